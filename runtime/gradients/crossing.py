"""A broken step of a differentiated run: parts with steps of their own, and the jumps between them.

Where accelerations jump from a- to a+ at a time T(p), positions and rates are continuous, and a state that goes on
from there has dv = (a- - a+) dT besides what it has from before (the saltation matrix of a jump in time). Schemes that
remember earlier steps start anew at each part, as in a run.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.tape import shared
from runtime.engine.native import NativeProgram
from runtime.gradients.course import Broken, EventPassage, Hold, Jump, Stop
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.start_of_run import Begun
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.breaks import within
from runtime.schemes.switching.restart import Restart, loop_guess, remembers, started_anew
from runtime.schemes.switching.watched import values_at


@dataclass(frozen=True)
class Handover:
    """From one part of a step to the next: the steps of both (groups,) [s], the clock [s], the jump there if any.

    lengths: of the major steps [s], where a run crosses by lists. goes_on: is a step made from there? The last turn
    leads back to the grid. holds: inputs that change there. passage: of events. kept: does the state stay as it is?
    """

    before: np.ndarray
    after: np.ndarray
    clock: float
    jump: Jump | None
    goes_on: bool
    holds: tuple[Hold, ...] = ()
    passage: EventPassage | None = None
    lengths: tuple[float, float] | None = None
    kept: bool = False


@dataclass(frozen=True)
class Taken:
    """A turn at a state z (n_s,), the scheme's part, and a clock [s].

    gap (n_i,): accelerations before the jump less those after it; w (n_w,): the inputs behind the turn. acted: what an
    event did there.
    """

    turn: Handover
    z: np.ndarray
    clock: float
    gap: np.ndarray
    w: np.ndarray
    acted: Acted | None = None


class JumpCrossing:
    """Broken steps of a program whose grid of steps begins at t0 [s]."""

    def __init__(self, program: ObservedProgram, t0: float) -> None:
        self._program, self._scheme, self._t0 = program, program.scheme, t0
        self._n_s, self._steps = self._scheme.layout.size, np.array(self._scheme.grid.h)
        self._own = [k for k, row in enumerate(program.active.z) if row < self._n_s]
        self._rows = [program.active.z[k] for k in self._own]
        self._v = self._scheme.layout.slice("v") if "v" in self._scheme.layout.sizes else slice(0, 0)
        self._w = self._scheme.layout.slice("inputs") if self._scheme.model.inputs else slice(0, 0)
        self._events = ActingEvents(self._scheme)
        self.remembers = remembers(self._scheme)
        self._anew = StartsAnew(self._scheme, self.remembers)
        if self.remembers and self._scheme.charts.size:
            raise ArgumentError(
                f"scheme of model {self._scheme.model.name}",
                "starts anew where forces jump, which is not differentiated for turns of free bodies",
                "take a scheme of one step, such as exponential or rk4",
            )

    def turns(self, broken: Broken) -> list[Handover]:
        """To each part of a broken step, and back to the grid."""
        found, before, last = [], self._steps, float(self._steps[0])
        if broken.whole:
            start, jump = broken.parts[0].start, broken.parts[0].jump
            begins = Handover(before, before, start, jump, True, kept=True)
            return [begins, Handover(before, before, broken.clock, None, False, kept=True)]
        by_python = broken.passage is not None or any(part.passage is not None for part in broken.parts)

        def lengths(of: float) -> tuple[float, float] | None:
            return None if by_python else (last, of)

        for part in broken.parts:
            length = within(part.length, self._scheme.grid.m)
            after = self._steps * (length / self._steps[0])
            found.append(
                Handover(before, after, part.start, part.jump, True, passage=part.passage, lengths=lengths(length))
            )
            before, last = after, length
        return [
            *found,
            Handover(
                before,
                self._steps,
                broken.clock,
                None,
                False,
                passage=broken.passage,
                lengths=lengths(float(self._steps[0])),
            ),
        ]

    def hold(self, holds: tuple[Hold, ...]) -> Handover:
        """On the grid, with other inputs from there on."""
        return Handover(self._steps, self._steps, 0.0, None, False, holds)

    def take(self, turn: Handover, z: np.ndarray, begun: Begun) -> Taken:
        """A turn at z (n_z,), in place."""
        own, p, n = z[: self._n_s].copy(), self._p(begun), float(z[1])
        clock, w = turn.clock, own[self._w].copy()
        for one in turn.holds:
            clock, w[one.row - self._w.start] = float(z[0]) + n * self._steps[0], one.number(begun.values)
        gap = np.zeros(len(self._scheme.model.q_i))
        if turn.jump is not None and turn.jump.moves.any():
            before, after = turn.jump.before, turn.jump.after
            gap = np.asarray(self._anew.gap(own, p, turn.before, before, after)).ravel()
        acted = None
        if turn.passage is not None and turn.passage.event >= 0:
            acted = self._events.act(turn.passage, own, p, turn.before)
            w = acted.w
        taken = Taken(turn, own, clock, gap, w, acted)
        if turn.kept:
            if turn.goes_on:
                z[0] = self._t0 + (clock - (self._t0 + n * self._steps[0]))
            return taken
        if self.remembers:
            z[: self._n_s] = self._restarted(taken, begun)
        elif acted is not None:
            z[: self._n_s][self._w] = w
        if not turn.holds:
            z[0], z[1] = clock, 0.0
        return taken

    def run(self, stepping: NativeProgram, z: np.ndarray, broken: Broken, begun: Begun) -> None:
        """A broken step of z (n_z,), in place."""
        for turn in self.turns(broken):
            self.take(turn, z, begun)
            if turn.goes_on:
                stepping.run(z, self.ready(turn, begun), 1)
        self.land(z, broken)

    def land(self, z: np.ndarray, broken: Broken) -> None:
        """The clock of z (n_z, ...) after the last turn: the next step starts after a jump that is there."""
        z[0] = self._t0 + (broken.clock - (self._t0 + broken.step * self._steps[0]))
        z[1] = broken.step

    def ready(self, turn: Handover, begun: Begun) -> np.ndarray:
        """What the program reads in the part behind a turn."""
        model = self._scheme.model
        return self._program.prepared.ready(np.concatenate([model.constants(self._p(begun)), turn.after]))

    def of_parameters(self, slopes: np.ndarray) -> np.ndarray:
        """(n_p, k) of the slopes (n_x, k) of what a run begins with."""
        return slopes[: len(self._scheme.model.parameters)]

    def directions(
        self, taken: Taken, begun: Begun, along: np.ndarray, moved: np.ndarray, first: int = 0
    ) -> np.ndarray:
        """(active entries of z, k) after a turn from those before it; along (n_p, k): directions of p.

        first: of what is differentiated by, the one of the first direction.
        """
        jump, v = taken.turn.jump, self._v
        pushed = np.zeros((len(taken.gap), along.shape[1]))
        if jump is not None:
            pushed = np.outer(taken.gap, jump.moves @ along)
        found, whole = moved.copy(), np.zeros((self._n_s, along.shape[1]))
        whole[self._rows] = moved[self._own]
        inputs = whole[self._w].copy()
        if taken.acted is not None:
            state = taken.acted, taken.z, self._p(begun), taken.turn.before
            for k in range(along.shape[1]):
                push, inputs[:, k] = self._events.moved(*state, whole[:, k], along[:, k])
                pushed[:, k] += push
        if not self.remembers:
            whole[v] += pushed
            whole[self._w] = inputs
        for one in taken.turn.holds:
            row = one.row - self._w.start
            inputs[row] = 0.0
            if first <= one.place < first + along.shape[1]:
                inputs[row, one.place - first] = 1.0
        for k in range(along.shape[1]) if self.remembers else ():
            moves = whole[:, k], along[:, k], pushed[:, k], inputs[:, k]
            if taken.turn.kept:  # it was started there just before: the push alone is new
                moves = 0 * moves[0], 0 * moves[1], moves[2], 0 * moves[3]
            new = np.asarray(self._anew.tangent(*self._arguments(taken, begun), *moves)).ravel()
            whole[:, k] = whole[:, k] + new if taken.turn.kept else new
        found[self._own] = whole[self._rows]
        return found

    def ready_directions(self, turn: Handover, begun: Begun, along: np.ndarray) -> np.ndarray:
        """(active constants, k) of the part behind a turn, along (n_p, k)."""
        columns = [np.asarray(self._ready_tangent(self._p(begun), turn.after, one)).ravel() for one in along.T]
        return np.array(columns).T

    def pulled_back(self, taken: Taken, begun: Begun, adjoint: np.ndarray, held: np.ndarray) -> np.ndarray:
        """(n_p,); the adjoint of the active entries of z becomes that before the turn, in place.

        held (n,): what the inputs that change there are differentiated by is added to it.
        """
        bar = np.zeros(self._n_s)
        bar[self._rows] = adjoint[self._own]
        p_bar, pushed = np.zeros(len(self._p(begun))), bar[self._v]
        if self.remembers and taken.turn.kept:
            pushed = np.asarray(self._anew.adjoint(*self._arguments(taken, begun), bar)[2]).ravel()
        elif self.remembers:
            found = self._anew.adjoint(*self._arguments(taken, begun), bar)
            bar, p_bar, pushed, of_inputs = (np.asarray(one).ravel() for one in found)
            for one in taken.turn.holds:
                row = one.row - self._w.start
                if one.place >= 0:
                    held[one.place] += of_inputs[row]
                of_inputs[row] = 0.0
            if taken.acted is None:
                bar[self._w] += of_inputs
        else:
            of_inputs = bar[self._w].copy()
        if taken.acted is not None:
            if not self.remembers:
                bar[self._w] = 0.0
            state = taken.acted, taken.z, self._p(begun), taken.turn.before
            of_state, of_p = self._events.pulled_back(*state, pushed, of_inputs)
            bar, p_bar = bar + of_state, p_bar + of_p
        adjoint[self._own] = bar[self._rows]
        if (jump := taken.turn.jump) is not None:
            p_bar = p_bar + jump.moves * float(taken.gap @ pushed)
        return p_bar

    def ready_pulled_back(self, turn: Handover, begun: Begun, bar: np.ndarray) -> np.ndarray:
        """(n_p,) from the adjoint of the active constants of the part behind a turn."""
        return np.asarray(self._ready_adjoint(self._p(begun), turn.after, bar)).ravel()

    # ---- inside ---------------------------------------------------------------------------------------------

    def _restarted(self, taken: Taken, begun: Begun) -> np.ndarray:
        """By the program that a run has for it, so that the bits are the same."""
        if taken.turn.lengths is None:
            return np.asarray(self._anew.restart(*self._arguments(taken, begun))).ravel()
        c = self._scheme.model.constants(self._p(begun))
        return self._restart(taken.z, self._scheme.constants(c), *taken.turn.lengths, taken.clock)

    @cached_property
    def _restart(self) -> Restart:
        return Restart(self._scheme)

    def _p(self, begun: Begun) -> np.ndarray:
        return begun.x[: len(self._scheme.model.parameters)]

    def _arguments(self, taken: Taken, begun: Begun) -> tuple[np.ndarray | float, ...]:
        turn = taken.turn
        return taken.z, self._p(begun), taken.clock, turn.before, turn.after, np.zeros(len(taken.gap)), taken.w

    @cached_property
    def _ready_derivatives(self) -> tuple[ca.Function, ca.Function]:
        p, steps = ca.SX.sym("p", len(self._scheme.model.parameters)), ca.SX.sym("h", len(self._steps))
        whole = self._program.prepared.constants(ca.vertcat(self._scheme.model.kernel("constants")(p), steps))
        found = ca.densify(whole[list(self._program.active.c)])
        along, bar = ca.SX.sym("along", p.numel()), ca.SX.sym("bar", found.numel())
        forward, back = ca.jtimes(found, p, along), ca.jtimes(found, p, bar, True)
        return (
            ca.Function("part_tangent", [p, steps, along], shared([ca.densify(forward)])),
            ca.Function("part_adjoint", [p, steps, bar], shared([ca.densify(back)])),
        )

    @property
    def _ready_tangent(self) -> ca.Function:
        return self._ready_derivatives[0]

    @property
    def _ready_adjoint(self) -> ca.Function:
        return self._ready_derivatives[1]


def hold_inputs(z: np.ndarray, stop: Stop, begun: Begun, crossing: JumpCrossing | None) -> None:
    """The inputs that change at a stop, in z (n_z,); crossing: where schemes may start anew there."""
    if stop.holds and crossing is not None and crossing.remembers:
        crossing.take(crossing.hold(stop.holds), z, begun)
        return
    for one in stop.holds:
        z[one.row] = one.number(begun.values)


# A state of a differentiated run behind a jump, for schemes that start anew there, with its derivatives.


class StartsAnew:
    """Of a scheme; remembers: does it act through more than positions and rates?"""

    def __init__(self, scheme: Scheme, remembers: bool) -> None:
        self._scheme, self._remembers = scheme, remembers
        self._n_s, self._groups = scheme.layout.size, len(scheme.grid.h)
        self._w = scheme.layout.slice("inputs") if scheme.model.inputs else slice(0, 0)

    @cached_property
    def _symbols(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """z, p, and c with the inputs that z holds."""
        model = self._scheme.model
        z, p = ca.SX.sym("z", self._n_s), ca.SX.sym("p", len(model.parameters))
        c, fields = ca.SX(model.kernel("constants")(p)), self._scheme.layout.unpack(z)
        if "inputs" in fields:
            c = ca.vertcat(c[: model.c_size - model.signals.size], fields["inputs"])
        return z, p, c

    def _seen(self, steps: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
        """q_i, q_i_dot and the loop unknowns of z."""
        z, _, c = self._symbols
        fields = self._scheme.layout.unpack(z)
        if not self._remembers:
            return fields["x"], fields["v"], fields["loop"]
        seen = self._scheme.observer(z=z, c=ca.vertcat(c, steps))
        return seen["q_i"], seen["q_i_dot"], loop_guess(self._scheme, seen["q_d"])

    @cached_property
    def gap(self) -> ca.Function:
        """(z, p, steps, before, after) -> accelerations before less those after."""
        z, p, c = self._symbols
        steps, before, after = ca.SX.sym("h", self._groups), ca.SX.sym("before"), ca.SX.sym("after")
        q_i, v, loop = self._seen(steps)
        equations = self._scheme.equations(ca.vertcat(c, steps), self._scheme.layout.unpack(z))
        a = [equations.accelerations(equations.close_well(q_i, loop, t), v) for t in (before, after)]
        return ca.Function("gap", [z, p, steps, before, after], shared([ca.densify(a[0] - a[1])]))

    @cached_property
    def _restarts(self) -> tuple[ca.Function, ca.Function, ca.Function]:
        """(z, p, t, steps before, after, push, w) -> z; push: what is added to q_i_dot; its tangent and adjoint."""
        z, p, c = self._symbols
        scheme, t = self._scheme, ca.SX.sym("t")
        before, after = (ca.SX.sym(name, self._groups) for name in ("before", "after"))
        push = ca.SX.sym("push", len(scheme.model.q_i))
        w = ca.SX.sym("w", self._w.stop - self._w.start)
        there = ca.vertcat(c[: c.numel() - w.numel()], w, after)
        found = started_anew(scheme, z, t, ca.vertcat(c, before), there, push)
        given = [z, p, t, before, after, push, w]
        along = [ca.SX.sym(f"along_{k}", one.numel()) for k, one in enumerate((z, p, push, w))]
        bar = ca.SX.sym("bar", found.numel())
        inputs = ca.vertcat(z, p, push, w)
        forward = ca.densify(ca.jtimes(found, inputs, ca.vertcat(*along)))
        back = ca.densify(ca.jtimes(found, inputs, bar, True))
        ends = np.cumsum([0, z.numel(), p.numel(), push.numel(), w.numel()]).tolist()
        return (
            ca.Function("restart", given, shared([ca.densify(found)])),
            ca.Function("restart_tangent", [*given, *along], shared([forward])),
            ca.Function("restart_adjoint", [*given, bar], shared(ca.vertsplit(back, ends))),
        )

    @property
    def restart(self) -> ca.Function:
        """(z, p, t, steps before, after, push, w) -> z."""
        return self._restarts[0]

    @property
    def tangent(self) -> ca.Function:
        """The same, and directions of z, p, push and w -> direction of z."""
        return self._restarts[1]

    @property
    def adjoint(self) -> ca.Function:
        """The same, and an adjoint of z -> those of z, p, push and w."""
        return self._restarts[2]


# What an event does to the derivatives of a run: its time follows the motion, and so does what it sets.
#
# An event happens where g(q, q', t, p) = 0. With dz, the derivative of the state at that time, and g' along the motion,
#
#     dT = -(g_z dz + g_p dp) / g',    dv+ = dv- + (a- - a+) dT,    dw+ = A_z dz + A_p dp + A' dT
#
# for an action w = A(z, p) on inputs; positions and velocities are continuous. It is the saltation matrix of the event.


@dataclass(frozen=True)
class Acted:
    """At a state (n_s,): the event, its value and rate, accelerations before less those after (n_i,), inputs (n_w,)."""

    event: int
    value: float
    rate: float
    gap: np.ndarray
    w: np.ndarray

    @property
    def numbers(self) -> tuple[np.ndarray | float, ...]:
        """As the derivatives take them."""
        return self.value, self.rate, self.gap


class ActingEvents:
    """Of a scheme without fields of events. z (n_s,), p (n_p,) and steps (groups,) [s] are those before an event."""

    def __init__(self, scheme: Scheme) -> None:
        self._scheme, self._made = scheme, dict[int, tuple[ca.Function, ...]]()

    def act(self, passage: EventPassage, z: np.ndarray, p: np.ndarray, steps: np.ndarray) -> Acted:
        """What happens. Raises NoResult for an event that only grazes zero."""
        value, rate, gap, w = (np.asarray(one).ravel() for one in self._of(passage.event)[0](z, p, steps))
        if abs(float(rate[0])) <= passage.least:
            event = self._scheme.model.description.events[passage.event]
            raise NoResult(
                f"event {event.name} of model {self._scheme.model.name}",
                f"grazes zero at t = {passage.clock:.6g} s (rate {float(rate[0]):.3g} 1/s): its time has no derivative",
                "let it pass zero faster, or leave out of `by` what moves it",
            )
        return Acted(passage.event, float(value[0]), float(rate[0]), gap, w)

    def moved(
        self, acted: Acted, z: np.ndarray, p: np.ndarray, steps: np.ndarray, dz: np.ndarray, dp: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(what is added to the derivative of q_i_dot (n_i,), the derivative of the inputs behind the event (n_w,))."""
        found = np.asarray(self._of(acted.event)[1](z, p, steps, *acted.numbers, dz, dp)).ravel()
        return found[: len(acted.gap)], found[len(acted.gap) :]

    def pulled_back(
        self, acted: Acted, z: np.ndarray, p: np.ndarray, steps: np.ndarray, pushed: np.ndarray, w: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(adjoint of z (n_s,), of p (n_p,)) from those of what `moved` gives."""
        back = self._of(acted.event)[2](z, p, steps, *acted.numbers, np.concatenate([pushed, w]))
        return np.asarray(back[0]).ravel(), np.asarray(back[1]).ravel()

    def _of(self, k: int) -> tuple[ca.Function, ...]:
        """Of event k: what happens, and the tangent and the adjoint of it."""
        if k not in self._made:
            self._made[k] = self._functions(k)
        return self._made[k]

    def _functions(self, k: int) -> tuple[ca.Function, ...]:
        scheme, model = self._scheme, self._scheme.model
        z, p = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("p", len(model.parameters))
        steps, fields = ca.SX.sym("h", len(scheme.grid.h)), scheme.layout.unpack(z)
        first = model.c_size - model.signals.size
        w, known = fields["inputs"], ca.SX(model.kernel("constants")(p))[:first]
        equations = scheme.equations(ca.vertcat(known, w, steps), fields)
        seen = values_at(scheme, z, equations)
        value, rate, gap = ca.SX.sym("value"), ca.SX.sym("rate"), ca.SX.sym("gap", len(model.q_i))
        moves = -(seen["events"][k] - value) / rate  # zero, with the derivative of the time
        behind, at = ca.SX(w), sum(len(event.sets) for event in model.description.events[:k])
        plain = ca.SX(w)
        for j, name in enumerate(model.description.events[k].sets, at):
            place = model.signals.names.index(name)
            plain[place] = seen["actions"][j]
            behind[place] = seen["actions"][j] + seen["drifts"][j] * moves
        state = scheme.observer(z=z, c=ca.vertcat(known, w, steps))
        loop = [state["q_d"][model.q_d.index(name)] for name in model.loop_unknowns]
        guess = ca.vertcat(*loop) if loop else ca.SX(0, 1)
        sides = []
        for inputs in (w, plain):
            own = scheme.equations(ca.vertcat(known, inputs, steps))
            motion = own.close_well(state["q_i"], guess, state["t"])
            sides.append(own.accelerations(motion, state["q_i_dot"]))
        happens = [seen["events"][k], seen["slopes"][k], sides[0] - sides[1], plain]
        given, found = [z, p, steps, value, rate, gap], ca.vertcat(gap * moves, behind)
        both, along, bar = (
            ca.vertcat(z, p),
            [ca.SX.sym("dz", z.numel()), ca.SX.sym("dp", p.numel())],
            ca.SX.sym("bar", found.numel()),
        )
        forward = ca.densify(ca.jtimes(found, both, ca.vertcat(*along)))
        back = ca.vertsplit(ca.densify(ca.jtimes(found, both, bar, True)), [0, z.numel(), both.numel()])
        return (
            ca.Function("event", [z, p, steps], shared([ca.densify(one) for one in happens])),
            ca.Function("event_tangent", [*given, *along], shared([forward])),
            ca.Function("event_adjoint", [*given, bar], shared(back)),
        )
