"""A program as native code without a C compiler: for one run in two tiers, see `llvm_code`, for many in lanes."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from typing import NamedTuple, Protocol

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.tape import arithmetic
from runtime.engine.llvm_code import (
    BEST,
    FIRST_EFFORT,
    INLINED,
    Code,
    Effort,
    ProgramCompiler,
    Tiers,
    best_tier,
    find_llvm,
    first_tier,
    host,
    program_length,
)
from runtime.engine.program import Form, Program


class _Bound(NamedTuple):
    """A call with its addresses filled in, and what must outlive it."""

    call: Callable[[int], None]
    code: Code
    work: np.ndarray

    def go(self, n: int) -> None:
        """Apply the program n times."""
        self.call(n)


class NativeProgram:
    """A program as native code; mathematics: `own` or `library`.

    wait: only the best code will do.
    """

    name = "compiled"

    def __init__(self, program: Program, mathematics: str = "own", wait: bool = False) -> None:
        self.note = ""
        first, best = first_tier(program, mathematics), best_tier(program, mathematics)
        self.tiers = Tiers(ProgramCompiler(program), first, best, program_length(program), wait)
        self._work = threading.local()

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z (z_size,) with constants c, in place."""
        self._advance(z.ctypes.data, c.ctypes.data, n)

    def run_rows(self, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        """Apply the program counts (N,) times, each count followed by a copy of z to the next of rows (N, z_size)."""

        def call(code: Code) -> None:
            own = z.ctypes.data, c.ctypes.data, self._work_array(code.work), counts.ctypes.data
            code.run_rows(*own, len(counts), rows.ctypes.data, rows.strides[0] if len(rows) else 0)

        self.tiers.use(call)

    def each(self, rows: np.ndarray) -> None:
        """Apply the program once to each of rows (N, z_size), in place; it reads no constants."""
        start, (n, _), apart = rows.ctypes.data, rows.shape, rows.strides[0]
        self.tiers.use(lambda code: code.run_blocks(start, start, self._work_array(code.work), 1, n, apart))

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z (z_size,) and c fixed, which must stay where they are: the number of steps is left to give.

        With the best code a call is nothing but native code. It has a work array of its own: for one thread at a time.
        """
        if not self.tiers.final:
            return partial(self._advance, z.ctypes.data, c.ctypes.data)
        code = self.tiers.code
        work = np.zeros(code.work + 1)
        return _Bound(partial(code.run, z.ctypes.data, c.ctypes.data, int(work.ctypes.data)), code, work).go

    def _advance(self, z: int, c: int, n: int) -> None:
        self.tiers.use(lambda code: code.run(z, c, self._work_array(code.work), n))

    def _work_array(self, size: int) -> int:
        """Address of this thread's work array."""
        array = getattr(self._work, "array", None)
        if array is None or len(array) < size:
            array = self._work.array = np.zeros(size + 1)
        return int(array.ctypes.data)


# ---- Which engine runs a program: compiled by LLVM, interpreted only where LLVM cannot be had.

# auto: compiled where LLVM is there; compiled-library: with sin, cos and exp of the C library, equal to interpreted bit
# for bit
ENGINES = ("auto", "compiled", "interpreted", "compiled-library")


class Engine(Protocol):
    """Runs a program n times on z in place. note says why it was chosen where that is worth knowing."""

    name: str
    note: str

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z."""

    def run_rows(self, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        """Apply the program counts (N,) times, each count followed by a copy of z to the next of rows (N, z_size)."""

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z and c fixed, which stay where they are."""


def choose_engine(requested: str, program: Program, z_size: int, c_size: int, wait: bool = False) -> Engine:
    """`requested` is one of ENGINES; auto is compiled, interpreted only where LLVM cannot be had.

    wait: for the best code. Raises ArgumentError for an unknown engine and CompilerError for one that cannot be had.
    """
    if requested not in ENGINES:
        raise ArgumentError(f"engine must be one of {', '.join(ENGINES)}, not {requested!r}")
    missing = find_llvm() if requested == "auto" else ""
    if requested == "interpreted" or missing:
        from runtime.engine.interpreted import InterpretedProgram

        engine: Engine = InterpretedProgram(program, z_size, c_size)
        engine.note = f"the run was interpreted: {missing}" if missing else ""
        return engine
    return NativeProgram(program, "library" if requested == "compiled-library" else "own", wait)


# ---- A program for many runs at once: how many lanes, code for them, and memory for blocks of lanes.
#
# A block is an array (size, width): entry e of lane l at [e, l]. z and c of a program are ranges of its rows.

SHORT = 2_000  # operations: below, two vector registers a value hide the latency of one
LONG_STEP_OPERATIONS = 20_000  # operations: above, passes over code in lanes cost more than they save
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
    if program_size(program) <= LONG_STEP_OPERATIONS:
        return Form(width, "own", 0, False), BEST
    return Form(width, "own", LONG_CHUNK, False), FIRST_EFFORT


def once_form(program: Program, width: int) -> tuple[Form, Effort]:
    """For what is done once a run, with the library's mathematics: the virtual machine's bits."""
    return Form(
        width, "library", LONG_CHUNK if program_size(program) > LONG_STEP_OPERATIONS else 1000, False
    ), FIRST_EFFORT


def blocks_of(count: int, size: int, width: int) -> np.ndarray:
    """Zeros (count, size, width), aligned for vectors of so many lanes."""
    raw = np.zeros(count * size * width + ALIGNMENT // 8)
    first = (-raw.ctypes.data // 8) % (ALIGNMENT // 8)
    return raw[first : first + count * size * width].reshape(count, size, width)


class LaneCode:
    """Code of a program for blocks of `width` lanes. Raises NoLlvm where LLVM cannot be had."""

    def __init__(self, program: Program, form: Form, effort: Effort) -> None:
        self.width = form.width
        self._code = ProgramCompiler(program).build(form, effort)
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
