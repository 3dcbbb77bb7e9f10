"""Numerical checks of the spatial twins: all from poses or nodes by complex step, nothing from M_hat or Q_hat."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np

from tests.hand_derived.twin_common import STEP, Array, complex_step


def particles(twin: ModuleType, params: Any, q_i: Array, t: float) -> list[tuple[float, Array]]:
    """(mass, world position) of the lumped nodes, none for a rigid twin."""
    return twin.nodes(params, q_i, t) if hasattr(twin, "nodes") else []


def body_jacobian(twin: ModuleType, params: Any, q_i: Array, t: float, k: int) -> tuple[Array, Array]:
    """(J_v, J_w) of body k, world: J_w from A' A^T, one column a coordinate."""
    J_v = complex_step(lambda x: twin.poses(params, x, t)[k].R_c, q_i)
    A_q = complex_step(lambda x: twin.poses(params, x, t)[k].A.ravel(), q_i).reshape(3, 3, -1)
    spin = np.einsum("ijn,kj->ikn", A_q, np.real(twin.poses(params, q_i, t)[k].A))
    return J_v, np.array([spin[2, 1], spin[0, 2], spin[1, 0]])


def mass_matrix(twin: ModuleType, params: Any, q_i: Array, t: float) -> Array:
    """M_hat from the kinetic energy of the poses and the nodes."""
    M = np.zeros((q_i.size, q_i.size))
    for k, body in enumerate(twin.poses(params, q_i, t)):
        J_v, J_w = body_jacobian(twin, params, q_i, t, k)
        A = np.real(body.A)
        M += body.mass * J_v.T @ J_v + J_w.T @ (A @ body.inertia @ A.T) @ J_w
    for k, (mass, _) in enumerate(particles(twin, params, q_i, t)):
        J_v = complex_step(lambda x, k=k: particles(twin, params, x, t)[k][1], q_i)
        M += mass * J_v.T @ J_v
    return M


def weight_potential(twin: ModuleType, params: Any, gravity: Array, q_i: Array, t: float) -> complex:
    """Potential of gravity alone."""
    heights = [b.mass * gravity @ b.R_c for b in twin.poses(params, q_i, t)]
    heights += [mass * gravity @ point for mass, point in particles(twin, params, q_i, t)]
    return -sum(heights)


def lagrange_force(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Q_hat by Lagrange: Q_applied - dV/dq + 1/2 d(q'^T M q')/dq - M' q', M differenced at fourth order."""
    h = 1e-3
    slopes = []
    for e in np.eye(q_i.size):
        near = mass_matrix(twin, params, q_i + h * e, t) - mass_matrix(twin, params, q_i - h * e, t)
        far = mass_matrix(twin, params, q_i + 2 * h * e, t) - mass_matrix(twin, params, q_i - 2 * h * e, t)
        farther = mass_matrix(twin, params, q_i + 3 * h * e, t) - mass_matrix(twin, params, q_i - 3 * h * e, t)
        slopes.append((45 * near - 9 * far + farther) / (60 * h))
    dM = np.array(slopes)  # dM[k] = dM/dq_k
    quadratic = 0.5 * np.einsum("kij,i,j->k", dM, q_i_dot, q_i_dot) - np.einsum("kij,k,j->i", dM, q_i_dot, q_i_dot)
    dV = complex_step(lambda x: np.array([twin.energy(params, x, 0 * q_i_dot, t)[1]]), q_i)[0]
    return twin.Q_applied(params, q_i, q_i_dot, t) - dV + quadratic


def along_motion(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, t: float) -> tuple[Array, Array]:
    """(q, q') one imaginary step ahead along the motion of M_hat, Q_hat."""
    acceleration = np.linalg.solve(twin.M_hat(params, q_i, t), twin.Q_hat(params, q_i, q_i_dot, t))
    return q_i + 1j * STEP * q_i_dot, q_i_dot + 1j * STEP * acceleration
