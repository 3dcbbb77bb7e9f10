"""The fewest steps with which a method stays below a tolerance."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from runtime.studies.work_precision.prepared_method import PreparedMethod, Spec, Trial

FEWEST = 8
REFINEMENTS = 4  # halvings of the interval (in logarithm) between too few steps and enough
HOPELESSLY_SLOW = 2.0  # times the best so far
CHEAP = 0.02  # s: a run this short is never given up for its length


@dataclass
class Search:
    """Trials of a method, and the one that meets the tolerance with the least time (None: none did)."""

    spec: Spec
    trials: list[Trial] = field(default_factory=list)
    best: Trial | None = None

    @property
    def label(self) -> str:
        """What reports call the method."""
        return self.spec.label

    @property
    def seconds(self) -> float:
        """CPU time of the best trial [s]."""
        return self.best.seconds if self.best else np.inf


def search_steps(
    prepared: PreparedMethod, tolerance: float, fewest: int = FEWEST, most: int = 10**8, seconds_to_beat: float = np.inf
) -> Search:
    """Double the steps until the error is below the tolerance, then close in on the fewest that are enough.

    Given up where a run takes far longer than `seconds_to_beat`.
    """
    found = Search(prepared.spec)
    low, steps = 0, max(1, fewest)
    while steps <= most:
        trial = prepared.run(steps)
        found.trials.append(trial)
        if trial.error <= tolerance:
            found.best = trial
            break
        if trial.seconds > max(CHEAP, HOPELESSLY_SLOW * seconds_to_beat):
            return found
        low, steps = steps, max(steps + 1, _next(trial, tolerance, prepared.scheme.order))
    if found.best is None:
        return found
    high = found.best.steps
    for _ in range(REFINEMENTS):
        middle = round((low * high) ** 0.5) if low else high // 2
        if middle in (low, high) or middle < 1:
            break
        trial = prepared.run(middle)
        found.trials.append(trial)
        if trial.error <= tolerance:
            high, found.best = middle, trial
        else:
            low = middle
    return found


def _next(trial: Trial, tolerance: float, order: int) -> int:
    """Twice the steps, or less where the order says that less is enough."""
    if trial.failure:
        return 2 * trial.steps
    factor = min(2.0, 1.1 * (trial.error / tolerance) ** (1 / order))
    return int(np.ceil(trial.steps * max(1.15, factor)))
