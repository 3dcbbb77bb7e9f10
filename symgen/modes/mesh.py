"""The mesh: equal elements, lumped nodal masses, and the element that holds a given point.

What bending and longitudinal modes of a uniform beam have in common.
"""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from symgen.modes.cleaning import Array

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
