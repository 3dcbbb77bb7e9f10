"""Case F2's beam for `twin_hub_beam`: clamped-free eigenfunctions sampled at nodes, lumped masses.

phi_j(x) = cosh(b xi) - cos(b xi) - sigma (sinh(b xi) - sin(b xi)), xi = x/L, cosh b cos b = -1,
sigma = (cosh b + cos b)/(sinh b + sin b). Masses by the trapezoid rule (half at the ends);
K_ff = E I int phi'' phi'' dx and H_k = int_0^{x_k} phi' phi' dx by the composite Simpson rule.
These are continuum shapes; a generator that takes modes from a finite-element mesh gets slightly different
numbers, so a test of generated code must hand its own masses, shapes, K_ff and H_k to `Params`.
"""

from __future__ import annotations

import math

import numpy as np

from tests.hand_derived.twin_common import Array
from tests.hand_derived.twin_hub_beam import Params

LENGTH, AREA, SECOND_MOMENT, MODULUS, DENSITY = 8.0, 7.2968e-5, 8.2189e-9, 6.8952e10, 2766.7


def f2_torque(t: float) -> float:
    """10 sin(pi t) N m for t < 2 s, then 0."""
    return 10.0 * math.sin(math.pi * t) if t < 2.0 else 0.0


def clamped_free_root(j: int) -> float:
    """j-th root (j = 1, 2, ...) of cosh b cos b = -1 by Newton on cos b + 1/cosh b."""
    b = 1.8751 if j == 1 else (j - 0.5) * math.pi
    for _ in range(20):
        b -= (math.cos(b) + 1 / math.cosh(b)) / (-math.sin(b) - math.sinh(b) / math.cosh(b) ** 2)
    return b


def clamped_free_shape(b: float, x: Array) -> tuple[Array, Array, Array]:
    """(phi, phi', phi'') at x (m)."""
    sigma = (math.cosh(b) + math.cos(b)) / (math.sinh(b) + math.sin(b))
    z, k = b * x / LENGTH, b / LENGTH
    phi = np.cosh(z) - np.cos(z) - sigma * (np.sinh(z) - np.sin(z))
    slope = k * (np.sinh(z) + np.sin(z) - sigma * (np.cosh(z) - np.cos(z)))
    curvature = k**2 * (np.cosh(z) + np.cos(z) - sigma * (np.sinh(z) + np.sin(z)))
    return phi, slope, curvature


def f2_params(
    elements: int = 100,
    modes: int = 3,
    stiffening: bool = False,
    damping_ratio: float = 0.0,
) -> Params:
    """Case F2 with J_hub = 10 and the half-sine torque; shapes have tip value +-2."""
    x = np.linspace(0.0, LENGTH, elements + 1)
    masses = np.full(elements + 1, DENSITY * AREA * LENGTH / elements)
    masses[[0, -1]] /= 2
    roots = [clamped_free_root(j + 1) for j in range(modes)]
    fine = np.linspace(0.0, LENGTH, 2 * elements + 1)
    sampled = [clamped_free_shape(b, fine) for b in roots]
    phi, slope, curvature = (np.array([s[n] for s in sampled]).T for n in range(3))
    cell = LENGTH / elements / 6 * np.array([1.0, 4.0, 1.0])

    def per_element(f: Array) -> Array:
        product = f[:, :, None] * f[:, None, :]
        return cell[0] * product[:-1:2] + cell[1] * product[1::2] + cell[2] * product[2::2]

    K_ff = MODULUS * SECOND_MOMENT * per_element(curvature).sum(axis=0)
    H = np.concatenate([np.zeros((1, modes, modes)), np.cumsum(per_element(slope), axis=0)])
    M_diag = masses @ phi[::2] ** 2
    return Params(
        masses=masses,
        positions=x,
        shapes=phi[::2],
        K_ff=K_ff,
        D_ff=np.diag(2 * damping_ratio * np.sqrt(np.diag(K_ff) * M_diag)),
        foreshortening=H if stiffening else None,
        torque=f2_torque,
    )
