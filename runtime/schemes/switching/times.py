"""The times at which loads and prescribed motions jump or kink: where a condition of the model changes its sign.

These are the known discontinuities (breakpoints) of the right-hand side; those that depend on the motion are events.

A condition is a function of time once the parameters are numbers. Interval bounds of it and of its slope tell where it
has no zero and where it has at most one; what is left is halved (bisection). So of `sin(w t) > 0` every change is
found, however short its period is beside a step.
"""

from __future__ import annotations

import sys
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.tape import node_value, read_tape
from runtime.engine.rows import ManyPoints
from runtime.schemes.switching.enclosure import Enclosure

MOST_TIMES = 100_000
MOST_PIECES = 1 << 17  # of the run, under way: from then on what is left is judged by the ends of the pieces
NARROWEST_PIECE = 1e-12  # of the run: changes nearer to each other are one, narrower pieces are not halved
LEAST_PIECE = 1e-18  # of the run, about zero; elsewhere floats are further apart
CONDITION_ROUNDING = 16 * np.finfo(float).eps  # of a time: conditions written in another way round otherwise
Signs = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class SwitchTime:
    """A time [s] at which something jumps or kinks; before < time < after: clocks that show one side and the other.

    owners: the loads, joints, states and inputs that it is of.
    """

    time: float
    before: float
    after: float
    owners: tuple[str, ...]


def has_switching_times(model: EmittedModel) -> bool:
    """May loads or prescribed motions jump or kink in time, by the scene or by the functions given for inputs?"""
    return model.has("switching") or bool(model.sources)


def may_jump(model: EmittedModel) -> bool:
    """Does a condition change with time, by the scene, by inputs that move, or by functions given for them?"""
    if not has_switching_times(model):
        return False
    if model.sources:
        return True
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    return bool(ca.depends_on(model.evaluate("switching", t=t, c=c)["switching"], t))


def switches_by_inputs(model: EmittedModel) -> bool:
    """Do conditions of the scene depend on held inputs?"""
    if not model.has("switching") or not model.signals.size:
        return False
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    return bool(ca.depends_on(model.evaluate("switching", t=t, c=c)["switching"], c[-model.signals.size :]))


def switching_times(model: EmittedModel, c: np.ndarray, t0: float, t_end: float) -> list[SwitchTime]:
    """All of them from t0 to t_end [s], rising, for constants c (c_size,) with held inputs; no step should cross one.

    Raises ModelError if there are more than MOST_TIMES.
    """
    found: list[SwitchTime] = []
    if not has_switching_times(model) or not t_end > t0:
        return found
    t = ca.SX.sym("t")
    for owner, value in conditions(model, ca.SX(ca.DM(c)), t):
        if not ca.depends_on(value, t):
            continue
        found += [SwitchTime(*clocks, (owner,)) for clocks in _changes(value, t, t0, t_end)]
        if len(found) > MOST_TIMES:
            raise ModelError(
                f"{owner} of model {model.name}",
                f"jumps or kinks more than {MOST_TIMES} times from {t0:g} to {t_end:g} s, and steps end at each",
                "simulate a shorter time, or let it change smoothly",
            )
    return _merged(found, NARROWEST_PIECE * (t_end - t0))


def conditions(model: EmittedModel, c: ca.SX, t: ca.SX) -> Iterator[tuple[str, ca.SX]]:
    """(owner, value that changes its sign), of the scene and of functions given for inputs; constants c (c_size,)."""
    if model.has("switching"):
        values = model.evaluate("switching", t=t, c=c)["switching"]
        yield from zip(model.description.switching, ca.vertsplit(ca.SX(values)), strict=True)
    for name, source in model.sources.items():
        yield from ((f"input {name}", value) for value in _of_function(source, t))


def _of_function(source: ca.Function, t: ca.SX) -> Iterator[ca.SX]:
    """What changes sign where a function of time branches, by its operations."""
    values: list[ca.SX] = []
    for node in read_tape(source).nodes:
        values.append(node_value(node, values, [t]))
        if node.op in (ca.OP_LT, ca.OP_LE, ca.OP_EQ, ca.OP_NE, ca.OP_FMIN, ca.OP_FMAX):
            yield values[node.a] - values[node.b]
        elif node.op in (ca.OP_SIGN, ca.OP_FABS):
            yield values[node.a]
        elif node.op in (ca.OP_FLOOR, ca.OP_CEIL):
            yield ca.sin(np.pi * values[node.a])
        elif node.op == ca.OP_FMOD:
            yield ca.sin(np.pi * values[node.a] / values[node.b])


