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
    gives c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    179 operations.
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
    # intermediate terms (30)
    w0 = coupler_density * coupler_area
    w1 = w0 * coupler_length
    w2 = beam_pinned_pinned2_1_0_H_0_0 / coupler_length
    w3 = beam_pinned_pinned2_1_0_H_1_1 / coupler_length
    w4 = beam_pinned_pinned2_1_0_H_0_0 / rocker_length
    w5 = beam_pinned_pinned2_1_0_H_1_1 / rocker_length
    w6 = rocker_density * rocker_area
    w7 = rocker_length * w6
    w8 = rocker_length**2
    w9 = w7 * beam_pinned_pinned2_mass_0_0
    w10 = w7 * beam_pinned_pinned2_xH_0_0
    w11 = w7 * beam_pinned_pinned2_mass_1_1
    w12 = w7 * beam_pinned_pinned2_xH_1_1
    w13 = coupler_length * w1
    w14 = w0 * beam_pinned_pinned2_H_0_0
    w15 = w0 * beam_pinned_pinned2_H_0_1
    w16 = w0 * beam_pinned_pinned2_H_1_0
    w17 = w0 * beam_pinned_pinned2_H_1_1
    w18 = coupler_length**2
    w19 = w1 * beam_pinned_pinned2_mass_0_0
    w20 = w1 * beam_pinned_pinned2_xH_0_0
    w21 = w1 * beam_pinned_pinned2_mass_1_1
    w22 = w1 * beam_pinned_pinned2_xH_1_1
    w23 = rocker_length * w7
    w24 = w6 * beam_pinned_pinned2_H_0_0
    w25 = w6 * beam_pinned_pinned2_H_0_1
    w26 = w6 * beam_pinned_pinned2_H_1_0
    w27 = w6 * beam_pinned_pinned2_H_1_1
    w28 = coupler_youngs_modulus * coupler_second_moment / (coupler_length * w18)
    w29 = rocker_youngs_modulus * rocker_second_moment / (rocker_length * w8)
    # outputs
    c = ca.vertcat(
        crank_tip_x,  # crank_tip_x
        coupler_length,  # coupler_length
        w1,  # c2
        crank_inertia + crank_tip_x * (crank_tip_x * w1),  # c3
        w2,  # c4
        w3,  # c5
        rocker_length,  # rocker_length
        w4,  # c7
        w5,  # c8
        w7 * w8 * beam_pinned_pinned2_i0_0_0,  # c9
        w9,  # c10
        w10,  # c11
        w7 * beam_pinned_pinned2_xH_0_1,  # c12
        w11,  # c13
        w7 * beam_pinned_pinned2_xH_1_0,  # c14
        w12,  # c15
        w13 * beam_pinned_pinned2_s1_0_0,  # c16
        w14,  # c17
        w15,  # c18
        w16,  # c19
        w17,  # c20
        w1 * beam_pinned_pinned2_phi_y_0_0,  # c21
        beam_pinned_pinned2_i0_0_0 * (w1 * w18),  # c22
        w19,  # c23
        w20,  # c24
        w1 * beam_pinned_pinned2_xH_0_1,  # c25
        w21,  # c26
        w1 * beam_pinned_pinned2_xH_1_0,  # c27
        w22,  # c28
        w13 * beam_pinned_pinned2_xi_phi_y_0_0,  # c29
        w13 * beam_pinned_pinned2_xi_phi_y_1_0,  # c30
        beam_pinned_pinned2_xi_phi_y_0_0 * w23,  # c31
        beam_pinned_pinned2_xi_phi_y_1_0 * w23,  # c32
        gravity_y,  # gravity_y
        w1 * gravity_y,  # c34
        beam_pinned_pinned2_s1_0_0 * w23,  # c35
        w24,  # c36
        w25,  # c37
        w26,  # c38
        w27,  # c39
        w7 * beam_pinned_pinned2_phi_y_0_0,  # c40
        w28 * beam_pinned_pinned2_kappa_lateral_0_0,  # c41
        w28 * beam_pinned_pinned2_kappa_lateral_1_1,  # c42
        beam_pinned_pinned2_kappa_lateral_0_0 * w29,  # c43
        beam_pinned_pinned2_kappa_lateral_1_1 * w29,  # c44
        ground_right_x,  # ground_right_x
        crank_inertia,  # crank_inertia
        w7,  # c47
        crank_mass,  # crank_mass
        gravity_y * crank_mass,  # c49
        w7 * gravity_y,  # c50
        w19 - w20,  # c51
        w2 * w3,  # c52
        w21 - w22,  # c53
        w9 - w10,  # c54
        w4 * w5,  # c55
        gravity_y * w24,  # c56
        gravity_y * w26,  # c57
        w11 - w12,  # c58
        gravity_y * w25,  # c59
        gravity_y * w27,  # c60
        2 * w2,  # c61
        2 * w3,  # c62
        2 * w4,  # c63
        2 * w5,  # c64
        w14 + w14,  # c65
        w15 + w16,  # c66
        w17 + w17,  # c67
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 5) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 5 x 5) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 5) [N, N m]: condensed force S^T (Q* - M s)
    521 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 2) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    72 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    123 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    193 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    271 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 68)
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
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 13 x 13) [SI]: mass matrix in all coordinates
    gives K (n x n = 13 x 13) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 13) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 13) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 13) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 13) [SI]: constraint Jacobian
    gives gamma_b (n_c = 8) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    833 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 68)
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
    # intermediate terms (75)
    w0 = ca.sin(coupler_theta)
    w1 = coupler_q1 * c17 + coupler_q2 * c18
    w2 = coupler_q1 * c19 + coupler_q2 * c20
    w3 = c16 - (coupler_q1 * w1 + coupler_q2 * w2) * 0.5
    w4 = ca.cos(coupler_theta)
    w5 = coupler_q1 * c21
    w6 = w0 * w3 + w4 * w5
    w7 = -w6
    w8 = -(w1 * w4 + w0 * c21)
    w9 = -(w2 * w4)
    w10 = w3 * w4 - w0 * w5
    w11 = w4 * c21 - w0 * w1
    w12 = w0 * w2
    w13 = -w12
    w14 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w15 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w16 = ca.sin(rocker_theta)
    w17 = rocker_q1 * c36 + rocker_q2 * c37
    w18 = rocker_q1 * c38 + rocker_q2 * c39
    w19 = c35 - (rocker_q1 * w17 + rocker_q2 * w18) * 0.5
    w20 = ca.cos(rocker_theta)
    w21 = rocker_q1 * c40
    w22 = w16 * w19 + w20 * w21
    w23 = -w22
    w24 = -(w17 * w20 + w16 * c40)
    w25 = -(w18 * w20)
    w26 = w19 * w20 - w16 * w21
    w27 = w20 * c40 - w16 * w17
    w28 = w16 * w18
    w29 = -w28
    w30 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w31 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w32 = coupler_theta_dot**2
    w33 = 2 * coupler_theta_dot
    w34 = coupler_q1_dot * c21
    w35 = w1 * coupler_q1_dot + w2 * coupler_q2_dot
    w36 = coupler_q1_dot * (coupler_q1_dot * c17 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + coupler_q2_dot * c20)
    w37 = w10 * w32 + w33 * (w4 * w34 - w0 * w35) + w4 * w36
    w38 = w6 * w32 + w0 * w36 + w33 * (w4 * w35 + w0 * w34)
    w39 = coupler_theta_dot * -2.0 * (w14 * coupler_q1_dot + w15 * coupler_q2_dot)
    w40 = w14 * w32
    w41 = w15 * w32
    w42 = rocker_theta_dot**2
    w43 = 2 * rocker_theta_dot
    w44 = rocker_q1_dot * c40
    w45 = w17 * rocker_q1_dot + w18 * rocker_q2_dot
    w46 = rocker_q1_dot * (rocker_q1_dot * c36 + rocker_q2_dot * c37) + rocker_q2_dot * (rocker_q1_dot * c38 + rocker_q2_dot * c39)
    w47 = w26 * w42 + w43 * (w20 * w44 - w16 * w45) + w20 * w46
    w48 = w22 * w42 + w16 * w46 + w43 * (w20 * w45 + w16 * w44)
    w49 = rocker_theta_dot * -2.0 * (w30 * rocker_q1_dot + w31 * rocker_q2_dot)
    w50 = w30 * w42
    w51 = w31 * w42
    w52 = w10 * gravity_y
    w53 = w11 * gravity_y
    w54 = w12 * gravity_y
    w55 = w26 * gravity_y
    w56 = w27 * gravity_y
    w57 = w28 * gravity_y
    w58 = ca.sin(crank_theta) * crank_tip_x
    w59 = ca.cos(crank_theta) * crank_tip_x
    w60 = coupler_q1 * c4
    w61 = coupler_q2 * c5
    w62 = coupler_length - (coupler_q1 * w60 + coupler_q2 * w61) * 0.5
    w63 = w0 * w62
    w64 = w4 * w62
    w65 = rocker_q1 * c7
    w66 = rocker_q2 * c8
    w67 = rocker_length - (rocker_q1 * w65 + rocker_q2 * w66) * 0.5
    w68 = w16 * w67
    w69 = w20 * w67
    w70 = crank_theta_dot**2
    w71 = coupler_q1_dot * w60 + coupler_q2_dot * w61
    w72 = coupler_q1_dot * (coupler_q1_dot * c4) + coupler_q2_dot * (coupler_q2_dot * c5)
    w73 = rocker_q1_dot * w65 + rocker_q2_dot * w66
    w74 = rocker_q1_dot * (rocker_q1_dot * c7) + rocker_q2_dot * (rocker_q2_dot * c8)
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
    M[3, 6] = w8
    M[3, 7] = w9
    # coupler.y
    M[4, 4] = c2
    M[4, 5] = w10
    M[4, 6] = w11
    M[4, 7] = w13
    # coupler.theta
    M[5, 3] = w7
    M[5, 4] = w10
    M[5, 5] = c22 + (coupler_q1 * w14 + coupler_q2 * w15)
    M[5, 6] = c29
    M[5, 7] = c30
    # coupler.q1
    M[6, 3] = w8
    M[6, 4] = w11
    M[6, 5] = c29
    M[6, 6] = c23
    # coupler.q2
    M[7, 3] = w9
    M[7, 4] = w13
    M[7, 5] = c30
    M[7, 7] = c26
    # rocker.x
    M[8, 8] = c47
    M[8, 10] = w23
    M[8, 11] = w24
    M[8, 12] = w25
    # rocker.y
    M[9, 9] = c47
    M[9, 10] = w26
    M[9, 11] = w27
    M[9, 12] = w29
    # rocker.theta
    M[10, 8] = w23
    M[10, 9] = w26
    M[10, 10] = c9 + (rocker_q1 * w30 + rocker_q2 * w31)
    M[10, 11] = c31
    M[10, 12] = c32
    # rocker.q1
    M[11, 8] = w24
    M[11, 9] = w27
    M[11, 10] = c31
    M[11, 11] = c10
    # rocker.q2
    M[12, 8] = w25
    M[12, 9] = w29
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
        w37,  # coupler.x
        w38,  # coupler.y
        w39,  # coupler.theta
        w40,  # coupler.q1
        w41,  # coupler.q2
        w47,  # rocker.x
        w48,  # rocker.y
        w49,  # rocker.theta
        w50,  # rocker.q1
        w51,  # rocker.q2
    )
    Q_F = ca.vertcat(
        0.0,  # crank.x
        c49,  # crank.y
        0.0,  # crank.theta
        0.0,  # coupler.x
        c34,  # coupler.y
        w52,  # coupler.theta
        w53,  # coupler.q1
        -w54,  # coupler.q2
        0.0,  # rocker.x
        c50,  # rocker.y
        w55,  # rocker.theta
        w56,  # rocker.q1
        -w57,  # rocker.q2
    )
    Q_star = ca.vertcat(
        0.0,  # crank.x
        c49,  # crank.y
        0.0,  # crank.theta
        w37,  # coupler.x
        c34 + w38,  # coupler.y
        w39 + w52,  # coupler.theta
        w53 + (w40 - coupler_q1 * c41),  # coupler.q1
        w41 - coupler_q2 * c42 - w54,  # coupler.q2
        w47,  # rocker.x
        w48 + c50,  # rocker.y
        w49 + w55,  # rocker.theta
        w56 + (w50 - rocker_q1 * c43),  # rocker.q1
        w51 - rocker_q2 * c44 - w57,  # rocker.q2
    )
    C_q = ca.SX(8, 13)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w58
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w59
    C_q[3, 4] = 1.0
    # C.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w63
    C_q[4, 6] = w4 * w60
    C_q[4, 7] = w4 * w61
    C_q[4, 8] = 1.0
    C_q[4, 10] = -w68
    C_q[4, 11] = -(w20 * w65)
    C_q[4, 12] = -(w20 * w66)
    # C.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w64
    C_q[5, 6] = w0 * w60
    C_q[5, 7] = w0 * w61
    C_q[5, 9] = 1.0
    C_q[5, 10] = w69
    C_q[5, 11] = -(w16 * w65)
    C_q[5, 12] = -(w16 * w66)
    # D.x
    C_q[6, 8] = 1.0
    # D.y
    C_q[7, 9] = 1.0
    gamma_b = ca.SX(8, 1)
    gamma_b[2] = -(w59 * w70)  # B.x
    gamma_b[3] = -(w58 * w70)  # B.y
    gamma_b[4] = w33 * (w0 * w71) - (w4 * w72 + w32 * w64) - (w43 * (w16 * w73) - (w20 * w74 + w42 * w69))  # C.x
    gamma_b[5] = w16 * w74 + w43 * (w20 * w73) + w42 * w68 - (w0 * w72 + w33 * (w4 * w71) + w32 * w63)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 13) [mixed]: rates of all coordinates
    takes q_ddot (n = 13) [mixed]: accelerations of all coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    350 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    280 operations.
    """
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 68)
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
    c49 = c[49]
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
    potential = ca.vertcat(-(crank_y * c49 + (w7 + coupler_y * c2) * gravity_y + (w25 + rocker_y * c47) * gravity_y))
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 13) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    56 operations.
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i, through q_d
    1742 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 68)
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
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    # intermediate terms (370)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = coupler_theta_dot**2
    w2 = coupler_q1 * c17
    w3 = w2 + coupler_q2 * c18
    w4 = coupler_q2 * c20
    w5 = coupler_q1 * c19 + w4
    w6 = c16 - (coupler_q1 * w3 + coupler_q2 * w5) * 0.5
    w7 = ca.cos(coupler_theta)
    w8 = coupler_q1 * c21
    w9 = ca.sin(coupler_theta)
    w10 = w6 * w7 - w8 * w9
    w11 = w1 * w10
    w12 = coupler_q1_dot * c17
    w13 = coupler_q2_dot * c20
    w14 = coupler_q1_dot * (w12 + coupler_q2_dot * c18) + coupler_q2_dot * (coupler_q1_dot * c19 + w13)
    w15 = w7 * w14
    w16 = 2 * coupler_theta_dot
    w17 = coupler_q1_dot * c21
    w18 = w3 * coupler_q1_dot + w5 * coupler_q2_dot
    w19 = w7 * w17 - w9 * w18
    w20 = w16 * w19
    w21 = ca.cos(rocker_theta)
    w22 = rocker_q1 * c7
    w23 = rocker_q2 * c8
    w24 = rocker_length - (rocker_q1 * w22 + rocker_q2 * w23) * 0.5
    w25 = w21 * w24
    w26 = coupler_q1 * c4
    w27 = coupler_q2 * c5
    w28 = coupler_q1_dot * w26 + coupler_q2_dot * w27
    w29 = w7 * w28
    w30 = w16 * w29
    w31 = coupler_q1_dot * c4
    w32 = coupler_q2_dot * c5
    w33 = coupler_q1_dot * w31 + coupler_q2_dot * w32
    w34 = w9 * w33
    w35 = coupler_length - (coupler_q1 * w26 + coupler_q2 * w27) * 0.5
    w36 = w9 * w35
    w37 = w1 * w36
    w38 = w30 + (w34 + w37)
    w39 = ca.sin(rocker_theta)
    w40 = w24 * w39
    w41 = w7 * w33
    w42 = w9 * w28
    w43 = w16 * w42
    w44 = w7 * w35
    w45 = w1 * w44
    w46 = w41 - w43 + w45
    w47 = w25 * w36 - w40 * w44
    w48 = 2 * rocker_theta_dot
    w49 = w22 * rocker_q1_dot + w23 * rocker_q2_dot
    w50 = w39 * w49
    w51 = w48 * w50
    w52 = rocker_q1_dot * c7
    w53 = rocker_q2_dot * c8
    w54 = rocker_q1_dot * w52 + rocker_q2_dot * w53
    w55 = w21 * w54
    w56 = rocker_theta_dot**2
    w57 = w25 * w56
    w58 = crank_theta_dot**2
    w59 = w0 * w58
    w60 = w43 - (w41 + w45) - (w51 - (w55 + w57)) - w59
    w61 = w39 * w54
    w62 = w21 * w49
    w63 = w48 * w62
    w64 = w40 * w56
    w65 = ca.sin(crank_theta) * crank_tip_x
    w66 = w58 * w65
    w67 = w61 + w63 + w64 - (w37 + (w30 + w34)) - w66
    w68 = (w25 * w60 + w40 * w67) / w47
    w69 = w68 / w47
    w70 = w25 * w44 + w36 * w40
    w71 = w69 * w70
    w72 = (w25 * w38 - w40 * w46) / w47 - w71
    w73 = w6 * w9 + w7 * w8
    w74 = w68 * w73
    w75 = w10 * w68
    w76 = w1 * w73
    w77 = w9 * w17 + w7 * w18
    w78 = w16 * w77
    w79 = w9 * w14
    w80 = rocker_theta_dot * -2.0
    w81 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w82 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w83 = rocker_q1_dot * w81 + rocker_q2_dot * w82
    w84 = rocker_q1 * c36
    w85 = w84 + rocker_q2 * c37
    w86 = rocker_q2 * c39
    w87 = rocker_q1 * c38 + w86
    w88 = c35 - (rocker_q1 * w85 + rocker_q2 * w87) * 0.5
    w89 = rocker_q1 * c40
    w90 = c9 + (rocker_q1 * w81 + rocker_q2 * w82)
    w91 = (w44 * w60 + w36 * w67) / w47
    w92 = w80 * w83 + (w21 * w88 - w39 * w89) * gravity_y - w90 * w91
    w93 = (w0 * w44 + w36 * w65) / w47
    w94 = (w0 * w36 - w44 * w65) / w47
    w95 = w94 / w47
    w96 = w70 * w95
    w97 = w93 - w96
    w98 = w91 / w47
    w99 = w70 * w98
    w100 = (w38 * w44 - w36 * w60 + (w44 * w67 - w36 * w46)) / w47 - w99
    w101 = w90 * w100
    w102 = w0 * (w11 + w15 + w20 - (w10 * w72 - w74)) - w65 * (w75 + w72 * w73 - (w76 + w78 + w79)) + (w92 * w97 - w94 * w101)
    w103 = (w0 * w40 - w25 * w65) / w47
    w104 = w10 * w59 + w66 * w73
    w105 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w106 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w107 = c22 + (coupler_q1 * w105 + coupler_q2 * w106)
    w108 = w73 * gravity_y + (w104 + w72 * w107)
    w109 = coupler_theta_dot * -2.0
    w110 = coupler_q1_dot * w105 + coupler_q2_dot * w106
    w111 = w109 * w110 + w10 * gravity_y - (w59 * w73 - w10 * w66 + w68 * w107)
    w112 = w103 / w47
    w113 = w70 * w112
    w114 = w102 - (w103 * w108 + w111 * w113)
    w115 = w57 + (w55 - w51)
    w116 = w63 + (w61 + w64)
    w117 = w99 + (w36 * w115 - w44 * w116) / w47
    w118 = (w39 * w88 + w21 * w89) * gravity_y + w90 * w117
    w119 = w71 + (w25 * w67 + w40 * w115 - (w40 * w60 + w25 * w116)) / w47
    w120 = (w0 * w25 + w40 * w65) / w47
    w121 = w113 + w120
    w122 = w107 * w119
    w123 = w92 * w96 - w94 * w118 - (w0 * (w10 * w119) + w65 * (w73 * w119)) + (w111 * w121 - w103 * w122)
    w124 = (w25 * w66 - w40 * w59) / w47
    w125 = w59 * c2
    w126 = w66 * c2
    w127 = w0 * (w10 * w124 - w125) + w65 * (c34 + (w78 + (w76 + w79)) - (w75 - w126)) + (w65 * (w73 * w124 - w126) + w0 * (w15 + (w11 + w20) + (w74 + w125)))
    w128 = (w44 * w66 - w36 * w59) / w47
    w129 = w90 * w128
    w130 = w107 * w124 - w104
    w131 = 2 * w42 - w16 * w44
    w132 = 2 * w29 + w16 * w36
    w133 = (w25 * w131 - w40 * w132) / w47
    w134 = (w44 * w131 - w36 * w132) / w47
    w135 = w90 * w134
    w136 = w110 * -2.0 - w107 * w133
    w137 = w0 * (w16 * w73 + 2 * w77 - w10 * w133) - w65 * (w10 * w16 + 2 * w19 + w73 * w133) - w94 * w135 + w103 * w136
    w138 = w9 * w26
    w139 = w25 * w138
    w140 = w7 * w26
    w141 = w40 * w140
    w142 = (w25 * w140 + w40 * w138) / w47
    w143 = w142 / w47
    w144 = w70 * w143
    w145 = (w139 - w141) / w47 + w144
    w146 = w9 * w27
    w147 = w25 * w146
    w148 = w7 * w27
    w149 = w40 * w148
    w150 = (w25 * w148 + w40 * w146) / w47
    w151 = w150 / w47
    w152 = w70 * w151
    w153 = (w147 - w149) / w47 + w152
    w154 = w22 * w39
    w155 = w21 * w22
    w156 = rocker_q1 * w24 * c7 / w47
    w157 = w156 / w47
    w158 = w70 * w157
    w159 = rocker_q1_dot * w158
    w160 = w23 * w39
    w161 = w21 * w23
    w162 = rocker_q2 * w24 * c8 / w47
    w163 = w162 / w47
    w164 = w70 * w163
    w165 = rocker_q2_dot * w164
    w166 = crank_theta_dot * w121 - coupler_q1_dot * w145 - coupler_q2_dot * w153 + w159 + w165
    w167 = w141 - w139
    w168 = w167 / w47 - w144
    w169 = w149 - w147
    w170 = w169 / w47 - w152
    w171 = w165 + (w159 + (crank_theta_dot * w113 + coupler_q1_dot * w168 + coupler_q2_dot * w170))
    w172 = w94 * w166 - w103 * w171 - crank_theta_dot * w120
    w173 = 2 * w62 + w40 * w48
    w174 = 2 * w50 - w25 * w48
    w175 = (w36 * w173 - w44 * w174) / w47
    w176 = w83 * -2.0 - w90 * w175
    w177 = (w40 * w173 - w25 * w174) / w47
    w178 = w107 * w177
    w179 = w94 * w176 - (w0 * (w10 * w177) + w65 * (w73 * w177)) - w103 * w178
    w180 = coupler_q1 * w35 * c4 / w47
    w181 = w180 / w47
    w182 = w70 * w181
    w183 = coupler_q1_dot * w182
    w184 = coupler_q2 * w35 * c5 / w47
    w185 = w184 / w47
    w186 = w70 * w185
    w187 = coupler_q2_dot * w186
    w188 = w44 * w154
    w189 = w36 * w155
    w190 = w188 - w189
    w191 = (w44 * w155 + w36 * w154) / w47
    w192 = w191 / w47
    w193 = w70 * w192
    w194 = w190 / w47 - w193
    w195 = w44 * w160
    w196 = w36 * w161
    w197 = w195 - w196
    w198 = (w44 * w161 + w36 * w160) / w47
    w199 = w198 / w47
    w200 = w70 * w199
    w201 = w197 / w47 - w200
    w202 = crank_theta_dot * w97 + w183 + w187 + rocker_q1_dot * w194 + rocker_q2_dot * w201
    w203 = w193 + (w189 - w188) / w47
    w204 = w200 + (w196 - w195) / w47
    w205 = crank_theta_dot * w96 - w183 - w187 + rocker_q1_dot * w203 + rocker_q2_dot * w204
    w206 = w103 * w202 + w94 * w205 - crank_theta_dot * w93
    w207 = w103 * w114 + w94 * w123 - (w127 + (w94 * w129 + w92 * w93) + (w103 * w130 + w111 * w120)) + (w137 * w172 + w179 * w206)
    w208 = w9 * c21
    w209 = w3 * w7 + w208
    w210 = w7 * c21
    w211 = w66 * w209 + w59 * (w210 - w3 * w9)
    w212 = w92 * w182
    w213 = w209 * gravity_y + (w211 + w72 * c29) - (w212 + w101 * w180) + (w111 * w168 - w108 * w142)
    w214 = w119 * c29 + (w212 - w118 * w180) + (w111 * w145 - w122 * w142)
    w215 = w16 * w105 - w133 * c29 + w135 * w180 - w136 * w142
    w216 = w142 * w178 - (w177 * c29 + w176 * w180)
    w217 = w129 * w180 - (w124 * c29 - w211) + w130 * w142 - (w103 * w213 + w94 * w214) + (w172 * w215 + w206 * w216)
    w218 = w59 * (w5 * w9)
    w219 = w5 * w7
    w220 = w66 * w219
    w221 = w92 * w186
    w222 = w219 * gravity_y + (w220 - w218 + w72 * c30) - (w221 + w101 * w184) + (w111 * w170 - w108 * w150)
    w223 = w119 * c30 + (w221 - w118 * w184) + (w111 * w153 - w122 * w150)
    w224 = w16 * w106 - w133 * c30 + w135 * w184 - w136 * w150
    w225 = w150 * w178 - (w177 * c30 + w176 * w184)
    w226 = w129 * w184 - (w218 - w220 + w124 * c30) + w130 * w150 - (w103 * w222 + w94 * w223) + (w172 * w224 + w206 * w225)
    w227 = w111 * w158
    w228 = w92 * w194 - w101 * w191 - w100 * c31 - (w108 * w156 + w227)
    w229 = w39 * c40
    w230 = w92 * w203 - w118 * w191 - ((w229 + w21 * w85) * gravity_y + w117 * c31) + (w227 - w122 * w156)
    w231 = w136 * w156 - (w134 * c31 + w135 * w191)
    w232 = w48 * w81 - w175 * c31 + w176 * w191 - w156 * w178
    w233 = w103 * w228 + w94 * w230 - (w128 * c31 + w129 * w191 + w130 * w156) + (w172 * w231 + w206 * w232)
    w234 = w111 * w164
    w235 = w92 * w201 - w101 * w198 - w100 * c32 - (w108 * w162 + w234)
    w236 = w92 * w204 - w118 * w198 - (w21 * w87 * gravity_y + w117 * c32) + (w234 - w122 * w162)
    w237 = w136 * w162 - (w134 * c32 + w135 * w198)
    w238 = w48 * w82 - w175 * c32 + w176 * w198 - w162 * w178
    w239 = w103 * w235 + w94 * w236 - (w128 * c32 + w129 * w198 + w130 * w162) + (w172 * w237 + w206 * w238)
    w240 = (w2 + w3 + coupler_q2 * c19) * 0.5
    w241 = w210 - w9 * w240
    w242 = w12 + coupler_q2_dot * c19
    w243 = w16 * (w9 * w31) + w1 * w140
    w244 = w16 * (w7 * w31) - w1 * w138
    w245 = (w25 * w243 - w40 * w244) / w47 - w69 * w167
    w246 = w208 + w7 * w240
    w247 = w0 * (w1 * w241 + w16 * (w7 * w242) - (w10 * w245 - w68 * w246)) - w65 * (w68 * w241 + w73 * w245 - (w1 * w246 + w16 * (w9 * w242)))
    w248 = (w65 * w140 - w0 * w138) / w47 - w95 * w167
    w249 = (w44 * w243 - w60 * w140 - (w67 * w138 + w36 * w244)) / w47 - w98 * w167
    w250 = w90 * w249
    w251 = w109 * (coupler_q1_dot * c51 - coupler_q2_dot * c27) - w246 * gravity_y - (w59 * w241 + w66 * w246 + (w68 * (w105 + coupler_q1 * c51 - coupler_q2 * c27) + w107 * w245))
    w252 = w112 * w167
    w253 = w151 * w167
    w254 = w7 * c4
    w255 = w9 * c4
    w256 = (w25 * w254 + w40 * w255) / w47 - w143 * w167
    w257 = w157 * w167
    w258 = w163 * w167
    w259 = coupler_q2_dot * w253 - (crank_theta_dot * w252 + coupler_q1_dot * w256) - rocker_q1_dot * w257 - rocker_q2_dot * w258
    w260 = w259 + (w142 * w171 - w166 * w180)
    w261 = (w44 * w254 - w140**2 + (w36 * w255 - w138**2)) / w47 - w167 * w181
    w262 = coupler_q1 * coupler_q2 * c52 / w47
    w263 = w262 + w167 * w185
    w264 = (w140 * w155 + w138 * w154) / w47
    w265 = w264 + w167 * w192
    w266 = (w140 * w161 + w138 * w160) / w47
    w267 = w266 + w167 * w199
    w268 = crank_theta_dot * w248 - coupler_q1_dot * w261 + coupler_q2_dot * w263 - rocker_q1_dot * w265 - rocker_q2_dot * w267
    w269 = w268 - (w142 * w202 + w180 * w205)
    w270 = w247 + (w92 * w248 - w94 * w250) + (w103 * w251 - w111 * w252) - (w114 * w142 + w123 * w180) + (w137 * w260 + w179 * w269)
    w271 = w9 * c17
    w272 = w1 * c51 - c41 - w271 * gravity_y - (w59 * (w7 * c17) + w66 * w271 + w245 * c29) - (w92 * w261 - w180 * w250)
    w273 = w9 * c19
    w274 = w184 * w250 + w92 * w263 - (w1 * c27 + w273 * gravity_y + (w59 * (w7 * c19) + w66 * w273 + w245 * c30))
    w275 = w156 * w251 - w111 * w257 - (w249 * c31 + (w191 * w250 + w92 * w265)) - (w142 * w228 + w180 * w230)
    w276 = w162 * w251 - w111 * w258 - (w249 * c32 + (w198 * w250 + w92 * w267)) - (w142 * w235 + w180 * w236)
    w277 = w13 + coupler_q1_dot * c18
    w278 = (coupler_q1 * c18 + (w4 + w5)) * 0.5
    w279 = w9 * w278
    w280 = w16 * (w9 * w32) + w1 * w148
    w281 = w16 * (w7 * w32) - w1 * w146
    w282 = (w25 * w280 - w40 * w281) / w47 - w69 * w169
    w283 = w7 * w278
    w284 = w0 * (w16 * (w7 * w277) - w1 * w279 - (w10 * w282 - w68 * w283)) - w65 * (w73 * w282 - w68 * w279 - (w1 * w283 + w16 * (w9 * w277)))
    w285 = (w65 * w148 - w0 * w146) / w47 - w95 * w169
    w286 = (w44 * w280 - w60 * w148 - (w67 * w146 + w36 * w281)) / w47 - w98 * w169
    w287 = w90 * w286
    w288 = w109 * (coupler_q2_dot * c53 - coupler_q1_dot * c25) - w283 * gravity_y - (w66 * w283 - w59 * w279 + (w68 * (w106 + coupler_q2 * c53 - coupler_q1 * c25) + w107 * w282))
    w289 = w112 * w169
    w290 = w143 * w169
    w291 = w7 * c5
    w292 = w9 * c5
    w293 = (w25 * w291 + w40 * w292) / w47 - w151 * w169
    w294 = w157 * w169
    w295 = w163 * w169
    w296 = coupler_q1_dot * w290 - crank_theta_dot * w289 - coupler_q2_dot * w293 - rocker_q1_dot * w294 - rocker_q2_dot * w295
    w297 = w296 + (w150 * w171 - w166 * w184)
    w298 = w262 + w169 * w181
    w299 = (w44 * w291 - w148**2 + (w36 * w292 - w146**2)) / w47 - w169 * w185
    w300 = (w148 * w155 + w146 * w154) / w47
    w301 = w300 + w169 * w192
    w302 = (w148 * w161 + w146 * w160) / w47
    w303 = w302 + w169 * w199
    w304 = crank_theta_dot * w285 + coupler_q1_dot * w298 - coupler_q2_dot * w299 - rocker_q1_dot * w301 - rocker_q2_dot * w303
    w305 = w304 - (w150 * w202 + w184 * w205)
    w306 = w284 + (w92 * w285 - w94 * w287) + (w103 * w288 - w111 * w289) - (w114 * w150 + w123 * w184) + (w137 * w297 + w179 * w305)
    w307 = w9 * c18
    w308 = w180 * w287 + w92 * w298 - (w1 * c25 + w307 * gravity_y + (w59 * (w7 * c18) + w66 * w307 + w282 * c29))
    w309 = w9 * c20
    w310 = w1 * c53 - c42 - w309 * gravity_y - (w59 * (w7 * c20) + w66 * w309 + w282 * c30) - (w92 * w299 - w184 * w287)
    w311 = w156 * w288 - w111 * w294 - (w286 * c31 + (w191 * w287 + w92 * w301)) - (w150 * w228 + w184 * w230)
    w312 = w162 * w288 - w111 * w295 - (w286 * c32 + (w198 * w287 + w92 * w303)) - (w150 * w235 + w184 * w236)
    w313 = w80 * (rocker_q1_dot * c54 - rocker_q2_dot * c14) - (w229 + w21 * ((w84 + w85 + rocker_q2 * c38) * 0.5)) * gravity_y
    w314 = w48 * (w21 * w52) - w56 * w154
    w315 = w48 * (w39 * w52) + w56 * w155
    w316 = (w36 * w314 - w44 * w315) / w47 - w98 * w190
    w317 = w313 - (w91 * (w81 + rocker_q1 * c54 - rocker_q2 * c14) + w90 * w316)
    w318 = w95 * w190
    w319 = (w40 * w314 - w67 * w154 - (w60 * w155 + w25 * w315)) / w47 - w69 * w190
    w320 = (w65 * w155 - w0 * w154) / w47 - w112 * w190
    w321 = w107 * w319
    w322 = w94 * w317 - w92 * w318 - (w0 * (w10 * w319) + w65 * (w73 * w319)) + (w111 * w320 - w103 * w321) + (w114 * w156 + w123 * w191)
    w323 = w264 + w143 * w190
    w324 = w300 + w151 * w190
    w325 = w21 * c7
    w326 = w39 * c7
    w327 = (w25 * w325 - w155**2 + (w40 * w326 - w154**2)) / w47 - w157 * w190
    w328 = rocker_q1 * rocker_q2 * c55 / w47
    w329 = w328 + w163 * w190
    w330 = crank_theta_dot * w320 + coupler_q1_dot * w323 + coupler_q2_dot * w324 + rocker_q1_dot * w327 - rocker_q2_dot * w329
    w331 = w330 + (w166 * w191 - w156 * w171)
    w332 = w181 * w190
    w333 = w185 * w190
    w334 = (w44 * w325 + w36 * w326) / w47 - w190 * w192
    w335 = w190 * w199
    w336 = coupler_q1_dot * w332 - crank_theta_dot * w318 + coupler_q2_dot * w333 + rocker_q1_dot * w334 - rocker_q2_dot * w335
    w337 = w336 + (w156 * w202 + w191 * w205)
    w338 = w142 * w321 + w111 * w323 - (w319 * c29 + (w180 * w317 - w92 * w332)) - (w156 * w213 + w191 * w214)
    w339 = w150 * w321 + w111 * w324 - (w319 * c30 + (w184 * w317 - w92 * w333)) - (w156 * w222 + w191 * w223)
    w340 = w56 * c54 - c43 - w39 * c56 - w316 * c31 + (w191 * w317 + w92 * w334) + (w111 * w327 - w156 * w321)
    w341 = w198 * w317 - w92 * w335 - (w56 * c14 + w39 * c57 + w316 * c32) - (w162 * w321 + w111 * w329) + (w156 * w235 + w191 * w236)
    w342 = w80 * (rocker_q2_dot * c58 - rocker_q1_dot * c12) - w21 * ((rocker_q1 * c37 + (w86 + w87)) * 0.5) * gravity_y
    w343 = w48 * (w21 * w53) - w56 * w160
    w344 = w48 * (w39 * w53) + w56 * w161
    w345 = (w36 * w343 - w44 * w344) / w47 - w98 * w197
    w346 = w342 - (w91 * (w82 + rocker_q2 * c58 - rocker_q1 * c12) + w90 * w345)
    w347 = w95 * w197
    w348 = (w40 * w343 - w67 * w160 - (w60 * w161 + w25 * w344)) / w47 - w69 * w197
    w349 = (w65 * w161 - w0 * w160) / w47 - w112 * w197
    w350 = w107 * w348
    w351 = w94 * w346 - w92 * w347 - (w0 * (w10 * w348) + w65 * (w73 * w348)) + (w111 * w349 - w103 * w350) + (w114 * w162 + w123 * w198)
    w352 = w266 + w143 * w197
    w353 = w302 + w151 * w197
    w354 = w328 + w157 * w197
    w355 = w21 * c8
    w356 = w39 * c8
    w357 = (w25 * w355 - w161**2 + (w40 * w356 - w160**2)) / w47 - w163 * w197
    w358 = crank_theta_dot * w349 + coupler_q1_dot * w352 + coupler_q2_dot * w353 - rocker_q1_dot * w354 + rocker_q2_dot * w357
    w359 = w358 + (w166 * w198 - w162 * w171)
    w360 = w181 * w197
    w361 = w185 * w197
    w362 = w192 * w197
    w363 = (w44 * w355 + w36 * w356) / w47 - w197 * w199
    w364 = coupler_q1_dot * w360 - crank_theta_dot * w347 + coupler_q2_dot * w361 - rocker_q1_dot * w362 + rocker_q2_dot * w363
    w365 = w364 + (w162 * w202 + w198 * w205)
    w366 = w142 * w350 + w111 * w352 - (w348 * c29 + (w180 * w346 - w92 * w360)) - (w162 * w213 + w198 * w214)
    w367 = w150 * w350 + w111 * w353 - (w348 * c30 + (w184 * w346 - w92 * w361)) - (w162 * w222 + w198 * w223)
    w368 = w191 * w346 - w92 * w362 - (w56 * c12 + w39 * c59 + w345 * c31) - (w156 * w350 + w111 * w354) + (w162 * w228 + w198 * w230)
    w369 = w56 * c58 - c44 - w39 * c60 - w345 * c32 + (w198 * w346 + w92 * w363) + (w111 * w357 - w162 * w350)
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # crank.theta
            w207, w270, w306, w322 + (w137 * w331 + w179 * w337), w351 + (w137 * w359 + w179 * w365),
        ),
        ca.horzcat(  # coupler.q1
            w217, w272 - (w142 * w251 + w111 * w256) + (w142 * w213 + w180 * w214) + (w215 * w260 + w216 * w269),
            w308 - (w142 * w288 - w111 * w290) + (w150 * w213 + w184 * w214) + (w215 * w297 + w216 * w305),
            w338 + (w215 * w331 + w216 * w337), w366 + (w215 * w359 + w216 * w365),
        ),
        ca.horzcat(  # coupler.q2
            w226, w274 - (w150 * w251 - w111 * w253) + (w142 * w222 + w180 * w223) + (w224 * w260 + w225 * w269),
            w310 - (w150 * w288 + w111 * w293) + (w150 * w222 + w184 * w223) + (w224 * w297 + w225 * w305),
            w339 + (w224 * w331 + w225 * w337), w367 + (w224 * w359 + w225 * w365),
        ),
        ca.horzcat(  # rocker.q1
            w233, w275 + (w231 * w260 + w232 * w269), w311 + (w231 * w297 + w232 * w305),
            w340 + (w156 * w228 + w191 * w230) + (w231 * w331 + w232 * w337), w368 + (w231 * w359 + w232 * w365),
        ),
        ca.horzcat(  # rocker.q2
            w239, w276 + (w237 * w260 + w238 * w269), w312 + (w237 * w297 + w238 * w305),
            w341 + (w237 * w331 + w238 * w337), w369 + (w162 * w235 + w198 * w236) + (w237 * w359 + w238 * w365),
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    719 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 68)
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
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    # intermediate terms (122)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.cos(coupler_theta)
    w2 = coupler_q1 * c17 + coupler_q2 * c18
    w3 = coupler_q1 * c19 + coupler_q2 * c20
    w4 = c16 - (coupler_q1 * w2 + coupler_q2 * w3) * 0.5
    w5 = ca.sin(coupler_theta)
    w6 = coupler_q1 * c21
    w7 = w1 * w4 - w5 * w6
    w8 = ca.cos(rocker_theta)
    w9 = rocker_q1 * c7
    w10 = rocker_q2 * c8
    w11 = rocker_length - (rocker_q1 * w9 + rocker_q2 * w10) * 0.5
    w12 = w8 * w11
    w13 = 2 * crank_theta_dot
    w14 = w0 * w13
    w15 = ca.sin(rocker_theta)
    w16 = w11 * w15
    w17 = ca.sin(crank_theta) * crank_tip_x
    w18 = w13 * w17
    w19 = coupler_q1 * c4
    w20 = coupler_q2 * c5
    w21 = coupler_length - (coupler_q1 * w19 + coupler_q2 * w20) * 0.5
    w22 = w5 * w21
    w23 = w1 * w21
    w24 = w12 * w22 - w16 * w23
    w25 = (w12 * w14 + w16 * w18) / w24
    w26 = w4 * w5 + w1 * w6
    w27 = (w0 * w22 - w17 * w23) / w24
    w28 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w29 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w30 = c9 + (rocker_q1 * w28 + rocker_q2 * w29)
    w31 = (w14 * w23 + w18 * w22) / w24
    w32 = w30 * w31
    w33 = (w0 * w16 - w12 * w17) / w24
    w34 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w35 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w36 = c22 + (coupler_q1 * w34 + coupler_q2 * w35)
    w37 = w14 * w26 - w7 * w18 - w25 * w36
    w38 = 2 * coupler_theta_dot
    w39 = w2 * coupler_q1_dot + w3 * coupler_q2_dot
    w40 = coupler_q1_dot * c21
    w41 = w19 * coupler_q1_dot + w20 * coupler_q2_dot
    w42 = 2 * (w5 * w41) - w23 * w38
    w43 = 2 * (w1 * w41) + w22 * w38
    w44 = (w12 * w42 - w16 * w43) / w24
    w45 = w0 * (w26 * w38 + 2 * (w1 * w39 + w5 * w40) - w7 * w44) - w17 * (w7 * w38 + 2 * (w1 * w40 - w5 * w39) + w26 * w44)
    w46 = (w23 * w42 - w22 * w43) / w24
    w47 = w30 * w46
    w48 = (w34 * coupler_q1_dot + w35 * coupler_q2_dot) * -2.0 - w36 * w44
    w49 = w45 - w27 * w47 + w33 * w48
    w50 = w9 * rocker_q1_dot + w10 * rocker_q2_dot
    w51 = 2 * rocker_theta_dot
    w52 = 2 * (w8 * w50) + w16 * w51
    w53 = 2 * (w15 * w50) - w12 * w51
    w54 = (w22 * w52 - w23 * w53) / w24
    w55 = (w28 * rocker_q1_dot + w29 * rocker_q2_dot) * -2.0 - w30 * w54
    w56 = (w16 * w52 - w12 * w53) / w24
    w57 = w36 * w56
    w58 = w27 * w55 - (w0 * (w7 * w56) + w17 * (w26 * w56)) - w33 * w57
    w59 = w0 * (w7 * w25 + w18 * c2) - w17 * (w14 * c2 - w25 * w26) + w27 * w32 - w33 * w37 + (w33 * w49 + w27 * w58)
    w60 = w1 * w19
    w61 = w5 * w19
    w62 = (w12 * w60 + w16 * w61) / w24
    w63 = w1 * w2 + w5 * c21
    w64 = w1 * c21 - w2 * w5
    w65 = coupler_q1 * w21 * c4 / w24
    w66 = w34 * w38 - w44 * c29 + w47 * w65 - w48 * w62
    w67 = w57 * w62 - (w56 * c29 + w55 * w65)
    w68 = w1 * w20
    w69 = w5 * w20
    w70 = (w12 * w68 + w16 * w69) / w24
    w71 = w1 * w3
    w72 = w3 * w5
    w73 = coupler_q2 * w21 * c5 / w24
    w74 = w35 * w38 - w44 * c30 + w47 * w73 - w48 * w70
    w75 = w57 * w70 - (w56 * c30 + w55 * w73)
    w76 = w8 * w9
    w77 = w9 * w15
    w78 = (w23 * w76 + w22 * w77) / w24
    w79 = rocker_q1 * w11 * c7 / w24
    w80 = w48 * w79 - (w46 * c31 + w47 * w78)
    w81 = w28 * w51 - w54 * c31 + w55 * w78 - w57 * w79
    w82 = w8 * w10
    w83 = w10 * w15
    w84 = (w23 * w82 + w22 * w83) / w24
    w85 = rocker_q2 * w11 * c8 / w24
    w86 = w48 * w85 - (w46 * c32 + w47 * w84)
    w87 = w29 * w51 - w54 * c32 + w55 * w84 - w57 * w85
    w88 = coupler_q1_dot * c65 + coupler_q2_dot * c66
    w89 = coupler_q1_dot * c61
    w90 = w38 * w61 - w1 * w89
    w91 = w5 * w89 + w38 * w60
    w92 = (w12 * w90 - w16 * w91) / w24
    w93 = (w23 * w90 - w22 * w91) / w24
    w94 = w30 * w93
    w95 = coupler_theta_dot * -2.0
    w96 = w34 * w95 - w36 * w92
    w97 = w0 * (w5 * w88 + w38 * w63 - w7 * w92) - w17 * (w38 * w64 + w1 * w88 + w26 * w92) - w27 * w94 + w33 * w96
    w98 = coupler_q2_dot * c67 + coupler_q1_dot * c66
    w99 = coupler_q2_dot * c62
    w100 = w38 * w69 - w1 * w99
    w101 = w5 * w99 + w38 * w68
    w102 = (w12 * w100 - w16 * w101) / w24
    w103 = (w23 * w100 - w22 * w101) / w24
    w104 = w30 * w103
    w105 = w35 * w95 - w36 * w102
    w106 = w0 * (w5 * w98 + w38 * w71 - w7 * w102) - w17 * (w1 * w98 - w38 * w72 + w26 * w102) - w27 * w104 + w33 * w105
    w107 = rocker_theta_dot * -2.0
    w108 = rocker_q1_dot * c63
    w109 = w15 * w108 + w51 * w76
    w110 = w51 * w77 - w8 * w108
    w111 = (w22 * w109 - w23 * w110) / w24
    w112 = w28 * w107 - w30 * w111
    w113 = (w16 * w109 - w12 * w110) / w24
    w114 = w36 * w113
    w115 = rocker_q2_dot * c64
    w116 = w15 * w115 + w51 * w82
    w117 = w51 * w83 - w8 * w115
    w118 = (w22 * w116 - w23 * w117) / w24
    w119 = w29 * w107 - w30 * w118
    w120 = (w16 * w116 - w12 * w117) / w24
    w121 = w36 * w120
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # crank.theta
            w59, w97 - (w49 * w62 + w58 * w65), w106 - (w49 * w70 + w58 * w73),
            w27 * w112 - (w0 * (w7 * w113) + w17 * (w26 * w113)) - w33 * w114 + (w49 * w79 + w58 * w78),
            w27 * w119 - (w0 * (w7 * w120) + w17 * (w26 * w120)) - w33 * w121 + (w49 * w85 + w58 * w84),
        ),
        ca.horzcat(  # coupler.q1
            w37 * w62 - (w14 * w63 - w18 * w64 - w25 * c29 + w32 * w65) + (w33 * w66 + w27 * w67),
            w65 * w94 - w92 * c29 - w62 * w96 - (w62 * w66 + w65 * w67),
            w65 * w104 - w102 * c29 - w62 * w105 - (w66 * w70 + w67 * w73),
            w62 * w114 - (w113 * c29 + w65 * w112) + (w66 * w79 + w67 * w78),
            w62 * w121 - (w120 * c29 + w65 * w119) + (w66 * w85 + w67 * w84),
        ),
        ca.horzcat(  # coupler.q2
            w37 * w70 - (w14 * w71 + w18 * w72 - w25 * c30 + w32 * w73) + (w33 * w74 + w27 * w75),
            w73 * w94 - w92 * c30 - w70 * w96 - (w62 * w74 + w65 * w75),
            w73 * w104 - w102 * c30 - w70 * w105 - (w70 * w74 + w73 * w75),
            w70 * w114 - (w113 * c30 + w73 * w112) + (w74 * w79 + w75 * w78),
            w70 * w121 - (w120 * c30 + w73 * w119) + (w74 * w85 + w75 * w84),
        ),
        ca.horzcat(  # rocker.q1
            w31 * c31 + w32 * w78 - w37 * w79 + (w33 * w80 + w27 * w81),
            w79 * w96 - (w93 * c31 + w78 * w94) - (w62 * w80 + w65 * w81),
            w79 * w105 - (w103 * c31 + w78 * w104) - (w70 * w80 + w73 * w81),
            w78 * w112 - w111 * c31 - w79 * w114 + (w79 * w80 + w78 * w81),
            w78 * w119 - w118 * c31 - w79 * w121 + (w80 * w85 + w81 * w84),
        ),
        ca.horzcat(  # rocker.q2
            w31 * c32 + w32 * w84 - w37 * w85 + (w33 * w86 + w27 * w87),
            w85 * w96 - (w93 * c32 + w84 * w94) - (w62 * w86 + w65 * w87),
            w85 * w105 - (w103 * c32 + w84 * w104) - (w70 * w86 + w73 * w87),
            w84 * w112 - w111 * c32 - w85 * w114 + (w79 * w86 + w78 * w87),
            w84 * w119 - w118 * c32 - w85 * w121 + (w85 * w86 + w84 * w87),
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 5 x 5) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    2323 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 68)
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
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    # intermediate terms (451)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = coupler_theta_dot**2
    w2 = coupler_q1 * c17
    w3 = w2 + coupler_q2 * c18
    w4 = coupler_q2 * c20
    w5 = coupler_q1 * c19 + w4
    w6 = c16 - (coupler_q1 * w3 + coupler_q2 * w5) * 0.5
    w7 = ca.cos(coupler_theta)
    w8 = coupler_q1 * c21
    w9 = ca.sin(coupler_theta)
    w10 = w6 * w7 - w8 * w9
    w11 = w1 * w10
    w12 = coupler_q1_dot * c17
    w13 = w12 + coupler_q2_dot * c18
    w14 = coupler_q2_dot * c20
    w15 = coupler_q1_dot * c19 + w14
    w16 = coupler_q1_dot * w13 + coupler_q2_dot * w15
    w17 = w7 * w16
    w18 = 2 * coupler_theta_dot
    w19 = coupler_q1_dot * c21
    w20 = w3 * coupler_q1_dot + w5 * coupler_q2_dot
    w21 = w7 * w19 - w9 * w20
    w22 = w18 * w21
    w23 = ca.cos(rocker_theta)
    w24 = rocker_q1 * c7
    w25 = rocker_q2 * c8
    w26 = rocker_length - (rocker_q1 * w24 + rocker_q2 * w25) * 0.5
    w27 = w23 * w26
    w28 = coupler_q1 * c4
    w29 = coupler_q2 * c5
    w30 = coupler_q1_dot * w28 + coupler_q2_dot * w29
    w31 = w7 * w30
    w32 = w18 * w31
    w33 = coupler_q1_dot * c4
    w34 = coupler_q2_dot * c5
    w35 = coupler_q1_dot * w33 + coupler_q2_dot * w34
    w36 = w9 * w35
    w37 = coupler_length - (coupler_q1 * w28 + coupler_q2 * w29) * 0.5
    w38 = w9 * w37
    w39 = w1 * w38
    w40 = w32 + (w36 + w39)
    w41 = ca.sin(rocker_theta)
    w42 = w26 * w41
    w43 = w7 * w35
    w44 = w9 * w30
    w45 = w18 * w44
    w46 = w7 * w37
    w47 = w1 * w46
    w48 = w43 - w45 + w47
    w49 = w27 * w38 - w42 * w46
    w50 = 2 * rocker_theta_dot
    w51 = w24 * rocker_q1_dot + w25 * rocker_q2_dot
    w52 = w41 * w51
    w53 = w50 * w52
    w54 = rocker_q1_dot * c7
    w55 = rocker_q2_dot * c8
    w56 = rocker_q1_dot * w54 + rocker_q2_dot * w55
    w57 = w23 * w56
    w58 = rocker_theta_dot**2
    w59 = w27 * w58
    w60 = crank_theta_dot**2
    w61 = w0 * w60
    w62 = w45 - (w43 + w47) - (w53 - (w57 + w59)) - w61
    w63 = w41 * w56
    w64 = w23 * w51
    w65 = w50 * w64
    w66 = w42 * w58
    w67 = ca.sin(crank_theta) * crank_tip_x
    w68 = w60 * w67
    w69 = w63 + w65 + w66 - (w39 + (w32 + w36)) - w68
    w70 = (w27 * w62 + w42 * w69) / w49
    w71 = w70 / w49
    w72 = w27 * w46 + w38 * w42
    w73 = w71 * w72
    w74 = (w0 * w42 - w27 * w67) / w49
    w75 = w74 / w49
    w76 = w72 * w75
    w77 = w7 * w28
    w78 = w42 * w77
    w79 = w9 * w28
    w80 = w27 * w79
    w81 = w78 - w80
    w82 = (w27 * w77 + w42 * w79) / w49
    w83 = w82 / w49
    w84 = w72 * w83
    w85 = w81 / w49 - w84
    w86 = w7 * w29
    w87 = w42 * w86
    w88 = w9 * w29
    w89 = w27 * w88
    w90 = w87 - w89
    w91 = (w27 * w86 + w42 * w88) / w49
    w92 = w91 / w49
    w93 = w72 * w92
    w94 = w90 / w49 - w93
    w95 = (w27 * w40 - w42 * w48) / w49 - w73 - crank_theta_ddot * w76 - coupler_q1_ddot * w85 - coupler_q2_ddot * w94
    w96 = w23 * w24
    w97 = w24 * w41
    w98 = rocker_q1 * w26 * c7 / w49
    w99 = w98 / w49
    w100 = w72 * w99
    w101 = rocker_q1_ddot * w100
    w102 = w23 * w25
    w103 = w25 * w41
    w104 = rocker_q2 * w26 * c8 / w49
    w105 = w104 / w49
    w106 = w72 * w105
    w107 = rocker_q2_ddot * w106
    w108 = w95 - w101 - w107
    w109 = w70 + crank_theta_ddot * w74 - coupler_q1_ddot * w82 - coupler_q2_ddot * w91 + rocker_q1_ddot * w98
    w110 = w109 + rocker_q2_ddot * w104
    w111 = w6 * w9 + w7 * w8
    w112 = w110 * w111
    w113 = w9 * c21
    w114 = w113 + w3 * w7
    w115 = coupler_q1_ddot * w114
    w116 = w5 * w7
    w117 = coupler_q2_ddot * w116
    w118 = w10 * w110
    w119 = w7 * c21
    w120 = w119 - w3 * w9
    w121 = coupler_q1_ddot * w120
    w122 = w5 * w9
    w123 = coupler_q2_ddot * w122
    w124 = w1 * w111
    w125 = w9 * w19 + w7 * w20
    w126 = w18 * w125
    w127 = w9 * w16
    w128 = w0 * (w11 + w17 + w22 - (w10 * w108 - w112 - w115 - w117)) - w67 * (w118 + w108 * w111 + w121 - w123 - (w124 + w126 + w127))
    w129 = rocker_theta_dot * -2.0
    w130 = rocker_q1 * c10 - (rocker_q1 * c11 + rocker_q2 * c12)
    w131 = rocker_q2 * c13 - (rocker_q1 * c14 + rocker_q2 * c15)
    w132 = rocker_q1_dot * w130 + rocker_q2_dot * w131
    w133 = rocker_q1 * c36
    w134 = w133 + rocker_q2 * c37
    w135 = rocker_q2 * c39
    w136 = rocker_q1 * c38 + w135
    w137 = c35 - (rocker_q1 * w134 + rocker_q2 * w136) * 0.5
    w138 = rocker_q1 * c40
    w139 = c9 + (rocker_q1 * w130 + rocker_q2 * w131)
    w140 = (w46 * w62 + w38 * w69) / w49
    w141 = (w0 * w38 - w46 * w67) / w49
    w142 = coupler_q1 * w37 * c4 / w49
    w143 = coupler_q2 * w37 * c5 / w49
    w144 = (w46 * w96 + w38 * w97) / w49
    w145 = w140 + crank_theta_ddot * w141 - coupler_q1_ddot * w142 - coupler_q2_ddot * w143 + rocker_q1_ddot * w144
    w146 = (w46 * w102 + w38 * w103) / w49
    w147 = w145 + rocker_q2_ddot * w146
    w148 = w129 * w132 + (w23 * w137 - w41 * w138) * gravity_y - (w139 * w147 + rocker_q1_ddot * c31 + rocker_q2_ddot * c32)
    w149 = (w0 * w46 + w38 * w67) / w49
    w150 = w141 / w49
    w151 = w72 * w150
    w152 = w149 - w151
    w153 = w140 / w49
    w154 = w72 * w153
    w155 = w142 / w49
    w156 = w72 * w155
    w157 = coupler_q1_ddot * w156
    w158 = w143 / w49
    w159 = w72 * w158
    w160 = coupler_q2_ddot * w159
    w161 = (w40 * w46 - w38 * w62 + (w46 * w69 - w38 * w48)) / w49 - w154 + crank_theta_ddot * w152 + w157 + w160
    w162 = w46 * w97
    w163 = w38 * w96
    w164 = w162 - w163
    w165 = w144 / w49
    w166 = w72 * w165
    w167 = w164 / w49 - w166
    w168 = w46 * w103
    w169 = w38 * w102
    w170 = w168 - w169
    w171 = w146 / w49
    w172 = w72 * w171
    w173 = w170 / w49 - w172
    w174 = w161 + rocker_q1_ddot * w167 + rocker_q2_ddot * w173
    w175 = w139 * w174
    w176 = w61 + w67 * crank_theta_ddot
    w177 = w10 * w176
    w178 = w0 * crank_theta_ddot - w68
    w179 = w111 * w178
    w180 = coupler_q1 * c23 - (coupler_q1 * c24 + coupler_q2 * c25)
    w181 = coupler_q2 * c26 - (coupler_q1 * c27 + coupler_q2 * c28)
    w182 = c22 + (coupler_q1 * w180 + coupler_q2 * w181)
    w183 = w111 * gravity_y + (w177 - w179 + w108 * w182)
    w184 = coupler_theta_dot * -2.0
    w185 = coupler_q1_dot * w180 + coupler_q2_dot * w181
    w186 = w184 * w185 + w10 * gravity_y - (w111 * w176 + w10 * w178 + w110 * w182 + coupler_q1_ddot * c29 + coupler_q2_ddot * c30)
    w187 = w128 + (w148 * w152 - w141 * w175) - (w74 * w183 + w76 * w186)
    w188 = w59 + (w57 - w53)
    w189 = w65 + (w63 + w66)
    w190 = w166 + (w163 - w162) / w49
    w191 = w154 + (w38 * w188 - w46 * w189) / w49 + crank_theta_ddot * w151 - w157 - w160 + rocker_q1_ddot * w190
    w192 = w172 + (w169 - w168) / w49
    w193 = w191 + rocker_q2_ddot * w192
    w194 = (w41 * w137 + w23 * w138) * gravity_y + w139 * w193
    w195 = (w0 * w27 + w42 * w67) / w49
    w196 = w76 + w195
    w197 = w84 + (w80 - w78) / w49
    w198 = w73 + (w27 * w69 + w42 * w188 - (w42 * w62 + w27 * w189)) / w49 + crank_theta_ddot * w196 - coupler_q1_ddot * w197
    w199 = w93 + (w89 - w87) / w49
    w200 = w107 + (w101 + (w198 - coupler_q2_ddot * w199))
    w201 = w182 * w200
    w202 = w148 * w151 - w141 * w194 - (w0 * (w10 * w200) + w67 * (w111 * w200)) + (w186 * w196 - w74 * w201)
    w203 = (w27 * w68 - w42 * w61) / w49 - crank_theta_ddot * w195
    w204 = w176 * c2
    w205 = w178 * c2
    w206 = w0 * (w10 * w203 - w204) + w67 * (c34 + (w126 + (w124 + w127)) - (w121 + (w118 + w205) - w123)) + (w67 * (w205 + w111 * w203) + w0 * (w17 + (w11 + w22) + (w117 + (w115 + (w112 + w204)))))
    w207 = (w46 * w68 - w38 * w61) / w49 - crank_theta_ddot * w149
    w208 = w139 * w207
    w209 = w179 - w177 + w182 * w203
    w210 = 2 * w44 - w18 * w46
    w211 = 2 * w31 + w18 * w38
    w212 = (w27 * w210 - w42 * w211) / w49
    w213 = (w46 * w210 - w38 * w211) / w49
    w214 = w139 * w213
    w215 = w0 * (w18 * w111 + 2 * w125 - w10 * w212) - w67 * (w10 * w18 + 2 * w21 + w111 * w212) - w141 * w214
    w216 = w185 * -2.0 - w182 * w212
    w217 = w215 + w74 * w216
    w218 = rocker_q1_dot * w100
    w219 = rocker_q2_dot * w106
    w220 = crank_theta_dot * w196 - coupler_q1_dot * w197 - coupler_q2_dot * w199 + w218 + w219
    w221 = w219 + (w218 + (crank_theta_dot * w76 + coupler_q1_dot * w85 + coupler_q2_dot * w94))
    w222 = w141 * w220 - w74 * w221 - crank_theta_dot * w195
    w223 = 2 * w64 + w42 * w50
    w224 = 2 * w52 - w27 * w50
    w225 = (w38 * w223 - w46 * w224) / w49
    w226 = w132 * -2.0 - w139 * w225
    w227 = (w42 * w223 - w27 * w224) / w49
    w228 = w182 * w227
    w229 = w141 * w226 - (w0 * (w10 * w227) + w67 * (w111 * w227)) - w74 * w228
    w230 = coupler_q1_dot * w156
    w231 = coupler_q2_dot * w159
    w232 = crank_theta_dot * w152 + w230 + w231 + rocker_q1_dot * w167 + rocker_q2_dot * w173
    w233 = crank_theta_dot * w151 - w230 - w231 + rocker_q1_dot * w190 + rocker_q2_dot * w192
    w234 = w74 * w232 + w141 * w233 - crank_theta_dot * w149
    w235 = w74 * w187 + w141 * w202 - (w206 + (w141 * w208 + w148 * w149) + (w74 * w209 + w186 * w195)) + (w217 * w222 + w229 * w234)
    w236 = w114 * w178
    w237 = w120 * w176
    w238 = w148 * w156
    w239 = w114 * gravity_y + (w237 - w236 + w108 * c29) - (w238 + w142 * w175) + (w85 * w186 - w82 * w183)
    w240 = w200 * c29 + (w238 - w142 * w194) + (w186 * w197 - w82 * w201)
    w241 = w18 * w180 - w212 * c29 + w142 * w214 - w82 * w216
    w242 = w82 * w228 - (w227 * c29 + w142 * w226)
    w243 = w142 * w208 - (w236 - w237 + w203 * c29) + w82 * w209 - (w74 * w239 + w141 * w240) + (w222 * w241 + w234 * w242)
    w244 = w116 * w178 + w122 * w176
    w245 = w148 * w159
    w246 = w116 * gravity_y + (w108 * c30 - w244) - (w245 + w143 * w175) + (w94 * w186 - w91 * w183)
    w247 = w200 * c30 + (w245 - w143 * w194) + (w186 * w199 - w91 * w201)
    w248 = w18 * w181 - w212 * c30 + w143 * w214 - w91 * w216
    w249 = w91 * w228 - (w227 * c30 + w143 * w226)
    w250 = w143 * w208 - (w244 + w203 * c30) + w91 * w209 - (w74 * w246 + w141 * w247) + (w222 * w248 + w234 * w249)
    w251 = w100 * w186
    w252 = w148 * w167 - w144 * w175 - w174 * c31 - (w98 * w183 + w251)
    w253 = w41 * c40
    w254 = w148 * w190 - w144 * w194 - ((w253 + w23 * w134) * gravity_y + w193 * c31) + (w251 - w98 * w201)
    w255 = w98 * w216 - (w213 * c31 + w144 * w214)
    w256 = w50 * w130 - w225 * c31 + w144 * w226 - w98 * w228
    w257 = w106 * w186
    w258 = w148 * w173 - w146 * w175 - w174 * c32 - (w104 * w183 + w257)
    w259 = w148 * w192 - w146 * w194 - (w23 * w136 * gravity_y + w193 * c32) + (w257 - w104 * w201)
    w260 = w104 * w216 - (w213 * c32 + w146 * w214)
    w261 = w50 * w131 - w225 * c32 + w146 * w226 - w104 * w228
    w262 = w74 * w258 + w141 * w259 - (w207 * c32 + w146 * w208 + w104 * w209) + (w222 * w260 + w234 * w261)
    w263 = (w2 + w3 + coupler_q2 * c19) * 0.5
    w264 = w119 - w9 * w263
    w265 = coupler_q2_dot * c19
    w266 = w12 + w265
    w267 = w18 * (w9 * w33) + w1 * w77
    w268 = w18 * (w7 * w33) - w1 * w79
    w269 = w75 * w81
    w270 = w7 * c4
    w271 = w9 * c4
    w272 = (w27 * w270 + w42 * w271) / w49 - w81 * w83
    w273 = w81 * w92
    w274 = (w27 * w267 - w42 * w268) / w49 - w71 * w81 - crank_theta_ddot * w269 - coupler_q1_ddot * w272 + coupler_q2_ddot * w273
    w275 = w81 * w99
    w276 = w81 * w105
    w277 = w274 - rocker_q1_ddot * w275 - rocker_q2_ddot * w276
    w278 = w113 + w7 * w263
    w279 = w9 * c17
    w280 = w9 * c19
    w281 = w1 * w264 + w18 * (w7 * w266) - (w10 * w277 - w110 * w278 - coupler_q1_ddot * w279 - coupler_q2_ddot * w280)
    w282 = w7 * c17
    w283 = w7 * c19
    w284 = w110 * w264 + w111 * w277 + coupler_q1_ddot * w282 + coupler_q2_ddot * w283 - (w1 * w278 + w18 * (w9 * w266))
    w285 = (w67 * w77 - w0 * w79) / w49 - w81 * w150
    w286 = (w46 * w270 - w77**2 + (w38 * w271 - w79**2)) / w49 - w81 * w155
    w287 = (w46 * w267 - w62 * w77 - (w69 * w79 + w38 * w268)) / w49 - w81 * w153 + crank_theta_ddot * w285 - coupler_q1_ddot * w286
    w288 = coupler_q1 * coupler_q2 * c52 / w49
    w289 = w288 + w81 * w158
    w290 = (w77 * w96 + w79 * w97) / w49
    w291 = w290 + w81 * w165
    w292 = (w77 * w102 + w79 * w103) / w49
    w293 = w292 + w81 * w171
    w294 = w287 + coupler_q2_ddot * w289 - rocker_q1_ddot * w291 - rocker_q2_ddot * w293
    w295 = w139 * w294
    w296 = w184 * (coupler_q1_dot * c51 - coupler_q2_dot * c27) - w278 * gravity_y - (w176 * w264 - w178 * w278 + (w110 * (w180 + coupler_q1 * c51 - coupler_q2 * c27) + w182 * w277))
    w297 = w0 * w281 - w67 * w284 + (w148 * w285 - w141 * w295) + (w74 * w296 - w186 * w269) - (w82 * w187 + w142 * w202)
    w298 = coupler_q2_dot * w273 - (crank_theta_dot * w269 + coupler_q1_dot * w272) - rocker_q1_dot * w275 - rocker_q2_dot * w276
    w299 = w298 + (w82 * w221 - w142 * w220)
    w300 = crank_theta_dot * w285 - coupler_q1_dot * w286 + coupler_q2_dot * w289 - rocker_q1_dot * w291 - rocker_q2_dot * w293
    w301 = w300 - (w82 * w232 + w142 * w233)
    w302 = w1 * c51 - c41 - w279 * gravity_y - (w176 * w282 - w178 * w279 + w277 * c29) - (w148 * w286 - w142 * w295)
    w303 = w143 * w295 + w148 * w289 - (w1 * c27 + w280 * gravity_y + (w176 * w283 - w178 * w280 + w277 * c30))
    w304 = w98 * w296 - w186 * w275 - (w294 * c31 + (w144 * w295 + w148 * w291)) - (w82 * w252 + w142 * w254)
    w305 = w104 * w296 - w186 * w276 - (w294 * c32 + (w146 * w295 + w148 * w293)) - (w82 * w258 + w142 * w259)
    w306 = coupler_q1_dot * c18
    w307 = w14 + w306
    w308 = (coupler_q1 * c18 + (w4 + w5)) * 0.5
    w309 = w9 * w308
    w310 = w18 * (w9 * w34) + w1 * w86
    w311 = w18 * (w7 * w34) - w1 * w88
    w312 = w75 * w90
    w313 = w83 * w90
    w314 = w7 * c5
    w315 = w9 * c5
    w316 = (w27 * w314 + w42 * w315) / w49 - w90 * w92
    w317 = (w27 * w310 - w42 * w311) / w49 - w71 * w90 - crank_theta_ddot * w312 + coupler_q1_ddot * w313 - coupler_q2_ddot * w316
    w318 = w90 * w99
    w319 = w90 * w105
    w320 = w317 - rocker_q1_ddot * w318 - rocker_q2_ddot * w319
    w321 = w7 * w308
    w322 = w9 * c18
    w323 = w9 * c20
    w324 = w18 * (w7 * w307) - w1 * w309 - (w10 * w320 - w110 * w321 - coupler_q1_ddot * w322 - coupler_q2_ddot * w323)
    w325 = w7 * c18
    w326 = w7 * c20
    w327 = w111 * w320 - w110 * w309 + coupler_q1_ddot * w325 + coupler_q2_ddot * w326 - (w1 * w321 + w18 * (w9 * w307))
    w328 = (w67 * w86 - w0 * w88) / w49 - w90 * w150
    w329 = w288 + w90 * w155
    w330 = (w46 * w310 - w62 * w86 - (w69 * w88 + w38 * w311)) / w49 - w90 * w153 + crank_theta_ddot * w328 + coupler_q1_ddot * w329
    w331 = (w46 * w314 - w86**2 + (w38 * w315 - w88**2)) / w49 - w90 * w158
    w332 = (w86 * w96 + w88 * w97) / w49
    w333 = w332 + w90 * w165
    w334 = (w86 * w102 + w88 * w103) / w49
    w335 = w334 + w90 * w171
    w336 = w330 - coupler_q2_ddot * w331 - rocker_q1_ddot * w333 - rocker_q2_ddot * w335
    w337 = w139 * w336
    w338 = w184 * (coupler_q2_dot * c53 - coupler_q1_dot * c25) - w321 * gravity_y - (w110 * (w181 + coupler_q2 * c53 - coupler_q1 * c25) + w182 * w320 - (w176 * w309 + w178 * w321))
    w339 = w0 * w324 - w67 * w327 + (w148 * w328 - w141 * w337) + (w74 * w338 - w186 * w312) - (w91 * w187 + w143 * w202)
    w340 = coupler_q1_dot * w313 - crank_theta_dot * w312 - coupler_q2_dot * w316 - rocker_q1_dot * w318 - rocker_q2_dot * w319
    w341 = w340 + (w91 * w221 - w143 * w220)
    w342 = crank_theta_dot * w328 + coupler_q1_dot * w329 - coupler_q2_dot * w331 - rocker_q1_dot * w333 - rocker_q2_dot * w335
    w343 = w342 - (w91 * w232 + w143 * w233)
    w344 = w142 * w337 + w148 * w329 - (w1 * c25 + w322 * gravity_y + (w176 * w325 - w178 * w322 + w320 * c29))
    w345 = w1 * c53 - c42 - w323 * gravity_y - (w176 * w326 - w178 * w323 + w320 * c30) - (w148 * w331 - w143 * w337)
    w346 = w98 * w338 - w186 * w318 - (w336 * c31 + (w144 * w337 + w148 * w333)) - (w91 * w252 + w143 * w254)
    w347 = w104 * w338 - w186 * w319 - (w336 * c32 + (w146 * w337 + w148 * w335)) - (w91 * w258 + w143 * w259)
    w348 = w129 * (rocker_q1_dot * c54 - rocker_q2_dot * c14) - (w253 + w23 * ((w133 + w134 + rocker_q2 * c38) * 0.5)) * gravity_y
    w349 = w50 * (w23 * w54) - w58 * w97
    w350 = w50 * (w41 * w54) + w58 * w96
    w351 = w150 * w164
    w352 = w155 * w164
    w353 = w158 * w164
    w354 = (w38 * w349 - w46 * w350) / w49 - w153 * w164 - crank_theta_ddot * w351 + coupler_q1_ddot * w352 + coupler_q2_ddot * w353
    w355 = w23 * c7
    w356 = w41 * c7
    w357 = (w46 * w355 + w38 * w356) / w49 - w164 * w165
    w358 = w164 * w171
    w359 = w354 + rocker_q1_ddot * w357 - rocker_q2_ddot * w358
    w360 = w348 - (w147 * (w130 + rocker_q1 * c54 - rocker_q2 * c14) + w139 * w359)
    w361 = (w67 * w96 - w0 * w97) / w49 - w75 * w164
    w362 = w290 + w83 * w164
    w363 = (w42 * w349 - w69 * w97 - (w62 * w96 + w27 * w350)) / w49 - w71 * w164 + crank_theta_ddot * w361 + coupler_q1_ddot * w362
    w364 = w332 + w92 * w164
    w365 = (w27 * w355 - w96**2 + (w42 * w356 - w97**2)) / w49 - w99 * w164
    w366 = rocker_q1 * rocker_q2 * c55 / w49
    w367 = w366 + w105 * w164
    w368 = w363 + coupler_q2_ddot * w364 + rocker_q1_ddot * w365 - rocker_q2_ddot * w367
    w369 = w182 * w368
    w370 = w141 * w360 - w148 * w351 - (w0 * (w10 * w368) + w67 * (w111 * w368)) + (w186 * w361 - w74 * w369)
    w371 = crank_theta_dot * w361 + coupler_q1_dot * w362 + coupler_q2_dot * w364 + rocker_q1_dot * w365 - rocker_q2_dot * w367
    w372 = w371 + (w144 * w220 - w98 * w221)
    w373 = coupler_q1_dot * w352 - crank_theta_dot * w351 + coupler_q2_dot * w353 + rocker_q1_dot * w357 - rocker_q2_dot * w358
    w374 = w373 + (w98 * w232 + w144 * w233)
    w375 = w82 * w369 + w186 * w362 - (w368 * c29 + (w142 * w360 - w148 * w352)) - (w98 * w239 + w144 * w240)
    w376 = w91 * w369 + w186 * w364 - (w368 * c30 + (w143 * w360 - w148 * w353)) - (w98 * w246 + w144 * w247)
    w377 = w58 * c54 - c43 - w41 * c56 - w359 * c31 + (w144 * w360 + w148 * w357) + (w186 * w365 - w98 * w369)
    w378 = w146 * w360 - w148 * w358 - (w58 * c14 + w41 * c57 + w359 * c32) - (w104 * w369 + w186 * w367) + (w98 * w258 + w144 * w259)
    w379 = w129 * (rocker_q2_dot * c58 - rocker_q1_dot * c12) - w23 * ((rocker_q1 * c37 + (w135 + w136)) * 0.5) * gravity_y
    w380 = w50 * (w23 * w55) - w58 * w103
    w381 = w50 * (w41 * w55) + w58 * w102
    w382 = w150 * w170
    w383 = w155 * w170
    w384 = w158 * w170
    w385 = (w38 * w380 - w46 * w381) / w49 - w153 * w170 - crank_theta_ddot * w382 + coupler_q1_ddot * w383 + coupler_q2_ddot * w384
    w386 = w165 * w170
    w387 = w23 * c8
    w388 = w41 * c8
    w389 = (w46 * w387 + w38 * w388) / w49 - w170 * w171
    w390 = w385 - rocker_q1_ddot * w386 + rocker_q2_ddot * w389
    w391 = w379 - (w147 * (w131 + rocker_q2 * c58 - rocker_q1 * c12) + w139 * w390)
    w392 = (w67 * w102 - w0 * w103) / w49 - w75 * w170
    w393 = (w42 * w380 - w69 * w103 - (w62 * w102 + w27 * w381)) / w49 - w71 * w170 + crank_theta_ddot * w392
    w394 = w292 + w83 * w170
    w395 = w334 + w92 * w170
    w396 = w366 + w99 * w170
    w397 = (w27 * w387 - w102**2 + (w42 * w388 - w103**2)) / w49 - w105 * w170
    w398 = w393 + coupler_q1_ddot * w394 + coupler_q2_ddot * w395 - rocker_q1_ddot * w396 + rocker_q2_ddot * w397
    w399 = w182 * w398
    w400 = w141 * w391 - w148 * w382 - (w0 * (w10 * w398) + w67 * (w111 * w398)) + (w186 * w392 - w74 * w399)
    w401 = crank_theta_dot * w392 + coupler_q1_dot * w394 + coupler_q2_dot * w395 - rocker_q1_dot * w396 + rocker_q2_dot * w397
    w402 = w401 + (w146 * w220 - w104 * w221)
    w403 = coupler_q1_dot * w383 - crank_theta_dot * w382 + coupler_q2_dot * w384 - rocker_q1_dot * w386 + rocker_q2_dot * w389
    w404 = w403 + (w104 * w232 + w146 * w233)
    w405 = w82 * w399 + w186 * w394 - (w398 * c29 + (w142 * w391 - w148 * w383)) - (w104 * w239 + w146 * w240)
    w406 = w91 * w399 + w186 * w395 - (w398 * c30 + (w143 * w391 - w148 * w384)) - (w104 * w246 + w146 * w247)
    w407 = w144 * w391 - w148 * w386 - (w58 * c12 + w41 * c59 + w390 * c31) - (w98 * w399 + w186 * w396) + (w104 * w252 + w146 * w254)
    w408 = w58 * c58 - c44 - w41 * c60 - w390 * c32 + (w146 * w391 + w148 * w389) + (w186 * w397 - w104 * w399)
    w409 = 2 * crank_theta_dot
    w410 = w67 * w409
    w411 = w0 * w409
    w412 = (w27 * w411 + w42 * w410) / w49
    w413 = (w46 * w411 + w38 * w410) / w49
    w414 = w139 * w413
    w415 = w111 * w411 - w10 * w410 - w182 * w412
    w416 = w0 * (w410 * c2 + w10 * w412) - w67 * (w411 * c2 - w111 * w412) + w141 * w414 - w74 * w415 + (w74 * w217 + w141 * w229)
    w417 = w265 + (w12 + w13)
    w418 = 2 * w33
    w419 = w18 * w79 - w7 * w418
    w420 = w9 * w418 + w18 * w77
    w421 = (w27 * w419 - w42 * w420) / w49
    w422 = (w46 * w419 - w38 * w420) / w49
    w423 = w139 * w422
    w424 = w0 * (w9 * w417 + w18 * w114 - w10 * w421) - w67 * (w18 * w120 + w7 * w417 + w111 * w421) - w141 * w423
    w425 = w180 * w184 - w182 * w421
    w426 = w306 + (w14 + w15)
    w427 = 2 * w34
    w428 = w18 * w88 - w7 * w427
    w429 = w9 * w427 + w18 * w86
    w430 = (w27 * w428 - w42 * w429) / w49
    w431 = (w46 * w428 - w38 * w429) / w49
    w432 = w139 * w431
    w433 = w0 * (w9 * w426 + w18 * w116 - w10 * w430) - w67 * (w7 * w426 - w18 * w122 + w111 * w430) - w141 * w432
    w434 = w181 * w184 - w182 * w430
    w435 = 2 * w54
    w436 = w41 * w435 + w50 * w96
    w437 = w50 * w97 - w23 * w435
    w438 = (w38 * w436 - w46 * w437) / w49
    w439 = w129 * w130 - w139 * w438
    w440 = (w42 * w436 - w27 * w437) / w49
    w441 = w182 * w440
    w442 = w141 * w439 - (w0 * (w10 * w440) + w67 * (w111 * w440)) - w74 * w441 + (w98 * w217 + w144 * w229)
    w443 = 2 * w55
    w444 = w41 * w443 + w50 * w102
    w445 = w50 * w103 - w23 * w443
    w446 = (w38 * w444 - w46 * w445) / w49
    w447 = w129 * w131 - w139 * w446
    w448 = (w42 * w444 - w27 * w445) / w49
    w449 = w182 * w448
    w450 = w141 * w447 - (w0 * (w10 * w448) + w67 * (w111 * w448)) - w74 * w449 + (w104 * w217 + w146 * w229)
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # crank.theta
            w235, w297 + (w217 * w299 + w229 * w301), w339 + (w217 * w341 + w229 * w343),
            w370 + (w98 * w187 + w144 * w202) + (w217 * w372 + w229 * w374),
            w400 + (w104 * w187 + w146 * w202) + (w217 * w402 + w229 * w404),
        ),
        ca.horzcat(  # coupler.q1
            w243, w302 - (w82 * w296 + w186 * w272) + (w82 * w239 + w142 * w240) + (w241 * w299 + w242 * w301),
            w344 - (w82 * w338 - w186 * w313) + (w91 * w239 + w143 * w240) + (w241 * w341 + w242 * w343),
            w375 + (w241 * w372 + w242 * w374), w405 + (w241 * w402 + w242 * w404),
        ),
        ca.horzcat(  # coupler.q2
            w250, w303 - (w91 * w296 - w186 * w273) + (w82 * w246 + w142 * w247) + (w248 * w299 + w249 * w301),
            w345 - (w91 * w338 + w186 * w316) + (w91 * w246 + w143 * w247) + (w248 * w341 + w249 * w343),
            w376 + (w248 * w372 + w249 * w374), w406 + (w248 * w402 + w249 * w404),
        ),
        ca.horzcat(  # rocker.q1
            w74 * w252 + w141 * w254 - (w207 * c31 + w144 * w208 + w98 * w209) + (w222 * w255 + w234 * w256),
            w304 + (w255 * w299 + w256 * w301), w346 + (w255 * w341 + w256 * w343),
            w377 + (w98 * w252 + w144 * w254) + (w255 * w372 + w256 * w374), w407 + (w255 * w402 + w256 * w404),
        ),
        ca.horzcat(  # rocker.q2
            w262, w305 + (w260 * w299 + w261 * w301), w347 + (w260 * w341 + w261 * w343),
            w378 + (w260 * w372 + w261 * w374), w408 + (w104 * w258 + w146 * w259) + (w260 * w402 + w261 * w404),
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # crank.theta
            w416, w424 + w74 * w425 - (w82 * w217 + w142 * w229), w433 + w74 * w434 - (w91 * w217 + w143 * w229),
            w442, w450,
        ),
        ca.horzcat(  # coupler.q1
            w82 * w415 - (w114 * w411 - w120 * w410 - w412 * c29 + w142 * w414) + (w74 * w241 + w141 * w242),
            w142 * w423 - w421 * c29 - w82 * w425 - (w82 * w241 + w142 * w242),
            w142 * w432 - w430 * c29 - w82 * w434 - (w91 * w241 + w143 * w242),
            w82 * w441 - (w440 * c29 + w142 * w439) + (w98 * w241 + w144 * w242),
            w82 * w449 - (w448 * c29 + w142 * w447) + (w104 * w241 + w146 * w242),
        ),
        ca.horzcat(  # coupler.q2
            w91 * w415 - (w116 * w411 + w122 * w410 - w412 * c30 + w143 * w414) + (w74 * w248 + w141 * w249),
            w143 * w423 - w421 * c30 - w91 * w425 - (w82 * w248 + w142 * w249),
            w143 * w432 - w430 * c30 - w91 * w434 - (w91 * w248 + w143 * w249),
            w91 * w441 - (w440 * c30 + w143 * w439) + (w98 * w248 + w144 * w249),
            w91 * w449 - (w448 * c30 + w143 * w447) + (w104 * w248 + w146 * w249),
        ),
        ca.horzcat(  # rocker.q1
            w413 * c31 + w144 * w414 - w98 * w415 + (w74 * w255 + w141 * w256),
            w98 * w425 - (w422 * c31 + w144 * w423) - (w82 * w255 + w142 * w256),
            w98 * w434 - (w431 * c31 + w144 * w432) - (w91 * w255 + w143 * w256),
            w144 * w439 - w438 * c31 - w98 * w441 + (w98 * w255 + w144 * w256),
            w144 * w447 - w446 * c31 - w98 * w449 + (w104 * w255 + w146 * w256),
        ),
        ca.horzcat(  # rocker.q2
            w413 * c32 + w146 * w414 - w104 * w415 + (w74 * w260 + w141 * w261),
            w104 * w425 - (w422 * c32 + w146 * w423) - (w82 * w260 + w142 * w261),
            w104 * w434 - (w431 * c32 + w146 * w432) - (w91 * w260 + w143 * w261),
            w146 * w439 - w438 * c32 - w104 * w441 + (w98 * w260 + w144 * w261),
            w146 * w447 - w446 * c32 - w104 * w449 + (w104 * w260 + w146 * w261),
        ),
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 5 x 4) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 4 x 4) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 4 x 4) [SI]: damping of the stiff deflections
    58 operations.
    """
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 4) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 4) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 4) [N, N m]: part of Q_hat of S
    521 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 68)
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
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 4 x 4) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 4) [N, N m]: right-hand side of a sub-step, slow q'' given
    432 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 68)
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
    1480 operations.
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
