"""A reference path that can be asked at any time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, integrated
from runtime.baselines.scipy_methods import counted, in_pieces
from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import NoResult
from runtime.contract.model import Model
from runtime.engine.rows import evaluator


class NoReference(NoResult):
    """The reference could not be computed."""


def reference_path(
    model: Model, c: np.ndarray, state: ConsistentState, t_end: float, rtol: float, atol: float
) -> Callable[[np.ndarray], np.ndarray]:
    """times (N,) -> what tells the motion (N, n; `followed`): DOP853 with its dense output.

    Raises NoReference, or NoResult for steps that shrink.
    """
    y0 = integrated(model, state.q, state.q_dot)
    at = [*model.places.plain, *range(len(y0) - model.places.parameters.size, len(y0))]
    slope = counted(evaluator(CondensedOde(model, 1).right_hand_side(), c), "the reference")
    with np.errstate(all="ignore"):  # a motion that leaves the range of numbers is told by the result
        settings = {"method": "DOP853", "dense_output": True, "rtol": rtol, "atol": atol}
        results = in_pieces(model, c, slope, y0, t_end, None, **settings)
    last = results[-1]
    if not last.success or not np.isfinite(last.y[:, -1]).all():
        raise NoReference(f"the reference stopped at t = {last.t[-1]:.6g} s: {last.message}")
    starts = np.array([one.t[0] for one in results[1:]])

    def path(times: np.ndarray) -> np.ndarray:
        asked = np.clip(times, 0.0, t_end)
        pieces, found = np.searchsorted(starts, asked, side="right"), np.zeros((len(asked), len(at)))
        for k in np.unique(pieces):
            found[pieces == k] = results[k].sol(asked[pieces == k]).T[:, at]
        return found

    return path
