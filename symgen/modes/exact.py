"""Mode sets of a uniform beam in closed form, their integrals by Gauss quadrature to rounding (Eqs. 15-20).

Bending modes of a uniform Euler-Bernoulli beam, and those of a mesh with lumped nodal masses.

Longitudinal modes of a uniform bar, which are those of torsion too, and of a mesh with lumped nodal masses.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from runtime.contract.flexible import (
    ShapeFunctions,
    bending_shapes,
    gauss_points,
    panels_for,
    slope_size,
    stretching_shapes,
)
from symgen.modes import mesh as fe
from symgen.modes.cleaning import Array, clean, fixed, symmetric
from symgen.modes.mesh import (
    UniformModes,
    axial_flexibility,
    centred_positions,
    check_fraction,
    free_vibration,
    lateral_flexibility,
    locate,
    mesh_for,
    normalised,
)

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
    Raises ValueError for unknown ends or a mesh too coarse for the modes.
    """
    mesh = mesh_for("lateral", elements, ends, modes, LATERAL_ENDS)
    rigid = None
    if ends == "free-free":
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
    Raises ValueError for unknown ends or a mesh too coarse for the modes.
    """
    mesh = mesh_for("axial", elements, ends, modes, AXIAL_ENDS)
    rigid = None
    if ends == "free-free":
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


@dataclass(frozen=True, eq=False)
class ExactBeamModes(BeamModes):
    """Bending shapes in closed form for L = 1, EI = 1, rho A = 1, orthogonal in mass and stiffness.

    xi, mu: Gauss points and weights. functions: the shapes. panels: parts of the quadrature.
    """

    functions: ShapeFunctions
    panels: int
    slope_size: float

    def interpolate(self, at: float) -> LateralPoint:
        """Deflection, slope and eta at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        check_fraction(at)
        point = np.array([at])
        phi, slope = self.functions.at(point)[0], self.functions.at(point, 1)[0]
        xi, weights = gauss_points(self.panels, at)
        rate = self.functions.at(xi, 1)
        eta = symmetric(rate.T @ (weights[:, None] * rate))
        return LateralPoint(clean(phi, 1.0), clean(slope, self.slope_size), clean(eta, self.slope_size**2))


@dataclass(frozen=True, eq=False)
class ExactBarModes(BarModes):
    """Longitudinal shapes in closed form for L = 1, EA = 1, rho A = 1, orthogonal; xi, mu: Gauss points and weights.

    panels: parts of the quadrature.
    """

    functions: ShapeFunctions
    panels: int

    def interpolate(self, at: float) -> Array:
        """Displacement shapes u (modes,) at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        check_fraction(at)
        return clean(self.functions.at(np.array([at]))[0], 1.0)

    def shortening(self, at: float) -> Array:
        """Integral of u'^T u' from the start to the fraction `at`. Raises ValueError outside [0, 1]."""
        check_fraction(at)
        xi, weights = gauss_points(self.panels, at)
        rate = self.functions.at(xi, 1)
        return symmetric(rate.T @ (weights[:, None] * rate))


def exact_bending(ends: str, modes: int, panels: int | None = None) -> ExactBeamModes:
    """The first `modes` bending shapes of `ends` (end shapes among them), orthogonalised.

    Raises ValueError for unknown ends or fewer modes than the ends have static shapes.
    """
    parts = panels or panels_for(modes)
    functions, values = shapes = bending_shapes(ends, modes)
    xi, mu = gauss_points(parts)
    phi, rate = functions.at(xi), functions.at(xi, 1)
    mass = np.einsum("k,ka,ka->a", mu, phi, phi)
    size = slope_size(shapes)
    return ExactBeamModes(
        ends=ends,
        xi=fixed(xi),
        mu=fixed(mu),
        kappa=fixed(np.diag(values * mass)),
        mass=fixed(np.diag(mass)),
        frequencies=fixed(np.sqrt(values)),
        phi=fixed(phi),
        # int_0^1 int_0^xi f dx dxi = int (1 - x) f dx, and with the factor xi inside: int (1 - x^2)/2 f dx
        H=fixed(clean(symmetric(rate.T @ ((mu * (1.0 - xi))[:, None] * rate)), size**2)),
        xH=fixed(clean(symmetric(rate.T @ ((mu * (0.5 - 0.5 * xi**2))[:, None] * rate)), size**2)),
        functions=functions,
        panels=parts,
        slope_size=size,
    )


def exact_stretching(ends: str, modes: int, panels: int | None = None) -> ExactBarModes:
    """The first `modes` longitudinal shapes of `ends`, orthogonalised; errors as of `exact_bending`."""
    parts = panels or panels_for(modes)
    functions, values = stretching_shapes(ends, modes)
    xi, mu = gauss_points(parts)
    u = functions.at(xi)
    mass = np.einsum("k,ka,ka->a", mu, u, u)
    return ExactBarModes(
        ends=ends,
        xi=fixed(xi),
        mu=fixed(mu),
        kappa=fixed(np.diag(values * mass)),
        mass=fixed(np.diag(mass)),
        frequencies=fixed(np.sqrt(values)),
        u=fixed(u),
        functions=functions,
        panels=parts,
    )
