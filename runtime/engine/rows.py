"""An SX Function at many points: by CasADi's buffers where there are few, by native code of the same bits for many."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from threading import Lock
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.tape import UNUSED, marked, read_tape
from runtime.engine.llvm_code import find_llvm
from runtime.engine.native import NativeProgram
from runtime.engine.program import Call

# ---- CasADi Functions called from Python at little cost.


class Direct:
    """A Function called on arrays through CasADi's buffers: without conversions, which cost more than small functions.

    All outputs come as one vector, column by column. Threads that share it wait for one another.
    """

    def __init__(self, function: ca.Function) -> None:
        symbols = [ca.MX.sym(f"x{k}", *function.size_in(k)) for k in range(function.n_in())]
        found = ca.vertcat(*(ca.densify(ca.vec(one)) for one in function.call(symbols)))
        dense = ca.Function("direct", symbols, [ca.densify(found)])
        self._arguments = [np.zeros(dense.numel_in(k)) for k in range(dense.n_in())]
        self._result = np.zeros(dense.numel_out(0))
        buffers: Any = dense.buffer()
        self._kept, self._call = (dense, buffers[0]), buffers[1]  # the buffer holds no references
        for k, array in enumerate(self._arguments):
            buffers[0].set_arg(k, array.data)
        buffers[0].set_res(0, self._result.data)
        self._lock = Lock()  # runs of one model in several threads have its arrays in common

    def __call__(self, *arguments: np.ndarray | float) -> np.ndarray:
        """(size,) a copy of what it gives."""
        with self._lock:
            for own, one in zip(self._arguments, arguments, strict=True):
                own[:] = one
            self._call()
            return self._result.copy()

    def many(self, arguments: list[np.ndarray], shape: tuple[int, int]) -> np.ndarray:
        """(N, size), its shape, of what it gives for arguments (N, .); a vector is that of all points."""
        found = np.empty(shape)
        with self._lock:
            rows = []
            for own, one in zip(self._arguments, arguments, strict=True):
                if one.ndim == 1:
                    own[:] = one
                elif one.shape[1]:
                    rows.append((own, one))
            call, result = self._call, self._result
            for k in range(len(found)):
                for own, one in rows:
                    own[:] = one[k]
                call()
                found[k] = result
        return found


FEW_POINTS = 4000  # points: until then making native code takes longer than the virtual machine, whatever the length
CONSTANTS = "c"


class RowFunction:
    """Arguments and outputs are rows: values by name (N, size), outputs by name (N, size), column by column.

    The argument `c` is one vector for all points, or a row of each.
    """

    def __init__(self, function: ca.Function) -> None:
        self._function, self._direct = function, Direct(function)
        self._names = function.name_in()
        self._sizes = [int(function.numel_in(k)) for k in range(function.n_in())]
        self._outputs = {name: int(function.numel_out(name)) for name in function.name_out()}
        self._left = FEW_POINTS if function.is_a("SXFunction") else np.inf
        self._native: NativeProgram | None = None
        self._lock = Lock()

    def __call__(self, values: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
        n, whole = len(next(iter(values.values()))), sum(self._outputs.values())
        arguments = [
            (c if c.ndim == 1 else c[:n]) if name == CONSTANTS else np.reshape(values[name], (n, size))
            for name, size in zip(self._names, self._sizes, strict=True)
        ]
        self._left -= n
        by_calls = self._left > 0 or find_llvm()
        found = self._direct.many(arguments, (n, whole)) if by_calls else self._by_native(arguments, n)
        ends = np.cumsum([0, *self._outputs.values()]).tolist()
        return {name: found[:, ends[k] : ends[k + 1]].copy() for k, name in enumerate(self._outputs)}

    def _by_native(self, arguments: list[np.ndarray], n: int) -> np.ndarray:
        with self._lock:
            if self._native is None:
                self._native = NativeProgram(Call(_at_a_point(self._function)), "library")
        rows, first = np.empty((n, sum(self._sizes) + sum(self._outputs.values()))), 0
        for size, one in zip(self._sizes, arguments, strict=True):
            rows[:, first : first + size], first = one, first + size
        self._native.each(rows)
        return rows[:, first:]


def _at_a_point(function: ca.Function) -> ca.Function:
    """(z, c) -> z: arguments and outputs one after another; no constants."""
    sizes = [int(function.numel_in(k)) for k in range(function.n_in())]
    outputs = sum(int(function.numel_out(k)) for k in range(function.n_out()))
    z, c = ca.SX.sym("z", sum(sizes) + outputs), ca.SX.sym("c", 1)
    ends = np.cumsum([0, *sizes]).tolist()
    given = [ca.reshape(z[ends[k] : ends[k + 1]], *function.size_in(k)) for k in range(function.n_in())]
    found = ca.vertcat(*(ca.densify(ca.vec(ca.SX(one))) for one in function.call(given)))
    return ca.Function("at_a_point", [z, c], [ca.densify(ca.vertcat(z[: ends[-1]], found))], ["z", "c"], ["z_next"])


# ---- Values of straight-line code at many points at once, by NumPy: a hundredth of the time of as many calls.

UNARY: dict[int, Callable[..., np.ndarray]] = {
    ca.OP_NEG: np.negative,
    ca.OP_TWICE: lambda x: 2 * x,
    ca.OP_NOT: lambda x: np.equal(x, 0) * 1.0,
    ca.OP_SQ: np.square,
    ca.OP_FABS: np.abs,
    ca.OP_INV: lambda x: 1 / x,
    ca.OP_SQRT: np.sqrt,
    ca.OP_EXP: np.exp,
    ca.OP_LOG: np.log,
    ca.OP_SIN: np.sin,
    ca.OP_COS: np.cos,
    ca.OP_TAN: np.tan,
    ca.OP_ATAN: np.arctan,
    ca.OP_TANH: np.tanh,
    ca.OP_SIGN: np.sign,
    ca.OP_FLOOR: np.floor,
    ca.OP_CEIL: np.ceil,
}
BINARY: dict[int, Callable[..., np.ndarray]] = {
    ca.OP_ADD: np.add,
    ca.OP_SUB: np.subtract,
    ca.OP_MUL: np.multiply,
    ca.OP_DIV: np.divide,
    ca.OP_POW: np.power,
    ca.OP_CONSTPOW: np.power,
    ca.OP_LT: lambda a, b: np.less(a, b) * 1.0,
    ca.OP_LE: lambda a, b: np.less_equal(a, b) * 1.0,
    ca.OP_EQ: lambda a, b: np.equal(a, b) * 1.0,
    ca.OP_NE: lambda a, b: np.not_equal(a, b) * 1.0,
    ca.OP_AND: lambda a, b: (np.not_equal(a, 0) & np.not_equal(b, 0)) * 1.0,
    ca.OP_OR: lambda a, b: (np.not_equal(a, 0) | np.not_equal(b, 0)) * 1.0,
    ca.OP_FMIN: np.fmin,
    ca.OP_FMAX: np.fmax,
    ca.OP_FMOD: np.fmod,
    ca.OP_IF_ELSE_ZERO: lambda a, b: np.where(np.not_equal(a, 0), b, 0.0),
}


class ManyPoints:
    """The first output (m,) of an SX Function of one vector (n,), at points (N, n) at once.

    Roundings of functions such as exp may be others than CasADi's.
    """

    def __init__(self, function: ca.Function) -> None:
        self._function, self._tape = function, read_tape(function)
        known = {ca.OP_INPUT, ca.OP_CONST, ca.OP_CALL, *UNARY, *BINARY}
        self._by_calls = not all(node.op in known for node in self._tape.nodes)

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """(N, m)."""
        if self._by_calls:
            return np.asarray(self._function(points.T)).T
        values = list[np.ndarray | float]()
        with np.errstate(all="ignore"):
            for op, a, b, value in self._tape.nodes:
                if op == ca.OP_INPUT:
                    values.append(points[:, b])
                elif op == ca.OP_CONST:
                    values.append(value)
                elif op == ca.OP_CALL:
                    table, order = marked(value)
                    values.append(table(np.asarray(values[a]), order))
                else:
                    values.append(UNARY[op](values[a]) if b == UNUSED else BINARY[op](values[a], values[b]))
        found = np.empty((len(points), len(self._tape.outputs[0])))
        for entry, k in enumerate(self._tape.outputs[0]):
            found[:, entry] = values[k]
        return found


# ---- CasADi Functions of (t, y, c) called from Python at little cost: as native code, or through buffers.

Evaluate = Callable[[float, np.ndarray], np.ndarray]


def evaluator(function: ca.Function, c: np.ndarray, compiled: bool = True) -> Evaluate:
    """(t, y) -> the only output of a Function (t, y, c), column by column; native where LLVM is there and it is asked.

    The array it returns may be overwritten by the next call.
    """
    constants = np.array(c, dtype=float)
    if not compiled or find_llvm():
        direct = Direct(function)
        return lambda t, y: direct(t, y, constants)
    engine, n = NativeProgram(Call(_at_a_point(function)), wait=True), function.numel_in(1)
    row = np.concatenate([np.zeros(1 + n), constants, np.zeros(function.numel_out(0))])[None, :]

    def evaluate(t: float, y: np.ndarray) -> np.ndarray:
        row[0, 0], row[0, 1 : 1 + n] = t, y
        engine.each(row)
        return np.asarray(row[0, 1 + n + len(constants) :])

    return evaluate


# ---- Functions at many samples: rows in, rows out.


_rows = lru_cache(maxsize=256)(RowFunction)


def evaluate(function: ca.Function, values: dict[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """Outputs (N, size) of a Function at N samples (rows of each value), matrices flattened column by column.

    c: (c_size,) of all samples, or a row of each (N, c_size).
    """
    return _rows(function)(values, c)
