"""Double pendulum: bodies `upper` (m1, J1, a1, l1) and `lower` (m2, J2, a2), absolute angles theta1, theta2.

Joints: revolute `shoulder` (ground.origin, upper.origin), revolute `elbow` (upper.tip at (l1, 0),
lower.origin). J are inertias about the centres of mass, which lie at (a, 0) in the body frames; gravity is
(0, -g).

Derivation (Lagrange, q_i = (theta1, theta2)); e_k = (cos, sin)(theta_k), n_k = (-sin, cos)(theta_k),
    D = theta2 - theta1, h = m2 l1 a2
    velocities of the centres: v1 = a1 theta1' n1,  v2 = l1 theta1' n1 + a2 theta2' n2,  n1.n2 = cos D
    T = 1/2 (J1 + m1 a1^2 + m2 l1^2) theta1'^2 + 1/2 (J2 + m2 a2^2) theta2'^2 + h cos D theta1' theta2'
    V = g [(m1 a1 + m2 l1) sin theta1 + m2 a2 sin theta2]
    dampers: torque -c1 theta1' on `upper` and -/+ c2 (theta2' - theta1') on lower/upper.
    theta1: d/dt(h cos D theta2') - dT/dtheta1
            = h cos D theta2'' - h sin D (theta2' - theta1') theta2' - h sin D theta1' theta2'
            = h cos D theta2'' - h sin D theta2'^2
    theta2: d/dt(h cos D theta1') - dT/dtheta2
            = h cos D theta1'' - h sin D (theta2' - theta1') theta1' + h sin D theta1' theta2'
            = h cos D theta1'' + h sin D theta1'^2
    Hence
        M_hat = [[J1 + m1 a1^2 + m2 l1^2, h cos D], [h cos D, J2 + m2 a2^2]]
        Q_1 = + h sin D theta2'^2 - g (m1 a1 + m2 l1) cos theta1 - c1 theta1' + c2 (theta2' - theta1')
        Q_2 = - h sin D theta1'^2 - g m2 a2 cos theta2 - c2 (theta2' - theta1')

q = (upper.x, upper.y, upper.theta, lower.x, lower.y, lower.theta).
Rows of C: shoulder x, y = (upper.x, upper.y); elbow x, y = lower.origin - upper.tip.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """SI units: masses kg, inertias kg m^2, lengths m, g m/s^2, dampers N m s/rad."""

    m1: float = 1.3
    J1: float = 0.12
    a1: float = 0.45
    l1: float = 1.0
    m2: float = 0.8
    J2: float = 0.07
    a2: float = 0.4
    g: float = 9.81
    c1: float = 0.0
    c2: float = 0.0


def coordinates(params: Params) -> list[str]:
    return ["upper.x", "upper.y", "upper.theta", "lower.x", "lower.y", "lower.theta"]


def independent(params: Params) -> list[str]:
    return ["upper.theta", "lower.theta"]


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    p = params
    off = p.m2 * p.l1 * p.a2 * np.cos(q_i[1] - q_i[0])
    return np.array([[p.J1 + p.m1 * p.a1**2 + p.m2 * p.l1**2, off], [off, p.J2 + p.m2 * p.a2**2]])


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i."""
    elbow = params.c2 * (q_i_dot[1] - q_i_dot[0])
    return np.array([-params.c1 * q_i_dot[0] + elbow, -elbow])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    h_sin = p.m2 * p.l1 * p.a2 * np.sin(q_i[1] - q_i[0])
    q_1 = h_sin * q_i_dot[1] ** 2 - p.g * (p.m1 * p.a1 + p.m2 * p.l1) * np.cos(q_i[0])
    q_2 = -h_sin * q_i_dot[0] ** 2 - p.g * p.m2 * p.a2 * np.cos(q_i[1])
    return np.array([q_1, q_2]) + Q_applied(p, q_i, q_i_dot, t)


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    h_cos = p.m2 * p.l1 * p.a2 * np.cos(q_i[1] - q_i[0])
    w1, w2 = q_i_dot[0] ** 2, q_i_dot[1] ** 2
    weight_1 = p.g * (p.m1 * p.a1 + p.m2 * p.l1) * np.sin(q_i[0])
    weight_2 = p.g * p.m2 * p.a2 * np.sin(q_i[1])
    return np.array([[-h_cos * w2 + weight_1, h_cos * w2], [h_cos * w1, -h_cos * w1 + weight_2]])


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    h_sin = p.m2 * p.l1 * p.a2 * np.sin(q_i[1] - q_i[0])
    row_1 = [-p.c1 - p.c2, 2 * h_sin * q_i_dot[1] + p.c2]
    row_2 = [-2 * h_sin * q_i_dot[0] + p.c2, -p.c2]
    return np.array([row_1, row_2])


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    # d(h cos D)/dtheta1 = h sin D, d(h cos D)/dtheta2 = -h sin D
    h_sin = params.m2 * params.l1 * params.a2 * np.sin(q_i[1] - q_i[0])
    return h_sin * np.array([[a[1], -a[1]], [a[0], -a[0]]])


def q_full(params: Params, q_i: Array, t: float) -> Array:
    zero = 0 * q_i[0]
    tip = [params.l1 * np.cos(q_i[0]), params.l1 * np.sin(q_i[0])]
    return np.array([zero, zero, q_i[0], tip[0], tip[1], q_i[1]])


def q_d(params: Params, q_i: Array, t: float) -> Array:
    return q_full(params, q_i, t)[[0, 1, 3, 4]]


def C(params: Params, q: Array, t: float) -> Array:
    elbow_x = q[3] - q[0] - params.l1 * np.cos(q[2])
    elbow_y = q[4] - q[1] - params.l1 * np.sin(q[2])
    return np.array([q[0], q[1], elbow_x, elbow_y])


def C_q(params: Params, q: Array, t: float) -> Array:
    s, c = params.l1 * np.sin(q[2]), params.l1 * np.cos(q[2])
    return np.array([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [-1, 0, s, 1, 0, 0], [0, -1, -c, 0, 1, 0]])


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V) at full coordinates."""
    p = params
    kinetic, potential = 0.0, 0.0
    for k, mass, inertia, arm in ((0, p.m1, p.J1, p.a1), (3, p.m2, p.J2, p.a2)):
        vx = q_dot[k] - arm * np.sin(q[k + 2]) * q_dot[k + 2]
        vy = q_dot[k + 1] + arm * np.cos(q[k + 2]) * q_dot[k + 2]
        kinetic = kinetic + 0.5 * mass * (vx**2 + vy**2) + 0.5 * inertia * q_dot[k + 2] ** 2
        potential = potential + mass * p.g * (q[k + 1] + arm * np.sin(q[k + 2]))
    return kinetic, potential
