"""Steps of a grid with its stops: parts of steps are handed to the step program, events are searched between them."""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from threading import Lock
from typing import NamedTuple

import casadi as ca
import numpy as np

from runtime.engine.native import Engine, choose_engine
from runtime.schemes.scheme import direct
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.event_search import MOST_PLACES_OF_STEP, first_bracket, first_passage, unsure
from runtime.schemes.switching.impulse import Impulse, may_give_impulses
from runtime.schemes.switching.native_events import EventLog, EventRecord, KinkMemory, StepTable, native_events
from runtime.schemes.switching.stop_program import KNOWN_PARTS, Restart, StopProgram, impulse_there
from runtime.schemes.switching.times import JUMP_AT_STEP, Breaks, SwitchTime, within
from runtime.schemes.switching.watched import NEVER, Acted, are_kinks, event_slopes, event_values, passed, quiet_until

STEPS_WORTH_A_CALL = 128  # whole steps that are worth a call of the step program alone
STEPS_LOOKED_UP = 256  # steps with stops whose parts are looked up at once
RESOLVED_STEPS, RESOLVING_PARTS = 2, 4  # steps that a load acts for, below which more parts tell what they err
_LOCK = Lock()


# what events (positions) do to a state shown by steps dt at a time [s], in place
Acts = Callable[[np.ndarray, float, float, list[int]], Acted]


class _Compiled(NamedTuple):
    program: StopProgram
    engine: Engine
    restart: Restart


def compiled(stepper: Stepper, impulses: bool) -> _Compiled:
    """Made once for a stepper and those of the same programs with other steps, which are data."""
    with _LOCK:
        if impulses not in stepper.across:
            made = StopProgram(stepper.scheme, stepper.prepared, impulses)
            engine = choose_engine(stepper.requested, made.program(), made.layout.size, made.c_size, stepper.waits)
            stepper.across[impulses] = _Compiled(made, engine, restart_of(stepper))
        found: _Compiled = stepper.across[impulses]
        return found


def restart_of(stepper: Stepper) -> Restart:
    """Made once, as `compiled`."""
    if "restart" not in stepper.across:
        stepper.across["restart"] = Restart(stepper.scheme, stepper.requested)
    found: Restart = stepper.across["restart"]
    return found


class Opened(NamedTuple):
    """Kinks that loads came to at a clock [s], and the state (whole, flat) of the program behind it."""

    kinks: tuple[int, ...]
    clock: float
    z: np.ndarray


class Passage(NamedTuple):
    """Steps with the events in them: z (whole, flat) behind them, rows (N, n_z) of it at those that were asked for,
    what happened, in order, and what is known of loads that act for a short time.
    """

    z: np.ndarray
    rows: np.ndarray
    records: list[EventRecord]
    opened: Opened
    unresolved: float


