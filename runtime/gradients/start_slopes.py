"""How the start of a run moves with parameters and given initial values.

Where only q_i and their rates are given they stay what they are, and the scheme closes the loops: what that means
for q_d is in its start. Where other coordinates are given the assembly solves C = 0 and C_q q_dot + C_t = 0 for those
that are left open, and their slopes follow by the implicit-function theorem:

    C_q dq + C_c dc = 0,    C_q dq_dot + d(C_q q_dot + C_t)/dq dq + d(C_q q_dot + C_t)/dc dc = 0
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import independent_slopes, parameter_columns
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angular_velocity, chart_rates, exponential, parameter_rates, product
from runtime.gradients.variables import Variables, independent_turns

Given = Mapping[str, float]


RELATIVE_RANK = 1e-9  # of the largest singular value: less means that the assembly leaves a coordinate open
MOVED_GIVEN_SLOPE = 1e-8  # of the largest slope: more means that what was given had to move


def start_slopes(
    model: EmittedModel,
    p: np.ndarray,
    t0: float,
    state: ConsistentState,
    given: Mapping[str, float],
    by: Variables,
    x: np.ndarray,
) -> np.ndarray:
    """d(p, q_i, q_i_dot, loop unknowns)/d(variables), (n_x, n); given: all initial values by name, the variables' too.

    x (n,): the variables. Raises InitialStateError where the assembly leaves open or moves what would have to be known.
    """
    n, n_p = len(model.coordinates), len(p)
    dp, dq, dv = np.zeros((n_p, len(by.names))), np.zeros((n, len(by.names))), np.zeros((n, len(by.names)))
    for k, entry, _ in by.parameters:
        dp[entry, k] = 1.0
    for k, column, is_rate in by.initial:
        (dv if is_rate else dq)[column, k] = 1.0
    _turn_slopes(model, state, by, x, dq, dv)
    free_q, free_v = _open(model, given, rates=False), _open(model, given, rates=True)
    _require_kept(model, given, free_q, model.initial_q, state.q, "")
    _require_kept(model, given, free_v, model.initial_q_dot, state.q_dot, "_dot")
    dependent = set(map(int, model.dependent_columns)) - set(_independent_parameters(model))
    if model.constraints and (set(free_q) != dependent or set(free_v) != dependent):
        _assembled(model, p, t0, state, dp, dq, dv, free_q, free_v)
    return np.concatenate([dp, *independent_slopes(model, state.q, state.q_dot, dq, dv)])


def _open(model: EmittedModel, given: Mapping[str, float], rates: bool) -> list[int]:
    """Coordinates (or rates) that the assembly finds, in the way of runtime.operating.given_state."""
    end = "_dot" if rates else ""
    named = {name for name in model.coordinates if name + end in given}
    own = {*model.q_i, *(model.coordinates[k] for k in _independent_parameters(model))}
    kept = {name for name in own if named <= own or name in model.elastic}
    return [k for k, name in enumerate(model.coordinates) if name not in named | kept]


def _independent_parameters(model: EmittedModel) -> list[int]:
    """Columns of q of the Euler parameters of orientations that are independent."""
    return [int(column) for k in independent_turns(model) for column in model.places.parameters[k]]


def turned_start(model: EmittedModel, given: Given, by: Variables, x: np.ndarray) -> dict[str, float]:
    """Initial values by name, with the Euler parameters and their rates of orientations that x (n,) turns.

    Raises InitialStateError for an orientation that is given by Euler angles.
    """
    found = dict(given)
    angles_of = {one.name: one.angles for one in model.description.bodies}
    for body in {one[1]: None for one in by.turns}:
        columns = parameter_columns(model)[body]
        names, axes = [model.coordinates[k] for k in columns], [f"{body}.omega_{axis}" for axis in "xyz"]
        angles = [name for name in angles_of.get(body, ()) if name in found]
        if angles:
            raise InitialStateError(
                f"the start is turned further from {angles[0]}: give the orientation of {body} by its Euler parameters"
            )
        e = np.array([found.get(name, value) for name, value in zip(names, model.initial_q[columns], strict=True)])
        e_dot = [found.pop(f"{name}_dot", v) for name, v in zip(names, model.initial_q_dot[columns], strict=True)]
        omega = angular_velocity(e, np.array(e_dot))
        omega = np.array([found.pop(name, value) for name, value in zip(axes, omega, strict=True)])
        for k, owner, axis, is_rate in by.turns:
            if owner == body and is_rate:
                omega[axis] = x[k]
        e = product(e, exponential(_rotation(by, body, x)))
        found |= dict(zip(names, e.tolist(), strict=True))
        found |= {f"{name}_dot": float(v) for name, v in zip(names, parameter_rates(e, omega), strict=True)}
    return found


def _rotation(by: Variables, body: str, x: np.ndarray) -> np.ndarray:
    """(3,) the rotation vector among the variables that turns a body further."""
    found = np.zeros(3)
    for k, owner, axis, is_rate in by.turns:
        if owner == body and not is_rate:
            found[axis] = x[k]
    return found


def _turn_slopes(
    model: EmittedModel, state: ConsistentState, by: Variables, x: np.ndarray, dq: np.ndarray, dv: np.ndarray
) -> None:
    """Fill the rows of Euler parameters: e moves by e o (0, turn) / 2, and the angular velocity is kept."""
    for k, body, axis, is_rate in by.turns:
        e = parameter_columns(model)[body]
        omega = angular_velocity(state.q[e], state.q_dot[e])
        if is_rate:
            dv[e, k] = parameter_rates(state.q[e], np.eye(3)[axis])
        else:
            dq[e, k] = parameter_rates(state.q[e], np.linalg.inv(chart_rates(_rotation(by, body, x)))[:, axis])
            dv[e, k] = parameter_rates(dq[e, k], omega)


def _require_kept(
    model: EmittedModel, given: Mapping[str, float], free: list[int], wanted: np.ndarray, found: np.ndarray, end: str
) -> None:
    """What the assembly was to keep, it kept. Raises InitialStateError."""
    for k, name in enumerate(model.coordinates):
        if k in free or name + end in given:
            continue
        if abs(found[k] - wanted[k]) > MOVED_GIVEN_SLOPE * max(1.0, abs(wanted[k])):
            raise InitialStateError(
                f"the start has no derivative: the assembly moves {name}{end} from {wanted[k]:.9g} to {found[k]:.9g}; "
                f"give it by initial = {{{name + end!r}: ...}}"
            )


def _assembled(
    model: EmittedModel,
    p: np.ndarray,
    t0: float,
    state: ConsistentState,
    dp: np.ndarray,
    dq: np.ndarray,
    dv: np.ndarray,
    free_q: list[int],
    free_v: list[int],
) -> None:
    """Fill the rows of dq and dv (n, k) that are left open."""
    C_q, C_p, rate_q, rate_p = model.derived("assembly_slopes", lambda: _slopes(model))(state.q, state.q_dot, t0, p)
    C_q, C_p, rate_q, rate_p = (np.asarray(value) for value in (C_q, C_p, rate_q, rate_p))
    dq[free_q] = _solved(model, C_q, free_q, -(C_p @ dp + C_q @ dq))
    dv[free_v] = _solved(model, C_q, free_v, -(rate_p @ dp + rate_q @ dq + C_q @ dv))


def _solved(model: EmittedModel, C_q: np.ndarray, free: list[int], side: np.ndarray) -> np.ndarray:
    matrix = C_q[:, free]
    values = np.linalg.svd(matrix, compute_uv=False) if free else np.ones(1)
    if len(values) < len(free) or values[-1] < RELATIVE_RANK * values[0]:
        names = ", ".join(model.coordinates[k] for k in free)
        raise InitialStateError(
            f"the start has no derivative: the assembly leaves {names} open; give as many of them as it is free"
        )
    found = np.linalg.lstsq(matrix, side, rcond=None)[0]
    if np.abs(matrix @ found - side).max(initial=0.0) > MOVED_GIVEN_SLOPE * max(1.0, np.abs(side).max(initial=0.0)):
        raise InitialStateError("the start has no derivative: given values do not fit together when parameters change")
    return np.asarray(found)


def _slopes(model: EmittedModel) -> ca.Function:
    """(q, q_dot, t, p) -> C_q, C_p, and the slopes of C_q q_dot + C_t by q and p."""
    n = len(model.coordinates)
    q, v, t, p = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
    found = model.evaluate("constraints", q=q, q_dot=v, t=t, c=model.kernel("constants")(p))
    rate = ca.mtimes(found["C_q"], v) + found["C_t"]
    outputs = [found["C_q"], ca.jacobian(found["C"], p), ca.jacobian(rate, q), ca.jacobian(rate, p)]
    return ca.Function("assembly_slopes", [q, v, t, p], [ca.densify(value) for value in outputs])
