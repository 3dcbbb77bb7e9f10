"""A step program for many runs at once: how many lanes, code for them, and memory for blocks of lanes.

A block is an array (size, width): entry e of lane l at [e, l]. z and c of a program are ranges of its rows.
"""

from __future__ import annotations

import threading

import numpy as np

from runtime.contract.tape import arithmetic
from runtime.engine.llvm_code import BEST, FIRST, INLINED, Compiler, Effort, host
from runtime.engine.program import Form, Program

SHORT = 2_000  # operations: below, two vector registers a value hide the latency of one
LONG = 20_000  # operations: above, passes over code in lanes cost more than they save
LONG_CHUNK = 100
ALIGNMENT = 128  # bytes, of 16 lanes


def lane_width(program: Program) -> int:
    """How many runs go side by side on this machine."""
    features = host().features
    if "+avx512f" in features:
        return 16 if program_size(program) < SHORT else 8
    return 4 if "+avx" in features else 2


def program_size(program: Program) -> int:
    """Operations of its distinct stages; what they pass on costs nothing in lanes."""
    return sum(arithmetic(stage) for stage in program.stages())


def lane_form(program: Program, width: int) -> tuple[Form, Effort]:
    """How steps are compiled for so many lanes: with own mathematics."""
    written_out = program.fold(arithmetic, lambda parts: sum(parts), lambda body, node: body)
    if written_out <= INLINED:
        return Form(width, "own", 0, True), BEST
    if program_size(program) <= LONG:
        return Form(width, "own", 0, False), BEST
    return Form(width, "own", LONG_CHUNK, False), FIRST


def once_form(program: Program, width: int) -> tuple[Form, Effort]:
    """For what is done once a run, with the library's mathematics: the virtual machine's bits."""
    return Form(width, "library", LONG_CHUNK if program_size(program) > LONG else 1000, False), FIRST


def blocks_of(count: int, size: int, width: int) -> np.ndarray:
    """Zeros (count, size, width), aligned for vectors of so many lanes."""
    raw = np.zeros(count * size * width + ALIGNMENT // 8)
    first = (-raw.ctypes.data // 8) % (ALIGNMENT // 8)
    return raw[first : first + count * size * width].reshape(count, size, width)


class LaneCode:
    """Code of a program for blocks of `width` lanes. Raises NoLlvm where LLVM cannot be had."""

    def __init__(self, program: Program, form: Form, effort: Effort) -> None:
        self.width = form.width
        self._code = Compiler(program).build(form, effort)
        self._work = threading.local()

    def run(self, blocks: np.ndarray, z: int, c: int, n: int) -> None:
        """Apply the program n times to each of the blocks (count, size, width), whose z and c begin at these rows.

        Several threads may do so at once; Python goes on meanwhile.
        """
        count, size, width = blocks.shape
        start, row = blocks.ctypes.data, 8 * width
        self._code.run_blocks(start + z * row, start + c * row, self._own_work(), n, count, size * row)

    def _own_work(self) -> int:
        array = getattr(self._work, "array", None)
        if array is None:
            array = self._work.array = blocks_of(1, self._code.work + 1, self.width)
        return int(array.ctypes.data)
