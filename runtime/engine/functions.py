"""CasADi Functions of (t, y, c) called from Python at little cost: as native code, or through CasADi's buffers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np

from runtime.engine.llvm_code import find_llvm
from runtime.engine.native import NativeProgram
from runtime.engine.program import Call

Evaluate = Callable[[float, np.ndarray], np.ndarray]


def evaluator(function: ca.Function, c: np.ndarray, compiled: bool = True) -> Evaluate:
    """(t, y) -> the only output of a Function (t, y, c), column by column; native where LLVM is there and it is asked.

    The array it returns is overwritten by the next call.
    """
    constants = np.array(c, dtype=float)
    return _native(function, constants) if compiled and not find_llvm() else _buffered(function, constants)


def _native(function: ca.Function, c: np.ndarray) -> Evaluate:
    """As a step program on z = [t, y, output]."""
    n, count = function.numel_in(1), function.numel_out(0)
    z_symbol, c_symbol = ca.SX.sym("z", 1 + n + count), ca.SX.sym("c", len(c))
    value = ca.densify(ca.vec(function(z_symbol[0], z_symbol[1 : 1 + n], c_symbol)))
    z_next = ca.vertcat(z_symbol[: 1 + n], value)
    stage = ca.Function(function.name(), [z_symbol, c_symbol], [z_next], ["z", "c"], ["z_next"])
    engine, z = NativeProgram(Call(stage), wait=True), np.zeros(1 + n + count)

    def evaluate(t: float, y: np.ndarray) -> np.ndarray:
        z[0], z[1 : 1 + n] = t, y
        engine.run(z, c, 1)
        return z[1 + n :]

    return evaluate


def _buffered(function: ca.Function, c: np.ndarray) -> Evaluate:
    buffers: Any = function.buffer()
    buffer, call = buffers
    clock, state, result = np.zeros(1), np.zeros(function.numel_in(1)), np.zeros(function.numel_out(0))
    for k, array in enumerate((clock, state, c)):
        buffer.set_arg(k, array.data)
    buffer.set_res(0, result.data)

    def evaluate(t: float, y: np.ndarray, keep: tuple[Any, ...] = (function, buffer, c)) -> np.ndarray:
        clock[0], state[:] = t, y  # the buffer holds no references: hence keep
        call()
        return result

    return evaluate
