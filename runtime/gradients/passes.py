"""A run along directions, and a run with its way back: outputs at saved times and their derivatives.

Forward, each lane carries one direction. Backward, the outputs' bars are given and flow to the beginning: what steps
and outputs read is on tapes. A short run is recorded whole. A long one keeps its state at some sqrt(n) steps and is run
again from the last of them, then from the one before, so that memory grows as sqrt(n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import ceil, sqrt

import numpy as np

from runtime.engine.derivatives import LaneArrays, Recorder, TangentCode
from runtime.gradients.course import Broken, Course, Hold, Stop
from runtime.gradients.crossing import JumpCrossing, Taken
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.start_of_run import Begun

TAPE_NUMBERS = 500_000  # a run whose tape is shorter is recorded whole; about what a second-level cache holds


def forward(
    program: ObservedProgram,
    codes: tuple[TangentCode, TangentCode],
    course: Course,
    begun: Begun,
    directions: np.ndarray,
    crossing: JumpCrossing | None = None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(outputs (N, n_y), their derivatives (N, n_y, k), the last z) along directions (active, k).

    codes: tangents of the step and of the outputs, of one width; crossing: where steps are broken.
    """
    stepping, observing = codes
    active, width, n_y = program.active, stepping.width, program.outputs.stop - program.outputs.start
    count, z, constants = directions.shape[1], begun.z, begun.ready
    y, slopes = np.zeros((len(course.times), n_y)), np.zeros((len(course.times), n_y, count))
    arrays = LaneArrays(len(z) + len(active.z), len(constants) + len(active.c), width)
    rows = [len(z) + row for row in program.output_rows]
    for first in range(0, count, width):
        here = min(width, count - first)
        arrays.z[: len(z)], arrays.c[: len(constants)] = z[:, None], constants[:, None]
        arrays.z[len(z) :], arrays.c[len(constants) :] = 0.0, 0.0
        arrays.z[len(z) :, :here] = directions[: len(active.z), first : first + here]
        arrays.c[len(constants) :, :here] = directions[len(active.z) :, first : first + here]
        for stop in course.stops:
            if stop.broken is not None and crossing is not None:
                across(crossing, stepping, arrays, stop.broken, begun, begun.slopes[:, first : first + here])
            elif stop.steps:
                stepping.run(arrays, stop.steps)
            if stop.sample >= 0:
                observing.run(arrays, 1)
                slopes[stop.sample, :, first : first + here] = arrays.z[rows[0] : rows[-1] + 1, :here]
                if first == 0:
                    y[stop.sample] = arrays.z[program.outputs, 0]
            if stop.holds and crossing is not None and crossing.remembers:
                hold_in_lanes(crossing, arrays, stop.holds, begun, begun.slopes[:, first : first + here], first)
                continue
            for hold in stop.holds:
                row = len(z) + active.z.index(hold.row)
                arrays.z[hold.row], arrays.z[row] = hold.number(begun.values), 0.0
                if first <= hold.place < first + here:
                    arrays.z[row, hold.place - first] = 1.0
    return y, slopes, arrays.z[: len(z), 0].copy()


def across(
    crossing: JumpCrossing, stepping: TangentCode, arrays: LaneArrays, broken: Broken, begun: Begun, slopes: np.ndarray
) -> None:
    """A broken step in lanes; slopes (n_x, k): of what the run begins with, p first."""
    z, c, here, kept = arrays.z, arrays.c, slopes.shape[1], arrays.c.copy()
    n_z, n_c, along = len(begun.z), len(begun.ready), crossing.of_parameters(slopes)
    for turn in crossing.turns(broken):
        state = z[:n_z, 0].copy()
        taken = crossing.take(turn, state, begun)
        z[:n_z] = state[:, None]
        z[n_z:, :here] = crossing.directions(taken, begun, along, z[n_z:, :here])
        if turn.goes_on:
            c[:n_c] = crossing.ready(turn, begun)[:, None]
            c[n_c:, :here] = crossing.ready_directions(turn, begun, along)
            stepping.run(arrays, 1)
    crossing.land(z, broken)
    c[:] = kept


