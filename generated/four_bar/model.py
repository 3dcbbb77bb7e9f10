"""Four-bar linkage: equations of motion, emitted by symgen from the scene `four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 76 operations."""
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
    w0 = crank_inertia + crank_mass * crank_center_of_mass_x**2
    w1 = crank_tip_x * coupler_mass
    w2 = rocker_inertia + rocker_mass * rocker_center_of_mass_x**2
    w3 = coupler_mass * coupler_center_of_mass_x
    w4 = crank_mass * crank_center_of_mass_x
    w5 = rocker_mass * rocker_center_of_mass_x
    c = ca.vertcat(
        crank_tip_x,
        coupler_mass,
        w0 + crank_tip_x * w1,
        coupler_tip_x,
        rocker_tip_x,
        w2,
        w3,
        coupler_inertia + coupler_mass * coupler_center_of_mass_x**2,
        gravity_y,
        w4 * gravity_y,
        motor_value,
        coupler_mass * gravity_y,
        gravity_y * w5,
        ground_right_x,
        crank_mass,
        w0,
        rocker_mass,
        w4,
        w5,
        crank_mass * gravity_y,
        rocker_mass * gravity_y,
        coupler_tip_x * (2 * coupler_tip_x),
        rocker_tip_x * (2 * rocker_tip_x),
        coupler_inertia + coupler_center_of_mass_x * w3,
        rocker_inertia + rocker_center_of_mass_x * w5,
        coupler_center_of_mass_x * (coupler_mass * (2 * crank_tip_x)),
        w1 * coupler_center_of_mass_x,
        w2 + w2,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 110 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 28)
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
    w10 = w4 * w8 - w6 * w9
    w11 = (w1 * w4 - w2 * w6) / w10
    w12 = (w1 * w9 - w2 * w8) / w10
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
    w24 = w0 * c9 + c10 + w1 * (w14 * w16 + c11 - (w13 * w23 - w21 * c1)) - w2 * (w13 * w16 + (w19 * c1 + w14 * w23))
    w25 = w24 + w11 * (w7 * c12 - (w6 * w20 + w4 * w22) / w10 * c5) + w12 * (w13 * c8 - (w14 * w19 - w13 * w21 + w23 * c7))
    M_hat = ca.vertcat(
        c2 + w11 * (w11 * c5) + (w12 * (w15 + w12 * c7) + w12 * w15),
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w25,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 49 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 28)
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
    w4 = w2 + c13 - (w0 + w3)
    w5 = ca.sin(rocker_theta) * c4
    w6 = ca.sin(coupler_theta) * c3
    w7 = w5 - (w1 + w6)
    w8 = w2 * w6 - w3 * w5
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
    det_loop = ca.vertcat(
        w8,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 44 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 28)
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
    w6 = w3 * w4 - w2 * w5
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -(w0 * crank_theta_dot),
        crank_theta_dot * w1,
        crank_theta_dot * ((w1 * w2 - w0 * w3) / w6),
        0.0,
        0.0,
        crank_theta_dot * ((w1 * w4 - w0 * w5) / w6),
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
    c = ca.SX.sym("c", 28)
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
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c0
    w2 = w0 * w1
    w3 = ca.sin(crank_theta) * c0
    w4 = w0 * w3
    w5 = ca.cos(rocker_theta) * c4
    w6 = rocker_theta_dot**2
    w7 = coupler_theta_dot**2
    w8 = ca.cos(coupler_theta) * c3
    w9 = w5 * w6 - w7 * w8 - w2
    w10 = ca.sin(rocker_theta) * c4
    w11 = ca.sin(coupler_theta) * c3
    w12 = w6 * w10 - w7 * w11 - w4
    w13 = w5 * w11 - w8 * w10
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -(w2 + w3 * crank_theta_ddot),
        w1 * crank_theta_ddot - w4,
        (w5 * w9 + w10 * w12) / w13 + crank_theta_ddot * ((w1 * w10 - w3 * w5) / w13),
        0.0,
        0.0,
        (w8 * w9 + w11 * w12) / w13 + crank_theta_ddot * ((w1 * w11 - w3 * w8) / w13),
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 162 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 28)
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
        -(w0 * w6),
        -(w1 * w6),
        w2 * w7 - w3 * w8,
        w4 * w7 - w5 * w8,
        0.0,
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 345 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 28)
    crank_theta = q[2]
    coupler_theta = q[5]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c11 = c[11]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    w0 = ca.sin(crank_theta)
    w1 = w0 * c17
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c17
    w5 = ca.sin(coupler_theta)
    w6 = w5 * c6
    w7 = -w6
    w8 = ca.cos(coupler_theta)
    w9 = w8 * c6
    w10 = ca.sin(rocker_theta)
    w11 = w10 * c18
    w12 = -w11
    w13 = ca.cos(rocker_theta)
    w14 = w13 * c18
    w15 = crank_theta_dot**2
    w16 = w4 * w15
    w17 = w1 * w15
    w18 = coupler_theta_dot**2
    w19 = w9 * w18
    w20 = w6 * w18
    w21 = rocker_theta_dot**2
    w22 = w14 * w21
    w23 = w11 * w21
    w24 = c10 + w4 * c8
    w25 = w9 * c8
    w26 = w14 * c8
    w27 = w0 * c0
    w28 = w3 * c0
    w29 = w5 * c3
    w30 = w8 * c3
    w31 = w10 * c4
    w32 = w13 * c4
    M = ca.vertcat(
        c14,
        0.0,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c14,
        w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        c15,
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
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
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
        c16,
        0.0,
        w12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c16,
        w14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w14,
        c5,
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
        w16,
        w17,
        0.0,
        w19,
        w20,
        0.0,
        w22,
        w23,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c19,
        w24,
        0.0,
        c11,
        w25,
        0.0,
        c20,
        w26,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w16,
        w17 + c19,
        w24,
        w19,
        c11 + w20,
        w25,
        w22,
        w23 + c20,
        w26,
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
        w27,
        -w28,
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
        w29,
        -w30,
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
        -w31,
        w32,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 9)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w15 * w28),
        -(w15 * w27),
        w21 * w32 - w18 * w30,
        w21 * w31 - w18 * w29,
        0.0,
        0.0,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 141 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 28)
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
    c11 = c[11]
    c14 = c[14]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c17
    w2 = ca.sin(crank_theta) * c17
    w3 = coupler_theta_dot**2
    w4 = ca.cos(coupler_theta)
    w5 = w4 * c6
    w6 = ca.sin(coupler_theta)
    w7 = w6 * c6
    w8 = ca.cos(rocker_theta)
    w9 = w8 * c4
    w10 = w5 * c8 - (w5 * coupler_y_ddot - coupler_x_ddot * w7 + coupler_theta_ddot * c7)
    w11 = w4 * c3
    w12 = w8 * c18
    w13 = ca.sin(rocker_theta)
    w14 = w13 * c18
    w15 = w12 * c8 - (w12 * rocker_y_ddot - w14 * rocker_x_ddot + rocker_theta_ddot * c5)
    w16 = w6 * c3
    w17 = w13 * c4
    w18 = w9 * w16 - w11 * w17
    w19 = (w9 * w10 + w11 * w15) / w18
    w20 = w3 * w5 - (coupler_x_ddot * c1 - w7 * coupler_theta_ddot) + w19
    w21 = w0 * w1 - (crank_x_ddot * c14 - w2 * crank_theta_ddot) + w20
    w22 = (w10 * w17 + w15 * w16) / w18
    w23 = c11 + w3 * w7 - (coupler_y_ddot * c1 + w5 * coupler_theta_ddot) + w22
    w24 = c19 + w0 * w2 - (crank_y_ddot * c14 + w1 * crank_theta_ddot) + w23
    w25 = rocker_theta_dot**2
    w26 = w12 * w25 - (rocker_x_ddot * c16 - w14 * rocker_theta_ddot) - w19
    w27 = c20 + w14 * w25 - (rocker_y_ddot * c16 + w12 * rocker_theta_ddot) - w22
    lam = ca.vertcat(
        w21,
        w24,
        w20,
        w23,
        w19,
        w22,
        w26,
        w27,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w21,
        -w24,
        0.0,
        -w20,
        -w23,
        0.0,
        -w19,
        -w22,
        0.0,
        -w26,
        -w27,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 4)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 109 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 28)
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
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    w0 = ca.sin(crank_theta) * c17
    w1 = ca.cos(crank_theta) * c17
    w2 = crank_x_dot * (crank_x_dot * c14 - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * c14 + crank_theta_dot * w1)
    w3 = ca.sin(coupler_theta) * c6
    w4 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c15) + coupler_x_dot * (coupler_x_dot * c1 - w3 * coupler_theta_dot)
    w5 = ca.cos(coupler_theta) * c6
    w6 = w4 + coupler_y_dot * (coupler_y_dot * c1 + coupler_theta_dot * w5) + coupler_theta_dot * (coupler_y_dot * w5 - coupler_x_dot * w3 + coupler_theta_dot * c7)
    w7 = ca.sin(rocker_theta) * c18
    w8 = ca.cos(rocker_theta) * c18
    w9 = w6 + rocker_x_dot * (rocker_x_dot * c16 - w7 * rocker_theta_dot) + rocker_y_dot * (rocker_y_dot * c16 + rocker_theta_dot * w8)
    kinetic = ca.vertcat(
        (w9 + rocker_theta_dot * (rocker_y_dot * w8 - rocker_x_dot * w7 + rocker_theta_dot * c5)) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -((w0 + crank_y * c14) * c8 + (w3 + coupler_y * c1) * c8 + (w7 + rocker_y * c16) * c8),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        crank_theta_dot * c10,
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
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[6]
    rocker_y = q[7]
    rocker_theta = q[8]
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(coupler_theta)
    w3 = ca.sin(coupler_theta)
    w4 = ca.cos(rocker_theta)
    w5 = ca.sin(rocker_theta)
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
        coupler_x,
        coupler_y,
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
        rocker_x,
        rocker_y,
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
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 276 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 28)
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
    c21 = c[21]
    c22 = c[22]
    w0 = ca.cos(crank_theta) * c0
    w1 = coupler_theta_dot**2
    w2 = ca.cos(coupler_theta)
    w3 = w2 * c6
    w4 = w1 * w3
    w5 = ca.cos(rocker_theta)
    w6 = w5 * c4
    w7 = ca.sin(coupler_theta)
    w8 = w7 * c3
    w9 = w1 * w8
    w10 = ca.sin(rocker_theta)
    w11 = w10 * c4
    w12 = w2 * c3
    w13 = w1 * w12
    w14 = w6 * w8 - w11 * w12
    w15 = rocker_theta_dot**2
    w16 = w6 * w15
    w17 = crank_theta_dot**2
    w18 = w0 * w17
    w19 = w16 - w13 - w18
    w20 = w11 * w15
    w21 = ca.sin(crank_theta)
    w22 = w21 * c0
    w23 = w17 * w22
    w24 = w20 - w9 - w23
    w25 = (w6 * w19 + w11 * w24) / w14
    w26 = w6 * w12 + w8 * w11
    w27 = w25 / w14 * w26
    w28 = (w6 * w9 - w11 * w13) / w14 - w27
    w29 = w7 * c6
    w30 = w25 * w29
    w31 = w3 * w25
    w32 = w1 * w29
    w33 = (w12 * w19 + w8 * w24) / w14
    w34 = w5 * c12 - w33 * c5
    w35 = (w0 * w12 + w8 * w22) / w14
    w36 = (w0 * w8 - w12 * w22) / w14
    w37 = w26 * (w36 / w14)
    w38 = w35 - w37
    w39 = w26 * (w33 / w14)
    w40 = w0 * (w4 - (w3 * w28 - w30)) - w22 * (w31 + w28 * w29 - w32) + (w34 * w38 - w36 * (((w9 * w12 - w8 * w19 + (w12 * w24 - w8 * w13)) / w14 - w39) * c5))
    w41 = (w0 * w11 - w6 * w22) / w14
    w42 = w3 * w18 + w23 * w29
    w43 = w3 * c8 - (w18 * w29 - w3 * w23 + w25 * c7)
    w44 = w26 * (w41 / w14)
    w45 = w27 + (w6 * w24 + w11 * w16 - (w11 * w19 + w6 * w20)) / w14
    w46 = w34 * w37 - w36 * (w10 * c12 + (w39 + (w8 * w16 - w12 * w20) / w14) * c5) - (w0 * (w3 * w45) + w22 * (w29 * w45))
    w47 = (w0 * w6 + w11 * w22) / w14
    w48 = w44 + w47
    w49 = w41 * (w40 - (w41 * (w29 * c8 + (w42 + w28 * c7)) + w43 * w44)) + w36 * (w46 + (w43 * w48 - w41 * (w45 * c7)))
    w50 = (w6 * w23 - w11 * w18) / w14
    w51 = w18 * c1
    w52 = w23 * c1
    w53 = w21 * c9 + (w0 * (w3 * w50 - w51) + w22 * (c11 + w32 - (w31 - w52))) + (w22 * (w29 * w50 - w52) + w0 * (w4 + (w30 + w51)))
    w54 = w53 + (w36 * ((w12 * w23 - w8 * w18) / w14 * c5) + w34 * w35) + (w41 * (w50 * c7 - w42) + w43 * w47)
    w55 = 2 * coupler_theta_dot
    w56 = (w6 * (w12 * w55) + w11 * (w8 * w55)) / w14
    w57 = w0 * (w29 * w55 + w3 * w56) - w22 * (w3 * w55 - w29 * w56) + w36 * (coupler_theta_dot * c21 / w14 * c5)
    w58 = (w57 + w41 * (w56 * c7)) * (w36 * (crank_theta_dot * w48) - w41 * (crank_theta_dot * w44) - crank_theta_dot * w47)
    w59 = 2 * rocker_theta_dot
    w60 = rocker_theta_dot * c22 / w14
    w61 = w0 * (w3 * w60) + w22 * (w29 * w60) + w36 * ((w12 * (w6 * w59) + w8 * (w11 * w59)) / w14 * c5) + w41 * (w60 * c7)
    w62 = w58 - w61 * (w41 * (crank_theta_dot * w38) + w36 * (crank_theta_dot * w37) - crank_theta_dot * w35)
    dQ_hat_dq_i = ca.vertcat(
        w49 - w54 + w62,
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 78 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 28)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(rocker_theta) * c4
    w2 = ca.cos(rocker_theta) * c4
    w3 = ca.sin(crank_theta) * c0
    w4 = ca.sin(coupler_theta) * c3
    w5 = ca.cos(coupler_theta) * c3
    w6 = w2 * w4 - w1 * w5
    w7 = (w0 * w1 - w2 * w3) / w6
    w8 = w7 * crank_theta_dot
    w9 = w7 * (2 * w8)
    w10 = (w0 * w4 - w3 * w5) / w6
    w11 = w10 * (2 * (crank_theta_dot * w10))
    w12 = 2 * crank_theta_dot
    w13 = w2 * w11 - w5 * w9 - w0 * w12
    w14 = w1 * w11 - w4 * w9 - w3 * w12
    w15 = (w2 * w13 + w1 * w14) / w6
    w16 = coupler_theta - crank_theta
    w17 = ca.sin(w16) * c25
    w18 = w17 * (crank_theta_dot * w7**2) - w8 * w17 - w7 * w15 * c23 - w10 * ((w5 * w13 + w4 * w14) / w6) * c24
    dQ_hat_dq_i_dot = ca.vertcat(
        w18 - w15 * (ca.cos(w16) * c26),
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 130 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 28)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c6 = c[6]
    c7 = c[7]
    c27 = c[27]
    w0 = ca.sin(crank_theta) * c0
    w1 = ca.cos(crank_theta) * c0
    w2 = crank_theta_ddot * w1
    w3 = w2 * c1
    w4 = ca.sin(coupler_theta)
    w5 = w4 * c6
    w6 = ca.sin(rocker_theta) * c4
    w7 = ca.cos(rocker_theta) * c4
    w8 = w4 * c3
    w9 = ca.cos(coupler_theta)
    w10 = w9 * c3
    w11 = w7 * w8 - w6 * w10
    w12 = (w0 * w6 + w1 * w7) / w11
    w13 = crank_theta_ddot * w12
    w14 = w0 * crank_theta_ddot
    w15 = w14 * c1
    w16 = (w1 * w6 - w0 * w7) / w11
    w17 = crank_theta_ddot * w16
    w18 = w5 * w17
    w19 = w9 * c6
    w20 = w17 * w19
    w21 = (w1 * w8 - w0 * w10) / w11
    w22 = (w0 * w8 + w1 * w10) / w11
    w23 = crank_theta_ddot * w21
    w24 = w0 * (w3 - w5 * w13) + w1 * (w15 + w18) - (w1 * (w15 + w13 * w19) + w0 * (w3 + w20)) - w22 * w23 * c27
    w25 = w2 * w5
    w26 = w14 * w19
    w27 = w5 * w14 + w2 * w19 + w17 * c7
    w28 = w7 * w10 + w6 * w8
    w29 = w16 / w11 * w28
    w30 = crank_theta_ddot * w29
    w31 = w21 / w11
    w32 = w0 * (w20 - w5 * w30) - w1 * (w18 + w19 * w30) + w23 * (w22 - w28 * w31) * c27 + (w16 * (w26 - w25 - w30 * c7) - w27 * w29)
    w33 = w12 + w29
    w34 = crank_theta_ddot * w33
    w35 = w21 * (w1 * (w19 * w34) + w0 * (w5 * w34) + w31 * (w23 * w28) * c27 + (w16 * (w34 * c7) + w27 * w33))
    dMa_dq_i = ca.vertcat(
        w24 + (w16 * (w25 - w26 - w13 * c7) - w12 * w27) + (w16 * w32 + w35),
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 102 operations."""
    p = ca.SX.sym("p", 15)
    crank_tip_x = p[10]
    coupler_tip_x = p[11]
    rocker_tip_x = p[12]
    ground_right_x = p[13]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        ground_right_x,
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
        coupler_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        rocker_tip_x,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 8)
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
    axes = ca.reshape(axes, 9, 8)
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