def _changes(value: ca.SX, t: ca.SX, t0: float, t_end: float) -> list[tuple[float, float, float]]:
    """(time, clock before, clock after) of each change of sign."""
    with_slope = ca.Function("condition", [t], [ca.densify(ca.vertcat(value, ca.jacobian(value, t)))])
    plain = ManyPoints(ca.Function("condition", [t], [ca.densify(value)]))

    def at(times: np.ndarray) -> np.ndarray:
        return plain(times[:, None])[:, 0]

    around = NARROWEST_PIECE * max(t_end - t0, abs(t0), abs(t_end))  # a change at t0 or at t_end shows its two sides
    low, high = _pieces(Enclosure(with_slope), t0 - around, t_end + around)
    if not len(low):
        return []
    a, b = at(low), at(high)
    change = (a >= 0) != (b >= 0)
    low, high, a, b = (part[change] for part in (low, high, a, b))
    rising = b > a
    # both ends of a stretch of zeros: the last clock with the sign before, the first with the one after
    before = _last(low, high, lambda x: np.where(rising, at(x) < 0, at(x) > 0), np.where(rising, a < 0, a > 0))
    high = _soon(before, high, lambda x: np.where(rising, at(x) > 0, at(x) < 0))
    after = -_last(-high, -before, lambda x: np.where(rising, at(-x) > 0, at(-x) < 0), np.where(rising, b > 0, b < 0))
    time = before + (after - before) / 2
    inside = (time >= t0 - around) & (time <= t_end + around)
    margin = CONDITION_ROUNDING * np.abs(time)
    clocks = np.column_stack([np.clip(time, t0, t_end), before - margin, after + margin])[inside]
    return [(float(one), float(two), float(three)) for one, two, three in clocks]


def _pieces(condition: Enclosure, t0: float, t_end: float) -> tuple[np.ndarray, np.ndarray]:
    """Pieces of the run (low, high) with at most one change each; those that surely have none are left out."""
    low, high = np.array([t0]), np.array([t_end])
    kept: list[tuple[np.ndarray, np.ndarray]] = []
    while len(low):
        (value, slope), jumps = condition.bounds(low, high)
        possible = (value[0] <= 0) & (value[1] >= 0)
        one = ((slope[0] > 0) | (slope[1] < 0)) & ~jumps
        done = possible & (one | (high - low <= NARROWEST_PIECE * (t_end - t0)))
        kept.append((low[done], high[done]))
        low, high = low[possible & ~done], high[possible & ~done]
        if len(low) > MOST_PIECES:
            kept.append((low, high))
            break
        middle = low + (high - low) / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    lows, highs = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    order = np.argsort(lows)
    return lows[order], highs[order]


def _soon(low: np.ndarray, high: np.ndarray, holds: Signs) -> np.ndarray:
    """Times from low to high at which a condition holds as it does at high, by going ahead from low."""
    reach, found = 2 * np.spacing(np.abs(low)), high.copy()
    waits = np.ones(len(low), dtype=bool)
    while waits.any():
        near = np.minimum(low + reach, high)
        done = waits & ((near >= high) | holds(near))
        found[done], waits = near[done], waits & ~done
        reach *= 8
    return found


def _last(low: np.ndarray, high: np.ndarray, holds: Signs, at_low: np.ndarray) -> np.ndarray:
    """The last float in [low, high] until which a condition holds, by halving; low where it does not hold there."""
    low, high, finest = low.copy(), np.where(at_low, high, low), LEAST_PIECE * (high - low).max(initial=0.0)
    while True:
        middle = low + (high - low) / 2
        if not np.any((low < middle) & (middle < high) & (high - low > finest)):
            return low
        yes = holds(middle)
        low, high = np.where(yes, middle, low), np.where(yes, high, middle)


def between(switches: Sequence[SwitchTime], t0: float, t_end: float) -> Sequence[SwitchTime]:
    """Those of all, rising, that are from t0 to t_end [s]."""
    first, last = (
        find(switches, t, key=lambda one: one.time) for find, t in ((bisect_left, t0), (bisect_right, t_end))
    )
    return switches[first:last]


