"""States along a trajectory, at which stability and frequencies are looked at."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.baselines.scipy_methods import reference_solution
from runtime.contract.model import Model
from runtime.operating.mode_solver import State, state_at

RTOL, ATOL = 1e-7, 1e-10


def states_along(
    model: Model,
    *,
    t_end: float,
    count: int = 9,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> list[State]:
    """`count` states from 0 to t_end, evenly spaced but for a shift that keeps them off multiples of the motion."""
    places = (np.arange(count) + 0.5 * np.sin(np.arange(count)) ** 2) / max(1, count - 0.5)
    solution = reference_solution(
        model,
        t_end=t_end,
        times=places * t_end,
        rtol=RTOL,
        atol=ATOL,
        parameters=parameters,
        initial=initial,
        start=start,
    )
    return [state_at(solution, k) for k in range(len(solution.t))]