class StepsWithStops:
    """Runs major steps dt [s] of a stepper from t0 on, with stops within them or at their ends.

    c (c_size,): the model's constants; known: of how many steps all stops are given; end [s]: see Breaks. impulses: of
    prescribed motions whose velocity has jumped so far, by time. unresolved: error of a rate at the end of a load
    that acted for less than two steps, the largest so far [m/s, rad/s]. opened: the last event, if loads changed at it.
    """

    def __init__(
        self,
        stepper: Stepper,
        t0: float,
        dt: float,
        switches: Sequence[SwitchTime],
        c: np.ndarray,
        known: int = sys.maxsize,
        end: float | None = None,
    ) -> None:
        self.stepper, self.t0, self.dt = stepper, t0, dt
        self.grid, self.impulses = Breaks(t0, dt, switches, known, end), dict[float, Impulse]()
        self.unresolved, self.opened = 0.0, Opened((), 0.0, np.zeros(0))
        self._jolts = np.array([one.time for one in may_give_impulses(stepper.scheme.model, c, switches)])
        self._parts, self._steps = np.zeros((0, 0)), list[int]()  # and the step that each is in
        self._numbers, self._first, self._behind = [0], 0, 0  # of the broken ones; the next one that is not looked up
        self._far = list[int]()  # broken steps with so many whole ones behind them
        self._jolted = list[int]()  # parts at whose end an impulse may be
        self._read = b""
        if self.grid.broken:
            _ = self._made  # compiled before anything is run

    @cached_property
    def _made(self) -> _Compiled:
        found = compiled(self.stepper, bool(len(self._jolts)))
        layout = found.program.layout
        self._z, self._constants, at = np.zeros(layout.size), np.zeros(found.program.c_size), layout.slice
        self._state, self._inputs = self._z[at("state")], self._z[at("inputs")]
        self._inside, self._waiting, self._number = (at(name).start for name in ("inside", "waiting", "number"))
        self._z[at("t0")] = self.t0
        part = found.program.part
        self._known = self._z[at(part[0]).start : at(part[-1]).stop].reshape(len(part), KNOWN_PARTS)
        return found

    def is_whole(self, z: np.ndarray, end: int) -> bool:
        """Are all steps from z (whole, flat) to step `end` steps of the grid, so that the stepper makes them alone?"""
        broken = self.grid.next_broken(int(z[1]))
        return (broken is None or broken >= end) and float(z[0]) == self.t0

    def run(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, steps: int) -> None:
        """Advance z (whole, flat) in place; ready, c (c_size,): what the stepper reads, and the model's constants."""
        step = int(z[1])
        end, broken = step + steps, self.grid.next_broken(step)
        if broken is not None and broken < end:
            self._across(z, ready, c, end)
            return
        if z[0] != self.t0 and steps:  # the clock was set after a jump at the start of this step
            self.stepper.run(z, ready, 1)
            z[0], step = self.t0, step + 1
        self.stepper.run(z, ready, end - step)

    def _load(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray) -> None:
        """A state of the stepper, and what is read with it."""
        made = self._made
        if (read := c.tobytes() + ready.tobytes()) != self._read:
            self._constants[:] = np.concatenate([ready, self.stepper.scheme.constants(c, self.dt)])
            self._go, self._read = made.engine.bound(self._z, self._constants), read
        self._state[:], self._z[self._inside], self._z[self._waiting] = z, 0.0, 0.0
        self._inputs[:] = self._state[self._own_inputs]

    @cached_property
    def _own_inputs(self) -> slice:
        layout = self.stepper.scheme.layout
        return layout.slice("inputs") if "inputs" in layout.sizes else slice(0, 0)

    def _across(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, end: int) -> None:
        """To step `end`, with stops on the way."""
        self._load(z, ready, c)
        whole, step, cursor = self._z, int(z[1]), -1
        while step < end:
            if whole[self._inside] <= 0 and not 0 <= cursor < len(self._steps):
                cursor = self._place(step)
            behind = min(cursor + KNOWN_PARTS, len(self._steps))
            ahead = (self._steps[cursor] if cursor < behind else self._behind) - step
            if min(ahead, end - step) >= STEPS_WORTH_A_CALL and self._state[0] == self.t0:
                self.stepper.run(self._state, ready, min(ahead, end - step))
                step = int(self._state[1])
                continue
            if self._jolted and (next_one := bisect_left(self._jolted, cursor)) < len(self._jolted):
                behind = min(behind, self._jolted[next_one] + 1)  # what it did is told before the next one
            self._known[:, : behind - cursor] = self._parts[:, cursor:behind]
            whole[self._waiting] = behind - cursor
            # what is not known is not passed: a step of which some parts are known ends by itself where they run out
            until = self._steps[behind] if behind < len(self._steps) else self._behind
            partly = cursor < behind and self._steps[behind - 1] == until
            far = bisect_left(self._far, step)
            until = min(until + partly, self._far[far] + 2 if far < len(self._far) else end, end)
            self._go(max(1, until - step))
            cursor = behind - int(whole[self._waiting])
            if cursor - 1 in self._jolted:
                self._note(*self._parts[-2:, cursor - 1])
            step = int(whole[self._number] if whole[self._inside] > 0 else self._state[1])
        z[:] = self._state

    def _note(self, before: float, after: float) -> None:
        """An impulse that was given last."""
        at = self._made.program.layout.slice
        if (jumps := self._z[at("jumps")]).any():
            self.impulses[float(before + after) / 2] = Impulse(float(self._z[at("energy")][0]), jumps.copy())

    def _place(self, step: int) -> int:
        """Where the parts of the first broken step from this one on are among those that were looked up."""
        grid, number = self.grid, self.grid.number(step)
        if number == len(grid.broken) and self._behind == sys.maxsize:  # none follows
            return len(self._steps)
        if not self._first <= number < self._first + len(self._numbers) - 1:
            steps = np.array(grid.broken[number : number + STEPS_LOOKED_UP], dtype=int)
            self._first, self._parts = number, self._looked_up(steps)
            self._steps = self._parts[0].astype(int).tolist()
            self._numbers = [*np.searchsorted(self._steps, steps).tolist(), len(self._steps)]
            following = number + len(steps)
            self._behind = grid.broken[following] if following < len(grid.broken) else sys.maxsize
            gaps = np.diff(self._steps, append=self._behind)
            self._far = [step for step, gap in zip(self._steps, gaps.tolist(), strict=True) if gap > STEPS_WORTH_A_CALL]
            self._jolted = np.flatnonzero(self._parts[-3]).tolist() if len(self._jolts) else []
        return self._numbers[number - self._first]

    def _looked_up(self, steps: np.ndarray) -> np.ndarray:
        """(fields of a part, N) of broken steps (S,)."""
        return parts_of(self.grid, steps, self.stepper.scheme.grid.m, self._jolts)

    def breaks_between(self, before: float, after: float) -> bool:
        """Do steps end within themselves somewhere between two clocks [s]?"""
        first, last = (int((clock - self.t0) / self.dt) for clock in (before, after))
        broken = self.grid.next_broken(first)
        return broken is not None and broken <= last

    def note_unresolved(self, rates: np.ndarray, finer: np.ndarray) -> None:
        """Rates (n_i,) at the end of a load that acted for a short time, and those by shorter steps."""
        with np.errstate(invalid="ignore"):
            off = float(np.abs(rates - finer).max())
        self.unresolved = max(self.unresolved, off if np.isfinite(off) else np.inf)

    # ---- steps with events ----------------------------------------------------------------------------------

    def through_events(
        self,
        z: np.ndarray,
        ready: np.ndarray,
        c: np.ndarray,
        ends: np.ndarray,
        kinks: list[KinkMemory],
        told: bool = True,
    ) -> Passage | None:
        """From z (whole, flat) to these steps (N,), rising, in native code; told: with records of what happens. None
        where one of them ends the motion; `accept` makes what was found true.
        """
        code = native_events(self.stepper)
        assert self.native and code is not None
        n, log, records, reached = len(z), self._log, list[EventRecord](), 0
        whole, rows = np.zeros(n + code.sizes["KEPT"]), np.empty((len(ends), n))
        whole[:n], whole[n] = z, self.t0
        code.put_kinks(whole, kinks)
        self._open(log, code.sizes["NE"])
        constants = self.stepper.scheme.constants(c, self.dt)
        while reached < len(ends):
            more = code.run(
                whole, ready, constants, ends[reached:], rows[reached:], self._table.structure, log.structure
            )
            happened = log.structure.n
            new = log.take(told)
            if whole[n + 1] != 0 or log.structure.lost or not (more or happened):
                return None
            reached, records = reached + more, records + new
        kinds = np.flatnonzero(log.opened[1 : 1 + code.sizes["NE"]]).tolist()
        opened = Opened(tuple(kinds), float(log.opened[0]), log.opened[1 + code.sizes["NE"] :].copy())
        return Passage(whole[:n].copy(), rows, records, opened, log.structure.unresolved)

    @property
    def native(self) -> bool:
        """Are there native steps with the events in them?"""
        return not len(self._jolts) and native_events(self.stepper) is not None and self._table.fits

    def accept(self, passage: Passage) -> None:
        """Go on behind it."""
        self.opened, self.unresolved = passage.opened, passage.unresolved

    def _open(self, log: EventLog, n_e: int) -> None:
        """Tell the C what is known of loads that act for a short time."""
        log.structure.lost, log.structure.unresolved, log.opened[:] = 0, self.unresolved, 0.0
        log.opened[0], log.opened[[1 + k for k in self.opened.kinks]] = self.opened.clock, 1.0
        if len(self.opened.z):
            log.opened[1 + n_e :] = self.opened.z

    @cached_property
    def _log(self) -> EventLog:
        code = native_events(self.stepper)
        assert code is not None
        return EventLog(code)

    @cached_property
    def _table(self) -> StepTable:
        return StepTable(self.grid)

    def step_with_events(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, acts: Acts) -> bool:
        """One major step in which events may happen, in place; where one ends the run, z is the state there.

        Does one? Else it is the step that it would have been.
        """
        scheme, start, made = self.stepper.scheme, z.copy(), list[int]()
        own = scheme.layout.slice
        start[own("event_step")] = NEVER

        def noted(state: np.ndarray, dt: float, t: float, happened: list[int]) -> Acted:
            made.extend(happened)
            return acts(state, dt, t, happened)

        self._load(start, ready, c)
        z[:] = _EventStep(self, c, noted).made(int(start[1]))
        z[own("event_step")] = NEVER
        if made:
            return True
        self.run(start, ready, c, 1)
        if not passed(scheme, z[own("event_values")], start[own("event_values")]):  # not by a rounding of the end
            z[:] = start
            z[own("event_step")] = NEVER
        return False


