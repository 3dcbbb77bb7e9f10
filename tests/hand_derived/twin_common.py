"""Shared by the hand-derived twins: array alias and complex-step Jacobian."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

# Small enough that the truncation error (step^2) vanishes; no subtraction, so nothing cancels.
STEP = 1e-40


def complex_step(function: Callable[[Array], Array], x: Array) -> Array:
    """Jacobian of a real-analytic `function` at the real point `x` (n,): column j = Im f(x + i h e_j) / h."""
    x = np.asarray(x, dtype=float)
    columns = []
    for j in range(x.size):
        shifted = x.astype(complex)
        shifted[j] += 1j * STEP
        columns.append(np.imag(function(shifted)) / STEP)
    return np.stack(columns, axis=-1)
