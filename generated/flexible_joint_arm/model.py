"""Manipulator with flexible joints: equations of motion, emitted by symgen from the scene `flexible_joint_arm`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 82 operations."""
    p = ca.SX.sym("p", 17)
    shoulder_torque = p[0]
    elbow_torque = p[1]
    gravity_y = p[2]
    link1_mass = p[3]
    link1_inertia = p[4]
    link1_center_of_mass_x = p[5]
    rotor1_mass = p[6]
    rotor1_inertia = p[7]
    link2_mass = p[8]
    link2_inertia = p[9]
    link2_center_of_mass_x = p[10]
    rotor2_mass = p[11]
    rotor2_inertia = p[12]
    link1_tip_x = p[13]
    gear1_stiffness = p[14]
    gear2_stiffness = p[15]
    w0 = link1_tip_x * rotor2_mass
    w1 = link1_tip_x * link2_mass
    w2 = link2_mass * link2_center_of_mass_x
    w3 = link1_mass * link1_center_of_mass_x
    w4 = w3 * gravity_y
    w5 = link1_tip_x**2
    c = ca.vertcat(
        rotor1_inertia,
        rotor2_inertia,
        gear1_stiffness,
        elbow_torque,
        shoulder_torque,
        gear2_stiffness,
        link1_inertia + link1_center_of_mass_x * w3 + rotor2_mass * w5 + link2_mass * w5,
        w1 * link2_center_of_mass_x,
        link2_inertia + link2_center_of_mass_x * w2,
        w4 + w0 * gravity_y + w1 * gravity_y,
        w2 * gravity_y,
        link1_tip_x,
        link1_mass,
        link1_inertia + link1_mass * link1_center_of_mass_x**2,
        rotor2_mass,
        link2_mass,
        w2,
        link2_inertia + link2_mass * link2_center_of_mass_x**2,
        w3,
        gravity_y,
        rotor2_mass * gravity_y,
        link2_mass * gravity_y,
        rotor1_mass,
        link1_mass * gravity_y,
        gravity_y * rotor1_mass,
        -gear1_stiffness,
        -gear2_stiffness,
        link2_center_of_mass_x * (link2_mass * (2 * link1_tip_x)),
        link1_tip_x * w0,
        w4,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 75 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
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
    w0 = ca.sin(t * 6.283185307179586) * c3
    w1 = link2_theta - link1_theta
    w2 = ca.cos(w1) * c7
    w3 = link1_theta * c2
    w4 = rotor1_theta * c2
    w5 = ca.sin(w1) * c7
    w6 = link2_theta * c5
    w7 = rotor2_theta * c5
    M_hat = ca.vertcat(
        c6,
        0.0,
        w2,
        0.0,
        0.0,
        c0,
        0.0,
        0.0,
        w2,
        0.0,
        c8,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
    )
    M_hat = ca.reshape(M_hat, 4, 4)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        link2_theta_dot**2 * w5 + (ca.cos(link1_theta) * c9 + w4) - w3 - w0,
        ca.sin(t * 3.141592653589793) * c4 + w3 - w4,
        ca.cos(link2_theta) * c10 + w7 - w6 - link1_theta_dot**2 * w5,
        w0 + w6 - w7,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, t, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 15 operations."""
    q_i = ca.SX.sym("q_i", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    c11 = c[11]
    w0 = ca.cos(link1_theta) * c11
    w1 = ca.sin(link1_theta) * c11
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w0,
        w1,
        w0,
        w1,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 19 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    link1_theta_dot = q_i_dot[0]
    c11 = c[11]
    w0 = -(ca.sin(link1_theta) * c11 * link1_theta_dot)
    w1 = link1_theta_dot * (ca.cos(link1_theta) * c11)
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w0,
        w1,
        w0,
        w1,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 25 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    link1_theta_dot = q_i_dot[0]
    link1_theta_ddot = q_i_ddot[0]
    c11 = c[11]
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c11
    w2 = ca.sin(link1_theta) * c11
    w3 = -(w0 * w1 + w2 * link1_theta_ddot)
    w4 = w1 * link1_theta_ddot - w0 * w2
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w3,
        w4,
        w3,
        w4,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 158 operations."""
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    c = ca.SX.sym("c", 30)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_x = q[3]
    rotor1_y = q[4]
    link2_x = q[6]
    link2_y = q[7]
    rotor2_x = q[9]
    rotor2_y = q[10]
    link1_theta_dot = q_dot[2]
    c11 = c[11]
    w0 = ca.cos(link1_theta) * c11
    w1 = link1_x + w0
    w2 = ca.sin(link1_theta) * c11
    w3 = link1_y + w2
    w4 = -w0
    w5 = link1_theta_dot**2
    w6 = -(w0 * w5)
    w7 = -(w2 * w5)
    C = ca.vertcat(
        link1_x,
        link1_y,
        rotor1_x,
        rotor1_y,
        link2_x - w1,
        link2_y - w3,
        rotor2_x - w1,
        rotor2_y - w3,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        w2,
        w4,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
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
        1.0,
        0.0,
        0.0,
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
        1.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 12)
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
        0.0,
        0.0,
        w6,
        w7,
        w6,
        w7,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 502 operations."""
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_theta = q[2]
    rotor1_theta = q[5]
    link2_theta = q[8]
    rotor2_theta = q[11]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[8]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    w0 = ca.sin(link1_theta)
    w1 = w0 * c18
    w2 = -w1
    w3 = ca.cos(link1_theta)
    w4 = w3 * c18
    w5 = ca.sin(link2_theta) * c16
    w6 = -w5
    w7 = ca.cos(link2_theta) * c16
    w8 = link1_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = link2_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = (link1_theta - rotor1_theta) * c2
    w15 = ca.sin(t * 6.283185307179586) * c3
    w16 = w4 * c19 - w14 - w15
    w17 = w14 + ca.sin(t * 3.141592653589793) * c4
    w18 = (link2_theta - rotor2_theta) * c5
    w19 = w7 * c19 - w18
    w20 = w15 + w18
    w21 = w0 * c11
    w22 = w3 * c11
    w23 = -w22
    w24 = -(w8 * w22)
    w25 = -(w8 * w21)
    M = ca.vertcat(
        c12,
        0.0,
        w2,
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
        c12,
        w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        c13,
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
        c22,
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
        c22,
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
        0.0,
        0.0,
        0.0,
        c15,
        0.0,
        w6,
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
        c15,
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w6,
        w7,
        c17,
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
        c14,
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
        c14,
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
        c1,
    )
    M = ca.reshape(M, 12, 12)
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
    K = ca.reshape(K, 12, 12)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w9,
        w10,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w13,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c23,
        w16,
        0.0,
        c24,
        w17,
        0.0,
        c21,
        w19,
        0.0,
        c20,
        w20,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w9,
        w10 + c23,
        w16,
        0.0,
        c24,
        w17,
        w12,
        c21 + w13,
        w19,
        0.0,
        c20,
        w20,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w21,
        w23,
        w21,
        w23,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
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
        1.0,
        0.0,
        0.0,
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
        1.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 12)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w24,
        w25,
        w24,
        w25,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, t, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 95 operations."""
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    q_ddot = ca.SX.sym("q_ddot", 12)
    c = ca.SX.sym("c", 30)
    link1_theta = q[2]
    link2_theta = q[8]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[8]
    link1_x_ddot = q_ddot[0]
    link1_y_ddot = q_ddot[1]
    link1_theta_ddot = q_ddot[2]
    rotor1_x_ddot = q_ddot[3]
    rotor1_y_ddot = q_ddot[4]
    link2_x_ddot = q_ddot[6]
    link2_y_ddot = q_ddot[7]
    link2_theta_ddot = q_ddot[8]
    rotor2_x_ddot = q_ddot[9]
    rotor2_y_ddot = q_ddot[10]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c18
    w2 = ca.sin(link1_theta) * c18
    w3 = rotor2_x_ddot * c14
    w4 = link2_theta_dot**2
    w5 = ca.cos(link2_theta) * c16
    w6 = ca.sin(link2_theta) * c16
    w7 = w4 * w5 - (link2_x_ddot * c15 - w6 * link2_theta_ddot)
    w8 = w0 * w1 - (link1_x_ddot * c12 - w2 * link1_theta_ddot) - w3 + w7
    w9 = c20 - rotor2_y_ddot * c14
    w10 = c21 + w4 * w6 - (link2_y_ddot * c15 + w5 * link2_theta_ddot)
    w11 = c23 + w0 * w2 - (link1_y_ddot * c12 + w1 * link1_theta_ddot) + w9 + w10
    w12 = rotor1_x_ddot * c22
    w13 = c24 - rotor1_y_ddot * c22
    lam = ca.vertcat(
        w8,
        w11,
        -w12,
        w13,
        w7,
        w10,
        -w3,
        w9,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w8,
        -w11,
        0.0,
        w12,
        -w13,
        0.0,
        -w7,
        -w10,
        0.0,
        w3,
        -w9,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 4)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 138 operations."""
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_y = q[4]
    rotor1_theta = q[5]
    link2_y = q[7]
    link2_theta = q[8]
    rotor2_y = q[10]
    rotor2_theta = q[11]
    link1_x_dot = q_dot[0]
    link1_y_dot = q_dot[1]
    link1_theta_dot = q_dot[2]
    rotor1_x_dot = q_dot[3]
    rotor1_y_dot = q_dot[4]
    rotor1_theta_dot = q_dot[5]
    link2_x_dot = q_dot[6]
    link2_y_dot = q_dot[7]
    link2_theta_dot = q_dot[8]
    rotor2_x_dot = q_dot[9]
    rotor2_y_dot = q_dot[10]
    rotor2_theta_dot = q_dot[11]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c24 = c[24]
    w0 = ca.sin(link1_theta) * c18
    w1 = ca.cos(link1_theta) * c18
    w2 = link1_x_dot * (link1_x_dot * c12 - w0 * link1_theta_dot) + link1_y_dot * (link1_y_dot * c12 + link1_theta_dot * w1)
    w3 = w2 + link1_theta_dot * (link1_y_dot * w1 - link1_x_dot * w0 + link1_theta_dot * c13) + rotor1_x_dot * (rotor1_x_dot * c22)
    w4 = ca.sin(link2_theta) * c16
    w5 = w3 + rotor1_y_dot * (rotor1_y_dot * c22) + rotor1_theta_dot * (rotor1_theta_dot * c0) + link2_x_dot * (link2_x_dot * c15 - w4 * link2_theta_dot)
    w6 = ca.cos(link2_theta) * c16
    w7 = w5 + link2_y_dot * (link2_y_dot * c15 + link2_theta_dot * w6) + link2_theta_dot * (link2_y_dot * w6 - link2_x_dot * w4 + link2_theta_dot * c17)
    w8 = w7 + rotor2_x_dot * (rotor2_x_dot * c14) + rotor2_y_dot * (rotor2_y_dot * c14) + rotor2_theta_dot * (rotor2_theta_dot * c1)
    w9 = rotor1_theta_dot * (ca.sin(t * 3.141592653589793) * c4) + ca.sin(t * 6.283185307179586) * c3 * (rotor2_theta_dot - link1_theta_dot)
    kinetic = ca.vertcat(
        w8 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (link1_theta - rotor1_theta)**2 * c2 / 2.0 + (link2_theta - rotor2_theta)**2 * c5 / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -((w0 + link1_y * c12) * c19 + rotor1_y * c24 + (w4 + link2_y * c15) * c19 + rotor2_y * c20),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        w9,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, t, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 74 operations."""
    q = ca.SX.sym("q", 12)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_x = q[3]
    rotor1_y = q[4]
    rotor1_theta = q[5]
    link2_x = q[6]
    link2_y = q[7]
    link2_theta = q[8]
    rotor2_x = q[9]
    rotor2_y = q[10]
    rotor2_theta = q[11]
    w0 = ca.cos(link1_theta)
    w1 = ca.sin(link1_theta)
    w2 = ca.cos(rotor1_theta)
    w3 = ca.sin(rotor1_theta)
    w4 = ca.cos(link2_theta)
    w5 = ca.sin(link2_theta)
    w6 = ca.cos(rotor2_theta)
    w7 = ca.sin(rotor2_theta)
    poses = ca.vertcat(
        link1_x,
        link1_y,
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
        rotor1_x,
        rotor1_y,
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
        link2_x,
        link2_y,
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
        rotor2_x,
        rotor2_y,
        0.0,
        w6,
        w7,
        0.0,
        -w7,
        w6,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    poses = ca.reshape(poses, 12, 4)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 43 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    c2 = c[2]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c25 = c[25]
    c26 = c[26]
    w0 = ca.cos(link2_theta - link1_theta) * c7
    w1 = link2_theta_dot**2 * w0
    w2 = link1_theta_dot**2 * w0
    dQ_hat_dq_i = ca.vertcat(
        c25 - ca.sin(link1_theta) * c9 - w1,
        c2,
        w2,
        0.0,
        c2,
        c25,
        0.0,
        0.0,
        w1,
        0.0,
        c26 - w2 - ca.sin(link2_theta) * c10,
        c5,
        0.0,
        0.0,
        c5,
        c26,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 4, 4)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 28 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    c27 = c[27]
    w0 = ca.sin(link2_theta - link1_theta) * c27
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
        0.0,
        -(link1_theta_dot * w0),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link2_theta_dot * w0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 4, 4)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 29 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_ddot = q_i_ddot[0]
    link2_theta_ddot = q_i_ddot[2]
    c7 = c[7]
    w0 = ca.sin(link2_theta - link1_theta) * c7
    w1 = link2_theta_ddot * w0
    w2 = link1_theta_ddot * w0
    dMa_dq_i = ca.vertcat(
        w1,
        0.0,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w1,
        0.0,
        -w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 4, 4)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 115 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c28 = c[28]
    c29 = c[29]
    w0 = ca.cos(link1_theta)
    w1 = (link1_theta - rotor1_theta) * c2
    w2 = ca.sin(t * 6.283185307179586) * c3
    w3 = w0 * c11
    w4 = link2_theta_dot**2
    w5 = ca.sin(link2_theta) * c16
    w6 = ca.cos(link2_theta) * c16
    w7 = w6 / c17
    w8 = (link2_theta - rotor2_theta) * c5
    w9 = w6 * c19 - w8
    w10 = c15 - w6 * w7
    w11 = link1_theta_dot**2
    w12 = ca.sin(link1_theta) * c11
    w13 = w11 * w12
    w14 = w5 / c17
    w15 = w6 * w14
    w16 = w3 * w15
    w17 = w3 * w11
    w18 = c15 - w5 * w14
    w19 = w0 * c29 - w1 - w2 + w3 * (c21 + w4 * w5 - w7 * w9 + w10 * w13) + w16 * w17 - w12 * (w4 * w6 + w9 * w14 + w13 * w15 + w17 * w18)
    w20 = (w19 + w3 * (c20 + w13 * c14) - w12 * (w17 * c14)) / (c28 + (c13 + w3 * (w3 * w10) - (w12 * (w16 - w12 * w18) + w12 * w16)))
    q_i_ddot = ca.vertcat(
        w20,
        (w1 + ca.sin(t * 3.141592653589793) * c4) / c0,
        (w9 - (w5 * (w17 + w12 * w20) + w6 * (w3 * w20 - w13))) / c17,
        (w2 + w8) / c1,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, t, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 75 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
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
    w0 = ca.sin(t * 6.283185307179586) * c3
    w1 = link2_theta - link1_theta
    w2 = ca.cos(w1) * c7
    w3 = link1_theta * c2
    w4 = rotor1_theta * c2
    w5 = ca.sin(w1) * c7
    w6 = link2_theta * c5
    w7 = rotor2_theta * c5
    M_hat_LL = ca.vertcat(
        c6,
        w2,
        w2,
        c8,
    )
    M_hat_LL = ca.reshape(M_hat_LL, 2, 2)
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
    )
    M_hat_LS = ca.reshape(M_hat_LS, 2, 2)
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
    )
    M_hat_SL = ca.reshape(M_hat_SL, 2, 2)
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c0,
        0.0,
        0.0,
        c1,
    )
    M_hat_SS = ca.reshape(M_hat_SS, 2, 2)
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        link2_theta_dot**2 * w5 + (ca.cos(link1_theta) * c9 + w4) - w3 - w0,
        ca.cos(link2_theta) * c10 + w7 - w6 - link1_theta_dot**2 * w5,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        ca.sin(t * 3.141592653589793) * c4 + w3 - w4,
        w0 + w6 - w7,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_i_dot, t, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 32 operations."""
    q_i = ca.SX.sym("q_i", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 30)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    M_hat_SS = ca.vertcat(
        c0,
        0.0,
        0.0,
        c1,
    )
    M_hat_SS = ca.reshape(M_hat_SS, 2, 2)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        (link1_theta - rotor1_theta) * c2 + ca.sin(t * 3.141592653589793) * c4,
        (link2_theta - rotor2_theta) * c5 + ca.sin(t * 6.283185307179586) * c3,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, t, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "t", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 88 operations."""
    p = ca.SX.sym("p", 17)
    link1_tip_x = p[13]
    link2_tip_x = p[16]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link1_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link2_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 7)
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
    )
    axes = ca.reshape(axes, 9, 7)
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
    "forward_dynamics": forward_dynamics,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
