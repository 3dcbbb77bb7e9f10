"""The mesh: equal elements, lumped nodal masses, and the element that holds a given point.

What bending and longitudinal modes of a uniform beam have in common.

Finite elements: stiffness, nodal slopes by static condensation, slope integrals (EI = EA = L = 1).

Deflection of node i under a unit force at node j: Green's functions of beam and bar (EI = EA = L = 1).

Cubic Hermite elements reproduce the exact nodal deflections of a uniform beam under nodal forces, so these
closed forms are the inverse of the assembled stiffness with the (massless) rotations condensed out. The modes
are computed from them because the lowest modes are then the best conditioned ones; with the stiffness matrix
their error grows with the fourth power of the number of elements. For a body with free ends the deflection is
fixed only up to a rigid motion, which the vibration problem projects out.

The free-vibration problem of the mesh, K w = lambda M w, solved through the nodal flexibility.
"""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import dataclass
from typing import NamedTuple

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


SIGN_THRESHOLD = 1e-6


def free_vibration(
    flexibility: Array, masses: Array, count: int, mirrored: bool, rigid: Array | None = None
) -> tuple[Array, Array]:
    """Lowest `count` elastic modes: eigenvalues lambda = omega^2 (count,) ascending and shapes w (k, count).

    flexibility (k, k) and lumped masses (k,) belong to the k free nodes.
    mirrored: supports and mesh are symmetric about the middle; the symmetric and antisymmetric shapes are
    then sought apart, which makes their symmetry exact.
    rigid (k, r): rigid motions of an unsupported body, removed by mass-orthogonal projection.
    Shapes are orthogonal in the masses; the caller normalises them.
    """
    root = np.sqrt(masses)
    dynamic = root[:, None] * flexibility * root[None, :]
    held = np.linalg.qr(root[:, None] * rigid)[0] if rigid is not None else np.zeros((len(masses), 0))
    values: list[Array] = []
    vectors: list[Array] = []
    for basis in _parity_bases(len(masses)) if mirrored else [np.eye(len(masses))]:
        held_part = basis.T @ held
        projector = np.eye(basis.shape[1]) - held_part @ held_part.T
        part = projector @ (basis.T @ dynamic @ basis) @ projector
        part_values, part_vectors = np.linalg.eigh(0.5 * (part + part.T))
        values.append(part_values[::-1][:count])
        # Project once more: modes with small eigenvalues may have picked up a trace of rigid motion.
        vectors.append(basis @ (projector @ part_vectors[:, ::-1][:, :count]))
    inverse = np.concatenate(values)
    order = np.argsort(-inverse, kind="stable")[:count]
    return 1.0 / inverse[order], np.concatenate(vectors, axis=1)[:, order] / root[:, None]


def _parity_bases(nodes: int) -> list[Array]:
    """Orthonormal bases of the shapes that are symmetric and antisymmetric about the middle node."""
    half = nodes // 2
    near = np.arange(half)
    bases = []
    for sign in (1.0, -1.0):
        middle = nodes % 2 if sign > 0 else 0
        basis = np.zeros((nodes, half + middle))
        basis[near, near] = np.sqrt(0.5)
        basis[nodes - 1 - near, near] = sign * np.sqrt(0.5)
        if middle:
            basis[half, half] = 1.0
        bases.append(basis)
    return [basis for basis in bases if basis.shape[1]]


def normalised(shapes: Array) -> Array:
    """Shapes (k, modes) with largest nodal value 1; the first value above 1e-6 in magnitude is positive."""
    scaled = shapes / np.max(np.abs(shapes), axis=0)
    first = np.argmax(np.abs(scaled) > SIGN_THRESHOLD, axis=0)
    return np.asarray(scaled * np.sign(scaled[first, np.arange(scaled.shape[1])]))


NODE_TOLERANCE = 1e-9


def node_positions(elements: int) -> Array:
    """Node positions xi = x / L, shape (elements + 1,)."""
    return np.arange(elements + 1, dtype=np.float64) / elements


