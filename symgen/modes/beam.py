"""Modes of a uniform beam in closed form and their shape integrals, by Gauss quadrature to rounding (Eqs. 15-20).

All is for a beam of unit length, mass and stiffness (EI = EA = GJ = L = rho A = 1). Torsion turns a section about the
beam's line by the angle u q and leaves it plane: no warping.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from runtime.contract.flexible import (
    OrthogonalShapes,
    ShapeFunctions,
    bending_shapes,
    gauss_points,
    panels_for,
    slope_size,
    stretching_shapes,
)
from symgen.modes.cleaning import Array, clean, fixed, symmetric

TORSION = 3
TURN = {1: (2, 1.0), 2: (1, -1.0)}  # deflection along y turns about z, along z about -y


class ModesAt(NamedTuple):
    """At one point: phi (modes,), slope = d phi / d xi (modes,), eta (modes, modes): int slope^T slope to it."""

    phi: Array
    slope: Array
    eta: Array


@dataclass(frozen=True, eq=False)
class BeamModes:
    """Shapes of bending, stretching or torsion, orthogonal in mass and stiffness; arrays are read-only.

    functions: the shapes, of largest magnitude 1.  xi, mu (points,): Gauss points and weights in `panels` parts.
    phi (points, modes): the shapes there.  kappa, mass (modes, modes), diagonal: K_ff = EI / L^3, EA / L or GJ / L
    times kappa, M_ff = rho A L times mass (20).  frequencies (modes,): omega over sqrt(EI / (rho A L^4)), or over
    sqrt(E / rho) / L.
    H, xH (modes, modes): integrals of eta and of x eta over the mass.
    """

    functions: ShapeFunctions
    panels: int
    slope_size: float
    xi: Array
    mu: Array
    phi: Array
    kappa: Array
    mass: Array
    frequencies: Array
    H: Array
    xH: Array

    @property
    def modes(self) -> int:
        """Number of modes."""
        return len(self.frequencies)

    def at(self, at: float) -> ModesAt:
        """Values at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        if not 0.0 <= at <= 1.0:
            raise ValueError(f"position {at!r} is off the beam; give a fraction of the length in [0, 1]")
        point = np.array([at])
        phi, slope = self.functions.at(point)[0], self.functions.at(point, 1)[0]
        xi, weights = gauss_points(self.panels, at)
        rate = self.functions.at(xi, 1)
        eta = symmetric(rate.T @ (weights[:, None] * rate))
        return ModesAt(clean(phi, 1.0), clean(slope, self.slope_size), clean(eta, self.slope_size**2))


def exact_bending(ends: str, modes: int, panels: int | None = None) -> BeamModes:
    """The first `modes` bending shapes of `ends` (end shapes among them), orthogonalised (Eqs. 15-19).

    Raises ValueError for unknown ends or fewer modes than the ends have static shapes.
    """
    return _modes(bending_shapes(ends, modes), panels or panels_for(modes))


def exact_stretching(ends: str, modes: int, panels: int | None = None) -> BeamModes:
    """The first `modes` longitudinal shapes of `ends`, also of torsion (15)-(19); errors as of `exact_bending`."""
    return _modes(stretching_shapes(ends, modes), panels or panels_for(modes))


def _modes(shapes: OrthogonalShapes, panels: int) -> BeamModes:
    functions, values = shapes
    xi, mu = gauss_points(panels)
    phi, rate = functions.at(xi), functions.at(xi, 1)
    mass = np.einsum("k,ka,ka->a", mu, phi, phi)
    size = slope_size(shapes)
    return BeamModes(
        functions=functions,
        panels=panels,
        slope_size=size,
        xi=fixed(xi),
        mu=fixed(mu),
        phi=fixed(phi),
        kappa=fixed(np.diag(values * mass)),
        mass=fixed(np.diag(mass)),
        frequencies=fixed(np.sqrt(values)),
        # int_0^1 int_0^xi f dx dxi = int (1 - x) f dx, and with the factor xi inside: int (1 - x^2)/2 f dx
        H=fixed(clean(symmetric(rate.T @ ((mu * (1.0 - xi))[:, None] * rate)), size**2)),
        xH=fixed(clean(symmetric(rate.T @ ((mu * (0.5 - 0.5 * xi**2))[:, None] * rate)), size**2)),
    )


ModeSets = tuple[tuple[int, BeamModes], ...]  # (axis, shapes)


