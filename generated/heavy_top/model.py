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
    gives c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    71 operations.
    """
    p = ca.SX.sym("p", 6)
    gravity_z = p[0]
    top_mass = p[1]
    top_inertia_xx = p[2]
    top_inertia_yy = p[3]
    top_inertia_zz = p[4]
    top_foot_y = p[5]
    # intermediate terms (20)
    w0 = (top_inertia_xx + top_inertia_yy + top_inertia_zz) / 2.0
    w1 = w0 - top_inertia_yy
    w2 = w0 - top_inertia_zz
    w3 = w1 + w2
    w4 = w0 - top_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = 4.0 * w5
    w8 = -4.0 * w6
    w9 = 4.0 * w3
    w10 = -4.0 * w5
    w11 = -4.0 * w3
    w12 = 4.0 * w6
    w13 = 4.0 * w6
    w14 = 4.0 * w3
    w15 = 4.0 * w5
    w16 = -4.0 * w6
    w17 = -4.0 * w3
    w18 = -4.0 * w5
    w19 = top_mass * gravity_z
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
        w7 + w8,  # c8
        w9 + w10,  # c9
        w11 + w12,  # c10
        w13 + w11,  # c11
        w14 + w10,  # c12
        w8 + w15,  # c13
        gravity_z,  # gravity_z
        -top_foot_y,  # c15
        w7 + w16,  # c16
        w12 + w17,  # c17
        w14 + w18,  # c18
        w9 + w18,  # c19
        w15 + w16,  # c20
        w19,  # c21
        -w19,  # c22
        4.0 * top_foot_y,  # c23
        w13 + w17,  # c24
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    392 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 25)
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
    gravity_z = c[14]
    # intermediate terms (86)
    w0 = 2 * top_e0
    w1 = top_e3 * -2.0
    w2 = w1 * c4
    w3 = 2 * top_e2
    w4 = w3 * c5
    w5 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w6 = w0 * w5
    w7 = 2 * top_e3
    w8 = 2 * top_e1
    w9 = (top_e2 * w8 - w0 * top_e3) * top_foot_y
    w10 = w6 - w7 * w9
    w11 = w10 * top_mass
    w12 = top_e2 * -2.0
    w13 = w9 * w12
    w14 = (w0 * top_e1 + top_e3 * w3) * top_foot_y
    w15 = w0 * w14
    w16 = w13 - w15
    w17 = w16 * top_mass
    w18 = w7 * w14 - w5 * w12
    w19 = w18 * top_mass
    w20 = top_e1 / top_e0
    w21 = top_e1 * -2.0
    w22 = w21 * c2
    w23 = w12 * c4
    w24 = w1 * c5
    w25 = w5 * w21 - w13
    w26 = w14 * w21
    w27 = w1 * w9 - w26
    w28 = w1 * w5
    w29 = w12 * w14 - w28
    w30 = w0 * w22 + top_e3 * top_e2 * c8 + w11 * w25 + w17 * w27 + w19 * w29
    w31 = w21 * w22 + w12 * w23 + w1 * w24 + w25 * (w25 * top_mass) + w27 * (w27 * top_mass) + w29 * (w29 * top_mass)
    w32 = w0 * (w0 * c2) + w1 * w2 + w3 * w4 + w10 * w11 + w16 * w17 + w18 * w19 - (w20 * (w30 - w20 * w31) + w20 * w30)
    w33 = w0 * w9
    w34 = w28 - w33
    w35 = w34 * top_mass
    w36 = w8 * w9 - w1 * w14
    w37 = w36 * top_mass
    w38 = w15 - w5 * w8
    w39 = w38 * top_mass
    w40 = w0 * w23 + top_e3 * top_e1 * c10 + w25 * w35 + w27 * w37 + w29 * w39
    w41 = top_e2 / top_e0
    w42 = w40 - w31 * w41
    w43 = top_e0 * top_e3 * c9 + w4 * w21 + w10 * w35 + w16 * w37 + w18 * w39 - (w20 * w42 + w30 * w41)
    w44 = w3 * w5 - w9 * w21
    w45 = w44 * top_mass
    w46 = w33 - w3 * w14
    w47 = w46 * top_mass
    w48 = w26 - w6
    w49 = w48 * top_mass
    w50 = top_e2 * top_e1 * c12 + w0 * w24 + w25 * w45 + w27 * w47 + w29 * w49
    w51 = top_e3 / top_e0
    w52 = w50 - w31 * w51
    w53 = w2 * w8 + top_e0 * top_e2 * c11 + w10 * w45 + w16 * w47 + w18 * w49 - (w20 * w52 + w30 * w51)
    w54 = w7 * c2
    w55 = w7 * w54 + w0 * (w0 * c4) + w21 * (w21 * c5) + w34 * w35 + w36 * w37 + w38 * w39 - (w41 * w42 + w40 * w41)
    w56 = w12 * w54 + top_e0 * top_e1 * c13 + w34 * w45 + w36 * w47 + w38 * w49 - (w41 * w52 + w40 * w51)
    w57 = w12 * (w12 * c2) + w8 * (w8 * c4) + w0 * (w0 * c5) + w44 * w45 + w46 * w47 + w48 * w49 - (w51 * w52 + w50 * w51)
    w58 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w59 = w21 * top_e0_dot + w0 * top_e1_dot
    w60 = w59 + w1 * top_e2_dot + w3 * top_e3_dot
    w61 = w1 * top_e0_dot
    w62 = w0 * top_e3_dot
    w63 = w61 + w12 * top_e1_dot + w8 * top_e2_dot + w62
    w64 = w9 * w63 - w14 * w60
    w65 = w12 * top_e0_dot
    w66 = w0 * top_e2_dot
    w67 = w65 + w7 * top_e1_dot + w66 + w21 * top_e3_dot
    w68 = w14 * w67 - w5 * w63
    w69 = (w25 * w58 - (w60 * w64 - w67 * w68) - gravity_z) * top_mass
    w70 = w66 + (w65 + w1 * top_e1_dot) + w8 * top_e3_dot
    w71 = w62 + (w61 + w3 * top_e1_dot + w21 * top_e2_dot)
    w72 = w70 * w71
    w73 = w21 * w58
    w74 = (w72 - w73) * c0 - (w72 + w73) * c1
    w75 = w59 + w7 * top_e2_dot + w12 * top_e3_dot
    w76 = w71 * w75
    w77 = w12 * w58
    w78 = (w76 - w77) * c1 - (w76 + w77) * c3
    w79 = w70 * w75
    w80 = w1 * w58
    w81 = (w79 - w80) * c3 - (w79 + w80) * c0
    w82 = w5 * w60 - w9 * w67
    w83 = (w27 * w58 - (w63 * w68 - w60 * w82)) * top_mass
    w84 = (w29 * w58 - (w67 * w82 - w63 * w64)) * top_mass
    w85 = w25 * w69 - (w21 * w74 + w12 * w78 + w1 * w81) + w27 * w83 + w29 * w84
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(w32, w43, w53),  # top.e1
        ca.horzcat(w43, w55, w56),  # top.e2
        ca.horzcat(w53, w56, w57),  # top.e3
    )
    Q_hat = ca.vertcat(
        w10 * w69 - (w0 * w74 + w1 * w78 + w3 * w81) + w16 * w83 + w18 * w84 - w20 * w85,  # top.e1
        w34 * w69 - (w7 * w74 + w0 * w78 + w21 * w81) + w36 * w83 + w38 * w84 - w41 * w85,  # top.e2
        w44 * w69 - (w12 * w74 + w8 * w78 + w0 * w81) + w46 * w83 + w48 * w84 - w51 * w85,  # top.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 4) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    40 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    c = ca.SX.sym("c", 25)
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    96 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 25)
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 4) [mixed]: accelerations of the dependent coordinates
    151 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 25)
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 4) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 4 x 7) [SI]: constraint Jacobian
    gives C_t (n_c = 4) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 4) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    172 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 25)
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    c = ca.SX.sym("c", 25)
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
    c11 = c[11]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    # intermediate terms (52)
    w0 = top_e1 * -2.0
    w1 = top_e2 * -2.0
    w2 = top_e3 * -2.0
    w3 = 2 * top_e0
    w4 = w3 * c2
    w5 = 2 * top_e2
    w6 = w0 * w4 + top_e2 * top_e3 * c16
    w7 = 2 * top_e3
    w8 = w3 * c4
    w9 = w0 * c5
    w10 = w1 * w8 + top_e1 * top_e3 * c17
    w11 = w1 * c2
    w12 = 2 * top_e1
    w13 = w12 * c4
    w14 = w3 * c5
    w15 = top_e1 * top_e2 * c18 + w2 * w14
    w16 = top_e3 * top_e0 * c19 + w5 * w9
    w17 = w2 * w13 + top_e2 * top_e0 * c11
    w18 = w7 * w11 + top_e1 * top_e0 * c20
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
    Q_F[2] = c21  # top.z
    Q_star = ca.vertcat(
        0.0,  # top.x
        0.0,  # top.y
        c21,  # top.z
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 4) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6) [N, N m]: world force and moment of a joint on its body b, at b
    154 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 25)
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
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c21 = c[21]
    # intermediate terms (21)
    w0 = top_x_ddot * top_mass
    w1 = top_y_ddot * top_mass
    w2 = c21 - top_z_ddot * top_mass
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
    w15 = (w3 * (w3 * c2) + w9 * (w9 * c4) + w4 * (w4 * c5)) * top_e0_ddot + (w3 * (w6 * c2) + top_e3 * top_e2 * c16) * top_e1_ddot
    w16 = w15 + (w9 * (w6 * c4) + top_e1 * top_e3 * c17) * top_e2_ddot + (top_e1 * top_e2 * c18 + w4 * (w6 * c5)) * top_e3_ddot
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    140 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 25)
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
    c11 = c[11]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    # intermediate terms (25)
    w0 = top_x_dot * (top_x_dot * top_mass) + top_y_dot * (top_y_dot * top_mass) + top_z_dot * (top_z_dot * top_mass)
    w1 = top_e1 * -2.0
    w2 = top_e2 * -2.0
    w3 = top_e3 * -2.0
    w4 = 2 * top_e0
    w5 = w4 * c2
    w6 = 2 * top_e2
    w7 = w1 * w5 + top_e2 * top_e3 * c16
    w8 = 2 * top_e3
    w9 = w4 * c4
    w10 = w1 * c5
    w11 = w2 * w9 + top_e1 * top_e3 * c17
    w12 = top_e0_dot * (w1 * (w1 * c2) + w2 * (w2 * c4) + w3 * (w3 * c5)) + w7 * top_e1_dot + w11 * top_e2_dot
    w13 = w2 * c2
    w14 = 2 * top_e1
    w15 = w14 * c4
    w16 = w4 * c5
    w17 = top_e1 * top_e2 * c18 + w3 * w16
    w18 = top_e3 * top_e0 * c19 + w6 * w10
    w19 = w3 * w15 + top_e2 * top_e0 * c11
    w20 = top_e0_dot * w7 + top_e1_dot * (w4 * w5 + w3 * (w3 * c4) + w6 * (w6 * c5)) + top_e2_dot * w18 + top_e3_dot * w19
    w21 = w8 * w13 + top_e1 * top_e0 * c20
    w22 = top_e0_dot * w11 + top_e1_dot * w18 + top_e2_dot * (w8 * (w8 * c2) + w4 * w9 + w1 * w10) + top_e3_dot * w21
    w23 = top_e0_dot * w17 + top_e1_dot * w19 + top_e2_dot * w21 + top_e3_dot * (w2 * w13 + w14 * w15 + w4 * w16)
    w24 = w0 + top_e0_dot * (w12 + w17 * top_e3_dot) + top_e1_dot * w20 + top_e2_dot * w22 + top_e3_dot * w23
    # outputs
    kinetic = ca.vertcat(w24 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(top_z * c22)
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
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    1049 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 25)
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
    c3 = c[3]
    top_foot_y = c[6]
    top_mass = c[7]
    gravity_z = c[14]
    c23 = c[23]
    # intermediate terms (242)
    w0 = 2 * top_e0
    w1 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w2 = w0 * w1
    w3 = 2 * top_e3
    w4 = 2 * top_e1
    w5 = (w4 * top_e2 - w0 * top_e3) * top_foot_y
    w6 = w2 - w3 * w5
    w7 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w8 = w1 * -2.0
    w9 = top_e1 * -2.0
    w10 = top_e1 * c23
    w11 = top_e2 * -2.0
    w12 = 2 * top_e2
    w13 = w12 * top_foot_y
    w14 = w11 * w13
    w15 = w8 - w9 * w10 - w14
    w16 = top_e3 * -2.0
    w17 = top_e0_dot * w16
    w18 = w0 * top_e3_dot
    w19 = w17 + top_e1_dot * w11 + w4 * top_e2_dot + w18
    w20 = top_e0_dot * w9 + w0 * top_e1_dot
    w21 = w20 + top_e2_dot * w16 + top_e3_dot * w12
    w22 = (w0 * top_e1 + top_e3 * w12) * top_foot_y
    w23 = w5 * w19 - w21 * w22
    w24 = top_e0_dot * -2.0
    w25 = w23 * w24
    w26 = 2 * top_e2_dot
    w27 = w5 * w26
    w28 = w22 * w24
    w29 = w0 * top_foot_y
    w30 = w27 + w13 * w19 - (w28 + w21 * w29)
    w31 = top_e0_dot * w11
    w32 = w0 * top_e2_dot
    w33 = w31 + w3 * top_e1_dot + w32 + top_e3_dot * w9
    w34 = w22 * w33 - w1 * w19
    w35 = top_e3_dot * -2.0
    w36 = w29 * w33
    w37 = w22 * w35 + w36 - (w1 * w26 - w10 * w19)
    w38 = (w7 * w15 - (w25 + w21 * w30 - (w34 * w35 + w33 * w37))) * top_mass
    w39 = w5 * w11
    w40 = w1 * w9 - w39
    w41 = (w7 * w40 - (w21 * w23 - w33 * w34) - gravity_z) * top_mass
    w42 = w0 * w10
    w43 = w3 * w13
    w44 = w18 + (w17 + top_e1_dot * w12 + top_e2_dot * w9)
    w45 = 2 * top_e3_dot
    w46 = w32 + (w31 + top_e1_dot * w16) + w4 * top_e3_dot
    w47 = top_e2_dot * -2.0
    w48 = w44 * w45 + w46 * w47
    w49 = w7 * -2.0
    w50 = (w48 - w49) * c0 - (w48 + w49) * c1
    w51 = w24 * w44
    w52 = w20 + w3 * top_e2_dot + top_e3_dot * w11
    w53 = w51 + w47 * w52
    w54 = w53 * c1 - w53 * c3
    w55 = w24 * w46
    w56 = w45 * w52
    w57 = w55 + w56
    w58 = w57 * c3 - w57 * c0
    w59 = w0 * w22
    w60 = w39 - w59
    w61 = w13 * w16
    w62 = w22 * -2.0
    w63 = w9 * w29
    w64 = w62 + w63
    w65 = w61 - w64
    w66 = w26 * w34
    w67 = w1 * w21 - w5 * w33
    w68 = w24 * w67
    w69 = w1 * w24
    w70 = w13 * w33
    w71 = w69 - w10 * w21 - (w5 * w35 + w70)
    w72 = (w7 * w65 - (w66 + w19 * w37 - (w68 + w21 * w71))) * top_mass
    w73 = w9 * w22
    w74 = w5 * w16 - w73
    w75 = (w7 * w74 - (w19 * w34 - w21 * w67)) * top_mass
    w76 = w0 * w29
    w77 = w6 * w38 - w41 * (w42 + w43) - (w0 * w50 + w16 * w54 + w12 * w58) + (w60 * w72 + w75 * (w14 - w76))
    w78 = w3 * w22 - w1 * w11
    w79 = w11 * w29
    w80 = w10 * w16
    w81 = w79 + w80
    w82 = (w7 * w81 - (w35 * w67 + w33 * w71 - (w23 * w26 + w19 * w30))) * top_mass
    w83 = w1 * w16
    w84 = w11 * w22 - w83
    w85 = (w7 * w84 - (w33 * w67 - w19 * w23)) * top_mass
    w86 = w3 * w29
    w87 = top_e1 / top_e0
    w88 = w44 * w46
    w89 = w7 * w9
    w90 = (w88 - w89) * c0 - (w88 + w89) * c1
    w91 = w90 * -2.0
    w92 = w38 * w40 + w15 * w41 - (w91 + w9 * w50 + w11 * w54 + w16 * w58) + (w72 * w74 + w65 * w75) + (w82 * w84 + w81 * w85)
    w93 = w44 * w52
    w94 = w7 * w11
    w95 = (w93 - w94) * c1 - (w93 + w94) * c3
    w96 = w46 * w52
    w97 = w7 * w16
    w98 = (w96 - w97) * c3 - (w96 + w97) * c0
    w99 = w40 * w41 - (w9 * w90 + w11 * w95 + w16 * w98) + w74 * w75 + w84 * w85
    w100 = w99 / top_e0
    w101 = w3 * top_foot_y
    w102 = w11 * w101
    w103 = w7 / top_e0
    w104 = 2 * top_e1_dot
    w105 = w22 * w104
    w106 = w4 * top_foot_y
    w107 = w5 * w45 - w19 * w101 - (w105 + w21 * w106)
    w108 = w33 * w106
    w109 = w1 * w45
    w110 = w22 * w26 + w108 - w109
    w111 = (w7 * w102 - w40 * w103 - (w23 * w104 + w21 * w107 - (w66 + w33 * w110))) * top_mass
    w112 = 2 * w1
    w113 = w3 * w101
    w114 = 2 * w90
    w115 = w26 * w44
    w116 = w115 + w45 * w46
    w117 = w9 * w103
    w118 = (w116 + w117) * c0 - (w116 - w117) * c1
    w119 = w56 + w44 * w104
    w120 = w11 * w103
    w121 = (w119 + w120) * c1 - (w119 - w120) * c3
    w122 = w46 * w104
    w123 = w122 + w26 * w52
    w124 = w16 * w103
    w125 = (w123 + w124) * c3 - (w123 - w124) * c0
    w126 = w16 * w101
    w127 = w9 * w106
    w128 = w126 + w127
    w129 = w67 * w104
    w130 = w33 * w101
    w131 = w1 * w104 - (w27 - w130)
    w132 = (w7 * w128 + w74 * w103 + (w34 * w45 + w19 * w110 - (w129 + w21 * w131))) * top_mass
    w133 = 2 * w22
    w134 = w0 * w106
    w135 = w133 + w134
    w136 = w6 * w111 + w41 * (w112 + w113) - (w114 + w0 * w118 + w16 * w121 + w12 * w125) - (w60 * w132 + w75 * (w102 + w135))
    w137 = w11 * w106
    w138 = w23 * w45
    w139 = (w7 * w137 - w84 * w103 - (w26 * w67 + w33 * w131 - (w138 + w19 * w107))) * top_mass
    w140 = w3 * w106
    w141 = w40 * w111 + w41 * w102 - (w9 * w118 + w11 * w121 + w16 * w125) - (w74 * w132 + w75 * w128) + (w84 * w139 + w85 * w137)
    w142 = w87 / top_e0
    w143 = w136 + (w78 * w139 + w85 * w140) - (w87 * w141 - w99 * w142)
    w144 = 2 * top_e0_dot / top_e0
    w145 = (w40 * w144 - (w9 * w23 + w21 * w74 - (w11 * w34 + w33 * w84))) * top_mass
    w146 = w11 * w44 + w16 * w46
    w147 = w9 * w144
    w148 = (w146 - w147) * c0 - (w146 + w147) * c1
    w149 = w9 * w44 + w16 * w52
    w150 = w11 * w144
    w151 = (w149 - w150) * c1 - (w149 + w150) * c3
    w152 = w9 * w46 + w11 * w52
    w153 = w16 * w144
    w154 = (w152 - w153) * c3 - (w152 + w153) * c0
    w155 = (w74 * w144 - (w16 * w34 + w19 * w84 - (w9 * w67 + w21 * w40))) * top_mass
    w156 = (w84 * w144 - (w11 * w67 + w33 * w40 - (w16 * w23 + w19 * w74))) * top_mass
    w157 = w40 * w145 - (w9 * w148 + w11 * w151 + w16 * w154) + w74 * w155 + w84 * w156
    w158 = w6 * w145 - (w0 * w148 + w16 * w151 + w12 * w154) + w60 * w155 + w78 * w156 - w87 * w157
    w159 = top_e2 / top_e0
    w160 = w159 / top_e0
    w161 = top_e3 / top_e0
    w162 = w161 / top_e0
    w163 = top_e1_dot * w142 + top_e2_dot * w160 + top_e3_dot * w162
    w164 = top_e1_dot / top_e0 + w87 * w163
    w165 = w0 * w5
    w166 = w83 - w165
    w167 = w0 * w13
    w168 = w98 * -2.0
    w169 = w4 * w5 - w16 * w22
    w170 = 2 * w5
    w171 = w16 * w29
    w172 = w38 * w166 - w41 * (w80 + w167) - (w3 * w50 + w0 * w54 + (w168 + w9 * w58)) + (w72 * w169 + w75 * (w170 + w4 * w13 - w171))
    w173 = w59 - w1 * w4
    w174 = w0 * w101
    w175 = w170 - w174
    w176 = 2 * w95
    w177 = w16 * w106
    w178 = w111 * w166 - w41 * w175 - (w3 * w118 + (w176 + w0 * w121) + w9 * w125) - (w132 * w169 + w75 * (w4 * w101 + w177))
    w179 = w178 + (w139 * w173 + w85 * w135) - (w141 * w159 - w99 * w160)
    w180 = w145 * w166 - (w3 * w148 + w0 * w151 + w9 * w154) + w155 * w169 + w156 * w173 - w157 * w159
    w181 = w1 * w12 - w5 * w9
    w182 = w5 * -2.0
    w183 = w9 * w13
    w184 = w165 - w12 * w22
    w185 = w38 * w181 - w41 * (w10 * w12 + (w182 + w183)) - (w11 * w50 + (w176 + w4 * w54) + w0 * w58) + (w72 * w184 + w75 * (w167 - w12 * w29))
    w186 = w73 - w2
    w187 = w9 * w101
    w188 = 2 * w98
    w189 = w111 * w181 + w41 * w187 - (w11 * w118 + w4 * w121 + (w188 + w0 * w125)) + (w75 * (w175 - w12 * w106) - w132 * w184)
    w190 = w189 + (w139 * w186 + w85 * (w127 - w112)) - (w141 * w161 - w99 * w162)
    w191 = w145 * w181 - (w11 * w148 + w4 * w151 + w0 * w154) + w155 * w184 + w156 * w186 - w157 * w161
    w192 = w177 - w187
    w193 = top_e1_dot * -2.0
    w194 = w28 + w130 - w1 * w193
    w195 = w5 * w24
    w196 = w109 - (w108 + w195)
    w197 = (w7 * w192 - (w34 * w193 + w19 * w194 - (w45 * w67 + w21 * w196))) * top_mass
    w198 = w137 + w182
    w199 = w5 * w193 + w19 * w106 - (w22 * w45 + w21 * w101)
    w200 = w24 * w34
    w201 = (w7 * w198 + (w138 + w21 * w199 - (w200 + w33 * w194))) * top_mass
    w202 = w51 + w122
    w203 = w202 * c0 - w202 * c1
    w204 = w35 * w44 + w52 * w104
    w205 = (w204 - w49) * c1 - (w49 + w204) * c3
    w206 = w24 * w52
    w207 = w35 * w46 + w206
    w208 = w207 * c3 - w207 * c0
    w209 = w60 * w197 + w75 * (w198 - w174) - (w6 * w201 + w41 * w140 + (w0 * w203 + w16 * w205 + (w188 + w12 * w208)))
    w210 = w62 + w102
    w211 = (w7 * w210 - (w68 + w33 * w196 - (w23 * w193 + w19 * w199))) * top_mass
    w212 = w95 * -2.0
    w213 = w74 * w197 + w75 * w192 - (w40 * w201 + w41 * w198 + (w9 * w203 + (w212 + w11 * w205) + w16 * w208))
    w214 = w213 + (w84 * w211 + w85 * w210)
    w215 = top_e2_dot / top_e0 + w159 * w163
    w216 = w169 * w197 + w75 * (w4 * w106 - w126) - (w166 * w201 + w41 * w134 + (w3 * w203 + w0 * w205 + w9 * w208))
    w217 = w41 * (w112 - w127) - w181 * w201 - (w91 + w11 * w203 + w4 * w205 + w0 * w208) + (w184 * w197 + w75 * (w134 - (w133 + w12 * w101)))
    w218 = top_e3 * c23
    w219 = w79 - w9 * w218
    w220 = w195 - w19 * w29 - (w22 * w47 + w13 * w21)
    w221 = w70 + w105 - (w69 - w19 * w218)
    w222 = (w7 * w219 - (w23 * w47 + w21 * w220 - (w34 * w104 + w33 * w221))) * top_mass
    w223 = w0 * w218
    w224 = w55 + w44 * w193
    w225 = w224 * c0 - w224 * c1
    w226 = w115 + w206
    w227 = w226 * c1 - w226 * c3
    w228 = w26 * w46 + w52 * w193
    w229 = (w228 - w49) * c3 - (w49 + w228) * c0
    w230 = w182 - w171 - w183
    w231 = w1 * w47 - w21 * w218 - (w5 * w104 - w36)
    w232 = (w7 * w230 - (w200 + w19 * w221 - (w47 * w67 + w21 * w231))) * top_mass
    w233 = w6 * w222 - w41 * (w223 + (w170 - w86)) - (w0 * w225 + (w212 + w16 * w227) + w12 * w229) + (w60 * w232 - w75 * (w79 + w167))
    w234 = w8 - w16 * w218
    w235 = w14 - w234
    w236 = (w7 * w235 - (w129 + w33 * w231 - (w25 + w19 * w220))) * top_mass
    w237 = w40 * w222 + w41 * w219 - (w9 * w225 + w11 * w227 + (w168 + w16 * w229)) + (w74 * w232 + w75 * w230)
    w238 = w237 + (w84 * w236 + w85 * w235)
    w239 = top_e3_dot / top_e0 + w161 * w163
    w240 = w166 * w222 + w41 * (w76 + w234) - (w114 + w3 * w225 + w0 * w227 + w9 * w229) + (w169 * w232 - w75 * (w4 * w29 + (w61 + w62)))
    w241 = w181 * w222 + w41 * (w63 - w12 * w218) - (w11 * w225 + w4 * w227 + w0 * w229) + (w184 * w232 - w75 * (w76 + w12 * w13))
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # top.e1
            w77 + (w78 * w82 + w85 * (w86 + w10 * w11)) - (w87 * w92 + w100) - w87 * w143 - w158 * w164,
            w209 + (w78 * w211 + w85 * (w113 - w8)) - w87 * w214 - w143 * w159 - w158 * w215,
            w233 + (w78 * w236 + w85 * (w43 + w133 + w11 * w218)) - w87 * w238 - w143 * w161 - w158 * w239,
        ),
        ca.horzcat(  # top.e2
            w172 + (w82 * w173 + w85 * (w76 - (w112 - w4 * w10))) - w92 * w159 - w87 * w179 - w164 * w180,
            w216 + (w173 * w211 + w85 * w174) - (w100 + w159 * w214) - w159 * w179 - w180 * w215,
            w240 + (w173 * w236 + w85 * (w167 + w4 * w218)) - w159 * w238 - w161 * w179 - w180 * w239,
        ),
        ca.horzcat(  # top.e3
            w185 + (w82 * w186 + w85 * (w42 + w64)) - w92 * w161 - w87 * w190 - w164 * w191,
            w217 + (w186 * w211 + w85 * w187) - w161 * w214 - w159 * w190 - w191 * w215,
            w241 + (w186 * w236 + w85 * (w183 + w223)) - (w100 + w161 * w238) - w161 * w190 - w191 * w239,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    512 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 25)
    top_e1 = q_i[0]
    top_e2 = q_i[1]
    top_e3 = q_i[2]
    top_e0 = q_d[3]
    top_e1_dot = q_i_dot[0]
    top_e2_dot = q_i_dot[1]
    top_e3_dot = q_i_dot[2]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    top_foot_y = c[6]
    top_mass = c[7]
    # intermediate terms (119)
    w0 = 2 * top_e0
    w1 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w2 = w0 * w1
    w3 = 2 * top_e3
    w4 = 2 * top_e1
    w5 = (w4 * top_e2 - w0 * top_e3) * top_foot_y
    w6 = w2 - w3 * w5
    w7 = top_e1 * -2.0
    w8 = top_e2 * -2.0
    w9 = w5 * w8
    w10 = w1 * w7 - w9
    w11 = top_e1 / top_e0
    w12 = top_e2 / top_e0
    w13 = top_e3 / top_e0
    w14 = w11 * top_e1_dot + w12 * top_e2_dot + w13 * top_e3_dot
    w15 = 2 * w14
    w16 = (w11 * w15 + 2 * top_e1_dot) / top_e0
    w17 = top_e3 * -2.0
    w18 = w14 * w17
    w19 = w0 * top_e3_dot
    w20 = w8 * top_e1_dot - w18 + w4 * top_e2_dot + w19
    w21 = w0 * top_e1_dot - w7 * w14
    w22 = 2 * top_e2
    w23 = w21 + top_e2_dot * w17 + top_e3_dot * w22
    w24 = (w0 * top_e1 + top_e3 * w22) * top_foot_y
    w25 = w5 * w20 - w23 * w24
    w26 = w0 - w7 * w11
    w27 = w11 * w17
    w28 = w8 - w27
    w29 = w5 * w28 - w24 * w26
    w30 = w8 * w14
    w31 = w0 * top_e2_dot
    w32 = w3 * top_e1_dot - w30 + w31 + w7 * top_e3_dot
    w33 = w24 * w32 - w1 * w20
    w34 = w8 * w11
    w35 = w3 - w34
    w36 = w24 * w35 - w1 * w28
    w37 = (w10 * w16 - (w25 * w26 + w23 * w29 - (w33 * w35 + w32 * w36))) * top_mass
    w38 = w19 + (top_e1_dot * w22 - w18 + w7 * top_e2_dot)
    w39 = w17 - w34
    w40 = w31 + (top_e1_dot * w17 - w30) + w4 * top_e3_dot
    w41 = w22 - w27
    w42 = w38 * w39 + w40 * w41
    w43 = w7 * w16
    w44 = (w42 - w43) * c0 - (w42 + w43) * c1
    w45 = w21 + w3 * top_e2_dot + w8 * top_e3_dot
    w46 = w26 * w38 + w41 * w45
    w47 = w8 * w16
    w48 = (w46 - w47) * c1 - (w46 + w47) * c3
    w49 = w26 * w40 + w39 * w45
    w50 = w16 * w17
    w51 = (w49 - w50) * c3 - (w49 + w50) * c0
    w52 = w0 * w24
    w53 = w9 - w52
    w54 = w7 * w24
    w55 = w5 * w17 - w54
    w56 = w1 * w23 - w5 * w32
    w57 = w1 * w26 - w5 * w35
    w58 = (w16 * w55 - (w28 * w33 + w20 * w36 - (w26 * w56 + w23 * w57))) * top_mass
    w59 = w3 * w24 - w1 * w8
    w60 = w1 * w17
    w61 = w8 * w24 - w60
    w62 = (w16 * w61 - (w35 * w56 + w32 * w57 - (w25 * w28 + w20 * w29))) * top_mass
    w63 = w10 * w37 - (w7 * w44 + w8 * w48 + w17 * w51) + w55 * w58 + w61 * w62
    w64 = w0 * w5
    w65 = w60 - w64
    w66 = w4 * w5 - w17 * w24
    w67 = w52 - w1 * w4
    w68 = w1 * w22 - w5 * w7
    w69 = w64 - w22 * w24
    w70 = w54 - w2
    w71 = (w12 * w15 + 2 * top_e2_dot) / top_e0
    w72 = w7 * w12
    w73 = w17 - w72
    w74 = w12 * w17
    w75 = w4 - w74
    w76 = w5 * w75 - w24 * w73
    w77 = w0 - w8 * w12
    w78 = w24 * w77 - w1 * w75
    w79 = (w10 * w71 - (w25 * w73 + w23 * w76 - (w33 * w77 + w32 * w78))) * top_mass
    w80 = w7 - w74
    w81 = w38 * w77 + w40 * w80
    w82 = w7 * w71
    w83 = (w81 - w82) * c0 - (w81 + w82) * c1
    w84 = w3 - w72
    w85 = w38 * w84 + w45 * w80
    w86 = w8 * w71
    w87 = (w85 - w86) * c1 - (w85 + w86) * c3
    w88 = w40 * w84 + w45 * w77
    w89 = w17 * w71
    w90 = (w88 - w89) * c3 - (w88 + w89) * c0
    w91 = w1 * w73 - w5 * w77
    w92 = (w55 * w71 - (w33 * w75 + w20 * w78 - (w56 * w73 + w23 * w91))) * top_mass
    w93 = (w61 * w71 - (w56 * w77 + w32 * w91 - (w25 * w75 + w20 * w76))) * top_mass
    w94 = w10 * w79 - (w7 * w83 + w8 * w87 + w17 * w90) + w55 * w92 + w61 * w93
    w95 = (w13 * w15 + 2 * top_e3_dot) / top_e0
    w96 = w7 * w13
    w97 = w22 - w96
    w98 = w0 - w13 * w17
    w99 = w5 * w98 - w24 * w97
    w100 = w8 * w13
    w101 = w7 - w100
    w102 = w24 * w101 - w1 * w98
    w103 = (w10 * w95 - (w25 * w97 + w23 * w99 - (w33 * w101 + w32 * w102))) * top_mass
    w104 = w4 - w100
    w105 = w38 * w104 + w40 * w98
    w106 = w7 * w95
    w107 = (w105 - w106) * c0 - (w105 + w106) * c1
    w108 = w8 - w96
    w109 = w38 * w108 + w45 * w98
    w110 = w8 * w95
    w111 = (w109 - w110) * c1 - (w109 + w110) * c3
    w112 = w40 * w108 + w45 * w104
    w113 = w17 * w95
    w114 = (w112 - w113) * c3 - (w112 + w113) * c0
    w115 = w1 * w97 - w5 * w101
    w116 = (w55 * w95 - (w33 * w98 + w20 * w102 - (w56 * w97 + w23 * w115))) * top_mass
    w117 = (w61 * w95 - (w56 * w101 + w32 * w115 - (w25 * w98 + w20 * w99))) * top_mass
    w118 = w10 * w103 - (w7 * w107 + w8 * w111 + w17 * w114) + w55 * w116 + w61 * w117
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # top.e1
            w6 * w37 - (w0 * w44 + w17 * w48 + w22 * w51) + w53 * w58 + w59 * w62 - w11 * w63,
            w6 * w79 - (w0 * w83 + w17 * w87 + w22 * w90) + w53 * w92 + w59 * w93 - w11 * w94,
            w6 * w103 - (w0 * w107 + w17 * w111 + w22 * w114) + w53 * w116 + w59 * w117 - w11 * w118,
        ),
        ca.horzcat(  # top.e2
            w37 * w65 - (w3 * w44 + w0 * w48 + w7 * w51) + w58 * w66 + w62 * w67 - w12 * w63,
            w65 * w79 - (w3 * w83 + w0 * w87 + w7 * w90) + w66 * w92 + w67 * w93 - w12 * w94,
            w65 * w103 - (w3 * w107 + w0 * w111 + w7 * w114) + w66 * w116 + w67 * w117 - w12 * w118,
        ),
        ca.horzcat(  # top.e3
            w37 * w68 - (w8 * w44 + w4 * w48 + w0 * w51) + w58 * w69 + w62 * w70 - w13 * w63,
            w68 * w79 - (w8 * w83 + w4 * w87 + w0 * w90) + w69 * w92 + w70 * w93 - w13 * w94,
            w68 * w103 - (w8 * w107 + w4 * w111 + w0 * w114) + w69 * w116 + w70 * w117 - w13 * w118,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 3 x 3) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1655 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 25)
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
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    top_foot_y = c[6]
    top_mass = c[7]
    gravity_z = c[14]
    c23 = c[23]
    # intermediate terms (402)
    w0 = 2 * top_e0
    w1 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w2 = w0 * w1
    w3 = 2 * top_e3
    w4 = 2 * top_e1
    w5 = (w4 * top_e2 - w0 * top_e3) * top_foot_y
    w6 = w2 - w3 * w5
    w7 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w8 = top_e1 / top_e0
    w9 = top_e2 / top_e0
    w10 = top_e3 / top_e0
    w11 = w7 + w8 * top_e1_ddot + w9 * top_e2_ddot + w10 * top_e3_ddot
    w12 = w1 * -2.0
    w13 = top_e1 * -2.0
    w14 = top_e1 * c23
    w15 = top_e2 * -2.0
    w16 = 2 * top_e2
    w17 = w16 * top_foot_y
    w18 = w15 * w17
    w19 = w12 - w13 * w14 - w18
    w20 = w5 * w15
    w21 = w1 * w13 - w20
    w22 = top_e1_ddot / top_e0
    w23 = top_e3 * -2.0
    w24 = top_e0_dot * w23
    w25 = top_e1_dot * w15
    w26 = w4 * top_e2_dot
    w27 = w0 * top_e3_dot
    w28 = w24 + w25 + w26 + w27
    w29 = w0 * top_e1_dot
    w30 = top_e0_dot * w13 + w29
    w31 = top_e2_dot * w23
    w32 = top_e3_dot * w16
    w33 = w30 + w31 + w32
    w34 = (w0 * top_e1 + top_e3 * w16) * top_foot_y
    w35 = w5 * w28 - w33 * w34
    w36 = top_e0_dot * -2.0
    w37 = w35 * w36
    w38 = 2 * top_e2_dot
    w39 = w5 * w38
    w40 = w34 * w36
    w41 = w0 * top_foot_y
    w42 = w39 + w17 * w28 - (w40 + w33 * w41)
    w43 = top_e0_dot * w15
    w44 = w3 * top_e1_dot
    w45 = w0 * top_e2_dot
    w46 = top_e3_dot * w13
    w47 = w43 + w44 + w45 + w46
    w48 = w34 * w47 - w1 * w28
    w49 = top_e3_dot * -2.0
    w50 = w41 * w47
    w51 = w34 * w49 + w50 - (w1 * w38 - w14 * w28)
    w52 = w0 * w14
    w53 = w3 * w17
    w54 = w52 + w53
    w55 = w14 * w23
    w56 = w0 * w17
    w57 = w55 + w56
    w58 = w11 * w19 + w21 * w22 - (w37 + w33 * w42 - (w48 * w49 + w47 * w51)) + top_e1_ddot * w54 + top_e2_ddot * w57
    w59 = w5 * -2.0
    w60 = w13 * w17
    w61 = w14 * w16 + (w59 + w60)
    w62 = (w58 + top_e3_ddot * w61) * top_mass
    w63 = w1 * w23
    w64 = w0 * w5
    w65 = w63 - w64
    w66 = w1 * w16 - w5 * w13
    w67 = w11 * w21 - (w33 * w35 - w47 * w48) - w6 * top_e1_ddot - top_e2_ddot * w65 - top_e3_ddot * w66 - gravity_z
    w68 = w67 * top_mass
    w69 = top_e1_dot * w16
    w70 = top_e2_dot * w13
    w71 = w27 + (w24 + w69 + w70)
    w72 = 2 * top_e3_dot
    w73 = top_e1_dot * w23
    w74 = w4 * top_e3_dot
    w75 = w45 + (w43 + w73) + w74
    w76 = top_e2_dot * -2.0
    w77 = w71 * w72 + w75 * w76
    w78 = w11 * -2.0
    w79 = w13 * w22 + w78
    w80 = (w77 - w79) * c0 - (w77 + w79) * c1
    w81 = w36 * w71
    w82 = w3 * top_e2_dot
    w83 = top_e3_dot * w15
    w84 = w30 + w82 + w83
    w85 = w81 + w76 * w84
    w86 = 2 * top_e3_ddot
    w87 = w86 - w15 * w22
    w88 = (w85 + w87) * c1 - (w85 - w87) * c3
    w89 = w36 * w75
    w90 = w72 * w84
    w91 = w89 + w90
    w92 = top_e2_ddot * -2.0 - w22 * w23
    w93 = (w91 + w92) * c3 - (w91 - w92) * c0
    w94 = w0 * w34
    w95 = w20 - w94
    w96 = w17 * w23
    w97 = w34 * -2.0
    w98 = w13 * w41
    w99 = w97 + w98
    w100 = w96 - w99
    w101 = w13 * w34
    w102 = w5 * w23 - w101
    w103 = w38 * w48
    w104 = w1 * w33 - w5 * w47
    w105 = w36 * w104
    w106 = w1 * w36
    w107 = w17 * w47
    w108 = w106 - w14 * w33 - (w5 * w49 + w107)
    w109 = w0 * w41
    w110 = w18 - w109
    w111 = 2 * w5
    w112 = w23 * w41
    w113 = w111 + w4 * w17 - w112
    w114 = w11 * w100 + w22 * w102 - (w103 + w28 * w51 - (w105 + w33 * w108)) - top_e1_ddot * w110 - top_e2_ddot * w113
    w115 = w56 - w16 * w41
    w116 = (w114 - top_e3_ddot * w115) * top_mass
    w117 = w4 * w5 - w23 * w34
    w118 = w64 - w16 * w34
    w119 = w11 * w102 - (w28 * w48 - w33 * w104) - top_e1_ddot * w95 - top_e2_ddot * w117 - top_e3_ddot * w118
    w120 = w119 * top_mass
    w121 = w3 * w34 - w1 * w15
    w122 = w15 * w41
    w123 = w55 + w122
    w124 = w15 * w34 - w63
    w125 = w3 * w41
    w126 = w125 + w14 * w15
    w127 = w11 * w123 + w22 * w124 - (w49 * w104 + w47 * w108 - (w35 * w38 + w28 * w42)) - top_e1_ddot * w126
    w128 = 2 * w1
    w129 = w109 - (w128 - w4 * w14)
    w130 = w52 + w99
    w131 = (w127 - top_e2_ddot * w129 - top_e3_ddot * w130) * top_mass
    w132 = w94 - w1 * w4
    w133 = w101 - w2
    w134 = w11 * w124 - (w47 * w104 - w28 * w35) - top_e1_ddot * w121 - top_e2_ddot * w132 - top_e3_ddot * w133
    w135 = w134 * top_mass
    w136 = w6 * w62 - w54 * w68 - (w0 * w80 + w23 * w88 + w16 * w93) + (w95 * w116 + w110 * w120) + (w121 * w131 + w126 * w135)
    w137 = w71 * w75
    w138 = w0 * top_e1_ddot - w11 * w13 + w3 * top_e2_ddot + top_e3_ddot * w15
    w139 = (w137 + w138) * c0 - (w137 - w138) * c1
    w140 = w139 * -2.0
    w141 = w21 * w62 + w19 * w68 - (w140 + w13 * w80 + w15 * w88 + w23 * w93) + (w102 * w116 + w100 * w120) + (w124 * w131 + w123 * w135)
    w142 = w71 * w84
    w143 = top_e1_ddot * w23 - w11 * w15 + w0 * top_e2_ddot + w4 * top_e3_ddot
    w144 = (w142 + w143) * c1 - (w142 - w143) * c3
    w145 = w75 * w84
    w146 = top_e1_ddot * w16 - w11 * w23 + top_e2_ddot * w13 + w0 * top_e3_ddot
    w147 = (w145 + w146) * c3 - (w145 - w146) * c0
    w148 = w21 * w68 - (w13 * w139 + w15 * w144 + w23 * w147) + w102 * w120 + w124 * w135
    w149 = w148 / top_e0
    w150 = w3 * top_foot_y
    w151 = w15 * w150
    w152 = w8 / top_e0
    w153 = w9 / top_e0
    w154 = w10 / top_e0
    w155 = w7 / top_e0 + top_e1_ddot * w152 + top_e2_ddot * w153 + top_e3_ddot * w154
    w156 = 2 * top_e1_dot
    w157 = w34 * w156
    w158 = w4 * top_foot_y
    w159 = w5 * w72 - w28 * w150 - (w157 + w33 * w158)
    w160 = w47 * w158
    w161 = w1 * w72
    w162 = w34 * w38 + w160 - w161
    w163 = w3 * w150
    w164 = w128 + w163
    w165 = w0 * w150
    w166 = w111 - w165
    w167 = w11 * w151 - w21 * w155 - (w35 * w156 + w33 * w159 - (w103 + w47 * w162)) - top_e1_ddot * w164 + top_e2_ddot * w166
    w168 = w13 * w150
    w169 = top_e3_ddot * w168
    w170 = (w167 - w169) * top_mass
    w171 = 2 * w139
    w172 = w38 * w71
    w173 = w172 + w72 * w75
    w174 = 2 * top_e1_ddot
    w175 = w174 + w13 * w155
    w176 = (w173 + w175) * c0 - (w173 - w175) * c1
    w177 = w90 + w71 * w156
    w178 = 2 * top_e2_ddot
    w179 = w15 * w155 + w178
    w180 = (w177 + w179) * c1 - (w177 - w179) * c3
    w181 = w75 * w156
    w182 = w181 + w38 * w84
    w183 = w86 + w23 * w155
    w184 = (w182 + w183) * c3 - (w182 - w183) * c0
    w185 = 2 * w34
    w186 = w0 * w158
    w187 = w185 + w186
    w188 = w151 + w187
    w189 = w23 * w150
    w190 = w13 * w158
    w191 = w189 + w190
    w192 = w104 * w156
    w193 = w47 * w150
    w194 = w1 * w156 - (w39 - w193)
    w195 = w23 * w158
    w196 = w4 * w150 + w195
    w197 = top_e1_ddot * w188 - (w11 * w191 + w102 * w155 + (w48 * w72 + w28 * w162 - (w192 + w33 * w194))) + top_e2_ddot * w196
    w198 = w166 - w16 * w158
    w199 = (w197 - top_e3_ddot * w198) * top_mass
    w200 = w6 * w170 + w68 * w164 - (w171 + w0 * w176 + w23 * w180 + w16 * w184) + (w95 * w199 - w120 * w188)
    w201 = w15 * w158
    w202 = w35 * w72
    w203 = w3 * w158
    w204 = top_e1_ddot * w203
    w205 = w11 * w201 - w124 * w155 - (w38 * w104 + w47 * w194 - (w202 + w28 * w159)) - w204 - top_e2_ddot * w187
    w206 = w190 - w128
    w207 = (w205 - top_e3_ddot * w206) * top_mass
    w208 = w21 * w170 + w68 * w151 - (w13 * w176 + w15 * w180 + w23 * w184) + (w102 * w199 - w120 * w191) + (w124 * w207 + w135 * w201)
    w209 = w200 + (w121 * w207 + w135 * w203) - (w8 * w208 - w148 * w152)
    w210 = 2 * top_e0_dot / top_e0
    w211 = (w21 * w210 - (w13 * w35 + w33 * w102 - (w15 * w48 + w47 * w124))) * top_mass
    w212 = w15 * w71 + w23 * w75
    w213 = w13 * w210
    w214 = (w212 - w213) * c0 - (w212 + w213) * c1
    w215 = w13 * w71 + w23 * w84
    w216 = w15 * w210
    w217 = (w215 - w216) * c1 - (w215 + w216) * c3
    w218 = w13 * w75 + w15 * w84
    w219 = w23 * w210
    w220 = (w218 - w219) * c3 - (w218 + w219) * c0
    w221 = (w102 * w210 - (w23 * w48 + w28 * w124 - (w13 * w104 + w21 * w33))) * top_mass
    w222 = (w124 * w210 - (w15 * w104 + w21 * w47 - (w23 * w35 + w28 * w102))) * top_mass
    w223 = w21 * w211 - (w13 * w214 + w15 * w217 + w23 * w220) + w102 * w221 + w124 * w222
    w224 = w6 * w211 - (w0 * w214 + w23 * w217 + w16 * w220) + w95 * w221 + w121 * w222 - w8 * w223
    w225 = top_e1_dot * w152 + top_e2_dot * w153 + top_e3_dot * w154
    w226 = top_e1_dot / top_e0 + w8 * w225
    w227 = w147 * -2.0
    w228 = w62 * w65 - w57 * w68 - (w3 * w80 + w0 * w88 + (w227 + w13 * w93)) + (w116 * w117 + w113 * w120) + (w131 * w132 + w129 * w135)
    w229 = 2 * w144
    w230 = w65 * w170 - w68 * w166 - (w3 * w176 + (w229 + w0 * w180) + w13 * w184) + (w117 * w199 - w120 * w196)
    w231 = w230 + (w132 * w207 + w135 * w187) - (w9 * w208 - w148 * w153)
    w232 = w65 * w211 - (w3 * w214 + w0 * w217 + w13 * w220) + w117 * w221 + w132 * w222 - w9 * w223
    w233 = w62 * w66 - w61 * w68 - (w15 * w80 + (w229 + w4 * w88) + w0 * w93) + (w116 * w118 + w115 * w120) + (w131 * w133 + w130 * w135)
    w234 = 2 * w147
    w235 = w66 * w170 + w68 * w168 - (w15 * w176 + w4 * w180 + (w234 + w0 * w184)) + (w118 * w199 + w120 * w198)
    w236 = w235 + (w133 * w207 + w135 * w206) - (w10 * w208 - w148 * w154)
    w237 = w66 * w211 - (w15 * w214 + w4 * w217 + w0 * w220) + w118 * w221 + w133 * w222 - w10 * w223
    w238 = top_e2_ddot / top_e0
    w239 = w59 + w201
    w240 = top_e1_dot * -2.0
    w241 = w5 * w240 + w28 * w158 - (w34 * w72 + w33 * w150)
    w242 = w36 * w48
    w243 = w40 + w193 - w1 * w240
    w244 = w204 + (w21 * w238 - w11 * w239 - (w202 + w33 * w241 - (w242 + w47 * w243))) + top_e2_ddot * w186
    w245 = w128 - w190
    w246 = (w244 - top_e3_ddot * w245) * top_mass
    w247 = w81 + w181
    w248 = top_e3_ddot * -2.0 - w13 * w238
    w249 = (w247 + w248) * c0 - (w247 - w248) * c1
    w250 = w49 * w71 + w84 * w156
    w251 = w78 + w15 * w238
    w252 = (w250 - w251) * c1 - (w250 + w251) * c3
    w253 = w36 * w84
    w254 = w49 * w75 + w253
    w255 = w174 - w23 * w238
    w256 = (w254 + w255) * c3 - (w254 - w255) * c0
    w257 = w195 - w168
    w258 = w5 * w36
    w259 = w161 - (w160 + w258)
    w260 = w239 - w165
    w261 = w11 * w257 + w102 * w238 - (w48 * w240 + w28 * w243 - (w72 * w104 + w33 * w259)) - top_e1_ddot * w260
    w262 = w4 * w158 - w189
    w263 = w186 - (w185 + w16 * w150)
    w264 = (w261 - top_e2_ddot * w262 - top_e3_ddot * w263) * top_mass
    w265 = w6 * w246 - w68 * w203 - (w0 * w249 + w23 * w252 + (w234 + w16 * w256)) + (w95 * w264 + w120 * w260)
    w266 = w97 + w151
    w267 = w163 - w12
    w268 = w11 * w266 + w124 * w238 - (w105 + w47 * w259 - (w35 * w240 + w28 * w241)) - top_e1_ddot * w267 - top_e2_ddot * w165
    w269 = (w268 - w169) * top_mass
    w270 = w144 * -2.0
    w271 = w21 * w246 - w68 * w239 - (w13 * w249 + (w270 + w15 * w252) + w23 * w256) + (w102 * w264 + w120 * w257)
    w272 = w271 + (w124 * w269 + w135 * w266)
    w273 = top_e2_dot / top_e0 + w9 * w225
    w274 = w65 * w246 - w68 * w186 - (w3 * w249 + w0 * w252 + w13 * w256) + (w117 * w264 + w120 * w262) + (w132 * w269 + w135 * w165)
    w275 = w66 * w246 + w68 * w245 - (w140 + w15 * w249 + w4 * w252 + w0 * w256) + (w118 * w264 + w120 * w263)
    w276 = top_e3 * c23
    w277 = w122 - w13 * w276
    w278 = top_e3_ddot / top_e0
    w279 = w258 - w28 * w41 - (w34 * w76 + w17 * w33)
    w280 = w107 + w157 - (w106 - w28 * w276)
    w281 = w0 * w276
    w282 = w281 + (w111 - w125)
    w283 = w11 * w277 + w21 * w278 - (w35 * w76 + w33 * w279 - (w48 * w156 + w47 * w280)) + top_e1_ddot * w282
    w284 = w12 - w23 * w276
    w285 = w109 + w284
    w286 = w98 - w16 * w276
    w287 = (w283 - top_e2_ddot * w285 - top_e3_ddot * w286) * top_mass
    w288 = w89 + w71 * w240
    w289 = w178 - w13 * w278
    w290 = (w288 + w289) * c0 - (w288 - w289) * c1
    w291 = w172 + w253
    w292 = top_e1_ddot * -2.0 - w15 * w278
    w293 = (w291 + w292) * c1 - (w291 - w292) * c3
    w294 = w38 * w75 + w84 * w240
    w295 = w78 + w23 * w278
    w296 = (w294 - w295) * c3 - (w294 + w295) * c0
    w297 = w59 - w112 - w60
    w298 = w1 * w76 - w33 * w276 - (w5 * w156 - w50)
    w299 = w56 + w122
    w300 = w4 * w41 + (w96 + w97)
    w301 = w11 * w297 + w102 * w278 - (w242 + w28 * w280 - (w76 * w104 + w33 * w298)) + top_e1_ddot * w299 + top_e2_ddot * w300
    w302 = w109 + w16 * w17
    w303 = (w301 + top_e3_ddot * w302) * top_mass
    w304 = w6 * w287 - w68 * w282 - (w0 * w290 + (w270 + w23 * w293) + w16 * w296) + (w95 * w303 - w120 * w299)
    w305 = w18 - w284
    w306 = w53 + w185 + w15 * w276
    w307 = w56 + w4 * w276
    w308 = w11 * w305 + w124 * w278 - (w192 + w47 * w298 - (w37 + w28 * w279)) - top_e1_ddot * w306 - top_e2_ddot * w307
    w309 = w60 + w281
    w310 = (w308 - top_e3_ddot * w309) * top_mass
    w311 = w21 * w287 + w68 * w277 - (w13 * w290 + w15 * w293 + (w227 + w23 * w296)) + (w102 * w303 + w120 * w297)
    w312 = w311 + (w124 * w310 + w135 * w305)
    w313 = top_e3_dot / top_e0 + w10 * w225
    w314 = w65 * w287 + w68 * w285 - (w171 + w3 * w290 + w0 * w293 + w13 * w296) + (w117 * w303 - w120 * w300)
    w315 = w66 * w287 + w68 * w286 - (w15 * w290 + w4 * w293 + w0 * w296) + (w118 * w303 - w120 * w302) + (w133 * w310 + w135 * w309)
    w316 = top_e1_dot * w8 + top_e2_dot * w9 + top_e3_dot * w10
    w317 = 2 * w316
    w318 = (w156 + w8 * w317) / top_e0
    w319 = w23 * w316
    w320 = w27 + (w26 + (w25 - w319))
    w321 = w29 - w13 * w316
    w322 = w32 + (w31 + w321)
    w323 = w5 * w320 - w34 * w322
    w324 = w0 - w8 * w13
    w325 = w8 * w23
    w326 = w15 - w325
    w327 = w5 * w326 - w34 * w324
    w328 = w15 * w316
    w329 = w46 + (w45 + (w44 - w328))
    w330 = w34 * w329 - w1 * w320
    w331 = w8 * w15
    w332 = w3 - w331
    w333 = w34 * w332 - w1 * w326
    w334 = (w21 * w318 - (w323 * w324 + w322 * w327 - (w330 * w332 + w329 * w333))) * top_mass
    w335 = w27 + (w70 + (w69 - w319))
    w336 = w23 - w331
    w337 = w74 + (w45 + (w73 - w328))
    w338 = w16 - w325
    w339 = w335 * w336 + w337 * w338
    w340 = w13 * w318
    w341 = (w339 - w340) * c0 - (w339 + w340) * c1
    w342 = w83 + (w82 + w321)
    w343 = w324 * w335 + w338 * w342
    w344 = w15 * w318
    w345 = (w343 - w344) * c1 - (w343 + w344) * c3
    w346 = w324 * w337 + w336 * w342
    w347 = w23 * w318
    w348 = (w346 - w347) * c3 - (w346 + w347) * c0
    w349 = w1 * w322 - w5 * w329
    w350 = w1 * w324 - w5 * w332
    w351 = (w102 * w318 - (w326 * w330 + w320 * w333 - (w324 * w349 + w322 * w350))) * top_mass
    w352 = (w124 * w318 - (w332 * w349 + w329 * w350 - (w323 * w326 + w320 * w327))) * top_mass
    w353 = w21 * w334 - (w13 * w341 + w15 * w345 + w23 * w348) + w102 * w351 + w124 * w352
    w354 = (w38 + w9 * w317) / top_e0
    w355 = w9 * w13
    w356 = w23 - w355
    w357 = w9 * w23
    w358 = w4 - w357
    w359 = w5 * w358 - w34 * w356
    w360 = w0 - w9 * w15
    w361 = w34 * w360 - w1 * w358
    w362 = (w21 * w354 - (w323 * w356 + w322 * w359 - (w330 * w360 + w329 * w361))) * top_mass
    w363 = w13 - w357
    w364 = w335 * w360 + w337 * w363
    w365 = w13 * w354
    w366 = (w364 - w365) * c0 - (w364 + w365) * c1
    w367 = w3 - w355
    w368 = w335 * w367 + w342 * w363
    w369 = w15 * w354
    w370 = (w368 - w369) * c1 - (w368 + w369) * c3
    w371 = w337 * w367 + w342 * w360
    w372 = w23 * w354
    w373 = (w371 - w372) * c3 - (w371 + w372) * c0
    w374 = w1 * w356 - w5 * w360
    w375 = (w102 * w354 - (w330 * w358 + w320 * w361 - (w349 * w356 + w322 * w374))) * top_mass
    w376 = (w124 * w354 - (w349 * w360 + w329 * w374 - (w323 * w358 + w320 * w359))) * top_mass
    w377 = w21 * w362 - (w13 * w366 + w15 * w370 + w23 * w373) + w102 * w375 + w124 * w376
    w378 = (w72 + w10 * w317) / top_e0
    w379 = w10 * w13
    w380 = w16 - w379
    w381 = w0 - w10 * w23
    w382 = w5 * w381 - w34 * w380
    w383 = w10 * w15
    w384 = w13 - w383
    w385 = w34 * w384 - w1 * w381
    w386 = (w21 * w378 - (w323 * w380 + w322 * w382 - (w330 * w384 + w329 * w385))) * top_mass
    w387 = w4 - w383
    w388 = w335 * w387 + w337 * w381
    w389 = w13 * w378
    w390 = (w388 - w389) * c0 - (w388 + w389) * c1
    w391 = w15 - w379
    w392 = w335 * w391 + w342 * w381
    w393 = w15 * w378
    w394 = (w392 - w393) * c1 - (w392 + w393) * c3
    w395 = w337 * w391 + w342 * w387
    w396 = w23 * w378
    w397 = (w395 - w396) * c3 - (w395 + w396) * c0
    w398 = w1 * w380 - w5 * w384
    w399 = (w102 * w378 - (w330 * w381 + w320 * w385 - (w349 * w380 + w322 * w398))) * top_mass
    w400 = (w124 * w378 - (w349 * w384 + w329 * w398 - (w323 * w381 + w320 * w382))) * top_mass
    w401 = w21 * w386 - (w13 * w390 + w15 * w394 + w23 * w397) + w102 * w399 + w124 * w400
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # top.e1
            w136 - (w8 * w141 + w149) - w8 * w209 - w224 * w226,
            w265 + (w121 * w269 + w135 * w267) - w8 * w272 - w9 * w209 - w224 * w273,
            w304 + (w121 * w310 + w135 * w306) - w8 * w312 - w10 * w209 - w224 * w313,
        ),
        ca.horzcat(  # top.e2
            w228 - w9 * w141 - w8 * w231 - w226 * w232, w274 - (w149 + w9 * w272) - w9 * w231 - w232 * w273,
            w314 + (w132 * w310 + w135 * w307) - w9 * w312 - w10 * w231 - w232 * w313,
        ),
        ca.horzcat(  # top.e3
            w233 - w10 * w141 - w8 * w236 - w226 * w237,
            w275 + (w133 * w269 + w135 * w168) - w10 * w272 - w9 * w236 - w237 * w273,
            w315 - (w149 + w10 * w312) - w10 * w236 - w237 * w313,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # top.e1
            w6 * w334 - (w0 * w341 + w23 * w345 + w16 * w348) + w95 * w351 + w121 * w352 - w8 * w353,
            w6 * w362 - (w0 * w366 + w23 * w370 + w16 * w373) + w95 * w375 + w121 * w376 - w8 * w377,
            w6 * w386 - (w0 * w390 + w23 * w394 + w16 * w397) + w95 * w399 + w121 * w400 - w8 * w401,
        ),
        ca.horzcat(  # top.e2
            w65 * w334 - (w3 * w341 + w0 * w345 + w13 * w348) + w117 * w351 + w132 * w352 - w9 * w353,
            w65 * w362 - (w3 * w366 + w0 * w370 + w13 * w373) + w117 * w375 + w132 * w376 - w9 * w377,
            w65 * w386 - (w3 * w390 + w0 * w394 + w13 * w397) + w117 * w399 + w132 * w400 - w9 * w401,
        ),
        ca.horzcat(  # top.e3
            w66 * w334 - (w15 * w341 + w4 * w345 + w0 * w348) + w118 * w351 + w133 * w352 - w10 * w353,
            w66 * w362 - (w15 * w366 + w4 * w370 + w0 * w373) + w118 * w375 + w133 * w376 - w10 * w377,
            w66 * w386 - (w15 * w390 + w4 * w394 + w0 * w397) + w118 * w399 + w133 * w400 - w10 * w401,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    takes c (n_const = 25) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    402 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 4)
    c = ca.SX.sym("c", 25)
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
    c13 = c[13]
    c17 = c[17]
    c18 = c[18]
    c21 = c[21]
    c24 = c[24]
    # intermediate terms (92)
    w0 = 2 * top_e0
    w1 = top_e1 * -2.0
    w2 = w1 * c2
    w3 = top_e3 * -2.0
    w4 = top_e2 * -2.0
    w5 = w4 * c4
    w6 = 2 * top_e2
    w7 = w3 * c5
    w8 = (1.0 - 2 * top_e1**2 - 2 * top_e3**2) * top_foot_y
    w9 = 2 * top_e1
    w10 = (top_e2 * w9 - w0 * top_e3) * top_foot_y
    w11 = w4 * w10
    w12 = w1 * w8 - w11
    w13 = w0 * w8
    w14 = 2 * top_e3
    w15 = w13 - w10 * w14
    w16 = w15 * top_mass
    w17 = (w0 * top_e1 + top_e3 * w6) * top_foot_y
    w18 = w1 * w17
    w19 = w3 * w10 - w18
    w20 = w0 * w17
    w21 = w11 - w20
    w22 = w21 * top_mass
    w23 = w3 * w8
    w24 = w4 * w17 - w23
    w25 = w14 * w17 - w4 * w8
    w26 = w25 * top_mass
    w27 = w0 * w2 + top_e3 * top_e2 * c8 + w12 * w16 + w19 * w22 + w24 * w26
    w28 = (top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2) / top_e0
    w29 = w4 * top_e0_dot
    w30 = w0 * top_e2_dot
    w31 = w29 + w3 * top_e1_dot + w30 + w9 * top_e3_dot
    w32 = w3 * top_e0_dot
    w33 = w0 * top_e3_dot
    w34 = w32 + w6 * top_e1_dot + w1 * top_e2_dot + w33
    w35 = w31 * w34
    w36 = w35 * c0 - w35 * c1
    w37 = w1 * top_e0_dot + w0 * top_e1_dot
    w38 = w37 + w14 * top_e2_dot + w4 * top_e3_dot
    w39 = w34 * w38
    w40 = w39 * c1 - w39 * c3
    w41 = w31 * w38
    w42 = w41 * c3 - w41 * c0
    w43 = w37 + w3 * top_e2_dot + w6 * top_e3_dot
    w44 = w33 + (w32 + w4 * top_e1_dot + w9 * top_e2_dot)
    w45 = w10 * w44 - w17 * w43
    w46 = w30 + (w29 + w14 * top_e1_dot) + w1 * top_e3_dot
    w47 = w17 * w46 - w8 * w44
    w48 = c21 + (w43 * w45 - w46 * w47) * top_mass
    w49 = w8 * w43 - w10 * w46
    w50 = (w44 * w47 - w43 * w49) * top_mass
    w51 = (w46 * w49 - w44 * w45) * top_mass
    w52 = top_e1 / top_e0
    w53 = w1 * w2 + w4 * w5 + w3 * w7 + w12 * (w12 * top_mass) + w19 * (w19 * top_mass) + w24 * (w24 * top_mass)
    w54 = w28 * w53 - (w1 * w36 + w4 * w40 + w3 * w42 + w12 * w48 + w19 * w50 + w24 * w51)
    w55 = w3 * c4
    w56 = w6 * c5
    w57 = w6 * w8 - w1 * w10
    w58 = w57 * top_mass
    w59 = w0 * w10
    w60 = w59 - w6 * w17
    w61 = w60 * top_mass
    w62 = w18 - w13
    w63 = w62 * top_mass
    w64 = top_e1 * top_e2 * c18 + w0 * w7 + w12 * w58 + w19 * w61 + w24 * w63
    w65 = top_e3 / top_e0
    w66 = w64 - w53 * w65
    w67 = w9 * w55 + top_e0 * top_e2 * c24 + w15 * w58 + w21 * w61 + w25 * w63 - (w52 * w66 + w27 * w65)
    w68 = w4 * (w4 * c2) + w9 * (w9 * c4) + w0 * (w0 * c5) + w57 * w58 + w60 * w61 + w62 * w63 - (w65 * w66 + w64 * w65)
    w69 = w67 / w68
    w70 = w28 * w64 - (w4 * w36 + w9 * w40 + w0 * w42 + w48 * w57 + w50 * w60 + w51 * w62) - w54 * w65
    w71 = w27 * w28 - (w0 * w36 + w3 * w40 + w6 * w42 + w15 * w48 + w21 * w50 + w25 * w51) - w52 * w54 - w69 * w70
    w72 = w23 - w59
    w73 = w72 * top_mass
    w74 = w9 * w10 - w3 * w17
    w75 = w74 * top_mass
    w76 = w20 - w8 * w9
    w77 = w76 * top_mass
    w78 = w0 * w5 + top_e1 * top_e3 * c17 + w12 * w73 + w19 * w75 + w24 * w77
    w79 = top_e2 / top_e0
    w80 = w78 - w53 * w79
    w81 = w14 * c2
    w82 = w4 * w81 + top_e0 * top_e1 * c13 + w58 * w72 + w61 * w74 + w63 * w76 - (w66 * w79 + w65 * w78)
    w83 = top_e0 * top_e3 * c9 + w1 * w56 + w15 * w73 + w21 * w75 + w25 * w77 - (w52 * w80 + w27 * w79) - w69 * w82
    w84 = w14 * w81 + w0 * (w0 * c4) + w1 * (w1 * c5) + w72 * w73 + w74 * w75 + w76 * w77 - (w79 * w80 + w78 * w79)
    w85 = w82 / w68
    w86 = w84 - w82 * w85
    w87 = w83 / w86
    w88 = w28 * w78 - (w14 * w36 + w0 * w40 + w1 * w42 + w48 * w72 + w50 * w74 + w51 * w76) - w54 * w79 - w70 * w85
    w89 = w0 * (w0 * c2) + w3 * w55 + w6 * w56 + w15 * w16 + w21 * w22 + w25 * w26 - (w52 * (w27 - w52 * w53) + w27 * w52)
    w90 = (w71 - w87 * w88) / (w89 - w67 * w69 - w83 * w87)
    w91 = (w88 - w83 * w90) / w86
    # outputs
    q_i_ddot = ca.vertcat(w90, w91, (w70 - (w67 * w90 + w82 * w91)) / w68)
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
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
