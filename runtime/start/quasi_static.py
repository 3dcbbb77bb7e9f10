"""Start in quasi-static elastic equilibrium: elastic coordinates follow the loads without vibrating.

At given rigid coordinates and rates the elastic coordinates q_e are those for which q_e_ddot = 0 satisfies the
equations of motion; their rates are those of this equilibrium along the rigid motion. What vibration is left is of
the order of (rigid rate / elastic frequency)^2.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.model import Model
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.stage_equations import StageEquations

MAX_ITERATIONS = 30
TOLERANCE = 1e-12  # of the largest correction, times the largest elastic coordinate
CLOSURE_ITERATIONS = 4
PASSES = 3  # equilibrium and rates depend on each other weakly
SMALL_MOTION = 1e-4  # rad or m that rigid coordinates move between the two equilibria whose difference is the rate


def quasi_static_state(model: Model, c: np.ndarray, t: float, state: ConsistentState) -> ConsistentState:
    """The state with elastic coordinates in equilibrium. Raises InitialStateError where there is none in reach."""
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    if not elastic:
        return state
    solver = _Equilibrium(model, elastic, c)
    columns = model.independent_columns
    q_i, v = state.q[columns].copy(), state.q_dot[columns].copy()
    loop = state.q[model.loop_columns]
    rigid = [k for k in range(len(q_i)) if k not in elastic]
    speed = np.abs(np.delete(state.q_dot, [model.coordinates.index(name) for name in model.elastic])).max(initial=0.0)
    for _ in range(PASSES):
        q_i = solver.solve(t, q_i, v, loop)
        if speed > 0:
            step = SMALL_MOTION / speed
            moved = []
            for sign in (1, -1):
                at = q_i.copy()
                at[rigid] += sign * step * v[rigid]
                moved.append(solver.solve(t + sign * step, at, v, loop)[elastic])
            v[elastic] = (moved[0] - moved[1]) / (2 * step)
    q, q_dot = solver.closed(t, q_i, v, loop)
    changed = {
        name: (float(state.q[k]), float(q[k]))
        for k, name in enumerate(model.coordinates)
        if name in model.elastic and q[k] != state.q[k]
    }
    return ConsistentState(q, q_dot, {**state.changed, **changed})


class _Equilibrium:
    def __init__(self, model: Model, elastic: list[int], c: np.ndarray) -> None:
        self.model, self.elastic, self.c = model, elastic, c
        n = len(model.q_i)
        rigid = [k for k in range(n) if k not in elastic]
        t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
        loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        equations = StageEquations(model, constants)
        motion = equations.close(q, loop, t, CLOSURE_ITERATIONS)
        M_hat, Q_hat = equations.condensed(motion, v)
        residual = Q_hat[elastic]
        if rigid:
            residual = residual - ca.mtimes(M_hat[elastic, rigid], solve_symmetric(M_hat[rigid, rigid], Q_hat[rigid]))
        inputs = [t, q, v, loop, constants]
        self._residual = ca.Function("residual", inputs, [residual, ca.jacobian(residual, q)[:, elastic]])
        self._closed = ca.Function("closed", inputs, [motion.q_d, equations.rates(motion, v)])

    def solve(self, t: float, q_i: np.ndarray, v: np.ndarray, loop: np.ndarray) -> np.ndarray:
        """q_i with its elastic entries in equilibrium, by Newton."""
        q = q_i.copy()
        for _ in range(MAX_ITERATIONS):
            residual, slope = self._residual(t, q, v, loop, self.c)
            residual, slope = np.asarray(residual).ravel(), np.asarray(slope)
            finite = np.isfinite(residual).all() and np.isfinite(slope).all()
            if not finite or np.linalg.matrix_rank(slope) < len(slope):
                break
            step = np.linalg.solve(slope, residual)
            q[self.elastic] -= step
            if np.abs(step).max() <= TOLERANCE * max(1e-6, float(np.abs(q[self.elastic]).max())):
                return q
        raise InitialStateError(
            "there is no quasi-static elastic equilibrium in reach of the initial state "
            "(a soft or buckled body?): start = given, with elastic coordinates of your own"
        )

    def closed(self, t: float, q_i: np.ndarray, v: np.ndarray, loop: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All coordinates and rates."""
        q_d, q_d_dot = self._closed(t, q_i, v, loop, self.c)
        q, q_dot = np.zeros(len(self.model.coordinates)), np.zeros(len(self.model.coordinates))
        q[self.model.independent_columns], q_dot[self.model.independent_columns] = q_i, v
        q[self.model.dependent_columns] = np.asarray(q_d).ravel()
        q_dot[self.model.dependent_columns] = np.asarray(q_d_dot).ravel()
        return q, q_dot
