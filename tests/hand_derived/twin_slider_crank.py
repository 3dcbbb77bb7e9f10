"""Rigid slider-crank: crank (l1), rod (l2), slider (m3, on the line y = 0); q_i = (crank.theta).

Joints, in this order: A revolute ground.origin - crank.origin, B revolute crank.tip - rod.origin,
slide prismatic ground.origin - slider.origin, C revolute rod.tip - slider.origin. Inertias J1, J2 about the
centres of mass (a1, 0), (a2, 0); gravity (0, -g); constant torque on the crank. The slider does not turn, so
its inertia J3 drops out (kept for `energy`).

Derivation (Lagrange, one degree of freedom; branch cos(theta2) > 0, a dash is d/dtheta1, k = dtheta2/dtheta1)
    Closure  l1 sin1 + l2 sin2 = 0, so theta2 = -asin(l1 sin1 / l2), and x3 = l1 cos1 + l2 cos2.
    The derivatives of the closure and what they yield:
      l1 cos1 + l2 cos2 k = 0
      -l1 sin1 + l2 (cos2 k' - sin2 k^2) = 0
      -l1 cos1 + l2 (cos2 k'' - 3 sin2 k k' - cos2 k^3) = 0
      k   = -l1 cos1 / (l2 cos2)
      k'  = (l1 sin1 + l2 sin2 k^2) / (l2 cos2)
      k'' = (l1 cos1 + 3 l2 sin2 k k') / (l2 cos2) + k^3
      X   = x3'   = -l1 sin1 - l2 sin2 k
      X'  = x3''  = -l1 cos1 - l2 (cos2 k^2 + sin2 k')
      X'' = x3''' =  l1 sin1 - l2 (3 cos2 k k' + sin2 k'' - sin2 k^3)
    Rod centre l1 e1 + a2 e2 moves with theta1' (l1 n1 + a2 k n2), n1.n2 = cos21 = cos(theta2 - theta1):
      M   = J1 + m1 a1^2 + m2 l1^2 + (J2 + m2 a2^2) k^2 + 2 m2 l1 a2 k cos21 + m3 X^2
      M'  = 2 (J2 + m2 a2^2) k k' + 2 m2 l1 a2 [k' cos21 - k (k - 1) sin21] + 2 m3 X X'
      M'' = 2 (J2 + m2 a2^2)(k'^2 + k k'') + 2 m3 (X'^2 + X X'')
            + 2 m2 l1 a2 [k'' cos21 - 2 k' (k - 1) sin21 - k (k - 1)^2 cos21 - k k' sin21]
      V   = g [(m1 a1 + m2 l1) sin1 + m2 a2 sin2]
    T = 1/2 M theta1'^2, hence M theta1'' = torque - 1/2 M' theta1'^2 - V'.

q = (crank, rod, slider) x (x, y, theta). Rows of C: A x, y; B x, y (rod.origin - crank.tip);
slide: slider.y, slider.theta; C x, y (slider.origin - rod.tip).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """SI units: lengths m, masses kg, inertias kg m^2, g m/s^2, torque N m."""

    l1: float = 0.15
    l2: float = 0.3
    m1: float = 0.36
    m2: float = 0.151104
    m3: float = 0.075552
    J1: float = 0.000702
    J2: float = 0.00113328
    J3: float = 1e-4
    a1: float = 0.075
    a2: float = 0.15
    g: float = 9.81
    torque: float = 0.0


def coordinates(params: Params) -> list[str]:
    return [f"{body}.{part}" for body in ("crank", "rod", "slider") for part in ("x", "y", "theta")]


def independent(params: Params) -> list[str]:
    return ["crank.theta"]


def coefficients(params: Params, theta1: complex) -> tuple[Array, Array, Array]:
    """((theta2, k, k', k''), (x3, X, X', X''), (M, M', M'')) at theta1."""
    p = params
    s1, c1 = np.sin(theta1), np.cos(theta1)
    th2 = -np.arcsin(p.l1 * s1 / p.l2)
    s2, c2 = np.sin(th2), np.cos(th2)
    k = -p.l1 * c1 / (p.l2 * c2)
    kp = (p.l1 * s1 + p.l2 * s2 * k**2) / (p.l2 * c2)
    kpp = (p.l1 * c1 + 3 * p.l2 * s2 * k * kp) / (p.l2 * c2) + k**3
    x = -p.l1 * s1 - p.l2 * s2 * k
    xp = -p.l1 * c1 - p.l2 * (c2 * k**2 + s2 * kp)
    xpp = p.l1 * s1 - p.l2 * (3 * c2 * k * kp + s2 * kpp - s2 * k**3)
    s21, c21 = np.sin(th2 - theta1), np.cos(th2 - theta1)
    i2, h = p.J2 + p.m2 * p.a2**2, p.m2 * p.l1 * p.a2
    mass = p.J1 + p.m1 * p.a1**2 + p.m2 * p.l1**2 + i2 * k**2 + 2 * h * k * c21 + p.m3 * x**2
    mass_p = 2 * i2 * k * kp + 2 * h * (kp * c21 - k * (k - 1) * s21) + 2 * p.m3 * x * xp
    bracket = kpp * c21 - 2 * kp * (k - 1) * s21 - k * (k - 1) ** 2 * c21 - k * kp * s21
    mass_pp = 2 * i2 * (kp**2 + k * kpp) + 2 * h * bracket + 2 * p.m3 * (xp**2 + x * xpp)
    slider = np.array([p.l1 * c1 + p.l2 * c2, x, xp, xpp])
    return np.array([th2, k, kp, kpp]), slider, np.array([mass, mass_p, mass_pp])


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return coefficients(params, q_i[0])[2][:1].reshape(1, 1)


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    (th2, k, _, _), _, (_, mass_p, _) = coefficients(p, q_i[0])
    weight = (p.m1 * p.a1 + p.m2 * p.l1) * np.cos(q_i[0]) + p.m2 * p.a2 * np.cos(th2) * k
    return np.array([p.torque - 0.5 * mass_p * q_i_dot[0] ** 2 - p.g * weight])


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    (th2, k, kp, _), _, (_, _, mass_pp) = coefficients(p, q_i[0])
    weight = -(p.m1 * p.a1 + p.m2 * p.l1) * np.sin(q_i[0])
    weight = weight + p.m2 * p.a2 * (np.cos(th2) * kp - np.sin(th2) * k**2)
    return np.array([[-0.5 * mass_pp * q_i_dot[0] ** 2 - p.g * weight]])


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return np.array([[-coefficients(params, q_i[0])[2][1] * q_i_dot[0]]])


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    return np.array([[coefficients(params, q_i[0])[2][1] * a[0]]])


def q_full(params: Params, q_i: Array, t: float) -> Array:
    p, theta1 = params, q_i[0]
    rod, slider, _ = coefficients(p, theta1)
    zero = 0 * theta1
    tip = [p.l1 * np.cos(theta1), p.l1 * np.sin(theta1)]
    return np.array([zero, zero, theta1, tip[0], tip[1], rod[0], slider[0], zero, zero])


def q_d(params: Params, q_i: Array, t: float) -> Array:
    return np.delete(q_full(params, q_i, t), 2)


def C(params: Params, q: Array, t: float) -> Array:
    p = params
    rows_b = [q[3] - q[0] - p.l1 * np.cos(q[2]), q[4] - q[1] - p.l1 * np.sin(q[2])]
    rows_c = [q[6] - q[3] - p.l2 * np.cos(q[5]), q[7] - q[4] - p.l2 * np.sin(q[5])]
    return np.array([q[0], q[1], *rows_b, q[7], q[8], *rows_c])


def C_q(params: Params, q: Array, t: float) -> Array:
    p = params
    s1, c1 = p.l1 * np.sin(q[2]), p.l1 * np.cos(q[2])
    s2, c2 = p.l2 * np.sin(q[5]), p.l2 * np.cos(q[5])
    return np.array(
        [
            [1, 0, 0, 0, 0, 0, 0, 0, 0],
            [0, 1, 0, 0, 0, 0, 0, 0, 0],
            [-1, 0, s1, 1, 0, 0, 0, 0, 0],
            [0, -1, -c1, 0, 1, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, 0, 0, 1, 0],
            [0, 0, 0, 0, 0, 0, 0, 0, 1],
            [0, 0, 0, -1, 0, s2, 1, 0, 0],
            [0, 0, 0, 0, -1, -c2, 0, 1, 0],
        ]
    )


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V) at full coordinates."""
    p = params
    kinetic, potential = 0.0, 0.0
    for k, mass, inertia, arm in ((0, p.m1, p.J1, p.a1), (3, p.m2, p.J2, p.a2), (6, p.m3, p.J3, 0.0)):
        vx = q_dot[k] - arm * np.sin(q[k + 2]) * q_dot[k + 2]
        vy = q_dot[k + 1] + arm * np.cos(q[k + 2]) * q_dot[k + 2]
        kinetic = kinetic + 0.5 * mass * (vx**2 + vy**2) + 0.5 * inertia * q_dot[k + 2] ** 2
        potential = potential + mass * p.g * (q[k + 1] + arm * np.sin(q[k + 2]))
    return kinetic, potential


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i."""
    return np.array([params.torque])
