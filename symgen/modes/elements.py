"""Finite elements: stiffness, nodal slopes by static condensation, slope integrals (EI = EA = L = 1)."""

from __future__ import annotations

import numpy as np

from symgen.modes.cleaning import Array, symmetric

# Three Gauss points integrate the fourth-degree products of Hermite slopes exactly, on part elements too.
_GAUSS_POINTS, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(3)


def beam_stiffness(elements: int) -> Array:
    """Assembled stiffness of cubic Hermite elements, shape (2n + 2, 2n + 2), dofs (w_0, w_0', w_1, ...)."""
    h = 1.0 / elements
    block = np.array(
        [
            [12.0, 6.0 * h, -12.0, 6.0 * h],
            [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
            [-12.0, -6.0 * h, 12.0, -6.0 * h],
            [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
        ]
    ) / (h**3)
    stiffness = np.zeros((2 * elements + 2, 2 * elements + 2))
    for k in range(elements):
        stiffness[2 * k : 2 * k + 4, 2 * k : 2 * k + 4] += block
    return stiffness


def bar_stiffness(elements: int) -> Array:
    """Assembled stiffness of the linear bar elements, shape (n + 1, n + 1)."""
    stiffness = np.diag(np.full(elements + 1, 2.0 * elements))
    stiffness[0, 0] = stiffness[-1, -1] = elements
    off = np.arange(elements)
    stiffness[off, off + 1] = stiffness[off + 1, off] = -elements
    return stiffness


def condensed_slopes(elements: int, clamped: tuple[bool, bool]) -> Array:
    """Nodal slopes per unit nodal deflection, shape (n + 1, n + 1): slope = matrix @ deflection.

    The rotations carry no mass, so their rows of the equations of motion are static: K_rr w' = -K_rw w.
    `clamped` says whether the slope is held at zero at the start and at the end.
    """
    stiffness = beam_stiffness(elements)
    free = np.arange(int(clamped[0]), elements + 1 - int(clamped[1]))
    recovery = np.zeros((elements + 1, elements + 1))
    if free.size:
        rotations = stiffness[np.ix_(2 * free + 1, 2 * free + 1)]
        recovery[free] = np.linalg.solve(rotations, -stiffness[2 * free + 1, 0::2])
    return recovery


def condensed_beam_stiffness(elements: int) -> Array:
    """Stiffness of the unsupported beam on the nodal deflections alone, shape (n + 1, n + 1)."""
    stiffness = beam_stiffness(elements)
    condensed = stiffness[0::2, 0::2] + stiffness[0::2, 1::2] @ condensed_slopes(elements, (False, False))
    return symmetric(condensed)


def hermite(phi: Array, slope: Array, element: int, local: float, elements: int) -> tuple[Array, Array]:
    """Deflection and slope d/dxi, each (modes,), at `local` in [0, 1] of an element.

    phi, slope (n + 1, modes): nodal values.
    """
    s = local
    h = 1.0 / elements
    rise = 3 * s**2 - 2 * s**3
    value = np.array([1 - rise, h * (s - 2 * s**2 + s**3), rise, h * (s**3 - s**2)])
    rate = np.array([6 * (s * s - s) / h, 1 - 4 * s + 3 * s**2, 6 * (s - s * s) / h, 3 * s**2 - 2 * s])
    nodal = np.stack([phi[element], slope[element], phi[element + 1], slope[element + 1]])
    return value @ nodal, rate @ nodal


def slope_products(phi: Array, slope: Array, element: int, local: float, elements: int) -> Array:
    """Exact integral of phi'^T phi' from an element's start to `local` of it, shape (modes, modes)."""
    total = np.zeros((phi.shape[1], phi.shape[1]))
    half = 0.5 * local
    for point, weight in zip(_GAUSS_POINTS, _GAUSS_WEIGHTS, strict=True):
        _, rate = hermite(phi, slope, element, half * (1.0 + point), elements)
        total += weight * half / elements * np.outer(rate, rate)
    return symmetric(total)
