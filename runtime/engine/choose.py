"""Which engine runs a program: compiled where a compiler is there and pays, interpreted otherwise."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.engine.compiled import CompiledProgram, CompilerError, find_compiler
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.program import Program, Repeat, Until

VM_SECONDS_PER_OPERATION = 5e-9
COMPILE_SECONDS_PER_OPERATION = 1.5e-4
COMPILE_SECONDS = 0.1


class Engine(Protocol):
    """Runs a program n times on z in place. note says why it was chosen where that is worth knowing."""

    name: str
    note: str

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z."""

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z and c fixed, which stay where they are."""


def operations_per_step(program: Program) -> int:
    """Operations of one application (each Until body counted as often as is usual)."""

    def again(body: int, node: Repeat | Until) -> int:
        return body * (node.count if isinstance(node, Repeat) else node.usual)

    return program.fold(lambda stage: int(stage.n_instructions()), lambda parts: sum(parts), again)


def arithmetic(stage: ca.Function) -> int:
    """Operations of a stage without reading and writing its arguments."""
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_PARAMETER)
    return sum(stage.instruction_id(k) not in moves for k in range(stage.n_instructions()))


def sub_step_operations(program: Program) -> int | None:
    """Arithmetic operations of the innermost repeated part, None if nothing is repeated."""

    def again(body: int | None, node: Repeat | Until) -> int | None:
        if isinstance(node, Until):
            return None
        return body if body is not None else sum(arithmetic(stage) for stage in node.body.stages())

    def last(parts: list[int | None]) -> int | None:
        return next((count for count in reversed(parts) if count is not None), None)

    return program.fold(lambda stage: None, last, again)


def choose_engine(requested: str, program: Program, z_size: int, c_size: int, steps: int) -> Engine:
    """`requested` is auto, compiled or interpreted. auto compiles when that is expected to save time.

    Raises ArgumentError for an unknown one and CompilerError when `compiled` cannot be had.
    """
    if requested not in ("auto", "compiled", "interpreted"):
        raise ArgumentError(f"engine must be auto, compiled or interpreted, not {requested!r}")
    if requested == "auto":
        interpreted = operations_per_step(program) * steps * VM_SECONDS_PER_OPERATION
        size = sum(stage.n_instructions() for stage in program.stages())
        pays = interpreted > COMPILE_SECONDS + size * COMPILE_SECONDS_PER_OPERATION
        return (
            _compiled_if_possible(program, z_size, c_size)
            if pays and find_compiler()
            else InterpretedProgram(program, z_size, c_size)
        )
    return CompiledProgram(program) if requested == "compiled" else InterpretedProgram(program, z_size, c_size)


def _compiled_if_possible(program: Program, z_size: int, c_size: int) -> Engine:
    try:
        return CompiledProgram(program)
    except CompilerError as error:
        engine = InterpretedProgram(program, z_size, c_size)
        engine.note = f"compiling failed, so the run was interpreted: {error}"
        return engine
