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
    393 operations.
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
    # intermediate terms (65)
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
    w12 = w6 + w11
    w13 = (bar1_inertia_xx + bar1_inertia_yy + bar1_inertia_zz) / 2.0
    w14 = w13 - bar1_inertia_xx + bar1_mass * bar1_center_of_mass_x**2
    w15 = w13 - bar1_inertia_zz
    w16 = w4 - bar2_inertia_zz
    w17 = bar4_mass * bar4_center_of_mass_x
    w18 = w17 - bar4_end_x * bar4_mass
    w19 = (bar4_inertia_xx + bar4_inertia_yy + bar4_inertia_zz) / 2.0
    w20 = w19 - bar4_inertia_xx + bar4_mass * bar4_center_of_mass_x**2
    w21 = w20 - (bar4_end_x * w17 + bar4_end_x * w18)
    w22 = w19 - bar4_inertia_yy
    w23 = bar5_end_y * w18
    w24 = (bar5_inertia_xx + bar5_inertia_yy + bar5_inertia_zz) / 2.0
    w25 = w24 - bar5_inertia_yy + bar5_mass * bar5_center_of_mass_y**2
    w26 = bar5_mass * bar5_center_of_mass_y
    w27 = bar5_end_y * bar5_mass - w26
    w28 = bar5_end_y * bar4_mass
    w29 = w24 - bar5_inertia_zz
    w30 = w19 - bar4_inertia_zz
    w31 = w21 + w22
    w32 = w1 + w2
    w33 = ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 + ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w34 = bar1_start_quaternion_0_0_0 * ground_P0_quaternion_1_0_0 + ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w35 = bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 + bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w36 = bar3_start_quaternion_1_0_0 * bar2_end_quaternion_3_0_0 + bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w37 = ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 + ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w38 = bar5_end_quaternion_1_0_0 * ground_P5_quaternion_1_0_0 + ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w39 = w13 - bar1_inertia_yy
    w40 = w15 + w39
    w41 = w14 + w15
    w42 = w14 + w39
    w43 = -4.0 * w42
    w44 = -4.0 * w41
    w45 = w5 + w16
    w46 = w8 + w16
    w47 = w5 + w8
    w48 = -4.0 * w47
    w49 = -4.0 * w46
    w50 = w1 + w9
    w51 = w2 + w9
    w52 = -4.0 * w51
    w53 = -4.0 * w50
    w54 = w22 + w30
    w55 = w20 + w30
    w56 = w20 + w22
    w57 = -4.0 * w56
    w58 = -4.0 * w55
    w59 = w25 + w29
    w60 = w24 - bar5_inertia_xx
    w61 = w29 + w60
    w62 = w25 + w60
    w63 = -4.0 * w62
    w64 = -4.0 * w61
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
        w12,  # c8
        2 * bar1_end_x,  # c9
        w14 + bar1_end_x * (bar1_end_x * (bar3_mass + bar2_mass)) + (w15 + w16),  # c10
        bar4_end_x,  # bar4_end_x
        bar5_end_y,  # bar5_end_y
        bar3_end_z,  # bar3_end_z
        w18,  # c14
        w21,  # c15
        w22,  # c16
        w21 - w22,  # c17
        w23,  # c18
        2 * w23,  # c19
        w25 + (bar5_end_y * w27 - bar5_end_y * w26) + bar5_end_y * w28 + (w29 + w30),  # c20
        w31,  # c21
        w32,  # c22
        bar2_end_y * w3,  # c23
        gravity_y,  # gravity_y
        w27 + w28,  # c25
        ground_P0_quaternion_0_0_0,  # ground_P0_quaternion_0_0_0
        bar1_start_quaternion_0_0_0,  # bar1_start_quaternion_0_0_0
        ground_P0_quaternion_1_0_0,  # ground_P0_quaternion_1_0_0
        bar1_start_quaternion_1_0_0,  # bar1_start_quaternion_1_0_0
        w33,  # c30
        w34,  # c31
        ground_P5_z,  # ground_P5_z
        bar2_end_quaternion_1_0_0,  # bar2_end_quaternion_1_0_0
        bar3_start_quaternion_1_0_0,  # bar3_start_quaternion_1_0_0
        bar2_end_quaternion_3_0_0,  # bar2_end_quaternion_3_0_0
        bar3_start_quaternion_3_0_0,  # bar3_start_quaternion_3_0_0
        w35,  # c37
        w36,  # c38
        ground_P5_quaternion_3_0_0,  # ground_P5_quaternion_3_0_0
        bar5_end_quaternion_1_0_0,  # bar5_end_quaternion_1_0_0
        ground_P5_quaternion_1_0_0,  # ground_P5_quaternion_1_0_0
        bar5_end_quaternion_3_0_0,  # bar5_end_quaternion_3_0_0
        w37,  # c43
        w38,  # c44
        -w33,  # c45
        -w38,  # c46
        bar3_mass,  # bar3_mass
        bar2_mass,  # bar2_mass
        w5,  # c49
        w8,  # c50
        w9,  # c51
        w11,  # c52
        bar1_mass,  # bar1_mass
        w14,  # c54
        w15,  # c55
        w16,  # c56
        bar4_mass,  # bar4_mass
        w20,  # c58
        w17,  # c59
        bar5_mass,  # bar5_mass
        w25,  # c61
        w26,  # c62
        w29,  # c63
        w30,  # c64
        bar1_mass * bar1_center_of_mass_x,  # c65
        w39,  # c66
        w40,  # c67
        w41,  # c68
        w42,  # c69
        4.0 * w41 + w43,  # c70
        4.0 * w42 + -4.0 * w40,  # c71
        4.0 * w40 + w44,  # c72
        w44 + 4.0 * w40,  # c73
        4.0 * w42 + -4.0 * w40,  # c74
        w43 + 4.0 * w41,  # c75
        w45,  # c76
        w46,  # c77
        w47,  # c78
        4.0 * w46 + w48,  # c79
        4.0 * w47 + -4.0 * w45,  # c80
        4.0 * w45 + w49,  # c81
        w49 + 4.0 * w45,  # c82
        4.0 * w47 + -4.0 * w45,  # c83
        w48 + 4.0 * w46,  # c84
        w50,  # c85
        w51,  # c86
        4.0 * w50 + w52,  # c87
        4.0 * w51 + -4.0 * w32,  # c88
        4.0 * w32 + w53,  # c89
        w53 + 4.0 * w32,  # c90
        4.0 * w51 + -4.0 * w32,  # c91
        w52 + 4.0 * w50,  # c92
        w54,  # c93
        w55,  # c94
        w56,  # c95
        4.0 * w55 + w57,  # c96
        4.0 * w56 + -4.0 * w54,  # c97
        4.0 * w54 + w58,  # c98
        w58 + 4.0 * w54,  # c99
        4.0 * w56 + -4.0 * w54,  # c100
        w57 + 4.0 * w55,  # c101
        w59,  # c102
        w60,  # c103
        w61,  # c104
        w62,  # c105
        4.0 * w61 + w63,  # c106
        4.0 * w62 + -4.0 * w59,  # c107
        4.0 * w59 + w64,  # c108
        w64 + 4.0 * w59,  # c109
        4.0 * w62 + -4.0 * w59,  # c110
        w63 + 4.0 * w61,  # c111
        bar1_mass * gravity_y,  # c112
        bar2_mass * gravity_y,  # c113
        bar3_mass * gravity_y,  # c114
        bar4_mass * gravity_y,  # c115
        bar5_mass * gravity_y,  # c116
        -w35,  # c117
        2 * w10,  # c118
        0.0,  # c119
        w7 + w10,  # c120
        bar1_end_x * w12,  # c121
        2 * bar3_end_z,  # c122
        2 * bar5_end_y,  # c123
        2 * bar2_end_y,  # c124
        2.0,  # c125
        2 * bar4_end_x,  # c126
        2 * w31,  # c127
        2 * w22,  # c128
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
    722 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    # intermediate terms (202)
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
    w11 = ca.sin(hinge4_angle)
    w12 = ca.cos(hinge5_angle)
    w13 = w11 * w12 * bar4_end_x
    w14 = w12 * bar5_end_y
    w15 = w13 - w14
    w16 = ca.sin(hinge0_angle)
    w17 = w7 * bar2_end_y
    w18 = w3 * w7 * bar3_end_z
    w19 = w17 - w18
    w20 = ca.cos(hinge0_angle)
    w21 = w9 * w20
    w22 = (w3 * w21 + w0 * w16) * bar3_end_z
    w23 = w21 * bar2_end_y
    w24 = w22 - w23
    w25 = w9 * w16
    w26 = w25 * bar2_end_y
    w27 = (w0 * w20 - w3 * w25) * bar3_end_z
    w28 = w26 + w27
    w29 = w20 * w24 - w16 * w28
    w30 = w7 * w16
    w31 = ca.cos(hinge4_angle)
    w32 = w12 * w31
    w33 = w30 * w32
    w34 = ca.sin(hinge5_angle)
    w35 = w31 * w34
    w36 = w9 * w35
    w37 = w33 - w36
    w38 = w7 * w20
    w39 = w32 * w38
    w40 = w9 * w11
    w41 = w39 - w40
    w42 = w16 * w37 + w20 * w41
    w43 = ca.sqrt(w29**2 + w19**2 + w42**2)
    w44 = w16 * w19 / w43
    w45 = w34 * bar5_end_y
    w46 = w11 * w34 * bar4_end_x
    w47 = w45 - w46
    w48 = w29 / w43
    w49 = w36 - w33
    w50 = w42 / w43
    w51 = w15 * w44 - w47 * w48 - w49 * w50
    w52 = w19 * w20 / w43
    w53 = w51 * w52
    w54 = w9 * w27 - w18 * w30
    w55 = w35 * w38
    w56 = w11 * w30
    w57 = w55 - w56
    w58 = w37 * w38 + w9 * w57 - w30 * w41
    w59 = w22 * w30 + w27 * w38
    w60 = w18 * w38 + w9 * w22
    w61 = w50 * w58 - (w52 * w54 + w48 * w59 + w44 * w60)
    w62 = w54 + w52 * w61
    w63 = w59 + w48 * w61
    w64 = w60 + w44 * w61
    w65 = w58 - w50 * w61
    w66 = ca.sqrt(w62**2 + w63**2 + w64**2 + w65**2)
    w67 = w62 / w66
    w68 = w47 + w48 * w51
    w69 = w63 / w66
    w70 = w44 * w51 - w15
    w71 = w64 / w66
    w72 = w49 + w50 * w51
    w73 = w65 / w66
    w74 = w53 * w67 + w68 * w69 + w70 * w71 - w72 * w73
    w75 = w67 * w74 - w53
    w76 = w11 * bar4_end_x
    w77 = w31 * bar4_end_x
    w78 = w12 * w77
    w79 = w34 * w77
    w80 = w56 - w55
    w81 = w40 - w39
    w82 = w34 * w80 + w12 * w81
    w83 = w52 * w76 - w48 * w78 + w44 * w79 - w50 * w82
    w84 = w76 - w52 * w83
    w85 = w78 + w48 * w83
    w86 = w44 * w83 - w79
    w87 = w82 + w50 * w83
    w88 = w69 * w85 - w67 * w84 + w71 * w86 - w73 * w87
    w89 = w84 + w67 * w88
    w90 = w85 - w69 * w88
    w91 = w86 - w71 * w88
    w92 = w87 + w73 * w88
    w93 = ca.sqrt(w89**2 + w90**2 + w91**2 + w92**2)
    w94 = w89 / w93
    w95 = w68 - w69 * w74
    w96 = w90 / w93
    w97 = w70 - w71 * w74
    w98 = w91 / w93
    w99 = w72 + w73 * w74
    w100 = w92 / w93
    w101 = w75 * w94 + w95 * w96 + w97 * w98 + w99 * w100
    w102 = w75 - w94 * w101
    w103 = w95 - w96 * w101
    w104 = w97 - w98 * w101
    w105 = w100 * w101 - w99
    w106 = ca.sqrt(w102**2 + w103**2 + w104**2 + w105**2)
    w107 = w102 / w106
    w108 = w16 * bar1_end_x
    w109 = w28 - w108
    w110 = w104 / w106
    w111 = w20 * bar1_end_x
    w112 = w24 + w111
    w113 = w105 / w106
    w114 = (w107 * w109 - w110 * w112 - w57 * w113) / w106
    w115 = w10 - (w10 - (c1 + w2)) + (w6 - w8 - w9 * (c8 - w4) * c9 + c10) + w114 * (w114 * (w11 * c19 + (c15 - w31 * (w31 * c17) + c20)))
    w116 = (w94 * w109 - w98 * w112 + w57 * w100 - w101 * w114) / w93
    w117 = (w67 * w109 + w71 * w112 + w57 * w73 + w74 * w114 + w88 * w116) / w66
    w118 = w4 * bar1_end_x - w9 * (w5 - c22)
    w119 = (w52 * w109 + w44 * w112 - w50 * w57 - w51 * w114 - w83 * w116 + w61 * w117) / w43
    w120 = w7 * (w0 * c23 - w1 * w3)
    w121 = w115 + w116 * (w116 * c21) - (w117 * (w118 - w117 * c22) + w117 * w118) + (w119 * (w119 * (w6 + c6) - w120) - w119 * w120)
    w122 = w9 * hinge0_angle_dot
    w123 = w122 * hinge1_angle_dot
    w124 = w16 * hinge1_angle_dot
    w125 = hinge0_angle_dot * w124
    w126 = w17 * w124 + w23 * hinge0_angle_dot
    w127 = w20 * hinge1_angle_dot
    w128 = w9 * hinge1_angle_dot * bar2_end_y
    w129 = w17 * w125 - hinge0_angle_dot * (w111 * hinge0_angle_dot) + (hinge0_angle_dot * w126 + w127 * w128)
    w130 = w38 * hinge2_angle_dot
    w131 = w30 * hinge2_angle_dot
    w132 = hinge2_angle_dot * (w7 * hinge1_angle_dot)
    w133 = w9 * hinge2_angle_dot
    w134 = w124 * w133 - hinge0_angle_dot * w130 - w125
    w135 = hinge0_angle_dot + w133
    w136 = w124 + w130
    w137 = w18 * w136 + w22 * w135
    w138 = w127 - w131
    w139 = w22 * w138 - w27 * w136
    w140 = w12 * hinge4_angle_dot
    w141 = hinge5_angle_dot * w140
    w142 = w34 * hinge4_angle_dot
    w143 = hinge5_angle_dot * w142
    w144 = w13 * hinge5_angle_dot + w77 * w142
    w145 = w77 * w140 - w46 * hinge5_angle_dot
    w146 = w129 + (w27 * w132 + w18 * w134) - (w135 * w137 + w138 * w139) - (w46 * w141 - w13 * w143 + (w142 * w144 + w140 * w145))
    w147 = hinge0_angle_dot * w127
    w148 = w26 * hinge0_angle_dot - w17 * w127
    w149 = w147 - (hinge0_angle_dot * w131 + w127 * w133)
    w150 = w27 * w135 + w18 * w138
    w151 = w23 * w125 - w26 * w147 + (w127 * w148 - w124 * w126) + (w22 * w134 - w27 * w149) + (w138 * w150 + w136 * w137)
    w152 = w11 * hinge4_angle_dot * bar4_end_x
    w153 = hinge5_angle_dot * (w14 * hinge5_angle_dot) - w77 * w143 - (w140 * w152 + hinge5_angle_dot * w144)
    w154 = w151 - w153
    w155 = hinge0_angle_dot * (w108 * hinge0_angle_dot) + w17 * w147 - (w124 * w128 + hinge0_angle_dot * w148)
    w156 = w142 * w152 - hinge5_angle_dot * w145 - (hinge5_angle_dot * (w45 * hinge5_angle_dot) + w77 * w141)
    w157 = w155 - (w18 * w149 + w22 * w132) + (w136 * w139 - w135 * w150) - w156
    w158 = w11 * w142 - w32 * hinge5_angle_dot
    w159 = w31 * hinge4_angle_dot
    w160 = w11 * w140 + w35 * hinge5_angle_dot
    w161 = w9 * (hinge5_angle_dot * w158 - w140 * w159) - w38 * (w142 * w158 + w140 * w160) - w30 * (hinge5_angle_dot * w160 + w142 * w159)
    w162 = w9 * w136 - w38 * w135
    w163 = w38 * w138 + w30 * w136
    w164 = w30 * w135 + w9 * w138
    w165 = w161 + w11 * (w135 * w162 - w138 * w163) - w32 * (w138 * w164 + w136 * w162) - w35 * (w136 * w163 + w135 * w164)
    w166 = w165 + w159 * (2 * -w164) - w160 * (2 * w163) + w158 * (2 * w162) + w37 * w149 + w57 * w132 + w41 * w134
    w167 = w80 * w141 - w166 - w81 * w143
    w168 = (w107 * w146 + w154 * (w103 / w106) + w110 * w157 + w113 * w167) / w106
    w169 = (w94 * w146 + w96 * w154 + w98 * w157 - w100 * w167 - w101 * w168) / w93
    w170 = (w69 * w154 - w67 * w146 + w71 * w157 + w73 * w167 - w74 * w168 - w88 * w169) / w66
    w171 = (w52 * w146 - w48 * w154 - w44 * w157 + w50 * w167 - w51 * w168 - w83 * w169 - w61 * w170) / w43
    w172 = w7 * hinge0_angle_dot
    w173 = w0 * w172 + w3 * hinge1_angle_dot
    w174 = w122 + hinge2_angle_dot
    w175 = (w3 * w123 + w0 * w171 - hinge2_angle_dot * w173 - w173 * w174) * c1
    w176 = hinge0_angle_dot**2 * bar1_end_x
    w177 = w7 * w176 + w9 * gravity_y
    w178 = w122 * w172
    w179 = w171 - w178
    w180 = w0 * hinge1_angle_dot - w3 * w172
    w181 = w174 * w180 - (w0 * w123 - w3 * w171 - hinge2_angle_dot * w180)
    w182 = (w177 + w179 * bar2_end_y) * c4 - w181 * c0
    w183 = hinge1_angle_dot * w172
    w184 = w170 + w183
    w185 = w173 * w180
    w186 = w184 - w185
    w187 = w0 * ((w173**2 + w174**2) * c4) + w3 * (w186 * c4)
    w188 = 2 * w183
    w189 = w0 * (w9 * w176 - w7 * gravity_y - (w122**2 + hinge1_angle_dot**2) * bar2_end_y) + w3 * (w188 * bar2_end_y)
    w190 = w186 * c0 + (w184 + w185) * c1 - w189 * c4
    w191 = w7 * (w3 * w175 + w0 * w182 + 2 * w123 * c6) + w9 * (w187 * bar2_end_y - w190 - w188 * c5) + (w188 * c8 - w187) * bar1_end_x
    w192 = w11 * hinge5_angle_dot
    w193 = hinge4_angle_dot * w192
    w194 = w34 * gravity_y
    w195 = w31 * hinge5_angle_dot
    w196 = hinge4_angle_dot * w195
    w197 = w196 + (w196 + w11 * w168)
    w198 = w31 * ((w193 + (w193 - w31 * w168)) * c16) + w11 * ((w194 - w168 * bar5_end_y) * c14 - w197 * c15)
    w199 = w192 * w195
    w200 = (w199 - w169) * c15 - (w169 + w199) * c16 - w31 * (w12 * gravity_y - hinge5_angle_dot**2 * bar5_end_y) * c14
    w201 = w191 + w114 * (w198 - w197 * c18 + (w194 * c25 - w168 * c20)) + w116 * w200 + w117 * w190 - w119 * (w0 * w175 - w3 * w182 - w181 * c23 + (w177 * c8 + (w179 * c5 + (w171 + w178) * c6)))
    # outputs
    M_hat = ca.vertcat(w121)
    Q_hat = ca.vertcat(w201)
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
    578 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    # intermediate terms (156)
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
    w12 = ca.cos(hinge1_angle)
    w13 = ca.sin(hinge0_angle)
    w14 = w12 * w13
    w15 = ca.cos(hinge4_angle)
    w16 = ca.cos(hinge5_angle)
    w17 = w15 * w16
    w18 = w14 * w17
    w19 = ca.sin(hinge1_angle)
    w20 = ca.sin(hinge5_angle)
    w21 = w15 * w20
    w22 = w19 * w21
    w23 = w18 - w22
    w24 = ca.cos(hinge0_angle)
    w25 = w12 * w24
    w26 = w17 * w25
    w27 = ca.sin(hinge4_angle)
    w28 = w19 * w27
    w29 = w26 - w28
    w30 = w13 * w23 + w24 * w29
    w31 = ca.sin(hinge2_angle)
    w32 = w12 * w31 * bar3_end_z
    w33 = w12 * bar2_end_y - w32
    w34 = w24 * w33
    w35 = w19 * w24
    w36 = ca.cos(hinge2_angle)
    w37 = (w31 * w35 + w13 * w36) * bar3_end_z
    w38 = w37 - w35 * bar2_end_y
    w39 = w13 * w19
    w40 = (w24 * w36 - w31 * w39) * bar3_end_z
    w41 = w39 * bar2_end_y + w40
    w42 = w24 * w38 - w13 * w41
    w43 = w13 * w33
    w44 = ca.sqrt(w42**2 + w33**2 + w30**2)
    w45 = w30 / w44
    w46 = w25 * w27 + w17 * w19 + w14 * w21
    w47 = w34 / w44
    w48 = w15 * bar4_end_x
    w49 = w48 + (w38 + w24 * bar1_end_x)
    w50 = w42 / w44
    w51 = w16 * w27 * bar4_end_x - w16 * bar5_end_y
    w52 = w51 - w33
    w53 = w43 / w44
    w54 = w20 * bar5_end_y - w20 * w27 * bar4_end_x
    w55 = ground_P5_z + w54 - (w41 - w13 * bar1_end_x)
    w56 = w22 - w18
    w57 = w51 * w53 - w50 * w54 - w45 * w56
    w58 = w54 + w50 * w57
    w59 = w47 * w57
    w60 = w19 * w40 - w14 * w32
    w61 = w21 * w25
    w62 = w14 * w27
    w63 = w23 * w25 + w19 * (w61 - w62) - w14 * w29
    w64 = w14 * w37 + w25 * w40
    w65 = w25 * w32 + w19 * w37
    w66 = w45 * w63 - (w47 * w60 + w50 * w64 + w53 * w65)
    w67 = w60 + w47 * w66
    w68 = w64 + w50 * w66
    w69 = w65 + w53 * w66
    w70 = w63 - w45 * w66
    w71 = ca.sqrt(w67**2 + w68**2 + w69**2 + w70**2)
    w72 = w67 / w71
    w73 = w68 / w71
    w74 = w53 * w57 - w51
    w75 = w69 / w71
    w76 = w56 + w45 * w57
    w77 = w70 / w71
    w78 = w59 * w72 + w58 * w73 + w74 * w75 - w76 * w77
    w79 = w58 - w73 * w78
    w80 = w72 * w78 - w59
    w81 = w27 * bar4_end_x
    w82 = w16 * w48
    w83 = w20 * w48
    w84 = w20 * (w62 - w61) + w16 * (w28 - w26)
    w85 = w47 * w81 - w50 * w82 + w53 * w83 - w45 * w84
    w86 = w81 - w47 * w85
    w87 = w82 + w50 * w85
    w88 = w53 * w85 - w83
    w89 = w84 + w45 * w85
    w90 = w73 * w87 - w72 * w86 + w75 * w88 - w77 * w89
    w91 = w86 + w72 * w90
    w92 = w87 - w73 * w90
    w93 = w88 - w75 * w90
    w94 = w89 + w77 * w90
    w95 = ca.sqrt(w91**2 + w92**2 + w93**2 + w94**2)
    w96 = w91 / w95
    w97 = w92 / w95
    w98 = w74 - w75 * w78
    w99 = w93 / w95
    w100 = w76 + w77 * w78
    w101 = w94 / w95
    w102 = w80 * w96 + w79 * w97 + w98 * w99 + w100 * w101
    w103 = w79 - w97 * w102
    w104 = w80 - w96 * w102
    w105 = w98 - w99 * w102
    w106 = w101 * w102 - w100
    w107 = ca.sqrt(w104**2 + w103**2 + w105**2 + w106**2)
    w108 = (w52 * (w103 / w107) - w49 * (w104 / w107) + w55 * (w105 / w107) + w46 * (w106 / w107)) / w107
    w109 = (w52 * w97 - w49 * w96 + w55 * w99 - w46 * w101 - w102 * w108) / w95
    w110 = (w49 * w72 + w52 * w73 + w55 * w75 + w46 * w77 - w78 * w108 - w90 * w109) / w71
    w111 = hinge1_angle - (w45 * w46 - (w47 * w49 + w50 * w52 + w53 * w55) - w57 * w108 - w85 * w109 - w66 * w110) / w44
    w112 = w111 / 2.0
    w113 = ca.cos(w112)
    w114 = ca.sin(w112)
    w115 = w2 * w113 - w6 * w114
    w116 = w3 * w113 - w5 * w114
    w117 = w5 * w113 + w3 * w114
    w118 = -w117
    w119 = w2 * w114 + w6 * w113
    w120 = 2 * w115
    w121 = hinge2_angle - w110
    w122 = w121 / 2.0
    w123 = ca.cos(w122)
    w124 = w123 * c37
    w125 = ca.sin(w122)
    w126 = w125 * c38
    w127 = w123 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w123 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w128 = w125 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w125 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w129 = hinge5_angle - w108
    w130 = w129 / 2.0
    w131 = ca.sin(w130)
    w132 = w131 * c43
    w133 = -w132
    w134 = ca.cos(w130)
    w135 = w134 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0 - w134 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w136 = w134 * c44
    w137 = 2 * w136
    w138 = w131 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w131 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w139 = (2 * w133 * w135 - w137 * w138) * bar5_end_y
    w140 = hinge4_angle - w109
    w141 = w140 / 2.0
    w142 = ca.cos(w141)
    w143 = ca.sin(w141)
    w144 = w135 * w142 - w132 * w143
    w145 = w138 * w142 - w136 * w143
    w146 = (1.0 - 2 * w132**2 - 2 * w138**2) * bar5_end_y
    w147 = w136 * w142 + w138 * w143
    w148 = 2 * w147
    w149 = -(w132 * w142 + w135 * w143)
    w150 = 2 * w149
    w151 = ground_P5_z - (w138 * (2 * w135) - w132 * w137) * bar5_end_y
    w152 = w56 * w83 - w51 * w84
    w153 = w51 * w63 - w56 * w65
    w154 = w43 * w56 + w30 * w51
    w155 = w34 * (w64 * w152 - w82 * w153 + w54 * (w63 * w83 - w65 * w84)) + w60 * (w54 * (w43 * w84 + w30 * w83) - (w42 * w152 + w82 * w154))
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
        w115,  # bar2.e0
        w116,  # bar2.e1
        w118,  # bar2.e2
        w119,  # bar2.e3
        w7 - (w117 * (2 * w116) + w119 * w120) * bar2_end_y,  # bar3.x
        w10 + (1.0 - 2 * w116**2 - 2 * w119**2) * bar2_end_y,  # bar3.y
        w11 + (w116 * w120 + w119 * (2 * w118)) * bar2_end_y,  # bar3.z
        w115 * w124 - (w116 * w126 - w117 * w127 + w119 * w128),  # bar3.e0
        w115 * w126 + w116 * w124 - (w117 * w128 + w119 * w127),  # bar3.e1
        w115 * w127 - w117 * w124 + (w119 * w126 - w116 * w128),  # bar3.e2
        w115 * w128 + w119 * w124 + (w116 * w127 + w117 * w126),  # bar3.e3
        -(w139 + (1.0 - 2 * w144**2 - 2 * w145**2) * bar4_end_x),  # bar4.x
        -(w146 + (w145 * w148 + w144 * w150) * bar4_end_x),  # bar4.y
        w151 - (w145 * w150 - w144 * w148) * bar4_end_x,  # bar4.z
        w147,  # bar4.e0
        w149,  # bar4.e1
        w144,  # bar4.e2
        w145,  # bar4.e3
        -w139,  # bar5.x
        -w146,  # bar5.y
        w151,  # bar5.z
        w136,  # bar5.e0
        w133,  # bar5.e1
        w135,  # bar5.e2
        w138,  # bar5.e3
        w111,  # hinge1.angle
        w121,  # hinge2.angle
        w140,  # hinge4.angle
        w129,  # hinge5.angle
    )
    C_loop = ca.vertcat(
        -w49,  # hinge3.x
        w52,  # hinge3.y
        w55,  # hinge3.z
        w46,  # hinge3.parallel_x
    )
    det_loop = ca.vertcat(w155 - w81 * (w42 * w153 + w64 * w154 + w54 * (w43 * w63 + w30 * w65)))
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 39) [mixed]: rates of the dependent coordinates
    860 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    # intermediate terms (228)
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
    w33 = ca.cos(hinge0_angle)
    w34 = ca.cos(hinge1_angle)
    w35 = ca.sin(hinge2_angle)
    w36 = w34 * w35 * bar3_end_z
    w37 = w34 * bar2_end_y - w36
    w38 = ca.sin(hinge1_angle)
    w39 = w33 * w38
    w40 = ca.cos(hinge2_angle)
    w41 = ca.sin(hinge0_angle)
    w42 = (w35 * w39 + w40 * w41) * bar3_end_z
    w43 = w42 - w39 * bar2_end_y
    w44 = w38 * w41
    w45 = (w33 * w40 - w35 * w44) * bar3_end_z
    w46 = w44 * bar2_end_y + w45
    w47 = w33 * w43 - w41 * w46
    w48 = w34 * w41
    w49 = ca.cos(hinge4_angle)
    w50 = ca.cos(hinge5_angle)
    w51 = w49 * w50
    w52 = w48 * w51
    w53 = ca.sin(hinge5_angle)
    w54 = w49 * w53
    w55 = w38 * w54
    w56 = w52 - w55
    w57 = w33 * w34
    w58 = w51 * w57
    w59 = ca.sin(hinge4_angle)
    w60 = w38 * w59
    w61 = w58 - w60
    w62 = w41 * w56 + w33 * w61
    w63 = ca.sqrt(w47**2 + w37**2 + w62**2)
    w64 = w33 * w37 / w63
    w65 = w46 - w41 * bar1_end_x
    w66 = w37 * w41 / w63
    w67 = w43 + w33 * bar1_end_x
    w68 = w62 / w63
    w69 = w54 * w57
    w70 = w48 * w59
    w71 = w69 - w70
    w72 = w50 * w59 * bar4_end_x - w50 * bar5_end_y
    w73 = w53 * bar5_end_y - w53 * w59 * bar4_end_x
    w74 = w47 / w63
    w75 = w55 - w52
    w76 = w66 * w72 - w73 * w74 - w68 * w75
    w77 = w64 * w76
    w78 = w38 * w45 - w36 * w48
    w79 = w56 * w57 + w38 * w71 - w48 * w61
    w80 = w42 * w48 + w45 * w57
    w81 = w36 * w57 + w38 * w42
    w82 = w68 * w79 - (w64 * w78 + w74 * w80 + w66 * w81)
    w83 = w78 + w64 * w82
    w84 = w80 + w74 * w82
    w85 = w81 + w66 * w82
    w86 = w79 - w68 * w82
    w87 = ca.sqrt(w83**2 + w84**2 + w85**2 + w86**2)
    w88 = w83 / w87
    w89 = w73 + w74 * w76
    w90 = w84 / w87
    w91 = w66 * w76 - w72
    w92 = w85 / w87
    w93 = w75 + w68 * w76
    w94 = w86 / w87
    w95 = w77 * w88 + w89 * w90 + w91 * w92 - w93 * w94
    w96 = w88 * w95 - w77
    w97 = w59 * bar4_end_x
    w98 = w49 * bar4_end_x
    w99 = w50 * w98
    w100 = w53 * w98
    w101 = w53 * (w70 - w69) + w50 * (w60 - w58)
    w102 = w64 * w97 - w74 * w99 + w66 * w100 - w68 * w101
    w103 = w97 - w64 * w102
    w104 = w99 + w74 * w102
    w105 = w66 * w102 - w100
    w106 = w101 + w68 * w102
    w107 = w90 * w104 - w88 * w103 + w92 * w105 - w94 * w106
    w108 = w103 + w88 * w107
    w109 = w104 - w90 * w107
    w110 = w105 - w92 * w107
    w111 = w106 + w94 * w107
    w112 = ca.sqrt(w108**2 + w109**2 + w110**2 + w111**2)
    w113 = w108 / w112
    w114 = w89 - w90 * w95
    w115 = w109 / w112
    w116 = w91 - w92 * w95
    w117 = w110 / w112
    w118 = w93 + w94 * w95
    w119 = w111 / w112
    w120 = w96 * w113 + w114 * w115 + w116 * w117 + w118 * w119
    w121 = w96 - w113 * w120
    w122 = w116 - w117 * w120
    w123 = w119 * w120 - w118
    w124 = ca.sqrt(w121**2 + (w114 - w115 * w120)**2 + w122**2 + w123**2)
    w125 = (w65 * (w121 / w124) - w67 * (w122 / w124) - w71 * (w123 / w124)) / w124
    w126 = (w65 * w113 - w67 * w117 + w71 * w119 - w120 * w125) / w112
    w127 = (w65 * w88 + w67 * w92 + w71 * w94 + w95 * w125 + w107 * w126) / w87
    w128 = hinge0_angle_dot * ((w64 * w65 + w66 * w67 - w68 * w71 - w76 * w125 - w102 * w126 + w82 * w127) / w63)
    w129 = w2 * w29 + w8 * w30 + (bar1_e0 * w31 + bar1_e3 * w32) * w128
    w130 = w4 * w29 - w6 * w30 + w128 * (bar1_e2 * w32 - bar1_e1 * w31)
    w131 = w4 * w30 + w6 * w29 + w128 * (bar1_e2 * w31 + bar1_e1 * w32)
    w132 = w8 * w29 - w2 * w30 + w128 * (bar1_e0 * w32 - bar1_e3 * w31)
    w133 = bar2_e2 * -2.0
    w134 = 2 * bar2_e0
    w135 = 2 * bar2_e2
    w136 = (w134 * bar2_e1 + w135 * bar2_e3) * bar2_end_y
    w137 = bar2_e3 * -2.0
    w138 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * bar2_end_y
    w139 = w137 * w138
    w140 = 2 * bar2_e3
    w141 = w134 * w136
    w142 = 2 * bar2_e1
    w143 = w21 - w129 * (w133 * w136 - w139) + w130 * (w136 * w140 - w133 * w138) - w131 * (w141 - w138 * w142)
    w144 = bar2_e1 * -2.0
    w145 = w136 * w144
    w146 = w134 * w138
    w147 = (bar2_e2 * w142 - w134 * bar2_e3) * bar2_end_y
    w148 = w133 * w147
    w149 = w134 * w147
    w150 = w26 - w129 * (w137 * w147 - w145) + w130 * (w148 - w141) - w131 * (w142 * w147 - w136 * w137) + w132 * (w149 - w135 * w136)
    w151 = w27 - w129 * (w138 * w144 - w148) + w130 * (w146 - w140 * w147) - w131 * (w139 - w149) + w132 * (w135 * w138 - w144 * w147)
    w152 = hinge2_angle / 2.0
    w153 = ca.cos(w152)
    w154 = w153 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w153 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w155 = w153 * c37
    w156 = ca.sin(w152)
    w157 = w156 * c38
    w158 = w156 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w156 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w159 = w156 / 2.0
    w160 = w159 * c37
    w161 = w153 / 2.0
    w162 = w161 * c38
    w163 = w159 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w159 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w164 = w161 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w161 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w165 = hinge0_angle_dot * w127
    w166 = w131 * w154 - (w129 * w155 + w130 * w157) - w132 * w158 + (bar2_e0 * w160 + (bar2_e1 * w162 + bar2_e2 * w163 + bar2_e3 * w164)) * w165
    w167 = w130 * w155 - w129 * w157 - w131 * w158 - w132 * w154 - w165 * (bar2_e0 * w162 - bar2_e1 * w160 + (bar2_e2 * w164 - bar2_e3 * w163))
    w168 = w132 * w157 - (w129 * w154 + w130 * w158 + w131 * w155) - w165 * (bar2_e0 * w163 - bar2_e2 * w160 + (bar2_e3 * w162 - bar2_e1 * w164))
    w169 = w130 * w154 - w129 * w158 + w131 * w157 + w132 * w155 - w165 * (bar2_e0 * w164 - bar2_e3 * w160 + (bar2_e1 * w163 - bar2_e2 * w162))
    w170 = 2 * bar4_e3
    w171 = 2 * bar4_e1
    w172 = 2 * bar4_e0
    w173 = (bar4_e3 * w171 - w172 * bar4_e2) * bar4_end_x
    w174 = bar4_e2 * -2.0
    w175 = (bar4_e3 * w172 + w171 * bar4_e2) * bar4_end_x
    w176 = hinge4_angle / 2.0
    w177 = ca.cos(w176)
    w178 = hinge5_angle / 2.0
    w179 = ca.cos(w178) / 2.0
    w180 = hinge0_angle_dot * w125
    w181 = w179 * c43 * w180
    w182 = ca.sin(w176)
    w183 = ca.sin(w178) / 2.0
    w184 = w183 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w183 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w185 = w180 * w184
    w186 = w182 / 2.0
    w187 = w177 / 2.0
    w188 = hinge0_angle_dot * w126
    w189 = w177 * w181 + w182 * w185 + (w186 * bar5_e1 + bar5_e2 * w187) * w188
    w190 = bar4_e3 * -2.0
    w191 = w175 * w190
    w192 = w179 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w179 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w193 = w180 * w192
    w194 = w180 * (w183 * c44)
    w195 = w182 * w193 - w177 * w194 + w188 * (w187 * bar5_e3 - w186 * bar5_e0)
    w196 = w172 * w173
    w197 = w177 * w185 - w181 * w182 + w188 * (bar5_e1 * w187 - w186 * bar5_e2)
    w198 = bar4_e1 * -2.0
    w199 = w173 * w198
    w200 = w172 * w175
    w201 = w182 * w194 + w177 * w193 - w188 * (w187 * bar5_e0 + w186 * bar5_e3)
    w202 = (w170 * w173 - w174 * w175) * w189 - (w173 * w174 - w191) * w195 - (w196 - w171 * w175) * w197 - (w199 - w200) * w201
    w203 = bar5_e2 * -2.0
    w204 = 2 * bar5_e0
    w205 = 2 * bar5_e2
    w206 = (bar5_e1 * w204 + bar5_e3 * w205) * bar5_end_y
    w207 = bar5_e3 * -2.0
    w208 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * bar5_end_y
    w209 = w207 * w208
    w210 = 2 * bar5_e3
    w211 = w204 * w206
    w212 = 2 * bar5_e1
    w213 = bar5_e1 * -2.0
    w214 = w206 * w213
    w215 = w204 * w208
    w216 = w194 * (w203 * w206 - w209) + w181 * (w206 * w210 - w203 * w208) - w185 * (w211 - w208 * w212) - w193 * (w214 - w215)
    w217 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * bar4_end_x
    w218 = w174 * w217
    w219 = w172 * w217
    w220 = 2 * bar4_e2
    w221 = w189 * (w218 - w196) - w195 * (w190 * w217 - w199) - w197 * (w171 * w217 - w173 * w190) - w201 * (w219 - w173 * w220)
    w222 = (bar5_e2 * w212 - bar5_e3 * w204) * bar5_end_y
    w223 = w203 * w222
    w224 = w204 * w222
    w225 = w194 * (w207 * w222 - w214) + w181 * (w223 - w211) - w185 * (w212 * w222 - w206 * w207) - w193 * (w224 - w205 * w206)
    w226 = w189 * (w200 - w170 * w217) - w195 * (w175 * w198 - w218) - w197 * (w191 - w219) - w201 * (w175 * w220 - w198 * w217)
    w227 = w194 * (w208 * w213 - w223) + w181 * (w215 - w210 * w222) - w185 * (w209 - w224) - w193 * (w205 * w208 - w213 * w222)
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
        -w129,  # bar2.e0
        w130,  # bar2.e1
        -w131,  # bar2.e2
        w132,  # bar2.e3
        w143 + w132 * (w145 - w146),  # bar3.x
        w150,  # bar3.y
        w151,  # bar3.z
        w166,  # bar3.e0
        w167,  # bar3.e1
        w168,  # bar3.e2
        w169,  # bar3.e3
        w202 + w216,  # bar4.x
        w221 + w225,  # bar4.y
        w226 + w227,  # bar4.z
        w195,  # bar4.e0
        -w189,  # bar4.e1
        w197,  # bar4.e2
        w201,  # bar4.e3
        w216,  # bar5.x
        w225,  # bar5.y
        w227,  # bar5.z
        -w194,  # bar5.e0
        -w181,  # bar5.e1
        w185,  # bar5.e2
        w193,  # bar5.e3
        w128,  # hinge1.angle
        -w165,  # hinge2.angle
        w188,  # hinge4.angle
        w180,  # hinge5.angle
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
    1503 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    # intermediate terms (375)
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
    w54 = ca.cos(hinge0_angle)
    w55 = ca.cos(hinge1_angle)
    w56 = w55 * bar2_end_y
    w57 = ca.sin(hinge2_angle)
    w58 = w55 * w57 * bar3_end_z
    w59 = w56 - w58
    w60 = ca.sin(hinge1_angle)
    w61 = w54 * w60
    w62 = ca.cos(hinge2_angle)
    w63 = ca.sin(hinge0_angle)
    w64 = (w57 * w61 + w62 * w63) * bar3_end_z
    w65 = w61 * bar2_end_y
    w66 = w64 - w65
    w67 = w60 * w63
    w68 = w67 * bar2_end_y
    w69 = (w54 * w62 - w57 * w67) * bar3_end_z
    w70 = w68 + w69
    w71 = w54 * w66 - w63 * w70
    w72 = w55 * w63
    w73 = ca.cos(hinge4_angle)
    w74 = ca.cos(hinge5_angle)
    w75 = w73 * w74
    w76 = w72 * w75
    w77 = ca.sin(hinge5_angle)
    w78 = w73 * w77
    w79 = w60 * w78
    w80 = w76 - w79
    w81 = w54 * w55
    w82 = w75 * w81
    w83 = ca.sin(hinge4_angle)
    w84 = w60 * w83
    w85 = w82 - w84
    w86 = w63 * w80 + w54 * w85
    w87 = ca.sqrt(w71**2 + w59**2 + w86**2)
    w88 = w54 * w59 / w87
    w89 = hinge1_angle_dot * w63
    w90 = hinge0_angle_dot * w89
    w91 = w54 * bar1_end_x
    w92 = w56 * w89 + hinge0_angle_dot * w65
    w93 = hinge1_angle_dot * w54
    w94 = hinge1_angle_dot * w60 * bar2_end_y
    w95 = w81 * hinge2_angle_dot
    w96 = w72 * hinge2_angle_dot
    w97 = hinge2_angle_dot * (hinge1_angle_dot * w55)
    w98 = w60 * hinge2_angle_dot
    w99 = w89 * w98 - hinge0_angle_dot * w95 - w90
    w100 = w56 * w90 - hinge0_angle_dot * (hinge0_angle_dot * w91) + (hinge0_angle_dot * w92 + w93 * w94) + (w69 * w97 + w58 * w99)
    w101 = hinge0_angle_dot + w98
    w102 = w89 + w95
    w103 = w58 * w102 + w64 * w101
    w104 = w93 - w96
    w105 = w64 * w104 - w69 * w102
    w106 = w74 * hinge4_angle_dot
    w107 = hinge5_angle_dot * w106
    w108 = w77 * w83 * bar4_end_x
    w109 = w77 * hinge4_angle_dot
    w110 = hinge5_angle_dot * w109
    w111 = w74 * w83 * bar4_end_x
    w112 = w73 * bar4_end_x
    w113 = hinge5_angle_dot * w111 + w109 * w112
    w114 = w106 * w112 - hinge5_angle_dot * w108
    w115 = w100 - (w101 * w103 + w104 * w105) - (w107 * w108 - w110 * w111 + (w109 * w113 + w106 * w114))
    w116 = w71 / w87
    w117 = hinge0_angle_dot * w93
    w118 = hinge0_angle_dot * w68 - w56 * w93
    w119 = w117 - (hinge0_angle_dot * w96 + w93 * w98)
    w120 = w69 * w101 + w58 * w104
    w121 = w65 * w90 - w68 * w117 + (w93 * w118 - w89 * w92) + (w64 * w99 - w69 * w119) + (w104 * w120 + w102 * w103)
    w122 = w74 * bar5_end_y
    w123 = w83 * hinge4_angle_dot * bar4_end_x
    w124 = hinge5_angle_dot * (hinge5_angle_dot * w122) - w110 * w112 - (w106 * w123 + hinge5_angle_dot * w113)
    w125 = w121 - w124
    w126 = w59 * w63 / w87
    w127 = w63 * bar1_end_x
    w128 = hinge0_angle_dot * (hinge0_angle_dot * w127) + w56 * w117 - (w89 * w94 + hinge0_angle_dot * w118)
    w129 = w77 * bar5_end_y
    w130 = w109 * w123 - hinge5_angle_dot * w114 - (hinge5_angle_dot * (hinge5_angle_dot * w129) + w107 * w112)
    w131 = w128 - (w58 * w119 + w64 * w97) + (w102 * w105 - w101 * w120) - w130
    w132 = w86 / w87
    w133 = w72 * w83
    w134 = w78 * w81
    w135 = w133 - w134
    w136 = w83 * w109 - w75 * hinge5_angle_dot
    w137 = w73 * hinge4_angle_dot
    w138 = w83 * w106 + w78 * hinge5_angle_dot
    w139 = w60 * (hinge5_angle_dot * w136 - w106 * w137) - w81 * (w109 * w136 + w106 * w138) - w72 * (hinge5_angle_dot * w138 + w109 * w137)
    w140 = w60 * w102 - w81 * w101
    w141 = w81 * w104 + w72 * w102
    w142 = w72 * w101 + w60 * w104
    w143 = w139 + w83 * (w101 * w140 - w104 * w141) - w75 * (w104 * w142 + w102 * w140) - w78 * (w102 * w141 + w101 * w142)
    w144 = w134 - w133
    w145 = w143 + w137 * (2 * -w142) - w138 * (2 * w141) + w136 * (2 * w140) + w80 * w119 + w97 * w144 + w85 * w99
    w146 = w84 - w82
    w147 = w107 * w135 - w145 - w110 * w146
    w148 = w111 - w122
    w149 = w129 - w108
    w150 = w79 - w76
    w151 = w126 * w148 - w116 * w149 - w132 * w150
    w152 = w88 * w151
    w153 = w60 * w69 - w58 * w72
    w154 = w80 * w81 + w60 * w144 - w72 * w85
    w155 = w64 * w72 + w69 * w81
    w156 = w58 * w81 + w60 * w64
    w157 = w132 * w154 - (w88 * w153 + w116 * w155 + w126 * w156)
    w158 = w153 + w88 * w157
    w159 = w155 + w116 * w157
    w160 = w156 + w126 * w157
    w161 = w154 - w132 * w157
    w162 = ca.sqrt(w158**2 + w159**2 + w160**2 + w161**2)
    w163 = w158 / w162
    w164 = w149 + w116 * w151
    w165 = w159 / w162
    w166 = w126 * w151 - w148
    w167 = w160 / w162
    w168 = w150 + w132 * w151
    w169 = w161 / w162
    w170 = w152 * w163 + w164 * w165 + w166 * w167 - w168 * w169
    w171 = w163 * w170 - w152
    w172 = w83 * bar4_end_x
    w173 = w74 * w112
    w174 = w77 * w112
    w175 = w77 * w135 + w74 * w146
    w176 = w88 * w172 - w116 * w173 + w126 * w174 - w132 * w175
    w177 = w172 - w88 * w176
    w178 = w173 + w116 * w176
    w179 = w126 * w176 - w174
    w180 = w175 + w132 * w176
    w181 = w165 * w178 - w163 * w177 + w167 * w179 - w169 * w180
    w182 = w177 + w163 * w181
    w183 = w178 - w165 * w181
    w184 = w179 - w167 * w181
    w185 = w180 + w169 * w181
    w186 = ca.sqrt(w182**2 + w183**2 + w184**2 + w185**2)
    w187 = w182 / w186
    w188 = w164 - w165 * w170
    w189 = w183 / w186
    w190 = w166 - w167 * w170
    w191 = w184 / w186
    w192 = w168 + w169 * w170
    w193 = w185 / w186
    w194 = w171 * w187 + w188 * w189 + w190 * w191 + w192 * w193
    w195 = w171 - w187 * w194
    w196 = w188 - w189 * w194
    w197 = w190 - w191 * w194
    w198 = w193 * w194 - w192
    w199 = ca.sqrt(w195**2 + w196**2 + w197**2 + w198**2)
    w200 = w195 / w199
    w201 = w197 / w199
    w202 = w198 / w199
    w203 = (w115 * w200 + w125 * (w196 / w199) + w131 * w201 + w147 * w202) / w199
    w204 = (w115 * w187 + w125 * w189 + w131 * w191 - w147 * w193 - w194 * w203) / w186
    w205 = (w125 * w165 - w115 * w163 + w131 * w167 + w147 * w169 - w170 * w203 - w181 * w204) / w162
    w206 = (w88 * w115 - w116 * w125 - w126 * w131 + w132 * w147 - w151 * w203 - w176 * w204 - w157 * w205) / w87
    w207 = w70 - w127
    w208 = w66 + w91
    w209 = (w200 * w207 - w201 * w208 - w144 * w202) / w199
    w210 = (w187 * w207 - w191 * w208 + w144 * w193 - w194 * w209) / w186
    w211 = (w163 * w207 + w167 * w208 + w144 * w169 + w170 * w209 + w181 * w210) / w162
    w212 = hinge0_angle_ddot * ((w88 * w207 + w126 * w208 - w132 * w144 - w151 * w209 - w176 * w210 + w157 * w211) / w87)
    w213 = w206 + w212
    w214 = bar1_e3 * w46 - bar1_e0 * w48 - w53 - w53 - w6 * w47 - w15 * w45 - (bar1_e0 * w49 + bar1_e3 * w51) * w213
    w215 = bar1_e2_dot * w52 - bar1_e1_dot * w50
    w216 = w215 + (w215 - (bar1_e1 * w48 + bar1_e2 * w46)) + w9 * w47 + w12 * w45 + w213 * (bar1_e2 * w51 - bar1_e1 * w49)
    w217 = bar1_e2_dot * w50 + bar1_e1_dot * w52
    w218 = bar1_e1 * w46 - bar1_e2 * w48 - w217 - w217 - w9 * w45 + w12 * w47 - w213 * (bar1_e2 * w49 + bar1_e1 * w51)
    w219 = bar1_e0_dot * w52 - bar1_e3_dot * w50
    w220 = w219 + (w219 - (bar1_e0 * w46 + bar1_e3 * w48)) - w6 * w45 + w15 * w47 + w213 * (bar1_e0 * w51 - bar1_e3 * w49)
    w221 = bar2_e2 * -2.0
    w222 = 2 * bar2_e3
    w223 = 2 * bar2_e0
    w224 = bar2_e1 * -2.0
    w225 = bar2_e0_dot * w221 + bar2_e1_dot * w222 + bar2_e2_dot * w223 + bar2_e3_dot * w224
    w226 = bar2_e3 * -2.0
    w227 = 2 * bar2_e2
    w228 = bar2_e0_dot * w224 + bar2_e1_dot * w223 + bar2_e2_dot * w226 + bar2_e3_dot * w227
    w229 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * bar2_end_y
    w230 = 2 * bar2_e1
    w231 = (bar2_e2 * w230 - bar2_e3 * w223) * bar2_end_y
    w232 = w228 * w229 - w225 * w231
    w233 = bar2_e0_dot * w226 + w221 * bar2_e1_dot + bar2_e2_dot * w230 + w223 * bar2_e3_dot
    w234 = (w223 * bar2_e1 + bar2_e3 * w227) * bar2_end_y
    w235 = w231 * w233 - w228 * w234
    w236 = w226 * w229
    w237 = w36 + (w225 * w232 - w233 * w235) + w214 * (w221 * w234 - w236) + w216 * (w222 * w234 - w221 * w229)
    w238 = w223 * w234
    w239 = w224 * w234
    w240 = w223 * w229
    w241 = w225 * w234 - w229 * w233
    w242 = w221 * w231
    w243 = w41 + (w233 * w241 - w228 * w232) + w214 * (w226 * w231 - w239) + w216 * (w242 - w238) + w218 * (w230 * w231 - w226 * w234)
    w244 = w223 * w231
    w245 = w42 + (w228 * w235 - w225 * w241) + w214 * (w224 * w229 - w242) + w216 * (w240 - w222 * w231) + w218 * (w236 - w244)
    w246 = hinge2_angle / 2.0
    w247 = ca.cos(w246)
    w248 = w247 * c37
    w249 = hinge2_angle_dot / 2.0
    w250 = w249**2
    w251 = w247 * w250
    w252 = w249 * (w247 * w249) * c37
    w253 = w251 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w251 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w254 = ca.sin(w246)
    w255 = w250 * w254
    w256 = w255 * c38
    w257 = w255 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w255 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w258 = w254 / 2.0
    w259 = hinge2_angle_dot * w258
    w260 = w259 * c37
    w261 = w247 / 2.0
    w262 = hinge2_angle_dot * w261
    w263 = w262 * c38
    w264 = w259 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w259 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w265 = w262 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w262 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w266 = bar2_e0_dot * w260 + (bar2_e1_dot * w263 + bar2_e2_dot * w264 + bar2_e3_dot * w265)
    w267 = w214 * w248 - (w266 + (bar2_e0 * w252 + (bar2_e2 * w253 - bar2_e1 * w256 + bar2_e3 * w257) + w266))
    w268 = w254 * c38
    w269 = w247 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w247 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w270 = w254 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w254 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w271 = w258 * c37
    w272 = w261 * c38
    w273 = w258 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w258 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w274 = w261 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w261 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w275 = w205 - hinge0_angle_ddot * w211
    w276 = w267 - w216 * w268 - w218 * w269 - w220 * w270 - (bar2_e0 * w271 + (bar2_e1 * w272 + bar2_e2 * w273 + bar2_e3 * w274)) * w275
    w277 = bar2_e0_dot * w263 - bar2_e1_dot * w260 + (bar2_e2_dot * w265 - bar2_e3_dot * w264)
    w278 = w277 + (bar2_e2 * w257 - bar2_e3 * w253 - (bar2_e0 * w256 + bar2_e1 * w252) + w277) + w214 * w268
    w279 = w278 + w216 * w248 + w218 * w270 - w220 * w269 + w275 * (bar2_e0 * w272 - bar2_e1 * w271 + (bar2_e2 * w274 - bar2_e3 * w273))
    w280 = bar2_e0_dot * w264 - bar2_e2_dot * w260 + (bar2_e3_dot * w263 - bar2_e1_dot * w265)
    w281 = w280 + (bar2_e0 * w253 - bar2_e2 * w252 - (bar2_e3 * w256 + bar2_e1 * w257) + w280) + w214 * w269
    w282 = w281 - w216 * w270 + w218 * w248 + w220 * w268 + w275 * (bar2_e0 * w273 - bar2_e2 * w271 + (bar2_e3 * w272 - bar2_e1 * w274))
    w283 = bar2_e0_dot * w265 - bar2_e3_dot * w260 + (bar2_e1_dot * w264 - bar2_e2_dot * w263)
    w284 = w283 + (bar2_e0 * w257 - bar2_e3 * w252 + (bar2_e1 * w253 + bar2_e2 * w256) + w283) + w214 * w270
    w285 = w284 + w216 * w269 - w218 * w268 + w220 * w248 + w275 * (bar2_e0 * w274 - bar2_e3 * w271 + (bar2_e1 * w273 - bar2_e2 * w272))
    w286 = bar5_e2 * -2.0
    w287 = 2 * bar5_e0
    w288 = 2 * bar5_e2
    w289 = (w287 * bar5_e1 + w288 * bar5_e3) * bar5_end_y
    w290 = bar5_e3 * -2.0
    w291 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * bar5_end_y
    w292 = w290 * w291
    w293 = (hinge5_angle_dot / 2.0)**2
    w294 = hinge5_angle / 2.0
    w295 = ca.cos(w294)
    w296 = w293 * w295
    w297 = ca.sin(w294)
    w298 = w297 / 2.0
    w299 = w203 + hinge0_angle_ddot * w209
    w300 = w296 * c44 + w298 * c44 * w299
    w301 = 2 * bar5_e3
    w302 = bar5_e1 * -2.0
    w303 = w286 * bar5_e0_dot + bar5_e1_dot * w301 + w287 * bar5_e2_dot + bar5_e3_dot * w302
    w304 = bar5_e0_dot * w302 + w287 * bar5_e1_dot + w290 * bar5_e2_dot + w288 * bar5_e3_dot
    w305 = 2 * bar5_e1
    w306 = (bar5_e2 * w305 - w287 * bar5_e3) * bar5_end_y
    w307 = w291 * w304 - w303 * w306
    w308 = w290 * bar5_e0_dot + w286 * bar5_e1_dot + bar5_e2_dot * w305 + w287 * bar5_e3_dot
    w309 = w306 * w308 - w289 * w304
    w310 = w293 * w297
    w311 = w295 / 2.0
    w312 = w310 * c43 - w299 * (w311 * c43)
    w313 = w287 * w289
    w314 = w296 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w296 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w315 = w298 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w298 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w316 = w314 + w299 * w315
    w317 = (w286 * w289 - w292) * w300 - (w303 * w307 - w308 * w309) - (w289 * w301 - w286 * w291) * w312 - (w313 - w291 * w305) * w316
    w318 = w289 * w302
    w319 = w287 * w291
    w320 = w310 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w310 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w321 = w311 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w311 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w322 = w320 + w299 * w321
    w323 = w317 - (w318 - w319) * w322
    w324 = bar4_e2 * -2.0
    w325 = 2 * bar4_e3
    w326 = 2 * bar4_e0
    w327 = bar4_e1 * -2.0
    w328 = bar4_e0_dot * w324 + bar4_e1_dot * w325 + bar4_e2_dot * w326 + bar4_e3_dot * w327
    w329 = bar4_e3 * -2.0
    w330 = 2 * bar4_e2
    w331 = bar4_e0_dot * w327 + bar4_e1_dot * w326 + bar4_e2_dot * w329 + bar4_e3_dot * w330
    w332 = 2 * bar4_e1
    w333 = (bar4_e3 * w326 + bar4_e2 * w332) * bar4_end_x
    w334 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * bar4_end_x
    w335 = w331 * w333 - w328 * w334
    w336 = bar4_e0_dot * w329 + w324 * bar4_e1_dot + bar4_e2_dot * w332 + w326 * bar4_e3_dot
    w337 = (bar4_e3 * w332 - bar4_e2 * w326) * bar4_end_x
    w338 = w334 * w336 - w331 * w337
    w339 = w329 * w333
    w340 = hinge4_angle / 2.0
    w341 = ca.cos(w340)
    w342 = w341 / 2.0
    w343 = hinge4_angle_dot * w342
    w344 = ca.sin(w340)
    w345 = w344 / 2.0
    w346 = hinge4_angle_dot * w345
    w347 = bar5_e3_dot * w343 - bar5_e0_dot * w346
    w348 = (hinge4_angle_dot / 2.0)**2
    w349 = w341 * w348
    w350 = w344 * w348
    w351 = w204 + hinge0_angle_ddot * w210
    w352 = w347 + (w347 - (bar5_e0 * w349 + bar5_e3 * w350)) - w300 * w341 + w322 * w344 + (bar5_e3 * w342 - bar5_e0 * w345) * w351
    w353 = bar5_e1_dot * w346 + bar5_e2_dot * w343
    w354 = bar5_e2 * w350 - bar5_e1 * w349 - w353 - w353 + w312 * w341 - w316 * w344 - w351 * (bar5_e1 * w345 + bar5_e2 * w342)
    w355 = w326 * w337
    w356 = bar5_e1_dot * w343 - bar5_e2_dot * w346
    w357 = w356 + (w356 - (bar5_e2 * w349 + bar5_e1 * w350)) + w312 * w344 + w316 * w341 + w351 * (bar5_e1 * w342 - bar5_e2 * w345)
    w358 = w328 * w335 - w336 * w338 + (w324 * w337 - w339) * w352 + (w325 * w337 - w324 * w333) * w354 + (w355 - w332 * w333) * w357
    w359 = w327 * w337
    w360 = w326 * w333
    w361 = bar5_e0_dot * w343 + bar5_e3_dot * w346
    w362 = bar5_e0 * w350 - bar5_e3 * w349 - w361 - w361 + w300 * w344 + w322 * w341 - w351 * (bar5_e0 * w342 + bar5_e3 * w345)
    w363 = w289 * w303 - w291 * w308
    w364 = w286 * w306
    w365 = w300 * (w290 * w306 - w318) - (w308 * w363 - w304 * w307) - w312 * (w364 - w313) - w316 * (w305 * w306 - w289 * w290)
    w366 = w287 * w306
    w367 = w365 - w322 * (w366 - w288 * w289)
    w368 = w328 * w337 - w333 * w336
    w369 = w324 * w334
    w370 = w336 * w368 - w331 * w335 + w352 * (w329 * w334 - w359) + w354 * (w369 - w355) + w357 * (w332 * w334 - w329 * w337)
    w371 = w326 * w334
    w372 = w300 * (w291 * w302 - w364) - (w304 * w309 - w303 * w363) - w312 * (w319 - w301 * w306) - w316 * (w292 - w366)
    w373 = w372 - w322 * (w288 * w291 - w302 * w306)
    w374 = w331 * w338 - w328 * w368 + w352 * (w327 * w333 - w369) + w354 * (w360 - w325 * w334) + w357 * (w339 - w371)
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
        w214,  # bar2.e0
        w216,  # bar2.e1
        w218,  # bar2.e2
        w220,  # bar2.e3
        w237 + w218 * (w238 - w229 * w230) + w220 * (w239 - w240),  # bar3.x
        w243 + w220 * (w244 - w227 * w234),  # bar3.y
        w245 + w220 * (w227 * w229 - w224 * w231),  # bar3.z
        w276,  # bar3.e0
        w279,  # bar3.e1
        w282,  # bar3.e2
        w285,  # bar3.e3
        w323 - (w358 + (w359 - w360) * w362),  # bar4.x
        w367 - (w370 + w362 * (w371 - w330 * w337)),  # bar4.y
        w373 - (w374 + w362 * (w330 * w333 - w327 * w334)),  # bar4.z
        w352,  # bar4.e0
        w354,  # bar4.e1
        w357,  # bar4.e2
        w362,  # bar4.e3
        w323,  # bar5.x
        w367,  # bar5.y
        w373,  # bar5.z
        -w300,  # bar5.e0
        w312,  # bar5.e1
        w316,  # bar5.e2
        w322,  # bar5.e3
        w213,  # hinge1.angle
        w275,  # hinge2.angle
        w351,  # hinge4.angle
        w299,  # hinge5.angle
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
    3083 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    c46 = c[46]
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
    w151 = w150 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w150 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w152 = w1 / 2.0
    w153 = w152 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w152 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w154 = w7 / 2.0
    w155 = w6 / 2.0
    w156 = w16 / 2.0
    w157 = w156 * c37
    w158 = w14 / 2.0
    w159 = w158 * c38
    w160 = w156 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w156 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w161 = w158 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w158 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w162 = w51 / 2.0
    w163 = w52 / 2.0
    w164 = w58 / 2.0
    w165 = w57 / 2.0
    w166 = w164 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w164 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w167 = w165 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w165 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w168 = hinge0_angle_dot / 2.0
    w169 = w168**2
    w170 = w1 * w169
    w171 = w170 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w170 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w172 = w3 * w169
    w173 = w172 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w172 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w174 = (hinge1_angle_dot / 2.0)**2
    w175 = w7 * w174
    w176 = w6 * w174
    w177 = w154 * hinge1_angle_dot
    w178 = w155 * hinge1_angle_dot
    w179 = bar1_e0_dot * w177 + bar1_e3_dot * w178
    w180 = w178 * bar1_e2_dot - w177 * bar1_e1_dot
    w181 = w177 * bar1_e2_dot + w178 * bar1_e1_dot
    w182 = bar1_e0_dot * w178 - w177 * bar1_e3_dot
    w183 = w69 * bar1_e0_dot + w75 * bar1_e1_dot + w9 * bar1_e2_dot + w72 * bar1_e3_dot
    w184 = w72 * bar1_e0_dot + w9 * bar1_e1_dot + w70 * bar1_e2_dot + w79 * bar1_e3_dot
    w185 = w11 * w184 - w8 * w183
    w186 = w70 * bar1_e0_dot + w69 * bar1_e1_dot + w10 * bar1_e2_dot + w9 * bar1_e3_dot
    w187 = w8 * w186 - w12 * w184
    w188 = w12 * w183 - w11 * w186
    w189 = hinge2_angle_dot / 2.0
    w190 = w189**2
    w191 = w14 * w190
    w192 = w189 * (w14 * w189) * c37
    w193 = w191 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w191 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w194 = w16 * w190
    w195 = w189 * (w16 * w189) * c38
    w196 = w194 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w194 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w197 = w156 * hinge2_angle_dot
    w198 = w197 * c37
    w199 = w158 * hinge2_angle_dot
    w200 = w199 * c38
    w201 = w197 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w197 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w202 = w199 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w199 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w203 = bar2_e0_dot * w198 + (bar2_e1_dot * w200 + bar2_e2_dot * w201 + bar2_e3_dot * w202)
    w204 = bar2_e0_dot * w200 - w198 * bar2_e1_dot + (bar2_e2_dot * w202 - w201 * bar2_e3_dot)
    w205 = bar2_e0_dot * w201 - w198 * bar2_e2_dot + (w200 * bar2_e3_dot - bar2_e1_dot * w202)
    w206 = bar2_e0_dot * w202 - w198 * bar2_e3_dot + (bar2_e1_dot * w201 - w200 * bar2_e2_dot)
    w207 = w84 * bar2_e0_dot + w90 * bar2_e1_dot + w21 * bar2_e2_dot + w87 * bar2_e3_dot
    w208 = w87 * bar2_e0_dot + w21 * bar2_e1_dot + w85 * bar2_e2_dot + w24 * bar2_e3_dot
    w209 = w23 * w208 - w22 * w207
    w210 = w85 * bar2_e0_dot + w84 * bar2_e1_dot + w20 * bar2_e2_dot + w21 * bar2_e3_dot
    w211 = w22 * w210 - w25 * w208
    w212 = w25 * w207 - w23 * w210
    w213 = w94 * bar3_e0_dot + w118 * bar3_e1_dot + w26 * bar3_e2_dot + w97 * bar3_e3_dot
    w214 = w97 * bar3_e0_dot + w26 * bar3_e1_dot + w95 * bar3_e2_dot + w32 * bar3_e3_dot
    w215 = w34 * w214 - w31 * w213
    w216 = w95 * bar3_e0_dot + w94 * bar3_e1_dot + w28 * bar3_e2_dot + w26 * bar3_e3_dot
    w217 = w31 * w216 - w37 * w214
    w218 = w37 * w213 - w34 * w216
    w219 = w125 * bar4_e0_dot + w134 * bar4_e1_dot + w41 * bar4_e2_dot + w123 * bar4_e3_dot
    w220 = w123 * bar4_e0_dot + w41 * bar4_e1_dot + w127 * bar4_e2_dot + w48 * bar4_e3_dot
    w221 = w46 * w220 - w43 * w219
    w222 = w127 * bar4_e0_dot + w125 * bar4_e1_dot + w39 * bar4_e2_dot + w41 * bar4_e3_dot
    w223 = w43 * w222 - w49 * w220
    w224 = w219 * w221 - w222 * w223
    w225 = w49 * w219 - w46 * w222
    w226 = w222 * w225 - w220 * w221
    w227 = w220 * w223 - w219 * w225
    w228 = w44 * w214 - w38 * w213
    w229 = w38 * w216 - w47 * w214
    w230 = w47 * w213 - w44 * w216
    w231 = w38 * w224 + w44 * w226 + w47 * w227 + w43 * (w213 * w228 - w216 * w229) + w46 * (w216 * w230 - w214 * w228)
    w232 = w231 + w49 * (w214 * w229 - w213 * w230) + w225 * (2 * w230) + w223 * (2 * w229) + w221 * (2 * w228)
    w233 = w30 * w213 - w33 * w214
    w234 = w36 * w214 - w30 * w216
    w235 = w33 * w216 - w36 * w213
    w236 = w43 * (w213 * w233 - w216 * w234) - (w30 * w224 + w33 * w226 + w36 * w227) + w46 * (w216 * w235 - w214 * w233)
    w237 = w236 + w49 * (w214 * w234 - w213 * w235) + w225 * (2 * w235) + w223 * (2 * w234) + w221 * (2 * w233)
    w238 = w162 * hinge4_angle_dot
    w239 = w163 * hinge4_angle_dot
    w240 = bar5_e3_dot * w238 - bar5_e0_dot * w239
    w241 = (hinge4_angle_dot / 2.0)**2
    w242 = w51 * w241
    w243 = w52 * w241
    w244 = w239 * bar5_e1_dot + w238 * bar5_e2_dot
    w245 = w238 * bar5_e1_dot - w239 * bar5_e2_dot
    w246 = w238 * bar5_e0_dot + bar5_e3_dot * w239
    w247 = w54 * w220 - w53 * w219
    w248 = w53 * w222 - w55 * w220
    w249 = w55 * w219 - w54 * w222
    w250 = hinge5_angle_dot / 2.0
    w251 = w250**2
    w252 = w57 * w251
    w253 = w58 * w251
    w254 = w252 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w252 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w255 = w253 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w253 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w256 = w139 * bar5_e0_dot + w146 * bar5_e1_dot + w62 * bar5_e2_dot + w142 * bar5_e3_dot
    w257 = w142 * bar5_e0_dot + w62 * bar5_e1_dot + w140 * bar5_e2_dot + w65 * bar5_e3_dot
    w258 = w64 * w257 - w63 * w256
    w259 = w140 * bar5_e0_dot + w139 * bar5_e1_dot + w61 * bar5_e2_dot + w62 * bar5_e3_dot
    w260 = w63 * w259 - w66 * w257
    w261 = w66 * w256 - w64 * w259
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
    C_q[1, 35] = -w151
    # hinge0.e2
    C_q[2, 5] = 1.0
    C_q[2, 35] = w152 * c31
    # hinge0.e3
    C_q[3, 6] = 1.0
    C_q[3, 35] = -w153
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
    C_q[7, 36] = bar1_e0 * w154 + bar1_e3 * w155
    # hinge1.e1
    C_q[8, 4] = w67
    C_q[8, 5] = w68
    C_q[8, 11] = 1.0
    C_q[8, 36] = -(bar1_e2 * w155 - bar1_e1 * w154)
    # hinge1.e2
    C_q[9, 4] = w7
    C_q[9, 5] = w67
    C_q[9, 12] = 1.0
    C_q[9, 36] = bar1_e2 * w154 + bar1_e1 * w155
    # hinge1.e3
    C_q[10, 3] = w68
    C_q[10, 6] = w67
    C_q[10, 13] = 1.0
    C_q[10, 36] = -(bar1_e0 * w155 - bar1_e3 * w154)
    # hinge1.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = -(w12 * w69 - w71)
    C_q[11, 4] = -(w12 * w75 - w11 * w69)
    C_q[11, 5] = -(w76 - w10 * w11)
    C_q[11, 6] = -(w73 - w77)
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = -(w8 * w70 - w73)
    C_q[12, 4] = -(w74 - w76)
    C_q[12, 5] = -(w8 * w10 - w12 * w70)
    C_q[12, 6] = -(w78 - w12 * w79)
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = -(w11 * w72 - w74)
    C_q[13, 4] = -(w77 - w8 * w75)
    C_q[13, 5] = -(w71 - w78)
    C_q[13, 6] = -(w11 * w79 - w8 * w72)
    C_q[13, 9] = 1.0
    # hinge2.e0
    C_q[14, 10] = w80
    C_q[14, 11] = w17
    C_q[14, 12] = w18
    C_q[14, 13] = w19
    C_q[14, 17] = 1.0
    C_q[14, 37] = bar2_e0 * w157 + (bar2_e1 * w159 + bar2_e2 * w160 + bar2_e3 * w161)
    # hinge2.e1
    C_q[15, 10] = w81
    C_q[15, 11] = w80
    C_q[15, 12] = w83
    C_q[15, 13] = w18
    C_q[15, 18] = 1.0
    C_q[15, 37] = -(bar2_e0 * w159 - bar2_e1 * w157 + (bar2_e2 * w161 - bar2_e3 * w160))
    # hinge2.e2
    C_q[16, 10] = w82
    C_q[16, 11] = w19
    C_q[16, 12] = w80
    C_q[16, 13] = w81
    C_q[16, 19] = 1.0
    C_q[16, 37] = -(bar2_e0 * w160 - bar2_e2 * w157 + (bar2_e3 * w159 - bar2_e1 * w161))
    # hinge2.e3
    C_q[17, 10] = w83
    C_q[17, 11] = w82
    C_q[17, 12] = w17
    C_q[17, 13] = w80
    C_q[17, 20] = 1.0
    C_q[17, 37] = -(bar2_e0 * w161 - bar2_e3 * w157 + (bar2_e1 * w160 - bar2_e2 * w159))
    # hinge2.x
    C_q[18, 7] = -1.0
    C_q[18, 10] = -(w25 * w84 - w86)
    C_q[18, 11] = -(w25 * w90 - w23 * w84)
    C_q[18, 12] = -(w91 - w20 * w23)
    C_q[18, 13] = -(w88 - w92)
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = -(w22 * w85 - w88)
    C_q[19, 11] = -(w89 - w91)
    C_q[19, 12] = -(w20 * w22 - w25 * w85)
    C_q[19, 13] = -(w93 - w24 * w25)
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = -(w23 * w87 - w89)
    C_q[20, 11] = -(w92 - w22 * w90)
    C_q[20, 12] = -(w86 - w93)
    C_q[20, 13] = -(w23 * w24 - w22 * w87)
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = -(w37 * w94 - w96)
    C_q[21, 18] = -(w37 * w118 - w34 * w94)
    C_q[21, 19] = -(w119 - w28 * w34)
    C_q[21, 20] = -(w98 - w120)
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = -(w31 * w95 - w98)
    C_q[22, 18] = -(w99 - w119)
    C_q[22, 19] = -(w28 * w31 - w37 * w95)
    C_q[22, 20] = -(w121 - w32 * w37)
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = -(w34 * w97 - w99)
    C_q[23, 18] = -(w120 - w31 * w118)
    C_q[23, 19] = -(w96 - w121)
    C_q[23, 20] = -(w32 * w34 - w31 * w97)
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
    C_q[26, 38] = -(bar5_e3 * w162 - bar5_e0 * w163)
    # hinge4.e1
    C_q[27, 25] = 1.0
    C_q[27, 32] = w138
    C_q[27, 33] = w52
    C_q[27, 38] = bar5_e1 * w163 + bar5_e2 * w162
    # hinge4.e2
    C_q[28, 26] = 1.0
    C_q[28, 32] = w145
    C_q[28, 33] = w138
    C_q[28, 38] = -(bar5_e1 * w162 - bar5_e2 * w163)
    # hinge4.e3
    C_q[29, 27] = 1.0
    C_q[29, 31] = w52
    C_q[29, 34] = w138
    C_q[29, 38] = bar5_e0 * w162 + bar5_e3 * w163
    # hinge4.x
    C_q[30, 21] = -1.0
    C_q[30, 24] = -(w55 * w125 - w131)
    C_q[30, 25] = -(w55 * w134 - w54 * w125)
    C_q[30, 26] = -(w135 - w39 * w54)
    C_q[30, 27] = -(w132 - w136)
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = -(w53 * w127 - w132)
    C_q[31, 25] = -(w133 - w135)
    C_q[31, 26] = -(w39 * w53 - w55 * w127)
    C_q[31, 27] = -(w137 - w48 * w55)
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = -(w54 * w123 - w133)
    C_q[32, 25] = -(w136 - w53 * w134)
    C_q[32, 26] = -(w131 - w137)
    C_q[32, 27] = -(w48 * w54 - w53 * w123)
    C_q[32, 30] = 1.0
    # hinge5.e0
    C_q[33, 31] = 1.0
    C_q[33, 39] = w164 * c44
    # hinge5.e1
    C_q[34, 32] = 1.0
    C_q[34, 39] = w165 * c43
    # hinge5.e2
    C_q[35, 33] = 1.0
    C_q[35, 39] = -w166
    # hinge5.e3
    C_q[36, 34] = 1.0
    C_q[36, 39] = -w167
    # hinge5.x
    C_q[37, 28] = -1.0
    C_q[37, 31] = -(w66 * w139 - w141)
    C_q[37, 32] = -(w66 * w146 - w64 * w139)
    C_q[37, 33] = -(w147 - w61 * w64)
    C_q[37, 34] = -(w143 - w148)
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = -(w63 * w140 - w143)
    C_q[38, 32] = -(w144 - w147)
    C_q[38, 33] = -(w61 * w63 - w66 * w140)
    C_q[38, 34] = -(w149 - w65 * w66)
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = -(w64 * w142 - w144)
    C_q[39, 32] = -(w148 - w63 * w146)
    C_q[39, 33] = -(w141 - w149)
    C_q[39, 34] = -(w64 * w65 - w63 * w142)
    C_t = ca.SX(40, 1)
    nu = ca.SX(40, 1)
    gamma = ca.vertcat(
        w168 * (w1 * w168) * c45,  # hinge0.e0
        w171,  # hinge0.e1
        w168 * (w3 * w168) * c31,  # hinge0.e2
        w173,  # hinge0.e3
        0.0,  # hinge0.x
        0.0,  # hinge0.y
        0.0,  # hinge0.z
        bar1_e3 * w175 - bar1_e0 * w176 - w179 - w179,  # hinge1.e0
        w180 + (w180 - (bar1_e1 * w176 + bar1_e2 * w175)),  # hinge1.e1
        bar1_e1 * w175 - bar1_e2 * w176 - w181 - w181,  # hinge1.e2
        w182 + (w182 - (bar1_e0 * w175 + bar1_e3 * w176)),  # hinge1.e3
        w183 * w185 - w186 * w187,  # hinge1.x
        w186 * w188 - w184 * w185,  # hinge1.y
        w184 * w187 - w183 * w188,  # hinge1.z
        -(w203 + (bar2_e0 * w192 + (bar2_e2 * w193 - bar2_e1 * w195 + bar2_e3 * w196) + w203)),  # hinge2.e0
        w204 + (bar2_e2 * w196 - bar2_e3 * w193 - (bar2_e0 * w195 + bar2_e1 * w192) + w204),  # hinge2.e1
        w205 + (bar2_e0 * w193 - bar2_e2 * w192 - (bar2_e3 * w195 + bar2_e1 * w196) + w205),  # hinge2.e2
        w206 + (bar2_e0 * w196 - bar2_e3 * w192 + (bar2_e1 * w193 + bar2_e2 * w195) + w206),  # hinge2.e3
        w207 * w209 - w210 * w211,  # hinge2.x
        w210 * w212 - w208 * w209,  # hinge2.y
        w208 * w211 - w207 * w212,  # hinge2.z
        w213 * w215 - w216 * w217,  # hinge3.x
        w216 * w218 - w214 * w215,  # hinge3.y
        w214 * w217 - w213 * w218,  # hinge3.z
        -w232,  # hinge3.parallel_x
        -w237,  # hinge3.parallel_y
        w240 + (w240 - (bar5_e0 * w242 + bar5_e3 * w243)),  # hinge4.e0
        bar5_e2 * w243 - bar5_e1 * w242 - w244 - w244,  # hinge4.e1
        w245 + (w245 - (bar5_e2 * w242 + bar5_e1 * w243)),  # hinge4.e2
        bar5_e0 * w243 - bar5_e3 * w242 - w246 - w246,  # hinge4.e3
        w219 * w247 - w222 * w248,  # hinge4.x
        w222 * w249 - w220 * w247,  # hinge4.y
        w220 * w248 - w219 * w249,  # hinge4.z
        w250 * (w57 * w250) * c46,  # hinge5.e0
        w250 * (w58 * w250) * c43,  # hinge5.e1
        w254,  # hinge5.e2
        w255,  # hinge5.e3
        w256 * w258 - w259 * w260,  # hinge5.x
        w259 * w261 - w257 * w258,  # hinge5.y
        w257 * w260 - w256 * w261,  # hinge5.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 40 x 40) [SI]: mass matrix in all coordinates
    gives K (n x n = 40 x 40) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 40) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 40) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 40) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 40 x 40) [SI]: constraint Jacobian
    gives gamma_b (n_c = 40) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    7075 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    c45 = c[45]
    c46 = c[46]
    bar3_mass = c[47]
    bar2_mass = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    bar1_mass = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    bar4_mass = c[57]
    c58 = c[58]
    c59 = c[59]
    bar5_mass = c[60]
    c61 = c[61]
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
    # intermediate terms (623)
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = w1 * bar1_e3
    w3 = 2 * bar1_e0
    w4 = bar1_e2 * w3
    w5 = w2 - w4
    w6 = w5 * c65
    w7 = bar1_e3 * -2.0
    w8 = bar1_e3 * w3
    w9 = bar1_e2 * w1
    w10 = w8 + w9
    w11 = w10 * c65
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
    w25 = w24 * c65
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
    w37 = w3 * c67
    w38 = w18 * w37 + bar1_e2 * bar1_e3 * c70
    w39 = w3 * c68
    w40 = w18 * c69
    w41 = w0 * w39 + bar1_e1 * bar1_e3 * c71
    w42 = w0 * c67
    w43 = w1 * c68
    w44 = w3 * c69
    w45 = bar1_e2 * bar1_e1 * c72 + w7 * w44
    w46 = bar1_e3 * bar1_e0 * c73 + w31 * w40
    w47 = w7 * w43 + bar1_e2 * bar1_e0 * c74
    w48 = w14 * w42 + bar1_e1 * bar1_e0 * c75
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = w50 * bar2_e1
    w52 = 2 * bar2_e2
    w53 = w52 * bar2_e3
    w54 = w51 + w53
    w55 = w54 * c52
    w56 = bar2_e3 * -2.0
    w57 = 1.0 - 2 * bar2_e1**2
    w58 = 2 * bar2_e3**2
    w59 = w57 - w58
    w60 = w59 * c52
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
    w75 = w74 * c52
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
    w86 = w50 * c76
    w87 = w68 * w86 + bar2_e2 * bar2_e3 * c79
    w88 = w50 * c77
    w89 = w68 * c78
    w90 = w49 * w88 + bar2_e1 * bar2_e3 * c80
    w91 = w49 * c76
    w92 = w66 * c77
    w93 = w50 * c78
    w94 = bar2_e2 * bar2_e1 * c81 + w56 * w93
    w95 = bar2_e0 * bar2_e3 * c82 + w52 * w89
    w96 = w56 * w92 + bar2_e2 * bar2_e0 * c83
    w97 = w63 * w91 + bar2_e0 * bar2_e1 * c84
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
    w136 = w117 * w135 + bar3_e2 * bar3_e3 * c87
    w137 = w106 * c85
    w138 = w117 * c86
    w139 = w98 * w137 + bar3_e1 * bar3_e3 * c88
    w140 = w98 * c22
    w141 = w115 * c85
    w142 = w106 * c86
    w143 = bar3_e2 * bar3_e1 * c89 + w103 * w142
    w144 = bar3_e3 * bar3_e0 * c90 + w104 * w138
    w145 = w103 * w141 + bar3_e2 * bar3_e0 * c91
    w146 = w112 * w140 + bar3_e1 * bar3_e0 * c92
    w147 = bar4_e2 * -2.0
    w148 = 2 * bar4_e1
    w149 = w148 * bar4_e3
    w150 = 2 * bar4_e0
    w151 = bar4_e2 * w150
    w152 = w149 - w151
    w153 = w152 * c59
    w154 = bar4_e3 * -2.0
    w155 = bar4_e3 * w150
    w156 = bar4_e2 * w148
    w157 = w155 + w156
    w158 = w157 * c59
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
    w172 = w171 * c59
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
    w184 = w150 * c93
    w185 = w165 * w184 + bar4_e2 * bar4_e3 * c96
    w186 = w150 * c94
    w187 = w165 * c95
    w188 = w147 * w186 + bar4_e1 * bar4_e3 * c97
    w189 = w147 * c93
    w190 = w148 * c94
    w191 = w150 * c95
    w192 = bar4_e2 * bar4_e1 * c98 + w154 * w191
    w193 = bar4_e3 * bar4_e0 * c99 + w178 * w187
    w194 = w154 * w190 + bar4_e2 * bar4_e0 * c100
    w195 = w161 * w189 + bar4_e1 * bar4_e0 * c101
    w196 = bar5_e2 * -2.0
    w197 = 2 * bar5_e0
    w198 = w197 * bar5_e1
    w199 = 2 * bar5_e2
    w200 = w199 * bar5_e3
    w201 = w198 + w200
    w202 = w201 * c62
    w203 = bar5_e3 * -2.0
    w204 = 1.0 - 2 * bar5_e1**2
    w205 = 2 * bar5_e3**2
    w206 = w204 - w205
    w207 = w206 * c62
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
    w222 = w221 * c62
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
    w233 = w197 * c102
    w234 = w215 * w233 + bar5_e2 * bar5_e3 * c106
    w235 = w197 * c104
    w236 = w215 * c105
    w237 = w196 * w235 + bar5_e1 * bar5_e3 * c107
    w238 = w196 * c102
    w239 = w213 * c104
    w240 = w197 * c105
    w241 = bar5_e2 * bar5_e1 * c108 + w203 * w240
    w242 = bar5_e0 * bar5_e3 * c109 + w199 * w236
    w243 = w203 * w239 + bar5_e2 * bar5_e0 * c110
    w244 = w210 * w238 + bar5_e0 * bar5_e1 * c111
    w245 = w7 * bar1_e0_dot
    w246 = w3 * bar1_e3_dot
    w247 = w245 + w31 * bar1_e1_dot + w18 * bar1_e2_dot + w246
    w248 = w247 * c65
    w249 = w0 * bar1_e0_dot
    w250 = w3 * bar1_e2_dot
    w251 = w249 + w7 * bar1_e1_dot + w250 + w1 * bar1_e3_dot
    w252 = w251 * c65
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
    w264 = w247 * c55
    w265 = w251 * c66
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c54
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w18 * w266 + w0 * w268 + w7 * w269
    w271 = w3 * w266 + w7 * w268 + w31 * w269
    w272 = w14 * w266 + w3 * w268 + w18 * w269
    w273 = w0 * w266 + w1 * w268 + w3 * w269
    w274 = w68 * bar2_e0_dot + w50 * bar2_e1_dot
    w275 = w274 + w63 * bar2_e2_dot + w49 * bar2_e3_dot
    w276 = w275 * c52
    w277 = w56 * bar2_e0_dot
    w278 = w50 * bar2_e3_dot
    w279 = w277 + w52 * bar2_e1_dot + w68 * bar2_e2_dot + w278
    w280 = w279 * c52
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
    w293 = w279 * c56
    w294 = w285 * c49
    w295 = w285 * w293 - w279 * w294
    w296 = w275 * c50
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
    w328 = w308 * c51
    w329 = w315 * w328 - w308 * w325
    w330 = w308 * w326 - w305 * w328
    w331 = w117 * w327 + w98 * w329 + w103 * w330
    w332 = w106 * w327 + w103 * w329 + w104 * w330
    w333 = w112 * w327 + w106 * w329 + w117 * w330
    w334 = w98 * w327 + w115 * w329 + w106 * w330
    w335 = w154 * bar4_e0_dot
    w336 = w150 * bar4_e3_dot
    w337 = w335 + w178 * bar4_e1_dot + w165 * bar4_e2_dot + w336
    w338 = w337 * c59
    w339 = w147 * bar4_e0_dot
    w340 = w150 * bar4_e2_dot
    w341 = w339 + w154 * bar4_e1_dot + w340 + w148 * bar4_e3_dot
    w342 = w341 * c59
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
    w357 = w337 * c64
    w358 = w341 * c16
    w359 = w341 * w357 - w337 * w358
    w360 = w346 * c58
    w361 = w337 * w360 - w346 * w357
    w362 = w346 * w358 - w341 * w360
    w363 = w165 * w359 + w147 * w361 + w154 * w362
    w364 = w150 * w359 + w154 * w361 + w178 * w362
    w365 = w161 * w359 + w150 * w361 + w165 * w362
    w366 = w147 * w359 + w148 * w361 + w150 * w362
    w367 = w215 * bar5_e0_dot + w197 * bar5_e1_dot
    w368 = w367 + w210 * bar5_e2_dot + w196 * bar5_e3_dot
    w369 = w368 * c62
    w370 = w203 * bar5_e0_dot
    w371 = w197 * bar5_e3_dot
    w372 = w370 + w199 * bar5_e1_dot + w215 * bar5_e2_dot + w371
    w373 = w372 * c62
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
    w386 = w372 * c63
    w387 = w378 * c61
    w388 = w378 * w386 - w372 * w387
    w389 = w368 * c103
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
    w432 = w431 * c117
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
    w508 = w507 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w507 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w509 = ca.cos(w505)
    w510 = w509 / 2.0
    w511 = w510 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0 - w510 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w512 = w419 / 2.0
    w513 = w417 / 2.0
    w514 = w433 / 2.0
    w515 = w514 * c37
    w516 = w431 / 2.0
    w517 = w516 * c38
    w518 = w514 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w514 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w519 = w516 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w516 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w520 = w492 / 2.0
    w521 = w494 / 2.0
    w522 = hinge5_angle / 2.0
    w523 = ca.sin(w522)
    w524 = w523 / 2.0
    w525 = ca.cos(w522)
    w526 = w525 / 2.0
    w527 = w524 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w524 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w528 = w526 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w526 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w529 = hinge0_angle_dot / 2.0
    w530 = w529**2
    w531 = w509 * w530
    w532 = w531 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0 - w531 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_0_0_0
    w533 = w506 * w530
    w534 = w533 * ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0 - w533 * ground_P0_quaternion_0_0_0 * bar1_start_quaternion_0_0_0
    w535 = (hinge1_angle_dot / 2.0)**2
    w536 = w419 * w535
    w537 = w417 * w535
    w538 = w512 * hinge1_angle_dot
    w539 = w513 * hinge1_angle_dot
    w540 = bar1_e0_dot * w538 + bar1_e3_dot * w539
    w541 = bar1_e2_dot * w539 - bar1_e1_dot * w538
    w542 = bar1_e2_dot * w538 + bar1_e1_dot * w539
    w543 = bar1_e0_dot * w539 - bar1_e3_dot * w538
    w544 = w250 + (w249 + w14 * bar1_e1_dot) + w18 * bar1_e3_dot
    w545 = w254 + w7 * bar1_e2_dot + w31 * bar1_e3_dot
    w546 = w422 * w545 - w424 * w544
    w547 = w246 + (w245 + w0 * bar1_e1_dot + w1 * bar1_e2_dot)
    w548 = w424 * w547 - w421 * w545
    w549 = w421 * w544 - w422 * w547
    w550 = hinge2_angle_dot / 2.0
    w551 = w550**2
    w552 = w431 * w551
    w553 = w550 * (w431 * w550) * c37
    w554 = w552 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w552 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w555 = w433 * w551
    w556 = w550 * (w433 * w550) * c38
    w557 = w555 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0 - w555 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w558 = w514 * hinge2_angle_dot
    w559 = w558 * c37
    w560 = w516 * hinge2_angle_dot
    w561 = w560 * c38
    w562 = w558 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w558 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w563 = w560 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w560 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w564 = bar2_e0_dot * w559 + (bar2_e1_dot * w561 + bar2_e2_dot * w562 + bar2_e3_dot * w563)
    w565 = bar2_e0_dot * w561 - bar2_e1_dot * w559 + (bar2_e2_dot * w563 - bar2_e3_dot * w562)
    w566 = bar2_e0_dot * w562 - bar2_e2_dot * w559 + (bar2_e3_dot * w561 - bar2_e1_dot * w563)
    w567 = bar2_e0_dot * w563 - bar2_e3_dot * w559 + (bar2_e1_dot * w562 - bar2_e2_dot * w561)
    w568 = w284 + (w283 + w63 * bar2_e1_dot) + w68 * bar2_e3_dot
    w569 = w274 + w56 * bar2_e2_dot + w52 * bar2_e3_dot
    w570 = w441 * w569 - w443 * w568
    w571 = w278 + (w277 + w49 * bar2_e1_dot + w66 * bar2_e2_dot)
    w572 = w443 * w571 - w440 * w569
    w573 = w440 * w568 - w441 * w571
    w574 = w304 + (w303 + w112 * bar3_e1_dot) + w117 * bar3_e3_dot
    w575 = w307 + w103 * bar3_e2_dot + w104 * bar3_e3_dot
    w576 = w450 * w575 - w452 * w574
    w577 = w314 + (w313 + w98 * bar3_e1_dot + w115 * bar3_e2_dot)
    w578 = w452 * w577 - w449 * w575
    w579 = w449 * w574 - w450 * w577
    w580 = w340 + (w339 + w161 * bar4_e1_dot) + w165 * bar4_e3_dot
    w581 = w345 + w154 * bar4_e2_dot + w178 * bar4_e3_dot
    w582 = w351 * w581 - w344 * w580
    w583 = w336 + (w335 + w147 * bar4_e1_dot + w148 * bar4_e2_dot)
    w584 = w344 * w583 - w355 * w581
    w585 = w580 * w582 - w583 * w584
    w586 = w355 * w580 - w351 * w583
    w587 = w583 * w586 - w581 * w582
    w588 = w581 * w584 - w580 * w586
    w589 = w321 * w575 - w312 * w574
    w590 = w312 * w577 - w323 * w575
    w591 = w323 * w574 - w321 * w577
    w592 = w312 * w585 + w321 * w587 + w323 * w588 + w344 * (w574 * w589 - w577 * w590) + w351 * (w577 * w591 - w575 * w589)
    w593 = w592 + w355 * (w575 * w590 - w574 * w591) + w586 * (2 * w591) + w584 * (2 * w590) + w582 * (2 * w589)
    w594 = w123 * w574 - w108 * w575
    w595 = w101 * w575 - w123 * w577
    w596 = w108 * w577 - w101 * w574
    w597 = w344 * (w574 * w594 - w577 * w595) - (w123 * w585 + w108 * w587 + w101 * w588) + w351 * (w577 * w596 - w575 * w594)
    w598 = w597 + w355 * (w575 * w595 - w574 * w596) + w586 * (2 * w596) + w584 * (2 * w595) + w582 * (2 * w594)
    w599 = w520 * hinge4_angle_dot
    w600 = w521 * hinge4_angle_dot
    w601 = bar5_e3_dot * w599 - bar5_e0_dot * w600
    w602 = (hinge4_angle_dot / 2.0)**2
    w603 = w492 * w602
    w604 = w494 * w602
    w605 = bar5_e1_dot * w600 + bar5_e2_dot * w599
    w606 = bar5_e1_dot * w599 - bar5_e2_dot * w600
    w607 = bar5_e0_dot * w599 + bar5_e3_dot * w600
    w608 = w483 * w581 - w485 * w580
    w609 = w485 * w583 - w482 * w581
    w610 = w482 * w580 - w483 * w583
    w611 = hinge5_angle_dot / 2.0
    w612 = w611**2
    w613 = w525 * w612
    w614 = w523 * w612
    w615 = w613 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w613 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w616 = w614 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0 - w614 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0
    w617 = w377 + (w376 + w210 * bar5_e1_dot) + w215 * bar5_e3_dot
    w618 = w367 + w203 * bar5_e2_dot + w199 * bar5_e3_dot
    w619 = w496 * w618 - w498 * w617
    w620 = w371 + (w370 + w196 * bar5_e1_dot + w213 * bar5_e2_dot)
    w621 = w498 * w620 - w495 * w618
    w622 = w495 * w617 - w496 * w620
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
    M[3, 3] = w18 * (w18 * c67) + w0 * (w0 * c68) + w7 * (w7 * c69)
    M[3, 4] = w38
    M[3, 5] = w41
    M[3, 6] = w45
    # bar1.e1
    M[4, 0] = w15
    M[4, 1] = w28
    M[4, 2] = w34
    M[4, 3] = w38
    M[4, 4] = w3 * w37 + w7 * (w7 * c68) + w31 * (w31 * c69)
    M[4, 5] = w46
    M[4, 6] = w47
    # bar1.e2
    M[5, 0] = w17
    M[5, 1] = w29
    M[5, 2] = w35
    M[5, 3] = w41
    M[5, 4] = w46
    M[5, 5] = w14 * (w14 * c67) + w3 * w39 + w18 * w40
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
    M[10, 10] = w68 * (w68 * c76) + w49 * (w49 * c77) + w56 * (w56 * c78)
    M[10, 11] = w87
    M[10, 12] = w90
    M[10, 13] = w94
    # bar2.e1
    M[11, 7] = w64
    M[11, 8] = w78
    M[11, 9] = w83
    M[11, 10] = w87
    M[11, 11] = w50 * w86 + w56 * (w56 * c77) + w52 * (w52 * c78)
    M[11, 12] = w95
    M[11, 13] = w96
    # bar2.e2
    M[12, 7] = w67
    M[12, 8] = w79
    M[12, 9] = w84
    M[12, 10] = w90
    M[12, 11] = w95
    M[12, 12] = w63 * (w63 * c76) + w50 * w88 + w68 * w89
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
    M[17, 17] = w117 * (w117 * c22) + w98 * (w98 * c85) + w103 * (w103 * c86)
    M[17, 18] = w136
    M[17, 19] = w139
    M[17, 20] = w143
    # bar3.e1
    M[18, 14] = w113
    M[18, 15] = w127
    M[18, 16] = w132
    M[18, 17] = w136
    M[18, 18] = w106 * w135 + w103 * (w103 * c85) + w104 * (w104 * c86)
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
    M[24, 24] = w165 * (w165 * c93) + w147 * (w147 * c94) + w154 * (w154 * c95)
    M[24, 25] = w185
    M[24, 26] = w188
    M[24, 27] = w192
    # bar4.e1
    M[25, 21] = w162
    M[25, 22] = w175
    M[25, 23] = w181
    M[25, 24] = w185
    M[25, 25] = w150 * w184 + w154 * (w154 * c94) + w178 * (w178 * c95)
    M[25, 26] = w193
    M[25, 27] = w194
    # bar4.e2
    M[26, 21] = w164
    M[26, 22] = w176
    M[26, 23] = w182
    M[26, 24] = w188
    M[26, 25] = w193
    M[26, 26] = w161 * (w161 * c93) + w150 * w186 + w165 * w187
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
    M[31, 31] = w215 * (w215 * c102) + w196 * (w196 * c104) + w203 * (w203 * c105)
    M[31, 32] = w234
    M[31, 33] = w237
    M[31, 34] = w241
    # bar5.e1
    M[32, 28] = w211
    M[32, 29] = w225
    M[32, 30] = w230
    M[32, 31] = w234
    M[32, 32] = w197 * w233 + w203 * (w203 * c104) + w199 * (w199 * c105)
    M[32, 33] = w242
    M[32, 34] = w243
    # bar5.e2
    M[33, 28] = w214
    M[33, 29] = w226
    M[33, 30] = w231
    M[33, 31] = w237
    M[33, 32] = w242
    M[33, 33] = w210 * (w210 * c102) + w197 * w235 + w215 * w236
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
    Q_F[1] = c112  # bar1.y
    Q_F[3] = w396  # bar1.e0
    Q_F[4] = w397  # bar1.e1
    Q_F[5] = w398  # bar1.e2
    Q_F[6] = w399  # bar1.e3
    Q_F[8] = c113  # bar2.y
    Q_F[10] = w400  # bar2.e0
    Q_F[11] = w401  # bar2.e1
    Q_F[12] = w402  # bar2.e2
    Q_F[13] = w403  # bar2.e3
    Q_F[15] = c114  # bar3.y
    Q_F[17] = w404  # bar3.e0
    Q_F[18] = w405  # bar3.e1
    Q_F[19] = w406  # bar3.e2
    Q_F[20] = w407  # bar3.e3
    Q_F[22] = c115  # bar4.y
    Q_F[24] = w408  # bar4.e0
    Q_F[25] = w409  # bar4.e1
    Q_F[26] = w410  # bar4.e2
    Q_F[27] = w411  # bar4.e3
    Q_F[29] = c116  # bar5.y
    Q_F[31] = w412  # bar5.e0
    Q_F[32] = w413  # bar5.e1
    Q_F[33] = w414  # bar5.e2
    Q_F[34] = w415  # bar5.e3
    Q_star = ca.vertcat(
        w258,  # bar1.x
        w262 + c112,  # bar1.y
        w263,  # bar1.z
        w270 + w396,  # bar1.e0
        w271 + w397,  # bar1.e1
        w272 + w398,  # bar1.e2
        w273 + w399,  # bar1.e3
        w290,  # bar2.x
        w291 + c113,  # bar2.y
        w292,  # bar2.z
        w299 + w400,  # bar2.e0
        w300 + w401,  # bar2.e1
        w301 + w402,  # bar2.e2
        w302 + w403,  # bar2.e3
        w320,  # bar3.x
        w322 + c114,  # bar3.y
        w324,  # bar3.z
        w331 + w404,  # bar3.e0
        w332 + w405,  # bar3.e1
        w333 + w406,  # bar3.e2
        w334 + w407,  # bar3.e3
        w349,  # bar4.x
        w354 + c115,  # bar4.y
        w356,  # bar4.z
        w363 + w408,  # bar4.e0
        w364 + w409,  # bar4.e1
        w365 + w410,  # bar4.e2
        w366 + w411,  # bar4.e3
        w383,  # bar5.x
        w384 + c116,  # bar5.y
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
    C_q[1, 35] = -w508
    # hinge0.e2
    C_q[2, 5] = 1.0
    C_q[2, 35] = w510 * c31
    # hinge0.e3
    C_q[3, 6] = 1.0
    C_q[3, 35] = -w511
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
    C_q[7, 36] = bar1_e0 * w512 + bar1_e3 * w513
    # hinge1.e1
    C_q[8, 4] = w418
    C_q[8, 5] = w420
    C_q[8, 11] = 1.0
    C_q[8, 36] = -(bar1_e2 * w513 - bar1_e1 * w512)
    # hinge1.e2
    C_q[9, 4] = w419
    C_q[9, 5] = w418
    C_q[9, 12] = 1.0
    C_q[9, 36] = bar1_e2 * w512 + bar1_e1 * w513
    # hinge1.e3
    C_q[10, 3] = w420
    C_q[10, 6] = w418
    C_q[10, 13] = 1.0
    C_q[10, 36] = -(bar1_e0 * w513 - bar1_e3 * w512)
    # hinge1.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = -(w0 * w421 - w423)
    C_q[11, 4] = -(w14 * w421 - w0 * w422)
    C_q[11, 5] = -(w427 - w1 * w422)
    C_q[11, 6] = -(w425 - w428)
    C_q[11, 7] = 1.0
    # hinge1.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = -(w7 * w424 - w425)
    C_q[12, 4] = -(w426 - w427)
    C_q[12, 5] = -(w1 * w424 - w7 * w421)
    C_q[12, 6] = -(w429 - w31 * w421)
    C_q[12, 8] = 1.0
    # hinge1.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = -(w18 * w422 - w426)
    C_q[13, 4] = -(w428 - w14 * w424)
    C_q[13, 5] = -(w423 - w429)
    C_q[13, 6] = -(w31 * w422 - w18 * w424)
    C_q[13, 9] = 1.0
    # hinge2.e0
    C_q[14, 10] = w432
    C_q[14, 11] = w434
    C_q[14, 12] = w436
    C_q[14, 13] = w438
    C_q[14, 17] = 1.0
    C_q[14, 37] = bar2_e0 * w515 + (bar2_e1 * w517 + bar2_e2 * w518 + bar2_e3 * w519)
    # hinge2.e1
    C_q[15, 10] = w435
    C_q[15, 11] = w432
    C_q[15, 12] = w439
    C_q[15, 13] = w436
    C_q[15, 18] = 1.0
    C_q[15, 37] = -(bar2_e0 * w517 - bar2_e1 * w515 + (bar2_e2 * w519 - bar2_e3 * w518))
    # hinge2.e2
    C_q[16, 10] = w437
    C_q[16, 11] = w438
    C_q[16, 12] = w432
    C_q[16, 13] = w435
    C_q[16, 19] = 1.0
    C_q[16, 37] = -(bar2_e0 * w518 - bar2_e2 * w515 + (bar2_e3 * w517 - bar2_e1 * w519))
    # hinge2.e3
    C_q[17, 10] = w439
    C_q[17, 11] = w437
    C_q[17, 12] = w434
    C_q[17, 13] = w432
    C_q[17, 20] = 1.0
    C_q[17, 37] = -(bar2_e0 * w519 - bar2_e3 * w515 + (bar2_e1 * w518 - bar2_e2 * w517))
    # hinge2.x
    C_q[18, 7] = -1.0
    C_q[18, 10] = -(w49 * w440 - w442)
    C_q[18, 11] = -(w63 * w440 - w49 * w441)
    C_q[18, 12] = -(w446 - w66 * w441)
    C_q[18, 13] = -(w444 - w447)
    C_q[18, 14] = 1.0
    # hinge2.y
    C_q[19, 8] = -1.0
    C_q[19, 10] = -(w56 * w443 - w444)
    C_q[19, 11] = -(w445 - w446)
    C_q[19, 12] = -(w66 * w443 - w56 * w440)
    C_q[19, 13] = -(w448 - w52 * w440)
    C_q[19, 15] = 1.0
    # hinge2.z
    C_q[20, 9] = -1.0
    C_q[20, 10] = -(w68 * w441 - w445)
    C_q[20, 11] = -(w447 - w63 * w443)
    C_q[20, 12] = -(w442 - w448)
    C_q[20, 13] = -(w52 * w441 - w68 * w443)
    C_q[20, 16] = 1.0
    # hinge3.x
    C_q[21, 14] = -1.0
    C_q[21, 17] = -(w98 * w449 - w451)
    C_q[21, 18] = -(w112 * w449 - w98 * w450)
    C_q[21, 19] = -(w473 - w115 * w450)
    C_q[21, 20] = -(w453 - w474)
    C_q[21, 21] = 1.0
    # hinge3.y
    C_q[22, 15] = -1.0
    C_q[22, 17] = -(w103 * w452 - w453)
    C_q[22, 18] = -(w454 - w473)
    C_q[22, 19] = -(w115 * w452 - w103 * w449)
    C_q[22, 20] = -(w475 - w104 * w449)
    C_q[22, 22] = 1.0
    # hinge3.z
    C_q[23, 16] = -1.0
    C_q[23, 17] = -(w117 * w450 - w454)
    C_q[23, 18] = -(w474 - w112 * w452)
    C_q[23, 19] = -(w451 - w475)
    C_q[23, 20] = -(w104 * w450 - w117 * w452)
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
    C_q[26, 38] = -(bar5_e3 * w520 - bar5_e0 * w521)
    # hinge4.e1
    C_q[27, 25] = 1.0
    C_q[27, 32] = w493
    C_q[27, 33] = w494
    C_q[27, 38] = bar5_e1 * w521 + bar5_e2 * w520
    # hinge4.e2
    C_q[28, 26] = 1.0
    C_q[28, 32] = w501
    C_q[28, 33] = w493
    C_q[28, 38] = -(bar5_e1 * w520 - bar5_e2 * w521)
    # hinge4.e3
    C_q[29, 27] = 1.0
    C_q[29, 31] = w494
    C_q[29, 34] = w493
    C_q[29, 38] = bar5_e0 * w520 + bar5_e3 * w521
    # hinge4.x
    C_q[30, 21] = -1.0
    C_q[30, 24] = -(w147 * w482 - w484)
    C_q[30, 25] = -(w161 * w482 - w147 * w483)
    C_q[30, 26] = -(w488 - w148 * w483)
    C_q[30, 27] = -(w486 - w489)
    C_q[30, 28] = 1.0
    # hinge4.y
    C_q[31, 22] = -1.0
    C_q[31, 24] = -(w154 * w485 - w486)
    C_q[31, 25] = -(w487 - w488)
    C_q[31, 26] = -(w148 * w485 - w154 * w482)
    C_q[31, 27] = -(w490 - w178 * w482)
    C_q[31, 29] = 1.0
    # hinge4.z
    C_q[32, 23] = -1.0
    C_q[32, 24] = -(w165 * w483 - w487)
    C_q[32, 25] = -(w489 - w161 * w485)
    C_q[32, 26] = -(w484 - w490)
    C_q[32, 27] = -(w178 * w483 - w165 * w485)
    C_q[32, 30] = 1.0
    # hinge5.e0
    C_q[33, 31] = 1.0
    C_q[33, 39] = w524 * c44
    # hinge5.e1
    C_q[34, 32] = 1.0
    C_q[34, 39] = w526 * c43
    # hinge5.e2
    C_q[35, 33] = 1.0
    C_q[35, 39] = -w527
    # hinge5.e3
    C_q[36, 34] = 1.0
    C_q[36, 39] = -w528
    # hinge5.x
    C_q[37, 28] = -1.0
    C_q[37, 31] = -(w196 * w495 - w497)
    C_q[37, 32] = -(w210 * w495 - w196 * w496)
    C_q[37, 33] = -(w502 - w213 * w496)
    C_q[37, 34] = -(w499 - w503)
    # hinge5.y
    C_q[38, 29] = -1.0
    C_q[38, 31] = -(w203 * w498 - w499)
    C_q[38, 32] = -(w500 - w502)
    C_q[38, 33] = -(w213 * w498 - w203 * w495)
    C_q[38, 34] = -(w504 - w199 * w495)
    # hinge5.z
    C_q[39, 30] = -1.0
    C_q[39, 31] = -(w215 * w496 - w500)
    C_q[39, 32] = -(w503 - w210 * w498)
    C_q[39, 33] = -(w497 - w504)
    C_q[39, 34] = -(w199 * w496 - w215 * w498)
    gamma_b = ca.vertcat(
        w529 * (w509 * w529) * c45,  # hinge0.e0
        w532,  # hinge0.e1
        w529 * (w506 * w529) * c31,  # hinge0.e2
        w534,  # hinge0.e3
        0.0,  # hinge0.x
        0.0,  # hinge0.y
        0.0,  # hinge0.z
        bar1_e3 * w536 - bar1_e0 * w537 - w540 - w540,  # hinge1.e0
        w541 + (w541 - (bar1_e1 * w537 + bar1_e2 * w536)),  # hinge1.e1
        bar1_e1 * w536 - bar1_e2 * w537 - w542 - w542,  # hinge1.e2
        w543 + (w543 - (bar1_e0 * w536 + bar1_e3 * w537)),  # hinge1.e3
        w544 * w546 - w547 * w548,  # hinge1.x
        w547 * w549 - w545 * w546,  # hinge1.y
        w545 * w548 - w544 * w549,  # hinge1.z
        -(w564 + (bar2_e0 * w553 + (bar2_e2 * w554 - bar2_e1 * w556 + bar2_e3 * w557) + w564)),  # hinge2.e0
        w565 + (bar2_e2 * w557 - bar2_e3 * w554 - (bar2_e0 * w556 + bar2_e1 * w553) + w565),  # hinge2.e1
        w566 + (bar2_e0 * w554 - bar2_e2 * w553 - (bar2_e3 * w556 + bar2_e1 * w557) + w566),  # hinge2.e2
        w567 + (bar2_e0 * w557 - bar2_e3 * w553 + (bar2_e1 * w554 + bar2_e2 * w556) + w567),  # hinge2.e3
        w568 * w570 - w571 * w572,  # hinge2.x
        w571 * w573 - w569 * w570,  # hinge2.y
        w569 * w572 - w568 * w573,  # hinge2.z
        w574 * w576 - w577 * w578,  # hinge3.x
        w577 * w579 - w575 * w576,  # hinge3.y
        w575 * w578 - w574 * w579,  # hinge3.z
        -w593,  # hinge3.parallel_x
        -w598,  # hinge3.parallel_y
        w601 + (w601 - (bar5_e0 * w603 + bar5_e3 * w604)),  # hinge4.e0
        bar5_e2 * w604 - bar5_e1 * w603 - w605 - w605,  # hinge4.e1
        w606 + (w606 - (bar5_e2 * w603 + bar5_e1 * w604)),  # hinge4.e2
        bar5_e0 * w604 - bar5_e3 * w603 - w607 - w607,  # hinge4.e3
        w580 * w608 - w583 * w609,  # hinge4.x
        w583 * w610 - w581 * w608,  # hinge4.y
        w581 * w609 - w580 * w610,  # hinge4.z
        w611 * (w525 * w611) * c46,  # hinge5.e0
        w611 * (w523 * w611) * c43,  # hinge5.e1
        w615,  # hinge5.e2
        w616,  # hinge5.e3
        w617 * w619 - w620 * w621,  # hinge5.x
        w620 * w622 - w618 * w619,  # hinge5.y
        w618 * w621 - w617 * w622,  # hinge5.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b; lam_R: multipliers of the redundant rows, which the others go with (Eq. 37).

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 40) [mixed]: rates of all coordinates
    takes q_ddot (n = 40) [mixed]: accelerations of all coordinates
    takes lam_R (n_R = 1) [N, N m]: multipliers of the redundant rows, which no equation determines
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 40) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 6) [N, N m]: world force and moment of a joint on its body b, at b
    3029 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
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
    bar3_mass = c[47]
    bar2_mass = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    bar1_mass = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    bar4_mass = c[57]
    c58 = c[58]
    c59 = c[59]
    bar5_mass = c[60]
    c61 = c[61]
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
    # intermediate terms (749)
    w0 = bar1_e1 * -2.0
    w1 = bar1_e3 * -2.0
    w2 = 2 * bar1_e2
    w3 = 2 * bar1_e0
    w4 = bar1_e0_dot * w1 + bar1_e1_dot * w2 + w0 * bar1_e2_dot + bar1_e3_dot * w3
    w5 = w4 * c55
    w6 = bar1_e2 * -2.0
    w7 = 2 * bar1_e1
    w8 = bar1_e0_dot * w6 + w1 * bar1_e1_dot + bar1_e2_dot * w3 + bar1_e3_dot * w7
    w9 = w8 * c66
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * bar1_e3
    w12 = w0 * bar1_e0_dot + bar1_e1_dot * w3 + bar1_e2_dot * w11 + bar1_e3_dot * w6
    w13 = w12 * c54
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = 2 * bar1_e2**2
    w17 = 2 * bar1_e3**2
    w18 = 1.0 - w16 - w17
    w19 = w18 * c65
    w20 = bar1_e3 * w7
    w21 = bar1_e2 * w3
    w22 = w20 - w21
    w23 = w22 * c65
    w24 = w0 * w23
    w25 = w1 * w19 - w24
    w26 = bar1_e3 * w3
    w27 = bar1_e2 * w7
    w28 = w26 + w27
    w29 = w28 * c65
    w30 = w1 * w29
    w31 = w6 * w23 - w30
    w32 = w6 * w19
    w33 = w0 * w29 - w32
    w34 = w31 * bar1_x_ddot + w25 * bar1_y_ddot + w33 * bar1_z_ddot + (w0 * (w0 * c67) + w6 * (w6 * c68) + w1 * (w1 * c69)) * bar1_e0_ddot
    w35 = w3 * c67
    w36 = w0 * w35 + bar1_e3 * bar1_e2 * c70
    w37 = w3 * c68
    w38 = w0 * c69
    w39 = w6 * w37 + bar1_e1 * bar1_e3 * c71
    w40 = w6 * c67
    w41 = w7 * c68
    w42 = w3 * c69
    w43 = bar1_e1 * bar1_e2 * c72 + w1 * w42
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
    w57 = w56 * c52
    w58 = bar2_e3 * -2.0
    w59 = bar2_e0_dot * w58 + w50 * bar2_e1_dot + w53 * bar2_e2_dot + w48 * bar2_e3_dot
    w60 = w59 * c52
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
    w73 = w72 * c52
    w74 = bar2_e2 * w62
    w75 = w48 * bar2_e3
    w76 = w74 - w75
    w77 = w76 * c52
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
    w124 = ca.sin(hinge0_angle)
    w125 = ca.cos(hinge1_angle)
    w126 = ca.sin(hinge2_angle)
    w127 = w125 * w126 * bar3_end_z
    w128 = w125 * bar2_end_y - w127
    w129 = w124 * w128
    w130 = ca.cos(hinge0_angle)
    w131 = w128 * w130
    w132 = ca.sin(hinge1_angle)
    w133 = ca.cos(hinge2_angle)
    w134 = w124 * w132
    w135 = (w130 * w133 - w126 * w134) * bar3_end_z
    w136 = w124 * w125
    w137 = w132 * w135 - w127 * w136
    w138 = ca.sin(hinge5_angle)
    w139 = ca.sin(hinge4_angle)
    w140 = ca.cos(hinge5_angle)
    w141 = w139 * bar4_end_x
    w142 = ca.sqrt(w131**2 + w137**2 + w141**2)
    w143 = w131 / w142
    w144 = w125 * w130
    w145 = w130 * w132
    w146 = (w126 * w145 + w124 * w133) * bar3_end_z
    w147 = w127 * w144 + w132 * w146
    w148 = w137 / w142
    w149 = ca.cos(hinge4_angle)
    w150 = w149 * bar4_end_x
    w151 = w138 * w150
    w152 = w141 / w142
    w153 = w129 * w143 + w147 * w148 + w151 * w152
    w154 = w143 * w153 - w129
    w155 = w147 - w148 * w153
    w156 = w136 * w146 + w135 * w144
    w157 = w140 * w150
    w158 = w130 * (w146 - w145 * bar2_end_y) - w124 * (w135 + w134 * bar2_end_y)
    w159 = w152 * w157 - (w143 * w158 + w148 * w156)
    w160 = w156 + w148 * w159
    w161 = w158 + w143 * w159
    w162 = w157 - w152 * w159
    w163 = w138 * bar5_end_y - w138 * w139 * bar4_end_x
    w164 = ca.sqrt(w161**2 + w160**2 + w162**2 + w163**2)
    w165 = w160 / w164
    w166 = w161 / w164
    w167 = w152 * w153 - w151
    w168 = w162 / w164
    w169 = w139 * w140 * bar4_end_x - w140 * bar5_end_y
    w170 = w163 / w164
    w171 = w155 * w165 - w154 * w166 + w167 * w168 - w169 * w170
    w172 = w154 + w166 * w171
    w173 = w155 - w165 * w171
    w174 = w167 - w168 * w171
    w175 = w169 + w170 * w171
    w176 = ca.sqrt(w172**2 + w173**2 + w174**2 + w175**2)
    w177 = w172 / w176
    w178 = hinge1_angle / 2.0
    w179 = ca.cos(w178)
    w180 = w179 / 2.0
    w181 = ca.sin(w178)
    w182 = w181 / 2.0
    w183 = w59 * c56
    w184 = w66 * c49
    w185 = w66 * w183 - w59 * w184
    w186 = w56 * c50
    w187 = w59 * w186 - w56 * w183
    w188 = w56 * w184 - w66 * w186
    w189 = w52 * c52
    w190 = w83 - w50 * w189
    w191 = w53 * w189
    w192 = w191 - w80
    w193 = w55 * c76
    w194 = w62 * c77
    w195 = w48 * c78
    w196 = bar2_e1 * bar2_e2 * c81 + w58 * w195
    w197 = w58 * w194 + bar2_e0 * bar2_e2 * c83
    w198 = w192 * bar2_x_ddot + w190 * bar2_y_ddot + bar2_z_ddot * w85 + bar2_e0_ddot * w196 + bar2_e1_ddot * w197
    w199 = w54 * w193 + bar2_e0 * bar2_e1 * c84
    w200 = w55 * w185 + w62 * w187 + w48 * w188 + w190 * gravity_y - (w198 + bar2_e2_ddot * w199 + bar2_e3_ddot * (w55 * w193 + w62 * w194 + w48 * w195))
    w201 = w72 * bar2_end_y
    w202 = w76 * bar2_end_y
    w203 = w50 * w201 - w53 * w202
    w204 = w48 * w202
    w205 = w52 * bar2_end_y
    w206 = w204 - w50 * w205
    w207 = bar3_e3 * w92
    w208 = bar3_e2 * w93
    w209 = w207 + w208
    w210 = 2 * bar3_e3**2
    w211 = w89 * c4
    w212 = w96 * w211
    w213 = w91 * w113 - w212
    w214 = w92 * w211
    w215 = w114 - w214
    w216 = w93 * w113 - w91 * w211
    w217 = w119 - w104 * w211
    w218 = bar3_y_ddot * bar3_mass + bar3_e0_ddot * w213 + bar3_e1_ddot * w215 + bar3_e2_ddot * w216 + bar3_e3_ddot * w217
    w219 = c114 + (w100 * w110 - (w106 * w209 + w109 * (w87 - w210))) - w218
    w220 = w53 * w205
    w221 = w48 * w201
    w222 = w220 - w221
    w223 = 1.0 - w88 - w210
    w224 = w90 * w211 - w118
    w225 = w97 * w211 - w90 * w111
    w226 = w214 - w93 * w111
    w227 = w212 - w116
    w228 = bar3_x_ddot * bar3_mass + bar3_e0_ddot * w224 + bar3_e1_ddot * w225 + bar3_e2_ddot * w226 + bar3_e3_ddot * w227
    w229 = w100 * w112 - (w106 * w223 + w109 * (w208 - w207)) - w228
    w230 = hinge2_angle / 2.0
    w231 = ca.cos(w230)
    w232 = w231 * c37
    w233 = w105 * c0
    w234 = w94 * c1
    w235 = w94 * w233 - w105 * w234
    w236 = w98 * c51
    w237 = w105 * w236 - w98 * w233
    w238 = w98 * w234 - w94 * w236
    w239 = w90 * c22
    w240 = w93 * c85
    w241 = w92 * c86
    w242 = bar3_e1 * bar3_e2 * c89 + w91 * w241
    w243 = w91 * w240 + bar3_e2 * bar3_e0 * c91
    w244 = bar3_x_ddot * w227 + bar3_y_ddot * w217 + bar3_z_ddot * w121 + bar3_e0_ddot * w242 + bar3_e1_ddot * w243
    w245 = w97 * w239 + bar3_e1 * bar3_e0 * c92
    w246 = w90 * w235 + w93 * w237 + w92 * w238 + w217 * gravity_y - (w244 + bar3_e2_ddot * w245 + bar3_e3_ddot * (w90 * w239 + w93 * w240 + w92 * w241))
    w247 = 1.0 - 2 * bar4_e1**2
    w248 = 2 * bar4_e3**2
    w249 = w247 - w248
    w250 = w89 * w249
    w251 = 2 * bar4_e0
    w252 = bar4_e1 * w251
    w253 = 2 * bar4_e2
    w254 = bar4_e3 * w253
    w255 = w252 + w254
    w256 = w110 * w255
    w257 = w250 - w256
    w258 = w112 * w255
    w259 = 2 * bar4_e1
    w260 = bar4_e2 * w259
    w261 = bar4_e3 * w251
    w262 = w260 - w261
    w263 = w89 * w262
    w264 = w258 - w263
    w265 = w110 * w262
    w266 = w112 * w249
    w267 = w265 - w266
    w268 = w246 - (w104 * w257 + w96 * w264 + w92 * w267) * lam_R0
    w269 = ca.sin(w230)
    w270 = w269 * c38
    w271 = w92 * c85
    w272 = w96 * c86
    w273 = w90 * w271 + bar3_e1 * bar3_e3 * c88
    w274 = bar3_e3 * bar3_e0 * c90 + w104 * w272
    w275 = bar3_x_ddot * w226 + bar3_y_ddot * w216 + bar3_z_ddot * w120 + bar3_e0_ddot * w273 + bar3_e1_ddot * w274
    w276 = w97 * w235 + w92 * w237 + w96 * w238 + w216 * gravity_y - (w275 + bar3_e2_ddot * (w97 * (w97 * c22) + w92 * w271 + w96 * w272) + bar3_e3_ddot * w245)
    w277 = w276 - lam_R0 * (w91 * w257 + w92 * w264 + w93 * w267)
    w278 = w231 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0 - w231 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0
    w279 = w92 * c22
    w280 = w96 * w279 + bar3_e2 * bar3_e3 * c87
    w281 = bar3_x_ddot * w225 + bar3_y_ddot * w215 + bar3_z_ddot * w117 + bar3_e0_ddot * w280 + bar3_e1_ddot * (w92 * w279 + w91 * (w91 * c85) + w104 * (w104 * c86))
    w282 = w92 * w235 + w91 * w237 + w104 * w238 + w215 * gravity_y - (w281 + bar3_e2_ddot * w274 + bar3_e3_ddot * w243)
    w283 = w282 - lam_R0 * (w92 * w257 + w97 * w264 + w90 * w267)
    w284 = w269 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w269 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w285 = bar3_x_ddot * w224 + bar3_y_ddot * w213 + bar3_z_ddot * w115 + bar3_e0_ddot * (w96 * (w96 * c22) + w90 * (w90 * c85) + w91 * (w91 * c86))
    w286 = w96 * w235 + w90 * w237 + w91 * w238 + w213 * gravity_y - (w285 + bar3_e1_ddot * w280 + bar3_e2_ddot * w273 + bar3_e3_ddot * w242)
    w287 = w286 - lam_R0 * (w96 * w257 + w90 * w264 + w91 * w267)
    w288 = w200 + w123 * w203 + w206 * w219 + w222 * w229 + w232 * w268 + w270 * w277 - w278 * w283 - w284 * w287
    w289 = w62 * w77 - w58 * w189
    w290 = w48 * w189
    w291 = w290 - w62 * w73
    w292 = w48 * c77
    w293 = w53 * c78
    w294 = w55 * w292 + bar2_e1 * bar2_e3 * c80
    w295 = bar2_e0 * bar2_e3 * c82 + w50 * w293
    w296 = bar2_x_ddot * w291 + bar2_y_ddot * w289 + bar2_z_ddot * w84 + bar2_e0_ddot * w294 + bar2_e1_ddot * w295
    w297 = w54 * w185 + w48 * w187 + w53 * w188 + w289 * gravity_y - (w296 + bar2_e2_ddot * (w54 * (w54 * c76) + w48 * w292 + w53 * w293) + bar2_e3_ddot * w199)
    w298 = w58 * w201
    w299 = w298 - w204
    w300 = w62 * w202 - w58 * w205
    w301 = w48 * w205
    w302 = w301 - w62 * w201
    w303 = w297 + w123 * w299 + w219 * w300 + w229 * w302 - w268 * w270 + w232 * w277 + w283 * w284 - w278 * w287
    w304 = w78 - w290
    w305 = w54 * w189 - w55 * w73
    w306 = w48 * c76
    w307 = w53 * w306 + bar2_e2 * bar2_e3 * c79
    w308 = bar2_x_ddot * w305 + bar2_y_ddot * w304 + bar2_z_ddot * w81 + bar2_e0_ddot * w307 + bar2_e1_ddot * (w48 * w306 + w58 * (w58 * c77) + w50 * (w50 * c78))
    w309 = w48 * w185 + w58 * w187 + w50 * w188 + w304 * gravity_y - (w308 + bar2_e2_ddot * w295 + bar2_e3_ddot * w197)
    w310 = w221 - w54 * w202
    w311 = w55 * w202
    w312 = w311 - w301
    w313 = w54 * w205 - w55 * w201
    w314 = w309 + w123 * w310 + w219 * w312 + w229 * w313 + w268 * w278 - w277 * w284 + w232 * w283 - w270 * w287
    w315 = (bar1_e0 * w180 - bar1_e3 * w182) * w288 - (bar1_e2 * w182 + bar1_e1 * w180) * w303 + (bar1_e2 * w180 - bar1_e1 * w182) * w314
    w316 = w58 * w77 - w191
    w317 = w55 * w189 - w82
    w318 = bar2_x_ddot * w317 + bar2_y_ddot * w316 + bar2_z_ddot * w79 + bar2_e0_ddot * (w53 * (w53 * c76) + w55 * (w55 * c77) + w58 * (w58 * c78))
    w319 = w53 * w185 + w55 * w187 + w58 * w188 + w316 * gravity_y - (w318 + bar2_e1_ddot * w307 + bar2_e2_ddot * w294 + bar2_e3_ddot * w196)
    w320 = w53 * w201 - w311
    w321 = w58 * w202 - w220
    w322 = w55 * w205 - w298
    w323 = w319 + w123 * w320 + w219 * w321 + w229 * w322 + w268 * w284 + w277 * w278 + w270 * w283 + w232 * w287
    w324 = w315 - (bar1_e0 * w182 + bar1_e3 * w180) * w323
    w325 = w173 / w176
    w326 = w231 / 2.0
    w327 = w326 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0 - w326 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w328 = w269 / 2.0
    w329 = w328 * c37
    w330 = w328 * bar2_end_quaternion_3_0_0 * bar3_start_quaternion_1_0_0 - w328 * bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w331 = w326 * c38
    w332 = w268 * (bar2_e0 * w327 - bar2_e3 * w329 + (bar2_e1 * w330 - bar2_e2 * w331)) + w277 * (bar2_e0 * w330 - bar2_e2 * w329 + (bar2_e3 * w331 - bar2_e1 * w327))
    w333 = w332 + w283 * (bar2_e0 * w331 - bar2_e1 * w329 + (bar2_e2 * w327 - bar2_e3 * w330)) - w287 * (bar2_e0 * w329 + (bar2_e1 * w331 + bar2_e2 * w330 + bar2_e3 * w327))
    w334 = w174 / w176
    w335 = hinge4_angle / 2.0
    w336 = ca.cos(w335)
    w337 = w336 / 2.0
    w338 = ca.sin(w335)
    w339 = w338 / 2.0
    w340 = 2 * bar4_e3
    w341 = bar4_e3 * -2.0
    w342 = bar4_e1 * -2.0
    w343 = bar4_e0_dot * w341 + w253 * bar4_e1_dot + bar4_e2_dot * w342 + w251 * bar4_e3_dot
    w344 = w343 * c64
    w345 = bar4_e2 * -2.0
    w346 = bar4_e0_dot * w345 + w341 * bar4_e1_dot + w251 * bar4_e2_dot + w259 * bar4_e3_dot
    w347 = w346 * c16
    w348 = w344 * w346 - w343 * w347
    w349 = bar4_e0_dot * w342 + w251 * bar4_e1_dot + w340 * bar4_e2_dot + bar4_e3_dot * w345
    w350 = w349 * c58
    w351 = w343 * w350 - w344 * w349
    w352 = w347 * w349 - w346 * w350
    w353 = 2 * bar4_e2**2
    w354 = 1.0 - w353 - w248
    w355 = w354 * c59
    w356 = bar4_e3 * w259
    w357 = w251 * bar4_e2
    w358 = w356 - w357
    w359 = w358 * c59
    w360 = w259 * w355 - w341 * w359
    w361 = w251 * w359
    w362 = w260 + w261
    w363 = w362 * c59
    w364 = w361 - w259 * w363
    w365 = w341 * w363
    w366 = w251 * w355
    w367 = w365 - w366
    w368 = w251 * c94
    w369 = w342 * c95
    w370 = w345 * w368 + bar4_e1 * bar4_e3 * c97
    w371 = bar4_e3 * bar4_e0 * c99 + w253 * w369
    w372 = w364 * bar4_x_ddot + w360 * bar4_y_ddot + w367 * bar4_z_ddot + w370 * bar4_e0_ddot + w371 * bar4_e1_ddot
    w373 = w345 * c93
    w374 = w259 * c94
    w375 = w251 * c95
    w376 = w340 * w373 + bar4_e1 * bar4_e0 * c101
    w377 = w340 * w348 + w251 * w351 + w342 * w352 + w360 * gravity_y - (w372 + (w340 * (w340 * c93) + w251 * w368 + w342 * w369) * bar4_e2_ddot + w376 * bar4_e3_ddot)
    w378 = w256 - w250
    w379 = w263 - w258
    w380 = w266 - w265
    w381 = w377 - lam_R0 * (w341 * w378 + w251 * w379 + w259 * w380)
    w382 = w362 * bar4_end_x
    w383 = w341 * w382
    w384 = w354 * bar4_end_x
    w385 = w251 * w384
    w386 = w383 - w385
    w387 = w343 * c59
    w388 = w346 * c59
    w389 = w343 * w387 + w346 * w388
    w390 = w349 * w388
    w391 = w247 - w353
    w392 = w349 * w387
    w393 = w345 * w355
    w394 = w342 * w363 - w393
    w395 = w251 * w363
    w396 = w395 - w340 * w355
    w397 = w253 * w363 - w342 * w355
    w398 = bar4_z_ddot * bar4_mass + bar4_e0_ddot * w394 + bar4_e1_ddot * w396 + w367 * bar4_e2_ddot + bar4_e3_ddot * w397
    w399 = w358 * w389 - w255 * w390 - w391 * w392 - w398
    w400 = w358 * bar4_end_x
    w401 = w259 * w384 - w341 * w400
    w402 = w254 - w252
    w403 = w342 * w359
    w404 = w341 * w355 - w403
    w405 = w393 - w361
    w406 = w366 - w253 * w359
    w407 = bar4_y_ddot * bar4_mass + bar4_e0_ddot * w404 + bar4_e1_ddot * w405 + w360 * bar4_e2_ddot + bar4_e3_ddot * w406
    w408 = c115 + (w362 * w389 - w249 * w390 - w392 * w402) - w407
    w409 = w251 * w400
    w410 = w409 - w259 * w382
    w411 = w356 + w357
    w412 = w345 * w359 - w365
    w413 = w340 * w359 - w345 * w363
    w414 = w403 - w395
    w415 = bar4_x_ddot * bar4_mass + bar4_e0_ddot * w412 + bar4_e1_ddot * w413 + w364 * bar4_e2_ddot + bar4_e3_ddot * w414
    w416 = w354 * w389 - w262 * w390 - w392 * w411 - w415
    w417 = w381 - w386 * w399 - w401 * w408 - w410 * w416
    w418 = bar4_e1 * bar4_e2 * c98 + w341 * w375
    w419 = w341 * w374 + bar4_e0 * bar4_e2 * c100
    w420 = bar4_x_ddot * w414 + bar4_y_ddot * w406 + bar4_z_ddot * w397 + bar4_e0_ddot * w418 + bar4_e1_ddot * w419
    w421 = w345 * w348 + w259 * w351 + w251 * w352 + w406 * gravity_y - (w420 + bar4_e2_ddot * w376 + bar4_e3_ddot * (w345 * w373 + w259 * w374 + w251 * w375))
    w422 = w421 - lam_R0 * (w253 * w378 + w342 * w379 + w251 * w380)
    w423 = w253 * w382 - w342 * w384
    w424 = w385 - w253 * w400
    w425 = w342 * w400
    w426 = w251 * w382
    w427 = w425 - w426
    w428 = w422 - w399 * w423 - w408 * w424 - w416 * w427
    w429 = w251 * c93
    w430 = w342 * w429 + bar4_e3 * bar4_e2 * c96
    w431 = bar4_x_ddot * w413 + bar4_y_ddot * w405 + bar4_z_ddot * w396 + bar4_e0_ddot * w430 + bar4_e1_ddot * (w251 * w429 + w341 * (w341 * c94) + w253 * (w253 * c95))
    w432 = w251 * w348 + w341 * w351 + w253 * w352 + w405 * gravity_y - (w431 + w371 * bar4_e2_ddot + bar4_e3_ddot * w419)
    w433 = w432 - lam_R0 * (w251 * w378 + w340 * w379 + w345 * w380)
    w434 = w426 - w340 * w384
    w435 = w345 * w384
    w436 = w435 - w409
    w437 = w340 * w400 - w345 * w382
    w438 = w433 - w399 * w434 - w408 * w436 - w416 * w437
    w439 = (bar5_e1 * w337 - w339 * bar5_e2) * w417 - (w337 * bar5_e0 + w339 * bar5_e3) * w428 - (bar5_e1 * w339 + w337 * bar5_e2) * w438
    w440 = bar4_x_ddot * w412 + bar4_y_ddot * w404 + bar4_z_ddot * w394 + bar4_e0_ddot * (w342 * (w342 * c93) + w345 * (w345 * c94) + w341 * (w341 * c95))
    w441 = w342 * w348 + w345 * w351 + w341 * w352 + w404 * gravity_y - (w440 + bar4_e1_ddot * w430 + w370 * bar4_e2_ddot + bar4_e3_ddot * w418)
    w442 = w441 - lam_R0 * (w342 * w378 + w345 * w379 + w341 * w380)
    w443 = w342 * w382 - w435
    w444 = w341 * w384 - w425
    w445 = w345 * w400 - w383
    w446 = w442 - w399 * w443 - w408 * w444 - w416 * w445
    w447 = w439 + (w337 * bar5_e3 - w339 * bar5_e0) * w446
    w448 = w175 / w176
    w449 = hinge5_angle / 2.0
    w450 = ca.cos(w449) / 2.0
    w451 = w450 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_1_0_0 - w450 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w452 = bar5_e2 * -2.0
    w453 = bar5_e3 * -2.0
    w454 = 2 * bar5_e2
    w455 = bar5_e1 * -2.0
    w456 = 2 * bar5_e0
    w457 = bar5_e0_dot * w453 + bar5_e1_dot * w454 + bar5_e2_dot * w455 + bar5_e3_dot * w456
    w458 = w457 * c63
    w459 = 2 * bar5_e1
    w460 = w452 * bar5_e0_dot + w453 * bar5_e1_dot + bar5_e2_dot * w456 + bar5_e3_dot * w459
    w461 = w460 * c61
    w462 = w458 * w460 - w457 * w461
    w463 = 2 * bar5_e3
    w464 = bar5_e0_dot * w455 + bar5_e1_dot * w456 + bar5_e2_dot * w463 + w452 * bar5_e3_dot
    w465 = w464 * c103
    w466 = w457 * w465 - w458 * w464
    w467 = w461 * w464 - w460 * w465
    w468 = bar5_e2 * w459
    w469 = bar5_e3 * w456
    w470 = w468 - w469
    w471 = w470 * c62
    w472 = w456 * w471
    w473 = bar5_e1 * w456
    w474 = bar5_e3 * w454
    w475 = w473 + w474
    w476 = w475 * c62
    w477 = w472 - w454 * w476
    w478 = w455 * w476
    w479 = 1.0 - 2 * bar5_e1**2
    w480 = 2 * bar5_e3**2
    w481 = w479 - w480
    w482 = w481 * c62
    w483 = w456 * w482
    w484 = w478 - w483
    w485 = w454 * w482 - w455 * w471
    w486 = w452 * c102
    w487 = w459 * c104
    w488 = w456 * c105
    w489 = bar5_e1 * bar5_e2 * c108 + w453 * w488
    w490 = w453 * w487 + bar5_e2 * bar5_e0 * c110
    w491 = w484 * bar5_x_ddot + w477 * bar5_y_ddot + w485 * bar5_z_ddot + w489 * bar5_e0_ddot + w490 * bar5_e1_ddot
    w492 = w463 * w486 + bar5_e1 * bar5_e0 * c111
    w493 = w452 * w462 + w459 * w466 + w456 * w467 + w477 * gravity_y - (w491 + w492 * bar5_e2_ddot + (w452 * w486 + w459 * w487 + w456 * w488) * bar5_e3_ddot)
    w494 = w481 * bar5_end_y
    w495 = w470 * bar5_end_y
    w496 = w454 * w494 - w455 * w495
    w497 = w464 * c62
    w498 = w457 * c62
    w499 = w464 * w497 + w457 * w498
    w500 = bar5_e3 * w459
    w501 = bar5_e2 * w456
    w502 = w500 - w501
    w503 = w460 * w497
    w504 = 2 * bar5_e2**2
    w505 = w460 * w498
    w506 = w452 * w471
    w507 = w455 * w482 - w506
    w508 = w483 - w463 * w471
    w509 = w453 * w482
    w510 = w509 - w472
    w511 = bar5_z_ddot * bar5_mass + bar5_e0_ddot * w507 + bar5_e1_ddot * w508 + bar5_e2_ddot * w510 + w485 * bar5_e3_ddot
    w512 = w475 * w499 - w502 * w503 - (w479 - w504) * w505 - w511
    w513 = w399 + w512
    w514 = w456 * w495
    w515 = w475 * bar5_end_y
    w516 = w514 - w454 * w515
    w517 = w468 + w469
    w518 = w453 * w471 - w478
    w519 = w456 * w476
    w520 = w506 - w519
    w521 = w459 * w471 - w453 * w476
    w522 = bar5_y_ddot * bar5_mass + bar5_e0_ddot * w518 + bar5_e1_ddot * w520 + bar5_e2_ddot * w521 + w477 * bar5_e3_ddot
    w523 = c116 + (w481 * w499 - w503 * w517 - w505 * (w474 - w473)) - w522
    w524 = w408 + w523
    w525 = w455 * w515
    w526 = w456 * w494
    w527 = w525 - w526
    w528 = 1.0 - w504 - w480
    w529 = w452 * w476 - w509
    w530 = w463 * w476 - w452 * w482
    w531 = w519 - w459 * w482
    w532 = bar5_x_ddot * bar5_mass + bar5_e0_ddot * w529 + bar5_e1_ddot * w530 + bar5_e2_ddot * w531 + w484 * bar5_e3_ddot
    w533 = w470 * w499 - w503 * w528 - w505 * (w500 + w501) - w532
    w534 = w416 + w533
    w535 = ca.sin(w449) / 2.0
    w536 = w535 * ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0 - w535 * ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w537 = w456 * c104
    w538 = w455 * c105
    w539 = w452 * w537 + bar5_e1 * bar5_e3 * c107
    w540 = bar5_e0 * bar5_e3 * c109 + w454 * w538
    w541 = bar5_x_ddot * w531 + bar5_y_ddot * w521 + bar5_z_ddot * w510 + bar5_e0_ddot * w539 + bar5_e1_ddot * w540
    w542 = w462 * w463 + w456 * w466 + w455 * w467 + w521 * gravity_y - (w541 + bar5_e2_ddot * (w463 * (w463 * c102) + w456 * w537 + w455 * w538) + w492 * bar5_e3_ddot)
    w543 = w453 * w494
    w544 = w543 - w514
    w545 = w459 * w495 - w453 * w515
    w546 = w456 * w515
    w547 = w546 - w459 * w494
    w548 = w451 * (w493 + w336 * w428 + w338 * w446 - w496 * w513 - w516 * w524 - w527 * w534) + w536 * (w542 + w336 * w417 - w338 * w438 - w513 * w544 - w524 * w545 - w534 * w547)
    w549 = w456 * c102
    w550 = w455 * w549 + bar5_e2 * bar5_e3 * c106
    w551 = bar5_x_ddot * w530 + bar5_y_ddot * w520 + bar5_z_ddot * w508 + bar5_e0_ddot * w550 + bar5_e1_ddot * (w456 * w549 + w453 * (w453 * c104) + w454 * (w454 * c105))
    w552 = w456 * w462 + w453 * w466 + w454 * w467 + w520 * gravity_y - (w551 + bar5_e2_ddot * w540 + w490 * bar5_e3_ddot)
    w553 = w526 - w463 * w495
    w554 = w452 * w495
    w555 = w554 - w546
    w556 = w463 * w515 - w452 * w494
    w557 = bar5_x_ddot * w529 + bar5_y_ddot * w518 + bar5_z_ddot * w507 + bar5_e0_ddot * (w455 * (w455 * c102) + w452 * (w452 * c104) + w453 * (w453 * c105))
    w558 = w455 * w462 + w452 * w466 + w453 * w467 + w518 * gravity_y - (w557 + bar5_e1_ddot * w550 + bar5_e2_ddot * w539 + w489 * bar5_e3_ddot)
    w559 = w455 * w494 - w554
    w560 = w453 * w495 - w525
    w561 = w452 * w515 - w543
    w562 = w548 - w450 * c43 * (w552 + w338 * w417 + w336 * w438 - w513 * w553 - w524 * w555 - w534 * w556) - w535 * c44 * (w558 - w338 * w428 + w336 * w446 - w513 * w559 - w524 * w560 - w534 * w561)
    w563 = w140 * w149
    w564 = w136 * w563
    w565 = w138 * w149
    w566 = w132 * w565
    w567 = w564 - w566
    w568 = w144 * w563
    w569 = w132 * w139
    w570 = w568 - w569
    w571 = w124 * w567 + w130 * w570
    w572 = w144 * w565
    w573 = w136 * w139
    w574 = w144 * w567 + w132 * (w572 - w573) - w136 * w570
    w575 = w138 * (w573 - w572) + w140 * (w569 - w568)
    w576 = w143 * w571 - w148 * w574 - w152 * w575
    w577 = w571 - w143 * w576
    w578 = w574 + w148 * w576
    w579 = w575 + w152 * w576
    w580 = w566 - w564
    w581 = w165 * w578 - w166 * w577 - w168 * w579 - w170 * w580
    w582 = w577 + w166 * w581
    w583 = w578 - w165 * w581
    w584 = w579 + w168 * w581
    w585 = w580 + w170 * w581
    w586 = w177 * w582 + w325 * w583 - w334 * w584 + w448 * w585
    w587 = w582 - w177 * w586
    w588 = w583 - w325 * w586
    w589 = w584 + w334 * w586
    w590 = w448 * w586 - w585
    w591 = ca.sqrt(w587**2 + w588**2 + w589**2 + w590**2)
    w592 = (w324 * (w587 / w591) + w333 * (w588 / w591) - w447 * (w589 / w591) + w562 * (w590 / w591)) / w591
    w593 = (w177 * w324 + w325 * w333 + w334 * w447 - w448 * w562 - w586 * w592) / w176
    w594 = w123 + w593
    w595 = w52 * w61 - w65 * w67 - (w68 - w69) * w70 - w86 + w594
    w596 = w22 * bar1_end_x
    w597 = w0 * w596
    w598 = w74 + w75
    w599 = bar2_y_ddot * bar2_mass + bar2_e0_ddot * w316 + bar2_e1_ddot * w304 + bar2_e2_ddot * w289 + bar2_e3_ddot * w190
    w600 = (w165 * w333 - w166 * w324 + w168 * w447 + w170 * w562 - w581 * w592 - w171 * w593) / w164
    w601 = w219 + w600
    w602 = c113 + (w61 * w72 - w67 * w598 - w70 * (w51 - w49)) - w599 + w601
    w603 = w1 * w45
    w604 = 1.0 - w69 - w71
    w605 = bar2_x_ddot * bar2_mass + bar2_e0_ddot * w317 + bar2_e1_ddot * w305 + bar2_e2_ddot * w291 + bar2_e3_ddot * w192
    w606 = (w143 * w324 - w148 * w333 + w152 * w447 - w576 * w592 + w153 * w593 - w159 * w600) / w142
    w607 = w229 + w606
    w608 = w61 * w76 - w67 * w604 - w70 * (w63 + w64) - w605 + w607
    w609 = w89 * bar3_end_z
    w610 = w96 * w609
    w611 = w110 * bar3_end_z
    w612 = w92 * w611
    w613 = w112 * bar3_end_z
    w614 = w92 * w613
    w615 = w209 * w255
    w616 = w103 * w249
    w617 = w615 - w616
    w618 = w103 * w262
    w619 = w223 * w255
    w620 = w618 - w619
    w621 = w223 * w249
    w622 = w209 * w262
    w623 = w621 - w622
    w624 = w268 + w606 * (w610 - w612) + w600 * (w614 - w104 * w609) + w593 * (w104 * w611 - w96 * w613) - w592 * (w104 * w617 + w96 * w620 + w92 * w623)
    w625 = w92 * w609
    w626 = w91 * w611
    w627 = w277 + w606 * (w625 - w93 * w611) + w600 * (w93 * w613 - w91 * w609) + w593 * (w626 - w614) - w592 * (w91 * w617 + w92 * w620 + w93 * w623)
    w628 = w90 * w613
    w629 = w283 + w606 * (w97 * w609 - w90 * w611) + w600 * (w628 - w625) + w593 * (w612 - w97 * w613) - w592 * (w92 * w617 + w97 * w620 + w90 * w623)
    w630 = w287 + w606 * (w90 * w609 - w626) + w600 * (w91 * w613 - w610) + w593 * (w96 * w611 - w628) - w592 * (w96 * w617 + w90 * w620 + w91 * w623)
    w631 = w200 + w203 * w594 + w206 * w601 + w222 * w607 + w232 * w624 + w270 * w627 - w278 * w629 - w284 * w630
    w632 = w44 + (w0 * w45 - w47) * w595 + (w1 * w46 - w597) * w602 + (w6 * w596 - w603) * w608 + w181 * w631
    w633 = w319 + w320 * w594 + w321 * w601 + w322 * w607 + w284 * w624 + w278 * w627 + w270 * w629 + w232 * w630
    w634 = w632 + w179 * w633
    w635 = w3 * w23
    w636 = w32 - w635
    w637 = w11 * w23 - w6 * w29
    w638 = w3 * w29
    w639 = w638 - w11 * w19
    w640 = bar1_x_ddot * w637 + bar1_y_ddot * w636 + bar1_z_ddot * w639 + bar1_e0_ddot * w36 + bar1_e1_ddot * (w3 * w35 + w1 * (w1 * c68) + w2 * (w2 * c69))
    w641 = bar1_e3 * bar1_e0 * c73 + w2 * w38
    w642 = w1 * w41 + bar1_e2 * bar1_e0 * c74
    w643 = w3 * w10 + w1 * w14 + w2 * w15 + w636 * gravity_y - (w640 + bar1_e2_ddot * w641 + bar1_e3_ddot * w642)
    w644 = w3 * w45
    w645 = w3 * w596
    w646 = w297 + w299 * w594 + w300 * w601 + w302 * w607 - w270 * w624 + w232 * w627 + w284 * w629 - w278 * w630
    w647 = w643 + w595 * (w644 - w11 * w46) + w602 * (w47 - w645) + w608 * (w11 * w596 - w6 * w45) - w181 * w646
    w648 = w309 + w310 * w594 + w312 * w601 + w313 * w607 + w278 * w624 - w284 * w627 + w232 * w629 - w270 * w630
    w649 = w647 + w179 * w648
    w650 = w7 * w19 - w1 * w23
    w651 = w635 - w7 * w29
    w652 = w3 * w19
    w653 = w30 - w652
    w654 = bar1_x_ddot * w651 + bar1_y_ddot * w650 + bar1_z_ddot * w653 + bar1_e0_ddot * w39 + bar1_e1_ddot * w641
    w655 = w11 * w40 + bar1_e1 * bar1_e0 * c75
    w656 = w10 * w11 + w3 * w14 + w0 * w15 + w650 * gravity_y - (w654 + bar1_e2_ddot * (w11 * (w11 * c67) + w3 * w37 + w0 * w38) + bar1_e3_ddot * w655)
    w657 = w3 * w46
    w658 = w656 + w595 * (w603 - w657) + w602 * (w7 * w46 - w1 * w596) + w608 * (w645 - w7 * w45) + w179 * w646
    w659 = w658 + w181 * w648
    w660 = w652 - w2 * w23
    w661 = w24 - w638
    w662 = w2 * w29 - w0 * w19
    w663 = bar1_x_ddot * w661 + bar1_y_ddot * w660 + bar1_z_ddot * w662 + bar1_e0_ddot * w43 + bar1_e1_ddot * w642
    w664 = w6 * w10 + w7 * w14 + w3 * w15 + w660 * gravity_y - (w663 + bar1_e2_ddot * w655 + bar1_e3_ddot * (w6 * w40 + w7 * w41 + w3 * w42))
    w665 = w664 + w595 * (w2 * w45 - w0 * w46) + w602 * (w657 - w2 * w596) + w608 * (w597 - w644) + w179 * w631
    w666 = w665 - w181 * w633
    w667 = w4 * c65
    w668 = w8 * c65
    w669 = w4 * w667 + w8 * w668
    w670 = w12 * w668
    w671 = w20 + w21
    w672 = w12 * w667
    w673 = bar1_x_ddot * bar1_mass + w31 * bar1_e0_ddot + bar1_e1_ddot * w637 + bar1_e2_ddot * w651 + bar1_e3_ddot * w661
    w674 = w608 + (w18 * w669 - (w27 - w26) * w670 - w671 * w672 - w673)
    w675 = 1.0 - 2 * bar1_e1**2
    w676 = bar1_e3 * w2
    w677 = bar1_e1 * w3
    w678 = w676 - w677
    w679 = bar1_y_ddot * bar1_mass + w25 * bar1_e0_ddot + bar1_e1_ddot * w636 + bar1_e2_ddot * w650 + bar1_e3_ddot * w660
    w680 = w602 + (c112 + (w28 * w669 - w670 * (w675 - w17) - w672 * w678) - w679)
    w681 = w675 - w16
    w682 = bar1_z_ddot * bar1_mass + w33 * bar1_e0_ddot + bar1_e1_ddot * w639 + bar1_e2_ddot * w653 + bar1_e3_ddot * w662
    w683 = w595 + (w22 * w669 - w670 * (w676 + w677) - w672 * w681 - w682)
    w684 = w616 - w615
    w685 = w619 - w618
    w686 = w622 - w621
    w687 = w399 - w593
    w688 = w408 - w600
    w689 = w416 - w606
    w690 = w442 - w592 * (w342 * w684 + w345 * w685 + w341 * w686) - w443 * w687 - w444 * w688 - w445 * w689
    w691 = w433 - w592 * (w251 * w684 + w340 * w685 + w345 * w686) - w434 * w687 - w436 * w688 - w437 * w689
    w692 = w381 - w592 * (w341 * w684 + w251 * w685 + w259 * w686) - w386 * w687 - w401 * w688 - w410 * w689
    w693 = w422 - w592 * (w253 * w684 + w342 * w685 + w251 * w686) - w423 * w687 - w424 * w688 - w427 * w689
    w694 = w512 + w687
    w695 = w523 + w688
    w696 = w533 + w689
    w697 = w558 - w338 * w693 + w336 * w690 - w559 * w694 - w560 * w695 - w561 * w696
    w698 = w552 + w338 * w692 + w336 * w691 - w553 * w694 - w555 * w695 - w556 * w696
    w699 = w542 + w336 * w692 - w338 * w691 - w544 * w694 - w545 * w695 - w547 * w696
    w700 = w493 + w336 * w693 + w338 * w690 - w496 * w694 - w516 * w695 - w527 * w696
    w701 = bar1_e1 * 0.5
    w702 = bar1_e0 * 0.5
    w703 = bar1_e3 * 0.5
    w704 = bar1_e2 * 0.5
    w705 = bar2_e3 * 0.5
    w706 = bar2_e0 * 0.5
    w707 = bar2_e1 * 0.5
    w708 = w678 * w706 - w671 * w705 + w681 * w707
    w709 = bar2_e2 * 0.5
    w710 = w671 * w707 + w678 * w709 + w681 * w705
    w711 = w671 * w706 + w678 * w705 - w681 * w709
    w712 = w671 * w709 - w678 * w707 + w681 * w706
    w713 = w646 * (w705 + w671 * w708) - (w633 * (w671 * w710 - w707) + w648 * (w706 - w671 * w711)) - w631 * (w709 - w671 * w712)
    w714 = w631 * (w707 + w678 * w712) - (w633 * (w678 * w710 - w709) + w648 * (w705 - w678 * w711) + w646 * (w706 - w678 * w708))
    w715 = w648 * (w709 + w681 * w711) - w633 * (w681 * w710 - w705) - w646 * (w707 - w681 * w708) - w631 * (w706 - w681 * w712)
    w716 = bar3_e3 * 0.5
    w717 = bar3_e0 * 0.5
    w718 = bar3_e1 * 0.5
    w719 = w598 * w717 - w604 * w716 + w65 * w718
    w720 = bar3_e2 * 0.5
    w721 = w604 * w718 + w598 * w720 + w65 * w716
    w722 = w604 * w717 + w598 * w716 - w65 * w720
    w723 = w604 * w720 - w598 * w718 + w65 * w717
    w724 = w627 * (w716 + w604 * w719) - (w630 * (w604 * w721 - w718) + w629 * (w717 - w604 * w722)) - w624 * (w720 - w604 * w723)
    w725 = w624 * (w718 + w598 * w723) - (w630 * (w598 * w721 - w720) + w629 * (w716 - w598 * w722) + w627 * (w717 - w598 * w719))
    w726 = w629 * (w720 + w65 * w722) - w630 * (w65 * w721 - w716) - w627 * (w718 - w65 * w719) - w624 * (w717 - w65 * w723)
    w727 = bar4_e0 * 0.5
    w728 = bar4_e2 * 0.5
    w729 = bar4_e3 * 0.5
    w730 = w391 * w728 - (w411 * w727 + w402 * w729)
    w731 = bar4_e1 * 0.5
    w732 = w411 * w731 + w402 * w728 + w391 * w729
    w733 = w411 * w729 - w402 * w727 - w391 * w731
    w734 = w402 * w731 - w411 * w728 - w391 * w727
    w735 = w691 * (w727 + w411 * w730) - w690 * (w731 - w411 * w732) - w692 * (w729 - w411 * w733) + w693 * (w728 + w411 * w734)
    w736 = w691 * (w729 + w402 * w730) - w690 * (w728 - w402 * w732) + w692 * (w727 + w402 * w733) - w693 * (w731 - w402 * w734)
    w737 = w692 * (w731 + w391 * w733) - (w690 * (w729 - w391 * w732) + w691 * (w728 - w391 * w730)) + w693 * (w727 + w391 * w734)
    w738 = bar5_e0 * 0.5
    w739 = bar5_e2 * 0.5
    w740 = bar5_e3 * 0.5
    w741 = w502 * w739 - (w528 * w738 + w517 * w740)
    w742 = bar5_e1 * 0.5
    w743 = w528 * w742 + w517 * w739 + w502 * w740
    w744 = w528 * w740 - w517 * w738 - w502 * w742
    w745 = w517 * w742 - w528 * w739 - w502 * w738
    w746 = w698 * (w738 + w528 * w741) - w697 * (w742 - w528 * w743) - w699 * (w740 - w528 * w744) + w700 * (w739 + w528 * w745)
    w747 = w698 * (w740 + w517 * w741) - w697 * (w739 - w517 * w743) + w699 * (w738 + w517 * w744) - w700 * (w742 - w517 * w745)
    w748 = w699 * (w742 + w502 * w744) - (w697 * (w740 - w502 * w743) + w698 * (w739 - w502 * w741)) + w700 * (w738 + w502 * w745)
    # outputs
    lam = ca.vertcat(
        w634,  # hinge0.e0
        w649,  # hinge0.e1
        w659,  # hinge0.e2
        w666,  # hinge0.e3
        w674,  # hinge0.x
        w680,  # hinge0.y
        w683,  # hinge0.z
        w633,  # hinge1.e0
        w648,  # hinge1.e1
        w646,  # hinge1.e2
        w631,  # hinge1.e3
        w608,  # hinge1.x
        w602,  # hinge1.y
        w595,  # hinge1.z
        w630,  # hinge2.e0
        w629,  # hinge2.e1
        w627,  # hinge2.e2
        w624,  # hinge2.e3
        w607,  # hinge2.x
        w601,  # hinge2.y
        w594,  # hinge2.z
        w606,  # hinge3.x
        w600,  # hinge3.y
        w593,  # hinge3.z
        w592,  # hinge3.parallel_x
        lam_R0,  # hinge3.parallel_y
        w690,  # hinge4.e0
        w691,  # hinge4.e1
        w692,  # hinge4.e2
        w693,  # hinge4.e3
        -w689,  # hinge4.x
        -w688,  # hinge4.y
        -w687,  # hinge4.z
        w697,  # hinge5.e0
        w698,  # hinge5.e1
        w699,  # hinge5.e2
        w700,  # hinge5.e3
        -w696,  # hinge5.x
        -w695,  # hinge5.y
        -w694,  # hinge5.z
    )
    joint_forces = ca.horzcat(
        ca.vertcat(  # hinge0
            -w674, -w680, -w683, w634 * w701 - w649 * w702 + w659 * w703 - w666 * w704, 0.0,
            w634 * w703 + w649 * w704 - w659 * w701 - w666 * w702,
        ),
        ca.vertcat(-w608, -w602, -w595, w713, w714, w715),  # hinge1
        ca.vertcat(-w607, -w601, -w594, w724, w725, w726),  # hinge2
        ca.vertcat(  # hinge3
            -w606, -w600, -w593, -(w592 * w684 + lam_R0 * w378), -(w592 * w685 + lam_R0 * w379),
            -(w592 * w686 + lam_R0 * w380),
        ),
        ca.vertcat(w689, w688, w687, w735, w736, w737),  # hinge4
        ca.vertcat(w696, w695, w694, w746, w747, w748),  # hinge5
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
    1150 operations.
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
    gravity_y = c[24]
    bar3_mass = c[47]
    bar2_mass = c[48]
    c52 = c[52]
    bar1_mass = c[53]
    bar4_mass = c[57]
    c59 = c[59]
    bar5_mass = c[60]
    c62 = c[62]
    c65 = c[65]
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
    c104 = c[104]
    c105 = c[105]
    c106 = c[106]
    c107 = c[107]
    c108 = c[108]
    c109 = c[109]
    c110 = c[110]
    c111 = c[111]
    # intermediate terms (253)
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = 2 * bar1_e0
    w3 = (w1 * bar1_e3 - bar1_e2 * w2) * c65
    w4 = bar1_e3 * -2.0
    w5 = (bar1_e3 * w2 + bar1_e2 * w1) * c65
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
    w17 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c65
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
    w31 = bar1_x_dot * w7 + bar1_y_dot * w18 + bar1_z_dot * w26 + bar1_e0_dot * (w12 * (w12 * c67) + w0 * (w0 * c68) + w4 * (w4 * c69))
    w32 = w2 * c67
    w33 = w12 * w32 + bar1_e2 * bar1_e3 * c70
    w34 = w2 * c68
    w35 = w12 * c69
    w36 = w0 * w34 + bar1_e1 * bar1_e3 * c71
    w37 = w0 * c67
    w38 = w1 * c68
    w39 = w2 * c69
    w40 = bar1_e2 * bar1_e1 * c72 + w4 * w39
    w41 = bar1_x_dot * w16 + bar1_y_dot * w25 + bar1_z_dot * w30 + bar1_e0_dot * (w31 + bar1_e1_dot * w33 + bar1_e2_dot * w36 + bar1_e3_dot * w40)
    w42 = bar1_x_dot * w9 + bar1_y_dot * w20 + bar1_z_dot * w27 + bar1_e0_dot * w33 + bar1_e1_dot * (w2 * w32 + w4 * (w4 * c68) + w23 * (w23 * c69))
    w43 = bar1_e3 * bar1_e0 * c73 + w23 * w35
    w44 = w4 * w38 + bar1_e2 * bar1_e0 * c74
    w45 = bar1_x_dot * w11 + bar1_y_dot * w21 + bar1_z_dot * w28 + bar1_e0_dot * w36 + bar1_e1_dot * w43 + bar1_e2_dot * (w8 * (w8 * c67) + w2 * w34 + w12 * w35)
    w46 = w8 * w37 + bar1_e1 * bar1_e0 * c75
    w47 = w41 + bar1_e1_dot * (w42 + bar1_e2_dot * w43 + bar1_e3_dot * w44) + bar1_e2_dot * (w45 + bar1_e3_dot * w46)
    w48 = bar1_x_dot * w15 + bar1_y_dot * w24 + bar1_z_dot * w29 + bar1_e0_dot * w40 + bar1_e1_dot * w44 + bar1_e2_dot * w46
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = 2 * bar2_e2
    w52 = (w50 * bar2_e1 + w51 * bar2_e3) * c52
    w53 = bar2_e3 * -2.0
    w54 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c52
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
    w67 = (bar2_e2 * w60 - w50 * bar2_e3) * c52
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
    w81 = bar2_x_dot * w56 + bar2_y_dot * w68 + bar2_z_dot * w76 + bar2_e0_dot * (w62 * (w62 * c76) + w49 * (w49 * c77) + w53 * (w53 * c78))
    w82 = w50 * c76
    w83 = w62 * w82 + bar2_e2 * bar2_e3 * c79
    w84 = w50 * c77
    w85 = w62 * c78
    w86 = w49 * w84 + bar2_e1 * bar2_e3 * c80
    w87 = w49 * c76
    w88 = w60 * c77
    w89 = w50 * c78
    w90 = bar2_e2 * bar2_e1 * c81 + w53 * w89
    w91 = w75 + bar2_z_dot * w80 + bar2_e0_dot * (w81 + bar2_e1_dot * w83 + bar2_e2_dot * w86 + bar2_e3_dot * w90)
    w92 = bar2_x_dot * w58 + bar2_y_dot * w70 + bar2_z_dot * w77 + bar2_e0_dot * w83 + bar2_e1_dot * (w50 * w82 + w53 * (w53 * c77) + w51 * (w51 * c78))
    w93 = bar2_e0 * bar2_e3 * c82 + w51 * w85
    w94 = w53 * w88 + bar2_e2 * bar2_e0 * c83
    w95 = bar2_x_dot * w61 + bar2_y_dot * w71 + bar2_z_dot * w78 + bar2_e0_dot * w86 + bar2_e1_dot * w93 + bar2_e2_dot * (w57 * (w57 * c76) + w50 * w84 + w62 * w85)
    w96 = w57 * w87 + bar2_e0 * bar2_e1 * c84
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
    w131 = bar3_x_dot * w106 + bar3_y_dot * w119 + bar3_z_dot * w126 + bar3_e0_dot * (w112 * (w112 * c22) + w99 * (w99 * c85) + w101 * (w101 * c86))
    w132 = w103 * c22
    w133 = w112 * w132 + bar3_e2 * bar3_e3 * c87
    w134 = w103 * c85
    w135 = w112 * c86
    w136 = w99 * w134 + bar3_e1 * bar3_e3 * c88
    w137 = w99 * c22
    w138 = w110 * c85
    w139 = w103 * c86
    w140 = bar3_e2 * bar3_e1 * c89 + w101 * w139
    w141 = w117 + bar3_y_dot * w125 + bar3_z_dot * w130 + bar3_e0_dot * (w131 + bar3_e1_dot * w133 + bar3_e2_dot * w136 + bar3_e3_dot * w140)
    w142 = bar3_x_dot * w108 + bar3_y_dot * w121 + bar3_z_dot * w127 + bar3_e0_dot * w133 + bar3_e1_dot * (w103 * w132 + w101 * (w101 * c85) + w102 * (w102 * c86))
    w143 = bar3_e3 * bar3_e0 * c90 + w102 * w135
    w144 = w101 * w138 + bar3_e2 * bar3_e0 * c91
    w145 = bar3_x_dot * w111 + bar3_y_dot * w122 + bar3_z_dot * w128 + bar3_e0_dot * w136 + bar3_e1_dot * w143
    w146 = w107 * w137 + bar3_e1 * bar3_e0 * c92
    w147 = bar3_e2_dot * (w145 + bar3_e2_dot * (w107 * (w107 * c22) + w103 * w134 + w112 * w135) + bar3_e3_dot * w146)
    w148 = bar3_x_dot * w115 + bar3_y_dot * w124 + bar3_z_dot * w129 + bar3_e0_dot * w140 + bar3_e1_dot * w144
    w149 = bar3_e3_dot * (w148 + bar3_e2_dot * w146 + bar3_e3_dot * (w99 * w137 + w110 * w138 + w103 * w139))
    w150 = bar4_e2 * -2.0
    w151 = 2 * bar4_e1
    w152 = 2 * bar4_e0
    w153 = (w151 * bar4_e3 - bar4_e2 * w152) * c59
    w154 = bar4_e3 * -2.0
    w155 = (bar4_e3 * w152 + bar4_e2 * w151) * c59
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
    w168 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * c59
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
    w182 = bar4_x_dot * w157 + bar4_y_dot * w169 + bar4_z_dot * w177 + bar4_e0_dot * (w162 * (w162 * c93) + w150 * (w150 * c94) + w154 * (w154 * c95))
    w183 = w152 * c93
    w184 = w162 * w183 + bar4_e2 * bar4_e3 * c96
    w185 = w152 * c94
    w186 = w162 * c95
    w187 = w150 * w185 + bar4_e1 * bar4_e3 * c97
    w188 = w150 * c93
    w189 = w151 * c94
    w190 = w152 * c95
    w191 = bar4_e2 * bar4_e1 * c98 + w154 * w190
    w192 = w167 + bar4_y_dot * w176 + bar4_z_dot * w181 + bar4_e0_dot * (w182 + bar4_e1_dot * w184 + bar4_e2_dot * w187 + bar4_e3_dot * w191)
    w193 = bar4_x_dot * w159 + bar4_y_dot * w171 + bar4_z_dot * w178 + bar4_e0_dot * w184 + bar4_e1_dot * (w152 * w183 + w154 * (w154 * c94) + w174 * (w174 * c95))
    w194 = bar4_e3 * bar4_e0 * c99 + w174 * w186
    w195 = w154 * w189 + bar4_e2 * bar4_e0 * c100
    w196 = bar4_x_dot * w161 + bar4_y_dot * w172 + bar4_z_dot * w179 + bar4_e0_dot * w187 + bar4_e1_dot * w194
    w197 = w158 * w188 + bar4_e1 * bar4_e0 * c101
    w198 = bar4_e2_dot * (w196 + bar4_e2_dot * (w158 * (w158 * c93) + w152 * w185 + w162 * w186) + bar4_e3_dot * w197)
    w199 = bar4_x_dot * w165 + bar4_y_dot * w175 + bar4_z_dot * w180 + bar4_e0_dot * w191 + bar4_e1_dot * w195
    w200 = bar4_e3_dot * (w199 + bar4_e2_dot * w197 + bar4_e3_dot * (w150 * w188 + w151 * w189 + w152 * w190))
    w201 = bar5_e2 * -2.0
    w202 = 2 * bar5_e0
    w203 = 2 * bar5_e2
    w204 = (w202 * bar5_e1 + w203 * bar5_e3) * c62
    w205 = bar5_e3 * -2.0
    w206 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c62
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
    w220 = (bar5_e2 * w212 - w202 * bar5_e3) * c62
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
    w233 = bar5_x_dot * w208 + bar5_y_dot * w221 + bar5_z_dot * w228 + bar5_e0_dot * (w214 * (w214 * c102) + w201 * (w201 * c104) + w205 * (w205 * c105))
    w234 = w202 * c102
    w235 = w214 * w234 + bar5_e2 * bar5_e3 * c106
    w236 = w202 * c104
    w237 = w214 * c105
    w238 = w201 * w236 + bar5_e1 * bar5_e3 * c107
    w239 = w201 * c102
    w240 = w212 * c104
    w241 = w202 * c105
    w242 = bar5_e2 * bar5_e1 * c108 + w205 * w241
    w243 = w219 + bar5_y_dot * w227 + bar5_z_dot * w232 + bar5_e0_dot * (w233 + bar5_e1_dot * w235 + bar5_e2_dot * w238 + bar5_e3_dot * w242)
    w244 = bar5_x_dot * w210 + bar5_y_dot * w223 + bar5_z_dot * w229 + bar5_e0_dot * w235 + bar5_e1_dot * (w202 * w234 + w205 * (w205 * c104) + w203 * (w203 * c105))
    w245 = bar5_e0 * bar5_e3 * c109 + w203 * w237
    w246 = w205 * w240 + bar5_e2 * bar5_e0 * c110
    w247 = bar5_x_dot * w213 + bar5_y_dot * w224 + bar5_z_dot * w230 + bar5_e0_dot * w238 + bar5_e1_dot * w245
    w248 = w209 * w239 + bar5_e0 * bar5_e1 * c111
    w249 = bar5_e2_dot * (w247 + bar5_e2_dot * (w209 * (w209 * c102) + w202 * w236 + w214 * w237) + bar5_e3_dot * w248)
    w250 = bar5_x_dot * w217 + bar5_y_dot * w226 + bar5_z_dot * w231 + bar5_e0_dot * w242 + bar5_e1_dot * w246
    w251 = bar5_e3_dot * (w250 + bar5_e2_dot * w248 + bar5_e3_dot * (w201 * w239 + w212 * w240 + w202 * w241))
    w252 = (w5 + bar1_y * bar1_mass) * gravity_y + (w54 + bar2_y * bar2_mass) * gravity_y + (w104 + bar3_y * bar3_mass) * gravity_y
    # outputs
    kinetic = ca.vertcat((w243 + bar5_e1_dot * (w244 + bar5_e2_dot * w245 + bar5_e3_dot * w246) + w249 + w251) / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(-(w252 + (w155 + bar4_y * bar4_mass) * gravity_y + (w206 + bar5_y * bar5_mass) * gravity_y))
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
    71 operations.
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
    bar3_end_z = c[13]
    # intermediate terms (6)
    w0 = 2 * bar3_e0
    w1 = 2 * bar3_e1
    w2 = 2 * bar3_e0_dot
    w3 = (bar3_e2 * w2 + w0 * bar3_e2_dot + (bar3_e3 * (2 * bar3_e1_dot) + w1 * bar3_e3_dot)) * bar3_end_z
    w4 = 2 * bar3_e2
    w5 = (bar3_e3 * (2 * bar3_e2_dot) + bar3_e3_dot * w4 - (bar3_e1 * w2 + w0 * bar3_e1_dot)) * bar3_end_z
    # outputs
    measures = ca.vertcat(
        bar3_x + (w0 * bar3_e2 + w1 * bar3_e3) * bar3_end_z,  # P3_x
        bar3_x_dot + w3,  # P3_x_dot
        bar3_y + (bar3_e3 * w4 - w0 * bar3_e1) * bar3_end_z,  # P3_y
        bar3_y_dot + w5,  # P3_y_dot
        bar3_z + (1.0 - 2 * bar3_e1**2 - 2 * bar3_e2**2) * bar3_end_z,  # P3_z
        bar3_z_dot - (2 * (w1 * bar3_e1_dot) + 2 * (bar3_e2_dot * w4)) * bar3_end_z,  # P3_z_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 40) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 5) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    226 operations.
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
    3858 operations.
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
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    gravity_y = c[24]
    c25 = c[25]
    c118 = c[118]
    c119 = c[119]
    c120 = c[120]
    c121 = c[121]
    c122 = c[122]
    c123 = c[123]
    # intermediate terms (831)
    w0 = ca.cos(hinge1_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.cos(hinge2_angle)
    w3 = ca.cos(hinge0_angle)
    w4 = w0 * bar2_end_y
    w5 = w0 * w1
    w6 = w5 * bar3_end_z
    w7 = w4 - w6
    w8 = w3 * w7
    w9 = ca.sin(hinge1_angle)
    w10 = w3 * w9
    w11 = ca.sin(hinge0_angle)
    w12 = (w1 * w10 + w2 * w11) * bar3_end_z
    w13 = w10 * bar2_end_y
    w14 = w12 - w13
    w15 = w9 * w11
    w16 = w15 * bar2_end_y
    w17 = (w2 * w3 - w1 * w15) * bar3_end_z
    w18 = w16 + w17
    w19 = w3 * w14 - w11 * w18
    w20 = w7 * w11
    w21 = w0 * w11
    w22 = ca.cos(hinge4_angle)
    w23 = ca.cos(hinge5_angle)
    w24 = w22 * w23
    w25 = w21 * w24
    w26 = ca.sin(hinge5_angle)
    w27 = w22 * w26
    w28 = w9 * w27
    w29 = w25 - w28
    w30 = w0 * w3
    w31 = w24 * w30
    w32 = ca.sin(hinge4_angle)
    w33 = w9 * w32
    w34 = w31 - w33
    w35 = w11 * w29 + w3 * w34
    w36 = ca.sqrt(w19**2 + w7**2 + w35**2)
    w37 = w8 / w36
    w38 = w3 * hinge1_angle_dot
    w39 = hinge0_angle_dot * w38
    w40 = w11 * bar1_end_x
    w41 = w4 * w39 + hinge0_angle_dot * (hinge0_angle_dot * w40)
    w42 = w4 * w38
    w43 = w16 * hinge0_angle_dot
    w44 = w42 - w43
    w45 = w11 * hinge1_angle_dot
    w46 = w9 * hinge1_angle_dot * bar2_end_y
    w47 = w45 * w46
    w48 = w21 * hinge2_angle_dot
    w49 = w30 * hinge2_angle_dot
    w50 = hinge2_angle_dot * (w0 * hinge1_angle_dot)
    w51 = w12 * w50
    w52 = w9 * hinge2_angle_dot
    w53 = w38 * w52 + hinge0_angle_dot * w48
    w54 = w53 - w39
    w55 = hinge0_angle_dot + w52
    w56 = w38 - w48
    w57 = w6 * w56 + w17 * w55
    w58 = w55 * w57
    w59 = w45 + w49
    w60 = w12 * w56 - w17 * w59
    w61 = w59 * w60
    w62 = w41 + (hinge0_angle_dot * w44 - w47) + (w6 * w54 - w51) - (w58 - w61)
    w63 = hinge0_angle_dot * w45
    w64 = w4 * w63
    w65 = w3 * bar1_end_x
    w66 = hinge0_angle_dot * (hinge0_angle_dot * w65)
    w67 = w4 * w45 + w13 * hinge0_angle_dot
    w68 = hinge0_angle_dot * w67 + w38 * w46
    w69 = w17 * w50
    w70 = w45 * w52
    w71 = hinge0_angle_dot * w49
    w72 = w70 - w71 - w63
    w73 = w6 * w59 + w12 * w55
    w74 = w55 * w73 + w56 * w60
    w75 = w23 * hinge4_angle_dot
    w76 = hinge5_angle_dot * w75
    w77 = w26 * w32
    w78 = w77 * bar4_end_x
    w79 = w26 * hinge4_angle_dot
    w80 = hinge5_angle_dot * w79
    w81 = w23 * w32
    w82 = w81 * bar4_end_x
    w83 = w22 * bar4_end_x
    w84 = hinge5_angle_dot * w82 + w79 * w83
    w85 = w75 * w83 - hinge5_angle_dot * w78
    w86 = w64 - w66 + w68 + (w69 + w6 * w72) - w74 - (w76 * w78 - w80 * w82 + (w79 * w84 + w75 * w85))
    w87 = w20 / w36
    w88 = w37 / w36
    w89 = 2 * w19
    w90 = w3 * w18
    w91 = w13 - w12
    w92 = w90 - w11 * w14 - (w90 + w11 * w91)
    w93 = 2 * w8
    w94 = 2 * w20
    w95 = 2 * w35
    w96 = w11 * w31 + w3 * w29 - (w3 * w25 + w11 * w34)
    w97 = 2 * w36
    w98 = (w89 * w92 - w20 * w93 + w8 * w94 + w95 * w96) / w97
    w99 = w87 + w88 * w98
    w100 = w43 - w42
    w101 = w39 - w53
    w102 = w13 * w63 - w16 * w39 + (w38 * w100 - w45 * w67) + (w12 * w72 - w17 * w101) + (w56 * w57 + w59 * w73)
    w103 = w23 * bar5_end_y
    w104 = hinge5_angle_dot * w103
    w105 = w32 * hinge4_angle_dot * bar4_end_x
    w106 = w102 - (hinge5_angle_dot * w104 - w80 * w83 - (w75 * w105 + hinge5_angle_dot * w84))
    w107 = w19 / w36
    w108 = w107 / w36
    w109 = w92 / w36 - w98 * w108
    w110 = w38 * w67
    w111 = w63 + (w71 - w70)
    w112 = w110 - w45 * w100 - (w110 + w44 * w45) + (w12 * w54 + w17 * w72 + (w17 * w111 + w12 * w101))
    w113 = w26 * bar5_end_y
    w114 = w41 - (w47 + hinge0_angle_dot * w100) - (w51 + w6 * w101) + (w61 - w58) - (w79 * w105 - hinge5_angle_dot * w85 - (hinge5_angle_dot * (hinge5_angle_dot * w113) + w76 * w83))
    w115 = w87 / w36
    w116 = w37 - w98 * w115
    w117 = w74 + (w66 - w64 - w68 - (w69 - w6 * w111))
    w118 = w21 * w32
    w119 = w27 * w30
    w120 = w118 - w119
    w121 = w32 * w79 - w24 * hinge5_angle_dot
    w122 = w22 * hinge4_angle_dot
    w123 = hinge5_angle_dot * w121 - w75 * w122
    w124 = w32 * w75 + w27 * hinge5_angle_dot
    w125 = w79 * w121 + w75 * w124
    w126 = hinge5_angle_dot * w124 + w79 * w122
    w127 = w9 * w59
    w128 = w30 * w55
    w129 = w127 - w128
    w130 = w30 * w56 + w21 * w59
    w131 = w56 * w130
    w132 = w55 * w129 - w131
    w133 = w21 * w55 + w9 * w56
    w134 = w56 * w133 + w59 * w129
    w135 = w59 * w130 + w55 * w133
    w136 = 2 * -w133
    w137 = 2 * w130
    w138 = w9 * w123 - w30 * w125 - w21 * w126 + w32 * w132 - w24 * w134 - w27 * w135 + w122 * w136 - w124 * w137
    w139 = 2 * w129
    w140 = w119 - w118
    w141 = w33 - w31
    w142 = w76 * w120 - (w138 + w121 * w139 + w29 * w101 + w50 * w140 + w34 * w72) - w80 * w141
    w143 = w35 / w36
    w144 = w143 / w36
    w145 = w96 / w36 - w98 * w144
    w146 = w21 * w27
    w147 = w30 * w32 + w146
    w148 = w128 - w127
    w149 = w59 * w133
    w150 = w21 * w125 - w30 * w126 + w32 * w135 - w24 * (w56 * w148 - w149 + (w149 + w56 * w129)) - w27 * (w131 + w55 * w148)
    w151 = w150 + w122 * (2 * -w148) - w124 * c119 + w121 * (2 * w133) + (w31 * w101 - w29 * w111) - w50 * w147
    w152 = w76 * w147 - (w151 + (w34 * w54 - w25 * w72)) - w25 * w80
    w153 = w37 * w62 - w86 * w99 - (w106 * w109 + w107 * w112) - (w114 * w116 + w87 * w117) + (w142 * w145 + w143 * w152)
    w154 = w82 - w103
    w155 = w113 - w78
    w156 = w28 - w25
    w157 = w87 * w154 - w107 * w155 - w143 * w156
    w158 = w37 * w157
    w159 = w9 * w17 - w6 * w21
    w160 = w29 * w30 + w9 * w140 - w21 * w34
    w161 = w12 * w21 + w17 * w30
    w162 = w6 * w30 + w9 * w12
    w163 = w143 * w160 - (w37 * w159 + w107 * w161 + w87 * w162)
    w164 = w159 + w37 * w163
    w165 = w161 + w107 * w163
    w166 = w162 + w87 * w163
    w167 = w160 - w143 * w163
    w168 = ca.sqrt(w164**2 + w165**2 + w166**2 + w167**2)
    w169 = w164 / w168
    w170 = w155 + w107 * w157
    w171 = w165 / w168
    w172 = w87 * w157 - w154
    w173 = w166 / w168
    w174 = w156 + w143 * w157
    w175 = w167 / w168
    w176 = w158 * w169 + w170 * w171 + w172 * w173 - w174 * w175
    w177 = w169 * w176 - w158
    w178 = w32 * bar4_end_x
    w179 = w23 * w83
    w180 = w26 * w83
    w181 = w26 * w120 + w23 * w141
    w182 = w37 * w178 - w107 * w179 + w87 * w180 - w143 * w181
    w183 = w178 - w37 * w182
    w184 = w179 + w107 * w182
    w185 = w87 * w182 - w180
    w186 = w181 + w143 * w182
    w187 = w171 * w184 - w169 * w183 + w173 * w185 - w175 * w186
    w188 = w183 + w169 * w187
    w189 = w184 - w171 * w187
    w190 = w185 - w173 * w187
    w191 = w186 + w175 * w187
    w192 = ca.sqrt(w188**2 + w189**2 + w190**2 + w191**2)
    w193 = w188 / w192
    w194 = w170 - w171 * w176
    w195 = w189 / w192
    w196 = w172 - w173 * w176
    w197 = w190 / w192
    w198 = w174 + w175 * w176
    w199 = w191 / w192
    w200 = w177 * w193 + w194 * w195 + w196 * w197 + w198 * w199
    w201 = w177 - w193 * w200
    w202 = w194 - w195 * w200
    w203 = w196 - w197 * w200
    w204 = w199 * w200 - w198
    w205 = ca.sqrt(w201**2 + w202**2 + w203**2 + w204**2)
    w206 = w201 / w205
    w207 = w202 / w205
    w208 = w203 / w205
    w209 = w204 / w205
    w210 = (w86 * w206 + w106 * w207 + w114 * w208 + w142 * w209) / w205
    w211 = w31 * w143
    w212 = w116 * w154 - w109 * w155 - (w145 * w156 - w211)
    w213 = w37 * w212 - w99 * w157
    w214 = w30 * w31 - w21 * w29 - w9 * w147 - (w30 * w34 - w21 * w25)
    w215 = w143 * w214 + w145 * w160 - (w109 * w161 - (w37 * w162 + w99 * w159) + (w87 * w159 + w116 * w162))
    w216 = w37 * w215 - w99 * w163 - w162
    w217 = w169 / w168
    w218 = 2 * w164
    w219 = 2 * w165
    w220 = w107 * w215 + w109 * w163
    w221 = 2 * w166
    w222 = w159 + (w87 * w215 + w116 * w163)
    w223 = 2 * w167
    w224 = w214 - (w143 * w215 + w145 * w163)
    w225 = 2 * w168
    w226 = (w216 * w218 + w219 * w220 + w221 * w222 + w223 * w224) / w225
    w227 = w216 / w168 - w217 * w226
    w228 = w107 * w212 + w109 * w157
    w229 = w171 / w168
    w230 = w220 / w168 - w226 * w229
    w231 = w87 * w212 + w116 * w157
    w232 = w173 / w168
    w233 = w222 / w168 - w226 * w232
    w234 = w143 * w212 + w145 * w157 - w31
    w235 = w175 / w168
    w236 = w224 / w168 - w226 * w235
    w237 = w169 * w213 + w158 * w227 + (w171 * w228 + w170 * w230) + (w173 * w231 + w172 * w233) - (w175 * w234 + w174 * w236)
    w238 = w169 * w237 + w176 * w227 - w213
    w239 = w26 * w147 + w23 * w25
    w240 = w116 * w180 - (w99 * w178 + w109 * w179) - (w143 * w239 + w145 * w181)
    w241 = w107 * w240 + w109 * w182
    w242 = w37 * w240 - w99 * w182
    w243 = w87 * w240 + w116 * w182
    w244 = w239 + (w143 * w240 + w145 * w182)
    w245 = w171 * w241 + w184 * w230 - (w183 * w227 - w169 * w242) + (w173 * w243 + w185 * w233) - (w175 * w244 + w186 * w236)
    w246 = w169 * w245 + w187 * w227 - w242
    w247 = w193 / w192
    w248 = 2 * w188
    w249 = 2 * w189
    w250 = w241 - (w171 * w245 + w187 * w230)
    w251 = 2 * w190
    w252 = w243 - (w173 * w245 + w187 * w233)
    w253 = 2 * w191
    w254 = w244 + (w175 * w245 + w187 * w236)
    w255 = 2 * w192
    w256 = (w246 * w248 + w249 * w250 + w251 * w252 + w253 * w254) / w255
    w257 = w246 / w192 - w247 * w256
    w258 = w228 - (w171 * w237 + w176 * w230)
    w259 = w195 / w192
    w260 = w250 / w192 - w256 * w259
    w261 = w231 - (w173 * w237 + w176 * w233)
    w262 = w197 / w192
    w263 = w252 / w192 - w256 * w262
    w264 = w234 + (w175 * w237 + w176 * w236)
    w265 = w199 / w192
    w266 = w254 / w192 - w256 * w265
    w267 = w193 * w238 + w177 * w257 + (w195 * w258 + w194 * w260) + (w197 * w261 + w196 * w263) + (w199 * w264 + w198 * w266)
    w268 = w238 - (w193 * w267 + w200 * w257)
    w269 = w206 / w205
    w270 = 2 * w201
    w271 = 2 * w202
    w272 = w258 - (w195 * w267 + w200 * w260)
    w273 = 2 * w203
    w274 = w261 - (w197 * w267 + w200 * w263)
    w275 = 2 * w204
    w276 = w199 * w267 + w200 * w266 - w264
    w277 = 2 * w205
    w278 = (w268 * w270 + w271 * w272 + w273 * w274 + w275 * w276) / w277
    w279 = w268 / w205 - w269 * w278
    w280 = w207 / w205
    w281 = w208 / w205
    w282 = w274 / w205 - w278 * w281
    w283 = w86 * w279 + w62 * w206 + (w106 * (w272 / w205 - w278 * w280) + w112 * w207) + (w114 * w282 + w117 * w208)
    w284 = w209 / w205
    w285 = w276 / w205 - w278 * w284
    w286 = w210 / w205
    w287 = (w283 + (w142 * w285 + w152 * w209)) / w205 - w278 * w286
    w288 = (w86 * w193 + w106 * w195 + w114 * w197 - w142 * w199 - w200 * w210) / w192
    w289 = w86 * w257 + w62 * w193 + (w106 * w260 + w112 * w195) + (w114 * w263 + w117 * w197) - (w142 * w266 + w152 * w199)
    w290 = w288 / w192
    w291 = (w289 - (w210 * w267 + w200 * w287)) / w192 - w256 * w290
    w292 = (w106 * w171 - w86 * w169 + w114 * w173 + w142 * w175 - w176 * w210 - w187 * w288) / w168
    w293 = w106 * w230 + w112 * w171 - (w86 * w227 + w62 * w169) + (w114 * w233 + w117 * w173) + (w142 * w236 + w152 * w175)
    w294 = w292 / w168
    w295 = (w293 - (w210 * w237 + w176 * w287) - (w245 * w288 + w187 * w291)) / w168 - w226 * w294
    w296 = (w153 - (w210 * w212 + w157 * w287) - (w240 * w288 + w182 * w291) - (w215 * w292 + w163 * w295)) / w36
    w297 = (w37 * w86 - w106 * w107 - w87 * w114 + w142 * w143 - w157 * w210 - w182 * w288 - w163 * w292) / w36
    w298 = w297 / w36
    w299 = w296 - w98 * w298
    w300 = w2 * w299 * c1
    w301 = w1 * w299
    w302 = w299 * c23 - w301 * c0
    w303 = w1 * (w295 * c4)
    w304 = w295 * c22
    w305 = w32 * hinge5_angle_dot
    w306 = hinge4_angle_dot * w305
    w307 = (w306 + (w306 - w22 * w210)) * c16
    w308 = w26 * gravity_y
    w309 = w22 * hinge5_angle_dot
    w310 = hinge4_angle_dot * w309
    w311 = w310 + (w310 + w32 * w210)
    w312 = (w308 - w210 * bar5_end_y) * c14 - w311 * c15
    w313 = w22 * w307 + w32 * w312 - w311 * c18 + (w308 * c25 - w210 * c20)
    w314 = w18 - w40
    w315 = w91 - w65
    w316 = w14 + w65
    w317 = (w206 * w314 - w208 * w316 - w140 * w209) / w205
    w318 = w317 / w205
    w319 = (w279 * w314 + w206 * w315 - (w282 * w316 + w208 * w314) - (w140 * w285 - w147 * w209)) / w205 - w278 * w318
    w320 = w32 * w287
    w321 = w313 * w319 - w317 * (w22 * (w22 * w287 * c16) + w32 * (w287 * c18 + w320 * c15) + w320 * c18 + w287 * c20)
    w322 = w305 * w309
    w323 = w23 * gravity_y - hinge5_angle_dot**2 * bar5_end_y
    w324 = (w322 - w288) * c15 - (w288 + w322) * c16 - w22 * w323 * c14
    w325 = w257 * w314 + w193 * w315 - (w263 * w316 + w197 * w314) + (w140 * w266 - w147 * w199) - (w267 * w317 + w200 * w319)
    w326 = (w193 * w314 - w197 * w316 + w140 * w199 - w200 * w317) / w192
    w327 = w326 / w192
    w328 = w325 / w192 - w256 * w327
    w329 = w0 * (w1 * w300 + w2 * w302) + w9 * (w303 * bar2_end_y - w304) - w303 * bar1_end_x + w321 + (w324 * w328 - w326 * (w291 * c21))
    w330 = (w169 * w314 + w173 * w316 + w140 * w175 + w176 * w317 + w187 * w326) / w168
    w331 = w0 * hinge0_angle_dot
    w332 = hinge1_angle_dot * w331
    w333 = w292 + w332
    w334 = w2 * hinge1_angle_dot - w1 * w331
    w335 = w2 * w331 + w1 * hinge1_angle_dot
    w336 = w334 * w335
    w337 = w333 - w336
    w338 = hinge0_angle_dot**2 * bar1_end_x
    w339 = w9 * hinge0_angle_dot
    w340 = w9 * w338 - w0 * gravity_y - (w339**2 + hinge1_angle_dot**2) * bar2_end_y
    w341 = 2 * w332
    w342 = w341 * bar2_end_y
    w343 = w337 * c0 + (w333 + w336) * c1 - (w2 * w340 + w1 * w342) * c4
    w344 = w227 * w314 + w169 * w315 + (w233 * w316 + w173 * w314) + (w140 * w236 - w147 * w175) + (w237 * w317 + w176 * w319)
    w345 = w330 / w168
    w346 = (w344 + (w245 * w326 + w187 * w328)) / w168 - w226 * w345
    w347 = (w37 * w314 + w87 * w316 - w140 * w143 - w157 * w317 - w182 * w326 + w163 * w330) / w36
    w348 = hinge1_angle_dot * w339
    w349 = hinge2_angle_dot + w339
    w350 = (w1 * w348 + w2 * w297 - hinge2_angle_dot * w335 - w335 * w349) * c1
    w351 = w0 * w338 + w9 * gravity_y
    w352 = w331 * w339
    w353 = w297 - w352
    w354 = w334 * w349 - (w2 * w348 - w1 * w297 - hinge2_angle_dot * w334)
    w355 = (w351 + w353 * bar2_end_y) * c4 - w354 * c0
    w356 = w2 * w350 - w1 * w355 - w354 * c23 + (w351 * c8 + (w353 * c5 + (w297 + w352) * c6))
    w357 = w37 * w315 - w99 * w314 + (w116 * w316 + w87 * w314) - (w140 * w145 - w143 * w147) - (w212 * w317 + w157 * w319)
    w358 = w347 / w36
    w359 = (w357 - (w240 * w326 + w182 * w328) + (w215 * w330 + w163 * w346)) / w36 - w98 * w358
    w360 = w329 + (w304 * w330 + w343 * w346) - (w347 * (w2 * w300 - w1 * w302 - w301 * c23 + w299 * c120) + w356 * w359)
    w361 = (w335**2 + w349**2) * c4
    w362 = w337 * c4
    w363 = w330 - w9
    w364 = w363 * c4
    w365 = w2 * w364
    w366 = w0 * w2
    w367 = w1 * w347 + w366
    w368 = w367 * c4
    w369 = w368 - w347 * c8
    w370 = w356 / w36
    w371 = w343 - w163 * w370
    w372 = w371 / w168
    w373 = w363 * c1
    w374 = w9 * bar2_end_y
    w375 = w374 - bar1_end_x
    w376 = w363 * c0 + w1 * w375 * c4
    w377 = w373 + w376
    w378 = w347 * c23 - w367 * c0
    w379 = w347 * c6
    w380 = w368 * bar2_end_y - w347 * c5
    w381 = (w5 - w2 * w347) * c1
    w382 = w1 * w378 - w379 + w380 + w2 * w381
    w383 = w382 / w36
    w384 = w377 - w163 * w383
    w385 = w384 / w168
    w386 = w326 * c16
    w387 = w326 * c15
    w388 = w386 + w387 + w187 * w385 + w182 * w383
    w389 = w388 / w192
    w390 = w32 * w317
    w391 = w317 * c18 + w390 * c15
    w392 = w390 * c14
    w393 = w22 * w317 * c16
    w394 = w200 * w389 - (w317 * c20 + w32 * w391 + w392 * bar5_end_y + w22 * w393 + w176 * w385) - w157 * w383
    w395 = w394 / w205
    w396 = w324 + (w182 * w370 + w187 * w372)
    w397 = w396 / w192
    w398 = w313 + (w157 * w370 + w176 * w372 - w200 * w397)
    w399 = w398 / w205
    w400 = w114 * w395 - w316 * w399
    w401 = w142 * w395 - w140 * w399
    w402 = w106 * w395
    w403 = w314 * w399 + w86 * w395
    w404 = (w318 * w398 + w286 * w394 + w284 * w401 + w281 * w400 + w280 * w402 + w269 * w403) / w277
    w405 = w400 / w205 - w273 * w404
    w406 = w401 / w205 - w275 * w404
    w407 = w402 / w205 - w271 * w404
    w408 = w403 / w205 - w270 * w404
    w409 = w210 * w389 - w317 * w397 + w199 * w406 - w197 * w405 - w195 * w407 - w193 * w408
    w410 = w405 + w197 * w409
    w411 = w196 * w409 - (w316 * w397 + w114 * w389 + w200 * w405)
    w412 = w140 * w397 + w142 * w389 + w200 * w406 + w198 * w409
    w413 = w194 * w409 - (w106 * w389 + w200 * w407)
    w414 = w314 * w397 - w86 * w389 - w200 * w408 + w177 * w409
    w415 = (w290 * w388 - w327 * w396 - w265 * w412 - w262 * w411 - w259 * w413 - w247 * w414) / w255
    w416 = w411 / w192 + w251 * w415
    w417 = w412 / w192 + w253 * w415
    w418 = w413 / w192 + w249 * w415
    w419 = w414 / w192 + w248 * w415
    w420 = w326 * w372 - w288 * w385 + w175 * w417 - w173 * w416 - w171 * w418 + w169 * w419
    w421 = w199 * w409 - w406
    w422 = w407 + w195 * w409
    w423 = w408 + w193 * w409
    w424 = w317 * w372 - w210 * w385 + w175 * w421 - w173 * w410 - w171 * w422 + w169 * w423
    w425 = w316 * w372 + w114 * w385 - w176 * w410 - w187 * w416 + w185 * w420 + w172 * w424
    w426 = w140 * w372 + w142 * w385 + w176 * w421 + w187 * w417 - w186 * w420 - w174 * w424
    w427 = w106 * w385 - w176 * w422 - w187 * w418 + w184 * w420 + w170 * w424
    w428 = w314 * w372 - w86 * w385 + w187 * w419 - w183 * w420 + w176 * w423 + w158 * w424
    w429 = (w345 * w371 + w294 * w384 + w235 * w426 + w232 * w425 + w229 * w427 + w217 * w428) / w225
    w430 = w425 / w168 - w221 * w429
    w431 = w426 / w168 - w223 * w429
    w432 = w427 / w168 - w219 * w429
    w433 = w428 / w168 - w218 * w429
    w434 = w87 * w430 - (w330 * w370 + w292 * w383 + w143 * w431) + w107 * w432 + w37 * w433
    w435 = w430 - w87 * w434
    w436 = (w2 * w361 + w1 * w362) * bar2_end_y - w343 - w341 * c5 - w338 * w365 + w369 * gravity_y + w12 * w435
    w437 = w431 + w143 * w434
    w438 = w433 - w37 * w434
    w439 = w175 * w385 + w199 * w389 + w209 * w395 + w143 * w383
    w440 = w27 * w439
    w441 = w24 * w439
    w442 = w55 * w440 - 2 * -(w122 * w439) + w56 * w441
    w443 = w32 * w439
    w444 = 2 * -(w121 * w439) + w59 * w441 - w55 * w443
    w445 = w173 * w385 - w197 * w389 + w208 * w395 - w87 * w383
    w446 = w171 * w385 - w195 * w389 + w207 * w395 - w107 * w383
    w447 = w29 * w439 + w6 * w445 + w17 * w446
    w448 = w56 * w446 - w55 * w445
    w449 = w206 * w395 - (w169 * w385 + w193 * w389) + w37 * w383
    w450 = w59 * w446 - w55 * w449
    w451 = w133 * w440 + w21 * w442 - w129 * w443 - w30 * w444 - w57 * w445 + w17 * w448 - w73 * w449 + w12 * w450
    w452 = w12 * w446 - w34 * w439 + w6 * w449
    w453 = w38 * w447 + w451 + w45 * w452
    w454 = w436 + w140 * w437 + w17 * w438 + w56 * w442 + w59 * w444 - w123 * w439 + hinge2_angle_dot * w453
    w455 = w417 - w175 * w420
    w456 = w416 + w173 * w420
    w457 = w418 + w171 * w420
    w458 = w419 - w169 * w420
    w459 = w326 * w370 - w288 * w383 + w143 * w455 + w87 * w456 + w107 * w457 - w37 * w458
    w460 = w455 - w143 * w459
    w461 = w23 * w460 - w80 * w439
    w462 = w421 - w175 * w424
    w463 = w410 + w173 * w424
    w464 = w422 + w171 * w424
    w465 = w169 * w424 - w423
    w466 = w317 * w370 - w210 * w383 + w143 * w462 + w87 * w463 + w107 * w464 + w37 * w465
    w467 = w140 * w370 + w182 * w455 - w181 * w459 + w157 * w462 - w163 * w431 + w160 * w434 - w156 * w466 + w142 * w383
    w468 = w182 * w456 - w316 * w370 + w180 * w459 + w157 * w463 + w163 * w430 - w162 * w434 + w154 * w466 - w114 * w383
    w469 = w182 * w457 - w179 * w459 + w157 * w464 + w163 * w432 - w161 * w434 - w155 * w466 - w106 * w383
    w470 = w178 * w459 - (w314 * w370 + w182 * w458) + w163 * w433 - w159 * w434 + w157 * w465 + w86 * w383
    w471 = (w356 * w358 - w298 * w382 - w144 * w467 - w115 * w468 - w108 * w469 - w88 * w470) / w97
    w472 = w467 / w36 + w95 * w471
    w473 = w3 * w472 - (w21 * w437 + w72 * w439)
    w474 = w461 - w473
    w475 = w462 - w143 * w466
    w476 = w30 * w437 - w101 * w439 + w11 * w472
    w477 = w475 - w476
    w478 = w38 * w446 - hinge0_angle_dot * w445
    w479 = w38 * w449 - w45 * w445
    w480 = w469 / w36 + w89 * w471
    w481 = w169 * w372 - w37 * w370 + w193 * w397 + w206 * w399 - w11 * w480
    w482 = w432 - w107 * w434
    w483 = w59 * w445 - w56 * w449
    w484 = (w481 + (w30 * w482 + w9 * w438 + w55 * w448 - w101 * w446 - w59 * w483 + w50 * w449)) * bar3_end_z
    w485 = w454 + w32 * w474 + w27 * w477 + w11 * ((hinge0_angle_dot * w478 - w39 * w446 + w45 * w479 + w481) * bar2_end_y - w1 * w484)
    w486 = hinge0_angle_dot * w449 - w45 * w446
    w487 = w173 * w372 - w87 * w370 - w197 * w397 - w208 * w399 + w3 * w480
    w488 = (w487 + (w9 * w435 + w21 * w482 - w50 * w445 + w72 * w446 + w56 * w483 + w55 * w450)) * bar3_end_z
    w489 = w485 + w3 * ((w63 * w446 + w38 * w479 + hinge0_angle_dot * w486 - w487) * bar2_end_y + w1 * w488)
    w490 = w365 * bar2_end_y
    w491 = w0 * c118
    w492 = w379 + w380
    w493 = w2 * w375 * c4
    w494 = w334 * w378
    w495 = w335 * w381
    w496 = 2 * w349 * w493 + w494 - w495
    w497 = w1 * w381 - w2 * w378
    w498 = hinge0_angle_dot * (2 * w339 * w490 + hinge1_angle_dot * w491 - w331 * w492 + w496 + hinge1_angle_dot * w497)
    w499 = 2 * (c121 - w9 * c5 - w1 * w364 * bar2_end_y)
    w500 = w373 - w376
    w501 = w335 * w500 + hinge2_angle_dot * w378 + w349 * w378
    w502 = w334 * w500 + w493 * (2 * w335) - w349 * w381 - hinge2_angle_dot * w381
    w503 = hinge0_angle_dot * (hinge1_angle_dot * w499 + hinge1_angle_dot * w377 - w1 * w501 - w339 * w492 + w2 * w502)
    w504 = 2 * (w124 * w439) + w59 * w440 + w56 * w443
    w505 = w143 * w370 + w175 * w372 + w199 * w397 - w209 * w399 + w9 * w437 - w50 * w439
    w506 = w26 * w460 + w76 * w439
    w507 = w505 - w506
    w508 = w130 * w440 + w129 * w441 + w21 * w504 + w9 * w444 + w60 * w445 + w73 * w446 - w17 * w483 + w6 * w450
    w509 = w17 * w449 - (w140 * w439 + w12 * w445)
    w510 = w508 - hinge0_angle_dot * w452 + w38 * w509
    w511 = w6 * w435 + w17 * w482 + w29 * w437 + w56 * w504 - w55 * w444 + w125 * w439 + w27 * w507 + hinge2_angle_dot * w510
    w512 = w473 - w461
    w513 = w365 * gravity_y + (w1 * w350 + w2 * w355 + 2 * w348 * c6) + w338 * w369 + w503 + w3 * (w511 + w24 * w512)
    w514 = w506 - w505
    w515 = w133 * w441 + w9 * w442 + w130 * w443 + w30 * w504 + w57 * w446 + w6 * w448 - w60 * w449 + w12 * w483
    w516 = hinge0_angle_dot * w447 - w515 + w45 * w509
    w517 = w12 * w482 - w34 * w437 - w6 * w438 + w55 * w442 + w59 * w504 + w126 * w439 + w32 * w514 + hinge2_angle_dot * w516
    w518 = w476 - w475
    w519 = w11 * (w468 / w36 + w94 * w471) + w3 * (w470 / w36 + w93 * w471)
    w520 = (w30 * w435 - w21 * w438 - w101 * w445 + w56 * w448 + w59 * w450 + w72 * w449 - w519) * bar3_end_z
    w521 = w513 + w11 * (w517 + w24 * w518) + w1 * w520 + (w519 + (w39 * w445 - w38 * w478 + w45 * w486 + w63 * w449)) * bar2_end_y
    w522 = w347 * w355 - w342 * w364 + w362 * w375 + w297 * w378 - w331 * w501 + w0 * w350 + hinge1_angle_dot * w502
    w523 = w361 * w375 - (w347 * w350 + w340 * w364) + w0 * w355 - w348 * w378 + hinge1_angle_dot * w501 + w331 * w502
    w524 = w2 * (w522 - w15 * w484 + w10 * w488 + w0 * w520 + w348 * w381) - w1 * (w523 + w297 * w381 + w3 * w484 + w11 * w488)
    w525 = w387 - w386
    w526 = hinge4_angle_dot * w393
    w527 = w526 + (w309 * w525 + w526)
    w528 = w21 * w439
    w529 = w30 * w439
    w530 = w137 * w439 + hinge5_angle_dot * w528 + w75 * w529
    w531 = w9 * w439
    w532 = w79 * w529 - w139 * w439 - hinge5_angle_dot * w531
    w533 = w312 * w317 - w210 * w391 + hinge5_angle_dot * w527 - w132 * w439 + w75 * w530 + w79 * w532 + w21 * w514
    w534 = w458 + w37 * w459
    w535 = w87 * w466 - w463
    w536 = w75 * w446 - w79 * w445
    w537 = hinge5_angle_dot * w446
    w538 = w537 - w79 * w449
    w539 = (w23 * w534 + w535 + w75 * w536 + hinge5_angle_dot * w538 + w80 * w449) * bar4_end_x
    w540 = w464 - w107 * w466
    w541 = hinge5_angle_dot * w445
    w542 = w541 - w75 * w449
    w543 = (w26 * w534 - w540 + w79 * w536 - hinge5_angle_dot * w542 - w76 * w449) * bar4_end_x
    w544 = hinge4_angle_dot * w391
    w545 = w305 * w525 - w544 - w544
    w546 = w326 * c14
    w547 = w87 * w459 - w456
    w548 = w457 - w107 * w459
    w549 = hinge5_angle_dot * w545 - w323 * w546 + w307 * w317 - w210 * w393 + (w26 * w547 + w23 * w548 + w76 * w445 + w80 * w446 + w75 * w542 + w79 * w538) * bar4_end_x
    w550 = w79 * w528 - w136 * w439 + w75 * w531
    w551 = w135 * w439 + hinge5_angle_dot * w530 + w79 * w550 + w30 * w507 + w9 * w477
    w552 = w134 * w439 + w75 * w550 - hinge5_angle_dot * w532 + w30 * w512 + w21 * w518
    w553 = w326 * (w22 * (w533 + w23 * w539 + w26 * w543 + w9 * w474) - w32 * (w549 + w26 * w551 + w23 * w552))
    w554 = (w392 + w317 * c25) * gravity_y + w120 * w460 + w83 * w547 + w78 * w534 + (w540 + hinge5_angle_dot * w541) * bar5_end_y
    w555 = w122 * w528 + w121 * w529 + w27 * w550 + w32 * w532 - w105 * w445 + w78 * w536 - w84 * w449 + w83 * w538
    w556 = w83 * w446 - w141 * w439 + w82 * w449
    w557 = w555 + hinge5_angle_dot * w556
    w558 = w22 * w546
    w559 = w141 * w460 - w558 * gravity_y + w83 * w548 + w82 * w534 - (w535 + hinge5_angle_dot * w537) * bar5_end_y
    w560 = w124 * w529 + w32 * w530 + w122 * w531 + w24 * w550 + w105 * w446 + w82 * w536 - w85 * w449 + w83 * w542
    w561 = w120 * w439 + w83 * w445 - w78 * w449
    w562 = w560 + hinge5_angle_dot * w561
    w563 = w23 * (w554 + hinge4_angle_dot * w557 + w32 * w543 + w22 * w551) - w26 * (w559 + w32 * w539 + hinge4_angle_dot * w562 + w22 * w552)
    w564 = w515 + (w52 * w447 + w100 * w446 - w4 * w478 + hinge0_angle_dot * (w4 * w445 - w447 - w16 * w446))
    w565 = w331 * w499 + w490 * (2 * hinge1_angle_dot) + w331 * w377 + w339 * w491 + w2 * w501 + w1 * w502 + w3 * (w564 + w49 * w509 + w46 * w449 + w13 * w479)
    w566 = w508 - (w46 * w445 + w67 * w446) + w52 * w452 + w48 * w509 + w16 * w479 + w4 * w486 + hinge0_angle_dot * (w13 * w446 - w452 + w4 * w449)
    w567 = w1 * w9 * bar3_end_z - w374
    w568 = w1 * w30 * bar3_end_z
    w569 = w568 - w30 * bar2_end_y
    w570 = w1 * w21 * bar3_end_z
    w571 = w21 * bar2_end_y - w570
    w572 = w3 * w569 - w11 * w571
    w573 = w15 * w24 + w0 * w27
    w574 = w10 * w24 + w0 * w32
    w575 = w11 * w573 + w3 * w574
    w576 = (w89 * w572 + 2 * (w7 * w567) - w95 * w575) / w97
    w577 = w3 * w567 / w36 - w88 * w576
    w578 = w11 * w567 / w36 - w115 * w576
    w579 = w15 * w32
    w580 = w10 * w27
    w581 = w579 - w580
    w582 = w575 / w36 + w144 * w576
    w583 = w572 / w36 - w108 * w576
    w584 = w154 * w578 - w155 * w583 - (w143 * w573 - w156 * w582)
    w585 = w37 * w584 + w157 * w577
    w586 = w0 * w17 - w9 * w570 + w11 * (w5 * w9) * c122
    w587 = w9 * w581 + w0 * w140 - (w30 * w573 + w10 * w29) + (w21 * w574 + w15 * w34)
    w588 = w21 * w568 - w12 * w15 - (w10 * w17 + w30 * w570)
    w589 = w0 * w12 + w9 * w568 - w9 * (w3 * w5) * c122
    w590 = w143 * w587 - w160 * w582 - (w37 * w586 + w159 * w577 + (w107 * w588 + w161 * w583) + (w87 * w589 + w162 * w578))
    w591 = w586 + (w37 * w590 + w163 * w577)
    w592 = w588 + (w107 * w590 + w163 * w583)
    w593 = w589 + (w87 * w590 + w163 * w578)
    w594 = w587 - (w143 * w590 - w163 * w582)
    w595 = (w218 * w591 + w219 * w592 + w221 * w593 + w223 * w594) / w225
    w596 = w591 / w168 - w217 * w595
    w597 = w107 * w584 + w157 * w583
    w598 = w592 / w168 - w229 * w595
    w599 = w87 * w584 + w157 * w578
    w600 = w593 / w168 - w232 * w595
    w601 = w573 + (w143 * w584 - w157 * w582)
    w602 = w594 / w168 - w235 * w595
    w603 = w169 * w585 + w158 * w596 + (w171 * w597 + w170 * w598) + (w173 * w599 + w172 * w600) - (w175 * w601 + w174 * w602)
    w604 = w169 * w603 + w176 * w596 - w585
    w605 = w26 * (w580 - w579) + w23 * w574
    w606 = w178 * w577 - w179 * w583 + w180 * w578 - (w143 * w605 - w181 * w582)
    w607 = w107 * w606 + w182 * w583
    w608 = w37 * w606 + w182 * w577
    w609 = w87 * w606 + w182 * w578
    w610 = w605 + (w143 * w606 - w182 * w582)
    w611 = w171 * w607 + w184 * w598 - (w183 * w596 - w169 * w608) + (w173 * w609 + w185 * w600) - (w175 * w610 + w186 * w602)
    w612 = w169 * w611 + w187 * w596 - w608
    w613 = w607 - (w171 * w611 + w187 * w598)
    w614 = w609 - (w173 * w611 + w187 * w600)
    w615 = w610 + (w175 * w611 + w187 * w602)
    w616 = (w248 * w612 + w249 * w613 + w251 * w614 + w253 * w615) / w255
    w617 = w612 / w192 - w247 * w616
    w618 = w597 - (w171 * w603 + w176 * w598)
    w619 = w613 / w192 - w259 * w616
    w620 = w599 - (w173 * w603 + w176 * w600)
    w621 = w614 / w192 - w262 * w616
    w622 = w601 + (w175 * w603 + w176 * w602)
    w623 = w615 / w192 - w265 * w616
    w624 = w193 * w604 + w177 * w617 + (w195 * w618 + w194 * w619) + (w197 * w620 + w196 * w621) + (w199 * w622 + w198 * w623)
    w625 = w604 - (w193 * w624 + w200 * w617)
    w626 = w620 - (w197 * w624 + w200 * w621)
    w627 = w199 * w624 + w200 * w623 - w622
    w628 = (w270 * w625 + w271 * (w618 - (w195 * w624 + w200 * w619)) + w273 * w626 + w275 * w627) / w277
    w629 = w314 * (w625 / w205 - w269 * w628) + w206 * w571 - (w316 * (w626 / w205 - w281 * w628) + w208 * w569)
    w630 = (w629 - (w140 * (w627 / w205 - w284 * w628) + w209 * w581)) / w205 - w318 * w628
    w631 = w314 * w577 + w37 * w571 + (w316 * w578 + w87 * w569) - (w143 * w581 - w140 * w582) - (w317 * w584 + w157 * w630)
    w632 = w314 * w617 + w193 * w571 - (w316 * w621 + w197 * w569) + (w140 * w623 + w199 * w581) - (w317 * w624 + w200 * w630)
    w633 = w632 / w192 - w327 * w616
    w634 = w314 * w596 + w169 * w571 + (w316 * w600 + w173 * w569) + (w140 * w602 + w175 * w581) + (w317 * w603 + w176 * w630)
    w635 = (w634 + (w326 * w611 + w187 * w633)) / w168 - w345 * w595
    w636 = hinge0_angle_dot * ((w631 - (w326 * w606 + w182 * w633) + (w330 * w590 + w163 * w635)) / w36 - w358 * w576)
    w637 = (w2 * w10 - w1 * w11) * bar3_end_z
    w638 = w366 * bar3_end_z
    w639 = w11 * w638
    w640 = (w1 * w3 + w2 * w15) * bar3_end_z
    w641 = w3 * w637 + w11 * w640
    w642 = w3 * w638
    w643 = (w89 * w641 - w93 * w642 - w94 * w639) / w97
    w644 = w639 / w36 + w115 * w643
    w645 = w642 / w36 + w88 * w643
    w646 = w144 * w643
    w647 = w641 / w36 - w108 * w643
    w648 = w156 * w646 - (w154 * w644 + w155 * w647)
    w649 = w37 * w648 - w157 * w645
    w650 = w9 * w640 + w21 * w638
    w651 = w21 * w637 - w30 * w640
    w652 = w30 * w638 + w9 * w637
    w653 = w160 * w646 + (w107 * w651 + w161 * w647 - (w37 * w650 + w159 * w645) + (w87 * w652 - w162 * w644))
    w654 = w650 + (w37 * w653 + w163 * w645)
    w655 = w651 + (w163 * w647 - w107 * w653)
    w656 = w652 - (w87 * w653 + w163 * w644)
    w657 = w143 * w653 + w163 * w646
    w658 = (w219 * w655 - w218 * w654 + w221 * w656 + w223 * w657) / w225
    w659 = w654 / w168 + w217 * w658
    w660 = w107 * w648 + w157 * w647
    w661 = w655 / w168 - w229 * w658
    w662 = w87 * w648 - w157 * w644
    w663 = w656 / w168 - w232 * w658
    w664 = w143 * w648 - w157 * w646
    w665 = w657 / w168 - w235 * w658
    w666 = w169 * w649 - w158 * w659 + (w171 * w660 + w170 * w661) + (w173 * w662 + w172 * w663) - (w175 * w664 + w174 * w665)
    w667 = w169 * w666 - w176 * w659 - w649
    w668 = w181 * w646 - (w178 * w645 + w179 * w647 + w180 * w644)
    w669 = w107 * w668 + w182 * w647
    w670 = w37 * w668 - w182 * w645
    w671 = w87 * w668 - w182 * w644
    w672 = w143 * w668 - w182 * w646
    w673 = w171 * w669 + w184 * w661 + (w169 * w670 + w183 * w659) + (w173 * w671 + w185 * w663) - (w175 * w672 + w186 * w665)
    w674 = w169 * w673 - w187 * w659 - w670
    w675 = w669 - (w171 * w673 + w187 * w661)
    w676 = w671 - (w173 * w673 + w187 * w663)
    w677 = w672 + (w175 * w673 + w187 * w665)
    w678 = (w248 * w674 + w249 * w675 + w251 * w676 + w253 * w677) / w255
    w679 = w674 / w192 - w247 * w678
    w680 = w660 - (w171 * w666 + w176 * w661)
    w681 = w675 / w192 - w259 * w678
    w682 = w662 - (w173 * w666 + w176 * w663)
    w683 = w676 / w192 - w262 * w678
    w684 = w664 + (w175 * w666 + w176 * w665)
    w685 = w677 / w192 - w265 * w678
    w686 = w193 * w667 + w177 * w679 + (w195 * w680 + w194 * w681) + (w197 * w682 + w196 * w683) + (w199 * w684 + w198 * w685)
    w687 = w667 - (w193 * w686 + w200 * w679)
    w688 = w682 - (w197 * w686 + w200 * w683)
    w689 = w199 * w686 + w200 * w685 - w684
    w690 = (w270 * w687 + w271 * (w680 - (w195 * w686 + w200 * w681)) + w273 * w688 + w275 * w689) / w277
    w691 = w314 * (w687 / w205 - w269 * w690) - w206 * w640 - (w316 * (w688 / w205 - w281 * w690) + w208 * w637)
    w692 = (w691 - w140 * (w689 / w205 - w284 * w690)) / w205 - w318 * w690
    w693 = w87 * w637 - w316 * w644 - (w314 * w645 + w37 * w640) + w140 * w646 - (w317 * w648 + w157 * w692)
    w694 = w314 * w679 - w193 * w640 - (w316 * w683 + w197 * w637) + w140 * w685 - (w317 * w686 + w200 * w692)
    w695 = w694 / w192 - w327 * w678
    w696 = w316 * w663 + w173 * w637 - (w314 * w659 + w169 * w640) + w140 * w665 + (w317 * w666 + w176 * w692)
    w697 = (w696 + (w326 * w673 + w187 * w695)) / w168 - w345 * w658
    w698 = hinge0_angle_dot * ((w693 - (w326 * w668 + w182 * w695) + (w163 * w697 - w330 * w653)) / w36 - w358 * w643)
    w699 = w9 * w77
    w700 = w21 * w81
    w701 = w699 - w700
    w702 = w30 * w77 + w21 * w22
    w703 = w30 * w81 + w9 * w22
    w704 = w30 * w701 - w9 * w702 + w21 * w703
    w705 = w11 * w701 - w3 * w703
    w706 = w95 * w705 / w97
    w707 = w705 / w36 - w144 * w706
    w708 = w88 * w706
    w709 = w108 * w706
    w710 = w115 * w706
    w711 = w143 * w704 + w160 * w707 + (w159 * w708 + w161 * w709 + w162 * w710)
    w712 = w37 * w711 - w163 * w708
    w713 = w107 * w711 - w163 * w709
    w714 = w87 * w711 - w163 * w710
    w715 = w704 - (w143 * w711 + w163 * w707)
    w716 = (w218 * w712 + w219 * w713 + w221 * w714 + w223 * w715) / w225
    w717 = w712 / w168 - w217 * w716
    w718 = w714 / w168 - w232 * w716
    w719 = w715 / w168 - w235 * w716
    w720 = w24 * bar4_end_x
    w721 = w27 * bar4_end_x
    w722 = w700 - w699
    w723 = w87 * w720 - w154 * w710 + (w107 * w721 + w155 * w709) - (w143 * w722 + w156 * w707)
    w724 = w37 * w723 - w157 * w708
    w725 = w107 * w723 - w157 * w709 - w721
    w726 = w713 / w168 - w229 * w716
    w727 = w87 * w723 - w157 * w710 - w720
    w728 = w722 + (w143 * w723 + w157 * w707)
    w729 = w169 * w724 + w158 * w717 + (w171 * w725 + w170 * w726) + (w173 * w727 + w172 * w718) - (w175 * w728 + w174 * w719)
    w730 = w169 * w729 + w176 * w717 - w724
    w731 = w23 * w178
    w732 = w26 * w178
    w733 = w26 * w702 + w23 * w703
    w734 = w37 * w83 - w178 * w708 + (w107 * w731 + w179 * w709) - (w87 * w732 + w180 * w710) - (w143 * w733 + w181 * w707)
    w735 = w83 - (w37 * w734 - w182 * w708)
    w736 = w107 * w734 - w182 * w709 - w731
    w737 = w732 + (w87 * w734 - w182 * w710)
    w738 = w733 + (w143 * w734 + w182 * w707)
    w739 = w171 * w736 + w184 * w726 - (w169 * w735 + w183 * w717) + (w173 * w737 + w185 * w718) - (w175 * w738 + w186 * w719)
    w740 = w735 + (w169 * w739 + w187 * w717)
    w741 = w736 - (w171 * w739 + w187 * w726)
    w742 = w737 - (w173 * w739 + w187 * w718)
    w743 = w738 + (w175 * w739 + w187 * w719)
    w744 = (w248 * w740 + w249 * w741 + w251 * w742 + w253 * w743) / w255
    w745 = w740 / w192 - w247 * w744
    w746 = w725 - (w171 * w729 + w176 * w726)
    w747 = w741 / w192 - w259 * w744
    w748 = w727 - (w173 * w729 + w176 * w718)
    w749 = w742 / w192 - w262 * w744
    w750 = w728 + (w175 * w729 + w176 * w719)
    w751 = w743 / w192 - w265 * w744
    w752 = w193 * w730 + w177 * w745 + (w195 * w746 + w194 * w747) + (w197 * w748 + w196 * w749) + (w199 * w750 + w198 * w751)
    w753 = w730 - (w193 * w752 + w200 * w745)
    w754 = w748 - (w197 * w752 + w200 * w749)
    w755 = w199 * w752 + w200 * w751 - w750
    w756 = (w270 * w753 + w271 * (w746 - (w195 * w752 + w200 * w747)) + w273 * w754 + w275 * w755) / w277
    w757 = w314 * (w753 / w205 - w269 * w756) - w316 * (w754 / w205 - w281 * w756) - (w140 * (w755 / w205 - w284 * w756) - w209 * w702)
    w758 = w757 / w205 - w318 * w756
    w759 = (w314 * w745 - w316 * w749 + (w140 * w751 - w199 * w702) - (w317 * w752 + w200 * w758)) / w192 - w327 * w744
    w760 = w314 * w717 + w316 * w718 + (w140 * w719 - w175 * w702) + (w317 * w729 + w176 * w758) + (w326 * w739 + w187 * w759)
    w761 = w760 / w168 - w345 * w716
    w762 = w314 * w708 + w316 * w710 + (w140 * w707 - w143 * w702) + (w317 * w723 + w157 * w758) + (w326 * w734 + w182 * w759)
    w763 = w347 * w636 - w330 * w698 + w326 * (hinge0_angle_dot * ((w330 * w711 + w163 * w761 - w762) / w36 - w358 * w706))
    w764 = w146 + w9 * w24
    w765 = w11 * w764 + w3 * w119
    w766 = w95 * w765 / w97
    w767 = w88 * w766
    w768 = w115 * w766
    w769 = w144 * w766 - w765 / w36
    w770 = w103 - w82
    w771 = w108 * w766
    w772 = w87 * w155 + w154 * w768 - (w107 * w770 + w155 * w771) - (w143 * w764 + w156 * w769)
    w773 = w37 * w772 + w157 * w767
    w774 = w9 * w31 - w30 * w764 + w21 * w119
    w775 = w143 * w774 + w160 * w769 - (w159 * w767 + w161 * w771 + w162 * w768)
    w776 = w37 * w775 + w163 * w767
    w777 = w107 * w775 + w163 * w771
    w778 = w87 * w775 + w163 * w768
    w779 = w774 - (w143 * w775 + w163 * w769)
    w780 = (w218 * w776 + w219 * w777 + w221 * w778 + w223 * w779) / w225
    w781 = w776 / w168 - w217 * w780
    w782 = w770 + (w107 * w772 + w157 * w771)
    w783 = w777 / w168 - w229 * w780
    w784 = w87 * w772 + w157 * w768 - w155
    w785 = w778 / w168 - w232 * w780
    w786 = w764 + (w143 * w772 + w157 * w769)
    w787 = w779 / w168 - w235 * w780
    w788 = w169 * w773 + w158 * w781 + (w171 * w782 + w170 * w783) + (w173 * w784 + w172 * w785) - (w175 * w786 + w174 * w787)
    w789 = w169 * w788 + w176 * w781 - w773
    w790 = w23 * w120 - w26 * w31 + (w23 * w119 - w26 * w141)
    w791 = w178 * w767 - (w179 * w771 - w107 * w180) + (w87 * w179 + w180 * w768) - (w143 * w790 + w181 * w769)
    w792 = w37 * w791 + w182 * w767
    w793 = w107 * w791 + w182 * w771 - w180
    w794 = w87 * w791 + w182 * w768 - w179
    w795 = w790 + (w143 * w791 + w182 * w769)
    w796 = w171 * w793 + w184 * w783 - (w183 * w781 - w169 * w792) + (w173 * w794 + w185 * w785) - (w175 * w795 + w186 * w787)
    w797 = w169 * w796 + w187 * w781 - w792
    w798 = w793 - (w171 * w796 + w187 * w783)
    w799 = w794 - (w173 * w796 + w187 * w785)
    w800 = w795 + (w175 * w796 + w187 * w787)
    w801 = (w248 * w797 + w249 * w798 + w251 * w799 + w253 * w800) / w255
    w802 = w797 / w192 - w247 * w801
    w803 = w782 - (w171 * w788 + w176 * w783)
    w804 = w798 / w192 - w259 * w801
    w805 = w784 - (w173 * w788 + w176 * w785)
    w806 = w799 / w192 - w262 * w801
    w807 = w786 + (w175 * w788 + w176 * w787)
    w808 = w800 / w192 - w265 * w801
    w809 = w193 * w789 + w177 * w802 + (w195 * w803 + w194 * w804) + (w197 * w805 + w196 * w806) + (w199 * w807 + w198 * w808)
    w810 = w789 - (w193 * w809 + w200 * w802)
    w811 = w805 - (w197 * w809 + w200 * w806)
    w812 = w199 * w809 + w200 * w808 - w807
    w813 = (w270 * w810 + w271 * (w803 - (w195 * w809 + w200 * w804)) + w273 * w811 + w275 * w812) / w277
    w814 = w314 * (w810 / w205 - w269 * w813) - w316 * (w811 / w205 - w281 * w813) - (w140 * (w812 / w205 - w284 * w813) + w31 * w209)
    w815 = w814 / w205 - w318 * w813
    w816 = (w314 * w802 - w316 * w806 + (w140 * w808 + w31 * w199) - (w317 * w809 + w200 * w815)) / w192 - w327 * w801
    w817 = w314 * w767 + w316 * w768 - (w211 + w140 * w769) - (w317 * w772 + w157 * w815) - (w326 * w791 + w182 * w816)
    w818 = w314 * w781 + w316 * w785 + (w140 * w787 + w31 * w175) + (w317 * w788 + w176 * w815) + (w326 * w796 + w187 * w816)
    w819 = w818 / w168 - w345 * w780
    w820 = hinge0_angle_dot * w359 + (w763 + w317 * (hinge0_angle_dot * ((w817 + (w330 * w775 + w163 * w819)) / w36 + w358 * w766)))
    w821 = w330 * (hinge0_angle_dot * w697) - w347 * (hinge0_angle_dot * w635) - w326 * (hinge0_angle_dot * w761)
    w822 = (w494 + w496 - w495 + w9 * w453 + w21 * w516 + w30 * w510) * (w821 - w317 * (hinge0_angle_dot * w819) - hinge0_angle_dot * w346)
    w823 = w305 * w393
    w824 = w347 * (hinge0_angle_dot * w633) - w330 * (hinge0_angle_dot * w695) + w326 * (hinge0_angle_dot * w759)
    w825 = (w823 + (w823 - 2 * (w309 * w391)) + w26 * w557 + w23 * w562) * (hinge0_angle_dot * w328 + (w824 + w317 * (hinge0_angle_dot * w816)))
    w826 = 2 * hinge5_angle_dot * (w558 * bar5_end_y) + w22 * w545 + w32 * w527 + w124 * w528 + w27 * w530 - w121 * w531
    w827 = w826 - w24 * w532 + w445 * (w26 * hinge5_angle_dot) * c123 + w85 * w445 + w84 * w446 - w104 * w446
    w828 = w347 * (hinge0_angle_dot * w630) - w330 * (hinge0_angle_dot * w692) + w326 * (hinge0_angle_dot * w758)
    w829 = (w827 - w103 * w537 - w78 * w542 + w82 * w538 + w79 * w556 + w75 * w561) * (hinge0_angle_dot * w319 + (w828 + w317 * (hinge0_angle_dot * w815)))
    w830 = w360 + (w347 * (w0 * (w489 + w498) - w9 * w521) - w330 * w524 + w553 + w317 * w563) + ((w565 + w11 * w566 + w339 * w497) * w820 + w822 + w825 + w829)
    # outputs
    dQ_hat_dq_i = ca.vertcat(w830)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    821 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 129)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_dot = q_i_dot[0]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c23 = c[23]
    c123 = c[123]
    c124 = c[124]
    c125 = c[125]
    c126 = c[126]
    # intermediate terms (218)
    w0 = ca.cos(hinge1_angle)
    w1 = ca.sin(hinge2_angle)
    w2 = ca.cos(hinge0_angle)
    w3 = w0 * bar2_end_y
    w4 = w0 * w1
    w5 = w4 * bar3_end_z
    w6 = w3 - w5
    w7 = ca.sin(hinge1_angle)
    w8 = w2 * w7
    w9 = ca.cos(hinge2_angle)
    w10 = ca.sin(hinge0_angle)
    w11 = (w1 * w8 + w9 * w10) * bar3_end_z
    w12 = w8 * bar2_end_y
    w13 = w11 - w12
    w14 = w7 * w10
    w15 = w14 * bar2_end_y
    w16 = (w2 * w9 - w1 * w14) * bar3_end_z
    w17 = w15 + w16
    w18 = w2 * w13 - w10 * w17
    w19 = w0 * w10
    w20 = ca.cos(hinge4_angle)
    w21 = ca.cos(hinge5_angle)
    w22 = w20 * w21
    w23 = w19 * w22
    w24 = ca.sin(hinge5_angle)
    w25 = w20 * w24
    w26 = w7 * w25
    w27 = w23 - w26
    w28 = w0 * w2
    w29 = w22 * w28
    w30 = ca.sin(hinge4_angle)
    w31 = w7 * w30
    w32 = w29 - w31
    w33 = w10 * w27 + w2 * w32
    w34 = ca.sqrt(w18**2 + w6**2 + w33**2)
    w35 = w2 * w6 / w34
    w36 = w10 * bar1_end_x
    w37 = w17 - w36
    w38 = w6 * w10 / w34
    w39 = w2 * bar1_end_x
    w40 = w13 + w39
    w41 = w33 / w34
    w42 = w25 * w28
    w43 = w19 * w30
    w44 = w42 - w43
    w45 = w21 * w30
    w46 = w45 * bar4_end_x
    w47 = w46 - w21 * bar5_end_y
    w48 = w24 * w30
    w49 = w48 * bar4_end_x
    w50 = w24 * bar5_end_y - w49
    w51 = w18 / w34
    w52 = w26 - w23
    w53 = w38 * w47 - w50 * w51 - w41 * w52
    w54 = w35 * w53
    w55 = w7 * w16 - w5 * w19
    w56 = w27 * w28 + w7 * w44 - w19 * w32
    w57 = w11 * w19 + w16 * w28
    w58 = w5 * w28 + w7 * w11
    w59 = w41 * w56 - (w35 * w55 + w51 * w57 + w38 * w58)
    w60 = w55 + w35 * w59
    w61 = w57 + w51 * w59
    w62 = w58 + w38 * w59
    w63 = w56 - w41 * w59
    w64 = ca.sqrt(w60**2 + w61**2 + w62**2 + w63**2)
    w65 = w60 / w64
    w66 = w50 + w51 * w53
    w67 = w61 / w64
    w68 = w38 * w53 - w47
    w69 = w62 / w64
    w70 = w52 + w41 * w53
    w71 = w63 / w64
    w72 = w54 * w65 + w66 * w67 + w68 * w69 - w70 * w71
    w73 = w65 * w72 - w54
    w74 = w30 * bar4_end_x
    w75 = w20 * bar4_end_x
    w76 = w21 * w75
    w77 = w24 * w75
    w78 = w43 - w42
    w79 = w31 - w29
    w80 = w24 * w78 + w21 * w79
    w81 = w35 * w74 - w51 * w76 + w38 * w77 - w41 * w80
    w82 = w74 - w35 * w81
    w83 = w76 + w51 * w81
    w84 = w38 * w81 - w77
    w85 = w80 + w41 * w81
    w86 = w67 * w83 - w65 * w82 + w69 * w84 - w71 * w85
    w87 = w82 + w65 * w86
    w88 = w83 - w67 * w86
    w89 = w84 - w69 * w86
    w90 = w85 + w71 * w86
    w91 = ca.sqrt(w87**2 + w88**2 + w89**2 + w90**2)
    w92 = w87 / w91
    w93 = w66 - w67 * w72
    w94 = w88 / w91
    w95 = w68 - w69 * w72
    w96 = w89 / w91
    w97 = w70 + w71 * w72
    w98 = w90 / w91
    w99 = w73 * w92 + w93 * w94 + w95 * w96 + w97 * w98
    w100 = w73 - w92 * w99
    w101 = w93 - w94 * w99
    w102 = w95 - w96 * w99
    w103 = w98 * w99 - w97
    w104 = ca.sqrt(w100**2 + w101**2 + w102**2 + w103**2)
    w105 = w100 / w104
    w106 = w102 / w104
    w107 = w103 / w104
    w108 = (w37 * w105 - w40 * w106 - w44 * w107) / w104
    w109 = (w37 * w92 - w40 * w96 + w44 * w98 - w99 * w108) / w91
    w110 = (w37 * w65 + w40 * w69 + w44 * w71 + w72 * w108 + w86 * w109) / w64
    w111 = (w35 * w37 + w38 * w40 - w41 * w44 - w53 * w108 - w81 * w109 + w59 * w110) / w34
    w112 = w111 * hinge0_angle_dot
    w113 = w7 * hinge0_angle_dot
    w114 = hinge0_angle_dot * (w7 * w111) * c125
    w115 = w10 * w112
    w116 = w10 * w111
    w117 = w115 + hinge0_angle_dot * w116
    w118 = w3 * w115 + w12 * hinge0_angle_dot
    w119 = w12 + w3 * w116
    w120 = w2 * w112
    w121 = w2 * w111
    w122 = w3 * w117 - 2 * (w39 * hinge0_angle_dot) + (w118 + hinge0_angle_dot * w119 + hinge0_angle_dot * (w111 * (w8 * w111)) * c124)
    w123 = w110 * hinge0_angle_dot
    w124 = w28 * w123
    w125 = w28 * w110
    w126 = w124 + hinge0_angle_dot * w125 - hinge0_angle_dot * (w111 * (w14 * w110)) * c125 - w117
    w127 = w19 * w123
    w128 = w19 * w110
    w129 = hinge0_angle_dot * (w111 * (w0 * w110)) * c125
    w130 = w115 - w124
    w131 = hinge0_angle_dot - w7 * w123
    w132 = w5 * w130 + w11 * w131
    w133 = 1.0 - w7 * w110
    w134 = w116 - w125
    w135 = w5 * w134 + w11 * w133
    w136 = w120 + w127
    w137 = w11 * w136 - w16 * w130
    w138 = w121 + w128
    w139 = w11 * w138 - w16 * w134
    w140 = w109 * hinge0_angle_dot
    w141 = w21 * w140
    w142 = w108 * hinge0_angle_dot
    w143 = w21 * w109
    w144 = w21 * w108
    w145 = hinge0_angle_dot * (w109 * w144) * c125
    w146 = w24 * w140
    w147 = w24 * w109
    w148 = w24 * w108
    w149 = hinge0_angle_dot * (w109 * w148) * c125
    w150 = w46 * w142 + w75 * w146
    w151 = w46 * w108 + w75 * w147
    w152 = w75 * w141 - w49 * w142
    w153 = w75 * w143 - w49 * w108
    w154 = w122 + (w5 * w126 - w16 * w129) - (w132 * w133 + w131 * w135 + (w137 * w138 + w136 * w139)) - (w49 * w145 - w46 * w149 + (w147 * w150 + w146 * w151 + (w143 * w152 + w141 * w153)))
    w155 = w120 + hinge0_angle_dot * w121
    w156 = w15 * hinge0_angle_dot - w3 * w120
    w157 = w15 - w3 * w121
    w158 = w155 + (w127 + hinge0_angle_dot * w128 + hinge0_angle_dot * (w111 * (w8 * w110)) * c125)
    w159 = w12 * w117 - w15 * w155 + (w121 * w156 + w120 * w157 - (w116 * w118 + w115 * w119)) + (w11 * w126 - w16 * w158)
    w160 = w16 * w131 + w5 * w136
    w161 = w16 * w133 + w5 * w138
    w162 = hinge0_angle_dot * (w108 * w144) * c123 - w75 * w149 - (hinge0_angle_dot * (w109 * (w45 * w109)) * c126 + (w108 * w150 + w142 * w151))
    w163 = w159 + (w138 * w160 + w136 * w161 + (w132 * w134 + w130 * w135)) - w162
    w164 = 2 * (w36 * hinge0_angle_dot) + w3 * w155 - (hinge0_angle_dot * (w111 * (w14 * w111)) * c124 + (w156 + hinge0_angle_dot * w157))
    w165 = hinge0_angle_dot * (w109 * (w48 * w109)) * c126 - (w108 * w152 + w142 * w153) - (hinge0_angle_dot * (w108 * w148) * c123 + w75 * w145)
    w166 = w164 - (w5 * w158 - w11 * w129) + (w134 * w137 + w130 * w139 - (w133 * w160 + w131 * w161)) - w165
    w167 = w30 * w146 - w22 * w142
    w168 = w30 * w147 - w22 * w108
    w169 = w20 * w109
    w170 = w30 * w141 + w25 * w142
    w171 = w30 * w143 + w25 * w108
    w172 = w7 * (w108 * w167 + w142 * w168 - hinge0_angle_dot * (w109 * (w22 * w109)) * c125) - w28 * (w147 * w167 + w146 * w168 + (w143 * w170 + w141 * w171))
    w173 = w7 * w130 - w28 * w131
    w174 = w7 * w134 - w28 * w133
    w175 = w28 * w136 + w19 * w130
    w176 = w28 * w138 + w19 * w134
    w177 = w172 - w19 * (w108 * w170 + w142 * w171 + hinge0_angle_dot * (w109 * (w25 * w109)) * c125) + w30 * (w133 * w173 + w131 * w174 - (w138 * w175 + w136 * w176))
    w178 = w19 * w131 + w7 * w136
    w179 = w19 * w133 + w7 * w138
    w180 = w177 - w22 * (w138 * w178 + w136 * w179 + (w134 * w173 + w130 * w174)) - w25 * (w134 * w175 + w130 * w176 + (w133 * w178 + w131 * w179))
    w181 = w180 + (hinge0_angle_dot * w169 * (2 * -w179) + w169 * (2 * -w178)) - (w170 * (2 * w176) + w171 * (2 * w175))
    w182 = w78 * w145 - (w181 + (w167 * (2 * w174) + w168 * (2 * w173)) + w27 * w158 - w44 * w129 + w32 * w126)
    w183 = w182 - w79 * w149
    w184 = (w105 * w154 + w163 * (w101 / w104) + w106 * w166 + w107 * w183) / w104
    w185 = (w92 * w154 + w94 * w163 + w96 * w166 - w98 * w183 - w99 * w184) / w91
    w186 = (w67 * w163 - w65 * w154 + w69 * w166 + w71 * w183 - w72 * w184 - w86 * w185) / w64
    w187 = (w35 * w154 - w51 * w163 - w38 * w166 + w41 * w183 - w53 * w184 - w81 * w185 - w59 * w186) / w34
    w188 = w0 * w9 + w1 * w111
    w189 = w0 * hinge0_angle_dot
    w190 = w9 * w189 + w1 * w112
    w191 = w113 - w123
    w192 = w7 - w110
    w193 = (w1 * w114 + w9 * w187 + (w123 * w188 + w110 * w190) - (w188 * w191 + w190 * w192)) * c1
    w194 = 2 * hinge0_angle_dot * bar1_end_x
    w195 = w0 * w194
    w196 = hinge0_angle_dot * (w0 * w7) * c125
    w197 = w187 - w196
    w198 = w9 * w111 - w4
    w199 = w9 * w112 - w1 * w189
    w200 = w191 * w198 + w192 * w199 - (w9 * w114 - w1 * w187 + (w123 * w198 + w110 * w199))
    w201 = (w195 + w197 * bar2_end_y) * c4 - w200 * c0
    w202 = hinge0_angle_dot * (w0 * w111) * c125
    w203 = w186 + w202
    w204 = w190 * w198 + w188 * w199
    w205 = w203 - w204
    w206 = w9 * ((w188 * (2 * w190) + w192 * (2 * w191)) * c4) + w1 * (w205 * c4)
    w207 = 2 * w202
    w208 = (w9 * (w7 * w194 - (w7 * (2 * w113) + w111 * (2 * w112)) * bar2_end_y) + w1 * (w207 * bar2_end_y)) * c4
    w209 = w205 * c0 + (w203 + w204) * c1 - w208
    w210 = w0 * (w1 * w193 + w9 * w201 + 2 * w114 * c6) + w7 * (w206 * bar2_end_y - w209 - w207 * c5) + (w207 * c8 - w206) * bar1_end_x
    w211 = hinge0_angle_dot * (w109 * (w30 * w108)) * c125
    w212 = hinge0_angle_dot * (w109 * (w20 * w108)) * c125
    w213 = w212 + (w212 + w30 * w184)
    w214 = w20 * ((w211 + (w211 - w20 * w184)) * c16) - w30 * (w184 * c18 + w213 * c15) - w213 * c18 - w184 * c20
    w215 = hinge0_angle_dot * (w108 * (w108 * (w20 * w30))) * c125
    w216 = w109 * ((w215 - w185) * c15 - (w185 + w215) * c16 + w20 * (w108 * (2 * w142) * bar5_end_y) * c14)
    w217 = w210 + w108 * w214 + w216 + w110 * w209 - w111 * (w9 * w193 - w1 * w201 - w200 * c23 + (w195 * c8 + (w197 * c5 + (w187 + w196) * c6)))
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w217)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 39) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 129) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dMa_dq_i (n_i x n_i = 1) [SI]: total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot
    1358 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 129)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    hinge0_angle_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    bar2_end_y = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    bar1_end_x = c[7]
    c8 = c[8]
    bar4_end_x = c[11]
    bar5_end_y = c[12]
    bar3_end_z = c[13]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c120 = c[120]
    c121 = c[121]
    c127 = c[127]
    c128 = c[128]
    # intermediate terms (350)
    w0 = ca.sin(hinge4_angle)
    w1 = ca.cos(hinge5_angle)
    w2 = w0 * w1 * bar4_end_x
    w3 = w2 - w1 * bar5_end_y
    w4 = ca.sin(hinge0_angle)
    w5 = ca.cos(hinge1_angle)
    w6 = ca.sin(hinge2_angle)
    w7 = w5 * w6
    w8 = w7 * bar3_end_z
    w9 = w5 * bar2_end_y - w8
    w10 = w4 * w9
    w11 = ca.cos(hinge0_angle)
    w12 = w9 * w11
    w13 = ca.sin(hinge1_angle)
    w14 = w11 * w13
    w15 = ca.cos(hinge2_angle)
    w16 = (w6 * w14 + w4 * w15) * bar3_end_z
    w17 = w14 * bar2_end_y
    w18 = w16 - w17
    w19 = w4 * w13
    w20 = (w11 * w15 - w6 * w19) * bar3_end_z
    w21 = w19 * bar2_end_y + w20
    w22 = w11 * w18 - w4 * w21
    w23 = w4 * w5
    w24 = ca.cos(hinge4_angle)
    w25 = w1 * w24
    w26 = w23 * w25
    w27 = ca.sin(hinge5_angle)
    w28 = w24 * w27
    w29 = w13 * w28
    w30 = w26 - w29
    w31 = w5 * w11
    w32 = w25 * w31
    w33 = w0 * w13
    w34 = w32 - w33
    w35 = w4 * w30 + w11 * w34
    w36 = ca.sqrt(w22**2 + w9**2 + w35**2)
    w37 = w10 / w36
    w38 = w0 * w27 * bar4_end_x
    w39 = w27 * bar5_end_y - w38
    w40 = w22 / w36
    w41 = w29 - w26
    w42 = w35 / w36
    w43 = w3 * w37 - w39 * w40 - w41 * w42
    w44 = w12 / w36
    w45 = w43 * w44
    w46 = w13 * w20 - w8 * w23
    w47 = w28 * w31
    w48 = w0 * w23
    w49 = w47 - w48
    w50 = w30 * w31 + w13 * w49 - w23 * w34
    w51 = w16 * w23 + w20 * w31
    w52 = w8 * w31 + w13 * w16
    w53 = w42 * w50 - (w44 * w46 + w40 * w51 + w37 * w52)
    w54 = w46 + w44 * w53
    w55 = w51 + w40 * w53
    w56 = w52 + w37 * w53
    w57 = w50 - w42 * w53
    w58 = ca.sqrt(w54**2 + w55**2 + w56**2 + w57**2)
    w59 = w54 / w58
    w60 = w39 + w40 * w43
    w61 = w55 / w58
    w62 = w37 * w43 - w3
    w63 = w56 / w58
    w64 = w41 + w42 * w43
    w65 = w57 / w58
    w66 = w45 * w59 + w60 * w61 + w62 * w63 - w64 * w65
    w67 = w59 * w66 - w45
    w68 = w0 * bar4_end_x
    w69 = w24 * bar4_end_x
    w70 = w1 * w69
    w71 = w27 * w69
    w72 = w48 - w47
    w73 = w33 - w32
    w74 = w27 * w72 + w1 * w73
    w75 = w44 * w68 - w40 * w70 + w37 * w71 - w42 * w74
    w76 = w68 - w44 * w75
    w77 = w70 + w40 * w75
    w78 = w37 * w75 - w71
    w79 = w74 + w42 * w75
    w80 = w61 * w77 - w59 * w76 + w63 * w78 - w65 * w79
    w81 = w76 + w59 * w80
    w82 = w77 - w61 * w80
    w83 = w78 - w63 * w80
    w84 = w79 + w65 * w80
    w85 = ca.sqrt(w81**2 + w82**2 + w83**2 + w84**2)
    w86 = w81 / w85
    w87 = w60 - w61 * w66
    w88 = w82 / w85
    w89 = w62 - w63 * w66
    w90 = w83 / w85
    w91 = w64 + w65 * w66
    w92 = w84 / w85
    w93 = w67 * w86 + w87 * w88 + w89 * w90 + w91 * w92
    w94 = w67 - w86 * w93
    w95 = w87 - w88 * w93
    w96 = w89 - w90 * w93
    w97 = w92 * w93 - w91
    w98 = ca.sqrt(w94**2 + w95**2 + w96**2 + w97**2)
    w99 = w94 / w98
    w100 = w21 - w4 * bar1_end_x
    w101 = w96 / w98
    w102 = w11 * bar1_end_x
    w103 = w18 + w102
    w104 = w97 / w98
    w105 = (w99 * w100 - w101 * w103 - w49 * w104) / w98
    w106 = w37 / w36
    w107 = 2 * w22
    w108 = w11 * w21
    w109 = w17 - w16
    w110 = w108 - w4 * w18 - (w108 + w4 * w109)
    w111 = 2 * w12
    w112 = 2 * w10
    w113 = 2 * w35
    w114 = w4 * w32 + w11 * w30 - (w11 * w26 + w4 * w34)
    w115 = 2 * w36
    w116 = (w107 * w110 - w10 * w111 + w12 * w112 + w113 * w114) / w115
    w117 = w44 - w106 * w116
    w118 = w40 / w36
    w119 = w110 / w36 - w116 * w118
    w120 = w42 / w36
    w121 = w114 / w36 - w116 * w120
    w122 = w3 * w117 - w39 * w119 - (w41 * w121 - w32 * w42)
    w123 = w44 / w36
    w124 = w37 + w116 * w123
    w125 = w44 * w122 - w43 * w124
    w126 = w23 * w28 + w0 * w31
    w127 = w31 * w32 - w23 * w30 - w13 * w126 - (w31 * w34 - w23 * w26)
    w128 = w42 * w127 + w50 * w121 - (w51 * w119 - (w44 * w52 + w46 * w124) + (w37 * w46 + w52 * w117))
    w129 = w44 * w128 - w53 * w124 - w52
    w130 = w59 / w58
    w131 = 2 * w54
    w132 = 2 * w55
    w133 = w40 * w128 + w53 * w119
    w134 = 2 * w56
    w135 = w46 + (w37 * w128 + w53 * w117)
    w136 = 2 * w57
    w137 = w127 - (w42 * w128 + w53 * w121)
    w138 = 2 * w58
    w139 = (w129 * w131 + w132 * w133 + w134 * w135 + w136 * w137) / w138
    w140 = w129 / w58 - w130 * w139
    w141 = w40 * w122 + w43 * w119
    w142 = w61 / w58
    w143 = w133 / w58 - w139 * w142
    w144 = w37 * w122 + w43 * w117
    w145 = w63 / w58
    w146 = w135 / w58 - w139 * w145
    w147 = w42 * w122 + w43 * w121 - w32
    w148 = w65 / w58
    w149 = w137 / w58 - w139 * w148
    w150 = w59 * w125 + w45 * w140 + (w61 * w141 + w60 * w143) + (w63 * w144 + w62 * w146) - (w65 * w147 + w64 * w149)
    w151 = w59 * w150 + w66 * w140 - w125
    w152 = w27 * w126 + w1 * w26
    w153 = w71 * w117 - (w68 * w124 + w70 * w119) - (w42 * w152 + w74 * w121)
    w154 = w40 * w153 + w75 * w119
    w155 = w44 * w153 - w75 * w124
    w156 = w37 * w153 + w75 * w117
    w157 = w152 + (w42 * w153 + w75 * w121)
    w158 = w61 * w154 + w77 * w143 - (w76 * w140 - w59 * w155) + (w63 * w156 + w78 * w146) - (w65 * w157 + w79 * w149)
    w159 = w59 * w158 + w80 * w140 - w155
    w160 = w86 / w85
    w161 = 2 * w81
    w162 = 2 * w82
    w163 = w154 - (w61 * w158 + w80 * w143)
    w164 = 2 * w83
    w165 = w156 - (w63 * w158 + w80 * w146)
    w166 = 2 * w84
    w167 = w157 + (w65 * w158 + w80 * w149)
    w168 = 2 * w85
    w169 = (w159 * w161 + w162 * w163 + w164 * w165 + w166 * w167) / w168
    w170 = w159 / w85 - w160 * w169
    w171 = w141 - (w61 * w150 + w66 * w143)
    w172 = w88 / w85
    w173 = w163 / w85 - w169 * w172
    w174 = w144 - (w63 * w150 + w66 * w146)
    w175 = w90 / w85
    w176 = w165 / w85 - w169 * w175
    w177 = w147 + (w65 * w150 + w66 * w149)
    w178 = w92 / w85
    w179 = w167 / w85 - w169 * w178
    w180 = w86 * w151 + w67 * w170 + (w88 * w171 + w87 * w173) + (w90 * w174 + w89 * w176) + (w92 * w177 + w91 * w179)
    w181 = w151 - (w86 * w180 + w93 * w170)
    w182 = w99 / w98
    w183 = 2 * w94
    w184 = 2 * w95
    w185 = 2 * w96
    w186 = w174 - (w90 * w180 + w93 * w176)
    w187 = 2 * w97
    w188 = w92 * w180 + w93 * w179 - w177
    w189 = 2 * w98
    w190 = (w181 * w183 + w184 * (w171 - (w88 * w180 + w93 * w173)) + w185 * w186 + w187 * w188) / w189
    w191 = w109 - w102
    w192 = w101 / w98
    w193 = w100 * (w181 / w98 - w182 * w190) + w99 * w191 - (w103 * (w186 / w98 - w190 * w192) + w100 * w101)
    w194 = w104 / w98
    w195 = w105 / w98
    w196 = (w193 - (w49 * (w188 / w98 - w190 * w194) - w104 * w126)) / w98 - w190 * w195
    w197 = hinge0_angle_ddot * w196
    w198 = w0 * w197
    w199 = w105 * hinge0_angle_ddot
    w200 = w0 * w199
    w201 = w199 * c18 + w200 * c15
    w202 = w24 * (w24 * w199 * c16) + w0 * w201 + w200 * c18 + w199 * c20
    w203 = w105 * (w24 * (w24 * w197 * c16) + w0 * (w197 * c18 + w198 * c15) + w198 * c18 + w197 * c20) + w196 * w202
    w204 = w44 * w191 - w100 * w124 + (w103 * w117 + w37 * w100) - (w49 * w121 - w42 * w126) - (w105 * w122 + w43 * w196)
    w205 = (w86 * w100 - w90 * w103 + w49 * w92 - w93 * w105) / w85
    w206 = w100 * w170 + w86 * w191 - (w103 * w176 + w90 * w100) + (w49 * w179 - w92 * w126) - (w105 * w180 + w93 * w196)
    w207 = w205 / w85
    w208 = w206 / w85 - w169 * w207
    w209 = (w59 * w100 + w63 * w103 + w49 * w65 + w66 * w105 + w80 * w205) / w58
    w210 = w100 * w140 + w59 * w191 + (w103 * w146 + w63 * w100) + (w49 * w149 - w65 * w126) + (w105 * w150 + w66 * w196)
    w211 = w209 / w58
    w212 = (w210 + (w158 * w205 + w80 * w208)) / w58 - w139 * w211
    w213 = (w44 * w100 + w37 * w103 - w42 * w49 - w43 * w105 - w75 * w205 + w53 * w209) / w36
    w214 = w213 / w36
    w215 = (w204 - (w153 * w205 + w75 * w208) + (w128 * w209 + w53 * w212)) / w36 - w116 * w214
    w216 = hinge0_angle_ddot * w215
    w217 = w15 * w216 * c1
    w218 = w6 * w216
    w219 = w216 * c23 - w218 * c0
    w220 = hinge0_angle_ddot * w212
    w221 = w220 * c22
    w222 = w6 * (w220 * c4)
    w223 = hinge0_angle_ddot * w205
    w224 = w203 - (w5 * (w6 * w217 + w15 * w219) + w13 * (w221 - w222 * bar2_end_y) + w222 * bar1_end_x) + w208 * w223 * c127
    w225 = w13 * hinge0_angle_ddot
    w226 = w225 - hinge0_angle_ddot * w209
    w227 = hinge0_angle_ddot * bar1_end_x
    w228 = w225 * bar2_end_y - w227
    w229 = w226 * c22 - w6 * w228 * c4
    w230 = hinge0_angle_ddot * w213
    w231 = w5 * hinge0_angle_ddot
    w232 = (w15 * w230 - w6 * w231) * c1
    w233 = w15 * w231 + w6 * w230
    w234 = w230 * c23 - w233 * c0
    w235 = w15 * w232 - w6 * w234 - w233 * c23 + w230 * c120
    w236 = w224 - (w212 * w229 - w209 * w221) + (w213 * (w15 * w217 - w6 * w219 - w218 * c23 + w216 * c120) + w215 * w235)
    w237 = w13 - w209
    w238 = w237 * c4
    w239 = bar1_end_x - w13 * bar2_end_y
    w240 = w237 * c22 + w6 * w239 * c4
    w241 = w226 * c4
    w242 = hinge0_angle_ddot * (w13 * c5 - c121 - w6 * w238 * bar2_end_y + w240) - (w6 * w241 * bar2_end_y - w229 + (w227 * c8 - w225 * c5))
    w243 = w6 * w213 + w5 * w15
    w244 = w243 * c0 - w213 * c23
    w245 = (w15 * w213 - w7) * c1
    w246 = w235 + hinge0_angle_ddot * (w213 * c120 + w6 * w244 - w243 * c23 + w15 * w245)
    w247 = w246 / w36
    w248 = w53 * w247 - (w229 + hinge0_angle_ddot * w240)
    w249 = w248 / w58
    w250 = w0 * w105
    w251 = w105 * c18 + w250 * c15
    w252 = w24 * w105
    w253 = w202 + hinge0_angle_ddot * (w105 * c20 + w0 * w251 + w250 * c18 + w24 * (w252 * c16)) + w66 * w249
    w254 = w223 * c21 + hinge0_angle_ddot * (w205 * c21) + w80 * w249 - w75 * w247
    w255 = w254 / w85
    w256 = w253 - w93 * w255 - w43 * w247
    w257 = w256 / w98
    w258 = w49 * w257
    w259 = w103 * w257
    w260 = w100 * w257
    w261 = (w194 * w258 - w195 * w256 + w192 * w259 - w182 * w260) / w189
    w262 = w185 * w261 - w259 / w98
    w263 = w187 * w261 - w258 / w98
    w264 = w184 * w261
    w265 = w260 / w98 + w183 * w261
    w266 = w92 * w263 - w105 * w255 - w90 * w262 - w88 * w264 - w86 * w265
    w267 = w262 + w90 * w266
    w268 = w89 * w266 - (w103 * w255 + w93 * w262)
    w269 = w49 * w255 + w93 * w263 + w91 * w266
    w270 = w87 * w266 - w93 * w264
    w271 = w100 * w255 - w93 * w265 + w67 * w266
    w272 = (w207 * w254 + w178 * w269 + w175 * w268 + w172 * w270 + w160 * w271) / w168
    w273 = w268 / w85 - w164 * w272
    w274 = w269 / w85 - w166 * w272
    w275 = w270 / w85 - w162 * w272
    w276 = w271 / w85 - w161 * w272
    w277 = w205 * w249 + w65 * w274 - w63 * w273 - w61 * w275 + w59 * w276
    w278 = w92 * w266 - w263
    w279 = w264 + w88 * w266
    w280 = w265 + w86 * w266
    w281 = w105 * w249 + w65 * w278 - w63 * w267 - w61 * w279 + w59 * w280
    w282 = w103 * w249 - w66 * w267 - w80 * w273 + w78 * w277 + w62 * w281
    w283 = w49 * w249 + w66 * w278 + w80 * w274 - w79 * w277 - w64 * w281
    w284 = w77 * w277 - (w66 * w279 + w80 * w275) + w60 * w281
    w285 = w100 * w249 + w80 * w276 - w76 * w277 + w66 * w280 + w45 * w281
    w286 = (w211 * w248 + w148 * w283 + w145 * w282 + w142 * w284 + w130 * w285) / w138
    w287 = w282 / w58 - w134 * w286
    w288 = w283 / w58 - w136 * w286
    w289 = w284 / w58 - w132 * w286
    w290 = w285 / w58 - w131 * w286
    w291 = w209 * w247 - w42 * w288 + w37 * w287 + w40 * w289 + w44 * w290
    w292 = w287 - w37 * w291
    w293 = w288 + w42 * w291
    w294 = w290 - w44 * w291
    w295 = w274 - w65 * w277
    w296 = w273 + w63 * w277
    w297 = w275 + w61 * w277
    w298 = w276 - w59 * w277
    w299 = w42 * w295 - w205 * w247 + w37 * w296 + w40 * w297 - w44 * w298
    w300 = w295 - w42 * w299
    w301 = w1 * w300
    w302 = w278 - w65 * w281
    w303 = w267 + w63 * w281
    w304 = w279 + w61 * w281
    w305 = w59 * w281 - w280
    w306 = w42 * w302 - w105 * w247 + w37 * w303 + w40 * w304 + w44 * w305
    w307 = w75 * w295 - w74 * w299 + w43 * w302 - w53 * w288 + w50 * w291 - w41 * w306 - w49 * w247
    w308 = w75 * w297 - w70 * w299 + w43 * w304 + w53 * w289 - w51 * w291 - w39 * w306
    w309 = w75 * w296 + w71 * w299 + w43 * w303 + w53 * w287 - w52 * w291 + w3 * w306 + w103 * w247
    w310 = w68 * w299 - w75 * w298 + w53 * w290 - w46 * w291 + w43 * w305 + w100 * w247
    w311 = (w214 * w246 + w118 * w308 + w120 * w307 + w106 * w309 + w123 * w310) / w115
    w312 = w307 / w36 - w113 * w311
    w313 = w11 * w312 - w23 * w293
    w314 = w301 - w313
    w315 = w302 - w42 * w306
    w316 = w31 * w293 + w4 * w312
    w317 = w315 - w316
    w318 = w308 / w36 - w107 * w311
    w319 = w59 * w249 + w86 * w255 + w99 * w257 + w44 * w247 - w4 * w318
    w320 = w289 - w40 * w291
    w321 = (w319 + (w31 * w320 + w13 * w294)) * bar3_end_z
    w322 = w242 + w16 * w292 + w49 * w293 + w20 * w294 + w0 * w314 + w28 * w317 + w4 * (w319 * bar2_end_y - w6 * w321)
    w323 = w63 * w249 - w90 * w255 - w101 * w257 + w37 * w247 + w11 * w318
    w324 = (w13 * w292 + w23 * w320 + w323) * bar3_end_z
    w325 = w65 * w249 + w92 * w255 - w104 * w257 + w13 * w293 - w42 * w247
    w326 = w27 * w300
    w327 = w325 - w326
    w328 = w313 - w301
    w329 = w231 * c6 - (w6 * w232 + w15 * w234) + w11 * (w8 * w292 + w20 * w320 + w30 * w293 + w28 * w327 + w25 * w328)
    w330 = w326 - w325
    w331 = w316 - w315
    w332 = w4 * (w309 / w36 - w112 * w311) + w11 * (w310 / w36 - w111 * w311)
    w333 = (w31 * w292 - w23 * w294 - w332) * bar3_end_z
    w334 = w329 + w4 * (w16 * w320 - w34 * w293 - w8 * w294 + w0 * w330 + w25 * w331) + w6 * w333 + w332 * bar2_end_y
    w335 = w5 * (w322 + w11 * (w6 * w324 - w323 * bar2_end_y)) - w13 * (w334 + hinge0_angle_ddot * (w15 * w244 - w6 * w245 + w5 * c6))
    w336 = w239 * w241 - (w213 * w234 + w228 * w238) + w230 * w244 - w5 * w232 - w231 * w245 - w19 * w321 + w14 * w324
    w337 = w15 * (w336 + w5 * w333) - w6 * (w213 * w232 - w5 * w234 + w231 * w244 + w230 * w245 + w11 * w321 + w4 * w324)
    w338 = w298 + w44 * w299
    w339 = w304 - w40 * w306
    w340 = (w27 * w338 - w339) * bar4_end_x
    w341 = w37 * w306 - w303
    w342 = (w1 * w338 + w341) * bar4_end_x
    w343 = w37 * w299 - w296
    w344 = w297 - w40 * w299
    w345 = w31 * w327 + w13 * w317
    w346 = w31 * w328 + w23 * w331
    w347 = hinge0_angle_ddot * (w105 * w252) * c128 + (w27 * w343 + w1 * w344) * bar4_end_x + w27 * w345 + w1 * w346
    w348 = w205 * (w24 * (w105 * w201 + w199 * w251 + w27 * w340 + w1 * w342 + w23 * w330 + w13 * w314) - w0 * w347)
    w349 = w1 * (w72 * w300 + w69 * w343 + w38 * w338 + w0 * w340 + w339 * bar5_end_y + w24 * w345) - w27 * (w73 * w300 + w69 * w344 + w2 * w338 - w341 * bar5_end_y + w0 * w342 + w24 * w346)
    # outputs
    dMa_dq_i = ca.vertcat(w236 + (w213 * w335 - w209 * w337 + w348 + w105 * w349))
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [ca.densify(dMa_dq_i)]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 48) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    165 operations.
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
    "dMa_dq_i": dMa_dq_i,
    "geometry": geometry,
}
