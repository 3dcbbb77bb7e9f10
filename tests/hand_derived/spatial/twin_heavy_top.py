"""Heavy top: a rigid body on a spherical joint at the world point `pivot`, Euler angles zxz: q_i = theta (3,).

The body frame's origin is the fixed point; centre of mass at r, inertia J_c about it (body axes).

Derivation (Euler about the fixed point, omega and alpha in body axes, J_o = J_c + m (r.r 1 - r r^T))
    J_o alpha + omega x J_o omega = r x A^T m g,   alpha = G theta'' + G' theta', virtual turns G delta theta:
        M_hat = G^T J_o G,   Q_hat = G^T (r x A^T m g - omega x J_o omega - J_o G' theta')
    Reaction on the body at the fixed point, world: m (a_c - g), a_c = A (alpha x r + omega x (omega x r)).
    With J_o = diag(I, I, I3) and r = (0, 0, l) this is Lagrange's top: p3 = I3 (theta3' + theta1' cos theta2)
    and p1 = (I sin^2 theta2) theta1' + p3 cos theta2 are constant for gravity along -z.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_spatial import Pose, euler_A, euler_G, euler_G_dot
from tests.hand_derived.twin_common import Array


def _inertia() -> Array:
    return np.array([[0.21, 0.012, -0.025], [0.012, 0.17, 0.031], [-0.025, 0.031, 0.13]])


@dataclass(frozen=True, eq=False)
class Params:
    """mass kg; inertia (3, 3) kg m^2 about the centre of mass; centre (3,) m; pivot (3,) m world; gravity m/s^2."""

    mass: float = 1.7
    inertia: Array = field(default_factory=_inertia)
    centre: Array = field(default_factory=lambda: np.array([0.11, -0.07, 0.42]))
    pivot: Array = field(default_factory=lambda: np.array([0.3, -0.2, 0.5]))
    gravity: Array = field(default_factory=lambda: np.array([0.3, 0.6, -9.81]))
    sequence: str = "zxz"


def coordinates(params: Params) -> list[str]:
    return ["theta1", "theta2", "theta3"]


def inertia_about_pivot(p: Params) -> Array:
    """J_o (3, 3)."""
    r = p.centre
    return p.inertia + p.mass * (r @ r * np.eye(3) - np.outer(r, r))


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    G = euler_G(params.sequence, q_i)
    return G.T @ inertia_about_pivot(params) @ G


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    A, G, J = euler_A(p.sequence, q_i), euler_G(p.sequence, q_i), inertia_about_pivot(p)
    omega, bias = G @ q_i_dot, euler_G_dot(p.sequence, q_i, q_i_dot) @ q_i_dot
    weight = np.cross(p.centre, A.T @ (p.mass * p.gravity))
    return G.T @ (weight - np.cross(omega, J @ omega) - J @ bias)


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return np.zeros(3)


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    A = euler_A(params.sequence, q_i)
    return [Pose(params.mass, params.inertia, params.pivot + A @ params.centre, A)]


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    kinetic = 0.5 * q_i_dot @ M_hat(params, q_i, t) @ q_i_dot
    return kinetic, -params.mass * params.gravity @ poses(params, q_i, t)[0].R_c


def reaction(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Force (3,) N, world, of the spherical joint on the body."""
    p = params
    A, G = euler_A(p.sequence, q_i), euler_G(p.sequence, q_i)
    q_i_ddot = np.linalg.solve(M_hat(p, q_i, t), Q_hat(p, q_i, q_i_dot, t))
    omega = G @ q_i_dot
    alpha = G @ q_i_ddot + euler_G_dot(p.sequence, q_i, q_i_dot) @ q_i_dot
    a_c = A @ (np.cross(alpha, p.centre) + np.cross(omega, np.cross(omega, p.centre)))
    return p.mass * (a_c - p.gravity)