def centred_positions(elements: int) -> Array:
    """xi - 1/2 at the nodes, shape (elements + 1,), with exactly opposite values at mirrored nodes."""
    return np.arange(-elements, elements + 1, 2, dtype=np.float64) / (2.0 * elements)


def lumped_masses(elements: int) -> Array:
    """Nodal mass fractions, shape (elements + 1,): 1/elements inside, half of that at the two ends.

    The ends take what rounding leaves over, so that the exact sum (math.fsum) is 1.
    """
    masses = np.full(elements + 1, 1.0 / elements)
    masses[[0, -1]] = 0.5 * (1.0 - math.fsum(masses[1:-1]))
    return masses


def check_fraction(at: float) -> None:
    """Raises ValueError if `at` is not a fraction of the length."""
    if not 0.0 <= at <= 1.0:
        raise ValueError(f"position {at!r} is off the beam; give a fraction of the length in [0, 1]")


def locate(at: float, elements: int) -> tuple[int, float]:
    """Element index and position in [0, 1] inside it of the point at fraction `at`; exactly 0 or 1 on a node.

    Raises ValueError if `at` is outside [0, 1].
    """
    check_fraction(at)
    scaled = at * elements
    nearest = round(scaled)
    if abs(scaled - nearest) <= NODE_TOLERANCE:
        return (nearest, 0.0) if nearest < elements else (elements - 1, 1.0)
    element = int(scaled)
    return element, scaled - element


def check_request(kind: str, elements: int, ends: str, modes: int, removed: dict[str, int]) -> None:
    """Check what was asked for; `removed` maps each known end condition to the node motions it takes away.

    Raises ValueError, saying what is wrong and what to do, for unknown ends, fewer than one element or mode,
    or more modes than the mesh has free nodes.
    """
    if ends not in removed:
        raise ValueError(f"unknown ends {ends!r} for {kind} modes; use one of {', '.join(removed)}")
    if elements < 1:
        raise ValueError(f"{elements} elements make no beam; give at least 1")
    if modes < 1:
        raise ValueError(f"{modes} {kind} modes asked for; ask for at least 1, or leave the mode set out")
    available = elements + 1 - removed[ends]
    if modes > available:
        needed = modes + removed[ends] - 1
        raise ValueError(
            f"{modes} {kind} modes asked for, but {elements} elements with {ends} ends have {available}; "
            f"use at least {needed} elements (several per mode for accuracy) or fewer modes"
        )


@dataclass(frozen=True, eq=False)
class UniformModes(ABC):
    """Orthogonal shapes of a beam with their integrals over the mass; arrays are read-only.

    xi (points,): places x / L of the mass: nodes of a lumped mesh, or Gauss points.  mu (points,): mass fractions,
    sum 1; the mass at a point is rho A L mu.
    kappa, mass (modes, modes): modal stiffness and mass, diagonal; M_ff = rho A L mass (Eq. 20).
    frequencies (modes,): of the beam of unit length, mass and stiffness.
    """

    ends: str
    xi: Array
    mu: Array
    kappa: Array
    mass: Array
    frequencies: Array

    @property
    def modes(self) -> int:
        """Number of modes."""
        return len(self.frequencies)


class Mesh(NamedTuple):
    """Node positions xi, mass fractions mu, the nodes `free` that an end does not hold, and how the ends are held."""

    xi: Array
    mu: Array
    free: np.ndarray
    start: str
    end: str


def mesh_for(kind: str, elements: int, ends: str, modes: int, known: dict[str, int]) -> Mesh:
    """The mesh for a request of modes; raises ValueError for unknown ends or a mesh too coarse for the modes."""
    check_request(kind, elements, ends, modes, known)
    start, end = ends.split("-")
    free = np.arange(int(start != "free"), elements + 1 - int(end != "free"))
    return Mesh(node_positions(elements), lumped_masses(elements), free, start, end)
