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
    gives c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    217 operations.
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
    # intermediate terms (64)
    w0 = (bar3_inertia_xx + bar3_inertia_yy + bar3_inertia_zz) / 2.0
    w1 = w0 - bar3_inertia_zz + bar3_mass * bar3_center_of_mass_z**2
    w2 = w0 - bar3_inertia_yy
    w3 = bar3_mass * bar3_center_of_mass_z
    w4 = (bar2_inertia_xx + bar2_inertia_yy + bar2_inertia_zz) / 2.0
    w5 = w4 - bar2_inertia_yy + bar2_mass * bar2_center_of_mass_y**2
    w6 = bar3_mass * bar2_end_y
    w7 = w5 + bar2_end_y * w6
    w8 = w4 - bar2_inertia_xx
    w9 = w0 - bar3_inertia_xx
    w10 = w8 + w9
    w11 = bar2_mass * bar2_center_of_mass_y
    w12 = (bar1_inertia_xx + bar1_inertia_yy + bar1_inertia_zz) / 2.0
    w13 = w12 - bar1_inertia_xx + bar1_mass * bar1_center_of_mass_x**2
    w14 = w12 - bar1_inertia_zz
    w15 = w4 - bar2_inertia_zz
    w16 = bar4_mass * bar4_center_of_mass_x
    w17 = w16 - bar4_end_x * bar4_mass
    w18 = (bar4_inertia_xx + bar4_inertia_yy + bar4_inertia_zz) / 2.0
    w19 = w18 - bar4_inertia_xx + bar4_mass * bar4_center_of_mass_x**2
    w20 = w19 - (bar4_end_x * w16 + bar4_end_x * w17)
    w21 = w18 - bar4_inertia_yy
    w22 = bar5_end_y * w17
    w23 = (bar5_inertia_xx + bar5_inertia_yy + bar5_inertia_zz) / 2.0
    w24 = w23 - bar5_inertia_yy + bar5_mass * bar5_center_of_mass_y**2
    w25 = bar5_mass * bar5_center_of_mass_y
    w26 = bar5_end_y * bar5_mass - w25
    w27 = bar5_end_y * bar4_mass
    w28 = w23 - bar5_inertia_zz
    w29 = w18 - bar4_inertia_zz
    w30 = w1 + w2
    w31 = ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 + ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w32 = bar1_start_quaternion_0_0_0 * ground_P0_quaternion_1_0_0 + ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w33 = bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 + bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w34 = bar3_start_quaternion_1_0_0 * bar2_end_quaternion_3_0_0 + bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w35 = ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 + ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w36 = bar5_end_quaternion_1_0_0 * ground_P5_quaternion_1_0_0 + ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w37 = w12 - bar1_inertia_yy
    w38 = w14 + w37
    w39 = w13 + w14
    w40 = w13 + w37
    w41 = -4.0 * w40
    w42 = -4.0 * w39
    w43 = w5 + w15
    w44 = w8 + w15
    w45 = w5 + w8
    w46 = -4.0 * w45
    w47 = -4.0 * w44
    w48 = w1 + w9
    w49 = w2 + w9
    w50 = -4.0 * w49
    w51 = -4.0 * w48
    w52 = w21 + w29
    w53 = w19 + w29
    w54 = w19 + w21
    w55 = -4.0 * w54
    w56 = -4.0 * w53
    w57 = w24 + w28
    w58 = w23 - bar5_inertia_xx
    w59 = w28 + w58
    w60 = w24 + w58
    w61 = -4.0 * w60
    w62 = -4.0 * w59
    w63 = 2 * bar5_end_y
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w1 - w2,  # c2
        bar2_end_y,  # bar2_end_y
        w3,  # c4
        w7,  # c5
        w10,  # c6
        bar1_end_x,  # bar1_end_x
        w6 + w11,  # c8
        2 * bar1_end_x,  # c9
        w13 + bar1_end_x * (bar1_end_x * (bar3_mass + bar2_mass)) + (w14 + w15),  # c10
        bar3_end_z,  # bar3_end_z
        bar4_end_x,  # bar4_end_x
        bar5_end_y,  # bar5_end_y
        w17,  # c14
        w20,  # c15
        w21,  # c16
        w20 - w21,  # c17
        w22,  # c18
        2 * w22,  # c19
        w24 + (bar5_end_y * w26 - bar5_end_y * w25) + bar5_end_y * w27 + (w28 + w29),  # c20
        w20 + w21,  # c21
        w30,  # c22
        bar2_end_y * w3,  # c23
        gravity_y,  # gravity_y
        w26 + w27,  # c25
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
        w8,  # c51
        w9,  # c52
        w11,  # c53
        bar1_mass,  # bar1_mass
        w13,  # c55
        w14,  # c56
        w15,  # c57
        bar4_mass,  # bar4_mass
        w19,  # c59
        w16,  # c60
        bar5_mass,  # bar5_mass
        w24,  # c62
        w25,  # c63
        w28,  # c64
        w29,  # c65
        bar1_mass * bar1_center_of_mass_x,  # c66
        w37,  # c67
        w38,  # c68
        w39,  # c69
        w40,  # c70
        4.0 * w39 + w41,  # c71
        4.0 * w40 + -4.0 * w38,  # c72
        4.0 * w38 + w42,  # c73
        w42 + 4.0 * w38,  # c74
        4.0 * w40 + -4.0 * w38,  # c75
        w41 + 4.0 * w39,  # c76
        w43,  # c77
        w44,  # c78
        w45,  # c79
        4.0 * w44 + w46,  # c80
        4.0 * w45 + -4.0 * w43,  # c81
        4.0 * w43 + w47,  # c82
        w47 + 4.0 * w43,  # c83
        4.0 * w45 + -4.0 * w43,  # c84
        w46 + 4.0 * w44,  # c85
        w48,  # c86
        w49,  # c87
        4.0 * w48 + w50,  # c88
        4.0 * w49 + -4.0 * w30,  # c89
        4.0 * w30 + w51,  # c90
        w51 + 4.0 * w30,  # c91
        4.0 * w49 + -4.0 * w30,  # c92
        w50 + 4.0 * w48,  # c93
        w52,  # c94
        w53,  # c95
        w54,  # c96
        4.0 * w53 + w55,  # c97
        4.0 * w54 + -4.0 * w52,  # c98
        4.0 * w52 + w56,  # c99
        w56 + 4.0 * w52,  # c100
        4.0 * w54 + -4.0 * w52,  # c101
        w55 + 4.0 * w53,  # c102
        w57,  # c103
        w58,  # c104
        w59,  # c105
        w60,  # c106
        4.0 * w59 + w61,  # c107
        4.0 * w60 + -4.0 * w57,  # c108
        4.0 * w57 + w62,  # c109
        w62 + 4.0 * w57,  # c110
        4.0 * w60 + -4.0 * w57,  # c111
        w61 + 4.0 * w59,  # c112
        bar1_mass * gravity_y,  # c113
        bar2_mass * gravity_y,  # c114
        bar3_mass * gravity_y,  # c115
        bar4_mass * gravity_y,  # c116
        bar5_mass * gravity_y,  # c117
        -w33,  # c118
        -gravity_y,  # c119
        2 * bar3_end_z,  # c120
        4.0 * bar3_end_z,  # c121
        2 * bar2_end_y,  # c122
        w7 - w10,  # c123
        -w63,  # c124
        w63,  # c125
        2.0,  # c126
        2 * bar3_end_z,  # c127
        2 * bar4_end_x,  # c128
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    636 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 129)
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 39) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 4) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    426 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    c = ca.SX.sym("c", 129)
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
    # intermediate terms (123)
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 * c30
    w3 = w1 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w1 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w4 = ca.sin(w0)
    w5 = w4 * c31
    w6 = w4 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w4 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w7 = (1.0 - 2 * w5**2 - 2 * w6**2) * bar1_end_x
    w8 = 2 * w2
    w9 = 2 * w3
    w10 = (w6 * w8 - w5 * w9) * bar1_end_x
    w11 = (w6 * w9 + w5 * w8) * bar1_end_x
    w12 = ca.sin(hinge1_angle)
    w13 = ca.cos(hinge2_angle)
    w14 = ca.cos(hinge0_angle)
    w15 = ca.sin(hinge2_angle)
    w16 = ca.sin(hinge0_angle)
    w17 = w12 * w16
    w18 = (w13 * w14 - w15 * w17) * bar3_end_z
    w19 = ca.cos(hinge1_angle)
    w20 = w16 * w19
    w21 = w15 * w19 * bar3_end_z
    w22 = w12 * w18 - w20 * w21
    w23 = ca.sin(hinge5_angle)
    w24 = ca.cos(hinge4_angle)
    w25 = w24 * bar4_end_x
    w26 = w23 * w25
    w27 = w23 * w24
    w28 = w12 * w27
    w29 = ca.cos(hinge5_angle)
    w30 = w24 * w29
    w31 = w20 * w30
    w32 = w28 - w31
    w33 = ca.sin(hinge4_angle)
    w34 = w29 * w33 * bar4_end_x - w29 * bar5_end_y
    w35 = w20 * w33
    w36 = w14 * w19
    w37 = w27 * w36
    w38 = w12 * w33
    w39 = w30 * w36
    w40 = w23 * (w35 - w37) + w29 * (w38 - w39)
    w41 = w26 * w32 - w34 * w40
    w42 = w33 * bar4_end_x
    w43 = w31 - w28
    w44 = w39 - w38
    w45 = w36 * w43 + w12 * (w37 - w35) - w20 * w44
    w46 = w12 * w14
    w47 = (w15 * w46 + w13 * w16) * bar3_end_z
    w48 = w21 * w36 + w12 * w47
    w49 = w34 * w45 - w32 * w48
    w50 = w19 * bar2_end_y - w21
    w51 = w34 - w50
    w52 = w20 * w47 + w18 * w36
    w53 = w25 * w29
    w54 = w23 * bar5_end_y - w23 * w33 * bar4_end_x
    w55 = w26 * w45 - w40 * w48
    w56 = w41 * w52 - w49 * w53 + w54 * w55
    w57 = w47 - w46 * bar2_end_y
    w58 = w25 + (w14 * bar1_end_x + w57)
    w59 = w42 * w54
    w60 = w22 * w54
    w61 = w22 * w53 + w42 * w52
    w62 = w18 + w17 * bar2_end_y
    w63 = w54 + ground_P5_z - (w62 - w16 * bar1_end_x)
    w64 = w33 * w36 + w12 * w30 + w20 * w27
    w65 = (w22 * w41 + w42 * w49) * w51 - w56 * w58 + (w45 * w59 - w40 * w60 + w32 * w61) * w63 - (w48 * w59 - w26 * w60 + w34 * w61) * w64
    w66 = w14 * w50
    w67 = w16 * w50
    w68 = w16 * w43 + w14 * w44
    w69 = w40 * w67 + w26 * w68
    w70 = w14 * w57 - w16 * w62
    w71 = w32 * w67 + w34 * w68
    w72 = w54 * w69 - (w41 * w70 + w53 * w71)
    w73 = w45 * w67 + w48 * w68
    w74 = w49 * w70 + w52 * w71 + w54 * w73
    w75 = w56 * w66 + w22 * w72 - w42 * w74
    w76 = hinge1_angle - w65 / w75
    w77 = w76 / 2.0
    w78 = ca.cos(w77)
    w79 = ca.sin(w77)
    w80 = w2 * w78 - w6 * w79
    w81 = w3 * w78 - w5 * w79
    w82 = w5 * w78 + w3 * w79
    w83 = -w82
    w84 = w2 * w79 + w6 * w78
    w85 = 2 * w80
    w86 = w54 * w66
    w87 = w53 * w66 + w42 * w70
    w88 = w58 * w72 + w51 * (w41 * w66 - w42 * w71) - w63 * (w59 * w68 + w40 * w86 - w32 * w87) + w64 * (w26 * w86 - w59 * w67 - w34 * w87)
    w89 = hinge2_angle - w88 / w75
    w90 = w89 / 2.0
    w91 = ca.cos(w90)
    w92 = w91 * c37
    w93 = ca.sin(w90)
    w94 = w93 * c38
    w95 = w91 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w91 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w96 = w93 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w93 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w97 = w52 * w66 - w22 * w70
    w98 = w51 * (w55 * w66 + w22 * w69 - w42 * w73) - w58 * (w55 * w70 + w52 * w69 + w53 * w73) + w63 * (w61 * w68 + w45 * w87 + w40 * w97)
    w99 = hinge5_angle - (w98 + w64 * (w61 * w67 - w48 * w87 - w26 * w97)) / w75
    w100 = w99 / 2.0
    w101 = ca.sin(w100)
    w102 = w101 * c43
    w103 = -w102
    w104 = ca.cos(w100)
    w105 = w104 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w104 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w106 = w104 * c44
    w107 = 2 * w106
    w108 = w101 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w101 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w109 = (2 * w103 * w105 - w107 * w108) * bar5_end_y
    w110 = w58 * w74 - w51 * (w49 * w66 + w22 * w71) - w63 * (w60 * w68 + w45 * w86 + w32 * w97) - w64 * (w60 * w67 - w48 * w86 - w34 * w97)
    w111 = hinge4_angle - w110 / w75
    w112 = w111 / 2.0
    w113 = ca.cos(w112)
    w114 = ca.sin(w112)
    w115 = w105 * w113 - w102 * w114
    w116 = w108 * w113 - w106 * w114
    w117 = (1.0 - 2 * w102**2 - 2 * w108**2) * bar5_end_y
    w118 = w106 * w113 + w108 * w114
    w119 = 2 * w118
    w120 = -(w102 * w113 + w105 * w114)
    w121 = 2 * w120
    w122 = ground_P5_z - (w108 * (2 * w105) - w102 * w107) * bar5_end_y
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # bar1.x
        0.0,  # bar1.y
        0.0,  # bar1.z
        w2,  # bar1.e0
        w3,  # bar1.e1
        -w5,  # bar1.e2
        w6,  # bar1.e3
        w7,  # bar2.x
        w10,  # bar2.y
        w11,  # bar2.z
        w80,  # bar2.e0
        w81,  # bar2.e1
        w83,  # bar2.e2
        w84,  # bar2.e3
        w7 - (w82 * (2 * w81) + w84 * w85) * bar2_end_y,  # bar3.x
        w10 + (1.0 - 2 * w81**2 - 2 * w84**2) * bar2_end_y,  # bar3.y
        w11 + (w81 * w85 + w84 * (2 * w83)) * bar2_end_y,  # bar3.z
        w80 * w92 - (w81 * w94 - w82 * w95 + w84 * w96),  # bar3.e0
        w80 * w94 + w81 * w92 - (w82 * w96 + w84 * w95),  # bar3.e1
        w80 * w95 - w82 * w92 + (w84 * w94 - w81 * w96),  # bar3.e2
        w80 * w96 + w84 * w92 + (w81 * w95 + w82 * w94),  # bar3.e3
        (1.0 - 2 * w115**2 - 2 * w116**2) * c45 - w109,  # bar4.x
        (w116 * w119 + w115 * w121) * c45 - w117,  # bar4.y
        w122 - (w116 * w121 - w115 * w119) * bar4_end_x,  # bar4.z
        w118,  # bar4.e0
        w120,  # bar4.e1
        w115,  # bar4.e2
        w116,  # bar4.e3
        -w109,  # bar5.x
        -w117,  # bar5.y
        w122,  # bar5.z
        w106,  # bar5.e0
        w103,  # bar5.e1
        w105,  # bar5.e2
        w108,  # bar5.e3
        w76,  # hinge1.angle
        w89,  # hinge2.angle
        w111,  # hinge4.angle
        w99,  # hinge5.angle
    )
    C_loop = ca.vertcat(
        -w58,  # hinge3.x
        w51,  # hinge3.y
        w63,  # hinge3.z
        w64,  # hinge3.parallel_x
    )
    det_loop = ca.vertcat(w75)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    722 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 129)
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
    w11 = 2 * bar1_e0
    w12 = (bar1_e3 * w10 - w11 * bar1_e2) * bar1_end_x
    w13 = bar1_e2 * -2.0
    w14 = (bar1_e3 * w11 + w10 * bar1_e2) * bar1_end_x
    w15 = bar1_e3 * -2.0
    w16 = w14 * w15
    w17 = w11 * w12
    w18 = bar1_e1 * -2.0
    w19 = w12 * w18
    w20 = w11 * w14
    w21 = w4 * (w9 * w12 - w13 * w14) - w2 * (w12 * w13 - w16) - w6 * (w17 - w10 * w14) + w8 * (w19 - w20)
    w22 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * bar1_end_x
    w23 = w13 * w22
    w24 = w11 * w22
    w25 = 2 * bar1_e2
    w26 = w4 * (w23 - w17) - w2 * (w15 * w22 - w19) - w6 * (w10 * w22 - w12 * w15) + w8 * (w24 - w12 * w25)
    w27 = w4 * (w20 - w9 * w22) - w2 * (w14 * w18 - w23) - w6 * (w16 - w24) + w8 * (w14 * w25 - w18 * w22)
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
    w101 = bar2_e2 * -2.0
    w102 = 2 * bar2_e0
    w103 = 2 * bar2_e2
    w104 = (w102 * bar2_e1 + w103 * bar2_e3) * bar2_end_y
    w105 = bar2_e3 * -2.0
    w106 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * bar2_end_y
    w107 = w105 * w106
    w108 = 2 * bar2_e3
    w109 = w102 * w104
    w110 = 2 * bar2_e1
    w111 = w21 - w97 * (w101 * w104 - w107) + w98 * (w104 * w108 - w101 * w106) - w99 * (w109 - w106 * w110)
    w112 = bar2_e1 * -2.0
    w113 = w104 * w112
    w114 = w102 * w106
    w115 = (bar2_e2 * w110 - w102 * bar2_e3) * bar2_end_y
    w116 = w101 * w115
    w117 = w102 * w115
    w118 = w26 - w97 * (w105 * w115 - w113) + w98 * (w116 - w109) - w99 * (w110 * w115 - w104 * w105) + w100 * (w117 - w103 * w104)
    w119 = w27 - w97 * (w106 * w112 - w116) + w98 * (w114 - w108 * w115) - w99 * (w107 - w117) + w100 * (w103 * w106 - w112 * w115)
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
    w143 = 2 * bar4_e0
    w144 = (bar4_e3 * w142 - w143 * bar4_e2) * bar4_end_x
    w145 = bar4_e2 * -2.0
    w146 = (bar4_e3 * w143 + w142 * bar4_e2) * bar4_end_x
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
    w164 = bar4_e3 * -2.0
    w165 = w146 * w164
    w166 = w150 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w150 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w167 = w153 * w166
    w168 = w153 * (w156 * c44)
    w169 = w155 * w167 - w148 * w168 + w162 * (w160 * bar5_e3 - w159 * bar5_e0)
    w170 = w143 * w144
    w171 = w148 * w158 - w154 * w155 + w162 * (bar5_e1 * w160 - w159 * bar5_e2)
    w172 = bar4_e1 * -2.0
    w173 = w144 * w172
    w174 = w143 * w146
    w175 = w155 * w168 + w148 * w167 - w162 * (w160 * bar5_e0 + w159 * bar5_e3)
    w176 = (w141 * w144 - w145 * w146) * w163 - (w144 * w145 - w165) * w169 - (w170 - w142 * w146) * w171 - (w173 - w174) * w175
    w177 = bar5_e2 * -2.0
    w178 = 2 * bar5_e0
    w179 = 2 * bar5_e2
    w180 = (bar5_e1 * w178 + bar5_e3 * w179) * bar5_end_y
    w181 = bar5_e3 * -2.0
    w182 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * bar5_end_y
    w183 = w181 * w182
    w184 = 2 * bar5_e3
    w185 = w178 * w180
    w186 = 2 * bar5_e1
    w187 = bar5_e1 * -2.0
    w188 = w180 * w187
    w189 = w178 * w182
    w190 = w168 * (w177 * w180 - w183) + w154 * (w180 * w184 - w177 * w182) - w158 * (w185 - w182 * w186) - w167 * (w188 - w189)
    w191 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * bar4_end_x
    w192 = w145 * w191
    w193 = w143 * w191
    w194 = 2 * bar4_e2
    w195 = w163 * (w192 - w170) - w169 * (w164 * w191 - w173) - w171 * (w142 * w191 - w144 * w164) - w175 * (w193 - w144 * w194)
    w196 = (bar5_e2 * w186 - bar5_e3 * w178) * bar5_end_y
    w197 = w177 * w196
    w198 = w178 * w196
    w199 = w168 * (w181 * w196 - w188) + w154 * (w197 - w185) - w158 * (w186 * w196 - w180 * w181) - w167 * (w198 - w179 * w180)
    w200 = w163 * (w174 - w141 * w191) - w169 * (w146 * w172 - w192) - w171 * (w165 - w193) - w175 * (w146 * w194 - w172 * w191)
    w201 = w168 * (w182 * w187 - w197) + w154 * (w189 - w184 * w196) - w158 * (w183 - w198) - w167 * (w179 * w182 - w187 * w196)
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # bar1.x
        0.0,  # bar1.y
        0.0,  # bar1.z
        -w2,  # bar1.e0
        w4,  # bar1.e1
        -w6,  # bar1.e2
        w8,  # bar1.e3
        w21,  # bar2.x
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
        w176 + w190,  # bar4.x
        w195 + w199,  # bar4.y
        w200 + w201,  # bar4.z
        w169,  # bar4.e0
        -w163,  # bar4.e1
        w171,  # bar4.e2
        w175,  # bar4.e3
        w190,  # bar5.x
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 39) [mixed]: accelerations of the dependent coordinates
    1346 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 129)
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
    w16 = bar1_e2 * -2.0
    w17 = 2 * bar1_e3
    w18 = 2 * bar1_e0
    w19 = bar1_e1 * -2.0
    w20 = bar1_e0_dot * w16 + bar1_e1_dot * w17 + bar1_e2_dot * w18 + bar1_e3_dot * w19
    w21 = bar1_e3 * -2.0
    w22 = 2 * bar1_e2
    w23 = bar1_e0_dot * w19 + bar1_e1_dot * w18 + bar1_e2_dot * w21 + bar1_e3_dot * w22
    w24 = 2 * bar1_e1
    w25 = (bar1_e3 * w18 + bar1_e2 * w24) * bar1_end_x
    w26 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * bar1_end_x
    w27 = w23 * w25 - w20 * w26
    w28 = bar1_e0_dot * w21 + w16 * bar1_e1_dot + bar1_e2_dot * w24 + w18 * bar1_e3_dot
    w29 = (bar1_e3 * w24 - bar1_e2 * w18) * bar1_end_x
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
    w181 = bar2_e2 * -2.0
    w182 = 2 * bar2_e3
    w183 = 2 * bar2_e0
    w184 = bar2_e1 * -2.0
    w185 = bar2_e0_dot * w181 + bar2_e1_dot * w182 + bar2_e2_dot * w183 + bar2_e3_dot * w184
    w186 = bar2_e3 * -2.0
    w187 = 2 * bar2_e2
    w188 = bar2_e0_dot * w184 + bar2_e1_dot * w183 + bar2_e2_dot * w186 + bar2_e3_dot * w187
    w189 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * bar2_end_y
    w190 = 2 * bar2_e1
    w191 = (bar2_e2 * w190 - bar2_e3 * w183) * bar2_end_y
    w192 = w188 * w189 - w185 * w191
    w193 = bar2_e0_dot * w186 + w181 * bar2_e1_dot + bar2_e2_dot * w190 + w183 * bar2_e3_dot
    w194 = (w183 * bar2_e1 + bar2_e3 * w187) * bar2_end_y
    w195 = w191 * w193 - w188 * w194
    w196 = w186 * w189
    w197 = w36 + (w185 * w192 - w193 * w195) + w174 * (w181 * w194 - w196) + w176 * (w182 * w194 - w181 * w189)
    w198 = w183 * w194
    w199 = w184 * w194
    w200 = w183 * w189
    w201 = w185 * w194 - w189 * w193
    w202 = w181 * w191
    w203 = w41 + (w193 * w201 - w188 * w192) + w174 * (w186 * w191 - w199) + w176 * (w202 - w198) + w178 * (w190 * w191 - w186 * w194)
    w204 = w183 * w191
    w205 = w42 + (w188 * w195 - w185 * w201) + w174 * (w184 * w189 - w202) + w176 * (w200 - w182 * w191) + w178 * (w196 - w204)
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
    w250 = bar5_e2 * -2.0
    w251 = 2 * bar5_e0
    w252 = 2 * bar5_e2
    w253 = (w251 * bar5_e1 + w252 * bar5_e3) * bar5_end_y
    w254 = bar5_e3 * -2.0
    w255 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * bar5_end_y
    w256 = w254 * w255
    w257 = (hinge5_angle_dot / 2.0)**2
    w258 = hinge5_angle / 2.0
    w259 = ca.cos(w258)
    w260 = w257 * w259
    w261 = ca.sin(w258)
    w262 = w261 / 2.0
    w263 = w100 * w165 + w66 * w162 + w89 * w168
    w264 = w66 * w159 - w129 * w165
    w265 = w141 * w161 + w93 * w236 + w87 * w264
    w266 = w141 * w160 - w95 * w236 - w70 * w264
    w267 = (w128 * w263 + w138 * (w100 * w159 + w129 * w162 - w130 * w168) + w146 * w265 + w157 * w266) / w170
    w268 = w267 + hinge0_angle_ddot * ((w171 * w263 - w172 * w265 - w91 * w266) / w170)
    w269 = w260 * c44 + w262 * c44 * w268
    w270 = 2 * bar5_e3
    w271 = bar5_e1 * -2.0
    w272 = w250 * bar5_e0_dot + bar5_e1_dot * w270 + w251 * bar5_e2_dot + bar5_e3_dot * w271
    w273 = bar5_e0_dot * w271 + w251 * bar5_e1_dot + w254 * bar5_e2_dot + w252 * bar5_e3_dot
    w274 = 2 * bar5_e1
    w275 = (bar5_e2 * w274 - w251 * bar5_e3) * bar5_end_y
    w276 = w255 * w273 - w272 * w275
    w277 = w254 * bar5_e0_dot + w250 * bar5_e1_dot + bar5_e2_dot * w274 + w251 * bar5_e3_dot
    w278 = w275 * w277 - w253 * w273
    w279 = w257 * w261
    w280 = w259 / 2.0
    w281 = w279 * c43 - w268 * (w280 * c43)
    w282 = w251 * w253
    w283 = w260 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w260 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w284 = w262 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w262 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w285 = w283 + w268 * w284
    w286 = (w250 * w253 - w256) * w269 - (w272 * w276 - w277 * w278) - (w253 * w270 - w250 * w255) * w281 - (w282 - w255 * w274) * w285
    w287 = w253 * w271
    w288 = w251 * w255
    w289 = w279 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w279 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w290 = w280 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w280 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w291 = w289 + w268 * w290
    w292 = w286 - (w287 - w288) * w291
    w293 = bar4_e2 * -2.0
    w294 = 2 * bar4_e3
    w295 = 2 * bar4_e0
    w296 = bar4_e1 * -2.0
    w297 = bar4_e0_dot * w293 + bar4_e1_dot * w294 + bar4_e2_dot * w295 + bar4_e3_dot * w296
    w298 = bar4_e3 * -2.0
    w299 = 2 * bar4_e2
    w300 = bar4_e0_dot * w296 + bar4_e1_dot * w295 + bar4_e2_dot * w298 + bar4_e3_dot * w299
    w301 = 2 * bar4_e1
    w302 = (bar4_e3 * w295 + bar4_e2 * w301) * bar4_end_x
    w303 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * bar4_end_x
    w304 = w300 * w302 - w297 * w303
    w305 = bar4_e0_dot * w298 + w293 * bar4_e1_dot + bar4_e2_dot * w301 + w295 * bar4_e3_dot
    w306 = (bar4_e3 * w301 - bar4_e2 * w295) * bar4_end_x
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
    w320 = w140 * w161 + w93 * w235 + w76 * w264
    w321 = w140 * w160 - w95 * w235 - w80 * w264
    w322 = hinge0_angle_ddot * ((w172 * w320 - w169 * w171 + w91 * w321) / w170) - (w128 * w169 + w138 * (w96 * w159 + w129 * w166) + w146 * w320 + w157 * w321) / w170
    w323 = w316 + (w316 - (bar5_e0 * w318 + bar5_e3 * w319)) - w269 * w310 + w291 * w313 + (bar5_e3 * w311 - bar5_e0 * w314) * w322
    w324 = bar5_e1_dot * w315 + bar5_e2_dot * w312
    w325 = bar5_e2 * w319 - bar5_e1 * w318 - w324 - w324 + w281 * w310 - w285 * w313 - w322 * (bar5_e1 * w314 + bar5_e2 * w311)
    w326 = w295 * w306
    w327 = bar5_e1_dot * w312 - bar5_e2_dot * w315
    w328 = w327 + (w327 - (bar5_e2 * w318 + bar5_e1 * w319)) + w281 * w313 + w285 * w310 + w322 * (bar5_e1 * w311 - bar5_e2 * w314)
    w329 = w297 * w304 - w305 * w307 + (w293 * w306 - w308) * w323 + (w294 * w306 - w293 * w302) * w325 + (w326 - w301 * w302) * w328
    w330 = w296 * w306
    w331 = w295 * w302
    w332 = bar5_e0_dot * w312 + bar5_e3_dot * w315
    w333 = bar5_e0 * w319 - bar5_e3 * w318 - w332 - w332 + w269 * w313 + w291 * w310 - w322 * (bar5_e0 * w311 + bar5_e3 * w314)
    w334 = w253 * w272 - w255 * w277
    w335 = w250 * w275
    w336 = w269 * (w254 * w275 - w287) - (w277 * w334 - w273 * w276) - w281 * (w335 - w282) - w285 * (w274 * w275 - w253 * w254)
    w337 = w251 * w275
    w338 = w336 - w291 * (w337 - w252 * w253)
    w339 = w297 * w306 - w302 * w305
    w340 = w293 * w303
    w341 = w305 * w339 - w300 * w304 + w323 * (w298 * w303 - w330) + w325 * (w340 - w326) + w328 * (w301 * w303 - w298 * w306)
    w342 = w295 * w303
    w343 = w269 * (w255 * w271 - w335) - (w273 * w278 - w272 * w334) - w281 * (w288 - w270 * w275) - w285 * (w256 - w337)
    w344 = w343 - w291 * (w252 * w255 - w271 * w275)
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
        w205 + w180 * (w187 * w189 - w184 * w191),  # bar3.z
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
        -w269,  # bar5.e0
        w281,  # bar5.e1
        w285,  # bar5.e2
        w291,  # bar5.e3
        w173,  # hinge1.angle
        w239,  # hinge2.angle
        w322,  # hinge4.angle
        w268,  # hinge5.angle
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 40) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 40 x 40) [SI]: constraint Jacobian
    gives C_t (n_c = 40) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 40) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 40) [m/s^2, rad/s^2]: right-hand side at acceleration level
    1153 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 129)
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
    w8 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * bar1_end_x
    w9 = 2 * bar1_e0
    w10 = 2 * bar1_e1
    w11 = (bar1_e3 * w9 + bar1_e2 * w10) * bar1_end_x
    w12 = (bar1_e3 * w10 - bar1_e2 * w9) * bar1_end_x
    w13 = hinge2_angle / 2.0
    w14 = ca.cos(w13)
    w15 = w14 * c37
    w16 = ca.sin(w13)
    w17 = w16 * c38
    w18 = w14 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w14 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w19 = w16 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w16 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w20 = 2 * bar2_e1
    w21 = 2 * bar2_e0
    w22 = (bar2_e2 * w20 - bar2_e3 * w21) * bar2_end_y
    w23 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * bar2_end_y
    w24 = 2 * bar2_e2
    w25 = (bar2_e1 * w21 + bar2_e3 * w24) * bar2_end_y
    w26 = 2 * bar3_e0
    w27 = bar3_e2 * w26
    w28 = 2 * bar3_e1
    w29 = bar3_e3 * w28
    w30 = w27 + w29
    w31 = w30 * bar3_end_z
    w32 = 2 * bar3_e2
    w33 = bar3_e3 * w32 - bar3_e1 * w26
    w34 = w33 * bar3_end_z
    w35 = 2 * bar3_e2**2
    w36 = 1.0 - 2 * bar3_e1**2 - w35
    w37 = w36 * bar3_end_z
    w38 = 1.0 - w35 - 2 * bar3_e3**2
    w39 = 2 * bar4_e1
    w40 = w39 * bar4_e2
    w41 = 2 * bar4_e0
    w42 = w41 * bar4_e3
    w43 = w40 - w42
    w44 = bar3_e3 * w26 + bar3_e2 * w28
    w45 = 2 * bar4_e3**2
    w46 = 1.0 - 2 * bar4_e1**2 - w45
    w47 = w29 - w27
    w48 = 2 * bar4_e2
    w49 = bar4_e1 * w41 + bar4_e3 * w48
    w50 = hinge4_angle / 2.0
    w51 = ca.cos(w50)
    w52 = ca.sin(w50)
    w53 = (1.0 - 2 * bar4_e2**2 - w45) * bar4_end_x
    w54 = (w40 + w42) * bar4_end_x
    w55 = (w39 * bar4_e3 - bar4_e2 * w41) * bar4_end_x
    w56 = hinge5_angle / 2.0
    w57 = ca.cos(w56)
    w58 = ca.sin(w56)
    w59 = w57 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w57 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w60 = w58 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w58 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w61 = 2 * bar5_e1
    w62 = 2 * bar5_e0
    w63 = (bar5_e2 * w61 - bar5_e3 * w62) * bar5_end_y
    w64 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * bar5_end_y
    w65 = 2 * bar5_e2
    w66 = (bar5_e1 * w62 + bar5_e3 * w65) * bar5_end_y
    w67 = -w6
    w68 = -w7
    w69 = bar1_e2 * -2.0
    w70 = bar1_e3 * -2.0
    w71 = w11 * w70
    w72 = bar1_e1 * -2.0
    w73 = w12 * w72
    w74 = w8 * w69
    w75 = 2 * bar1_e3
    w76 = w9 * w12
    w77 = w9 * w11
    w78 = w8 * w9
    w79 = 2 * bar1_e2
    w80 = -w15
    w81 = -w17
    w82 = -w18
    w83 = -w19
    w84 = bar2_e2 * -2.0
    w85 = bar2_e3 * -2.0
    w86 = w23 * w85
    w87 = bar2_e1 * -2.0
    w88 = w25 * w87
    w89 = w22 * w84
    w90 = 2 * bar2_e3
    w91 = w21 * w25
    w92 = w21 * w23
    w93 = w21 * w22
    w94 = bar3_e2 * -2.0
    w95 = bar3_e3 * -2.0
    w96 = w34 * w95
    w97 = bar3_e1 * -2.0
    w98 = w37 * w97
    w99 = w31 * w94
    w100 = w44 * w49
    w101 = w46 * w47
    w102 = w100 - w101
    w103 = w43 * w47
    w104 = w38 * w49
    w105 = w103 - w104
    w106 = w38 * w46
    w107 = w43 * w44
    w108 = w106 - w107
    w109 = w36 * w46
    w110 = w33 * w49
    w111 = w109 - w110
    w112 = w30 * w49
    w113 = w36 * w43
    w114 = w112 - w113
    w115 = w33 * w43
    w116 = w30 * w46
    w117 = w115 - w116
    w118 = 2 * bar3_e3
    w119 = w26 * w37
    w120 = w26 * w34
    w121 = w26 * w31
    w122 = w101 - w100
    w123 = bar4_e1 * -2.0
    w124 = w104 - w103
    w125 = bar4_e2 * -2.0
    w126 = w107 - w106
    w127 = bar4_e3 * -2.0
    w128 = w110 - w109
    w129 = w113 - w112
    w130 = w116 - w115
    w131 = w54 * w127
    w132 = w55 * w123
    w133 = w53 * w125
    w134 = 2 * bar4_e3
    w135 = w41 * w55
    w136 = w41 * w54
    w137 = w41 * w53
    w138 = -w51
    w139 = bar5_e2 * -2.0
    w140 = bar5_e3 * -2.0
    w141 = w64 * w140
    w142 = bar5_e1 * -2.0
    w143 = w66 * w142
    w144 = w63 * w139
    w145 = -w52
    w146 = 2 * bar5_e3
    w147 = w62 * w66
    w148 = w62 * w64
    w149 = w62 * w63
    w150 = w3 / 2.0
    w151 = w1 / 2.0
    w152 = w7 / 2.0
    w153 = w6 / 2.0
    w154 = w16 / 2.0
    w155 = w154 * c37
    w156 = w14 / 2.0
    w157 = w156 * c38
    w158 = w154 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w154 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w159 = w156 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w156 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w160 = w51 / 2.0
    w161 = w52 / 2.0
    w162 = w58 / 2.0
    w163 = w57 / 2.0
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
    w179 = w69 * bar1_e0_dot + w75 * bar1_e1_dot + w9 * bar1_e2_dot + w72 * bar1_e3_dot
    w180 = w72 * bar1_e0_dot + w9 * bar1_e1_dot + w70 * bar1_e2_dot + w79 * bar1_e3_dot
    w181 = w11 * w180 - w8 * w179
    w182 = w70 * bar1_e0_dot + w69 * bar1_e1_dot + w10 * bar1_e2_dot + w9 * bar1_e3_dot
    w183 = w8 * w182 - w12 * w180
    w184 = w12 * w179 - w11 * w182
    w185 = hinge2_angle_dot / 2.0
    w186 = w185**2
    w187 = w14 * w186
    w188 = w185 * (w14 * w185) * c37
    w189 = w187 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w187 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w190 = w16 * w186
    w191 = w185 * (w16 * w185) * c38
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
    w203 = w84 * bar2_e0_dot + w90 * bar2_e1_dot + w21 * bar2_e2_dot + w87 * bar2_e3_dot
    w204 = w87 * bar2_e0_dot + w21 * bar2_e1_dot + w85 * bar2_e2_dot + w24 * bar2_e3_dot
    w205 = w23 * w204 - w22 * w203
    w206 = w85 * bar2_e0_dot + w84 * bar2_e1_dot + w20 * bar2_e2_dot + w21 * bar2_e3_dot
    w207 = w22 * w206 - w25 * w204
    w208 = w25 * w203 - w23 * w206
    w209 = w94 * bar3_e0_dot + w118 * bar3_e1_dot + w26 * bar3_e2_dot + w97 * bar3_e3_dot
    w210 = w97 * bar3_e0_dot + w26 * bar3_e1_dot + w95 * bar3_e2_dot + w32 * bar3_e3_dot
    w211 = w34 * w210 - w31 * w209
    w212 = w95 * bar3_e0_dot + w94 * bar3_e1_dot + w28 * bar3_e2_dot + w26 * bar3_e3_dot
    w213 = w31 * w212 - w37 * w210
    w214 = w37 * w209 - w34 * w212
    w215 = w125 * bar4_e0_dot + w134 * bar4_e1_dot + w41 * bar4_e2_dot + w123 * bar4_e3_dot
    w216 = w123 * bar4_e0_dot + w41 * bar4_e1_dot + w127 * bar4_e2_dot + w48 * bar4_e3_dot
    w217 = w46 * w216 - w43 * w215
    w218 = w127 * bar4_e0_dot + w125 * bar4_e1_dot + w39 * bar4_e2_dot + w41 * bar4_e3_dot
    w219 = w43 * w218 - w49 * w216
    w220 = w215 * w217 - w218 * w219
    w221 = w49 * w215 - w46 * w218
    w222 = w218 * w221 - w216 * w217
    w223 = w216 * w219 - w215 * w221
    w224 = w44 * w210 - w38 * w209
    w225 = w38 * w212 - w47 * w210
    w226 = w47 * w209 - w44 * w212
    w227 = w30 * w209 - w33 * w210
    w228 = w36 * w210 - w30 * w212
    w229 = w33 * w212 - w36 * w209
    w230 = w160 * hinge4_angle_dot
    w231 = w161 * hinge4_angle_dot
    w232 = bar5_e3_dot * w230 - bar5_e0_dot * w231
    w233 = (hinge4_angle_dot / 2.0)**2
    w234 = w51 * w233
    w235 = w52 * w233
    w236 = w231 * bar5_e1_dot + w230 * bar5_e2_dot
    w237 = w230 * bar5_e1_dot - w231 * bar5_e2_dot
    w238 = w230 * bar5_e0_dot + bar5_e3_dot * w231
    w239 = w54 * w216 - w53 * w215
    w240 = w53 * w218 - w55 * w216
    w241 = w55 * w215 - w54 * w218
    w242 = hinge5_angle_dot / 2.0
    w243 = w242**2
    w244 = w57 * w243
    w245 = w58 * w243
    w246 = w244 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w244 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w247 = w245 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w245 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w248 = w139 * bar5_e0_dot + w146 * bar5_e1_dot + w62 * bar5_e2_dot + w142 * bar5_e3_dot
    w249 = w142 * bar5_e0_dot + w62 * bar5_e1_dot + w140 * bar5_e2_dot + w65 * bar5_e3_dot
    w250 = w64 * w249 - w63 * w248
    w251 = w140 * bar5_e0_dot + w139 * bar5_e1_dot + w61 * bar5_e2_dot + w62 * bar5_e3_dot
    w252 = w63 * w251 - w66 * w249
    w253 = w66 * w248 - w64 * w251
    w254 = w150 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w150 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w255 = w151 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w151 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w256 = w162 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w162 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w257 = w163 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w163 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w258 = (w212 * w225 - w209 * w224) * w43 - (w38 * w220 + w44 * w222 + w47 * w223) - w46 * (w212 * w226 - w210 * w224)
    w259 = w258 - w49 * (w210 * w225 - w209 * w226) - w221 * (2 * w226) - w219 * (2 * w225) - w217 * (2 * w224)
    w260 = w30 * w220 + w33 * w222 + w36 * w223 - w43 * (w209 * w227 - w212 * w228) - w46 * (w212 * w229 - w210 * w227)
    w261 = w260 - w49 * (w210 * w228 - w209 * w229) - w221 * (2 * w229) - w219 * (2 * w228) - w217 * (2 * w227)
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
        bar2_x - (bar1_x + w8),  # hinge1.x
        bar2_y - (bar1_y + w11),  # hinge1.y
        bar2_z - (bar1_z + w12),  # hinge1.z
        bar3_e0 - (bar2_e0 * w15 - (bar2_e1 * w17 + bar2_e2 * w18 + bar2_e3 * w19)),  # hinge2.e0
        bar3_e1 - (bar2_e0 * w17 + bar2_e1 * w15 + (bar2_e2 * w19 - bar2_e3 * w18)),  # hinge2.e1
        bar3_e2 - (bar2_e0 * w18 + bar2_e2 * w15 + (bar2_e3 * w17 - bar2_e1 * w19)),  # hinge2.e2
        bar3_e3 - (bar2_e0 * w19 + bar2_e3 * w15 + (bar2_e1 * w18 - bar2_e2 * w17)),  # hinge2.e3
        bar3_x - (bar2_x + w22),  # hinge2.x
        bar3_y - (bar2_y + w23),  # hinge2.y
        bar3_z - (bar2_z + w25),  # hinge2.z
        bar4_x - (bar3_x + w31),  # hinge3.x
        bar4_y - (bar3_y + w34),  # hinge3.y
        bar4_z - (bar3_z + w37),  # hinge3.z
        w38 * w43 + w44 * w46 + w47 * w49,  # hinge3.parallel_x
        -(w30 * w43 + w33 * w46 + w36 * w49),  # hinge3.parallel_y
        bar4_e0 - (bar5_e0 * w51 + bar5_e3 * w52),  # hinge4.e0
        bar4_e1 - (w51 * bar5_e1 - w52 * bar5_e2),  # hinge4.e1
        bar4_e2 - (w51 * bar5_e2 + w52 * bar5_e1),  # hinge4.e2
        bar4_e3 - (w51 * bar5_e3 - bar5_e0 * w52),  # hinge4.e3
        bar5_x - (bar4_x + w53),  # hinge4.x
        bar5_y - (bar4_y + w54),  # hinge4.y
        bar5_z - (bar4_z + w55),  # hinge4.z
        bar5_e0 - w57 * c44,  # hinge5.e0
        bar5_e1 + w58 * c43,  # hinge5.e1
        bar5_e2 - w59,  # hinge5.e2
        bar5_e3 - w60,  # hinge5.e3
        -(bar5_x + w63),  # hinge5.x
        -(bar5_y + w64),  # hinge5.y
        ground_P5_z - (bar5_z + w66),  # hinge5.z
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
    C_q[7, 3] = w67
    C_q[7, 6] = w7
    C_q[7, 10] = 1.0
    C_q[7, 36] = bar1_e0 * w152 + bar1_e3 * w153
    # hinge1.e1
    C_q[8, 4] = w67
    C_q[8, 5] = w68
    C_q[8, 11] = 1.0
    C_q[8, 36] = bar1_e1 * w152 - bar1_e2 * w153
    # hinge1.e2
    C_q[9, 4] = w7
    C_q[9, 5] = w67
    C_q[9, 12] = 1.0
    C_q[9, 36] = bar1_e2 * w152 + bar1_e1 * w153
    # hinge1.e3
    C_q[10, 3] = w68
    C_q[10, 6] = w67
    C_q[10, 13] = 1.0
    C_q[10, 36] = bar1_e3 * w152 - bar1_e0 * w153
    # hinge1.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = w71 - w12 * w69
    C_q[11, 4] = w11 * w69 - w12 * w75
    C_q[11, 5] = w10 * w11 - w76
    C_q[11, 6] = w77 - w73
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w73 - w8 * w70
    C_q[12, 4] = w76 - w74
    C_q[12, 5] = w12 * w70 - w8 * w10
    C_q[12, 6] = w12 * w79 - w78
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w74 - w11 * w72
    C_q[13, 4] = w8 * w75 - w77
    C_q[13, 5] = w78 - w71
    C_q[13, 6] = w8 * w72 - w11 * w79
    C_q[13, 9] = 1.0
    # hinge2.e0
    C_q[14, 10] = w80
    C_q[14, 11] = w17
    C_q[14, 12] = w18
    C_q[14, 13] = w19
    C_q[14, 17] = 1.0
    C_q[14, 37] = bar2_e0 * w155 + (bar2_e1 * w157 + bar2_e2 * w158 + bar2_e3 * w159)
    # hinge2.e1
    C_q[15, 10] = w81
    C_q[15, 11] = w80
    C_q[15, 12] = w83
    C_q[15, 13] = w18
    C_q[15, 18] = 1.0
    C_q[15, 37] = bar2_e1 * w155 - bar2_e0 * w157 - (bar2_e2 * w159 - bar2_e3 * w158)
    # hinge2.e2
    C_q[16, 10] = w82
    C_q[16, 11] = w19
    C_q[16, 12] = w80
    C_q[16, 13] = w81
    C_q[16, 19] = 1.0
    C_q[16, 37] = bar2_e2 * w155 - bar2_e0 * w158 - (bar2_e3 * w157 - bar2_e1 * w159)
    # hinge2.e3
    C_q[17, 10] = w83
    C_q[17, 11] = w82
    C_q[17, 12] = w17
    C_q[17, 13] = w80
    C_q[17, 20] = 1.0
    C_q[17, 37] = bar2_e3 * w155 - bar2_e0 * w159 - (bar2_e1 * w158 - bar2_e2 * w157)
    # hinge2.x
    C_q[18, 7] = -1.0
    C_q[18, 10] = w86 - w25 * w84
    C_q[18, 11] = w23 * w84 - w25 * w90
    C_q[18, 12] = w20 * w23 - w91
    C_q[18, 13] = w92 - w88
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = w88 - w22 * w85
    C_q[19, 11] = w91 - w89
    C_q[19, 12] = w25 * w85 - w20 * w22
    C_q[19, 13] = w24 * w25 - w93
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = w89 - w23 * w87
    C_q[20, 11] = w22 * w90 - w92
    C_q[20, 12] = w93 - w86
    C_q[20, 13] = w22 * w87 - w23 * w24
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = w96 - w37 * w94
    C_q[21, 18] = w34 * w94 - w37 * w118
    C_q[21, 19] = w28 * w34 - w119
    C_q[21, 20] = w120 - w98
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = w98 - w31 * w95
    C_q[22, 18] = w119 - w99
    C_q[22, 19] = w37 * w95 - w28 * w31
    C_q[22, 20] = w32 * w37 - w121
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = w99 - w34 * w97
    C_q[23, 18] = w31 * w118 - w120
    C_q[23, 19] = w121 - w96
    C_q[23, 20] = w31 * w97 - w32 * w34
    C_q[23, 23] = 1.0
    # hinge3.parallel_x
    C_q[24, 17] = w97 * w102 + w94 * w105 + w95 * w108
    C_q[24, 18] = w26 * w102 + w105 * w118 + w94 * w108
    C_q[24, 19] = w95 * w102 + w26 * w105 + w28 * w108
    C_q[24, 20] = w32 * w102 + w97 * w105 + w26 * w108
    C_q[24, 24] = w122 * w123 + w124 * w125 + w126 * w127
    C_q[24, 25] = w41 * w122 + w124 * w134 + w125 * w126
    C_q[24, 26] = w122 * w127 + w41 * w124 + w39 * w126
    C_q[24, 27] = w48 * w122 + w123 * w124 + w41 * w126
    # hinge3.parallel_y
    C_q[25, 17] = w97 * w111 + w94 * w114 + w95 * w117
    C_q[25, 18] = w26 * w111 + w114 * w118 + w94 * w117
    C_q[25, 19] = w95 * w111 + w26 * w114 + w28 * w117
    C_q[25, 20] = w32 * w111 + w97 * w114 + w26 * w117
    C_q[25, 24] = w123 * w128 + w125 * w129 + w127 * w130
    C_q[25, 25] = w41 * w128 + w129 * w134 + w125 * w130
    C_q[25, 26] = w127 * w128 + w41 * w129 + w39 * w130
    C_q[25, 27] = w48 * w128 + w123 * w129 + w41 * w130
    # hinge4.e0
    C_q[26, 24] = 1.0
    C_q[26, 31] = w138
    C_q[26, 34] = w145
    C_q[26, 38] = bar5_e0 * w161 - bar5_e3 * w160
    # hinge4.e1
    C_q[27, 25] = 1.0
    C_q[27, 32] = w138
    C_q[27, 33] = w52
    C_q[27, 38] = bar5_e1 * w161 + bar5_e2 * w160
    # hinge4.e2
    C_q[28, 26] = 1.0
    C_q[28, 32] = w145
    C_q[28, 33] = w138
    C_q[28, 38] = bar5_e2 * w161 - bar5_e1 * w160
    # hinge4.e3
    C_q[29, 27] = 1.0
    C_q[29, 31] = w52
    C_q[29, 34] = w138
    C_q[29, 38] = bar5_e0 * w160 + bar5_e3 * w161
    # hinge4.x
    C_q[30, 21] = -1.0
    C_q[30, 24] = w131 - w55 * w125
    C_q[30, 25] = w54 * w125 - w55 * w134
    C_q[30, 26] = w39 * w54 - w135
    C_q[30, 27] = w136 - w132
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = w132 - w53 * w127
    C_q[31, 25] = w135 - w133
    C_q[31, 26] = w55 * w127 - w39 * w53
    C_q[31, 27] = w48 * w55 - w137
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = w133 - w54 * w123
    C_q[32, 25] = w53 * w134 - w136
    C_q[32, 26] = w137 - w131
    C_q[32, 27] = w53 * w123 - w48 * w54
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
    C_q[37, 31] = w141 - w66 * w139
    C_q[37, 32] = w64 * w139 - w66 * w146
    C_q[37, 33] = w61 * w64 - w147
    C_q[37, 34] = w148 - w143
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = w143 - w63 * w140
    C_q[38, 32] = w147 - w144
    C_q[38, 33] = w66 * w140 - w61 * w63
    C_q[38, 34] = w65 * w66 - w149
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = w144 - w64 * w142
    C_q[39, 32] = w63 * w146 - w148
    C_q[39, 33] = w149 - w141
    C_q[39, 34] = w63 * w142 - w64 * w65
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
        w242 * (w57 * w242) * c47,  # hinge5.e0
        w242 * (w58 * w242) * c43,  # hinge5.e1
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 40 x 40) [SI]: mass matrix in all coordinates
    gives K (n x n = 40 x 40) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 40) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 40) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 40) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 40 x 40) [SI]: constraint Jacobian
    gives gamma (n_c = 40) [m/s^2, rad/s^2]: right-hand side at acceleration level
    1884 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 129)
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
    c104 = c[104]
    c105 = c[105]
    c106 = c[106]
    c107 = c[107]
    c108 = c[108]
    c109 = c[109]
    c110 = c[110]
    c111 = c[111]
    c112 = c[112]
    c113 = c[113]
    c114 = c[114]
    c115 = c[115]
    c116 = c[116]
    c117 = c[117]
    c118 = c[118]
    # intermediate terms (623)
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = w1 * bar1_e3
    w3 = 2 * bar1_e0
    w4 = bar1_e2 * w3
    w5 = w2 - w4
    w6 = w5 * c66
    w7 = bar1_e3 * -2.0
    w8 = bar1_e3 * w3
    w9 = bar1_e2 * w1
    w10 = w8 + w9
    w11 = w10 * c66
    w12 = w7 * w11
    w13 = w0 * w6 - w12
    w14 = 2 * bar1_e3
    w15 = w6 * w14 - w0 * w11
    w16 = w3 * w6
    w17 = w16 - w1 * w11
    w18 = bar1_e1 * -2.0
    w19 = w6 * w18
    w20 = w3 * w11
    w21 = w19 - w20
    w22 = 2 * bar1_e2**2
    w23 = 2 * bar1_e3**2
    w24 = 1.0 - w22 - w23
    w25 = w24 * c66
    w26 = w7 * w25 - w19
    w27 = w0 * w25
    w28 = w27 - w16
    w29 = w1 * w25 - w6 * w7
    w30 = w3 * w25
    w31 = 2 * bar1_e2
    w32 = w30 - w6 * w31
    w33 = w11 * w18 - w27
    w34 = w20 - w14 * w25
    w35 = w12 - w30
    w36 = w11 * w31 - w18 * w25
    w37 = w3 * c68
    w38 = w18 * w37 + bar1_e2 * bar1_e3 * c71
    w39 = w3 * c69
    w40 = w18 * c70
    w41 = w0 * w39 + bar1_e1 * bar1_e3 * c72
    w42 = w0 * c68
    w43 = w1 * c69
    w44 = w3 * c70
    w45 = bar1_e2 * bar1_e1 * c73 + w7 * w44
    w46 = bar1_e3 * bar1_e0 * c74 + w31 * w40
    w47 = w7 * w43 + bar1_e2 * bar1_e0 * c75
    w48 = w14 * w42 + bar1_e1 * bar1_e0 * c76
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = w50 * bar2_e1
    w52 = 2 * bar2_e2
    w53 = w52 * bar2_e3
    w54 = w51 + w53
    w55 = w54 * c53
    w56 = bar2_e3 * -2.0
    w57 = 1.0 - 2 * bar2_e1**2
    w58 = 2 * bar2_e3**2
    w59 = w57 - w58
    w60 = w59 * c53
    w61 = w56 * w60
    w62 = w49 * w55 - w61
    w63 = 2 * bar2_e3
    w64 = w55 * w63 - w49 * w60
    w65 = w50 * w55
    w66 = 2 * bar2_e1
    w67 = w65 - w60 * w66
    w68 = bar2_e1 * -2.0
    w69 = w55 * w68
    w70 = w50 * w60
    w71 = w69 - w70
    w72 = bar2_e2 * w66
    w73 = w50 * bar2_e3
    w74 = w72 - w73
    w75 = w74 * c53
    w76 = w56 * w75 - w69
    w77 = w49 * w75
    w78 = w77 - w65
    w79 = w66 * w75 - w55 * w56
    w80 = w50 * w75
    w81 = w80 - w52 * w55
    w82 = w60 * w68 - w77
    w83 = w70 - w63 * w75
    w84 = w61 - w80
    w85 = w52 * w60 - w68 * w75
    w86 = w50 * c77
    w87 = w68 * w86 + bar2_e2 * bar2_e3 * c80
    w88 = w50 * c78
    w89 = w68 * c79
    w90 = w49 * w88 + bar2_e1 * bar2_e3 * c81
    w91 = w49 * c77
    w92 = w66 * c78
    w93 = w50 * c79
    w94 = bar2_e2 * bar2_e1 * c82 + w56 * w93
    w95 = bar2_e0 * bar2_e3 * c83 + w52 * w89
    w96 = w56 * w92 + bar2_e2 * bar2_e0 * c84
    w97 = w63 * w91 + bar2_e0 * bar2_e1 * c85
    w98 = bar3_e2 * -2.0
    w99 = 1.0 - 2 * bar3_e1**2
    w100 = 2 * bar3_e2**2
    w101 = w99 - w100
    w102 = w101 * c4
    w103 = bar3_e3 * -2.0
    w104 = 2 * bar3_e2
    w105 = bar3_e3 * w104
    w106 = 2 * bar3_e0
    w107 = bar3_e1 * w106
    w108 = w105 - w107
    w109 = w108 * c4
    w110 = w103 * w109
    w111 = w98 * w102 - w110
    w112 = 2 * bar3_e3
    w113 = w102 * w112 - w98 * w109
    w114 = w102 * w106
    w115 = 2 * bar3_e1
    w116 = w114 - w109 * w115
    w117 = bar3_e1 * -2.0
    w118 = w102 * w117
    w119 = w106 * w109
    w120 = w118 - w119
    w121 = bar3_e2 * w106
    w122 = bar3_e3 * w115
    w123 = w121 + w122
    w124 = w123 * c4
    w125 = w103 * w124 - w118
    w126 = w98 * w124
    w127 = w126 - w114
    w128 = w115 * w124 - w102 * w103
    w129 = w106 * w124
    w130 = w129 - w102 * w104
    w131 = w109 * w117 - w126
    w132 = w119 - w112 * w124
    w133 = w110 - w129
    w134 = w104 * w109 - w117 * w124
    w135 = w106 * c22
    w136 = w117 * w135 + bar3_e2 * bar3_e3 * c88
    w137 = w106 * c86
    w138 = w117 * c87
    w139 = w98 * w137 + bar3_e1 * bar3_e3 * c89
    w140 = w98 * c22
    w141 = w115 * c86
    w142 = w106 * c87
    w143 = bar3_e2 * bar3_e1 * c90 + w103 * w142
    w144 = bar3_e3 * bar3_e0 * c91 + w104 * w138
    w145 = w103 * w141 + bar3_e2 * bar3_e0 * c92
    w146 = w112 * w140 + bar3_e1 * bar3_e0 * c93
    w147 = bar4_e2 * -2.0
    w148 = 2 * bar4_e1
    w149 = w148 * bar4_e3
    w150 = 2 * bar4_e0
    w151 = bar4_e2 * w150
    w152 = w149 - w151
    w153 = w152 * c60
    w154 = bar4_e3 * -2.0
    w155 = bar4_e3 * w150
    w156 = bar4_e2 * w148
    w157 = w155 + w156
    w158 = w157 * c60
    w159 = w154 * w158
    w160 = w147 * w153 - w159
    w161 = 2 * bar4_e3
    w162 = w153 * w161 - w147 * w158
    w163 = w150 * w153
    w164 = w163 - w148 * w158
    w165 = bar4_e1 * -2.0
    w166 = w153 * w165
    w167 = w150 * w158
    w168 = w166 - w167
    w169 = 2 * bar4_e2**2
    w170 = 2 * bar4_e3**2
    w171 = 1.0 - w169 - w170
    w172 = w171 * c60
    w173 = w154 * w172 - w166
    w174 = w147 * w172
    w175 = w174 - w163
    w176 = w148 * w172 - w153 * w154
    w177 = w150 * w172
    w178 = 2 * bar4_e2
    w179 = w177 - w153 * w178
    w180 = w158 * w165 - w174
    w181 = w167 - w161 * w172
    w182 = w159 - w177
    w183 = w158 * w178 - w165 * w172
    w184 = w150 * c94
    w185 = w165 * w184 + bar4_e2 * bar4_e3 * c97
    w186 = w150 * c95
    w187 = w165 * c96
    w188 = w147 * w186 + bar4_e1 * bar4_e3 * c98
    w189 = w147 * c94
    w190 = w148 * c95
    w191 = w150 * c96
    w192 = bar4_e2 * bar4_e1 * c99 + w154 * w191
    w193 = bar4_e3 * bar4_e0 * c100 + w178 * w187
    w194 = w154 * w190 + bar4_e2 * bar4_e0 * c101
    w195 = w161 * w189 + bar4_e1 * bar4_e0 * c102
    w196 = bar5_e2 * -2.0
    w197 = 2 * bar5_e0
    w198 = w197 * bar5_e1
    w199 = 2 * bar5_e2
    w200 = w199 * bar5_e3
    w201 = w198 + w200
    w202 = w201 * c63
    w203 = bar5_e3 * -2.0
    w204 = 1.0 - 2 * bar5_e1**2
    w205 = 2 * bar5_e3**2
    w206 = w204 - w205
    w207 = w206 * c63
    w208 = w203 * w207
    w209 = w196 * w202 - w208
    w210 = 2 * bar5_e3
    w211 = w202 * w210 - w196 * w207
    w212 = w197 * w202
    w213 = 2 * bar5_e1
    w214 = w212 - w207 * w213
    w215 = bar5_e1 * -2.0
    w216 = w202 * w215
    w217 = w197 * w207
    w218 = w216 - w217
    w219 = bar5_e2 * w213
    w220 = w197 * bar5_e3
    w221 = w219 - w220
    w222 = w221 * c63
    w223 = w203 * w222 - w216
    w224 = w196 * w222
    w225 = w224 - w212
    w226 = w213 * w222 - w202 * w203
    w227 = w197 * w222
    w228 = w227 - w199 * w202
    w229 = w207 * w215 - w224
    w230 = w217 - w210 * w222
    w231 = w208 - w227
    w232 = w199 * w207 - w215 * w222
    w233 = w197 * c103
    w234 = w215 * w233 + bar5_e2 * bar5_e3 * c107
    w235 = w197 * c105
    w236 = w215 * c106
    w237 = w196 * w235 + bar5_e1 * bar5_e3 * c108
    w238 = w196 * c103
    w239 = w213 * c105
    w240 = w197 * c106
    w241 = bar5_e2 * bar5_e1 * c109 + w203 * w240
    w242 = bar5_e0 * bar5_e3 * c110 + w199 * w236
    w243 = w203 * w239 + bar5_e2 * bar5_e0 * c111
    w244 = w210 * w238 + bar5_e0 * bar5_e1 * c112
    w245 = w7 * bar1_e0_dot
    w246 = w3 * bar1_e3_dot
    w247 = w245 + w31 * bar1_e1_dot + w18 * bar1_e2_dot + w246
    w248 = w247 * c66
    w249 = w0 * bar1_e0_dot
    w250 = w3 * bar1_e2_dot
    w251 = w249 + w7 * bar1_e1_dot + w250 + w1 * bar1_e3_dot
    w252 = w251 * c66
    w253 = w247 * w248 + w251 * w252
    w254 = w18 * bar1_e0_dot + w3 * bar1_e1_dot
    w255 = w254 + w14 * bar1_e2_dot + w0 * bar1_e3_dot
    w256 = w252 * w255
    w257 = w248 * w255
    w258 = w24 * w253 - (w9 - w8) * w256 - (w2 + w4) * w257
    w259 = 1.0 - 2 * bar1_e1**2
    w260 = bar1_e3 * w31
    w261 = bar1_e1 * w3
    w262 = w10 * w253 - w256 * (w259 - w23) - w257 * (w260 - w261)
    w263 = w5 * w253 - w256 * (w260 + w261) - w257 * (w259 - w22)
    w264 = w247 * c56
    w265 = w251 * c67
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c55
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w18 * w266 + w0 * w268 + w7 * w269
    w271 = w3 * w266 + w7 * w268 + w31 * w269
    w272 = w14 * w266 + w3 * w268 + w18 * w269
    w273 = w0 * w266 + w1 * w268 + w3 * w269
    w274 = w68 * bar2_e0_dot + w50 * bar2_e1_dot
    w275 = w274 + w63 * bar2_e2_dot + w49 * bar2_e3_dot
    w276 = w275 * c53
    w277 = w56 * bar2_e0_dot
    w278 = w50 * bar2_e3_dot
    w279 = w277 + w52 * bar2_e1_dot + w68 * bar2_e2_dot + w278
    w280 = w279 * c53
    w281 = w275 * w276 + w279 * w280
    w282 = 2 * bar2_e2**2
    w283 = w49 * bar2_e0_dot
    w284 = w50 * bar2_e2_dot
    w285 = w283 + w56 * bar2_e1_dot + w284 + w66 * bar2_e3_dot
    w286 = w276 * w285
    w287 = bar2_e2 * w50
    w288 = bar2_e3 * w66
    w289 = w280 * w285
    w290 = w74 * w281 - (1.0 - w282 - w58) * w286 - (w287 + w288) * w289
    w291 = w59 * w281 - w286 * (w72 + w73) - w289 * (w53 - w51)
    w292 = w54 * w281 - w286 * (w288 - w287) - w289 * (w57 - w282)
    w293 = w279 * c57
    w294 = w285 * c50
    w295 = w285 * w293 - w279 * w294
    w296 = w275 * c51
    w297 = w279 * w296 - w275 * w293
    w298 = w275 * w294 - w285 * w296
    w299 = w68 * w295 + w49 * w297 + w56 * w298
    w300 = w50 * w295 + w56 * w297 + w52 * w298
    w301 = w63 * w295 + w50 * w297 + w68 * w298
    w302 = w49 * w295 + w66 * w297 + w50 * w298
    w303 = w98 * bar3_e0_dot
    w304 = w106 * bar3_e2_dot
    w305 = w303 + w103 * bar3_e1_dot + w304 + w115 * bar3_e3_dot
    w306 = w305 * c4
    w307 = w117 * bar3_e0_dot + w106 * bar3_e1_dot
    w308 = w307 + w112 * bar3_e2_dot + w98 * bar3_e3_dot
    w309 = w308 * c4
    w310 = w305 * w306 + w308 * w309
    w311 = 2 * bar3_e3**2
    w312 = 1.0 - w100 - w311
    w313 = w103 * bar3_e0_dot
    w314 = w106 * bar3_e3_dot
    w315 = w313 + w104 * bar3_e1_dot + w117 * bar3_e2_dot + w314
    w316 = w309 * w315
    w317 = bar3_e2 * w115
    w318 = bar3_e3 * w106
    w319 = w306 * w315
    w320 = w123 * w310 - (w312 * w316 + (w317 - w318) * w319)
    w321 = w317 + w318
    w322 = w108 * w310 - (w316 * w321 + w319 * (w99 - w311))
    w323 = w122 - w121
    w324 = w101 * w310 - (w316 * w323 + w319 * (w105 + w107))
    w325 = w315 * c0
    w326 = w305 * c1
    w327 = w305 * w325 - w315 * w326
    w328 = w308 * c52
    w329 = w315 * w328 - w308 * w325
    w330 = w308 * w326 - w305 * w328
    w331 = w117 * w327 + w98 * w329 + w103 * w330
    w332 = w106 * w327 + w103 * w329 + w104 * w330
    w333 = w112 * w327 + w106 * w329 + w117 * w330
    w334 = w98 * w327 + w115 * w329 + w106 * w330
    w335 = w154 * bar4_e0_dot
    w336 = w150 * bar4_e3_dot
    w337 = w335 + w178 * bar4_e1_dot + w165 * bar4_e2_dot + w336
    w338 = w337 * c60
    w339 = w147 * bar4_e0_dot
    w340 = w150 * bar4_e2_dot
    w341 = w339 + w154 * bar4_e1_dot + w340 + w148 * bar4_e3_dot
    w342 = w341 * c60
    w343 = w337 * w338 + w341 * w342
    w344 = w156 - w155
    w345 = w165 * bar4_e0_dot + w150 * bar4_e1_dot
    w346 = w345 + w161 * bar4_e2_dot + w147 * bar4_e3_dot
    w347 = w342 * w346
    w348 = w338 * w346
    w349 = w171 * w343 - w344 * w347 - (w149 + w151) * w348
    w350 = 1.0 - 2 * bar4_e1**2
    w351 = w350 - w170
    w352 = bar4_e3 * w178
    w353 = bar4_e1 * w150
    w354 = w157 * w343 - w347 * w351 - w348 * (w352 - w353)
    w355 = w352 + w353
    w356 = w152 * w343 - w347 * w355 - w348 * (w350 - w169)
    w357 = w337 * c65
    w358 = w341 * c16
    w359 = w341 * w357 - w337 * w358
    w360 = w346 * c59
    w361 = w337 * w360 - w346 * w357
    w362 = w346 * w358 - w341 * w360
    w363 = w165 * w359 + w147 * w361 + w154 * w362
    w364 = w150 * w359 + w154 * w361 + w178 * w362
    w365 = w161 * w359 + w150 * w361 + w165 * w362
    w366 = w147 * w359 + w148 * w361 + w150 * w362
    w367 = w215 * bar5_e0_dot + w197 * bar5_e1_dot
    w368 = w367 + w210 * bar5_e2_dot + w196 * bar5_e3_dot
    w369 = w368 * c63
    w370 = w203 * bar5_e0_dot
    w371 = w197 * bar5_e3_dot
    w372 = w370 + w199 * bar5_e1_dot + w215 * bar5_e2_dot + w371
    w373 = w372 * c63
    w374 = w368 * w369 + w372 * w373
    w375 = 2 * bar5_e2**2
    w376 = w196 * bar5_e0_dot
    w377 = w197 * bar5_e2_dot
    w378 = w376 + w203 * bar5_e1_dot + w377 + w213 * bar5_e3_dot
    w379 = w369 * w378
    w380 = bar5_e2 * w197
    w381 = bar5_e3 * w213
    w382 = w373 * w378
    w383 = w221 * w374 - (1.0 - w375 - w205) * w379 - (w380 + w381) * w382
    w384 = w206 * w374 - w379 * (w219 + w220) - w382 * (w200 - w198)
    w385 = w201 * w374 - w379 * (w381 - w380) - w382 * (w204 - w375)
    w386 = w372 * c64
    w387 = w378 * c62
    w388 = w378 * w386 - w372 * w387
    w389 = w368 * c104
    w390 = w372 * w389 - w368 * w386
    w391 = w368 * w387 - w378 * w389
    w392 = w215 * w388 + w196 * w390 + w203 * w391
    w393 = w197 * w388 + w203 * w390 + w199 * w391
    w394 = w210 * w388 + w197 * w390 + w215 * w391
    w395 = w196 * w388 + w213 * w390 + w197 * w391
    w396 = w26 * gravity_y
    w397 = w28 * gravity_y
    w398 = w29 * gravity_y
    w399 = w32 * gravity_y
    w400 = w76 * gravity_y
    w401 = w78 * gravity_y
    w402 = w79 * gravity_y
    w403 = w81 * gravity_y
    w404 = w125 * gravity_y
    w405 = w127 * gravity_y
    w406 = w128 * gravity_y
    w407 = w130 * gravity_y
    w408 = w173 * gravity_y
    w409 = w175 * gravity_y
    w410 = w176 * gravity_y
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
    w422 = w10 * bar1_end_x
    w423 = w7 * w422
    w424 = w24 * bar1_end_x
    w425 = w18 * w421
    w426 = w0 * w424
    w427 = w3 * w421
    w428 = w3 * w422
    w429 = w3 * w424
    w430 = hinge2_angle / 2.0
    w431 = ca.cos(w430)
    w432 = w431 * c118
    w433 = ca.sin(w430)
    w434 = w433 * c38
    w435 = -w434
    w436 = w431 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w431 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w437 = -w436
    w438 = w433 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w433 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w439 = -w438
    w440 = w54 * bar2_end_y
    w441 = w59 * bar2_end_y
    w442 = w56 * w441
    w443 = w74 * bar2_end_y
    w444 = w68 * w440
    w445 = w49 * w443
    w446 = w50 * w440
    w447 = w50 * w441
    w448 = w50 * w443
    w449 = w101 * bar3_end_z
    w450 = w108 * bar3_end_z
    w451 = w103 * w450
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
    w464 = w101 * w351
    w465 = w108 * w355
    w466 = w464 - w465
    w467 = w123 * w355
    w468 = w101 * w344
    w469 = w467 - w468
    w470 = w108 * w344
    w471 = w123 * w351
    w472 = w470 - w471
    w473 = w106 * w449
    w474 = w106 * w450
    w475 = w106 * w452
    w476 = w456 - w455
    w477 = w459 - w458
    w478 = w462 - w461
    w479 = w465 - w464
    w480 = w468 - w467
    w481 = w471 - w470
    w482 = w152 * bar4_end_x
    w483 = w157 * bar4_end_x
    w484 = w154 * w483
    w485 = w171 * bar4_end_x
    w486 = w165 * w482
    w487 = w147 * w485
    w488 = w150 * w482
    w489 = w150 * w483
    w490 = w150 * w485
    w491 = hinge4_angle / 2.0
    w492 = ca.cos(w491)
    w493 = -w492
    w494 = ca.sin(w491)
    w495 = w201 * bar5_end_y
    w496 = w206 * bar5_end_y
    w497 = w203 * w496
    w498 = w221 * bar5_end_y
    w499 = w215 * w495
    w500 = w196 * w498
    w501 = -w494
    w502 = w197 * w495
    w503 = w197 * w496
    w504 = w197 * w498
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
    w540 = w250 + (w249 + w14 * bar1_e1_dot) + w18 * bar1_e3_dot
    w541 = w254 + w7 * bar1_e2_dot + w31 * bar1_e3_dot
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
    w564 = w284 + (w283 + w63 * bar2_e1_dot) + w68 * bar2_e3_dot
    w565 = w274 + w56 * bar2_e2_dot + w52 * bar2_e3_dot
    w566 = w441 * w565 - w443 * w564
    w567 = w278 + (w277 + w49 * bar2_e1_dot + w66 * bar2_e2_dot)
    w568 = w443 * w567 - w440 * w565
    w569 = w440 * w564 - w441 * w567
    w570 = w304 + (w303 + w112 * bar3_e1_dot) + w117 * bar3_e3_dot
    w571 = w307 + w103 * bar3_e2_dot + w104 * bar3_e3_dot
    w572 = w450 * w571 - w452 * w570
    w573 = w314 + (w313 + w98 * bar3_e1_dot + w115 * bar3_e2_dot)
    w574 = w452 * w573 - w449 * w571
    w575 = w449 * w570 - w450 * w573
    w576 = w340 + (w339 + w161 * bar4_e1_dot) + w165 * bar4_e3_dot
    w577 = w345 + w154 * bar4_e2_dot + w178 * bar4_e3_dot
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
    w589 = w101 * w571 - w123 * w573
    w590 = w108 * w573 - w101 * w570
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
    w609 = w377 + (w376 + w210 * bar5_e1_dot) + w215 * bar5_e3_dot
    w610 = w367 + w203 * bar5_e2_dot + w199 * bar5_e3_dot
    w611 = w496 * w610 - w498 * w609
    w612 = w371 + (w370 + w196 * bar5_e1_dot + w213 * bar5_e2_dot)
    w613 = w498 * w612 - w495 * w610
    w614 = w495 * w609 - w496 * w612
    w615 = w507 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0 - w507 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w616 = w509 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w509 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w617 = w522 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w522 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w618 = w524 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w524 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w619 = (w573 * w586 - w570 * w585) * w344 - (w312 * w581 + w321 * w583 + w323 * w584) - w351 * (w573 * w587 - w571 * w585)
    w620 = w619 - w355 * (w571 * w586 - w570 * w587) - w582 * (2 * w587) - w580 * (2 * w586) - w578 * (2 * w585)
    w621 = w123 * w581 + w108 * w583 + w101 * w584 - w344 * (w570 * w588 - w573 * w589) - w351 * (w573 * w590 - w571 * w588)
    w622 = w621 - w355 * (w571 * w589 - w570 * w590) - w582 * (2 * w590) - w580 * (2 * w589) - w578 * (2 * w588)
    # outputs
    M = ca.SX(40, 40)
    # bar1.x
    M[0, 0] = bar1_mass
    M[0, 3] = w13
    M[0, 4] = w15
    M[0, 5] = w17
    M[0, 6] = w21
    # bar1.y
    M[1, 1] = bar1_mass
    M[1, 3] = w26
    M[1, 4] = w28
    M[1, 5] = w29
    M[1, 6] = w32
    # bar1.z
    M[2, 2] = bar1_mass
    M[2, 3] = w33
    M[2, 4] = w34
    M[2, 5] = w35
    M[2, 6] = w36
    # bar1.e0
    M[3, 0] = w13
    M[3, 1] = w26
    M[3, 2] = w33
    M[3, 3] = w18 * (w18 * c68) + w0 * (w0 * c69) + w7 * (w7 * c70)
    M[3, 4] = w38
    M[3, 5] = w41
    M[3, 6] = w45
    # bar1.e1
    M[4, 0] = w15
    M[4, 1] = w28
    M[4, 2] = w34
    M[4, 3] = w38
    M[4, 4] = w3 * w37 + w7 * (w7 * c69) + w31 * (w31 * c70)
    M[4, 5] = w46
    M[4, 6] = w47
    # bar1.e2
    M[5, 0] = w17
    M[5, 1] = w29
    M[5, 2] = w35
    M[5, 3] = w41
    M[5, 4] = w46
    M[5, 5] = w14 * (w14 * c68) + w3 * w39 + w18 * w40
    M[5, 6] = w48
    # bar1.e3
    M[6, 0] = w21
    M[6, 1] = w32
    M[6, 2] = w36
    M[6, 3] = w45
    M[6, 4] = w47
    M[6, 5] = w48
    M[6, 6] = w0 * w42 + w1 * w43 + w3 * w44
    # bar2.x
    M[7, 7] = bar2_mass
    M[7, 10] = w62
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
    M[10, 7] = w62
    M[10, 8] = w76
    M[10, 9] = w82
    M[10, 10] = w68 * (w68 * c77) + w49 * (w49 * c78) + w56 * (w56 * c79)
    M[10, 11] = w87
    M[10, 12] = w90
    M[10, 13] = w94
    # bar2.e1
    M[11, 7] = w64
    M[11, 8] = w78
    M[11, 9] = w83
    M[11, 10] = w87
    M[11, 11] = w50 * w86 + w56 * (w56 * c78) + w52 * (w52 * c79)
    M[11, 12] = w95
    M[11, 13] = w96
    # bar2.e2
    M[12, 7] = w67
    M[12, 8] = w79
    M[12, 9] = w84
    M[12, 10] = w90
    M[12, 11] = w95
    M[12, 12] = w63 * (w63 * c77) + w50 * w88 + w68 * w89
    M[12, 13] = w97
    # bar2.e3
    M[13, 7] = w71
    M[13, 8] = w81
    M[13, 9] = w85
    M[13, 10] = w94
    M[13, 11] = w96
    M[13, 12] = w97
    M[13, 13] = w49 * w91 + w66 * w92 + w50 * w93
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
    M[17, 17] = w117 * (w117 * c22) + w98 * (w98 * c86) + w103 * (w103 * c87)
    M[17, 18] = w136
    M[17, 19] = w139
    M[17, 20] = w143
    # bar3.e1
    M[18, 14] = w113
    M[18, 15] = w127
    M[18, 16] = w132
    M[18, 17] = w136
    M[18, 18] = w106 * w135 + w103 * (w103 * c86) + w104 * (w104 * c87)
    M[18, 19] = w144
    M[18, 20] = w145
    # bar3.e2
    M[19, 14] = w116
    M[19, 15] = w128
    M[19, 16] = w133
    M[19, 17] = w139
    M[19, 18] = w144
    M[19, 19] = w112 * (w112 * c22) + w106 * w137 + w117 * w138
    M[19, 20] = w146
    # bar3.e3
    M[20, 14] = w120
    M[20, 15] = w130
    M[20, 16] = w134
    M[20, 17] = w143
    M[20, 18] = w145
    M[20, 19] = w146
    M[20, 20] = w98 * w140 + w115 * w141 + w106 * w142
    # bar4.x
    M[21, 21] = bar4_mass
    M[21, 24] = w160
    M[21, 25] = w162
    M[21, 26] = w164
    M[21, 27] = w168
    # bar4.y
    M[22, 22] = bar4_mass
    M[22, 24] = w173
    M[22, 25] = w175
    M[22, 26] = w176
    M[22, 27] = w179
    # bar4.z
    M[23, 23] = bar4_mass
    M[23, 24] = w180
    M[23, 25] = w181
    M[23, 26] = w182
    M[23, 27] = w183
    # bar4.e0
    M[24, 21] = w160
    M[24, 22] = w173
    M[24, 23] = w180
    M[24, 24] = w165 * (w165 * c94) + w147 * (w147 * c95) + w154 * (w154 * c96)
    M[24, 25] = w185
    M[24, 26] = w188
    M[24, 27] = w192
    # bar4.e1
    M[25, 21] = w162
    M[25, 22] = w175
    M[25, 23] = w181
    M[25, 24] = w185
    M[25, 25] = w150 * w184 + w154 * (w154 * c95) + w178 * (w178 * c96)
    M[25, 26] = w193
    M[25, 27] = w194
    # bar4.e2
    M[26, 21] = w164
    M[26, 22] = w176
    M[26, 23] = w182
    M[26, 24] = w188
    M[26, 25] = w193
    M[26, 26] = w161 * (w161 * c94) + w150 * w186 + w165 * w187
    M[26, 27] = w195
    # bar4.e3
    M[27, 21] = w168
    M[27, 22] = w179
    M[27, 23] = w183
    M[27, 24] = w192
    M[27, 25] = w194
    M[27, 26] = w195
    M[27, 27] = w147 * w189 + w148 * w190 + w150 * w191
    # bar5.x
    M[28, 28] = bar5_mass
    M[28, 31] = w209
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
    M[31, 28] = w209
    M[31, 29] = w223
    M[31, 30] = w229
    M[31, 31] = w215 * (w215 * c103) + w196 * (w196 * c105) + w203 * (w203 * c106)
    M[31, 32] = w234
    M[31, 33] = w237
    M[31, 34] = w241
    # bar5.e1
    M[32, 28] = w211
    M[32, 29] = w225
    M[32, 30] = w230
    M[32, 31] = w234
    M[32, 32] = w197 * w233 + w203 * (w203 * c105) + w199 * (w199 * c106)
    M[32, 33] = w242
    M[32, 34] = w243
    # bar5.e2
    M[33, 28] = w214
    M[33, 29] = w226
    M[33, 30] = w231
    M[33, 31] = w237
    M[33, 32] = w242
    M[33, 33] = w210 * (w210 * c103) + w197 * w235 + w215 * w236
    M[33, 34] = w244
    # bar5.e3
    M[34, 28] = w218
    M[34, 29] = w228
    M[34, 30] = w232
    M[34, 31] = w241
    M[34, 32] = w243
    M[34, 33] = w244
    M[34, 34] = w196 * w238 + w213 * w239 + w197 * w240
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
    Q_F[1] = c113  # bar1.y
    Q_F[3] = w396  # bar1.e0
    Q_F[4] = w397  # bar1.e1
    Q_F[5] = w398  # bar1.e2
    Q_F[6] = w399  # bar1.e3
    Q_F[8] = c114  # bar2.y
    Q_F[10] = w400  # bar2.e0
    Q_F[11] = w401  # bar2.e1
    Q_F[12] = w402  # bar2.e2
    Q_F[13] = w403  # bar2.e3
    Q_F[15] = c115  # bar3.y
    Q_F[17] = w404  # bar3.e0
    Q_F[18] = w405  # bar3.e1
    Q_F[19] = w406  # bar3.e2
    Q_F[20] = w407  # bar3.e3
    Q_F[22] = c116  # bar4.y
    Q_F[24] = w408  # bar4.e0
    Q_F[25] = w409  # bar4.e1
    Q_F[26] = w410  # bar4.e2
    Q_F[27] = w411  # bar4.e3
    Q_F[29] = c117  # bar5.y
    Q_F[31] = w412  # bar5.e0
    Q_F[32] = w413  # bar5.e1
    Q_F[33] = w414  # bar5.e2
    Q_F[34] = w415  # bar5.e3
    Q_star = ca.vertcat(
        w258,  # bar1.x
        w262 + c113,  # bar1.y
        w263,  # bar1.z
        w270 + w396,  # bar1.e0
        w271 + w397,  # bar1.e1
        w272 + w398,  # bar1.e2
        w273 + w399,  # bar1.e3
        w290,  # bar2.x
        w291 + c114,  # bar2.y
        w292,  # bar2.z
        w299 + w400,  # bar2.e0
        w300 + w401,  # bar2.e1
        w301 + w402,  # bar2.e2
        w302 + w403,  # bar2.e3
        w320,  # bar3.x
        w322 + c115,  # bar3.y
        w324,  # bar3.z
        w331 + w404,  # bar3.e0
        w332 + w405,  # bar3.e1
        w333 + w406,  # bar3.e2
        w334 + w407,  # bar3.e3
        w349,  # bar4.x
        w354 + c116,  # bar4.y
        w356,  # bar4.z
        w363 + w408,  # bar4.e0
        w364 + w409,  # bar4.e1
        w365 + w410,  # bar4.e2
        w366 + w411,  # bar4.e3
        w383,  # bar5.x
        w384 + c117,  # bar5.y
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
    C_q[11, 4] = w0 * w422 - w14 * w421
    C_q[11, 5] = w1 * w422 - w427
    C_q[11, 6] = w428 - w425
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w425 - w7 * w424
    C_q[12, 4] = w427 - w426
    C_q[12, 5] = w7 * w421 - w1 * w424
    C_q[12, 6] = w31 * w421 - w429
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w426 - w18 * w422
    C_q[13, 4] = w14 * w424 - w428
    C_q[13, 5] = w429 - w423
    C_q[13, 6] = w18 * w424 - w31 * w422
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
    C_q[18, 11] = w49 * w441 - w63 * w440
    C_q[18, 12] = w66 * w441 - w446
    C_q[18, 13] = w447 - w444
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = w444 - w56 * w443
    C_q[19, 11] = w446 - w445
    C_q[19, 12] = w56 * w440 - w66 * w443
    C_q[19, 13] = w52 * w440 - w448
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = w445 - w68 * w441
    C_q[20, 11] = w63 * w443 - w447
    C_q[20, 12] = w448 - w442
    C_q[20, 13] = w68 * w443 - w52 * w441
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = w451 - w98 * w449
    C_q[21, 18] = w98 * w450 - w112 * w449
    C_q[21, 19] = w115 * w450 - w473
    C_q[21, 20] = w474 - w453
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = w453 - w103 * w452
    C_q[22, 18] = w473 - w454
    C_q[22, 19] = w103 * w449 - w115 * w452
    C_q[22, 20] = w104 * w449 - w475
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = w454 - w117 * w450
    C_q[23, 18] = w112 * w452 - w474
    C_q[23, 19] = w475 - w451
    C_q[23, 20] = w117 * w452 - w104 * w450
    C_q[23, 23] = 1.0
    # hinge3.parallel_x
    C_q[24, 17] = w117 * w457 + w98 * w460 + w103 * w463
    C_q[24, 18] = w106 * w457 + w112 * w460 + w98 * w463
    C_q[24, 19] = w103 * w457 + w106 * w460 + w115 * w463
    C_q[24, 20] = w104 * w457 + w117 * w460 + w106 * w463
    C_q[24, 24] = w165 * w476 + w147 * w477 + w154 * w478
    C_q[24, 25] = w150 * w476 + w161 * w477 + w147 * w478
    C_q[24, 26] = w154 * w476 + w150 * w477 + w148 * w478
    C_q[24, 27] = w178 * w476 + w165 * w477 + w150 * w478
    # hinge3.parallel_y
    C_q[25, 17] = w117 * w466 + w98 * w469 + w103 * w472
    C_q[25, 18] = w106 * w466 + w112 * w469 + w98 * w472
    C_q[25, 19] = w103 * w466 + w106 * w469 + w115 * w472
    C_q[25, 20] = w104 * w466 + w117 * w469 + w106 * w472
    C_q[25, 24] = w165 * w479 + w147 * w480 + w154 * w481
    C_q[25, 25] = w150 * w479 + w161 * w480 + w147 * w481
    C_q[25, 26] = w154 * w479 + w150 * w480 + w148 * w481
    C_q[25, 27] = w178 * w479 + w165 * w480 + w150 * w481
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
    C_q[30, 25] = w147 * w483 - w161 * w482
    C_q[30, 26] = w148 * w483 - w488
    C_q[30, 27] = w489 - w486
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = w486 - w154 * w485
    C_q[31, 25] = w488 - w487
    C_q[31, 26] = w154 * w482 - w148 * w485
    C_q[31, 27] = w178 * w482 - w490
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = w487 - w165 * w483
    C_q[32, 25] = w161 * w485 - w489
    C_q[32, 26] = w490 - w484
    C_q[32, 27] = w165 * w485 - w178 * w483
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
    C_q[37, 32] = w196 * w496 - w210 * w495
    C_q[37, 33] = w213 * w496 - w502
    C_q[37, 34] = w503 - w499
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = w499 - w203 * w498
    C_q[38, 32] = w502 - w500
    C_q[38, 33] = w203 * w495 - w213 * w498
    C_q[38, 34] = w199 * w495 - w504
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = w500 - w215 * w496
    C_q[39, 32] = w210 * w498 - w503
    C_q[39, 33] = w504 - w497
    C_q[39, 34] = w215 * w498 - w199 * w496
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 40) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 6) [N, N m]: world force and moment of a joint on its body b, at b
    2752 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    q_ddot = ca.SX.sym("q_ddot", 40)
    lam_R = ca.SX.sym("lam_R", 1)
    c = ca.SX.sym("c", 129)
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
    c103 = c[103]
    c104 = c[104]
    c105 = c[105]
    c106 = c[106]
    c107 = c[107]
    c108 = c[108]
    c109 = c[109]
    c110 = c[110]
    c111 = c[111]
    c112 = c[112]
    c113 = c[113]
    c114 = c[114]
    c115 = c[115]
    c116 = c[116]
    c117 = c[117]
    # intermediate terms (728)
    w0 = bar1_e1 * -2.0
    w1 = bar1_e3 * -2.0
    w2 = 2 * bar1_e2
    w3 = 2 * bar1_e0
    w4 = bar1_e0_dot * w1 + bar1_e1_dot * w2 + w0 * bar1_e2_dot + bar1_e3_dot * w3
    w5 = w4 * c56
    w6 = bar1_e2 * -2.0
    w7 = 2 * bar1_e1
    w8 = bar1_e0_dot * w6 + w1 * bar1_e1_dot + bar1_e2_dot * w3 + bar1_e3_dot * w7
    w9 = w8 * c67
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * bar1_e3
    w12 = w0 * bar1_e0_dot + bar1_e1_dot * w3 + bar1_e2_dot * w11 + bar1_e3_dot * w6
    w13 = w12 * c55
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = 2 * bar1_e2**2
    w17 = 2 * bar1_e3**2
    w18 = 1.0 - w16 - w17
    w19 = w18 * c66
    w20 = bar1_e3 * w7
    w21 = bar1_e2 * w3
    w22 = w20 - w21
    w23 = w22 * c66
    w24 = w0 * w23
    w25 = w1 * w19 - w24
    w26 = bar1_e3 * w3
    w27 = bar1_e2 * w7
    w28 = w26 + w27
    w29 = w28 * c66
    w30 = w1 * w29
    w31 = w6 * w23 - w30
    w32 = w6 * w19
    w33 = w0 * w29 - w32
    w34 = w31 * bar1_x_ddot + w25 * bar1_y_ddot + w33 * bar1_z_ddot + (w0 * (w0 * c68) + w6 * (w6 * c69) + w1 * (w1 * c70)) * bar1_e0_ddot
    w35 = w3 * c68
    w36 = w0 * w35 + bar1_e3 * bar1_e2 * c71
    w37 = w3 * c69
    w38 = w0 * c70
    w39 = w6 * w37 + bar1_e1 * bar1_e3 * c72
    w40 = w6 * c68
    w41 = w7 * c69
    w42 = w3 * c70
    w43 = bar1_e1 * bar1_e2 * c73 + w1 * w42
    w44 = w0 * w10 + w6 * w14 + w1 * w15 + w25 * gravity_y - (w34 + w36 * bar1_e1_ddot + w39 * bar1_e2_ddot + w43 * bar1_e3_ddot)
    w45 = w28 * bar1_end_x
    w46 = w18 * bar1_end_x
    w47 = w6 * w46
    w48 = 2 * bar2_e0
    w49 = w48 * bar2_e1
    w50 = 2 * bar2_e2
    w51 = w50 * bar2_e3
    w52 = w49 + w51
    w53 = bar2_e1 * -2.0
    w54 = 2 * bar2_e3
    w55 = bar2_e2 * -2.0
    w56 = bar2_e0_dot * w53 + w48 * bar2_e1_dot + bar2_e2_dot * w54 + bar2_e3_dot * w55
    w57 = w56 * c53
    w58 = bar2_e3 * -2.0
    w59 = bar2_e0_dot * w58 + w50 * bar2_e1_dot + w53 * bar2_e2_dot + w48 * bar2_e3_dot
    w60 = w59 * c53
    w61 = w56 * w57 + w59 * w60
    w62 = 2 * bar2_e1
    w63 = bar2_e3 * w62
    w64 = w48 * bar2_e2
    w65 = w63 - w64
    w66 = bar2_e0_dot * w55 + bar2_e1_dot * w58 + w48 * bar2_e2_dot + bar2_e3_dot * w62
    w67 = w57 * w66
    w68 = 1.0 - 2 * bar2_e1**2
    w69 = 2 * bar2_e2**2
    w70 = w60 * w66
    w71 = 2 * bar2_e3**2
    w72 = w68 - w71
    w73 = w72 * c53
    w74 = bar2_e2 * w62
    w75 = w48 * bar2_e3
    w76 = w74 - w75
    w77 = w76 * c53
    w78 = w55 * w77
    w79 = w53 * w73 - w78
    w80 = w48 * w73
    w81 = w80 - w54 * w77
    w82 = w58 * w73
    w83 = w48 * w77
    w84 = w82 - w83
    w85 = w50 * w73 - w53 * w77
    w86 = bar2_z_ddot * bar2_mass + w79 * bar2_e0_ddot + w81 * bar2_e1_ddot + w84 * bar2_e2_ddot + w85 * bar2_e3_ddot
    w87 = 1.0 - 2 * bar3_e1**2
    w88 = 2 * bar3_e2**2
    w89 = w87 - w88
    w90 = bar3_e2 * -2.0
    w91 = bar3_e3 * -2.0
    w92 = 2 * bar3_e0
    w93 = 2 * bar3_e1
    w94 = bar3_e0_dot * w90 + bar3_e1_dot * w91 + bar3_e2_dot * w92 + bar3_e3_dot * w93
    w95 = w94 * c4
    w96 = bar3_e1 * -2.0
    w97 = 2 * bar3_e3
    w98 = bar3_e0_dot * w96 + bar3_e1_dot * w92 + bar3_e2_dot * w97 + w90 * bar3_e3_dot
    w99 = w98 * c4
    w100 = w94 * w95 + w98 * w99
    w101 = bar3_e3 * w93
    w102 = bar3_e2 * w92
    w103 = w101 - w102
    w104 = 2 * bar3_e2
    w105 = bar3_e0_dot * w91 + bar3_e1_dot * w104 + bar3_e2_dot * w96 + w92 * bar3_e3_dot
    w106 = w99 * w105
    w107 = bar3_e1 * w92
    w108 = bar3_e3 * w104
    w109 = w95 * w105
    w110 = w108 - w107
    w111 = w110 * c4
    w112 = w101 + w102
    w113 = w112 * c4
    w114 = w90 * w113
    w115 = w96 * w111 - w114
    w116 = w92 * w111
    w117 = w116 - w97 * w113
    w118 = w91 * w111
    w119 = w92 * w113
    w120 = w118 - w119
    w121 = w104 * w111 - w96 * w113
    w122 = bar3_z_ddot * bar3_mass + w115 * bar3_e0_ddot + w117 * bar3_e1_ddot + w120 * bar3_e2_ddot + w121 * bar3_e3_ddot
    w123 = w89 * w100 - (w103 * w106 + (w107 + w108) * w109) - w122
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
    w169 = w59 * c57
    w170 = w66 * c50
    w171 = w66 * w169 - w59 * w170
    w172 = w56 * c51
    w173 = w59 * w172 - w56 * w169
    w174 = w56 * w170 - w66 * w172
    w175 = w52 * c53
    w176 = w83 - w50 * w175
    w177 = w53 * w175
    w178 = w177 - w80
    w179 = w55 * c77
    w180 = w62 * c78
    w181 = w48 * c79
    w182 = bar2_e1 * bar2_e2 * c82 + w58 * w181
    w183 = w58 * w180 + bar2_e0 * bar2_e2 * c84
    w184 = w178 * bar2_x_ddot + w176 * bar2_y_ddot + bar2_z_ddot * w85 + bar2_e0_ddot * w182 + bar2_e1_ddot * w183
    w185 = w54 * w179 + bar2_e0 * bar2_e1 * c85
    w186 = w55 * w171 + w62 * w173 + w48 * w174 + w176 * gravity_y - (w184 + bar2_e2_ddot * w185 + bar2_e3_ddot * (w55 * w179 + w62 * w180 + w48 * w181))
    w187 = w72 * bar2_end_y
    w188 = w76 * bar2_end_y
    w189 = w50 * w187 - w53 * w188
    w190 = w48 * w188
    w191 = w52 * bar2_end_y
    w192 = w190 - w50 * w191
    w193 = bar3_e3 * w92
    w194 = bar3_e2 * w93
    w195 = w193 + w194
    w196 = 2 * bar3_e3**2
    w197 = w89 * c4
    w198 = w96 * w197
    w199 = w91 * w113 - w198
    w200 = w92 * w197
    w201 = w114 - w200
    w202 = w93 * w113 - w91 * w197
    w203 = w119 - w104 * w197
    w204 = bar3_y_ddot * bar3_mass + bar3_e0_ddot * w199 + bar3_e1_ddot * w201 + bar3_e2_ddot * w202 + bar3_e3_ddot * w203
    w205 = c115 + (w100 * w110 - (w106 * w195 + w109 * (w87 - w196))) - w204
    w206 = w53 * w191
    w207 = w48 * w187
    w208 = w206 - w207
    w209 = 1.0 - w88 - w196
    w210 = w90 * w197 - w118
    w211 = w97 * w197 - w90 * w111
    w212 = w200 - w93 * w111
    w213 = w198 - w116
    w214 = bar3_x_ddot * bar3_mass + bar3_e0_ddot * w210 + bar3_e1_ddot * w211 + bar3_e2_ddot * w212 + bar3_e3_ddot * w213
    w215 = w100 * w112 - (w106 * w209 + w109 * (w194 - w193)) - w214
    w216 = hinge2_angle / 2.0
    w217 = ca.cos(w216)
    w218 = w217 * c37
    w219 = w105 * c0
    w220 = w94 * c1
    w221 = w94 * w219 - w105 * w220
    w222 = w98 * c52
    w223 = w105 * w222 - w98 * w219
    w224 = w98 * w220 - w94 * w222
    w225 = w90 * c22
    w226 = w93 * c86
    w227 = w92 * c87
    w228 = bar3_e1 * bar3_e2 * c90 + w91 * w227
    w229 = w91 * w226 + bar3_e2 * bar3_e0 * c92
    w230 = bar3_x_ddot * w213 + bar3_y_ddot * w203 + bar3_z_ddot * w121 + bar3_e0_ddot * w228 + bar3_e1_ddot * w229
    w231 = w97 * w225 + bar3_e1 * bar3_e0 * c93
    w232 = w90 * w221 + w93 * w223 + w92 * w224 + w203 * gravity_y - (w230 + bar3_e2_ddot * w231 + bar3_e3_ddot * (w90 * w225 + w93 * w226 + w92 * w227))
    w233 = 1.0 - 2 * bar4_e1**2
    w234 = 2 * bar4_e3**2
    w235 = w233 - w234
    w236 = w89 * w235
    w237 = 2 * bar4_e0
    w238 = bar4_e1 * w237
    w239 = 2 * bar4_e2
    w240 = bar4_e3 * w239
    w241 = w238 + w240
    w242 = w110 * w241
    w243 = w236 - w242
    w244 = w112 * w241
    w245 = 2 * bar4_e1
    w246 = bar4_e2 * w245
    w247 = bar4_e3 * w237
    w248 = w246 - w247
    w249 = w89 * w248
    w250 = w244 - w249
    w251 = w110 * w248
    w252 = w112 * w235
    w253 = w251 - w252
    w254 = w232 - (w104 * w243 + w96 * w250 + w92 * w253) * lam_R0
    w255 = ca.sin(w216)
    w256 = w255 * c38
    w257 = w92 * c86
    w258 = w96 * c87
    w259 = w90 * w257 + bar3_e1 * bar3_e3 * c89
    w260 = bar3_e3 * bar3_e0 * c91 + w104 * w258
    w261 = bar3_x_ddot * w212 + bar3_y_ddot * w202 + bar3_z_ddot * w120 + bar3_e0_ddot * w259 + bar3_e1_ddot * w260
    w262 = w97 * w221 + w92 * w223 + w96 * w224 + w202 * gravity_y - (w261 + bar3_e2_ddot * (w97 * (w97 * c22) + w92 * w257 + w96 * w258) + bar3_e3_ddot * w231)
    w263 = w262 - lam_R0 * (w91 * w243 + w92 * w250 + w93 * w253)
    w264 = w217 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w217 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w265 = w92 * c22
    w266 = w96 * w265 + bar3_e2 * bar3_e3 * c88
    w267 = bar3_x_ddot * w211 + bar3_y_ddot * w201 + bar3_z_ddot * w117 + bar3_e0_ddot * w266 + bar3_e1_ddot * (w92 * w265 + w91 * (w91 * c86) + w104 * (w104 * c87))
    w268 = w92 * w221 + w91 * w223 + w104 * w224 + w201 * gravity_y - (w267 + bar3_e2_ddot * w260 + bar3_e3_ddot * w229)
    w269 = w268 - lam_R0 * (w92 * w243 + w97 * w250 + w90 * w253)
    w270 = w255 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w255 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w271 = bar3_x_ddot * w210 + bar3_y_ddot * w199 + bar3_z_ddot * w115 + bar3_e0_ddot * (w96 * (w96 * c22) + w90 * (w90 * c86) + w91 * (w91 * c87))
    w272 = w96 * w221 + w90 * w223 + w91 * w224 + w199 * gravity_y - (w271 + bar3_e1_ddot * w266 + bar3_e2_ddot * w259 + bar3_e3_ddot * w228)
    w273 = w272 - lam_R0 * (w96 * w243 + w90 * w250 + w91 * w253)
    w274 = w186 + w123 * w189 + w192 * w205 + w208 * w215 + w218 * w254 + w256 * w263 - w264 * w269 - w270 * w273
    w275 = w62 * w77 - w58 * w175
    w276 = w48 * w175
    w277 = w276 - w62 * w73
    w278 = w48 * c78
    w279 = w53 * c79
    w280 = w55 * w278 + bar2_e1 * bar2_e3 * c81
    w281 = bar2_e0 * bar2_e3 * c83 + w50 * w279
    w282 = bar2_x_ddot * w277 + bar2_y_ddot * w275 + bar2_z_ddot * w84 + bar2_e0_ddot * w280 + bar2_e1_ddot * w281
    w283 = w54 * w171 + w48 * w173 + w53 * w174 + w275 * gravity_y - (w282 + bar2_e2_ddot * (w54 * (w54 * c77) + w48 * w278 + w53 * w279) + bar2_e3_ddot * w185)
    w284 = w58 * w187
    w285 = w284 - w190
    w286 = w62 * w188 - w58 * w191
    w287 = w48 * w191
    w288 = w287 - w62 * w187
    w289 = w283 + w123 * w285 + w205 * w286 + w215 * w288 - w254 * w256 + w218 * w263 + w269 * w270 - w264 * w273
    w290 = w78 - w276
    w291 = w54 * w175 - w55 * w73
    w292 = w48 * c77
    w293 = w53 * w292 + bar2_e2 * bar2_e3 * c80
    w294 = bar2_x_ddot * w291 + bar2_y_ddot * w290 + bar2_z_ddot * w81 + bar2_e0_ddot * w293 + bar2_e1_ddot * (w48 * w292 + w58 * (w58 * c78) + w50 * (w50 * c79))
    w295 = w48 * w171 + w58 * w173 + w50 * w174 + w290 * gravity_y - (w294 + bar2_e2_ddot * w281 + bar2_e3_ddot * w183)
    w296 = w207 - w54 * w188
    w297 = w55 * w188
    w298 = w297 - w287
    w299 = w54 * w191 - w55 * w187
    w300 = w295 + w123 * w296 + w205 * w298 + w215 * w299 + w254 * w264 - w263 * w270 + w218 * w269 - w256 * w273
    w301 = (bar1_e0 * w166 - bar1_e3 * w168) * w274 - (bar1_e2 * w168 + bar1_e1 * w166) * w289 + (bar1_e2 * w166 - bar1_e1 * w168) * w300
    w302 = w58 * w77 - w177
    w303 = w55 * w175 - w82
    w304 = bar2_x_ddot * w303 + bar2_y_ddot * w302 + bar2_z_ddot * w79 + bar2_e0_ddot * (w53 * (w53 * c77) + w55 * (w55 * c78) + w58 * (w58 * c79))
    w305 = w53 * w171 + w55 * w173 + w58 * w174 + w302 * gravity_y - (w304 + bar2_e1_ddot * w293 + bar2_e2_ddot * w280 + bar2_e3_ddot * w182)
    w306 = w53 * w187 - w297
    w307 = w58 * w188 - w206
    w308 = w55 * w191 - w284
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
    w330 = 2 * bar4_e3
    w331 = bar4_e3 * -2.0
    w332 = bar4_e1 * -2.0
    w333 = bar4_e0_dot * w331 + w239 * bar4_e1_dot + bar4_e2_dot * w332 + w237 * bar4_e3_dot
    w334 = w333 * c65
    w335 = bar4_e2 * -2.0
    w336 = bar4_e0_dot * w335 + w331 * bar4_e1_dot + w237 * bar4_e2_dot + w245 * bar4_e3_dot
    w337 = w336 * c16
    w338 = w334 * w336 - w333 * w337
    w339 = bar4_e0_dot * w332 + w237 * bar4_e1_dot + w330 * bar4_e2_dot + bar4_e3_dot * w335
    w340 = w339 * c59
    w341 = w333 * w340 - w334 * w339
    w342 = w337 * w339 - w336 * w340
    w343 = 2 * bar4_e2**2
    w344 = 1.0 - w343 - w234
    w345 = w344 * c60
    w346 = bar4_e3 * w245
    w347 = w237 * bar4_e2
    w348 = w346 - w347
    w349 = w348 * c60
    w350 = w245 * w345 - w331 * w349
    w351 = w237 * w349
    w352 = w246 + w247
    w353 = w352 * c60
    w354 = w351 - w245 * w353
    w355 = w331 * w353
    w356 = w237 * w345
    w357 = w355 - w356
    w358 = w237 * c95
    w359 = w332 * c96
    w360 = w335 * w358 + bar4_e1 * bar4_e3 * c98
    w361 = bar4_e3 * bar4_e0 * c100 + w239 * w359
    w362 = w354 * bar4_x_ddot + w350 * bar4_y_ddot + w357 * bar4_z_ddot + w360 * bar4_e0_ddot + w361 * bar4_e1_ddot
    w363 = w335 * c94
    w364 = w245 * c95
    w365 = w237 * c96
    w366 = w330 * w363 + bar4_e1 * bar4_e0 * c102
    w367 = w330 * w338 + w237 * w341 + w332 * w342 + w350 * gravity_y - (w362 + (w330 * (w330 * c94) + w237 * w358 + w332 * w359) * bar4_e2_ddot + w366 * bar4_e3_ddot)
    w368 = w242 - w236
    w369 = w249 - w244
    w370 = w252 - w251
    w371 = w367 - lam_R0 * (w331 * w368 + w237 * w369 + w245 * w370)
    w372 = w352 * bar4_end_x
    w373 = w331 * w372
    w374 = w344 * bar4_end_x
    w375 = w237 * w374
    w376 = w373 - w375
    w377 = w333 * c60
    w378 = w336 * c60
    w379 = w333 * w377 + w336 * w378
    w380 = w339 * w378
    w381 = w233 - w343
    w382 = w339 * w377
    w383 = w335 * w345
    w384 = w332 * w353 - w383
    w385 = w237 * w353
    w386 = w385 - w330 * w345
    w387 = w239 * w353 - w332 * w345
    w388 = bar4_z_ddot * bar4_mass + bar4_e0_ddot * w384 + bar4_e1_ddot * w386 + w357 * bar4_e2_ddot + bar4_e3_ddot * w387
    w389 = w348 * w379 - w241 * w380 - w381 * w382 - w388
    w390 = w348 * bar4_end_x
    w391 = w245 * w374 - w331 * w390
    w392 = w240 - w238
    w393 = w332 * w349
    w394 = w331 * w345 - w393
    w395 = w383 - w351
    w396 = w356 - w239 * w349
    w397 = bar4_y_ddot * bar4_mass + bar4_e0_ddot * w394 + bar4_e1_ddot * w395 + w350 * bar4_e2_ddot + bar4_e3_ddot * w396
    w398 = c116 + (w352 * w379 - w235 * w380 - w382 * w392) - w397
    w399 = w237 * w390
    w400 = w399 - w245 * w372
    w401 = w346 + w347
    w402 = w335 * w349 - w355
    w403 = w330 * w349 - w335 * w353
    w404 = w393 - w385
    w405 = bar4_x_ddot * bar4_mass + bar4_e0_ddot * w402 + bar4_e1_ddot * w403 + w354 * bar4_e2_ddot + bar4_e3_ddot * w404
    w406 = w344 * w379 - w248 * w380 - w382 * w401 - w405
    w407 = w371 - w376 * w389 - w391 * w398 - w400 * w406
    w408 = bar4_e1 * bar4_e2 * c99 + w331 * w365
    w409 = w331 * w364 + bar4_e0 * bar4_e2 * c101
    w410 = bar4_x_ddot * w404 + bar4_y_ddot * w396 + bar4_z_ddot * w387 + bar4_e0_ddot * w408 + bar4_e1_ddot * w409
    w411 = w335 * w338 + w245 * w341 + w237 * w342 + w396 * gravity_y - (w410 + bar4_e2_ddot * w366 + bar4_e3_ddot * (w335 * w363 + w245 * w364 + w237 * w365))
    w412 = w411 - lam_R0 * (w239 * w368 + w332 * w369 + w237 * w370)
    w413 = w239 * w372 - w332 * w374
    w414 = w375 - w239 * w390
    w415 = w332 * w390
    w416 = w237 * w372
    w417 = w415 - w416
    w418 = w412 - w389 * w413 - w398 * w414 - w406 * w417
    w419 = w237 * c94
    w420 = w332 * w419 + bar4_e3 * bar4_e2 * c97
    w421 = bar4_x_ddot * w403 + bar4_y_ddot * w395 + bar4_z_ddot * w386 + bar4_e0_ddot * w420 + bar4_e1_ddot * (w237 * w419 + w331 * (w331 * c95) + w239 * (w239 * c96))
    w422 = w237 * w338 + w331 * w341 + w239 * w342 + w395 * gravity_y - (w421 + w361 * bar4_e2_ddot + bar4_e3_ddot * w409)
    w423 = w422 - lam_R0 * (w237 * w368 + w330 * w369 + w335 * w370)
    w424 = w416 - w330 * w374
    w425 = w335 * w374
    w426 = w425 - w399
    w427 = w330 * w390 - w335 * w372
    w428 = w423 - w389 * w424 - w398 * w426 - w406 * w427
    w429 = (bar5_e1 * w327 - w329 * bar5_e2) * w407 - (w327 * bar5_e0 + w329 * bar5_e3) * w418 - (bar5_e1 * w329 + w327 * bar5_e2) * w428
    w430 = bar4_x_ddot * w402 + bar4_y_ddot * w394 + bar4_z_ddot * w384 + bar4_e0_ddot * (w332 * (w332 * c94) + w335 * (w335 * c95) + w331 * (w331 * c96))
    w431 = w332 * w338 + w335 * w341 + w331 * w342 + w394 * gravity_y - (w430 + bar4_e1_ddot * w420 + w360 * bar4_e2_ddot + bar4_e3_ddot * w408)
    w432 = w431 - lam_R0 * (w332 * w368 + w335 * w369 + w331 * w370)
    w433 = w332 * w372 - w425
    w434 = w331 * w374 - w415
    w435 = w335 * w390 - w373
    w436 = w432 - w389 * w433 - w398 * w434 - w406 * w435
    w437 = w429 + (w327 * bar5_e3 - w329 * bar5_e0) * w436
    w438 = w163 * w310 - (w158 * w312 - w147 * w313 + w162 * w314) * w322 - (w155 * w323 + w146 * w324) * w437
    w439 = w161 * w313 + w136 * w314
    w440 = hinge5_angle / 2.0
    w441 = ca.cos(w440) / 2.0
    w442 = w441 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w441 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w443 = bar5_e2 * -2.0
    w444 = bar5_e3 * -2.0
    w445 = 2 * bar5_e2
    w446 = bar5_e1 * -2.0
    w447 = 2 * bar5_e0
    w448 = bar5_e0_dot * w444 + bar5_e1_dot * w445 + bar5_e2_dot * w446 + bar5_e3_dot * w447
    w449 = w448 * c64
    w450 = 2 * bar5_e1
    w451 = w443 * bar5_e0_dot + w444 * bar5_e1_dot + bar5_e2_dot * w447 + bar5_e3_dot * w450
    w452 = w451 * c62
    w453 = w449 * w451 - w448 * w452
    w454 = 2 * bar5_e3
    w455 = bar5_e0_dot * w446 + bar5_e1_dot * w447 + bar5_e2_dot * w454 + w443 * bar5_e3_dot
    w456 = w455 * c104
    w457 = w448 * w456 - w449 * w455
    w458 = w452 * w455 - w451 * w456
    w459 = bar5_e2 * w450
    w460 = bar5_e3 * w447
    w461 = w459 - w460
    w462 = w461 * c63
    w463 = w447 * w462
    w464 = bar5_e1 * w447
    w465 = bar5_e3 * w445
    w466 = w464 + w465
    w467 = w466 * c63
    w468 = w463 - w445 * w467
    w469 = w446 * w467
    w470 = 1.0 - 2 * bar5_e1**2
    w471 = 2 * bar5_e3**2
    w472 = w470 - w471
    w473 = w472 * c63
    w474 = w447 * w473
    w475 = w469 - w474
    w476 = w445 * w473 - w446 * w462
    w477 = w443 * c103
    w478 = w450 * c105
    w479 = w447 * c106
    w480 = bar5_e1 * bar5_e2 * c109 + w444 * w479
    w481 = w444 * w478 + bar5_e2 * bar5_e0 * c111
    w482 = w475 * bar5_x_ddot + w468 * bar5_y_ddot + w476 * bar5_z_ddot + w480 * bar5_e0_ddot + w481 * bar5_e1_ddot
    w483 = w454 * w477 + bar5_e1 * bar5_e0 * c112
    w484 = w443 * w453 + w450 * w457 + w447 * w458 + w468 * gravity_y - (w482 + w483 * bar5_e2_ddot + (w443 * w477 + w450 * w478 + w447 * w479) * bar5_e3_ddot)
    w485 = w472 * bar5_end_y
    w486 = w461 * bar5_end_y
    w487 = w445 * w485 - w446 * w486
    w488 = w455 * c63
    w489 = w448 * c63
    w490 = w455 * w488 + w448 * w489
    w491 = bar5_e3 * w450
    w492 = bar5_e2 * w447
    w493 = w491 - w492
    w494 = w451 * w488
    w495 = 2 * bar5_e2**2
    w496 = w451 * w489
    w497 = w443 * w462
    w498 = w446 * w473 - w497
    w499 = w474 - w454 * w462
    w500 = w444 * w473
    w501 = w500 - w463
    w502 = bar5_z_ddot * bar5_mass + bar5_e0_ddot * w498 + bar5_e1_ddot * w499 + bar5_e2_ddot * w501 + w476 * bar5_e3_ddot
    w503 = w466 * w490 - w493 * w494 - (w470 - w495) * w496 - w502
    w504 = w389 + w503
    w505 = w447 * w486
    w506 = w466 * bar5_end_y
    w507 = w505 - w445 * w506
    w508 = w459 + w460
    w509 = w444 * w462 - w469
    w510 = w447 * w467
    w511 = w497 - w510
    w512 = w450 * w462 - w444 * w467
    w513 = bar5_y_ddot * bar5_mass + bar5_e0_ddot * w509 + bar5_e1_ddot * w511 + bar5_e2_ddot * w512 + w468 * bar5_e3_ddot
    w514 = c117 + (w472 * w490 - w494 * w508 - w496 * (w465 - w464)) - w513
    w515 = w398 + w514
    w516 = w446 * w506
    w517 = w447 * w485
    w518 = w516 - w517
    w519 = 1.0 - w495 - w471
    w520 = w443 * w467 - w500
    w521 = w454 * w467 - w443 * w473
    w522 = w510 - w450 * w473
    w523 = bar5_x_ddot * bar5_mass + bar5_e0_ddot * w520 + bar5_e1_ddot * w521 + bar5_e2_ddot * w522 + w475 * bar5_e3_ddot
    w524 = w461 * w490 - w494 * w519 - w496 * (w491 + w492) - w523
    w525 = w406 + w524
    w526 = ca.sin(w440) / 2.0
    w527 = w526 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w526 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w528 = w447 * c105
    w529 = w446 * c106
    w530 = w443 * w528 + bar5_e1 * bar5_e3 * c108
    w531 = bar5_e0 * bar5_e3 * c110 + w445 * w529
    w532 = bar5_x_ddot * w522 + bar5_y_ddot * w512 + bar5_z_ddot * w501 + bar5_e0_ddot * w530 + bar5_e1_ddot * w531
    w533 = w453 * w454 + w447 * w457 + w446 * w458 + w512 * gravity_y - (w532 + bar5_e2_ddot * (w454 * (w454 * c103) + w447 * w528 + w446 * w529) + w483 * bar5_e3_ddot)
    w534 = w444 * w485
    w535 = w534 - w505
    w536 = w450 * w486 - w444 * w506
    w537 = w447 * w506
    w538 = w537 - w450 * w485
    w539 = w442 * (w484 + w326 * w418 + w328 * w436 - w487 * w504 - w507 * w515 - w518 * w525) + w527 * (w533 + w326 * w407 - w328 * w428 - w504 * w535 - w515 * w536 - w525 * w538)
    w540 = w447 * c103
    w541 = w446 * w540 + bar5_e2 * bar5_e3 * c107
    w542 = bar5_x_ddot * w521 + bar5_y_ddot * w511 + bar5_z_ddot * w499 + bar5_e0_ddot * w541 + bar5_e1_ddot * (w447 * w540 + w444 * (w444 * c105) + w445 * (w445 * c106))
    w543 = w447 * w453 + w444 * w457 + w445 * w458 + w511 * gravity_y - (w542 + bar5_e2_ddot * w531 + w481 * bar5_e3_ddot)
    w544 = w517 - w454 * w486
    w545 = w443 * w486
    w546 = w545 - w537
    w547 = w454 * w506 - w443 * w485
    w548 = bar5_x_ddot * w520 + bar5_y_ddot * w509 + bar5_z_ddot * w498 + bar5_e0_ddot * (w446 * (w446 * c103) + w443 * (w443 * c105) + w444 * (w444 * c106))
    w549 = w446 * w453 + w443 * w457 + w444 * w458 + w509 * gravity_y - (w548 + bar5_e1_ddot * w541 + bar5_e2_ddot * w530 + w480 * bar5_e3_ddot)
    w550 = w446 * w485 - w545
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
    w567 = w52 * w61 - w65 * w67 - (w68 - w69) * w70 - w86 + w566
    w568 = w22 * bar1_end_x
    w569 = w0 * w568
    w570 = w74 + w75
    w571 = bar2_y_ddot * bar2_mass + bar2_e0_ddot * w302 + bar2_e1_ddot * w290 + bar2_e2_ddot * w275 + bar2_e3_ddot * w176
    w572 = w312 * w557 - w149 * w562
    w573 = w322 * (w312 * w556 - w147 * w562 - w314 * w560) - w310 * w561 - w437 * (w323 * w555 - w146 * w572)
    w574 = w161 * w562 + w314 * w557
    w575 = (w573 + w553 * (w323 * w554 - w140 * w574 - w154 * w572)) / w564
    w576 = w205 + w575
    w577 = c114 + (w61 * w72 - w67 * w570 - w70 * (w51 - w49)) - w571 + w576
    w578 = w1 * w45
    w579 = 1.0 - w69 - w71
    w580 = bar2_x_ddot * bar2_mass + bar2_e0_ddot * w303 + bar2_e1_ddot * w291 + bar2_e2_ddot * w277 + bar2_e3_ddot * w178
    w581 = w136 * w562 - w313 * w557
    w582 = w310 * w559 - w322 * (w158 * w562 - w313 * w556 + w314 * w558) - w437 * (w155 * w574 + w439 * w555 + w146 * w581)
    w583 = (w582 + w553 * (w157 * w574 + w439 * w554 + w154 * w581)) / w564
    w584 = w215 + w583
    w585 = w61 * w76 - w67 * w579 - w70 * (w63 + w64) - w580 + w584
    w586 = w89 * bar3_end_z
    w587 = w96 * w586
    w588 = w110 * bar3_end_z
    w589 = w92 * w588
    w590 = w112 * bar3_end_z
    w591 = w92 * w590
    w592 = w195 * w241
    w593 = w103 * w235
    w594 = w592 - w593
    w595 = w103 * w248
    w596 = w209 * w241
    w597 = w595 - w596
    w598 = w209 * w235
    w599 = w195 * w248
    w600 = w598 - w599
    w601 = w322 * (w312 * w558 - w313 * w560 - w162 * w562) - w310 * w563 + w437 * (w155 * w572 + w324 * w555)
    w602 = (w601 + w553 * (w140 * w581 - w157 * w572 - w324 * w554)) / w564
    w603 = w254 + w583 * (w587 - w589) + w575 * (w591 - w104 * w586) + w565 * (w104 * w588 - w96 * w590) - (w104 * w594 + w96 * w597 + w92 * w600) * w602
    w604 = w92 * w586
    w605 = w91 * w588
    w606 = w263 + w583 * (w604 - w93 * w588) + w575 * (w93 * w590 - w91 * w586) + w565 * (w605 - w591) - w602 * (w91 * w594 + w92 * w597 + w93 * w600)
    w607 = w90 * w590
    w608 = w269 + w583 * (w97 * w586 - w90 * w588) + w575 * (w607 - w604) + w565 * (w589 - w97 * w590) - w602 * (w92 * w594 + w97 * w597 + w90 * w600)
    w609 = w273 + w583 * (w90 * w586 - w605) + w575 * (w91 * w590 - w587) + w565 * (w96 * w588 - w607) - w602 * (w96 * w594 + w90 * w597 + w91 * w600)
    w610 = w186 + w189 * w566 + w192 * w576 + w208 * w584 + w218 * w603 + w256 * w606 - w264 * w608 - w270 * w609
    w611 = w44 + (w0 * w45 - w47) * w567 + (w1 * w46 - w569) * w577 + (w6 * w568 - w578) * w585 + w167 * w610
    w612 = w305 + w306 * w566 + w307 * w576 + w308 * w584 + w270 * w603 + w264 * w606 + w256 * w608 + w218 * w609
    w613 = w611 + w165 * w612
    w614 = w3 * w23
    w615 = w32 - w614
    w616 = w11 * w23 - w6 * w29
    w617 = w3 * w29
    w618 = w617 - w11 * w19
    w619 = bar1_x_ddot * w616 + bar1_y_ddot * w615 + bar1_z_ddot * w618 + bar1_e0_ddot * w36 + bar1_e1_ddot * (w3 * w35 + w1 * (w1 * c69) + w2 * (w2 * c70))
    w620 = bar1_e3 * bar1_e0 * c74 + w2 * w38
    w621 = w1 * w41 + bar1_e2 * bar1_e0 * c75
    w622 = w3 * w10 + w1 * w14 + w2 * w15 + w615 * gravity_y - (w619 + bar1_e2_ddot * w620 + bar1_e3_ddot * w621)
    w623 = w3 * w45
    w624 = w3 * w568
    w625 = w283 + w285 * w566 + w286 * w576 + w288 * w584 - w256 * w603 + w218 * w606 + w270 * w608 - w264 * w609
    w626 = w622 + w567 * (w623 - w11 * w46) + w577 * (w47 - w624) + w585 * (w11 * w568 - w6 * w45) - w167 * w625
    w627 = w295 + w296 * w566 + w298 * w576 + w299 * w584 + w264 * w603 - w270 * w606 + w218 * w608 - w256 * w609
    w628 = w626 + w165 * w627
    w629 = w7 * w19 - w1 * w23
    w630 = w614 - w7 * w29
    w631 = w3 * w19
    w632 = w30 - w631
    w633 = bar1_x_ddot * w630 + bar1_y_ddot * w629 + bar1_z_ddot * w632 + bar1_e0_ddot * w39 + bar1_e1_ddot * w620
    w634 = w11 * w40 + bar1_e1 * bar1_e0 * c76
    w635 = w10 * w11 + w3 * w14 + w0 * w15 + w629 * gravity_y - (w633 + bar1_e2_ddot * (w11 * (w11 * c68) + w3 * w37 + w0 * w38) + bar1_e3_ddot * w634)
    w636 = w3 * w46
    w637 = w635 + w567 * (w578 - w636) + w577 * (w7 * w46 - w1 * w568) + w585 * (w624 - w7 * w45) + w165 * w625
    w638 = w637 + w167 * w627
    w639 = w631 - w2 * w23
    w640 = w24 - w617
    w641 = w2 * w29 - w0 * w19
    w642 = bar1_x_ddot * w640 + bar1_y_ddot * w639 + bar1_z_ddot * w641 + bar1_e0_ddot * w43 + bar1_e1_ddot * w621
    w643 = w6 * w10 + w7 * w14 + w3 * w15 + w639 * gravity_y - (w642 + bar1_e2_ddot * w634 + bar1_e3_ddot * (w6 * w40 + w7 * w41 + w3 * w42))
    w644 = w643 + w567 * (w2 * w45 - w0 * w46) + w577 * (w636 - w2 * w568) + w585 * (w569 - w623) + w165 * w610
    w645 = w644 - w167 * w612
    w646 = w4 * c66
    w647 = w8 * c66
    w648 = w4 * w646 + w8 * w647
    w649 = w12 * w647
    w650 = w20 + w21
    w651 = w12 * w646
    w652 = bar1_x_ddot * bar1_mass + w31 * bar1_e0_ddot + bar1_e1_ddot * w616 + bar1_e2_ddot * w630 + bar1_e3_ddot * w640
    w653 = w585 + (w18 * w648 - (w27 - w26) * w649 - w650 * w651 - w652)
    w654 = 1.0 - 2 * bar1_e1**2
    w655 = bar1_e3 * w2
    w656 = bar1_e1 * w3
    w657 = w655 - w656
    w658 = bar1_y_ddot * bar1_mass + w25 * bar1_e0_ddot + bar1_e1_ddot * w615 + bar1_e2_ddot * w629 + bar1_e3_ddot * w639
    w659 = w577 + (c113 + (w28 * w648 - w649 * (w654 - w17) - w651 * w657) - w658)
    w660 = w654 - w16
    w661 = bar1_z_ddot * bar1_mass + w33 * bar1_e0_ddot + bar1_e1_ddot * w618 + bar1_e2_ddot * w632 + bar1_e3_ddot * w641
    w662 = w567 + (w22 * w648 - w649 * (w655 + w656) - w651 * w660 - w661)
    w663 = w593 - w592
    w664 = w596 - w595
    w665 = w599 - w598
    w666 = w389 - w565
    w667 = w398 - w575
    w668 = w406 - w583
    w669 = w432 - w602 * (w332 * w663 + w335 * w664 + w331 * w665) - w433 * w666 - w434 * w667 - w435 * w668
    w670 = w423 - w602 * (w237 * w663 + w330 * w664 + w335 * w665) - w424 * w666 - w426 * w667 - w427 * w668
    w671 = w371 - w602 * (w331 * w663 + w237 * w664 + w245 * w665) - w376 * w666 - w391 * w667 - w400 * w668
    w672 = w412 - w602 * (w239 * w663 + w332 * w664 + w237 * w665) - w413 * w666 - w414 * w667 - w417 * w668
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    1020 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 129)
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
    c105 = c[105]
    c106 = c[106]
    c107 = c[107]
    c108 = c[108]
    c109 = c[109]
    c110 = c[110]
    c111 = c[111]
    c112 = c[112]
    c119 = c[119]
    # intermediate terms (253)
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = 2 * bar1_e0
    w3 = (w1 * bar1_e3 - bar1_e2 * w2) * c66
    w4 = bar1_e3 * -2.0
    w5 = (bar1_e3 * w2 + bar1_e2 * w1) * c66
    w6 = w4 * w5
    w7 = w0 * w3 - w6
    w8 = 2 * bar1_e3
    w9 = w3 * w8 - w0 * w5
    w10 = w2 * w3
    w11 = w10 - w1 * w5
    w12 = bar1_e1 * -2.0
    w13 = w3 * w12
    w14 = w2 * w5
    w15 = w13 - w14
    w16 = bar1_x_dot * bar1_mass + w7 * bar1_e0_dot + w9 * bar1_e1_dot + w11 * bar1_e2_dot + w15 * bar1_e3_dot
    w17 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c66
    w18 = w4 * w17 - w13
    w19 = w0 * w17
    w20 = w19 - w10
    w21 = w1 * w17 - w3 * w4
    w22 = w2 * w17
    w23 = 2 * bar1_e2
    w24 = w22 - w3 * w23
    w25 = bar1_y_dot * bar1_mass + bar1_e0_dot * w18 + bar1_e1_dot * w20 + bar1_e2_dot * w21 + bar1_e3_dot * w24
    w26 = w5 * w12 - w19
    w27 = w14 - w8 * w17
    w28 = w6 - w22
    w29 = w5 * w23 - w12 * w17
    w30 = bar1_z_dot * bar1_mass + bar1_e0_dot * w26 + bar1_e1_dot * w27 + bar1_e2_dot * w28 + bar1_e3_dot * w29
    w31 = bar1_x_dot * w7 + bar1_y_dot * w18 + bar1_z_dot * w26 + bar1_e0_dot * (w12 * (w12 * c68) + w0 * (w0 * c69) + w4 * (w4 * c70))
    w32 = w2 * c68
    w33 = w12 * w32 + bar1_e2 * bar1_e3 * c71
    w34 = w2 * c69
    w35 = w12 * c70
    w36 = w0 * w34 + bar1_e1 * bar1_e3 * c72
    w37 = w0 * c68
    w38 = w1 * c69
    w39 = w2 * c70
    w40 = bar1_e2 * bar1_e1 * c73 + w4 * w39
    w41 = bar1_x_dot * w16 + bar1_y_dot * w25 + bar1_z_dot * w30 + bar1_e0_dot * (w31 + bar1_e1_dot * w33 + bar1_e2_dot * w36 + bar1_e3_dot * w40)
    w42 = bar1_x_dot * w9 + bar1_y_dot * w20 + bar1_z_dot * w27 + bar1_e0_dot * w33 + bar1_e1_dot * (w2 * w32 + w4 * (w4 * c69) + w23 * (w23 * c70))
    w43 = bar1_e3 * bar1_e0 * c74 + w23 * w35
    w44 = w4 * w38 + bar1_e2 * bar1_e0 * c75
    w45 = bar1_x_dot * w11 + bar1_y_dot * w21 + bar1_z_dot * w28 + bar1_e0_dot * w36 + bar1_e1_dot * w43 + bar1_e2_dot * (w8 * (w8 * c68) + w2 * w34 + w12 * w35)
    w46 = w8 * w37 + bar1_e1 * bar1_e0 * c76
    w47 = w41 + bar1_e1_dot * (w42 + bar1_e2_dot * w43 + bar1_e3_dot * w44) + bar1_e2_dot * (w45 + bar1_e3_dot * w46)
    w48 = bar1_x_dot * w15 + bar1_y_dot * w24 + bar1_z_dot * w29 + bar1_e0_dot * w40 + bar1_e1_dot * w44 + bar1_e2_dot * w46
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = 2 * bar2_e2
    w52 = (w50 * bar2_e1 + w51 * bar2_e3) * c53
    w53 = bar2_e3 * -2.0
    w54 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c53
    w55 = w53 * w54
    w56 = w49 * w52 - w55
    w57 = 2 * bar2_e3
    w58 = w52 * w57 - w49 * w54
    w59 = w50 * w52
    w60 = 2 * bar2_e1
    w61 = w59 - w54 * w60
    w62 = bar2_e1 * -2.0
    w63 = w52 * w62
    w64 = w50 * w54
    w65 = w63 - w64
    w66 = bar2_x_dot * bar2_mass + w56 * bar2_e0_dot + w58 * bar2_e1_dot + w61 * bar2_e2_dot + w65 * bar2_e3_dot
    w67 = (bar2_e2 * w60 - w50 * bar2_e3) * c53
    w68 = w53 * w67 - w63
    w69 = w49 * w67
    w70 = w69 - w59
    w71 = w60 * w67 - w52 * w53
    w72 = w50 * w67
    w73 = w72 - w51 * w52
    w74 = bar2_y_dot * bar2_mass + bar2_e0_dot * w68 + bar2_e1_dot * w70 + bar2_e2_dot * w71 + bar2_e3_dot * w73
    w75 = w47 + bar1_e3_dot * (w48 + bar1_e3_dot * (w0 * w37 + w1 * w38 + w2 * w39)) + bar2_x_dot * w66 + bar2_y_dot * w74
    w76 = w54 * w62 - w69
    w77 = w64 - w57 * w67
    w78 = w55 - w72
    w79 = w51 * w54 - w62 * w67
    w80 = bar2_z_dot * bar2_mass + bar2_e0_dot * w76 + bar2_e1_dot * w77 + bar2_e2_dot * w78 + bar2_e3_dot * w79
    w81 = bar2_x_dot * w56 + bar2_y_dot * w68 + bar2_z_dot * w76 + bar2_e0_dot * (w62 * (w62 * c77) + w49 * (w49 * c78) + w53 * (w53 * c79))
    w82 = w50 * c77
    w83 = w62 * w82 + bar2_e2 * bar2_e3 * c80
    w84 = w50 * c78
    w85 = w62 * c79
    w86 = w49 * w84 + bar2_e1 * bar2_e3 * c81
    w87 = w49 * c77
    w88 = w60 * c78
    w89 = w50 * c79
    w90 = bar2_e2 * bar2_e1 * c82 + w53 * w89
    w91 = w75 + bar2_z_dot * w80 + bar2_e0_dot * (w81 + bar2_e1_dot * w83 + bar2_e2_dot * w86 + bar2_e3_dot * w90)
    w92 = bar2_x_dot * w58 + bar2_y_dot * w70 + bar2_z_dot * w77 + bar2_e0_dot * w83 + bar2_e1_dot * (w50 * w82 + w53 * (w53 * c78) + w51 * (w51 * c79))
    w93 = bar2_e0 * bar2_e3 * c83 + w51 * w85
    w94 = w53 * w88 + bar2_e2 * bar2_e0 * c84
    w95 = bar2_x_dot * w61 + bar2_y_dot * w71 + bar2_z_dot * w78 + bar2_e0_dot * w86 + bar2_e1_dot * w93 + bar2_e2_dot * (w57 * (w57 * c77) + w50 * w84 + w62 * w85)
    w96 = w57 * w87 + bar2_e0 * bar2_e1 * c85
    w97 = w91 + bar2_e1_dot * (w92 + bar2_e2_dot * w93 + bar2_e3_dot * w94) + bar2_e2_dot * (w95 + bar2_e3_dot * w96)
    w98 = bar2_x_dot * w65 + bar2_y_dot * w73 + bar2_z_dot * w79 + bar2_e0_dot * w90 + bar2_e1_dot * w94 + bar2_e2_dot * w96
    w99 = bar3_e2 * -2.0
    w100 = (1.0 - 2 * bar3_e1**2 - 2 * bar3_e2**2) * c4
    w101 = bar3_e3 * -2.0
    w102 = 2 * bar3_e2
    w103 = 2 * bar3_e0
    w104 = (bar3_e3 * w102 - bar3_e1 * w103) * c4
    w105 = w101 * w104
    w106 = w99 * w100 - w105
    w107 = 2 * bar3_e3
    w108 = w100 * w107 - w99 * w104
    w109 = w100 * w103
    w110 = 2 * bar3_e1
    w111 = w109 - w104 * w110
    w112 = bar3_e1 * -2.0
    w113 = w100 * w112
    w114 = w103 * w104
    w115 = w113 - w114
    w116 = bar3_x_dot * bar3_mass + w106 * bar3_e0_dot + w108 * bar3_e1_dot + w111 * bar3_e2_dot + w115 * bar3_e3_dot
    w117 = w97 + bar2_e3_dot * (w98 + bar2_e3_dot * (w49 * w87 + w60 * w88 + w50 * w89)) + bar3_x_dot * w116
    w118 = (bar3_e2 * w103 + bar3_e3 * w110) * c4
    w119 = w101 * w118 - w113
    w120 = w99 * w118
    w121 = w120 - w109
    w122 = w110 * w118 - w100 * w101
    w123 = w103 * w118
    w124 = w123 - w100 * w102
    w125 = bar3_y_dot * bar3_mass + bar3_e0_dot * w119 + bar3_e1_dot * w121 + bar3_e2_dot * w122 + bar3_e3_dot * w124
    w126 = w104 * w112 - w120
    w127 = w114 - w107 * w118
    w128 = w105 - w123
    w129 = w102 * w104 - w112 * w118
    w130 = bar3_z_dot * bar3_mass + bar3_e0_dot * w126 + bar3_e1_dot * w127 + bar3_e2_dot * w128 + bar3_e3_dot * w129
    w131 = bar3_x_dot * w106 + bar3_y_dot * w119 + bar3_z_dot * w126 + bar3_e0_dot * (w112 * (w112 * c22) + w99 * (w99 * c86) + w101 * (w101 * c87))
    w132 = w103 * c22
    w133 = w112 * w132 + bar3_e2 * bar3_e3 * c88
    w134 = w103 * c86
    w135 = w112 * c87
    w136 = w99 * w134 + bar3_e1 * bar3_e3 * c89
    w137 = w99 * c22
    w138 = w110 * c86
    w139 = w103 * c87
    w140 = bar3_e2 * bar3_e1 * c90 + w101 * w139
    w141 = w117 + bar3_y_dot * w125 + bar3_z_dot * w130 + bar3_e0_dot * (w131 + bar3_e1_dot * w133 + bar3_e2_dot * w136 + bar3_e3_dot * w140)
    w142 = bar3_x_dot * w108 + bar3_y_dot * w121 + bar3_z_dot * w127 + bar3_e0_dot * w133 + bar3_e1_dot * (w103 * w132 + w101 * (w101 * c86) + w102 * (w102 * c87))
    w143 = bar3_e3 * bar3_e0 * c91 + w102 * w135
    w144 = w101 * w138 + bar3_e2 * bar3_e0 * c92
    w145 = bar3_x_dot * w111 + bar3_y_dot * w122 + bar3_z_dot * w128 + bar3_e0_dot * w136 + bar3_e1_dot * w143
    w146 = w107 * w137 + bar3_e1 * bar3_e0 * c93
    w147 = bar3_e2_dot * (w145 + bar3_e2_dot * (w107 * (w107 * c22) + w103 * w134 + w112 * w135) + bar3_e3_dot * w146)
    w148 = bar3_x_dot * w115 + bar3_y_dot * w124 + bar3_z_dot * w129 + bar3_e0_dot * w140 + bar3_e1_dot * w144
    w149 = bar3_e3_dot * (w148 + bar3_e2_dot * w146 + bar3_e3_dot * (w99 * w137 + w110 * w138 + w103 * w139))
    w150 = bar4_e2 * -2.0
    w151 = 2 * bar4_e1
    w152 = 2 * bar4_e0
    w153 = (w151 * bar4_e3 - bar4_e2 * w152) * c60
    w154 = bar4_e3 * -2.0
    w155 = (bar4_e3 * w152 + bar4_e2 * w151) * c60
    w156 = w154 * w155
    w157 = w150 * w153 - w156
    w158 = 2 * bar4_e3
    w159 = w153 * w158 - w150 * w155
    w160 = w152 * w153
    w161 = w160 - w151 * w155
    w162 = bar4_e1 * -2.0
    w163 = w153 * w162
    w164 = w152 * w155
    w165 = w163 - w164
    w166 = bar4_x_dot * bar4_mass + w157 * bar4_e0_dot + w159 * bar4_e1_dot + w161 * bar4_e2_dot + w165 * bar4_e3_dot
    w167 = w141 + bar3_e1_dot * (w142 + bar3_e2_dot * w143 + bar3_e3_dot * w144) + w147 + w149 + bar4_x_dot * w166
    w168 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * c60
    w169 = w154 * w168 - w163
    w170 = w150 * w168
    w171 = w170 - w160
    w172 = w151 * w168 - w153 * w154
    w173 = w152 * w168
    w174 = 2 * bar4_e2
    w175 = w173 - w153 * w174
    w176 = bar4_y_dot * bar4_mass + bar4_e0_dot * w169 + bar4_e1_dot * w171 + bar4_e2_dot * w172 + bar4_e3_dot * w175
    w177 = w155 * w162 - w170
    w178 = w164 - w158 * w168
    w179 = w156 - w173
    w180 = w155 * w174 - w162 * w168
    w181 = bar4_z_dot * bar4_mass + bar4_e0_dot * w177 + bar4_e1_dot * w178 + bar4_e2_dot * w179 + bar4_e3_dot * w180
    w182 = bar4_x_dot * w157 + bar4_y_dot * w169 + bar4_z_dot * w177 + bar4_e0_dot * (w162 * (w162 * c94) + w150 * (w150 * c95) + w154 * (w154 * c96))
    w183 = w152 * c94
    w184 = w162 * w183 + bar4_e2 * bar4_e3 * c97
    w185 = w152 * c95
    w186 = w162 * c96
    w187 = w150 * w185 + bar4_e1 * bar4_e3 * c98
    w188 = w150 * c94
    w189 = w151 * c95
    w190 = w152 * c96
    w191 = bar4_e2 * bar4_e1 * c99 + w154 * w190
    w192 = w167 + bar4_y_dot * w176 + bar4_z_dot * w181 + bar4_e0_dot * (w182 + bar4_e1_dot * w184 + bar4_e2_dot * w187 + bar4_e3_dot * w191)
    w193 = bar4_x_dot * w159 + bar4_y_dot * w171 + bar4_z_dot * w178 + bar4_e0_dot * w184 + bar4_e1_dot * (w152 * w183 + w154 * (w154 * c95) + w174 * (w174 * c96))
    w194 = bar4_e3 * bar4_e0 * c100 + w174 * w186
    w195 = w154 * w189 + bar4_e2 * bar4_e0 * c101
    w196 = bar4_x_dot * w161 + bar4_y_dot * w172 + bar4_z_dot * w179 + bar4_e0_dot * w187 + bar4_e1_dot * w194
    w197 = w158 * w188 + bar4_e1 * bar4_e0 * c102
    w198 = bar4_e2_dot * (w196 + bar4_e2_dot * (w158 * (w158 * c94) + w152 * w185 + w162 * w186) + bar4_e3_dot * w197)
    w199 = bar4_x_dot * w165 + bar4_y_dot * w175 + bar4_z_dot * w180 + bar4_e0_dot * w191 + bar4_e1_dot * w195
    w200 = bar4_e3_dot * (w199 + bar4_e2_dot * w197 + bar4_e3_dot * (w150 * w188 + w151 * w189 + w152 * w190))
    w201 = bar5_e2 * -2.0
    w202 = 2 * bar5_e0
    w203 = 2 * bar5_e2
    w204 = (w202 * bar5_e1 + w203 * bar5_e3) * c63
    w205 = bar5_e3 * -2.0
    w206 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c63
    w207 = w205 * w206
    w208 = w201 * w204 - w207
    w209 = 2 * bar5_e3
    w210 = w204 * w209 - w201 * w206
    w211 = w202 * w204
    w212 = 2 * bar5_e1
    w213 = w211 - w206 * w212
    w214 = bar5_e1 * -2.0
    w215 = w204 * w214
    w216 = w202 * w206
    w217 = w215 - w216
    w218 = bar5_x_dot * bar5_mass + w208 * bar5_e0_dot + w210 * bar5_e1_dot + w213 * bar5_e2_dot + w217 * bar5_e3_dot
    w219 = w192 + bar4_e1_dot * (w193 + bar4_e2_dot * w194 + bar4_e3_dot * w195) + w198 + w200 + bar5_x_dot * w218
    w220 = (bar5_e2 * w212 - w202 * bar5_e3) * c63
    w221 = w205 * w220 - w215
    w222 = w201 * w220
    w223 = w222 - w211
    w224 = w212 * w220 - w204 * w205
    w225 = w202 * w220
    w226 = w225 - w203 * w204
    w227 = bar5_y_dot * bar5_mass + bar5_e0_dot * w221 + bar5_e1_dot * w223 + bar5_e2_dot * w224 + bar5_e3_dot * w226
    w228 = w206 * w214 - w222
    w229 = w216 - w209 * w220
    w230 = w207 - w225
    w231 = w203 * w206 - w214 * w220
    w232 = bar5_z_dot * bar5_mass + bar5_e0_dot * w228 + bar5_e1_dot * w229 + bar5_e2_dot * w230 + bar5_e3_dot * w231
    w233 = bar5_x_dot * w208 + bar5_y_dot * w221 + bar5_z_dot * w228 + bar5_e0_dot * (w214 * (w214 * c103) + w201 * (w201 * c105) + w205 * (w205 * c106))
    w234 = w202 * c103
    w235 = w214 * w234 + bar5_e2 * bar5_e3 * c107
    w236 = w202 * c105
    w237 = w214 * c106
    w238 = w201 * w236 + bar5_e1 * bar5_e3 * c108
    w239 = w201 * c103
    w240 = w212 * c105
    w241 = w202 * c106
    w242 = bar5_e2 * bar5_e1 * c109 + w205 * w241
    w243 = w219 + bar5_y_dot * w227 + bar5_z_dot * w232 + bar5_e0_dot * (w233 + bar5_e1_dot * w235 + bar5_e2_dot * w238 + bar5_e3_dot * w242)
    w244 = bar5_x_dot * w210 + bar5_y_dot * w223 + bar5_z_dot * w229 + bar5_e0_dot * w235 + bar5_e1_dot * (w202 * w234 + w205 * (w205 * c105) + w203 * (w203 * c106))
    w245 = bar5_e0 * bar5_e3 * c110 + w203 * w237
    w246 = w205 * w240 + bar5_e2 * bar5_e0 * c111
    w247 = bar5_x_dot * w213 + bar5_y_dot * w224 + bar5_z_dot * w230 + bar5_e0_dot * w238 + bar5_e1_dot * w245
    w248 = w209 * w239 + bar5_e0 * bar5_e1 * c112
    w249 = bar5_e2_dot * (w247 + bar5_e2_dot * (w209 * (w209 * c103) + w202 * w236 + w214 * w237) + bar5_e3_dot * w248)
    w250 = bar5_x_dot * w217 + bar5_y_dot * w226 + bar5_z_dot * w231 + bar5_e0_dot * w242 + bar5_e1_dot * w246
    w251 = bar5_e3_dot * (w250 + bar5_e2_dot * w248 + bar5_e3_dot * (w201 * w239 + w212 * w240 + w202 * w241))
    w252 = w5 + bar1_y * bar1_mass + (w54 + bar2_y * bar2_mass) + (w104 + bar3_y * bar3_mass) + (w155 + bar4_y * bar4_mass)
    # outputs
    kinetic = ca.vertcat((w243 + bar5_e1_dot * (w244 + bar5_e2_dot * w245 + bar5_e3_dot * w246) + w249 + w251) / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w252 + (w206 + bar5_y * bar5_mass)) * c119)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives measures (measures = 6) [mixed]: measures of the scene and their rates
    41 operations.
    """
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 129)
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
    c120 = c[120]
    c121 = c[121]
    # intermediate terms (2)
    w0 = bar3_e3 * bar3_e1_dot + (bar3_e1 * bar3_e3_dot + (bar3_e0 * bar3_e2_dot + bar3_e2 * bar3_e0_dot))
    w1 = (bar3_e2 * bar3_e3_dot + bar3_e3 * bar3_e2_dot - bar3_e0 * bar3_e1_dot - bar3_e1 * bar3_e0_dot) * c120
    # outputs
    measures = ca.vertcat(
        bar3_x + (bar3_e0 * bar3_e2 + bar3_e1 * bar3_e3) * c120,  # P3_x
        bar3_x_dot + w0 * c120,  # P3_x_dot
        bar3_y + (bar3_e2 * bar3_e3 - bar3_e0 * bar3_e1) * c120,  # P3_y
        bar3_y_dot + w1,  # P3_y_dot
        bar3_end_z + bar3_z - bar3_e2**2 * c120 - bar3_e1**2 * c120,  # P3_z
        bar3_z_dot - bar3_e2 * bar3_e2_dot * c121 - bar3_e1 * bar3_e1_dot * c121,  # P3_z_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 5) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    130 operations.
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
    # intermediate terms (55)
    w0 = 2 * bar1_e2**2
    w1 = 2 * bar1_e3**2
    w2 = 2 * bar1_e0
    w3 = bar1_e3 * w2
    w4 = 2 * bar1_e1
    w5 = bar1_e2 * w4
    w6 = bar1_e3 * w4
    w7 = bar1_e2 * w2
    w8 = 1.0 - 2 * bar1_e1**2
    w9 = w2 * bar1_e1
    w10 = bar1_e3 * (2 * bar1_e2)
    w11 = 2 * bar2_e2**2
    w12 = 2 * bar2_e3**2
    w13 = 2 * bar2_e0
    w14 = bar2_e3 * w13
    w15 = 2 * bar2_e1
    w16 = bar2_e2 * w15
    w17 = bar2_e3 * w15
    w18 = bar2_e2 * w13
    w19 = 1.0 - 2 * bar2_e1**2
    w20 = w13 * bar2_e1
    w21 = bar2_e3 * (2 * bar2_e2)
    w22 = 2 * bar3_e2**2
    w23 = 2 * bar3_e3**2
    w24 = 2 * bar3_e0
    w25 = bar3_e3 * w24
    w26 = 2 * bar3_e1
    w27 = bar3_e2 * w26
    w28 = bar3_e3 * w26
    w29 = bar3_e2 * w24
    w30 = 1.0 - 2 * bar3_e1**2
    w31 = w24 * bar3_e1
    w32 = bar3_e3 * (2 * bar3_e2)
    w33 = 2 * bar4_e2**2
    w34 = 2 * bar4_e3**2
    w35 = 2 * bar4_e0
    w36 = bar4_e3 * w35
    w37 = 2 * bar4_e1
    w38 = bar4_e2 * w37
    w39 = bar4_e3 * w37
    w40 = bar4_e2 * w35
    w41 = 1.0 - 2 * bar4_e1**2
    w42 = w35 * bar4_e1
    w43 = bar4_e3 * (2 * bar4_e2)
    w44 = 2 * bar5_e2**2
    w45 = 2 * bar5_e3**2
    w46 = 2 * bar5_e0
    w47 = bar5_e3 * w46
    w48 = 2 * bar5_e1
    w49 = bar5_e2 * w48
    w50 = bar5_e3 * w48
    w51 = bar5_e2 * w46
    w52 = 1.0 - 2 * bar5_e1**2
    w53 = w46 * bar5_e1
    w54 = bar5_e3 * (2 * bar5_e2)
    # outputs
    poses = ca.vertcat(
        ca.horzcat(bar1_x, bar2_x, bar3_x, bar4_x, bar5_x),
        ca.horzcat(bar1_y, bar2_y, bar3_y, bar4_y, bar5_y),
        ca.horzcat(bar1_z, bar2_z, bar3_z, bar4_z, bar5_z),
        ca.horzcat(1.0 - w0 - w1, 1.0 - w11 - w12, 1.0 - w22 - w23, 1.0 - w33 - w34, 1.0 - w44 - w45),
        ca.horzcat(w3 + w5, w14 + w16, w25 + w27, w36 + w38, w47 + w49),
        ca.horzcat(w6 - w7, w17 - w18, w28 - w29, w39 - w40, w50 - w51),
        ca.horzcat(w5 - w3, w16 - w14, w27 - w25, w38 - w36, w49 - w47),
        ca.horzcat(w8 - w1, w19 - w12, w30 - w23, w41 - w34, w52 - w45),
        ca.horzcat(w9 + w10, w20 + w21, w31 + w32, w42 + w43, w53 + w54),
        ca.horzcat(w6 + w7, w17 + w18, w28 + w29, w39 + w40, w50 + w51),
        ca.horzcat(w10 - w9, w21 - w20, w32 - w31, w43 - w42, w54 - w53),
        ca.horzcat(w8 - w0, w19 - w11, w30 - w22, w41 - w33, w52 - w44),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    1606 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 129)
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
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    663 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 129)
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
    c122 = c[122]
    c123 = c[123]
    c124 = c[124]
    # intermediate terms (177)
    w0 = ca.cos(hinge0_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.sin(hinge1_angle)
    w3 = w0 * w2
    w4 = ca.cos(hinge2_angle)
    w5 = ca.sin(hinge0_angle)
    w6 = (w1 * w3 + w4 * w5) * bar3_end_z
    w7 = w6 - w3 * bar2_end_y
    w8 = w2 * w5
    w9 = (w0 * w4 - w1 * w8) * bar3_end_z
    w10 = w8 * bar2_end_y + w9
    w11 = w0 * w7 - w5 * w10
    w12 = ca.sin(hinge5_angle)
    w13 = ca.cos(hinge4_angle)
    w14 = w13 * bar4_end_x
    w15 = w12 * w14
    w16 = ca.cos(hinge1_angle)
    w17 = w5 * w16
    w18 = ca.cos(hinge5_angle)
    w19 = w13 * w18
    w20 = w17 * w19
    w21 = w12 * w13
    w22 = w2 * w21
    w23 = w20 - w22
    w24 = w0 * w16
    w25 = w21 * w24
    w26 = ca.sin(hinge4_angle)
    w27 = w17 * w26
    w28 = w25 - w27
    w29 = w19 * w24
    w30 = w2 * w26
    w31 = w29 - w30
    w32 = w23 * w24 + w2 * w28 - w17 * w31
    w33 = w1 * w16 * bar3_end_z
    w34 = w24 * w33 + w2 * w6
    w35 = w27 - w25
    w36 = w30 - w29
    w37 = w12 * w35 + w18 * w36
    w38 = w15 * w32 - w34 * w37
    w39 = w6 * w17 + w9 * w24
    w40 = w16 * bar2_end_y - w33
    w41 = w5 * w40
    w42 = w5 * w23 + w0 * w31
    w43 = w37 * w41 + w15 * w42
    w44 = w14 * w18
    w45 = w32 * w41 + w34 * w42
    w46 = w11 * w38 + w39 * w43 + w44 * w45
    w47 = w10 - w5 * bar1_end_x
    w48 = w2 * w9 - w17 * w33
    w49 = w12 * w26 * bar4_end_x
    w50 = w18 * w26 * bar4_end_x
    w51 = w26 * bar4_end_x
    w52 = w44 * w48 + w39 * w51
    w53 = w0 * w40
    w54 = w44 * w53 + w11 * w51
    w55 = w39 * w53 - w11 * w48
    w56 = w42 * w52 + w32 * w54 + w37 * w55
    w57 = w7 + w0 * bar1_end_x
    w58 = w41 * w52 - w34 * w54 - w15 * w55
    w59 = w22 - w20
    w60 = w50 - w18 * bar5_end_y
    w61 = w15 * w59 - w37 * w60
    w62 = w32 * w60 - w34 * w59
    w63 = w12 * bar5_end_y - w49
    w64 = w39 * w61 - w44 * w62 + w38 * w63
    w65 = w41 * w59 + w42 * w60
    w66 = w43 * w63 - (w11 * w61 + w44 * w65)
    w67 = w11 * w62 + w39 * w65 + w45 * w63
    w68 = w53 * w64 + w48 * w66 - w51 * w67
    w69 = (w46 * w47 - w56 * w57 - w28 * w58) / w68
    w70 = 2 * -hinge4_angle_dot
    w71 = w18 * hinge5_angle_dot
    w72 = w13 * hinge4_angle_dot
    w73 = (w12 * w72 + w26 * w71) * bar4_end_x
    w74 = w12 * hinge5_angle_dot
    w75 = (w18 * w72 - w26 * w74) * bar4_end_x
    w76 = w48 * w63
    w77 = w53 * w63
    w78 = w42 * w76 + w32 * w77 + w55 * w59
    w79 = w41 * w76 - w34 * w77 - w55 * w60
    w80 = (w57 * w78 - w47 * w67 + w28 * w79) / w68
    w81 = w16 * hinge1_angle_dot
    w82 = w0 * hinge0_angle_dot
    w83 = w5 * w81 + w2 * w82
    w84 = w1 * hinge2_angle_dot
    w85 = w5 * hinge0_angle_dot
    w86 = w4 * hinge2_angle_dot
    w87 = (w0 * w84 + w4 * w85 + (w8 * w86 + w1 * w83)) * bar3_end_z
    w88 = w83 * bar2_end_y - w87
    w89 = w2 * hinge1_angle_dot
    w90 = (w16 * w86 - w1 * w89) * bar3_end_z
    w91 = w89 * bar2_end_y + w90
    w92 = w51 * w63
    w93 = w32 * w92 - w37 * w76 + w52 * w59
    w94 = w34 * w92 - w15 * w76 + w52 * w60
    w95 = (w47 * w64 - w57 * w93 + w28 * w94) / w68
    w96 = w16 * w82 - w5 * w89
    w97 = w42 * w92 + w37 * w77 - w54 * w59
    w98 = w15 * w77 - w41 * w92 - w54 * w60
    w99 = (w57 * w97 - w47 * w66 - w28 * w98) / w68
    w100 = w88 - w82 * bar1_end_x + (w40 * w85 + w0 * w91) * w95 + (w9 * w81 - w2 * w87 - (w33 * w96 + w17 * w90)) * w99
    w101 = (w49 * w71 + w12 * w73 + (w18 * w75 - w50 * w74)) * w80 - w100
    w102 = w0 * w81 - w2 * w85
    w103 = (w3 * w86 + w1 * w102 + (w4 * w82 - w5 * w84)) * bar3_end_z
    w104 = w0 * w89 + w16 * w85
    w105 = w103 - w102 * bar2_end_y
    w106 = w99 * (w6 * w96 + w17 * w103 - (w9 * w104 + w24 * w87)) - w95 * (w0 * w105 - w7 * w85 - (w10 * w82 + w5 * w88))
    w107 = w26 * hinge4_angle_dot
    w108 = w107 * bar4_end_x
    w109 = w106 - w80 * (w14 * w74 + w18 * w108) + w69 * (w71 * bar5_end_y - w73)
    w110 = w105 - w85 * bar1_end_x - w95 * (w40 * w82 - w5 * w91) + w99 * (w24 * w90 - w33 * w104 + (w6 * w81 + w2 * w103))
    w111 = w110 - w80 * (w14 * w71 - w12 * w108) - w69 * (w75 + w74 * bar5_end_y)
    w112 = w13 * w71 - w12 * w107
    w113 = w24 * w112 - w21 * w104
    w114 = w26 * w96 + w17 * w72
    w115 = w113 - w114
    w116 = w18 * w107 + w13 * w74
    w117 = w19 * w96 - w17 * w116
    w118 = w21 * w81 + w2 * w112
    w119 = w117 - w118
    w120 = w19 * w104 + w24 * w116 + (w26 * w81 + w2 * w72)
    w121 = w115 + w95 * (w5 * w119 + w23 * w82 - (w0 * w120 + w31 * w85)) + w99 * (w24 * w119 - w23 * w104 + (w2 * w115 + w28 * w81) - (w31 * w96 - w17 * w120))
    w122 = w121 - w80 * (w12 * (w114 - w113) + w35 * w71 + (w18 * w120 - w36 * w74)) - w69 * (w118 - w117)
    w123 = (w26 * c19 + (c20 + (c15 - w13 * (w13 * c17)))) * (2 * -((w46 * w101 + (w38 * w53 + w43 * w48 - w45 * w51) * w109 + w56 * w111 + w58 * w122) / w68))
    w124 = w2 * hinge0_angle_dot
    w125 = 2 * (hinge2_angle_dot + w124)
    w126 = w125 * c0
    w127 = w125 * c1
    w128 = w1 * (w126 - w127)
    w129 = w4 * w128
    w130 = w125 * c4
    w131 = w4 * w130
    w132 = w131 * bar2_end_y
    w133 = w129 - w132
    w134 = w16 * hinge0_angle_dot
    w135 = 2 * -(w4 * w134 + w1 * hinge1_angle_dot)
    w136 = w135 * c4
    w137 = w1 * c4
    w138 = hinge1_angle_dot * c122
    w139 = w137 * w138
    w140 = w135 * c0
    w141 = w1 * w140
    w142 = 2 * (w4 * hinge1_angle_dot - w1 * w134)
    w143 = w142 * c1
    w144 = w4 * w143
    w145 = 2 * hinge1_angle_dot
    w146 = w16 * (w16 * w133 - w2 * (w136 * bar2_end_y - w139 - (w141 - w144) + w145 * c123))
    w147 = w4 * c4
    w148 = w124 * c122
    w149 = w147 * w148
    w150 = hinge0_angle_dot * c9
    w151 = w133 - w146 + (w2 * w131 - w16 * (w136 + w145 * c8)) * bar1_end_x + (w146 - (w146 - (w149 - w129)) - w147 * w150)
    w152 = 2 * -(w13 * hinge5_angle_dot)
    w153 = 2 * -(w26 * hinge5_angle_dot)
    w154 = w69 * (w69 * (w13 * (w26 * (w70 * c17)) + w13 * (w70 * c14) * bar5_end_y) - w123) - w151 + w80 * (w69 * (w26 * (w152 * c15) - w13 * (w153 * c16) + w152 * c18))
    w155 = w69 * (w26 * (w152 * c16) - w13 * (w153 * c15) - hinge5_angle_dot * c124 * (w13 * c14)) - 2 * ((w67 * w101 + w109 * (w53 * w62 + w48 * w65) + w78 * w111 + w79 * w122) / w68) * c21
    w156 = w137 * bar2_end_y
    w157 = w156 - c22
    w158 = 2 * ((w66 * w101 - w109 * (w53 * w61 - w51 * w65) + w97 * w111 - w98 * w122) / w68)
    w159 = w142 * c0
    w160 = w135 * c1
    w161 = w154 + w80 * w155 - (w137 * bar1_end_x - w2 * w157) * w158 - w99 * (w16 * (w4 * w159 - w1 * w160) - w2 * w132 + w131 * bar1_end_x)
    w162 = w4 * c2
    w163 = w147 * bar2_end_y - w1 * w162
    w164 = 2 * ((w94 * w122 - (w64 * w101 + w109 * (w48 * w61 + w51 * w62) + w93 * w111)) / w68)
    w165 = w161 - w99 * (w16 * (w144 - w141 - w139) + w2 * w149 - w150 * (w2 * w147) + w158 * c22) + w16 * w163 * w164
    w166 = w4 * w162
    w167 = c1 + w166
    w168 = 2 * -w124
    w169 = w1 * w128
    w170 = c5 + (c0 - w166 - 2 * w156)
    w171 = 2 * w134
    w172 = w4 * w140 + w1 * w143 + w138 * w147
    w173 = c8 - w137
    w174 = w16 * ((c6 + w167) * w168 - (w169 - w126)) + w2 * ((w167 + w170) * w171 + w172) - w171 * w173 * bar1_end_x
    w175 = w2 * (w171 * c6) - w16 * (w127 + w169 - (w1 * w130 * bar2_end_y + w137 * w148) - w168 * c5) + w150 * (w16 * w173)
    w176 = w175 + w99 * (w4 * w160 + w1 * w159 - w142 * c23) + w164 * (c6 + w170) + w95 * (w133 - w163 * w168)
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w165 - w95 * (w174 + w99 * (w172 - w157 * w171)) - w95 * w176)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1892 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 129)
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
    c2 = c[2]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    c9 = c[9]
    bar3_end_z = c[11]
    bar4_end_x = c[12]
    bar5_end_y = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    gravity_y = c[24]
    c25 = c[25]
    c122 = c[122]
    c124 = c[124]
    c125 = c[125]
    c126 = c[126]
    c127 = c[127]
    c128 = c[128]
    # intermediate terms (485)
    w0 = ca.cos(hinge0_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.sin(hinge1_angle)
    w3 = w0 * w2
    w4 = ca.cos(hinge2_angle)
    w5 = ca.sin(hinge0_angle)
    w6 = (w1 * w3 + w4 * w5) * bar3_end_z
    w7 = w3 * bar2_end_y
    w8 = w6 - w7
    w9 = w2 * w5
    w10 = w9 * bar2_end_y
    w11 = (w0 * w4 - w1 * w9) * bar3_end_z
    w12 = w10 + w11
    w13 = w0 * w8 - w5 * w12
    w14 = ca.sin(hinge5_angle)
    w15 = ca.cos(hinge4_angle)
    w16 = w15 * bar4_end_x
    w17 = w14 * w16
    w18 = ca.cos(hinge1_angle)
    w19 = w5 * w18
    w20 = ca.cos(hinge5_angle)
    w21 = w15 * w20
    w22 = w19 * w21
    w23 = w14 * w15
    w24 = w2 * w23
    w25 = w22 - w24
    w26 = w0 * w18
    w27 = w23 * w26
    w28 = ca.sin(hinge4_angle)
    w29 = w19 * w28
    w30 = w27 - w29
    w31 = w21 * w26
    w32 = w2 * w28
    w33 = w31 - w32
    w34 = w25 * w26 + w2 * w30 - w19 * w33
    w35 = w1 * w18 * bar3_end_z
    w36 = w26 * w35 + w2 * w6
    w37 = w29 - w27
    w38 = w32 - w31
    w39 = w14 * w37 + w20 * w38
    w40 = w17 * w34 - w36 * w39
    w41 = w6 * w19 + w11 * w26
    w42 = w18 * bar2_end_y
    w43 = w42 - w35
    w44 = w5 * w43
    w45 = w5 * w25 + w0 * w33
    w46 = w39 * w44 + w17 * w45
    w47 = w16 * w20
    w48 = w34 * w44 + w36 * w45
    w49 = w47 * w48
    w50 = w13 * w40 + w41 * w46 + w49
    w51 = w5 * bar1_end_x
    w52 = w12 - w51
    w53 = w2 * w11 - w19 * w35
    w54 = w14 * w28
    w55 = w54 * bar4_end_x
    w56 = w20 * w28
    w57 = w56 * bar4_end_x
    w58 = w28 * bar4_end_x
    w59 = w47 * w53 + w41 * w58
    w60 = w0 * w43
    w61 = w47 * w60 + w13 * w58
    w62 = w41 * w60 - w13 * w53
    w63 = w39 * w62
    w64 = w45 * w59 + w34 * w61 + w63
    w65 = w0 * bar1_end_x
    w66 = w8 + w65
    w67 = w17 * w62
    w68 = w44 * w59 - w36 * w61 - w67
    w69 = w24 - w22
    w70 = w20 * bar5_end_y
    w71 = w57 - w70
    w72 = w17 * w69 - w39 * w71
    w73 = w41 * w72
    w74 = w34 * w71 - w36 * w69
    w75 = w14 * bar5_end_y
    w76 = w75 - w55
    w77 = w73 - w47 * w74 + w40 * w76
    w78 = w13 * w72
    w79 = w44 * w69 + w45 * w71
    w80 = w46 * w76 - (w78 + w47 * w79)
    w81 = w48 * w76
    w82 = w13 * w74 + w41 * w79 + w81
    w83 = w60 * w77 + w53 * w80 - w58 * w82
    w84 = (w50 * w52 - w64 * w66 - w30 * w68) / w83
    w85 = w28 * c14
    w86 = w85 * c125 + (c20 + (c15 - w15 * (w15 * c17)))
    w87 = w5 * hinge0_angle_dot
    w88 = w2 * hinge1_angle_dot
    w89 = w88 * bar2_end_y
    w90 = w4 * hinge2_angle_dot
    w91 = w18 * w90 - w1 * w88
    w92 = w91 * bar3_end_z
    w93 = w89 + w92
    w94 = w43 * w87 + w0 * w93
    w95 = w58 * w76
    w96 = w36 * w95
    w97 = w53 * w76
    w98 = w96 - w17 * w97 + w59 * w71
    w99 = w20 * hinge5_angle_dot
    w100 = w28 * hinge4_angle_dot
    w101 = w15 * w99 - w14 * w100
    w102 = w0 * w88 + w18 * w87
    w103 = w26 * w101 - w23 * w102
    w104 = w0 * hinge0_angle_dot
    w105 = w18 * w104 - w5 * w88
    w106 = w15 * hinge4_angle_dot
    w107 = w28 * w105 + w19 * w106
    w108 = w103 - w107
    w109 = w14 * hinge5_angle_dot
    w110 = w20 * w100 + w15 * w109
    w111 = w21 * w105 - w19 * w110
    w112 = w18 * hinge1_angle_dot
    w113 = w23 * w112 + w2 * w101
    w114 = w111 - w113
    w115 = w21 * w102 + w26 * w110 + (w28 * w112 + w2 * w106)
    w116 = w5 * w114 + w25 * w104 - (w0 * w115 + w33 * w87)
    w117 = w34 * w95
    w118 = w117 - w39 * w97 + w59 * w69
    w119 = (w52 * w77 - w66 * w118 + w30 * w98) / w83
    w120 = w26 * w114 - w25 * w102 + (w2 * w108 + w30 * w112) - (w33 * w105 - w19 * w115)
    w121 = w45 * w95
    w122 = w60 * w76
    w123 = w121 + w39 * w122 - w61 * w69
    w124 = w44 * w95
    w125 = w17 * w122 - w124 - w61 * w71
    w126 = (w66 * w123 - w52 * w80 - w30 * w125) / w83
    w127 = w107 - w103
    w128 = w14 * w127 + w37 * w99 + (w20 * w115 - w38 * w109)
    w129 = w62 * w69
    w130 = w45 * w97 + w34 * w122 + w129
    w131 = w62 * w71
    w132 = w44 * w97 - w36 * w122 - w131
    w133 = (w66 * w130 - w52 * w82 + w30 * w132) / w83
    w134 = w113 - w111
    w135 = w108 + w116 * w119 + w120 * w126 - w128 * w133 - w84 * w134
    w136 = w14 * w106 + w28 * w99
    w137 = w136 * bar4_end_x
    w138 = (w20 * w106 - w28 * w109) * bar4_end_x
    w139 = w55 * w99 + w14 * w137 + (w20 * w138 - w57 * w109)
    w140 = w5 * w112 + w2 * w104
    w141 = w1 * hinge2_angle_dot
    w142 = (w0 * w141 + w4 * w87 + (w9 * w90 + w1 * w140)) * bar3_end_z
    w143 = w140 * bar2_end_y - w142
    w144 = w11 * w112 - w2 * w142 - (w35 * w105 + w19 * w92)
    w145 = w133 * w139 - (w143 - w104 * bar1_end_x + w94 * w119 + w126 * w144)
    w146 = w53 * w72
    w147 = w146 + w58 * w74
    w148 = w0 * w112 - w2 * w87
    w149 = w3 * w90 + w1 * w148 + (w4 * w104 - w5 * w141)
    w150 = w149 * bar3_end_z
    w151 = w6 * w105 + w19 * w150 - (w11 * w102 + w26 * w142)
    w152 = w150 - w148 * bar2_end_y
    w153 = w0 * w152 - w8 * w87 - (w12 * w104 + w5 * w143)
    w154 = w100 * bar4_end_x
    w155 = w16 * w109 + w20 * w154
    w156 = w99 * bar5_end_y - w137
    w157 = w126 * w151 - w119 * w153 - w133 * w155 + w84 * w156
    w158 = w43 * w104 - w5 * w93
    w159 = w26 * w92 - w35 * w102 + (w6 * w112 + w2 * w150)
    w160 = w16 * w99 - w14 * w154
    w161 = w138 + w109 * bar5_end_y
    w162 = w152 - w87 * bar1_end_x - w119 * w158 + w126 * w159 - w133 * w160 - w84 * w161
    w163 = (w98 * w135 - (w77 * w145 + w147 * w157 + w118 * w162)) / w83
    w164 = w5 * hinge1_angle_dot
    w165 = hinge0_angle_dot * w164
    w166 = w42 * w164 + w7 * hinge0_angle_dot
    w167 = w0 * hinge1_angle_dot
    w168 = w42 * w165 - hinge0_angle_dot * (w65 * hinge0_angle_dot) + (hinge0_angle_dot * w166 + w89 * w167)
    w169 = w26 * hinge2_angle_dot
    w170 = w19 * hinge2_angle_dot
    w171 = hinge2_angle_dot * w112
    w172 = w2 * hinge2_angle_dot
    w173 = w164 * w172 - hinge0_angle_dot * w169 - w165
    w174 = hinge0_angle_dot + w172
    w175 = w164 + w169
    w176 = w35 * w175 + w6 * w174
    w177 = w167 - w170
    w178 = w6 * w177 - w11 * w175
    w179 = w20 * hinge4_angle_dot
    w180 = hinge5_angle_dot * w179
    w181 = w14 * hinge4_angle_dot
    w182 = hinge5_angle_dot * w181
    w183 = w57 * hinge5_angle_dot + w16 * w181
    w184 = w16 * w179 - w55 * hinge5_angle_dot
    w185 = w168 + (w11 * w171 + w35 * w173) - (w174 * w176 + w177 * w178) - (w55 * w180 - w57 * w182 + (w181 * w183 + w179 * w184))
    w186 = hinge0_angle_dot * w167
    w187 = w10 * hinge0_angle_dot - w42 * w167
    w188 = w186 - (hinge0_angle_dot * w170 + w167 * w172)
    w189 = w11 * w174 + w35 * w177
    w190 = w7 * w165 - w10 * w186 + (w167 * w187 - w164 * w166) + (w6 * w173 - w11 * w188) + (w177 * w189 + w175 * w176)
    w191 = hinge5_angle_dot * (w70 * hinge5_angle_dot) - w16 * w182 - (w154 * w179 + hinge5_angle_dot * w183)
    w192 = w190 - w191
    w193 = hinge0_angle_dot * (w51 * hinge0_angle_dot) + w42 * w186 - (w89 * w164 + hinge0_angle_dot * w187)
    w194 = w154 * w181 - hinge5_angle_dot * w184 - (hinge5_angle_dot * (w75 * hinge5_angle_dot) + w16 * w180)
    w195 = w193 - (w35 * w188 + w6 * w171) + (w175 * w178 - w174 * w189) - w194
    w196 = w21 * hinge5_angle_dot
    w197 = w28 * w181 - w196
    w198 = w28 * w179 + w23 * hinge5_angle_dot
    w199 = w2 * (hinge5_angle_dot * w197 - w106 * w179) - w26 * (w181 * w197 + w179 * w198) - w19 * (hinge5_angle_dot * w198 + w106 * w181)
    w200 = w2 * w175 - w26 * w174
    w201 = w26 * w177 + w19 * w175
    w202 = w19 * w174 + w2 * w177
    w203 = w199 + w28 * (w174 * w200 - w177 * w201) - w21 * (w177 * w202 + w175 * w200) - w23 * (w175 * w201 + w174 * w202)
    w204 = w203 + w106 * (2 * -w202) - w198 * (2 * w201) + w197 * (2 * w200) + w25 * w188 + w30 * w171 + w33 * w173
    w205 = w37 * w180 - w204 - w38 * w182
    w206 = (w77 * w185 + w147 * w192 + w118 * w195 - w98 * w205) / w83 + w119 * hinge0_angle_ddot
    w207 = w18 * w206 - hinge1_angle_dot * w88
    w208 = w0 * hinge0_angle_ddot - hinge0_angle_dot * w87
    w209 = w2 * w208 + (w5 * w207 + hinge1_angle_dot * (w26 * hinge0_angle_dot) * c126)
    w210 = w60 * w72
    w211 = w210 - w58 * w79
    w212 = (w192 * w211 - w80 * w185 - w123 * w195 + w125 * w205) / w83 + w126 * hinge0_angle_ddot
    w213 = hinge2_angle_dot * w90 + w1 * w212
    w214 = w87 * w141
    w215 = hinge0_angle_dot * w104 + w5 * hinge0_angle_ddot
    w216 = w4 * w212 - hinge2_angle_dot * w141
    w217 = (w0 * w213 - w214 + (w4 * w215 - w214) + (w1 * w209 + (w9 * w216 + w90 * w140 * c126))) * bar3_end_z
    w218 = w209 * bar2_end_y - w217
    w219 = w87 * w93
    w220 = hinge1_angle_dot * w112 + w2 * w206
    w221 = w88 * w90
    w222 = (w18 * w216 - w221 - (w221 + w1 * w220)) * bar3_end_z
    w223 = w220 * bar2_end_y + w222
    w224 = (w80 * w145 - w157 * w211 + w123 * w162 - w125 * w135) / w83
    w225 = 2 * -w94 * w163 - (w218 - w208 * bar1_end_x) - w119 * (w43 * w215 - w219 + (w0 * w223 - w219)) + 2 * -w144 * w224
    w226 = w112 * w142
    w227 = w88 * w104
    w228 = w18 * w208 - w227 - (w227 + w5 * w220)
    w229 = w126 * (w11 * w207 - w226 - (w226 + w2 * w217) - (w19 * w222 + (w35 * w228 + w91 * w105 * c127)))
    w230 = w60 * w74 + w53 * w79
    w231 = (w82 * w145 + w157 * w230 + w130 * w162 + w132 * w135) / w83
    w232 = w48 * w58
    w233 = w40 * w60 + w46 * w53 - w232
    w234 = (w50 * w185 + w192 * w233 + w64 * w195 + w68 * w205) / w83 + w84 * hinge0_angle_ddot
    w235 = w20 * w234 - hinge5_angle_dot * w109
    w236 = w133 * hinge0_angle_ddot - (w82 * w185 + w192 * w230 + w130 * w195 + w132 * w205) / w83
    w237 = w15 * w236 - hinge4_angle_dot * w100
    w238 = (w28 * w235 + (w14 * w237 + hinge4_angle_dot * w196 * c126)) * bar4_end_x
    w239 = w106 * w109
    w240 = hinge5_angle_dot * w99 + w14 * w234
    w241 = (w20 * w237 - w239 - (w239 + w28 * w240)) * bar4_end_x
    w242 = w109 * w138
    w243 = w133 * (w14 * w238 + (w55 * w235 + w99 * w136 * c128) + (w20 * w241 - w242 - (w242 + w57 * w240)))
    w244 = w225 - w229 + 2 * w139 * w231 + w243
    w245 = w87 * w112
    w246 = w0 * w207 - w245 - (w245 + w2 * w215)
    w247 = w104 * w141
    w248 = (w1 * w246 + (w3 * w216 + w90 * w148 * c126) + (w4 * w208 - w247 - (w247 + w5 * w213))) * bar3_end_z
    w249 = w248 - w246 * bar2_end_y
    w250 = w87 * w152
    w251 = w163 * (2 * -w153) - w119 * (w0 * w249 - w250 - (w250 + w8 * w215) - (w5 * w218 + (w12 * w208 + w104 * w143 * c126)))
    w252 = w87 * w88
    w253 = w0 * w220 - w252 + (w18 * w215 - w252)
    w254 = w102 * w142
    w255 = w126 * (w19 * w248 + (w6 * w228 + w105 * w149 * c127) - (w11 * w253 - w254 + (w26 * w217 - w254)))
    w256 = w109 * w154
    w257 = hinge4_angle_dot * w106 + w28 * w236
    w258 = w257 * bar4_end_x
    w259 = w251 + w224 * (2 * w151) + w255 + w231 * (2 * -w155) - w133 * (w16 * w240 - w256 + (w20 * w258 - w256))
    w260 = (w50 * w145 + w157 * w233 + w64 * w162 + w68 * w135) / w83
    w261 = w259 - 2 * w156 * w260 + w84 * (w235 * bar5_end_y - w238)
    w262 = w93 * w104
    w263 = w249 - w215 * bar1_end_x + w163 * (2 * -w158) - w119 * (w43 * w208 - w262 - (w262 + w5 * w223)) + w224 * (2 * w159)
    w264 = w92 * w102
    w265 = w126 * (w26 * w222 - w264 - (w264 + w35 * w253) + (w2 * w248 + (w6 * w207 + w112 * w149 * c127)))
    w266 = w99 * w154
    w267 = w263 + w265 + w231 * (2 * -w160) - w133 * (w16 * w235 - w266 - (w266 + w14 * w258)) - w260 * (2 * -w161)
    w268 = w267 - w84 * (w241 + w240 * bar5_end_y)
    w269 = w99 * w100
    w270 = w15 * w235 - w269 - (w269 + w14 * w257)
    w271 = w101 * w102
    w272 = w26 * w270 - w271 - (w271 + w23 * w253)
    w273 = w19 * w237 + (w28 * w228 + w105 * w106 * c126)
    w274 = w272 - w273
    w275 = w105 * w110
    w276 = w100 * w109
    w277 = w20 * w257 - w276 + (w15 * w240 - w276)
    w278 = w21 * w228 - w275 - (w275 + w19 * w277)
    w279 = w2 * w270 + (w23 * w207 + w101 * w112 * c126)
    w280 = w278 - w279
    w281 = w102 * w110
    w282 = w21 * w253 - w281 + (w26 * w277 - w281) + (w2 * w237 + (w28 * w207 + hinge4_angle_dot * (hinge1_angle_dot * (w15 * w18)) * c126))
    w283 = w87 * w115
    w284 = w119 * (w25 * w208 + (w5 * w280 + w104 * w114 * c126) - (w0 * w282 - w283 + (w33 * w215 - w283)))
    w285 = w102 * w114
    w286 = w105 * w115
    w287 = w26 * w280 - w285 - (w285 + w25 * w253) + (w30 * w207 + (w2 * w274 + w108 * w112 * c126)) - (w33 * w228 - w286 - (w286 + w19 * w282))
    w288 = w109 * w115
    w289 = w37 * w235 + (w14 * (w273 - w272) + w99 * w127 * c126) + (w20 * w282 - w288 - (w288 + w38 * w240))
    w290 = w274 + w163 * (2 * w116) + w284 + w224 * (2 * w120) + w126 * w287 + w231 * (2 * -w128) - w133 * w289
    w291 = w290 - w260 * (2 * -w134) - w84 * (w279 - w278)
    w292 = w58 * w71
    w293 = w17 * w76 - w47 * w71
    w294 = w96 + (w41 * w292 - w53 * w293)
    w295 = w18 * hinge0_angle_ddot
    w296 = w2 * hinge0_angle_dot
    w297 = hinge1_angle_dot * w296
    w298 = w295 - w297
    w299 = w18 * hinge0_angle_dot
    w300 = w4 * w299 + w1 * hinge1_angle_dot
    w301 = w4 * w206 - w1 * w298 - hinge2_angle_dot * w300
    w302 = hinge2_angle_dot + w296
    w303 = w300 * w302
    w304 = (w301 - w303) * c1
    w305 = hinge0_angle_dot**2
    w306 = w305 * bar1_end_x
    w307 = w18 * w306 + w2 * gravity_y
    w308 = w296 * w299
    w309 = w206 - w308
    w310 = w4 * hinge1_angle_dot - w1 * w299
    w311 = w302 * w310
    w312 = w4 * w298 + w1 * w206 + hinge2_angle_dot * w310
    w313 = w311 + w312
    w314 = (w307 + w309 * bar2_end_y) * c4 - w313 * c0
    w315 = w4 * w304 - w1 * w314 - w313 * c23 + (w307 * c8 + (w309 * c5 + (w206 + w308) * c6))
    w316 = w2 * hinge0_angle_ddot
    w317 = hinge1_angle_dot * w299
    w318 = w316 + w317
    w319 = w212 + w318
    w320 = w300 * w310
    w321 = w319 - w320
    w322 = w2 * w306 - w18 * gravity_y
    w323 = w322 - (w296**2 + hinge1_angle_dot**2) * bar2_end_y
    w324 = w317 + w318
    w325 = hinge0_angle_ddot * bar1_end_x
    w326 = w324 * bar2_end_y - w325
    w327 = w321 * c0 + (w319 + w320) * c1 - (w4 * w323 + w1 * w326) * c4
    w328 = w36 * w60 - w44 * w53
    w329 = w15 * hinge5_angle_dot
    w330 = w28 * hinge5_angle_dot
    w331 = w329 * w330
    w332 = w20 * gravity_y
    w333 = hinge5_angle_dot**2
    w334 = w332 - w333 * bar5_end_y
    w335 = (w331 - w236) * c15 - (w236 + w331) * c16 - w15 * w334 * c14
    w336 = w41 * w44 - w13 * w36
    w337 = hinge4_angle_dot * w330
    w338 = w337 - w15 * w234
    w339 = (w337 + w338) * c16
    w340 = w14 * gravity_y
    w341 = hinge4_angle_dot * w329
    w342 = w28 * w234
    w343 = w341 + (w341 + w342)
    w344 = (w340 - w234 * bar5_end_y) * c14 - w343 * c15
    w345 = w15 * w339 + w28 * w344 - w343 * c18 + (w340 * c25 - w234 * c20)
    w346 = w294 * w315 - (w60 * w293 - w13 * w292 - w124) * w327 + (w131 + w76 * w328) * w335 + (w58 * w336 - w47 * w328 - w67) * w345
    w347 = w39 * w76 - w47 * w69
    w348 = w73 - w36 * w347 + w34 * w293
    w349 = w58 * w69
    w350 = w36 * w349 - w146 - w34 * w292
    w351 = w117 + (w41 * w349 - w53 * w347)
    w352 = w60 * w348 + w13 * w350 - w44 * w351 - w45 * w294
    w353 = w346 / w352
    w354 = w26 * w353
    w355 = w21 * w354
    w356 = 2 * -hinge4_angle_dot
    w357 = w356 * c15
    w358 = w356 * c16
    w359 = w356 * c14
    w360 = w15 * (w28 * (w357 - w358)) + w15 * w359 * bar5_end_y
    w361 = w34 * w60 + w45 * w53
    w362 = w13 * w34 + w41 * w45
    w363 = w327 * (w121 + (w60 * w347 - w13 * w349)) - w315 * w351 - w335 * (w129 + w76 * w361) + w345 * (w63 + (w58 * w362 + w47 * w361))
    w364 = w363 / w352
    w365 = w315 * w350 - w327 * (w210 - w44 * w349 - w45 * w292) - w335 * (w71 * w361 - w69 * w328) + w345 * (w17 * w361 - w232 - w39 * w328)
    w366 = w365 / w352
    w367 = w19 * w353
    w368 = w23 * w367
    w369 = w2 * w353
    w370 = w86 * ((w50 * w244 + w233 * w261 + w64 * w268 + w68 * w291) / w83) - w355 - w260 * w360 + w84 * (w76 * w364 + w71 * w366 + (w368 + w21 * w369) + w332 * (c25 + w85))
    w371 = w327 * (w44 * w347 - w78 + w45 * w293) - w315 * w348 - w335 * (w81 + w71 * w362 + w69 * w336) + w345 * (w49 + w17 * w362 + w39 * w336)
    w372 = w371 / w352
    w373 = 2 * -w329
    w374 = 2 * -w330
    w375 = w84 * (w28 * (w373 * c15) - w15 * (w374 * c16) + w373 * c18)
    w376 = w15 * w367 + w54 * w354
    w377 = w337 - w338
    w378 = w15 * (w344 + (w342 * c16 - w329 * w358)) - w28 * (w339 + (w377 * c15 + w330 * w357)) - (w377 * c14 + w330 * w359) * bar5_end_y
    w379 = w54 * w369 - w56 * w367 - (w47 * w364 + w17 * w366)
    w380 = w84 * w370 - (w52 * w364 + w66 * w372 - (w368 + w28 * w354) + w84 * w355) + w231 * w375 + w133 * (w376 + w84 * (w378 - w379))
    w381 = w373 * c16
    w382 = w374 * c15
    w383 = w15 * c14
    w384 = w28 * w381 - w15 * w382 - hinge5_angle_dot * c124 * w383
    w385 = w376 - w260 * w384 + w84 * (w340 * w383 - w379) - (w82 * w244 + w230 * w261 + w130 * w268 + w132 * w291) / w83 * c21
    w386 = w58 * (w14 * w364 - w20 * w366) + w15 * w372 * bar4_end_x - (w15 * (w20 * w369 + w14 * w367) + w353 * (w26 * w28))
    w387 = w380 + w133 * (w385 + w133 * (w28 * w334 * c14 + w333 * c21 + (w330 * w382 + w329 * w381) - w386))
    w388 = w1 * c4
    w389 = w388 * bar2_end_y
    w390 = w389 - c22
    w391 = w388 * bar1_end_x - w2 * w390
    w392 = (w80 * w244 - w211 * w261 + w123 * w268 - w125 * w291) / w83
    w393 = 2 * w310
    w394 = w393 * c0
    w395 = 2 * -w300
    w396 = w395 * c1
    w397 = 2 * w302
    w398 = w397 * c4
    w399 = w4 * w398
    w400 = w399 * bar2_end_y
    w401 = w18 * (w4 * w394 - w1 * w396) - w2 * w400 + w399 * bar1_end_x
    w402 = w26 * w367 - w19 * w354
    w403 = w26 * w369 - w2 * w354
    w404 = w84 * (w23 * w402 + w21 * w403)
    w405 = w19 * w369 - w2 * w367
    w406 = w53 * w364 + w36 * w372 + (w23 * w405 + w28 * w403)
    w407 = w393 * c1
    w408 = w395 * c0
    w409 = w300**2
    w410 = w310**2 + w409
    w411 = w310 * w407 - w300 * w408 - ((w4 * w326 - w1 * w323) * c4 + w410 * c22)
    w412 = w395 * c4
    w413 = w321 * c4
    w414 = (w409 + w302**2) * c4
    w415 = w4 * (w310 * w412 - w413) + w1 * (w410 * c4 + w300 * w412 + w414)
    w416 = w397 * c1
    w417 = (w311 - w312) * c1 - w310 * w416 - w314
    w418 = w397 * c0
    w419 = w301 + w303
    w420 = w304 + (w300 * w418 - w419 * c0)
    w421 = w404 - (w406 + (w2 * (w411 + w415 * bar2_end_y) - w18 * (w1 * w417 + w4 * w420) - w415 * bar1_end_x))
    w422 = w133 * (w15 * w405 - w56 * w402 + w54 * w403)
    w423 = w53 * (w19 * w366 + w2 * w364) + w41 * (w26 * w364 + w19 * w372) - w36 * (w26 * w366 - w2 * w372)
    w424 = w404 - w406 - w422 - w392 * c22 - w126 * (w411 + (w423 + (w69 * w405 + w37 * w402 + w38 * w403)))
    w425 = w4 * c4
    w426 = w4 * c2
    w427 = w425 * bar2_end_y - w1 * w426
    w428 = w18 * w427
    w429 = (w98 * w291 - (w77 * w244 + w147 * w261 + w118 * w268)) / w83
    w430 = w4 * w426
    w431 = c1 + w430
    w432 = c6 + w431
    w433 = 2 * -w296
    w434 = w1 * (w418 - w416)
    w435 = w1 * w434
    w436 = c5 + (c0 - w430 - 2 * w389)
    w437 = w431 + w436
    w438 = 2 * w299
    w439 = hinge1_angle_dot * c122
    w440 = w4 * w408 + w1 * w407 + w425 * w439
    w441 = c8 - w388
    w442 = w18 * (w432 * w433 - (w435 - w418)) + w2 * (w437 * w438 + w440) - w438 * w441 * bar1_end_x + w126 * (w440 - w390 * w438)
    w443 = w387 - w391 * w392 - w224 * w401 + w126 * (w421 - w422) + w126 * w424 + w428 * w429 - w163 * w442
    w444 = w18 * w353
    w445 = w5 * w369
    w446 = w84 * (w23 * w444 + w21 * w445)
    w447 = w0 * w369
    w448 = w28 * w445 - w23 * w447 - (w60 * w364 + w44 * w372)
    w449 = w296 * c122
    w450 = w425 * w449
    w451 = w4 * w434
    w452 = w450 - w451
    w453 = 2 * hinge1_angle_dot
    w454 = w453 * c6
    w455 = w322 * w425 + (w305 * w427 - w316 * w432) - (w296 * w452 + w299 * w454) - ((w4 * w414 + w1 * w413) * bar2_end_y - w327 + (w325 * c8 - w324 * c5))
    w456 = w307 * w425
    w457 = w388 * w439
    w458 = w1 * w408
    w459 = w4 * w407
    w460 = w412 * bar2_end_y - w457 - (w458 - w459) + w453 * c5
    w461 = w451 - w400
    w462 = w456 - w295 * w437 + (w296 * w460 - w299 * (w452 + w461)) + ((w298 - w297) * c6 - (w1 * w304 + w4 * w314))
    w463 = w412 + w453 * c8
    w464 = w446 - (w448 + (w18 * w455 - w2 * w462 - (w295 * w441 - (w296 * w463 + w299 * w399)) * bar1_end_x))
    w465 = w133 * (w54 * w445 - (w15 * w447 + w56 * w444))
    w466 = w5 * w23 + w0 * w28
    w467 = w0 * w372 - w5 * w364
    w468 = w405 * (w0 * w21) - w402 * w466 - w403 * (w5 * w21) - (w53 * (w0 * w366) + w41 * w467 + w36 * (w5 * w366))
    w469 = w459 - w458 - w457
    w470 = w4 * w396 + w1 * w394 - w393 * c23
    w471 = w446 - w448 - w465 - w224 * w470 - w126 * (w468 + (w4 * w417 - w1 * w420 - (w419 * c4 - w300 * w398) * bar2_end_y))
    w472 = c6 + w436
    w473 = w461 - w427 * w433
    w474 = w416 + w435 - (w1 * w398 * bar2_end_y + w388 * w449) - w433 * c5
    w475 = w438 * c6
    w476 = w13 * w467 + w43 * w366 - (w444 * w466 + w353 * (w20 * (w2 * w15))) + (w316 * w427 - w305 * w472 - w322 * w441 + (w296 * w474 + w299 * w475))
    w477 = w443 + w119 * (w464 - w465 - w126 * (w468 + (w299 * w450 - w296 * w469 - (w456 + w295 * w390)))) + w119 * (w471 - w429 * w472 - w163 * w473 - w119 * w476)
    w478 = w18 * (w18 * w461 - w2 * (w460 - w454))
    w479 = hinge0_angle_dot * c9
    w480 = w84 * (w84 * w360 - w86 * (2 * -w260)) - (w461 - w478 + (w2 * w399 - w18 * w463) * bar1_end_x + (w478 - (w478 - w452) - w425 * w479))
    w481 = 2 * w224
    w482 = w480 + w133 * w375 + w133 * (w84 * w384 - 2 * w231 * c21) - w391 * w481 - w126 * w401 - w126 * (w18 * w469 + w2 * w450 - w479 * (w2 * w425) + w481 * c22)
    w483 = 2 * w163
    w484 = w482 + w428 * w483 - w119 * w442 - w119 * (w2 * w475 - w18 * w474 + w479 * (w18 * w441) + w126 * w470 + w472 * w483 + w119 * w473)
    # outputs
    J_q = ca.vertcat(w477)
    J_v = ca.vertcat(w484)
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
