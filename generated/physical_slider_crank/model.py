"""Flexible slider-crank, crank prescribed, physical axial mass: equations of motion, emitted by symgen from the scene `physical_slider_crank`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 rod.q1 [m], 1 rod.q2 [m], 2 rod.q3 [m], 3 rod.q4 [m]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 crank.theta [rad], 3 rod.x [m], 4 rod.y [m], 5 rod.theta [rad],
    6 slider.x [m], 7 slider.y [m], 8 slider.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 68) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    16 operations.
    """
    p = ca.SX.sym("p", 68)
    omega = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    rod_mass = p[4]
    rod_first_moment_x = p[5]
    rod_inertia = p[6]
    rod_phi_integral_0_2 = p[7]
    rod_phi_integral_0_3 = p[8]
    rod_phi_integral_1_0 = p[9]
    rod_rho_dot_phi_2_0 = p[10]
    rod_rho_dot_phi_3_0 = p[11]
    rod_rho_cross_phi_0_0 = p[12]
    rod_rho_cross_phi_1_0 = p[13]
    rod_M_ff_0_0 = p[14]
    rod_M_ff_1_1 = p[15]
    rod_M_ff_2_2 = p[16]
    rod_M_ff_2_3 = p[17]
    rod_M_ff_3_3 = p[18]
    rod_phi_cross_phi_0_2 = p[19]
    rod_phi_cross_phi_0_3 = p[20]
    rod_phi_cross_phi_1_3 = p[21]
    rod_phi_cross_phi_2_0 = p[22]
    rod_phi_cross_phi_3_0 = p[23]
    rod_phi_cross_phi_3_1 = p[24]
    rod_K_ff_0_0 = p[25]
    rod_K_ff_1_1 = p[26]
    rod_K_ff_2_2 = p[27]
    rod_K_ff_2_3 = p[28]
    rod_K_ff_3_3 = p[29]
    slider_mass = p[30]
    slider_inertia = p[31]
    crank_tip_x = p[32]
    rod_end_x = p[33]
    rod_end_shape_0_3 = p[34]
    # outputs
    c = ca.vertcat(
        rod_M_ff_0_0,  # rod_M_ff_0_0
        rod_end_shape_0_3,  # rod_end_shape_0_3
        rod_end_x,  # rod_end_x
        rod_rho_cross_phi_0_0,  # rod_rho_cross_phi_0_0
        rod_phi_cross_phi_0_2,  # rod_phi_cross_phi_0_2
        rod_phi_cross_phi_0_3,  # rod_phi_cross_phi_0_3
        rod_M_ff_1_1,  # rod_M_ff_1_1
        rod_rho_cross_phi_1_0,  # rod_rho_cross_phi_1_0
        rod_phi_cross_phi_1_3,  # rod_phi_cross_phi_1_3
        rod_M_ff_2_2,  # rod_M_ff_2_2
        rod_M_ff_2_3,  # rod_M_ff_2_3
        rod_phi_cross_phi_2_0,  # rod_phi_cross_phi_2_0
        rod_M_ff_3_3,  # rod_M_ff_3_3
        slider_mass,  # slider_mass
        rod_phi_cross_phi_3_0,  # rod_phi_cross_phi_3_0
        rod_phi_cross_phi_3_1,  # rod_phi_cross_phi_3_1
        rod_inertia,  # rod_inertia
        rod_rho_dot_phi_2_0,  # rod_rho_dot_phi_2_0
        rod_rho_dot_phi_3_0,  # rod_rho_dot_phi_3_0
        rod_K_ff_0_0,  # rod_K_ff_0_0
        rod_phi_integral_1_0,  # rod_phi_integral_1_0
        crank_tip_x,  # crank_tip_x
        rod_K_ff_1_1,  # rod_K_ff_1_1
        rod_K_ff_2_2,  # rod_K_ff_2_2
        rod_K_ff_2_3,  # rod_K_ff_2_3
        rod_phi_integral_0_2,  # rod_phi_integral_0_2
        rod_K_ff_3_3,  # rod_K_ff_3_3
        rod_phi_integral_0_3,  # rod_phi_integral_0_3
        rod_first_moment_x,  # rod_first_moment_x
        omega,  # omega
        crank_tip_x * omega,  # c30
        -rod_end_shape_0_3,  # c31
        -omega,  # c32
        crank_mass,  # crank_mass
        crank_mass * crank_center_of_mass_x,  # c34
        crank_inertia + crank_mass * crank_center_of_mass_x**2,  # c35
        rod_mass,  # rod_mass
        -rod_phi_integral_1_0,  # c37
        -rod_phi_cross_phi_2_0,  # c38
        slider_inertia,  # slider_inertia
        -rod_phi_cross_phi_3_0,  # c40
        rod_rho_dot_phi_2_0 + rod_rho_dot_phi_2_0,  # c41
        rod_rho_dot_phi_3_0 + rod_rho_dot_phi_3_0,  # c42
        2 * rod_phi_cross_phi_1_3,  # c43
        2 * rod_phi_cross_phi_2_0,  # c44
        -rod_phi_cross_phi_0_2,  # c45
        -rod_phi_cross_phi_3_1,  # c46
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 4 x 4) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 4) [N, N m]: condensed force S^T (Q* - M s)
    173 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    # intermediate terms (38)
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
    w26 = w25 * (ca.cos(crank_theta) * crank_tip_x)
    w27 = w25 * (ca.sin(crank_theta) * crank_tip_x)
    w28 = rod_q4_dot * rod_end_shape_0_3
    w29 = (w23 * (w1 * w28) - w14 * w22 - w27) / w3
    w30 = w18 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w31 = w19 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    w32 = (w14 * w29 - (w26 + (w3 * w22 + w23 * (w0 * w28)))) * slider_mass
    w33 = w31 - (w13 * w29 - (w26 * (w1 * rod_phi_integral_0_3) + w27 * (w0 * rod_phi_integral_0_3))) - w11 * w32
    w34 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w35 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w36 = rod_q1 * rod_phi_integral_1_0
    w37 = w33 - w4 * (w34 - (w26 * (w0 * w35 + w1 * w36) - w27 * (w1 * w35 - w0 * w36) - w21 * w29) + w14 * w32)
    # outputs
    M_hat = ca.SX(4, 4)
    # rod.q1
    M_hat[0, 0] = rod_M_ff_0_0
    M_hat[0, 3] = w6
    # rod.q2
    M_hat[1, 1] = rod_M_ff_1_1
    M_hat[1, 3] = w8
    # rod.q3
    M_hat[2, 2] = rod_M_ff_2_2
    M_hat[2, 3] = w10
    # rod.q4
    M_hat[3, 0] = w6
    M_hat[3, 1] = w8
    M_hat[3, 2] = w10
    M_hat[3, 3] = rod_M_ff_3_3 + w11 * w12 + (w4 * (w15 + w4 * (w21 + w14 * (w14 * slider_mass))) + w4 * w15)
    Q_hat = ca.vertcat(
        w24 - (w0 * rod_phi_integral_1_0 * w26 - w1 * rod_phi_integral_1_0 * w27 - w5 * w29),  # rod.q1
        w17 * w22 + w23 * (rod_q4_dot * rod_phi_cross_phi_1_3) - rod_q2 * rod_K_ff_1_1 + w7 * w29,  # rod.q2
        w30 - (w9 * w29 - (w26 * (w1 * rod_phi_integral_0_2) + w27 * (w0 * rod_phi_integral_0_2))),  # rod.q3
        w37,  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes t (1) [s]: time
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 9) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    19 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 47)
    rod_q4 = q_i[3]
    rod_theta = q_d[5]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    crank_tip_x = c[21]
    omega = c[29]
    # intermediate terms (7)
    w0 = t * omega
    w1 = ca.cos(w0) * crank_tip_x
    w2 = ca.sin(w0) * crank_tip_x
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 + ca.sin(rod_theta) * w3
    w5 = w3 * ca.cos(rod_theta)
    w6 = rod_theta - w4 / w5
    # outputs
    q_d_next = ca.SX(9, 1)
    q_d_next[2] = w0  # crank.theta
    q_d_next[3] = w1  # rod.x
    q_d_next[4] = w2  # rod.y
    q_d_next[5] = w6  # rod.theta
    q_d_next[6] = w1 + w3 * ca.cos(w6)  # slider.x
    C_loop = ca.vertcat(-w4)
    det_loop = ca.vertcat(-w5)
    inputs, outputs = [q_i, q_d, t, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "t", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    22 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 47)
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q4_dot = q_i_dot[3]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    omega = c[29]
    c30 = c[30]
    # intermediate terms (7)
    w0 = ca.sin(crank_theta) * c30
    w1 = ca.cos(crank_theta) * c30
    w2 = ca.cos(rod_theta)
    w3 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w1 / w4 + w5 * rod_end_shape_0_3 / w4 * rod_q4_dot
    # outputs
    q_d_dot = ca.SX(9, 1)
    q_d_dot[2] = omega  # crank.theta
    q_d_dot[3] = -w0  # rod.x
    q_d_dot[4] = w1  # rod.y
    q_d_dot[5] = -w6  # rod.theta
    q_d_dot[6] = w6 * (w3 * w5) - w0 + rod_q4_dot * (w2 * rod_end_shape_0_3)  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 9) [mixed]: accelerations of the dependent coordinates
    39 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 47)
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_q4_ddot = q_i_ddot[3]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    crank_tip_x = c[21]
    # intermediate terms (12)
    w0 = crank_theta_dot**2
    w1 = w0 * (ca.cos(crank_theta) * crank_tip_x)
    w2 = w0 * (ca.sin(crank_theta) * crank_tip_x)
    w3 = 2 * rod_theta_dot
    w4 = ca.cos(rod_theta)
    w5 = rod_q4_dot * rod_end_shape_0_3
    w6 = rod_theta_dot**2
    w7 = ca.sin(rod_theta)
    w8 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w9 = w7 * w8
    w10 = w4 * w8
    w11 = (w3 * (w4 * w5) - w6 * w9 - w2) / w10 + w7 * rod_end_shape_0_3 / w10 * rod_q4_ddot
    # outputs
    q_d_ddot = ca.SX(9, 1)
    q_d_ddot[3] = -w1  # rod.x
    q_d_ddot[4] = -w2  # rod.y
    q_d_ddot[5] = -w11  # rod.theta
    q_d_ddot[6] = w9 * w11 - (w1 + (w6 * w10 + w3 * (w5 * w7))) + rod_q4_ddot * (w4 * rod_end_shape_0_3)  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 9) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 9 x 13) [SI]: constraint Jacobian
    gives C_t (n_c = 9) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 9) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    41 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 47)
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
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    crank_tip_x = c[21]
    omega = c[29]
    c31 = c[31]
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
        crank_theta - t * omega,  # drive.angle
    )
    C_q = ca.SX(9, 13)
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
    C_q[6, 9] = w2 * c31
    C_q[6, 10] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w4
    C_q[7, 9] = w5 * c31
    C_q[7, 11] = 1.0
    # drive.angle
    C_q[8, 2] = 1.0
    C_t = ca.SX(9, 1)
    C_t[8] = c32  # drive.angle
    nu = ca.SX(9, 1)
    nu[8] = omega  # drive.angle
    gamma = ca.SX(9, 1)
    gamma[2] = -(w0 * w7)  # B.x
    gamma[3] = -(w1 * w7)  # B.y
    gamma[6] = -(w4 * w8 + w9 * (w5 * w10))  # C.x
    gamma[7] = w9 * (w2 * w10) - w6 * w8  # C.y
    inputs, outputs = [q, q_dot, t, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "t", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 13 x 13) [SI]: mass matrix in all coordinates
    gives K (n x n = 13 x 13) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 13) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 13) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 13) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 9 x 13) [SI]: constraint Jacobian
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    141 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 47)
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
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    c31 = c[31]
    crank_mass = c[33]
    c34 = c[34]
    c35 = c[35]
    rod_mass = c[36]
    c37 = c[37]
    c38 = c[38]
    slider_inertia = c[39]
    c40 = c[40]
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
    w11 = w5 * c37
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
    w25 = rod_q1 * c38
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
    w46 = rod_q1 * c40 - rod_q2 * rod_phi_cross_phi_3_1
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
    M[2, 2] = c35
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
    C_q = ca.SX(9, 13)
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
    C_q[6, 9] = w7 * c31
    C_q[6, 10] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w44
    C_q[7, 9] = w5 * c31
    C_q[7, 11] = 1.0
    # drive.angle
    C_q[8, 2] = 1.0
    gamma = ca.SX(9, 1)
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
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 9) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 5) [N, N m]: world force and moment of a joint on its body b, at b
    160 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 47)
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
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_phi_integral_0_2 = c[25]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    crank_mass = c[33]
    c34 = c[34]
    c35 = c[35]
    rod_mass = c[36]
    slider_inertia = c[39]
    # intermediate terms (36)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta)
    w2 = w1 * c34
    w3 = ca.sin(crank_theta)
    w4 = w3 * c34
    w5 = rod_theta_dot**2
    w6 = ca.cos(rod_theta)
    w7 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w8 = ca.sin(rod_theta)
    w9 = rod_q1 * rod_phi_integral_1_0
    w10 = w6 * w7 - w8 * w9
    w11 = 2 * rod_theta_dot
    w12 = rod_q3_dot * rod_phi_integral_0_2 + rod_q4_dot * rod_phi_integral_0_3
    w13 = rod_q1_dot * rod_phi_integral_1_0
    w14 = w7 * w8 + w6 * w9
    w15 = rod_x_ddot * rod_mass - w14 * rod_theta_ddot - w8 * rod_phi_integral_1_0 * rod_q1_ddot + w6 * rod_phi_integral_0_2 * rod_q3_ddot
    w16 = slider_x_ddot * slider_mass
    w17 = w5 * w10 + w11 * (w8 * w12 + w6 * w13) - (w15 + w6 * rod_phi_integral_0_3 * rod_q4_ddot) - w16
    w18 = w0 * w2 - (crank_x_ddot * crank_mass - w4 * crank_theta_ddot) + w17
    w19 = rod_y_ddot * rod_mass + w10 * rod_theta_ddot + rod_q1_ddot * (w6 * rod_phi_integral_1_0) + rod_q3_ddot * (w8 * rod_phi_integral_0_2)
    w20 = rod_q1 * rod_M_ff_0_0
    w21 = rod_q2 * rod_M_ff_1_1
    w22 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w23 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w24 = rod_theta_dot * -2.0 * (rod_q1_dot * w20 + w21 * rod_q2_dot + rod_q3_dot * w22 + rod_q4_dot * w23)
    w25 = rod_q1 * w20 + rod_q2 * w21 + rod_q3 * (rod_rho_dot_phi_2_0 + w22) + rod_q4 * (rod_rho_dot_phi_3_0 + w23)
    w26 = rod_q1_ddot * (rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3))
    w27 = w10 * rod_y_ddot - rod_x_ddot * w14 + rod_theta_ddot * (rod_inertia + w25) + w26 + (rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3) * rod_q2_ddot
    w28 = w27 - rod_q3_ddot * (rod_q1 * rod_phi_cross_phi_2_0) - rod_q4_ddot * (rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1)
    w29 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w30 = (w24 - w28 + w16 * (w8 * w29)) / (w6 * w29)
    w31 = w5 * w14 - w11 * (w6 * w12 - w8 * w13) - (w19 + rod_q4_ddot * (w8 * rod_phi_integral_0_3)) - w30
    w32 = w0 * w4 - (crank_y_ddot * crank_mass + w2 * crank_theta_ddot) + w31
    w33 = w30 - slider_y_ddot * slider_mass
    w34 = slider_theta_ddot * slider_inertia
    w35 = w31 * (w1 * crank_tip_x) - (w2 * crank_y_ddot - crank_x_ddot * w4 + crank_theta_ddot * c35) - w17 * (w3 * crank_tip_x)
    # outputs
    lam = ca.vertcat(
        w18,  # A.x
        w32,  # A.y
        w17,  # B.x
        w31,  # B.y
        w33,  # slide.normal
        -w34,  # slide.angle
        -w16,  # C.x
        -w30,  # C.y
        w35,  # drive.angle
    )
    joint_forces = ca.SX(3, 5)
    joint_forces[0, 0] = -w18
    joint_forces[0, 1] = -w17
    joint_forces[0, 3] = w16
    joint_forces[1, 0] = -w32
    joint_forces[1, 1] = -w31
    joint_forces[1, 2] = -w33
    joint_forces[1, 3] = w30
    joint_forces[2, 2] = w34
    joint_forces[2, 4] = -w35
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    166 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 47)
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
    rod_M_ff_0_0 = c[0]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    crank_mass = c[33]
    c34 = c[34]
    c35 = c[35]
    rod_mass = c[36]
    slider_inertia = c[39]
    c41 = c[41]
    c42 = c[42]
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
    w17 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c35) + w11 + rod_y_dot * w16
    w18 = rod_q1 * (rod_q1 * rod_M_ff_0_0) + rod_q2 * (rod_q2 * rod_M_ff_1_1) + rod_q3 * (rod_q4 * rod_M_ff_2_3 + (rod_q3 * rod_M_ff_2_2 + c41))
    w19 = rod_theta_dot * (rod_inertia + (w18 + rod_q4 * (rod_q4 * rod_M_ff_3_3 + (rod_q3 * rod_M_ff_2_3 + c42))))
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

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i, through q_d
    267 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    c38 = c[38]
    c40 = c[40]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    # intermediate terms (60)
    w0 = rod_theta_dot**2
    w1 = 2 * rod_theta_dot
    w2 = ca.cos(rod_theta)
    w3 = rod_q4_dot * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w7 = w5 * w6
    w8 = w1 * w4 - w0 * w7
    w9 = crank_theta_dot**2
    w10 = w9 * (ca.sin(crank_theta) * crank_tip_x)
    w11 = w8 - w10
    w12 = w2 * w6
    w13 = w11 / w12
    w14 = w5 * rod_end_shape_0_3
    w15 = w14 / w12
    w16 = rod_theta_dot * -2.0
    w17 = w9 * (ca.cos(crank_theta) * crank_tip_x)
    w18 = w10 * (w5 * rod_phi_integral_1_0) + w17 * (w2 * rod_phi_integral_1_0)
    w19 = rod_q1 * rod_M_ff_0_0
    w20 = rod_q2 * rod_M_ff_1_1
    w21 = w0 * rod_M_ff_2_3 - rod_K_ff_2_3
    w22 = w17 * (w5 * rod_phi_integral_0_2) - w10 * (w2 * rod_phi_integral_0_2)
    w23 = rod_q3 * rod_M_ff_2_2
    w24 = rod_q4 * rod_M_ff_2_3
    w25 = rod_rho_dot_phi_2_0 + (w23 + w24)
    w26 = rod_rho_dot_phi_2_0 + w25
    w27 = w16 * (rod_q3_dot * rod_M_ff_2_2 + rod_q4_dot * rod_M_ff_2_3) - (w22 - w13 * (w24 + (w23 + w26)))
    w28 = w2 * rod_end_shape_0_3
    w29 = (w15 * (rod_q4_dot * w28 - rod_theta_dot * w7) - rod_theta_dot * w28) / w12
    w30 = w3 * w5
    w31 = w1 * w30 + w0 * w12
    w32 = w7 * w13
    w33 = (w0 * w14 + w13 * w28 - w29 * (2 * w4 - w1 * w7) - w15 * (w31 - w32)) / w12
    w34 = (rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)) * w33
    w35 = (w1 * w19 + 2 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)) * w29 - (w13 * rod_phi_cross_phi_0_3 + w34)
    w36 = w29 * (w1 * w20 + rod_q4_dot * c43) - (w13 * rod_phi_cross_phi_1_3 + w33 * (rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3))
    w37 = (w0 * w28 - w13 * w14) * slider_mass
    w38 = w33 * (rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1 + w7 * (w28 * slider_mass))
    w39 = rod_q3 * rod_M_ff_2_3
    w40 = rod_q4 * rod_M_ff_3_3
    w41 = rod_rho_dot_phi_3_0 + (w39 + w40)
    w42 = (w1 * w12 + 2 * w30) * slider_mass
    w43 = w1 * w41 + 2 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) + w28 * w42
    w44 = (w32 - (w17 + w31)) * slider_mass
    w45 = w14 * w44
    w46 = rod_q1_dot * w19 + rod_q2_dot * w20 + rod_q3_dot * w25 + rod_q4_dot * w41
    w47 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w48 = rod_q1 * rod_phi_integral_1_0
    w49 = w5 * w47 + w2 * w48
    w50 = w2 * w47 - w5 * w48
    w51 = rod_rho_dot_phi_3_0 + w41
    w52 = rod_inertia + (rod_q1 * w19 + rod_q2 * w20 + rod_q3 * w26 + rod_q4 * w51)
    w53 = (w16 * w46 - (w17 * w49 - w10 * w50 - w13 * w52) + w7 * w44) / w12
    w54 = w28 * w53
    w55 = w17 * (w5 * rod_phi_integral_0_3) - w10 * (w2 * rod_phi_integral_0_3)
    w56 = (w8 - w11) * slider_mass
    w57 = w0 * rod_M_ff_3_3 - rod_K_ff_3_3 + w28 * w37 + w38 + w29 * w43 - w15 * (w45 - (w54 + w55) + w28 * w56)
    w58 = w16 * (rod_q3_dot * rod_M_ff_2_3 + rod_q4_dot * rod_M_ff_3_3) - (w55 - w13 * (w39 + (w40 + w51)))
    w59 = w45 + (w58 - w54) - w7 * w37 - w33 * (w52 + w7 * (w7 * slider_mass)) + w29 * (w46 * -2.0 - w7 * w42)
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(w0 * rod_M_ff_0_0 - rod_K_ff_0_0, 0.0, w13 * c45, w35 + w15 * w18),  # rod.q1
        ca.horzcat(0.0, w0 * rod_M_ff_1_1 - rod_K_ff_1_1, 0.0, w36),  # rod.q2
        ca.horzcat(  # rod.q3
            w13 * c38, 0.0, w0 * rod_M_ff_2_2 - rod_K_ff_2_2,
            w21 + w33 * (rod_q1 * rod_phi_cross_phi_2_0) + w29 * (w1 * w25 + rod_q1_dot * c44) + w15 * w22,
        ),
        ca.horzcat(  # rod.q4
            w13 * c40 - w15 * (w16 * (rod_q1_dot * rod_M_ff_0_0) - (w18 - w13 * (2 * w19))),
            w13 * c46 - w15 * (w16 * (rod_q2_dot * rod_M_ff_1_1) + w13 * (2 * w20)), w21 - w15 * w27,
            w57 - w15 * (w59 - w15 * (w7 * w53 - (w10 * w49 + w17 * w50) + w12 * w44 - w7 * w56)),
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    125 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    rod_theta_dot = q_d_dot[5]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    # intermediate terms (25)
    w0 = 2 * rod_theta_dot
    w1 = ca.sin(rod_theta)
    w2 = w1 * rod_end_shape_0_3
    w3 = ca.cos(rod_theta)
    w4 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w5 = w3 * w4
    w6 = w2 / w5
    w7 = rod_theta_dot * -2.0
    w8 = rod_q1 * rod_M_ff_0_0
    w9 = rod_q2 * rod_M_ff_1_1
    w10 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w11 = 2 * -w6
    w12 = (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3) * w11 + w0 * rod_phi_cross_phi_0_3
    w13 = w0 * w6
    w14 = rod_q4_dot * rod_end_shape_0_3
    w15 = w3 * rod_end_shape_0_3
    w16 = w1 * w4
    w17 = (w11 * (w3 * w14) + w0 * w15 + w13 * w16) / w5
    w18 = (rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)) * w17
    w19 = w11 * (rod_q4_dot * rod_phi_cross_phi_1_3) + w0 * rod_phi_cross_phi_1_3 - w9 * w13 + w17 * (rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3)
    w20 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w21 = w11 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - w13 * w20 - w17 * (rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1)
    w22 = w7 * w20 - (w8 * rod_q1_dot + w9 * rod_q2_dot + w10 * rod_q3_dot + rod_q4_dot * w20) * (w6 * -2.0)
    w23 = rod_q1 * w8 + rod_q2 * w9 + rod_q3 * (rod_rho_dot_phi_2_0 + w10) + rod_q4 * (rod_rho_dot_phi_3_0 + w20)
    w24 = w21 - w6 * (w22 + w17 * (rod_inertia + w23)) - (w15 + w6 * w16) * ((w16 * w17 - (w11 * (w1 * w14) + w0 * w2 - w5 * w13)) * slider_mass)
    # outputs
    dQ_hat_dq_i_dot = ca.SX(4, 4)
    # rod.q1
    dQ_hat_dq_i_dot[0, 2] = w0 * rod_phi_cross_phi_0_2
    dQ_hat_dq_i_dot[0, 3] = w12 - w8 * w13 + w18
    # rod.q2
    dQ_hat_dq_i_dot[1, 3] = w19
    # rod.q3
    dQ_hat_dq_i_dot[2, 0] = w0 * rod_phi_cross_phi_2_0
    dQ_hat_dq_i_dot[2, 3] = w11 * (rod_q1_dot * rod_phi_cross_phi_2_0) - w10 * w13 - w17 * (rod_q1 * rod_phi_cross_phi_2_0)
    # rod.q4
    dQ_hat_dq_i_dot[3, 0] = w0 * rod_phi_cross_phi_3_0 - w6 * (w7 * w8)
    dQ_hat_dq_i_dot[3, 1] = w0 * rod_phi_cross_phi_3_1 - w6 * (w7 * w9)
    dQ_hat_dq_i_dot[3, 2] = -(w6 * (w7 * w10))
    dQ_hat_dq_i_dot[3, 3] = w24
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 4 x 4) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    338 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_q1_ddot = q_i_ddot[0]
    rod_q2_ddot = q_i_ddot[1]
    rod_q3_ddot = q_i_ddot[2]
    rod_q4_ddot = q_i_ddot[3]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    c38 = c[38]
    c40 = c[40]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    # intermediate terms (72)
    w0 = rod_theta_dot**2
    w1 = 2 * rod_theta_dot
    w2 = ca.cos(rod_theta)
    w3 = rod_q4_dot * rod_end_shape_0_3
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w7 = w5 * w6
    w8 = w1 * w4 - w0 * w7
    w9 = crank_theta_dot**2
    w10 = w9 * (ca.sin(crank_theta) * crank_tip_x)
    w11 = w2 * w6
    w12 = w5 * rod_end_shape_0_3
    w13 = w12 / w11
    w14 = (w8 - w10) / w11 + w13 * rod_q4_ddot
    w15 = rod_theta_dot * -2.0
    w16 = w9 * (ca.cos(crank_theta) * crank_tip_x)
    w17 = w10 * (w5 * rod_phi_integral_1_0) + w16 * (w2 * rod_phi_integral_1_0)
    w18 = rod_q1 * rod_M_ff_0_0
    w19 = w17 - w14 * (2 * w18) - rod_q3_ddot * rod_phi_cross_phi_2_0 - rod_q4_ddot * rod_phi_cross_phi_3_0
    w20 = rod_q2 * rod_M_ff_1_1
    w21 = w13 * (w15 * (rod_q2_dot * rod_M_ff_1_1) + (w14 * (2 * w20) + rod_q4_ddot * rod_phi_cross_phi_3_1))
    w22 = w0 * rod_M_ff_2_3 - rod_K_ff_2_3
    w23 = w16 * (w5 * rod_phi_integral_0_2) - w10 * (w2 * rod_phi_integral_0_2)
    w24 = rod_q3 * rod_M_ff_2_2
    w25 = rod_q4 * rod_M_ff_2_3
    w26 = rod_rho_dot_phi_2_0 + (w24 + w25)
    w27 = rod_rho_dot_phi_2_0 + w26
    w28 = w15 * (rod_q3_dot * rod_M_ff_2_2 + rod_q4_dot * rod_M_ff_2_3) - (w23 - w14 * (w25 + (w24 + w27)) - rod_q1_ddot * rod_phi_cross_phi_0_2)
    w29 = w1 * w18 + 2 * (rod_q3_dot * rod_phi_cross_phi_0_2 + rod_q4_dot * rod_phi_cross_phi_0_3)
    w30 = w2 * rod_end_shape_0_3
    w31 = (w13 * (rod_q4_dot * w30 - rod_theta_dot * w7) - rod_theta_dot * w30) / w11
    w32 = rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)
    w33 = w3 * w5
    w34 = w1 * w33 + w0 * w11
    w35 = rod_q4_ddot * w30
    w36 = w7 * w14
    w37 = (w0 * w12 + w14 * w30 - w31 * (2 * w4 - w1 * w7) - w13 * (w34 - (w35 + w36))) / w11
    w38 = w1 * w20 + rod_q4_dot * c43
    w39 = rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3
    w40 = rod_q1 * rod_phi_cross_phi_2_0
    w41 = w1 * w26 + rod_q1_dot * c44
    w42 = (w0 * w30 - w12 * w14) * slider_mass
    w43 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w44 = w43 + w7 * (w30 * slider_mass)
    w45 = rod_q3 * rod_M_ff_2_3
    w46 = rod_q4 * rod_M_ff_3_3
    w47 = rod_rho_dot_phi_3_0 + (w45 + w46)
    w48 = (w1 * w11 + 2 * w33) * slider_mass
    w49 = w1 * w47 + 2 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) + w30 * w48
    w50 = (w35 + (w36 - (w16 + w34))) * slider_mass
    w51 = w12 * w50
    w52 = rod_q1_dot * w18 + rod_q2_dot * w20 + rod_q3_dot * w26 + rod_q4_dot * w47
    w53 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w54 = rod_q1 * rod_phi_integral_1_0
    w55 = w5 * w53 + w2 * w54
    w56 = w2 * w53 - w5 * w54
    w57 = rod_rho_dot_phi_3_0 + w47
    w58 = rod_inertia + (rod_q1 * w18 + rod_q2 * w20 + rod_q3 * w27 + rod_q4 * w57)
    w59 = w16 * w55 - w10 * w56 - w14 * w58 + rod_q1_ddot * w32 + w39 * rod_q2_ddot - rod_q3_ddot * w40 - rod_q4_ddot * w43
    w60 = (w15 * w52 - w59 + w7 * w50) / w11
    w61 = w30 * w60
    w62 = w16 * (w5 * rod_phi_integral_0_3) - w10 * (w2 * rod_phi_integral_0_3)
    w63 = (w8 + (w12 * rod_q4_ddot - w11 * w14)) * slider_mass
    w64 = w0 * rod_M_ff_3_3 - rod_K_ff_3_3 + w30 * w42 + w37 * w44 + w31 * w49 - w13 * (w51 - (w61 + w62) + w30 * w63)
    w65 = w62 - w14 * (w45 + (w46 + w57)) - rod_q1_ddot * rod_phi_cross_phi_0_3 - rod_q2_ddot * rod_phi_cross_phi_1_3
    w66 = w58 + w7 * (w7 * slider_mass)
    w67 = w51 + (w15 * (rod_q3_dot * rod_M_ff_2_3 + rod_q4_dot * rod_M_ff_3_3) - w65 - w61) - w7 * w42 - w37 * w66
    w68 = w52 * -2.0 - w7 * w48
    w69 = w64 - w13 * (w67 + w31 * w68 - w13 * (w7 * w60 - (w10 * w55 + w16 * w56) + w11 * w50 - w7 * w63))
    w70 = 2 * w31
    w71 = w1 * w12 * slider_mass
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # rod.q1
            w0 * rod_M_ff_0_0 - rod_K_ff_0_0, 0.0, w14 * c45,
            w29 * w31 - (w14 * rod_phi_cross_phi_0_3 + w32 * w37) + w13 * w17,
        ),
        ca.horzcat(  # rod.q2
            0.0, w0 * rod_M_ff_1_1 - rod_K_ff_1_1, 0.0, w31 * w38 - (w14 * rod_phi_cross_phi_1_3 + w37 * w39),
        ),
        ca.horzcat(w14 * c38, 0.0, w0 * rod_M_ff_2_2 - rod_K_ff_2_2, w22 + w37 * w40 + w31 * w41 + w13 * w23),  # rod.q3
        ca.horzcat(  # rod.q4
            w14 * c40 - w13 * (w15 * (rod_q1_dot * rod_M_ff_0_0) - w19), w14 * c46 - w21, w22 - w13 * w28, w69,
        ),
    )
    J_v = ca.SX(4, 4)
    # rod.q1
    J_v[0, 2] = w1 * rod_phi_cross_phi_0_2
    J_v[0, 3] = w1 * rod_phi_cross_phi_0_3 - w32 * w70 - w13 * w29
    # rod.q2
    J_v[1, 3] = w1 * rod_phi_cross_phi_1_3 - w39 * w70 - w13 * w38
    # rod.q3
    J_v[2, 0] = w1 * rod_phi_cross_phi_2_0
    J_v[2, 3] = w40 * w70 - w13 * w41
    # rod.q4
    J_v[3, 0] = w1 * rod_phi_cross_phi_3_0 - w13 * (w15 * w18)
    J_v[3, 1] = w1 * rod_phi_cross_phi_3_1 - w13 * (w15 * w20)
    J_v[3, 2] = -(w13 * (w15 * w26))
    J_v[3, 3] = w30 * w71 + w44 * w70 - w13 * w49 - w13 * (w15 * w47 - w7 * w71 - w66 * w70 - w13 * w68)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 4 x 4) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 4 x 4) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 4 x 4) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 47)
    rod_K_ff_0_0 = c[19]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_K_ff_3_3 = c[26]
    # outputs
    B = ca.SX(4, 4)
    # rod.q1
    B[0, 0] = 1.0
    # rod.q2
    B[1, 1] = 1.0
    # rod.q3
    B[2, 2] = 1.0
    # rod.q4
    B[3, 3] = 1.0
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

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 2 x 2) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 2 x 2) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 2 x 2) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 2) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 2) [N, N m]: part of Q_hat of S
    173 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_K_ff_0_0 = c[19]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_1_1 = c[22]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    # intermediate terms (38)
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
    w26 = w25 * (ca.cos(crank_theta) * crank_tip_x)
    w27 = w25 * (ca.sin(crank_theta) * crank_tip_x)
    w28 = rod_q4_dot * rod_end_shape_0_3
    w29 = (w23 * (w1 * w28) - w14 * w22 - w27) / w3
    w30 = w18 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w31 = w19 * w22 + w23 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    w32 = (w14 * w29 - (w26 + (w3 * w22 + w23 * (w0 * w28)))) * slider_mass
    w33 = w31 - (w13 * w29 - (w26 * (w1 * rod_phi_integral_0_3) + w27 * (w0 * rod_phi_integral_0_3))) - w11 * w32
    w34 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w35 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w36 = rod_q1 * rod_phi_integral_1_0
    w37 = w33 - w4 * (w34 - (w26 * (w0 * w35 + w1 * w36) - w27 * (w1 * w35 - w0 * w36) - w21 * w29) + w14 * w32)
    # outputs
    M_hat_LL = ca.SX(2, 2)
    # rod.q1
    M_hat_LL[0, 0] = rod_M_ff_0_0
    # rod.q2
    M_hat_LL[1, 1] = rod_M_ff_1_1
    M_hat_LS = ca.SX(2, 2)
    # rod.q1
    M_hat_LS[0, 1] = w6
    # rod.q2
    M_hat_LS[1, 1] = w8
    M_hat_SL = ca.SX(2, 2)
    # rod.q4
    M_hat_SL[1, 0] = w6
    M_hat_SL[1, 1] = w8
    M_hat_SS = ca.vertcat(
        ca.horzcat(rod_M_ff_2_2, w10),  # rod.q3
        ca.horzcat(  # rod.q4
            w10, rod_M_ff_3_3 + w11 * w12 + (w4 * (w15 + w4 * (w21 + w14 * (w14 * slider_mass))) + w4 * w15),
        ),
    )
    Q_hat_L = ca.vertcat(
        w24 - (w0 * rod_phi_integral_1_0 * w26 - w1 * rod_phi_integral_1_0 * w27 - w5 * w29),  # rod.q1
        w17 * w22 + w23 * (rod_q4_dot * rod_phi_cross_phi_1_3) - rod_q2 * rod_K_ff_1_1 + w7 * w29,  # rod.q2
    )
    Q_hat_S = ca.vertcat(
        w30 - (w9 * w29 - (w26 * (w1 * rod_phi_integral_0_2) + w27 * (w0 * rod_phi_integral_0_2))),  # rod.q3
        w37,  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 9) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    takes q_L_ddot (n_L = 2) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 47) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 2) [N, N m]: right-hand side of a sub-step, slow q'' given
    149 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    q_L_ddot = ca.SX.sym("q_L_ddot", 2)
    c = ca.SX.sym("c", 47)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_q1_ddot = q_L_ddot[0]
    rod_q2_ddot = q_L_ddot[1]
    rod_M_ff_0_0 = c[0]
    rod_end_shape_0_3 = c[1]
    rod_end_x = c[2]
    rod_rho_cross_phi_0_0 = c[3]
    rod_phi_cross_phi_0_2 = c[4]
    rod_phi_cross_phi_0_3 = c[5]
    rod_M_ff_1_1 = c[6]
    rod_rho_cross_phi_1_0 = c[7]
    rod_phi_cross_phi_1_3 = c[8]
    rod_M_ff_2_2 = c[9]
    rod_M_ff_2_3 = c[10]
    rod_phi_cross_phi_2_0 = c[11]
    rod_M_ff_3_3 = c[12]
    slider_mass = c[13]
    rod_phi_cross_phi_3_0 = c[14]
    rod_phi_cross_phi_3_1 = c[15]
    rod_inertia = c[16]
    rod_rho_dot_phi_2_0 = c[17]
    rod_rho_dot_phi_3_0 = c[18]
    rod_phi_integral_1_0 = c[20]
    crank_tip_x = c[21]
    rod_K_ff_2_2 = c[23]
    rod_K_ff_2_3 = c[24]
    rod_phi_integral_0_2 = c[25]
    rod_K_ff_3_3 = c[26]
    rod_phi_integral_0_3 = c[27]
    rod_first_moment_x = c[28]
    # intermediate terms (34)
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = rod_end_x + rod_q4 * rod_end_shape_0_3
    w3 = w1 * w2
    w4 = w0 * rod_end_shape_0_3 / w3
    w5 = rod_q1 * rod_phi_cross_phi_2_0
    w6 = rod_M_ff_2_3 + w4 * w5
    w7 = w1 * rod_end_shape_0_3
    w8 = w7 * slider_mass
    w9 = rod_q1 * rod_phi_cross_phi_3_0 + rod_q2 * rod_phi_cross_phi_3_1
    w10 = w0 * w2
    w11 = w9 + w8 * w10
    w12 = rod_q1 * rod_M_ff_0_0
    w13 = rod_q2 * rod_M_ff_1_1
    w14 = rod_rho_dot_phi_2_0 + (rod_q3 * rod_M_ff_2_2 + rod_q4 * rod_M_ff_2_3)
    w15 = rod_rho_dot_phi_3_0 + (rod_q3 * rod_M_ff_2_3 + rod_q4 * rod_M_ff_3_3)
    w16 = rod_q1 * w12 + rod_q2 * w13 + rod_q3 * (rod_rho_dot_phi_2_0 + w14) + rod_q4 * (rod_rho_dot_phi_3_0 + w15)
    w17 = rod_inertia + w16
    w18 = rod_theta_dot**2
    w19 = 2 * rod_theta_dot
    w20 = w14 * w18 + w19 * (rod_q1_dot * rod_phi_cross_phi_2_0) - (rod_q3 * rod_K_ff_2_2 + rod_q4 * rod_K_ff_2_3)
    w21 = rod_q4_dot * rod_end_shape_0_3
    w22 = crank_theta_dot**2
    w23 = w22 * (ca.sin(crank_theta) * crank_tip_x)
    w24 = (w19 * (w1 * w21) - w10 * w18 - w23) / w3
    w25 = w22 * (ca.cos(crank_theta) * crank_tip_x)
    w26 = w15 * w18 + w19 * (rod_q1_dot * rod_phi_cross_phi_3_0 + rod_q2_dot * rod_phi_cross_phi_3_1) - (rod_q3 * rod_K_ff_2_3 + rod_q4 * rod_K_ff_3_3)
    w27 = (w10 * w24 - (w25 + (w3 * w18 + w19 * (w0 * w21)))) * slider_mass
    w28 = w26 - (w9 * w24 - (w25 * (w1 * rod_phi_integral_0_3) + w23 * (w0 * rod_phi_integral_0_3))) - w7 * w27
    w29 = rod_theta_dot * -2.0 * (w12 * rod_q1_dot + w13 * rod_q2_dot + w14 * rod_q3_dot + w15 * rod_q4_dot)
    w30 = rod_first_moment_x + (rod_q3 * rod_phi_integral_0_2 + rod_q4 * rod_phi_integral_0_3)
    w31 = rod_q1 * rod_phi_integral_1_0
    w32 = (rod_rho_cross_phi_0_0 - (rod_q3 * rod_phi_cross_phi_0_2 + rod_q4 * rod_phi_cross_phi_0_3)) * rod_q1_ddot
    w33 = w25 * (w0 * w30 + w1 * w31) - w23 * (w1 * w30 - w0 * w31) - w17 * w24 + w32 + (rod_rho_cross_phi_1_0 - rod_q4 * rod_phi_cross_phi_1_3) * rod_q2_ddot
    # outputs
    M_hat_SS = ca.vertcat(
        ca.horzcat(rod_M_ff_2_2, w6),  # rod.q3
        ca.horzcat(  # rod.q4
            w6, rod_M_ff_3_3 + w7 * w8 + (w4 * (w11 + w4 * (w17 + w10 * (w10 * slider_mass))) + w4 * w11),
        ),
    )
    rhs_S = ca.vertcat(
        w20 - (w5 * w24 - (w1 * rod_phi_integral_0_2 * w25 + w23 * (w0 * rod_phi_integral_0_2))),  # rod.q3
        w28 - w4 * (w29 - w33 + w10 * w27),  # rod.q4
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 68) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 36) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 36) [1/m]: rotation at a drawn point by each mode of its body
    0 operations.
    """
    p = ca.SX.sym("p", 68)
    crank_tip_x = p[32]
    rod_end_x = p[33]
    rod_end_shape_0_3 = p[34]
    rod_at1_x = p[35]
    rod_at1_shape_0_2 = p[36]
    rod_at1_shape_0_3 = p[37]
    rod_at1_shape_1_0 = p[38]
    rod_at1_shape_1_1 = p[39]
    rod_at2_x = p[40]
    rod_at2_shape_0_2 = p[41]
    rod_at2_shape_0_3 = p[42]
    rod_at2_shape_1_0 = p[43]
    rod_at2_shape_1_1 = p[44]
    rod_at3_x = p[45]
    rod_at3_shape_0_2 = p[46]
    rod_at3_shape_0_3 = p[47]
    rod_at3_shape_1_0 = p[48]
    rod_at3_shape_1_1 = p[49]
    rod_at4_x = p[50]
    rod_at4_shape_0_2 = p[51]
    rod_at4_shape_1_0 = p[52]
    rod_at5_x = p[53]
    rod_at5_shape_0_2 = p[54]
    rod_at5_shape_0_3 = p[55]
    rod_at5_shape_1_0 = p[56]
    rod_at5_shape_1_1 = p[57]
    rod_at6_x = p[58]
    rod_at6_shape_0_2 = p[59]
    rod_at6_shape_0_3 = p[60]
    rod_at6_shape_1_0 = p[61]
    rod_at6_shape_1_1 = p[62]
    rod_at7_x = p[63]
    rod_at7_shape_0_2 = p[64]
    rod_at7_shape_0_3 = p[65]
    rod_at7_shape_1_0 = p[66]
    rod_at7_shape_1_1 = p[67]
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
