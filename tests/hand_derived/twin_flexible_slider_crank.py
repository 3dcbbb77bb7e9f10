"""Flexible slider-crank, free (or torque-driven) crank: q_i = (crank.theta, rod.q1 .. rod.q<nf>).

Derivation: the tree z = (theta1, theta2, q_f) of `twin_rod_tree` obeys M z'' = h while the loop is open.
Keeping the tip on y = 0 fixes theta2. With z' = B q_i' and z'' = B q_i'' + b, b = (0, kappa_0, 0), virtual
work along B removes the tip's reaction:
    M_hat = B^T M B,   Q_hat = B^T (h - M b).
The Jacobians are complex-step derivatives of these hand-derived M_hat and Q_hat (exact to rounding; total,
through theta2).

Joint order A, B, slide, C (rows in `twin_slider_crank_bodies`); q_d is everything but q_i, in the order of q.
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
    return ["crank.theta", *coordinates(params)[6:-3]]


def tree(params: Params, q_i: Array) -> Array:
    return np.concatenate([[q_i[0], theta2_of(params, q_i[0], q_i[1:])], q_i[1:]])


def condensed(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[Array, Array]:
    """(M_hat, Q_hat) at once."""
    z = tree(params, q_i)
    k = geometry(params, z)
    basis = loop_basis(params, z, k)
    z_dot = basis @ q_i_dot
    mass = tree_mass(params, z, k)
    force = tree_force(params, z, z_dot, k) - mass[:, 1] * closure_bias(params, z, z_dot, k)
    return basis.T @ mass @ basis, basis.T @ force


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
    return full_from_tree(params, tree(params, q_i))


def q_d(params: Params, q_i: Array, t: float) -> Array:
    q = q_full(params, q_i, t)
    return np.concatenate([q[[0, 1, 3, 4, 5]], q[-3:]])


def C(params: Params, q: Array, t: float) -> Array:
    return bodies.constraints(params, q, t, driven=False)


def C_q(params: Params, q: Array, t: float) -> Array:
    return bodies.constraint_jacobian(params, q, t, driven=False)


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    return bodies.energy(params, q, q_dot, t)


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i: torque on the crank, modal damping."""
    return np.concatenate([[params.torque + 0 * q_i_dot[0]], -params.rod.D_ff @ q_i_dot[1:]])
