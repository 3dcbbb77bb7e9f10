"""Turns of a differentiated run: restarts where steps of another length follow, loads jump, events act, inputs change.

The restart is that of a run (`restarted`), as a program that is differentiated like a step. Where at a time T rates go
from v- to v+ and accelerations from a- to a+, a state that goes on from there has besides

    dq = (v- - v+) dT,    dv = (a- - a+) dT                                      (saltation)

which is what the saltation matrix does to a tangent. dT is data where a load jumps. An event happens where g(q, q', t,
p) = 0 and sets w = A(q, q', t, p), so that with the rates g' and A' along the motion dT = -dg / g', dw = dA + A' dT.
Impacts, and what holds from there on, add r to the rates (impacts.py), so that dv has dr + r' dT, too. Which event it
is, what is struck, and the modes behind it are data. A stage measures g, g', a-, a+ and r, which do not count as
differentiated; the next one adds terms such as (a- - a+) (g measured - g) / g', whose value is zero and whose
derivative is dv.
"""

from __future__ import annotations

from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, NoResult
from runtime.engine.derivatives import Active, LaneArrays, Recorder, TangentCode
from runtime.engine.native import NativeProgram
from runtime.engine.program import Fields, Layout, Program, Sequence, make_stage
from runtime.gradients.course import EVENT, EventCrossing, Turn
from runtime.gradients.impacts import sizes, thrown
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.started_run import StartedRun
from runtime.schemes.switching.stop_program import loop_guess, restarted, with_steps
from runtime.schemes.switching.watched import NEVER, held_kinks, values_at, watched_events

IMPACT_MISMATCH = 1e-6  # of the largest rate: impacts at one time that are none after another
TURN_DATA = (
    "dt_before",
    "dt",
    "share",
    "clock",
    "before",
    "after",
)  # of a turn, see there; share: dt over that of the grid


