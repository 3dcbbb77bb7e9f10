"""Shape integrals of a straight beam in space: bending in two planes and stretching, as numbers (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symgen.modes.axial import BarModes
from symgen.modes.cleaning import Array, clean, fixed
from symgen.modes.lateral import BeamModes

ALONG = 0
TURN = {1: (2, 1.0), 2: (1, -1.0)}  # deflection along y turns about z, along z about -y


@dataclass(frozen=True, eq=False)
class SpatialBeamPoint:
    """Shapes at a point: shape and turn (3, nf), rotation vector turn / L . q_f; H (nf, nf): foreshortening along x."""

    shape: Array
    turn: Array
    H: Array


@dataclass(frozen=True, eq=False)
class SpatialBeam:
    """Shape integrals for L = m = 1, origin at the start, x along the beam; modes in the order they are given.

    axes (nf,): direction of each mode, 0 = x, 1 = y, 2 = z.  i0 = int x^2 dm, s1 = int x dm = 1/2.
    phi (3, nf) = int Phi dm; x_phi (nf, 3) = int x phi_a dm; pairs (nf, nf, 3, 3) = int phi_a phi_b^T dm; mass (nf,);
    kappa (nf,): stiffness over E A / L or E I / L^3; H, xH (nf, nf) = int H dm, int x H dm. Exact zeros where zero.
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
    sets: tuple[tuple[int, BeamModes | BarModes], ...]

    def point(self, at: float) -> SpatialBeamPoint:
        """Shapes at the fraction `at` of the length. Raises ValueError outside [0, 1]."""
        nf = len(self.axes)
        shape, turn, H = np.zeros((3, nf)), np.zeros((3, nf)), np.zeros((nf, nf))
        first = 0
        for axis, modes in self.sets:
            own = slice(first, first + modes.modes)
            if isinstance(modes, BeamModes):
                about, sign = TURN[axis]
                shape[axis, own], slope, H[own, own] = modes.interpolate(at)
                turn[about, own] = sign * slope
            else:
                shape[axis, own] = modes.interpolate(at)
            first += modes.modes
        return SpatialBeamPoint(fixed(shape), fixed(turn), fixed(H))


def spatial_beam(sets: tuple[tuple[int, BeamModes | BarModes], ...]) -> SpatialBeam:
    """Sums over the points of the mass. sets: (axis, modes on the same mesh), at least one."""
    xi, mu = sets[0][1].xi, sets[0][1].mu
    axes = tuple(axis for axis, modes in sets for _ in range(modes.modes))
    nf = len(axes)
    nodal = np.zeros((len(xi), 3, nf))
    H, xH = np.zeros((nf, nf)), np.zeros((nf, nf))
    first = 0
    for axis, modes in sets:
        own = slice(first, first + modes.modes)
        if isinstance(modes, BeamModes):
            nodal[:, axis, own], H[own, own], xH[own, own] = modes.phi, modes.H, modes.xH
        else:
            nodal[:, axis, own] = modes.u
        first += modes.modes
    return SpatialBeam(
        axes,
        float(mu @ xi**2),
        fixed(clean(np.einsum("k,kia->ia", mu, nodal), 1.0)),
        fixed(clean(np.einsum("k,kia->ai", mu * xi, nodal), 1.0)),
        fixed(clean(np.einsum("k,kia,kjb->abij", mu, nodal, nodal), 1.0)),
        fixed(np.concatenate([np.diag(modes.mass) for _, modes in sets])),
        fixed(np.concatenate([np.diag(modes.kappa) for _, modes in sets])),
        fixed(H),
        fixed(xH),
        sets,
    )
