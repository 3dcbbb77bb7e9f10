"""Four-bar linkage: equations of motion, emitted by symgen from the scene `four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 48 operations."""
    p = ca.SX.sym("p", 15)
    gravity_y = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    coupler_mass = p[4]
    coupler_inertia = p[5]
    coupler_center_of_mass_x = p[6]
    rocker_mass = p[7]
    rocker_inertia = p[8]
    rocker_center_of_mass_x = p[9]
    crank_tip_x = p[10]
    coupler_tip_x = p[11]
    rocker_tip_x = p[12]
    ground_right_x = p[13]
    motor_value = p[14]
    c = ca.vertcat(
        crank_tip_x,
        coupler_mass,
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        coupler_tip_x,
        rocker_tip_x,
        rocker_inertia + rocker_mass * rocker_center_of_mass_x**2,
        coupler_mass * coupler_center_of_mass_x,
        coupler_inertia + coupler_mass * coupler_center_of_mass_x**2,
        crank_mass * crank_center_of_mass_x,
        gravity_y,
        motor_value,
        coupler_mass * gravity_y,
        rocker_mass * rocker_center_of_mass_x,
        ground_right_x,
        crank_mass * gravity_y,
        rocker_mass * gravity_y,
        crank_mass,
        rocker_mass,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 118 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
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
    c11 = c[11]
    c12 = c[12]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = ca.sin(crank_theta) * c0
    w3 = ca.sin(coupler_theta)
    w4 = w3 * c3
    w5 = ca.cos(coupler_theta)
    w6 = w5 * c3
    w7 = ca.cos(rocker_theta)
    w8 = w7 * c4
    w9 = ca.sin(rocker_theta) * c4
    w10 = w4 * w8 - w9 * w6
    w11 = (w4 * w1 - w6 * w2) / w10
    w12 = (w9 * w1 - w8 * w2) / w10
    w13 = w5 * c6
    w14 = w3 * c6
    w15 = w1 * w13 + w2 * w14
    w16 = coupler_theta_dot**2
    w17 = rocker_theta_dot**2
    w18 = crank_theta_dot**2
    w19 = w1 * w18
    w20 = w8 * w17 - w6 * w16 - w19
    w21 = w2 * w18
    w22 = w9 * w17 - w4 * w16 - w21
    w23 = (w8 * w20 + w9 * w22) / w10
    w24 = w0 * c8 * c9 + c10 + (w14 * w16 + c11 - (w13 * w23 - c1 * w21)) * w1 - (w13 * w16 + (c1 * w19 + w14 * w23)) * w2
    w25 = w24 + (w7 * c12 * c9 - c5 * ((w6 * w20 + w4 * w22) / w10)) * w11 + (w13 * c9 - (w14 * w19 - w13 * w21 + c7 * w23)) * w12
    M_hat = ca.vertcat(
        c2 + w1 * (w1 * c1) + w2 * (w2 * c1) + w11 * (w11 * c5) + (w12 * (w15 + w12 * c7) + w12 * w15),
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w25,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d in closed form (Eq. 31); C_loop before the step. 48 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c13 = c[13]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = ca.cos(rocker_theta) * c4
    w3 = ca.cos(coupler_theta) * c3
    w4 = c13 + w2 - (w0 + w3)
    w5 = ca.sin(rocker_theta) * c4
    w6 = ca.sin(coupler_theta) * c3
    w7 = w5 - (w1 + w6)
    w8 = w6 * w2 - w5 * w3
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        coupler_theta - (w2 * w4 + w5 * w7) / w8,
        c13,
        0.0,
        rocker_theta - (w3 * w4 + w6 * w7) / w8,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        w4,
        w7,
    )
    C_loop = ca.densify(C_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 44 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    w0 = ca.sin(crank_theta) * c0
    w1 = ca.cos(crank_theta) * c0
    w2 = ca.sin(rocker_theta) * c4
    w3 = ca.cos(rocker_theta) * c4
    w4 = ca.sin(coupler_theta) * c3
    w5 = ca.cos(coupler_theta) * c3
    w6 = w4 * w3 - w2 * w5
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -(w0 * crank_theta_dot),
        w1 * crank_theta_dot,
        (w2 * w1 - w3 * w0) / w6 * crank_theta_dot,
        0.0,
        0.0,
        (w4 * w1 - w5 * w0) / w6 * crank_theta_dot,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 72 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_i_ddot[0]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    w0 = ca.cos(crank_theta) * c0
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = ca.sin(crank_theta) * c0
    w4 = w3 * w1
    w5 = ca.cos(rocker_theta) * c4
    w6 = rocker_theta_dot**2
    w7 = ca.cos(coupler_theta) * c3
    w8 = coupler_theta_dot**2
    w9 = w5 * w6 - w7 * w8 - w2
    w10 = ca.sin(rocker_theta) * c4
    w11 = ca.sin(coupler_theta) * c3
    w12 = w10 * w6 - w11 * w8 - w4
    w13 = w11 * w5 - w10 * w7
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -(w2 + w3 * crank_theta_ddot),
        w0 * crank_theta_ddot - w4,
        (w5 * w9 + w10 * w12) / w13 + (w10 * w0 - w5 * w3) / w13 * crank_theta_ddot,
        0.0,
        0.0,
        (w7 * w9 + w11 * w12) / w13 + (w11 * w0 - w7 * w3) / w13 * crank_theta_ddot,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t and gamma in all coordinates (Eqs. 21-27). 154 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[6]
    rocker_y = q[7]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c13 = c[13]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = ca.cos(rocker_theta) * c4
    w3 = ca.cos(coupler_theta) * c3
    w4 = ca.sin(rocker_theta) * c4
    w5 = ca.sin(coupler_theta) * c3
    w6 = crank_theta_dot**2
    w7 = rocker_theta_dot**2
    w8 = coupler_theta_dot**2
    C = ca.vertcat(
        crank_x,
        crank_y,
        coupler_x - (crank_x + w0),
        coupler_y - (crank_y + w1),
        rocker_x + w2 - (coupler_x + w3),
        rocker_y + w4 - (coupler_y + w5),
        rocker_x - c13,
        rocker_y,
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
        w5,
        -w3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w4,
        w2,
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
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w6),
        -(w1 * w6),
        w2 * w7 - w3 * w8,
        w4 * w7 - w5 * w8,
        0.0,
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "gamma"])


