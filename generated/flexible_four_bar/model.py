"""Four-bar linkage with two flexible links: equations of motion, emitted by symgen from the scene `flexible_four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 crank.theta [rad], 1 coupler.q1 [m], 2 coupler.q2 [m], 3 rocker.q1 [m], 4 rocker.q2 [m]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 coupler.x [m], 3 coupler.y [m], 4 coupler.theta [rad], 5 rocker.x [m],
    6 rocker.y [m], 7 rocker.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 169) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    74 operations.
    """
    p = ca.SX.sym("p", 169)
    gravity_y = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    coupler_length = p[3]
    coupler_density = p[4]
    coupler_area = p[5]
    coupler_youngs_modulus = p[6]
    coupler_second_moment = p[7]
    beam_pinned_pinned2_kappa_lateral_0_0 = p[8]
    beam_pinned_pinned2_kappa_lateral_1_1 = p[9]
    beam_pinned_pinned2_mass_0_0 = p[10]
    beam_pinned_pinned2_mass_1_1 = p[11]
    beam_pinned_pinned2_s1_0_0 = p[12]
    beam_pinned_pinned2_i0_0_0 = p[13]
    beam_pinned_pinned2_phi_y_0_0 = p[14]
    beam_pinned_pinned2_xi_phi_y_0_0 = p[15]
    beam_pinned_pinned2_xi_phi_y_1_0 = p[16]
    beam_pinned_pinned2_H_0_0 = p[17]
    beam_pinned_pinned2_H_0_1 = p[18]
    beam_pinned_pinned2_H_1_0 = p[19]
    beam_pinned_pinned2_H_1_1 = p[20]
    beam_pinned_pinned2_xH_0_0 = p[21]
    beam_pinned_pinned2_xH_0_1 = p[22]
    beam_pinned_pinned2_xH_1_0 = p[23]
    beam_pinned_pinned2_xH_1_1 = p[24]
    rocker_length = p[25]
    rocker_density = p[26]
    rocker_area = p[27]
    rocker_youngs_modulus = p[28]
    rocker_second_moment = p[29]
    crank_tip_x = p[30]
    beam_pinned_pinned2_1_0_H_0_0 = p[35]
    beam_pinned_pinned2_1_0_H_1_1 = p[36]
    ground_right_x = p[37]
    # intermediate terms (29)
    w0 = coupler_density * coupler_area
    w1 = w0 * coupler_length
    w2 = rocker_density * rocker_area
    w3 = rocker_length * w2
    w4 = rocker_length**2
    w5 = w3 * beam_pinned_pinned2_mass_0_0
    w6 = w3 * beam_pinned_pinned2_xH_0_0
    w7 = w3 * beam_pinned_pinned2_mass_1_1
    w8 = w3 * beam_pinned_pinned2_xH_1_1
    w9 = coupler_length * w1
    w10 = w0 * beam_pinned_pinned2_H_0_0
    w11 = w0 * beam_pinned_pinned2_H_0_1
    w12 = w0 * beam_pinned_pinned2_H_1_0
    w13 = w0 * beam_pinned_pinned2_H_1_1
    w14 = w1 * beam_pinned_pinned2_phi_y_0_0
    w15 = coupler_length**2
    w16 = w1 * beam_pinned_pinned2_mass_0_0
    w17 = w1 * beam_pinned_pinned2_xH_0_0
    w18 = w1 * beam_pinned_pinned2_mass_1_1
    w19 = w1 * beam_pinned_pinned2_xH_1_1
    w20 = rocker_length * w3
    w21 = w2 * beam_pinned_pinned2_H_0_0
    w22 = w2 * beam_pinned_pinned2_H_0_1
    w23 = w2 * beam_pinned_pinned2_H_1_0
    w24 = w2 * beam_pinned_pinned2_H_1_1
    w25 = w3 * beam_pinned_pinned2_phi_y_0_0
    w26 = coupler_youngs_modulus * coupler_second_moment / (coupler_length * w15)
    w27 = rocker_youngs_modulus * rocker_second_moment / (rocker_length * w4)
    w28 = gravity_y * crank_mass
    # outputs
    c = ca.vertcat(
        crank_tip_x,  # crank_tip_x
        coupler_length,  # coupler_length
        w1,  # c2
        crank_inertia + crank_tip_x * (crank_tip_x * w1),  # c3
        beam_pinned_pinned2_1_0_H_0_0 / coupler_length,  # c4
        beam_pinned_pinned2_1_0_H_1_1 / coupler_length,  # c5
        rocker_length,  # rocker_length
        beam_pinned_pinned2_1_0_H_0_0 / rocker_length,  # c7
        beam_pinned_pinned2_1_0_H_1_1 / rocker_length,  # c8
        w3 * w4 * beam_pinned_pinned2_i0_0_0,  # c9
        w5,  # c10
        w6,  # c11
        w3 * beam_pinned_pinned2_xH_0_1,  # c12
        w7,  # c13
        w3 * beam_pinned_pinned2_xH_1_0,  # c14
        w8,  # c15
        w9 * beam_pinned_pinned2_s1_0_0,  # c16
        w10,  # c17
        w11,  # c18
        w12,  # c19
        w13,  # c20
        w14,  # c21
        beam_pinned_pinned2_i0_0_0 * (w1 * w15),  # c22
        w16,  # c23
        w17,  # c24
        w1 * beam_pinned_pinned2_xH_0_1,  # c25
        w18,  # c26
        w1 * beam_pinned_pinned2_xH_1_0,  # c27
        w19,  # c28
        w9 * beam_pinned_pinned2_xi_phi_y_0_0,  # c29
        w9 * beam_pinned_pinned2_xi_phi_y_1_0,  # c30
        beam_pinned_pinned2_xi_phi_y_0_0 * w20,  # c31
        beam_pinned_pinned2_xi_phi_y_1_0 * w20,  # c32
        gravity_y,  # gravity_y
        w1 * gravity_y,  # c34
        beam_pinned_pinned2_s1_0_0 * w20,  # c35
        w21,  # c36
        w22,  # c37
        w23,  # c38
        w24,  # c39
        w25,  # c40
        w26 * beam_pinned_pinned2_kappa_lateral_0_0,  # c41
        w26 * beam_pinned_pinned2_kappa_lateral_1_1,  # c42
        beam_pinned_pinned2_kappa_lateral_0_0 * w27,  # c43
        beam_pinned_pinned2_kappa_lateral_1_1 * w27,  # c44
        ground_right_x,  # ground_right_x
        crank_inertia,  # crank_inertia
        w3,  # c47
        crank_mass,  # crank_mass
        w28,  # c49
        w3 * gravity_y,  # c50
        -w14,  # c51
        -w25,  # c52
        -w28,  # c53
        w16 - w17,  # c54
        w18 - w19,  # c55
        w5 - w6,  # c56
        gravity_y * w21,  # c57
        gravity_y * w23,  # c58
        w7 - w8,  # c59
        gravity_y * w22,  # c60
        gravity_y * w24,  # c61
        w10 + w10,  # c62
        w11 + w12,  # c63
        w13 + w13,  # c64
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 5 x 5) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 5) [N, N m]: condensed force S^T (Q* - M s)
    430 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (89)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.sin(coupler_theta)
    w3 = coupler_q1 * c4
    w4 = coupler_q2 * c5
    w5 = coupler_length - (coupler_q1 * w3 + coupler_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = ca.cos(coupler_theta)
    w8 = w5 * w7
    w9 = ca.cos(rocker_theta)
    w10 = rocker_q1 * c7
    w11 = rocker_q2 * c8
    w12 = rocker_length - (rocker_q1 * w10 + rocker_q2 * w11) * 0.5
    w13 = w9 * w12
    w14 = ca.sin(rocker_theta)
    w15 = w12 * w14
    w16 = w6 * w13 - w8 * w15
    w17 = (w0 * w6 - w1 * w8) / w16
    w18 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w19 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w20 = c9 + (rocker_q1 * w18 + rocker_q2 * w19)
    w21 = (w0 * w15 - w1 * w13) / w16
    w22 = coupler_q1 * c17 + coupler_q2 * c18
    w23 = coupler_q1 * c19 + coupler_q2 * c20
    w24 = c16 - (coupler_q1 * w22 + coupler_q2 * w23) * 0.5
    w25 = coupler_q1 * c21
    w26 = w7 * w24 - w2 * w25
    w27 = w2 * w24 + w7 * w25
    w28 = w0 * w26 + w1 * w27
    w29 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w30 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w31 = c22 + (coupler_q1 * w29 + coupler_q2 * w30)
    w32 = w7 * c21 - w2 * w22
    w33 = w7 * w22 + w2 * c21
    w34 = coupler_q1 * w5 * c4 / w16
    w35 = w20 * w34
    w36 = (w13 * (w3 * w7) + w15 * (w2 * w3)) / w16
    w37 = c29 - w31 * w36
    w38 = w0 * w32 + w1 * w33 - w17 * w35 + (w21 * w37 - w28 * w36)
    w39 = w7 * w23
    w40 = w2 * w23
    w41 = coupler_q2 * w5 * c5 / w16
    w42 = w20 * w41
    w43 = (w13 * (w4 * w7) + w15 * (w2 * w4)) / w16
    w44 = c30 - w31 * w43
    w45 = w1 * w39 - w0 * w40 - w17 * w42 + (w21 * w44 - w28 * w43)
    w46 = (w8 * (w9 * w10) + w6 * (w10 * w14)) / w16
    w47 = c31 + w20 * w46
    w48 = rocker_q1 * w12 * c7 / w16
    w49 = w31 * w48
    w50 = w17 * w47 + (w21 * w49 + w28 * w48)
    w51 = (w8 * (w9 * w11) + w6 * (w11 * w14)) / w16
    w52 = c32 + w20 * w51
    w53 = rocker_q2 * w12 * c8 / w16
    w54 = w31 * w53
    w55 = w17 * w52 + (w21 * w54 + w28 * w53)
    w56 = w34 * w42 - (w36 * w44 + w43 * c29)
    w57 = w48 * c29 - w36 * w49 - w34 * w47
    w58 = w53 * c29 - w36 * w54 - w34 * w52
    w59 = w48 * c30 - w43 * w49 - w41 * w47
    w60 = w53 * c30 - w43 * w54 - w41 * w52
    w61 = w46 * w52 + w51 * c31 + w48 * w54
    w62 = coupler_theta_dot**2
    w63 = coupler_q1_dot * (coupler_q1_dot * c17 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + coupler_q2_dot * c20)
    w64 = 2 * coupler_theta_dot
    w65 = w22 * coupler_q1_dot + w23 * coupler_q2_dot
    w66 = coupler_q1_dot * c21
    w67 = w3 * coupler_q1_dot + w4 * coupler_q2_dot
    w68 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w69 = 2 * rocker_theta_dot
    w70 = w10 * rocker_q1_dot + w11 * rocker_q2_dot
    w71 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w72 = rocker_theta_dot**2
    w73 = crank_theta_dot**2
    w74 = w0 * w73
    w75 = w64 * (w2 * w67) - (w7 * w68 + w8 * w62) - (w69 * (w14 * w70) - (w9 * w71 + w13 * w72)) - w74
    w76 = w1 * w73
    w77 = w14 * w71 + w69 * (w9 * w70) + w15 * w72 - (w2 * w68 + w64 * (w7 * w67) + w6 * w62) - w76
    w78 = (w13 * w75 + w15 * w77) / w16
    w79 = w0 * (w27 * w62 + w2 * w63 + w64 * (w7 * w65 + w2 * w66) + c34 - (w26 * w78 - w76 * c2)) - w1 * (w26 * w62 + w64 * (w7 * w66 - w2 * w65) + w7 * w63 + (w74 * c2 + w27 * w78))
    w80 = rocker_q1 * c36 + rocker_q2 * c37
    w81 = rocker_q1 * c38 + rocker_q2 * c39
    w82 = rocker_theta_dot * -2.0 * (w18 * rocker_q1_dot + w19 * rocker_q2_dot) + (w9 * (c35 - (rocker_q1 * w80 + rocker_q2 * w81) * 0.5) - w14 * (rocker_q1 * c40)) * gravity_y
    w83 = (w8 * w75 + w6 * w77) / w16
    w84 = w82 - w20 * w83
    w85 = coupler_theta_dot * -2.0 * (w29 * coupler_q1_dot + w30 * coupler_q2_dot) + w26 * gravity_y - (w27 * w74 - w26 * w76 + w31 * w78)
    w86 = w29 * w62 - coupler_q1 * c41 + w32 * gravity_y - (w33 * w74 - w32 * w76 + w78 * c29) - w34 * w84 - w36 * w85
    w87 = w30 * w62 - coupler_q2 * c42 - w40 * gravity_y - (w39 * w74 + w40 * w76 + w78 * c30) - w41 * w84 - w43 * w85
    w88 = w18 * w72 - rocker_q1 * c43 + (w9 * c40 - w14 * w80) * gravity_y - w83 * c31 + w46 * w84 + w48 * w85
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(c3 + w17 * (w17 * w20) + (w21 * (w28 + w21 * w31) + w21 * w28), w38, w45, w50, w55),  # crank.theta
        ca.horzcat(w38, c23 + w34 * w35 - (w36 * w37 + w36 * c29), w56, w57, w58),  # coupler.q1
        ca.horzcat(w45, w56, c26 + w41 * w42 - (w43 * w44 + w43 * c30), w59, w60),  # coupler.q2
        ca.horzcat(w50, w57, w59, c10 + (w46 * w47 + w46 * c31) + w48 * w49, w61),  # rocker.q1
        ca.horzcat(w55, w58, w60, w61, c13 + (w51 * w52 + w51 * c32) + w53 * w54),  # rocker.q2
    )
    Q_hat = ca.vertcat(
        w79 + w17 * w84 + w21 * w85,  # crank.theta
        w86,  # coupler.q1
        w87,  # coupler.q2
        w88,  # rocker.q1
        w19 * w72 - rocker_q2 * c44 - w14 * w81 * gravity_y - w83 * c32 + w51 * w84 + w53 * w85,  # rocker.q2
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 2) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    44 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
    c7 = c[7]
    c8 = c[8]
    ground_right_x = c[45]
    # intermediate terms (11)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = rocker_length - (rocker_q1 * (rocker_q1 * c7) + rocker_q2 * (rocker_q2 * c8)) * 0.5
    w3 = ca.cos(rocker_theta) * w2
    w4 = coupler_length - (coupler_q1 * (coupler_q1 * c4) + coupler_q2 * (coupler_q2 * c5)) * 0.5
    w5 = ca.cos(coupler_theta) * w4
    w6 = w3 + ground_right_x - (w0 + w5)
    w7 = w2 * ca.sin(rocker_theta)
    w8 = w4 * ca.sin(coupler_theta)
    w9 = w7 - (w1 + w8)
    w10 = w3 * w8 - w5 * w7
    # outputs
    q_d_next = ca.SX(8, 1)
    q_d_next[2] = w0  # coupler.x
    q_d_next[3] = w1  # coupler.y
    q_d_next[4] = coupler_theta - (w3 * w6 + w7 * w9) / w10  # coupler.theta
    q_d_next[5] = ground_right_x  # rocker.x
    q_d_next[7] = rocker_theta - (w5 * w6 + w8 * w9) / w10  # rocker.theta
    C_loop = ca.vertcat(w6, w9)
    det_loop = ca.vertcat(w10)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    94 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
    c7 = c[7]
    c8 = c[8]
    # intermediate terms (21)
    w0 = ca.sin(crank_theta) * crank_tip_x
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(rocker_theta)
    w3 = rocker_q1 * c7
    w4 = rocker_q2 * c8
    w5 = rocker_length - (rocker_q1 * w3 + rocker_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = ca.cos(rocker_theta)
    w8 = w5 * w7
    w9 = ca.sin(coupler_theta)
    w10 = coupler_q1 * c4
    w11 = coupler_q2 * c5
    w12 = coupler_length - (coupler_q1 * w10 + coupler_q2 * w11) * 0.5
    w13 = w9 * w12
    w14 = ca.cos(coupler_theta)
    w15 = w12 * w14
    w16 = w8 * w13 - w6 * w15
    w17 = crank_theta_dot * ((w1 * w6 - w0 * w8) / w16) - (w8 * (w10 * w14) + w6 * (w9 * w10)) / w16 * coupler_q1_dot
    w18 = w17 - (w8 * (w11 * w14) + w6 * (w9 * w11)) / w16 * coupler_q2_dot + rocker_q1 * w5 * c7 / w16 * rocker_q1_dot
    w19 = crank_theta_dot * ((w1 * w13 - w0 * w15) / w16) - coupler_q1_dot * (coupler_q1 * w12 * c4 / w16) - coupler_q2_dot * (coupler_q2 * w12 * c5 / w16)
    w20 = w19 + rocker_q1_dot * ((w15 * (w3 * w7) + w13 * (w2 * w3)) / w16) + rocker_q2_dot * ((w15 * (w4 * w7) + w13 * (w2 * w4)) / w16)
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[2] = -(w0 * crank_theta_dot)  # coupler.x
    q_d_dot[3] = crank_theta_dot * w1  # coupler.y
    q_d_dot[4] = w18 + rocker_q2 * w5 * c8 / w16 * rocker_q2_dot  # coupler.theta
    q_d_dot[7] = w20  # rocker.theta
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 5) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    157 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_i_ddot[0]
    coupler_q1_ddot = q_i_ddot[1]
    coupler_q2_ddot = q_i_ddot[2]
    rocker_q1_ddot = q_i_ddot[3]
    rocker_q2_ddot = q_i_ddot[4]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
    c7 = c[7]
    c8 = c[8]
    # intermediate terms (34)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = w0 * w1
    w3 = ca.sin(crank_theta) * crank_tip_x
    w4 = w0 * w3
    w5 = ca.cos(rocker_theta)
    w6 = rocker_q1 * c7
    w7 = rocker_q2 * c8
    w8 = rocker_length - (rocker_q1 * w6 + rocker_q2 * w7) * 0.5
    w9 = w5 * w8
    w10 = 2 * coupler_theta_dot
    w11 = ca.sin(coupler_theta)
    w12 = coupler_q1 * c4
    w13 = coupler_q2 * c5
    w14 = w12 * coupler_q1_dot + w13 * coupler_q2_dot
    w15 = ca.cos(coupler_theta)
    w16 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w17 = coupler_theta_dot**2
    w18 = coupler_length - (coupler_q1 * w12 + coupler_q2 * w13) * 0.5
    w19 = w15 * w18
    w20 = 2 * rocker_theta_dot
    w21 = ca.sin(rocker_theta)
    w22 = w6 * rocker_q1_dot + w7 * rocker_q2_dot
    w23 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w24 = rocker_theta_dot**2
    w25 = w10 * (w11 * w14) - (w15 * w16 + w17 * w19) - (w20 * (w21 * w22) - (w5 * w23 + w9 * w24)) - w2
    w26 = w8 * w21
    w27 = w11 * w18
    w28 = w21 * w23 + w20 * (w5 * w22) + w24 * w26 - (w11 * w16 + w10 * (w14 * w15) + w17 * w27) - w4
    w29 = w9 * w27 - w19 * w26
    w30 = (w9 * w25 + w26 * w28) / w29 + crank_theta_ddot * ((w1 * w26 - w3 * w9) / w29) - (w9 * (w12 * w15) + w26 * (w11 * w12)) / w29 * coupler_q1_ddot
    w31 = w30 - (w9 * (w13 * w15) + w26 * (w11 * w13)) / w29 * coupler_q2_ddot + rocker_q1 * w8 * c7 / w29 * rocker_q1_ddot
    w32 = (w19 * w25 + w27 * w28) / w29 + crank_theta_ddot * ((w1 * w27 - w3 * w19) / w29) - coupler_q1_ddot * (coupler_q1 * w18 * c4 / w29)
    w33 = w32 - coupler_q2_ddot * (coupler_q2 * w18 * c5 / w29) + rocker_q1_ddot * ((w19 * (w5 * w6) + w27 * (w6 * w21)) / w29)
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[2] = -(w2 + w3 * crank_theta_ddot)  # coupler.x
    q_d_ddot[3] = w1 * crank_theta_ddot - w4  # coupler.y
    q_d_ddot[4] = w31 + rocker_q2 * w8 * c8 / w29 * rocker_q2_ddot  # coupler.theta
    q_d_ddot[7] = w33 + rocker_q2_ddot * ((w19 * (w5 * w7) + w27 * (w7 * w21)) / w29)  # rocker.theta
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    103 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 65)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    coupler_q1 = q[6]
    coupler_q2 = q[7]
    rocker_x = q[8]
    rocker_y = q[9]
    rocker_theta = q[10]
    rocker_q1 = q[11]
    rocker_q2 = q[12]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    coupler_q1_dot = q_dot[6]
    coupler_q2_dot = q_dot[7]
    rocker_theta_dot = q_dot[10]
    rocker_q1_dot = q_dot[11]
    rocker_q2_dot = q_dot[12]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
    c7 = c[7]
    c8 = c[8]
    ground_right_x = c[45]
    # intermediate terms (25)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rocker_theta)
    w3 = rocker_q1 * c7
    w4 = rocker_q2 * c8
    w5 = rocker_length - (rocker_q1 * w3 + rocker_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = ca.cos(coupler_theta)
    w8 = coupler_q1 * c4
    w9 = coupler_q2 * c5
    w10 = coupler_length - (coupler_q1 * w8 + coupler_q2 * w9) * 0.5
    w11 = w7 * w10
    w12 = ca.sin(rocker_theta)
    w13 = w5 * w12
    w14 = ca.sin(coupler_theta)
    w15 = w10 * w14
    w16 = crank_theta_dot**2
    w17 = 2 * coupler_theta_dot
    w18 = w8 * coupler_q1_dot + w9 * coupler_q2_dot
    w19 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w20 = coupler_theta_dot**2
    w21 = 2 * rocker_theta_dot
    w22 = w3 * rocker_q1_dot + w4 * rocker_q2_dot
    w23 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w24 = rocker_theta_dot**2
    # outputs
    C = ca.vertcat(
        crank_x,  # A.x
        crank_y,  # A.y
        coupler_x - (crank_x + w0),  # B.x
        coupler_y - (crank_y + w1),  # B.y
        rocker_x + w6 - (coupler_x + w11),  # C.x
        rocker_y + w13 - (coupler_y + w15),  # C.y
        rocker_x - ground_right_x,  # D.x
        rocker_y,  # D.y
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
    # C.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w15
    C_q[4, 6] = w7 * w8
    C_q[4, 7] = w7 * w9
    C_q[4, 8] = 1.0
    C_q[4, 10] = -w13
    C_q[4, 11] = -(w2 * w3)
    C_q[4, 12] = -(w2 * w4)
    # C.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w11
    C_q[5, 6] = w8 * w14
    C_q[5, 7] = w9 * w14
    C_q[5, 9] = 1.0
    C_q[5, 10] = w6
    C_q[5, 11] = -(w3 * w12)
    C_q[5, 12] = -(w4 * w12)
    # D.x
    C_q[6, 8] = 1.0
    # D.y
    C_q[7, 9] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[2] = -(w0 * w16)  # B.x
    gamma[3] = -(w1 * w16)  # B.y
    gamma[4] = w17 * (w14 * w18) - (w7 * w19 + w11 * w20) - (w21 * (w12 * w22) - (w2 * w23 + w6 * w24))  # C.x
    gamma[5] = w12 * w23 + w21 * (w2 * w22) + w13 * w24 - (w14 * w19 + w17 * (w7 * w18) + w15 * w20)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 13 x 13) [SI]: mass matrix in all coordinates
    gives K (n x n = 13 x 13) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 13) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 13) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 13) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    274 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 65)
    crank_theta = q[2]
    coupler_theta = q[5]
    coupler_q1 = q[6]
    coupler_q2 = q[7]
    rocker_theta = q[10]
    rocker_q1 = q[11]
    rocker_q2 = q[12]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    coupler_q1_dot = q_dot[6]
    coupler_q2_dot = q_dot[7]
    rocker_theta_dot = q_dot[10]
    rocker_q1_dot = q_dot[11]
    rocker_q2_dot = q_dot[12]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    crank_inertia = c[46]
    c47 = c[47]
    crank_mass = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    # intermediate terms (75)
    w0 = ca.sin(coupler_theta)
    w1 = coupler_q1 * c17 + coupler_q2 * c18
    w2 = coupler_q1 * c19 + coupler_q2 * c20
    w3 = c16 - (coupler_q1 * w1 + coupler_q2 * w2) * 0.5
    w4 = ca.cos(coupler_theta)
    w5 = coupler_q1 * c21
    w6 = w0 * w3 + w4 * w5
    w7 = -w6
    w8 = -(w2 * w4)
    w9 = w3 * w4 - w0 * w5
    w10 = w4 * c21 - w0 * w1
    w11 = w0 * w2
    w12 = -w11
    w13 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w14 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w15 = ca.sin(rocker_theta)
    w16 = rocker_q1 * c36 + rocker_q2 * c37
    w17 = rocker_q1 * c38 + rocker_q2 * c39
    w18 = c35 - (rocker_q1 * w16 + rocker_q2 * w17) * 0.5
    w19 = ca.cos(rocker_theta)
    w20 = rocker_q1 * c40
    w21 = w15 * w18 + w19 * w20
    w22 = -w21
    w23 = -(w17 * w19)
    w24 = w18 * w19 - w15 * w20
    w25 = w19 * c40 - w15 * w16
    w26 = w15 * w17
    w27 = -w26
    w28 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w29 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w30 = coupler_theta_dot**2
    w31 = 2 * coupler_theta_dot
    w32 = coupler_q1_dot * c21
    w33 = w1 * coupler_q1_dot + w2 * coupler_q2_dot
    w34 = coupler_q1_dot * (coupler_q1_dot * c17 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + coupler_q2_dot * c20)
    w35 = w9 * w30 + w31 * (w4 * w32 - w0 * w33) + w4 * w34
    w36 = w6 * w30 + w0 * w34 + w31 * (w4 * w33 + w0 * w32)
    w37 = coupler_theta_dot * -2.0 * (w13 * coupler_q1_dot + w14 * coupler_q2_dot)
    w38 = w13 * w30
    w39 = w14 * w30
    w40 = rocker_theta_dot**2
    w41 = 2 * rocker_theta_dot
    w42 = rocker_q1_dot * c40
    w43 = w16 * rocker_q1_dot + w17 * rocker_q2_dot
    w44 = rocker_q1_dot * (rocker_q1_dot * c36 + rocker_q2_dot * c37) + rocker_q2_dot * (rocker_q1_dot * c38 + rocker_q2_dot * c39)
    w45 = w24 * w40 + w41 * (w19 * w42 - w15 * w43) + w19 * w44
    w46 = w21 * w40 + w15 * w44 + w41 * (w19 * w43 + w15 * w42)
    w47 = rocker_theta_dot * -2.0 * (w28 * rocker_q1_dot + w29 * rocker_q2_dot)
    w48 = w28 * w40
    w49 = w29 * w40
    w50 = w9 * gravity_y
    w51 = w10 * gravity_y
    w52 = w11 * gravity_y
    w53 = w24 * gravity_y
    w54 = w25 * gravity_y
    w55 = w26 * gravity_y
    w56 = ca.sin(crank_theta) * crank_tip_x
    w57 = ca.cos(crank_theta) * crank_tip_x
    w58 = coupler_q1 * c4
    w59 = coupler_q2 * c5
    w60 = coupler_length - (coupler_q1 * w58 + coupler_q2 * w59) * 0.5
    w61 = w0 * w60
    w62 = w4 * w60
    w63 = rocker_q1 * c7
    w64 = rocker_q2 * c8
    w65 = rocker_length - (rocker_q1 * w63 + rocker_q2 * w64) * 0.5
    w66 = w15 * w65
    w67 = w19 * w65
    w68 = crank_theta_dot**2
    w69 = coupler_q1_dot * w58 + coupler_q2_dot * w59
    w70 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w71 = rocker_q1_dot * w63 + rocker_q2_dot * w64
    w72 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w73 = w0 * c51 - w1 * w4
    w74 = w15 * c52 - w16 * w19
    # outputs
    M = ca.SX(13, 13)
    # crank.x
    M[0, 0] = crank_mass
    # crank.y
    M[1, 1] = crank_mass
    # crank.theta
    M[2, 2] = crank_inertia
    # coupler.x
    M[3, 3] = c2
    M[3, 5] = w7
    M[3, 6] = w73
    M[3, 7] = w8
    # coupler.y
    M[4, 4] = c2
    M[4, 5] = w9
    M[4, 6] = w10
    M[4, 7] = w12
    # coupler.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c22 + (coupler_q1 * w13 + coupler_q2 * w14)
    M[5, 6] = c29
    M[5, 7] = c30
    # coupler.q1
    M[6, 3] = w73
    M[6, 4] = w10
    M[6, 5] = c29
    M[6, 6] = c23
    # coupler.q2
    M[7, 3] = w8
    M[7, 4] = w12
    M[7, 5] = c30
    M[7, 7] = c26
    # rocker.x
    M[8, 8] = c47
    M[8, 10] = w22
    M[8, 11] = w74
    M[8, 12] = w23
    # rocker.y
    M[9, 9] = c47
    M[9, 10] = w24
    M[9, 11] = w25
    M[9, 12] = w27
    # rocker.theta
    M[10, 8] = w22
    M[10, 9] = w24
    M[10, 10] = c9 + (rocker_q1 * w28 + rocker_q2 * w29)
    M[10, 11] = c31
    M[10, 12] = c32
    # rocker.q1
    M[11, 8] = w74
    M[11, 9] = w25
    M[11, 10] = c31
    M[11, 11] = c10
    # rocker.q2
    M[12, 8] = w23
    M[12, 9] = w27
    M[12, 10] = c32
    M[12, 12] = c13
    K = ca.SX(13, 13)
    # coupler.q1
    K[6, 6] = c41
    # coupler.q2
    K[7, 7] = c42
    # rocker.q1
    K[11, 11] = c43
    # rocker.q2
    K[12, 12] = c44
    Q_v = ca.vertcat(
        0.0,  # crank.x
        0.0,  # crank.y
        0.0,  # crank.theta
        w35,  # coupler.x
        w36,  # coupler.y
        w37,  # coupler.theta
        w38,  # coupler.q1
        w39,  # coupler.q2
        w45,  # rocker.x
        w46,  # rocker.y
        w47,  # rocker.theta
        w48,  # rocker.q1
        w49,  # rocker.q2
    )
    Q_F = ca.vertcat(
        0.0,  # crank.x
        c49,  # crank.y
        0.0,  # crank.theta
        0.0,  # coupler.x
        c34,  # coupler.y
        w50,  # coupler.theta
        w51,  # coupler.q1
        -w52,  # coupler.q2
        0.0,  # rocker.x
        c50,  # rocker.y
        w53,  # rocker.theta
        w54,  # rocker.q1
        -w55,  # rocker.q2
    )
    Q_star = ca.vertcat(
        0.0,  # crank.x
        c49,  # crank.y
        0.0,  # crank.theta
        w35,  # coupler.x
        c34 + w36,  # coupler.y
        w37 + w50,  # coupler.theta
        w51 + (w38 - coupler_q1 * c41),  # coupler.q1
        w39 - coupler_q2 * c42 - w52,  # coupler.q2
        w45,  # rocker.x
        w46 + c50,  # rocker.y
        w47 + w53,  # rocker.theta
        w54 + (w48 - rocker_q1 * c43),  # rocker.q1
        w49 - rocker_q2 * c44 - w55,  # rocker.q2
    )
    C_q = ca.SX(8, 13)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w56
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w57
    C_q[3, 4] = 1.0
    # C.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w61
    C_q[4, 6] = w4 * w58
    C_q[4, 7] = w4 * w59
    C_q[4, 8] = 1.0
    C_q[4, 10] = -w66
    C_q[4, 11] = -(w19 * w63)
    C_q[4, 12] = -(w19 * w64)
    # C.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w62
    C_q[5, 6] = w0 * w58
    C_q[5, 7] = w0 * w59
    C_q[5, 9] = 1.0
    C_q[5, 10] = w67
    C_q[5, 11] = -(w15 * w63)
    C_q[5, 12] = -(w15 * w64)
    # D.x
    C_q[6, 8] = 1.0
    # D.y
    C_q[7, 9] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w57 * w68)  # B.x
    gamma[3] = -(w56 * w68)  # B.y
    gamma[4] = w31 * (w0 * w69) - (w4 * w70 + w30 * w62) - (w41 * (w15 * w71) - (w19 * w72 + w40 * w67))  # C.x
    gamma[5] = w15 * w72 + w41 * (w19 * w71) + w40 * w66 - (w0 * w70 + w31 * (w4 * w69) + w30 * w61)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes q_ddot (n = 13) [mixed]: accelerations of all coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    260 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 65)
    coupler_theta = q[5]
    coupler_q1 = q[6]
    coupler_q2 = q[7]
    rocker_theta = q[10]
    rocker_q1 = q[11]
    rocker_q2 = q[12]
    coupler_theta_dot = q_dot[5]
    coupler_q1_dot = q_dot[6]
    coupler_q2_dot = q_dot[7]
    rocker_theta_dot = q_dot[10]
    rocker_q1_dot = q_dot[11]
    rocker_q2_dot = q_dot[12]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    coupler_x_ddot = q_ddot[3]
    coupler_y_ddot = q_ddot[4]
    coupler_theta_ddot = q_ddot[5]
    coupler_q1_ddot = q_ddot[6]
    coupler_q2_ddot = q_ddot[7]
    rocker_x_ddot = q_ddot[8]
    rocker_y_ddot = q_ddot[9]
    rocker_theta_ddot = q_ddot[10]
    rocker_q1_ddot = q_ddot[11]
    rocker_q2_ddot = q_ddot[12]
    coupler_length = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c47 = c[47]
    crank_mass = c[48]
    c49 = c[49]
    c50 = c[50]
    # intermediate terms (53)
    w0 = coupler_theta_dot**2
    w1 = ca.cos(coupler_theta)
    w2 = coupler_q1 * c17 + coupler_q2 * c18
    w3 = coupler_q1 * c19 + coupler_q2 * c20
    w4 = c16 - (coupler_q1 * w2 + coupler_q2 * w3) * 0.5
    w5 = ca.sin(coupler_theta)
    w6 = coupler_q1 * c21
    w7 = w1 * w4 - w5 * w6
    w8 = 2 * coupler_theta_dot
    w9 = coupler_q1_dot * c21
    w10 = w2 * coupler_q1_dot + w3 * coupler_q2_dot
    w11 = coupler_q1_dot * (coupler_q1_dot * c17 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + coupler_q2_dot * c20)
    w12 = w4 * w5 + w1 * w6
    w13 = coupler_x_ddot * c2 - w12 * coupler_theta_ddot - (w1 * w2 + w5 * c21) * coupler_q1_ddot - w1 * w3 * coupler_q2_ddot
    w14 = ca.cos(rocker_theta)
    w15 = rocker_length - (rocker_q1 * (rocker_q1 * c7) + rocker_q2 * (rocker_q2 * c8)) * 0.5
    w16 = w14 * w15
    w17 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w18 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w19 = w7 * coupler_y_ddot - coupler_x_ddot * w12 + coupler_theta_ddot * (c22 + (coupler_q1 * w17 + coupler_q2 * w18))
    w20 = coupler_theta_dot * -2.0 * (coupler_q1_dot * w17 + coupler_q2_dot * w18) + w7 * gravity_y - (w19 + coupler_q1_ddot * c29 + coupler_q2_ddot * c30)
    w21 = coupler_length - (coupler_q1 * (coupler_q1 * c4) + coupler_q2 * (coupler_q2 * c5)) * 0.5
    w22 = w1 * w21
    w23 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w24 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w25 = rocker_q1 * c36 + rocker_q2 * c37
    w26 = rocker_q1 * c38 + rocker_q2 * c39
    w27 = c35 - (rocker_q1 * w25 + rocker_q2 * w26) * 0.5
    w28 = ca.sin(rocker_theta)
    w29 = rocker_q1 * c40
    w30 = w14 * w27 - w28 * w29
    w31 = w27 * w28 + w14 * w29
    w32 = w30 * rocker_y_ddot - w31 * rocker_x_ddot + (c9 + (rocker_q1 * w23 + rocker_q2 * w24)) * rocker_theta_ddot
    w33 = rocker_theta_dot * -2.0 * (w23 * rocker_q1_dot + w24 * rocker_q2_dot) + w30 * gravity_y - (w32 + rocker_q1_ddot * c31 + rocker_q2_ddot * c32)
    w34 = w5 * w21
    w35 = w15 * w28
    w36 = w16 * w34 - w22 * w35
    w37 = (w16 * w20 + w22 * w33) / w36
    w38 = w0 * w7 + w8 * (w1 * w9 - w5 * w10) + w1 * w11 - w13 + w37
    w39 = w38 - crank_x_ddot * crank_mass
    w40 = coupler_y_ddot * c2 + w7 * coupler_theta_ddot + coupler_q1_ddot * (w1 * c21 - w2 * w5) - coupler_q2_ddot * (w3 * w5)
    w41 = (w20 * w35 + w33 * w34) / w36
    w42 = c34 + (w0 * w12 + w5 * w11 + w8 * (w1 * w10 + w5 * w9)) - w40 + w41
    w43 = c49 - crank_y_ddot * crank_mass + w42
    w44 = rocker_theta_dot**2
    w45 = 2 * rocker_theta_dot
    w46 = rocker_q1_dot * c40
    w47 = rocker_q1_dot * w25 + rocker_q2_dot * w26
    w48 = rocker_q1_dot * (rocker_q1_dot * c36 + rocker_q2_dot * c37) + rocker_q2_dot * (rocker_q1_dot * c38 + rocker_q2_dot * c39)
    w49 = rocker_x_ddot * c47 - w31 * rocker_theta_ddot - rocker_q1_ddot * (w14 * w25 + w28 * c40) - rocker_q2_ddot * (w14 * w26)
    w50 = w30 * w44 + w45 * (w14 * w46 - w28 * w47) + w14 * w48 - w49 - w37
    w51 = rocker_y_ddot * c47 + w30 * rocker_theta_ddot + rocker_q1_ddot * (w14 * c40 - w25 * w28) - rocker_q2_ddot * (w26 * w28)
    w52 = c50 + (w31 * w44 + w28 * w48 + w45 * (w14 * w47 + w28 * w46)) - w51 - w41
    # outputs
    lam = ca.vertcat(
        w39,  # A.x
        w43,  # A.y
        w38,  # B.x
        w42,  # B.y
        w37,  # C.x
        w41,  # C.y
        w50,  # D.x
        w52,  # D.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w39, -w43, 0.0),  # A
        ca.vertcat(-w38, -w42, 0.0),  # B
        ca.vertcat(-w37, -w41, 0.0),  # C
        ca.vertcat(-w50, -w52, 0.0),  # D
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    208 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 65)
    crank_y = q[1]
    coupler_y = q[4]
    coupler_theta = q[5]
    coupler_q1 = q[6]
    coupler_q2 = q[7]
    rocker_y = q[9]
    rocker_theta = q[10]
    rocker_q1 = q[11]
    rocker_q2 = q[12]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    coupler_x_dot = q_dot[3]
    coupler_y_dot = q_dot[4]
    coupler_theta_dot = q_dot[5]
    coupler_q1_dot = q_dot[6]
    coupler_q2_dot = q_dot[7]
    rocker_x_dot = q_dot[8]
    rocker_y_dot = q_dot[9]
    rocker_theta_dot = q_dot[10]
    rocker_q1_dot = q_dot[11]
    rocker_q2_dot = q_dot[12]
    c2 = c[2]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    crank_inertia = c[46]
    c47 = c[47]
    crank_mass = c[48]
    c53 = c[53]
    # intermediate terms (39)
    w0 = crank_x_dot * (crank_x_dot * crank_mass) + crank_y_dot * (crank_y_dot * crank_mass) + crank_theta_dot * (crank_theta_dot * crank_inertia)
    w1 = ca.sin(coupler_theta)
    w2 = coupler_q1 * c17 + coupler_q2 * c18
    w3 = coupler_q1 * c19 + coupler_q2 * c20
    w4 = c16 - (coupler_q1 * w2 + coupler_q2 * w3) * 0.5
    w5 = ca.cos(coupler_theta)
    w6 = coupler_q1 * c21
    w7 = w1 * w4 + w5 * w6
    w8 = w2 * w5 + w1 * c21
    w9 = w3 * w5
    w10 = coupler_x_dot * (coupler_x_dot * c2 - w7 * coupler_theta_dot - w8 * coupler_q1_dot - w9 * coupler_q2_dot)
    w11 = w4 * w5 - w1 * w6
    w12 = w5 * c21 - w1 * w2
    w13 = w1 * w3
    w14 = coupler_y_dot * (coupler_y_dot * c2 + coupler_theta_dot * w11 + coupler_q1_dot * w12 - coupler_q2_dot * w13)
    w15 = coupler_q1 * (coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)) + coupler_q2 * (coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28))
    w16 = coupler_y_dot * w11 - coupler_x_dot * w7 + coupler_theta_dot * (c22 + w15) + coupler_q1_dot * c29
    w17 = coupler_q1_dot * (coupler_y_dot * w12 - coupler_x_dot * w8 + coupler_theta_dot * c29 + coupler_q1_dot * c23)
    w18 = coupler_q2_dot * (coupler_theta_dot * c30 - (coupler_x_dot * w9 + coupler_y_dot * w13) + coupler_q2_dot * c26)
    w19 = ca.sin(rocker_theta)
    w20 = rocker_q1 * c36 + rocker_q2 * c37
    w21 = rocker_q1 * c38 + rocker_q2 * c39
    w22 = c35 - (rocker_q1 * w20 + rocker_q2 * w21) * 0.5
    w23 = ca.cos(rocker_theta)
    w24 = rocker_q1 * c40
    w25 = w19 * w22 + w23 * w24
    w26 = w20 * w23 + w19 * c40
    w27 = w21 * w23
    w28 = rocker_x_dot * (rocker_x_dot * c47 - w25 * rocker_theta_dot - w26 * rocker_q1_dot - w27 * rocker_q2_dot)
    w29 = w22 * w23 - w19 * w24
    w30 = w23 * c40 - w19 * w20
    w31 = w19 * w21
    w32 = rocker_y_dot * (rocker_y_dot * c47 + rocker_theta_dot * w29 + rocker_q1_dot * w30 - rocker_q2_dot * w31)
    w33 = rocker_q1 * (rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)) + rocker_q2 * (rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15))
    w34 = rocker_y_dot * w29 - rocker_x_dot * w25 + rocker_theta_dot * (c9 + w33) + rocker_q1_dot * c31 + rocker_q2_dot * c32
    w35 = w0 + w10 + w14 + coupler_theta_dot * (w16 + coupler_q2_dot * c30) + w17 + w18 + w28 + w32 + rocker_theta_dot * w34
    w36 = rocker_q1_dot * (rocker_y_dot * w30 - rocker_x_dot * w26 + rocker_theta_dot * c31 + rocker_q1_dot * c10)
    w37 = rocker_q2_dot * (rocker_theta_dot * c32 - (rocker_x_dot * w27 + rocker_y_dot * w31) + rocker_q2_dot * c13)
    w38 = (coupler_q1 * (coupler_q1 * c41) + coupler_q2 * (coupler_q2 * c42)) / 2.0 + (rocker_q1 * (rocker_q1 * c43) + rocker_q2 * (rocker_q2 * c44)) / 2.0
    # outputs
    kinetic = ca.vertcat((w35 + w36 + w37) / 2.0)
    elastic = ca.vertcat(w38)
    potential = ca.vertcat(crank_y * c53 - (w7 + coupler_y * c2 + (w25 + rocker_y * c47)) * gravity_y)
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
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[8]
    rocker_y = q[9]
    rocker_theta = q[10]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(coupler_theta)
    w3 = ca.sin(coupler_theta)
    w4 = ca.cos(rocker_theta)
    w5 = ca.sin(rocker_theta)
    # outputs
    poses = ca.SX(12, 3)
    poses[0, 0] = crank_x
    poses[0, 1] = coupler_x
    poses[0, 2] = rocker_x
    poses[1, 0] = crank_y
    poses[1, 1] = coupler_y
    poses[1, 2] = rocker_y
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
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i, through q_d
    1171 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (244)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * c2
    w4 = coupler_theta_dot**2
    w5 = ca.sin(coupler_theta)
    w6 = coupler_q1 * c17
    w7 = w6 + coupler_q2 * c18
    w8 = coupler_q2 * c20
    w9 = coupler_q1 * c19 + w8
    w10 = c16 - (coupler_q1 * w7 + coupler_q2 * w9) * 0.5
    w11 = ca.cos(coupler_theta)
    w12 = coupler_q1 * c21
    w13 = w5 * w10 + w11 * w12
    w14 = w4 * w13
    w15 = coupler_q1_dot * c17
    w16 = coupler_q2_dot * c20
    w17 = coupler_q1_dot * (w15 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + w16)
    w18 = w5 * w17
    w19 = 2 * coupler_theta_dot
    w20 = w7 * coupler_q1_dot + w9 * coupler_q2_dot
    w21 = coupler_q1_dot * c21
    w22 = w11 * w20 + w5 * w21
    w23 = w19 * w22
    w24 = w10 * w11 - w5 * w12
    w25 = ca.cos(rocker_theta)
    w26 = rocker_q1 * c7
    w27 = rocker_q2 * c8
    w28 = rocker_length - (rocker_q1 * w26 + rocker_q2 * w27) * 0.5
    w29 = w25 * w28
    w30 = coupler_q1 * c4
    w31 = coupler_q2 * c5
    w32 = coupler_q1_dot * w30 + coupler_q2_dot * w31
    w33 = w5 * w32
    w34 = w19 * w33
    w35 = coupler_q1_dot * c4
    w36 = coupler_q2_dot * c5
    w37 = coupler_q1_dot * w35 + coupler_q2_dot * w36
    w38 = w11 * w37
    w39 = coupler_length - (coupler_q1 * w30 + coupler_q2 * w31) * 0.5
    w40 = w11 * w39
    w41 = w4 * w40
    w42 = 2 * rocker_theta_dot
    w43 = ca.sin(rocker_theta)
    w44 = w26 * rocker_q1_dot + w27 * rocker_q2_dot
    w45 = w43 * w44
    w46 = w42 * w45
    w47 = rocker_q1_dot * c7
    w48 = rocker_q2_dot * c8
    w49 = rocker_q1_dot * w47 + rocker_q2_dot * w48
    w50 = w25 * w49
    w51 = rocker_theta_dot**2
    w52 = w29 * w51
    w53 = w34 - (w38 + w41) - (w46 - (w50 + w52)) - w2
    w54 = w28 * w43
    w55 = w43 * w49
    w56 = w25 * w44
    w57 = w42 * w56
    w58 = w51 * w54
    w59 = w5 * w37
    w60 = w11 * w32
    w61 = w19 * w60
    w62 = w5 * w39
    w63 = w4 * w62
    w64 = ca.sin(crank_theta) * crank_tip_x
    w65 = w1 * w64
    w66 = w55 + w57 + w58 - (w59 + w61 + w63) - w65
    w67 = w29 * w62 - w40 * w54
    w68 = (w29 * w53 + w54 * w66) / w67
    w69 = w24 * w68
    w70 = w65 * c2
    w71 = coupler_theta_dot * -2.0
    w72 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w73 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w74 = coupler_q1_dot * w72 + coupler_q2_dot * w73
    w75 = c22 + (coupler_q1 * w72 + coupler_q2 * w73)
    w76 = w71 * w74 + w24 * gravity_y - (w2 * w13 - w24 * w65 + w68 * w75)
    w77 = rocker_theta_dot * -2.0
    w78 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w79 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w80 = rocker_q1_dot * w78 + rocker_q2_dot * w79
    w81 = rocker_q1 * c36
    w82 = w81 + rocker_q2 * c37
    w83 = rocker_q2 * c39
    w84 = rocker_q1 * c38 + w83
    w85 = c35 - (rocker_q1 * w82 + rocker_q2 * w84) * 0.5
    w86 = rocker_q1 * c40
    w87 = c9 + (rocker_q1 * w78 + rocker_q2 * w79)
    w88 = (w40 * w53 + w62 * w66) / w67
    w89 = w77 * w80 + (w25 * w85 - w43 * w86) * gravity_y - w87 * w88
    w90 = (w54 * w76 + w62 * w89) / w67
    w91 = w4 * w24
    w92 = w11 * w21 - w5 * w20
    w93 = w19 * w92
    w94 = w11 * w17
    w95 = w13 * w68
    w96 = (w29 * w76 + w40 * w89) / w67
    w97 = w0 * w3 - (w64 * (c34 + (w14 + w18 + w23) - (w69 - w70) + w90) + w0 * (w91 + w93 + w94 + (w3 + w95) + w96))
    w98 = (w0 * w62 - w40 * w64) / w67
    w99 = w40 * w68 - (w61 + (w59 + w63))
    w100 = (w0 * w54 - w29 * w64) / w67
    w101 = w19 * w40 + 2 * -w33
    w102 = w5 * w30
    w103 = w5 * w31
    w104 = coupler_theta_dot * w40 - coupler_q1_dot * w102 - coupler_q2_dot * w103
    w105 = w26 * w43
    w106 = w27 * w43
    w107 = rocker_q1_dot * w105 - w29 * rocker_theta_dot + rocker_q2_dot * w106
    w108 = w0 * crank_theta_dot + w100 * w104 + w98 * w107
    w109 = w11 * w30
    w110 = w11 * w31
    w111 = coupler_q1_dot * w109 + coupler_theta_dot * w62 + coupler_q2_dot * w110
    w112 = w25 * w26
    w113 = w25 * w27
    w114 = rocker_theta_dot * w54 + rocker_q1_dot * w112 + rocker_q2_dot * w113
    w115 = crank_theta_dot * w64 + w100 * w111 - w98 * w114
    w116 = (w29 * w108 + w54 * w115) / w67
    w117 = 2 * w45 - w29 * w42
    w118 = (w40 * w108 + w62 * w115) / w67
    w119 = w57 + (w55 + w58) - w29 * w88
    w120 = w99 * w100 - (w65 + w101 * w116) - w117 * w118 + w98 * w119
    w121 = w19 * w62 + 2 * w60
    w122 = w62 * w68 + (w41 + (w38 - w34))
    w123 = 2 * -w56 - w42 * w54
    w124 = w54 * w88 + (w52 + (w50 - w46))
    w125 = w2 - w116 * w121 + w100 * w122 - w118 * w123 - w98 * w124
    w126 = (w40 * w120 + w62 * w125) / w67
    w127 = w80 * -2.0
    w128 = w29 * w96 - (w43 * w85 + w25 * w86) * gravity_y + w54 * w90
    w129 = w87 * w126 - w118 * w127 + w98 * w128
    w130 = w0 * w24 + w13 * w64
    w131 = (w29 * w120 + w54 * w125) / w67
    w132 = w0 * (w13 * w19 + 2 * w22) - w64 * (w19 * w24 + 2 * w92)
    w133 = w0 * (w95 + (w93 + (w91 + w94))) - w64 * (w69 - (w18 + (w14 + w23)))
    w134 = w2 * w24 + w13 * w65
    w135 = w74 * -2.0
    w136 = w134 + w13 * gravity_y + w40 * w96 + w62 * w90
    w137 = w134 + w75 * w131 - w116 * w135 - w100 * w136
    w138 = w11 * c21
    w139 = w5 * c21
    w140 = w7 * w11 + w139
    w141 = w2 * (w138 - w5 * w7) + w65 * w140
    w142 = coupler_q1 * w39 * c4 / w67
    w143 = w19 * w72
    w144 = w96 * w102
    w145 = w90 * w109
    w146 = w144 - (w141 + w140 * gravity_y) - w145
    w147 = (w29 * w109 + w54 * w102) / w67
    w148 = w9 * w11
    w149 = w65 * w148
    w150 = w2 * (w5 * w9)
    w151 = coupler_q2 * w39 * c5 / w67
    w152 = w19 * w73
    w153 = w96 * w103
    w154 = w90 * w110
    w155 = w150 - w149 - w148 * gravity_y + w153 - w154
    w156 = (w29 * w110 + w54 * w103) / w67
    w157 = w42 * w78
    w158 = w90 * w112
    w159 = w43 * c40
    w160 = w96 * w105
    w161 = w158 - ((w159 + w25 * w82) * gravity_y + w160)
    w162 = (w40 * w112 + w62 * w105) / w67
    w163 = rocker_q1 * w28 * c7 / w67
    w164 = w42 * w79
    w165 = w90 * w113
    w166 = w96 * w106
    w167 = w165 - (w25 * w84 * gravity_y + w166)
    w168 = (w40 * w113 + w62 * w106) / w67
    w169 = rocker_q2 * w28 * c8 / w67
    w170 = (w6 + w7 + coupler_q2 * c19) * 0.5
    w171 = w138 - w5 * w170
    w172 = w15 + coupler_q2_dot * c19
    w173 = w139 + w11 * w170
    w174 = w0 * (w4 * w171 + w19 * (w11 * w172) + w68 * w173) - w64 * (w68 * w171 - (w4 * w173 + w19 * (w5 * w172)))
    w175 = w11 * c4
    w176 = coupler_q1_dot * w175 - coupler_theta_dot * w102 - w104 * w147 - w107 * w142
    w177 = w5 * c4
    w178 = coupler_q1_dot * w177 + coupler_theta_dot * w109 - w111 * w147 + w114 * w142
    w179 = (w29 * w176 + w54 * w178) / w67
    w180 = (w40 * w176 + w62 * w178) / w67
    w181 = w68 * w102 + (w19 * (w5 * w35) + w4 * w109) + w101 * w179 + w99 * w147 + w117 * w180 + w119 * w142
    w182 = w68 * w109 + (w19 * (w11 * w35) - w4 * w102) - w121 * w179 - w122 * w147 - w123 * w180 + w124 * w142
    w183 = (w40 * w181 - w62 * w182) / w67
    w184 = w87 * w183 + w127 * w180 + w128 * w142
    w185 = (w29 * w181 - w54 * w182) / w67
    w186 = w71 * (coupler_q1_dot * c54 - coupler_q2_dot * c27) - w173 * gravity_y - (w68 * (w72 + coupler_q1 * c54 - coupler_q2 * c27) + (w65 * w173 + w2 * w171))
    w187 = w144 + w186 - w145 - w75 * w185 - w135 * w179 + w136 * w147
    w188 = w5 * c17
    w189 = w4 * c54 - c41 - w188 * gravity_y - (w65 * w188 + w2 * (w11 * c17)) - w96 * w175 - w90 * w177 + w142 * w184
    w190 = w5 * c19
    w191 = w151 * w184 - (w2 * (w11 * c19) + w65 * w190 + (w4 * c27 + w190 * gravity_y)) - w185 * c30 - w152 * w179
    w192 = w16 + coupler_q1_dot * c18
    w193 = (coupler_q1 * c18 + (w8 + w9)) * 0.5
    w194 = w5 * w193
    w195 = w11 * w193
    w196 = w0 * (w19 * (w11 * w192) - w4 * w194 + w68 * w195) + w64 * (w4 * w195 + w19 * (w5 * w192) + w68 * w194)
    w197 = w11 * c5
    w198 = coupler_q2_dot * w197 - coupler_theta_dot * w103 - w104 * w156 - w107 * w151
    w199 = w5 * c5
    w200 = coupler_theta_dot * w110 + coupler_q2_dot * w199 - w111 * w156 + w114 * w151
    w201 = (w29 * w198 + w54 * w200) / w67
    w202 = (w40 * w198 + w62 * w200) / w67
    w203 = w68 * w103 + (w19 * (w5 * w36) + w4 * w110) + w101 * w201 + w99 * w156 + w117 * w202 + w119 * w151
    w204 = w68 * w110 + (w19 * (w11 * w36) - w4 * w103) - w121 * w201 - w122 * w156 - w123 * w202 + w124 * w151
    w205 = (w40 * w203 - w62 * w204) / w67
    w206 = w87 * w205 + w127 * w202 + w128 * w151
    w207 = (w29 * w203 - w54 * w204) / w67
    w208 = w71 * (coupler_q2_dot * c55 - coupler_q1_dot * c25) - w195 * gravity_y - (w65 * w195 - w2 * w194 + w68 * (w73 + coupler_q2 * c55 - coupler_q1 * c25))
    w209 = w153 + w208 - w154 - w75 * w207 - w135 * w201 + w136 * w156
    w210 = w5 * c18
    w211 = w142 * w206 - (w65 * w210 + w2 * (w11 * c18) + (w4 * c25 + w210 * gravity_y)) - w207 * c29 - w143 * w201
    w212 = w5 * c20
    w213 = w4 * c55 - c42 - w212 * gravity_y - (w2 * (w11 * c20) + w65 * w212) - w96 * w197 - w90 * w199 + w151 * w206
    w214 = w77 * (rocker_q1_dot * c56 - rocker_q2_dot * c14) - (w159 + w25 * ((w81 + w82 + rocker_q2 * c38) * 0.5)) * gravity_y
    w215 = w25 * c7
    w216 = rocker_theta_dot * w105 - rocker_q1_dot * w215 + w104 * w163 + w107 * w162
    w217 = w43 * c7
    w218 = w111 * w163 - (rocker_theta_dot * w112 + rocker_q1_dot * w217) - w114 * w162
    w219 = (w29 * w216 + w54 * w218) / w67
    w220 = (w40 * w216 + w62 * w218) / w67
    w221 = w88 * w105 + (w42 * (w43 * w47) + w51 * w112) - w101 * w219 + w99 * w163 - w117 * w220 + w119 * w162
    w222 = w122 * w163 - (w88 * w112 + (w42 * (w25 * w47) - w51 * w105) + w121 * w219) - w123 * w220 - w124 * w162
    w223 = (w40 * w221 + w62 * w222) / w67
    w224 = w158 + (w214 - w88 * (w78 + rocker_q1 * c56 - rocker_q2 * c14) - w160) + w87 * w223 - w127 * w220
    w225 = w224 + w128 * w162
    w226 = (w29 * w221 + w54 * w222) / w67
    w227 = w75 * w226 - w135 * w219 - w136 * w163
    w228 = w51 * c56 - c43 - w43 * c57 + w96 * w215 + w90 * w217 + w223 * c31 - w157 * w220 + w161 * w162 + w162 * w225
    w229 = w77 * (rocker_q2_dot * c59 - rocker_q1_dot * c12) - w25 * ((rocker_q1 * c37 + (w83 + w84)) * 0.5) * gravity_y
    w230 = w25 * c8
    w231 = rocker_theta_dot * w106 - rocker_q2_dot * w230 + w104 * w169 + w107 * w168
    w232 = w43 * c8
    w233 = w111 * w169 - (rocker_theta_dot * w113 + rocker_q2_dot * w232) - w114 * w168
    w234 = (w29 * w231 + w54 * w233) / w67
    w235 = (w40 * w231 + w62 * w233) / w67
    w236 = w88 * w106 + (w42 * (w43 * w48) + w51 * w113) - w101 * w234 + w99 * w169 - w117 * w235 + w119 * w168
    w237 = w122 * w169 - (w88 * w113 + (w42 * (w25 * w48) - w51 * w106) + w121 * w234) - w123 * w235 - w124 * w168
    w238 = (w40 * w236 + w62 * w237) / w67
    w239 = w165 + (w229 - w88 * (w79 + rocker_q2 * c59 - rocker_q1 * c12) - w166) + w87 * w238 - w127 * w235
    w240 = w239 + w128 * w168
    w241 = (w29 * w236 + w54 * w237) / w67
    w242 = w75 * w241 - w135 * w234 - w136 * w169
    w243 = w51 * c59 - c44 - w43 * c61 + w96 * w230 + w90 * w232 + w238 * c32 - w164 * w235 + w167 * w168 + w168 * w240
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # crank.theta
            w97 + w64 * w70 + w98 * w129 + w130 * w131 - w116 * w132 + w100 * w133 + w100 * w137,
            w174 - w98 * w184 - w130 * w185 - w132 * w179 - w133 * w147 + w100 * w187,
            w196 - w98 * w206 - w130 * w207 - w132 * w201 - w133 * w156 + w100 * w209,
            w98 * w225 + w130 * w226 - w132 * w219 + w133 * w163 + w100 * w227,
            w98 * w240 + w130 * w241 - w132 * w234 + w133 * w169 + w100 * w242,
        ),
        ca.horzcat(  # coupler.q1
            w141 - w129 * w142 + w131 * c29 - w116 * w143 + w100 * w146 - w137 * w147,
            w189 - w185 * c29 - w143 * w179 - w146 * w147 - w147 * w187, w211 - w146 * w156 - w147 * w209,
            w226 * c29 - w142 * w225 - w143 * w219 + w146 * w163 - w147 * w227,
            w241 * c29 - w142 * w240 - w143 * w234 + w146 * w169 - w147 * w242,
        ),
        ca.horzcat(  # coupler.q2
            w149 - w150 - w129 * w151 + w131 * c30 - w116 * w152 + w100 * w155 - w137 * w156,
            w191 - w147 * w155 - w156 * w187, w213 - w207 * c30 - w152 * w201 - w155 * w156 - w156 * w209,
            w226 * c30 - w151 * w225 - w152 * w219 + w155 * w163 - w156 * w227,
            w241 * c30 - w151 * w240 - w152 * w234 + w155 * w169 - w156 * w242,
        ),
        ca.horzcat(  # rocker.q1
            w126 * c31 - w118 * w157 + w98 * w161 + w129 * w162 + w137 * w163,
            w163 * w187 - (w183 * c31 + w157 * w180 + w142 * w161 + w162 * w184),
            w163 * w209 - (w205 * c31 + w157 * w202 + w151 * w161 + w162 * w206), w228 + w163 * w227,
            w238 * c31 - (w51 * c12 + w43 * c60) - w157 * w235 + w161 * w168 + w162 * w240 + w163 * w242,
        ),
        ca.horzcat(  # rocker.q2
            w126 * c32 - w118 * w164 + w98 * w167 + w129 * w168 + w137 * w169,
            w169 * w187 - (w183 * c32 + w164 * w180 + w142 * w167 + w168 * w184),
            w169 * w209 - (w205 * c32 + w164 * w202 + w151 * w167 + w168 * w206),
            w223 * c32 - (w51 * c14 + w43 * c58) - w164 * w220 + w162 * w167 + w168 * w225 + w169 * w227,
            w243 + w169 * w242,
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
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    579 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    # intermediate terms (106)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = 2 * crank_theta_dot
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = w1 * w2
    w4 = w0 * w1
    w5 = ca.sin(coupler_theta)
    w6 = coupler_q1 * c4
    w7 = coupler_q2 * c5
    w8 = coupler_length - (coupler_q1 * w6 + coupler_q2 * w7) * 0.5
    w9 = w5 * w8
    w10 = ca.cos(coupler_theta)
    w11 = w8 * w10
    w12 = ca.cos(rocker_theta)
    w13 = rocker_q1 * c7
    w14 = rocker_q2 * c8
    w15 = rocker_length - (rocker_q1 * w13 + rocker_q2 * w14) * 0.5
    w16 = w12 * w15
    w17 = ca.sin(rocker_theta)
    w18 = w15 * w17
    w19 = w9 * w16 - w11 * w18
    w20 = (w0 * w9 - w2 * w11) / w19
    w21 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w22 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w23 = (w21 * rocker_q1_dot + w22 * rocker_q2_dot) * -2.0
    w24 = c9 + (rocker_q1 * w21 + rocker_q2 * w22)
    w25 = w5 * w6
    w26 = w5 * w7
    w27 = w11 * coupler_theta_dot - coupler_q1_dot * w25 - coupler_q2_dot * w26
    w28 = (w0 * w18 - w2 * w16) / w19
    w29 = w13 * w17
    w30 = w14 * w17
    w31 = rocker_q1_dot * w29 - w16 * rocker_theta_dot + rocker_q2_dot * w30
    w32 = w0 * crank_theta_dot + w27 * w28 + w20 * w31
    w33 = w6 * w10
    w34 = w7 * w10
    w35 = coupler_q1_dot * w33 + w9 * coupler_theta_dot + coupler_q2_dot * w34
    w36 = w12 * w13
    w37 = w12 * w14
    w38 = w18 * rocker_theta_dot + rocker_q1_dot * w36 + rocker_q2_dot * w37
    w39 = crank_theta_dot * w2 + w28 * w35 - w20 * w38
    w40 = 2 * -((w11 * w32 + w9 * w39) / w19)
    w41 = w20 * w23 - w24 * w40
    w42 = coupler_q1 * c17 + coupler_q2 * c18
    w43 = coupler_q1 * c19 + coupler_q2 * c20
    w44 = c16 - (coupler_q1 * w42 + coupler_q2 * w43) * 0.5
    w45 = coupler_q1 * c21
    w46 = w10 * w44 - w5 * w45
    w47 = w5 * w44 + w10 * w45
    w48 = w0 * w46 + w2 * w47
    w49 = 2 * -((w16 * w32 + w18 * w39) / w19)
    w50 = 2 * coupler_theta_dot
    w51 = coupler_q1_dot * w42 + coupler_q2_dot * w43
    w52 = coupler_q1_dot * c21
    w53 = w0 * (w47 * w50 + 2 * (w10 * w51 + w5 * w52)) - w2 * (w46 * w50 + 2 * (w10 * w52 - w5 * w51))
    w54 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w55 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w56 = c22 + (coupler_q1 * w54 + coupler_q2 * w55)
    w57 = (coupler_q1_dot * w54 + coupler_q2_dot * w55) * -2.0
    w58 = w3 * w46 - w4 * w47 - w49 * w56 + w28 * w57
    w59 = w10 * c21 - w5 * w42
    w60 = w10 * w42 + w5 * c21
    w61 = coupler_q1 * w8 * c4 / w19
    w62 = w50 * w54
    w63 = (w16 * w33 + w18 * w25) / w19
    w64 = w50 * w55
    w65 = w5 * w43
    w66 = w10 * w43
    w67 = coupler_q2 * w8 * c5 / w19
    w68 = (w16 * w34 + w18 * w26) / w19
    w69 = 2 * rocker_theta_dot
    w70 = w21 * w69
    w71 = (w11 * w36 + w9 * w29) / w19
    w72 = rocker_q1 * w15 * c7 / w19
    w73 = w22 * w69
    w74 = (w11 * w37 + w9 * w30) / w19
    w75 = rocker_q2 * w15 * c8 / w19
    w76 = coupler_q1_dot * c62 + coupler_q2_dot * c63
    w77 = coupler_q1_dot * (w10 * c4) - coupler_theta_dot * w25 - w27 * w63 - w31 * w61
    w78 = coupler_q1_dot * (w5 * c4) + coupler_theta_dot * w33 - w35 * w63 + w38 * w61
    w79 = 2 * -((w11 * w77 + w9 * w78) / w19)
    w80 = w24 * w79 + w23 * w61
    w81 = 2 * -((w16 * w77 + w18 * w78) / w19)
    w82 = coupler_theta_dot * -2.0
    w83 = w54 * w82 - w56 * w81 - w57 * w63
    w84 = w0 * (w5 * w76 + w50 * w60) - w2 * (w50 * w59 + w10 * w76) - w20 * w80 - w48 * w81 - w53 * w63 + w28 * w83
    w85 = coupler_q2_dot * c64 + coupler_q1_dot * c63
    w86 = coupler_q2_dot * (w10 * c5) - coupler_theta_dot * w26 - w27 * w68 - w31 * w67
    w87 = coupler_theta_dot * w34 + coupler_q2_dot * (w5 * c5) - w35 * w68 + w38 * w67
    w88 = 2 * -((w11 * w86 + w9 * w87) / w19)
    w89 = w24 * w88 + w23 * w67
    w90 = 2 * -((w16 * w86 + w18 * w87) / w19)
    w91 = w55 * w82 - w56 * w90 - w57 * w68
    w92 = w0 * (w5 * w85 + w50 * w66) - w2 * (w10 * w85 - w50 * w65) - w20 * w89 - w48 * w90 - w53 * w68 + w28 * w91
    w93 = rocker_theta_dot * -2.0
    w94 = w29 * rocker_theta_dot - rocker_q1_dot * (w12 * c7) + w27 * w72 + w31 * w71
    w95 = w35 * w72 - (rocker_theta_dot * w36 + rocker_q1_dot * (w17 * c7)) - w38 * w71
    w96 = 2 * -((w11 * w94 + w9 * w95) / w19)
    w97 = w21 * w93 - w24 * w96 + w23 * w71
    w98 = 2 * -((w16 * w94 + w18 * w95) / w19)
    w99 = w57 * w72 - w56 * w98
    w100 = rocker_theta_dot * w30 - rocker_q2_dot * (w12 * c8) + w27 * w75 + w31 * w74
    w101 = w35 * w75 - (rocker_theta_dot * w37 + rocker_q2_dot * (w17 * c8)) - w38 * w74
    w102 = 2 * -((w11 * w100 + w9 * w101) / w19)
    w103 = w22 * w93 - w24 * w102 + w23 * w74
    w104 = 2 * -((w16 * w100 + w18 * w101) / w19)
    w105 = w57 * w75 - w56 * w104
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w3 * c2) - w2 * (w4 * c2) + w20 * w41 - w48 * w49 + w28 * w53 + w28 * w58, w84, w92,
            w20 * w97 - w48 * w98 + w53 * w72 + w28 * w99, w20 * w103 - w48 * w104 + w53 * w75 + w28 * w105,
        ),
        ca.horzcat(  # coupler.q1
            w3 * w59 - w4 * w60 - w41 * w61 - w49 * c29 + w28 * w62 - w58 * w63,
            w61 * w80 - w81 * c29 - w62 * w63 - w63 * w83, w61 * w89 - w90 * c29 - w62 * w68 - w63 * w91,
            w62 * w72 - (w61 * w97 + w98 * c29) - w63 * w99, w62 * w75 - (w61 * w103 + w104 * c29) - w63 * w105,
        ),
        ca.horzcat(  # coupler.q2
            w28 * w64 - (w3 * w65 + w4 * w66 + w41 * w67 + w49 * c30) - w58 * w68,
            w67 * w80 - w81 * c30 - w63 * w64 - w68 * w83, w67 * w89 - w90 * c30 - w64 * w68 - w68 * w91,
            w64 * w72 - (w67 * w97 + w98 * c30) - w68 * w99, w64 * w75 - (w67 * w103 + w104 * c30) - w68 * w105,
        ),
        ca.horzcat(  # rocker.q1
            w20 * w70 - w40 * c31 + w41 * w71 + w58 * w72, w72 * w83 - (w79 * c31 + w61 * w70 + w71 * w80),
            w72 * w91 - (w88 * c31 + w67 * w70 + w71 * w89), w70 * w71 - w96 * c31 + w71 * w97 + w72 * w99,
            w70 * w74 - w102 * c31 + w71 * w103 + w72 * w105,
        ),
        ca.horzcat(  # rocker.q2
            w20 * w73 - w40 * c32 + w41 * w74 + w58 * w75, w75 * w83 - (w79 * c32 + w61 * w73 + w74 * w80),
            w75 * w91 - (w88 * c32 + w67 * w73 + w74 * w89), w71 * w73 - w96 * c32 + w74 * w97 + w75 * w99,
            w73 * w74 - w102 * c32 + w74 * w103 + w75 * w105,
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
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 5 x 5) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1542 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_i_ddot[0]
    coupler_q1_ddot = q_i_ddot[1]
    coupler_q2_ddot = q_i_ddot[2]
    rocker_q1_ddot = q_i_ddot[3]
    rocker_q2_ddot = q_i_ddot[4]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (300)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = crank_theta_dot**2
    w3 = w0 * w2
    w4 = crank_theta_ddot * w1 + w3
    w5 = w4 * c2
    w6 = coupler_theta_dot**2
    w7 = ca.sin(coupler_theta)
    w8 = coupler_q1 * c17
    w9 = w8 + coupler_q2 * c18
    w10 = coupler_q2 * c20
    w11 = coupler_q1 * c19 + w10
    w12 = c16 - (coupler_q1 * w9 + coupler_q2 * w11) * 0.5
    w13 = ca.cos(coupler_theta)
    w14 = coupler_q1 * c21
    w15 = w7 * w12 + w13 * w14
    w16 = w6 * w15
    w17 = coupler_q1_dot * c17
    w18 = w17 + coupler_q2_dot * c18
    w19 = coupler_q2_dot * c20
    w20 = coupler_q1_dot * c19 + w19
    w21 = coupler_q1_dot * w18 + coupler_q2_dot * w20
    w22 = w7 * w21
    w23 = 2 * coupler_theta_dot
    w24 = w9 * coupler_q1_dot + w11 * coupler_q2_dot
    w25 = coupler_q1_dot * c21
    w26 = w13 * w24 + w7 * w25
    w27 = w23 * w26
    w28 = w1 * w2
    w29 = w0 * crank_theta_ddot - w28
    w30 = w29 * c2
    w31 = w12 * w13 - w7 * w14
    w32 = ca.cos(rocker_theta)
    w33 = rocker_q1 * c7
    w34 = rocker_q2 * c8
    w35 = rocker_length - (rocker_q1 * w33 + rocker_q2 * w34) * 0.5
    w36 = w32 * w35
    w37 = coupler_q1 * c4
    w38 = coupler_q2 * c5
    w39 = coupler_q1_dot * w37 + coupler_q2_dot * w38
    w40 = w7 * w39
    w41 = w23 * w40
    w42 = coupler_q1_dot * c4
    w43 = coupler_q2_dot * c5
    w44 = coupler_q1_dot * w42 + coupler_q2_dot * w43
    w45 = w13 * w44
    w46 = coupler_length - (coupler_q1 * w37 + coupler_q2 * w38) * 0.5
    w47 = w13 * w46
    w48 = w6 * w47
    w49 = 2 * rocker_theta_dot
    w50 = ca.sin(rocker_theta)
    w51 = w33 * rocker_q1_dot + w34 * rocker_q2_dot
    w52 = w50 * w51
    w53 = w49 * w52
    w54 = rocker_q1_dot * c7
    w55 = rocker_q2_dot * c8
    w56 = rocker_q1_dot * w54 + rocker_q2_dot * w55
    w57 = w32 * w56
    w58 = rocker_theta_dot**2
    w59 = w36 * w58
    w60 = w41 - (w45 + w48) - (w53 - (w57 + w59)) - w3
    w61 = w35 * w50
    w62 = w50 * w56
    w63 = w32 * w51
    w64 = w49 * w63
    w65 = w58 * w61
    w66 = w7 * w44
    w67 = w13 * w39
    w68 = w23 * w67
    w69 = w7 * w46
    w70 = w6 * w69
    w71 = w62 + w64 + w65 - (w66 + w68 + w70) - w28
    w72 = w36 * w69 - w47 * w61
    w73 = (w0 * w61 - w1 * w36) / w72
    w74 = w13 * w37
    w75 = w7 * w37
    w76 = (w36 * w74 + w61 * w75) / w72
    w77 = w13 * w38
    w78 = w7 * w38
    w79 = (w36 * w77 + w61 * w78) / w72
    w80 = (w36 * w60 + w61 * w71) / w72 + crank_theta_ddot * w73 - w76 * coupler_q1_ddot - w79 * coupler_q2_ddot
    w81 = w32 * w33
    w82 = w33 * w50
    w83 = rocker_q1 * w35 * c7 / w72
    w84 = w32 * w34
    w85 = w34 * w50
    w86 = rocker_q2 * w35 * c8 / w72
    w87 = w80 + w83 * rocker_q1_ddot + w86 * rocker_q2_ddot
    w88 = w31 * w87
    w89 = w13 * c21
    w90 = w89 - w7 * w9
    w91 = coupler_q1_ddot * w90
    w92 = w7 * w11
    w93 = coupler_q2_ddot * w92
    w94 = coupler_theta_dot * -2.0
    w95 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w96 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w97 = coupler_q1_dot * w95 + coupler_q2_dot * w96
    w98 = c22 + (coupler_q1 * w95 + coupler_q2 * w96)
    w99 = w94 * w97 + w31 * gravity_y - (w29 * w31 + w4 * w15 + w87 * w98 + coupler_q1_ddot * c29 + coupler_q2_ddot * c30)
    w100 = rocker_theta_dot * -2.0
    w101 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w102 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w103 = rocker_q1_dot * w101 + rocker_q2_dot * w102
    w104 = rocker_q1 * c36
    w105 = w104 + rocker_q2 * c37
    w106 = rocker_q2 * c39
    w107 = rocker_q1 * c38 + w106
    w108 = c35 - (rocker_q1 * w105 + rocker_q2 * w107) * 0.5
    w109 = rocker_q1 * c40
    w110 = c9 + (rocker_q1 * w101 + rocker_q2 * w102)
    w111 = (w0 * w69 - w1 * w47) / w72
    w112 = coupler_q1 * w46 * c4 / w72
    w113 = coupler_q2 * w46 * c5 / w72
    w114 = (w47 * w60 + w69 * w71) / w72 + crank_theta_ddot * w111 - coupler_q1_ddot * w112 - coupler_q2_ddot * w113
    w115 = (w47 * w81 + w69 * w82) / w72
    w116 = (w47 * w84 + w69 * w85) / w72
    w117 = w114 + rocker_q1_ddot * w115 + rocker_q2_ddot * w116
    w118 = w100 * w103 + (w32 * w108 - w50 * w109) * gravity_y - (w110 * w117 + rocker_q1_ddot * c31 + rocker_q2_ddot * c32)
    w119 = (w61 * w99 + w69 * w118) / w72
    w120 = w6 * w31
    w121 = w13 * w25 - w7 * w24
    w122 = w23 * w121
    w123 = w13 * w21
    w124 = w15 * w87
    w125 = w7 * c21
    w126 = w9 * w13 + w125
    w127 = coupler_q1_ddot * w126
    w128 = w11 * w13
    w129 = coupler_q2_ddot * w128
    w130 = (w36 * w99 + w47 * w118) / w72
    w131 = w1 * (c34 + (w16 + w22 + w27) - (w30 + w88 + w91 - w93) + w119) + w0 * (w120 + w122 + w123 + (w5 + w124 + w127 + w129) + w130)
    w132 = w23 * w47 + 2 * -w40
    w133 = coupler_theta_dot * w47 - coupler_q1_dot * w75 - coupler_q2_dot * w78
    w134 = rocker_q1_dot * w82 - w36 * rocker_theta_dot + rocker_q2_dot * w85
    w135 = w0 * crank_theta_dot + w73 * w133 + w111 * w134
    w136 = coupler_q1_dot * w74 + coupler_theta_dot * w69 + coupler_q2_dot * w77
    w137 = rocker_theta_dot * w61 + rocker_q1_dot * w81 + rocker_q2_dot * w84
    w138 = w1 * crank_theta_dot + w73 * w136 - w111 * w137
    w139 = (w36 * w135 + w61 * w138) / w72
    w140 = w47 * w87 - w75 * coupler_q1_ddot - w78 * coupler_q2_ddot - (w68 + (w66 + w70))
    w141 = 2 * w52 - w36 * w49
    w142 = (w47 * w135 + w69 * w138) / w72
    w143 = w82 * rocker_q1_ddot - w36 * w117 + w85 * rocker_q2_ddot + (w64 + (w62 + w65))
    w144 = w29 - w132 * w139 + w73 * w140 - w141 * w142 + w111 * w143
    w145 = w23 * w69 + 2 * w67
    w146 = w74 * coupler_q1_ddot + w69 * w87 + w77 * coupler_q2_ddot + (w48 + (w45 - w41))
    w147 = 2 * -w63 - w49 * w61
    w148 = w61 * w117 + w81 * rocker_q1_ddot + w84 * rocker_q2_ddot + (w59 + (w57 - w53))
    w149 = w4 - w139 * w145 + w73 * w146 - w142 * w147 - w111 * w148
    w150 = (w47 * w144 + w69 * w149) / w72
    w151 = w103 * -2.0
    w152 = w36 * w130 - (w50 * w108 + w32 * w109) * gravity_y + w61 * w119
    w153 = w110 * w150 - w142 * w151 + w111 * w152
    w154 = w0 * w31 + w1 * w15
    w155 = (w36 * w144 + w61 * w149) / w72
    w156 = w0 * (w15 * w23 + 2 * w26) - w1 * (w23 * w31 + 2 * w121)
    w157 = w0 * (w122 + (w120 + w123) + (w129 + (w124 + w127))) + w1 * (w22 + (w16 + w27) + (w93 - (w88 + w91)))
    w158 = w4 * w31
    w159 = w15 * w29
    w160 = w97 * -2.0
    w161 = w159 - w158 - w15 * gravity_y - w47 * w130 - w69 * w119
    w162 = w158 - w159 + w98 * w155 - w139 * w160 + w73 * w161
    w163 = w4 * w90
    w164 = w29 * w126
    w165 = w23 * w95
    w166 = w75 * w130
    w167 = w74 * w119
    w168 = w164 - w163 - w126 * gravity_y + w166 - w167
    w169 = w4 * w92 + w29 * w128
    w170 = w23 * w96
    w171 = w78 * w130
    w172 = w77 * w119
    w173 = w169 - w128 * gravity_y + w171 - w172
    w174 = w49 * w101
    w175 = w81 * w119
    w176 = w50 * c40
    w177 = w82 * w130
    w178 = w175 - ((w176 + w32 * w105) * gravity_y + w177)
    w179 = w49 * w102
    w180 = w84 * w119
    w181 = w85 * w130
    w182 = w180 - (w32 * w107 * gravity_y + w181)
    w183 = (w8 + w9 + coupler_q2 * c19) * 0.5
    w184 = w89 - w7 * w183
    w185 = coupler_q2_dot * c19
    w186 = w17 + w185
    w187 = w125 + w13 * w183
    w188 = w7 * c17
    w189 = w7 * c19
    w190 = w0 * (w6 * w184 + w23 * (w13 * w186) + (w87 * w187 + coupler_q1_ddot * w188 + coupler_q2_ddot * w189))
    w191 = w13 * c17
    w192 = w13 * c19
    w193 = w1 * (w87 * w184 + coupler_q1_ddot * w191 + coupler_q2_ddot * w192 - (w6 * w187 + w23 * (w7 * w186)))
    w194 = w13 * c4
    w195 = coupler_q1_dot * w194 - coupler_theta_dot * w75 - w76 * w133 - w112 * w134
    w196 = w7 * c4
    w197 = coupler_q1_dot * w196 + coupler_theta_dot * w74 - w76 * w136 + w112 * w137
    w198 = (w36 * w195 + w61 * w197) / w72
    w199 = (w47 * w195 + w69 * w197) / w72
    w200 = coupler_q1_ddot * w194 - w75 * w87 - (w23 * (w7 * w42) + w6 * w74) - w132 * w198 - w76 * w140 - w141 * w199
    w201 = w200 - w112 * w143
    w202 = coupler_q1_ddot * w196 + w74 * w87 + (w23 * (w13 * w42) - w6 * w75) - w145 * w198 - w76 * w146 - w147 * w199
    w203 = w202 + w112 * w148
    w204 = (w47 * w201 + w69 * w203) / w72
    w205 = w110 * w204 - w151 * w199 - w112 * w152
    w206 = (w36 * w201 + w61 * w203) / w72
    w207 = w94 * (coupler_q1_dot * c54 - coupler_q2_dot * c27) - w187 * gravity_y - (w87 * (w95 + coupler_q1 * c54 - coupler_q2 * c27) - (w29 * w187 - w4 * w184))
    w208 = w166 + w207 - w167 + w98 * w206 - w160 * w198 - w76 * w161
    w209 = w6 * c54 - c41 - w188 * gravity_y + (w29 * w188 - w4 * w191) - w130 * w194 - w119 * w196 - w112 * w205
    w210 = w29 * w189 - w4 * w192 - (w6 * c27 + w189 * gravity_y) - w113 * w205 + w206 * c30 - w170 * w198 - w76 * w173
    w211 = coupler_q1_dot * c18
    w212 = w19 + w211
    w213 = (coupler_q1 * c18 + (w10 + w11)) * 0.5
    w214 = w7 * w213
    w215 = w13 * w213
    w216 = w7 * c18
    w217 = w7 * c20
    w218 = w0 * (w23 * (w13 * w212) - w6 * w214 + (w87 * w215 + coupler_q1_ddot * w216 + coupler_q2_ddot * w217))
    w219 = w13 * c18
    w220 = w13 * c20
    w221 = w1 * (w6 * w215 + w23 * (w7 * w212) + (w87 * w214 - coupler_q1_ddot * w219 - coupler_q2_ddot * w220))
    w222 = w13 * c5
    w223 = coupler_q2_dot * w222 - coupler_theta_dot * w78 - w79 * w133 - w113 * w134
    w224 = w7 * c5
    w225 = coupler_theta_dot * w77 + coupler_q2_dot * w224 - w79 * w136 + w113 * w137
    w226 = (w36 * w223 + w61 * w225) / w72
    w227 = (w47 * w223 + w69 * w225) / w72
    w228 = coupler_q2_ddot * w222 - w78 * w87 - (w23 * (w7 * w43) + w6 * w77) - w132 * w226 - w79 * w140 - w141 * w227
    w229 = w228 - w113 * w143
    w230 = w77 * w87 + coupler_q2_ddot * w224 + (w23 * (w13 * w43) - w6 * w78) - w145 * w226 - w79 * w146 - w147 * w227
    w231 = w230 + w113 * w148
    w232 = (w47 * w229 + w69 * w231) / w72
    w233 = w110 * w232 - w151 * w227 - w113 * w152
    w234 = (w36 * w229 + w61 * w231) / w72
    w235 = w94 * (coupler_q2_dot * c55 - coupler_q1_dot * c25) - w215 * gravity_y - (w87 * (w96 + coupler_q2 * c55 - coupler_q1 * c25) - (w4 * w214 + w29 * w215))
    w236 = w171 + w235 - w172 + w98 * w234 - w160 * w226 - w79 * w161
    w237 = w29 * w216 - w4 * w219 - (w6 * c25 + w216 * gravity_y) - w112 * w233 + w234 * c29 - w165 * w226 - w79 * w168
    w238 = w6 * c55 - c42 - w217 * gravity_y + (w29 * w217 - w4 * w220) - w130 * w222 - w119 * w224 - w113 * w233
    w239 = w100 * (rocker_q1_dot * c56 - rocker_q2_dot * c14) - (w176 + w32 * ((w104 + w105 + rocker_q2 * c38) * 0.5)) * gravity_y
    w240 = w32 * c7
    w241 = rocker_theta_dot * w82 - rocker_q1_dot * w240 + w83 * w133 + w115 * w134
    w242 = w50 * c7
    w243 = w83 * w136 - (rocker_theta_dot * w81 + rocker_q1_dot * w242) - w115 * w137
    w244 = (w36 * w241 + w61 * w243) / w72
    w245 = (w47 * w241 + w69 * w243) / w72
    w246 = w82 * w117 - rocker_q1_ddot * w240 + (w49 * (w50 * w54) + w58 * w81) - w132 * w244 + w83 * w140 - w141 * w245
    w247 = w246 + w115 * w143
    w248 = w83 * w146 - (w81 * w117 + rocker_q1_ddot * w242 + (w49 * (w32 * w54) - w58 * w82) + w145 * w244)
    w249 = w248 - w147 * w245 - w115 * w148
    w250 = (w47 * w247 + w69 * w249) / w72
    w251 = w175 + (w239 - w117 * (w101 + rocker_q1 * c56 - rocker_q2 * c14) - w177) + w110 * w250 - w151 * w245
    w252 = w251 + w115 * w152
    w253 = (w36 * w247 + w61 * w249) / w72
    w254 = w98 * w253 - w160 * w244 + w83 * w161
    w255 = w58 * c56 - c43 - w50 * c57 + w130 * w240 + w119 * w242 + w250 * c31 - w174 * w245 + w115 * w178 + w115 * w252
    w256 = w100 * (rocker_q2_dot * c59 - rocker_q1_dot * c12) - w32 * ((rocker_q1 * c37 + (w106 + w107)) * 0.5) * gravity_y
    w257 = w32 * c8
    w258 = rocker_theta_dot * w85 - rocker_q2_dot * w257 + w86 * w133 + w116 * w134
    w259 = w50 * c8
    w260 = w86 * w136 - (rocker_theta_dot * w84 + rocker_q2_dot * w259) - w116 * w137
    w261 = (w36 * w258 + w61 * w260) / w72
    w262 = (w47 * w258 + w69 * w260) / w72
    w263 = w85 * w117 - rocker_q2_ddot * w257 + (w49 * (w50 * w55) + w58 * w84) - w132 * w261 + w86 * w140 - w141 * w262
    w264 = w263 + w116 * w143
    w265 = w86 * w146 - (w84 * w117 + rocker_q2_ddot * w259 + (w49 * (w32 * w55) - w58 * w85) + w145 * w261)
    w266 = w265 - w147 * w262 - w116 * w148
    w267 = (w47 * w264 + w69 * w266) / w72
    w268 = w180 + (w256 - w117 * (w102 + rocker_q2 * c59 - rocker_q1 * c12) - w181) + w110 * w267 - w151 * w262
    w269 = w268 + w116 * w152
    w270 = (w36 * w264 + w61 * w266) / w72
    w271 = w98 * w270 - w160 * w261 + w86 * w161
    w272 = w58 * c59 - c44 - w50 * c61 + w130 * w257 + w119 * w259 + w267 * c32 - w179 * w262 + w116 * w182 + w116 * w269
    w273 = 2 * crank_theta_dot
    w274 = w1 * w273
    w275 = w0 * w273
    w276 = 2 * -w142
    w277 = w111 * w151 - w110 * w276
    w278 = 2 * -w139
    w279 = w31 * w274 - w15 * w275 - w98 * w278 + w73 * w160
    w280 = w185 + (w17 + w18)
    w281 = 2 * -w199
    w282 = w110 * w281 + w112 * w151
    w283 = 2 * -w198
    w284 = w0 * (w7 * w280 + w23 * w126) - w1 * (w23 * w90 + w13 * w280) - w111 * w282 - w154 * w283 - w76 * w156
    w285 = w94 * w95 - w98 * w283 - w76 * w160
    w286 = w211 + (w19 + w20)
    w287 = 2 * -w227
    w288 = w110 * w287 + w113 * w151
    w289 = 2 * -w226
    w290 = w0 * (w7 * w286 + w23 * w128) - w1 * (w13 * w286 - w23 * w92) - w111 * w288 - w154 * w289 - w79 * w156
    w291 = w94 * w96 - w98 * w289 - w79 * w160
    w292 = 2 * -w245
    w293 = w100 * w101 - w110 * w292 + w115 * w151
    w294 = 2 * -w244
    w295 = w83 * w160 - w98 * w294
    w296 = 2 * -w262
    w297 = w100 * w102 - w110 * w296 + w116 * w151
    w298 = 2 * -w261
    w299 = w86 * w160 - w98 * w298
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * w5 - w131 - w1 * w30 + w111 * w153 + w154 * w155 - w139 * w156 + w73 * w157 + w73 * w162,
            w190 - w193 + w111 * w205 + w154 * w206 - w156 * w198 - w76 * w157 + w73 * w208,
            w218 + w221 + w111 * w233 + w154 * w234 - w156 * w226 - w79 * w157 + w73 * w236,
            w111 * w252 + w154 * w253 - w156 * w244 + w83 * w157 + w73 * w254,
            w111 * w269 + w154 * w270 - w156 * w261 + w86 * w157 + w73 * w271,
        ),
        ca.horzcat(  # coupler.q1
            w163 - w164 - w112 * w153 + w155 * c29 - w139 * w165 + w73 * w168 - w76 * w162,
            w209 + w206 * c29 - w165 * w198 - w76 * w168 - w76 * w208, w237 - w76 * w236,
            w253 * c29 - w112 * w252 - w165 * w244 + w83 * w168 - w76 * w254,
            w270 * c29 - w112 * w269 - w165 * w261 + w86 * w168 - w76 * w271,
        ),
        ca.horzcat(  # coupler.q2
            w155 * c30 - (w169 + w113 * w153) - w139 * w170 + w73 * w173 - w79 * w162, w210 - w79 * w208,
            w238 + w234 * c30 - w170 * w226 - w79 * w173 - w79 * w236,
            w253 * c30 - w113 * w252 - w170 * w244 + w83 * w173 - w79 * w254,
            w270 * c30 - w113 * w269 - w170 * w261 + w86 * w173 - w79 * w271,
        ),
        ca.horzcat(  # rocker.q1
            w150 * c31 - w142 * w174 + w111 * w178 + w115 * w153 + w83 * w162,
            w204 * c31 - w174 * w199 - w112 * w178 + w115 * w205 + w83 * w208,
            w232 * c31 - w174 * w227 - w113 * w178 + w115 * w233 + w83 * w236, w255 + w83 * w254,
            w267 * c31 - (w58 * c12 + w50 * c60) - w174 * w262 + w116 * w178 + w115 * w269 + w83 * w271,
        ),
        ca.horzcat(  # rocker.q2
            w150 * c32 - w142 * w179 + w111 * w182 + w116 * w153 + w86 * w162,
            w204 * c32 - w179 * w199 - w112 * w182 + w116 * w205 + w86 * w208,
            w232 * c32 - w179 * w227 - w113 * w182 + w116 * w233 + w86 * w236,
            w250 * c32 - (w58 * c14 + w50 * c58) - w179 * w245 + w115 * w182 + w116 * w252 + w86 * w254,
            w272 + w86 * w271,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # crank.theta
            w0 * (w274 * c2) - w1 * (w275 * c2) + w111 * w277 - w154 * w278 + w73 * w156 + w73 * w279,
            w284 + w73 * w285, w290 + w73 * w291, w111 * w293 - w154 * w294 + w83 * w156 + w73 * w295,
            w111 * w297 - w154 * w298 + w86 * w156 + w73 * w299,
        ),
        ca.horzcat(  # coupler.q1
            w90 * w274 - w126 * w275 - w112 * w277 - w278 * c29 + w73 * w165 - w76 * w279,
            w112 * w282 - w283 * c29 - w76 * w165 - w76 * w285, w112 * w288 - w289 * c29 - w79 * w165 - w76 * w291,
            w83 * w165 - (w112 * w293 + w294 * c29) - w76 * w295,
            w86 * w165 - (w112 * w297 + w298 * c29) - w76 * w299,
        ),
        ca.horzcat(  # coupler.q2
            w73 * w170 - (w92 * w274 + w128 * w275 + w113 * w277 + w278 * c30) - w79 * w279,
            w113 * w282 - w283 * c30 - w76 * w170 - w79 * w285, w113 * w288 - w289 * c30 - w79 * w170 - w79 * w291,
            w83 * w170 - (w113 * w293 + w294 * c30) - w79 * w295,
            w86 * w170 - (w113 * w297 + w298 * c30) - w79 * w299,
        ),
        ca.horzcat(  # rocker.q1
            w111 * w174 - w276 * c31 + w115 * w277 + w83 * w279,
            w83 * w285 - (w281 * c31 + w112 * w174 + w115 * w282),
            w83 * w291 - (w287 * c31 + w113 * w174 + w115 * w288),
            w115 * w174 - w292 * c31 + w115 * w293 + w83 * w295,
            w116 * w174 - w296 * c31 + w115 * w297 + w83 * w299,
        ),
        ca.horzcat(  # rocker.q2
            w111 * w179 - w276 * c32 + w116 * w277 + w86 * w279,
            w86 * w285 - (w281 * c32 + w112 * w179 + w116 * w282),
            w86 * w291 - (w287 * c32 + w113 * w179 + w116 * w288),
            w115 * w179 - w292 * c32 + w116 * w293 + w86 * w295,
            w116 * w179 - w296 * c32 + w116 * w297 + w86 * w299,
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 5 x 4) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 4 x 4) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 4 x 4) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 65)
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # outputs
    B = ca.SX(5, 4)
    # coupler.q1
    B[1, 0] = 1.0
    # coupler.q2
    B[2, 1] = 1.0
    # rocker.q1
    B[3, 2] = 1.0
    # rocker.q2
    B[4, 3] = 1.0
    K_s = ca.SX(4, 4)
    K_s[0, 0] = c41
    K_s[1, 1] = c42
    K_s[2, 2] = c43
    K_s[3, 3] = c44
    D_s = ca.SX(4, 4)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 4) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 4) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 4) [N, N m]: part of Q_hat of S
    430 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (89)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.sin(coupler_theta)
    w3 = coupler_q1 * c4
    w4 = coupler_q2 * c5
    w5 = coupler_length - (coupler_q1 * w3 + coupler_q2 * w4) * 0.5
    w6 = w2 * w5
    w7 = ca.cos(coupler_theta)
    w8 = w5 * w7
    w9 = ca.cos(rocker_theta)
    w10 = rocker_q1 * c7
    w11 = rocker_q2 * c8
    w12 = rocker_length - (rocker_q1 * w10 + rocker_q2 * w11) * 0.5
    w13 = w9 * w12
    w14 = ca.sin(rocker_theta)
    w15 = w12 * w14
    w16 = w6 * w13 - w8 * w15
    w17 = (w0 * w6 - w1 * w8) / w16
    w18 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w19 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w20 = c9 + (rocker_q1 * w18 + rocker_q2 * w19)
    w21 = (w0 * w15 - w1 * w13) / w16
    w22 = coupler_q1 * c17 + coupler_q2 * c18
    w23 = coupler_q1 * c19 + coupler_q2 * c20
    w24 = c16 - (coupler_q1 * w22 + coupler_q2 * w23) * 0.5
    w25 = coupler_q1 * c21
    w26 = w7 * w24 - w2 * w25
    w27 = w2 * w24 + w7 * w25
    w28 = w0 * w26 + w1 * w27
    w29 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w30 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w31 = c22 + (coupler_q1 * w29 + coupler_q2 * w30)
    w32 = w7 * c21 - w2 * w22
    w33 = w7 * w22 + w2 * c21
    w34 = coupler_q1 * w5 * c4 / w16
    w35 = w20 * w34
    w36 = (w13 * (w3 * w7) + w15 * (w2 * w3)) / w16
    w37 = c29 - w31 * w36
    w38 = w0 * w32 + w1 * w33 - w17 * w35 + (w21 * w37 - w28 * w36)
    w39 = w7 * w23
    w40 = w2 * w23
    w41 = coupler_q2 * w5 * c5 / w16
    w42 = w20 * w41
    w43 = (w13 * (w4 * w7) + w15 * (w2 * w4)) / w16
    w44 = c30 - w31 * w43
    w45 = w1 * w39 - w0 * w40 - w17 * w42 + (w21 * w44 - w28 * w43)
    w46 = (w8 * (w9 * w10) + w6 * (w10 * w14)) / w16
    w47 = c31 + w20 * w46
    w48 = rocker_q1 * w12 * c7 / w16
    w49 = w31 * w48
    w50 = w17 * w47 + (w21 * w49 + w28 * w48)
    w51 = (w8 * (w9 * w11) + w6 * (w11 * w14)) / w16
    w52 = c32 + w20 * w51
    w53 = rocker_q2 * w12 * c8 / w16
    w54 = w31 * w53
    w55 = w17 * w52 + (w21 * w54 + w28 * w53)
    w56 = w34 * w42 - (w36 * w44 + w43 * c29)
    w57 = w48 * c29 - w36 * w49 - w34 * w47
    w58 = w53 * c29 - w36 * w54 - w34 * w52
    w59 = w48 * c30 - w43 * w49 - w41 * w47
    w60 = w53 * c30 - w43 * w54 - w41 * w52
    w61 = w46 * w52 + w51 * c31 + w48 * w54
    w62 = coupler_theta_dot**2
    w63 = coupler_q1_dot * (coupler_q1_dot * c17 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + coupler_q2_dot * c20)
    w64 = 2 * coupler_theta_dot
    w65 = w22 * coupler_q1_dot + w23 * coupler_q2_dot
    w66 = coupler_q1_dot * c21
    w67 = w3 * coupler_q1_dot + w4 * coupler_q2_dot
    w68 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w69 = 2 * rocker_theta_dot
    w70 = w10 * rocker_q1_dot + w11 * rocker_q2_dot
    w71 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w72 = rocker_theta_dot**2
    w73 = crank_theta_dot**2
    w74 = w0 * w73
    w75 = w64 * (w2 * w67) - (w7 * w68 + w8 * w62) - (w69 * (w14 * w70) - (w9 * w71 + w13 * w72)) - w74
    w76 = w1 * w73
    w77 = w14 * w71 + w69 * (w9 * w70) + w15 * w72 - (w2 * w68 + w64 * (w7 * w67) + w6 * w62) - w76
    w78 = (w13 * w75 + w15 * w77) / w16
    w79 = w0 * (c34 + (w27 * w62 + w2 * w63 + w64 * (w7 * w65 + w2 * w66)) - (w26 * w78 - w76 * c2)) - w1 * (w26 * w62 + w64 * (w7 * w66 - w2 * w65) + w7 * w63 + (w74 * c2 + w27 * w78))
    w80 = rocker_q1 * c36 + rocker_q2 * c37
    w81 = rocker_q1 * c38 + rocker_q2 * c39
    w82 = rocker_theta_dot * -2.0 * (w18 * rocker_q1_dot + w19 * rocker_q2_dot) + (w9 * (c35 - (rocker_q1 * w80 + rocker_q2 * w81) * 0.5) - w14 * (rocker_q1 * c40)) * gravity_y
    w83 = (w8 * w75 + w6 * w77) / w16
    w84 = w82 - w20 * w83
    w85 = coupler_theta_dot * -2.0 * (w29 * coupler_q1_dot + w30 * coupler_q2_dot) + w26 * gravity_y - (w27 * w74 - w26 * w76 + w31 * w78)
    w86 = w29 * w62 - coupler_q1 * c41 + w32 * gravity_y - (w33 * w74 - w32 * w76 + w78 * c29) - w34 * w84 - w36 * w85
    w87 = w30 * w62 - coupler_q2 * c42 - w40 * gravity_y - (w39 * w74 + w40 * w76 + w78 * c30) - w41 * w84 - w43 * w85
    w88 = w18 * w72 - rocker_q1 * c43 + (w9 * c40 - w14 * w80) * gravity_y - w83 * c31 + w46 * w84 + w48 * w85
    # outputs
    M_hat_LL = ca.vertcat(c3 + w17 * (w17 * w20) + (w21 * (w28 + w21 * w31) + w21 * w28))
    M_hat_LS = ca.horzcat(
        w38, w45, w50, w55,
    )
    M_hat_SL = ca.vertcat(
        w38,  # coupler.q1
        w45,  # coupler.q2
        w50,  # rocker.q1
        w55,  # rocker.q2
    )
    M_hat_SS = ca.vertcat(
        ca.horzcat(c23 + w34 * w35 - (w36 * w37 + w36 * c29), w56, w57, w58),  # coupler.q1
        ca.horzcat(w56, c26 + w41 * w42 - (w43 * w44 + w43 * c30), w59, w60),  # coupler.q2
        ca.horzcat(w57, w59, c10 + (w46 * w47 + w46 * c31) + w48 * w49, w61),  # rocker.q1
        ca.horzcat(w58, w60, w61, c13 + (w51 * w52 + w51 * c32) + w53 * w54),  # rocker.q2
    )
    Q_hat_L = ca.vertcat(w79 + w17 * w84 + w21 * w85)
    Q_hat_S = ca.vertcat(
        w86,  # coupler.q1
        w87,  # coupler.q2
        w88,  # rocker.q1
        w19 * w72 - rocker_q2 * c44 - w14 * w81 * gravity_y - w83 * c32 + w51 * w84 + w53 * w85,  # rocker.q2
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
    takes c (n_const = 65) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 4) [N, N m]: right-hand side of a sub-step, slow q'' given
    353 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 65)
    crank_theta = q_i[0]
    coupler_q1 = q_i[1]
    coupler_q2 = q_i[2]
    rocker_q1 = q_i[3]
    rocker_q2 = q_i[4]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_q1_dot = q_i_dot[1]
    coupler_q2_dot = q_i_dot[2]
    rocker_q1_dot = q_i_dot[3]
    rocker_q2_dot = q_i_dot[4]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_L_ddot[0]
    crank_tip_x = c[0]
    coupler_length = c[1]
    c4 = c[4]
    c5 = c[5]
    rocker_length = c[6]
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
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    gravity_y = c[33]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (75)
    w0 = ca.cos(coupler_theta)
    w1 = coupler_q1 * c4
    w2 = coupler_q2 * c5
    w3 = coupler_length - (coupler_q1 * w1 + coupler_q2 * w2) * 0.5
    w4 = w0 * w3
    w5 = ca.sin(coupler_theta)
    w6 = w3 * w5
    w7 = ca.cos(rocker_theta)
    w8 = rocker_q1 * c7
    w9 = rocker_q2 * c8
    w10 = rocker_length - (rocker_q1 * w8 + rocker_q2 * w9) * 0.5
    w11 = w7 * w10
    w12 = ca.sin(rocker_theta)
    w13 = w10 * w12
    w14 = w6 * w11 - w4 * w13
    w15 = coupler_q1 * w3 * c4 / w14
    w16 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w17 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w18 = c9 + (rocker_q1 * w16 + rocker_q2 * w17)
    w19 = (w0 * w1 * w11 + w1 * w5 * w13) / w14
    w20 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w21 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w22 = c22 + (coupler_q1 * w20 + coupler_q2 * w21)
    w23 = coupler_q2 * w3 * c5 / w14
    w24 = w18 * w23
    w25 = (w11 * (w0 * w2) + w13 * (w2 * w5)) / w14
    w26 = c30 - w22 * w25
    w27 = w15 * w24 - (w19 * w26 + w25 * c29)
    w28 = rocker_q1 * w10 * c7 / w14
    w29 = w22 * w28
    w30 = (w4 * (w7 * w8) + w6 * (w8 * w12)) / w14
    w31 = c31 + w18 * w30
    w32 = w28 * c29 - w19 * w29 - w15 * w31
    w33 = rocker_q2 * w10 * c8 / w14
    w34 = w22 * w33
    w35 = (w4 * (w7 * w9) + w6 * (w9 * w12)) / w14
    w36 = c32 + w18 * w35
    w37 = w33 * c29 - w19 * w34 - w15 * w36
    w38 = w28 * c30 - w25 * w29 - w23 * w31
    w39 = w33 * c30 - w25 * w34 - w23 * w36
    w40 = w30 * w36 + w35 * c31 + w28 * w34
    w41 = coupler_theta_dot**2
    w42 = coupler_q1 * c17 + coupler_q2 * c18
    w43 = w0 * c21 - w5 * w42
    w44 = crank_theta_dot**2
    w45 = ca.cos(crank_theta) * crank_tip_x
    w46 = w44 * w45
    w47 = ca.sin(crank_theta) * crank_tip_x
    w48 = w46 + w47 * crank_theta_ddot
    w49 = w44 * w47
    w50 = w45 * crank_theta_ddot - w49
    w51 = 2 * coupler_theta_dot
    w52 = w1 * coupler_q1_dot + w2 * coupler_q2_dot
    w53 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w54 = 2 * rocker_theta_dot
    w55 = w8 * rocker_q1_dot + w9 * rocker_q2_dot
    w56 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
    w57 = rocker_theta_dot**2
    w58 = w51 * (w5 * w52) - (w0 * w53 + w4 * w41) - (w54 * (w12 * w55) - (w7 * w56 + w11 * w57)) - w46
    w59 = w12 * w56 + w54 * (w7 * w55) + w13 * w57 - (w5 * w53 + w51 * (w0 * w52) + w6 * w41) - w49
    w60 = (w11 * w58 + w13 * w59) / w14 + crank_theta_ddot * ((w13 * w45 - w11 * w47) / w14)
    w61 = w20 * w41 - coupler_q1 * c41 + w43 * gravity_y - ((w0 * w42 + w5 * c21) * w48 + w43 * w50 + w60 * c29)
    w62 = rocker_q1 * c36 + rocker_q2 * c37
    w63 = rocker_q1 * c38 + rocker_q2 * c39
    w64 = rocker_theta_dot * -2.0 * (w16 * rocker_q1_dot + w17 * rocker_q2_dot) + (w7 * (c35 - (rocker_q1 * w62 + rocker_q2 * w63) * 0.5) - w12 * (rocker_q1 * c40)) * gravity_y
    w65 = (w4 * w58 + w6 * w59) / w14 + crank_theta_ddot * ((w6 * w45 - w4 * w47) / w14)
    w66 = w64 - w18 * w65
    w67 = coupler_q1 * c19 + coupler_q2 * c20
    w68 = c16 - (coupler_q1 * w42 + coupler_q2 * w67) * 0.5
    w69 = coupler_q1 * c21
    w70 = w0 * w68 - w5 * w69
    w71 = coupler_theta_dot * -2.0 * (w20 * coupler_q1_dot + w21 * coupler_q2_dot) + w70 * gravity_y - (w48 * (w5 * w68 + w0 * w69) + w50 * w70 + w22 * w60)
    w72 = w5 * w67
    w73 = w21 * w41 - coupler_q2 * c42 - w72 * gravity_y - (w48 * (w0 * w67) - w50 * w72 + w60 * c30) - w23 * w66
    w74 = w16 * w57 - rocker_q1 * c43 + (w7 * c40 - w12 * w62) * gravity_y - w65 * c31 + w30 * w66 + w28 * w71
    # outputs
    M_hat_SS = ca.vertcat(
        ca.horzcat(c23 + w15 * (w15 * w18) - (w19 * (c29 - w19 * w22) + w19 * c29), w27, w32, w37),  # coupler.q1
        ca.horzcat(w27, c26 + w23 * w24 - (w25 * w26 + w25 * c30), w38, w39),  # coupler.q2
        ca.horzcat(w32, w38, c10 + (w30 * w31 + w30 * c31) + w28 * w29, w40),  # rocker.q1
        ca.horzcat(w37, w39, w40, c13 + (w35 * w36 + w35 * c32) + w33 * w34),  # rocker.q2
    )
    rhs_S = ca.vertcat(
        w61 - w15 * w66 - w19 * w71,  # coupler.q1
        w73 - w25 * w71,  # coupler.q2
        w74,  # rocker.q1
        w17 * w57 - rocker_q2 * c44 - w12 * w63 * gravity_y - w65 * c32 + w35 * w66 + w33 * w71,  # rocker.q2
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 169) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 42) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 42) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 76) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 76) [1/m]: rotation at a drawn point by each mode of its body
    gives H (1 x entries = 1 x 136) [1/m]: foreshortening of the drawn points that have it, nf x nf each
    gives sections (2 x beams = 2 x 2) [m]: height and width of a rectangle that stands for a beam's section
    gives rigidities (2 x beams = 2 x 2) [N m^2]: E I of a beam for bending along y and along z
    226 operations.
    """
    p = ca.SX.sym("p", 169)
    coupler_length = p[3]
    coupler_area = p[5]
    coupler_youngs_modulus = p[6]
    coupler_second_moment = p[7]
    rocker_length = p[25]
    rocker_area = p[27]
    rocker_youngs_modulus = p[28]
    rocker_second_moment = p[29]
    crank_tip_x = p[30]
    beam_pinned_pinned2_0_0_slope_0_0 = p[31]
    beam_pinned_pinned2_0_0_slope_1_0 = p[32]
    beam_pinned_pinned2_1_0_slope_0_0 = p[33]
    beam_pinned_pinned2_1_0_slope_1_0 = p[34]
    beam_pinned_pinned2_1_0_H_0_0 = p[35]
    beam_pinned_pinned2_1_0_H_1_1 = p[36]
    ground_right_x = p[37]
    beam_pinned_pinned2_0_0625_at_0_0 = p[38]
    beam_pinned_pinned2_0_0625_shape_1_0 = p[39]
    beam_pinned_pinned2_0_0625_shape_1_1 = p[40]
    beam_pinned_pinned2_0_0625_slope_0_0 = p[41]
    beam_pinned_pinned2_0_0625_slope_1_0 = p[42]
    beam_pinned_pinned2_0_0625_H_0_0 = p[43]
    beam_pinned_pinned2_0_0625_H_0_1 = p[44]
    beam_pinned_pinned2_0_0625_H_1_0 = p[45]
    beam_pinned_pinned2_0_0625_H_1_1 = p[46]
    beam_pinned_pinned2_0_125_at_0_0 = p[47]
    beam_pinned_pinned2_0_125_shape_1_0 = p[48]
    beam_pinned_pinned2_0_125_shape_1_1 = p[49]
    beam_pinned_pinned2_0_125_slope_0_0 = p[50]
    beam_pinned_pinned2_0_125_slope_1_0 = p[51]
    beam_pinned_pinned2_0_125_H_0_0 = p[52]
    beam_pinned_pinned2_0_125_H_0_1 = p[53]
    beam_pinned_pinned2_0_125_H_1_0 = p[54]
    beam_pinned_pinned2_0_125_H_1_1 = p[55]
    beam_pinned_pinned2_0_1875_at_0_0 = p[56]
    beam_pinned_pinned2_0_1875_shape_1_0 = p[57]
    beam_pinned_pinned2_0_1875_shape_1_1 = p[58]
    beam_pinned_pinned2_0_1875_slope_0_0 = p[59]
    beam_pinned_pinned2_0_1875_slope_1_0 = p[60]
    beam_pinned_pinned2_0_1875_H_0_0 = p[61]
    beam_pinned_pinned2_0_1875_H_0_1 = p[62]
    beam_pinned_pinned2_0_1875_H_1_0 = p[63]
    beam_pinned_pinned2_0_1875_H_1_1 = p[64]
    beam_pinned_pinned2_0_25_at_0_0 = p[65]
    beam_pinned_pinned2_0_25_shape_1_0 = p[66]
    beam_pinned_pinned2_0_25_shape_1_1 = p[67]
    beam_pinned_pinned2_0_25_slope_0_0 = p[68]
    beam_pinned_pinned2_0_25_H_0_0 = p[69]
    beam_pinned_pinned2_0_25_H_0_1 = p[70]
    beam_pinned_pinned2_0_25_H_1_0 = p[71]
    beam_pinned_pinned2_0_25_H_1_1 = p[72]
    beam_pinned_pinned2_0_3125_at_0_0 = p[73]
    beam_pinned_pinned2_0_3125_shape_1_0 = p[74]
    beam_pinned_pinned2_0_3125_shape_1_1 = p[75]
    beam_pinned_pinned2_0_3125_slope_0_0 = p[76]
    beam_pinned_pinned2_0_3125_slope_1_0 = p[77]
    beam_pinned_pinned2_0_3125_H_0_0 = p[78]
    beam_pinned_pinned2_0_3125_H_0_1 = p[79]
    beam_pinned_pinned2_0_3125_H_1_0 = p[80]
    beam_pinned_pinned2_0_3125_H_1_1 = p[81]
    beam_pinned_pinned2_0_375_at_0_0 = p[82]
    beam_pinned_pinned2_0_375_shape_1_0 = p[83]
    beam_pinned_pinned2_0_375_shape_1_1 = p[84]
    beam_pinned_pinned2_0_375_slope_0_0 = p[85]
    beam_pinned_pinned2_0_375_slope_1_0 = p[86]
    beam_pinned_pinned2_0_375_H_0_0 = p[87]
    beam_pinned_pinned2_0_375_H_0_1 = p[88]
    beam_pinned_pinned2_0_375_H_1_0 = p[89]
    beam_pinned_pinned2_0_375_H_1_1 = p[90]
    beam_pinned_pinned2_0_4375_at_0_0 = p[91]
    beam_pinned_pinned2_0_4375_shape_1_0 = p[92]
    beam_pinned_pinned2_0_4375_shape_1_1 = p[93]
    beam_pinned_pinned2_0_4375_slope_0_0 = p[94]
    beam_pinned_pinned2_0_4375_slope_1_0 = p[95]
    beam_pinned_pinned2_0_4375_H_0_0 = p[96]
    beam_pinned_pinned2_0_4375_H_0_1 = p[97]
    beam_pinned_pinned2_0_4375_H_1_0 = p[98]
    beam_pinned_pinned2_0_4375_H_1_1 = p[99]
    beam_pinned_pinned2_0_5_at_0_0 = p[100]
    beam_pinned_pinned2_0_5_shape_1_0 = p[101]
    beam_pinned_pinned2_0_5_slope_1_0 = p[102]
    beam_pinned_pinned2_0_5_H_0_0 = p[103]
    beam_pinned_pinned2_0_5_H_0_1 = p[104]
    beam_pinned_pinned2_0_5_H_1_0 = p[105]
    beam_pinned_pinned2_0_5_H_1_1 = p[106]
    beam_pinned_pinned2_0_5625_at_0_0 = p[107]
    beam_pinned_pinned2_0_5625_shape_1_0 = p[108]
    beam_pinned_pinned2_0_5625_shape_1_1 = p[109]
    beam_pinned_pinned2_0_5625_slope_0_0 = p[110]
    beam_pinned_pinned2_0_5625_slope_1_0 = p[111]
    beam_pinned_pinned2_0_5625_H_0_0 = p[112]
    beam_pinned_pinned2_0_5625_H_0_1 = p[113]
    beam_pinned_pinned2_0_5625_H_1_0 = p[114]
    beam_pinned_pinned2_0_5625_H_1_1 = p[115]
    beam_pinned_pinned2_0_625_at_0_0 = p[116]
    beam_pinned_pinned2_0_625_shape_1_0 = p[117]
    beam_pinned_pinned2_0_625_shape_1_1 = p[118]
    beam_pinned_pinned2_0_625_slope_0_0 = p[119]
    beam_pinned_pinned2_0_625_slope_1_0 = p[120]
    beam_pinned_pinned2_0_625_H_0_0 = p[121]
    beam_pinned_pinned2_0_625_H_0_1 = p[122]
    beam_pinned_pinned2_0_625_H_1_0 = p[123]
    beam_pinned_pinned2_0_625_H_1_1 = p[124]
    beam_pinned_pinned2_0_6875_at_0_0 = p[125]
    beam_pinned_pinned2_0_6875_shape_1_0 = p[126]
    beam_pinned_pinned2_0_6875_shape_1_1 = p[127]
    beam_pinned_pinned2_0_6875_slope_0_0 = p[128]
    beam_pinned_pinned2_0_6875_slope_1_0 = p[129]
    beam_pinned_pinned2_0_6875_H_0_0 = p[130]
    beam_pinned_pinned2_0_6875_H_0_1 = p[131]
    beam_pinned_pinned2_0_6875_H_1_0 = p[132]
    beam_pinned_pinned2_0_6875_H_1_1 = p[133]
    beam_pinned_pinned2_0_75_at_0_0 = p[134]
    beam_pinned_pinned2_0_75_shape_1_0 = p[135]
    beam_pinned_pinned2_0_75_shape_1_1 = p[136]
    beam_pinned_pinned2_0_75_slope_0_0 = p[137]
    beam_pinned_pinned2_0_75_H_0_0 = p[138]
    beam_pinned_pinned2_0_75_H_0_1 = p[139]
    beam_pinned_pinned2_0_75_H_1_0 = p[140]
    beam_pinned_pinned2_0_75_H_1_1 = p[141]
    beam_pinned_pinned2_0_8125_at_0_0 = p[142]
    beam_pinned_pinned2_0_8125_shape_1_0 = p[143]
    beam_pinned_pinned2_0_8125_shape_1_1 = p[144]
    beam_pinned_pinned2_0_8125_slope_0_0 = p[145]
    beam_pinned_pinned2_0_8125_slope_1_0 = p[146]
    beam_pinned_pinned2_0_8125_H_0_0 = p[147]
    beam_pinned_pinned2_0_8125_H_0_1 = p[148]
    beam_pinned_pinned2_0_8125_H_1_0 = p[149]
    beam_pinned_pinned2_0_8125_H_1_1 = p[150]
    beam_pinned_pinned2_0_875_at_0_0 = p[151]
    beam_pinned_pinned2_0_875_shape_1_0 = p[152]
    beam_pinned_pinned2_0_875_shape_1_1 = p[153]
    beam_pinned_pinned2_0_875_slope_0_0 = p[154]
    beam_pinned_pinned2_0_875_slope_1_0 = p[155]
    beam_pinned_pinned2_0_875_H_0_0 = p[156]
    beam_pinned_pinned2_0_875_H_0_1 = p[157]
    beam_pinned_pinned2_0_875_H_1_0 = p[158]
    beam_pinned_pinned2_0_875_H_1_1 = p[159]
    beam_pinned_pinned2_0_9375_at_0_0 = p[160]
    beam_pinned_pinned2_0_9375_shape_1_0 = p[161]
    beam_pinned_pinned2_0_9375_shape_1_1 = p[162]
    beam_pinned_pinned2_0_9375_slope_0_0 = p[163]
    beam_pinned_pinned2_0_9375_slope_1_0 = p[164]
    beam_pinned_pinned2_0_9375_H_0_0 = p[165]
    beam_pinned_pinned2_0_9375_H_0_1 = p[166]
    beam_pinned_pinned2_0_9375_H_1_0 = p[167]
    beam_pinned_pinned2_0_9375_H_1_1 = p[168]
    # intermediate terms (14)
    w0 = beam_pinned_pinned2_0_0_slope_0_0 / coupler_length
    w1 = beam_pinned_pinned2_0_0_slope_1_0 / coupler_length
    w2 = beam_pinned_pinned2_1_0_slope_0_0 / coupler_length
    w3 = beam_pinned_pinned2_1_0_slope_1_0 / coupler_length
    w4 = beam_pinned_pinned2_0_0_slope_0_0 / rocker_length
    w5 = beam_pinned_pinned2_0_0_slope_1_0 / rocker_length
    w6 = beam_pinned_pinned2_1_0_slope_0_0 / rocker_length
    w7 = beam_pinned_pinned2_1_0_slope_1_0 / rocker_length
    w8 = beam_pinned_pinned2_1_0_H_0_0 / coupler_length
    w9 = beam_pinned_pinned2_1_0_H_1_1 / coupler_length
    w10 = beam_pinned_pinned2_1_0_H_0_0 / rocker_length
    w11 = beam_pinned_pinned2_1_0_H_1_1 / rocker_length
    w12 = ca.sqrt(12.0 * coupler_second_moment / coupler_area)
    w13 = ca.sqrt(12.0 * rocker_second_moment / rocker_area)
    # outputs
    positions = ca.SX(3, 42)
    positions[0, 1] = coupler_length * beam_pinned_pinned2_0_0625_at_0_0
    positions[0, 2] = coupler_length * beam_pinned_pinned2_0_125_at_0_0
    positions[0, 3] = coupler_length * beam_pinned_pinned2_0_1875_at_0_0
    positions[0, 4] = coupler_length * beam_pinned_pinned2_0_25_at_0_0
    positions[0, 5] = coupler_length * beam_pinned_pinned2_0_3125_at_0_0
    positions[0, 6] = coupler_length * beam_pinned_pinned2_0_375_at_0_0
    positions[0, 7] = coupler_length * beam_pinned_pinned2_0_4375_at_0_0
    positions[0, 8] = coupler_length * beam_pinned_pinned2_0_5_at_0_0
    positions[0, 9] = coupler_length * beam_pinned_pinned2_0_5625_at_0_0
    positions[0, 10] = coupler_length * beam_pinned_pinned2_0_625_at_0_0
    positions[0, 11] = coupler_length * beam_pinned_pinned2_0_6875_at_0_0
    positions[0, 12] = coupler_length * beam_pinned_pinned2_0_75_at_0_0
    positions[0, 13] = coupler_length * beam_pinned_pinned2_0_8125_at_0_0
    positions[0, 14] = coupler_length * beam_pinned_pinned2_0_875_at_0_0
    positions[0, 15] = coupler_length * beam_pinned_pinned2_0_9375_at_0_0
    positions[0, 16] = coupler_length
    positions[0, 18] = rocker_length * beam_pinned_pinned2_0_0625_at_0_0
    positions[0, 19] = rocker_length * beam_pinned_pinned2_0_125_at_0_0
    positions[0, 20] = rocker_length * beam_pinned_pinned2_0_1875_at_0_0
    positions[0, 21] = rocker_length * beam_pinned_pinned2_0_25_at_0_0
    positions[0, 22] = rocker_length * beam_pinned_pinned2_0_3125_at_0_0
    positions[0, 23] = rocker_length * beam_pinned_pinned2_0_375_at_0_0
    positions[0, 24] = rocker_length * beam_pinned_pinned2_0_4375_at_0_0
    positions[0, 25] = rocker_length * beam_pinned_pinned2_0_5_at_0_0
    positions[0, 26] = rocker_length * beam_pinned_pinned2_0_5625_at_0_0
    positions[0, 27] = rocker_length * beam_pinned_pinned2_0_625_at_0_0
    positions[0, 28] = rocker_length * beam_pinned_pinned2_0_6875_at_0_0
    positions[0, 29] = rocker_length * beam_pinned_pinned2_0_75_at_0_0
    positions[0, 30] = rocker_length * beam_pinned_pinned2_0_8125_at_0_0
    positions[0, 31] = rocker_length * beam_pinned_pinned2_0_875_at_0_0
    positions[0, 32] = rocker_length * beam_pinned_pinned2_0_9375_at_0_0
    positions[0, 33] = rocker_length
    positions[0, 35] = ground_right_x
    positions[0, 37] = crank_tip_x
    positions[0, 39] = coupler_length
    positions[0, 40] = rocker_length
    axes = ca.SX(9, 42)
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
    axes[0, 23] = 1.0
    axes[0, 24] = 1.0
    axes[0, 25] = 1.0
    axes[0, 26] = 1.0
    axes[0, 27] = 1.0
    axes[0, 28] = 1.0
    axes[0, 29] = 1.0
    axes[0, 30] = 1.0
    axes[0, 31] = 1.0
    axes[0, 32] = 1.0
    axes[0, 33] = 1.0
    axes[0, 34] = 1.0
    axes[0, 35] = 1.0
    axes[0, 36] = 1.0
    axes[0, 37] = 1.0
    axes[0, 38] = 1.0
    axes[0, 39] = 1.0
    axes[0, 40] = 1.0
    axes[0, 41] = 1.0
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
    axes[4, 23] = 1.0
    axes[4, 24] = 1.0
    axes[4, 25] = 1.0
    axes[4, 26] = 1.0
    axes[4, 27] = 1.0
    axes[4, 28] = 1.0
    axes[4, 29] = 1.0
    axes[4, 30] = 1.0
    axes[4, 31] = 1.0
    axes[4, 32] = 1.0
    axes[4, 33] = 1.0
    axes[4, 34] = 1.0
    axes[4, 35] = 1.0
    axes[4, 36] = 1.0
    axes[4, 37] = 1.0
    axes[4, 38] = 1.0
    axes[4, 39] = 1.0
    axes[4, 40] = 1.0
    axes[4, 41] = 1.0
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
    axes[8, 23] = 1.0
    axes[8, 24] = 1.0
    axes[8, 25] = 1.0
    axes[8, 26] = 1.0
    axes[8, 27] = 1.0
    axes[8, 28] = 1.0
    axes[8, 29] = 1.0
    axes[8, 30] = 1.0
    axes[8, 31] = 1.0
    axes[8, 32] = 1.0
    axes[8, 33] = 1.0
    axes[8, 34] = 1.0
    axes[8, 35] = 1.0
    axes[8, 36] = 1.0
    axes[8, 37] = 1.0
    axes[8, 38] = 1.0
    axes[8, 39] = 1.0
    axes[8, 40] = 1.0
    axes[8, 41] = 1.0
    shapes = ca.SX(3, 76)
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
    shapes[1, 36] = beam_pinned_pinned2_0_0625_shape_1_0
    shapes[1, 37] = beam_pinned_pinned2_0_0625_shape_1_1
    shapes[1, 38] = beam_pinned_pinned2_0_125_shape_1_0
    shapes[1, 39] = beam_pinned_pinned2_0_125_shape_1_1
    shapes[1, 40] = beam_pinned_pinned2_0_1875_shape_1_0
    shapes[1, 41] = beam_pinned_pinned2_0_1875_shape_1_1
    shapes[1, 42] = beam_pinned_pinned2_0_25_shape_1_0
    shapes[1, 43] = beam_pinned_pinned2_0_25_shape_1_1
    shapes[1, 44] = beam_pinned_pinned2_0_3125_shape_1_0
    shapes[1, 45] = beam_pinned_pinned2_0_3125_shape_1_1
    shapes[1, 46] = beam_pinned_pinned2_0_375_shape_1_0
    shapes[1, 47] = beam_pinned_pinned2_0_375_shape_1_1
    shapes[1, 48] = beam_pinned_pinned2_0_4375_shape_1_0
    shapes[1, 49] = beam_pinned_pinned2_0_4375_shape_1_1
    shapes[1, 50] = beam_pinned_pinned2_0_5_shape_1_0
    shapes[1, 52] = beam_pinned_pinned2_0_5625_shape_1_0
    shapes[1, 53] = beam_pinned_pinned2_0_5625_shape_1_1
    shapes[1, 54] = beam_pinned_pinned2_0_625_shape_1_0
    shapes[1, 55] = beam_pinned_pinned2_0_625_shape_1_1
    shapes[1, 56] = beam_pinned_pinned2_0_6875_shape_1_0
    shapes[1, 57] = beam_pinned_pinned2_0_6875_shape_1_1
    shapes[1, 58] = beam_pinned_pinned2_0_75_shape_1_0
    shapes[1, 59] = beam_pinned_pinned2_0_75_shape_1_1
    shapes[1, 60] = beam_pinned_pinned2_0_8125_shape_1_0
    shapes[1, 61] = beam_pinned_pinned2_0_8125_shape_1_1
    shapes[1, 62] = beam_pinned_pinned2_0_875_shape_1_0
    shapes[1, 63] = beam_pinned_pinned2_0_875_shape_1_1
    shapes[1, 64] = beam_pinned_pinned2_0_9375_shape_1_0
    shapes[1, 65] = beam_pinned_pinned2_0_9375_shape_1_1
    turns = ca.SX(3, 76)
    turns[2, 0] = w0
    turns[2, 1] = w1
    turns[2, 2] = beam_pinned_pinned2_0_0625_slope_0_0 / coupler_length
    turns[2, 3] = beam_pinned_pinned2_0_0625_slope_1_0 / coupler_length
    turns[2, 4] = beam_pinned_pinned2_0_125_slope_0_0 / coupler_length
    turns[2, 5] = beam_pinned_pinned2_0_125_slope_1_0 / coupler_length
    turns[2, 6] = beam_pinned_pinned2_0_1875_slope_0_0 / coupler_length
    turns[2, 7] = beam_pinned_pinned2_0_1875_slope_1_0 / coupler_length
    turns[2, 8] = beam_pinned_pinned2_0_25_slope_0_0 / coupler_length
    turns[2, 10] = beam_pinned_pinned2_0_3125_slope_0_0 / coupler_length
    turns[2, 11] = beam_pinned_pinned2_0_3125_slope_1_0 / coupler_length
    turns[2, 12] = beam_pinned_pinned2_0_375_slope_0_0 / coupler_length
    turns[2, 13] = beam_pinned_pinned2_0_375_slope_1_0 / coupler_length
    turns[2, 14] = beam_pinned_pinned2_0_4375_slope_0_0 / coupler_length
    turns[2, 15] = beam_pinned_pinned2_0_4375_slope_1_0 / coupler_length
    turns[2, 17] = beam_pinned_pinned2_0_5_slope_1_0 / coupler_length
    turns[2, 18] = beam_pinned_pinned2_0_5625_slope_0_0 / coupler_length
    turns[2, 19] = beam_pinned_pinned2_0_5625_slope_1_0 / coupler_length
    turns[2, 20] = beam_pinned_pinned2_0_625_slope_0_0 / coupler_length
    turns[2, 21] = beam_pinned_pinned2_0_625_slope_1_0 / coupler_length
    turns[2, 22] = beam_pinned_pinned2_0_6875_slope_0_0 / coupler_length
    turns[2, 23] = beam_pinned_pinned2_0_6875_slope_1_0 / coupler_length
    turns[2, 24] = beam_pinned_pinned2_0_75_slope_0_0 / coupler_length
    turns[2, 26] = beam_pinned_pinned2_0_8125_slope_0_0 / coupler_length
    turns[2, 27] = beam_pinned_pinned2_0_8125_slope_1_0 / coupler_length
    turns[2, 28] = beam_pinned_pinned2_0_875_slope_0_0 / coupler_length
    turns[2, 29] = beam_pinned_pinned2_0_875_slope_1_0 / coupler_length
    turns[2, 30] = beam_pinned_pinned2_0_9375_slope_0_0 / coupler_length
    turns[2, 31] = beam_pinned_pinned2_0_9375_slope_1_0 / coupler_length
    turns[2, 32] = w2
    turns[2, 33] = w3
    turns[2, 34] = w4
    turns[2, 35] = w5
    turns[2, 36] = beam_pinned_pinned2_0_0625_slope_0_0 / rocker_length
    turns[2, 37] = beam_pinned_pinned2_0_0625_slope_1_0 / rocker_length
    turns[2, 38] = beam_pinned_pinned2_0_125_slope_0_0 / rocker_length
    turns[2, 39] = beam_pinned_pinned2_0_125_slope_1_0 / rocker_length
    turns[2, 40] = beam_pinned_pinned2_0_1875_slope_0_0 / rocker_length
    turns[2, 41] = beam_pinned_pinned2_0_1875_slope_1_0 / rocker_length
    turns[2, 42] = beam_pinned_pinned2_0_25_slope_0_0 / rocker_length
    turns[2, 44] = beam_pinned_pinned2_0_3125_slope_0_0 / rocker_length
    turns[2, 45] = beam_pinned_pinned2_0_3125_slope_1_0 / rocker_length
    turns[2, 46] = beam_pinned_pinned2_0_375_slope_0_0 / rocker_length
    turns[2, 47] = beam_pinned_pinned2_0_375_slope_1_0 / rocker_length
    turns[2, 48] = beam_pinned_pinned2_0_4375_slope_0_0 / rocker_length
    turns[2, 49] = beam_pinned_pinned2_0_4375_slope_1_0 / rocker_length
    turns[2, 51] = beam_pinned_pinned2_0_5_slope_1_0 / rocker_length
    turns[2, 52] = beam_pinned_pinned2_0_5625_slope_0_0 / rocker_length
    turns[2, 53] = beam_pinned_pinned2_0_5625_slope_1_0 / rocker_length
    turns[2, 54] = beam_pinned_pinned2_0_625_slope_0_0 / rocker_length
    turns[2, 55] = beam_pinned_pinned2_0_625_slope_1_0 / rocker_length
    turns[2, 56] = beam_pinned_pinned2_0_6875_slope_0_0 / rocker_length
    turns[2, 57] = beam_pinned_pinned2_0_6875_slope_1_0 / rocker_length
    turns[2, 58] = beam_pinned_pinned2_0_75_slope_0_0 / rocker_length
    turns[2, 60] = beam_pinned_pinned2_0_8125_slope_0_0 / rocker_length
    turns[2, 61] = beam_pinned_pinned2_0_8125_slope_1_0 / rocker_length
    turns[2, 62] = beam_pinned_pinned2_0_875_slope_0_0 / rocker_length
    turns[2, 63] = beam_pinned_pinned2_0_875_slope_1_0 / rocker_length
    turns[2, 64] = beam_pinned_pinned2_0_9375_slope_0_0 / rocker_length
    turns[2, 65] = beam_pinned_pinned2_0_9375_slope_1_0 / rocker_length
    turns[2, 66] = w6
    turns[2, 67] = w7
    turns[2, 68] = w0
    turns[2, 69] = w1
    turns[2, 70] = w2
    turns[2, 71] = w3
    turns[2, 72] = w6
    turns[2, 73] = w7
    turns[2, 74] = w4
    turns[2, 75] = w5
    H = ca.horzcat(
        beam_pinned_pinned2_0_0625_H_0_0 / coupler_length, beam_pinned_pinned2_0_0625_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_0625_H_1_0 / coupler_length, beam_pinned_pinned2_0_0625_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_125_H_0_0 / coupler_length, beam_pinned_pinned2_0_125_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_125_H_1_0 / coupler_length, beam_pinned_pinned2_0_125_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_1875_H_0_0 / coupler_length, beam_pinned_pinned2_0_1875_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_1875_H_1_0 / coupler_length, beam_pinned_pinned2_0_1875_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_25_H_0_0 / coupler_length, beam_pinned_pinned2_0_25_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_25_H_1_0 / coupler_length, beam_pinned_pinned2_0_25_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_3125_H_0_0 / coupler_length, beam_pinned_pinned2_0_3125_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_3125_H_1_0 / coupler_length, beam_pinned_pinned2_0_3125_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_375_H_0_0 / coupler_length, beam_pinned_pinned2_0_375_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_375_H_1_0 / coupler_length, beam_pinned_pinned2_0_375_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_4375_H_0_0 / coupler_length, beam_pinned_pinned2_0_4375_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_4375_H_1_0 / coupler_length, beam_pinned_pinned2_0_4375_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_5_H_0_0 / coupler_length, beam_pinned_pinned2_0_5_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_5_H_1_0 / coupler_length, beam_pinned_pinned2_0_5_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_5625_H_0_0 / coupler_length, beam_pinned_pinned2_0_5625_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_5625_H_1_0 / coupler_length, beam_pinned_pinned2_0_5625_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_625_H_0_0 / coupler_length, beam_pinned_pinned2_0_625_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_625_H_1_0 / coupler_length, beam_pinned_pinned2_0_625_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_6875_H_0_0 / coupler_length, beam_pinned_pinned2_0_6875_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_6875_H_1_0 / coupler_length, beam_pinned_pinned2_0_6875_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_75_H_0_0 / coupler_length, beam_pinned_pinned2_0_75_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_75_H_1_0 / coupler_length, beam_pinned_pinned2_0_75_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_8125_H_0_0 / coupler_length, beam_pinned_pinned2_0_8125_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_8125_H_1_0 / coupler_length, beam_pinned_pinned2_0_8125_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_875_H_0_0 / coupler_length, beam_pinned_pinned2_0_875_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_875_H_1_0 / coupler_length, beam_pinned_pinned2_0_875_H_1_1 / coupler_length,
        beam_pinned_pinned2_0_9375_H_0_0 / coupler_length, beam_pinned_pinned2_0_9375_H_0_1 / coupler_length,
        beam_pinned_pinned2_0_9375_H_1_0 / coupler_length, beam_pinned_pinned2_0_9375_H_1_1 / coupler_length,
        w8, 0.0, 0.0, w9, beam_pinned_pinned2_0_0625_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_0625_H_0_1 / rocker_length, beam_pinned_pinned2_0_0625_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_0625_H_1_1 / rocker_length, beam_pinned_pinned2_0_125_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_125_H_0_1 / rocker_length, beam_pinned_pinned2_0_125_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_125_H_1_1 / rocker_length, beam_pinned_pinned2_0_1875_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_1875_H_0_1 / rocker_length, beam_pinned_pinned2_0_1875_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_1875_H_1_1 / rocker_length, beam_pinned_pinned2_0_25_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_25_H_0_1 / rocker_length, beam_pinned_pinned2_0_25_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_25_H_1_1 / rocker_length, beam_pinned_pinned2_0_3125_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_3125_H_0_1 / rocker_length, beam_pinned_pinned2_0_3125_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_3125_H_1_1 / rocker_length, beam_pinned_pinned2_0_375_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_375_H_0_1 / rocker_length, beam_pinned_pinned2_0_375_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_375_H_1_1 / rocker_length, beam_pinned_pinned2_0_4375_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_4375_H_0_1 / rocker_length, beam_pinned_pinned2_0_4375_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_4375_H_1_1 / rocker_length, beam_pinned_pinned2_0_5_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_5_H_0_1 / rocker_length, beam_pinned_pinned2_0_5_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_5_H_1_1 / rocker_length, beam_pinned_pinned2_0_5625_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_5625_H_0_1 / rocker_length, beam_pinned_pinned2_0_5625_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_5625_H_1_1 / rocker_length, beam_pinned_pinned2_0_625_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_625_H_0_1 / rocker_length, beam_pinned_pinned2_0_625_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_625_H_1_1 / rocker_length, beam_pinned_pinned2_0_6875_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_6875_H_0_1 / rocker_length, beam_pinned_pinned2_0_6875_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_6875_H_1_1 / rocker_length, beam_pinned_pinned2_0_75_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_75_H_0_1 / rocker_length, beam_pinned_pinned2_0_75_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_75_H_1_1 / rocker_length, beam_pinned_pinned2_0_8125_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_8125_H_0_1 / rocker_length, beam_pinned_pinned2_0_8125_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_8125_H_1_1 / rocker_length, beam_pinned_pinned2_0_875_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_875_H_0_1 / rocker_length, beam_pinned_pinned2_0_875_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_875_H_1_1 / rocker_length, beam_pinned_pinned2_0_9375_H_0_0 / rocker_length,
        beam_pinned_pinned2_0_9375_H_0_1 / rocker_length, beam_pinned_pinned2_0_9375_H_1_0 / rocker_length,
        beam_pinned_pinned2_0_9375_H_1_1 / rocker_length, w10, 0.0, 0.0, w11, w8, 0.0, 0.0, w9, w10, 0.0, 0.0,
        w11,
    )
    sections = ca.vertcat(
        ca.horzcat(w12, w13),
        ca.horzcat(coupler_area / w12, rocker_area / w13),
    )
    rigidities = ca.SX(2, 2)
    rigidities[0, 0] = coupler_youngs_modulus * coupler_second_moment
    rigidities[0, 1] = rocker_youngs_modulus * rocker_second_moment
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
