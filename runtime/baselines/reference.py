"""A tight reference path: DOP853 on the emitted functions, for judging the step schemes by."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.baselines.condensed_ode import TO_ROUNDING
from runtime.baselines.scipy_methods import scipy_solution
from runtime.contract.model import Model
from runtime.results.solution import Solution


def reference_solution(
    model: Model,
    *,
    t_end: float,
    times: np.ndarray | None = None,
    rtol: float = 1e-11,
    atol: float = 1e-13,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> Solution:
    """Integrate the condensed equations from 0 to t_end with DOP853 at the given tolerances, loops closed to rounding.

    times: where to report (the end only by default). Raises ModelError or InitialStateError for bad arguments.
    """
    return scipy_solution(
        model,
        "DOP853",
        t_end=t_end,
        times=times,
        rtol=rtol,
        atol=atol,
        parameters=parameters,
        initial=initial,
        start=start,
        compiled=False,
        closure_iterations=TO_ROUNDING,
    )
