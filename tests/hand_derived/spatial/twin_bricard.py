"""Bricard mechanism (case A04 of the IFToMM library): five bars on the ground, six hinges, one redundant constraint.

Bars P0P1, P1P2, P2P3, P3P4, P4P5 of length 1, mass 1 and square section 0.1 (cuboid inertia); the base P5P0 is the
ground. At the start P0..P5 = (0,0,0) (1,0,0) (1,-1,0) (1,-1,1) (0,-1,1) (0,0,1), hinge axes y, z, x, y, z, x at
P0..P5, at rest, gravity 9.81 along -y. Body frames are parallel to the world at the start (A_k = 1) and have their
origin in P_k, so that a bar's far end is at its starting direction d_k in its own frame.

Derivation. Chain in the five hinge angles q of P0..P4 (zero at the start), closed at P5:
    A_k = A_{k-1} R(axis_k, q_k),  P_{k+1} = P_k + A_k d_k,  a_k = A_{k-1} axis_k (world)
    omega_k = omega_{k-1} + a_k q_k';   bias of alpha_k: that of k-1, plus omega_{k-1} x a_k q_k'
    J_w,k has the columns a_j, J_P of a point R the columns a_j x (R - P_j), j <= k
    bias of a point at arm r: that of P_k, plus bias_alpha x r + omega x (omega x r)
    Closure (5 rows, rank 4): P_5 = (0,0,1); the last bar keeps the hinge axis: e_y . A_5 e_x = e_z . A_5 e_x = 0.
    Row rates: J_P, and e . (J_w x a) with a = A_5 e_x.
    One degree of freedom: N spans the null space of C_q (last right singular vector); with the minimum-norm
    particular solution p of C_q p = gamma,  q'' = p + N (N^T (Q - M p)) / (N^T M N).
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.spatial.twin_spatial import E_X, E_Y, E_Z, Part, Pose, jourdain, rot_x, rot_y, rot_z
from tests.hand_derived.twin_common import Array

TURNS = (rot_y, rot_z, rot_x, rot_y, rot_z)
AXES = (E_Y, E_Z, E_X, E_Y, E_Z)
DIRECTIONS = (E_X, -E_Y, E_Z, -E_X, E_Y)
BASE = E_Z  # P5 on the ground
GRAVITY = -9.81 * E_Y
MASS, LENGTH, SECTION = 1.0, 1.0, 0.1


def bar_inertia(direction: Array) -> Array:
    """(3, 3) of a cuboid about its centre, long side along `direction`."""
    along, across = MASS * SECTION**2 / 6, MASS * (LENGTH**2 + SECTION**2) / 12
    return across * np.eye(3) + (along - across) * np.outer(direction, direction)


def frames(q: Array) -> tuple[list[Array], list[Array], list[Array]]:
    """(A_k of the five bars, points P0..P5, world axes of the hinges at P0..P4)."""
    A, points, axes, rotations = np.eye(3), [np.zeros(3)], [], []
    for turn, axis, direction, angle in zip(TURNS, AXES, DIRECTIONS, q, strict=True):
        axes.append(A @ axis)
        A = A @ turn(angle)
        rotations.append(A)
        points.append(points[-1] + A @ direction)
    return rotations, points, axes


def poses(q: Array) -> list[Pose]:
    rotations, points, _ = frames(q)
    centres = [(points[k] + points[k + 1]) / 2 for k in range(5)]
    return [Pose(MASS, bar_inertia(DIRECTIONS[k]), centres[k], rotations[k]) for k in range(5)]


def closure(q: Array) -> Array:
    """C (5,)."""
    rotations, points, _ = frames(q)
    axis = rotations[4] @ E_X
    return np.concatenate([points[5] - BASE, axis[1:]])


def _chain(q: Array, q_dot: Array) -> tuple[list[Part], Array, Array]:
    """(bars, C_q (5, 5), bias (5,) of C'')."""
    rotations, points, axes = frames(q)
    omega = alpha = bias = np.zeros(3)
    parts = []
    for k in range(5):
        alpha = alpha + np.cross(omega, axes[k]) * q_dot[k]
        omega = omega + axes[k] * q_dot[k]
        arm = points[k + 1] - points[k]
        swing = np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        centre = points[k] + arm / 2
        zeros = [np.zeros(3)] * (4 - k)
        J_v = np.stack([np.cross(axes[j], centre - points[j]) for j in range(k + 1)] + zeros, axis=1)
        J_w = np.stack(axes[: k + 1] + zeros, axis=1)
        inertia = rotations[k] @ bar_inertia(DIRECTIONS[k]) @ rotations[k].T
        parts.append(Part(MASS, inertia, J_v, J_w, omega, bias + swing / 2, alpha, MASS * GRAVITY, np.zeros(3)))
        bias = bias + swing
    J_end = np.stack([np.cross(axes[j], points[5] - points[j]) for j in range(5)], axis=1)
    axis = rotations[4] @ E_X
    J_axis = np.stack([np.cross(axes[j], axis) for j in range(5)], axis=1)
    turn = np.cross(alpha, axis) + np.cross(omega, np.cross(omega, axis))
    return parts, np.vstack([J_end, J_axis[1:]]), np.concatenate([bias, turn[1:]])


def closure_jacobian(q: Array) -> Array:
    """C_q (5, 5), of rank 4 on the mechanism's path."""
    return _chain(q, np.zeros(5))[1]


def tangent(q: Array) -> Array:
    """Unit vector of the one motion the closure leaves."""
    return np.linalg.svd(closure_jacobian(q))[2][-1]


def acceleration(q: Array, q_dot: Array) -> Array:
    """q'' (5,)."""
    parts, C_q, bias = _chain(q, q_dot)
    M, Q = jourdain(parts)
    left, values, right = np.linalg.svd(C_q)
    particular = right[:4].T @ ((left[:, :4].T @ -bias) / values[:4])
    N = right[4]
    return particular + N * (N @ (Q - M @ particular)) / (N @ M @ N)


def project(q: Array) -> Array:
    """The nearest closed position by Gauss-Newton steps of minimum norm."""
    for _ in range(4):
        left, values, right = np.linalg.svd(closure_jacobian(q))
        q = q - right[:4].T @ ((left[:, :4].T @ closure(q)) / values[:4])
    return q


def condensed(q: Array, q_dot: Array, k: int) -> tuple[float, float]:
    """(M_hat, Q_hat) for the hinge angle q_k as the independent coordinate; q, q_dot closed."""
    parts, C_q, bias = _chain(q, q_dot)
    M, Q = jourdain(parts)
    S = np.linalg.svd(C_q)[2][-1]
    S = S / S[k]
    rest = [j for j in range(5) if j != k]
    s = np.zeros(5)
    s[rest] = np.linalg.lstsq(C_q[:, rest], -bias, rcond=1e-9)[0]
    return S @ M @ S, S @ (Q - M @ s)


def energy(q: Array, q_dot: Array) -> tuple[float, float]:
    """(T, V)."""
    M = jourdain(_chain(q, np.zeros(5))[0])[0]
    return 0.5 * q_dot @ M @ q_dot, -sum(b.mass * GRAVITY @ b.R_c for b in poses(q))
