"""A program as native code without a C compiler: code at once, better code when the run has lasted long enough.

The first code takes some 10 us an operation to make. Once the run has taken as long as better code is expected to
take, that is made in a background thread, and the next call uses it: the same bits, so a run may change over any time.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from runtime.engine.llvm_code import Code, Compiler, Effort
from runtime.engine.llvm_ir import Form
from runtime.engine.program import Program

INLINED = 10_000  # operations with every call written out: below, stages are inlined and z is local
WHOLE = 70_000  # below, each stage is one function when it is optimised
LONG = 50_000  # above, the first code is fetched faster in short functions
OPTIMISED = 200_000  # above, no passes
FIRST = Effort(passes=False, level=0)
BEST = Effort(passes=True, level=2)
BEST_SECONDS_PER_OPERATION = 6e-5


def first_form(program: Program, mathematics: str) -> tuple[Form, Effort]:
    """How a program is compiled at once."""
    return Form(1, mathematics, 100 if _size(program) > LONG else 1000, False), FIRST


def best_form(program: Program, mathematics: str) -> tuple[Form, Effort]:
    """How it is compiled for a long run."""
    written_out = program.fold(lambda stage: stage.n_instructions(), lambda parts: sum(parts), lambda body, node: body)
    if written_out <= INLINED:
        return Form(1, mathematics, 0, True), BEST
    size = _size(program)
    if size <= WHOLE:
        return Form(1, mathematics, 0, False), BEST
    return Form(1, mathematics, 300, False), BEST if size <= OPTIMISED else Effort(passes=False, level=2)


def _size(program: Program) -> int:
    return sum(stage.n_instructions() for stage in program.stages())


class _Bound(NamedTuple):
    """A call with its addresses filled in, and what must outlive it."""

    call: Callable[[int], None]
    code: Code
    work: np.ndarray

    def go(self, n: int) -> None:
        """Apply the program n times."""
        self.call(n)


class NativeProgram:
    """A program as native code; mathematics: `own` or `library`. wait: only the best code will do."""

    name = "compiled"

    def __init__(self, program: Program, mathematics: str = "own", wait: bool = False) -> None:
        self.note = ""
        self._compiler = Compiler(program)
        self._best = best_form(program, mathematics)
        self._price = _size(program) * BEST_SECONDS_PER_OPERATION
        self._spent = 0.0
        self._builder: threading.Thread | None = None
        self._work = threading.local()
        self.final = wait or self._compiler.is_kept(*self._best)
        self._code: Code = self._compiler.build(*(self._best if self.final else first_form(program, mathematics)))

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z (z_size,) with constants c, in place."""
        self._advance(z.ctypes.data, c.ctypes.data, n)

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z (z_size,) and c fixed, which must stay where they are: the number of steps is left to give.

        With the best code a call is nothing but native code. It has a work array of its own: for one thread at a time.
        """
        if not self.final:
            return partial(self._advance, z.ctypes.data, c.ctypes.data)
        work = np.zeros(self._code.work + 1)
        return _Bound(partial(self._code.run, z.ctypes.data, c.ctypes.data, int(work.ctypes.data)), self._code, work).go

    def _advance(self, z: int, c: int, n: int) -> None:
        code = self._code  # one code for the whole call, whatever the builder does meanwhile
        began = time.perf_counter()
        code.run(z, c, self._work_array(code.work), n)
        if not self.final:
            self._spent += time.perf_counter() - began
            if self._spent > self._price and self._builder is None:
                self._builder = threading.Thread(target=self._improve, name="symgen better code")
                self._builder.start()

    def finish(self) -> None:
        """Change to the best code now, and wait for it."""
        if self._builder is not None:
            self._builder.join()
        elif not self.final:
            self._improve()

    def _improve(self) -> None:
        self._code = self._compiler.build(*self._best)
        self.final = True

    def _work_array(self, size: int) -> int:
        """Address of this thread's work array."""
        array = getattr(self._work, "array", None)
        if array is None or len(array) < size:
            array = self._work.array = np.zeros(size + 1)
        return int(array.ctypes.data)
