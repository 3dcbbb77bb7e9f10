"""Heavy top: equations of motion, emitted by symgen from the scene `heavy_top`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 69 operations."""
    p = ca.SX.sym("p", 6)
    gravity_z = p[0]
    top_mass = p[1]
    top_inertia_xx = p[2]
    top_inertia_yy = p[3]
    top_inertia_zz = p[4]
    top_foot_y = p[5]
    w0 = (top_inertia_xx + top_inertia_yy + top_inertia_zz) / 2.0
    w1 = w0 - top_inertia_yy
    w2 = w0 - top_inertia_zz
    w3 = w1 + w2
    w4 = w0 - top_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = -4.0 * w6
    w8 = -4.0 * w5
    w9 = top_mass * gravity_z
    c = ca.vertcat(
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        top_foot_y,
        top_mass,
        4.0 * w5 + w7,
        4.0 * w3 + w8,
        4.0 * w6 + -4.0 * w3,
        4.0 * w6 + -4.0 * w3,
        4.0 * w3 + w8,
        w7 + 4.0 * w5,
        w9,
        -top_foot_y,
        -w9,
        2 * w3,
        -2.0 * w5,
        2 * w6,
        -2.0 * w3,
        -2.0 * w6,
        2 * w5,
        4.0 * top_foot_y,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 391 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    top_e0_dot = q_d_dot[3]
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
    c13 = c[13]
    c14 = c[14]
    w0 = 2 * top_e0
    w1 = w0 * c2
    w2 = top_e3 * -2.0
    w3 = 2 * top_e2
    w4 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w5 = w0 * w4
    w6 = 2 * top_e3
    w7 = 2 * top_e1
    w8 = (top_e2 * w7 - w0 * top_e3) * c6
    w9 = w5 - w6 * w8
    w10 = w9 * c7
    w11 = top_e2 * -2.0
    w12 = w8 * w11
    w13 = (w0 * top_e1 + top_e3 * w3) * c6
    w14 = w0 * w13
    w15 = w12 - w14
    w16 = w15 * c7
    w17 = w6 * w13 - w4 * w11
    w18 = w17 * c7
    w19 = top_e1 / top_e0
    w20 = top_e1 * -2.0
    w21 = w1 * w20 + top_e3 * top_e2 * c8
    w22 = w4 * w20 - w12
    w23 = w13 * w20
    w24 = w2 * w8 - w23
    w25 = w2 * w4
    w26 = w11 * w13 - w25
    w27 = w21 + w10 * w22 + w16 * w24 + w18 * w26
    w28 = w20 * (w20 * c2) + w11 * (w11 * c4) + w2 * (w2 * c5)
    w29 = w28 + w22 * (w22 * c7) + w24 * (w24 * c7) + w26 * (w26 * c7)
    w30 = w0 * w1 + w2 * (w2 * c4) + w3 * (w3 * c5) + w9 * w10 + w15 * w16 + w17 * w18 - (w19 * (w27 - w19 * w29) + w19 * w27)
    w31 = w0 * c4
    w32 = w20 * c5
    w33 = w0 * w8
    w34 = w25 - w33
    w35 = w34 * c7
    w36 = w7 * w8 - w2 * w13
    w37 = w36 * c7
    w38 = w14 - w4 * w7
    w39 = w38 * c7
    w40 = w11 * w31 + top_e3 * top_e1 * c10
    w41 = w40 + w22 * w35 + w24 * w37 + w26 * w39
    w42 = top_e2 / top_e0
    w43 = w41 - w29 * w42
    w44 = top_e0 * top_e3 * c9 + w3 * w32 + w9 * w35 + w15 * w37 + w17 * w39 - (w19 * w43 + w27 * w42)
    w45 = w11 * c2
    w46 = w7 * c4
    w47 = w0 * c5
    w48 = w3 * w4 - w8 * w20
    w49 = w48 * c7
    w50 = w33 - w3 * w13
    w51 = w50 * c7
    w52 = w23 - w5
    w53 = w52 * c7
    w54 = top_e2 * top_e1 * c12 + w2 * w47
    w55 = w54 + w22 * w49 + w24 * w51 + w26 * w53
    w56 = top_e3 / top_e0
    w57 = w55 - w29 * w56
    w58 = w2 * w46 + top_e0 * top_e2 * c11 + w9 * w49 + w15 * w51 + w17 * w53 - (w19 * w57 + w27 * w56)
    w59 = w6 * (w6 * c2) + w0 * w31 + w20 * w32 + w34 * w35 + w36 * w37 + w38 * w39 - (w42 * w43 + w41 * w42)
    w60 = w6 * w45 + top_e0 * top_e1 * c13 + w34 * w49 + w36 * w51 + w38 * w53 - (w42 * w57 + w41 * w56)
    w61 = w2 * top_e0_dot
    w62 = w0 * top_e3_dot
    w63 = w61 + w3 * top_e1_dot + w20 * top_e2_dot + w62
    w64 = w63 * c1
    w65 = w11 * top_e0_dot
    w66 = w0 * top_e2_dot
    w67 = w65 + w2 * top_e1_dot + w66 + w7 * top_e3_dot
    w68 = w67 * c0
    w69 = w64 * w67 - w63 * w68
    w70 = w20 * top_e0_dot + w0 * top_e1_dot
    w71 = w70 + w6 * top_e2_dot + w11 * top_e3_dot
    w72 = w71 * c3
    w73 = w63 * w72 - w64 * w71
    w74 = w68 * w71 - w67 * w72
    w75 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w76 = w70 + w2 * top_e2_dot + w3 * top_e3_dot
    w77 = w62 + (w61 + w11 * top_e1_dot + w7 * top_e2_dot)
    w78 = w8 * w77 - w13 * w76
    w79 = w66 + (w65 + w6 * top_e1_dot) + w20 * top_e3_dot
    w80 = w13 * w79 - w4 * w77
    w81 = c14 - (w22 * w75 - (w76 * w78 - w79 * w80)) * c7
    w82 = w4 * w76 - w8 * w79
    w83 = (w24 * w75 - (w77 * w80 - w76 * w82)) * c7
    w84 = (w26 * w75 - (w79 * w82 - w77 * w78)) * c7
    w85 = w20 * w69 + w11 * w73 + w2 * w74 + w28 * w75 - w22 * w81 + w24 * w83 + w26 * w84
    M_hat = ca.vertcat(
        w30,
        w44,
        w58,
        w44,
        w59,
        w60,
        w58,
        w60,
        w11 * w45 + w7 * w46 + w0 * w47 + w48 * w49 + w50 * w51 + w52 * w53 - (w56 * w57 + w55 * w56),
    )
    M_hat = ca.reshape(M_hat, 3, 3)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w0 * w69 + w2 * w73 + w3 * w74 + w21 * w75 - w9 * w81 + w15 * w83 + w17 * w84 - w19 * w85,
        w6 * w69 + w0 * w73 + w20 * w74 + w40 * w75 - w34 * w81 + w36 * w83 + w38 * w84 - w42 * w85,
        w11 * w69 + w7 * w73 + w0 * w74 + w54 * w75 - w48 * w81 + w50 * w83 + w52 * w84 - w56 * w85,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 40 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    c15 = c[15]
    w0 = top_e1**2
    w1 = top_e3**2
    w2 = (top_e0**2 + w0 + top_e2**2 + w1 - 1.0) / 2.0
    w3 = top_e0 - w2 / top_e0
    w4 = 2 * w3
    q_d_next = ca.vertcat(
        (2 * top_e1 * top_e2 - top_e3 * w4) * c15,
        (1.0 - 2 * w0 - 2 * w1) * c15,
        (top_e1 * w4 + top_e3 * (2 * top_e2)) * c15,
        w3,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        w2,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        top_e0,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 96 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    c6 = c[6]
    w0 = top_e2 * -2.0
    w1 = 2 * top_e0
    w2 = 2 * top_e2
    w3 = (w1 * top_e1 + w2 * top_e3) * c6
    w4 = top_e3 * -2.0
    w5 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w6 = w4 * w5
    w7 = top_e1 / top_e0 * top_e1_dot + top_e2 / top_e0 * top_e2_dot + top_e3 / top_e0 * top_e3_dot
    w8 = 2 * top_e3
    w9 = w1 * w3
    w10 = 2 * top_e1
    w11 = top_e1 * -2.0
    w12 = w3 * w11
    w13 = w1 * w5
    w14 = (w0 * w3 - w6) * w7 - top_e1_dot * (w3 * w8 - w0 * w5) - top_e2_dot * (w9 - w5 * w10) - top_e3_dot * (w12 - w13)
    w15 = (top_e2 * w10 - w1 * top_e3) * c6
    w16 = w0 * w15
    w17 = w1 * w15
    w18 = w7 * (w4 * w15 - w12) - top_e1_dot * (w16 - w9) - top_e2_dot * (w10 * w15 - w3 * w4) - top_e3_dot * (w17 - w2 * w3)
    w19 = w7 * (w5 * w11 - w16) - top_e1_dot * (w13 - w8 * w15) - top_e2_dot * (w6 - w17) - top_e3_dot * (w2 * w5 - w11 * w15)
    q_d_dot = ca.vertcat(
        w14,
        w18,
        w19,
        -w7,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 151 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    top_e0_dot = q_d_dot[3]
    top_e1_ddot = q_i_ddot[0]
    top_e2_ddot = q_i_ddot[1]
    top_e3_ddot = q_i_ddot[2]
    c6 = c[6]
    w0 = top_e2 * -2.0
    w1 = 2 * top_e0
    w2 = 2 * top_e2
    w3 = (w1 * top_e1 + w2 * top_e3) * c6
    w4 = top_e3 * -2.0
    w5 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w6 = w4 * w5
    w7 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0 + top_e1 / top_e0 * top_e1_ddot
    w8 = w7 + top_e2 / top_e0 * top_e2_ddot + top_e3 / top_e0 * top_e3_ddot
    w9 = 2 * top_e3
    w10 = top_e1 * -2.0
    w11 = w0 * top_e0_dot + top_e1_dot * w9 + w1 * top_e2_dot + top_e3_dot * w10
    w12 = top_e0_dot * w10 + w1 * top_e1_dot + w4 * top_e2_dot + w2 * top_e3_dot
    w13 = 2 * top_e1
    w14 = (top_e2 * w13 - w1 * top_e3) * c6
    w15 = w5 * w12 - w11 * w14
    w16 = w4 * top_e0_dot + w0 * top_e1_dot + top_e2_dot * w13 + w1 * top_e3_dot
    w17 = w14 * w16 - w3 * w12
    w18 = w1 * w3
    w19 = (w0 * w3 - w6) * w8 - (w11 * w15 - w16 * w17) - top_e1_ddot * (w3 * w9 - w0 * w5) - top_e2_ddot * (w18 - w5 * w13)
    w20 = w3 * w10
    w21 = w1 * w5
    w22 = w3 * w11 - w5 * w16
    w23 = w0 * w14
    w24 = w8 * (w4 * w14 - w20) - (w16 * w22 - w12 * w15) - top_e1_ddot * (w23 - w18) - top_e2_ddot * (w13 * w14 - w3 * w4)
    w25 = w1 * w14
    w26 = w8 * (w5 * w10 - w23) - (w12 * w17 - w11 * w22) - top_e1_ddot * (w21 - w9 * w14) - top_e2_ddot * (w6 - w25)
    q_d_ddot = ca.vertcat(
        w19 - top_e3_ddot * (w20 - w21),
        w24 - top_e3_ddot * (w25 - w2 * w3),
        w26 - top_e3_ddot * (w2 * w5 - w10 * w14),
        -w8,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 172 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 24)
    top_x = q[0]
    top_y = q[1]
    top_z = q[2]
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    top_e0_dot = q_dot[3]
    top_e1_dot = q_dot[4]
    top_e2_dot = q_dot[5]
    top_e3_dot = q_dot[6]
    c6 = c[6]
    w0 = 2 * top_e1
    w1 = 2 * top_e0
    w2 = (w0 * top_e2 - w1 * top_e3) * c6
    w3 = top_e1**2
    w4 = top_e3**2
    w5 = (1.0 - 2 * w3 - 2 * w4) * c6
    w6 = 2 * top_e2
    w7 = (top_e1 * w1 + top_e3 * w6) * c6
    w8 = top_e2 * -2.0
    w9 = top_e3 * -2.0
    w10 = w5 * w9
    w11 = top_e1 * -2.0
    w12 = w7 * w11
    w13 = w2 * w8
    w14 = 2 * top_e3
    w15 = w1 * w7
    w16 = w1 * w5
    w17 = w1 * w2
    w18 = w8 * top_e0_dot + w14 * top_e1_dot + w1 * top_e2_dot + w11 * top_e3_dot
    w19 = w11 * top_e0_dot + w1 * top_e1_dot + w9 * top_e2_dot + w6 * top_e3_dot
    w20 = w5 * w19 - w2 * w18
    w21 = w9 * top_e0_dot + w8 * top_e1_dot + w0 * top_e2_dot + w1 * top_e3_dot
    w22 = w2 * w21 - w7 * w19
    w23 = w7 * w18 - w5 * w21
    C = ca.vertcat(
        top_x + w2,
        top_y + w5,
        top_z + w7,
        (w4 + (w3 + top_e0**2 + top_e2**2) - 1.0) / 2.0,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        w7 * w8 - w10,
        w2 * w9 - w12,
        w5 * w11 - w13,
        top_e0,
        w7 * w14 - w5 * w8,
        w13 - w15,
        w16 - w2 * w14,
        top_e1,
        w15 - w0 * w5,
        w0 * w2 - w7 * w9,
        w10 - w17,
        top_e2,
        w12 - w16,
        w17 - w6 * w7,
        w5 * w6 - w2 * w11,
        top_e3,
    )
    C_q = ca.reshape(C_q, 4, 7)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
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
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        -(w18 * w20 - w21 * w22),
        -(w21 * w23 - w19 * w20),
        -(w19 * w22 - w18 * w23),
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 381 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 24)
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    top_e0_dot = q_dot[3]
    top_e1_dot = q_dot[4]
    top_e2_dot = q_dot[5]
    top_e3_dot = q_dot[6]
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
    c13 = c[13]
    c14 = c[14]
    w0 = top_e1 * -2.0
    w1 = top_e2 * -2.0
    w2 = top_e3 * -2.0
    w3 = 2 * top_e0
    w4 = w3 * c2
    w5 = 2 * top_e2
    w6 = w0 * w4 + top_e2 * top_e3 * c8
    w7 = 2 * top_e3
    w8 = w3 * c4
    w9 = w0 * c5
    w10 = w1 * w8 + top_e1 * top_e3 * c10
    w11 = w1 * c2
    w12 = 2 * top_e1
    w13 = w12 * c4
    w14 = w3 * c5
    w15 = top_e1 * top_e2 * c12 + w2 * w14
    w16 = top_e3 * top_e0 * c9 + w5 * w9
    w17 = w2 * w13 + top_e2 * top_e0 * c11
    w18 = w7 * w11 + top_e1 * top_e0 * c13
    w19 = w2 * top_e0_dot
    w20 = w3 * top_e3_dot
    w21 = w19 + w5 * top_e1_dot + w0 * top_e2_dot + w20
    w22 = w21 * c1
    w23 = w1 * top_e0_dot
    w24 = w3 * top_e2_dot
    w25 = w23 + w2 * top_e1_dot + w24 + w12 * top_e3_dot
    w26 = w25 * c0
    w27 = w22 * w25 - w21 * w26
    w28 = w0 * top_e0_dot + w3 * top_e1_dot
    w29 = w28 + w7 * top_e2_dot + w1 * top_e3_dot
    w30 = w29 * c3
    w31 = w21 * w30 - w22 * w29
    w32 = w26 * w29 - w25 * w30
    w33 = w0 * w27 + w1 * w31 + w2 * w32
    w34 = w3 * w27 + w2 * w31 + w5 * w32
    w35 = w7 * w27 + w3 * w31 + w0 * w32
    w36 = w1 * w27 + w12 * w31 + w3 * w32
    w37 = (top_e1 * w3 + top_e3 * w5) * c6
    w38 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w39 = w2 * w38
    w40 = (top_e2 * w12 - top_e3 * w3) * c6
    w41 = w0 * w37
    w42 = w1 * w40
    w43 = w3 * w37
    w44 = w3 * w38
    w45 = w3 * w40
    w46 = w24 + (w23 + w7 * top_e1_dot) + w0 * top_e3_dot
    w47 = w28 + w2 * top_e2_dot + w5 * top_e3_dot
    w48 = w38 * w47 - w40 * w46
    w49 = w20 + (w19 + w1 * top_e1_dot + w12 * top_e2_dot)
    w50 = w40 * w49 - w37 * w47
    w51 = w37 * w46 - w38 * w49
    M = ca.vertcat(
        c7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * (w0 * c2) + w1 * (w1 * c4) + w2 * (w2 * c5),
        w6,
        w10,
        w15,
        0.0,
        0.0,
        0.0,
        w6,
        w3 * w4 + w2 * (w2 * c4) + w5 * (w5 * c5),
        w16,
        w17,
        0.0,
        0.0,
        0.0,
        w10,
        w16,
        w7 * (w7 * c2) + w3 * w8 + w0 * w9,
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
        w33,
        w34,
        w35,
        w36,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        0.0,
        c14,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        0.0,
        0.0,
        c14,
        w33,
        w34,
        w35,
        w36,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        w1 * w37 - w39,
        w2 * w40 - w41,
        w0 * w38 - w42,
        top_e0,
        w7 * w37 - w1 * w38,
        w42 - w43,
        w44 - w7 * w40,
        top_e1,
        w43 - w12 * w38,
        w12 * w40 - w2 * w37,
        w39 - w45,
        top_e2,
        w41 - w44,
        w45 - w5 * w37,
        w5 * w38 - w0 * w40,
        top_e3,
    )
    C_q = ca.reshape(C_q, 4, 7)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        -(w46 * w48 - w49 * w50),
        -(w49 * w51 - w47 * w48),
        -(w47 * w50 - w46 * w51),
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 154 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 24)
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    top_e0_dot = q_dot[3]
    top_e1_dot = q_dot[4]
    top_e2_dot = q_dot[5]
    top_e3_dot = q_dot[6]
    top_x_ddot = q_ddot[0]
    top_y_ddot = q_ddot[1]
    top_z_ddot = q_ddot[2]
    top_e0_ddot = q_ddot[3]
    top_e1_ddot = q_ddot[4]
    top_e2_ddot = q_ddot[5]
    top_e3_ddot = q_ddot[6]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    c14 = c[14]
    w0 = top_x_ddot * c7
    w1 = top_y_ddot * c7
    w2 = c14 - top_z_ddot * c7
    w3 = top_e1 * -2.0
    w4 = top_e3 * -2.0
    w5 = 2 * top_e2
    w6 = 2 * top_e0
    w7 = top_e0_dot * w4 + top_e1_dot * w5 + w3 * top_e2_dot + top_e3_dot * w6
    w8 = w7 * c1
    w9 = top_e2 * -2.0
    w10 = 2 * top_e1
    w11 = top_e0_dot * w9 + w4 * top_e1_dot + top_e2_dot * w6 + top_e3_dot * w10
    w12 = w11 * c0
    w13 = w3 * top_e0_dot + top_e1_dot * w6 + top_e2_dot * (2 * top_e3) + top_e3_dot * w9
    w14 = w13 * c3
    w15 = (w3 * (w3 * c2) + w9 * (w9 * c4) + w4 * (w4 * c5)) * top_e0_ddot + (w3 * (w6 * c2) + top_e3 * top_e2 * c8) * top_e1_ddot
    w16 = w15 + (w9 * (w6 * c4) + top_e1 * top_e3 * c10) * top_e2_ddot + (top_e1 * top_e2 * c12 + w4 * (w6 * c5)) * top_e3_ddot
    w17 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w18 = (top_e2 * w10 - top_e3 * w6) * c6
    w19 = w3 * (w8 * w11 - w7 * w12) + w9 * (w7 * w14 - w8 * w13) + w4 * (w12 * w13 - w11 * w14) - w16 - w2 * (w3 * w17 - w9 * w18)
    w20 = (top_e1 * w6 + top_e3 * w5) * c6
    lam = ca.vertcat(
        -w0,
        -w1,
        w2,
        (w19 + w1 * (w4 * w18 - w3 * w20) + w0 * (w9 * w20 - w4 * w17)) / top_e0,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        w0,
        w1,
        -w2,
        0.0,
        0.0,
        0.0,
    )
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 140 operations."""
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 24)
    top_z = q[2]
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    top_x_dot = q_dot[0]
    top_y_dot = q_dot[1]
    top_z_dot = q_dot[2]
    top_e0_dot = q_dot[3]
    top_e1_dot = q_dot[4]
    top_e2_dot = q_dot[5]
    top_e3_dot = q_dot[6]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c16 = c[16]
    w0 = top_e1 * -2.0
    w1 = top_e2 * -2.0
    w2 = top_e3 * -2.0
    w3 = 2 * top_e0
    w4 = w3 * c2
    w5 = 2 * top_e2
    w6 = w0 * w4 + top_e2 * top_e3 * c8
    w7 = 2 * top_e3
    w8 = w3 * c4
    w9 = w0 * c5
    w10 = w1 * w8 + top_e1 * top_e3 * c10
    w11 = top_e0_dot * (w0 * (w0 * c2) + w1 * (w1 * c4) + w2 * (w2 * c5)) + w6 * top_e1_dot + w10 * top_e2_dot
    w12 = w1 * c2
    w13 = 2 * top_e1
    w14 = w13 * c4
    w15 = w3 * c5
    w16 = top_e1 * top_e2 * c12 + w2 * w15
    w17 = top_x_dot * (top_x_dot * c7) + top_y_dot * (top_y_dot * c7) + top_z_dot * (top_z_dot * c7) + top_e0_dot * (w11 + w16 * top_e3_dot)
    w18 = top_e3 * top_e0 * c9 + w5 * w9
    w19 = w2 * w14 + top_e2 * top_e0 * c11
    w20 = top_e0_dot * w6 + top_e1_dot * (w3 * w4 + w2 * (w2 * c4) + w5 * (w5 * c5)) + top_e2_dot * w18 + top_e3_dot * w19
    w21 = w7 * w12 + top_e1 * top_e0 * c13
    w22 = top_e0_dot * w10 + top_e1_dot * w18 + top_e2_dot * (w7 * (w7 * c2) + w3 * w8 + w0 * w9) + top_e3_dot * w21
    w23 = top_e0_dot * w16 + top_e1_dot * w19 + top_e2_dot * w21 + top_e3_dot * (w1 * w12 + w13 * w14 + w3 * w15)
    kinetic = ca.vertcat(
        (w17 + top_e1_dot * w20 + top_e2_dot * w22 + top_e3_dot * w23) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        top_z * c16,
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
    top_x = q[0]
    top_y = q[1]
    top_z = q[2]
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    w0 = 2 * top_e2**2
    w1 = 2 * top_e3**2
    w2 = 2 * top_e0
    w3 = top_e3 * w2
    w4 = 2 * top_e1
    w5 = top_e2 * w4
    w6 = top_e3 * w4
    w7 = top_e2 * w2
    w8 = 1.0 - 2 * top_e1**2
    w9 = w2 * top_e1
    w10 = top_e3 * (2 * top_e2)
    poses = ca.vertcat(
        top_x,
        top_y,
        top_z,
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
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 1161 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    top_e0_dot = q_d_dot[3]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    c14 = c[14]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    w0 = 2 * top_e0
    w1 = top_e2 * -2.0
    w2 = top_e0_dot * w1
    w3 = top_e3 * -2.0
    w4 = w0 * top_e2_dot
    w5 = 2 * top_e1
    w6 = w2 + top_e1_dot * w3 + w4 + top_e3_dot * w5
    w7 = top_e2_dot * -2.0
    w8 = w7 * c1
    w9 = top_e0_dot * w3
    w10 = 2 * top_e2
    w11 = top_e1 * -2.0
    w12 = w0 * top_e3_dot
    w13 = w9 + top_e1_dot * w10 + top_e2_dot * w11 + w12
    w14 = w13 * c1
    w15 = 2 * top_e3_dot
    w16 = w15 * c0
    w17 = w6 * c0
    w18 = w6 * w8 + w14 * w15 - (w13 * w16 + w7 * w17)
    w19 = top_e0_dot * -2.0
    w20 = w19 * c3
    w21 = top_e0_dot * w11 + w0 * top_e1_dot
    w22 = 2 * top_e3
    w23 = w21 + top_e2_dot * w22 + w1 * top_e3_dot
    w24 = w23 * c3
    w25 = w14 * w19
    w26 = w13 * w20 + w7 * w24 - (w8 * w23 + w25)
    w27 = w17 * w19
    w28 = w15 * w24
    w29 = w16 * w23 + w27 - (w6 * w20 + w28)
    w30 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w31 = w0 * c2
    w32 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w33 = w0 * w32
    w34 = (top_e2 * w5 - w0 * top_e3) * c6
    w35 = w33 - w22 * w34
    w36 = w32 * -2.0
    w37 = top_e1 * c23
    w38 = w10 * c6
    w39 = w1 * w38
    w40 = w36 - w11 * w37 - w39
    w41 = w12 + (w9 + w1 * top_e1_dot + top_e2_dot * w5)
    w42 = w21 + w3 * top_e2_dot + top_e3_dot * w10
    w43 = (w0 * top_e1 + top_e3 * w10) * c6
    w44 = w34 * w41 - w42 * w43
    w45 = w19 * w44
    w46 = 2 * top_e2_dot
    w47 = w34 * w46
    w48 = w19 * w43
    w49 = w0 * c6
    w50 = w47 + w38 * w41 - (w48 + w42 * w49)
    w51 = w4 + (w2 + top_e1_dot * w22) + top_e3_dot * w11
    w52 = w43 * w51 - w32 * w41
    w53 = top_e3_dot * -2.0
    w54 = w49 * w51
    w55 = w43 * w53 + w54 - (w32 * w46 - w37 * w41)
    w56 = (w30 * w40 - (w45 + w42 * w50 - (w52 * w53 + w51 * w55))) * c7
    w57 = w1 * w34
    w58 = w11 * w32 - w57
    w59 = c14 - (w30 * w58 - (w42 * w44 - w51 * w52)) * c7
    w60 = w0 * w37
    w61 = w22 * w38
    w62 = w0 * w43
    w63 = w57 - w62
    w64 = w3 * w38
    w65 = w43 * -2.0
    w66 = w11 * w49
    w67 = w65 + w66
    w68 = w64 - w67
    w69 = w46 * w52
    w70 = w32 * w42 - w34 * w51
    w71 = w19 * w70
    w72 = w19 * w32
    w73 = w38 * w51
    w74 = w72 - w37 * w42 - (w34 * w53 + w73)
    w75 = (w30 * w68 - (w69 + w41 * w55 - (w71 + w42 * w74))) * c7
    w76 = w11 * w43
    w77 = w3 * w34 - w76
    w78 = (w30 * w77 - (w41 * w52 - w42 * w70)) * c7
    w79 = w0 * w49
    w80 = w0 * w18 + w3 * w26 + w10 * w29 + w30 * (w31 * -2.0) + (w35 * w56 + w59 * (w60 + w61)) + (w63 * w75 + w78 * (w39 - w79))
    w81 = w22 * w43 - w1 * w32
    w82 = w1 * w49
    w83 = w3 * w37
    w84 = w82 + w83
    w85 = (w30 * w84 - (w53 * w70 + w51 * w74 - (w44 * w46 + w41 * w50))) * c7
    w86 = w3 * w32
    w87 = w1 * w43 - w86
    w88 = (w30 * w87 - (w51 * w70 - w41 * w44)) * c7
    w89 = w22 * w49
    w90 = top_e1 / top_e0
    w91 = w6 * w14 - w13 * w17
    w92 = w91 * -2.0
    w93 = w11 * c2
    w94 = w11 * c20
    w95 = w92 + w11 * w18 + w1 * w26 + w3 * w29 + w30 * (w93 * -2.0 + w94) - (w40 * w59 - w56 * w58) + (w75 * w77 + w68 * w78)
    w96 = w95 + (w85 * w87 + w84 * w88)
    w97 = w13 * w24 - w14 * w23
    w98 = w17 * w23 - w6 * w24
    w99 = w1 * c4
    w100 = w3 * c5
    w101 = w11 * w93 + w1 * w99 + w3 * w100
    w102 = w11 * w91 + w1 * w97 + w3 * w98 + w30 * w101 - w58 * w59 + w77 * w78 + w87 * w88
    w103 = w102 / top_e0
    w104 = 2 * w91
    w105 = w15 * c1
    w106 = w14 * w46
    w107 = w46 * c0
    w108 = w6 * w105 + w106 - (w13 * w107 + w15 * w17)
    w109 = 2 * top_e1_dot
    w110 = w109 * c3
    w111 = w28 + w13 * w110 - (w23 * w105 + w14 * w109)
    w112 = w17 * w109
    w113 = w23 * w107 + w112 - (w6 * w110 + w24 * w46)
    w114 = w11 * c17
    w115 = w11 * w31 + top_e2 * top_e3 * c8
    w116 = w30 / top_e0
    w117 = 2 * w32
    w118 = w22 * c6
    w119 = w22 * w118
    w120 = w1 * w118
    w121 = w43 * w109
    w122 = w5 * c6
    w123 = w15 * w34 - w41 * w118 - (w121 + w42 * w122)
    w124 = w51 * w122
    w125 = w15 * w32
    w126 = w43 * w46 + w124 - w125
    w127 = (w30 * w120 - w58 * w116 - (w44 * w109 + w42 * w123 - (w69 + w51 * w126))) * c7
    w128 = w104 + w0 * w108 + w3 * w111 + w10 * w113 + (w30 * w114 - w115 * w116) - (w59 * (w117 + w119) - w35 * w127)
    w129 = w3 * w118
    w130 = w11 * w122
    w131 = w129 + w130
    w132 = w70 * w109
    w133 = w51 * w118
    w134 = w32 * w109 - (w47 - w133)
    w135 = (w30 * w131 + w77 * w116 + (w15 * w52 + w41 * w126 - (w132 + w42 * w134))) * c7
    w136 = 2 * w43
    w137 = w0 * w122
    w138 = w136 + w137
    w139 = w1 * w122
    w140 = w15 * w44
    w141 = (w30 * w139 - w87 * w116 - (w46 * w70 + w51 * w134 - (w140 + w41 * w123))) * c7
    w142 = w22 * w122
    w143 = w11 * w108 + w1 * w111 + w3 * w113 - w101 * w116 - (w59 * w120 - w58 * w127) - (w77 * w135 + w78 * w131)
    w144 = w143 + (w87 * w141 + w88 * w139)
    w145 = w90 / top_e0
    w146 = w128 - (w63 * w135 + w78 * (w120 + w138)) + (w81 * w141 + w88 * w142) - (w90 * w144 - w102 * w145)
    w147 = w3 * c1
    w148 = w1 * c0
    w149 = w6 * w147 + w1 * w14 - (w13 * w148 + w3 * w17)
    w150 = w11 * c3
    w151 = w13 * w150 + w3 * w24 - (w23 * w147 + w11 * w14)
    w152 = w23 * w148 + w11 * w17 - (w6 * w150 + w1 * w24)
    w153 = 2 * top_e0_dot / top_e0
    w154 = (w58 * w153 - (w11 * w44 + w42 * w77 - (w1 * w52 + w51 * w87))) * c7
    w155 = (w77 * w153 - (w3 * w52 + w41 * w87 - (w11 * w70 + w42 * w58))) * c7
    w156 = (w87 * w153 - (w1 * w70 + w51 * w58 - (w3 * w44 + w41 * w77))) * c7
    w157 = w11 * w149 + w1 * w151 + w3 * w152 + w101 * w153 + w58 * w154 + w77 * w155 + w87 * w156
    w158 = w0 * w149 + w3 * w151 + w10 * w152 + w115 * w153 + w35 * w154 + w63 * w155 + w81 * w156 - w90 * w157
    w159 = top_e2 / top_e0
    w160 = w159 / top_e0
    w161 = top_e3 / top_e0
    w162 = w161 / top_e0
    w163 = top_e1_dot * w145 + top_e2_dot * w160 + top_e3_dot * w162
    w164 = top_e1_dot / top_e0 + w90 * w163
    w165 = w98 * -2.0
    w166 = w3 * c21
    w167 = w0 * w34
    w168 = w86 - w167
    w169 = w0 * w38
    w170 = w18 * w22 + w0 * w26 + (w165 + w11 * w29) + w30 * (w22 * c2 * -2.0 + w166) + (w56 * w168 + w59 * (w83 + w169))
    w171 = w5 * w34 - w3 * w43
    w172 = 2 * w34
    w173 = w3 * w49
    w174 = w62 - w5 * w32
    w175 = w170 + (w75 * w171 + w78 * (w172 + w5 * w38 - w173)) + (w85 * w174 + w88 * (w79 - (w117 - w5 * w37)))
    w176 = 2 * w97
    w177 = w1 * c22
    w178 = w0 * c4
    w179 = w1 * w178 + top_e3 * top_e1 * c10
    w180 = w0 * w118
    w181 = w172 - w180
    w182 = w22 * w108 + (w176 + w0 * w111) + w11 * w113 + (w30 * w177 - w116 * w179) + (w127 * w168 + w59 * w181)
    w183 = w3 * w122
    w184 = w182 - (w135 * w171 + w78 * (w5 * w118 + w183)) + (w141 * w174 + w88 * w138) - (w144 * w159 - w102 * w160)
    w185 = w22 * w149 + w0 * w151 + w11 * w152 + w153 * w179 + w154 * w168 + w155 * w171 + w156 * w174 - w157 * w159
    w186 = w10 * w32 - w11 * w34
    w187 = w34 * -2.0
    w188 = w11 * w38
    w189 = w1 * w18 + (w176 + w5 * w26) + w0 * w29 + w30 * (w177 + w1 * c2 * -2.0) + (w56 * w186 + w59 * (w10 * w37 + (w187 + w188)))
    w190 = w167 - w10 * w43
    w191 = w76 - w33
    w192 = 2 * w98
    w193 = w3 * c19
    w194 = w0 * c5
    w195 = top_e2 * top_e1 * c12 + w3 * w194
    w196 = w11 * w118
    w197 = w1 * w108 + w5 * w111 + (w192 + w0 * w113) + (w30 * w193 - w116 * w195) - (w59 * w196 - w127 * w186)
    w198 = w197 + (w78 * (w181 - w10 * w122) - w135 * w190) + (w141 * w191 + w88 * (w130 - w117)) - (w144 * w161 - w102 * w162)
    w199 = w189 + (w75 * w190 + w78 * (w169 - w10 * w49)) + (w85 * w191 + w88 * (w60 + w67)) - w96 * w161 - w90 * w198
    w200 = w1 * w149 + w5 * w151 + w0 * w152 + w153 * w195 + w154 * w186 + w155 * w190 + w156 * w191 - w157 * w161
    w201 = w109 * c1
    w202 = w19 * c0
    w203 = w25 + w6 * w201 - (w112 + w13 * w202)
    w204 = w53 * c3
    w205 = w13 * w204 + w24 * w109 - (w23 * w201 + w14 * w53)
    w206 = w19 * w24
    w207 = w23 * w202 + w17 * w53 - (w6 * w204 + w206)
    w208 = w139 + w187
    w209 = top_e1_dot * -2.0
    w210 = w34 * w209 + w41 * w122 - (w15 * w43 + w42 * w118)
    w211 = w19 * w52
    w212 = w48 + w133 - w32 * w209
    w213 = (w30 * w208 + (w140 + w42 * w210 - (w211 + w51 * w212))) * c7
    w214 = w0 * w203 + w3 * w205 + (w192 + w10 * w207) + w30 * (w193 + w3 * c4 * -2.0) - (w35 * w213 - w59 * w142)
    w215 = w183 - w196
    w216 = w19 * w34
    w217 = w125 - (w124 + w216)
    w218 = (w30 * w215 - (w52 * w209 + w41 * w212 - (w15 * w70 + w42 * w217))) * c7
    w219 = w65 + w120
    w220 = (w30 * w219 - (w71 + w51 * w217 - (w44 * w209 + w41 * w210))) * c7
    w221 = w97 * -2.0
    w222 = w1 * c18
    w223 = w11 * w203 + (w221 + w1 * w205) + w3 * w207 + w30 * (w99 * -2.0 + w222) - (w58 * w213 - w59 * w208)
    w224 = w223 + (w77 * w218 + w78 * w215) + (w87 * w220 + w88 * w219)
    w225 = w214 + (w63 * w218 + w78 * (w208 - w180)) + (w81 * w220 + w88 * (w119 - w36)) - w90 * w224 - w146 * w159
    w226 = top_e2_dot / top_e0 + w159 * w163
    w227 = w22 * w203 + w0 * w205 + w11 * w207 + w30 * (w178 * -2.0) - (w168 * w213 - w59 * w137) + (w171 * w218 + w78 * (w5 * w122 - w129))
    w228 = w92 + w1 * w203 + w5 * w205 + w0 * w207 + w30 * (w94 + w5 * c4 * -2.0) - (w186 * w213 + w59 * (w117 - w130))
    w229 = w228 + (w190 * w218 + w78 * (w137 - (w136 + w10 * w118))) + (w191 * w220 + w88 * w196) - w161 * w224
    w230 = w19 * c1
    w231 = w209 * c0
    w232 = w6 * w230 + w14 * w209 - (w27 + w13 * w231)
    w233 = w46 * c3
    w234 = w206 + w13 * w233 - (w106 + w23 * w230)
    w235 = w23 * w231 + w17 * w46 - (w6 * w233 + w24 * w209)
    w236 = top_e3 * c23
    w237 = w82 - w11 * w236
    w238 = w216 - w41 * w49 - (w7 * w43 + w38 * w42)
    w239 = w73 + w121 - (w72 - w41 * w236)
    w240 = (w30 * w237 - (w7 * w44 + w42 * w238 - (w52 * w109 + w51 * w239))) * c7
    w241 = w0 * w236
    w242 = w0 * w232 + (w221 + w3 * w234) + w10 * w235 + w30 * (w222 + w10 * c5 * -2.0) + (w35 * w240 + w59 * (w241 + (w172 - w89)))
    w243 = w187 - w173 - w188
    w244 = w7 * w32 - w42 * w236 - (w34 * w109 - w54)
    w245 = (w30 * w243 - (w211 + w41 * w239 - (w7 * w70 + w42 * w244))) * c7
    w246 = w36 - w3 * w236
    w247 = w39 - w246
    w248 = (w30 * w247 - (w132 + w51 * w244 - (w45 + w41 * w238))) * c7
    w249 = w11 * w232 + w1 * w234 + (w165 + w3 * w235) + w30 * (w166 + w100 * -2.0) - (w59 * w237 - w58 * w240)
    w250 = w249 + (w77 * w245 + w78 * w243) + (w87 * w248 + w88 * w247)
    w251 = w242 + (w63 * w245 - w78 * (w82 + w169)) + (w81 * w248 + w88 * (w61 + w136 + w1 * w236)) - w90 * w250
    w252 = top_e3_dot / top_e0 + w161 * w163
    w253 = w104 + w22 * w232 + w0 * w234 + w11 * w235 + w30 * (w114 + w11 * c5 * -2.0) - (w59 * (w79 + w246) - w168 * w240)
    w254 = w253 + (w171 * w245 - w78 * (w5 * w49 + (w64 + w65))) + (w174 * w248 + w88 * (w169 + w5 * w236)) - w159 * w250
    w255 = w1 * w232 + w5 * w234 + w0 * w235 + w30 * (w194 * -2.0) - (w59 * (w66 - w10 * w236) - w186 * w240)
    w256 = w255 + (w190 * w245 - w78 * (w79 + w10 * w38)) + (w191 * w248 + w88 * (w188 + w241)) - (w103 + w161 * w250)
    dQ_hat_dq_i = ca.vertcat(
        w80 + (w81 * w85 + w88 * (w89 + w1 * w37)) - (w90 * w96 + w103) - w90 * w146 - w158 * w164,
        w175 - w96 * w159 - w90 * w184 - w164 * w185,
        w199 - w164 * w200,
        w225 - w158 * w226,
        w227 + (w174 * w220 + w88 * w180) - (w103 + w159 * w224) - w159 * w184 - w185 * w226,
        w229 - w159 * w198 - w200 * w226,
        w251 - w146 * w161 - w158 * w252,
        w254 - w161 * w184 - w185 * w252,
        w256 - w161 * w198 - w200 * w252,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 3, 3)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 559 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    w0 = 2 * top_e0
    w1 = top_e3 * -2.0
    w2 = top_e1 / top_e0
    w3 = top_e2 / top_e0
    w4 = top_e3 / top_e0
    w5 = top_e1_dot * w2 + w3 * top_e2_dot + w4 * top_e3_dot
    w6 = top_e2 * -2.0
    w7 = w5 * w6
    w8 = w0 * top_e2_dot
    w9 = 2 * top_e1
    w10 = top_e1_dot * w1 - w7 + w8 + top_e3_dot * w9
    w11 = 2 * top_e2
    w12 = w1 * w2
    w13 = w11 - w12
    w14 = w13 * c1
    w15 = w1 * w5
    w16 = top_e1 * -2.0
    w17 = w0 * top_e3_dot
    w18 = top_e1_dot * w11 - w15 + top_e2_dot * w16 + w17
    w19 = w18 * c1
    w20 = w2 * w6
    w21 = w1 - w20
    w22 = w21 * c0
    w23 = w10 * c0
    w24 = w10 * w14 + w19 * w21 - (w18 * w22 + w13 * w23)
    w25 = w0 - w2 * w16
    w26 = w25 * c3
    w27 = w0 * top_e1_dot - w5 * w16
    w28 = 2 * top_e3
    w29 = w27 + top_e2_dot * w28 + top_e3_dot * w6
    w30 = w29 * c3
    w31 = w18 * w26 + w13 * w30 - (w14 * w29 + w19 * w25)
    w32 = w22 * w29 + w23 * w25 - (w10 * w26 + w21 * w30)
    w33 = w16 * (w0 * c2) + top_e3 * top_e2 * c8
    w34 = 2 * w5
    w35 = (w2 * w34 + 2 * top_e1_dot) / top_e0
    w36 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w37 = w0 * w36
    w38 = (top_e2 * w9 - w0 * top_e3) * c6
    w39 = w37 - w28 * w38
    w40 = w6 * w38
    w41 = w16 * w36 - w40
    w42 = w17 + (top_e1_dot * w6 - w15 + top_e2_dot * w9)
    w43 = w27 + w1 * top_e2_dot + top_e3_dot * w11
    w44 = (w0 * top_e1 + top_e3 * w11) * c6
    w45 = w38 * w42 - w43 * w44
    w46 = w6 - w12
    w47 = w38 * w46 - w25 * w44
    w48 = w8 + (top_e1_dot * w28 - w7) + top_e3_dot * w16
    w49 = w44 * w48 - w36 * w42
    w50 = w28 - w20
    w51 = w44 * w50 - w36 * w46
    w52 = (w35 * w41 - (w25 * w45 + w43 * w47 - (w49 * w50 + w48 * w51))) * c7
    w53 = w0 * w44
    w54 = w40 - w53
    w55 = w16 * w44
    w56 = w1 * w38 - w55
    w57 = w36 * w43 - w38 * w48
    w58 = w25 * w36 - w38 * w50
    w59 = (w35 * w56 - (w46 * w49 + w42 * w51 - (w25 * w57 + w43 * w58))) * c7
    w60 = w28 * w44 - w6 * w36
    w61 = w1 * w36
    w62 = w6 * w44 - w61
    w63 = (w35 * w62 - (w50 * w57 + w48 * w58 - (w45 * w46 + w42 * w47))) * c7
    w64 = w16 * (w16 * c2) + w6 * (w6 * c4) + w1 * (w1 * c5)
    w65 = w16 * w24 + w6 * w31 + w1 * w32 + w35 * w64 + w41 * w52 + w56 * w59 + w62 * w63
    w66 = w6 * (w0 * c4) + top_e3 * top_e1 * c10
    w67 = w0 * w38
    w68 = w61 - w67
    w69 = w9 * w38 - w1 * w44
    w70 = w53 - w9 * w36
    w71 = top_e1 * top_e2 * c12 + w1 * (w0 * c5)
    w72 = w11 * w36 - w16 * w38
    w73 = w67 - w11 * w44
    w74 = w55 - w37
    w75 = w1 * w3
    w76 = w16 - w75
    w77 = w76 * c1
    w78 = w0 - w3 * w6
    w79 = w78 * c0
    w80 = w10 * w77 + w19 * w78 - (w18 * w79 + w23 * w76)
    w81 = w3 * w16
    w82 = w28 - w81
    w83 = w82 * c3
    w84 = w18 * w83 + w30 * w76 - (w29 * w77 + w19 * w82)
    w85 = w29 * w79 + w23 * w82 - (w10 * w83 + w30 * w78)
    w86 = (w3 * w34 + 2 * top_e2_dot) / top_e0
    w87 = w1 - w81
    w88 = w9 - w75
    w89 = w38 * w88 - w44 * w87
    w90 = w44 * w78 - w36 * w88
    w91 = (w41 * w86 - (w45 * w87 + w43 * w89 - (w49 * w78 + w48 * w90))) * c7
    w92 = w36 * w87 - w38 * w78
    w93 = (w56 * w86 - (w49 * w88 + w42 * w90 - (w57 * w87 + w43 * w92))) * c7
    w94 = (w62 * w86 - (w57 * w78 + w48 * w92 - (w45 * w88 + w42 * w89))) * c7
    w95 = w16 * w80 + w6 * w84 + w1 * w85 + w64 * w86 + w41 * w91 + w56 * w93 + w62 * w94
    w96 = w0 - w1 * w4
    w97 = w96 * c1
    w98 = w4 * w6
    w99 = w9 - w98
    w100 = w99 * c0
    w101 = w10 * w97 + w19 * w99 - (w18 * w100 + w23 * w96)
    w102 = w4 * w16
    w103 = w6 - w102
    w104 = w103 * c3
    w105 = w18 * w104 + w30 * w96 - (w29 * w97 + w19 * w103)
    w106 = w29 * w100 + w23 * w103 - (w10 * w104 + w30 * w99)
    w107 = (w4 * w34 + 2 * top_e3_dot) / top_e0
    w108 = w11 - w102
    w109 = w38 * w96 - w44 * w108
    w110 = w16 - w98
    w111 = w44 * w110 - w36 * w96
    w112 = (w41 * w107 - (w45 * w108 + w43 * w109 - (w49 * w110 + w48 * w111))) * c7
    w113 = w36 * w108 - w38 * w110
    w114 = (w56 * w107 - (w49 * w96 + w42 * w111 - (w57 * w108 + w43 * w113))) * c7
    w115 = (w62 * w107 - (w57 * w110 + w48 * w113 - (w45 * w96 + w42 * w109))) * c7
    w116 = w16 * w101 + w6 * w105 + w1 * w106 + w64 * w107 + w41 * w112 + w56 * w114 + w62 * w115
    w117 = w0 * w101 + w1 * w105 + w11 * w106 + w33 * w107 + w39 * w112 + w54 * w114 + w60 * w115 - w2 * w116
    w118 = w28 * w101 + w0 * w105 + w16 * w106 + w66 * w107 + w68 * w112 + w69 * w114 + w70 * w115 - w3 * w116
    w119 = w6 * w101 + w9 * w105 + w0 * w106 + w71 * w107 + w72 * w112 + w73 * w114 + w74 * w115 - w4 * w116
    dQ_hat_dq_i_dot = ca.vertcat(
        w0 * w24 + w1 * w31 + w11 * w32 + w33 * w35 + w39 * w52 + w54 * w59 + w60 * w63 - w2 * w65,
        w24 * w28 + w0 * w31 + w16 * w32 + w35 * w66 + w52 * w68 + w59 * w69 + w63 * w70 - w3 * w65,
        w6 * w24 + w9 * w31 + w0 * w32 + w35 * w71 + w52 * w72 + w59 * w73 + w63 * w74 - w4 * w65,
        w0 * w80 + w1 * w84 + w11 * w85 + w33 * w86 + w39 * w91 + w54 * w93 + w60 * w94 - w2 * w95,
        w28 * w80 + w0 * w84 + w16 * w85 + w66 * w86 + w68 * w91 + w69 * w93 + w70 * w94 - w3 * w95,
        w6 * w80 + w9 * w84 + w0 * w85 + w71 * w86 + w72 * w91 + w73 * w93 + w74 * w94 - w4 * w95,
        w117,
        w118,
        w119,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 3, 3)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 835 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_ddot = q_i_ddot[0]
    top_e2_ddot = q_i_ddot[1]
    top_e3_ddot = q_i_ddot[2]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    w0 = 2 * top_e2
    w1 = w0 * c21
    w2 = top_e1 / top_e0
    w3 = top_e2 / top_e0
    w4 = top_e3 / top_e0
    w5 = w2 * top_e1_ddot + top_e2_ddot * w3 + w4 * top_e3_ddot
    w6 = 2 * top_e0
    w7 = w6 * c2
    w8 = w7 * -2.0
    w9 = top_e1 * -2.0
    w10 = top_e2 * -2.0
    w11 = top_e3 * -2.0
    w12 = w0 * c5
    w13 = w7 * w9 + top_e2 * top_e3 * c8
    w14 = top_e1_ddot / top_e0
    w15 = w11 * c22
    w16 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w17 = w6 * w16
    w18 = 2 * top_e3
    w19 = 2 * top_e1
    w20 = (top_e2 * w19 - top_e3 * w6) * c6
    w21 = w17 - w18 * w20
    w22 = w16 * -2.0
    w23 = top_e1 * c23
    w24 = w0 * c6
    w25 = w10 * w24
    w26 = w22 - w9 * w23 - w25
    w27 = w10 * w20
    w28 = w9 * w16 - w27
    w29 = w6 * w23
    w30 = w18 * w24
    w31 = w29 + w30
    w32 = w11 * w23
    w33 = w6 * w24
    w34 = w32 + w33
    w35 = w20 * -2.0
    w36 = w9 * w24
    w37 = w0 * w23 + (w35 + w36)
    w38 = (w5 * w26 + w14 * w28 + top_e1_ddot * w31 + top_e2_ddot * w34 + top_e3_ddot * w37) * c7
    w39 = w11 * w16
    w40 = w6 * w20
    w41 = w39 - w40
    w42 = w0 * w16 - w9 * w20
    w43 = (w5 * w28 - top_e1_ddot * w21 - top_e2_ddot * w41 - top_e3_ddot * w42) * c7
    w44 = (top_e1 * w6 + w0 * top_e3) * c6
    w45 = w6 * w44
    w46 = w27 - w45
    w47 = w11 * w24
    w48 = w44 * -2.0
    w49 = w6 * c6
    w50 = w9 * w49
    w51 = w48 + w50
    w52 = w47 - w51
    w53 = w9 * w44
    w54 = w11 * w20 - w53
    w55 = w6 * w49
    w56 = w25 - w55
    w57 = 2 * w20
    w58 = w11 * w49
    w59 = w57 + w19 * w24 - w58
    w60 = w33 - w0 * w49
    w61 = (w5 * w52 + w14 * w54 - top_e1_ddot * w56 - top_e2_ddot * w59 - top_e3_ddot * w60) * c7
    w62 = w19 * w20 - w11 * w44
    w63 = w40 - w0 * w44
    w64 = (w5 * w54 - top_e1_ddot * w46 - top_e2_ddot * w62 - top_e3_ddot * w63) * c7
    w65 = top_e2_ddot * w1 - (w5 * w8 + w13 * w14) + top_e3_ddot * w15 - (w21 * w38 - w31 * w43) - (w46 * w61 + w56 * w64)
    w66 = w18 * w44 - w10 * w16
    w67 = w10 * w49
    w68 = w32 + w67
    w69 = w10 * w44 - w39
    w70 = w18 * w49
    w71 = w70 + w10 * w23
    w72 = 2 * w16
    w73 = w55 - (w72 - w19 * w23)
    w74 = w29 + w51
    w75 = (w5 * w68 + w14 * w69 - top_e1_ddot * w71 - top_e2_ddot * w73 - top_e3_ddot * w74) * c7
    w76 = w45 - w16 * w19
    w77 = w53 - w17
    w78 = (w5 * w69 - top_e1_ddot * w66 - top_e2_ddot * w76 - top_e3_ddot * w77) * c7
    w79 = w9 * c2
    w80 = w9 * c20
    w81 = w10 * c4
    w82 = w11 * c5
    w83 = w9 * w79 + w10 * w81 + w11 * w82
    w84 = w18 * c2
    w85 = w11 * c21
    w86 = w84 * -2.0 + w85
    w87 = w10 * c2
    w88 = w87 * -2.0
    w89 = w10 * c22
    w90 = w88 + w89
    w91 = top_e1_ddot * w8 - (w5 * (w79 * -2.0 + w80) + w14 * w83) + top_e2_ddot * w86 + top_e3_ddot * w90 - (w28 * w38 + w26 * w43)
    w92 = w91 - (w54 * w61 + w52 * w64) - (w69 * w75 + w68 * w78)
    w93 = w6 * c4
    w94 = w9 * c5
    w95 = w10 * w93 + top_e1 * top_e3 * c10
    w96 = w19 * c4
    w97 = w6 * c5
    w98 = top_e2 * top_e1 * c12 + w11 * w97
    w99 = top_e1_ddot * w13 - w5 * w83 + top_e2_ddot * w95 + top_e3_ddot * w98 - w28 * w43 - w54 * w64 - w69 * w78
    w100 = w99 / top_e0
    w101 = w6 * c17
    w102 = w9 * c17
    w103 = w2 / top_e0
    w104 = w3 / top_e0
    w105 = w4 / top_e0
    w106 = top_e1_ddot * w103 + top_e2_ddot * w104 + top_e3_ddot * w105
    w107 = 2 * w84
    w108 = w15 + w107
    w109 = 2 * w87
    w110 = w0 * c19
    w111 = w109 + w110
    w112 = top_e1_ddot * (2 * w7 + w101) - (w5 * w102 - w13 * w106) + top_e2_ddot * w108 + top_e3_ddot * w111
    w113 = w18 * c6
    w114 = w10 * w113
    w115 = w18 * w113
    w116 = w72 + w115
    w117 = w6 * w113
    w118 = w57 - w117
    w119 = w9 * w113
    w120 = top_e3_ddot * w119
    w121 = (w5 * w114 - w28 * w106 - top_e1_ddot * w116 + top_e2_ddot * w118 - w120) * c7
    w122 = 2 * w44
    w123 = w19 * c6
    w124 = w6 * w123
    w125 = w122 + w124
    w126 = w114 + w125
    w127 = w11 * w113
    w128 = w9 * w123
    w129 = w127 + w128
    w130 = w11 * w123
    w131 = w19 * w113 + w130
    w132 = w118 - w0 * w123
    w133 = (top_e1_ddot * w126 - (w5 * w129 + w54 * w106) + top_e2_ddot * w131 - top_e3_ddot * w132) * c7
    w134 = w10 * w123
    w135 = w18 * w123
    w136 = top_e1_ddot * w135
    w137 = w128 - w72
    w138 = (w5 * w134 - w69 * w106 - w136 - top_e2_ddot * w125 - top_e3_ddot * w137) * c7
    w139 = w11 * c19
    w140 = top_e1_ddot * w102 + w83 * w106 + top_e2_ddot * w89 + top_e3_ddot * w139 - (w28 * w121 + w43 * w114)
    w141 = w140 - (w54 * w133 - w64 * w129) - (w69 * w138 + w78 * w134)
    w142 = w112 - (w21 * w121 + w43 * w116) - (w46 * w133 - w64 * w126) - (w66 * w138 + w78 * w135) - (w2 * w141 - w99 * w103)
    w143 = w94 * -2.0
    w144 = w6 * c22
    w145 = w97 * -2.0
    w146 = w144 + w145
    w147 = w1 * top_e1_ddot - (w5 * w86 + w14 * w95) + top_e2_ddot * (w143 + w9 * c21) + top_e3_ddot * w146 - (w38 * w41 - w34 * w43)
    w148 = 2 * w96
    w149 = w148 + w9 * c19
    w150 = top_e1_ddot * w108 - (w5 * w89 - w95 * w106) + top_e2_ddot * (w144 + 2 * w93) + top_e3_ddot * w149
    w151 = w150 - (w41 * w121 - w43 * w118) - (w62 * w133 - w64 * w131) - (w76 * w138 + w78 * w125) - (w3 * w141 - w99 * w104)
    w152 = top_e1_ddot * w15 - (w5 * w90 + w14 * w98) + top_e2_ddot * w146 + top_e3_ddot * (w148 + w19 * c22)
    w153 = 2 * w97
    w154 = top_e1_ddot * w111 - (w5 * w139 - w98 * w106) + top_e2_ddot * w149 + top_e3_ddot * (w153 + w6 * c19)
    w155 = w154 - (w42 * w121 + w43 * w119) - (w63 * w133 + w64 * w132) - (w77 * w138 + w78 * w137) - (w4 * w141 - w99 * w105)
    w156 = w152 - (w38 * w42 - w37 * w43) - (w61 * w63 + w60 * w64) - (w75 * w77 + w74 * w78) - w4 * w92 - w2 * w155
    w157 = w11 * c4 * -2.0
    w158 = w139 + w157
    w159 = top_e2_ddot / top_e0
    w160 = 2 * w94
    w161 = w153 + w6 * c20
    w162 = top_e1_ddot * (w110 + 2 * w12) - (w5 * w158 + w13 * w159) + top_e2_ddot * w160 + top_e3_ddot * w161
    w163 = w35 + w134
    w164 = w72 - w128
    w165 = (w136 + (w28 * w159 - w5 * w163) + top_e2_ddot * w124 - top_e3_ddot * w164) * c7
    w166 = w130 - w119
    w167 = w163 - w117
    w168 = w19 * w123 - w127
    w169 = w124 - (w122 + w0 * w113)
    w170 = (w5 * w166 + w54 * w159 - top_e1_ddot * w167 - top_e2_ddot * w168 - top_e3_ddot * w169) * c7
    w171 = w48 + w114
    w172 = w115 - w22
    w173 = (w5 * w171 + w69 * w159 - top_e1_ddot * w172 - top_e2_ddot * w117 - w120) * c7
    w174 = w10 * c18
    w175 = w93 * -2.0
    w176 = w96 * -2.0
    w177 = w80 + w176
    w178 = top_e1_ddot * w158 - (w5 * (w81 * -2.0 + w174) + w83 * w159) + top_e2_ddot * w175 + top_e3_ddot * w177
    w179 = w178 - (w28 * w165 - w43 * w163) - (w54 * w170 + w64 * w166) - (w69 * w173 + w78 * w171)
    w180 = w162 - (w21 * w165 - w43 * w135) - (w46 * w170 + w64 * w167) - (w66 * w173 + w78 * w172) - w2 * w179
    w181 = w18 * c20
    w182 = top_e1_ddot * w160 - (w5 * w175 + w95 * w159) + top_e3_ddot * w181 - (w41 * w165 - w43 * w124) - (w62 * w170 + w64 * w168)
    w183 = top_e1_ddot * w161 - (w5 * w177 + w98 * w159) + top_e2_ddot * w181 + top_e3_ddot * (w88 + w10 * c20)
    w184 = w183 - (w42 * w165 + w43 * w164) - (w63 * w170 + w64 * w169) - (w77 * w173 + w78 * w119) - w4 * w179
    w185 = w174 + w12 * -2.0
    w186 = top_e3_ddot / top_e0
    w187 = w101 + w175
    w188 = top_e1_ddot * (w157 + w11 * c18) - (w5 * w185 + w13 * w186) + top_e2_ddot * w187 + top_e3_ddot * w176
    w189 = top_e3 * c23
    w190 = w67 - w9 * w189
    w191 = w6 * w189
    w192 = w191 + (w57 - w70)
    w193 = w22 - w11 * w189
    w194 = w55 + w193
    w195 = w50 - w0 * w189
    w196 = (w5 * w190 + w28 * w186 + top_e1_ddot * w192 - top_e2_ddot * w194 - top_e3_ddot * w195) * c7
    w197 = w35 - w58 - w36
    w198 = w33 + w67
    w199 = w19 * w49 + (w47 + w48)
    w200 = w55 + w0 * w24
    w201 = (w5 * w197 + w54 * w186 + top_e1_ddot * w198 + top_e2_ddot * w199 + top_e3_ddot * w200) * c7
    w202 = w25 - w193
    w203 = w30 + w122 + w10 * w189
    w204 = w33 + w19 * w189
    w205 = w36 + w191
    w206 = (w5 * w202 + w69 * w186 - top_e1_ddot * w203 - top_e2_ddot * w204 - top_e3_ddot * w205) * c7
    w207 = w102 + w143
    w208 = top_e1_ddot * w185 - (w5 * (w85 + w82 * -2.0) + w83 * w186) + top_e2_ddot * w207 + top_e3_ddot * w145
    w209 = w208 - (w28 * w196 + w43 * w190) - (w54 * w201 + w64 * w197) - (w69 * w206 + w78 * w202)
    w210 = w188 - (w21 * w196 - w43 * w192) - (w46 * w201 - w64 * w198) - (w66 * w206 + w78 * w203) - w2 * w209
    w211 = top_e1_ddot * w187 - (w5 * w207 + w95 * w186) + top_e2_ddot * (w107 + w18 * c17) + top_e3_ddot * w109
    w212 = w211 - (w41 * w196 + w43 * w194) - (w62 * w201 - w64 * w199) - (w76 * w206 + w78 * w204) - w3 * w209
    w213 = top_e1_ddot * w176 - (w5 * w145 + w98 * w186) + top_e2_ddot * w109 - (w42 * w196 + w43 * w195) - (w63 * w201 - w64 * w200)
    dMa_dq_i = ca.vertcat(
        w65 - (w66 * w75 + w71 * w78) - (w2 * w92 + w100) - w2 * w142,
        w147 - (w61 * w62 + w59 * w64) - (w75 * w76 + w73 * w78) - w3 * w92 - w2 * w151,
        w156,
        w180 - w3 * w142,
        w182 - (w76 * w173 + w78 * w117) - (w100 + w3 * w179) - w3 * w151,
        w184 - w3 * w155,
        w210 - w4 * w142,
        w212 - w4 * w151,
        w213 - (w77 * w206 + w78 * w205) - (w100 + w4 * w209) - w4 * w155,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 3, 3)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 402 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    top_e0_dot = q_d_dot[3]
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
    c13 = c[13]
    c14 = c[14]
    w0 = 2 * top_e0
    w1 = top_e3 * -2.0
    w2 = top_e0_dot * w1
    w3 = 2 * top_e2
    w4 = top_e1 * -2.0
    w5 = w0 * top_e3_dot
    w6 = w2 + top_e1_dot * w3 + top_e2_dot * w4 + w5
    w7 = w6 * c1
    w8 = top_e2 * -2.0
    w9 = top_e0_dot * w8
    w10 = w0 * top_e2_dot
    w11 = 2 * top_e1
    w12 = w9 + w1 * top_e1_dot + w10 + top_e3_dot * w11
    w13 = w12 * c0
    w14 = w7 * w12 - w6 * w13
    w15 = top_e0_dot * w4 + w0 * top_e1_dot
    w16 = 2 * top_e3
    w17 = w15 + top_e2_dot * w16 + top_e3_dot * w8
    w18 = w17 * c3
    w19 = w6 * w18 - w7 * w17
    w20 = w13 * w17 - w12 * w18
    w21 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * c6
    w22 = w0 * w21
    w23 = (top_e2 * w11 - w0 * top_e3) * c6
    w24 = w22 - w16 * w23
    w25 = w15 + w1 * top_e2_dot + w3 * top_e3_dot
    w26 = w5 + (w2 + top_e1_dot * w8 + top_e2_dot * w11)
    w27 = (w0 * top_e1 + top_e3 * w3) * c6
    w28 = w23 * w26 - w25 * w27
    w29 = w10 + (w9 + top_e1_dot * w16) + w4 * top_e3_dot
    w30 = w27 * w29 - w21 * w26
    w31 = c14 + (w25 * w28 - w29 * w30) * c7
    w32 = w8 * w23
    w33 = w0 * w27
    w34 = w32 - w33
    w35 = w21 * w25 - w23 * w29
    w36 = (w26 * w30 - w25 * w35) * c7
    w37 = w16 * w27 - w8 * w21
    w38 = (w29 * w35 - w26 * w28) * c7
    w39 = w0 * c2
    w40 = w4 * w21 - w32
    w41 = w24 * c7
    w42 = w4 * w27
    w43 = w1 * w23 - w42
    w44 = w34 * c7
    w45 = w1 * w21
    w46 = w8 * w27 - w45
    w47 = w37 * c7
    w48 = w4 * w39 + top_e3 * top_e2 * c8 + w40 * w41 + w43 * w44 + w46 * w47
    w49 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w50 = top_e1 / top_e0
    w51 = w4 * (w4 * c2) + w8 * (w8 * c4) + w1 * (w1 * c5) + w40 * (w40 * c7) + w43 * (w43 * c7) + w46 * (w46 * c7)
    w52 = w4 * w14 + w8 * w19 + w1 * w20 - w31 * w40 - w36 * w43 - w38 * w46 + w49 * w51
    w53 = w8 * c2
    w54 = w11 * c4
    w55 = w0 * c5
    w56 = w3 * w21 - w4 * w23
    w57 = w56 * c7
    w58 = w0 * w23
    w59 = w58 - w3 * w27
    w60 = w59 * c7
    w61 = w42 - w22
    w62 = w61 * c7
    w63 = top_e2 * top_e1 * c12 + w1 * w55 + w40 * w57 + w43 * w60 + w46 * w62
    w64 = top_e3 / top_e0
    w65 = w63 - w51 * w64
    w66 = w1 * w54 + top_e0 * top_e2 * c11 + w24 * w57 + w34 * w60 + w37 * w62 - (w50 * w65 + w48 * w64)
    w67 = w8 * w53 + w11 * w54 + w0 * w55 + w56 * w57 + w59 * w60 + w61 * w62 - (w64 * w65 + w63 * w64)
    w68 = w66 / w67
    w69 = w8 * w14 + w11 * w19 + w0 * w20 - w31 * w56 - w36 * w59 - w38 * w61 + w49 * w63 - w52 * w64
    w70 = w0 * w14 + w1 * w19 + w3 * w20 - w24 * w31 - w34 * w36 - w37 * w38 + w48 * w49 - w50 * w52 - w68 * w69
    w71 = w0 * c4
    w72 = w4 * c5
    w73 = w45 - w58
    w74 = w73 * c7
    w75 = w11 * w23 - w1 * w27
    w76 = w75 * c7
    w77 = w33 - w11 * w21
    w78 = w77 * c7
    w79 = w8 * w71 + top_e3 * top_e1 * c10 + w40 * w74 + w43 * w76 + w46 * w78
    w80 = top_e2 / top_e0
    w81 = w79 - w51 * w80
    w82 = w16 * w53 + top_e0 * top_e1 * c13 + w57 * w73 + w60 * w75 + w62 * w77 - (w65 * w80 + w64 * w79)
    w83 = top_e0 * top_e3 * c9 + w3 * w72 + w24 * w74 + w34 * w76 + w37 * w78 - (w50 * w81 + w48 * w80) - w68 * w82
    w84 = w16 * (w16 * c2) + w0 * w71 + w4 * w72 + w73 * w74 + w75 * w76 + w77 * w78 - (w80 * w81 + w79 * w80)
    w85 = w82 / w67
    w86 = w84 - w82 * w85
    w87 = w83 / w86
    w88 = w14 * w16 + w0 * w19 + w4 * w20 - w31 * w73 - w36 * w75 - w38 * w77 + w49 * w79 - w52 * w80 - w69 * w85
    w89 = w0 * w39 + w1 * (w1 * c4) + w3 * (w3 * c5) + w24 * w41 + w34 * w44 + w37 * w47 - (w50 * (w48 - w50 * w51) + w48 * w50)
    w90 = (w70 - w87 * w88) / (w89 - w66 * w68 - w83 * w87)
    w91 = (w88 - w83 * w90) / w86
    q_i_ddot = ca.vertcat(
        w90,
        w91,
        (w69 - (w66 * w90 + w82 * w91)) / w67,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 39 operations."""
    p = ca.SX.sym("p", 6)
    top_foot_y = p[5]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        top_foot_y,
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
