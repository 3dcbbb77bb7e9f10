"""Steps with stops on the way, as one program: whole steps, and steps that are made in parts, which are data of z.

An application is one major step. One without stops is the scheme's own step. One with stops is made of parts, each from
its clock by a step of its own length: a restart, what the step program reads for that length, the step. Behind the last
part the state is restarted on the grid, where events are looked for. z knows the next KNOWN parts; where they run out
within a step, an application ends there, and goes on when whoever runs it has given more.
"""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Mapping
from threading import Lock
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np

from runtime.engine.choose import choose_engine
from runtime.engine.prepare import Prepared
from runtime.engine.program import Call, Fields, Layout, Program, Sequence, Until, make_stage
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.breaks import Breaks, within
from runtime.schemes.switching.restart import restarted, with_steps
from runtime.schemes.switching.watched import NEVER, flagged, values_at, watches

KNOWN = 16  # parts
FAR = 128  # whole steps that are worth a call of the step program alone
CHUNK = 256  # steps with stops whose parts are looked up at once
# of a part: the step that it is in, its clock [s] and length [s], the same over a major step, is it the last one of the
# step?, and of that one the clock from which steps go on [s], and t0 for it
PART = ("step", "start", "length", "share", "last", "clock", "origin")
_LOCK = Lock()
_KEPT: WeakKeyDictionary[Prepared, StopProgram] = WeakKeyDictionary()  # shared by steppers of other steps


