"""Setting round-off to exact zero, so that structural zeros can be left out of generated code."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

RELATIVE_ZERO = 1e-12


def clean(array: Array, scale: float | None = None) -> Array:
    """Copy of `array` (any shape) with every entry below 1e-12 * `scale` in magnitude set to exactly 0.

    `scale` is in the unit of the entries; without it, the largest magnitude in the array is taken. Give the
    size of the terms that were added up when a whole sum may vanish: its largest entry is then round-off.
    """
    values = np.array(array, dtype=np.float64)
    if values.size == 0:
        return values
    limit = RELATIVE_ZERO * (float(np.max(np.abs(values))) if scale is None else abs(scale))
    values[np.abs(values) <= limit] = 0.0
    return values


def fixed(array: Array) -> Array:
    """`array`, marked read-only: modal data are shared between bodies and must not change under them."""
    values = np.ascontiguousarray(array, dtype=np.float64)
    values.setflags(write=False)
    return values


def symmetric(array: Array) -> Array:
    """Exactly symmetric part over the last two axes."""
    return 0.5 * (array + np.swapaxes(array, -1, -2))
