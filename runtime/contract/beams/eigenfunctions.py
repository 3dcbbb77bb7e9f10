"""Eigenfunctions of a uniform beam and of a uniform bar in closed form, by the way their ends are held (Eq. 19)."""

from __future__ import annotations

import numpy as np

from runtime.contract.beams.shape_functions import Array, ShapeFunctions

# end -> orders of the derivatives that vanish there
BENDING_CONDITIONS = {"clamped": (0, 1), "pinned": (0, 2), "free": (2, 3)}
STRETCHING_CONDITIONS = {"fixed": 0, "free": 1}
ROOT_STEPS = 12


def bending_functions(start: str, end: str, count: int) -> ShapeFunctions:
    """First `count` elastic bending eigenfunctions, phi'''' = b^4 phi, in any scale; frequencies are b^2.

    start, end: "clamped", "pinned" or "free"; rigid motions are left out.
    """
    numbers = bending_wave_numbers(start, end, count)
    waves = np.zeros((count, 4, count))
    for k, b in enumerate(numbers):
        rows = [_values(b, 0.0, order) for order in BENDING_CONDITIONS[start]]
        rows += [_values(b, 1.0, order) for order in BENDING_CONDITIONS[end]]
        waves[k, :, k] = np.linalg.svd(np.array(rows))[2][-1]
    return ShapeFunctions(np.zeros((4, count)), numbers, waves)


def bending_wave_numbers(start: str, end: str, count: int) -> Array:
    """Roots b (count,) of the frequency equation, ascending, by Newton's method from their asymptotes."""
    n, ends = np.arange(1, count + 1), {start, end}
    if ends == {"pinned"}:
        return np.asarray(np.pi * n, dtype=np.float64)
    if "pinned" in ends:  # tan b = tanh b
        b = (n + 0.25) * np.pi
        for _ in range(ROOT_STEPS):
            b = b - (np.sin(b) - np.cos(b) * np.tanh(b)) / (
                np.cos(b) + np.sin(b) * np.tanh(b) - np.cos(b) / np.cosh(np.minimum(b, 300.0)) ** 2
            )
        return np.asarray(b, dtype=np.float64)
    sign = 1.0 if len(ends) == 1 else -1.0  # cos b cosh b = 1 for equal ends, -1 for clamped and free
    b = (n + 0.5 * sign) * np.pi
    for _ in range(ROOT_STEPS):
        small = sign / np.cosh(np.minimum(b, 300.0))
        b = b - (np.cos(b) - small) / (-np.sin(b) + small * np.tanh(b))
    return np.asarray(b, dtype=np.float64)


def _values(b: float, xi: float, order: int) -> list[float]:
    """Derivatives of the four waves at xi, over b^order."""
    turned = b * xi + order * np.pi / 2
    return [np.cos(turned), np.sin(turned), (-1.0) ** order * np.exp(-b * xi), np.exp(-b * (1.0 - xi))]


def stretching_functions(start: str, end: str, count: int) -> ShapeFunctions:
    """First `count` elastic longitudinal eigenfunctions, u'' = -b^2 u, of ends "fixed" or "free"; frequencies are b."""
    same = start == end
    numbers = np.asarray(np.pi * (np.arange(1, count + 1) - (0.0 if same else 0.5)), dtype=np.float64)
    waves = np.zeros((count, 4, count))
    waves[np.arange(count), 1 if start == "fixed" else 0, np.arange(count)] = 1.0
    return ShapeFunctions(np.zeros((4, count)), numbers, waves)
