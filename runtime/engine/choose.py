"""Which engine runs a program: compiled by LLVM, interpreted only where LLVM cannot be had."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

import numpy as np

from runtime.contract.doors import opened
from runtime.contract.errors import ArgumentError
from runtime.contract.tape import Tape, arithmetic, code_length
from runtime.engine.llvm_code import find_llvm
from runtime.engine.native import NativeProgram
from runtime.engine.program import Program, Repeat, Until

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


def operations_per_step(program: Program) -> int:
    """Operations of one application (each Until body counted as often as is usual)."""

    def again(body: int, node: Repeat | Until) -> int:
        return body * (node.count if isinstance(node, Repeat) else node.usual)

    return program.fold(code_length, lambda parts: sum(parts), again)


def sub_step_operations(program: Program) -> int | None:
    """Arithmetic operations of the innermost repeated part, None if nothing is repeated."""

    def again(body: int | None, node: Repeat | Until) -> int | None:
        if isinstance(node, Until):
            return None
        return body if body is not None else sum(arithmetic(stage) for stage in node.body.stages())

    def last(parts: list[int | None]) -> int | None:
        return next((count for count in reversed(parts) if count is not None), None)

    return program.fold(lambda stage: None, last, again)


def choose_engine(
    requested: str,
    program: Program,
    z_size: int,
    c_size: int,
    wait: bool = False,
    tapes: Mapping[str, Tape] | None = None,
) -> Engine:
    """`requested` is one of ENGINES; auto is compiled, interpreted only where LLVM cannot be had.

    wait: for the best code. tapes: of stages by name, where they are known. Raises ArgumentError for an unknown engine
    and CompilerError for one that cannot be had.
    """
    if requested not in ENGINES:
        raise ArgumentError(f"engine must be one of {', '.join(ENGINES)}, not {requested!r}")
    missing = find_llvm() if requested == "auto" else ""
    if requested == "interpreted" or missing:
        engine: Engine = opened("runtime.engine.interpreted:InterpretedProgram")(program, z_size, c_size)
        engine.note = f"the run was interpreted: {missing}" if missing else ""
        return engine
    return NativeProgram(program, "library" if requested == "compiled-library" else "own", wait, tapes)
