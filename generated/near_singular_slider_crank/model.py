"""Flexible slider-crank close to a change point: equations of motion, emitted by symgen from the scene `near_singular_slider_crank`.

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

    takes p (n_p = 164) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    36 operations.
    """
    p = ca.SX.sym("p", 164)
    crank_mass = p[0]
    crank_inertia = p[1]
    rod_length = p[2]
    rod_density = p[3]
    rod_area = p[4]
    rod_youngs_modulus = p[5]
    rod_second_moment = p[6]
    beam_pinned_pinned2_kappa_lateral_0_0 = p[7]
    beam_pinned_pinned2_kappa_lateral_1_1 = p[8]
    beam_pinned_pinned2_mass_0_0 = p[9]
    beam_pinned_pinned2_mass_1_1 = p[10]
    beam_pinned_pinned2_s1_0_0 = p[11]
    beam_pinned_pinned2_i0_0_0 = p[12]
    beam_pinned_pinned2_phi_y_0_0 = p[13]
    beam_pinned_pinned2_xi_phi_y_0_0 = p[14]
    beam_pinned_pinned2_xi_phi_y_1_0 = p[15]
    beam_pinned_pinned2_H_0_0 = p[16]
    beam_pinned_pinned2_H_0_1 = p[17]
    beam_pinned_pinned2_H_1_0 = p[18]
    beam_pinned_pinned2_H_1_1 = p[19]
    beam_pinned_pinned2_xH_0_0 = p[20]
    beam_pinned_pinned2_xH_0_1 = p[21]
    beam_pinned_pinned2_xH_1_0 = p[22]
    beam_pinned_pinned2_xH_1_1 = p[23]
    slider_mass = p[24]
    slider_inertia = p[25]
    crank_tip_x = p[26]
    beam_pinned_pinned2_1_0_H_0_0 = p[31]
    beam_pinned_pinned2_1_0_H_1_1 = p[32]
    # intermediate terms (16)
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
    w15 = rod_youngs_modulus * rod_second_moment / (rod_length * w10)
    # outputs
    c = ca.vertcat(
        crank_inertia,  # crank_inertia
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
        w15 * beam_pinned_pinned2_kappa_lateral_0_0,  # c23
        w15 * beam_pinned_pinned2_kappa_lateral_1_1,  # c24
        crank_mass,  # crank_mass
        slider_inertia,  # slider_inertia
        -w9,  # c27
        w11 - w12,  # c28
        w13 - w14,  # c29
        2 * w2,  # c30
        2 * w3,  # c31
        w5 + w5,  # c32
        w6 + w7,  # c33
        w8 + w8,  # c34
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    237 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 35)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_inertia = c[0]
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
    c23 = c[23]
    c24 = c[24]
    # intermediate terms (54)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_q1 * c6
    w4 = rod_q2 * c7
    w5 = rod_length - (rod_q1 * w3 + rod_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = w0 / w6
    w8 = rod_q1 * c9 + rod_q2 * c10
    w9 = rod_q1 * c11 + rod_q2 * c12
    w10 = c8 - (rod_q1 * w8 + rod_q2 * w9) * 0.5
    w11 = ca.sin(rod_theta)
    w12 = rod_q1 * c13
    w13 = w2 * w10 - w11 * w12
    w14 = w10 * w11 + w2 * w12
    w15 = w5 * w11
    w16 = w15 * slider_mass
    w17 = w0 * w13 + w1 * (w14 + w16)
    w18 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w19 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w20 = c14 + (rod_q1 * w18 + rod_q2 * w19)
    w21 = w20 + w15 * w16
    w22 = w2 * c13 - w8 * w11
    w23 = w2 * w8 + w11 * c13
    w24 = w2 * w3
    w25 = w24 * slider_mass
    w26 = w3 * w11 / w6
    w27 = c21 + w15 * w25
    w28 = w27 + w21 * w26
    w29 = w0 * w22 + w1 * (w23 + w25) + (w17 * w26 - w7 * w28)
    w30 = w2 * w9
    w31 = w2 * w4
    w32 = w31 * slider_mass
    w33 = w9 * w11
    w34 = w4 * w11 / w6
    w35 = c22 + w15 * w32
    w36 = w35 + w21 * w34
    w37 = w1 * (w30 + w32) - w0 * w33 + (w17 * w34 - w7 * w36)
    w38 = w24 * w32 + (w26 * w36 + w27 * w34)
    w39 = rod_theta_dot**2
    w40 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w41 = 2 * rod_theta_dot
    w42 = w8 * rod_q1_dot + w9 * rod_q2_dot
    w43 = rod_q1_dot * c13
    w44 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w45 = w3 * rod_q1_dot + w4 * rod_q2_dot
    w46 = crank_theta_dot**2
    w47 = w1 * w46
    w48 = (w11 * w44 + w41 * (w2 * w45) + w15 * w39 + w47) / w6
    w49 = w0 * w46
    w50 = (w41 * (w11 * w45) - (w2 * w44 + w6 * w39) - w49 - w15 * w48) * slider_mass
    w51 = w0 * (w14 * w39 + w11 * w40 + w41 * (w2 * w42 + w11 * w43) - (w13 * w48 - w47 * c3)) - w1 * (w13 * w39 + w41 * (w2 * w43 - w11 * w42) + w2 * w40 + (w49 * c3 + w14 * w48) - w50)
    w52 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot) - (w14 * w49 - w13 * w47 + w20 * w48)
    w53 = w52 + w15 * w50
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(  # crank.theta
            crank_inertia + w0 * (w0 * c3) + w1 * (w1 * c5) - (w7 * (w17 - w7 * w21) + w7 * w17), w29, w37,
        ),
        ca.horzcat(w29, c15 + w24 * w25 + (w26 * w28 + w26 * w27), w38),  # rod.q1
        ca.horzcat(w37, w38, c18 + w31 * w32 + (w34 * w36 + w34 * w35)),  # rod.q2
    )
    Q_hat = ca.vertcat(
        w51 - w7 * w53,  # crank.theta
        w18 * w39 - rod_q1 * c23 - (w23 * w49 - w22 * w47 + w48 * c21) + w24 * w50 + w26 * w53,  # rod.q1
        w19 * w39 - rod_q2 * c24 - (w30 * w49 + w33 * w47 + w48 * c22) + w31 * w50 + w34 * w53,  # rod.q2
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    23 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 35)
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    37 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 35)
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    67 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 35)
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 11) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    57 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    c = ca.SX.sym("c", 35)
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 11 x 11) [SI]: mass matrix in all coordinates
    gives K (n x n = 11 x 11) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 11) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 11) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 11) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 11) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    132 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    c = ca.SX.sym("c", 35)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    crank_inertia = c[0]
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
    c23 = c[23]
    c24 = c[24]
    crank_mass = c[25]
    slider_inertia = c[26]
    c27 = c[27]
    # intermediate terms (35)
    w0 = ca.sin(rod_theta)
    w1 = rod_q1 * c9 + rod_q2 * c10
    w2 = rod_q1 * c11 + rod_q2 * c12
    w3 = c8 - (rod_q1 * w1 + rod_q2 * w2) * 0.5
    w4 = ca.cos(rod_theta)
    w5 = rod_q1 * c13
    w6 = w0 * w3 + w4 * w5
    w7 = -w6
    w8 = -(w2 * w4)
    w9 = w3 * w4 - w0 * w5
    w10 = w4 * c13 - w0 * w1
    w11 = -(w0 * w2)
    w12 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w13 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w14 = rod_theta_dot**2
    w15 = 2 * rod_theta_dot
    w16 = rod_q1_dot * c13
    w17 = w1 * rod_q1_dot + w2 * rod_q2_dot
    w18 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w19 = w9 * w14 + w15 * (w4 * w16 - w0 * w17) + w4 * w18
    w20 = w6 * w14 + w0 * w18 + w15 * (w4 * w17 + w0 * w16)
    w21 = rod_theta_dot * -2.0 * (w12 * rod_q1_dot + w13 * rod_q2_dot)
    w22 = w12 * w14
    w23 = w13 * w14
    w24 = ca.sin(crank_theta) * crank_tip_x
    w25 = ca.cos(crank_theta) * crank_tip_x
    w26 = rod_q1 * c6
    w27 = rod_q2 * c7
    w28 = rod_length - (rod_q1 * w26 + rod_q2 * w27) * 0.5
    w29 = w0 * w28
    w30 = w4 * w28
    w31 = crank_theta_dot**2
    w32 = rod_q1_dot * w26 + rod_q2_dot * w27
    w33 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w34 = w0 * c27 - w1 * w4
    # outputs
    M = ca.SX(11, 11)
    # crank.x
    M[0, 0] = crank_mass
    # crank.y
    M[1, 1] = crank_mass
    # crank.theta
    M[2, 2] = crank_inertia
    # rod.x
    M[3, 3] = c3
    M[3, 5] = w7
    M[3, 6] = w34
    M[3, 7] = w8
    # rod.y
    M[4, 4] = c3
    M[4, 5] = w9
    M[4, 6] = w10
    M[4, 7] = w11
    # rod.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c14 + (rod_q1 * w12 + rod_q2 * w13)
    M[5, 6] = c21
    M[5, 7] = c22
    # rod.q1
    M[6, 3] = w34
    M[6, 4] = w10
    M[6, 5] = c21
    M[6, 6] = c15
    # rod.q2
    M[7, 3] = w8
    M[7, 4] = w11
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
    K[6, 6] = c23
    # rod.q2
    K[7, 7] = c24
    Q_v = ca.SX(11, 1)
    Q_v[3] = w19  # rod.x
    Q_v[4] = w20  # rod.y
    Q_v[5] = w21  # rod.theta
    Q_v[6] = w22  # rod.q1
    Q_v[7] = w23  # rod.q2
    Q_F = ca.SX(11, 1)
    Q_star = ca.SX(11, 1)
    Q_star[3] = w19  # rod.x
    Q_star[4] = w20  # rod.y
    Q_star[5] = w21  # rod.theta
    Q_star[6] = w22 - rod_q1 * c23  # rod.q1
    Q_star[7] = w23 - rod_q2 * c24  # rod.q2
    C_q = ca.SX(8, 11)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w24
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w25
    C_q[3, 4] = 1.0
    # slide.normal
    C_q[4, 9] = 1.0
    # slide.angle
    C_q[5, 10] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w29
    C_q[6, 6] = w4 * w26
    C_q[6, 7] = w4 * w27
    C_q[6, 8] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w30
    C_q[7, 6] = w0 * w26
    C_q[7, 7] = w0 * w27
    C_q[7, 9] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w25 * w31)  # B.x
    gamma[3] = -(w24 * w31)  # B.y
    gamma[6] = w15 * (w0 * w32) - (w4 * w33 + w14 * w30)  # C.x
    gamma[7] = -(w0 * w33 + w15 * (w4 * w32) + w14 * w29)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes q_ddot (n = 11) [mixed]: accelerations of all coordinates
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    134 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    q_ddot = ca.SX.sym("q_ddot", 11)
    c = ca.SX.sym("c", 35)
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
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
    crank_mass = c[25]
    slider_inertia = c[26]
    # intermediate terms (28)
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta)
    w2 = rod_q1 * c9 + rod_q2 * c10
    w3 = rod_q1 * c11 + rod_q2 * c12
    w4 = c8 - (rod_q1 * w2 + rod_q2 * w3) * 0.5
    w5 = ca.sin(rod_theta)
    w6 = rod_q1 * c13
    w7 = w1 * w4 - w5 * w6
    w8 = 2 * rod_theta_dot
    w9 = rod_q1_dot * c13
    w10 = w2 * rod_q1_dot + w3 * rod_q2_dot
    w11 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w12 = w4 * w5 + w1 * w6
    w13 = rod_x_ddot * c3 - w12 * rod_theta_ddot - (w1 * w2 + w5 * c13) * rod_q1_ddot - w1 * w3 * rod_q2_ddot
    w14 = slider_x_ddot * slider_mass
    w15 = w0 * w7 + w8 * (w1 * w9 - w5 * w10) + w1 * w11 - w13 - w14
    w16 = w15 - crank_x_ddot * crank_mass
    w17 = rod_y_ddot * c3 + w7 * rod_theta_ddot + rod_q1_ddot * (w1 * c13 - w2 * w5) - rod_q2_ddot * (w3 * w5)
    w18 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w19 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w20 = w7 * rod_y_ddot - rod_x_ddot * w12 + rod_theta_ddot * (c14 + (rod_q1 * w18 + rod_q2 * w19)) + rod_q1_ddot * c21
    w21 = rod_length - (rod_q1 * (rod_q1 * c6) + rod_q2 * (rod_q2 * c7)) * 0.5
    w22 = rod_theta_dot * -2.0 * (rod_q1_dot * w18 + rod_q2_dot * w19) - (w20 + rod_q2_ddot * c22) + w14 * (w5 * w21)
    w23 = w22 / (w1 * w21)
    w24 = w0 * w12 + w5 * w11 + w8 * (w1 * w10 + w5 * w9) - w17 - w23
    w25 = w24 - crank_y_ddot * crank_mass
    w26 = w23 - slider_y_ddot * slider_mass
    w27 = slider_theta_ddot * slider_inertia
    # outputs
    lam = ca.vertcat(
        w16,  # A.x
        w25,  # A.y
        w15,  # B.x
        w24,  # B.y
        w26,  # slide.normal
        -w27,  # slide.angle
        -w14,  # C.x
        -w23,  # C.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w16, -w25, 0.0),  # A
        ca.vertcat(-w15, -w24, 0.0),  # B
        ca.vertcat(0.0, -w26, w27),  # slide
        ca.vertcat(w14, w23, 0.0),  # C
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 11) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 11) [mixed]: rates of all coordinates
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    113 operations.
    """
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    c = ca.SX.sym("c", 35)
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
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
    crank_inertia = c[0]
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
    c23 = c[23]
    c24 = c[24]
    crank_mass = c[25]
    slider_inertia = c[26]
    # intermediate terms (19)
    w0 = crank_x_dot * (crank_x_dot * crank_mass) + crank_y_dot * (crank_y_dot * crank_mass) + crank_theta_dot * (crank_theta_dot * crank_inertia)
    w1 = ca.sin(rod_theta)
    w2 = rod_q1 * c9 + rod_q2 * c10
    w3 = rod_q1 * c11 + rod_q2 * c12
    w4 = c8 - (rod_q1 * w2 + rod_q2 * w3) * 0.5
    w5 = ca.cos(rod_theta)
    w6 = rod_q1 * c13
    w7 = w1 * w4 + w5 * w6
    w8 = w2 * w5 + w1 * c13
    w9 = w3 * w5
    w10 = w4 * w5 - w1 * w6
    w11 = w5 * c13 - w1 * w2
    w12 = w1 * w3
    w13 = w0 + rod_x_dot * (rod_x_dot * c3 - w7 * rod_theta_dot - w8 * rod_q1_dot - w9 * rod_q2_dot) + rod_y_dot * (rod_y_dot * c3 + rod_theta_dot * w10 + rod_q1_dot * w11 - rod_q2_dot * w12)
    w14 = rod_q1 * (rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)) + rod_q2 * (rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20))
    w15 = rod_y_dot * w10 - rod_x_dot * w7 + rod_theta_dot * (c14 + w14) + rod_q1_dot * c21 + rod_q2_dot * c22
    w16 = w13 + rod_theta_dot * w15 + rod_q1_dot * (rod_y_dot * w11 - rod_x_dot * w8 + rod_theta_dot * c21 + rod_q1_dot * c15)
    w17 = w16 + rod_q2_dot * (rod_theta_dot * c22 - (rod_x_dot * w9 + rod_y_dot * w12) + rod_q2_dot * c18) + slider_x_dot * (slider_x_dot * slider_mass)
    w18 = w17 + slider_y_dot * (slider_y_dot * slider_mass) + slider_theta_dot * (slider_theta_dot * slider_inertia)
    # outputs
    kinetic = ca.vertcat(w18 / 2.0)
    elastic = ca.vertcat((rod_q1 * (rod_q1 * c23) + rod_q2 * (rod_q2 * c24)) / 2.0)
    potential = ca.SX(1, 1)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


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


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    533 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 35)
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
    c23 = c[23]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    # intermediate terms (129)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * c3
    w4 = rod_theta_dot**2
    w5 = ca.sin(rod_theta)
    w6 = rod_q1 * c9
    w7 = w6 + rod_q2 * c10
    w8 = rod_q2 * c12
    w9 = rod_q1 * c11 + w8
    w10 = c8 - (rod_q1 * w7 + rod_q2 * w9) * 0.5
    w11 = ca.cos(rod_theta)
    w12 = rod_q1 * c13
    w13 = w5 * w10 + w11 * w12
    w14 = w4 * w13
    w15 = rod_q1_dot * c9
    w16 = rod_q2_dot * c12
    w17 = rod_q1_dot * (w15 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + w16)
    w18 = w5 * w17
    w19 = 2 * rod_theta_dot
    w20 = w7 * rod_q1_dot + w9 * rod_q2_dot
    w21 = rod_q1_dot * c13
    w22 = w11 * w20 + w5 * w21
    w23 = w19 * w22
    w24 = w10 * w11 - w5 * w12
    w25 = rod_q1_dot * c6
    w26 = rod_q2_dot * c7
    w27 = rod_q1_dot * w25 + rod_q2_dot * w26
    w28 = w5 * w27
    w29 = rod_q1 * c6
    w30 = rod_q2 * c7
    w31 = rod_q1_dot * w29 + rod_q2_dot * w30
    w32 = w11 * w31
    w33 = w19 * w32
    w34 = rod_length - (rod_q1 * w29 + rod_q2 * w30) * 0.5
    w35 = w5 * w34
    w36 = w4 * w35
    w37 = ca.sin(crank_theta) * crank_tip_x
    w38 = w1 * w37
    w39 = w28 + w33 + w36 + w38
    w40 = w11 * w34
    w41 = w39 / w40
    w42 = w24 * w41
    w43 = rod_theta_dot * -2.0
    w44 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w45 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w46 = rod_q1_dot * w44 + rod_q2_dot * w45
    w47 = c14 + (rod_q1 * w44 + rod_q2 * w45)
    w48 = w5 * w31
    w49 = w19 * w48
    w50 = w11 * w27
    w51 = w4 * w40
    w52 = w35 * w41
    w53 = (w49 - (w50 + w51) - w2 - w52) * slider_mass
    w54 = (w43 * w46 - (w2 * w13 - w24 * w38 + w41 * w47) + w35 * w53) / w40
    w55 = w4 * w24
    w56 = w11 * w21 - w5 * w20
    w57 = w19 * w56
    w58 = w11 * w17
    w59 = w13 * w41
    w60 = w0 * w3 - (w37 * (w14 + w18 + w23 - (w42 - w38 * c3) - w54) + w0 * (w55 + w57 + w58 + (w3 + w59) - w53))
    w61 = w35 * slider_mass
    w62 = w13 + w61
    w63 = w0 * w24 + w37 * w62
    w64 = 2 * w32 + w19 * w35
    w65 = w11 * w29
    w66 = w11 * w30
    w67 = rod_q1_dot * w65 + rod_theta_dot * w35 + rod_q2_dot * w66
    w68 = w0 / w40
    w69 = (crank_theta_dot * w37 - w67 * w68) / w40
    w70 = w52 + (w51 + (w50 - w49))
    w71 = (w2 + w64 * w69 - w68 * w70) / w40
    w72 = (2 * w48 - w19 * w40) * slider_mass
    w73 = w0 * (w13 * w19 + 2 * w22) - w37 * (w19 * w24 + 2 * w56 - w72)
    w74 = (w39 - (w33 + (w28 + w36))) * slider_mass
    w75 = w0 * (w59 + (w57 + (w55 + w58))) - w37 * (w42 - (w18 + (w14 + w23)) + w74)
    w76 = w2 * w24
    w77 = w47 + w35 * w61
    w78 = w46 * -2.0 + w35 * w72
    w79 = w35 * w54 - (w76 + w13 * w38) + w40 * w53 - w35 * w74
    w80 = w76 + w38 * w62 - w71 * w77 + w69 * w78 - w68 * w79
    w81 = w11 * c13
    w82 = w2 * (w81 - w5 * w7)
    w83 = w5 * c13
    w84 = w7 * w11 + w83
    w85 = w65 * slider_mass
    w86 = c21 + w35 * w85
    w87 = w19 * w44 + w65 * w72
    w88 = w54 * w65
    w89 = w5 * w29
    w90 = w53 * w89
    w91 = w88 - (w82 + w38 * w84) - w90 - w65 * w74
    w92 = w89 / w40
    w93 = w9 * w11
    w94 = w66 * slider_mass
    w95 = w2 * (w5 * w9)
    w96 = c22 + w35 * w94
    w97 = w19 * w45 + w66 * w72
    w98 = w54 * w66
    w99 = w5 * w30
    w100 = w53 * w99
    w101 = w95 - w38 * w93 + w98 - w100 - w66 * w74
    w102 = w99 / w40
    w103 = (w6 + w7 + rod_q2 * c11) * 0.5
    w104 = w81 - w5 * w103
    w105 = w15 + rod_q2_dot * c11
    w106 = w83 + w11 * w103
    w107 = (w41 * w89 + (w19 * (w5 * w25) + w4 * w65)) * slider_mass
    w108 = w0 * (w4 * w104 + w19 * (w11 * w105) + w41 * w106) - w37 * (w41 * w104 - (w4 * w106 + w19 * (w5 * w105)) - w107)
    w109 = w5 * c6
    w110 = (rod_q1_dot * w109 + rod_theta_dot * w65 + w67 * w92) / w40
    w111 = (w41 * w65 + (w19 * (w11 * w25) - w4 * w89) + w64 * w110 + w70 * w92) / w40
    w112 = w43 * (rod_q1_dot * c28 - rod_q2_dot * c19) - (w41 * (w44 + rod_q1 * c28 - rod_q2 * c19) + (w38 * w106 + w2 * w104))
    w113 = w88 + w112 - w90 + w35 * w107 - w77 * w111 + w78 * w110 + w79 * w92
    w114 = w4 * c28 - c23 - (w38 * (w5 * c9) + w2 * (w11 * c9)) + w54 * w109 + w53 * (w11 * c6) + w65 * w107
    w115 = w66 * w107 - (w2 * (w11 * c11) + w38 * (w5 * c11) + w4 * c19) - w96 * w111 + w97 * w110 + w92 * w101
    w116 = w16 + rod_q1_dot * c10
    w117 = (rod_q1 * c10 + (w8 + w9)) * 0.5
    w118 = w5 * w117
    w119 = w11 * w117
    w120 = (w41 * w99 + (w19 * (w5 * w26) + w4 * w66)) * slider_mass
    w121 = w0 * (w19 * (w11 * w116) - w4 * w118 + w41 * w119) + w37 * (w4 * w119 + w19 * (w5 * w116) + w41 * w118 + w120)
    w122 = w5 * c7
    w123 = (rod_theta_dot * w66 + rod_q2_dot * w122 + w67 * w102) / w40
    w124 = (w41 * w66 + (w19 * (w11 * w26) - w4 * w99) + w64 * w123 + w70 * w102) / w40
    w125 = w43 * (rod_q2_dot * c29 - rod_q1_dot * c17) - (w38 * w119 - w2 * w118 + w41 * (w45 + rod_q2 * c29 - rod_q1 * c17))
    w126 = w98 + w125 - w100 + w35 * w120 - w77 * w124 + w78 * w123 + w79 * w102
    w127 = w65 * w120 - (w38 * (w5 * c10) + w2 * (w11 * c10) + w4 * c17) - w86 * w124 + w87 * w123 + w91 * w102
    w128 = w4 * c29 - c24 - (w2 * (w11 * c12) + w38 * (w5 * c12)) + w54 * w122 + w53 * (w11 * c7) + w66 * w120
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # crank.theta
            w60 + w37 * (w38 * c5) - w63 * w71 + w69 * w73 - w68 * w75 - w68 * w80,
            w108 - w63 * w111 + w73 * w110 + w75 * w92 - w68 * w113,
            w121 - w63 * w124 + w73 * w123 + w75 * w102 - w68 * w126,
        ),
        ca.horzcat(  # rod.q1
            w82 + w38 * (w84 + w85) - w71 * w86 + w69 * w87 - w68 * w91 + w80 * w92,
            w114 - w86 * w111 + w87 * w110 + w91 * w92 + w92 * w113, w127 + w92 * w126,
        ),
        ca.horzcat(  # rod.q2
            w38 * (w93 + w94) - w95 - w71 * w96 + w69 * w97 - w68 * w101 + w80 * w102, w115 + w102 * w113,
            w128 - w96 * w124 + w97 * w123 + w101 * w102 + w102 * w126,
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    274 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 35)
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
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
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
    w50 = rod_q1_dot * c32 + rod_q2_dot * c33
    w51 = (w26 * w41 - w5 * (rod_q1_dot * c30)) * slider_mass
    w52 = 2 * ((rod_q1_dot * (w9 * c6) + w20 * rod_theta_dot + w22 * w42) / w23)
    w53 = rod_theta_dot * -2.0
    w54 = w31 * w53 + w16 * w51 - w33 * w52 + w34 * w42
    w55 = w0 * (w9 * w50 + w26 * w37) - w1 * (w26 * w36 + w5 * w50 - w51) - w19 * w52 + w30 * w42 - w24 * w54
    w56 = rod_q2_dot * c34 + rod_q1_dot * c33
    w57 = (w26 * w43 - w5 * (rod_q2_dot * c31)) * slider_mass
    w58 = 2 * ((rod_theta_dot * w21 + rod_q2_dot * (w9 * c7) + w22 * w44) / w23)
    w59 = w32 * w53 + w16 * w57 - w33 * w58 + w34 * w44
    w60 = w0 * (w9 * w56 + w26 * w46) - w1 * (w5 * w56 - w26 * w45 - w57) - w19 * w58 + w30 * w44 - w24 * w59
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(w0 * (w3 * c3) - w1 * (w4 * c5) - w19 * w25 - w24 * w30 - w24 * w35, w55, w60),  # crank.theta
        ca.horzcat(  # rod.q1
            w3 * w36 - w4 * (w37 + w38) - w25 * w39 - w24 * w40 + w35 * w42,
            w20 * w51 - w39 * w52 + w40 * w42 + w42 * w54, w20 * w57 - w39 * w58 + w40 * w44 + w42 * w59,
        ),
        ca.horzcat(  # rod.q2
            w35 * w44 - (w3 * w45 + w4 * (w46 + w47) + w25 * w48 + w24 * w49),
            w21 * w51 - w48 * w52 + w42 * w49 + w44 * w54, w21 * w57 - w48 * w58 + w44 * w49 + w44 * w59,
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
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 3 x 3) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    724 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 35)
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
    c23 = c[23]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    # intermediate terms (171)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = crank_theta_dot**2
    w3 = crank_theta_ddot * w1 + w0 * w2
    w4 = w3 * c3
    w5 = rod_theta_dot**2
    w6 = ca.sin(rod_theta)
    w7 = rod_q1 * c9
    w8 = w7 + rod_q2 * c10
    w9 = rod_q2 * c12
    w10 = rod_q1 * c11 + w9
    w11 = c8 - (rod_q1 * w8 + rod_q2 * w10) * 0.5
    w12 = ca.cos(rod_theta)
    w13 = rod_q1 * c13
    w14 = w6 * w11 + w12 * w13
    w15 = w5 * w14
    w16 = rod_q1_dot * c9
    w17 = w16 + rod_q2_dot * c10
    w18 = rod_q2_dot * c12
    w19 = rod_q1_dot * c11 + w18
    w20 = rod_q1_dot * w17 + rod_q2_dot * w19
    w21 = w6 * w20
    w22 = 2 * rod_theta_dot
    w23 = w8 * rod_q1_dot + w10 * rod_q2_dot
    w24 = rod_q1_dot * c13
    w25 = w12 * w23 + w6 * w24
    w26 = w22 * w25
    w27 = w1 * w2
    w28 = w0 * crank_theta_ddot - w27
    w29 = w11 * w12 - w6 * w13
    w30 = rod_q1_dot * c6
    w31 = rod_q2_dot * c7
    w32 = rod_q1_dot * w30 + rod_q2_dot * w31
    w33 = w6 * w32
    w34 = rod_q1 * c6
    w35 = rod_q2 * c7
    w36 = rod_q1_dot * w34 + rod_q2_dot * w35
    w37 = w12 * w36
    w38 = w22 * w37
    w39 = rod_length - (rod_q1 * w34 + rod_q2 * w35) * 0.5
    w40 = w6 * w39
    w41 = w5 * w40
    w42 = w12 * w39
    w43 = w0 / w42
    w44 = w6 * w34
    w45 = w44 / w42
    w46 = w6 * w35
    w47 = w46 / w42
    w48 = (w27 + (w33 + w38 + w41)) / w42 - crank_theta_ddot * w43 + w45 * rod_q1_ddot + w47 * rod_q2_ddot
    w49 = w29 * w48
    w50 = w12 * c13
    w51 = w50 - w6 * w8
    w52 = rod_q1_ddot * w51
    w53 = w6 * w10
    w54 = rod_q2_ddot * w53
    w55 = rod_theta_dot * -2.0
    w56 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w57 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w58 = rod_q1_dot * w56 + rod_q2_dot * w57
    w59 = c14 + (rod_q1 * w56 + rod_q2 * w57)
    w60 = w6 * w36
    w61 = w22 * w60
    w62 = w12 * w32
    w63 = w5 * w42
    w64 = w40 * w48
    w65 = w12 * w34
    w66 = rod_q1_ddot * w65
    w67 = w12 * w35
    w68 = rod_q2_ddot * w67
    w69 = (w61 - (w62 + w63) - w3 - w64 - w66 - w68) * slider_mass
    w70 = w55 * w58 - (w28 * w29 + w3 * w14 + w48 * w59 + rod_q1_ddot * c21 + rod_q2_ddot * c22) + w40 * w69
    w71 = w70 / w42
    w72 = w5 * w29
    w73 = w12 * w24 - w6 * w23
    w74 = w22 * w73
    w75 = w12 * w20
    w76 = w14 * w48
    w77 = w6 * c13
    w78 = w8 * w12 + w77
    w79 = rod_q1_ddot * w78
    w80 = w10 * w12
    w81 = rod_q2_ddot * w80
    w82 = w1 * (w15 + w21 + w26 - (w28 * c3 + w49 + w52 - w54) - w71) + w0 * (w72 + w74 + w75 + (w4 + w76 + w79 + w81) - w69)
    w83 = w40 * slider_mass
    w84 = w14 + w83
    w85 = w0 * w29 + w1 * w84
    w86 = 2 * w37 + w22 * w40
    w87 = rod_q1_dot * w65 + rod_theta_dot * w40 + rod_q2_dot * w67
    w88 = (w1 * crank_theta_dot - w43 * w87) / w42
    w89 = w68 + (w64 + w66) + (w63 + (w62 - w61))
    w90 = (w3 + w86 * w88 - w43 * w89) / w42
    w91 = (2 * w60 - w22 * w42) * slider_mass
    w92 = w0 * (w14 * w22 + 2 * w25) - w1 * (w22 * w29 + 2 * w73 - w91)
    w93 = (w42 * w48 - w44 * rod_q1_ddot - w46 * rod_q2_ddot - (w38 + (w33 + w41))) * slider_mass
    w94 = w0 * (w74 + (w72 + w75) + (w81 + (w76 + w79))) - w1 * (w93 - (w21 + (w15 + w26) + (w54 - (w49 + w52))))
    w95 = w3 * w29
    w96 = w59 + w40 * w83
    w97 = w58 * -2.0 + w40 * w91
    w98 = w14 * w28 - w95 + w40 * w71 + w42 * w69 - w40 * w93
    w99 = w95 - w28 * w84 - w90 * w96 + w88 * w97 - w43 * w98
    w100 = w3 * w51
    w101 = w65 * slider_mass
    w102 = w78 + w101
    w103 = c21 + w40 * w101
    w104 = w22 * w56 + w65 * w91
    w105 = w65 * w71
    w106 = w44 * w69
    w107 = w28 * w78 - w100 + w105 - w106 - w65 * w93
    w108 = w22 * w57 + w67 * w91
    w109 = w3 * w53
    w110 = w67 * slider_mass
    w111 = w80 + w110
    w112 = c22 + w40 * w110
    w113 = w67 * w71
    w114 = w46 * w69
    w115 = w109 + w28 * w80 + w113 - w114 - w67 * w93
    w116 = (w7 + w8 + rod_q2 * c11) * 0.5
    w117 = w50 - w6 * w116
    w118 = rod_q2_dot * c11
    w119 = w16 + w118
    w120 = w77 + w12 * w116
    w121 = w6 * c9
    w122 = w6 * c11
    w123 = w12 * c9
    w124 = w12 * c11
    w125 = w12 * c6
    w126 = (rod_q1_ddot * w125 - w44 * w48 - (w22 * (w6 * w30) + w5 * w65)) * slider_mass
    w127 = w1 * (w48 * w117 + rod_q1_ddot * w123 + rod_q2_ddot * w124 - (w5 * w120 + w22 * (w6 * w119)) + w126)
    w128 = w0 * (w5 * w117 + w22 * (w12 * w119) + (w48 * w120 + rod_q1_ddot * w121 + rod_q2_ddot * w122)) - w127
    w129 = w6 * c6
    w130 = (rod_q1_dot * w129 + rod_theta_dot * w65 + w45 * w87) / w42
    w131 = (rod_q1_ddot * w129 + w48 * w65 + (w22 * (w12 * w30) - w5 * w44) + w86 * w130 + w45 * w89) / w42
    w132 = w55 * (rod_q1_dot * c28 - rod_q2_dot * c19) - (w48 * (w56 + rod_q1 * c28 - rod_q2 * c19) - (w28 * w120 - w3 * w117))
    w133 = w105 + w132 - w106 - w40 * w126 - w96 * w131 + w97 * w130 + w45 * w98
    w134 = w5 * c28 - c23 + (w28 * w121 - w3 * w123) + w71 * w129 + w69 * w125 - w65 * w126 - w103 * w131 + w104 * w130
    w135 = w28 * w122 - w3 * w124 - w5 * c19 - w67 * w126 - w112 * w131 + w108 * w130 + w45 * w115 + w47 * w133
    w136 = rod_q1_dot * c10
    w137 = w18 + w136
    w138 = (rod_q1 * c10 + (w9 + w10)) * 0.5
    w139 = w6 * w138
    w140 = w12 * w138
    w141 = w6 * c10
    w142 = w6 * c12
    w143 = w12 * c7
    w144 = (rod_q2_ddot * w143 - w46 * w48 - (w22 * (w6 * w31) + w5 * w67)) * slider_mass
    w145 = w12 * c10
    w146 = w12 * c12
    w147 = w1 * (w144 - (w5 * w140 + w22 * (w6 * w137) + (w48 * w139 - rod_q1_ddot * w145 - rod_q2_ddot * w146)))
    w148 = w0 * (w22 * (w12 * w137) - w5 * w139 + (w48 * w140 + rod_q1_ddot * w141 + rod_q2_ddot * w142)) - w147
    w149 = w6 * c7
    w150 = (rod_theta_dot * w67 + rod_q2_dot * w149 + w47 * w87) / w42
    w151 = (w48 * w67 + rod_q2_ddot * w149 + (w22 * (w12 * w31) - w5 * w46) + w86 * w150 + w47 * w89) / w42
    w152 = w55 * (rod_q2_dot * c29 - rod_q1_dot * c17) - (w48 * (w57 + rod_q2 * c29 - rod_q1 * c17) - (w3 * w139 + w28 * w140))
    w153 = w113 + w152 - w114 - w40 * w144 - w96 * w151 + w97 * w150 + w47 * w98
    w154 = w28 * w141 - w3 * w145 - w5 * c17 - w65 * w144 - w103 * w151 + w104 * w150 + w47 * w107 + w45 * w153
    w155 = w5 * c29 - c24 + (w28 * w142 - w3 * w146) + w71 * w149 + w69 * w143 - w67 * w144 - w112 * w151 + w108 * w150
    w156 = 2 * crank_theta_dot
    w157 = w1 * w156
    w158 = w0 * w156
    w159 = 2 * w88
    w160 = w29 * w157 - w84 * w158 - w96 * w159 - w43 * w97
    w161 = w118 + (w16 + w17)
    w162 = (w22 * w44 - w12 * (2 * w30)) * slider_mass
    w163 = 2 * w130
    w164 = w55 * w56 + w40 * w162 - w96 * w163 + w45 * w97
    w165 = w0 * (w6 * w161 + w22 * w78) - w1 * (w22 * w51 + w12 * w161 - w162) - w85 * w163 + w45 * w92 - w43 * w164
    w166 = w136 + (w18 + w19)
    w167 = (w22 * w46 - w12 * (2 * w31)) * slider_mass
    w168 = 2 * w150
    w169 = w55 * w57 + w40 * w167 - w96 * w168 + w47 * w97
    w170 = w0 * (w6 * w166 + w22 * w80) - w1 * (w12 * w166 - w22 * w53 - w167) - w85 * w168 + w47 * w92 - w43 * w169
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * w4 - w82 - w1 * (w28 * c5) - w85 * w90 + w88 * w92 - w43 * w94 - w43 * w99,
            w128 - w85 * w131 + w92 * w130 + w45 * w94 - w43 * w133,
            w148 - w85 * w151 + w92 * w150 + w47 * w94 - w43 * w153,
        ),
        ca.horzcat(  # rod.q1
            w100 - w28 * w102 - w90 * w103 + w88 * w104 - w43 * w107 + w45 * w99, w134 + w45 * w107 + w45 * w133,
            w154,
        ),
        ca.horzcat(  # rod.q2
            w88 * w108 - (w109 + w28 * w111 + w90 * w112) - w43 * w115 + w47 * w99, w135,
            w155 + w47 * w115 + w47 * w153,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w157 * c3) - w1 * (w158 * c5) - w85 * w159 - w43 * w92 - w43 * w160, w165, w170,
        ),
        ca.horzcat(  # rod.q1
            w51 * w157 - w102 * w158 - w103 * w159 - w43 * w104 + w45 * w160,
            w65 * w162 - w103 * w163 + w45 * w104 + w45 * w164, w65 * w167 - w103 * w168 + w47 * w104 + w45 * w169,
        ),
        ca.horzcat(  # rod.q2
            w47 * w160 - (w53 * w157 + w111 * w158 + w112 * w159 + w43 * w108),
            w67 * w162 - w112 * w163 + w45 * w108 + w47 * w164, w67 * w167 - w112 * w168 + w47 * w108 + w47 * w169,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 3 x 2) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 2 x 2) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 2 x 2) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 35)
    c23 = c[23]
    c24 = c[24]
    # outputs
    B = ca.SX(3, 2)
    # rod.q1
    B[1, 0] = 1.0
    # rod.q2
    B[2, 1] = 1.0
    K_s = ca.SX(2, 2)
    K_s[0, 0] = c23
    K_s[1, 1] = c24
    D_s = ca.SX(2, 2)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 2) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 2) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 2) [N, N m]: part of Q_hat of S
    237 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 35)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_inertia = c[0]
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
    c23 = c[23]
    c24 = c[24]
    # intermediate terms (54)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta)
    w3 = rod_q1 * c6
    w4 = rod_q2 * c7
    w5 = rod_length - (rod_q1 * w3 + rod_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = w0 / w6
    w8 = rod_q1 * c9 + rod_q2 * c10
    w9 = rod_q1 * c11 + rod_q2 * c12
    w10 = c8 - (rod_q1 * w8 + rod_q2 * w9) * 0.5
    w11 = ca.sin(rod_theta)
    w12 = rod_q1 * c13
    w13 = w2 * w10 - w11 * w12
    w14 = w10 * w11 + w2 * w12
    w15 = w5 * w11
    w16 = w15 * slider_mass
    w17 = w0 * w13 + w1 * (w14 + w16)
    w18 = rod_q1 * c15 - (rod_q1 * c16 + rod_q2 * c17)
    w19 = rod_q2 * c18 - (rod_q1 * c19 + rod_q2 * c20)
    w20 = c14 + (rod_q1 * w18 + rod_q2 * w19)
    w21 = w20 + w15 * w16
    w22 = w2 * c13 - w8 * w11
    w23 = w2 * w8 + w11 * c13
    w24 = w2 * w3
    w25 = w24 * slider_mass
    w26 = w3 * w11 / w6
    w27 = c21 + w15 * w25
    w28 = w27 + w21 * w26
    w29 = w0 * w22 + w1 * (w23 + w25) + (w17 * w26 - w7 * w28)
    w30 = w2 * w9
    w31 = w2 * w4
    w32 = w31 * slider_mass
    w33 = w9 * w11
    w34 = w4 * w11 / w6
    w35 = c22 + w15 * w32
    w36 = w35 + w21 * w34
    w37 = w1 * (w30 + w32) - w0 * w33 + (w17 * w34 - w7 * w36)
    w38 = w24 * w32 + (w26 * w36 + w27 * w34)
    w39 = rod_theta_dot**2
    w40 = rod_q1_dot * (rod_q1_dot * c9 + rod_q2_dot * c10) + rod_q2_dot * (rod_q1_dot * c11 + rod_q2_dot * c12)
    w41 = 2 * rod_theta_dot
    w42 = w8 * rod_q1_dot + w9 * rod_q2_dot
    w43 = rod_q1_dot * c13
    w44 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w45 = w3 * rod_q1_dot + w4 * rod_q2_dot
    w46 = crank_theta_dot**2
    w47 = w1 * w46
    w48 = (w11 * w44 + w41 * (w2 * w45) + w15 * w39 + w47) / w6
    w49 = w0 * w46
    w50 = (w41 * (w11 * w45) - (w2 * w44 + w6 * w39) - w49 - w15 * w48) * slider_mass
    w51 = w0 * (w14 * w39 + w11 * w40 + w41 * (w2 * w42 + w11 * w43) - (w13 * w48 - w47 * c3)) - w1 * (w13 * w39 + w41 * (w2 * w43 - w11 * w42) + w2 * w40 + (w49 * c3 + w14 * w48) - w50)
    w52 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot) - (w14 * w49 - w13 * w47 + w20 * w48)
    w53 = w52 + w15 * w50
    # outputs
    M_hat_LL = ca.vertcat(crank_inertia + w0 * (w0 * c3) + w1 * (w1 * c5) - (w7 * (w17 - w7 * w21) + w7 * w17))
    M_hat_LS = ca.horzcat(
        w29, w37,
    )
    M_hat_SL = ca.vertcat(w29, w37)
    M_hat_SS = ca.vertcat(
        ca.horzcat(c15 + w24 * w25 + (w26 * w28 + w26 * w27), w38),  # rod.q1
        ca.horzcat(w38, c18 + w31 * w32 + (w34 * w36 + w34 * w35)),  # rod.q2
    )
    Q_hat_L = ca.vertcat(w51 - w7 * w53)
    Q_hat_S = ca.vertcat(
        w18 * w39 - rod_q1 * c23 - (w23 * w49 - w22 * w47 + w48 * c21) + w24 * w50 + w26 * w53,  # rod.q1
        w19 * w39 - rod_q2 * c24 - (w30 * w49 + w33 * w47 + w48 * c22) + w31 * w50 + w34 * w53,  # rod.q2
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 35) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 2) [N, N m]: right-hand side of a sub-step, slow q'' given
    168 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 35)
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
    c23 = c[23]
    c24 = c[24]
    # intermediate terms (41)
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
    w23 = crank_theta_dot**2
    w24 = ca.cos(crank_theta) * crank_tip_x
    w25 = ca.sin(crank_theta) * crank_tip_x
    w26 = w23 * w24 + w25 * crank_theta_ddot
    w27 = w23 * w25
    w28 = w24 * crank_theta_ddot - w27
    w29 = rod_q1_dot * (rod_q1_dot * c6) + rod_q2_dot * (rod_q2_dot * c7)
    w30 = 2 * rod_theta_dot
    w31 = w1 * rod_q1_dot + w5 * rod_q2_dot
    w32 = (w27 + (w4 * w29 + w30 * (w0 * w31) + w9 * w21)) / w7 - crank_theta_ddot * (w24 / w7)
    w33 = w11 * w21 - rod_q1 * c23 - ((w0 * w22 + w4 * c13) * w26 + (w0 * c13 - w4 * w22) * w28 + w32 * c21)
    w34 = (w30 * (w4 * w31) - (w0 * w29 + w7 * w21) - w26 - w9 * w32) * slider_mass
    w35 = rod_q1 * c11 + rod_q2 * c12
    w36 = c8 - (rod_q1 * w22 + rod_q2 * w35) * 0.5
    w37 = rod_q1 * c13
    w38 = rod_theta_dot * -2.0 * (w11 * rod_q1_dot + w12 * rod_q2_dot) - (w26 * (w4 * w36 + w0 * w37) + w28 * (w0 * w36 - w4 * w37) + w13 * w32)
    w39 = w38 + w9 * w34
    w40 = w12 * w21 - rod_q2 * c24 - (w26 * (w0 * w35) - w28 * (w4 * w35) + w32 * c22) + w15 * w34 + w18 * w39
    # outputs
    M_hat_SS = ca.vertcat(
        ca.horzcat(c15 + w2 * w3 + (w8 * (w10 + w8 * w14) + w8 * w10), w20),  # rod.q1
        ca.horzcat(w20, c18 + w15 * w16 + (w18 * w19 + w17 * w18)),  # rod.q2
    )
    rhs_S = ca.vertcat(w33 + w2 * w34 + w8 * w39, w40)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 164) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 23) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 23) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 38) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 38) [1/m]: rotation at a drawn point by each mode of its body
    gives H (1 x entries = 1 x 68) [1/m]: foreshortening of the drawn points that have it, nf x nf each
    gives sections (2 x beams = 2) [m]: height and width of a rectangle that stands for a beam's section
    gives rigidities (2 x beams = 2) [N m^2]: E I of a beam for bending along y and along z
    113 operations.
    """
    p = ca.SX.sym("p", 164)
    rod_length = p[2]
    rod_area = p[4]
    rod_youngs_modulus = p[5]
    rod_second_moment = p[6]
    crank_tip_x = p[26]
    beam_pinned_pinned2_0_0_slope_0_0 = p[27]
    beam_pinned_pinned2_0_0_slope_1_0 = p[28]
    beam_pinned_pinned2_1_0_slope_0_0 = p[29]
    beam_pinned_pinned2_1_0_slope_1_0 = p[30]
    beam_pinned_pinned2_1_0_H_0_0 = p[31]
    beam_pinned_pinned2_1_0_H_1_1 = p[32]
    beam_pinned_pinned2_0_0625_at_0_0 = p[33]
    beam_pinned_pinned2_0_0625_shape_1_0 = p[34]
    beam_pinned_pinned2_0_0625_shape_1_1 = p[35]
    beam_pinned_pinned2_0_0625_slope_0_0 = p[36]
    beam_pinned_pinned2_0_0625_slope_1_0 = p[37]
    beam_pinned_pinned2_0_0625_H_0_0 = p[38]
    beam_pinned_pinned2_0_0625_H_0_1 = p[39]
    beam_pinned_pinned2_0_0625_H_1_0 = p[40]
    beam_pinned_pinned2_0_0625_H_1_1 = p[41]
    beam_pinned_pinned2_0_125_at_0_0 = p[42]
    beam_pinned_pinned2_0_125_shape_1_0 = p[43]
    beam_pinned_pinned2_0_125_shape_1_1 = p[44]
    beam_pinned_pinned2_0_125_slope_0_0 = p[45]
    beam_pinned_pinned2_0_125_slope_1_0 = p[46]
    beam_pinned_pinned2_0_125_H_0_0 = p[47]
    beam_pinned_pinned2_0_125_H_0_1 = p[48]
    beam_pinned_pinned2_0_125_H_1_0 = p[49]
    beam_pinned_pinned2_0_125_H_1_1 = p[50]
    beam_pinned_pinned2_0_1875_at_0_0 = p[51]
    beam_pinned_pinned2_0_1875_shape_1_0 = p[52]
    beam_pinned_pinned2_0_1875_shape_1_1 = p[53]
    beam_pinned_pinned2_0_1875_slope_0_0 = p[54]
    beam_pinned_pinned2_0_1875_slope_1_0 = p[55]
    beam_pinned_pinned2_0_1875_H_0_0 = p[56]
    beam_pinned_pinned2_0_1875_H_0_1 = p[57]
    beam_pinned_pinned2_0_1875_H_1_0 = p[58]
    beam_pinned_pinned2_0_1875_H_1_1 = p[59]
    beam_pinned_pinned2_0_25_at_0_0 = p[60]
    beam_pinned_pinned2_0_25_shape_1_0 = p[61]
    beam_pinned_pinned2_0_25_shape_1_1 = p[62]
    beam_pinned_pinned2_0_25_slope_0_0 = p[63]
    beam_pinned_pinned2_0_25_H_0_0 = p[64]
    beam_pinned_pinned2_0_25_H_0_1 = p[65]
    beam_pinned_pinned2_0_25_H_1_0 = p[66]
    beam_pinned_pinned2_0_25_H_1_1 = p[67]
    beam_pinned_pinned2_0_3125_at_0_0 = p[68]
    beam_pinned_pinned2_0_3125_shape_1_0 = p[69]
    beam_pinned_pinned2_0_3125_shape_1_1 = p[70]
    beam_pinned_pinned2_0_3125_slope_0_0 = p[71]
    beam_pinned_pinned2_0_3125_slope_1_0 = p[72]
    beam_pinned_pinned2_0_3125_H_0_0 = p[73]
    beam_pinned_pinned2_0_3125_H_0_1 = p[74]
    beam_pinned_pinned2_0_3125_H_1_0 = p[75]
    beam_pinned_pinned2_0_3125_H_1_1 = p[76]
    beam_pinned_pinned2_0_375_at_0_0 = p[77]
    beam_pinned_pinned2_0_375_shape_1_0 = p[78]
    beam_pinned_pinned2_0_375_shape_1_1 = p[79]
    beam_pinned_pinned2_0_375_slope_0_0 = p[80]
    beam_pinned_pinned2_0_375_slope_1_0 = p[81]
    beam_pinned_pinned2_0_375_H_0_0 = p[82]
    beam_pinned_pinned2_0_375_H_0_1 = p[83]
    beam_pinned_pinned2_0_375_H_1_0 = p[84]
    beam_pinned_pinned2_0_375_H_1_1 = p[85]
    beam_pinned_pinned2_0_4375_at_0_0 = p[86]
    beam_pinned_pinned2_0_4375_shape_1_0 = p[87]
    beam_pinned_pinned2_0_4375_shape_1_1 = p[88]
    beam_pinned_pinned2_0_4375_slope_0_0 = p[89]
    beam_pinned_pinned2_0_4375_slope_1_0 = p[90]
    beam_pinned_pinned2_0_4375_H_0_0 = p[91]
    beam_pinned_pinned2_0_4375_H_0_1 = p[92]
    beam_pinned_pinned2_0_4375_H_1_0 = p[93]
    beam_pinned_pinned2_0_4375_H_1_1 = p[94]
    beam_pinned_pinned2_0_5_at_0_0 = p[95]
    beam_pinned_pinned2_0_5_shape_1_0 = p[96]
    beam_pinned_pinned2_0_5_slope_1_0 = p[97]
    beam_pinned_pinned2_0_5_H_0_0 = p[98]
    beam_pinned_pinned2_0_5_H_0_1 = p[99]
    beam_pinned_pinned2_0_5_H_1_0 = p[100]
    beam_pinned_pinned2_0_5_H_1_1 = p[101]
    beam_pinned_pinned2_0_5625_at_0_0 = p[102]
    beam_pinned_pinned2_0_5625_shape_1_0 = p[103]
    beam_pinned_pinned2_0_5625_shape_1_1 = p[104]
    beam_pinned_pinned2_0_5625_slope_0_0 = p[105]
    beam_pinned_pinned2_0_5625_slope_1_0 = p[106]
    beam_pinned_pinned2_0_5625_H_0_0 = p[107]
    beam_pinned_pinned2_0_5625_H_0_1 = p[108]
    beam_pinned_pinned2_0_5625_H_1_0 = p[109]
    beam_pinned_pinned2_0_5625_H_1_1 = p[110]
    beam_pinned_pinned2_0_625_at_0_0 = p[111]
    beam_pinned_pinned2_0_625_shape_1_0 = p[112]
    beam_pinned_pinned2_0_625_shape_1_1 = p[113]
    beam_pinned_pinned2_0_625_slope_0_0 = p[114]
    beam_pinned_pinned2_0_625_slope_1_0 = p[115]
    beam_pinned_pinned2_0_625_H_0_0 = p[116]
    beam_pinned_pinned2_0_625_H_0_1 = p[117]
    beam_pinned_pinned2_0_625_H_1_0 = p[118]
    beam_pinned_pinned2_0_625_H_1_1 = p[119]
    beam_pinned_pinned2_0_6875_at_0_0 = p[120]
    beam_pinned_pinned2_0_6875_shape_1_0 = p[121]
    beam_pinned_pinned2_0_6875_shape_1_1 = p[122]
    beam_pinned_pinned2_0_6875_slope_0_0 = p[123]
    beam_pinned_pinned2_0_6875_slope_1_0 = p[124]
    beam_pinned_pinned2_0_6875_H_0_0 = p[125]
    beam_pinned_pinned2_0_6875_H_0_1 = p[126]
    beam_pinned_pinned2_0_6875_H_1_0 = p[127]
    beam_pinned_pinned2_0_6875_H_1_1 = p[128]
    beam_pinned_pinned2_0_75_at_0_0 = p[129]
    beam_pinned_pinned2_0_75_shape_1_0 = p[130]
    beam_pinned_pinned2_0_75_shape_1_1 = p[131]
    beam_pinned_pinned2_0_75_slope_0_0 = p[132]
    beam_pinned_pinned2_0_75_H_0_0 = p[133]
    beam_pinned_pinned2_0_75_H_0_1 = p[134]
    beam_pinned_pinned2_0_75_H_1_0 = p[135]
    beam_pinned_pinned2_0_75_H_1_1 = p[136]
    beam_pinned_pinned2_0_8125_at_0_0 = p[137]
    beam_pinned_pinned2_0_8125_shape_1_0 = p[138]
    beam_pinned_pinned2_0_8125_shape_1_1 = p[139]
    beam_pinned_pinned2_0_8125_slope_0_0 = p[140]
    beam_pinned_pinned2_0_8125_slope_1_0 = p[141]
    beam_pinned_pinned2_0_8125_H_0_0 = p[142]
    beam_pinned_pinned2_0_8125_H_0_1 = p[143]
    beam_pinned_pinned2_0_8125_H_1_0 = p[144]
    beam_pinned_pinned2_0_8125_H_1_1 = p[145]
    beam_pinned_pinned2_0_875_at_0_0 = p[146]
    beam_pinned_pinned2_0_875_shape_1_0 = p[147]
    beam_pinned_pinned2_0_875_shape_1_1 = p[148]
    beam_pinned_pinned2_0_875_slope_0_0 = p[149]
    beam_pinned_pinned2_0_875_slope_1_0 = p[150]
    beam_pinned_pinned2_0_875_H_0_0 = p[151]
    beam_pinned_pinned2_0_875_H_0_1 = p[152]
    beam_pinned_pinned2_0_875_H_1_0 = p[153]
    beam_pinned_pinned2_0_875_H_1_1 = p[154]
    beam_pinned_pinned2_0_9375_at_0_0 = p[155]
    beam_pinned_pinned2_0_9375_shape_1_0 = p[156]
    beam_pinned_pinned2_0_9375_shape_1_1 = p[157]
    beam_pinned_pinned2_0_9375_slope_0_0 = p[158]
    beam_pinned_pinned2_0_9375_slope_1_0 = p[159]
    beam_pinned_pinned2_0_9375_H_0_0 = p[160]
    beam_pinned_pinned2_0_9375_H_0_1 = p[161]
    beam_pinned_pinned2_0_9375_H_1_0 = p[162]
    beam_pinned_pinned2_0_9375_H_1_1 = p[163]
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
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
