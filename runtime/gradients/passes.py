"""A run along directions, and a run with its way back: outputs at saved times and their derivatives.

Forward, each lane carries one direction. Backward, the outputs' bars are given and flow to the beginning: what steps
and outputs read is on tapes. A short run is recorded whole. A long one keeps its state at some sqrt(n) steps and is run
again from the last of them, then from the one before, so that memory grows as sqrt(n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, sqrt

import numpy as np

from runtime.engine.derivatives_code import LaneArrays, Recorder, TangentCode
from runtime.gradients.observed_program import ObservedProgram

TAPE_NUMBERS = 500_000  # a run whose tape is shorter is recorded whole; about what a second-level cache holds


@dataclass(frozen=True)
class SampleGrid:
    """steps: major steps before each sample but the first, so N + 1 samples follow from N entries."""

    steps: tuple[int, ...]

    @property
    def count(self) -> int:
        """How many samples."""
        return len(self.steps) + 1


def forward(
    program: ObservedProgram,
    codes: tuple[TangentCode, TangentCode],
    samples: SampleGrid,
    z: np.ndarray,
    constants: np.ndarray,
    directions: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(outputs (N, n_y), their derivatives (N, n_y, k), the last z) along directions (active, k).

    codes: tangents of the step and of the outputs, of one width.
    """
    stepping, observing = codes
    active, width, n_y = program.active, stepping.width, program.outputs.stop - program.outputs.start
    count = directions.shape[1]
    y, slopes = np.zeros((samples.count, n_y)), np.zeros((samples.count, n_y, count))
    arrays = LaneArrays(len(z) + len(active.z), len(constants) + len(active.c), width)
    rows = [len(z) + row for row in program.output_rows]
    for first in range(0, count, width):
        here = min(width, count - first)
        arrays.z[: len(z)], arrays.c[: len(constants)] = z[:, None], constants[:, None]
        arrays.z[len(z) :], arrays.c[len(constants) :] = 0.0, 0.0
        arrays.z[len(z) :, :here] = directions[: len(active.z), first : first + here]
        arrays.c[len(constants) :, :here] = directions[len(active.z) :, first : first + here]
        for k in range(samples.count):
            if k:
                stepping.run(arrays, samples.steps[k - 1])
            observing.run(arrays, 1)
            slopes[k, :, first : first + here] = arrays.z[rows[0] : rows[-1] + 1, :here]
            if first == 0:
                y[k] = arrays.z[program.outputs, 0]
    return y, slopes, arrays.z[: len(z), 0].copy()


Weigh = Callable[[np.ndarray], np.ndarray]  # outputs (N, n_y) -> derivative of the objective by them, of that shape


class Backward:
    """A run with its way back.  codes: recorders of the step and of the outputs."""

    def __init__(self, program: ObservedProgram, codes: tuple[Recorder, Recorder], samples: SampleGrid) -> None:
        self.program, self.samples = program, samples
        self.stepping, self.observing = codes
        total = sum(samples.steps)
        self.longest = self._longest_segment(total)
        self.parts = self._parts()

    def _longest_segment(self, steps: int) -> int:
        """Steps between two states that are kept: what is kept and what is recorded take equal room."""
        records = max(1, self.stepping.records)
        if steps * records <= TAPE_NUMBERS:
            return max(1, steps)
        return max(ceil(sqrt(steps * self.program.active.z_size / records)), TAPE_NUMBERS // records, 1)

    def _parts(self) -> list[list[tuple[int, int]]]:
        """Segments of (steps, sample after them or -1), each of at most `longest` steps."""
        segments: list[list[tuple[int, int]]] = [[]]
        room = self.longest
        for k, steps in enumerate(self.samples.steps):
            left = steps
            while left:
                if not room:
                    segments.append([])
                    room = self.longest
                taken = min(left, room)
                left, room = left - taken, room - taken
                segments[-1].append((taken, -1 if left else k + 1))
        return segments

    def run(self, z: np.ndarray, constants: np.ndarray, weigh: Weigh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(outputs (N, n_y), adjoint of the active entries of z and constants at the beginning, the last z)."""
        active, outputs = self.program.active, self.program.outputs
        y = np.zeros((self.samples.count, outputs.stop - outputs.start))
        z, whole = z.copy(), len(self.parts) == 1
        kept = []
        tapes = _Tapes(self, max((sum(steps for steps, _ in part) for part in self.parts), default=0))
        first = np.zeros(self.observing.records + 1)
        self.observing.record(z, constants, first, 1)
        y[0] = z[outputs]
        for part in self.parts:
            kept.append(z.copy())
            tapes.rewind()
            for steps, sample in part:
                tapes.forward(z, constants, steps, sample)
                if sample >= 0:
                    y[sample] = z[outputs]
        last = z.copy()
        bars = weigh(y)
        adjoint = np.zeros(active.size)
        rows = slice(self.program.output_rows[0], self.program.output_rows[-1] + 1)
        for part, start in zip(reversed(self.parts), reversed(kept), strict=True):
            if not whole and part is not self.parts[-1]:
                z = start.copy()
                tapes.rewind()
                for steps, sample in part:
                    tapes.forward(z, constants, steps, sample)
            for steps, sample in reversed(part):
                if sample >= 0:
                    adjoint[rows] = bars[sample]
                tapes.back(adjoint, constants, steps, sample)
        adjoint[rows] = bars[0]
        self.observing.reverse(adjoint, constants, first, 1)
        return y, adjoint, last


class _Tapes:
    """What a segment recorded: of steps and of outputs, each in its order."""

    def __init__(self, run: Backward, steps: int) -> None:
        self._step, self._output = run.stepping, run.observing
        most = max((sum(sample >= 0 for _, sample in part) for part in run.parts), default=0)
        self._steps = np.zeros(steps * self._step.records + 1)
        self._outputs = np.zeros(most * self._output.records + 1)
        self.rewind()

    def rewind(self) -> None:
        """Begin anew."""
        self._at, self._seen = 0, 0

    def forward(self, z: np.ndarray, c: np.ndarray, steps: int, sample: int) -> None:
        """Steps, and outputs where there is a sample after them."""
        self._step.record(z, c, self._steps[self._at :], steps)
        self._at += steps * self._step.records
        if sample >= 0:
            self._output.record(z, c, self._outputs[self._seen :], 1)
            self._seen += self._output.records

    def back(self, adjoint: np.ndarray, c: np.ndarray, steps: int, sample: int) -> None:
        """The same, the other way."""
        if sample >= 0:
            self._seen -= self._output.records
            self._output.reverse(adjoint, c, self._outputs[self._seen :], 1)
        self._at -= steps * self._step.records
        self._step.reverse(adjoint, c, self._steps[self._at :], steps)
