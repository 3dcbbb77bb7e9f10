"""Free flexible body of lumped nodes: q_i = (R_o, theta, q_f), Euler angles zyx or zxz, arbitrary nodes and shapes.

Derivation (Jourdain for particles; omega = G theta' in body axes, u = x + Phi q_f):
    place         R_o + A u
    velocity      R_o' + A (omega x u + Phi q_f')                J = [1, -A u~ G, A Phi]
    acceleration  J q'' + A (omega x (omega x u) + 2 omega x Phi q_f' - u x G' theta')
    M_hat = sum m J^T J,  Q_hat = sum m J^T (g - bias) - [0, 0, K q_f + D q_f'] + J_p^T f
    with a constant world force f at node `loaded`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_flexible_nodes import Nodes, particle_sums, scattered
from tests.hand_derived.spatial.twin_spatial import Pose, euler_A, euler_G, euler_G_dot, tilde
from tests.hand_derived.twin_common import Array


@dataclass(frozen=True, eq=False)
class Params:
    """body; gravity (3,) m/s^2; force (3,) N, world, at node number `loaded`; sequence "zyx" or "zxz"."""

    body: Nodes = field(default_factory=scattered)
    gravity: Array = field(default_factory=lambda: np.array([0.4, -1.1, -9.81]))
    force: Array = field(default_factory=lambda: np.array([2.0, -1.0, 3.0]))
    loaded: int = 3
    sequence: str = "zyx"


def coordinates(params: Params) -> list[str]:
    head = ["x", "y", "z", "theta1", "theta2", "theta3"]
    return [*head, *(f"q{k + 1}" for k in range(params.body.shapes.shape[2]))]


def _jacobians(p: Params, q_i: Array) -> Array:
    """J (N, 3, 6 + nf)."""
    A, G = euler_A(p.sequence, q_i[3:6]), euler_G(p.sequence, q_i[3:6])
    unit = np.eye(3)
    return np.array(
        [
            np.hstack([unit, -A @ tilde(u) @ G, A @ shape])
            for u, shape in zip(p.body.places(q_i[6:]), p.body.shapes, strict=True)
        ]
    )


def _bias(p: Params, q_i: Array, q_i_dot: Array) -> Array:
    """Accelerations (N, 3), world, at q'' = 0."""
    theta, theta_dot = q_i[3:6], q_i_dot[3:6]
    omega = euler_G(p.sequence, theta) @ theta_dot
    turn = euler_G_dot(p.sequence, theta, theta_dot) @ theta_dot
    u, drift = p.body.places(q_i[6:]), p.body.drift(q_i_dot[6:])
    local = np.cross(omega, np.cross(omega, u)) + 2 * np.cross(omega, drift) + np.cross(turn, u)
    return local @ euler_A(p.sequence, theta).T


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    none = np.zeros((params.body.masses.size, 3))
    return particle_sums(params.body.masses, _jacobians(params, q_i), none, params.gravity)[0]


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Force at the loaded node, modal damping."""
    modal = np.concatenate([np.zeros(6), params.body.D_ff @ q_i_dot[6:]])
    return _jacobians(params, q_i)[params.loaded].T @ params.force - modal


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p = params
    Q = particle_sums(p.body.masses, _jacobians(p, q_i), _bias(p, q_i, q_i_dot), p.gravity)[1]
    return Q - np.concatenate([np.zeros(6), p.body.K_ff @ q_i[6:]]) + Q_applied(p, q_i, q_i_dot, t)


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    return []


def nodes(params: Params, q_i: Array, t: float) -> list[tuple[float, Array]]:
    """(mass, world position) of the nodes."""
    places = q_i[:3] + params.body.places(q_i[6:]) @ euler_A(params.sequence, q_i[3:6]).T
    return list(zip(params.body.masses, places, strict=True))


def accelerations(params: Params, A: Array, omega: Array, q_f: Array, q_f_dot: Array) -> tuple[Array, Array, Array]:
    """(R_o'', omega' in body axes, q_f'') for any parametrisation of the orientation; omega in body axes.

    The same sums in the velocities (A^T R_o', omega, q_f'), J = [1, -u~, Phi], everything in body axes.
    """
    p, u = params, params.body.places(q_f)
    J = np.array([np.hstack([np.eye(3), -tilde(a), shape]) for a, shape in zip(u, p.body.shapes, strict=True)])
    bias = np.cross(omega, np.cross(omega, u)) + 2 * np.cross(omega, p.body.drift(q_f_dot))
    M, Q = particle_sums(p.body.masses, J, bias, A.T @ p.gravity)
    Q = Q + J[p.loaded].T @ (A.T @ p.force)
    Q[6:] -= p.body.K_ff @ q_f + p.body.D_ff @ q_f_dot
    solution = np.linalg.solve(M, Q)
    return A @ solution[:3], solution[3:6], solution[6:]


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    p, q_f = params, q_i[6:]
    weight = sum(mass * p.gravity @ place for mass, place in nodes(p, q_i, t))
    return 0.5 * q_i_dot @ M_hat(p, q_i, t) @ q_i_dot, 0.5 * q_f @ p.body.K_ff @ q_f - weight
