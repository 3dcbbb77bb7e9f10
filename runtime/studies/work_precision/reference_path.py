"""A reference path that can be asked at any time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde
from runtime.baselines.scipy_methods import counted
from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import NoResult
from runtime.contract.model import Model
from runtime.engine.functions import evaluator


class NoReference(NoResult):
    """The reference could not be computed."""


def reference_path(
    model: Model, c: np.ndarray, state: ConsistentState, t_end: float, rtol: float, atol: float
) -> Callable[[np.ndarray], np.ndarray]:
    """times (N,) -> q_i (N, n): DOP853 with its dense output. Raises NoReference, or NoResult for steps that shrink."""
    from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

    columns, n = model.independent_columns, len(model.q_i)
    loop = state.q[model.loop_columns]
    y0 = np.concatenate([state.q[columns], state.q_dot[columns], loop])
    slope = counted(evaluator(CondensedOde(model, 1).right_hand_side(), c), "the reference")
    with np.errstate(all="ignore"):  # a motion that leaves the range of numbers is told by the result
        result = solve_ivp(slope, (0.0, t_end), y0, method="DOP853", dense_output=True, rtol=rtol, atol=atol)
    if not result.success or not np.isfinite(result.y[:, -1]).all():
        raise NoReference(f"the reference stopped at t = {result.t[-1]:.6g} s: {result.message}")
    return lambda times: result.sol(np.clip(times, 0.0, t_end)).T[:, :n]
