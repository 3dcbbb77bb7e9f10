"""Longitudinal modes of a uniform bar with lumped nodal masses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symgen.modes import elements as fe
from symgen.modes.cleaning import Array, clean, fixed
from symgen.modes.flexibility import axial_flexibility
from symgen.modes.mesh import check_request, locate, lumped_masses, node_positions
from symgen.modes.vibration import check_rigid_modes, free_vibration, normalised

# Ends -> node motions that are not elastic modes (held displacements, or the rigid motion).
AXIAL_ENDS = {"fixed-free": 1, "free-free": 1, "fixed-fixed": 2}


@dataclass(frozen=True, eq=False)
class BarModes:
    """Longitudinal modes for L = 1, EA = 1, rho A = 1; n elements. Arrays are read-only.

    xi (n+1,): node positions x / L.  mu (n+1,): lumped mass fractions, sum 1; nodal mass is rho A L mu.
    u (n+1, modes): nodal displacement per unit modal coordinate, largest magnitude 1 (coordinate in m).
    kappa (modes, modes): U^T K U, diagonal; K_ff = EA / L kappa.
    mass (modes, modes): sum mu u u^T, diagonal; M_ff = rho A L mass (Eq. 20).
    frequencies (modes,): omega = frequencies sqrt(E / (rho L^2)), in rad/s.
    """

    ends: str
    xi: Array
    mu: Array
    u: Array
    kappa: Array
    mass: Array
    frequencies: Array

    @property
    def elements(self) -> int:
        """Number of elements."""
        return len(self.xi) - 1

    @property
    def modes(self) -> int:
        """Number of modes."""
        return self.u.shape[1]

    def interpolate(self, at: float) -> Array:
        """Displacement shapes u (modes,) at the fraction `at` of the length: linear; nodal values on a node.

        Raises ValueError if `at` is outside [0, 1].
        """
        element, local = locate(at, self.elements)
        if local in (0.0, 1.0):
            return self.u[element + int(local)]
        return clean((1.0 - local) * self.u[element] + local * self.u[element + 1], 1.0)


def axial_modes(elements: int, ends: str, modes: int) -> BarModes:
    """First `modes` elastic longitudinal modes of the bar in `elements` equal elements (Eqs. 15-20).

    ends: "fixed-free", "free-free" (the rigid mode removed) or "fixed-fixed", start first.
    Raises ValueError for unknown ends or a mesh too coarse for the modes; RuntimeError if a free bar lacks
    its rigid mode.
    """
    check_request("axial", elements, ends, modes, AXIAL_ENDS)
    xi, mu = node_positions(elements), lumped_masses(elements)
    start, end = ends.split("-")
    free = np.arange(int(start != "free"), elements + 1 - int(end != "free"))
    rigid = None
    if ends == "free-free":
        check_rigid_modes(fe.bar_stiffness(elements), mu, 1)
        rigid = np.ones((elements + 1, 1))
    values, shapes = free_vibration(axial_flexibility(xi[free], ends), mu[free], modes, start == end, rigid)
    u = np.zeros((elements + 1, modes))
    u[free] = clean(normalised(shapes))
    mass = np.diag(np.einsum("k,ka,ka->a", mu, u, u))
    return BarModes(
        ends,
        fixed(xi),
        fixed(mu),
        fixed(u),
        kappa=fixed(np.diag(values * np.diag(mass))),
        mass=fixed(mass),
        frequencies=fixed(np.sqrt(values)),
    )
