"""Four-bar: crank (l1), coupler (l2), rocker (l3), ground distance d along x; q_i = (crank.theta).

Joints: A ground.origin - crank.origin, B crank.tip - coupler.origin, C coupler.tip - rocker.tip,
D ground.right (d, 0) - rocker.origin. Masses m_k, inertias J_k about the centres of mass (a_k, 0); gravity
(0, -g); constant torque on the crank.

Derivation (Lagrange, one degree of freedom); e_k, n_k the unit vectors along and normal to bar k; 21 stands
for theta2 - theta1 and so on; a dash is d/dtheta1 (in theta' it is d/dt); k_j = dtheta_j/dtheta1
    Closure  l1 e1 + l2 e2 - l3 e3 - d e_x = 0, differentiated:
      first    l1 n1 + l2 k2 n2 - l3 k3 n3 = 0
      second  -l1 e1 + l2 (k2' n2 - k2^2 e2) - l3 (k3' n3 - k3^2 e3) = 0
      third   -l1 n1 + l2 [(k2'' - k2^3) n2 - 3 k2 k2' e2] - l3 [(k3'' - k3^3) n3 - 3 k3 k3' e3] = 0
    Projection on e3 removes n3 and yields k2, k2', k2''; on e2 it removes n2 and yields k3, k3', k3''. With
    n_a.e_b = sin(ba) and e_a.e_b = cos(ba):
      k2   = -l1 sin31 / (l2 sin32)
      k3   = l1 sin21 / (l3 sin23)
      k2'  = (l1 cos31 + l2 k2^2 cos32 - l3 k3^2) / (l2 sin32)
      k3'  = (-l1 cos21 - l2 k2^2 + l3 k3^2 cos23) / (l3 sin23)
      k2'' = k2^3 + (l1 sin31 + 3 l2 k2 k2' cos32 - 3 l3 k3 k3') / (l2 sin32)
      k3'' = k3^3 + (-l1 sin21 - 3 l2 k2 k2' + 3 l3 k3 k3' cos23) / (l3 sin23)
    Coupler centre l1 e1 + a2 e2 has the velocity theta1' (l1 n1 + a2 k2 n2), so T = 1/2 M theta1'^2 with
      M = J1 + m1 a1^2 + m2 (l1^2 + a2^2 k2^2 + 2 l1 a2 k2 cos21) + J2 k2^2 + (J3 + m3 a3^2) k3^2
      M'  = 2 (J2 + m2 a2^2) k2 k2' + 2 m2 l1 a2 [k2' cos21 - k2 (k2 - 1) sin21] + 2 (J3 + m3 a3^2) k3 k3'
      M'' = 2 (J2 + m2 a2^2)(k2'^2 + k2 k2'') + 2 (J3 + m3 a3^2)(k3'^2 + k3 k3'')
            + 2 m2 l1 a2 [k2'' cos21 - 2 k2' (k2 - 1) sin21 - k2 (k2 - 1)^2 cos21 - k2 k2' sin21]
      V   = g [(m1 a1 + m2 l1) sin1 + m2 a2 sin2 + m3 a3 sin3]
    Lagrange: M theta1'' = torque - 1/2 M' theta1'^2 - V'.

q = (crank, coupler, rocker) x (x, y, theta). Rows of C: A x, y; B x, y; C x, y (rocker.tip - coupler.tip);
D x, y. The branch of the closure is the one Newton reaches from Params.guess = (theta2, theta3).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """SI units: lengths m, masses kg, inertias kg m^2, g m/s^2, torque N m, guess rad."""

    d: float = 1.0
    l1: float = 0.3
    l2: float = 0.9
    l3: float = 0.7
    m1: float = 0.5
    m2: float = 1.4
    m3: float = 1.1
    J1: float = 0.004
    J2: float = 0.09
    J3: float = 0.05
    a1: float = 0.13
    a2: float = 0.41
    a3: float = 0.36
    g: float = 9.81
    torque: float = 0.0
    guess: tuple[float, float] = (0.7, 1.8)


def coordinates(params: Params) -> list[str]:
    return [f"{body}.{part}" for body in ("crank", "coupler", "rocker") for part in ("x", "y", "theta")]


def independent(params: Params) -> list[str]:
    return ["crank.theta"]


def closure(params: Params, theta1: Any) -> tuple[Any, Any]:
    """(theta2, theta3) by Newton; two extra iterations after convergence carry an imaginary step exactly."""
    p = params
    th2, th3 = p.guess[0] + 0 * theta1, p.guess[1] + 0 * theta1
    extra = 0
    for _ in range(60):
        rx = p.l1 * np.cos(theta1) + p.l2 * np.cos(th2) - p.l3 * np.cos(th3) - p.d
        ry = p.l1 * np.sin(theta1) + p.l2 * np.sin(th2) - p.l3 * np.sin(th3)
        # columns l2 n2 and -l3 n3, Cramer's rule with determinant l2 l3 sin(theta2 - theta3)
        det = p.l2 * p.l3 * np.sin(th2 - th3)
        step2 = p.l3 * (rx * np.cos(th3) + ry * np.sin(th3)) / det
        step3 = p.l2 * (rx * np.cos(th2) + ry * np.sin(th2)) / det
        th2, th3 = th2 + step2, th3 + step3
        extra += abs(step2) + abs(step3) < 1e-12
        if extra == 3:
            return th2, th3
    raise ValueError("four-bar closure: Newton did not converge; give a guess nearer to the wanted branch")


def coefficients(params: Params, theta1: complex) -> tuple[Array, Array, Array]:
    """((theta2, k2, k2', k2''), (theta3, k3, k3', k3''), (M, M', M'')) at theta1."""
    p = params
    th2, th3 = closure(p, theta1)
    s21, c21 = np.sin(th2 - theta1), np.cos(th2 - theta1)
    s31, c31 = np.sin(th3 - theta1), np.cos(th3 - theta1)
    s32, c32 = np.sin(th3 - th2), np.cos(th3 - th2)
    on_2, on_3 = p.l2 * s32, -p.l3 * s32
    k2, k3 = -p.l1 * s31 / on_2, p.l1 * s21 / on_3
    k2p = (p.l1 * c31 + p.l2 * k2**2 * c32 - p.l3 * k3**2) / on_2
    k3p = (-p.l1 * c21 - p.l2 * k2**2 + p.l3 * k3**2 * c32) / on_3
    u2, u3 = 3 * p.l2 * k2 * k2p, 3 * p.l3 * k3 * k3p
    k2pp = k2**3 + (p.l1 * s31 + u2 * c32 - u3) / on_2
    k3pp = k3**3 + (-p.l1 * s21 - u2 + u3 * c32) / on_3
    i2, i3, h = p.J2 + p.m2 * p.a2**2, p.J3 + p.m3 * p.a3**2, p.m2 * p.l1 * p.a2
    mass = p.J1 + p.m1 * p.a1**2 + p.m2 * p.l1**2 + i2 * k2**2 + 2 * h * k2 * c21 + i3 * k3**2
    mass_p = 2 * i2 * k2 * k2p + 2 * h * (k2p * c21 - k2 * (k2 - 1) * s21) + 2 * i3 * k3 * k3p
    bracket = k2pp * c21 - 2 * k2p * (k2 - 1) * s21 - k2 * (k2 - 1) ** 2 * c21 - k2 * k2p * s21
    mass_pp = 2 * i2 * (k2p**2 + k2 * k2pp) + 2 * i3 * (k3p**2 + k3 * k3pp) + 2 * h * bracket
    return np.array([th2, k2, k2p, k2pp]), np.array([th3, k3, k3p, k3pp]), np.array([mass, mass_p, mass_pp])


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return coefficients(params, q_i[0])[2][:1].reshape(1, 1)


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    (th2, k2, _, _), (th3, k3, _, _), (_, mass_p, _) = coefficients(p, q_i[0])
    weight = (p.m1 * p.a1 + p.m2 * p.l1) * np.cos(q_i[0])
    weight = weight + p.m2 * p.a2 * np.cos(th2) * k2 + p.m3 * p.a3 * np.cos(th3) * k3
    return np.array([p.torque - 0.5 * mass_p * q_i_dot[0] ** 2 - p.g * weight])


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    (th2, k2, k2p, _), (th3, k3, k3p, _), (_, _, mass_pp) = coefficients(p, q_i[0])
    weight = -(p.m1 * p.a1 + p.m2 * p.l1) * np.sin(q_i[0])
    weight = weight + p.m2 * p.a2 * (np.cos(th2) * k2p - np.sin(th2) * k2**2)
    weight = weight + p.m3 * p.a3 * (np.cos(th3) * k3p - np.sin(th3) * k3**2)
    return np.array([[-0.5 * mass_pp * q_i_dot[0] ** 2 - p.g * weight]])


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return np.array([[-coefficients(params, q_i[0])[2][1] * q_i_dot[0]]])


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    return np.array([[coefficients(params, q_i[0])[2][1] * a[0]]])


def q_full(params: Params, q_i: Array, t: float) -> Array:
    p, theta1 = params, q_i[0]
    th2, th3 = closure(p, theta1)
    zero = 0 * theta1
    tip = [p.l1 * np.cos(theta1), p.l1 * np.sin(theta1)]
    return np.array([zero, zero, theta1, tip[0], tip[1], th2, p.d + zero, zero, th3])


def q_d(params: Params, q_i: Array, t: float) -> Array:
    return np.delete(q_full(params, q_i, t), 2)


def C(params: Params, q: Array, t: float) -> Array:
    p = params
    crank_tip = [q[0] + p.l1 * np.cos(q[2]), q[1] + p.l1 * np.sin(q[2])]
    coupler_tip = [q[3] + p.l2 * np.cos(q[5]), q[4] + p.l2 * np.sin(q[5])]
    rocker_tip = [q[6] + p.l3 * np.cos(q[8]), q[7] + p.l3 * np.sin(q[8])]
    rows_b = [q[3] - crank_tip[0], q[4] - crank_tip[1]]
    rows_c = [rocker_tip[0] - coupler_tip[0], rocker_tip[1] - coupler_tip[1]]
    return np.array([q[0], q[1], *rows_b, *rows_c, q[6] - p.d, q[7]])


def C_q(params: Params, q: Array, t: float) -> Array:
    p = params
    s1, c1 = p.l1 * np.sin(q[2]), p.l1 * np.cos(q[2])
    s2, c2 = p.l2 * np.sin(q[5]), p.l2 * np.cos(q[5])
    s3, c3 = p.l3 * np.sin(q[8]), p.l3 * np.cos(q[8])
    return np.array(
        [
            [1, 0, 0, 0, 0, 0, 0, 0, 0],
            [0, 1, 0, 0, 0, 0, 0, 0, 0],
            [-1, 0, s1, 1, 0, 0, 0, 0, 0],
            [0, -1, -c1, 0, 1, 0, 0, 0, 0],
            [0, 0, 0, -1, 0, s2, 1, 0, -s3],
            [0, 0, 0, 0, -1, -c2, 0, 1, c3],
            [0, 0, 0, 0, 0, 0, 1, 0, 0],
            [0, 0, 0, 0, 0, 0, 0, 1, 0],
        ]
    )


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V) at full coordinates."""
    p = params
    kinetic, potential = 0.0, 0.0
    for k, mass, inertia, arm in ((0, p.m1, p.J1, p.a1), (3, p.m2, p.J2, p.a2), (6, p.m3, p.J3, p.a3)):
        vx = q_dot[k] - arm * np.sin(q[k + 2]) * q_dot[k + 2]
        vy = q_dot[k + 1] + arm * np.cos(q[k + 2]) * q_dot[k + 2]
        kinetic = kinetic + 0.5 * mass * (vx**2 + vy**2) + 0.5 * inertia * q_dot[k + 2] ** 2
        potential = potential + mass * p.g * (q[k + 1] + arm * np.sin(q[k + 2]))
    return kinetic, potential


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i."""
    return np.array([params.torque])
