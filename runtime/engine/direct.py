"""CasADi Functions called from Python at little cost."""

from __future__ import annotations

from threading import Lock
from typing import Any

import casadi as ca
import numpy as np


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

    def many(self, points: np.ndarray, sizes: list[int], size: int) -> np.ndarray:
        """(N, size) of what it gives at points (N, sum of sizes), arguments one after another."""
        found = np.empty((len(points), size))
        ends = np.cumsum([0, *sizes]).tolist()
        with self._lock:
            own = [(array, ends[k], ends[k + 1]) for k, array in enumerate(self._arguments) if sizes[k]]
            call, result = self._call, self._result
            for point, row in zip(points, found, strict=True):
                for array, first, last in own:
                    array[:] = point[first:last]
                call()
                row[:] = result
        return found
