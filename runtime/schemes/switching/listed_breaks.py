"""Broken steps one after another in one native call: the list of what is run and copied, for many of them at once.

Each is what broken_steps.py makes of it: parts of their own lengths, each with constants of its own, and where the
scheme needs them starts anew and looks for events (crossing.py).
"""

from __future__ import annotations

import sys
from bisect import bisect_left

import numpy as np

from runtime.engine.call_list import CallList, repeated, woven
from runtime.engine.program import Layout
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.breaks import Breaks, StepParts, within
from runtime.schemes.switching.crossing import ACTS, crossing, needs_crossing
from runtime.schemes.switching.crossing_rows import LEAD, CrossingRows, marks
from runtime.schemes.switching.watched import NEVER

MOST_NUMBERS = 1 << 19  # of the constants of their parts, about


class ListedBreaks:
    """Broken steps first, first + 1, ... of a grid, by their numbers among the broken ones; not those from `last` on.

    c (c_size,): the model's constants; n_c: how many numbers the program of the stepper reads. most: of steps.
    """

    def __init__(self, stepper: Stepper, grid: Breaks, first: int, c: np.ndarray, n_c: int, most: int) -> None:
        scheme, n_z = stepper.scheme, stepper.prepared.z_size
        self._stepper, self._grid, self.first = stepper, grid, first
        steps = np.array(grid.broken[first : first + most])
        held = n_c * np.cumsum(grid.parts(steps).counts)  # numbers, up to each step
        self._steps = steps[: max(1, int(np.searchsorted(held, MOST_NUMBERS, side="right")))]
        self.last, parts = first + len(self._steps), grid.parts(self._steps)
        own = self._crossing = crossing(stepper) if needs_crossing(scheme) else None
        # clock and n; step, the one before and the clock; the same of the return to the grid, whose t0 and n are `grid`
        self._part, self._step = Layout({"clock": 2, "whole": 3, "ready": n_c}), Layout({"grid": 2, "back": 3})
        sizes = {"z": n_z, "ready": n_c, "t0": 1, "dt": 1, "never": 1}
        programs = [(stepper.engine, n_z, n_c)]
        if own is not None:
            sizes |= {"cross": own.prepared.z_size, "constants": own.n_c, **dict.fromkeys(marks(), len(ACTS))}
            programs.append((own.engine, own.prepared.z_size, own.n_c))
        of_parts, of_steps = len(parts.start) * self._part.size, len(self._steps) * self._step.size
        self._memory = Layout({**sizes, "parts": of_parts, "steps": of_steps})
        gaps = np.diff(self._steps, prepend=self._steps[0] - 1) - 1
        shifted = np.append(False, parts.clocks != grid.times(self._steps + 1))
        self._between, self._shifted, self._numbers = gaps.tolist(), shifted.tolist(), self._steps.tolist()
        behind = grid.next_broken(self._numbers[-1] + 1)
        self._until = sys.maxsize if behind is None else behind
        rows, self._leads = self._listed(parts)
        self._list = CallList(self._filled(parts, c), programs, rows)
        memory, at = self._list.memory, self._memory.slice
        self._z, self._ready = memory[at("z")], memory[at("ready")]

    def run(self, z: np.ndarray, ready: np.ndarray, number: int, end: int) -> None:
        """Advance z (n_z,) in place to step `end`, or as far as is known here; broken step `number` comes next.

        ready: what the program of the stepper reads for whole steps.
        """
        k, steps = number - self.first, self._numbers
        last = bisect_left(steps, end)
        until = min(end, steps[last] if last < len(steps) else self._until)
        self._whole_steps(k, steps[k] - int(z[1]), z[0] != self._grid.t0)
        self._whole_steps(last, until - steps[last - 1] - 1, self._shifted[last])
        self._z[:], self._ready[:] = z, ready
        self._list.run(self._leads[k], self._leads[last] + LEAD)
        z[:] = self._z
        for one in (k, last):
            if 0 < one < len(steps):  # those at both ends are given by each call
                self._whole_steps(one, self._between[one], self._shifted[one])

    def _whole_steps(self, k: int, n: int, shifted: bool) -> None:
        """So many before broken step k; shifted: the first from a clock behind a jump."""
        first = int(shifted and n > 0)
        self._list.set_counts(self._leads[k], (first, first, n - first))

    def _listed(self, parts: StepParts) -> tuple[np.ndarray, list[int]]:
        """(rows, where those of whole steps before each broken one are, and at last behind all)."""
        at, count = self._memory.slice, len(self._steps)
        rows = CrossingRows(
            self._stepper.scheme, self._stepper.prepared.z_size, self._memory, self._part, self._step, self._crossing
        )
        between = np.array(self._between)
        first = (np.array(self._shifted[:-1]) & (between > 0)).astype(int)  # the clock was set after a jump there
        of_steps = count, at("steps").start, self._step.size
        found, begins, _ = woven(
            repeated([*rows.whole_steps(first, between - first), *rows.opened()], *of_steps),
            repeated(rows.made(), len(parts.start), at("parts").start, self._part.size),
            repeated(rows.closed(), *of_steps),
            parts.counts,
        )
        none = np.zeros(1, dtype=int)
        last = repeated(rows.whole_steps(none, none), 1, 0, 0)[0]
        return np.concatenate([found, last]), [*begins.tolist(), len(found)]

    def _filled(self, parts: StepParts, c: np.ndarray) -> np.ndarray:
        """The memory of the list, with what is known beforehand."""
        grid, scheme, own = self._grid, self._stepper.scheme, self._crossing
        memory, at = np.zeros(self._memory.size), self._memory.slice
        memory[at("t0")], memory[at("dt")], memory[at("never")] = grid.t0, grid.dt, NEVER
        if own is not None:
            memory[at("constants")] = own.prepared.ready(scheme.constants(c))
            for mark, acts in marks().items():
                memory[at(mark)] = acts
        length = within(parts.length, scheme.grid.m)
        last = np.cumsum(parts.counts) - 1
        before = np.append(grid.dt, length[:-1])
        before[last[:-1] + 1] = grid.dt
        columns = {"clock": [parts.start, np.zeros_like(length)], "whole": [length, before, parts.start]}
        of_parts = memory[at("parts")].reshape(len(length), -1)
        for name, values in columns.items():
            of_parts[:, self._part.slice(name)] = np.column_stack(values)
        h = np.array(scheme.grid.h)
        ready = self._stepper.prepared.ready_for_many(c, h * (length / h[0])[:, None])
        of_parts[:, self._part.slice("ready")] = ready
        of_steps, done = memory[at("steps")].reshape(len(last), -1), self._steps + 1
        of_steps[:, self._step.slice("grid")] = np.column_stack([grid.t0 + (parts.clocks - grid.times(done)), done])
        whole = np.full(len(last), grid.dt)
        of_steps[:, self._step.slice("back")] = np.column_stack([whole, length[last], parts.clocks])
        return memory
