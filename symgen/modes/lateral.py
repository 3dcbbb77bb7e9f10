"""Bending modes of a uniform Euler-Bernoulli beam, and those of a mesh with lumped nodal masses."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from symgen.modes import elements as fe
from symgen.modes.cleaning import Array, clean, fixed, symmetric
from symgen.modes.flexibility import lateral_flexibility
from symgen.modes.mesh import centred_positions, locate
from symgen.modes.uniform import UniformModes, mesh_for
from symgen.modes.vibration import check_rigid_modes, free_vibration, normalised

# Ends -> node motions that are not elastic modes (held deflections, or rigid motions).
LATERAL_ENDS = {
    "pinned-pinned": 2,
    "clamped-free": 1,
    "free-free": 2,
    "clamped-pinned": 2,
    "clamped-clamped": 2,
}


class LateralPoint(NamedTuple):
    """Lateral data at one point: phi (modes,), slope = d phi / d xi (modes,), eta (modes, modes)."""

    phi: Array
    slope: Array
    eta: Array


@dataclass(frozen=True, eq=False)
class BeamModes(UniformModes):
    """Bending modes for L = 1, EI = 1, rho A = 1.

    phi (points, modes): deflection per unit modal coordinate, largest magnitude 1 (coordinate in m).
    kappa: Phi^T K Phi; K_ff = EI / L^3 kappa.  mass: sum mu phi phi^T.
    H, xH (modes, modes): integrals of eta and of x eta over the mass, eta = integral of phi'^T phi' from 0 to xi.
    frequencies: omega = frequencies sqrt(EI / (rho A L^4)), in rad/s.
    """

    phi: Array
    H: Array
    xH: Array

    @abstractmethod
    def interpolate(self, at: float) -> LateralPoint:
        """Deflection, slope and eta at the fraction `at` of the length. Raises ValueError outside [0, 1]."""


@dataclass(frozen=True, eq=False)
class LumpedBeamModes(BeamModes):
    """Bending modes of n elements with lumped nodal masses: the points are the n+1 nodes.

    slope (n+1, modes): d phi / d xi; the rotation per metre of coordinate is slope / L.
    eta (n+1, modes, modes): integral of phi'^T phi' from 0 to xi; the foreshortening matrix is eta / L.
    """

    slope: Array
    eta: Array

    @property
    def elements(self) -> int:
        """Number of elements."""
        return len(self.xi) - 1

    def interpolate(self, at: float) -> LateralPoint:
        """Values at the fraction `at` of the length: Hermite cubic with its exact eta; nodal on a node.

        Raises ValueError if `at` is outside [0, 1].
        """
        element, local = locate(at, self.elements)
        if local in (0.0, 1.0):
            node = element + int(local)
            return LateralPoint(self.phi[node], self.slope[node], self.eta[node])
        phi, slope = fe.hermite(self.phi, self.slope, element, local, self.elements)
        part = fe.slope_products(self.phi, self.slope, element, local, self.elements)
        return LateralPoint(
            clean(phi, 1.0),
            clean(slope, float(np.max(np.abs(self.slope)))),
            clean(self.eta[element] + part, float(np.max(np.abs(self.eta)))),
        )


def lateral_modes(elements: int, ends: str, modes: int) -> LumpedBeamModes:
    """First `modes` elastic bending modes of the beam in `elements` equal elements (Eqs. 15-20).

    ends: "pinned-pinned", "clamped-free", "free-free" (the two rigid modes removed), "clamped-pinned" or
    "clamped-clamped", start first. Masses are lumped at the nodes without rotary inertia, so the rotations
    are condensed statically, without error, and recovered from the deflections.
    Raises ValueError for unknown ends or a mesh too coarse for the modes, RuntimeError if a free beam lacks
    its two rigid modes.
    """
    mesh = mesh_for("lateral", elements, ends, modes, LATERAL_ENDS)
    rigid = None
    if ends == "free-free":
        check_rigid_modes(fe.condensed_beam_stiffness(elements), mesh.mu, 2)
        rigid = np.stack([np.ones(elements + 1), centred_positions(elements)], axis=1)
    mirrored = mesh.start == mesh.end
    flexibility = lateral_flexibility(mesh.xi[mesh.free], ends)
    values, shapes = free_vibration(flexibility, mesh.mu[mesh.free], modes, mirrored, rigid)
    phi = np.zeros((elements + 1, modes))
    phi[mesh.free] = clean(normalised(shapes))
    slope = fe.condensed_slopes(elements, (mesh.start == "clamped", mesh.end == "clamped")) @ phi
    if mirrored:
        # The slope of a symmetric shape is antisymmetric and the other way round; make that exact too.
        parity = np.where(np.all(phi == phi[::-1], axis=0), 1.0, -1.0)
        slope = 0.5 * (slope - parity * slope[::-1])
    slope = clean(slope)
    mass = np.diag(np.einsum("k,ka,ka->a", mesh.mu, phi, phi))
    eta = _cumulative_eta(phi, slope)
    size = float(np.max(np.abs(eta), initial=0.0))
    return LumpedBeamModes(
        ends=ends,
        xi=fixed(mesh.xi),
        mu=fixed(mesh.mu),
        phi=fixed(phi),
        slope=fixed(slope),
        kappa=fixed(np.diag(values * np.diag(mass))),
        mass=fixed(mass),
        H=fixed(clean(symmetric(np.einsum("k,kab->ab", mesh.mu, eta)), size)),
        xH=fixed(clean(symmetric(np.einsum("k,kab->ab", mesh.mu * mesh.xi, eta)), size)),
        eta=fixed(eta),
        frequencies=fixed(np.sqrt(values)),
    )


def _cumulative_eta(phi: Array, slope: Array) -> Array:
    """Integral of phi'^T phi' from the start to each node, shape (n + 1, modes, modes)."""
    elements = len(phi) - 1
    eta = np.zeros((elements + 1, phi.shape[1], phi.shape[1]))
    parts = [fe.slope_products(phi, slope, k, 1.0, elements) for k in range(elements)]
    eta[1:] = np.cumsum(parts, axis=0)
    return clean(symmetric(eta))
