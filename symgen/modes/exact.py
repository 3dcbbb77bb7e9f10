"""Mode sets of a uniform beam in closed form, their integrals by Gauss quadrature to rounding (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symgen.modes.axial import BarModes
from symgen.modes.cleaning import Array, clean, fixed, symmetric
from symgen.modes.eigenfunctions import bending_functions, stretching_functions
from symgen.modes.end_shapes import BENDING, STRETCHING, EndShapes
from symgen.modes.lateral import BeamModes, LateralPoint
from symgen.modes.mesh import check_fraction
from symgen.modes.shape_functions import ShapeFunctions, gauss_points, polynomials
from symgen.modes.vibration import SIGN_THRESHOLD

FEWEST_PANELS = 8
GRID = 16  # points a panel among which the largest value of a shape is sought
POLISHING = 4  # Newton steps to it


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
    """Longitudinal shapes in closed form for L = 1, EA = 1, rho A = 1, orthogonal; xi, mu: Gauss points and weights."""

    functions: ShapeFunctions

    def interpolate(self, at: float) -> Array:
        """Displacement shapes u (modes,) at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        check_fraction(at)
        return clean(self.functions.at(np.array([at]))[0], 1.0)


def panels_for(modes: int) -> int:
    """Parts of the quadrature for sets of at most `modes` shapes: each holds at most half a period."""
    return max(FEWEST_PANELS, modes + 2)


def exact_bending(ends: str, modes: int, panels: int | None = None) -> ExactBeamModes:
    """The first `modes` bending shapes of `ends` (end shapes among them), orthogonalised.

    Raises ValueError for unknown ends or fewer modes than the ends have static shapes.
    """
    parts = panels or panels_for(modes)
    choice = _choice("lateral", BENDING, ends, modes)
    own = bending_functions(choice.start, choice.end, modes - len(choice.static))
    functions, values = _orthogonal(choice, own, own.wave_numbers**4, parts, order=2)
    xi, mu = gauss_points(parts)
    phi, rate = functions.at(xi), functions.at(xi, 1)
    mass = np.einsum("k,ka,ka->a", mu, phi, phi)
    size = float(np.max(np.abs(functions.at(_grid(parts), 1))))
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
    choice = _choice("axial", STRETCHING, ends, modes)
    own = stretching_functions(choice.start, choice.end, modes - len(choice.static))
    functions, values = _orthogonal(choice, own, own.wave_numbers**2, parts, order=1)
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
    )


def _choice(kind: str, known: dict[str, EndShapes], ends: str, modes: int) -> EndShapes:
    if ends not in known:
        raise ValueError(f"unknown ends {ends!r} for {kind} modes; use one of {', '.join(known)}")
    least = max(1, len(known[ends].static))
    if modes < least:
        raise ValueError(
            f"{modes} {kind} modes asked for, but {ends} ends have {len(known[ends].static)} static shapes; "
            f"ask for at least {least}"
        )
    return known[ends]


def _orthogonal(
    choice: EndShapes, own: ShapeFunctions, values: Array, panels: int, order: int
) -> tuple[ShapeFunctions, Array]:
    """Shapes of largest value 1 that are orthogonal in mass and stiffness, and their eigenvalues, ascending.

    values: eigenvalues of the modes `own`. Static shapes do no work on the modes between held ends, so the stiffness
    int phi_a^(order) phi_b^(order) has two diagonal blocks.
    """
    functions = own
    if choice.static:
        static = polynomials(list(choice.static))
        functions = static.beside(own)
        xi, mu = gauss_points(panels)
        phi, strain = functions.at(xi), static.at(xi, order)
        mass = phi.T @ (mu[:, None] * phi)
        split = static.count
        stiffness = np.diag(np.concatenate([np.zeros(split), values * np.diag(mass)[split:]]))
        stiffness[:split, :split] = strain.T @ (mu[:, None] * strain)
        inverse = np.linalg.inv(np.linalg.cholesky(mass))
        values, vectors = np.linalg.eigh(symmetric(inverse @ stiffness @ inverse.T))
        functions = functions.mixed(inverse.T @ vectors)
    return functions.mixed(np.diag(_scales(functions, panels))), values


def _grid(panels: int) -> Array:
    return np.linspace(0.0, 1.0, GRID * panels + 1)


def _scales(functions: ShapeFunctions, panels: int) -> Array:
    """Factors (n,) that make the largest value 1 and the first one above 1e-6 of it positive."""
    xi = _grid(panels)
    phi = functions.at(xi)
    each = np.arange(functions.count)
    place = xi[np.argmax(np.abs(phi), axis=0)]
    inside = (place > 0.0) & (place < 1.0)
    for _ in range(POLISHING):
        rate, bend = (np.diagonal(functions.at(place, order)) for order in (1, 2))
        place = np.where(inside, place - rate / np.where(inside, bend, 1.0), place)
    largest = np.abs(functions.at(place)[each, each])
    first = np.argmax(np.abs(phi) > SIGN_THRESHOLD * largest, axis=0)
    return np.asarray(np.sign(phi[first, each]) / largest)
