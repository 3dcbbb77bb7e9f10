"""Flexible slider-crank, running freely: equations of motion, emitted by symgen from the scene `flexible_slider_crank_free`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 crank.theta [rad], 1 rod.q1 [m], 2 rod.q2 [m], 3 rod.q3 [m], 4 rod.q4 [m]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 rod.x [m], 3 rod.y [m], 4 rod.theta [rad], 5 slider.x [m],
    6 slider.y [m], 7 slider.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 67) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    15 operations.
    """
    p = ca.SX.sym("p", 67)
    crank_mass = p[0]
    crank_inertia = p[1]
    crank_center_of_mass_x = p[2]
    rod_mass = p[3]
    rod_first_moment_x = p[4]
    rod_inertia = p[5]
    rod_phi_integral_0_2 = p[6]
    rod_phi_integral_0_3 = p[7]
    rod_phi_integral_1_0 = p[8]
    rod_rho_dot_phi_2_0 = p[9]
    rod_rho_dot_phi_3_0 = p[10]
    rod_rho_cross_phi_0_0 = p[11]
    rod_rho_cross_phi_1_0 = p[12]
    rod_M_ff_0_0 = p[13]
    rod_M_ff_1_1 = p[14]
    rod_M_ff_2_2 = p[15]
    rod_M_ff_2_3 = p[16]
    rod_M_ff_3_3 = p[17]
    rod_phi_cross_phi_0_2 = p[18]
    rod_phi_cross_phi_0_3 = p[19]
    rod_phi_cross_phi_1_3 = p[20]
    rod_phi_cross_phi_2_0 = p[21]
    rod_phi_cross_phi_3_0 = p[22]
    rod_phi_cross_phi_3_1 = p[23]
    rod_K_ff_0_0 = p[24]
    rod_K_ff_1_1 = p[25]
    rod_K_ff_2_2 = p[26]
    rod_K_ff_2_3 = p[27]
    rod_K_ff_3_3 = p[28]
    slider_mass = p[29]
    slider_inertia = p[30]
    crank_tip_x = p[31]
    rod_end_x = p[32]
    rod_end_shape_0_3 = p[33]
    # outputs
    c = ca.vertcat(
        crank_inertia + crank_mass * crank_center_of_mass_x**2,  # c0
        crank_tip_x,  # crank_tip_x
        rod_mass,  # rod_mass
        slider_mass,  # slider_mass
        rod_mass + slider_mass,  # c4
        rod_end_x,  # rod_end_x
        rod_end_shape_0_3,  # rod_end_shape_0_3
        rod_first_moment_x,  # rod_first_moment_x
        rod_phi_integral_0_2,  # rod_phi_integral_0_2
        rod_phi_integral_0_3,  # rod_phi_integral_0_3
        rod_phi_integral_1_0,  # rod_phi_integral_1_0
        rod_inertia,  # rod_inertia
        rod_M_ff_0_0,  # rod_M_ff_0_0
        rod_M_ff_1_1,  # rod_M_ff_1_1
        rod_rho_dot_phi_2_0,  # rod_rho_dot_phi_2_0
        rod_M_ff_2_2,  # rod_M_ff_2_2
        rod_M_ff_2_3,  # rod_M_ff_2_3
        rod_rho_dot_phi_3_0,  # rod_rho_dot_phi_3_0
        rod_M_ff_3_3,  # rod_M_ff_3_3
        rod_rho_cross_phi_0_0,  # rod_rho_cross_phi_0_0
        rod_phi_cross_phi_0_2,  # rod_phi_cross_phi_0_2
        rod_phi_cross_phi_0_3,  # rod_phi_cross_phi_0_3
        rod_rho_cross_phi_1_0,  # rod_rho_cross_phi_1_0
        rod_phi_cross_phi_1_3,  # rod_phi_cross_phi_1_3
        rod_phi_cross_phi_2_0,  # rod_phi_cross_phi_2_0
        rod_phi_cross_phi_3_0,  # rod_phi_cross_phi_3_0
        rod_phi_cross_phi_3_1,  # rod_phi_cross_phi_3_1
        rod_K_ff_0_0,  # rod_K_ff_0_0
        rod_K_ff_1_1,  # rod_K_ff_1_1
        rod_K_ff_2_2,  # rod_K_ff_2_2
        rod_K_ff_2_3,  # rod_K_ff_2_3
        rod_K_ff_3_3,  # rod_K_ff_3_3
        -rod_end_shape_0_3,  # c32
        crank_mass,  # crank_mass
        crank_mass * crank_center_of_mass_x,  # c34
        -rod_phi_integral_1_0,  # c35
        -rod_phi_cross_phi_2_0,  # c36
        slider_inertia,  # slider_inertia
        -rod_phi_cross_phi_3_0,  # c38
        rod_rho_dot_phi_2_0 + rod_rho_dot_phi_2_0,  # c39
        rod_rho_dot_phi_3_0 + rod_rho_dot_phi_3_0,  # c40
        2 * rod_phi_cross_phi_1_3,  # c41
        2 * rod_phi_cross_phi_2_0,  # c42
        -rod_phi_cross_phi_0_2,  # c43
        -rod_phi_cross_phi_3_1,  # c44
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 5 x 5) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 5) [N, N m]: condensed force S^T (Q* - M s)
    240 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    # intermediate terms (59)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = w0 / w4
    w6 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w7 = ca.sin(rod_theta)
    w8 = rod_q1 * rod_phi_integral_1_0
    w9 = w2 * w6 - w7 * w8
    w10 = w6 * w7 + w2 * w8
    w11 = w3 * w7
    w12 = w11 * slider_mass
    w13 = w0 * w9 + w1 * (w10 + w12)
    w14 = rod_q1 * rod_M_ff_0_0
    w15 = rod_q2 * rod_M_ff_1_1
    w16 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w17 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w18 = rod_q1 * w14 + rod_q2 * w15 + rod_q3 * (rod_rho_dot_phi_2_0 + w16) + rod_q4 * (rod_rho_dot_phi_3_0 + w17)
    w19 = rod_inertia + w18
    w20 = w19 + w11 * w12
    w21 = w2 * rod_phi_integral_1_0
    w22 = w7 * rod_phi_integral_1_0
    w23 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w24 = w0 * w21 + w1 * w22 - w5 * w23
    w25 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w26 = -(w5 * w25)
    w27 = w7 * rod_phi_integral_0_2
    w28 = w2 * rod_phi_integral_0_2
    w29 = rod_q1 * rod_phi_cross_phi_2_0
    w30 = w0 * w27 - w1 * w28 + w5 * w29
    w31 = w7 * rod_phi_integral_0_3
    w32 = w2 * rod_phi_integral_0_3
    w33 = w2 * rod_end_shape_0_3
    w34 = w33 * slider_mass
    w35 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w36 = w35 + w11 * w34
    w37 = w7 * rod_end_shape_0_3 / w4
    w38 = w36 + w20 * w37
    w39 = w0 * w31 - w1 * (w32 + w34) + (w5 * w38 - w13 * w37)
    w40 = -(w23 * w37)
    w41 = -(w25 * w37)
    w42 = rod_M_ff_2_3 + w29 * w37
    w43 = rod_theta_dot**2
    w44 = 2 * rod_theta_dot
    w45 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w46 = rod_q1_dot * rod_phi_integral_1_0
    w47 = crank_theta_dot**2
    w48 = w1 * w47
    w49 = rod_q4_dot * rod_end_shape_0_3
    w50 = (w44 * (w2 * w49) - w11 * w43 - w48) / w4
    w51 = w0 * w47
    w52 = (w11 * w50 - (w51 + (w4 * w43 + w44 * (w7 * w49)))) * slider_mass
    w53 = w0 * (w10 * w43 - w44 * (w2 * w45 - w7 * w46) + (w48 * rod_mass + w9 * w50)) - w1 * (w9 * w43 + w44 * (w7 * w45 + w2 * w46) - (w10 * w50 - w51 * rod_mass) - w52)
    w54 = rod_theta_dot * -2.0 * (w14 * rod_q1_dot + w15 * rod_q2_dot + w16 * rod_q3_dot + w17 * rod_q4_dot)
    w55 = w54 - (w10 * w51 - w9 * w48 - w19 * w50) + w11 * w52
    w56 = w14 * w43 + w44 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3) - rod_q1 * rod_K_ff_0_0
    w57 = w16 * w43 + w44 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w58 = w17 * w43 + w44 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(  # crank.theta
            c0 + w0 * (w0 * rod_mass) + w1 * (w1 * c4) - (w5 * (w13 - w5 * w20) + w5 * w13), w24, w26, w30, w39,
        ),
        ca.horzcat(w24, rod_M_ff_0_0, 0.0, 0.0, w40),  # rod.q1
        ca.horzcat(w26, 0.0, rod_M_ff_1_1, 0.0, w41),  # rod.q2
        ca.horzcat(w30, 0.0, 0.0, rod_M_ff_2_2, w42),  # rod.q3
        ca.horzcat(w39, w40, w41, w42, rod_M_ff_3_3 + w33 * w34 + (w37 * w38 + w36 * w37)),  # rod.q4
    )
    Q_hat = ca.vertcat(
        w53 - w5 * w55,  # crank.theta
        w56 - (w22 * w51 - w21 * w48 - w23 * w50),  # rod.q1
        w15 * w43 + w44 * (rod_q4_dot * rod_phi_cross_phi_1_3) - rod_q2 * rod_K_ff_1_1 + w25 * w50,  # rod.q2
        w57 - (w29 * w50 - (w28 * w51 + w27 * w48)),  # rod.q3
        w58 - (w35 * w50 - (w32 * w51 + w31 * w48)) - w33 * w52 - w37 * w55,  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    18 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_tip_x = c[1]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w3 = w1 + ca.sin(rod_theta) * w2
    w4 = w2 * ca.cos(rod_theta)
    w5 = rod_theta - w3 / w4
    # outputs
    q_d_next = ca.SX(8, 1)
    q_d_next[2] = w0  # rod.x
    q_d_next[3] = w1  # rod.y
    q_d_next[4] = w5  # rod.theta
    q_d_next[5] = w0 + w2 * ca.cos(w5)  # slider.x
    C_loop = ca.vertcat(-w3)
    det_loop = ca.vertcat(-w4)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    25 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    crank_tip_x = c[1]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    # intermediate terms (7)
    w0 = ca.sin(crank_theta) * crank_tip_x * crank_theta_dot
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = crank_theta_dot * (w1 / w4) + w5 * rod_end_shape_0_3 / w4 * rod_q4_dot
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[2] = -w0  # rod.x
    q_d_dot[3] = crank_theta_dot * w1  # rod.y
    q_d_dot[4] = -w6  # rod.theta
    q_d_dot[5] = w6 * (w3 * w5) - w0 + rod_q4_dot * (w2 * rod_end_shape_0_3)  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 5) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    45 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q4_ddot = q_i_ddot[4]
    crank_tip_x = c[1]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    # intermediate terms (14)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w0 * w2
    w5 = 2 * rod_theta_dot
    w6 = ca.cos(rod_theta)
    w7 = rod_q4_dot * rod_end_shape_0_3
    w8 = rod_theta_dot**2
    w9 = ca.sin(rod_theta)
    w10 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w11 = w9 * w10
    w12 = w6 * w10
    w13 = (w5 * (w6 * w7) - w8 * w11 - w4) / w12 + crank_theta_ddot * (w1 / w12) + w9 * rod_end_shape_0_3 / w12 * rod_q4_ddot
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[2] = -w3  # rod.x
    q_d_ddot[3] = w1 * crank_theta_ddot - w4  # rod.y
    q_d_ddot[4] = -w13  # rod.theta
    q_d_ddot[5] = w11 * w13 - (w3 + (w8 * w12 + w5 * (w7 * w9))) + rod_q4_ddot * (w6 * rod_end_shape_0_3)  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    39 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 45)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q4 = q[9]
    slider_x = q[10]
    slider_y = q[11]
    slider_theta = q[12]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q4_dot = q_dot[9]
    crank_tip_x = c[1]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    c32 = c[32]
    # intermediate terms (11)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w3 * w5
    w7 = crank_theta_dot**2
    w8 = rod_theta_dot**2
    w9 = 2 * rod_theta_dot
    w10 = rod_q4_dot * rod_end_shape_0_3
    # outputs
    C = ca.vertcat(
        crank_x,  # A.x
        crank_y,  # A.y
        rod_x - (crank_x + w0),  # B.x
        rod_y - (crank_y + w1),  # B.y
        slider_y,  # slide.normal
        slider_theta,  # slide.angle
        slider_x - (rod_x + w4),  # C.x
        slider_y - (rod_y + w6),  # C.y
    )
    C_q = ca.SX(8, 13)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    # slide.normal
    C_q[4, 11] = 1.0
    # slide.angle
    C_q[5, 12] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w6
    C_q[6, 9] = w2 * c32
    C_q[6, 10] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w4
    C_q[7, 9] = w5 * c32
    C_q[7, 11] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[2] = -(w0 * w7)  # B.x
    gamma[3] = -(w1 * w7)  # B.y
    gamma[6] = -(w4 * w8 + w9 * (w5 * w10))  # C.x
    gamma[7] = w9 * (w2 * w10) - w6 * w8  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 13 x 13) [SI]: mass matrix in all coordinates
    gives K (n x n = 13 x 13) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 13) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 13) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 13) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    141 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 45)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    c32 = c[32]
    crank_mass = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    slider_inertia = c[37]
    c38 = c[38]
    # intermediate terms (47)
    w0 = ca.sin(crank_theta)
    w1 = w0 * c34
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c34
    w5 = ca.sin(rod_theta)
    w6 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * rod_phi_integral_1_0
    w9 = w5 * w6 + w7 * w8
    w10 = -w9
    w11 = w5 * c35
    w12 = w7 * rod_phi_integral_0_2
    w13 = w7 * rod_phi_integral_0_3
    w14 = w6 * w7 - w5 * w8
    w15 = w7 * rod_phi_integral_1_0
    w16 = w5 * rod_phi_integral_0_2
    w17 = w5 * rod_phi_integral_0_3
    w18 = rod_q1 * rod_M_ff_0_0
    w19 = rod_q2 * rod_M_ff_1_1
    w20 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w21 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w22 = rod_q1 * w18 + rod_q2 * w19 + rod_q3 * (rod_rho_dot_phi_2_0 + w20) + rod_q4 * (rod_rho_dot_phi_3_0 + w21)
    w23 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w24 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w25 = rod_q1 * c36
    w26 = crank_theta_dot**2
    w27 = w4 * w26
    w28 = w1 * w26
    w29 = rod_theta_dot**2
    w30 = 2 * rod_theta_dot
    w31 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w32 = rod_q1_dot * rod_phi_integral_1_0
    w33 = w14 * w29 + w30 * (w5 * w31 + w7 * w32)
    w34 = w9 * w29 - w30 * (w7 * w31 - w5 * w32)
    w35 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot + w20 * rod_q3_dot + w21 * rod_q4_dot)
    w36 = w18 * w29 + w30 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)
    w37 = w19 * w29 + w30 * (rod_q4_dot * rod_phi_cross_phi_1_3)
    w38 = w20 * w29 + w30 * (rod_q1_dot * rod_phi_cross_phi_2_0)
    w39 = w21 * w29 + w30 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1)
    w40 = w0 * crank_tip_x
    w41 = w3 * crank_tip_x
    w42 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w43 = w5 * w42
    w44 = w7 * w42
    w45 = rod_q4_dot * rod_end_shape_0_3
    w46 = rod_q1 * c38 - rod_q2 * rod_phi_cross_phi_3_1
    # outputs
    M = ca.SX(13, 13)
    # crank.x
    M[0, 0] = crank_mass
    M[0, 2] = w2
    # crank.y
    M[1, 1] = crank_mass
    M[1, 2] = w4
    # crank.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c0
    # rod.x
    M[3, 3] = rod_mass
    M[3, 5] = w10
    M[3, 6] = w11
    M[3, 8] = w12
    M[3, 9] = w13
    # rod.y
    M[4, 4] = rod_mass
    M[4, 5] = w14
    M[4, 6] = w15
    M[4, 8] = w16
    M[4, 9] = w17
    # rod.theta
    M[5, 3] = w10
    M[5, 4] = w14
    M[5, 5] = rod_inertia + w22
    M[5, 6] = w23
    M[5, 7] = w24
    M[5, 8] = w25
    M[5, 9] = w46
    # rod.q1
    M[6, 3] = w11
    M[6, 4] = w15
    M[6, 5] = w23
    M[6, 6] = rod_M_ff_0_0
    # rod.q2
    M[7, 5] = w24
    M[7, 7] = rod_M_ff_1_1
    # rod.q3
    M[8, 3] = w12
    M[8, 4] = w16
    M[8, 5] = w25
    M[8, 8] = rod_M_ff_2_2
    M[8, 9] = rod_M_ff_2_3
    # rod.q4
    M[9, 3] = w13
    M[9, 4] = w17
    M[9, 5] = w46
    M[9, 8] = rod_M_ff_2_3
    M[9, 9] = rod_M_ff_3_3
    # slider.x
    M[10, 10] = slider_mass
    # slider.y
    M[11, 11] = slider_mass
    # slider.theta
    M[12, 12] = slider_inertia
    K = ca.SX(13, 13)
    # rod.q1
    K[6, 6] = rod_K_ff_0_0
    # rod.q2
    K[7, 7] = rod_K_ff_1_1
    # rod.q3
    K[8, 8] = rod_K_ff_2_2
    K[8, 9] = rod_K_ff_2_3
    # rod.q4
    K[9, 8] = rod_K_ff_2_3
    K[9, 9] = rod_K_ff_3_3
    Q_v = ca.vertcat(
        w27,  # crank.x
        w28,  # crank.y
        0.0,  # crank.theta
        w33,  # rod.x
        w34,  # rod.y
        w35,  # rod.theta
        w36,  # rod.q1
        w37,  # rod.q2
        w38,  # rod.q3
        w39,  # rod.q4
        0.0,  # slider.x
        0.0,  # slider.y
        0.0,  # slider.theta
    )
    Q_F = ca.SX(13, 1)
    Q_star = ca.vertcat(
        w27,  # crank.x
        w28,  # crank.y
        0.0,  # crank.theta
        w33,  # rod.x
        w34,  # rod.y
        w35,  # rod.theta
        w36 - rod_q1 * rod_K_ff_0_0,  # rod.q1
        w37 - rod_q2 * rod_K_ff_1_1,  # rod.q2
        w38 - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3),  # rod.q3
        w39 - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3),  # rod.q4
        0.0,  # slider.x
        0.0,  # slider.y
        0.0,  # slider.theta
    )
    C_q = ca.SX(8, 13)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w40
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w41
    C_q[3, 4] = 1.0
    # slide.normal
    C_q[4, 11] = 1.0
    # slide.angle
    C_q[5, 12] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w43
    C_q[6, 9] = w7 * c32
    C_q[6, 10] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w44
    C_q[7, 9] = w5 * c32
    C_q[7, 11] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w26 * w41)  # B.x
    gamma[3] = -(w26 * w40)  # B.y
    gamma[6] = -(w29 * w44 + w30 * (w5 * w45))  # C.x
    gamma[7] = w30 * (w7 * w45) - w29 * w43  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes q_ddot (n = 13) [mixed]: accelerations of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    148 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 45)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    rod_q1_ddot = q_ddot[6]
    rod_q2_ddot = q_ddot[7]
    rod_q3_ddot = q_ddot[8]
    rod_q4_ddot = q_ddot[9]
    slider_x_ddot = q_ddot[10]
    slider_y_ddot = q_ddot[11]
    slider_theta_ddot = q_ddot[12]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    crank_mass = c[33]
    c34 = c[34]
    slider_inertia = c[37]
    # intermediate terms (33)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c34
    w2 = ca.sin(crank_theta) * c34
    w3 = rod_theta_dot**2
    w4 = ca.cos(rod_theta)
    w5 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w6 = ca.sin(rod_theta)
    w7 = rod_q1 * rod_phi_integral_1_0
    w8 = w4 * w5 - w6 * w7
    w9 = 2 * rod_theta_dot
    w10 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w11 = rod_q1_dot * rod_phi_integral_1_0
    w12 = w5 * w6 + w4 * w7
    w13 = rod_x_ddot * rod_mass - w12 * rod_theta_ddot - w6 * rod_phi_integral_1_0 * rod_q1_ddot + w4 * rod_phi_integral_0_2 * rod_q3_ddot
    w14 = slider_x_ddot * slider_mass
    w15 = w3 * w8 + w9 * (w6 * w10 + w4 * w11) - (w13 + w4 * rod_phi_integral_0_3 * rod_q4_ddot) - w14
    w16 = w0 * w1 - (crank_x_ddot * crank_mass - w2 * crank_theta_ddot) + w15
    w17 = rod_y_ddot * rod_mass + w8 * rod_theta_ddot + rod_q1_ddot * (w4 * rod_phi_integral_1_0) + rod_q3_ddot * (w6 * rod_phi_integral_0_2)
    w18 = rod_q1 * rod_M_ff_0_0
    w19 = rod_q2 * rod_M_ff_1_1
    w20 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w21 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w22 = rod_theta_dot * -2.0 * (rod_q1_dot * w18 + w19 * rod_q2_dot + rod_q3_dot * w20 + rod_q4_dot * w21)
    w23 = rod_q1 * w18 + rod_q2 * w19 + rod_q3 * (rod_rho_dot_phi_2_0 + w20) + rod_q4 * (rod_rho_dot_phi_3_0 + w21)
    w24 = rod_q1_ddot * (rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3))
    w25 = w8 * rod_y_ddot - rod_x_ddot * w12 + rod_theta_ddot * (rod_inertia + w23) + w24 + (rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3) * rod_q2_ddot
    w26 = w25 - rod_q3_ddot * (rod_q1 * rod_phi_cross_phi_2_0) - rod_q4_ddot * (rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1)
    w27 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w28 = (w22 - w26 + w14 * (w6 * w27)) / (w4 * w27)
    w29 = w3 * w12 - w9 * (w4 * w10 - w6 * w11) - (w17 + rod_q4_ddot * (w6 * rod_phi_integral_0_3)) - w28
    w30 = w0 * w2 - (crank_y_ddot * crank_mass + w1 * crank_theta_ddot) + w29
    w31 = w28 - slider_y_ddot * slider_mass
    w32 = slider_theta_ddot * slider_inertia
    # outputs
    lam = ca.vertcat(
        w16,  # A.x
        w30,  # A.y
        w15,  # B.x
        w29,  # B.y
        w31,  # slide.normal
        -w32,  # slide.angle
        -w14,  # C.x
        -w28,  # C.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w16, -w30, 0.0),  # A
        ca.vertcat(-w15, -w29, 0.0),  # B
        ca.vertcat(0.0, -w31, w32),  # slide
        ca.vertcat(w14, w28, 0.0),  # C
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    166 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 45)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    slider_x_dot = q_dot[10]
    slider_y_dot = q_dot[11]
    slider_theta_dot = q_dot[12]
    c0 = c[0]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    crank_mass = c[33]
    c34 = c[34]
    slider_inertia = c[37]
    c39 = c[39]
    c40 = c[40]
    # intermediate terms (31)
    w0 = ca.sin(crank_theta) * c34
    w1 = ca.cos(crank_theta) * c34
    w2 = crank_x_dot * (crank_x_dot * crank_mass - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * crank_mass + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta)
    w4 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w5 = ca.cos(rod_theta)
    w6 = rod_q1 * rod_phi_integral_1_0
    w7 = w3 * w4 + w5 * w6
    w8 = w3 * rod_phi_integral_1_0
    w9 = w5 * rod_phi_integral_0_2
    w10 = w5 * rod_phi_integral_0_3
    w11 = rod_x_dot * (rod_x_dot * rod_mass - w7 * rod_theta_dot - w8 * rod_q1_dot + w9 * rod_q3_dot + w10 * rod_q4_dot)
    w12 = w4 * w5 - w3 * w6
    w13 = w5 * rod_phi_integral_1_0
    w14 = w3 * rod_phi_integral_0_2
    w15 = w3 * rod_phi_integral_0_3
    w16 = rod_y_dot * rod_mass + rod_theta_dot * w12 + rod_q1_dot * w13 + rod_q3_dot * w14 + rod_q4_dot * w15
    w17 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c0) + w11 + rod_y_dot * w16
    w18 = rod_q1 * (rod_q1 * rod_M_ff_0_0) + rod_q2 * (rod_q2 * rod_M_ff_1_1) + rod_q3 * (rod_q4 * rod_M_ff_2_3 + (rod_q3 * rod_M_ff_2_2 + c39))
    w19 = rod_theta_dot * (rod_inertia + (w18 + rod_q4 * (rod_q4 * rod_M_ff_3_3 + (rod_q3 * rod_M_ff_2_3 + c40))))
    w20 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w21 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w22 = rod_q1 * rod_phi_cross_phi_2_0
    w23 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w24 = rod_y_dot * w12 - rod_x_dot * w7 + w19 + rod_q1_dot * w20 + w21 * rod_q2_dot - rod_q3_dot * w22 - rod_q4_dot * w23
    w25 = rod_q1_dot * (rod_y_dot * w13 - rod_x_dot * w8 + rod_theta_dot * w20 + rod_q1_dot * rod_M_ff_0_0)
    w26 = rod_x_dot * w9 + rod_y_dot * w14 - rod_theta_dot * w22 + rod_q3_dot * rod_M_ff_2_2 + rod_q4_dot * rod_M_ff_2_3
    w27 = w17 + rod_theta_dot * w24 + w25 + rod_q2_dot * (rod_theta_dot * w21 + rod_q2_dot * rod_M_ff_1_1) + rod_q3_dot * w26
    w28 = rod_q3_dot * rod_M_ff_2_3 + rod_x_dot * w10 + rod_y_dot * w15 - rod_theta_dot * w23 + rod_q4_dot * rod_M_ff_3_3
    w29 = w27 + rod_q4_dot * w28 + slider_x_dot * (slider_x_dot * slider_mass) + slider_y_dot * (slider_y_dot * slider_mass)
    w30 = rod_q1 * (rod_q1 * rod_K_ff_0_0) + rod_q2 * (rod_q2 * rod_K_ff_1_1) + rod_q3 * (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    # outputs
    kinetic = ca.vertcat((w29 + slider_theta_dot * (slider_theta_dot * slider_inertia)) / 2.0)
    elastic = ca.vertcat((w30 + rod_q4 * (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)) / 2.0)
    potential = ca.SX(1, 1)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    9 operations.
    """
    q = ca.SX.sym("q", 13)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[10]
    slider_y = q[11]
    slider_theta = q[12]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(rod_theta)
    w3 = ca.sin(rod_theta)
    w4 = ca.cos(slider_theta)
    w5 = ca.sin(slider_theta)
    # outputs
    poses = ca.SX(12, 3)
    poses[0, 0] = crank_x
    poses[0, 1] = rod_x
    poses[0, 2] = slider_x
    poses[1, 0] = crank_y
    poses[1, 1] = rod_y
    poses[1, 2] = slider_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[3, 2] = w4
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[4, 2] = w5
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[6, 2] = -w5
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[7, 2] = w4
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    poses[11, 2] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i, through q_d
    416 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    c36 = c[36]
    c38 = c[38]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (103)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * rod_mass
    w4 = rod_theta_dot**2
    w5 = ca.sin(rod_theta)
    w6 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * rod_phi_integral_1_0
    w9 = w5 * w6 + w7 * w8
    w10 = w4 * w9
    w11 = 2 * rod_theta_dot
    w12 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w13 = rod_q1_dot * rod_phi_integral_1_0
    w14 = w7 * w12 - w5 * w13
    w15 = w11 * w14
    w16 = ca.sin(crank_theta) * crank_tip_x
    w17 = w1 * w16
    w18 = w6 * w7 - w5 * w8
    w19 = rod_q4_dot * rod_end_shape_0_3
    w20 = w7 * w19
    w21 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w22 = w5 * w21
    w23 = w11 * w20 - w4 * w22
    w24 = w23 - w17
    w25 = w7 * w21
    w26 = w24 / w25
    w27 = w18 * w26
    w28 = rod_theta_dot * -2.0
    w29 = rod_q1 * rod_M_ff_0_0
    w30 = rod_q2 * rod_M_ff_1_1
    w31 = rod_q3 * rod_M_ff_2_2
    w32 = rod_q4 * rod_M_ff_2_3
    w33 = rod_rho_dot_phi_2_0 + (w31 + w32)
    w34 = rod_q3 * rod_M_ff_2_3
    w35 = rod_q4 * rod_M_ff_3_3
    w36 = rod_rho_dot_phi_3_0 + (w34 + w35)
    w37 = rod_q1_dot * w29 + w30 * rod_q2_dot + rod_q3_dot * w33 + rod_q4_dot * w36
    w38 = rod_rho_dot_phi_2_0 + w33
    w39 = rod_rho_dot_phi_3_0 + w36
    w40 = rod_inertia + (rod_q1 * w29 + rod_q2 * w30 + rod_q3 * w38 + rod_q4 * w39)
    w41 = w22 * w26
    w42 = w5 * w19
    w43 = w4 * w25 + w11 * w42
    w44 = (w41 - (w2 + w43)) * slider_mass
    w45 = (w28 * w37 - (w2 * w9 - w17 * w18 - w26 * w40) + w22 * w44) / w25
    w46 = w5 * w12 + w7 * w13
    w47 = w4 * w18 + w11 * w46
    w48 = w9 * w26
    w49 = w0 * w3 - (w16 * (w10 - w15 + (w17 * rod_mass + w27) - w45) + w0 * (w47 - (w48 - w3) - w44)) + w16 * (w17 * c4)
    w50 = w22 * slider_mass
    w51 = w9 + w50
    w52 = w0 * w18 + w16 * w51
    w53 = 2 * w20 - w11 * w22
    w54 = w7 * rod_end_shape_0_3
    w55 = rod_q4_dot * w54 - rod_theta_dot * w22
    w56 = w0 / w25
    w57 = (crank_theta_dot * w16 + w55 * w56) / w25
    w58 = w43 - w41
    w59 = (w2 - w53 * w57 - w56 * w58) / w25
    w60 = (w11 * w25 + 2 * w42) * slider_mass
    w61 = w0 * (w9 * w11 - 2 * w14) - w16 * (w11 * w18 + 2 * w46 + w60)
    w62 = (w23 - w24) * slider_mass
    w63 = w0 * (w47 - w48) - w16 * (w15 - w10 - w27 + w62)
    w64 = w2 * w18
    w65 = w40 + w22 * w50
    w66 = w37 * -2.0 - w22 * w60
    w67 = w22 * w45 - (w64 + w9 * w17) + w25 * w44 - w22 * w62
    w68 = w64 + w17 * w51 - w59 * w65 + w57 * w66 - w56 * w67
    w69 = w7 * rod_phi_integral_1_0
    w70 = w5 * rod_phi_integral_1_0
    w71 = w2 * w69 + w17 * w70
    w72 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w73 = w11 * w29 + 2 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)
    w74 = w11 * w30 + rod_q4_dot * c41
    w75 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w76 = w5 * rod_phi_integral_0_2
    w77 = w7 * rod_phi_integral_0_2
    w78 = w2 * w76 - w17 * w77
    w79 = rod_q1 * rod_phi_cross_phi_2_0
    w80 = w11 * w33 + rod_q1_dot * c42
    w81 = w5 * rod_phi_integral_0_3
    w82 = w2 * w81
    w83 = w7 * rod_phi_integral_0_3
    w84 = w54 * slider_mass
    w85 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1 + w22 * w84
    w86 = w11 * w36 + 2 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) + w54 * w60
    w87 = w5 * rod_end_shape_0_3
    w88 = w44 * w87
    w89 = w45 * w54
    w90 = w82 - w17 * w83
    w91 = w88 - (w89 + w90) + w54 * w62
    w92 = w87 / w25
    w93 = w28 * (rod_q1_dot * rod_M_ff_0_0) - (w71 - w26 * (2 * w29))
    w94 = w28 * (rod_q2_dot * rod_M_ff_1_1) + w26 * (2 * w30)
    w95 = w28 * (rod_q3_dot * rod_M_ff_2_2 + rod_q4_dot * rod_M_ff_2_3) - (w78 - w26 * (w32 + (w31 + w38)))
    w96 = w4 * rod_M_ff_2_3 - rod_K_ff_2_3
    w97 = (w4 * w54 - w26 * w87) * slider_mass
    w98 = (w55 * w92 - rod_theta_dot * w54) / w25
    w99 = (w4 * w87 + w26 * w54 - w53 * w98 - w58 * w92) / w25
    w100 = w0 * (w4 * w81 + w26 * w83) - w16 * (w4 * w83 - w26 * w81 + w97) - w52 * w99 + w61 * w98 - w63 * w92
    w101 = w28 * (rod_q3_dot * rod_M_ff_2_3 + rod_q4_dot * rod_M_ff_3_3) - (w90 - w26 * (w34 + (w35 + w39)))
    w102 = w88 + (w101 - w89) - w22 * w97 - w65 * w99 + w66 * w98 - w67 * w92
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # crank.theta
            w49 - w52 * w59 + w57 * w61 - w56 * w63 - w56 * w68,
            w0 * (w4 * w69 - w26 * w70) + w16 * (w26 * w69 + w4 * w70) - w56 * w93, -(w56 * w94),
            w0 * (w4 * w76 + w26 * w77) - w16 * (w4 * w77 - w26 * w76) - w56 * w95, w100 - w56 * w102,
        ),
        ca.horzcat(  # rod.q1
            w71 - w59 * w72 + w57 * w73 + w56 * w71, w4 * rod_M_ff_0_0 - rod_K_ff_0_0, 0.0, w26 * c43,
            w73 * w98 - (w26 * rod_phi_cross_phi_0_3 + w72 * w99) + w71 * w92,
        ),
        ca.horzcat(  # rod.q2
            w57 * w74 - w59 * w75, 0.0, w4 * rod_M_ff_1_1 - rod_K_ff_1_1, 0.0,
            w74 * w98 - (w26 * rod_phi_cross_phi_1_3 + w75 * w99),
        ),
        ca.horzcat(  # rod.q3
            w78 + w59 * w79 + w57 * w80 + w56 * w78, w26 * c36, 0.0, w4 * rod_M_ff_2_2 - rod_K_ff_2_2,
            w96 + w79 * w99 + w80 * w98 + w78 * w92,
        ),
        ca.horzcat(  # rod.q4
            w82 - w17 * (w83 + w84) + w59 * w85 + w57 * w86 - w56 * w91 - w68 * w92, w26 * c38 - w92 * w93,
            w26 * c44 - w92 * w94, w96 - w92 * w95,
            w4 * rod_M_ff_3_3 - rod_K_ff_3_3 + w54 * w97 + w85 * w99 + w86 * w98 - w91 * w92 - w92 * w102,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    263 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    c41 = c[41]
    c42 = c[42]
    # intermediate terms (58)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = 2 * crank_theta_dot
    w3 = w1 * w2
    w4 = w0 * w2
    w5 = ca.cos(rod_theta)
    w6 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w7 = ca.sin(rod_theta)
    w8 = rod_q1 * rod_phi_integral_1_0
    w9 = w5 * w6 - w7 * w8
    w10 = w6 * w7 + w5 * w8
    w11 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w12 = w7 * w11
    w13 = w12 * slider_mass
    w14 = w10 + w13
    w15 = w0 * w9 + w1 * w14
    w16 = w5 * rod_end_shape_0_3
    w17 = rod_q4_dot * w16 - w12 * rod_theta_dot
    w18 = w5 * w11
    w19 = w0 / w18
    w20 = 2 * ((w1 * crank_theta_dot + w17 * w19) / w18)
    w21 = 2 * rod_theta_dot
    w22 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w23 = rod_q1_dot * rod_phi_integral_1_0
    w24 = (w18 * w21 + 2 * (w7 * (rod_q4_dot * rod_end_shape_0_3))) * slider_mass
    w25 = w0 * (w10 * w21 - 2 * (w5 * w22 - w7 * w23)) - w1 * (w9 * w21 + 2 * (w7 * w22 + w5 * w23) + w24)
    w26 = rod_q1 * rod_M_ff_0_0
    w27 = rod_q2 * rod_M_ff_1_1
    w28 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w29 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w30 = rod_q1 * w26 + rod_q2 * w27 + rod_q3 * (rod_rho_dot_phi_2_0 + w28) + rod_q4 * (rod_rho_dot_phi_3_0 + w29)
    w31 = rod_inertia + w30 + w12 * w13
    w32 = (rod_q1_dot * w26 + w27 * rod_q2_dot + rod_q3_dot * w28 + rod_q4_dot * w29) * -2.0 - w12 * w24
    w33 = w3 * w9 - w4 * w14 - w20 * w31 - w19 * w32
    w34 = w5 * rod_phi_integral_1_0
    w35 = w7 * rod_phi_integral_1_0
    w36 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w37 = w21 * w26 + 2 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)
    w38 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w39 = w21 * w27 + rod_q4_dot * c41
    w40 = w7 * rod_phi_integral_0_2
    w41 = w5 * rod_phi_integral_0_2
    w42 = rod_q1 * rod_phi_cross_phi_2_0
    w43 = w21 * w28 + rod_q1_dot * c42
    w44 = w7 * rod_phi_integral_0_3
    w45 = w5 * rod_phi_integral_0_3
    w46 = w16 * slider_mass
    w47 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1 + w12 * w46
    w48 = w21 * w29 + 2 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) + w16 * w24
    w49 = w7 * rod_end_shape_0_3
    w50 = w49 / w18
    w51 = rod_theta_dot * -2.0
    w52 = w26 * w51
    w53 = w27 * w51
    w54 = w28 * w51
    w55 = w21 * w49 * slider_mass
    w56 = 2 * ((w17 * w50 - w16 * rod_theta_dot) / w18)
    w57 = w29 * w51 - w12 * w55 - w31 * w56 - w32 * w50
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w3 * rod_mass) - w1 * (w4 * c4) - w15 * w20 - w19 * w25 - w19 * w33,
            w0 * (w21 * w35) - w1 * (w21 * w34) - w19 * w52, -(w19 * w53),
            -(w0 * (w21 * w41) + w1 * (w21 * w40) + w19 * w54),
            -(w0 * (w21 * w45) + w1 * (w21 * w44 + w55) + w15 * w56 + w25 * w50 + w19 * w57),
        ),
        ca.horzcat(  # rod.q1
            w3 * w34 - w4 * w35 - w20 * w36 - w19 * w37, 0.0, 0.0, w21 * rod_phi_cross_phi_0_2,
            w21 * rod_phi_cross_phi_0_3 - w36 * w56 - w37 * w50,
        ),
        ca.horzcat(  # rod.q2
            -(w20 * w38 + w19 * w39), 0.0, 0.0, 0.0, w21 * rod_phi_cross_phi_1_3 - w38 * w56 - w39 * w50,
        ),
        ca.horzcat(  # rod.q3
            w3 * w40 + w4 * w41 + w20 * w42 - w19 * w43, w21 * rod_phi_cross_phi_2_0, 0.0, 0.0,
            w42 * w56 - w43 * w50,
        ),
        ca.horzcat(  # rod.q4
            w3 * w44 + w4 * (w45 + w46) + w20 * w47 - w19 * w48 - w33 * w50,
            w21 * rod_phi_cross_phi_3_0 - w50 * w52, w21 * rod_phi_cross_phi_3_1 - w50 * w53, -(w50 * w54),
            w16 * w55 + w47 * w56 - w48 * w50 - w50 * w57,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 5) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 5 x 5) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    591 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    rod_q3_ddot = q_i_ddot[3]
    rod_q4_ddot = q_i_ddot[4]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    c36 = c[36]
    c38 = c[38]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (129)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = crank_theta_dot**2
    w3 = crank_theta_ddot * w1 + w0 * w2
    w4 = w3 * rod_mass
    w5 = rod_theta_dot**2
    w6 = ca.sin(rod_theta)
    w7 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w8 = ca.cos(rod_theta)
    w9 = rod_q1 * rod_phi_integral_1_0
    w10 = w6 * w7 + w8 * w9
    w11 = w5 * w10
    w12 = 2 * rod_theta_dot
    w13 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w14 = rod_q1_dot * rod_phi_integral_1_0
    w15 = w8 * w13 - w6 * w14
    w16 = w12 * w15
    w17 = w1 * w2
    w18 = w0 * crank_theta_ddot - w17
    w19 = w7 * w8 - w6 * w9
    w20 = rod_q4_dot * rod_end_shape_0_3
    w21 = w8 * w20
    w22 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w23 = w6 * w22
    w24 = w12 * w21 - w5 * w23
    w25 = w8 * w22
    w26 = w0 / w25
    w27 = w6 * rod_end_shape_0_3
    w28 = w27 / w25
    w29 = (w24 - w17) / w25 + crank_theta_ddot * w26 + w28 * rod_q4_ddot
    w30 = w19 * w29
    w31 = w8 * rod_phi_integral_1_0
    w32 = w31 * rod_q1_ddot
    w33 = w6 * rod_phi_integral_0_2
    w34 = w33 * rod_q3_ddot
    w35 = w6 * rod_phi_integral_0_3
    w36 = rod_q4_ddot * w35
    w37 = rod_theta_dot * -2.0
    w38 = rod_q1 * rod_M_ff_0_0
    w39 = rod_q2 * rod_M_ff_1_1
    w40 = rod_q3 * rod_M_ff_2_2
    w41 = rod_q4 * rod_M_ff_2_3
    w42 = rod_rho_dot_phi_2_0 + (w40 + w41)
    w43 = rod_q3 * rod_M_ff_2_3
    w44 = rod_q4 * rod_M_ff_3_3
    w45 = rod_rho_dot_phi_3_0 + (w43 + w44)
    w46 = rod_q1_dot * w38 + w39 * rod_q2_dot + rod_q3_dot * w42 + rod_q4_dot * w45
    w47 = rod_rho_dot_phi_2_0 + w42
    w48 = rod_rho_dot_phi_3_0 + w45
    w49 = rod_inertia + (rod_q1 * w38 + rod_q2 * w39 + rod_q3 * w47 + rod_q4 * w48)
    w50 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w51 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w52 = rod_q1 * rod_phi_cross_phi_2_0
    w53 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w54 = w18 * w19 + w3 * w10 - w29 * w49 + rod_q1_ddot * w50 + w51 * rod_q2_ddot - rod_q3_ddot * w52 - rod_q4_ddot * w53
    w55 = w23 * w29
    w56 = w6 * w20
    w57 = w5 * w25 + w12 * w56
    w58 = w8 * rod_end_shape_0_3
    w59 = rod_q4_ddot * w58
    w60 = (w55 - (w3 + w57) + w59) * slider_mass
    w61 = (w37 * w46 - w54 + w23 * w60) / w25
    w62 = w6 * w13 + w8 * w14
    w63 = w5 * w19 + w12 * w62
    w64 = w10 * w29
    w65 = w6 * rod_phi_integral_1_0
    w66 = rod_q1_ddot * w65
    w67 = w8 * rod_phi_integral_0_2
    w68 = rod_q3_ddot * w67
    w69 = w8 * rod_phi_integral_0_3
    w70 = rod_q4_ddot * w69
    w71 = w1 * (w11 - w16 - (w18 * rod_mass - w30 + w32 + w34 + w36) - w61) + w0 * (w63 - (w64 - w4 - w66 + w68 + w70) - w60)
    w72 = w23 * slider_mass
    w73 = w10 + w72
    w74 = w0 * w19 + w1 * w73
    w75 = 2 * w21 - w12 * w23
    w76 = rod_q4_dot * w58 - rod_theta_dot * w23
    w77 = (w1 * crank_theta_dot + w26 * w76) / w25
    w78 = w57 - (w55 + w59)
    w79 = (w3 - w75 * w77 - w26 * w78) / w25
    w80 = (w12 * w25 + 2 * w56) * slider_mass
    w81 = w0 * (w10 * w12 - 2 * w15) - w1 * (w12 * w19 + 2 * w62 + w80)
    w82 = (w24 + (w27 * rod_q4_ddot - w25 * w29)) * slider_mass
    w83 = w0 * (w63 - (w70 + (w68 - (w66 - w64)))) - w1 * (w16 - w11 + (w36 + (w34 + (w32 - w30))) + w82)
    w84 = w3 * w19
    w85 = w49 + w23 * w72
    w86 = w46 * -2.0 - w23 * w80
    w87 = w10 * w18 - w84 + w23 * w61 + w25 * w60 - w23 * w82
    w88 = w84 - w18 * w73 - w79 * w85 + w77 * w86 - w26 * w87
    w89 = w3 * w31
    w90 = w18 * w65
    w91 = w12 * w38 + 2 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)
    w92 = w90 - w89
    w93 = w12 * w39 + rod_q4_dot * c41
    w94 = w3 * w33 + w18 * w67
    w95 = w12 * w42 + rod_q1_dot * c42
    w96 = w3 * w35
    w97 = w58 * slider_mass
    w98 = w69 + w97
    w99 = w53 + w23 * w97
    w100 = w12 * w45 + 2 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) + w58 * w80
    w101 = w27 * w60
    w102 = w58 * w61
    w103 = w96 + w18 * w69
    w104 = w101 - (w102 + w103) + w58 * w82
    w105 = w92 + w29 * (2 * w38) + rod_q3_ddot * rod_phi_cross_phi_2_0 + rod_q4_ddot * rod_phi_cross_phi_3_0
    w106 = w37 * (rod_q1_dot * rod_M_ff_0_0) + w105
    w107 = w37 * (rod_q2_dot * rod_M_ff_1_1) + (w29 * (2 * w39) + rod_q4_ddot * rod_phi_cross_phi_3_1)
    w108 = w37 * (rod_q3_dot * rod_M_ff_2_2 + rod_q4_dot * rod_M_ff_2_3) - (w94 - w29 * (w41 + (w40 + w47)) - rod_q1_ddot * rod_phi_cross_phi_0_2)
    w109 = w5 * rod_M_ff_2_3 - rod_K_ff_2_3
    w110 = (w5 * w58 - w27 * w29) * slider_mass
    w111 = (w28 * w76 - rod_theta_dot * w58) / w25
    w112 = (w5 * w27 + w29 * w58 - w75 * w111 - w28 * w78) / w25
    w113 = w0 * (w5 * w35 + w29 * w69) - w1 * (w5 * w69 - w29 * w35 + w110) - w74 * w112 + w81 * w111 - w28 * w83
    w114 = w103 - w29 * (w43 + (w44 + w48)) - rod_q1_ddot * rod_phi_cross_phi_0_3 - rod_q2_ddot * rod_phi_cross_phi_1_3
    w115 = w101 + (w37 * (rod_q3_dot * rod_M_ff_2_3 + rod_q4_dot * rod_M_ff_3_3) - w114 - w102) - w23 * w110
    w116 = w115 - w85 * w112 + w86 * w111 - w28 * w87
    w117 = w5 * rod_M_ff_3_3 - rod_K_ff_3_3 + w58 * w110 + w99 * w112 + w100 * w111 - w28 * w104 - w28 * w116
    w118 = 2 * crank_theta_dot
    w119 = w1 * w118
    w120 = w0 * w118
    w121 = 2 * w77
    w122 = w19 * w119 - w73 * w120 - w85 * w121 - w26 * w86
    w123 = w37 * w38
    w124 = w37 * w39
    w125 = w37 * w42
    w126 = w12 * w27 * slider_mass
    w127 = 2 * w111
    w128 = w37 * w45 - w23 * w126 - w85 * w127 - w28 * w86
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * w4 - w71 - w1 * (w18 * c4) - w74 * w79 + w77 * w81 - w26 * w83 - w26 * w88,
            w0 * (w5 * w31 - w29 * w65) + w1 * (w29 * w31 + w5 * w65) - w26 * w106, -(w26 * w107),
            w0 * (w5 * w33 + w29 * w67) - w1 * (w5 * w67 - w29 * w33) - w26 * w108, w113 - w26 * w116,
        ),
        ca.horzcat(  # rod.q1
            w89 - w90 - w50 * w79 + w77 * w91 - w26 * w92, w5 * rod_M_ff_0_0 - rod_K_ff_0_0, 0.0, w29 * c43,
            w91 * w111 - (w29 * rod_phi_cross_phi_0_3 + w50 * w112) - w28 * w92,
        ),
        ca.horzcat(  # rod.q2
            w77 * w93 - w51 * w79, 0.0, w5 * rod_M_ff_1_1 - rod_K_ff_1_1, 0.0,
            w93 * w111 - (w29 * rod_phi_cross_phi_1_3 + w51 * w112),
        ),
        ca.horzcat(  # rod.q3
            w94 + w52 * w79 + w77 * w95 + w26 * w94, w29 * c36, 0.0, w5 * rod_M_ff_2_2 - rod_K_ff_2_2,
            w109 + w52 * w112 + w95 * w111 + w28 * w94,
        ),
        ca.horzcat(  # rod.q4
            w96 + w18 * w98 + w79 * w99 + w77 * w100 - w26 * w104 - w28 * w88, w29 * c38 - w28 * w106,
            w29 * c44 - w28 * w107, w109 - w28 * w108, w117,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w119 * rod_mass) - w1 * (w120 * c4) - w74 * w121 - w26 * w81 - w26 * w122,
            w0 * (w12 * w65) - w1 * (w12 * w31) - w26 * w123, -(w26 * w124),
            -(w0 * (w12 * w67) + w1 * (w12 * w33) + w26 * w125),
            -(w0 * (w12 * w69) + w1 * (w12 * w35 + w126) + w74 * w127 + w28 * w81 + w26 * w128),
        ),
        ca.horzcat(  # rod.q1
            w31 * w119 - w65 * w120 - w50 * w121 - w26 * w91, 0.0, 0.0, w12 * rod_phi_cross_phi_0_2,
            w12 * rod_phi_cross_phi_0_3 - w50 * w127 - w28 * w91,
        ),
        ca.horzcat(  # rod.q2
            -(w51 * w121 + w26 * w93), 0.0, 0.0, 0.0, w12 * rod_phi_cross_phi_1_3 - w51 * w127 - w28 * w93,
        ),
        ca.horzcat(  # rod.q3
            w33 * w119 + w67 * w120 + w52 * w121 - w26 * w95, w12 * rod_phi_cross_phi_2_0, 0.0, 0.0,
            w52 * w127 - w28 * w95,
        ),
        ca.horzcat(  # rod.q4
            w35 * w119 + w98 * w120 + w99 * w121 - w26 * w100 - w28 * w122,
            w12 * rod_phi_cross_phi_3_0 - w28 * w123, w12 * rod_phi_cross_phi_3_1 - w28 * w124, -(w28 * w125),
            w58 * w126 + w99 * w127 - w28 * w100 - w28 * w128,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 5 x 4) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 4 x 4) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 4 x 4) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 45)
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    # outputs
    B = ca.SX(5, 4)
    # rod.q1
    B[1, 0] = 1.0
    # rod.q2
    B[2, 1] = 1.0
    # rod.q3
    B[3, 2] = 1.0
    # rod.q4
    B[4, 3] = 1.0
    K_s = ca.SX(4, 4)
    K_s[0, 0] = rod_K_ff_0_0
    K_s[1, 1] = rod_K_ff_1_1
    K_s[2, 2] = rod_K_ff_2_2
    K_s[2, 3] = rod_K_ff_2_3
    K_s[3, 2] = rod_K_ff_2_3
    K_s[3, 3] = rod_K_ff_3_3
    D_s = ca.SX(4, 4)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 4) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 4) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 4) [N, N m]: part of Q_hat of S
    240 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    # intermediate terms (59)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = w0 / w4
    w6 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w7 = ca.sin(rod_theta)
    w8 = rod_q1 * rod_phi_integral_1_0
    w9 = w2 * w6 - w7 * w8
    w10 = w6 * w7 + w2 * w8
    w11 = w3 * w7
    w12 = w11 * slider_mass
    w13 = w0 * w9 + w1 * (w10 + w12)
    w14 = rod_q1 * rod_M_ff_0_0
    w15 = rod_q2 * rod_M_ff_1_1
    w16 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w17 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w18 = rod_q1 * w14 + rod_q2 * w15 + rod_q3 * (rod_rho_dot_phi_2_0 + w16) + rod_q4 * (rod_rho_dot_phi_3_0 + w17)
    w19 = rod_inertia + w18
    w20 = w19 + w11 * w12
    w21 = w2 * rod_phi_integral_1_0
    w22 = w7 * rod_phi_integral_1_0
    w23 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w24 = w0 * w21 + w1 * w22 - w5 * w23
    w25 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w26 = -(w5 * w25)
    w27 = w7 * rod_phi_integral_0_2
    w28 = w2 * rod_phi_integral_0_2
    w29 = rod_q1 * rod_phi_cross_phi_2_0
    w30 = w0 * w27 - w1 * w28 + w5 * w29
    w31 = w7 * rod_phi_integral_0_3
    w32 = w2 * rod_phi_integral_0_3
    w33 = w2 * rod_end_shape_0_3
    w34 = w33 * slider_mass
    w35 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w36 = w35 + w11 * w34
    w37 = w7 * rod_end_shape_0_3 / w4
    w38 = w36 + w20 * w37
    w39 = w0 * w31 - w1 * (w32 + w34) + (w5 * w38 - w13 * w37)
    w40 = -(w23 * w37)
    w41 = -(w25 * w37)
    w42 = rod_M_ff_2_3 + w29 * w37
    w43 = rod_theta_dot**2
    w44 = 2 * rod_theta_dot
    w45 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w46 = rod_q1_dot * rod_phi_integral_1_0
    w47 = crank_theta_dot**2
    w48 = w1 * w47
    w49 = rod_q4_dot * rod_end_shape_0_3
    w50 = (w44 * (w2 * w49) - w11 * w43 - w48) / w4
    w51 = w0 * w47
    w52 = (w11 * w50 - (w51 + (w4 * w43 + w44 * (w7 * w49)))) * slider_mass
    w53 = w0 * (w10 * w43 - w44 * (w2 * w45 - w7 * w46) + (w48 * rod_mass + w9 * w50)) - w1 * (w9 * w43 + w44 * (w7 * w45 + w2 * w46) - (w10 * w50 - w51 * rod_mass) - w52)
    w54 = rod_theta_dot * -2.0 * (w14 * rod_q1_dot + w15 * rod_q2_dot + w16 * rod_q3_dot + w17 * rod_q4_dot)
    w55 = w54 - (w10 * w51 - w9 * w48 - w19 * w50) + w11 * w52
    w56 = w14 * w43 + w44 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3) - rod_q1 * rod_K_ff_0_0
    w57 = w16 * w43 + w44 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w58 = w17 * w43 + w44 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    # outputs
    M_hat_LL = ca.vertcat(c0 + w0 * (w0 * rod_mass) + w1 * (w1 * c4) - (w5 * (w13 - w5 * w20) + w5 * w13))
    M_hat_LS = ca.horzcat(
        w24, w26, w30, w39,
    )
    M_hat_SL = ca.vertcat(
        w24,  # rod.q1
        w26,  # rod.q2
        w30,  # rod.q3
        w39,  # rod.q4
    )
    M_hat_SS = ca.SX(4, 4)
    # rod.q1
    M_hat_SS[0, 0] = rod_M_ff_0_0
    M_hat_SS[0, 3] = w40
    # rod.q2
    M_hat_SS[1, 1] = rod_M_ff_1_1
    M_hat_SS[1, 3] = w41
    # rod.q3
    M_hat_SS[2, 2] = rod_M_ff_2_2
    M_hat_SS[2, 3] = w42
    # rod.q4
    M_hat_SS[3, 0] = w40
    M_hat_SS[3, 1] = w41
    M_hat_SS[3, 2] = w42
    M_hat_SS[3, 3] = rod_M_ff_3_3 + w33 * w34 + (w37 * w38 + w36 * w37)
    Q_hat_L = ca.vertcat(w53 - w5 * w55)
    Q_hat_S = ca.vertcat(
        w56 - (w22 * w51 - w21 * w48 - w23 * w50),  # rod.q1
        w15 * w43 + w44 * (rod_q4_dot * rod_phi_cross_phi_1_3) - rod_q2 * rod_K_ff_1_1 + w25 * w50,  # rod.q2
        w57 - (w29 * w50 - (w28 * w51 + w27 * w48)),  # rod.q3
        w58 - (w35 * w50 - (w32 * w51 + w31 * w48)) - w33 * w52 - w37 * w55,  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 4) [N, N m]: right-hand side of a sub-step, slow q'' given
    180 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_L_ddot[0]
    crank_tip_x = c[1]
    slider_mass = c[3]
    rod_end_x = c[5]
    rod_end_shape_0_3 = c[6]
    rod_first_moment_x = c[7]
    rod_phi_integral_0_2 = c[8]
    rod_phi_integral_0_3 = c[9]
    rod_phi_integral_1_0 = c[10]
    rod_inertia = c[11]
    rod_M_ff_0_0 = c[12]
    rod_M_ff_1_1 = c[13]
    rod_rho_dot_phi_2_0 = c[14]
    rod_M_ff_2_2 = c[15]
    rod_M_ff_2_3 = c[16]
    rod_rho_dot_phi_3_0 = c[17]
    rod_M_ff_3_3 = c[18]
    rod_rho_cross_phi_0_0 = c[19]
    rod_phi_cross_phi_0_2 = c[20]
    rod_phi_cross_phi_0_3 = c[21]
    rod_rho_cross_phi_1_0 = c[22]
    rod_phi_cross_phi_1_3 = c[23]
    rod_phi_cross_phi_2_0 = c[24]
    rod_phi_cross_phi_3_0 = c[25]
    rod_phi_cross_phi_3_1 = c[26]
    rod_K_ff_0_0 = c[27]
    rod_K_ff_1_1 = c[28]
    rod_K_ff_2_2 = c[29]
    rod_K_ff_2_3 = c[30]
    rod_K_ff_3_3 = c[31]
    # intermediate terms (41)
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w3 = w1 * w2
    w4 = w0 * rod_end_shape_0_3 / w3
    w5 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w6 = -(w4 * w5)
    w7 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w8 = -(w4 * w7)
    w9 = rod_q1 * rod_phi_cross_phi_2_0
    w10 = rod_M_ff_2_3 + w4 * w9
    w11 = w1 * rod_end_shape_0_3
    w12 = w11 * slider_mass
    w13 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w14 = w0 * w2
    w15 = w13 + w12 * w14
    w16 = rod_q1 * rod_M_ff_0_0
    w17 = rod_q2 * rod_M_ff_1_1
    w18 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w19 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w20 = rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (rod_rho_dot_phi_2_0 + w18) + rod_q4 * (rod_rho_dot_phi_3_0 + w19)
    w21 = rod_inertia + w20
    w22 = rod_theta_dot**2
    w23 = 2 * rod_theta_dot
    w24 = w16 * w22 + w23 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3) - rod_q1 * rod_K_ff_0_0
    w25 = crank_theta_dot**2
    w26 = ca.cos(crank_theta) * crank_tip_x
    w27 = ca.sin(crank_theta) * crank_tip_x
    w28 = w25 * w26 + w27 * crank_theta_ddot
    w29 = w25 * w27
    w30 = w26 * crank_theta_ddot - w29
    w31 = rod_q4_dot * rod_end_shape_0_3
    w32 = (w23 * (w1 * w31) - w14 * w22 - w29) / w3 + crank_theta_ddot * (w26 / w3)
    w33 = w18 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w34 = w19 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    w35 = (w14 * w32 - (w28 + (w3 * w22 + w23 * (w0 * w31)))) * slider_mass
    w36 = w34 - (w30 * (w0 * rod_phi_integral_0_3) - w28 * (w1 * rod_phi_integral_0_3) + w13 * w32) - w11 * w35
    w37 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w38 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w39 = rod_q1 * rod_phi_integral_1_0
    w40 = w36 - w4 * (w37 - (w28 * (w0 * w38 + w1 * w39) + w30 * (w1 * w38 - w0 * w39) - w21 * w32) + w14 * w35)
    # outputs
    M_hat_SS = ca.SX(4, 4)
    # rod.q1
    M_hat_SS[0, 0] = rod_M_ff_0_0
    M_hat_SS[0, 3] = w6
    # rod.q2
    M_hat_SS[1, 1] = rod_M_ff_1_1
    M_hat_SS[1, 3] = w8
    # rod.q3
    M_hat_SS[2, 2] = rod_M_ff_2_2
    M_hat_SS[2, 3] = w10
    # rod.q4
    M_hat_SS[3, 0] = w6
    M_hat_SS[3, 1] = w8
    M_hat_SS[3, 2] = w10
    M_hat_SS[3, 3] = rod_M_ff_3_3 + w11 * w12 + (w4 * (w15 + w4 * (w21 + w14 * (w14 * slider_mass))) + w4 * w15)
    rhs_S = ca.vertcat(
        w24 - (w0 * rod_phi_integral_1_0 * w28 + w1 * rod_phi_integral_1_0 * w30 - w5 * w32),  # rod.q1
        w17 * w22 + w23 * (rod_q4_dot * rod_phi_cross_phi_1_3) - rod_q2 * rod_K_ff_1_1 + w7 * w32,  # rod.q2
        w33 - (w30 * (w0 * rod_phi_integral_0_2) - w28 * (w1 * rod_phi_integral_0_2) + w9 * w32),  # rod.q3
        w40,  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 67) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 36) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 36) [1/m]: rotation at a drawn point by each mode of its body
    0 operations.
    """
    p = ca.SX.sym("p", 67)
    crank_tip_x = p[31]
    rod_end_x = p[32]
    rod_end_shape_0_3 = p[33]
    rod_at1_x = p[34]
    rod_at1_shape_0_2 = p[35]
    rod_at1_shape_0_3 = p[36]
    rod_at1_shape_1_0 = p[37]
    rod_at1_shape_1_1 = p[38]
    rod_at2_x = p[39]
    rod_at2_shape_0_2 = p[40]
    rod_at2_shape_0_3 = p[41]
    rod_at2_shape_1_0 = p[42]
    rod_at2_shape_1_1 = p[43]
    rod_at3_x = p[44]
    rod_at3_shape_0_2 = p[45]
    rod_at3_shape_0_3 = p[46]
    rod_at3_shape_1_0 = p[47]
    rod_at3_shape_1_1 = p[48]
    rod_at4_x = p[49]
    rod_at4_shape_0_2 = p[50]
    rod_at4_shape_1_0 = p[51]
    rod_at5_x = p[52]
    rod_at5_shape_0_2 = p[53]
    rod_at5_shape_0_3 = p[54]
    rod_at5_shape_1_0 = p[55]
    rod_at5_shape_1_1 = p[56]
    rod_at6_x = p[57]
    rod_at6_shape_0_2 = p[58]
    rod_at6_shape_0_3 = p[59]
    rod_at6_shape_1_0 = p[60]
    rod_at6_shape_1_1 = p[61]
    rod_at7_x = p[62]
    rod_at7_shape_0_2 = p[63]
    rod_at7_shape_0_3 = p[64]
    rod_at7_shape_1_0 = p[65]
    rod_at7_shape_1_1 = p[66]
    # outputs
    positions = ca.SX(3, 13)
    positions[0, 2] = crank_tip_x
    positions[0, 3] = rod_at1_x
    positions[0, 4] = rod_at2_x
    positions[0, 5] = rod_at3_x
    positions[0, 6] = rod_at4_x
    positions[0, 7] = rod_at5_x
    positions[0, 8] = rod_at6_x
    positions[0, 9] = rod_at7_x
    positions[0, 10] = rod_end_x
    axes = ca.SX(9, 13)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[0, 7] = 1.0
    axes[0, 8] = 1.0
    axes[0, 9] = 1.0
    axes[0, 10] = 1.0
    axes[0, 11] = 1.0
    axes[0, 12] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[4, 7] = 1.0
    axes[4, 8] = 1.0
    axes[4, 9] = 1.0
    axes[4, 10] = 1.0
    axes[4, 11] = 1.0
    axes[4, 12] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
    axes[8, 7] = 1.0
    axes[8, 8] = 1.0
    axes[8, 9] = 1.0
    axes[8, 10] = 1.0
    axes[8, 11] = 1.0
    axes[8, 12] = 1.0
    shapes = ca.SX(3, 36)
    shapes[0, 2] = rod_at1_shape_0_2
    shapes[0, 3] = rod_at1_shape_0_3
    shapes[0, 6] = rod_at2_shape_0_2
    shapes[0, 7] = rod_at2_shape_0_3
    shapes[0, 10] = rod_at3_shape_0_2
    shapes[0, 11] = rod_at3_shape_0_3
    shapes[0, 14] = rod_at4_shape_0_2
    shapes[0, 18] = rod_at5_shape_0_2
    shapes[0, 19] = rod_at5_shape_0_3
    shapes[0, 22] = rod_at6_shape_0_2
    shapes[0, 23] = rod_at6_shape_0_3
    shapes[0, 26] = rod_at7_shape_0_2
    shapes[0, 27] = rod_at7_shape_0_3
    shapes[0, 31] = rod_end_shape_0_3
    shapes[1, 0] = rod_at1_shape_1_0
    shapes[1, 1] = rod_at1_shape_1_1
    shapes[1, 4] = rod_at2_shape_1_0
    shapes[1, 5] = rod_at2_shape_1_1
    shapes[1, 8] = rod_at3_shape_1_0
    shapes[1, 9] = rod_at3_shape_1_1
    shapes[1, 12] = rod_at4_shape_1_0
    shapes[1, 16] = rod_at5_shape_1_0
    shapes[1, 17] = rod_at5_shape_1_1
    shapes[1, 20] = rod_at6_shape_1_0
    shapes[1, 21] = rod_at6_shape_1_1
    shapes[1, 24] = rod_at7_shape_1_0
    shapes[1, 25] = rod_at7_shape_1_1
    turns = ca.SX(3, 36)
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes), ca.densify(shapes), ca.densify(turns)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes", "shapes", "turns"])


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
    "deflections": deflections,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
