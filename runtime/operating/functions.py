"""The condensed equations, their total derivatives and the motion of all coordinates at one state, as one Function."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.operating.mode_solver import State, axes_turning, in_moving_axes
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, along_rotations

POINT_CLOSURE_ITERATIONS = 4
POINT_CLOSURE_TOLERANCE = (
    1e-9  # rad or m: a larger error before the last Newton step means that the loops did not close
)
ALREADY_CLOSED = 2  # Newton steps from a closed state, through which derivatives are exact to second order


@dataclass(frozen=True)
class PointValues:
    """At a state: M_hat, Q_hat, J_q = d(Q_hat - M_hat a)/dq_i, J_v = dQ_hat/dq_i_dot (n_i x n_i) of Eq. (38), all
    coordinates q and rates q_dot (n), S = dq/dq_i (n x n_i), the loop unknowns, how far the loops were open, and
    Q_t = d(Q_hat - M_hat a)/dt at fixed q_i and q_i_dot (n_i). turns: positions in q_i of independent turns, and
    turn_rates their angular velocities.
    """

    M: np.ndarray
    Q: np.ndarray
    J_q: np.ndarray
    J_v: np.ndarray
    q: np.ndarray
    q_dot: np.ndarray
    S: np.ndarray
    loop: np.ndarray
    open_by: float
    Q_t: np.ndarray
    turns: np.ndarray = field(default_factory=lambda: np.zeros(0, dtype=int))
    turn_rates: np.ndarray = field(default_factory=lambda: np.zeros(0))

    @property
    def places(self) -> np.ndarray:
        """q, followed by the independent turns, which count from here: the rows that `row_names` names."""
        return np.concatenate([self.q, np.zeros(len(self.turns))])

    @property
    def speeds(self) -> np.ndarray:
        """q_dot and angular velocities of these rows."""
        return np.concatenate([self.q_dot, self.turn_rates])

    @property
    def directions(self) -> np.ndarray:
        """S of these rows."""
        return np.vstack([self.S, np.eye(self.S.shape[1])[self.turns]])

    @property
    def usable(self) -> bool:
        """Are all values finite and the loops closed?"""
        finite = all(np.isfinite(values).all() for values in (self.M, self.Q, self.J_q, self.J_v, self.q, self.S))
        return finite and self.open_by < POINT_CLOSURE_TOLERANCE


class PointFunctions:
    """Evaluates a model with constants c. Raises ModelError without Jacobians or freedoms.

    drives_move: do prescribed motions have their rates and accelerations, or are they held where they are at t?
    """

    def __init__(self, model: EmittedModel, c: np.ndarray, drives_move: bool = True) -> None:
        if not model.q_i:
            raise ModelError(
                f"every coordinate of model {model.name} is driven: it has no equilibrium and no modes of its own"
            )
        self.model, self.c = model, c
        self.drives_move = drives_move = drives_move or not has_drives(model)
        name = "operating_point" if drives_move else "operating_point_of_held_drives"
        self._function = model.derived(name, lambda: _built(model, drives_move))
        self._pull = model.derived("pull_of_holding_forces", lambda: _pull(model)) if model.q_d else None

    @property
    def depend_on_time(self) -> bool:
        """Do forces depend on t, if only by a condition?"""
        return self._function.jac_sparsity(1, 0).nnz() > 0

    def __call__(self, state: State, a: np.ndarray | None = None) -> PointValues:
        """Everything at a state; a (n_i): the accelerations about which J_q is taken, zero by default."""
        a = np.zeros(len(self.model.q_i)) if a is None else a
        found = self._function(state.t, state.q_i, state.q_i_dot, a, state.loop, self.c)
        M, Q, J_q, J_v, q, q_dot, S, loop, open_by, Q_t = (np.asarray(value) for value in found)
        Q, q, q_dot, loop, Q_t = (vector.ravel() for vector in (Q, q, q_dot, loop, Q_t))
        turns = independent_turns(self.model)
        rates = state.q_i_dot[turns]
        return PointValues(M, Q, J_q, J_v, q, q_dot, S, loop, float(open_by.max()), Q_t, turns, rates)

    def in_moving_axes(self, at: PointValues, state: State, a: np.ndarray) -> PointValues:
        """Values with J_q and J_v for turns dphi in axes that move with the state: d omega = dphi' + omega x dphi.

        a: q_i_ddot (n_i) of the state.
        """
        turning = axes_turning(self.model, self.c, state.t, state.q_i, state.q_i_dot, a, state.loop)
        J_q, J_v = in_moving_axes(turning, at.M, at.J_q, at.J_v)
        return replace(at, J_q=J_q, J_v=J_v)

    def pull_slope(self, state: State, force: np.ndarray) -> np.ndarray:
        """d(S^T force)/dq_i (n_i x n_i) for constant generalised forces on all coordinates (n)."""
        if self._pull is None:
            return np.zeros((len(self.model.q_i),) * 2)
        return np.asarray(self._pull(state.t, state.q_i, state.loop, force, self.c))


def independent_turns(model: EmittedModel) -> np.ndarray:
    """Positions in q_i of turns."""
    return np.array([k for k in model.places.turns.ravel() if k < len(model.q_i)], dtype=int)


def row_names(model: EmittedModel) -> list[str]:
    """Names of what can be held or has a rate: coordinates, and independent turns."""
    return [*model.coordinates, *(model.q_i[k] for k in independent_turns(model))]


def all_coordinates(model: EmittedModel, q_i: ca.SX, q_d: ca.SX) -> ca.SX:
    """q in the order of model.coordinates."""
    return ca.densify(joined(model, q_i, q_d))


def tangents(model: EmittedModel, equations: StageEquations, motion: ClosedConfiguration) -> ca.SX:
    """S = dq/dq_i (n x n_i), along rotations for turns: the rates are affine in q_i_dot."""
    v = ca.SX.sym("v", len(model.q_i))
    rates = equations.rates(motion, v)
    # of a function that calls a table the Jacobian names v, though it does not depend on it
    B = ca.substitute(ca.jacobian(rates, v), v, ca.SX.zeros(v.shape)) if model.q_d else ca.SX(0, len(model.q_i))
    unit = ca.SX.eye(len(model.q_i))
    return ca.densify(ca.horzcat(*(joined(model, unit[:, k], B[:, k]) for k in range(len(model.q_i)))))


def has_drives(model: EmittedModel) -> bool:
    """Does a joint prescribe a motion?"""
    return bool(model.q_d) and "t" in model.kernel("closure").name_in()


def dependent_rates(equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, drives_move: bool) -> ca.SX:
    """q_d_dot (Eq. 36), with the rates of prescribed motions or without."""
    rates = equations.rates(motion, v)
    return rates if drives_move else rates - equations.rates(motion, ca.SX.zeros(len(equations.model.q_i)))


def rates_and_forces(
    equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, drives_move: bool
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """(q_d_dot, M_hat, Q_hat) at a state; prescribed motions that do not move have neither rates nor inertia."""
    q_d_dot = dependent_rates(equations, motion, v, drives_move)
    if drives_move:
        return q_d_dot, *equations.condensed(motion, v)
    at = {"q_i": motion.q_i, "q_d": motion.q_d, "t": motion.t, "q_i_dot": v, "q_d_dot": q_d_dot}
    found = equations.call("condensed", **at)
    return q_d_dot, found["M_hat"], found["Q_hat"] + driven_inertia(equations, motion)


def driven_inertia(equations: StageEquations, motion: ClosedConfiguration) -> ca.SX:
    """S^T M q'' (n_i,) of the q'' that the accelerations of prescribed motions bring about at rest (Eq. 35).

    M q'' is dT/dq' at q' = q'', since T is quadratic in the rates.
    """
    model = equations.model
    still = ca.SX.zeros(len(model.q_i))
    resting = {"q_i_dot": still, "q_d_dot": ca.SX.zeros(len(model.q_d)), "q_i_ddot": still}
    found = equations.call("accelerations", q_i=motion.q_i, q_d=motion.q_d, t=motion.t, **resting)
    rates, place = ca.SX.sym("rates", len(model.coordinates)), all_coordinates(model, motion.q_i, motion.q_d)
    T = equations.call("energy", q=place, q_dot=rates, t=motion.t)["kinetic"]
    accelerations = all_coordinates(model, still, found["q_d_ddot"])
    momenta = ca.substitute(ca.gradient(T, rates), rates, accelerations)
    return ca.mtimes(tangents(model, equations, motion).T, momenta)


def _built(model: EmittedModel, drives_move: bool) -> ca.Function:
    """(t, q_i, q_i_dot, a, loop unknowns, c) -> the entries of PointValues."""
    n = len(model.q_i)
    t, q, v, a = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, c)
    motion = equations.close(q, loop, t, POINT_CLOSURE_ITERATIONS)
    q_d_dot, M, Q = rates_and_forces(equations, motion, v, drives_move)
    arguments = {"q_i": q, "q_d": motion.q_d, "q_i_dot": v, "q_d_dot": q_d_dot, "q_i_ddot": a, "t": t}
    found = equations.call("residual_jacobian", **arguments)
    J_q, Q_t = found["J_q"], equations.force_rate(motion, v, a)
    if not drives_move:
        inertia = driven_inertia(equations, equations.close(q, loop, t, ALREADY_CLOSED))
        J_q += along_rotations(equations, motion, ca.jacobian(inertia, q))
        Q_t = _rate_of_loads(equations, motion, v)
    outputs = [M, Q, J_q, found["J_v"], all_coordinates(model, q, motion.q_d), all_coordinates(model, v, q_d_dot)]
    outputs += [tangents(model, equations, motion), equations.loop_part(motion.q_d), motion.C_loop, Q_t]
    return ca.Function("operating_point", [t, q, v, a, loop, c], [ca.densify(value) for value in outputs])


def _rate_of_loads(equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """dQ_hat/dt at a place where prescribed motions are held."""
    t = ca.SX.sym("time")
    Q = rates_and_forces(equations, replace(motion, t=t), v, False)[2]
    return ca.substitute(ca.jacobian(Q, t), t, motion.t)


def _pull(model: EmittedModel) -> ca.Function:
    """(t, q_i, loop unknowns, force, c) -> d(S^T force)/dq_i."""
    t, q = ca.SX.sym("t"), ca.SX.sym("q", len(model.q_i))
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    force = ca.SX.sym("force", len(model.coordinates))
    equations = StageEquations(model, c)
    motion = equations.close(q, loop, t, ALREADY_CLOSED)
    pull = ca.mtimes(tangents(model, equations, motion).T, force)
    slope = along_rotations(equations, motion, ca.jacobian(pull, q))
    return ca.Function("pull", [t, q, loop, force, c], [ca.densify(slope)])
