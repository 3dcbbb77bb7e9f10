"""CasADi Functions as native code: C by CasADi, the project's flags and cache, loaded as external Functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np

from runtime.engine.compiled import LARGE_SOURCE, compile_source, find_compiler

Call = Callable[[float, np.ndarray], np.ndarray]


def native(function: ca.Function) -> ca.Function:
    """The Function compiled, or itself where there is no C compiler. Raises CompilerError if compiling fails."""
    if find_compiler() is None:
        return function
    generator = ca.CodeGenerator(f"{function.name()}.c")
    generator.add(function)
    source = generator.dump()
    library = compile_source(source, source.count("\n") > LARGE_SOURCE)
    return ca.external(function.name(), str(library))


def buffered(function: ca.Function, c: np.ndarray) -> Call:
    """(t, y) -> the only output of a Function (t, y, c), column by column, through fixed buffers.

    The array it returns is overwritten by the next call.
    """
    buffers: Any = function.buffer()
    buffer, call = buffers
    clock, state = np.zeros(1), np.zeros(function.numel_in(1))
    constants, result = np.array(c, dtype=float), np.zeros(function.numel_out(0))
    for k, array in enumerate((clock, state, constants)):
        buffer.set_arg(k, array.data)
    buffer.set_res(0, result.data)

    def evaluate(t: float, y: np.ndarray, keep: tuple[Any, ...] = (function, buffer, constants)) -> np.ndarray:
        clock[0], state[:] = t, y  # the buffer holds no references: hence keep
        call()
        return result

    return evaluate
