"""Body-level constraints and energies of the flexible slider-crank, typed in full coordinates.

q = (crank.x, .y, .theta, rod.x, .y, .theta, rod.q1 .. rod.q<nf>, slider.x, .y, .theta).
Rows of C, in joint order:
    A      crank.origin - ground.origin (x, y)
    drive  crank.theta - Omega t                        (only where driven)
    B      rod.origin - crank.tip (x, y)
    slide  slider.y, slider.theta                       (prismatic along the ground's x-axis)
    C      slider.origin - rod.tip (x, y),  rod.tip = R + A(theta) (u, v)
The rod's kinetic energy in full coordinates, with R' its frame's velocity and S = s0 + P q_f:
    T = 1/2 m R'.R' + 1/2 (J + 2 d.q + q.M_ff q) theta'^2 + 1/2 q'.M_ff q' + theta' (e.q' + q.G q')
        + R'.A (theta' e_z x S + P q')
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.twin_common import Array
from tests.hand_derived.twin_rod_tree import Params


def constraints(params: Params, q: Array, t: float, driven: bool) -> Array:
    p, r = params, params.rod
    crank, frame, slider, q_f = q[:3], q[3:6], q[-3:], q[6:-3]
    s, c = np.sin(frame[2]), np.cos(frame[2])
    u, v = r.length + r.shape_x @ q_f, r.shape_y @ q_f
    rows = [crank[0], crank[1]]
    if driven:
        rows.append(crank[2] - p.Omega * t)
    rows += [frame[0] - crank[0] - p.l1 * np.cos(crank[2]), frame[1] - crank[1] - p.l1 * np.sin(crank[2])]
    rows += [slider[1], slider[2]]
    rows += [slider[0] - frame[0] - u * c + v * s, slider[1] - frame[1] - u * s - v * c]
    return np.array(rows)


def constraint_jacobian(params: Params, q: Array, t: float, driven: bool) -> Array:
    p, r = params, params.rod
    q_f = q[6:-3]
    s1, c1 = p.l1 * np.sin(q[2]), p.l1 * np.cos(q[2])
    s, c = np.sin(q[5]), np.cos(q[5])
    u, v = r.length + r.shape_x @ q_f, r.shape_y @ q_f
    zeros = np.zeros(q_f.size)
    rows = [[1, 0, 0, 0, 0, 0, *zeros, 0, 0, 0], [0, 1, 0, 0, 0, 0, *zeros, 0, 0, 0]]
    if driven:
        rows.append([0, 0, 1, 0, 0, 0, *zeros, 0, 0, 0])
    rows += [
        [-1, 0, s1, 1, 0, 0, *zeros, 0, 0, 0],
        [0, -1, -c1, 0, 1, 0, *zeros, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, *zeros, 0, 1, 0],
        [0, 0, 0, 0, 0, 0, *zeros, 0, 0, 1],
        [0, 0, 0, -1, 0, u * s + v * c, *(-r.shape_x * c + r.shape_y * s), 1, 0, 0],
        [0, 0, 0, 0, -1, -u * c + v * s, *(-r.shape_x * s - r.shape_y * c), 0, 1, 0],
    ]
    return np.array(rows)


def energy(params: Params, q: Array, q_dot: Array, t: float) -> tuple[complex, complex]:
    """Body-level (T, V); V = elastic + gravity."""
    p, r = params, params.rod
    q_f, q_f_dot, g = q[6:-3], q_dot[6:-3], params.gravity
    s1, c1, s, c = np.sin(q[2]), np.cos(q[2]), np.sin(q[5]), np.cos(q[5])
    crank_v = [q_dot[0] - p.a1 * s1 * q_dot[2], q_dot[1] + p.a1 * c1 * q_dot[2]]
    kinetic = 0.5 * p.m1 * (crank_v[0] ** 2 + crank_v[1] ** 2) + 0.5 * p.J1 * q_dot[2] ** 2
    kinetic = kinetic + 0.5 * p.m3 * (q_dot[-3] ** 2 + q_dot[-2] ** 2) + 0.5 * p.J3 * q_dot[-1] ** 2
    w, frame_v = q_dot[5], q_dot[3:5]
    moment = r.first_moment + r.phi_integral @ q_f
    local = w * np.array([-moment[1], moment[0]]) + r.phi_integral @ q_f_dot
    world = np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]])
    inertia = r.inertia + 2 * r.rho_dot_phi @ q_f + q_f @ r.M_ff @ q_f
    kinetic = kinetic + 0.5 * r.mass * frame_v @ frame_v + 0.5 * inertia * w**2
    kinetic = kinetic + 0.5 * q_f_dot @ r.M_ff @ q_f_dot + frame_v @ world
    kinetic = kinetic + w * (r.rho_cross_phi @ q_f_dot + q_f @ r.phi_cross_phi @ q_f_dot)
    rod_moment = np.array([c * moment[0] - s * moment[1], s * moment[0] + c * moment[1]])
    weights = p.m1 * (q[:2] + p.a1 * np.array([c1, s1])) + r.mass * q[3:5] + rod_moment + p.m3 * q[-3:-1]
    return kinetic, 0.5 * q_f @ r.K_ff @ q_f - g @ weights
