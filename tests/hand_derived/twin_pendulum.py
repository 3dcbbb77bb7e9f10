"""Pendulum: body `rod`, mass m, inertia Jc about its centre of mass (a, 0) in the body frame.

Joint: revolute `hinge` ground.origin - rod.origin.

Derivation (Lagrange, minimal coordinate theta = rod.theta)
    The origin is fixed, so the centre of mass is at a (cos theta, sin theta) and moves with speed a theta'.
    T = 1/2 (Jc + m a^2) theta'^2,   V = m g a sin theta   (gravity (0, -g)),   hinge damper torque -c theta'.
    d/dt dT/dtheta' - dT/dtheta + dV/dtheta = -c theta' gives
        (Jc + m a^2) theta'' = -m g a cos theta - c theta'.
    Jacobians: dQ/dtheta = m g a sin theta, dQ/dtheta' = -c, d(M a)/dtheta = 0.

q = (rod.x, rod.y, rod.theta); q_i = (rod.theta); q_d = (0, 0).
Rows of C: hinge x, hinge y: C = (rod.x, rod.y).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """SI units: m kg, Jc kg m^2, a m, g m/s^2, c N m s/rad."""

    m: float = 1.3
    Jc: float = 0.21
    a: float = 0.7
    g: float = 9.81
    c: float = 0.0


def coordinates(params: Params) -> list[str]:
    return ["rod.x", "rod.y", "rod.theta"]


def independent(params: Params) -> list[str]:
    return ["rod.theta"]


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return np.array([[params.Jc + params.m * params.a**2]])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    return np.array([-p.m * p.g * p.a * np.cos(q_i[0]) - p.c * q_i_dot[0]])


def dQ_hat_dq_i(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return np.array([[params.m * params.g * params.a * np.sin(q_i[0])]])


def dQ_hat_dq_i_dot(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return np.array([[-params.c]])


def dMa_dq_i(params: Params, q_i: Array, a: Array, t: float) -> Array:
    return np.zeros((1, 1))


def q_full(params: Params, q_i: Array, t: float) -> Array:
    zero = 0 * q_i[0]
    return np.array([zero, zero, q_i[0]])


def q_d(params: Params, q_i: Array, t: float) -> Array:
    return q_full(params, q_i, t)[:2]


def C(params: Params, q: Array, t: float) -> Array:
    return np.array([q[0], q[1]])


def C_q(params: Params, q: Array, t: float) -> Array:
    return np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V) at full coordinates."""
    p = params
    vx = q_dot[0] - p.a * np.sin(q[2]) * q_dot[2]
    vy = q_dot[1] + p.a * np.cos(q[2]) * q_dot[2]
    kinetic = 0.5 * p.m * (vx**2 + vy**2) + 0.5 * p.Jc * q_dot[2] ** 2
    return kinetic, p.m * p.g * (q[1] + p.a * np.sin(q[2]))


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Non-conservative generalised force on q_i."""
    return np.array([-params.c * q_i_dot[0]])