class StopProgram:
    """The program of a stepper, compiled. Fields of its z besides `state`, the stepper's, and the parts (KNOWN each):

    waiting: how many are known; t0: of the grid [s]; whole, parts, back: what is to be done; inside: are parts of the
    step made already?; number: of the step; dt_seen: steps that show the state; ready: what the step program reads for
    a part; event_before: in which step an event was seen until now.
    """

    def __init__(self, stepper: Stepper) -> None:
        self.scheme, self._prepared = stepper.scheme, stepper.prepared
        self.n_ready = int(stepper.prepared.constants.size1_out(0))
        flags = ("waiting", "t0", "whole", "parts", "back", "inside", "number", "dt_seen", "event_before")
        sizes = {"state": stepper.prepared.z_size, **dict.fromkeys(flags, 1), **dict.fromkeys(PART, KNOWN)}
        self.layout = Layout({**sizes, "ready": self.n_ready})
        self.c_size = self.n_ready + self.scheme.c_size
        program = self._program(stepper.program)
        self.engine = choose_engine(stepper.requested, program, self.layout.size, self.c_size, stepper.waits)

    def constants(self, c: np.ndarray, ready: np.ndarray, dt: float) -> np.ndarray:
        """What it reads: `ready` of whole steps dt [s], and the constants of the scheme for c (c_size,)."""
        return np.concatenate([ready, self.scheme.constants(c, dt)])

    def _program(self, step: Program) -> Program:
        flag = {name: self.layout.slice(name).start for name in ("whole", "parts", "back")}
        whole = Sequence((self._applied("whole_", step, None), self._stage("counted", self._counted)))
        part = (
            self._stage("set_out", self._set_out),
            self._applied("part_", step, "ready"),
            self._stage("next", _next),
        )
        back = Until(self._stage("to_grid", self._to_grid), flag["back"], 1, usual=1)
        parts = Until(Sequence((*part, back)), flag["parts"], KNOWN, usual=1)
        return Sequence((self._stage("plan", self._plan), Until(whole, flag["whole"], 1, usual=1), parts))

    def _stage(self, name: str, body) -> Call:  # type: ignore[no-untyped-def]
        return make_stage(name, self.layout, self.c_size, body)

    def _applied(self, prefix: str, program: Program, ready: str | None) -> Program:
        """A program of the stepper on `state`, with what it reads in a field, or among the constants."""

        def changed(stage: ca.Function) -> ca.Function:
            def body(z: Fields, c: ca.SX) -> dict[str, ca.SX]:
                return {"state": stage(z["state"], c[: self.n_ready] if ready is None else z[ready])}

            return self._stage(prefix + stage.name(), body).stage

        return program.map(changed)  # `state` comes first, so flags are where they were

    def _own(self, z: Fields) -> tuple[ca.SX, Fields]:
        """The scheme's part of the state, whole and by fields."""
        state = z["state"][: self.scheme.layout.size]
        return state, self.scheme.layout.unpack(state)

    def _changed(self, z: Fields, state: ca.SX) -> ca.SX:
        return ca.vertcat(state, z["state"][state.numel() :])

    def _plan(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """Is there a stop in this step?"""
        state, fields = self._own(z)
        inside = z["inside"] > 0
        known = ca.logic_and(z["waiting"] > 0, ca.logic_or(inside, z["step"][0] <= fields["n"]))
        begins = ca.logic_and(known, ca.logic_not(inside))
        found = {
            "parts": known,
            "whole": ca.logic_not(ca.logic_or(known, inside)),
            "number": ca.if_else(inside, z["number"], fields["n"]),
            "dt_seen": ca.if_else(inside, z["dt_seen"], self._dt(c)),
        }
        if watches(self.scheme):
            found["event_before"] = ca.if_else(begins, fields["event_step"], z["event_before"])
            event_step = ca.if_else(begins, NEVER, fields["event_step"])
            found["state"] = self._changed(z, self.scheme.layout.pack({**fields, "event_step": event_step}))
        return found

    def _dt(self, c: ca.SX) -> ca.SX:
        return c[self.n_ready + self.scheme.model.c_size]

    def _counted(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """Behind a stop the first step runs on the clock that it was given; the next ones on the grid."""
        state, fields = self._own(z)
        return {"whole": ca.SX(0), "state": self._changed(z, self.scheme.layout.pack({**fields, "t0": z["t0"]}))}

    def _set_out(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        state, _ = self._own(z)
        c, length = c[self.n_ready :], z["length"][0]
        end = self.scheme.model.c_size
        ready = self._prepared.constants(ca.vertcat(c[:end], c[end:] * z["share"][0]))
        start = restarted(self.scheme, state, c, z["dt_seen"], length, z["start"][0])
        return {"state": self._changed(z, start), "ready": ready}

    def _to_grid(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """The state on the grid; the part behind it is gone from z, its clock and t0 are in the last places."""
        state, _ = self._own(z)
        dt, c = self._dt(c), c[self.n_ready :]
        fields = self.scheme.layout.unpack(restarted(self.scheme, state, c, z["dt_seen"], dt, z["clock"][KNOWN - 1]))
        fields |= {"t0": z["origin"][KNOWN - 1], "n": z["number"] + 1}
        if watches(self.scheme):
            fields = self._looked(fields, z["event_before"], c, dt)
        return {"state": self._changed(z, self.scheme.layout.pack(fields)), "back": ca.SX(0)}

    def _looked(self, fields: Fields, event_before: ca.SX, c: ca.SX, dt: ca.SX) -> Fields:
        """Events are looked for from here on; event_step is the first step in which one was seen."""
        state = self.scheme.layout.pack(fields)
        seen = values_at(self.scheme, state, self.scheme.equations(with_steps(self.scheme, state, c, dt), fields))
        by_jump = flagged(self.scheme, fields, fields["event_values"], seen["events"], seen["t"])
        sooner = ca.logic_or(fields["event_step"] < NEVER, by_jump)
        return {
            **fields,
            "event_values": seen["events"],
            "event_change": ca.SX.ones(seen["events"].numel()) * NEVER,
            "event_slopes": seen["slopes"],
            "event_step": ca.if_else(sooner, ca.fmin(event_before, fields["n"]), event_before),
        }


def _next(z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
    """A part is made: the next ones move up, and it comes last."""
    closed, waiting = z["last"][0], z["waiting"] - 1
    return {
        **{name: ca.vertcat(z[name][1:], z[name][0]) for name in PART},
        "dt_seen": z["length"][0],
        "waiting": waiting,
        "back": closed,
        "inside": 1 - closed,
        "parts": ca.logic_and(waiting > 0, closed <= 0),
    }


def stop_program(stepper: Stepper) -> StopProgram:
    """Made once for a stepper and those of the same programs with other steps, which are data."""
    with _LOCK:
        if stepper.prepared not in _KEPT:
            _KEPT[stepper.prepared] = StopProgram(stepper)
        return _KEPT[stepper.prepared]


class StepsWithStops:
    """Runs major steps of a grid, with its stops."""

    def __init__(self, stepper: Stepper, grid: Breaks) -> None:
        self._stepper, self._grid, self._program = stepper, grid, stop_program(stepper)
        layout = self._program.layout
        self._z, at = np.zeros(layout.size), layout.slice
        self._state = self._z[at("state")]
        self._inside, self._waiting, self._number = (at(name).start for name in ("inside", "waiting", "number"))
        self._z[at("t0")] = grid.t0
        self._known = self._z[at(PART[0]).start : at(PART[-1]).stop].reshape(len(PART), KNOWN)
        self._parts, self._steps = np.zeros((len(PART), 0)), list[int]()  # and the step that each is in
        self._numbers, self._first, self._behind = [0], 0, 0  # of the broken ones; the next one that is not looked up
        self._far = list[int]()  # broken steps with so many whole ones behind them
        self._constants, self._read = np.zeros(self._program.c_size), b""

    def run(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, end: int) -> None:
        """Advance z (n_z,) in place to step `end`; ready, c (c_size,): of the stepper and of the model."""
        if (read := c.tobytes() + ready.tobytes()) != self._read:
            self._constants[:], self._read = self._program.constants(c, ready, self._grid.dt), read
            self._go = self._program.engine.bound(self._z, self._constants)
        whole, step, cursor = self._z, int(z[1]), -1
        self._state[:], whole[self._inside] = z, 0.0
        while step < end:
            if whole[self._inside] <= 0 and not 0 <= cursor < len(self._steps):
                cursor = self._place(step)
            behind = min(cursor + KNOWN, len(self._steps))
            ahead = (self._steps[cursor] if cursor < behind else self._behind) - step
            if min(ahead, end - step) >= FAR and self._state[0] == self._grid.t0:
                self._stepper.run(self._state, ready, min(ahead, end - step))
                step = int(self._state[1])
                continue
            self._known[:, : behind - cursor] = self._parts[:, cursor:behind]
            whole[self._waiting] = behind - cursor
            # what is not known is not passed: a step of which some parts are known ends by itself where they run out
            until = self._steps[behind] if behind < len(self._steps) else self._behind
            partly = cursor < behind and self._steps[behind - 1] == until
            far = bisect_left(self._far, step)
            until = min(until + partly, self._far[far] + 2 if far < len(self._far) else end, end)
            self._go(max(1, until - step))
            cursor = behind - int(whole[self._waiting])
            step = int(whole[self._number] if whole[self._inside] > 0 else self._state[1])
        z[:] = self._state

    def _place(self, step: int) -> int:
        """Where the parts of the first broken step from this one on are among those that were looked up."""
        grid, number = self._grid, self._grid.number(step)
        if number == len(grid.broken) and self._behind == sys.maxsize:  # none follows
            return len(self._steps)
        if not self._first <= number < self._first + len(self._numbers) - 1:
            steps = np.array(grid.broken[number : number + CHUNK], dtype=int)
            self._first, self._parts = number, self._looked_up(steps)
            self._steps = self._parts[0].astype(int).tolist()
            self._numbers = [*np.searchsorted(self._steps, steps).tolist(), len(self._steps)]
            following = number + len(steps)
            self._behind = grid.broken[following] if following < len(grid.broken) else sys.maxsize
            gaps = np.diff(self._steps, append=self._behind)
            self._far = [step for step, gap in zip(self._steps, gaps.tolist(), strict=True) if gap > FAR]
        return self._numbers[number - self._first]

    def _looked_up(self, steps: np.ndarray) -> np.ndarray:
        """(len(PART), N) of broken steps (S,)."""
        if not len(steps):
            return np.zeros((len(PART), 0))
        grid, parts = self._grid, self._grid.parts(steps)
        length = within(parts.length, self._stepper.scheme.grid.m)
        last = np.zeros(len(length))
        last[np.cumsum(parts.counts) - 1] = 1.0
        clocks, origin = (
            np.repeat(one, parts.counts) for one in (parts.clocks, grid.t0 + (parts.clocks - grid.times(steps + 1)))
        )
        return np.array([np.repeat(steps, parts.counts), parts.start, length, length / grid.dt, last, clocks, origin])
