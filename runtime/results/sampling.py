"""Functions at many samples: rows in, rows out."""

from __future__ import annotations

from functools import lru_cache

import casadi as ca
import numpy as np

BLOCK = 256  # samples a call


@lru_cache(maxsize=64)
def _mapped(function: ca.Function, size: int, one_c: bool) -> ca.Function:
    """The Function of `size` samples a call; building one takes time for each sample."""
    constant = [k for k, name in enumerate(function.name_in()) if name == "c" and one_c]
    return function.map("samples", "serial", size, constant, [])


def evaluate(function: ca.Function, values: dict[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """Outputs (N, size) of a Function at N samples (rows of each value), matrices flattened column by column.

    c: (c_size,) of all samples, or a row of each (N, c_size).
    """
    n = next(iter(values.values())).shape[0]
    size = min(BLOCK, 1 << max(0, n - 1).bit_length())  # few sizes
    mapped = _mapped(function, size, c.ndim == 1)
    output = {name: np.zeros((n, function.numel_out(name))) for name in function.name_out()}
    for first in range(0, n, size):
        rows = np.minimum(np.arange(first, first + size), n - 1)
        columns: dict[str, np.ndarray] = {
            name: (c[:, None] if c.ndim == 1 else c[rows].T) if name == "c" else values[name][rows].T
            for name in function.name_in()
        }
        result = mapped(**columns)
        for name, table in output.items():
            height, width = function.size_out(name)
            block = np.asarray(result[name], dtype=float).reshape(height, size, width)
            table[first : first + size] = block.transpose(1, 2, 0).reshape(size, -1)[: n - first]
    return output
