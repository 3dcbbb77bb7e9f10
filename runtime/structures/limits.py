"""How long a step of central differences may be: bounds of a row, and the limit of a region (Courant, 2 / w_max).

References
----------
.. [1] Belytschko, T., Liu, W. K., Moran, B., Elkhodary, K., Nonlinear Finite Elements for Continua and Structures,
   2nd ed., Wiley 2014, Sec. 6.2: the critical step, bounds by rows (Gershgorin) and by elements.
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from scipy.linalg import eigvalsh_tridiagonal

from runtime.structures.structure import Array

LANCZOS_STEPS = 30  # gives w_max within 0.1 % for meshes; from below


def row_limits(K: sp.csr_matrix, mass: Array) -> Array:
    """The step (n,) [s] that each row alone would allow, by Gershgorin's circles of M^-1 K: never too long."""
    circles = np.asarray(abs(K).sum(axis=1)).ravel() / mass
    with np.errstate(divide="ignore"):
        return 2.0 / np.sqrt(circles)


def largest_frequency(K: sp.csr_matrix, mass: Array, steps: int = LANCZOS_STEPS) -> float:
    """w_max [rad/s] of K against M by Lanczos' recursion on M^-1/2 K M^-1/2, from below, within some 0.1 %."""
    n = len(mass)
    if not n or not K.nnz:
        return 0.0
    scale = 1.0 / np.sqrt(mass)
    v = np.random.default_rng(0).standard_normal(n)
    v /= np.linalg.norm(v)
    before, beta = np.zeros(n), 0.0
    diagonal, beside = [], []
    for _ in range(min(steps, n)):
        w = scale * (K @ (scale * v)) - beta * before
        alpha = float(w @ v)
        w -= alpha * v
        diagonal.append(alpha)
        beta = float(np.linalg.norm(w))
        if beta <= 1e-12 * abs(alpha):
            break
        beside.append(beta)
        before, v = v, w / beta
    largest = eigvalsh_tridiagonal(np.array(diagonal), np.array(beside[: len(diagonal) - 1]))[-1]
    return float(np.sqrt(max(largest, 0.0)))


def damped_limit(frequency: float, stiffness_damping: float, mass_damping: float = 0.0) -> float:
    """The longest stable step [s] for x'' + (a + b w^2) x' + w^2 x = 0 by the recursion of central_difference.c.

    stiffness_damping: b [s], explicit with predicted rates; mass_damping: a [1/s], implicit, which only helps.
    """
    if frequency == 0.0:
        return np.inf
    if stiffness_damping == 0.0:
        return 2.0 / frequency
    low, high = 0.0, 2.0 / frequency
    for _ in range(50):
        h = (low + high) / 2
        low, high = (h, high) if _stable(h, frequency, stiffness_damping, mass_damping) else (low, h)
    return low


def _stable(h: float, w: float, b: float, a: float) -> bool:
    """Are all roots of the recursion of (x, d, d before) within the unit circle?"""
    keep, gain = (1 - a * h / 2) / (1 + a * h / 2), h * h / (1 + a * h / 2)
    damper = gain * b * w * w / h
    step = np.array(
        [
            [1 - gain * w * w, keep - 1.5 * damper, 0.5 * damper],
            [-gain * w * w, keep - 1.5 * damper, 0.5 * damper],
            [0, 1, 0],
        ]
    )
    return bool(np.abs(np.linalg.eigvals(step)).max() <= 1 + 1e-12)
