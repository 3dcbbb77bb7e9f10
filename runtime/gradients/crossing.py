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

from runtime.contract.errors import ArgumentError
from runtime.contract.tape import shared
from runtime.engine.native import NativeProgram
from runtime.gradients.acting_events import Acted, ActingEvents
from runtime.gradients.beginning import Begun
from runtime.gradients.course import Broken, EventPassage, Hold, Jump, Stop
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.starts_anew import StartsAnew
from runtime.schemes.switching.breaks import within
from runtime.schemes.switching.restart import Restart, remembers


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
