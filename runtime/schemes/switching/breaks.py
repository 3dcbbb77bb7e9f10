"""Which steps of a grid are broken: the times at which something jumps, within steps and at their ends."""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from runtime.schemes.switching.times import SwitchTime

ON_THE_GRID = 1e-9  # of a step: a jump that near to the end of a step is there
LOST = 1e-11  # of a step: by so much a part that ends at a jump may be short, so that its clocks are on their sides


@dataclass(frozen=True)
class StepParts:
    """Of broken steps, in order: clocks at which they start and lengths (N,) [s]; counts (S,): how many each step has.

    before, after (N,): clocks of what jumps at the end of a part [s]; infinite where nothing does. clocks (S,): from
    where the step behind each broken one starts [s].
    """

    start: np.ndarray
    length: np.ndarray
    before: np.ndarray
    after: np.ndarray
    counts: np.ndarray
    clocks: np.ndarray

    def each(self) -> Iterator[tuple[float, float, float | None, float]]:
        """(start, length, before or None where nothing jumps at the end, after) of each [s]."""
        for start, length, before, after in zip(self.start, self.length, self.before, self.after, strict=True):
            yield float(start), float(length), float(before) if np.isfinite(before) else None, float(after)


def within(length: Any, m: Sequence[int]) -> Any:
    """The step [s] of a part so long [s]: its sub-steps, m of each group, add up by rounding, and end within it."""
    return length * (1 - 2 * np.finfo(float).eps * prod(m))


class Breaks:
    """Of steps of dt [s] from t0 on. inside: jumps by the step that they are in; on: at the start of which step.

    known: of how many steps all jumps are given.
    """

    def __init__(self, t0: float, dt: float, switches: Sequence[SwitchTime], known: int = sys.maxsize) -> None:
        self.t0, self.dt = t0, dt
        self.inside: dict[int, list[SwitchTime]] = {}
        self.on: dict[int, list[SwitchTime]] = {}
        times, before, after = (
            np.array([getattr(one, name) for one in switches], dtype=float) for name in ("time", "before", "after")
        )
        steps = np.floor((times - t0) / dt)
        near = [np.abs(times - self.times(k)) <= ON_THE_GRID * dt for k in (steps, steps + 1)]
        there, step = near[0] | near[1], np.where(near[1] & ~near[0], steps + 1, steps).astype(int)
        for one, k, on in zip(switches, step.tolist(), there.tolist(), strict=True):
            (self.on if on else self.inside).setdefault(k, []).append(one)
        self.broken = sorted({*self.inside, *(k - 1 for k in self.on if k > 0)})
        self._next = np.array([*(k for k in self.broken if k < known), known, sys.maxsize], dtype=np.int64)
        self._inside = step[~there], times[~there], before[~there], after[~there]
        self._on, first = np.unique(step[there], return_index=True)
        self._sides_on = (
            (np.minimum.reduceat(before[there], first), np.maximum.reduceat(after[there], first))
            if len(first)
            else (first, first)
        )

    def time(self, step: int) -> float:
        """Of the grid [s]."""
        return self.t0 + step * self.dt

    def times(self, steps: np.ndarray) -> np.ndarray:
        """(N,) of the grid [s]."""
        return np.asarray(self.t0 + steps * self.dt)

    def clock(self, step: int) -> float:
        """The time from which a step starts [s]: after a jump that is there."""
        return float(np.maximum(self._sides(np.array([step]))[1], self.time(step))[0])

    def parts(self, steps: np.ndarray) -> StepParts:
        """Of broken steps (S,) that follow one another.

        A part is as long as it is between the times at its ends, up to LOST. At a jump its clocks stay on their side:
        one that ends at a jump starts from a clock so much sooner, one that starts behind a jump ends so much later.
        What is between two jumps is made in halves, one with the clocks of the first, one with those of the second.
        """
        own = slice(*np.searchsorted(self._inside[0], [steps[0], steps[-1] + 1]))
        step, time, last, first = (values[own] for values in self._inside)
        counts = np.bincount(np.searchsorted(steps, step), minlength=len(steps)) + 1
        ends = np.zeros(counts.sum(), dtype=bool)
        ends[np.cumsum(counts) - 1] = True
        begins = np.roll(ends, 1)
        start, end, before, after, behind = (np.empty(len(ends)) for _ in range(5))
        start[begins], start[~begins], end[ends], end[~ends] = self.times(steps), time, self.times(steps + 1), time
        (_, behind[begins]), behind[~begins] = self._sides(steps), first
        (before[ends], after[ends]), before[~ends], after[~ends] = self._sides(steps + 1), last, first
        clocks = np.maximum(after[ends], end[ends])
        length = end - start
        clock, free = np.maximum(behind, start), np.isinf(behind)
        short = (clock + length - before > LOST * self.dt) & ~(free & (start <= self.t0))  # loads may begin at t0
        halved = short & ~free
        length = np.where(short, length / (1 + halved), np.minimum(length, before - clock))
        clock = np.where(short & free, before - length, clock)
        of = np.repeat(np.arange(len(ends)), 1 + halved)
        again, goes_on = np.append(False, of[1:] == of[:-1]), np.append(of[1:] == of[:-1], False)
        clock = np.where(again, before[of] - length[of], clock[of])
        before, after = np.where(goes_on, np.inf, before[of]), np.where(goes_on, -np.inf, after[of])
        counts = np.add.reduceat(1 + halved, np.flatnonzero(begins))
        return StepParts(clock, length[of], before, after, counts, clocks)

    def _sides(self, steps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(N,) clocks before and after what jumps at the start of steps [s]; infinite where nothing does."""
        before, after = np.full(len(steps), np.inf), np.full(len(steps), -np.inf)
        if len(self._on):
            k = np.minimum(np.searchsorted(self._on, steps), len(self._on) - 1)
            there = self._on[k] == steps
            before[there], after[there] = (side[k[there]] for side in self._sides_on)
        return before, after

    def next_broken(self, step: int) -> int | None:
        """The first broken step from this one on."""
        k = self.number(step)
        return self.broken[k] if k < len(self.broken) else None

    def number(self, step: int) -> int:
        """How many steps before this one are broken."""
        return bisect_left(self.broken, step)
