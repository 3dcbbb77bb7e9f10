"""Planar inertia shape integrals of a beam in its own frame, ready to be scaled to a real beam."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from symgen.modes.cleaning import Array, clean, fixed
from symgen.modes.exact import BarModes, BeamModes
from symgen.modes.mesh import check_fraction


@dataclass(frozen=True, eq=False)
class BeamPoint:
    """Shapes at a point, q_f = (lateral, axial): its displacement is (shape_x . q_f, shape_y . q_f).

    shape_x (nf,), shape_y (nf,): dimensionless.  slope (nf,): d shape_y / d xi; rotation (slope / L) . q_f.
    H (nf, nf): foreshortening; the point moves back by 1/2 q_f^T (H / L) q_f along x if the body stiffens.
    """

    shape_x: Array
    shape_y: Array
    slope: Array
    H: Array


@dataclass(frozen=True, eq=False)
class BeamIntegrals:
    """Shape integrals for L = rho A = 1; origin at the start, x along the beam, q_f = (lateral, axial modes).

    With m = rho A L, the integrals of Eq. 20 are (rho0 = (x, 0), Phi = rows Phi_x and Phi_y, nf columns):
      s1                      int x dm = m L s1                           [kg m]
      i0                      int x^2 dm = m L^2 i0                       [kg m^2]
      phi_x, phi_y (nf,)      int Phi dm = m (phi_x; phi_y)               [kg]
      xi_phi_x (nf,)          int rho0 . Phi dm = m L xi_phi_x            [kg m]
      xi_phi_y (nf,)          int rho0 x Phi dm = m L xi_phi_y            [kg m]
      mass (nf, nf)           M_ff = int Phi^T Phi dm = m mass            [kg]
      phi_cross_phi (nf, nf)  int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm = m phi_cross_phi, skew   [kg]
      kappa_lateral, kappa_axial   K_ff = blockdiag(EI / L^3 kappa_lateral, EA / L kappa_axial)   [N/m]
      H (nf, nf)              int H(x) dm = (m / L) H                     [kg/m]
      xH (nf, nf)             int x H(x) dm = m xH                        [kg]
    H and xH are zero outside the lateral block. Structural zeros are exact zeros.
    """

    s1: float
    i0: float
    phi_x: Array
    phi_y: Array
    xi_phi_x: Array
    xi_phi_y: Array
    mass: Array
    phi_cross_phi: Array
    kappa_lateral: Array
    kappa_axial: Array
    H: Array
    xH: Array
    lateral: BeamModes | None
    axial: BarModes | None

    @property
    def nf(self) -> int:
        """Number of modal coordinates, lateral then axial."""
        return len(self.phi_x)

    def point(self, at: float) -> BeamPoint:
        """Shapes at the fraction `at` of the length. Raises ValueError if `at` is outside [0, 1]."""
        check_fraction(at)
        shape_x, shape_y, slope = np.zeros(self.nf), np.zeros(self.nf), np.zeros(self.nf)
        foreshortening = np.zeros((self.nf, self.nf))
        split = self.lateral.modes if self.lateral else 0
        if self.lateral:
            shape_y[:split], slope[:split], foreshortening[:split, :split] = self.lateral.interpolate(at)
        if self.axial:
            shape_x[split:] = self.axial.interpolate(at)
        return BeamPoint(fixed(shape_x), fixed(shape_y), fixed(slope), fixed(foreshortening))


def beam_integrals(lateral: BeamModes | None, axial: BarModes | None) -> BeamIntegrals:
    """Shape integrals of a beam with these modes: sums over the points of the mass (Eqs. 15-20).

    Without any modes the beam is a rigid uniform rod (nf = 0, i0 = 1/3).
    Raises ValueError if the two mode sets have different meshes.
    """
    if lateral and axial and not np.array_equal(lateral.xi, axial.xi):
        raise ValueError(
            f"lateral modes have {len(lateral.xi)} points and axial modes {len(axial.xi)}; use the same mesh for both"
        )
    meshed = lateral or axial
    xi, mu = (meshed.xi, meshed.mu) if meshed else (np.zeros(0), np.zeros(0))
    x, y = _values(lateral, axial)
    cross = np.einsum("k,ka,kb->ab", mu, x, y)
    none = np.zeros((axial.modes, axial.modes)) if axial else None
    return BeamIntegrals(
        s1=0.5,  # mirrored points have equal masses, so the centre of mass is the middle exactly
        i0=math.fsum(mu * xi * xi) if meshed else 1.0 / 3.0,
        # Shapes are at most 1 and the masses add up to 1: the size of every sum of them is 1.
        phi_x=fixed(clean(mu @ x, 1.0)),
        phi_y=fixed(clean(mu @ y, 1.0)),
        xi_phi_x=fixed(clean((mu * xi) @ x, 1.0)),
        xi_phi_y=fixed(clean((mu * xi) @ y, 1.0)),
        mass=fixed(_block_diagonal(lateral.mass if lateral else None, axial.mass if axial else None)),
        phi_cross_phi=fixed(clean(cross - cross.T, 1.0)),
        kappa_lateral=lateral.kappa if lateral else fixed(np.zeros((0, 0))),
        kappa_axial=axial.kappa if axial else fixed(np.zeros((0, 0))),
        H=fixed(_block_diagonal(lateral.H if lateral else None, none)),
        xH=fixed(_block_diagonal(lateral.xH if lateral else None, none)),
        lateral=lateral,
        axial=axial,
    )


def _values(lateral: BeamModes | None, axial: BarModes | None) -> tuple[Array, Array]:
    """Phi_x and Phi_y (points, nf) over all modal coordinates, lateral first."""
    meshed = lateral or axial
    split = lateral.modes if lateral else 0
    nf = split + (axial.modes if axial else 0)
    x, y = (np.zeros((len(meshed.xi) if meshed else 0, nf)) for _ in range(2))
    if lateral:
        y[:, :split] = lateral.phi
    if axial:
        x[:, split:] = axial.u
    return x, y


def _block_diagonal(first: Array | None, second: Array | None) -> Array:
    blocks = [block for block in (first, second) if block is not None]
    size = sum(len(block) for block in blocks)
    whole = np.zeros((size, size))
    start = 0
    for block in blocks:
        whole[start : start + len(block), start : start + len(block)] = block
        start += len(block)
    return whole
