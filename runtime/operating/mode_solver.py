"""The condensed equations linearised at a state, by whose frequencies and decays steps are limited.

M_hat w'' = J_q w + J_v w' with the emitted Jacobians; J_q includes d(M_hat a)/dq_i. Step limits follow from these, not
from a body's clamped modes.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import dense_eigenvalues, one_thread
from runtime.contract.coordinates import independent, loop_part
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import tilde
from runtime.results.samples import Samples
from runtime.schemes.stage_equations import StageEquations, is_long_tree, turning_and_rate

# ---- Small turns in axes that move with their bodies: d omega = dphi' + omega x dphi, so q_i' changes by W
# dq_i.


def axes_turning(
    model: EmittedModel, c: np.ndarray, t: float, q_i: np.ndarray, v: np.ndarray, a: np.ndarray, loop: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(W, W') (n_i x n_i) at a state, where q_i_ddot = a."""
    if not model.places.all_independent:
        W, rate = model.derived("axes_turning", lambda: _built(model))(t, q_i, v, a, loop, c)
        return np.asarray(W), np.asarray(rate)
    found = np.zeros((2, len(q_i), len(q_i)))
    for own in model.places.turns:
        found[0][np.ix_(own, own)], found[1][np.ix_(own, own)] = tilde(v[own]), tilde(a[own])
    return found[0], found[1]


def in_moving_axes(
    turning: tuple[np.ndarray, np.ndarray], M: np.ndarray, J_q: np.ndarray, J_v: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """J_q and J_v (n_i x n_i) in such axes, of M a'' = J_q da + J_v dv; turning: W and W'."""
    W, rate = turning
    return J_q + J_v @ W - M @ rate, J_v - M @ W


def _built(model: EmittedModel) -> ca.Function:
    """(t, q_i, q_i_dot, q_i_ddot, loop unknowns, c) -> W, W'."""
    n = len(model.q_i)
    t, q, v, a = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, c)
    found = turning_and_rate(equations, equations.close(q, loop, t, MODE_CLOSURE_ITERATIONS), v, a)
    return ca.Function("axes_turning", [t, q, v, a, loop, c], [ca.densify(one) for one in found])


MODE_CLOSURE_ITERATIONS = 3


@dataclass(frozen=True)
class State:
    """Time [s], independent coordinates, rates, and loop unknowns."""

    t: float
    q_i: np.ndarray
    q_i_dot: np.ndarray
    loop: np.ndarray


class ModeSolver:
    """Linear systems of a model with constants c. Raises ModelError if it was generated without its Jacobians."""

    def __init__(self, model: EmittedModel, c: np.ndarray) -> None:
        self.model, self.n, self.c = model, len(model.q_i), c

    @staticmethod
    def possible(model: EmittedModel) -> bool:
        """Was the model generated with the Jacobians that modes need?"""
        return model.has("residual_jacobian")

    @staticmethod
    def _built(model: EmittedModel) -> ca.Function:
        """(t, q_i, q_i_dot, loop unknowns, c) -> M_hat, J_q, J_v, q_i_ddot."""
        n = len(model.q_i)
        t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
        loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        equations = StageEquations(model, constants)
        motion = equations.close(q, loop, t, MODE_CLOSURE_ITERATIONS)
        found = equations.along_rotations(motion, v)
        matrices = [ca.densify(matrix) for matrix in (found.M_hat, found.J_q, found.J_v, found.a)]
        return ca.Function("modes", [t, q, v, loop, constants], matrices)

    def matrices(self, state: State, moving: bool = True) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """M_hat, J_q, J_v; moving: for turns in axes that move with their bodies, else for held ones."""
        function = self.model.derived("modes", lambda: self._built(self.model))
        found = function(state.t, state.q_i, state.q_i_dot, state.loop, self.c)
        M, J_q, J_v, a = (np.asarray(value) for value in found)
        return M, *(in_moving_axes(self._turning(state, a.ravel()), M, J_q, J_v) if moving else (J_q, J_v))

    def _turning(self, state: State, a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return axes_turning(self.model, self.c, state.t, state.q_i, state.q_i_dot, a, state.loop)

    def slopes(self, state: State, moving: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """A_q and A_v of w'' = A_q w + A_v w'; of a long tree without M_hat, then not finite where that is singular.

        What limits a step is in held axes, see `matrices`. Raises LinAlgError if M_hat is singular.
        """
        with one_thread(self.n):
            return self._slopes(state, moving)

    def eigenvalues(self, state: State) -> np.ndarray:
        """(2 n,) of the equations linearised at a state, in axes that move with their bodies [1/s]."""
        A = np.zeros((2 * self.n, 2 * self.n))
        A[: self.n, self.n :] = np.eye(self.n)
        A[self.n :, : self.n], A[self.n :, self.n :] = self.slopes(state, moving=True)
        return dense_eigenvalues(A)

    def _slopes(self, state: State, moving: bool) -> tuple[np.ndarray, np.ndarray]:
        if is_long_tree(self.model):
            function = self.model.derived("slopes", lambda: self._along(self.model))
            found = function(state.t, state.q_i, state.q_i_dot, state.loop, self.c, np.eye(self.n))
            A_q, A_v, a = (np.asarray(value) for value in found)
            unit = np.eye(self.n)
            return in_moving_axes(self._turning(state, a[:, 0]), unit, A_q, A_v) if moving else (A_q, A_v)
        M, J_q, J_v = self.matrices(state, moving)
        return np.linalg.solve(M, J_q), np.linalg.solve(M, J_v)

    @staticmethod
    def _along(model: EmittedModel) -> ca.Function:
        """(t, q_i, q_i_dot, loop unknowns, c, direction) -> derivatives of q_i_ddot by q_i and by q_i_dot along it,
        and q_i_ddot; of turns along rotations.
        """
        n = len(model.q_i)
        t, q, v, along = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("along", n)
        loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        equations = StageEquations(model, constants)
        motion = equations.close(q, loop, t, MODE_CLOSURE_ITERATIONS)
        a, rates = equations.accelerations(motion, v), equations.turning(motion, along)
        slopes = [*(ca.densify(ca.jtimes(a, by, to)) for by, to in ((q, rates), (v, along))), ca.densify(a)]
        return ca.Function("slopes", [t, q, v, loop, constants, along], slopes)


def state_at(solution: Samples, k: int) -> State:
    """Sample k of a solution."""
    model = solution.model
    q, q_dot = solution.q[k], solution.q_dot[k]
    return State(float(solution.t[k]), *independent(model, q, q_dot), loop_part(model, q))


def parameters_at(solution: Samples, k: int) -> np.ndarray:
    """p (n_p,) at sample k: what the inputs were then is in it."""
    model, p = solution.model, np.array(solution.parameters)
    if model.signals.size:
        u = {name: float(solution.measures[k, position]) for position, name in enumerate(model.measures)}
        p[-model.signals.size :] = model.signals.held_as(u, float(solution.t[k]))
    return p
