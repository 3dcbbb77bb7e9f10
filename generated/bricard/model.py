"""Bricard mechanism: equations of motion, emitted by symgen from the scene `bricard`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 hinge0.angle [rad]

q_d, the dependent coordinates by index:
    0 bar1.x [m], 1 bar1.y [m], 2 bar1.z [m], 3 bar1.e0 [1], 4 bar1.e1 [1], 5 bar1.e2 [1], 6 bar1.e3 [1],
    7 bar2.x [m], 8 bar2.y [m], 9 bar2.z [m], 10 bar2.e0 [1], 11 bar2.e1 [1], 12 bar2.e2 [1],
    13 bar2.e3 [1], 14 bar3.x [m], 15 bar3.y [m], 16 bar3.z [m], 17 bar3.e0 [1], 18 bar3.e1 [1],
    19 bar3.e2 [1], 20 bar3.e3 [1], 21 bar4.x [m], 22 bar4.y [m], 23 bar4.z [m], 24 bar4.e0 [1],
    25 bar4.e1 [1], 26 bar4.e2 [1], 27 bar4.e3 [1], 28 bar5.x [m], 29 bar5.y [m], 30 bar5.z [m],
    31 bar5.e0 [1], 32 bar5.e1 [1], 33 bar5.e2 [1], 34 bar5.e3 [1], 35 hinge1.angle [rad],
    36 hinge2.angle [rad], 37 hinge4.angle [rad], 38 hinge5.angle [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 48) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    165 operations.
    """
    p = ca.SX.sym("p", 48)
    gravity_y = p[0]
    bar1_mass = p[1]
    bar1_center_of_mass_x = p[2]
    bar1_inertia_xx = p[3]
    bar1_inertia_yy = p[4]
    bar1_inertia_zz = p[5]
    bar2_mass = p[6]
    bar2_center_of_mass_y = p[7]
    bar2_inertia_xx = p[8]
    bar2_inertia_yy = p[9]
    bar2_inertia_zz = p[10]
    bar3_mass = p[11]
    bar3_center_of_mass_z = p[12]
    bar3_inertia_xx = p[13]
    bar3_inertia_yy = p[14]
    bar3_inertia_zz = p[15]
    bar4_mass = p[16]
    bar4_center_of_mass_x = p[17]
    bar4_inertia_xx = p[18]
    bar4_inertia_yy = p[19]
    bar4_inertia_zz = p[20]
    bar5_mass = p[21]
    bar5_center_of_mass_y = p[22]
    bar5_inertia_xx = p[23]
    bar5_inertia_yy = p[24]
    bar5_inertia_zz = p[25]
    ground_P0_quaternion_0_0_0 = p[26]
    ground_P0_quaternion_1_0_0 = p[27]
    bar1_start_quaternion_0_0_0 = p[28]
    bar1_start_quaternion_1_0_0 = p[29]
    bar1_end_x = p[30]
    bar2_end_quaternion_1_0_0 = p[31]
    bar2_end_quaternion_3_0_0 = p[32]
    bar2_end_y = p[33]
    bar3_start_quaternion_1_0_0 = p[34]
    bar3_start_quaternion_3_0_0 = p[35]
    bar3_end_z = p[38]
    bar4_end_x = p[41]
    bar5_end_quaternion_1_0_0 = p[42]
    bar5_end_quaternion_3_0_0 = p[43]
    bar5_end_y = p[44]
    ground_P5_quaternion_1_0_0 = p[45]
    ground_P5_quaternion_3_0_0 = p[46]
    ground_P5_z = p[47]
    # intermediate terms (68)
    w0 = (bar3_inertia_xx + bar3_inertia_yy + bar3_inertia_zz) / 2.0
    w1 = w0 - bar3_inertia_zz + bar3_mass * bar3_center_of_mass_z**2
    w2 = w0 - bar3_inertia_yy
    w3 = bar3_mass * bar3_center_of_mass_z
    w4 = (bar2_inertia_xx + bar2_inertia_yy + bar2_inertia_zz) / 2.0
    w5 = w4 - bar2_inertia_yy + bar2_mass * bar2_center_of_mass_y**2
    w6 = bar3_mass * bar2_end_y
    w7 = w4 - bar2_inertia_xx
    w8 = w0 - bar3_inertia_xx
    w9 = bar2_mass * bar2_center_of_mass_y
    w10 = (bar1_inertia_xx + bar1_inertia_yy + bar1_inertia_zz) / 2.0
    w11 = w10 - bar1_inertia_xx + bar1_mass * bar1_center_of_mass_x**2
    w12 = w10 - bar1_inertia_zz
    w13 = w4 - bar2_inertia_zz
    w14 = bar4_mass * bar4_center_of_mass_x
    w15 = w14 - bar4_end_x * bar4_mass
    w16 = (bar4_inertia_xx + bar4_inertia_yy + bar4_inertia_zz) / 2.0
    w17 = w16 - bar4_inertia_xx + bar4_mass * bar4_center_of_mass_x**2
    w18 = w17 - (bar4_end_x * w14 + bar4_end_x * w15)
    w19 = w16 - bar4_inertia_yy
    w20 = bar5_end_y * w15
    w21 = (bar5_inertia_xx + bar5_inertia_yy + bar5_inertia_zz) / 2.0
    w22 = w21 - bar5_inertia_yy + bar5_mass * bar5_center_of_mass_y**2
    w23 = bar5_mass * bar5_center_of_mass_y
    w24 = bar5_end_y * bar5_mass - w23
    w25 = bar5_end_y * bar4_mass
    w26 = w22 + (bar5_end_y * w24 - bar5_end_y * w23) + bar5_end_y * w25
    w27 = w21 - bar5_inertia_zz
    w28 = w16 - bar4_inertia_zz
    w29 = w27 + w28
    w30 = w1 + w2
    w31 = ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 + ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w32 = bar1_start_quaternion_0_0_0 * ground_P0_quaternion_1_0_0 + ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w33 = bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 + bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w34 = bar3_start_quaternion_1_0_0 * bar2_end_quaternion_3_0_0 + bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w35 = ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 + ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w36 = bar5_end_quaternion_1_0_0 * ground_P5_quaternion_1_0_0 + ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w37 = w10 - bar1_inertia_yy
    w38 = w12 + w37
    w39 = w11 + w12
    w40 = w11 + w37
    w41 = 4.0 * w39
    w42 = 4.0 * w40
    w43 = 4.0 * w38
    w44 = w5 + w13
    w45 = w7 + w13
    w46 = w5 + w7
    w47 = 4.0 * w45
    w48 = 4.0 * w46
    w49 = 4.0 * w44
    w50 = w1 + w8
    w51 = w2 + w8
    w52 = 4.0 * w50
    w53 = 4.0 * w51
    w54 = 4.0 * w30
    w55 = w19 + w28
    w56 = w17 + w28
    w57 = w17 + w19
    w58 = 4.0 * w56
    w59 = 4.0 * w57
    w60 = 4.0 * w55
    w61 = w22 + w27
    w62 = w21 - bar5_inertia_xx
    w63 = w27 + w62
    w64 = w22 + w62
    w65 = 4.0 * w63
    w66 = 4.0 * w64
    w67 = 4.0 * w61
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w1 - w2,  # c2
        bar2_end_y,  # bar2_end_y
        w3,  # c4
        w5 + bar2_end_y * w6,  # c5
        w7 + w8,  # c6
        bar1_end_x,  # bar1_end_x
        w6 + w9,  # c8
        2 * bar1_end_x,  # c9
        w11 + bar1_end_x * (bar1_end_x * (bar3_mass + bar2_mass)) + (w12 + w13),  # c10
        bar3_end_z,  # bar3_end_z
        bar4_end_x,  # bar4_end_x
        bar5_end_y,  # bar5_end_y
        w15,  # c14
        w18,  # c15
        w19,  # c16
        w18 - w19,  # c17
        w20,  # c18
        2 * w20,  # c19
        w26 + w29,  # c20
        w18 + w19,  # c21
        w30,  # c22
        bar2_end_y * w3,  # c23
        gravity_y,  # gravity_y
        w24 + w25,  # c25
        ground_P0_quaternion_0_0_0,  # ground_P0_quaternion_0_0_0
        bar1_start_quaternion_0_0_0,  # bar1_start_quaternion_0_0_0
        ground_P0_quaternion_1_0_0,  # ground_P0_quaternion_1_0_0
        bar1_start_quaternion_1_0_0,  # bar1_start_quaternion_1_0_0
        w31,  # c30
        w32,  # c31
        ground_P5_z,  # ground_P5_z
        bar2_end_quaternion_1_0_0,  # bar2_end_quaternion_1_0_0
        bar3_start_quaternion_1_0_0,  # bar3_start_quaternion_1_0_0
        bar2_end_quaternion_3_0_0,  # bar2_end_quaternion_3_0_0
        bar3_start_quaternion_3_0_0,  # bar3_start_quaternion_3_0_0
        w33,  # c37
        w34,  # c38
        ground_P5_quaternion_3_0_0,  # ground_P5_quaternion_3_0_0
        bar5_end_quaternion_1_0_0,  # bar5_end_quaternion_1_0_0
        ground_P5_quaternion_1_0_0,  # ground_P5_quaternion_1_0_0
        bar5_end_quaternion_3_0_0,  # bar5_end_quaternion_3_0_0
        w35,  # c43
        w36,  # c44
        -bar4_end_x,  # c45
        -w31,  # c46
        -w36,  # c47
        bar3_mass,  # bar3_mass
        bar2_mass,  # bar2_mass
        w5,  # c50
        w7,  # c51
        w8,  # c52
        w9,  # c53
        bar1_mass,  # bar1_mass
        w11,  # c55
        w12,  # c56
        w13,  # c57
        bar4_mass,  # bar4_mass
        w17,  # c59
        w14,  # c60
        bar5_mass,  # bar5_mass
        w22,  # c62
        w23,  # c63
        w27,  # c64
        w28,  # c65
        bar1_mass * bar1_center_of_mass_x,  # c66
        w37,  # c67
        w38,  # c68
        w39,  # c69
        w40,  # c70
        w41 - w42,  # c71
        w42 - w43,  # c72
        w43 - w41,  # c73
        w44,  # c74
        w45,  # c75
        w46,  # c76
        w47 - w48,  # c77
        w48 - w49,  # c78
        w49 - w47,  # c79
        w50,  # c80
        w51,  # c81
        w52 - w53,  # c82
        w53 - w54,  # c83
        w54 - w52,  # c84
        w55,  # c85
        w56,  # c86
        w57,  # c87
        w58 - w59,  # c88
        w59 - w60,  # c89
        w60 - w58,  # c90
        w61,  # c91
        w62,  # c92
        w63,  # c93
        w64,  # c94
        w65 - w66,  # c95
        w66 - w67,  # c96
        w67 - w65,  # c97
        bar1_mass * gravity_y,  # c98
        bar2_mass * gravity_y,  # c99
        bar3_mass * gravity_y,  # c100
        bar4_mass * gravity_y,  # c101
        bar5_mass * gravity_y,  # c102
        -w33,  # c103
        -gravity_y,  # c104
        2 * bar3_end_z,  # c105
        4.0 * bar3_end_z,  # c106
        2.0,  # c107
        -(2 * w26 + 2 * w29),  # c108
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    636 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    hinge1_angle_dot = q_d_dot[35]
    hinge2_angle_dot = q_d_dot[36]
    hinge4_angle_dot = q_d_dot[37]
    hinge5_angle_dot = q_d_dot[38]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
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
    gravity_y = c[24]
    c25 = c[25]
    # intermediate terms (179)
    w0 = ca.cos(hinge2_angle)
    w1 = w0 * c2
    w2 = w0 * w1
    w3 = ca.sin(hinge2_angle)
    w4 = w3 * c4
    w5 = w4 * bar2_end_y
    w6 = c0 - w2 - 2 * w5 + c5
    w7 = ca.cos(hinge1_angle)
    w8 = w7 * (w7 * (w6 - c6))
    w9 = ca.sin(hinge1_angle)
    w10 = c6 + w8
    w11 = ca.cos(hinge0_angle)
    w12 = w9 * w11
    w13 = ca.sin(hinge0_angle)
    w14 = (w3 * w12 + w0 * w13) * bar3_end_z
    w15 = w12 * bar2_end_y
    w16 = w14 - w15
    w17 = w9 * w13
    w18 = w17 * bar2_end_y
    w19 = (w0 * w11 - w3 * w17) * bar3_end_z
    w20 = w18 + w19
    w21 = w11 * w16 - w13 * w20
    w22 = ca.sin(hinge5_angle)
    w23 = ca.cos(hinge4_angle)
    w24 = w23 * bar4_end_x
    w25 = w22 * w24
    w26 = w7 * w13
    w27 = ca.cos(hinge5_angle)
    w28 = w23 * w27
    w29 = w26 * w28
    w30 = w22 * w23
    w31 = w9 * w30
    w32 = w29 - w31
    w33 = w7 * w11
    w34 = w30 * w33
    w35 = ca.sin(hinge4_angle)
    w36 = w26 * w35
    w37 = w34 - w36
    w38 = w28 * w33
    w39 = w9 * w35
    w40 = w38 - w39
    w41 = w32 * w33 + w9 * w37 - w26 * w40
    w42 = w3 * w7 * bar3_end_z
    w43 = w33 * w42 + w9 * w14
    w44 = w36 - w34
    w45 = w39 - w38
    w46 = w22 * w44 + w27 * w45
    w47 = w25 * w41 - w43 * w46
    w48 = w14 * w26 + w19 * w33
    w49 = w7 * bar2_end_y
    w50 = w49 - w42
    w51 = w13 * w50
    w52 = w13 * w32 + w11 * w40
    w53 = w46 * w51 + w25 * w52
    w54 = w24 * w27
    w55 = w41 * w51 + w43 * w52
    w56 = w21 * w47 + w48 * w53 + w54 * w55
    w57 = w13 * bar1_end_x
    w58 = w20 - w57
    w59 = w9 * w19 - w26 * w42
    w60 = w22 * w35 * bar4_end_x
    w61 = w27 * w35 * bar4_end_x
    w62 = w35 * bar4_end_x
    w63 = w54 * w59 + w48 * w62
    w64 = w11 * w50
    w65 = w54 * w64 + w21 * w62
    w66 = w48 * w64 - w21 * w59
    w67 = w52 * w63 + w41 * w65 + w46 * w66
    w68 = w11 * bar1_end_x
    w69 = w16 + w68
    w70 = w51 * w63 - w43 * w65 - w25 * w66
    w71 = w31 - w29
    w72 = w27 * bar5_end_y
    w73 = w61 - w72
    w74 = w25 * w71 - w46 * w73
    w75 = w41 * w73 - w43 * w71
    w76 = w22 * bar5_end_y
    w77 = w76 - w60
    w78 = w48 * w74 - w54 * w75 + w47 * w77
    w79 = w51 * w71 + w52 * w73
    w80 = w53 * w77 - (w21 * w74 + w54 * w79)
    w81 = w21 * w75 + w48 * w79 + w55 * w77
    w82 = w64 * w78 + w59 * w80 - w62 * w81
    w83 = (w56 * w58 - w67 * w69 - w37 * w70) / w82
    w84 = w10 - (w10 - (c1 + w2)) + (w6 - w8 - w9 * (c8 - w4) * c9 + c10) + w83 * (w83 * (w35 * c19 + (c15 - w23 * (w23 * c17) + c20)))
    w85 = w59 * w77
    w86 = w64 * w77
    w87 = w52 * w85 + w41 * w86 + w66 * w71
    w88 = w51 * w85 - w43 * w86 - w66 * w73
    w89 = (w69 * w87 - w58 * w81 + w37 * w88) / w82
    w90 = w62 * w77
    w91 = w52 * w90 + w46 * w86 - w65 * w71
    w92 = w25 * w86 - w51 * w90 - w65 * w73
    w93 = (w69 * w91 - w58 * w80 - w37 * w92) / w82
    w94 = w4 * bar1_end_x - w9 * (w5 - c22)
    w95 = w41 * w90 - w46 * w85 + w63 * w71
    w96 = w43 * w90 - w25 * w85 + w63 * w73
    w97 = (w58 * w78 - w69 * w95 + w37 * w96) / w82
    w98 = w7 * (w0 * c23 - w1 * w3)
    w99 = w84 + w89 * (w89 * c21) + (w93 * (w94 + w93 * c22) + w93 * w94) + (w97 * (w97 * (w6 + c6) - w98) - w97 * w98)
    w100 = w9 * hinge0_angle_dot
    w101 = w100 * hinge1_angle_dot
    w102 = w13 * hinge1_angle_dot
    w103 = hinge0_angle_dot * w102
    w104 = w49 * w102 + w15 * hinge0_angle_dot
    w105 = w11 * hinge1_angle_dot
    w106 = w9 * hinge1_angle_dot * bar2_end_y
    w107 = w49 * w103 - hinge0_angle_dot * (w68 * hinge0_angle_dot) + (hinge0_angle_dot * w104 + w105 * w106)
    w108 = w33 * hinge2_angle_dot
    w109 = w26 * hinge2_angle_dot
    w110 = hinge2_angle_dot * (w7 * hinge1_angle_dot)
    w111 = w9 * hinge2_angle_dot
    w112 = w102 * w111 - hinge0_angle_dot * w108 - w103
    w113 = hinge0_angle_dot + w111
    w114 = w102 + w108
    w115 = w42 * w114 + w14 * w113
    w116 = w105 - w109
    w117 = w14 * w116 - w19 * w114
    w118 = w27 * hinge4_angle_dot
    w119 = hinge5_angle_dot * w118
    w120 = w22 * hinge4_angle_dot
    w121 = hinge5_angle_dot * w120
    w122 = w61 * hinge5_angle_dot + w24 * w120
    w123 = w24 * w118 - w60 * hinge5_angle_dot
    w124 = w107 + (w19 * w110 + w42 * w112) - (w113 * w115 + w116 * w117) - (w60 * w119 - w61 * w121 + (w120 * w122 + w118 * w123))
    w125 = hinge0_angle_dot * w105
    w126 = w18 * hinge0_angle_dot - w49 * w105
    w127 = w125 - (hinge0_angle_dot * w109 + w105 * w111)
    w128 = w19 * w113 + w42 * w116
    w129 = w15 * w103 - w18 * w125 + (w105 * w126 - w102 * w104) + (w14 * w112 - w19 * w127) + (w116 * w128 + w114 * w115)
    w130 = w35 * hinge4_angle_dot * bar4_end_x
    w131 = hinge5_angle_dot * (w72 * hinge5_angle_dot) - w24 * w121 - (w118 * w130 + hinge5_angle_dot * w122)
    w132 = w129 - w131
    w133 = hinge0_angle_dot * (w57 * hinge0_angle_dot) + w49 * w125 - (w102 * w106 + hinge0_angle_dot * w126)
    w134 = w120 * w130 - hinge5_angle_dot * w123 - (hinge5_angle_dot * (w76 * hinge5_angle_dot) + w24 * w119)
    w135 = w133 - (w42 * w127 + w14 * w110) + (w114 * w117 - w113 * w128) - w134
    w136 = w35 * w120 - w28 * hinge5_angle_dot
    w137 = w23 * hinge4_angle_dot
    w138 = w35 * w118 + w30 * hinge5_angle_dot
    w139 = w9 * (hinge5_angle_dot * w136 - w118 * w137) - w33 * (w120 * w136 + w118 * w138) - w26 * (hinge5_angle_dot * w138 + w120 * w137)
    w140 = w9 * w114 - w33 * w113
    w141 = w33 * w116 + w26 * w114
    w142 = w26 * w113 + w9 * w116
    w143 = w139 + w35 * (w113 * w140 - w116 * w141) - w28 * (w116 * w142 + w114 * w140) - w30 * (w114 * w141 + w113 * w142)
    w144 = w143 + w137 * (2 * -w142) - w138 * (2 * w141) + w136 * (2 * w140) + w32 * w127 + w37 * w110 + w40 * w112
    w145 = w44 * w119 - w144 - w45 * w121
    w146 = (w78 * w124 + (w59 * w74 + w62 * w75) * w132 + w95 * w135 - w96 * w145) / w82
    w147 = w7 * hinge0_angle_dot
    w148 = w0 * w147 + w3 * hinge1_angle_dot
    w149 = w100 + hinge2_angle_dot
    w150 = (w3 * w101 + w0 * w146 - hinge2_angle_dot * w148 - w148 * w149) * c1
    w151 = hinge0_angle_dot**2 * bar1_end_x
    w152 = w7 * w151 + w9 * gravity_y
    w153 = w100 * w147
    w154 = w146 - w153
    w155 = w0 * hinge1_angle_dot - w3 * w147
    w156 = w149 * w155 - (w0 * w101 - w3 * w146 - hinge2_angle_dot * w155)
    w157 = (w152 + w154 * bar2_end_y) * c4 - w156 * c0
    w158 = hinge1_angle_dot * w147
    w159 = w158 + (w132 * (w64 * w74 - w62 * w79) - w80 * w124 - w91 * w135 + w92 * w145) / w82
    w160 = w148 * w155
    w161 = w159 - w160
    w162 = w0 * ((w148**2 + w149**2) * c4) + w3 * (w161 * c4)
    w163 = 2 * w158
    w164 = w0 * (w9 * w151 - w7 * gravity_y - (w100**2 + hinge1_angle_dot**2) * bar2_end_y) + w3 * (w163 * bar2_end_y)
    w165 = w161 * c0 + (w159 + w160) * c1 - w164 * c4
    w166 = w7 * (w3 * w150 + w0 * w157 + 2 * w101 * c6) + w9 * (w162 * bar2_end_y - w165 - w163 * c5) + (w163 * c8 - w162) * bar1_end_x
    w167 = w35 * hinge5_angle_dot
    w168 = hinge4_angle_dot * w167
    w169 = (w56 * w124 + w132 * (w47 * w64 + w53 * w59 - w55 * w62) + w67 * w135 + w70 * w145) / w82
    w170 = w22 * gravity_y
    w171 = w23 * hinge5_angle_dot
    w172 = hinge4_angle_dot * w171
    w173 = w172 + (w172 + w35 * w169)
    w174 = w23 * ((w168 + (w168 - w23 * w169)) * c16) + w35 * ((w170 - w169 * bar5_end_y) * c14 - w173 * c15)
    w175 = w167 * w171
    w176 = (w81 * w124 + w132 * (w64 * w75 + w59 * w79) + w87 * w135 + w88 * w145) / w82
    w177 = (w175 + w176) * c15 - (w175 - w176) * c16 - w23 * (w27 * gravity_y - hinge5_angle_dot**2 * bar5_end_y) * c14
    w178 = w166 + w83 * (w174 - w173 * c18 + (w170 * c25 - w169 * c20)) + w89 * w177 - w93 * w165 - w97 * (w0 * w150 - w3 * w157 - w156 * c23 + (w152 * c8 + (w154 * c5 + (w146 + w153) * c6)))
    # outputs
    M_hat = ca.vertcat(w99)
    Q_hat = ca.vertcat(w178)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 39) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 4) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    420 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    bar2_end_y = c[3]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    ground_P0_quaternion_0_0_0 = c[26]
    bar1_start_quaternion_0_0_0 = c[27]
    ground_P0_quaternion_1_0_0 = c[28]
    bar1_start_quaternion_1_0_0 = c[29]
    c30 = c[30]
    c31 = c[31]
    ground_P5_z = c[32]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    # intermediate terms (128)
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 * c30
    w3 = w1 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w1 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w4 = ca.sin(w0)
    w5 = w4 * c31
    w6 = -w5
    w7 = w4 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w4 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w8 = 2 * w7
    w9 = 2 * w6
    w10 = (1.0 - (w7 * w8 - w5 * w9)) * bar1_end_x
    w11 = 2 * w3
    w12 = (w2 * w8 - w5 * w11) * bar1_end_x
    w13 = (w7 * w11 - w2 * w9) * bar1_end_x
    w14 = ca.sin(hinge1_angle)
    w15 = ca.cos(hinge2_angle)
    w16 = ca.cos(hinge0_angle)
    w17 = ca.sin(hinge2_angle)
    w18 = ca.sin(hinge0_angle)
    w19 = w14 * w18
    w20 = (w15 * w16 - w17 * w19) * bar3_end_z
    w21 = ca.cos(hinge1_angle)
    w22 = w18 * w21
    w23 = w17 * w21 * bar3_end_z
    w24 = w14 * w20 - w22 * w23
    w25 = ca.sin(hinge5_angle)
    w26 = ca.cos(hinge4_angle)
    w27 = w26 * bar4_end_x
    w28 = w25 * w27
    w29 = w25 * w26
    w30 = w14 * w29
    w31 = ca.cos(hinge5_angle)
    w32 = w26 * w31
    w33 = w22 * w32
    w34 = w30 - w33
    w35 = ca.sin(hinge4_angle)
    w36 = w31 * w35 * bar4_end_x - w31 * bar5_end_y
    w37 = w22 * w35
    w38 = w16 * w21
    w39 = w29 * w38
    w40 = w14 * w35
    w41 = w32 * w38
    w42 = w25 * (w37 - w39) + w31 * (w40 - w41)
    w43 = w28 * w34 - w36 * w42
    w44 = w35 * bar4_end_x
    w45 = w33 - w30
    w46 = w41 - w40
    w47 = w38 * w45 + w14 * (w39 - w37) - w22 * w46
    w48 = w14 * w16
    w49 = (w17 * w48 + w15 * w18) * bar3_end_z
    w50 = w23 * w38 + w14 * w49
    w51 = w36 * w47 - w34 * w50
    w52 = w21 * bar2_end_y - w23
    w53 = w36 - w52
    w54 = w22 * w49 + w20 * w38
    w55 = w27 * w31
    w56 = w25 * bar5_end_y - w25 * w35 * bar4_end_x
    w57 = w28 * w47 - w42 * w50
    w58 = w43 * w54 - w51 * w55 + w56 * w57
    w59 = w49 - w48 * bar2_end_y
    w60 = w27 + (w16 * bar1_end_x + w59)
    w61 = w44 * w56
    w62 = w24 * w56
    w63 = w24 * w55 + w44 * w54
    w64 = w20 + w19 * bar2_end_y
    w65 = w56 + ground_P5_z - (w64 - w18 * bar1_end_x)
    w66 = w35 * w38 + w14 * w32 + w22 * w29
    w67 = (w24 * w43 + w44 * w51) * w53 - w58 * w60 + (w47 * w61 - w42 * w62 + w34 * w63) * w65 - (w50 * w61 - w28 * w62 + w36 * w63) * w66
    w68 = w16 * w52
    w69 = w18 * w52
    w70 = w18 * w45 + w16 * w46
    w71 = w42 * w69 + w28 * w70
    w72 = w16 * w59 - w18 * w64
    w73 = w34 * w69 + w36 * w70
    w74 = w56 * w71 - (w43 * w72 + w55 * w73)
    w75 = w47 * w69 + w50 * w70
    w76 = w51 * w72 + w54 * w73 + w56 * w75
    w77 = w58 * w68 + w24 * w74 - w44 * w76
    w78 = hinge1_angle - w67 / w77
    w79 = w78 / 2.0
    w80 = ca.cos(w79)
    w81 = ca.sin(w79)
    w82 = w2 * w80 - w7 * w81
    w83 = w3 * w80 - w5 * w81
    w84 = w5 * w80 + w3 * w81
    w85 = -w84
    w86 = w2 * w81 + w7 * w80
    w87 = 2 * w83
    w88 = 2 * w86
    w89 = w56 * w68
    w90 = w55 * w68 + w44 * w72
    w91 = w60 * w74 + w53 * (w43 * w68 - w44 * w73) - w65 * (w61 * w70 + w42 * w89 - w34 * w90) + w66 * (w28 * w89 - w61 * w69 - w36 * w90)
    w92 = hinge2_angle - w91 / w77
    w93 = w92 / 2.0
    w94 = ca.cos(w93)
    w95 = w94 * c37
    w96 = ca.sin(w93)
    w97 = w96 * c38
    w98 = w94 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w94 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w99 = w96 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w96 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w100 = w54 * w68 - w24 * w72
    w101 = w53 * (w57 * w68 + w24 * w71 - w44 * w75) - w60 * (w57 * w72 + w54 * w71 + w55 * w75) + w65 * (w63 * w70 + w47 * w90 + w42 * w100)
    w102 = hinge5_angle - (w101 + w66 * (w63 * w69 - w50 * w90 - w28 * w100)) / w77
    w103 = w102 / 2.0
    w104 = ca.sin(w103)
    w105 = w104 * c43
    w106 = -w105
    w107 = 2 * w106
    w108 = ca.cos(w103)
    w109 = w108 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w108 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w110 = w104 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w104 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w111 = 2 * w110
    w112 = w108 * c44
    w113 = (w107 * w109 - w111 * w112) * bar5_end_y
    w114 = w60 * w76 - w53 * (w51 * w68 + w24 * w73) - w65 * (w62 * w70 + w47 * w89 + w34 * w100) - w66 * (w62 * w69 - w50 * w89 - w36 * w100)
    w115 = hinge4_angle - w114 / w77
    w116 = w115 / 2.0
    w117 = ca.cos(w116)
    w118 = ca.sin(w116)
    w119 = w109 * w117 - w105 * w118
    w120 = 2 * w119
    w121 = w110 * w117 - w112 * w118
    w122 = 2 * w121
    w123 = (1.0 - (w110 * w111 - w105 * w107)) * bar5_end_y
    w124 = -(w105 * w117 + w109 * w118)
    w125 = 2 * w124
    w126 = w112 * w117 + w110 * w118
    w127 = ground_P5_z - (w110 * (2 * w109) + w107 * w112) * bar5_end_y
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # bar1.x
        0.0,  # bar1.y
        0.0,  # bar1.z
        w2,  # bar1.e0
        w3,  # bar1.e1
        w6,  # bar1.e2
        w7,  # bar1.e3
        w10,  # bar2.x
        w12,  # bar2.y
        w13,  # bar2.z
        w82,  # bar2.e0
        w83,  # bar2.e1
        w85,  # bar2.e2
        w86,  # bar2.e3
        w10 - (w84 * w87 + w82 * w88) * bar2_end_y,  # bar3.x
        w12 + (1.0 - (w83 * w87 + w86 * w88)) * bar2_end_y,  # bar3.y
        w13 + (w86 * (2 * w85) + w82 * w87) * bar2_end_y,  # bar3.z
        w82 * w95 - (w83 * w97 - w84 * w98 + w86 * w99),  # bar3.e0
        w82 * w97 + w83 * w95 - (w84 * w99 + w86 * w98),  # bar3.e1
        w82 * w98 - w84 * w95 + (w86 * w97 - w83 * w99),  # bar3.e2
        w82 * w99 + w86 * w95 + (w83 * w98 + w84 * w97),  # bar3.e3
        (1.0 - (w119 * w120 + w121 * w122)) * c45 - w113,  # bar4.x
        (w119 * w125 + w122 * w126) * c45 - w123,  # bar4.y
        w127 - (w121 * w125 - w120 * w126) * bar4_end_x,  # bar4.z
        w126,  # bar4.e0
        w124,  # bar4.e1
        w119,  # bar4.e2
        w121,  # bar4.e3
        -w113,  # bar5.x
        -w123,  # bar5.y
        w127,  # bar5.z
        w112,  # bar5.e0
        w106,  # bar5.e1
        w109,  # bar5.e2
        w110,  # bar5.e3
        w78,  # hinge1.angle
        w92,  # hinge2.angle
        w115,  # hinge4.angle
        w102,  # hinge5.angle
    )
    C_loop = ca.vertcat(
        -w60,  # hinge3.x
        w53,  # hinge3.y
        w65,  # hinge3.z
        w66,  # hinge3.parallel_x
    )
    det_loop = ca.vertcat(w77)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    726 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar4_e0 = q_d[24]
    bar4_e1 = q_d[25]
    bar4_e2 = q_d[26]
    bar4_e3 = q_d[27]
    bar5_e0 = q_d[31]
    bar5_e1 = q_d[32]
    bar5_e2 = q_d[33]
    bar5_e3 = q_d[34]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    bar2_end_y = c[3]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    ground_P0_quaternion_0_0_0 = c[26]
    bar1_start_quaternion_0_0_0 = c[27]
    ground_P0_quaternion_1_0_0 = c[28]
    bar1_start_quaternion_1_0_0 = c[29]
    c30 = c[30]
    c31 = c[31]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (202)
    w0 = hinge0_angle / 2.0
    w1 = ca.sin(w0) / 2.0
    w2 = w1 * c30 * hinge0_angle_dot
    w3 = w1 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w1 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w4 = hinge0_angle_dot * w3
    w5 = ca.cos(w0) / 2.0
    w6 = hinge0_angle_dot * (w5 * c31)
    w7 = w5 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w5 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w8 = hinge0_angle_dot * w7
    w9 = 2 * bar1_e3
    w10 = 2 * bar1_e1
    w11 = 2 * bar1_e2
    w12 = (bar1_e3 * w10 - w11 * bar1_e0) * bar1_end_x
    w13 = 2 * -bar1_e2
    w14 = (w10 * bar1_e2 + w9 * bar1_e0) * bar1_end_x
    w15 = 2 * -bar1_e3
    w16 = w14 * w15
    w17 = 2 * bar1_e0
    w18 = w12 * w17
    w19 = 2 * -bar1_e1
    w20 = w12 * w19
    w21 = w14 * w17
    w22 = w4 * (w9 * w12 - w13 * w14) - w2 * (w12 * w13 - w16) - w6 * (w18 - w10 * w14) + w8 * (w20 - w21)
    w23 = (1.0 - (bar1_e2 * w11 + bar1_e3 * w9)) * bar1_end_x
    w24 = w13 * w23
    w25 = w17 * w23
    w26 = w4 * (w24 - w18) - w2 * (w15 * w23 - w20) - w6 * (w10 * w23 - w12 * w15) + w8 * (w25 - w11 * w12)
    w27 = w4 * (w21 - w9 * w23) - w2 * (w14 * w19 - w24) - w6 * (w16 - w25) + w8 * (w11 * w14 - w19 * w23)
    w28 = hinge1_angle / 2.0
    w29 = ca.cos(w28)
    w30 = ca.sin(w28)
    w31 = w30 / 2.0
    w32 = w29 / 2.0
    w33 = ca.cos(hinge1_angle)
    w34 = ca.sin(hinge0_angle)
    w35 = w33 * w34
    w36 = ca.sin(hinge2_angle)
    w37 = ca.sin(hinge1_angle)
    w38 = ca.cos(hinge0_angle)
    w39 = w37 * w38
    w40 = ca.cos(hinge2_angle)
    w41 = (w36 * w39 + w34 * w40) * bar3_end_z
    w42 = w33 * w38
    w43 = w34 * w37
    w44 = (w38 * w40 - w36 * w43) * bar3_end_z
    w45 = w35 * w41 + w42 * w44
    w46 = ca.sin(hinge5_angle)
    w47 = ca.cos(hinge4_angle)
    w48 = w47 * bar4_end_x
    w49 = w46 * w48
    w50 = w46 * w47
    w51 = w37 * w50
    w52 = ca.cos(hinge5_angle)
    w53 = w47 * w52
    w54 = w35 * w53
    w55 = w51 - w54
    w56 = ca.sin(hinge4_angle)
    w57 = w52 * w56 * bar4_end_x - w52 * bar5_end_y
    w58 = w35 * w56
    w59 = w42 * w50
    w60 = w37 * w56
    w61 = w42 * w53
    w62 = w46 * (w58 - w59) + w52 * (w60 - w61)
    w63 = w49 * w55 - w57 * w62
    w64 = w48 * w52
    w65 = w54 - w51
    w66 = w59 - w58
    w67 = w61 - w60
    w68 = w42 * w65 + w37 * w66 - w35 * w67
    w69 = w33 * w36 * bar3_end_z
    w70 = w42 * w69 + w37 * w41
    w71 = w57 * w68 - w55 * w70
    w72 = w46 * bar5_end_y - w46 * w56 * bar4_end_x
    w73 = w49 * w68 - w62 * w70
    w74 = w45 * w63 - w64 * w71 + w72 * w73
    w75 = w44 + w43 * bar2_end_y
    w76 = w75 - w34 * bar1_end_x
    w77 = w56 * bar4_end_x
    w78 = w72 * w77
    w79 = w37 * w44 - w35 * w69
    w80 = w72 * w79
    w81 = w64 * w79 + w45 * w77
    w82 = w41 - w39 * bar2_end_y
    w83 = w38 * bar1_end_x + w82
    w84 = w74 * w76 - (w68 * w78 - w62 * w80 + w55 * w81) * w83 + w66 * (w70 * w78 - w49 * w80 + w57 * w81)
    w85 = w33 * bar2_end_y - w69
    w86 = w38 * w85
    w87 = w34 * w85
    w88 = w34 * w65 + w38 * w67
    w89 = w62 * w87 + w49 * w88
    w90 = w38 * w82 - w34 * w75
    w91 = w55 * w87 + w57 * w88
    w92 = w72 * w89 - (w63 * w90 + w64 * w91)
    w93 = w68 * w87 + w70 * w88
    w94 = w71 * w90 + w45 * w91 + w72 * w93
    w95 = w74 * w86 + w79 * w92 - w77 * w94
    w96 = hinge0_angle_dot * (w84 / w95)
    w97 = w2 * w29 + w8 * w30 + (bar1_e0 * w31 + bar1_e3 * w32) * w96
    w98 = w4 * w29 - w6 * w30 + w96 * (bar1_e2 * w32 - bar1_e1 * w31)
    w99 = w4 * w30 + w6 * w29 + w96 * (bar1_e2 * w31 + bar1_e1 * w32)
    w100 = w8 * w29 - w2 * w30 + w96 * (bar1_e0 * w32 - bar1_e3 * w31)
    w101 = 2 * -bar2_e2
    w102 = 2 * bar2_e2
    w103 = 2 * bar2_e1
    w104 = (w102 * bar2_e3 + w103 * bar2_e0) * bar2_end_y
    w105 = 2 * -bar2_e3
    w106 = 2 * bar2_e3
    w107 = (1.0 - (bar2_e1 * w103 + bar2_e3 * w106)) * bar2_end_y
    w108 = w105 * w107
    w109 = 2 * bar2_e0
    w110 = w104 * w109
    w111 = w22 - w97 * (w101 * w104 - w108) + w98 * (w104 * w106 - w101 * w107) - w99 * (w110 - w103 * w107)
    w112 = 2 * -bar2_e1
    w113 = w104 * w112
    w114 = w107 * w109
    w115 = (bar2_e2 * w103 - bar2_e0 * w106) * bar2_end_y
    w116 = w101 * w115
    w117 = w109 * w115
    w118 = w26 - w97 * (w105 * w115 - w113) + w98 * (w116 - w110) - w99 * (w103 * w115 - w104 * w105) + w100 * (w117 - w102 * w104)
    w119 = w27 - w97 * (w107 * w112 - w116) + w98 * (w114 - w106 * w115) - w99 * (w108 - w117) + w100 * (w102 * w107 - w112 * w115)
    w120 = hinge2_angle / 2.0
    w121 = ca.cos(w120)
    w122 = w121 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w121 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w123 = w121 * c37
    w124 = ca.sin(w120)
    w125 = w124 * c38
    w126 = w124 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w124 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w127 = w124 / 2.0
    w128 = w127 * c37
    w129 = w121 / 2.0
    w130 = w129 * c38
    w131 = w127 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w127 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w132 = w129 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w129 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w133 = w72 * w86
    w134 = w64 * w86 + w77 * w90
    w135 = w83 * (w78 * w88 + w62 * w133 - w55 * w134) - w76 * w92 - w66 * (w49 * w133 - w78 * w87 - w57 * w134)
    w136 = hinge0_angle_dot * (w135 / w95)
    w137 = w99 * w122 - (w97 * w123 + w98 * w125) - w100 * w126 - (bar2_e0 * w128 + (bar2_e1 * w130 + bar2_e2 * w131 + bar2_e3 * w132)) * w136
    w138 = w98 * w123 - w97 * w125 - w99 * w126 - w100 * w122 + w136 * (bar2_e0 * w130 - bar2_e1 * w128 + (bar2_e2 * w132 - bar2_e3 * w131))
    w139 = w100 * w125 - (w97 * w122 + w98 * w126 + w99 * w123) + w136 * (bar2_e0 * w131 - bar2_e2 * w128 + (bar2_e3 * w130 - bar2_e1 * w132))
    w140 = w98 * w122 - w97 * w126 + w99 * w125 + w100 * w123 + w136 * (bar2_e0 * w132 - bar2_e3 * w128 + (bar2_e1 * w131 - bar2_e2 * w130))
    w141 = 2 * bar4_e3
    w142 = 2 * bar4_e1
    w143 = 2 * bar4_e2
    w144 = (bar4_e3 * w142 - w143 * bar4_e0) * bar4_end_x
    w145 = 2 * -bar4_e2
    w146 = (w142 * bar4_e2 + w141 * bar4_e0) * bar4_end_x
    w147 = hinge4_angle / 2.0
    w148 = ca.cos(w147)
    w149 = hinge5_angle / 2.0
    w150 = ca.cos(w149) / 2.0
    w151 = w45 * w86 - w79 * w90
    w152 = w76 * (w73 * w90 + w45 * w89 + w64 * w93) - w83 * (w81 * w88 + w68 * w134 + w62 * w151) - w66 * (w81 * w87 - w70 * w134 - w49 * w151)
    w153 = hinge0_angle_dot * (w152 / w95)
    w154 = w150 * c43 * w153
    w155 = ca.sin(w147)
    w156 = ca.sin(w149) / 2.0
    w157 = w156 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w156 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w158 = w153 * w157
    w159 = w155 / 2.0
    w160 = w148 / 2.0
    w161 = w83 * (w80 * w88 + w68 * w133 + w55 * w151) - w76 * w94 + w66 * (w80 * w87 - w70 * w133 - w57 * w151)
    w162 = hinge0_angle_dot * (w161 / w95)
    w163 = w148 * w154 + w155 * w158 + (w159 * bar5_e1 + bar5_e2 * w160) * w162
    w164 = 2 * -bar4_e3
    w165 = w146 * w164
    w166 = w150 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w150 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w167 = w153 * w166
    w168 = w153 * (w156 * c44)
    w169 = w155 * w167 - w148 * w168 + w162 * (w160 * bar5_e3 - w159 * bar5_e0)
    w170 = 2 * bar4_e0
    w171 = w144 * w170
    w172 = w148 * w158 - w154 * w155 + w162 * (bar5_e1 * w160 - w159 * bar5_e2)
    w173 = 2 * -bar4_e1
    w174 = w144 * w173
    w175 = w146 * w170
    w176 = w155 * w168 + w148 * w167 - w162 * (w160 * bar5_e0 + w159 * bar5_e3)
    w177 = (w141 * w144 - w145 * w146) * w163 - (w144 * w145 - w165) * w169 - (w171 - w142 * w146) * w172 - (w174 - w175) * w176
    w178 = 2 * -bar5_e2
    w179 = 2 * bar5_e2
    w180 = 2 * bar5_e1
    w181 = (bar5_e3 * w179 + bar5_e0 * w180) * bar5_end_y
    w182 = 2 * -bar5_e3
    w183 = 2 * bar5_e3
    w184 = (1.0 - (bar5_e1 * w180 + bar5_e3 * w183)) * bar5_end_y
    w185 = w182 * w184
    w186 = 2 * bar5_e0
    w187 = w181 * w186
    w188 = 2 * -bar5_e1
    w189 = w181 * w188
    w190 = w184 * w186
    w191 = w168 * (w178 * w181 - w185) + w154 * (w181 * w183 - w178 * w184) - w158 * (w187 - w180 * w184) - w167 * (w189 - w190)
    w192 = (1.0 - (bar4_e2 * w143 + bar4_e3 * w141)) * bar4_end_x
    w193 = w145 * w192
    w194 = w170 * w192
    w195 = w163 * (w193 - w171) - w169 * (w164 * w192 - w174) - w172 * (w142 * w192 - w144 * w164) - w176 * (w194 - w143 * w144)
    w196 = (bar5_e2 * w180 - bar5_e0 * w183) * bar5_end_y
    w197 = w178 * w196
    w198 = w186 * w196
    w199 = w168 * (w182 * w196 - w189) + w154 * (w197 - w187) - w158 * (w180 * w196 - w181 * w182) - w167 * (w198 - w179 * w181)
    w200 = w163 * (w175 - w141 * w192) - w169 * (w146 * w173 - w193) - w172 * (w165 - w194) - w176 * (w143 * w146 - w173 * w192)
    w201 = w168 * (w184 * w188 - w197) + w154 * (w190 - w183 * w196) - w158 * (w185 - w198) - w167 * (w179 * w184 - w188 * w196)
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # bar1.x
        0.0,  # bar1.y
        0.0,  # bar1.z
        -w2,  # bar1.e0
        w4,  # bar1.e1
        -w6,  # bar1.e2
        w8,  # bar1.e3
        w22,  # bar2.x
        w26,  # bar2.y
        w27,  # bar2.z
        -w97,  # bar2.e0
        w98,  # bar2.e1
        -w99,  # bar2.e2
        w100,  # bar2.e3
        w111 + w100 * (w113 - w114),  # bar3.x
        w118,  # bar3.y
        w119,  # bar3.z
        w137,  # bar3.e0
        w138,  # bar3.e1
        w139,  # bar3.e2
        w140,  # bar3.e3
        w177 + w191,  # bar4.x
        w195 + w199,  # bar4.y
        w200 + w201,  # bar4.z
        w169,  # bar4.e0
        -w163,  # bar4.e1
        w172,  # bar4.e2
        w176,  # bar4.e3
        w191,  # bar5.x
        w199,  # bar5.y
        w201,  # bar5.z
        -w168,  # bar5.e0
        -w154,  # bar5.e1
        w158,  # bar5.e2
        w167,  # bar5.e3
        w96,  # hinge1.angle
        w136,  # hinge2.angle
        w162,  # hinge4.angle
        w153,  # hinge5.angle
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 39) [mixed]: accelerations of the dependent coordinates
    1350 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar4_e0 = q_d[24]
    bar4_e1 = q_d[25]
    bar4_e2 = q_d[26]
    bar4_e3 = q_d[27]
    bar5_e0 = q_d[31]
    bar5_e1 = q_d[32]
    bar5_e2 = q_d[33]
    bar5_e3 = q_d[34]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    bar1_e0_dot = q_d_dot[3]
    bar1_e1_dot = q_d_dot[4]
    bar1_e2_dot = q_d_dot[5]
    bar1_e3_dot = q_d_dot[6]
    bar2_e0_dot = q_d_dot[10]
    bar2_e1_dot = q_d_dot[11]
    bar2_e2_dot = q_d_dot[12]
    bar2_e3_dot = q_d_dot[13]
    bar4_e0_dot = q_d_dot[24]
    bar4_e1_dot = q_d_dot[25]
    bar4_e2_dot = q_d_dot[26]
    bar4_e3_dot = q_d_dot[27]
    bar5_e0_dot = q_d_dot[31]
    bar5_e1_dot = q_d_dot[32]
    bar5_e2_dot = q_d_dot[33]
    bar5_e3_dot = q_d_dot[34]
    hinge1_angle_dot = q_d_dot[35]
    hinge2_angle_dot = q_d_dot[36]
    hinge4_angle_dot = q_d_dot[37]
    hinge5_angle_dot = q_d_dot[38]
    hinge0_angle_ddot = q_i_ddot[0]
    bar2_end_y = c[3]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    ground_P0_quaternion_0_0_0 = c[26]
    bar1_start_quaternion_0_0_0 = c[27]
    ground_P0_quaternion_1_0_0 = c[28]
    bar1_start_quaternion_1_0_0 = c[29]
    c30 = c[30]
    c31 = c[31]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (346)
    w0 = (hinge0_angle_dot / 2.0)**2
    w1 = hinge0_angle / 2.0
    w2 = ca.cos(w1)
    w3 = w0 * w2
    w4 = ca.sin(w1)
    w5 = w4 / 2.0
    w6 = w3 * c30 + w5 * c30 * hinge0_angle_ddot
    w7 = w3 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w3 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w8 = w5 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w5 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w9 = w7 + hinge0_angle_ddot * w8
    w10 = w0 * w4
    w11 = w2 / 2.0
    w12 = w10 * c31 - hinge0_angle_ddot * (w11 * c31)
    w13 = w10 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w10 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w14 = w11 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w11 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w15 = w13 + hinge0_angle_ddot * w14
    w16 = 2 * -bar1_e2
    w17 = 2 * bar1_e3
    w18 = 2 * bar1_e0
    w19 = 2 * -bar1_e1
    w20 = bar1_e0_dot * w16 + bar1_e1_dot * w17 + bar1_e2_dot * w18 + bar1_e3_dot * w19
    w21 = 2 * -bar1_e3
    w22 = 2 * bar1_e2
    w23 = bar1_e0_dot * w19 + bar1_e1_dot * w18 + bar1_e2_dot * w21 + bar1_e3_dot * w22
    w24 = 2 * bar1_e1
    w25 = (bar1_e2 * w24 + w17 * bar1_e0) * bar1_end_x
    w26 = (1.0 - (bar1_e2 * w22 + bar1_e3 * w17)) * bar1_end_x
    w27 = w23 * w25 - w20 * w26
    w28 = bar1_e0_dot * w21 + w16 * bar1_e1_dot + bar1_e2_dot * w24 + w18 * bar1_e3_dot
    w29 = (bar1_e3 * w24 - bar1_e0 * w22) * bar1_end_x
    w30 = w26 * w28 - w23 * w29
    w31 = w21 * w25
    w32 = w18 * w29
    w33 = w20 * w27 - w28 * w30 - w6 * (w16 * w29 - w31) + w9 * (w17 * w29 - w16 * w25) + w12 * (w32 - w24 * w25)
    w34 = w19 * w29
    w35 = w18 * w25
    w36 = w33 + w15 * (w34 - w35)
    w37 = w20 * w29 - w25 * w28
    w38 = w16 * w26
    w39 = w28 * w37 - w23 * w27 - w6 * (w21 * w26 - w34) + w9 * (w38 - w32) + w12 * (w24 * w26 - w21 * w29)
    w40 = w18 * w26
    w41 = w39 + w15 * (w40 - w22 * w29)
    w42 = w23 * w30 - w20 * w37 - w6 * (w19 * w25 - w38) + w9 * (w35 - w17 * w26) + w12 * (w31 - w40) + w15 * (w22 * w25 - w19 * w26)
    w43 = (hinge1_angle_dot / 2.0)**2
    w44 = hinge1_angle / 2.0
    w45 = ca.sin(w44)
    w46 = w43 * w45
    w47 = ca.cos(w44)
    w48 = w43 * w47
    w49 = w45 / 2.0
    w50 = hinge1_angle_dot * w49
    w51 = w47 / 2.0
    w52 = hinge1_angle_dot * w51
    w53 = bar1_e0_dot * w50 + bar1_e3_dot * w52
    w54 = ca.cos(hinge1_angle)
    w55 = ca.sin(hinge0_angle)
    w56 = w54 * w55
    w57 = ca.sin(hinge2_angle)
    w58 = ca.sin(hinge1_angle)
    w59 = ca.cos(hinge0_angle)
    w60 = w58 * w59
    w61 = ca.cos(hinge2_angle)
    w62 = (w57 * w60 + w55 * w61) * bar3_end_z
    w63 = w54 * w59
    w64 = w55 * w58
    w65 = (w59 * w61 - w57 * w64) * bar3_end_z
    w66 = w56 * w62 + w63 * w65
    w67 = ca.sin(hinge5_angle)
    w68 = ca.cos(hinge4_angle)
    w69 = w68 * bar4_end_x
    w70 = w67 * w69
    w71 = w67 * w68
    w72 = w58 * w71
    w73 = ca.cos(hinge5_angle)
    w74 = w68 * w73
    w75 = w56 * w74
    w76 = w72 - w75
    w77 = ca.sin(hinge4_angle)
    w78 = w73 * w77 * bar4_end_x
    w79 = w73 * bar5_end_y
    w80 = w78 - w79
    w81 = w56 * w77
    w82 = w63 * w71
    w83 = w81 - w82
    w84 = w58 * w77
    w85 = w63 * w74
    w86 = w84 - w85
    w87 = w67 * w83 + w73 * w86
    w88 = w70 * w76 - w80 * w87
    w89 = w69 * w73
    w90 = w75 - w72
    w91 = w82 - w81
    w92 = w85 - w84
    w93 = w63 * w90 + w58 * w91 - w56 * w92
    w94 = w54 * w57 * bar3_end_z
    w95 = w63 * w94 + w58 * w62
    w96 = w80 * w93 - w76 * w95
    w97 = w67 * bar5_end_y
    w98 = w67 * w77 * bar4_end_x
    w99 = w97 - w98
    w100 = w70 * w93 - w87 * w95
    w101 = w66 * w88 - w89 * w96 + w99 * w100
    w102 = hinge1_angle_dot * w55
    w103 = hinge0_angle_dot * w102
    w104 = w54 * bar2_end_y
    w105 = w59 * bar1_end_x
    w106 = w60 * bar2_end_y
    w107 = w102 * w104 + hinge0_angle_dot * w106
    w108 = hinge1_angle_dot * w59
    w109 = w64 * bar2_end_y
    w110 = hinge1_angle_dot * w58 * bar2_end_y
    w111 = w103 * w104 - hinge0_angle_dot * (hinge0_angle_dot * w105) + (hinge0_angle_dot * w107 + w108 * w110)
    w112 = w63 * hinge2_angle_dot
    w113 = w56 * hinge2_angle_dot
    w114 = hinge2_angle_dot * (hinge1_angle_dot * w54)
    w115 = w58 * hinge2_angle_dot
    w116 = w102 * w115 - hinge0_angle_dot * w112 - w103
    w117 = hinge0_angle_dot + w115
    w118 = w102 + w112
    w119 = w94 * w118 + w62 * w117
    w120 = w108 - w113
    w121 = w62 * w120 - w65 * w118
    w122 = w73 * hinge4_angle_dot
    w123 = hinge5_angle_dot * w122
    w124 = w67 * hinge4_angle_dot
    w125 = hinge5_angle_dot * w124
    w126 = w78 * hinge5_angle_dot + w69 * w124
    w127 = w69 * w122 - w98 * hinge5_angle_dot
    w128 = w111 + (w65 * w114 + w94 * w116) - (w117 * w119 + w120 * w121) - (w98 * w123 - w78 * w125 + (w124 * w126 + w122 * w127))
    w129 = w58 * w65 - w56 * w94
    w130 = w77 * bar4_end_x
    w131 = hinge0_angle_dot * w108
    w132 = hinge0_angle_dot * w109 - w104 * w108
    w133 = w131 - (hinge0_angle_dot * w113 + w108 * w115)
    w134 = w65 * w117 + w94 * w120
    w135 = w103 * w106 - w109 * w131 + (w108 * w132 - w102 * w107) + (w62 * w116 - w65 * w133) + (w120 * w134 + w118 * w119)
    w136 = w77 * hinge4_angle_dot * bar4_end_x
    w137 = hinge5_angle_dot * (w79 * hinge5_angle_dot) - w69 * w125 - (w122 * w136 + hinge5_angle_dot * w126)
    w138 = w135 - w137
    w139 = w99 * w130
    w140 = w99 * w129
    w141 = w89 * w129 + w66 * w130
    w142 = w93 * w139 - w87 * w140 + w76 * w141
    w143 = w55 * bar1_end_x
    w144 = hinge0_angle_dot * (hinge0_angle_dot * w143) + w104 * w131 - (w102 * w110 + hinge0_angle_dot * w132)
    w145 = w124 * w136 - hinge5_angle_dot * w127 - (hinge5_angle_dot * (w97 * hinge5_angle_dot) + w69 * w123)
    w146 = w144 - (w94 * w133 + w62 * w114) + (w118 * w121 - w117 * w134) - w145
    w147 = w95 * w139 - w70 * w140 + w80 * w141
    w148 = w77 * w124 - w74 * hinge5_angle_dot
    w149 = w68 * hinge4_angle_dot
    w150 = w77 * w122 + w71 * hinge5_angle_dot
    w151 = w58 * (hinge5_angle_dot * w148 - w122 * w149) - w63 * (w124 * w148 + w122 * w150) - w56 * (hinge5_angle_dot * w150 + w124 * w149)
    w152 = w58 * w118 - w63 * w117
    w153 = w63 * w120 + w56 * w118
    w154 = w56 * w117 + w58 * w120
    w155 = w151 + w77 * (w117 * w152 - w120 * w153) - w74 * (w120 * w154 + w118 * w152) - w71 * (w118 * w153 + w117 * w154)
    w156 = w155 + w149 * (2 * -w154) - w150 * (2 * w153) + w148 * (2 * w152) + w90 * w133 + w91 * w114 + w92 * w116
    w157 = w83 * w123 - w156 - w86 * w125
    w158 = w104 - w94
    w159 = w59 * w158
    w160 = w55 * w158
    w161 = w55 * w90 + w59 * w92
    w162 = w87 * w160 + w70 * w161
    w163 = w62 - w106
    w164 = w65 + w109
    w165 = w59 * w163 - w55 * w164
    w166 = w76 * w160 + w80 * w161
    w167 = w99 * w162 - (w88 * w165 + w89 * w166)
    w168 = w93 * w160 + w95 * w161
    w169 = w96 * w165 + w66 * w166 + w99 * w168
    w170 = w101 * w159 + w129 * w167 - w130 * w169
    w171 = w164 - w143
    w172 = w105 + w163
    w173 = (w101 * w128 + (w88 * w129 + w96 * w130) * w138 + w142 * w146 - w147 * w157) / w170 + hinge0_angle_ddot * ((w101 * w171 - w142 * w172 + w91 * w147) / w170)
    w174 = bar1_e3 * w46 - bar1_e0 * w48 - w53 - w53 - w6 * w47 - w15 * w45 - (bar1_e0 * w49 + bar1_e3 * w51) * w173
    w175 = bar1_e2_dot * w52 - bar1_e1_dot * w50
    w176 = w175 + (w175 - (bar1_e1 * w48 + bar1_e2 * w46)) + w9 * w47 + w12 * w45 + w173 * (bar1_e2 * w51 - bar1_e1 * w49)
    w177 = bar1_e2_dot * w50 + bar1_e1_dot * w52
    w178 = bar1_e1 * w46 - bar1_e2 * w48 - w177 - w177 - w9 * w45 + w12 * w47 - w173 * (bar1_e2 * w49 + bar1_e1 * w51)
    w179 = bar1_e0_dot * w52 - bar1_e3_dot * w50
    w180 = w179 + (w179 - (bar1_e0 * w46 + bar1_e3 * w48)) - w6 * w45 + w15 * w47 + w173 * (bar1_e0 * w51 - bar1_e3 * w49)
    w181 = 2 * -bar2_e2
    w182 = 2 * bar2_e3
    w183 = 2 * bar2_e0
    w184 = 2 * -bar2_e1
    w185 = bar2_e0_dot * w181 + bar2_e1_dot * w182 + bar2_e2_dot * w183 + bar2_e3_dot * w184
    w186 = 2 * -bar2_e3
    w187 = 2 * bar2_e2
    w188 = bar2_e0_dot * w184 + bar2_e1_dot * w183 + bar2_e2_dot * w186 + bar2_e3_dot * w187
    w189 = 2 * bar2_e1
    w190 = (1.0 - (bar2_e1 * w189 + bar2_e3 * w182)) * bar2_end_y
    w191 = (bar2_e2 * w189 - w182 * bar2_e0) * bar2_end_y
    w192 = w188 * w190 - w185 * w191
    w193 = bar2_e0_dot * w186 + w181 * bar2_e1_dot + bar2_e2_dot * w189 + w183 * bar2_e3_dot
    w194 = (bar2_e3 * w187 + bar2_e0 * w189) * bar2_end_y
    w195 = w191 * w193 - w188 * w194
    w196 = w186 * w190
    w197 = w36 + (w185 * w192 - w193 * w195) + w174 * (w181 * w194 - w196) + w176 * (w182 * w194 - w181 * w190)
    w198 = w183 * w194
    w199 = w184 * w194
    w200 = w183 * w190
    w201 = w185 * w194 - w190 * w193
    w202 = w181 * w191
    w203 = w41 + (w193 * w201 - w188 * w192) + w174 * (w186 * w191 - w199) + w176 * (w202 - w198) + w178 * (w189 * w191 - w186 * w194)
    w204 = w183 * w191
    w205 = w42 + (w188 * w195 - w185 * w201) + w174 * (w184 * w190 - w202) + w176 * (w200 - w182 * w191) + w178 * (w196 - w204)
    w206 = hinge2_angle / 2.0
    w207 = ca.cos(w206)
    w208 = w207 * c37
    w209 = hinge2_angle_dot / 2.0
    w210 = w209**2
    w211 = w207 * w210
    w212 = w209 * (w207 * w209) * c37
    w213 = w211 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w211 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w214 = ca.sin(w206)
    w215 = w210 * w214
    w216 = w215 * c38
    w217 = w215 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w215 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w218 = w214 / 2.0
    w219 = hinge2_angle_dot * w218
    w220 = w219 * c37
    w221 = w207 / 2.0
    w222 = hinge2_angle_dot * w221
    w223 = w222 * c38
    w224 = w219 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w219 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w225 = w222 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w222 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w226 = bar2_e0_dot * w220 + (bar2_e1_dot * w223 + bar2_e2_dot * w224 + bar2_e3_dot * w225)
    w227 = w174 * w208 - (w226 + (bar2_e0 * w212 + (bar2_e2 * w213 - bar2_e1 * w216 + bar2_e3 * w217) + w226))
    w228 = w214 * c38
    w229 = w207 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w207 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w230 = w214 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w214 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w231 = w218 * c37
    w232 = w221 * c38
    w233 = w218 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w218 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w234 = w221 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w221 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w235 = w99 * w159
    w236 = w89 * w159 + w130 * w165
    w237 = w139 * w161 + w87 * w235 - w76 * w236
    w238 = w70 * w235 - w139 * w160 - w80 * w236
    w239 = (w138 * (w88 * w159 - w130 * w166) - w128 * w167 - w146 * w237 + w157 * w238) / w170 + hinge0_angle_ddot * ((w172 * w237 - w167 * w171 - w91 * w238) / w170)
    w240 = w227 - w176 * w228 - w178 * w229 - w180 * w230 - (bar2_e0 * w231 + (bar2_e1 * w232 + bar2_e2 * w233 + bar2_e3 * w234)) * w239
    w241 = bar2_e0_dot * w223 - bar2_e1_dot * w220 + (bar2_e2_dot * w225 - bar2_e3_dot * w224)
    w242 = w241 + (bar2_e2 * w217 - bar2_e3 * w213 - (bar2_e0 * w216 + bar2_e1 * w212) + w241) + w174 * w228
    w243 = w242 + w176 * w208 + w178 * w230 - w180 * w229 + w239 * (bar2_e0 * w232 - bar2_e1 * w231 + (bar2_e2 * w234 - bar2_e3 * w233))
    w244 = bar2_e0_dot * w224 - bar2_e2_dot * w220 + (bar2_e3_dot * w223 - bar2_e1_dot * w225)
    w245 = w244 + (bar2_e0 * w213 - bar2_e2 * w212 - (bar2_e3 * w216 + bar2_e1 * w217) + w244) + w174 * w229
    w246 = w245 - w176 * w230 + w178 * w208 + w180 * w228 + w239 * (bar2_e0 * w233 - bar2_e2 * w231 + (bar2_e3 * w232 - bar2_e1 * w234))
    w247 = bar2_e0_dot * w225 - bar2_e3_dot * w220 + (bar2_e1_dot * w224 - bar2_e2_dot * w223)
    w248 = w247 + (bar2_e0 * w217 - bar2_e3 * w212 + (bar2_e1 * w213 + bar2_e2 * w216) + w247) + w174 * w230
    w249 = w248 + w176 * w229 - w178 * w228 + w180 * w208 + w239 * (bar2_e0 * w234 - bar2_e3 * w231 + (bar2_e1 * w233 - bar2_e2 * w232))
    w250 = 2 * -bar5_e2
    w251 = 2 * bar5_e2
    w252 = 2 * bar5_e1
    w253 = (w251 * bar5_e3 + w252 * bar5_e0) * bar5_end_y
    w254 = 2 * -bar5_e3
    w255 = 2 * bar5_e3
    w256 = (1.0 - (bar5_e1 * w252 + bar5_e3 * w255)) * bar5_end_y
    w257 = w254 * w256
    w258 = (hinge5_angle_dot / 2.0)**2
    w259 = hinge5_angle / 2.0
    w260 = ca.cos(w259)
    w261 = w258 * w260
    w262 = ca.sin(w259)
    w263 = w262 / 2.0
    w264 = w100 * w165 + w66 * w162 + w89 * w168
    w265 = w66 * w159 - w129 * w165
    w266 = w141 * w161 + w93 * w236 + w87 * w265
    w267 = w141 * w160 - w95 * w236 - w70 * w265
    w268 = (w128 * w264 + w138 * (w100 * w159 + w129 * w162 - w130 * w168) + w146 * w266 + w157 * w267) / w170
    w269 = w268 + hinge0_angle_ddot * ((w171 * w264 - w172 * w266 - w91 * w267) / w170)
    w270 = w261 * c44 + w263 * c44 * w269
    w271 = 2 * bar5_e0
    w272 = 2 * -bar5_e1
    w273 = w250 * bar5_e0_dot + w255 * bar5_e1_dot + bar5_e2_dot * w271 + bar5_e3_dot * w272
    w274 = bar5_e0_dot * w272 + bar5_e1_dot * w271 + w254 * bar5_e2_dot + w251 * bar5_e3_dot
    w275 = (bar5_e2 * w252 - bar5_e0 * w255) * bar5_end_y
    w276 = w256 * w274 - w273 * w275
    w277 = w254 * bar5_e0_dot + w250 * bar5_e1_dot + w252 * bar5_e2_dot + w271 * bar5_e3_dot
    w278 = w275 * w277 - w253 * w274
    w279 = w258 * w262
    w280 = w260 / 2.0
    w281 = w279 * c43 - w269 * (w280 * c43)
    w282 = w253 * w271
    w283 = w261 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w261 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w284 = w263 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w263 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w285 = w283 + w269 * w284
    w286 = (w250 * w253 - w257) * w270 - (w273 * w276 - w277 * w278) - (w253 * w255 - w250 * w256) * w281 - (w282 - w252 * w256) * w285
    w287 = w253 * w272
    w288 = w256 * w271
    w289 = w279 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w279 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w290 = w280 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w280 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w291 = w289 + w269 * w290
    w292 = w286 - (w287 - w288) * w291
    w293 = 2 * -bar4_e2
    w294 = 2 * bar4_e3
    w295 = 2 * bar4_e0
    w296 = 2 * -bar4_e1
    w297 = bar4_e0_dot * w293 + bar4_e1_dot * w294 + bar4_e2_dot * w295 + bar4_e3_dot * w296
    w298 = 2 * -bar4_e3
    w299 = 2 * bar4_e2
    w300 = bar4_e0_dot * w296 + bar4_e1_dot * w295 + bar4_e2_dot * w298 + bar4_e3_dot * w299
    w301 = 2 * bar4_e1
    w302 = (bar4_e2 * w301 + w294 * bar4_e0) * bar4_end_x
    w303 = (1.0 - (bar4_e2 * w299 + bar4_e3 * w294)) * bar4_end_x
    w304 = w300 * w302 - w297 * w303
    w305 = bar4_e0_dot * w298 + w293 * bar4_e1_dot + bar4_e2_dot * w301 + w295 * bar4_e3_dot
    w306 = (bar4_e3 * w301 - bar4_e0 * w299) * bar4_end_x
    w307 = w303 * w305 - w300 * w306
    w308 = w298 * w302
    w309 = hinge4_angle / 2.0
    w310 = ca.cos(w309)
    w311 = w310 / 2.0
    w312 = hinge4_angle_dot * w311
    w313 = ca.sin(w309)
    w314 = w313 / 2.0
    w315 = hinge4_angle_dot * w314
    w316 = bar5_e3_dot * w312 - bar5_e0_dot * w315
    w317 = (hinge4_angle_dot / 2.0)**2
    w318 = w310 * w317
    w319 = w313 * w317
    w320 = w140 * w161 + w93 * w235 + w76 * w265
    w321 = w140 * w160 - w95 * w235 - w80 * w265
    w322 = hinge0_angle_ddot * ((w172 * w320 - w169 * w171 + w91 * w321) / w170) - (w128 * w169 + w138 * (w96 * w159 + w129 * w166) + w146 * w320 + w157 * w321) / w170
    w323 = w316 + (w316 - (bar5_e0 * w318 + bar5_e3 * w319)) - w270 * w310 + w291 * w313 + (bar5_e3 * w311 - bar5_e0 * w314) * w322
    w324 = bar5_e1_dot * w315 + bar5_e2_dot * w312
    w325 = bar5_e2 * w319 - bar5_e1 * w318 - w324 - w324 + w281 * w310 - w285 * w313 - w322 * (bar5_e1 * w314 + bar5_e2 * w311)
    w326 = w295 * w306
    w327 = bar5_e1_dot * w312 - bar5_e2_dot * w315
    w328 = w327 + (w327 - (bar5_e2 * w318 + bar5_e1 * w319)) + w281 * w313 + w285 * w310 + w322 * (bar5_e1 * w311 - bar5_e2 * w314)
    w329 = w297 * w304 - w305 * w307 + (w293 * w306 - w308) * w323 + (w294 * w306 - w293 * w302) * w325 + (w326 - w301 * w302) * w328
    w330 = w296 * w306
    w331 = w295 * w302
    w332 = bar5_e0_dot * w312 + bar5_e3_dot * w315
    w333 = bar5_e0 * w319 - bar5_e3 * w318 - w332 - w332 + w270 * w313 + w291 * w310 - w322 * (bar5_e0 * w311 + bar5_e3 * w314)
    w334 = w253 * w273 - w256 * w277
    w335 = w250 * w275
    w336 = w270 * (w254 * w275 - w287) - (w277 * w334 - w274 * w276) - w281 * (w335 - w282) - w285 * (w252 * w275 - w253 * w254)
    w337 = w271 * w275
    w338 = w336 - w291 * (w337 - w251 * w253)
    w339 = w297 * w306 - w302 * w305
    w340 = w293 * w303
    w341 = w305 * w339 - w300 * w304 + w323 * (w298 * w303 - w330) + w325 * (w340 - w326) + w328 * (w301 * w303 - w298 * w306)
    w342 = w295 * w303
    w343 = w270 * (w256 * w272 - w335) - (w274 * w278 - w273 * w334) - w281 * (w288 - w255 * w275) - w285 * (w257 - w337)
    w344 = w343 - w291 * (w251 * w256 - w272 * w275)
    w345 = w300 * w307 - w297 * w339 + w323 * (w296 * w302 - w340) + w325 * (w331 - w294 * w303) + w328 * (w308 - w342)
    # outputs
    q_d_ddot = ca.vertcat(
        0.0,  # bar1.x
        0.0,  # bar1.y
        0.0,  # bar1.z
        -w6,  # bar1.e0
        w9,  # bar1.e1
        w12,  # bar1.e2
        w15,  # bar1.e3
        w36,  # bar2.x
        w41,  # bar2.y
        w42,  # bar2.z
        w174,  # bar2.e0
        w176,  # bar2.e1
        w178,  # bar2.e2
        w180,  # bar2.e3
        w197 + w178 * (w198 - w189 * w190) + w180 * (w199 - w200),  # bar3.x
        w203 + w180 * (w204 - w187 * w194),  # bar3.y
        w205 + w180 * (w187 * w190 - w184 * w191),  # bar3.z
        w240,  # bar3.e0
        w243,  # bar3.e1
        w246,  # bar3.e2
        w249,  # bar3.e3
        w292 - (w329 + (w330 - w331) * w333),  # bar4.x
        w338 - (w341 + w333 * (w342 - w299 * w306)),  # bar4.y
        w344 - (w345 + w333 * (w299 * w302 - w296 * w303)),  # bar4.z
        w323,  # bar4.e0
        w325,  # bar4.e1
        w328,  # bar4.e2
        w333,  # bar4.e3
        w292,  # bar5.x
        w338,  # bar5.y
        w344,  # bar5.z
        -w270,  # bar5.e0
        w281,  # bar5.e1
        w285,  # bar5.e2
        w291,  # bar5.e3
        w173,  # hinge1.angle
        w239,  # hinge2.angle
        w322,  # hinge4.angle
        w269,  # hinge5.angle
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 40) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 40 x 40) [SI]: constraint Jacobian
    gives C_t (n_c = 40) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 40) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 40) [m/s^2, rad/s^2]: right-hand side at acceleration level
    1156 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 109)
    bar1_x = q[0]
    bar1_y = q[1]
    bar1_z = q[2]
    bar1_e0 = q[3]
    bar1_e1 = q[4]
    bar1_e2 = q[5]
    bar1_e3 = q[6]
    bar2_x = q[7]
    bar2_y = q[8]
    bar2_z = q[9]
    bar2_e0 = q[10]
    bar2_e1 = q[11]
    bar2_e2 = q[12]
    bar2_e3 = q[13]
    bar3_x = q[14]
    bar3_y = q[15]
    bar3_z = q[16]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar4_x = q[21]
    bar4_y = q[22]
    bar4_z = q[23]
    bar4_e0 = q[24]
    bar4_e1 = q[25]
    bar4_e2 = q[26]
    bar4_e3 = q[27]
    bar5_x = q[28]
    bar5_y = q[29]
    bar5_z = q[30]
    bar5_e0 = q[31]
    bar5_e1 = q[32]
    bar5_e2 = q[33]
    bar5_e3 = q[34]
    hinge0_angle = q[35]
    hinge1_angle = q[36]
    hinge2_angle = q[37]
    hinge4_angle = q[38]
    hinge5_angle = q[39]
    bar1_e0_dot = q_dot[3]
    bar1_e1_dot = q_dot[4]
    bar1_e2_dot = q_dot[5]
    bar1_e3_dot = q_dot[6]
    bar2_e0_dot = q_dot[10]
    bar2_e1_dot = q_dot[11]
    bar2_e2_dot = q_dot[12]
    bar2_e3_dot = q_dot[13]
    bar3_e0_dot = q_dot[17]
    bar3_e1_dot = q_dot[18]
    bar3_e2_dot = q_dot[19]
    bar3_e3_dot = q_dot[20]
    bar4_e0_dot = q_dot[24]
    bar4_e1_dot = q_dot[25]
    bar4_e2_dot = q_dot[26]
    bar4_e3_dot = q_dot[27]
    bar5_e0_dot = q_dot[31]
    bar5_e1_dot = q_dot[32]
    bar5_e2_dot = q_dot[33]
    bar5_e3_dot = q_dot[34]
    hinge0_angle_dot = q_dot[35]
    hinge1_angle_dot = q_dot[36]
    hinge2_angle_dot = q_dot[37]
    hinge4_angle_dot = q_dot[38]
    hinge5_angle_dot = q_dot[39]
    bar2_end_y = c[3]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    ground_P0_quaternion_0_0_0 = c[26]
    bar1_start_quaternion_0_0_0 = c[27]
    ground_P0_quaternion_1_0_0 = c[28]
    bar1_start_quaternion_1_0_0 = c[29]
    c30 = c[30]
    c31 = c[31]
    ground_P5_z = c[32]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    c46 = c[46]
    c47 = c[47]
    # intermediate terms (262)
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w1 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w3 = ca.sin(w0)
    w4 = w3 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w3 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w5 = hinge1_angle / 2.0
    w6 = ca.cos(w5)
    w7 = ca.sin(w5)
    w8 = 2 * bar1_e2
    w9 = 2 * bar1_e3
    w10 = (1.0 - (bar1_e2 * w8 + bar1_e3 * w9)) * bar1_end_x
    w11 = 2 * bar1_e1
    w12 = (bar1_e2 * w11 + bar1_e0 * w9) * bar1_end_x
    w13 = (bar1_e3 * w11 - bar1_e0 * w8) * bar1_end_x
    w14 = hinge2_angle / 2.0
    w15 = ca.cos(w14)
    w16 = w15 * c37
    w17 = ca.sin(w14)
    w18 = w17 * c38
    w19 = w15 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w15 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w20 = w17 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w17 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w21 = 2 * bar2_e1
    w22 = 2 * bar2_e3
    w23 = (bar2_e2 * w21 - bar2_e0 * w22) * bar2_end_y
    w24 = (1.0 - (bar2_e1 * w21 + bar2_e3 * w22)) * bar2_end_y
    w25 = 2 * bar2_e2
    w26 = (bar2_e3 * w25 + bar2_e0 * w21) * bar2_end_y
    w27 = 2 * bar3_e1
    w28 = bar3_e3 * w27
    w29 = 2 * bar3_e2
    w30 = bar3_e0 * w29
    w31 = w28 + w30
    w32 = w31 * bar3_end_z
    w33 = bar3_e3 * w29 - bar3_e0 * w27
    w34 = w33 * bar3_end_z
    w35 = bar3_e2 * w29
    w36 = 1.0 - (bar3_e1 * w27 + w35)
    w37 = w36 * bar3_end_z
    w38 = 2 * bar3_e3
    w39 = 1.0 - (w35 + bar3_e3 * w38)
    w40 = 2 * bar4_e1
    w41 = w40 * bar4_e2
    w42 = 2 * bar4_e3
    w43 = w42 * bar4_e0
    w44 = w41 - w43
    w45 = bar3_e2 * w27 + bar3_e0 * w38
    w46 = bar4_e3 * w42
    w47 = 1.0 - (bar4_e1 * w40 + w46)
    w48 = w28 - w30
    w49 = 2 * bar4_e2
    w50 = bar4_e3 * w49 + w40 * bar4_e0
    w51 = hinge4_angle / 2.0
    w52 = ca.cos(w51)
    w53 = ca.sin(w51)
    w54 = (1.0 - (w46 + bar4_e2 * w49)) * bar4_end_x
    w55 = (w41 + w43) * bar4_end_x
    w56 = (w40 * bar4_e3 - bar4_e0 * w49) * bar4_end_x
    w57 = hinge5_angle / 2.0
    w58 = ca.cos(w57)
    w59 = ca.sin(w57)
    w60 = w58 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w58 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w61 = w59 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w59 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w62 = 2 * bar5_e1
    w63 = 2 * bar5_e3
    w64 = (bar5_e2 * w62 - bar5_e0 * w63) * bar5_end_y
    w65 = (1.0 - (bar5_e1 * w62 + bar5_e3 * w63)) * bar5_end_y
    w66 = 2 * bar5_e2
    w67 = (bar5_e3 * w66 + bar5_e0 * w62) * bar5_end_y
    w68 = -w6
    w69 = -w7
    w70 = 2 * -bar1_e2
    w71 = 2 * -bar1_e3
    w72 = w12 * w71
    w73 = 2 * -bar1_e1
    w74 = w13 * w73
    w75 = w10 * w70
    w76 = 2 * bar1_e0
    w77 = w13 * w76
    w78 = w12 * w76
    w79 = w10 * w76
    w80 = -w16
    w81 = -w18
    w82 = -w19
    w83 = -w20
    w84 = 2 * -bar2_e2
    w85 = 2 * -bar2_e3
    w86 = w24 * w85
    w87 = 2 * -bar2_e1
    w88 = w26 * w87
    w89 = w23 * w84
    w90 = 2 * bar2_e0
    w91 = w26 * w90
    w92 = w24 * w90
    w93 = w23 * w90
    w94 = 2 * -bar3_e2
    w95 = 2 * -bar3_e3
    w96 = w34 * w95
    w97 = 2 * -bar3_e1
    w98 = w37 * w97
    w99 = w32 * w94
    w100 = w45 * w50
    w101 = w47 * w48
    w102 = w100 - w101
    w103 = w44 * w48
    w104 = w39 * w50
    w105 = w103 - w104
    w106 = w39 * w47
    w107 = w44 * w45
    w108 = w106 - w107
    w109 = w36 * w47
    w110 = w33 * w50
    w111 = w109 - w110
    w112 = w31 * w50
    w113 = w36 * w44
    w114 = w112 - w113
    w115 = w33 * w44
    w116 = w31 * w47
    w117 = w115 - w116
    w118 = 2 * bar3_e0
    w119 = w37 * w118
    w120 = w34 * w118
    w121 = w32 * w118
    w122 = w101 - w100
    w123 = 2 * -bar4_e1
    w124 = w104 - w103
    w125 = 2 * -bar4_e2
    w126 = w107 - w106
    w127 = 2 * -bar4_e3
    w128 = w110 - w109
    w129 = w113 - w112
    w130 = w116 - w115
    w131 = w55 * w127
    w132 = w56 * w123
    w133 = w54 * w125
    w134 = 2 * bar4_e0
    w135 = w56 * w134
    w136 = w55 * w134
    w137 = w54 * w134
    w138 = -w52
    w139 = 2 * -bar5_e2
    w140 = 2 * -bar5_e3
    w141 = w65 * w140
    w142 = 2 * -bar5_e1
    w143 = w67 * w142
    w144 = w64 * w139
    w145 = -w53
    w146 = 2 * bar5_e0
    w147 = w67 * w146
    w148 = w65 * w146
    w149 = w64 * w146
    w150 = w3 / 2.0
    w151 = w1 / 2.0
    w152 = w7 / 2.0
    w153 = w6 / 2.0
    w154 = w17 / 2.0
    w155 = w154 * c37
    w156 = w15 / 2.0
    w157 = w156 * c38
    w158 = w154 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w154 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w159 = w156 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w156 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w160 = w52 / 2.0
    w161 = w53 / 2.0
    w162 = w59 / 2.0
    w163 = w58 / 2.0
    w164 = hinge0_angle_dot / 2.0
    w165 = w164**2
    w166 = w1 * w165
    w167 = w166 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w166 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w168 = w3 * w165
    w169 = w168 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w168 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w170 = (hinge1_angle_dot / 2.0)**2
    w171 = w7 * w170
    w172 = w6 * w170
    w173 = w152 * hinge1_angle_dot
    w174 = w153 * hinge1_angle_dot
    w175 = bar1_e0_dot * w173 + bar1_e3_dot * w174
    w176 = w174 * bar1_e2_dot - w173 * bar1_e1_dot
    w177 = w173 * bar1_e2_dot + w174 * bar1_e1_dot
    w178 = bar1_e0_dot * w174 - w173 * bar1_e3_dot
    w179 = w70 * bar1_e0_dot + w9 * bar1_e1_dot + w76 * bar1_e2_dot + w73 * bar1_e3_dot
    w180 = w73 * bar1_e0_dot + w76 * bar1_e1_dot + w71 * bar1_e2_dot + w8 * bar1_e3_dot
    w181 = w12 * w180 - w10 * w179
    w182 = w71 * bar1_e0_dot + w70 * bar1_e1_dot + w11 * bar1_e2_dot + w76 * bar1_e3_dot
    w183 = w10 * w182 - w13 * w180
    w184 = w13 * w179 - w12 * w182
    w185 = hinge2_angle_dot / 2.0
    w186 = w185**2
    w187 = w15 * w186
    w188 = w185 * (w15 * w185) * c37
    w189 = w187 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w187 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w190 = w17 * w186
    w191 = w185 * (w17 * w185) * c38
    w192 = w190 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w190 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w193 = w154 * hinge2_angle_dot
    w194 = w193 * c37
    w195 = w156 * hinge2_angle_dot
    w196 = w195 * c38
    w197 = w193 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w193 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w198 = w195 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w195 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w199 = bar2_e0_dot * w194 + (bar2_e1_dot * w196 + bar2_e2_dot * w197 + bar2_e3_dot * w198)
    w200 = bar2_e0_dot * w196 - w194 * bar2_e1_dot + (bar2_e2_dot * w198 - w197 * bar2_e3_dot)
    w201 = bar2_e0_dot * w197 - w194 * bar2_e2_dot + (w196 * bar2_e3_dot - bar2_e1_dot * w198)
    w202 = bar2_e0_dot * w198 - w194 * bar2_e3_dot + (bar2_e1_dot * w197 - w196 * bar2_e2_dot)
    w203 = w84 * bar2_e0_dot + w22 * bar2_e1_dot + w90 * bar2_e2_dot + w87 * bar2_e3_dot
    w204 = w87 * bar2_e0_dot + w90 * bar2_e1_dot + w85 * bar2_e2_dot + w25 * bar2_e3_dot
    w205 = w24 * w204 - w23 * w203
    w206 = w85 * bar2_e0_dot + w84 * bar2_e1_dot + w21 * bar2_e2_dot + w90 * bar2_e3_dot
    w207 = w23 * w206 - w26 * w204
    w208 = w26 * w203 - w24 * w206
    w209 = w94 * bar3_e0_dot + w38 * bar3_e1_dot + w118 * bar3_e2_dot + w97 * bar3_e3_dot
    w210 = w97 * bar3_e0_dot + w118 * bar3_e1_dot + w95 * bar3_e2_dot + w29 * bar3_e3_dot
    w211 = w34 * w210 - w32 * w209
    w212 = w95 * bar3_e0_dot + w94 * bar3_e1_dot + w27 * bar3_e2_dot + w118 * bar3_e3_dot
    w213 = w32 * w212 - w37 * w210
    w214 = w37 * w209 - w34 * w212
    w215 = w125 * bar4_e0_dot + w42 * bar4_e1_dot + w134 * bar4_e2_dot + w123 * bar4_e3_dot
    w216 = w123 * bar4_e0_dot + w134 * bar4_e1_dot + w127 * bar4_e2_dot + w49 * bar4_e3_dot
    w217 = w47 * w216 - w44 * w215
    w218 = w127 * bar4_e0_dot + w125 * bar4_e1_dot + w40 * bar4_e2_dot + w134 * bar4_e3_dot
    w219 = w44 * w218 - w50 * w216
    w220 = w215 * w217 - w218 * w219
    w221 = w50 * w215 - w47 * w218
    w222 = w218 * w221 - w216 * w217
    w223 = w216 * w219 - w215 * w221
    w224 = w45 * w210 - w39 * w209
    w225 = w39 * w212 - w48 * w210
    w226 = w48 * w209 - w45 * w212
    w227 = w31 * w209 - w33 * w210
    w228 = w36 * w210 - w31 * w212
    w229 = w33 * w212 - w36 * w209
    w230 = w160 * hinge4_angle_dot
    w231 = w161 * hinge4_angle_dot
    w232 = bar5_e3_dot * w230 - bar5_e0_dot * w231
    w233 = (hinge4_angle_dot / 2.0)**2
    w234 = w52 * w233
    w235 = w53 * w233
    w236 = w231 * bar5_e1_dot + w230 * bar5_e2_dot
    w237 = w230 * bar5_e1_dot - w231 * bar5_e2_dot
    w238 = w230 * bar5_e0_dot + bar5_e3_dot * w231
    w239 = w55 * w216 - w54 * w215
    w240 = w54 * w218 - w56 * w216
    w241 = w56 * w215 - w55 * w218
    w242 = hinge5_angle_dot / 2.0
    w243 = w242**2
    w244 = w58 * w243
    w245 = w59 * w243
    w246 = w244 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w244 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w247 = w245 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w245 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w248 = w139 * bar5_e0_dot + w63 * bar5_e1_dot + w146 * bar5_e2_dot + w142 * bar5_e3_dot
    w249 = w142 * bar5_e0_dot + w146 * bar5_e1_dot + w140 * bar5_e2_dot + w66 * bar5_e3_dot
    w250 = w65 * w249 - w64 * w248
    w251 = w140 * bar5_e0_dot + w139 * bar5_e1_dot + w62 * bar5_e2_dot + w146 * bar5_e3_dot
    w252 = w64 * w251 - w67 * w249
    w253 = w67 * w248 - w65 * w251
    w254 = w150 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w150 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w255 = w151 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w151 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w256 = w162 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w162 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w257 = w163 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w163 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w258 = (w212 * w225 - w209 * w224) * w44 - (w39 * w220 + w45 * w222 + w48 * w223) - w47 * (w212 * w226 - w210 * w224)
    w259 = w258 - w50 * (w210 * w225 - w209 * w226) - w221 * (2 * w226) - w219 * (2 * w225) - w217 * (2 * w224)
    w260 = w31 * w220 + w33 * w222 + w36 * w223 - w44 * (w209 * w227 - w212 * w228) - w47 * (w212 * w229 - w210 * w227)
    w261 = w260 - w50 * (w210 * w228 - w209 * w229) - w221 * (2 * w229) - w219 * (2 * w228) - w217 * (2 * w227)
    # outputs
    C = ca.vertcat(
        bar1_e0 - w1 * c30,  # hinge0.e0
        bar1_e1 - w2,  # hinge0.e1
        bar1_e2 + w3 * c31,  # hinge0.e2
        bar1_e3 - w4,  # hinge0.e3
        bar1_x,  # hinge0.x
        bar1_y,  # hinge0.y
        bar1_z,  # hinge0.z
        bar2_e0 - (bar1_e0 * w6 - bar1_e3 * w7),  # hinge1.e0
        bar2_e1 - (bar1_e1 * w6 + bar1_e2 * w7),  # hinge1.e1
        bar2_e2 - (bar1_e2 * w6 - bar1_e1 * w7),  # hinge1.e2
        bar2_e3 - (bar1_e0 * w7 + bar1_e3 * w6),  # hinge1.e3
        bar2_x - (bar1_x + w10),  # hinge1.x
        bar2_y - (bar1_y + w12),  # hinge1.y
        bar2_z - (bar1_z + w13),  # hinge1.z
        bar3_e0 - (bar2_e0 * w16 - (bar2_e1 * w18 + bar2_e2 * w19 + bar2_e3 * w20)),  # hinge2.e0
        bar3_e1 - (bar2_e0 * w18 + bar2_e1 * w16 + (bar2_e2 * w20 - bar2_e3 * w19)),  # hinge2.e1
        bar3_e2 - (bar2_e0 * w19 + bar2_e2 * w16 + (bar2_e3 * w18 - bar2_e1 * w20)),  # hinge2.e2
        bar3_e3 - (bar2_e0 * w20 + bar2_e3 * w16 + (bar2_e1 * w19 - bar2_e2 * w18)),  # hinge2.e3
        bar3_x - (bar2_x + w23),  # hinge2.x
        bar3_y - (bar2_y + w24),  # hinge2.y
        bar3_z - (bar2_z + w26),  # hinge2.z
        bar4_x - (bar3_x + w32),  # hinge3.x
        bar4_y - (bar3_y + w34),  # hinge3.y
        bar4_z - (bar3_z + w37),  # hinge3.z
        w39 * w44 + w45 * w47 + w48 * w50,  # hinge3.parallel_x
        -(w31 * w44 + w33 * w47 + w36 * w50),  # hinge3.parallel_y
        bar4_e0 - (bar5_e0 * w52 + bar5_e3 * w53),  # hinge4.e0
        bar4_e1 - (w52 * bar5_e1 - w53 * bar5_e2),  # hinge4.e1
        bar4_e2 - (w52 * bar5_e2 + w53 * bar5_e1),  # hinge4.e2
        bar4_e3 - (w52 * bar5_e3 - bar5_e0 * w53),  # hinge4.e3
        bar5_x - (bar4_x + w54),  # hinge4.x
        bar5_y - (bar4_y + w55),  # hinge4.y
        bar5_z - (bar4_z + w56),  # hinge4.z
        bar5_e0 - w58 * c44,  # hinge5.e0
        bar5_e1 + w59 * c43,  # hinge5.e1
        bar5_e2 - w60,  # hinge5.e2
        bar5_e3 - w61,  # hinge5.e3
        -(bar5_x + w64),  # hinge5.x
        -(bar5_y + w65),  # hinge5.y
        ground_P5_z - (bar5_z + w67),  # hinge5.z
    )
    C_q = ca.SX(40, 40)
    # hinge0.e0
    C_q[0, 3] = 1.0
    C_q[0, 35] = w150 * c30
    # hinge0.e1
    C_q[1, 4] = 1.0
    C_q[1, 35] = w254
    # hinge0.e2
    C_q[2, 5] = 1.0
    C_q[2, 35] = w151 * c31
    # hinge0.e3
    C_q[3, 6] = 1.0
    C_q[3, 35] = w255
    # hinge0.x
    C_q[4, 0] = 1.0
    # hinge0.y
    C_q[5, 1] = 1.0
    # hinge0.z
    C_q[6, 2] = 1.0
    # hinge1.e0
    C_q[7, 3] = w68
    C_q[7, 6] = w7
    C_q[7, 10] = 1.0
    C_q[7, 36] = bar1_e0 * w152 + bar1_e3 * w153
    # hinge1.e1
    C_q[8, 4] = w68
    C_q[8, 5] = w69
    C_q[8, 11] = 1.0
    C_q[8, 36] = bar1_e1 * w152 - bar1_e2 * w153
    # hinge1.e2
    C_q[9, 4] = w7
    C_q[9, 5] = w68
    C_q[9, 12] = 1.0
    C_q[9, 36] = bar1_e2 * w152 + bar1_e1 * w153
    # hinge1.e3
    C_q[10, 3] = w69
    C_q[10, 6] = w68
    C_q[10, 13] = 1.0
    C_q[10, 36] = bar1_e3 * w152 - bar1_e0 * w153
    # hinge1.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = w72 - w13 * w70
    C_q[11, 4] = w12 * w70 - w9 * w13
    C_q[11, 5] = w11 * w12 - w77
    C_q[11, 6] = w78 - w74
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w74 - w10 * w71
    C_q[12, 4] = w77 - w75
    C_q[12, 5] = w13 * w71 - w10 * w11
    C_q[12, 6] = w8 * w13 - w79
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w75 - w12 * w73
    C_q[13, 4] = w9 * w10 - w78
    C_q[13, 5] = w79 - w72
    C_q[13, 6] = w10 * w73 - w8 * w12
    C_q[13, 9] = 1.0
    # hinge2.e0
    C_q[14, 10] = w80
    C_q[14, 11] = w18
    C_q[14, 12] = w19
    C_q[14, 13] = w20
    C_q[14, 17] = 1.0
    C_q[14, 37] = bar2_e0 * w155 + (bar2_e1 * w157 + bar2_e2 * w158 + bar2_e3 * w159)
    # hinge2.e1
    C_q[15, 10] = w81
    C_q[15, 11] = w80
    C_q[15, 12] = w83
    C_q[15, 13] = w19
    C_q[15, 18] = 1.0
    C_q[15, 37] = bar2_e1 * w155 - bar2_e0 * w157 - (bar2_e2 * w159 - bar2_e3 * w158)
    # hinge2.e2
    C_q[16, 10] = w82
    C_q[16, 11] = w20
    C_q[16, 12] = w80
    C_q[16, 13] = w81
    C_q[16, 19] = 1.0
    C_q[16, 37] = bar2_e2 * w155 - bar2_e0 * w158 - (bar2_e3 * w157 - bar2_e1 * w159)
    # hinge2.e3
    C_q[17, 10] = w83
    C_q[17, 11] = w82
    C_q[17, 12] = w18
    C_q[17, 13] = w80
    C_q[17, 20] = 1.0
    C_q[17, 37] = bar2_e3 * w155 - bar2_e0 * w159 - (bar2_e1 * w158 - bar2_e2 * w157)
    # hinge2.x
    C_q[18, 7] = -1.0
    C_q[18, 10] = w86 - w26 * w84
    C_q[18, 11] = w24 * w84 - w22 * w26
    C_q[18, 12] = w21 * w24 - w91
    C_q[18, 13] = w92 - w88
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = w88 - w23 * w85
    C_q[19, 11] = w91 - w89
    C_q[19, 12] = w26 * w85 - w21 * w23
    C_q[19, 13] = w25 * w26 - w93
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = w89 - w24 * w87
    C_q[20, 11] = w22 * w23 - w92
    C_q[20, 12] = w93 - w86
    C_q[20, 13] = w23 * w87 - w24 * w25
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = w96 - w37 * w94
    C_q[21, 18] = w34 * w94 - w37 * w38
    C_q[21, 19] = w27 * w34 - w119
    C_q[21, 20] = w120 - w98
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = w98 - w32 * w95
    C_q[22, 18] = w119 - w99
    C_q[22, 19] = w37 * w95 - w27 * w32
    C_q[22, 20] = w29 * w37 - w121
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = w99 - w34 * w97
    C_q[23, 18] = w32 * w38 - w120
    C_q[23, 19] = w121 - w96
    C_q[23, 20] = w32 * w97 - w29 * w34
    C_q[23, 23] = 1.0
    # hinge3.parallel_x
    C_q[24, 17] = w97 * w102 + w94 * w105 + w95 * w108
    C_q[24, 18] = w102 * w118 + w38 * w105 + w94 * w108
    C_q[24, 19] = w95 * w102 + w105 * w118 + w27 * w108
    C_q[24, 20] = w29 * w102 + w97 * w105 + w108 * w118
    C_q[24, 24] = w122 * w123 + w124 * w125 + w126 * w127
    C_q[24, 25] = w122 * w134 + w42 * w124 + w125 * w126
    C_q[24, 26] = w122 * w127 + w124 * w134 + w40 * w126
    C_q[24, 27] = w49 * w122 + w123 * w124 + w126 * w134
    # hinge3.parallel_y
    C_q[25, 17] = w97 * w111 + w94 * w114 + w95 * w117
    C_q[25, 18] = w111 * w118 + w38 * w114 + w94 * w117
    C_q[25, 19] = w95 * w111 + w114 * w118 + w27 * w117
    C_q[25, 20] = w29 * w111 + w97 * w114 + w117 * w118
    C_q[25, 24] = w123 * w128 + w125 * w129 + w127 * w130
    C_q[25, 25] = w128 * w134 + w42 * w129 + w125 * w130
    C_q[25, 26] = w127 * w128 + w129 * w134 + w40 * w130
    C_q[25, 27] = w49 * w128 + w123 * w129 + w130 * w134
    # hinge4.e0
    C_q[26, 24] = 1.0
    C_q[26, 31] = w138
    C_q[26, 34] = w145
    C_q[26, 38] = bar5_e0 * w161 - bar5_e3 * w160
    # hinge4.e1
    C_q[27, 25] = 1.0
    C_q[27, 32] = w138
    C_q[27, 33] = w53
    C_q[27, 38] = bar5_e1 * w161 + bar5_e2 * w160
    # hinge4.e2
    C_q[28, 26] = 1.0
    C_q[28, 32] = w145
    C_q[28, 33] = w138
    C_q[28, 38] = bar5_e2 * w161 - bar5_e1 * w160
    # hinge4.e3
    C_q[29, 27] = 1.0
    C_q[29, 31] = w53
    C_q[29, 34] = w138
    C_q[29, 38] = bar5_e0 * w160 + bar5_e3 * w161
    # hinge4.x
    C_q[30, 21] = -1.0
    C_q[30, 24] = w131 - w56 * w125
    C_q[30, 25] = w55 * w125 - w42 * w56
    C_q[30, 26] = w40 * w55 - w135
    C_q[30, 27] = w136 - w132
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = w132 - w54 * w127
    C_q[31, 25] = w135 - w133
    C_q[31, 26] = w56 * w127 - w40 * w54
    C_q[31, 27] = w49 * w56 - w137
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = w133 - w55 * w123
    C_q[32, 25] = w42 * w54 - w136
    C_q[32, 26] = w137 - w131
    C_q[32, 27] = w54 * w123 - w49 * w55
    C_q[32, 30] = 1.0
    # hinge5.e0
    C_q[33, 31] = 1.0
    C_q[33, 39] = w162 * c44
    # hinge5.e1
    C_q[34, 32] = 1.0
    C_q[34, 39] = w163 * c43
    # hinge5.e2
    C_q[35, 33] = 1.0
    C_q[35, 39] = w256
    # hinge5.e3
    C_q[36, 34] = 1.0
    C_q[36, 39] = w257
    # hinge5.x
    C_q[37, 28] = -1.0
    C_q[37, 31] = w141 - w67 * w139
    C_q[37, 32] = w65 * w139 - w63 * w67
    C_q[37, 33] = w62 * w65 - w147
    C_q[37, 34] = w148 - w143
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = w143 - w64 * w140
    C_q[38, 32] = w147 - w144
    C_q[38, 33] = w67 * w140 - w62 * w64
    C_q[38, 34] = w66 * w67 - w149
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = w144 - w65 * w142
    C_q[39, 32] = w63 * w64 - w148
    C_q[39, 33] = w149 - w141
    C_q[39, 34] = w64 * w142 - w65 * w66
    C_t = ca.SX(40, 1)
    nu = ca.SX(40, 1)
    gamma = ca.vertcat(
        w164 * (w1 * w164) * c46,  # hinge0.e0
        w167,  # hinge0.e1
        w164 * (w3 * w164) * c31,  # hinge0.e2
        w169,  # hinge0.e3
        0.0,  # hinge0.x
        0.0,  # hinge0.y
        0.0,  # hinge0.z
        bar1_e3 * w171 - bar1_e0 * w172 - w175 - w175,  # hinge1.e0
        w176 + (w176 - (bar1_e1 * w172 + bar1_e2 * w171)),  # hinge1.e1
        bar1_e1 * w171 - bar1_e2 * w172 - w177 - w177,  # hinge1.e2
        w178 + (w178 - (bar1_e0 * w171 + bar1_e3 * w172)),  # hinge1.e3
        w179 * w181 - w182 * w183,  # hinge1.x
        w182 * w184 - w180 * w181,  # hinge1.y
        w180 * w183 - w179 * w184,  # hinge1.z
        bar2_e1 * w191 - bar2_e2 * w189 - bar2_e3 * w192 - bar2_e0 * w188 - w199 - w199,  # hinge2.e0
        w200 + (bar2_e2 * w192 - bar2_e3 * w189 - (bar2_e0 * w191 + bar2_e1 * w188) + w200),  # hinge2.e1
        w201 + (bar2_e0 * w189 - bar2_e2 * w188 - (bar2_e3 * w191 + bar2_e1 * w192) + w201),  # hinge2.e2
        w202 + (bar2_e0 * w192 - bar2_e3 * w188 + (bar2_e1 * w189 + bar2_e2 * w191) + w202),  # hinge2.e3
        w203 * w205 - w206 * w207,  # hinge2.x
        w206 * w208 - w204 * w205,  # hinge2.y
        w204 * w207 - w203 * w208,  # hinge2.z
        w209 * w211 - w212 * w213,  # hinge3.x
        w212 * w214 - w210 * w211,  # hinge3.y
        w210 * w213 - w209 * w214,  # hinge3.z
        w259,  # hinge3.parallel_x
        w261,  # hinge3.parallel_y
        w232 + (w232 - (bar5_e0 * w234 + bar5_e3 * w235)),  # hinge4.e0
        bar5_e2 * w235 - bar5_e1 * w234 - w236 - w236,  # hinge4.e1
        w237 + (w237 - (bar5_e2 * w234 + bar5_e1 * w235)),  # hinge4.e2
        bar5_e0 * w235 - bar5_e3 * w234 - w238 - w238,  # hinge4.e3
        w215 * w239 - w218 * w240,  # hinge4.x
        w218 * w241 - w216 * w239,  # hinge4.y
        w216 * w240 - w215 * w241,  # hinge4.z
        w242 * (w58 * w242) * c47,  # hinge5.e0
        w242 * (w59 * w242) * c43,  # hinge5.e1
        w246,  # hinge5.e2
        w247,  # hinge5.e3
        w248 * w250 - w251 * w252,  # hinge5.x
        w251 * w253 - w249 * w250,  # hinge5.y
        w249 * w252 - w248 * w253,  # hinge5.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 40 x 40) [SI]: mass matrix in all coordinates
    gives K (n x n = 40 x 40) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 40) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 40) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 40) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 40 x 40) [SI]: constraint Jacobian
    gives gamma (n_c = 40) [m/s^2, rad/s^2]: right-hand side at acceleration level
    1889 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 109)
    bar1_e0 = q[3]
    bar1_e1 = q[4]
    bar1_e2 = q[5]
    bar1_e3 = q[6]
    bar2_e0 = q[10]
    bar2_e1 = q[11]
    bar2_e2 = q[12]
    bar2_e3 = q[13]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar4_e0 = q[24]
    bar4_e1 = q[25]
    bar4_e2 = q[26]
    bar4_e3 = q[27]
    bar5_e0 = q[31]
    bar5_e1 = q[32]
    bar5_e2 = q[33]
    bar5_e3 = q[34]
    hinge0_angle = q[35]
    hinge1_angle = q[36]
    hinge2_angle = q[37]
    hinge4_angle = q[38]
    hinge5_angle = q[39]
    bar1_e0_dot = q_dot[3]
    bar1_e1_dot = q_dot[4]
    bar1_e2_dot = q_dot[5]
    bar1_e3_dot = q_dot[6]
    bar2_e0_dot = q_dot[10]
    bar2_e1_dot = q_dot[11]
    bar2_e2_dot = q_dot[12]
    bar2_e3_dot = q_dot[13]
    bar3_e0_dot = q_dot[17]
    bar3_e1_dot = q_dot[18]
    bar3_e2_dot = q_dot[19]
    bar3_e3_dot = q_dot[20]
    bar4_e0_dot = q_dot[24]
    bar4_e1_dot = q_dot[25]
    bar4_e2_dot = q_dot[26]
    bar4_e3_dot = q_dot[27]
    bar5_e0_dot = q_dot[31]
    bar5_e1_dot = q_dot[32]
    bar5_e2_dot = q_dot[33]
    bar5_e3_dot = q_dot[34]
    hinge0_angle_dot = q_dot[35]
    hinge1_angle_dot = q_dot[36]
    hinge2_angle_dot = q_dot[37]
    hinge4_angle_dot = q_dot[38]
    hinge5_angle_dot = q_dot[39]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c16 = c[16]
    c22 = c[22]
    gravity_y = c[24]
    ground_P0_quaternion_0_0_0 = c[26]
    bar1_start_quaternion_0_0_0 = c[27]
    ground_P0_quaternion_1_0_0 = c[28]
    bar1_start_quaternion_1_0_0 = c[29]
    c30 = c[30]
    c31 = c[31]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    c46 = c[46]
    c47 = c[47]
    bar3_mass = c[48]
    bar2_mass = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    bar1_mass = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    bar4_mass = c[58]
    c59 = c[59]
    c60 = c[60]
    bar5_mass = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    c89 = c[89]
    c90 = c[90]
    c91 = c[91]
    c92 = c[92]
    c93 = c[93]
    c94 = c[94]
    c95 = c[95]
    c96 = c[96]
    c97 = c[97]
    c98 = c[98]
    c99 = c[99]
    c100 = c[100]
    c101 = c[101]
    c102 = c[102]
    c103 = c[103]
    # intermediate terms (623)
    w0 = 2 * -bar1_e2
    w1 = 2 * bar1_e1
    w2 = w1 * bar1_e3
    w3 = 2 * bar1_e2
    w4 = w3 * bar1_e0
    w5 = w2 - w4
    w6 = w5 * c66
    w7 = 2 * -bar1_e3
    w8 = bar1_e2 * w1
    w9 = 2 * bar1_e3
    w10 = bar1_e0 * w9
    w11 = w8 + w10
    w12 = w11 * c66
    w13 = w7 * w12
    w14 = w0 * w6 - w13
    w15 = w6 * w9 - w0 * w12
    w16 = 2 * bar1_e0
    w17 = w6 * w16
    w18 = w17 - w1 * w12
    w19 = 2 * -bar1_e1
    w20 = w6 * w19
    w21 = w12 * w16
    w22 = w20 - w21
    w23 = bar1_e2 * w3
    w24 = bar1_e3 * w9
    w25 = 1.0 - (w23 + w24)
    w26 = w25 * c66
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
    w37 = w16 * c68
    w38 = w19 * w37 + bar1_e2 * bar1_e3 * c71
    w39 = w16 * c69
    w40 = w19 * c70
    w41 = w0 * w39 + bar1_e1 * bar1_e3 * c72
    w42 = w0 * c68
    w43 = w1 * c69
    w44 = w16 * c70
    w45 = bar1_e2 * bar1_e1 * c73 + w7 * w44
    w46 = bar1_e3 * bar1_e0 * c73 + w3 * w40
    w47 = w7 * w43 + bar1_e2 * bar1_e0 * c72
    w48 = w9 * w42 + bar1_e1 * bar1_e0 * c71
    w49 = 2 * -bar2_e2
    w50 = 2 * bar2_e2
    w51 = w50 * bar2_e3
    w52 = 2 * bar2_e1
    w53 = w52 * bar2_e0
    w54 = w51 + w53
    w55 = w54 * c53
    w56 = 2 * -bar2_e3
    w57 = bar2_e1 * w52
    w58 = 2 * bar2_e3
    w59 = bar2_e3 * w58
    w60 = 1.0 - (w57 + w59)
    w61 = w60 * c53
    w62 = w56 * w61
    w63 = w49 * w55 - w62
    w64 = w55 * w58 - w49 * w61
    w65 = 2 * bar2_e0
    w66 = w55 * w65
    w67 = w66 - w52 * w61
    w68 = 2 * -bar2_e1
    w69 = w55 * w68
    w70 = w61 * w65
    w71 = w69 - w70
    w72 = bar2_e2 * w52
    w73 = bar2_e0 * w58
    w74 = w72 - w73
    w75 = w74 * c53
    w76 = w56 * w75 - w69
    w77 = w49 * w75
    w78 = w77 - w66
    w79 = w52 * w75 - w55 * w56
    w80 = w65 * w75
    w81 = w80 - w50 * w55
    w82 = w61 * w68 - w77
    w83 = w70 - w58 * w75
    w84 = w62 - w80
    w85 = w50 * w61 - w68 * w75
    w86 = w65 * c74
    w87 = w68 * w86 + bar2_e2 * bar2_e3 * c77
    w88 = w65 * c75
    w89 = w68 * c76
    w90 = w49 * w88 + bar2_e3 * bar2_e1 * c78
    w91 = w49 * c74
    w92 = w52 * c75
    w93 = w65 * c76
    w94 = bar2_e2 * bar2_e1 * c79 + w56 * w93
    w95 = bar2_e3 * bar2_e0 * c79 + w50 * w89
    w96 = w56 * w92 + bar2_e2 * bar2_e0 * c78
    w97 = w58 * w91 + bar2_e1 * bar2_e0 * c77
    w98 = 2 * -bar3_e2
    w99 = 2 * bar3_e1
    w100 = bar3_e1 * w99
    w101 = 2 * bar3_e2
    w102 = bar3_e2 * w101
    w103 = 1.0 - (w100 + w102)
    w104 = w103 * c4
    w105 = 2 * -bar3_e3
    w106 = w101 * bar3_e3
    w107 = w99 * bar3_e0
    w108 = w106 - w107
    w109 = w108 * c4
    w110 = w105 * w109
    w111 = w98 * w104 - w110
    w112 = 2 * bar3_e3
    w113 = w104 * w112 - w98 * w109
    w114 = 2 * bar3_e0
    w115 = w104 * w114
    w116 = w115 - w99 * w109
    w117 = 2 * -bar3_e1
    w118 = w104 * w117
    w119 = w109 * w114
    w120 = w118 - w119
    w121 = w99 * bar3_e3
    w122 = w101 * bar3_e0
    w123 = w121 + w122
    w124 = w123 * c4
    w125 = w105 * w124 - w118
    w126 = w98 * w124
    w127 = w126 - w115
    w128 = w99 * w124 - w104 * w105
    w129 = w114 * w124
    w130 = w129 - w101 * w104
    w131 = w109 * w117 - w126
    w132 = w119 - w112 * w124
    w133 = w110 - w129
    w134 = w101 * w109 - w117 * w124
    w135 = w114 * c22
    w136 = w117 * w135 + bar3_e2 * bar3_e3 * c82
    w137 = w114 * c80
    w138 = w117 * c81
    w139 = w98 * w137 + bar3_e1 * bar3_e3 * c83
    w140 = w98 * c22
    w141 = w99 * c80
    w142 = w114 * c81
    w143 = bar3_e2 * bar3_e1 * c84 + w105 * w142
    w144 = bar3_e3 * bar3_e0 * c84 + w101 * w138
    w145 = w105 * w141 + bar3_e2 * bar3_e0 * c83
    w146 = w112 * w140 + bar3_e1 * bar3_e0 * c82
    w147 = 2 * -bar4_e2
    w148 = 2 * bar4_e1
    w149 = w148 * bar4_e3
    w150 = 2 * bar4_e2
    w151 = w150 * bar4_e0
    w152 = w149 - w151
    w153 = w152 * c60
    w154 = 2 * -bar4_e3
    w155 = bar4_e2 * w148
    w156 = 2 * bar4_e3
    w157 = bar4_e0 * w156
    w158 = w155 + w157
    w159 = w158 * c60
    w160 = w154 * w159
    w161 = w147 * w153 - w160
    w162 = w153 * w156 - w147 * w159
    w163 = 2 * bar4_e0
    w164 = w153 * w163
    w165 = w164 - w148 * w159
    w166 = 2 * -bar4_e1
    w167 = w153 * w166
    w168 = w159 * w163
    w169 = w167 - w168
    w170 = bar4_e2 * w150
    w171 = bar4_e3 * w156
    w172 = 1.0 - (w170 + w171)
    w173 = w172 * c60
    w174 = w154 * w173 - w167
    w175 = w147 * w173
    w176 = w175 - w164
    w177 = w148 * w173 - w153 * w154
    w178 = w163 * w173
    w179 = w178 - w150 * w153
    w180 = w159 * w166 - w175
    w181 = w168 - w156 * w173
    w182 = w160 - w178
    w183 = w150 * w159 - w166 * w173
    w184 = w163 * c85
    w185 = w166 * w184 + bar4_e2 * bar4_e3 * c88
    w186 = w163 * c86
    w187 = w166 * c87
    w188 = w147 * w186 + bar4_e1 * bar4_e3 * c89
    w189 = w147 * c85
    w190 = w148 * c86
    w191 = w163 * c87
    w192 = bar4_e2 * bar4_e1 * c90 + w154 * w191
    w193 = bar4_e3 * bar4_e0 * c90 + w150 * w187
    w194 = w154 * w190 + bar4_e2 * bar4_e0 * c89
    w195 = w156 * w189 + bar4_e1 * bar4_e0 * c88
    w196 = 2 * -bar5_e2
    w197 = 2 * bar5_e2
    w198 = w197 * bar5_e3
    w199 = 2 * bar5_e1
    w200 = w199 * bar5_e0
    w201 = w198 + w200
    w202 = w201 * c63
    w203 = 2 * -bar5_e3
    w204 = bar5_e1 * w199
    w205 = 2 * bar5_e3
    w206 = bar5_e3 * w205
    w207 = 1.0 - (w204 + w206)
    w208 = w207 * c63
    w209 = w203 * w208
    w210 = w196 * w202 - w209
    w211 = w202 * w205 - w196 * w208
    w212 = 2 * bar5_e0
    w213 = w202 * w212
    w214 = w213 - w199 * w208
    w215 = 2 * -bar5_e1
    w216 = w202 * w215
    w217 = w208 * w212
    w218 = w216 - w217
    w219 = bar5_e2 * w199
    w220 = bar5_e0 * w205
    w221 = w219 - w220
    w222 = w221 * c63
    w223 = w203 * w222 - w216
    w224 = w196 * w222
    w225 = w224 - w213
    w226 = w199 * w222 - w202 * w203
    w227 = w212 * w222
    w228 = w227 - w197 * w202
    w229 = w208 * w215 - w224
    w230 = w217 - w205 * w222
    w231 = w209 - w227
    w232 = w197 * w208 - w215 * w222
    w233 = w212 * c91
    w234 = w215 * w233 + bar5_e2 * bar5_e3 * c95
    w235 = w212 * c93
    w236 = w215 * c94
    w237 = w196 * w235 + bar5_e3 * bar5_e1 * c96
    w238 = w196 * c91
    w239 = w199 * c93
    w240 = w212 * c94
    w241 = bar5_e2 * bar5_e1 * c97 + w203 * w240
    w242 = bar5_e3 * bar5_e0 * c97 + w197 * w236
    w243 = w203 * w239 + bar5_e2 * bar5_e0 * c96
    w244 = w205 * w238 + bar5_e1 * bar5_e0 * c95
    w245 = w7 * bar1_e0_dot
    w246 = w16 * bar1_e3_dot
    w247 = w245 + w3 * bar1_e1_dot + w19 * bar1_e2_dot + w246
    w248 = w247 * c66
    w249 = w0 * bar1_e0_dot
    w250 = w16 * bar1_e2_dot
    w251 = w249 + w7 * bar1_e1_dot + w250 + w1 * bar1_e3_dot
    w252 = w251 * c66
    w253 = w247 * w248 + w251 * w252
    w254 = w19 * bar1_e0_dot + w16 * bar1_e1_dot
    w255 = w254 + w9 * bar1_e2_dot + w0 * bar1_e3_dot
    w256 = w252 * w255
    w257 = w248 * w255
    w258 = w25 * w253 - (w8 - w10) * w256 - (w2 + w4) * w257
    w259 = bar1_e1 * w1
    w260 = bar1_e3 * w3
    w261 = w1 * bar1_e0
    w262 = w11 * w253 - w256 * (1.0 - (w24 + w259)) - w257 * (w260 - w261)
    w263 = w5 * w253 - w256 * (w260 + w261) - w257 * (1.0 - (w23 + w259))
    w264 = w247 * c56
    w265 = w251 * c67
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c55
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w19 * w266 + w0 * w268 + w7 * w269
    w271 = w16 * w266 + w7 * w268 + w3 * w269
    w272 = w9 * w266 + w16 * w268 + w19 * w269
    w273 = w0 * w266 + w1 * w268 + w16 * w269
    w274 = w68 * bar2_e0_dot + w65 * bar2_e1_dot
    w275 = w274 + w58 * bar2_e2_dot + w49 * bar2_e3_dot
    w276 = w275 * c53
    w277 = w56 * bar2_e0_dot
    w278 = w65 * bar2_e3_dot
    w279 = w277 + w50 * bar2_e1_dot + w68 * bar2_e2_dot + w278
    w280 = w279 * c53
    w281 = w275 * w276 + w279 * w280
    w282 = bar2_e2 * w50
    w283 = w49 * bar2_e0_dot
    w284 = w65 * bar2_e2_dot
    w285 = w283 + w56 * bar2_e1_dot + w284 + w52 * bar2_e3_dot
    w286 = w276 * w285
    w287 = bar2_e3 * w52
    w288 = w50 * bar2_e0
    w289 = w280 * w285
    w290 = w74 * w281 - (1.0 - (w59 + w282)) * w286 - (w287 + w288) * w289
    w291 = w60 * w281 - w286 * (w72 + w73) - w289 * (w51 - w53)
    w292 = w54 * w281 - w286 * (w287 - w288) - w289 * (1.0 - (w57 + w282))
    w293 = w279 * c57
    w294 = w285 * c50
    w295 = w285 * w293 - w279 * w294
    w296 = w275 * c51
    w297 = w279 * w296 - w275 * w293
    w298 = w275 * w294 - w285 * w296
    w299 = w68 * w295 + w49 * w297 + w56 * w298
    w300 = w65 * w295 + w56 * w297 + w50 * w298
    w301 = w58 * w295 + w65 * w297 + w68 * w298
    w302 = w49 * w295 + w52 * w297 + w65 * w298
    w303 = w98 * bar3_e0_dot
    w304 = w114 * bar3_e2_dot
    w305 = w303 + w105 * bar3_e1_dot + w304 + w99 * bar3_e3_dot
    w306 = w305 * c4
    w307 = w117 * bar3_e0_dot + w114 * bar3_e1_dot
    w308 = w307 + w112 * bar3_e2_dot + w98 * bar3_e3_dot
    w309 = w308 * c4
    w310 = w305 * w306 + w308 * w309
    w311 = bar3_e3 * w112
    w312 = 1.0 - (w102 + w311)
    w313 = w105 * bar3_e0_dot
    w314 = w114 * bar3_e3_dot
    w315 = w313 + w101 * bar3_e1_dot + w117 * bar3_e2_dot + w314
    w316 = w309 * w315
    w317 = bar3_e2 * w99
    w318 = bar3_e0 * w112
    w319 = w306 * w315
    w320 = w123 * w310 - (w312 * w316 + (w317 - w318) * w319)
    w321 = w317 + w318
    w322 = w108 * w310 - (w316 * w321 + w319 * (1.0 - (w100 + w311)))
    w323 = w121 - w122
    w324 = w103 * w310 - (w316 * w323 + w319 * (w106 + w107))
    w325 = w315 * c0
    w326 = w305 * c1
    w327 = w305 * w325 - w315 * w326
    w328 = w308 * c52
    w329 = w315 * w328 - w308 * w325
    w330 = w308 * w326 - w305 * w328
    w331 = w117 * w327 + w98 * w329 + w105 * w330
    w332 = w114 * w327 + w105 * w329 + w101 * w330
    w333 = w112 * w327 + w114 * w329 + w117 * w330
    w334 = w98 * w327 + w99 * w329 + w114 * w330
    w335 = w154 * bar4_e0_dot
    w336 = w163 * bar4_e3_dot
    w337 = w335 + w150 * bar4_e1_dot + w166 * bar4_e2_dot + w336
    w338 = w337 * c60
    w339 = w147 * bar4_e0_dot
    w340 = w163 * bar4_e2_dot
    w341 = w339 + w154 * bar4_e1_dot + w340 + w148 * bar4_e3_dot
    w342 = w341 * c60
    w343 = w337 * w338 + w341 * w342
    w344 = w155 - w157
    w345 = w166 * bar4_e0_dot + w163 * bar4_e1_dot
    w346 = w345 + w156 * bar4_e2_dot + w147 * bar4_e3_dot
    w347 = w342 * w346
    w348 = w338 * w346
    w349 = w172 * w343 - w344 * w347 - (w149 + w151) * w348
    w350 = bar4_e1 * w148
    w351 = 1.0 - (w171 + w350)
    w352 = bar4_e3 * w150
    w353 = w148 * bar4_e0
    w354 = w158 * w343 - w347 * w351 - w348 * (w352 - w353)
    w355 = w352 + w353
    w356 = w152 * w343 - w347 * w355 - w348 * (1.0 - (w170 + w350))
    w357 = w337 * c65
    w358 = w341 * c16
    w359 = w341 * w357 - w337 * w358
    w360 = w346 * c59
    w361 = w337 * w360 - w346 * w357
    w362 = w346 * w358 - w341 * w360
    w363 = w166 * w359 + w147 * w361 + w154 * w362
    w364 = w163 * w359 + w154 * w361 + w150 * w362
    w365 = w156 * w359 + w163 * w361 + w166 * w362
    w366 = w147 * w359 + w148 * w361 + w163 * w362
    w367 = w215 * bar5_e0_dot + w212 * bar5_e1_dot
    w368 = w367 + w205 * bar5_e2_dot + w196 * bar5_e3_dot
    w369 = w368 * c63
    w370 = w203 * bar5_e0_dot
    w371 = w212 * bar5_e3_dot
    w372 = w370 + w197 * bar5_e1_dot + w215 * bar5_e2_dot + w371
    w373 = w372 * c63
    w374 = w368 * w369 + w372 * w373
    w375 = bar5_e2 * w197
    w376 = w196 * bar5_e0_dot
    w377 = w212 * bar5_e2_dot
    w378 = w376 + w203 * bar5_e1_dot + w377 + w199 * bar5_e3_dot
    w379 = w369 * w378
    w380 = bar5_e3 * w199
    w381 = w197 * bar5_e0
    w382 = w373 * w378
    w383 = w221 * w374 - (1.0 - (w206 + w375)) * w379 - (w380 + w381) * w382
    w384 = w207 * w374 - w379 * (w219 + w220) - w382 * (w198 - w200)
    w385 = w201 * w374 - w379 * (w380 - w381) - w382 * (1.0 - (w204 + w375))
    w386 = w372 * c64
    w387 = w378 * c62
    w388 = w378 * w386 - w372 * w387
    w389 = w368 * c92
    w390 = w372 * w389 - w368 * w386
    w391 = w368 * w387 - w378 * w389
    w392 = w215 * w388 + w196 * w390 + w203 * w391
    w393 = w212 * w388 + w203 * w390 + w197 * w391
    w394 = w205 * w388 + w212 * w390 + w215 * w391
    w395 = w196 * w388 + w199 * w390 + w212 * w391
    w396 = w27 * gravity_y
    w397 = w29 * gravity_y
    w398 = w30 * gravity_y
    w399 = w32 * gravity_y
    w400 = w76 * gravity_y
    w401 = w78 * gravity_y
    w402 = w79 * gravity_y
    w403 = w81 * gravity_y
    w404 = w125 * gravity_y
    w405 = w127 * gravity_y
    w406 = w128 * gravity_y
    w407 = w130 * gravity_y
    w408 = w174 * gravity_y
    w409 = w176 * gravity_y
    w410 = w177 * gravity_y
    w411 = w179 * gravity_y
    w412 = w223 * gravity_y
    w413 = w225 * gravity_y
    w414 = w226 * gravity_y
    w415 = w228 * gravity_y
    w416 = hinge1_angle / 2.0
    w417 = ca.cos(w416)
    w418 = -w417
    w419 = ca.sin(w416)
    w420 = -w419
    w421 = w5 * bar1_end_x
    w422 = w11 * bar1_end_x
    w423 = w7 * w422
    w424 = w25 * bar1_end_x
    w425 = w19 * w421
    w426 = w0 * w424
    w427 = w16 * w421
    w428 = w16 * w422
    w429 = w16 * w424
    w430 = hinge2_angle / 2.0
    w431 = ca.cos(w430)
    w432 = w431 * c103
    w433 = ca.sin(w430)
    w434 = w433 * c38
    w435 = -w434
    w436 = w431 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w431 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w437 = -w436
    w438 = w433 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w433 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w439 = -w438
    w440 = w54 * bar2_end_y
    w441 = w60 * bar2_end_y
    w442 = w56 * w441
    w443 = w74 * bar2_end_y
    w444 = w68 * w440
    w445 = w49 * w443
    w446 = w65 * w440
    w447 = w65 * w441
    w448 = w65 * w443
    w449 = w103 * bar3_end_z
    w450 = w108 * bar3_end_z
    w451 = w105 * w450
    w452 = w123 * bar3_end_z
    w453 = w117 * w449
    w454 = w98 * w452
    w455 = w321 * w355
    w456 = w323 * w351
    w457 = w455 - w456
    w458 = w323 * w344
    w459 = w312 * w355
    w460 = w458 - w459
    w461 = w312 * w351
    w462 = w321 * w344
    w463 = w461 - w462
    w464 = w103 * w351
    w465 = w108 * w355
    w466 = w464 - w465
    w467 = w123 * w355
    w468 = w103 * w344
    w469 = w467 - w468
    w470 = w108 * w344
    w471 = w123 * w351
    w472 = w470 - w471
    w473 = w114 * w449
    w474 = w114 * w450
    w475 = w114 * w452
    w476 = w456 - w455
    w477 = w459 - w458
    w478 = w462 - w461
    w479 = w465 - w464
    w480 = w468 - w467
    w481 = w471 - w470
    w482 = w152 * bar4_end_x
    w483 = w158 * bar4_end_x
    w484 = w154 * w483
    w485 = w172 * bar4_end_x
    w486 = w166 * w482
    w487 = w147 * w485
    w488 = w163 * w482
    w489 = w163 * w483
    w490 = w163 * w485
    w491 = hinge4_angle / 2.0
    w492 = ca.cos(w491)
    w493 = -w492
    w494 = ca.sin(w491)
    w495 = w201 * bar5_end_y
    w496 = w207 * bar5_end_y
    w497 = w203 * w496
    w498 = w221 * bar5_end_y
    w499 = w215 * w495
    w500 = w196 * w498
    w501 = -w494
    w502 = w212 * w495
    w503 = w212 * w496
    w504 = w212 * w498
    w505 = hinge0_angle / 2.0
    w506 = ca.sin(w505)
    w507 = w506 / 2.0
    w508 = ca.cos(w505)
    w509 = w508 / 2.0
    w510 = w419 / 2.0
    w511 = w417 / 2.0
    w512 = w433 / 2.0
    w513 = w512 * c37
    w514 = w431 / 2.0
    w515 = w514 * c38
    w516 = w512 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w512 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w517 = w514 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w514 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w518 = w492 / 2.0
    w519 = w494 / 2.0
    w520 = hinge5_angle / 2.0
    w521 = ca.sin(w520)
    w522 = w521 / 2.0
    w523 = ca.cos(w520)
    w524 = w523 / 2.0
    w525 = hinge0_angle_dot / 2.0
    w526 = w525**2
    w527 = w508 * w526
    w528 = w527 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w527 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w529 = w506 * w526
    w530 = w529 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w529 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w531 = (hinge1_angle_dot / 2.0)**2
    w532 = w419 * w531
    w533 = w417 * w531
    w534 = w510 * hinge1_angle_dot
    w535 = w511 * hinge1_angle_dot
    w536 = bar1_e0_dot * w534 + bar1_e3_dot * w535
    w537 = bar1_e2_dot * w535 - bar1_e1_dot * w534
    w538 = bar1_e2_dot * w534 + bar1_e1_dot * w535
    w539 = bar1_e0_dot * w535 - bar1_e3_dot * w534
    w540 = w250 + (w249 + w9 * bar1_e1_dot) + w19 * bar1_e3_dot
    w541 = w254 + w7 * bar1_e2_dot + w3 * bar1_e3_dot
    w542 = w422 * w541 - w424 * w540
    w543 = w246 + (w245 + w0 * bar1_e1_dot + w1 * bar1_e2_dot)
    w544 = w424 * w543 - w421 * w541
    w545 = w421 * w540 - w422 * w543
    w546 = hinge2_angle_dot / 2.0
    w547 = w546**2
    w548 = w431 * w547
    w549 = w546 * (w431 * w546) * c37
    w550 = w548 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w548 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w551 = w433 * w547
    w552 = w546 * (w433 * w546) * c38
    w553 = w551 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w551 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w554 = w512 * hinge2_angle_dot
    w555 = w554 * c37
    w556 = w514 * hinge2_angle_dot
    w557 = w556 * c38
    w558 = w554 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w554 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w559 = w556 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w556 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w560 = bar2_e0_dot * w555 + (bar2_e1_dot * w557 + bar2_e2_dot * w558 + bar2_e3_dot * w559)
    w561 = bar2_e0_dot * w557 - bar2_e1_dot * w555 + (bar2_e2_dot * w559 - bar2_e3_dot * w558)
    w562 = bar2_e0_dot * w558 - bar2_e2_dot * w555 + (bar2_e3_dot * w557 - bar2_e1_dot * w559)
    w563 = bar2_e0_dot * w559 - bar2_e3_dot * w555 + (bar2_e1_dot * w558 - bar2_e2_dot * w557)
    w564 = w284 + (w283 + w58 * bar2_e1_dot) + w68 * bar2_e3_dot
    w565 = w274 + w56 * bar2_e2_dot + w50 * bar2_e3_dot
    w566 = w441 * w565 - w443 * w564
    w567 = w278 + (w277 + w49 * bar2_e1_dot + w52 * bar2_e2_dot)
    w568 = w443 * w567 - w440 * w565
    w569 = w440 * w564 - w441 * w567
    w570 = w304 + (w303 + w112 * bar3_e1_dot) + w117 * bar3_e3_dot
    w571 = w307 + w105 * bar3_e2_dot + w101 * bar3_e3_dot
    w572 = w450 * w571 - w452 * w570
    w573 = w314 + (w313 + w98 * bar3_e1_dot + w99 * bar3_e2_dot)
    w574 = w452 * w573 - w449 * w571
    w575 = w449 * w570 - w450 * w573
    w576 = w340 + (w339 + w156 * bar4_e1_dot) + w166 * bar4_e3_dot
    w577 = w345 + w154 * bar4_e2_dot + w150 * bar4_e3_dot
    w578 = w351 * w577 - w344 * w576
    w579 = w336 + (w335 + w147 * bar4_e1_dot + w148 * bar4_e2_dot)
    w580 = w344 * w579 - w355 * w577
    w581 = w576 * w578 - w579 * w580
    w582 = w355 * w576 - w351 * w579
    w583 = w579 * w582 - w577 * w578
    w584 = w577 * w580 - w576 * w582
    w585 = w321 * w571 - w312 * w570
    w586 = w312 * w573 - w323 * w571
    w587 = w323 * w570 - w321 * w573
    w588 = w123 * w570 - w108 * w571
    w589 = w103 * w571 - w123 * w573
    w590 = w108 * w573 - w103 * w570
    w591 = w518 * hinge4_angle_dot
    w592 = w519 * hinge4_angle_dot
    w593 = bar5_e3_dot * w591 - bar5_e0_dot * w592
    w594 = (hinge4_angle_dot / 2.0)**2
    w595 = w492 * w594
    w596 = w494 * w594
    w597 = bar5_e1_dot * w592 + bar5_e2_dot * w591
    w598 = bar5_e1_dot * w591 - bar5_e2_dot * w592
    w599 = bar5_e0_dot * w591 + bar5_e3_dot * w592
    w600 = w483 * w577 - w485 * w576
    w601 = w485 * w579 - w482 * w577
    w602 = w482 * w576 - w483 * w579
    w603 = hinge5_angle_dot / 2.0
    w604 = w603**2
    w605 = w523 * w604
    w606 = w521 * w604
    w607 = w605 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w605 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w608 = w606 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w606 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w609 = w377 + (w376 + w205 * bar5_e1_dot) + w215 * bar5_e3_dot
    w610 = w367 + w203 * bar5_e2_dot + w197 * bar5_e3_dot
    w611 = w496 * w610 - w498 * w609
    w612 = w371 + (w370 + w196 * bar5_e1_dot + w199 * bar5_e2_dot)
    w613 = w498 * w612 - w495 * w610
    w614 = w495 * w609 - w496 * w612
    w615 = w507 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w507 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w616 = w509 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w509 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w617 = w522 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w522 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w618 = w524 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w524 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w619 = (w573 * w586 - w570 * w585) * w344 - (w312 * w581 + w321 * w583 + w323 * w584) - w351 * (w573 * w587 - w571 * w585)
    w620 = w619 - w355 * (w571 * w586 - w570 * w587) - w582 * (2 * w587) - w580 * (2 * w586) - w578 * (2 * w585)
    w621 = w123 * w581 + w108 * w583 + w103 * w584 - w344 * (w570 * w588 - w573 * w589) - w351 * (w573 * w590 - w571 * w588)
    w622 = w621 - w355 * (w571 * w589 - w570 * w590) - w582 * (2 * w590) - w580 * (2 * w589) - w578 * (2 * w588)
    # outputs
    M = ca.SX(40, 40)
    # bar1.x
    M[0, 0] = bar1_mass
    M[0, 3] = w14
    M[0, 4] = w15
    M[0, 5] = w18
    M[0, 6] = w22
    # bar1.y
    M[1, 1] = bar1_mass
    M[1, 3] = w27
    M[1, 4] = w29
    M[1, 5] = w30
    M[1, 6] = w32
    # bar1.z
    M[2, 2] = bar1_mass
    M[2, 3] = w33
    M[2, 4] = w34
    M[2, 5] = w35
    M[2, 6] = w36
    # bar1.e0
    M[3, 0] = w14
    M[3, 1] = w27
    M[3, 2] = w33
    M[3, 3] = w19 * (w19 * c68) + w0 * (w0 * c69) + w7 * (w7 * c70)
    M[3, 4] = w38
    M[3, 5] = w41
    M[3, 6] = w45
    # bar1.e1
    M[4, 0] = w15
    M[4, 1] = w29
    M[4, 2] = w34
    M[4, 3] = w38
    M[4, 4] = w16 * w37 + w7 * (w7 * c69) + w3 * (w3 * c70)
    M[4, 5] = w46
    M[4, 6] = w47
    # bar1.e2
    M[5, 0] = w18
    M[5, 1] = w30
    M[5, 2] = w35
    M[5, 3] = w41
    M[5, 4] = w46
    M[5, 5] = w9 * (w9 * c68) + w16 * w39 + w19 * w40
    M[5, 6] = w48
    # bar1.e3
    M[6, 0] = w22
    M[6, 1] = w32
    M[6, 2] = w36
    M[6, 3] = w45
    M[6, 4] = w47
    M[6, 5] = w48
    M[6, 6] = w0 * w42 + w1 * w43 + w16 * w44
    # bar2.x
    M[7, 7] = bar2_mass
    M[7, 10] = w63
    M[7, 11] = w64
    M[7, 12] = w67
    M[7, 13] = w71
    # bar2.y
    M[8, 8] = bar2_mass
    M[8, 10] = w76
    M[8, 11] = w78
    M[8, 12] = w79
    M[8, 13] = w81
    # bar2.z
    M[9, 9] = bar2_mass
    M[9, 10] = w82
    M[9, 11] = w83
    M[9, 12] = w84
    M[9, 13] = w85
    # bar2.e0
    M[10, 7] = w63
    M[10, 8] = w76
    M[10, 9] = w82
    M[10, 10] = w68 * (w68 * c74) + w49 * (w49 * c75) + w56 * (w56 * c76)
    M[10, 11] = w87
    M[10, 12] = w90
    M[10, 13] = w94
    # bar2.e1
    M[11, 7] = w64
    M[11, 8] = w78
    M[11, 9] = w83
    M[11, 10] = w87
    M[11, 11] = w65 * w86 + w56 * (w56 * c75) + w50 * (w50 * c76)
    M[11, 12] = w95
    M[11, 13] = w96
    # bar2.e2
    M[12, 7] = w67
    M[12, 8] = w79
    M[12, 9] = w84
    M[12, 10] = w90
    M[12, 11] = w95
    M[12, 12] = w58 * (w58 * c74) + w65 * w88 + w68 * w89
    M[12, 13] = w97
    # bar2.e3
    M[13, 7] = w71
    M[13, 8] = w81
    M[13, 9] = w85
    M[13, 10] = w94
    M[13, 11] = w96
    M[13, 12] = w97
    M[13, 13] = w49 * w91 + w52 * w92 + w65 * w93
    # bar3.x
    M[14, 14] = bar3_mass
    M[14, 17] = w111
    M[14, 18] = w113
    M[14, 19] = w116
    M[14, 20] = w120
    # bar3.y
    M[15, 15] = bar3_mass
    M[15, 17] = w125
    M[15, 18] = w127
    M[15, 19] = w128
    M[15, 20] = w130
    # bar3.z
    M[16, 16] = bar3_mass
    M[16, 17] = w131
    M[16, 18] = w132
    M[16, 19] = w133
    M[16, 20] = w134
    # bar3.e0
    M[17, 14] = w111
    M[17, 15] = w125
    M[17, 16] = w131
    M[17, 17] = w117 * (w117 * c22) + w98 * (w98 * c80) + w105 * (w105 * c81)
    M[17, 18] = w136
    M[17, 19] = w139
    M[17, 20] = w143
    # bar3.e1
    M[18, 14] = w113
    M[18, 15] = w127
    M[18, 16] = w132
    M[18, 17] = w136
    M[18, 18] = w114 * w135 + w105 * (w105 * c80) + w101 * (w101 * c81)
    M[18, 19] = w144
    M[18, 20] = w145
    # bar3.e2
    M[19, 14] = w116
    M[19, 15] = w128
    M[19, 16] = w133
    M[19, 17] = w139
    M[19, 18] = w144
    M[19, 19] = w112 * (w112 * c22) + w114 * w137 + w117 * w138
    M[19, 20] = w146
    # bar3.e3
    M[20, 14] = w120
    M[20, 15] = w130
    M[20, 16] = w134
    M[20, 17] = w143
    M[20, 18] = w145
    M[20, 19] = w146
    M[20, 20] = w98 * w140 + w99 * w141 + w114 * w142
    # bar4.x
    M[21, 21] = bar4_mass
    M[21, 24] = w161
    M[21, 25] = w162
    M[21, 26] = w165
    M[21, 27] = w169
    # bar4.y
    M[22, 22] = bar4_mass
    M[22, 24] = w174
    M[22, 25] = w176
    M[22, 26] = w177
    M[22, 27] = w179
    # bar4.z
    M[23, 23] = bar4_mass
    M[23, 24] = w180
    M[23, 25] = w181
    M[23, 26] = w182
    M[23, 27] = w183
    # bar4.e0
    M[24, 21] = w161
    M[24, 22] = w174
    M[24, 23] = w180
    M[24, 24] = w166 * (w166 * c85) + w147 * (w147 * c86) + w154 * (w154 * c87)
    M[24, 25] = w185
    M[24, 26] = w188
    M[24, 27] = w192
    # bar4.e1
    M[25, 21] = w162
    M[25, 22] = w176
    M[25, 23] = w181
    M[25, 24] = w185
    M[25, 25] = w163 * w184 + w154 * (w154 * c86) + w150 * (w150 * c87)
    M[25, 26] = w193
    M[25, 27] = w194
    # bar4.e2
    M[26, 21] = w165
    M[26, 22] = w177
    M[26, 23] = w182
    M[26, 24] = w188
    M[26, 25] = w193
    M[26, 26] = w156 * (w156 * c85) + w163 * w186 + w166 * w187
    M[26, 27] = w195
    # bar4.e3
    M[27, 21] = w169
    M[27, 22] = w179
    M[27, 23] = w183
    M[27, 24] = w192
    M[27, 25] = w194
    M[27, 26] = w195
    M[27, 27] = w147 * w189 + w148 * w190 + w163 * w191
    # bar5.x
    M[28, 28] = bar5_mass
    M[28, 31] = w210
    M[28, 32] = w211
    M[28, 33] = w214
    M[28, 34] = w218
    # bar5.y
    M[29, 29] = bar5_mass
    M[29, 31] = w223
    M[29, 32] = w225
    M[29, 33] = w226
    M[29, 34] = w228
    # bar5.z
    M[30, 30] = bar5_mass
    M[30, 31] = w229
    M[30, 32] = w230
    M[30, 33] = w231
    M[30, 34] = w232
    # bar5.e0
    M[31, 28] = w210
    M[31, 29] = w223
    M[31, 30] = w229
    M[31, 31] = w215 * (w215 * c91) + w196 * (w196 * c93) + w203 * (w203 * c94)
    M[31, 32] = w234
    M[31, 33] = w237
    M[31, 34] = w241
    # bar5.e1
    M[32, 28] = w211
    M[32, 29] = w225
    M[32, 30] = w230
    M[32, 31] = w234
    M[32, 32] = w212 * w233 + w203 * (w203 * c93) + w197 * (w197 * c94)
    M[32, 33] = w242
    M[32, 34] = w243
    # bar5.e2
    M[33, 28] = w214
    M[33, 29] = w226
    M[33, 30] = w231
    M[33, 31] = w237
    M[33, 32] = w242
    M[33, 33] = w205 * (w205 * c91) + w212 * w235 + w215 * w236
    M[33, 34] = w244
    # bar5.e3
    M[34, 28] = w218
    M[34, 29] = w228
    M[34, 30] = w232
    M[34, 31] = w241
    M[34, 32] = w243
    M[34, 33] = w244
    M[34, 34] = w196 * w238 + w199 * w239 + w212 * w240
    K = ca.SX(40, 40)
    Q_v = ca.vertcat(
        w258,  # bar1.x
        w262,  # bar1.y
        w263,  # bar1.z
        w270,  # bar1.e0
        w271,  # bar1.e1
        w272,  # bar1.e2
        w273,  # bar1.e3
        w290,  # bar2.x
        w291,  # bar2.y
        w292,  # bar2.z
        w299,  # bar2.e0
        w300,  # bar2.e1
        w301,  # bar2.e2
        w302,  # bar2.e3
        w320,  # bar3.x
        w322,  # bar3.y
        w324,  # bar3.z
        w331,  # bar3.e0
        w332,  # bar3.e1
        w333,  # bar3.e2
        w334,  # bar3.e3
        w349,  # bar4.x
        w354,  # bar4.y
        w356,  # bar4.z
        w363,  # bar4.e0
        w364,  # bar4.e1
        w365,  # bar4.e2
        w366,  # bar4.e3
        w383,  # bar5.x
        w384,  # bar5.y
        w385,  # bar5.z
        w392,  # bar5.e0
        w393,  # bar5.e1
        w394,  # bar5.e2
        w395,  # bar5.e3
        0.0,  # hinge0.angle
        0.0,  # hinge1.angle
        0.0,  # hinge2.angle
        0.0,  # hinge4.angle
        0.0,  # hinge5.angle
    )
    Q_F = ca.SX(40, 1)
    Q_F[1] = c98  # bar1.y
    Q_F[3] = w396  # bar1.e0
    Q_F[4] = w397  # bar1.e1
    Q_F[5] = w398  # bar1.e2
    Q_F[6] = w399  # bar1.e3
    Q_F[8] = c99  # bar2.y
    Q_F[10] = w400  # bar2.e0
    Q_F[11] = w401  # bar2.e1
    Q_F[12] = w402  # bar2.e2
    Q_F[13] = w403  # bar2.e3
    Q_F[15] = c100  # bar3.y
    Q_F[17] = w404  # bar3.e0
    Q_F[18] = w405  # bar3.e1
    Q_F[19] = w406  # bar3.e2
    Q_F[20] = w407  # bar3.e3
    Q_F[22] = c101  # bar4.y
    Q_F[24] = w408  # bar4.e0
    Q_F[25] = w409  # bar4.e1
    Q_F[26] = w410  # bar4.e2
    Q_F[27] = w411  # bar4.e3
    Q_F[29] = c102  # bar5.y
    Q_F[31] = w412  # bar5.e0
    Q_F[32] = w413  # bar5.e1
    Q_F[33] = w414  # bar5.e2
    Q_F[34] = w415  # bar5.e3
    Q_star = ca.vertcat(
        w258,  # bar1.x
        w262 + c98,  # bar1.y
        w263,  # bar1.z
        w270 + w396,  # bar1.e0
        w271 + w397,  # bar1.e1
        w272 + w398,  # bar1.e2
        w273 + w399,  # bar1.e3
        w290,  # bar2.x
        w291 + c99,  # bar2.y
        w292,  # bar2.z
        w299 + w400,  # bar2.e0
        w300 + w401,  # bar2.e1
        w301 + w402,  # bar2.e2
        w302 + w403,  # bar2.e3
        w320,  # bar3.x
        w322 + c100,  # bar3.y
        w324,  # bar3.z
        w331 + w404,  # bar3.e0
        w332 + w405,  # bar3.e1
        w333 + w406,  # bar3.e2
        w334 + w407,  # bar3.e3
        w349,  # bar4.x
        w354 + c101,  # bar4.y
        w356,  # bar4.z
        w363 + w408,  # bar4.e0
        w364 + w409,  # bar4.e1
        w365 + w410,  # bar4.e2
        w366 + w411,  # bar4.e3
        w383,  # bar5.x
        w384 + c102,  # bar5.y
        w385,  # bar5.z
        w392 + w412,  # bar5.e0
        w393 + w413,  # bar5.e1
        w394 + w414,  # bar5.e2
        w395 + w415,  # bar5.e3
        0.0,  # hinge0.angle
        0.0,  # hinge1.angle
        0.0,  # hinge2.angle
        0.0,  # hinge4.angle
        0.0,  # hinge5.angle
    )
    C_q = ca.SX(40, 40)
    # hinge0.e0
    C_q[0, 3] = 1.0
    C_q[0, 35] = w507 * c30
    # hinge0.e1
    C_q[1, 4] = 1.0
    C_q[1, 35] = w615
    # hinge0.e2
    C_q[2, 5] = 1.0
    C_q[2, 35] = w509 * c31
    # hinge0.e3
    C_q[3, 6] = 1.0
    C_q[3, 35] = w616
    # hinge0.x
    C_q[4, 0] = 1.0
    # hinge0.y
    C_q[5, 1] = 1.0
    # hinge0.z
    C_q[6, 2] = 1.0
    # hinge1.e0
    C_q[7, 3] = w418
    C_q[7, 6] = w419
    C_q[7, 10] = 1.0
    C_q[7, 36] = bar1_e0 * w510 + bar1_e3 * w511
    # hinge1.e1
    C_q[8, 4] = w418
    C_q[8, 5] = w420
    C_q[8, 11] = 1.0
    C_q[8, 36] = bar1_e1 * w510 - bar1_e2 * w511
    # hinge1.e2
    C_q[9, 4] = w419
    C_q[9, 5] = w418
    C_q[9, 12] = 1.0
    C_q[9, 36] = bar1_e2 * w510 + bar1_e1 * w511
    # hinge1.e3
    C_q[10, 3] = w420
    C_q[10, 6] = w418
    C_q[10, 13] = 1.0
    C_q[10, 36] = bar1_e3 * w510 - bar1_e0 * w511
    # hinge1.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = w423 - w0 * w421
    C_q[11, 4] = w0 * w422 - w9 * w421
    C_q[11, 5] = w1 * w422 - w427
    C_q[11, 6] = w428 - w425
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w425 - w7 * w424
    C_q[12, 4] = w427 - w426
    C_q[12, 5] = w7 * w421 - w1 * w424
    C_q[12, 6] = w3 * w421 - w429
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w426 - w19 * w422
    C_q[13, 4] = w9 * w424 - w428
    C_q[13, 5] = w429 - w423
    C_q[13, 6] = w19 * w424 - w3 * w422
    C_q[13, 9] = 1.0
    # hinge2.e0
    C_q[14, 10] = w432
    C_q[14, 11] = w434
    C_q[14, 12] = w436
    C_q[14, 13] = w438
    C_q[14, 17] = 1.0
    C_q[14, 37] = bar2_e0 * w513 + (bar2_e1 * w515 + bar2_e2 * w516 + bar2_e3 * w517)
    # hinge2.e1
    C_q[15, 10] = w435
    C_q[15, 11] = w432
    C_q[15, 12] = w439
    C_q[15, 13] = w436
    C_q[15, 18] = 1.0
    C_q[15, 37] = bar2_e1 * w513 - bar2_e0 * w515 - (bar2_e2 * w517 - bar2_e3 * w516)
    # hinge2.e2
    C_q[16, 10] = w437
    C_q[16, 11] = w438
    C_q[16, 12] = w432
    C_q[16, 13] = w435
    C_q[16, 19] = 1.0
    C_q[16, 37] = bar2_e2 * w513 - bar2_e0 * w516 - (bar2_e3 * w515 - bar2_e1 * w517)
    # hinge2.e3
    C_q[17, 10] = w439
    C_q[17, 11] = w437
    C_q[17, 12] = w434
    C_q[17, 13] = w432
    C_q[17, 20] = 1.0
    C_q[17, 37] = bar2_e3 * w513 - bar2_e0 * w517 - (bar2_e1 * w516 - bar2_e2 * w515)
    # hinge2.x
    C_q[18, 7] = -1.0
    C_q[18, 10] = w442 - w49 * w440
    C_q[18, 11] = w49 * w441 - w58 * w440
    C_q[18, 12] = w52 * w441 - w446
    C_q[18, 13] = w447 - w444
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = w444 - w56 * w443
    C_q[19, 11] = w446 - w445
    C_q[19, 12] = w56 * w440 - w52 * w443
    C_q[19, 13] = w50 * w440 - w448
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = w445 - w68 * w441
    C_q[20, 11] = w58 * w443 - w447
    C_q[20, 12] = w448 - w442
    C_q[20, 13] = w68 * w443 - w50 * w441
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = w451 - w98 * w449
    C_q[21, 18] = w98 * w450 - w112 * w449
    C_q[21, 19] = w99 * w450 - w473
    C_q[21, 20] = w474 - w453
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = w453 - w105 * w452
    C_q[22, 18] = w473 - w454
    C_q[22, 19] = w105 * w449 - w99 * w452
    C_q[22, 20] = w101 * w449 - w475
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = w454 - w117 * w450
    C_q[23, 18] = w112 * w452 - w474
    C_q[23, 19] = w475 - w451
    C_q[23, 20] = w117 * w452 - w101 * w450
    C_q[23, 23] = 1.0
    # hinge3.parallel_x
    C_q[24, 17] = w117 * w457 + w98 * w460 + w105 * w463
    C_q[24, 18] = w114 * w457 + w112 * w460 + w98 * w463
    C_q[24, 19] = w105 * w457 + w114 * w460 + w99 * w463
    C_q[24, 20] = w101 * w457 + w117 * w460 + w114 * w463
    C_q[24, 24] = w166 * w476 + w147 * w477 + w154 * w478
    C_q[24, 25] = w163 * w476 + w156 * w477 + w147 * w478
    C_q[24, 26] = w154 * w476 + w163 * w477 + w148 * w478
    C_q[24, 27] = w150 * w476 + w166 * w477 + w163 * w478
    # hinge3.parallel_y
    C_q[25, 17] = w117 * w466 + w98 * w469 + w105 * w472
    C_q[25, 18] = w114 * w466 + w112 * w469 + w98 * w472
    C_q[25, 19] = w105 * w466 + w114 * w469 + w99 * w472
    C_q[25, 20] = w101 * w466 + w117 * w469 + w114 * w472
    C_q[25, 24] = w166 * w479 + w147 * w480 + w154 * w481
    C_q[25, 25] = w163 * w479 + w156 * w480 + w147 * w481
    C_q[25, 26] = w154 * w479 + w163 * w480 + w148 * w481
    C_q[25, 27] = w150 * w479 + w166 * w480 + w163 * w481
    # hinge4.e0
    C_q[26, 24] = 1.0
    C_q[26, 31] = w493
    C_q[26, 34] = w501
    C_q[26, 38] = bar5_e0 * w519 - bar5_e3 * w518
    # hinge4.e1
    C_q[27, 25] = 1.0
    C_q[27, 32] = w493
    C_q[27, 33] = w494
    C_q[27, 38] = bar5_e1 * w519 + bar5_e2 * w518
    # hinge4.e2
    C_q[28, 26] = 1.0
    C_q[28, 32] = w501
    C_q[28, 33] = w493
    C_q[28, 38] = bar5_e2 * w519 - bar5_e1 * w518
    # hinge4.e3
    C_q[29, 27] = 1.0
    C_q[29, 31] = w494
    C_q[29, 34] = w493
    C_q[29, 38] = bar5_e0 * w518 + bar5_e3 * w519
    # hinge4.x
    C_q[30, 21] = -1.0
    C_q[30, 24] = w484 - w147 * w482
    C_q[30, 25] = w147 * w483 - w156 * w482
    C_q[30, 26] = w148 * w483 - w488
    C_q[30, 27] = w489 - w486
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = w486 - w154 * w485
    C_q[31, 25] = w488 - w487
    C_q[31, 26] = w154 * w482 - w148 * w485
    C_q[31, 27] = w150 * w482 - w490
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = w487 - w166 * w483
    C_q[32, 25] = w156 * w485 - w489
    C_q[32, 26] = w490 - w484
    C_q[32, 27] = w166 * w485 - w150 * w483
    C_q[32, 30] = 1.0
    # hinge5.e0
    C_q[33, 31] = 1.0
    C_q[33, 39] = w522 * c44
    # hinge5.e1
    C_q[34, 32] = 1.0
    C_q[34, 39] = w524 * c43
    # hinge5.e2
    C_q[35, 33] = 1.0
    C_q[35, 39] = w617
    # hinge5.e3
    C_q[36, 34] = 1.0
    C_q[36, 39] = w618
    # hinge5.x
    C_q[37, 28] = -1.0
    C_q[37, 31] = w497 - w196 * w495
    C_q[37, 32] = w196 * w496 - w205 * w495
    C_q[37, 33] = w199 * w496 - w502
    C_q[37, 34] = w503 - w499
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = w499 - w203 * w498
    C_q[38, 32] = w502 - w500
    C_q[38, 33] = w203 * w495 - w199 * w498
    C_q[38, 34] = w197 * w495 - w504
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = w500 - w215 * w496
    C_q[39, 32] = w205 * w498 - w503
    C_q[39, 33] = w504 - w497
    C_q[39, 34] = w215 * w498 - w197 * w496
    gamma = ca.vertcat(
        w525 * (w508 * w525) * c46,  # hinge0.e0
        w528,  # hinge0.e1
        w525 * (w506 * w525) * c31,  # hinge0.e2
        w530,  # hinge0.e3
        0.0,  # hinge0.x
        0.0,  # hinge0.y
        0.0,  # hinge0.z
        bar1_e3 * w532 - bar1_e0 * w533 - w536 - w536,  # hinge1.e0
        w537 + (w537 - (bar1_e1 * w533 + bar1_e2 * w532)),  # hinge1.e1
        bar1_e1 * w532 - bar1_e2 * w533 - w538 - w538,  # hinge1.e2
        w539 + (w539 - (bar1_e0 * w532 + bar1_e3 * w533)),  # hinge1.e3
        w540 * w542 - w543 * w544,  # hinge1.x
        w543 * w545 - w541 * w542,  # hinge1.y
        w541 * w544 - w540 * w545,  # hinge1.z
        bar2_e1 * w552 - bar2_e2 * w550 - bar2_e3 * w553 - bar2_e0 * w549 - w560 - w560,  # hinge2.e0
        w561 + (bar2_e2 * w553 - bar2_e3 * w550 - (bar2_e0 * w552 + bar2_e1 * w549) + w561),  # hinge2.e1
        w562 + (bar2_e0 * w550 - bar2_e2 * w549 - (bar2_e3 * w552 + bar2_e1 * w553) + w562),  # hinge2.e2
        w563 + (bar2_e0 * w553 - bar2_e3 * w549 + (bar2_e1 * w550 + bar2_e2 * w552) + w563),  # hinge2.e3
        w564 * w566 - w567 * w568,  # hinge2.x
        w567 * w569 - w565 * w566,  # hinge2.y
        w565 * w568 - w564 * w569,  # hinge2.z
        w570 * w572 - w573 * w574,  # hinge3.x
        w573 * w575 - w571 * w572,  # hinge3.y
        w571 * w574 - w570 * w575,  # hinge3.z
        w620,  # hinge3.parallel_x
        w622,  # hinge3.parallel_y
        w593 + (w593 - (bar5_e0 * w595 + bar5_e3 * w596)),  # hinge4.e0
        bar5_e2 * w596 - bar5_e1 * w595 - w597 - w597,  # hinge4.e1
        w598 + (w598 - (bar5_e2 * w595 + bar5_e1 * w596)),  # hinge4.e2
        bar5_e0 * w596 - bar5_e3 * w595 - w599 - w599,  # hinge4.e3
        w576 * w600 - w579 * w601,  # hinge4.x
        w579 * w602 - w577 * w600,  # hinge4.y
        w577 * w601 - w576 * w602,  # hinge4.z
        w603 * (w523 * w603) * c47,  # hinge5.e0
        w603 * (w521 * w603) * c43,  # hinge5.e1
        w607,  # hinge5.e2
        w608,  # hinge5.e3
        w609 * w611 - w612 * w613,  # hinge5.x
        w612 * w614 - w610 * w611,  # hinge5.y
        w610 * w613 - w609 * w614,  # hinge5.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b; lam_R: multipliers of the redundant rows, which the others go with (Eq. 37).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes q_ddot (n = 40) [mixed]: accelerations of all coordinates
    takes lam_R (n_R = 1) [N, N m]: multipliers of the redundant rows, which no equation determines
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 40) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 6) [N, N m]: world force and moment of a joint on its body b, at b
    2757 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    q_ddot = ca.SX.sym("q_ddot", 40)
    lam_R = ca.SX.sym("lam_R", 1)
    c = ca.SX.sym("c", 109)
    bar1_e0 = q[3]
    bar1_e1 = q[4]
    bar1_e2 = q[5]
    bar1_e3 = q[6]
    bar2_e0 = q[10]
    bar2_e1 = q[11]
    bar2_e2 = q[12]
    bar2_e3 = q[13]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar4_e0 = q[24]
    bar4_e1 = q[25]
    bar4_e2 = q[26]
    bar4_e3 = q[27]
    bar5_e0 = q[31]
    bar5_e1 = q[32]
    bar5_e2 = q[33]
    bar5_e3 = q[34]
    hinge0_angle = q[35]
    hinge1_angle = q[36]
    hinge2_angle = q[37]
    hinge4_angle = q[38]
    hinge5_angle = q[39]
    bar1_e0_dot = q_dot[3]
    bar1_e1_dot = q_dot[4]
    bar1_e2_dot = q_dot[5]
    bar1_e3_dot = q_dot[6]
    bar2_e0_dot = q_dot[10]
    bar2_e1_dot = q_dot[11]
    bar2_e2_dot = q_dot[12]
    bar2_e3_dot = q_dot[13]
    bar3_e0_dot = q_dot[17]
    bar3_e1_dot = q_dot[18]
    bar3_e2_dot = q_dot[19]
    bar3_e3_dot = q_dot[20]
    bar4_e0_dot = q_dot[24]
    bar4_e1_dot = q_dot[25]
    bar4_e2_dot = q_dot[26]
    bar4_e3_dot = q_dot[27]
    bar5_e0_dot = q_dot[31]
    bar5_e1_dot = q_dot[32]
    bar5_e2_dot = q_dot[33]
    bar5_e3_dot = q_dot[34]
    bar1_x_ddot = q_ddot[0]
    bar1_y_ddot = q_ddot[1]
    bar1_z_ddot = q_ddot[2]
    bar1_e0_ddot = q_ddot[3]
    bar1_e1_ddot = q_ddot[4]
    bar1_e2_ddot = q_ddot[5]
    bar1_e3_ddot = q_ddot[6]
    bar2_x_ddot = q_ddot[7]
    bar2_y_ddot = q_ddot[8]
    bar2_z_ddot = q_ddot[9]
    bar2_e0_ddot = q_ddot[10]
    bar2_e1_ddot = q_ddot[11]
    bar2_e2_ddot = q_ddot[12]
    bar2_e3_ddot = q_ddot[13]
    bar3_x_ddot = q_ddot[14]
    bar3_y_ddot = q_ddot[15]
    bar3_z_ddot = q_ddot[16]
    bar3_e0_ddot = q_ddot[17]
    bar3_e1_ddot = q_ddot[18]
    bar3_e2_ddot = q_ddot[19]
    bar3_e3_ddot = q_ddot[20]
    bar4_x_ddot = q_ddot[21]
    bar4_y_ddot = q_ddot[22]
    bar4_z_ddot = q_ddot[23]
    bar4_e0_ddot = q_ddot[24]
    bar4_e1_ddot = q_ddot[25]
    bar4_e2_ddot = q_ddot[26]
    bar4_e3_ddot = q_ddot[27]
    bar5_x_ddot = q_ddot[28]
    bar5_y_ddot = q_ddot[29]
    bar5_z_ddot = q_ddot[30]
    bar5_e0_ddot = q_ddot[31]
    bar5_e1_ddot = q_ddot[32]
    bar5_e2_ddot = q_ddot[33]
    bar5_e3_ddot = q_ddot[34]
    lam_R0 = lam_R[0]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    bar1_end_x = c[7]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c16 = c[16]
    c22 = c[22]
    gravity_y = c[24]
    bar2_end_quaternion_1_0_0 = c[33]
    bar3_start_quaternion_1_0_0 = c[34]
    bar2_end_quaternion_3_0_0 = c[35]
    bar3_start_quaternion_3_0_0 = c[36]
    c37 = c[37]
    c38 = c[38]
    ground_P5_quaternion_3_0_0 = c[39]
    bar5_end_quaternion_1_0_0 = c[40]
    ground_P5_quaternion_1_0_0 = c[41]
    bar5_end_quaternion_3_0_0 = c[42]
    c43 = c[43]
    c44 = c[44]
    bar3_mass = c[48]
    bar2_mass = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    bar1_mass = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    bar4_mass = c[58]
    c59 = c[59]
    c60 = c[60]
    bar5_mass = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    c89 = c[89]
    c90 = c[90]
    c91 = c[91]
    c92 = c[92]
    c93 = c[93]
    c94 = c[94]
    c95 = c[95]
    c96 = c[96]
    c97 = c[97]
    c98 = c[98]
    c99 = c[99]
    c100 = c[100]
    c101 = c[101]
    c102 = c[102]
    # intermediate terms (728)
    w0 = 2 * -bar1_e1
    w1 = 2 * -bar1_e2
    w2 = 2 * -bar1_e3
    w3 = 2 * bar1_e0
    w4 = 2 * bar1_e1
    w5 = bar1_e0_dot * w1 + bar1_e1_dot * w2 + bar1_e2_dot * w3 + bar1_e3_dot * w4
    w6 = 2 * bar1_e2
    w7 = bar1_e0_dot * w2 + bar1_e1_dot * w6 + w0 * bar1_e2_dot + w3 * bar1_e3_dot
    w8 = w7 * c56
    w9 = w5 * c67
    w10 = w5 * w8 - w7 * w9
    w11 = 2 * bar1_e3
    w12 = w0 * bar1_e0_dot + bar1_e1_dot * w3 + bar1_e2_dot * w11 + w1 * bar1_e3_dot
    w13 = w12 * c55
    w14 = w7 * w13 - w8 * w12
    w15 = w9 * w12 - w5 * w13
    w16 = bar1_e2 * w6
    w17 = bar1_e3 * w11
    w18 = 1.0 - (w16 + w17)
    w19 = w18 * c66
    w20 = bar1_e3 * w4
    w21 = bar1_e0 * w6
    w22 = w20 - w21
    w23 = w22 * c66
    w24 = w0 * w23
    w25 = w2 * w19 - w24
    w26 = bar1_e2 * w4
    w27 = bar1_e0 * w11
    w28 = w26 + w27
    w29 = w28 * c66
    w30 = w2 * w29
    w31 = w1 * w23 - w30
    w32 = w1 * w19
    w33 = w0 * w29 - w32
    w34 = w31 * bar1_x_ddot + w25 * bar1_y_ddot + w33 * bar1_z_ddot + (w0 * (w0 * c68) + w1 * (w1 * c69) + w2 * (w2 * c70)) * bar1_e0_ddot
    w35 = w3 * c68
    w36 = w0 * w35 + bar1_e2 * bar1_e3 * c71
    w37 = w3 * c69
    w38 = w0 * c70
    w39 = w1 * w37 + bar1_e1 * bar1_e3 * c72
    w40 = w1 * c68
    w41 = w4 * c69
    w42 = w3 * c70
    w43 = bar1_e1 * bar1_e2 * c73 + w2 * w42
    w44 = w0 * w10 + w1 * w14 + w2 * w15 + w25 * gravity_y - (w34 + w36 * bar1_e1_ddot + w39 * bar1_e2_ddot + w43 * bar1_e3_ddot)
    w45 = w28 * bar1_end_x
    w46 = w18 * bar1_end_x
    w47 = w1 * w46
    w48 = 2 * bar2_e2
    w49 = w48 * bar2_e3
    w50 = 2 * bar2_e1
    w51 = w50 * bar2_e0
    w52 = w49 + w51
    w53 = 2 * -bar2_e1
    w54 = 2 * bar2_e0
    w55 = 2 * bar2_e3
    w56 = 2 * -bar2_e2
    w57 = bar2_e0_dot * w53 + bar2_e1_dot * w54 + bar2_e2_dot * w55 + bar2_e3_dot * w56
    w58 = w57 * c53
    w59 = 2 * -bar2_e3
    w60 = bar2_e0_dot * w59 + w48 * bar2_e1_dot + w53 * bar2_e2_dot + w54 * bar2_e3_dot
    w61 = w60 * c53
    w62 = w57 * w58 + w60 * w61
    w63 = bar2_e3 * w50
    w64 = w48 * bar2_e0
    w65 = w63 - w64
    w66 = bar2_e0_dot * w56 + bar2_e1_dot * w59 + w54 * bar2_e2_dot + w50 * bar2_e3_dot
    w67 = w58 * w66
    w68 = bar2_e1 * w50
    w69 = bar2_e2 * w48
    w70 = w61 * w66
    w71 = bar2_e3 * w55
    w72 = 1.0 - (w68 + w71)
    w73 = w72 * c53
    w74 = bar2_e2 * w50
    w75 = bar2_e0 * w55
    w76 = w74 - w75
    w77 = w76 * c53
    w78 = w56 * w77
    w79 = w53 * w73 - w78
    w80 = w54 * w73
    w81 = w80 - w55 * w77
    w82 = w59 * w73
    w83 = w54 * w77
    w84 = w82 - w83
    w85 = w48 * w73 - w53 * w77
    w86 = bar2_z_ddot * bar2_mass + w79 * bar2_e0_ddot + w81 * bar2_e1_ddot + w84 * bar2_e2_ddot + w85 * bar2_e3_ddot
    w87 = 2 * bar3_e1
    w88 = bar3_e1 * w87
    w89 = 2 * bar3_e2
    w90 = bar3_e2 * w89
    w91 = 1.0 - (w88 + w90)
    w92 = 2 * -bar3_e2
    w93 = 2 * -bar3_e3
    w94 = 2 * bar3_e0
    w95 = bar3_e0_dot * w92 + bar3_e1_dot * w93 + bar3_e2_dot * w94 + w87 * bar3_e3_dot
    w96 = w95 * c4
    w97 = 2 * -bar3_e1
    w98 = 2 * bar3_e3
    w99 = bar3_e0_dot * w97 + bar3_e1_dot * w94 + bar3_e2_dot * w98 + w92 * bar3_e3_dot
    w100 = w99 * c4
    w101 = w95 * w96 + w99 * w100
    w102 = w87 * bar3_e3
    w103 = w89 * bar3_e0
    w104 = w102 - w103
    w105 = bar3_e0_dot * w93 + w89 * bar3_e1_dot + bar3_e2_dot * w97 + w94 * bar3_e3_dot
    w106 = w100 * w105
    w107 = w89 * bar3_e3
    w108 = w87 * bar3_e0
    w109 = w96 * w105
    w110 = w107 - w108
    w111 = w110 * c4
    w112 = w102 + w103
    w113 = w112 * c4
    w114 = w92 * w113
    w115 = w97 * w111 - w114
    w116 = w94 * w111
    w117 = w116 - w98 * w113
    w118 = w93 * w111
    w119 = w94 * w113
    w120 = w118 - w119
    w121 = w89 * w111 - w97 * w113
    w122 = bar3_z_ddot * bar3_mass + w115 * bar3_e0_ddot + w117 * bar3_e1_ddot + w120 * bar3_e2_ddot + w121 * bar3_e3_ddot
    w123 = w91 * w101 - (w104 * w106 + (w107 + w108) * w109) - w122
    w124 = ca.cos(hinge1_angle)
    w125 = ca.sin(hinge0_angle)
    w126 = w124 * w125
    w127 = ca.sin(hinge2_angle)
    w128 = ca.sin(hinge1_angle)
    w129 = ca.cos(hinge0_angle)
    w130 = w128 * w129
    w131 = ca.cos(hinge2_angle)
    w132 = (w127 * w130 + w125 * w131) * bar3_end_z
    w133 = w124 * w129
    w134 = w125 * w128
    w135 = (w129 * w131 - w127 * w134) * bar3_end_z
    w136 = w126 * w132 + w133 * w135
    w137 = ca.sin(hinge5_angle)
    w138 = ca.sin(hinge4_angle)
    w139 = ca.cos(hinge5_angle)
    w140 = w138 * bar4_end_x
    w141 = ca.cos(hinge4_angle)
    w142 = w137 * w141
    w143 = w128 * w142
    w144 = w139 * w141
    w145 = w126 * w144
    w146 = w143 - w145
    w147 = w140 * w146
    w148 = w124 * w127 * bar3_end_z
    w149 = w128 * w135 - w126 * w148
    w150 = w126 * w138
    w151 = w133 * w142
    w152 = w128 * w138
    w153 = w133 * w144
    w154 = w137 * (w150 - w151) + w139 * (w152 - w153)
    w155 = w137 * bar5_end_y - w137 * w138 * bar4_end_x
    w156 = w141 * bar4_end_x
    w157 = w139 * w156
    w158 = w154 * w155 - w146 * w157
    w159 = w145 - w143
    w160 = w153 - w152
    w161 = w133 * w159 + w128 * (w151 - w150) - w126 * w160
    w162 = w140 * w155
    w163 = w136 * w147 - w149 * w158 + w161 * w162
    w164 = hinge1_angle / 2.0
    w165 = ca.cos(w164)
    w166 = w165 / 2.0
    w167 = ca.sin(w164)
    w168 = w167 / 2.0
    w169 = w60 * c57
    w170 = w66 * c50
    w171 = w66 * w169 - w60 * w170
    w172 = w57 * c51
    w173 = w60 * w172 - w57 * w169
    w174 = w57 * w170 - w66 * w172
    w175 = w52 * c53
    w176 = w83 - w48 * w175
    w177 = w53 * w175
    w178 = w177 - w80
    w179 = w56 * c74
    w180 = w50 * c75
    w181 = w54 * c76
    w182 = bar2_e2 * bar2_e1 * c79 + w59 * w181
    w183 = w59 * w180 + bar2_e2 * bar2_e0 * c78
    w184 = w178 * bar2_x_ddot + w176 * bar2_y_ddot + bar2_z_ddot * w85 + bar2_e0_ddot * w182 + bar2_e1_ddot * w183
    w185 = w55 * w179 + bar2_e1 * bar2_e0 * c77
    w186 = w56 * w171 + w50 * w173 + w54 * w174 + w176 * gravity_y - (w184 + bar2_e2_ddot * w185 + bar2_e3_ddot * (w56 * w179 + w50 * w180 + w54 * w181))
    w187 = w72 * bar2_end_y
    w188 = w76 * bar2_end_y
    w189 = w48 * w187 - w53 * w188
    w190 = w54 * w188
    w191 = w52 * bar2_end_y
    w192 = w190 - w48 * w191
    w193 = w87 * bar3_e2
    w194 = bar3_e0 * w98
    w195 = w193 + w194
    w196 = bar3_e3 * w98
    w197 = w91 * c4
    w198 = w97 * w197
    w199 = w93 * w113 - w198
    w200 = w94 * w197
    w201 = w114 - w200
    w202 = w87 * w113 - w93 * w197
    w203 = w119 - w89 * w197
    w204 = bar3_y_ddot * bar3_mass + bar3_e0_ddot * w199 + bar3_e1_ddot * w201 + bar3_e2_ddot * w202 + bar3_e3_ddot * w203
    w205 = c100 + (w101 * w110 - (w106 * w195 + w109 * (1.0 - (w88 + w196)))) - w204
    w206 = w53 * w191
    w207 = w54 * w187
    w208 = w206 - w207
    w209 = 1.0 - (w90 + w196)
    w210 = w92 * w197 - w118
    w211 = w98 * w197 - w92 * w111
    w212 = w200 - w87 * w111
    w213 = w198 - w116
    w214 = bar3_x_ddot * bar3_mass + bar3_e0_ddot * w210 + bar3_e1_ddot * w211 + bar3_e2_ddot * w212 + bar3_e3_ddot * w213
    w215 = w101 * w112 - (w106 * w209 + w109 * (w193 - w194)) - w214
    w216 = hinge2_angle / 2.0
    w217 = ca.cos(w216)
    w218 = w217 * c37
    w219 = w105 * c0
    w220 = w95 * c1
    w221 = w95 * w219 - w105 * w220
    w222 = w99 * c52
    w223 = w105 * w222 - w99 * w219
    w224 = w99 * w220 - w95 * w222
    w225 = w92 * c22
    w226 = w87 * c80
    w227 = w94 * c81
    w228 = bar3_e1 * bar3_e2 * c84 + w93 * w227
    w229 = w93 * w226 + bar3_e2 * bar3_e0 * c83
    w230 = bar3_x_ddot * w213 + bar3_y_ddot * w203 + bar3_z_ddot * w121 + bar3_e0_ddot * w228 + bar3_e1_ddot * w229
    w231 = w98 * w225 + bar3_e1 * bar3_e0 * c82
    w232 = w92 * w221 + w87 * w223 + w94 * w224 + w203 * gravity_y - (w230 + bar3_e2_ddot * w231 + bar3_e3_ddot * (w92 * w225 + w87 * w226 + w94 * w227))
    w233 = 2 * bar4_e1
    w234 = bar4_e1 * w233
    w235 = 2 * bar4_e3
    w236 = bar4_e3 * w235
    w237 = 1.0 - (w234 + w236)
    w238 = w91 * w237
    w239 = 2 * bar4_e2
    w240 = bar4_e3 * w239
    w241 = w233 * bar4_e0
    w242 = w240 + w241
    w243 = w110 * w242
    w244 = w238 - w243
    w245 = w112 * w242
    w246 = w233 * bar4_e2
    w247 = w235 * bar4_e0
    w248 = w246 - w247
    w249 = w91 * w248
    w250 = w245 - w249
    w251 = w110 * w248
    w252 = w112 * w237
    w253 = w251 - w252
    w254 = w232 - (w89 * w244 + w97 * w250 + w94 * w253) * lam_R0
    w255 = ca.sin(w216)
    w256 = w255 * c38
    w257 = w94 * c80
    w258 = w97 * c81
    w259 = w92 * w257 + bar3_e1 * bar3_e3 * c83
    w260 = bar3_e3 * bar3_e0 * c84 + w89 * w258
    w261 = bar3_x_ddot * w212 + bar3_y_ddot * w202 + bar3_z_ddot * w120 + bar3_e0_ddot * w259 + bar3_e1_ddot * w260
    w262 = w98 * w221 + w94 * w223 + w97 * w224 + w202 * gravity_y - (w261 + bar3_e2_ddot * (w98 * (w98 * c22) + w94 * w257 + w97 * w258) + bar3_e3_ddot * w231)
    w263 = w262 - lam_R0 * (w93 * w244 + w94 * w250 + w87 * w253)
    w264 = w217 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w217 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w265 = w94 * c22
    w266 = w97 * w265 + bar3_e2 * bar3_e3 * c82
    w267 = bar3_x_ddot * w211 + bar3_y_ddot * w201 + bar3_z_ddot * w117 + bar3_e0_ddot * w266 + bar3_e1_ddot * (w94 * w265 + w93 * (w93 * c80) + w89 * (w89 * c81))
    w268 = w94 * w221 + w93 * w223 + w89 * w224 + w201 * gravity_y - (w267 + bar3_e2_ddot * w260 + bar3_e3_ddot * w229)
    w269 = w268 - lam_R0 * (w94 * w244 + w98 * w250 + w92 * w253)
    w270 = w255 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w255 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w271 = bar3_x_ddot * w210 + bar3_y_ddot * w199 + bar3_z_ddot * w115 + bar3_e0_ddot * (w97 * (w97 * c22) + w92 * (w92 * c80) + w93 * (w93 * c81))
    w272 = w97 * w221 + w92 * w223 + w93 * w224 + w199 * gravity_y - (w271 + bar3_e1_ddot * w266 + bar3_e2_ddot * w259 + bar3_e3_ddot * w228)
    w273 = w272 - lam_R0 * (w97 * w244 + w92 * w250 + w93 * w253)
    w274 = w186 + w123 * w189 + w192 * w205 + w208 * w215 + w218 * w254 + w256 * w263 - w264 * w269 - w270 * w273
    w275 = w50 * w77 - w59 * w175
    w276 = w54 * w175
    w277 = w276 - w50 * w73
    w278 = w54 * c75
    w279 = w53 * c76
    w280 = w56 * w278 + bar2_e3 * bar2_e1 * c78
    w281 = bar2_e3 * bar2_e0 * c79 + w48 * w279
    w282 = bar2_x_ddot * w277 + bar2_y_ddot * w275 + bar2_z_ddot * w84 + bar2_e0_ddot * w280 + bar2_e1_ddot * w281
    w283 = w55 * w171 + w54 * w173 + w53 * w174 + w275 * gravity_y - (w282 + bar2_e2_ddot * (w55 * (w55 * c74) + w54 * w278 + w53 * w279) + bar2_e3_ddot * w185)
    w284 = w59 * w187
    w285 = w284 - w190
    w286 = w50 * w188 - w59 * w191
    w287 = w54 * w191
    w288 = w287 - w50 * w187
    w289 = w283 + w123 * w285 + w205 * w286 + w215 * w288 - w254 * w256 + w218 * w263 + w269 * w270 - w264 * w273
    w290 = w78 - w276
    w291 = w55 * w175 - w56 * w73
    w292 = w54 * c74
    w293 = w53 * w292 + bar2_e2 * bar2_e3 * c77
    w294 = bar2_x_ddot * w291 + bar2_y_ddot * w290 + bar2_z_ddot * w81 + bar2_e0_ddot * w293 + bar2_e1_ddot * (w54 * w292 + w59 * (w59 * c75) + w48 * (w48 * c76))
    w295 = w54 * w171 + w59 * w173 + w48 * w174 + w290 * gravity_y - (w294 + bar2_e2_ddot * w281 + bar2_e3_ddot * w183)
    w296 = w207 - w55 * w188
    w297 = w56 * w188
    w298 = w297 - w287
    w299 = w55 * w191 - w56 * w187
    w300 = w295 + w123 * w296 + w205 * w298 + w215 * w299 + w254 * w264 - w263 * w270 + w218 * w269 - w256 * w273
    w301 = (bar1_e0 * w166 - bar1_e3 * w168) * w274 - (bar1_e2 * w168 + bar1_e1 * w166) * w289 + (bar1_e2 * w166 - bar1_e1 * w168) * w300
    w302 = w59 * w77 - w177
    w303 = w56 * w175 - w82
    w304 = bar2_x_ddot * w303 + bar2_y_ddot * w302 + bar2_z_ddot * w79 + bar2_e0_ddot * (w53 * (w53 * c74) + w56 * (w56 * c75) + w59 * (w59 * c76))
    w305 = w53 * w171 + w56 * w173 + w59 * w174 + w302 * gravity_y - (w304 + bar2_e1_ddot * w293 + bar2_e2_ddot * w280 + bar2_e3_ddot * w182)
    w306 = w53 * w187 - w297
    w307 = w59 * w188 - w206
    w308 = w56 * w191 - w284
    w309 = w305 + w123 * w306 + w205 * w307 + w215 * w308 + w254 * w270 + w263 * w264 + w256 * w269 + w218 * w273
    w310 = w301 - (bar1_e0 * w168 + bar1_e3 * w166) * w309
    w311 = w124 * bar2_end_y - w148
    w312 = w129 * w311
    w313 = w129 * (w132 - w130 * bar2_end_y) - w125 * (w135 + w134 * bar2_end_y)
    w314 = w125 * w159 + w129 * w160
    w315 = w217 / 2.0
    w316 = w315 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w315 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w317 = w255 / 2.0
    w318 = w317 * c37
    w319 = w317 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w317 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w320 = w315 * c38
    w321 = w254 * (bar2_e0 * w316 - bar2_e3 * w318 + (bar2_e1 * w319 - bar2_e2 * w320)) + w263 * (bar2_e0 * w319 - bar2_e2 * w318 + (bar2_e3 * w320 - bar2_e1 * w316))
    w322 = w321 + w269 * (bar2_e0 * w320 - bar2_e1 * w318 + (bar2_e2 * w316 - bar2_e3 * w319)) - w273 * (bar2_e0 * w318 + (bar2_e1 * w320 + bar2_e2 * w319 + bar2_e3 * w316))
    w323 = w161 * w312 + w149 * w314
    w324 = w136 * w312 - w149 * w313
    w325 = hinge4_angle / 2.0
    w326 = ca.cos(w325)
    w327 = w326 / 2.0
    w328 = ca.sin(w325)
    w329 = w328 / 2.0
    w330 = 2 * -bar4_e2
    w331 = 2 * -bar4_e3
    w332 = 2 * bar4_e0
    w333 = bar4_e0_dot * w330 + bar4_e1_dot * w331 + bar4_e2_dot * w332 + w233 * bar4_e3_dot
    w334 = 2 * -bar4_e1
    w335 = bar4_e0_dot * w331 + w239 * bar4_e1_dot + bar4_e2_dot * w334 + w332 * bar4_e3_dot
    w336 = w335 * c65
    w337 = w333 * c16
    w338 = w333 * w336 - w335 * w337
    w339 = bar4_e0_dot * w334 + bar4_e1_dot * w332 + w235 * bar4_e2_dot + w330 * bar4_e3_dot
    w340 = w339 * c59
    w341 = w335 * w340 - w336 * w339
    w342 = w337 * w339 - w333 * w340
    w343 = bar4_e2 * w239
    w344 = 1.0 - (w236 + w343)
    w345 = w344 * c60
    w346 = w233 * bar4_e3
    w347 = w239 * bar4_e0
    w348 = w346 - w347
    w349 = w348 * c60
    w350 = w233 * w345 - w331 * w349
    w351 = w332 * w349
    w352 = w246 + w247
    w353 = w352 * c60
    w354 = w351 - w233 * w353
    w355 = w331 * w353
    w356 = w332 * w345
    w357 = w355 - w356
    w358 = w332 * c86
    w359 = w334 * c87
    w360 = w330 * w358 + bar4_e1 * bar4_e3 * c89
    w361 = bar4_e3 * bar4_e0 * c90 + w239 * w359
    w362 = w354 * bar4_x_ddot + w350 * bar4_y_ddot + w357 * bar4_z_ddot + w360 * bar4_e0_ddot + w361 * bar4_e1_ddot
    w363 = w330 * c85
    w364 = w233 * c86
    w365 = w332 * c87
    w366 = w235 * w363 + bar4_e1 * bar4_e0 * c88
    w367 = w235 * w338 + w332 * w341 + w334 * w342 + w350 * gravity_y - (w362 + (w235 * (w235 * c85) + w332 * w358 + w334 * w359) * bar4_e2_ddot + w366 * bar4_e3_ddot)
    w368 = w243 - w238
    w369 = w249 - w245
    w370 = w252 - w251
    w371 = w367 - lam_R0 * (w331 * w368 + w332 * w369 + w233 * w370)
    w372 = w352 * bar4_end_x
    w373 = w331 * w372
    w374 = w344 * bar4_end_x
    w375 = w332 * w374
    w376 = w373 - w375
    w377 = w335 * c60
    w378 = w333 * c60
    w379 = w335 * w377 + w333 * w378
    w380 = w339 * w378
    w381 = 1.0 - (w234 + w343)
    w382 = w339 * w377
    w383 = w330 * w345
    w384 = w334 * w353 - w383
    w385 = w332 * w353
    w386 = w385 - w235 * w345
    w387 = w239 * w353 - w334 * w345
    w388 = bar4_z_ddot * bar4_mass + bar4_e0_ddot * w384 + bar4_e1_ddot * w386 + w357 * bar4_e2_ddot + bar4_e3_ddot * w387
    w389 = w348 * w379 - w242 * w380 - w381 * w382 - w388
    w390 = w348 * bar4_end_x
    w391 = w233 * w374 - w331 * w390
    w392 = w240 - w241
    w393 = w334 * w349
    w394 = w331 * w345 - w393
    w395 = w383 - w351
    w396 = w356 - w239 * w349
    w397 = bar4_y_ddot * bar4_mass + bar4_e0_ddot * w394 + bar4_e1_ddot * w395 + w350 * bar4_e2_ddot + bar4_e3_ddot * w396
    w398 = c101 + (w352 * w379 - w237 * w380 - w382 * w392) - w397
    w399 = w332 * w390
    w400 = w399 - w233 * w372
    w401 = w346 + w347
    w402 = w330 * w349 - w355
    w403 = w235 * w349 - w330 * w353
    w404 = w393 - w385
    w405 = bar4_x_ddot * bar4_mass + bar4_e0_ddot * w402 + bar4_e1_ddot * w403 + w354 * bar4_e2_ddot + bar4_e3_ddot * w404
    w406 = w344 * w379 - w248 * w380 - w382 * w401 - w405
    w407 = w371 - w376 * w389 - w391 * w398 - w400 * w406
    w408 = bar4_e1 * bar4_e2 * c90 + w331 * w365
    w409 = w331 * w364 + bar4_e2 * bar4_e0 * c89
    w410 = bar4_x_ddot * w404 + bar4_y_ddot * w396 + bar4_z_ddot * w387 + bar4_e0_ddot * w408 + bar4_e1_ddot * w409
    w411 = w330 * w338 + w233 * w341 + w332 * w342 + w396 * gravity_y - (w410 + bar4_e2_ddot * w366 + bar4_e3_ddot * (w330 * w363 + w233 * w364 + w332 * w365))
    w412 = w411 - lam_R0 * (w239 * w368 + w334 * w369 + w332 * w370)
    w413 = w239 * w372 - w334 * w374
    w414 = w375 - w239 * w390
    w415 = w334 * w390
    w416 = w332 * w372
    w417 = w415 - w416
    w418 = w412 - w389 * w413 - w398 * w414 - w406 * w417
    w419 = w332 * c85
    w420 = w334 * w419 + bar4_e3 * bar4_e2 * c88
    w421 = bar4_x_ddot * w403 + bar4_y_ddot * w395 + bar4_z_ddot * w386 + bar4_e0_ddot * w420 + bar4_e1_ddot * (w332 * w419 + w331 * (w331 * c86) + w239 * (w239 * c87))
    w422 = w332 * w338 + w331 * w341 + w239 * w342 + w395 * gravity_y - (w421 + w361 * bar4_e2_ddot + bar4_e3_ddot * w409)
    w423 = w422 - lam_R0 * (w332 * w368 + w235 * w369 + w330 * w370)
    w424 = w416 - w235 * w374
    w425 = w330 * w374
    w426 = w425 - w399
    w427 = w235 * w390 - w330 * w372
    w428 = w423 - w389 * w424 - w398 * w426 - w406 * w427
    w429 = (bar5_e1 * w327 - w329 * bar5_e2) * w407 - (w327 * bar5_e0 + w329 * bar5_e3) * w418 - (bar5_e1 * w329 + w327 * bar5_e2) * w428
    w430 = bar4_x_ddot * w402 + bar4_y_ddot * w394 + bar4_z_ddot * w384 + bar4_e0_ddot * (w334 * (w334 * c85) + w330 * (w330 * c86) + w331 * (w331 * c87))
    w431 = w334 * w338 + w330 * w341 + w331 * w342 + w394 * gravity_y - (w430 + bar4_e1_ddot * w420 + w360 * bar4_e2_ddot + bar4_e3_ddot * w408)
    w432 = w431 - lam_R0 * (w334 * w368 + w330 * w369 + w331 * w370)
    w433 = w334 * w372 - w425
    w434 = w331 * w374 - w415
    w435 = w330 * w390 - w373
    w436 = w432 - w389 * w433 - w398 * w434 - w406 * w435
    w437 = w429 + (w327 * bar5_e3 - w329 * bar5_e0) * w436
    w438 = w163 * w310 - (w158 * w312 - w147 * w313 + w162 * w314) * w322 - (w155 * w323 + w146 * w324) * w437
    w439 = w161 * w313 + w136 * w314
    w440 = hinge5_angle / 2.0
    w441 = ca.cos(w440) / 2.0
    w442 = w441 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w441 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w443 = 2 * -bar5_e2
    w444 = 2 * -bar5_e3
    w445 = 2 * bar5_e0
    w446 = 2 * bar5_e1
    w447 = w443 * bar5_e0_dot + bar5_e1_dot * w444 + bar5_e2_dot * w445 + bar5_e3_dot * w446
    w448 = 2 * bar5_e2
    w449 = 2 * -bar5_e1
    w450 = bar5_e0_dot * w444 + bar5_e1_dot * w448 + bar5_e2_dot * w449 + w445 * bar5_e3_dot
    w451 = w450 * c64
    w452 = w447 * c62
    w453 = w447 * w451 - w450 * w452
    w454 = 2 * bar5_e3
    w455 = bar5_e0_dot * w449 + bar5_e1_dot * w445 + bar5_e2_dot * w454 + w443 * bar5_e3_dot
    w456 = w455 * c92
    w457 = w450 * w456 - w451 * w455
    w458 = w452 * w455 - w447 * w456
    w459 = bar5_e2 * w446
    w460 = bar5_e0 * w454
    w461 = w459 - w460
    w462 = w461 * c63
    w463 = w445 * w462
    w464 = bar5_e3 * w448
    w465 = bar5_e0 * w446
    w466 = w464 + w465
    w467 = w466 * c63
    w468 = w463 - w448 * w467
    w469 = w449 * w467
    w470 = bar5_e1 * w446
    w471 = bar5_e3 * w454
    w472 = 1.0 - (w470 + w471)
    w473 = w472 * c63
    w474 = w445 * w473
    w475 = w469 - w474
    w476 = w448 * w473 - w449 * w462
    w477 = w443 * c91
    w478 = w446 * c93
    w479 = w445 * c94
    w480 = bar5_e1 * bar5_e2 * c97 + w444 * w479
    w481 = w444 * w478 + bar5_e2 * bar5_e0 * c96
    w482 = w475 * bar5_x_ddot + w468 * bar5_y_ddot + w476 * bar5_z_ddot + w480 * bar5_e0_ddot + w481 * bar5_e1_ddot
    w483 = w454 * w477 + bar5_e1 * bar5_e0 * c95
    w484 = w443 * w453 + w446 * w457 + w445 * w458 + w468 * gravity_y - (w482 + w483 * bar5_e2_ddot + (w443 * w477 + w446 * w478 + w445 * w479) * bar5_e3_ddot)
    w485 = w472 * bar5_end_y
    w486 = w461 * bar5_end_y
    w487 = w448 * w485 - w449 * w486
    w488 = w455 * c63
    w489 = w450 * c63
    w490 = w455 * w488 + w450 * w489
    w491 = bar5_e3 * w446
    w492 = bar5_e0 * w448
    w493 = w491 - w492
    w494 = w447 * w488
    w495 = bar5_e2 * w448
    w496 = w447 * w489
    w497 = w443 * w462
    w498 = w449 * w473 - w497
    w499 = w474 - w454 * w462
    w500 = w444 * w473
    w501 = w500 - w463
    w502 = bar5_z_ddot * bar5_mass + bar5_e0_ddot * w498 + bar5_e1_ddot * w499 + bar5_e2_ddot * w501 + w476 * bar5_e3_ddot
    w503 = w466 * w490 - w493 * w494 - (1.0 - (w470 + w495)) * w496 - w502
    w504 = w389 + w503
    w505 = w445 * w486
    w506 = w466 * bar5_end_y
    w507 = w505 - w448 * w506
    w508 = w459 + w460
    w509 = w444 * w462 - w469
    w510 = w445 * w467
    w511 = w497 - w510
    w512 = w446 * w462 - w444 * w467
    w513 = bar5_y_ddot * bar5_mass + bar5_e0_ddot * w509 + bar5_e1_ddot * w511 + bar5_e2_ddot * w512 + w468 * bar5_e3_ddot
    w514 = c102 + (w472 * w490 - w494 * w508 - w496 * (w464 - w465)) - w513
    w515 = w398 + w514
    w516 = w449 * w506
    w517 = w445 * w485
    w518 = w516 - w517
    w519 = 1.0 - (w471 + w495)
    w520 = w443 * w467 - w500
    w521 = w454 * w467 - w443 * w473
    w522 = w510 - w446 * w473
    w523 = bar5_x_ddot * bar5_mass + bar5_e0_ddot * w520 + bar5_e1_ddot * w521 + bar5_e2_ddot * w522 + w475 * bar5_e3_ddot
    w524 = w461 * w490 - w494 * w519 - w496 * (w491 + w492) - w523
    w525 = w406 + w524
    w526 = ca.sin(w440) / 2.0
    w527 = w526 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w526 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w528 = w445 * c93
    w529 = w449 * c94
    w530 = w443 * w528 + bar5_e1 * bar5_e3 * c96
    w531 = bar5_e0 * bar5_e3 * c97 + w448 * w529
    w532 = bar5_x_ddot * w522 + bar5_y_ddot * w512 + bar5_z_ddot * w501 + bar5_e0_ddot * w530 + bar5_e1_ddot * w531
    w533 = w453 * w454 + w445 * w457 + w449 * w458 + w512 * gravity_y - (w532 + bar5_e2_ddot * (w454 * (w454 * c91) + w445 * w528 + w449 * w529) + w483 * bar5_e3_ddot)
    w534 = w444 * w485
    w535 = w534 - w505
    w536 = w446 * w486 - w444 * w506
    w537 = w445 * w506
    w538 = w537 - w446 * w485
    w539 = w442 * (w484 + w326 * w418 + w328 * w436 - w487 * w504 - w507 * w515 - w518 * w525) + w527 * (w533 + w326 * w407 - w328 * w428 - w504 * w535 - w515 * w536 - w525 * w538)
    w540 = w445 * c91
    w541 = w449 * w540 + bar5_e2 * bar5_e3 * c95
    w542 = bar5_x_ddot * w521 + bar5_y_ddot * w511 + bar5_z_ddot * w499 + bar5_e0_ddot * w541 + bar5_e1_ddot * (w445 * w540 + w444 * (w444 * c93) + w448 * (w448 * c94))
    w543 = w445 * w453 + w444 * w457 + w448 * w458 + w511 * gravity_y - (w542 + bar5_e2_ddot * w531 + w481 * bar5_e3_ddot)
    w544 = w517 - w454 * w486
    w545 = w443 * w486
    w546 = w545 - w537
    w547 = w454 * w506 - w443 * w485
    w548 = bar5_x_ddot * w520 + bar5_y_ddot * w509 + bar5_z_ddot * w498 + bar5_e0_ddot * (w449 * (w449 * c91) + w443 * (w443 * c93) + w444 * (w444 * c94))
    w549 = w449 * w453 + w443 * w457 + w444 * w458 + w509 * gravity_y - (w548 + bar5_e1_ddot * w541 + bar5_e2_ddot * w530 + w480 * bar5_e3_ddot)
    w550 = w449 * w485 - w545
    w551 = w444 * w486 - w516
    w552 = w443 * w506 - w534
    w553 = w539 - w441 * c43 * (w543 + w328 * w407 + w326 * w428 - w504 * w544 - w515 * w546 - w525 * w547) - w526 * c44 * (w549 - w328 * w418 + w326 * w436 - w504 * w550 - w515 * w551 - w525 * w552)
    w554 = w137 * w156
    w555 = w138 * w139 * bar4_end_x - w139 * bar5_end_y
    w556 = w146 * w554 - w154 * w555
    w557 = w133 * w148 + w128 * w132
    w558 = w155 * w554 - w157 * w555
    w559 = w136 * w556 - w158 * w557 + w161 * w558
    w560 = w140 * w555
    w561 = w147 * w557 - w149 * w556 - w161 * w560
    w562 = w125 * w311
    w563 = w136 * w560 - w149 * w558 + w162 * w557
    w564 = w312 * w559 + w313 * w561 - w163 * w562 - w314 * w563
    w565 = (w438 + (w140 * w439 + w157 * w323 + w154 * w324) * w553) / w564
    w566 = w123 + w565
    w567 = w52 * w62 - w65 * w67 - (1.0 - (w68 + w69)) * w70 - w86 + w566
    w568 = w22 * bar1_end_x
    w569 = w0 * w568
    w570 = w74 + w75
    w571 = bar2_y_ddot * bar2_mass + bar2_e0_ddot * w302 + bar2_e1_ddot * w290 + bar2_e2_ddot * w275 + bar2_e3_ddot * w176
    w572 = w312 * w557 - w149 * w562
    w573 = w322 * (w312 * w556 - w147 * w562 - w314 * w560) - w310 * w561 - w437 * (w323 * w555 - w146 * w572)
    w574 = w161 * w562 + w314 * w557
    w575 = (w573 + w553 * (w323 * w554 - w140 * w574 - w154 * w572)) / w564
    w576 = w205 + w575
    w577 = c99 + (w62 * w72 - w67 * w570 - w70 * (w49 - w51)) - w571 + w576
    w578 = w2 * w45
    w579 = 1.0 - (w69 + w71)
    w580 = bar2_x_ddot * bar2_mass + bar2_e0_ddot * w303 + bar2_e1_ddot * w291 + bar2_e2_ddot * w277 + bar2_e3_ddot * w178
    w581 = w136 * w562 - w313 * w557
    w582 = w310 * w559 - w322 * (w158 * w562 - w313 * w556 + w314 * w558) - w437 * (w155 * w574 + w439 * w555 + w146 * w581)
    w583 = (w582 + w553 * (w157 * w574 + w439 * w554 + w154 * w581)) / w564
    w584 = w215 + w583
    w585 = w62 * w76 - w67 * w579 - w70 * (w63 + w64) - w580 + w584
    w586 = w91 * bar3_end_z
    w587 = w97 * w586
    w588 = w110 * bar3_end_z
    w589 = w94 * w588
    w590 = w112 * bar3_end_z
    w591 = w94 * w590
    w592 = w195 * w242
    w593 = w104 * w237
    w594 = w592 - w593
    w595 = w104 * w248
    w596 = w209 * w242
    w597 = w595 - w596
    w598 = w209 * w237
    w599 = w195 * w248
    w600 = w598 - w599
    w601 = w322 * (w312 * w558 - w313 * w560 - w162 * w562) - w310 * w563 + w437 * (w155 * w572 + w324 * w555)
    w602 = (w601 + w553 * (w140 * w581 - w157 * w572 - w324 * w554)) / w564
    w603 = w254 + w583 * (w587 - w589) + w575 * (w591 - w89 * w586) + w565 * (w89 * w588 - w97 * w590) - (w89 * w594 + w97 * w597 + w94 * w600) * w602
    w604 = w94 * w586
    w605 = w93 * w588
    w606 = w263 + w583 * (w604 - w87 * w588) + w575 * (w87 * w590 - w93 * w586) + w565 * (w605 - w591) - w602 * (w93 * w594 + w94 * w597 + w87 * w600)
    w607 = w92 * w590
    w608 = w269 + w583 * (w98 * w586 - w92 * w588) + w575 * (w607 - w604) + w565 * (w589 - w98 * w590) - w602 * (w94 * w594 + w98 * w597 + w92 * w600)
    w609 = w273 + w583 * (w92 * w586 - w605) + w575 * (w93 * w590 - w587) + w565 * (w97 * w588 - w607) - w602 * (w97 * w594 + w92 * w597 + w93 * w600)
    w610 = w186 + w189 * w566 + w192 * w576 + w208 * w584 + w218 * w603 + w256 * w606 - w264 * w608 - w270 * w609
    w611 = w44 + (w0 * w45 - w47) * w567 + (w2 * w46 - w569) * w577 + (w1 * w568 - w578) * w585 + w167 * w610
    w612 = w305 + w306 * w566 + w307 * w576 + w308 * w584 + w270 * w603 + w264 * w606 + w256 * w608 + w218 * w609
    w613 = w611 + w165 * w612
    w614 = w3 * w23
    w615 = w32 - w614
    w616 = w11 * w23 - w1 * w29
    w617 = w3 * w29
    w618 = w617 - w11 * w19
    w619 = bar1_x_ddot * w616 + bar1_y_ddot * w615 + bar1_z_ddot * w618 + bar1_e0_ddot * w36 + bar1_e1_ddot * (w3 * w35 + w2 * (w2 * c69) + w6 * (w6 * c70))
    w620 = bar1_e3 * bar1_e0 * c73 + w6 * w38
    w621 = w2 * w41 + bar1_e2 * bar1_e0 * c72
    w622 = w3 * w10 + w2 * w14 + w6 * w15 + w615 * gravity_y - (w619 + bar1_e2_ddot * w620 + bar1_e3_ddot * w621)
    w623 = w3 * w45
    w624 = w3 * w568
    w625 = w283 + w285 * w566 + w286 * w576 + w288 * w584 - w256 * w603 + w218 * w606 + w270 * w608 - w264 * w609
    w626 = w622 + w567 * (w623 - w11 * w46) + w577 * (w47 - w624) + w585 * (w11 * w568 - w1 * w45) - w167 * w625
    w627 = w295 + w296 * w566 + w298 * w576 + w299 * w584 + w264 * w603 - w270 * w606 + w218 * w608 - w256 * w609
    w628 = w626 + w165 * w627
    w629 = w4 * w19 - w2 * w23
    w630 = w614 - w4 * w29
    w631 = w3 * w19
    w632 = w30 - w631
    w633 = bar1_x_ddot * w630 + bar1_y_ddot * w629 + bar1_z_ddot * w632 + bar1_e0_ddot * w39 + bar1_e1_ddot * w620
    w634 = w11 * w40 + bar1_e1 * bar1_e0 * c71
    w635 = w10 * w11 + w3 * w14 + w0 * w15 + w629 * gravity_y - (w633 + bar1_e2_ddot * (w11 * (w11 * c68) + w3 * w37 + w0 * w38) + bar1_e3_ddot * w634)
    w636 = w3 * w46
    w637 = w635 + w567 * (w578 - w636) + w577 * (w4 * w46 - w2 * w568) + w585 * (w624 - w4 * w45) + w165 * w625
    w638 = w637 + w167 * w627
    w639 = w631 - w6 * w23
    w640 = w24 - w617
    w641 = w6 * w29 - w0 * w19
    w642 = bar1_x_ddot * w640 + bar1_y_ddot * w639 + bar1_z_ddot * w641 + bar1_e0_ddot * w43 + bar1_e1_ddot * w621
    w643 = w1 * w10 + w4 * w14 + w3 * w15 + w639 * gravity_y - (w642 + bar1_e2_ddot * w634 + bar1_e3_ddot * (w1 * w40 + w4 * w41 + w3 * w42))
    w644 = w643 + w567 * (w6 * w45 - w0 * w46) + w577 * (w636 - w6 * w568) + w585 * (w569 - w623) + w165 * w610
    w645 = w644 - w167 * w612
    w646 = w7 * c66
    w647 = w5 * c66
    w648 = w7 * w646 + w5 * w647
    w649 = w12 * w647
    w650 = w20 + w21
    w651 = w12 * w646
    w652 = bar1_x_ddot * bar1_mass + w31 * bar1_e0_ddot + bar1_e1_ddot * w616 + bar1_e2_ddot * w630 + bar1_e3_ddot * w640
    w653 = w585 + (w18 * w648 - (w26 - w27) * w649 - w650 * w651 - w652)
    w654 = bar1_e1 * w4
    w655 = bar1_e3 * w6
    w656 = bar1_e0 * w4
    w657 = w655 - w656
    w658 = bar1_y_ddot * bar1_mass + w25 * bar1_e0_ddot + bar1_e1_ddot * w615 + bar1_e2_ddot * w629 + bar1_e3_ddot * w639
    w659 = w577 + (c98 + (w28 * w648 - w649 * (1.0 - (w17 + w654)) - w651 * w657) - w658)
    w660 = 1.0 - (w16 + w654)
    w661 = bar1_z_ddot * bar1_mass + w33 * bar1_e0_ddot + bar1_e1_ddot * w618 + bar1_e2_ddot * w632 + bar1_e3_ddot * w641
    w662 = w567 + (w22 * w648 - w649 * (w655 + w656) - w651 * w660 - w661)
    w663 = w593 - w592
    w664 = w596 - w595
    w665 = w599 - w598
    w666 = w389 - w565
    w667 = w398 - w575
    w668 = w406 - w583
    w669 = w432 - w602 * (w334 * w663 + w330 * w664 + w331 * w665) - w433 * w666 - w434 * w667 - w435 * w668
    w670 = w423 - w602 * (w332 * w663 + w235 * w664 + w330 * w665) - w424 * w666 - w426 * w667 - w427 * w668
    w671 = w371 - w602 * (w331 * w663 + w332 * w664 + w233 * w665) - w376 * w666 - w391 * w667 - w400 * w668
    w672 = w412 - w602 * (w239 * w663 + w334 * w664 + w332 * w665) - w413 * w666 - w414 * w667 - w417 * w668
    w673 = w503 + w666
    w674 = w514 + w667
    w675 = w524 + w668
    w676 = w549 - w328 * w672 + w326 * w669 - w550 * w673 - w551 * w674 - w552 * w675
    w677 = w543 + w328 * w671 + w326 * w670 - w544 * w673 - w546 * w674 - w547 * w675
    w678 = w533 + w326 * w671 - w328 * w670 - w535 * w673 - w536 * w674 - w538 * w675
    w679 = w484 + w326 * w672 + w328 * w669 - w487 * w673 - w507 * w674 - w518 * w675
    w680 = bar1_e1 * 0.5
    w681 = bar1_e0 * 0.5
    w682 = bar1_e3 * 0.5
    w683 = bar1_e2 * 0.5
    w684 = bar2_e3 * 0.5
    w685 = bar2_e0 * 0.5
    w686 = bar2_e1 * 0.5
    w687 = w657 * w685 - w650 * w684 + w660 * w686
    w688 = bar2_e2 * 0.5
    w689 = w650 * w686 + w657 * w688 + w660 * w684
    w690 = w650 * w685 + w657 * w684 - w660 * w688
    w691 = w650 * w688 - w657 * w686 + w660 * w685
    w692 = w625 * (w684 + w650 * w687) - (w612 * (w650 * w689 - w686) + w627 * (w685 - w650 * w690)) - w610 * (w688 - w650 * w691)
    w693 = w610 * (w686 + w657 * w691) - (w612 * (w657 * w689 - w688) + w627 * (w684 - w657 * w690) + w625 * (w685 - w657 * w687))
    w694 = w627 * (w688 + w660 * w690) - w612 * (w660 * w689 - w684) - w625 * (w686 - w660 * w687) - w610 * (w685 - w660 * w691)
    w695 = bar3_e3 * 0.5
    w696 = bar3_e0 * 0.5
    w697 = bar3_e1 * 0.5
    w698 = w570 * w696 - w579 * w695 + w65 * w697
    w699 = bar3_e2 * 0.5
    w700 = w579 * w697 + w570 * w699 + w65 * w695
    w701 = w579 * w696 + w570 * w695 - w65 * w699
    w702 = w579 * w699 - w570 * w697 + w65 * w696
    w703 = w606 * (w695 + w579 * w698) - (w609 * (w579 * w700 - w697) + w608 * (w696 - w579 * w701)) - w603 * (w699 - w579 * w702)
    w704 = w603 * (w697 + w570 * w702) - (w609 * (w570 * w700 - w699) + w608 * (w695 - w570 * w701) + w606 * (w696 - w570 * w698))
    w705 = w608 * (w699 + w65 * w701) - w609 * (w65 * w700 - w695) - w606 * (w697 - w65 * w698) - w603 * (w696 - w65 * w702)
    w706 = bar4_e0 * 0.5
    w707 = bar4_e2 * 0.5
    w708 = bar4_e3 * 0.5
    w709 = w381 * w707 - (w401 * w706 + w392 * w708)
    w710 = bar4_e1 * 0.5
    w711 = w401 * w710 + w392 * w707 + w381 * w708
    w712 = w401 * w708 - w392 * w706 - w381 * w710
    w713 = w392 * w710 - w401 * w707 - w381 * w706
    w714 = w670 * (w706 + w401 * w709) - w669 * (w710 - w401 * w711) - w671 * (w708 - w401 * w712) + w672 * (w707 + w401 * w713)
    w715 = w670 * (w708 + w392 * w709) - w669 * (w707 - w392 * w711) + w671 * (w706 + w392 * w712) - w672 * (w710 - w392 * w713)
    w716 = w671 * (w710 + w381 * w712) - (w669 * (w708 - w381 * w711) + w670 * (w707 - w381 * w709)) + w672 * (w706 + w381 * w713)
    w717 = bar5_e0 * 0.5
    w718 = bar5_e2 * 0.5
    w719 = bar5_e3 * 0.5
    w720 = w493 * w718 - (w519 * w717 + w508 * w719)
    w721 = bar5_e1 * 0.5
    w722 = w519 * w721 + w508 * w718 + w493 * w719
    w723 = w519 * w719 - w508 * w717 - w493 * w721
    w724 = w508 * w721 - w519 * w718 - w493 * w717
    w725 = w677 * (w717 + w519 * w720) - w676 * (w721 - w519 * w722) - w678 * (w719 - w519 * w723) + w679 * (w718 + w519 * w724)
    w726 = w677 * (w719 + w508 * w720) - w676 * (w718 - w508 * w722) + w678 * (w717 + w508 * w723) - w679 * (w721 - w508 * w724)
    w727 = w678 * (w721 + w493 * w723) - (w676 * (w719 - w493 * w722) + w677 * (w718 - w493 * w720)) + w679 * (w717 + w493 * w724)
    # outputs
    lam = ca.vertcat(
        w613,  # hinge0.e0
        w628,  # hinge0.e1
        w638,  # hinge0.e2
        w645,  # hinge0.e3
        w653,  # hinge0.x
        w659,  # hinge0.y
        w662,  # hinge0.z
        w612,  # hinge1.e0
        w627,  # hinge1.e1
        w625,  # hinge1.e2
        w610,  # hinge1.e3
        w585,  # hinge1.x
        w577,  # hinge1.y
        w567,  # hinge1.z
        w609,  # hinge2.e0
        w608,  # hinge2.e1
        w606,  # hinge2.e2
        w603,  # hinge2.e3
        w584,  # hinge2.x
        w576,  # hinge2.y
        w566,  # hinge2.z
        w583,  # hinge3.x
        w575,  # hinge3.y
        w565,  # hinge3.z
        w602,  # hinge3.parallel_x
        lam_R0,  # hinge3.parallel_y
        w669,  # hinge4.e0
        w670,  # hinge4.e1
        w671,  # hinge4.e2
        w672,  # hinge4.e3
        -w668,  # hinge4.x
        -w667,  # hinge4.y
        -w666,  # hinge4.z
        w676,  # hinge5.e0
        w677,  # hinge5.e1
        w678,  # hinge5.e2
        w679,  # hinge5.e3
        -w675,  # hinge5.x
        -w674,  # hinge5.y
        -w673,  # hinge5.z
    )
    joint_forces = ca.horzcat(
        ca.vertcat(  # hinge0
            -w653, -w659, -w662, w613 * w680 - w628 * w681 + w638 * w682 - w645 * w683, 0.0,
            w613 * w682 + w628 * w683 - w638 * w680 - w645 * w681,
        ),
        ca.vertcat(-w585, -w577, -w567, w692, w693, w694),  # hinge1
        ca.vertcat(-w584, -w576, -w566, w703, w704, w705),  # hinge2
        ca.vertcat(  # hinge3
            -w583, -w575, -w565, -(w602 * w663 + lam_R0 * w368), -(w602 * w664 + lam_R0 * w369),
            -(w602 * w665 + lam_R0 * w370),
        ),
        ca.vertcat(w668, w667, w666, w714, w715, w716),  # hinge4
        ca.vertcat(w675, w674, w673, w725, w726, w727),  # hinge5
    )
    inputs, outputs = [q, q_dot, q_ddot, lam_R, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "lam_R", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    1025 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 109)
    bar1_y = q[1]
    bar1_e0 = q[3]
    bar1_e1 = q[4]
    bar1_e2 = q[5]
    bar1_e3 = q[6]
    bar2_y = q[8]
    bar2_e0 = q[10]
    bar2_e1 = q[11]
    bar2_e2 = q[12]
    bar2_e3 = q[13]
    bar3_y = q[15]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar4_y = q[22]
    bar4_e0 = q[24]
    bar4_e1 = q[25]
    bar4_e2 = q[26]
    bar4_e3 = q[27]
    bar5_y = q[29]
    bar5_e0 = q[31]
    bar5_e1 = q[32]
    bar5_e2 = q[33]
    bar5_e3 = q[34]
    bar1_x_dot = q_dot[0]
    bar1_y_dot = q_dot[1]
    bar1_z_dot = q_dot[2]
    bar1_e0_dot = q_dot[3]
    bar1_e1_dot = q_dot[4]
    bar1_e2_dot = q_dot[5]
    bar1_e3_dot = q_dot[6]
    bar2_x_dot = q_dot[7]
    bar2_y_dot = q_dot[8]
    bar2_z_dot = q_dot[9]
    bar2_e0_dot = q_dot[10]
    bar2_e1_dot = q_dot[11]
    bar2_e2_dot = q_dot[12]
    bar2_e3_dot = q_dot[13]
    bar3_x_dot = q_dot[14]
    bar3_y_dot = q_dot[15]
    bar3_z_dot = q_dot[16]
    bar3_e0_dot = q_dot[17]
    bar3_e1_dot = q_dot[18]
    bar3_e2_dot = q_dot[19]
    bar3_e3_dot = q_dot[20]
    bar4_x_dot = q_dot[21]
    bar4_y_dot = q_dot[22]
    bar4_z_dot = q_dot[23]
    bar4_e0_dot = q_dot[24]
    bar4_e1_dot = q_dot[25]
    bar4_e2_dot = q_dot[26]
    bar4_e3_dot = q_dot[27]
    bar5_x_dot = q_dot[28]
    bar5_y_dot = q_dot[29]
    bar5_z_dot = q_dot[30]
    bar5_e0_dot = q_dot[31]
    bar5_e1_dot = q_dot[32]
    bar5_e2_dot = q_dot[33]
    bar5_e3_dot = q_dot[34]
    c4 = c[4]
    c22 = c[22]
    bar3_mass = c[48]
    bar2_mass = c[49]
    c53 = c[53]
    bar1_mass = c[54]
    bar4_mass = c[58]
    c60 = c[60]
    bar5_mass = c[61]
    c63 = c[63]
    c66 = c[66]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    c89 = c[89]
    c90 = c[90]
    c91 = c[91]
    c93 = c[93]
    c94 = c[94]
    c95 = c[95]
    c96 = c[96]
    c97 = c[97]
    c104 = c[104]
    # intermediate terms (253)
    w0 = 2 * -bar1_e2
    w1 = 2 * bar1_e1
    w2 = 2 * bar1_e2
    w3 = (w1 * bar1_e3 - w2 * bar1_e0) * c66
    w4 = 2 * -bar1_e3
    w5 = 2 * bar1_e3
    w6 = (bar1_e2 * w1 + bar1_e0 * w5) * c66
    w7 = w4 * w6
    w8 = w0 * w3 - w7
    w9 = w3 * w5 - w0 * w6
    w10 = 2 * bar1_e0
    w11 = w3 * w10
    w12 = w11 - w1 * w6
    w13 = 2 * -bar1_e1
    w14 = w3 * w13
    w15 = w6 * w10
    w16 = w14 - w15
    w17 = bar1_x_dot * bar1_mass + w8 * bar1_e0_dot + w9 * bar1_e1_dot + w12 * bar1_e2_dot + w16 * bar1_e3_dot
    w18 = (1.0 - (bar1_e2 * w2 + bar1_e3 * w5)) * c66
    w19 = w4 * w18 - w14
    w20 = w0 * w18
    w21 = w20 - w11
    w22 = w1 * w18 - w3 * w4
    w23 = w10 * w18
    w24 = w23 - w2 * w3
    w25 = bar1_y_dot * bar1_mass + bar1_e0_dot * w19 + bar1_e1_dot * w21 + bar1_e2_dot * w22 + bar1_e3_dot * w24
    w26 = w6 * w13 - w20
    w27 = w15 - w5 * w18
    w28 = w7 - w23
    w29 = w2 * w6 - w13 * w18
    w30 = bar1_z_dot * bar1_mass + bar1_e0_dot * w26 + bar1_e1_dot * w27 + bar1_e2_dot * w28 + bar1_e3_dot * w29
    w31 = bar1_x_dot * w8 + bar1_y_dot * w19 + bar1_z_dot * w26 + bar1_e0_dot * (w13 * (w13 * c68) + w0 * (w0 * c69) + w4 * (w4 * c70))
    w32 = w10 * c68
    w33 = w13 * w32 + bar1_e2 * bar1_e3 * c71
    w34 = w10 * c69
    w35 = w13 * c70
    w36 = w0 * w34 + bar1_e1 * bar1_e3 * c72
    w37 = w0 * c68
    w38 = w1 * c69
    w39 = w10 * c70
    w40 = bar1_e2 * bar1_e1 * c73 + w4 * w39
    w41 = bar1_x_dot * w17 + bar1_y_dot * w25 + bar1_z_dot * w30 + bar1_e0_dot * (w31 + bar1_e1_dot * w33 + bar1_e2_dot * w36 + bar1_e3_dot * w40)
    w42 = bar1_x_dot * w9 + bar1_y_dot * w21 + bar1_z_dot * w27 + bar1_e0_dot * w33 + bar1_e1_dot * (w10 * w32 + w4 * (w4 * c69) + w2 * (w2 * c70))
    w43 = bar1_e3 * bar1_e0 * c73 + w2 * w35
    w44 = w4 * w38 + bar1_e2 * bar1_e0 * c72
    w45 = bar1_x_dot * w12 + bar1_y_dot * w22 + bar1_z_dot * w28 + bar1_e0_dot * w36 + bar1_e1_dot * w43 + bar1_e2_dot * (w5 * (w5 * c68) + w10 * w34 + w13 * w35)
    w46 = w5 * w37 + bar1_e1 * bar1_e0 * c71
    w47 = w41 + bar1_e1_dot * (w42 + bar1_e2_dot * w43 + bar1_e3_dot * w44) + bar1_e2_dot * (w45 + bar1_e3_dot * w46)
    w48 = bar1_x_dot * w16 + bar1_y_dot * w24 + bar1_z_dot * w29 + bar1_e0_dot * w40 + bar1_e1_dot * w44 + bar1_e2_dot * w46
    w49 = 2 * -bar2_e2
    w50 = 2 * bar2_e2
    w51 = 2 * bar2_e1
    w52 = (w50 * bar2_e3 + w51 * bar2_e0) * c53
    w53 = 2 * -bar2_e3
    w54 = 2 * bar2_e3
    w55 = (1.0 - (bar2_e1 * w51 + bar2_e3 * w54)) * c53
    w56 = w53 * w55
    w57 = w49 * w52 - w56
    w58 = w52 * w54 - w49 * w55
    w59 = 2 * bar2_e0
    w60 = w52 * w59
    w61 = w60 - w51 * w55
    w62 = 2 * -bar2_e1
    w63 = w52 * w62
    w64 = w55 * w59
    w65 = w63 - w64
    w66 = bar2_x_dot * bar2_mass + w57 * bar2_e0_dot + w58 * bar2_e1_dot + w61 * bar2_e2_dot + w65 * bar2_e3_dot
    w67 = (bar2_e2 * w51 - bar2_e0 * w54) * c53
    w68 = w53 * w67 - w63
    w69 = w49 * w67
    w70 = w69 - w60
    w71 = w51 * w67 - w52 * w53
    w72 = w59 * w67
    w73 = w72 - w50 * w52
    w74 = bar2_y_dot * bar2_mass + bar2_e0_dot * w68 + bar2_e1_dot * w70 + bar2_e2_dot * w71 + bar2_e3_dot * w73
    w75 = w47 + bar1_e3_dot * (w48 + bar1_e3_dot * (w0 * w37 + w1 * w38 + w10 * w39)) + bar2_x_dot * w66 + bar2_y_dot * w74
    w76 = w55 * w62 - w69
    w77 = w64 - w54 * w67
    w78 = w56 - w72
    w79 = w50 * w55 - w62 * w67
    w80 = bar2_z_dot * bar2_mass + bar2_e0_dot * w76 + bar2_e1_dot * w77 + bar2_e2_dot * w78 + bar2_e3_dot * w79
    w81 = bar2_x_dot * w57 + bar2_y_dot * w68 + bar2_z_dot * w76 + bar2_e0_dot * (w62 * (w62 * c74) + w49 * (w49 * c75) + w53 * (w53 * c76))
    w82 = w59 * c74
    w83 = w62 * w82 + bar2_e2 * bar2_e3 * c77
    w84 = w59 * c75
    w85 = w62 * c76
    w86 = w49 * w84 + bar2_e3 * bar2_e1 * c78
    w87 = w49 * c74
    w88 = w51 * c75
    w89 = w59 * c76
    w90 = bar2_e2 * bar2_e1 * c79 + w53 * w89
    w91 = w75 + bar2_z_dot * w80 + bar2_e0_dot * (w81 + bar2_e1_dot * w83 + bar2_e2_dot * w86 + bar2_e3_dot * w90)
    w92 = bar2_x_dot * w58 + bar2_y_dot * w70 + bar2_z_dot * w77 + bar2_e0_dot * w83 + bar2_e1_dot * (w59 * w82 + w53 * (w53 * c75) + w50 * (w50 * c76))
    w93 = bar2_e3 * bar2_e0 * c79 + w50 * w85
    w94 = w53 * w88 + bar2_e2 * bar2_e0 * c78
    w95 = bar2_x_dot * w61 + bar2_y_dot * w71 + bar2_z_dot * w78 + bar2_e0_dot * w86 + bar2_e1_dot * w93 + bar2_e2_dot * (w54 * (w54 * c74) + w59 * w84 + w62 * w85)
    w96 = w54 * w87 + bar2_e1 * bar2_e0 * c77
    w97 = w91 + bar2_e1_dot * (w92 + bar2_e2_dot * w93 + bar2_e3_dot * w94) + bar2_e2_dot * (w95 + bar2_e3_dot * w96)
    w98 = bar2_x_dot * w65 + bar2_y_dot * w73 + bar2_z_dot * w79 + bar2_e0_dot * w90 + bar2_e1_dot * w94 + bar2_e2_dot * w96
    w99 = 2 * -bar3_e2
    w100 = 2 * bar3_e1
    w101 = 2 * bar3_e2
    w102 = (1.0 - (bar3_e1 * w100 + bar3_e2 * w101)) * c4
    w103 = 2 * -bar3_e3
    w104 = (w101 * bar3_e3 - w100 * bar3_e0) * c4
    w105 = w103 * w104
    w106 = w99 * w102 - w105
    w107 = 2 * bar3_e3
    w108 = w102 * w107 - w99 * w104
    w109 = 2 * bar3_e0
    w110 = w102 * w109
    w111 = w110 - w100 * w104
    w112 = 2 * -bar3_e1
    w113 = w102 * w112
    w114 = w104 * w109
    w115 = w113 - w114
    w116 = bar3_x_dot * bar3_mass + w106 * bar3_e0_dot + w108 * bar3_e1_dot + w111 * bar3_e2_dot + w115 * bar3_e3_dot
    w117 = w97 + bar2_e3_dot * (w98 + bar2_e3_dot * (w49 * w87 + w51 * w88 + w59 * w89)) + bar3_x_dot * w116
    w118 = (w100 * bar3_e3 + w101 * bar3_e0) * c4
    w119 = w103 * w118 - w113
    w120 = w99 * w118
    w121 = w120 - w110
    w122 = w100 * w118 - w102 * w103
    w123 = w109 * w118
    w124 = w123 - w101 * w102
    w125 = bar3_y_dot * bar3_mass + bar3_e0_dot * w119 + bar3_e1_dot * w121 + bar3_e2_dot * w122 + bar3_e3_dot * w124
    w126 = w104 * w112 - w120
    w127 = w114 - w107 * w118
    w128 = w105 - w123
    w129 = w101 * w104 - w112 * w118
    w130 = bar3_z_dot * bar3_mass + bar3_e0_dot * w126 + bar3_e1_dot * w127 + bar3_e2_dot * w128 + bar3_e3_dot * w129
    w131 = bar3_x_dot * w106 + bar3_y_dot * w119 + bar3_z_dot * w126 + bar3_e0_dot * (w112 * (w112 * c22) + w99 * (w99 * c80) + w103 * (w103 * c81))
    w132 = w109 * c22
    w133 = w112 * w132 + bar3_e2 * bar3_e3 * c82
    w134 = w109 * c80
    w135 = w112 * c81
    w136 = w99 * w134 + bar3_e1 * bar3_e3 * c83
    w137 = w99 * c22
    w138 = w100 * c80
    w139 = w109 * c81
    w140 = bar3_e2 * bar3_e1 * c84 + w103 * w139
    w141 = w117 + bar3_y_dot * w125 + bar3_z_dot * w130 + bar3_e0_dot * (w131 + bar3_e1_dot * w133 + bar3_e2_dot * w136 + bar3_e3_dot * w140)
    w142 = bar3_x_dot * w108 + bar3_y_dot * w121 + bar3_z_dot * w127 + bar3_e0_dot * w133 + bar3_e1_dot * (w109 * w132 + w103 * (w103 * c80) + w101 * (w101 * c81))
    w143 = bar3_e3 * bar3_e0 * c84 + w101 * w135
    w144 = w103 * w138 + bar3_e2 * bar3_e0 * c83
    w145 = bar3_x_dot * w111 + bar3_y_dot * w122 + bar3_z_dot * w128 + bar3_e0_dot * w136 + bar3_e1_dot * w143
    w146 = w107 * w137 + bar3_e1 * bar3_e0 * c82
    w147 = bar3_e2_dot * (w145 + bar3_e2_dot * (w107 * (w107 * c22) + w109 * w134 + w112 * w135) + bar3_e3_dot * w146)
    w148 = bar3_x_dot * w115 + bar3_y_dot * w124 + bar3_z_dot * w129 + bar3_e0_dot * w140 + bar3_e1_dot * w144
    w149 = bar3_e3_dot * (w148 + bar3_e2_dot * w146 + bar3_e3_dot * (w99 * w137 + w100 * w138 + w109 * w139))
    w150 = 2 * -bar4_e2
    w151 = 2 * bar4_e1
    w152 = 2 * bar4_e2
    w153 = (w151 * bar4_e3 - w152 * bar4_e0) * c60
    w154 = 2 * -bar4_e3
    w155 = 2 * bar4_e3
    w156 = (bar4_e2 * w151 + bar4_e0 * w155) * c60
    w157 = w154 * w156
    w158 = w150 * w153 - w157
    w159 = w153 * w155 - w150 * w156
    w160 = 2 * bar4_e0
    w161 = w153 * w160
    w162 = w161 - w151 * w156
    w163 = 2 * -bar4_e1
    w164 = w153 * w163
    w165 = w156 * w160
    w166 = w164 - w165
    w167 = bar4_x_dot * bar4_mass + w158 * bar4_e0_dot + w159 * bar4_e1_dot + w162 * bar4_e2_dot + w166 * bar4_e3_dot
    w168 = w141 + bar3_e1_dot * (w142 + bar3_e2_dot * w143 + bar3_e3_dot * w144) + w147 + w149 + bar4_x_dot * w167
    w169 = (1.0 - (bar4_e2 * w152 + bar4_e3 * w155)) * c60
    w170 = w154 * w169 - w164
    w171 = w150 * w169
    w172 = w171 - w161
    w173 = w151 * w169 - w153 * w154
    w174 = w160 * w169
    w175 = w174 - w152 * w153
    w176 = bar4_y_dot * bar4_mass + bar4_e0_dot * w170 + bar4_e1_dot * w172 + bar4_e2_dot * w173 + bar4_e3_dot * w175
    w177 = w156 * w163 - w171
    w178 = w165 - w155 * w169
    w179 = w157 - w174
    w180 = w152 * w156 - w163 * w169
    w181 = bar4_z_dot * bar4_mass + bar4_e0_dot * w177 + bar4_e1_dot * w178 + bar4_e2_dot * w179 + bar4_e3_dot * w180
    w182 = bar4_x_dot * w158 + bar4_y_dot * w170 + bar4_z_dot * w177 + bar4_e0_dot * (w163 * (w163 * c85) + w150 * (w150 * c86) + w154 * (w154 * c87))
    w183 = w160 * c85
    w184 = w163 * w183 + bar4_e2 * bar4_e3 * c88
    w185 = w160 * c86
    w186 = w163 * c87
    w187 = w150 * w185 + bar4_e1 * bar4_e3 * c89
    w188 = w150 * c85
    w189 = w151 * c86
    w190 = w160 * c87
    w191 = bar4_e2 * bar4_e1 * c90 + w154 * w190
    w192 = w168 + bar4_y_dot * w176 + bar4_z_dot * w181 + bar4_e0_dot * (w182 + bar4_e1_dot * w184 + bar4_e2_dot * w187 + bar4_e3_dot * w191)
    w193 = bar4_x_dot * w159 + bar4_y_dot * w172 + bar4_z_dot * w178 + bar4_e0_dot * w184 + bar4_e1_dot * (w160 * w183 + w154 * (w154 * c86) + w152 * (w152 * c87))
    w194 = bar4_e3 * bar4_e0 * c90 + w152 * w186
    w195 = w154 * w189 + bar4_e2 * bar4_e0 * c89
    w196 = bar4_x_dot * w162 + bar4_y_dot * w173 + bar4_z_dot * w179 + bar4_e0_dot * w187 + bar4_e1_dot * w194
    w197 = w155 * w188 + bar4_e1 * bar4_e0 * c88
    w198 = bar4_e2_dot * (w196 + bar4_e2_dot * (w155 * (w155 * c85) + w160 * w185 + w163 * w186) + bar4_e3_dot * w197)
    w199 = bar4_x_dot * w166 + bar4_y_dot * w175 + bar4_z_dot * w180 + bar4_e0_dot * w191 + bar4_e1_dot * w195
    w200 = bar4_e3_dot * (w199 + bar4_e2_dot * w197 + bar4_e3_dot * (w150 * w188 + w151 * w189 + w160 * w190))
    w201 = 2 * -bar5_e2
    w202 = 2 * bar5_e2
    w203 = 2 * bar5_e1
    w204 = (w202 * bar5_e3 + w203 * bar5_e0) * c63
    w205 = 2 * -bar5_e3
    w206 = 2 * bar5_e3
    w207 = (1.0 - (bar5_e1 * w203 + bar5_e3 * w206)) * c63
    w208 = w205 * w207
    w209 = w201 * w204 - w208
    w210 = w204 * w206 - w201 * w207
    w211 = 2 * bar5_e0
    w212 = w204 * w211
    w213 = w212 - w203 * w207
    w214 = 2 * -bar5_e1
    w215 = w204 * w214
    w216 = w207 * w211
    w217 = w215 - w216
    w218 = bar5_x_dot * bar5_mass + w209 * bar5_e0_dot + w210 * bar5_e1_dot + w213 * bar5_e2_dot + w217 * bar5_e3_dot
    w219 = w192 + bar4_e1_dot * (w193 + bar4_e2_dot * w194 + bar4_e3_dot * w195) + w198 + w200 + bar5_x_dot * w218
    w220 = (bar5_e2 * w203 - bar5_e0 * w206) * c63
    w221 = w205 * w220 - w215
    w222 = w201 * w220
    w223 = w222 - w212
    w224 = w203 * w220 - w204 * w205
    w225 = w211 * w220
    w226 = w225 - w202 * w204
    w227 = bar5_y_dot * bar5_mass + bar5_e0_dot * w221 + bar5_e1_dot * w223 + bar5_e2_dot * w224 + bar5_e3_dot * w226
    w228 = w207 * w214 - w222
    w229 = w216 - w206 * w220
    w230 = w208 - w225
    w231 = w202 * w207 - w214 * w220
    w232 = bar5_z_dot * bar5_mass + bar5_e0_dot * w228 + bar5_e1_dot * w229 + bar5_e2_dot * w230 + bar5_e3_dot * w231
    w233 = bar5_x_dot * w209 + bar5_y_dot * w221 + bar5_z_dot * w228 + bar5_e0_dot * (w214 * (w214 * c91) + w201 * (w201 * c93) + w205 * (w205 * c94))
    w234 = w211 * c91
    w235 = w214 * w234 + bar5_e2 * bar5_e3 * c95
    w236 = w211 * c93
    w237 = w214 * c94
    w238 = w201 * w236 + bar5_e3 * bar5_e1 * c96
    w239 = w201 * c91
    w240 = w203 * c93
    w241 = w211 * c94
    w242 = bar5_e2 * bar5_e1 * c97 + w205 * w241
    w243 = w219 + bar5_y_dot * w227 + bar5_z_dot * w232 + bar5_e0_dot * (w233 + bar5_e1_dot * w235 + bar5_e2_dot * w238 + bar5_e3_dot * w242)
    w244 = bar5_x_dot * w210 + bar5_y_dot * w223 + bar5_z_dot * w229 + bar5_e0_dot * w235 + bar5_e1_dot * (w211 * w234 + w205 * (w205 * c93) + w202 * (w202 * c94))
    w245 = bar5_e3 * bar5_e0 * c97 + w202 * w237
    w246 = w205 * w240 + bar5_e2 * bar5_e0 * c96
    w247 = bar5_x_dot * w213 + bar5_y_dot * w224 + bar5_z_dot * w230 + bar5_e0_dot * w238 + bar5_e1_dot * w245
    w248 = w206 * w239 + bar5_e1 * bar5_e0 * c95
    w249 = bar5_e2_dot * (w247 + bar5_e2_dot * (w206 * (w206 * c91) + w211 * w236 + w214 * w237) + bar5_e3_dot * w248)
    w250 = bar5_x_dot * w217 + bar5_y_dot * w226 + bar5_z_dot * w231 + bar5_e0_dot * w242 + bar5_e1_dot * w246
    w251 = bar5_e3_dot * (w250 + bar5_e2_dot * w248 + bar5_e3_dot * (w201 * w239 + w203 * w240 + w211 * w241))
    w252 = w6 + bar1_y * bar1_mass + (w55 + bar2_y * bar2_mass) + (w104 + bar3_y * bar3_mass) + (w156 + bar4_y * bar4_mass)
    # outputs
    kinetic = ca.vertcat((w243 + bar5_e1_dot * (w244 + bar5_e2_dot * w245 + bar5_e3_dot * w246) + w249 + w251) / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w252 + (w207 + bar5_y * bar5_mass)) * c104)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives measures (measures = 6) [mixed]: measures of the scene and their rates
    41 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 109)
    bar3_x = q[14]
    bar3_y = q[15]
    bar3_z = q[16]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar3_x_dot = q_dot[14]
    bar3_y_dot = q_dot[15]
    bar3_z_dot = q_dot[16]
    bar3_e0_dot = q_dot[17]
    bar3_e1_dot = q_dot[18]
    bar3_e2_dot = q_dot[19]
    bar3_e3_dot = q_dot[20]
    bar3_end_z = c[11]
    c105 = c[105]
    c106 = c[106]
    # intermediate terms (2)
    w0 = bar3_e0 * bar3_e2_dot + (bar3_e2 * bar3_e0_dot + (bar3_e1 * bar3_e3_dot + bar3_e3 * bar3_e1_dot))
    w1 = (bar3_e3 * bar3_e2_dot + bar3_e2 * bar3_e3_dot - bar3_e1 * bar3_e0_dot - bar3_e0 * bar3_e1_dot) * c105
    # outputs
    measures = ca.vertcat(
        bar3_x + (bar3_e1 * bar3_e3 + bar3_e2 * bar3_e0) * c105,  # P3_x
        bar3_x_dot + w0 * c105,  # P3_x_dot
        bar3_y + (bar3_e3 * bar3_e2 - bar3_e1 * bar3_e0) * c105,  # P3_y
        bar3_y_dot + w1,  # P3_y_dot
        bar3_end_z + bar3_z - bar3_e1**2 * c105 - bar3_e2**2 * c105,  # P3_z
        bar3_z_dot - bar3_e1 * bar3_e1_dot * c106 - bar3_e2 * bar3_e2_dot * c106,  # P3_z_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 5) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    120 operations.
    """
    q = ca.SX.sym("q", 40)
    bar1_x = q[0]
    bar1_y = q[1]
    bar1_z = q[2]
    bar1_e0 = q[3]
    bar1_e1 = q[4]
    bar1_e2 = q[5]
    bar1_e3 = q[6]
    bar2_x = q[7]
    bar2_y = q[8]
    bar2_z = q[9]
    bar2_e0 = q[10]
    bar2_e1 = q[11]
    bar2_e2 = q[12]
    bar2_e3 = q[13]
    bar3_x = q[14]
    bar3_y = q[15]
    bar3_z = q[16]
    bar3_e0 = q[17]
    bar3_e1 = q[18]
    bar3_e2 = q[19]
    bar3_e3 = q[20]
    bar4_x = q[21]
    bar4_y = q[22]
    bar4_z = q[23]
    bar4_e0 = q[24]
    bar4_e1 = q[25]
    bar4_e2 = q[26]
    bar4_e3 = q[27]
    bar5_x = q[28]
    bar5_y = q[29]
    bar5_z = q[30]
    bar5_e0 = q[31]
    bar5_e1 = q[32]
    bar5_e2 = q[33]
    bar5_e3 = q[34]
    # intermediate terms (60)
    w0 = 2 * bar1_e2
    w1 = bar1_e2 * w0
    w2 = 2 * bar1_e3
    w3 = bar1_e3 * w2
    w4 = 2 * bar1_e1
    w5 = bar1_e2 * w4
    w6 = w2 * bar1_e0
    w7 = bar1_e3 * w4
    w8 = w0 * bar1_e0
    w9 = bar1_e1 * w4
    w10 = w0 * bar1_e3
    w11 = w4 * bar1_e0
    w12 = 2 * bar2_e2
    w13 = bar2_e2 * w12
    w14 = 2 * bar2_e3
    w15 = bar2_e3 * w14
    w16 = 2 * bar2_e1
    w17 = bar2_e2 * w16
    w18 = w14 * bar2_e0
    w19 = bar2_e3 * w16
    w20 = w12 * bar2_e0
    w21 = bar2_e1 * w16
    w22 = w12 * bar2_e3
    w23 = w16 * bar2_e0
    w24 = 2 * bar3_e2
    w25 = bar3_e2 * w24
    w26 = 2 * bar3_e3
    w27 = bar3_e3 * w26
    w28 = 2 * bar3_e1
    w29 = bar3_e2 * w28
    w30 = w26 * bar3_e0
    w31 = bar3_e3 * w28
    w32 = w24 * bar3_e0
    w33 = bar3_e1 * w28
    w34 = w24 * bar3_e3
    w35 = w28 * bar3_e0
    w36 = 2 * bar4_e2
    w37 = bar4_e2 * w36
    w38 = 2 * bar4_e3
    w39 = bar4_e3 * w38
    w40 = 2 * bar4_e1
    w41 = bar4_e2 * w40
    w42 = w38 * bar4_e0
    w43 = bar4_e3 * w40
    w44 = w36 * bar4_e0
    w45 = bar4_e1 * w40
    w46 = w36 * bar4_e3
    w47 = w40 * bar4_e0
    w48 = 2 * bar5_e2
    w49 = bar5_e2 * w48
    w50 = 2 * bar5_e3
    w51 = bar5_e3 * w50
    w52 = 2 * bar5_e1
    w53 = bar5_e2 * w52
    w54 = w50 * bar5_e0
    w55 = bar5_e3 * w52
    w56 = w48 * bar5_e0
    w57 = bar5_e1 * w52
    w58 = w48 * bar5_e3
    w59 = w52 * bar5_e0
    # outputs
    poses = ca.vertcat(
        ca.horzcat(bar1_x, bar2_x, bar3_x, bar4_x, bar5_x),
        ca.horzcat(bar1_y, bar2_y, bar3_y, bar4_y, bar5_y),
        ca.horzcat(bar1_z, bar2_z, bar3_z, bar4_z, bar5_z),
        ca.horzcat(1.0 - (w1 + w3), 1.0 - (w13 + w15), 1.0 - (w25 + w27), 1.0 - (w37 + w39), 1.0 - (w49 + w51)),
        ca.horzcat(w5 + w6, w17 + w18, w29 + w30, w41 + w42, w53 + w54),
        ca.horzcat(w7 - w8, w19 - w20, w31 - w32, w43 - w44, w55 - w56),
        ca.horzcat(w5 - w6, w17 - w18, w29 - w30, w41 - w42, w53 - w54),
        ca.horzcat(1.0 - (w3 + w9), 1.0 - (w15 + w21), 1.0 - (w27 + w33), 1.0 - (w39 + w45), 1.0 - (w51 + w57)),
        ca.horzcat(w10 + w11, w22 + w23, w34 + w35, w46 + w47, w58 + w59),
        ca.horzcat(w7 + w8, w19 + w20, w31 + w32, w43 + w44, w55 + w56),
        ca.horzcat(w10 - w11, w22 - w23, w34 - w35, w46 - w47, w58 - w59),
        ca.horzcat(1.0 - (w1 + w9), 1.0 - (w13 + w21), 1.0 - (w25 + w33), 1.0 - (w37 + w45), 1.0 - (w49 + w57)),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    1606 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    hinge1_angle_dot = q_d_dot[35]
    hinge2_angle_dot = q_d_dot[36]
    hinge4_angle_dot = q_d_dot[37]
    hinge5_angle_dot = q_d_dot[38]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c23 = c[23]
    gravity_y = c[24]
    c25 = c[25]
    # intermediate terms (374)
    w0 = ca.cos(hinge1_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.sin(hinge1_angle)
    w3 = w2 * hinge0_angle_dot
    w4 = w3 * hinge1_angle_dot
    w5 = ca.cos(hinge2_angle)
    w6 = ca.sin(hinge0_angle)
    w7 = w0 * w6
    w8 = ca.cos(hinge0_angle)
    w9 = w2 * w8
    w10 = w5 * w6
    w11 = (w1 * w9 + w10) * bar3_end_z
    w12 = w0 * w8
    w13 = w5 * w8
    w14 = w2 * w6
    w15 = (w13 - w1 * w14) * bar3_end_z
    w16 = w7 * w11 + w12 * w15
    w17 = ca.sin(hinge5_angle)
    w18 = ca.cos(hinge4_angle)
    w19 = w18 * bar4_end_x
    w20 = w17 * w19
    w21 = w17 * w18
    w22 = w2 * w21
    w23 = ca.cos(hinge5_angle)
    w24 = w18 * w23
    w25 = w7 * w24
    w26 = w22 - w25
    w27 = ca.sin(hinge4_angle)
    w28 = w23 * w27 * bar4_end_x
    w29 = w23 * bar5_end_y
    w30 = w28 - w29
    w31 = w7 * w27
    w32 = w12 * w21
    w33 = w31 - w32
    w34 = w2 * w27
    w35 = w12 * w24
    w36 = w34 - w35
    w37 = w17 * w33 + w23 * w36
    w38 = w20 * w26 - w30 * w37
    w39 = w16 * w38
    w40 = w19 * w23
    w41 = w25 - w22
    w42 = w32 - w31
    w43 = w35 - w34
    w44 = w12 * w41 + w2 * w42 - w7 * w43
    w45 = w0 * w1 * bar3_end_z
    w46 = w12 * w45 + w2 * w11
    w47 = w30 * w44 - w26 * w46
    w48 = w17 * bar5_end_y
    w49 = w17 * w27 * bar4_end_x
    w50 = w48 - w49
    w51 = w20 * w44 - w37 * w46
    w52 = w39 - w40 * w47 + w50 * w51
    w53 = hinge1_angle_dot * w6
    w54 = hinge0_angle_dot * w53
    w55 = w0 * bar2_end_y
    w56 = w8 * bar1_end_x
    w57 = hinge0_angle_dot * (hinge0_angle_dot * w56)
    w58 = w9 * bar2_end_y
    w59 = w53 * w55 + hinge0_angle_dot * w58
    w60 = hinge1_angle_dot * w8
    w61 = w14 * bar2_end_y
    w62 = w2 * hinge1_angle_dot * bar2_end_y
    w63 = w12 * hinge2_angle_dot
    w64 = w7 * hinge2_angle_dot
    w65 = hinge2_angle_dot * (w0 * hinge1_angle_dot)
    w66 = w2 * hinge2_angle_dot
    w67 = w53 * w66 - hinge0_angle_dot * w63 - w54
    w68 = hinge0_angle_dot + w66
    w69 = w53 + w63
    w70 = w45 * w69 + w11 * w68
    w71 = w60 - w64
    w72 = w11 * w71 - w15 * w69
    w73 = w54 * w55 - w57 + (hinge0_angle_dot * w59 + w60 * w62) + (w15 * w65 + w45 * w67) - (w68 * w70 + w71 * w72)
    w74 = w23 * hinge4_angle_dot
    w75 = hinge5_angle_dot * w74
    w76 = w17 * hinge4_angle_dot
    w77 = hinge5_angle_dot * w76
    w78 = w28 * hinge5_angle_dot + w19 * w76
    w79 = w19 * w74 - w49 * hinge5_angle_dot
    w80 = w73 - (w49 * w75 - w28 * w77 + (w76 * w78 + w74 * w79))
    w81 = w2 * w15 - w7 * w45
    w82 = w38 * w81
    w83 = w27 * bar4_end_x
    w84 = w82 + w47 * w83
    w85 = hinge0_angle_dot * w60
    w86 = hinge0_angle_dot * w61 - w55 * w60
    w87 = w85 - (hinge0_angle_dot * w64 + w60 * w66)
    w88 = w15 * w68 + w45 * w71
    w89 = w54 * w58 - w61 * w85 + (w60 * w86 - w53 * w59) + (w11 * w67 - w15 * w87) + (w71 * w88 + w69 * w70)
    w90 = w29 * hinge5_angle_dot
    w91 = w27 * hinge4_angle_dot * bar4_end_x
    w92 = w89 - (hinge5_angle_dot * w90 - w19 * w77 - (w74 * w91 + hinge5_angle_dot * w78))
    w93 = w50 * w83
    w94 = w44 * w93
    w95 = w50 * w81
    w96 = w40 * w81 + w16 * w83
    w97 = w94 - w37 * w95 + w26 * w96
    w98 = w6 * bar1_end_x
    w99 = hinge0_angle_dot * (hinge0_angle_dot * w98)
    w100 = w99 + w55 * w85 - (w53 * w62 + hinge0_angle_dot * w86) - (w45 * w87 + w11 * w65) + (w69 * w72 - w68 * w88)
    w101 = w48 * hinge5_angle_dot
    w102 = w100 - (w76 * w91 - hinge5_angle_dot * w79 - (hinge5_angle_dot * w101 + w19 * w75))
    w103 = w46 * w93
    w104 = w103 - w20 * w95 + w30 * w96
    w105 = w27 * w76 - w24 * hinge5_angle_dot
    w106 = w18 * hinge4_angle_dot
    w107 = hinge5_angle_dot * w105 - w74 * w106
    w108 = w27 * w74 + w21 * hinge5_angle_dot
    w109 = w76 * w105 + w74 * w108
    w110 = hinge5_angle_dot * w108 + w76 * w106
    w111 = w2 * w69 - w12 * w68
    w112 = w12 * w71 + w7 * w69
    w113 = w68 * w111 - w71 * w112
    w114 = w7 * w68 + w2 * w71
    w115 = w71 * w114 + w69 * w111
    w116 = w69 * w112 + w68 * w114
    w117 = 2 * -w114
    w118 = 2 * w112
    w119 = w2 * w107 - w12 * w109 - w7 * w110 + w27 * w113 - w24 * w115 - w21 * w116 + w106 * w117 - w108 * w118
    w120 = 2 * w111
    w121 = w33 * w75 - (w119 + w105 * w120 + w41 * w87 + w42 * w65 + w43 * w67) - w36 * w77
    w122 = w55 - w45
    w123 = w8 * w122
    w124 = w6 * w122
    w125 = w6 * w41 + w8 * w43
    w126 = w37 * w124 + w20 * w125
    w127 = w11 - w58
    w128 = w15 + w61
    w129 = w8 * w127 - w6 * w128
    w130 = w38 * w129
    w131 = w26 * w124 + w30 * w125
    w132 = w50 * w126 - (w130 + w40 * w131)
    w133 = w44 * w124 + w46 * w125
    w134 = w50 * w133
    w135 = w47 * w129 + w16 * w131 + w134
    w136 = w52 * w123 + w81 * w132 - w83 * w135
    w137 = (w52 * w80 + w84 * w92 + w97 * w102 - w104 * w121) / w136
    w138 = w0 * hinge0_angle_dot
    w139 = w5 * w138 + w1 * hinge1_angle_dot
    w140 = w3 + hinge2_angle_dot
    w141 = (w1 * w4 + w5 * w137 - hinge2_angle_dot * w139 - w139 * w140) * c1
    w142 = w93 * w125
    w143 = w50 * w123
    w144 = w40 * w123 + w83 * w129
    w145 = w142 + w37 * w143 - w26 * w144
    w146 = w56 + w127
    w147 = w128 - w98
    w148 = w93 * w124
    w149 = w20 * w143 - w148 - w30 * w144
    w150 = (w145 * w146 - w132 * w147 - w42 * w149) / w136
    w151 = w5 * w150
    w152 = (w52 * w147 - w97 * w146 + w42 * w104) / w136
    w153 = w0 * w152
    w154 = hinge0_angle_dot * w153
    w155 = w2 * w152
    w156 = w12 - w6 * w155
    w157 = w16 * w123 - w81 * w129
    w158 = w26 * w157
    w159 = w95 * w125 + w44 * w143 + w158
    w160 = w30 * w157
    w161 = w95 * w124 - w46 * w143 - w160
    w162 = (w146 * w159 - w135 * w147 + w42 * w161) / w136
    w163 = w27 * w162
    w164 = w40 * w133
    w165 = w51 * w129 + w16 * w126 + w164
    w166 = w37 * w157
    w167 = w96 * w125 + w44 * w144 + w166
    w168 = w20 * w157
    w169 = w96 * w124 - w46 * w144 - w168
    w170 = (w147 * w165 - w146 * w167 - w42 * w169) / w136
    w171 = w17 * w170
    w172 = w23 * w163 + w18 * w171
    w173 = w24 * w156 - w7 * w172
    w174 = w23 * w170
    w175 = w18 * w174 - w17 * w163
    w176 = w21 * w153 + w2 * w175
    w177 = w173 - w176
    w178 = w7 + w8 * w155
    w179 = w18 * w162
    w180 = w24 * w178 + w12 * w172 + (w27 * w153 + w2 * w179)
    w181 = w6 * w177 + w8 * w41 - (w8 * w180 + w6 * w43)
    w182 = w12 * w175 - w21 * w178
    w183 = w27 * w156 + w7 * w179
    w184 = w182 - w183
    w185 = w12 * w177 - w41 * w178 + (w2 * w184 + w42 * w153) - (w43 * w156 - w7 * w180)
    w186 = w176 - w173
    w187 = hinge1_angle_dot * w181 + hinge2_angle_dot * w185 + hinge0_angle_dot * w184 - hinge5_angle_dot * w186
    w188 = w183 - w182
    w189 = w17 * w188 + w33 * w174 + (w23 * w180 - w36 * w171)
    w190 = w187 - hinge4_angle_dot * w189
    w191 = (w17 * w179 + w27 * w174) * bar4_end_x
    w192 = (w23 * w179 - w27 * w171) * bar4_end_x
    w193 = w49 * w174 + w17 * w191 + (w23 * w192 - w28 * w171)
    w194 = w155 * bar2_end_y
    w195 = (w0 * w151 - w1 * w155) * bar3_end_z
    w196 = w194 + w195
    w197 = w124 + w8 * w196
    w198 = w9 + w6 * w153
    w199 = w198 * bar2_end_y
    w200 = w1 * w150
    w201 = (w10 + w8 * w200 + (w14 * w151 + w1 * w198)) * bar3_end_z
    w202 = w199 - w201
    w203 = w202 - w56
    w204 = w15 * w153 - w2 * w201 - (w45 * w156 + w7 * w195)
    w205 = hinge4_angle_dot * w193 - (hinge1_angle_dot * w197 + hinge0_angle_dot * w203 + hinge2_angle_dot * w204)
    w206 = w8 * w153 - w14
    w207 = (w9 * w151 + w1 * w206 + (w13 - w6 * w200)) * bar3_end_z
    w208 = w11 * w156 + w7 * w207 - (w15 * w178 + w12 * w201)
    w209 = w206 * bar2_end_y
    w210 = w207 - w209
    w211 = w8 * w210 - w6 * w127 - (w8 * w128 + w6 * w202)
    w212 = w174 * bar5_end_y
    w213 = w212 - w191
    w214 = w163 * bar4_end_x
    w215 = w19 * w171 + w23 * w214
    w216 = hinge2_angle_dot * w208 - hinge1_angle_dot * w211 + hinge5_angle_dot * w213 - hinge4_angle_dot * w215
    w217 = w210 - w98
    w218 = w123 - w6 * w196
    w219 = w12 * w195 - w45 * w178 + (w11 * w153 + w2 * w207)
    w220 = w171 * bar5_end_y
    w221 = w192 + w220
    w222 = hinge0_angle_dot * w217 - hinge1_angle_dot * w218 + hinge2_angle_dot * w219 - hinge5_angle_dot * w221
    w223 = w19 * w174 - w17 * w214
    w224 = w222 - hinge4_angle_dot * w223
    w225 = (w104 * w190 - (w52 * w205 + w84 * w216 + w97 * w224)) / w136
    w226 = hinge1_angle_dot * w154 + w3 * w225
    w227 = w38 * w123
    w228 = w227 - w83 * w131
    w229 = (w92 * w228 - w80 * w132 - w102 * w145 + w121 * w149) / w136
    w230 = w83 * w133
    w231 = w51 * w123 + w81 * w126 - w230
    w232 = (w80 * w165 + w92 * w231 + w102 * w167 + w121 * w169) / w136
    w233 = w47 * w123 + w81 * w131
    w234 = (w80 * w135 + w92 * w233 + w102 * w159 + w121 * w161) / w136
    w235 = (w135 * w205 + w216 * w233 + w159 * w224 + w161 * w190) / w136
    w236 = w23 * w235 - hinge4_angle_dot * w171
    w237 = (w165 * w205 + w216 * w231 + w167 * w224 + w169 * w190) / w136
    w238 = hinge5_angle_dot * w236 - w74 * w237
    w239 = w17 * w235 + hinge4_angle_dot * w174
    w240 = w27 * w239 + w76 * w179 + (w24 * w237 + hinge5_angle_dot * w172)
    w241 = w21 * w239 + w76 * w175 + (w24 * w236 - w74 * w172)
    w242 = w27 * w236 + w74 * w179 + (hinge5_angle_dot * w175 - w21 * w237)
    w243 = w2 * (hinge5_angle_dot * w240 - w105 * w237 - (w106 * w236 + w74 * w241)) + w107 * w153 - (w12 * (w105 * w239 + w76 * w240 + (w108 * w236 + w74 * w242)) - w109 * w178)
    w244 = (w132 * w205 - w216 * w228 + w145 * w224 - w149 * w190) / w136
    w245 = w2 * w244 + hinge2_angle_dot * w153
    w246 = w60 + w6 * w225
    w247 = w12 * w244 - hinge2_angle_dot * w178
    w248 = w246 + w247
    w249 = w2 * w248 + w69 * w153 - (w12 * w245 - w68 * w178)
    w250 = w8 * w225 - w53
    w251 = w7 * w244 + hinge2_angle_dot * w156
    w252 = w250 - w251
    w253 = w12 * w252 - w71 * w178 + (w7 * w248 + w69 * w156)
    w254 = w243 - (w7 * (hinge5_angle_dot * w242 - w108 * w237 + (w106 * w239 + w76 * w241)) + w110 * w156) + (w27 * (w111 * w245 + w68 * w249 - (w112 * w252 + w71 * w253)) + w113 * w179)
    w255 = w7 * w245 + w68 * w156 + (w2 * w252 + w71 * w153)
    w256 = w254 - (w24 * (w114 * w252 + w71 * w255 + (w111 * w248 + w69 * w249)) - w115 * w172) - (w21 * (w112 * w248 + w69 * w253 + (w114 * w245 + w68 * w255)) + w116 * w175)
    w257 = w256 + (w106 * (2 * -w255) + w117 * w241) - (w108 * (2 * w253) + w118 * w242) + (w105 * (2 * w249) + w120 * w240)
    w258 = hinge0_angle_dot * w250
    w259 = w258 - (hinge0_angle_dot * w251 + (w66 * w250 + w60 * w245))
    w260 = w63 * w250 + w60 * w247 + (w64 * w246 + w53 * w251)
    w261 = hinge0_angle_dot * w246
    w262 = w66 * w246 + w53 * w245 - hinge0_angle_dot * w247 - w261
    w263 = w75 * w188 + w33 * w238 - (w257 + (w87 * w177 + w41 * w259) + (w65 * w184 + w42 * w260) + (w43 * w262 - w67 * w180))
    w264 = hinge5_angle_dot * w239 - w76 * w237
    w265 = w137 * w181 + w185 * w229 - w186 * w232 + w189 * w234 - (w263 - (w77 * w180 + w36 * w264))
    w266 = hinge0_angle_dot * w199 - (w55 * w250 - w60 * w194)
    w267 = w55 * w246 - w53 * w194 + hinge0_angle_dot * w209
    w268 = w58 * w261 + w54 * w209 - (w61 * w258 + w85 * w199) + (w86 * w250 + w60 * w266 - (w59 * w246 + w53 * w267))
    w269 = w15 * w245 - w68 * w201 + (w45 * w252 + w71 * w195)
    w270 = w45 * w248 + w69 * w195 + (w11 * w245 + w68 * w207)
    w271 = w268 + (w11 * w262 + w67 * w207 - (w15 * w259 - w87 * w201)) + (w88 * w252 + w71 * w269 + (w70 * w248 + w69 * w270))
    w272 = w90 * w237 + hinge5_angle_dot * (w29 * w237 + hinge5_angle_dot * w220) + (w19 * w264 - w77 * w214)
    w273 = w49 * w239 + w76 * w191 + (w28 * w236 + w74 * w192)
    w274 = hinge5_angle_dot * w192 - w28 * w237 + (w19 * w239 - w76 * w214)
    w275 = w208 * w229 - w137 * w211 + w213 * w232 + w215 * w234 - (w271 + (w272 + (w91 * w236 + w74 * w273 + (hinge5_angle_dot * w274 - w78 * w237))))
    w276 = w58 * w250 + w60 * w209 + (w61 * w246 + w53 * w199)
    w277 = w99 + (w55 * w261 - w54 * w194) + (hinge0_angle_dot * w267 + (w62 * w250 + w60 * w276)) + (w15 * w260 - w65 * w201 + (w45 * w262 + w67 * w195))
    w278 = w11 * w252 + w71 * w207 - (w15 * w248 - w69 * w201)
    w279 = w19 * w236 - w74 * w214 - (hinge5_angle_dot * w191 - w49 * w237)
    w280 = w49 * w238 + w75 * w191 - (w28 * w264 + w77 * w192) + (w78 * w239 + w76 * w274 + (w79 * w236 + w74 * w279))
    w281 = w193 * w234 + (w137 * w197 + w204 * w229) + (w277 - (w70 * w245 + w68 * w270 + (w72 * w252 + w71 * w278)) - w280)
    w282 = w57 + (w55 * w258 - w85 * w194) - (w62 * w246 + w53 * w276 + hinge0_angle_dot * w266) - (w45 * w259 + w87 * w195 + (w11 * w260 + w65 * w207))
    w283 = hinge5_angle_dot * (hinge5_angle_dot * w212 - w48 * w237) - w101 * w237 + (w19 * w238 - w75 * w214)
    w284 = w282 + (w72 * w248 + w69 * w278 - (w88 * w245 + w68 * w269)) - (w91 * w239 + w76 * w273 - (hinge5_angle_dot * w279 - w79 * w237) - w283)
    w285 = w219 * w229 - w137 * w218 - w221 * w232 + w223 * w234 - w284
    w286 = (w104 * w265 - (w84 * w275 - w52 * w281 + w97 * w285)) / w136
    w287 = hinge0_angle_dot * w155
    w288 = hinge1_angle_dot * w151 + w1 * w225 - (w138 * w200 + w5 * w287)
    w289 = w154 + w244
    w290 = w4 * w151 + w1 * w226 + (w5 * w286 - w137 * w200) - (hinge2_angle_dot * w288 + w139 * w244) - (w140 * w288 + w139 * w289)
    w291 = w290 * c1
    w292 = hinge0_angle_dot**2 * bar1_end_x
    w293 = w153 * gravity_y - w155 * w292
    w294 = w138 * w154 - w3 * w287
    w295 = w286 - w294
    w296 = w5 * w225 - hinge1_angle_dot * w200 - (w138 * w151 - w1 * w287)
    w297 = hinge1_angle_dot * w5 - w1 * w138
    w298 = w140 * w296 + w289 * w297 - (w5 * w226 - w4 * w200 - (w137 * w151 + w1 * w286) - (hinge2_angle_dot * w296 + w244 * w297))
    w299 = (w293 + w295 * bar2_end_y) * c4 - w298 * c0
    w300 = w0 * w292 + w2 * gravity_y
    w301 = w3 * w138
    w302 = w137 - w301
    w303 = w140 * w297 - (w4 * w5 - w1 * w137 - hinge2_angle_dot * w297)
    w304 = (w300 + w302 * bar2_end_y) * c4 - w303 * c0
    w305 = w0 * (w141 * w151 + w1 * w291 + (w5 * w299 - w200 * w304) + 2 * w226 * c6) - w155 * (w1 * w141 + w5 * w304 + 2 * w4 * c6)
    w306 = (w139**2 + w140**2) * c4
    w307 = hinge1_angle_dot * w138
    w308 = w229 + w307
    w309 = w139 * w297
    w310 = w308 - w309
    w311 = w310 * c4
    w312 = w2 * w292 - w0 * gravity_y - (w3**2 + hinge1_angle_dot**2) * bar2_end_y
    w313 = 2 * w307
    w314 = w313 * bar2_end_y
    w315 = w310 * c0 + (w308 + w309) * c1 - (w5 * w312 + w1 * w314) * c4
    w316 = w138 * w225 - hinge1_angle_dot * w287
    w317 = w316 + (w145 * w285 - (w132 * w281 + w228 * w275) - w149 * w265) / w136
    w318 = w139 * w296 + w288 * w297
    w319 = w317 - w318
    w320 = w5 * ((w288 * (2 * w139) + w289 * (2 * w140)) * c4) - w200 * w306 + (w151 * w311 + w1 * (w319 * c4))
    w321 = w5 * (w153 * w292 + w155 * gravity_y - (w154 * (2 * w3) + w225 * (2 * hinge1_angle_dot)) * bar2_end_y)
    w322 = 2 * w316
    w323 = w319 * c0 + (w317 + w318) * c1 - (w321 - w200 * w312 + (w151 * w314 + w1 * (w322 * bar2_end_y))) * c4
    w324 = w153 * ((w5 * w306 + w1 * w311) * bar2_end_y - w315 - w313 * c5) + w2 * (w320 * bar2_end_y - w323 - w322 * c5)
    w325 = w37 * w50 - w26 * w40
    w326 = w20 * w50 - w30 * w40
    w327 = w39 - w46 * w325 + w44 * w326
    w328 = w5 * w141 - w1 * w304 - w303 * c23 + (w300 * c8 + (w302 * c5 + (w137 + w301) * c6))
    w329 = w44 * w129 + w16 * w125
    w330 = w16 * w124 - w46 * w129
    w331 = w18 * hinge5_angle_dot
    w332 = w27 * hinge5_angle_dot
    w333 = w331 * w332
    w334 = w23 * gravity_y - hinge5_angle_dot**2 * bar5_end_y
    w335 = (w234 + w333) * c15 - (w333 - w234) * c16 - w18 * w334 * c14
    w336 = w315 * (w124 * w325 - w130 + w125 * w326) - w327 * w328 - (w134 + w30 * w329 + w26 * w330) * w335
    w337 = hinge4_angle_dot * w332
    w338 = (w337 + (w337 - w18 * w232)) * c16
    w339 = w17 * gravity_y
    w340 = hinge4_angle_dot * w331
    w341 = w340 + (w340 + w27 * w232)
    w342 = (w339 - w232 * bar5_end_y) * c14 - w341 * c15
    w343 = w18 * w338 + w27 * w342 - w341 * c18 + (w339 * c25 - w232 * c20)
    w344 = w26 * w83
    w345 = w30 * w83
    w346 = w46 * w344 - w82 - w44 * w345
    w347 = w94 + (w16 * w344 - w81 * w325)
    w348 = w103 + (w16 * w345 - w81 * w326)
    w349 = w123 * w327 + w129 * w346 - w124 * w347 - w125 * w348
    w350 = (w336 + (w164 + w20 * w329 + w37 * w330) * w343) / w349
    w351 = w44 * w123 + w81 * w125
    w352 = w315 * (w142 + (w123 * w325 - w129 * w344)) - w328 * w347 - w335 * (w158 + w50 * w351) + w343 * (w166 + (w83 * w329 + w40 * w351))
    w353 = w352 / w349
    w354 = w46 * w123 - w81 * w124
    w355 = w328 * w348 - w315 * (w123 * w326 - w129 * w345 - w148) + w335 * (w160 + w50 * w354) + w343 * (w83 * w330 - w40 * w354 - w168)
    w356 = w355 / w349
    w357 = w328 * w346 - w315 * (w227 - w124 * w344 - w125 * w345) - w335 * (w30 * w351 - w26 * w354) + w343 * (w20 * w351 - w230 - w37 * w354)
    w358 = w357 / w349
    w359 = w5 * w291 - w141 * w200 - (w151 * w304 + w1 * w299) - w298 * c23 + (w293 * c8 + (w295 * c5 + (w286 + w294) * c6))
    w360 = w305 + w324 + (w322 * c8 - w320) * bar1_end_x + w203 * w350 - w217 * w353 - w184 * w356 + w152 * (w211 * w358 - (w359 - w197 * w350) + w218 * w353 - w181 * w356)
    w361 = hinge5_angle_dot * w179 - w27 * w237
    w362 = hinge5_angle_dot * w163 + w18 * w237
    w363 = w331 * w361 - w332 * w362
    w364 = (w233 * w275 - w135 * w281 + w159 * w285 + w161 * w265) / w136
    w365 = (w363 - w364) * c15 - (w363 + w364) * c16 - (w18 * (w237 * (2 * hinge5_angle_dot) * bar5_end_y - w171 * gravity_y) - w163 * w334) * c14
    w366 = w360 + w150 * (w204 * w350 - w323 - w208 * w358 - w219 * w353 - w185 * w356) + w162 * (w365 - w193 * w350 + w215 * w358 + w223 * w353 + w189 * w356)
    w367 = hinge4_angle_dot * w361 + w235 * w332
    w368 = (w231 * w275 - w165 * w281 + w167 * w285 + w169 * w265) / w136
    w369 = w174 * gravity_y
    w370 = w235 * w331 - hinge4_angle_dot * w362
    w371 = w370 + (w370 + (w179 * w232 - w27 * w368))
    w372 = w18 * ((w367 + (w367 + (w163 * w232 + w18 * w368))) * c16) - w163 * w338 + (w179 * w342 + w27 * ((w369 + w368 * bar5_end_y) * c14 - w371 * c15))
    w373 = w366 + w170 * (w372 - w371 * c18 + (w369 * c25 + w368 * c20) - w213 * w358 + w221 * w353 + w186 * w356)
    # outputs
    dQ_hat_dq_i = ca.vertcat(w373)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    610 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    hinge1_angle_dot = q_d_dot[35]
    hinge2_angle_dot = q_d_dot[36]
    hinge4_angle_dot = q_d_dot[37]
    hinge5_angle_dot = q_d_dot[38]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c23 = c[23]
    c107 = c[107]
    c108 = c[108]
    # intermediate terms (161)
    w0 = ca.cos(hinge1_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.sin(hinge1_angle)
    w3 = w2 * hinge0_angle_dot
    w4 = ca.sin(hinge0_angle)
    w5 = w0 * w4
    w6 = ca.cos(hinge0_angle)
    w7 = w2 * w6
    w8 = ca.cos(hinge2_angle)
    w9 = w4 * w8
    w10 = (w1 * w7 + w9) * bar3_end_z
    w11 = w0 * w6
    w12 = w6 * w8
    w13 = w2 * w4
    w14 = (w12 - w1 * w13) * bar3_end_z
    w15 = w5 * w10 + w11 * w14
    w16 = ca.sin(hinge5_angle)
    w17 = ca.cos(hinge4_angle)
    w18 = w17 * bar4_end_x
    w19 = w16 * w18
    w20 = w16 * w17
    w21 = w2 * w20
    w22 = ca.cos(hinge5_angle)
    w23 = w17 * w22
    w24 = w5 * w23
    w25 = w21 - w24
    w26 = ca.sin(hinge4_angle)
    w27 = w22 * w26 * bar4_end_x
    w28 = w27 - w22 * bar5_end_y
    w29 = w5 * w26
    w30 = w11 * w20
    w31 = w29 - w30
    w32 = w2 * w26
    w33 = w11 * w23
    w34 = w32 - w33
    w35 = w16 * w31 + w22 * w34
    w36 = w19 * w25 - w28 * w35
    w37 = w18 * w22
    w38 = w24 - w21
    w39 = w30 - w29
    w40 = w33 - w32
    w41 = w11 * w38 + w2 * w39 - w5 * w40
    w42 = w0 * w1
    w43 = w42 * bar3_end_z
    w44 = w11 * w43 + w2 * w10
    w45 = w28 * w41 - w25 * w44
    w46 = w16 * w26 * bar4_end_x
    w47 = w16 * bar5_end_y - w46
    w48 = w19 * w41 - w35 * w44
    w49 = w15 * w36 - w37 * w45 + w47 * w48
    w50 = w14 + w13 * bar2_end_y
    w51 = w4 * bar1_end_x
    w52 = w50 - w51
    w53 = w26 * bar4_end_x
    w54 = w47 * w53
    w55 = w2 * w14 - w5 * w43
    w56 = w47 * w55
    w57 = w37 * w55 + w15 * w53
    w58 = w41 * w54 - w35 * w56 + w25 * w57
    w59 = w6 * bar1_end_x
    w60 = w10 - w7 * bar2_end_y
    w61 = w59 + w60
    w62 = w44 * w54 - w19 * w56 + w28 * w57
    w63 = w0 * bar2_end_y - w43
    w64 = w6 * w63
    w65 = w4 * w63
    w66 = w4 * w38 + w6 * w40
    w67 = w35 * w65 + w19 * w66
    w68 = w6 * w60 - w4 * w50
    w69 = w25 * w65 + w28 * w66
    w70 = w47 * w67 - (w36 * w68 + w37 * w69)
    w71 = w41 * w65 + w44 * w66
    w72 = w45 * w68 + w15 * w69 + w47 * w71
    w73 = w49 * w64 + w55 * w70 - w53 * w72
    w74 = (w49 * w52 - w58 * w61 + w39 * w62) / w73
    w75 = hinge1_angle_dot * w2 + w3 * w74
    w76 = w2 * w74
    w77 = w11 - w4 * w76
    w78 = w47 * w64
    w79 = w15 * w64 - w55 * w68
    w80 = w56 * w66 + w41 * w78 + w25 * w79
    w81 = w56 * w65 - w44 * w78 - w28 * w79
    w82 = (w61 * w80 - w52 * w72 + w39 * w81) / w73
    w83 = w26 * w82
    w84 = w48 * w68 + w15 * w67 + w37 * w71
    w85 = w37 * w64 + w53 * w68
    w86 = w57 * w66 + w41 * w85 + w35 * w79
    w87 = w57 * w65 - w44 * w85 - w19 * w79
    w88 = (w52 * w84 - w61 * w86 - w39 * w87) / w73
    w89 = w16 * w88
    w90 = w22 * w83 + w17 * w89
    w91 = w23 * w77 - w5 * w90
    w92 = w0 * w74
    w93 = w22 * w88
    w94 = w17 * w93 - w16 * w83
    w95 = w20 * w92 + w2 * w94
    w96 = w91 - w95
    w97 = w5 + w6 * w76
    w98 = w17 * w82
    w99 = w23 * w97 + w11 * w90 + (w26 * w92 + w2 * w98)
    w100 = w11 * w94 - w20 * w97
    w101 = w26 * w77 + w5 * w98
    w102 = w100 - w101
    w103 = hinge1_angle_dot * (w4 * w96 + w6 * w38 - (w6 * w99 + w4 * w40)) + hinge2_angle_dot * (w11 * w96 - w38 * w97 + (w2 * w102 + w39 * w92) - (w40 * w77 - w5 * w99))
    w104 = w103 + hinge0_angle_dot * w102 - hinge5_angle_dot * (w95 - w91) - hinge4_angle_dot * (w16 * (w101 - w100) + w31 * w93 + (w22 * w99 - w34 * w89))
    w105 = (w16 * w98 + w26 * w93) * bar4_end_x
    w106 = (w22 * w98 - w26 * w89) * bar4_end_x
    w107 = w54 * w66 + w35 * w78 - w25 * w85
    w108 = w19 * w78 - w54 * w65 - w28 * w85
    w109 = (w61 * w107 - w52 * w70 - w39 * w108) / w73
    w110 = w8 * w109
    w111 = (w0 * w110 - w1 * w76) * bar3_end_z
    w112 = w76 * bar2_end_y + w111
    w113 = w7 + w4 * w92
    w114 = w1 * w109
    w115 = (w9 + w6 * w114 + (w13 * w110 + w1 * w113)) * bar3_end_z
    w116 = w113 * bar2_end_y - w115
    w117 = hinge1_angle_dot * (w65 + w6 * w112) + hinge0_angle_dot * (w116 - w59) + hinge2_angle_dot * (w14 * w92 - w2 * w115 - (w43 * w77 + w5 * w111))
    w118 = hinge4_angle_dot * (w46 * w93 + w16 * w105 + (w22 * w106 - w27 * w89)) - w117
    w119 = w6 * w92 - w13
    w120 = (w7 * w110 + w1 * w119 + (w12 - w4 * w114)) * bar3_end_z
    w121 = w120 - w119 * bar2_end_y
    w122 = hinge2_angle_dot * (w10 * w77 + w5 * w120 - (w14 * w97 + w11 * w115)) - hinge1_angle_dot * (w6 * w121 - w4 * w60 - (w6 * w50 + w4 * w116))
    w123 = w83 * bar4_end_x
    w124 = w122 + hinge5_angle_dot * (w93 * bar5_end_y - w105) - hinge4_angle_dot * (w18 * w89 + w22 * w123)
    w125 = hinge0_angle_dot * (w121 - w51) - hinge1_angle_dot * (w64 - w4 * w112) + hinge2_angle_dot * (w11 * w111 - w43 * w97 + (w10 * w92 + w2 * w120))
    w126 = w125 - hinge5_angle_dot * (w106 + w89 * bar5_end_y) - hinge4_angle_dot * (w18 * w93 - w16 * w123)
    w127 = 2 * ((w62 * w104 - (w49 * w118 + (w36 * w55 + w45 * w53) * w124 + w58 * w126)) / w73)
    w128 = w0 * w8 + w1 * w74
    w129 = w0 * hinge0_angle_dot
    w130 = w8 * w129 + w1 * hinge1_angle_dot
    w131 = w3 + hinge2_angle_dot
    w132 = w2 + w109
    w133 = (w1 * w75 + w8 * w127 - (hinge2_angle_dot * w128 + w109 * w130) - (w128 * w131 + w130 * w132)) * c1
    w134 = 2 * hinge0_angle_dot * bar1_end_x
    w135 = w0 * w134
    w136 = hinge0_angle_dot * (w0 * w2) * c107
    w137 = w127 - w136
    w138 = w8 * w74 - w42
    w139 = hinge1_angle_dot * w8 - w1 * w129
    w140 = w131 * w138 + w132 * w139 - (w8 * w75 - w1 * w127 - (hinge2_angle_dot * w138 + w109 * w139))
    w141 = (w135 + w137 * bar2_end_y) * c4 - w140 * c0
    w142 = w0 * hinge1_angle_dot + w74 * w129
    w143 = w142 + 2 * ((w70 * w118 - w124 * (w36 * w64 - w53 * w69) + w107 * w126 - w104 * w108) / w73)
    w144 = w130 * w138 + w128 * w139
    w145 = w143 - w144
    w146 = w8 * ((w128 * (2 * w130) + w132 * (2 * w131)) * c4) + w1 * (w145 * c4)
    w147 = 2 * w142
    w148 = w8 * (w2 * w134 - (w2 * (2 * w3) + w74 * (2 * hinge1_angle_dot)) * bar2_end_y) + w1 * (w147 * bar2_end_y)
    w149 = w145 * c0 + (w143 + w144) * c1 - w148 * c4
    w150 = w0 * (w1 * w133 + w8 * w141 + 2 * w75 * c6) + w2 * (w146 * bar2_end_y - w149 - w147 * c5) + (w147 * c8 - w146) * bar1_end_x
    w151 = w150 - w74 * (w8 * w133 - w1 * w141 - w140 * c23 + (w135 * c8 + (w137 * c5 + (w127 + w136) * c6)))
    w152 = hinge5_angle_dot * (w88 * (w17 * w26)) * c107
    w153 = 2 * ((w72 * w118 + w124 * (w45 * w64 + w55 * w69) + w80 * w126 + w81 * w104) / w73)
    w154 = (w152 - w153) * c15 - (w152 + w153) * c16 + w17 * (w88 * (2 * hinge5_angle_dot) * bar5_end_y) * c14
    w155 = hinge4_angle_dot * (w26 * w88) + w82 * (w26 * hinge5_angle_dot)
    w156 = (w84 * w118 + w124 * (w48 * w64 + w55 * w67 - w53 * w71) + w86 * w126 + w87 * w104) / w73
    w157 = 2 * -w156
    w158 = hinge4_angle_dot * (w17 * w88) + w82 * (w17 * hinge5_angle_dot)
    w159 = w158 + (w158 + w26 * w157)
    w160 = w17 * ((w155 + (w155 - w17 * w157)) * c16) - w26 * (w157 * c18 + w159 * c15) - w159 * c18 - w156 * c108
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w151 - w109 * w149 + w82 * w154 + w88 * w160)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 109) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1788 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 109)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    hinge1_angle_dot = q_d_dot[35]
    hinge2_angle_dot = q_d_dot[36]
    hinge4_angle_dot = q_d_dot[37]
    hinge5_angle_dot = q_d_dot[38]
    hinge0_angle_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c23 = c[23]
    gravity_y = c[24]
    c25 = c[25]
    c107 = c[107]
    c108 = c[108]
    # intermediate terms (416)
    w0 = ca.sin(hinge0_angle)
    w1 = ca.cos(hinge1_angle)
    w2 = w1 * bar2_end_y
    w3 = ca.sin(hinge2_angle)
    w4 = w1 * w3
    w5 = w4 * bar3_end_z
    w6 = w2 - w5
    w7 = w0 * w6
    w8 = w0 * w1
    w9 = ca.sin(hinge4_angle)
    w10 = w8 * w9
    w11 = ca.cos(hinge0_angle)
    w12 = w1 * w11
    w13 = ca.cos(hinge4_angle)
    w14 = ca.sin(hinge5_angle)
    w15 = w13 * w14
    w16 = w12 * w15
    w17 = w10 - w16
    w18 = ca.sin(hinge1_angle)
    w19 = w9 * w18
    w20 = ca.cos(hinge5_angle)
    w21 = w13 * w20
    w22 = w12 * w21
    w23 = w19 - w22
    w24 = w14 * w17 + w20 * w23
    w25 = w14 * bar5_end_y
    w26 = w9 * w14 * bar4_end_x
    w27 = w25 - w26
    w28 = w13 * bar4_end_x
    w29 = w20 * w28
    w30 = w15 * w18
    w31 = w8 * w21
    w32 = w30 - w31
    w33 = w24 * w27 - w29 * w32
    w34 = w11 * w18
    w35 = ca.cos(hinge2_angle)
    w36 = w0 * w35
    w37 = (w3 * w34 + w36) * bar3_end_z
    w38 = w34 * bar2_end_y
    w39 = w37 - w38
    w40 = w0 * w18
    w41 = w40 * bar2_end_y
    w42 = w11 * w35
    w43 = (w42 - w3 * w40) * bar3_end_z
    w44 = w41 + w43
    w45 = w11 * w39 - w0 * w44
    w46 = w14 * w28
    w47 = w9 * w20 * bar4_end_x
    w48 = w20 * bar5_end_y
    w49 = w47 - w48
    w50 = w32 * w46 - w24 * w49
    w51 = w45 * w50
    w52 = w31 - w30
    w53 = w22 - w19
    w54 = w0 * w52 + w11 * w53
    w55 = w27 * w46 - w29 * w49
    w56 = w1 * hinge0_angle_dot
    w57 = w56 * hinge1_angle_dot
    w58 = w18 * hinge0_angle_ddot + w57
    w59 = w6 * w11
    w60 = w50 * w59
    w61 = w9 * bar4_end_x
    w62 = w7 * w32 + w49 * w54
    w63 = w60 - w61 * w62
    w64 = w0 * hinge1_angle_dot
    w65 = hinge0_angle_dot * w64
    w66 = w11 * hinge1_angle_dot
    w67 = hinge0_angle_dot * w66
    w68 = w41 * hinge0_angle_dot - w2 * w66
    w69 = w2 * w64 + w38 * hinge0_angle_dot
    w70 = w18 * hinge2_angle_dot
    w71 = w12 * hinge2_angle_dot
    w72 = w64 * w70 - hinge0_angle_dot * w71 - w65
    w73 = w8 * hinge2_angle_dot
    w74 = w67 - (hinge0_angle_dot * w73 + w66 * w70)
    w75 = w66 - w73
    w76 = hinge0_angle_dot + w70
    w77 = w43 * w76 + w5 * w75
    w78 = w64 + w71
    w79 = w5 * w78 + w37 * w76
    w80 = w38 * w65 - w41 * w67 + (w66 * w68 - w64 * w69) + (w37 * w72 - w43 * w74) + (w75 * w77 + w78 * w79)
    w81 = w48 * hinge5_angle_dot
    w82 = w14 * hinge4_angle_dot
    w83 = hinge5_angle_dot * w82
    w84 = w20 * hinge4_angle_dot
    w85 = w9 * hinge4_angle_dot * bar4_end_x
    w86 = w47 * hinge5_angle_dot + w28 * w82
    w87 = w80 - (hinge5_angle_dot * w81 - w28 * w83 - (w84 * w85 + hinge5_angle_dot * w86))
    w88 = w7 * w24 + w46 * w54
    w89 = w27 * w88 - (w51 + w29 * w62)
    w90 = w11 * bar1_end_x
    w91 = hinge0_angle_dot * (hinge0_angle_dot * w90)
    w92 = w18 * hinge1_angle_dot
    w93 = w92 * bar2_end_y
    w94 = w1 * hinge1_angle_dot
    w95 = hinge2_angle_dot * w94
    w96 = w37 * w75 - w43 * w78
    w97 = w2 * w65 - w91 + (hinge0_angle_dot * w69 + w66 * w93) + (w43 * w95 + w5 * w72) - (w76 * w79 + w75 * w96)
    w98 = hinge5_angle_dot * w84
    w99 = w28 * w84 - w26 * hinge5_angle_dot
    w100 = w97 - (w26 * w98 - w47 * w83 + (w82 * w86 + w84 * w99))
    w101 = w27 * w61
    w102 = w54 * w101
    w103 = w27 * w59
    w104 = w29 * w59 + w45 * w61
    w105 = w102 + w24 * w103 - w32 * w104
    w106 = w0 * bar1_end_x
    w107 = hinge0_angle_dot * (hinge0_angle_dot * w106)
    w108 = w107 + w2 * w67 - (w64 * w93 + hinge0_angle_dot * w68) - (w5 * w74 + w37 * w95) + (w78 * w96 - w76 * w77)
    w109 = w25 * hinge5_angle_dot
    w110 = w108 - (w82 * w85 - hinge5_angle_dot * w99 - (hinge5_angle_dot * w109 + w28 * w98))
    w111 = w7 * w101
    w112 = w46 * w103 - w111 - w49 * w104
    w113 = w9 * w82 - w21 * hinge5_angle_dot
    w114 = w13 * hinge4_angle_dot
    w115 = hinge5_angle_dot * w113 - w84 * w114
    w116 = w9 * w84 + w15 * hinge5_angle_dot
    w117 = w82 * w113 + w84 * w116
    w118 = hinge5_angle_dot * w116 + w82 * w114
    w119 = w18 * w78 - w12 * w76
    w120 = w12 * w75 + w8 * w78
    w121 = w76 * w119 - w75 * w120
    w122 = w8 * w76 + w18 * w75
    w123 = w75 * w122 + w78 * w119
    w124 = w78 * w120 + w76 * w122
    w125 = 2 * -w122
    w126 = 2 * w120
    w127 = w18 * w115 - w12 * w117 - w8 * w118 + w9 * w121 - w21 * w123 - w15 * w124 + w114 * w125 - w116 * w126
    w128 = 2 * w119
    w129 = w16 - w10
    w130 = w17 * w98 - (w127 + w113 * w128 + w52 * w74 + w95 * w129 + w53 * w72) - w23 * w83
    w131 = w8 * w37 + w12 * w43
    w132 = w50 * w131
    w133 = w12 * w52 + w18 * w129 - w8 * w53
    w134 = w5 * w12 + w18 * w37
    w135 = w49 * w133 - w32 * w134
    w136 = w46 * w133 - w24 * w134
    w137 = w132 - w29 * w135 + w27 * w136
    w138 = w18 * w43 - w5 * w8
    w139 = w7 * w133 + w54 * w134
    w140 = w27 * w139
    w141 = w45 * w135 + w62 * w131 + w140
    w142 = w59 * w137 + w89 * w138 - w61 * w141
    w143 = w39 + w90
    w144 = w44 - w106
    w145 = (w105 * w143 - w89 * w144 - w112 * w129) / w142
    w146 = (w63 * w87 - w89 * w100 - w105 * w110 + w112 * w130) / w142 + hinge0_angle_ddot * w145
    w147 = w58 + w146
    w148 = w35 * hinge1_angle_dot - w3 * w56
    w149 = w35 * w56 + w3 * hinge1_angle_dot
    w150 = w148 * w149
    w151 = w147 - w150
    w152 = hinge0_angle_dot**2 * bar1_end_x
    w153 = w18 * hinge0_angle_dot
    w154 = w18 * w152 - w1 * gravity_y - (w153**2 + hinge1_angle_dot**2) * bar2_end_y
    w155 = w57 + w58
    w156 = hinge0_angle_ddot * bar1_end_x
    w157 = w155 * bar2_end_y - w156
    w158 = w151 * c0 + (w147 + w150) * c1 - (w35 * w154 + w3 * w157) * c4
    w159 = w132 - w33 * w134 + w55 * w133
    w160 = w50 * w138
    w161 = w160 + w61 * w135
    w162 = w101 * w133
    w163 = w27 * w138
    w164 = w29 * w138 + w61 * w131
    w165 = w162 - w24 * w163 + w32 * w164
    w166 = w101 * w134
    w167 = w166 - w46 * w163 + w49 * w164
    w168 = (w137 * w144 - w143 * w165 + w129 * w167) / w142
    w169 = (w100 * w137 + w87 * w161 + w110 * w165 - w130 * w167) / w142 + hinge0_angle_ddot * w168
    w170 = hinge1_angle_dot * w153
    w171 = w1 * hinge0_angle_ddot - w170
    w172 = hinge2_angle_dot + w153
    w173 = (w35 * w169 - w3 * w171 - hinge2_angle_dot * w149 - w149 * w172) * c1
    w174 = w1 * w152 + w18 * gravity_y
    w175 = w56 * w153
    w176 = w169 - w175
    w177 = w148 * w172 + (w35 * w171 + w3 * w169 + hinge2_angle_dot * w148)
    w178 = (w174 + w176 * bar2_end_y) * c4 - w177 * c0
    w179 = w35 * w173 - w3 * w178 - w177 * c23 + (w174 * c8 + (w176 * c5 + (w169 + w175) * c6))
    w180 = w45 * w133 + w54 * w131
    w181 = w7 * w131 - w45 * w134
    w182 = w13 * hinge5_angle_dot
    w183 = w9 * hinge5_angle_dot
    w184 = w182 * w183
    w185 = w59 * w131 - w45 * w138
    w186 = w32 * w185
    w187 = w54 * w163 + w103 * w133 + w186
    w188 = w49 * w185
    w189 = w7 * w163 - w103 * w134 - w188
    w190 = (w143 * w187 - w141 * w144 + w129 * w189) / w142
    w191 = w59 * w135 + w62 * w138
    w192 = hinge0_angle_ddot * w190 - (w100 * w141 + w87 * w191 + w110 * w187 + w130 * w189) / w142
    w193 = w20 * gravity_y - hinge5_angle_dot**2 * bar5_end_y
    w194 = (w184 - w192) * c15 - (w184 + w192) * c16 - w13 * w193 * c14
    w195 = w29 * w139
    w196 = hinge4_angle_dot * w183
    w197 = w195 + (w45 * w136 + w88 * w131)
    w198 = w61 * w139
    w199 = w59 * w136 + w88 * w138 - w198
    w200 = w24 * w185
    w201 = w54 * w164 + w104 * w133 + w200
    w202 = w46 * w185
    w203 = w7 * w164 - w104 * w134 - w202
    w204 = (w144 * w197 - w143 * w201 - w129 * w203) / w142
    w205 = (w100 * w197 + w87 * w199 + w110 * w201 + w130 * w203) / w142 + hinge0_angle_ddot * w204
    w206 = (w196 + (w196 - w13 * w205)) * c16
    w207 = w14 * gravity_y
    w208 = hinge4_angle_dot * w182
    w209 = w208 + (w208 + w9 * w205)
    w210 = (w207 - w205 * bar5_end_y) * c14 - w209 * c15
    w211 = w13 * w206 + w9 * w210 - w209 * c18 + (w207 * c25 - w205 * c20)
    w212 = (w7 * w33 - w51 + w54 * w55) * w158 - w159 * w179 - (w140 + w49 * w180 + w32 * w181) * w194 + (w195 + w46 * w180 + w24 * w181) * w211
    w213 = w32 * w61
    w214 = w49 * w61
    w215 = w134 * w213 - w160 - w133 * w214
    w216 = w162 + (w131 * w213 - w33 * w138)
    w217 = w166 + (w131 * w214 - w55 * w138)
    w218 = w59 * w159 + w45 * w215 - w7 * w216 - w54 * w217
    w219 = w212 / w218
    w220 = w1 * w168
    w221 = w34 + w0 * w220
    w222 = w221 * bar2_end_y
    w223 = w3 * w145
    w224 = w35 * w145
    w225 = (w36 + w11 * w223 + (w40 * w224 + w3 * w221)) * bar3_end_z
    w226 = w222 - w225
    w227 = w226 - w90
    w228 = w18 * w168
    w229 = hinge0_angle_dot * w220
    w230 = w12 - w0 * w228
    w231 = w9 * w190
    w232 = w14 * w204
    w233 = w20 * w231 + w13 * w232
    w234 = w21 * w230 - w8 * w233
    w235 = w20 * w204
    w236 = w13 * w235 - w14 * w231
    w237 = w15 * w220 + w18 * w236
    w238 = w234 - w237
    w239 = w8 + w11 * w228
    w240 = w13 * w190
    w241 = w21 * w239 + w12 * w233 + (w9 * w220 + w18 * w240)
    w242 = w0 * w238 + w11 * w52 - (w11 * w241 + w0 * w53)
    w243 = w12 * w236 - w15 * w239
    w244 = w9 * w230 + w8 * w240
    w245 = w243 - w244
    w246 = w12 * w238 - w52 * w239 + (w18 * w245 + w129 * w220) - (w53 * w230 - w8 * w241)
    w247 = w237 - w234
    w248 = hinge1_angle_dot * w242 + hinge2_angle_dot * w246 + hinge0_angle_dot * w245 - hinge5_angle_dot * w247
    w249 = w244 - w243
    w250 = w14 * w249 + w17 * w235 + (w20 * w241 - w23 * w232)
    w251 = w248 - hinge4_angle_dot * w250
    w252 = (w14 * w240 + w9 * w235) * bar4_end_x
    w253 = (w20 * w240 - w9 * w232) * bar4_end_x
    w254 = w26 * w235 + w14 * w252 + (w20 * w253 - w47 * w232)
    w255 = w228 * bar2_end_y
    w256 = (w1 * w224 - w3 * w228) * bar3_end_z
    w257 = w255 + w256
    w258 = w7 + w11 * w257
    w259 = w43 * w220 - w18 * w225 - (w5 * w230 + w8 * w256)
    w260 = hinge4_angle_dot * w254 - (hinge1_angle_dot * w258 + hinge0_angle_dot * w227 + hinge2_angle_dot * w259)
    w261 = w11 * w220 - w40
    w262 = (w34 * w224 + w3 * w261 + (w42 - w0 * w223)) * bar3_end_z
    w263 = w37 * w230 + w8 * w262 - (w43 * w239 + w12 * w225)
    w264 = w261 * bar2_end_y
    w265 = w262 - w264
    w266 = w11 * w265 - w0 * w39 - (w11 * w44 + w0 * w226)
    w267 = w235 * bar5_end_y
    w268 = w267 - w252
    w269 = w231 * bar4_end_x
    w270 = w28 * w232 + w20 * w269
    w271 = hinge2_angle_dot * w263 - hinge1_angle_dot * w266 + hinge5_angle_dot * w268 - hinge4_angle_dot * w270
    w272 = w265 - w106
    w273 = w59 - w0 * w257
    w274 = w12 * w256 - w5 * w239 + (w37 * w220 + w18 * w262)
    w275 = w232 * bar5_end_y
    w276 = w253 + w275
    w277 = hinge0_angle_dot * w272 - hinge1_angle_dot * w273 + hinge2_angle_dot * w274 - hinge5_angle_dot * w276
    w278 = w28 * w235 - w14 * w269
    w279 = w277 - hinge4_angle_dot * w278
    w280 = (w167 * w251 - (w137 * w260 + w161 * w271 + w165 * w279)) / w142
    w281 = hinge1_angle_dot * w229 + w153 * w280
    w282 = hinge0_angle_ddot * w228 + w281
    w283 = (w141 * w260 + w191 * w271 + w187 * w279 + w189 * w251) / w142
    w284 = w20 * w283 - hinge4_angle_dot * w232
    w285 = (w197 * w260 + w199 * w271 + w201 * w279 + w203 * w251) / w142
    w286 = hinge5_angle_dot * w284 - w84 * w285
    w287 = w14 * w283 + hinge4_angle_dot * w235
    w288 = w9 * w287 + w82 * w240 + (w21 * w285 + hinge5_angle_dot * w233)
    w289 = w15 * w287 + w82 * w236 + (w21 * w284 - w84 * w233)
    w290 = w9 * w284 + w84 * w240 + (hinge5_angle_dot * w236 - w15 * w285)
    w291 = w18 * (hinge5_angle_dot * w288 - w113 * w285 - (w114 * w284 + w84 * w289)) + w115 * w220 - (w12 * (w113 * w287 + w82 * w288 + (w116 * w284 + w84 * w290)) - w117 * w239)
    w292 = (w89 * w260 - w63 * w271 + w105 * w279 - w112 * w251) / w142
    w293 = w18 * w292 + hinge2_angle_dot * w220
    w294 = w66 + w0 * w280
    w295 = w12 * w292 - hinge2_angle_dot * w239
    w296 = w294 + w295
    w297 = w18 * w296 + w78 * w220 - (w12 * w293 - w76 * w239)
    w298 = w11 * w280 - w64
    w299 = w8 * w292 + hinge2_angle_dot * w230
    w300 = w298 - w299
    w301 = w12 * w300 - w75 * w239 + (w8 * w296 + w78 * w230)
    w302 = w291 - (w8 * (hinge5_angle_dot * w290 - w116 * w285 + (w114 * w287 + w82 * w289)) + w118 * w230) + (w9 * (w119 * w293 + w76 * w297 - (w120 * w300 + w75 * w301)) + w121 * w240)
    w303 = w8 * w293 + w76 * w230 + (w18 * w300 + w75 * w220)
    w304 = w302 - (w21 * (w122 * w300 + w75 * w303 + (w119 * w296 + w78 * w297)) - w123 * w233) - (w15 * (w120 * w296 + w78 * w301 + (w122 * w293 + w76 * w303)) + w124 * w236)
    w305 = w304 + (w114 * (2 * -w303) + w125 * w289) - (w116 * (2 * w301) + w126 * w290) + (w113 * (2 * w297) + w128 * w288)
    w306 = hinge0_angle_dot * w298
    w307 = w306 - (hinge0_angle_dot * w299 + (w70 * w298 + w66 * w293))
    w308 = w71 * w298 + w66 * w295 + (w73 * w294 + w64 * w299)
    w309 = hinge0_angle_dot * w294
    w310 = w70 * w294 + w64 * w293 - hinge0_angle_dot * w295 - w309
    w311 = w98 * w249 + w17 * w286 - (w305 + (w74 * w238 + w52 * w307) + (w95 * w245 + w129 * w308) + (w53 * w310 - w72 * w241))
    w312 = hinge5_angle_dot * w287 - w82 * w285
    w313 = w169 * w242 + w146 * w246 + hinge0_angle_ddot * w245 - w205 * w247 - w192 * w250 - (w311 - (w83 * w241 + w23 * w312))
    w314 = w2 * w294 - w64 * w255 + hinge0_angle_dot * w264
    w315 = w38 * w298 + w66 * w264 + (w41 * w294 + w64 * w222)
    w316 = w107 + (w2 * w309 - w65 * w255) + (hinge0_angle_dot * w314 + (w93 * w298 + w66 * w315)) + (w43 * w308 - w95 * w225 + (w5 * w310 + w72 * w256))
    w317 = w5 * w296 + w78 * w256 + (w37 * w293 + w76 * w262)
    w318 = w37 * w300 + w75 * w262 - (w43 * w296 - w78 * w225)
    w319 = hinge5_angle_dot * w253 - w47 * w285 + (w28 * w287 - w82 * w269)
    w320 = w28 * w284 - w84 * w269 - (hinge5_angle_dot * w252 - w26 * w285)
    w321 = w26 * w286 + w98 * w252 - (w47 * w312 + w83 * w253) + (w86 * w287 + w82 * w319 + (w99 * w284 + w84 * w320))
    w322 = w192 * w254 - (w169 * w258 + hinge0_angle_ddot * w227 + w146 * w259) - (w316 - (w79 * w293 + w76 * w317 + (w96 * w300 + w75 * w318)) - w321)
    w323 = hinge0_angle_dot * w222 - (w2 * w298 - w66 * w255)
    w324 = w38 * w309 + w65 * w264 - (w41 * w306 + w67 * w222) + (w68 * w298 + w66 * w323 - (w69 * w294 + w64 * w314))
    w325 = w43 * w293 - w76 * w225 + (w5 * w300 + w75 * w256)
    w326 = w324 + (w37 * w310 + w72 * w262 - (w43 * w307 - w74 * w225)) + (w77 * w300 + w75 * w325 + (w79 * w296 + w78 * w317))
    w327 = w81 * w285 + hinge5_angle_dot * (w48 * w285 + hinge5_angle_dot * w275) + (w28 * w312 - w83 * w269)
    w328 = w26 * w287 + w82 * w252 + (w47 * w284 + w84 * w253)
    w329 = w146 * w263 - w169 * w266 + w205 * w268 - w192 * w270 - (w326 + (w327 + (w85 * w284 + w84 * w328 + (hinge5_angle_dot * w319 - w86 * w285))))
    w330 = w91 + (w2 * w306 - w67 * w255) - (w93 * w294 + w64 * w315 + hinge0_angle_dot * w323) - (w5 * w307 + w74 * w256 + (w37 * w308 + w95 * w262))
    w331 = hinge5_angle_dot * (hinge5_angle_dot * w267 - w25 * w285) - w109 * w285 + (w28 * w286 - w98 * w269)
    w332 = w330 + (w96 * w296 + w78 * w318 - (w77 * w293 + w76 * w325)) - (w85 * w287 + w82 * w328 - (hinge5_angle_dot * w320 - w99 * w285) - w331)
    w333 = hinge0_angle_ddot * w272 - w169 * w273 + w146 * w274 - w205 * w276 - w192 * w278 - w332
    w334 = (w167 * w313 - (w137 * w322 + w161 * w329 + w165 * w333)) / w142
    w335 = hinge0_angle_dot * w228
    w336 = hinge1_angle_dot * w224 + w3 * w280 - (w56 * w223 + w35 * w335)
    w337 = w229 + w292
    w338 = w35 * w334 - w169 * w223 - (w171 * w224 - w3 * w282) - (hinge2_angle_dot * w336 + w149 * w292) - (w172 * w336 + w149 * w337)
    w339 = w338 * c1
    w340 = w220 * gravity_y - w152 * w228
    w341 = w56 * w229 - w153 * w335
    w342 = w334 - w341
    w343 = w35 * w280 - hinge1_angle_dot * w223 - (w56 * w224 - w3 * w335)
    w344 = w172 * w343 + w148 * w337 + (w169 * w224 + w3 * w334 - (w171 * w223 + w35 * w282) + (hinge2_angle_dot * w343 + w148 * w292))
    w345 = (w340 + w342 * bar2_end_y) * c4 - w344 * c0
    w346 = ((w171 - w170) * c6 - (w3 * w173 + w35 * w178)) * w228 + w1 * ((w281 + w282) * c6 + (w173 * w224 + w3 * w339 + (w35 * w345 - w178 * w223)))
    w347 = (w149**2 + w172**2) * c4
    w348 = w151 * c4
    w349 = 2 * w149
    w350 = 2 * w172
    w351 = w56 * w280 - hinge1_angle_dot * w335
    w352 = hinge0_angle_ddot * w220 + w351
    w353 = w352 + (w89 * w322 - w63 * w329 + w105 * w333 - w112 * w313) / w142
    w354 = w149 * w343 + w148 * w336
    w355 = w353 - w354
    w356 = w35 * ((w336 * w349 + w337 * w350) * c4) - w223 * w347 + (w224 * w348 + w3 * (w355 * c4))
    w357 = 2 * w153
    w358 = 2 * hinge1_angle_dot
    w359 = w351 + w352
    w360 = w35 * (w152 * w220 + w228 * gravity_y - (w229 * w357 + w280 * w358) * bar2_end_y) - w154 * w223 + (w157 * w224 + w3 * (w359 * bar2_end_y))
    w361 = w355 * c0 + (w353 + w354) * c1 - w360 * c4
    w362 = w220 * ((w35 * w347 + w3 * w348) * bar2_end_y - w158 + (w156 * c8 - w155 * c5)) + w18 * (w356 * bar2_end_y - w361 - w359 * c5)
    w363 = w59 * w133 + w54 * w138
    w364 = w158 * (w102 + (w33 * w59 - w45 * w213)) - w179 * w216 - w194 * (w186 + w27 * w363) + w211 * (w200 + (w61 * w180 + w29 * w363))
    w365 = w364 / w218
    w366 = w59 * w134 - w7 * w138
    w367 = w179 * w217 - w158 * (w55 * w59 - w45 * w214 - w111) + w194 * (w188 + w27 * w366) + w211 * (w61 * w181 - w29 * w366 - w202)
    w368 = w367 / w218
    w369 = w179 * w215 - w158 * (w60 - w7 * w213 - w54 * w214) - w194 * (w49 * w363 - w32 * w366) + w211 * (w46 * w363 - w198 - w24 * w366)
    w370 = w369 / w218
    w371 = w35 * w339 - w173 * w223 - (w178 * w224 + w3 * w345) - w344 * c23 + (w340 * c8 + (w342 * c5 + (w334 + w341) * c6))
    w372 = w219 * w227 + (w346 + w362 + (w359 * c8 - w356) * bar1_end_x) - w272 * w365 - w245 * w368 + w168 * (w266 * w370 - (w371 - w219 * w258) + w273 * w365 - w242 * w368)
    w373 = hinge5_angle_dot * w240 - w9 * w285
    w374 = hinge5_angle_dot * w231 + w13 * w285
    w375 = w182 * w373 - w183 * w374
    w376 = (w141 * w322 + w191 * w329 + w187 * w333 + w189 * w313) / w142
    w377 = 2 * hinge5_angle_dot
    w378 = (w375 - w376) * c15 - (w375 + w376) * c16 - (w13 * (w285 * w377 * bar5_end_y - w232 * gravity_y) - w193 * w231) * c14
    w379 = w372 + w145 * (w219 * w259 - w361 - w263 * w370 - w274 * w365 - w246 * w368) + w190 * (w378 - w219 * w254 + w270 * w370 + w278 * w365 + w250 * w368)
    w380 = hinge4_angle_dot * w373 + w183 * w283
    w381 = (w197 * w322 + w199 * w329 + w201 * w333 + w203 * w313) / w142
    w382 = w235 * gravity_y
    w383 = w182 * w283 - hinge4_angle_dot * w374
    w384 = w383 + (w383 + (w205 * w240 - w9 * w381))
    w385 = w13 * ((w380 + (w380 + (w205 * w231 + w13 * w381))) * c16) - w206 * w231 + (w210 * w240 + w9 * ((w382 + w381 * bar5_end_y) * c14 - w384 * c15))
    w386 = w379 + w204 * (w385 - w384 * c18 + (w382 * c25 + w381 * c20) - w268 * w370 + w276 * w365 + w247 * w368)
    w387 = w92 + w153 * w168
    w388 = 2 * w280
    w389 = w1 * w35 + w3 * w168
    w390 = w18 + w145
    w391 = (w35 * w388 + w3 * w387 - (hinge2_angle_dot * w389 + w145 * w149) - (w172 * w389 + w149 * w390)) * c1
    w392 = 2 * hinge0_angle_dot * bar1_end_x
    w393 = w1 * w392
    w394 = hinge0_angle_dot * (w1 * w18) * c107
    w395 = w388 - w394
    w396 = w35 * w168 - w4
    w397 = w172 * w396 + w148 * w390 + (w3 * w388 - w35 * w387 + (hinge2_angle_dot * w396 + w145 * w148))
    w398 = (w393 + w395 * bar2_end_y) * c4 - w397 * c0
    w399 = w94 + w56 * w168
    w400 = w399 + 2 * w292
    w401 = w149 * w396 + w148 * w389
    w402 = w400 - w401
    w403 = w35 * ((w349 * w389 + w350 * w390) * c4) + w3 * (w402 * c4)
    w404 = 2 * w399
    w405 = w402 * c0 + (w400 + w401) * c1 - (w35 * (w18 * w392 - (w18 * w357 + w168 * w358) * bar2_end_y) + w3 * (w404 * bar2_end_y)) * c4
    w406 = w1 * (2 * w387 * c6 + (w3 * w391 + w35 * w398)) + w18 * (w403 * bar2_end_y - w405 - w404 * c5) + (w404 * c8 - w403) * bar1_end_x
    w407 = w406 - w168 * (w35 * w391 - w3 * w398 - w397 * c23 + (w393 * c8 + (w395 * c5 + (w388 + w394) * c6)))
    w408 = w204 * (hinge5_angle_dot * (w9 * w13)) * c107
    w409 = 2 * w283
    w410 = w407 - w145 * w405 + w190 * ((w408 - w409) * c15 - (w408 + w409) * c16 + w13 * (w204 * w377 * bar5_end_y) * c14)
    w411 = hinge4_angle_dot * (w9 * w204) + w183 * w190
    w412 = 2 * -w285
    w413 = hinge4_angle_dot * (w13 * w204) + w182 * w190
    w414 = w413 + (w413 + w9 * w412)
    w415 = w13 * ((w411 + (w411 - w13 * w412)) * c16) - w9 * (w412 * c18 + w414 * c15) - w414 * c18 - w285 * c108
    # outputs
    J_q = ca.vertcat(w386)
    J_v = ca.vertcat(w410 + w204 * w415)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 48) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 48)
    bar1_end_x = p[30]
    bar2_end_y = p[33]
    bar3_end_z = p[38]
    bar4_end_x = p[41]
    bar5_end_y = p[44]
    ground_P5_z = p[47]
    # outputs
    positions = ca.SX(3, 13)
    positions[0, 4] = bar1_end_x
    positions[0, 10] = bar4_end_x
    positions[1, 6] = bar2_end_y
    positions[1, 12] = bar5_end_y
    positions[2, 1] = ground_P5_z
    positions[2, 8] = bar3_end_z
    axes = ca.SX(9, 13)
    axes[0, 0] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 8] = 1.0
    axes[0, 9] = 1.0
    axes[0, 10] = 1.0
    axes[0, 11] = 1.0
    axes[2, 1] = 1.0
    axes[2, 6] = 1.0
    axes[2, 7] = 1.0
    axes[2, 12] = 1.0
    axes[4, 1] = -1.0
    axes[4, 2] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = -1.0
    axes[4, 7] = -1.0
    axes[4, 10] = 1.0
    axes[4, 11] = 1.0
    axes[4, 12] = -1.0
    axes[5, 0] = -1.0
    axes[5, 3] = -1.0
    axes[5, 8] = -1.0
    axes[5, 9] = -1.0
    axes[6, 1] = 1.0
    axes[6, 6] = 1.0
    axes[6, 7] = 1.0
    axes[6, 12] = 1.0
    axes[7, 0] = 1.0
    axes[7, 3] = 1.0
    axes[7, 8] = 1.0
    axes[7, 9] = 1.0
    axes[8, 2] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 10] = 1.0
    axes[8, 11] = 1.0
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
    "measures": measures,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "geometry": geometry,
}
