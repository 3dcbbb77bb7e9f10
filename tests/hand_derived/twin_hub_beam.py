"""Rigid hub pinned to the ground with a beam clamped at its centre: q_i = (hub.theta, beam.q1 .. beam.q<nf>).

Hub: mass m_hub, inertia J_hub about its centre, which is its origin and does not move (m_hub drops out).
Beam: lumped masses m_k at x_k with lateral nodal shapes phi_k (zero with zero slope at the clamp), K_ff,
D_ff, and optional foreshortening H_k per node. Torque torque(t) on the hub; gravity (gx, gy). Joints:
revolute `pivot` ground.origin - hub.origin, weld `clamp` hub.origin - beam.start; body order hub, beam.

Derivation (Lagrange)
    Node k sits at A(theta) (x_k - s_k, w_k), w_k = phi_k.q, s_k = 1/2 q.H_k q (s = 0 without stiffening).
    Its velocity in the frame is (-s' - theta' w, w' + theta' (x - s)), so
        2 T = J_hub theta'^2
              + sum m [theta'^2 ((x - s)^2 + w^2) + 2 theta' ((x - s) w' + w s') + w'^2 + s'^2].
    T is kept to second order in (q, q') taken together: of the theta'^2 terms x^2 - 2 x s + w^2, of the
    theta' terms x w', of the rest w'^2. (Without stiffening nothing is dropped.) With
        J = J_hub + sum m x^2,  b = sum m x phi,  M_ff = sum m phi phi,  G = sum m x H,  N = M_ff - G:
        T = 1/2 theta'^2 (J + q.N q) + theta' b.q' + 1/2 q'.M_ff q'
    Lagrange:  theta:  (J + q.N q) theta'' + b.q'' + 2 theta' q.N q' = torque + F_theta
               q_f:    b theta'' + M_ff q'' - theta'^2 N q = -K q - D q' + F_f
    so M_hat = [[J + q.N q, b], [b, M_ff]], and the beam sees K - theta'^2 (M_ff - G), the geometric
    stiffness of a spinning beam.
    Gravity: V = -sum m g.A (x - s, w). With e = (cos, sin), n = (-sin, cos), H = sum m H_k, p = sum m phi,
    S_1 = sum m x - 1/2 q.H q, S_2 = p.q:
        F_theta = S_1 g.n - S_2 g.e,   F_f = -(g.e) H q + (g.n) p.

q = (hub.x, hub.y, hub.theta, beam.x, beam.y, beam.theta, beam.q1 ..). Rows of C: hub.x, hub.y;
beam.x - hub.x, beam.y - hub.y, beam.theta - hub.theta.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tests.hand_derived.twin_common import Array


def _no_torque(t: float) -> float:
    return 0.0


@dataclass(frozen=True, eq=False)
class Params:
    """masses (n+1,) kg, positions (n+1,) m, shapes (n+1, nf), K_ff and D_ff (nf, nf), J_hub kg m^2.

    m_hub kg; foreshortening (n+1, nf, nf), H_k in 1/m for dimensionless shapes, None for no stiffening;
    torque(t) N m; gravity m/s^2.
    """

    masses: Array
    positions: Array
    shapes: Array
    K_ff: Array
    D_ff: Array
    foreshortening: Array | None = None
    J_hub: float = 10.0
    m_hub: float = 5.0
    torque: Callable[[float], float] = _no_torque
    gravity: Array = field(default_factory=lambda: np.zeros(2))


def _integrals(p: Params) -> dict[str, Any]:
    """J, b, M_ff, N, H, moment, p of the derivation."""
    nf = p.shapes.shape[1]
    H = np.zeros((nf, nf)) if p.foreshortening is None else np.einsum("k,kab->ab", p.masses, p.foreshortening)
    x_m = p.masses * p.positions
    G = np.zeros((nf, nf)) if p.foreshortening is None else np.einsum("k,kab->ab", x_m, p.foreshortening)
    M_ff = p.shapes.T @ (p.masses[:, None] * p.shapes)
    J = p.J_hub + x_m @ p.positions
    return dict(J=J, b=x_m @ p.shapes, M_ff=M_ff, N=M_ff - G, H=H, moment=x_m.sum(), p=p.masses @ p.shapes)


def _gravity(p: Params, theta: complex) -> tuple[complex, complex]:
    """(g.e, g.n)."""
    s, c = np.sin(theta), np.cos(theta)
    return p.gravity[0] * c + p.gravity[1] * s, -p.gravity[0] * s + p.gravity[1] * c


def coordinates(params: Params) -> list[str]:
    head = [f"{body}.{part}" for body in ("hub", "beam") for part in ("x", "y", "theta")]
    return [*head, *(f"beam.q{k + 1}" for k in range(params.shapes.shape[1]))]


def independent(params: Params) -> list[str]:
    return ["hub.theta", *coordinates(params)[6:]]


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    i, q = _integrals(params), q_i[1:]
    top = np.concatenate([[i["J"] + q @ i["N"] @ q], i["b"]])
    return np.vstack([top, np.hstack([i["b"][:, None], i["M_ff"]])])


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i: torque on the hub, modal damping."""
    return np.concatenate([[params.torque(t)], -params.D_ff @ q_i_dot[1:]])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, i, q = params, _integrals(params), q_i[1:]
    w, q_dot = q_i_dot[0], q_i_dot[1:]
    g_e, g_n = _gravity(p, q_i[0])
    s_1, s_2 = i["moment"] - 0.5 * q @ i["H"] @ q, i["p"] @ q
    on_theta = -2 * w * q @ i["N"] @ q_dot + s_1 * g_n - s_2 * g_e
    on_modes = w**2 * i["N"] @ q - p.K_ff @ q - g_e * i["H"] @ q + g_n * i["p"]
    return np.concatenate([[on_theta], on_modes]) + Q_applied(p, q_i, q_i_dot, t)


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, i, q = params, _integrals(params), q_i[1:]
    w, q_dot = q_i_dot[0], q_i_dot[1:]
    g_e, g_n = _gravity(p, q_i[0])
    # d(g.e)/dtheta = g.n, d(g.n)/dtheta = -g.e
    s_1, s_2 = i["moment"] - 0.5 * q @ i["H"] @ q, i["p"] @ q
    h_q = i["H"] @ q
    theta_row = np.concatenate([[-s_1 * g_e - s_2 * g_n], -2 * w * i["N"] @ q_dot - h_q * g_n - i["p"] * g_e])
    theta_column = -g_n * h_q - g_e * i["p"]
    modes = w**2 * i["N"] - p.K_ff - g_e * i["H"]
    return np.vstack([theta_row, np.hstack([theta_column[:, None], modes])])


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, i, q = params, _integrals(params), q_i[1:]
    w, q_dot = q_i_dot[0], q_i_dot[1:]
    n_q = i["N"] @ q
    theta_row = np.concatenate([[-2 * n_q @ q_dot], -2 * w * n_q])
    return np.vstack([theta_row, np.hstack([(2 * w * n_q)[:, None], -p.D_ff])])


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    i, q = _integrals(params), q_i[1:]
    out = np.zeros((q_i.size, q_i.size), dtype=np.result_type(q_i, a))
    out[0, 1:] = 2 * a[0] * i["N"] @ q
    return out


