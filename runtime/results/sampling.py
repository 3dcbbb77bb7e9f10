"""Functions at many samples: rows in, rows out."""

from __future__ import annotations

from functools import lru_cache

import casadi as ca
import numpy as np

from runtime.engine.rows import RowFunction


@lru_cache(maxsize=256)
def _rows(function: ca.Function) -> RowFunction:
    return RowFunction(function)


def evaluate(function: ca.Function, values: dict[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """Outputs (N, size) of a Function at N samples (rows of each value), matrices flattened column by column.

    c: (c_size,) of all samples, or a row of each (N, c_size).
    """
    return _rows(function)(values, c)
