"""What happens at which step of a differentiated run: outputs are taken, inputs are set, jumps in time are crossed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NoReturn

import casadi as ca
import numpy as np

from runtime.contract.errors import NoResult
from runtime.contract.model import EmittedModel
from runtime.running.problem import Plan
from runtime.schemes.switching.times import JUMP_AT_STEP, Breaks, SwitchTime, switching_times, within

JUMPS, EVENT = "jumps", "event"  # of turns whose time moves, as that of a jump or of an event
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
class EventCrossing:
    """Events happen at a clock [s]. event: the position of the one whose time counts (-1: of none).

    least: the rate of its value [1/s] below which it grazes zero. sets: does an action change inputs?; modes: those of
    elements behind it. push (n_i,): what impacts add to the rates; rows, struck: see impacts.py; empty without
    elements.
    """

    clock: float
    event: int = -1
    least: float = 0.0
    sets: bool = False
    modes: tuple[Hold, ...] = ()
    push: np.ndarray = field(default_factory=lambda: np.zeros(0))
    rows: np.ndarray = field(default_factory=lambda: np.zeros(0))
    struck: np.ndarray = field(default_factory=lambda: np.zeros(0))


@dataclass(frozen=True)
class Turn:
    """A restart at a clock [s] from major steps dt_before to those of dt [s], with t0 [s] and n of z behind it.

    goes_on: are steps of dt made before the next turn? Else those of the grid. jump, passage, holds: what is there.
    """

    dt_before: float
    dt: float
    clock: float
    t0: float
    n: int
    goes_on: bool = False
    jump: Jump | None = None
    crossing: EventCrossing | None = None
    holds: tuple[Hold, ...] = ()

    @property
    def kind(self) -> str:
        """EVENT; JUMPS where the time of a jump moves; nothing where neither is."""
        if self.crossing is not None and self.crossing.event >= 0:
            return EVENT
        return JUMPS if self.jump is not None and self.jump.moves.any() else ""


@dataclass(frozen=True)
class Stop:
    """A turn, if any, so many major steps behind it, and then outputs as a sample (-1: none).

    t0: of z from here on where there is no turn [s].
    """

    steps: int
    sample: int = -1
    turn: Turn | None = None
    t0: float = 0.0


@dataclass(frozen=True)
class Course:
    """Stops, the first before any step; times [steps] of the samples (N,)."""

    stops: tuple[Stop, ...]
    times: tuple[int, ...]

    @property
    def steps(self) -> int:
        """All of them."""
        return sum(stop.steps for stop in self.stops)


def course(plan: Plan, holds: Iterable[Hold] = ()) -> Course:
    """Samples at every so many steps and at the last one; inputs change before that are within the run."""
    steps, t0, dt = plan.steps, plan.t0, plan.grid.dt_L
    times = [*range(0, steps, plan.seen_steps), steps]
    changes: dict[int, list[Hold]] = {}
    for hold in holds:
        if 0 < hold.step < steps:
            changes.setdefault(hold.step, []).append(hold)
    sample = {time: k for k, time in enumerate(times)}
    stops, before = [], 0
    for time in sorted({*times, *changes}):
        stops.append(Stop(time - before, sample.get(time, -1), t0=t0))
        if time in changes:
            stops.append(Stop(0, turn=Turn(dt, dt, t0 + time * dt, t0, time, holds=tuple(changes[time]))))
        before = time
    return Course(tuple(stops), tuple(times))


def across(
    course: Course, grid: Breaks, m: Sequence[int], moves: Moves, crossings: Mapping[int, Sequence[EventCrossing]]
) -> Course:
    """The course with the steps made in parts in which something jumps, or events happen (by step); m: of the groups.

    Raises NoResult for an event at the time of a jump.
    """
    special = sorted({*grid.broken, *crossings})
    stops, done, t0 = list[Stop](), 0, grid.t0 + (grid.clock(0) - grid.t0)
    for stop in course.stops:
        if stop.turn is not None:
            stops.append(replace(stop, turn=replace(stop.turn, t0=t0, clock=t0 + done * grid.dt)))
            continue
        end, cut = done + stop.steps, list[Stop]()
        for k in [*(one for one in special if done <= one < end), end]:
            if k > done and t0 != grid.t0:  # the first step behind a jump that is on the grid
                cut.append(Stop(1, t0=t0))
                done, t0 = done + 1, grid.t0
            cut += [Stop(k - done, t0=t0)] if k > done else []
            if k < end:
                cut += _broken(grid, k, m, moves, crossings.get(k, ()))
                assert cut[-1].turn is not None
                t0 = cut[-1].turn.t0
            done = k + 1
        stops += [*cut[:-1], replace(cut[-1] if cut else stop, sample=stop.sample)]
        done = end
    return replace(course, stops=tuple(stops))


def _broken(
    grid: Breaks, step: int, m: Sequence[int], moves: Moves, crossings: Sequence[EventCrossing]
) -> Iterator[Stop]:
    """The parts of a step, and the way back to the grid."""
    turn = Turn(grid.dt, grid.dt, 0.0, 0.0, 0)
    for start, length, jump, crossing in _parts(grid, step, moves, crossings):
        turn = replace(turn, dt=within(length, m), clock=start, t0=start, goes_on=True)
        yield Stop(1, turn=turn)
        holds = () if crossing is None else crossing.modes
        turn = Turn(turn.dt, grid.dt, 0.0, 0.0, 0, jump=jump, crossing=crossing, holds=holds)
    clock = grid.clock(step + 1)
    origin = float(grid.origins(np.array([step + 1]), np.array([clock]))[0])
    yield Stop(0, turn=replace(turn, clock=clock, t0=origin, n=step + 1))


def _parts(
    grid: Breaks, step: int, moves: Moves, crossings: Sequence[EventCrossing]
) -> Iterator[tuple[float, float, Jump | None, EventCrossing | None]]:
    """(clock, length, what is at its end) of each part of a step [s]."""
    waiting, inside = list(crossings), iter(grid.inside.get(step, []))
    for start, length, before, after in grid.parts(np.array([step])).each():
        end, jump, last = start + length, None, None
        if before is not None:
            there = next(inside, None)
            jump = Jump(before, after, moves(grid.on[step + 1] if there is None else [there]))
        while last is None and waiting and waiting[0].clock <= (end if before is None else after):
            crossing = waiting.pop(0)
            left = end - crossing.clock
            if crossing.clock < start:
                _refuse(crossing)
            if left > JUMP_AT_STEP * grid.dt:
                yield start, crossing.clock - start, None, crossing
                start, length = crossing.clock, left
            elif jump is None:
                last, length = crossing, crossing.clock - start
            elif crossing.clock < jump.before or crossing.sets:
                _refuse(crossing)
            else:  # what sticks lets go by the jump itself
                last = replace(crossing, event=-1)
        yield start, length, jump, last
    if waiting:
        _refuse(waiting[0])


def _refuse(crossing: EventCrossing) -> NoReturn:
    raise NoResult(f"an event at t = {crossing.clock:.6g} s", "coincides with a jump of a load", "move one of them")


# How the times of jumps move with parameters: g(t, c(p)) = 0 gives dt/dp = -g_p / g_t.

NEAR_JUMP = 1e-9  # of a run: a condition whose zero is that near to a jump is of it
ALIKE_SLOPES = 1e-9  # of the largest entry: derivatives of the times of two conditions


class MovingJumps:
    """Of a model; by: the entries of p that are differentiated by."""

    def __init__(self, model: EmittedModel, by: Sequence[int]) -> None:
        self._model, self._by = model, list(by)
        if model.has("switching"):
            t, p = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
            g = ca.densify(model.evaluate("switching", t=t, c=model.kernel("constants")(p))["switching"])
            slopes = ca.densify(ca.jacobian(g, p)) if self._by else ca.SX.zeros(g.numel(), p.numel())
            self._of = ca.Function("conditions", [t, p], [g, ca.densify(ca.jacobian(g, t)), slopes])

    def broken(
        self, course: Course, plan: Plan, p: np.ndarray, crossings: Mapping[int, Sequence[EventCrossing]]
    ) -> Course:
        """The course of a run with parameters p (n_p,), its steps in parts where something jumps or happens.

        crossings: of events, by step. Raises NoResult.
        """
        found = switching_times(self._model, self._model.constants(p), plan.t0, plan.t_end)
        if not found and not crossings and plan.end is None:
            return course
        near, grid = NEAR_JUMP * (plan.t_end - plan.t0), Breaks(plan.t0, plan.grid.dt_L, found, end=plan.end)
        return across(course, grid, plan.grid.m, lambda there: self._moves(there, p, near), crossings)

    def _moves(self, there: Sequence[SwitchTime], p: np.ndarray, near: float) -> np.ndarray:
        """(n_p,) the derivative of the time of jumps that are at one time; near [s]: zeros of their conditions."""
        none = np.zeros(len(p))
        if not self._by or not self._model.has("switching"):
            return none
        found: list[np.ndarray] = []
        for one in there:
            g, g_t, g_p = (np.asarray(value) for value in self._of(one.time, p))
            for k in np.flatnonzero(np.abs(g[:, 0]) <= near * np.abs(g_t[:, 0])):
                if g_t[k, 0] != 0:
                    slope = none.copy()
                    slope[self._by] = -g_p[k, self._by] / g_t[k, 0]
                    found.append(slope)
        if not found:
            return none
        scale = max(float(np.abs(one).max()) for one in found)
        if any(np.abs(one - found[0]).max() > ALIKE_SLOPES * scale for one in found[1:]):
            raise NoResult(
                f"model {self._model.name}",
                f"two conditions change at t = {there[0].time:.6g} s and separate when these change: "
                f"({', '.join(there[0].owners)})",
                "move one of them a little, or leave out of `by` what moves them",
            )
        return found[0]
