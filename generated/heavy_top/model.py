"""Heavy top: equations of motion, emitted by symgen from the scene `heavy_top`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 top.turn_x [rad], 1 top.turn_y [rad], 2 top.turn_z [rad]

q_d, the dependent coordinates by index:
    0 top.x [m], 1 top.y [m], 2 top.z [m], 3 top.e0 [1], 4 top.e1 [1], 5 top.e2 [1], 6 top.e3 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    63 operations.
    """
    p = ca.SX.sym("p", 6)
    gravity_z = p[0]
    top_mass = p[1]
    top_inertia_xx = p[2]
    top_inertia_yy = p[3]
    top_inertia_zz = p[4]
    top_foot_y = p[5]
    # intermediate terms (21)
    w0 = top_mass * top_foot_y
    w1 = w0 * gravity_z
    w2 = top_inertia_xx + top_inertia_yy
    w3 = (w2 + top_inertia_zz) / 2.0
    w4 = -2.0 * w3
    w5 = top_foot_y * w0
    w6 = gravity_z * (top_foot_y * (2 * top_mass))
    w7 = w3 - top_inertia_yy
    w8 = w3 - top_inertia_zz
    w9 = w3 - top_inertia_xx
    w10 = w8 + w9
    w11 = w7 + w8
    w12 = w7 + w9
    w13 = 4.0 * w10
    w14 = 4.0 * w12
    w15 = 4.0 * w11
    w16 = top_mass * gravity_z
    w17 = w7 + w5
    w18 = -1.0 / (w17 + w8)
    w19 = -1.0 / w10
    w20 = -1.0 / (w17 + w9)
    # outputs
    c = ca.vertcat(
        w1,  # c0
        -(top_inertia_yy + top_inertia_zz + w4 - w5),  # c1
        -(w4 + (top_inertia_xx + top_inertia_zz)),  # c2
        -(w2 + w4 - w5),  # c3
        w6,  # c4
        top_inertia_yy - top_inertia_zz - w5,  # c5
        -(top_inertia_xx - top_inertia_zz),  # c6
        w5 + (top_inertia_xx - top_inertia_yy),  # c7
        -top_foot_y,  # c8
        top_foot_y,  # top_foot_y
        w7,  # c10
        top_mass,  # top_mass
        w8,  # c12
        w9,  # c13
        w10,  # c14
        w11,  # c15
        w12,  # c16
        w13 - w14,  # c17
        w14 - w15,  # c18
        w15 - w13,  # c19
        w16,  # c20
        -w16,  # c21
        w1 * w18,  # c22
        w6 * w18,  # c23
        top_inertia_yy * w18 - top_inertia_zz * w18 - w5 * w18,  # c24
        top_inertia_xx * w19 - top_inertia_zz * w19,  # c25
        w6 * w20,  # c26
        top_inertia_xx * w20 - top_inertia_yy * w20 + w5 * w20,  # c27
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    17 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    # outputs
    M_hat = ca.SX(3, 3)
    # top.turn_x
    M_hat[0, 0] = c1
    # top.turn_y
    M_hat[1, 1] = c2
    # top.turn_z
    M_hat[2, 2] = c3
    Q_hat = ca.vertcat(
        top_omega_y * top_omega_z * c5 + (top_e1**2 + top_e2**2) * c4 - c0,  # top.turn_x
        top_omega_z * top_omega_x * c6,  # top.turn_y
        top_omega_y * top_omega_x * c7 + (top_e1 * top_e3 - top_e2 * top_e0) * c4,  # top.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_d", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 4) [1]: unit quaternions from which the turns in q_i are rotation vectors
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 7) [mixed]: dependent coordinates after one Newton step
    59 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    chart = ca.SX.sym("chart", 4)
    c = ca.SX.sym("c", 28)
    top_turn_x = q_i[0]
    top_turn_y = q_i[1]
    top_turn_z = q_i[2]
    top_chart_0 = chart[0]
    top_chart_1 = chart[1]
    top_chart_2 = chart[2]
    top_chart_3 = chart[3]
    c8 = c[8]
    # intermediate terms (12)
    w0 = ca.sqrt((top_turn_x**2 + top_turn_y**2 + top_turn_z**2) / 4.0 + 1e-300)
    w1 = ca.sin(w0) / w0 / 2.0
    w2 = top_turn_x * w1
    w3 = ca.cos(w0)
    w4 = top_turn_z * w1
    w5 = top_turn_y * w1
    w6 = top_chart_0 * w2 + w3 * top_chart_1 + (top_chart_2 * w4 - top_chart_3 * w5)
    w7 = 2 * w6
    w8 = top_chart_0 * w5 + w3 * top_chart_2 + (w2 * top_chart_3 - top_chart_1 * w4)
    w9 = top_chart_0 * w4 + w3 * top_chart_3 + (top_chart_1 * w5 - w2 * top_chart_2)
    w10 = 2 * w9
    w11 = top_chart_0 * w3 - (w2 * top_chart_1 + top_chart_2 * w5 + w4 * top_chart_3)
    # outputs
    q_d_next = ca.vertcat(
        (w7 * w8 - w10 * w11) * c8,  # top.x
        (1.0 - (w6 * w7 + w9 * w10)) * c8,  # top.y
        (w9 * (2 * w8) + w7 * w11) * c8,  # top.z
        w11,  # top.e0
        w6,  # top.e1
        w8,  # top.e2
        w9,  # top.e3
    )
    inputs, outputs = [q_i, chart, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 7) [mixed]: rates of the dependent coordinates
    99 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    top_foot_y = c[9]
    # intermediate terms (24)
    w0 = 2 * -top_e2
    w1 = 2 * top_e2
    w2 = 2 * top_e1
    w3 = (w1 * top_e3 + w2 * top_e0) * top_foot_y
    w4 = 2 * -top_e3
    w5 = 2 * top_e3
    w6 = (1.0 - (top_e1 * w2 + top_e3 * w5)) * top_foot_y
    w7 = w4 * w6
    w8 = top_e1 * 0.5
    w9 = top_e2 * 0.5
    w10 = top_e3 * 0.5
    w11 = w8 * top_omega_x + w9 * top_omega_y + w10 * top_omega_z
    w12 = top_e0 * 0.5
    w13 = top_omega_x * w12 - top_omega_y * w10 + w9 * top_omega_z
    w14 = 2 * top_e0
    w15 = w3 * w14
    w16 = top_omega_x * w10 + top_omega_y * w12 - w8 * top_omega_z
    w17 = 2 * -top_e1
    w18 = w3 * w17
    w19 = w6 * w14
    w20 = w8 * top_omega_y - top_omega_x * w9 + top_omega_z * w12
    w21 = (top_e2 * w2 - top_e0 * w5) * top_foot_y
    w22 = w0 * w21
    w23 = w14 * w21
    # outputs
    q_d_dot = ca.vertcat(
        (w0 * w3 - w7) * w11 - (w3 * w5 - w0 * w6) * w13 - (w15 - w2 * w6) * w16 - (w18 - w19) * w20,  # top.x
        w11 * (w4 * w21 - w18) - w13 * (w22 - w15) - w16 * (w2 * w21 - w3 * w4) - w20 * (w23 - w1 * w3),  # top.y
        w11 * (w6 * w17 - w22) - w13 * (w19 - w5 * w21) - w16 * (w7 - w23) - w20 * (w1 * w6 - w17 * w21),  # top.z
        -w11,  # top.e0
        w13,  # top.e1
        w16,  # top.e2
        w20,  # top.e3
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 7) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 7) [mixed]: accelerations of the dependent coordinates
    155 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 7)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    top_e0_dot = q_d_dot[3]
    top_e1_dot = q_d_dot[4]
    top_e2_dot = q_d_dot[5]
    top_e3_dot = q_d_dot[6]
    top_turn_x_ddot = q_i_ddot[0]
    top_turn_y_ddot = q_i_ddot[1]
    top_turn_z_ddot = q_i_ddot[2]
    top_foot_y = c[9]
    # intermediate terms (34)
    w0 = 2 * -top_e2
    w1 = 2 * top_e2
    w2 = 2 * top_e1
    w3 = (w1 * top_e3 + w2 * top_e0) * top_foot_y
    w4 = 2 * -top_e3
    w5 = 2 * top_e3
    w6 = (1.0 - (top_e1 * w2 + top_e3 * w5)) * top_foot_y
    w7 = w4 * w6
    w8 = (top_omega_x**2 + top_omega_y**2 + top_omega_z**2) / 4.0
    w9 = top_e1 * 0.5
    w10 = top_e2 * 0.5
    w11 = top_e3 * 0.5
    w12 = top_e0 * w8 + w9 * top_turn_x_ddot + w10 * top_turn_y_ddot + w11 * top_turn_z_ddot
    w13 = 2 * top_e0
    w14 = 2 * -top_e1
    w15 = w0 * top_e0_dot + w5 * top_e1_dot + top_e2_dot * w13 + top_e3_dot * w14
    w16 = top_e0_dot * w14 + top_e1_dot * w13 + w4 * top_e2_dot + w1 * top_e3_dot
    w17 = (top_e2 * w2 - top_e0 * w5) * top_foot_y
    w18 = w6 * w16 - w15 * w17
    w19 = w4 * top_e0_dot + w0 * top_e1_dot + w2 * top_e2_dot + w13 * top_e3_dot
    w20 = w17 * w19 - w3 * w16
    w21 = top_e0 * 0.5
    w22 = top_turn_x_ddot * w21 - top_e1 * w8 - top_turn_y_ddot * w11 + w10 * top_turn_z_ddot
    w23 = w3 * w13
    w24 = top_turn_x_ddot * w11 - top_e2 * w8 + top_turn_y_ddot * w21 - w9 * top_turn_z_ddot
    w25 = (w0 * w3 - w7) * w12 - (w15 * w18 - w19 * w20) - (w3 * w5 - w0 * w6) * w22 - (w23 - w2 * w6) * w24
    w26 = w3 * w14
    w27 = w6 * w13
    w28 = w9 * top_turn_y_ddot - (top_e3 * w8 + top_turn_x_ddot * w10) + top_turn_z_ddot * w21
    w29 = w3 * w15 - w6 * w19
    w30 = w0 * w17
    w31 = w12 * (w4 * w17 - w26) - (w19 * w29 - w16 * w18) - w22 * (w30 - w23) - w24 * (w2 * w17 - w3 * w4)
    w32 = w13 * w17
    w33 = w12 * (w6 * w14 - w30) - (w16 * w20 - w15 * w29) - w22 * (w27 - w5 * w17) - w24 * (w7 - w32) - w28 * (w1 * w6 - w14 * w17)
    # outputs
    q_d_ddot = ca.vertcat(
        w25 - (w26 - w27) * w28,  # top.x
        w31 - w28 * (w32 - w1 * w3),  # top.y
        w33,  # top.z
        -w12,  # top.e0
        w22,  # top.e1
        w24,  # top.e2
        w28,  # top.e3
    )
    inputs, outputs = [q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 4) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 4 x 7) [SI]: constraint Jacobian
    gives C_t (n_c = 4) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 4) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    112 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 28)
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
    top_foot_y = c[9]
    # intermediate terms (22)
    w0 = 2 * top_e1
    w1 = 2 * top_e3
    w2 = (w0 * top_e2 - w1 * top_e0) * top_foot_y
    w3 = (1.0 - (top_e1 * w0 + top_e3 * w1)) * top_foot_y
    w4 = 2 * top_e2
    w5 = (top_e3 * w4 + w0 * top_e0) * top_foot_y
    w6 = 2 * -top_e2
    w7 = 2 * -top_e3
    w8 = w3 * w7
    w9 = 2 * -top_e1
    w10 = w5 * w9
    w11 = w2 * w6
    w12 = 2 * top_e0
    w13 = w5 * w12
    w14 = w3 * w12
    w15 = w2 * w12
    w16 = w6 * top_e0_dot + w1 * top_e1_dot + w12 * top_e2_dot + w9 * top_e3_dot
    w17 = w9 * top_e0_dot + w12 * top_e1_dot + w7 * top_e2_dot + w4 * top_e3_dot
    w18 = w3 * w17 - w2 * w16
    w19 = w7 * top_e0_dot + w6 * top_e1_dot + w0 * top_e2_dot + w12 * top_e3_dot
    w20 = w2 * w19 - w5 * w17
    w21 = w5 * w16 - w3 * w19
    # outputs
    C = ca.vertcat(
        top_x + w2,  # foot.x
        top_y + w3,  # foot.y
        top_z + w5,  # foot.z
        (top_e0**2 + top_e1**2 + top_e2**2 + top_e3**2 - 1.0) / 2.0,  # top.norm
    )
    C_q = ca.vertcat(
        ca.horzcat(1.0, 0.0, 0.0, w5 * w6 - w8, w1 * w5 - w3 * w6, w13 - w0 * w3, w10 - w14),  # foot.x
        ca.horzcat(0.0, 1.0, 0.0, w2 * w7 - w10, w11 - w13, w0 * w2 - w5 * w7, w15 - w4 * w5),  # foot.y
        ca.horzcat(0.0, 0.0, 1.0, w3 * w9 - w11, w14 - w1 * w2, w8 - w15, w3 * w4 - w2 * w9),  # foot.z
        ca.horzcat(0.0, 0.0, 0.0, top_e0, top_e1, top_e2, top_e3),  # top.norm
    )
    C_t = ca.SX(4, 1)
    nu = ca.SX(4, 1)
    gamma = ca.vertcat(
        w19 * w20 - w16 * w18,  # foot.x
        w17 * w18 - w19 * w21,  # foot.y
        w16 * w21 - w17 * w20,  # foot.z
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),  # top.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 7 x 7) [SI]: mass matrix in all coordinates
    gives K (n x n = 7 x 7) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 7) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 7) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 7) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 4 x 7) [SI]: constraint Jacobian
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    202 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 28)
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    top_e0_dot = q_dot[3]
    top_e1_dot = q_dot[4]
    top_e2_dot = q_dot[5]
    top_e3_dot = q_dot[6]
    top_foot_y = c[9]
    c10 = c[10]
    top_mass = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (52)
    w0 = 2 * -top_e1
    w1 = 2 * -top_e2
    w2 = 2 * -top_e3
    w3 = 2 * top_e0
    w4 = w3 * c15
    w5 = 2 * top_e2
    w6 = w0 * w4 + top_e2 * top_e3 * c17
    w7 = 2 * top_e3
    w8 = w3 * c14
    w9 = w0 * c16
    w10 = w1 * w8 + top_e1 * top_e3 * c18
    w11 = w1 * c15
    w12 = 2 * top_e1
    w13 = w12 * c14
    w14 = w3 * c16
    w15 = top_e1 * top_e2 * c19 + w2 * w14
    w16 = top_e3 * top_e0 * c19 + w5 * w9
    w17 = w2 * w13 + top_e2 * top_e0 * c18
    w18 = w7 * w11 + top_e1 * top_e0 * c17
    w19 = w1 * top_e0_dot
    w20 = w3 * top_e2_dot
    w21 = w19 + w2 * top_e1_dot + w20 + w12 * top_e3_dot
    w22 = w2 * top_e0_dot
    w23 = w3 * top_e3_dot
    w24 = w22 + w5 * top_e1_dot + w0 * top_e2_dot + w23
    w25 = w24 * c12
    w26 = w21 * c10
    w27 = w21 * w25 - w24 * w26
    w28 = w0 * top_e0_dot + w3 * top_e1_dot
    w29 = w28 + w7 * top_e2_dot + w1 * top_e3_dot
    w30 = w29 * c13
    w31 = w24 * w30 - w25 * w29
    w32 = w26 * w29 - w21 * w30
    w33 = w0 * w27 + w1 * w31 + w2 * w32
    w34 = w3 * w27 + w2 * w31 + w5 * w32
    w35 = w7 * w27 + w3 * w31 + w0 * w32
    w36 = w1 * w27 + w12 * w31 + w3 * w32
    w37 = (top_e3 * w5 + top_e0 * w12) * top_foot_y
    w38 = (1.0 - (top_e1 * w12 + top_e3 * w7)) * top_foot_y
    w39 = w2 * w38
    w40 = (top_e2 * w12 - top_e0 * w7) * top_foot_y
    w41 = w0 * w37
    w42 = w1 * w40
    w43 = w3 * w37
    w44 = w3 * w38
    w45 = w3 * w40
    w46 = w20 + (w19 + w7 * top_e1_dot) + w0 * top_e3_dot
    w47 = w28 + w2 * top_e2_dot + w5 * top_e3_dot
    w48 = w38 * w47 - w40 * w46
    w49 = w23 + (w22 + w1 * top_e1_dot + w12 * top_e2_dot)
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
    M[3, 3] = w0 * (w0 * c15) + w1 * (w1 * c14) + w2 * (w2 * c16)
    M[3, 4] = w6
    M[3, 5] = w10
    M[3, 6] = w15
    # top.e1
    M[4, 3] = w6
    M[4, 4] = w3 * w4 + w2 * (w2 * c14) + w5 * (w5 * c16)
    M[4, 5] = w16
    M[4, 6] = w17
    # top.e2
    M[5, 3] = w10
    M[5, 4] = w16
    M[5, 5] = w7 * (w7 * c15) + w3 * w8 + w0 * w9
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
    Q_F[2] = c20  # top.z
    Q_star = ca.vertcat(
        0.0,  # top.x
        0.0,  # top.y
        c20,  # top.z
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
    gamma = ca.vertcat(
        w49 * w50 - w46 * w48,  # foot.x
        w47 * w48 - w49 * w51,  # foot.y
        w46 * w51 - w47 * w50,  # foot.z
        -(top_e0_dot**2 + top_e1_dot**2 + top_e2_dot**2 + top_e3_dot**2),  # top.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes q_ddot (n = 7) [mixed]: accelerations of all coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 4) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6) [N, N m]: world force and moment of a joint on its body b, at b
    232 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 28)
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
    top_foot_y = c[9]
    c10 = c[10]
    top_mass = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (48)
    w0 = top_x_ddot * top_mass
    w1 = top_y_ddot * top_mass
    w2 = c20 - top_z_ddot * top_mass
    w3 = 2 * -top_e1
    w4 = 2 * -top_e2
    w5 = 2 * -top_e3
    w6 = 2 * top_e0
    w7 = 2 * top_e1
    w8 = top_e0_dot * w4 + top_e1_dot * w5 + top_e2_dot * w6 + top_e3_dot * w7
    w9 = 2 * top_e2
    w10 = top_e0_dot * w5 + top_e1_dot * w9 + w3 * top_e2_dot + w6 * top_e3_dot
    w11 = w10 * c12
    w12 = w8 * c10
    w13 = w8 * w11 - w10 * w12
    w14 = 2 * top_e3
    w15 = w3 * top_e0_dot + top_e1_dot * w6 + top_e2_dot * w14 + w4 * top_e3_dot
    w16 = w15 * c13
    w17 = w10 * w16 - w11 * w15
    w18 = w12 * w15 - w8 * w16
    w19 = w6 * c15
    w20 = w3 * w19 + top_e2 * top_e3 * c17
    w21 = w6 * c14
    w22 = w3 * c16
    w23 = w4 * w21 + top_e1 * top_e3 * c18
    w24 = (w3 * (w3 * c15) + w4 * (w4 * c14) + w5 * (w5 * c16)) * top_e0_ddot + w20 * top_e1_ddot + w23 * top_e2_ddot
    w25 = w4 * c15
    w26 = w7 * c14
    w27 = w6 * c16
    w28 = top_e1 * top_e2 * c19 + w5 * w27
    w29 = (1.0 - (top_e1 * w7 + top_e3 * w14)) * top_foot_y
    w30 = (top_e2 * w7 - top_e0 * w14) * top_foot_y
    w31 = w4 * w30
    w32 = (top_e3 * w9 + top_e0 * w7) * top_foot_y
    w33 = w5 * w29
    w34 = w3 * w32
    w35 = w3 * w13 + w4 * w17 + w5 * w18 - (w24 + w28 * top_e3_ddot) - (w2 * (w3 * w29 - w31) - (w0 * (w4 * w32 - w33) + w1 * (w5 * w30 - w34)))
    w36 = top_e3 * top_e0 * c19 + w9 * w22
    w37 = top_e0_ddot * w20 + top_e1_ddot * (w6 * w19 + w5 * (w5 * c14) + w9 * (w9 * c16)) + top_e2_ddot * w36
    w38 = w5 * w26 + top_e2 * top_e0 * c18
    w39 = w6 * w29
    w40 = w6 * w32
    w41 = w6 * w13 + w5 * w17 + w9 * w18 - (w37 + top_e3_ddot * w38) - (w2 * (w39 - w14 * w30) - (w0 * (w14 * w32 - w4 * w29) + w1 * (w31 - w40)))
    w42 = w14 * w25 + top_e1 * top_e0 * c17
    w43 = top_e0_ddot * w23 + top_e1_ddot * w36 + top_e2_ddot * (w14 * (w14 * c15) + w6 * w21 + w3 * w22) + top_e3_ddot * w42
    w44 = w6 * w30
    w45 = w13 * w14 + w6 * w17 + w3 * w18 - w43 - (w2 * (w33 - w44) - (w0 * (w40 - w7 * w29) + w1 * (w7 * w30 - w5 * w32)))
    w46 = top_e0_ddot * w28 + top_e1_ddot * w38 + top_e2_ddot * w42 + top_e3_ddot * (w4 * w25 + w7 * w26 + w6 * w27)
    w47 = w4 * w13 + w7 * w17 + w6 * w18 - w46 - (w2 * (w9 * w29 - w3 * w30) - (w0 * (w34 - w39) + w1 * (w44 - w9 * w32)))
    # outputs
    lam = ca.vertcat(
        -w0,  # foot.x
        -w1,  # foot.y
        w2,  # foot.z
        top_e0 * w35 + top_e1 * w41 + top_e2 * w45 + top_e3 * w47,  # top.norm
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
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    112 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 28)
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
    top_mass = c[11]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c21 = c[21]
    # intermediate terms (25)
    w0 = top_x_dot * (top_x_dot * top_mass) + top_y_dot * (top_y_dot * top_mass) + top_z_dot * (top_z_dot * top_mass)
    w1 = 2 * -top_e1
    w2 = 2 * -top_e2
    w3 = 2 * -top_e3
    w4 = 2 * top_e0
    w5 = w4 * c15
    w6 = 2 * top_e2
    w7 = w1 * w5 + top_e2 * top_e3 * c17
    w8 = 2 * top_e3
    w9 = w4 * c14
    w10 = w1 * c16
    w11 = w2 * w9 + top_e1 * top_e3 * c18
    w12 = top_e0_dot * (w1 * (w1 * c15) + w2 * (w2 * c14) + w3 * (w3 * c16)) + w7 * top_e1_dot + w11 * top_e2_dot
    w13 = w2 * c15
    w14 = 2 * top_e1
    w15 = w14 * c14
    w16 = w4 * c16
    w17 = top_e1 * top_e2 * c19 + w3 * w16
    w18 = top_e3 * top_e0 * c19 + w6 * w10
    w19 = w3 * w15 + top_e2 * top_e0 * c18
    w20 = top_e0_dot * w7 + top_e1_dot * (w4 * w5 + w3 * (w3 * c14) + w6 * (w6 * c16)) + top_e2_dot * w18 + top_e3_dot * w19
    w21 = w8 * w13 + top_e1 * top_e0 * c17
    w22 = top_e0_dot * w11 + top_e1_dot * w18 + top_e2_dot * (w8 * (w8 * c15) + w4 * w9 + w1 * w10) + top_e3_dot * w21
    w23 = top_e0_dot * w17 + top_e1_dot * w19 + top_e2_dot * w21 + top_e3_dot * (w2 * w13 + w14 * w15 + w4 * w16)
    w24 = w0 + top_e0_dot * (w12 + w17 * top_e3_dot) + top_e1_dot * w20 + top_e2_dot * w22 + top_e3_dot * w23
    # outputs
    kinetic = ca.vertcat(w24 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(top_z * c21)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    24 operations.
    """
    q = ca.SX.sym("q", 7)
    top_x = q[0]
    top_y = q[1]
    top_z = q[2]
    top_e0 = q[3]
    top_e1 = q[4]
    top_e2 = q[5]
    top_e3 = q[6]
    # intermediate terms (12)
    w0 = 2 * top_e2
    w1 = top_e2 * w0
    w2 = 2 * top_e3
    w3 = top_e3 * w2
    w4 = 2 * top_e1
    w5 = top_e2 * w4
    w6 = w2 * top_e0
    w7 = top_e3 * w4
    w8 = w0 * top_e0
    w9 = top_e1 * w4
    w10 = w0 * top_e3
    w11 = w4 * top_e0
    # outputs
    poses = ca.vertcat(
        top_x, top_y, top_z, 1.0 - (w1 + w3), w5 + w6, w7 - w8, w5 - w6, 1.0 - (w3 + w9), w10 + w11, w7 + w8,
        w10 - w11, 1.0 - (w1 + w9),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    16 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    c0 = c[0]
    c4 = c[4]
    # intermediate terms (1)
    w0 = (top_e1 * top_e0 + top_e2 * top_e3) * c4
    # outputs
    dQ_hat_dq_i = ca.SX(3, 3)
    # top.turn_x
    dQ_hat_dq_i[0, 0] = w0
    dQ_hat_dq_i[0, 1] = (top_e2 * top_e0 - top_e3 * top_e1) * c4
    # top.turn_z
    dQ_hat_dq_i[2, 1] = (top_e2**2 + top_e1**2 - top_e3**2 - top_e0**2) * c0
    dQ_hat_dq_i[2, 2] = w0
    inputs, outputs = [q_d, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_d", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    6 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 28)
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(0.0, top_omega_z * c5, top_omega_y * c5),  # top.turn_x
        ca.horzcat(top_omega_z * c6, 0.0, top_omega_x * c6),  # top.turn_y
        ca.horzcat(top_omega_y * c7, top_omega_x * c7, 0.0),  # top.turn_z
    )
    inputs, outputs = [q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 3 x 3) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    22 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (1)
    w0 = (top_e1 * top_e0 + top_e2 * top_e3) * c4
    # outputs
    J_q = ca.SX(3, 3)
    # top.turn_x
    J_q[0, 0] = w0
    J_q[0, 1] = (top_e2 * top_e0 - top_e3 * top_e1) * c4
    # top.turn_z
    J_q[2, 1] = (top_e2**2 + top_e1**2 - top_e3**2 - top_e0**2) * c0
    J_q[2, 2] = w0
    J_v = ca.vertcat(
        ca.horzcat(0.0, top_omega_z * c5, top_omega_y * c5),  # top.turn_x
        ca.horzcat(top_omega_z * c6, 0.0, top_omega_x * c6),  # top.turn_y
        ca.horzcat(top_omega_y * c7, top_omega_x * c7, 0.0),  # top.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_d", "q_i_dot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_d (n_d = 7) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 28) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    18 operations.
    """
    q_d = ca.SX.sym("q_d", 7)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 28)
    top_e0 = q_d[3]
    top_e1 = q_d[4]
    top_e2 = q_d[5]
    top_e3 = q_d[6]
    top_omega_x = q_i_dot[0]
    top_omega_y = q_i_dot[1]
    top_omega_z = q_i_dot[2]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    # outputs
    q_i_ddot = ca.vertcat(
        c22 - top_e1**2 * c23 - top_e2**2 * c23 - top_omega_y * top_omega_z * c24,  # top.turn_x
        top_omega_z * top_omega_x * c25,  # top.turn_y
        (top_e2 * top_e0 - top_e1 * top_e3) * c26 - top_omega_y * top_omega_x * c27,  # top.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_d", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 3) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 3) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
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
