"""Flyball governor: q_i = (phi, s, beta1, beta2): shaft spin, slider height, two rod angles below the horizontal.

The shaft turns about the world z-axis through the origin; its frame has the same origin and z-axis. Rod k (side
+1, -1 along the shaft's x) hangs on a revolute joint along the shaft's y at (side a, 0, height): a point at
distance r along it is at (side (a + r cos beta), 0, height - r sin beta) in the shaft frame, so rod 1's axis is
R_y(beta1) e_x and rod 2's R_y(-beta2) (-e_x). A point mass sits on each rod's far end, r = l. The slider slides
along the shaft and turns with it, its centre at (0, 0, s). A spring-damper (k, c, free length l0) joins each rod's
middle to the slider's point (side b, 0, 0).

Derivation (Lagrange). Rod with its point mass: m_e = m_r + m_p, S = m_r l/2 + m_p l, I = m_r l^2/4 + m_p l^2;
    J_t, J_a the rod's transverse and axial moments of inertia about its centre.
    A point at distance r moves with r beta' in the plane of the shaft and (a + r cos beta) phi' across it;
    the rod turns with beta' about y (J_t), phi' cos beta across its axis in the plane (J_t) and phi' sin beta along
    its axis (J_a). Hence
        2 T_rod = (I + J_t) beta'^2 + B(beta) phi'^2,
        B = m_e a^2 + 2 a S cos beta + (I + J_t) cos^2 beta + J_a sin^2 beta
        B' = dB/dbeta = -2 a S sin beta - 2 (I + J_t - J_a) sin beta cos beta
        2 T = (J_shaft + J_slider + B1 + B2) phi'^2 + m_s s'^2 + (I + J_t) (beta1'^2 + beta2'^2)
    so M_hat is diagonal, and
        phi:   Q = -phi' sum B'_k beta_k'
        s:     Q = -m_s g + sum f_k ds-part,      beta_k: Q = 1/2 B'_k phi'^2 + g S cos beta_k + spring
    Spring k: X = a + l/2 cos beta - b, Z = height - l/2 sin beta - s, length L = sqrt(X^2 + Z^2),
        dL/dbeta = (-X sin beta - Z cos beta) l / (2 L),  dL/ds = -Z / L,
        tension f = k (L - l0) + c L',  Q_beta = -f dL/dbeta, Q_s = -f dL/ds.
The potential is m_s g s - g S sum sin beta_k + 1/2 k sum (L_k - l0)^2 + constant, gravity g along -z.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.spatial.twin_spatial import Pose, rot_y, rot_z
from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """SI units. Defaults are case A05 of the IFToMM library: density 3000 kg/m^3, cuboid inertias."""

    shaft_mass: float = 0.3
    rod_mass: float = 0.3
    slider_mass: float = 3.0
    ball_mass: float = 5.0
    length: float = 1.0  # of the rods and the shaft
    width: float = 0.01  # square section of the rods and the shaft
    cube: float = 0.1  # edge of the slider
    a: float = 0.05  # rod pivots from the axis
    b: float = 0.05  # slider's spring points from the axis
    height: float = 1.0  # of the rod pivots
    k: float = 8e5
    c: float = 4e4
    l0: float = 0.5
    g: float = 9.81


def coordinates(params: Params) -> list[str]:
    return ["shaft.spin", "slider.travel", "rod1.angle", "rod2.angle"]


def start(params: Params) -> tuple[Array, Array]:
    """Initial (q_i, q_i_dot) of A05: s = 0.5, both rods 30 degrees below the horizontal, spin 2 pi rad/s."""
    return np.array([0.0, 0.5, np.pi / 6, np.pi / 6]), np.array([2 * np.pi, 0.0, 0.0, 0.0])


def moments(p: Params) -> dict[str, float]:
    """m_e, S, I, J_t, J_a of the derivation and J_axis = J_shaft + J_slider."""
    m_e = p.rod_mass + p.ball_mass
    S = p.rod_mass * p.length / 2 + p.ball_mass * p.length
    inertia = p.rod_mass * p.length**2 / 4 + p.ball_mass * p.length**2
    J_t, J_a = p.rod_mass * (p.length**2 + p.width**2) / 12, p.rod_mass * p.width**2 / 6
    J_axis = p.shaft_mass * p.width**2 / 6 + p.slider_mass * p.cube**2 / 6
    return dict(m_e=m_e, S=S, I=inertia, J_t=J_t, J_a=J_a, J_axis=J_axis)


def _B(p: Params, beta: Array) -> tuple[Array, Array]:
    """(B, B') per rod."""
    i, sine, cosine = moments(p), np.sin(beta), np.cos(beta)
    across = i["I"] + i["J_t"]
    B = i["m_e"] * p.a**2 + 2 * p.a * i["S"] * cosine + across * cosine**2 + i["J_a"] * sine**2
    return B, -2 * p.a * i["S"] * sine - 2 * (across - i["J_a"]) * sine * cosine


def springs(params: Params, q_i: Array) -> tuple[Array, Array, Array]:
    """(L, dL/dbeta, dL/ds) of the two springs, each (2,)."""
    p, s, beta = params, q_i[1], q_i[2:]
    X = p.a + p.length / 2 * np.cos(beta) - p.b
    Z = p.height - p.length / 2 * np.sin(beta) - s
    L = np.sqrt(X**2 + Z**2)
    return L, -(X * np.sin(beta) + Z * np.cos(beta)) * p.length / (2 * L), -Z / L


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    i = moments(params)
    spin = i["J_axis"] + np.sum(_B(params, q_i[2:])[0])
    rod = i["I"] + i["J_t"]
    return np.diag(np.array([spin, params.slider_mass, rod, rod]))


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Generalised force of the two dampers."""
    _, L_beta, L_s = springs(params, q_i)
    force = params.c * (L_beta * q_i_dot[2:] + L_s * q_i_dot[1])
    return np.array([0.0, -force @ L_s, *(-force * L_beta)])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, beta = params, q_i[2:]
    slope = _B(p, beta)[1]
    L, L_beta, L_s = springs(p, q_i)
    tension = p.k * (L - p.l0)
    on_phi = -q_i_dot[0] * (slope @ q_i_dot[2:])
    on_s = -p.slider_mass * p.g - tension @ L_s
    on_beta = 0.5 * slope * q_i_dot[0] ** 2 + p.g * moments(p)["S"] * np.cos(beta) - tension * L_beta
    return np.array([on_phi, on_s, *on_beta]) + Q_applied(p, q_i, q_i_dot, t)


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    """Shaft, slider, rod 1, rod 2, ball 1, ball 2 (the balls without inertia about their centres)."""
    p, turn = params, rot_z(q_i[0])
    bar = p.length**2 + p.width**2
    upright = p.shaft_mass / 12 * np.diag([bar, bar, 2 * p.width**2])
    lying = p.rod_mass / 12 * np.diag([2 * p.width**2, bar, bar])
    cube = p.slider_mass * p.cube**2 / 6 * np.eye(3)
    result = [
        Pose(p.shaft_mass, upright, np.array([0, 0, p.length / 2]), turn),
        Pose(p.slider_mass, cube, np.array([0 * q_i[1], 0 * q_i[1], q_i[1]]), turn),
    ]
    for mass, inertia, r in ((p.rod_mass, lying, p.length / 2), (p.ball_mass, np.zeros((3, 3)), p.length)):
        for side, beta in ((1, q_i[2]), (-1, q_i[3])):
            point = np.array([side * (p.a + r * np.cos(beta)), 0, p.height - r * np.sin(beta)])
            result.append(Pose(mass, inertia, turn @ point, turn @ rot_y(side * beta)))
    return result


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    p = params
    stretch = springs(p, q_i)[0] - p.l0
    potential = p.g * (p.slider_mass * q_i[1] - moments(p)["S"] * np.sum(np.sin(q_i[2:])))
    return 0.5 * q_i_dot @ M_hat(p, q_i, t) @ q_i_dot, potential + 0.5 * p.k * stretch @ stretch
