"""How the start of a run moves with parameters and given initial values.

Where only q_i and their rates are given they stay what they are, and the scheme closes the loops: what that means for
q_d is in its start. Where other coordinates are given the assembly solves C = 0 and C_q q_dot + C_t = 0 for those that
are left open, and their slopes follow by the implicit-function theorem:

    C_q dq + C_c dc = 0,    C_q dq_dot + d(C_q q_dot + C_t)/dq dq + d(C_q q_dot + C_t)/dc dc = 0
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import independent_slopes
from runtime.contract.model import Model
from runtime.gradients.variables import Variables

RANK = 1e-9  # of the largest singular value: less means that the assembly leaves a coordinate open
OPEN = 1e-8  # of the largest slope: more means that what was given had to move


def start_slopes(
    model: Model, p: np.ndarray, t0: float, state: ConsistentState, given: Mapping[str, float], by: Variables
) -> np.ndarray:
    """d(p, q_i, q_i_dot, loop unknowns)/d(variables), (n_x, n); given: all initial values by name, the variables' too.

    Raises InitialStateError where the assembly leaves open or moves what would have to be known.
    """
    n, n_p = len(model.coordinates), len(p)
    dp, dq, dv = np.zeros((n_p, len(by.names))), np.zeros((n, len(by.names))), np.zeros((n, len(by.names)))
    for k, entry, _ in by.parameters:
        dp[entry, k] = 1.0
    for k, column, is_rate in by.initial:
        (dv if is_rate else dq)[column, k] = 1.0
    free_q, free_v = _open(model, given, rates=False), _open(model, given, rates=True)
    _require_kept(model, given, free_q, model.initial_q, state.q, "")
    _require_kept(model, given, free_v, model.initial_q_dot, state.q_dot, "_dot")
    dependent = set(map(int, model.dependent_columns))
    if model.constraints and (set(free_q) != dependent or set(free_v) != dependent):
        _assembled(model, p, t0, state, dp, dq, dv, free_q, free_v)
    return np.concatenate([dp, *independent_slopes(model, state.q, state.q_dot, dq, dv)])


def _open(model: Model, given: Mapping[str, float], rates: bool) -> list[int]:
    """Coordinates (or rates) that the assembly finds, in the way of runtime.operating.given_state."""
    end = "_dot" if rates else ""
    named = {name for name in model.coordinates if name + end in given}
    kept = {name for name in model.q_i if named <= set(model.q_i) or name in model.elastic}
    return [k for k, name in enumerate(model.coordinates) if name not in named | kept]


def _require_kept(
    model: Model, given: Mapping[str, float], free: list[int], wanted: np.ndarray, found: np.ndarray, end: str
) -> None:
    """What the assembly was to keep, it kept. Raises InitialStateError."""
    for k, name in enumerate(model.coordinates):
        if k in free or name + end in given:
            continue
        if abs(found[k] - wanted[k]) > OPEN * max(1.0, abs(wanted[k])):
            raise InitialStateError(
                f"the start has no derivative: the assembly moves {name}{end} from {wanted[k]:.9g} to {found[k]:.9g}; "
                f"give it by initial = {{{name + end!r}: ...}}"
            )


def _assembled(
    model: Model,
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


def _solved(model: Model, C_q: np.ndarray, free: list[int], side: np.ndarray) -> np.ndarray:
    matrix = C_q[:, free]
    values = np.linalg.svd(matrix, compute_uv=False) if free else np.ones(1)
    if len(values) < len(free) or values[-1] < RANK * values[0]:
        names = ", ".join(model.coordinates[k] for k in free)
        raise InitialStateError(
            f"the start has no derivative: the assembly leaves {names} open; give as many of them as it is free"
        )
    found = np.linalg.lstsq(matrix, side, rcond=None)[0]
    if np.abs(matrix @ found - side).max(initial=0.0) > OPEN * max(1.0, np.abs(side).max(initial=0.0)):
        raise InitialStateError("the start has no derivative: given values do not fit together when parameters change")
    return np.asarray(found)


def _slopes(model: Model) -> ca.Function:
    """(q, q_dot, t, p) -> C_q, C_p, and the slopes of C_q q_dot + C_t by q and p."""
    n = len(model.coordinates)
    q, v, t, p = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
    found = model.evaluate("constraints", q=q, q_dot=v, t=t, c=model.kernel("constants")(p))
    rate = ca.mtimes(found["C_q"], v) + found["C_t"]
    outputs = [found["C_q"], ca.jacobian(found["C"], p), ca.jacobian(rate, q), ca.jacobian(rate, p)]
    return ca.Function("assembly_slopes", [q, v, t, p], [ca.densify(value) for value in outputs])
