"""Longitudinal modes of a uniform bar, which are those of torsion too, and of a mesh with lumped nodal masses."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from symgen.modes import elements as fe
from symgen.modes.cleaning import Array, clean, fixed, symmetric
from symgen.modes.flexibility import axial_flexibility
from symgen.modes.mesh import locate
from symgen.modes.uniform import UniformModes, mesh_for
from symgen.modes.vibration import check_rigid_modes, free_vibration, normalised

# Ends -> node motions that are not elastic modes (held displacements, or the rigid motion).
AXIAL_ENDS = {"fixed-free": 1, "free-free": 1, "fixed-fixed": 2}


@dataclass(frozen=True, eq=False)
class BarModes(UniformModes):
    """Longitudinal modes for L = 1, EA = 1, rho A = 1.

    u (points, modes): displacement per unit modal coordinate, largest magnitude 1 (coordinate in m).
    kappa: U^T K U; K_ff = EA / L kappa.  mass: sum mu u u^T.
    frequencies: omega = frequencies sqrt(E / (rho L^2)), in rad/s.
    """

    u: Array

    @abstractmethod
    def interpolate(self, at: float) -> Array:
        """Displacement shapes u (modes,) at the fraction `at` of the length. Raises ValueError outside [0, 1]."""

    @abstractmethod
    def shortening(self, at: float) -> Array:
        """Integral of u'^T u' from the start to the fraction `at`, (modes, modes): of twisted fibres."""


@dataclass(frozen=True, eq=False)
class LumpedBarModes(BarModes):
    """Longitudinal modes of n elements with lumped nodal masses: the points are the n+1 nodes."""

    @property
    def elements(self) -> int:
        """Number of elements."""
        return len(self.xi) - 1

    def interpolate(self, at: float) -> Array:
        """Displacement shapes u (modes,) at the fraction `at` of the length: linear; nodal values on a node.

        Raises ValueError if `at` is outside [0, 1].
        """
        element, local = locate(at, self.elements)
        if local in (0.0, 1.0):
            return np.asarray(self.u[element + int(local)])
        return clean((1.0 - local) * self.u[element] + local * self.u[element + 1], 1.0)

    def shortening(self, at: float) -> Array:
        """Integral of u'^T u' from the start to the fraction `at`: of slopes that are constant in each element."""
        element, local = locate(at, self.elements)
        slopes = np.diff(self.u[: element + 2], axis=0) * self.elements
        parts = np.append(np.ones(element), local) / self.elements
        return symmetric(slopes.T @ (parts[:, None] * slopes))


def axial_modes(elements: int, ends: str, modes: int) -> LumpedBarModes:
    """First `modes` elastic longitudinal modes of the bar in `elements` equal elements (Eqs. 15-20).

    ends: "fixed-free", "free-free" (the rigid mode removed) or "fixed-fixed", start first.
    Raises ValueError for unknown ends or a mesh too coarse for the modes; RuntimeError if a free bar lacks
    its rigid mode.
    """
    mesh = mesh_for("axial", elements, ends, modes, AXIAL_ENDS)
    rigid = None
    if ends == "free-free":
        check_rigid_modes(fe.bar_stiffness(elements), mesh.mu, 1)
        rigid = np.ones((elements + 1, 1))
    flexibility = axial_flexibility(mesh.xi[mesh.free], ends)
    values, shapes = free_vibration(flexibility, mesh.mu[mesh.free], modes, mesh.start == mesh.end, rigid)
    u = np.zeros((elements + 1, modes))
    u[mesh.free] = clean(normalised(shapes))
    mass = np.diag(np.einsum("k,ka,ka->a", mesh.mu, u, u))
    return LumpedBarModes(
        ends=ends,
        xi=fixed(mesh.xi),
        mu=fixed(mesh.mu),
        u=fixed(u),
        kappa=fixed(np.diag(values * np.diag(mass))),
        mass=fixed(mass),
        frequencies=fixed(np.sqrt(values)),
    )
