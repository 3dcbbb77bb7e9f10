"""Mode sets of a uniform beam in closed form, their integrals by Gauss quadrature to rounding (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.flexible import (
    ShapeFunctions,
    bending_shapes,
    gauss_points,
    panels_for,
    slope_size,
    stretching_shapes,
)
from symgen.modes.axial import BarModes
from symgen.modes.cleaning import Array, clean, fixed, symmetric
from symgen.modes.lateral import BeamModes, LateralPoint
from symgen.modes.mesh import check_fraction


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
