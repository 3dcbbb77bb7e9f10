"""Forward and reverse mode: a run along directions, and a run with its way back (the adjoint); derivatives of outputs.

Forward mode gives sensitivities by the parameters and initial values, reverse mode the gradient of one number.

Forward, each lane carries one direction: the variational equations (tangent linear model) of the steps.
Backward, the outputs' bars are given and flow to the beginning: what steps
and outputs read is on tapes. A short run is recorded whole. A long one keeps its state at some sqrt(n) steps and is run
again from the last of them, then from the one before, so that memory grows as sqrt(n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import ceil, sqrt

import numpy as np

from runtime.engine.derivatives import LaneArrays, Recorder, TangentCode
from runtime.gradients.course import Course, Stop, Turn
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.started_run import StartedRun
from runtime.gradients.turns import TurnProgram

TAPE_NUMBERS = 500_000  # a run whose tape is shorter is recorded whole; about what a second-level cache holds


Turns = Callable[[Turn], TurnProgram]  # the program of a turn


def forward(
    program: ObservedProgram,
    codes: tuple[TangentCode, TangentCode],
    turns: Turns,
    course: Course,
    started: StartedRun,
    directions: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(outputs (N, n_y), their derivatives (N, n_y, k), the last z) along directions (active, k).

    codes: tangents of the step and of the outputs, of one width.
    """
    stepping, observing = codes
    active, width, n_y = program.active, stepping.width, program.outputs.stop - program.outputs.start
    count, z, constants = directions.shape[1], started.z, started.ready
    y, slopes = np.zeros((len(course.times), n_y)), np.zeros((len(course.times), n_y, count))
    arrays = LaneArrays(len(z) + len(active.z), len(constants) + len(active.c), width)
    grid = LaneArrays(0, len(arrays.c), width).c
    rows = [len(z) + row for row in program.output_rows]
    for first in range(0, count, width):
        here = min(width, count - first)
        arrays.z[: len(z)], arrays.c[: len(constants)] = z[:, None], constants[:, None]
        arrays.z[len(z) :], arrays.c[len(constants) :] = 0.0, 0.0
        arrays.z[len(z) :, :here] = directions[: len(active.z), first : first + here]
        arrays.c[len(constants) :, :here] = directions[len(active.z) :, first : first + here]
        grid[:] = arrays.c
        for stop in course.stops:
            if stop.turn is not None:
                turns(stop.turn).along(stop.turn, arrays, started, grid, first, here)
            else:
                arrays.z[0] = stop.t0
            if stop.steps:
                stepping.run(arrays, stop.steps)
            if stop.sample >= 0:
                observing.run(arrays, 1)
                slopes[stop.sample, :, first : first + here] = arrays.z[rows[0] : rows[-1] + 1, :here]
                if first == 0:
                    y[stop.sample] = arrays.z[program.outputs, 0]
    return y, slopes, arrays.z[: len(z), 0].copy()


class Backward:
    """A run with its way back.  codes: recorders of the step and of the outputs."""

    def __init__(
        self, program: ObservedProgram, codes: tuple[Recorder, Recorder], turns: Turns, course: Course
    ) -> None:
        self.program, self.course, self.turns = program, course, turns
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
            left = stop
            while True:
                if not room and left.steps:
                    segments.append([])
                    room = self.longest
                taken = min(left.steps, room)
                room -= taken
                if taken == left.steps:
                    segments[-1].append(left)
                    break
                segments[-1].append(replace(left, steps=taken, sample=-1))
                left = replace(left, steps=left.steps - taken)
        return segments

    def record(self, started: StartedRun) -> Recording:
        """Run forward, on tapes."""
        return Recording(self, started)

    @property
    def rows(self) -> slice:
        """Where the outputs lie in an adjoint."""
        return slice(self.program.output_rows[0], self.program.output_rows[-1] + 1)


