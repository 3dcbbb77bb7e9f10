"""Which steps of a grid are broken: the times at which something jumps, within steps and at their ends."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from math import floor

import numpy as np

from runtime.schemes.switching.times import SwitchTime

ON_THE_GRID = 1e-9  # of a step: a jump that near to the end of a step is there


class Breaks:
    """Of steps of dt [s] from t0 on. inside: jumps by the step that they are in; on: at the start of which step."""

    def __init__(self, t0: float, dt: float, switches: Sequence[SwitchTime]) -> None:
        self.t0, self.dt = t0, dt
        self.inside: dict[int, list[SwitchTime]] = {}
        self.on: dict[int, list[SwitchTime]] = {}
        for one in switches:
            k = floor((one.time - t0) / dt)
            near = [step for step in (k, k + 1) if abs(one.time - self.time(step)) <= ON_THE_GRID * dt]
            where, step = (self.on, near[0]) if near else (self.inside, k)
            where.setdefault(step, []).append(one)
        self.broken = sorted({*self.inside, *(k - 1 for k in self.on if k > 0)})

    def time(self, step: int) -> float:
        """Of the grid [s]."""
        return self.t0 + step * self.dt

    def clock(self, step: int) -> float:
        """The time from which a step starts [s]: after a jump that is there."""
        return max(self.time(step), *(one.after for one in self.on.get(step, ())), -np.inf)

    def ends(self, step: int) -> list[tuple[float, float | None]]:
        """Clocks [s] at which the parts of a step end, and from which the next ones start (None: nothing jumps)."""
        inside = [(one.before, one.after) for one in self.inside.get(step, ())]
        if step + 1 not in self.on:
            return [*inside, (self.time(step + 1), None)]
        there = self.on[step + 1]
        return [*inside, (min(one.before for one in there), max(one.after for one in there))]

    def next_broken(self, step: int) -> int | None:
        """The first broken step from this one on."""
        k = bisect_left(self.broken, step)
        return self.broken[k] if k < len(self.broken) else None
