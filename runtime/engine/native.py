"""A program as native code without a C compiler, in two tiers; see `llvm_code`."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import NamedTuple

import numpy as np

from runtime.contract.tape import Tape
from runtime.engine.llvm_code import Code, Effort, best_tier, code_in_tiers, first_tier, host, linked, machine_code
from runtime.engine.program import Program


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

    wait: only the best code will do. tapes: of stages by name, where they are known.
    """

    name = "compiled"

    def __init__(
        self,
        program: Program,
        mathematics: str = "own",
        wait: bool = False,
        tapes: Mapping[str, Tape] | None = None,
    ) -> None:
        self.note = ""
        first, best = first_tier(program, mathematics), best_tier(program, mathematics)
        self.tiers = code_in_tiers(program, first, best, wait, tapes or {})
        self._work = threading.local()

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z (z_size,) with constants c, in place."""
        self._advance(z.ctypes.data, c.ctypes.data, n)

    def run_rows(self, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        """Apply the program counts (N,) times, each count followed by a copy of z to the next of rows (N, z_size)."""

        def call(code: Code) -> None:
            address = ctypes.cast(code.run, ctypes.c_void_p).value  # type: ignore[arg-type]
            assert address is not None
            own = z.ctypes.data, c.ctypes.data, self._work_array(code.work), counts.ctypes.data
            _drive()[0](address, *own, len(counts), rows.ctypes.data, rows.strides[0] if len(rows) else 0)

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


# ---- Many calls of a step in one: states are written to rows on the way, without Python in between.

IR = """
declare void @llvm.memcpy.p0i8.p0i8.i64(i8*, i8*, i64, i1)

define void @drive(void (double*, double*, double*, i64)* %step, double* %z, double* %c, double* %w,
                   i64* %counts, i64 %rows, i8* %out, i64 %bytes) {
entry:
  %none = icmp eq i64 %rows, 0
  br i1 %none, label %done, label %next
next:
  %k = phi i64 [ 0, %entry ], [ %more, %next ]
  %place = phi i8* [ %out, %entry ], [ %after, %next ]
  %address = getelementptr i64, i64* %counts, i64 %k
  %count = load i64, i64* %address
  call void %step(double* %z, double* %c, double* %w, i64 %count)
  %state = bitcast double* %z to i8*
  call void @llvm.memcpy.p0i8.p0i8.i64(i8* %place, i8* %state, i64 %bytes, i1 false)
  %after = getelementptr i8, i8* %place, i64 %bytes
  %more = add i64 %k, 1
  %going = icmp ult i64 %more, %rows
  br i1 %going, label %next, label %done
done:
  ret void
}
"""
Drive = Callable[[int, int, int, int, int, int, int, int], None]


@cache
def _drive() -> tuple[Drive, object]:
    """(the function, what keeps it alive)."""
    engine = linked(machine_code(IR, Effort(passes=False, level=1), host()), host())
    pointers, numbers = ctypes.c_void_p, ctypes.c_int64
    kind = ctypes.CFUNCTYPE(None, *[pointers] * 5, numbers, pointers, numbers)
    return kind(engine.get_function_address("drive")), engine
