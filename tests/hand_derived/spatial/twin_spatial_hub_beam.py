"""Flexible beam on a rigid hub that turns about a tilted axis: q_i = (angle, q_f).

Hub: revolute joint; marker a on the ground at `pivot` with axes A_a (world), marker b on the hub at its origin with
axes B_b (columns, hub components): A_h B_b = A_a R_z(angle). Beam: frame clamped (weld) to the hub's point u_c with
axes B_c (hub components): A = A_h B_c, R_o = pivot + A_h u_c. Nodes of any place and shape; a slender beam has
x_k = (x_k, 0, 0).

Derivation (Jourdain for particles, world): z = A_a e_z, omega = z angle', rho_k = A_h u_c + A (x_k + Phi_k q_f)
    velocity      z x rho_k angle' + A Phi_k q_f'            J_k = [z x rho_k, A Phi_k]
    acceleration  J_k q'' + omega x (omega x rho_k) + 2 omega x A Phi_k q_f'
    hub: about the fixed axis, J_z = z.J_h z + m_h |z x r|^2, r = A_h centre; no bias force does work on the turn.
    M_hat = [[J_z, 0], [0, 0]] + sum m J^T J
    Q_hat = [m_h g.(z x r) + torque - c angle', -K q_f - D q_f'] + sum m J^T (g - bias)
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_flexible_nodes import Nodes, particle_sums, slender_beam
from tests.hand_derived.spatial.twin_spatial import E_Z, Pose, euler_A, rot_z
from tests.hand_derived.twin_common import Array


def _hub_inertia() -> Array:
    return np.array([[0.31, 0.02, -0.03], [0.02, 0.24, 0.04], [-0.03, 0.04, 0.19]])


@dataclass(frozen=True, eq=False)
class Params:
    """hub_mass kg; hub_inertia (3, 3) about the hub's centre of mass; hub_centre, clamp (3,) m, hub components;

    A_a, B_b, B_c (3, 3) axes of the markers; pivot (3,) m; torque N m about the axis; damper N m s/rad.
    """

    beam: Nodes = field(default_factory=slender_beam)
    hub_mass: float = 1.4
    hub_inertia: Array = field(default_factory=_hub_inertia)
    hub_centre: Array = field(default_factory=lambda: np.array([0.05, -0.03, 0.02]))
    pivot: Array = field(default_factory=lambda: np.array([0.3, 0.1, -0.2]))
    A_a: Array = field(default_factory=lambda: euler_A("zyx", np.array([0.3, 0.5, -0.8])))
    B_b: Array = field(default_factory=lambda: euler_A("zyx", np.array([-0.4, 0.2, 0.6])))
    clamp: Array = field(default_factory=lambda: np.array([0.12, 0.04, -0.05]))
    B_c: Array = field(default_factory=lambda: euler_A("zyx", np.array([0.7, -0.3, 0.4])))
    gravity: Array = field(default_factory=lambda: np.array([0.4, -1.1, -9.81]))
    torque: float = 0.6
    damper: float = 0.05


def coordinates(params: Params) -> list[str]:
    return ["hub.angle", *(f"beam.q{k + 1}" for k in range(params.beam.shapes.shape[2]))]


def _frames(p: Params, q_i: Array) -> tuple[Array, Array, Array]:
    """(A_h, A, R_o)."""
    A_h = p.A_a @ rot_z(q_i[0]) @ p.B_b.T
    return A_h, A_h @ p.B_c, p.pivot + A_h @ p.clamp


def _sums(p: Params, q_i: Array, q_i_dot: Array) -> tuple[Array, Array]:
    """Sums over the beam's nodes."""
    _, A, R_o = _frames(p, q_i)
    z = p.A_a @ E_Z
    rho = R_o - p.pivot + p.beam.places(q_i[1:]) @ A.T
    flexing = np.einsum("ab,kbj->kaj", A, p.beam.shapes)
    J = np.concatenate([np.cross(z, rho)[:, :, None], flexing], axis=2)
    omega = z * q_i_dot[0]
    bias = np.cross(omega, np.cross(omega, rho)) + 2 * np.cross(omega, flexing @ q_i_dot[1:])
    return particle_sums(p.beam.masses, J, bias, p.gravity)


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    p, z = params, params.A_a @ E_Z
    A_h = _frames(p, q_i)[0]
    M = _sums(p, q_i, np.zeros(q_i.size))[0]
    arm = np.cross(z, A_h @ p.hub_centre)
    M[0, 0] += z @ A_h @ p.hub_inertia @ A_h.T @ z + p.hub_mass * arm @ arm
    return M


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Torque and damper on the hub, modal damping."""
    on_hub = params.torque - params.damper * q_i_dot[0]
    return np.concatenate([[on_hub], -params.beam.D_ff @ q_i_dot[1:]])


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    p, A_h = params, _frames(params, q_i)[0]
    hub = p.hub_mass * p.gravity @ np.cross(p.A_a @ E_Z, A_h @ p.hub_centre)
    stored = np.concatenate([[hub], -p.beam.K_ff @ q_i[1:]])
    return _sums(p, q_i, q_i_dot)[1] + stored + Q_applied(p, q_i, q_i_dot, t)


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    """The hub."""
    A_h = _frames(params, q_i)[0]
    return [Pose(params.hub_mass, params.hub_inertia, params.pivot + A_h @ params.hub_centre, A_h)]


def nodes(params: Params, q_i: Array, t: float) -> list[tuple[float, Array]]:
    """(mass, world position) of the beam's nodes."""
    _, A, R_o = _frames(params, q_i)
    return list(zip(params.beam.masses, R_o + params.beam.places(q_i[1:]) @ A.T, strict=True))


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    p, q_f = params, q_i[1:]
    weight = p.hub_mass * p.gravity @ poses(p, q_i, t)[0].R_c + sum(m * p.gravity @ r for m, r in nodes(p, q_i, t))
    return 0.5 * q_i_dot @ M_hat(p, q_i, t) @ q_i_dot, 0.5 * q_f @ p.beam.K_ff @ q_f - weight
