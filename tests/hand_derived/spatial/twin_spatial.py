"""Shared by the spatial twins: rotations, Euler-angle rates, Euler parameters, Jourdain's principle.

Conventions: world axes x, y, z; A maps body components to world; omega in body axes unless said otherwise.
Sequence "zyx": A = R_z(theta1) R_y(theta2) R_x(theta3); "zxz": A = R_z(theta1) R_x(theta2) R_z(theta3).

Angular velocity in body axes, omega = G(theta) theta', read off from the three successive turns:
    zyx: theta1' R_x^T R_y^T e_z + theta2' R_x^T e_y + theta3' e_x,
         R_x^T e_y = (0, c3, -s3),  R_x^T R_y^T e_z = (-s2, c2 s3, c2 c3)
    zxz: theta1' R_z^T R_x^T e_z + theta2' R_z^T e_x + theta3' e_z,
         R_z^T e_x = (c3, -s3, 0),  R_z^T R_x^T e_z = (s2 s3, s2 c3, c2)
G' is the time derivative of these entries, typed below.

Jourdain: with velocities v = J_v q' and omega = J_w q' (world) of a body's centre of mass, and accelerations
    a = J_v q'' + a_0, alpha = J_w q'' + alpha_0, the virtual power of inertia and of the applied force and moment
    gives M = sum m J_v^T J_v + J_w^T J J_w,
          Q = sum J_v^T (F - m a_0) + J_w^T (N - J alpha_0 - omega x J omega).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.hand_derived.twin_common import Array

E_X, E_Y, E_Z = np.eye(3)


def tilde(v: Array) -> Array:
    """Cross-product matrix: tilde(v) w = v x w."""
    zero = 0 * v[0]
    return np.array([[zero, -v[2], v[1]], [v[2], zero, -v[0]], [-v[1], v[0], zero]])


def rot_x(angle: Any) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def rot_y(angle: Any) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rot_z(angle: Any) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def euler_A(sequence: str, theta: Array) -> Array:
    """Rotation matrix of the Euler angles `theta` (3,), sequence "zyx" or "zxz"."""
    middle, last = {"zyx": (rot_y, rot_x), "zxz": (rot_x, rot_z)}[sequence]
    return rot_z(theta[0]) @ middle(theta[1]) @ last(theta[2])


def euler_G(sequence: str, theta: Array) -> Array:
    """omega (body axes) = G theta'."""
    s2, c2, s3, c3 = np.sin(theta[1]), np.cos(theta[1]), np.sin(theta[2]), np.cos(theta[2])
    if sequence == "zyx":
        return np.array([[-s2, 0, 1], [c2 * s3, c3, 0], [c2 * c3, -s3, 0]])
    return np.array([[s2 * s3, c3, 0], [s2 * c3, -s3, 0], [c2, 0, 1]])


def euler_G_dot(sequence: str, theta: Array, theta_dot: Array) -> Array:
    """Time derivative of G."""
    s2, c2, s3, c3 = np.sin(theta[1]), np.cos(theta[1]), np.sin(theta[2]), np.cos(theta[2])
    d2, d3 = theta_dot[1], theta_dot[2]
    if sequence == "zyx":
        return np.array(
            [
                [-c2 * d2, 0, 0],
                [-s2 * s3 * d2 + c2 * c3 * d3, -s3 * d3, 0],
                [-s2 * c3 * d2 - c2 * s3 * d3, -c3 * d3, 0],
            ]
        )
    return np.array(
        [
            [c2 * s3 * d2 + s2 * c3 * d3, -s3 * d3, 0],
            [c2 * c3 * d2 - s2 * s3 * d3, -c3 * d3, 0],
            [-s2 * d2, 0, 0],
        ]
    )


def parameters_A(e: Array) -> Array:
    """Rotation matrix of the unit Euler parameters e = (e0, e1, e2, e3), scalar first."""
    v = e[1:]
    return (2 * e[0] ** 2 - 1) * np.eye(3) + 2 * (np.outer(v, v) + e[0] * tilde(v))


def parameters_dot(e: Array, omega: Array) -> Array:
    """e' for the body angular velocity: e' = 1/2 e o (0, omega)."""
    return 0.5 * np.concatenate([[-e[1:] @ omega], e[0] * omega + np.cross(e[1:], omega)])


def parameters_ddot(e: Array, omega: Array, omega_dot: Array) -> Array:
    """e'' = 1/2 e o (0, omega') - 1/4 |omega|^2 e."""
    return parameters_dot(e, omega_dot) - 0.25 * (omega @ omega) * e


@dataclass(frozen=True, eq=False)
class Pose:
    """A body in place: mass kg, inertia (3, 3) about the centre of mass in body axes, R_c (3,) world, A (3, 3)."""

    mass: float
    inertia: Array
    R_c: Array
    A: Array


@dataclass(frozen=True, eq=False)
class Part:
    """One body in Jourdain's principle, all in world axes; inertia, moment about the centre of mass."""

    mass: float
    inertia: Array
    J_v: Array
    J_w: Array
    omega: Array
    a_0: Array
    alpha_0: Array
    force: Array
    moment: Array


def jourdain(parts: list[Part]) -> tuple[Array, Array]:
    """(M, Q) of the sum over the bodies."""
    M = sum(b.mass * b.J_v.T @ b.J_v + b.J_w.T @ b.inertia @ b.J_w for b in parts)
    Q = sum(
        b.J_v.T @ (b.force - b.mass * b.a_0)
        + b.J_w.T @ (b.moment - b.inertia @ b.alpha_0 - np.cross(b.omega, b.inertia @ b.omega))
        for b in parts
    )
    return np.asarray(M), np.asarray(Q)
