"""Which steps of a grid are broken: the times at which something jumps, within steps and at their ends."""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from runtime.schemes.switching.times import SwitchTime
from runtime.schemes.work import AHEAD

ON_THE_GRID = 1e-9  # of a step: a jump that near to the end of a step is there


@dataclass(frozen=True)
class StepParts:
    """Of broken steps, in order: clocks at which they start and end (N,) [s]; counts (S,): how many each step has.

    clocks (S,): from where the step behind each broken one starts [s].
    """

    start: np.ndarray
    end: np.ndarray
    counts: np.ndarray
    clocks: np.ndarray


class Breaks:
    """Of steps of dt [s] from t0 on. inside: jumps by the step that they are in; on: at the start of which step."""

    def __init__(self, t0: float, dt: float, switches: Sequence[SwitchTime]) -> None:
        self.t0, self.dt = t0, dt
        self.inside: dict[int, list[SwitchTime]] = {}
        self.on: dict[int, list[SwitchTime]] = {}
        times, self._before, self._after = (
            np.array([getattr(one, name) for one in switches], dtype=float) for name in ("time", "before", "after")
        )
        steps = np.floor((times - t0) / dt)
        near = [np.abs(times - self.times(k)) <= ON_THE_GRID * dt for k in (steps, steps + 1)]
        self._there, self._step = near[0] | near[1], np.where(near[1] & ~near[0], steps + 1, steps).astype(int)
        for one, step, there in zip(switches, self._step.tolist(), self._there.tolist(), strict=True):
            (self.on if there else self.inside).setdefault(step, []).append(one)
        self.broken = sorted({*self.inside, *(k - 1 for k in self.on if k > 0)})
        self._next = np.array([*self.broken, sys.maxsize], dtype=np.int64)

    def time(self, step: int) -> float:
        """Of the grid [s]."""
        return self.t0 + step * self.dt

    def times(self, steps: np.ndarray) -> np.ndarray:
        """(N,) of the grid [s]."""
        return np.asarray(self.t0 + steps * self.dt)

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

    def parts(self, first: int, last: int) -> StepParts:
        """Of these broken steps, counted among the broken ones."""
        steps = np.array(self.broken[first:last])
        inside = ~self._there & (self._step >= steps[0]) & (self._step <= steps[-1])
        counts = np.bincount(np.searchsorted(steps, self._step[inside]), minlength=len(steps)) + 1
        ends = np.zeros(counts.sum(), dtype=bool)
        ends[np.cumsum(counts) - 1] = True
        begins = np.roll(ends, 1)
        start, end = np.empty(len(ends)), np.empty(len(ends))
        start[~begins], end[~ends] = self._after[inside], self._before[inside]
        (_, start[begins]), (end[ends], clocks) = self._sides(steps), self._sides(steps + 1)
        return StepParts(start, end, counts, clocks)

    def _sides(self, steps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(N,) clocks at which the steps before these end, and from which these start [s]."""
        before, after = self.times(steps), self.times(steps)
        on = self._step[self._there]
        if len(on):
            which, first = np.unique(on, return_index=True)
            least = np.minimum.reduceat(self._before[self._there], first)
            most = np.maximum.reduceat(self._after[self._there], first)
            k = np.minimum(np.searchsorted(which, steps), len(which) - 1)
            there = which[k] == steps
            before, after = np.where(there, least[k], before), np.where(there, np.maximum(most[k], after), after)
        return before, after

    def next_broken(self, step: int) -> int | None:
        """The first broken step from this one on."""
        k = self.number(step)
        return self.broken[k] if k < len(self.broken) else None

    def whole_ahead(self, steps: np.ndarray) -> np.ndarray:
        """(N,) whole steps from each of these on, as many as an account of work looks at in advance at most."""
        return np.asarray(np.minimum(self._next[np.searchsorted(self._next, steps)] - steps, AHEAD))

    def number(self, step: int) -> int:
        """How many steps before this one are broken."""
        return bisect_left(self.broken, step)
