"""Flexible slider-crank with the crank angle prescribed, theta1 = Omega t: q_i = (rod.q1 .. rod.q<nf>).

Derivation: as in `twin_flexible_slider_crank`, but theta1' = Omega and theta1'' = 0 are known. With B split
into its first column B_1 (crank) and the rest B_f,
    z' = B_f q_i' + Omega B_1,   z'' = B_f q_i'' + b,   b = (0, kappa_0, 0),
    M_hat = B_f^T M B_f,   Q_hat = B_f^T (h - M b).
The torque on the crank does no virtual work and drops out. Jacobians: complex step of the hand-derived M_hat
and Q_hat.

Joint order A, drive, B, slide, C, where drive = prescribed_angle ground.origin -> crank.origin.
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived import twin_slider_crank_bodies as bodies
from tests.hand_derived.twin_common import Array, complex_step
from tests.hand_derived.twin_rod_tree import (
    Params,
    closure_bias,
    coordinates,
    full_from_tree,
    geometry,
    loop_basis,
    theta2_of,
    tree_force,
    tree_mass,
)

__all__ = ["Params", "coordinates"]


def independent(params: Params) -> list[str]:
    return coordinates(params)[6:-3]


def tree(params: Params, q_i: Array, t: float) -> Array:
    theta1 = params.Omega * t
    return np.concatenate([[theta1, theta2_of(params, theta1, q_i)], q_i])


def tree_rate(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """(theta1', theta2', q_f')."""
    z = tree(params, q_i, t)
    basis = loop_basis(params, z, geometry(params, z))
    return basis[:, 1:] @ q_i_dot + params.Omega * basis[:, 0]


def condensed(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[Array, Array]:
    """(M_hat, Q_hat) at once."""
    z = tree(params, q_i, t)
    k = geometry(params, z)
    basis = loop_basis(params, z, k)
    crank, modes = basis[:, 0], basis[:, 1:]
    z_dot = modes @ q_i_dot + params.Omega * crank
    mass = tree_mass(params, z, k)
    force = tree_force(params, z, z_dot, k) - mass[:, 1] * closure_bias(params, z, z_dot, k)
    return modes.T @ mass @ modes, modes.T @ force


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return condensed(params, q_i, 0 * q_i, t)[0]


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return condensed(params, q_i, q_i_dot, t)[1]


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return complex_step(lambda x: Q_hat(params, x, q_i_dot, t), q_i)


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return complex_step(lambda x: Q_hat(params, q_i, x, t), q_i_dot)


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    return complex_step(lambda x: M_hat(params, x, t) @ a, q_i)


def q_full(params: Params, q_i: Array, t: float) -> Array:
    return full_from_tree(params, tree(params, q_i, t))


def q_d(params: Params, q_i: Array, t: float) -> Array:
    q = q_full(params, q_i, t)
    return np.concatenate([q[:6], q[-3:]])


def C(params: Params, q: Array, t: float) -> Array:
    return bodies.constraints(params, q, t, driven=True)


def C_q(params: Params, q: Array, t: float) -> Array:
    return bodies.constraint_jacobian(params, q, t, driven=True)


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    return bodies.energy(params, q, q_dot, t)


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i: modal damping."""
    return -params.rod.D_ff @ q_i_dot
