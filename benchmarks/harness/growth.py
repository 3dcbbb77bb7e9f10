"""How a quantity grows with size: y = a N^b, or two such laws that meet, fitted to logarithms by least squares."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

FEWEST_TO_BREAK = 5  # points; with fewer a break is not looked for
BETTER, APART = 0.25, 0.3  # a break leaves at most this share of the squares, and its exponents differ by this


@dataclass(frozen=True)
class Growth:
    """exponents: one, or two that meet at the size `at`."""

    exponents: tuple[float, ...]
    at: float | None = None

    def __str__(self) -> str:
        parts = [f"{round(exponent, 2) + 0.0:.2f}" for exponent in self.exponents]  # no -0.00
        return parts[0] if self.at is None else f"{parts[0]}, from {self.at:g} on {parts[1]}"


def growth(sizes: Sequence[float], values: Sequence[float]) -> Growth:
    """The law that fits: a break, at one of the inner sizes, only where that fits much better.

    Raises ValueError for fewer than two sizes.
    """
    if len(sizes) < 2:
        raise ValueError("growth needs two sizes at least")
    x, y = np.log(np.asarray(sizes, dtype=float)), np.log(np.asarray(values, dtype=float))
    (_, exponent), left = _fit(np.stack([np.ones_like(x), x], axis=1), y)
    best = Growth((float(exponent),))
    if len(x) < FEWEST_TO_BREAK:
        return best
    least = BETTER * left
    for k in range(1, len(x) - 1):
        (_, first, more), found = _fit(np.stack([np.ones_like(x), x, np.maximum(x - x[k], 0)], axis=1), y)
        if found < least and abs(more) > APART:
            best, least = Growth((float(first), float(first + more)), float(sizes[k])), found
    return best


def _fit(columns: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, float]:
    """(coefficients, sum of the squares that are left)."""
    found = np.linalg.lstsq(columns, y, rcond=None)[0]
    return found, float(((columns @ found - y) ** 2).sum())
