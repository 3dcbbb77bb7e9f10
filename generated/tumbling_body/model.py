"""Free body turning over: equations of motion, emitted by symgen from the scene `tumbling_body`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 58 operations."""
    p = ca.SX.sym("p", 6)
    body_mass = p[0]
    body_inertia_xx = p[1]
    body_inertia_yy = p[2]
    body_inertia_zz = p[3]
    w0 = (body_inertia_xx + body_inertia_yy + body_inertia_zz) / 2.0
    w1 = w0 - body_inertia_yy
    w2 = w0 - body_inertia_zz
    w3 = w1 + w2
    w4 = w0 - body_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = -4.0 * w6
    w8 = -4.0 * w5
    c = ca.vertcat(
        body_mass,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        4.0 * w5 + w7,
        4.0 * w3 + w8,
        4.0 * w6 + -4.0 * w3,
        4.0 * w6 + -4.0 * w3,
        4.0 * w3 + w8,
        w7 + 4.0 * w5,
        2 * w3,
        -2.0 * w5,
        2 * w6,
        -2.0 * w3,
        -2.0 * w6,
        2 * w5,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 236 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
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
    w0 = 2 * body_e0
    w1 = w0 * c3
    w2 = body_e3 * -2.0
    w3 = 2 * body_e2
    w4 = body_e1 / body_e0
    w5 = body_e1 * -2.0
    w6 = body_e2 * -2.0
    w7 = w1 * w5 + body_e3 * body_e2 * c7
    w8 = w5 * (w5 * c3) + w6 * (w6 * c5) + w2 * (w2 * c6)
    w9 = 2 * body_e3
    w10 = w0 * c5
    w11 = w5 * c6
    w12 = w6 * w10 + body_e3 * body_e1 * c9
    w13 = body_e2 / body_e0
    w14 = w12 - w8 * w13
    w15 = body_e0 * body_e3 * c8 + w3 * w11 - (w4 * w14 + w7 * w13)
    w16 = w6 * c3
    w17 = 2 * body_e1
    w18 = w17 * c5
    w19 = w0 * c6
    w20 = body_e2 * body_e1 * c11 + w2 * w19
    w21 = body_e3 / body_e0
    w22 = w20 - w8 * w21
    w23 = w2 * w18 + body_e0 * body_e2 * c10 - (w4 * w22 + w7 * w21)
    w24 = w9 * w16 + body_e0 * body_e1 * c12 - (w13 * w22 + w12 * w21)
    w25 = w2 * body_e0_dot + w3 * body_e1_dot + w5 * body_e2_dot + w0 * body_e3_dot
    w26 = w25 * c2
    w27 = w6 * body_e0_dot + w2 * body_e1_dot + w0 * body_e2_dot + w17 * body_e3_dot
    w28 = w27 * c1
    w29 = w26 * w27 - w25 * w28
    w30 = w5 * body_e0_dot + w0 * body_e1_dot + w9 * body_e2_dot + w6 * body_e3_dot
    w31 = w30 * c4
    w32 = w25 * w31 - w26 * w30
    w33 = w28 * w30 - w27 * w31
    w34 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w35 = w5 * w29 + w6 * w32 + w2 * w33 + w8 * w34
    M_hat = ca.vertcat(
        c0,
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
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * w1 + w2 * (w2 * c5) + w3 * (w3 * c6) - (w4 * (w7 - w4 * w8) + w4 * w7),
        w15,
        w23,
        0.0,
        0.0,
        0.0,
        w15,
        w9 * (w9 * c3) + w0 * w10 + w5 * w11 - (w13 * w14 + w12 * w13),
        w24,
        0.0,
        0.0,
        0.0,
        w23,
        w24,
        w6 * w16 + w17 * w18 + w0 * w19 - (w21 * w22 + w20 * w21),
    )
    M_hat = ca.reshape(M_hat, 6, 6)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w0 * w29 + w2 * w32 + w3 * w33 + w7 * w34 - w4 * w35,
        w9 * w29 + w0 * w32 + w5 * w33 + w12 * w34 - w13 * w35,
        w6 * w29 + w17 * w32 + w0 * w33 + w20 * w34 - w21 * w35,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 20 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    w0 = (body_e0**2 + body_e1**2 + body_e2**2 + body_e3**2 - 1.0) / 2.0
    q_d_next = ca.vertcat(
        body_e0 - w0 / body_e0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        w0,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        body_e0,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 17 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    w0 = body_e1 / body_e0 * body_e1_dot + body_e2 / body_e0 * body_e2_dot + body_e3 / body_e0 * body_e3_dot
    q_d_dot = ca.vertcat(
        -w0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 30 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
    body_e1_ddot = q_i_ddot[3]
    body_e2_ddot = q_i_ddot[4]
    body_e3_ddot = q_i_ddot[5]
    w0 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0 + body_e1 / body_e0 * body_e1_ddot
    q_d_ddot = ca.vertcat(
        -(w0 + body_e2 / body_e0 * body_e2_ddot + body_e3 / body_e0 * body_e3_ddot),
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 39 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    C = ca.vertcat(
        (body_e0**2 + body_e1**2 + body_e2**2 + body_e3**2 - 1.0) / 2.0,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        0.0,
        0.0,
        0.0,
        body_e0,
        body_e1,
        body_e2,
        body_e3,
    )
    C_q = ca.reshape(C_q, 1, 7)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        -(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 274 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
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
    w0 = body_e1 * -2.0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e0
    w4 = w3 * c3
    w5 = 2 * body_e2
    w6 = w0 * w4 + body_e2 * body_e3 * c7
    w7 = 2 * body_e3
    w8 = w3 * c5
    w9 = w0 * c6
    w10 = w1 * w8 + body_e1 * body_e3 * c9
    w11 = w1 * c3
    w12 = 2 * body_e1
    w13 = w12 * c5
    w14 = w3 * c6
    w15 = body_e1 * body_e2 * c11 + w2 * w14
    w16 = body_e3 * body_e0 * c8 + w5 * w9
    w17 = w2 * w13 + body_e2 * body_e0 * c10
    w18 = w7 * w11 + body_e1 * body_e0 * c12
    w19 = w2 * body_e0_dot + w5 * body_e1_dot + w0 * body_e2_dot + w3 * body_e3_dot
    w20 = w19 * c2
    w21 = w1 * body_e0_dot + w2 * body_e1_dot + w3 * body_e2_dot + w12 * body_e3_dot
    w22 = w21 * c1
    w23 = w20 * w21 - w19 * w22
    w24 = w0 * body_e0_dot + w3 * body_e1_dot + w7 * body_e2_dot + w1 * body_e3_dot
    w25 = w24 * c4
    w26 = w19 * w25 - w20 * w24
    w27 = w22 * w24 - w21 * w25
    w28 = w0 * w23 + w1 * w26 + w2 * w27
    w29 = w3 * w23 + w2 * w26 + w5 * w27
    w30 = w7 * w23 + w3 * w26 + w0 * w27
    w31 = w1 * w23 + w12 * w26 + w3 * w27
    M = ca.vertcat(
        c0,
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
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * (w0 * c3) + w1 * (w1 * c5) + w2 * (w2 * c6),
        w6,
        w10,
        w15,
        0.0,
        0.0,
        0.0,
        w6,
        w3 * w4 + w2 * (w2 * c5) + w5 * (w5 * c6),
        w16,
        w17,
        0.0,
        0.0,
        0.0,
        w10,
        w16,
        w7 * (w7 * c3) + w3 * w8 + w0 * w9,
        w18,
        0.0,
        0.0,
        0.0,
        w15,
        w17,
        w18,
        w1 * w11 + w12 * w13 + w3 * w14,
    )
    M = ca.reshape(M, 7, 7)
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
    )
    K = ca.reshape(K, 7, 7)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w28,
        w29,
        w30,
        w31,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w28,
        w29,
        w30,
        w31,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        0.0,
        0.0,
        0.0,
        body_e0,
        body_e1,
        body_e2,
        body_e3,
    )
    C_q = ca.reshape(C_q, 1, 7)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        -(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 100 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    body_e0_ddot = q_ddot[3]
    body_e1_ddot = q_ddot[4]
    body_e2_ddot = q_ddot[5]
    body_e3_ddot = q_ddot[6]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    w0 = body_e1 * -2.0
    w1 = body_e3 * -2.0
    w2 = 2 * body_e0
    w3 = body_e0_dot * w1 + body_e1_dot * (2 * body_e2) + w0 * body_e2_dot + body_e3_dot * w2
    w4 = w3 * c2
    w5 = body_e2 * -2.0
    w6 = body_e0_dot * w5 + w1 * body_e1_dot + body_e2_dot * w2 + body_e3_dot * (2 * body_e1)
    w7 = w6 * c1
    w8 = w0 * body_e0_dot + body_e1_dot * w2 + body_e2_dot * (2 * body_e3) + body_e3_dot * w5
    w9 = w8 * c4
    w10 = (w0 * (w0 * c3) + w5 * (w5 * c5) + w1 * (w1 * c6)) * body_e0_ddot + (w0 * (w2 * c3) + body_e3 * body_e2 * c7) * body_e1_ddot
    w11 = w10 + (w5 * (w2 * c5) + body_e1 * body_e3 * c9) * body_e2_ddot + (body_e1 * body_e2 * c11 + w1 * (w2 * c6)) * body_e3_ddot
    lam = ca.vertcat(
        (w0 * (w4 * w6 - w3 * w7) + w5 * (w3 * w9 - w4 * w8) + w1 * (w7 * w8 - w6 * w9) - w11) / body_e0,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
    )
    joint_forces = ca.reshape(joint_forces, 6, 0)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 137 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_x_dot = q_dot[0]
    body_y_dot = q_dot[1]
    body_z_dot = q_dot[2]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    c0 = c[0]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    w0 = body_e1 * -2.0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e0
    w4 = w3 * c3
    w5 = 2 * body_e2
    w6 = w0 * w4 + body_e2 * body_e3 * c7
    w7 = 2 * body_e3
    w8 = w3 * c5
    w9 = w0 * c6
    w10 = w1 * w8 + body_e1 * body_e3 * c9
    w11 = body_e0_dot * (w0 * (w0 * c3) + w1 * (w1 * c5) + w2 * (w2 * c6)) + w6 * body_e1_dot + w10 * body_e2_dot
    w12 = w1 * c3
    w13 = 2 * body_e1
    w14 = w13 * c5
    w15 = w3 * c6
    w16 = body_e1 * body_e2 * c11 + w2 * w15
    w17 = body_x_dot * (body_x_dot * c0) + body_y_dot * (body_y_dot * c0) + body_z_dot * (body_z_dot * c0) + body_e0_dot * (w11 + w16 * body_e3_dot)
    w18 = body_e3 * body_e0 * c8 + w5 * w9
    w19 = w2 * w14 + body_e2 * body_e0 * c10
    w20 = body_e0_dot * w6 + body_e1_dot * (w3 * w4 + w2 * (w2 * c5) + w5 * (w5 * c6)) + body_e2_dot * w18 + body_e3_dot * w19
    w21 = w7 * w12 + body_e1 * body_e0 * c12
    w22 = body_e0_dot * w10 + body_e1_dot * w18 + body_e2_dot * (w7 * (w7 * c3) + w3 * w8 + w0 * w9) + body_e3_dot * w21
    w23 = body_e0_dot * w16 + body_e1_dot * w19 + body_e2_dot * w21 + body_e3_dot * (w1 * w12 + w13 * w14 + w3 * w15)
    kinetic = ca.vertcat(
        (w17 + body_e1_dot * w20 + body_e2_dot * w22 + body_e3_dot * w23) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        0.0,
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
    """Origin and rotation matrix of each body, for pictures. 46 operations."""
    q = ca.SX.sym("q", 7)
    body_x = q[0]
    body_y = q[1]
    body_z = q[2]
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    w0 = 2 * body_e2**2
    w1 = 2 * body_e3**2
    w2 = 2 * body_e0
    w3 = body_e3 * w2
    w4 = 2 * body_e1
    w5 = body_e2 * w4
    w6 = body_e3 * w4
    w7 = body_e2 * w2
    w8 = 1.0 - 2 * body_e1**2
    w9 = w2 * body_e1
    w10 = body_e3 * (2 * body_e2)
    poses = ca.vertcat(
        body_x,
        body_y,
        body_z,
        1.0 - w0 - w1,
        w3 + w5,
        w6 - w7,
        w5 - w3,
        w8 - w1,
        w9 + w10,
        w6 + w7,
        w10 - w9,
        w8 - w0,
    )
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 556 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    w0 = 2 * body_e0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e1
    w4 = body_e0_dot * w1 + body_e1_dot * w2 + w0 * body_e2_dot + body_e3_dot * w3
    w5 = body_e2_dot * -2.0
    w6 = w5 * c2
    w7 = 2 * body_e2
    w8 = body_e1 * -2.0
    w9 = body_e0_dot * w2 + body_e1_dot * w7 + body_e2_dot * w8 + w0 * body_e3_dot
    w10 = w9 * c2
    w11 = 2 * body_e3_dot
    w12 = w11 * c1
    w13 = w4 * c1
    w14 = w4 * w6 + w10 * w11 - (w9 * w12 + w5 * w13)
    w15 = body_e0_dot * -2.0
    w16 = w15 * c4
    w17 = 2 * body_e3
    w18 = body_e0_dot * w8 + w0 * body_e1_dot + body_e2_dot * w17 + w1 * body_e3_dot
    w19 = w18 * c4
    w20 = w10 * w15
    w21 = w9 * w16 + w5 * w19 - (w6 * w18 + w20)
    w22 = w13 * w15
    w23 = w11 * w19
    w24 = w12 * w18 + w22 - (w4 * w16 + w23)
    w25 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w26 = w0 * c3
    w27 = body_e1 / body_e0
    w28 = w4 * w10 - w9 * w13
    w29 = w28 * -2.0
    w30 = w8 * c3
    w31 = w8 * c16
    w32 = w29 + w8 * w14 + w1 * w21 + w2 * w24 + w25 * (w30 * -2.0 + w31)
    w33 = w9 * w19 - w10 * w18
    w34 = w13 * w18 - w4 * w19
    w35 = w1 * c5
    w36 = w2 * c6
    w37 = w8 * w30 + w1 * w35 + w2 * w36
    w38 = w8 * w28 + w1 * w33 + w2 * w34 + w25 * w37
    w39 = w38 / body_e0
    w40 = 2 * w28
    w41 = w11 * c2
    w42 = 2 * body_e2_dot
    w43 = w10 * w42
    w44 = w42 * c1
    w45 = w4 * w41 + w43 - (w9 * w44 + w11 * w13)
    w46 = 2 * body_e1_dot
    w47 = w46 * c4
    w48 = w23 + w9 * w47 - (w18 * w41 + w10 * w46)
    w49 = w13 * w46
    w50 = w18 * w44 + w49 - (w4 * w47 + w19 * w42)
    w51 = w8 * c13
    w52 = w8 * w26 + body_e2 * body_e3 * c7
    w53 = w25 / body_e0
    w54 = w8 * w45 + w1 * w48 + w2 * w50 - w37 * w53
    w55 = w27 / body_e0
    w56 = w40 + w0 * w45 + w2 * w48 + w7 * w50 + (w25 * w51 - w52 * w53) - (w27 * w54 - w38 * w55)
    w57 = w2 * c2
    w58 = w1 * c1
    w59 = w4 * w57 + w1 * w10 - (w9 * w58 + w2 * w13)
    w60 = w8 * c4
    w61 = w9 * w60 + w2 * w19 - (w18 * w57 + w8 * w10)
    w62 = w18 * w58 + w8 * w13 - (w4 * w60 + w1 * w19)
    w63 = 2 * body_e0_dot / body_e0
    w64 = w8 * w59 + w1 * w61 + w2 * w62 + w37 * w63
    w65 = w0 * w59 + w2 * w61 + w7 * w62 + w52 * w63 - w27 * w64
    w66 = body_e2 / body_e0
    w67 = w66 / body_e0
    w68 = body_e3 / body_e0
    w69 = w68 / body_e0
    w70 = body_e1_dot * w55 + body_e2_dot * w67 + body_e3_dot * w69
    w71 = body_e1_dot / body_e0 + w27 * w70
    w72 = w34 * -2.0
    w73 = w2 * c17
    w74 = 2 * w33
    w75 = w1 * c18
    w76 = w0 * c5
    w77 = w1 * w76 + body_e3 * body_e1 * c9
    w78 = w17 * w45 + (w74 + w0 * w48) + w8 * w50 + (w25 * w75 - w53 * w77) - (w54 * w66 - w38 * w67)
    w79 = w17 * w59 + w0 * w61 + w8 * w62 + w63 * w77 - w64 * w66
    w80 = w14 * w17 + w0 * w21 + (w72 + w8 * w24) + w25 * (w17 * c3 * -2.0 + w73) - w32 * w66 - w27 * w78 - w71 * w79
    w81 = 2 * w34
    w82 = w2 * c15
    w83 = w0 * c6
    w84 = body_e2 * body_e1 * c11 + w2 * w83
    w85 = w1 * w45 + w3 * w48 + (w81 + w0 * w50) + (w25 * w82 - w53 * w84) - (w54 * w68 - w38 * w69)
    w86 = w1 * w59 + w3 * w61 + w0 * w62 + w63 * w84 - w64 * w68
    w87 = w1 * w14 + (w74 + w3 * w21) + w0 * w24 + w25 * (w75 + w1 * c3 * -2.0) - w32 * w68 - w27 * w85 - w71 * w86
    w88 = w46 * c2
    w89 = w15 * c1
    w90 = w20 + w4 * w88 - (w49 + w9 * w89)
    w91 = body_e3_dot * -2.0
    w92 = w91 * c4
    w93 = w9 * w92 + w19 * w46 - (w18 * w88 + w10 * w91)
    w94 = w15 * w19
    w95 = w18 * w89 + w13 * w91 - (w4 * w92 + w94)
    w96 = w33 * -2.0
    w97 = w1 * c14
    w98 = w8 * w90 + (w96 + w1 * w93) + w2 * w95 + w25 * (w35 * -2.0 + w97)
    w99 = body_e2_dot / body_e0 + w66 * w70
    w100 = w0 * w90 + w2 * w93 + (w81 + w7 * w95) + w25 * (w82 + w2 * c5 * -2.0) - w27 * w98 - w56 * w66 - w65 * w99
    w101 = w29 + w1 * w90 + w3 * w93 + w0 * w95 + w25 * (w31 + w3 * c5 * -2.0) - w68 * w98 - w66 * w85 - w86 * w99
    w102 = w15 * c2
    w103 = body_e1_dot * -2.0
    w104 = w103 * c1
    w105 = w4 * w102 + w10 * w103 - (w22 + w9 * w104)
    w106 = w42 * c4
    w107 = w94 + w9 * w106 - (w43 + w18 * w102)
    w108 = w18 * w104 + w13 * w42 - (w4 * w106 + w19 * w103)
    w109 = w8 * w105 + w1 * w107 + (w72 + w2 * w108) + w25 * (w73 + w36 * -2.0)
    w110 = w0 * w105 + (w96 + w2 * w107) + w7 * w108 + w25 * (w97 + w7 * c6 * -2.0) - w27 * w109 - w56 * w68
    w111 = body_e3_dot / body_e0 + w68 * w70
    w112 = w40 + w17 * w105 + w0 * w107 + w8 * w108 + w25 * (w51 + w8 * c6 * -2.0) - w66 * w109 - w68 * w78 - w79 * w111
    w113 = w1 * w105 + w3 * w107 + w0 * w108 + w25 * (w83 * -2.0) - (w39 + w68 * w109) - w68 * w85 - w86 * w111
    dQ_hat_dq_i = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * w14 + w2 * w21 + w7 * w24 + w25 * (w26 * -2.0) - (w27 * w32 + w39) - w27 * w56 - w65 * w71,
        w80,
        w87,
        0.0,
        0.0,
        0.0,
        w100,
        w17 * w90 + w0 * w93 + w8 * w95 + w25 * (w76 * -2.0) - (w39 + w66 * w98) - w66 * w78 - w79 * w99,
        w101,
        0.0,
        0.0,
        0.0,
        w110 - w65 * w111,
        w112,
        w113,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 6, 6)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 321 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    w0 = 2 * body_e0
    w1 = body_e3 * -2.0
    w2 = body_e1 / body_e0
    w3 = body_e2 / body_e0
    w4 = body_e3 / body_e0
    w5 = body_e1_dot * w2 + w3 * body_e2_dot + w4 * body_e3_dot
    w6 = body_e2 * -2.0
    w7 = 2 * body_e1
    w8 = body_e1_dot * w1 - w5 * w6 + w0 * body_e2_dot + body_e3_dot * w7
    w9 = 2 * body_e2
    w10 = w9 - w1 * w2
    w11 = w10 * c2
    w12 = body_e1 * -2.0
    w13 = body_e1_dot * w9 - w1 * w5 + body_e2_dot * w12 + w0 * body_e3_dot
    w14 = w13 * c2
    w15 = w1 - w2 * w6
    w16 = w15 * c1
    w17 = w8 * c1
    w18 = w8 * w11 + w14 * w15 - (w13 * w16 + w10 * w17)
    w19 = w0 - w2 * w12
    w20 = w19 * c4
    w21 = 2 * body_e3
    w22 = w0 * body_e1_dot - w5 * w12 + body_e2_dot * w21 + body_e3_dot * w6
    w23 = w22 * c4
    w24 = w13 * w20 + w10 * w23 - (w11 * w22 + w14 * w19)
    w25 = w16 * w22 + w17 * w19 - (w8 * w20 + w15 * w23)
    w26 = w12 * (w0 * c3) + body_e3 * body_e2 * c7
    w27 = 2 * w5
    w28 = (w2 * w27 + 2 * body_e1_dot) / body_e0
    w29 = w12 * (w12 * c3) + w6 * (w6 * c5) + w1 * (w1 * c6)
    w30 = w12 * w18 + w6 * w24 + w1 * w25 + w28 * w29
    w31 = w6 * (w0 * c5) + body_e3 * body_e1 * c9
    w32 = body_e1 * body_e2 * c11 + w1 * (w0 * c6)
    w33 = w12 - w1 * w3
    w34 = w33 * c2
    w35 = w0 - w3 * w6
    w36 = w35 * c1
    w37 = w8 * w34 + w14 * w35 - (w13 * w36 + w17 * w33)
    w38 = w21 - w3 * w12
    w39 = w38 * c4
    w40 = w13 * w39 + w23 * w33 - (w22 * w34 + w14 * w38)
    w41 = w22 * w36 + w17 * w38 - (w8 * w39 + w23 * w35)
    w42 = (w3 * w27 + 2 * body_e2_dot) / body_e0
    w43 = w12 * w37 + w6 * w40 + w1 * w41 + w29 * w42
    w44 = w0 - w1 * w4
    w45 = w44 * c2
    w46 = w7 - w4 * w6
    w47 = w46 * c1
    w48 = w8 * w45 + w14 * w46 - (w13 * w47 + w17 * w44)
    w49 = w6 - w4 * w12
    w50 = w49 * c4
    w51 = w13 * w50 + w23 * w44 - (w22 * w45 + w14 * w49)
    w52 = w22 * w47 + w17 * w49 - (w8 * w50 + w23 * w46)
    w53 = (w4 * w27 + 2 * body_e3_dot) / body_e0
    w54 = w12 * w48 + w6 * w51 + w1 * w52 + w29 * w53
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * w18 + w1 * w24 + w9 * w25 + w26 * w28 - w2 * w30,
        w18 * w21 + w0 * w24 + w12 * w25 + w28 * w31 - w3 * w30,
        w6 * w18 + w7 * w24 + w0 * w25 + w28 * w32 - w4 * w30,
        0.0,
        0.0,
        0.0,
        w0 * w37 + w1 * w40 + w9 * w41 + w26 * w42 - w2 * w43,
        w21 * w37 + w0 * w40 + w12 * w41 + w31 * w42 - w3 * w43,
        w6 * w37 + w7 * w40 + w0 * w41 + w32 * w42 - w4 * w43,
        0.0,
        0.0,
        0.0,
        w0 * w48 + w1 * w51 + w9 * w52 + w26 * w53 - w2 * w54,
        w21 * w48 + w0 * w51 + w12 * w52 + w31 * w53 - w3 * w54,
        w6 * w48 + w7 * w51 + w0 * w52 + w32 * w53 - w4 * w54,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 6, 6)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 371 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_ddot = q_i_ddot[3]
    body_e2_ddot = q_i_ddot[4]
    body_e3_ddot = q_i_ddot[5]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    w0 = 2 * body_e2
    w1 = w0 * c17
    w2 = body_e1 / body_e0
    w3 = body_e2 / body_e0
    w4 = body_e3 / body_e0
    w5 = w2 * body_e1_ddot + body_e2_ddot * w3 + w4 * body_e3_ddot
    w6 = 2 * body_e0
    w7 = w6 * c3
    w8 = w7 * -2.0
    w9 = body_e1 * -2.0
    w10 = body_e2 * -2.0
    w11 = body_e3 * -2.0
    w12 = w0 * c6
    w13 = w7 * w9 + body_e2 * body_e3 * c7
    w14 = body_e1_ddot / body_e0
    w15 = w11 * c18
    w16 = w9 * c3
    w17 = w9 * c16
    w18 = w10 * c5
    w19 = w11 * c6
    w20 = w9 * w16 + w10 * w18 + w11 * w19
    w21 = 2 * body_e3
    w22 = w21 * c3
    w23 = w11 * c17
    w24 = w22 * -2.0 + w23
    w25 = w10 * c3
    w26 = w25 * -2.0
    w27 = w10 * c18
    w28 = w26 + w27
    w29 = body_e1_ddot * w8 - (w5 * (w16 * -2.0 + w17) + w14 * w20) + body_e2_ddot * w24 + body_e3_ddot * w28
    w30 = w6 * c5
    w31 = w9 * c6
    w32 = w10 * w30 + body_e1 * body_e3 * c9
    w33 = 2 * body_e1
    w34 = w33 * c5
    w35 = w6 * c6
    w36 = body_e2 * body_e1 * c11 + w11 * w35
    w37 = body_e1_ddot * w13 - w5 * w20 + body_e2_ddot * w32 + body_e3_ddot * w36
    w38 = w37 / body_e0
    w39 = w6 * c13
    w40 = w9 * c13
    w41 = w2 / body_e0
    w42 = w3 / body_e0
    w43 = w4 / body_e0
    w44 = body_e1_ddot * w41 + body_e2_ddot * w42 + body_e3_ddot * w43
    w45 = 2 * w22
    w46 = w15 + w45
    w47 = 2 * w25
    w48 = w0 * c15
    w49 = w47 + w48
    w50 = w11 * c15
    w51 = body_e1_ddot * w40 + w20 * w44 + body_e2_ddot * w27 + body_e3_ddot * w50
    w52 = body_e1_ddot * (2 * w7 + w39) - (w5 * w40 - w13 * w44) + body_e2_ddot * w46 + body_e3_ddot * w49 - (w2 * w51 - w37 * w41)
    w53 = w31 * -2.0
    w54 = w6 * c18
    w55 = w35 * -2.0
    w56 = w54 + w55
    w57 = w1 * body_e1_ddot - (w5 * w24 + w14 * w32) + body_e2_ddot * (w53 + w9 * c17) + body_e3_ddot * w56
    w58 = 2 * w34
    w59 = w58 + w9 * c15
    w60 = body_e1_ddot * w46 - (w5 * w27 - w32 * w44) + body_e2_ddot * (w54 + 2 * w30) + body_e3_ddot * w59
    w61 = w60 - (w3 * w51 - w37 * w42)
    w62 = body_e1_ddot * w15 - (w5 * w28 + w14 * w36) + body_e2_ddot * w56 + body_e3_ddot * (w58 + w33 * c18)
    w63 = 2 * w35
    w64 = body_e1_ddot * w49 - (w5 * w50 - w36 * w44) + body_e2_ddot * w59 + body_e3_ddot * (w63 + w6 * c15)
    w65 = w64 - (w4 * w51 - w37 * w43)
    w66 = w11 * c5 * -2.0
    w67 = w50 + w66
    w68 = body_e2_ddot / body_e0
    w69 = 2 * w31
    w70 = w63 + w6 * c16
    w71 = body_e1_ddot * (w48 + 2 * w12) - (w5 * w67 + w13 * w68) + body_e2_ddot * w69 + body_e3_ddot * w70
    w72 = w10 * c14
    w73 = w30 * -2.0
    w74 = w34 * -2.0
    w75 = w17 + w74
    w76 = body_e1_ddot * w67 - (w5 * (w18 * -2.0 + w72) + w20 * w68) + body_e2_ddot * w73 + body_e3_ddot * w75
    w77 = w21 * c16
    w78 = body_e1_ddot * w70 - (w5 * w75 + w36 * w68) + body_e2_ddot * w77 + body_e3_ddot * (w26 + w10 * c16)
    w79 = w72 + w12 * -2.0
    w80 = body_e3_ddot / body_e0
    w81 = w39 + w73
    w82 = body_e1_ddot * (w66 + w11 * c14) - (w5 * w79 + w13 * w80) + body_e2_ddot * w81 + body_e3_ddot * w74
    w83 = w40 + w53
    w84 = body_e1_ddot * w79 - (w5 * (w23 + w19 * -2.0) + w20 * w80) + body_e2_ddot * w83 + body_e3_ddot * w55
    w85 = body_e1_ddot * w81 - (w5 * w83 + w32 * w80) + body_e2_ddot * (w45 + w21 * c13) + body_e3_ddot * w47
    dMa_dq_i = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        body_e2_ddot * w1 - (w5 * w8 + w13 * w14) + body_e3_ddot * w15 - (w2 * w29 + w38) - w2 * w52,
        w57 - w3 * w29 - w2 * w61,
        w62 - w4 * w29 - w2 * w65,
        0.0,
        0.0,
        0.0,
        w71 - w2 * w76 - w3 * w52,
        body_e1_ddot * w69 - (w5 * w73 + w32 * w68) + body_e3_ddot * w77 - (w38 + w3 * w76) - w3 * w61,
        w78 - w4 * w76 - w3 * w65,
        0.0,
        0.0,
        0.0,
        w82 - w2 * w84 - w4 * w52,
        w85 - w3 * w84 - w4 * w61,
        body_e1_ddot * w74 - (w5 * w55 + w36 * w80) + body_e2_ddot * w47 - (w38 + w4 * w84) - w4 * w65,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 6, 6)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 225 operations."""
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
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
    w0 = 2 * body_e0
    w1 = body_e3 * -2.0
    w2 = 2 * body_e2
    w3 = body_e1 * -2.0
    w4 = body_e0_dot * w1 + body_e1_dot * w2 + body_e2_dot * w3 + w0 * body_e3_dot
    w5 = w4 * c2
    w6 = body_e2 * -2.0
    w7 = 2 * body_e1
    w8 = body_e0_dot * w6 + w1 * body_e1_dot + w0 * body_e2_dot + body_e3_dot * w7
    w9 = w8 * c1
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * body_e3
    w12 = body_e0_dot * w3 + w0 * body_e1_dot + body_e2_dot * w11 + body_e3_dot * w6
    w13 = w12 * c4
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = w0 * c3
    w17 = w3 * w16 + body_e3 * body_e2 * c7
    w18 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w19 = body_e1 / body_e0
    w20 = w3 * (w3 * c3) + w6 * (w6 * c5) + w1 * (w1 * c6)
    w21 = w3 * w10 + w6 * w14 + w1 * w15 + w18 * w20
    w22 = w6 * c3
    w23 = w7 * c5
    w24 = w0 * c6
    w25 = body_e2 * body_e1 * c11 + w1 * w24
    w26 = body_e3 / body_e0
    w27 = w25 - w20 * w26
    w28 = w1 * w23 + body_e0 * body_e2 * c10 - (w19 * w27 + w17 * w26)
    w29 = w6 * w22 + w7 * w23 + w0 * w24 - (w26 * w27 + w25 * w26)
    w30 = w28 / w29
    w31 = w6 * w10 + w7 * w14 + w0 * w15 + w18 * w25 - w21 * w26
    w32 = w0 * c5
    w33 = w3 * c6
    w34 = w6 * w32 + body_e3 * body_e1 * c9
    w35 = body_e2 / body_e0
    w36 = w34 - w20 * w35
    w37 = w11 * w22 + body_e0 * body_e1 * c12 - (w27 * w35 + w26 * w34)
    w38 = body_e0 * body_e3 * c8 + w2 * w33 - (w19 * w36 + w17 * w35) - w30 * w37
    w39 = w37 / w29
    w40 = w11 * (w11 * c3) + w0 * w32 + w3 * w33 - (w35 * w36 + w34 * w35) - w37 * w39
    w41 = w38 / w40
    w42 = w10 * w11 + w0 * w14 + w3 * w15 + w18 * w34 - w21 * w35 - w31 * w39
    w43 = w0 * w16 + w1 * (w1 * c5) + w2 * (w2 * c6) - (w19 * (w17 - w19 * w20) + w17 * w19) - w28 * w30 - w38 * w41
    w44 = (w0 * w10 + w1 * w14 + w2 * w15 + w17 * w18 - w19 * w21 - w30 * w31 - w41 * w42) / w43
    w45 = (w42 - w38 * w44) / w40
    q_i_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w44,
        w45,
        (w31 - (w28 * w44 + w37 * w45)) / w29,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 40 operations."""
    p = ca.SX.sym("p", 6)
    body_tip_x_x = p[4]
    body_tip_y_y = p[5]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        body_tip_x_x,
        0.0,
        0.0,
        0.0,
        body_tip_y_y,
        0.0,
    )
    positions = ca.reshape(positions, 3, 3)
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
    )
    axes = ca.reshape(axes, 9, 3)
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
    "geometry": geometry,
}
