"""What bending and longitudinal modes of a uniform beam have in common."""

from __future__ import annotations

from abc import ABC
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from symgen.modes.cleaning import Array
from symgen.modes.mesh import check_request, lumped_masses, node_positions


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
