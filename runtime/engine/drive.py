"""Many calls of a step in one: states are written to rows on the way, without Python in between."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache

import numpy as np

from runtime.engine.llvm_code import Effort, host, linked, machine_code

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


def drive(step: int, z: int, c: int, work: int, counts: np.ndarray, rows: np.ndarray) -> None:
    """Call step(z, c, work, n) for each n of counts (N,) int64, and copy z to the next of rows (N, size) after each.

    step, z, c, work: addresses.
    """
    _drive()[0](
        step, z, c, work, counts.ctypes.data, len(counts), rows.ctypes.data, rows.strides[0] if len(rows) else 0
    )
