"""Free rigid body, frame origin away from the centre of mass: q_i = (R_o, theta), Euler angles zyx or zxz.

Centre of mass at r in the body frame, inertia J_c about it (body axes, products of inertia included). Loads:
gravity, a constant world force at a body point, a constant moment in body axes.

Derivation (Newton and Euler about the moving origin; omega, alpha in body axes, J_o = J_c + m (r.r 1 - r r^T))
    centre of mass:  R_o + A r,  acceleration R_o'' + A (alpha x r + omega x (omega x r))
    force:   m R_o'' - m A r~ alpha + m A omega~ omega~ r = F
    moment about the origin, body axes:  m r~ A^T R_o'' + J_o alpha + omega~ J_o omega = N_o
        with N_o = r x A^T (m g) + p x A^T f + n   and   F = m g + f
    alpha = G theta'' + G' theta'; the generalised force on theta is G^T N_o, so
        M_hat = [[m 1, -m A r~ G], [sym., G^T J_o G]]
        Q_R = F - m A omega~ omega~ r + m A r~ G' theta'
        Q_theta = G^T (N_o - omega~ J_o omega - J_o G' theta')
    (the second row uses (m A r~ G)^T = -m G^T r~ A^T, so -(m A r~ G)^T = m G^T r~ A^T).
    In the velocities (R_o', omega) themselves the two lines above are all there is, see `by_velocities`:
        M = [[m 1, -m A r~], [m r~ A^T, J_o]],  Q = (F - m A omega~ omega~ r, N_o - omega~ J_o omega)
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_spatial import Pose, euler_A, euler_G, euler_G_dot, tilde
from tests.hand_derived.twin_common import Array


def _inertia() -> Array:
    return np.array([[0.31, 0.022, -0.035], [0.022, 0.24, 0.041], [-0.035, 0.041, 0.19]])


@dataclass(frozen=True, eq=False)
class Params:
    """mass kg; inertia (3, 3) kg m^2 about the centre of mass; centre (3,) m in the body frame; gravity m/s^2;

    force (3,) N, world, at `point` (3,) m, body frame; moment (3,) N m, body axes; sequence "zyx" or "zxz".
    """

    mass: float = 2.3
    inertia: Array = field(default_factory=_inertia)
    centre: Array = field(default_factory=lambda: np.array([0.21, -0.13, 0.17]))
    gravity: Array = field(default_factory=lambda: np.array([0.4, -1.1, -9.81]))
    force: Array = field(default_factory=lambda: np.array([3.0, -2.0, 5.0]))
    point: Array = field(default_factory=lambda: np.array([-0.3, 0.25, 0.4]))
    moment: Array = field(default_factory=lambda: np.array([0.7, 0.3, -0.9]))
    sequence: str = "zyx"


def coordinates(params: Params) -> list[str]:
    return ["x", "y", "z", "theta1", "theta2", "theta3"]


def inertia_about_origin(p: Params) -> Array:
    """J_o (3, 3)."""
    r = p.centre
    return p.inertia + p.mass * (r @ r * np.eye(3) - np.outer(r, r))


def _loads(p: Params, A: Array) -> tuple[Array, Array]:
    """(F, N_o) of the derivation."""
    weight = p.mass * p.gravity
    moment = np.cross(p.centre, A.T @ weight) + np.cross(p.point, A.T @ p.force) + p.moment
    return weight + p.force, moment


def by_velocities(params: Params, A: Array, omega: Array) -> tuple[Array, Array]:
    """(M, Q) of M (R_o'', omega') = Q, omega in body axes: Newton's line, and Euler's about the origin."""
    p, J = params, inertia_about_origin(params)
    F, N = _loads(p, A)
    corner = -p.mass * A @ tilde(p.centre)
    M = np.block([[p.mass * np.eye(3), corner], [corner.T, J]])
    on_R = F - p.mass * A @ np.cross(omega, np.cross(omega, p.centre))
    return M, np.concatenate([on_R, N - np.cross(omega, J @ omega)])


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    A, G = euler_A(params.sequence, q_i[3:]), euler_G(params.sequence, q_i[3:])
    corner = -params.mass * A @ tilde(params.centre) @ G
    rotation = G.T @ inertia_about_origin(params) @ G
    return np.block([[params.mass * np.eye(3), corner], [corner.T, rotation]])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, theta, theta_dot = params, q_i[3:], q_i_dot[3:]
    A, G = euler_A(p.sequence, theta), euler_G(p.sequence, theta)
    omega, bias = G @ theta_dot, euler_G_dot(p.sequence, theta, theta_dot) @ theta_dot
    F, N = _loads(p, A)
    J, r = inertia_about_origin(p), p.centre
    on_R = F - p.mass * A @ np.cross(omega, np.cross(omega, r)) + p.mass * A @ np.cross(r, bias)
    return np.concatenate([on_R, G.T @ (N - np.cross(omega, J @ omega) - J @ bias)])


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Generalised force of the force at the point and of the moment (gravity is in the potential)."""
    A, G = euler_A(params.sequence, q_i[3:]), euler_G(params.sequence, q_i[3:])
    return np.concatenate([params.force, G.T @ (np.cross(params.point, A.T @ params.force) + params.moment)])


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    A = euler_A(params.sequence, q_i[3:])
    return [Pose(params.mass, params.inertia, q_i[:3] + A @ params.centre, A)]


def accelerations(params: Params, A: Array, omega: Array) -> tuple[Array, Array]:
    """(R_o'', omega' in body axes) for any parametrisation of the orientation; omega in body axes.

    Newton for the centre of mass, Euler about it, then R_o'' = a_c - A (omega' x r + omega x (omega x r)).
    """
    p = params
    moment = np.cross(p.point - p.centre, A.T @ p.force) + p.moment
    omega_dot = np.linalg.solve(p.inertia, moment - np.cross(omega, p.inertia @ omega))
    a_c = p.gravity + p.force / p.mass
    lever = np.cross(omega_dot, p.centre) + np.cross(omega, np.cross(omega, p.centre))
    return a_c - A @ lever, omega_dot


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    """(T, V); V of gravity only."""
    kinetic = 0.5 * q_i_dot @ M_hat(params, q_i, t) @ q_i_dot
    return kinetic, -params.mass * params.gravity @ poses(params, q_i, t)[0].R_c


def momenta(params: Params, R_o: Array, A: Array, R_o_dot: Array, omega: Array) -> tuple[Array, Array]:
    """(linear momentum, angular momentum about the world origin), world; omega in body axes."""
    p = params
    linear = p.mass * (R_o_dot + A @ np.cross(omega, p.centre))
    return linear, np.cross(R_o + A @ p.centre, linear) + A @ p.inertia @ omega