def q_full(params: Params, q_i: Array, t: float) -> Array:
    zero = 0 * q_i[0]
    return np.concatenate([[zero, zero, q_i[0], zero, zero, q_i[0]], q_i[1:]])


def q_d(params: Params, q_i: Array, t: float) -> Array:
    return q_full(params, q_i, t)[[0, 1, 3, 4, 5]]


def C(params: Params, q: Array, t: float) -> Array:
    return np.array([q[0], q[1], q[3] - q[0], q[4] - q[1], q[5] - q[2]])


def C_q(params: Params, q: Array, t: float) -> Array:
    pivot = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0]]
    clamp = [[-1, 0, 0, 1, 0, 0], [0, -1, 0, 0, 1, 0], [0, 0, -1, 0, 0, 1]]
    return np.hstack([np.array(pivot + clamp), np.zeros((5, params.shapes.shape[1]))])


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V), node by node; with foreshortening T is truncated as the docstring says."""
    p, w = params, q_dot[5]
    q_f, q_f_dot = q[6:], q_dot[6:]
    H = np.zeros((p.masses.size, q_f.size, q_f.size)) if p.foreshortening is None else p.foreshortening
    lag, lag_dot = p.shapes @ q_f, p.shapes @ q_f_dot
    short, short_dot = 0.5 * (H @ q_f) @ q_f, (H @ q_f) @ q_f_dot
    s, c = np.sin(q[5]), np.cos(q[5])
    frame_v = [c * q_dot[3] + s * q_dot[4], -s * q_dot[3] + c * q_dot[4]]
    x, m = p.positions, p.masses
    transport = frame_v[0] * (-short_dot - w * lag) + frame_v[1] * (lag_dot + w * (x - short))
    quadratic = w**2 * (x**2 - 2 * x * short + lag**2) + 2 * w * x * lag_dot + lag_dot**2
    speed = frame_v[0] ** 2 + frame_v[1] ** 2 + 2 * transport + quadratic
    hub = 0.5 * p.m_hub * (q_dot[0] ** 2 + q_dot[1] ** 2) + 0.5 * p.J_hub * q_dot[2] ** 2
    kinetic = hub + 0.5 * m @ speed
    px, py = q[3] + c * (x - short) - s * lag, q[4] + s * (x - short) + c * lag
    weight = p.gravity[0] * (m @ px + p.m_hub * q[0]) + p.gravity[1] * (m @ py + p.m_hub * q[1])
    return kinetic, 0.5 * q_f @ p.K_ff @ q_f - weight
