"""Flexible slider-crank, driven by a torque: equations of motion, emitted by symgen from the scene `flexible_slider_crank_torque`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 crank.theta [rad], 1 rod.q1 [m], 2 rod.q2 [m]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 rod.x [m], 3 rod.y [m], 4 rod.theta [rad], 5 slider.x [m],
    6 slider.y [m], 7 slider.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 168) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    52 operations.
    """
    p = ca.SX.sym("p", 168)
    motor_torque = p[0]
    gravity_y = p[1]
    crank_mass = p[2]
    crank_inertia = p[3]
    crank_center_of_mass_x = p[4]
    rod_length = p[5]
    rod_density = p[6]
    rod_area = p[7]
    rod_youngs_modulus = p[8]
    rod_second_moment = p[9]
    beam_pinned_pinned2_kappa_lateral_0_0 = p[10]
    beam_pinned_pinned2_kappa_lateral_1_1 = p[11]
    beam_pinned_pinned2_mass_0_0 = p[12]
    beam_pinned_pinned2_mass_1_1 = p[13]
    rod_damping_ratio = p[14]
    beam_pinned_pinned2_s1_0_0 = p[15]
    beam_pinned_pinned2_i0_0_0 = p[16]
    beam_pinned_pinned2_phi_y_0_0 = p[17]
    beam_pinned_pinned2_xi_phi_y_0_0 = p[18]
    beam_pinned_pinned2_xi_phi_y_1_0 = p[19]
    beam_pinned_pinned2_H_0_0 = p[20]
    beam_pinned_pinned2_H_0_1 = p[21]
    beam_pinned_pinned2_H_1_0 = p[22]
    beam_pinned_pinned2_H_1_1 = p[23]
    beam_pinned_pinned2_xH_0_0 = p[24]
    beam_pinned_pinned2_xH_0_1 = p[25]
    beam_pinned_pinned2_xH_1_0 = p[26]
    beam_pinned_pinned2_xH_1_1 = p[27]
    slider_mass = p[28]
    slider_inertia = p[29]
    crank_tip_x = p[30]
    beam_pinned_pinned2_1_0_H_0_0 = p[35]
    beam_pinned_pinned2_1_0_H_1_1 = p[36]
    # intermediate terms (20)
    w0 = rod_density * rod_area
    w1 = w0 * rod_length
    w2 = beam_pinned_pinned2_1_0_H_0_0 / rod_length
    w3 = beam_pinned_pinned2_1_0_H_1_1 / rod_length
    w4 = rod_length * w1
    w5 = w0 * beam_pinned_pinned2_H_0_0
    w6 = w0 * beam_pinned_pinned2_H_0_1
    w7 = w0 * beam_pinned_pinned2_H_1_0
    w8 = w0 * beam_pinned_pinned2_H_1_1
    w9 = w1 * beam_pinned_pinned2_phi_y_0_0
    w10 = rod_length**2
    w11 = w1 * beam_pinned_pinned2_mass_0_0
    w12 = w1 * beam_pinned_pinned2_xH_0_0
    w13 = w1 * beam_pinned_pinned2_mass_1_1
    w14 = w1 * beam_pinned_pinned2_xH_1_1
    w15 = crank_mass * crank_center_of_mass_x
    w16 = rod_youngs_modulus * rod_second_moment / (rod_length * w10)
    w17 = w16 * beam_pinned_pinned2_kappa_lateral_0_0
    w18 = 2 * rod_damping_ratio
    w19 = w16 * beam_pinned_pinned2_kappa_lateral_1_1
    # outputs
    c = ca.vertcat(
        crank_inertia + crank_mass * crank_center_of_mass_x**2,  # c0
        crank_tip_x,  # crank_tip_x
        rod_length,  # rod_length
        w1,  # c3
        slider_mass,  # slider_mass
        w1 + slider_mass,  # c5
        w2,  # c6
        w3,  # c7
        w4 * beam_pinned_pinned2_s1_0_0,  # c8
        w5,  # c9
        w6,  # c10
        w7,  # c11
        w8,  # c12
        w9,  # c13
        w1 * w10 * beam_pinned_pinned2_i0_0_0,  # c14
        w11,  # c15
        w12,  # c16
        w1 * beam_pinned_pinned2_xH_0_1,  # c17
        w13,  # c18
        w1 * beam_pinned_pinned2_xH_1_0,  # c19
        w14,  # c20
        w4 * beam_pinned_pinned2_xi_phi_y_0_0,  # c21
        w4 * beam_pinned_pinned2_xi_phi_y_1_0,  # c22
        gravity_y,  # gravity_y
        w15 * gravity_y,  # c24
        motor_torque,  # motor_torque
        w1 * gravity_y,  # c26
        w17,  # c27
        w18 * ca.sqrt(w11 * w17),  # c28
        w19,  # c29
        w18 * ca.sqrt(w13 * w19),  # c30
        crank_mass,  # crank_mass
        w15,  # c32
        slider_inertia,  # slider_inertia
        crank_mass * gravity_y,  # c34
        slider_mass * gravity_y,  # c35
        -w9,  # c36
        -gravity_y,  # c37
        w11 - w12,  # c38
        w13 - w14,  # c39
        2 * w2,  # c40
        2 * w3,  # c41
        w5 + w5,  # c42
        w6 + w7,  # c43
        w8 + w8,  # c44
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
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
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    gravity_y = c[23]
    c24 = c[24]
    motor_torque = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    # intermediate terms (58)
    w0 = ca.cos(crank_theta)
    w1 = w0 * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = ca.cos(rod_theta)
    w4 = rod_q1 * c6
    w5 = rod_q2 * c7
    w6 = rod_length - (rod_q1 * w4 + rod_q2 * w5) * 0.5
    w7 = w3 * w6
    w8 = w1 / w7
    w9 = rod_q1 * c9 + rod_q2 * c10
    w10 = rod_q1 * c11 + rod_q2 * c12
    w11 = c8 - (rod_q1 * w9 + rod_q2 * w10) * 0.5
    w12 = ca.sin(rod_theta)
    w13 = rod_q1 * c13
    w14 = w3 * w11 - w12 * w13
    w15 = w11 * w12 + w3 * w13
    w16 = w6 * w12
    w17 = w16 * slider_mass
    w18 = w1 * w14 + w2 * (w15 + w17)
    w19 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w20 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w21 = c14 + (rod_q1 * w19 + rod_q2 * w20)
    w22 = w21 + w16 * w17
    w23 = w3 * c13 - w9 * w12
    w24 = w3 * w9 + w12 * c13
    w25 = w3 * w4
    w26 = w25 * slider_mass
    w27 = w4 * w12 / w7
    w28 = c21 + w16 * w26
    w29 = w28 + w22 * w27
    w30 = w1 * w23 + w2 * (w24 + w26) + (w18 * w27 - w8 * w29)
    w31 = w3 * w10
    w32 = w3 * w5
    w33 = w32 * slider_mass
    w34 = w10 * w12
    w35 = w5 * w12 / w7
    w36 = c22 + w16 * w33
    w37 = w36 + w22 * w35
    w38 = w2 * (w31 + w33) - w1 * w34 + (w18 * w35 - w8 * w37)
    w39 = w25 * w33 + (w27 * w37 + w28 * w35)
    w40 = rod_theta_dot**2
    w41 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w42 = 2 * rod_theta_dot
    w43 = w9 * rod_q1_dot + w10 * rod_q2_dot
    w44 = rod_q1_dot * c13
    w45 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w46 = w4 * rod_q1_dot + w5 * rod_q2_dot
    w47 = crank_theta_dot**2
    w48 = w2 * w47
    w49 = (w12 * w45 + w42 * (w3 * w46) + w16 * w40 + w48) / w7
    w50 = w0 * c24 + ca.if_else(t < 0.15, motor_torque, 0) + w1 * (w15 * w40 + w12 * w41 + w42 * (w3 * w43 + w12 * w44) + c26 - (w14 * w49 - w48 * c3))
    w51 = w1 * w47
    w52 = (w42 * (w12 * w46) - (w3 * w45 + w7 * w40) - w51 - w16 * w49) * slider_mass
    w53 = rod_theta_dot * -2.0 * (w19 * rod_q1_dot + w20 * rod_q2_dot) + w14 * gravity_y - (w15 * w51 - w14 * w48 + w21 * w49)
    w54 = w53 + w16 * w52
    w55 = w50 - w2 * (w14 * w40 + w42 * (w3 * w44 - w12 * w43) + w3 * w41 + (w51 * c3 + w15 * w49) - w52) - w8 * w54
    w56 = w19 * w40 - rod_q1 * c27 + (w23 * gravity_y - rod_q1_dot * c28) - (w24 * w51 - w23 * w48 + w49 * c21)
    w57 = w20 * w40 - rod_q2 * c29 - (rod_q2_dot * c30 + w34 * gravity_y) - (w31 * w51 + w34 * w48 + w49 * c22)
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(c0 + w1 * (w1 * c3) + w2 * (w2 * c5) - (w8 * (w18 - w8 * w22) + w8 * w18), w30, w38),  # crank.theta
        ca.horzcat(w30, c15 + w25 * w26 + (w27 * w29 + w27 * w28), w39),  # rod.q1
        ca.horzcat(w38, w39, c18 + w32 * w33 + (w35 * w37 + w35 * w36)),  # rod.q2
    )
    Q_hat = ca.vertcat(w55, w56 + w25 * w52 + w27 * w54, w57 + w32 * w52 + w35 * w54)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, t, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    23 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_tip_x = c[1]
    rod_length = c[2]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = rod_length - (rod_q1 * (rod_q1 * c6) + rod_q2 * (rod_q2 * c7)) * 0.5
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

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    37 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    crank_tip_x = c[1]
    rod_length = c[2]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (9)
    w0 = ca.sin(crank_theta) * crank_tip_x * crank_theta_dot
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(rod_theta)
    w3 = rod_q1 * c6
    w4 = ca.cos(rod_theta)
    w5 = rod_q2 * c7
    w6 = rod_length - (rod_q1 * w3 + rod_q2 * w5) * 0.5
    w7 = w4 * w6
    w8 = w2 * w3 / w7 * rod_q1_dot - crank_theta_dot * (w1 / w7) + w2 * w5 / w7 * rod_q2_dot
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[2] = -w0  # rod.x
    q_d_dot[3] = crank_theta_dot * w1  # rod.y
    q_d_dot[4] = w8  # rod.theta
    q_d_dot[5] = -(w0 + w8 * (w2 * w6) + rod_q1_dot * (w3 * w4) + rod_q2_dot * (w4 * w5))  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    67 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    crank_tip_x = c[1]
    rod_length = c[2]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (19)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w0 * w2
    w5 = ca.sin(rod_theta)
    w6 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w7 = 2 * rod_theta_dot
    w8 = ca.cos(rod_theta)
    w9 = rod_q1 * c6
    w10 = rod_q2 * c7
    w11 = rod_q1_dot * w9 + rod_q2_dot * w10
    w12 = rod_theta_dot**2
    w13 = rod_length - (rod_q1 * w9 + rod_q2 * w10) * 0.5
    w14 = w5 * w13
    w15 = w8 * w13
    w16 = (w4 + (w5 * w6 + w7 * (w8 * w11) + w12 * w14)) / w15 - crank_theta_ddot * (w1 / w15) + w5 * w9 / w15 * rod_q1_ddot
    w17 = w16 + w5 * w10 / w15 * rod_q2_ddot
    w18 = w7 * (w5 * w11) - (w6 * w8 + w12 * w15) - w3 - w14 * w17 - rod_q1_ddot * (w8 * w9) - rod_q2_ddot * (w8 * w10)
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[2] = -w3  # rod.x
    q_d_ddot[3] = w1 * crank_theta_ddot - w4  # rod.y
    q_d_ddot[4] = w17  # rod.theta
    q_d_ddot[5] = w18  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 11) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    57 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    c = ca.SX.sym("c", 45)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    slider_x = q[8]
    slider_y = q[9]
    slider_theta = q[10]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    crank_tip_x = c[1]
    rod_length = c[2]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (14)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_q1 * c6
    w4 = rod_q2 * c7
    w5 = rod_length - (rod_q1 * w3 + rod_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = ca.sin(rod_theta)
    w8 = w5 * w7
    w9 = crank_theta_dot**2
    w10 = 2 * rod_theta_dot
    w11 = w3 * rod_q1_dot + w4 * rod_q2_dot
    w12 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w13 = rod_theta_dot**2
    # outputs
    C = ca.vertcat(
        crank_x,  # A.x
        crank_y,  # A.y
        rod_x - (crank_x + w0),  # B.x
        rod_y - (crank_y + w1),  # B.y
        slider_y,  # slide.normal
        slider_theta,  # slide.angle
        slider_x - (rod_x + w6),  # C.x
        slider_y - (rod_y + w8),  # C.y
    )
    C_q = ca.SX(8, 11)
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
    C_q[4, 9] = 1.0
    # slide.angle
    C_q[5, 10] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w8
    C_q[6, 6] = w2 * w3
    C_q[6, 7] = w2 * w4
    C_q[6, 8] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w6
    C_q[7, 6] = w3 * w7
    C_q[7, 7] = w4 * w7
    C_q[7, 9] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[2] = -(w0 * w9)  # B.x
    gamma[3] = -(w1 * w9)  # B.y
    gamma[6] = w10 * (w7 * w11) - (w2 * w12 + w6 * w13)  # C.x
    gamma[7] = -(w7 * w12 + w10 * (w2 * w11) + w8 * w13)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 11 x 11) [SI]: mass matrix in all coordinates
    gives K (n x n = 11 x 11) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 11) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 11) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 11) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 11) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    154 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 45)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
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
    gravity_y = c[23]
    motor_torque = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    crank_mass = c[31]
    c32 = c[32]
    slider_inertia = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    # intermediate terms (47)
    w0 = ca.sin(crank_theta)
    w1 = w0 * c32
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c32
    w5 = ca.sin(rod_theta)
    w6 = rod_q1 * c9 + rod_q2 * c10
    w7 = rod_q1 * c11 + rod_q2 * c12
    w8 = c8 - (rod_q1 * w6 + rod_q2 * w7) * 0.5
    w9 = ca.cos(rod_theta)
    w10 = rod_q1 * c13
    w11 = w5 * w8 + w9 * w10
    w12 = -w11
    w13 = -(w7 * w9)
    w14 = w8 * w9 - w5 * w10
    w15 = w9 * c13 - w5 * w6
    w16 = w5 * w7
    w17 = -w16
    w18 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w19 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w20 = crank_theta_dot**2
    w21 = w4 * w20
    w22 = w1 * w20
    w23 = rod_theta_dot**2
    w24 = 2 * rod_theta_dot
    w25 = rod_q1_dot * c13
    w26 = w6 * rod_q1_dot + w7 * rod_q2_dot
    w27 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w28 = w14 * w23 + w24 * (w9 * w25 - w5 * w26) + w9 * w27
    w29 = w11 * w23 + w5 * w27 + w24 * (w9 * w26 + w5 * w25)
    w30 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot)
    w31 = w18 * w23
    w32 = w19 * w23
    w33 = w4 * gravity_y + ca.if_else(t < 0.15, motor_torque, 0)
    w34 = w14 * gravity_y
    w35 = w15 * gravity_y - rod_q1_dot * c28
    w36 = rod_q2_dot * c30 + w16 * gravity_y
    w37 = w0 * crank_tip_x
    w38 = w3 * crank_tip_x
    w39 = rod_q1 * c6
    w40 = rod_q2 * c7
    w41 = rod_length - (rod_q1 * w39 + rod_q2 * w40) * 0.5
    w42 = w5 * w41
    w43 = w9 * w41
    w44 = rod_q1_dot * w39 + rod_q2_dot * w40
    w45 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w46 = w5 * c36 - w6 * w9
    # outputs
    M = ca.SX(11, 11)
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
    M[3, 3] = c3
    M[3, 5] = w12
    M[3, 6] = w46
    M[3, 7] = w13
    # rod.y
    M[4, 4] = c3
    M[4, 5] = w14
    M[4, 6] = w15
    M[4, 7] = w17
    # rod.theta
    M[5, 3] = w12
    M[5, 4] = w14
    M[5, 5] = c14 + (rod_q1 * w18 + rod_q2 * w19)
    M[5, 6] = c21
    M[5, 7] = c22
    # rod.q1
    M[6, 3] = w46
    M[6, 4] = w15
    M[6, 5] = c21
    M[6, 6] = c15
    # rod.q2
    M[7, 3] = w13
    M[7, 4] = w17
    M[7, 5] = c22
    M[7, 7] = c18
    # slider.x
    M[8, 8] = slider_mass
    # slider.y
    M[9, 9] = slider_mass
    # slider.theta
    M[10, 10] = slider_inertia
    K = ca.SX(11, 11)
    # rod.q1
    K[6, 6] = c27
    # rod.q2
    K[7, 7] = c29
    Q_v = ca.SX(11, 1)
    Q_v[0] = w21  # crank.x
    Q_v[1] = w22  # crank.y
    Q_v[3] = w28  # rod.x
    Q_v[4] = w29  # rod.y
    Q_v[5] = w30  # rod.theta
    Q_v[6] = w31  # rod.q1
    Q_v[7] = w32  # rod.q2
    Q_F = ca.SX(11, 1)
    Q_F[1] = c34  # crank.y
    Q_F[2] = w33  # crank.theta
    Q_F[4] = c26  # rod.y
    Q_F[5] = w34  # rod.theta
    Q_F[6] = w35  # rod.q1
    Q_F[7] = -w36  # rod.q2
    Q_F[9] = c35  # slider.y
    Q_star = ca.vertcat(
        w21,  # crank.x
        w22 + c34,  # crank.y
        w33,  # crank.theta
        w28,  # rod.x
        c26 + w29,  # rod.y
        w30 + w34,  # rod.theta
        w35 + (w31 - rod_q1 * c27),  # rod.q1
        w32 - rod_q2 * c29 - w36,  # rod.q2
        0.0,  # slider.x
        c35,  # slider.y
        0.0,  # slider.theta
    )
    C_q = ca.SX(8, 11)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w37
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w38
    C_q[3, 4] = 1.0
    # slide.normal
    C_q[4, 9] = 1.0
    # slide.angle
    C_q[5, 10] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w42
    C_q[6, 6] = w9 * w39
    C_q[6, 7] = w9 * w40
    C_q[6, 8] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w43
    C_q[7, 6] = w5 * w39
    C_q[7, 7] = w5 * w40
    C_q[7, 9] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w20 * w38)  # B.x
    gamma[3] = -(w20 * w37)  # B.y
    gamma[6] = w24 * (w5 * w44) - (w9 * w45 + w23 * w43)  # C.x
    gamma[7] = -(w5 * w45 + w24 * (w9 * w44) + w23 * w42)  # C.y
    inputs, outputs = [q, q_dot, t, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes q_ddot (n = 11) [mixed]: accelerations of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    152 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    q_ddot = ca.SX.sym("q_ddot", 11)
    c = ca.SX.sym("c", 45)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    rod_q1_ddot = q_ddot[6]
    rod_q2_ddot = q_ddot[7]
    slider_x_ddot = q_ddot[8]
    slider_y_ddot = q_ddot[9]
    slider_theta_ddot = q_ddot[10]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
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
    gravity_y = c[23]
    c26 = c[26]
    crank_mass = c[31]
    c32 = c[32]
    slider_inertia = c[33]
    c34 = c[34]
    c35 = c[35]
    # intermediate terms (31)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c32
    w2 = ca.sin(crank_theta) * c32
    w3 = rod_theta_dot**2
    w4 = ca.cos(rod_theta)
    w5 = rod_q1 * c9 + rod_q2 * c10
    w6 = rod_q1 * c11 + rod_q2 * c12
    w7 = c8 - (rod_q1 * w5 + rod_q2 * w6) * 0.5
    w8 = ca.sin(rod_theta)
    w9 = rod_q1 * c13
    w10 = w4 * w7 - w8 * w9
    w11 = 2 * rod_theta_dot
    w12 = rod_q1_dot * c13
    w13 = w5 * rod_q1_dot + w6 * rod_q2_dot
    w14 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w15 = w7 * w8 + w4 * w9
    w16 = rod_x_ddot * c3 - w15 * rod_theta_ddot - (w4 * w5 + w8 * c13) * rod_q1_ddot - w4 * w6 * rod_q2_ddot
    w17 = slider_x_ddot * slider_mass
    w18 = w3 * w10 + w11 * (w4 * w12 - w8 * w13) + w4 * w14 - w16 - w17
    w19 = w0 * w1 - (crank_x_ddot * crank_mass - w2 * crank_theta_ddot) + w18
    w20 = rod_y_ddot * c3 + w10 * rod_theta_ddot + rod_q1_ddot * (w4 * c13 - w5 * w8) - rod_q2_ddot * (w6 * w8)
    w21 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w22 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w23 = w10 * rod_y_ddot - rod_x_ddot * w15 + rod_theta_ddot * (c14 + (rod_q1 * w21 + rod_q2 * w22)) + rod_q1_ddot * c21
    w24 = rod_theta_dot * -2.0 * (rod_q1_dot * w21 + rod_q2_dot * w22) + w10 * gravity_y - (w23 + rod_q2_ddot * c22)
    w25 = rod_length - (rod_q1 * (rod_q1 * c6) + rod_q2 * (rod_q2 * c7)) * 0.5
    w26 = (w24 + w17 * (w8 * w25)) / (w4 * w25)
    w27 = c26 + (w3 * w15 + w8 * w14 + w11 * (w4 * w13 + w8 * w12)) - w20 - w26
    w28 = c34 + w0 * w2 - (crank_y_ddot * crank_mass + w1 * crank_theta_ddot) + w27
    w29 = w26 + (c35 - slider_y_ddot * slider_mass)
    w30 = slider_theta_ddot * slider_inertia
    # outputs
    lam = ca.vertcat(
        w19,  # A.x
        w28,  # A.y
        w18,  # B.x
        w27,  # B.y
        w29,  # slide.normal
        -w30,  # slide.angle
        -w17,  # C.x
        -w26,  # C.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w19, -w28, 0.0),  # A
        ca.vertcat(-w18, -w27, 0.0),  # B
        ca.vertcat(0.0, -w29, w30),  # slide
        ca.vertcat(w17, w26, 0.0),  # C
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    141 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 45)
    crank_y = q[1]
    crank_theta = q[2]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    slider_y = q[9]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    slider_x_dot = q_dot[8]
    slider_y_dot = q_dot[9]
    slider_theta_dot = q_dot[10]
    c0 = c[0]
    c3 = c[3]
    slider_mass = c[4]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
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
    motor_torque = c[25]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    crank_mass = c[31]
    c32 = c[32]
    slider_inertia = c[33]
    c35 = c[35]
    c37 = c[37]
    # intermediate terms (21)
    w0 = ca.sin(crank_theta) * c32
    w1 = ca.cos(crank_theta) * c32
    w2 = crank_x_dot * (crank_x_dot * crank_mass - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * crank_mass + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta)
    w4 = rod_q1 * c9 + rod_q2 * c10
    w5 = rod_q1 * c11 + rod_q2 * c12
    w6 = c8 - (rod_q1 * w4 + rod_q2 * w5) * 0.5
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * c13
    w9 = w3 * w6 + w7 * w8
    w10 = w4 * w7 + w3 * c13
    w11 = w5 * w7
    w12 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c0) + rod_x_dot * (rod_x_dot * c3 - w9 * rod_theta_dot - w10 * rod_q1_dot - w11 * rod_q2_dot)
    w13 = w6 * w7 - w3 * w8
    w14 = w7 * c13 - w3 * w4
    w15 = w3 * w5
    w16 = rod_q1 * (rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)) + rod_q2 * (rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20))
    w17 = rod_y_dot * w13 - rod_x_dot * w9 + rod_theta_dot * (c14 + w16) + rod_q1_dot * c21 + rod_q2_dot * c22
    w18 = w12 + rod_y_dot * (rod_y_dot * c3 + rod_theta_dot * w13 + rod_q1_dot * w14 - rod_q2_dot * w15) + rod_theta_dot * w17
    w19 = w18 + rod_q1_dot * (rod_y_dot * w14 - rod_x_dot * w10 + rod_theta_dot * c21 + rod_q1_dot * c15) + rod_q2_dot * (rod_theta_dot * c22 - (rod_x_dot * w11 + rod_y_dot * w15) + rod_q2_dot * c18)
    w20 = w19 + slider_x_dot * (slider_x_dot * slider_mass) + slider_y_dot * (slider_y_dot * slider_mass) + slider_theta_dot * (slider_theta_dot * slider_inertia)
    # outputs
    kinetic = ca.vertcat(w20 / 2.0)
    elastic = ca.vertcat((rod_q1 * (rod_q1 * c27) + rod_q2 * (rod_q2 * c29)) / 2.0)
    potential = ca.vertcat((w0 + crank_y * crank_mass + (w9 + rod_y * c3)) * c37 - slider_y * c35)
    power_dissipated = ca.vertcat(rod_q1_dot * (rod_q1_dot * c28) + rod_q2_dot * (rod_q2_dot * c30))
    power_applied = ca.vertcat(ca.if_else(t < 0.15, crank_theta_dot * motor_torque, 0))
    inputs, outputs = [q, q_dot, t, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes t (1) [s]: time
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3) [N, N m]: world force and moment of a load on its marker, or b
    2 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 45)
    motor_torque = c[25]
    # outputs
    load_actions = ca.vertcat(0.0, 0.0, ca.if_else(t < 0.15, motor_torque, 0))
    inputs, outputs = [t, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["t", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    9 operations.
    """
    q = ca.SX.sym("q", 11)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[8]
    slider_y = q[9]
    slider_theta = q[10]
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


def switching() -> ca.Function:
    """Where in time loads and prescribed motions jump or kink: where one of these changes its sign.

    takes t (1) [s]: time
    gives switching (conditions in t = 1) [SI]: zero where a load or a prescribed motion jumps or kinks
    1 operations.
    """
    t = ca.SX.sym("t", 1)
    # outputs
    switching = ca.vertcat(t - 0.15)
    inputs, outputs = [t], [ca.densify(switching)]
    return ca.Function("switching", inputs, outputs, ["t"], ["switching"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    556 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
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
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    gravity_y = c[23]
    c24 = c[24]
    c26 = c[26]
    c27 = c[27]
    c29 = c[29]
    c38 = c[38]
    c39 = c[39]
    # intermediate terms (134)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * c3
    w4 = ca.sin(crank_theta)
    w5 = rod_theta_dot**2
    w6 = ca.cos(rod_theta)
    w7 = rod_q1 * c9
    w8 = w7 + rod_q2 * c10
    w9 = rod_q2 * c12
    w10 = rod_q1 * c11 + w9
    w11 = c8 - (rod_q1 * w8 + rod_q2 * w10) * 0.5
    w12 = ca.sin(rod_theta)
    w13 = rod_q1 * c13
    w14 = w6 * w11 - w12 * w13
    w15 = w5 * w14
    w16 = 2 * rod_theta_dot
    w17 = rod_q1_dot * c13
    w18 = w8 * rod_q1_dot + w10 * rod_q2_dot
    w19 = w6 * w17 - w12 * w18
    w20 = w16 * w19
    w21 = rod_q1_dot * c9
    w22 = rod_q2_dot * c12
    w23 = rod_q1_dot * (w21 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + w22)
    w24 = w6 * w23
    w25 = w11 * w12 + w6 * w13
    w26 = rod_q1_dot * c6
    w27 = rod_q2_dot * c7
    w28 = rod_q1_dot * w26 + rod_q2_dot * w27
    w29 = w12 * w28
    w30 = rod_q1 * c6
    w31 = rod_q2 * c7
    w32 = rod_q1_dot * w30 + rod_q2_dot * w31
    w33 = w6 * w32
    w34 = w16 * w33
    w35 = rod_length - (rod_q1 * w30 + rod_q2 * w31) * 0.5
    w36 = w12 * w35
    w37 = w5 * w36
    w38 = w4 * crank_tip_x
    w39 = w1 * w38
    w40 = w29 + w34 + w37 + w39
    w41 = w6 * w35
    w42 = w40 / w41
    w43 = w25 * w42
    w44 = w12 * w32
    w45 = w16 * w44
    w46 = w6 * w28
    w47 = w5 * w41
    w48 = w36 * w42
    w49 = (w45 - (w46 + w47) - w2 - w48) * slider_mass
    w50 = w5 * w25
    w51 = w12 * w23
    w52 = w6 * w18 + w12 * w17
    w53 = w16 * w52
    w54 = w14 * w42
    w55 = rod_theta_dot * -2.0
    w56 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w57 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w58 = rod_q1_dot * w56 + rod_q2_dot * w57
    w59 = c14 + (rod_q1 * w56 + rod_q2 * w57)
    w60 = (w55 * w58 + w14 * gravity_y - (w2 * w25 - w14 * w39 + w42 * w59) + w36 * w49) / w41
    w61 = w4 * c24 + w0 * (w15 + w20 + w24 + (w3 + w43) - w49) + w38 * (c26 + (w50 + w51 + w53) - (w54 - w39 * c3) - w60)
    w62 = w36 * slider_mass
    w63 = w25 + w62
    w64 = w0 * w14 + w38 * w63
    w65 = 2 * w33 + w16 * w36
    w66 = w6 * w30
    w67 = w6 * w31
    w68 = rod_q1_dot * w66 + rod_theta_dot * w36 + rod_q2_dot * w67
    w69 = w0 / w41
    w70 = (crank_theta_dot * w38 - w68 * w69) / w41
    w71 = w48 + (w47 + (w46 - w45))
    w72 = (w2 + w65 * w70 - w69 * w71) / w41
    w73 = (2 * w44 - w16 * w41) * slider_mass
    w74 = w0 * (w16 * w25 + 2 * w52) - w38 * (w14 * w16 + 2 * w19 - w73)
    w75 = (w40 - (w34 + (w29 + w37))) * slider_mass
    w76 = w0 * (w43 + (w20 + (w15 + w24))) - w38 * (w54 - (w51 + (w50 + w53)) + w75)
    w77 = w2 * w14
    w78 = w59 + w36 * w62
    w79 = w58 * -2.0 + w36 * w73
    w80 = w36 * w60 - (w77 + w25 * w39 + w25 * gravity_y) + w41 * w49 - w36 * w75
    w81 = w77 + w39 * w63 - w72 * w78 + w70 * w79 - w69 * w80
    w82 = w6 * c13
    w83 = w2 * (w82 - w8 * w12)
    w84 = w12 * c13
    w85 = w6 * w8 + w84
    w86 = w66 * slider_mass
    w87 = c21 + w36 * w86
    w88 = w16 * w56 + w66 * w73
    w89 = w60 * w66
    w90 = w12 * w30
    w91 = w49 * w90
    w92 = w89 - (w83 + w39 * w85 + w85 * gravity_y) - w91 - w66 * w75
    w93 = w90 / w41
    w94 = w6 * w10
    w95 = w67 * slider_mass
    w96 = w2 * (w10 * w12)
    w97 = c22 + w36 * w95
    w98 = w16 * w57 + w67 * w73
    w99 = w60 * w67
    w100 = w12 * w31
    w101 = w49 * w100
    w102 = w96 - w39 * w94 - w94 * gravity_y + w99 - w101 - w67 * w75
    w103 = w100 / w41
    w104 = (w7 + w8 + rod_q2 * c11) * 0.5
    w105 = w82 - w12 * w104
    w106 = w21 + rod_q2_dot * c11
    w107 = w84 + w6 * w104
    w108 = (w42 * w90 + (w16 * (w12 * w26) + w5 * w66)) * slider_mass
    w109 = w0 * (w5 * w105 + w16 * (w6 * w106) + w42 * w107) - w38 * (w42 * w105 - (w5 * w107 + w16 * (w12 * w106)) - w108)
    w110 = w12 * c6
    w111 = (rod_q1_dot * w110 + rod_theta_dot * w66 + w68 * w93) / w41
    w112 = (w42 * w66 + (w16 * (w6 * w26) - w5 * w90) + w65 * w111 + w71 * w93) / w41
    w113 = w55 * (rod_q1_dot * c38 - rod_q2_dot * c19) - w107 * gravity_y - (w42 * (w56 + rod_q1 * c38 - rod_q2 * c19) + (w39 * w107 + w2 * w105))
    w114 = w89 + w113 - w91 + w36 * w108 - w78 * w112 + w79 * w111 + w80 * w93
    w115 = w12 * c9
    w116 = w5 * c38 - c27 - w115 * gravity_y - (w39 * w115 + w2 * (w6 * c9)) + w60 * w110 + w49 * (w6 * c6) + w66 * w108
    w117 = w12 * c11
    w118 = w67 * w108 - (w2 * (w6 * c11) + w39 * w117 + (w5 * c19 + w117 * gravity_y)) - w97 * w112 + w98 * w111
    w119 = w22 + rod_q1_dot * c10
    w120 = (rod_q1 * c10 + (w9 + w10)) * 0.5
    w121 = w12 * w120
    w122 = w6 * w120
    w123 = (w42 * w100 + (w16 * (w12 * w27) + w5 * w67)) * slider_mass
    w124 = w0 * (w16 * (w6 * w119) - w5 * w121 + w42 * w122) + w38 * (w5 * w122 + w16 * (w12 * w119) + w42 * w121 + w123)
    w125 = w12 * c7
    w126 = (rod_theta_dot * w67 + rod_q2_dot * w125 + w68 * w103) / w41
    w127 = (w42 * w67 + (w16 * (w6 * w27) - w5 * w100) + w65 * w126 + w71 * w103) / w41
    w128 = w55 * (rod_q2_dot * c39 - rod_q1_dot * c17) - w122 * gravity_y - (w39 * w122 - w2 * w121 + w42 * (w57 + rod_q2 * c39 - rod_q1 * c17))
    w129 = w99 + w128 - w101 + w36 * w123 - w78 * w127 + w79 * w126 + w80 * w103
    w130 = w12 * c10
    w131 = w66 * w123 - (w39 * w130 + w2 * (w6 * c10) + (w5 * c17 + w130 * gravity_y)) - w87 * w127 + w88 * w126
    w132 = w12 * c12
    w133 = w5 * c39 - c29 - w132 * gravity_y - (w2 * (w6 * c12) + w39 * w132) + w60 * w125 + w49 * (w6 * c7)
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * w3 - w61 + w38 * (w39 * c5) - w64 * w72 + w70 * w74 - w69 * w76 - w69 * w81,
            w109 - w64 * w112 + w74 * w111 + w76 * w93 - w69 * w114,
            w124 - w64 * w127 + w74 * w126 + w76 * w103 - w69 * w129,
        ),
        ca.horzcat(  # rod.q1
            w83 + w39 * (w85 + w86) - w72 * w87 + w70 * w88 - w69 * w92 + w81 * w93,
            w116 - w87 * w112 + w88 * w111 + w92 * w93 + w93 * w114, w131 + w92 * w103 + w93 * w129,
        ),
        ca.horzcat(  # rod.q2
            w39 * (w94 + w95) - w96 - w72 * w97 + w70 * w98 - w69 * w102 + w81 * w103,
            w118 + w93 * w102 + w103 * w114,
            w133 + w67 * w123 - w97 * w127 + w98 * w126 + w102 * w103 + w103 * w129,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    276 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
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
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c28 = c[28]
    c30 = c[30]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (61)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = 2 * crank_theta_dot
    w3 = w1 * w2
    w4 = w0 * w2
    w5 = ca.cos(rod_theta)
    w6 = rod_q1 * c9 + rod_q2 * c10
    w7 = rod_q1 * c11 + rod_q2 * c12
    w8 = c8 - (rod_q1 * w6 + rod_q2 * w7) * 0.5
    w9 = ca.sin(rod_theta)
    w10 = rod_q1 * c13
    w11 = w5 * w8 - w9 * w10
    w12 = w8 * w9 + w5 * w10
    w13 = rod_q1 * c6
    w14 = rod_q2 * c7
    w15 = rod_length - (rod_q1 * w13 + rod_q2 * w14) * 0.5
    w16 = w9 * w15
    w17 = w16 * slider_mass
    w18 = w12 + w17
    w19 = w0 * w11 + w1 * w18
    w20 = w5 * w13
    w21 = w5 * w14
    w22 = rod_q1_dot * w20 + w16 * rod_theta_dot + rod_q2_dot * w21
    w23 = w5 * w15
    w24 = w0 / w23
    w25 = 2 * ((w1 * crank_theta_dot - w22 * w24) / w23)
    w26 = 2 * rod_theta_dot
    w27 = w6 * rod_q1_dot + w7 * rod_q2_dot
    w28 = rod_q1_dot * c13
    w29 = (2 * (w9 * (w13 * rod_q1_dot + w14 * rod_q2_dot)) - w23 * w26) * slider_mass
    w30 = w0 * (w12 * w26 + 2 * (w5 * w27 + w9 * w28)) - w1 * (w11 * w26 + 2 * (w5 * w28 - w9 * w27) - w29)
    w31 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w32 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w33 = c14 + (rod_q1 * w31 + rod_q2 * w32) + w16 * w17
    w34 = (rod_q1_dot * w31 + rod_q2_dot * w32) * -2.0 + w16 * w29
    w35 = w3 * w11 - w4 * w18 - w25 * w33 - w24 * w34
    w36 = w5 * c13 - w6 * w9
    w37 = w5 * w6 + w9 * c13
    w38 = w20 * slider_mass
    w39 = c21 + w16 * w38
    w40 = w26 * w31 + w20 * w29
    w41 = w9 * w13
    w42 = w41 / w23
    w43 = w9 * w14
    w44 = w43 / w23
    w45 = w7 * w9
    w46 = w5 * w7
    w47 = w21 * slider_mass
    w48 = c22 + w16 * w47
    w49 = w26 * w32 + w21 * w29
    w50 = rod_q1_dot * c42 + rod_q2_dot * c43
    w51 = (w26 * w41 - w5 * (rod_q1_dot * c40)) * slider_mass
    w52 = 2 * ((rod_q1_dot * (w9 * c6) + w20 * rod_theta_dot + w22 * w42) / w23)
    w53 = rod_theta_dot * -2.0
    w54 = w31 * w53 + w16 * w51 - w33 * w52 + w34 * w42
    w55 = w0 * (w9 * w50 + w26 * w37) - w1 * (w26 * w36 + w5 * w50 - w51) - w19 * w52 + w30 * w42 - w24 * w54
    w56 = rod_q2_dot * c44 + rod_q1_dot * c43
    w57 = (w26 * w43 - w5 * (rod_q2_dot * c41)) * slider_mass
    w58 = 2 * ((rod_theta_dot * w21 + rod_q2_dot * (w9 * c7) + w22 * w44) / w23)
    w59 = w32 * w53 + w16 * w57 - w33 * w58 + w34 * w44
    w60 = w0 * (w9 * w56 + w26 * w46) - w1 * (w5 * w56 - w26 * w45 - w57) - w19 * w58 + w30 * w44 - w24 * w59
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(w0 * (w3 * c3) - w1 * (w4 * c5) - w19 * w25 - w24 * w30 - w24 * w35, w55, w60),  # crank.theta
        ca.horzcat(  # rod.q1
            w3 * w36 - w4 * (w37 + w38) - w25 * w39 - w24 * w40 + w35 * w42,
            w20 * w51 - c28 - w39 * w52 + w40 * w42 + w42 * w54, w20 * w57 - w39 * w58 + w40 * w44 + w42 * w59,
        ),
        ca.horzcat(  # rod.q2
            w35 * w44 - (w3 * w45 + w4 * (w46 + w47) + w25 * w48 + w24 * w49),
            w21 * w51 - w48 * w52 + w42 * w49 + w44 * w54, w21 * w57 - c30 - w48 * w58 + w44 * w49 + w44 * w59,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 3 x 3) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    749 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
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
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    gravity_y = c[23]
    c24 = c[24]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c38 = c[38]
    c39 = c[39]
    # intermediate terms (172)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta)
    w2 = w1 * crank_tip_x
    w3 = crank_theta_dot**2
    w4 = crank_theta_ddot * w2 + w0 * w3
    w5 = w4 * c3
    w6 = rod_theta_dot**2
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * c9
    w9 = w8 + rod_q2 * c10
    w10 = rod_q2 * c12
    w11 = rod_q1 * c11 + w10
    w12 = c8 - (rod_q1 * w9 + rod_q2 * w11) * 0.5
    w13 = ca.sin(rod_theta)
    w14 = rod_q1 * c13
    w15 = w7 * w12 - w13 * w14
    w16 = w6 * w15
    w17 = 2 * rod_theta_dot
    w18 = rod_q1_dot * c13
    w19 = w9 * rod_q1_dot + w11 * rod_q2_dot
    w20 = w7 * w18 - w13 * w19
    w21 = w17 * w20
    w22 = rod_q1_dot * c9
    w23 = w22 + rod_q2_dot * c10
    w24 = rod_q2_dot * c12
    w25 = rod_q1_dot * c11 + w24
    w26 = rod_q1_dot * w23 + rod_q2_dot * w25
    w27 = w7 * w26
    w28 = w12 * w13 + w7 * w14
    w29 = rod_q1_dot * c6
    w30 = rod_q2_dot * c7
    w31 = rod_q1_dot * w29 + rod_q2_dot * w30
    w32 = w13 * w31
    w33 = rod_q1 * c6
    w34 = rod_q2 * c7
    w35 = rod_q1_dot * w33 + rod_q2_dot * w34
    w36 = w7 * w35
    w37 = w17 * w36
    w38 = rod_length - (rod_q1 * w33 + rod_q2 * w34) * 0.5
    w39 = w13 * w38
    w40 = w6 * w39
    w41 = w2 * w3
    w42 = w7 * w38
    w43 = w0 / w42
    w44 = w13 * w33
    w45 = w44 / w42
    w46 = w13 * w34
    w47 = w46 / w42
    w48 = (w32 + w37 + w40 + w41) / w42 - crank_theta_ddot * w43 + w45 * rod_q1_ddot + w47 * rod_q2_ddot
    w49 = w28 * w48
    w50 = w13 * c13
    w51 = w7 * w9 + w50
    w52 = rod_q1_ddot * w51
    w53 = w7 * w11
    w54 = rod_q2_ddot * w53
    w55 = w13 * w35
    w56 = w17 * w55
    w57 = w7 * w31
    w58 = w6 * w42
    w59 = w39 * w48
    w60 = w7 * w33
    w61 = rod_q1_ddot * w60
    w62 = w7 * w34
    w63 = rod_q2_ddot * w62
    w64 = (w56 - (w57 + w58) - w4 - w59 - w61 - w63) * slider_mass
    w65 = w6 * w28
    w66 = w13 * w26
    w67 = w7 * w19 + w13 * w18
    w68 = w17 * w67
    w69 = w0 * crank_theta_ddot - w41
    w70 = w15 * w48
    w71 = w7 * c13
    w72 = w71 - w9 * w13
    w73 = rod_q1_ddot * w72
    w74 = w11 * w13
    w75 = rod_q2_ddot * w74
    w76 = rod_theta_dot * -2.0
    w77 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w78 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w79 = rod_q1_dot * w77 + rod_q2_dot * w78
    w80 = c14 + (rod_q1 * w77 + rod_q2 * w78)
    w81 = w76 * w79 + w15 * gravity_y - (w15 * w69 + w4 * w28 + w48 * w80 + rod_q1_ddot * c21 + rod_q2_ddot * c22)
    w82 = (w81 + w39 * w64) / w42
    w83 = w1 * c24 + w0 * (w16 + w21 + w27 + (w5 + w49 + w52 + w54) - w64) + w2 * (c26 + (w65 + w66 + w68) - (w69 * c3 + w70 + w73 - w75) - w82)
    w84 = w39 * slider_mass
    w85 = w28 + w84
    w86 = w0 * w15 + w2 * w85
    w87 = 2 * w36 + w17 * w39
    w88 = rod_q1_dot * w60 + rod_theta_dot * w39 + rod_q2_dot * w62
    w89 = (w2 * crank_theta_dot - w43 * w88) / w42
    w90 = w63 + (w59 + w61) + (w58 + (w57 - w56))
    w91 = (w4 + w87 * w89 - w43 * w90) / w42
    w92 = (2 * w55 - w17 * w42) * slider_mass
    w93 = w0 * (w17 * w28 + 2 * w67) - w2 * (w15 * w17 + 2 * w20 - w92)
    w94 = (w42 * w48 - w44 * rod_q1_ddot - w46 * rod_q2_ddot - (w37 + (w32 + w40))) * slider_mass
    w95 = w0 * (w21 + (w16 + w27) + (w54 + (w49 + w52))) - w2 * (w94 - (w66 + (w65 + w68) + (w75 - (w70 + w73))))
    w96 = w4 * w15
    w97 = w80 + w39 * w84
    w98 = w79 * -2.0 + w39 * w92
    w99 = w28 * w69 - w96 - w28 * gravity_y + w39 * w82 + w42 * w64 - w39 * w94
    w100 = w96 - w69 * w85 - w91 * w97 + w89 * w98 - w43 * w99
    w101 = w4 * w72
    w102 = w60 * slider_mass
    w103 = w51 + w102
    w104 = c21 + w39 * w102
    w105 = w17 * w77 + w60 * w92
    w106 = w60 * w82
    w107 = w44 * w64
    w108 = w51 * w69 - w101 - w51 * gravity_y + w106 - w107 - w60 * w94
    w109 = w17 * w78 + w62 * w92
    w110 = w4 * w74
    w111 = w62 * slider_mass
    w112 = w53 + w111
    w113 = c22 + w39 * w111
    w114 = w62 * w82
    w115 = w46 * w64
    w116 = w110 + w53 * w69 - w53 * gravity_y + w114 - w115 - w62 * w94
    w117 = (w8 + w9 + rod_q2 * c11) * 0.5
    w118 = w71 - w13 * w117
    w119 = rod_q2_dot * c11
    w120 = w22 + w119
    w121 = w50 + w7 * w117
    w122 = w13 * c9
    w123 = w13 * c11
    w124 = w7 * c9
    w125 = w7 * c11
    w126 = w7 * c6
    w127 = (rod_q1_ddot * w126 - w44 * w48 - (w17 * (w13 * w29) + w6 * w60)) * slider_mass
    w128 = w2 * (w48 * w118 + rod_q1_ddot * w124 + rod_q2_ddot * w125 - (w6 * w121 + w17 * (w13 * w120)) + w127)
    w129 = w0 * (w6 * w118 + w17 * (w7 * w120) + (w48 * w121 + rod_q1_ddot * w122 + rod_q2_ddot * w123)) - w128
    w130 = w13 * c6
    w131 = (rod_q1_dot * w130 + rod_theta_dot * w60 + w45 * w88) / w42
    w132 = (rod_q1_ddot * w130 + w48 * w60 + (w17 * (w7 * w29) - w6 * w44) + w87 * w131 + w45 * w90) / w42
    w133 = w76 * (rod_q1_dot * c38 - rod_q2_dot * c19) - w121 * gravity_y - (w48 * (w77 + rod_q1 * c38 - rod_q2 * c19) - (w69 * w121 - w4 * w118))
    w134 = w106 + w133 - w107 - w39 * w127 - w97 * w132 + w98 * w131 + w45 * w99
    w135 = w6 * c38 - c27 - w122 * gravity_y + (w69 * w122 - w4 * w124) + w82 * w130 + w64 * w126 - w60 * w127
    w136 = w69 * w123 - w4 * w125 - (w6 * c19 + w123 * gravity_y) - w62 * w127 - w113 * w132 + w109 * w131 + w45 * w116
    w137 = rod_q1_dot * c10
    w138 = w24 + w137
    w139 = (rod_q1 * c10 + (w10 + w11)) * 0.5
    w140 = w13 * w139
    w141 = w7 * w139
    w142 = w13 * c10
    w143 = w13 * c12
    w144 = w7 * c7
    w145 = (rod_q2_ddot * w144 - w46 * w48 - (w17 * (w13 * w30) + w6 * w62)) * slider_mass
    w146 = w7 * c10
    w147 = w7 * c12
    w148 = w2 * (w145 - (w6 * w141 + w17 * (w13 * w138) + (w48 * w140 - rod_q1_ddot * w146 - rod_q2_ddot * w147)))
    w149 = w0 * (w17 * (w7 * w138) - w6 * w140 + (w48 * w141 + rod_q1_ddot * w142 + rod_q2_ddot * w143)) - w148
    w150 = w13 * c7
    w151 = (rod_theta_dot * w62 + rod_q2_dot * w150 + w47 * w88) / w42
    w152 = (w48 * w62 + rod_q2_ddot * w150 + (w17 * (w7 * w30) - w6 * w46) + w87 * w151 + w47 * w90) / w42
    w153 = w76 * (rod_q2_dot * c39 - rod_q1_dot * c17) - w141 * gravity_y - (w48 * (w78 + rod_q2 * c39 - rod_q1 * c17) - (w4 * w140 + w69 * w141))
    w154 = w114 + w153 - w115 - w39 * w145 - w97 * w152 + w98 * w151 + w47 * w99
    w155 = w69 * w142 - w4 * w146 - (w6 * c17 + w142 * gravity_y) - w60 * w145 - w104 * w152 + w105 * w151 + w47 * w108
    w156 = w6 * c39 - c29 - w143 * gravity_y + (w69 * w143 - w4 * w147) + w82 * w150 + w64 * w144 - w62 * w145
    w157 = 2 * crank_theta_dot
    w158 = w2 * w157
    w159 = w0 * w157
    w160 = 2 * w89
    w161 = w15 * w158 - w85 * w159 - w97 * w160 - w43 * w98
    w162 = w119 + (w22 + w23)
    w163 = (w17 * w44 - w7 * (2 * w29)) * slider_mass
    w164 = 2 * w131
    w165 = w76 * w77 + w39 * w163 - w97 * w164 + w45 * w98
    w166 = w0 * (w13 * w162 + w17 * w51) - w2 * (w17 * w72 + w7 * w162 - w163) - w86 * w164 + w45 * w93 - w43 * w165
    w167 = w137 + (w24 + w25)
    w168 = (w17 * w46 - w7 * (2 * w30)) * slider_mass
    w169 = 2 * w151
    w170 = w76 * w78 + w39 * w168 - w97 * w169 + w47 * w98
    w171 = w0 * (w13 * w167 + w17 * w53) - w2 * (w7 * w167 - w17 * w74 - w168) - w86 * w169 + w47 * w93 - w43 * w170
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * w5 - w83 - w2 * (w69 * c5) - w86 * w91 + w89 * w93 - w43 * w95 - w43 * w100,
            w129 - w86 * w132 + w93 * w131 + w45 * w95 - w43 * w134,
            w149 - w86 * w152 + w93 * w151 + w47 * w95 - w43 * w154,
        ),
        ca.horzcat(  # rod.q1
            w101 - w69 * w103 - w91 * w104 + w89 * w105 - w43 * w108 + w45 * w100,
            w135 - w104 * w132 + w105 * w131 + w45 * w108 + w45 * w134, w155 + w45 * w154,
        ),
        ca.horzcat(  # rod.q2
            w89 * w109 - (w110 + w69 * w112 + w91 * w113) - w43 * w116 + w47 * w100, w136 + w47 * w134,
            w156 - w113 * w152 + w109 * w151 + w47 * w116 + w47 * w154,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w158 * c3) - w2 * (w159 * c5) - w86 * w160 - w43 * w93 - w43 * w161, w166, w171,
        ),
        ca.horzcat(  # rod.q1
            w72 * w158 - w103 * w159 - w104 * w160 - w43 * w105 + w45 * w161,
            w60 * w163 - c28 - w104 * w164 + w45 * w105 + w45 * w165,
            w60 * w168 - w104 * w169 + w47 * w105 + w45 * w170,
        ),
        ca.horzcat(  # rod.q2
            w47 * w161 - (w74 * w158 + w112 * w159 + w113 * w160 + w43 * w109),
            w62 * w163 - w113 * w164 + w45 * w109 + w47 * w165,
            w62 * w168 - c30 - w113 * w169 + w47 * w109 + w47 * w170,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 3 x 2) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 2 x 2) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 2 x 2) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 45)
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    # outputs
    B = ca.SX(3, 2)
    # rod.q1
    B[1, 0] = 1.0
    # rod.q2
    B[2, 1] = 1.0
    K_s = ca.SX(2, 2)
    K_s[0, 0] = c27
    K_s[1, 1] = c29
    D_s = ca.SX(2, 2)
    D_s[0, 0] = c28
    D_s[1, 1] = c30
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 2) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 2) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 2) [N, N m]: part of Q_hat of S
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_length = c[2]
    c3 = c[3]
    slider_mass = c[4]
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
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    gravity_y = c[23]
    c24 = c[24]
    motor_torque = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    # intermediate terms (58)
    w0 = ca.cos(crank_theta)
    w1 = w0 * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = ca.cos(rod_theta)
    w4 = rod_q1 * c6
    w5 = rod_q2 * c7
    w6 = rod_length - (rod_q1 * w4 + rod_q2 * w5) * 0.5
    w7 = w3 * w6
    w8 = w1 / w7
    w9 = rod_q1 * c9 + rod_q2 * c10
    w10 = rod_q1 * c11 + rod_q2 * c12
    w11 = c8 - (rod_q1 * w9 + rod_q2 * w10) * 0.5
    w12 = ca.sin(rod_theta)
    w13 = rod_q1 * c13
    w14 = w3 * w11 - w12 * w13
    w15 = w11 * w12 + w3 * w13
    w16 = w6 * w12
    w17 = w16 * slider_mass
    w18 = w1 * w14 + w2 * (w15 + w17)
    w19 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w20 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w21 = c14 + (rod_q1 * w19 + rod_q2 * w20)
    w22 = w21 + w16 * w17
    w23 = w3 * c13 - w9 * w12
    w24 = w3 * w9 + w12 * c13
    w25 = w3 * w4
    w26 = w25 * slider_mass
    w27 = w4 * w12 / w7
    w28 = c21 + w16 * w26
    w29 = w28 + w22 * w27
    w30 = w1 * w23 + w2 * (w24 + w26) + (w18 * w27 - w8 * w29)
    w31 = w3 * w10
    w32 = w3 * w5
    w33 = w32 * slider_mass
    w34 = w10 * w12
    w35 = w5 * w12 / w7
    w36 = c22 + w16 * w33
    w37 = w36 + w22 * w35
    w38 = w2 * (w31 + w33) - w1 * w34 + (w18 * w35 - w8 * w37)
    w39 = w25 * w33 + (w27 * w37 + w28 * w35)
    w40 = rod_theta_dot**2
    w41 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w42 = 2 * rod_theta_dot
    w43 = w9 * rod_q1_dot + w10 * rod_q2_dot
    w44 = rod_q1_dot * c13
    w45 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w46 = w4 * rod_q1_dot + w5 * rod_q2_dot
    w47 = crank_theta_dot**2
    w48 = w2 * w47
    w49 = (w12 * w45 + w42 * (w3 * w46) + w16 * w40 + w48) / w7
    w50 = w0 * c24 + ca.if_else(t < 0.15, motor_torque, 0) + w1 * (c26 + (w15 * w40 + w12 * w41 + w42 * (w3 * w43 + w12 * w44)) - (w14 * w49 - w48 * c3))
    w51 = w1 * w47
    w52 = (w42 * (w12 * w46) - (w3 * w45 + w7 * w40) - w51 - w16 * w49) * slider_mass
    w53 = rod_theta_dot * -2.0 * (w19 * rod_q1_dot + w20 * rod_q2_dot) + w14 * gravity_y - (w15 * w51 - w14 * w48 + w21 * w49)
    w54 = w53 + w16 * w52
    w55 = w50 - w2 * (w14 * w40 + w42 * (w3 * w44 - w12 * w43) + w3 * w41 + (w51 * c3 + w15 * w49) - w52) - w8 * w54
    w56 = w19 * w40 - rod_q1 * c27 + (w23 * gravity_y - rod_q1_dot * c28) - (w24 * w51 - w23 * w48 + w49 * c21)
    w57 = w20 * w40 - rod_q2 * c29 - (rod_q2_dot * c30 + w34 * gravity_y) - (w31 * w51 + w34 * w48 + w49 * c22)
    # outputs
    M_hat_LL = ca.vertcat(c0 + w1 * (w1 * c3) + w2 * (w2 * c5) - (w8 * (w18 - w8 * w22) + w8 * w18))
    M_hat_LS = ca.horzcat(
        w30, w38,
    )
    M_hat_SL = ca.vertcat(w30, w38)
    M_hat_SS = ca.vertcat(
        ca.horzcat(c15 + w25 * w26 + (w27 * w29 + w27 * w28), w39),  # rod.q1
        ca.horzcat(w39, c18 + w32 * w33 + (w35 * w37 + w35 * w36)),  # rod.q2
    )
    Q_hat_L = ca.vertcat(w55)
    Q_hat_S = ca.vertcat(w56 + w25 * w52 + w27 * w54, w57 + w32 * w52 + w35 * w54)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, t, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 2) [N, N m]: right-hand side of a sub-step, slow q'' given
    178 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 45)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_L_ddot[0]
    crank_tip_x = c[1]
    rod_length = c[2]
    slider_mass = c[4]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
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
    gravity_y = c[23]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    # intermediate terms (44)
    w0 = ca.cos(rod_theta)
    w1 = rod_q1 * c6
    w2 = w0 * w1
    w3 = w2 * slider_mass
    w4 = ca.sin(rod_theta)
    w5 = rod_q2 * c7
    w6 = rod_length - (rod_q1 * w1 + rod_q2 * w5) * 0.5
    w7 = w0 * w6
    w8 = w1 * w4 / w7
    w9 = w4 * w6
    w10 = c21 + w3 * w9
    w11 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w12 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w13 = c14 + (rod_q1 * w11 + rod_q2 * w12)
    w14 = w13 + w9 * (w9 * slider_mass)
    w15 = w0 * w5
    w16 = w15 * slider_mass
    w17 = c22 + w9 * w16
    w18 = w4 * w5 / w7
    w19 = w17 + w14 * w18
    w20 = w2 * w16 + (w8 * w19 + w10 * w18)
    w21 = rod_theta_dot**2
    w22 = rod_q1 * c9 + rod_q2 * c10
    w23 = w0 * c13 - w4 * w22
    w24 = crank_theta_dot**2
    w25 = ca.cos(crank_theta) * crank_tip_x
    w26 = ca.sin(crank_theta) * crank_tip_x
    w27 = w24 * w25 + w26 * crank_theta_ddot
    w28 = w24 * w26
    w29 = w25 * crank_theta_ddot - w28
    w30 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w31 = 2 * rod_theta_dot
    w32 = w1 * rod_q1_dot + w5 * rod_q2_dot
    w33 = (w28 + (w4 * w30 + w31 * (w0 * w32) + w9 * w21)) / w7 - crank_theta_ddot * (w25 / w7)
    w34 = w11 * w21 - rod_q1 * c27 + (w23 * gravity_y - rod_q1_dot * c28) - ((w0 * w22 + w4 * c13) * w27 + w23 * w29 + w33 * c21)
    w35 = (w31 * (w4 * w32) - (w0 * w30 + w7 * w21) - w27 - w9 * w33) * slider_mass
    w36 = rod_q1 * c11 + rod_q2 * c12
    w37 = c8 - (rod_q1 * w22 + rod_q2 * w36) * 0.5
    w38 = rod_q1 * c13
    w39 = w0 * w37 - w4 * w38
    w40 = rod_theta_dot * -2.0 * (w11 * rod_q1_dot + w12 * rod_q2_dot) + w39 * gravity_y - (w27 * (w4 * w37 + w0 * w38) + w29 * w39 + w13 * w33)
    w41 = w40 + w9 * w35
    w42 = w4 * w36
    w43 = w12 * w21 - rod_q2 * c29 - (rod_q2_dot * c30 + w42 * gravity_y) - (w27 * (w0 * w36) - w29 * w42 + w33 * c22)
    # outputs
    M_hat_SS = ca.vertcat(
        ca.horzcat(c15 + w2 * w3 + (w8 * (w10 + w8 * w14) + w8 * w10), w20),  # rod.q1
        ca.horzcat(w20, c18 + w15 * w16 + (w18 * w19 + w17 * w18)),  # rod.q2
    )
    rhs_S = ca.vertcat(w34 + w2 * w35 + w8 * w41, w43 + w15 * w35 + w18 * w41)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 168) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 23) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 23) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 38) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 38) [1/m]: rotation at a drawn point by each mode of its body
    gives H (1 x entries = 1 x 68) [1/m]: foreshortening of the drawn points that have it, nf x nf each
    gives sections (2 x beams = 2) [m]: height and width of a rectangle that stands for a beam's section
    gives rigidities (2 x beams = 2) [N m^2]: E I of a beam for bending along y and along z
    113 operations.
    """
    p = ca.SX.sym("p", 168)
    rod_length = p[5]
    rod_area = p[7]
    rod_youngs_modulus = p[8]
    rod_second_moment = p[9]
    crank_tip_x = p[30]
    beam_pinned_pinned2_0_0_slope_0_0 = p[31]
    beam_pinned_pinned2_0_0_slope_1_0 = p[32]
    beam_pinned_pinned2_1_0_slope_0_0 = p[33]
    beam_pinned_pinned2_1_0_slope_1_0 = p[34]
    beam_pinned_pinned2_1_0_H_0_0 = p[35]
    beam_pinned_pinned2_1_0_H_1_1 = p[36]
    beam_pinned_pinned2_0_0625_at_0_0 = p[37]
    beam_pinned_pinned2_0_0625_shape_1_0 = p[38]
    beam_pinned_pinned2_0_0625_shape_1_1 = p[39]
    beam_pinned_pinned2_0_0625_slope_0_0 = p[40]
    beam_pinned_pinned2_0_0625_slope_1_0 = p[41]
    beam_pinned_pinned2_0_0625_H_0_0 = p[42]
    beam_pinned_pinned2_0_0625_H_0_1 = p[43]
    beam_pinned_pinned2_0_0625_H_1_0 = p[44]
    beam_pinned_pinned2_0_0625_H_1_1 = p[45]
    beam_pinned_pinned2_0_125_at_0_0 = p[46]
    beam_pinned_pinned2_0_125_shape_1_0 = p[47]
    beam_pinned_pinned2_0_125_shape_1_1 = p[48]
    beam_pinned_pinned2_0_125_slope_0_0 = p[49]
    beam_pinned_pinned2_0_125_slope_1_0 = p[50]
    beam_pinned_pinned2_0_125_H_0_0 = p[51]
    beam_pinned_pinned2_0_125_H_0_1 = p[52]
    beam_pinned_pinned2_0_125_H_1_0 = p[53]
    beam_pinned_pinned2_0_125_H_1_1 = p[54]
    beam_pinned_pinned2_0_1875_at_0_0 = p[55]
    beam_pinned_pinned2_0_1875_shape_1_0 = p[56]
    beam_pinned_pinned2_0_1875_shape_1_1 = p[57]
    beam_pinned_pinned2_0_1875_slope_0_0 = p[58]
    beam_pinned_pinned2_0_1875_slope_1_0 = p[59]
    beam_pinned_pinned2_0_1875_H_0_0 = p[60]
    beam_pinned_pinned2_0_1875_H_0_1 = p[61]
    beam_pinned_pinned2_0_1875_H_1_0 = p[62]
    beam_pinned_pinned2_0_1875_H_1_1 = p[63]
    beam_pinned_pinned2_0_25_at_0_0 = p[64]
    beam_pinned_pinned2_0_25_shape_1_0 = p[65]
    beam_pinned_pinned2_0_25_shape_1_1 = p[66]
    beam_pinned_pinned2_0_25_slope_0_0 = p[67]
    beam_pinned_pinned2_0_25_H_0_0 = p[68]
    beam_pinned_pinned2_0_25_H_0_1 = p[69]
    beam_pinned_pinned2_0_25_H_1_0 = p[70]
    beam_pinned_pinned2_0_25_H_1_1 = p[71]
    beam_pinned_pinned2_0_3125_at_0_0 = p[72]
    beam_pinned_pinned2_0_3125_shape_1_0 = p[73]
    beam_pinned_pinned2_0_3125_shape_1_1 = p[74]
    beam_pinned_pinned2_0_3125_slope_0_0 = p[75]
    beam_pinned_pinned2_0_3125_slope_1_0 = p[76]
    beam_pinned_pinned2_0_3125_H_0_0 = p[77]
    beam_pinned_pinned2_0_3125_H_0_1 = p[78]
    beam_pinned_pinned2_0_3125_H_1_0 = p[79]
    beam_pinned_pinned2_0_3125_H_1_1 = p[80]
    beam_pinned_pinned2_0_375_at_0_0 = p[81]
    beam_pinned_pinned2_0_375_shape_1_0 = p[82]
    beam_pinned_pinned2_0_375_shape_1_1 = p[83]
    beam_pinned_pinned2_0_375_slope_0_0 = p[84]
    beam_pinned_pinned2_0_375_slope_1_0 = p[85]
    beam_pinned_pinned2_0_375_H_0_0 = p[86]
    beam_pinned_pinned2_0_375_H_0_1 = p[87]
    beam_pinned_pinned2_0_375_H_1_0 = p[88]
    beam_pinned_pinned2_0_375_H_1_1 = p[89]
    beam_pinned_pinned2_0_4375_at_0_0 = p[90]
    beam_pinned_pinned2_0_4375_shape_1_0 = p[91]
    beam_pinned_pinned2_0_4375_shape_1_1 = p[92]
    beam_pinned_pinned2_0_4375_slope_0_0 = p[93]
    beam_pinned_pinned2_0_4375_slope_1_0 = p[94]
    beam_pinned_pinned2_0_4375_H_0_0 = p[95]
    beam_pinned_pinned2_0_4375_H_0_1 = p[96]
    beam_pinned_pinned2_0_4375_H_1_0 = p[97]
    beam_pinned_pinned2_0_4375_H_1_1 = p[98]
    beam_pinned_pinned2_0_5_at_0_0 = p[99]
    beam_pinned_pinned2_0_5_shape_1_0 = p[100]
    beam_pinned_pinned2_0_5_slope_1_0 = p[101]
    beam_pinned_pinned2_0_5_H_0_0 = p[102]
    beam_pinned_pinned2_0_5_H_0_1 = p[103]
    beam_pinned_pinned2_0_5_H_1_0 = p[104]
    beam_pinned_pinned2_0_5_H_1_1 = p[105]
    beam_pinned_pinned2_0_5625_at_0_0 = p[106]
    beam_pinned_pinned2_0_5625_shape_1_0 = p[107]
    beam_pinned_pinned2_0_5625_shape_1_1 = p[108]
    beam_pinned_pinned2_0_5625_slope_0_0 = p[109]
    beam_pinned_pinned2_0_5625_slope_1_0 = p[110]
    beam_pinned_pinned2_0_5625_H_0_0 = p[111]
    beam_pinned_pinned2_0_5625_H_0_1 = p[112]
    beam_pinned_pinned2_0_5625_H_1_0 = p[113]
    beam_pinned_pinned2_0_5625_H_1_1 = p[114]
    beam_pinned_pinned2_0_625_at_0_0 = p[115]
    beam_pinned_pinned2_0_625_shape_1_0 = p[116]
    beam_pinned_pinned2_0_625_shape_1_1 = p[117]
    beam_pinned_pinned2_0_625_slope_0_0 = p[118]
    beam_pinned_pinned2_0_625_slope_1_0 = p[119]
    beam_pinned_pinned2_0_625_H_0_0 = p[120]
    beam_pinned_pinned2_0_625_H_0_1 = p[121]
    beam_pinned_pinned2_0_625_H_1_0 = p[122]
    beam_pinned_pinned2_0_625_H_1_1 = p[123]
    beam_pinned_pinned2_0_6875_at_0_0 = p[124]
    beam_pinned_pinned2_0_6875_shape_1_0 = p[125]
    beam_pinned_pinned2_0_6875_shape_1_1 = p[126]
    beam_pinned_pinned2_0_6875_slope_0_0 = p[127]
    beam_pinned_pinned2_0_6875_slope_1_0 = p[128]
    beam_pinned_pinned2_0_6875_H_0_0 = p[129]
    beam_pinned_pinned2_0_6875_H_0_1 = p[130]
    beam_pinned_pinned2_0_6875_H_1_0 = p[131]
    beam_pinned_pinned2_0_6875_H_1_1 = p[132]
    beam_pinned_pinned2_0_75_at_0_0 = p[133]
    beam_pinned_pinned2_0_75_shape_1_0 = p[134]
    beam_pinned_pinned2_0_75_shape_1_1 = p[135]
    beam_pinned_pinned2_0_75_slope_0_0 = p[136]
    beam_pinned_pinned2_0_75_H_0_0 = p[137]
    beam_pinned_pinned2_0_75_H_0_1 = p[138]
    beam_pinned_pinned2_0_75_H_1_0 = p[139]
    beam_pinned_pinned2_0_75_H_1_1 = p[140]
    beam_pinned_pinned2_0_8125_at_0_0 = p[141]
    beam_pinned_pinned2_0_8125_shape_1_0 = p[142]
    beam_pinned_pinned2_0_8125_shape_1_1 = p[143]
    beam_pinned_pinned2_0_8125_slope_0_0 = p[144]
    beam_pinned_pinned2_0_8125_slope_1_0 = p[145]
    beam_pinned_pinned2_0_8125_H_0_0 = p[146]
    beam_pinned_pinned2_0_8125_H_0_1 = p[147]
    beam_pinned_pinned2_0_8125_H_1_0 = p[148]
    beam_pinned_pinned2_0_8125_H_1_1 = p[149]
    beam_pinned_pinned2_0_875_at_0_0 = p[150]
    beam_pinned_pinned2_0_875_shape_1_0 = p[151]
    beam_pinned_pinned2_0_875_shape_1_1 = p[152]
    beam_pinned_pinned2_0_875_slope_0_0 = p[153]
    beam_pinned_pinned2_0_875_slope_1_0 = p[154]
    beam_pinned_pinned2_0_875_H_0_0 = p[155]
    beam_pinned_pinned2_0_875_H_0_1 = p[156]
    beam_pinned_pinned2_0_875_H_1_0 = p[157]
    beam_pinned_pinned2_0_875_H_1_1 = p[158]
    beam_pinned_pinned2_0_9375_at_0_0 = p[159]
    beam_pinned_pinned2_0_9375_shape_1_0 = p[160]
    beam_pinned_pinned2_0_9375_shape_1_1 = p[161]
    beam_pinned_pinned2_0_9375_slope_0_0 = p[162]
    beam_pinned_pinned2_0_9375_slope_1_0 = p[163]
    beam_pinned_pinned2_0_9375_H_0_0 = p[164]
    beam_pinned_pinned2_0_9375_H_0_1 = p[165]
    beam_pinned_pinned2_0_9375_H_1_0 = p[166]
    beam_pinned_pinned2_0_9375_H_1_1 = p[167]
    # intermediate terms (7)
    w0 = beam_pinned_pinned2_0_0_slope_0_0 / rod_length
    w1 = beam_pinned_pinned2_0_0_slope_1_0 / rod_length
    w2 = beam_pinned_pinned2_1_0_slope_0_0 / rod_length
    w3 = beam_pinned_pinned2_1_0_slope_1_0 / rod_length
    w4 = beam_pinned_pinned2_1_0_H_0_0 / rod_length
    w5 = beam_pinned_pinned2_1_0_H_1_1 / rod_length
    w6 = ca.sqrt(12.0 * rod_second_moment / rod_area)
    # outputs
    positions = ca.SX(3, 23)
    positions[0, 1] = rod_length * beam_pinned_pinned2_0_0625_at_0_0
    positions[0, 2] = rod_length * beam_pinned_pinned2_0_125_at_0_0
    positions[0, 3] = rod_length * beam_pinned_pinned2_0_1875_at_0_0
    positions[0, 4] = rod_length * beam_pinned_pinned2_0_25_at_0_0
    positions[0, 5] = rod_length * beam_pinned_pinned2_0_3125_at_0_0
    positions[0, 6] = rod_length * beam_pinned_pinned2_0_375_at_0_0
    positions[0, 7] = rod_length * beam_pinned_pinned2_0_4375_at_0_0
    positions[0, 8] = rod_length * beam_pinned_pinned2_0_5_at_0_0
    positions[0, 9] = rod_length * beam_pinned_pinned2_0_5625_at_0_0
    positions[0, 10] = rod_length * beam_pinned_pinned2_0_625_at_0_0
    positions[0, 11] = rod_length * beam_pinned_pinned2_0_6875_at_0_0
    positions[0, 12] = rod_length * beam_pinned_pinned2_0_75_at_0_0
    positions[0, 13] = rod_length * beam_pinned_pinned2_0_8125_at_0_0
    positions[0, 14] = rod_length * beam_pinned_pinned2_0_875_at_0_0
    positions[0, 15] = rod_length * beam_pinned_pinned2_0_9375_at_0_0
    positions[0, 16] = rod_length
    positions[0, 19] = crank_tip_x
    positions[0, 21] = rod_length
    axes = ca.SX(9, 23)
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
    axes[0, 13] = 1.0
    axes[0, 14] = 1.0
    axes[0, 15] = 1.0
    axes[0, 16] = 1.0
    axes[0, 17] = 1.0
    axes[0, 18] = 1.0
    axes[0, 19] = 1.0
    axes[0, 20] = 1.0
    axes[0, 21] = 1.0
    axes[0, 22] = 1.0
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
    axes[4, 13] = 1.0
    axes[4, 14] = 1.0
    axes[4, 15] = 1.0
    axes[4, 16] = 1.0
    axes[4, 17] = 1.0
    axes[4, 18] = 1.0
    axes[4, 19] = 1.0
    axes[4, 20] = 1.0
    axes[4, 21] = 1.0
    axes[4, 22] = 1.0
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
    axes[8, 13] = 1.0
    axes[8, 14] = 1.0
    axes[8, 15] = 1.0
    axes[8, 16] = 1.0
    axes[8, 17] = 1.0
    axes[8, 18] = 1.0
    axes[8, 19] = 1.0
    axes[8, 20] = 1.0
    axes[8, 21] = 1.0
    axes[8, 22] = 1.0
    shapes = ca.SX(3, 38)
    shapes[1, 2] = beam_pinned_pinned2_0_0625_shape_1_0
    shapes[1, 3] = beam_pinned_pinned2_0_0625_shape_1_1
    shapes[1, 4] = beam_pinned_pinned2_0_125_shape_1_0
    shapes[1, 5] = beam_pinned_pinned2_0_125_shape_1_1
    shapes[1, 6] = beam_pinned_pinned2_0_1875_shape_1_0
    shapes[1, 7] = beam_pinned_pinned2_0_1875_shape_1_1
    shapes[1, 8] = beam_pinned_pinned2_0_25_shape_1_0
    shapes[1, 9] = beam_pinned_pinned2_0_25_shape_1_1
    shapes[1, 10] = beam_pinned_pinned2_0_3125_shape_1_0
    shapes[1, 11] = beam_pinned_pinned2_0_3125_shape_1_1
    shapes[1, 12] = beam_pinned_pinned2_0_375_shape_1_0
    shapes[1, 13] = beam_pinned_pinned2_0_375_shape_1_1
    shapes[1, 14] = beam_pinned_pinned2_0_4375_shape_1_0
    shapes[1, 15] = beam_pinned_pinned2_0_4375_shape_1_1
    shapes[1, 16] = beam_pinned_pinned2_0_5_shape_1_0
    shapes[1, 18] = beam_pinned_pinned2_0_5625_shape_1_0
    shapes[1, 19] = beam_pinned_pinned2_0_5625_shape_1_1
    shapes[1, 20] = beam_pinned_pinned2_0_625_shape_1_0
    shapes[1, 21] = beam_pinned_pinned2_0_625_shape_1_1
    shapes[1, 22] = beam_pinned_pinned2_0_6875_shape_1_0
    shapes[1, 23] = beam_pinned_pinned2_0_6875_shape_1_1
    shapes[1, 24] = beam_pinned_pinned2_0_75_shape_1_0
    shapes[1, 25] = beam_pinned_pinned2_0_75_shape_1_1
    shapes[1, 26] = beam_pinned_pinned2_0_8125_shape_1_0
    shapes[1, 27] = beam_pinned_pinned2_0_8125_shape_1_1
    shapes[1, 28] = beam_pinned_pinned2_0_875_shape_1_0
    shapes[1, 29] = beam_pinned_pinned2_0_875_shape_1_1
    shapes[1, 30] = beam_pinned_pinned2_0_9375_shape_1_0
    shapes[1, 31] = beam_pinned_pinned2_0_9375_shape_1_1
    turns = ca.SX(3, 38)
    turns[2, 0] = w0
    turns[2, 1] = w1
    turns[2, 2] = beam_pinned_pinned2_0_0625_slope_0_0 / rod_length
    turns[2, 3] = beam_pinned_pinned2_0_0625_slope_1_0 / rod_length
    turns[2, 4] = beam_pinned_pinned2_0_125_slope_0_0 / rod_length
    turns[2, 5] = beam_pinned_pinned2_0_125_slope_1_0 / rod_length
    turns[2, 6] = beam_pinned_pinned2_0_1875_slope_0_0 / rod_length
    turns[2, 7] = beam_pinned_pinned2_0_1875_slope_1_0 / rod_length
    turns[2, 8] = beam_pinned_pinned2_0_25_slope_0_0 / rod_length
    turns[2, 10] = beam_pinned_pinned2_0_3125_slope_0_0 / rod_length
    turns[2, 11] = beam_pinned_pinned2_0_3125_slope_1_0 / rod_length
    turns[2, 12] = beam_pinned_pinned2_0_375_slope_0_0 / rod_length
    turns[2, 13] = beam_pinned_pinned2_0_375_slope_1_0 / rod_length
    turns[2, 14] = beam_pinned_pinned2_0_4375_slope_0_0 / rod_length
    turns[2, 15] = beam_pinned_pinned2_0_4375_slope_1_0 / rod_length
    turns[2, 17] = beam_pinned_pinned2_0_5_slope_1_0 / rod_length
    turns[2, 18] = beam_pinned_pinned2_0_5625_slope_0_0 / rod_length
    turns[2, 19] = beam_pinned_pinned2_0_5625_slope_1_0 / rod_length
    turns[2, 20] = beam_pinned_pinned2_0_625_slope_0_0 / rod_length
    turns[2, 21] = beam_pinned_pinned2_0_625_slope_1_0 / rod_length
    turns[2, 22] = beam_pinned_pinned2_0_6875_slope_0_0 / rod_length
    turns[2, 23] = beam_pinned_pinned2_0_6875_slope_1_0 / rod_length
    turns[2, 24] = beam_pinned_pinned2_0_75_slope_0_0 / rod_length
    turns[2, 26] = beam_pinned_pinned2_0_8125_slope_0_0 / rod_length
    turns[2, 27] = beam_pinned_pinned2_0_8125_slope_1_0 / rod_length
    turns[2, 28] = beam_pinned_pinned2_0_875_slope_0_0 / rod_length
    turns[2, 29] = beam_pinned_pinned2_0_875_slope_1_0 / rod_length
    turns[2, 30] = beam_pinned_pinned2_0_9375_slope_0_0 / rod_length
    turns[2, 31] = beam_pinned_pinned2_0_9375_slope_1_0 / rod_length
    turns[2, 32] = w2
    turns[2, 33] = w3
    turns[2, 34] = w0
    turns[2, 35] = w1
    turns[2, 36] = w2
    turns[2, 37] = w3
    H = ca.horzcat(
        beam_pinned_pinned2_0_0625_H_0_0 / rod_length, beam_pinned_pinned2_0_0625_H_0_1 / rod_length,
        beam_pinned_pinned2_0_0625_H_1_0 / rod_length, beam_pinned_pinned2_0_0625_H_1_1 / rod_length,
        beam_pinned_pinned2_0_125_H_0_0 / rod_length, beam_pinned_pinned2_0_125_H_0_1 / rod_length,
        beam_pinned_pinned2_0_125_H_1_0 / rod_length, beam_pinned_pinned2_0_125_H_1_1 / rod_length,
        beam_pinned_pinned2_0_1875_H_0_0 / rod_length, beam_pinned_pinned2_0_1875_H_0_1 / rod_length,
        beam_pinned_pinned2_0_1875_H_1_0 / rod_length, beam_pinned_pinned2_0_1875_H_1_1 / rod_length,
        beam_pinned_pinned2_0_25_H_0_0 / rod_length, beam_pinned_pinned2_0_25_H_0_1 / rod_length,
        beam_pinned_pinned2_0_25_H_1_0 / rod_length, beam_pinned_pinned2_0_25_H_1_1 / rod_length,
        beam_pinned_pinned2_0_3125_H_0_0 / rod_length, beam_pinned_pinned2_0_3125_H_0_1 / rod_length,
        beam_pinned_pinned2_0_3125_H_1_0 / rod_length, beam_pinned_pinned2_0_3125_H_1_1 / rod_length,
        beam_pinned_pinned2_0_375_H_0_0 / rod_length, beam_pinned_pinned2_0_375_H_0_1 / rod_length,
        beam_pinned_pinned2_0_375_H_1_0 / rod_length, beam_pinned_pinned2_0_375_H_1_1 / rod_length,
        beam_pinned_pinned2_0_4375_H_0_0 / rod_length, beam_pinned_pinned2_0_4375_H_0_1 / rod_length,
        beam_pinned_pinned2_0_4375_H_1_0 / rod_length, beam_pinned_pinned2_0_4375_H_1_1 / rod_length,
        beam_pinned_pinned2_0_5_H_0_0 / rod_length, beam_pinned_pinned2_0_5_H_0_1 / rod_length,
        beam_pinned_pinned2_0_5_H_1_0 / rod_length, beam_pinned_pinned2_0_5_H_1_1 / rod_length,
        beam_pinned_pinned2_0_5625_H_0_0 / rod_length, beam_pinned_pinned2_0_5625_H_0_1 / rod_length,
        beam_pinned_pinned2_0_5625_H_1_0 / rod_length, beam_pinned_pinned2_0_5625_H_1_1 / rod_length,
        beam_pinned_pinned2_0_625_H_0_0 / rod_length, beam_pinned_pinned2_0_625_H_0_1 / rod_length,
        beam_pinned_pinned2_0_625_H_1_0 / rod_length, beam_pinned_pinned2_0_625_H_1_1 / rod_length,
        beam_pinned_pinned2_0_6875_H_0_0 / rod_length, beam_pinned_pinned2_0_6875_H_0_1 / rod_length,
        beam_pinned_pinned2_0_6875_H_1_0 / rod_length, beam_pinned_pinned2_0_6875_H_1_1 / rod_length,
        beam_pinned_pinned2_0_75_H_0_0 / rod_length, beam_pinned_pinned2_0_75_H_0_1 / rod_length,
        beam_pinned_pinned2_0_75_H_1_0 / rod_length, beam_pinned_pinned2_0_75_H_1_1 / rod_length,
        beam_pinned_pinned2_0_8125_H_0_0 / rod_length, beam_pinned_pinned2_0_8125_H_0_1 / rod_length,
        beam_pinned_pinned2_0_8125_H_1_0 / rod_length, beam_pinned_pinned2_0_8125_H_1_1 / rod_length,
        beam_pinned_pinned2_0_875_H_0_0 / rod_length, beam_pinned_pinned2_0_875_H_0_1 / rod_length,
        beam_pinned_pinned2_0_875_H_1_0 / rod_length, beam_pinned_pinned2_0_875_H_1_1 / rod_length,
        beam_pinned_pinned2_0_9375_H_0_0 / rod_length, beam_pinned_pinned2_0_9375_H_0_1 / rod_length,
        beam_pinned_pinned2_0_9375_H_1_0 / rod_length, beam_pinned_pinned2_0_9375_H_1_1 / rod_length, w4, 0.0,
        0.0, w5, w4, 0.0, 0.0, w5,
    )
    sections = ca.vertcat(w6, rod_area / w6)
    rigidities = ca.vertcat(rod_youngs_modulus * rod_second_moment, 0.0)
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes), ca.densify(shapes), ca.densify(turns), ca.densify(H), ca.densify(sections), ca.densify(rigidities)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes", "shapes", "turns", "H", "sections", "rigidities"])


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
    "load_actions": load_actions,
    "poses": poses,
    "switching": switching,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
