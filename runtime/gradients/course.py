"""What happens at which step of a differentiated run: outputs are taken, inputs are set, jumps in time are crossed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from runtime.contract.errors import NoResult
from runtime.contract.model import Model
from runtime.schemes.switching.breaks import ON_THE_GRID, Breaks
from runtime.schemes.switching.times import SwitchTime, has_switching_times, switches_by_inputs, switching_times

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


# How the times of jumps move with parameters: g(t, c(p)) = 0 gives dt/dp = -g_p / g_t.

NEAR = 1e-9  # of a run: a condition whose zero is that near to a jump is of it
ALIKE = 1e-9  # of the largest entry: derivatives of the times of two conditions


class MovingJumps:
    """Of a model; by: the entries of p that are differentiated by. steps, t0 [s], dt [s]: of the run."""

    def __init__(self, model: Model, by: Sequence[int], t0: float, dt: float, steps: int) -> None:
        self._model, self._by = model, list(by)
        self._t0, self._dt, self._end = t0, dt, t0 + steps * dt
        self.possible = has_switching_times(model)
        if model.has("switching"):
            t, p = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
            g = ca.densify(model.evaluate("switching", t=t, c=model.kernel("constants")(p))["switching"])
            slopes = ca.densify(ca.jacobian(g, p)) if self._by else ca.SX.zeros(g.numel(), p.numel())
            self._of = ca.Function("conditions", [t, p], [g, ca.densify(ca.jacobian(g, t)), slopes])

    def over(self, t0: float, dt: float, steps: int) -> MovingJumps:
        """The same of a run with so many steps of dt from t0 on [s]."""
        other = copy(self)
        other._t0, other._dt, other._end = t0, dt, t0 + steps * dt
        return other

    @property
    def reads_inputs(self) -> bool:
        """Do conditions depend on held inputs?"""
        return switches_by_inputs(self._model)

    def broken(self, course: Course, p: np.ndarray, passages: Mapping[int, Sequence[EventPassage]]) -> Course:
        """The course of a run with parameters p (n_p,), its steps broken where something jumps or happens.

        passages: of events, by step. Raises NoResult.
        """
        c, found = self._model.constants(p), list[SwitchTime]()
        if self.possible:
            found = switching_times(self._model, c, self._t0, self._end)
        if not found and not passages:
            return course
        return across(course, Breaks(self._t0, self._dt, found), lambda there: self._moves(there, p), passages)

    def _moves(self, there: Sequence[SwitchTime], p: np.ndarray) -> np.ndarray:
        """(n_p,) the derivative of the time of jumps that are at one time."""
        none = np.zeros(len(p))
        if not self._by or not self._model.has("switching"):
            return none
        found: list[np.ndarray] = []
        for one in there:
            g, g_t, g_p = (np.asarray(value) for value in self._of(one.time, p))
            for k in np.flatnonzero(np.abs(g[:, 0]) <= NEAR * (self._end - self._t0) * np.abs(g_t[:, 0])):
                if g_t[k, 0] != 0:
                    slope = none.copy()
                    slope[self._by] = -g_p[k, self._by] / g_t[k, 0]
                    found.append(slope)
        if not found:
            return none
        scale = max(float(np.abs(one).max()) for one in found)
        if any(np.abs(one - found[0]).max() > ALIKE * scale for one in found[1:]):
            raise NoResult(
                f"model {self._model.name}",
                f"two conditions change at t = {there[0].time:.6g} s and move apart with what is differentiated by "
                f"({', '.join(there[0].owners)})",
                "move one of them a little, or leave out of `by` what moves them",
            )
        return found[0]