def _merged(found: list[SwitchTime], near: float) -> list[SwitchTime]:
    """In order; those at one time together."""
    merged: list[SwitchTime] = []
    for one in sorted(found, key=lambda each: each.time):
        if merged and one.time - merged[-1].time <= near:
            last = merged.pop()
            owners = tuple(dict.fromkeys((*last.owners, *one.owners)))
            one = SwitchTime(last.time, min(last.before, one.before), max(last.after, one.after), owners)
        merged.append(one)
    return merged


# Which steps of a grid are broken: the times at which something jumps, within steps and at their ends.

JUMP_AT_STEP = 1e-9  # of a step: a jump that near to the end of a step is there
SHORT_PART_ROUNDING = (
    1e-11  # of a step: by so much a part that ends at a jump may be short, so that its clocks are on their sides
)


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

    known: of how many steps all jumps are given. end [s]: where the last step ends, if that is sooner than its dt; it
    is then one of the broken ones.
    """

    def __init__(
        self,
        t0: float,
        dt: float,
        switches: Sequence[SwitchTime],
        known: int = sys.maxsize,
        end: float | None = None,
    ) -> None:
        self.t0, self.dt, self.end = t0, dt, end
        self.last = sys.maxsize if end is None else int(np.ceil((end - t0) / dt))
        self.inside: dict[int, list[SwitchTime]] = {}
        self.on: dict[int, list[SwitchTime]] = {}
        times, before, after = (
            np.array([getattr(one, name) for one in switches], dtype=float) for name in ("time", "before", "after")
        )
        steps = np.floor((times - t0) / dt)
        near = [np.abs(times - self.ends(k)) <= JUMP_AT_STEP * dt for k in (steps, steps + 1)]
        there, step = near[0] | near[1], np.where(near[1] & ~near[0], steps + 1, steps).astype(int)
        for one, k, on in zip(switches, step.tolist(), there.tolist(), strict=True):
            (self.on if on else self.inside).setdefault(k, []).append(one)
        shorter = set() if end is None else {self.last - 1}
        self.broken = sorted({*self.inside, *(k - 1 for k in self.on if k > 0), *shorter})
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

    def ends(self, steps: np.ndarray) -> np.ndarray:
        """(N,) times after so many steps [s]: those of the grid, but for the end of a shorter last step."""
        times = self.times(steps)
        return times if self.end is None else np.where(steps == self.last, self.end, times)

    def clock(self, step: int) -> float:
        """The time from which a step starts [s]: after a jump that is there."""
        steps = np.array([step])
        return float(np.maximum(self._sides(steps)[1], self.ends(steps))[0])

    def origins(self, steps: np.ndarray, clocks: np.ndarray) -> np.ndarray:
        """(N,) t0 [s] of states after so many steps whose clocks show these times [s]."""
        found = self.t0 + (clocks - self.times(steps))
        return found if self.end is None else np.where(steps == self.last, clocks - steps * self.dt, found)

    def parts(self, steps: np.ndarray) -> StepParts:
        """Of broken steps (S,) that follow one another.

        A part is as long as it is between the times at its ends, up to SHORT_PART_ROUNDING. At a jump its clocks
        stay on their side: one that ends at a jump starts from a clock so much sooner, one that starts behind a
        jump ends so much later. What is between two jumps is made in halves, one with the clocks of the first, one
        with those of the second.
        """
        own = slice(*np.searchsorted(self._inside[0], [steps[0], steps[-1] + 1]))
        step, time, last, first = (values[own] for values in self._inside)
        counts = np.bincount(np.searchsorted(steps, step), minlength=len(steps)) + 1
        ends = np.zeros(counts.sum(), dtype=bool)
        ends[np.cumsum(counts) - 1] = True
        begins = np.roll(ends, 1)
        start, end, before, after, behind = (np.empty(len(ends)) for _ in range(5))
        start[begins], start[~begins], end[ends], end[~ends] = self.times(steps), time, self.ends(steps + 1), time
        (_, behind[begins]), behind[~begins] = self._sides(steps), first
        (before[ends], after[ends]), before[~ends], after[~ends] = self._sides(steps + 1), last, first
        clocks = np.maximum(after[ends], end[ends])
        length = end - start
        clock, free = np.maximum(behind, start), np.isinf(behind)
        short = (clock + length - before > SHORT_PART_ROUNDING * self.dt) & ~(
            free & (start <= self.t0)
        )  # loads may begin at t0
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
