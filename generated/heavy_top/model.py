"""Heavy top: equations of motion, emitted by symgen from the scene `heavy_top`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 top.e1 [1], 1 top.e2 [1], 2 top.e3 [1]

q_d, the dependent coordinates by index:
    0 top.x [m], 1 top.y [m], 2 top.z [m], 3 top.e0 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    69 operations.
    """
    p = ca.SX.sym("p", 6)
    gravity_z = p[0]
    top_mass = p[1]
    top_inertia_xx = p[2]
    top_inertia_yy = p[3]
    top_inertia_zz = p[4]
    top_foot_y = p[5]
    # intermediate terms (10)
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
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w3,  # c2
        w4,  # c3
        w5,  # c4
        w6,  # c5
        top_foot_y,  # top_foot_y
        top_mass,  # top_mass
        4.0 * w5 + w7,  # c8
        4.0 * w3 + w8,  # c9
        4.0 * w6 + -4.0 * w3,  # c10
        4.0 * w6 + -4.0 * w3,  # c11
        4.0 * w3 + w8,  # c12
        w7 + 4.0 * w5,  # c13
        w9,  # c14
        -top_foot_y,  # c15
        -w9,  # c16
        2 * w3,  # c17
        -2.0 * w5,  # c18
        2 * w6,  # c19
        -2.0 * w3,  # c20
        -2.0 * w6,  # c21
        2 * w5,  # c22
        4.0 * top_foot_y,  # c23
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    391 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    # intermediate terms (86)
    w0 = 2 * top_e0
    w1 = w0 * c2
    w2 = top_e3 * -2.0
    w3 = 2 * top_e2
    w4 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w5 = w0 * w4
    w6 = 2 * top_e3
    w7 = 2 * top_e1
    w8 = (top_e2 * w7 - w0 * top_e3) * top_foot_y
    w9 = w5 - w6 * w8
    w10 = w9 * top_mass
    w11 = top_e2 * -2.0
    w12 = w8 * w11
    w13 = (w0 * top_e1 + top_e3 * w3) * top_foot_y
    w14 = w0 * w13
    w15 = w12 - w14
    w16 = w15 * top_mass
    w17 = w6 * w13 - w4 * w11
    w18 = w17 * top_mass
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
    w29 = w28 + w22 * (w22 * top_mass) + w24 * (w24 * top_mass) + w26 * (w26 * top_mass)
    w30 = w0 * w1 + w2 * (w2 * c4) + w3 * (w3 * c5) + w9 * w10 + w15 * w16 + w17 * w18 - (w19 * (w27 - w19 * w29) + w19 * w27)
    w31 = w0 * c4
    w32 = w20 * c5
    w33 = w0 * w8
    w34 = w25 - w33
    w35 = w34 * top_mass
    w36 = w7 * w8 - w2 * w13
    w37 = w36 * top_mass
    w38 = w14 - w4 * w7
    w39 = w38 * top_mass
    w40 = w11 * w31 + top_e3 * top_e1 * c10
    w41 = w40 + w22 * w35 + w24 * w37 + w26 * w39
    w42 = top_e2 / top_e0
    w43 = w41 - w29 * w42
    w44 = top_e0 * top_e3 * c9 + w3 * w32 + w9 * w35 + w15 * w37 + w17 * w39 - (w19 * w43 + w27 * w42)
    w45 = w11 * c2
    w46 = w7 * c4
    w47 = w0 * c5
    w48 = w3 * w4 - w8 * w20
    w49 = w48 * top_mass
    w50 = w33 - w3 * w13
    w51 = w50 * top_mass
    w52 = w23 - w5
    w53 = w52 * top_mass
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
    w81 = c14 - (w22 * w75 - (w76 * w78 - w79 * w80)) * top_mass
    w82 = w4 * w76 - w8 * w79
    w83 = (w24 * w75 - (w77 * w80 - w76 * w82)) * top_mass
    w84 = (w26 * w75 - (w79 * w82 - w77 * w78)) * top_mass
    w85 = w20 * w69 + w11 * w73 + w2 * w74 + w28 * w75 - w22 * w81 + w24 * w83 + w26 * w84
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(w30, w44, w58),  # top.e1
        ca.horzcat(w44, w59, w60),  # top.e2
        ca.horzcat(  # top.e3
            w58, w60, w11 * w45 + w7 * w46 + w0 * w47 + w48 * w49 + w50 * w51 + w52 * w53 - (w56 * w57 + w55 * w56),
        ),
    )
    Q_hat = ca.vertcat(
        w0 * w69 + w2 * w73 + w3 * w74 + w21 * w75 - w9 * w81 + w15 * w83 + w17 * w84 - w19 * w85,  # top.e1
        w6 * w69 + w0 * w73 + w20 * w74 + w40 * w75 - w34 * w81 + w36 * w83 + w38 * w84 - w42 * w85,  # top.e2
        w11 * w69 + w7 * w73 + w0 * w74 + w54 * w75 - w48 * w81 + w50 * w83 + w52 * w84 - w56 * w85,  # top.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 4) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    40 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    c = ca.SX.sym("c", 24)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    c15 = c[15]
    # intermediate terms (5)
    w0 = top_e1**2
    w1 = top_e3**2
    w2 = (top_e0**2 + w0 + top_e2**2 + w1 - 1.0) / 2.0
    w3 = top_e0 - w2 / top_e0
    w4 = 2 * w3
    # outputs
    q_d_next = ca.vertcat(
        (2 * top_e1 * top_e2 - top_e3 * w4) * c15,  # top.x
        (1.0 - 2 * w0 - 2 * w1) * c15,  # top.y
        (top_e1 * w4 + top_e3 * (2 * top_e2)) * c15,  # top.z
        w3,  # top.e0
    )
    C_loop = ca.vertcat(w2)
    det_loop = ca.vertcat(top_e0)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    96 operations.
    """
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
    top_foot_y = c[6]
    # intermediate terms (20)
    w0 = top_e2 * -2.0
    w1 = 2 * top_e0
    w2 = 2 * top_e2
    w3 = (w1 * top_e1 + w2 * top_e3) * top_foot_y
    w4 = top_e3 * -2.0
    w5 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w6 = w4 * w5
    w7 = top_e1 / top_e0 * top_e1_dot + top_e2 / top_e0 * top_e2_dot + top_e3 / top_e0 * top_e3_dot
    w8 = 2 * top_e3
    w9 = w1 * w3
    w10 = 2 * top_e1
    w11 = top_e1 * -2.0
    w12 = w3 * w11
    w13 = w1 * w5
    w14 = (w0 * w3 - w6) * w7 - top_e1_dot * (w3 * w8 - w0 * w5) - top_e2_dot * (w9 - w5 * w10) - top_e3_dot * (w12 - w13)
    w15 = (top_e2 * w10 - w1 * top_e3) * top_foot_y
    w16 = w0 * w15
    w17 = w1 * w15
    w18 = w7 * (w4 * w15 - w12) - top_e1_dot * (w16 - w9) - top_e2_dot * (w10 * w15 - w3 * w4) - top_e3_dot * (w17 - w2 * w3)
    w19 = w7 * (w5 * w11 - w16) - top_e1_dot * (w13 - w8 * w15) - top_e2_dot * (w6 - w17) - top_e3_dot * (w2 * w5 - w11 * w15)
    # outputs
    q_d_dot = ca.vertcat(
        w14,  # top.x
        w18,  # top.y
        w19,  # top.z
        -w7,  # top.e0
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 4) [mixed]: accelerations of the dependent coordinates
    151 operations.
    """
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
    top_foot_y = c[6]
    # intermediate terms (27)
    w0 = top_e2 * -2.0
    w1 = 2 * top_e0
    w2 = 2 * top_e2
    w3 = (w1 * top_e1 + w2 * top_e3) * top_foot_y
    w4 = top_e3 * -2.0
    w5 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w6 = w4 * w5
    w7 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0 + top_e1 / top_e0 * top_e1_ddot
    w8 = w7 + top_e2 / top_e0 * top_e2_ddot + top_e3 / top_e0 * top_e3_ddot
    w9 = 2 * top_e3
    w10 = top_e1 * -2.0
    w11 = w0 * top_e0_dot + top_e1_dot * w9 + w1 * top_e2_dot + top_e3_dot * w10
    w12 = top_e0_dot * w10 + w1 * top_e1_dot + w4 * top_e2_dot + w2 * top_e3_dot
    w13 = 2 * top_e1
    w14 = (top_e2 * w13 - w1 * top_e3) * top_foot_y
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
    # outputs
    q_d_ddot = ca.vertcat(
        w19 - top_e3_ddot * (w20 - w21),  # top.x
        w24 - top_e3_ddot * (w25 - w2 * w3),  # top.y
        w26 - top_e3_ddot * (w2 * w5 - w10 * w14),  # top.z
        -w8,  # top.e0
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 4) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 4 x 7) [SI]: constraint Jacobian
    gives C_t (n_c = 4) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 4) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    172 operations.
    """
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
    top_foot_y = c[6]
    # intermediate terms (24)
    w0 = 2 * top_e1
    w1 = 2 * top_e0
    w2 = (w0 * top_e2 - w1 * top_e3) * top_foot_y
    w3 = top_e1**2
    w4 = top_e3**2
    w5 = (1.0 - 2 * w3 - 2 * w4) * top_foot_y
    w6 = 2 * top_e2
    w7 = (top_e1 * w1 + top_e3 * w6) * top_foot_y
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
    # outputs
    C = ca.vertcat(
        top_x + w2,  # foot.x
        top_y + w5,  # foot.y
        top_z + w7,  # foot.z
        (w4 + (w3 + top_e0**2 + top_e2**2) - 1.0) / 2.0,  # top.norm
    )
    C_q = ca.vertcat(
        ca.horzcat(1.0, 0.0, 0.0, w7 * w8 - w10, w7 * w14 - w5 * w8, w15 - w0 * w5, w12 - w16),  # foot.x
        ca.horzcat(0.0, 1.0, 0.0, w2 * w9 - w12, w13 - w15, w0 * w2 - w7 * w9, w17 - w6 * w7),  # foot.y
        ca.horzcat(0.0, 0.0, 1.0, w5 * w11 - w13, w16 - w2 * w14, w10 - w17, w5 * w6 - w2 * w11),  # foot.z
        ca.horzcat(0.0, 0.0, 0.0, top_e0, top_e1, top_e2, top_e3),  # top.norm
    )
    C_t = ca.SX(4, 1)
    nu = ca.SX(4, 1)
    gamma = ca.vertcat(
        -(w18 * w20 - w21 * w22),  # foot.x
        -(w21 * w23 - w19 * w20),  # foot.y
        -(w19 * w22 - w18 * w23),  # foot.z
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),  # top.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 7 x 7) [SI]: mass matrix in all coordinates
    gives K (n x n = 7 x 7) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 7) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 7) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 7) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 4 x 7) [SI]: constraint Jacobian
    gives gamma_b (n_c = 4) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    381 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    # intermediate terms (52)
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
    w37 = (top_e1 * w3 + top_e3 * w5) * top_foot_y
    w38 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w39 = w2 * w38
    w40 = (top_e2 * w12 - top_e3 * w3) * top_foot_y
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
    # outputs
    M = ca.SX(7, 7)
    # top.x
    M[0, 0] = top_mass
    # top.y
    M[1, 1] = top_mass
    # top.z
    M[2, 2] = top_mass
    # top.e0
    M[3, 3] = w0 * (w0 * c2) + w1 * (w1 * c4) + w2 * (w2 * c5)
    M[3, 4] = w6
    M[3, 5] = w10
    M[3, 6] = w15
    # top.e1
    M[4, 3] = w6
    M[4, 4] = w3 * w4 + w2 * (w2 * c4) + w5 * (w5 * c5)
    M[4, 5] = w16
    M[4, 6] = w17
    # top.e2
    M[5, 3] = w10
    M[5, 4] = w16
    M[5, 5] = w7 * (w7 * c2) + w3 * w8 + w0 * w9
    M[5, 6] = w18
    # top.e3
    M[6, 3] = w15
    M[6, 4] = w17
    M[6, 5] = w18
    M[6, 6] = w1 * w11 + w12 * w13 + w3 * w14
    K = ca.SX(7, 7)
    Q_v = ca.SX(7, 1)
    Q_v[3] = w33  # top.e0
    Q_v[4] = w34  # top.e1
    Q_v[5] = w35  # top.e2
    Q_v[6] = w36  # top.e3
    Q_F = ca.SX(7, 1)
    Q_F[2] = c14  # top.z
    Q_star = ca.vertcat(
        0.0,  # top.x
        0.0,  # top.y
        c14,  # top.z
        w33,  # top.e0
        w34,  # top.e1
        w35,  # top.e2
        w36,  # top.e3
    )
    C_q = ca.vertcat(
        ca.horzcat(1.0, 0.0, 0.0, w1 * w37 - w39, w7 * w37 - w1 * w38, w43 - w12 * w38, w41 - w44),  # foot.x
        ca.horzcat(0.0, 1.0, 0.0, w2 * w40 - w41, w42 - w43, w12 * w40 - w2 * w37, w45 - w5 * w37),  # foot.y
        ca.horzcat(0.0, 0.0, 1.0, w0 * w38 - w42, w44 - w7 * w40, w39 - w45, w5 * w38 - w0 * w40),  # foot.z
        ca.horzcat(0.0, 0.0, 0.0, top_e0, top_e1, top_e2, top_e3),  # top.norm
    )
    gamma_b = ca.vertcat(
        -(w46 * w48 - w49 * w50),  # foot.x
        -(w49 * w51 - w47 * w48),  # foot.y
        -(w47 * w50 - w46 * w51),  # foot.z
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),  # top.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes q_ddot (n = 7) [mixed]: accelerations of all coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 4) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6) [N, N m]: world force and moment of a joint on its body b, at b
    154 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    c14 = c[14]
    # intermediate terms (21)
    w0 = top_x_ddot * top_mass
    w1 = top_y_ddot * top_mass
    w2 = c14 - top_z_ddot * top_mass
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
    w17 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w18 = (top_e2 * w10 - top_e3 * w6) * top_foot_y
    w19 = w3 * (w8 * w11 - w7 * w12) + w9 * (w7 * w14 - w8 * w13) + w4 * (w12 * w13 - w11 * w14) - w16 - w2 * (w3 * w17 - w9 * w18)
    w20 = (top_e1 * w6 + top_e3 * w5) * top_foot_y
    # outputs
    lam = ca.vertcat(
        -w0,  # foot.x
        -w1,  # foot.y
        w2,  # foot.z
        (w19 + w1 * (w4 * w18 - w3 * w20) + w0 * (w9 * w20 - w4 * w17)) / top_e0,  # top.norm
    )
    joint_forces = ca.SX(6, 1)
    joint_forces[0] = w0
    joint_forces[1] = w1
    joint_forces[2] = -w2
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    140 operations.
    """
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
    top_mass = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c16 = c[16]
    # intermediate terms (25)
    w0 = top_x_dot * (top_x_dot * top_mass) + top_y_dot * (top_y_dot * top_mass) + top_z_dot * (top_z_dot * top_mass)
    w1 = top_e1 * -2.0
    w2 = top_e2 * -2.0
    w3 = top_e3 * -2.0
    w4 = 2 * top_e0
    w5 = w4 * c2
    w6 = 2 * top_e2
    w7 = w1 * w5 + top_e2 * top_e3 * c8
    w8 = 2 * top_e3
    w9 = w4 * c4
    w10 = w1 * c5
    w11 = w2 * w9 + top_e1 * top_e3 * c10
    w12 = top_e0_dot * (w1 * (w1 * c2) + w2 * (w2 * c4) + w3 * (w3 * c5)) + w7 * top_e1_dot + w11 * top_e2_dot
    w13 = w2 * c2
    w14 = 2 * top_e1
    w15 = w14 * c4
    w16 = w4 * c5
    w17 = top_e1 * top_e2 * c12 + w3 * w16
    w18 = top_e3 * top_e0 * c9 + w6 * w10
    w19 = w3 * w15 + top_e2 * top_e0 * c11
    w20 = top_e0_dot * w7 + top_e1_dot * (w4 * w5 + w3 * (w3 * c4) + w6 * (w6 * c5)) + top_e2_dot * w18 + top_e3_dot * w19
    w21 = w8 * w13 + top_e1 * top_e0 * c13
    w22 = top_e0_dot * w11 + top_e1_dot * w18 + top_e2_dot * (w8 * (w8 * c2) + w4 * w9 + w1 * w10) + top_e3_dot * w21
    w23 = top_e0_dot * w17 + top_e1_dot * w19 + top_e2_dot * w21 + top_e3_dot * (w2 * w13 + w14 * w15 + w4 * w16)
    w24 = w0 + top_e0_dot * (w12 + w17 * top_e3_dot) + top_e1_dot * w20 + top_e2_dot * w22 + top_e3_dot * w23
    # outputs
    kinetic = ca.vertcat(w24 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(top_z * c16)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    46 operations.
    """
    q = ca.SX.sym("q", 7)
    top_x = q[0]
    top_y = q[1]
    top_z = q[2]
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    # intermediate terms (11)
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
    # outputs
    poses = ca.vertcat(
        top_x, top_y, top_z, 1.0 - w0 - w1, w3 + w5, w6 - w7, w5 - w3, w8 - w1, w9 + w10, w6 + w7, w10 - w9,
        w8 - w0,
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    1161 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
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
    # intermediate terms (257)
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
    w32 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w33 = w0 * w32
    w34 = (top_e2 * w5 - w0 * top_e3) * top_foot_y
    w35 = w33 - w22 * w34
    w36 = w32 * -2.0
    w37 = top_e1 * c23
    w38 = w10 * top_foot_y
    w39 = w1 * w38
    w40 = w36 - w11 * w37 - w39
    w41 = w12 + (w9 + w1 * top_e1_dot + top_e2_dot * w5)
    w42 = w21 + w3 * top_e2_dot + top_e3_dot * w10
    w43 = (w0 * top_e1 + top_e3 * w10) * top_foot_y
    w44 = w34 * w41 - w42 * w43
    w45 = w19 * w44
    w46 = 2 * top_e2_dot
    w47 = w34 * w46
    w48 = w19 * w43
    w49 = w0 * top_foot_y
    w50 = w47 + w38 * w41 - (w48 + w42 * w49)
    w51 = w4 + (w2 + top_e1_dot * w22) + top_e3_dot * w11
    w52 = w43 * w51 - w32 * w41
    w53 = top_e3_dot * -2.0
    w54 = w49 * w51
    w55 = w43 * w53 + w54 - (w32 * w46 - w37 * w41)
    w56 = (w30 * w40 - (w45 + w42 * w50 - (w52 * w53 + w51 * w55))) * top_mass
    w57 = w1 * w34
    w58 = w11 * w32 - w57
    w59 = c14 - (w30 * w58 - (w42 * w44 - w51 * w52)) * top_mass
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
    w75 = (w30 * w68 - (w69 + w41 * w55 - (w71 + w42 * w74))) * top_mass
    w76 = w11 * w43
    w77 = w3 * w34 - w76
    w78 = (w30 * w77 - (w41 * w52 - w42 * w70)) * top_mass
    w79 = w0 * w49
    w80 = w0 * w18 + w3 * w26 + w10 * w29 + w30 * (w31 * -2.0) + (w35 * w56 + w59 * (w60 + w61)) + (w63 * w75 + w78 * (w39 - w79))
    w81 = w22 * w43 - w1 * w32
    w82 = w1 * w49
    w83 = w3 * w37
    w84 = w82 + w83
    w85 = (w30 * w84 - (w53 * w70 + w51 * w74 - (w44 * w46 + w41 * w50))) * top_mass
    w86 = w3 * w32
    w87 = w1 * w43 - w86
    w88 = (w30 * w87 - (w51 * w70 - w41 * w44)) * top_mass
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
    w118 = w22 * top_foot_y
    w119 = w22 * w118
    w120 = w1 * w118
    w121 = w43 * w109
    w122 = w5 * top_foot_y
    w123 = w15 * w34 - w41 * w118 - (w121 + w42 * w122)
    w124 = w51 * w122
    w125 = w15 * w32
    w126 = w43 * w46 + w124 - w125
    w127 = (w30 * w120 - w58 * w116 - (w44 * w109 + w42 * w123 - (w69 + w51 * w126))) * top_mass
    w128 = w104 + w0 * w108 + w3 * w111 + w10 * w113 + (w30 * w114 - w115 * w116) - (w59 * (w117 + w119) - w35 * w127)
    w129 = w3 * w118
    w130 = w11 * w122
    w131 = w129 + w130
    w132 = w70 * w109
    w133 = w51 * w118
    w134 = w32 * w109 - (w47 - w133)
    w135 = (w30 * w131 + w77 * w116 + (w15 * w52 + w41 * w126 - (w132 + w42 * w134))) * top_mass
    w136 = 2 * w43
    w137 = w0 * w122
    w138 = w136 + w137
    w139 = w1 * w122
    w140 = w15 * w44
    w141 = (w30 * w139 - w87 * w116 - (w46 * w70 + w51 * w134 - (w140 + w41 * w123))) * top_mass
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
    w154 = (w58 * w153 - (w11 * w44 + w42 * w77 - (w1 * w52 + w51 * w87))) * top_mass
    w155 = (w77 * w153 - (w3 * w52 + w41 * w87 - (w11 * w70 + w42 * w58))) * top_mass
    w156 = (w87 * w153 - (w1 * w70 + w51 * w58 - (w3 * w44 + w41 * w77))) * top_mass
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
    w213 = (w30 * w208 + (w140 + w42 * w210 - (w211 + w51 * w212))) * top_mass
    w214 = w0 * w203 + w3 * w205 + (w192 + w10 * w207) + w30 * (w193 + w3 * c4 * -2.0) - (w35 * w213 - w59 * w142)
    w215 = w183 - w196
    w216 = w19 * w34
    w217 = w125 - (w124 + w216)
    w218 = (w30 * w215 - (w52 * w209 + w41 * w212 - (w15 * w70 + w42 * w217))) * top_mass
    w219 = w65 + w120
    w220 = (w30 * w219 - (w71 + w51 * w217 - (w44 * w209 + w41 * w210))) * top_mass
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
    w240 = (w30 * w237 - (w7 * w44 + w42 * w238 - (w52 * w109 + w51 * w239))) * top_mass
    w241 = w0 * w236
    w242 = w0 * w232 + (w221 + w3 * w234) + w10 * w235 + w30 * (w222 + w10 * c5 * -2.0) + (w35 * w240 + w59 * (w241 + (w172 - w89)))
    w243 = w187 - w173 - w188
    w244 = w7 * w32 - w42 * w236 - (w34 * w109 - w54)
    w245 = (w30 * w243 - (w211 + w41 * w239 - (w7 * w70 + w42 * w244))) * top_mass
    w246 = w36 - w3 * w236
    w247 = w39 - w246
    w248 = (w30 * w247 - (w132 + w51 * w244 - (w45 + w41 * w238))) * top_mass
    w249 = w11 * w232 + w1 * w234 + (w165 + w3 * w235) + w30 * (w166 + w100 * -2.0) - (w59 * w237 - w58 * w240)
    w250 = w249 + (w77 * w245 + w78 * w243) + (w87 * w248 + w88 * w247)
    w251 = w242 + (w63 * w245 - w78 * (w82 + w169)) + (w81 * w248 + w88 * (w61 + w136 + w1 * w236)) - w90 * w250
    w252 = top_e3_dot / top_e0 + w161 * w163
    w253 = w104 + w22 * w232 + w0 * w234 + w11 * w235 + w30 * (w114 + w11 * c5 * -2.0) - (w59 * (w79 + w246) - w168 * w240)
    w254 = w253 + (w171 * w245 - w78 * (w5 * w49 + (w64 + w65))) + (w174 * w248 + w88 * (w169 + w5 * w236)) - w159 * w250
    w255 = w1 * w232 + w5 * w234 + w0 * w235 + w30 * (w194 * -2.0) - (w59 * (w66 - w10 * w236) - w186 * w240)
    w256 = w255 + (w190 * w245 - w78 * (w79 + w10 * w38)) + (w191 * w248 + w88 * (w188 + w241)) - (w103 + w161 * w250)
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # top.e1
            w80 + (w81 * w85 + w88 * (w89 + w1 * w37)) - (w90 * w96 + w103) - w90 * w146 - w158 * w164,
            w225 - w158 * w226, w251 - w146 * w161 - w158 * w252,
        ),
        ca.horzcat(  # top.e2
            w175 - w96 * w159 - w90 * w184 - w164 * w185,
            w227 + (w174 * w220 + w88 * w180) - (w103 + w159 * w224) - w159 * w184 - w185 * w226,
            w254 - w161 * w184 - w185 * w252,
        ),
        ca.horzcat(w199 - w164 * w200, w229 - w159 * w198 - w200 * w226, w256 - w161 * w198 - w200 * w252),  # top.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    559 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
    c8 = c[8]
    c10 = c[10]
    c12 = c[12]
    # intermediate terms (120)
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
    w36 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w37 = w0 * w36
    w38 = (top_e2 * w9 - w0 * top_e3) * top_foot_y
    w39 = w37 - w28 * w38
    w40 = w6 * w38
    w41 = w16 * w36 - w40
    w42 = w17 + (top_e1_dot * w6 - w15 + top_e2_dot * w9)
    w43 = w27 + w1 * top_e2_dot + top_e3_dot * w11
    w44 = (w0 * top_e1 + top_e3 * w11) * top_foot_y
    w45 = w38 * w42 - w43 * w44
    w46 = w6 - w12
    w47 = w38 * w46 - w25 * w44
    w48 = w8 + (top_e1_dot * w28 - w7) + top_e3_dot * w16
    w49 = w44 * w48 - w36 * w42
    w50 = w28 - w20
    w51 = w44 * w50 - w36 * w46
    w52 = (w35 * w41 - (w25 * w45 + w43 * w47 - (w49 * w50 + w48 * w51))) * top_mass
    w53 = w0 * w44
    w54 = w40 - w53
    w55 = w16 * w44
    w56 = w1 * w38 - w55
    w57 = w36 * w43 - w38 * w48
    w58 = w25 * w36 - w38 * w50
    w59 = (w35 * w56 - (w46 * w49 + w42 * w51 - (w25 * w57 + w43 * w58))) * top_mass
    w60 = w28 * w44 - w6 * w36
    w61 = w1 * w36
    w62 = w6 * w44 - w61
    w63 = (w35 * w62 - (w50 * w57 + w48 * w58 - (w45 * w46 + w42 * w47))) * top_mass
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
    w91 = (w41 * w86 - (w45 * w87 + w43 * w89 - (w49 * w78 + w48 * w90))) * top_mass
    w92 = w36 * w87 - w38 * w78
    w93 = (w56 * w86 - (w49 * w88 + w42 * w90 - (w57 * w87 + w43 * w92))) * top_mass
    w94 = (w62 * w86 - (w57 * w78 + w48 * w92 - (w45 * w88 + w42 * w89))) * top_mass
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
    w112 = (w41 * w107 - (w45 * w108 + w43 * w109 - (w49 * w110 + w48 * w111))) * top_mass
    w113 = w36 * w108 - w38 * w110
    w114 = (w56 * w107 - (w49 * w96 + w42 * w111 - (w57 * w108 + w43 * w113))) * top_mass
    w115 = (w62 * w107 - (w57 * w110 + w48 * w113 - (w45 * w96 + w42 * w109))) * top_mass
    w116 = w16 * w101 + w6 * w105 + w1 * w106 + w64 * w107 + w41 * w112 + w56 * w114 + w62 * w115
    w117 = w0 * w101 + w1 * w105 + w11 * w106 + w33 * w107 + w39 * w112 + w54 * w114 + w60 * w115 - w2 * w116
    w118 = w28 * w101 + w0 * w105 + w16 * w106 + w66 * w107 + w68 * w112 + w69 * w114 + w70 * w115 - w3 * w116
    w119 = w6 * w101 + w9 * w105 + w0 * w106 + w71 * w107 + w72 * w112 + w73 * w114 + w74 * w115 - w4 * w116
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # top.e1
            w0 * w24 + w1 * w31 + w11 * w32 + w33 * w35 + w39 * w52 + w54 * w59 + w60 * w63 - w2 * w65,
            w0 * w80 + w1 * w84 + w11 * w85 + w33 * w86 + w39 * w91 + w54 * w93 + w60 * w94 - w2 * w95, w117,
        ),
        ca.horzcat(  # top.e2
            w24 * w28 + w0 * w31 + w16 * w32 + w35 * w66 + w52 * w68 + w59 * w69 + w63 * w70 - w3 * w65,
            w28 * w80 + w0 * w84 + w16 * w85 + w66 * w86 + w68 * w91 + w69 * w93 + w70 * w94 - w3 * w95, w118,
        ),
        ca.horzcat(  # top.e3
            w6 * w24 + w9 * w31 + w0 * w32 + w35 * w71 + w52 * w72 + w59 * w73 + w63 * w74 - w4 * w65,
            w6 * w80 + w9 * w84 + w0 * w85 + w71 * w86 + w72 * w91 + w73 * w93 + w74 * w94 - w4 * w95, w119,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dMa_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot
    835 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
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
    # intermediate terms (214)
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
    w16 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w17 = w6 * w16
    w18 = 2 * top_e3
    w19 = 2 * top_e1
    w20 = (top_e2 * w19 - top_e3 * w6) * top_foot_y
    w21 = w17 - w18 * w20
    w22 = w16 * -2.0
    w23 = top_e1 * c23
    w24 = w0 * top_foot_y
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
    w38 = (w5 * w26 + w14 * w28 + top_e1_ddot * w31 + top_e2_ddot * w34 + top_e3_ddot * w37) * top_mass
    w39 = w11 * w16
    w40 = w6 * w20
    w41 = w39 - w40
    w42 = w0 * w16 - w9 * w20
    w43 = (w5 * w28 - top_e1_ddot * w21 - top_e2_ddot * w41 - top_e3_ddot * w42) * top_mass
    w44 = (top_e1 * w6 + w0 * top_e3) * top_foot_y
    w45 = w6 * w44
    w46 = w27 - w45
    w47 = w11 * w24
    w48 = w44 * -2.0
    w49 = w6 * top_foot_y
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
    w61 = (w5 * w52 + w14 * w54 - top_e1_ddot * w56 - top_e2_ddot * w59 - top_e3_ddot * w60) * top_mass
    w62 = w19 * w20 - w11 * w44
    w63 = w40 - w0 * w44
    w64 = (w5 * w54 - top_e1_ddot * w46 - top_e2_ddot * w62 - top_e3_ddot * w63) * top_mass
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
    w75 = (w5 * w68 + w14 * w69 - top_e1_ddot * w71 - top_e2_ddot * w73 - top_e3_ddot * w74) * top_mass
    w76 = w45 - w16 * w19
    w77 = w53 - w17
    w78 = (w5 * w69 - top_e1_ddot * w66 - top_e2_ddot * w76 - top_e3_ddot * w77) * top_mass
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
    w113 = w18 * top_foot_y
    w114 = w10 * w113
    w115 = w18 * w113
    w116 = w72 + w115
    w117 = w6 * w113
    w118 = w57 - w117
    w119 = w9 * w113
    w120 = top_e3_ddot * w119
    w121 = (w5 * w114 - w28 * w106 - top_e1_ddot * w116 + top_e2_ddot * w118 - w120) * top_mass
    w122 = 2 * w44
    w123 = w19 * top_foot_y
    w124 = w6 * w123
    w125 = w122 + w124
    w126 = w114 + w125
    w127 = w11 * w113
    w128 = w9 * w123
    w129 = w127 + w128
    w130 = w11 * w123
    w131 = w19 * w113 + w130
    w132 = w118 - w0 * w123
    w133 = (top_e1_ddot * w126 - (w5 * w129 + w54 * w106) + top_e2_ddot * w131 - top_e3_ddot * w132) * top_mass
    w134 = w10 * w123
    w135 = w18 * w123
    w136 = top_e1_ddot * w135
    w137 = w128 - w72
    w138 = (w5 * w134 - w69 * w106 - w136 - top_e2_ddot * w125 - top_e3_ddot * w137) * top_mass
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
    w165 = (w136 + (w28 * w159 - w5 * w163) + top_e2_ddot * w124 - top_e3_ddot * w164) * top_mass
    w166 = w130 - w119
    w167 = w163 - w117
    w168 = w19 * w123 - w127
    w169 = w124 - (w122 + w0 * w113)
    w170 = (w5 * w166 + w54 * w159 - top_e1_ddot * w167 - top_e2_ddot * w168 - top_e3_ddot * w169) * top_mass
    w171 = w48 + w114
    w172 = w115 - w22
    w173 = (w5 * w171 + w69 * w159 - top_e1_ddot * w172 - top_e2_ddot * w117 - w120) * top_mass
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
    w196 = (w5 * w190 + w28 * w186 + top_e1_ddot * w192 - top_e2_ddot * w194 - top_e3_ddot * w195) * top_mass
    w197 = w35 - w58 - w36
    w198 = w33 + w67
    w199 = w19 * w49 + (w47 + w48)
    w200 = w55 + w0 * w24
    w201 = (w5 * w197 + w54 * w186 + top_e1_ddot * w198 + top_e2_ddot * w199 + top_e3_ddot * w200) * top_mass
    w202 = w25 - w193
    w203 = w30 + w122 + w10 * w189
    w204 = w33 + w19 * w189
    w205 = w36 + w191
    w206 = (w5 * w202 + w69 * w186 - top_e1_ddot * w203 - top_e2_ddot * w204 - top_e3_ddot * w205) * top_mass
    w207 = w102 + w143
    w208 = top_e1_ddot * w185 - (w5 * (w85 + w82 * -2.0) + w83 * w186) + top_e2_ddot * w207 + top_e3_ddot * w145
    w209 = w208 - (w28 * w196 + w43 * w190) - (w54 * w201 + w64 * w197) - (w69 * w206 + w78 * w202)
    w210 = w188 - (w21 * w196 - w43 * w192) - (w46 * w201 - w64 * w198) - (w66 * w206 + w78 * w203) - w2 * w209
    w211 = top_e1_ddot * w187 - (w5 * w207 + w95 * w186) + top_e2_ddot * (w107 + w18 * c17) + top_e3_ddot * w109
    w212 = w211 - (w41 * w196 + w43 * w194) - (w62 * w201 - w64 * w199) - (w76 * w206 + w78 * w204) - w3 * w209
    w213 = top_e1_ddot * w176 - (w5 * w145 + w98 * w186) + top_e2_ddot * w109 - (w42 * w196 + w43 * w195) - (w63 * w201 - w64 * w200)
    # outputs
    dMa_dq_i = ca.vertcat(
        ca.horzcat(  # top.e1
            w65 - (w66 * w75 + w71 * w78) - (w2 * w92 + w100) - w2 * w142, w180 - w3 * w142, w210 - w4 * w142,
        ),
        ca.horzcat(  # top.e2
            w147 - (w61 * w62 + w59 * w64) - (w75 * w76 + w73 * w78) - w3 * w92 - w2 * w151,
            w182 - (w76 * w173 + w78 * w117) - (w100 + w3 * w179) - w3 * w151, w212 - w4 * w151,
        ),
        ca.horzcat(w156, w184 - w3 * w155, w213 - (w77 * w206 + w78 * w205) - (w100 + w4 * w209) - w4 * w155),  # top.e3
    )
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [ca.densify(dMa_dq_i)]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes c (n_const = 24) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    402 operations.
    """
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
    top_foot_y = c[6]
    top_mass = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    # intermediate terms (93)
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
    w21 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w22 = w0 * w21
    w23 = (top_e2 * w11 - w0 * top_e3) * top_foot_y
    w24 = w22 - w16 * w23
    w25 = w15 + w1 * top_e2_dot + w3 * top_e3_dot
    w26 = w5 + (w2 + top_e1_dot * w8 + top_e2_dot * w11)
    w27 = (w0 * top_e1 + top_e3 * w3) * top_foot_y
    w28 = w23 * w26 - w25 * w27
    w29 = w10 + (w9 + top_e1_dot * w16) + w4 * top_e3_dot
    w30 = w27 * w29 - w21 * w26
    w31 = c14 + (w25 * w28 - w29 * w30) * top_mass
    w32 = w8 * w23
    w33 = w0 * w27
    w34 = w32 - w33
    w35 = w21 * w25 - w23 * w29
    w36 = (w26 * w30 - w25 * w35) * top_mass
    w37 = w16 * w27 - w8 * w21
    w38 = (w29 * w35 - w26 * w28) * top_mass
    w39 = w0 * c2
    w40 = w4 * w21 - w32
    w41 = w24 * top_mass
    w42 = w4 * w27
    w43 = w1 * w23 - w42
    w44 = w34 * top_mass
    w45 = w1 * w21
    w46 = w8 * w27 - w45
    w47 = w37 * top_mass
    w48 = w4 * w39 + top_e3 * top_e2 * c8 + w40 * w41 + w43 * w44 + w46 * w47
    w49 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w50 = top_e1 / top_e0
    w51 = w4 * (w4 * c2) + w8 * (w8 * c4) + w1 * (w1 * c5) + w40 * (w40 * top_mass) + w43 * (w43 * top_mass)
    w52 = w51 + w46 * (w46 * top_mass)
    w53 = w4 * w14 + w8 * w19 + w1 * w20 - w31 * w40 - w36 * w43 - w38 * w46 + w49 * w52
    w54 = w8 * c2
    w55 = w11 * c4
    w56 = w0 * c5
    w57 = w3 * w21 - w4 * w23
    w58 = w57 * top_mass
    w59 = w0 * w23
    w60 = w59 - w3 * w27
    w61 = w60 * top_mass
    w62 = w42 - w22
    w63 = w62 * top_mass
    w64 = top_e2 * top_e1 * c12 + w1 * w56 + w40 * w58 + w43 * w61 + w46 * w63
    w65 = top_e3 / top_e0
    w66 = w64 - w52 * w65
    w67 = w1 * w55 + top_e0 * top_e2 * c11 + w24 * w58 + w34 * w61 + w37 * w63 - (w50 * w66 + w48 * w65)
    w68 = w8 * w54 + w11 * w55 + w0 * w56 + w57 * w58 + w60 * w61 + w62 * w63 - (w65 * w66 + w64 * w65)
    w69 = w67 / w68
    w70 = w8 * w14 + w11 * w19 + w0 * w20 - w31 * w57 - w36 * w60 - w38 * w62 + w49 * w64 - w53 * w65
    w71 = w0 * w14 + w1 * w19 + w3 * w20 - w24 * w31 - w34 * w36 - w37 * w38 + w48 * w49 - w50 * w53 - w69 * w70
    w72 = w0 * c4
    w73 = w4 * c5
    w74 = w45 - w59
    w75 = w74 * top_mass
    w76 = w11 * w23 - w1 * w27
    w77 = w76 * top_mass
    w78 = w33 - w11 * w21
    w79 = w78 * top_mass
    w80 = w8 * w72 + top_e3 * top_e1 * c10 + w40 * w75 + w43 * w77 + w46 * w79
    w81 = top_e2 / top_e0
    w82 = w80 - w52 * w81
    w83 = w16 * w54 + top_e0 * top_e1 * c13 + w58 * w74 + w61 * w76 + w63 * w78 - (w66 * w81 + w65 * w80)
    w84 = top_e0 * top_e3 * c9 + w3 * w73 + w24 * w75 + w34 * w77 + w37 * w79 - (w50 * w82 + w48 * w81) - w69 * w83
    w85 = w16 * (w16 * c2) + w0 * w72 + w4 * w73 + w74 * w75 + w76 * w77 + w78 * w79 - (w81 * w82 + w80 * w81)
    w86 = w83 / w68
    w87 = w85 - w83 * w86
    w88 = w84 / w87
    w89 = w14 * w16 + w0 * w19 + w4 * w20 - w31 * w74 - w36 * w76 - w38 * w78 + w49 * w80 - w53 * w81 - w70 * w86
    w90 = w0 * w39 + w1 * (w1 * c4) + w3 * (w3 * c5) + w24 * w41 + w34 * w44 + w37 * w47 - (w50 * (w48 - w50 * w52) + w48 * w50)
    w91 = (w71 - w88 * w89) / (w90 - w67 * w69 - w84 * w88)
    w92 = (w89 - w84 * w91) / w87
    # outputs
    q_i_ddot = ca.vertcat(w91, w92, (w70 - (w67 * w91 + w83 * w92)) / w68)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 3) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 3) [1]: columns of the rotation matrix of the marker at a drawn point
    39 operations.
    """
    p = ca.SX.sym("p", 6)
    top_foot_y = p[5]
    # outputs
    positions = ca.SX(3, 3)
    positions[1, 2] = top_foot_y
    axes = ca.SX(9, 3)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes)]
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
