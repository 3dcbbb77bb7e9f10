"""Tree of rigid bodies on hinges, slides and both together, in the rates of the joints' own coordinates.

Derivation, in world axes. Body k hangs on a joint of its parent p: a rotation by an angle about, and a travel along,
the z-axis of the parent's marker, with the axes B_k at u_k. The body's own marker, with axes C_k at c_k, stands there:
    z_k = A_p B_k e_z,  A_k = A_p B_k R_z(angle) C_k^T,  r_k = r_p + A_p u_k + travel z_k - A_k c_k
    omega_k = omega_p + z_k angle',  J_w,k = J_w,p + z_k in the angle's column,
    alpha_0,k = alpha_0,p + omega_p x z_k angle'
    velocity of the joint's point s on body k: that of the parent's point, plus z_k travel' + omega_p x z_k travel
    its acceleration without second derivatives: a_0,p + alpha_0,p x d + omega_p x (omega_p x d)
    + 2 omega_p x z_k travel', with d = A_p u_k + travel z_k
    from s to the centre of mass at arm b: J_v = J_s + J_w x b,  a_0 = a_0,s + alpha_0 x b + omega x (omega x b)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.spatial.twin_spatial import Part, jourdain, rot_z
from tests.hand_derived.twin_common import Array


@dataclass(frozen=True, eq=False)
class Limb:
    """A body on its joint: parent (-1: the ground), markers (u, B) on it and (c, C) on the body, columns of w, inertia.

    angle, travel: the joint's columns, None where it leaves none free.
    """

    parent: int
    u: Array
    B: Array
    c: Array
    C: Array
    angle: int | None
    travel: int | None
    mass: float
    center: Array
    inertia: Array


def across(J: Array, arm: Array) -> Array:
    """Columns J_j x arm."""
    return np.cross(J, arm, axis=0)


def M_and_Q(limbs: list[Limb], gravity: Array, q: Array, w: Array) -> tuple[Array, Array]:
    """(M, Q) of M w' = Q."""
    n = len(q)
    ground = (np.eye(3), np.zeros(3), np.zeros((3, n)), np.zeros((3, n)), np.zeros(3), np.zeros(3), np.zeros(3))
    bodies, parts = [], []
    for limb in limbs:
        A_p, r_p, J_r, J_w, omega, alpha, a = ground if limb.parent < 0 else bodies[limb.parent]
        z = A_p @ limb.B[:, 2]
        travel = 0.0 if limb.travel is None else q[limb.travel]
        d = A_p @ limb.u + travel * z
        J_s = J_r + across(J_w, d)
        a_s = a + np.cross(alpha, d) + np.cross(omega, np.cross(omega, d))
        if limb.travel is not None:
            J_s = J_s + np.outer(z, np.eye(n)[limb.travel])
            a_s = a_s + 2 * np.cross(omega, z) * w[limb.travel]
        turned = np.eye(3)
        if limb.angle is not None:
            J_w = J_w + np.outer(z, np.eye(n)[limb.angle])
            alpha = alpha + np.cross(omega, z) * w[limb.angle]
            omega = omega + z * w[limb.angle]
            turned = rot_z(q[limb.angle])
        A = A_p @ limb.B @ turned @ limb.C.T
        back = -A @ limb.c
        J_r = J_s + across(J_w, back)
        a_r = a_s + np.cross(alpha, back) + np.cross(omega, np.cross(omega, back))
        bodies.append((A, r_p + d + back, J_r, J_w, omega, alpha, a_r))
        b = A @ limb.center
        a_0 = a_r + np.cross(alpha, b) + np.cross(omega, np.cross(omega, b))
        inertia = A @ limb.inertia @ A.T
        force, moment = limb.mass * gravity, np.zeros(3)
        parts.append(Part(limb.mass, inertia, J_r + across(J_w, b), J_w, omega, a_0, alpha, force, moment))
    return jourdain(parts)
