"""What happens at which step of a differentiated run: outputs are taken, and inputs are set to other numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Hold:
    """A number that an input takes before a step and keeps: row of z, value, its place among what is differentiated by.

    place: -1 for a number by which is not differentiated.
    """

    step: int
    row: int
    value: float
    place: int = -1

    def number(self, x: np.ndarray) -> float:
        """The value at x (n,)."""
        return float(x[self.place]) if self.place >= 0 else self.value


@dataclass(frozen=True)
class Stop:
    """After so many major steps: outputs are taken as a sample (-1: none), then inputs change."""

    steps: int
    sample: int
    holds: tuple[Hold, ...] = ()


@dataclass(frozen=True)
class Course:
    """Stops, the first before any step; times [steps] of the samples (N,)."""

    stops: tuple[Stop, ...]
    times: tuple[int, ...]

    @property
    def steps(self) -> int:
        """All of them."""
        return sum(stop.steps for stop in self.stops)


def course(steps: int, every: int, holds: Iterable[Hold]) -> Course:
    """Samples at every so many steps and at the last one; inputs change before that are within the run."""
    times = [*range(0, steps, every), steps]
    changes: dict[int, list[Hold]] = {}
    for hold in holds:
        if 0 < hold.step < steps:
            changes.setdefault(hold.step, []).append(hold)
    sample = {time: k for k, time in enumerate(times)}
    stops, before = [], 0
    for time in sorted({*times, *changes}):
        stops.append(Stop(time - before, sample.get(time, -1), tuple(changes.get(time, ()))))
        before = time
    return Course(tuple(stops), tuple(times))