class TurnProgram:
    """Turns of an observed program of one kind (see Turn.kind), with `width` directions in lanes.

    Fields of z besides the state of the scheme and the data: moved, zero, of which dT is the derivative; held: numbers
    of inputs, those that are set by holds; of an event acts, one for the one that counts; push, rows, struck, see
    EventCrossing; value, rate, ends, begins, thrown: g, g', a-, a+, r as measured; ready: what the step program reads
    behind it.
    """

    def __init__(self, program: ObservedProgram, kind: str, width: int, wait: bool) -> None:
        self._of, self._scheme, self._kind = program, program.scheme, kind
        scheme, active = program.scheme, program.active
        if scheme.multistep and scheme.charts.size:
            raise ArgumentError(
                f"scheme of model {scheme.model.name}",
                "starts anew where forces jump, which is not differentiated for turns of free bodies",
                "take a scheme of one step, such as exponential or rk4",
            )
        n_w = scheme.layout.sizes.get("inputs", 0)
        n_i, acts = len(scheme.model.q_i), len(watched_events(scheme)) if kind == EVENT else 0
        self._struck = kind == EVENT and bool(scheme.model.element_modes.size)
        rows, stops = sizes(scheme.model) if self._struck else (0, 0)
        own = {"state": scheme.layout.size, **dict.fromkeys(TURN_DATA, 1), "moved": 1, "holds": n_w, "held": n_w}
        own |= {"acts": acts, "push": n_i if self._struck else 0, "rows": rows, "struck": stops, "value": 1, "rate": 1}
        own |= {"ends": n_i, "begins": n_i, "thrown": n_i if self._struck else 0, "ready": active.c_size}
        self.layout = Layout(own)
        at = self.layout.slice
        self._rows = [row for row in active.z if row < scheme.layout.size]
        ready = [at("ready").start + row for row in active.c]
        seeds = [at("moved").start, *range(*at("held").indices(self.layout.size))]
        self._active = Active((*self._rows, *seeds, *ready), active.c, self.layout.size, active.c_size)
        self._own = [k for k, row in enumerate(active.z) if row < scheme.layout.size]
        self._seeds, self._ready = slice(len(self._rows), len(self._rows) + len(seeds)), len(self._rows) + len(seeds)
        self._width, self._wait = width, wait

    # ---- what a turn does -----------------------------------------------------------------------------------

    def take(self, turn: Turn, z: np.ndarray, started: StartedRun) -> np.ndarray:
        """A turn at z (n_z,), in place; what steps behind it read."""
        own = self._given(turn, z, started)
        self._plain.run(own, started.ready, 1)
        return self._taken(turn, own, z, started)

    def along(
        self, turn: Turn, arrays: LaneArrays, started: StartedRun, grid: np.ndarray, first: int, here: int
    ) -> None:
        """The same in lanes, of directions first ... first + here; grid: constants in lanes of steps of the grid."""
        n, n_z, n_c, code = self.layout.size, len(started.z), len(started.ready), self._tangents
        own = LaneArrays(n + len(self._active.z), 0, code.width)
        own.c, moving, seeds = grid, own.z[n:], np.zeros((self._seeds.stop - self._seeds.start, here))
        own.z[:n] = self._given(turn, arrays.z[:, 0], started)[:, None]
        moving[: len(self._rows)] = arrays.z[[n_z + k for k in self._own]]
        if turn.jump is not None:
            seeds[0] = turn.jump.moves @ started.slopes[: len(turn.jump.moves), first : first + here]
        for row, place in self._seeded(turn):
            if first <= place < first + here:
                seeds[row, place - first] = 1.0
        moving[self._seeds, :here] = seeds
        code.run(own, 1)
        ready, z = self._taken(turn, own.z[:n, 0].copy(), arrays.z[:n_z, 0].copy(), started), arrays.z
        z[: self._scheme.layout.size] = own.z[: self._scheme.layout.size]
        z[0], z[1] = turn.t0, turn.n
        z[[n_z + k for k in self._own]] = moving[: len(self._rows)]
        arrays.c[:] = grid
        if turn.goes_on:
            arrays.c[:n_c], arrays.c[n_c:] = ready[:, None], moving[self._ready :]

    def record(self, turn: Turn, z: np.ndarray, started: StartedRun) -> tuple[np.ndarray, np.ndarray]:
        """`take`, and the tape for the way back."""
        own, tape = self._given(turn, z, started), np.zeros(self._recorder.records + 1)
        self._recorder.record(own, started.ready, tape, 1)
        return self._taken(turn, own, z, started), tape

    def back(
        self,
        turn: Turn,
        tape: np.ndarray,
        adjoint: np.ndarray,
        ready: np.ndarray,
        started: StartedRun,
        held: np.ndarray,
    ) -> np.ndarray | float:
        """The adjoint behind a turn becomes that before it, in place; the derivative by p (n_p,) through its time.

        ready: the adjoint of what steps behind it read; held (n,): takes that of what inputs are set to.
        """
        bar, first, last = np.zeros(self._active.size), len(self._of.active.z), len(self._active.z)
        bar[: len(self._rows)], bar[self._ready : last], bar[last:] = adjoint[self._own], ready, adjoint[first:]
        self._recorder.reverse(bar, started.ready, tape, 1)
        adjoint[self._own], adjoint[first:] = bar[: len(self._rows)], bar[last:]
        for row, place in self._seeded(turn):
            held[place] += bar[self._seeds][row]
        return turn.jump.moves * bar[self._seeds.start] if turn.jump is not None else 0.0

    def _given(self, turn: Turn, z: np.ndarray, started: StartedRun) -> np.ndarray:
        """z of the program."""
        given, at, steps = np.zeros(self.layout.size), self.layout.slice, self._scheme.layout.size
        sides = (turn.jump.before, turn.jump.after) if turn.jump is not None else (0.0, 0.0)
        share = turn.dt / started.ready[self._scheme.model.c_size]
        given[:steps] = z[:steps]
        given[steps : steps + len(TURN_DATA)] = turn.dt_before, turn.dt, share, turn.clock, *sides
        for hold in turn.holds:
            row = hold.row - self._scheme.layout.slice("inputs").start
            given[at("holds")][row], given[at("held")][row] = 1.0, hold.number(started.values)
        if self._kind == EVENT and turn.crossing is not None:
            given[at("acts")][turn.crossing.event] = 1.0
            for name in ("push", "rows", "struck") if self._struck else ():
                given[at(name)] = getattr(turn.crossing, name)
        return given

    def _seeded(self, turn: Turn) -> list[tuple[int, int]]:
        """(row of the seeds, place among what is differentiated by) of inputs that are set."""
        start = self._scheme.layout.slice("inputs").start if turn.holds else 0
        return [(1 + hold.row - start, hold.place) for hold in turn.holds if hold.place >= 0]

    def _taken(self, turn: Turn, own: np.ndarray, z: np.ndarray, started: StartedRun) -> np.ndarray:
        """Into z; what steps read. Raises NoResult where an event grazes zero, or impacts follow one another."""
        if self._kind == EVENT and turn.crossing is not None:
            self._check(turn.crossing, own)
        z[: self._scheme.layout.size] = own[: self._scheme.layout.size]
        z[0], z[1] = turn.t0, turn.n
        return own[self.layout.slice("ready")].copy() if turn.goes_on else started.ready

    def _check(self, crossing: EventCrossing, own: np.ndarray) -> None:
        rate, at = float(own[self.layout.slice("rate")][0]), self.layout.slice
        event = watched_events(self._scheme)[crossing.event]
        who = f"event {event.name} of model {self._scheme.model.name}"
        if abs(rate) <= crossing.least:
            raise NoResult(
                who,
                f"grazes zero at t = {crossing.clock:.6g} s (rate {rate:.3g} 1/s): its time has no derivative",
                "let it pass zero faster, or leave out of `by` what moves it",
            )
        if np.abs(own[at("thrown")] - own[at("push")]).max(initial=0.0) > IMPACT_MISMATCH * (
            1 + np.abs(crossing.push).max(initial=0)
        ):
            raise NoResult(
                who,
                f"leads to several impacts at t = {crossing.clock:.6g} s: which have no derivative",
                "start slightly away from that motion, so that the impacts happen at different times",
            )

    # ---- its stages, and their code -------------------------------------------------------------------------

    @cached_property
    def _plain(self) -> NativeProgram:
        return NativeProgram(self._program, wait=self._wait)

    @cached_property
    def _tangents(self) -> TangentCode:
        return TangentCode(self._program, self._active, self._width, self._wait)

    @cached_property
    def _recorder(self) -> Recorder:
        return Recorder(self._program, self._active, self._wait)

    @cached_property
    def _program(self) -> Program:
        parts = [("measured", self._measured)] if self._kind else []
        stages = [*parts, ("turned", self._turned)]
        return Sequence(tuple(make_stage(name, self.layout, self._active.c_size, body) for name, body in stages))

    def _observed(self, z: Fields, c: ca.SX) -> tuple[Fields, ca.SX, dict[str, ca.SX]]:
        """The scheme's fields, the constants that show them, and what events are there."""
        fields = self._scheme.layout.unpack(z["state"])
        c = with_steps(self._scheme, z["state"], c[: self._scheme.c_size], z["dt_before"])
        if self._kind != EVENT:
            return fields, c, {}
        observed = values_at(self._scheme, z["state"], self._scheme.equations(c))
        for name in ("events", "slopes"):  # of the event that counts
            values = zip(ca.vertsplit(z["acts"]), ca.vertsplit(observed[name]), strict=True)
            observed[name] = sum((ca.if_else(acts, value, 0) for acts, value in values), ca.SX(0))
        return fields, c, observed

    def _motion(self, z: Fields, fields: Fields, c: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
        """q_i, their rates, and a guess of the loop unknowns."""
        if not self._scheme.multistep:
            return fields["x"], fields["v"], fields["loop"]
        shown = self._scheme.observer(z=z["state"], c=c)
        return shown["q_i"], shown["q_i_dot"], loop_guess(self._scheme, shown["q_d"])

    def _measured(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """The event and its rate, the accelerations on both sides, and what is added to the rates."""
        fields, c, observed = self._observed(z, c)
        t = (observed["t"], observed["t"]) if observed else (z["before"], z["after"])
        w = (fields.get("inputs"), self._inputs(z, fields, observed, ca.SX(0)))
        q_i, v, loop = self._motion(z, fields, c)
        rates, a = (v, v + z["push"] if self._struck else v), []
        sides = self._sides(z, observed)
        for clock, inputs, rate, side in zip(t, w, rates, sides, strict=True):
            held = {**fields, **({} if inputs is None else {"inputs": inputs}), **side}
            equations = self._scheme.equations(c, held)
            a.append(equations.accelerations(equations.close_well(q_i, loop, clock), rate))
        found = {"ends": a[0], "begins": a[1]}
        if self._struck:
            found["thrown"] = thrown(self._scheme.equations(c, fields), (q_i, loop, t[0]), v, z["rows"], z["struck"])
        return found | {"value": observed["events"], "rate": observed["slopes"]} if observed else found

    def _sides(self, z: Fields, observed: dict[str, ca.SX]) -> tuple[dict[str, ca.SX], dict[str, ca.SX]]:
        """Of the jump by the motion that counts, before and behind the turn; nothing where none does."""
        held = held_kinks(self._scheme)
        if not observed or not held:
            return {}, {}
        side = NEVER * ca.sign(observed["slopes"]) * z["acts"][held]
        return {"side": -side}, {"side": side}

    def _inputs(self, z: Fields, fields: Fields, observed: dict[str, ca.SX], moved: ca.SX) -> ca.SX | None:
        """The inputs (n_w,) behind the turn, whose time moves by so much; None where there are none."""
        if "inputs" not in fields:
            return None
        found, names, events = ca.SX(fields["inputs"]), self._scheme.model.signals.names, watched_events(self._scheme)
        sets = [(k, name) for k, event in enumerate(events) for name in event.sets] if observed else []
        for j, (k, name) in enumerate(sets):
            value, place = observed["actions"][j] + observed["drifts"][j] * moved, names.index(name)
            found[place] = ca.if_else(z["acts"][k], value, found[place])
        return ca.if_else(z["holds"], z["held"], found)

    def _turned(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """The restart, and what the step program reads behind it."""
        fields, shown, observed = self._observed(z, c)
        scheme, end, c = self._scheme, self._scheme.model.c_size, c[: self._scheme.c_size]
        moved = (z["value"] - observed["events"]) / z["rate"] if observed else z["moved"]
        push, shift = (z["ends"] - z["begins"]) * moved if self._kind else None, ca.SX(0)
        if push is not None and self._struck:
            q_i, v, loop = self._motion(z, fields, shown)
            place = q_i + v * moved, loop, observed["t"] + moved
            added = thrown(scheme.equations(shown, fields), place, v + z["ends"] * moved, z["rows"], z["struck"])
            push, shift = push + z["push"] + (added - z["thrown"]), -z["push"] * moved
        inputs = self._inputs(z, fields, observed, moved)
        found = restarted(scheme, z["state"], c, z["dt_before"], z["dt"], z["clock"], push, inputs, shift)
        return {"state": found, "ready": self._of.prepared.constants(ca.vertcat(c[:end], c[end:] * z["share"]))}
