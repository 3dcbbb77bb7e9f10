"""Chain of 3 links in space: equations of motion, emitted by symgen from the scene `spatial_chain`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 link1.turn_x [rad], 1 link1.turn_y [rad], 2 link1.turn_z [rad], 3 link2.turn_x [rad],
    4 link2.turn_y [rad], 5 link2.turn_z [rad], 6 link3.turn_x [rad], 7 link3.turn_y [rad],
    8 link3.turn_z [rad]

q_d, the dependent coordinates by index:
    0 link1.x [m], 1 link1.y [m], 2 link1.z [m], 3 link1.e0 [1], 4 link1.e1 [1], 5 link1.e2 [1],
    6 link1.e3 [1], 7 link2.x [m], 8 link2.y [m], 9 link2.z [m], 10 link2.e0 [1], 11 link2.e1 [1],
    12 link2.e2 [1], 13 link2.e3 [1], 14 link3.x [m], 15 link3.y [m], 16 link3.z [m], 17 link3.e0 [1],
    18 link3.e1 [1], 19 link3.e2 [1], 20 link3.e3 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 19) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    89 operations.
    """
    p = ca.SX.sym("p", 19)
    gravity_z = p[0]
    link1_mass = p[1]
    link1_center_of_mass_x = p[2]
    link1_inertia_xx = p[3]
    link1_inertia_yy = p[4]
    link1_inertia_zz = p[5]
    link2_mass = p[6]
    link2_center_of_mass_x = p[7]
    link2_inertia_xx = p[8]
    link2_inertia_yy = p[9]
    link2_inertia_zz = p[10]
    link3_mass = p[11]
    link3_center_of_mass_x = p[12]
    link3_inertia_xx = p[13]
    link3_inertia_yy = p[14]
    link3_inertia_zz = p[15]
    link1_end_x = p[16]
    link2_end_x = p[17]
    # intermediate terms (41)
    w0 = (link1_inertia_xx + link1_inertia_yy + link1_inertia_zz) / 2.0
    w1 = w0 - link1_inertia_yy
    w2 = w0 - link1_inertia_zz
    w3 = w1 + w2
    w4 = w0 - link1_inertia_xx + link1_mass * link1_center_of_mass_x**2
    w5 = (link2_mass + link3_mass) * link1_end_x
    w6 = w4 + link1_end_x * w5
    w7 = link2_mass * link2_center_of_mass_x
    w8 = link3_mass * link2_end_x
    w9 = (link2_inertia_xx + link2_inertia_yy + link2_inertia_zz) / 2.0
    w10 = w9 - link2_inertia_yy
    w11 = w9 - link2_inertia_zz
    w12 = w10 + w11
    w13 = w9 - link2_inertia_xx + link2_mass * link2_center_of_mass_x**2
    w14 = w13 + link2_end_x * w8
    w15 = (link3_inertia_xx + link3_inertia_yy + link3_inertia_zz) / 2.0
    w16 = w15 - link3_inertia_yy
    w17 = w15 - link3_inertia_zz
    w18 = w16 + w17
    w19 = w15 - link3_inertia_xx + link3_mass * link3_center_of_mass_x**2
    w20 = w17 + w19
    w21 = w16 + w19
    w22 = w1 - w2
    w23 = link1_mass * link1_center_of_mass_x
    w24 = w10 - w11
    w25 = w16 - w17
    w26 = w14 - w10
    w27 = w19 - w16
    w28 = w2 + w4
    w29 = w1 + w4
    w30 = 4.0 * w28
    w31 = 4.0 * w29
    w32 = 4.0 * w3
    w33 = w11 + w13
    w34 = w10 + w13
    w35 = 4.0 * w33
    w36 = 4.0 * w34
    w37 = 4.0 * w12
    w38 = 4.0 * w20
    w39 = 4.0 * w21
    w40 = 4.0 * w18
    # outputs
    c = ca.vertcat(
        w3,  # c0
        link1_end_x,  # link1_end_x
        w2 + w6,  # c2
        link2_end_x,  # link2_end_x
        w7 + w8,  # c4
        link3_mass * link3_center_of_mass_x,  # c5
        w1 + w6,  # c6
        w12,  # c7
        w11 + w14,  # c8
        w10 + w14,  # c9
        w18,  # c10
        w20,  # c11
        w21,  # c12
        -w22,  # c13
        gravity_z,  # gravity_z
        (w5 + w23) * gravity_z,  # c15
        w2 - w6,  # c16
        w6 - w1,  # c17
        -w24,  # c18
        w11 - w14,  # c19
        -w25,  # c20
        w17 - w19,  # c21
        -w26,  # c22
        -w27,  # c23
        w1,  # c24
        w2,  # c25
        link1_mass,  # link1_mass
        w4,  # c27
        link2_mass,  # link2_mass
        link3_mass,  # link3_mass
        w7,  # c30
        w10,  # c31
        w11,  # c32
        w13,  # c33
        w16,  # c34
        w17,  # c35
        w19,  # c36
        w23,  # c37
        w28,  # c38
        w29,  # c39
        w30 - w31,  # c40
        w31 - w32,  # c41
        w32 - w30,  # c42
        w33,  # c43
        w34,  # c44
        w35 - w36,  # c45
        w36 - w37,  # c46
        w37 - w35,  # c47
        w38 - w39,  # c48
        w39 - w40,  # c49
        w40 - w38,  # c50
        link1_mass * gravity_z,  # c51
        link2_mass * gravity_z,  # c52
        link3_mass * gravity_z,  # c53
        -gravity_z,  # c54
        w6,  # c55
        w14,  # c56
        w22,  # c57
        w24,  # c58
        w26,  # c59
        w25,  # c60
        w27,  # c61
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 9 x 9) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 9) [N, N m]: condensed force S^T (Q* - M s)
    302 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    c0 = c[0]
    link1_end_x = c[1]
    c2 = c[2]
    link2_end_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    gravity_z = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    # intermediate terms (117)
    w0 = 2 * link1_e1
    w1 = w0 * link1_e3
    w2 = 2 * link1_e2
    w3 = w2 * link1_e0
    w4 = w1 + w3
    w5 = w4 * link1_end_x
    w6 = 2 * link2_e1
    w7 = w6 * link2_e3
    w8 = 2 * link2_e2
    w9 = w8 * link2_e0
    w10 = w7 + w9
    w11 = w10 * c4
    w12 = link1_e3 * w2
    w13 = w0 * link1_e0
    w14 = w12 - w13
    w15 = w14 * link1_end_x
    w16 = link2_e3 * w8
    w17 = w6 * link2_e0
    w18 = w16 - w17
    w19 = w18 * c4
    w20 = link1_e1 * w0
    w21 = link1_e2 * w2
    w22 = 1.0 - (w20 + w21)
    w23 = w22 * link1_end_x
    w24 = link2_e1 * w6
    w25 = link2_e2 * w8
    w26 = 1.0 - (w24 + w25)
    w27 = w26 * c4
    w28 = w5 * w11 + w15 * w19 + w23 * w27
    w29 = w6 * link2_e2
    w30 = 2 * link2_e3
    w31 = link2_e0 * w30
    w32 = w29 - w31
    w33 = w32 * c4
    w34 = link2_e3 * w30
    w35 = 1.0 - (w24 + w34)
    w36 = w35 * c4
    w37 = w16 + w17
    w38 = w37 * c4
    w39 = -(w5 * w33 + w15 * w36 + w23 * w38)
    w40 = 2 * link3_e1
    w41 = w40 * link3_e3
    w42 = 2 * link3_e2
    w43 = w42 * link3_e0
    w44 = w41 + w43
    w45 = w44 * c5
    w46 = link3_e3 * w42
    w47 = w40 * link3_e0
    w48 = w46 - w47
    w49 = w48 * c5
    w50 = link3_e1 * w40
    w51 = link3_e2 * w42
    w52 = 1.0 - (w50 + w51)
    w53 = w52 * c5
    w54 = w5 * w45 + w15 * w49 + w23 * w53
    w55 = w40 * link3_e2
    w56 = 2 * link3_e3
    w57 = link3_e0 * w56
    w58 = w55 - w57
    w59 = w58 * c5
    w60 = link3_e3 * w56
    w61 = 1.0 - (w50 + w60)
    w62 = w61 * c5
    w63 = w46 + w47
    w64 = w63 * c5
    w65 = -(w5 * w59 + w15 * w62 + w23 * w64)
    w66 = w0 * link1_e2
    w67 = 2 * link1_e3
    w68 = link1_e0 * w67
    w69 = w66 - w68
    w70 = w69 * link1_end_x
    w71 = link1_e3 * w67
    w72 = 1.0 - (w20 + w71)
    w73 = w72 * link1_end_x
    w74 = w12 + w13
    w75 = w74 * link1_end_x
    w76 = -(w11 * w70 + w19 * w73 + w27 * w75)
    w77 = w33 * w70 + w36 * w73 + w38 * w75
    w78 = -(w45 * w70 + w49 * w73 + w53 * w75)
    w79 = w59 * w70 + w62 * w73 + w64 * w75
    w80 = w10 * link2_end_x
    w81 = w18 * link2_end_x
    w82 = w26 * link2_end_x
    w83 = w45 * w80 + w49 * w81 + w53 * w82
    w84 = -(w59 * w80 + w62 * w81 + w64 * w82)
    w85 = w32 * link2_end_x
    w86 = w35 * link2_end_x
    w87 = w37 * link2_end_x
    w88 = -(w45 * w85 + w49 * w86 + w53 * w87)
    w89 = w59 * w85 + w62 * w86 + w64 * w87
    w90 = link1_omega_z * link1_omega_x
    w91 = link3_omega_x * link3_omega_y
    w92 = link3_omega_y**2 + link3_omega_z**2
    w93 = link3_omega_x * link3_omega_z
    w94 = (w58 * w91 - (1.0 - (w51 + w60)) * w92 + w44 * w93) * c5
    w95 = link2_omega_x * link2_omega_y
    w96 = link2_omega_y**2 + link2_omega_z**2
    w97 = link2_omega_x * link2_omega_z
    w98 = w32 * w95 - (1.0 - (w25 + w34)) * w96 + w10 * w97
    w99 = w94 + w98 * c4
    w100 = (w61 * w91 - w92 * (w55 + w57) + w48 * w93) * c5
    w101 = w35 * w95 - w96 * (w29 + w31) + w18 * w97
    w102 = w100 + w101 * c4
    w103 = (w63 * w91 - w92 * (w41 - w43) + w52 * w93) * c5
    w104 = w37 * w95 - w96 * (w7 - w9) + w26 * w97
    w105 = w103 + w104 * c4
    w106 = link1_omega_y * link1_omega_x
    w107 = link1_omega_y**2 + link1_omega_z**2
    w108 = (w69 * w106 - (1.0 - (w21 + w71)) * w107 + w4 * w90) * link1_end_x
    w109 = w94 * link2_end_x + w108 * c4
    w110 = (w72 * w106 - w107 * (w66 + w68) + w14 * w90) * link1_end_x
    w111 = w100 * link2_end_x + w110 * c4
    w112 = (w74 * w106 - w107 * (w1 - w3) + w22 * w90) * link1_end_x - gravity_z
    w113 = w103 * link2_end_x + w112 * c4
    w114 = w108 + w98 * link2_end_x
    w115 = w110 + w101 * link2_end_x
    w116 = w112 + w104 * link2_end_x
    # outputs
    M_hat = ca.SX(9, 9)
    # link1.turn_x
    M_hat[0, 0] = c0
    # link1.turn_y
    M_hat[1, 1] = c2
    M_hat[1, 4] = w28
    M_hat[1, 5] = w39
    M_hat[1, 7] = w54
    M_hat[1, 8] = w65
    # link1.turn_z
    M_hat[2, 2] = c6
    M_hat[2, 4] = w76
    M_hat[2, 5] = w77
    M_hat[2, 7] = w78
    M_hat[2, 8] = w79
    # link2.turn_x
    M_hat[3, 3] = c7
    # link2.turn_y
    M_hat[4, 1] = w28
    M_hat[4, 2] = w76
    M_hat[4, 4] = c8
    M_hat[4, 7] = w83
    M_hat[4, 8] = w84
    # link2.turn_z
    M_hat[5, 1] = w39
    M_hat[5, 2] = w77
    M_hat[5, 5] = c9
    M_hat[5, 7] = w88
    M_hat[5, 8] = w89
    # link3.turn_x
    M_hat[6, 6] = c10
    # link3.turn_y
    M_hat[7, 1] = w54
    M_hat[7, 2] = w78
    M_hat[7, 4] = w83
    M_hat[7, 5] = w88
    M_hat[7, 7] = c11
    # link3.turn_z
    M_hat[8, 1] = w65
    M_hat[8, 2] = w79
    M_hat[8, 4] = w84
    M_hat[8, 5] = w89
    M_hat[8, 8] = c12
    Q_hat = ca.vertcat(
        link1_omega_y * link1_omega_z * c13,  # link1.turn_x
        w5 * w99 + w15 * w102 + w23 * w105 - (w22 * c15 + w90 * c16),  # link1.turn_y
        w74 * c15 - w106 * c17 - (w70 * w99 + w73 * w102 + w75 * w105),  # link1.turn_z
        link2_omega_y * link2_omega_z * c18,  # link2.turn_x
        w10 * w109 + w18 * w111 + w26 * w113 - w97 * c19,  # link2.turn_y
        w95 * c22 - (w32 * w109 + w35 * w111 + w37 * w113),  # link2.turn_z
        link3_omega_y * link3_omega_z * c20,  # link3.turn_x
        w45 * w114 + w49 * w115 + w53 * w116 - w93 * c21,  # link3.turn_y
        w91 * c23 - (w59 * w114 + w62 * w115 + w64 * w116),  # link3.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_d", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 12) [1]: unit quaternions from which the turns in q_i are rotation vectors
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 21) [mixed]: dependent coordinates after one Newton step
    164 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    chart = ca.SX.sym("chart", 12)
    c = ca.SX.sym("c", 62)
    link1_turn_x = q_i[0]
    link1_turn_y = q_i[1]
    link1_turn_z = q_i[2]
    link2_turn_x = q_i[3]
    link2_turn_y = q_i[4]
    link2_turn_z = q_i[5]
    link3_turn_x = q_i[6]
    link3_turn_y = q_i[7]
    link3_turn_z = q_i[8]
    link1_chart_0 = chart[0]
    link1_chart_1 = chart[1]
    link1_chart_2 = chart[2]
    link1_chart_3 = chart[3]
    link2_chart_0 = chart[4]
    link2_chart_1 = chart[5]
    link2_chart_2 = chart[6]
    link2_chart_3 = chart[7]
    link3_chart_0 = chart[8]
    link3_chart_1 = chart[9]
    link3_chart_2 = chart[10]
    link3_chart_3 = chart[11]
    link1_end_x = c[1]
    link2_end_x = c[3]
    # intermediate terms (35)
    w0 = ca.sqrt((link1_turn_x**2 + link1_turn_y**2 + link1_turn_z**2) / 4.0 + 1e-300)
    w1 = ca.cos(w0)
    w2 = ca.sin(w0) / w0 / 2.0
    w3 = link1_turn_x * w2
    w4 = link1_turn_y * w2
    w5 = link1_turn_z * w2
    w6 = link1_chart_0 * w1 - (link1_chart_1 * w3 + link1_chart_2 * w4 + link1_chart_3 * w5)
    w7 = link1_chart_0 * w3 + w1 * link1_chart_1 + (link1_chart_2 * w5 - w4 * link1_chart_3)
    w8 = link1_chart_0 * w4 + w1 * link1_chart_2 + (w3 * link1_chart_3 - link1_chart_1 * w5)
    w9 = link1_chart_0 * w5 + w1 * link1_chart_3 + (link1_chart_1 * w4 - w3 * link1_chart_2)
    w10 = 2 * w8
    w11 = 2 * w9
    w12 = (1.0 - (w8 * w10 + w9 * w11)) * link1_end_x
    w13 = 2 * w7
    w14 = (w8 * w13 + w6 * w11) * link1_end_x
    w15 = (w9 * w13 - w6 * w10) * link1_end_x
    w16 = ca.sqrt(1e-300 + (link2_turn_x**2 + link2_turn_y**2 + link2_turn_z**2) / 4.0)
    w17 = ca.cos(w16)
    w18 = ca.sin(w16) / w16 / 2.0
    w19 = link2_turn_x * w18
    w20 = link2_turn_y * w18
    w21 = link2_turn_z * w18
    w22 = link2_chart_0 * w17 - (link2_chart_1 * w19 + link2_chart_2 * w20 + link2_chart_3 * w21)
    w23 = link2_chart_0 * w19 + w17 * link2_chart_1 + (link2_chart_2 * w21 - w20 * link2_chart_3)
    w24 = link2_chart_0 * w20 + w17 * link2_chart_2 + (w19 * link2_chart_3 - link2_chart_1 * w21)
    w25 = link2_chart_0 * w21 + w17 * link2_chart_3 + (link2_chart_1 * w20 - w19 * link2_chart_2)
    w26 = 2 * w24
    w27 = 2 * w25
    w28 = 2 * w23
    w29 = ca.sqrt(1e-300 + (link3_turn_x**2 + link3_turn_y**2 + link3_turn_z**2) / 4.0)
    w30 = ca.cos(w29)
    w31 = ca.sin(w29) / w29 / 2.0
    w32 = link3_turn_x * w31
    w33 = link3_turn_y * w31
    w34 = link3_turn_z * w31
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        w6,  # link1.e0
        w7,  # link1.e1
        w8,  # link1.e2
        w9,  # link1.e3
        w12,  # link2.x
        w14,  # link2.y
        w15,  # link2.z
        w22,  # link2.e0
        w23,  # link2.e1
        w24,  # link2.e2
        w25,  # link2.e3
        w12 + (1.0 - (w24 * w26 + w25 * w27)) * link2_end_x,  # link3.x
        w14 + (w24 * w28 + w22 * w27) * link2_end_x,  # link3.y
        w15 + (w25 * w28 - w22 * w26) * link2_end_x,  # link3.z
        link3_chart_0 * w30 - (link3_chart_1 * w32 + link3_chart_2 * w33 + link3_chart_3 * w34),  # link3.e0
        link3_chart_0 * w32 + w30 * link3_chart_1 + (link3_chart_2 * w34 - w33 * link3_chart_3),  # link3.e1
        link3_chart_0 * w33 + w30 * link3_chart_2 + (w32 * link3_chart_3 - link3_chart_1 * w34),  # link3.e2
        link3_chart_0 * w34 + w30 * link3_chart_3 + (link3_chart_1 * w33 - w32 * link3_chart_2),  # link3.e3
    )
    inputs, outputs = [q_i, chart, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 21) [mixed]: rates of the dependent coordinates
    226 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    link1_end_x = c[1]
    link2_end_x = c[3]
    # intermediate terms (58)
    w0 = link1_e1 * 0.5
    w1 = link1_e2 * 0.5
    w2 = link1_e3 * 0.5
    w3 = w0 * link1_omega_x + w1 * link1_omega_y + w2 * link1_omega_z
    w4 = link1_e0 * 0.5
    w5 = link1_omega_x * w4 - link1_omega_y * w2 + w1 * link1_omega_z
    w6 = link1_omega_x * w2 + link1_omega_y * w4 - w0 * link1_omega_z
    w7 = w0 * link1_omega_y - link1_omega_x * w1 + link1_omega_z * w4
    w8 = 2 * link1_e3
    w9 = 2 * link1_e1
    w10 = 2 * link1_e2
    w11 = (link1_e3 * w9 - link1_e0 * w10) * link1_end_x
    w12 = 2 * -link1_e2
    w13 = (link1_e2 * w9 + link1_e0 * w8) * link1_end_x
    w14 = 2 * -link1_e3
    w15 = w13 * w14
    w16 = 2 * link1_e0
    w17 = w11 * w16
    w18 = 2 * -link1_e1
    w19 = w11 * w18
    w20 = w13 * w16
    w21 = w5 * (w8 * w11 - w12 * w13) - w3 * (w11 * w12 - w15) + w6 * (w17 - w9 * w13) + w7 * (w19 - w20)
    w22 = (1.0 - (link1_e2 * w10 + link1_e3 * w8)) * link1_end_x
    w23 = w12 * w22
    w24 = w16 * w22
    w25 = w5 * (w23 - w17) - w3 * (w14 * w22 - w19) + w6 * (w9 * w22 - w11 * w14) + w7 * (w24 - w10 * w11)
    w26 = w5 * (w20 - w8 * w22) - w3 * (w13 * w18 - w23) + w6 * (w15 - w24) + w7 * (w10 * w13 - w18 * w22)
    w27 = link2_e1 * 0.5
    w28 = link2_e2 * 0.5
    w29 = link2_e3 * 0.5
    w30 = w27 * link2_omega_x + w28 * link2_omega_y + w29 * link2_omega_z
    w31 = link2_e0 * 0.5
    w32 = link2_omega_x * w31 - link2_omega_y * w29 + w28 * link2_omega_z
    w33 = link2_omega_x * w29 + link2_omega_y * w31 - w27 * link2_omega_z
    w34 = w27 * link2_omega_y - link2_omega_x * w28 + link2_omega_z * w31
    w35 = 2 * -link2_e2
    w36 = 2 * link2_e1
    w37 = 2 * link2_e2
    w38 = (link2_e3 * w36 - link2_e0 * w37) * link2_end_x
    w39 = 2 * -link2_e3
    w40 = 2 * link2_e3
    w41 = (link2_e2 * w36 + link2_e0 * w40) * link2_end_x
    w42 = w39 * w41
    w43 = 2 * link2_e0
    w44 = w38 * w43
    w45 = 2 * -link2_e1
    w46 = w38 * w45
    w47 = w41 * w43
    w48 = w21 - w30 * (w35 * w38 - w42) + w32 * (w38 * w40 - w35 * w41) + w33 * (w44 - w36 * w41) + w34 * (w46 - w47)
    w49 = (1.0 - (link2_e2 * w37 + link2_e3 * w40)) * link2_end_x
    w50 = w35 * w49
    w51 = w43 * w49
    w52 = w25 - w30 * (w39 * w49 - w46) + w32 * (w50 - w44) + w33 * (w36 * w49 - w38 * w39) + w34 * (w51 - w37 * w38)
    w53 = w26 - w30 * (w41 * w45 - w50) + w32 * (w47 - w40 * w49) + w33 * (w42 - w51) + w34 * (w37 * w41 - w45 * w49)
    w54 = link3_e1 * 0.5
    w55 = link3_e2 * 0.5
    w56 = link3_e3 * 0.5
    w57 = link3_e0 * 0.5
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        -w3,  # link1.e0
        w5,  # link1.e1
        w6,  # link1.e2
        w7,  # link1.e3
        w21,  # link2.x
        w25,  # link2.y
        w26,  # link2.z
        -w30,  # link2.e0
        w32,  # link2.e1
        w33,  # link2.e2
        w34,  # link2.e3
        w48,  # link3.x
        w52,  # link3.y
        w53,  # link3.z
        -(w54 * link3_omega_x + w55 * link3_omega_y + w56 * link3_omega_z),  # link3.e0
        link3_omega_x * w57 - link3_omega_y * w56 + w55 * link3_omega_z,  # link3.e1
        link3_omega_x * w56 + link3_omega_y * w57 - w54 * link3_omega_z,  # link3.e2
        w54 * link3_omega_y - link3_omega_x * w55 + link3_omega_z * w57,  # link3.e3
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 21) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 21) [mixed]: accelerations of the dependent coordinates
    352 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_d_dot = ca.SX.sym("q_d_dot", 21)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    link1_e0_dot = q_d_dot[3]
    link1_e1_dot = q_d_dot[4]
    link1_e2_dot = q_d_dot[5]
    link1_e3_dot = q_d_dot[6]
    link2_e0_dot = q_d_dot[10]
    link2_e1_dot = q_d_dot[11]
    link2_e2_dot = q_d_dot[12]
    link2_e3_dot = q_d_dot[13]
    link1_turn_x_ddot = q_i_ddot[0]
    link1_turn_y_ddot = q_i_ddot[1]
    link1_turn_z_ddot = q_i_ddot[2]
    link2_turn_x_ddot = q_i_ddot[3]
    link2_turn_y_ddot = q_i_ddot[4]
    link2_turn_z_ddot = q_i_ddot[5]
    link3_turn_x_ddot = q_i_ddot[6]
    link3_turn_y_ddot = q_i_ddot[7]
    link3_turn_z_ddot = q_i_ddot[8]
    link1_end_x = c[1]
    link2_end_x = c[3]
    # intermediate terms (74)
    w0 = (link1_omega_x**2 + link1_omega_y**2 + link1_omega_z**2) / 4.0
    w1 = link1_e1 * 0.5
    w2 = link1_e2 * 0.5
    w3 = link1_e3 * 0.5
    w4 = w0 * link1_e0 + w1 * link1_turn_x_ddot + w2 * link1_turn_y_ddot + w3 * link1_turn_z_ddot
    w5 = link1_e0 * 0.5
    w6 = link1_turn_x_ddot * w5 - w0 * link1_e1 - link1_turn_y_ddot * w3 + w2 * link1_turn_z_ddot
    w7 = link1_turn_x_ddot * w3 - w0 * link1_e2 + link1_turn_y_ddot * w5 - w1 * link1_turn_z_ddot
    w8 = w1 * link1_turn_y_ddot - (w0 * link1_e3 + link1_turn_x_ddot * w2) + link1_turn_z_ddot * w5
    w9 = 2 * -link1_e2
    w10 = 2 * link1_e3
    w11 = 2 * link1_e0
    w12 = 2 * -link1_e1
    w13 = link1_e0_dot * w9 + link1_e1_dot * w10 + link1_e2_dot * w11 + link1_e3_dot * w12
    w14 = 2 * -link1_e3
    w15 = 2 * link1_e2
    w16 = link1_e0_dot * w12 + link1_e1_dot * w11 + link1_e2_dot * w14 + link1_e3_dot * w15
    w17 = 2 * link1_e1
    w18 = (link1_e2 * w17 + link1_e0 * w10) * link1_end_x
    w19 = (1.0 - (link1_e2 * w15 + link1_e3 * w10)) * link1_end_x
    w20 = w16 * w18 - w13 * w19
    w21 = link1_e0_dot * w14 + w9 * link1_e1_dot + link1_e2_dot * w17 + w11 * link1_e3_dot
    w22 = (link1_e3 * w17 - link1_e0 * w15) * link1_end_x
    w23 = w19 * w21 - w16 * w22
    w24 = w14 * w18
    w25 = w11 * w22
    w26 = w13 * w20 - w21 * w23 - w4 * (w9 * w22 - w24) + w6 * (w10 * w22 - w9 * w18) + w7 * (w25 - w17 * w18)
    w27 = w12 * w22
    w28 = w11 * w18
    w29 = w26 + w8 * (w27 - w28)
    w30 = w13 * w22 - w18 * w21
    w31 = w9 * w19
    w32 = w11 * w19
    w33 = w21 * w30 - w16 * w20 - w4 * (w14 * w19 - w27) + w6 * (w31 - w25) + w7 * (w17 * w19 - w14 * w22) + w8 * (w32 - w15 * w22)
    w34 = w16 * w23 - w13 * w30 - w4 * (w12 * w18 - w31) + w6 * (w28 - w10 * w19) + w7 * (w24 - w32) + w8 * (w15 * w18 - w12 * w19)
    w35 = (link2_omega_x**2 + link2_omega_y**2 + link2_omega_z**2) / 4.0
    w36 = link2_e1 * 0.5
    w37 = link2_e2 * 0.5
    w38 = link2_e3 * 0.5
    w39 = w35 * link2_e0 + w36 * link2_turn_x_ddot + w37 * link2_turn_y_ddot + w38 * link2_turn_z_ddot
    w40 = link2_e0 * 0.5
    w41 = link2_turn_x_ddot * w40 - w35 * link2_e1 - link2_turn_y_ddot * w38 + w37 * link2_turn_z_ddot
    w42 = link2_turn_x_ddot * w38 - w35 * link2_e2 + link2_turn_y_ddot * w40 - w36 * link2_turn_z_ddot
    w43 = w36 * link2_turn_y_ddot - (w35 * link2_e3 + link2_turn_x_ddot * w37) + link2_turn_z_ddot * w40
    w44 = 2 * -link2_e2
    w45 = 2 * link2_e3
    w46 = 2 * link2_e0
    w47 = 2 * -link2_e1
    w48 = link2_e0_dot * w44 + link2_e1_dot * w45 + link2_e2_dot * w46 + link2_e3_dot * w47
    w49 = 2 * -link2_e3
    w50 = 2 * link2_e2
    w51 = link2_e0_dot * w47 + link2_e1_dot * w46 + link2_e2_dot * w49 + link2_e3_dot * w50
    w52 = 2 * link2_e1
    w53 = (link2_e2 * w52 + link2_e0 * w45) * link2_end_x
    w54 = (1.0 - (link2_e2 * w50 + link2_e3 * w45)) * link2_end_x
    w55 = w51 * w53 - w48 * w54
    w56 = link2_e0_dot * w49 + w44 * link2_e1_dot + link2_e2_dot * w52 + w46 * link2_e3_dot
    w57 = (link2_e3 * w52 - link2_e0 * w50) * link2_end_x
    w58 = w54 * w56 - w51 * w57
    w59 = w49 * w53
    w60 = w46 * w57
    w61 = w29 + (w48 * w55 - w56 * w58) - w39 * (w44 * w57 - w59) + w41 * (w45 * w57 - w44 * w53) + w42 * (w60 - w52 * w53)
    w62 = w47 * w57
    w63 = w46 * w53
    w64 = w48 * w57 - w53 * w56
    w65 = w44 * w54
    w66 = w33 + (w56 * w64 - w51 * w55) - w39 * (w49 * w54 - w62) + w41 * (w65 - w60) + w42 * (w52 * w54 - w49 * w57)
    w67 = w46 * w54
    w68 = w34 + (w51 * w58 - w48 * w64) - w39 * (w47 * w53 - w65) + w41 * (w63 - w45 * w54) + w42 * (w59 - w67)
    w69 = (link3_omega_x**2 + link3_omega_y**2 + link3_omega_z**2) / 4.0
    w70 = link3_e1 * 0.5
    w71 = link3_e2 * 0.5
    w72 = link3_e3 * 0.5
    w73 = link3_e0 * 0.5
    # outputs
    q_d_ddot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        -w4,  # link1.e0
        w6,  # link1.e1
        w7,  # link1.e2
        w8,  # link1.e3
        w29,  # link2.x
        w33,  # link2.y
        w34,  # link2.z
        -w39,  # link2.e0
        w41,  # link2.e1
        w42,  # link2.e2
        w43,  # link2.e3
        w61 + w43 * (w62 - w63),  # link3.x
        w66 + w43 * (w67 - w50 * w57),  # link3.y
        w68 + w43 * (w50 * w53 - w47 * w54),  # link3.z
        -(w69 * link3_e0 + w70 * link3_turn_x_ddot + w71 * link3_turn_y_ddot + w72 * link3_turn_z_ddot),  # link3.e0
        link3_turn_x_ddot * w73 - w69 * link3_e1 - link3_turn_y_ddot * w72 + w71 * link3_turn_z_ddot,  # link3.e1
        link3_turn_x_ddot * w72 - w69 * link3_e2 + link3_turn_y_ddot * w73 - w70 * link3_turn_z_ddot,  # link3.e2
        w70 * link3_turn_y_ddot - (w69 * link3_e3 + link3_turn_x_ddot * w71) + link3_turn_z_ddot * w73,  # link3.e3
    )
    inputs, outputs = [q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 21) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 21) [mixed]: rates of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 12) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 12 x 21) [SI]: constraint Jacobian
    gives C_t (n_c = 12) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 12) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 12) [m/s^2, rad/s^2]: right-hand side at acceleration level
    247 operations.
    """
    q = ca.SX.sym("q", 21)
    q_dot = ca.SX.sym("q_dot", 21)
    c = ca.SX.sym("c", 62)
    link1_x = q[0]
    link1_y = q[1]
    link1_z = q[2]
    link1_e0 = q[3]
    link1_e1 = q[4]
    link1_e2 = q[5]
    link1_e3 = q[6]
    link2_x = q[7]
    link2_y = q[8]
    link2_z = q[9]
    link2_e0 = q[10]
    link2_e1 = q[11]
    link2_e2 = q[12]
    link2_e3 = q[13]
    link3_x = q[14]
    link3_y = q[15]
    link3_z = q[16]
    link3_e0 = q[17]
    link3_e1 = q[18]
    link3_e2 = q[19]
    link3_e3 = q[20]
    link1_e0_dot = q_dot[3]
    link1_e1_dot = q_dot[4]
    link1_e2_dot = q_dot[5]
    link1_e3_dot = q_dot[6]
    link2_e0_dot = q_dot[10]
    link2_e1_dot = q_dot[11]
    link2_e2_dot = q_dot[12]
    link2_e3_dot = q_dot[13]
    link3_e0_dot = q_dot[17]
    link3_e1_dot = q_dot[18]
    link3_e2_dot = q_dot[19]
    link3_e3_dot = q_dot[20]
    link1_end_x = c[1]
    link2_end_x = c[3]
    # intermediate terms (44)
    w0 = 2 * link1_e2
    w1 = 2 * link1_e3
    w2 = (1.0 - (link1_e2 * w0 + link1_e3 * w1)) * link1_end_x
    w3 = 2 * link1_e1
    w4 = (link1_e2 * w3 + w1 * link1_e0) * link1_end_x
    w5 = (link1_e3 * w3 - w0 * link1_e0) * link1_end_x
    w6 = 2 * link2_e2
    w7 = 2 * link2_e3
    w8 = (1.0 - (link2_e2 * w6 + link2_e3 * w7)) * link2_end_x
    w9 = 2 * link2_e1
    w10 = (link2_e2 * w9 + w7 * link2_e0) * link2_end_x
    w11 = (link2_e3 * w9 - w6 * link2_e0) * link2_end_x
    w12 = 2 * -link1_e2
    w13 = 2 * -link1_e3
    w14 = w4 * w13
    w15 = 2 * -link1_e1
    w16 = w5 * w15
    w17 = w2 * w12
    w18 = 2 * link1_e0
    w19 = w5 * w18
    w20 = w4 * w18
    w21 = w2 * w18
    w22 = 2 * -link2_e2
    w23 = 2 * -link2_e3
    w24 = w10 * w23
    w25 = 2 * -link2_e1
    w26 = w11 * w25
    w27 = w8 * w22
    w28 = 2 * link2_e0
    w29 = w11 * w28
    w30 = w10 * w28
    w31 = w8 * w28
    w32 = w12 * link1_e0_dot + w1 * link1_e1_dot + w18 * link1_e2_dot + w15 * link1_e3_dot
    w33 = w15 * link1_e0_dot + w18 * link1_e1_dot + w13 * link1_e2_dot + w0 * link1_e3_dot
    w34 = w4 * w33 - w2 * w32
    w35 = w13 * link1_e0_dot + w12 * link1_e1_dot + w3 * link1_e2_dot + w18 * link1_e3_dot
    w36 = w2 * w35 - w5 * w33
    w37 = w5 * w32 - w4 * w35
    w38 = w22 * link2_e0_dot + w7 * link2_e1_dot + w28 * link2_e2_dot + w25 * link2_e3_dot
    w39 = w25 * link2_e0_dot + w28 * link2_e1_dot + w23 * link2_e2_dot + w6 * link2_e3_dot
    w40 = w10 * w39 - w8 * w38
    w41 = w23 * link2_e0_dot + w22 * link2_e1_dot + w9 * link2_e2_dot + w28 * link2_e3_dot
    w42 = w8 * w41 - w11 * w39
    w43 = w11 * w38 - w10 * w41
    # outputs
    C = ca.vertcat(
        link1_x,  # joint1.x
        link1_y,  # joint1.y
        link1_z,  # joint1.z
        link2_x - (link1_x + w2),  # joint2.x
        link2_y - (link1_y + w4),  # joint2.y
        link2_z - (link1_z + w5),  # joint2.z
        link3_x - (link2_x + w8),  # joint3.x
        link3_y - (link2_y + w10),  # joint3.y
        link3_z - (link2_z + w11),  # joint3.z
        (link1_e0**2 + link1_e1**2 + link1_e2**2 + link1_e3**2 - 1.0) / 2.0,  # link1.norm
        (link2_e0**2 + link2_e1**2 + link2_e2**2 + link2_e3**2 - 1.0) / 2.0,  # link2.norm
        (link3_e0**2 + link3_e1**2 + link3_e2**2 + link3_e3**2 - 1.0) / 2.0,  # link3.norm
    )
    C_q = ca.SX(12, 21)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # joint1.z
    C_q[2, 2] = 1.0
    # joint2.x
    C_q[3, 0] = -1.0
    C_q[3, 3] = w14 - w5 * w12
    C_q[3, 4] = w4 * w12 - w1 * w5
    C_q[3, 5] = w3 * w4 - w19
    C_q[3, 6] = w20 - w16
    C_q[3, 7] = 1.0
    # joint2.y
    C_q[4, 1] = -1.0
    C_q[4, 3] = w16 - w2 * w13
    C_q[4, 4] = w19 - w17
    C_q[4, 5] = w5 * w13 - w2 * w3
    C_q[4, 6] = w0 * w5 - w21
    C_q[4, 8] = 1.0
    # joint2.z
    C_q[5, 2] = -1.0
    C_q[5, 3] = w17 - w4 * w15
    C_q[5, 4] = w1 * w2 - w20
    C_q[5, 5] = w21 - w14
    C_q[5, 6] = w2 * w15 - w0 * w4
    C_q[5, 9] = 1.0
    # joint3.x
    C_q[6, 7] = -1.0
    C_q[6, 10] = w24 - w11 * w22
    C_q[6, 11] = w10 * w22 - w7 * w11
    C_q[6, 12] = w9 * w10 - w29
    C_q[6, 13] = w30 - w26
    C_q[6, 14] = 1.0
    # joint3.y
    C_q[7, 8] = -1.0
    C_q[7, 10] = w26 - w8 * w23
    C_q[7, 11] = w29 - w27
    C_q[7, 12] = w11 * w23 - w8 * w9
    C_q[7, 13] = w6 * w11 - w31
    C_q[7, 15] = 1.0
    # joint3.z
    C_q[8, 9] = -1.0
    C_q[8, 10] = w27 - w10 * w25
    C_q[8, 11] = w7 * w8 - w30
    C_q[8, 12] = w31 - w24
    C_q[8, 13] = w8 * w25 - w6 * w10
    C_q[8, 16] = 1.0
    # link1.norm
    C_q[9, 3] = link1_e0
    C_q[9, 4] = link1_e1
    C_q[9, 5] = link1_e2
    C_q[9, 6] = link1_e3
    # link2.norm
    C_q[10, 10] = link2_e0
    C_q[10, 11] = link2_e1
    C_q[10, 12] = link2_e2
    C_q[10, 13] = link2_e3
    # link3.norm
    C_q[11, 17] = link3_e0
    C_q[11, 18] = link3_e1
    C_q[11, 19] = link3_e2
    C_q[11, 20] = link3_e3
    C_t = ca.SX(12, 1)
    nu = ca.SX(12, 1)
    gamma = ca.vertcat(
        0.0,  # joint1.x
        0.0,  # joint1.y
        0.0,  # joint1.z
        w32 * w34 - w35 * w36,  # joint2.x
        w35 * w37 - w33 * w34,  # joint2.y
        w33 * w36 - w32 * w37,  # joint2.z
        w38 * w40 - w41 * w42,  # joint3.x
        w41 * w43 - w39 * w40,  # joint3.y
        w39 * w42 - w38 * w43,  # joint3.z
        -(link1_e0_dot**2 + link1_e1_dot**2 + link1_e2_dot**2 + link1_e3_dot**2),  # link1.norm
        -(link2_e0_dot**2 + link2_e1_dot**2 + link2_e2_dot**2 + link2_e3_dot**2),  # link2.norm
        -(link3_e0_dot**2 + link3_e1_dot**2 + link3_e2_dot**2 + link3_e3_dot**2),  # link3.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 21) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 21) [mixed]: rates of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 21 x 21) [SI]: mass matrix in all coordinates
    gives K (n x n = 21 x 21) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 21) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 21) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 21) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 12 x 21) [SI]: constraint Jacobian
    gives gamma (n_c = 12) [m/s^2, rad/s^2]: right-hand side at acceleration level
    766 operations.
    """
    q = ca.SX.sym("q", 21)
    q_dot = ca.SX.sym("q_dot", 21)
    c = ca.SX.sym("c", 62)
    link1_e0 = q[3]
    link1_e1 = q[4]
    link1_e2 = q[5]
    link1_e3 = q[6]
    link2_e0 = q[10]
    link2_e1 = q[11]
    link2_e2 = q[12]
    link2_e3 = q[13]
    link3_e0 = q[17]
    link3_e1 = q[18]
    link3_e2 = q[19]
    link3_e3 = q[20]
    link1_e0_dot = q_dot[3]
    link1_e1_dot = q_dot[4]
    link1_e2_dot = q_dot[5]
    link1_e3_dot = q_dot[6]
    link2_e0_dot = q_dot[10]
    link2_e1_dot = q_dot[11]
    link2_e2_dot = q_dot[12]
    link2_e3_dot = q_dot[13]
    link3_e0_dot = q_dot[17]
    link3_e1_dot = q_dot[18]
    link3_e2_dot = q_dot[19]
    link3_e3_dot = q_dot[20]
    c0 = c[0]
    link1_end_x = c[1]
    link2_end_x = c[3]
    c5 = c[5]
    c7 = c[7]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    gravity_z = c[14]
    c24 = c[24]
    c25 = c[25]
    link1_mass = c[26]
    c27 = c[27]
    link2_mass = c[28]
    link3_mass = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
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
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    # intermediate terms (271)
    w0 = 2 * -link1_e2
    w1 = 2 * link1_e1
    w2 = w1 * link1_e3
    w3 = 2 * link1_e2
    w4 = w3 * link1_e0
    w5 = w2 - w4
    w6 = w5 * c37
    w7 = 2 * -link1_e3
    w8 = link1_e2 * w1
    w9 = 2 * link1_e3
    w10 = link1_e0 * w9
    w11 = w8 + w10
    w12 = w11 * c37
    w13 = w7 * w12
    w14 = w0 * w6 - w13
    w15 = w6 * w9 - w0 * w12
    w16 = 2 * link1_e0
    w17 = w6 * w16
    w18 = w17 - w1 * w12
    w19 = 2 * -link1_e1
    w20 = w6 * w19
    w21 = w12 * w16
    w22 = w20 - w21
    w23 = link1_e2 * w3
    w24 = link1_e3 * w9
    w25 = 1.0 - (w23 + w24)
    w26 = w25 * c37
    w27 = w7 * w26 - w20
    w28 = w0 * w26
    w29 = w28 - w17
    w30 = w1 * w26 - w6 * w7
    w31 = w16 * w26
    w32 = w31 - w3 * w6
    w33 = w12 * w19 - w28
    w34 = w21 - w9 * w26
    w35 = w13 - w31
    w36 = w3 * w12 - w19 * w26
    w37 = w16 * c0
    w38 = w19 * w37 + link1_e2 * link1_e3 * c40
    w39 = w16 * c38
    w40 = w19 * c39
    w41 = w0 * w39 + link1_e1 * link1_e3 * c41
    w42 = w0 * c0
    w43 = w1 * c38
    w44 = w16 * c39
    w45 = link1_e2 * link1_e1 * c42 + w7 * w44
    w46 = link1_e3 * link1_e0 * c42 + w3 * w40
    w47 = w7 * w43 + link1_e2 * link1_e0 * c41
    w48 = w9 * w42 + link1_e1 * link1_e0 * c40
    w49 = 2 * -link2_e2
    w50 = 2 * link2_e1
    w51 = w50 * link2_e3
    w52 = 2 * link2_e2
    w53 = w52 * link2_e0
    w54 = w51 - w53
    w55 = w54 * c30
    w56 = 2 * -link2_e3
    w57 = link2_e2 * w50
    w58 = 2 * link2_e3
    w59 = link2_e0 * w58
    w60 = w57 + w59
    w61 = w60 * c30
    w62 = w56 * w61
    w63 = w49 * w55 - w62
    w64 = w55 * w58 - w49 * w61
    w65 = 2 * link2_e0
    w66 = w55 * w65
    w67 = w66 - w50 * w61
    w68 = 2 * -link2_e1
    w69 = w55 * w68
    w70 = w61 * w65
    w71 = w69 - w70
    w72 = link2_e2 * w52
    w73 = link2_e3 * w58
    w74 = 1.0 - (w72 + w73)
    w75 = w74 * c30
    w76 = w56 * w75 - w69
    w77 = w49 * w75
    w78 = w77 - w66
    w79 = w50 * w75 - w55 * w56
    w80 = w65 * w75
    w81 = w80 - w52 * w55
    w82 = w61 * w68 - w77
    w83 = w70 - w58 * w75
    w84 = w62 - w80
    w85 = w52 * w61 - w68 * w75
    w86 = w65 * c7
    w87 = w68 * w86 + link2_e2 * link2_e3 * c45
    w88 = w65 * c43
    w89 = w68 * c44
    w90 = w49 * w88 + link2_e1 * link2_e3 * c46
    w91 = w49 * c7
    w92 = w50 * c43
    w93 = w65 * c44
    w94 = link2_e2 * link2_e1 * c47 + w56 * w93
    w95 = link2_e3 * link2_e0 * c47 + w52 * w89
    w96 = w56 * w92 + link2_e2 * link2_e0 * c46
    w97 = w58 * w91 + link2_e1 * link2_e0 * c45
    w98 = 2 * -link3_e2
    w99 = 2 * link3_e1
    w100 = w99 * link3_e3
    w101 = 2 * link3_e2
    w102 = w101 * link3_e0
    w103 = w100 - w102
    w104 = w103 * c5
    w105 = 2 * -link3_e3
    w106 = link3_e2 * w99
    w107 = 2 * link3_e3
    w108 = link3_e0 * w107
    w109 = w106 + w108
    w110 = w109 * c5
    w111 = w105 * w110
    w112 = w98 * w104 - w111
    w113 = w104 * w107 - w98 * w110
    w114 = 2 * link3_e0
    w115 = w104 * w114
    w116 = w115 - w99 * w110
    w117 = 2 * -link3_e1
    w118 = w104 * w117
    w119 = w110 * w114
    w120 = w118 - w119
    w121 = link3_e2 * w101
    w122 = link3_e3 * w107
    w123 = 1.0 - (w121 + w122)
    w124 = w123 * c5
    w125 = w105 * w124 - w118
    w126 = w98 * w124
    w127 = w126 - w115
    w128 = w99 * w124 - w104 * w105
    w129 = w114 * w124
    w130 = w129 - w101 * w104
    w131 = w110 * w117 - w126
    w132 = w119 - w107 * w124
    w133 = w111 - w129
    w134 = w101 * w110 - w117 * w124
    w135 = w114 * c10
    w136 = w117 * w135 + link3_e2 * link3_e3 * c48
    w137 = w114 * c11
    w138 = w117 * c12
    w139 = w98 * w137 + link3_e1 * link3_e3 * c49
    w140 = w98 * c10
    w141 = w99 * c11
    w142 = w114 * c12
    w143 = link3_e2 * link3_e1 * c50 + w105 * w142
    w144 = link3_e3 * link3_e0 * c50 + w101 * w138
    w145 = w105 * w141 + link3_e2 * link3_e0 * c49
    w146 = w107 * w140 + link3_e1 * link3_e0 * c48
    w147 = w7 * link1_e0_dot
    w148 = w16 * link1_e3_dot
    w149 = w147 + w3 * link1_e1_dot + w19 * link1_e2_dot + w148
    w150 = w149 * c37
    w151 = w0 * link1_e0_dot
    w152 = w16 * link1_e2_dot
    w153 = w151 + w7 * link1_e1_dot + w152 + w1 * link1_e3_dot
    w154 = w153 * c37
    w155 = w149 * w150 + w153 * w154
    w156 = w19 * link1_e0_dot + w16 * link1_e1_dot
    w157 = w156 + w9 * link1_e2_dot + w0 * link1_e3_dot
    w158 = w154 * w157
    w159 = w150 * w157
    w160 = w25 * w155 - (w8 - w10) * w158 - (w2 + w4) * w159
    w161 = link1_e1 * w1
    w162 = link1_e3 * w3
    w163 = w1 * link1_e0
    w164 = w11 * w155 - w158 * (1.0 - (w24 + w161)) - w159 * (w162 - w163)
    w165 = w5 * w155 - w158 * (w162 + w163) - w159 * (1.0 - (w23 + w161))
    w166 = w149 * c25
    w167 = w153 * c24
    w168 = w153 * w166 - w149 * w167
    w169 = w157 * c27
    w170 = w149 * w169 - w157 * w166
    w171 = w157 * w167 - w153 * w169
    w172 = w19 * w168 + w0 * w170 + w7 * w171
    w173 = w16 * w168 + w7 * w170 + w3 * w171
    w174 = w9 * w168 + w16 * w170 + w19 * w171
    w175 = w0 * w168 + w1 * w170 + w16 * w171
    w176 = w56 * link2_e0_dot
    w177 = w65 * link2_e3_dot
    w178 = w176 + w52 * link2_e1_dot + w68 * link2_e2_dot + w177
    w179 = w178 * c30
    w180 = w49 * link2_e0_dot
    w181 = w65 * link2_e2_dot
    w182 = w180 + w56 * link2_e1_dot + w181 + w50 * link2_e3_dot
    w183 = w182 * c30
    w184 = w178 * w179 + w182 * w183
    w185 = w68 * link2_e0_dot + w65 * link2_e1_dot
    w186 = w185 + w58 * link2_e2_dot + w49 * link2_e3_dot
    w187 = w183 * w186
    w188 = w179 * w186
    w189 = w74 * w184 - (w57 - w59) * w187 - (w51 + w53) * w188
    w190 = link2_e1 * w50
    w191 = link2_e3 * w52
    w192 = w50 * link2_e0
    w193 = w60 * w184 - w187 * (1.0 - (w73 + w190)) - w188 * (w191 - w192)
    w194 = w54 * w184 - w187 * (w191 + w192) - w188 * (1.0 - (w72 + w190))
    w195 = w178 * c32
    w196 = w182 * c31
    w197 = w182 * w195 - w178 * w196
    w198 = w186 * c33
    w199 = w178 * w198 - w186 * w195
    w200 = w186 * w196 - w182 * w198
    w201 = w68 * w197 + w49 * w199 + w56 * w200
    w202 = w65 * w197 + w56 * w199 + w52 * w200
    w203 = w58 * w197 + w65 * w199 + w68 * w200
    w204 = w49 * w197 + w50 * w199 + w65 * w200
    w205 = w105 * link3_e0_dot + w101 * link3_e1_dot + w117 * link3_e2_dot + w114 * link3_e3_dot
    w206 = w205 * c5
    w207 = w98 * link3_e0_dot + w105 * link3_e1_dot + w114 * link3_e2_dot + w99 * link3_e3_dot
    w208 = w207 * c5
    w209 = w205 * w206 + w207 * w208
    w210 = w117 * link3_e0_dot + w114 * link3_e1_dot + w107 * link3_e2_dot + w98 * link3_e3_dot
    w211 = w208 * w210
    w212 = w206 * w210
    w213 = w123 * w209 - (w106 - w108) * w211 - (w100 + w102) * w212
    w214 = link3_e1 * w99
    w215 = link3_e3 * w101
    w216 = w99 * link3_e0
    w217 = w109 * w209 - w211 * (1.0 - (w122 + w214)) - w212 * (w215 - w216)
    w218 = w103 * w209 - w211 * (w215 + w216) - w212 * (1.0 - (w121 + w214))
    w219 = w205 * c35
    w220 = w207 * c34
    w221 = w207 * w219 - w205 * w220
    w222 = w210 * c36
    w223 = w205 * w222 - w210 * w219
    w224 = w210 * w220 - w207 * w222
    w225 = w117 * w221 + w98 * w223 + w105 * w224
    w226 = w114 * w221 + w105 * w223 + w101 * w224
    w227 = w107 * w221 + w114 * w223 + w117 * w224
    w228 = w98 * w221 + w99 * w223 + w114 * w224
    w229 = w33 * gravity_z
    w230 = w34 * gravity_z
    w231 = w35 * gravity_z
    w232 = w36 * gravity_z
    w233 = w82 * gravity_z
    w234 = w83 * gravity_z
    w235 = w84 * gravity_z
    w236 = w85 * gravity_z
    w237 = w131 * gravity_z
    w238 = w132 * gravity_z
    w239 = w133 * gravity_z
    w240 = w134 * gravity_z
    w241 = w5 * link1_end_x
    w242 = w11 * link1_end_x
    w243 = w7 * w242
    w244 = w25 * link1_end_x
    w245 = w19 * w241
    w246 = w0 * w244
    w247 = w16 * w241
    w248 = w16 * w242
    w249 = w16 * w244
    w250 = w54 * link2_end_x
    w251 = w60 * link2_end_x
    w252 = w56 * w251
    w253 = w74 * link2_end_x
    w254 = w68 * w250
    w255 = w49 * w253
    w256 = w65 * w250
    w257 = w65 * w251
    w258 = w65 * w253
    w259 = w152 + (w151 + w9 * link1_e1_dot) + w19 * link1_e3_dot
    w260 = w156 + w7 * link1_e2_dot + w3 * link1_e3_dot
    w261 = w242 * w260 - w244 * w259
    w262 = w148 + (w147 + w0 * link1_e1_dot + w1 * link1_e2_dot)
    w263 = w244 * w262 - w241 * w260
    w264 = w241 * w259 - w242 * w262
    w265 = w181 + (w180 + w58 * link2_e1_dot) + w68 * link2_e3_dot
    w266 = w185 + w56 * link2_e2_dot + w52 * link2_e3_dot
    w267 = w251 * w266 - w253 * w265
    w268 = w177 + (w176 + w49 * link2_e1_dot + w50 * link2_e2_dot)
    w269 = w253 * w268 - w250 * w266
    w270 = w250 * w265 - w251 * w268
    # outputs
    M = ca.SX(21, 21)
    # link1.x
    M[0, 0] = link1_mass
    M[0, 3] = w14
    M[0, 4] = w15
    M[0, 5] = w18
    M[0, 6] = w22
    # link1.y
    M[1, 1] = link1_mass
    M[1, 3] = w27
    M[1, 4] = w29
    M[1, 5] = w30
    M[1, 6] = w32
    # link1.z
    M[2, 2] = link1_mass
    M[2, 3] = w33
    M[2, 4] = w34
    M[2, 5] = w35
    M[2, 6] = w36
    # link1.e0
    M[3, 0] = w14
    M[3, 1] = w27
    M[3, 2] = w33
    M[3, 3] = w19 * (w19 * c0) + w0 * (w0 * c38) + w7 * (w7 * c39)
    M[3, 4] = w38
    M[3, 5] = w41
    M[3, 6] = w45
    # link1.e1
    M[4, 0] = w15
    M[4, 1] = w29
    M[4, 2] = w34
    M[4, 3] = w38
    M[4, 4] = w16 * w37 + w7 * (w7 * c38) + w3 * (w3 * c39)
    M[4, 5] = w46
    M[4, 6] = w47
    # link1.e2
    M[5, 0] = w18
    M[5, 1] = w30
    M[5, 2] = w35
    M[5, 3] = w41
    M[5, 4] = w46
    M[5, 5] = w9 * (w9 * c0) + w16 * w39 + w19 * w40
    M[5, 6] = w48
    # link1.e3
    M[6, 0] = w22
    M[6, 1] = w32
    M[6, 2] = w36
    M[6, 3] = w45
    M[6, 4] = w47
    M[6, 5] = w48
    M[6, 6] = w0 * w42 + w1 * w43 + w16 * w44
    # link2.x
    M[7, 7] = link2_mass
    M[7, 10] = w63
    M[7, 11] = w64
    M[7, 12] = w67
    M[7, 13] = w71
    # link2.y
    M[8, 8] = link2_mass
    M[8, 10] = w76
    M[8, 11] = w78
    M[8, 12] = w79
    M[8, 13] = w81
    # link2.z
    M[9, 9] = link2_mass
    M[9, 10] = w82
    M[9, 11] = w83
    M[9, 12] = w84
    M[9, 13] = w85
    # link2.e0
    M[10, 7] = w63
    M[10, 8] = w76
    M[10, 9] = w82
    M[10, 10] = w68 * (w68 * c7) + w49 * (w49 * c43) + w56 * (w56 * c44)
    M[10, 11] = w87
    M[10, 12] = w90
    M[10, 13] = w94
    # link2.e1
    M[11, 7] = w64
    M[11, 8] = w78
    M[11, 9] = w83
    M[11, 10] = w87
    M[11, 11] = w65 * w86 + w56 * (w56 * c43) + w52 * (w52 * c44)
    M[11, 12] = w95
    M[11, 13] = w96
    # link2.e2
    M[12, 7] = w67
    M[12, 8] = w79
    M[12, 9] = w84
    M[12, 10] = w90
    M[12, 11] = w95
    M[12, 12] = w58 * (w58 * c7) + w65 * w88 + w68 * w89
    M[12, 13] = w97
    # link2.e3
    M[13, 7] = w71
    M[13, 8] = w81
    M[13, 9] = w85
    M[13, 10] = w94
    M[13, 11] = w96
    M[13, 12] = w97
    M[13, 13] = w49 * w91 + w50 * w92 + w65 * w93
    # link3.x
    M[14, 14] = link3_mass
    M[14, 17] = w112
    M[14, 18] = w113
    M[14, 19] = w116
    M[14, 20] = w120
    # link3.y
    M[15, 15] = link3_mass
    M[15, 17] = w125
    M[15, 18] = w127
    M[15, 19] = w128
    M[15, 20] = w130
    # link3.z
    M[16, 16] = link3_mass
    M[16, 17] = w131
    M[16, 18] = w132
    M[16, 19] = w133
    M[16, 20] = w134
    # link3.e0
    M[17, 14] = w112
    M[17, 15] = w125
    M[17, 16] = w131
    M[17, 17] = w117 * (w117 * c10) + w98 * (w98 * c11) + w105 * (w105 * c12)
    M[17, 18] = w136
    M[17, 19] = w139
    M[17, 20] = w143
    # link3.e1
    M[18, 14] = w113
    M[18, 15] = w127
    M[18, 16] = w132
    M[18, 17] = w136
    M[18, 18] = w114 * w135 + w105 * (w105 * c11) + w101 * (w101 * c12)
    M[18, 19] = w144
    M[18, 20] = w145
    # link3.e2
    M[19, 14] = w116
    M[19, 15] = w128
    M[19, 16] = w133
    M[19, 17] = w139
    M[19, 18] = w144
    M[19, 19] = w107 * (w107 * c10) + w114 * w137 + w117 * w138
    M[19, 20] = w146
    # link3.e3
    M[20, 14] = w120
    M[20, 15] = w130
    M[20, 16] = w134
    M[20, 17] = w143
    M[20, 18] = w145
    M[20, 19] = w146
    M[20, 20] = w98 * w140 + w99 * w141 + w114 * w142
    K = ca.SX(21, 21)
    Q_v = ca.vertcat(
        w160,  # link1.x
        w164,  # link1.y
        w165,  # link1.z
        w172,  # link1.e0
        w173,  # link1.e1
        w174,  # link1.e2
        w175,  # link1.e3
        w189,  # link2.x
        w193,  # link2.y
        w194,  # link2.z
        w201,  # link2.e0
        w202,  # link2.e1
        w203,  # link2.e2
        w204,  # link2.e3
        w213,  # link3.x
        w217,  # link3.y
        w218,  # link3.z
        w225,  # link3.e0
        w226,  # link3.e1
        w227,  # link3.e2
        w228,  # link3.e3
    )
    Q_F = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        c51,  # link1.z
        w229,  # link1.e0
        w230,  # link1.e1
        w231,  # link1.e2
        w232,  # link1.e3
        0.0,  # link2.x
        0.0,  # link2.y
        c52,  # link2.z
        w233,  # link2.e0
        w234,  # link2.e1
        w235,  # link2.e2
        w236,  # link2.e3
        0.0,  # link3.x
        0.0,  # link3.y
        c53,  # link3.z
        w237,  # link3.e0
        w238,  # link3.e1
        w239,  # link3.e2
        w240,  # link3.e3
    )
    Q_star = ca.vertcat(
        w160,  # link1.x
        w164,  # link1.y
        w165 + c51,  # link1.z
        w172 + w229,  # link1.e0
        w173 + w230,  # link1.e1
        w174 + w231,  # link1.e2
        w175 + w232,  # link1.e3
        w189,  # link2.x
        w193,  # link2.y
        w194 + c52,  # link2.z
        w201 + w233,  # link2.e0
        w202 + w234,  # link2.e1
        w203 + w235,  # link2.e2
        w204 + w236,  # link2.e3
        w213,  # link3.x
        w217,  # link3.y
        w218 + c53,  # link3.z
        w225 + w237,  # link3.e0
        w226 + w238,  # link3.e1
        w227 + w239,  # link3.e2
        w228 + w240,  # link3.e3
    )
    C_q = ca.SX(12, 21)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # joint1.z
    C_q[2, 2] = 1.0
    # joint2.x
    C_q[3, 0] = -1.0
    C_q[3, 3] = w243 - w0 * w241
    C_q[3, 4] = w0 * w242 - w9 * w241
    C_q[3, 5] = w1 * w242 - w247
    C_q[3, 6] = w248 - w245
    C_q[3, 7] = 1.0
    # joint2.y
    C_q[4, 1] = -1.0
    C_q[4, 3] = w245 - w7 * w244
    C_q[4, 4] = w247 - w246
    C_q[4, 5] = w7 * w241 - w1 * w244
    C_q[4, 6] = w3 * w241 - w249
    C_q[4, 8] = 1.0
    # joint2.z
    C_q[5, 2] = -1.0
    C_q[5, 3] = w246 - w19 * w242
    C_q[5, 4] = w9 * w244 - w248
    C_q[5, 5] = w249 - w243
    C_q[5, 6] = w19 * w244 - w3 * w242
    C_q[5, 9] = 1.0
    # joint3.x
    C_q[6, 7] = -1.0
    C_q[6, 10] = w252 - w49 * w250
    C_q[6, 11] = w49 * w251 - w58 * w250
    C_q[6, 12] = w50 * w251 - w256
    C_q[6, 13] = w257 - w254
    C_q[6, 14] = 1.0
    # joint3.y
    C_q[7, 8] = -1.0
    C_q[7, 10] = w254 - w56 * w253
    C_q[7, 11] = w256 - w255
    C_q[7, 12] = w56 * w250 - w50 * w253
    C_q[7, 13] = w52 * w250 - w258
    C_q[7, 15] = 1.0
    # joint3.z
    C_q[8, 9] = -1.0
    C_q[8, 10] = w255 - w68 * w251
    C_q[8, 11] = w58 * w253 - w257
    C_q[8, 12] = w258 - w252
    C_q[8, 13] = w68 * w253 - w52 * w251
    C_q[8, 16] = 1.0
    # link1.norm
    C_q[9, 3] = link1_e0
    C_q[9, 4] = link1_e1
    C_q[9, 5] = link1_e2
    C_q[9, 6] = link1_e3
    # link2.norm
    C_q[10, 10] = link2_e0
    C_q[10, 11] = link2_e1
    C_q[10, 12] = link2_e2
    C_q[10, 13] = link2_e3
    # link3.norm
    C_q[11, 17] = link3_e0
    C_q[11, 18] = link3_e1
    C_q[11, 19] = link3_e2
    C_q[11, 20] = link3_e3
    gamma = ca.vertcat(
        0.0,  # joint1.x
        0.0,  # joint1.y
        0.0,  # joint1.z
        w259 * w261 - w262 * w263,  # joint2.x
        w262 * w264 - w260 * w261,  # joint2.y
        w260 * w263 - w259 * w264,  # joint2.z
        w265 * w267 - w268 * w269,  # joint3.x
        w268 * w270 - w266 * w267,  # joint3.y
        w266 * w269 - w265 * w270,  # joint3.z
        -(link1_e0_dot**2 + link1_e1_dot**2 + link1_e2_dot**2 + link1_e3_dot**2),  # link1.norm
        -(link2_e0_dot**2 + link2_e1_dot**2 + link2_e2_dot**2 + link2_e3_dot**2),  # link2.norm
        -(link3_e0_dot**2 + link3_e1_dot**2 + link3_e2_dot**2 + link3_e3_dot**2),  # link3.norm
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 21) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 21) [mixed]: rates of all coordinates
    takes q_ddot (n = 21) [mixed]: accelerations of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 12) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 3) [N, N m]: world force and moment of a joint on its body b, at b
    1020 operations.
    """
    q = ca.SX.sym("q", 21)
    q_dot = ca.SX.sym("q_dot", 21)
    q_ddot = ca.SX.sym("q_ddot", 21)
    c = ca.SX.sym("c", 62)
    link1_e0 = q[3]
    link1_e1 = q[4]
    link1_e2 = q[5]
    link1_e3 = q[6]
    link2_e0 = q[10]
    link2_e1 = q[11]
    link2_e2 = q[12]
    link2_e3 = q[13]
    link3_e0 = q[17]
    link3_e1 = q[18]
    link3_e2 = q[19]
    link3_e3 = q[20]
    link1_e0_dot = q_dot[3]
    link1_e1_dot = q_dot[4]
    link1_e2_dot = q_dot[5]
    link1_e3_dot = q_dot[6]
    link2_e0_dot = q_dot[10]
    link2_e1_dot = q_dot[11]
    link2_e2_dot = q_dot[12]
    link2_e3_dot = q_dot[13]
    link3_e0_dot = q_dot[17]
    link3_e1_dot = q_dot[18]
    link3_e2_dot = q_dot[19]
    link3_e3_dot = q_dot[20]
    link1_x_ddot = q_ddot[0]
    link1_y_ddot = q_ddot[1]
    link1_z_ddot = q_ddot[2]
    link1_e0_ddot = q_ddot[3]
    link1_e1_ddot = q_ddot[4]
    link1_e2_ddot = q_ddot[5]
    link1_e3_ddot = q_ddot[6]
    link2_x_ddot = q_ddot[7]
    link2_y_ddot = q_ddot[8]
    link2_z_ddot = q_ddot[9]
    link2_e0_ddot = q_ddot[10]
    link2_e1_ddot = q_ddot[11]
    link2_e2_ddot = q_ddot[12]
    link2_e3_ddot = q_ddot[13]
    link3_x_ddot = q_ddot[14]
    link3_y_ddot = q_ddot[15]
    link3_z_ddot = q_ddot[16]
    link3_e0_ddot = q_ddot[17]
    link3_e1_ddot = q_ddot[18]
    link3_e2_ddot = q_ddot[19]
    link3_e3_ddot = q_ddot[20]
    c0 = c[0]
    link1_end_x = c[1]
    link2_end_x = c[3]
    c5 = c[5]
    c7 = c[7]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    gravity_z = c[14]
    c24 = c[24]
    c25 = c[25]
    link1_mass = c[26]
    c27 = c[27]
    link2_mass = c[28]
    link3_mass = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
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
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    # intermediate terms (266)
    w0 = 2 * link1_e2
    w1 = link1_e2 * w0
    w2 = 2 * link1_e3
    w3 = link1_e3 * w2
    w4 = 1.0 - (w1 + w3)
    w5 = 2 * -link1_e3
    w6 = 2 * -link1_e1
    w7 = 2 * link1_e0
    w8 = link1_e0_dot * w5 + w0 * link1_e1_dot + link1_e2_dot * w6 + link1_e3_dot * w7
    w9 = w8 * c37
    w10 = 2 * -link1_e2
    w11 = 2 * link1_e1
    w12 = link1_e0_dot * w10 + w5 * link1_e1_dot + link1_e2_dot * w7 + link1_e3_dot * w11
    w13 = w12 * c37
    w14 = w8 * w9 + w12 * w13
    w15 = link1_e2 * w11
    w16 = w2 * link1_e0
    w17 = link1_e0_dot * w6 + link1_e1_dot * w7 + w2 * link1_e2_dot + link1_e3_dot * w10
    w18 = w13 * w17
    w19 = link1_e3 * w11
    w20 = w0 * link1_e0
    w21 = w9 * w17
    w22 = w19 - w20
    w23 = w22 * c37
    w24 = w15 + w16
    w25 = w24 * c37
    w26 = w5 * w25
    w27 = w10 * w23 - w26
    w28 = w2 * w23 - w10 * w25
    w29 = w7 * w23
    w30 = w29 - w11 * w25
    w31 = w6 * w23
    w32 = w7 * w25
    w33 = w31 - w32
    w34 = link1_x_ddot * link1_mass + w27 * link1_e0_ddot + w28 * link1_e1_ddot + w30 * link1_e2_ddot + w33 * link1_e3_ddot
    w35 = 2 * link2_e2
    w36 = link2_e2 * w35
    w37 = 2 * link2_e3
    w38 = link2_e3 * w37
    w39 = 1.0 - (w36 + w38)
    w40 = 2 * -link2_e3
    w41 = 2 * -link2_e1
    w42 = 2 * link2_e0
    w43 = link2_e0_dot * w40 + w35 * link2_e1_dot + link2_e2_dot * w41 + link2_e3_dot * w42
    w44 = w43 * c30
    w45 = 2 * -link2_e2
    w46 = 2 * link2_e1
    w47 = link2_e0_dot * w45 + w40 * link2_e1_dot + link2_e2_dot * w42 + link2_e3_dot * w46
    w48 = w47 * c30
    w49 = w43 * w44 + w47 * w48
    w50 = link2_e2 * w46
    w51 = w37 * link2_e0
    w52 = link2_e0_dot * w41 + link2_e1_dot * w42 + w37 * link2_e2_dot + link2_e3_dot * w45
    w53 = w48 * w52
    w54 = link2_e3 * w46
    w55 = w35 * link2_e0
    w56 = w44 * w52
    w57 = w54 - w55
    w58 = w57 * c30
    w59 = w50 + w51
    w60 = w59 * c30
    w61 = w40 * w60
    w62 = w45 * w58 - w61
    w63 = w37 * w58 - w45 * w60
    w64 = w42 * w58
    w65 = w64 - w46 * w60
    w66 = w41 * w58
    w67 = w42 * w60
    w68 = w66 - w67
    w69 = link2_x_ddot * link2_mass + w62 * link2_e0_ddot + w63 * link2_e1_ddot + w65 * link2_e2_ddot + w68 * link2_e3_ddot
    w70 = 2 * link3_e2
    w71 = link3_e2 * w70
    w72 = 2 * link3_e3
    w73 = link3_e3 * w72
    w74 = 1.0 - (w71 + w73)
    w75 = 2 * -link3_e3
    w76 = 2 * -link3_e1
    w77 = 2 * link3_e0
    w78 = link3_e0_dot * w75 + w70 * link3_e1_dot + link3_e2_dot * w76 + link3_e3_dot * w77
    w79 = w78 * c5
    w80 = 2 * -link3_e2
    w81 = 2 * link3_e1
    w82 = link3_e0_dot * w80 + w75 * link3_e1_dot + link3_e2_dot * w77 + link3_e3_dot * w81
    w83 = w82 * c5
    w84 = w78 * w79 + w82 * w83
    w85 = link3_e2 * w81
    w86 = w72 * link3_e0
    w87 = link3_e0_dot * w76 + link3_e1_dot * w77 + w72 * link3_e2_dot + link3_e3_dot * w80
    w88 = w83 * w87
    w89 = link3_e3 * w81
    w90 = w70 * link3_e0
    w91 = w79 * w87
    w92 = w89 - w90
    w93 = w92 * c5
    w94 = w85 + w86
    w95 = w94 * c5
    w96 = w75 * w95
    w97 = w80 * w93 - w96
    w98 = w72 * w93 - w80 * w95
    w99 = w77 * w93
    w100 = w99 - w81 * w95
    w101 = w76 * w93
    w102 = w77 * w95
    w103 = w101 - w102
    w104 = link3_x_ddot * link3_mass + w97 * link3_e0_ddot + w98 * link3_e1_ddot + w100 * link3_e2_ddot + w103 * link3_e3_ddot
    w105 = w74 * w84 - (w85 - w86) * w88 - (w89 + w90) * w91 - w104
    w106 = w39 * w49 - (w50 - w51) * w53 - (w54 + w55) * w56 - w69 + w105
    w107 = w4 * w14 - (w15 - w16) * w18 - (w19 + w20) * w21 - w34 + w106
    w108 = link1_e1 * w11
    w109 = w0 * link1_e3
    w110 = link1_e0 * w11
    w111 = w4 * c37
    w112 = w5 * w111 - w31
    w113 = w10 * w111
    w114 = w113 - w29
    w115 = w11 * w111 - w5 * w23
    w116 = w7 * w111
    w117 = w116 - w0 * w23
    w118 = link1_y_ddot * link1_mass + link1_e0_ddot * w112 + link1_e1_ddot * w114 + link1_e2_ddot * w115 + link1_e3_ddot * w117
    w119 = link2_e1 * w46
    w120 = w35 * link2_e3
    w121 = link2_e0 * w46
    w122 = w39 * c30
    w123 = w40 * w122 - w66
    w124 = w45 * w122
    w125 = w124 - w64
    w126 = w46 * w122 - w40 * w58
    w127 = w42 * w122
    w128 = w127 - w35 * w58
    w129 = link2_y_ddot * link2_mass + link2_e0_ddot * w123 + link2_e1_ddot * w125 + link2_e2_ddot * w126 + link2_e3_ddot * w128
    w130 = link3_e1 * w81
    w131 = w70 * link3_e3
    w132 = link3_e0 * w81
    w133 = w74 * c5
    w134 = w75 * w133 - w101
    w135 = w80 * w133
    w136 = w135 - w99
    w137 = w81 * w133 - w75 * w93
    w138 = w77 * w133
    w139 = w138 - w70 * w93
    w140 = link3_y_ddot * link3_mass + link3_e0_ddot * w134 + link3_e1_ddot * w136 + link3_e2_ddot * w137 + link3_e3_ddot * w139
    w141 = w84 * w94 - w88 * (1.0 - (w73 + w130)) - w91 * (w131 - w132) - w140
    w142 = w49 * w59 - w53 * (1.0 - (w38 + w119)) - w56 * (w120 - w121) - w129 + w141
    w143 = w14 * w24 - w18 * (1.0 - (w3 + w108)) - w21 * (w109 - w110) - w118 + w142
    w144 = w6 * w25 - w113
    w145 = w32 - w2 * w111
    w146 = w26 - w116
    w147 = w0 * w25 - w6 * w111
    w148 = link1_z_ddot * link1_mass + link1_e0_ddot * w144 + link1_e1_ddot * w145 + link1_e2_ddot * w146 + link1_e3_ddot * w147
    w149 = w41 * w60 - w124
    w150 = w67 - w37 * w122
    w151 = w61 - w127
    w152 = w35 * w60 - w41 * w122
    w153 = link2_z_ddot * link2_mass + link2_e0_ddot * w149 + link2_e1_ddot * w150 + link2_e2_ddot * w151 + link2_e3_ddot * w152
    w154 = w76 * w95 - w135
    w155 = w102 - w72 * w133
    w156 = w96 - w138
    w157 = w70 * w95 - w76 * w133
    w158 = link3_z_ddot * link3_mass + link3_e0_ddot * w154 + link3_e1_ddot * w155 + link3_e2_ddot * w156 + link3_e3_ddot * w157
    w159 = c53 + (w84 * w92 - w88 * (w131 + w132) - w91 * (1.0 - (w71 + w130))) - w158
    w160 = c52 + (w49 * w57 - w53 * (w120 + w121) - w56 * (1.0 - (w36 + w119))) - w153 + w159
    w161 = c51 + (w14 * w22 - w18 * (w109 + w110) - w21 * (1.0 - (w1 + w108))) - w148 + w160
    w162 = w8 * c25
    w163 = w12 * c24
    w164 = w12 * w162 - w8 * w163
    w165 = w17 * c27
    w166 = w8 * w165 - w17 * w162
    w167 = w17 * w163 - w12 * w165
    w168 = link1_x_ddot * w27 + link1_y_ddot * w112 + link1_z_ddot * w144 + link1_e0_ddot * (w6 * (w6 * c0) + w10 * (w10 * c38) + w5 * (w5 * c39))
    w169 = w7 * c0
    w170 = w6 * w169 + link1_e2 * link1_e3 * c40
    w171 = w7 * c38
    w172 = w6 * c39
    w173 = w10 * w171 + link1_e3 * link1_e1 * c41
    w174 = w10 * c0
    w175 = w11 * c38
    w176 = w7 * c39
    w177 = link1_e2 * link1_e1 * c42 + w5 * w176
    w178 = w6 * w164 + w10 * w166 + w5 * w167 + w144 * gravity_z - (w168 + link1_e1_ddot * w170 + link1_e2_ddot * w173 + link1_e3_ddot * w177)
    w179 = w22 * link1_end_x
    w180 = w24 * link1_end_x
    w181 = w5 * w180
    w182 = w4 * link1_end_x
    w183 = w6 * w179
    w184 = w10 * w182
    w185 = link1_e0 * (w178 + (w106 * (w10 * w179 - w181) + w142 * (w5 * w182 - w183) + w160 * (w6 * w180 - w184)))
    w186 = link1_x_ddot * w28 + link1_y_ddot * w114 + link1_z_ddot * w145 + link1_e0_ddot * w170 + link1_e1_ddot * (w7 * w169 + w5 * (w5 * c38) + w0 * (w0 * c39))
    w187 = link1_e3 * link1_e0 * c42 + w0 * w172
    w188 = w5 * w175 + link1_e2 * link1_e0 * c41
    w189 = w7 * w164 + w5 * w166 + w0 * w167 + w145 * gravity_z - (w186 + link1_e2_ddot * w187 + link1_e3_ddot * w188)
    w190 = w7 * w179
    w191 = w7 * w180
    w192 = link1_e1 * (w189 + (w106 * (w2 * w179 - w10 * w180) + w142 * (w184 - w190) + w160 * (w191 - w2 * w182)))
    w193 = link1_x_ddot * w30 + link1_y_ddot * w115 + link1_z_ddot * w146 + link1_e0_ddot * w173 + link1_e1_ddot * w187
    w194 = w2 * w174 + link1_e1 * link1_e0 * c40
    w195 = w2 * w164 + w7 * w166 + w6 * w167 + w146 * gravity_z - (w193 + link1_e2_ddot * (w2 * (w2 * c0) + w7 * w171 + w6 * w172) + link1_e3_ddot * w194)
    w196 = w7 * w182
    w197 = link1_e2 * (w195 + (w106 * (w190 - w11 * w180) + w142 * (w11 * w182 - w5 * w179) + w160 * (w181 - w196)))
    w198 = link1_x_ddot * w33 + link1_y_ddot * w117 + link1_z_ddot * w147 + link1_e0_ddot * w177 + link1_e1_ddot * w188
    w199 = w10 * w164 + w11 * w166 + w7 * w167 + w147 * gravity_z - (w198 + link1_e2_ddot * w194 + link1_e3_ddot * (w10 * w174 + w11 * w175 + w7 * w176))
    w200 = link1_e3 * (w199 + (w106 * (w183 - w191) + w142 * (w196 - w0 * w179) + w160 * (w0 * w180 - w6 * w182)))
    w201 = w43 * c32
    w202 = w47 * c31
    w203 = w47 * w201 - w43 * w202
    w204 = w52 * c33
    w205 = w43 * w204 - w52 * w201
    w206 = w52 * w202 - w47 * w204
    w207 = link2_x_ddot * w62 + link2_y_ddot * w123 + link2_z_ddot * w149 + link2_e0_ddot * (w41 * (w41 * c7) + w45 * (w45 * c43) + w40 * (w40 * c44))
    w208 = w42 * c7
    w209 = w41 * w208 + link2_e2 * link2_e3 * c45
    w210 = w42 * c43
    w211 = w41 * c44
    w212 = w45 * w210 + link2_e3 * link2_e1 * c46
    w213 = w45 * c7
    w214 = w46 * c43
    w215 = w42 * c44
    w216 = link2_e2 * link2_e1 * c47 + w40 * w215
    w217 = w41 * w203 + w45 * w205 + w40 * w206 + w149 * gravity_z - (w207 + link2_e1_ddot * w209 + link2_e2_ddot * w212 + link2_e3_ddot * w216)
    w218 = w57 * link2_end_x
    w219 = w59 * link2_end_x
    w220 = w40 * w219
    w221 = w39 * link2_end_x
    w222 = w41 * w218
    w223 = w45 * w221
    w224 = link2_e0 * (w217 + (w105 * (w45 * w218 - w220) + w141 * (w40 * w221 - w222) + w159 * (w41 * w219 - w223)))
    w225 = link2_x_ddot * w63 + link2_y_ddot * w125 + link2_z_ddot * w150 + link2_e0_ddot * w209 + link2_e1_ddot * (w42 * w208 + w40 * (w40 * c43) + w35 * (w35 * c44))
    w226 = link2_e3 * link2_e0 * c47 + w35 * w211
    w227 = w40 * w214 + link2_e2 * link2_e0 * c46
    w228 = w42 * w203 + w40 * w205 + w35 * w206 + w150 * gravity_z - (w225 + link2_e2_ddot * w226 + link2_e3_ddot * w227)
    w229 = w42 * w218
    w230 = w42 * w219
    w231 = link2_e1 * (w228 + (w105 * (w37 * w218 - w45 * w219) + w141 * (w223 - w229) + w159 * (w230 - w37 * w221)))
    w232 = link2_x_ddot * w65 + link2_y_ddot * w126 + link2_z_ddot * w151 + link2_e0_ddot * w212 + link2_e1_ddot * w226
    w233 = w37 * w213 + link2_e1 * link2_e0 * c45
    w234 = w37 * w203 + w42 * w205 + w41 * w206 + w151 * gravity_z - (w232 + link2_e2_ddot * (w37 * (w37 * c7) + w42 * w210 + w41 * w211) + link2_e3_ddot * w233)
    w235 = w42 * w221
    w236 = link2_e2 * (w234 + (w105 * (w229 - w46 * w219) + w141 * (w46 * w221 - w40 * w218) + w159 * (w220 - w235)))
    w237 = link2_x_ddot * w68 + link2_y_ddot * w128 + link2_z_ddot * w152 + link2_e0_ddot * w216 + link2_e1_ddot * w227
    w238 = w45 * w203 + w46 * w205 + w42 * w206 + w152 * gravity_z - (w237 + link2_e2_ddot * w233 + link2_e3_ddot * (w45 * w213 + w46 * w214 + w42 * w215))
    w239 = link2_e3 * (w238 + (w105 * (w222 - w230) + w141 * (w235 - w35 * w218) + w159 * (w35 * w219 - w41 * w221)))
    w240 = w78 * c35
    w241 = w82 * c34
    w242 = w82 * w240 - w78 * w241
    w243 = w87 * c36
    w244 = w78 * w243 - w87 * w240
    w245 = w87 * w241 - w82 * w243
    w246 = link3_x_ddot * w97 + link3_y_ddot * w134 + link3_z_ddot * w154 + link3_e0_ddot * (w76 * (w76 * c10) + w80 * (w80 * c11) + w75 * (w75 * c12))
    w247 = w77 * c10
    w248 = w76 * w247 + link3_e2 * link3_e3 * c48
    w249 = w77 * c11
    w250 = w76 * c12
    w251 = w80 * w249 + link3_e3 * link3_e1 * c49
    w252 = w80 * c10
    w253 = w81 * c11
    w254 = w77 * c12
    w255 = link3_e2 * link3_e1 * c50 + w75 * w254
    w256 = w76 * w242 + w80 * w244 + w75 * w245 + w154 * gravity_z - (w246 + link3_e1_ddot * w248 + link3_e2_ddot * w251 + link3_e3_ddot * w255)
    w257 = link3_x_ddot * w98 + link3_y_ddot * w136 + link3_z_ddot * w155 + link3_e0_ddot * w248 + link3_e1_ddot * (w77 * w247 + w75 * (w75 * c11) + w70 * (w70 * c12))
    w258 = link3_e3 * link3_e0 * c50 + w70 * w250
    w259 = w75 * w253 + link3_e2 * link3_e0 * c49
    w260 = w77 * w242 + w75 * w244 + w70 * w245 + w155 * gravity_z - (w257 + link3_e2_ddot * w258 + link3_e3_ddot * w259)
    w261 = link3_x_ddot * w100 + link3_y_ddot * w137 + link3_z_ddot * w156 + link3_e0_ddot * w251 + link3_e1_ddot * w258
    w262 = w72 * w252 + link3_e1 * link3_e0 * c48
    w263 = w72 * w242 + w77 * w244 + w76 * w245 + w156 * gravity_z - (w261 + link3_e2_ddot * (w72 * (w72 * c10) + w77 * w249 + w76 * w250) + link3_e3_ddot * w262)
    w264 = link3_x_ddot * w103 + link3_y_ddot * w139 + link3_z_ddot * w157 + link3_e0_ddot * w255 + link3_e1_ddot * w259
    w265 = w80 * w242 + w81 * w244 + w77 * w245 + w157 * gravity_z - (w264 + link3_e2_ddot * w262 + link3_e3_ddot * (w80 * w252 + w81 * w253 + w77 * w254))
    # outputs
    lam = ca.vertcat(
        w107,  # joint1.x
        w143,  # joint1.y
        w161,  # joint1.z
        w106,  # joint2.x
        w142,  # joint2.y
        w160,  # joint2.z
        w105,  # joint3.x
        w141,  # joint3.y
        w159,  # joint3.z
        w185 + w192 + w197 + w200,  # link1.norm
        w224 + w231 + w236 + w239,  # link2.norm
        link3_e0 * w256 + link3_e1 * w260 + link3_e2 * w263 + link3_e3 * w265,  # link3.norm
    )
    joint_forces = ca.SX(6, 3)
    joint_forces[0, 0] = -w107
    joint_forces[0, 1] = -w106
    joint_forces[0, 2] = -w105
    joint_forces[1, 0] = -w143
    joint_forces[1, 1] = -w142
    joint_forces[1, 2] = -w141
    joint_forces[2, 0] = -w161
    joint_forces[2, 1] = -w160
    joint_forces[2, 2] = -w159
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 21) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 21) [mixed]: rates of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    615 operations.
    """
    q = ca.SX.sym("q", 21)
    q_dot = ca.SX.sym("q_dot", 21)
    c = ca.SX.sym("c", 62)
    link1_z = q[2]
    link1_e0 = q[3]
    link1_e1 = q[4]
    link1_e2 = q[5]
    link1_e3 = q[6]
    link2_z = q[9]
    link2_e0 = q[10]
    link2_e1 = q[11]
    link2_e2 = q[12]
    link2_e3 = q[13]
    link3_z = q[16]
    link3_e0 = q[17]
    link3_e1 = q[18]
    link3_e2 = q[19]
    link3_e3 = q[20]
    link1_x_dot = q_dot[0]
    link1_y_dot = q_dot[1]
    link1_z_dot = q_dot[2]
    link1_e0_dot = q_dot[3]
    link1_e1_dot = q_dot[4]
    link1_e2_dot = q_dot[5]
    link1_e3_dot = q_dot[6]
    link2_x_dot = q_dot[7]
    link2_y_dot = q_dot[8]
    link2_z_dot = q_dot[9]
    link2_e0_dot = q_dot[10]
    link2_e1_dot = q_dot[11]
    link2_e2_dot = q_dot[12]
    link2_e3_dot = q_dot[13]
    link3_x_dot = q_dot[14]
    link3_y_dot = q_dot[15]
    link3_z_dot = q_dot[16]
    link3_e0_dot = q_dot[17]
    link3_e1_dot = q_dot[18]
    link3_e2_dot = q_dot[19]
    link3_e3_dot = q_dot[20]
    c0 = c[0]
    c5 = c[5]
    c7 = c[7]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    link1_mass = c[26]
    link2_mass = c[28]
    link3_mass = c[29]
    c30 = c[30]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c54 = c[54]
    # intermediate terms (150)
    w0 = 2 * -link1_e2
    w1 = 2 * link1_e1
    w2 = 2 * link1_e2
    w3 = (w1 * link1_e3 - w2 * link1_e0) * c37
    w4 = 2 * -link1_e3
    w5 = 2 * link1_e3
    w6 = (link1_e2 * w1 + link1_e0 * w5) * c37
    w7 = w4 * w6
    w8 = w0 * w3 - w7
    w9 = w3 * w5 - w0 * w6
    w10 = 2 * link1_e0
    w11 = w3 * w10
    w12 = w11 - w1 * w6
    w13 = 2 * -link1_e1
    w14 = w3 * w13
    w15 = w6 * w10
    w16 = w14 - w15
    w17 = link1_x_dot * link1_mass + w8 * link1_e0_dot + w9 * link1_e1_dot + w12 * link1_e2_dot + w16 * link1_e3_dot
    w18 = (1.0 - (link1_e2 * w2 + link1_e3 * w5)) * c37
    w19 = w4 * w18 - w14
    w20 = w0 * w18
    w21 = w20 - w11
    w22 = w1 * w18 - w3 * w4
    w23 = w10 * w18
    w24 = w23 - w2 * w3
    w25 = link1_y_dot * link1_mass + link1_e0_dot * w19 + link1_e1_dot * w21 + link1_e2_dot * w22 + link1_e3_dot * w24
    w26 = w6 * w13 - w20
    w27 = w15 - w5 * w18
    w28 = w7 - w23
    w29 = w2 * w6 - w13 * w18
    w30 = link1_z_dot * link1_mass + link1_e0_dot * w26 + link1_e1_dot * w27 + link1_e2_dot * w28 + link1_e3_dot * w29
    w31 = link1_x_dot * w8 + link1_y_dot * w19 + link1_z_dot * w26 + link1_e0_dot * (w13 * (w13 * c0) + w0 * (w0 * c38) + w4 * (w4 * c39))
    w32 = w10 * c0
    w33 = w13 * w32 + link1_e2 * link1_e3 * c40
    w34 = w10 * c38
    w35 = w13 * c39
    w36 = w0 * w34 + link1_e1 * link1_e3 * c41
    w37 = w0 * c0
    w38 = w1 * c38
    w39 = w10 * c39
    w40 = link1_e2 * link1_e1 * c42 + w4 * w39
    w41 = link1_x_dot * w17 + link1_y_dot * w25 + link1_z_dot * w30 + link1_e0_dot * (w31 + link1_e1_dot * w33 + link1_e2_dot * w36 + link1_e3_dot * w40)
    w42 = link1_x_dot * w9 + link1_y_dot * w21 + link1_z_dot * w27 + link1_e0_dot * w33 + link1_e1_dot * (w10 * w32 + w4 * (w4 * c38) + w2 * (w2 * c39))
    w43 = link1_e3 * link1_e0 * c42 + w2 * w35
    w44 = w4 * w38 + link1_e2 * link1_e0 * c41
    w45 = link1_x_dot * w12 + link1_y_dot * w22 + link1_z_dot * w28 + link1_e0_dot * w36 + link1_e1_dot * w43
    w46 = w5 * w37 + link1_e1 * link1_e0 * c40
    w47 = link1_e2_dot * (w45 + link1_e2_dot * (w5 * (w5 * c0) + w10 * w34 + w13 * w35) + link1_e3_dot * w46)
    w48 = link1_x_dot * w16 + link1_y_dot * w24 + link1_z_dot * w29 + link1_e0_dot * w40 + link1_e1_dot * w44
    w49 = w41 + link1_e1_dot * (w42 + link1_e2_dot * w43 + link1_e3_dot * w44) + w47 + link1_e3_dot * (w48 + link1_e2_dot * w46 + link1_e3_dot * (w0 * w37 + w1 * w38 + w10 * w39))
    w50 = 2 * -link2_e2
    w51 = 2 * link2_e1
    w52 = 2 * link2_e2
    w53 = (w51 * link2_e3 - w52 * link2_e0) * c30
    w54 = 2 * -link2_e3
    w55 = 2 * link2_e3
    w56 = (link2_e2 * w51 + link2_e0 * w55) * c30
    w57 = w54 * w56
    w58 = w50 * w53 - w57
    w59 = w53 * w55 - w50 * w56
    w60 = 2 * link2_e0
    w61 = w53 * w60
    w62 = w61 - w51 * w56
    w63 = 2 * -link2_e1
    w64 = w53 * w63
    w65 = w56 * w60
    w66 = w64 - w65
    w67 = link2_x_dot * link2_mass + w58 * link2_e0_dot + w59 * link2_e1_dot + w62 * link2_e2_dot + w66 * link2_e3_dot
    w68 = (1.0 - (link2_e2 * w52 + link2_e3 * w55)) * c30
    w69 = w54 * w68 - w64
    w70 = w50 * w68
    w71 = w70 - w61
    w72 = w51 * w68 - w53 * w54
    w73 = w60 * w68
    w74 = w73 - w52 * w53
    w75 = link2_y_dot * link2_mass + link2_e0_dot * w69 + link2_e1_dot * w71 + link2_e2_dot * w72 + link2_e3_dot * w74
    w76 = w56 * w63 - w70
    w77 = w65 - w55 * w68
    w78 = w57 - w73
    w79 = w52 * w56 - w63 * w68
    w80 = link2_z_dot * link2_mass + link2_e0_dot * w76 + link2_e1_dot * w77 + link2_e2_dot * w78 + link2_e3_dot * w79
    w81 = link2_x_dot * w58 + link2_y_dot * w69 + link2_z_dot * w76 + link2_e0_dot * (w63 * (w63 * c7) + w50 * (w50 * c43) + w54 * (w54 * c44))
    w82 = w60 * c7
    w83 = w63 * w82 + link2_e2 * link2_e3 * c45
    w84 = w60 * c43
    w85 = w63 * c44
    w86 = w50 * w84 + link2_e1 * link2_e3 * c46
    w87 = w50 * c7
    w88 = w51 * c43
    w89 = w60 * c44
    w90 = link2_e2 * link2_e1 * c47 + w54 * w89
    w91 = w49 + link2_x_dot * w67 + link2_y_dot * w75 + link2_z_dot * w80 + link2_e0_dot * (w81 + link2_e1_dot * w83 + link2_e2_dot * w86 + link2_e3_dot * w90)
    w92 = link2_x_dot * w59 + link2_y_dot * w71 + link2_z_dot * w77 + link2_e0_dot * w83 + link2_e1_dot * (w60 * w82 + w54 * (w54 * c43) + w52 * (w52 * c44))
    w93 = link2_e3 * link2_e0 * c47 + w52 * w85
    w94 = w54 * w88 + link2_e2 * link2_e0 * c46
    w95 = link2_x_dot * w62 + link2_y_dot * w72 + link2_z_dot * w78 + link2_e0_dot * w86 + link2_e1_dot * w93
    w96 = w55 * w87 + link2_e1 * link2_e0 * c45
    w97 = link2_e2_dot * (w95 + link2_e2_dot * (w55 * (w55 * c7) + w60 * w84 + w63 * w85) + link2_e3_dot * w96)
    w98 = link2_x_dot * w66 + link2_y_dot * w74 + link2_z_dot * w79 + link2_e0_dot * w90 + link2_e1_dot * w94
    w99 = w91 + link2_e1_dot * (w92 + link2_e2_dot * w93 + link2_e3_dot * w94) + w97 + link2_e3_dot * (w98 + link2_e2_dot * w96 + link2_e3_dot * (w50 * w87 + w51 * w88 + w60 * w89))
    w100 = 2 * -link3_e2
    w101 = 2 * link3_e1
    w102 = 2 * link3_e2
    w103 = (w101 * link3_e3 - w102 * link3_e0) * c5
    w104 = 2 * -link3_e3
    w105 = 2 * link3_e3
    w106 = (link3_e2 * w101 + link3_e0 * w105) * c5
    w107 = w104 * w106
    w108 = w100 * w103 - w107
    w109 = w103 * w105 - w100 * w106
    w110 = 2 * link3_e0
    w111 = w103 * w110
    w112 = w111 - w101 * w106
    w113 = 2 * -link3_e1
    w114 = w103 * w113
    w115 = w106 * w110
    w116 = w114 - w115
    w117 = link3_x_dot * link3_mass + w108 * link3_e0_dot + w109 * link3_e1_dot + w112 * link3_e2_dot + w116 * link3_e3_dot
    w118 = (1.0 - (link3_e2 * w102 + link3_e3 * w105)) * c5
    w119 = w104 * w118 - w114
    w120 = w100 * w118
    w121 = w120 - w111
    w122 = w101 * w118 - w103 * w104
    w123 = w110 * w118
    w124 = w123 - w102 * w103
    w125 = link3_y_dot * link3_mass + link3_e0_dot * w119 + link3_e1_dot * w121 + link3_e2_dot * w122 + link3_e3_dot * w124
    w126 = w106 * w113 - w120
    w127 = w115 - w105 * w118
    w128 = w107 - w123
    w129 = w102 * w106 - w113 * w118
    w130 = link3_z_dot * link3_mass + link3_e0_dot * w126 + link3_e1_dot * w127 + link3_e2_dot * w128 + link3_e3_dot * w129
    w131 = link3_x_dot * w108 + link3_y_dot * w119 + link3_z_dot * w126 + link3_e0_dot * (w113 * (w113 * c10) + w100 * (w100 * c11) + w104 * (w104 * c12))
    w132 = w110 * c10
    w133 = w113 * w132 + link3_e2 * link3_e3 * c48
    w134 = w110 * c11
    w135 = w113 * c12
    w136 = w100 * w134 + link3_e1 * link3_e3 * c49
    w137 = w100 * c10
    w138 = w101 * c11
    w139 = w110 * c12
    w140 = link3_e2 * link3_e1 * c50 + w104 * w139
    w141 = w99 + link3_x_dot * w117 + link3_y_dot * w125 + link3_z_dot * w130 + link3_e0_dot * (w131 + link3_e1_dot * w133 + link3_e2_dot * w136 + link3_e3_dot * w140)
    w142 = link3_x_dot * w109 + link3_y_dot * w121 + link3_z_dot * w127 + link3_e0_dot * w133 + link3_e1_dot * (w110 * w132 + w104 * (w104 * c11) + w102 * (w102 * c12))
    w143 = link3_e3 * link3_e0 * c50 + w102 * w135
    w144 = w104 * w138 + link3_e2 * link3_e0 * c49
    w145 = link3_x_dot * w112 + link3_y_dot * w122 + link3_z_dot * w128 + link3_e0_dot * w136 + link3_e1_dot * w143
    w146 = w105 * w137 + link3_e1 * link3_e0 * c48
    w147 = link3_e2_dot * (w145 + link3_e2_dot * (w105 * (w105 * c10) + w110 * w134 + w113 * w135) + link3_e3_dot * w146)
    w148 = link3_x_dot * w116 + link3_y_dot * w124 + link3_z_dot * w129 + link3_e0_dot * w140 + link3_e1_dot * w144
    w149 = link3_e3_dot * (w148 + link3_e2_dot * w146 + link3_e3_dot * (w100 * w137 + w101 * w138 + w110 * w139))
    # outputs
    kinetic = ca.vertcat((w141 + link3_e1_dot * (w142 + link3_e2_dot * w143 + link3_e3_dot * w144) + w147 + w149) / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(
        (w3 + link1_z * link1_mass + (w53 + link2_z * link2_mass) + (w103 + link3_z * link3_mass)) * c54,
    )
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 21) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    72 operations.
    """
    q = ca.SX.sym("q", 21)
    link1_x = q[0]
    link1_y = q[1]
    link1_z = q[2]
    link1_e0 = q[3]
    link1_e1 = q[4]
    link1_e2 = q[5]
    link1_e3 = q[6]
    link2_x = q[7]
    link2_y = q[8]
    link2_z = q[9]
    link2_e0 = q[10]
    link2_e1 = q[11]
    link2_e2 = q[12]
    link2_e3 = q[13]
    link3_x = q[14]
    link3_y = q[15]
    link3_z = q[16]
    link3_e0 = q[17]
    link3_e1 = q[18]
    link3_e2 = q[19]
    link3_e3 = q[20]
    # intermediate terms (36)
    w0 = 2 * link1_e2
    w1 = link1_e2 * w0
    w2 = 2 * link1_e3
    w3 = link1_e3 * w2
    w4 = 2 * link1_e1
    w5 = link1_e2 * w4
    w6 = w2 * link1_e0
    w7 = link1_e3 * w4
    w8 = w0 * link1_e0
    w9 = link1_e1 * w4
    w10 = w0 * link1_e3
    w11 = w4 * link1_e0
    w12 = 2 * link2_e2
    w13 = link2_e2 * w12
    w14 = 2 * link2_e3
    w15 = link2_e3 * w14
    w16 = 2 * link2_e1
    w17 = link2_e2 * w16
    w18 = w14 * link2_e0
    w19 = link2_e3 * w16
    w20 = w12 * link2_e0
    w21 = link2_e1 * w16
    w22 = w12 * link2_e3
    w23 = w16 * link2_e0
    w24 = 2 * link3_e2
    w25 = link3_e2 * w24
    w26 = 2 * link3_e3
    w27 = link3_e3 * w26
    w28 = 2 * link3_e1
    w29 = link3_e2 * w28
    w30 = w26 * link3_e0
    w31 = link3_e3 * w28
    w32 = w24 * link3_e0
    w33 = link3_e1 * w28
    w34 = w24 * link3_e3
    w35 = w28 * link3_e0
    # outputs
    poses = ca.vertcat(
        ca.horzcat(link1_x, link2_x, link3_x),
        ca.horzcat(link1_y, link2_y, link3_y),
        ca.horzcat(link1_z, link2_z, link3_z),
        ca.horzcat(1.0 - (w1 + w3), 1.0 - (w13 + w15), 1.0 - (w25 + w27)),
        ca.horzcat(w5 + w6, w17 + w18, w29 + w30),
        ca.horzcat(w7 - w8, w19 - w20, w31 - w32),
        ca.horzcat(w5 - w6, w17 - w18, w29 - w30),
        ca.horzcat(1.0 - (w3 + w9), 1.0 - (w15 + w21), 1.0 - (w27 + w33)),
        ca.horzcat(w10 + w11, w22 + w23, w34 + w35),
        ca.horzcat(w7 + w8, w19 + w20, w31 + w32),
        ca.horzcat(w10 - w11, w22 - w23, w34 - w35),
        ca.horzcat(1.0 - (w1 + w9), 1.0 - (w13 + w21), 1.0 - (w25 + w33)),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i, through q_d
    1104 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    link1_end_x = c[1]
    link2_end_x = c[3]
    c4 = c[4]
    c5 = c[5]
    gravity_z = c[14]
    c15 = c[15]
    # intermediate terms (331)
    w0 = link1_e2 * 4.0
    w1 = 2 * link3_e1
    w2 = w1 * link3_e2
    w3 = 2 * link3_e3
    w4 = w3 * link3_e0
    w5 = w2 - w4
    w6 = link3_omega_x * link3_omega_y
    w7 = 2 * link3_e2
    w8 = link3_e2 * w7
    w9 = link3_e3 * w3
    w10 = link3_omega_y**2 + link3_omega_z**2
    w11 = w1 * link3_e3
    w12 = link3_e0 * w7
    w13 = w11 + w12
    w14 = link3_omega_x * link3_omega_z
    w15 = (w5 * w6 - (1.0 - (w8 + w9)) * w10 + w13 * w14) * c5
    w16 = 2 * link2_e1
    w17 = w16 * link2_e2
    w18 = 2 * link2_e3
    w19 = w18 * link2_e0
    w20 = w17 - w19
    w21 = link2_omega_x * link2_omega_y
    w22 = 2 * link2_e2
    w23 = link2_e2 * w22
    w24 = link2_e3 * w18
    w25 = link2_omega_y**2 + link2_omega_z**2
    w26 = w16 * link2_e3
    w27 = link2_e0 * w22
    w28 = w26 + w27
    w29 = link2_omega_x * link2_omega_z
    w30 = w20 * w21 - (1.0 - (w23 + w24)) * w25 + w28 * w29
    w31 = w15 + w30 * c4
    w32 = 2 * link1_e0
    w33 = w32 * link1_end_x
    w34 = w31 * w33
    w35 = link3_e1 * w1
    w36 = 1.0 - (w9 + w35)
    w37 = link3_e3 * w7
    w38 = w1 * link3_e0
    w39 = w37 - w38
    w40 = (w6 * w36 - w10 * (w2 + w4) + w14 * w39) * c5
    w41 = link2_e1 * w16
    w42 = 1.0 - (w24 + w41)
    w43 = link2_e3 * w22
    w44 = w16 * link2_e0
    w45 = w43 - w44
    w46 = w21 * w42 - w25 * (w17 + w19) + w29 * w45
    w47 = w40 + w46 * c4
    w48 = 2 * link1_e3
    w49 = w48 * link1_end_x
    w50 = w37 + w38
    w51 = 1.0 - (w8 + w35)
    w52 = (w6 * w50 - w10 * (w11 - w12) + w14 * w51) * c5
    w53 = w43 + w44
    w54 = 1.0 - (w23 + w41)
    w55 = w21 * w53 - w25 * (w26 - w27) + w29 * w54
    w56 = w52 + w55 * c4
    w57 = w0 * c15 + (w34 + w47 * w49 - w56 * (w0 * link1_end_x))
    w58 = link1_e3 * 0.5
    w59 = 2 * link1_e1
    w60 = w59 * link1_end_x
    w61 = w31 * w60
    w62 = 2 * link1_e2
    w63 = w62 * link1_end_x
    w64 = w61 + w47 * w63
    w65 = link1_e2 * 0.5
    w66 = link1_e1 * 4.0
    w67 = w31 * w49
    w68 = w66 * link1_end_x
    w69 = w66 * c15 + (w67 - w33 * w47 - w56 * w68)
    w70 = link1_e0 * 0.5
    w71 = w31 * w63
    w72 = w71 - w47 * w60
    w73 = link1_e1 * 0.5
    w74 = link1_e3 * 4.0
    w75 = w56 * w63 - (w34 + w47 * (w74 * link1_end_x)) - w62 * c15
    w76 = w61 + w49 * w56 - w48 * c15
    w77 = w71 - w47 * w68 + w33 * w56 - w32 * c15
    w78 = w56 * w60 - w67 - w59 * c15
    w79 = link1_omega_x * link1_omega_y
    w80 = w59 * w79
    w81 = link1_omega_y**2 + link1_omega_z**2
    w82 = link1_omega_x * link1_omega_z
    w83 = w32 * w82
    w84 = (w80 + w0 * w81 + w83) * link1_end_x
    w85 = w84 * c4
    w86 = w48 * w82
    w87 = w59 * w81
    w88 = (w86 - w87) * link1_end_x
    w89 = w88 * c4
    w90 = w48 * w79
    w91 = w32 * w81
    w92 = (w90 + w91 - w0 * w82) * link1_end_x
    w93 = w92 * c4
    w94 = w28 * w85 + w45 * w89 + w54 * w93
    w95 = w32 * w79
    w96 = w59 * w82
    w97 = (w74 * w81 - w95 + w96) * link1_end_x
    w98 = w97 * c4
    w99 = w62 * w82
    w100 = (w99 - (w91 + w74 * w79)) * link1_end_x
    w101 = w100 * c4
    w102 = w62 * w79
    w103 = (w102 - w87) * link1_end_x
    w104 = w103 * c4
    w105 = w28 * w98 + w45 * w101 + w54 * w104
    w106 = (w86 + w102) * link1_end_x
    w107 = w106 * c4
    w108 = w62 * w81
    w109 = (w83 + (w66 * w79 + w108)) * link1_end_x
    w110 = w109 * c4
    w111 = w48 * w81
    w112 = (w95 - w111 - w66 * w82) * link1_end_x
    w113 = w112 * c4
    w114 = w28 * w107 - w45 * w110 + w54 * w113
    w115 = (w99 - w90) * link1_end_x
    w116 = w115 * c4
    w117 = (w96 + w111) * link1_end_x
    w118 = w117 * c4
    w119 = (w80 + w108) * link1_end_x
    w120 = w119 * c4
    w121 = w28 * w116 - w45 * w118 + w54 * w120
    w122 = w20 * w98 + w42 * w101 + w53 * w104
    w123 = w20 * w85 + w42 * w89 + w53 * w93
    w124 = w20 * w107 - w42 * w110 + w53 * w113
    w125 = w20 * w116 - w42 * w118 + w53 * w120
    w126 = w13 * c5
    w127 = w39 * c5
    w128 = w51 * c5
    w129 = w84 * w126 + w88 * w127 + w92 * w128
    w130 = w97 * w126 + w100 * w127 + w103 * w128
    w131 = w106 * w126 - w109 * w127 + w112 * w128
    w132 = w115 * w126 - w117 * w127 + w119 * w128
    w133 = w5 * c5
    w134 = w36 * c5
    w135 = w50 * c5
    w136 = w97 * w133 + w100 * w134 + w103 * w135
    w137 = w84 * w133 + w88 * w134 + w92 * w135
    w138 = w106 * w133 - w109 * w134 + w112 * w135
    w139 = w115 * w133 - w117 * w134 + w119 * w135
    w140 = link1_e3 * w59
    w141 = link1_e0 * w62
    w142 = w140 + w141
    w143 = w142 * link1_end_x
    w144 = w16 * w21
    w145 = link2_e2 * 4.0
    w146 = 2 * link2_e0
    w147 = w29 * w146
    w148 = w144 + w25 * w145 + w147
    w149 = w148 * c4
    w150 = link1_e3 * w62
    w151 = link1_e0 * w59
    w152 = w150 - w151
    w153 = w152 * link1_end_x
    w154 = w18 * w29
    w155 = w16 * w25
    w156 = w154 - w155
    w157 = w156 * c4
    w158 = link1_e1 * w59
    w159 = link1_e2 * w62
    w160 = 1.0 - (w158 + w159)
    w161 = w160 * link1_end_x
    w162 = w18 * w21
    w163 = w25 * w146
    w164 = w162 + w163 - w29 * w145
    w165 = w164 * c4
    w166 = w143 * w149 + w153 * w157 + w161 * w165
    w167 = link2_e3 * 0.5
    w168 = link2_e3 * 4.0
    w169 = w21 * w146
    w170 = w16 * w29
    w171 = w25 * w168 - w169 + w170
    w172 = w171 * c4
    w173 = w22 * w29
    w174 = w173 - (w163 + w21 * w168)
    w175 = w174 * c4
    w176 = w21 * w22
    w177 = w176 - w155
    w178 = w177 * c4
    w179 = w143 * w172 + w153 * w175 + w161 * w178
    w180 = link2_e2 * 0.5
    w181 = w154 + w176
    w182 = w181 * c4
    w183 = link2_e1 * 4.0
    w184 = w22 * w25
    w185 = w147 + (w21 * w183 + w184)
    w186 = w185 * c4
    w187 = w18 * w25
    w188 = w169 - w187 - w29 * w183
    w189 = w188 * c4
    w190 = w143 * w182 - w153 * w186 + w161 * w189
    w191 = link2_e0 * 0.5
    w192 = w173 - w162
    w193 = w192 * c4
    w194 = w170 + w187
    w195 = w194 * c4
    w196 = w144 + w184
    w197 = w196 * c4
    w198 = w143 * w193 - w153 * w195 + w161 * w197
    w199 = link2_e1 * 0.5
    w200 = link1_e2 * w59
    w201 = link1_e0 * w48
    w202 = w200 - w201
    w203 = w202 * link1_end_x
    w204 = link1_e3 * w48
    w205 = 1.0 - (w158 + w204)
    w206 = w205 * link1_end_x
    w207 = w150 + w151
    w208 = w207 * link1_end_x
    w209 = w172 * w203 + w175 * w206 + w178 * w208
    w210 = w149 * w203 + w157 * w206 + w165 * w208
    w211 = w182 * w203 - w186 * w206 + w189 * w208
    w212 = w193 * w203 - w195 * w206 + w197 * w208
    w213 = (w79 * w202 - w81 * (1.0 - (w159 + w204)) + w82 * w142) * link1_end_x
    w214 = w15 * link2_end_x + w213 * c4
    w215 = w146 * w214
    w216 = (w79 * w205 - w81 * (w200 + w201) + w82 * w152) * link1_end_x
    w217 = w40 * link2_end_x + w216 * c4
    w218 = (w79 * w207 - w81 * (w140 - w141) + w82 * w160) * link1_end_x - gravity_z
    w219 = w52 * link2_end_x + w218 * c4
    w220 = w215 + w18 * w217 - w145 * w219
    w221 = w16 * w214
    w222 = w221 + w22 * w217
    w223 = w18 * w214
    w224 = w223 - w146 * w217 - w183 * w219
    w225 = w22 * w214
    w226 = w225 - w16 * w217
    w227 = w22 * w219 - (w215 + w168 * w217)
    w228 = w221 + w18 * w219
    w229 = w225 - w183 * w217 + w146 * w219
    w230 = w16 * w219 - w223
    w231 = w148 * link2_end_x
    w232 = w156 * link2_end_x
    w233 = w164 * link2_end_x
    w234 = w126 * w231 + w127 * w232 + w128 * w233
    w235 = w171 * link2_end_x
    w236 = w174 * link2_end_x
    w237 = w177 * link2_end_x
    w238 = w126 * w235 + w127 * w236 + w128 * w237
    w239 = w181 * link2_end_x
    w240 = w185 * link2_end_x
    w241 = w188 * link2_end_x
    w242 = w126 * w239 - w127 * w240 + w128 * w241
    w243 = w192 * link2_end_x
    w244 = w194 * link2_end_x
    w245 = w196 * link2_end_x
    w246 = w126 * w243 - w127 * w244 + w128 * w245
    w247 = w133 * w235 + w134 * w236 + w135 * w237
    w248 = w133 * w231 + w134 * w232 + w135 * w233
    w249 = w133 * w239 - w134 * w240 + w135 * w241
    w250 = w133 * w243 - w134 * w244 + w135 * w245
    w251 = w1 * w6
    w252 = link3_e2 * 4.0
    w253 = 2 * link3_e0
    w254 = w14 * w253
    w255 = (w251 + w10 * w252 + w254) * c5
    w256 = w3 * w14
    w257 = w1 * w10
    w258 = (w256 - w257) * c5
    w259 = w3 * w6
    w260 = w10 * w253
    w261 = (w259 + w260 - w14 * w252) * c5
    w262 = w143 * w255 + w153 * w258 + w161 * w261
    w263 = link3_e3 * 0.5
    w264 = link3_e3 * 4.0
    w265 = w6 * w253
    w266 = w1 * w14
    w267 = (w10 * w264 - w265 + w266) * c5
    w268 = w7 * w14
    w269 = (w268 - (w260 + w6 * w264)) * c5
    w270 = w6 * w7
    w271 = (w270 - w257) * c5
    w272 = w143 * w267 + w153 * w269 + w161 * w271
    w273 = link3_e2 * 0.5
    w274 = (w256 + w270) * c5
    w275 = link3_e1 * 4.0
    w276 = w7 * w10
    w277 = (w254 + (w6 * w275 + w276)) * c5
    w278 = w3 * w10
    w279 = (w265 - w278 - w14 * w275) * c5
    w280 = w143 * w274 - w153 * w277 + w161 * w279
    w281 = link3_e0 * 0.5
    w282 = (w268 - w259) * c5
    w283 = (w266 + w278) * c5
    w284 = (w251 + w276) * c5
    w285 = w143 * w282 - w153 * w283 + w161 * w284
    w286 = link3_e1 * 0.5
    w287 = w203 * w267 + w206 * w269 + w208 * w271
    w288 = w203 * w255 + w206 * w258 + w208 * w261
    w289 = w203 * w274 - w206 * w277 + w208 * w279
    w290 = w203 * w282 - w206 * w283 + w208 * w284
    w291 = w255 * link2_end_x
    w292 = w258 * link2_end_x
    w293 = w261 * link2_end_x
    w294 = w28 * w291 + w45 * w292 + w54 * w293
    w295 = w267 * link2_end_x
    w296 = w269 * link2_end_x
    w297 = w271 * link2_end_x
    w298 = w28 * w295 + w45 * w296 + w54 * w297
    w299 = w274 * link2_end_x
    w300 = w277 * link2_end_x
    w301 = w279 * link2_end_x
    w302 = w28 * w299 - w45 * w300 + w54 * w301
    w303 = w282 * link2_end_x
    w304 = w283 * link2_end_x
    w305 = w284 * link2_end_x
    w306 = w28 * w303 - w45 * w304 + w54 * w305
    w307 = w20 * w295 + w42 * w296 + w53 * w297
    w308 = w20 * w291 + w42 * w292 + w53 * w293
    w309 = w20 * w299 - w42 * w300 + w53 * w301
    w310 = w20 * w303 - w42 * w304 + w53 * w305
    w311 = w213 + w30 * link2_end_x
    w312 = w253 * c5
    w313 = w311 * w312
    w314 = w216 + w46 * link2_end_x
    w315 = w3 * c5
    w316 = w218 + w55 * link2_end_x
    w317 = w313 + w314 * w315 - w316 * (w252 * c5)
    w318 = w1 * c5
    w319 = w311 * w318
    w320 = w7 * c5
    w321 = w319 + w314 * w320
    w322 = w311 * w315
    w323 = w275 * c5
    w324 = w322 - w312 * w314 - w316 * w323
    w325 = w311 * w320
    w326 = w325 - w314 * w318
    w327 = w316 * w320 - (w313 + w314 * (w264 * c5))
    w328 = w319 + w315 * w316
    w329 = w325 - w314 * w323 + w312 * w316
    w330 = w316 * w318 - w322
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.turn_x
        ca.horzcat(  # link1.turn_y
            w57 * w58 - w64 * w65 + w69 * w70 - w72 * w73, w64 * w73 + w57 * w70 - w58 * w69 - w65 * w72,
            w64 * w70 - w57 * w73 + w65 * w69 - w58 * w72, w166 * w167 - w179 * w180 + w190 * w191 - w198 * w199,
            w179 * w199 + w166 * w191 - w167 * w190 - w180 * w198,
            w179 * w191 - w166 * w199 + w180 * w190 - w167 * w198,
            w262 * w263 - w272 * w273 + w280 * w281 - w285 * w286,
            w272 * w286 + w262 * w281 - w263 * w280 - w273 * w285,
            w272 * w281 - w262 * w286 + w273 * w280 - w263 * w285,
        ),
        ca.horzcat(  # link1.turn_z
            w65 * w75 - w58 * w76 - w70 * w77 + w73 * w78, w58 * w77 - (w70 * w76 + w73 * w75) + w65 * w78,
            w58 * w78 - (w70 * w75 - w73 * w76 + w65 * w77), w180 * w209 - w167 * w210 - w191 * w211 + w199 * w212,
            w167 * w211 - (w199 * w209 + w191 * w210) + w180 * w212,
            w199 * w210 - w191 * w209 - w180 * w211 + w167 * w212,
            w273 * w287 - w263 * w288 - w281 * w289 + w286 * w290,
            w263 * w289 - (w286 * w287 + w281 * w288) + w273 * w290,
            w286 * w288 - w281 * w287 - w273 * w289 + w263 * w290,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link2.turn_x
        ca.horzcat(  # link2.turn_y
            w58 * w94 - w65 * w105 + w70 * w114 - w73 * w121, w73 * w105 + w70 * w94 - w58 * w114 - w65 * w121,
            w70 * w105 - w73 * w94 + w65 * w114 - w58 * w121, w167 * w220 - w180 * w222 + w191 * w224 - w199 * w226,
            w199 * w222 + w191 * w220 - w167 * w224 - w180 * w226,
            w191 * w222 - w199 * w220 + w180 * w224 - w167 * w226,
            w263 * w294 - w273 * w298 + w281 * w302 - w286 * w306,
            w286 * w298 + w281 * w294 - w263 * w302 - w273 * w306,
            w281 * w298 - w286 * w294 + w273 * w302 - w263 * w306,
        ),
        ca.horzcat(  # link2.turn_z
            w65 * w122 - w58 * w123 - w70 * w124 + w73 * w125, w58 * w124 - (w73 * w122 + w70 * w123) + w65 * w125,
            w73 * w123 - w70 * w122 - w65 * w124 + w58 * w125,
            w180 * w227 - w167 * w228 - w191 * w229 + w199 * w230,
            w167 * w229 - (w191 * w228 + w199 * w227) + w180 * w230,
            w167 * w230 - (w191 * w227 - w199 * w228 + w180 * w229),
            w273 * w307 - w263 * w308 - w281 * w309 + w286 * w310,
            w263 * w309 - (w286 * w307 + w281 * w308) + w273 * w310,
            w286 * w308 - w281 * w307 - w273 * w309 + w263 * w310,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link3.turn_x
        ca.horzcat(  # link3.turn_y
            w58 * w129 - w65 * w130 + w70 * w131 - w73 * w132, w73 * w130 + w70 * w129 - w58 * w131 - w65 * w132,
            w70 * w130 - w73 * w129 + w65 * w131 - w58 * w132,
            w167 * w234 - w180 * w238 + w191 * w242 - w199 * w246,
            w199 * w238 + w191 * w234 - w167 * w242 - w180 * w246,
            w191 * w238 - w199 * w234 + w180 * w242 - w167 * w246,
            w263 * w317 - w273 * w321 + w281 * w324 - w286 * w326,
            w286 * w321 + w281 * w317 - w263 * w324 - w273 * w326,
            w281 * w321 - w286 * w317 + w273 * w324 - w263 * w326,
        ),
        ca.horzcat(  # link3.turn_z
            w65 * w136 - w58 * w137 - w70 * w138 + w73 * w139, w58 * w138 - (w73 * w136 + w70 * w137) + w65 * w139,
            w73 * w137 - w70 * w136 - w65 * w138 + w58 * w139,
            w180 * w247 - w167 * w248 - w191 * w249 + w199 * w250,
            w167 * w249 - (w199 * w247 + w191 * w248) + w180 * w250,
            w199 * w248 - w191 * w247 - w180 * w249 + w167 * w250,
            w273 * w327 - w263 * w328 - w281 * w329 + w286 * w330,
            w263 * w329 - (w281 * w328 + w286 * w327) + w273 * w330,
            w263 * w330 - (w281 * w327 - w286 * w328 + w273 * w329),
        ),
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_d", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    468 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    link1_end_x = c[1]
    link2_end_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c24 = c[24]
    c25 = c[25]
    c31 = c[31]
    c32 = c[32]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c55 = c[55]
    c56 = c[56]
    # intermediate terms (153)
    w0 = link1_omega_z * c25
    w1 = link1_omega_y * c24
    w2 = 2 * link2_e1
    w3 = w2 * link2_e3
    w4 = 2 * link2_e2
    w5 = w4 * link2_e0
    w6 = w3 + w5
    w7 = 2 * link1_e1
    w8 = w7 * link1_e2
    w9 = 2 * link1_e3
    w10 = w9 * link1_e0
    w11 = w8 - w10
    w12 = w7 * link1_e3
    w13 = 2 * link1_e2
    w14 = link1_e0 * w13
    w15 = w12 + w14
    w16 = (link1_omega_y * w11 + link1_omega_z * w15) * link1_end_x
    w17 = w16 * c4
    w18 = link2_e3 * w4
    w19 = w2 * link2_e0
    w20 = w18 - w19
    w21 = link1_e1 * w7
    w22 = link1_e3 * w9
    w23 = 1.0 - (w21 + w22)
    w24 = link1_e3 * w13
    w25 = w7 * link1_e0
    w26 = w24 - w25
    w27 = (link1_omega_y * w23 + link1_omega_z * w26) * link1_end_x
    w28 = w27 * c4
    w29 = link2_e1 * w2
    w30 = link2_e2 * w4
    w31 = 1.0 - (w29 + w30)
    w32 = w24 + w25
    w33 = link1_e2 * w13
    w34 = 1.0 - (w21 + w33)
    w35 = (link1_omega_y * w32 + link1_omega_z * w34) * link1_end_x
    w36 = w35 * c4
    w37 = w2 * link2_e2
    w38 = 2 * link2_e3
    w39 = link2_e0 * w38
    w40 = w37 - w39
    w41 = link2_e3 * w38
    w42 = 1.0 - (w29 + w41)
    w43 = w18 + w19
    w44 = 2 * link3_e1
    w45 = w44 * link3_e3
    w46 = 2 * link3_e2
    w47 = w46 * link3_e0
    w48 = w45 + w47
    w49 = w48 * c5
    w50 = link3_e3 * w46
    w51 = w44 * link3_e0
    w52 = w50 - w51
    w53 = w52 * c5
    w54 = link3_e1 * w44
    w55 = link3_e2 * w46
    w56 = 1.0 - (w54 + w55)
    w57 = w56 * c5
    w58 = w44 * link3_e2
    w59 = 2 * link3_e3
    w60 = link3_e0 * w59
    w61 = w58 - w60
    w62 = w61 * c5
    w63 = link3_e3 * w59
    w64 = 1.0 - (w54 + w63)
    w65 = w64 * c5
    w66 = w50 + w51
    w67 = w66 * c5
    w68 = link1_omega_x * c55
    w69 = 1.0 - (w22 + w33)
    w70 = 2 * link1_omega_y
    w71 = (w11 * link1_omega_x - w69 * w70) * link1_end_x
    w72 = w71 * c4
    w73 = w8 + w10
    w74 = (w23 * link1_omega_x - w70 * w73) * link1_end_x
    w75 = w74 * c4
    w76 = w12 - w14
    w77 = (w32 * link1_omega_x - w70 * w76) * link1_end_x
    w78 = w77 * c4
    w79 = 2 * link1_omega_z
    w80 = (w15 * link1_omega_x - w69 * w79) * link1_end_x
    w81 = w80 * c4
    w82 = (w26 * link1_omega_x - w73 * w79) * link1_end_x
    w83 = w82 * c4
    w84 = (w34 * link1_omega_x - w76 * w79) * link1_end_x
    w85 = w84 * c4
    w86 = w15 * link1_end_x
    w87 = w40 * link2_omega_y + w6 * link2_omega_z
    w88 = w87 * c4
    w89 = w26 * link1_end_x
    w90 = w42 * link2_omega_y + w20 * link2_omega_z
    w91 = w90 * c4
    w92 = w34 * link1_end_x
    w93 = w43 * link2_omega_y + w31 * link2_omega_z
    w94 = w93 * c4
    w95 = w11 * link1_end_x
    w96 = w23 * link1_end_x
    w97 = w32 * link1_end_x
    w98 = link2_omega_z * c32
    w99 = link2_omega_y * c31
    w100 = w87 * link2_end_x
    w101 = w90 * link2_end_x
    w102 = w93 * link2_end_x
    w103 = 1.0 - (w30 + w41)
    w104 = 2 * link2_omega_y
    w105 = w40 * link2_omega_x - w103 * w104
    w106 = w105 * c4
    w107 = w37 + w39
    w108 = w42 * link2_omega_x - w104 * w107
    w109 = w108 * c4
    w110 = w3 - w5
    w111 = w43 * link2_omega_x - w104 * w110
    w112 = w111 * c4
    w113 = link2_omega_x * c56
    w114 = w105 * link2_end_x
    w115 = w108 * link2_end_x
    w116 = w111 * link2_end_x
    w117 = 2 * link2_omega_z
    w118 = w6 * link2_omega_x - w103 * w117
    w119 = w118 * c4
    w120 = w20 * link2_omega_x - w107 * w117
    w121 = w120 * c4
    w122 = w31 * link2_omega_x - w110 * w117
    w123 = w122 * c4
    w124 = w118 * link2_end_x
    w125 = w120 * link2_end_x
    w126 = w122 * link2_end_x
    w127 = (w61 * link3_omega_y + w48 * link3_omega_z) * c5
    w128 = (w64 * link3_omega_y + w52 * link3_omega_z) * c5
    w129 = (w66 * link3_omega_y + w56 * link3_omega_z) * c5
    w130 = w127 * link2_end_x
    w131 = w128 * link2_end_x
    w132 = w129 * link2_end_x
    w133 = link3_omega_z * c35
    w134 = link3_omega_y * c34
    w135 = 1.0 - (w55 + w63)
    w136 = 2 * link3_omega_y
    w137 = (w61 * link3_omega_x - w135 * w136) * c5
    w138 = w58 + w60
    w139 = (w64 * link3_omega_x - w136 * w138) * c5
    w140 = w45 - w47
    w141 = (w66 * link3_omega_x - w136 * w140) * c5
    w142 = w137 * link2_end_x
    w143 = w139 * link2_end_x
    w144 = w141 * link2_end_x
    w145 = link3_omega_x * c36
    w146 = 2 * link3_omega_z
    w147 = (w48 * link3_omega_x - w135 * w146) * c5
    w148 = (w52 * link3_omega_x - w138 * w146) * c5
    w149 = (w56 * link3_omega_x - w140 * w146) * c5
    w150 = w147 * link2_end_x
    w151 = w148 * link2_end_x
    w152 = w149 * link2_end_x
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.turn_x
            0.0, w0 - link1_omega_z * c24, link1_omega_y * c25 - w1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ),
        ca.horzcat(  # link1.turn_y
            link1_omega_z * c55 - w0, 0.0, w68 - link1_omega_x * c25, w86 * w88 + w89 * w91 + w92 * w94,
            w86 * w106 + w89 * w109 + w92 * w112, w86 * w119 + w89 * w121 + w92 * w123,
            w86 * w127 + w89 * w128 + w92 * w129, w86 * w137 + w89 * w139 + w92 * w141,
            w86 * w147 + w89 * w148 + w92 * w149,
        ),
        ca.horzcat(  # link1.turn_z
            w1 - link1_omega_y * c55, link1_omega_x * c24 - w68, 0.0, -(w88 * w95 + w91 * w96 + w94 * w97),
            -(w95 * w106 + w96 * w109 + w97 * w112), -(w95 * w119 + w96 * w121 + w97 * w123),
            -(w95 * w127 + w96 * w128 + w97 * w129), -(w95 * w137 + w96 * w139 + w97 * w141),
            -(w95 * w147 + w96 * w148 + w97 * w149),
        ),
        ca.horzcat(  # link2.turn_x
            0.0, 0.0, 0.0, 0.0, w98 - link2_omega_z * c31, link2_omega_y * c32 - w99, 0.0, 0.0, 0.0,
        ),
        ca.horzcat(  # link2.turn_y
            w6 * w17 + w20 * w28 + w31 * w36, w6 * w72 + w20 * w75 + w31 * w78, w6 * w81 + w20 * w83 + w31 * w85,
            link2_omega_z * c56 - w98, 0.0, w113 - link2_omega_x * c32, w6 * w130 + w20 * w131 + w31 * w132,
            w6 * w142 + w20 * w143 + w31 * w144, w6 * w150 + w20 * w151 + w31 * w152,
        ),
        ca.horzcat(  # link2.turn_z
            -(w17 * w40 + w28 * w42 + w36 * w43), -(w40 * w72 + w42 * w75 + w43 * w78),
            -(w40 * w81 + w42 * w83 + w43 * w85), w99 - link2_omega_y * c56, link2_omega_x * c31 - w113, 0.0,
            -(w40 * w130 + w42 * w131 + w43 * w132), -(w40 * w142 + w42 * w143 + w43 * w144),
            -(w40 * w150 + w42 * w151 + w43 * w152),
        ),
        ca.horzcat(  # link3.turn_x
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, w133 - link3_omega_z * c34, link3_omega_y * c35 - w134,
        ),
        ca.horzcat(  # link3.turn_y
            w16 * w49 + w27 * w53 + w35 * w57, w49 * w71 + w53 * w74 + w57 * w77, w49 * w80 + w53 * w82 + w57 * w84,
            w49 * w100 + w53 * w101 + w57 * w102, w49 * w114 + w53 * w115 + w57 * w116,
            w49 * w124 + w53 * w125 + w57 * w126, link3_omega_z * c36 - w133, 0.0, w145 - link3_omega_x * c35,
        ),
        ca.horzcat(  # link3.turn_z
            -(w16 * w62 + w27 * w65 + w35 * w67), -(w62 * w71 + w65 * w74 + w67 * w77),
            -(w62 * w80 + w65 * w82 + w67 * w84), -(w62 * w100 + w65 * w101 + w67 * w102),
            -(w62 * w114 + w65 * w115 + w67 * w116), -(w62 * w124 + w65 * w125 + w67 * w126),
            w134 - link3_omega_y * c36, link3_omega_x * c34 - w145, 0.0,
        ),
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 9 x 9) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1494 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    link1_turn_y_ddot = q_i_ddot[1]
    link1_turn_z_ddot = q_i_ddot[2]
    link2_turn_y_ddot = q_i_ddot[4]
    link2_turn_z_ddot = q_i_ddot[5]
    link3_turn_y_ddot = q_i_ddot[7]
    link3_turn_z_ddot = q_i_ddot[8]
    link1_end_x = c[1]
    link2_end_x = c[3]
    c4 = c[4]
    c5 = c[5]
    gravity_z = c[14]
    c15 = c[15]
    c24 = c[24]
    c25 = c[25]
    c31 = c[31]
    c32 = c[32]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c55 = c[55]
    c56 = c[56]
    # intermediate terms (418)
    w0 = link1_e2 * 4.0
    w1 = 2 * link3_e1
    w2 = w1 * link3_e2
    w3 = 2 * link3_e3
    w4 = w3 * link3_e0
    w5 = w2 - w4
    w6 = link3_omega_x * link3_omega_y + link3_turn_z_ddot
    w7 = 2 * link3_e2
    w8 = link3_e2 * w7
    w9 = link3_e3 * w3
    w10 = 1.0 - (w8 + w9)
    w11 = link3_omega_y**2 + link3_omega_z**2
    w12 = w1 * link3_e3
    w13 = link3_e0 * w7
    w14 = w12 + w13
    w15 = link3_omega_x * link3_omega_z - link3_turn_y_ddot
    w16 = (w5 * w6 - w10 * w11 + w14 * w15) * c5
    w17 = 2 * link2_e1
    w18 = w17 * link2_e2
    w19 = 2 * link2_e3
    w20 = w19 * link2_e0
    w21 = w18 - w20
    w22 = link2_omega_x * link2_omega_y + link2_turn_z_ddot
    w23 = 2 * link2_e2
    w24 = link2_e2 * w23
    w25 = link2_e3 * w19
    w26 = 1.0 - (w24 + w25)
    w27 = link2_omega_y**2 + link2_omega_z**2
    w28 = w17 * link2_e3
    w29 = link2_e0 * w23
    w30 = w28 + w29
    w31 = link2_omega_x * link2_omega_z - link2_turn_y_ddot
    w32 = w21 * w22 - w26 * w27 + w30 * w31
    w33 = w16 + w32 * c4
    w34 = 2 * link1_e0
    w35 = w34 * link1_end_x
    w36 = w33 * w35
    w37 = link3_e1 * w1
    w38 = 1.0 - (w9 + w37)
    w39 = w2 + w4
    w40 = link3_e3 * w7
    w41 = w1 * link3_e0
    w42 = w40 - w41
    w43 = (w6 * w38 - w11 * w39 + w15 * w42) * c5
    w44 = link2_e1 * w17
    w45 = 1.0 - (w25 + w44)
    w46 = w18 + w20
    w47 = link2_e3 * w23
    w48 = w17 * link2_e0
    w49 = w47 - w48
    w50 = w22 * w45 - w27 * w46 + w31 * w49
    w51 = w43 + w50 * c4
    w52 = 2 * link1_e3
    w53 = w52 * link1_end_x
    w54 = w40 + w41
    w55 = w12 - w13
    w56 = 1.0 - (w8 + w37)
    w57 = (w6 * w54 - w11 * w55 + w15 * w56) * c5
    w58 = w47 + w48
    w59 = w28 - w29
    w60 = 1.0 - (w24 + w44)
    w61 = w22 * w58 - w27 * w59 + w31 * w60
    w62 = w57 + w61 * c4
    w63 = w0 * c15 + (w36 + w51 * w53 - w62 * (w0 * link1_end_x))
    w64 = link1_e3 * 0.5
    w65 = 2 * link1_e1
    w66 = w65 * link1_end_x
    w67 = w33 * w66
    w68 = 2 * link1_e2
    w69 = w68 * link1_end_x
    w70 = w67 + w51 * w69
    w71 = link1_e2 * 0.5
    w72 = link1_e1 * 4.0
    w73 = w33 * w53
    w74 = w72 * link1_end_x
    w75 = w72 * c15 + (w73 - w35 * w51 - w62 * w74)
    w76 = link1_e0 * 0.5
    w77 = w33 * w69
    w78 = w77 - w51 * w66
    w79 = link1_e1 * 0.5
    w80 = link1_e3 * 4.0
    w81 = w62 * w69 - (w36 + w51 * (w80 * link1_end_x)) - w68 * c15
    w82 = w67 + w53 * w62 - w52 * c15
    w83 = w77 - w51 * w74 + w35 * w62 - w34 * c15
    w84 = w62 * w66 - w73 - w65 * c15
    w85 = link1_omega_x * link1_omega_y + link1_turn_z_ddot
    w86 = w65 * w85
    w87 = link1_omega_y**2 + link1_omega_z**2
    w88 = link1_omega_x * link1_omega_z - link1_turn_y_ddot
    w89 = w34 * w88
    w90 = (w86 + w0 * w87 + w89) * link1_end_x
    w91 = w90 * c4
    w92 = w52 * w88
    w93 = w65 * w87
    w94 = (w92 - w93) * link1_end_x
    w95 = w94 * c4
    w96 = w52 * w85
    w97 = w34 * w87
    w98 = (w96 + w97 - w0 * w88) * link1_end_x
    w99 = w98 * c4
    w100 = w30 * w91 + w49 * w95 + w60 * w99
    w101 = w34 * w85
    w102 = w65 * w88
    w103 = (w80 * w87 - w101 + w102) * link1_end_x
    w104 = w103 * c4
    w105 = w68 * w88
    w106 = (w105 - (w97 + w80 * w85)) * link1_end_x
    w107 = w106 * c4
    w108 = w68 * w85
    w109 = (w108 - w93) * link1_end_x
    w110 = w109 * c4
    w111 = w30 * w104 + w49 * w107 + w60 * w110
    w112 = (w92 + w108) * link1_end_x
    w113 = w112 * c4
    w114 = w68 * w87
    w115 = (w89 + (w72 * w85 + w114)) * link1_end_x
    w116 = w115 * c4
    w117 = w52 * w87
    w118 = (w101 - w117 - w72 * w88) * link1_end_x
    w119 = w118 * c4
    w120 = w30 * w113 - w49 * w116 + w60 * w119
    w121 = (w105 - w96) * link1_end_x
    w122 = w121 * c4
    w123 = (w102 + w117) * link1_end_x
    w124 = w123 * c4
    w125 = (w86 + w114) * link1_end_x
    w126 = w125 * c4
    w127 = w30 * w122 - w49 * w124 + w60 * w126
    w128 = w21 * w104 + w45 * w107 + w58 * w110
    w129 = w21 * w91 + w45 * w95 + w58 * w99
    w130 = w21 * w113 - w45 * w116 + w58 * w119
    w131 = w21 * w122 - w45 * w124 + w58 * w126
    w132 = w14 * c5
    w133 = w42 * c5
    w134 = w56 * c5
    w135 = w90 * w132 + w94 * w133 + w98 * w134
    w136 = w103 * w132 + w106 * w133 + w109 * w134
    w137 = w112 * w132 - w115 * w133 + w118 * w134
    w138 = w121 * w132 - w123 * w133 + w125 * w134
    w139 = w5 * c5
    w140 = w38 * c5
    w141 = w54 * c5
    w142 = w103 * w139 + w106 * w140 + w109 * w141
    w143 = w90 * w139 + w94 * w140 + w98 * w141
    w144 = w112 * w139 - w115 * w140 + w118 * w141
    w145 = w121 * w139 - w123 * w140 + w125 * w141
    w146 = link1_e3 * w65
    w147 = link1_e0 * w68
    w148 = w146 + w147
    w149 = w148 * link1_end_x
    w150 = w17 * w22
    w151 = link2_e2 * 4.0
    w152 = 2 * link2_e0
    w153 = w31 * w152
    w154 = w150 + w27 * w151 + w153
    w155 = w154 * c4
    w156 = link1_e3 * w68
    w157 = link1_e0 * w65
    w158 = w156 - w157
    w159 = w158 * link1_end_x
    w160 = w19 * w31
    w161 = w17 * w27
    w162 = w160 - w161
    w163 = w162 * c4
    w164 = link1_e1 * w65
    w165 = link1_e2 * w68
    w166 = 1.0 - (w164 + w165)
    w167 = w166 * link1_end_x
    w168 = w19 * w22
    w169 = w27 * w152
    w170 = w168 + w169 - w31 * w151
    w171 = w170 * c4
    w172 = w149 * w155 + w159 * w163 + w167 * w171
    w173 = link2_e3 * 0.5
    w174 = link2_e3 * 4.0
    w175 = w22 * w152
    w176 = w17 * w31
    w177 = w27 * w174 - w175 + w176
    w178 = w177 * c4
    w179 = w23 * w31
    w180 = w179 - (w169 + w22 * w174)
    w181 = w180 * c4
    w182 = w22 * w23
    w183 = w182 - w161
    w184 = w183 * c4
    w185 = w149 * w178 + w159 * w181 + w167 * w184
    w186 = link2_e2 * 0.5
    w187 = w160 + w182
    w188 = w187 * c4
    w189 = link2_e1 * 4.0
    w190 = w23 * w27
    w191 = w153 + (w22 * w189 + w190)
    w192 = w191 * c4
    w193 = w19 * w27
    w194 = w175 - w193 - w31 * w189
    w195 = w194 * c4
    w196 = w149 * w188 - w159 * w192 + w167 * w195
    w197 = link2_e0 * 0.5
    w198 = w179 - w168
    w199 = w198 * c4
    w200 = w176 + w193
    w201 = w200 * c4
    w202 = w150 + w190
    w203 = w202 * c4
    w204 = w149 * w199 - w159 * w201 + w167 * w203
    w205 = link2_e1 * 0.5
    w206 = link1_e2 * w65
    w207 = link1_e0 * w52
    w208 = w206 - w207
    w209 = w208 * link1_end_x
    w210 = link1_e3 * w52
    w211 = 1.0 - (w164 + w210)
    w212 = w211 * link1_end_x
    w213 = w156 + w157
    w214 = w213 * link1_end_x
    w215 = w178 * w209 + w181 * w212 + w184 * w214
    w216 = w155 * w209 + w163 * w212 + w171 * w214
    w217 = w188 * w209 - w192 * w212 + w195 * w214
    w218 = w199 * w209 - w201 * w212 + w203 * w214
    w219 = 1.0 - (w165 + w210)
    w220 = (w85 * w208 - w87 * w219 + w88 * w148) * link1_end_x
    w221 = w16 * link2_end_x + w220 * c4
    w222 = w152 * w221
    w223 = w206 + w207
    w224 = (w85 * w211 - w87 * w223 + w88 * w158) * link1_end_x
    w225 = w43 * link2_end_x + w224 * c4
    w226 = w146 - w147
    w227 = (w85 * w213 - w87 * w226 + w88 * w166) * link1_end_x - gravity_z
    w228 = w57 * link2_end_x + w227 * c4
    w229 = w222 + w19 * w225 - w151 * w228
    w230 = w17 * w221
    w231 = w230 + w23 * w225
    w232 = w19 * w221
    w233 = w232 - w152 * w225 - w189 * w228
    w234 = w23 * w221
    w235 = w234 - w17 * w225
    w236 = w23 * w228 - (w222 + w174 * w225)
    w237 = w230 + w19 * w228
    w238 = w234 - w189 * w225 + w152 * w228
    w239 = w17 * w228 - w232
    w240 = w154 * link2_end_x
    w241 = w162 * link2_end_x
    w242 = w170 * link2_end_x
    w243 = w132 * w240 + w133 * w241 + w134 * w242
    w244 = w177 * link2_end_x
    w245 = w180 * link2_end_x
    w246 = w183 * link2_end_x
    w247 = w132 * w244 + w133 * w245 + w134 * w246
    w248 = w187 * link2_end_x
    w249 = w191 * link2_end_x
    w250 = w194 * link2_end_x
    w251 = w132 * w248 - w133 * w249 + w134 * w250
    w252 = w198 * link2_end_x
    w253 = w200 * link2_end_x
    w254 = w202 * link2_end_x
    w255 = w132 * w252 - w133 * w253 + w134 * w254
    w256 = w139 * w244 + w140 * w245 + w141 * w246
    w257 = w139 * w240 + w140 * w241 + w141 * w242
    w258 = w139 * w248 - w140 * w249 + w141 * w250
    w259 = w139 * w252 - w140 * w253 + w141 * w254
    w260 = w1 * w6
    w261 = link3_e2 * 4.0
    w262 = 2 * link3_e0
    w263 = w15 * w262
    w264 = (w260 + w11 * w261 + w263) * c5
    w265 = w3 * w15
    w266 = w1 * w11
    w267 = (w265 - w266) * c5
    w268 = w3 * w6
    w269 = w11 * w262
    w270 = (w268 + w269 - w15 * w261) * c5
    w271 = w149 * w264 + w159 * w267 + w167 * w270
    w272 = link3_e3 * 0.5
    w273 = link3_e3 * 4.0
    w274 = w6 * w262
    w275 = w1 * w15
    w276 = (w11 * w273 - w274 + w275) * c5
    w277 = w7 * w15
    w278 = (w277 - (w269 + w6 * w273)) * c5
    w279 = w6 * w7
    w280 = (w279 - w266) * c5
    w281 = w149 * w276 + w159 * w278 + w167 * w280
    w282 = link3_e2 * 0.5
    w283 = (w265 + w279) * c5
    w284 = link3_e1 * 4.0
    w285 = w7 * w11
    w286 = (w263 + (w6 * w284 + w285)) * c5
    w287 = w3 * w11
    w288 = (w274 - w287 - w15 * w284) * c5
    w289 = w149 * w283 - w159 * w286 + w167 * w288
    w290 = link3_e0 * 0.5
    w291 = (w277 - w268) * c5
    w292 = (w275 + w287) * c5
    w293 = (w260 + w285) * c5
    w294 = w149 * w291 - w159 * w292 + w167 * w293
    w295 = link3_e1 * 0.5
    w296 = w209 * w276 + w212 * w278 + w214 * w280
    w297 = w209 * w264 + w212 * w267 + w214 * w270
    w298 = w209 * w283 - w212 * w286 + w214 * w288
    w299 = w209 * w291 - w212 * w292 + w214 * w293
    w300 = w264 * link2_end_x
    w301 = w267 * link2_end_x
    w302 = w270 * link2_end_x
    w303 = w30 * w300 + w49 * w301 + w60 * w302
    w304 = w276 * link2_end_x
    w305 = w278 * link2_end_x
    w306 = w280 * link2_end_x
    w307 = w30 * w304 + w49 * w305 + w60 * w306
    w308 = w283 * link2_end_x
    w309 = w286 * link2_end_x
    w310 = w288 * link2_end_x
    w311 = w30 * w308 - w49 * w309 + w60 * w310
    w312 = w291 * link2_end_x
    w313 = w292 * link2_end_x
    w314 = w293 * link2_end_x
    w315 = w30 * w312 - w49 * w313 + w60 * w314
    w316 = w21 * w304 + w45 * w305 + w58 * w306
    w317 = w21 * w300 + w45 * w301 + w58 * w302
    w318 = w21 * w308 - w45 * w309 + w58 * w310
    w319 = w21 * w312 - w45 * w313 + w58 * w314
    w320 = w220 + w32 * link2_end_x
    w321 = w262 * c5
    w322 = w320 * w321
    w323 = w224 + w50 * link2_end_x
    w324 = w3 * c5
    w325 = w227 + w61 * link2_end_x
    w326 = w322 + w323 * w324 - w325 * (w261 * c5)
    w327 = w1 * c5
    w328 = w320 * w327
    w329 = w7 * c5
    w330 = w328 + w323 * w329
    w331 = w320 * w324
    w332 = w284 * c5
    w333 = w331 - w321 * w323 - w325 * w332
    w334 = w320 * w329
    w335 = w334 - w323 * w327
    w336 = w325 * w329 - (w322 + w323 * (w273 * c5))
    w337 = w328 + w324 * w325
    w338 = w334 - w323 * w332 + w321 * w325
    w339 = w325 * w327 - w331
    w340 = link1_omega_z * c25
    w341 = link1_omega_y * c24
    w342 = (link1_omega_y * w208 + link1_omega_z * w148) * link1_end_x
    w343 = w342 * c4
    w344 = (link1_omega_y * w211 + link1_omega_z * w158) * link1_end_x
    w345 = w344 * c4
    w346 = (link1_omega_y * w213 + link1_omega_z * w166) * link1_end_x
    w347 = w346 * c4
    w348 = link1_omega_x * c55
    w349 = 2 * link1_omega_y
    w350 = (link1_omega_x * w208 - w219 * w349) * link1_end_x
    w351 = w350 * c4
    w352 = (link1_omega_x * w211 - w223 * w349) * link1_end_x
    w353 = w352 * c4
    w354 = (link1_omega_x * w213 - w226 * w349) * link1_end_x
    w355 = w354 * c4
    w356 = 2 * link1_omega_z
    w357 = (link1_omega_x * w148 - w219 * w356) * link1_end_x
    w358 = w357 * c4
    w359 = (link1_omega_x * w158 - w223 * w356) * link1_end_x
    w360 = w359 * c4
    w361 = (link1_omega_x * w166 - w226 * w356) * link1_end_x
    w362 = w361 * c4
    w363 = w21 * link2_omega_y + link2_omega_z * w30
    w364 = w363 * c4
    w365 = link2_omega_y * w45 + link2_omega_z * w49
    w366 = w365 * c4
    w367 = link2_omega_y * w58 + link2_omega_z * w60
    w368 = w367 * c4
    w369 = link2_omega_z * c32
    w370 = link2_omega_y * c31
    w371 = w363 * link2_end_x
    w372 = w365 * link2_end_x
    w373 = w367 * link2_end_x
    w374 = 2 * link2_omega_y
    w375 = w21 * link2_omega_x - w26 * w374
    w376 = w375 * c4
    w377 = link2_omega_x * w45 - w46 * w374
    w378 = w377 * c4
    w379 = link2_omega_x * w58 - w59 * w374
    w380 = w379 * c4
    w381 = link2_omega_x * c56
    w382 = w375 * link2_end_x
    w383 = w377 * link2_end_x
    w384 = w379 * link2_end_x
    w385 = 2 * link2_omega_z
    w386 = link2_omega_x * w30 - w26 * w385
    w387 = w386 * c4
    w388 = link2_omega_x * w49 - w46 * w385
    w389 = w388 * c4
    w390 = link2_omega_x * w60 - w59 * w385
    w391 = w390 * c4
    w392 = w386 * link2_end_x
    w393 = w388 * link2_end_x
    w394 = w390 * link2_end_x
    w395 = (w5 * link3_omega_y + link3_omega_z * w14) * c5
    w396 = (link3_omega_y * w38 + link3_omega_z * w42) * c5
    w397 = (link3_omega_y * w54 + link3_omega_z * w56) * c5
    w398 = w395 * link2_end_x
    w399 = w396 * link2_end_x
    w400 = w397 * link2_end_x
    w401 = link3_omega_z * c35
    w402 = link3_omega_y * c34
    w403 = 2 * link3_omega_y
    w404 = (w5 * link3_omega_x - w10 * w403) * c5
    w405 = (link3_omega_x * w38 - w39 * w403) * c5
    w406 = (link3_omega_x * w54 - w55 * w403) * c5
    w407 = w404 * link2_end_x
    w408 = w405 * link2_end_x
    w409 = w406 * link2_end_x
    w410 = link3_omega_x * c36
    w411 = 2 * link3_omega_z
    w412 = (link3_omega_x * w14 - w10 * w411) * c5
    w413 = (link3_omega_x * w42 - w39 * w411) * c5
    w414 = (link3_omega_x * w56 - w55 * w411) * c5
    w415 = w412 * link2_end_x
    w416 = w413 * link2_end_x
    w417 = w414 * link2_end_x
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.turn_x
        ca.horzcat(  # link1.turn_y
            w63 * w64 - w70 * w71 + w75 * w76 - w78 * w79, w70 * w79 + w63 * w76 - w64 * w75 - w71 * w78,
            w70 * w76 - w63 * w79 + w71 * w75 - w64 * w78, w172 * w173 - w185 * w186 + w196 * w197 - w204 * w205,
            w185 * w205 + w172 * w197 - w173 * w196 - w186 * w204,
            w185 * w197 - w172 * w205 + w186 * w196 - w173 * w204,
            w271 * w272 - w281 * w282 + w289 * w290 - w294 * w295,
            w281 * w295 + w271 * w290 - w272 * w289 - w282 * w294,
            w281 * w290 - w271 * w295 + w282 * w289 - w272 * w294,
        ),
        ca.horzcat(  # link1.turn_z
            w71 * w81 - w64 * w82 - w76 * w83 + w79 * w84, w64 * w83 - (w76 * w82 + w79 * w81) + w71 * w84,
            w64 * w84 - (w76 * w81 - w79 * w82 + w71 * w83), w186 * w215 - w173 * w216 - w197 * w217 + w205 * w218,
            w173 * w217 - (w205 * w215 + w197 * w216) + w186 * w218,
            w205 * w216 - w197 * w215 - w186 * w217 + w173 * w218,
            w282 * w296 - w272 * w297 - w290 * w298 + w295 * w299,
            w272 * w298 - (w295 * w296 + w290 * w297) + w282 * w299,
            w295 * w297 - w290 * w296 - w282 * w298 + w272 * w299,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link2.turn_x
        ca.horzcat(  # link2.turn_y
            w64 * w100 - w71 * w111 + w76 * w120 - w79 * w127, w79 * w111 + w76 * w100 - w64 * w120 - w71 * w127,
            w76 * w111 - w79 * w100 + w71 * w120 - w64 * w127,
            w173 * w229 - w186 * w231 + w197 * w233 - w205 * w235,
            w205 * w231 + w197 * w229 - w173 * w233 - w186 * w235,
            w197 * w231 - w205 * w229 + w186 * w233 - w173 * w235,
            w272 * w303 - w282 * w307 + w290 * w311 - w295 * w315,
            w295 * w307 + w290 * w303 - w272 * w311 - w282 * w315,
            w290 * w307 - w295 * w303 + w282 * w311 - w272 * w315,
        ),
        ca.horzcat(  # link2.turn_z
            w71 * w128 - w64 * w129 - w76 * w130 + w79 * w131, w64 * w130 - (w79 * w128 + w76 * w129) + w71 * w131,
            w79 * w129 - w76 * w128 - w71 * w130 + w64 * w131,
            w186 * w236 - w173 * w237 - w197 * w238 + w205 * w239,
            w173 * w238 - (w197 * w237 + w205 * w236) + w186 * w239,
            w173 * w239 - (w197 * w236 - w205 * w237 + w186 * w238),
            w282 * w316 - w272 * w317 - w290 * w318 + w295 * w319,
            w272 * w318 - (w295 * w316 + w290 * w317) + w282 * w319,
            w295 * w317 - w290 * w316 - w282 * w318 + w272 * w319,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link3.turn_x
        ca.horzcat(  # link3.turn_y
            w64 * w135 - w71 * w136 + w76 * w137 - w79 * w138, w79 * w136 + w76 * w135 - w64 * w137 - w71 * w138,
            w76 * w136 - w79 * w135 + w71 * w137 - w64 * w138,
            w173 * w243 - w186 * w247 + w197 * w251 - w205 * w255,
            w205 * w247 + w197 * w243 - w173 * w251 - w186 * w255,
            w197 * w247 - w205 * w243 + w186 * w251 - w173 * w255,
            w272 * w326 - w282 * w330 + w290 * w333 - w295 * w335,
            w295 * w330 + w290 * w326 - w272 * w333 - w282 * w335,
            w290 * w330 - w295 * w326 + w282 * w333 - w272 * w335,
        ),
        ca.horzcat(  # link3.turn_z
            w71 * w142 - w64 * w143 - w76 * w144 + w79 * w145, w64 * w144 - (w79 * w142 + w76 * w143) + w71 * w145,
            w79 * w143 - w76 * w142 - w71 * w144 + w64 * w145,
            w186 * w256 - w173 * w257 - w197 * w258 + w205 * w259,
            w173 * w258 - (w205 * w256 + w197 * w257) + w186 * w259,
            w205 * w257 - w197 * w256 - w186 * w258 + w173 * w259,
            w282 * w336 - w272 * w337 - w290 * w338 + w295 * w339,
            w272 * w338 - (w290 * w337 + w295 * w336) + w282 * w339,
            w272 * w339 - (w290 * w336 - w295 * w337 + w282 * w338),
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # link1.turn_x
            0.0, w340 - link1_omega_z * c24, link1_omega_y * c25 - w341, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ),
        ca.horzcat(  # link1.turn_y
            link1_omega_z * c55 - w340, 0.0, w348 - link1_omega_x * c25, w149 * w364 + w159 * w366 + w167 * w368,
            w149 * w376 + w159 * w378 + w167 * w380, w149 * w387 + w159 * w389 + w167 * w391,
            w149 * w395 + w159 * w396 + w167 * w397, w149 * w404 + w159 * w405 + w167 * w406,
            w149 * w412 + w159 * w413 + w167 * w414,
        ),
        ca.horzcat(  # link1.turn_z
            w341 - link1_omega_y * c55, link1_omega_x * c24 - w348, 0.0, -(w209 * w364 + w212 * w366 + w214 * w368),
            -(w209 * w376 + w212 * w378 + w214 * w380), -(w209 * w387 + w212 * w389 + w214 * w391),
            -(w209 * w395 + w212 * w396 + w214 * w397), -(w209 * w404 + w212 * w405 + w214 * w406),
            -(w209 * w412 + w212 * w413 + w214 * w414),
        ),
        ca.horzcat(  # link2.turn_x
            0.0, 0.0, 0.0, 0.0, w369 - link2_omega_z * c31, link2_omega_y * c32 - w370, 0.0, 0.0, 0.0,
        ),
        ca.horzcat(  # link2.turn_y
            w30 * w343 + w49 * w345 + w60 * w347, w30 * w351 + w49 * w353 + w60 * w355,
            w30 * w358 + w49 * w360 + w60 * w362, link2_omega_z * c56 - w369, 0.0, w381 - link2_omega_x * c32,
            w30 * w398 + w49 * w399 + w60 * w400, w30 * w407 + w49 * w408 + w60 * w409,
            w30 * w415 + w49 * w416 + w60 * w417,
        ),
        ca.horzcat(  # link2.turn_z
            -(w21 * w343 + w45 * w345 + w58 * w347), -(w21 * w351 + w45 * w353 + w58 * w355),
            -(w21 * w358 + w45 * w360 + w58 * w362), w370 - link2_omega_y * c56, link2_omega_x * c31 - w381, 0.0,
            -(w21 * w398 + w45 * w399 + w58 * w400), -(w21 * w407 + w45 * w408 + w58 * w409),
            -(w21 * w415 + w45 * w416 + w58 * w417),
        ),
        ca.horzcat(  # link3.turn_x
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, w401 - link3_omega_z * c34, link3_omega_y * c35 - w402,
        ),
        ca.horzcat(  # link3.turn_y
            w132 * w342 + w133 * w344 + w134 * w346, w132 * w350 + w133 * w352 + w134 * w354,
            w132 * w357 + w133 * w359 + w134 * w361, w132 * w371 + w133 * w372 + w134 * w373,
            w132 * w382 + w133 * w383 + w134 * w384, w132 * w392 + w133 * w393 + w134 * w394,
            link3_omega_z * c36 - w401, 0.0, w410 - link3_omega_x * c35,
        ),
        ca.horzcat(  # link3.turn_z
            -(w139 * w342 + w140 * w344 + w141 * w346), -(w139 * w350 + w140 * w352 + w141 * w354),
            -(w139 * w357 + w140 * w359 + w141 * w361), -(w139 * w371 + w140 * w372 + w141 * w373),
            -(w139 * w382 + w140 * w383 + w141 * w384), -(w139 * w392 + w140 * w393 + w141 * w394),
            w402 - link3_omega_y * c36, link3_omega_x * c34 - w410, 0.0,
        ),
    )
    inputs, outputs = [q_d, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_d", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_d (n_d = 21) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    436 operations.
    """
    q_d = ca.SX.sym("q_d", 21)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 62)
    link1_e0 = q_d[3]
    link1_e1 = q_d[4]
    link1_e2 = q_d[5]
    link1_e3 = q_d[6]
    link2_e0 = q_d[10]
    link2_e1 = q_d[11]
    link2_e2 = q_d[12]
    link2_e3 = q_d[13]
    link3_e0 = q_d[17]
    link3_e1 = q_d[18]
    link3_e2 = q_d[19]
    link3_e3 = q_d[20]
    link1_omega_x = q_i_dot[0]
    link1_omega_y = q_i_dot[1]
    link1_omega_z = q_i_dot[2]
    link2_omega_x = q_i_dot[3]
    link2_omega_y = q_i_dot[4]
    link2_omega_z = q_i_dot[5]
    link3_omega_x = q_i_dot[6]
    link3_omega_y = q_i_dot[7]
    link3_omega_z = q_i_dot[8]
    c0 = c[0]
    link1_end_x = c[1]
    c2 = c[2]
    link2_end_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    gravity_z = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c19 = c[19]
    c21 = c[21]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (147)
    w0 = 2 * link1_e1
    w1 = w0 * link1_e3
    w2 = 2 * link1_e2
    w3 = w2 * link1_e0
    w4 = w1 + w3
    w5 = w4 * link1_end_x
    w6 = 2 * link3_e1
    w7 = w6 * link3_e3
    w8 = 2 * link3_e2
    w9 = w8 * link3_e0
    w10 = w7 + w9
    w11 = w10 * c5
    w12 = link1_e3 * w2
    w13 = w0 * link1_e0
    w14 = w12 - w13
    w15 = w14 * link1_end_x
    w16 = link3_e3 * w8
    w17 = w6 * link3_e0
    w18 = w16 - w17
    w19 = w18 * c5
    w20 = link1_e1 * w0
    w21 = link1_e2 * w2
    w22 = 1.0 - (w20 + w21)
    w23 = w22 * link1_end_x
    w24 = link3_e1 * w6
    w25 = link3_e2 * w8
    w26 = 1.0 - (w24 + w25)
    w27 = w26 * c5
    w28 = w5 * w11 + w15 * w19 + w23 * w27
    w29 = w28 / c11
    w30 = link3_omega_x * link3_omega_z
    w31 = w0 * link1_e2
    w32 = 2 * link1_e3
    w33 = link1_e0 * w32
    w34 = w31 - w33
    w35 = link1_omega_y * link1_omega_x
    w36 = link1_e3 * w32
    w37 = link1_omega_y**2 + link1_omega_z**2
    w38 = link1_omega_z * link1_omega_x
    w39 = (w34 * w35 - (1.0 - (w21 + w36)) * w37 + w4 * w38) * link1_end_x
    w40 = 2 * link2_e1
    w41 = w40 * link2_e2
    w42 = 2 * link2_e3
    w43 = w42 * link2_e0
    w44 = w41 - w43
    w45 = link2_omega_x * link2_omega_y
    w46 = 2 * link2_e2
    w47 = link2_e2 * w46
    w48 = link2_e3 * w42
    w49 = link2_omega_y**2 + link2_omega_z**2
    w50 = w40 * link2_e3
    w51 = link2_e0 * w46
    w52 = w50 + w51
    w53 = link2_omega_x * link2_omega_z
    w54 = w44 * w45 - (1.0 - (w47 + w48)) * w49 + w52 * w53
    w55 = w39 + w54 * link2_end_x
    w56 = 1.0 - (w20 + w36)
    w57 = (w35 * w56 - w37 * (w31 + w33) + w14 * w38) * link1_end_x
    w58 = link2_e1 * w40
    w59 = 1.0 - (w48 + w58)
    w60 = link2_e3 * w46
    w61 = w40 * link2_e0
    w62 = w60 - w61
    w63 = w45 * w59 - w49 * (w41 + w43) + w53 * w62
    w64 = w57 + w63 * link2_end_x
    w65 = w12 + w13
    w66 = (w35 * w65 - w37 * (w1 - w3) + w22 * w38) * link1_end_x - gravity_z
    w67 = w60 + w61
    w68 = 1.0 - (w47 + w58)
    w69 = w45 * w67 - w49 * (w50 - w51) + w53 * w68
    w70 = w66 + w69 * link2_end_x
    w71 = w30 * c21 - (w11 * w55 + w19 * w64 + w27 * w70)
    w72 = w6 * link3_e2
    w73 = 2 * link3_e3
    w74 = link3_e0 * w73
    w75 = w72 - w74
    w76 = link3_omega_x * link3_omega_y
    w77 = link3_e3 * w73
    w78 = link3_omega_y**2 + link3_omega_z**2
    w79 = (w75 * w76 - (1.0 - (w25 + w77)) * w78 + w10 * w30) * c5
    w80 = w79 + w54 * c4
    w81 = 1.0 - (w24 + w77)
    w82 = (w76 * w81 - w78 * (w72 + w74) + w18 * w30) * c5
    w83 = w82 + w63 * c4
    w84 = w16 + w17
    w85 = (w76 * w84 - w78 * (w7 - w9) + w26 * w30) * c5
    w86 = w85 + w69 * c4
    w87 = w75 * c5
    w88 = w81 * c5
    w89 = w84 * c5
    w90 = w5 * w87 + w15 * w88 + w23 * w89
    w91 = w90 / c12
    w92 = w76 * c61 + (w55 * w87 + w64 * w88 + w70 * w89)
    w93 = w44 * link2_end_x
    w94 = w59 * link2_end_x
    w95 = w67 * link2_end_x
    w96 = w87 * w93 + w88 * w94 + w89 * w95
    w97 = w44 * c4
    w98 = w59 * c4
    w99 = w67 * c4
    w100 = w11 * w93 + w19 * w94 + w27 * w95
    w101 = w91 * w96 - (w5 * w97 + w15 * w98 + w23 * w99) + w29 * w100
    w102 = w96 / c12
    w103 = w100 / c11
    w104 = c9 - w96 * w102 - w100 * w103
    w105 = w101 / w104
    w106 = w79 * link2_end_x + w39 * c4
    w107 = w82 * link2_end_x + w57 * c4
    w108 = w85 * link2_end_x + w66 * c4
    w109 = w92 * w102 - (w45 * c59 + (w44 * w106 + w59 * w107 + w67 * w108)) - w71 * w103
    w110 = w29 * w71 - (w22 * c15 + w38 * c16 - (w5 * w80 + w15 * w83 + w23 * w86) + w91 * w92) - w105 * w109
    w111 = w52 * c4
    w112 = w62 * c4
    w113 = w68 * c4
    w114 = w52 * link2_end_x
    w115 = w62 * link2_end_x
    w116 = w68 * link2_end_x
    w117 = w87 * w114 + w88 * w115 + w89 * w116
    w118 = w11 * w114 + w19 * w115 + w27 * w116
    w119 = w117 / c12
    w120 = w118 / c11
    w121 = w96 * w119 + w100 * w120
    w122 = w5 * w111 + w15 * w112 + w23 * w113 - w91 * w117 - w29 * w118 - w105 * w121
    w123 = w121 / w104
    w124 = c8 - w117 * w119 - w118 * w120 - w121 * w123
    w125 = w122 / w124
    w126 = w71 * w120 - (w53 * c19 - (w52 * w106 + w62 * w107 + w68 * w108) + w92 * w119) - w109 * w123
    w127 = w34 * link1_end_x
    w128 = w56 * link1_end_x
    w129 = w65 * link1_end_x
    w130 = w87 * w127 + w88 * w128 + w89 * w129
    w131 = w11 * w127 + w19 * w128 + w27 * w129
    w132 = w130 / c12
    w133 = w131 / c11
    w134 = w97 * w127 + w98 * w128 + w99 * w129 - w96 * w132 - w100 * w133
    w135 = w134 / w104
    w136 = w117 * w132 - (w111 * w127 + w112 * w128 + w113 * w129) + w118 * w133 - w121 * w135
    w137 = w91 * w130 + w29 * w131 - w105 * w134 - w125 * w136
    w138 = w136 / w124
    w139 = c6 - w130 * w132 - w131 * w133 - w134 * w135 - w136 * w138
    w140 = w137 / w139
    w141 = w92 * w132 - (w35 * c17 - w65 * c15 + (w80 * w127 + w83 * w128 + w86 * w129)) - w71 * w133 - w109 * w135
    w142 = w141 - w126 * w138
    w143 = (w110 - w125 * w126 - w140 * w142) / (c2 - w90 * w91 - w28 * w29 - w101 * w105 - w122 * w125 - w137 * w140)
    w144 = w142 / w139 - w140 * w143
    w145 = w126 / w124 - w125 * w143 - w138 * w144
    w146 = w109 / w104 - w105 * w143 - w135 * w144 - w123 * w145
    # outputs
    q_i_ddot = ca.vertcat(
        -(link1_omega_y * link1_omega_z * c57 / c0),  # link1.turn_x
        w143,  # link1.turn_y
        w144,  # link1.turn_z
        -(link2_omega_y * link2_omega_z * c58 / c7),  # link2.turn_x
        w145,  # link2.turn_y
        w146,  # link2.turn_z
        -(link3_omega_z * link3_omega_y * c60 / c10),  # link3.turn_x
        w133 * w144 - (w71 / c11 + w29 * w143) - w120 * w145 + w103 * w146,  # link3.turn_y
        w91 * w143 - w92 / c12 - w132 * w144 + w119 * w145 - w102 * w146,  # link3.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_d", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 19) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 7) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 7) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 19)
    link1_end_x = p[16]
    link2_end_x = p[17]
    link3_end_x = p[18]
    # outputs
    positions = ca.SX(3, 7)
    positions[0, 2] = link1_end_x
    positions[0, 4] = link2_end_x
    positions[0, 6] = link3_end_x
    axes = ca.SX(9, 7)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
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