class Recording:
    """A run that went forward on tapes. y (N, n_y): its outputs; last: the last z."""

    def __init__(self, run: Backward, started: StartedRun) -> None:
        self._run, self._started = run, started
        outputs = run.program.outputs
        self.y = np.zeros((len(run.course.times), outputs.stop - outputs.start))
        self._tapes = _Tapes(run, started, self.y)
        self._first = np.zeros(run.observing.records + 1)
        self._kept: list[np.ndarray] = []  # z at the beginning of each part
        z = started.z.copy()
        run.observing.record(z, started.ready, self._first, 1)
        self.y[0] = z[outputs]
        for part in run.parts:
            self._kept.append(z.copy())
            self._tapes.forward(z, part)
        self.last = z
        self._on_tapes = True  # the last part; going back takes it off

    def back(self, bars: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(adjoint of the active entries of z and constants at the beginning, that of x by what is held later (n,),
        that of p through the times of jumps (n_p,)) from bars (N, n_y) of the outputs.
        """
        run, tapes = self._run, self._tapes
        adjoint, held = np.zeros(run.program.active.size), np.zeros(len(self._started.values))
        tapes.of_parameters[:] = 0.0
        for part, start in zip(reversed(run.parts), reversed(self._kept), strict=True):
            if not self._on_tapes:
                tapes.forward(start.copy(), part)
            self._on_tapes = False
            tapes.back(adjoint, held, bars, part)
        adjoint[run.rows] = bars[0]
        run.observing.reverse(adjoint, self._started.ready, self._first, 1)
        return adjoint, held, tapes.of_parameters


class _Tapes:
    """What a segment recorded: of steps and of outputs, each in its order; outputs go to y (N, n_y)."""

    def __init__(self, run: Backward, started: StartedRun, y: np.ndarray) -> None:
        self._run, self._started, self._y = run, started, y
        self._step, self._output = run.stepping, run.observing
        steps = max((sum(stop.steps for stop in part) for part in run.parts), default=0)
        most = max((sum(stop.sample >= 0 for stop in part) for part in run.parts), default=0)
        self._steps = np.zeros(steps * self._step.records + 1)
        self._outputs = np.zeros(most * self._output.records + 1)
        self._at, self._sampled = 0, 0
        self._turned: list[tuple[np.ndarray, np.ndarray]] = []  # tapes, and what steps read behind them
        self.of_parameters = np.zeros(len(run.program.scheme.model.parameters))

    def forward(self, z: np.ndarray, part: list[Stop]) -> None:
        """Run a segment and record it, from the beginning of the tapes."""
        self._at, self._sampled = 0, 0
        self._turned.clear()
        for stop in part:
            c = self._started.ready
            if stop.turn is not None:
                c, tape = self._run.turns(stop.turn).record(stop.turn, z, self._started)
                self._turned.append((tape, c))
            else:
                z[0] = stop.t0
            self._step.record(z, c, self._steps[self._at :], stop.steps)
            self._at += stop.steps * self._step.records
            if stop.sample >= 0:
                self._output.record(z, c, self._outputs[self._sampled :], 1)
                self._sampled += self._output.records
                self._y[stop.sample] = z[self._run.program.outputs]

    def back(self, adjoint: np.ndarray, held: np.ndarray, bars: np.ndarray, part: list[Stop]) -> None:
        """The same, the other way."""
        first = len(self._run.program.active.z)
        for stop in reversed(part):
            tape, c = self._turned.pop() if stop.turn is not None else (None, self._started.ready)
            if stop.sample >= 0:
                adjoint[self._run.rows] = bars[stop.sample]
                self._sampled -= self._output.records
                self._output.reverse(adjoint, c, self._outputs[self._sampled :], 1)
            grid = adjoint[first:].copy()
            if stop.turn is not None:
                adjoint[first:] = 0.0
            self._at -= stop.steps * self._step.records
            self._step.reverse(adjoint, c, self._steps[self._at :], stop.steps)
            if stop.turn is not None and tape is not None:
                ready, adjoint[first:] = adjoint[first:].copy(), grid
                turned = self._run.turns(stop.turn)
                self.of_parameters += turned.back(stop.turn, tape, adjoint, ready, self._started, held)
