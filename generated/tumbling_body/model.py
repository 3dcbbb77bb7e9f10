"""Free body turning over: equations of motion, emitted by symgen from the scene `tumbling_body`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 body.x [m], 1 body.y [m], 2 body.z [m], 3 body.turn_x [rad], 4 body.turn_y [rad], 5 body.turn_z [rad]

q_d, the dependent coordinates by index:
    0 body.e0 [1], 1 body.e1 [1], 2 body.e2 [1], 3 body.e3 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    25 operations.
    """
    p = ca.SX.sym("p", 6)
    body_mass = p[0]
    body_inertia_xx = p[1]
    body_inertia_yy = p[2]
    body_inertia_zz = p[3]
    # intermediate terms (13)
    w0 = (body_inertia_xx + body_inertia_yy + body_inertia_zz) / 2.0
    w1 = w0 - body_inertia_yy
    w2 = w0 - body_inertia_zz
    w3 = w1 + w2
    w4 = w0 - body_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = w1 - w2
    w8 = w2 - w4
    w9 = w4 - w1
    w10 = 4.0 * w5
    w11 = 4.0 * w6
    w12 = 4.0 * w3
    # outputs
    c = ca.vertcat(
        body_mass,  # body_mass
        w3,  # c1
        w5,  # c2
        w6,  # c3
        -w7,  # c4
        -w8,  # c5
        -w9,  # c6
        w1,  # c7
        w2,  # c8
        w4,  # c9
        w10 - w11,  # c10
        w11 - w12,  # c11
        w12 - w10,  # c12
        body_inertia_yy - body_inertia_zz,  # c13
        -(body_inertia_xx - body_inertia_zz),  # c14
        body_inertia_xx - body_inertia_yy,  # c15
        w7,  # c16
        w8,  # c17
        w9,  # c18
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 6 x 6) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 6) [N, N m]: condensed force S^T (Q* - M s)
    6 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    body_mass = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    # outputs
    M_hat = ca.SX(6, 6)
    # body.x
    M_hat[0, 0] = body_mass
    # body.y
    M_hat[1, 1] = body_mass
    # body.z
    M_hat[2, 2] = body_mass
    # body.turn_x
    M_hat[3, 3] = c1
    # body.turn_y
    M_hat[4, 4] = c2
    # body.turn_z
    M_hat[5, 5] = c3
    Q_hat = ca.SX(6, 1)
    Q_hat[3] = body_omega_y * body_omega_z * c4  # body.turn_x
    Q_hat[4] = body_omega_z * body_omega_x * c5  # body.turn_y
    Q_hat[5] = body_omega_y * body_omega_x * c6  # body.turn_z
    inputs, outputs = [q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 4) [1]: unit quaternions from which the turns in q_i are rotation vectors
    gives q_d_next (n_d = 4) [mixed]: dependent coordinates after one Newton step
    43 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    chart = ca.SX.sym("chart", 4)
    body_turn_x = q_i[3]
    body_turn_y = q_i[4]
    body_turn_z = q_i[5]
    body_chart_0 = chart[0]
    body_chart_1 = chart[1]
    body_chart_2 = chart[2]
    body_chart_3 = chart[3]
    # intermediate terms (6)
    w0 = ca.sqrt((body_turn_x**2 + body_turn_y**2 + body_turn_z**2) / 4.0 + 1e-300)
    w1 = ca.cos(w0)
    w2 = ca.sin(w0) / w0 / 2.0
    w3 = body_turn_x * w2
    w4 = body_turn_y * w2
    w5 = body_turn_z * w2
    # outputs
    q_d_next = ca.vertcat(
        body_chart_0 * w1 - (body_chart_1 * w3 + body_chart_2 * w4 + body_chart_3 * w5),  # body.e0
        body_chart_0 * w3 + w1 * body_chart_1 + (body_chart_2 * w5 - w4 * body_chart_3),  # body.e1
        body_chart_0 * w4 + w1 * body_chart_2 + (w3 * body_chart_3 - body_chart_1 * w5),  # body.e2
        body_chart_0 * w5 + w1 * body_chart_3 + (body_chart_1 * w4 - w3 * body_chart_2),  # body.e3
    )
    inputs, outputs = [q_i, chart], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    gives q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    25 operations.
    """
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    body_e0 = q_d[0]
    body_e1 = q_d[1]
    body_e2 = q_d[2]
    body_e3 = q_d[3]
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    # intermediate terms (4)
    w0 = body_e1 * 0.5
    w1 = body_e2 * 0.5
    w2 = body_e3 * 0.5
    w3 = body_e0 * 0.5
    # outputs
    q_d_dot = ca.vertcat(
        -(w0 * body_omega_x + w1 * body_omega_y + w2 * body_omega_z),  # body.e0
        body_omega_x * w3 - body_omega_y * w2 + w1 * body_omega_z,  # body.e1
        body_omega_x * w2 + body_omega_y * w3 - w0 * body_omega_z,  # body.e2
        w0 * body_omega_y - body_omega_x * w1 + body_omega_z * w3,  # body.e3
    )
    inputs, outputs = [q_d, q_i_dot], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_d", "q_i_dot"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_d (n_d = 4) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    gives q_d_ddot (n_d = 4) [mixed]: accelerations of the dependent coordinates
    39 operations.
    """
    q_d = ca.SX.sym("q_d", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    body_e0 = q_d[0]
    body_e1 = q_d[1]
    body_e2 = q_d[2]
    body_e3 = q_d[3]
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    body_turn_x_ddot = q_i_ddot[3]
    body_turn_y_ddot = q_i_ddot[4]
    body_turn_z_ddot = q_i_ddot[5]
    # intermediate terms (5)
    w0 = (body_omega_x**2 + body_omega_y**2 + body_omega_z**2) / 4.0
    w1 = body_e1 * 0.5
    w2 = body_e2 * 0.5
    w3 = body_e3 * 0.5
    w4 = body_e0 * 0.5
    # outputs
    q_d_ddot = ca.vertcat(
        -(w0 * body_e0 + w1 * body_turn_x_ddot + w2 * body_turn_y_ddot + w3 * body_turn_z_ddot),  # body.e0
        body_turn_x_ddot * w4 - w0 * body_e1 - body_turn_y_ddot * w3 + w2 * body_turn_z_ddot,  # body.e1
        body_turn_x_ddot * w3 - w0 * body_e2 + body_turn_y_ddot * w4 - w1 * body_turn_z_ddot,  # body.e2
        w1 * body_turn_y_ddot - (w0 * body_e3 + body_turn_x_ddot * w2) + body_turn_z_ddot * w4,  # body.e3
    )
    inputs, outputs = [q_d, q_i_dot, q_i_ddot], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_d", "q_i_dot", "q_i_ddot"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    gives C (n_c = 1) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 1 x 7) [SI]: constraint Jacobian
    gives C_t (n_c = 1) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 1) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 1) [m/s^2, rad/s^2]: right-hand side at acceleration level
    17 operations.
    """
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
    # outputs
    C = ca.vertcat((body_e0**2 + body_e1**2 + body_e2**2 + body_e3**2 - 1.0) / 2.0)
    C_q = ca.SX(1, 7)
    # body.norm
    C_q[0, 3] = body_e0
    C_q[0, 4] = body_e1
    C_q[0, 5] = body_e2
    C_q[0, 6] = body_e3
    C_t = ca.SX(1, 1)
    nu = ca.SX(1, 1)
    gamma = ca.vertcat(-(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2))
    inputs, outputs = [q, q_dot], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 7 x 7) [SI]: mass matrix in all coordinates
    gives K (n x n = 7 x 7) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 7) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 7) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 7) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 1 x 7) [SI]: constraint Jacobian
    gives gamma (n_c = 1) [m/s^2, rad/s^2]: right-hand side at acceleration level
    127 operations.
    """
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
    body_mass = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (32)
    w0 = 2 * -body_e1
    w1 = 2 * -body_e2
    w2 = 2 * -body_e3
    w3 = 2 * body_e0
    w4 = w3 * c1
    w5 = 2 * body_e2
    w6 = w0 * w4 + body_e2 * body_e3 * c10
    w7 = 2 * body_e3
    w8 = w3 * c2
    w9 = w0 * c3
    w10 = w1 * w8 + body_e1 * body_e3 * c11
    w11 = w1 * c1
    w12 = 2 * body_e1
    w13 = w12 * c2
    w14 = w3 * c3
    w15 = body_e1 * body_e2 * c12 + w2 * w14
    w16 = body_e3 * body_e0 * c12 + w5 * w9
    w17 = w2 * w13 + body_e2 * body_e0 * c11
    w18 = w7 * w11 + body_e1 * body_e0 * c10
    w19 = w1 * body_e0_dot + w2 * body_e1_dot + w3 * body_e2_dot + w12 * body_e3_dot
    w20 = w2 * body_e0_dot + w5 * body_e1_dot + w0 * body_e2_dot + w3 * body_e3_dot
    w21 = w20 * c8
    w22 = w19 * c7
    w23 = w19 * w21 - w20 * w22
    w24 = w0 * body_e0_dot + w3 * body_e1_dot + w7 * body_e2_dot + w1 * body_e3_dot
    w25 = w24 * c9
    w26 = w20 * w25 - w21 * w24
    w27 = w22 * w24 - w19 * w25
    w28 = w0 * w23 + w1 * w26 + w2 * w27
    w29 = w3 * w23 + w2 * w26 + w5 * w27
    w30 = w7 * w23 + w3 * w26 + w0 * w27
    w31 = w1 * w23 + w12 * w26 + w3 * w27
    # outputs
    M = ca.SX(7, 7)
    # body.x
    M[0, 0] = body_mass
    # body.y
    M[1, 1] = body_mass
    # body.z
    M[2, 2] = body_mass
    # body.e0
    M[3, 3] = w0 * (w0 * c1) + w1 * (w1 * c2) + w2 * (w2 * c3)
    M[3, 4] = w6
    M[3, 5] = w10
    M[3, 6] = w15
    # body.e1
    M[4, 3] = w6
    M[4, 4] = w3 * w4 + w2 * (w2 * c2) + w5 * (w5 * c3)
    M[4, 5] = w16
    M[4, 6] = w17
    # body.e2
    M[5, 3] = w10
    M[5, 4] = w16
    M[5, 5] = w7 * (w7 * c1) + w3 * w8 + w0 * w9
    M[5, 6] = w18
    # body.e3
    M[6, 3] = w15
    M[6, 4] = w17
    M[6, 5] = w18
    M[6, 6] = w1 * w11 + w12 * w13 + w3 * w14
    K = ca.SX(7, 7)
    Q_v = ca.SX(7, 1)
    Q_v[3] = w28  # body.e0
    Q_v[4] = w29  # body.e1
    Q_v[5] = w30  # body.e2
    Q_v[6] = w31  # body.e3
    Q_F = ca.SX(7, 1)
    Q_star = ca.SX(7, 1)
    Q_star[3] = w28  # body.e0
    Q_star[4] = w29  # body.e1
    Q_star[5] = w30  # body.e2
    Q_star[6] = w31  # body.e3
    C_q = ca.SX(1, 7)
    # body.norm
    C_q[0, 3] = body_e0
    C_q[0, 4] = body_e1
    C_q[0, 5] = body_e2
    C_q[0, 6] = body_e3
    gamma = ca.vertcat(-(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2))
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes q_ddot (n = 7) [mixed]: accelerations of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 1) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 0) [N, N m]: world force and moment of a joint on its body b, at b
    158 operations.
    """
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
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (34)
    w0 = 2 * -body_e1
    w1 = 2 * -body_e2
    w2 = 2 * -body_e3
    w3 = 2 * body_e0
    w4 = 2 * body_e1
    w5 = body_e0_dot * w1 + body_e1_dot * w2 + body_e2_dot * w3 + body_e3_dot * w4
    w6 = 2 * body_e2
    w7 = body_e0_dot * w2 + body_e1_dot * w6 + w0 * body_e2_dot + w3 * body_e3_dot
    w8 = w7 * c8
    w9 = w5 * c7
    w10 = w5 * w8 - w7 * w9
    w11 = 2 * body_e3
    w12 = w0 * body_e0_dot + body_e1_dot * w3 + body_e2_dot * w11 + w1 * body_e3_dot
    w13 = w12 * c9
    w14 = w7 * w13 - w8 * w12
    w15 = w9 * w12 - w5 * w13
    w16 = w3 * c1
    w17 = w0 * w16 + body_e2 * body_e3 * c10
    w18 = w3 * c2
    w19 = w0 * c3
    w20 = w1 * w18 + body_e1 * body_e3 * c11
    w21 = (w0 * (w0 * c1) + w1 * (w1 * c2) + w2 * (w2 * c3)) * body_e0_ddot + w17 * body_e1_ddot + w20 * body_e2_ddot
    w22 = w1 * c1
    w23 = w4 * c2
    w24 = w3 * c3
    w25 = body_e1 * body_e2 * c12 + w2 * w24
    w26 = body_e3 * body_e0 * c12 + w6 * w19
    w27 = body_e0_ddot * w17 + body_e1_ddot * (w3 * w16 + w2 * (w2 * c2) + w6 * (w6 * c3)) + body_e2_ddot * w26
    w28 = w2 * w23 + body_e2 * body_e0 * c11
    w29 = body_e0 * (w0 * w10 + w1 * w14 + w2 * w15 - (w21 + w25 * body_e3_ddot)) + body_e1 * (w3 * w10 + w2 * w14 + w6 * w15 - (w27 + body_e3_ddot * w28))
    w30 = body_e0_ddot * w20 + body_e1_ddot * w26 + body_e2_ddot * (w11 * (w11 * c1) + w3 * w18 + w0 * w19)
    w31 = w11 * w22 + body_e1 * body_e0 * c10
    w32 = body_e0_ddot * w25 + body_e1_ddot * w28 + body_e2_ddot * w31 + body_e3_ddot * (w1 * w22 + w4 * w23 + w3 * w24)
    w33 = w29 + body_e2 * (w10 * w11 + w3 * w14 + w0 * w15 - (w30 + body_e3_ddot * w31)) + body_e3 * (w1 * w10 + w4 * w14 + w3 * w15 - w32)
    # outputs
    lam = ca.vertcat(w33)
    joint_forces = ca.SX(6, 0)
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    111 operations.
    """
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
    body_mass = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (25)
    w0 = body_x_dot * (body_x_dot * body_mass) + body_y_dot * (body_y_dot * body_mass) + body_z_dot * (body_z_dot * body_mass)
    w1 = 2 * -body_e1
    w2 = 2 * -body_e2
    w3 = 2 * -body_e3
    w4 = 2 * body_e0
    w5 = w4 * c1
    w6 = 2 * body_e2
    w7 = w1 * w5 + body_e2 * body_e3 * c10
    w8 = 2 * body_e3
    w9 = w4 * c2
    w10 = w1 * c3
    w11 = w2 * w9 + body_e1 * body_e3 * c11
    w12 = body_e0_dot * (w1 * (w1 * c1) + w2 * (w2 * c2) + w3 * (w3 * c3)) + w7 * body_e1_dot + w11 * body_e2_dot
    w13 = w2 * c1
    w14 = 2 * body_e1
    w15 = w14 * c2
    w16 = w4 * c3
    w17 = body_e1 * body_e2 * c12 + w3 * w16
    w18 = body_e3 * body_e0 * c12 + w6 * w10
    w19 = w3 * w15 + body_e2 * body_e0 * c11
    w20 = body_e0_dot * w7 + body_e1_dot * (w4 * w5 + w3 * (w3 * c2) + w6 * (w6 * c3)) + body_e2_dot * w18 + body_e3_dot * w19
    w21 = w8 * w13 + body_e1 * body_e0 * c10
    w22 = body_e0_dot * w11 + body_e1_dot * w18 + body_e2_dot * (w8 * (w8 * c1) + w4 * w9 + w1 * w10) + body_e3_dot * w21
    w23 = body_e0_dot * w17 + body_e1_dot * w19 + body_e2_dot * w21 + body_e3_dot * (w2 * w13 + w14 * w15 + w4 * w16)
    w24 = w0 + body_e0_dot * (w12 + w17 * body_e3_dot) + body_e1_dot * w20 + body_e2_dot * w22 + body_e3_dot * w23
    # outputs
    kinetic = ca.vertcat(w24 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.SX(1, 1)
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
    body_x = q[0]
    body_y = q[1]
    body_z = q[2]
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    # intermediate terms (12)
    w0 = 2 * body_e2
    w1 = body_e2 * w0
    w2 = 2 * body_e3
    w3 = body_e3 * w2
    w4 = 2 * body_e1
    w5 = body_e2 * w4
    w6 = w2 * body_e0
    w7 = body_e3 * w4
    w8 = w0 * body_e0
    w9 = body_e1 * w4
    w10 = w0 * body_e3
    w11 = w4 * body_e0
    # outputs
    poses = ca.vertcat(
        body_x, body_y, body_z, 1.0 - (w1 + w3), w5 + w6, w7 - w8, w5 - w6, 1.0 - (w3 + w9), w10 + w11, w7 + w8,
        w10 - w11, 1.0 - (w1 + w9),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    gives dQ_hat_dq_i (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i, through q_d
    0 operations.
    """
    # outputs
    dQ_hat_dq_i = ca.SX(6, 6)
    inputs, outputs = [], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, [], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    6 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    # outputs
    dQ_hat_dq_i_dot = ca.SX(6, 6)
    # body.turn_x
    dQ_hat_dq_i_dot[3, 4] = body_omega_z * c13
    dQ_hat_dq_i_dot[3, 5] = body_omega_y * c13
    # body.turn_y
    dQ_hat_dq_i_dot[4, 3] = body_omega_z * c14
    dQ_hat_dq_i_dot[4, 5] = body_omega_x * c14
    # body.turn_z
    dQ_hat_dq_i_dot[5, 3] = body_omega_y * c15
    dQ_hat_dq_i_dot[5, 4] = body_omega_x * c15
    inputs, outputs = [q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 6 x 6) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    6 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    # outputs
    J_q = ca.SX(6, 6)
    J_v = ca.SX(6, 6)
    # body.turn_x
    J_v[3, 4] = body_omega_z * c13
    J_v[3, 5] = body_omega_y * c13
    # body.turn_y
    J_v[4, 3] = body_omega_z * c14
    J_v[4, 5] = body_omega_x * c14
    # body.turn_z
    J_v[5, 3] = body_omega_y * c15
    J_v[5, 4] = body_omega_x * c15
    inputs, outputs = [q_i_dot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i_dot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    12 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_omega_x = q_i_dot[3]
    body_omega_y = q_i_dot[4]
    body_omega_z = q_i_dot[5]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    # outputs
    q_i_ddot = ca.SX(6, 1)
    q_i_ddot[3] = -(body_omega_y * body_omega_z * c16 / c1)  # body.turn_x
    q_i_ddot[4] = -(body_omega_z * body_omega_x * c17 / c2)  # body.turn_y
    q_i_ddot[5] = -(body_omega_y * body_omega_x * c18 / c3)  # body.turn_z
    inputs, outputs = [q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 3) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 3) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 6)
    body_tip_x_x = p[4]
    body_tip_y_y = p[5]
    # outputs
    positions = ca.SX(3, 3)
    positions[0, 1] = body_tip_x_x
    positions[1, 2] = body_tip_y_y
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