def parts_of(grid: Breaks, steps: np.ndarray, m: Sequence[int], jolts: np.ndarray) -> np.ndarray:
    """(fields of a part, N) of broken steps (S,); m: ratios of groups; jolts: times that may give impulses."""
    parts = grid.parts(steps)
    length = within(parts.length, m)
    last = np.zeros(len(length))
    last[np.cumsum(parts.counts) - 1] = 1.0
    clocks, origin = (np.repeat(one, parts.counts) for one in (parts.clocks, grid.origins(steps + 1, parts.clocks)))
    found = [np.repeat(steps, parts.counts), parts.start, length, length / grid.dt, last, clocks, origin]
    if len(jolts):
        jolted = np.searchsorted(jolts, parts.before) < np.searchsorted(jolts, parts.after, side="right")
        found += [jolted, parts.before, parts.after]
    return np.array(found, dtype=float)


@dataclass
class _EventStep:
    """A major step whose parts end where events happen, on copies of the program's z: so every look is such a step."""

    steps: StepsWithStops
    c: np.ndarray
    acts: Acts

    def made(self, step: int) -> np.ndarray:
        """The state (whole, flat) behind the step that is loaded, or where an event ends the run."""
        own = self.steps
        z, clock, ends = own._z.copy(), 0.0, False
        self._put(z, number=step, dt_seen=own.dt, event_before=NEVER)
        for start, length, before, after in own.grid.parts(np.array([step])).each():
            z, clock, ends = self._reached(z, start, length)
            if before is not None and not ends:
                ends = self._jumped(z, before, after)
            if ends:
                break
        clock = clock if ends else own.grid.clock(step + 1)
        origin = float(own.grid.origins(np.array([step + 1]), np.array([clock]))[0])
        z[self._at("clock").stop - 1], z[self._at("origin").stop - 1] = clock, origin
        self._put(z, back=1.0, inside=1.0, waiting=0.0)
        return self._applied(z)[self._at("state")]

    def _at(self, name: str) -> slice:
        return self.steps._made.program.layout.slice(name)

    def _put(self, z: np.ndarray, **values: float) -> None:
        """Into the first places of fields."""
        for name, value in values.items():
            z[self._at(name).start] = value

    def _applied(self, z: np.ndarray) -> np.ndarray:
        self.steps._z[:] = z
        self.steps._go(1)
        return self.steps._z.copy()

    def _part(self, z: np.ndarray, start: float, length: float) -> np.ndarray:
        """A part so long [s] from a clock on [s]."""
        found, length = z.copy(), within(length, self.steps.stepper.scheme.grid.m)
        self._put(found, start=start, length=length, share=length / self.steps.dt, last=0.0, inside=1.0, waiting=1.0)
        return self._applied(found)

    def _shown(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The scheme's state, and the constants that show it."""
        scheme = self.steps.stepper.scheme
        return z[: scheme.layout.size], scheme.constants(self.c, float(z[self._at("dt_seen")][0]))

    def _set_out(self, z: np.ndarray, dt: float, clock: float) -> tuple[np.ndarray, np.ndarray]:
        """The same behind a restart."""
        made, scheme = self.steps._made, self.steps.stepper.scheme
        state, interval, inputs = z[: scheme.layout.size], float(z[self._at("dt_seen")][0]), z[self._at("inputs")]
        pushed = "push" in made.program.layout.sizes
        push = z[self._at("push")] if pushed else np.zeros(len(scheme.model.q_i))
        found = made.restart(state, scheme.constants(self.c), interval, dt, clock, push, inputs)
        return found, scheme.constants(self.c, dt)

    def _act(self, z: np.ndarray, t: float, happened: list[int]) -> bool:
        """What events do at t [s]; inputs change at the next restart."""
        scheme, own = self.steps.stepper.scheme, self.steps._own_inputs
        state = z[: scheme.layout.size].copy()
        state[own] = z[self._at("inputs")]
        ends, push = self.acts(state, float(z[self._at("dt_seen")][0]), t, happened)
        z[self._at("push")] += push
        z[self._at("inputs")], state[own] = state[own], z[: scheme.layout.size][own]
        z[: scheme.layout.size] = state
        return ends

    def _reached(self, z: np.ndarray, start: float, length: float) -> tuple[np.ndarray, float, bool]:
        """(z, clock, does an event end the run?) so far [s] from a clock on, through the events on the way; a part ends
        where a cool-down is over.
        """
        scheme, end = self.steps.stepper.scheme, start + length
        while True:
            quiet = quiet_until(scheme, z).copy()
            asleep = quiet > start
            nearly = end - JUMP_AT_STEP * self.steps.dt
            wakes = min((float(one) for one in quiet[asleep] if one < nearly), default=None)
            goal = length if wakes is None else wakes - start
            found = self._part(z, start, goal)
            at = self._looks(z, start, goal, found)
            bracket = self._bracket(z, start, goal, found, asleep, at)
            if bracket is None:
                if wakes is None:
                    return found, end, False
                z, start, length = found, wakes, end - wakes
                continue

            def ask(old: np.ndarray, new: np.ndarray, asleep: np.ndarray = asleep) -> list[int]:
                return passed(scheme, old, new, asleep)

            low, high = ((s, at(s)) for s in bracket)
            s, before = first_passage(ask, at, low, high, goal)
            clock = start + s
            z, happened = self._part(z, start, clock - start), ask(before, at(s))
            if set(self.steps.opened.kinks) & set(happened):
                self._resolve(z, clock)
            ends, start, length = self._act(z, clock, happened), clock, end - clock
            self.steps.opened = Opened(tuple(k for k in happened if are_kinks(scheme)[k]), clock, z.copy())
            if ends or length <= JUMP_AT_STEP * self.steps.dt:
                return z, clock, ends

    def _resolve(self, there: np.ndarray, clock: float) -> None:
        """What steps err through which a load acts for less than two of them, by four parts of that time: steps of
        other lengths end where it begins and ends, too, so that none of them shows it.
        """
        opened, steps = self.steps.opened, self.steps
        length = clock - opened.clock
        if not 0.0 < length < RESOLVED_STEPS * steps.dt or steps.breaks_between(opened.clock, clock):
            return
        z = opened.z
        for k in range(RESOLVING_PARTS):
            z = self._part(z, opened.clock + k * length / RESOLVING_PARTS, length / RESOLVING_PARTS)
        steps.note_unresolved(self._rates(there), self._rates(z))

    def _rates(self, z: np.ndarray) -> np.ndarray:
        """q_i_dot (n_i,) that a state shows."""
        state, constants = self._shown(z)
        return np.asarray(self.steps.stepper.scheme.observer(z=state, c=constants)["q_i_dot"]).ravel()

    def _looks(self, z: np.ndarray, start: float, length: float, found: np.ndarray) -> Callable[[float], np.ndarray]:
        """s [s] -> values of events (n_e,) on the way to `found`, so far away [s]: by a step that ends there."""
        scheme = self.steps.stepper.scheme
        known = {
            0.0: event_values(scheme, *self._set_out(z, length, start)),
            length: event_values(scheme, *self._shown(found)),
        }

        def at(s: float) -> np.ndarray:
            if s not in known:
                known[s] = event_values(scheme, *self._shown(self._part(z, start, s)))
            return known[s]

        return at

    def _bracket(
        self,
        z: np.ndarray,
        start: float,
        length: float,
        found: np.ndarray,
        asleep: np.ndarray,
        at: Callable[[float], np.ndarray],
    ) -> tuple[float, float] | None:
        """Where on the way to `found`, so far away [s], an event that is not asleep happens first [s].

        What happens between the two places is seen from their values: a kink behind the first event is left for later.
        """
        scheme = self.steps.stepper.scheme
        kinks = are_kinks(scheme)
        bracket = (0.0, length) if passed(scheme, at(0.0), at(length), asleep) else None
        if kinks.all():
            return bracket
        slopes = event_slopes(scheme, *self._set_out(z, length, start))
        end = event_slopes(scheme, *self._shown(found))
        open_ = unsure(ca.DM(at(0.0)), ca.DM(slopes), ca.DM(at(length)), ca.DM(end), length)
        if not (np.asarray(open_).ravel() * ~(asleep | kinks)).any():
            return bracket
        of_events = first_bracket(
            lambda a, b: bool(passed(scheme, a, b, asleep | kinks)),
            lambda s: np.array([at(float(one)) for one in s]),
            0.0,
            length,
            agreements=1,
            most=MOST_PLACES_OF_STEP,
        )
        first = length if of_events is None else of_events[0]
        return (0.0, first) if passed(scheme, at(0.0), at(first), asleep | ~kinks) else of_events

    def _jumped(self, z: np.ndarray, before: float, after: float) -> bool:
        """What jumps between two clocks [s]: an impulse, and events that pass zero just there. Does one end the run?"""
        scheme, steps = self.steps.stepper.scheme, self.steps
        state, constants = self._shown(z)
        if len(steps._jolts) and ((steps._jolts >= before) & (steps._jolts <= after)).any():
            n = len(scheme.model.q_i)
            dt = float(z[self._at("dt_seen")][0])
            found = _impulse(steps.stepper)(state, scheme.constants(self.c), dt, before, after)
            z[self._at("push")] = found[:n]
            if found[n + 1 :].any():
                steps.impulses[(before + after) / 2] = Impulse(float(found[n]), found[n + 1 :])
        there = event_values(scheme, *self._set_out(z, float(z[self._at("dt_seen")][0]), after))
        happened = passed(scheme, event_values(scheme, state, constants), there, quiet_until(scheme, z) > before)
        if not happened:
            return False
        clock = float(z[0])
        z[0] += after - before  # what holds or lets go is decided by the loads behind the jump
        ends, z[0] = self._act(z, (before + after) / 2, happened), clock
        return ends


def _impulse(stepper: Stepper) -> Callable[..., np.ndarray]:
    scheme = stepper.scheme

    def build() -> ca.Function:
        z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        dt, before, after = (ca.SX.sym(name) for name in ("dt", "before", "after"))
        found = impulse_there(scheme, z, c, dt, before, after)
        return ca.Function("impulse_there", [z, c, dt, before, after], [ca.densify(one) for one in found])

    return direct(scheme, "impulse_there", build)