def augmented() -> ca.Function:
    """M and Q* of the augmented form (Eq. 28). 142 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_theta = q[2]
    coupler_theta = q[5]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    c1 = c[1]
    c2 = c[2]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    w0 = ca.sin(crank_theta) * c8
    w1 = -w0
    w2 = ca.cos(crank_theta) * c8
    w3 = ca.sin(coupler_theta) * c6
    w4 = -w3
    w5 = ca.cos(coupler_theta) * c6
    w6 = ca.sin(rocker_theta) * c12
    w7 = -w6
    w8 = ca.cos(rocker_theta) * c12
    w9 = crank_theta_dot**2
    w10 = coupler_theta_dot**2
    w11 = rocker_theta_dot**2
    M = ca.vertcat(
        c16,
        0.0,
        w1,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c16,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        w2,
        c2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        0.0,
        w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        w5,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w4,
        w5,
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
        c17,
        0.0,
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c17,
        w8,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w7,
        w8,
        c5,
    )
    M = ca.reshape(M, 9, 9)
    M = ca.densify(M)
    Q_star = ca.vertcat(
        w2 * w9,
        w0 * w9 + c14,
        w2 * c9 + c10,
        w5 * w10,
        w3 * w10 + c11,
        w5 * c9,
        w8 * w11,
        w6 * w11 + c15,
        w8 * c9,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, c], [M, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "Q_star"])


def reactions() -> ca.Function:
    """Lagrange multipliers lam (Eq. 37). 120 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 18)
    crank_theta = q[2]
    coupler_theta = q[5]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    coupler_x_ddot = q_ddot[3]
    coupler_y_ddot = q_ddot[4]
    coupler_theta_ddot = q_ddot[5]
    rocker_x_ddot = q_ddot[6]
    rocker_y_ddot = q_ddot[7]
    rocker_theta_ddot = q_ddot[8]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c11 = c[11]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    w0 = ca.cos(crank_theta) * c8
    w1 = crank_theta_dot**2
    w2 = ca.sin(crank_theta) * c8
    w3 = ca.cos(coupler_theta)
    w4 = w3 * c6
    w5 = coupler_theta_dot**2
    w6 = ca.sin(coupler_theta)
    w7 = w6 * c6
    w8 = ca.cos(rocker_theta)
    w9 = w8 * c4
    w10 = w4 * c9 - (w4 * coupler_y_ddot - w7 * coupler_x_ddot + c7 * coupler_theta_ddot)
    w11 = w3 * c3
    w12 = w8 * c12
    w13 = ca.sin(rocker_theta)
    w14 = w13 * c12
    w15 = w12 * c9 - (w12 * rocker_y_ddot - w14 * rocker_x_ddot + c5 * rocker_theta_ddot)
    w16 = w6 * c3
    w17 = w13 * c4
    w18 = w16 * w9 - w11 * w17
    w19 = (w9 * w10 + w11 * w15) / w18
    w20 = w4 * w5 - (c1 * coupler_x_ddot - w7 * coupler_theta_ddot) + w19
    w21 = (w17 * w10 + w16 * w15) / w18
    w22 = w7 * w5 + c11 - (c1 * coupler_y_ddot + w4 * coupler_theta_ddot) + w21
    w23 = rocker_theta_dot**2
    lam = ca.vertcat(
        w0 * w1 - (c16 * crank_x_ddot - w2 * crank_theta_ddot) + w20,
        w2 * w1 + c14 - (c16 * crank_y_ddot + w0 * crank_theta_ddot) + w22,
        w20,
        w22,
        w19,
        w21,
        w12 * w23 - (c17 * rocker_x_ddot - w14 * rocker_theta_ddot) - w19,
        w14 * w23 + c15 - (c17 * rocker_y_ddot + w12 * rocker_theta_ddot) - w21,
    )
    lam = ca.densify(lam)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 109 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_y = q[1]
    crank_theta = q[2]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_y = q[7]
    rocker_theta = q[8]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    coupler_x_dot = q_dot[3]
    coupler_y_dot = q_dot[4]
    coupler_theta_dot = q_dot[5]
    rocker_x_dot = q_dot[6]
    rocker_y_dot = q_dot[7]
    rocker_theta_dot = q_dot[8]
    c1 = c[1]
    c2 = c[2]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c12 = c[12]
    c16 = c[16]
    c17 = c[17]
    w0 = ca.sin(crank_theta) * c8
    w1 = ca.cos(crank_theta) * c8
    w2 = crank_x_dot * (c16 * crank_x_dot - w0 * crank_theta_dot) + crank_y_dot * (c16 * crank_y_dot + w1 * crank_theta_dot)
    w3 = ca.sin(coupler_theta) * c6
    w4 = w2 + crank_theta_dot * (w1 * crank_y_dot - w0 * crank_x_dot + c2 * crank_theta_dot) + coupler_x_dot * (c1 * coupler_x_dot - w3 * coupler_theta_dot)
    w5 = ca.cos(coupler_theta) * c6
    w6 = w4 + coupler_y_dot * (c1 * coupler_y_dot + w5 * coupler_theta_dot) + coupler_theta_dot * (w5 * coupler_y_dot - w3 * coupler_x_dot + c7 * coupler_theta_dot)
    w7 = ca.sin(rocker_theta) * c12
    w8 = ca.cos(rocker_theta) * c12
    w9 = w6 + rocker_x_dot * (c17 * rocker_x_dot - w7 * rocker_theta_dot) + rocker_y_dot * (c17 * rocker_y_dot + w8 * rocker_theta_dot)
    kinetic = ca.vertcat(
        (w9 + rocker_theta_dot * (w8 * rocker_y_dot - w7 * rocker_x_dot + c5 * rocker_theta_dot)) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(c9 * (c16 * crank_y + w0) + c9 * (c1 * coupler_y + w3) + c9 * (c17 * rocker_y + w7)),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        c10 * crank_theta_dot,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 48 operations."""
    q = ca.SX.sym("q", 9)
    c = ca.SX.sym("c", 18)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[6]
    rocker_y = q[7]
    rocker_theta = q[8]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c13 = c[13]
    xy = ca.vertcat(
        0.0,
        0.0,
        c13,
        0.0,
        crank_x,
        crank_y,
        crank_x + ca.cos(crank_theta) * c0,
        crank_y + ca.sin(crank_theta) * c0,
        coupler_x,
        coupler_y,
        coupler_x + ca.cos(coupler_theta) * c3,
        coupler_y + ca.sin(coupler_theta) * c3,
        rocker_x,
        rocker_y,
        rocker_x + ca.cos(rocker_theta) * c4,
        rocker_y + ca.sin(rocker_theta) * c4,
    )
    xy = ca.reshape(xy, 2, 8)
    xy = ca.densify(xy)
    inputs, outputs = [q, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 319 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c11 = c[11]
    c12 = c[12]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = coupler_theta_dot**2
    w3 = ca.cos(coupler_theta)
    w4 = c6 * w3
    w5 = w3 * c6
    w6 = ca.cos(rocker_theta)
    w7 = w6 * c4
    w8 = ca.sin(coupler_theta)
    w9 = c3 * w8
    w10 = w2 * w9
    w11 = ca.sin(rocker_theta)
    w12 = w11 * c4
    w13 = c3 * w3
    w14 = w2 * w13
    w15 = w8 * c3
    w16 = w3 * c3
    w17 = w15 * w7 - w12 * w16
    w18 = rocker_theta_dot**2
    w19 = crank_theta_dot**2
    w20 = w1 * w19
    w21 = w7 * w18 - w16 * w2 - w20
    w22 = ca.sin(crank_theta)
    w23 = w22 * c0
    w24 = w23 * w19
    w25 = w12 * w18 - w15 * w2 - w24
    w26 = (w7 * w21 + w12 * w25) / w17
    w27 = w26 / w17
    w28 = w7 * w13 + w12 * w9
    w29 = (w7 * w10 - w12 * w14) / w17 - w27 * w28
    w30 = c6 * w8
    w31 = w8 * c6
    w32 = (w16 * w21 + w15 * w25) / w17
    w33 = w6 * c12 * c9 - c5 * w32
    w34 = (w15 * w1 - w16 * w23) / w17
    w35 = w34 / w17
    w36 = (w1 * w13 + w23 * w9) / w17 - w35 * w28
    w37 = w32 / w17
    w38 = w1 * (w2 * w4 - (w5 * w29 - w26 * w30)) - w23 * (w26 * w4 + w31 * w29 - w2 * w30) + (w33 * w36 - w34 * (c5 * ((w16 * w10 - w21 * w9 + (w25 * w13 - w15 * w14)) / w17 - w37 * w28)))
    w39 = (w12 * w1 - w7 * w23) / w17
    w40 = w5 * c9 - (w31 * w20 - w5 * w24 + c7 * w26)
    w41 = w39 / w17
    w42 = w41 * w28
    w43 = c4 * w11
    w44 = c4 * w6
    w45 = w15 * w43 + w16 * w44
    w46 = w35 * w45
    w47 = w18 * w44
    w48 = w18 * w43
    w49 = (w25 * w44 + w12 * w47 - (w21 * w43 + w7 * w48)) / w17 + w27 * w45
    w50 = w33 * w46 - w34 * (c9 * (c12 * w11) + c5 * ((w15 * w47 - w16 * w48) / w17 + w37 * w45)) - (w1 * (w5 * w49) + w23 * (w31 * w49))
    w51 = (w1 * w44 + w23 * w43) / w17 + w41 * w45
    w52 = (w38 - (w39 * (c9 * w30 + (w20 * w4 + w24 * w30 + c7 * w29)) + w40 * w42)) * w39 + (w50 + (w40 * w51 - w39 * (c7 * w49))) * w34
    w53 = c0 * w22
    w54 = w19 * w53
    w55 = c0 * w0
    w56 = w19 * w55
    w57 = (w7 * w54 - w12 * w56) / w17
    w58 = c9 * (c8 * w22) + (w1 * (w5 * w57 - c1 * w56) + (w31 * w2 + c11 - (w5 * w26 - c1 * w24)) * w53) + (w23 * (w31 * w57 - c1 * w54) + (w5 * w2 + (c1 * w20 + w31 * w26)) * w55)
    w59 = (w15 * w53 + w16 * w55) / w17
    w60 = (w12 * w53 + w7 * w55) / w17
    w61 = w58 + (w34 * (c5 * ((w16 * w54 - w15 * w56) / w17)) + w33 * w59) + (w39 * (c7 * w57 - (w31 * w54 + w5 * w56)) + w40 * w60)
    w62 = 2 * coupler_theta_dot
    w63 = w16 * w62
    w64 = w15 * w62
    w65 = (w7 * w63 + w12 * w64) / w17
    w66 = w1 * (w31 * w62 + w5 * w65) - w23 * (w5 * w62 - w31 * w65) + w34 * (c5 * ((w16 * w63 + w15 * w64) / w17))
    w67 = (w66 + w39 * (c7 * w65)) * (crank_theta_dot * w51 * w34 - crank_theta_dot * w42 * w39 - crank_theta_dot * w60)
    w68 = 2 * rocker_theta_dot
    w69 = w7 * w68
    w70 = w12 * w68
    w71 = (w7 * w69 + w12 * w70) / w17
    w72 = w1 * (w5 * w71) + w23 * (w31 * w71) + w34 * (c5 * ((w16 * w69 + w15 * w70) / w17)) + w39 * (c7 * w71)
    w73 = w52 - w61 + (w67 - w72 * (crank_theta_dot * w36 * w39 + crank_theta_dot * w46 * w34 - crank_theta_dot * w59))
    dQ_hat_dq_i = ca.vertcat(
        w73,
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 121 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.cos(coupler_theta)
    w2 = w1 * c6
    w3 = ca.cos(rocker_theta) * c4
    w4 = 2 * crank_theta_dot
    w5 = w0 * w4
    w6 = ca.sin(rocker_theta) * c4
    w7 = ca.sin(crank_theta) * c0
    w8 = w7 * w4
    w9 = ca.sin(coupler_theta)
    w10 = w9 * c3
    w11 = w1 * c3
    w12 = w10 * w3 - w6 * w11
    w13 = (w3 * w5 + w6 * w8) / w12
    w14 = w9 * c6
    w15 = (w10 * w0 - w11 * w7) / w12
    w16 = w0 * (w2 * w13 + c1 * w8) - w7 * (c1 * w5 - w14 * w13) + w15 * (c5 * ((w11 * w5 + w10 * w8) / w12))
    w17 = (w6 * w0 - w3 * w7) / w12
    w18 = 2 * coupler_theta_dot
    w19 = w11 * w18
    w20 = w10 * w18
    w21 = (w3 * w19 + w6 * w20) / w12
    w22 = w0 * (w14 * w18 + w2 * w21) - w7 * (w2 * w18 - w14 * w21) + w15 * (c5 * ((w11 * w19 + w10 * w20) / w12))
    w23 = 2 * rocker_theta_dot
    w24 = w3 * w23
    w25 = w6 * w23
    w26 = (w3 * w24 + w6 * w25) / w12
    w27 = w0 * (w2 * w26) + w7 * (w14 * w26) + w15 * (c5 * ((w11 * w24 + w10 * w25) / w12)) + w17 * (c7 * w26)
    dQ_hat_dq_i_dot = ca.vertcat(
        w16 - w17 * (w14 * w5 - w2 * w8 - c7 * w13) + ((w22 + w17 * (c7 * w21)) * w17 - w27 * w15),
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 168 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    w0 = ca.sin(crank_theta)
    w1 = w0 * c0
    w2 = ca.cos(crank_theta)
    w3 = c0 * w2
    w4 = crank_theta_ddot * w3
    w5 = ca.sin(coupler_theta)
    w6 = w5 * c6
    w7 = ca.sin(rocker_theta)
    w8 = w7 * c4
    w9 = c0 * w0
    w10 = ca.cos(rocker_theta)
    w11 = w10 * c4
    w12 = w5 * c3
    w13 = ca.cos(coupler_theta)
    w14 = w13 * c3
    w15 = w12 * w11 - w8 * w14
    w16 = (w8 * w9 + w11 * w3) / w15
    w17 = crank_theta_ddot * w16
    w18 = w1 * crank_theta_ddot
    w19 = w2 * c0
    w20 = (w8 * w19 - w11 * w1) / w15
    w21 = w20 * crank_theta_ddot
    w22 = crank_theta_ddot * w9
    w23 = w13 * c6
    w24 = w19 * crank_theta_ddot
    w25 = w1 * (c1 * w4 - w6 * w17) + (c1 * w18 + w6 * w21) * w3 - (w19 * (c1 * w22 + w23 * w17) + (c1 * w24 + w23 * w21) * w9)
    w26 = (w12 * w19 - w14 * w1) / w15
    w27 = (w12 * w9 + w14 * w3) / w15
    w28 = c5 * (w26 * crank_theta_ddot)
    w29 = w6 * w18 + w23 * w24 + c7 * w21
    w30 = w25 - (w26 * (c5 * (crank_theta_ddot * w27)) + w28 * w27) + (w20 * (w6 * w4 - w23 * w22 - c7 * w17) - w29 * w16)
    w31 = c6 * w13
    w32 = w20 / w15
    w33 = c3 * w13
    w34 = c3 * w5
    w35 = w11 * w33 + w8 * w34
    w36 = w32 * w35
    w37 = crank_theta_ddot * w36
    w38 = c6 * w5
    w39 = w26 / w15
    w40 = (w19 * w33 + w1 * w34) / w15 - w39 * w35
    w41 = w1 * (w21 * w31 - w6 * w37) - w19 * (w21 * w38 + w23 * w37) + (w26 * (c5 * (crank_theta_ddot * w40)) + w28 * w40)
    w42 = c4 * w10
    w43 = c4 * w7
    w44 = w12 * w43 + w14 * w42
    w45 = (w19 * w42 + w1 * w43) / w15 + w32 * w44
    w46 = crank_theta_ddot * w45
    w47 = w39 * w44
    w48 = w19 * (w23 * w46) + w1 * (w6 * w46) + (w26 * (c5 * (crank_theta_ddot * w47)) + w28 * w47) + (w20 * (c7 * w46) + w29 * w45)
    dMa_dq_i = ca.vertcat(
        w30 + ((w41 + (w20 * (w18 * w31 - w24 * w38 - c7 * w37) - w29 * w36)) * w20 + w48 * w26),
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


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
    "drawing": drawing,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
}
