"""Deflection of node i under a unit force at node j: Green's functions of beam and bar (EI = EA = L = 1).

Cubic Hermite elements reproduce the exact nodal deflections of a uniform beam under nodal forces, so these
closed forms are the inverse of the assembled stiffness with the (massless) rotations condensed out. The modes
are computed from them because the lowest modes are then the best conditioned ones; with the stiffness matrix
their error grows with the fourth power of the number of elements. For a body with free ends the deflection is
fixed only up to a rigid motion, which the vibration problem projects out.
"""

from __future__ import annotations

import numpy as np

from symgen.modes.cleaning import Array


def _sorted_pairs(xi: Array) -> tuple[Array, Array]:
    return np.minimum(xi[:, None], xi[None, :]), np.maximum(xi[:, None], xi[None, :])


def lateral_flexibility(xi: Array, ends: str) -> Array:
    """Lateral flexibility between the points `xi` (k,), shape (k, k), in L^3 / EI."""
    near, far = _sorted_pairs(xi)
    rest = 1.0 - far
    if ends == "clamped-free":
        return near**2 * (3.0 * far - near) / 6.0
    if ends == "pinned-pinned":
        return near * rest * (2.0 * far - far**2 - near**2) / 6.0
    if ends == "clamped-pinned":
        return near**2 * rest * (3.0 * far * (2.0 - far) - near * (2.0 + 2.0 * far - far**2)) / 12.0
    if ends == "clamped-clamped":
        return near**2 * rest**2 * (3.0 * far - near * (1.0 + 2.0 * far)) / 6.0
    if ends == "free-free":
        return (far - near) ** 3 / 12.0
    raise ValueError(f"no lateral flexibility for ends {ends!r}; add its Green's function here")


def axial_flexibility(xi: Array, ends: str) -> Array:
    """Axial flexibility between the points `xi` (k,), shape (k, k), in L / EA."""
    near, far = _sorted_pairs(xi)
    if ends == "fixed-free":
        return near
    if ends == "fixed-fixed":
        return near * (1.0 - far)
    if ends == "free-free":
        return -0.5 * (far - near)
    raise ValueError(f"no axial flexibility for ends {ends!r}; add its Green's function here")
