"""Shape integrals of a straight beam: bending in one plane or two, stretching and torsion, as numbers (Eqs. 15-20).

Torsion turns a section about the beam's line by the angle u q and leaves it plane: no warping.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symgen.modes.cleaning import Array, clean, fixed
from symgen.modes.exact import BarModes, BeamModes

TORSION = 3
ModeSets = tuple[tuple[int, BeamModes | BarModes], ...]  # (axis, shapes)
TURN = {1: (2, 1.0), 2: (1, -1.0)}  # deflection along y turns about z, along z about -y


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
        first = 0
        for axis, modes in self.sets:
            own = slice(first, first + modes.modes)
            if isinstance(modes, BeamModes):
                about, sign = TURN[axis]
                shape[axis, own], slope, H[own, own] = modes.interpolate(at)
                turn[about, own] = sign * slope
            elif axis == TORSION:
                twist[own], H_twist[own, own] = modes.interpolate(at), modes.shortening(at)
            else:
                shape[axis, own] = modes.interpolate(at)
            first += modes.modes
        return BeamPoint(fixed(shape), fixed(turn), fixed(twist), fixed(H), fixed(H_twist))


def beam_integrals(sets: ModeSets) -> BeamIntegrals:
    """Sums over the points of the mass (20). sets: (axis, modes on the same mesh), at least one."""
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
        elif axis != TORSION:
            nodal[:, axis, own] = modes.u
        first += modes.modes
    return BeamIntegrals(
        axes,
        float(mu @ xi**2),
        fixed(clean(np.einsum("k,kia->ia", mu, nodal), 1.0)),
        fixed(clean(np.einsum("k,kia->ai", mu * xi, nodal), 1.0)),
        fixed(clean(np.einsum("k,kia,kjb->abij", mu, nodal, nodal), 1.0)),
        fixed(np.concatenate([np.diag(modes.mass) for _, modes in sets])),
        fixed(np.concatenate([np.diag(modes.kappa) for _, modes in sets])),
        fixed(H),
        fixed(xH),
        _twist(sets, nf),
        sets,
    )


def _twist(sets: ModeSets, nf: int) -> TwistIntegrals | None:
    """Integrals of the last set, where it is torsion."""
    axis, modes = sets[-1]
    if axis != TORSION or not isinstance(modes, BarModes):
        return None
    own = slice(nf - modes.modes, nf)
    first, (pairs, H, xH) = np.zeros(nf), np.zeros((3, nf, nf))
    first[own], pairs[own, own] = modes.mu @ modes.u, modes.mass
    eta = np.stack([modes.shortening(float(at)) for at in modes.xi])
    H[own, own] = np.einsum("k,kab->ab", modes.mu, eta)
    xH[own, own] = np.einsum("k,kab->ab", modes.mu * modes.xi, eta)
    size = float(np.abs(eta).max())
    return TwistIntegrals(fixed(clean(first, 1.0)), fixed(pairs), fixed(clean(H, size)), fixed(clean(xH, size)))
