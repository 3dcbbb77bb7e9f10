"""What happens at which step of a differentiated run: outputs are taken, inputs are set, jumps in time are crossed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from runtime.contract.errors import NoResult
from runtime.schemes.switching.breaks import ON_THE_GRID, Breaks
from runtime.schemes.switching.times import SwitchTime

Moves = Callable[[Sequence[SwitchTime]], np.ndarray]  # of jumps at one time: its derivative by p (n_p,)


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
class Jump:
    """Clocks before and after it [s], and the derivative of its time by p (n_p,)."""

    before: float
    after: float
    moves: np.ndarray


@dataclass(frozen=True)
class EventPassage:
    """Events happen at a clock [s]. event: the position of the one that acts (-1: none).

    least: the rate of its value [1/s] below which it grazes zero.
    """

    clock: float
    event: int = -1
    least: float = 0.0


@dataclass(frozen=True)
class StepPart:
    """Of a broken step: from a clock on, so long [s], behind a jump or a passage of events."""

    start: float
    length: float
    jump: Jump | None
    passage: EventPassage | None = None


@dataclass(frozen=True)
class Broken:
    """Parts of a major step, the number of steps done after it, and the clock from which the next one starts [s].

    passage: of events at its end. whole: is it one step of the grid, from a clock behind a jump at its start?
    """

    parts: tuple[StepPart, ...]
    step: int
    clock: float
    passage: EventPassage | None = None
    whole: bool = False


@dataclass(frozen=True)
class Stop:
    """After so many major steps, or a broken one: outputs are taken as a sample (-1: none), then inputs change."""

    steps: int
    sample: int
    holds: tuple[Hold, ...] = ()
    broken: Broken | None = None

    @property
    def recorded(self) -> int:
        """Steps that are made."""
        return self.steps if self.broken is None else len(self.broken.parts)


@dataclass(frozen=True)
class Course:
    """Stops, the first before any step; times [steps] of the samples (N,)."""

    stops: tuple[Stop, ...]
    times: tuple[int, ...]

    @property
    def steps(self) -> int:
        """All of them."""
        return sum(stop.recorded for stop in self.stops)


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


def across(course: Course, breaks: Breaks, moves: Moves, passages: Mapping[int, Sequence[EventPassage]]) -> Course:
    """The course with its steps broken where something jumps, and where events happen (by step)."""
    special = sorted({*breaks.broken, *breaks.on, *passages})
    stops: list[Stop] = []
    done = 0
    for stop in course.stops:
        end, cut = done + stop.steps, []
        for k in (one for one in special if done <= one < end):
            if k > done:
                cut.append(Stop(k - done, -1))
            cut.append(Stop(0, -1, broken=_passed(_broken(breaks, k, moves), passages.get(k, ()), breaks.dt)))
            done = k + 1
        if done < end or not cut:
            cut.append(Stop(end - done, -1))
        stops += [*cut[:-1], replace(cut[-1], sample=stop.sample, holds=stop.holds)]
        done = end
    return replace(course, stops=tuple(stops))


def _broken(breaks: Breaks, step: int, moves: Moves) -> Broken:
    there = breaks.on.get(step, []) if step else []
    jump = Jump(min(one.before for one in there), breaks.clock(step), moves(there)) if there else None
    inside, parts = iter(breaks.inside.get(step, [])), []
    for start, length, before, after in breaks.parts(np.array([step])).each():
        parts.append(StepPart(start, length, jump))
        one = next(inside, None) if before is not None else None  # what jumps at the end of the step is the next one's
        jump = Jump(before, after, moves([one])) if one is not None and before is not None else None
    whole = breaks.next_broken(step) != step
    return Broken(tuple(parts), step + 1, breaks.clock(step + 1), whole=whole)


def _passed(broken: Broken, passages: Sequence[EventPassage], dt: float) -> Broken:
    """The same with parts that end at passages of events, too. Raises NoResult for one at the time of a jump."""
    parts, last = list[StepPart](), None
    waiting = list(passages)
    for k, part in enumerate(broken.parts):
        end, now = part.start + part.length, part
        while waiting and waiting[0].clock <= end:
            passage = waiting.pop(0)
            _refuse(passage, passage.clock < now.start)
            left = end - passage.clock
            parts.append(replace(now, length=passage.clock - now.start))
            if left > ON_THE_GRID * dt:
                now = StepPart(passage.clock, left, None, passage)
                continue
            _refuse(passage, k < len(broken.parts) - 1)
            now, last = replace(now, length=0.0), passage
        if now.length:
            parts.append(now)
    if waiting:
        _refuse(waiting[0], True)
    return replace(broken, parts=tuple(parts), passage=last, whole=broken.whole and not passages)


def _refuse(passage: EventPassage, where_something_jumps: bool) -> None:
    if where_something_jumps:
        raise NoResult(f"an event at t = {passage.clock:.6g} s", "happens just where a load jumps", "move one of them")