@dataclass(frozen=True, eq=False)
class BeamPoint:
    """Shapes at a point: shape and turn (3, nf), rotation vector turn / L . q_f; twist (nf,): twist . q_f about x.

    H, H_twist (nf, nf): foreshortening along x by bending, over L, and by torsion, times I_p / (A L).
    """

    shape: Array
    turn: Array
    twist: Array
    H: Array
    H_twist: Array


@dataclass(frozen=True, eq=False)
class TwistIntegrals:
    """Of the angle u: first (nf,) = int u_a dm, pairs (nf, nf) = int u_a u_b dm, H and xH (nf, nf) as of bending."""

    first: Array
    pairs: Array
    H: Array
    xH: Array


@dataclass(frozen=True, eq=False)
class BeamIntegrals:
    """Shape integrals for L = m = 1, origin at the start, x along the beam; modes in the order they are given.

    axes (nf,): direction of each mode, 0 = x, 1 = y, 2 = z, 3 = torsion. i0 = int x^2 dm, s1 = int x dm = 1/2.
    phi (3, nf) = int Phi dm; x_phi (nf, 3) = int x phi_a dm; pairs (nf, nf, 3, 3) = int phi_a phi_b^T dm; mass (nf,),
    of torsion over rho I_p L; kappa (nf,): stiffness over E A / L, E I / L^3 or G J / L; H, xH (nf, nf) = int H dm,
    int x H dm; twist: None without torsion. Exact zeros where zero.
    """

    axes: tuple[int, ...]
    i0: float
    phi: Array
    x_phi: Array
    pairs: Array
    mass: Array
    kappa: Array
    H: Array
    xH: Array
    twist: TwistIntegrals | None
    sets: ModeSets

    def point(self, at: float) -> BeamPoint:
        """Shapes at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        nf = len(self.axes)
        shape, turn, twist = np.zeros((3, nf)), np.zeros((3, nf)), np.zeros(nf)
        H, H_twist = np.zeros((2, nf, nf))
        for own, axis, modes in _each(self.sets):
            phi, slope, eta = modes.at(at)
            if axis == TORSION:
                twist[own], H_twist[own, own] = phi, eta
                continue
            shape[axis, own] = phi
            if axis in TURN:
                about, sign = TURN[axis]
                turn[about, own], H[own, own] = sign * slope, eta
        return BeamPoint(fixed(shape), fixed(turn), fixed(twist), fixed(H), fixed(H_twist))


def _each(sets: ModeSets) -> Iterator[tuple[slice, int, BeamModes]]:
    """The modes of each set among all, its axis, its shapes."""
    first = 0
    for axis, modes in sets:
        yield slice(first, first + modes.modes), axis, modes
        first += modes.modes


def beam_integrals(sets: ModeSets) -> BeamIntegrals:
    """Sums over the points of the mass (20). sets: (axis, modes in the same panels), at least one."""
    xi, mu = sets[0][1].xi, sets[0][1].mu
    axes = tuple(axis for axis, modes in sets for _ in range(modes.modes))
    nf = len(axes)
    phi, (H, xH) = np.zeros((len(xi), 3, nf)), np.zeros((2, nf, nf))
    twist = None
    for own, axis, modes in _each(sets):
        if axis == TORSION:
            twist = _twist(modes, own, nf)
            continue
        phi[:, axis, own] = modes.phi
        if axis in TURN:
            H[own, own], xH[own, own] = modes.H, modes.xH
    return BeamIntegrals(
        axes,
        float(mu @ xi**2),
        fixed(clean(np.einsum("k,kia->ia", mu, phi), 1.0)),
        fixed(clean(np.einsum("k,kia->ai", mu * xi, phi), 1.0)),
        fixed(clean(np.einsum("k,kia,kjb->abij", mu, phi, phi), 1.0)),
        fixed(np.concatenate([np.diag(modes.mass) for _, modes in sets])),
        fixed(np.concatenate([np.diag(modes.kappa) for _, modes in sets])),
        fixed(H),
        fixed(xH),
        twist,
        sets,
    )


def _twist(modes: BeamModes, own: slice, nf: int) -> TwistIntegrals:
    first, (pairs, H, xH) = np.zeros(nf), np.zeros((3, nf, nf))
    first[own], pairs[own, own], H[own, own], xH[own, own] = modes.mu @ modes.phi, modes.mass, modes.H, modes.xH
    return TwistIntegrals(fixed(clean(first, 1.0)), fixed(pairs), fixed(H), fixed(xH))
