"""Machine code for derivatives: a program along directions in lanes, and a program that records with its way back."""

from __future__ import annotations

import ctypes
import hashlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from runtime.engine.derivatives import reversal, tangent_program
from runtime.engine.derivatives_ir import reversal_ir
from runtime.engine.derivatives_stage import Active
from runtime.engine.llvm_code import Code, host, linked, machine_code, program_digest, tools
from runtime.engine.llvm_ir import Form
from runtime.engine.object_cache import ObjectCache
from runtime.engine.program import Program
from runtime.engine.tiers import (
    BEST,
    FIRST,
    INLINED,
    OPTIMISED,
    Tier,
    Tiers,
    best_tier,
    code_in_tiers,
    first_tier,
    program_length,
    written_out,
)

PRINTER = ("derivatives", "derivatives_stage", "derivatives_ir", "derivatives_code")  # files of this folder
ADJOINT = 4  # operations of a stage with its adjoint, of one of the stage
LONGEST = 1000  # statements of a function of the first code
Entry = Callable[[int, int, int, int, int], None]


def most_lanes() -> int:
    """Values in a register of this processor, at least 2."""
    features = host().features
    return 8 if "+avx512f" in features else 4 if "+avx2" in features else 2


class LaneArrays:
    """z (rows, width) and c (rows, width) where native code expects them: every row begins at its own alignment."""

    def __init__(self, z_rows: int, c_rows: int, width: int) -> None:
        self.width = width
        self.z, self.c = _aligned(z_rows, width), _aligned(c_rows, width)


def _aligned(rows: int, width: int) -> np.ndarray:
    whole = np.zeros(rows * width + width)
    first = -(whole.ctypes.data // 8) % width
    return whole[first : first + rows * width].reshape(rows, width)


class TangentCode:
    """A program on [z, dz] and [c, dc] in lanes: one direction a lane. For one thread at a time. Raises NoLlvm."""

    def __init__(self, program: Program, active: Active, width: int, wait: bool = False) -> None:
        tangents, self.width = tangent_program(program, active), width
        first, best = (chosen(tangents, "own") for chosen in (first_tier, best_tier))
        first, best = (tier._replace(form=tier.form._replace(width=width)) for tier in (first, best))
        self.tiers = code_in_tiers(tangents, first, best, wait)
        self._work = _aligned(1, width)

    def run(self, arrays: LaneArrays, n: int) -> None:
        """Apply the program n times, in place."""
        self.tiers.use(lambda code: self._go(code, arrays, n))

    def _go(self, code: Code, arrays: LaneArrays, n: int) -> None:
        if len(self._work) < code.work + 1:
            self._work = _aligned(code.work + 1, self.width)
        code.run(arrays.z.ctypes.data, arrays.c.ctypes.data, self._work.ctypes.data, n)


class _Recording(NamedTuple):
    record: Entry
    reverse: Entry
    records: int
    work: int
    keep: Any


class Recorder:
    """A program that records what its way back reads. For one thread at a time. Raises NoLlvm.

    records: numbers that one application puts on the tape.
    """

    def __init__(self, program: Program, active: Active, wait: bool = False) -> None:
        self._program, self._active = program, active
        self._digest = hashlib.sha256(program_digest(program) + tools() + _texts() + repr(active).encode()).digest()
        size = ADJOINT * program_length(program)
        chunk, inline = (300, False) if size > OPTIMISED else (0, written_out(program) <= INLINED)
        best = Tier(Form(1, "own", chunk, inline), BEST)
        first = Tier(Form(1, "own", LONGEST, False), FIRST)
        self.tiers: Tiers[_Recording] = Tiers(self._built, self._is_kept, first, best, size, wait)
        self.records = self.tiers.code.records
        self._work = np.zeros(1)

    def record(self, z: np.ndarray, c: np.ndarray, tape: np.ndarray, n: int) -> None:
        """Apply the program n times to z (z_size,), in place; the tape takes n times `records` numbers."""
        self.tiers.use(lambda code: self._go(code, code.record, (z, c, tape), n))

    def reverse(self, adjoint: np.ndarray, c: np.ndarray, tape: np.ndarray, n: int) -> None:
        """[zbar, cbar] after n recorded applications becomes that before them, in place."""
        self.tiers.use(lambda code: self._go(code, code.reverse, (adjoint, c, tape), n))

    def _go(self, code: _Recording, entry: Entry, arrays: tuple[np.ndarray, np.ndarray, np.ndarray], n: int) -> None:
        z, c, tape = (array.ctypes.data for array in arrays)
        if len(self._work) < code.work + 1:
            self._work = np.zeros(code.work + 1)
        entry(z, c, self._work.ctypes.data, tape, n)

    def _key(self, tier: Tier) -> str:
        text = "\n".join([repr(tier), *host()])
        return hashlib.sha256(self._digest + text.encode()).hexdigest()

    def _is_kept(self, tier: Tier) -> bool:
        return ObjectCache().has(self._key(tier))

    def _built(self, tier: Tier) -> _Recording:
        """From the cache, where neither derivatives nor code have to be made, or new."""
        stored, key = ObjectCache(), self._key(tier)
        found = stored.read(key)
        if found is None:
            back = reversal(self._program, self._active)
            text, work = reversal_ir(back, self._active.z_size, self._active.size, tier.form)
            found = machine_code(text, tier.effort, host()), work
            stored.write(key, *found)
        return _loaded(*found)


def _loaded(code: bytes, work: int) -> _Recording:
    engine = linked(code, host())
    kind = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 4, ctypes.c_int64)
    record, reverse = (kind(engine.get_function_address(name)) for name in ("record", "reverse"))
    records = ctypes.c_int64.from_address(engine.get_global_value_address("records")).value
    return _Recording(record, reverse, records, work, engine)


@cache
def _texts() -> bytes:
    """The text of what decides about the code besides the printer of programs."""
    return "\n".join(Path(__file__).with_name(f"{name}.py").read_text(encoding="utf-8") for name in PRINTER).encode()