def hold_in_lanes(
    crossing: JumpCrossing,
    arrays: LaneArrays,
    holds: tuple[Hold, ...],
    begun: Begun,
    slopes: np.ndarray,
    first: int,
) -> None:
    """Inputs change where a scheme starts anew; slopes (n_x, k) as in `across`; first: see `directions`."""
    z, n_z, here = arrays.z, len(begun.z), slopes.shape[1]
    state = z[:n_z, 0].copy()
    taken = crossing.take(crossing.hold(holds), state, begun)
    z[:n_z] = state[:, None]
    z[n_z:, :here] = crossing.directions(taken, begun, crossing.of_parameters(slopes), z[n_z:, :here], first)


Weigh = Callable[[np.ndarray], np.ndarray]  # outputs (N, n_y) -> derivative of the objective by them, of that shape


class Backward:
    """A run with its way back.  codes: recorders of the step and of the outputs; crossing: where steps are broken."""

    def __init__(
        self,
        program: ObservedProgram,
        codes: tuple[Recorder, Recorder],
        course: Course,
        crossing: JumpCrossing | None = None,
    ) -> None:
        self.program, self.course, self.crossing = program, course, crossing
        self.stepping, self.observing = codes
        self.longest = self._longest_segment(course.steps)
        self.parts = self._parts()

    def _longest_segment(self, steps: int) -> int:
        """Steps between two states that are kept: what is kept and what is recorded take equal room."""
        records = max(1, self.stepping.records)
        if steps * records <= TAPE_NUMBERS:
            return max(1, steps)
        return max(ceil(sqrt(steps * self.program.active.z_size / records)), TAPE_NUMBERS // records, 1)

    def _parts(self) -> list[list[Stop]]:
        """Segments of the course, each of at most `longest` steps: a stop is cut where it is too long."""
        segments: list[list[Stop]] = [[]]
        room = self.longest
        for stop in self.course.stops[1:]:
            if stop.broken is not None:
                if stop.recorded > room and segments[-1]:
                    segments.append([])
                    room = self.longest
                segments[-1].append(stop)
                room = max(0, room - stop.recorded)
            left = stop.steps
            while left:
                if not room:
                    segments.append([])
                    room = self.longest
                taken = min(left, room)
                left, room = left - taken, room - taken
                segments[-1].append(Stop(taken, -1) if left else replace(stop, steps=taken))
        return segments

    def run(self, begun: Begun, weigh: Weigh) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """(outputs (N, n_y), adjoint of the active entries of z and constants at the beginning, that of x by what is
        held later (n,), that of p by broken steps (n_p,), the last z).
        """
        active, outputs, constants = self.program.active, self.program.outputs, begun.ready
        y = np.zeros((len(self.course.times), outputs.stop - outputs.start))
        z, kept = begun.z.copy(), []
        tapes = _Tapes(self, begun, y)
        first = np.zeros(self.observing.records + 1)
        self.observing.record(z, constants, first, 1)
        y[0] = z[outputs]
        for part in self.parts:
            kept.append(z.copy())
            tapes.forward(z, part)
        last = z.copy()
        bars = weigh(y)
        adjoint, held = np.zeros(active.size), np.zeros(len(begun.values))
        for part, start in zip(reversed(self.parts), reversed(kept), strict=True):
            if part is not self.parts[-1]:
                z = start.copy()
                tapes.forward(z, part)
            tapes.back(adjoint, held, bars, part)
        adjoint[self.rows] = bars[0]
        self.observing.reverse(adjoint, constants, first, 1)
        return y, adjoint, held, tapes.of_parameters, last

    @property
    def rows(self) -> slice:
        """Where the outputs lie in an adjoint."""
        return slice(self.program.output_rows[0], self.program.output_rows[-1] + 1)


class _Tapes:
    """What a segment recorded: of steps and of outputs, each in its order; outputs go to y (N, n_y)."""

    def __init__(self, run: Backward, begun: Begun, y: np.ndarray) -> None:
        self._run, self._begun, self._y = run, begun, y
        self._step, self._output = run.stepping, run.observing
        steps = max((sum(stop.recorded for stop in part) for part in run.parts), default=0)
        most = max((sum(stop.sample >= 0 for stop in part) for part in run.parts), default=0)
        self._steps = np.zeros(steps * self._step.records + 1)
        self._outputs = np.zeros(most * self._output.records + 1)
        self._at, self._seen = 0, 0
        self._taken: list[tuple[Taken, np.ndarray]] = []
        self.of_parameters = np.zeros(len(run.program.scheme.model.parameters))

    def forward(self, z: np.ndarray, part: list[Stop]) -> None:
        """Run a segment and record it, from the beginning of the tapes."""
        c, self._at, self._seen = self._begun.ready, 0, 0
        self._taken.clear()
        for stop in part:
            if stop.broken is not None:
                self._forward_across(z, stop.broken)
            self._step.record(z, c, self._steps[self._at :], stop.steps)
            self._at += stop.steps * self._step.records
            if stop.sample >= 0:
                self._output.record(z, c, self._outputs[self._seen :], 1)
                self._seen += self._output.records
                self._y[stop.sample] = z[self._run.program.outputs]
            if stop.holds and self._starts_anew is not None:
                taken = self._starts_anew.take(self._starts_anew.hold(stop.holds), z, self._begun)
                self._taken.append((taken, c))
                continue
            for hold in stop.holds:
                z[hold.row] = hold.number(self._begun.values)

    def back(self, adjoint: np.ndarray, held: np.ndarray, bars: np.ndarray, part: list[Stop]) -> None:
        """The same, the other way."""
        c, active = self._begun.ready, self._run.program.active
        for stop in reversed(part):
            if stop.holds and self._starts_anew is not None:
                self.of_parameters += self._starts_anew.pulled_back(self._taken.pop()[0], self._begun, adjoint, held)
            for hold in reversed(stop.holds) if self._starts_anew is None else ():
                row = active.z.index(hold.row)
                if hold.place >= 0:
                    held[hold.place] += adjoint[row]
                adjoint[row] = 0.0
            if stop.sample >= 0:
                adjoint[self._run.rows] = bars[stop.sample]
                self._seen -= self._output.records
                self._output.reverse(adjoint, c, self._outputs[self._seen :], 1)
            self._at -= stop.steps * self._step.records
            self._step.reverse(adjoint, c, self._steps[self._at :], stop.steps)
            if stop.broken is not None:
                self._back_across(adjoint, held, stop.recorded)

    def _forward_across(self, z: np.ndarray, broken: Broken) -> None:
        crossing = self._run.crossing
        assert crossing is not None
        for turn in crossing.turns(broken):
            taken, ready = crossing.take(turn, z, self._begun), self._begun.ready
            if turn.goes_on:
                ready = crossing.ready(turn, self._begun)
                self._step.record(z, ready, self._steps[self._at :], 1)
                self._at += self._step.records
            self._taken.append((taken, ready))
        crossing.land(z, broken)

    @property
    def _starts_anew(self) -> JumpCrossing | None:
        """Who starts anew where inputs change, if the scheme does."""
        crossing = self._run.crossing
        return crossing if crossing is not None and crossing.remembers else None

    def _back_across(self, adjoint: np.ndarray, held: np.ndarray, parts: int) -> None:
        crossing, begun, first = self._run.crossing, self._begun, len(self._run.program.active.z)
        assert crossing is not None
        for _ in range(parts + 1):
            taken, ready = self._taken.pop()
            if taken.turn.goes_on:
                self._at -= self._step.records
                kept, adjoint[first:] = adjoint[first:].copy(), 0.0
                self._step.reverse(adjoint, ready, self._steps[self._at :], 1)
                self.of_parameters += crossing.ready_pulled_back(taken.turn, begun, adjoint[first:].copy())
                adjoint[first:] = kept
            self.of_parameters += crossing.pulled_back(taken, begun, adjoint, held)
