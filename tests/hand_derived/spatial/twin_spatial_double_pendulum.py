"""Spatial double pendulum: two rigid bodies, two revolute joints with skew axes: q_i = (angle1, angle2).

Joint 1: marker a on the ground at `pivot1` with axes `A_1a`; marker b on body 1 at u_1b with axes B_1b.
Joint 2: marker a on body 1 at u_2a with axes B_2a; marker b on body 2 at u_2b with axes B_2b.
Columns of the B are the marker's axes in body components; body b turns by the angle about a's z-axis:
    A_1 B_1b = A_1a R_z(angle1),  R_1 = pivot1 - A_1 u_1b
    A_2 B_2b = A_1 B_2a R_z(angle2),  R_2 = R_1 + A_1 u_2a - A_2 u_2b
Each joint has a torsional spring k and damper c: torque -(k angle + c angle') on b about the axis.

Derivation (Jourdain, world axes): z1 = A_1a e_z, z2 = A_1 B_2a e_z; arms d1 = A_1 (r_1 - u_1b),
    h = A_1 (u_2a - u_1b), d2 = A_2 (r_2 - u_2b)
    omega1 = z1 a1',  omega2 = omega1 + z2 a2'
    v1 = z1 x d1 a1',  v2 = z1 x (h + d2) a1' + z2 x d2 a2'
    z1 is fixed in the world and z2 in body 1, so z2' = omega1 x z2:
    alpha1 = z1 a1'',  alpha2 = z1 a1'' + z2 a2'' + a1' a2' z1 x z2
    a1 = z1 x d1 a1'' + omega1 x (omega1 x d1)
    a2 = ... + omega1 x (omega1 x h) + (a1' a2' z1 x z2) x d2 + omega2 x (omega2 x d2)
Reactions (world, on body b at marker b): with the inertia force m (a - g) and the rate of the moment of momentum
    L' = J alpha + omega x J omega,
    F_2 = m_2 (a2 - g),           N_2 = L_2' + d2 x F_2
    F_1 = m_1 (a1 - g) + F_2,     N_1 = L_1' + d1 x m_1 (a1 - g) + N_2 + h x F_2
    N_k is the whole moment through joint k; its part along z_k is the spring and damper torque, the rest the
    constraint's reaction.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_spatial import E_Z, Part, Pose, euler_A, jourdain, rot_z
from tests.hand_derived.twin_common import Array

_INERTIA_1 = [[0.11, 0.012, -0.008], [0.012, 0.09, 0.015], [-0.008, 0.015, 0.07]]
_INERTIA_2 = [[0.05, -0.006, 0.004], [-0.006, 0.07, 0.009], [0.004, 0.009, 0.06]]


def _axes(*theta: float) -> Array:
    return euler_A("zyx", np.array(theta))


@dataclass(frozen=True, eq=False)
class Params:
    """Masses kg, inertias (3, 3) kg m^2 about the centres, points (3,) m, axes (3, 3), k N m/rad, c N m s/rad."""

    mass1: float = 1.3
    mass2: float = 0.9
    inertia1: Array = field(default_factory=lambda: np.array(_INERTIA_1))
    inertia2: Array = field(default_factory=lambda: np.array(_INERTIA_2))
    centre1: Array = field(default_factory=lambda: np.array([0.05, 0.31, -0.08]))
    centre2: Array = field(default_factory=lambda: np.array([0.27, -0.04, 0.11]))
    pivot1: Array = field(default_factory=lambda: np.array([0.2, -0.1, 0.6]))
    A_1a: Array = field(default_factory=lambda: _axes(0.4, -0.7, 1.1))
    u_1b: Array = field(default_factory=lambda: np.array([-0.03, -0.12, 0.06]))
    B_1b: Array = field(default_factory=lambda: _axes(-0.3, 0.5, 0.2))
    u_2a: Array = field(default_factory=lambda: np.array([0.09, 0.62, 0.14]))
    B_2a: Array = field(default_factory=lambda: _axes(0.8, 0.9, -0.6))
    u_2b: Array = field(default_factory=lambda: np.array([-0.08, 0.05, -0.02]))
    B_2b: Array = field(default_factory=lambda: _axes(0.1, -0.4, 0.7))
    gravity: Array = field(default_factory=lambda: np.array([0.5, -0.8, -9.7]))
    c1: float = 0.13
    c2: float = 0.07
    k1: float = 0.0
    k2: float = 0.0


def coordinates(params: Params) -> list[str]:
    return ["joint1.angle", "joint2.angle"]


def orientations(p: Params, q_i: Array) -> tuple[Array, Array]:
    """(A_1, A_2)."""
    A_1 = p.A_1a @ rot_z(q_i[0]) @ p.B_1b.T
    return A_1, A_1 @ p.B_2a @ rot_z(q_i[1]) @ p.B_2b.T


def origins(p: Params, q_i: Array) -> tuple[Array, Array]:
    """World positions (R_1, R_2) of the two body frames."""
    A_1, A_2 = orientations(p, q_i)
    R_1 = p.pivot1 - A_1 @ p.u_1b
    return R_1, R_1 + A_1 @ p.u_2a - A_2 @ p.u_2b


def _geometry(p: Params, q_i: Array) -> tuple[Array, ...]:
    """(A_1, A_2, z1, z2, d1, h, d2), arms and axes in the world."""
    A_1, A_2 = orientations(p, q_i)
    arms = A_1 @ (p.centre1 - p.u_1b), A_1 @ (p.u_2a - p.u_1b), A_2 @ (p.centre2 - p.u_2b)
    return A_1, A_2, p.A_1a @ E_Z, A_1 @ p.B_2a @ E_Z, *arms


def _parts(p: Params, q_i: Array, q_i_dot: Array) -> list[Part]:
    A_1, A_2, z1, z2, d1, h, d2 = _geometry(p, q_i)
    w1 = z1 * q_i_dot[0]
    w2 = w1 + z2 * q_i_dot[1]
    none = np.zeros(3)
    turn = q_i_dot[0] * q_i_dot[1] * np.cross(z1, z2)
    bias1 = np.cross(w1, np.cross(w1, d1))
    bias2 = np.cross(w1, np.cross(w1, h)) + np.cross(turn, d2) + np.cross(w2, np.cross(w2, d2))
    J_v1 = np.stack([np.cross(z1, d1), none], axis=1)
    J_v2 = np.stack([np.cross(z1, h + d2), np.cross(z2, d2)], axis=1)
    J_w1, J_w2 = np.stack([z1, none], axis=1), np.stack([z1, z2], axis=1)
    I_1, I_2 = A_1 @ p.inertia1 @ A_1.T, A_2 @ p.inertia2 @ A_2.T
    return [
        Part(p.mass1, I_1, J_v1, J_w1, w1, bias1, none, p.mass1 * p.gravity, none),
        Part(p.mass2, I_2, J_v2, J_w2, w2, bias2, turn, p.mass2 * p.gravity, none),
    ]


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return jourdain(_parts(params, q_i, np.zeros(2)))[0]


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Damper torques."""
    return -np.array([params.c1, params.c2]) * q_i_dot


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    springs = np.array([params.k1, params.k2]) * q_i
    return jourdain(_parts(params, q_i, q_i_dot))[1] + Q_applied(params, q_i, q_i_dot, t) - springs


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    p, (A_1, A_2), (R_1, R_2) = params, orientations(params, q_i), origins(params, q_i)
    return [
        Pose(p.mass1, p.inertia1, R_1 + A_1 @ p.centre1, A_1),
        Pose(p.mass2, p.inertia2, R_2 + A_2 @ p.centre2, A_2),
    ]


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    """(T, V) with gravity and springs."""
    springs = 0.5 * params.k1 * q_i[0] ** 2 + 0.5 * params.k2 * q_i[1] ** 2
    weight = -sum(b.mass * params.gravity @ b.R_c for b in poses(params, q_i, t))
    return 0.5 * q_i_dot @ M_hat(params, q_i, t) @ q_i_dot, weight + springs


def reactions(params: Params, q_i: Array, q_i_dot: Array, t: float) -> list[tuple[Array, Array]]:
    """[(F_1, N_1), (F_2, N_2)]: force N and *constraint* moment N m (across the axis), world, on b at marker b."""
    p = params
    _, _, z1, z2, d1, h, d2 = _geometry(p, q_i)
    q_i_ddot = np.linalg.solve(M_hat(p, q_i, t), Q_hat(p, q_i, q_i_dot, t))
    net, rate = [], []
    for b in _parts(p, q_i, q_i_dot):
        net.append(b.mass * (b.J_v @ q_i_ddot + b.a_0) - b.force)
        rate.append(b.inertia @ (b.J_w @ q_i_ddot + b.alpha_0) + np.cross(b.omega, b.inertia @ b.omega))
    moment2 = rate[1] + np.cross(d2, net[1])
    moment1 = rate[0] + np.cross(d1, net[0]) + moment2 + np.cross(h, net[1])
    return [(net[0] + net[1], moment1 - z1 * (z1 @ moment1)), (net[1], moment2 - z2 * (z2 @ moment2))]
