"""A broken step of a differentiated run: parts with steps of their own, and the jumps between them.

Where accelerations jump from a- to a+ at a time T(p), positions and rates are continuous, and a state that goes on
from there has dv = (a- - a+) dT besides what it has from before (the saltation matrix of a jump in time). Schemes that
remember earlier steps start anew at each part, as in a run.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import prod

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.engine.native import NativeProgram
from runtime.gradients.beginning import Begun
from runtime.gradients.course import Broken, Hold, Jump, Stop
from runtime.gradients.observed_program import ObservedProgram
from runtime.schemes.state_fields import Lasting


@dataclass(frozen=True)
class Handover:
    """From one part of a step to the next: the steps of both (groups,) [s], the clock [s], the jump there if any.

    goes_on: is a step made from there? The last turn leads back to the grid. holds: inputs that change there.
    """

    before: np.ndarray
    after: np.ndarray
    clock: float
    jump: Jump | None
    goes_on: bool
    holds: tuple[Hold, ...] = ()


@dataclass(frozen=True)
class Taken:
    """A turn at a state z (n_s,), the scheme's part, and a clock [s].

    gap (n_i,): accelerations before the jump less those after it; w (n_w,): the inputs behind the turn.
    """

    turn: Handover
    z: np.ndarray
    clock: float
    gap: np.ndarray
    w: np.ndarray


class JumpCrossing:
    """Broken steps of a program whose grid of steps begins at t0 [s]."""

    def __init__(self, program: ObservedProgram, t0: float) -> None:
        self._program, self._scheme, self._t0 = program, program.scheme, t0
        self._n_s, self._steps = self._scheme.layout.size, np.array(self._scheme.grid.h)
        self._own = [k for k, row in enumerate(program.active.z) if row < self._n_s]
        self._rows = [program.active.z[k] for k in self._own]
        self._v = self._scheme.layout.slice("v") if "v" in self._scheme.layout.sizes else slice(0, 0)
        self._w = self._scheme.layout.slice("inputs") if self._scheme.model.inputs else slice(0, 0)
        self.remembers = not set(self._scheme.memory) <= {"x", "v", "loop", "chart"}
        if self.remembers and self._scheme.charts.size:
            raise ArgumentError(
                f"scheme of model {self._scheme.model.name}",
                "starts anew where forces jump, which is not differentiated for turns of free bodies",
                "take a scheme of one step, such as exponential or rk4",
            )

    def turns(self, broken: Broken) -> list[Handover]:
        """To each part of a broken step, and back to the grid."""
        found, before = [], self._steps
        for part in broken.parts:
            length = part.length * (1 - 2 * np.finfo(float).eps * prod(self._scheme.grid.m))
            after = self._steps * (length / self._steps[0])
            found.append(Handover(before, after, part.start, part.jump, True))
            before = after
        return [*found, Handover(before, self._steps, broken.clock, None, False)]

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
            gap = np.asarray(self._gap(own, p, turn.before, before, after)).ravel()
        taken = Taken(turn, own, clock, gap, w)
        if self.remembers:
            z[: self._n_s] = np.asarray(self._restart(*self._arguments(taken, begun))).ravel()
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
        if not self.remembers:
            whole[v] += pushed
        inputs = whole[self._w].copy()
        for one in taken.turn.holds:
            row = one.row - self._w.start
            inputs[row] = 0.0
            if first <= one.place < first + along.shape[1]:
                inputs[row, one.place - first] = 1.0
        for k in range(along.shape[1]) if self.remembers else ():
            arguments = (*self._arguments(taken, begun), whole[:, k], along[:, k], pushed[:, k], inputs[:, k])
            whole[:, k] = np.asarray(self._restart_tangent(*arguments)).ravel()
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
        if self.remembers:
            found = self._restart_adjoint(*self._arguments(taken, begun), bar)
            bar, p_bar, pushed, of_inputs = (np.asarray(one).ravel() for one in found)
            for one in taken.turn.holds:
                row = one.row - self._w.start
                if one.place >= 0:
                    held[one.place] += of_inputs[row]
                of_inputs[row] = 0.0
            bar[self._w] += of_inputs
        adjoint[self._own] = bar[self._rows]
        if (jump := taken.turn.jump) is not None:
            p_bar = p_bar + jump.moves * float(taken.gap @ pushed)
        return p_bar

    def ready_pulled_back(self, turn: Handover, begun: Begun, bar: np.ndarray) -> np.ndarray:
        """(n_p,) from the adjoint of the active constants of the part behind a turn."""
        return np.asarray(self._ready_adjoint(self._p(begun), turn.after, bar)).ravel()

    # ---- inside ---------------------------------------------------------------------------------------------

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
            ca.Function("part_tangent", [p, steps, along], ca.cse([ca.densify(forward)])),
            ca.Function("part_adjoint", [p, steps, bar], ca.cse([ca.densify(back)])),
        )

    @property
    def _ready_tangent(self) -> ca.Function:
        return self._ready_derivatives[0]

    @property
    def _ready_adjoint(self) -> ca.Function:
        return self._ready_derivatives[1]

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
        model, fields = self._scheme.model, self._scheme.layout.unpack(z)
        if not self.remembers:
            return fields["x"], fields["v"], fields["loop"]
        seen = self._scheme.observer(z=z, c=ca.vertcat(c, steps))
        loop = [seen["q_d"][model.q_d.index(name)] for name in model.loop_unknowns]
        return seen["q_i"], seen["q_i_dot"], ca.vertcat(*loop) if loop else ca.SX(0, 1)

    @cached_property
    def _gap(self) -> ca.Function:
        """(z, p, steps, before, after) -> accelerations before less those after."""
        z, p, c = self._symbols
        steps, before, after = ca.SX.sym("h", len(self._steps)), ca.SX.sym("before"), ca.SX.sym("after")
        q_i, v, loop = self._seen(steps)
        equations = self._scheme.equations(ca.vertcat(c, steps), self._scheme.layout.unpack(z))
        a = [equations.accelerations(equations.close_well(q_i, loop, t), v) for t in (before, after)]
        return ca.Function("gap", [z, p, steps, before, after], ca.cse([ca.densify(a[0] - a[1])]))

    @cached_property
    def _restarts(self) -> tuple[ca.Function, ca.Function, ca.Function]:
        """(z, p, t, steps before, after, push, w) -> z; push: what is added to q_i_dot; its tangent and adjoint."""
        z, p, c = self._symbols
        scheme, t = self._scheme, ca.SX.sym("t")
        before, after = (ca.SX.sym(name, len(self._steps)) for name in ("before", "after"))
        push = ca.SX.sym("push", len(scheme.model.q_i))
        q_i, v, loop = self._seen(before)
        w = ca.SX.sym("w", self._w.stop - self._w.start)
        there = ca.vertcat(c[: c.numel() - w.numel()], w, after)
        found = ca.SX(scheme.starter(t, q_i, v + push, loop, there))
        for name in scheme.lasting(Lasting.ACCOUNT, Lasting.GIVEN):
            found[scheme.layout.slice(name)] = w if name == "inputs" else z[scheme.layout.slice(name)]
        given = [z, p, t, before, after, push, w]
        along = [ca.SX.sym(f"along_{k}", one.numel()) for k, one in enumerate((z, p, push, w))]
        bar = ca.SX.sym("bar", found.numel())
        inputs = ca.vertcat(z, p, push, w)
        forward = ca.densify(ca.jtimes(found, inputs, ca.vertcat(*along)))
        back = ca.densify(ca.jtimes(found, inputs, bar, True))
        ends = np.cumsum([0, z.numel(), p.numel(), push.numel(), w.numel()]).tolist()
        return (
            ca.Function("restart", given, ca.cse([ca.densify(found)])),
            ca.Function("restart_tangent", [*given, *along], ca.cse([forward])),
            ca.Function("restart_adjoint", [*given, bar], ca.cse(ca.vertsplit(back, ends))),
        )

    @property
    def _restart(self) -> ca.Function:
        return self._restarts[0]

    @property
    def _restart_tangent(self) -> ca.Function:
        return self._restarts[1]

    @property
    def _restart_adjoint(self) -> ca.Function:
        return self._restarts[2]


def hold_inputs(z: np.ndarray, stop: Stop, begun: Begun, crossing: JumpCrossing | None) -> None:
    """The inputs that change at a stop, in z (n_z,); crossing: where schemes may start anew there."""
    if stop.holds and crossing is not None and crossing.remembers:
        crossing.take(crossing.hold(stop.holds), z, begun)
        return
    for one in stop.holds:
        z[one.row] = one.number(begun.values)
