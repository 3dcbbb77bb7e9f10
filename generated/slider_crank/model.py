"""Rigid slider-crank: equations of motion, emitted by symgen from the scene `slider_crank`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 76 operations."""
    p = ca.SX.sym("p", 11)
    gravity_y = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    rod_mass = p[4]
    rod_inertia = p[5]
    rod_center_of_mass_x = p[6]
    slider_mass = p[7]
    slider_inertia = p[8]
    crank_tip_x = p[9]
    rod_tip_x = p[10]
    w0 = crank_mass * crank_center_of_mass_x
    w1 = 2 * crank_tip_x
    w2 = rod_mass * w1
    w3 = rod_center_of_mass_x * w2
    w4 = rod_tip_x * (slider_mass * w1)
    w5 = 2 * rod_mass
    w6 = rod_tip_x * (rod_tip_x * (2 * slider_mass))
    w7 = rod_center_of_mass_x * (rod_tip_x * w2)
    c = ca.vertcat(
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        crank_tip_x,
        rod_mass,
        slider_mass,
        rod_mass + slider_mass,
        rod_tip_x,
        rod_mass * rod_center_of_mass_x,
        rod_inertia + rod_mass * rod_center_of_mass_x**2,
        gravity_y,
        w0 * gravity_y,
        rod_mass * gravity_y,
        crank_mass,
        w0,
        slider_inertia,
        crank_mass * gravity_y,
        slider_mass * gravity_y,
        w3,
        w3 + w4,
        slider_mass * (crank_tip_x * w1),
        w6,
        w7,
        w7 + rod_tip_x * w4,
        rod_center_of_mass_x * (rod_center_of_mass_x * w5) + 2 * rod_inertia,
        rod_tip_x * w6,
        rod_center_of_mass_x * (rod_center_of_mass_x * (rod_tip_x * w5)) + rod_inertia * (2 * rod_tip_x),
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 87 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c1
    w2 = ca.sin(crank_theta) * c1
    w3 = ca.cos(rod_theta)
    w4 = w3 * c5
    w5 = w1 / w4
    w6 = w3 * c6
    w7 = ca.sin(rod_theta)
    w8 = w7 * c6
    w9 = w7 * c5
    w10 = w9 * c3
    w11 = w1 * w6 + w2 * (w8 + w10)
    w12 = rod_theta_dot**2
    w13 = crank_theta_dot**2
    w14 = w2 * w13
    w15 = (w9 * w12 + w14) / w4
    w16 = w1 * w13
    w17 = (w16 + w4 * w12 + w9 * w15) * c3
    w18 = w0 * c9 + w1 * (w8 * w12 + c10 - (w6 * w15 - w14 * c2)) - w2 * (w6 * w12 + (w16 * c2 + w8 * w15) + w17)
    M_hat = ca.vertcat(
        c0 + w1 * (w1 * c2) + w2 * (w2 * c4) - (w5 * (w11 - w5 * (c7 + w9 * w10)) + w5 * w11),
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w18 - w5 * (w6 * c8 - (w8 * w16 - w6 * w14 + w15 * c7) - w9 * w17),
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 31 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    c1 = c[1]
    c5 = c[5]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = w1 + ca.sin(rod_theta) * c5
    w3 = ca.cos(rod_theta) * c5
    w4 = rod_theta - w2 / w3
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w4,
        w0 + ca.cos(w4) * c5,
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w2,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        -w3,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 30 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    c1 = c[1]
    c5 = c[5]
    w0 = ca.sin(crank_theta) * c1 * crank_theta_dot
    w1 = ca.cos(crank_theta) * c1
    w2 = crank_theta_dot * (w1 / (ca.cos(rod_theta) * c5))
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -w0,
        crank_theta_dot * w1,
        -w2,
        w2 * (ca.sin(rod_theta) * c5) - w0,
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 44 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    c1 = c[1]
    c5 = c[5]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c1
    w2 = ca.sin(crank_theta) * c1
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w0 * w2
    w5 = rod_theta_dot**2
    w6 = ca.sin(rod_theta) * c5
    w7 = ca.cos(rod_theta) * c5
    w8 = (w4 + w5 * w6) / w7 - crank_theta_ddot * (w1 / w7)
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -w3,
        w1 * crank_theta_ddot - w4,
        w8,
        -(w3 + w5 * w7 + w6 * w8),
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 148 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 25)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[6]
    slider_y = q[7]
    slider_theta = q[8]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    c1 = c[1]
    c5 = c[5]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = ca.cos(rod_theta) * c5
    w3 = ca.sin(rod_theta) * c5
    w4 = crank_theta_dot**2
    w5 = rod_theta_dot**2
    C = ca.vertcat(
        crank_x,
        crank_y,
        rod_x - (crank_x + w0),
        rod_y - (crank_y + w1),
        slider_y,
        slider_theta,
        slider_x - (rod_x + w2),
        slider_y - (rod_y + w3),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        -w0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w3,
        -w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 9)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w4),
        -(w1 * w4),
        0.0,
        0.0,
        -(w2 * w5),
        -(w3 * w5),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 324 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 25)
    crank_theta = q[2]
    rod_theta = q[5]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    w0 = ca.sin(crank_theta)
    w1 = w0 * c12
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c12
    w5 = ca.sin(rod_theta)
    w6 = w5 * c6
    w7 = -w6
    w8 = ca.cos(rod_theta)
    w9 = w8 * c6
    w10 = crank_theta_dot**2
    w11 = w4 * w10
    w12 = w1 * w10
    w13 = rod_theta_dot**2
    w14 = w9 * w13
    w15 = w6 * w13
    w16 = w4 * c8
    w17 = w9 * c8
    w18 = w0 * c1
    w19 = w3 * c1
    w20 = w5 * c5
    w21 = w8 * c5
    M = ca.vertcat(
        c11,
        0.0,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c11,
        w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
        0.0,
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
        w9,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w7,
        w9,
        c7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c13,
    )
    M = ca.reshape(M, 9, 9)
    M = ca.densify(M)
    K = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    K = ca.reshape(K, 9, 9)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w11,
        w12,
        0.0,
        w14,
        w15,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c14,
        w16,
        0.0,
        c10,
        w17,
        0.0,
        c15,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w11,
        w12 + c14,
        w16,
        w14,
        c10 + w15,
        w17,
        0.0,
        c15,
        0.0,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w18,
        -w19,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w20,
        -w21,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 9)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w10 * w19),
        -(w10 * w18),
        0.0,
        0.0,
        -(w13 * w21),
        -(w13 * w20),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 107 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 25)
    crank_theta = q[2]
    rod_theta = q[5]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    slider_x_ddot = q_ddot[6]
    slider_y_ddot = q_ddot[7]
    slider_theta_ddot = q_ddot[8]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c12
    w2 = ca.sin(crank_theta) * c12
    w3 = rod_theta_dot**2
    w4 = ca.cos(rod_theta)
    w5 = w4 * c6
    w6 = ca.sin(rod_theta)
    w7 = w6 * c6
    w8 = slider_x_ddot * c3
    w9 = w3 * w5 - (rod_x_ddot * c2 - w7 * rod_theta_ddot) - w8
    w10 = w0 * w1 - (crank_x_ddot * c11 - w2 * crank_theta_ddot) + w9
    w11 = (w5 * c8 - (w5 * rod_y_ddot - rod_x_ddot * w7 + rod_theta_ddot * c7) + w8 * (w6 * c5)) / (w4 * c5)
    w12 = c10 + w3 * w7 - (rod_y_ddot * c2 + w5 * rod_theta_ddot) - w11
    w13 = c14 + w0 * w2 - (crank_y_ddot * c11 + w1 * crank_theta_ddot) + w12
    w14 = w11 + (c15 - slider_y_ddot * c3)
    w15 = slider_theta_ddot * c13
    lam = ca.vertcat(
        w10,
        w13,
        w9,
        w12,
        w14,
        -w15,
        -w8,
        -w11,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w10,
        -w13,
        0.0,
        -w9,
        -w12,
        0.0,
        0.0,
        -w14,
        w15,
        w8,
        w11,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 4)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 92 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 25)
    crank_y = q[1]
    crank_theta = q[2]
    rod_y = q[4]
    rod_theta = q[5]
    slider_y = q[7]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    slider_x_dot = q_dot[6]
    slider_y_dot = q_dot[7]
    slider_theta_dot = q_dot[8]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c15 = c[15]
    w0 = ca.sin(crank_theta) * c12
    w1 = ca.cos(crank_theta) * c12
    w2 = crank_x_dot * (crank_x_dot * c11 - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * c11 + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta) * c6
    w4 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c0) + rod_x_dot * (rod_x_dot * c2 - w3 * rod_theta_dot)
    w5 = ca.cos(rod_theta) * c6
    w6 = w4 + rod_y_dot * (rod_y_dot * c2 + rod_theta_dot * w5) + rod_theta_dot * (rod_y_dot * w5 - rod_x_dot * w3 + rod_theta_dot * c7)
    w7 = w6 + slider_x_dot * (slider_x_dot * c3) + slider_y_dot * (slider_y_dot * c3) + slider_theta_dot * (slider_theta_dot * c13)
    kinetic = ca.vertcat(
        w7 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -((w0 + crank_y * c11) * c8 + (w3 + rod_y * c2) * c8 + slider_y * c15),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 56 operations."""
    q = ca.SX.sym("q", 9)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[6]
    slider_y = q[7]
    slider_theta = q[8]
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(rod_theta)
    w3 = ca.sin(rod_theta)
    w4 = ca.cos(slider_theta)
    w5 = ca.sin(slider_theta)
    poses = ca.vertcat(
        crank_x,
        crank_y,
        0.0,
        w0,
        w1,
        0.0,
        -w1,
        w0,
        0.0,
        0.0,
        0.0,
        1.0,
        rod_x,
        rod_y,
        0.0,
        w2,
        w3,
        0.0,
        -w3,
        w2,
        0.0,
        0.0,
        0.0,
        1.0,
        slider_x,
        slider_y,
        0.0,
        w4,
        w5,
        0.0,
        -w5,
        w4,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    poses = ca.reshape(poses, 12, 3)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 149 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.cos(rod_theta)
    w2 = w1 * c5
    w3 = w0 / w2
    w4 = crank_theta_dot**2
    w5 = w0 * w4
    w6 = w5 / w2
    w7 = ca.sin(rod_theta)
    w8 = w7 * c6
    w9 = ca.sin(crank_theta)
    w10 = w9 * c1
    w11 = w4 * w10
    w12 = w1 * c6
    w13 = w8 * w11 + w5 * w12
    w14 = w7 * c5
    w15 = (w6 * w14 - w11) * c3
    w16 = rod_theta_dot**2
    w17 = w14 * w16
    w18 = w11 + w17
    w19 = w18 / w2
    w20 = (w5 + w2 * w16 + w14 * w19) * c3
    w21 = w12 * c8 - (w5 * w8 - w11 * w12 + w19 * c7) - w14 * w20
    w22 = w10 / w2
    w23 = w5 * c2
    w24 = w8 * w16
    w25 = w12 * w19
    w26 = w11 * c2
    w27 = w12 * w16
    w28 = w8 * w19
    w29 = w9 * c9 + (w0 * (w6 * w12 - w23) + w10 * (c10 + w24 - (w25 - w26))) + (w10 * (w15 + (w6 * w8 - w26)) + w0 * (w20 + (w27 + (w23 + w28))))
    w30 = w16 + w14 * (w19 / w2)
    w31 = (w18 + w14 * w30 - w17) * c3
    w32 = w14 * (w3 / w2)
    w33 = w0 * (w27 - (w12 * w30 - w28)) - w10 * (w25 + w8 * w30 - w24 + w31) - (w21 * w32 - w3 * (w8 * c8 + (w13 + w30 * c7) + (w14 * w31 + w2 * w20)))
    w34 = 2 * rod_theta_dot
    w35 = w14 * w34 / w2
    w36 = (w2 * w34 + w14 * w35) * c3
    w37 = (w0 * (w8 * w34 - w12 * w35) - w10 * (w12 * w34 + w8 * w35 + w36) + w3 * (w35 * c7 + w14 * w36)) * (crank_theta_dot * w22 + w3 * (crank_theta_dot * w32))
    dQ_hat_dq_i = ca.vertcat(
        w3 * (w6 * c7 - w13 + w14 * w15) + w21 * w22 - w29 - w3 * w33 + w37,
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 58 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(rod_theta)
    w2 = w1 * c6
    w3 = ca.cos(rod_theta)
    w4 = w3 * c5
    w5 = w0 / w4
    w6 = w5 * (2 * (w5 * crank_theta_dot))
    w7 = w3 * c6
    w8 = w1 * c5
    w9 = ca.sin(crank_theta) * c1
    w10 = 2 * crank_theta_dot
    w11 = w9 * w10
    w12 = (w6 * w8 + w11) / w4
    w13 = w0 * w10
    w14 = (w13 + w4 * w6 + w8 * w12) * c3
    w15 = w0 * (w2 * w6 - (w7 * w12 - w11 * c2)) - w9 * (w6 * w7 + (w13 * c2 + w2 * w12) + w14) + w5 * (w2 * w13 - w7 * w11 + w12 * c7 + w8 * w14)
    dQ_hat_dq_i_dot = ca.vertcat(
        w15,
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 82 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 25)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_ddot = q_i_ddot[0]
    c1 = c[1]
    c5 = c[5]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    w0 = ca.cos(crank_theta)
    w1 = ca.cos(rod_theta)
    w2 = ca.sin(crank_theta)
    w3 = w1 * c5
    w4 = crank_theta_ddot * (w2 * c1 / w3)
    w5 = w0 * c1 / w3
    w6 = crank_theta_ddot * w5
    w7 = ca.sin(rod_theta)
    w8 = w5 / w3
    w9 = w0 * w1
    w10 = w6 * w8
    w11 = w0 * w7
    w12 = w5 * w6
    w13 = w1 * w2
    w14 = w2 * w7
    w15 = w4 * w5
    w16 = w7**2
    w17 = w8 * w12
    w18 = w6 * (w13 * c16) + (crank_theta_ddot * (w0 * w2 * c18) + (w4 * (w9 * c16) + w7 * w9 * c20 * w10))
    w19 = w10 * (w7 * w14 * c21) + (w4 * (w14 * c17) + (w12 * (w13 * c17) + w18)) - w11 * c16 * w12 - w6 * (w11 * c17)
    w20 = w19 - w1 * w7 * c19 * (w5 * w12) - w15 * c22 - w15 * (w16 * c19) - w7 * w16 * c23 * w17 - w17 * (w7 * c24)
    dMa_dq_i = ca.vertcat(
        w20,
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 76 operations."""
    p = ca.SX.sym("p", 11)
    crank_tip_x = p[9]
    rod_tip_x = p[10]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        crank_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        rod_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 6)
    positions = ca.densify(positions)
    axes = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    axes = ca.reshape(axes, 9, 6)
    axes = ca.densify(axes)
    inputs, outputs = [p], [positions, axes]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "closure": closure,
    "velocities": velocities,
    "accelerations": accelerations,
    "constraints": constraints,
    "augmented": augmented,
    "reactions": reactions,
    "energy": energy,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "geometry": geometry,
}
