"""Many runs of programs, and copies between them, in one native call: nothing but a list of addresses is followed.

A list has rows (which, to, from, n): n numbers are copied (which = 0), or program number `which` is applied n times
to what is at `to` with the constants at `from`. Both are places in one array, the memory of the list.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from runtime.engine.choose import Engine
from runtime.engine.llvm_code import Code, Effort, host, linked, machine_code
from runtime.engine.native import NativeProgram

COPY = 0
NUMBER, ROW = 8, 40  # bytes
FOLLOW = """
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)

define void @copy(ptr %to, ptr %from, ptr %w, i64 %n) nounwind {
  %bytes = shl i64 %n, 3
  call void @llvm.memcpy.p0.p0.i64(ptr %to, ptr %from, i64 %bytes, i1 false)
  ret void
}

define void @follow(ptr %rows, i64 %count) nounwind {
entry:
  br label %head
head:
  %k = phi i64 [ 0, %entry ], [ %next, %body ]
  %go = icmp slt i64 %k, %count
  br i1 %go, label %body, label %done
body:
  %row = getelementptr [5 x i64], ptr %rows, i64 %k
  %at1 = getelementptr i64, ptr %row, i64 1
  %at2 = getelementptr i64, ptr %row, i64 2
  %at3 = getelementptr i64, ptr %row, i64 3
  %at4 = getelementptr i64, ptr %row, i64 4
  %function = load ptr, ptr %row
  %to = load ptr, ptr %at1
  %from = load ptr, ptr %at2
  %w = load ptr, ptr %at3
  %n = load i64, ptr %at4
  call void %function(ptr %to, ptr %from, ptr %w, i64 %n)
  %next = add i64 %k, 1
  br label %head
done:
  ret void
}
"""


@dataclass(frozen=True)
class Row:
    """A row that stands in a list many times: n may be of each time (N,), `source` counted from data of each time."""

    which: int
    to: int
    source: int
    n: int | np.ndarray
    own: bool = False


def repeated(rows: Sequence[Row], count: int, data: int, size: int) -> np.ndarray:
    """(count, len(rows), 4) rows so many times; their own data begin at `data`, so many numbers each."""
    found = np.empty((count, len(rows), 4), dtype=np.int64)
    for k, row in enumerate(rows):
        found[:, k, 0], found[:, k, 1], found[:, k, 3] = row.which, row.to, row.n
        found[:, k, 2] = row.source + (data + size * np.arange(count) if row.own else 0)
    return found


def woven(
    before: np.ndarray, parts: np.ndarray, after: np.ndarray, counts: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(N, 4) rows: those before (S, A, 4), so many parts (P, B, 4) as counts (S,) say, those after (S, C, 4), S times.

    With where each of the S begins and ends (S,).
    """
    ends = np.cumsum(before.shape[1] + parts.shape[1] * counts + after.shape[1])
    begins = np.append(0, ends[:-1])
    rows = np.empty((int(ends[-1]), 4), dtype=np.int64)
    rows[begins[:, None] + np.arange(before.shape[1])] = before
    rows[ends[:, None] - after.shape[1] + np.arange(after.shape[1])] = after
    number = np.arange(len(parts)) - np.repeat(np.cumsum(counts) - counts, counts)
    at = np.repeat(begins + before.shape[1], counts) + parts.shape[1] * number
    rows[at[:, None] + np.arange(parts.shape[1])] = parts
    return rows, begins, ends


class CallList:
    """Rows (N, 4) of whole numbers, done on a memory (M,) that stays where it is.

    programs: engines with the lengths of what they change and of their constants. For one thread at a time.
    """

    def __init__(self, memory: np.ndarray, programs: Sequence[tuple[Engine, int, int]], rows: np.ndarray) -> None:
        self.memory, self._programs, self.rows = memory, list(programs), rows
        self._native = [engine for engine, _, _ in programs if isinstance(engine, NativeProgram)]
        self._addresses = np.zeros((0, 5), dtype=np.int64)
        self._place, self._final = 0, False
        self._codes: tuple[Code, ...] | None = None
        self._work: list[np.ndarray] = []

    def run(self, first: int, last: int) -> None:
        """Do these rows."""
        if self._final:
            _follower()[1](self._place + ROW * first, last - first)
        elif len(self._native) < len(self._programs):
            self._one_by_one(first, last)
        else:
            self._use(first, last, ())

    def set_counts(self, first: int, counts: Sequence[int]) -> None:
        """n of rows from this one on."""
        for k, n in enumerate(counts, first):
            self.rows[k, 3] = n
            if self._place:
                self._addresses[k, 4] = n

    def _use(self, first: int, last: int, codes: tuple[Code, ...]) -> None:
        """With the code that each program has now; what it takes counts as time of all."""
        if len(codes) < len(self._native):
            self._native[len(codes)].tiers.use(lambda code: self._use(first, last, (*codes, code)))
            return
        if codes != self._codes:
            self._addresses, self._codes = self._addressed(codes), codes
            self._place = self._addresses.ctypes.data
            self._final = all(
                one.tiers.final and one.tiers.code is code for one, code in zip(self._native, codes, strict=True)
            )
        _follower()[1](self._place + ROW * first, last - first)

    def _addressed(self, codes: tuple[Code, ...]) -> np.ndarray:
        self._work = [np.zeros(code.work + 1) for code in codes]
        copy, _, _ = _follower()
        functions = np.array([copy, *(int(ctypes.cast(code.run, ctypes.c_void_p).value or 0) for code in codes)])  # type: ignore[arg-type]
        works = np.array([0, *(work.ctypes.data for work in self._work)])
        which, base = self.rows[:, 0], self.memory.ctypes.data
        places = base + NUMBER * self.rows[:, 1:3]
        return np.column_stack([functions[which], places, works[which], self.rows[:, 3]]).astype(np.int64)

    def _one_by_one(self, first: int, last: int) -> None:
        memory = self.memory
        for which, to, source, n in self.rows[first:last].tolist():
            if which == COPY:
                memory[to : to + n] = memory[source : source + n]
            elif n:
                engine, z_size, c_size = self._programs[which - 1]
                engine.run(memory[to : to + z_size], memory[source : source + c_size], n)


@cache
def _follower() -> tuple[int, Callable[[int, int], None], object]:
    """(address of `copy`, `follow`, what must outlive both)."""
    engine = linked(machine_code(FOLLOW, Effort(False, 2), host()), host())
    follow = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64)(engine.get_function_address("follow"))
    return int(engine.get_function_address("copy")), follow, engine
