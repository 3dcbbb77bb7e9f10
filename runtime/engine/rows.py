"""An SX Function at many points: by CasADi's buffers where there are few, by native code of the same bits for many."""

from __future__ import annotations

from collections.abc import Mapping
from threading import Lock

import casadi as ca
import numpy as np

from runtime.engine.direct import Direct
from runtime.engine.llvm_code import find_llvm
from runtime.engine.native import NativeProgram
from runtime.engine.program import Call

FEW = 2_000_000  # operations of all points: below, making native code takes longer than the virtual machine
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
        self._operations = int(function.n_instructions()) if function.is_a("SXFunction") else 0
        self._native: NativeProgram | None = None
        self._lock = Lock()

    def __call__(self, values: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
        n = next(iter(values.values())).shape[0]
        points = np.empty((n, sum(self._sizes)))
        first = 0
        for name, size in zip(self._names, self._sizes, strict=True):
            given = (c if c.ndim == 1 else c[:n]) if name == CONSTANTS else np.reshape(values[name], (n, size))
            points[:, first : first + size] = given
            first += size
        found = self._by_native(points) if self._worth(n) else self._by_calls(points)
        ends = np.cumsum([0, *self._outputs.values()]).tolist()
        return {name: found[:, ends[k] : ends[k + 1]].copy() for k, name in enumerate(self._outputs)}

    def _worth(self, n: int) -> bool:
        return n * self._operations > FEW and not find_llvm()

    def _by_calls(self, points: np.ndarray) -> np.ndarray:
        return self._direct.many(points, self._sizes, sum(self._outputs.values()))

    def _by_native(self, points: np.ndarray) -> np.ndarray:
        with self._lock:
            if self._native is None:
                self._native = NativeProgram(Call(self._stage()), "library")
        rows = np.concatenate([points, np.zeros((len(points), sum(self._outputs.values())))], axis=1)
        nothing = np.zeros(1)
        for row in rows:
            self._native.run(row, nothing, 1)
        return rows[:, points.shape[1] :]

    def _stage(self) -> ca.Function:
        """(z, c) -> z: arguments and outputs one after another; no constants."""
        size = sum(self._sizes)
        z, c = ca.SX.sym("z", size + sum(self._outputs.values())), ca.SX.sym("c", 1)
        ends = np.cumsum([0, *self._sizes]).tolist()
        given = [ca.reshape(z[ends[k] : ends[k + 1]], *self._function.size_in(k)) for k in range(self._function.n_in())]
        found = ca.vertcat(*(ca.densify(ca.vec(ca.SX(one))) for one in self._function.call(given)))
        return ca.Function("at_a_point", [z, c], [ca.densify(ca.vertcat(z[:size], found))], ["z", "c"], ["z_next"])
