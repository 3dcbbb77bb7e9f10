"""Bricard mechanism: equations of motion, emitted by symgen from the scene `bricard`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 485 operations."""
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
    w0 = (bar1_inertia_xx + bar1_inertia_yy + bar1_inertia_zz) / 2.0
    w1 = w0 - bar1_inertia_yy
    w2 = w0 - bar1_inertia_zz
    w3 = w1 + w2
    w4 = w0 - bar1_inertia_xx + bar1_mass * bar1_center_of_mass_x**2
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = bar2_mass * bar2_center_of_mass_y
    w8 = bar2_end_quaternion_1_0_0 * bar3_start_quaternion_1_0_0
    w9 = bar2_end_quaternion_3_0_0 * bar3_start_quaternion_3_0_0
    w10 = w8 + w9
    w11 = bar3_mass * bar3_center_of_mass_z
    w12 = bar3_start_quaternion_1_0_0 * bar2_end_quaternion_3_0_0
    w13 = bar2_end_quaternion_1_0_0 * bar3_start_quaternion_3_0_0
    w14 = (bar2_inertia_xx + bar2_inertia_yy + bar2_inertia_zz) / 2.0
    w15 = w14 - bar2_inertia_yy + bar2_mass * bar2_center_of_mass_y**2
    w16 = w14 - bar2_inertia_zz
    w17 = w15 + w16
    w18 = w14 - bar2_inertia_xx
    w19 = w16 + w18
    w20 = w15 + w18
    w21 = (bar3_inertia_xx + bar3_inertia_yy + bar3_inertia_zz) / 2.0
    w22 = w21 - bar3_inertia_yy
    w23 = w21 - bar3_inertia_zz + bar3_mass * bar3_center_of_mass_z**2
    w24 = w22 + w23
    w25 = w21 - bar3_inertia_xx
    w26 = w23 + w25
    w27 = w22 + w25
    w28 = -4.0 * w27
    w29 = -4.0 * w26
    w30 = -4.0 * w19
    w31 = bar1_start_quaternion_0_0_0 * ground_P0_quaternion_1_0_0
    w32 = ground_P0_quaternion_0_0_0 * bar1_start_quaternion_1_0_0
    w33 = w31 + w32
    w34 = 4.0 * w5
    w35 = -4.0 * w20
    w36 = 4.0 * w6
    w37 = -4.0 * w3
    w38 = -4.0 * w5
    w39 = bar1_start_quaternion_0_0_0 * ground_P0_quaternion_0_0_0
    w40 = ground_P0_quaternion_1_0_0 * bar1_start_quaternion_1_0_0
    w41 = w39 + w40
    w42 = -4.0 * w6
    w43 = ground_P5_quaternion_3_0_0 * bar5_end_quaternion_1_0_0
    w44 = ground_P5_quaternion_1_0_0 * bar5_end_quaternion_3_0_0
    w45 = w43 + w44
    w46 = bar5_end_quaternion_1_0_0 * ground_P5_quaternion_1_0_0
    w47 = ground_P5_quaternion_3_0_0 * bar5_end_quaternion_3_0_0
    w48 = w46 + w47
    w49 = (bar5_inertia_xx + bar5_inertia_yy + bar5_inertia_zz) / 2.0
    w50 = w49 - bar5_inertia_yy + bar5_mass * bar5_center_of_mass_y**2
    w51 = w49 - bar5_inertia_zz
    w52 = w50 + w51
    w53 = w49 - bar5_inertia_xx
    w54 = w51 + w53
    w55 = w50 + w53
    w56 = (bar4_inertia_xx + bar4_inertia_yy + bar4_inertia_zz) / 2.0
    w57 = w56 - bar4_inertia_yy
    w58 = w56 - bar4_inertia_zz
    w59 = w57 + w58
    w60 = w56 - bar4_inertia_xx + bar4_mass * bar4_center_of_mass_x**2
    w61 = w58 + w60
    w62 = w57 + w60
    w63 = bar4_mass * bar4_center_of_mass_x
    w64 = -4.0 * w61
    w65 = bar5_mass * bar5_center_of_mass_y
    w66 = -4.0 * w55
    w67 = -4.0 * w62
    w68 = -4.0 * w54
    w69 = w41**2
    w70 = w48 * w52
    w71 = w48 * w54
    w72 = w48 * w55
    w73 = w48**2
    c = ca.vertcat(
        bar1_start_quaternion_0_0_0,
        ground_P0_quaternion_0_0_0,
        ground_P0_quaternion_1_0_0,
        bar1_start_quaternion_1_0_0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        bar1_end_x,
        bar2_mass,
        bar3_mass,
        bar2_mass + bar3_mass,
        w7,
        bar2_end_y,
        bar2_end_quaternion_1_0_0,
        bar3_start_quaternion_1_0_0,
        bar2_end_quaternion_3_0_0,
        bar3_start_quaternion_3_0_0,
        w10,
        w11,
        w12 + w13,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
        w22,
        w23,
        w24,
        w25,
        w26,
        w27,
        4.0 * w26 + w28,
        4.0 * w27 + -4.0 * w24,
        4.0 * w24 + w29,
        4.0 * w24 + w29,
        4.0 * w27 + -4.0 * w24,
        w28 + 4.0 * w26,
        4.0 * w17 + w30,
        w33,
        w34 + -4.0 * w6,
        4.0 * w19 + w35,
        4.0 * w20 + -4.0 * w17,
        4.0 * w20 + -4.0 * w17,
        4.0 * w19 + w35,
        w30 + 4.0 * w17,
        w36 + w37,
        4.0 * w3 + w38,
        w41,
        4.0 * w3 + w38,
        w37 + 4.0 * w6,
        4.0 * w5 + w42,
        bar4_end_x,
        bar5_end_y,
        ground_P5_quaternion_3_0_0,
        bar5_end_quaternion_1_0_0,
        ground_P5_quaternion_1_0_0,
        bar5_end_quaternion_3_0_0,
        w45,
        w48,
        bar3_end_z,
        bar5_mass,
        w50,
        w51,
        w52,
        w53,
        w54,
        w55,
        w57,
        w58,
        w59,
        bar4_mass,
        w60,
        w61,
        w62,
        w63,
        4.0 * w59 + w64,
        w65,
        bar5_mass + bar4_mass,
        4.0 * w54 + w66,
        4.0 * w61 + w67,
        4.0 * w62 + -4.0 * w59,
        4.0 * w62 + -4.0 * w59,
        w67 + 4.0 * w61,
        w64 + 4.0 * w59,
        4.0 * w55 + -4.0 * w52,
        4.0 * w52 + w68,
        4.0 * w52 + w68,
        4.0 * w55 + -4.0 * w52,
        w66 + 4.0 * w54,
        bar1_mass * bar1_center_of_mass_x,
        gravity_y,
        bar2_mass * gravity_y,
        bar3_mass * gravity_y,
        bar4_mass * gravity_y,
        bar5_mass * gravity_y,
        ground_P5_z,
        -w41,
        -w48,
        bar1_mass,
        w36 + -4.0 * w3,
        w34 + w42,
        bar1_mass * gravity_y,
        -w10,
        4.0 * bar3_end_z,
        0.5 * w39 + 0.5 * w40,
        0.5 * w31 + 0.5 * w32,
        0.25 * w31 + 0.25 * w32,
        0.25 * w39 + 0.25 * w40,
        -2.0 * (w3 * w69) + -2.0 * (w41 * (w3 * w41)),
        -2.0 * (w5 * w69) + -2.0 * (w41 * (w5 * w41)),
        -2.0 * (w6 * w69) + -2.0 * (w41 * (w6 * w41)),
        -4.0 * w17,
        -4.0 * w19,
        -4.0 * w20,
        -4.0 * w24,
        -4.0 * w26,
        -4.0 * w27,
        -4.0 * w61,
        -4.0 * w70,
        -4.0 * w71,
        -4.0 * w72,
        4.0 * bar1_end_x,
        4.0 * bar2_end_y,
        4.0 * bar4_end_x,
        4.0 * bar5_end_y,
        0.5 * w12 + 0.5 * w13,
        0.5 * w8 + 0.5 * w9,
        0.25 * w8 + 0.25 * w9,
        0.25 * w12 + 0.25 * w13,
        0.25 * w43 + 0.25 * w44,
        0.25 * w46 + 0.25 * w47,
        2 * w7,
        2.0,
        2 * w41,
        2 * w48,
        2 * w45,
        2 * w33,
        0.5 * w43 + 0.5 * w44,
        0.5 * w46 + 0.5 * w47,
        2 * w11,
        2 * w63,
        2 * w65,
        2 * (w33 * w41),
        -(2 * bar1_end_x),
        -4.0 * w59,
        -4.0 * w62,
        2 * (w45 * w48),
        -2.0 * (w52 * w73) + -2.0 * (w48 * w70),
        -2.0 * (w54 * w73) + -2.0 * (w48 * w71),
        -2.0 * (w55 * w73) + -2.0 * (w48 * w72),
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 5082 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    bar3_e0_dot = q_d_dot[17]
    bar3_e1_dot = q_d_dot[18]
    bar3_e2_dot = q_d_dot[19]
    bar3_e3_dot = q_d_dot[20]
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
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
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
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
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = w2 * c1 * c0 - w2 * c2 * c3
    w4 = bar1_e2 * -2.0
    w5 = w4 * c6
    w6 = 2 * bar1_e1
    w7 = w6 * c8
    w8 = 2 * bar1_e0
    w9 = w8 * c9
    w10 = w4 * w5 + w6 * w7 + w8 * w9
    w11 = 2 * bar1_e2
    w12 = (w8 * bar1_e3 + bar1_e2 * w6) * c10
    w13 = bar1_e1 * -2.0
    w14 = 1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2
    w15 = w14 * c10
    w16 = w11 * w12 - w13 * w15
    w17 = w16 * c13
    w18 = w8 * w15
    w19 = w6 * bar1_e3 - bar1_e2 * w8
    w20 = w19 * c10
    w21 = w18 - w11 * w20
    w22 = w21 * c13
    w23 = w13 * w20
    w24 = w8 * w12
    w25 = w23 - w24
    w26 = w25 * c13
    w27 = hinge1_angle / 2.0
    w28 = ca.cos(w27)
    w29 = 2 * bar2_e2
    w30 = 1.0 - 2 * bar2_e1**2
    w31 = 2 * bar2_e3**2
    w32 = w30 - w31
    w33 = w32 * c14
    w34 = bar2_e1 * -2.0
    w35 = 2 * bar2_e1
    w36 = bar2_e2 * w35
    w37 = 2 * bar2_e0
    w38 = bar2_e3 * w37
    w39 = w36 - w38
    w40 = w39 * c14
    w41 = w29 * w33 - w34 * w40
    w42 = w32 * c15
    w43 = w39 * c15
    w44 = w29 * w42 - w34 * w43
    w45 = w44 * c12
    w46 = hinge2_angle / 2.0
    w47 = ca.cos(w46)
    w48 = w47 * c20
    w49 = 2 * bar3_e2
    w50 = w49 * bar3_e3
    w51 = 2 * bar3_e0
    w52 = w51 * bar3_e1
    w53 = w50 - w52
    w54 = w53 * c21
    w55 = bar3_e1 * -2.0
    w56 = bar3_e2 * w51
    w57 = 2 * bar3_e1
    w58 = bar3_e3 * w57
    w59 = w56 + w58
    w60 = w59 * c21
    w61 = w49 * w54 - w55 * w60
    w62 = ca.sin(w46)
    w63 = w62 * c22
    w64 = bar3_e3 * -2.0
    w65 = w54 * w64
    w66 = w51 * w60
    w67 = w65 - w66
    w68 = w47 * c16 * c19 - w47 * c18 * c17
    w69 = w51 * w54
    w70 = 2 * bar3_e3
    w71 = w69 - w60 * w70
    w72 = w62 * c18 * c19 - w62 * c16 * c17
    w73 = bar3_e2 * -2.0
    w74 = w60 * w73
    w75 = w54 * w55 - w74
    w76 = w41 + w45 + w48 * w61 + w63 * w67 - w68 * w71 - w72 * w75
    w77 = w37 * w40
    w78 = bar2_e1 * w37
    w79 = w29 * bar2_e3
    w80 = w78 + w79
    w81 = w80 * c14
    w82 = w77 - w29 * w81
    w83 = w37 * w43
    w84 = w80 * c15
    w85 = w83 - w29 * w84
    w86 = w85 * c12
    w87 = 1.0 - 2 * bar3_e1**2
    w88 = 2 * bar3_e2**2
    w89 = w87 - w88
    w90 = w89 * c21
    w91 = w66 - w49 * w90
    w92 = w57 * w60 - w64 * w90
    w93 = w51 * w90
    w94 = w74 - w93
    w95 = w55 * w90
    w96 = w60 * w64 - w95
    w97 = w82 + w86 + w48 * w91 + w63 * w92 - w68 * w94 - w72 * w96
    w98 = w34 * w81
    w99 = w33 * w37
    w100 = w98 - w99
    w101 = w34 * w84
    w102 = w37 * w42
    w103 = w101 - w102
    w104 = w103 * c12
    w105 = w95 - w69
    w106 = w93 - w54 * w57
    w107 = w70 * w90 - w54 * w73
    w108 = w73 * w90 - w65
    w109 = w100 + w104 + w48 * w105 + w63 * w106 - w68 * w107 - w72 * w108
    w110 = w16 * w76 + w21 * w97 + w25 * w109
    w111 = bar2_e2 * -2.0
    w112 = w111 * c25
    w113 = w35 * c27
    w114 = w37 * c28
    w115 = w111 * w112 + w35 * w113 + w37 * w114
    w116 = w44 * w61 + w85 * w91 + w103 * w105
    w117 = w73 * c31
    w118 = w57 * c33
    w119 = w51 * c34
    w120 = w73 * w117 + w57 * w118 + w51 * w119
    w121 = w116 + w48 * w120
    w122 = w70 * w117 + bar3_e0 * bar3_e1 * c35
    w123 = w44 * w67 + w85 * w92 + w103 * w106 + w48 * w122
    w124 = w51 * c33
    w125 = w55 * c34
    w126 = w70 * (w70 * c31) + w51 * w124 + w55 * w125
    w127 = w123 + w63 * w126
    w128 = w115 + w44 * w45 + w85 * w86 + w103 * w104 + (w48 * w121 + w48 * w116) + (w63 * w127 + w63 * w123)
    w129 = w64 * w118 + bar3_e2 * bar3_e0 * c36
    w130 = bar3_e3 * bar3_e0 * c37 + w49 * w125
    w131 = w44 * w71 + w85 * w94 + w103 * w107 + w48 * w129 + w63 * w130
    w132 = w51 * c31
    w133 = w51 * w132 + w64 * (w64 * c33) + w49 * (w49 * c34)
    w134 = w131 - w68 * w133
    w135 = bar3_e2 * bar3_e1 * c38 + w64 * w119
    w136 = w73 * w124 + bar3_e3 * bar3_e1 * c39
    w137 = w55 * w132 + bar3_e2 * bar3_e3 * c40
    w138 = w44 * w75 + w85 * w96 + w103 * w108 + w48 * w135 + w63 * w136 - w68 * w137
    w139 = w55 * (w55 * c31) + w73 * (w73 * c33) + w64 * (w64 * c34)
    w140 = w138 - w72 * w139
    w141 = w128 - (w68 * w134 + w68 * w131) - (w72 * w140 + w72 * w138)
    w142 = w110 + w28 * w141
    w143 = ca.sin(w27)
    w144 = w40 * w111
    w145 = w33 * w34 - w144
    w146 = w43 * w111
    w147 = w34 * w42 - w146
    w148 = w147 * c12
    w149 = w145 + w148 + w61 * w72 + w67 * w68 + w63 * w71 + w48 * w75
    w150 = bar2_e3 * -2.0
    w151 = w40 * w150 - w98
    w152 = w43 * w150 - w101
    w153 = w152 * c12
    w154 = w151 + w153 + w72 * w91 + w68 * w92 + w63 * w94 + w48 * w96
    w155 = w33 * w150
    w156 = w81 * w111 - w155
    w157 = w42 * w150
    w158 = w84 * w111 - w157
    w159 = w158 * c12
    w160 = w156 + w159 + w72 * w105 + w68 * w106 + w63 * w107 + w48 * w108
    w161 = bar2_e2 * bar2_e1 * c41 + w114 * w150
    w162 = w61 * w147 + w91 * w152 + w105 * w158
    w163 = w67 * w147 + w92 * w152 + w106 * w158 + w72 * w122
    w164 = w161 + w45 * w147 + w86 * w152 + w104 * w158 + (w72 * w121 + w48 * w162) + (w68 * w127 + w63 * w163)
    w165 = w71 * w147 + w94 * w152 + w107 * w158 + w72 * w129 + w68 * w130
    w166 = w75 * w147 + w96 * w152 + w108 * w158 + w72 * w135 + w68 * w136 + w63 * w137
    w167 = w164 + (w63 * w134 - w68 * w165) + (w48 * w140 - w72 * w166)
    w168 = w16 * w149 + w21 * w154 + w25 * w160 + w28 * w167
    w169 = w34 * (w34 * c25) + w111 * (w111 * c27) + w150 * (w150 * c28)
    w170 = w169 + w147 * w148 + w152 * w153 + w158 * w159 + (w72 * (w162 + w72 * w120) + w72 * w162) + (w68 * (w163 + w68 * w126) + w68 * w163)
    w171 = w170 + (w63 * (w165 + w63 * w133) + w63 * w165) + (w48 * (w166 + w48 * w139) + w48 * w166)
    w172 = w168 - w143 * w171
    w173 = w10 + w16 * w17 + w21 * w22 + w25 * w26 + (w28 * w142 + w28 * w110) - (w143 * w172 + w143 * w168)
    w174 = w2 * c42
    w175 = 2 * bar1_e3
    w176 = w5 * w175 + bar1_e1 * bar1_e0 * c43
    w177 = bar1_e3 * -2.0
    w178 = w12 * w177
    w179 = w178 - w18
    w180 = w6 * w15 - w20 * w177
    w181 = w8 * w20
    w182 = w181 - w6 * w12
    w183 = w76 * w179 + w97 * w180 + w109 * w182
    w184 = w155 - w77
    w185 = w157 - w83
    w186 = w185 * c12
    w187 = w184 + w186 - w61 * w63 + w48 * w67 + w71 * w72 - w68 * w75
    w188 = w35 * w40 - w81 * w150
    w189 = w35 * w43 - w84 * w150
    w190 = w189 * c12
    w191 = w188 + w190 - w63 * w91 + w48 * w92 + w72 * w94 - w68 * w96
    w192 = w37 * w81
    w193 = w192 - w33 * w35
    w194 = w37 * w84
    w195 = w194 - w35 * w42
    w196 = w195 * c12
    w197 = w193 + w196 - w63 * w105 + w48 * w106 + w72 * w107 - w68 * w108
    w198 = 2 * bar2_e3
    w199 = w112 * w198 + bar2_e1 * bar2_e0 * c44
    w200 = w61 * w185 + w91 * w189 + w105 * w195
    w201 = w67 * w185 + w92 * w189 + w106 * w195 - w63 * w122
    w202 = w199 + w45 * w185 + w86 * w189 + w104 * w195 + (w48 * w200 - w63 * w121) + (w48 * w127 + w63 * w201)
    w203 = w71 * w185 + w94 * w189 + w107 * w195 - w63 * w129 + w48 * w130
    w204 = w75 * w185 + w96 * w189 + w108 * w195 - w63 * w135 + w48 * w136 + w72 * w137
    w205 = w202 + (w72 * w134 - w68 * w203) - (w68 * w140 + w72 * w204)
    w206 = w16 * w187 + w21 * w191 + w25 * w197 + w28 * w205
    w207 = w99 - w40 * w198
    w208 = w102 - w43 * w198
    w209 = w208 * c12
    w210 = w207 + w209 + w61 * w68 - w67 * w72 + w48 * w71 - w63 * w75
    w211 = w144 - w192
    w212 = w146 - w194
    w213 = w212 * c12
    w214 = w211 + w213 + w68 * w91 - w72 * w92 + w48 * w94 - w63 * w96
    w215 = w81 * w198 - w33 * w111
    w216 = w84 * w198 - w42 * w111
    w217 = w216 * c12
    w218 = w215 + w217 + w68 * w105 - w72 * w106 + w48 * w107 - w63 * w108
    w219 = w113 * w150 + bar2_e2 * bar2_e0 * c45
    w220 = w61 * w208 + w91 * w212 + w105 * w216
    w221 = w67 * w208 + w92 * w212 + w106 * w216 + w68 * w122
    w222 = w219 + w45 * w208 + w86 * w212 + w104 * w216 + (w68 * w121 + w48 * w220) + (w63 * w221 - w72 * w127)
    w223 = w71 * w208 + w94 * w212 + w107 * w216 + w68 * w129 - w72 * w130
    w224 = w75 * w208 + w96 * w212 + w108 * w216 + w68 * w135 - w72 * w136 + w48 * w137
    w225 = w222 + (w48 * w134 - w68 * w223) - (w63 * w140 + w72 * w224)
    w226 = w16 * w210 + w21 * w214 + w25 * w218 + w28 * w225
    w227 = w37 * c27
    w228 = w34 * c28
    w229 = w111 * w227 + bar2_e1 * bar2_e3 * c46
    w230 = w200 - w63 * w120
    w231 = w201 + w48 * w126
    w232 = w229 + w147 * w186 + w152 * w190 + w158 * w196 + (w72 * w230 - w63 * w162) + (w68 * w231 + w48 * w163)
    w233 = w203 + w72 * w133
    w234 = w204 - w68 * w139
    w235 = w232 + (w63 * w233 + w72 * w165) + (w48 * w234 - w68 * w166)
    w236 = w37 * c25
    w237 = w34 * w236 + bar2_e2 * bar2_e3 * c47
    w238 = w220 + w68 * w120
    w239 = w221 - w72 * w126
    w240 = w237 + w147 * w209 + w152 * w213 + w158 * w217 + (w72 * w238 + w68 * w162) + (w68 * w239 - w72 * w163)
    w241 = w223 + w48 * w133
    w242 = w224 - w63 * w139
    w243 = w240 + (w63 * w241 + w48 * w165) + (w48 * w242 - w63 * w166)
    w244 = w149 * w179 + w154 * w180 + w160 * w182 + w28 * w235 + w143 * w243
    w245 = w176 + w17 * w179 + w22 * w180 + w26 * w182 + w28 * w183 + w28 * w206 + w143 * w226 - w143 * w244
    w246 = w3 * w245
    w247 = w8 * c8
    w248 = w13 * c9
    w249 = w175 * (w175 * c6) + w8 * w247 + w13 * w248
    w250 = w179 * c13
    w251 = w180 * c13
    w252 = w182 * c13
    w253 = w179 * w187 + w180 * w191 + w182 * w197
    w254 = w198 * (w198 * c25) + w37 * w227 + w34 * w228
    w255 = w254 + w185 * w186 + w189 * w190 + w195 * w196 - (w63 * w230 + w63 * w200) + (w48 * w231 + w48 * w201)
    w256 = w255 + (w72 * w233 + w72 * w203) - (w68 * w234 + w68 * w204)
    w257 = w253 + w28 * w256
    w258 = bar2_e3 * bar2_e0 * c48 + w29 * w228
    w259 = w258 + w186 * w208 + w190 * w212 + w196 * w216 + (w68 * w230 - w63 * w220) + (w48 * w221 - w72 * w231)
    w260 = w259 + (w48 * w233 + w72 * w223) - (w63 * w234 + w68 * w224)
    w261 = w179 * w210 + w180 * w214 + w182 * w218 + w28 * w260
    w262 = w37 * w236 + w150 * (w150 * c27) + w29 * (w29 * c28)
    w263 = w262 + w208 * w209 + w212 * w213 + w216 * w217 + (w68 * w238 + w68 * w220) - (w72 * w239 + w72 * w221)
    w264 = w263 + (w48 * w241 + w48 * w223) - (w63 * w242 + w63 * w224)
    w265 = w261 + w143 * w264
    w266 = w249 + w179 * w250 + w180 * w251 + w182 * w252 + (w28 * w257 + w28 * w253) + (w143 * w265 + w143 * w261)
    w267 = ca.sin(w0)
    w268 = w267 / 2.0
    w269 = w268 * c1 * c3 - w268 * c2 * c0
    w270 = w7 * w177 + bar1_e2 * bar1_e0 * c49
    w271 = w24 - w15 * w175
    w272 = w4 * w15
    w273 = w272 - w181
    w274 = w20 * w175 - w4 * w12
    w275 = w76 * w271 + w97 * w273 + w109 * w274
    w276 = w149 * w271 + w154 * w273 + w160 * w274 - w143 * w235 + w28 * w243
    w277 = w270 + w17 * w271 + w22 * w273 + w26 * w274 + w28 * w275 - w143 * w206 + w28 * w226 - w143 * w276
    w278 = bar1_e0 * bar1_e3 * c50 + w11 * w248
    w279 = w187 * w271 + w191 * w273 + w197 * w274
    w280 = w210 * w271 + w214 * w273 + w218 * w274 - w143 * w260
    w281 = w278 + w250 * w271 + w251 * w273 + w252 * w274 + (w28 * w279 - w143 * w257) + (w28 * w265 + w143 * w280)
    w282 = w3 * w277 - w174 * w281
    w283 = w8 * c6
    w284 = w8 * w283 + w177 * (w177 * c8) + w11 * (w11 * c9)
    w285 = w271 * c13
    w286 = w273 * c13
    w287 = w274 * c13
    w288 = w284 + w271 * w285 + w273 * w286 + w274 * w287 - (w143 * (w279 - w143 * w256) + w143 * w279) + (w28 * (w280 + w28 * w264) + w28 * w280)
    w289 = w3 * (w3 * w173) - (w174 * (w246 - w174 * w266) + w174 * w246) + (w269 * (w282 + w269 * w288) + w269 * w282)
    w290 = w268 * c51
    w291 = bar1_e2 * bar1_e1 * c52 + w9 * w177
    w292 = w12 * w13 - w272
    w293 = w15 * w177 - w23
    w294 = w4 * w20 - w178
    w295 = w76 * w292 + w97 * w293 + w109 * w294
    w296 = w149 * w292 + w154 * w293 + w160 * w294 + w143 * w167
    w297 = w291 + w17 * w292 + w22 * w293 + w26 * w294 + (w142 * w143 + w28 * w295) + (w28 * w172 - w143 * w296)
    w298 = w4 * w247 + bar1_e1 * bar1_e3 * c53
    w299 = w187 * w292 + w191 * w293 + w197 * w294 + w143 * w205
    w300 = w210 * w292 + w214 * w293 + w218 * w294 + w143 * w225
    w301 = w298 + w250 * w292 + w251 * w293 + w252 * w294 + w143 * w183 + w28 * w299 + w143 * w300 + w28 * w244
    w302 = w13 * w283 + bar1_e2 * bar1_e3 * c54
    w303 = w302 + w285 * w292 + w286 * w293 + w287 * w294 + w143 * w275 - w143 * w299 + w28 * w300 + w28 * w276
    w304 = w3 * w297 - w174 * w301 + w269 * w303
    w305 = w13 * (w13 * c6) + w4 * (w4 * c8) + w177 * (w177 * c9)
    w306 = w305 + w292 * (w292 * c13) + w293 * (w293 * c13) + w294 * (w294 * c13) + (w143 * (w295 + w141 * w143) + w143 * w295)
    w307 = 2 * bar4_e3
    w308 = 2 * bar4_e1
    w309 = bar4_e3 * w308
    w310 = 2 * bar4_e0
    w311 = w310 * bar4_e2
    w312 = w309 - w311
    w313 = w312 * c55
    w314 = bar4_e2 * -2.0
    w315 = bar4_e3 * w310
    w316 = w308 * bar4_e2
    w317 = w315 + w316
    w318 = w317 * c55
    w319 = w307 * w313 - w314 * w318
    w320 = hinge4_angle / 2.0
    w321 = ca.sin(w320)
    w322 = w310 * w313
    w323 = w322 - w308 * w318
    w324 = ca.cos(w320)
    w325 = 2 * bar5_e0
    w326 = w325 * bar5_e1
    w327 = 2 * bar5_e2
    w328 = w327 * bar5_e3
    w329 = w326 + w328
    w330 = w329 * c56
    w331 = w325 * w330
    w332 = 2 * bar5_e1
    w333 = 1.0 - 2 * bar5_e1**2
    w334 = 2 * bar5_e3**2
    w335 = w333 - w334
    w336 = w335 * c56
    w337 = w331 - w332 * w336
    w338 = w319 * w321 - w323 * w324 - w337
    w339 = hinge5_angle / 2.0
    w340 = ca.sin(w339)
    w341 = w340 / 2.0
    w342 = w341 * c57 * c58 - w341 * c59 * c60
    w343 = bar4_e1 * -2.0
    w344 = w313 * w343
    w345 = w310 * w318
    w346 = w344 - w345
    w347 = bar4_e3 * -2.0
    w348 = w318 * w347
    w349 = w313 * w314 - w348
    w350 = bar5_e1 * -2.0
    w351 = w330 * w350
    w352 = w325 * w336
    w353 = w351 - w352
    w354 = w324 * w346 + w321 * w349 + w353
    w355 = ca.cos(w339)
    w356 = w355 / 2.0
    w357 = w356 * c59 * c58 - w356 * c57 * c60
    w358 = 2 * bar5_e3
    w359 = bar5_e2 * -2.0
    w360 = w330 * w358 - w336 * w359
    w361 = w321 * w323 + w319 * w324 + w360
    w362 = w356 * c61
    w363 = bar5_e3 * -2.0
    w364 = w336 * w363
    w365 = w330 * w359 - w364
    w366 = w321 * w346 - w324 * w349 - w365
    w367 = w341 * c62
    w368 = w338 * w342 - w354 * w357 + w361 * w362 - w366 * w367
    w369 = w89 * c63
    w370 = w53 * c63
    w371 = w70 * w369 - w73 * w370
    w372 = w55 * w369
    w373 = w51 * w370
    w374 = w372 - w373
    w375 = w51 * w369
    w376 = w375 - w57 * w370
    w377 = w64 * w370
    w378 = w73 * w369 - w377
    w379 = w68 * w371 - (w103 + w48 * w374 + w63 * w376) + w72 * w378
    w380 = w28 / 2.0
    w381 = w143 / 2.0
    w382 = bar1_e0 * w380 - bar1_e3 * w381
    w383 = w63 * w374 - w195 - w48 * w376 - w72 * w371 + w68 * w378
    w384 = bar1_e2 * w381 + bar1_e1 * w380
    w385 = w72 * w376 - (w216 + w68 * w374) - w48 * w371 + w63 * w378
    w386 = bar1_e2 * w380 - bar1_e1 * w381
    w387 = w158 + w72 * w374 + w68 * w376 + w63 * w371 + w48 * w378
    w388 = bar1_e0 * w381 + bar1_e3 * w380
    w389 = w379 * w382 - w383 * w384 + w385 * w386 + w387 * w388
    w390 = w59 * c63
    w391 = w73 * w390
    w392 = w391 - w375
    w393 = w51 * w390
    w394 = w393 - w49 * w369
    w395 = w57 * w390 - w64 * w369
    w396 = w64 * w390 - w372
    w397 = w68 * w392 - (w85 + w48 * w394 + w63 * w395) + w72 * w396
    w398 = w63 * w394 - w189 - w48 * w395 - w72 * w392 + w68 * w396
    w399 = w72 * w395 - (w212 + w68 * w394) - w48 * w392 + w63 * w396
    w400 = w152 + w72 * w394 + w68 * w395 + w63 * w392 + w48 * w396
    w401 = w382 * w397 - w384 * w398 + w386 * w399 + w388 * w400
    w402 = w373 - w70 * w390
    w403 = w49 * w370 - w55 * w390
    w404 = w377 - w393
    w405 = w55 * w370 - w391
    w406 = w68 * w402 - (w44 + w48 * w403 + w63 * w404) + w72 * w405
    w407 = w63 * w403 - w185 - w48 * w404 - w72 * w402 + w68 * w405
    w408 = w72 * w404 - (w208 + w68 * w403) - w48 * w402 + w63 * w405
    w409 = w147 + w72 * w403 + w68 * w404 + w63 * w402 + w48 * w405
    w410 = w382 * w406 - w384 * w407 + w386 * w408 + w388 * w409
    w411 = bar3_e3 * w51
    w412 = bar3_e2 * w57
    w413 = w411 + w412
    w414 = bar4_e1 * w310
    w415 = 2 * bar4_e2
    w416 = bar4_e3 * w415
    w417 = w414 + w416
    w418 = w413 * w417
    w419 = w58 - w56
    w420 = 1.0 - 2 * bar4_e1**2
    w421 = 2 * bar4_e3**2
    w422 = w420 - w421
    w423 = w419 * w422
    w424 = w418 - w423
    w425 = w316 - w315
    w426 = w419 * w425
    w427 = 2 * bar3_e3**2
    w428 = 1.0 - w88 - w427
    w429 = w417 * w428
    w430 = w426 - w429
    w431 = w422 * w428
    w432 = w413 * w425
    w433 = w431 - w432
    w434 = w49 * w424 + w55 * w430 + w51 * w433
    w435 = w64 * w424 + w51 * w430 + w57 * w433
    w436 = w51 * w424 + w70 * w430 + w73 * w433
    w437 = w55 * w424 + w73 * w430 + w64 * w433
    w438 = w48 * w434 + w63 * w435 - w68 * w436 - w72 * w437
    w439 = w48 * w435 - w63 * w434 + w72 * w436 - w68 * w437
    w440 = w68 * w434 - w72 * w435 + w48 * w436 - w63 * w437
    w441 = w72 * w434 + w68 * w435 + w63 * w436 + w48 * w437
    w442 = w382 * w438 - w384 * w439 + w386 * w440 - w388 * w441
    w443 = ca.sqrt(w389**2 + w401**2 + w410**2 + w442**2)
    w444 = w389 / w443
    w445 = 2 * bar4_e2**2
    w446 = 1.0 - w445 - w421
    w447 = w446 * c55
    w448 = w314 * w447
    w449 = w448 - w322
    w450 = w308 * w447 - w313 * w347
    w451 = bar5_e2 * w332
    w452 = w325 * bar5_e3
    w453 = w451 - w452
    w454 = w453 * c56
    w455 = w332 * w454 - w330 * w363
    w456 = w321 * w449 - w324 * w450 - w455
    w457 = w310 * w447
    w458 = w457 - w313 * w415
    w459 = w347 * w447 - w344
    w460 = w325 * w454
    w461 = w460 - w327 * w330
    w462 = w324 * w458 + w321 * w459 + w461
    w463 = w359 * w454
    w464 = w463 - w331
    w465 = w321 * w450 + w324 * w449 + w464
    w466 = w363 * w454 - w351
    w467 = w321 * w458 - w324 * w459 - w466
    w468 = w342 * w456 - w357 * w462 + w362 * w465 - w367 * w467
    w469 = w401 / w443
    w470 = w345 - w307 * w447
    w471 = w348 - w457
    w472 = w364 - w460
    w473 = w321 * w470 - w324 * w471 - w472
    w474 = w318 * w415 - w343 * w447
    w475 = w318 * w343 - w448
    w476 = w327 * w336 - w350 * w454
    w477 = w324 * w474 + w321 * w475 + w476
    w478 = w352 - w358 * w454
    w479 = w321 * w471 + w324 * w470 + w478
    w480 = w336 * w350 - w463
    w481 = w321 * w474 - w324 * w475 - w480
    w482 = w342 * w473 - w357 * w477 + w362 * w479 - w367 * w481
    w483 = w410 / w443
    w484 = w423 - w418
    w485 = w429 - w426
    w486 = w432 - w431
    w487 = w415 * w484 + w343 * w485 + w310 * w486
    w488 = w343 * w484 + w314 * w485 + w347 * w486
    w489 = w324 * w487 + w321 * w488
    w490 = w347 * w484 + w310 * w485 + w308 * w486
    w491 = w310 * w484 + w307 * w485 + w314 * w486
    w492 = w324 * w490 - w321 * w491
    w493 = w321 * w490 + w324 * w491
    w494 = w324 * w488 - w321 * w487
    w495 = w357 * w489 + w342 * w492 - w362 * w493 - w367 * w494
    w496 = w442 / w443
    w497 = w368 * w444 + w468 * w469 + w482 * w483 + w495 * w496
    w498 = w368 - w444 * w497
    w499 = w62 / 2.0
    w500 = w499 * c20
    w501 = w47 / 2.0
    w502 = w501 * c22
    w503 = w499 * c18 * c17 - w499 * c16 * c19
    w504 = w501 * c18 * c19 - w501 * c16 * c17
    w505 = bar2_e0 * w500 + (bar2_e1 * w502 + bar2_e2 * w503 + bar2_e3 * w504)
    w506 = bar2_e0 * w504 - bar2_e3 * w500 + (bar2_e1 * w503 - bar2_e2 * w502)
    w507 = bar2_e0 * w503 - bar2_e2 * w500 + (bar2_e3 * w502 - bar2_e1 * w504)
    w508 = bar2_e0 * w502 - bar2_e1 * w500 + (bar2_e2 * w504 - bar2_e3 * w503)
    w509 = w378 * w505 - (w374 * w506 + w376 * w507 + w371 * w508)
    w510 = w396 * w505 - (w394 * w506 + w395 * w507 + w392 * w508)
    w511 = w405 * w505 - (w403 * w506 + w404 * w507 + w402 * w508)
    w512 = w434 * w506 + w435 * w507 + w436 * w508 - w437 * w505
    w513 = w444 * w509 + w469 * w510 + w483 * w511 + w496 * w512
    w514 = w509 - w444 * w513
    w515 = w510 - w469 * w513
    w516 = w511 - w483 * w513
    w517 = w512 - w496 * w513
    w518 = ca.sqrt(w514**2 + w515**2 + w516**2 + w517**2)
    w519 = w514 / w518
    w520 = w468 - w469 * w497
    w521 = w515 / w518
    w522 = w482 - w483 * w497
    w523 = w516 / w518
    w524 = w495 - w496 * w497
    w525 = w517 / w518
    w526 = w498 * w519 + w520 * w521 + w522 * w523 + w524 * w525
    w527 = w498 - w519 * w526
    w528 = w324 / 2.0
    w529 = w321 / 2.0
    w530 = bar5_e0 * w528 + bar5_e3 * w529
    w531 = bar5_e1 * w528 - bar5_e2 * w529
    w532 = bar5_e1 * w529 + bar5_e2 * w528
    w533 = bar5_e3 * w528 - bar5_e0 * w529
    w534 = w346 * w530 - w323 * w531 + w319 * w532 - w349 * w533
    w535 = w458 * w530 - w450 * w531 + w449 * w532 - w459 * w533
    w536 = w474 * w530 - w471 * w531 + w470 * w532 - w475 * w533
    w537 = w490 * w531 - w487 * w530 - w491 * w532 + w488 * w533
    w538 = w444 * w534 + w469 * w535 + w483 * w536 + w496 * w537
    w539 = w534 - w444 * w538
    w540 = w535 - w469 * w538
    w541 = w536 - w483 * w538
    w542 = w537 - w496 * w538
    w543 = w519 * w539 + w521 * w540 + w523 * w541 + w525 * w542
    w544 = w539 - w519 * w543
    w545 = w540 - w521 * w543
    w546 = w541 - w523 * w543
    w547 = w542 - w525 * w543
    w548 = ca.sqrt(w544**2 + w545**2 + w546**2 + w547**2)
    w549 = w544 / w548
    w550 = w520 - w521 * w526
    w551 = w545 / w548
    w552 = w522 - w523 * w526
    w553 = w546 / w548
    w554 = w524 - w525 * w526
    w555 = w547 / w548
    w556 = w527 * w549 + w550 * w551 + w552 * w553 + w554 * w555
    w557 = w527 - w549 * w556
    w558 = w550 - w551 * w556
    w559 = w552 - w553 * w556
    w560 = w554 - w555 * w556
    w561 = ca.sqrt(w557**2 + w558**2 + w559**2 + w560**2)
    w562 = w557 / w561
    w563 = w28 * w379 - w25 + w143 * w387
    w564 = w28 * w383 - w182 + w143 * w385
    w565 = w28 * w385 - (w274 + w143 * w383)
    w566 = w143 * w379 - w294 - w28 * w387
    w567 = w3 * w563 - w174 * w564 + w269 * w565 - w290 * w566
    w568 = w558 / w561
    w569 = w28 * w397 - w21 + w143 * w400
    w570 = w28 * w398 - w180 + w143 * w399
    w571 = w28 * w399 - (w273 + w143 * w398)
    w572 = w143 * w397 - w293 - w28 * w400
    w573 = w3 * w569 - w174 * w570 + w269 * w571 - w290 * w572
    w574 = w559 / w561
    w575 = w28 * w406 - w16 + w143 * w409
    w576 = w28 * w407 - w179 + w143 * w408
    w577 = w28 * w408 - (w271 + w143 * w407)
    w578 = w143 * w406 - w292 - w28 * w409
    w579 = w3 * w575 - w174 * w576 + w269 * w577 - w290 * w578
    w580 = w560 / w561
    w581 = w28 * w438 - w143 * w441
    w582 = w28 * w439 + w143 * w440
    w583 = w28 * w440 - w143 * w439
    w584 = w143 * w438 + w28 * w441
    w585 = w3 * w581 - w174 * w582 + w269 * w583 - w290 * w584
    w586 = (w562 * w567 + w568 * w573 + w574 * w579 + w580 * w585) / w561
    w587 = w359 * c67
    w588 = w332 * c69
    w589 = w325 * c70
    w590 = w359 * w587 + w332 * w588 + w325 * w589
    w591 = w314 * c73
    w592 = w308 * c76
    w593 = w310 * c77
    w594 = w314 * w591 + w308 * w592 + w310 * w593
    w595 = w317 * c78
    w596 = w446 * c78
    w597 = w415 * w595 - w343 * w596
    w598 = w597 - w474 * c74
    w599 = w310 * w596
    w600 = w312 * c78
    w601 = w599 - w415 * w600
    w602 = w601 - w458 * c74
    w603 = w343 * w600
    w604 = w310 * w595
    w605 = w603 - w604
    w606 = w605 - w346 * c74
    w607 = w594 - (w474 * w598 + w474 * w597) - (w458 * w602 + w458 * w601) - (w346 * w606 + w346 * w605)
    w608 = w324 * w607
    w609 = bar4_e1 * bar4_e2 * c79 + w347 * w593
    w610 = w314 * w596
    w611 = w343 * w595 - w610
    w612 = w347 * w596 - w603
    w613 = w347 * w595
    w614 = w314 * w600 - w613
    w615 = w609 - (w475 * w598 + w474 * w611) - (w459 * w602 + w458 * w612) - (w349 * w606 + w346 * w614)
    w616 = w324 * w615
    w617 = w343 * (w343 * c73) + w314 * (w314 * c76) + w347 * (w347 * c77)
    w618 = w611 - w475 * c74
    w619 = w612 - w459 * c74
    w620 = w614 - w349 * c74
    w621 = w617 - (w475 * w618 + w475 * w611) - (w459 * w619 + w459 * w612) - (w349 * w620 + w349 * w614)
    w622 = w616 + w321 * w621
    w623 = w335 * c80
    w624 = w453 * c80
    w625 = w327 * w623 - w350 * w624
    w626 = w625 + w324 * w598 + w321 * w618
    w627 = w626 - w476 * c81
    w628 = w325 * w624
    w629 = w329 * c80
    w630 = w628 - w327 * w629
    w631 = w630 + w324 * w602 + w321 * w619
    w632 = w631 - w461 * c81
    w633 = w590 + w324 * w608 + (w321 * w622 + w321 * w616) - (w476 * w627 + w476 * w626) - (w461 * w632 + w461 * w631)
    w634 = w350 * w629
    w635 = w325 * w623
    w636 = w634 - w635
    w637 = w636 + w324 * w606 + w321 * w620
    w638 = w637 - w353 * c81
    w639 = w358 * w587 + bar5_e0 * bar5_e1 * c82
    w640 = w307 * w591 + bar4_e1 * bar4_e0 * c83
    w641 = w613 - w599
    w642 = w308 * w596 - w347 * w600
    w643 = w310 * w600
    w644 = w643 - w308 * w595
    w645 = w640 - (w471 * w598 + w474 * w641) - (w450 * w602 + w458 * w642) - (w323 * w606 + w346 * w644)
    w646 = w324 * w645
    w647 = w347 * w592 + bar4_e0 * bar4_e2 * c84
    w648 = w604 - w307 * w596
    w649 = w610 - w643
    w650 = w307 * w600 - w314 * w595
    w651 = w647 - (w470 * w598 + w474 * w648) - (w449 * w602 + w458 * w649) - (w319 * w606 + w346 * w650)
    w652 = w324 * w651
    w653 = w310 * c76
    w654 = w343 * c77
    w655 = w314 * w653 + bar4_e3 * bar4_e1 * c85
    w656 = w641 - w471 * c74
    w657 = w642 - w450 * c74
    w658 = w644 - w323 * c74
    w659 = w655 - (w475 * w656 + w471 * w611) - (w459 * w657 + w450 * w612) - (w349 * w658 + w323 * w614)
    w660 = w310 * c73
    w661 = w343 * w660 + bar4_e3 * bar4_e2 * c86
    w662 = w648 - w470 * c74
    w663 = w649 - w449 * c74
    w664 = w650 - w319 * c74
    w665 = w661 - (w475 * w662 + w470 * w611) - (w459 * w663 + w449 * w612) - (w349 * w664 + w319 * w614)
    w666 = w324 * w659 - w321 * w665
    w667 = w363 * w623
    w668 = w667 - w628
    w669 = w668 + w324 * w656 - w321 * w662
    w670 = w332 * w624 - w363 * w629
    w671 = w670 + w324 * w657 - w321 * w663
    w672 = w639 + w324 * w646 - w321 * w652 + w321 * w666 - (w472 * w627 + w476 * w669) - (w455 * w632 + w461 * w671)
    w673 = w325 * w629
    w674 = w673 - w332 * w623
    w675 = w674 + w324 * w658 - w321 * w664
    w676 = w357 * (w672 - (w337 * w638 + w353 * w675))
    w677 = w325 * c69
    w678 = w350 * c70
    w679 = w358 * (w358 * c67) + w325 * w677 + w350 * w678
    w680 = w307 * (w307 * c73) + w310 * w653 + w343 * w654
    w681 = w680 - (w471 * w656 + w471 * w641) - (w450 * w657 + w450 * w642) - (w323 * w658 + w323 * w644)
    w682 = w324 * w681
    w683 = bar4_e3 * bar4_e0 * c87 + w415 * w654
    w684 = w683 - (w470 * w656 + w471 * w648) - (w449 * w657 + w450 * w649) - (w319 * w658 + w323 * w650)
    w685 = w324 * w684
    w686 = w310 * w660 + w347 * (w347 * c76) + w415 * (w415 * c77)
    w687 = w686 - (w470 * w662 + w470 * w648) - (w449 * w663 + w449 * w649) - (w319 * w664 + w319 * w650)
    w688 = w685 - w321 * w687
    w689 = w669 - w472 * c81
    w690 = w671 - w455 * c81
    w691 = w679 + w324 * w682 - (w321 * w688 + w321 * w685) - (w472 * w689 + w472 * w669) - (w455 * w690 + w455 * w671)
    w692 = w675 - w337 * c81
    w693 = w357 * (w357 * (w633 - (w353 * w638 + w353 * w637))) + (w342 * (w676 + w342 * (w691 - (w337 * w692 + w337 * w675))) + w342 * w676)
    w694 = w363 * w588 + bar5_e0 * bar5_e2 * c88
    w695 = w321 * w659 + w324 * w665
    w696 = w635 - w358 * w624
    w697 = w696 + w321 * w656 + w324 * w662
    w698 = w359 * w624
    w699 = w698 - w673
    w700 = w699 + w321 * w657 + w324 * w663
    w701 = w694 + w321 * w646 + w324 * w652 + w321 * w695 - (w478 * w627 + w476 * w697) - (w464 * w632 + w461 * w700)
    w702 = w358 * w629 - w359 * w623
    w703 = w702 + w321 * w658 + w324 * w664
    w704 = bar5_e0 * bar5_e3 * c89 + w327 * w678
    w705 = w321 * w684
    w706 = w704 + w321 * w682 + (w324 * w688 - w321 * w705) - (w478 * w689 + w472 * w697) - (w464 * w690 + w455 * w700)
    w707 = w357 * (w701 - (w360 * w638 + w353 * w703)) + w342 * (w706 - (w360 * w692 + w337 * w703))
    w708 = w325 * c67
    w709 = w325 * w708 + w363 * (w363 * c69) + w327 * (w327 * c70)
    w710 = w697 - w478 * c81
    w711 = w709 + w321 * (w321 * w681) + (w324 * (w705 + w324 * w687) + w324 * w705) - (w478 * w710 + w478 * w697)
    w712 = w700 - w464 * c81
    w713 = w703 - w360 * c81
    w714 = w362 * (w707 - w362 * (w711 - (w464 * w712 + w464 * w700) - (w360 * w713 + w360 * w703))) + w362 * w707
    w715 = bar5_e1 * bar5_e2 * c90 + w363 * w589
    w716 = w321 * w615
    w717 = w350 * w623 - w698
    w718 = w717 - w321 * w598 + w324 * w618
    w719 = w363 * w624 - w634
    w720 = w719 - w321 * w602 + w324 * w619
    w721 = w715 - w321 * w608 + (w324 * w622 - w321 * w716) - (w480 * w627 + w476 * w718) - (w466 * w632 + w461 * w720)
    w722 = w359 * w629 - w667
    w723 = w722 - w321 * w606 + w324 * w620
    w724 = w359 * w677 + bar5_e1 * bar5_e3 * c91
    w725 = w321 * w645
    w726 = w321 * w651
    w727 = w724 - w324 * w725 + w321 * w726 + w324 * w666 - (w480 * w689 + w472 * w718) - (w466 * w690 + w455 * w720)
    w728 = w350 * w708 + bar5_e2 * bar5_e3 * c92
    w729 = w728 - w321 * w725 - w324 * w726 + w324 * w695 - (w480 * w710 + w478 * w718) - (w466 * w712 + w464 * w720)
    w730 = w357 * (w721 - (w365 * w638 + w353 * w723)) + w342 * (w727 - (w365 * w692 + w337 * w723)) - w362 * (w729 - (w365 * w713 + w360 * w723))
    w731 = w350 * (w350 * c67) + w359 * (w359 * c69) + w363 * (w363 * c70)
    w732 = w731 + w321 * (w321 * w607) + (w324 * (w324 * w621 - w716) - w324 * w716) - (w480 * (w718 - w480 * c81) + w480 * w718)
    w733 = w367 * (w732 - (w466 * (w720 - w466 * c81) + w466 * w720) - (w365 * (w723 - w365 * c81) + w365 * w723))
    w734 = w289 - (w290 * (w304 - w290 * (w306 + (w28 * (w296 + w28 * w171) + w28 * w296))) + w290 * w304) + w586 * (w586 * (w693 - w714 - (w367 * (w730 - w733) + w367 * w730)))
    w735 = (w556 * w586 - (w549 * w567 + w551 * w573 + w553 * w579 + w555 * w585)) / w548
    w736 = w530 * w607
    w737 = w530 * w645
    w738 = w531 * w681 - w737
    w739 = w531 * w684 - w530 * w651
    w740 = w739 - w532 * w687
    w741 = w531 * w659 - w530 * w615 - w532 * w665
    w742 = w741 + w533 * w621
    w743 = w530 * w736 + (w531 * w738 - w531 * w737) - (w532 * w740 + w532 * w739) + (w533 * w742 + w533 * w741)
    w744 = w531 * w656 - w530 * w598 - w532 * w662 + w533 * w618
    w745 = w531 * w657 - w530 * w602 - w532 * w663 + w533 * w619
    w746 = w531 * w646 - w324 * w736 - w532 * w652 + (w321 * w742 + w533 * w616) - w476 * w744 - w461 * w745
    w747 = w531 * w658 - w530 * w606 - w532 * w664 + w533 * w620
    w748 = w324 * w738 - (w321 * w740 + w532 * w685) + w533 * w666 - w472 * w744 - w455 * w745 - w337 * w747
    w749 = w321 * w738 + (w324 * w740 - w532 * w705) + w533 * w695 - w478 * w744 - w464 * w745 - w360 * w747
    w750 = w321 * w736 - w531 * w725 + w532 * w726 + (w324 * w742 - w533 * w716) - w480 * w744 - w466 * w745
    w751 = w586 * (w357 * (w746 - w353 * w747) + w342 * w748 - w362 * w749 - w367 * (w750 - w365 * w747))
    w752 = (w526 * w586 - (w519 * w567 + w521 * w573 + w523 * w579 + w525 * w585) - w543 * w735) / w518
    w753 = w61 * w506 + w67 * w507 + w71 * w508 - w75 * w505
    w754 = w91 * w506 + w92 * w507 + w94 * w508 - w96 * w505
    w755 = w105 * w506 + w106 * w507 + w107 * w508 - w108 * w505
    w756 = w120 * w506
    w757 = w122 * w506
    w758 = w757 + w126 * w507
    w759 = w129 * w506 + w130 * w507
    w760 = w759 + w133 * w508
    w761 = w135 * w506 + w136 * w507 + w137 * w508
    w762 = w761 - w139 * w505
    w763 = w48 * w756 + w116 * w506 + (w63 * w758 + w123 * w507) + (w131 * w508 - w68 * w760) - (w72 * w762 + w138 * w505)
    w764 = w72 * w756 + w162 * w506 + (w68 * w758 + w163 * w507) + (w63 * w760 + w165 * w508) + (w48 * w762 - w166 * w505)
    w765 = w200 * w506 - w63 * w756 + (w48 * w758 + w201 * w507) + (w72 * w760 + w203 * w508) - (w68 * w762 + w204 * w505)
    w766 = w68 * w756 + w220 * w506 + (w221 * w507 - w72 * w758) + (w48 * w760 + w223 * w508) - (w63 * w762 + w224 * w505)
    w767 = w3 * (w16 * w753 + w21 * w754 + w25 * w755 + w28 * w763 - w143 * w764) - w174 * (w179 * w753 + w180 * w754 + w182 * w755 + w28 * w765 + w143 * w766)
    w768 = w767 + w269 * (w271 * w753 + w273 * w754 + w274 * w755 - w143 * w765 + w28 * w766) - w290 * (w292 * w753 + w293 * w754 + w294 * w755 + w143 * w763 + w28 * w764)
    w769 = w506 * w756 + (w507 * w758 + w507 * w757) + (w508 * w760 + w508 * w759) - (w505 * w762 + w505 * w761)
    w770 = w497 * w586 - (w444 * w567 + w469 * w573 + w483 * w579 + w496 * w585) - w538 * w735 - w513 * w752
    w771 = w770 / w443
    w772 = w141 * w382
    w773 = w167 * w382 - w235 * w384 + w243 * w386
    w774 = w773 - w171 * w388
    w775 = w205 * w382
    w776 = w775 - w256 * w384
    w777 = w225 * w382 - w260 * w384
    w778 = w777 + w264 * w386
    w779 = w3 * (w28 * w772 + w110 * w382 - w206 * w384 + w226 * w386 - (w143 * w774 + w168 * w388)) - w174 * (w183 * w382 + (w28 * w776 - w253 * w384) + (w143 * w778 + w261 * w386) - w244 * w388)
    w780 = w779 + w269 * (w275 * w382 - (w143 * w776 + w279 * w384) + (w28 * w778 + w280 * w386) - w276 * w388)
    w781 = w780 - w290 * (w143 * w772 + w295 * w382 - w299 * w384 + w300 * w386 + (w28 * w774 - w296 * w388))
    w782 = w781 + w752 * (w382 * w763 - w384 * w765 + w386 * w766 - w388 * w764)
    w783 = w382 * w772 - (w384 * w776 + w384 * w775) + (w386 * w778 + w386 * w777) - (w388 * w774 + w388 * w773)
    w784 = w734 + (w735 * (w735 * w743 - w751) - w735 * w751) + (w752 * (w768 + w752 * w769) + w752 * w768) + (w771 * (w782 + w771 * w783) + w771 * w782)
    w785 = w177 * bar1_e0_dot
    w786 = w8 * bar1_e3_dot
    w787 = w785 + w11 * bar1_e1_dot + w13 * bar1_e2_dot + w786
    w788 = w787 * c5
    w789 = w4 * bar1_e0_dot
    w790 = w8 * bar1_e2_dot
    w791 = w789 + w177 * bar1_e1_dot + w790 + w6 * bar1_e3_dot
    w792 = w791 * c4
    w793 = w788 * w791 - w787 * w792
    w794 = w13 * bar1_e0_dot + w8 * bar1_e1_dot
    w795 = w794 + w175 * bar1_e2_dot + w4 * bar1_e3_dot
    w796 = w795 * c7
    w797 = w787 * w796 - w788 * w795
    w798 = w792 * w795 - w791 * w796
    w799 = w14 * c93
    w800 = w19 * c93
    w801 = hinge0_angle_dot / 2.0
    w802 = w801**2
    w803 = w1 * w802
    w804 = w803 * c1 * c3 - w803 * c2 * c0
    w805 = w801 * (w1 * w801) * c51
    w806 = w267 * w802
    w807 = w801 * (w267 * w801) * c42
    w808 = w806 * c2 * c3 - w806 * c1 * c0
    w809 = w4 * w793 + w6 * w797 + w8 * w798 + (w8 * w799 - w11 * w800) * c94 - (w270 * w804 - w291 * w805 + w176 * w807 + w10 * w808)
    w810 = w34 * bar2_e0_dot + w37 * bar2_e1_dot
    w811 = w810 + w198 * bar2_e2_dot + w111 * bar2_e3_dot
    w812 = w811 * c14
    w813 = w150 * bar2_e0_dot
    w814 = w37 * bar2_e3_dot
    w815 = w813 + w29 * bar2_e1_dot + w34 * bar2_e2_dot + w814
    w816 = w815 * c14
    w817 = w811 * w812 + w815 * w816
    w818 = bar2_e3 * w35
    w819 = bar2_e2 * w37
    w820 = w111 * bar2_e0_dot
    w821 = w37 * bar2_e2_dot
    w822 = w820 + w150 * bar2_e1_dot + w821 + w35 * bar2_e3_dot
    w823 = w812 * w822
    w824 = 2 * bar2_e2**2
    w825 = w816 * w822
    w826 = w794 + w177 * bar1_e2_dot + w11 * bar1_e3_dot
    w827 = w786 + (w785 + w4 * bar1_e1_dot + w6 * bar1_e2_dot)
    w828 = w15 * w827 - w20 * w826
    w829 = w790 + (w789 + w175 * bar1_e1_dot) + w13 * bar1_e3_dot
    w830 = w20 * w829 - w12 * w827
    w831 = w826 * w828 - w829 * w830
    w832 = w831 - w292 * w805 + w271 * w804 + w179 * w807 + w16 * w808
    w833 = (hinge1_angle_dot / 2.0)**2
    w834 = w143 * w833
    w835 = w28 * w833
    w836 = w381 * hinge1_angle_dot
    w837 = w380 * hinge1_angle_dot
    w838 = bar1_e0_dot * w836 + bar1_e3_dot * w837
    w839 = bar1_e3 * w834 - bar1_e0 * w835 - w838 - w838
    w840 = w73 * bar3_e0_dot
    w841 = w51 * bar3_e2_dot
    w842 = w840 + w70 * bar3_e1_dot + w841 + w55 * bar3_e3_dot
    w843 = w55 * bar3_e0_dot + w51 * bar3_e1_dot
    w844 = w843 + w64 * bar3_e2_dot + w49 * bar3_e3_dot
    w845 = w370 * w844 - w390 * w842
    w846 = w64 * bar3_e0_dot
    w847 = w51 * bar3_e3_dot
    w848 = w846 + w73 * bar3_e1_dot + w57 * bar3_e2_dot + w847
    w849 = w390 * w848 - w369 * w844
    w850 = w821 + (w820 + w198 * bar2_e1_dot) + w34 * bar2_e3_dot
    w851 = w810 + w150 * bar2_e2_dot + w29 * bar2_e3_dot
    w852 = w42 * w851 - w43 * w850
    w853 = w814 + (w813 + w111 * bar2_e1_dot + w35 * bar2_e2_dot)
    w854 = w43 * w853 - w84 * w851
    w855 = w850 * w852 - w853 * w854
    w856 = hinge2_angle_dot / 2.0
    w857 = w856**2
    w858 = w62 * w857
    w859 = w858 * c16 * c17 - w858 * c18 * c19
    w860 = w47 * w857
    w861 = w856 * (w47 * w856) * c20
    w862 = w860 * c18 * c17 - w860 * c16 * c19
    w863 = w856 * (w62 * w856) * c22
    w864 = w501 * hinge2_angle_dot
    w865 = w864 * c18 * c19 - w864 * c16 * c17
    w866 = w499 * hinge2_angle_dot
    w867 = w866 * c20
    w868 = w866 * c18 * c17 - w866 * c16 * c19
    w869 = w864 * c22
    w870 = bar2_e0_dot * w865 - bar2_e3_dot * w867 + (bar2_e1_dot * w868 - bar2_e2_dot * w869)
    w871 = w870 + (bar2_e0 * w859 - bar2_e3 * w861 + (bar2_e1 * w862 + bar2_e2 * w863) + w870)
    w872 = bar2_e0_dot * w868 - bar2_e2_dot * w867 + (bar2_e3_dot * w869 - bar2_e1_dot * w865)
    w873 = w872 + (bar2_e0 * w862 - bar2_e2 * w861 - (bar2_e3 * w863 + bar2_e1 * w859) + w872)
    w874 = bar2_e0_dot * w869 - bar2_e1_dot * w867 + (bar2_e2_dot * w865 - bar2_e3_dot * w868)
    w875 = w874 + (bar2_e2 * w859 - bar2_e3 * w862 - (bar2_e0 * w863 + bar2_e1 * w861) + w874)
    w876 = bar2_e0_dot * w867 + (bar2_e1_dot * w869 + bar2_e2_dot * w868 + bar2_e3_dot * w865)
    w877 = w876 + (bar2_e0 * w861 + (bar2_e2 * w862 - bar2_e1 * w863 + bar2_e3 * w859) + w876)
    w878 = w314 * bar4_e0_dot
    w879 = w310 * bar4_e2_dot
    w880 = w878 + w307 * bar4_e1_dot + w879 + w343 * bar4_e3_dot
    w881 = w343 * bar4_e0_dot + w310 * bar4_e1_dot
    w882 = w881 + w347 * bar4_e2_dot + w415 * bar4_e3_dot
    w883 = w318 * w882 - w447 * w880
    w884 = w347 * bar4_e0_dot
    w885 = w310 * bar4_e3_dot
    w886 = w884 + w314 * bar4_e1_dot + w308 * bar4_e2_dot + w885
    w887 = w447 * w886 - w313 * w882
    w888 = w880 * w883 - w886 * w887
    w889 = (hinge4_angle_dot / 2.0)**2
    w890 = w321 * w889
    w891 = w324 * w889
    w892 = w528 * hinge4_angle_dot
    w893 = w529 * hinge4_angle_dot
    w894 = bar5_e0_dot * w892 + w893 * bar5_e3_dot
    w895 = bar5_e0 * w890 - bar5_e3 * w891 - w894 - w894
    w896 = w842 * w845 - w848 * w849 + w855 + w374 * w871 + w376 * w873 + w371 * w875 - w378 * w877 + w888 + w346 * w895
    w897 = w892 * bar5_e1_dot - w893 * bar5_e2_dot
    w898 = w897 + (w897 - (bar5_e2 * w891 + bar5_e1 * w890))
    w899 = w893 * bar5_e1_dot + w892 * bar5_e2_dot
    w900 = bar5_e2 * w890 - bar5_e1 * w891 - w899 - w899
    w901 = w892 * bar5_e3_dot - bar5_e0_dot * w893
    w902 = w901 + (w901 - (bar5_e0 * w891 + bar5_e3 * w890))
    w903 = w12 * w826 - w15 * w829
    w904 = w829 * w903 - w827 * w828
    w905 = bar1_e0_dot * w837 - bar1_e3_dot * w836
    w906 = w905 + (w905 - (bar1_e0 * w834 + bar1_e3 * w835))
    w907 = bar1_e2_dot * w836 + bar1_e1_dot * w837
    w908 = bar1_e1 * w834 - bar1_e2 * w835 - w907 - w907
    w909 = bar1_e2_dot * w837 - bar1_e1_dot * w836
    w910 = w909 + (w909 - (bar1_e1 * w835 + bar1_e2 * w834))
    w911 = w896 + w323 * w898 + w319 * w900 + w349 * w902 + w904 - w379 * w906 - w383 * w908 - w385 * w910 + w387 * w839
    w912 = w359 * bar5_e0_dot
    w913 = w325 * bar5_e2_dot
    w914 = w912 + w358 * bar5_e1_dot + w913 + w350 * bar5_e3_dot
    w915 = w350 * bar5_e0_dot + w325 * bar5_e1_dot
    w916 = w915 + w363 * bar5_e2_dot + w327 * bar5_e3_dot
    w917 = w336 * w916 - w454 * w914
    w918 = w363 * bar5_e0_dot
    w919 = w325 * bar5_e3_dot
    w920 = w918 + w359 * bar5_e1_dot + w332 * bar5_e2_dot + w919
    w921 = w454 * w920 - w330 * w916
    w922 = w914 * w917 - w920 * w921
    w923 = hinge5_angle_dot / 2.0
    w924 = w923**2
    w925 = w340 * w924
    w926 = w925 * c57 * c60 - w925 * c59 * c58
    w927 = w355 * w924
    w928 = w927 * c57 * c58 - w927 * c59 * c60
    w929 = w923 * (w340 * w923) * c61
    w930 = w923 * (w355 * w923) * c62
    w931 = w911 + w922 + w354 * w926 - w338 * w928 + w361 * w929 + w366 * w930 - w563 * w808 - w564 * w807 - w565 * w804
    w932 = w931 + w566 * w805
    w933 = w369 * w842 - w370 * w848
    w934 = w84 * w850 - w42 * w853
    w935 = w853 * w934 - w851 * w852
    w936 = w313 * w880 - w318 * w886
    w937 = w886 * w936 - w882 * w883
    w938 = w848 * w933 - w844 * w845 + w935 + w394 * w871 + w395 * w873 + w392 * w875 - w396 * w877 + w937 + w458 * w895
    w939 = w827 * w830 - w826 * w903
    w940 = w938 + w450 * w898 + w449 * w900 + w459 * w902 + w939 - w397 * w906 - w398 * w908 - w399 * w910 + w400 * w839
    w941 = w330 * w914 - w336 * w920
    w942 = w920 * w941 - w916 * w917
    w943 = w940 + w942 + w462 * w926 - w456 * w928 + w465 * w929 + w467 * w930 - w569 * w808 - w570 * w807 - w571 * w804
    w944 = w943 + w572 * w805
    w945 = w851 * w854 - w850 * w934
    w946 = w882 * w887 - w880 * w936
    w947 = w844 * w849 - w842 * w933 + w945 + w403 * w871 + w404 * w873 + w402 * w875 - w405 * w877 + w946 + w474 * w895
    w948 = w831 + (w947 + w471 * w898 + w470 * w900 + w475 * w902) - w406 * w906 - w407 * w908 - w408 * w910
    w949 = w916 * w921 - w914 * w941
    w950 = w948 + w409 * w839 + w949 + w477 * w926 - w473 * w928 + w479 * w929 + w481 * w930 - w575 * w808 - w576 * w807
    w951 = w950 - w577 * w804 + w578 * w805
    w952 = w422 * w882 - w425 * w880
    w953 = w425 * w886 - w417 * w882
    w954 = w417 * w880 - w422 * w886
    w955 = w428 * (w880 * w952 - w886 * w953) + w413 * (w886 * w954 - w882 * w952) + w419 * (w882 * w953 - w880 * w954)
    w956 = w413 * w844 - w428 * w842
    w957 = w428 * w848 - w419 * w844
    w958 = w419 * w842 - w413 * w848
    w959 = w955 + w425 * (w842 * w956 - w848 * w957) + w422 * (w848 * w958 - w844 * w956) + w417 * (w844 * w957 - w842 * w958)
    w960 = w959 + w954 * (2 * w958) + w953 * (2 * w957) + w952 * (2 * w956) + w434 * w871 + w435 * w873 + w436 * w875
    w961 = w437 * w877 - w960 - w487 * w895 - w490 * w898 - w491 * w900 - w488 * w902 - w438 * w906 - w439 * w908
    w962 = w961 - w440 * w910 - w441 * w839 - w489 * w926 - w492 * w928 - w493 * w929 + w494 * w930 - w581 * w808
    w963 = w962 - w582 * w807 - w583 * w804 + w584 * w805
    w964 = (w562 * w932 + w568 * w944 + w574 * w951 + w580 * w963) / w561
    w965 = (w549 * w932 + w551 * w944 + w553 * w951 + w555 * w963 - w556 * w964) / w548
    w966 = (w519 * w932 + w521 * w944 + w523 * w951 + w525 * w963 - w526 * w964 - w543 * w965) / w518
    w967 = (w444 * w932 + w469 * w944 + w483 * w951 + w496 * w963 - w497 * w964 - w538 * w965 - w513 * w966) / w443
    w968 = w839 - w28 * w805 - w143 * w808 - w388 * w967
    w969 = w910 + w28 * w804 + w143 * w807 + w386 * w967
    w970 = w908 - w143 * w804 + w28 * w807 - w384 * w967
    w971 = w906 - w143 * w805 + w28 * w808 + w382 * w967
    w972 = w80 * w817 - (w818 - w819) * w823 - (w30 - w824) * w825 - (w832 * c11 + w145 * w968 + w207 * w969 + w184 * w970 + w41 * w971)
    w973 = w841 + (w840 + w64 * bar3_e1_dot) + w57 * bar3_e3_dot
    w974 = w973 * c21
    w975 = w843 + w70 * bar3_e2_dot + w73 * bar3_e3_dot
    w976 = w975 * c21
    w977 = w973 * w974 + w975 * w976
    w978 = w847 + (w846 + w49 * bar3_e1_dot + w55 * bar3_e2_dot)
    w979 = w976 * w978
    w980 = w974 * w978
    w981 = w832 + w945 + w147 * w968 + w208 * w969 + w185 * w970 + w44 * w971
    w982 = w48 * w968 - w877 - w63 * w969 - w68 * w970 - w72 * w971 - w505 * w966
    w983 = w875 + w63 * w968 + w48 * w969 + w72 * w970 - w68 * w971 + w508 * w966
    w984 = w873 + w68 * w968 - w72 * w969 + w48 * w970 + w63 * w971 + w507 * w966
    w985 = w871 + w72 * w968 + w68 * w969 - w63 * w970 + w48 * w971 + w506 * w966
    w986 = w89 * w977 - (w419 * w979 + (w50 + w52) * w980) - (w981 * c12 + w75 * w982 + w71 * w983 + w67 * w984 + w61 * w985)
    w987 = w972 + w986
    w988 = w939 - w293 * w805 + w273 * w804 + w180 * w807 + w21 * w808
    w989 = w32 * w817 - w823 * (w36 + w38) - w825 * (w79 - w78) + c95 - (w988 * c11 + w151 * w968 + w211 * w969 + w188 * w970 + w82 * w971)
    w990 = w935 + w988 + w152 * w968 + w212 * w969 + w189 * w970 + w85 * w971
    w991 = w53 * w977 - (w413 * w979 + w980 * (w87 - w427)) + c96 - (w990 * c12 + w96 * w982 + w94 * w983 + w92 * w984 + w91 * w985)
    w992 = w989 + w991
    w993 = w904 - w294 * w805 + w274 * w804 + w182 * w807 + w25 * w808
    w994 = w39 * w817 - w823 * (1.0 - w824 - w31) - w825 * (w818 + w819) - (w993 * c11 + w156 * w968 + w215 * w969 + w193 * w970 + w100 * w971)
    w995 = w855 + w993 + w158 * w968 + w216 * w969 + w195 * w970 + w103 * w971
    w996 = w59 * w977 - (w428 * w979 + w980 * (w412 - w411)) - (w995 * c12 + w108 * w982 + w107 * w983 + w106 * w984 + w105 * w985)
    w997 = w994 + w996
    w998 = w815 * c24
    w999 = w822 * c23
    w1000 = w822 * w998 - w815 * w999
    w1001 = w811 * c26
    w1002 = w815 * w1001 - w811 * w998
    w1003 = w811 * w999 - w822 * w1001
    w1004 = w111 * w1000 + w35 * w1002 + w37 * w1003 + w82 * c94 - (w100 * w993 + w82 * w988 + w41 * w832 + w161 * w968 + w219 * w969 + w199 * w970 + w115 * w971)
    w1005 = w978 * c30
    w1006 = w973 * c29
    w1007 = w973 * w1005 - w978 * w1006
    w1008 = w975 * c32
    w1009 = w978 * w1008 - w975 * w1005
    w1010 = w975 * w1006 - w973 * w1008
    w1011 = w73 * w1007 + w57 * w1009 + w51 * w1010 + w91 * c94 - (w105 * w995 + w91 * w990 + w61 * w981 + w135 * w982 + w129 * w983 + w122 * w984 + w120 * w985)
    w1012 = w70 * w1007 + w51 * w1009 + w55 * w1010 + w92 * c94 - (w106 * w995 + w92 * w990 + w67 * w981 + w136 * w982 + w130 * w983 + w126 * w984 + w122 * w985)
    w1013 = w51 * w1007 + w64 * w1009 + w49 * w1010 + w94 * c94 - (w107 * w995 + w94 * w990 + w71 * w981 + w137 * w982 + w133 * w983 + w130 * w984 + w129 * w985)
    w1014 = w55 * w1007 + w73 * w1009 + w64 * w1010 + w96 * c94 - (w108 * w995 + w96 * w990 + w75 * w981 + w139 * w982 + w137 * w983 + w136 * w984 + w135 * w985)
    w1015 = w1004 + w44 * w986 + w85 * w991 + w103 * w996 + w48 * w1011 + w63 * w1012 - w68 * w1013 - w72 * w1014
    w1016 = w34 * w1000 + w111 * w1002 + w150 * w1003 + w151 * c94 - (w156 * w993 + w151 * w988 + w145 * w832 + w169 * w968 + w237 * w969 + w229 * w970 + w161 * w971)
    w1017 = w1016 + w147 * w986 + w152 * w991 + w158 * w996 + w72 * w1011 + w68 * w1012 + w63 * w1013 + w48 * w1014
    w1018 = w175 * w793 + w8 * w797 + w13 * w798 + (w6 * w799 - w177 * w800) * c94 - (w278 * w804 - w298 * w805 + w249 * w807 + w176 * w808)
    w1019 = w198 * w1000 + w37 * w1002 + w34 * w1003 + w188 * c94 - (w193 * w993 + w188 * w988 + w184 * w832 + w229 * w968 + w258 * w969 + w254 * w970 + w199 * w971)
    w1020 = w1019 + w185 * w986 + w189 * w991 + w195 * w996 - w63 * w1011 + w48 * w1012 + w72 * w1013 - w68 * w1014
    w1021 = w37 * w1000 + w150 * w1002 + w29 * w1003 + w211 * c94 - (w215 * w993 + w211 * w988 + w207 * w832 + w237 * w968 + w262 * w969 + w258 * w970 + w219 * w971)
    w1022 = w1021 + w208 * w986 + w212 * w991 + w216 * w996 + w68 * w1011 - w72 * w1012 + w48 * w1013 - w63 * w1014
    w1023 = w3 * (w809 + w16 * w987 + w21 * w992 + w25 * w997 + w28 * w1015 - w143 * w1017) - w174 * (w1018 + w179 * w987 + w180 * w992 + w182 * w997 + w28 * w1020 + w143 * w1022)
    w1024 = w8 * w793 + w177 * w797 + w11 * w798 + (w4 * w799 - w8 * w800) * c94 - (w284 * w804 - w302 * w805 + w278 * w807 + w270 * w808)
    w1025 = w13 * w793 + w4 * w797 + w177 * w798 + (w177 * w799 - w13 * w800) * c94 - (w302 * w804 - w305 * w805 + w298 * w807 + w291 * w808)
    w1026 = w1023 + w269 * (w1024 + w271 * w987 + w273 * w992 + w274 * w997 - w143 * w1020 + w28 * w1022) - w290 * (w1025 + w292 * w987 + w293 * w992 + w294 * w997 + w143 * w1015 + w28 * w1017)
    w1027 = w919 + (w918 + w327 * bar5_e1_dot + w350 * bar5_e2_dot)
    w1028 = w1027 * c66
    w1029 = w913 + (w912 + w363 * bar5_e1_dot) + w332 * bar5_e3_dot
    w1030 = w1029 * c65
    w1031 = w1028 * w1029 - w1027 * w1030
    w1032 = w915 + w358 * bar5_e2_dot + w359 * bar5_e3_dot
    w1033 = w1032 * c68
    w1034 = w1027 * w1033 - w1028 * w1032
    w1035 = w1030 * w1032 - w1029 * w1033
    w1036 = w930 + w367 * w964
    w1037 = w929 - w362 * w964
    w1038 = w928 + w342 * w964
    w1039 = w926 + w357 * w964
    w1040 = w365 * w1036 - w922 - w360 * w1037 - w337 * w1038 - w353 * w1039
    w1041 = w466 * w1036 - w942 - w464 * w1037 - w455 * w1038 - w461 * w1039
    w1042 = w480 * w1036 - w949 - w478 * w1037 - w472 * w1038 - w476 * w1039
    w1043 = w636 * w1040 + w630 * w1041 + w625 * w1042 - w715 * w1036 + w694 * w1037 + w639 * w1038 + w590 * w1039
    w1044 = w885 + (w884 + w415 * bar4_e1_dot + w343 * bar4_e2_dot)
    w1045 = w1044 * c72
    w1046 = w879 + (w878 + w347 * bar4_e1_dot) + w308 * bar4_e3_dot
    w1047 = w1046 * c71
    w1048 = w1045 * w1046 - w1044 * w1047
    w1049 = w881 + w307 * bar4_e2_dot + w314 * bar4_e3_dot
    w1050 = w1049 * c75
    w1051 = w1044 * w1050 - w1045 * w1049
    w1052 = w1047 * w1049 - w1046 * w1050
    w1053 = w902 - w324 * w1036 + w321 * w1039 + w533 * w965
    w1054 = w900 + w324 * w1037 - w321 * w1038 - w532 * w965
    w1055 = w898 + w321 * w1037 + w324 * w1038 + w531 * w965
    w1056 = w895 + w321 * w1036 + w324 * w1039 - w530 * w965
    w1057 = w1040 - (w888 + w349 * w1053 + w319 * w1054 + w323 * w1055 + w346 * w1056)
    w1058 = w1041 - (w937 + w459 * w1053 + w449 * w1054 + w450 * w1055 + w458 * w1056)
    w1059 = w1042 - (w946 + w475 * w1053 + w470 * w1054 + w471 * w1055 + w474 * w1056)
    w1060 = w605 * w1057 + w601 * w1058 + w597 * w1059 + w609 * w1053 + w647 * w1054 + w640 * w1055 + w594 * w1056
    w1061 = w1044 * c78
    w1062 = w1046 * c78
    w1063 = w1044 * w1061 + w1046 * w1062
    w1064 = w1049 * w1062
    w1065 = w1049 * w1061
    w1066 = w312 * w1063 - w417 * w1064 - (w420 - w445) * w1065 - (w1059 * c74 + w611 * w1053 + w648 * w1054 + w641 * w1055 + w597 * w1056)
    w1067 = w317 * w1063 - w422 * w1064 - w1065 * (w416 - w414) + c97 - (w1058 * c74 + w612 * w1053 + w649 * w1054 + w642 * w1055 + w601 * w1056)
    w1068 = w446 * w1063 - w425 * w1064 - w1065 * (w309 + w311) - (w1057 * c74 + w614 * w1053 + w650 * w1054 + w644 * w1055 + w605 * w1056)
    w1069 = w314 * w1048 + w308 * w1051 + w310 * w1052 + w601 * c94 - w1060 - w474 * w1066 - w458 * w1067 - w346 * w1068
    w1070 = w614 * w1057 + w612 * w1058 + w611 * w1059 + w617 * w1053 + w661 * w1054 + w655 * w1055 + w609 * w1056
    w1071 = w343 * w1048 + w314 * w1051 + w347 * w1052 + w612 * c94 - w1070 - w475 * w1066 - w459 * w1067 - w349 * w1068
    w1072 = w1032 * c80
    w1073 = w1027 * c80
    w1074 = w1032 * w1072 + w1027 * w1073
    w1075 = bar5_e3 * w332
    w1076 = w325 * bar5_e2
    w1077 = w1029 * w1072
    w1078 = 2 * bar5_e2**2
    w1079 = w1029 * w1073
    w1080 = w329 * w1074 - (w1075 - w1076) * w1077 - (w333 - w1078) * w1079 - (w1042 * c64 - w717 * w1036 + w696 * w1037 + w668 * w1038 + w625 * w1039)
    w1081 = w1066 + w1080
    w1082 = w359 * w1031 + w332 * w1034 + w325 * w1035 + w630 * c94 - w1043 + w324 * w1069 + w321 * w1071 - w476 * w1081
    w1083 = w335 * w1074 - w1077 * (w451 + w452) - w1079 * (w328 - w326) + c98 - (w1041 * c64 - w719 * w1036 + w699 * w1037 + w670 * w1038 + w630 * w1039)
    w1084 = w1067 + w1083
    w1085 = w453 * w1074 - w1077 * (1.0 - w1078 - w334) - w1079 * (w1075 + w1076) - (w1040 * c64 - w722 * w1036 + w702 * w1037 + w674 * w1038 + w636 * w1039)
    w1086 = w1068 + w1085
    w1087 = w674 * w1040 + w670 * w1041 + w668 * w1042 - w724 * w1036 + w704 * w1037 + w679 * w1038 + w639 * w1039
    w1088 = w644 * w1057 + w642 * w1058 + w641 * w1059 + w655 * w1053 + w683 * w1054 + w680 * w1055 + w640 * w1056
    w1089 = w307 * w1048 + w310 * w1051 + w343 * w1052 + w642 * c94 - w1088 - w471 * w1066 - w450 * w1067 - w323 * w1068
    w1090 = w650 * w1057 + w649 * w1058 + w648 * w1059 + w661 * w1053 + w686 * w1054 + w683 * w1055 + w647 * w1056
    w1091 = w310 * w1048 + w347 * w1051 + w415 * w1052 + w649 * c94 - w1090 - w470 * w1066 - w449 * w1067 - w319 * w1068
    w1092 = w358 * w1031 + w325 * w1034 + w350 * w1035 + w670 * c94 - w1087 + w324 * w1089 - w321 * w1091 - w472 * w1081
    w1093 = w702 * w1040 + w699 * w1041 + w696 * w1042 - w728 * w1036 + w709 * w1037 + w704 * w1038 + w694 * w1039
    w1094 = w325 * w1031 + w363 * w1034 + w327 * w1035 + w699 * c94 - w1093 + w321 * w1089 + w324 * w1091 - w478 * w1081
    w1095 = w357 * (w1082 - w461 * w1084 - w353 * w1086) + w342 * (w1092 - w455 * w1084 - w337 * w1086) - w362 * (w1094 - w464 * w1084 - w360 * w1086)
    w1096 = w722 * w1040 + w719 * w1041 + w717 * w1042 - w731 * w1036 + w728 * w1037 + w724 * w1038 + w715 * w1039
    w1097 = w350 * w1031 + w359 * w1034 + w363 * w1035 + w719 * c94 - w1096 - w321 * w1069 + w324 * w1071 - w480 * w1081
    w1098 = w1026 - w586 * (w1095 - w367 * (w1097 - w466 * w1084 - w365 * w1086)) + w735 * (w531 * w1089 - w530 * w1069 - w532 * w1091 + w533 * w1071)
    w1099 = w1098 + w752 * (w506 * w1011 + w507 * w1012 + w508 * w1013 - w505 * w1014) + w771 * (w382 * w1015 - w384 * w1020 + w386 * w1022 - w388 * w1017)
    M_hat = ca.vertcat(
        w784,
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w1099,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 1263 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    hinge1_angle = q_d[35]
    hinge2_angle = q_d[36]
    hinge4_angle = q_d[37]
    hinge5_angle = q_d[38]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c10 = c[10]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c42 = c[42]
    c51 = c[51]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c99 = c[99]
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 * c51
    w3 = w1 * c2 * c0 - w1 * c1 * c3
    w4 = ca.sin(w0)
    w5 = w4 * c42
    w6 = w4 * c1 * c0 - w4 * c2 * c3
    w7 = (1.0 - 2 * w5**2 - 2 * w6**2) * c10
    w8 = 2 * w2
    w9 = 2 * w3
    w10 = (w6 * w8 - w5 * w9) * c10
    w11 = (w6 * w9 + w5 * w8) * c10
    w12 = hinge1_angle / 2.0
    w13 = ca.cos(w12)
    w14 = ca.sin(w12)
    w15 = w2 * w13 - w6 * w14
    w16 = hinge2_angle / 2.0
    w17 = ca.cos(w16)
    w18 = w17 * c20
    w19 = w3 * w13 - w5 * w14
    w20 = ca.sin(w16)
    w21 = w20 * c22
    w22 = w5 * w13 + w3 * w14
    w23 = w17 * c16 * c19 - w17 * c18 * c17
    w24 = w2 * w14 + w6 * w13
    w25 = w20 * c18 * c19 - w20 * c16 * c17
    w26 = 2 * (w15 * w18 - (w19 * w21 - w22 * w23 + w24 * w25))
    w27 = w15 * w23 - w18 * w22 + (w21 * w24 - w19 * w25)
    w28 = 2 * w27
    w29 = w15 * w25 + w18 * w24 + (w19 * w23 + w21 * w22)
    w30 = w15 * w21 + w18 * w19 - (w22 * w25 + w23 * w24)
    w31 = (w28 * w29 - w26 * w30) * c63
    w32 = w26 * w31
    w33 = 2 * w29
    w34 = w26 * w27
    w35 = 2 * w30
    w36 = w29 * w35
    w37 = (w34 + w36) * c63
    w38 = w32 - w33 * w37
    w39 = 2 * -w22
    w40 = (1.0 - 2 * w19**2 - 2 * w24**2) * c15
    w41 = w19 * -2.0
    w42 = 2 * w19
    w43 = 2 * w15
    w44 = (w22 * w42 + w24 * w43) * c15
    w45 = w30 * -2.0
    w46 = w28 * w31 - w37 * w45
    w47 = w29 * -2.0
    w48 = w31 * w47
    w49 = w26 * w37
    w50 = w48 - w49
    w51 = w27 * -2.0
    w52 = w37 * w51
    w53 = w31 * w45 - w52
    w54 = w13 / 2.0
    w55 = w14 / 2.0
    w56 = w2 * w54 - w6 * w55
    w57 = w24 * -2.0
    w58 = w40 * w57
    w59 = w43 * w44
    w60 = w3 * w54 - w5 * w55
    w61 = (w23 * w38 - (w39 * w40 + w41 * w44 + w18 * w46 + w21 * w50) + w25 * w53) * w56 - (w21 * w46 - (w58 + w59) - w18 * w50 - w25 * w38 + w23 * w53) * w60
    w62 = w40 * w43
    w63 = 2 * w24
    w64 = w5 * w54 + w3 * w55
    w65 = w22 * -2.0
    w66 = w44 * w65
    w67 = w2 * w55 + w6 * w54
    w68 = w61 - (w25 * w50 - (w62 + w44 * w63 + w23 * w46) - w18 * w38 + w21 * w53) * w64 + (w40 * w41 - w66 + w25 * w46 + w23 * w50 + w21 * w38 + w18 * w53) * w67
    w69 = 2 * w27**2
    w70 = (1.0 - 2 * w30**2 - w69) * c63
    w71 = w33 * w70 - w31 * w51
    w72 = (w19 * w43 + w24 * w39) * c15
    w73 = w41 * w72
    w74 = w45 * w70
    w75 = w74 - w32
    w76 = w26 * w70
    w77 = w76 - w31 * w35
    w78 = w51 * w70 - w48
    w79 = w43 * w72
    w80 = w56 * (w23 * w71 - (w73 - w62 + w18 * w75 + w21 * w77) + w25 * w78) - w60 * (w21 * w75 - (w79 - w40 * w42) - w18 * w77 - w25 * w71 + w23 * w78)
    w81 = w80 - w64 * (w25 * w77 - (w63 * w72 + w40 * w65 + w23 * w75) - w18 * w71 + w21 * w78) + w67 * (w25 * w75 - (w58 + w65 * w72) + w23 * w77 + w21 * w71 + w18 * w78)
    w82 = w52 - w76
    w83 = w49 - w28 * w70
    w84 = w35 * w37 - w47 * w70
    w85 = w37 * w47 - w74
    w86 = w56 * (w23 * w82 - (w18 * w83 - (w59 + w39 * w72) + w21 * w84) + w25 * w85) - w60 * (w21 * w83 + (w42 * w44 + w57 * w72) - w18 * w84 - w25 * w82 + w23 * w85)
    w87 = w86 - w64 * (w25 * w84 - (w66 - w79 + w23 * w83) - w18 * w82 + w21 * w85) + w67 * (w25 * w83 - (w73 + w44 * w57) + w23 * w84 + w21 * w82 + w18 * w85)
    w88 = w26 * w29 + w27 * w35
    w89 = hinge4_angle / 2.0
    w90 = ca.cos(w89)
    w91 = hinge5_angle / 2.0
    w92 = ca.cos(w91)
    w93 = w92 * c59 * c60 - w92 * c57 * c58
    w94 = ca.sin(w91)
    w95 = w94 * c61
    w96 = ca.sin(w89)
    w97 = w90 * w93 - w95 * w96
    w98 = 2 * w97
    w99 = w94 * c59 * c58 - w94 * c57 * c60
    w100 = w92 * c62
    w101 = w90 * w99 - w96 * w100
    w102 = 2 * (w90 * w100 + w96 * w99)
    w103 = w90 * w95 + w93 * w96
    w104 = w98 * w101 - w102 * w103
    w105 = w88 * w104
    w106 = w36 - w34
    w107 = 2 * w101**2
    w108 = 1.0 - 2 * w103**2 - w107
    w109 = w106 * w108
    w110 = w105 - w109
    w111 = 2 * -w103
    w112 = w97 * w111
    w113 = w101 * w102
    w114 = w112 - w113
    w115 = w106 * w114
    w116 = 1.0 - w69 - 2 * w29**2
    w117 = w104 * w116
    w118 = w115 - w117
    w119 = w108 * w116
    w120 = w88 * w114
    w121 = w119 - w120
    w122 = w28 * w110 + w45 * w118 + w26 * w121
    w123 = w47 * w110 + w26 * w118 + w35 * w121
    w124 = w26 * w110 + w33 * w118 + w51 * w121
    w125 = w45 * w110 + w51 * w118 + w47 * w121
    w126 = w56 * (w18 * w122 + w21 * w123 - w23 * w124 - w25 * w125) - w60 * (w18 * w123 - w21 * w122 + w25 * w124 - w23 * w125)
    w127 = w126 - w64 * (w23 * w122 - w25 * w123 + w18 * w124 - w21 * w125) - w67 * (w25 * w122 + w23 * w123 + w21 * w124 + w18 * w125)
    w128 = ca.sqrt(w81**2 + w87**2 + w68**2 + w127**2)
    w129 = w68 / w128
    w130 = 2 * w93
    w131 = 2 * w100
    w132 = (w99 * w130 - w95 * w131) * c56
    w133 = (w101 * w111 - w97 * w102) * c55
    w134 = c99 - w132 - w133 - (w70 + (w11 + w72))
    w135 = w81 / w128
    w136 = 2 * -w95
    w137 = (w93 * w136 - w99 * w131) * c56
    w138 = (1.0 - 2 * w97**2 - w107) * c55
    w139 = w137 + w138 + (w37 + (w7 - w44))
    w140 = w87 / w128
    w141 = (1.0 - 2 * w95**2 - 2 * w99**2) * c56
    w142 = (w112 + w113) * c55
    w143 = w141 + w142 + (w31 + (w10 + w40))
    w144 = w127 / w128
    w145 = w114 * w116 + w88 * w108 + w104 * w106
    w146 = 2 * w101
    w147 = w97 * -2.0
    w148 = w133 * w146 - w142 * w147
    w149 = w102 * w133
    w150 = w149 - w111 * w142
    w151 = w131 * w132
    w152 = w94 / 2.0
    w153 = w152 * c57 * c58 - w152 * c59 * c60
    w154 = w101 * -2.0
    w155 = w142 * w154
    w156 = w133 * w147 - w155
    w157 = w103 * -2.0
    w158 = w133 * w157
    w159 = w102 * w142
    w160 = w158 + w159
    w161 = w95 * -2.0
    w162 = w132 * w161
    w163 = w131 * w141
    w164 = w92 / 2.0
    w165 = w164 * c59 * c58 - w164 * c57 * c60
    w166 = (w96 * w148 - w90 * w150 - (w151 - w136 * w141)) * w153 - (w96 * w156 - w90 * w160 - (w162 + w163)) * w165
    w167 = 2 * w99
    w168 = w93 * -2.0
    w169 = w164 * c61
    w170 = w99 * -2.0
    w171 = w141 * w170
    w172 = w152 * c62
    w173 = w166 + (w96 * w150 + w90 * w148 + (w132 * w167 - w141 * w168)) * w169 + (w96 * w160 + w90 * w156 + (w132 * w168 - w171)) * w172
    w174 = w138 * w147
    w175 = w174 - w149
    w176 = w111 * w138 - w133 * w154
    w177 = w102 * w138
    w178 = w177 - w98 * w133
    w179 = w158 + w138 * w154
    w180 = w131 * w137
    w181 = w153 * (w96 * w175 - w90 * w176 - (w136 * w137 - w132 * w170)) - w165 * (w90 * w178 + w96 * w179 + (w180 - w130 * w132))
    w182 = w137 * w168
    w183 = w181 + w169 * (w96 * w176 + w90 * w175 + (w182 - w151)) - w172 * (w96 * w178 - w90 * w179 - (w162 + w137 * w170))
    w184 = w159 - w138 * w146
    w185 = w155 - w177
    w186 = w98 * w142 + w138 * w157
    w187 = w174 + w142 * w157
    w188 = w153 * (w96 * w184 - w90 * w185 - (w171 - w180)) - w165 * (w90 * w186 - w96 * w187 + (w130 * w141 + w137 * w161))
    w189 = w188 + w169 * (w96 * w185 + w90 * w184 + (w163 - w137 * w167)) - w172 * (w96 * w186 + w90 * w187 + (w182 + w141 * w161))
    w190 = w109 - w105
    w191 = w117 - w115
    w192 = w120 - w119
    w193 = w98 * w190 - w157 * w191 + w102 * w192
    w194 = w147 * w191 - w157 * w190 + w154 * w192
    w195 = w154 * w190 + w102 * w191 + w111 * w192
    w196 = w102 * w190 + w146 * w191 + w147 * w192
    w197 = w165 * (w90 * w193 + w96 * w194) + w153 * (w90 * w195 - w96 * w196) - w169 * (w96 * w195 + w90 * w196)
    w198 = w197 - w172 * (w90 * w194 - w96 * w193)
    w199 = w135 * w173 + w140 * w183 + w129 * w189 + w144 * w198
    w200 = w189 - w129 * w199
    w201 = w173 - w135 * w199
    w202 = w20 / 2.0
    w203 = w202 * c20
    w204 = w17 / 2.0
    w205 = w204 * c22
    w206 = w202 * c18 * c17 - w202 * c16 * c19
    w207 = w204 * c18 * c19 - w204 * c16 * c17
    w208 = w15 * w203 + (w19 * w205 - w22 * w206 + w24 * w207)
    w209 = w15 * w207 - w24 * w203 + (w19 * w206 + w22 * w205)
    w210 = w15 * w206 + w22 * w203 + (w24 * w205 - w19 * w207)
    w211 = w15 * w205 - w19 * w203 - (w22 * w207 + w24 * w206)
    w212 = w78 * w208 - (w75 * w209 + w77 * w210 + w71 * w211)
    w213 = w85 * w208 - (w83 * w209 + w84 * w210 + w82 * w211)
    w214 = w53 * w208 - (w46 * w209 + w50 * w210 + w38 * w211)
    w215 = w122 * w209 + w123 * w210 + w124 * w211 - w125 * w208
    w216 = w135 * w212 + w140 * w213 + w129 * w214 + w144 * w215
    w217 = w212 - w135 * w216
    w218 = w213 - w140 * w216
    w219 = w214 - w129 * w216
    w220 = w215 - w144 * w216
    w221 = ca.sqrt(w217**2 + w218**2 + w219**2 + w220**2)
    w222 = w217 / w221
    w223 = w183 - w140 * w199
    w224 = w218 / w221
    w225 = w219 / w221
    w226 = w198 - w144 * w199
    w227 = w220 / w221
    w228 = w201 * w222 + w223 * w224 + w200 * w225 + w226 * w227
    w229 = w200 - w225 * w228
    w230 = w201 - w222 * w228
    w231 = w90 / 2.0
    w232 = w96 / 2.0
    w233 = w95 * w231 + w93 * w232
    w234 = w100 * w231 + w99 * w232
    w235 = w93 * w231 - w95 * w232
    w236 = w99 * w231 - w100 * w232
    w237 = w150 * w233 - w160 * w234 + w148 * w235 - w156 * w236
    w238 = w178 * w234 + w176 * w233 + w175 * w235 - w179 * w236
    w239 = w186 * w234 + w185 * w233 + w184 * w235 + w187 * w236
    w240 = w194 * w236 - (w195 * w233 + w193 * w234 + w196 * w235)
    w241 = w135 * w237 + w140 * w238 + w129 * w239 + w144 * w240
    w242 = w237 - w135 * w241
    w243 = w238 - w140 * w241
    w244 = w239 - w129 * w241
    w245 = w240 - w144 * w241
    w246 = w222 * w242 + w224 * w243 + w225 * w244 + w227 * w245
    w247 = w242 - w222 * w246
    w248 = w243 - w224 * w246
    w249 = w244 - w225 * w246
    w250 = w245 - w227 * w246
    w251 = ca.sqrt(w247**2 + w248**2 + w249**2 + w250**2)
    w252 = w247 / w251
    w253 = w223 - w224 * w228
    w254 = w248 / w251
    w255 = w249 / w251
    w256 = w226 - w227 * w228
    w257 = w250 / w251
    w258 = w230 * w252 + w253 * w254 + w229 * w255 + w256 * w257
    w259 = w229 - w255 * w258
    w260 = w230 - w252 * w258
    w261 = w253 - w254 * w258
    w262 = w256 - w257 * w258
    w263 = ca.sqrt(w260**2 + w261**2 + w259**2 + w262**2)
    w264 = (w134 * (w259 / w263) - (w139 * (w260 / w263) + w143 * (w261 / w263)) + w145 * (w262 / w263)) / w263
    w265 = (w134 * w255 - (w139 * w252 + w143 * w254) + w145 * w257 - w258 * w264) / w251
    w266 = (w134 * w225 - (w139 * w222 + w143 * w224) + w145 * w227 - w228 * w264 - w246 * w265) / w221
    w267 = w129 * w134 - (w135 * w139 + w140 * w143) + w144 * w145 - w199 * w264 - w241 * w265 - w216 * w266
    w268 = hinge1_angle - w267 / w128
    w269 = w268 / 2.0
    w270 = ca.cos(w269)
    w271 = ca.sin(w269)
    w272 = w2 * w270 - w6 * w271
    w273 = w3 * w270 - w5 * w271
    w274 = w5 * w270 + w3 * w271
    w275 = -w274
    w276 = w2 * w271 + w6 * w270
    w277 = 2 * w272
    w278 = hinge2_angle - w266
    w279 = w278 / 2.0
    w280 = ca.cos(w279)
    w281 = w280 * c20
    w282 = ca.sin(w279)
    w283 = w282 * c22
    w284 = w280 * c16 * c19 - w280 * c18 * c17
    w285 = w282 * c18 * c19 - w282 * c16 * c17
    w286 = hinge5_angle - w264
    w287 = w286 / 2.0
    w288 = ca.sin(w287)
    w289 = w288 * c61
    w290 = -w289
    w291 = ca.cos(w287)
    w292 = w291 * c59 * c60 - w291 * c57 * c58
    w293 = w291 * c62
    w294 = 2 * w293
    w295 = w288 * c59 * c58 - w288 * c57 * c60
    w296 = (2 * w290 * w292 - w294 * w295) * c56
    w297 = hinge4_angle - w265
    w298 = w297 / 2.0
    w299 = ca.cos(w298)
    w300 = ca.sin(w298)
    w301 = w292 * w299 - w289 * w300
    w302 = w295 * w299 - w293 * w300
    w303 = (1.0 - 2 * w289**2 - 2 * w295**2) * c56
    w304 = w293 * w299 + w295 * w300
    w305 = 2 * w304
    w306 = -(w289 * w299 + w292 * w300)
    w307 = 2 * w306
    w308 = c99 - (w295 * (2 * w292) - w289 * w294) * c56
    w309 = w198 * w239 - w189 * w240
    w310 = w198 * w214 - w189 * w215
    w311 = w214 * w240 - w215 * w239
    w312 = w68 * w198 - w127 * w189
    w313 = w68 * w240 - w127 * w239
    w314 = w81 * (w213 * w309 - w238 * w310 + w183 * w311) - w212 * (w87 * w309 - w238 * w312 + w183 * w313)
    w315 = w68 * w215 - w127 * w214
    w316 = w314 + w237 * (w87 * w310 - w213 * w312 + w183 * w315) - w173 * (w87 * w311 - w213 * w313 + w238 * w315)
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w2,
        w3,
        -w5,
        w6,
        w7,
        w10,
        w11,
        w272,
        w273,
        w275,
        w276,
        w7 - (w274 * (2 * w273) + w276 * w277) * c15,
        w10 + (1.0 - 2 * w273**2 - 2 * w276**2) * c15,
        w11 + (w273 * w277 + w276 * (2 * w275)) * c15,
        w272 * w281 - (w273 * w283 - w274 * w284 + w276 * w285),
        w272 * w283 + w273 * w281 - (w274 * w285 + w276 * w284),
        w272 * w284 - w274 * w281 + (w276 * w283 - w273 * w285),
        w272 * w285 + w276 * w281 + (w273 * w284 + w274 * w283),
        -(w296 + (1.0 - 2 * w301**2 - 2 * w302**2) * c55),
        -(w303 + (w302 * w305 + w301 * w307) * c55),
        w308 - (w302 * w307 - w301 * w305) * c55,
        w304,
        w306,
        w301,
        w302,
        -w296,
        -w303,
        w308,
        w293,
        w290,
        w292,
        w295,
        w268,
        w278,
        w297,
        w286,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w139,
        -w143,
        w134,
        w145,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        w316,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 1297 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c10 = c[10]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c42 = c[42]
    c51 = c[51]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    w0 = hinge0_angle / 2.0
    w1 = ca.sin(w0) / 2.0
    w2 = w1 * c51
    w3 = w2 * hinge0_angle_dot
    w4 = w1 * c1 * c3 - w1 * c2 * c0
    w5 = hinge0_angle_dot * w4
    w6 = ca.cos(w0) / 2.0
    w7 = w6 * c42
    w8 = hinge0_angle_dot * w7
    w9 = w6 * c1 * c0 - w6 * c2 * c3
    w10 = hinge0_angle_dot * w9
    w11 = 2 * bar1_e3
    w12 = 2 * bar1_e1
    w13 = 2 * bar1_e0
    w14 = (bar1_e3 * w12 - w13 * bar1_e2) * c10
    w15 = bar1_e2 * -2.0
    w16 = (bar1_e3 * w13 + w12 * bar1_e2) * c10
    w17 = w11 * w14 - w15 * w16
    w18 = bar1_e3 * -2.0
    w19 = w16 * w18
    w20 = w14 * w15 - w19
    w21 = w13 * w14
    w22 = w21 - w12 * w16
    w23 = bar1_e1 * -2.0
    w24 = w14 * w23
    w25 = w13 * w16
    w26 = w24 - w25
    w27 = w5 * w17 - w3 * w20 - w8 * w22 + w10 * w26
    w28 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c10
    w29 = w15 * w28
    w30 = w29 - w21
    w31 = w18 * w28 - w24
    w32 = w12 * w28 - w14 * w18
    w33 = w13 * w28
    w34 = 2 * bar1_e2
    w35 = w33 - w14 * w34
    w36 = w5 * w30 - w3 * w31 - w8 * w32 + w10 * w35
    w37 = w25 - w11 * w28
    w38 = w16 * w23 - w29
    w39 = w19 - w33
    w40 = w16 * w34 - w23 * w28
    w41 = w5 * w37 - w3 * w38 - w8 * w39 + w10 * w40
    w42 = hinge1_angle / 2.0
    w43 = ca.cos(w42)
    w44 = ca.sin(w42)
    w45 = w44 / 2.0
    w46 = w43 / 2.0
    w47 = bar1_e0 * w45 + bar1_e3 * w46
    w48 = 2 * bar4_e3
    w49 = 2 * bar4_e1
    w50 = 2 * bar4_e0
    w51 = (bar4_e3 * w49 - w50 * bar4_e2) * c55
    w52 = bar4_e2 * -2.0
    w53 = bar4_e3 * w50
    w54 = w49 * bar4_e2
    w55 = (w53 + w54) * c55
    w56 = w48 * w51 - w52 * w55
    w57 = hinge4_angle / 2.0
    w58 = ca.sin(w57)
    w59 = w50 * w51
    w60 = w59 - w49 * w55
    w61 = ca.cos(w57)
    w62 = 2 * bar5_e0
    w63 = 2 * bar5_e2
    w64 = (w62 * bar5_e1 + w63 * bar5_e3) * c56
    w65 = w62 * w64
    w66 = 2 * bar5_e1
    w67 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c56
    w68 = w65 - w66 * w67
    w69 = hinge5_angle / 2.0
    w70 = ca.sin(w69) / 2.0
    w71 = w70 * c57 * c58 - w70 * c59 * c60
    w72 = bar4_e1 * -2.0
    w73 = w51 * w72
    w74 = w50 * w55
    w75 = w73 - w74
    w76 = bar4_e3 * -2.0
    w77 = w55 * w76
    w78 = w51 * w52 - w77
    w79 = bar5_e1 * -2.0
    w80 = w64 * w79
    w81 = w62 * w67
    w82 = w80 - w81
    w83 = ca.cos(w69) / 2.0
    w84 = w83 * c59 * c58 - w83 * c57 * c60
    w85 = 2 * bar5_e3
    w86 = bar5_e2 * -2.0
    w87 = w64 * w85 - w67 * w86
    w88 = w83 * c61
    w89 = (w56 * w58 - w60 * w61 - w68) * w71 - (w61 * w75 + w58 * w78 + w82) * w84 + (w58 * w60 + w56 * w61 + w87) * w88
    w90 = bar5_e3 * -2.0
    w91 = w67 * w90
    w92 = w64 * w86 - w91
    w93 = w70 * c62
    w94 = w89 - (w58 * w75 - w61 * w78 - w92) * w93
    w95 = 2 * bar3_e3
    w96 = 2 * bar3_e2**2
    w97 = (1.0 - 2 * bar3_e1**2 - w96) * c63
    w98 = bar3_e2 * -2.0
    w99 = 2 * bar3_e2
    w100 = 2 * bar3_e0
    w101 = (bar3_e3 * w99 - bar3_e1 * w100) * c63
    w102 = w95 * w97 - w98 * w101
    w103 = hinge2_angle / 2.0
    w104 = ca.cos(w103)
    w105 = w104 * c16 * c19 - w104 * c18 * c17
    w106 = bar2_e1 * -2.0
    w107 = 2 * bar2_e0
    w108 = 2 * bar2_e2
    w109 = (bar2_e1 * w107 + w108 * bar2_e3) * c15
    w110 = w106 * w109
    w111 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c15
    w112 = w107 * w111
    w113 = w110 - w112
    w114 = bar3_e1 * -2.0
    w115 = w97 * w114
    w116 = w100 * w101
    w117 = w115 - w116
    w118 = w104 * c20
    w119 = w97 * w100
    w120 = 2 * bar3_e1
    w121 = w119 - w101 * w120
    w122 = ca.sin(w103)
    w123 = w122 * c22
    w124 = bar3_e3 * -2.0
    w125 = w101 * w124
    w126 = w97 * w98 - w125
    w127 = w122 * c18 * c19 - w122 * c16 * c17
    w128 = w102 * w105 - (w113 + w117 * w118 + w121 * w123) + w126 * w127
    w129 = bar1_e0 * w46 - bar1_e3 * w45
    w130 = w107 * w109
    w131 = 2 * bar2_e1
    w132 = w130 - w111 * w131
    w133 = w117 * w123 - w132 - w118 * w121 - w102 * w127 + w105 * w126
    w134 = bar1_e2 * w45 + bar1_e1 * w46
    w135 = 2 * bar2_e3
    w136 = bar2_e2 * -2.0
    w137 = w109 * w135 - w111 * w136
    w138 = w121 * w127 - (w137 + w105 * w117) - w102 * w118 + w123 * w126
    w139 = bar1_e2 * w46 - bar1_e1 * w45
    w140 = bar2_e3 * -2.0
    w141 = w111 * w140
    w142 = w109 * w136 - w141
    w143 = w142 + w117 * w127 + w105 * w121 + w102 * w123 + w118 * w126
    w144 = w128 * w129 - w133 * w134 + w138 * w139 + w47 * w143
    w145 = bar3_e2 * w100
    w146 = bar3_e3 * w120
    w147 = (w145 + w146) * c63
    w148 = w98 * w147
    w149 = w148 - w119
    w150 = (bar2_e2 * w131 - w107 * bar2_e3) * c15
    w151 = w107 * w150
    w152 = w151 - w108 * w109
    w153 = w100 * w147
    w154 = w153 - w97 * w99
    w155 = w120 * w147 - w97 * w124
    w156 = w124 * w147 - w115
    w157 = w105 * w149 - (w152 + w118 * w154 + w123 * w155) + w127 * w156
    w158 = w131 * w150 - w109 * w140
    w159 = w123 * w154 - w158 - w118 * w155 - w127 * w149 + w105 * w156
    w160 = w136 * w150
    w161 = w160 - w130
    w162 = w127 * w155 - (w161 + w105 * w154) - w118 * w149 + w123 * w156
    w163 = w140 * w150 - w110
    w164 = w163 + w127 * w154 + w105 * w155 + w123 * w149 + w118 * w156
    w165 = w129 * w157 - w134 * w159 + w139 * w162 + w47 * w164
    w166 = w116 - w95 * w147
    w167 = w108 * w111 - w106 * w150
    w168 = w99 * w101 - w114 * w147
    w169 = w125 - w153
    w170 = w101 * w114 - w148
    w171 = w105 * w166 - (w167 + w118 * w168 + w123 * w169) + w127 * w170
    w172 = w141 - w151
    w173 = w123 * w168 - w172 - w118 * w169 - w127 * w166 + w105 * w170
    w174 = w112 - w135 * w150
    w175 = w127 * w169 - (w174 + w105 * w168) - w118 * w166 + w123 * w170
    w176 = w106 * w111 - w160
    w177 = w176 + w127 * w168 + w105 * w169 + w123 * w166 + w118 * w170
    w178 = w129 * w171 - w134 * w173 + w139 * w175 + w47 * w177
    w179 = bar3_e3 * w100 + bar3_e2 * w120
    w180 = 2 * bar4_e2
    w181 = bar4_e1 * w50 + bar4_e3 * w180
    w182 = w179 * w181
    w183 = w146 - w145
    w184 = 2 * bar4_e3**2
    w185 = 1.0 - 2 * bar4_e1**2 - w184
    w186 = w183 * w185
    w187 = w182 - w186
    w188 = w54 - w53
    w189 = w183 * w188
    w190 = 1.0 - w96 - 2 * bar3_e3**2
    w191 = w181 * w190
    w192 = w189 - w191
    w193 = w185 * w190
    w194 = w179 * w188
    w195 = w193 - w194
    w196 = w99 * w187 + w114 * w192 + w100 * w195
    w197 = w124 * w187 + w100 * w192 + w120 * w195
    w198 = w100 * w187 + w95 * w192 + w98 * w195
    w199 = w114 * w187 + w98 * w192 + w124 * w195
    w200 = w118 * w196 + w123 * w197 - w105 * w198 - w127 * w199
    w201 = w118 * w197 - w123 * w196 + w127 * w198 - w105 * w199
    w202 = w105 * w196 - w127 * w197 + w118 * w198 - w123 * w199
    w203 = w127 * w196 + w105 * w197 + w123 * w198 + w118 * w199
    w204 = w129 * w200 - w134 * w201 + w139 * w202 - w47 * w203
    w205 = ca.sqrt(w144**2 + w165**2 + w178**2 + w204**2)
    w206 = w144 / w205
    w207 = (1.0 - 2 * bar4_e2**2 - w184) * c55
    w208 = w52 * w207
    w209 = w208 - w59
    w210 = w49 * w207 - w51 * w76
    w211 = (bar5_e2 * w66 - w62 * bar5_e3) * c56
    w212 = w66 * w211 - w64 * w90
    w213 = w50 * w207
    w214 = w213 - w51 * w180
    w215 = w76 * w207 - w73
    w216 = w62 * w211
    w217 = w216 - w63 * w64
    w218 = w86 * w211
    w219 = w218 - w65
    w220 = w71 * (w58 * w209 - w61 * w210 - w212) - w84 * (w61 * w214 + w58 * w215 + w217) + w88 * (w58 * w210 + w61 * w209 + w219)
    w221 = w90 * w211 - w80
    w222 = w220 - w93 * (w58 * w214 - w61 * w215 - w221)
    w223 = w165 / w205
    w224 = w74 - w48 * w207
    w225 = w77 - w213
    w226 = w91 - w216
    w227 = w55 * w180 - w72 * w207
    w228 = w55 * w72 - w208
    w229 = w63 * w67 - w79 * w211
    w230 = w81 - w85 * w211
    w231 = w71 * (w58 * w224 - w61 * w225 - w226) - w84 * (w61 * w227 + w58 * w228 + w229) + w88 * (w58 * w225 + w61 * w224 + w230)
    w232 = w67 * w79 - w218
    w233 = w231 - w93 * (w58 * w227 - w61 * w228 - w232)
    w234 = w178 / w205
    w235 = w186 - w182
    w236 = w191 - w189
    w237 = w194 - w193
    w238 = w180 * w235 + w72 * w236 + w50 * w237
    w239 = w72 * w235 + w52 * w236 + w76 * w237
    w240 = w76 * w235 + w50 * w236 + w49 * w237
    w241 = w50 * w235 + w48 * w236 + w52 * w237
    w242 = w84 * (w61 * w238 + w58 * w239) + w71 * (w61 * w240 - w58 * w241) - w88 * (w58 * w240 + w61 * w241)
    w243 = w242 - w93 * (w61 * w239 - w58 * w238)
    w244 = w204 / w205
    w245 = w94 * w206 + w222 * w223 + w233 * w234 + w243 * w244
    w246 = w94 - w206 * w245
    w247 = w122 / 2.0
    w248 = w247 * c20
    w249 = w104 / 2.0
    w250 = w249 * c22
    w251 = w247 * c18 * c17 - w247 * c16 * c19
    w252 = w249 * c18 * c19 - w249 * c16 * c17
    w253 = bar2_e0 * w248 + (bar2_e1 * w250 + bar2_e2 * w251 + bar2_e3 * w252)
    w254 = bar2_e0 * w252 - bar2_e3 * w248 + (bar2_e1 * w251 - bar2_e2 * w250)
    w255 = bar2_e0 * w251 - bar2_e2 * w248 + (bar2_e3 * w250 - bar2_e1 * w252)
    w256 = bar2_e0 * w250 - bar2_e1 * w248 + (bar2_e2 * w252 - bar2_e3 * w251)
    w257 = w126 * w253 - (w117 * w254 + w121 * w255 + w102 * w256)
    w258 = w156 * w253 - (w154 * w254 + w155 * w255 + w149 * w256)
    w259 = w170 * w253 - (w168 * w254 + w169 * w255 + w166 * w256)
    w260 = w196 * w254 + w197 * w255 + w198 * w256 - w199 * w253
    w261 = w206 * w257 + w223 * w258 + w234 * w259 + w244 * w260
    w262 = w257 - w206 * w261
    w263 = w258 - w223 * w261
    w264 = w259 - w234 * w261
    w265 = w260 - w244 * w261
    w266 = ca.sqrt(w262**2 + w263**2 + w264**2 + w265**2)
    w267 = w262 / w266
    w268 = w222 - w223 * w245
    w269 = w263 / w266
    w270 = w233 - w234 * w245
    w271 = w264 / w266
    w272 = w243 - w244 * w245
    w273 = w265 / w266
    w274 = w246 * w267 + w268 * w269 + w270 * w271 + w272 * w273
    w275 = w246 - w267 * w274
    w276 = w61 / 2.0
    w277 = w58 / 2.0
    w278 = bar5_e0 * w276 + bar5_e3 * w277
    w279 = bar5_e1 * w276 - bar5_e2 * w277
    w280 = bar5_e1 * w277 + bar5_e2 * w276
    w281 = bar5_e3 * w276 - bar5_e0 * w277
    w282 = w75 * w278 - w60 * w279 + w56 * w280 - w78 * w281
    w283 = w214 * w278 - w210 * w279 + w209 * w280 - w215 * w281
    w284 = w227 * w278 - w225 * w279 + w224 * w280 - w228 * w281
    w285 = w240 * w279 - w238 * w278 - w241 * w280 + w239 * w281
    w286 = w206 * w282 + w223 * w283 + w234 * w284 + w244 * w285
    w287 = w282 - w206 * w286
    w288 = w283 - w223 * w286
    w289 = w284 - w234 * w286
    w290 = w285 - w244 * w286
    w291 = w267 * w287 + w269 * w288 + w271 * w289 + w273 * w290
    w292 = w287 - w267 * w291
    w293 = w288 - w269 * w291
    w294 = w289 - w271 * w291
    w295 = w290 - w273 * w291
    w296 = ca.sqrt(w292**2 + w293**2 + w294**2 + w295**2)
    w297 = w292 / w296
    w298 = w268 - w269 * w274
    w299 = w293 / w296
    w300 = w270 - w271 * w274
    w301 = w294 / w296
    w302 = w272 - w273 * w274
    w303 = w295 / w296
    w304 = w275 * w297 + w298 * w299 + w300 * w301 + w302 * w303
    w305 = w275 - w297 * w304
    w306 = w298 - w299 * w304
    w307 = w300 - w301 * w304
    w308 = w302 - w303 * w304
    w309 = ca.sqrt(w305**2 + w306**2 + w307**2 + w308**2)
    w310 = w9 * (w43 * w128 - w26 + w44 * w143) - w7 * (w43 * w133 - w22 + w44 * w138) + w4 * (w43 * w138 - (w17 + w44 * w133))
    w311 = w310 - w2 * (w44 * w128 - w20 - w43 * w143)
    w312 = w9 * (w43 * w157 - w35 + w44 * w164) - w7 * (w43 * w159 - w32 + w44 * w162) + w4 * (w43 * w162 - (w30 + w44 * w159))
    w313 = w312 - w2 * (w44 * w157 - w31 - w43 * w164)
    w314 = w9 * (w43 * w171 - w40 + w44 * w177) - w7 * (w43 * w173 - w39 + w44 * w175) + w4 * (w43 * w175 - (w37 + w44 * w173))
    w315 = w314 - w2 * (w44 * w171 - w38 - w43 * w177)
    w316 = w9 * (w43 * w200 - w44 * w203) - w7 * (w43 * w201 + w44 * w202) + w4 * (w43 * w202 - w44 * w201) - w2 * (w44 * w200 + w43 * w203)
    w317 = (w305 / w309 * w311 + w306 / w309 * w313 + w307 / w309 * w315 + w308 / w309 * w316) / w309
    w318 = (w304 * w317 - (w297 * w311 + w299 * w313 + w301 * w315 + w303 * w316)) / w296
    w319 = (w274 * w317 - (w267 * w311 + w269 * w313 + w271 * w315 + w273 * w316) - w291 * w318) / w266
    w320 = w245 * w317 - (w206 * w311 + w223 * w313 + w234 * w315 + w244 * w316) - w286 * w318 - w261 * w319
    w321 = hinge0_angle_dot * (w320 / w205)
    w322 = w3 * w43 + w10 * w44 + w47 * w321
    w323 = w5 * w43 - w8 * w44 + w139 * w321
    w324 = w5 * w44 + w8 * w43 + w134 * w321
    w325 = w10 * w43 - w3 * w44 + w129 * w321
    w326 = hinge0_angle_dot * w319
    w327 = hinge0_angle_dot * w317
    w328 = w93 * w327
    w329 = w84 * w327
    w330 = hinge0_angle_dot * w318
    w331 = w58 * w328 + w61 * w329 + w278 * w330
    w332 = w61 * w328 - w58 * w329 + w281 * w330
    w333 = w88 * w327
    w334 = w71 * w327
    w335 = w61 * w333 + w58 * w334 - w280 * w330
    w336 = w58 * w333 - w61 * w334 + w279 * w330
    w337 = w68 * w334 - (w92 * w328 + w87 * w333) + w82 * w329
    w338 = w212 * w334 - (w221 * w328 + w219 * w333) + w217 * w329
    w339 = w226 * w334 - (w232 * w328 + w230 * w333) + w229 * w329
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        -w3,
        w5,
        -w8,
        w10,
        w27,
        w36,
        w41,
        -w322,
        w323,
        -w324,
        w325,
        w27 - w142 * w322 + w137 * w323 - w132 * w324 + w113 * w325,
        w36 - w163 * w322 + w161 * w323 - w158 * w324 + w152 * w325,
        w41 - w176 * w322 + w174 * w323 - w172 * w324 + w167 * w325,
        w105 * w324 - (w118 * w322 + w123 * w323) - w127 * w325 - w253 * w326,
        w118 * w323 - w123 * w322 - w127 * w324 - w105 * w325 + w256 * w326,
        w123 * w325 - (w105 * w322 + w127 * w323 + w118 * w324) + w255 * w326,
        w105 * w323 - w127 * w322 + w123 * w324 + w118 * w325 + w254 * w326,
        w75 * w331 - (w78 * w332 + w56 * w335 + w60 * w336) + w337,
        w214 * w331 - (w215 * w332 + w209 * w335 + w210 * w336) + w338,
        w227 * w331 - (w228 * w332 + w224 * w335 + w225 * w336) + w339,
        w332,
        w335,
        w336,
        -w331,
        w337,
        w338,
        w339,
        w328,
        w333,
        -w334,
        -w329,
        w321,
        w326,
        w330,
        -w327,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 2025 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    bar3_e0_dot = q_d_dot[17]
    bar3_e1_dot = q_d_dot[18]
    bar3_e2_dot = q_d_dot[19]
    bar3_e3_dot = q_d_dot[20]
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c10 = c[10]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c42 = c[42]
    c51 = c[51]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    w0 = (hinge0_angle_dot / 2.0)**2
    w1 = hinge0_angle / 2.0
    w2 = ca.cos(w1)
    w3 = w0 * w2
    w4 = w3 * c51
    w5 = ca.sin(w1)
    w6 = w5 / 2.0
    w7 = w6 * c51
    w8 = w4 + w7 * hinge0_angle_ddot
    w9 = w3 * c1 * c3 - w3 * c2 * c0
    w10 = w6 * c1 * c3 - w6 * c2 * c0
    w11 = w9 + hinge0_angle_ddot * w10
    w12 = w0 * w5
    w13 = w12 * c42
    w14 = w2 / 2.0
    w15 = w14 * c42
    w16 = w13 - hinge0_angle_ddot * w15
    w17 = w12 * c2 * c3 - w12 * c1 * c0
    w18 = w14 * c1 * c0 - w14 * c2 * c3
    w19 = w17 + hinge0_angle_ddot * w18
    w20 = bar1_e2 * -2.0
    w21 = 2 * bar1_e3
    w22 = 2 * bar1_e0
    w23 = bar1_e1 * -2.0
    w24 = bar1_e0_dot * w20 + bar1_e1_dot * w21 + bar1_e2_dot * w22 + bar1_e3_dot * w23
    w25 = bar1_e3 * -2.0
    w26 = 2 * bar1_e2
    w27 = bar1_e0_dot * w23 + bar1_e1_dot * w22 + bar1_e2_dot * w25 + bar1_e3_dot * w26
    w28 = 2 * bar1_e1
    w29 = (bar1_e3 * w22 + bar1_e2 * w28) * c10
    w30 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c10
    w31 = w27 * w29 - w24 * w30
    w32 = bar1_e0_dot * w25 + w20 * bar1_e1_dot + bar1_e2_dot * w28 + w22 * bar1_e3_dot
    w33 = (bar1_e3 * w28 - bar1_e2 * w22) * c10
    w34 = w30 * w32 - w27 * w33
    w35 = w24 * w31 - w32 * w34
    w36 = w25 * w29
    w37 = w20 * w33 - w36
    w38 = w21 * w33 - w20 * w29
    w39 = w22 * w33
    w40 = w39 - w28 * w29
    w41 = w23 * w33
    w42 = w22 * w29
    w43 = w41 - w42
    w44 = w35 - w8 * w37 + w11 * w38 + w16 * w40 + w19 * w43
    w45 = w24 * w33 - w29 * w32
    w46 = w32 * w45 - w27 * w31
    w47 = w25 * w30 - w41
    w48 = w20 * w30
    w49 = w48 - w39
    w50 = w28 * w30 - w25 * w33
    w51 = w22 * w30
    w52 = w51 - w26 * w33
    w53 = w46 - w8 * w47 + w11 * w49 + w16 * w50 + w19 * w52
    w54 = w27 * w34 - w24 * w45
    w55 = w23 * w29 - w48
    w56 = w42 - w21 * w30
    w57 = w36 - w51
    w58 = w26 * w29 - w23 * w30
    w59 = w54 - w8 * w55 + w11 * w56 + w16 * w57 + w19 * w58
    w60 = (hinge1_angle_dot / 2.0)**2
    w61 = hinge1_angle / 2.0
    w62 = ca.sin(w61)
    w63 = w60 * w62
    w64 = ca.cos(w61)
    w65 = w60 * w64
    w66 = w62 / 2.0
    w67 = hinge1_angle_dot * w66
    w68 = w64 / 2.0
    w69 = hinge1_angle_dot * w68
    w70 = bar1_e0_dot * w67 + bar1_e3_dot * w69
    w71 = bar1_e3 * w63 - bar1_e0 * w65 - w70 - w70
    w72 = bar1_e0 * w66 + bar1_e3 * w68
    w73 = 2 * bar3_e3
    w74 = 2 * bar3_e2**2
    w75 = (1.0 - 2 * bar3_e1**2 - w74) * c63
    w76 = bar3_e2 * -2.0
    w77 = 2 * bar3_e2
    w78 = 2 * bar3_e0
    w79 = (bar3_e3 * w77 - bar3_e1 * w78) * c63
    w80 = w73 * w75 - w76 * w79
    w81 = hinge2_angle / 2.0
    w82 = ca.cos(w81)
    w83 = w82 * c16 * c19 - w82 * c18 * c17
    w84 = bar2_e1 * -2.0
    w85 = 2 * bar2_e0
    w86 = 2 * bar2_e2
    w87 = (bar2_e1 * w85 + w86 * bar2_e3) * c15
    w88 = w84 * w87
    w89 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c15
    w90 = w85 * w89
    w91 = w88 - w90
    w92 = bar3_e1 * -2.0
    w93 = w75 * w92
    w94 = w78 * w79
    w95 = w93 - w94
    w96 = w82 * c20
    w97 = w75 * w78
    w98 = 2 * bar3_e1
    w99 = w97 - w79 * w98
    w100 = ca.sin(w81)
    w101 = w100 * c22
    w102 = bar3_e3 * -2.0
    w103 = w79 * w102
    w104 = w75 * w76 - w103
    w105 = w100 * c18 * c19 - w100 * c16 * c17
    w106 = w80 * w83 - (w91 + w95 * w96 + w99 * w101) + w104 * w105
    w107 = bar1_e0 * w68 - bar1_e3 * w66
    w108 = w85 * w87
    w109 = 2 * bar2_e1
    w110 = w108 - w89 * w109
    w111 = w95 * w101 - w110 - w96 * w99 - w80 * w105 + w83 * w104
    w112 = bar1_e2 * w66 + bar1_e1 * w68
    w113 = 2 * bar2_e3
    w114 = bar2_e2 * -2.0
    w115 = w87 * w113 - w89 * w114
    w116 = w99 * w105 - (w115 + w83 * w95) - w80 * w96 + w101 * w104
    w117 = bar1_e2 * w68 - bar1_e1 * w66
    w118 = bar2_e3 * -2.0
    w119 = w89 * w118
    w120 = w87 * w114 - w119
    w121 = w120 + w95 * w105 + w83 * w99 + w80 * w101 + w96 * w104
    w122 = w106 * w107 - w111 * w112 + w116 * w117 + w72 * w121
    w123 = bar3_e2 * w78
    w124 = bar3_e3 * w98
    w125 = (w123 + w124) * c63
    w126 = w76 * w125
    w127 = w126 - w97
    w128 = (bar2_e2 * w109 - w85 * bar2_e3) * c15
    w129 = w85 * w128
    w130 = w129 - w86 * w87
    w131 = w78 * w125
    w132 = w131 - w75 * w77
    w133 = w98 * w125 - w75 * w102
    w134 = w102 * w125 - w93
    w135 = w83 * w127 - (w130 + w96 * w132 + w101 * w133) + w105 * w134
    w136 = w109 * w128 - w87 * w118
    w137 = w101 * w132 - w136 - w96 * w133 - w105 * w127 + w83 * w134
    w138 = w114 * w128
    w139 = w138 - w108
    w140 = w105 * w133 - (w139 + w83 * w132) - w96 * w127 + w101 * w134
    w141 = w118 * w128 - w88
    w142 = w141 + w105 * w132 + w83 * w133 + w101 * w127 + w96 * w134
    w143 = w107 * w135 - w112 * w137 + w117 * w140 + w72 * w142
    w144 = w94 - w73 * w125
    w145 = w86 * w89 - w84 * w128
    w146 = w77 * w79 - w92 * w125
    w147 = w103 - w131
    w148 = w79 * w92 - w126
    w149 = w83 * w144 - (w145 + w96 * w146 + w101 * w147) + w105 * w148
    w150 = w119 - w129
    w151 = w101 * w146 - w150 - w96 * w147 - w105 * w144 + w83 * w148
    w152 = w90 - w113 * w128
    w153 = w105 * w147 - (w152 + w83 * w146) - w96 * w144 + w101 * w148
    w154 = w84 * w89 - w138
    w155 = w154 + w105 * w146 + w83 * w147 + w101 * w144 + w96 * w148
    w156 = w107 * w149 - w112 * w151 + w117 * w153 + w72 * w155
    w157 = bar3_e3 * w78 + bar3_e2 * w98
    w158 = 2 * bar4_e0
    w159 = 2 * bar4_e2
    w160 = w158 * bar4_e1 + w159 * bar4_e3
    w161 = w157 * w160
    w162 = w124 - w123
    w163 = 2 * bar4_e3**2
    w164 = 1.0 - 2 * bar4_e1**2 - w163
    w165 = w162 * w164
    w166 = w161 - w165
    w167 = 2 * bar4_e1
    w168 = bar4_e2 * w167
    w169 = w158 * bar4_e3
    w170 = w168 - w169
    w171 = w162 * w170
    w172 = 1.0 - w74 - 2 * bar3_e3**2
    w173 = w160 * w172
    w174 = w171 - w173
    w175 = w164 * w172
    w176 = w157 * w170
    w177 = w175 - w176
    w178 = w77 * w166 + w92 * w174 + w78 * w177
    w179 = w102 * w166 + w78 * w174 + w98 * w177
    w180 = w78 * w166 + w73 * w174 + w76 * w177
    w181 = w92 * w166 + w76 * w174 + w102 * w177
    w182 = w96 * w178 + w101 * w179 - w83 * w180 - w105 * w181
    w183 = w96 * w179 - w101 * w178 + w105 * w180 - w83 * w181
    w184 = w83 * w178 - w105 * w179 + w96 * w180 - w101 * w181
    w185 = w105 * w178 + w83 * w179 + w101 * w180 + w96 * w181
    w186 = w107 * w182 - w112 * w183 + w117 * w184 - w72 * w185
    w187 = ca.sqrt(w122**2 + w143**2 + w156**2 + w186**2)
    w188 = w122 / w187
    w189 = w76 * bar3_e0_dot + w73 * bar3_e1_dot + w78 * bar3_e2_dot + w92 * bar3_e3_dot
    w190 = w92 * bar3_e0_dot + w78 * bar3_e1_dot + w102 * bar3_e2_dot + w77 * bar3_e3_dot
    w191 = w79 * w190 - w125 * w189
    w192 = w102 * bar3_e0_dot + w76 * bar3_e1_dot + w98 * bar3_e2_dot + w78 * bar3_e3_dot
    w193 = w125 * w192 - w75 * w190
    w194 = w114 * bar2_e0_dot + w113 * bar2_e1_dot + w85 * bar2_e2_dot + w84 * bar2_e3_dot
    w195 = w84 * bar2_e0_dot + w85 * bar2_e1_dot + w118 * bar2_e2_dot + w86 * bar2_e3_dot
    w196 = w89 * w195 - w128 * w194
    w197 = w118 * bar2_e0_dot + w114 * bar2_e1_dot + w109 * bar2_e2_dot + w85 * bar2_e3_dot
    w198 = w128 * w197 - w87 * w195
    w199 = w194 * w196 - w197 * w198
    w200 = hinge2_angle_dot / 2.0
    w201 = w200**2
    w202 = w100 * w201
    w203 = w202 * c16 * c17 - w202 * c18 * c19
    w204 = w82 * w201
    w205 = w200 * (w82 * w200) * c20
    w206 = w204 * c18 * c17 - w204 * c16 * c19
    w207 = w200 * (w100 * w200) * c22
    w208 = w82 / 2.0
    w209 = hinge2_angle_dot * w208
    w210 = w209 * c18 * c19 - w209 * c16 * c17
    w211 = w100 / 2.0
    w212 = hinge2_angle_dot * w211
    w213 = w212 * c20
    w214 = w212 * c18 * c17 - w212 * c16 * c19
    w215 = w209 * c22
    w216 = bar2_e0_dot * w210 - bar2_e3_dot * w213 + (bar2_e1_dot * w214 - bar2_e2_dot * w215)
    w217 = w216 + (bar2_e0 * w203 - bar2_e3 * w205 + (bar2_e1 * w206 + bar2_e2 * w207) + w216)
    w218 = bar2_e0_dot * w214 - bar2_e2_dot * w213 + (bar2_e3_dot * w215 - bar2_e1_dot * w210)
    w219 = w218 + (bar2_e0 * w206 - bar2_e2 * w205 - (bar2_e3 * w207 + bar2_e1 * w203) + w218)
    w220 = bar2_e0_dot * w215 - bar2_e1_dot * w213 + (bar2_e2_dot * w210 - bar2_e3_dot * w214)
    w221 = w220 + (bar2_e2 * w203 - bar2_e3 * w206 - (bar2_e0 * w207 + bar2_e1 * w205) + w220)
    w222 = bar2_e0_dot * w213 + (bar2_e1_dot * w215 + bar2_e2_dot * w214 + bar2_e3_dot * w210)
    w223 = w222 + (bar2_e0 * w205 + (bar2_e2 * w206 - bar2_e1 * w207 + bar2_e3 * w203) + w222)
    w224 = bar4_e2 * -2.0
    w225 = 2 * bar4_e3
    w226 = bar4_e1 * -2.0
    w227 = bar4_e0_dot * w224 + bar4_e1_dot * w225 + w158 * bar4_e2_dot + bar4_e3_dot * w226
    w228 = bar4_e3 * -2.0
    w229 = bar4_e0_dot * w226 + w158 * bar4_e1_dot + bar4_e2_dot * w228 + w159 * bar4_e3_dot
    w230 = (w168 + w169) * c55
    w231 = (1.0 - 2 * bar4_e2**2 - w163) * c55
    w232 = w229 * w230 - w227 * w231
    w233 = bar4_e0_dot * w228 + w224 * bar4_e1_dot + w167 * bar4_e2_dot + w158 * bar4_e3_dot
    w234 = (bar4_e3 * w167 - w158 * bar4_e2) * c55
    w235 = w231 * w233 - w229 * w234
    w236 = w227 * w232 - w233 * w235
    w237 = w226 * w234
    w238 = w158 * w230
    w239 = w237 - w238
    w240 = (hinge4_angle_dot / 2.0)**2
    w241 = hinge4_angle / 2.0
    w242 = ca.sin(w241)
    w243 = w240 * w242
    w244 = ca.cos(w241)
    w245 = w240 * w244
    w246 = w244 / 2.0
    w247 = hinge4_angle_dot * w246
    w248 = w242 / 2.0
    w249 = hinge4_angle_dot * w248
    w250 = bar5_e0_dot * w247 + w249 * bar5_e3_dot
    w251 = bar5_e0 * w243 - w245 * bar5_e3 - w250 - w250
    w252 = w189 * w191 - w192 * w193 + w199 + w95 * w217 + w99 * w219 + w80 * w221 - w104 * w223 + w236 + w239 * w251
    w253 = w158 * w234
    w254 = w253 - w167 * w230
    w255 = w247 * bar5_e1_dot - w249 * bar5_e2_dot
    w256 = w255 + (w255 - (w245 * bar5_e2 + w243 * bar5_e1))
    w257 = w225 * w234 - w224 * w230
    w258 = w249 * bar5_e1_dot + w247 * bar5_e2_dot
    w259 = w243 * bar5_e2 - w245 * bar5_e1 - w258 - w258
    w260 = w228 * w230
    w261 = w224 * w234 - w260
    w262 = w247 * bar5_e3_dot - bar5_e0_dot * w249
    w263 = w262 + (w262 - (bar5_e0 * w245 + w243 * bar5_e3))
    w264 = bar1_e0_dot * w69 - bar1_e3_dot * w67
    w265 = w264 + (w264 - (bar1_e0 * w63 + bar1_e3 * w65))
    w266 = bar1_e2_dot * w67 + bar1_e1_dot * w69
    w267 = bar1_e1 * w63 - bar1_e2 * w65 - w266 - w266
    w268 = bar1_e2_dot * w69 - bar1_e1_dot * w67
    w269 = w268 + (w268 - (bar1_e1 * w65 + bar1_e2 * w63))
    w270 = w35 + (w252 + w254 * w256 + w257 * w259 + w261 * w263) - w106 * w265 - w111 * w267 - w116 * w269 + w71 * w121
    w271 = bar5_e2 * -2.0
    w272 = 2 * bar5_e3
    w273 = 2 * bar5_e0
    w274 = bar5_e1 * -2.0
    w275 = bar5_e0_dot * w271 + bar5_e1_dot * w272 + bar5_e2_dot * w273 + bar5_e3_dot * w274
    w276 = bar5_e3 * -2.0
    w277 = 2 * bar5_e2
    w278 = bar5_e0_dot * w274 + bar5_e1_dot * w273 + bar5_e2_dot * w276 + bar5_e3_dot * w277
    w279 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c56
    w280 = 2 * bar5_e1
    w281 = (bar5_e2 * w280 - bar5_e3 * w273) * c56
    w282 = w278 * w279 - w275 * w281
    w283 = bar5_e0_dot * w276 + bar5_e1_dot * w271 + bar5_e2_dot * w280 + bar5_e3_dot * w273
    w284 = (bar5_e1 * w273 + bar5_e3 * w277) * c56
    w285 = w281 * w283 - w278 * w284
    w286 = w275 * w282 - w283 * w285
    w287 = w274 * w284
    w288 = w273 * w279
    w289 = w287 - w288
    w290 = w239 * w244 + w242 * w261 + w289
    w291 = (hinge5_angle_dot / 2.0)**2
    w292 = hinge5_angle / 2.0
    w293 = ca.sin(w292)
    w294 = w291 * w293
    w295 = w294 * c57 * c60 - w294 * c59 * c58
    w296 = w273 * w284
    w297 = w296 - w279 * w280
    w298 = w242 * w257 - w244 * w254 - w297
    w299 = ca.cos(w292)
    w300 = w291 * w299
    w301 = w300 * c57 * c58 - w300 * c59 * c60
    w302 = w272 * w284 - w271 * w279
    w303 = w242 * w254 + w244 * w257 + w302
    w304 = w294 * c61
    w305 = w276 * w279
    w306 = w271 * w284 - w305
    w307 = w239 * w242 - w244 * w261 - w306
    w308 = w300 * c62
    w309 = w64 * w106 - w43 + w62 * w121
    w310 = w64 * w111 - w40 + w62 * w116
    w311 = w64 * w116 - (w38 + w62 * w111)
    w312 = w270 + w286 + w290 * w295 - w298 * w301 + w303 * w304 + w307 * w308 - w17 * w309 - w13 * w310 - w9 * w311
    w313 = w62 * w106 - w37 - w64 * w121
    w314 = w312 + w4 * w313
    w315 = w143 / w187
    w316 = w75 * w189 - w79 * w192
    w317 = w87 * w194 - w89 * w197
    w318 = w197 * w317 - w195 * w196
    w319 = w227 * w234 - w230 * w233
    w320 = w233 * w319 - w229 * w232
    w321 = w158 * w231
    w322 = w321 - w159 * w234
    w323 = w192 * w316 - w190 * w191 + w318 + w132 * w217 + w133 * w219 + w127 * w221 - w134 * w223 + w320 + w251 * w322
    w324 = w167 * w231 - w228 * w234
    w325 = w224 * w231
    w326 = w325 - w253
    w327 = w228 * w231 - w237
    w328 = w46 + (w323 + w256 * w324 + w259 * w326 + w263 * w327) - w135 * w265 - w137 * w267 - w140 * w269 + w71 * w142
    w329 = w275 * w284 - w279 * w283
    w330 = w283 * w329 - w278 * w282
    w331 = w273 * w281
    w332 = w331 - w277 * w284
    w333 = w244 * w322 + w242 * w327 + w332
    w334 = w280 * w281 - w276 * w284
    w335 = w242 * w326 - w244 * w324 - w334
    w336 = w271 * w281
    w337 = w336 - w296
    w338 = w242 * w324 + w244 * w326 + w337
    w339 = w276 * w281 - w287
    w340 = w242 * w322 - w244 * w327 - w339
    w341 = w64 * w135 - w52 + w62 * w142
    w342 = w64 * w137 - w50 + w62 * w140
    w343 = w64 * w140 - (w49 + w62 * w137)
    w344 = w328 + w330 + w295 * w333 - w301 * w335 + w304 * w338 + w308 * w340 - w17 * w341 - w13 * w342 - w9 * w343
    w345 = w62 * w135 - w47 - w64 * w142
    w346 = w344 + w4 * w345
    w347 = w156 / w187
    w348 = w195 * w198 - w194 * w317
    w349 = w229 * w235 - w227 * w319
    w350 = w159 * w230 - w226 * w231
    w351 = w190 * w193 - w189 * w316 + w348 + w146 * w217 + w147 * w219 + w144 * w221 - w148 * w223 + w349 + w251 * w350
    w352 = w260 - w321
    w353 = w238 - w225 * w231
    w354 = w226 * w230 - w325
    w355 = w54 + (w351 + w256 * w352 + w259 * w353 + w263 * w354) - w149 * w265 - w151 * w267 - w153 * w269 + w71 * w155
    w356 = w278 * w285 - w275 * w329
    w357 = w277 * w279 - w274 * w281
    w358 = w244 * w350 + w242 * w354 + w357
    w359 = w305 - w331
    w360 = w242 * w353 - w244 * w352 - w359
    w361 = w288 - w272 * w281
    w362 = w242 * w352 + w244 * w353 + w361
    w363 = w274 * w279 - w336
    w364 = w242 * w350 - w244 * w354 - w363
    w365 = w64 * w149 - w58 + w62 * w155
    w366 = w64 * w151 - w57 + w62 * w153
    w367 = w64 * w153 - (w56 + w62 * w151)
    w368 = w355 + w356 + w295 * w358 - w301 * w360 + w304 * w362 + w308 * w364 - w17 * w365 - w13 * w366 - w9 * w367
    w369 = w62 * w149 - w55 - w64 * w155
    w370 = w368 + w4 * w369
    w371 = w186 / w187
    w372 = w164 * w229 - w170 * w227
    w373 = w170 * w233 - w160 * w229
    w374 = w160 * w227 - w164 * w233
    w375 = w172 * (w227 * w372 - w233 * w373) + w157 * (w233 * w374 - w229 * w372) + w162 * (w229 * w373 - w227 * w374)
    w376 = w157 * w190 - w172 * w189
    w377 = w172 * w192 - w162 * w190
    w378 = w162 * w189 - w157 * w192
    w379 = w375 + w170 * (w189 * w376 - w192 * w377) + w164 * (w192 * w378 - w190 * w376) + w160 * (w190 * w377 - w189 * w378)
    w380 = w379 + w374 * (2 * w378) + w373 * (2 * w377) + w372 * (2 * w376) + w178 * w217 + w179 * w219 + w180 * w221
    w381 = w165 - w161
    w382 = w173 - w171
    w383 = w176 - w175
    w384 = w159 * w381 + w226 * w382 + w158 * w383
    w385 = w228 * w381 + w158 * w382 + w167 * w383
    w386 = w158 * w381 + w225 * w382 + w224 * w383
    w387 = w226 * w381 + w224 * w382 + w228 * w383
    w388 = w181 * w223 - w380 - w251 * w384 - w256 * w385 - w259 * w386 - w263 * w387 - w182 * w265 - w183 * w267
    w389 = w244 * w384 + w242 * w387
    w390 = w244 * w385 - w242 * w386
    w391 = w242 * w385 + w244 * w386
    w392 = w244 * w387 - w242 * w384
    w393 = w64 * w182 - w62 * w185
    w394 = w388 - w184 * w269 - w71 * w185 - w295 * w389 - w301 * w390 - w304 * w391 + w308 * w392 - w17 * w393
    w395 = w64 * w183 + w62 * w184
    w396 = w64 * w184 - w62 * w183
    w397 = w62 * w182 + w64 * w185
    w398 = w394 - w13 * w395 - w9 * w396 + w4 * w397
    w399 = w293 / 2.0
    w400 = w399 * c57 * c58 - w399 * c59 * c60
    w401 = w299 / 2.0
    w402 = w401 * c59 * c58 - w401 * c57 * c60
    w403 = w401 * c61
    w404 = w399 * c62
    w405 = w298 * w400 - w290 * w402 + w303 * w403 - w307 * w404
    w406 = w335 * w400 - w333 * w402 + w338 * w403 - w340 * w404
    w407 = w360 * w400 - w358 * w402 + w362 * w403 - w364 * w404
    w408 = w389 * w402 + w390 * w400 - w391 * w403 - w392 * w404
    w409 = w188 * w405 + w315 * w406 + w347 * w407 + w371 * w408
    w410 = w405 - w188 * w409
    w411 = w211 * c20
    w412 = w208 * c22
    w413 = w211 * c18 * c17 - w211 * c16 * c19
    w414 = w208 * c18 * c19 - w208 * c16 * c17
    w415 = bar2_e0 * w411 + (bar2_e1 * w412 + bar2_e2 * w413 + bar2_e3 * w414)
    w416 = bar2_e0 * w414 - bar2_e3 * w411 + (bar2_e1 * w413 - bar2_e2 * w412)
    w417 = bar2_e0 * w413 - bar2_e2 * w411 + (bar2_e3 * w412 - bar2_e1 * w414)
    w418 = bar2_e0 * w412 - bar2_e1 * w411 + (bar2_e2 * w414 - bar2_e3 * w413)
    w419 = w104 * w415 - (w95 * w416 + w99 * w417 + w80 * w418)
    w420 = w134 * w415 - (w132 * w416 + w133 * w417 + w127 * w418)
    w421 = w148 * w415 - (w146 * w416 + w147 * w417 + w144 * w418)
    w422 = w178 * w416 + w179 * w417 + w180 * w418 - w181 * w415
    w423 = w188 * w419 + w315 * w420 + w347 * w421 + w371 * w422
    w424 = w419 - w188 * w423
    w425 = w420 - w315 * w423
    w426 = w421 - w347 * w423
    w427 = w422 - w371 * w423
    w428 = ca.sqrt(w424**2 + w425**2 + w426**2 + w427**2)
    w429 = w424 / w428
    w430 = w406 - w315 * w409
    w431 = w425 / w428
    w432 = w407 - w347 * w409
    w433 = w426 / w428
    w434 = w408 - w371 * w409
    w435 = w427 / w428
    w436 = w410 * w429 + w430 * w431 + w432 * w433 + w434 * w435
    w437 = w410 - w429 * w436
    w438 = bar5_e0 * w246 + bar5_e3 * w248
    w439 = w246 * bar5_e1 - w248 * bar5_e2
    w440 = w248 * bar5_e1 + w246 * bar5_e2
    w441 = bar5_e3 * w246 - bar5_e0 * w248
    w442 = w239 * w438 - w254 * w439 + w257 * w440 - w261 * w441
    w443 = w322 * w438 - w324 * w439 + w326 * w440 - w327 * w441
    w444 = w350 * w438 - w352 * w439 + w353 * w440 - w354 * w441
    w445 = w385 * w439 - w384 * w438 - w386 * w440 + w387 * w441
    w446 = w188 * w442 + w315 * w443 + w347 * w444 + w371 * w445
    w447 = w442 - w188 * w446
    w448 = w443 - w315 * w446
    w449 = w444 - w347 * w446
    w450 = w445 - w371 * w446
    w451 = w429 * w447 + w431 * w448 + w433 * w449 + w435 * w450
    w452 = w447 - w429 * w451
    w453 = w448 - w431 * w451
    w454 = w449 - w433 * w451
    w455 = w450 - w435 * w451
    w456 = ca.sqrt(w452**2 + w453**2 + w454**2 + w455**2)
    w457 = w452 / w456
    w458 = w430 - w431 * w436
    w459 = w453 / w456
    w460 = w432 - w433 * w436
    w461 = w454 / w456
    w462 = w434 - w435 * w436
    w463 = w455 / w456
    w464 = w437 * w457 + w458 * w459 + w460 * w461 + w462 * w463
    w465 = w437 - w457 * w464
    w466 = w458 - w459 * w464
    w467 = w460 - w461 * w464
    w468 = w462 - w463 * w464
    w469 = ca.sqrt(w465**2 + w466**2 + w467**2 + w468**2)
    w470 = w465 / w469
    w471 = w466 / w469
    w472 = w467 / w469
    w473 = w468 / w469
    w474 = (w314 * w470 + w346 * w471 + w370 * w472 + w398 * w473) / w469
    w475 = (w314 * w457 + w346 * w459 + w370 * w461 + w398 * w463 - w464 * w474) / w456
    w476 = (w314 * w429 + w346 * w431 + w370 * w433 + w398 * w435 - w436 * w474 - w451 * w475) / w428
    w477 = (w188 * w314 + w315 * w346 + w347 * w370 + w371 * w398 - w409 * w474 - w446 * w475 - w423 * w476) / w187
    w478 = w18 * w309 - w15 * w310 + w10 * w311 - w7 * w313
    w479 = w18 * w341 - w15 * w342 + w10 * w343 - w7 * w345
    w480 = w18 * w365 - w15 * w366 + w10 * w367 - w7 * w369
    w481 = w18 * w393 - w15 * w395 + w10 * w396 - w7 * w397
    w482 = (w470 * w478 + w471 * w479 + w472 * w480 + w473 * w481) / w469
    w483 = (w464 * w482 - (w457 * w478 + w459 * w479 + w461 * w480 + w463 * w481)) / w456
    w484 = (w436 * w482 - (w429 * w478 + w431 * w479 + w433 * w480 + w435 * w481) - w451 * w483) / w428
    w485 = w409 * w482 - (w188 * w478 + w315 * w479 + w347 * w480 + w371 * w481) - w446 * w483 - w423 * w484
    w486 = w477 + hinge0_angle_ddot * (w485 / w187)
    w487 = w71 - w8 * w64 - w19 * w62 - w72 * w486
    w488 = w269 + w11 * w64 + w16 * w62 + w117 * w486
    w489 = w267 - w11 * w62 + w16 * w64 - w112 * w486
    w490 = w265 - w8 * w62 + w19 * w64 + w107 * w486
    w491 = w476 + hinge0_angle_ddot * w484
    w492 = w474 - hinge0_angle_ddot * w482
    w493 = w308 + w404 * w492
    w494 = w304 - w403 * w492
    w495 = w301 + w400 * w492
    w496 = w295 + w402 * w492
    w497 = w306 * w493 - w286 - w302 * w494 - w297 * w495 - w289 * w496
    w498 = w475 + hinge0_angle_ddot * w483
    w499 = w263 - w244 * w493 + w242 * w496 + w441 * w498
    w500 = w259 + w244 * w494 - w242 * w495 - w440 * w498
    w501 = w256 + w242 * w494 + w244 * w495 + w439 * w498
    w502 = w251 + w242 * w493 + w244 * w496 - w438 * w498
    w503 = w339 * w493 - w330 - w337 * w494 - w334 * w495 - w332 * w496
    w504 = w363 * w493 - w356 - w361 * w494 - w359 * w495 - w357 * w496
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        -w8,
        w11,
        w16,
        w19,
        w44,
        w53,
        w59,
        w487,
        w488,
        w489,
        w490,
        w44 + w199 + w120 * w487 + w115 * w488 + w110 * w489 + w91 * w490,
        w53 + w318 + w141 * w487 + w139 * w488 + w136 * w489 + w130 * w490,
        w59 + w348 + w154 * w487 + w152 * w488 + w150 * w489 + w145 * w490,
        w96 * w487 - w223 - w101 * w488 - w83 * w489 - w105 * w490 - w415 * w491,
        w221 + w101 * w487 + w96 * w488 + w105 * w489 - w83 * w490 + w418 * w491,
        w219 + w83 * w487 - w105 * w488 + w96 * w489 + w101 * w490 + w417 * w491,
        w217 + w105 * w487 + w83 * w488 - w101 * w489 + w96 * w490 + w416 * w491,
        w497 - (w236 + w261 * w499 + w257 * w500 + w254 * w501 + w239 * w502),
        w503 - (w320 + w327 * w499 + w326 * w500 + w324 * w501 + w322 * w502),
        w504 - (w349 + w354 * w499 + w353 * w500 + w352 * w501 + w350 * w502),
        w499,
        w500,
        w501,
        w502,
        w497,
        w503,
        w504,
        -w493,
        w494,
        w495,
        w496,
        w486,
        w491,
        w498,
        w492,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 3083 operations."""
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 154)
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c10 = c[10]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c42 = c[42]
    c51 = c[51]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c99 = c[99]
    c100 = c[100]
    c101 = c[101]
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = ca.sin(w0)
    w3 = hinge1_angle / 2.0
    w4 = ca.cos(w3)
    w5 = ca.sin(w3)
    w6 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c10
    w7 = 2 * bar1_e0
    w8 = 2 * bar1_e1
    w9 = (bar1_e3 * w7 + bar1_e2 * w8) * c10
    w10 = (bar1_e3 * w8 - bar1_e2 * w7) * c10
    w11 = hinge2_angle / 2.0
    w12 = ca.cos(w11)
    w13 = w12 * c20
    w14 = ca.sin(w11)
    w15 = w14 * c22
    w16 = w12 * c16 * c19 - w12 * c18 * c17
    w17 = w14 * c18 * c19 - w14 * c16 * c17
    w18 = 2 * bar2_e1
    w19 = 2 * bar2_e0
    w20 = (bar2_e2 * w18 - bar2_e3 * w19) * c15
    w21 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c15
    w22 = 2 * bar2_e2
    w23 = (bar2_e1 * w19 + bar2_e3 * w22) * c15
    w24 = 2 * bar3_e0
    w25 = bar3_e2 * w24
    w26 = 2 * bar3_e1
    w27 = bar3_e3 * w26
    w28 = w25 + w27
    w29 = w28 * c63
    w30 = 2 * bar3_e2
    w31 = bar3_e3 * w30 - bar3_e1 * w24
    w32 = w31 * c63
    w33 = 2 * bar3_e2**2
    w34 = 1.0 - 2 * bar3_e1**2 - w33
    w35 = w34 * c63
    w36 = 1.0 - w33 - 2 * bar3_e3**2
    w37 = 2 * bar4_e1
    w38 = w37 * bar4_e2
    w39 = 2 * bar4_e0
    w40 = w39 * bar4_e3
    w41 = w38 - w40
    w42 = bar3_e3 * w24 + bar3_e2 * w26
    w43 = 2 * bar4_e3**2
    w44 = 1.0 - 2 * bar4_e1**2 - w43
    w45 = w27 - w25
    w46 = 2 * bar4_e2
    w47 = bar4_e1 * w39 + bar4_e3 * w46
    w48 = hinge4_angle / 2.0
    w49 = ca.cos(w48)
    w50 = ca.sin(w48)
    w51 = (1.0 - 2 * bar4_e2**2 - w43) * c55
    w52 = (w38 + w40) * c55
    w53 = (w37 * bar4_e3 - bar4_e2 * w39) * c55
    w54 = hinge5_angle / 2.0
    w55 = ca.cos(w54)
    w56 = ca.sin(w54)
    w57 = 2 * bar5_e1
    w58 = 2 * bar5_e0
    w59 = (bar5_e2 * w57 - bar5_e3 * w58) * c56
    w60 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c56
    w61 = 2 * bar5_e2
    w62 = (bar5_e1 * w58 + bar5_e3 * w61) * c56
    w63 = -w4
    w64 = -w5
    w65 = bar1_e2 * -2.0
    w66 = bar1_e3 * -2.0
    w67 = w9 * w66
    w68 = bar1_e1 * -2.0
    w69 = w10 * w68
    w70 = w6 * w65
    w71 = 2 * bar1_e3
    w72 = w7 * w10
    w73 = w7 * w9
    w74 = w6 * w7
    w75 = 2 * bar1_e2
    w76 = -w13
    w77 = -w15
    w78 = -w16
    w79 = -w17
    w80 = bar2_e2 * -2.0
    w81 = bar2_e3 * -2.0
    w82 = w21 * w81
    w83 = bar2_e1 * -2.0
    w84 = w23 * w83
    w85 = w20 * w80
    w86 = 2 * bar2_e3
    w87 = w19 * w23
    w88 = w19 * w21
    w89 = w19 * w20
    w90 = bar3_e2 * -2.0
    w91 = bar3_e3 * -2.0
    w92 = w32 * w91
    w93 = bar3_e1 * -2.0
    w94 = w35 * w93
    w95 = w29 * w90
    w96 = w42 * w47
    w97 = w44 * w45
    w98 = w96 - w97
    w99 = w41 * w45
    w100 = w36 * w47
    w101 = w99 - w100
    w102 = w36 * w44
    w103 = w41 * w42
    w104 = w102 - w103
    w105 = w34 * w44
    w106 = w31 * w47
    w107 = w105 - w106
    w108 = w28 * w47
    w109 = w34 * w41
    w110 = w108 - w109
    w111 = w31 * w41
    w112 = w28 * w44
    w113 = w111 - w112
    w114 = 2 * bar3_e3
    w115 = w24 * w35
    w116 = w24 * w32
    w117 = w24 * w29
    w118 = w97 - w96
    w119 = bar4_e1 * -2.0
    w120 = w100 - w99
    w121 = bar4_e2 * -2.0
    w122 = w103 - w102
    w123 = bar4_e3 * -2.0
    w124 = w106 - w105
    w125 = w109 - w108
    w126 = w112 - w111
    w127 = w52 * w123
    w128 = w53 * w119
    w129 = w51 * w121
    w130 = 2 * bar4_e3
    w131 = w39 * w53
    w132 = w39 * w52
    w133 = w39 * w51
    w134 = -w49
    w135 = bar5_e2 * -2.0
    w136 = bar5_e3 * -2.0
    w137 = w60 * w136
    w138 = bar5_e1 * -2.0
    w139 = w62 * w138
    w140 = w59 * w135
    w141 = -w50
    w142 = 2 * bar5_e3
    w143 = w58 * w62
    w144 = w58 * w60
    w145 = w58 * w59
    w146 = w2 / 2.0
    w147 = w1 / 2.0
    w148 = w5 / 2.0
    w149 = w4 / 2.0
    w150 = w14 / 2.0
    w151 = w150 * c20
    w152 = w12 / 2.0
    w153 = w152 * c22
    w154 = w150 * c18 * c17 - w150 * c16 * c19
    w155 = w152 * c18 * c19 - w152 * c16 * c17
    w156 = w49 / 2.0
    w157 = w50 / 2.0
    w158 = w56 / 2.0
    w159 = w55 / 2.0
    w160 = hinge0_angle_dot / 2.0
    w161 = w160**2
    w162 = w1 * w161
    w163 = w2 * w161
    w164 = (hinge1_angle_dot / 2.0)**2
    w165 = w5 * w164
    w166 = w4 * w164
    w167 = w148 * hinge1_angle_dot
    w168 = w149 * hinge1_angle_dot
    w169 = bar1_e0_dot * w167 + bar1_e3_dot * w168
    w170 = w168 * bar1_e2_dot - w167 * bar1_e1_dot
    w171 = w167 * bar1_e2_dot + w168 * bar1_e1_dot
    w172 = bar1_e0_dot * w168 - w167 * bar1_e3_dot
    w173 = w65 * bar1_e0_dot + w71 * bar1_e1_dot + w7 * bar1_e2_dot + w68 * bar1_e3_dot
    w174 = w68 * bar1_e0_dot + w7 * bar1_e1_dot + w66 * bar1_e2_dot + w75 * bar1_e3_dot
    w175 = w9 * w174 - w6 * w173
    w176 = w66 * bar1_e0_dot + w65 * bar1_e1_dot + w8 * bar1_e2_dot + w7 * bar1_e3_dot
    w177 = w6 * w176 - w10 * w174
    w178 = w10 * w173 - w9 * w176
    w179 = hinge2_angle_dot / 2.0
    w180 = w179**2
    w181 = w12 * w180
    w182 = w179 * (w12 * w179) * c20
    w183 = w181 * c18 * c17 - w181 * c16 * c19
    w184 = w14 * w180
    w185 = w179 * (w14 * w179) * c22
    w186 = w184 * c16 * c17 - w184 * c18 * c19
    w187 = w150 * hinge2_angle_dot
    w188 = w187 * c20
    w189 = w152 * hinge2_angle_dot
    w190 = w189 * c22
    w191 = w187 * c18 * c17 - w187 * c16 * c19
    w192 = w189 * c18 * c19 - w189 * c16 * c17
    w193 = bar2_e0_dot * w188 + (bar2_e1_dot * w190 + bar2_e2_dot * w191 + bar2_e3_dot * w192)
    w194 = bar2_e0_dot * w190 - w188 * bar2_e1_dot + (bar2_e2_dot * w192 - w191 * bar2_e3_dot)
    w195 = bar2_e0_dot * w191 - w188 * bar2_e2_dot + (w190 * bar2_e3_dot - bar2_e1_dot * w192)
    w196 = bar2_e0_dot * w192 - w188 * bar2_e3_dot + (bar2_e1_dot * w191 - w190 * bar2_e2_dot)
    w197 = w80 * bar2_e0_dot + w86 * bar2_e1_dot + w19 * bar2_e2_dot + w83 * bar2_e3_dot
    w198 = w83 * bar2_e0_dot + w19 * bar2_e1_dot + w81 * bar2_e2_dot + w22 * bar2_e3_dot
    w199 = w21 * w198 - w20 * w197
    w200 = w81 * bar2_e0_dot + w80 * bar2_e1_dot + w18 * bar2_e2_dot + w19 * bar2_e3_dot
    w201 = w20 * w200 - w23 * w198
    w202 = w23 * w197 - w21 * w200
    w203 = w90 * bar3_e0_dot + w114 * bar3_e1_dot + w24 * bar3_e2_dot + w93 * bar3_e3_dot
    w204 = w93 * bar3_e0_dot + w24 * bar3_e1_dot + w91 * bar3_e2_dot + w30 * bar3_e3_dot
    w205 = w32 * w204 - w29 * w203
    w206 = w91 * bar3_e0_dot + w90 * bar3_e1_dot + w26 * bar3_e2_dot + w24 * bar3_e3_dot
    w207 = w29 * w206 - w35 * w204
    w208 = w35 * w203 - w32 * w206
    w209 = w121 * bar4_e0_dot + w130 * bar4_e1_dot + w39 * bar4_e2_dot + w119 * bar4_e3_dot
    w210 = w119 * bar4_e0_dot + w39 * bar4_e1_dot + w123 * bar4_e2_dot + w46 * bar4_e3_dot
    w211 = w44 * w210 - w41 * w209
    w212 = w123 * bar4_e0_dot + w121 * bar4_e1_dot + w37 * bar4_e2_dot + w39 * bar4_e3_dot
    w213 = w41 * w212 - w47 * w210
    w214 = w209 * w211 - w212 * w213
    w215 = w47 * w209 - w44 * w212
    w216 = w212 * w215 - w210 * w211
    w217 = w210 * w213 - w209 * w215
    w218 = w42 * w204 - w36 * w203
    w219 = w36 * w206 - w45 * w204
    w220 = w45 * w203 - w42 * w206
    w221 = w36 * w214 + w42 * w216 + w45 * w217 + w41 * (w203 * w218 - w206 * w219) + w44 * (w206 * w220 - w204 * w218)
    w222 = w221 + w47 * (w204 * w219 - w203 * w220) + w215 * (2 * w220) + w213 * (2 * w219) + w211 * (2 * w218)
    w223 = w28 * w203 - w31 * w204
    w224 = w34 * w204 - w28 * w206
    w225 = w31 * w206 - w34 * w203
    w226 = w41 * (w203 * w223 - w206 * w224) - (w28 * w214 + w31 * w216 + w34 * w217) + w44 * (w206 * w225 - w204 * w223)
    w227 = w226 + w47 * (w204 * w224 - w203 * w225) + w215 * (2 * w225) + w213 * (2 * w224) + w211 * (2 * w223)
    w228 = w156 * hinge4_angle_dot
    w229 = w157 * hinge4_angle_dot
    w230 = bar5_e3_dot * w228 - bar5_e0_dot * w229
    w231 = (hinge4_angle_dot / 2.0)**2
    w232 = w49 * w231
    w233 = w50 * w231
    w234 = w229 * bar5_e1_dot + w228 * bar5_e2_dot
    w235 = w228 * bar5_e1_dot - w229 * bar5_e2_dot
    w236 = w228 * bar5_e0_dot + bar5_e3_dot * w229
    w237 = w52 * w210 - w51 * w209
    w238 = w51 * w212 - w53 * w210
    w239 = w53 * w209 - w52 * w212
    w240 = hinge5_angle_dot / 2.0
    w241 = w240**2
    w242 = w55 * w241
    w243 = w56 * w241
    w244 = w135 * bar5_e0_dot + w142 * bar5_e1_dot + w58 * bar5_e2_dot + w138 * bar5_e3_dot
    w245 = w138 * bar5_e0_dot + w58 * bar5_e1_dot + w136 * bar5_e2_dot + w61 * bar5_e3_dot
    w246 = w60 * w245 - w59 * w244
    w247 = w136 * bar5_e0_dot + w135 * bar5_e1_dot + w57 * bar5_e2_dot + w58 * bar5_e3_dot
    w248 = w59 * w247 - w62 * w245
    w249 = w62 * w244 - w60 * w247
    C = ca.vertcat(
        bar1_e0 - w1 * c51,
        bar1_e1 - (w1 * c2 * c0 - w1 * c1 * c3),
        bar1_e2 + w2 * c42,
        bar1_e3 - (w2 * c1 * c0 - w2 * c2 * c3),
        bar1_x,
        bar1_y,
        bar1_z,
        bar2_e0 - (bar1_e0 * w4 - bar1_e3 * w5),
        bar2_e1 - (bar1_e1 * w4 + bar1_e2 * w5),
        bar2_e2 - (bar1_e2 * w4 - bar1_e1 * w5),
        bar2_e3 - (bar1_e0 * w5 + bar1_e3 * w4),
        bar2_x - (bar1_x + w6),
        bar2_y - (bar1_y + w9),
        bar2_z - (bar1_z + w10),
        bar3_e0 - (bar2_e0 * w13 - (bar2_e1 * w15 + bar2_e2 * w16 + bar2_e3 * w17)),
        bar3_e1 - (bar2_e0 * w15 + bar2_e1 * w13 + (bar2_e2 * w17 - bar2_e3 * w16)),
        bar3_e2 - (bar2_e0 * w16 + bar2_e2 * w13 + (bar2_e3 * w15 - bar2_e1 * w17)),
        bar3_e3 - (bar2_e0 * w17 + bar2_e3 * w13 + (bar2_e1 * w16 - bar2_e2 * w15)),
        bar3_x - (bar2_x + w20),
        bar3_y - (bar2_y + w21),
        bar3_z - (bar2_z + w23),
        bar4_x - (bar3_x + w29),
        bar4_y - (bar3_y + w32),
        bar4_z - (bar3_z + w35),
        w36 * w41 + w42 * w44 + w45 * w47,
        -(w28 * w41 + w31 * w44 + w34 * w47),
        bar4_e0 - (bar5_e0 * w49 + bar5_e3 * w50),
        bar4_e1 - (w49 * bar5_e1 - w50 * bar5_e2),
        bar4_e2 - (w49 * bar5_e2 + w50 * bar5_e1),
        bar4_e3 - (w49 * bar5_e3 - bar5_e0 * w50),
        bar5_x - (bar4_x + w51),
        bar5_y - (bar4_y + w52),
        bar5_z - (bar4_z + w53),
        bar5_e0 - w55 * c62,
        bar5_e1 + w56 * c61,
        bar5_e2 - (w55 * c59 * c60 - w55 * c57 * c58),
        bar5_e3 - (w56 * c59 * c58 - w56 * c57 * c60),
        -(bar5_x + w59),
        -(bar5_y + w60),
        c99 - (bar5_z + w62),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w63,
        0.0,
        0.0,
        w64,
        -(w10 * w65 - w67),
        -(w6 * w66 - w69),
        -(w9 * w68 - w70),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w63,
        w5,
        0.0,
        -(w10 * w71 - w9 * w65),
        -(w70 - w72),
        -(w73 - w6 * w71),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w64,
        w63,
        0.0,
        -(w72 - w8 * w9),
        -(w6 * w8 - w10 * w66),
        -(w67 - w74),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        w5,
        0.0,
        0.0,
        w63,
        -(w69 - w73),
        -(w74 - w10 * w75),
        -(w9 * w75 - w6 * w68),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w76,
        w77,
        w78,
        w79,
        -(w23 * w80 - w82),
        -(w20 * w81 - w84),
        -(w21 * w83 - w85),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w15,
        w76,
        w17,
        w78,
        -(w23 * w86 - w21 * w80),
        -(w85 - w87),
        -(w88 - w20 * w86),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w16,
        w79,
        w76,
        w15,
        -(w87 - w18 * w21),
        -(w18 * w20 - w23 * w81),
        -(w82 - w89),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        w17,
        w16,
        w77,
        w76,
        -(w84 - w88),
        -(w89 - w22 * w23),
        -(w21 * w22 - w20 * w83),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w35 * w90 - w92),
        -(w29 * w91 - w94),
        -(w32 * w93 - w95),
        w93 * w98 + w90 * w101 + w91 * w104,
        w93 * w107 + w90 * w110 + w91 * w113,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w35 * w114 - w32 * w90),
        -(w95 - w115),
        -(w116 - w29 * w114),
        w24 * w98 + w101 * w114 + w90 * w104,
        w24 * w107 + w110 * w114 + w90 * w113,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w115 - w26 * w32),
        -(w26 * w29 - w35 * w91),
        -(w92 - w117),
        w91 * w98 + w24 * w101 + w26 * w104,
        w91 * w107 + w24 * w110 + w26 * w113,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w94 - w116),
        -(w117 - w30 * w35),
        -(w30 * w32 - w29 * w93),
        w30 * w98 + w93 * w101 + w24 * w104,
        w30 * w107 + w93 * w110 + w24 * w113,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w118 * w119 + w120 * w121 + w122 * w123,
        w119 * w124 + w121 * w125 + w123 * w126,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w53 * w121 - w127),
        -(w51 * w123 - w128),
        -(w52 * w119 - w129),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w39 * w118 + w120 * w130 + w121 * w122,
        w39 * w124 + w125 * w130 + w121 * w126,
        0.0,
        1.0,
        0.0,
        0.0,
        -(w53 * w130 - w52 * w121),
        -(w129 - w131),
        -(w132 - w51 * w130),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w118 * w123 + w39 * w120 + w37 * w122,
        w123 * w124 + w39 * w125 + w37 * w126,
        0.0,
        0.0,
        1.0,
        0.0,
        -(w131 - w37 * w52),
        -(w37 * w51 - w53 * w123),
        -(w127 - w133),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w46 * w118 + w119 * w120 + w39 * w122,
        w46 * w124 + w119 * w125 + w39 * w126,
        0.0,
        0.0,
        0.0,
        1.0,
        -(w128 - w132),
        -(w133 - w46 * w53),
        -(w46 * w52 - w51 * w119),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w134,
        0.0,
        0.0,
        w50,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w62 * w135 - w137),
        -(w59 * w136 - w139),
        -(w60 * w138 - w140),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w134,
        w141,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -(w62 * w142 - w60 * w135),
        -(w140 - w143),
        -(w144 - w59 * w142),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w50,
        w134,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -(w143 - w57 * w60),
        -(w57 * w59 - w62 * w136),
        -(w137 - w145),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w141,
        0.0,
        0.0,
        w134,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        -(w139 - w144),
        -(w145 - w61 * w62),
        -(w60 * w61 - w59 * w138),
        w146 * c51,
        -(w146 * c1 * c3 - w146 * c2 * c0),
        w147 * c42,
        -(w147 * c1 * c0 - w147 * c2 * c3),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar1_e0 * w148 + bar1_e3 * w149,
        -(bar1_e2 * w149 - bar1_e1 * w148),
        bar1_e2 * w148 + bar1_e1 * w149,
        -(bar1_e0 * w149 - bar1_e3 * w148),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar2_e0 * w151 + (bar2_e1 * w153 + bar2_e2 * w154 + bar2_e3 * w155),
        -(bar2_e0 * w153 - bar2_e1 * w151 + (bar2_e2 * w155 - bar2_e3 * w154)),
        -(bar2_e0 * w154 - bar2_e2 * w151 + (bar2_e3 * w153 - bar2_e1 * w155)),
        -(bar2_e0 * w155 - bar2_e3 * w151 + (bar2_e1 * w154 - bar2_e2 * w153)),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(bar5_e3 * w156 - bar5_e0 * w157),
        bar5_e1 * w157 + bar5_e2 * w156,
        -(bar5_e1 * w156 - bar5_e2 * w157),
        bar5_e0 * w156 + bar5_e3 * w157,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w158 * c62,
        w159 * c61,
        -(w158 * c57 * c58 - w158 * c59 * c60),
        -(w159 * c59 * c58 - w159 * c57 * c60),
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 40, 40)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        w160 * (w1 * w160) * c100,
        w162 * c1 * c3 - w162 * c2 * c0,
        w160 * (w2 * w160) * c42,
        w163 * c2 * c3 - w163 * c1 * c0,
        0.0,
        0.0,
        0.0,
        bar1_e3 * w165 - bar1_e0 * w166 - w169 - w169,
        w170 + (w170 - (bar1_e1 * w166 + bar1_e2 * w165)),
        bar1_e1 * w165 - bar1_e2 * w166 - w171 - w171,
        w172 + (w172 - (bar1_e0 * w165 + bar1_e3 * w166)),
        w173 * w175 - w176 * w177,
        w176 * w178 - w174 * w175,
        w174 * w177 - w173 * w178,
        -(w193 + (bar2_e0 * w182 + (bar2_e2 * w183 - bar2_e1 * w185 + bar2_e3 * w186) + w193)),
        w194 + (bar2_e2 * w186 - bar2_e3 * w183 - (bar2_e0 * w185 + bar2_e1 * w182) + w194),
        w195 + (bar2_e0 * w183 - bar2_e2 * w182 - (bar2_e3 * w185 + bar2_e1 * w186) + w195),
        w196 + (bar2_e0 * w186 - bar2_e3 * w182 + (bar2_e1 * w183 + bar2_e2 * w185) + w196),
        w197 * w199 - w200 * w201,
        w200 * w202 - w198 * w199,
        w198 * w201 - w197 * w202,
        w203 * w205 - w206 * w207,
        w206 * w208 - w204 * w205,
        w204 * w207 - w203 * w208,
        -w222,
        -w227,
        w230 + (w230 - (bar5_e0 * w232 + bar5_e3 * w233)),
        bar5_e2 * w233 - bar5_e1 * w232 - w234 - w234,
        w235 + (w235 - (bar5_e2 * w232 + bar5_e1 * w233)),
        bar5_e0 * w233 - bar5_e3 * w232 - w236 - w236,
        w209 * w237 - w212 * w238,
        w212 * w239 - w210 * w237,
        w210 * w238 - w209 * w239,
        w240 * (w55 * w240) * c101,
        w240 * (w56 * w240) * c61,
        w242 * c57 * c58 - w242 * c59 * c60,
        w243 * c57 * c60 - w243 * c59 * c58,
        w244 * w246 - w247 * w248,
        w247 * w249 - w245 * w246,
        w245 * w248 - w244 * w249,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 7075 operations."""
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 154)
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
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
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
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c50 = c[50]
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
    c100 = c[100]
    c101 = c[101]
    c102 = c[102]
    c103 = c[103]
    c104 = c[104]
    c105 = c[105]
    c106 = c[106]
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = w1 * bar1_e3
    w3 = 2 * bar1_e0
    w4 = bar1_e2 * w3
    w5 = w2 - w4
    w6 = w5 * c93
    w7 = bar1_e3 * -2.0
    w8 = bar1_e3 * w3
    w9 = bar1_e2 * w1
    w10 = w8 + w9
    w11 = w10 * c93
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
    w25 = w24 * c93
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
    w37 = w3 * c6
    w38 = w18 * w37 + bar1_e2 * bar1_e3 * c54
    w39 = w3 * c8
    w40 = w18 * c9
    w41 = w0 * w39 + bar1_e1 * bar1_e3 * c53
    w42 = w0 * c6
    w43 = w1 * c8
    w44 = w3 * c9
    w45 = bar1_e2 * bar1_e1 * c52 + w7 * w44
    w46 = bar1_e3 * bar1_e0 * c50 + w31 * w40
    w47 = w7 * w43 + bar1_e2 * bar1_e0 * c103
    w48 = w14 * w42 + bar1_e1 * bar1_e0 * c104
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = w50 * bar2_e1
    w52 = 2 * bar2_e2
    w53 = w52 * bar2_e3
    w54 = w51 + w53
    w55 = w54 * c14
    w56 = bar2_e3 * -2.0
    w57 = 1.0 - 2 * bar2_e1**2
    w58 = 2 * bar2_e3**2
    w59 = w57 - w58
    w60 = w59 * c14
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
    w75 = w74 * c14
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
    w86 = w50 * c25
    w87 = w68 * w86 + bar2_e2 * bar2_e3 * c47
    w88 = w50 * c27
    w89 = w68 * c28
    w90 = w49 * w88 + bar2_e1 * bar2_e3 * c46
    w91 = w49 * c25
    w92 = w66 * c27
    w93 = w50 * c28
    w94 = bar2_e2 * bar2_e1 * c41 + w56 * w93
    w95 = bar2_e0 * bar2_e3 * c48 + w52 * w89
    w96 = w56 * w92 + bar2_e2 * bar2_e0 * c45
    w97 = w63 * w91 + bar2_e0 * bar2_e1 * c44
    w98 = bar3_e2 * -2.0
    w99 = 1.0 - 2 * bar3_e1**2
    w100 = 2 * bar3_e2**2
    w101 = w99 - w100
    w102 = w101 * c21
    w103 = bar3_e3 * -2.0
    w104 = 2 * bar3_e2
    w105 = bar3_e3 * w104
    w106 = 2 * bar3_e0
    w107 = bar3_e1 * w106
    w108 = w105 - w107
    w109 = w108 * c21
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
    w124 = w123 * c21
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
    w135 = w106 * c31
    w136 = w117 * w135 + bar3_e2 * bar3_e3 * c40
    w137 = w106 * c33
    w138 = w117 * c34
    w139 = w98 * w137 + bar3_e1 * bar3_e3 * c39
    w140 = w98 * c31
    w141 = w115 * c33
    w142 = w106 * c34
    w143 = bar3_e2 * bar3_e1 * c38 + w103 * w142
    w144 = bar3_e3 * bar3_e0 * c37 + w104 * w138
    w145 = w103 * w141 + bar3_e2 * bar3_e0 * c36
    w146 = w112 * w140 + bar3_e1 * bar3_e0 * c35
    w147 = bar4_e2 * -2.0
    w148 = 2 * bar4_e1
    w149 = w148 * bar4_e3
    w150 = 2 * bar4_e0
    w151 = bar4_e2 * w150
    w152 = w149 - w151
    w153 = w152 * c78
    w154 = bar4_e3 * -2.0
    w155 = bar4_e3 * w150
    w156 = bar4_e2 * w148
    w157 = w155 + w156
    w158 = w157 * c78
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
    w172 = w171 * c78
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
    w184 = w150 * c73
    w185 = w165 * w184 + bar4_e2 * bar4_e3 * c86
    w186 = w150 * c76
    w187 = w165 * c77
    w188 = w147 * w186 + bar4_e1 * bar4_e3 * c85
    w189 = w147 * c73
    w190 = w148 * c76
    w191 = w150 * c77
    w192 = bar4_e2 * bar4_e1 * c79 + w154 * w191
    w193 = bar4_e3 * bar4_e0 * c87 + w178 * w187
    w194 = w154 * w190 + bar4_e2 * bar4_e0 * c84
    w195 = w161 * w189 + bar4_e1 * bar4_e0 * c83
    w196 = bar5_e2 * -2.0
    w197 = 2 * bar5_e0
    w198 = w197 * bar5_e1
    w199 = 2 * bar5_e2
    w200 = w199 * bar5_e3
    w201 = w198 + w200
    w202 = w201 * c80
    w203 = bar5_e3 * -2.0
    w204 = 1.0 - 2 * bar5_e1**2
    w205 = 2 * bar5_e3**2
    w206 = w204 - w205
    w207 = w206 * c80
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
    w222 = w221 * c80
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
    w233 = w197 * c67
    w234 = w215 * w233 + bar5_e2 * bar5_e3 * c92
    w235 = w197 * c69
    w236 = w215 * c70
    w237 = w196 * w235 + bar5_e1 * bar5_e3 * c91
    w238 = w196 * c67
    w239 = w213 * c69
    w240 = w197 * c70
    w241 = bar5_e2 * bar5_e1 * c90 + w203 * w240
    w242 = bar5_e0 * bar5_e3 * c89 + w199 * w236
    w243 = w203 * w239 + bar5_e2 * bar5_e0 * c88
    w244 = w210 * w238 + bar5_e0 * bar5_e1 * c82
    w245 = w7 * bar1_e0_dot
    w246 = w3 * bar1_e3_dot
    w247 = w245 + w31 * bar1_e1_dot + w18 * bar1_e2_dot + w246
    w248 = w247 * c93
    w249 = w0 * bar1_e0_dot
    w250 = w3 * bar1_e2_dot
    w251 = w249 + w7 * bar1_e1_dot + w250 + w1 * bar1_e3_dot
    w252 = w251 * c93
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
    w264 = w247 * c5
    w265 = w251 * c4
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c7
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w18 * w266 + w0 * w268 + w7 * w269
    w271 = w3 * w266 + w7 * w268 + w31 * w269
    w272 = w14 * w266 + w3 * w268 + w18 * w269
    w273 = w0 * w266 + w1 * w268 + w3 * w269
    w274 = w68 * bar2_e0_dot + w50 * bar2_e1_dot
    w275 = w274 + w63 * bar2_e2_dot + w49 * bar2_e3_dot
    w276 = w275 * c14
    w277 = w56 * bar2_e0_dot
    w278 = w50 * bar2_e3_dot
    w279 = w277 + w52 * bar2_e1_dot + w68 * bar2_e2_dot + w278
    w280 = w279 * c14
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
    w293 = w279 * c24
    w294 = w285 * c23
    w295 = w285 * w293 - w279 * w294
    w296 = w275 * c26
    w297 = w279 * w296 - w275 * w293
    w298 = w275 * w294 - w285 * w296
    w299 = w68 * w295 + w49 * w297 + w56 * w298
    w300 = w50 * w295 + w56 * w297 + w52 * w298
    w301 = w63 * w295 + w50 * w297 + w68 * w298
    w302 = w49 * w295 + w66 * w297 + w50 * w298
    w303 = w98 * bar3_e0_dot
    w304 = w106 * bar3_e2_dot
    w305 = w303 + w103 * bar3_e1_dot + w304 + w115 * bar3_e3_dot
    w306 = w305 * c21
    w307 = w117 * bar3_e0_dot + w106 * bar3_e1_dot
    w308 = w307 + w112 * bar3_e2_dot + w98 * bar3_e3_dot
    w309 = w308 * c21
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
    w325 = w315 * c30
    w326 = w305 * c29
    w327 = w305 * w325 - w315 * w326
    w328 = w308 * c32
    w329 = w315 * w328 - w308 * w325
    w330 = w308 * w326 - w305 * w328
    w331 = w117 * w327 + w98 * w329 + w103 * w330
    w332 = w106 * w327 + w103 * w329 + w104 * w330
    w333 = w112 * w327 + w106 * w329 + w117 * w330
    w334 = w98 * w327 + w115 * w329 + w106 * w330
    w335 = w154 * bar4_e0_dot
    w336 = w150 * bar4_e3_dot
    w337 = w335 + w178 * bar4_e1_dot + w165 * bar4_e2_dot + w336
    w338 = w337 * c78
    w339 = w147 * bar4_e0_dot
    w340 = w150 * bar4_e2_dot
    w341 = w339 + w154 * bar4_e1_dot + w340 + w148 * bar4_e3_dot
    w342 = w341 * c78
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
    w357 = w337 * c72
    w358 = w341 * c71
    w359 = w341 * w357 - w337 * w358
    w360 = w346 * c75
    w361 = w337 * w360 - w346 * w357
    w362 = w346 * w358 - w341 * w360
    w363 = w165 * w359 + w147 * w361 + w154 * w362
    w364 = w150 * w359 + w154 * w361 + w178 * w362
    w365 = w161 * w359 + w150 * w361 + w165 * w362
    w366 = w147 * w359 + w148 * w361 + w150 * w362
    w367 = w215 * bar5_e0_dot + w197 * bar5_e1_dot
    w368 = w367 + w210 * bar5_e2_dot + w196 * bar5_e3_dot
    w369 = w368 * c80
    w370 = w203 * bar5_e0_dot
    w371 = w197 * bar5_e3_dot
    w372 = w370 + w199 * bar5_e1_dot + w215 * bar5_e2_dot + w371
    w373 = w372 * c80
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
    w386 = w372 * c66
    w387 = w378 * c65
    w388 = w378 * w386 - w372 * w387
    w389 = w368 * c68
    w390 = w372 * w389 - w368 * w386
    w391 = w368 * w387 - w378 * w389
    w392 = w215 * w388 + w196 * w390 + w203 * w391
    w393 = w197 * w388 + w203 * w390 + w199 * w391
    w394 = w210 * w388 + w197 * w390 + w215 * w391
    w395 = w196 * w388 + w213 * w390 + w197 * w391
    w396 = w26 * c94
    w397 = w28 * c94
    w398 = w29 * c94
    w399 = w32 * c94
    w400 = w76 * c94
    w401 = w78 * c94
    w402 = w79 * c94
    w403 = w81 * c94
    w404 = w125 * c94
    w405 = w127 * c94
    w406 = w128 * c94
    w407 = w130 * c94
    w408 = w173 * c94
    w409 = w175 * c94
    w410 = w176 * c94
    w411 = w179 * c94
    w412 = w223 * c94
    w413 = w225 * c94
    w414 = w226 * c94
    w415 = w228 * c94
    w416 = hinge1_angle / 2.0
    w417 = ca.cos(w416)
    w418 = -w417
    w419 = ca.sin(w416)
    w420 = -w419
    w421 = w5 * c10
    w422 = w10 * c10
    w423 = w7 * w422
    w424 = w24 * c10
    w425 = w18 * w421
    w426 = w0 * w424
    w427 = w3 * w421
    w428 = w3 * w422
    w429 = w3 * w424
    w430 = hinge2_angle / 2.0
    w431 = ca.cos(w430)
    w432 = w431 * c106
    w433 = ca.sin(w430)
    w434 = w433 * c22
    w435 = -w434
    w436 = w431 * c16 * c19 - w431 * c18 * c17
    w437 = -w436
    w438 = w433 * c18 * c19 - w433 * c16 * c17
    w439 = -w438
    w440 = w54 * c15
    w441 = w59 * c15
    w442 = w56 * w441
    w443 = w74 * c15
    w444 = w68 * w440
    w445 = w49 * w443
    w446 = w50 * w440
    w447 = w50 * w441
    w448 = w50 * w443
    w449 = w101 * c63
    w450 = w108 * c63
    w451 = w103 * w450
    w452 = w123 * c63
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
    w482 = w152 * c55
    w483 = w157 * c55
    w484 = w154 * w483
    w485 = w171 * c55
    w486 = w165 * w482
    w487 = w147 * w485
    w488 = w150 * w482
    w489 = w150 * w483
    w490 = w150 * w485
    w491 = hinge4_angle / 2.0
    w492 = ca.cos(w491)
    w493 = -w492
    w494 = ca.sin(w491)
    w495 = w201 * c56
    w496 = w206 * c56
    w497 = w203 * w496
    w498 = w221 * c56
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
    w513 = w512 * c20
    w514 = w431 / 2.0
    w515 = w514 * c22
    w516 = w512 * c18 * c17 - w512 * c16 * c19
    w517 = w514 * c18 * c19 - w514 * c16 * c17
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
    w528 = w506 * w526
    w529 = (hinge1_angle_dot / 2.0)**2
    w530 = w419 * w529
    w531 = w417 * w529
    w532 = w510 * hinge1_angle_dot
    w533 = w511 * hinge1_angle_dot
    w534 = bar1_e0_dot * w532 + bar1_e3_dot * w533
    w535 = bar1_e2_dot * w533 - bar1_e1_dot * w532
    w536 = bar1_e2_dot * w532 + bar1_e1_dot * w533
    w537 = bar1_e0_dot * w533 - bar1_e3_dot * w532
    w538 = w250 + (w249 + w14 * bar1_e1_dot) + w18 * bar1_e3_dot
    w539 = w254 + w7 * bar1_e2_dot + w31 * bar1_e3_dot
    w540 = w422 * w539 - w424 * w538
    w541 = w246 + (w245 + w0 * bar1_e1_dot + w1 * bar1_e2_dot)
    w542 = w424 * w541 - w421 * w539
    w543 = w421 * w538 - w422 * w541
    w544 = hinge2_angle_dot / 2.0
    w545 = w544**2
    w546 = w431 * w545
    w547 = w544 * (w431 * w544) * c20
    w548 = w546 * c18 * c17 - w546 * c16 * c19
    w549 = w433 * w545
    w550 = w544 * (w433 * w544) * c22
    w551 = w549 * c16 * c17 - w549 * c18 * c19
    w552 = w512 * hinge2_angle_dot
    w553 = w552 * c20
    w554 = w514 * hinge2_angle_dot
    w555 = w554 * c22
    w556 = w552 * c18 * c17 - w552 * c16 * c19
    w557 = w554 * c18 * c19 - w554 * c16 * c17
    w558 = bar2_e0_dot * w553 + (bar2_e1_dot * w555 + bar2_e2_dot * w556 + bar2_e3_dot * w557)
    w559 = bar2_e0_dot * w555 - bar2_e1_dot * w553 + (bar2_e2_dot * w557 - bar2_e3_dot * w556)
    w560 = bar2_e0_dot * w556 - bar2_e2_dot * w553 + (bar2_e3_dot * w555 - bar2_e1_dot * w557)
    w561 = bar2_e0_dot * w557 - bar2_e3_dot * w553 + (bar2_e1_dot * w556 - bar2_e2_dot * w555)
    w562 = w284 + (w283 + w63 * bar2_e1_dot) + w68 * bar2_e3_dot
    w563 = w274 + w56 * bar2_e2_dot + w52 * bar2_e3_dot
    w564 = w441 * w563 - w443 * w562
    w565 = w278 + (w277 + w49 * bar2_e1_dot + w66 * bar2_e2_dot)
    w566 = w443 * w565 - w440 * w563
    w567 = w440 * w562 - w441 * w565
    w568 = w304 + (w303 + w112 * bar3_e1_dot) + w117 * bar3_e3_dot
    w569 = w307 + w103 * bar3_e2_dot + w104 * bar3_e3_dot
    w570 = w450 * w569 - w452 * w568
    w571 = w314 + (w313 + w98 * bar3_e1_dot + w115 * bar3_e2_dot)
    w572 = w452 * w571 - w449 * w569
    w573 = w449 * w568 - w450 * w571
    w574 = w340 + (w339 + w161 * bar4_e1_dot) + w165 * bar4_e3_dot
    w575 = w345 + w154 * bar4_e2_dot + w178 * bar4_e3_dot
    w576 = w351 * w575 - w344 * w574
    w577 = w336 + (w335 + w147 * bar4_e1_dot + w148 * bar4_e2_dot)
    w578 = w344 * w577 - w355 * w575
    w579 = w574 * w576 - w577 * w578
    w580 = w355 * w574 - w351 * w577
    w581 = w577 * w580 - w575 * w576
    w582 = w575 * w578 - w574 * w580
    w583 = w321 * w569 - w312 * w568
    w584 = w312 * w571 - w323 * w569
    w585 = w323 * w568 - w321 * w571
    w586 = w312 * w579 + w321 * w581 + w323 * w582 + w344 * (w568 * w583 - w571 * w584) + w351 * (w571 * w585 - w569 * w583)
    w587 = w586 + w355 * (w569 * w584 - w568 * w585) + w580 * (2 * w585) + w578 * (2 * w584) + w576 * (2 * w583)
    w588 = w123 * w568 - w108 * w569
    w589 = w101 * w569 - w123 * w571
    w590 = w108 * w571 - w101 * w568
    w591 = w344 * (w568 * w588 - w571 * w589) - (w123 * w579 + w108 * w581 + w101 * w582) + w351 * (w571 * w590 - w569 * w588)
    w592 = w591 + w355 * (w569 * w589 - w568 * w590) + w580 * (2 * w590) + w578 * (2 * w589) + w576 * (2 * w588)
    w593 = w518 * hinge4_angle_dot
    w594 = w519 * hinge4_angle_dot
    w595 = bar5_e3_dot * w593 - bar5_e0_dot * w594
    w596 = (hinge4_angle_dot / 2.0)**2
    w597 = w492 * w596
    w598 = w494 * w596
    w599 = bar5_e1_dot * w594 + bar5_e2_dot * w593
    w600 = bar5_e1_dot * w593 - bar5_e2_dot * w594
    w601 = bar5_e0_dot * w593 + bar5_e3_dot * w594
    w602 = w483 * w575 - w485 * w574
    w603 = w485 * w577 - w482 * w575
    w604 = w482 * w574 - w483 * w577
    w605 = hinge5_angle_dot / 2.0
    w606 = w605**2
    w607 = w523 * w606
    w608 = w521 * w606
    w609 = w377 + (w376 + w210 * bar5_e1_dot) + w215 * bar5_e3_dot
    w610 = w367 + w203 * bar5_e2_dot + w199 * bar5_e3_dot
    w611 = w496 * w610 - w498 * w609
    w612 = w371 + (w370 + w196 * bar5_e1_dot + w213 * bar5_e2_dot)
    w613 = w498 * w612 - w495 * w610
    w614 = w495 * w609 - w496 * w612
    M = ca.vertcat(
        c102,
        0.0,
        0.0,
        w13,
        w15,
        w17,
        w21,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c102,
        0.0,
        w26,
        w28,
        w29,
        w32,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c102,
        w33,
        w34,
        w35,
        w36,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w13,
        w26,
        w33,
        w18 * (w18 * c6) + w0 * (w0 * c8) + w7 * (w7 * c9),
        w38,
        w41,
        w45,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w15,
        w28,
        w34,
        w38,
        w3 * w37 + w7 * (w7 * c8) + w31 * (w31 * c9),
        w46,
        w47,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w17,
        w29,
        w35,
        w41,
        w46,
        w14 * (w14 * c6) + w3 * w39 + w18 * w40,
        w48,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w21,
        w32,
        w36,
        w45,
        w47,
        w48,
        w0 * w42 + w1 * w43 + w3 * w44,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c11,
        0.0,
        0.0,
        w62,
        w64,
        w67,
        w71,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c11,
        0.0,
        w76,
        w78,
        w79,
        w81,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c11,
        w82,
        w83,
        w84,
        w85,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w62,
        w76,
        w82,
        w68 * (w68 * c25) + w49 * (w49 * c27) + w56 * (w56 * c28),
        w87,
        w90,
        w94,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w64,
        w78,
        w83,
        w87,
        w50 * w86 + w56 * (w56 * c27) + w52 * (w52 * c28),
        w95,
        w96,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w67,
        w79,
        w84,
        w90,
        w95,
        w63 * (w63 * c25) + w50 * w88 + w68 * w89,
        w97,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w71,
        w81,
        w85,
        w94,
        w96,
        w97,
        w49 * w91 + w66 * w92 + w50 * w93,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c12,
        0.0,
        0.0,
        w111,
        w113,
        w116,
        w120,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c12,
        0.0,
        w125,
        w127,
        w128,
        w130,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c12,
        w131,
        w132,
        w133,
        w134,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w111,
        w125,
        w131,
        w117 * (w117 * c31) + w98 * (w98 * c33) + w103 * (w103 * c34),
        w136,
        w139,
        w143,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w113,
        w127,
        w132,
        w136,
        w106 * w135 + w103 * (w103 * c33) + w104 * (w104 * c34),
        w144,
        w145,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w116,
        w128,
        w133,
        w139,
        w144,
        w112 * (w112 * c31) + w106 * w137 + w117 * w138,
        w146,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w120,
        w130,
        w134,
        w143,
        w145,
        w146,
        w98 * w140 + w115 * w141 + w106 * w142,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c74,
        0.0,
        0.0,
        w160,
        w162,
        w164,
        w168,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c74,
        0.0,
        w173,
        w175,
        w176,
        w179,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c74,
        w180,
        w181,
        w182,
        w183,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w160,
        w173,
        w180,
        w165 * (w165 * c73) + w147 * (w147 * c76) + w154 * (w154 * c77),
        w185,
        w188,
        w192,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w162,
        w175,
        w181,
        w185,
        w150 * w184 + w154 * (w154 * c76) + w178 * (w178 * c77),
        w193,
        w194,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w164,
        w176,
        w182,
        w188,
        w193,
        w161 * (w161 * c73) + w150 * w186 + w165 * w187,
        w195,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w168,
        w179,
        w183,
        w192,
        w194,
        w195,
        w147 * w189 + w148 * w190 + w150 * w191,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c64,
        0.0,
        0.0,
        w209,
        w211,
        w214,
        w218,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c64,
        0.0,
        w223,
        w225,
        w226,
        w228,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c64,
        w229,
        w230,
        w231,
        w232,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w209,
        w223,
        w229,
        w215 * (w215 * c67) + w196 * (w196 * c69) + w203 * (w203 * c70),
        w234,
        w237,
        w241,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w211,
        w225,
        w230,
        w234,
        w197 * w233 + w203 * (w203 * c69) + w199 * (w199 * c70),
        w242,
        w243,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w214,
        w226,
        w231,
        w237,
        w242,
        w210 * (w210 * c67) + w197 * w235 + w215 * w236,
        w244,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w218,
        w228,
        w232,
        w241,
        w243,
        w244,
        w196 * w238 + w213 * w239 + w197 * w240,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    M = ca.reshape(M, 40, 40)
    M = ca.densify(M)
    K = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    K = ca.reshape(K, 40, 40)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w258,
        w262,
        w263,
        w270,
        w271,
        w272,
        w273,
        w290,
        w291,
        w292,
        w299,
        w300,
        w301,
        w302,
        w320,
        w322,
        w324,
        w331,
        w332,
        w333,
        w334,
        w349,
        w354,
        w356,
        w363,
        w364,
        w365,
        w366,
        w383,
        w384,
        w385,
        w392,
        w393,
        w394,
        w395,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c105,
        0.0,
        w396,
        w397,
        w398,
        w399,
        0.0,
        c95,
        0.0,
        w400,
        w401,
        w402,
        w403,
        0.0,
        c96,
        0.0,
        w404,
        w405,
        w406,
        w407,
        0.0,
        c97,
        0.0,
        w408,
        w409,
        w410,
        w411,
        0.0,
        c98,
        0.0,
        w412,
        w413,
        w414,
        w415,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w258,
        w262 + c105,
        w263,
        w270 + w396,
        w271 + w397,
        w272 + w398,
        w273 + w399,
        w290,
        c95 + w291,
        w292,
        w299 + w400,
        w300 + w401,
        w301 + w402,
        w302 + w403,
        w320,
        c96 + w322,
        w324,
        w331 + w404,
        w332 + w405,
        w333 + w406,
        w334 + w407,
        w349,
        c97 + w354,
        w356,
        w363 + w408,
        w364 + w409,
        w365 + w410,
        w366 + w411,
        w383,
        c98 + w384,
        w385,
        w392 + w412,
        w393 + w413,
        w394 + w414,
        w395 + w415,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w418,
        0.0,
        0.0,
        w420,
        -(w0 * w421 - w423),
        -(w7 * w424 - w425),
        -(w18 * w422 - w426),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w418,
        w419,
        0.0,
        -(w14 * w421 - w0 * w422),
        -(w426 - w427),
        -(w428 - w14 * w424),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w420,
        w418,
        0.0,
        -(w427 - w1 * w422),
        -(w1 * w424 - w7 * w421),
        -(w423 - w429),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        w419,
        0.0,
        0.0,
        w418,
        -(w425 - w428),
        -(w429 - w31 * w421),
        -(w31 * w422 - w18 * w424),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w432,
        w435,
        w437,
        w439,
        -(w49 * w440 - w442),
        -(w56 * w443 - w444),
        -(w68 * w441 - w445),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w434,
        w432,
        w438,
        w437,
        -(w63 * w440 - w49 * w441),
        -(w445 - w446),
        -(w447 - w63 * w443),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w436,
        w439,
        w432,
        w434,
        -(w446 - w66 * w441),
        -(w66 * w443 - w56 * w440),
        -(w442 - w448),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        w438,
        w436,
        w435,
        w432,
        -(w444 - w447),
        -(w448 - w52 * w440),
        -(w52 * w441 - w68 * w443),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w98 * w449 - w451),
        -(w103 * w452 - w453),
        -(w117 * w450 - w454),
        w117 * w457 + w98 * w460 + w103 * w463,
        w117 * w466 + w98 * w469 + w103 * w472,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w112 * w449 - w98 * w450),
        -(w454 - w473),
        -(w474 - w112 * w452),
        w106 * w457 + w112 * w460 + w98 * w463,
        w106 * w466 + w112 * w469 + w98 * w472,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w473 - w115 * w450),
        -(w115 * w452 - w103 * w449),
        -(w451 - w475),
        w103 * w457 + w106 * w460 + w115 * w463,
        w103 * w466 + w106 * w469 + w115 * w472,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w453 - w474),
        -(w475 - w104 * w449),
        -(w104 * w450 - w117 * w452),
        w104 * w457 + w117 * w460 + w106 * w463,
        w104 * w466 + w117 * w469 + w106 * w472,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w165 * w476 + w147 * w477 + w154 * w478,
        w165 * w479 + w147 * w480 + w154 * w481,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w147 * w482 - w484),
        -(w154 * w485 - w486),
        -(w165 * w483 - w487),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w150 * w476 + w161 * w477 + w147 * w478,
        w150 * w479 + w161 * w480 + w147 * w481,
        0.0,
        1.0,
        0.0,
        0.0,
        -(w161 * w482 - w147 * w483),
        -(w487 - w488),
        -(w489 - w161 * w485),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w154 * w476 + w150 * w477 + w148 * w478,
        w154 * w479 + w150 * w480 + w148 * w481,
        0.0,
        0.0,
        1.0,
        0.0,
        -(w488 - w148 * w483),
        -(w148 * w485 - w154 * w482),
        -(w484 - w490),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w178 * w476 + w165 * w477 + w150 * w478,
        w178 * w479 + w165 * w480 + w150 * w481,
        0.0,
        0.0,
        0.0,
        1.0,
        -(w486 - w489),
        -(w490 - w178 * w482),
        -(w178 * w483 - w165 * w485),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w493,
        0.0,
        0.0,
        w494,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -(w196 * w495 - w497),
        -(w203 * w498 - w499),
        -(w215 * w496 - w500),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w493,
        w501,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        -(w210 * w495 - w196 * w496),
        -(w500 - w502),
        -(w503 - w210 * w498),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w494,
        w493,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -(w502 - w213 * w496),
        -(w213 * w498 - w203 * w495),
        -(w497 - w504),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w501,
        0.0,
        0.0,
        w493,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        -(w499 - w503),
        -(w504 - w199 * w495),
        -(w199 * w496 - w215 * w498),
        w507 * c51,
        -(w507 * c1 * c3 - w507 * c2 * c0),
        w509 * c42,
        -(w509 * c1 * c0 - w509 * c2 * c3),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar1_e0 * w510 + bar1_e3 * w511,
        -(bar1_e2 * w511 - bar1_e1 * w510),
        bar1_e2 * w510 + bar1_e1 * w511,
        -(bar1_e0 * w511 - bar1_e3 * w510),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar2_e0 * w513 + (bar2_e1 * w515 + bar2_e2 * w516 + bar2_e3 * w517),
        -(bar2_e0 * w515 - bar2_e1 * w513 + (bar2_e2 * w517 - bar2_e3 * w516)),
        -(bar2_e0 * w516 - bar2_e2 * w513 + (bar2_e3 * w515 - bar2_e1 * w517)),
        -(bar2_e0 * w517 - bar2_e3 * w513 + (bar2_e1 * w516 - bar2_e2 * w515)),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(bar5_e3 * w518 - bar5_e0 * w519),
        bar5_e1 * w519 + bar5_e2 * w518,
        -(bar5_e1 * w518 - bar5_e2 * w519),
        bar5_e0 * w518 + bar5_e3 * w519,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w522 * c62,
        w524 * c61,
        -(w522 * c57 * c58 - w522 * c59 * c60),
        -(w524 * c59 * c58 - w524 * c57 * c60),
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 40, 40)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        w525 * (w508 * w525) * c100,
        w527 * c1 * c3 - w527 * c2 * c0,
        w525 * (w506 * w525) * c42,
        w528 * c2 * c3 - w528 * c1 * c0,
        0.0,
        0.0,
        0.0,
        bar1_e3 * w530 - bar1_e0 * w531 - w534 - w534,
        w535 + (w535 - (bar1_e1 * w531 + bar1_e2 * w530)),
        bar1_e1 * w530 - bar1_e2 * w531 - w536 - w536,
        w537 + (w537 - (bar1_e0 * w530 + bar1_e3 * w531)),
        w538 * w540 - w541 * w542,
        w541 * w543 - w539 * w540,
        w539 * w542 - w538 * w543,
        -(w558 + (bar2_e0 * w547 + (bar2_e2 * w548 - bar2_e1 * w550 + bar2_e3 * w551) + w558)),
        w559 + (bar2_e2 * w551 - bar2_e3 * w548 - (bar2_e0 * w550 + bar2_e1 * w547) + w559),
        w560 + (bar2_e0 * w548 - bar2_e2 * w547 - (bar2_e3 * w550 + bar2_e1 * w551) + w560),
        w561 + (bar2_e0 * w551 - bar2_e3 * w547 + (bar2_e1 * w548 + bar2_e2 * w550) + w561),
        w562 * w564 - w565 * w566,
        w565 * w567 - w563 * w564,
        w563 * w566 - w562 * w567,
        w568 * w570 - w571 * w572,
        w571 * w573 - w569 * w570,
        w569 * w572 - w568 * w573,
        -w587,
        -w592,
        w595 + (w595 - (bar5_e0 * w597 + bar5_e3 * w598)),
        bar5_e2 * w598 - bar5_e1 * w597 - w599 - w599,
        w600 + (w600 - (bar5_e2 * w597 + bar5_e1 * w598)),
        bar5_e0 * w598 - bar5_e3 * w597 - w601 - w601,
        w574 * w602 - w577 * w603,
        w577 * w604 - w575 * w602,
        w575 * w603 - w574 * w604,
        w605 * (w523 * w605) * c101,
        w605 * (w521 * w605) * c61,
        w607 * c57 * c58 - w607 * c59 * c60,
        w608 * c57 * c60 - w608 * c59 * c58,
        w609 * w611 - w612 * w613,
        w612 * w614 - w610 * w611,
        w610 * w613 - w609 * w614,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b; lam_R: multipliers of the redundant rows, which the others go with. 3260 operations."""
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    q_ddot = ca.SX.sym("q_ddot", 40)
    lam_R = ca.SX.sym("lam_R", 1)
    c = ca.SX.sym("c", 154)
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
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
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
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c50 = c[50]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
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
    c102 = c[102]
    c103 = c[103]
    c104 = c[104]
    c105 = c[105]
    w0 = bar1_e1 * -2.0
    w1 = bar1_e3 * -2.0
    w2 = 2 * bar1_e2
    w3 = 2 * bar1_e0
    w4 = bar1_e0_dot * w1 + bar1_e1_dot * w2 + w0 * bar1_e2_dot + bar1_e3_dot * w3
    w5 = w4 * c5
    w6 = bar1_e2 * -2.0
    w7 = 2 * bar1_e1
    w8 = bar1_e0_dot * w6 + w1 * bar1_e1_dot + bar1_e2_dot * w3 + bar1_e3_dot * w7
    w9 = w8 * c4
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * bar1_e3
    w12 = w0 * bar1_e0_dot + bar1_e1_dot * w3 + bar1_e2_dot * w11 + bar1_e3_dot * w6
    w13 = w12 * c7
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = 2 * bar1_e2**2
    w17 = 2 * bar1_e3**2
    w18 = 1.0 - w16 - w17
    w19 = w18 * c93
    w20 = bar1_e3 * w7
    w21 = bar1_e2 * w3
    w22 = w20 - w21
    w23 = w22 * c93
    w24 = w0 * w23
    w25 = w1 * w19 - w24
    w26 = bar1_e3 * w3
    w27 = bar1_e2 * w7
    w28 = w26 + w27
    w29 = w28 * c93
    w30 = w1 * w29
    w31 = w6 * w23 - w30
    w32 = w6 * w19
    w33 = w0 * w29 - w32
    w34 = w31 * bar1_x_ddot + w25 * bar1_y_ddot + w33 * bar1_z_ddot + (w0 * (w0 * c6) + w6 * (w6 * c8) + w1 * (w1 * c9)) * bar1_e0_ddot
    w35 = w3 * c6
    w36 = w0 * w35 + bar1_e3 * bar1_e2 * c54
    w37 = w3 * c8
    w38 = w0 * c9
    w39 = w6 * w37 + bar1_e1 * bar1_e3 * c53
    w40 = w6 * c6
    w41 = w7 * c8
    w42 = w3 * c9
    w43 = bar1_e1 * bar1_e2 * c52 + w1 * w42
    w44 = w0 * w10 + w6 * w14 + w1 * w15 + w25 * c94 - (w34 + w36 * bar1_e1_ddot + w39 * bar1_e2_ddot + w43 * bar1_e3_ddot)
    w45 = w28 * c10
    w46 = w18 * c10
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
    w57 = w56 * c14
    w58 = bar2_e3 * -2.0
    w59 = bar2_e0_dot * w58 + w50 * bar2_e1_dot + w53 * bar2_e2_dot + w48 * bar2_e3_dot
    w60 = w59 * c14
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
    w73 = w72 * c14
    w74 = bar2_e2 * w62
    w75 = w48 * bar2_e3
    w76 = w74 - w75
    w77 = w76 * c14
    w78 = w55 * w77
    w79 = w53 * w73 - w78
    w80 = w48 * w73
    w81 = w80 - w54 * w77
    w82 = w58 * w73
    w83 = w48 * w77
    w84 = w82 - w83
    w85 = w50 * w73 - w53 * w77
    w86 = bar2_z_ddot * c11 + w79 * bar2_e0_ddot + w81 * bar2_e1_ddot + w84 * bar2_e2_ddot + w85 * bar2_e3_ddot
    w87 = 1.0 - 2 * bar3_e1**2
    w88 = 2 * bar3_e2**2
    w89 = w87 - w88
    w90 = bar3_e2 * -2.0
    w91 = bar3_e3 * -2.0
    w92 = 2 * bar3_e0
    w93 = 2 * bar3_e1
    w94 = bar3_e0_dot * w90 + bar3_e1_dot * w91 + bar3_e2_dot * w92 + bar3_e3_dot * w93
    w95 = w94 * c21
    w96 = bar3_e1 * -2.0
    w97 = 2 * bar3_e3
    w98 = bar3_e0_dot * w96 + bar3_e1_dot * w92 + bar3_e2_dot * w97 + w90 * bar3_e3_dot
    w99 = w98 * c21
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
    w111 = w110 * c21
    w112 = w101 + w102
    w113 = w112 * c21
    w114 = w90 * w113
    w115 = w96 * w111 - w114
    w116 = w92 * w111
    w117 = w116 - w97 * w113
    w118 = w91 * w111
    w119 = w92 * w113
    w120 = w118 - w119
    w121 = w104 * w111 - w96 * w113
    w122 = bar3_z_ddot * c12 + w115 * bar3_e0_ddot + w117 * bar3_e1_ddot + w120 * bar3_e2_ddot + w121 * bar3_e3_ddot
    w123 = w89 * w100 - (w103 * w106 + (w107 + w108) * w109) - w122
    w124 = w110 * c63
    w125 = w92 * w124
    w126 = w112 * c63
    w127 = w125 - w97 * w126
    w128 = hinge2_angle / 2.0
    w129 = ca.cos(w128)
    w130 = w129 * c16 * c19 - w129 * c18 * c17
    w131 = w72 * c15
    w132 = w76 * c15
    w133 = w50 * w131 - w53 * w132
    w134 = w104 * w124 - w96 * w126
    w135 = w129 * c20
    w136 = w91 * w124
    w137 = w92 * w126
    w138 = w136 - w137
    w139 = ca.sin(w128)
    w140 = w139 * c22
    w141 = w90 * w126
    w142 = w96 * w124 - w141
    w143 = w139 * c18 * c19 - w139 * c16 * c17
    w144 = hinge1_angle / 2.0
    w145 = ca.cos(w144)
    w146 = w145 / 2.0
    w147 = ca.sin(w144)
    w148 = w147 / 2.0
    w149 = bar1_e0 * w146 - bar1_e3 * w148
    w150 = w58 * w131
    w151 = w48 * w132
    w152 = w150 - w151
    w153 = bar1_e2 * w148 + bar1_e1 * w146
    w154 = (w127 * w130 - (w133 + w134 * w135 + w138 * w140) + w142 * w143) * w149 - (w134 * w140 - w152 - w135 * w138 - w127 * w143 + w130 * w142) * w153
    w155 = w48 * w131
    w156 = w155 - w54 * w132
    w157 = bar1_e2 * w146 - bar1_e1 * w148
    w158 = w55 * w132
    w159 = w53 * w131 - w158
    w160 = bar1_e0 * w148 + bar1_e3 * w146
    w161 = w154 + (w138 * w143 - (w156 + w130 * w134) - w127 * w135 + w140 * w142) * w157 + (w159 + w134 * w143 + w130 * w138 + w127 * w140 + w135 * w142) * w160
    w162 = w89 * c63
    w163 = w97 * w162 - w90 * w124
    w164 = w52 * c15
    w165 = w53 * w164
    w166 = w165 - w155
    w167 = w96 * w162
    w168 = w167 - w125
    w169 = w92 * w162
    w170 = w169 - w93 * w124
    w171 = w90 * w162 - w136
    w172 = w48 * w164
    w173 = w172 - w62 * w131
    w174 = w149 * (w130 * w163 - (w166 + w135 * w168 + w140 * w170) + w143 * w171) - w153 * (w140 * w168 - w173 - w135 * w170 - w143 * w163 + w130 * w171)
    w175 = w54 * w164 - w55 * w131
    w176 = w55 * w164 - w150
    w177 = w174 + w157 * (w143 * w170 - (w175 + w130 * w168) - w135 * w163 + w140 * w171) + w160 * (w176 + w143 * w168 + w130 * w170 + w140 * w163 + w135 * w171)
    w178 = w139 / 2.0
    w179 = w178 * c20
    w180 = w129 / 2.0
    w181 = w180 * c22
    w182 = w178 * c18 * c17 - w178 * c16 * c19
    w183 = w180 * c18 * c19 - w180 * c16 * c17
    w184 = bar2_e0 * w179 + (bar2_e1 * w181 + bar2_e2 * w182 + bar2_e3 * w183)
    w185 = bar2_e0 * w183 - bar2_e3 * w179 + (bar2_e1 * w182 - bar2_e2 * w181)
    w186 = bar2_e0 * w182 - bar2_e2 * w179 + (bar2_e3 * w181 - bar2_e1 * w183)
    w187 = bar2_e0 * w181 - bar2_e1 * w179 + (bar2_e2 * w183 - bar2_e3 * w182)
    w188 = w171 * w184 - (w168 * w185 + w170 * w186 + w163 * w187)
    w189 = bar4_e1 * -2.0
    w190 = 2 * bar4_e1
    w191 = w190 * bar4_e3
    w192 = 2 * bar4_e0
    w193 = w192 * bar4_e2
    w194 = w191 - w193
    w195 = w194 * c55
    w196 = w189 * w195
    w197 = bar4_e3 * w192
    w198 = w190 * bar4_e2
    w199 = w197 + w198
    w200 = w199 * c55
    w201 = w192 * w200
    w202 = w196 - w201
    w203 = hinge4_angle / 2.0
    w204 = ca.cos(w203)
    w205 = w204 / 2.0
    w206 = ca.sin(w203)
    w207 = w206 / 2.0
    w208 = bar5_e0 * w205 + w207 * bar5_e3
    w209 = w192 * w195
    w210 = w209 - w190 * w200
    w211 = w205 * bar5_e1 - w207 * bar5_e2
    w212 = 2 * bar4_e3
    w213 = bar4_e2 * -2.0
    w214 = w195 * w212 - w200 * w213
    w215 = w207 * bar5_e1 + w205 * bar5_e2
    w216 = bar4_e3 * -2.0
    w217 = w200 * w216
    w218 = w195 * w213 - w217
    w219 = w205 * bar5_e3 - bar5_e0 * w207
    w220 = w202 * w208 - w210 * w211 + w214 * w215 - w218 * w219
    w221 = 2 * bar5_e0
    w222 = bar5_e1 * w221
    w223 = 2 * bar5_e2
    w224 = bar5_e3 * w223
    w225 = w222 + w224
    w226 = w225 * c56
    w227 = w221 * w226
    w228 = 2 * bar5_e1
    w229 = 1.0 - 2 * bar5_e1**2
    w230 = 2 * bar5_e3**2
    w231 = w229 - w230
    w232 = w231 * c56
    w233 = w227 - w228 * w232
    w234 = hinge5_angle / 2.0
    w235 = ca.sin(w234) / 2.0
    w236 = w235 * c57 * c58 - w235 * c59 * c60
    w237 = bar5_e1 * -2.0
    w238 = w226 * w237
    w239 = w221 * w232
    w240 = w238 - w239
    w241 = ca.cos(w234) / 2.0
    w242 = w241 * c59 * c58 - w241 * c57 * c60
    w243 = 2 * bar5_e3
    w244 = bar5_e2 * -2.0
    w245 = w226 * w243 - w232 * w244
    w246 = w241 * c61
    w247 = (w206 * w214 - w204 * w210 - w233) * w236 - (w202 * w204 + w206 * w218 + w240) * w242 + (w206 * w210 + w204 * w214 + w245) * w246
    w248 = bar5_e3 * -2.0
    w249 = w232 * w248
    w250 = w226 * w244 - w249
    w251 = w235 * c62
    w252 = w247 - (w202 * w206 - w204 * w218 - w250) * w251
    w253 = ca.sqrt(w177**2 + w188**2 + w220**2 + w252**2)
    w254 = w177 / w253
    w255 = w142 * w184 - (w134 * w185 + w138 * w186 + w127 * w187)
    w256 = w188 / w253
    w257 = 2 * bar4_e2
    w258 = 2 * bar4_e2**2
    w259 = 2 * bar4_e3**2
    w260 = 1.0 - w258 - w259
    w261 = w260 * c55
    w262 = w200 * w257 - w189 * w261
    w263 = w192 * w261
    w264 = w217 - w263
    w265 = w201 - w212 * w261
    w266 = w213 * w261
    w267 = w189 * w200 - w266
    w268 = w208 * w262 - w211 * w264 + w215 * w265 - w219 * w267
    w269 = w220 / w253
    w270 = bar5_e2 * w228
    w271 = bar5_e3 * w221
    w272 = w270 - w271
    w273 = w272 * c56
    w274 = w221 * w273
    w275 = w249 - w274
    w276 = w223 * w232 - w237 * w273
    w277 = w239 - w243 * w273
    w278 = w236 * (w206 * w265 - w204 * w264 - w275) - w242 * (w204 * w262 + w206 * w267 + w276) + w246 * (w206 * w264 + w204 * w265 + w277)
    w279 = w244 * w273
    w280 = w232 * w237 - w279
    w281 = w278 - w251 * (w206 * w262 - w204 * w267 - w280)
    w282 = w252 / w253
    w283 = w161 * w254 + w255 * w256 + w268 * w269 + w281 * w282
    w284 = w161 - w254 * w283
    w285 = w141 - w169
    w286 = w151 - w50 * w164
    w287 = w137 - w104 * w162
    w288 = w93 * w126 - w91 * w162
    w289 = w91 * w126 - w167
    w290 = w62 * w132 - w58 * w164
    w291 = w149 * (w130 * w285 - (w286 + w135 * w287 + w140 * w288) + w143 * w289) - w153 * (w140 * w287 - w290 - w135 * w288 - w143 * w285 + w130 * w289)
    w292 = w158 - w172
    w293 = w58 * w132 - w165
    w294 = w291 + w157 * (w143 * w288 - (w292 + w130 * w287) - w135 * w285 + w140 * w289) + w160 * (w293 + w143 * w287 + w130 * w288 + w140 * w285 + w135 * w289)
    w295 = w184 * w289 - (w185 * w287 + w186 * w288 + w187 * w285)
    w296 = w263 - w195 * w257
    w297 = w190 * w261 - w195 * w216
    w298 = w266 - w209
    w299 = w216 * w261 - w196
    w300 = w208 * w296 - w211 * w297 + w215 * w298 - w219 * w299
    w301 = w228 * w273 - w226 * w248
    w302 = w274 - w223 * w226
    w303 = w279 - w227
    w304 = w236 * (w206 * w298 - w204 * w297 - w301) - w242 * (w204 * w296 + w206 * w299 + w302) + w246 * (w206 * w297 + w204 * w298 + w303)
    w305 = w248 * w273 - w238
    w306 = w304 - w251 * (w206 * w296 - w204 * w299 - w305)
    w307 = w254 * w294 + w256 * w295 + w269 * w300 + w282 * w306
    w308 = w294 - w254 * w307
    w309 = w295 - w256 * w307
    w310 = w300 - w269 * w307
    w311 = w306 - w282 * w307
    w312 = ca.sqrt(w308**2 + w309**2 + w310**2 + w311**2)
    w313 = w308 / w312
    w314 = w255 - w256 * w283
    w315 = w309 / w312
    w316 = w268 - w269 * w283
    w317 = w310 / w312
    w318 = w281 - w282 * w283
    w319 = w311 / w312
    w320 = w284 * w313 + w314 * w315 + w316 * w317 + w318 * w319
    w321 = w284 - w313 * w320
    w322 = w314 - w315 * w320
    w323 = w316 - w317 * w320
    w324 = w318 - w319 * w320
    w325 = ca.sqrt(w321**2 + w322**2 + w323**2 + w324**2)
    w326 = w321 / w325
    w327 = w59 * c24
    w328 = w66 * c23
    w329 = w66 * w327 - w59 * w328
    w330 = w56 * c26
    w331 = w59 * w330 - w56 * w327
    w332 = w56 * w328 - w66 * w330
    w333 = w52 * c14
    w334 = w83 - w50 * w333
    w335 = w53 * w333
    w336 = w335 - w80
    w337 = w55 * c25
    w338 = w62 * c27
    w339 = w48 * c28
    w340 = bar2_e1 * bar2_e2 * c41 + w58 * w339
    w341 = w58 * w338 + bar2_e0 * bar2_e2 * c45
    w342 = w336 * bar2_x_ddot + w334 * bar2_y_ddot + bar2_z_ddot * w85 + bar2_e0_ddot * w340 + bar2_e1_ddot * w341
    w343 = w54 * w337 + bar2_e0 * bar2_e1 * c44
    w344 = w55 * w329 + w62 * w331 + w48 * w332 + w334 * c94 - (w342 + bar2_e2_ddot * w343 + bar2_e3_ddot * (w55 * w337 + w62 * w338 + w48 * w339))
    w345 = bar3_e3 * w92
    w346 = bar3_e2 * w93
    w347 = w345 + w346
    w348 = 2 * bar3_e3**2
    w349 = w89 * c21
    w350 = w96 * w349
    w351 = w91 * w113 - w350
    w352 = w92 * w349
    w353 = w114 - w352
    w354 = w93 * w113 - w91 * w349
    w355 = w119 - w104 * w349
    w356 = bar3_y_ddot * c12 + bar3_e0_ddot * w351 + bar3_e1_ddot * w353 + bar3_e2_ddot * w354 + bar3_e3_ddot * w355
    w357 = c96 + (w100 * w110 - (w106 * w347 + w109 * (w87 - w348))) - w356
    w358 = 1.0 - w88 - w348
    w359 = w90 * w349 - w118
    w360 = w97 * w349 - w90 * w111
    w361 = w352 - w93 * w111
    w362 = w350 - w116
    w363 = bar3_x_ddot * c12 + bar3_e0_ddot * w359 + bar3_e1_ddot * w360 + bar3_e2_ddot * w361 + bar3_e3_ddot * w362
    w364 = w100 * w112 - (w106 * w358 + w109 * (w346 - w345)) - w363
    w365 = w105 * c30
    w366 = w94 * c29
    w367 = w94 * w365 - w105 * w366
    w368 = w98 * c32
    w369 = w105 * w368 - w98 * w365
    w370 = w98 * w366 - w94 * w368
    w371 = w90 * c31
    w372 = w93 * c33
    w373 = w92 * c34
    w374 = bar3_e1 * bar3_e2 * c38 + w91 * w373
    w375 = w91 * w372 + bar3_e2 * bar3_e0 * c36
    w376 = bar3_x_ddot * w362 + bar3_y_ddot * w355 + bar3_z_ddot * w121 + bar3_e0_ddot * w374 + bar3_e1_ddot * w375
    w377 = w97 * w371 + bar3_e1 * bar3_e0 * c35
    w378 = w90 * w367 + w93 * w369 + w92 * w370 + w355 * c94 - (w376 + bar3_e2_ddot * w377 + bar3_e3_ddot * (w90 * w371 + w93 * w372 + w92 * w373))
    w379 = 1.0 - 2 * bar4_e1**2
    w380 = w379 - w259
    w381 = w89 * w380
    w382 = bar4_e1 * w192
    w383 = bar4_e3 * w257
    w384 = w382 + w383
    w385 = w110 * w384
    w386 = w381 - w385
    w387 = w112 * w384
    w388 = w198 - w197
    w389 = w89 * w388
    w390 = w387 - w389
    w391 = w110 * w388
    w392 = w112 * w380
    w393 = w391 - w392
    w394 = w378 - (w104 * w386 + w96 * w390 + w92 * w393) * lam_R0
    w395 = w92 * c33
    w396 = w96 * c34
    w397 = w90 * w395 + bar3_e1 * bar3_e3 * c39
    w398 = bar3_e3 * bar3_e0 * c37 + w104 * w396
    w399 = bar3_x_ddot * w361 + bar3_y_ddot * w354 + bar3_z_ddot * w120 + bar3_e0_ddot * w397 + bar3_e1_ddot * w398
    w400 = w97 * w367 + w92 * w369 + w96 * w370 + w354 * c94 - (w399 + bar3_e2_ddot * (w97 * (w97 * c31) + w92 * w395 + w96 * w396) + bar3_e3_ddot * w377)
    w401 = w400 - lam_R0 * (w91 * w386 + w92 * w390 + w93 * w393)
    w402 = w92 * c31
    w403 = w96 * w402 + bar3_e2 * bar3_e3 * c40
    w404 = bar3_x_ddot * w360 + bar3_y_ddot * w353 + bar3_z_ddot * w117 + bar3_e0_ddot * w403 + bar3_e1_ddot * (w92 * w402 + w91 * (w91 * c33) + w104 * (w104 * c34))
    w405 = w92 * w367 + w91 * w369 + w104 * w370 + w353 * c94 - (w404 + bar3_e2_ddot * w398 + bar3_e3_ddot * w375)
    w406 = w405 - lam_R0 * (w92 * w386 + w97 * w390 + w90 * w393)
    w407 = bar3_x_ddot * w359 + bar3_y_ddot * w351 + bar3_z_ddot * w115 + bar3_e0_ddot * (w96 * (w96 * c31) + w90 * (w90 * c33) + w91 * (w91 * c34))
    w408 = w96 * w367 + w90 * w369 + w91 * w370 + w351 * c94 - (w407 + bar3_e1_ddot * w403 + bar3_e2_ddot * w397 + bar3_e3_ddot * w374)
    w409 = w408 - lam_R0 * (w96 * w386 + w90 * w390 + w91 * w393)
    w410 = w344 + w123 * w133 + w286 * w357 + w166 * w364 + w135 * w394 + w140 * w401 - w130 * w406 - w143 * w409
    w411 = w62 * w77 - w58 * w333
    w412 = w48 * w333
    w413 = w412 - w62 * w73
    w414 = w48 * c27
    w415 = w53 * c28
    w416 = w55 * w414 + bar2_e1 * bar2_e3 * c46
    w417 = bar2_e0 * bar2_e3 * c48 + w50 * w415
    w418 = bar2_x_ddot * w413 + bar2_y_ddot * w411 + bar2_z_ddot * w84 + bar2_e0_ddot * w416 + bar2_e1_ddot * w417
    w419 = w54 * w329 + w48 * w331 + w53 * w332 + w411 * c94 - (w418 + bar2_e2_ddot * (w54 * (w54 * c25) + w48 * w414 + w53 * w415) + bar2_e3_ddot * w343)
    w420 = w419 + w123 * w152 + w290 * w357 + w173 * w364 - w140 * w394 + w135 * w401 + w143 * w406 - w130 * w409
    w421 = w78 - w412
    w422 = w54 * w333 - w55 * w73
    w423 = w48 * c25
    w424 = w53 * w423 + bar2_e2 * bar2_e3 * c47
    w425 = bar2_x_ddot * w422 + bar2_y_ddot * w421 + bar2_z_ddot * w81 + bar2_e0_ddot * w424 + bar2_e1_ddot * (w48 * w423 + w58 * (w58 * c27) + w50 * (w50 * c28))
    w426 = w48 * w329 + w58 * w331 + w50 * w332 + w421 * c94 - (w425 + bar2_e2_ddot * w417 + bar2_e3_ddot * w341)
    w427 = w426 + w123 * w156 + w292 * w357 + w175 * w364 + w130 * w394 - w143 * w401 + w135 * w406 - w140 * w409
    w428 = w58 * w77 - w335
    w429 = w55 * w333 - w82
    w430 = bar2_x_ddot * w429 + bar2_y_ddot * w428 + bar2_z_ddot * w79 + bar2_e0_ddot * (w53 * (w53 * c25) + w55 * (w55 * c27) + w58 * (w58 * c28))
    w431 = w53 * w329 + w55 * w331 + w58 * w332 + w428 * c94 - (w430 + bar2_e1_ddot * w424 + bar2_e2_ddot * w416 + bar2_e3_ddot * w340)
    w432 = w431 + w123 * w159 + w293 * w357 + w176 * w364 + w143 * w394 + w130 * w401 + w140 * w406 + w135 * w409
    w433 = w149 * w410 - w153 * w420 + w157 * w427 - w160 * w432
    w434 = w322 / w325
    w435 = w185 * w394 + w186 * w401 + w187 * w406 - w184 * w409
    w436 = w323 / w325
    w437 = w216 * bar4_e0_dot + w257 * bar4_e1_dot + w189 * bar4_e2_dot + w192 * bar4_e3_dot
    w438 = w437 * c72
    w439 = w213 * bar4_e0_dot + w216 * bar4_e1_dot + w192 * bar4_e2_dot + w190 * bar4_e3_dot
    w440 = w439 * c71
    w441 = w438 * w439 - w437 * w440
    w442 = w189 * bar4_e0_dot + w192 * bar4_e1_dot + w212 * bar4_e2_dot + w213 * bar4_e3_dot
    w443 = w442 * c75
    w444 = w437 * w443 - w438 * w442
    w445 = w440 * w442 - w439 * w443
    w446 = w260 * c78
    w447 = w194 * c78
    w448 = w190 * w446 - w216 * w447
    w449 = w192 * w447
    w450 = w199 * c78
    w451 = w449 - w190 * w450
    w452 = w216 * w450
    w453 = w192 * w446
    w454 = w452 - w453
    w455 = w192 * c76
    w456 = w189 * c77
    w457 = w213 * w455 + bar4_e1 * bar4_e3 * c85
    w458 = bar4_e3 * bar4_e0 * c87 + w257 * w456
    w459 = w451 * bar4_x_ddot + w448 * bar4_y_ddot + w454 * bar4_z_ddot + w457 * bar4_e0_ddot + w458 * bar4_e1_ddot
    w460 = w213 * c73
    w461 = w190 * c76
    w462 = w192 * c77
    w463 = w212 * w460 + bar4_e1 * bar4_e0 * c83
    w464 = w212 * w441 + w192 * w444 + w189 * w445 + w448 * c94 - (w459 + (w212 * (w212 * c73) + w192 * w455 + w189 * w456) * bar4_e2_ddot + w463 * bar4_e3_ddot)
    w465 = w385 - w381
    w466 = w389 - w387
    w467 = w392 - w391
    w468 = w464 - lam_R0 * (w216 * w465 + w192 * w466 + w190 * w467)
    w469 = w437 * c78
    w470 = w439 * c78
    w471 = w437 * w469 + w439 * w470
    w472 = w442 * w470
    w473 = w379 - w258
    w474 = w442 * w469
    w475 = w213 * w446
    w476 = w189 * w450 - w475
    w477 = w192 * w450
    w478 = w477 - w212 * w446
    w479 = w257 * w450 - w189 * w446
    w480 = bar4_z_ddot * c74 + bar4_e0_ddot * w476 + bar4_e1_ddot * w478 + w454 * bar4_e2_ddot + bar4_e3_ddot * w479
    w481 = w194 * w471 - w384 * w472 - w473 * w474 - w480
    w482 = w383 - w382
    w483 = w189 * w447
    w484 = w216 * w446 - w483
    w485 = w475 - w449
    w486 = w453 - w257 * w447
    w487 = bar4_y_ddot * c74 + bar4_e0_ddot * w484 + bar4_e1_ddot * w485 + w448 * bar4_e2_ddot + bar4_e3_ddot * w486
    w488 = c97 + (w199 * w471 - w380 * w472 - w474 * w482) - w487
    w489 = w191 + w193
    w490 = w213 * w447 - w452
    w491 = w212 * w447 - w213 * w450
    w492 = w483 - w477
    w493 = bar4_x_ddot * c74 + bar4_e0_ddot * w490 + bar4_e1_ddot * w491 + w451 * bar4_e2_ddot + bar4_e3_ddot * w492
    w494 = w260 * w471 - w388 * w472 - w474 * w489 - w493
    w495 = w468 - w264 * w481 - w297 * w488 - w210 * w494
    w496 = bar4_e1 * bar4_e2 * c79 + w216 * w462
    w497 = w216 * w461 + bar4_e0 * bar4_e2 * c84
    w498 = bar4_x_ddot * w492 + bar4_y_ddot * w486 + bar4_z_ddot * w479 + bar4_e0_ddot * w496 + bar4_e1_ddot * w497
    w499 = w213 * w441 + w190 * w444 + w192 * w445 + w486 * c94 - (w498 + bar4_e2_ddot * w463 + bar4_e3_ddot * (w213 * w460 + w190 * w461 + w192 * w462))
    w500 = w499 - lam_R0 * (w257 * w465 + w189 * w466 + w192 * w467)
    w501 = w500 - w262 * w481 - w296 * w488 - w202 * w494
    w502 = w192 * c73
    w503 = w189 * w502 + bar4_e3 * bar4_e2 * c86
    w504 = bar4_x_ddot * w491 + bar4_y_ddot * w485 + bar4_z_ddot * w478 + bar4_e0_ddot * w503 + bar4_e1_ddot * (w192 * w502 + w216 * (w216 * c76) + w257 * (w257 * c77))
    w505 = w192 * w441 + w216 * w444 + w257 * w445 + w485 * c94 - (w504 + w458 * bar4_e2_ddot + bar4_e3_ddot * w497)
    w506 = w505 - lam_R0 * (w192 * w465 + w212 * w466 + w213 * w467)
    w507 = w506 - w265 * w481 - w298 * w488 - w214 * w494
    w508 = bar4_x_ddot * w490 + bar4_y_ddot * w484 + bar4_z_ddot * w476 + bar4_e0_ddot * (w189 * (w189 * c73) + w213 * (w213 * c76) + w216 * (w216 * c77))
    w509 = w189 * w441 + w213 * w444 + w216 * w445 + w484 * c94 - (w508 + bar4_e1_ddot * w503 + w457 * bar4_e2_ddot + bar4_e3_ddot * w496)
    w510 = w509 - lam_R0 * (w189 * w465 + w213 * w466 + w216 * w467)
    w511 = w510 - w267 * w481 - w299 * w488 - w218 * w494
    w512 = w211 * w495 - w208 * w501 - w215 * w507 + w219 * w511
    w513 = w324 / w325
    w514 = w248 * bar5_e0_dot + w223 * bar5_e1_dot + w237 * bar5_e2_dot + w221 * bar5_e3_dot
    w515 = w514 * c66
    w516 = w244 * bar5_e0_dot + w248 * bar5_e1_dot + w221 * bar5_e2_dot + w228 * bar5_e3_dot
    w517 = w516 * c65
    w518 = w515 * w516 - w514 * w517
    w519 = w237 * bar5_e0_dot + w221 * bar5_e1_dot + w243 * bar5_e2_dot + w244 * bar5_e3_dot
    w520 = w519 * c68
    w521 = w514 * w520 - w515 * w519
    w522 = w517 * w519 - w516 * w520
    w523 = w272 * c80
    w524 = w221 * w523
    w525 = w225 * c80
    w526 = w524 - w223 * w525
    w527 = w237 * w525
    w528 = w231 * c80
    w529 = w221 * w528
    w530 = w527 - w529
    w531 = w223 * w528 - w237 * w523
    w532 = w244 * c67
    w533 = w228 * c69
    w534 = w221 * c70
    w535 = bar5_e1 * bar5_e2 * c90 + w248 * w534
    w536 = w248 * w533 + bar5_e0 * bar5_e2 * c88
    w537 = w530 * bar5_x_ddot + w526 * bar5_y_ddot + w531 * bar5_z_ddot + w535 * bar5_e0_ddot + w536 * bar5_e1_ddot
    w538 = w243 * w532 + bar5_e0 * bar5_e1 * c82
    w539 = w244 * w518 + w228 * w521 + w221 * w522 + w526 * c94 - (w537 + w538 * bar5_e2_ddot + (w244 * w532 + w228 * w533 + w221 * w534) * bar5_e3_ddot)
    w540 = w519 * c80
    w541 = w514 * c80
    w542 = w519 * w540 + w514 * w541
    w543 = bar5_e3 * w228
    w544 = bar5_e2 * w221
    w545 = w543 - w544
    w546 = w516 * w540
    w547 = 2 * bar5_e2**2
    w548 = w516 * w541
    w549 = w244 * w523
    w550 = w237 * w528 - w549
    w551 = w529 - w243 * w523
    w552 = w248 * w528
    w553 = w552 - w524
    w554 = bar5_z_ddot * c64 + bar5_e0_ddot * w550 + bar5_e1_ddot * w551 + bar5_e2_ddot * w553 + w531 * bar5_e3_ddot
    w555 = w225 * w542 - w545 * w546 - (w229 - w547) * w548 - w554
    w556 = w481 + w555
    w557 = w270 + w271
    w558 = w248 * w523 - w527
    w559 = w221 * w525
    w560 = w549 - w559
    w561 = w228 * w523 - w248 * w525
    w562 = bar5_y_ddot * c64 + bar5_e0_ddot * w558 + bar5_e1_ddot * w560 + bar5_e2_ddot * w561 + w526 * bar5_e3_ddot
    w563 = c98 + (w231 * w542 - w546 * w557 - w548 * (w224 - w222)) - w562
    w564 = w488 + w563
    w565 = 1.0 - w547 - w230
    w566 = w244 * w525 - w552
    w567 = w243 * w525 - w244 * w528
    w568 = w559 - w228 * w528
    w569 = bar5_x_ddot * c64 + bar5_e0_ddot * w566 + bar5_e1_ddot * w567 + bar5_e2_ddot * w568 + w530 * bar5_e3_ddot
    w570 = w272 * w542 - w546 * w565 - w548 * (w543 + w544) - w569
    w571 = w494 + w570
    w572 = w221 * c69
    w573 = w237 * c70
    w574 = w244 * w572 + bar5_e3 * bar5_e1 * c91
    w575 = bar5_e0 * bar5_e3 * c89 + w223 * w573
    w576 = bar5_x_ddot * w568 + bar5_y_ddot * w561 + bar5_z_ddot * w553 + bar5_e0_ddot * w574 + bar5_e1_ddot * w575
    w577 = w243 * w518 + w221 * w521 + w237 * w522 + w561 * c94 - (w576 + bar5_e2_ddot * (w243 * (w243 * c67) + w221 * w572 + w237 * w573) + w538 * bar5_e3_ddot)
    w578 = w242 * (w539 + w204 * w501 + w206 * w511 - w276 * w556 - w302 * w564 - w240 * w571) + w236 * (w577 + w204 * w495 - w206 * w507 - w275 * w556 - w301 * w564 - w233 * w571)
    w579 = w221 * c67
    w580 = w237 * w579 + bar5_e3 * bar5_e2 * c92
    w581 = bar5_x_ddot * w567 + bar5_y_ddot * w560 + bar5_z_ddot * w551 + bar5_e0_ddot * w580 + bar5_e1_ddot * (w221 * w579 + w248 * (w248 * c69) + w223 * (w223 * c70))
    w582 = w221 * w518 + w248 * w521 + w223 * w522 + w560 * c94 - (w581 + bar5_e2_ddot * w575 + w536 * bar5_e3_ddot)
    w583 = bar5_x_ddot * w566 + bar5_y_ddot * w558 + bar5_z_ddot * w550 + bar5_e0_ddot * (w237 * (w237 * c67) + w244 * (w244 * c69) + w248 * (w248 * c70))
    w584 = w237 * w518 + w244 * w521 + w248 * w522 + w558 * c94 - (w583 + bar5_e1_ddot * w580 + bar5_e2_ddot * w574 + w535 * bar5_e3_ddot)
    w585 = w578 - w246 * (w582 + w206 * w495 + w204 * w507 - w277 * w556 - w303 * w564 - w245 * w571) - w251 * (w584 - w206 * w501 + w204 * w511 - w280 * w556 - w305 * w564 - w250 * w571)
    w586 = w347 * w384
    w587 = w103 * w380
    w588 = w586 - w587
    w589 = w103 * w388
    w590 = w358 * w384
    w591 = w589 - w590
    w592 = w358 * w380
    w593 = w347 * w388
    w594 = w592 - w593
    w595 = w104 * w588 + w96 * w591 + w92 * w594
    w596 = w91 * w588 + w92 * w591 + w93 * w594
    w597 = w92 * w588 + w97 * w591 + w90 * w594
    w598 = w96 * w588 + w90 * w591 + w91 * w594
    w599 = w149 * (w135 * w595 + w140 * w596 - w130 * w597 - w143 * w598) - w153 * (w135 * w596 - w140 * w595 + w143 * w597 - w130 * w598)
    w600 = w599 + w157 * (w130 * w595 - w143 * w596 + w135 * w597 - w140 * w598) - w160 * (w143 * w595 + w130 * w596 + w140 * w597 + w135 * w598)
    w601 = w185 * w595 + w186 * w596 + w187 * w597 - w184 * w598
    w602 = w587 - w586
    w603 = w590 - w589
    w604 = w593 - w592
    w605 = w216 * w602 + w192 * w603 + w190 * w604
    w606 = w257 * w602 + w189 * w603 + w192 * w604
    w607 = w192 * w602 + w212 * w603 + w213 * w604
    w608 = w189 * w602 + w213 * w603 + w216 * w604
    w609 = w211 * w605 - w208 * w606 - w215 * w607 + w219 * w608
    w610 = w242 * (w204 * w606 + w206 * w608) + w236 * (w204 * w605 - w206 * w607) - w246 * (w206 * w605 + w204 * w607)
    w611 = w610 - w251 * (w204 * w608 - w206 * w606)
    w612 = w254 * w600 + w256 * w601 + w269 * w609 + w282 * w611
    w613 = w600 - w254 * w612
    w614 = w601 - w256 * w612
    w615 = w609 - w269 * w612
    w616 = w611 - w282 * w612
    w617 = w313 * w613 + w315 * w614 + w317 * w615 + w319 * w616
    w618 = w613 - w313 * w617
    w619 = w614 - w315 * w617
    w620 = w615 - w317 * w617
    w621 = w616 - w319 * w617
    w622 = w326 * w618 + w434 * w619 + w436 * w620 + w513 * w621
    w623 = w618 - w326 * w622
    w624 = w619 - w434 * w622
    w625 = w620 - w436 * w622
    w626 = w621 - w513 * w622
    w627 = ca.sqrt(w623**2 + w624**2 + w625**2 + w626**2)
    w628 = (w433 * (w623 / w627) + w435 * (w624 / w627) + w512 * (w625 / w627) + w585 * (w626 / w627)) / w627
    w629 = (w326 * w433 + w434 * w435 + w436 * w512 + w513 * w585 - w622 * w628) / w325
    w630 = w123 + w629
    w631 = w52 * w61 - w65 * w67 - (w68 - w69) * w70 - w86 + w630
    w632 = w22 * c10
    w633 = w0 * w632
    w634 = w74 + w75
    w635 = bar2_y_ddot * c11 + bar2_e0_ddot * w428 + bar2_e1_ddot * w421 + bar2_e2_ddot * w411 + bar2_e3_ddot * w334
    w636 = (w313 * w433 + w315 * w435 + w317 * w512 + w319 * w585 - w617 * w628 - w320 * w629) / w312
    w637 = w357 + w636
    w638 = c95 + (w61 * w72 - w67 * w634 - w70 * (w51 - w49)) - w635 + w637
    w639 = w1 * w45
    w640 = 1.0 - w69 - w71
    w641 = bar2_x_ddot * c11 + bar2_e0_ddot * w429 + bar2_e1_ddot * w422 + bar2_e2_ddot * w413 + bar2_e3_ddot * w336
    w642 = (w254 * w433 + w256 * w435 + w269 * w512 + w282 * w585 - w612 * w628 - w283 * w629 - w307 * w636) / w253
    w643 = w364 + w642
    w644 = w61 * w76 - w67 * w640 - w70 * (w63 + w64) - w641 + w643
    w645 = w394 + w168 * w642 + w287 * w636 + w134 * w629 - w595 * w628
    w646 = w401 + w170 * w642 + w288 * w636 + w138 * w629 - w596 * w628
    w647 = w406 + w163 * w642 + w285 * w636 + w127 * w629 - w597 * w628
    w648 = w409 + w171 * w642 + w289 * w636 + w142 * w629 - w598 * w628
    w649 = w344 + w133 * w630 + w286 * w637 + w166 * w643 + w135 * w645 + w140 * w646 - w130 * w647 - w143 * w648
    w650 = w44 + (w0 * w45 - w47) * w631 + (w1 * w46 - w633) * w638 + (w6 * w632 - w639) * w644 + w147 * w649
    w651 = w431 + w159 * w630 + w293 * w637 + w176 * w643 + w143 * w645 + w130 * w646 + w140 * w647 + w135 * w648
    w652 = w650 + w145 * w651
    w653 = w3 * w23
    w654 = w32 - w653
    w655 = w11 * w23 - w6 * w29
    w656 = w3 * w29
    w657 = w656 - w11 * w19
    w658 = bar1_x_ddot * w655 + bar1_y_ddot * w654 + bar1_z_ddot * w657 + bar1_e0_ddot * w36 + bar1_e1_ddot * (w3 * w35 + w1 * (w1 * c8) + w2 * (w2 * c9))
    w659 = bar1_e3 * bar1_e0 * c50 + w2 * w38
    w660 = w1 * w41 + bar1_e2 * bar1_e0 * c103
    w661 = w3 * w45
    w662 = w3 * w10 + w1 * w14 + w2 * w15 + w654 * c94 - (w658 + bar1_e2_ddot * w659 + bar1_e3_ddot * w660) + w631 * (w661 - w11 * w46)
    w663 = w3 * w632
    w664 = w419 + w152 * w630 + w290 * w637 + w173 * w643 - w140 * w645 + w135 * w646 + w143 * w647 - w130 * w648
    w665 = w426 + w156 * w630 + w292 * w637 + w175 * w643 + w130 * w645 - w143 * w646 + w135 * w647 - w140 * w648
    w666 = w662 + w638 * (w47 - w663) + w644 * (w11 * w632 - w6 * w45) - w147 * w664 + w145 * w665
    w667 = w7 * w19 - w1 * w23
    w668 = w653 - w7 * w29
    w669 = w3 * w19
    w670 = w30 - w669
    w671 = bar1_x_ddot * w668 + bar1_y_ddot * w667 + bar1_z_ddot * w670 + bar1_e0_ddot * w39 + bar1_e1_ddot * w659
    w672 = w11 * w40 + bar1_e1 * bar1_e0 * c104
    w673 = w10 * w11 + w3 * w14 + w0 * w15 + w667 * c94 - (w671 + bar1_e2_ddot * (w11 * (w11 * c6) + w3 * w37 + w0 * w38) + bar1_e3_ddot * w672)
    w674 = w3 * w46
    w675 = w673 + w631 * (w639 - w674) + w638 * (w7 * w46 - w1 * w632) + w644 * (w663 - w7 * w45) + w145 * w664
    w676 = w675 + w147 * w665
    w677 = w669 - w2 * w23
    w678 = w24 - w656
    w679 = w2 * w29 - w0 * w19
    w680 = bar1_x_ddot * w678 + bar1_y_ddot * w677 + bar1_z_ddot * w679 + bar1_e0_ddot * w43 + bar1_e1_ddot * w660
    w681 = w6 * w10 + w7 * w14 + w3 * w15 + w677 * c94 - (w680 + bar1_e2_ddot * w672 + bar1_e3_ddot * (w6 * w40 + w7 * w41 + w3 * w42))
    w682 = w681 + w631 * (w2 * w45 - w0 * w46) + w638 * (w674 - w2 * w632) + w644 * (w633 - w661) + w145 * w649
    w683 = w682 - w147 * w651
    w684 = w4 * c93
    w685 = w8 * c93
    w686 = w4 * w684 + w8 * w685
    w687 = w12 * w685
    w688 = w20 + w21
    w689 = w12 * w684
    w690 = bar1_x_ddot * c102 + w31 * bar1_e0_ddot + bar1_e1_ddot * w655 + bar1_e2_ddot * w668 + bar1_e3_ddot * w678
    w691 = w644 + (w18 * w686 - (w27 - w26) * w687 - w688 * w689 - w690)
    w692 = 1.0 - 2 * bar1_e1**2
    w693 = bar1_e3 * w2
    w694 = bar1_e1 * w3
    w695 = w693 - w694
    w696 = bar1_y_ddot * c102 + w25 * bar1_e0_ddot + bar1_e1_ddot * w654 + bar1_e2_ddot * w667 + bar1_e3_ddot * w677
    w697 = w638 + (c105 + (w28 * w686 - w687 * (w692 - w17) - w689 * w695) - w696)
    w698 = w692 - w16
    w699 = bar1_z_ddot * c102 + w33 * bar1_e0_ddot + bar1_e1_ddot * w657 + bar1_e2_ddot * w670 + bar1_e3_ddot * w679
    w700 = w631 + (w22 * w686 - w687 * (w693 + w694) - w689 * w698 - w699)
    w701 = w481 - w629
    w702 = w488 - w636
    w703 = w494 - w642
    w704 = w510 - w608 * w628 - w267 * w701 - w299 * w702 - w218 * w703
    w705 = w506 - w607 * w628 - w265 * w701 - w298 * w702 - w214 * w703
    w706 = w468 - w605 * w628 - w264 * w701 - w297 * w702 - w210 * w703
    w707 = w500 - w606 * w628 - w262 * w701 - w296 * w702 - w202 * w703
    w708 = w555 + w701
    w709 = w563 + w702
    w710 = w570 + w703
    w711 = w584 - w206 * w707 + w204 * w704 - w280 * w708 - w305 * w709 - w250 * w710
    w712 = w582 + w206 * w706 + w204 * w705 - w277 * w708 - w303 * w709 - w245 * w710
    w713 = w577 + w204 * w706 - w206 * w705 - w275 * w708 - w301 * w709 - w233 * w710
    w714 = w539 + w204 * w707 + w206 * w704 - w276 * w708 - w302 * w709 - w240 * w710
    w715 = bar1_e1 * 0.5
    w716 = bar1_e0 * 0.5
    w717 = bar1_e3 * 0.5
    w718 = bar1_e2 * 0.5
    w719 = bar2_e3 * 0.5
    w720 = bar2_e0 * 0.5
    w721 = bar2_e1 * 0.5
    w722 = w695 * w720 - w688 * w719 + w698 * w721
    w723 = bar2_e2 * 0.5
    w724 = w688 * w721 + w695 * w723 + w698 * w719
    w725 = w688 * w720 + w695 * w719 - w698 * w723
    w726 = w688 * w723 - w695 * w721 + w698 * w720
    w727 = w664 * (w719 + w688 * w722) - (w651 * (w688 * w724 - w721) + w665 * (w720 - w688 * w725)) - w649 * (w723 - w688 * w726)
    w728 = w649 * (w721 + w695 * w726) - (w651 * (w695 * w724 - w723) + w665 * (w719 - w695 * w725) + w664 * (w720 - w695 * w722))
    w729 = w665 * (w723 + w698 * w725) - w651 * (w698 * w724 - w719) - w664 * (w721 - w698 * w722) - w649 * (w720 - w698 * w726)
    w730 = bar3_e3 * 0.5
    w731 = bar3_e0 * 0.5
    w732 = bar3_e1 * 0.5
    w733 = w634 * w731 - w640 * w730 + w65 * w732
    w734 = bar3_e2 * 0.5
    w735 = w640 * w732 + w634 * w734 + w65 * w730
    w736 = w640 * w731 + w634 * w730 - w65 * w734
    w737 = w640 * w734 - w634 * w732 + w65 * w731
    w738 = w646 * (w730 + w640 * w733) - (w648 * (w640 * w735 - w732) + w647 * (w731 - w640 * w736)) - w645 * (w734 - w640 * w737)
    w739 = w645 * (w732 + w634 * w737) - (w648 * (w634 * w735 - w734) + w647 * (w730 - w634 * w736) + w646 * (w731 - w634 * w733))
    w740 = w647 * (w734 + w65 * w736) - w648 * (w65 * w735 - w730) - w646 * (w732 - w65 * w733) - w645 * (w731 - w65 * w737)
    w741 = bar4_e0 * 0.5
    w742 = bar4_e2 * 0.5
    w743 = bar4_e3 * 0.5
    w744 = w473 * w742 - (w489 * w741 + w482 * w743)
    w745 = bar4_e1 * 0.5
    w746 = w489 * w745 + w482 * w742 + w473 * w743
    w747 = w489 * w743 - w482 * w741 - w473 * w745
    w748 = w482 * w745 - w489 * w742 - w473 * w741
    w749 = w705 * (w741 + w489 * w744) - w704 * (w745 - w489 * w746) - w706 * (w743 - w489 * w747) + w707 * (w742 + w489 * w748)
    w750 = w705 * (w743 + w482 * w744) - w704 * (w742 - w482 * w746) + w706 * (w741 + w482 * w747) - w707 * (w745 - w482 * w748)
    w751 = w706 * (w745 + w473 * w747) - (w704 * (w743 - w473 * w746) + w705 * (w742 - w473 * w744)) + w707 * (w741 + w473 * w748)
    w752 = bar5_e0 * 0.5
    w753 = bar5_e2 * 0.5
    w754 = bar5_e3 * 0.5
    w755 = w545 * w753 - (w565 * w752 + w557 * w754)
    w756 = bar5_e1 * 0.5
    w757 = w565 * w756 + w557 * w753 + w545 * w754
    w758 = w565 * w754 - w557 * w752 - w545 * w756
    w759 = w557 * w756 - w565 * w753 - w545 * w752
    w760 = w712 * (w752 + w565 * w755) - w711 * (w756 - w565 * w757) - w713 * (w754 - w565 * w758) + w714 * (w753 + w565 * w759)
    w761 = w712 * (w754 + w557 * w755) - w711 * (w753 - w557 * w757) + w713 * (w752 + w557 * w758) - w714 * (w756 - w557 * w759)
    w762 = w713 * (w756 + w545 * w758) - (w711 * (w754 - w545 * w757) + w712 * (w753 - w545 * w755)) + w714 * (w752 + w545 * w759)
    lam = ca.vertcat(
        w652,
        w666,
        w676,
        w683,
        w691,
        w697,
        w700,
        w651,
        w665,
        w664,
        w649,
        w644,
        w638,
        w631,
        w648,
        w647,
        w646,
        w645,
        w643,
        w637,
        w630,
        w642,
        w636,
        w629,
        w628,
        lam_R0,
        w704,
        w705,
        w706,
        w707,
        -w703,
        -w702,
        -w701,
        w711,
        w712,
        w713,
        w714,
        -w710,
        -w709,
        -w708,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w691,
        -w697,
        -w700,
        w652 * w715 - w666 * w716 + w676 * w717 - w683 * w718,
        0.0,
        w652 * w717 + w666 * w718 - w676 * w715 - w683 * w716,
        -w644,
        -w638,
        -w631,
        w727,
        w728,
        w729,
        -w643,
        -w637,
        -w630,
        w738,
        w739,
        w740,
        -w642,
        -w636,
        -w629,
        -(w602 * w628 + lam_R0 * w465),
        -(w603 * w628 + lam_R0 * w466),
        -(w604 * w628 + lam_R0 * w467),
        w703,
        w702,
        w701,
        w749,
        w750,
        w751,
        w710,
        w709,
        w708,
        w760,
        w761,
        w762,
    )
    joint_forces = ca.reshape(joint_forces, 6, 6)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, lam_R, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "lam_R", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 1150 operations."""
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 154)
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
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c11 = c[11]
    c12 = c[12]
    c14 = c[14]
    c21 = c[21]
    c25 = c[25]
    c27 = c[27]
    c28 = c[28]
    c31 = c[31]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c50 = c[50]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c64 = c[64]
    c67 = c[67]
    c69 = c[69]
    c70 = c[70]
    c73 = c[73]
    c74 = c[74]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
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
    c102 = c[102]
    c103 = c[103]
    c104 = c[104]
    w0 = bar1_e2 * -2.0
    w1 = 2 * bar1_e1
    w2 = 2 * bar1_e0
    w3 = (w1 * bar1_e3 - bar1_e2 * w2) * c93
    w4 = bar1_e3 * -2.0
    w5 = (bar1_e3 * w2 + bar1_e2 * w1) * c93
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
    w16 = bar1_x_dot * (bar1_x_dot * c102 + w7 * bar1_e0_dot + w9 * bar1_e1_dot + w11 * bar1_e2_dot + w15 * bar1_e3_dot)
    w17 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c93
    w18 = w4 * w17 - w13
    w19 = w0 * w17
    w20 = w19 - w10
    w21 = w1 * w17 - w3 * w4
    w22 = w2 * w17
    w23 = 2 * bar1_e2
    w24 = w22 - w3 * w23
    w25 = bar1_y_dot * c102 + bar1_e0_dot * w18 + bar1_e1_dot * w20 + bar1_e2_dot * w21 + bar1_e3_dot * w24
    w26 = w5 * w12 - w19
    w27 = w14 - w8 * w17
    w28 = w6 - w22
    w29 = w5 * w23 - w12 * w17
    w30 = bar1_z_dot * c102 + bar1_e0_dot * w26 + bar1_e1_dot * w27 + bar1_e2_dot * w28 + bar1_e3_dot * w29
    w31 = bar1_x_dot * w7 + bar1_y_dot * w18 + bar1_z_dot * w26 + bar1_e0_dot * (w12 * (w12 * c6) + w0 * (w0 * c8) + w4 * (w4 * c9))
    w32 = w2 * c6
    w33 = w12 * w32 + bar1_e2 * bar1_e3 * c54
    w34 = w2 * c8
    w35 = w12 * c9
    w36 = w0 * w34 + bar1_e1 * bar1_e3 * c53
    w37 = w0 * c6
    w38 = w1 * c8
    w39 = w2 * c9
    w40 = bar1_e2 * bar1_e1 * c52 + w4 * w39
    w41 = w16 + bar1_y_dot * w25 + bar1_z_dot * w30 + bar1_e0_dot * (w31 + bar1_e1_dot * w33 + bar1_e2_dot * w36 + bar1_e3_dot * w40)
    w42 = bar1_x_dot * w9 + bar1_y_dot * w20 + bar1_z_dot * w27 + bar1_e0_dot * w33 + bar1_e1_dot * (w2 * w32 + w4 * (w4 * c8) + w23 * (w23 * c9))
    w43 = bar1_e3 * bar1_e0 * c50 + w23 * w35
    w44 = w4 * w38 + bar1_e2 * bar1_e0 * c103
    w45 = bar1_x_dot * w11 + bar1_y_dot * w21 + bar1_z_dot * w28 + bar1_e0_dot * w36 + bar1_e1_dot * w43 + bar1_e2_dot * (w8 * (w8 * c6) + w2 * w34 + w12 * w35)
    w46 = w8 * w37 + bar1_e1 * bar1_e0 * c104
    w47 = w41 + bar1_e1_dot * (w42 + bar1_e2_dot * w43 + bar1_e3_dot * w44) + bar1_e2_dot * (w45 + bar1_e3_dot * w46)
    w48 = bar1_x_dot * w15 + bar1_y_dot * w24 + bar1_z_dot * w29 + bar1_e0_dot * w40 + bar1_e1_dot * w44 + bar1_e2_dot * w46
    w49 = bar2_e2 * -2.0
    w50 = 2 * bar2_e0
    w51 = 2 * bar2_e2
    w52 = (w50 * bar2_e1 + w51 * bar2_e3) * c14
    w53 = bar2_e3 * -2.0
    w54 = (1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2) * c14
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
    w66 = bar2_x_dot * (bar2_x_dot * c11 + w56 * bar2_e0_dot + w58 * bar2_e1_dot + w61 * bar2_e2_dot + w65 * bar2_e3_dot)
    w67 = (bar2_e2 * w60 - w50 * bar2_e3) * c14
    w68 = w53 * w67 - w63
    w69 = w49 * w67
    w70 = w69 - w59
    w71 = w60 * w67 - w52 * w53
    w72 = w50 * w67
    w73 = w72 - w51 * w52
    w74 = bar2_y_dot * (bar2_y_dot * c11 + bar2_e0_dot * w68 + bar2_e1_dot * w70 + bar2_e2_dot * w71 + bar2_e3_dot * w73)
    w75 = w54 * w62 - w69
    w76 = w64 - w57 * w67
    w77 = w55 - w72
    w78 = w51 * w54 - w62 * w67
    w79 = bar2_z_dot * (bar2_z_dot * c11 + bar2_e0_dot * w75 + bar2_e1_dot * w76 + bar2_e2_dot * w77 + bar2_e3_dot * w78)
    w80 = bar2_x_dot * w56 + bar2_y_dot * w68 + bar2_z_dot * w75 + bar2_e0_dot * (w62 * (w62 * c25) + w49 * (w49 * c27) + w53 * (w53 * c28))
    w81 = w50 * c25
    w82 = w62 * w81 + bar2_e2 * bar2_e3 * c47
    w83 = w50 * c27
    w84 = w62 * c28
    w85 = w49 * w83 + bar2_e1 * bar2_e3 * c46
    w86 = w49 * c25
    w87 = w60 * c27
    w88 = w50 * c28
    w89 = bar2_e2 * bar2_e1 * c41 + w53 * w88
    w90 = w47 + bar1_e3_dot * (w48 + bar1_e3_dot * (w0 * w37 + w1 * w38 + w2 * w39)) + w66 + w74 + w79 + bar2_e0_dot * (w80 + bar2_e1_dot * w82 + bar2_e2_dot * w85 + bar2_e3_dot * w89)
    w91 = bar2_x_dot * w58 + bar2_y_dot * w70 + bar2_z_dot * w76 + bar2_e0_dot * w82 + bar2_e1_dot * (w50 * w81 + w53 * (w53 * c27) + w51 * (w51 * c28))
    w92 = bar2_e0 * bar2_e3 * c48 + w51 * w84
    w93 = w53 * w87 + bar2_e2 * bar2_e0 * c45
    w94 = bar2_x_dot * w61 + bar2_y_dot * w71 + bar2_z_dot * w77 + bar2_e0_dot * w85 + bar2_e1_dot * w92 + bar2_e2_dot * (w57 * (w57 * c25) + w50 * w83 + w62 * w84)
    w95 = w57 * w86 + bar2_e0 * bar2_e1 * c44
    w96 = w90 + bar2_e1_dot * (w91 + bar2_e2_dot * w92 + bar2_e3_dot * w93) + bar2_e2_dot * (w94 + bar2_e3_dot * w95)
    w97 = bar2_x_dot * w65 + bar2_y_dot * w73 + bar2_z_dot * w78 + bar2_e0_dot * w89 + bar2_e1_dot * w93 + bar2_e2_dot * w95
    w98 = bar3_e2 * -2.0
    w99 = (1.0 - 2 * bar3_e1**2 - 2 * bar3_e2**2) * c21
    w100 = bar3_e3 * -2.0
    w101 = 2 * bar3_e2
    w102 = 2 * bar3_e0
    w103 = (bar3_e3 * w101 - bar3_e1 * w102) * c21
    w104 = w100 * w103
    w105 = w98 * w99 - w104
    w106 = 2 * bar3_e3
    w107 = w99 * w106 - w98 * w103
    w108 = w99 * w102
    w109 = 2 * bar3_e1
    w110 = w108 - w103 * w109
    w111 = bar3_e1 * -2.0
    w112 = w99 * w111
    w113 = w102 * w103
    w114 = w112 - w113
    w115 = bar3_x_dot * c12 + w105 * bar3_e0_dot + w107 * bar3_e1_dot + w110 * bar3_e2_dot + w114 * bar3_e3_dot
    w116 = w96 + bar2_e3_dot * (w97 + bar2_e3_dot * (w49 * w86 + w60 * w87 + w50 * w88)) + bar3_x_dot * w115
    w117 = (bar3_e2 * w102 + bar3_e3 * w109) * c21
    w118 = w100 * w117 - w112
    w119 = w98 * w117
    w120 = w119 - w108
    w121 = w109 * w117 - w99 * w100
    w122 = w102 * w117
    w123 = w122 - w99 * w101
    w124 = bar3_y_dot * c12 + bar3_e0_dot * w118 + bar3_e1_dot * w120 + bar3_e2_dot * w121 + bar3_e3_dot * w123
    w125 = w103 * w111 - w119
    w126 = w113 - w106 * w117
    w127 = w104 - w122
    w128 = w101 * w103 - w111 * w117
    w129 = bar3_z_dot * c12 + bar3_e0_dot * w125 + bar3_e1_dot * w126 + bar3_e2_dot * w127 + bar3_e3_dot * w128
    w130 = bar3_x_dot * w105 + bar3_y_dot * w118 + bar3_z_dot * w125 + bar3_e0_dot * (w111 * (w111 * c31) + w98 * (w98 * c33) + w100 * (w100 * c34))
    w131 = w102 * c31
    w132 = w111 * w131 + bar3_e2 * bar3_e3 * c40
    w133 = w102 * c33
    w134 = w111 * c34
    w135 = w98 * w133 + bar3_e1 * bar3_e3 * c39
    w136 = w98 * c31
    w137 = w109 * c33
    w138 = w102 * c34
    w139 = bar3_e2 * bar3_e1 * c38 + w100 * w138
    w140 = w116 + bar3_y_dot * w124 + bar3_z_dot * w129 + bar3_e0_dot * (w130 + bar3_e1_dot * w132 + bar3_e2_dot * w135 + bar3_e3_dot * w139)
    w141 = bar3_x_dot * w107 + bar3_y_dot * w120 + bar3_z_dot * w126 + bar3_e0_dot * w132 + bar3_e1_dot * (w102 * w131 + w100 * (w100 * c33) + w101 * (w101 * c34))
    w142 = bar3_e3 * bar3_e0 * c37 + w101 * w134
    w143 = w100 * w137 + bar3_e2 * bar3_e0 * c36
    w144 = bar3_x_dot * w110 + bar3_y_dot * w121 + bar3_z_dot * w127 + bar3_e0_dot * w135 + bar3_e1_dot * w142
    w145 = w106 * w136 + bar3_e1 * bar3_e0 * c35
    w146 = bar3_e2_dot * (w144 + bar3_e2_dot * (w106 * (w106 * c31) + w102 * w133 + w111 * w134) + bar3_e3_dot * w145)
    w147 = bar3_x_dot * w114 + bar3_y_dot * w123 + bar3_z_dot * w128 + bar3_e0_dot * w139 + bar3_e1_dot * w143
    w148 = bar3_e3_dot * (w147 + bar3_e2_dot * w145 + bar3_e3_dot * (w98 * w136 + w109 * w137 + w102 * w138))
    w149 = bar4_e2 * -2.0
    w150 = 2 * bar4_e1
    w151 = 2 * bar4_e0
    w152 = (w150 * bar4_e3 - bar4_e2 * w151) * c78
    w153 = bar4_e3 * -2.0
    w154 = (bar4_e3 * w151 + bar4_e2 * w150) * c78
    w155 = w153 * w154
    w156 = w149 * w152 - w155
    w157 = 2 * bar4_e3
    w158 = w152 * w157 - w149 * w154
    w159 = w151 * w152
    w160 = w159 - w150 * w154
    w161 = bar4_e1 * -2.0
    w162 = w152 * w161
    w163 = w151 * w154
    w164 = w162 - w163
    w165 = bar4_x_dot * c74 + w156 * bar4_e0_dot + w158 * bar4_e1_dot + w160 * bar4_e2_dot + w164 * bar4_e3_dot
    w166 = w140 + bar3_e1_dot * (w141 + bar3_e2_dot * w142 + bar3_e3_dot * w143) + w146 + w148 + bar4_x_dot * w165
    w167 = (1.0 - 2 * bar4_e2**2 - 2 * bar4_e3**2) * c78
    w168 = w153 * w167 - w162
    w169 = w149 * w167
    w170 = w169 - w159
    w171 = w150 * w167 - w152 * w153
    w172 = w151 * w167
    w173 = 2 * bar4_e2
    w174 = w172 - w152 * w173
    w175 = bar4_y_dot * c74 + bar4_e0_dot * w168 + bar4_e1_dot * w170 + bar4_e2_dot * w171 + bar4_e3_dot * w174
    w176 = w154 * w161 - w169
    w177 = w163 - w157 * w167
    w178 = w155 - w172
    w179 = w154 * w173 - w161 * w167
    w180 = bar4_z_dot * c74 + bar4_e0_dot * w176 + bar4_e1_dot * w177 + bar4_e2_dot * w178 + bar4_e3_dot * w179
    w181 = bar4_x_dot * w156 + bar4_y_dot * w168 + bar4_z_dot * w176 + bar4_e0_dot * (w161 * (w161 * c73) + w149 * (w149 * c76) + w153 * (w153 * c77))
    w182 = w151 * c73
    w183 = w161 * w182 + bar4_e2 * bar4_e3 * c86
    w184 = w151 * c76
    w185 = w161 * c77
    w186 = w149 * w184 + bar4_e1 * bar4_e3 * c85
    w187 = w149 * c73
    w188 = w150 * c76
    w189 = w151 * c77
    w190 = bar4_e2 * bar4_e1 * c79 + w153 * w189
    w191 = w166 + bar4_y_dot * w175 + bar4_z_dot * w180 + bar4_e0_dot * (w181 + bar4_e1_dot * w183 + bar4_e2_dot * w186 + bar4_e3_dot * w190)
    w192 = bar4_x_dot * w158 + bar4_y_dot * w170 + bar4_z_dot * w177 + bar4_e0_dot * w183 + bar4_e1_dot * (w151 * w182 + w153 * (w153 * c76) + w173 * (w173 * c77))
    w193 = bar4_e3 * bar4_e0 * c87 + w173 * w185
    w194 = w153 * w188 + bar4_e2 * bar4_e0 * c84
    w195 = bar4_x_dot * w160 + bar4_y_dot * w171 + bar4_z_dot * w178 + bar4_e0_dot * w186 + bar4_e1_dot * w193
    w196 = w157 * w187 + bar4_e1 * bar4_e0 * c83
    w197 = bar4_e2_dot * (w195 + bar4_e2_dot * (w157 * (w157 * c73) + w151 * w184 + w161 * w185) + bar4_e3_dot * w196)
    w198 = bar4_x_dot * w164 + bar4_y_dot * w174 + bar4_z_dot * w179 + bar4_e0_dot * w190 + bar4_e1_dot * w194
    w199 = bar4_e3_dot * (w198 + bar4_e2_dot * w196 + bar4_e3_dot * (w149 * w187 + w150 * w188 + w151 * w189))
    w200 = bar5_e2 * -2.0
    w201 = 2 * bar5_e0
    w202 = 2 * bar5_e2
    w203 = (w201 * bar5_e1 + w202 * bar5_e3) * c80
    w204 = bar5_e3 * -2.0
    w205 = (1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2) * c80
    w206 = w204 * w205
    w207 = w200 * w203 - w206
    w208 = 2 * bar5_e3
    w209 = w203 * w208 - w200 * w205
    w210 = w201 * w203
    w211 = 2 * bar5_e1
    w212 = w210 - w205 * w211
    w213 = bar5_e1 * -2.0
    w214 = w203 * w213
    w215 = w201 * w205
    w216 = w214 - w215
    w217 = bar5_x_dot * c64 + w207 * bar5_e0_dot + w209 * bar5_e1_dot + w212 * bar5_e2_dot + w216 * bar5_e3_dot
    w218 = w191 + bar4_e1_dot * (w192 + bar4_e2_dot * w193 + bar4_e3_dot * w194) + w197 + w199 + bar5_x_dot * w217
    w219 = (bar5_e2 * w211 - w201 * bar5_e3) * c80
    w220 = w204 * w219 - w214
    w221 = w200 * w219
    w222 = w221 - w210
    w223 = w211 * w219 - w203 * w204
    w224 = w201 * w219
    w225 = w224 - w202 * w203
    w226 = bar5_y_dot * c64 + bar5_e0_dot * w220 + bar5_e1_dot * w222 + bar5_e2_dot * w223 + bar5_e3_dot * w225
    w227 = w205 * w213 - w221
    w228 = w215 - w208 * w219
    w229 = w206 - w224
    w230 = w202 * w205 - w213 * w219
    w231 = bar5_z_dot * c64 + bar5_e0_dot * w227 + bar5_e1_dot * w228 + bar5_e2_dot * w229 + bar5_e3_dot * w230
    w232 = bar5_x_dot * w207 + bar5_y_dot * w220 + bar5_z_dot * w227 + bar5_e0_dot * (w213 * (w213 * c67) + w200 * (w200 * c69) + w204 * (w204 * c70))
    w233 = w201 * c67
    w234 = w213 * w233 + bar5_e2 * bar5_e3 * c92
    w235 = w201 * c69
    w236 = w213 * c70
    w237 = w200 * w235 + bar5_e1 * bar5_e3 * c91
    w238 = w200 * c67
    w239 = w211 * c69
    w240 = w201 * c70
    w241 = bar5_e2 * bar5_e1 * c90 + w204 * w240
    w242 = w218 + bar5_y_dot * w226 + bar5_z_dot * w231 + bar5_e0_dot * (w232 + bar5_e1_dot * w234 + bar5_e2_dot * w237 + bar5_e3_dot * w241)
    w243 = bar5_x_dot * w209 + bar5_y_dot * w222 + bar5_z_dot * w228 + bar5_e0_dot * w234 + bar5_e1_dot * (w201 * w233 + w204 * (w204 * c69) + w202 * (w202 * c70))
    w244 = bar5_e0 * bar5_e3 * c89 + w202 * w236
    w245 = w204 * w239 + bar5_e2 * bar5_e0 * c88
    w246 = bar5_x_dot * w212 + bar5_y_dot * w223 + bar5_z_dot * w229 + bar5_e0_dot * w237 + bar5_e1_dot * w244
    w247 = w208 * w238 + bar5_e0 * bar5_e1 * c82
    w248 = bar5_e2_dot * (w246 + bar5_e2_dot * (w208 * (w208 * c67) + w201 * w235 + w213 * w236) + bar5_e3_dot * w247)
    w249 = bar5_x_dot * w216 + bar5_y_dot * w225 + bar5_z_dot * w230 + bar5_e0_dot * w241 + bar5_e1_dot * w245
    w250 = bar5_e3_dot * (w249 + bar5_e2_dot * w247 + bar5_e3_dot * (w200 * w238 + w211 * w239 + w201 * w240))
    w251 = (w5 + bar1_y * c102) * c94 + (w54 + bar2_y * c11) * c94 + (w103 + bar3_y * c12) * c94 + (w154 + bar4_y * c74) * c94
    kinetic = ca.vertcat(
        (w242 + bar5_e1_dot * (w243 + bar5_e2_dot * w244 + bar5_e3_dot * w245) + w248 + w250) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(w251 + (w205 + bar5_y * c64) * c94),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates. 71 operations."""
    q = ca.SX.sym("q", 40)
    q_dot = ca.SX.sym("q_dot", 40)
    c = ca.SX.sym("c", 154)
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
    c63 = c[63]
    w0 = 2 * bar3_e0
    w1 = 2 * bar3_e1
    w2 = 2 * bar3_e0_dot
    w3 = bar3_x_dot + (bar3_e2 * w2 + w0 * bar3_e2_dot + (bar3_e3 * (2 * bar3_e1_dot) + w1 * bar3_e3_dot)) * c63
    w4 = 2 * bar3_e2
    w5 = bar3_y_dot + (bar3_e3 * (2 * bar3_e2_dot) + bar3_e3_dot * w4 - (bar3_e1 * w2 + w0 * bar3_e1_dot)) * c63
    measures = ca.vertcat(
        bar3_x + (w0 * bar3_e2 + w1 * bar3_e3) * c63,
        w3,
        bar3_y + (bar3_e3 * w4 - w0 * bar3_e1) * c63,
        w5,
        bar3_z + (1.0 - 2 * bar3_e1**2 - 2 * bar3_e2**2) * c63,
        bar3_z_dot - (2 * (w1 * bar3_e1_dot) + 2 * (bar3_e2_dot * w4)) * c63,
    )
    measures = ca.densify(measures)
    inputs, outputs = [q, q_dot, c], [measures]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 226 operations."""
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
    poses = ca.vertcat(
        bar1_x,
        bar1_y,
        bar1_z,
        1.0 - w0 - w1,
        w3 + w5,
        w6 - w7,
        w5 - w3,
        w8 - w1,
        w9 + w10,
        w6 + w7,
        w10 - w9,
        w8 - w0,
        bar2_x,
        bar2_y,
        bar2_z,
        1.0 - w11 - w12,
        w14 + w16,
        w17 - w18,
        w16 - w14,
        w19 - w12,
        w20 + w21,
        w17 + w18,
        w21 - w20,
        w19 - w11,
        bar3_x,
        bar3_y,
        bar3_z,
        1.0 - w22 - w23,
        w25 + w27,
        w28 - w29,
        w27 - w25,
        w30 - w23,
        w31 + w32,
        w28 + w29,
        w32 - w31,
        w30 - w22,
        bar4_x,
        bar4_y,
        bar4_z,
        1.0 - w33 - w34,
        w36 + w38,
        w39 - w40,
        w38 - w36,
        w41 - w34,
        w42 + w43,
        w39 + w40,
        w43 - w42,
        w41 - w33,
        bar5_x,
        bar5_y,
        bar5_z,
        1.0 - w44 - w45,
        w47 + w49,
        w50 - w51,
        w49 - w47,
        w52 - w45,
        w53 + w54,
        w50 + w51,
        w54 - w53,
        w52 - w44,
    )
    poses = ca.reshape(poses, 12, 5)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 24707 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 39)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    bar3_e0_dot = q_d_dot[17]
    bar3_e1_dot = q_d_dot[18]
    bar3_e2_dot = q_d_dot[19]
    bar3_e3_dot = q_d_dot[20]
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
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
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c50 = c[50]
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
    c103 = c[103]
    c104 = c[104]
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
    c119 = c[119]
    c120 = c[120]
    c121 = c[121]
    c122 = c[122]
    c123 = c[123]
    c124 = c[124]
    c125 = c[125]
    c126 = c[126]
    c127 = c[127]
    c128 = c[128]
    c129 = c[129]
    c130 = c[130]
    c131 = c[131]
    c132 = c[132]
    c133 = c[133]
    c134 = c[134]
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = w2 * c1 * c0 - w2 * c2 * c3
    w4 = hinge1_angle / 2.0
    w5 = ca.cos(w4)
    w6 = hinge2_angle / 2.0
    w7 = ca.cos(w6)
    w8 = w7 * c16 * c19 - w7 * c18 * c17
    w9 = 2 * bar3_e3
    w10 = 1.0 - 2 * bar3_e1**2
    w11 = 2 * bar3_e2**2
    w12 = w10 - w11
    w13 = w12 * c21
    w14 = bar3_e2 * -2.0
    w15 = 2 * bar3_e2
    w16 = bar3_e3 * w15
    w17 = 2 * bar3_e0
    w18 = bar3_e1 * w17
    w19 = w16 - w18
    w20 = w19 * c21
    w21 = w9 * w13 - w14 * w20
    w22 = bar1_e2 * -2.0
    w23 = 2 * bar1_e1
    w24 = 2 * bar1_e0
    w25 = w23 * bar1_e3 - bar1_e2 * w24
    w26 = w25 * c10
    w27 = bar1_e3 * -2.0
    w28 = (bar1_e3 * w24 + bar1_e2 * w23) * c10
    w29 = w27 * w28
    w30 = w22 * w26 - w29
    w31 = hinge0_angle_dot / 2.0
    w32 = w31**2
    w33 = ca.sin(w0)
    w34 = w32 * (w33 * 0.5)
    w35 = w32 * w33
    w36 = w35 * c108
    w37 = 2 * bar1_e3
    w38 = w26 * w37 - w22 * w28
    w39 = w34 * c2 * c0 - w34 * c1 * c3
    w40 = w24 * w26
    w41 = w40 - w23 * w28
    w42 = w32 * (w1 * 0.5)
    w43 = w31 * (w1 * w31)
    w44 = w43 * c109
    w45 = bar1_e1 * -2.0
    w46 = w26 * w45
    w47 = w24 * w28
    w48 = w46 - w47
    w49 = w42 * c2 * c3 - w42 * c1 * c0
    w50 = w30 * w36 + w38 * w39 + w41 * w44 + w48 * w49
    w51 = bar2_e2 * -2.0
    w52 = 2 * bar2_e0
    w53 = w52 * bar2_e1
    w54 = 2 * bar2_e2
    w55 = w54 * bar2_e3
    w56 = w53 + w55
    w57 = w56 * c15
    w58 = bar2_e3 * -2.0
    w59 = 1.0 - 2 * bar2_e1**2
    w60 = 2 * bar2_e3**2
    w61 = w59 - w60
    w62 = w61 * c15
    w63 = w58 * w62
    w64 = w51 * w57 - w63
    w65 = ca.sin(w4)
    w66 = w65 / 2.0
    w67 = w5 / 2.0
    w68 = bar1_e0 * w66 + bar1_e3 * w67
    w69 = 2 * bar4_e3
    w70 = 2 * bar4_e1
    w71 = bar4_e3 * w70
    w72 = 2 * bar4_e0
    w73 = w72 * bar4_e2
    w74 = w71 - w73
    w75 = w74 * c55
    w76 = bar4_e2 * -2.0
    w77 = bar4_e3 * w72
    w78 = w70 * bar4_e2
    w79 = w77 + w78
    w80 = w79 * c55
    w81 = w69 * w75 - w76 * w80
    w82 = hinge4_angle / 2.0
    w83 = ca.sin(w82)
    w84 = w72 * w75
    w85 = w84 - w70 * w80
    w86 = ca.cos(w82)
    w87 = 2 * bar5_e0
    w88 = w87 * bar5_e1
    w89 = 2 * bar5_e2
    w90 = w89 * bar5_e3
    w91 = w88 + w90
    w92 = w91 * c56
    w93 = w87 * w92
    w94 = 2 * bar5_e1
    w95 = 1.0 - 2 * bar5_e1**2
    w96 = 2 * bar5_e3**2
    w97 = w95 - w96
    w98 = w97 * c56
    w99 = w93 - w94 * w98
    w100 = w81 * w83 - w85 * w86 - w99
    w101 = hinge5_angle / 2.0
    w102 = ca.sin(w101)
    w103 = w102 / 2.0
    w104 = w103 * c57 * c58 - w103 * c59 * c60
    w105 = bar4_e1 * -2.0
    w106 = w75 * w105
    w107 = w72 * w80
    w108 = w106 - w107
    w109 = bar4_e3 * -2.0
    w110 = w80 * w109
    w111 = w75 * w76 - w110
    w112 = bar5_e1 * -2.0
    w113 = w92 * w112
    w114 = w87 * w98
    w115 = w113 - w114
    w116 = w86 * w108 + w83 * w111 + w115
    w117 = ca.cos(w101)
    w118 = w117 / 2.0
    w119 = w118 * c59 * c58 - w118 * c57 * c60
    w120 = 2 * bar5_e3
    w121 = bar5_e2 * -2.0
    w122 = w92 * w120 - w98 * w121
    w123 = w83 * w85 + w81 * w86 + w122
    w124 = w118 * c61
    w125 = bar5_e3 * -2.0
    w126 = w98 * w125
    w127 = w92 * w121 - w126
    w128 = w83 * w108 - w86 * w111 - w127
    w129 = w103 * c62
    w130 = w100 * w104 - w116 * w119 + w123 * w124 - w128 * w129
    w131 = w12 * c63
    w132 = w19 * c63
    w133 = w9 * w131 - w14 * w132
    w134 = bar2_e1 * -2.0
    w135 = w57 * w134
    w136 = w52 * w62
    w137 = w135 - w136
    w138 = bar3_e1 * -2.0
    w139 = w131 * w138
    w140 = w17 * w132
    w141 = w139 - w140
    w142 = w7 * c20
    w143 = w17 * w131
    w144 = 2 * bar3_e1
    w145 = w143 - w132 * w144
    w146 = ca.sin(w6)
    w147 = w146 * c22
    w148 = bar3_e3 * -2.0
    w149 = w132 * w148
    w150 = w14 * w131 - w149
    w151 = w146 * c18 * c19 - w146 * c16 * c17
    w152 = w8 * w133 - (w137 + w141 * w142 + w145 * w147) + w150 * w151
    w153 = bar1_e0 * w67 - bar1_e3 * w66
    w154 = w52 * w57
    w155 = 2 * bar2_e1
    w156 = w154 - w62 * w155
    w157 = w141 * w147 - w156 - w142 * w145 - w133 * w151 + w8 * w150
    w158 = bar1_e2 * w66 + bar1_e1 * w67
    w159 = 2 * bar2_e3
    w160 = w57 * w159 - w51 * w62
    w161 = w145 * w151 - (w160 + w8 * w141) - w133 * w142 + w147 * w150
    w162 = bar1_e2 * w67 - bar1_e1 * w66
    w163 = w64 + w141 * w151 + w8 * w145 + w133 * w147 + w142 * w150
    w164 = w152 * w153 - w157 * w158 + w161 * w162 + w68 * w163
    w165 = bar3_e2 * w17
    w166 = bar3_e3 * w144
    w167 = w165 + w166
    w168 = w167 * c63
    w169 = w14 * w168
    w170 = w169 - w143
    w171 = bar2_e2 * w155
    w172 = w52 * bar2_e3
    w173 = w171 - w172
    w174 = w173 * c15
    w175 = w52 * w174
    w176 = w175 - w54 * w57
    w177 = w17 * w168
    w178 = w177 - w15 * w131
    w179 = w144 * w168 - w131 * w148
    w180 = w148 * w168 - w139
    w181 = w8 * w170 - (w176 + w142 * w178 + w147 * w179) + w151 * w180
    w182 = w155 * w174 - w57 * w58
    w183 = w147 * w178 - w182 - w142 * w179 - w151 * w170 + w8 * w180
    w184 = w51 * w174
    w185 = w184 - w154
    w186 = w151 * w179 - (w185 + w8 * w178) - w142 * w170 + w147 * w180
    w187 = w58 * w174 - w135
    w188 = w187 + w151 * w178 + w8 * w179 + w147 * w170 + w142 * w180
    w189 = w153 * w181 - w158 * w183 + w162 * w186 + w68 * w188
    w190 = w140 - w9 * w168
    w191 = w54 * w62 - w134 * w174
    w192 = w15 * w132 - w138 * w168
    w193 = w149 - w177
    w194 = w132 * w138 - w169
    w195 = w8 * w190 - (w191 + w142 * w192 + w147 * w193) + w151 * w194
    w196 = w63 - w175
    w197 = w147 * w192 - w196 - w142 * w193 - w151 * w190 + w8 * w194
    w198 = w136 - w159 * w174
    w199 = w151 * w193 - (w198 + w8 * w192) - w142 * w190 + w147 * w194
    w200 = w62 * w134 - w184
    w201 = w200 + w151 * w192 + w8 * w193 + w147 * w190 + w142 * w194
    w202 = w153 * w195 - w158 * w197 + w162 * w199 + w68 * w201
    w203 = bar3_e3 * w17
    w204 = bar3_e2 * w144
    w205 = w203 + w204
    w206 = bar4_e1 * w72
    w207 = 2 * bar4_e2
    w208 = bar4_e3 * w207
    w209 = w206 + w208
    w210 = w205 * w209
    w211 = w166 - w165
    w212 = 1.0 - 2 * bar4_e1**2
    w213 = 2 * bar4_e3**2
    w214 = w212 - w213
    w215 = w211 * w214
    w216 = w210 - w215
    w217 = w78 - w77
    w218 = w211 * w217
    w219 = 2 * bar3_e3**2
    w220 = 1.0 - w11 - w219
    w221 = w209 * w220
    w222 = w218 - w221
    w223 = w214 * w220
    w224 = w205 * w217
    w225 = w223 - w224
    w226 = w15 * w216 + w138 * w222 + w17 * w225
    w227 = w148 * w216 + w17 * w222 + w144 * w225
    w228 = w17 * w216 + w9 * w222 + w14 * w225
    w229 = w138 * w216 + w14 * w222 + w148 * w225
    w230 = w142 * w226 + w147 * w227 - w8 * w228 - w151 * w229
    w231 = w142 * w227 - w147 * w226 + w151 * w228 - w8 * w229
    w232 = w8 * w226 - w151 * w227 + w142 * w228 - w147 * w229
    w233 = w151 * w226 + w8 * w227 + w147 * w228 + w142 * w229
    w234 = w153 * w230 - w158 * w231 + w162 * w232 - w68 * w233
    w235 = ca.sqrt(w164**2 + w189**2 + w202**2 + w234**2)
    w236 = w164 / w235
    w237 = 2 * bar4_e2**2
    w238 = 1.0 - w237 - w213
    w239 = w238 * c55
    w240 = w76 * w239
    w241 = w240 - w84
    w242 = w70 * w239 - w75 * w109
    w243 = bar5_e2 * w94
    w244 = w87 * bar5_e3
    w245 = w243 - w244
    w246 = w245 * c56
    w247 = w94 * w246 - w92 * w125
    w248 = w83 * w241 - w86 * w242 - w247
    w249 = w72 * w239
    w250 = w249 - w75 * w207
    w251 = w109 * w239 - w106
    w252 = w87 * w246
    w253 = w252 - w89 * w92
    w254 = w86 * w250 + w83 * w251 + w253
    w255 = w121 * w246
    w256 = w255 - w93
    w257 = w83 * w242 + w86 * w241 + w256
    w258 = w125 * w246 - w113
    w259 = w83 * w250 - w86 * w251 - w258
    w260 = w104 * w248 - w119 * w254 + w124 * w257 - w129 * w259
    w261 = w189 / w235
    w262 = w107 - w69 * w239
    w263 = w110 - w249
    w264 = w126 - w252
    w265 = w83 * w262 - w86 * w263 - w264
    w266 = w80 * w207 - w105 * w239
    w267 = w80 * w105 - w240
    w268 = w89 * w98 - w112 * w246
    w269 = w86 * w266 + w83 * w267 + w268
    w270 = w114 - w120 * w246
    w271 = w83 * w263 + w86 * w262 + w270
    w272 = w98 * w112 - w255
    w273 = w83 * w266 - w86 * w267 - w272
    w274 = w104 * w265 - w119 * w269 + w124 * w271 - w129 * w273
    w275 = w202 / w235
    w276 = w215 - w210
    w277 = w221 - w218
    w278 = w224 - w223
    w279 = w207 * w276 + w105 * w277 + w72 * w278
    w280 = w105 * w276 + w76 * w277 + w109 * w278
    w281 = w86 * w279 + w83 * w280
    w282 = w109 * w276 + w72 * w277 + w70 * w278
    w283 = w72 * w276 + w69 * w277 + w76 * w278
    w284 = w86 * w282 - w83 * w283
    w285 = w83 * w282 + w86 * w283
    w286 = w86 * w280 - w83 * w279
    w287 = w119 * w281 + w104 * w284 - w124 * w285 - w129 * w286
    w288 = w234 / w235
    w289 = w130 * w236 + w260 * w261 + w274 * w275 + w287 * w288
    w290 = w130 - w236 * w289
    w291 = w146 / 2.0
    w292 = w291 * c20
    w293 = w7 / 2.0
    w294 = w293 * c22
    w295 = w291 * c18 * c17 - w291 * c16 * c19
    w296 = w293 * c18 * c19 - w293 * c16 * c17
    w297 = bar2_e0 * w292 + (bar2_e1 * w294 + bar2_e2 * w295 + bar2_e3 * w296)
    w298 = bar2_e0 * w296 - bar2_e3 * w292 + (bar2_e1 * w295 - bar2_e2 * w294)
    w299 = bar2_e0 * w295 - bar2_e2 * w292 + (bar2_e3 * w294 - bar2_e1 * w296)
    w300 = bar2_e0 * w294 - bar2_e1 * w292 + (bar2_e2 * w296 - bar2_e3 * w295)
    w301 = w150 * w297 - (w141 * w298 + w145 * w299 + w133 * w300)
    w302 = w180 * w297 - (w178 * w298 + w179 * w299 + w170 * w300)
    w303 = w194 * w297 - (w192 * w298 + w193 * w299 + w190 * w300)
    w304 = w226 * w298 + w227 * w299 + w228 * w300 - w229 * w297
    w305 = w236 * w301 + w261 * w302 + w275 * w303 + w288 * w304
    w306 = w301 - w236 * w305
    w307 = w302 - w261 * w305
    w308 = w303 - w275 * w305
    w309 = w304 - w288 * w305
    w310 = ca.sqrt(w306**2 + w307**2 + w308**2 + w309**2)
    w311 = w306 / w310
    w312 = w260 - w261 * w289
    w313 = w307 / w310
    w314 = w274 - w275 * w289
    w315 = w308 / w310
    w316 = w287 - w288 * w289
    w317 = w309 / w310
    w318 = w290 * w311 + w312 * w313 + w314 * w315 + w316 * w317
    w319 = w290 - w311 * w318
    w320 = w86 / 2.0
    w321 = w83 / 2.0
    w322 = bar5_e0 * w320 + bar5_e3 * w321
    w323 = bar5_e1 * w320 - bar5_e2 * w321
    w324 = bar5_e1 * w321 + bar5_e2 * w320
    w325 = bar5_e3 * w320 - bar5_e0 * w321
    w326 = w108 * w322 - w85 * w323 + w81 * w324 - w111 * w325
    w327 = w250 * w322 - w242 * w323 + w241 * w324 - w251 * w325
    w328 = w266 * w322 - w263 * w323 + w262 * w324 - w267 * w325
    w329 = w282 * w323 - w279 * w322 - w283 * w324 + w280 * w325
    w330 = w236 * w326 + w261 * w327 + w275 * w328 + w288 * w329
    w331 = w326 - w236 * w330
    w332 = w327 - w261 * w330
    w333 = w328 - w275 * w330
    w334 = w329 - w288 * w330
    w335 = w311 * w331 + w313 * w332 + w315 * w333 + w317 * w334
    w336 = w331 - w311 * w335
    w337 = w332 - w313 * w335
    w338 = w333 - w315 * w335
    w339 = w334 - w317 * w335
    w340 = ca.sqrt(w336**2 + w337**2 + w338**2 + w339**2)
    w341 = w336 / w340
    w342 = w312 - w313 * w318
    w343 = w337 / w340
    w344 = w314 - w315 * w318
    w345 = w338 / w340
    w346 = w316 - w317 * w318
    w347 = w339 / w340
    w348 = w319 * w341 + w342 * w343 + w344 * w345 + w346 * w347
    w349 = w319 - w341 * w348
    w350 = w342 - w343 * w348
    w351 = w344 - w345 * w348
    w352 = w346 - w347 * w348
    w353 = ca.sqrt(w349**2 + w350**2 + w351**2 + w352**2)
    w354 = w349 / w353
    w355 = w5 * w152 - w48 + w65 * w163
    w356 = w5 * w157 - w41 + w65 * w161
    w357 = w5 * w161 - (w38 + w65 * w157)
    w358 = w65 * w152 - w30 - w5 * w163
    w359 = w49 * w355 + w44 * w356 + w39 * w357 + w36 * w358
    w360 = w350 / w353
    w361 = 1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2
    w362 = w361 * c10
    w363 = w24 * w362
    w364 = 2 * bar1_e2
    w365 = w363 - w26 * w364
    w366 = w5 * w181 - w365 + w65 * w188
    w367 = w23 * w362 - w26 * w27
    w368 = w5 * w183 - w367 + w65 * w186
    w369 = w22 * w362
    w370 = w369 - w40
    w371 = w5 * w186 - (w370 + w65 * w183)
    w372 = w27 * w362 - w46
    w373 = w65 * w181 - w372 - w5 * w188
    w374 = w49 * w366 + w44 * w368 + w39 * w371 + w36 * w373
    w375 = w351 / w353
    w376 = w28 * w364 - w45 * w362
    w377 = w5 * w195 - w376 + w65 * w201
    w378 = w29 - w363
    w379 = w5 * w197 - w378 + w65 * w199
    w380 = w47 - w37 * w362
    w381 = w5 * w199 - (w380 + w65 * w197)
    w382 = w28 * w45 - w369
    w383 = w65 * w195 - w382 - w5 * w201
    w384 = w49 * w377 + w44 * w379 + w39 * w381 + w36 * w383
    w385 = w352 / w353
    w386 = w5 * w230 - w65 * w233
    w387 = w5 * w231 + w65 * w232
    w388 = w5 * w232 - w65 * w231
    w389 = w65 * w230 + w5 * w233
    w390 = w49 * w386 + w44 * w387 + w39 * w388 + w36 * w389
    w391 = (w354 * w359 + w360 * w374 + w375 * w384 + w385 * w390) / w353
    w392 = (w348 * w391 - (w341 * w359 + w343 * w374 + w345 * w384 + w347 * w390)) / w340
    w393 = (w318 * w391 - (w311 * w359 + w313 * w374 + w315 * w384 + w317 * w390) - w335 * w392) / w310
    w394 = w289 * w391 - (w236 * w359 + w261 * w374 + w275 * w384 + w288 * w390) - w330 * w392 - w305 * w393
    w395 = w394 / w235
    w396 = w5 * w36 - w49 * w65 - w68 * w395
    w397 = w5 * w39 + w44 * w65 + w162 * w395
    w398 = w5 * w44 - w39 * w65 - w158 * w395
    w399 = w36 * w65 + w5 * w49 + w153 * w395
    w400 = w50 + w64 * w396 + w160 * w397 + w156 * w398 + w137 * w399
    w401 = w167 * c21
    w402 = w14 * w401
    w403 = w13 * w17
    w404 = w402 - w403
    w405 = w36 * w372 + w39 * w370 + w44 * w367 + w49 * w365
    w406 = w405 + w187 * w396 + w185 * w397 + w182 * w398 + w176 * w399
    w407 = w17 * w20
    w408 = w407 - w9 * w401
    w409 = w36 * w382 + w39 * w380 + w44 * w378 + w49 * w376
    w410 = w409 + w200 * w396 + w198 * w397 + w196 * w398 + w191 * w399
    w411 = w17 * c31
    w412 = w148 * c33
    w413 = w15 * c34
    w414 = w138 * w411 + bar3_e3 * bar3_e2 * c40
    w415 = w142 * w396 - w147 * w397 - w8 * w398 - w151 * w399 - w297 * w393
    w416 = w17 * w411 + w148 * w412 + w15 * w413
    w417 = w147 * w396 + w142 * w397 + w151 * w398 - w8 * w399 + w300 * w393
    w418 = w9 * c31
    w419 = w17 * c33
    w420 = w138 * c34
    w421 = bar3_e3 * bar3_e0 * c37 + w15 * w420
    w422 = w8 * w396 - w151 * w397 + w142 * w398 + w147 * w399 + w299 * w393
    w423 = w14 * c31
    w424 = w144 * c33
    w425 = w17 * c34
    w426 = w148 * w424 + bar3_e2 * bar3_e0 * c36
    w427 = w151 * w396 + w8 * w397 - w147 * w398 + w142 * w399 + w298 * w393
    w428 = w21 * w400 + w404 * w406 + w408 * w410 + w414 * w415 + w416 * w417 + w421 * w422 + w426 * w427
    w429 = w56 * c14
    w430 = w134 * w429
    w431 = w61 * c14
    w432 = w52 * w431
    w433 = w430 - w432
    w434 = w173 * c14
    w435 = w52 * w434
    w436 = w435 - w54 * w429
    w437 = w54 * w431 - w134 * w434
    w438 = w51 * c25
    w439 = w155 * c27
    w440 = w52 * c28
    w441 = bar2_e2 * bar2_e1 * c41 + w58 * w440
    w442 = w58 * w439 + bar2_e2 * bar2_e0 * c45
    w443 = w159 * w438 + bar2_e0 * bar2_e1 * c44
    w444 = w51 * w438 + w155 * w439 + w52 * w440
    w445 = w20 * w138 - w402
    w446 = w20 * w148
    w447 = w17 * w401
    w448 = w446 - w447
    w449 = w15 * w20 - w138 * w401
    w450 = w410 * c12 + w415 * w445 + w408 * w417 + w422 * w448 + w427 * w449
    w451 = w50 * w433 + w405 * w436 + w409 * w437 + w396 * w441 + w397 * w442 + w398 * w443 + w399 * w444 + w191 * w450
    w452 = w13 * w138
    w453 = w148 * w401 - w452
    w454 = w144 * w401 - w13 * w148
    w455 = w447 - w13 * w15
    w456 = w406 * c12 + w415 * w453 + w404 * w417 + w422 * w454 + w427 * w455
    w457 = w13 * w14 - w446
    w458 = w403 - w20 * w144
    w459 = w452 - w407
    w460 = w400 * c12 + w415 * w457 + w21 * w417 + w422 * w458 + w427 * w459
    w461 = bar3_e1 * bar3_e2 * c38 + w148 * w425
    w462 = w9 * w423 + bar3_e1 * bar3_e0 * c35
    w463 = w14 * w423 + w144 * w424 + w17 * w425
    w464 = w400 * w459 + w406 * w455 + w410 * w449 + w415 * w461 + w417 * w426 + w422 * w462 + w427 * w463
    w465 = w14 * w419 + bar3_e3 * bar3_e1 * c39
    w466 = w9 * w418 + w17 * w419 + w138 * w420
    w467 = w400 * w458 + w406 * w454 + w410 * w448 + w415 * w465 + w417 * w421 + w422 * w466 + w427 * w462
    w468 = w138 * (w138 * c31) + w14 * (w14 * c33) + w148 * (w148 * c34)
    w469 = w400 * w457 + w406 * w453 + w410 * w445 + w415 * w468 + w414 * w417 + w422 * w465 + w427 * w461
    w470 = w8 * w428 - (w451 + w176 * w456 + w137 * w460 + w142 * w464 + w147 * w467) + w151 * w469
    w471 = w22 * c6
    w472 = w23 * c8
    w473 = w24 * c9
    w474 = w27 * w472 + bar1_e2 * bar1_e0 * c103
    w475 = bar1_e2 * bar1_e1 * c52 + w27 * w473
    w476 = w37 * w471 + bar1_e1 * bar1_e0 * c104
    w477 = w22 * w471 + w23 * w472 + w24 * w473
    w478 = w51 * w434
    w479 = w134 * w431 - w478
    w480 = w432 - w159 * w434
    w481 = w58 * w431
    w482 = w481 - w435
    w483 = w450 + (w409 * c11 + w396 * w479 + w397 * w480 + w398 * w482 + w399 * w437)
    w484 = w58 * w434 - w430
    w485 = w52 * w429
    w486 = w478 - w485
    w487 = w155 * w434 - w58 * w429
    w488 = w456 + (w405 * c11 + w396 * w484 + w397 * w486 + w398 * w487 + w399 * w436)
    w489 = w51 * w429 - w481
    w490 = w159 * w429 - w51 * w431
    w491 = w485 - w155 * w431
    w492 = w460 + (w50 * c11 + w396 * w489 + w397 * w490 + w398 * w491 + w399 * w433)
    w493 = w5 * w470 - (w39 * w474 + w36 * w475 + w44 * w476 + w49 * w477 + w376 * w483 + w365 * w488 + w48 * w492)
    w494 = w134 * (w134 * c25) + w51 * (w51 * c27) + w58 * (w58 * c28)
    w495 = w52 * c25
    w496 = w58 * c27
    w497 = w54 * c28
    w498 = w134 * w495 + bar2_e2 * bar2_e3 * c47
    w499 = w159 * c25
    w500 = w52 * c27
    w501 = w134 * c28
    w502 = w51 * w500 + bar2_e1 * bar2_e3 * c46
    w503 = w50 * w489 + w405 * w484 + w409 * w479 + w396 * w494 + w397 * w498 + w398 * w502 + w399 * w441 + w200 * w450
    w504 = w503 + w187 * w456 + w64 * w460 + w151 * w464 + w8 * w467 + w147 * w428 + w142 * w469
    w505 = w27 * bar1_e0_dot
    w506 = w24 * bar1_e3_dot
    w507 = w505 + w364 * bar1_e1_dot + w45 * bar1_e2_dot + w506
    w508 = w507 * c5
    w509 = w22 * bar1_e0_dot
    w510 = w24 * bar1_e2_dot
    w511 = w509 + w27 * bar1_e1_dot + w510 + w23 * bar1_e3_dot
    w512 = w511 * c4
    w513 = w508 * w511 - w507 * w512
    w514 = w45 * bar1_e0_dot + w24 * bar1_e1_dot
    w515 = w514 + w37 * bar1_e2_dot + w22 * bar1_e3_dot
    w516 = w515 * c7
    w517 = w507 * w516 - w508 * w515
    w518 = w512 * w515 - w511 * w516
    w519 = w361 * c93
    w520 = w25 * c93
    w521 = w1 * w32
    w522 = w521 * c1 * c3 - w521 * c2 * c0
    w523 = w43 * c51
    w524 = w35 * c42
    w525 = w35 * c2 * c3 - w35 * c1 * c0
    w526 = w22 * w513 + w23 * w517 + w24 * w518 + (w24 * w519 - w364 * w520) * c94 - (w474 * w522 - w475 * w523 + w476 * w524 + w477 * w525)
    w527 = w134 * bar2_e0_dot + w52 * bar2_e1_dot
    w528 = w527 + w159 * bar2_e2_dot + w51 * bar2_e3_dot
    w529 = w528 * c14
    w530 = w58 * bar2_e0_dot
    w531 = w52 * bar2_e3_dot
    w532 = w530 + w54 * bar2_e1_dot + w134 * bar2_e2_dot + w531
    w533 = w532 * c14
    w534 = w528 * w529 + w532 * w533
    w535 = bar2_e3 * w155
    w536 = bar2_e2 * w52
    w537 = w535 - w536
    w538 = w51 * bar2_e0_dot
    w539 = w52 * bar2_e2_dot
    w540 = w538 + w58 * bar2_e1_dot + w539 + w155 * bar2_e3_dot
    w541 = w529 * w540
    w542 = 2 * bar2_e2**2
    w543 = w59 - w542
    w544 = w533 * w540
    w545 = w514 + w27 * bar1_e2_dot + w364 * bar1_e3_dot
    w546 = w506 + (w505 + w22 * bar1_e1_dot + w23 * bar1_e2_dot)
    w547 = w362 * w546 - w26 * w545
    w548 = w510 + (w509 + w37 * bar1_e1_dot) + w45 * bar1_e3_dot
    w549 = w26 * w548 - w28 * w546
    w550 = w545 * w547 - w548 * w549
    w551 = w550 - w382 * w523 + w380 * w522 + w378 * w524 + w376 * w525
    w552 = (hinge1_angle_dot / 2.0)**2
    w553 = w65 * w552
    w554 = w5 * w552
    w555 = w66 * hinge1_angle_dot
    w556 = w67 * hinge1_angle_dot
    w557 = bar1_e0_dot * w555 + bar1_e3_dot * w556
    w558 = bar1_e3 * w553 - bar1_e0 * w554 - w557 - w557
    w559 = w14 * bar3_e0_dot
    w560 = w17 * bar3_e2_dot
    w561 = w559 + w9 * bar3_e1_dot + w560 + w138 * bar3_e3_dot
    w562 = w138 * bar3_e0_dot + w17 * bar3_e1_dot
    w563 = w562 + w148 * bar3_e2_dot + w15 * bar3_e3_dot
    w564 = w132 * w563 - w168 * w561
    w565 = w148 * bar3_e0_dot
    w566 = w17 * bar3_e3_dot
    w567 = w565 + w14 * bar3_e1_dot + w144 * bar3_e2_dot + w566
    w568 = w168 * w567 - w131 * w563
    w569 = w539 + (w538 + w159 * bar2_e1_dot) + w134 * bar2_e3_dot
    w570 = w527 + w58 * bar2_e2_dot + w54 * bar2_e3_dot
    w571 = w62 * w570 - w174 * w569
    w572 = w531 + (w530 + w51 * bar2_e1_dot + w155 * bar2_e2_dot)
    w573 = w174 * w572 - w57 * w570
    w574 = w569 * w571 - w572 * w573
    w575 = hinge2_angle_dot / 2.0
    w576 = w575**2
    w577 = w146 * w576
    w578 = w577 * c16 * c17 - w577 * c18 * c19
    w579 = w7 * w576
    w580 = w575 * (w7 * w575) * c20
    w581 = w579 * c18 * c17 - w579 * c16 * c19
    w582 = w575 * (w146 * w575) * c22
    w583 = w293 * hinge2_angle_dot
    w584 = w583 * c18 * c19 - w583 * c16 * c17
    w585 = w291 * hinge2_angle_dot
    w586 = w585 * c20
    w587 = w585 * c18 * c17 - w585 * c16 * c19
    w588 = w583 * c22
    w589 = bar2_e0_dot * w584 - bar2_e3_dot * w586 + (bar2_e1_dot * w587 - bar2_e2_dot * w588)
    w590 = w589 + (bar2_e0 * w578 - bar2_e3 * w580 + (bar2_e1 * w581 + bar2_e2 * w582) + w589)
    w591 = bar2_e0_dot * w587 - bar2_e2_dot * w586 + (bar2_e3_dot * w588 - bar2_e1_dot * w584)
    w592 = w591 + (bar2_e0 * w581 - bar2_e2 * w580 - (bar2_e3 * w582 + bar2_e1 * w578) + w591)
    w593 = bar2_e0_dot * w588 - bar2_e1_dot * w586 + (bar2_e2_dot * w584 - bar2_e3_dot * w587)
    w594 = w593 + (bar2_e2 * w578 - bar2_e3 * w581 - (bar2_e0 * w582 + bar2_e1 * w580) + w593)
    w595 = bar2_e0_dot * w586 + (bar2_e1_dot * w588 + bar2_e2_dot * w587 + bar2_e3_dot * w584)
    w596 = w595 + (bar2_e0 * w580 + (bar2_e2 * w581 - bar2_e1 * w582 + bar2_e3 * w578) + w595)
    w597 = w76 * bar4_e0_dot
    w598 = w72 * bar4_e2_dot
    w599 = w597 + w69 * bar4_e1_dot + w598 + w105 * bar4_e3_dot
    w600 = w105 * bar4_e0_dot + w72 * bar4_e1_dot
    w601 = w600 + w109 * bar4_e2_dot + w207 * bar4_e3_dot
    w602 = w80 * w601 - w239 * w599
    w603 = w109 * bar4_e0_dot
    w604 = w72 * bar4_e3_dot
    w605 = w603 + w76 * bar4_e1_dot + w70 * bar4_e2_dot + w604
    w606 = w239 * w605 - w75 * w601
    w607 = w599 * w602 - w605 * w606
    w608 = (hinge4_angle_dot / 2.0)**2
    w609 = w83 * w608
    w610 = w86 * w608
    w611 = w320 * hinge4_angle_dot
    w612 = w321 * hinge4_angle_dot
    w613 = bar5_e0_dot * w611 + w612 * bar5_e3_dot
    w614 = bar5_e0 * w609 - bar5_e3 * w610 - w613 - w613
    w615 = w561 * w564 - w567 * w568 + w574 + w141 * w590 + w145 * w592 + w133 * w594 - w150 * w596 + w607 + w108 * w614
    w616 = w611 * bar5_e1_dot - w612 * bar5_e2_dot
    w617 = w616 + (w616 - (bar5_e2 * w610 + bar5_e1 * w609))
    w618 = w612 * bar5_e1_dot + w611 * bar5_e2_dot
    w619 = bar5_e2 * w609 - bar5_e1 * w610 - w618 - w618
    w620 = w611 * bar5_e3_dot - bar5_e0_dot * w612
    w621 = w620 + (w620 - (bar5_e0 * w610 + bar5_e3 * w609))
    w622 = w28 * w545 - w362 * w548
    w623 = w548 * w622 - w546 * w547
    w624 = bar1_e0_dot * w556 - bar1_e3_dot * w555
    w625 = w624 + (w624 - (bar1_e0 * w553 + bar1_e3 * w554))
    w626 = bar1_e2_dot * w555 + bar1_e1_dot * w556
    w627 = bar1_e1 * w553 - bar1_e2 * w554 - w626 - w626
    w628 = bar1_e2_dot * w556 - bar1_e1_dot * w555
    w629 = w628 + (w628 - (bar1_e1 * w554 + bar1_e2 * w553))
    w630 = w615 + w85 * w617 + w81 * w619 + w111 * w621 + w623 - w152 * w625 - w157 * w627 - w161 * w629 + w163 * w558
    w631 = w121 * bar5_e0_dot
    w632 = w87 * bar5_e2_dot
    w633 = w631 + w120 * bar5_e1_dot + w632 + w112 * bar5_e3_dot
    w634 = w112 * bar5_e0_dot + w87 * bar5_e1_dot
    w635 = w634 + w125 * bar5_e2_dot + w89 * bar5_e3_dot
    w636 = w98 * w635 - w246 * w633
    w637 = w125 * bar5_e0_dot
    w638 = w87 * bar5_e3_dot
    w639 = w637 + w121 * bar5_e1_dot + w94 * bar5_e2_dot + w638
    w640 = w246 * w639 - w92 * w635
    w641 = w633 * w636 - w639 * w640
    w642 = hinge5_angle_dot / 2.0
    w643 = w642**2
    w644 = w102 * w643
    w645 = w644 * c57 * c60 - w644 * c59 * c58
    w646 = w117 * w643
    w647 = w646 * c57 * c58 - w646 * c59 * c60
    w648 = w642 * (w102 * w642) * c61
    w649 = w642 * (w117 * w642) * c62
    w650 = w630 + w641 + w116 * w645 - w100 * w647 + w123 * w648 + w128 * w649 - w355 * w525 - w356 * w524 - w357 * w522
    w651 = w650 + w358 * w523
    w652 = w131 * w561 - w132 * w567
    w653 = w57 * w569 - w62 * w572
    w654 = w572 * w653 - w570 * w571
    w655 = w75 * w599 - w80 * w605
    w656 = w605 * w655 - w601 * w602
    w657 = w567 * w652 - w563 * w564 + w654 + w178 * w590 + w179 * w592 + w170 * w594 - w180 * w596 + w656 + w250 * w614
    w658 = w546 * w549 - w545 * w622
    w659 = w657 + w242 * w617 + w241 * w619 + w251 * w621 + w658 - w181 * w625 - w183 * w627 - w186 * w629 + w188 * w558
    w660 = w92 * w633 - w98 * w639
    w661 = w639 * w660 - w635 * w636
    w662 = w659 + w661 + w254 * w645 - w248 * w647 + w257 * w648 + w259 * w649 - w366 * w525 - w368 * w524 - w371 * w522
    w663 = w662 + w373 * w523
    w664 = w570 * w573 - w569 * w653
    w665 = w601 * w606 - w599 * w655
    w666 = w563 * w568 - w561 * w652 + w664 + w192 * w590 + w193 * w592 + w190 * w594 - w194 * w596 + w665 + w266 * w614
    w667 = w550 + (w666 + w263 * w617 + w262 * w619 + w267 * w621) - w195 * w625 - w197 * w627 - w199 * w629
    w668 = w635 * w640 - w633 * w660
    w669 = w667 + w201 * w558 + w668 + w269 * w645 - w265 * w647 + w271 * w648 + w273 * w649 - w377 * w525 - w379 * w524
    w670 = w669 - w381 * w522 + w383 * w523
    w671 = w214 * w601 - w217 * w599
    w672 = w217 * w605 - w209 * w601
    w673 = w599 * w671 - w605 * w672
    w674 = w209 * w599 - w214 * w605
    w675 = w605 * w674 - w601 * w671
    w676 = w601 * w672 - w599 * w674
    w677 = w205 * w563 - w220 * w561
    w678 = w220 * w567 - w211 * w563
    w679 = w561 * w677 - w567 * w678
    w680 = w211 * w561 - w205 * w567
    w681 = w567 * w680 - w563 * w677
    w682 = w563 * w678 - w561 * w680
    w683 = 2 * w680
    w684 = 2 * w678
    w685 = w220 * w673 + w205 * w675 + w211 * w676 + w217 * w679 + w214 * w681 + w209 * w682 + w674 * w683 + w672 * w684
    w686 = 2 * w677
    w687 = w229 * w596 - (w685 + w671 * w686 + w226 * w590 + w227 * w592 + w228 * w594) - w279 * w614 - w282 * w617
    w688 = w687 - w283 * w619 - w280 * w621 - w230 * w625 - w231 * w627 - w232 * w629 - w233 * w558 - w281 * w645
    w689 = w688 - w284 * w647 - w285 * w648 + w286 * w649 - w386 * w525 - w387 * w524 - w388 * w522 + w389 * w523
    w690 = (w354 * w651 + w360 * w663 + w375 * w670 + w385 * w689) / w353
    w691 = (w341 * w651 + w343 * w663 + w345 * w670 + w347 * w689 - w348 * w690) / w340
    w692 = (w311 * w651 + w313 * w663 + w315 * w670 + w317 * w689 - w318 * w690 - w335 * w691) / w310
    w693 = (w236 * w651 + w261 * w663 + w275 * w670 + w288 * w689 - w289 * w690 - w330 * w691 - w305 * w692) / w235
    w694 = w558 - w5 * w523 - w65 * w525 - w68 * w693
    w695 = w629 + w5 * w522 + w65 * w524 + w162 * w693
    w696 = w627 - w65 * w522 + w5 * w524 - w158 * w693
    w697 = w625 - w65 * w523 + w5 * w525 + w153 * w693
    w698 = w56 * w534 - w537 * w541 - w543 * w544 - (w551 * c11 + w479 * w694 + w480 * w695 + w482 * w696 + w437 * w697)
    w699 = w560 + (w559 + w148 * bar3_e1_dot) + w144 * bar3_e3_dot
    w700 = w699 * c21
    w701 = w562 + w9 * bar3_e2_dot + w14 * bar3_e3_dot
    w702 = w701 * c21
    w703 = w699 * w700 + w701 * w702
    w704 = w566 + (w565 + w15 * bar3_e1_dot + w138 * bar3_e2_dot)
    w705 = w702 * w704
    w706 = w16 + w18
    w707 = w700 * w704
    w708 = w551 + w664 + w200 * w694 + w198 * w695 + w196 * w696 + w191 * w697
    w709 = w142 * w694 - w596 - w147 * w695 - w8 * w696 - w151 * w697 - w297 * w692
    w710 = w594 + w147 * w694 + w142 * w695 + w151 * w696 - w8 * w697 + w300 * w692
    w711 = w592 + w8 * w694 - w151 * w695 + w142 * w696 + w147 * w697 + w299 * w692
    w712 = w590 + w151 * w694 + w8 * w695 - w147 * w696 + w142 * w697 + w298 * w692
    w713 = w12 * w703 - (w211 * w705 + w706 * w707) - (w708 * c12 + w445 * w709 + w408 * w710 + w448 * w711 + w449 * w712)
    w714 = w698 + w713
    w715 = w171 + w172
    w716 = w55 - w53
    w717 = w658 - w372 * w523 + w370 * w522 + w367 * w524 + w365 * w525
    w718 = c95 + (w61 * w534 - w541 * w715 - w544 * w716) - (w717 * c11 + w484 * w694 + w486 * w695 + w487 * w696 + w436 * w697)
    w719 = w10 - w219
    w720 = w654 + w717 + w187 * w694 + w185 * w695 + w182 * w696 + w176 * w697
    w721 = c96 + (w19 * w703 - (w205 * w705 + w707 * w719)) - (w720 * c12 + w453 * w709 + w404 * w710 + w454 * w711 + w455 * w712)
    w722 = w718 + w721
    w723 = 1.0 - w542 - w60
    w724 = w535 + w536
    w725 = w623 - w30 * w523 + w38 * w522 + w41 * w524 + w48 * w525
    w726 = w173 * w534 - w541 * w723 - w544 * w724 - (w725 * c11 + w489 * w694 + w490 * w695 + w491 * w696 + w433 * w697)
    w727 = w204 - w203
    w728 = w574 + w725 + w64 * w694 + w160 * w695 + w156 * w696 + w137 * w697
    w729 = w167 * w703 - (w220 * w705 + w707 * w727) - (w728 * c12 + w457 * w709 + w21 * w710 + w458 * w711 + w459 * w712)
    w730 = w726 + w729
    w731 = w532 * c24
    w732 = w540 * c23
    w733 = w540 * w731 - w532 * w732
    w734 = w528 * c26
    w735 = w532 * w734 - w528 * w731
    w736 = w528 * w732 - w540 * w734
    w737 = w51 * w733 + w155 * w735 + w52 * w736 + w436 * c94 - (w433 * w725 + w436 * w717 + w437 * w551 + w441 * w694 + w442 * w695 + w443 * w696 + w444 * w697)
    w738 = w704 * c30
    w739 = w699 * c29
    w740 = w699 * w738 - w704 * w739
    w741 = w701 * c32
    w742 = w704 * w741 - w701 * w738
    w743 = w701 * w739 - w699 * w741
    w744 = w14 * w740 + w144 * w742 + w17 * w743 + w455 * c94 - (w459 * w728 + w455 * w720 + w449 * w708 + w461 * w709 + w426 * w710 + w462 * w711 + w463 * w712)
    w745 = w9 * w740 + w17 * w742 + w138 * w743 + w454 * c94 - (w458 * w728 + w454 * w720 + w448 * w708 + w465 * w709 + w421 * w710 + w466 * w711 + w462 * w712)
    w746 = w17 * w740 + w148 * w742 + w15 * w743 + w404 * c94 - (w21 * w728 + w404 * w720 + w408 * w708 + w414 * w709 + w416 * w710 + w421 * w711 + w426 * w712)
    w747 = w138 * w740 + w14 * w742 + w148 * w743 + w453 * c94 - (w457 * w728 + w453 * w720 + w445 * w708 + w468 * w709 + w414 * w710 + w465 * w711 + w461 * w712)
    w748 = w737 + w191 * w713 + w176 * w721 + w137 * w729 + w142 * w744 + w147 * w745 - w8 * w746 - w151 * w747
    w749 = w134 * w733 + w51 * w735 + w58 * w736 + w484 * c94 - (w489 * w725 + w484 * w717 + w479 * w551 + w494 * w694 + w498 * w695 + w502 * w696 + w441 * w697)
    w750 = w749 + w200 * w713 + w187 * w721 + w64 * w729 + w151 * w744 + w8 * w745 + w147 * w746 + w142 * w747
    w751 = w33 * 0.25
    w752 = w751 * c2 * c3 - w751 * c1 * c0
    w753 = w3 * (w493 + w65 * w504) + (w526 + w376 * w714 + w365 * w722 + w48 * w730 + w5 * w748 - w65 * w750) * w752
    w754 = w2 * c42
    w755 = bar2_e0 * bar2_e3 * c48 + w54 * w501
    w756 = w159 * w499 + w52 * w500 + w134 * w501
    w757 = w50 * w491 + w405 * w487 + w409 * w482 + w396 * w502 + w397 * w755 + w398 * w756 + w399 * w443 + w196 * w450
    w758 = w147 * w464 - (w757 + w182 * w456 + w156 * w460) - w142 * w467 - w151 * w428 + w8 * w469
    w759 = w37 * c6
    w760 = w24 * c8
    w761 = w45 * c9
    w762 = bar1_e3 * bar1_e0 * c50 + w364 * w761
    w763 = w22 * w760 + bar1_e1 * bar1_e3 * c53
    w764 = w37 * w759 + w24 * w760 + w45 * w761
    w765 = w5 * w758 - (w39 * w762 + w36 * w763 + w44 * w764 + w49 * w476 + w378 * w483 + w367 * w488 + w41 * w492)
    w766 = w52 * w495 + w58 * w496 + w54 * w497
    w767 = w50 * w490 + w405 * w486 + w409 * w480 + w396 * w498 + w397 * w766 + w398 * w755 + w399 * w442 + w198 * w450
    w768 = w151 * w467 - (w767 + w185 * w456 + w160 * w460 + w8 * w464) - w142 * w428 + w147 * w469
    w769 = w37 * w513 + w24 * w517 + w45 * w518 + (w23 * w519 - w27 * w520) * c94 - (w522 * w762 - w523 * w763 + w524 * w764 + w476 * w525)
    w770 = w159 * w733 + w52 * w735 + w134 * w736 + w487 * c94 - (w491 * w725 + w487 * w717 + w482 * w551 + w502 * w694 + w695 * w755 + w696 * w756 + w443 * w697)
    w771 = w770 + w196 * w713 + w182 * w721 + w156 * w729 - w147 * w744 + w142 * w745 + w151 * w746 - w8 * w747
    w772 = w52 * w733 + w58 * w735 + w54 * w736 + w486 * c94 - (w490 * w725 + w486 * w717 + w480 * w551 + w498 * w694 + w695 * w766 + w696 * w755 + w442 * w697)
    w773 = w772 + w198 * w713 + w185 * w721 + w160 * w729 + w8 * w744 - w151 * w745 + w142 * w746 - w147 * w747
    w774 = w33 * c110
    w775 = w754 * (w765 + w65 * w768) - (w769 + w378 * w714 + w367 * w722 + w41 * w730 + w5 * w771 + w65 * w773) * w774
    w776 = w33 / 2.0
    w777 = w776 * c1 * c3 - w776 * c2 * c0
    w778 = w24 * c6
    w779 = w27 * c8
    w780 = w364 * c9
    w781 = w24 * w778 + w27 * w779 + w364 * w780
    w782 = w45 * w778 + bar1_e2 * bar1_e3 * c54
    w783 = w39 * w781 + w36 * w782 + w44 * w762 + w49 * w474 + w380 * w483 + w370 * w488 + w38 * w492 + w65 * w758
    w784 = w24 * w513 + w27 * w517 + w364 * w518 + (w22 * w519 - w24 * w520) * c94 - (w522 * w781 - w523 * w782 + w524 * w762 + w474 * w525)
    w785 = w1 * 0.25
    w786 = w785 * c1 * c3 - w785 * c2 * c0
    w787 = w777 * (w5 * w768 - w783) + (w784 + w380 * w714 + w370 * w722 + w38 * w730 - w65 * w771 + w5 * w773) * w786
    w788 = w776 * c51
    w789 = w45 * (w45 * c6) + w22 * (w22 * c8) + w27 * (w27 * c9)
    w790 = w65 * w470 - (w39 * w782 + w36 * w789 + w44 * w763 + w49 * w475 + w382 * w483 + w372 * w488 + w30 * w492)
    w791 = w45 * w513 + w22 * w517 + w27 * w518 + (w27 * w519 - w45 * w520) * c94 - (w522 * w782 - w523 * w789 + w524 * w763 + w475 * w525)
    w792 = w1 * c111
    w793 = w788 * (w790 - w5 * w504) + (w791 + w382 * w714 + w372 * w722 + w30 * w730 + w65 * w748 + w5 * w750) * w792
    w794 = w3 * w355 - w356 * w754 + w357 * w777 - w358 * w788
    w795 = w3 * w366 - w368 * w754 + w371 * w777 - w373 * w788
    w796 = w3 * w377 - w379 * w754 + w381 * w777 - w383 * w788
    w797 = w3 * w386 - w387 * w754 + w388 * w777 - w389 * w788
    w798 = (w354 * w794 + w360 * w795 + w375 * w796 + w385 * w797) / w353
    w799 = w104 * w391
    w800 = w129 * w391
    w801 = w124 * w391
    w802 = w119 * w391
    w803 = w264 * w799 - (w272 * w800 + w270 * w801) + w268 * w802
    w804 = w86 * w800 - w83 * w802 + w325 * w392
    w805 = w86 * w801 + w83 * w799 - w324 * w392
    w806 = w83 * w801 - w86 * w799 + w323 * w392
    w807 = w83 * w800 + w86 * w802 + w322 * w392
    w808 = w803 - (w267 * w804 + w262 * w805 + w263 * w806 - w266 * w807)
    w809 = w79 * c78
    w810 = w238 * c78
    w811 = w76 * w810
    w812 = w105 * w809 - w811
    w813 = w72 * w809
    w814 = w813 - w69 * w810
    w815 = w109 * w809
    w816 = w72 * w810
    w817 = w815 - w816
    w818 = w207 * w809 - w105 * w810
    w819 = w808 * c74 + w804 * w812 + w805 * w814 + w806 * w817 - w807 * w818
    w820 = w74 * c78
    w821 = w105 * w820
    w822 = w821 - w813
    w823 = w99 * w799 - (w127 * w800 + w122 * w801) + w115 * w802
    w824 = w823 - (w111 * w804 + w81 * w805 + w85 * w806 - w108 * w807)
    w825 = w816 - w207 * w820
    w826 = w247 * w799 - (w258 * w800 + w256 * w801) + w253 * w802
    w827 = w826 - (w251 * w804 + w241 * w805 + w242 * w806 - w250 * w807)
    w828 = w76 * c73
    w829 = w70 * c76
    w830 = w72 * c77
    w831 = bar4_e1 * bar4_e2 * c79 + w109 * w830
    w832 = w109 * w829 + bar4_e0 * bar4_e2 * c84
    w833 = w69 * w828 + bar4_e1 * bar4_e0 * c83
    w834 = w76 * w828 + w70 * w829 + w72 * w830
    w835 = w266 * w819 - (w822 * w824 + w825 * w827 + w808 * w818 + w804 * w831 + w805 * w832 + w806 * w833 - w807 * w834)
    w836 = w109 * w810 - w821
    w837 = w72 * w820
    w838 = w811 - w837
    w839 = w70 * w810 - w109 * w820
    w840 = w827 * c74 + w804 * w836 + w805 * w838 + w806 * w839 - w807 * w825
    w841 = w76 * w820 - w815
    w842 = w69 * w820 - w76 * w809
    w843 = w837 - w70 * w809
    w844 = w824 * c74 + w804 * w841 + w805 * w842 + w806 * w843 - w807 * w822
    w845 = w835 + w250 * w840 + w108 * w844
    w846 = w91 * c80
    w847 = w112 * w846
    w848 = w97 * c80
    w849 = w87 * w848
    w850 = w847 - w849
    w851 = w245 * c80
    w852 = w87 * w851
    w853 = w852 - w89 * w846
    w854 = w89 * w848 - w112 * w851
    w855 = w121 * c67
    w856 = w94 * c69
    w857 = w87 * c70
    w858 = bar5_e1 * bar5_e2 * c90 + w125 * w857
    w859 = w125 * w856 + bar5_e0 * bar5_e2 * c88
    w860 = w120 * w855 + bar5_e0 * bar5_e1 * c82
    w861 = w121 * w855 + w94 * w856 + w87 * w857
    w862 = w86 * w845 - (w823 * w850 + w826 * w853 + w803 * w854 + w800 * w858 + w801 * w859 - w799 * w860 - w802 * w861)
    w863 = w105 * c73
    w864 = w109 * c77
    w865 = w105 * w863 + w76 * (w76 * c76) + w109 * w864
    w866 = w72 * c73
    w867 = w109 * c76
    w868 = w207 * c77
    w869 = w105 * w866 + bar4_e3 * bar4_e2 * c86
    w870 = w69 * c73
    w871 = w72 * c76
    w872 = w105 * c77
    w873 = w76 * w871 + bar4_e3 * bar4_e1 * c85
    w874 = w267 * w819 - (w824 * w841 + w827 * w836 + w808 * w812 + w804 * w865 + w805 * w869 + w806 * w873 - w807 * w831)
    w875 = w874 + w251 * w840 + w111 * w844
    w876 = w121 * w851
    w877 = w112 * w848 - w876
    w878 = w849 - w120 * w851
    w879 = w125 * w848
    w880 = w879 - w852
    w881 = w819 + (w803 * c64 + w800 * w877 + w801 * w878 - w799 * w880 - w802 * w854)
    w882 = w125 * w851 - w847
    w883 = w87 * w846
    w884 = w876 - w883
    w885 = w94 * w851 - w125 * w846
    w886 = w840 + (w826 * c64 + w800 * w882 + w801 * w884 - w799 * w885 - w802 * w853)
    w887 = w121 * w846 - w879
    w888 = w120 * w846 - w121 * w848
    w889 = w883 - w94 * w848
    w890 = w844 + (w823 * c64 + w800 * w887 + w801 * w888 - w799 * w889 - w802 * w850)
    w891 = bar4_e3 * bar4_e0 * c87 + w207 * w872
    w892 = w69 * w870 + w72 * w871 + w105 * w872
    w893 = w263 * w819 - (w824 * w843 + w827 * w839 + w808 * w817 + w804 * w873 + w805 * w891 + w806 * w892 - w807 * w833)
    w894 = w893 + w242 * w840 + w85 * w844
    w895 = w120 * c67
    w896 = w87 * c69
    w897 = w112 * c70
    w898 = w121 * w896 + bar5_e1 * bar5_e3 * c91
    w899 = bar5_e0 * bar5_e3 * c89 + w89 * w897
    w900 = w120 * w895 + w87 * w896 + w112 * w897
    w901 = w86 * w894 - (w823 * w889 + w826 * w885 + w803 * w880 + w800 * w898 + w801 * w899 - w799 * w900 - w802 * w860)
    w902 = w72 * w866 + w109 * w867 + w207 * w868
    w903 = w262 * w819 - (w824 * w842 + w827 * w838 + w808 * w814 + w804 * w869 + w805 * w902 + w806 * w891 - w807 * w832)
    w904 = w903 + w241 * w840 + w81 * w844
    w905 = w119 * (w862 + w83 * w875 + w268 * w881 + w253 * w886 + w115 * w890) + w104 * (w901 - w83 * w904 + w264 * w881 + w247 * w886 + w99 * w890)
    w906 = w87 * c67
    w907 = w125 * c69
    w908 = w89 * c70
    w909 = w112 * w906 + bar5_e2 * bar5_e3 * c92
    w910 = w87 * w906 + w125 * w907 + w89 * w908
    w911 = w83 * w894 - (w823 * w888 + w826 * w884 + w803 * w878 + w800 * w909 + w801 * w910 - w799 * w899 - w802 * w859)
    w912 = w112 * (w112 * c67) + w121 * (w121 * c69) + w125 * (w125 * c70)
    w913 = w823 * w887 + w826 * w882 + w803 * w877 + w800 * w912 + w801 * w909 - w799 * w898 - w802 * w858 + w83 * w845
    w914 = w905 - w124 * (w911 + w86 * w904 + w270 * w881 + w256 * w886 + w122 * w890) - w129 * (w86 * w875 - w913 + w272 * w881 + w258 * w886 + w127 * w890)
    w915 = w638 + (w637 + w89 * bar5_e1_dot + w112 * bar5_e2_dot)
    w916 = w915 * c66
    w917 = w632 + (w631 + w125 * bar5_e1_dot) + w94 * bar5_e3_dot
    w918 = w917 * c65
    w919 = w916 * w917 - w915 * w918
    w920 = w634 + w120 * bar5_e2_dot + w121 * bar5_e3_dot
    w921 = w920 * c68
    w922 = w915 * w921 - w916 * w920
    w923 = w918 * w920 - w917 * w921
    w924 = w649 + w129 * w690
    w925 = w648 - w124 * w690
    w926 = w647 + w104 * w690
    w927 = w645 + w119 * w690
    w928 = w127 * w924 - w641 - w122 * w925 - w99 * w926 - w115 * w927
    w929 = w258 * w924 - w661 - w256 * w925 - w247 * w926 - w253 * w927
    w930 = w272 * w924 - w668 - w270 * w925 - w264 * w926 - w268 * w927
    w931 = w121 * w919 + w94 * w922 + w87 * w923 + w853 * c94 - (w850 * w928 + w853 * w929 + w854 * w930 - w858 * w924 + w859 * w925 + w860 * w926 + w861 * w927)
    w932 = w604 + (w603 + w207 * bar4_e1_dot + w105 * bar4_e2_dot)
    w933 = w932 * c72
    w934 = w598 + (w597 + w109 * bar4_e1_dot) + w70 * bar4_e3_dot
    w935 = w934 * c71
    w936 = w933 * w934 - w932 * w935
    w937 = w600 + w69 * bar4_e2_dot + w76 * bar4_e3_dot
    w938 = w937 * c75
    w939 = w932 * w938 - w933 * w937
    w940 = w935 * w937 - w934 * w938
    w941 = w621 - w86 * w924 + w83 * w927 + w325 * w691
    w942 = w619 + w86 * w925 - w83 * w926 - w324 * w691
    w943 = w617 + w83 * w925 + w86 * w926 + w323 * w691
    w944 = w614 + w83 * w924 + w86 * w927 - w322 * w691
    w945 = w928 - (w607 + w111 * w941 + w81 * w942 + w85 * w943 + w108 * w944)
    w946 = w929 - (w656 + w251 * w941 + w241 * w942 + w242 * w943 + w250 * w944)
    w947 = w930 - (w665 + w267 * w941 + w262 * w942 + w263 * w943 + w266 * w944)
    w948 = w76 * w936 + w70 * w939 + w72 * w940 + w825 * c94 - (w822 * w945 + w825 * w946 + w818 * w947 + w831 * w941 + w832 * w942 + w833 * w943 + w834 * w944)
    w949 = w932 * c78
    w950 = w934 * c78
    w951 = w932 * w949 + w934 * w950
    w952 = w937 * w950
    w953 = w212 - w237
    w954 = w937 * w949
    w955 = w74 * w951 - w209 * w952 - w953 * w954 - (w947 * c74 + w812 * w941 + w814 * w942 + w817 * w943 + w818 * w944)
    w956 = w208 - w206
    w957 = c97 + (w79 * w951 - w214 * w952 - w954 * w956) - (w946 * c74 + w836 * w941 + w838 * w942 + w839 * w943 + w825 * w944)
    w958 = w71 + w73
    w959 = w238 * w951 - w217 * w952 - w954 * w958 - (w945 * c74 + w841 * w941 + w842 * w942 + w843 * w943 + w822 * w944)
    w960 = w948 - w266 * w955 - w250 * w957 - w108 * w959
    w961 = w105 * w936 + w76 * w939 + w109 * w940 + w836 * c94 - (w841 * w945 + w836 * w946 + w812 * w947 + w865 * w941 + w869 * w942 + w873 * w943 + w831 * w944)
    w962 = w961 - w267 * w955 - w251 * w957 - w111 * w959
    w963 = w920 * c80
    w964 = w915 * c80
    w965 = w920 * w963 + w915 * w964
    w966 = bar5_e3 * w94
    w967 = w87 * bar5_e2
    w968 = w966 - w967
    w969 = w917 * w963
    w970 = 2 * bar5_e2**2
    w971 = w95 - w970
    w972 = w917 * w964
    w973 = w91 * w965 - w968 * w969 - w971 * w972 - (w930 * c64 - w877 * w924 + w878 * w925 + w880 * w926 + w854 * w927)
    w974 = w955 + w973
    w975 = w243 + w244
    w976 = w90 - w88
    w977 = c98 + (w97 * w965 - w969 * w975 - w972 * w976) - (w929 * c64 - w882 * w924 + w884 * w925 + w885 * w926 + w853 * w927)
    w978 = w957 + w977
    w979 = 1.0 - w970 - w96
    w980 = w966 + w967
    w981 = w245 * w965 - w969 * w979 - w972 * w980 - (w928 * c64 - w887 * w924 + w888 * w925 + w889 * w926 + w850 * w927)
    w982 = w959 + w981
    w983 = w931 + w86 * w960 + w83 * w962 - w268 * w974 - w253 * w978 - w115 * w982
    w984 = w120 * w919 + w87 * w922 + w112 * w923 + w885 * c94 - (w889 * w928 + w885 * w929 + w880 * w930 - w898 * w924 + w899 * w925 + w900 * w926 + w860 * w927)
    w985 = w69 * w936 + w72 * w939 + w105 * w940 + w839 * c94 - (w843 * w945 + w839 * w946 + w817 * w947 + w873 * w941 + w891 * w942 + w892 * w943 + w833 * w944)
    w986 = w985 - w263 * w955 - w242 * w957 - w85 * w959
    w987 = w72 * w936 + w109 * w939 + w207 * w940 + w838 * c94 - (w842 * w945 + w838 * w946 + w814 * w947 + w869 * w941 + w902 * w942 + w891 * w943 + w832 * w944)
    w988 = w987 - w262 * w955 - w241 * w957 - w81 * w959
    w989 = w984 + w86 * w986 - w83 * w988 - w264 * w974 - w247 * w978 - w99 * w982
    w990 = w87 * w919 + w125 * w922 + w89 * w923 + w884 * c94 - (w888 * w928 + w884 * w929 + w878 * w930 - w909 * w924 + w910 * w925 + w899 * w926 + w859 * w927)
    w991 = w990 + w83 * w986 + w86 * w988 - w270 * w974 - w256 * w978 - w122 * w982
    w992 = w112 * w919 + w121 * w922 + w125 * w923 + w882 * c94 - (w887 * w928 + w882 * w929 + w877 * w930 - w912 * w924 + w909 * w925 + w898 * w926 + w858 * w927)
    w993 = w992 - w83 * w960 + w86 * w962 - w272 * w974 - w258 * w978 - w127 * w982
    w994 = w119 * w983 + w104 * w989 - w124 * w991 - w129 * w993
    w995 = w355 * w752 + w356 * w774 + w357 * w786 - w358 * w792
    w996 = w366 * w752 + w368 * w774 + w371 * w786 - w373 * w792
    w997 = w377 * w752 + w379 * w774 + w381 * w786 - w383 * w792
    w998 = w386 * w752 + w387 * w774 + w388 * w786 - w389 * w792
    w999 = (w354 * w995 + w360 * w996 + w375 * w997 + w385 * w998) / w353
    w1000 = (w348 * w798 - (w341 * w794 + w343 * w795 + w345 * w796 + w347 * w797)) / w340
    w1001 = w323 * w986 - w322 * w960 - w324 * w988 + w325 * w962
    w1002 = (w348 * w999 - (w341 * w995 + w343 * w996 + w345 * w997 + w347 * w998)) / w340
    w1003 = w753 - w775 + w787 - w793 - (w798 * w914 + w994 * w999) + (w1000 * (w323 * w894 - w322 * w845 - w324 * w904 + w325 * w875) + w1001 * w1002)
    w1004 = (w318 * w798 - (w311 * w794 + w313 * w795 + w315 * w796 + w317 * w797) - w335 * w1000) / w310
    w1005 = w298 * w744 + w299 * w745 + w300 * w746 - w297 * w747
    w1006 = (w318 * w999 - (w311 * w995 + w313 * w996 + w315 * w997 + w317 * w998) - w335 * w1002) / w310
    w1007 = w289 * w798 - (w236 * w794 + w261 * w795 + w275 * w796 + w288 * w797) - w330 * w1000 - w305 * w1004
    w1008 = w1007 / w235
    w1009 = w153 * w748 - w158 * w771 + w162 * w773 - w68 * w750
    w1010 = w289 * w999 - (w236 * w995 + w261 * w996 + w275 * w997 + w288 * w998) - w330 * w1002 - w305 * w1006
    w1011 = w1010 / w235
    w1012 = w1003 + (w1004 * (w297 * w469 - (w298 * w464 + w299 * w467 + w300 * w428)) + w1005 * w1006) + (w1008 * (w153 * w470 - w158 * w758 + w162 * w768 + w68 * w504) + w1009 * w1011)
    w1013 = w158 * w1008
    w1014 = w65 * w777
    w1015 = w5 * w754
    w1016 = w1013 + w1014 + w1015
    w1017 = w162 * w1008
    w1018 = w5 * w777
    w1019 = w65 * w754
    w1020 = w1017 + w1018 - w1019
    w1021 = w68 * w1008
    w1022 = w5 * w788
    w1023 = w3 * w65
    w1024 = w1021 + w1022 + w1023
    w1025 = w153 * w1008
    w1026 = w65 * w788
    w1027 = w3 * w5
    w1028 = w1025 - w1026 + w1027
    w1029 = w297 * w1004
    w1030 = w8 * w1016 - (w1029 + w147 * w1020) - w142 * w1024 - w151 * w1028
    w1031 = w300 * w1004
    w1032 = w1031 + w142 * w1020 - w151 * w1016 - w147 * w1024 - w8 * w1028
    w1033 = w299 * w1004
    w1034 = w1033 - w151 * w1020 - w142 * w1016 - w8 * w1024 + w147 * w1028
    w1035 = w298 * w1004
    w1036 = w1035 + w8 * w1020 + w147 * w1016 - w151 * w1024 + w142 * w1028
    w1037 = w38 * w777 - w30 * w788 - w41 * w754 + w3 * w48
    w1038 = w160 * w1020 - w156 * w1016 - w64 * w1024 + w137 * w1028 + w1037
    w1039 = w457 * w1030 + w21 * w1032 + w458 * w1034 + w459 * w1036 + w1038 * c12
    w1040 = w370 * w777 - w372 * w788 - w367 * w754 + w3 * w365
    w1041 = w185 * w1020 - w182 * w1016 - w187 * w1024 + w176 * w1028 + w1040
    w1042 = w453 * w1030 + w404 * w1032 + w454 * w1034 + w455 * w1036 + w1041 * c12
    w1043 = w756 * w1016 - w755 * w1020 + w502 * w1024 - w443 * w1028 - w156 * w1039 - w491 * w1037 - w182 * w1042
    w1044 = w380 * w777 - w382 * w788 - w378 * w754 + w3 * w376
    w1045 = w198 * w1020 - w196 * w1016 - w200 * w1024 + w191 * w1028 + w1044
    w1046 = w461 * w1030 + w426 * w1032 + w462 * w1034 + w463 * w1036 + w459 * w1038 + w455 * w1041 + w449 * w1045
    w1047 = w465 * w1030 + w421 * w1032 + w466 * w1034 + w462 * w1036 + w458 * w1038 + w454 * w1041 + w448 * w1045
    w1048 = w414 * w1030 + w416 * w1032 + w421 * w1034 + w426 * w1036 + w21 * w1038 + w404 * w1041 + w408 * w1045
    w1049 = w468 * w1030 + w414 * w1032 + w465 * w1034 + w461 * w1036 + w457 * w1038 + w453 * w1041 + w445 * w1045
    w1050 = w445 * w1030 + w408 * w1032 + w448 * w1034 + w449 * w1036 + w1045 * c12
    w1051 = w1043 - w487 * w1040 + w147 * w1046 - w142 * w1047 - w151 * w1048 + w8 * w1049 - w196 * w1050 - w482 * w1044
    w1052 = w443 * w1016 - w442 * w1020 + w441 * w1024 - w444 * w1028 - w137 * w1039 - w433 * w1037 - w176 * w1042
    w1053 = w1052 - w436 * w1040 - w142 * w1046 - w147 * w1047 + w8 * w1048 + w151 * w1049 - w191 * w1050 - w437 * w1044
    w1054 = w755 * w1016 - w766 * w1020 + w498 * w1024 - w442 * w1028 - w160 * w1039 - w490 * w1037 - w185 * w1042
    w1055 = w1054 - w486 * w1040 - w8 * w1046 + w151 * w1047 - w142 * w1048 + w147 * w1049 - w198 * w1050 - w480 * w1044
    w1056 = w502 * w1016 - w498 * w1020 + w494 * w1024 - w441 * w1028 - w64 * w1039 - w489 * w1037 - w187 * w1042
    w1057 = w1056 - w484 * w1040 - w151 * w1046 - w8 * w1047 - w147 * w1048 - w142 * w1049 - w200 * w1050 - w479 * w1044
    w1058 = w153 * w1053 - w158 * w1051 + w162 * w1055 - w68 * w1057
    w1059 = w1058 / w235
    w1060 = w297 * w1049 - (w298 * w1046 + w299 * w1047 + w300 * w1048) - w305 * w1059
    w1061 = w1060 / w310
    w1062 = w322 * w1000
    w1063 = w129 * w798
    w1064 = w83 * w1063
    w1065 = w119 * w798
    w1066 = w86 * w1065
    w1067 = w1062 + w1064 + w1066
    w1068 = w124 * w798
    w1069 = w86 * w1068
    w1070 = w324 * w1000
    w1071 = w104 * w798
    w1072 = w83 * w1071
    w1073 = w1069 - w1070 + w1072
    w1074 = w323 * w1000
    w1075 = w83 * w1068
    w1076 = w86 * w1071
    w1077 = w1074 + w1075 - w1076
    w1078 = w325 * w1000
    w1079 = w86 * w1063
    w1080 = w83 * w1065
    w1081 = w1078 + w1079 - w1080
    w1082 = w99 * w1071 - (w127 * w1063 + w122 * w1068) + w115 * w1065
    w1083 = w1082 - (w81 * w1073 + w85 * w1077) - w111 * w1081 + w108 * w1067
    w1084 = w247 * w1071 - (w258 * w1063 + w256 * w1068) + w253 * w1065
    w1085 = w1084 - (w241 * w1073 + w242 * w1077) - w251 * w1081 + w250 * w1067
    w1086 = w264 * w1071 - (w272 * w1063 + w270 * w1068) + w268 * w1065
    w1087 = w1086 - (w262 * w1073 + w263 * w1077) - w267 * w1081 + w266 * w1067
    w1088 = w833 * w1067 - (w891 * w1073 + w892 * w1077 + w873 * w1081 + w843 * w1083 + w839 * w1085 + w817 * w1087)
    w1089 = w818 * w1067 - (w814 * w1073 + w817 * w1077 + w812 * w1081 + w1087 * c74)
    w1090 = w825 * w1067 - (w838 * w1073 + w839 * w1077 + w836 * w1081 + w1085 * c74)
    w1091 = w822 * w1067 - (w842 * w1073 + w843 * w1077 + w841 * w1081 + w1083 * c74)
    w1092 = w1088 - w263 * w1089 - w242 * w1090 - w85 * w1091
    w1093 = w834 * w1067 - (w832 * w1073 + w833 * w1077 + w831 * w1081 + w822 * w1083 + w825 * w1085 + w818 * w1087)
    w1094 = w1093 - w266 * w1089 - w250 * w1090 - w108 * w1091
    w1095 = w832 * w1067 - (w902 * w1073 + w891 * w1077 + w869 * w1081 + w842 * w1083 + w838 * w1085 + w814 * w1087)
    w1096 = w1095 - w262 * w1089 - w241 * w1090 - w81 * w1091
    w1097 = w831 * w1067 - (w869 * w1073 + w873 * w1077 + w865 * w1081 + w841 * w1083 + w836 * w1085 + w812 * w1087)
    w1098 = w1097 - w267 * w1089 - w251 * w1090 - w111 * w1091
    w1099 = w323 * w1092 - w322 * w1094 - w324 * w1096 + w325 * w1098 - w335 * w1061 - w330 * w1059
    w1100 = w1099 / w340
    w1101 = w860 * w1071 - (w858 * w1063 + w859 * w1068) - w850 * w1082 - w853 * w1084 - w854 * w1086 + w86 * w1094
    w1102 = w1089 + (w880 * w1071 - (w877 * w1063 + w878 * w1068) - w1086 * c64) + w854 * w1065
    w1103 = w1090 + (w885 * w1071 - (w882 * w1063 + w884 * w1068) - w1084 * c64) + w853 * w1065
    w1104 = w1091 + (w889 * w1071 - (w887 * w1063 + w888 * w1068) - w1082 * c64) + w850 * w1065
    w1105 = w1101 + w83 * w1098 + w861 * w1065 - w268 * w1102 - w253 * w1103 - w115 * w1104
    w1106 = w900 * w1071 - (w898 * w1063 + w899 * w1068) - w889 * w1082 - w885 * w1084 - w880 * w1086 + w86 * w1092
    w1107 = w1106 - w83 * w1096 + w860 * w1065 - w264 * w1102 - w247 * w1103 - w99 * w1104
    w1108 = w899 * w1071 - (w909 * w1063 + w910 * w1068) - w888 * w1082 - w884 * w1084 - w878 * w1086 + w83 * w1092
    w1109 = w1108 + w86 * w1096 + w859 * w1065 - w270 * w1102 - w256 * w1103 - w122 * w1104
    w1110 = w912 * w1063 + w909 * w1068 - w898 * w1071 + w887 * w1082 + w882 * w1084 + w877 * w1086 + w83 * w1094
    w1111 = w1110 - w86 * w1098 - w858 * w1065 + w272 * w1102 + w258 * w1103 + w127 * w1104
    w1112 = w119 * w1105 + w104 * w1107 - w124 * w1109 + w129 * w1111 - w318 * w1061 - w348 * w1100 - w289 * w1059
    w1113 = w1112 / w353
    w1114 = w317 * w1061 + w347 * w1100 + w385 * w1113 + w288 * w1059
    w1115 = w315 * w1061 + w345 * w1100 + w375 * w1113 + w275 * w1059
    w1116 = w313 * w1061 + w343 * w1100 + w360 * w1113 + w261 * w1059
    w1117 = w311 * w1061 + w341 * w1100 + w354 * w1113 + w236 * w1059
    w1118 = w1051 - w231 * w1114 - w197 * w1115 - w183 * w1116 - w157 * w1117
    w1119 = w1055 - w232 * w1114 - w199 * w1115 - w186 * w1116 - w161 * w1117
    w1120 = w1009 / w235
    w1121 = w1005 - w305 * w1120
    w1122 = w1121 / w310
    w1123 = w1001 - (w330 * w1120 + w335 * w1122)
    w1124 = w1123 / w340
    w1125 = w289 * w1120 + w318 * w1122 + w348 * w1124 - w994
    w1126 = w1125 / w353
    w1127 = w797 * w1126 + w689 * w1113
    w1128 = 2 * w352
    w1129 = w798 / w353
    w1130 = w385 / w353
    w1131 = w375 / w353
    w1132 = w796 * w1126 + w670 * w1113
    w1133 = w360 / w353
    w1134 = w795 * w1126 + w663 * w1113
    w1135 = w354 / w353
    w1136 = w794 * w1126 + w651 * w1113
    w1137 = w1125 * w1129 + w1112 * (w690 / w353) + w1127 * w1130 + w1131 * w1132 + w1133 * w1134 + w1135 * w1136
    w1138 = 2 * w353
    w1139 = w1137 / w1138
    w1140 = w1127 / w353 - w1128 * w1139
    w1141 = 2 * w351
    w1142 = w1132 / w353 - w1139 * w1141
    w1143 = 2 * w350
    w1144 = w1134 / w353 - w1139 * w1143
    w1145 = 2 * w349
    w1146 = w1136 / w353 - w1139 * w1145
    w1147 = w798 * w1124 - w690 * w1100 - w347 * w1140 - w345 * w1142 - w343 * w1144 - w341 * w1146
    w1148 = w1140 + w347 * w1147
    w1149 = w1142 + w345 * w1147
    w1150 = w1144 + w343 * w1147
    w1151 = w1146 + w341 * w1147
    w1152 = w798 * w1122 - w690 * w1061 - w317 * w1148 - w315 * w1149 - w313 * w1150 - w311 * w1151
    w1153 = w1148 + w317 * w1152
    w1154 = w1149 + w315 * w1152
    w1155 = w1150 + w313 * w1152
    w1156 = w1151 + w311 * w1152
    w1157 = w798 * w1120 - w690 * w1059 - w288 * w1153 - w275 * w1154 - w261 * w1155 - w236 * w1156
    w1158 = w689 * w1100 - w797 * w1124 - w348 * w1140 + w346 * w1147
    w1159 = 2 * w339
    w1160 = w1000 / w340
    w1161 = w347 / w340
    w1162 = w345 / w340
    w1163 = w670 * w1100 - w796 * w1124 - w348 * w1142 + w344 * w1147
    w1164 = w343 / w340
    w1165 = w663 * w1100 - w795 * w1124 - w348 * w1144 + w342 * w1147
    w1166 = w341 / w340
    w1167 = w651 * w1100 - w794 * w1124 - w348 * w1146 + w319 * w1147
    w1168 = w1123 * w1160 + w1099 * (w691 / w340) + w1158 * w1161 + w1162 * w1163 + w1164 * w1165 + w1166 * w1167
    w1169 = 2 * w340
    w1170 = w1168 / w1169
    w1171 = w1158 / w340 - w1159 * w1170
    w1172 = 2 * w338
    w1173 = w1163 / w340 - w1170 * w1172
    w1174 = 2 * w337
    w1175 = w1165 / w340 - w1170 * w1174
    w1176 = 2 * w336
    w1177 = w1167 / w340 - w1170 * w1176
    w1178 = w1000 * w1122 + w691 * w1061 + w317 * w1171 + w315 * w1173 + w313 * w1175 + w311 * w1177
    w1179 = w1171 - w317 * w1178
    w1180 = w1173 - w315 * w1178
    w1181 = w1175 - w313 * w1178
    w1182 = w1177 - w311 * w1178
    w1183 = w1000 * w1120 + w691 * w1059 + w288 * w1179 + w275 * w1180 + w261 * w1181 + w236 * w1182
    w1184 = w689 * w1061 - w797 * w1122 - w318 * w1148 - w335 * w1171 - w334 * w1178 + w316 * w1152
    w1185 = 2 * w309
    w1186 = w1004 / w310
    w1187 = w317 / w310
    w1188 = w315 / w310
    w1189 = w670 * w1061 - w796 * w1122 - w318 * w1149 - w335 * w1173 - w333 * w1178 + w314 * w1152
    w1190 = w313 / w310
    w1191 = w663 * w1061 - w795 * w1122 - w318 * w1150 - w335 * w1175 - w332 * w1178 + w312 * w1152
    w1192 = w311 / w310
    w1193 = w651 * w1061 - w794 * w1122 - w335 * w1177 - w331 * w1178 - w318 * w1151 + w290 * w1152
    w1194 = w1121 * w1186 + w1060 * (w692 / w310) + w1184 * w1187 + w1188 * w1189 + w1190 * w1191 + w1192 * w1193
    w1195 = 2 * w310
    w1196 = w1194 / w1195
    w1197 = w1184 / w310 - w1185 * w1196
    w1198 = 2 * w308
    w1199 = w1189 / w310 - w1196 * w1198
    w1200 = 2 * w307
    w1201 = w1191 / w310 - w1196 * w1200
    w1202 = 2 * w306
    w1203 = w1193 / w310 - w1196 * w1202
    w1204 = w1004 * w1120 + w692 * w1059 + w288 * w1197 + w275 * w1199 + w261 * w1201 + w236 * w1203
    w1205 = w287 * w1157 - (w797 * w1120 + w330 * w1179 + w329 * w1183 + w289 * w1153 + w305 * w1197 + w304 * w1204)
    w1206 = w1205 + w689 * w1059
    w1207 = 2 * w234
    w1208 = w1008 / w235
    w1209 = w288 / w235
    w1210 = w275 / w235
    w1211 = w274 * w1157 - (w796 * w1120 + w330 * w1180 + w328 * w1183 + w289 * w1154 + w305 * w1199 + w303 * w1204)
    w1212 = w1211 + w670 * w1059
    w1213 = w261 / w235
    w1214 = w260 * w1157 - (w795 * w1120 + w330 * w1181 + w327 * w1183 + w289 * w1155 + w305 * w1201 + w302 * w1204)
    w1215 = w1214 + w663 * w1059
    w1216 = w236 / w235
    w1217 = w130 * w1157 - (w794 * w1120 + w330 * w1182 + w326 * w1183 + w305 * w1203 + w301 * w1204 + w289 * w1156)
    w1218 = w1217 + w651 * w1059
    w1219 = w1009 * w1208 + w1058 * (w693 / w235) + w1206 * w1209 + w1210 * w1212 + w1213 * w1215 + w1216 * w1218
    w1220 = 2 * w235
    w1221 = w1219 / w1220
    w1222 = w1206 / w235 - w1207 * w1221
    w1223 = 2 * w202
    w1224 = w1212 / w235 - w1221 * w1223
    w1225 = 2 * w189
    w1226 = w1215 / w235 - w1221 * w1225
    w1227 = 2 * w164
    w1228 = w1218 / w235 - w1221 * w1227
    w1229 = w773 * w1008 + w693 * w1055 + w232 * w1222 + w199 * w1224 + w186 * w1226 + w161 * w1228
    w1230 = w771 * w1008 + w693 * w1051 + w231 * w1222 + w197 * w1224 + w183 * w1226 + w157 * w1228
    w1231 = w491 * w1016 - w490 * w1020 + w489 * w1024 - w433 * w1028 - w1039 - w1037 * c11
    w1232 = w354 * w1126 - (w236 * w1120 + w311 * w1122 + w341 * w1124)
    w1233 = w523 * w1117 - w788 * w1232
    w1234 = w730 * w788 + w523 * w1231 + w1233
    w1235 = w777 * w1232 - w522 * w1117
    w1236 = w730 * w777 + w522 * w1231 - w1235
    w1237 = w754 * w1232 + w524 * w1117
    w1238 = w524 * w1231 - w730 * w754 + w1237
    w1239 = w3 * w1232 - w525 * w1117
    w1240 = w3 * w730 + w525 * w1231 - w1239
    w1241 = w1117 + w1231
    w1242 = w487 * w1016 - w486 * w1020 + w484 * w1024 - w436 * w1028 - w1042 - w1040 * c11
    w1243 = w1116 + w1242
    w1244 = w548 * w1241 - w545 * w1243
    w1245 = w375 * w1126 - (w275 * w1120 + w315 * w1122 + w345 * w1124)
    w1246 = w3 * w1245 - w525 * w1115
    w1247 = w482 * w1016 - w480 * w1020 + w479 * w1024 - w437 * w1028 - w1050 - w1044 * c11
    w1248 = w3 * w714 - w1246 + w525 * w1247
    w1249 = w754 * w1245 + w524 * w1115
    w1250 = w1249 - w714 * w754 + w524 * w1247
    w1251 = w27 * w1234 - w22 * w1236 - w23 * w1238 - w24 * w1240 + w545 * w1244 + w364 * w1248 + w27 * w1250
    w1252 = w777 * w1245 - w522 * w1115
    w1253 = w714 * w777 - w1252 + w522 * w1247
    w1254 = w523 * w1115 - w788 * w1245
    w1255 = w714 * w788 + w1254 + w523 * w1247
    w1256 = w1115 + w1247
    w1257 = w546 * w1243 - w548 * w1256
    w1258 = (w1251 + w24 * w1253 - w45 * w1255 - w546 * w1257) * c10
    w1259 = w360 * w1126 - (w261 * w1120 + w313 * w1122 + w343 * w1124)
    w1260 = w523 * w1116 - w788 * w1259
    w1261 = w722 * w788 + w523 * w1242 + w1260
    w1262 = w777 * w1259 - w522 * w1116
    w1263 = w722 * w777 + w522 * w1242 - w1262
    w1264 = w754 * w1259 + w524 * w1116
    w1265 = w524 * w1242 - w722 * w754 + w1264
    w1266 = w3 * w1259 - w525 * w1116
    w1267 = w3 * w722 + w525 * w1242 - w1266
    w1268 = w45 * w1261 - w24 * w1263 - w27 * w1265 - w364 * w1267 - w22 * w1234 + w37 * w1236 + w24 * w1238 + w45 * w1240
    w1269 = w545 * w1256 - w546 * w1241
    w1270 = w788 * c94
    w1271 = w777 * c94
    w1272 = w754 * c94
    w1273 = w3 * c94
    w1274 = (w1268 + w548 * w1257 - w545 * w1269) * c10 + (w45 * w1270 - w24 * w1271 + w27 * w1272 - w364 * w1273) * c93
    w1275 = w553 * w1118 - w554 * w1119 - w66 * w1229 - w67 * w1230 + 2 * (bar1_e2 * w1258) + 2 * (bar1_e3 * w1274)
    w1276 = w549 * w1243 - w547 * w1241 - w28 * w1257 + w362 * w1269
    w1277 = w3 * w525
    w1278 = w525 * w754 - w3 * w524
    w1279 = w525 * w788 + w3 * w523
    w1280 = w525 * w777 + w3 * w522
    w1281 = w362 * w1265 - w519 * w1272 - w28 * w1238 + bar1_e2_dot * w1276 - w472 * w1277 + (w24 * w1278 - w23 * w1277 + w22 * w1279 - w27 * w1280) * c8
    w1282 = w364 * w777 - w27 * w788 - w45 * w754 + w3 * w24
    w1283 = w24 * w777 - w45 * w788 - w37 * w754 + w3 * w22
    w1284 = (w515 * w1282 - w507 * w1283) * c4 - w516 * w1282 + w508 * w1283
    w1285 = w522 * w788 + w523 * w777
    w1286 = w524 * w754
    w1287 = w520 * w1270 - w776 * (w31 * (w31 * (w1 * bar1_e1))) * c112 - w513 * w788 + w778 * w1285 + w761 * w1286
    w1288 = w524 * w788 - w523 * w754
    w1289 = w522 * w754 - w524 * w777
    w1290 = w1287 + w759 * w1288 + (w45 * w1286 + w27 * w1288 + w364 * w1289) * c9 - w518 * w754 + w26 * w1261
    w1291 = w622 * w1241 - w362 * w1244 - w549 * w1256 + w26 * w1257
    w1292 = w28 * w1244 - w622 * w1243 + w547 * w1256 - w26 * w1269
    w1293 = w1290 + w26 * w1240 - w362 * w1248 - w28 * w1255 + bar1_e3_dot * w1291 + bar1_e0_dot * w1292 + w473 * w1278
    w1294 = w27 * w777 - w22 * w788 - w24 * w754 + w3 * w23
    w1295 = w512 * w1282 - w508 * w1294 + (w507 * w1294 - w511 * w1282) * c7
    w1296 = w516 * w1294 - w512 * w1283 + (w511 * w1283 - w515 * w1294) * c5
    w1297 = w1275 + 2 * (w1281 + w3 * w517 + bar1_e3_dot * w1284) + (w1293 + w471 * w1279 + bar1_e0_dot * w1295 + bar1_e2_dot * w1296) * -2.0
    w1298 = w748 * w1008 + w693 * w1053 + w230 * w1222 + w195 * w1224 + w181 * w1226 + w152 * w1228
    w1299 = w1053 - w230 * w1114 - w195 * w1115 - w181 * w1116 - w152 * w1117
    w1300 = w201 * w1224 - (w750 * w1008 + w693 * w1057 + w233 * w1222) + w188 * w1226 + w163 * w1228
    w1301 = w1057 + (w201 * w1115 - w233 * w1114 + w188 * w1116 + w163 * w1117)
    w1302 = w67 * w1298 - w553 * w1299 + w66 * w1300 - w554 * w1301 + 2 * (bar1_e3 * w1258) + 2 * -(bar1_e2 * w1274)
    w1303 = w522 * w777
    w1304 = (w45 * w1285 - w24 * w1303) * c6 - w778 * w1303 - w520 * w1271 + w513 * w777 + w760 * w1286 + (w24 * w1286 + w22 * w1288 + w27 * w1289) * c8
    w1305 = w1304 + w759 * w1289 - w517 * w754 - w26 * w1263 + w362 * w1267 + w26 * w1238 - w28 * w1240 - w362 * w1250
    w1306 = w1305 + w28 * w1253 + bar1_e2_dot * w1291 + bar1_e3_dot * w1276 + bar1_e1_dot * w1292 - w473 * w1277
    w1307 = w1306 + w472 * w1278 + (w45 * w1278 - w24 * w1277 + w27 * w1279 - w364 * w1280) * c9 - w471 * w1280
    w1308 = w1307 + w519 * w1273 + w3 * w518 + bar1_e1_dot * w1295 + bar1_e2_dot * w1284 + bar1_e3_dot * w1296
    w1309 = w22 * w1263 - w27 * w1261 + w23 * w1265 + w24 * w1267 - w548 * w1244 - w45 * w1248 - w24 * w1250 - w37 * w1253
    w1310 = (w1309 + w22 * w1255 + w546 * w1269) * c10 + (w22 * w1271 - w27 * w1270 - w23 * w1272 + w24 * w1273) * c93
    w1311 = 2 * -w1310
    w1312 = w67 * w1229 - (w553 * w1119 + w554 * w1118) - w66 * w1230 + w23 * w1258 - w24 * w1274 + w364 * w1311
    w1313 = (w27 * w1285 - w364 * w1303) * c9 - w780 * w1303 + w518 * w777 + w761 * w1289 - w26 * w1267 + w28 * w1248
    w1314 = w779 * w1285 - (w776 * (w31 * (w31 * (w1 * bar1_e2))) * c113 + w517 * w788) + w519 * w1271 + w760 * w1288
    w1315 = w1314 + w362 * w1263 - w26 * w1234 - w28 * w1236 + w362 * w1255 + bar1_e0_dot * w1291 + bar1_e1_dot * w1276
    w1316 = w1315 - w471 * w1277 + w472 * w1279 + (w37 * w1278 - w22 * w1277 + w45 * w1279 - w24 * w1280) * c6
    w1317 = w1312 + 2 * (w1313 + bar1_e3_dot * w1292 - w473 * w1280 - w520 * w1273 + bar1_e1_dot * w1296) + (w1316 + bar1_e3_dot * w1295 + w3 * w513 + bar1_e0_dot * w1284) * -2.0
    w1318 = w67 * w1300 - (w554 * w1299 + w66 * w1298) + w553 * w1301 + w24 * w1258 + w23 * w1274 + w37 * w1311
    w1319 = w759 * w1286 + (w37 * w1286 + w45 * w1288 + w24 * w1289) * c6 - w513 * w754 + w26 * w1236 - w362 * w1253
    w1320 = w780 * w1285 - (w776 * (w31 * (w31 * (w1 * bar1_e3))) * c114 + w519 * w1270 + w518 * w788) - w779 * w1303
    w1321 = w1320 + (w22 * w1285 - w27 * w1303) * c8 + w517 * w777 + w761 * w1288 + w760 * w1289 + w520 * w1272
    w1322 = w1321 - w362 * w1261 - w26 * w1265 + w28 * w1234 + w28 * w1250 + bar1_e0_dot * w1276 + bar1_e2_dot * w1292
    w1323 = w1318 + 2 * (w1319 + bar1_e1_dot * w1291 + w471 * w1278 + bar1_e2_dot * w1295) + (w1322 + w473 * w1279 - w472 * w1280 + bar1_e1_dot * w1284 + bar1_e0_dot * w1296) * -2.0
    w1324 = w1197 - w288 * w1204
    w1325 = w1199 - w275 * w1204
    w1326 = w1201 - w261 * w1204
    w1327 = w1203 - w236 * w1204
    w1328 = w746 * w1004 - w692 * w1048 + w228 * w1324 - w190 * w1325 - w170 * w1326 - w133 * w1327
    w1329 = w745 * w1004 - w692 * w1047 + w227 * w1324 - w193 * w1325 - w179 * w1326 - w145 * w1327
    w1330 = w744 * w1004 - w692 * w1046 + w226 * w1324 - w192 * w1325 - w178 * w1326 - w141 * w1327
    w1331 = w692 * w1049 - w747 * w1004 - w229 * w1324 + w194 * w1325 + w180 * w1326 + w150 * w1327
    w1332 = w1049 + w229 * w1114 - w194 * w1115 - w180 * w1116 - w150 * w1117
    w1333 = w190 * w1115 - (w1048 + w228 * w1114) + w170 * w1116 + w133 * w1117
    w1334 = w193 * w1115 - (w1047 + w227 * w1114) + w179 * w1116 + w145 * w1117
    w1335 = w294 * w1328 + w295 * w1329 + w296 * w1330 + w292 * w1331 + w580 * w1332 - w582 * w1333 + w581 * w1334
    w1336 = w192 * w1115 - (w1046 + w226 * w1114) + w178 * w1116 + w141 * w1117
    w1337 = w541 * w1040
    w1338 = w1115 - w1050
    w1339 = w1117 - w1039
    w1340 = w570 * w1338 - w572 * w1339
    w1341 = w1116 - w1042
    w1342 = w569 * w1339 - w570 * w1341
    w1343 = w65 * w1246 - w5 * w1254 + w558 * w1115 + w68 * w1224
    w1344 = w1343 - (w713 * w1024 + w694 * w1050)
    w1345 = w5 * w1252 - w65 * w1249 - w629 * w1115 + w162 * w1224
    w1346 = w713 * w1020 - w695 * w1050 - w1345
    w1347 = w65 * w1252 + w5 * w1249 + w627 * w1115 + w158 * w1224
    w1348 = w1347 - (w713 * w1016 + w696 * w1050)
    w1349 = w65 * w1254 + w5 * w1246 - w625 * w1115 + w153 * w1224
    w1350 = w713 * w1028 - w697 * w1050 - w1349
    w1351 = w65 * w1266 - w5 * w1260 + w558 * w1116 + w68 * w1226
    w1352 = w1351 - (w721 * w1024 + w694 * w1042)
    w1353 = w572 * w1340 - w569 * w1342 - w51 * w1344 - w159 * w1346 - w52 * w1348 - w134 * w1350 + w58 * w1352
    w1354 = w5 * w1262 - w65 * w1264 - w629 * w1116 + w162 * w1226
    w1355 = w721 * w1020 - w695 * w1042 - w1354
    w1356 = w65 * w1262 + w5 * w1264 + w627 * w1116 + w158 * w1226
    w1357 = w1356 - (w721 * w1016 + w696 * w1042)
    w1358 = w65 * w1260 + w5 * w1266 - w625 * w1116 + w153 * w1226
    w1359 = w721 * w1028 - w697 * w1042 - w1358
    w1360 = w1028 * c94 - w717 * w1028 - w697 * w1040
    w1361 = w717 * w1016 - w1016 * c94 - w696 * w1040
    w1362 = w1020 * c94 - w717 * w1020 - w695 * w1040
    w1363 = w717 * w1024 - w1024 * c94 - w694 * w1040
    w1364 = w551 * w1028 + w697 * w1044
    w1365 = w551 * w1016 - w696 * w1044
    w1366 = w551 * w1020 + w695 * w1044
    w1367 = w52 * w1360 + w155 * w1361 + w51 * w1362 + w58 * w1363 + w134 * w1364 - w52 * w1365 + w159 * w1366
    w1368 = w551 * w1024 - w694 * w1044
    w1369 = w534 * w1037 + (w1353 + w51 * w1355 + w155 * w1357 + w52 * w1359) * c15 + (w1367 - w51 * w1368) * c14
    w1370 = w1337 + w1369
    w1371 = w541 * w1044
    w1372 = w544 * w1037
    w1373 = w1371 - w1372
    w1374 = w695 * w1020
    w1375 = w696 * w1016
    w1376 = w695 * w1016 - w696 * w1020
    w1377 = w694 * w1016 + w696 * w1024
    w1378 = w733 * w1020 - w495 * w1374 + w500 * w1375 + w499 * w1376 - w735 * w1016 + (w52 * w1375 + w58 * w1376 + w51 * w1377) * c27
    w1379 = w695 * w1024 - w694 * w1020
    w1380 = w697 * w1028
    w1381 = w697 * w1016 - w696 * w1028
    w1382 = w697 * w1020 + w695 * w1028
    w1383 = w697 * w1024 - w694 * w1028
    w1384 = w1378 + (w134 * w1379 - w52 * w1374) * c25 - w440 * w1380 + w439 * w1381 - w438 * w1382 + (w134 * w1381 - w52 * w1380 - w54 * w1382 + w58 * w1383) * c28
    w1385 = w725 * w1028 + w697 * w1037
    w1386 = w725 * w1016 - w696 * w1037
    w1387 = w1384 + w736 * w1028 + w431 * w1385 + w429 * w1386 + w434 * w1360 - w429 * w1362 - w434 * w1365 - w431 * w1366
    w1388 = w572 * w1341 - w569 * w1338
    w1389 = w653 * w1341 - w62 * w1388 - w573 * w1339 + w174 * w1340
    w1390 = w573 * w1338 - w571 * w1341 - w57 * w1340 + w62 * w1342
    w1391 = w57 * w1388 - w653 * w1338 + w571 * w1339 - w174 * w1342
    w1392 = w1387 + bar2_e3_dot * w1389 + bar2_e1_dot * w1390 + bar2_e2_dot * w1391 + w62 * w1346 - w174 * w1348
    w1393 = w65 * w1235 + w5 * w1237 + w627 * w1117 + w158 * w1228
    w1394 = w1393 - (w729 * w1016 + w696 * w1039)
    w1395 = w65 * w1233 + w5 * w1239 - w625 * w1117 + w153 * w1228
    w1396 = w729 * w1028 - w697 * w1039 - w1395
    w1397 = w54 * w1020 - w134 * w1016 - w58 * w1024 + w52 * w1028
    w1398 = w52 * w1020 - w159 * w1016 - w134 * w1024 + w51 * w1028
    w1399 = w724 * w1037 + w716 * w1040 + w543 * w1044
    w1400 = w723 * w1037 + w715 * w1040 + w537 * w1044
    w1401 = (w528 * w1397 - w532 * w1398) * c23 - w734 * w1397 + w731 * w1398 - w533 * w1399 - w529 * w1400
    w1402 = w58 * w1020 - w52 * w1016 - w51 * w1024 + w155 * w1028
    w1403 = w173 * w1037 + w61 * w1040 + w56 * w1044
    w1404 = w734 * w1402 - w732 * w1398 + (w540 * w1398 - w528 * w1402) * c24 + w533 * w1403 + (w532 * w1403 - w540 * w1399) * c14
    w1405 = w1392 - w57 * w1355 + w174 * w1359 + w57 * w1394 - w62 * w1396 + bar2_e2_dot * w1401 + bar2_e3_dot * w1404
    w1406 = w732 * w1397 - w731 * w1402 + (w532 * w1402 - w540 * w1397) * c26 + w529 * w1403 + (w528 * w1403 - w540 * w1400) * c14
    w1407 = w1335 + w578 * w1336 + 2 * -(bar2_e3 * w1370) + 2 * (bar2_e2 * w1373) + 2 * (w1405 + bar2_e1_dot * w1406)
    w1408 = w544 * w1040
    w1409 = w725 * w1020 + w695 * w1037
    w1410 = w725 * w1024 - w694 * w1037
    w1411 = w52 * w1386 - w134 * w1385 - w159 * w1409 + w51 * w1410 - w54 * w1360 - w58 * w1361 - w52 * w1362
    w1412 = w65 * w1239 - w5 * w1233 + w558 * w1117 + w68 * w1228
    w1413 = w1412 - (w729 * w1024 + w694 * w1039)
    w1414 = w569 * w1388 - w570 * w1340 - w134 * w1352 - w52 * w1355 - w58 * w1357 - w54 * w1359 + w51 * w1413
    w1415 = w5 * w1235 - w65 * w1237 - w629 * w1117 + w162 * w1228
    w1416 = w729 * w1020 - w695 * w1039 - w1415
    w1417 = (w1411 - w134 * w1363) * c14 + (w1414 + w159 * w1416 + w52 * w1394 + w134 * w1396) * c15 + w534 * w1044
    w1418 = w1408 + w1417
    w1419 = w1021 + (w1022 + w1023)
    w1420 = w777 * w1297 - w788 * (w1302 + 2 * w1308) - w754 * w1317 + w3 * w1323 - (w1407 + 2 * (bar2_e1 * w1418)) * w1419
    w1421 = w295 * w1330 - (w292 * w1328 + w296 * w1329) + w294 * w1331 - w582 * w1332 - w580 * w1333 - w578 * w1334
    w1422 = w1369 - w1337
    w1423 = w544 * w1044
    w1424 = w570 * w1342 - w572 * w1388 + w134 * w1344 + w52 * w1346 + w58 * w1348 + w54 * w1350 - w58 * w1413
    w1425 = w52 * w1385 - w155 * w1386 + w51 * w1409 - w58 * w1410 - w54 * w1364 + w58 * w1365 - w52 * w1366 + w134 * w1368
    w1426 = w534 * w1040 + (w1424 - w51 * w1416 - w155 * w1394 - w52 * w1396) * c15 + w1425 * c14
    w1427 = (w52 * w1381 - w155 * w1380 - w58 * w1382 + w51 * w1383) * c27 - w439 * w1380 + w735 * w1028 - w431 * w1386
    w1428 = 2 * (w1427 + w434 * w1361 + bar2_e2_dot * w1389 + w174 * w1357 - w62 * w1394 + bar2_e3_dot * w1401)
    w1429 = w1371 + w1372
    w1430 = w1421 + w581 * w1336 + 2 * (bar2_e2 * w1422) + w155 * (2 * (w1423 - w1426)) + w1428 + 2 * -(bar2_e3 * w1429)
    w1431 = (w134 * w1375 + w54 * w1376 + w58 * w1377) * c28 + (w501 * w1375 - w736 * w1016 + w1024 * (bar2_e1 * w694) * c115)
    w1432 = w495 * w1379 + (w499 * w1377 + w1431) - w733 * w1024 + w440 * w1381 + w438 * w1383 - w429 * w1385
    w1433 = w1432 - w429 * w1363 + w434 * w1364 + bar2_e0_dot * w1390 + bar2_e3_dot * w1391 + w62 * w1344 - w174 * w1350
    w1434 = (w1433 - w57 * w1352 + w57 * w1396 + w431 * w1368 + bar2_e2_dot * w1404 + bar2_e0_dot * w1406) * -2.0
    w1435 = w1017 + (w1018 - w1019)
    w1436 = w296 * w1328 - w292 * w1329 - w294 * w1330 + w295 * w1331 + w581 * w1332 + w578 * w1333 - w580 * w1334
    w1437 = w541 * w1037
    w1438 = w736 * w1020 - w497 * w1374 + w501 * w1376 + (w58 * w1379 - w54 * w1374) * c28 - w440 * w1382 - w429 * w1360
    w1439 = 2 * (w1438 - w431 * w1364 + bar2_e3_dot * w1390 + w62 * w1350 - w57 * w1359 + bar2_e1_dot * w1404)
    w1440 = w496 * w1379 + (w500 * w1377 + w1024 * (bar2_e2 * w694) * c116) - w735 * w1024 - w438 * w1380 + w439 * w1383
    w1441 = w1440 + (w159 * w1381 - w51 * w1380 - w52 * w1382 + w134 * w1383) * c25 + w733 * w1028 + w431 * w1409
    w1442 = w1441 + w429 * w1410 + w434 * w1362 + bar2_e1_dot * w1389 + bar2_e0_dot * w1391 - w174 * w1344 + w174 * w1355
    w1443 = (w1442 + w57 * w1413 - w62 * w1416 - w434 * w1368 + bar2_e0_dot * w1401 + bar2_e3_dot * w1406) * -2.0
    w1444 = w1417 - w1408
    w1445 = w1436 + w582 * w1336 + w155 * w1422 + w54 * (2 * (w1423 + w1437)) + w52 * w1373 + w1439 + w1443 + 2 * (bar2_e3 * w1444)
    w1446 = w1013 + (w1014 + w1015)
    w1447 = w294 * w1329 - w295 * w1328 - w292 * w1330 + w296 * w1331 + w578 * w1332 - w581 * w1333 - w582 * w1334
    w1448 = w497 * w1379 + (w501 * w1377 + (w500 * w1376 + (w735 * w1020 - w496 * w1374 + w1024 * (bar2_e3 * w694) * c117)))
    w1449 = (w51 * w1379 - w58 * w1374) * c27 + w1448 - w736 * w1024 - w439 * w1382 + w440 * w1383 - w431 * w1410
    w1450 = w1449 - w429 * w1361 + w434 * w1363 + w431 * w1365 + bar2_e0_dot * w1389 + bar2_e2_dot * w1390 + w62 * w1348
    w1451 = (w1450 + w174 * w1352 - w57 * w1357 - w62 * w1413 + bar2_e1_dot * w1401 + bar2_e0_dot * w1404) * -2.0
    w1452 = w499 * w1375 - w733 * w1016 + (w159 * w1375 + w52 * w1376 + w134 * w1377) * c25 + w438 * w1381 - w429 * w1409
    w1453 = 2 * (w1452 + w434 * w1366 + bar2_e1_dot * w1391 - w174 * w1346 + w57 * w1416 + bar2_e2_dot * w1406)
    w1454 = w1447 - w580 * w1336 - w52 * w1370 + w159 * (2 * (w1437 - w1426)) - w155 * w1429 + w1451 + w1453 + w54 * w1444
    w1455 = w1025 + (w1027 - w1026)
    w1456 = w707 * w1038
    w1457 = w214 * w1114
    w1458 = w217 * w1114
    w1459 = 2 * -(w671 * w1114) + w563 * w1457 - w561 * w1458
    w1460 = w209 * w1114
    w1461 = 2 * -(w674 * w1114) + w561 * w1460 - w567 * w1457
    w1462 = w1179 - w288 * w1183
    w1463 = w1153 + w288 * w1157
    w1464 = w649 * w1114 - w129 * w1463
    w1465 = w119 * w1463 - w645 * w1114
    w1466 = w325 * w1462 + w86 * w1464 + w83 * w1465 - w621 * w1114
    w1467 = w124 * w1463 + w648 * w1114
    w1468 = w104 * w1463 - w647 * w1114
    w1469 = w324 * w1462 + w86 * w1467 + w83 * w1468 + w619 * w1114
    w1470 = w323 * w1462 - w83 * w1467 + w86 * w1468 - w617 * w1114
    w1471 = w86 * w1465 - (w322 * w1462 + w83 * w1464) - w614 * w1114
    w1472 = w109 * w1466 - w76 * w1469 + w70 * w1470 + w72 * w1471
    w1473 = w385 * w1126 - (w288 * w1120 + w317 * w1122 + w347 * w1124)
    w1474 = w523 * w1114 - w788 * w1473
    w1475 = w3 * w1473 - w525 * w1114
    w1476 = w5 * w1474 - w65 * w1475 - w558 * w1114 - w68 * w1222
    w1477 = w777 * w1473 - w522 * w1114
    w1478 = w754 * w1473 + w524 * w1114
    w1479 = w5 * w1477 - w65 * w1478 - w629 * w1114 + w162 * w1222
    w1480 = w65 * w1477 + w5 * w1478 + w627 * w1114 + w158 * w1222
    w1481 = w65 * w1474 + w5 * w1475 - w625 * w1114 + w153 * w1222
    w1482 = w596 * w1114 - w297 * w1324 + w142 * w1476 - w147 * w1479 + w8 * w1480 - w151 * w1481
    w1483 = w300 * w1324 - w594 * w1114 + w147 * w1476 + w142 * w1479 - w151 * w1480 - w8 * w1481
    w1484 = w299 * w1324 - w592 * w1114 + w8 * w1476 - w151 * w1479 - w142 * w1480 + w147 * w1481
    w1485 = w298 * w1324 - w590 * w1114 + w151 * w1476 + w8 * w1479 + w147 * w1480 + w142 * w1481
    w1486 = w148 * w1482 + w14 * w1483 + w144 * w1484 + w17 * w1485
    w1487 = w1472 - w1486
    w1488 = w138 * w1482 + w17 * w1483 + w148 * w1484 + w15 * w1485
    w1489 = w105 * w1466 - w72 * w1469 + w109 * w1470 + w207 * w1471
    w1490 = w1488 - w1489
    w1491 = w563 * w1459 - (w705 * w1041 + w567 * w1461) - w675 * w1114 + w217 * w1487 + w209 * w1490
    w1492 = w1456 + w1491
    w1493 = w1036 * c94 - w720 * w1036 - w712 * w1041
    w1494 = w1034 * c94 - w720 * w1034 - w711 * w1041
    w1495 = w1032 * c94 - w720 * w1032 - w710 * w1041
    w1496 = w1030 * c94 - w720 * w1030 - w709 * w1041
    w1497 = w708 * w1036 + w712 * w1045
    w1498 = w708 * w1034 + w711 * w1045
    w1499 = w708 * w1032 + w710 * w1045
    w1500 = w17 * w1493 + w144 * w1494 + w14 * w1495 + w148 * w1496 + w138 * w1497 + w17 * w1498 + w9 * w1499
    w1501 = w708 * w1030 + w709 * w1045
    w1502 = w563 * w1115 - w567 * w1117
    w1503 = w561 * w1117 - w563 * w1116
    w1504 = w297 * w1325 - w596 * w1115 + w142 * w1343 + w147 * w1345 - w8 * w1347 + w151 * w1349
    w1505 = w592 * w1115 - w299 * w1325 + w8 * w1343 + w151 * w1345 + w142 * w1347 - w147 * w1349
    w1506 = w590 * w1115 - w298 * w1325 + w151 * w1343 - w8 * w1345 - w147 * w1347 - w142 * w1349
    w1507 = w594 * w1115 - w300 * w1325 + w147 * w1343 - w142 * w1345 + w151 * w1347 + w8 * w1349
    w1508 = w297 * w1326 - w596 * w1116 + w142 * w1351 + w147 * w1354 - w8 * w1356 + w151 * w1358
    w1509 = w567 * w1502 - w561 * w1503 - w14 * w1504 - w17 * w1505 - w138 * w1506 - w9 * w1507 + w148 * w1508
    w1510 = w592 * w1116 - w299 * w1326 + w8 * w1351 + w151 * w1354 + w142 * w1356 - w147 * w1358
    w1511 = w590 * w1116 - w298 * w1326 + w151 * w1351 - w8 * w1354 - w147 * w1356 - w142 * w1358
    w1512 = w594 * w1116 - w300 * w1326 + w147 * w1351 - w142 * w1354 + w151 * w1356 + w8 * w1358
    w1513 = w703 * w1038 + (w1500 + w14 * w1501) * c21 + (w1509 + w144 * w1510 + w17 * w1511 + w14 * w1512) * c63
    w1514 = 2 * -(w672 * w1114) - w563 * w1460 + w567 * w1458
    w1515 = w14 * w1482 + w9 * w1483 + w17 * w1484 + w138 * w1485
    w1516 = w76 * w1466 - w69 * w1469 + w72 * w1470 + w105 * w1471
    w1517 = w1515 - w1516
    w1518 = w1489 - w1488
    w1519 = w561 * w1461 - w705 * w1045 - w563 * w1514 - w676 * w1114 + w217 * w1517 + w214 * w1518
    w1520 = w1513 - w1519
    w1521 = w710 * w1032
    w1522 = w710 * w1030 + w709 * w1032
    w1523 = w711 * w1034
    w1524 = w711 * w1032 + w710 * w1034
    w1525 = w711 * w1030 + w709 * w1034
    w1526 = w740 * w1032 - (w411 * w1521 + (w17 * w1521 + w138 * w1522) * c31) - w419 * w1523 - w418 * w1524 - (w17 * w1523 + w148 * w1524 + w14 * w1525) * c33
    w1527 = w712 * w1036
    w1528 = w712 * w1034 + w711 * w1036
    w1529 = w712 * w1032 + w710 * w1036
    w1530 = w712 * w1030 + w709 * w1036
    w1531 = w1526 + w742 * w1034 - w425 * w1527 - w424 * w1528 - w423 * w1529 - (w17 * w1527 + w138 * w1528 + w15 * w1529 + w148 * w1530) * c34
    w1532 = w728 * w1036 + w712 * w1038
    w1533 = w728 * w1034 + w711 * w1038
    w1534 = w1531 + w743 * w1036 + w20 * w1532 - w13 * w1533 + w401 * w1493 - w13 * w1495 + w401 * w1498 - w20 * w1499
    w1535 = w14 * w1030 + w148 * w1032 + w17 * w1034 + w144 * w1036
    w1536 = w138 * w1030 + w17 * w1032 + w9 * w1034 + w14 * w1036
    w1537 = w727 * w1038 + w719 * w1041 + w706 * w1045
    w1538 = w220 * w1038 + w205 * w1041 + w211 * w1045
    w1539 = w741 * w1535 - w739 * w1536 + (w699 * w1536 - w701 * w1535) * c30 - w700 * w1537 - w702 * w1538
    w1540 = w148 * w1030 + w15 * w1032 + w138 * w1034 + w17 * w1036
    w1541 = w167 * w1038 + w19 * w1041 + w12 * w1045
    w1542 = w739 * w1540 - w738 * w1535 + (w704 * w1535 - w699 * w1540) * c32 + w702 * w1541 + (w701 * w1541 - w704 * w1538) * c21
    w1543 = (w701 * w1540 - w704 * w1536) * c29 - w741 * w1540 + w738 * w1536 + w700 * w1541 + (w699 * w1541 - w704 * w1537) * c21
    w1544 = w567 * w1116 - w561 * w1115
    w1545 = w678 * w1458 - (w680 * w1457 + w205 * w1461) + w220 * w1514 + w652 * w1116 - w132 * w1544 - w568 * w1117
    w1546 = w1545 + w168 * w1502
    w1547 = w677 * w1457 - w678 * w1460 - w211 * w1514 + w205 * w1459 + w568 * w1115 - w564 * w1116 - w131 * w1502
    w1548 = w1547 + w132 * w1503
    w1549 = w1534 + bar3_e3_dot * w1539 + bar3_e1_dot * w1542 + bar3_e2_dot * w1543 + bar3_e3_dot * w1546 + bar3_e1_dot * w1548
    w1550 = w680 * w1460 + w211 * w1461 - w677 * w1458 - w220 * w1459 - w652 * w1115 + w131 * w1544 + w564 * w1117
    w1551 = w1550 - w168 * w1503
    w1552 = w1549 + bar3_e2_dot * w1551 + w216 * w1483 + w222 * w1484 + w225 * w1485 - w168 * w1505 + w132 * w1507
    w1553 = w592 * w1117 - w299 * w1327 + w8 * w1412 + w151 * w1415 + w142 * w1393 - w147 * w1395
    w1554 = w590 * w1117 - w298 * w1327 + w151 * w1412 - w8 * w1415 - w147 * w1393 - w142 * w1395
    w1555 = 2 * (bar3_e3 * w1492) + 2 * (bar3_e2 * w1520) + 2 * (w1552 + w168 * w1511 - w131 * w1512 + w131 * w1553 - w132 * w1554)
    w1556 = w707 * w1045
    w1557 = w728 * w1032 + w710 * w1038
    w1558 = w728 * w1030 + w709 * w1038
    w1559 = w17 * w1532 + w144 * w1533 + w14 * w1557 + w148 * w1558 - w15 * w1497 - w148 * w1498 - w17 * w1499
    w1560 = w297 * w1327 - w596 * w1117 + w142 * w1412 + w147 * w1415 - w8 * w1393 + w151 * w1395
    w1561 = w563 * w1503 - w567 * w1544 + w138 * w1504 + w148 * w1505 + w15 * w1506 + w17 * w1507 - w148 * w1560
    w1562 = w594 * w1117 - w300 * w1327 + w147 * w1412 - w142 * w1415 + w151 * w1393 + w8 * w1395
    w1563 = w703 * w1041 + (w1559 - w138 * w1501) * c21 + (w1561 - w144 * w1553 - w17 * w1554 - w14 * w1562) * c63
    w1564 = w1556 + w1563
    w1565 = w8 * w1446 - (w142 * w1419 + w147 * w1435) - w151 * w1455 - w1029
    w1566 = w1420 + (w1430 + w1434 + w52 * w1418) * w1435 - w1445 * w1446 + w1454 * w1455 + (w1555 + 2 * -(bar3_e1 * w1564)) * w1565
    w1567 = w1491 - w1456
    w1568 = w1513 + w1519
    w1569 = w742 * w1036 - (w424 * w1527 + (w144 * w1527 + w17 * w1528 + w148 * w1529 + w14 * w1530) * c33) + w20 * w1533
    w1570 = w1569 + w401 * w1494 + bar3_e3_dot * w1543 + bar3_e2_dot * w1546 + w225 * w1484 + w168 * w1510 - w132 * w1553
    w1571 = w740 * w1030 - w1030 * (bar3_e1 * w709) * c118 - w411 * w1522 - w420 * w1523 - (w138 * w1523 + w15 * w1524 + w148 * w1525) * c34
    w1572 = w1571 - w418 * w1525 + w743 * w1034 - w425 * w1528 - w423 * w1530 - w13 * w1532 - w13 * w1496 + w401 * w1497
    w1573 = w1572 - w20 * w1501 + bar3_e2_dot * w1539 + bar3_e0_dot * w1542 + bar3_e0_dot * w1548 + bar3_e3_dot * w1551
    w1574 = (w1573 + w216 * w1482 + w222 * w1485 + w132 * w1504 - w168 * w1506 - w131 * w1508 + w131 * w1554) * -2.0
    w1575 = w707 * w1041
    w1576 = w138 * w1532 + w17 * w1533 + w9 * w1557 + w14 * w1558 + w15 * w1493 + w148 * w1494 + w17 * w1495 + w138 * w1496
    w1577 = w561 * w1544 - w563 * w1502 - w138 * w1508 - w148 * w1510 - w15 * w1511 - w17 * w1512 + w14 * w1560
    w1578 = w703 * w1045 - w1576 * c21 + (w1577 + w17 * w1553 + w138 * w1554 + w9 * w1562) * c63
    w1579 = 2 * (bar3_e2 * w1567) + 2 * (bar3_e3 * w1568) + 2 * w1570 + w1574 - w17 * w1564 + w144 * (2 * (w1575 - w1578))
    w1580 = w1031 + (w142 * w1435 - w147 * w1419 - w151 * w1446 - w8 * w1455)
    w1581 = w743 * w1032 - (w413 * w1521 + (w15 * w1521 + w148 * w1522) * c34) - w420 * w1524 - w425 * w1529 - w13 * w1493
    w1582 = w1581 - w20 * w1497 + bar3_e1_dot * w1539 + bar3_e3_dot * w1548 + w216 * w1485 + w132 * w1506 - w131 * w1511
    w1583 = w1563 - w1556
    w1584 = w742 * w1030 - w1030 * (bar3_e2 * w709) * c119 - w412 * w1522 - w419 * w1525 - w423 * w1527 - w424 * w1530
    w1585 = w1584 - (w14 * w1527 + w9 * w1528 + w17 * w1529 + w138 * w1530) * c31 + w740 * w1036 + w20 * w1557
    w1586 = w1585 - w13 * w1558 + w401 * w1495 + w401 * w1501 + bar3_e3_dot * w1542 + bar3_e0_dot * w1543 + bar3_e1_dot * w1546
    w1587 = w1586 + bar3_e0_dot * w1551 + w222 * w1482 + w225 * w1483 - w168 * w1504 + w168 * w1512 + w131 * w1560
    w1588 = w1486 - w1472
    w1589 = w1516 - w1515
    w1590 = w567 * w1514 - w705 * w1038 - w561 * w1459 - w673 * w1114 + w214 * w1588 + w209 * w1589
    w1591 = w144 * w1567 + 2 * w1582 + w17 * w1520 + 2 * (bar3_e3 * w1583) + (w1587 - w132 * w1562) * -2.0 + w15 * (2 * -(w1578 + w1590))
    w1592 = w1033 + (w147 * w1455 - (w8 * w1419 + w151 * w1435 + w142 * w1446))
    w1593 = w743 * w1030 - w1030 * (bar3_e3 * w709) * c120 - w412 * w1521 - w413 * w1522 - (w148 * w1521 + w14 * w1522) * c33
    w1594 = w1593 + w742 * w1032 - w419 * w1524 - w420 * w1525 - w424 * w1529 - w425 * w1530 + w20 * w1558 - w13 * w1494
    w1595 = w1594 + w401 * w1496 - w20 * w1498 + bar3_e0_dot * w1539 + bar3_e1_dot * w1543 + bar3_e0_dot * w1546
    w1596 = w1595 + bar3_e2_dot * w1548 + w225 * w1482 + w216 * w1484 + w132 * w1505 + w168 * w1508 - w131 * w1510
    w1597 = w9 * (2 * (w1575 - w1590)) + w17 * w1492 + w144 * w1568 + (w1596 - w132 * w1560) * -2.0 + w15 * w1583
    w1598 = w740 * w1034 - (w418 * w1523 + (w9 * w1523 + w17 * w1524 + w138 * w1525) * c31) - w423 * w1528 - w13 * w1557
    w1599 = w1598 + w401 * w1499 + bar3_e2_dot * w1542 + bar3_e1_dot * w1551 + w222 * w1483 - w168 * w1507 + w131 * w1562
    w1600 = w1035 + (w8 * w1435 - w151 * w1419 + w147 * w1446 + w142 * w1455)
    w1601 = w954 * w1083
    w1602 = w945 * w1067 - w944 * w1083
    w1603 = w945 * w1077 + w943 * w1083
    w1604 = w945 * w1073 + w942 * w1083
    w1605 = w945 * w1081 + w941 * w1083
    w1606 = w1077 * c94 - w946 * w1077 - w943 * w1085
    w1607 = w1073 * c94 - w946 * w1073 - w942 * w1085
    w1608 = w1081 * c94 - w946 * w1081 - w941 * w1085
    w1609 = w105 * w1602 - (w72 * w1603 + w69 * w1604 + w76 * w1605 + w109 * w1606 + w72 * w1607 + w105 * w1608)
    w1610 = w946 * w1067 - w944 * w1085 - w1067 * c94
    w1611 = w1116 - w1090
    w1612 = w1115 - w1089
    w1613 = w605 * w1611 - w599 * w1612
    w1614 = w1155 + w261 * w1157
    w1615 = w645 * w1116 - w119 * w1614
    w1616 = w1181 - w261 * w1183
    w1617 = w649 * w1116 - w129 * w1614
    w1618 = w83 * w1615 - (w957 * w1081 + w941 * w1090 + w325 * w1616 + w86 * w1617) + w621 * w1116
    w1619 = w124 * w1614 + w648 * w1116
    w1620 = w104 * w1614 - w647 * w1116
    w1621 = w324 * w1616 - (w957 * w1073 + w942 * w1090) + w86 * w1619 + w83 * w1620 + w619 * w1116
    w1622 = w83 * w1619 - (w957 * w1077 + w943 * w1090 + w323 * w1616) - w86 * w1620 + w617 * w1116
    w1623 = w957 * w1067 - w944 * w1090 + w322 * w1616 + w83 * w1617 + w86 * w1615 + w614 * w1116
    w1624 = w1156 + w236 * w1157
    w1625 = w645 * w1117 - w119 * w1624
    w1626 = w1182 - w236 * w1183
    w1627 = w649 * w1117 - w129 * w1624
    w1628 = w83 * w1625 - (w959 * w1081 + w941 * w1091 + w325 * w1626 + w86 * w1627) + w621 * w1117
    w1629 = w124 * w1624 + w648 * w1117
    w1630 = w104 * w1624 - w647 * w1117
    w1631 = w324 * w1626 - (w959 * w1073 + w942 * w1091) + w86 * w1629 + w83 * w1630 + w619 * w1117
    w1632 = w599 * w1613 - (w105 * w1618 + w72 * w1621 + w109 * w1622 + w207 * w1623) + w76 * w1628 + w69 * w1631
    w1633 = w83 * w1629 - (w959 * w1077 + w943 * w1091 + w323 * w1626) - w86 * w1630 + w617 * w1117
    w1634 = w959 * w1067 - w944 * w1091 + w322 * w1626 + w83 * w1627 + w86 * w1625 + w614 * w1117
    w1635 = w1117 - w1091
    w1636 = w601 * w1612 - w605 * w1635
    w1637 = w951 * w1087 + (w1609 - w207 * w1610) * c78 + (w1632 + w72 * w1633 + w105 * w1634 - w601 * w1636) * c55
    w1638 = w1601 + w1637
    w1639 = w942 * w1073
    w1640 = w943 * w1077
    w1641 = w943 * w1073 + w942 * w1077
    w1642 = w941 * w1077 + w943 * w1081
    w1643 = w936 * w1073 - w866 * w1639 - w871 * w1640 - w870 * w1641 + w939 * w1077 - (w72 * w1640 + w109 * w1641 + w76 * w1642) * c76
    w1644 = w941 * w1073 + w942 * w1081
    w1645 = w947 * w1077 + w943 * w1087
    w1646 = w947 * w1073 + w942 * w1087
    w1647 = w1643 - (w72 * w1639 + w105 * w1644) * c73 - w820 * w1603 - w820 * w1607 + w810 * w1645 - w809 * w1646
    w1648 = w944 * w1067
    w1649 = w943 * w1067 - w944 * w1077
    w1650 = w942 * w1067 - w944 * w1073
    w1651 = w941 * w1067 - w944 * w1081
    w1652 = w1647 + w830 * w1648 + w829 * w1649 + w828 * w1650 + (w72 * w1648 + w105 * w1649 + w207 * w1650 + w109 * w1651) * c77
    w1653 = w207 * w1073 + w105 * w1077 + w109 * w1081 - w72 * w1067
    w1654 = w958 * w1083 + w956 * w1085 + w953 * w1087
    w1655 = w217 * w1083 + w214 * w1085 + w209 * w1087
    w1656 = w109 * w1073 + w72 * w1077 + w76 * w1081 - w70 * w1067
    w1657 = w935 * w1653 - (w949 * w1654 + w950 * w1655) - w933 * w1656 + (w932 * w1656 - w934 * w1653) * c75
    w1658 = w238 * w1083 + w79 * w1085 + w74 * w1087
    w1659 = w72 * w1073 + w69 * w1077 + w105 * w1081 - w76 * w1067
    w1660 = w950 * w1658 + (w934 * w1658 - w937 * w1655) * c78 - w938 * w1653 + (w937 * w1653 - w932 * w1659) * c71
    w1661 = w1660 + w933 * w1659
    w1662 = w949 * w1658 + (w932 * w1658 - w937 * w1654) * c78 + w938 * w1656 - w935 * w1659 + (w934 * w1659 - w937 * w1656) * c72
    w1663 = w1652 - w809 * w1602 + w810 * w1610 - w940 * w1067 + bar4_e1_dot * w1657 + bar4_e2_dot * w1661 + bar4_e3_dot * w1662
    w1664 = w1180 - w275 * w1183
    w1665 = w1154 + w275 * w1157
    w1666 = w124 * w1665 + w648 * w1115
    w1667 = w104 * w1665 - w647 * w1115
    w1668 = w324 * w1664 - (w955 * w1073 + w942 * w1089) + w86 * w1666 + w83 * w1667 + w619 * w1115
    w1669 = w83 * w1666 - (w955 * w1077 + w943 * w1089 + w323 * w1664) - w86 * w1667 + w617 * w1115
    w1670 = w1663 - w276 * w1469 + w277 * w1470 + w278 * w1471 + w80 * w1668 - w239 * w1669 - w75 * w1621 + w239 * w1623
    w1671 = w220 * w1114
    w1672 = w205 * w1114
    w1673 = w211 * w1114
    w1674 = w599 * w1673 - w683 * w1114 - w605 * w1672
    w1675 = w605 * w1671 - (w684 * w1114 + w601 * w1673)
    w1676 = w672 * w1671 - (w674 * w1672 + w214 * w1674) + w217 * w1675 + w655 * w1611 - w80 * w1613 - w606 * w1635
    w1677 = w1676 + w239 * w1636
    w1678 = w601 * w1672 - w686 * w1114 - w599 * w1671
    w1679 = w671 * w1672 - w672 * w1673 - w209 * w1675 + w214 * w1678 + w606 * w1612 - w602 * w1611 - w75 * w1636
    w1680 = w599 * w1635 - w601 * w1611
    w1681 = w1679 + w80 * w1680
    w1682 = w674 * w1673 + w209 * w1674 - w671 * w1671 - w217 * w1678 - w655 * w1612 + w75 * w1613 + w602 * w1635
    w1683 = w1682 - w239 * w1680
    w1684 = w1670 + w75 * w1633 - w80 * w1634 + bar4_e3_dot * w1677 + bar4_e1_dot * w1681 + bar4_e2_dot * w1683
    w1685 = w947 * w1081 + w941 * w1087
    w1686 = w947 * w1067 - w944 * w1087
    w1687 = w70 * w1603 + w76 * w1604 + w109 * w1605 - w109 * w1645 - w72 * w1646 - w105 * w1685 + w207 * w1686
    w1688 = w645 * w1115 - w119 * w1665
    w1689 = w649 * w1115 - w129 * w1665
    w1690 = w83 * w1688 - (w955 * w1081 + w941 * w1089 + w325 * w1664 + w86 * w1689) + w621 * w1115
    w1691 = w955 * w1067 - w944 * w1089 + w322 * w1664 + w83 * w1689 + w86 * w1688 + w614 * w1115
    w1692 = w105 * w1690 + w72 * w1668 + w109 * w1669 + w207 * w1691 - w605 * w1613 - w109 * w1628 - w76 * w1631
    w1693 = w951 * w1085 + (w1687 - w72 * w1602) * c78 + (w1692 - w70 * w1633 - w72 * w1634 + w601 * w1680) * c55
    w1694 = w605 * w1675 - (w952 * w1083 + w679 * w1114) - w599 * w1678 + w205 * w1487 + w211 * w1517
    w1695 = w1693 - w1694
    w1696 = w954 * w1085
    w1697 = w599 * w1674 - (w952 * w1087 + w682 * w1114) - w601 * w1675 + w220 * w1589 + w205 * w1490
    w1698 = w1696 + w1697
    w1699 = w1078 + (w1079 - w1080)
    w1700 = w1566 + w1579 * w1580 + w1591 * w1592 + (w1597 + 2 * w1599) * w1600 + (2 * -(bar4_e2 * w1638) + 2 * w1684 + 2 * (bar4_e3 * w1695) + 2 * (bar4_e1 * w1698)) * w1699
    w1701 = w1637 - w1601
    w1702 = w809 * w1603 + w810 * w1606 + w829 * w1648 + (w70 * w1648 + w72 * w1649 + w109 * w1650 + w76 * w1651) * c76
    w1703 = w1702 - w939 * w1067 + bar4_e3_dot * w1661 + w278 * w1470 + w239 * w1622 - w80 * w1633 + bar4_e2_dot * w1677
    w1704 = w940 * w1077 - w872 * w1640 - (w105 * w1640 + w207 * w1641 + w109 * w1642) * c77 - w870 * w1642 - w866 * w1644
    w1705 = w941 * w1081
    w1706 = w1704 - w863 * w1705 - w105 * w1705 * c73 + w936 * w1081 - w820 * w1608 - w809 * w1685 + w830 * w1649
    w1707 = w1706 + w828 * w1651 - w810 * w1686 + w820 * w1602 + bar4_e0_dot * w1657 + bar4_e2_dot * w1662 + w276 * w1466
    w1708 = w1707 + w277 * w1471 + w80 * w1690 - w239 * w1691 - w75 * w1618 + w75 * w1634 + bar4_e0_dot * w1681
    w1709 = w1693 + w1694
    w1710 = w954 * w1087
    w1711 = w601 * w1678 - (w952 * w1085 + w681 * w1114 + w605 * w1674) + w220 * w1588 + w211 * w1518
    w1712 = 2 * (bar4_e3 * w1701) + 2 * w1703 + (w1708 + bar4_e3_dot * w1683) * -2.0 + 2 * (bar4_e2 * w1709) + w70 * (2 * (w1710 - w1711))
    w1713 = w1069 + w1072 - w1070
    w1714 = w70 * w1606 + w76 * w1607 + w109 * w1608 + w72 * w1645 + w69 * w1646 + w76 * w1685 - w105 * w1686
    w1715 = w109 * w1618 - (w76 * w1690 + w69 * w1668 + w72 * w1669 + w105 * w1691) + w76 * w1621 + w70 * w1622
    w1716 = w951 * w1083 + (w1714 + w72 * w1610) * c78 + (w1715 + w72 * w1623 + w605 * w1636 - w599 * w1680) * c55
    w1717 = w940 * w1073 - w868 * w1639 - w872 * w1641 - (w207 * w1639 + w109 * w1644) * c77 + w830 * w1650 + w809 * w1686
    w1718 = w1717 - w820 * w1610 + bar4_e1_dot * w1662 + w276 * w1471 + w80 * w1691 - w75 * w1623 + bar4_e3_dot * w1681
    w1719 = w939 * w1081 - (w867 * w1644 + (w871 * w1642 + w1081 * (bar4_e2 * w941) * c121)) + w809 * w1604 - w820 * w1605
    w1720 = w1719 + w810 * w1607 + w810 * w1685 + w828 * w1648 + w829 * w1651 + (w76 * w1648 + w69 * w1649 + w72 * w1650 + w105 * w1651) * c73
    w1721 = w1720 + bar4_e3_dot * w1657 - w936 * w1067 + bar4_e0_dot * w1661 + w277 * w1466 - w278 * w1469 - w239 * w1690
    w1722 = (w1721 + w239 * w1621 + w75 * w1628 - w80 * w1631 + bar4_e1_dot * w1677 + bar4_e0_dot * w1683) * -2.0
    w1723 = w1697 - w1696
    w1724 = w207 * (2 * (w1710 - w1716)) - w72 * w1638 + 2 * w1718 + w1722 + w70 * w1709 + 2 * (bar4_e3 * w1723)
    w1725 = w1074 + (w1075 - w1076)
    w1726 = w939 * w1073 - w867 * w1639 - w871 * w1641 - w872 * w1642 - w868 * w1644 - (w109 * w1639 + w76 * w1644) * c76
    w1727 = w1726 - w864 * w1705 - w109 * w1705 * c77 + w940 * w1081 + w809 * w1605 - w820 * w1606 + w810 * w1608
    w1728 = w1727 - w809 * w1645 + w829 * w1650 + w830 * w1651 + bar4_e1_dot * w1661 + bar4_e0_dot * w1662 + w278 * w1466
    w1729 = w1728 + w276 * w1470 + w80 * w1669 + w239 * w1618 - w75 * w1622 - w80 * w1628 + bar4_e0_dot * w1677
    w1730 = w936 * w1077 - w870 * w1640 - (w69 * w1640 + w72 * w1641 + w105 * w1642) * c73 - w820 * w1604 + w810 * w1646
    w1731 = w1730 + w828 * w1649 + bar4_e2_dot * w1657 - w277 * w1469 - w239 * w1668 + w75 * w1631 + bar4_e1_dot * w1683
    w1732 = w70 * w1701 + (w1729 + bar4_e2_dot * w1681) * -2.0 + 2 * w1731 + w72 * w1695 + w69 * (2 * -(w1711 + w1716))
    w1733 = w1062 + (w1064 + w1066)
    w1734 = w969 * w1086
    w1735 = w972 * w1082
    w1736 = w1734 - w1735
    w1737 = w962 * w1000 + w691 * w1098 + w280 * w1462 - w267 * w1664 - w251 * w1616 - w111 * w1626
    w1738 = w266 * w1664 - (w960 * w1000 + w691 * w1094 + w279 * w1462) + w250 * w1616 + w108 * w1626
    w1739 = w972 * w1084
    w1740 = w928 * w1071 - w926 * w1082
    w1741 = w928 * w1068 + w925 * w1082
    w1742 = w924 * w1082 - w928 * w1063
    w1743 = w929 * w1071 - w1071 * c94 - w926 * w1084
    w1744 = w1068 * c94 - w929 * w1068 - w925 * w1084
    w1745 = w1063 * c94 - w929 * w1063 + w924 * w1084
    w1746 = w928 * w1065 - w927 * w1082
    w1747 = w87 * w1740 - w120 * w1741 + w121 * w1742 - w125 * w1743 - w87 * w1744 - w112 * w1745 + w112 * w1746
    w1748 = w929 * w1065 - w927 * w1084 - w1065 * c94
    w1749 = w1116 - w1103
    w1750 = w1115 - w1102
    w1751 = w639 * w1749 - w633 * w1750
    w1752 = w924 * w1103 - w978 * w1063 - w1617
    w1753 = w1619 - (w978 * w1068 + w925 * w1103)
    w1754 = w978 * w1071 - w926 * w1103 - w1620
    w1755 = w1615 + (w978 * w1065 - w927 * w1103)
    w1756 = w924 * w1104 - w982 * w1063 - w1627
    w1757 = w1629 - (w982 * w1068 + w925 * w1104)
    w1758 = w633 * w1751 - (w112 * w1752 + w87 * w1753 + w125 * w1754 + w89 * w1755) + w121 * w1756 + w120 * w1757
    w1759 = w982 * w1071 - w926 * w1104 - w1630
    w1760 = w1625 + (w982 * w1065 - w927 * w1104)
    w1761 = w1117 - w1104
    w1762 = w635 * w1750 - w639 * w1761
    w1763 = w965 * w1086 + (w1747 - w89 * w1748) * c80 + (w1758 + w87 * w1759 + w112 * w1760 - w635 * w1762) * c56
    w1764 = w1739 + w1763
    w1765 = w969 * w1084
    w1766 = w930 * w1071 - w926 * w1086
    w1767 = w930 * w1068 + w925 * w1086
    w1768 = w924 * w1086 - w930 * w1063
    w1769 = w930 * w1065 - w927 * w1086
    w1770 = w94 * w1743 + w121 * w1744 + w125 * w1745 - w87 * w1766 + w120 * w1767 - w121 * w1768 - w112 * w1769
    w1771 = w924 * w1102 - w974 * w1063 - w1689
    w1772 = w1666 - (w974 * w1068 + w925 * w1102)
    w1773 = w974 * w1071 - w926 * w1102 - w1667
    w1774 = w1688 + (w974 * w1065 - w927 * w1102)
    w1775 = w125 * w1752 - (w121 * w1771 + w120 * w1772 + w87 * w1773 + w112 * w1774) + w121 * w1753 + w94 * w1754
    w1776 = w633 * w1761 - w635 * w1749
    w1777 = w965 * w1082 + (w1770 + w87 * w1748) * c80 + (w1775 + w87 * w1755 + w639 * w1762 - w633 * w1776) * c56
    w1778 = w1765 + w1777
    w1779 = 2 * (bar5_e2 * w1736) - w321 * w1737 + w320 * w1738 + 2 * (bar5_e1 * w1764) + 2 * -(bar5_e3 * w1778)
    w1780 = w924 * w1068 - w925 * w1063
    w1781 = w925 * w1068
    w1782 = w926 * w1071
    w1783 = w925 * w1071 - w926 * w1068
    w1784 = w926 * w1063 + w924 * w1071
    w1785 = (w112 * w1780 - w87 * w1781) * c67 - w906 * w1781 + w919 * w1068 + w896 * w1782 + w895 * w1783 + (w87 * w1782 + w125 * w1783 - w121 * w1784) * c69
    w1786 = w927 * w1065
    w1787 = w927 * w1071 + w926 * w1065
    w1788 = w1785 - w922 * w1071 + w846 * w1740 - w846 * w1744 - w851 * w1766 - w848 * w1767 + w857 * w1786 + w856 * w1787
    w1789 = w925 * w1065 - w927 * w1068
    w1790 = w927 * w1063 + w924 * w1065
    w1791 = w1788 + w855 * w1789 + (w87 * w1786 + w112 * w1787 + w89 * w1789 - w125 * w1790) * c70 - w848 * w1746
    w1792 = w245 * w1082 + w97 * w1084 + w91 * w1086
    w1793 = w979 * w1082 + w975 * w1084 + w968 * w1086
    w1794 = w125 * w1063 + w89 * w1068 - w112 * w1071 - w87 * w1065
    w1795 = w121 * w1063 + w125 * w1068 - w87 * w1071 - w94 * w1065
    w1796 = w963 * w1792 + (w920 * w1792 - w917 * w1793) * c80 + w918 * w1794 - w916 * w1795 + (w915 * w1795 - w917 * w1794) * c68
    w1797 = w112 * w1063 + w87 * w1068 - w120 * w1071 - w121 * w1065
    w1798 = w980 * w1082 + w976 * w1084 + w971 * w1086
    w1799 = (w920 * w1794 - w915 * w1797) * c65 - (w964 * w1798 + w963 * w1793 + w921 * w1794) + w916 * w1797
    w1800 = w964 * w1792 + (w915 * w1792 - w917 * w1798) * c80 + w921 * w1795 - w918 * w1797 + (w917 * w1797 - w920 * w1795) * c66
    w1801 = w1791 + w851 * w1748 - w923 * w1065 + bar5_e1_dot * w1796 + bar5_e2_dot * w1799 + bar5_e3_dot * w1800
    w1802 = w660 * w1749 - w98 * w1751 - w640 * w1761 + w246 * w1762
    w1803 = w1801 + w98 * w1772 - w246 * w1773 - w92 * w1753 + w246 * w1755 + w92 * w1759 - w98 * w1760 + bar5_e3_dot * w1802
    w1804 = w640 * w1750 - w636 * w1749 - w92 * w1762 + w98 * w1776
    w1805 = w92 * w1751 - w660 * w1750 + w636 * w1761 - w246 * w1776
    w1806 = w1098 - w280 * w1114 + w267 * w1115 + w251 * w1116 + w111 * w1117
    w1807 = w1094 - w279 * w1114 + w266 * w1115 + w250 * w1116 + w108 * w1117
    w1808 = w1063 * (w1779 + 2 * (w1803 + bar5_e1_dot * w1804 + bar5_e2_dot * w1805) - w610 * w1806 + w609 * w1807)
    w1809 = w1734 + w1735
    w1810 = w262 * w1664 - (w988 * w1000 + w691 * w1096 + w283 * w1462) + w241 * w1616 + w81 * w1626
    w1811 = w986 * w1000 + w691 * w1092 + w282 * w1462 - w263 * w1664 - w242 * w1616 - w85 * w1626
    w1812 = w851 * w1743 - w848 * w1740 + w856 * w1786 + (w94 * w1786 + w87 * w1787 + w125 * w1789 - w121 * w1790) * c69
    w1813 = 2 * (w1812 - w922 * w1065 + bar5_e3_dot * w1799 + w246 * w1754 - w98 * w1759 + bar5_e2_dot * w1802)
    w1814 = w1777 - w1765
    w1815 = 2 * -(bar5_e3 * w1809) + w321 * w1810 + w320 * w1811 + w87 * w1764 + w1813 + 2 * (bar5_e2 * w1814)
    w1816 = w972 * w1086
    w1817 = w121 * w1741 - w94 * w1740 - w125 * w1742 + w125 * w1766 - w87 * w1767 + w112 * w1768 + w89 * w1769
    w1818 = w112 * w1771 + w87 * w1772 + w125 * w1773 + w89 * w1774 - w639 * w1751 - w125 * w1756 - w121 * w1757
    w1819 = w965 * w1084 + (w1817 - w87 * w1746) * c80 + (w1818 - w94 * w1759 - w87 * w1760 + w635 * w1776) * c56
    w1820 = w924 * (w798 * (bar5_e1 * w103)) * c122 + w919 * w1063 + w906 * w1780 + w897 * w1782 + (w112 * w1782 + w89 * w1783 - w125 * w1784) * c70
    w1821 = w1820 - w895 * w1784 - w923 * w1071 - w846 * w1745 + w848 * w1768 + w857 * w1787 - w855 * w1790 - w851 * w1769
    w1822 = w1821 + w846 * w1746 + bar5_e0_dot * w1796 + bar5_e2_dot * w1800 + w98 * w1771 - w246 * w1774 - w92 * w1752
    w1823 = w1815 + w94 * (2 * (w1816 - w1819)) + (w1822 + w92 * w1760 + bar5_e0_dot * w1804 + bar5_e3_dot * w1805) * -2.0
    w1824 = w1096 - w283 * w1114 + w262 * w1115 + w241 * w1116 + w81 * w1117
    w1825 = w1092 - w282 * w1114 + w263 * w1115 + w242 * w1116 + w85 * w1117
    w1826 = w1700 + (w1712 + w72 * w1698) * w1713 + w1724 * w1725 - (w1732 + w207 * w1723) * w1733 + w1808 + w1068 * (w1823 - w610 * w1824 - w609 * w1825)
    w1827 = w969 * w1082
    w1828 = w1763 - w1739
    w1829 = w89 * (2 * (w1816 + w1827)) + w87 * w1736 + w320 * w1810 - w321 * w1811 + 2 * (bar5_e3 * w1828) + w94 * w1814
    w1830 = (w125 * w1780 - w89 * w1781) * c70 - w908 * w1781 + w923 * w1068 + w897 * w1783 + w857 * w1789 + w848 * w1769
    w1831 = 2 * (w1830 - w846 * w1748 + bar5_e1_dot * w1800 + w98 * w1774 - w92 * w1755 + bar5_e3_dot * w1804)
    w1832 = w924 * (w798 * (bar5_e2 * w103)) * c123 + w922 * w1063 + w907 * w1780 - w896 * w1784 + w848 * w1741
    w1833 = w1832 + w846 * w1742 + w851 * w1744 - w851 * w1768 + w855 * w1786 - w856 * w1790 + (w121 * w1786 + w120 * w1787 + w87 * w1789 - w112 * w1790) * c67
    w1834 = w1833 + bar5_e3_dot * w1796 - w919 * w1065 + bar5_e0_dot * w1799 - w246 * w1771 + w246 * w1753 + w92 * w1756
    w1835 = w1829 + w1831 + (w1834 - w98 * w1757 + bar5_e1_dot * w1802 + bar5_e0_dot * w1805) * -2.0 + w609 * w1824
    w1836 = w320 * w1737 - w94 * w1809 + w321 * w1738 + w89 * w1828 - w87 * w1778 + w120 * (2 * (w1827 - w1819))
    w1837 = w924 * (w798 * (bar5_e3 * w103)) * c124 + w923 * w1063 - w907 * w1781 + w908 * w1780 + (w121 * w1780 - w125 * w1781) * c69
    w1838 = w1837 + w922 * w1068 + w896 * w1783 - w897 * w1784 - w848 * w1742 - w846 * w1743 + w851 * w1745 + w848 * w1766
    w1839 = w1838 + w856 * w1789 - w857 * w1790 + bar5_e1_dot * w1799 + bar5_e0_dot * w1800 + w98 * w1773 + w246 * w1752
    w1840 = w895 * w1782 + (w120 * w1782 + w87 * w1783 - w112 * w1784) * c67 - w919 * w1071 - w846 * w1741 + w851 * w1767
    w1841 = 2 * (w1840 + w855 * w1787 + bar5_e2_dot * w1796 - w246 * w1772 + w92 * w1757 + bar5_e1_dot * w1805)
    w1842 = w1836 + (w1839 - w92 * w1754 - w98 * w1756 + bar5_e0_dot * w1802 + bar5_e2_dot * w1804) * -2.0 + w1841
    w1843 = w524 * w1055 - (w748 * w788 + w771 * w777 + w754 * w773 + w3 * w750 + w523 * w1053 + w522 * w1051)
    w1844 = w1843 + w230 * w1474 - w231 * w1477 - w232 * w1478 - w233 * w1475 + w195 * w1254 - w197 * w1252 - w199 * w1249
    w1845 = w1844 + w201 * w1246 + w181 * w1260 - w183 * w1262 - w186 * w1264 + w188 * w1266 + w152 * w1233 - w157 * w1235
    w1846 = 2 * w1119
    w1847 = 2 * w1118
    w1848 = 2 * w1299
    w1849 = 2 * w1301
    w1850 = bar1_e1_dot * w1846 + bar1_e2_dot * w1847 + bar1_e3_dot * w1848 + bar1_e0_dot * w1849
    w1851 = bar1_e0 * w1300 - (bar1_e1 * w1229 + bar1_e2 * w1230 + bar1_e3 * w1298) - hinge1_angle_dot * w1850
    w1852 = bar1_e1 * w1118 - bar1_e2 * w1119 - bar1_e0 * w1299 + bar1_e3 * w1301
    w1853 = w773 * w777 - w750 * w788 - w754 * w771 + w3 * w748 + w525 * w1053 + w524 * w1051 + w522 * w1055 + w233 * w1474
    w1854 = w1853 + w232 * w1477 - w231 * w1478 + w230 * w1475 - w201 * w1254 + w199 * w1252 - w197 * w1249 + w195 * w1246
    w1855 = w1854 - w188 * w1260 + w186 * w1262 - w183 * w1264 + w181 * w1266 - w163 * w1233 + w161 * w1235 - w157 * w1237
    w1856 = bar1_e2_dot * w1846 - bar1_e1_dot * w1847 + bar1_e0_dot * w1848 - bar1_e3_dot * w1849
    w1857 = (bar1_e2 * w1229 - bar1_e1 * w1230 + bar1_e0 * w1298 + bar1_e3 * w1300 + hinge1_angle_dot * w1856) * 0.5
    w1858 = bar1_e1 * w1119 + bar1_e2 * w1118 + bar1_e3 * w1299 + bar1_e0 * w1301
    w1859 = w5 * (w1845 - w161 * w1237 + w163 * w1239 - w525 * w1057 + w1851 * 0.5 + w552 * w1852) - w65 * (w1855 + w152 * w1239 - w523 * w1057 + w1857 - w552 * w1858)
    w1860 = w1826 - w1071 * (w1835 - w610 * w1825) - w1065 * (w1842 - w609 * w1806 - w610 * w1807) + w1008 * (w1859 * 0.5)
    w1861 = bar2_e0 * w1329 - bar2_e3 * w1328 + bar2_e1 * w1330 + bar2_e2 * w1331
    w1862 = bar2_e0 * w1331 - (bar2_e1 * w1328 + bar2_e2 * w1329 + bar2_e3 * w1330)
    w1863 = 2 * w1332
    w1864 = 2 * w1333
    w1865 = 2 * w1334
    w1866 = 2 * w1336
    w1867 = bar2_e2_dot * w1863 - bar2_e3_dot * w1864 + bar2_e0_dot * w1865 + bar2_e1_dot * w1866
    w1868 = bar2_e0_dot * w1863 - bar2_e1_dot * w1864 - bar2_e2_dot * w1865 - bar2_e3_dot * w1866
    w1869 = (w1867 * c17 + w1868 * c19) * c18 + (w1868 * c17 - w1867 * c19) * c16
    w1870 = ((w1861 * c17 + w1862 * c19) * c18 + (w1862 * c17 - w1861 * c19) * c16 + hinge2_angle_dot * w1869) * 0.5
    w1871 = bar2_e2 * w1336 - (bar2_e1 * w1332 + bar2_e0 * w1333 + bar2_e3 * w1334)
    w1872 = bar2_e3 * w1332 + bar2_e2 * w1333 - bar2_e1 * w1334 + bar2_e0 * w1336
    w1873 = (w1871 * c17 - w1872 * c19) * c18 + (w1871 * c19 + w1872 * c17) * c16
    w1874 = w744 * w1016 - w747 * w1020 - w746 * w1024 + w745 * w1028 + w696 * w1046 - w697 * w1047 - w694 * w1048
    w1875 = w1874 + w695 * w1049 + w228 * w1476 - w229 * w1479 + w226 * w1480 + w227 * w1481 + w190 * w1343 + w194 * w1345
    w1876 = w1875 - w192 * w1347 - w193 * w1349 + w170 * w1351 + w180 * w1354 - w178 * w1356 - w179 * w1358 + w133 * w1412
    w1877 = w1876 + w150 * w1415 - w141 * w1393 - w145 * w1395
    w1878 = w695 * w1047 - (w745 * w1020 + w746 * w1016 + w744 * w1024 + w747 * w1028 + w694 * w1046) - w696 * w1048
    w1879 = w1878 + w697 * w1049 + w226 * w1476 - w227 * w1479 - w228 * w1480 - w229 * w1481 + w192 * w1343 + w193 * w1345
    w1880 = w1879 + w190 * w1347 + w194 * w1349 + w178 * w1351 + w179 * w1354 + w170 * w1356 + w180 * w1358 + w141 * w1412
    w1881 = w1880 + w145 * w1415 + w133 * w1393 + w150 * w1395
    w1882 = w7 * (w1870 + w576 * w1873 + (w1877 * c19 - w1881 * c17) * c16 + (w1881 * c19 + w1877 * c17) * c18)
    w1883 = bar2_e0 * w1328 + bar2_e3 * w1329 - bar2_e2 * w1330 + bar2_e1 * w1331
    w1884 = bar2_e2 * w1328 - bar2_e1 * w1329 + bar2_e0 * w1330 + bar2_e3 * w1331
    w1885 = bar2_e1_dot * w1863 + bar2_e0_dot * w1864 + bar2_e3_dot * w1865 - bar2_e2_dot * w1866
    w1886 = bar2_e3_dot * w1863 + bar2_e2_dot * w1864 - bar2_e1_dot * w1865 + bar2_e0_dot * w1866
    w1887 = (w1885 * c19 - w1886 * c17) * c16 + (w1885 * c17 + w1886 * c19) * c18
    w1888 = ((w1883 * c19 - w1884 * c17) * c16 + (w1884 * c19 + w1883 * c17) * c18 + hinge2_angle_dot * w1887) * 0.5
    w1889 = bar2_e2 * w1332 - bar2_e3 * w1333 + bar2_e0 * w1334 + bar2_e1 * w1336
    w1890 = bar2_e0 * w1332 - bar2_e1 * w1333 - bar2_e2 * w1334 - bar2_e3 * w1336
    w1891 = (w1889 * c17 + w1890 * c19) * c18 + (w1890 * c17 - w1889 * c19) * c16
    w1892 = w746 * w1020 - w745 * w1016 - w747 * w1024 + w744 * w1028 - w697 * w1046 - w696 * w1047 - w695 * w1048
    w1893 = w1892 - w694 * w1049 + w229 * w1476 + w228 * w1479 - w227 * w1480 + w226 * w1481 + w194 * w1343 - w190 * w1345
    w1894 = w1893 + w193 * w1347 - w192 * w1349 + w180 * w1351 - w170 * w1354 + w179 * w1356 - w178 * w1358 + w150 * w1412
    w1895 = w1894 - w133 * w1415 + w145 * w1393 - w141 * w1395
    w1896 = w744 * w1020 + w747 * w1016 - w745 * w1024 - w746 * w1028 - w695 * w1046 - w694 * w1047 + w697 * w1048
    w1897 = w1896 + w696 * w1049 + w227 * w1476 + w226 * w1479 + w229 * w1480 - w228 * w1481 + w193 * w1343 - w192 * w1345
    w1898 = w1897 - w194 * w1347 + w190 * w1349 + w179 * w1351 - w178 * w1354 - w180 * w1356 + w170 * w1358 + w145 * w1412
    w1899 = w1898 - w141 * w1415 - w150 * w1393 + w133 * w1395
    w1900 = w146 * (w1888 + w576 * w1891 + (w1895 * c19 - w1899 * c17) * c18 + (w1895 * c17 + w1899 * c19) * c16)
    w1901 = w986 * w1068 - w960 * w1063 + w988 * w1071 - w962 * w1065 + w924 * w1094 + w925 * w1092 - w926 * w1096
    w1902 = w1901 + w927 * w1098 - w279 * w1464 - w282 * w1467 - w283 * w1468 + w280 * w1465 + w266 * w1689 + w263 * w1666
    w1903 = w1902 + w262 * w1667 + w267 * w1688 + w250 * w1617 + w242 * w1619 + w241 * w1620 + w251 * w1615 + w108 * w1627
    w1904 = 2 * w1806
    w1905 = 2 * w1824
    w1906 = 2 * w1825
    w1907 = 2 * w1807
    w1908 = bar5_e0_dot * w1904 + bar5_e1_dot * w1905 + bar5_e2_dot * w1906 + bar5_e3_dot * w1907
    w1909 = (bar5_e1 * w1810 - bar5_e0 * w1737 - bar5_e2 * w1811 + bar5_e3 * w1738 - hinge4_angle_dot * w1908) * 0.5
    w1910 = bar5_e2 * w1824 - bar5_e3 * w1806 - bar5_e1 * w1825 + bar5_e0 * w1807
    w1911 = w962 * w1063 + w988 * w1068 - w986 * w1071 - w960 * w1065 + w927 * w1094 + w926 * w1092 + w925 * w1096
    w1912 = w1911 - w924 * w1098 + w280 * w1464 - w283 * w1467 + w282 * w1468 + w279 * w1465 - w267 * w1689 + w262 * w1666
    w1913 = w1912 - w263 * w1667 + w266 * w1688 - w251 * w1617 + w241 * w1619 - w242 * w1620 + w250 * w1615 - w111 * w1627
    w1914 = bar5_e3_dot * w1904 - bar5_e2_dot * w1905 + bar5_e1_dot * w1906 - bar5_e0_dot * w1907
    w1915 = (bar5_e3 * w1737 + bar5_e2 * w1810 + bar5_e1 * w1811 + bar5_e0 * w1738 + hinge4_angle_dot * w1914) * 0.5
    w1916 = bar5_e0 * w1806 + bar5_e1 * w1824 + bar5_e2 * w1825 + bar5_e3 * w1807
    w1917 = w86 * (w1903 + w85 * w1629 + w81 * w1630 + w111 * w1625 + w1909 + w608 * w1910) - w83 * (w1913 + w81 * w1629 - w85 * w1630 + w108 * w1625 + w1915 - w608 * w1916)
    w1918 = w798 * w993 + w690 * w1111 - w286 * w1463 - w273 * w1665 - w259 * w1614 - w128 * w1624
    w1919 = w690 * w1107 - w798 * w989 + w284 * w1463 + w265 * w1665 + w248 * w1614 + w100 * w1624
    w1920 = w1109 - w285 * w1114 + w271 * w1115 + w257 * w1116 + w123 * w1117
    w1921 = w1105 - w281 * w1114 + w269 * w1115 + w254 * w1116 + w116 * w1117
    w1922 = (w1920 * c60 - w1921 * c58) * c59 + (w1920 * c58 + w1921 * c60) * c57
    w1923 = w117 * (((w1918 * c58 - w1919 * c60) * c59 + (w1918 * c60 + w1919 * c58) * c57) * 0.5 + w643 * w1922)
    w1924 = w798 * w991 - w690 * w1109 - w285 * w1463 + w271 * w1665 + w257 * w1614 + w123 * w1624
    w1925 = w690 * w1105 - w798 * w983 + w281 * w1463 - w269 * w1665 - w254 * w1614 - w116 * w1624
    w1926 = w1111 + w286 * w1114 + w273 * w1115 + w259 * w1116 + w128 * w1117
    w1927 = w1107 - w284 * w1114 - w265 * w1115 - w248 * w1116 - w100 * w1117
    w1928 = (w1926 * c58 - w1927 * c60) * c59 + (w1926 * c60 + w1927 * c58) * c57
    w1929 = w102 * (((w1924 * c58 - w1925 * c60) * c57 + (w1924 * c60 + w1925 * c58) * c59) * 0.5 + w643 * w1928)
    w1930 = w1012 + (w1860 + w1004 * ((w1882 - w1900) * 0.5) + w1000 * (w1917 * 0.5) - w798 * ((w1923 - w1929) * 0.5))
    w1931 = w37 * w1291 - (w555 * w1846 + w556 * w1847) + w22 * w1276 + w24 * w1292 + w24 * w1295 + w27 * w1284
    w1932 = hinge0_angle_dot * w786
    w1933 = w556 * w1848 - w555 * w1849 + w22 * w1291 + w27 * w1276 + w45 * w1292 + w45 * w1295 + w22 * w1284
    w1934 = hinge0_angle_dot * w792
    w1935 = w556 * w1846 - w555 * w1847 + w24 * w1291 + w23 * w1276 + w27 * w1292 + w37 * w1295 + w24 * w1284
    w1936 = hinge0_angle_dot * w774
    w1937 = w45 * w1291 - (w555 * w1848 + w556 * w1849) + w24 * w1276 + w364 * w1292 + w22 * w1295 + w23 * w1284
    w1938 = hinge0_angle_dot * w752
    w1939 = (w1931 + w364 * w1296) * w1932 - (w1933 + w27 * w1296) * w1934 + (w1935 + w45 * w1296) * w1936 + (w1937 + w24 * w1296) * w1938
    w1940 = w586 * w1863 + w588 * w1864 + w587 * w1865 + w584 * w1866 + w58 * w1389 + w134 * w1390 + w51 * w1391
    w1941 = hinge0_angle_dot * w1008
    w1942 = w66 * w1941
    w1943 = w67 * w152 + w66 * w163
    w1944 = w67 * w181 + w66 * w188
    w1945 = w67 * w195 + w66 * w201
    w1946 = w67 * w230 - w66 * w233
    w1947 = (w1227 * w1943 + w1225 * w1944 + w1223 * w1945 + w1207 * w1946) / w1220
    w1948 = w1943 / w235 - w1216 * w1947
    w1949 = w1944 / w235 - w1213 * w1947
    w1950 = w1945 / w235 - w1210 * w1947
    w1951 = w1946 / w235 - w1209 * w1947
    w1952 = w130 * w1948 + w260 * w1949 + w274 * w1950 + w287 * w1951
    w1953 = w236 * w1952 + w289 * w1948
    w1954 = w301 * w1948 + w302 * w1949 + w303 * w1950 + w304 * w1951
    w1955 = w236 * w1954 + w305 * w1948
    w1956 = w261 * w1954 + w305 * w1949
    w1957 = w275 * w1954 + w305 * w1950
    w1958 = w288 * w1954 + w305 * w1951
    w1959 = (w1202 * w1955 + w1200 * w1956 + w1198 * w1957 + w1185 * w1958) / w1195
    w1960 = w1192 * w1959 - w1955 / w310
    w1961 = w1190 * w1959 - w1956 / w310
    w1962 = w261 * w1952 + w289 * w1949
    w1963 = w1188 * w1959 - w1957 / w310
    w1964 = w275 * w1952 + w289 * w1950
    w1965 = w1187 * w1959 - w1958 / w310
    w1966 = w288 * w1952 + w289 * w1951
    w1967 = w290 * w1960 - w311 * w1953 + (w312 * w1961 - w313 * w1962) + (w314 * w1963 - w315 * w1964) + (w316 * w1965 - w317 * w1966)
    w1968 = w1953 + (w311 * w1967 + w318 * w1960)
    w1969 = w326 * w1948 + w327 * w1949 + w328 * w1950 + w329 * w1951
    w1970 = w236 * w1969 + w330 * w1948
    w1971 = w261 * w1969 + w330 * w1949
    w1972 = w275 * w1969 + w330 * w1950
    w1973 = w288 * w1969 + w330 * w1951
    w1974 = w331 * w1960 - w311 * w1970 + (w332 * w1961 - w313 * w1971) + (w333 * w1963 - w315 * w1972) + (w334 * w1965 - w317 * w1973)
    w1975 = w1970 + (w311 * w1974 + w335 * w1960)
    w1976 = w1971 + (w313 * w1974 + w335 * w1961)
    w1977 = w1972 + (w315 * w1974 + w335 * w1963)
    w1978 = w1973 + (w317 * w1974 + w335 * w1965)
    w1979 = (w1176 * w1975 + w1174 * w1976 + w1172 * w1977 + w1159 * w1978) / w1169
    w1980 = w1166 * w1979 - w1975 / w340
    w1981 = w1164 * w1979 - w1976 / w340
    w1982 = w1962 + (w313 * w1967 + w318 * w1961)
    w1983 = w1162 * w1979 - w1977 / w340
    w1984 = w1964 + (w315 * w1967 + w318 * w1963)
    w1985 = w1161 * w1979 - w1978 / w340
    w1986 = w1966 + (w317 * w1967 + w318 * w1965)
    w1987 = w319 * w1980 - w341 * w1968 + (w342 * w1981 - w343 * w1982) + (w344 * w1983 - w345 * w1984) + (w346 * w1985 - w347 * w1986)
    w1988 = w1968 + (w341 * w1987 + w348 * w1980)
    w1989 = w1982 + (w343 * w1987 + w348 * w1981)
    w1990 = w1984 + (w345 * w1987 + w348 * w1983)
    w1991 = w1986 + (w347 * w1987 + w348 * w1985)
    w1992 = (w1145 * w1988 + w1143 * w1989 + w1141 * w1990 + w1128 * w1991) / w1138
    w1993 = w364 * c10
    w1994 = w45 * w1993
    w1995 = 2 * w28
    w1996 = w37 * c10
    w1997 = w24 * w1996
    w1998 = w1995 + w1997
    w1999 = 2 * w26
    w2000 = w24 * w1993
    w2001 = w1999 - w2000
    w2002 = w22 * w1996
    w2003 = w22 * w1993
    w2004 = w27 * w1996
    w2005 = w3 * (w1994 + w1998) + w754 * (w2001 - w23 * w1996) + w777 * (w37 * w1993 + w2002) - w788 * (w2003 + w2004)
    w2006 = w27 * w1993
    w2007 = w754 * w2006
    w2008 = 2 * w362
    w2009 = w364 * w1993
    w2010 = w2007 - w3 * (w2008 + w2009) + w777 * w2001 + w788 * w1994
    w2011 = w794 * (w1135 * w1992 - w1988 / w353) + w354 * w2005 + (w795 * (w1133 * w1992 - w1989 / w353) + w360 * w2010)
    w2012 = w3 * (w364 * w1996)
    w2013 = w45 * w1996
    w2014 = w754 * (w2004 - w2008) - w2012 - w777 * w1998 + w788 * w2013
    w2015 = w2011 + (w796 * (w1131 * w1992 - w1990 / w353) + w375 * w2014) + w797 * (w1130 * w1992 - w1991 / w353)
    w2016 = w2015 / w353 + w1129 * w1992
    w2017 = w794 * w1948 + w236 * w2005 + (w795 * w1949 + w261 * w2010) + (w796 * w1950 + w275 * w2014) + w797 * w1951
    w2018 = w794 * w1980 + w341 * w2005 + (w795 * w1981 + w343 * w2010) + (w796 * w1983 + w345 * w2014) + w797 * w1985
    w2019 = (w798 * w1987 + w348 * w2016 - w2018) / w340 + w1160 * w1979
    w2020 = w794 * w1960 + w311 * w2005 + (w795 * w1961 + w313 * w2010) + (w796 * w1963 + w315 * w2014) + w797 * w1965
    w2021 = (w798 * w1967 + w318 * w2016 - w2020 - (w1000 * w1974 + w335 * w2019)) / w310 + w1186 * w1959
    w2022 = w798 * w1952 + w289 * w2016 - w2017 - (w1000 * w1969 + w330 * w2019) - (w1004 * w1954 + w305 * w2021)
    w2023 = hinge0_angle_dot * (w2022 / w235 - w1208 * w1947)
    w2024 = w1942 + w68 * w2023
    w2025 = w67 * w157 + w66 * w161
    w2026 = w67 * w183 + w66 * w186
    w2027 = w67 * w197 + w66 * w199
    w2028 = w67 * w231 + w66 * w232
    w2029 = (w1227 * w2025 + w1225 * w2026 + w1223 * w2027 + w1207 * w2028) / w1220
    w2030 = w1216 * w2029 - w2025 / w235
    w2031 = w1213 * w2029 - w2026 / w235
    w2032 = w1210 * w2029 - w2027 / w235
    w2033 = w1209 * w2029 - w2028 / w235
    w2034 = w130 * w2030 + w260 * w2031 + w274 * w2032 + w287 * w2033
    w2035 = w236 * w2034 + w289 * w2030
    w2036 = w301 * w2030 + w302 * w2031 + w303 * w2032 + w304 * w2033
    w2037 = w236 * w2036 + w305 * w2030
    w2038 = w261 * w2036 + w305 * w2031
    w2039 = w275 * w2036 + w305 * w2032
    w2040 = w288 * w2036 + w305 * w2033
    w2041 = (w1202 * w2037 + w1200 * w2038 + w1198 * w2039 + w1185 * w2040) / w1195
    w2042 = w1192 * w2041 - w2037 / w310
    w2043 = w1190 * w2041 - w2038 / w310
    w2044 = w261 * w2034 + w289 * w2031
    w2045 = w1188 * w2041 - w2039 / w310
    w2046 = w275 * w2034 + w289 * w2032
    w2047 = w1187 * w2041 - w2040 / w310
    w2048 = w288 * w2034 + w289 * w2033
    w2049 = w290 * w2042 - w311 * w2035 + (w312 * w2043 - w313 * w2044) + (w314 * w2045 - w315 * w2046) + (w316 * w2047 - w317 * w2048)
    w2050 = w2035 + (w311 * w2049 + w318 * w2042)
    w2051 = w326 * w2030 + w327 * w2031 + w328 * w2032 + w329 * w2033
    w2052 = w236 * w2051 + w330 * w2030
    w2053 = w261 * w2051 + w330 * w2031
    w2054 = w275 * w2051 + w330 * w2032
    w2055 = w288 * w2051 + w330 * w2033
    w2056 = w331 * w2042 - w311 * w2052 + (w332 * w2043 - w313 * w2053) + (w333 * w2045 - w315 * w2054) + (w334 * w2047 - w317 * w2055)
    w2057 = w2052 + (w311 * w2056 + w335 * w2042)
    w2058 = w2053 + (w313 * w2056 + w335 * w2043)
    w2059 = w2054 + (w315 * w2056 + w335 * w2045)
    w2060 = w2055 + (w317 * w2056 + w335 * w2047)
    w2061 = (w1176 * w2057 + w1174 * w2058 + w1172 * w2059 + w1159 * w2060) / w1169
    w2062 = w1166 * w2061 - w2057 / w340
    w2063 = w1164 * w2061 - w2058 / w340
    w2064 = w2044 + (w313 * w2049 + w318 * w2043)
    w2065 = w1162 * w2061 - w2059 / w340
    w2066 = w2046 + (w315 * w2049 + w318 * w2045)
    w2067 = w1161 * w2061 - w2060 / w340
    w2068 = w2048 + (w317 * w2049 + w318 * w2047)
    w2069 = w319 * w2062 - w341 * w2050 + (w342 * w2063 - w343 * w2064) + (w344 * w2065 - w345 * w2066) + (w346 * w2067 - w347 * w2068)
    w2070 = w2050 + (w341 * w2069 + w348 * w2062)
    w2071 = w2064 + (w343 * w2069 + w348 * w2063)
    w2072 = w2066 + (w345 * w2069 + w348 * w2065)
    w2073 = w2068 + (w347 * w2069 + w348 * w2067)
    w2074 = (w1145 * w2070 + w1143 * w2071 + w1141 * w2072 + w1128 * w2073) / w1138
    w2075 = w26 * -2.0
    w2076 = w2013 + w2075
    w2077 = w754 * (w1997 - (w1995 + w23 * w1993)) - w3 * (w2076 - w2000) - w777 * (w37 * w1996 - w2003) + w788 * (w2002 - w2006)
    w2078 = w2012 + w754 * (w2008 - w2004) + w777 * w1997 - w788 * w2076
    w2079 = w794 * (w1135 * w2074 - w2070 / w353) + w354 * w2077 + (w795 * (w1133 * w2074 - w2071 / w353) + w360 * w2078)
    w2080 = w362 * -2.0
    w2081 = w28 * -2.0
    w2082 = w2007 - w3 * (w2009 - w2080) - w777 * w2000 + w788 * (w1994 + w2081)
    w2083 = w2079 + (w796 * (w1131 * w2074 - w2072 / w353) + w375 * w2082) + w797 * (w1130 * w2074 - w2073 / w353)
    w2084 = w2083 / w353 + w1129 * w2074
    w2085 = w794 * w2030 + w236 * w2077 + (w795 * w2031 + w261 * w2078) + (w796 * w2032 + w275 * w2082) + w797 * w2033
    w2086 = w794 * w2062 + w341 * w2077 + (w795 * w2063 + w343 * w2078) + (w796 * w2065 + w345 * w2082) + w797 * w2067
    w2087 = (w798 * w2069 + w348 * w2084 - w2086) / w340 + w1160 * w2061
    w2088 = w794 * w2042 + w311 * w2077 + (w795 * w2043 + w313 * w2078) + (w796 * w2045 + w315 * w2082) + w797 * w2047
    w2089 = (w798 * w2049 + w318 * w2084 - w2088 - (w1000 * w2056 + w335 * w2087)) / w310 + w1186 * w2041
    w2090 = w798 * w2034 + w289 * w2084 - w2085 - (w1000 * w2051 + w330 * w2087) - (w1004 * w2036 + w305 * w2089)
    w2091 = hinge0_angle_dot * (w2090 / w235 + w1208 * w2029)
    w2092 = w68 * w2091
    w2093 = w67 * w161 - w66 * w157
    w2094 = w67 * w186 - w66 * w183
    w2095 = w67 * w199 - w66 * w197
    w2096 = w67 * w232 - w66 * w231
    w2097 = (w1227 * w2093 + w1225 * w2094 + w1223 * w2095 + w1207 * w2096) / w1220
    w2098 = w2093 / w235 - w1216 * w2097
    w2099 = w2094 / w235 - w1213 * w2097
    w2100 = w2095 / w235 - w1210 * w2097
    w2101 = w2096 / w235 - w1209 * w2097
    w2102 = w130 * w2098 + w260 * w2099 + w274 * w2100 + w287 * w2101
    w2103 = w236 * w2102 + w289 * w2098
    w2104 = w301 * w2098 + w302 * w2099 + w303 * w2100 + w304 * w2101
    w2105 = w236 * w2104 + w305 * w2098
    w2106 = w261 * w2104 + w305 * w2099
    w2107 = w275 * w2104 + w305 * w2100
    w2108 = w288 * w2104 + w305 * w2101
    w2109 = (w1202 * w2105 + w1200 * w2106 + w1198 * w2107 + w1185 * w2108) / w1195
    w2110 = w1192 * w2109 - w2105 / w310
    w2111 = w1190 * w2109 - w2106 / w310
    w2112 = w261 * w2102 + w289 * w2099
    w2113 = w1188 * w2109 - w2107 / w310
    w2114 = w275 * w2102 + w289 * w2100
    w2115 = w1187 * w2109 - w2108 / w310
    w2116 = w288 * w2102 + w289 * w2101
    w2117 = w290 * w2110 - w311 * w2103 + (w312 * w2111 - w313 * w2112) + (w314 * w2113 - w315 * w2114) + (w316 * w2115 - w317 * w2116)
    w2118 = w2103 + (w311 * w2117 + w318 * w2110)
    w2119 = w326 * w2098 + w327 * w2099 + w328 * w2100 + w329 * w2101
    w2120 = w236 * w2119 + w330 * w2098
    w2121 = w261 * w2119 + w330 * w2099
    w2122 = w275 * w2119 + w330 * w2100
    w2123 = w288 * w2119 + w330 * w2101
    w2124 = w331 * w2110 - w311 * w2120 + (w332 * w2111 - w313 * w2121) + (w333 * w2113 - w315 * w2122) + (w334 * w2115 - w317 * w2123)
    w2125 = w2120 + (w311 * w2124 + w335 * w2110)
    w2126 = w2121 + (w313 * w2124 + w335 * w2111)
    w2127 = w2122 + (w315 * w2124 + w335 * w2113)
    w2128 = w2123 + (w317 * w2124 + w335 * w2115)
    w2129 = (w1176 * w2125 + w1174 * w2126 + w1172 * w2127 + w1159 * w2128) / w1169
    w2130 = w1166 * w2129 - w2125 / w340
    w2131 = w1164 * w2129 - w2126 / w340
    w2132 = w2112 + (w313 * w2117 + w318 * w2111)
    w2133 = w1162 * w2129 - w2127 / w340
    w2134 = w2114 + (w315 * w2117 + w318 * w2113)
    w2135 = w1161 * w2129 - w2128 / w340
    w2136 = w2116 + (w317 * w2117 + w318 * w2115)
    w2137 = w319 * w2130 - w341 * w2118 + (w342 * w2131 - w343 * w2132) + (w344 * w2133 - w345 * w2134) + (w346 * w2135 - w347 * w2136)
    w2138 = w2118 + (w341 * w2137 + w348 * w2130)
    w2139 = w2132 + (w343 * w2137 + w348 * w2131)
    w2140 = w2134 + (w345 * w2137 + w348 * w2133)
    w2141 = w2136 + (w347 * w2137 + w348 * w2135)
    w2142 = (w1145 * w2138 + w1143 * w2139 + w1141 * w2140 + w1128 * w2141) / w1138
    w2143 = w24 * c10
    w2144 = w45 * w2143
    w2145 = w23 * c10
    w2146 = w24 * w2145
    w2147 = w24 * w2143
    w2148 = w22 * w2145
    w2149 = w22 * w2143
    w2150 = w27 * w2145
    w2151 = w3 * (w2144 + w2146) - w754 * (w2147 + w23 * w2145) + w777 * (w37 * w2143 + (w2081 + w2148)) + w788 * (w2075 - w2149 - w2150)
    w2152 = bar1_e2 * c125
    w2153 = w24 * w2152
    w2154 = w364 * w2143
    w2155 = w27 * w2143
    w2156 = w2080 - w22 * w2152
    w2157 = w3 * (w2153 + (w1999 - w2154)) + w754 * (w2155 - w23 * w2152) - w777 * (w2147 + w2156) + w788 * (w2144 - w27 * w2152)
    w2158 = w794 * (w1135 * w2142 - w2138 / w353) + w354 * w2151 + (w795 * (w1133 * w2142 - w2139 / w353) + w360 * w2157)
    w2159 = w364 * w2145
    w2160 = w45 * w2145
    w2161 = w754 * (w2150 + w2153) - w3 * (w1995 + w2159 + w45 * w2152) - w777 * (w2146 + w37 * w2152) + w788 * (w2160 - w2156)
    w2162 = w2158 + (w796 * (w1131 * w2142 - w2140 / w353) + w375 * w2161) + w797 * (w1130 * w2142 - w2141 / w353)
    w2163 = w2162 / w353 + w1129 * w2142
    w2164 = w794 * w2098 + w236 * w2151 + (w795 * w2099 + w261 * w2157) + (w796 * w2100 + w275 * w2161) + w797 * w2101
    w2165 = w794 * w2130 + w341 * w2151 + (w795 * w2131 + w343 * w2157) + (w796 * w2133 + w345 * w2161) + w797 * w2135
    w2166 = (w798 * w2137 + w348 * w2163 - w2165) / w340 + w1160 * w2129
    w2167 = w794 * w2110 + w311 * w2151 + (w795 * w2111 + w313 * w2157) + (w796 * w2113 + w315 * w2161) + w797 * w2115
    w2168 = (w798 * w2117 + w318 * w2163 - w2167 - (w1000 * w2124 + w335 * w2166)) / w310 + w1186 * w2109
    w2169 = w798 * w2102 + w289 * w2163 - w2164 - (w1000 * w2119 + w330 * w2166) - (w1004 * w2104 + w305 * w2168)
    w2170 = hinge0_angle_dot * (w2169 / w235 - w1208 * w2097)
    w2171 = w68 * w2170
    w2172 = w67 * w1941
    w2173 = w67 * w163 - w66 * w152
    w2174 = w67 * w188 - w66 * w181
    w2175 = w67 * w201 - w66 * w195
    w2176 = w66 * w230 + w67 * w233
    w2177 = (w1227 * w2173 + w1225 * w2174 + w1223 * w2175 - w1207 * w2176) / w1220
    w2178 = w2173 / w235 - w1216 * w2177
    w2179 = w2174 / w235 - w1213 * w2177
    w2180 = w2175 / w235 - w1210 * w2177
    w2181 = w2176 / w235 + w1209 * w2177
    w2182 = w130 * w2178 + w260 * w2179 + w274 * w2180 - w287 * w2181
    w2183 = w236 * w2182 + w289 * w2178
    w2184 = w301 * w2178 + w302 * w2179 + w303 * w2180 - w304 * w2181
    w2185 = w236 * w2184 + w305 * w2178
    w2186 = w261 * w2184 + w305 * w2179
    w2187 = w275 * w2184 + w305 * w2180
    w2188 = w288 * w2184 - w305 * w2181
    w2189 = (w1202 * w2185 + w1200 * w2186 + w1198 * w2187 + w1185 * w2188) / w1195
    w2190 = w1192 * w2189 - w2185 / w310
    w2191 = w1190 * w2189 - w2186 / w310
    w2192 = w261 * w2182 + w289 * w2179
    w2193 = w1188 * w2189 - w2187 / w310
    w2194 = w275 * w2182 + w289 * w2180
    w2195 = w1187 * w2189 - w2188 / w310
    w2196 = w288 * w2182 - w289 * w2181
    w2197 = w290 * w2190 - w311 * w2183 + (w312 * w2191 - w313 * w2192) + (w314 * w2193 - w315 * w2194) + (w316 * w2195 - w317 * w2196)
    w2198 = w2183 + (w311 * w2197 + w318 * w2190)
    w2199 = w326 * w2178 + w327 * w2179 + w328 * w2180 - w329 * w2181
    w2200 = w236 * w2199 + w330 * w2178
    w2201 = w261 * w2199 + w330 * w2179
    w2202 = w275 * w2199 + w330 * w2180
    w2203 = w288 * w2199 - w330 * w2181
    w2204 = w331 * w2190 - w311 * w2200 + (w332 * w2191 - w313 * w2201) + (w333 * w2193 - w315 * w2202) + (w334 * w2195 - w317 * w2203)
    w2205 = w2200 + (w311 * w2204 + w335 * w2190)
    w2206 = w2201 + (w313 * w2204 + w335 * w2191)
    w2207 = w2202 + (w315 * w2204 + w335 * w2193)
    w2208 = w2203 + (w317 * w2204 + w335 * w2195)
    w2209 = (w1176 * w2205 + w1174 * w2206 + w1172 * w2207 + w1159 * w2208) / w1169
    w2210 = w1166 * w2209 - w2205 / w340
    w2211 = w1164 * w2209 - w2206 / w340
    w2212 = w2192 + (w313 * w2197 + w318 * w2191)
    w2213 = w1162 * w2209 - w2207 / w340
    w2214 = w2194 + (w315 * w2197 + w318 * w2193)
    w2215 = w1161 * w2209 - w2208 / w340
    w2216 = w2196 + (w317 * w2197 + w318 * w2195)
    w2217 = w319 * w2210 - w341 * w2198 + (w342 * w2211 - w343 * w2212) + (w344 * w2213 - w345 * w2214) + (w346 * w2215 - w347 * w2216)
    w2218 = w2198 + (w341 * w2217 + w348 * w2210)
    w2219 = w2212 + (w343 * w2217 + w348 * w2211)
    w2220 = w2214 + (w345 * w2217 + w348 * w2213)
    w2221 = w2216 + (w347 * w2217 + w348 * w2215)
    w2222 = (w1145 * w2218 + w1143 * w2219 + w1141 * w2220 + w1128 * w2221) / w1138
    w2223 = w2081 + w2155
    w2224 = w754 * (w2146 - w23 * w2143) - w3 * (w2160 - w2147) - w777 * (w1999 + w37 * w2145 - w2149) + w788 * (w2148 - w2223)
    w2225 = bar1_e3 * c125
    w2226 = w24 * w2225
    w2227 = w22 * w2225
    w2228 = w3 * (w2159 + w2226) - w754 * (w23 * w2225 + (w2075 + w2150)) + w777 * (w2146 + w2227) + w788 * (w2080 - w27 * w2225 - w2160)
    w2229 = w794 * (w1135 * w2222 - w2218 / w353) + w354 * w2224 + (w795 * (w1133 * w2222 - w2219 / w353) + w360 * w2228)
    w2230 = w754 * (w2223 + w2226) - w3 * (w2154 + w45 * w2225) - w777 * (w2147 - (w2008 - w37 * w2225)) + w788 * (w2144 + w2227)
    w2231 = w2229 + (w796 * (w1131 * w2222 - w2220 / w353) + w375 * w2230) + w797 * (w1130 * w2222 - w2221 / w353)
    w2232 = w2231 / w353 + w1129 * w2222
    w2233 = w794 * w2178 + w236 * w2224 + (w795 * w2179 + w261 * w2228) + (w796 * w2180 + w275 * w2230) - w797 * w2181
    w2234 = w794 * w2210 + w341 * w2224 + (w795 * w2211 + w343 * w2228) + (w796 * w2213 + w345 * w2230) + w797 * w2215
    w2235 = (w798 * w2217 + w348 * w2232 - w2234) / w340 + w1160 * w2209
    w2236 = w794 * w2190 + w311 * w2224 + (w795 * w2191 + w313 * w2228) + (w796 * w2193 + w315 * w2230) + w797 * w2195
    w2237 = (w798 * w2197 + w318 * w2232 - w2236 - (w1000 * w2204 + w335 * w2235)) / w310 + w1186 * w2189
    w2238 = w798 * w2182 + w289 * w2232 - w2233 - (w1000 * w2199 + w330 * w2235) - (w1004 * w2184 + w305 * w2237)
    w2239 = hinge0_angle_dot * (w2238 / w235 - w1208 * w2177)
    w2240 = w2172 + w68 * w2239
    w2241 = 2 * w57
    w2242 = w155 * c15
    w2243 = w52 * w2242
    w2244 = w2241 + w2243
    w2245 = w134 * w2242
    w2246 = 2 * w62
    w2247 = w2245 - w2246
    w2248 = w159 * w2242
    w2249 = w162 * w2248
    w2250 = w51 * w2242
    w2251 = w158 * w2244 - w153 * w2247 - w2249 + w68 * w2250
    w2252 = w159 * c15
    w2253 = w51 * w2252
    w2254 = w2244 + w2253
    w2255 = 2 * w174
    w2256 = w52 * w2252
    w2257 = w2255 - w2256
    w2258 = w2257 - w54 * w2242
    w2259 = w58 * w2242
    w2260 = w155 * w2252 + w2259
    w2261 = w58 * w2252
    w2262 = w2245 + w2261
    w2263 = w162 * w2254 - (w153 * w2258 + w158 * w2260) - w68 * w2262
    w2264 = w134 * w2252
    w2265 = w153 * w2264
    w2266 = w159 * w2252
    w2267 = w2246 + w2266
    w2268 = w68 * w2253 - (w2265 + w158 * w2257 + w162 * w2267)
    w2269 = (w1227 * w2251 + w1225 * w2263 + w1223 * w2268) / w1220
    w2270 = w2251 / w235 - w1216 * w2269
    w2271 = w2263 / w235 - w1213 * w2269
    w2272 = w2268 / w235 - w1210 * w2269
    w2273 = w1209 * w2269
    w2274 = w130 * w2270 + w260 * w2271 + w274 * w2272 - w287 * w2273
    w2275 = w236 * w2274 + w289 * w2270
    w2276 = w150 * w292 - (w141 * w296 + w145 * w295 + w133 * w294)
    w2277 = w180 * w292 - (w178 * w296 + w179 * w295 + w170 * w294)
    w2278 = w194 * w292 - (w192 * w296 + w193 * w295 + w190 * w294)
    w2279 = w226 * w296 + w227 * w295 + w228 * w294 - w229 * w292
    w2280 = w236 * w2276 + w301 * w2270 + (w261 * w2277 + w302 * w2271) + (w275 * w2278 + w303 * w2272) + (w288 * w2279 - w304 * w2273)
    w2281 = w2276 - (w236 * w2280 + w305 * w2270)
    w2282 = w2277 - (w261 * w2280 + w305 * w2271)
    w2283 = w2278 - (w275 * w2280 + w305 * w2272)
    w2284 = w2279 - (w288 * w2280 - w305 * w2273)
    w2285 = (w1202 * w2281 + w1200 * w2282 + w1198 * w2283 + w1185 * w2284) / w1195
    w2286 = w2281 / w310 - w1192 * w2285
    w2287 = w2282 / w310 - w1190 * w2285
    w2288 = w261 * w2274 + w289 * w2271
    w2289 = w2283 / w310 - w1188 * w2285
    w2290 = w275 * w2274 + w289 * w2272
    w2291 = w2284 / w310 - w1187 * w2285
    w2292 = w288 * w2274 - w289 * w2273
    w2293 = w290 * w2286 - w311 * w2275 + (w312 * w2287 - w313 * w2288) + (w314 * w2289 - w315 * w2290) + (w316 * w2291 - w317 * w2292)
    w2294 = w2275 + (w311 * w2293 + w318 * w2286)
    w2295 = w326 * w2270 + w327 * w2271 + w328 * w2272 - w329 * w2273
    w2296 = w236 * w2295 + w330 * w2270
    w2297 = w261 * w2295 + w330 * w2271
    w2298 = w275 * w2295 + w330 * w2272
    w2299 = w288 * w2295 - w330 * w2273
    w2300 = w331 * w2286 - w311 * w2296 + (w332 * w2287 - w313 * w2297) + (w333 * w2289 - w315 * w2298) + (w334 * w2291 - w317 * w2299)
    w2301 = w2296 + (w311 * w2300 + w335 * w2286)
    w2302 = w2297 + (w313 * w2300 + w335 * w2287)
    w2303 = w2298 + (w315 * w2300 + w335 * w2289)
    w2304 = w2299 + (w317 * w2300 + w335 * w2291)
    w2305 = (w1176 * w2301 + w1174 * w2302 + w1172 * w2303 + w1159 * w2304) / w1169
    w2306 = w1166 * w2305 - w2301 / w340
    w2307 = w1164 * w2305 - w2302 / w340
    w2308 = w2288 + (w313 * w2293 + w318 * w2287)
    w2309 = w1162 * w2305 - w2303 / w340
    w2310 = w2290 + (w315 * w2293 + w318 * w2289)
    w2311 = w1161 * w2305 - w2304 / w340
    w2312 = w2292 + (w317 * w2293 + w318 * w2291)
    w2313 = w319 * w2306 - w341 * w2294 + (w342 * w2307 - w343 * w2308) + (w344 * w2309 - w345 * w2310) + (w346 * w2311 - w347 * w2312)
    w2314 = w2294 + (w341 * w2313 + w348 * w2306)
    w2315 = w2308 + (w343 * w2313 + w348 * w2307)
    w2316 = w2310 + (w345 * w2313 + w348 * w2309)
    w2317 = w2312 + (w347 * w2313 + w348 * w2311)
    w2318 = (w1145 * w2314 + w1143 * w2315 + w1141 * w2316 + w1128 * w2317) / w1138
    w2319 = w65 * w2248
    w2320 = w5 * w2248
    w2321 = w3 * (w65 * w2250 - w5 * w2247) + w754 * (w5 * w2244 + w2319) + w777 * (w65 * w2244 - w2320) + w788 * (w65 * w2247 + w5 * w2250)
    w2322 = w777 * (w5 * w2254 - w65 * w2260) - (w3 * (w5 * w2258 + w65 * w2262) + w754 * (w5 * w2260 + w65 * w2254))
    w2323 = w2322 - w788 * (w5 * w2262 - w65 * w2258)
    w2324 = w794 * (w1135 * w2318 - w2314 / w353) + w354 * w2321 + (w795 * (w1133 * w2318 - w2315 / w353) + w360 * w2323)
    w2325 = w5 * w2264
    w2326 = w3 * (w65 * w2253 - w2325) - w754 * (w5 * w2257 - w65 * w2267) - w777 * (w5 * w2267 + w65 * w2257)
    w2327 = w65 * w2264
    w2328 = w2326 + w788 * (w2327 + w5 * w2253)
    w2329 = w2324 + (w796 * (w1131 * w2318 - w2316 / w353) + w375 * w2328) + w797 * (w1130 * w2318 - w2317 / w353)
    w2330 = w2329 / w353 + w1129 * w2318
    w2331 = w794 * w2270 + w236 * w2321 + (w795 * w2271 + w261 * w2323) + (w796 * w2272 + w275 * w2328) - w797 * w2273
    w2332 = w794 * w2306 + w341 * w2321 + (w795 * w2307 + w343 * w2323) + (w796 * w2309 + w345 * w2328) + w797 * w2311
    w2333 = (w798 * w2313 + w348 * w2330 - w2332) / w340 + w1160 * w2305
    w2334 = w794 * w2286 + w311 * w2321 + (w795 * w2287 + w313 * w2323) + (w796 * w2289 + w315 * w2328) + w797 * w2291
    w2335 = (w798 * w2293 + w318 * w2330 - w2334 - (w1000 * w2300 + w335 * w2333)) / w310 - w1186 * w2285
    w2336 = w798 * w2274 + w289 * w2330 - w2331 - (w1000 * w2295 + w330 * w2333) - (w1004 * w2280 + w305 * w2335)
    w2337 = hinge0_angle_dot * (w2336 / w235 - w1208 * w2269)
    w2338 = w68 * w2337
    w2339 = w52 * c15
    w2340 = w52 * w2339
    w2341 = bar2_e1 * c126
    w2342 = w2340 - (w2246 - w155 * w2341)
    w2343 = w57 * -2.0
    w2344 = w134 * w2339
    w2345 = w2343 + w2344
    w2346 = w52 * w2341
    w2347 = w2345 + w2346
    w2348 = w159 * w2339
    w2349 = w2348 + w51 * w2341
    w2350 = w51 * w2339
    w2351 = w58 * w2341
    w2352 = w2350 + w2351
    w2353 = w158 * w2342 - w153 * w2347 - w162 * w2349 + w68 * w2352
    w2354 = w54 * c15
    w2355 = w58 * w2339
    w2356 = w2255 + w155 * w2354 - w2355
    w2357 = w52 * w2354
    w2358 = w2357 - w54 * w2339
    w2359 = w51 * w2354
    w2360 = w2359 - w2340
    w2361 = w58 * w2354
    w2362 = w2361 - w2345
    w2363 = w158 * w2356 - w153 * w2358 - w162 * w2360 + w68 * w2362
    w2364 = w174 * -2.0
    w2365 = w134 * w2354
    w2366 = w54 * w2341 + (w2364 + w2365)
    w2367 = w2351 + w2357
    w2368 = w159 * w2354
    w2369 = w2346 + w2368
    w2370 = w62 * -2.0
    w2371 = w2370 - w134 * w2341 - w2359
    w2372 = w153 * w2366 - w158 * w2367 + w162 * w2369 + w68 * w2371
    w2373 = (w1227 * w2353 + w1225 * w2363 + w1223 * w2372) / w1220
    w2374 = w2353 / w235 - w1216 * w2373
    w2375 = w2363 / w235 - w1213 * w2373
    w2376 = w2372 / w235 - w1210 * w2373
    w2377 = w1209 * w2373
    w2378 = w130 * w2374 + w260 * w2375 + w274 * w2376 - w287 * w2377
    w2379 = w236 * w2378 + w289 * w2374
    w2380 = w150 * w294 - (w141 * w295 - w145 * w296 - w133 * w292)
    w2381 = w180 * w294 - (w178 * w295 - w179 * w296 - w170 * w292)
    w2382 = w194 * w294 - (w192 * w295 - w193 * w296 - w190 * w292)
    w2383 = w226 * w295 - w227 * w296 - w228 * w292 - w229 * w294
    w2384 = w236 * w2380 + w301 * w2374 + (w261 * w2381 + w302 * w2375) + (w275 * w2382 + w303 * w2376) + (w288 * w2383 - w304 * w2377)
    w2385 = w2380 - (w236 * w2384 + w305 * w2374)
    w2386 = w2381 - (w261 * w2384 + w305 * w2375)
    w2387 = w2382 - (w275 * w2384 + w305 * w2376)
    w2388 = w2383 - (w288 * w2384 - w305 * w2377)
    w2389 = (w1202 * w2385 + w1200 * w2386 + w1198 * w2387 + w1185 * w2388) / w1195
    w2390 = w2385 / w310 - w1192 * w2389
    w2391 = w2386 / w310 - w1190 * w2389
    w2392 = w261 * w2378 + w289 * w2375
    w2393 = w2387 / w310 - w1188 * w2389
    w2394 = w275 * w2378 + w289 * w2376
    w2395 = w2388 / w310 - w1187 * w2389
    w2396 = w288 * w2378 - w289 * w2377
    w2397 = w290 * w2390 - w311 * w2379 + (w312 * w2391 - w313 * w2392) + (w314 * w2393 - w315 * w2394) + (w316 * w2395 - w317 * w2396)
    w2398 = w2379 + (w311 * w2397 + w318 * w2390)
    w2399 = w326 * w2374 + w327 * w2375 + w328 * w2376 - w329 * w2377
    w2400 = w236 * w2399 + w330 * w2374
    w2401 = w261 * w2399 + w330 * w2375
    w2402 = w275 * w2399 + w330 * w2376
    w2403 = w288 * w2399 - w330 * w2377
    w2404 = w331 * w2390 - w311 * w2400 + (w332 * w2391 - w313 * w2401) + (w333 * w2393 - w315 * w2402) + (w334 * w2395 - w317 * w2403)
    w2405 = w2400 + (w311 * w2404 + w335 * w2390)
    w2406 = w2401 + (w313 * w2404 + w335 * w2391)
    w2407 = w2402 + (w315 * w2404 + w335 * w2393)
    w2408 = w2403 + (w317 * w2404 + w335 * w2395)
    w2409 = (w1176 * w2405 + w1174 * w2406 + w1172 * w2407 + w1159 * w2408) / w1169
    w2410 = w1166 * w2409 - w2405 / w340
    w2411 = w1164 * w2409 - w2406 / w340
    w2412 = w2392 + (w313 * w2397 + w318 * w2391)
    w2413 = w1162 * w2409 - w2407 / w340
    w2414 = w2394 + (w315 * w2397 + w318 * w2393)
    w2415 = w1161 * w2409 - w2408 / w340
    w2416 = w2396 + (w317 * w2397 + w318 * w2395)
    w2417 = w319 * w2410 - w341 * w2398 + (w342 * w2411 - w343 * w2412) + (w344 * w2413 - w345 * w2414) + (w346 * w2415 - w347 * w2416)
    w2418 = w2398 + (w341 * w2417 + w348 * w2410)
    w2419 = w2412 + (w343 * w2417 + w348 * w2411)
    w2420 = w2414 + (w345 * w2417 + w348 * w2413)
    w2421 = w2416 + (w347 * w2417 + w348 * w2415)
    w2422 = (w1145 * w2418 + w1143 * w2419 + w1141 * w2420 + w1128 * w2421) / w1138
    w2423 = w3 * (w65 * w2352 - w5 * w2347) + w754 * (w5 * w2342 + w65 * w2349) + w777 * (w65 * w2342 - w5 * w2349)
    w2424 = w2423 + w788 * (w65 * w2347 + w5 * w2352)
    w2425 = w3 * (w65 * w2362 - w5 * w2358) + w754 * (w5 * w2356 + w65 * w2360) + w777 * (w65 * w2356 - w5 * w2360)
    w2426 = w2425 + w788 * (w65 * w2358 + w5 * w2362)
    w2427 = w794 * (w1135 * w2422 - w2418 / w353) + w354 * w2424 + (w795 * (w1133 * w2422 - w2419 / w353) + w360 * w2426)
    w2428 = w3 * (w5 * w2366 + w65 * w2371) - w754 * (w5 * w2367 + w65 * w2369) + w777 * (w5 * w2369 - w65 * w2367)
    w2429 = w2428 - w788 * (w65 * w2366 - w5 * w2371)
    w2430 = w2427 + (w796 * (w1131 * w2422 - w2420 / w353) + w375 * w2429) + w797 * (w1130 * w2422 - w2421 / w353)
    w2431 = w2430 / w353 + w1129 * w2422
    w2432 = w794 * w2374 + w236 * w2424 + (w795 * w2375 + w261 * w2426) + (w796 * w2376 + w275 * w2429) - w797 * w2377
    w2433 = w794 * w2410 + w341 * w2424 + (w795 * w2411 + w343 * w2426) + (w796 * w2413 + w345 * w2429) + w797 * w2415
    w2434 = (w798 * w2417 + w348 * w2431 - w2433) / w340 + w1160 * w2409
    w2435 = w794 * w2390 + w311 * w2424 + (w795 * w2391 + w313 * w2426) + (w796 * w2393 + w315 * w2429) + w797 * w2395
    w2436 = (w798 * w2397 + w318 * w2431 - w2435 - (w1000 * w2404 + w335 * w2434)) / w310 - w1186 * w2389
    w2437 = w798 * w2378 + w289 * w2431 - w2432 - (w1000 * w2399 + w330 * w2434) - (w1004 * w2384 + w305 * w2436)
    w2438 = hinge0_angle_dot * (w2437 / w235 - w1208 * w2373)
    w2439 = w68 * w2438
    w2440 = w2266 - w2370
    w2441 = w2253 + w2343
    w2442 = w158 * w2256 - w2265 - w162 * w2440 + w68 * w2441
    w2443 = w155 * w2242 - w2261
    w2444 = w2243 - (w2241 + w54 * w2252)
    w2445 = w2250 + w2364
    w2446 = w2445 - w2256
    w2447 = w2259 - w2264
    w2448 = w158 * w2443 - w153 * w2444 - w162 * w2446 + w68 * w2447
    w2449 = w2246 - w2245
    w2450 = w2249 - (w153 * w2449 + w158 * w2243) - w68 * w2445
    w2451 = (w1227 * w2442 + w1225 * w2448 + w1223 * w2450) / w1220
    w2452 = w2442 / w235 - w1216 * w2451
    w2453 = w2448 / w235 - w1213 * w2451
    w2454 = w2450 / w235 - w1210 * w2451
    w2455 = w1209 * w2451
    w2456 = w130 * w2452 + w260 * w2453 + w274 * w2454 - w287 * w2455
    w2457 = w236 * w2456 + w289 * w2452
    w2458 = w150 * w295 - (w133 * w296 - (w141 * w294 + w145 * w292))
    w2459 = w180 * w295 - (w170 * w296 - (w178 * w294 + w179 * w292))
    w2460 = w194 * w295 - (w190 * w296 - (w192 * w294 + w193 * w292))
    w2461 = w228 * w296 - (w226 * w294 + w227 * w292) - w229 * w295
    w2462 = w236 * w2458 + w301 * w2452 + (w261 * w2459 + w302 * w2453) + (w275 * w2460 + w303 * w2454) + (w288 * w2461 - w304 * w2455)
    w2463 = w2458 - (w236 * w2462 + w305 * w2452)
    w2464 = w2459 - (w261 * w2462 + w305 * w2453)
    w2465 = w2460 - (w275 * w2462 + w305 * w2454)
    w2466 = w2461 - (w288 * w2462 - w305 * w2455)
    w2467 = (w1202 * w2463 + w1200 * w2464 + w1198 * w2465 + w1185 * w2466) / w1195
    w2468 = w2463 / w310 - w1192 * w2467
    w2469 = w2464 / w310 - w1190 * w2467
    w2470 = w261 * w2456 + w289 * w2453
    w2471 = w2465 / w310 - w1188 * w2467
    w2472 = w275 * w2456 + w289 * w2454
    w2473 = w2466 / w310 - w1187 * w2467
    w2474 = w288 * w2456 - w289 * w2455
    w2475 = w290 * w2468 - w311 * w2457 + (w312 * w2469 - w313 * w2470) + (w314 * w2471 - w315 * w2472) + (w316 * w2473 - w317 * w2474)
    w2476 = w2457 + (w311 * w2475 + w318 * w2468)
    w2477 = w326 * w2452 + w327 * w2453 + w328 * w2454 - w329 * w2455
    w2478 = w236 * w2477 + w330 * w2452
    w2479 = w261 * w2477 + w330 * w2453
    w2480 = w275 * w2477 + w330 * w2454
    w2481 = w288 * w2477 - w330 * w2455
    w2482 = w331 * w2468 - w311 * w2478 + (w332 * w2469 - w313 * w2479) + (w333 * w2471 - w315 * w2480) + (w334 * w2473 - w317 * w2481)
    w2483 = w2478 + (w311 * w2482 + w335 * w2468)
    w2484 = w2479 + (w313 * w2482 + w335 * w2469)
    w2485 = w2480 + (w315 * w2482 + w335 * w2471)
    w2486 = w2481 + (w317 * w2482 + w335 * w2473)
    w2487 = (w1176 * w2483 + w1174 * w2484 + w1172 * w2485 + w1159 * w2486) / w1169
    w2488 = w1166 * w2487 - w2483 / w340
    w2489 = w1164 * w2487 - w2484 / w340
    w2490 = w2470 + (w313 * w2475 + w318 * w2469)
    w2491 = w1162 * w2487 - w2485 / w340
    w2492 = w2472 + (w315 * w2475 + w318 * w2471)
    w2493 = w1161 * w2487 - w2486 / w340
    w2494 = w2474 + (w317 * w2475 + w318 * w2473)
    w2495 = w319 * w2488 - w341 * w2476 + (w342 * w2489 - w343 * w2490) + (w344 * w2491 - w345 * w2492) + (w346 * w2493 - w347 * w2494)
    w2496 = w2476 + (w341 * w2495 + w348 * w2488)
    w2497 = w2490 + (w343 * w2495 + w348 * w2489)
    w2498 = w2492 + (w345 * w2495 + w348 * w2491)
    w2499 = w2494 + (w347 * w2495 + w348 * w2493)
    w2500 = (w1145 * w2496 + w1143 * w2497 + w1141 * w2498 + w1128 * w2499) / w1138
    w2501 = w3 * (w65 * w2441 - w2325) + w754 * (w5 * w2256 + w65 * w2440) + w777 * (w65 * w2256 - w5 * w2440)
    w2502 = w2501 + w788 * (w2327 + w5 * w2441)
    w2503 = w3 * (w65 * w2447 - w5 * w2444) + w754 * (w5 * w2443 + w65 * w2446) + w777 * (w65 * w2443 - w5 * w2446)
    w2504 = w2503 + w788 * (w65 * w2444 + w5 * w2447)
    w2505 = w794 * (w1135 * w2500 - w2496 / w353) + w354 * w2502 + (w795 * (w1133 * w2500 - w2497 / w353) + w360 * w2504)
    w2506 = w777 * (w2320 - w65 * w2243) - (w3 * (w5 * w2449 + w65 * w2445) + w754 * (w2319 + w5 * w2243)) - w788 * (w5 * w2445 - w65 * w2449)
    w2507 = w2505 + (w796 * (w1131 * w2500 - w2498 / w353) + w375 * w2506) + w797 * (w1130 * w2500 - w2499 / w353)
    w2508 = w2507 / w353 + w1129 * w2500
    w2509 = w794 * w2452 + w236 * w2502 + (w795 * w2453 + w261 * w2504) + (w796 * w2454 + w275 * w2506) - w797 * w2455
    w2510 = w794 * w2488 + w341 * w2502 + (w795 * w2489 + w343 * w2504) + (w796 * w2491 + w345 * w2506) + w797 * w2493
    w2511 = (w798 * w2495 + w348 * w2508 - w2510) / w340 + w1160 * w2487
    w2512 = w794 * w2468 + w311 * w2502 + (w795 * w2469 + w313 * w2504) + (w796 * w2471 + w315 * w2506) + w797 * w2473
    w2513 = (w798 * w2475 + w318 * w2508 - w2512 - (w1000 * w2482 + w335 * w2511)) / w310 - w1186 * w2467
    w2514 = w798 * w2456 + w289 * w2508 - w2509 - (w1000 * w2477 + w330 * w2511) - (w1004 * w2462 + w305 * w2513)
    w2515 = hinge0_angle_dot * (w2514 / w235 - w1208 * w2451)
    w2516 = w68 * w2515
    w2517 = w788 * w2024 - w777 * w2092 + w754 * w2171 - w3 * w2240 + w1419 * w2338 - w1435 * w2439 + w1446 * w2516
    w2518 = bar2_e3 * c126
    w2519 = w2357 + w155 * w2518
    w2520 = w52 * w2518
    w2521 = w2365 + w2520
    w2522 = w2241 + w2368 + w51 * w2518
    w2523 = w2370 - w58 * w2518
    w2524 = w2359 - w2523
    w2525 = w158 * w2519 - w153 * w2521 - w162 * w2522 + w68 * w2524
    w2526 = w2340 + w54 * w2354
    w2527 = w155 * w2339 + (w2343 + w2361)
    w2528 = w2350 + w2357
    w2529 = w2364 - w2355 - w2365
    w2530 = w153 * w2526 - w158 * w2527 + w162 * w2528 + w68 * w2529
    w2531 = w2340 + w2523
    w2532 = w2344 - w54 * w2518
    w2533 = w2520 + (w2255 - w2348)
    w2534 = w2350 - w134 * w2518
    w2535 = w158 * w2531 - w153 * w2532 + w162 * w2533 + w68 * w2534
    w2536 = (w1227 * w2525 + w1225 * w2530 + w1223 * w2535) / w1220
    w2537 = w2525 / w235 - w1216 * w2536
    w2538 = w2530 / w235 - w1213 * w2536
    w2539 = w2535 / w235 - w1210 * w2536
    w2540 = w1209 * w2536
    w2541 = w130 * w2537 + w260 * w2538 + w274 * w2539 - w287 * w2540
    w2542 = w236 * w2541 + w289 * w2537
    w2543 = w150 * w296 - (w145 * w294 - w141 * w292 - w133 * w295)
    w2544 = w180 * w296 - (w179 * w294 - w178 * w292 - w170 * w295)
    w2545 = w194 * w296 - (w193 * w294 - w192 * w292 - w190 * w295)
    w2546 = w227 * w294 - w226 * w292 - w228 * w295 - w229 * w296
    w2547 = w236 * w2543 + w301 * w2537 + (w261 * w2544 + w302 * w2538) + (w275 * w2545 + w303 * w2539) + (w288 * w2546 - w304 * w2540)
    w2548 = w2543 - (w236 * w2547 + w305 * w2537)
    w2549 = w2544 - (w261 * w2547 + w305 * w2538)
    w2550 = w2545 - (w275 * w2547 + w305 * w2539)
    w2551 = w2546 - (w288 * w2547 - w305 * w2540)
    w2552 = (w1202 * w2548 + w1200 * w2549 + w1198 * w2550 + w1185 * w2551) / w1195
    w2553 = w2548 / w310 - w1192 * w2552
    w2554 = w2549 / w310 - w1190 * w2552
    w2555 = w261 * w2541 + w289 * w2538
    w2556 = w2550 / w310 - w1188 * w2552
    w2557 = w275 * w2541 + w289 * w2539
    w2558 = w2551 / w310 - w1187 * w2552
    w2559 = w288 * w2541 - w289 * w2540
    w2560 = w290 * w2553 - w311 * w2542 + (w312 * w2554 - w313 * w2555) + (w314 * w2556 - w315 * w2557) + (w316 * w2558 - w317 * w2559)
    w2561 = w2542 + (w311 * w2560 + w318 * w2553)
    w2562 = w326 * w2537 + w327 * w2538 + w328 * w2539 - w329 * w2540
    w2563 = w236 * w2562 + w330 * w2537
    w2564 = w261 * w2562 + w330 * w2538
    w2565 = w275 * w2562 + w330 * w2539
    w2566 = w288 * w2562 - w330 * w2540
    w2567 = w331 * w2553 - w311 * w2563 + (w332 * w2554 - w313 * w2564) + (w333 * w2556 - w315 * w2565) + (w334 * w2558 - w317 * w2566)
    w2568 = w2563 + (w311 * w2567 + w335 * w2553)
    w2569 = w2564 + (w313 * w2567 + w335 * w2554)
    w2570 = w2565 + (w315 * w2567 + w335 * w2556)
    w2571 = w2566 + (w317 * w2567 + w335 * w2558)
    w2572 = (w1176 * w2568 + w1174 * w2569 + w1172 * w2570 + w1159 * w2571) / w1169
    w2573 = w1166 * w2572 - w2568 / w340
    w2574 = w1164 * w2572 - w2569 / w340
    w2575 = w2555 + (w313 * w2560 + w318 * w2554)
    w2576 = w1162 * w2572 - w2570 / w340
    w2577 = w2557 + (w315 * w2560 + w318 * w2556)
    w2578 = w1161 * w2572 - w2571 / w340
    w2579 = w2559 + (w317 * w2560 + w318 * w2558)
    w2580 = w319 * w2573 - w341 * w2561 + (w342 * w2574 - w343 * w2575) + (w344 * w2576 - w345 * w2577) + (w346 * w2578 - w347 * w2579)
    w2581 = w2561 + (w341 * w2580 + w348 * w2573)
    w2582 = w2575 + (w343 * w2580 + w348 * w2574)
    w2583 = w2577 + (w345 * w2580 + w348 * w2576)
    w2584 = w2579 + (w347 * w2580 + w348 * w2578)
    w2585 = (w1145 * w2581 + w1143 * w2582 + w1141 * w2583 + w1128 * w2584) / w1138
    w2586 = w3 * (w65 * w2524 - w5 * w2521) + w754 * (w5 * w2519 + w65 * w2522) + w777 * (w65 * w2519 - w5 * w2522)
    w2587 = w2586 + w788 * (w65 * w2521 + w5 * w2524)
    w2588 = w3 * (w5 * w2526 + w65 * w2529) - w754 * (w5 * w2527 + w65 * w2528) + w777 * (w5 * w2528 - w65 * w2527)
    w2589 = w2588 - w788 * (w65 * w2526 - w5 * w2529)
    w2590 = w794 * (w1135 * w2585 - w2581 / w353) + w354 * w2587 + (w795 * (w1133 * w2585 - w2582 / w353) + w360 * w2589)
    w2591 = w3 * (w65 * w2534 - w5 * w2532) - w754 * (w65 * w2533 - w5 * w2531) + w777 * (w5 * w2533 + w65 * w2531)
    w2592 = w2591 + w788 * (w65 * w2532 + w5 * w2534)
    w2593 = w2590 + (w796 * (w1131 * w2585 - w2583 / w353) + w375 * w2592) + w797 * (w1130 * w2585 - w2584 / w353)
    w2594 = w2593 / w353 + w1129 * w2585
    w2595 = w794 * w2537 + w236 * w2587 + (w795 * w2538 + w261 * w2589) + (w796 * w2539 + w275 * w2592) - w797 * w2540
    w2596 = w794 * w2573 + w341 * w2587 + (w795 * w2574 + w343 * w2589) + (w796 * w2576 + w345 * w2592) + w797 * w2578
    w2597 = (w798 * w2580 + w348 * w2594 - w2596) / w340 + w1160 * w2572
    w2598 = w794 * w2553 + w311 * w2587 + (w795 * w2554 + w313 * w2589) + (w796 * w2556 + w315 * w2592) + w797 * w2558
    w2599 = (w798 * w2560 + w318 * w2594 - w2598 - (w1000 * w2567 + w335 * w2597)) / w310 - w1186 * w2552
    w2600 = w798 * w2541 + w289 * w2594 - w2595 - (w1000 * w2562 + w330 * w2597) - (w1004 * w2547 + w305 * w2599)
    w2601 = hinge0_angle_dot * (w2600 / w235 - w1208 * w2536)
    w2602 = w68 * w2601
    w2603 = w144 * c63
    w2604 = w14 * w2603
    w2605 = w8 * w2604
    w2606 = 2 * w131
    w2607 = w144 * w2603
    w2608 = w2606 + w2607
    w2609 = 2 * w132
    w2610 = w17 * w2603
    w2611 = w2609 - w2610
    w2612 = w148 * w2603
    w2613 = w2605 - (w147 * w2608 - w142 * w2611) + w151 * w2612
    w2614 = w151 * w2604
    w2615 = w8 * w2612 - (w147 * w2611 + w142 * w2608 + w2614)
    w2616 = w142 * w2604
    w2617 = w151 * w2608 + w8 * w2611 - w2616 + w147 * w2612
    w2618 = w147 * w2604
    w2619 = w8 * w2608 - w151 * w2611 + w2618 + w142 * w2612
    w2620 = w153 * w2613 - w158 * w2615 + w162 * w2617 + w68 * w2619
    w2621 = w15 * c63
    w2622 = w14 * w2621
    w2623 = w2622 - w2606
    w2624 = 2 * w168
    w2625 = w17 * w2621
    w2626 = w2624 + w2625
    w2627 = w144 * w2621
    w2628 = w147 * w2627
    w2629 = w148 * w2621
    w2630 = w8 * w2623 - (w142 * w2626 + w2628) + w151 * w2629
    w2631 = w142 * w2627
    w2632 = w147 * w2626 - w2631 - w151 * w2623 + w8 * w2629
    w2633 = w151 * w2627
    w2634 = w2633 - w8 * w2626 - w142 * w2623 + w147 * w2629
    w2635 = w8 * w2627
    w2636 = w151 * w2626 + w2635 + w147 * w2623 + w142 * w2629
    w2637 = w153 * w2630 - w158 * w2632 + w162 * w2634 + w68 * w2636
    w2638 = w2611 - w9 * w2621
    w2639 = w138 * w2621
    w2640 = w15 * w2603 + w2639
    w2641 = w2612 + w2626
    w2642 = w138 * w2603
    w2643 = w2622 + w2642
    w2644 = w8 * w2638 + (w142 * w2640 + w147 * w2641) - w151 * w2643
    w2645 = w142 * w2641 - w147 * w2640 - w151 * w2638 - w8 * w2643
    w2646 = w8 * w2640 - w151 * w2641 - w142 * w2638 - w147 * w2643
    w2647 = w147 * w2638 - (w151 * w2640 + w8 * w2641) - w142 * w2643
    w2648 = w153 * w2644 - w158 * w2645 + w162 * w2646 + w68 * w2647
    w2649 = w9 * w209 + w15 * w214
    w2650 = w15 * w217
    w2651 = 2 * w225
    w2652 = w9 * w217
    w2653 = w17 * w2652
    w2654 = w15 * w2649 - w138 * w2650 + (w2651 - w2653)
    w2655 = 2 * w222
    w2656 = w17 * w2650
    w2657 = w148 * w2649 + (w2655 - w2656) - w144 * w2652
    w2658 = 2 * w216
    w2659 = w14 * w2652
    w2660 = w17 * w2649 + w2658 - w9 * w2650 - w2659
    w2661 = w14 * w2650
    w2662 = w138 * w2649 - w2661 - w148 * w2652
    w2663 = w142 * w2654 + w147 * w2657 - w8 * w2660 - w151 * w2662
    w2664 = w142 * w2657 - w147 * w2654 + w151 * w2660 - w8 * w2662
    w2665 = w8 * w2654 - w151 * w2657 + w142 * w2660 - w147 * w2662
    w2666 = w151 * w2654 + w8 * w2657 + w147 * w2660 + w142 * w2662
    w2667 = w153 * w2663 - w158 * w2664 + w162 * w2665 - w68 * w2666
    w2668 = (w1227 * w2620 + w1225 * w2637 + w1223 * w2648 + w1207 * w2667) / w1220
    w2669 = w2620 / w235 - w1216 * w2668
    w2670 = w2637 / w235 - w1213 * w2668
    w2671 = w2648 / w235 - w1210 * w2668
    w2672 = w72 * w2652
    w2673 = w105 * w2650 - w207 * w2649 + w2672
    w2674 = w76 * w2650
    w2675 = w2674 - w105 * w2649 + w109 * w2652
    w2676 = w72 * w2650
    w2677 = w2676 - w109 * w2649 + w70 * w2652
    w2678 = w76 * w2652
    w2679 = w69 * w2650 - w72 * w2649 + w2678
    w2680 = w119 * (w86 * w2673 + w83 * w2675) + w104 * (w86 * w2677 - w83 * w2679) - w124 * (w83 * w2677 + w86 * w2679)
    w2681 = w2680 - w129 * (w86 * w2675 - w83 * w2673)
    w2682 = w2667 / w235 - w1209 * w2668
    w2683 = w130 * w2669 + w260 * w2670 + w274 * w2671 + (w288 * w2681 + w287 * w2682)
    w2684 = w3 * (w5 * w2613 + w65 * w2619) - w754 * (w5 * w2615 + w65 * w2617) + w777 * (w5 * w2617 - w65 * w2615)
    w2685 = w2684 - w788 * (w65 * w2613 - w5 * w2619)
    w2686 = w236 * w2683 + w289 * w2669
    w2687 = w300 * w2604
    w2688 = w297 * w2612 - (w299 * w2608 - w298 * w2611 + w2687)
    w2689 = w299 * w2627
    w2690 = w297 * w2629 - (w298 * w2626 + w2689 + w300 * w2623)
    w2691 = w297 * w2643 + (w300 * w2638 - (w298 * w2640 + w299 * w2641))
    w2692 = w298 * w2654 + w299 * w2657 + w300 * w2660 - w297 * w2662
    w2693 = w236 * w2688 + w301 * w2669 + (w261 * w2690 + w302 * w2670) + (w303 * w2671 - w275 * w2691) + (w288 * w2692 + w304 * w2682)
    w2694 = w2688 - (w236 * w2693 + w305 * w2669)
    w2695 = w2690 - (w261 * w2693 + w305 * w2670)
    w2696 = w2691 + (w275 * w2693 + w305 * w2671)
    w2697 = w2692 - (w288 * w2693 + w305 * w2682)
    w2698 = (w1202 * w2694 + w1200 * w2695 - w1198 * w2696 + w1185 * w2697) / w1195
    w2699 = w2694 / w310 - w1192 * w2698
    w2700 = w2695 / w310 - w1190 * w2698
    w2701 = w261 * w2683 + w289 * w2670
    w2702 = w275 * w2683 + w289 * w2671
    w2703 = w2696 / w310 + w1188 * w2698
    w2704 = w2681 - (w288 * w2683 + w289 * w2682)
    w2705 = w2697 / w310 - w1187 * w2698
    w2706 = w290 * w2699 - w311 * w2686 + (w312 * w2700 - w313 * w2701) - (w315 * w2702 + w314 * w2703) + (w317 * w2704 + w316 * w2705)
    w2707 = w2686 + (w311 * w2706 + w318 * w2699)
    w2708 = w2704 - (w317 * w2706 + w318 * w2705)
    w2709 = w323 * w2677 - w322 * w2673 - w324 * w2679 + w325 * w2675
    w2710 = w326 * w2669 + w327 * w2670 + w328 * w2671 + (w288 * w2709 + w329 * w2682)
    w2711 = w2709 - (w288 * w2710 + w330 * w2682)
    w2712 = w236 * w2710 + w330 * w2669
    w2713 = w261 * w2710 + w330 * w2670
    w2714 = w275 * w2710 + w330 * w2671
    w2715 = w331 * w2699 - w311 * w2712 + (w332 * w2700 - w313 * w2713) - (w315 * w2714 + w333 * w2703) + (w317 * w2711 + w334 * w2705)
    w2716 = w2711 - (w317 * w2715 + w335 * w2705)
    w2717 = w2712 + (w311 * w2715 + w335 * w2699)
    w2718 = w2713 + (w313 * w2715 + w335 * w2700)
    w2719 = w2714 + (w315 * w2715 - w335 * w2703)
    w2720 = (w1159 * w2716 - (w1176 * w2717 + w1174 * w2718 + w1172 * w2719)) / w1169
    w2721 = w2716 / w340 - w1161 * w2720
    w2722 = w2717 / w340 + w1166 * w2720
    w2723 = w2701 + (w313 * w2706 + w318 * w2700)
    w2724 = w2718 / w340 + w1164 * w2720
    w2725 = w2702 + (w315 * w2706 - w318 * w2703)
    w2726 = w2719 / w340 + w1162 * w2720
    w2727 = w347 * w2708 + w346 * w2721 - (w341 * w2707 + w319 * w2722 + (w343 * w2723 + w342 * w2724) + (w345 * w2725 + w344 * w2726))
    w2728 = w2707 + (w341 * w2727 - w348 * w2722)
    w2729 = w2708 - (w347 * w2727 + w348 * w2721)
    w2730 = w2723 + (w343 * w2727 - w348 * w2724)
    w2731 = w2725 + (w345 * w2727 - w348 * w2726)
    w2732 = (w1128 * w2729 - (w1145 * w2728 + w1143 * w2730 + w1141 * w2731)) / w1138
    w2733 = w3 * (w5 * w2630 + w65 * w2636) - w754 * (w5 * w2632 + w65 * w2634) + w777 * (w5 * w2634 - w65 * w2632)
    w2734 = w2733 - w788 * (w65 * w2630 - w5 * w2636)
    w2735 = w354 * w2685 - w794 * (w2728 / w353 + w1135 * w2732) + (w360 * w2734 - w795 * (w2730 / w353 + w1133 * w2732))
    w2736 = w3 * (w5 * w2644 + w65 * w2647) - w754 * (w5 * w2645 + w65 * w2646) + w777 * (w5 * w2646 - w65 * w2645)
    w2737 = w2736 - w788 * (w65 * w2644 - w5 * w2647)
    w2738 = w3 * (w5 * w2663 - w65 * w2666) - w754 * (w5 * w2664 + w65 * w2665) + w777 * (w5 * w2665 - w65 * w2664)
    w2739 = w2738 - w788 * (w65 * w2663 + w5 * w2666)
    w2740 = w2735 + (w375 * w2737 - w796 * (w2731 / w353 + w1131 * w2732)) + (w797 * (w2729 / w353 - w1130 * w2732) + w385 * w2739)
    w2741 = w2740 / w353 - w1129 * w2732
    w2742 = w794 * w2669 + w236 * w2685 + (w795 * w2670 + w261 * w2734) + (w796 * w2671 + w275 * w2737) + (w797 * w2682 + w288 * w2739)
    w2743 = w341 * w2685 - w794 * w2722 + (w343 * w2734 - w795 * w2724) + (w345 * w2737 - w796 * w2726) + (w797 * w2721 + w347 * w2739)
    w2744 = (w798 * w2727 + w348 * w2741 - w2743) / w340 - w1160 * w2720
    w2745 = w794 * w2699 + w311 * w2685 + (w795 * w2700 + w313 * w2734) + (w315 * w2737 - w796 * w2703) + (w797 * w2705 + w317 * w2739)
    w2746 = (w798 * w2706 + w318 * w2741 - w2745 - (w1000 * w2715 + w335 * w2744)) / w310 - w1186 * w2698
    w2747 = w798 * w2683 + w289 * w2741 - w2742 - (w1000 * w2710 + w330 * w2744) - (w1004 * w2693 + w305 * w2746)
    w2748 = hinge0_angle_dot * (w2747 / w235 - w1208 * w2668)
    w2749 = w68 * w2748
    w2750 = w17 * c63
    w2751 = w14 * w2750
    w2752 = bar3_e1 * c107
    w2753 = w2751 - w9 * w2752
    w2754 = w131 * -2.0
    w2755 = w2754 - w138 * w2752
    w2756 = w17 * w2750
    w2757 = w2755 + w2756
    w2758 = w17 * w2752
    w2759 = w144 * w2750
    w2760 = w2758 + (w2609 - w2759)
    w2761 = w148 * w2750
    w2762 = w2761 - w14 * w2752
    w2763 = w8 * w2753 - (w142 * w2757 - w147 * w2760) + w151 * w2762
    w2764 = w147 * w2757 + w142 * w2760 - w151 * w2753 + w8 * w2762
    w2765 = w147 * w2762 - (w151 * w2760 + w8 * w2757 + w142 * w2753)
    w2766 = w151 * w2757 - w8 * w2760 + w147 * w2753 + w142 * w2762
    w2767 = w153 * w2763 - w158 * w2764 + w162 * w2765 + w68 * w2766
    w2768 = w9 * c63
    w2769 = w14 * w2768
    w2770 = w2758 + w2769
    w2771 = w17 * w2768
    w2772 = w2771 + w15 * w2752
    w2773 = w144 * w2768
    w2774 = w2624 + w2773 + w148 * w2752
    w2775 = w148 * w2768
    w2776 = w2775 - w2755
    w2777 = w8 * w2770 - (w142 * w2772 + w147 * w2774) + w151 * w2776
    w2778 = w147 * w2772 - w142 * w2774 - w151 * w2770 + w8 * w2776
    w2779 = w151 * w2774 - w8 * w2772 - w142 * w2770 + w147 * w2776
    w2780 = w151 * w2772 + w8 * w2774 + w147 * w2770 + w142 * w2776
    w2781 = w153 * w2777 - w158 * w2778 + w162 * w2779 + w68 * w2780
    w2782 = w168 * -2.0
    w2783 = w138 * w2768
    w2784 = w15 * w2750 + (w2782 + w2783)
    w2785 = w2761 + w2771
    w2786 = w2756 + w9 * w2768
    w2787 = w132 * -2.0
    w2788 = w138 * w2750
    w2789 = w2787 - w2788 - w2769
    w2790 = w142 * w2784 + w147 * w2785 - w8 * w2786 + w151 * w2789
    w2791 = w142 * w2785 - w147 * w2784 + w151 * w2786 + w8 * w2789
    w2792 = w8 * w2784 - w151 * w2785 + w142 * w2786 + w147 * w2789
    w2793 = w142 * w2789 - (w151 * w2784 + w8 * w2785 + w147 * w2786)
    w2794 = w153 * w2790 - w158 * w2791 + w162 * w2792 + w68 * w2793
    w2795 = w15 * w209
    w2796 = w9 * w214
    w2797 = w2795 - w2796
    w2798 = w222 * -2.0
    w2799 = w15 * w2797 + (w138 * w2652 + w2798) - w2656
    w2800 = w2653 + w148 * w2797 + (w2651 - w144 * w2650)
    w2801 = w17 * w2797 + w9 * w2652 - w2661
    w2802 = w216 * -2.0
    w2803 = w2659 + (w138 * w2797 + w2802) - w148 * w2650
    w2804 = w142 * w2799 + w147 * w2800 - w8 * w2801 - w151 * w2803
    w2805 = w142 * w2800 - w147 * w2799 + w151 * w2801 - w8 * w2803
    w2806 = w8 * w2799 - w151 * w2800 + w142 * w2801 - w147 * w2803
    w2807 = w151 * w2799 + w8 * w2800 + w147 * w2801 + w142 * w2803
    w2808 = w153 * w2804 - w158 * w2805 + w162 * w2806 - w68 * w2807
    w2809 = (w1227 * w2767 + w1225 * w2781 + w1223 * w2794 + w1207 * w2808) / w1220
    w2810 = w2767 / w235 - w1216 * w2809
    w2811 = w2781 / w235 - w1213 * w2809
    w2812 = w2794 / w235 - w1210 * w2809
    w2813 = w2796 - w2795
    w2814 = w2676 + (w207 * w2813 - w105 * w2652)
    w2815 = w105 * w2813 - w2678 + w109 * w2650
    w2816 = w109 * w2813 - w2672 + w70 * w2650
    w2817 = w2674 + (w72 * w2813 - w69 * w2652)
    w2818 = w119 * (w86 * w2814 + w83 * w2815) + w104 * (w86 * w2816 - w83 * w2817) - w124 * (w83 * w2816 + w86 * w2817)
    w2819 = w2818 - w129 * (w86 * w2815 - w83 * w2814)
    w2820 = w2808 / w235 - w1209 * w2809
    w2821 = w130 * w2810 + w260 * w2811 + w274 * w2812 + (w288 * w2819 + w287 * w2820)
    w2822 = w3 * (w5 * w2763 + w65 * w2766) - w754 * (w5 * w2764 + w65 * w2765) + w777 * (w5 * w2765 - w65 * w2764)
    w2823 = w2822 - w788 * (w65 * w2763 - w5 * w2766)
    w2824 = w236 * w2821 + w289 * w2810
    w2825 = w297 * w2762 - (w298 * w2757 - w299 * w2760 + w300 * w2753)
    w2826 = w297 * w2776 - (w298 * w2772 + w299 * w2774 + w300 * w2770)
    w2827 = w297 * w2789 + (w298 * w2784 + w299 * w2785 + w300 * w2786)
    w2828 = w298 * w2799 + w299 * w2800 + w300 * w2801 - w297 * w2803
    w2829 = w236 * w2825 + w301 * w2810 + (w261 * w2826 + w302 * w2811) + (w275 * w2827 + w303 * w2812) + (w288 * w2828 + w304 * w2820)
    w2830 = w2825 - (w236 * w2829 + w305 * w2810)
    w2831 = w2826 - (w261 * w2829 + w305 * w2811)
    w2832 = w2827 - (w275 * w2829 + w305 * w2812)
    w2833 = w2828 - (w288 * w2829 + w305 * w2820)
    w2834 = (w1202 * w2830 + w1200 * w2831 + w1198 * w2832 + w1185 * w2833) / w1195
    w2835 = w2830 / w310 - w1192 * w2834
    w2836 = w2831 / w310 - w1190 * w2834
    w2837 = w261 * w2821 + w289 * w2811
    w2838 = w2832 / w310 - w1188 * w2834
    w2839 = w275 * w2821 + w289 * w2812
    w2840 = w2819 - (w288 * w2821 + w289 * w2820)
    w2841 = w2833 / w310 - w1187 * w2834
    w2842 = w290 * w2835 - w311 * w2824 + (w312 * w2836 - w313 * w2837) + (w314 * w2838 - w315 * w2839) + (w317 * w2840 + w316 * w2841)
    w2843 = w2824 + (w311 * w2842 + w318 * w2835)
    w2844 = w2840 - (w317 * w2842 + w318 * w2841)
    w2845 = w323 * w2816 - w322 * w2814 - w324 * w2817 + w325 * w2815
    w2846 = w326 * w2810 + w327 * w2811 + w328 * w2812 + (w288 * w2845 + w329 * w2820)
    w2847 = w2845 - (w288 * w2846 + w330 * w2820)
    w2848 = w236 * w2846 + w330 * w2810
    w2849 = w261 * w2846 + w330 * w2811
    w2850 = w275 * w2846 + w330 * w2812
    w2851 = w331 * w2835 - w311 * w2848 + (w332 * w2836 - w313 * w2849) + (w333 * w2838 - w315 * w2850) + (w317 * w2847 + w334 * w2841)
    w2852 = w2847 - (w317 * w2851 + w335 * w2841)
    w2853 = w2848 + (w311 * w2851 + w335 * w2835)
    w2854 = w2849 + (w313 * w2851 + w335 * w2836)
    w2855 = w2850 + (w315 * w2851 + w335 * w2838)
    w2856 = (w1159 * w2852 - (w1176 * w2853 + w1174 * w2854 + w1172 * w2855)) / w1169
    w2857 = w2852 / w340 - w1161 * w2856
    w2858 = w2853 / w340 + w1166 * w2856
    w2859 = w2837 + (w313 * w2842 + w318 * w2836)
    w2860 = w2854 / w340 + w1164 * w2856
    w2861 = w2839 + (w315 * w2842 + w318 * w2838)
    w2862 = w2855 / w340 + w1162 * w2856
    w2863 = w347 * w2844 + w346 * w2857 - (w341 * w2843 + w319 * w2858 + (w343 * w2859 + w342 * w2860) + (w345 * w2861 + w344 * w2862))
    w2864 = w2843 + (w341 * w2863 - w348 * w2858)
    w2865 = w2844 - (w347 * w2863 + w348 * w2857)
    w2866 = w2859 + (w343 * w2863 - w348 * w2860)
    w2867 = w2861 + (w345 * w2863 - w348 * w2862)
    w2868 = (w1128 * w2865 - (w1145 * w2864 + w1143 * w2866 + w1141 * w2867)) / w1138
    w2869 = w3 * (w5 * w2777 + w65 * w2780) - w754 * (w5 * w2778 + w65 * w2779) + w777 * (w5 * w2779 - w65 * w2778)
    w2870 = w2869 - w788 * (w65 * w2777 - w5 * w2780)
    w2871 = w354 * w2823 - w794 * (w2864 / w353 + w1135 * w2868) + (w360 * w2870 - w795 * (w2866 / w353 + w1133 * w2868))
    w2872 = w3 * (w5 * w2790 + w65 * w2793) - w754 * (w5 * w2791 + w65 * w2792) + w777 * (w5 * w2792 - w65 * w2791)
    w2873 = w2872 - w788 * (w65 * w2790 - w5 * w2793)
    w2874 = w3 * (w5 * w2804 - w65 * w2807) - w754 * (w5 * w2805 + w65 * w2806) + w777 * (w5 * w2806 - w65 * w2805)
    w2875 = w2874 - w788 * (w65 * w2804 + w5 * w2807)
    w2876 = w2871 + (w375 * w2873 - w796 * (w2867 / w353 + w1131 * w2868)) + (w797 * (w2865 / w353 - w1130 * w2868) + w385 * w2875)
    w2877 = w2876 / w353 - w1129 * w2868
    w2878 = w794 * w2810 + w236 * w2823 + (w795 * w2811 + w261 * w2870) + (w796 * w2812 + w275 * w2873) + (w797 * w2820 + w288 * w2875)
    w2879 = w341 * w2823 - w794 * w2858 + (w343 * w2870 - w795 * w2860) + (w345 * w2873 - w796 * w2862) + (w797 * w2857 + w347 * w2875)
    w2880 = (w798 * w2863 + w348 * w2877 - w2879) / w340 - w1160 * w2856
    w2881 = w794 * w2835 + w311 * w2823 + (w795 * w2836 + w313 * w2870) + (w796 * w2838 + w315 * w2873) + (w797 * w2841 + w317 * w2875)
    w2882 = (w798 * w2842 + w318 * w2877 - w2881 - (w1000 * w2851 + w335 * w2880)) / w310 - w1186 * w2834
    w2883 = w798 * w2821 + w289 * w2877 - w2878 - (w1000 * w2846 + w330 * w2880) - (w1004 * w2829 + w305 * w2882)
    w2884 = hinge0_angle_dot * (w2883 / w235 - w1208 * w2809)
    w2885 = w68 * w2884
    w2886 = bar3_e2 * 4.0
    w2887 = w2886 * c63
    w2888 = w138 * w2887
    w2889 = w2771 + w2888
    w2890 = w17 * w2887
    w2891 = w2773 + w2890
    w2892 = w9 * w2887 + (w2769 + w2787)
    w2893 = w2754 - w14 * w2887 - w2775
    w2894 = w142 * w2889 + w147 * w2891 - w8 * w2892 + w151 * w2893
    w2895 = w142 * w2891 - w147 * w2889 + w151 * w2892 + w8 * w2893
    w2896 = w8 * w2889 - w151 * w2891 + w142 * w2892 + w147 * w2893
    w2897 = w142 * w2893 - (w151 * w2889 + w8 * w2891 + w147 * w2892)
    w2898 = w153 * w2894 - w158 * w2895 + w162 * w2896 + w68 * w2897
    w2899 = w2751 + w2782
    w2900 = w2890 + w2899
    w2901 = w2756 - (w2606 - w15 * w2887)
    w2902 = w2759 + w148 * w2887
    w2903 = w2761 + w2888
    w2904 = w8 * w2900 - (w142 * w2901 + w147 * w2902) + w151 * w2903
    w2905 = w147 * w2901 - w142 * w2902 - w151 * w2900 + w8 * w2903
    w2906 = w151 * w2902 - w8 * w2901 - w142 * w2900 + w147 * w2903
    w2907 = w151 * w2901 + w8 * w2902 + w147 * w2900 + w142 * w2903
    w2908 = w153 * w2904 - w158 * w2905 + w162 * w2906 + w68 * w2907
    w2909 = w2771 - w9 * w2750
    w2910 = w2609 + w15 * w2768 - w2788
    w2911 = w2775 - w2756
    w2912 = w2783 - w2899
    w2913 = w8 * w2909 - (w142 * w2910 + w147 * w2911) + w151 * w2912
    w2914 = w147 * w2910 - w142 * w2911 - w151 * w2909 + w8 * w2912
    w2915 = w151 * w2911 - w8 * w2910 - w142 * w2909 + w147 * w2912
    w2916 = w151 * w2910 + w8 * w2911 + w147 * w2909 + w142 * w2912
    w2917 = w153 * w2913 - w158 * w2914 + w162 * w2915 + w68 * w2916
    w2918 = w144 * w209 + w17 * w214
    w2919 = w209 * w2886
    w2920 = w17 * w217
    w2921 = w2919 - w2920
    w2922 = w144 * w217
    w2923 = w214 * w2886 + w2922
    w2924 = w2658 + w15 * w2918 + w138 * w2921 - w17 * w2923
    w2925 = w148 * w2918 + w17 * w2921 - w144 * w2923
    w2926 = w225 * -2.0
    w2927 = w17 * w2918 + w9 * w2921 + (w2926 - w14 * w2923)
    w2928 = w138 * w2918 + (w2798 + w14 * w2921) - w148 * w2923
    w2929 = w142 * w2924 + w147 * w2925 - w8 * w2927 - w151 * w2928
    w2930 = w142 * w2925 - w147 * w2924 + w151 * w2927 - w8 * w2928
    w2931 = w8 * w2924 - w151 * w2925 + w142 * w2927 - w147 * w2928
    w2932 = w151 * w2924 + w8 * w2925 + w147 * w2927 + w142 * w2928
    w2933 = w153 * w2929 - w158 * w2930 + w162 * w2931 - w68 * w2932
    w2934 = (w1227 * w2898 + w1225 * w2908 + w1223 * w2917 + w1207 * w2933) / w1220
    w2935 = w2898 / w235 - w1216 * w2934
    w2936 = w2908 / w235 - w1213 * w2934
    w2937 = w2917 / w235 - w1210 * w2934
    w2938 = w2920 - w2919
    w2939 = w105 * w2938 - w207 * w2918 + w72 * w2923
    w2940 = w76 * w2938 - w105 * w2918 + w109 * w2923
    w2941 = w72 * w2938 - w109 * w2918 + w70 * w2923
    w2942 = w69 * w2938 - w72 * w2918 + w76 * w2923
    w2943 = w119 * (w86 * w2939 + w83 * w2940) + w104 * (w86 * w2941 - w83 * w2942) - w124 * (w83 * w2941 + w86 * w2942)
    w2944 = w2943 - w129 * (w86 * w2940 - w83 * w2939)
    w2945 = w2933 / w235 - w1209 * w2934
    w2946 = w130 * w2935 + w260 * w2936 + w274 * w2937 + (w288 * w2944 + w287 * w2945)
    w2947 = w3 * (w5 * w2894 + w65 * w2897) - w754 * (w5 * w2895 + w65 * w2896) + w777 * (w5 * w2896 - w65 * w2895)
    w2948 = w2947 - w788 * (w65 * w2894 - w5 * w2897)
    w2949 = w236 * w2946 + w289 * w2935
    w2950 = w297 * w2893 + (w298 * w2889 + w299 * w2891 + w300 * w2892)
    w2951 = w297 * w2903 - (w298 * w2901 + w299 * w2902 + w300 * w2900)
    w2952 = w297 * w2912 - (w298 * w2910 + w299 * w2911 + w300 * w2909)
    w2953 = w298 * w2924 + w299 * w2925 + w300 * w2927 - w297 * w2928
    w2954 = w236 * w2950 + w301 * w2935 + (w261 * w2951 + w302 * w2936) + (w275 * w2952 + w303 * w2937) + (w288 * w2953 + w304 * w2945)
    w2955 = w2950 - (w236 * w2954 + w305 * w2935)
    w2956 = w2951 - (w261 * w2954 + w305 * w2936)
    w2957 = w2952 - (w275 * w2954 + w305 * w2937)
    w2958 = w2953 - (w288 * w2954 + w305 * w2945)
    w2959 = (w1202 * w2955 + w1200 * w2956 + w1198 * w2957 + w1185 * w2958) / w1195
    w2960 = w2955 / w310 - w1192 * w2959
    w2961 = w2956 / w310 - w1190 * w2959
    w2962 = w261 * w2946 + w289 * w2936
    w2963 = w2957 / w310 - w1188 * w2959
    w2964 = w275 * w2946 + w289 * w2937
    w2965 = w2944 - (w288 * w2946 + w289 * w2945)
    w2966 = w2958 / w310 - w1187 * w2959
    w2967 = w290 * w2960 - w311 * w2949 + (w312 * w2961 - w313 * w2962) + (w314 * w2963 - w315 * w2964) + (w317 * w2965 + w316 * w2966)
    w2968 = w2949 + (w311 * w2967 + w318 * w2960)
    w2969 = w2965 - (w317 * w2967 + w318 * w2966)
    w2970 = w323 * w2941 - w322 * w2939 - w324 * w2942 + w325 * w2940
    w2971 = w326 * w2935 + w327 * w2936 + w328 * w2937 + (w288 * w2970 + w329 * w2945)
    w2972 = w2970 - (w288 * w2971 + w330 * w2945)
    w2973 = w236 * w2971 + w330 * w2935
    w2974 = w261 * w2971 + w330 * w2936
    w2975 = w275 * w2971 + w330 * w2937
    w2976 = w331 * w2960 - w311 * w2973 + (w332 * w2961 - w313 * w2974) + (w333 * w2963 - w315 * w2975) + (w317 * w2972 + w334 * w2966)
    w2977 = w2972 - (w317 * w2976 + w335 * w2966)
    w2978 = w2973 + (w311 * w2976 + w335 * w2960)
    w2979 = w2974 + (w313 * w2976 + w335 * w2961)
    w2980 = w2975 + (w315 * w2976 + w335 * w2963)
    w2981 = (w1159 * w2977 - (w1176 * w2978 + w1174 * w2979 + w1172 * w2980)) / w1169
    w2982 = w2977 / w340 - w1161 * w2981
    w2983 = w2978 / w340 + w1166 * w2981
    w2984 = w2962 + (w313 * w2967 + w318 * w2961)
    w2985 = w2979 / w340 + w1164 * w2981
    w2986 = w2964 + (w315 * w2967 + w318 * w2963)
    w2987 = w2980 / w340 + w1162 * w2981
    w2988 = w347 * w2969 + w346 * w2982 - (w341 * w2968 + w319 * w2983 + (w343 * w2984 + w342 * w2985) + (w345 * w2986 + w344 * w2987))
    w2989 = w2968 + (w341 * w2988 - w348 * w2983)
    w2990 = w2969 - (w347 * w2988 + w348 * w2982)
    w2991 = w2984 + (w343 * w2988 - w348 * w2985)
    w2992 = w2986 + (w345 * w2988 - w348 * w2987)
    w2993 = (w1128 * w2990 - (w1145 * w2989 + w1143 * w2991 + w1141 * w2992)) / w1138
    w2994 = w3 * (w5 * w2904 + w65 * w2907) - w754 * (w5 * w2905 + w65 * w2906) + w777 * (w5 * w2906 - w65 * w2905)
    w2995 = w2994 - w788 * (w65 * w2904 - w5 * w2907)
    w2996 = w354 * w2948 - w794 * (w2989 / w353 + w1135 * w2993) + (w360 * w2995 - w795 * (w2991 / w353 + w1133 * w2993))
    w2997 = w3 * (w5 * w2913 + w65 * w2916) - w754 * (w5 * w2914 + w65 * w2915) + w777 * (w5 * w2915 - w65 * w2914)
    w2998 = w2997 - w788 * (w65 * w2913 - w5 * w2916)
    w2999 = w3 * (w5 * w2929 - w65 * w2932) - w754 * (w5 * w2930 + w65 * w2931) + w777 * (w5 * w2931 - w65 * w2930)
    w3000 = w2999 - w788 * (w65 * w2929 + w5 * w2932)
    w3001 = w2996 + (w375 * w2998 - w796 * (w2992 / w353 + w1131 * w2993)) + (w797 * (w2990 / w353 - w1130 * w2993) + w385 * w3000)
    w3002 = w3001 / w353 - w1129 * w2993
    w3003 = w794 * w2935 + w236 * w2948 + (w795 * w2936 + w261 * w2995) + (w796 * w2937 + w275 * w2998) + (w797 * w2945 + w288 * w3000)
    w3004 = w341 * w2948 - w794 * w2983 + (w343 * w2995 - w795 * w2985) + (w345 * w2998 - w796 * w2987) + (w797 * w2982 + w347 * w3000)
    w3005 = (w798 * w2988 + w348 * w3002 - w3004) / w340 - w1160 * w2981
    w3006 = w794 * w2960 + w311 * w2948 + (w795 * w2961 + w313 * w2995) + (w796 * w2963 + w315 * w2998) + (w797 * w2966 + w317 * w3000)
    w3007 = (w798 * w2967 + w318 * w3002 - w3006 - (w1000 * w2976 + w335 * w3005)) / w310 - w1186 * w2959
    w3008 = w798 * w2946 + w289 * w3002 - w3003 - (w1000 * w2971 + w330 * w3005) - (w1004 * w2954 + w305 * w3007)
    w3009 = hinge0_angle_dot * (w3008 / w235 - w1208 * w2934)
    w3010 = w68 * w3009
    w3011 = w2606 - w2622
    w3012 = w2629 + w2787
    w3013 = w8 * w3011 + (w2628 + w142 * w2625) - w151 * w3012
    w3014 = w2631 - w147 * w2625 - w151 * w3011 - w8 * w3012
    w3015 = w8 * w2625 - w2633 - w142 * w3011 - w147 * w3012
    w3016 = w147 * w3011 - (w2635 + w151 * w2625) - w142 * w3012
    w3017 = w153 * w3013 - w158 * w3014 + w162 * w3015 + w68 * w3016
    w3018 = w2607 - w2754
    w3019 = w2612 + w2782
    w3020 = w2605 - (w142 * w2610 + w147 * w3018) + w151 * w3019
    w3021 = w147 * w2610 - w142 * w3018 - w2614 + w8 * w3019
    w3022 = w151 * w3018 - w8 * w2610 - w2616 + w147 * w3019
    w3023 = w2618 + (w151 * w2610 + w8 * w3018) + w142 * w3019
    w3024 = w153 * w3020 - w158 * w3021 + w162 * w3022 + w68 * w3023
    w3025 = w2625 - (w2624 + w9 * w2603)
    w3026 = w15 * w2621 - w2642
    w3027 = w3012 - w2610
    w3028 = w2639 - w2604
    w3029 = w8 * w3025 - (w142 * w3026 + w147 * w3027) + w151 * w3028
    w3030 = w147 * w3026 - w142 * w3027 - w151 * w3025 + w8 * w3028
    w3031 = w151 * w3027 - w8 * w3026 - w142 * w3025 + w147 * w3028
    w3032 = w151 * w3026 + w8 * w3027 + w147 * w3025 + w142 * w3028
    w3033 = w153 * w3029 - w158 * w3030 + w162 * w3031 + w68 * w3032
    w3034 = w17 * w209
    w3035 = w144 * w214
    w3036 = w3034 - w3035
    w3037 = bar3_e3 * 4.0
    w3038 = w2922 + w209 * w3037
    w3039 = w2920 + w214 * w3037
    w3040 = w15 * w3036 + w138 * w3038 - w17 * w3039
    w3041 = w2802 + w148 * w3036 + w17 * w3038 - w144 * w3039
    w3042 = w17 * w3036 + (w2655 + w9 * w3038) - w14 * w3039
    w3043 = w138 * w3036 + w14 * w3038 + (w2926 - w148 * w3039)
    w3044 = w142 * w3040 + w147 * w3041 - w8 * w3042 - w151 * w3043
    w3045 = w142 * w3041 - w147 * w3040 + w151 * w3042 - w8 * w3043
    w3046 = w8 * w3040 - w151 * w3041 + w142 * w3042 - w147 * w3043
    w3047 = w151 * w3040 + w8 * w3041 + w147 * w3042 + w142 * w3043
    w3048 = w153 * w3044 - w158 * w3045 + w162 * w3046 - w68 * w3047
    w3049 = (w1227 * w3017 + w1225 * w3024 + w1223 * w3033 + w1207 * w3048) / w1220
    w3050 = w3017 / w235 - w1216 * w3049
    w3051 = w3024 / w235 - w1213 * w3049
    w3052 = w3033 / w235 - w1210 * w3049
    w3053 = w3035 - w3034
    w3054 = w207 * w3053 - w105 * w3038 + w72 * w3039
    w3055 = w105 * w3053 - w76 * w3038 + w109 * w3039
    w3056 = w109 * w3053 - w72 * w3038 + w70 * w3039
    w3057 = w72 * w3053 - w69 * w3038 + w76 * w3039
    w3058 = w119 * (w86 * w3054 + w83 * w3055) + w104 * (w86 * w3056 - w83 * w3057) - w124 * (w83 * w3056 + w86 * w3057)
    w3059 = w3058 - w129 * (w86 * w3055 - w83 * w3054)
    w3060 = w3048 / w235 - w1209 * w3049
    w3061 = w130 * w3050 + w260 * w3051 + w274 * w3052 + (w288 * w3059 + w287 * w3060)
    w3062 = w3 * (w5 * w3013 + w65 * w3016) - w754 * (w5 * w3014 + w65 * w3015) + w777 * (w5 * w3015 - w65 * w3014)
    w3063 = w3062 - w788 * (w65 * w3013 - w5 * w3016)
    w3064 = w236 * w3061 + w289 * w3050
    w3065 = w297 * w3019 - (w2687 + (w298 * w2610 + w299 * w3018))
    w3066 = w297 * w3012 + (w300 * w3011 - (w2689 + w298 * w2625))
    w3067 = w297 * w3028 - (w298 * w3026 + w299 * w3027 + w300 * w3025)
    w3068 = w298 * w3040 + w299 * w3041 + w300 * w3042 - w297 * w3043
    w3069 = w301 * w3050 - w236 * w3066 + (w261 * w3065 + w302 * w3051) + (w275 * w3067 + w303 * w3052) + (w288 * w3068 + w304 * w3060)
    w3070 = w3065 - (w261 * w3069 + w305 * w3051)
    w3071 = w3066 + (w236 * w3069 + w305 * w3050)
    w3072 = w3067 - (w275 * w3069 + w305 * w3052)
    w3073 = w3068 - (w288 * w3069 + w305 * w3060)
    w3074 = (w1200 * w3070 - w1202 * w3071 + w1198 * w3072 + w1185 * w3073) / w1195
    w3075 = w3070 / w310 - w1190 * w3074
    w3076 = w261 * w3061 + w289 * w3051
    w3077 = w3071 / w310 + w1192 * w3074
    w3078 = w3072 / w310 - w1188 * w3074
    w3079 = w275 * w3061 + w289 * w3052
    w3080 = w3059 - (w288 * w3061 + w289 * w3060)
    w3081 = w3073 / w310 - w1187 * w3074
    w3082 = w312 * w3075 - w313 * w3076 - (w311 * w3064 + w290 * w3077) + (w314 * w3078 - w315 * w3079) + (w317 * w3080 + w316 * w3081)
    w3083 = w3064 + (w311 * w3082 - w318 * w3077)
    w3084 = w3080 - (w317 * w3082 + w318 * w3081)
    w3085 = w323 * w3056 - w322 * w3054 - w324 * w3057 + w325 * w3055
    w3086 = w326 * w3050 + w327 * w3051 + w328 * w3052 + (w288 * w3085 + w329 * w3060)
    w3087 = w3085 - (w288 * w3086 + w330 * w3060)
    w3088 = w261 * w3086 + w330 * w3051
    w3089 = w236 * w3086 + w330 * w3050
    w3090 = w275 * w3086 + w330 * w3052
    w3091 = w332 * w3075 - w313 * w3088 - (w311 * w3089 + w331 * w3077) + (w333 * w3078 - w315 * w3090) + (w317 * w3087 + w334 * w3081)
    w3092 = w3087 - (w317 * w3091 + w335 * w3081)
    w3093 = w3089 + (w311 * w3091 - w335 * w3077)
    w3094 = w3088 + (w313 * w3091 + w335 * w3075)
    w3095 = w3090 + (w315 * w3091 + w335 * w3078)
    w3096 = (w1159 * w3092 - (w1176 * w3093 + w1174 * w3094 + w1172 * w3095)) / w1169
    w3097 = w3092 / w340 - w1161 * w3096
    w3098 = w3093 / w340 + w1166 * w3096
    w3099 = w3076 + (w313 * w3082 + w318 * w3075)
    w3100 = w3094 / w340 + w1164 * w3096
    w3101 = w3079 + (w315 * w3082 + w318 * w3078)
    w3102 = w3095 / w340 + w1162 * w3096
    w3103 = w347 * w3084 + w346 * w3097 - (w341 * w3083 + w319 * w3098 + (w343 * w3099 + w342 * w3100) + (w345 * w3101 + w344 * w3102))
    w3104 = w3083 + (w341 * w3103 - w348 * w3098)
    w3105 = w3084 - (w347 * w3103 + w348 * w3097)
    w3106 = w3099 + (w343 * w3103 - w348 * w3100)
    w3107 = w3101 + (w345 * w3103 - w348 * w3102)
    w3108 = (w1128 * w3105 - (w1145 * w3104 + w1143 * w3106 + w1141 * w3107)) / w1138
    w3109 = w3 * (w5 * w3020 + w65 * w3023) - w754 * (w5 * w3021 + w65 * w3022) + w777 * (w5 * w3022 - w65 * w3021)
    w3110 = w3109 - w788 * (w65 * w3020 - w5 * w3023)
    w3111 = w354 * w3063 - w794 * (w3104 / w353 + w1135 * w3108) + (w360 * w3110 - w795 * (w3106 / w353 + w1133 * w3108))
    w3112 = w3 * (w5 * w3029 + w65 * w3032) - w754 * (w5 * w3030 + w65 * w3031) + w777 * (w5 * w3031 - w65 * w3030)
    w3113 = w3112 - w788 * (w65 * w3029 - w5 * w3032)
    w3114 = w3 * (w5 * w3044 - w65 * w3047) - w754 * (w5 * w3045 + w65 * w3046) + w777 * (w5 * w3046 - w65 * w3045)
    w3115 = w3114 - w788 * (w65 * w3044 + w5 * w3047)
    w3116 = w3111 + (w375 * w3113 - w796 * (w3107 / w353 + w1131 * w3108)) + (w797 * (w3105 / w353 - w1130 * w3108) + w385 * w3115)
    w3117 = w3116 / w353 - w1129 * w3108
    w3118 = w794 * w3050 + w236 * w3063 + (w795 * w3051 + w261 * w3110) + (w796 * w3052 + w275 * w3113) + (w797 * w3060 + w288 * w3115)
    w3119 = w341 * w3063 - w794 * w3098 + (w343 * w3110 - w795 * w3100) + (w345 * w3113 - w796 * w3102) + (w797 * w3097 + w347 * w3115)
    w3120 = (w798 * w3103 + w348 * w3117 - w3119) / w340 - w1160 * w3096
    w3121 = w311 * w3063 - w794 * w3077 + (w795 * w3075 + w313 * w3110) + (w796 * w3078 + w315 * w3113) + (w797 * w3081 + w317 * w3115)
    w3122 = (w798 * w3082 + w318 * w3117 - w3121 - (w1000 * w3091 + w335 * w3120)) / w310 - w1186 * w3074
    w3123 = w798 * w3061 + w289 * w3117 - w3118 - (w1000 * w3086 + w330 * w3120) - (w1004 * w3069 + w305 * w3122)
    w3124 = hinge0_angle_dot * (w3123 / w235 - w1208 * w3049)
    w3125 = w68 * w3124
    w3126 = w207 * c55
    w3127 = w105 * w3126
    w3128 = 2 * w80
    w3129 = w69 * c55
    w3130 = w72 * w3129
    w3131 = w3128 + w3130
    w3132 = w3127 + w3131
    w3133 = w76 * w3126
    w3134 = w109 * w3129
    w3135 = w3133 + w3134
    w3136 = w76 * w3129
    w3137 = w69 * w3126 + w3136
    w3138 = 2 * w75
    w3139 = w72 * w3126
    w3140 = w3138 - w3139
    w3141 = w3140 - w70 * w3129
    w3142 = w119 * (w86 * w3132 + w83 * w3135) - w104 * (w83 * w3137 + w86 * w3141) + w124 * (w83 * w3141 - w86 * w3137)
    w3143 = w3142 - w129 * (w86 * w3135 - w83 * w3132)
    w3144 = w70 * w205
    w3145 = w69 * w211 + w70 * w220
    w3146 = w69 * w205
    w3147 = w17 * w3146
    w3148 = w15 * w3144 - w138 * w3145 + w3147
    w3149 = w148 * w3144
    w3150 = w3149 - w17 * w3145 + w144 * w3146
    w3151 = w17 * w3144
    w3152 = w3151 - w9 * w3145 + w14 * w3146
    w3153 = w148 * w3146
    w3154 = w138 * w3144 - w14 * w3145 + w3153
    w3155 = w142 * w3148 + w147 * w3150 - w8 * w3152 - w151 * w3154
    w3156 = w142 * w3150 - w147 * w3148 + w151 * w3152 - w8 * w3154
    w3157 = w8 * w3148 - w151 * w3150 + w142 * w3152 - w147 * w3154
    w3158 = w151 * w3148 + w8 * w3150 + w147 * w3152 + w142 * w3154
    w3159 = w153 * w3155 - w158 * w3156 + w162 * w3157 - w68 * w3158
    w3160 = w1207 * w3159 / w1220
    w3161 = w1216 * w3160
    w3162 = w109 * w3126
    w3163 = w83 * w3162
    w3164 = w86 * w3162
    w3165 = 2 * w239
    w3166 = w207 * w3126
    w3167 = w3165 + w3166
    w3168 = w124 * (w3163 - w86 * w3140) - (w104 * (w83 * w3140 + w3164) + w119 * (w86 * w3167 + w83 * w3127))
    w3169 = w3168 - w129 * (w83 * w3167 - w86 * w3127)
    w3170 = w1213 * w3160
    w3171 = w3134 - w3165
    w3172 = w207 * w3129
    w3173 = w86 * w3172
    w3174 = w105 * w3129
    w3175 = w104 * (w83 * w3131 - w86 * w3171) - w119 * (w3173 + w83 * w3174) + w124 * (w83 * w3171 + w86 * w3131)
    w3176 = w83 * w3172
    w3177 = w3175 - w129 * (w3176 - w86 * w3174)
    w3178 = w1210 * w3160
    w3179 = 2 * w278
    w3180 = w72 * w3146
    w3181 = w105 * w3145 - w207 * w3144 + (w3179 - w3180)
    w3182 = w109 * w3146
    w3183 = w76 * w3145 - w105 * w3144 - w3182
    w3184 = 2 * w277
    w3185 = w109 * w3144
    w3186 = w72 * w3145 + w3184 - w3185 - w70 * w3146
    w3187 = 2 * w276
    w3188 = w72 * w3144
    w3189 = w3187 - w3188 + w69 * w3145 - w76 * w3146
    w3190 = w119 * (w86 * w3181 + w83 * w3183) + w104 * (w86 * w3186 - w83 * w3189) - w124 * (w83 * w3186 + w86 * w3189)
    w3191 = w3190 - w129 * (w86 * w3183 - w83 * w3181)
    w3192 = w3159 / w235 - w1209 * w3160
    w3193 = w236 * w3143 - w130 * w3161 + (w261 * w3169 - w260 * w3170) + (w275 * w3177 - w274 * w3178) + (w288 * w3191 + w287 * w3192)
    w3194 = w3143 - (w236 * w3193 - w289 * w3161)
    w3195 = w298 * w3148 + w299 * w3150 + w300 * w3152 - w297 * w3154
    w3196 = w288 * w3195 + w304 * w3192 - (w301 * w3161 + w302 * w3170 + w303 * w3178)
    w3197 = w236 * w3196 - w305 * w3161
    w3198 = w3195 - (w288 * w3196 + w305 * w3192)
    w3199 = w261 * w3196 - w305 * w3170
    w3200 = w275 * w3196 - w305 * w3178
    w3201 = (w1185 * w3198 - (w1202 * w3197 + w1200 * w3199 + w1198 * w3200)) / w1195
    w3202 = w3197 / w310 + w1192 * w3201
    w3203 = w3169 - (w261 * w3193 - w289 * w3170)
    w3204 = w3199 / w310 + w1190 * w3201
    w3205 = w3177 - (w275 * w3193 - w289 * w3178)
    w3206 = w3200 / w310 + w1188 * w3201
    w3207 = w3191 - (w288 * w3193 + w289 * w3192)
    w3208 = w3198 / w310 - w1187 * w3201
    w3209 = w311 * w3194 - w290 * w3202 + (w313 * w3203 - w312 * w3204) + (w315 * w3205 - w314 * w3206) + (w317 * w3207 + w316 * w3208)
    w3210 = w3194 - (w311 * w3209 - w318 * w3202)
    w3211 = w325 * w3135 - (w322 * w3132 + w323 * w3141 + w324 * w3137)
    w3212 = w323 * w3162
    w3213 = w322 * w3167 - w3212 - w324 * w3140 - w325 * w3127
    w3214 = w322 * w3172
    w3215 = w3214 - w323 * w3171 + w324 * w3131 - w325 * w3174
    w3216 = w323 * w3186 - w322 * w3181 - w324 * w3189 + w325 * w3183
    w3217 = w236 * w3211 - w326 * w3161 + (w261 * w3213 - w327 * w3170) + (w275 * w3215 - w328 * w3178) + (w288 * w3216 + w329 * w3192)
    w3218 = w3211 - (w236 * w3217 - w330 * w3161)
    w3219 = w3213 - (w261 * w3217 - w330 * w3170)
    w3220 = w3215 - (w275 * w3217 - w330 * w3178)
    w3221 = w3216 - (w288 * w3217 + w330 * w3192)
    w3222 = w311 * w3218 - w331 * w3202 + (w313 * w3219 - w332 * w3204) + (w315 * w3220 - w333 * w3206) + (w317 * w3221 + w334 * w3208)
    w3223 = w3218 - (w311 * w3222 - w335 * w3202)
    w3224 = w3219 - (w313 * w3222 - w335 * w3204)
    w3225 = w3220 - (w315 * w3222 - w335 * w3206)
    w3226 = w3221 - (w317 * w3222 + w335 * w3208)
    w3227 = (w1176 * w3223 + w1174 * w3224 + w1172 * w3225 + w1159 * w3226) / w1169
    w3228 = w3223 / w340 - w1166 * w3227
    w3229 = w3203 - (w313 * w3209 - w318 * w3204)
    w3230 = w3224 / w340 - w1164 * w3227
    w3231 = w3205 - (w315 * w3209 - w318 * w3206)
    w3232 = w3225 / w340 - w1162 * w3227
    w3233 = w3207 - (w317 * w3209 + w318 * w3208)
    w3234 = w3226 / w340 - w1161 * w3227
    w3235 = w341 * w3210 + w319 * w3228 + (w343 * w3229 + w342 * w3230) + (w345 * w3231 + w344 * w3232) + (w347 * w3233 + w346 * w3234)
    w3236 = w3210 - (w341 * w3235 + w348 * w3228)
    w3237 = w3229 - (w343 * w3235 + w348 * w3230)
    w3238 = w3231 - (w345 * w3235 + w348 * w3232)
    w3239 = w3233 - (w347 * w3235 + w348 * w3234)
    w3240 = (w1145 * w3236 + w1143 * w3237 + w1141 * w3238 + w1128 * w3239) / w1138
    w3241 = w794 * (w3236 / w353 - w1135 * w3240) + w795 * (w3237 / w353 - w1133 * w3240) + w796 * (w3238 / w353 - w1131 * w3240)
    w3242 = w3 * (w5 * w3155 - w65 * w3158) - w754 * (w5 * w3156 + w65 * w3157) + w777 * (w5 * w3157 - w65 * w3156)
    w3243 = w3242 - w788 * (w65 * w3155 + w5 * w3158)
    w3244 = (w3241 + (w797 * (w3239 / w353 - w1130 * w3240) + w385 * w3243)) / w353 - w1129 * w3240
    w3245 = w798 * w3193 + w289 * w3244 - (w797 * w3192 + w288 * w3243 - (w794 * w3161 + w795 * w3170 + w796 * w3178))
    w3246 = w798 * w3235 + w348 * w3244 - (w794 * w3228 + w795 * w3230 + w796 * w3232 + (w797 * w3234 + w347 * w3243))
    w3247 = w3246 / w340 - w1160 * w3227
    w3248 = w798 * w3209 + w318 * w3244 - (w797 * w3208 + w317 * w3243 - (w794 * w3202 + w795 * w3204 + w796 * w3206))
    w3249 = (w3248 - (w1000 * w3222 + w335 * w3247)) / w310 - w1186 * w3201
    w3250 = hinge0_angle_dot * ((w3245 - (w1000 * w3217 + w330 * w3247) - (w1004 * w3196 + w305 * w3249)) / w235 - w1208 * w3160)
    w3251 = w68 * w3250
    w3252 = w2517 - w1455 * w2602 - w1565 * w2749 - w1580 * w2885 - w1592 * w3010 - w1600 * w3125 - w1699 * w3251
    w3253 = w69 * w3129 - w3133
    w3254 = w3130 - (w3128 + w70 * w3126)
    w3255 = w75 * -2.0
    w3256 = w3174 + w3255
    w3257 = w3256 - w3139
    w3258 = w3136 - w3162
    w3259 = w104 * (w83 * w3253 - w86 * w3254) - w119 * (w86 * w3257 + w83 * w3258) + w124 * (w83 * w3254 + w86 * w3253)
    w3260 = w3259 - w129 * (w83 * w3257 - w86 * w3258)
    w3261 = w72 * w205
    w3262 = bar4_e1 * 4.0
    w3263 = w3261 + w211 * w3262
    w3264 = w207 * w211
    w3265 = w72 * w220
    w3266 = w3264 - w3265
    w3267 = w205 * w207
    w3268 = w220 * w3262 + w3267
    w3269 = w15 * w3263 + w138 * w3266 - w17 * w3268
    w3270 = w148 * w3263 + w17 * w3266 - w144 * w3268
    w3271 = w17 * w3263 + w9 * w3266 - w14 * w3268
    w3272 = w138 * w3263 + w14 * w3266 - w148 * w3268
    w3273 = w142 * w3269 + w147 * w3270 - w8 * w3271 - w151 * w3272
    w3274 = w142 * w3270 - w147 * w3269 + w151 * w3271 - w8 * w3272
    w3275 = w8 * w3269 - w151 * w3270 + w142 * w3271 - w147 * w3272
    w3276 = w151 * w3269 + w8 * w3270 + w147 * w3271 + w142 * w3272
    w3277 = w153 * w3273 - w158 * w3274 + w162 * w3275 - w68 * w3276
    w3278 = w1207 * w3277 / w1220
    w3279 = w1216 * w3278
    w3280 = w3165 - w3134
    w3281 = w119 * (w3173 + w83 * w3256) - w104 * (w83 * w3130 + w86 * w3280) + w124 * (w83 * w3280 - w86 * w3130)
    w3282 = w3281 - w129 * (w86 * w3256 - w3176)
    w3283 = w1213 * w3278
    w3284 = w239 * -2.0
    w3285 = w3166 - w3284
    w3286 = w80 * -2.0
    w3287 = w3127 + w3286
    w3288 = w104 * (w83 * w3139 - w3164) - w119 * (w86 * w3285 + w83 * w3287) + w124 * (w3163 + w86 * w3139) - w129 * (w83 * w3285 - w86 * w3287)
    w3289 = w1210 * w3278
    w3290 = w3265 - w3264
    w3291 = w277 * -2.0
    w3292 = w105 * w3290 + w3291 - w207 * w3263 + w72 * w3268
    w3293 = w276 * -2.0
    w3294 = w3293 - w105 * w3263 + w76 * w3290 + w109 * w3268
    w3295 = w72 * w3290 - w109 * w3263 + (w3179 + w70 * w3268)
    w3296 = w69 * w3290 - w72 * w3263 + w76 * w3268
    w3297 = w119 * (w86 * w3292 + w83 * w3294) + w104 * (w86 * w3295 - w83 * w3296) - w124 * (w83 * w3295 + w86 * w3296)
    w3298 = w3297 - w129 * (w86 * w3294 - w83 * w3292)
    w3299 = w3277 / w235 - w1209 * w3278
    w3300 = w236 * w3260 - w130 * w3279 + (w261 * w3282 - w260 * w3283) + (w275 * w3288 - w274 * w3289) + (w288 * w3298 + w287 * w3299)
    w3301 = w3260 - (w236 * w3300 - w289 * w3279)
    w3302 = w298 * w3269 + w299 * w3270 + w300 * w3271 - w297 * w3272
    w3303 = w288 * w3302 + w304 * w3299 - (w301 * w3279 + w302 * w3283 + w303 * w3289)
    w3304 = w236 * w3303 - w305 * w3279
    w3305 = w3302 - (w288 * w3303 + w305 * w3299)
    w3306 = w261 * w3303 - w305 * w3283
    w3307 = w275 * w3303 - w305 * w3289
    w3308 = (w1185 * w3305 - (w1202 * w3304 + w1200 * w3306 + w1198 * w3307)) / w1195
    w3309 = w3304 / w310 + w1192 * w3308
    w3310 = w3282 - (w261 * w3300 - w289 * w3283)
    w3311 = w3306 / w310 + w1190 * w3308
    w3312 = w3288 - (w275 * w3300 - w289 * w3289)
    w3313 = w3307 / w310 + w1188 * w3308
    w3314 = w3298 - (w288 * w3300 + w289 * w3299)
    w3315 = w3305 / w310 - w1187 * w3308
    w3316 = w311 * w3301 - w290 * w3309 + (w313 * w3310 - w312 * w3311) + (w315 * w3312 - w314 * w3313) + (w317 * w3314 + w316 * w3315)
    w3317 = w3301 - (w311 * w3316 - w318 * w3309)
    w3318 = w322 * w3257 - w323 * w3254 + w324 * w3253 - w325 * w3258
    w3319 = w325 * w3256 - (w3214 + w323 * w3280 + w324 * w3130)
    w3320 = w322 * w3285 - w3212 + w324 * w3139 - w325 * w3287
    w3321 = w323 * w3295 - w322 * w3292 - w324 * w3296 + w325 * w3294
    w3322 = w236 * w3318 - w326 * w3279 + (w261 * w3319 - w327 * w3283) + (w275 * w3320 - w328 * w3289) + (w288 * w3321 + w329 * w3299)
    w3323 = w3318 - (w236 * w3322 - w330 * w3279)
    w3324 = w3319 - (w261 * w3322 - w330 * w3283)
    w3325 = w3320 - (w275 * w3322 - w330 * w3289)
    w3326 = w3321 - (w288 * w3322 + w330 * w3299)
    w3327 = w311 * w3323 - w331 * w3309 + (w313 * w3324 - w332 * w3311) + (w315 * w3325 - w333 * w3313) + (w317 * w3326 + w334 * w3315)
    w3328 = w3323 - (w311 * w3327 - w335 * w3309)
    w3329 = w3324 - (w313 * w3327 - w335 * w3311)
    w3330 = w3325 - (w315 * w3327 - w335 * w3313)
    w3331 = w3326 - (w317 * w3327 + w335 * w3315)
    w3332 = (w1176 * w3328 + w1174 * w3329 + w1172 * w3330 + w1159 * w3331) / w1169
    w3333 = w3328 / w340 - w1166 * w3332
    w3334 = w3310 - (w313 * w3316 - w318 * w3311)
    w3335 = w3329 / w340 - w1164 * w3332
    w3336 = w3312 - (w315 * w3316 - w318 * w3313)
    w3337 = w3330 / w340 - w1162 * w3332
    w3338 = w3314 - (w317 * w3316 + w318 * w3315)
    w3339 = w3331 / w340 - w1161 * w3332
    w3340 = w341 * w3317 + w319 * w3333 + (w343 * w3334 + w342 * w3335) + (w345 * w3336 + w344 * w3337) + (w347 * w3338 + w346 * w3339)
    w3341 = w3317 - (w341 * w3340 + w348 * w3333)
    w3342 = w3334 - (w343 * w3340 + w348 * w3335)
    w3343 = w3336 - (w345 * w3340 + w348 * w3337)
    w3344 = w3338 - (w347 * w3340 + w348 * w3339)
    w3345 = (w1145 * w3341 + w1143 * w3342 + w1141 * w3343 + w1128 * w3344) / w1138
    w3346 = w794 * (w3341 / w353 - w1135 * w3345) + w795 * (w3342 / w353 - w1133 * w3345) + w796 * (w3343 / w353 - w1131 * w3345)
    w3347 = w3 * (w5 * w3273 - w65 * w3276) - w754 * (w5 * w3274 + w65 * w3275) + w777 * (w5 * w3275 - w65 * w3274)
    w3348 = w3347 - w788 * (w65 * w3273 + w5 * w3276)
    w3349 = (w3346 + (w797 * (w3344 / w353 - w1130 * w3345) + w385 * w3348)) / w353 - w1129 * w3345
    w3350 = w798 * w3300 + w289 * w3349 - (w797 * w3299 + w288 * w3348 - (w794 * w3279 + w795 * w3283 + w796 * w3289))
    w3351 = w798 * w3340 + w348 * w3349 - (w794 * w3333 + w795 * w3335 + w796 * w3337 + (w797 * w3339 + w347 * w3348))
    w3352 = w3351 / w340 - w1160 * w3332
    w3353 = w798 * w3316 + w318 * w3349 - (w797 * w3315 + w317 * w3348 - (w794 * w3309 + w795 * w3311 + w796 * w3313))
    w3354 = (w3353 - (w1000 * w3327 + w335 * w3352)) / w310 - w1186 * w3308
    w3355 = hinge0_angle_dot * ((w3350 - (w1000 * w3322 + w330 * w3352) - (w1004 * w3303 + w305 * w3354)) / w235 - w1208 * w3278)
    w3356 = w68 * w3355
    w3357 = w72 * c55
    w3358 = w72 * w3357
    w3359 = w70 * c55
    w3360 = w3358 + w70 * w3359
    w3361 = w76 * w3359
    w3362 = w69 * w3357 + (w3286 + w3361)
    w3363 = w76 * w3357
    w3364 = w109 * w3359
    w3365 = w3255 - w3363 - w3364
    w3366 = w105 * w3357
    w3367 = w72 * w3359
    w3368 = w3366 + w3367
    w3369 = w104 * (w86 * w3360 - w83 * w3362) - w119 * (w83 * w3365 - w86 * w3368) - w124 * (w83 * w3360 + w86 * w3362)
    w3370 = w3369 + w129 * (w83 * w3368 + w86 * w3365)
    w3371 = w70 * w211
    w3372 = w69 * w220
    w3373 = w3371 - w3372
    w3374 = w15 * w3146 + w138 * w3373 - w3151
    w3375 = w3153 + w17 * w3373 - w144 * w3144
    w3376 = w3147 + w9 * w3373 - w14 * w3144
    w3377 = w138 * w3146 + w14 * w3373 - w3149
    w3378 = w142 * w3374 + w147 * w3375 - w8 * w3376 - w151 * w3377
    w3379 = w142 * w3375 - w147 * w3374 + w151 * w3376 - w8 * w3377
    w3380 = w8 * w3374 - w151 * w3375 + w142 * w3376 - w147 * w3377
    w3381 = w151 * w3374 + w8 * w3375 + w147 * w3376 + w142 * w3377
    w3382 = w153 * w3378 - w158 * w3379 + w162 * w3380 - w68 * w3381
    w3383 = w1207 * w3382 / w1220
    w3384 = w1216 * w3383
    w3385 = bar4_e2 * c127
    w3386 = w3284 - w76 * w3385
    w3387 = w3358 + w3386
    w3388 = w109 * w3357
    w3389 = w3388 - w70 * w3385
    w3390 = w3366 - w109 * w3385
    w3391 = w72 * w3385
    w3392 = w207 * w3357
    w3393 = w3391 + (w3138 - w3392)
    w3394 = w104 * (w83 * w3387 - w86 * w3389) - w119 * (w83 * w3390 - w86 * w3393) + w124 * (w83 * w3389 + w86 * w3387)
    w3395 = w3394 + w129 * (w83 * w3393 + w86 * w3390)
    w3396 = w1213 * w3383
    w3397 = w3367 + w69 * w3385
    w3398 = w3364 + w3391
    w3399 = w207 * w3359
    w3400 = w3128 + w3399 + w105 * w3385
    w3401 = w105 * w3359
    w3402 = w3401 - w3386
    w3403 = w104 * (w83 * w3397 - w86 * w3398) - w119 * (w86 * w3400 + w83 * w3402) + w124 * (w83 * w3398 + w86 * w3397)
    w3404 = w3403 - w129 * (w83 * w3400 - w86 * w3402)
    w3405 = w1210 * w3383
    w3406 = w3372 - w3371
    w3407 = w3188 + (w3187 - w207 * w3146 + w105 * w3406)
    w3408 = w3185 + (w3291 + w76 * w3406 - w105 * w3146)
    w3409 = w72 * w3406 - w3182 + w70 * w3144
    w3410 = w278 * -2.0
    w3411 = w69 * w3406 - w3180 + (w76 * w3144 + w3410)
    w3412 = w119 * (w86 * w3407 + w83 * w3408) + w104 * (w86 * w3409 - w83 * w3411) - w124 * (w83 * w3409 + w86 * w3411)
    w3413 = w3412 - w129 * (w86 * w3408 - w83 * w3407)
    w3414 = w3382 / w235 - w1209 * w3383
    w3415 = w236 * w3370 - w130 * w3384 + (w261 * w3395 - w260 * w3396) + (w275 * w3404 - w274 * w3405) + (w288 * w3413 + w287 * w3414)
    w3416 = w3370 - (w236 * w3415 - w289 * w3384)
    w3417 = w298 * w3374 + w299 * w3375 + w300 * w3376 - w297 * w3377
    w3418 = w288 * w3417 + w304 * w3414 - (w301 * w3384 + w302 * w3396 + w303 * w3405)
    w3419 = w236 * w3418 - w305 * w3384
    w3420 = w3417 - (w288 * w3418 + w305 * w3414)
    w3421 = w261 * w3418 - w305 * w3396
    w3422 = w275 * w3418 - w305 * w3405
    w3423 = (w1185 * w3420 - (w1202 * w3419 + w1200 * w3421 + w1198 * w3422)) / w1195
    w3424 = w3419 / w310 + w1192 * w3423
    w3425 = w3395 - (w261 * w3415 - w289 * w3396)
    w3426 = w3421 / w310 + w1190 * w3423
    w3427 = w3404 - (w275 * w3415 - w289 * w3405)
    w3428 = w3422 / w310 + w1188 * w3423
    w3429 = w3413 - (w288 * w3415 + w289 * w3414)
    w3430 = w3420 / w310 - w1187 * w3423
    w3431 = w311 * w3416 - w290 * w3424 + (w313 * w3425 - w312 * w3426) + (w315 * w3427 - w314 * w3428) + (w317 * w3429 + w316 * w3430)
    w3432 = w3416 - (w311 * w3431 - w318 * w3424)
    w3433 = w323 * w3360 - w322 * w3368 - w324 * w3362 - w325 * w3365
    w3434 = w324 * w3387 - (w322 * w3393 + w323 * w3389) - w325 * w3390
    w3435 = w322 * w3400 - w323 * w3398 + w324 * w3397 - w325 * w3402
    w3436 = w323 * w3409 - w322 * w3407 - w324 * w3411 + w325 * w3408
    w3437 = w236 * w3433 - w326 * w3384 + (w261 * w3434 - w327 * w3396) + (w275 * w3435 - w328 * w3405) + (w288 * w3436 + w329 * w3414)
    w3438 = w3433 - (w236 * w3437 - w330 * w3384)
    w3439 = w3434 - (w261 * w3437 - w330 * w3396)
    w3440 = w3435 - (w275 * w3437 - w330 * w3405)
    w3441 = w3436 - (w288 * w3437 + w330 * w3414)
    w3442 = w311 * w3438 - w331 * w3424 + (w313 * w3439 - w332 * w3426) + (w315 * w3440 - w333 * w3428) + (w317 * w3441 + w334 * w3430)
    w3443 = w3438 - (w311 * w3442 - w335 * w3424)
    w3444 = w3439 - (w313 * w3442 - w335 * w3426)
    w3445 = w3440 - (w315 * w3442 - w335 * w3428)
    w3446 = w3441 - (w317 * w3442 + w335 * w3430)
    w3447 = (w1176 * w3443 + w1174 * w3444 + w1172 * w3445 + w1159 * w3446) / w1169
    w3448 = w3443 / w340 - w1166 * w3447
    w3449 = w3425 - (w313 * w3431 - w318 * w3426)
    w3450 = w3444 / w340 - w1164 * w3447
    w3451 = w3427 - (w315 * w3431 - w318 * w3428)
    w3452 = w3445 / w340 - w1162 * w3447
    w3453 = w3429 - (w317 * w3431 + w318 * w3430)
    w3454 = w3446 / w340 - w1161 * w3447
    w3455 = w341 * w3432 + w319 * w3448 + (w343 * w3449 + w342 * w3450) + (w345 * w3451 + w344 * w3452) + (w347 * w3453 + w346 * w3454)
    w3456 = w3432 - (w341 * w3455 + w348 * w3448)
    w3457 = w3449 - (w343 * w3455 + w348 * w3450)
    w3458 = w3451 - (w345 * w3455 + w348 * w3452)
    w3459 = w3453 - (w347 * w3455 + w348 * w3454)
    w3460 = (w1145 * w3456 + w1143 * w3457 + w1141 * w3458 + w1128 * w3459) / w1138
    w3461 = w794 * (w3456 / w353 - w1135 * w3460) + w795 * (w3457 / w353 - w1133 * w3460) + w796 * (w3458 / w353 - w1131 * w3460)
    w3462 = w3 * (w5 * w3378 - w65 * w3381) - w754 * (w5 * w3379 + w65 * w3380) + w777 * (w5 * w3380 - w65 * w3379)
    w3463 = w3462 - w788 * (w65 * w3378 + w5 * w3381)
    w3464 = (w3461 + (w797 * (w3459 / w353 - w1130 * w3460) + w385 * w3463)) / w353 - w1129 * w3460
    w3465 = w798 * w3415 + w289 * w3464 - (w797 * w3414 + w288 * w3463 - (w794 * w3384 + w795 * w3396 + w796 * w3405))
    w3466 = w798 * w3455 + w348 * w3464 - (w794 * w3448 + w795 * w3450 + w796 * w3452 + (w797 * w3454 + w347 * w3463))
    w3467 = w3466 / w340 - w1160 * w3447
    w3468 = w798 * w3431 + w318 * w3464 - (w797 * w3430 + w317 * w3463 - (w794 * w3424 + w795 * w3426 + w796 * w3428))
    w3469 = (w3468 - (w1000 * w3442 + w335 * w3467)) / w310 - w1186 * w3423
    w3470 = hinge0_angle_dot * ((w3465 - (w1000 * w3437 + w330 * w3467) - (w1004 * w3418 + w305 * w3469)) / w235 - w1208 * w3383)
    w3471 = w68 * w3470
    w3472 = w3138 + w69 * w3359 - w3363
    w3473 = w3367 - w70 * w3357
    w3474 = w3401 - w3358
    w3475 = w3286 + w3388
    w3476 = w3361 - w3475
    w3477 = w104 * (w83 * w3472 - w86 * w3473) - w119 * (w86 * w3474 + w83 * w3476) + w124 * (w83 * w3473 + w86 * w3472)
    w3478 = w3477 - w129 * (w83 * w3474 - w86 * w3476)
    w3479 = bar4_e3 * 4.0
    w3480 = w3267 + w211 * w3479
    w3481 = w72 * w211 + w207 * w220
    w3482 = w220 * w3479
    w3483 = w3261 - w3482
    w3484 = w15 * w3480 - w138 * w3481 + w17 * w3483
    w3485 = w148 * w3480 - w17 * w3481 + w144 * w3483
    w3486 = w17 * w3480 - w9 * w3481 + w14 * w3483
    w3487 = w138 * w3480 - w14 * w3481 + w148 * w3483
    w3488 = w142 * w3484 + w147 * w3485 - w8 * w3486 - w151 * w3487
    w3489 = w142 * w3485 - w147 * w3484 + w151 * w3486 - w8 * w3487
    w3490 = w8 * w3484 - w151 * w3485 + w142 * w3486 - w147 * w3487
    w3491 = w151 * w3484 + w8 * w3485 + w147 * w3486 + w142 * w3487
    w3492 = w153 * w3488 - w158 * w3489 + w162 * w3490 - w68 * w3491
    w3493 = w1207 * w3492 / w1220
    w3494 = w1216 * w3493
    w3495 = w3479 * c55
    w3496 = w70 * w3495 + (w3255 + w3364)
    w3497 = w76 * w3495
    w3498 = w3367 + w3497
    w3499 = w3284 - w109 * w3495 - w3401
    w3500 = w72 * w3495
    w3501 = w3399 + w3500
    w3502 = w104 * (w86 * w3496 - w83 * w3498) - w119 * (w83 * w3499 - w86 * w3501) - w124 * (w83 * w3496 + w86 * w3498)
    w3503 = w3502 + w129 * (w83 * w3501 + w86 * w3499)
    w3504 = w1213 * w3493
    w3505 = w3358 - (w3165 - w69 * w3495)
    w3506 = w3475 + w3500
    w3507 = w3392 + w105 * w3495
    w3508 = w3366 + w3497
    w3509 = w104 * (w83 * w3505 - w86 * w3506) - w119 * (w86 * w3507 + w83 * w3508) + w124 * (w83 * w3506 + w86 * w3505)
    w3510 = w3509 - w129 * (w83 * w3507 - w86 * w3508)
    w3511 = w1210 * w3493
    w3512 = w3482 - w3261
    w3513 = w105 * w3481 - w207 * w3480 + w72 * w3512
    w3514 = w76 * w3481 - w105 * w3480 + (w3410 + w109 * w3512)
    w3515 = w3293 - w109 * w3480 + w72 * w3481 + w70 * w3512
    w3516 = w3184 + w69 * w3481 - w72 * w3480 + w76 * w3512
    w3517 = w119 * (w86 * w3513 + w83 * w3514) + w104 * (w86 * w3515 - w83 * w3516) - w124 * (w83 * w3515 + w86 * w3516)
    w3518 = w3517 - w129 * (w86 * w3514 - w83 * w3513)
    w3519 = w3492 / w235 - w1209 * w3493
    w3520 = w236 * w3478 - w130 * w3494 + (w261 * w3503 - w260 * w3504) + (w275 * w3510 - w274 * w3511) + (w288 * w3518 + w287 * w3519)
    w3521 = w3478 - (w236 * w3520 - w289 * w3494)
    w3522 = w298 * w3484 + w299 * w3485 + w300 * w3486 - w297 * w3487
    w3523 = w288 * w3522 + w304 * w3519 - (w301 * w3494 + w302 * w3504 + w303 * w3511)
    w3524 = w236 * w3523 - w305 * w3494
    w3525 = w3522 - (w288 * w3523 + w305 * w3519)
    w3526 = w261 * w3523 - w305 * w3504
    w3527 = w275 * w3523 - w305 * w3511
    w3528 = (w1185 * w3525 - (w1202 * w3524 + w1200 * w3526 + w1198 * w3527)) / w1195
    w3529 = w3524 / w310 + w1192 * w3528
    w3530 = w3503 - (w261 * w3520 - w289 * w3504)
    w3531 = w3526 / w310 + w1190 * w3528
    w3532 = w3510 - (w275 * w3520 - w289 * w3511)
    w3533 = w3527 / w310 + w1188 * w3528
    w3534 = w3518 - (w288 * w3520 + w289 * w3519)
    w3535 = w3525 / w310 - w1187 * w3528
    w3536 = w311 * w3521 - w290 * w3529 + (w313 * w3530 - w312 * w3531) + (w315 * w3532 - w314 * w3533) + (w317 * w3534 + w316 * w3535)
    w3537 = w3521 - (w311 * w3536 - w318 * w3529)
    w3538 = w322 * w3474 - w323 * w3473 + w324 * w3472 - w325 * w3476
    w3539 = w323 * w3496 - w322 * w3501 - w324 * w3498 - w325 * w3499
    w3540 = w322 * w3507 - w323 * w3506 + w324 * w3505 - w325 * w3508
    w3541 = w323 * w3515 - w322 * w3513 - w324 * w3516 + w325 * w3514
    w3542 = w236 * w3538 - w326 * w3494 + (w261 * w3539 - w327 * w3504) + (w275 * w3540 - w328 * w3511) + (w288 * w3541 + w329 * w3519)
    w3543 = w3538 - (w236 * w3542 - w330 * w3494)
    w3544 = w3539 - (w261 * w3542 - w330 * w3504)
    w3545 = w3540 - (w275 * w3542 - w330 * w3511)
    w3546 = w3541 - (w288 * w3542 + w330 * w3519)
    w3547 = w311 * w3543 - w331 * w3529 + (w313 * w3544 - w332 * w3531) + (w315 * w3545 - w333 * w3533) + (w317 * w3546 + w334 * w3535)
    w3548 = w3543 - (w311 * w3547 - w335 * w3529)
    w3549 = w3544 - (w313 * w3547 - w335 * w3531)
    w3550 = w3545 - (w315 * w3547 - w335 * w3533)
    w3551 = w3546 - (w317 * w3547 + w335 * w3535)
    w3552 = (w1176 * w3548 + w1174 * w3549 + w1172 * w3550 + w1159 * w3551) / w1169
    w3553 = w3548 / w340 - w1166 * w3552
    w3554 = w3530 - (w313 * w3536 - w318 * w3531)
    w3555 = w3549 / w340 - w1164 * w3552
    w3556 = w3532 - (w315 * w3536 - w318 * w3533)
    w3557 = w3550 / w340 - w1162 * w3552
    w3558 = w3534 - (w317 * w3536 + w318 * w3535)
    w3559 = w3551 / w340 - w1161 * w3552
    w3560 = w341 * w3537 + w319 * w3553 + (w343 * w3554 + w342 * w3555) + (w345 * w3556 + w344 * w3557) + (w347 * w3558 + w346 * w3559)
    w3561 = w3537 - (w341 * w3560 + w348 * w3553)
    w3562 = w3554 - (w343 * w3560 + w348 * w3555)
    w3563 = w3556 - (w345 * w3560 + w348 * w3557)
    w3564 = w3558 - (w347 * w3560 + w348 * w3559)
    w3565 = (w1145 * w3561 + w1143 * w3562 + w1141 * w3563 + w1128 * w3564) / w1138
    w3566 = w794 * (w3561 / w353 - w1135 * w3565) + w795 * (w3562 / w353 - w1133 * w3565) + w796 * (w3563 / w353 - w1131 * w3565)
    w3567 = w3 * (w5 * w3488 - w65 * w3491) - w754 * (w5 * w3489 + w65 * w3490) + w777 * (w5 * w3490 - w65 * w3489)
    w3568 = w3567 - w788 * (w65 * w3488 + w5 * w3491)
    w3569 = (w3566 + (w797 * (w3564 / w353 - w1130 * w3565) + w385 * w3568)) / w353 - w1129 * w3565
    w3570 = w798 * w3520 + w289 * w3569 - (w797 * w3519 + w288 * w3568 - (w794 * w3494 + w795 * w3504 + w796 * w3511))
    w3571 = w798 * w3560 + w348 * w3569 - (w794 * w3553 + w795 * w3555 + w796 * w3557 + (w797 * w3559 + w347 * w3568))
    w3572 = w3571 / w340 - w1160 * w3552
    w3573 = w798 * w3536 + w318 * w3569 - (w797 * w3535 + w317 * w3568 - (w794 * w3529 + w795 * w3531 + w796 * w3533))
    w3574 = (w3573 - (w1000 * w3547 + w335 * w3572)) / w310 - w1186 * w3528
    w3575 = hinge0_angle_dot * ((w3570 - (w1000 * w3542 + w330 * w3572) - (w1004 * w3523 + w305 * w3574)) / w235 - w1208 * w3493)
    w3576 = w68 * w3575
    w3577 = w94 * c56
    w3578 = w124 * (w120 * w3577)
    w3579 = 2 * w92
    w3580 = w87 * w3577
    w3581 = w3579 + w3580
    w3582 = w112 * w3577
    w3583 = 2 * w98
    w3584 = w121 * w3577
    w3585 = w3578 - (w104 * w3581 + w119 * (w3582 - w3583)) + w129 * w3584
    w3586 = w120 * c56
    w3587 = w125 * w3577
    w3588 = 2 * w246
    w3589 = w87 * w3586
    w3590 = w3588 - w3589
    w3591 = w121 * w3586
    w3592 = w125 * w3586
    w3593 = w104 * (w94 * w3586 + w3587) - w119 * (w3590 - w89 * w3577) - w124 * (w3581 + w3591) - w129 * (w3582 + w3592)
    w3594 = w112 * w3586
    w3595 = w119 * w3594
    w3596 = w120 * w3586
    w3597 = w104 * w3590 - w3595 + w124 * (w3583 + w3596) + w129 * w3591
    w3598 = w236 * w3585 + w261 * w3593 + w275 * w3597
    w3599 = w3585 - w236 * w3598
    w3600 = w3593 - w261 * w3598
    w3601 = w3597 - w275 * w3598
    w3602 = w288 * w3598
    w3603 = w311 * w3599 + w313 * w3600 + w315 * w3601 - w317 * w3602
    w3604 = w3599 - w311 * w3603
    w3605 = w108 * w320 + w111 * w321
    w3606 = w250 * w320 + w251 * w321
    w3607 = w266 * w320 + w267 * w321
    w3608 = w279 * w320 + w280 * w321
    w3609 = w236 * w3605 + w261 * w3606 + w275 * w3607 - w288 * w3608
    w3610 = w3605 - w236 * w3609
    w3611 = w3606 - w261 * w3609
    w3612 = w3607 - w275 * w3609
    w3613 = w3608 + w288 * w3609
    w3614 = w311 * w3610 + w313 * w3611 + w315 * w3612 - w317 * w3613
    w3615 = w3610 - w311 * w3614
    w3616 = w3611 - w313 * w3614
    w3617 = w3612 - w315 * w3614
    w3618 = w3613 + w317 * w3614
    w3619 = (w1176 * w3615 + w1174 * w3616 + w1172 * w3617 - w1159 * w3618) / w1169
    w3620 = w3615 / w340 - w1166 * w3619
    w3621 = w3600 - w313 * w3603
    w3622 = w3616 / w340 - w1164 * w3619
    w3623 = w3601 - w315 * w3603
    w3624 = w3617 / w340 - w1162 * w3619
    w3625 = w3602 + w317 * w3603
    w3626 = w3618 / w340 + w1161 * w3619
    w3627 = w341 * w3604 + w319 * w3620 + (w343 * w3621 + w342 * w3622) + (w345 * w3623 + w344 * w3624) - (w347 * w3625 + w346 * w3626)
    w3628 = w3604 - (w341 * w3627 + w348 * w3620)
    w3629 = w3621 - (w343 * w3627 + w348 * w3622)
    w3630 = w3623 - (w345 * w3627 + w348 * w3624)
    w3631 = w3625 + (w347 * w3627 - w348 * w3626)
    w3632 = (w1145 * w3628 + w1143 * w3629 + w1141 * w3630 - w1128 * w3631) / w1138
    w3633 = w794 * (w3628 / w353 - w1135 * w3632) + w795 * (w3629 / w353 - w1133 * w3632) + w796 * (w3630 / w353 - w1131 * w3632)
    w3634 = (w3633 - w797 * (w3631 / w353 + w1130 * w3632)) / w353 - w1129 * w3632
    w3635 = (w798 * w3627 + w348 * w3634 - (w794 * w3620 + w795 * w3622 + w796 * w3624 - w797 * w3626)) / w340
    w3636 = w3635 - w1160 * w3619
    w3637 = (w798 * w3603 + w318 * w3634 - (w1000 * w3614 + w335 * w3636)) / w310
    w3638 = hinge0_angle_dot * ((w798 * w3598 + w289 * w3634 - (w1000 * w3609 + w330 * w3636) - w305 * w3637) / w235)
    w3639 = w68 * w3638
    w3640 = w87 * c56
    w3641 = w120 * w3640
    w3642 = bar5_e1 * c128
    w3643 = w87 * w3640
    w3644 = w92 * -2.0
    w3645 = w112 * w3640
    w3646 = w3644 + w3645
    w3647 = w87 * w3642
    w3648 = w124 * (w3641 + w121 * w3642) - (w104 * (w3643 - (w3583 - w94 * w3642)) + w119 * (w3646 + w3647))
    w3649 = w121 * w3640
    w3650 = w125 * w3642
    w3651 = w3648 + w129 * (w3649 + w3650)
    w3652 = w89 * c56
    w3653 = w121 * w3652
    w3654 = w125 * w3640
    w3655 = w87 * w3652
    w3656 = w125 * w3652
    w3657 = w124 * (w3653 - w3643) - (w104 * (w3588 + w94 * w3652 - w3654) + w119 * (w3655 - w89 * w3640)) + w129 * (w3656 - w3646)
    w3658 = w246 * -2.0
    w3659 = w112 * w3652
    w3660 = w120 * w3652
    w3661 = w98 * -2.0
    w3662 = w104 * (w3650 + w3655) + w119 * (w89 * w3642 + (w3658 + w3659)) - w124 * (w3647 + w3660) + w129 * (w3661 - w112 * w3642 - w3653)
    w3663 = w236 * w3651 + w261 * w3657 + w275 * w3662
    w3664 = w3651 - w236 * w3663
    w3665 = w3657 - w261 * w3663
    w3666 = w3662 - w275 * w3663
    w3667 = w288 * w3663
    w3668 = w311 * w3664 + w313 * w3665 + w315 * w3666 - w317 * w3667
    w3669 = w3664 - w311 * w3668
    w3670 = w81 * w321 - w85 * w320
    w3671 = w241 * w321 - w242 * w320
    w3672 = w262 * w321 - w263 * w320
    w3673 = w282 * w320 - w283 * w321
    w3674 = w236 * w3670 + w261 * w3671 + w275 * w3672 + w288 * w3673
    w3675 = w3670 - w236 * w3674
    w3676 = w3671 - w261 * w3674
    w3677 = w3672 - w275 * w3674
    w3678 = w3673 - w288 * w3674
    w3679 = w311 * w3675 + w313 * w3676 + w315 * w3677 + w317 * w3678
    w3680 = w3675 - w311 * w3679
    w3681 = w3676 - w313 * w3679
    w3682 = w3677 - w315 * w3679
    w3683 = w3678 - w317 * w3679
    w3684 = (w1176 * w3680 + w1174 * w3681 + w1172 * w3682 + w1159 * w3683) / w1169
    w3685 = w3680 / w340 - w1166 * w3684
    w3686 = w3665 - w313 * w3668
    w3687 = w3681 / w340 - w1164 * w3684
    w3688 = w3666 - w315 * w3668
    w3689 = w3682 / w340 - w1162 * w3684
    w3690 = w3683 / w340 - w1161 * w3684
    w3691 = w3667 + w317 * w3668
    w3692 = w341 * w3669 + w319 * w3685 + (w343 * w3686 + w342 * w3687) + (w345 * w3688 + w344 * w3689) + (w346 * w3690 - w347 * w3691)
    w3693 = w3669 - (w341 * w3692 + w348 * w3685)
    w3694 = w3686 - (w343 * w3692 + w348 * w3687)
    w3695 = w3688 - (w345 * w3692 + w348 * w3689)
    w3696 = w3691 + (w347 * w3692 + w348 * w3690)
    w3697 = (w1145 * w3693 + w1143 * w3694 + w1141 * w3695 - w1128 * w3696) / w1138
    w3698 = w794 * (w3693 / w353 - w1135 * w3697) + w795 * (w3694 / w353 - w1133 * w3697) + w796 * (w3695 / w353 - w1131 * w3697)
    w3699 = (w3698 - w797 * (w3696 / w353 + w1130 * w3697)) / w353 - w1129 * w3697
    w3700 = (w798 * w3692 + w348 * w3699 - (w794 * w3685 + w795 * w3687 + w796 * w3689 + w797 * w3690)) / w340
    w3701 = w3700 - w1160 * w3684
    w3702 = (w798 * w3668 + w318 * w3699 - (w1000 * w3679 + w335 * w3701)) / w310
    w3703 = hinge0_angle_dot * ((w798 * w3663 + w289 * w3699 - (w1000 * w3674 + w330 * w3701) - w305 * w3702) / w235)
    w3704 = w68 * w3703
    w3705 = w124 * (w3596 - w3661) - (w3595 + w104 * w3589) + w129 * (w3591 + w3644)
    w3706 = w3584 + w3658
    w3707 = w124 * (w3706 - w3589) - (w104 * (w94 * w3577 - w3592) + w119 * (w3580 - (w3579 + w89 * w3586))) + w129 * (w3587 - w3594)
    w3708 = w104 * w3580 - w119 * (w3583 - w3582) - w3578 - w129 * w3706
    w3709 = w236 * w3705 + w261 * w3707 + w275 * w3708
    w3710 = w3705 - w236 * w3709
    w3711 = w3707 - w261 * w3709
    w3712 = w3708 - w275 * w3709
    w3713 = w288 * w3709
    w3714 = w311 * w3710 + w313 * w3711 + w315 * w3712 - w317 * w3713
    w3715 = w3710 - w311 * w3714
    w3716 = w85 * w321 + w81 * w320
    w3717 = w242 * w321 + w241 * w320
    w3718 = w263 * w321 + w262 * w320
    w3719 = w282 * w321 + w283 * w320
    w3720 = w236 * w3716 + w261 * w3717 + w275 * w3718 - w288 * w3719
    w3721 = w3716 - w236 * w3720
    w3722 = w3717 - w261 * w3720
    w3723 = w3718 - w275 * w3720
    w3724 = w3719 + w288 * w3720
    w3725 = w311 * w3721 + w313 * w3722 + w315 * w3723 - w317 * w3724
    w3726 = w3721 - w311 * w3725
    w3727 = w3722 - w313 * w3725
    w3728 = w3723 - w315 * w3725
    w3729 = w3724 + w317 * w3725
    w3730 = (w1176 * w3726 + w1174 * w3727 + w1172 * w3728 - w1159 * w3729) / w1169
    w3731 = w3726 / w340 - w1166 * w3730
    w3732 = w3711 - w313 * w3714
    w3733 = w3727 / w340 - w1164 * w3730
    w3734 = w3712 - w315 * w3714
    w3735 = w3728 / w340 - w1162 * w3730
    w3736 = w3713 + w317 * w3714
    w3737 = w3729 / w340 + w1161 * w3730
    w3738 = w341 * w3715 + w319 * w3731 + (w343 * w3732 + w342 * w3733) + (w345 * w3734 + w344 * w3735) - (w347 * w3736 + w346 * w3737)
    w3739 = w3715 - (w341 * w3738 + w348 * w3731)
    w3740 = w3732 - (w343 * w3738 + w348 * w3733)
    w3741 = w3734 - (w345 * w3738 + w348 * w3735)
    w3742 = w3736 + (w347 * w3738 - w348 * w3737)
    w3743 = (w1145 * w3739 + w1143 * w3740 + w1141 * w3741 - w1128 * w3742) / w1138
    w3744 = w794 * (w3739 / w353 - w1135 * w3743) + w795 * (w3740 / w353 - w1133 * w3743) + w796 * (w3741 / w353 - w1131 * w3743)
    w3745 = (w3744 - w797 * (w3742 / w353 + w1130 * w3743)) / w353 - w1129 * w3743
    w3746 = (w798 * w3738 + w348 * w3745 - (w794 * w3731 + w795 * w3733 + w796 * w3735 - w797 * w3737)) / w340
    w3747 = w3746 - w1160 * w3730
    w3748 = (w798 * w3714 + w318 * w3745 - (w1000 * w3725 + w335 * w3747)) / w310
    w3749 = hinge0_angle_dot * ((w798 * w3709 + w289 * w3745 - (w1000 * w3720 + w330 * w3747) - w305 * w3748) / w235)
    w3750 = w68 * w3749
    w3751 = w3252 - w1713 * w3356 - w1725 * w3471 + w1733 * w3576 - w1063 * w3639 - w1068 * w3704 + w1071 * w3750
    w3752 = bar5_e3 * c128
    w3753 = w87 * w3752
    w3754 = w3661 - w125 * w3752
    w3755 = w124 * (w3579 + w3660 + w121 * w3752) - (w104 * (w3655 + w94 * w3752) + w119 * (w3659 + w3753)) + w129 * (w3653 - w3754)
    w3756 = w104 * (w94 * w3640 + (w3644 + w3656)) + w119 * (w3643 + w89 * w3652) - w124 * (w3649 + w3655) + w129 * (w3658 - w3654 - w3659)
    w3757 = w129 * (w3649 - w112 * w3752) - (w104 * (w3643 + w3754) + w119 * (w3645 - w89 * w3752) + w124 * (w3753 + (w3588 - w3641)))
    w3758 = w236 * w3755 + w261 * w3756 + w275 * w3757
    w3759 = w3755 - w236 * w3758
    w3760 = w3756 - w261 * w3758
    w3761 = w3757 - w275 * w3758
    w3762 = w288 * w3758
    w3763 = w311 * w3759 + w313 * w3760 + w315 * w3761 - w317 * w3762
    w3764 = w3759 - w311 * w3763
    w3765 = w108 * w321 - w111 * w320
    w3766 = w250 * w321 - w251 * w320
    w3767 = w266 * w321 - w267 * w320
    w3768 = w280 * w320 - w279 * w321
    w3769 = w236 * w3765 + w261 * w3766 + w275 * w3767 + w288 * w3768
    w3770 = w3765 - w236 * w3769
    w3771 = w3766 - w261 * w3769
    w3772 = w3767 - w275 * w3769
    w3773 = w3768 - w288 * w3769
    w3774 = w311 * w3770 + w313 * w3771 + w315 * w3772 + w317 * w3773
    w3775 = w3770 - w311 * w3774
    w3776 = w3771 - w313 * w3774
    w3777 = w3772 - w315 * w3774
    w3778 = w3773 - w317 * w3774
    w3779 = (w1176 * w3775 + w1174 * w3776 + w1172 * w3777 + w1159 * w3778) / w1169
    w3780 = w3775 / w340 - w1166 * w3779
    w3781 = w3760 - w313 * w3763
    w3782 = w3776 / w340 - w1164 * w3779
    w3783 = w3761 - w315 * w3763
    w3784 = w3777 / w340 - w1162 * w3779
    w3785 = w3778 / w340 - w1161 * w3779
    w3786 = w3762 + w317 * w3763
    w3787 = w341 * w3764 + w319 * w3780 + (w343 * w3781 + w342 * w3782) + (w345 * w3783 + w344 * w3784) + (w346 * w3785 - w347 * w3786)
    w3788 = w3764 - (w341 * w3787 + w348 * w3780)
    w3789 = w3781 - (w343 * w3787 + w348 * w3782)
    w3790 = w3783 - (w345 * w3787 + w348 * w3784)
    w3791 = w3786 + (w347 * w3787 + w348 * w3785)
    w3792 = (w1145 * w3788 + w1143 * w3789 + w1141 * w3790 - w1128 * w3791) / w1138
    w3793 = w794 * (w3788 / w353 - w1135 * w3792) + w795 * (w3789 / w353 - w1133 * w3792) + w796 * (w3790 / w353 - w1131 * w3792)
    w3794 = (w3793 - w797 * (w3791 / w353 + w1130 * w3792)) / w353 - w1129 * w3792
    w3795 = (w798 * w3787 + w348 * w3794 - (w794 * w3780 + w795 * w3782 + w796 * w3784 + w797 * w3785)) / w340
    w3796 = w3795 - w1160 * w3779
    w3797 = (w798 * w3763 + w318 * w3794 - (w1000 * w3774 + w335 * w3796)) / w310
    w3798 = hinge0_angle_dot * ((w798 * w3758 + w289 * w3794 - (w1000 * w3769 + w330 * w3796) - w305 * w3797) / w235)
    w3799 = w68 * w3798
    w3800 = w3 * hinge0_angle_dot
    w3801 = w5 * 0.5
    w3802 = hinge0_angle_dot * w788
    w3803 = w65 * 0.5
    w3804 = w5 * 0.25
    w3805 = w65 * 0.25
    w3806 = bar1_e0 * w3804 - bar1_e3 * w3805
    w3807 = bar1_e0 * w3805 + bar1_e3 * w3804
    w3808 = bar1_e2 * w3804 - bar1_e1 * w3805
    w3809 = bar1_e2 * w3805 + bar1_e1 * w3804
    w3810 = w163 * w3806 - (w152 * w3807 + w157 * w3808 + w161 * w3809)
    w3811 = w188 * w3806 - (w181 * w3807 + w183 * w3808 + w186 * w3809)
    w3812 = w201 * w3806 - (w195 * w3807 + w197 * w3808 + w199 * w3809)
    w3813 = w230 * w3807 + w231 * w3808 + w232 * w3809 + w233 * w3806
    w3814 = (w1227 * w3810 + w1225 * w3811 + w1223 * w3812 - w1207 * w3813) / w1220
    w3815 = w3810 / w235 - w1216 * w3814
    w3816 = w3811 / w235 - w1213 * w3814
    w3817 = w3812 / w235 - w1210 * w3814
    w3818 = w3813 / w235 + w1209 * w3814
    w3819 = w130 * w3815 + w260 * w3816 + w274 * w3817 - w287 * w3818
    w3820 = w236 * w3819 + w289 * w3815
    w3821 = w301 * w3815 + w302 * w3816 + w303 * w3817 - w304 * w3818
    w3822 = w236 * w3821 + w305 * w3815
    w3823 = w261 * w3821 + w305 * w3816
    w3824 = w275 * w3821 + w305 * w3817
    w3825 = w288 * w3821 - w305 * w3818
    w3826 = (w1202 * w3822 + w1200 * w3823 + w1198 * w3824 + w1185 * w3825) / w1195
    w3827 = w1192 * w3826 - w3822 / w310
    w3828 = w1190 * w3826 - w3823 / w310
    w3829 = w261 * w3819 + w289 * w3816
    w3830 = w1188 * w3826 - w3824 / w310
    w3831 = w275 * w3819 + w289 * w3817
    w3832 = w1187 * w3826 - w3825 / w310
    w3833 = w288 * w3819 - w289 * w3818
    w3834 = w290 * w3827 - w311 * w3820 + (w312 * w3828 - w313 * w3829) + (w314 * w3830 - w315 * w3831) + (w316 * w3832 - w317 * w3833)
    w3835 = w3820 + (w311 * w3834 + w318 * w3827)
    w3836 = w326 * w3815 + w327 * w3816 + w328 * w3817 - w329 * w3818
    w3837 = w236 * w3836 + w330 * w3815
    w3838 = w261 * w3836 + w330 * w3816
    w3839 = w275 * w3836 + w330 * w3817
    w3840 = w288 * w3836 - w330 * w3818
    w3841 = w331 * w3827 - w311 * w3837 + (w332 * w3828 - w313 * w3838) + (w333 * w3830 - w315 * w3839) + (w334 * w3832 - w317 * w3840)
    w3842 = w3837 + (w311 * w3841 + w335 * w3827)
    w3843 = w3838 + (w313 * w3841 + w335 * w3828)
    w3844 = w3839 + (w315 * w3841 + w335 * w3830)
    w3845 = w3840 + (w317 * w3841 + w335 * w3832)
    w3846 = (w1176 * w3842 + w1174 * w3843 + w1172 * w3844 + w1159 * w3845) / w1169
    w3847 = w1166 * w3846 - w3842 / w340
    w3848 = w1164 * w3846 - w3843 / w340
    w3849 = w3829 + (w313 * w3834 + w318 * w3828)
    w3850 = w1162 * w3846 - w3844 / w340
    w3851 = w3831 + (w315 * w3834 + w318 * w3830)
    w3852 = w1161 * w3846 - w3845 / w340
    w3853 = w3833 + (w317 * w3834 + w318 * w3832)
    w3854 = w319 * w3847 - w341 * w3835 + (w342 * w3848 - w343 * w3849) + (w344 * w3850 - w345 * w3851) + (w346 * w3852 - w347 * w3853)
    w3855 = w3835 + (w341 * w3854 + w348 * w3847)
    w3856 = w3849 + (w343 * w3854 + w348 * w3848)
    w3857 = w3851 + (w345 * w3854 + w348 * w3850)
    w3858 = w3853 + (w347 * w3854 + w348 * w3852)
    w3859 = (w1145 * w3855 + w1143 * w3856 + w1141 * w3857 + w1128 * w3858) / w1138
    w3860 = w3 * (w163 * w3801 - w152 * w3803) - w754 * (w161 * w3801 - w157 * w3803) - w777 * (w161 * w3803 + w157 * w3801)
    w3861 = w3860 - w788 * (w152 * w3801 + w163 * w3803)
    w3862 = w3 * (w188 * w3801 - w181 * w3803) - w754 * (w186 * w3801 - w183 * w3803) - w777 * (w186 * w3803 + w183 * w3801)
    w3863 = w3862 - w788 * (w181 * w3801 + w188 * w3803)
    w3864 = w794 * (w1135 * w3859 - w3855 / w353) + w354 * w3861 + (w795 * (w1133 * w3859 - w3856 / w353) + w360 * w3863)
    w3865 = w3 * (w201 * w3801 - w195 * w3803) - w754 * (w199 * w3801 - w197 * w3803) - w777 * (w199 * w3803 + w197 * w3801)
    w3866 = w3865 - w788 * (w195 * w3801 + w201 * w3803)
    w3867 = w3 * (w230 * w3803 + w233 * w3801) + w754 * (w232 * w3801 - w231 * w3803) + w777 * (w232 * w3803 + w231 * w3801)
    w3868 = w3867 + w788 * (w230 * w3801 - w233 * w3803)
    w3869 = w3864 + (w796 * (w1131 * w3859 - w3857 / w353) + w375 * w3866) + (w797 * (w1130 * w3859 - w3858 / w353) - w385 * w3868)
    w3870 = w3869 / w353 + w1129 * w3859
    w3871 = w794 * w3815 + w236 * w3861 + (w795 * w3816 + w261 * w3863) + (w796 * w3817 + w275 * w3866) - (w797 * w3818 + w288 * w3868)
    w3872 = w794 * w3847 + w341 * w3861 + (w795 * w3848 + w343 * w3863) + (w796 * w3850 + w345 * w3866) + (w797 * w3852 - w347 * w3868)
    w3873 = (w798 * w3854 + w348 * w3870 - w3872) / w340 + w1160 * w3846
    w3874 = w794 * w3827 + w311 * w3861 + (w795 * w3828 + w313 * w3863) + (w796 * w3830 + w315 * w3866) + (w797 * w3832 - w317 * w3868)
    w3875 = (w798 * w3834 + w318 * w3870 - w3874 - (w1000 * w3841 + w335 * w3873)) / w310 + w1186 * w3826
    w3876 = w798 * w3819 + w289 * w3870 - w3871 - (w1000 * w3836 + w330 * w3873) - (w1004 * w3821 + w305 * w3875)
    w3877 = hinge0_angle_dot * (w3876 / w235 - w1208 * w3814)
    w3878 = w3800 * w3801 - w3802 * w3803 + (w1941 * w3806 + w68 * w3877)
    w3879 = w146 * 0.5
    w3880 = w3879 * c18 * c17 - w3879 * c16 * c19
    w3881 = w7 * 0.5
    w3882 = w7 * c129
    w3883 = w146 * c130
    w3884 = w3881 * c18 * c19 - w3881 * c16 * c17
    w3885 = w133 * w3880 - (w145 * w3882 - w141 * w3883) + w150 * w3884
    w3886 = w141 * w3882 + w145 * w3883 - w133 * w3884 + w150 * w3880
    w3887 = w145 * w3884 - w141 * w3880 + w133 * w3883 + w150 * w3882
    w3888 = w141 * w3884 + w145 * w3880 + w133 * w3882 - w150 * w3883
    w3889 = w153 * w3885 - w158 * w3886 + w162 * w3887 + w68 * w3888
    w3890 = w170 * w3880 - (w179 * w3882 - w178 * w3883) + w180 * w3884
    w3891 = w178 * w3882 + w179 * w3883 - w170 * w3884 + w180 * w3880
    w3892 = w179 * w3884 - w178 * w3880 + w170 * w3883 + w180 * w3882
    w3893 = w178 * w3884 + w179 * w3880 + w170 * w3882 - w180 * w3883
    w3894 = w153 * w3890 - w158 * w3891 + w162 * w3892 + w68 * w3893
    w3895 = w190 * w3880 - (w193 * w3882 - w192 * w3883) + w194 * w3884
    w3896 = w192 * w3882 + w193 * w3883 - w190 * w3884 + w194 * w3880
    w3897 = w193 * w3884 - w192 * w3880 + w190 * w3883 + w194 * w3882
    w3898 = w192 * w3884 + w193 * w3880 + w190 * w3882 - w194 * w3883
    w3899 = w153 * w3895 - w158 * w3896 + w162 * w3897 + w68 * w3898
    w3900 = w227 * w3882 - w226 * w3883 - w228 * w3880 - w229 * w3884
    w3901 = w228 * w3884 - (w227 * w3883 + w226 * w3882) - w229 * w3880
    w3902 = w226 * w3880 - w227 * w3884 - w228 * w3883 - w229 * w3882
    w3903 = w226 * w3884 + w227 * w3880 + w228 * w3882 - w229 * w3883
    w3904 = w153 * w3900 - w158 * w3901 + w162 * w3902 - w68 * w3903
    w3905 = (w1227 * w3889 + w1225 * w3894 + w1223 * w3899 + w1207 * w3904) / w1220
    w3906 = w3889 / w235 - w1216 * w3905
    w3907 = w3894 / w235 - w1213 * w3905
    w3908 = w3899 / w235 - w1210 * w3905
    w3909 = w3904 / w235 - w1209 * w3905
    w3910 = w130 * w3906 + w260 * w3907 + w274 * w3908 + w287 * w3909
    w3911 = w236 * w3910 + w289 * w3906
    w3912 = w7 * 0.25
    w3913 = w7 * c131
    w3914 = w3912 * c18 * c17 - w3912 * c16 * c19
    w3915 = w146 * 0.25
    w3916 = w146 * c132
    w3917 = w3915 * c16 * c17 - w3915 * c18 * c19
    w3918 = bar2_e0 * w3913 + (bar2_e2 * w3914 - bar2_e1 * w3916 + bar2_e3 * w3917)
    w3919 = bar2_e0 * w3917 - bar2_e3 * w3913 + (bar2_e1 * w3914 + bar2_e2 * w3916)
    w3920 = bar2_e0 * w3914 - bar2_e2 * w3913 - (bar2_e3 * w3916 + bar2_e1 * w3917)
    w3921 = bar2_e2 * w3917 - bar2_e3 * w3914 - (bar2_e0 * w3916 + bar2_e1 * w3913)
    w3922 = w150 * w3918 - (w141 * w3919 + w145 * w3920 + w133 * w3921)
    w3923 = w180 * w3918 - (w178 * w3919 + w179 * w3920 + w170 * w3921)
    w3924 = w194 * w3918 - (w192 * w3919 + w193 * w3920 + w190 * w3921)
    w3925 = w226 * w3919 + w227 * w3920 + w228 * w3921 - w229 * w3918
    w3926 = w236 * w3922 + w301 * w3906 + (w261 * w3923 + w302 * w3907) + (w275 * w3924 + w303 * w3908) + (w288 * w3925 + w304 * w3909)
    w3927 = w3922 - (w236 * w3926 + w305 * w3906)
    w3928 = w3923 - (w261 * w3926 + w305 * w3907)
    w3929 = w3924 - (w275 * w3926 + w305 * w3908)
    w3930 = w3925 - (w288 * w3926 + w305 * w3909)
    w3931 = (w1202 * w3927 + w1200 * w3928 + w1198 * w3929 + w1185 * w3930) / w1195
    w3932 = w3927 / w310 - w1192 * w3931
    w3933 = w3928 / w310 - w1190 * w3931
    w3934 = w261 * w3910 + w289 * w3907
    w3935 = w3929 / w310 - w1188 * w3931
    w3936 = w275 * w3910 + w289 * w3908
    w3937 = w3930 / w310 - w1187 * w3931
    w3938 = w288 * w3910 + w289 * w3909
    w3939 = w290 * w3932 - w311 * w3911 + (w312 * w3933 - w313 * w3934) + (w314 * w3935 - w315 * w3936) + (w316 * w3937 - w317 * w3938)
    w3940 = w3911 + (w311 * w3939 + w318 * w3932)
    w3941 = w326 * w3906 + w327 * w3907 + w328 * w3908 + w329 * w3909
    w3942 = w236 * w3941 + w330 * w3906
    w3943 = w261 * w3941 + w330 * w3907
    w3944 = w275 * w3941 + w330 * w3908
    w3945 = w288 * w3941 + w330 * w3909
    w3946 = w331 * w3932 - w311 * w3942 + (w332 * w3933 - w313 * w3943) + (w333 * w3935 - w315 * w3944) + (w334 * w3937 - w317 * w3945)
    w3947 = w3942 + (w311 * w3946 + w335 * w3932)
    w3948 = w3943 + (w313 * w3946 + w335 * w3933)
    w3949 = w3944 + (w315 * w3946 + w335 * w3935)
    w3950 = w3945 + (w317 * w3946 + w335 * w3937)
    w3951 = (w1176 * w3947 + w1174 * w3948 + w1172 * w3949 + w1159 * w3950) / w1169
    w3952 = w1166 * w3951 - w3947 / w340
    w3953 = w1164 * w3951 - w3948 / w340
    w3954 = w3934 + (w313 * w3939 + w318 * w3933)
    w3955 = w1162 * w3951 - w3949 / w340
    w3956 = w3936 + (w315 * w3939 + w318 * w3935)
    w3957 = w1161 * w3951 - w3950 / w340
    w3958 = w3938 + (w317 * w3939 + w318 * w3937)
    w3959 = w319 * w3952 - w341 * w3940 + (w342 * w3953 - w343 * w3954) + (w344 * w3955 - w345 * w3956) + (w346 * w3957 - w347 * w3958)
    w3960 = w3940 + (w341 * w3959 + w348 * w3952)
    w3961 = w3954 + (w343 * w3959 + w348 * w3953)
    w3962 = w3956 + (w345 * w3959 + w348 * w3955)
    w3963 = w3958 + (w347 * w3959 + w348 * w3957)
    w3964 = (w1145 * w3960 + w1143 * w3961 + w1141 * w3962 + w1128 * w3963) / w1138
    w3965 = w3 * (w5 * w3885 + w65 * w3888) - w754 * (w5 * w3886 + w65 * w3887) + w777 * (w5 * w3887 - w65 * w3886)
    w3966 = w3965 - w788 * (w65 * w3885 - w5 * w3888)
    w3967 = w3 * (w5 * w3890 + w65 * w3893) - w754 * (w5 * w3891 + w65 * w3892) + w777 * (w5 * w3892 - w65 * w3891)
    w3968 = w3967 - w788 * (w65 * w3890 - w5 * w3893)
    w3969 = w794 * (w1135 * w3964 - w3960 / w353) + w354 * w3966 + (w795 * (w1133 * w3964 - w3961 / w353) + w360 * w3968)
    w3970 = w3 * (w5 * w3895 + w65 * w3898) - w754 * (w5 * w3896 + w65 * w3897) + w777 * (w5 * w3897 - w65 * w3896)
    w3971 = w3970 - w788 * (w65 * w3895 - w5 * w3898)
    w3972 = w3 * (w5 * w3900 - w65 * w3903) - w754 * (w5 * w3901 + w65 * w3902) + w777 * (w5 * w3902 - w65 * w3901)
    w3973 = w3972 - w788 * (w65 * w3900 + w5 * w3903)
    w3974 = w3969 + (w796 * (w1131 * w3964 - w3962 / w353) + w375 * w3971) + (w797 * (w1130 * w3964 - w3963 / w353) + w385 * w3973)
    w3975 = w3974 / w353 + w1129 * w3964
    w3976 = w794 * w3906 + w236 * w3966 + (w795 * w3907 + w261 * w3968) + (w796 * w3908 + w275 * w3971) + (w797 * w3909 + w288 * w3973)
    w3977 = w794 * w3952 + w341 * w3966 + (w795 * w3953 + w343 * w3968) + (w796 * w3955 + w345 * w3971) + (w797 * w3957 + w347 * w3973)
    w3978 = (w798 * w3959 + w348 * w3975 - w3977) / w340 + w1160 * w3951
    w3979 = w794 * w3932 + w311 * w3966 + (w795 * w3933 + w313 * w3968) + (w796 * w3935 + w315 * w3971) + (w797 * w3937 + w317 * w3973)
    w3980 = (w798 * w3939 + w318 * w3975 - w3979 - (w1000 * w3946 + w335 * w3978)) / w310 - w1186 * w3931
    w3981 = w798 * w3910 + w289 * w3975 - w3976 - (w1000 * w3941 + w330 * w3978) - (w1004 * w3926 + w305 * w3980)
    w3982 = hinge0_angle_dot * (w3981 / w235 - w1208 * w3905)
    w3983 = w68 * w3982
    w3984 = w86 * 0.5
    w3985 = w83 * 0.5
    w3986 = w104 * (w81 * w3984 + w85 * w3985) - w119 * (w111 * w3984 - w108 * w3985) + w124 * (w85 * w3984 - w81 * w3985)
    w3987 = w3986 - w129 * (w108 * w3984 + w111 * w3985)
    w3988 = w104 * (w241 * w3984 + w242 * w3985) - w119 * (w251 * w3984 - w250 * w3985) + w124 * (w242 * w3984 - w241 * w3985)
    w3989 = w3988 - w129 * (w250 * w3984 + w251 * w3985)
    w3990 = w104 * (w262 * w3984 + w263 * w3985) - w119 * (w267 * w3984 - w266 * w3985) + w124 * (w263 * w3984 - w262 * w3985)
    w3991 = w3990 - w129 * (w266 * w3984 + w267 * w3985)
    w3992 = w119 * (w280 * w3984 - w279 * w3985) - w104 * (w282 * w3985 + w283 * w3984) - w124 * (w282 * w3984 - w283 * w3985)
    w3993 = w3992 + w129 * (w280 * w3985 + w279 * w3984)
    w3994 = w236 * w3987 + w261 * w3989 + w275 * w3991 + w288 * w3993
    w3995 = w3987 - w236 * w3994
    w3996 = w3989 - w261 * w3994
    w3997 = w3991 - w275 * w3994
    w3998 = w3993 - w288 * w3994
    w3999 = w311 * w3995 + w313 * w3996 + w315 * w3997 + w317 * w3998
    w4000 = w3995 - w311 * w3999
    w4001 = w86 * 0.25
    w4002 = w83 * 0.25
    w4003 = bar5_e3 * w4001 - bar5_e0 * w4002
    w4004 = bar5_e1 * w4002 + bar5_e2 * w4001
    w4005 = bar5_e1 * w4001 - bar5_e2 * w4002
    w4006 = bar5_e3 * w4002 + bar5_e0 * w4001
    w4007 = w108 * w4003 + w85 * w4004 + w81 * w4005 + w111 * w4006
    w4008 = w250 * w4003 + w242 * w4004 + w241 * w4005 + w251 * w4006
    w4009 = w266 * w4003 + w263 * w4004 + w262 * w4005 + w267 * w4006
    w4010 = w282 * w4004 + w279 * w4003 + w283 * w4005 + w280 * w4006
    w4011 = w236 * w4007 + w261 * w4008 + w275 * w4009 - w288 * w4010
    w4012 = w4007 - w236 * w4011
    w4013 = w4008 - w261 * w4011
    w4014 = w4009 - w275 * w4011
    w4015 = w4010 + w288 * w4011
    w4016 = w311 * w4012 + w313 * w4013 + w315 * w4014 - w317 * w4015
    w4017 = w4012 - w311 * w4016
    w4018 = w4013 - w313 * w4016
    w4019 = w4014 - w315 * w4016
    w4020 = w4015 + w317 * w4016
    w4021 = (w1176 * w4017 + w1174 * w4018 + w1172 * w4019 - w1159 * w4020) / w1169
    w4022 = w4017 / w340 - w1166 * w4021
    w4023 = w3996 - w313 * w3999
    w4024 = w4018 / w340 - w1164 * w4021
    w4025 = w3997 - w315 * w3999
    w4026 = w4019 / w340 - w1162 * w4021
    w4027 = w3998 - w317 * w3999
    w4028 = w4020 / w340 + w1161 * w4021
    w4029 = w341 * w4000 + w319 * w4022 + (w343 * w4023 + w342 * w4024) + (w345 * w4025 + w344 * w4026) + (w347 * w4027 - w346 * w4028)
    w4030 = w4000 - (w341 * w4029 + w348 * w4022)
    w4031 = w4023 - (w343 * w4029 + w348 * w4024)
    w4032 = w4025 - (w345 * w4029 + w348 * w4026)
    w4033 = w4027 - (w347 * w4029 - w348 * w4028)
    w4034 = (w1145 * w4030 + w1143 * w4031 + w1141 * w4032 + w1128 * w4033) / w1138
    w4035 = w794 * (w4030 / w353 - w1135 * w4034) + w795 * (w4031 / w353 - w1133 * w4034) + w796 * (w4032 / w353 - w1131 * w4034)
    w4036 = (w4035 + w797 * (w4033 / w353 - w1130 * w4034)) / w353 - w1129 * w4034
    w4037 = (w798 * w4029 + w348 * w4036 - (w794 * w4022 + w795 * w4024 + w796 * w4026 - w797 * w4028)) / w340
    w4038 = w4037 - w1160 * w4021
    w4039 = (w798 * w3999 + w318 * w4036 - (w1000 * w4016 + w335 * w4038)) / w310
    w4040 = hinge0_angle_dot * ((w798 * w3994 + w289 * w4036 - (w1000 * w4011 + w330 * w4038) - w305 * w4039) / w235)
    w4041 = w68 * w4040
    w4042 = w117 * 0.25
    w4043 = w4042 * c57 * c58 - w4042 * c59 * c60
    w4044 = w102 * 0.25
    w4045 = w4044 * c57 * c60 - w4044 * c59 * c58
    w4046 = w102 * c133
    w4047 = w117 * c134
    w4048 = w100 * w4043 - w116 * w4045 - w123 * w4046 - w128 * w4047
    w4049 = w248 * w4043 - w254 * w4045 - w257 * w4046 - w259 * w4047
    w4050 = w265 * w4043 - w269 * w4045 - w271 * w4046 - w273 * w4047
    w4051 = w281 * w4045 + w284 * w4043 + w285 * w4046 - w286 * w4047
    w4052 = w236 * w4048 + w261 * w4049 + w275 * w4050 + w288 * w4051
    w4053 = w4048 - w236 * w4052
    w4054 = w4049 - w261 * w4052
    w4055 = w4050 - w275 * w4052
    w4056 = w4051 - w288 * w4052
    w4057 = w311 * w4053 + w313 * w4054 + w315 * w4055 + w317 * w4056
    w4058 = w4053 - w311 * w4057
    w4059 = w4054 - w313 * w4057
    w4060 = w4055 - w315 * w4057
    w4061 = w4056 - w317 * w4057
    w4062 = w341 * w4058 + w343 * w4059 + w345 * w4060 + w347 * w4061
    w4063 = w4058 - w341 * w4062
    w4064 = w4059 - w343 * w4062
    w4065 = w4060 - w345 * w4062
    w4066 = w4061 - w347 * w4062
    w4067 = (w1145 * w4063 + w1143 * w4064 + w1141 * w4065 + w1128 * w4066) / w1138
    w4068 = w794 * (w4063 / w353 - w1135 * w4067) + w795 * (w4064 / w353 - w1133 * w4067) + w796 * (w4065 / w353 - w1131 * w4067)
    w4069 = (w4068 + w797 * (w4066 / w353 - w1130 * w4067)) / w353 - w1129 * w4067
    w4070 = (w798 * w4062 + w348 * w4069) / w340
    w4071 = (w798 * w4057 + w318 * w4069 - w335 * w4070) / w310
    w4072 = hinge0_angle_dot * ((w798 * w4052 + w289 * w4069 - w330 * w4070 - w305 * w4071) / w235)
    w4073 = w68 * w4072
    w4074 = hinge0_angle_dot * w1011
    w4075 = w5 * w1934 + w65 * w1938 + w68 * w4074
    w4076 = (w1940 + w51 * w1401 + w58 * w1404 + w134 * w1406) * (w3751 + w1065 * w3799 - w1008 * w3878 - w1004 * w3983 - w1000 * w4041 + w798 * w4073 - w4075)
    w4077 = w588 * w1863 - w586 * w1864 - w584 * w1865 + w587 * w1866 + w51 * w1389 + w52 * w1390 + w159 * w1391
    w4078 = w5 * w1932 + w65 * w1936 + w162 * w4074
    w4079 = w162 * w2091 - w1942
    w4080 = w162 * w2023
    w4081 = w2172 + w162 * w2170
    w4082 = w162 * w2239
    w4083 = w162 * w2337
    w4084 = w162 * w2438
    w4085 = w162 * w2515
    w4086 = w777 * w4079 - w788 * w4080 - w754 * w4081 + w3 * w4082 - w1419 * w4083 + w1435 * w4084 - w1446 * w4085
    w4087 = w162 * w2601
    w4088 = w162 * w2748
    w4089 = w162 * w2884
    w4090 = w162 * w3009
    w4091 = w162 * w3124
    w4092 = w162 * w3250
    w4093 = w4086 + w1455 * w4087 + w1565 * w4088 + w1580 * w4089 + w1592 * w4090 + w1600 * w4091 + w1699 * w4092
    w4094 = w162 * w3355
    w4095 = w162 * w3470
    w4096 = w162 * w3575
    w4097 = w162 * w3638
    w4098 = w162 * w3703
    w4099 = w162 * w3749
    w4100 = w4093 + w1713 * w4094 + w1725 * w4095 - w1733 * w4096 + w1063 * w4097 + w1068 * w4098 - w1071 * w4099
    w4101 = w162 * w3798
    w4102 = hinge0_angle_dot * w777
    w4103 = hinge0_angle_dot * w754
    w4104 = w162 * w3877 - w1941 * w3809 - (w3803 * w4102 + w3801 * w4103)
    w4105 = w162 * w3982
    w4106 = w162 * w4040
    w4107 = w162 * w4072
    w4108 = (w4077 + w58 * w1401 + w54 * w1404 + w52 * w1406) * (w4078 + (w4100 - w1065 * w4101 + w1008 * w4104 + w1004 * w4105 + w1000 * w4106 - w798 * w4107))
    w4109 = w587 * w1863 + w584 * w1864 - w586 * w1865 - w588 * w1866 + w155 * w1389 + w58 * w1390 + w52 * w1391
    w4110 = w158 * w2023
    w4111 = w2172 + w158 * w2091
    w4112 = w1942 + w158 * w2170
    w4113 = w158 * w2239
    w4114 = w158 * w2337
    w4115 = w158 * w2438
    w4116 = w158 * w2515
    w4117 = w788 * w4110 - w777 * w4111 + w754 * w4112 - w3 * w4113 + w1419 * w4114 - w1435 * w4115 + w1446 * w4116
    w4118 = w158 * w2601
    w4119 = w158 * w2748
    w4120 = w158 * w2884
    w4121 = w158 * w3009
    w4122 = w158 * w3124
    w4123 = w158 * w3250
    w4124 = w4117 - w1455 * w4118 - w1565 * w4119 - w1580 * w4120 - w1592 * w4121 - w1600 * w4122 - w1699 * w4123
    w4125 = w158 * w3355
    w4126 = w158 * w3470
    w4127 = w158 * w3575
    w4128 = w158 * w3638
    w4129 = w158 * w3703
    w4130 = w158 * w3749
    w4131 = w4124 - w1713 * w4125 - w1725 * w4126 + w1733 * w4127 - w1063 * w4128 - w1068 * w4129 + w1071 * w4130
    w4132 = w158 * w3798
    w4133 = w3801 * w4102 - w3803 * w4103 + (w1941 * w3808 + w158 * w3877)
    w4134 = w158 * w3982
    w4135 = w158 * w4040
    w4136 = w158 * w4072
    w4137 = w65 * w1932 - w5 * w1936 + w158 * w4074
    w4138 = (w4109 + w52 * w1401 + w134 * w1404 + w159 * w1406) * (w4131 + w1065 * w4132 - w1008 * w4133 - w1004 * w4134 - w1000 * w4135 + w798 * w4136 - w4137)
    w4139 = w584 * w1863 - w587 * w1864 + w588 * w1865 - w586 * w1866 + w52 * w1389 + w54 * w1390 + w134 * w1391
    w4140 = w5 * w1938 - w65 * w1934 + w153 * w4074
    w4141 = w153 * w2091
    w4142 = w2172 + w153 * w2023
    w4143 = w153 * w2170
    w4144 = w153 * w2239 - w1942
    w4145 = w153 * w2337
    w4146 = w153 * w2438
    w4147 = w153 * w2515
    w4148 = w777 * w4141 - w788 * w4142 - w754 * w4143 + w3 * w4144 - w1419 * w4145 + w1435 * w4146 - w1446 * w4147
    w4149 = w153 * w2601
    w4150 = w153 * w2748
    w4151 = w153 * w2884
    w4152 = w153 * w3009
    w4153 = w153 * w3124
    w4154 = w153 * w3250
    w4155 = w4148 + w1455 * w4149 + w1565 * w4150 + w1580 * w4151 + w1592 * w4152 + w1600 * w4153 + w1699 * w4154
    w4156 = w153 * w3355
    w4157 = w153 * w3470
    w4158 = w153 * w3575
    w4159 = w153 * w3638
    w4160 = w153 * w3703
    w4161 = w153 * w3749
    w4162 = w4155 + w1713 * w4156 + w1725 * w4157 - w1733 * w4158 + w1063 * w4159 + w1068 * w4160 - w1071 * w4161
    w4163 = w153 * w3798
    w4164 = w153 * w3877 - w1941 * w3807 - (w3800 * w3803 + w3801 * w3802)
    w4165 = w153 * w3982
    w4166 = w153 * w4040
    w4167 = w153 * w4072
    w4168 = (w4139 + w155 * w1401 + w52 * w1404 + w51 * w1406) * (w4140 + (w4162 - w1065 * w4163 + w1008 * w4164 + w1004 * w4165 + w1000 * w4166 - w798 * w4167))
    w4169 = hinge0_angle_dot * w1006
    w4170 = hinge0_angle_dot * w2089
    w4171 = hinge0_angle_dot * w2021
    w4172 = w777 * (w8 * w4111 - (w142 * w2092 + w147 * w4079) - w151 * w4141 - w297 * w4170) - w788 * (w8 * w4110 - (w142 * w2024 + w147 * w4080) - w151 * w4142 - w297 * w4171)
    w4173 = hinge0_angle_dot * w2168
    w4174 = hinge0_angle_dot * w2237
    w4175 = w4172 - w754 * (w8 * w4112 - (w142 * w2171 + w147 * w4081) - w151 * w4143 - w297 * w4173) + w3 * (w8 * w4113 - (w142 * w2240 + w147 * w4082) - w151 * w4144 - w297 * w4174)
    w4176 = hinge0_angle_dot * w1004
    w4177 = w292 * w4176
    w4178 = hinge0_angle_dot * w2335
    w4179 = w4175 - w1419 * (w8 * w4114 - (w142 * w2338 + w147 * w4083) - w151 * w4145 - (w4177 + w297 * w4178))
    w4180 = w294 * w4176
    w4181 = hinge0_angle_dot * w2436
    w4182 = w4179 + w1435 * (w8 * w4115 - (w142 * w2439 + w147 * w4084) - w151 * w4146 - (w4180 + w297 * w4181))
    w4183 = w295 * w4176
    w4184 = hinge0_angle_dot * w2513
    w4185 = w4182 - w1446 * (w8 * w4116 - (w142 * w2516 + w147 * w4085) - w151 * w4147 - (w4183 + w297 * w4184))
    w4186 = w296 * w4176
    w4187 = hinge0_angle_dot * w2599
    w4188 = w4185 + w1455 * (w8 * w4118 - (w142 * w2602 + w147 * w4087) - w151 * w4149 - (w4186 + w297 * w4187))
    w4189 = hinge0_angle_dot * w2746
    w4190 = hinge0_angle_dot * w2882
    w4191 = w4188 + w1565 * (w8 * w4119 - (w142 * w2749 + w147 * w4088) - w151 * w4150 - w297 * w4189) + w1580 * (w8 * w4120 - (w142 * w2885 + w147 * w4089) - w151 * w4151 - w297 * w4190)
    w4192 = hinge0_angle_dot * w3007
    w4193 = hinge0_angle_dot * w3122
    w4194 = w4191 + w1592 * (w8 * w4121 - (w142 * w3010 + w147 * w4090) - w151 * w4152 - w297 * w4192) + w1600 * (w8 * w4122 - (w142 * w3125 + w147 * w4091) - w151 * w4153 - w297 * w4193)
    w4195 = hinge0_angle_dot * w3249
    w4196 = hinge0_angle_dot * w3354
    w4197 = w4194 + w1699 * (w8 * w4123 - (w142 * w3251 + w147 * w4092) - w151 * w4154 - w297 * w4195) + w1713 * (w8 * w4125 - (w142 * w3356 + w147 * w4094) - w151 * w4156 - w297 * w4196)
    w4198 = hinge0_angle_dot * w3469
    w4199 = hinge0_angle_dot * w3574
    w4200 = w4197 + w1725 * (w8 * w4126 - (w142 * w3471 + w147 * w4095) - w151 * w4157 - w297 * w4198) - w1733 * (w8 * w4127 - (w142 * w3576 + w147 * w4096) - w151 * w4158 - w297 * w4199)
    w4201 = hinge0_angle_dot * w3637
    w4202 = hinge0_angle_dot * w3702
    w4203 = w4200 + w1063 * (w8 * w4128 - (w142 * w3639 + w147 * w4097) - w151 * w4159 - w297 * w4201) + w1068 * (w8 * w4129 - (w142 * w3704 + w147 * w4098) - w151 * w4160 - w297 * w4202)
    w4204 = hinge0_angle_dot * w3748
    w4205 = hinge0_angle_dot * w3797
    w4206 = w4203 - w1071 * (w8 * w4130 - (w142 * w3750 + w147 * w4099) - w151 * w4161 - w297 * w4204) - w1065 * (w8 * w4132 - (w142 * w3799 + w147 * w4101) - w151 * w4163 - w297 * w4205)
    w4207 = hinge0_angle_dot * w3875
    w4208 = w65 * w4102 + w5 * w4103 + w158 * w1941
    w4209 = w5 * w3802 + w65 * w3800 + w68 * w1941
    w4210 = w5 * w4102 - w65 * w4103 + w162 * w1941
    w4211 = w5 * w3800 - w65 * w3802 + w153 * w1941
    w4212 = w3880 * w4208 + w8 * w4134 - (w142 * w3983 - w3883 * w4209 + (w3882 * w4210 + w147 * w4105)) - (w3884 * w4211 + w151 * w4165)
    w4213 = hinge0_angle_dot * w3980
    w4214 = w4206 + w1008 * (w8 * w4133 - (w142 * w3878 + w147 * w4104) - w151 * w4164 - w297 * w4207) + w1004 * (w4212 - (w3918 * w4176 + w297 * w4213))
    w4215 = hinge0_angle_dot * w4039
    w4216 = hinge0_angle_dot * w4071
    w4217 = w4214 + w1000 * (w8 * w4135 - (w142 * w4041 + w147 * w4106) - w151 * w4166 - w297 * w4215) - w798 * (w8 * w4136 - (w142 * w4073 + w147 * w4107) - w151 * w4167 - w297 * w4216)
    w4218 = (w148 * w1539 + w138 * w1542 + w14 * w1543 + w148 * w1546 + w138 * w1548 + w14 * w1551) * (w8 * w4137 - (w142 * w4075 + w147 * w4078) - w151 * w4140 - w297 * w4169 + w4217)
    w4219 = w777 * (w142 * w4079 - w147 * w2092 - w151 * w4111 - w8 * w4141 + w300 * w4170) - w788 * (w142 * w4080 - w147 * w2024 - w151 * w4110 - w8 * w4142 + w300 * w4171)
    w4220 = w4219 - w754 * (w142 * w4081 - w147 * w2171 - w151 * w4112 - w8 * w4143 + w300 * w4173) + w3 * (w142 * w4082 - w147 * w2240 - w151 * w4113 - w8 * w4144 + w300 * w4174)
    w4221 = w4220 - w1419 * (w142 * w4083 - w147 * w2338 - w151 * w4114 - w8 * w4145 + (w4180 + w300 * w4178))
    w4222 = w4221 + w1435 * (w142 * w4084 - w147 * w2439 - w151 * w4115 - w8 * w4146 + (w300 * w4181 - w4177))
    w4223 = w4222 - w1446 * (w142 * w4085 - w147 * w2516 - w151 * w4116 - w8 * w4147 + (w4186 + w300 * w4184))
    w4224 = w4223 + w1455 * (w142 * w4087 - w147 * w2602 - w151 * w4118 - w8 * w4149 + (w300 * w4187 - w4183))
    w4225 = w4224 + w1565 * (w142 * w4088 - w147 * w2749 - w151 * w4119 - w8 * w4150 + w300 * w4189) + w1580 * (w142 * w4089 - w147 * w2885 - w151 * w4120 - w8 * w4151 + w300 * w4190)
    w4226 = w4225 + w1592 * (w142 * w4090 - w147 * w3010 - w151 * w4121 - w8 * w4152 + w300 * w4192) + w1600 * (w142 * w4091 - w147 * w3125 - w151 * w4122 - w8 * w4153 + w300 * w4193)
    w4227 = w4226 + w1699 * (w142 * w4092 - w147 * w3251 - w151 * w4123 - w8 * w4154 + w300 * w4195) + w1713 * (w142 * w4094 - w147 * w3356 - w151 * w4125 - w8 * w4156 + w300 * w4196)
    w4228 = w4227 + w1725 * (w142 * w4095 - w147 * w3471 - w151 * w4126 - w8 * w4157 + w300 * w4198) - w1733 * (w142 * w4096 - w147 * w3576 - w151 * w4127 - w8 * w4158 + w300 * w4199)
    w4229 = w4228 + w1063 * (w142 * w4097 - w147 * w3639 - w151 * w4128 - w8 * w4159 + w300 * w4201) + w1068 * (w142 * w4098 - w147 * w3704 - w151 * w4129 - w8 * w4160 + w300 * w4202)
    w4230 = w4229 - w1071 * (w142 * w4099 - w147 * w3750 - w151 * w4130 - w8 * w4161 + w300 * w4204) - w1065 * (w142 * w4101 - w147 * w3799 - w151 * w4132 - w8 * w4163 + w300 * w4205)
    w4231 = w142 * w4105 - w3883 * w4210 - (w3882 * w4209 + w147 * w3983) - (w3884 * w4208 + w151 * w4134) - (w3880 * w4211 + w8 * w4165)
    w4232 = w4230 + w1008 * (w142 * w4104 - w147 * w3878 - w151 * w4133 - w8 * w4164 + w300 * w4207) + w1004 * (w4231 + (w3921 * w4176 + w300 * w4213))
    w4233 = w4232 + w1000 * (w142 * w4106 - w147 * w4041 - w151 * w4135 - w8 * w4166 + w300 * w4215) - w798 * (w142 * w4107 - w147 * w4073 - w151 * w4136 - w8 * w4167 + w300 * w4216)
    w4234 = (w15 * w1539 + w17 * w1542 + w148 * w1543 + w14 * w1546 + w17 * w1548 + w9 * w1551) * (w142 * w4078 - w147 * w4075 - w151 * w4137 - w8 * w4140 + w300 * w4169 + w4233)
    w4235 = w777 * (w147 * w4141 - (w8 * w2092 + w151 * w4079 + w142 * w4111) + w299 * w4170) - w788 * (w147 * w4142 - (w8 * w2024 + w151 * w4080 + w142 * w4110) + w299 * w4171)
    w4236 = w4235 - w754 * (w147 * w4143 - (w8 * w2171 + w151 * w4081 + w142 * w4112) + w299 * w4173) + w3 * (w147 * w4144 - (w8 * w2240 + w151 * w4082 + w142 * w4113) + w299 * w4174)
    w4237 = w4236 - w1419 * (w147 * w4145 - (w8 * w2338 + w151 * w4083 + w142 * w4114) + (w4183 + w299 * w4178))
    w4238 = w4237 + w1435 * (w147 * w4146 - (w8 * w2439 + w151 * w4084 + w142 * w4115) + (w299 * w4181 - w4186))
    w4239 = w4238 - w1446 * (w147 * w4147 - (w8 * w2516 + w151 * w4085 + w142 * w4116) + (w299 * w4184 - w4177))
    w4240 = w4239 + w1455 * (w147 * w4149 - (w8 * w2602 + w151 * w4087 + w142 * w4118) + (w4180 + w299 * w4187))
    w4241 = w4240 + w1565 * (w147 * w4150 - (w8 * w2749 + w151 * w4088 + w142 * w4119) + w299 * w4189) + w1580 * (w147 * w4151 - (w8 * w2885 + w151 * w4089 + w142 * w4120) + w299 * w4190)
    w4242 = w4241 + w1592 * (w147 * w4152 - (w8 * w3010 + w151 * w4090 + w142 * w4121) + w299 * w4192) + w1600 * (w147 * w4153 - (w8 * w3125 + w151 * w4091 + w142 * w4122) + w299 * w4193)
    w4243 = w4242 + w1699 * (w147 * w4154 - (w8 * w3251 + w151 * w4092 + w142 * w4123) + w299 * w4195) + w1713 * (w147 * w4156 - (w8 * w3356 + w151 * w4094 + w142 * w4125) + w299 * w4196)
    w4244 = w4243 + w1725 * (w147 * w4157 - (w8 * w3471 + w151 * w4095 + w142 * w4126) + w299 * w4198) - w1733 * (w147 * w4158 - (w8 * w3576 + w151 * w4096 + w142 * w4127) + w299 * w4199)
    w4245 = w4244 + w1063 * (w147 * w4159 - (w8 * w3639 + w151 * w4097 + w142 * w4128) + w299 * w4201) + w1068 * (w147 * w4160 - (w8 * w3704 + w151 * w4098 + w142 * w4129) + w299 * w4202)
    w4246 = w4245 - w1071 * (w147 * w4161 - (w8 * w3750 + w151 * w4099 + w142 * w4130) + w299 * w4204) - w1065 * (w147 * w4163 - (w8 * w3799 + w151 * w4101 + w142 * w4132) + w299 * w4205)
    w4247 = w3882 * w4211 + w147 * w4165 - (w3880 * w4209 + w8 * w3983 + (w3884 * w4210 + w151 * w4105) + (w142 * w4134 - w3883 * w4208))
    w4248 = w4246 + w1008 * (w147 * w4164 - (w8 * w3878 + w151 * w4104 + w142 * w4133) + w299 * w4207) + w1004 * (w4247 + (w3920 * w4176 + w299 * w4213))
    w4249 = w4248 + w1000 * (w147 * w4166 - (w8 * w4041 + w151 * w4106 + w142 * w4135) + w299 * w4215) - w798 * (w147 * w4167 - (w8 * w4073 + w151 * w4107 + w142 * w4136) + w299 * w4216)
    w4250 = (w138 * w1539 + w9 * w1542 + w17 * w1543 + w144 * w1546 + w148 * w1548 + w17 * w1551) * (w147 * w4140 - (w8 * w4075 + w151 * w4078 + w142 * w4137) + w299 * w4169 + w4249)
    w4251 = w777 * (w8 * w4079 - w151 * w2092 + w147 * w4111 + w142 * w4141 + w298 * w4170) - w788 * (w8 * w4080 - w151 * w2024 + w147 * w4110 + w142 * w4142 + w298 * w4171)
    w4252 = w4251 - w754 * (w8 * w4081 - w151 * w2171 + w147 * w4112 + w142 * w4143 + w298 * w4173) + w3 * (w8 * w4082 - w151 * w2240 + w147 * w4113 + w142 * w4144 + w298 * w4174)
    w4253 = w4252 - w1419 * (w8 * w4083 - w151 * w2338 + w147 * w4114 + w142 * w4145 + (w4186 + w298 * w4178))
    w4254 = w4253 + w1435 * (w8 * w4084 - w151 * w2439 + w147 * w4115 + w142 * w4146 + (w4183 + w298 * w4181))
    w4255 = w4254 - w1446 * (w8 * w4085 - w151 * w2516 + w147 * w4116 + w142 * w4147 + (w298 * w4184 - w4180))
    w4256 = w4255 + w1455 * (w8 * w4087 - w151 * w2602 + w147 * w4118 + w142 * w4149 + (w298 * w4187 - w4177))
    w4257 = w4256 + w1565 * (w8 * w4088 - w151 * w2749 + w147 * w4119 + w142 * w4150 + w298 * w4189) + w1580 * (w8 * w4089 - w151 * w2885 + w147 * w4120 + w142 * w4151 + w298 * w4190)
    w4258 = w4257 + w1592 * (w8 * w4090 - w151 * w3010 + w147 * w4121 + w142 * w4152 + w298 * w4192) + w1600 * (w8 * w4091 - w151 * w3125 + w147 * w4122 + w142 * w4153 + w298 * w4193)
    w4259 = w4258 + w1699 * (w8 * w4092 - w151 * w3251 + w147 * w4123 + w142 * w4154 + w298 * w4195) + w1713 * (w8 * w4094 - w151 * w3356 + w147 * w4125 + w142 * w4156 + w298 * w4196)
    w4260 = w4259 + w1725 * (w8 * w4095 - w151 * w3471 + w147 * w4126 + w142 * w4157 + w298 * w4198) - w1733 * (w8 * w4096 - w151 * w3576 + w147 * w4127 + w142 * w4158 + w298 * w4199)
    w4261 = w4260 + w1063 * (w8 * w4097 - w151 * w3639 + w147 * w4128 + w142 * w4159 + w298 * w4201) + w1068 * (w8 * w4098 - w151 * w3704 + w147 * w4129 + w142 * w4160 + w298 * w4202)
    w4262 = w4261 - w1071 * (w8 * w4099 - w151 * w3750 + w147 * w4130 + w142 * w4161 + w298 * w4204) - w1065 * (w8 * w4101 - w151 * w3799 + w147 * w4132 + w142 * w4163 + w298 * w4205)
    w4263 = w3880 * w4210 + w8 * w4105 - (w3884 * w4209 + w151 * w3983) + (w3882 * w4208 + w147 * w4134) + (w142 * w4165 - w3883 * w4211)
    w4264 = w4262 + w1008 * (w8 * w4104 - w151 * w3878 + w147 * w4133 + w142 * w4164 + w298 * w4207) + w1004 * (w4263 + (w3919 * w4176 + w298 * w4213))
    w4265 = w4264 + w1000 * (w8 * w4106 - w151 * w4041 + w147 * w4135 + w142 * w4166 + w298 * w4215) - w798 * (w8 * w4107 - w151 * w4073 + w147 * w4136 + w142 * w4167 + w298 * w4216)
    w4266 = (w17 * w1539 + w14 * w1542 + w144 * w1543 + w17 * w1546 + w15 * w1548 + w138 * w1551) * (w8 * w4078 - w151 * w4075 + w147 * w4137 + w142 * w4140 + w298 * w4169 + w4265)
    w4267 = hinge0_angle_dot * w999
    w4268 = w129 * w4267
    w4269 = w119 * w4267
    w4270 = hinge0_angle_dot * w1002
    w4271 = hinge0_angle_dot * w2084
    w4272 = w129 * w4271
    w4273 = w119 * w4271
    w4274 = hinge0_angle_dot * w2087
    w4275 = hinge0_angle_dot * w2016
    w4276 = w129 * w4275
    w4277 = w119 * w4275
    w4278 = hinge0_angle_dot * w2019
    w4279 = w777 * (w86 * w4272 - w83 * w4273 + w325 * w4274) - w788 * (w86 * w4276 - w83 * w4277 + w325 * w4278)
    w4280 = hinge0_angle_dot * w2163
    w4281 = w129 * w4280
    w4282 = w119 * w4280
    w4283 = hinge0_angle_dot * w2166
    w4284 = hinge0_angle_dot * w2232
    w4285 = w129 * w4284
    w4286 = w119 * w4284
    w4287 = hinge0_angle_dot * w2235
    w4288 = w4279 - w754 * (w86 * w4281 - w83 * w4282 + w325 * w4283) + w3 * (w86 * w4285 - w83 * w4286 + w325 * w4287)
    w4289 = hinge0_angle_dot * w2330
    w4290 = w129 * w4289
    w4291 = w119 * w4289
    w4292 = hinge0_angle_dot * w2333
    w4293 = hinge0_angle_dot * w2431
    w4294 = w129 * w4293
    w4295 = w119 * w4293
    w4296 = hinge0_angle_dot * w2434
    w4297 = w4288 - w1419 * (w86 * w4290 - w83 * w4291 + w325 * w4292) + w1435 * (w86 * w4294 - w83 * w4295 + w325 * w4296)
    w4298 = hinge0_angle_dot * w2508
    w4299 = w129 * w4298
    w4300 = w119 * w4298
    w4301 = hinge0_angle_dot * w2511
    w4302 = hinge0_angle_dot * w2594
    w4303 = w129 * w4302
    w4304 = w119 * w4302
    w4305 = hinge0_angle_dot * w2597
    w4306 = w4297 - w1446 * (w86 * w4299 - w83 * w4300 + w325 * w4301) + w1455 * (w86 * w4303 - w83 * w4304 + w325 * w4305)
    w4307 = hinge0_angle_dot * w2741
    w4308 = w129 * w4307
    w4309 = w119 * w4307
    w4310 = hinge0_angle_dot * w2744
    w4311 = hinge0_angle_dot * w2877
    w4312 = w129 * w4311
    w4313 = w119 * w4311
    w4314 = hinge0_angle_dot * w2880
    w4315 = w4306 + w1565 * (w86 * w4308 - w83 * w4309 + w325 * w4310) + w1580 * (w86 * w4312 - w83 * w4313 + w325 * w4314)
    w4316 = hinge0_angle_dot * w3002
    w4317 = w129 * w4316
    w4318 = w119 * w4316
    w4319 = hinge0_angle_dot * w3005
    w4320 = hinge0_angle_dot * w3117
    w4321 = w129 * w4320
    w4322 = w119 * w4320
    w4323 = hinge0_angle_dot * w3120
    w4324 = w4315 + w1592 * (w86 * w4317 - w83 * w4318 + w325 * w4319) + w1600 * (w86 * w4321 - w83 * w4322 + w325 * w4323)
    w4325 = hinge0_angle_dot * w3244
    w4326 = w129 * w4325
    w4327 = w119 * w4325
    w4328 = hinge0_angle_dot * w3247
    w4329 = hinge0_angle_dot * w3349
    w4330 = w129 * w4329
    w4331 = w119 * w4329
    w4332 = hinge0_angle_dot * w3352
    w4333 = w4324 + w1699 * (w86 * w4326 - w83 * w4327 + w325 * w4328) + w1713 * (w86 * w4330 - w83 * w4331 + w325 * w4332)
    w4334 = hinge0_angle_dot * w3464
    w4335 = w129 * w4334
    w4336 = w119 * w4334
    w4337 = hinge0_angle_dot * w3467
    w4338 = hinge0_angle_dot * w3569
    w4339 = w129 * w4338
    w4340 = w119 * w4338
    w4341 = hinge0_angle_dot * w3572
    w4342 = w4333 + w1725 * (w86 * w4335 - w83 * w4336 + w325 * w4337) - w1733 * (w86 * w4339 - w83 * w4340 + w325 * w4341)
    w4343 = hinge0_angle_dot * w3634
    w4344 = w129 * w4343
    w4345 = w119 * w4343
    w4346 = hinge0_angle_dot * w3636
    w4347 = hinge0_angle_dot * w1000
    w4348 = w321 * w4347
    w4349 = hinge0_angle_dot * w3699
    w4350 = w129 * w4349
    w4351 = w119 * w4349
    w4352 = hinge0_angle_dot * w3701
    w4353 = w4342 + w1063 * (w86 * w4344 - w83 * w4345 + (w325 * w4346 - w4348)) + w1068 * (w86 * w4350 - w83 * w4351 + w325 * w4352)
    w4354 = hinge0_angle_dot * w3745
    w4355 = w129 * w4354
    w4356 = w119 * w4354
    w4357 = hinge0_angle_dot * w3747
    w4358 = hinge0_angle_dot * w3794
    w4359 = w129 * w4358
    w4360 = w119 * w4358
    w4361 = w320 * w4347
    w4362 = hinge0_angle_dot * w3796
    w4363 = w4353 - w1071 * (w86 * w4355 - w83 * w4356 + w325 * w4357) - w1065 * (w86 * w4359 - w83 * w4360 + (w4361 + w325 * w4362))
    w4364 = hinge0_angle_dot * w3870
    w4365 = w129 * w4364
    w4366 = w119 * w4364
    w4367 = hinge0_angle_dot * w3873
    w4368 = hinge0_angle_dot * w3975
    w4369 = w129 * w4368
    w4370 = w119 * w4368
    w4371 = hinge0_angle_dot * w3978
    w4372 = w4363 + w1008 * (w86 * w4365 - w83 * w4366 + w325 * w4367) + w1004 * (w86 * w4369 - w83 * w4370 + w325 * w4371)
    w4373 = hinge0_angle_dot * w4036
    w4374 = w129 * w4373
    w4375 = hinge0_angle_dot * w798
    w4376 = w129 * w4375
    w4377 = w119 * w4375
    w4378 = w119 * w4373
    w4379 = hinge0_angle_dot * w4038
    w4380 = w1000 * (w86 * w4374 - w3985 * w4376 - (w3984 * w4377 + w83 * w4378) + (w325 * w4379 - w4006 * w4347))
    w4381 = hinge0_angle_dot * w4069
    w4382 = w4047 * w4375 + w129 * w4381
    w4383 = w4045 * w4375 + w119 * w4381
    w4384 = hinge0_angle_dot * w4070
    w4385 = w86 * w4268 - w83 * w4269 + w325 * w4270 + (w4372 + w4380 - w798 * (w86 * w4382 - w83 * w4383 + w325 * w4384))
    w4386 = w1939 + w4076 + w4108 + w4138 + w4168 + w4218 + w4234 + w4250 + w4266 + (w105 * w1657 + w76 * w1661 + w109 * w1662 + w109 * w1677 + w105 * w1681 + w76 * w1683) * w4385
    w4387 = w124 * w4267
    w4388 = w104 * w4267
    w4389 = w124 * w4271
    w4390 = w104 * w4271
    w4391 = w124 * w4275
    w4392 = w104 * w4275
    w4393 = w777 * (w86 * w4389 + w83 * w4390 - w324 * w4274) - w788 * (w86 * w4391 + w83 * w4392 - w324 * w4278)
    w4394 = w124 * w4280
    w4395 = w104 * w4280
    w4396 = w124 * w4284
    w4397 = w104 * w4284
    w4398 = w4393 - w754 * (w86 * w4394 + w83 * w4395 - w324 * w4283) + w3 * (w86 * w4396 + w83 * w4397 - w324 * w4287)
    w4399 = w124 * w4289
    w4400 = w104 * w4289
    w4401 = w124 * w4293
    w4402 = w104 * w4293
    w4403 = w4398 - w1419 * (w86 * w4399 + w83 * w4400 - w324 * w4292) + w1435 * (w86 * w4401 + w83 * w4402 - w324 * w4296)
    w4404 = w124 * w4298
    w4405 = w104 * w4298
    w4406 = w124 * w4302
    w4407 = w104 * w4302
    w4408 = w4403 - w1446 * (w86 * w4404 + w83 * w4405 - w324 * w4301) + w1455 * (w86 * w4406 + w83 * w4407 - w324 * w4305)
    w4409 = w124 * w4307
    w4410 = w104 * w4307
    w4411 = w124 * w4311
    w4412 = w104 * w4311
    w4413 = w4408 + w1565 * (w86 * w4409 + w83 * w4410 - w324 * w4310) + w1580 * (w86 * w4411 + w83 * w4412 - w324 * w4314)
    w4414 = w124 * w4316
    w4415 = w104 * w4316
    w4416 = w124 * w4320
    w4417 = w104 * w4320
    w4418 = w4413 + w1592 * (w86 * w4414 + w83 * w4415 - w324 * w4319) + w1600 * (w86 * w4416 + w83 * w4417 - w324 * w4323)
    w4419 = w124 * w4325
    w4420 = w104 * w4325
    w4421 = w124 * w4329
    w4422 = w104 * w4329
    w4423 = w4418 + w1699 * (w86 * w4419 + w83 * w4420 - w324 * w4328) + w1713 * (w86 * w4421 + w83 * w4422 - w324 * w4332)
    w4424 = w124 * w4334
    w4425 = w104 * w4334
    w4426 = w124 * w4338
    w4427 = w104 * w4338
    w4428 = w4423 + w1725 * (w86 * w4424 + w83 * w4425 - w324 * w4337) - w1733 * (w86 * w4426 + w83 * w4427 - w324 * w4341)
    w4429 = w124 * w4343
    w4430 = w104 * w4343
    w4431 = w124 * w4349
    w4432 = w104 * w4349
    w4433 = w4428 + w1063 * (w86 * w4429 + w83 * w4430 - w324 * w4346) + w1068 * (w86 * w4431 + w83 * w4432 - (w4348 + w324 * w4352))
    w4434 = w124 * w4354
    w4435 = w104 * w4354
    w4436 = w124 * w4358
    w4437 = w104 * w4358
    w4438 = w4433 - w1071 * (w86 * w4434 + w83 * w4435 - (w4361 + w324 * w4357)) - w1065 * (w86 * w4436 + w83 * w4437 - w324 * w4362)
    w4439 = w124 * w4364
    w4440 = w104 * w4364
    w4441 = w124 * w4368
    w4442 = w104 * w4368
    w4443 = w4438 + w1008 * (w86 * w4439 + w83 * w4440 - w324 * w4367) + w1004 * (w86 * w4441 + w83 * w4442 - w324 * w4371)
    w4444 = w124 * w4373
    w4445 = w124 * w4375
    w4446 = w104 * w4375
    w4447 = w104 * w4373
    w4448 = w1000 * (w86 * w4444 - w3985 * w4445 + (w3984 * w4446 + w83 * w4447) - (w4005 * w4347 + w324 * w4379))
    w4449 = w124 * w4381 - w4046 * w4375
    w4450 = w4043 * w4375 + w104 * w4381
    w4451 = w86 * w4387 + w83 * w4388 - w324 * w4270 + (w4443 + w4448 - w798 * (w86 * w4449 + w83 * w4450 - w324 * w4384))
    w4452 = w4386 + (w72 * w1657 + w109 * w1661 + w207 * w1662 + w76 * w1677 + w72 * w1681 + w69 * w1683) * w4451
    w4453 = w777 * (w83 * w4389 - w86 * w4390 + w323 * w4274) - w788 * (w83 * w4391 - w86 * w4392 + w323 * w4278)
    w4454 = w4453 - w754 * (w83 * w4394 - w86 * w4395 + w323 * w4283) + w3 * (w83 * w4396 - w86 * w4397 + w323 * w4287)
    w4455 = w4454 - w1419 * (w83 * w4399 - w86 * w4400 + w323 * w4292) + w1435 * (w83 * w4401 - w86 * w4402 + w323 * w4296)
    w4456 = w4455 - w1446 * (w83 * w4404 - w86 * w4405 + w323 * w4301) + w1455 * (w83 * w4406 - w86 * w4407 + w323 * w4305)
    w4457 = w4456 + w1565 * (w83 * w4409 - w86 * w4410 + w323 * w4310) + w1580 * (w83 * w4411 - w86 * w4412 + w323 * w4314)
    w4458 = w4457 + w1592 * (w83 * w4414 - w86 * w4415 + w323 * w4319) + w1600 * (w83 * w4416 - w86 * w4417 + w323 * w4323)
    w4459 = w4458 + w1699 * (w83 * w4419 - w86 * w4420 + w323 * w4328) + w1713 * (w83 * w4421 - w86 * w4422 + w323 * w4332)
    w4460 = w4459 + w1725 * (w83 * w4424 - w86 * w4425 + w323 * w4337) - w1733 * (w83 * w4426 - w86 * w4427 + w323 * w4341)
    w4461 = w4460 + w1063 * (w83 * w4429 - w86 * w4430 + w323 * w4346) + w1068 * (w83 * w4431 - w86 * w4432 + (w4361 + w323 * w4352))
    w4462 = w4461 - w1071 * (w83 * w4434 - w86 * w4435 + (w323 * w4357 - w4348)) - w1065 * (w83 * w4436 - w86 * w4437 + w323 * w4362)
    w4463 = w4462 + w1008 * (w83 * w4439 - w86 * w4440 + w323 * w4367) + w1004 * (w83 * w4441 - w86 * w4442 + w323 * w4371)
    w4464 = w1000 * (w3984 * w4445 + w83 * w4444 - (w86 * w4447 - w3985 * w4446) + (w323 * w4379 - w4004 * w4347))
    w4465 = w83 * w4387 - w86 * w4388 + w323 * w4270 + (w4463 + w4464 - w798 * (w83 * w4449 - w86 * w4450 + w323 * w4384))
    w4466 = w4452 + (w69 * w1657 + w72 * w1661 + w105 * w1662 + w70 * w1677 + w109 * w1681 + w72 * w1683) * w4465
    w4467 = w788 * (w83 * w4276 + w86 * w4277 + w322 * w4278) - w777 * (w83 * w4272 + w86 * w4273 + w322 * w4274)
    w4468 = w4467 + w754 * (w83 * w4281 + w86 * w4282 + w322 * w4283) - w3 * (w83 * w4285 + w86 * w4286 + w322 * w4287)
    w4469 = w4468 + w1419 * (w83 * w4290 + w86 * w4291 + w322 * w4292) - w1435 * (w83 * w4294 + w86 * w4295 + w322 * w4296)
    w4470 = w4469 + w1446 * (w83 * w4299 + w86 * w4300 + w322 * w4301) - w1455 * (w83 * w4303 + w86 * w4304 + w322 * w4305)
    w4471 = w4470 - w1565 * (w83 * w4308 + w86 * w4309 + w322 * w4310) - w1580 * (w83 * w4312 + w86 * w4313 + w322 * w4314)
    w4472 = w4471 - w1592 * (w83 * w4317 + w86 * w4318 + w322 * w4319) - w1600 * (w83 * w4321 + w86 * w4322 + w322 * w4323)
    w4473 = w4472 - w1699 * (w83 * w4326 + w86 * w4327 + w322 * w4328) - w1713 * (w83 * w4330 + w86 * w4331 + w322 * w4332)
    w4474 = w4473 - w1725 * (w83 * w4335 + w86 * w4336 + w322 * w4337) + w1733 * (w83 * w4339 + w86 * w4340 + w322 * w4341)
    w4475 = w4474 - w1063 * (w83 * w4344 + w86 * w4345 + (w4361 + w322 * w4346)) - w1068 * (w83 * w4350 + w86 * w4351 + w322 * w4352)
    w4476 = w4475 + w1071 * (w83 * w4355 + w86 * w4356 + w322 * w4357) + w1065 * (w83 * w4359 + w86 * w4360 + (w4348 + w322 * w4362))
    w4477 = w4476 - w1008 * (w83 * w4365 + w86 * w4366 + w322 * w4367) - w1004 * (w83 * w4369 + w86 * w4370 + w322 * w4371)
    w4478 = w1000 * (w3984 * w4376 + w83 * w4374 + (w86 * w4378 - w3985 * w4377) + (w4003 * w4347 + w322 * w4379))
    w4479 = w4477 - w4478 + w798 * (w83 * w4382 + w86 * w4383 + w322 * w4384) - (w83 * w4268 + w86 * w4269 + w322 * w4270)
    w4480 = w4466 + (w76 * w1657 + w70 * w1661 + w72 * w1662 + w72 * w1677 + w207 * w1681 + w105 * w1683) * w4479
    w4481 = w112 * w1796 + w121 * w1799 + w125 * w1800 + w125 * w1802 + w112 * w1804 + w121 * w1805 - w612 * w1904
    w4482 = w777 * w4272 - w788 * w4276 - w754 * w4281 + w3 * w4285 - w1419 * w4290 + w1435 * w4294 - w1446 * w4299
    w4483 = w4482 + w1455 * w4303 + w1565 * w4308 + w1580 * w4312 + w1592 * w4317 + w1600 * w4321 + w1699 * w4326
    w4484 = w4483 + w1713 * w4330 + w1725 * w4335 - w1733 * w4339 + w1063 * w4344 + w1068 * w4350 - w1071 * w4355
    w4485 = (w4481 - w611 * w1907) * (w4268 + (w4484 - w1065 * w4359 + w1008 * w4365 + w1004 * w4369 + w1000 * w4374 - w798 * w4382))
    w4486 = w87 * w1796 + w125 * w1799 + w89 * w1800 + w121 * w1802 + w87 * w1804 + w120 * w1805 - w612 * w1905
    w4487 = w777 * w4389 - w788 * w4391 - w754 * w4394 + w3 * w4396 - w1419 * w4399 + w1435 * w4401 - w1446 * w4404
    w4488 = w4487 + w1455 * w4406 + w1565 * w4409 + w1580 * w4411 + w1592 * w4414 + w1600 * w4416 + w1699 * w4419
    w4489 = w4488 + w1713 * w4421 + w1725 * w4424 - w1733 * w4426 + w1063 * w4429 + w1068 * w4431 - w1071 * w4434
    w4490 = (w4486 + w611 * w1906) * (w4387 + (w4489 - w1065 * w4436 + w1008 * w4439 + w1004 * w4441 + w1000 * w4444 - w798 * w4449))
    w4491 = w120 * w1796 + w87 * w1799 + w112 * w1800 + w94 * w1802 + w125 * w1804 + w87 * w1805 - w611 * w1905
    w4492 = w788 * w4392 - w777 * w4390 + w754 * w4395 - w3 * w4397 + w1419 * w4400 - w1435 * w4402 + w1446 * w4405
    w4493 = w4492 - w1455 * w4407 - w1565 * w4410 - w1580 * w4412 - w1592 * w4415 - w1600 * w4417 - w1699 * w4420
    w4494 = w4493 - w1713 * w4422 - w1725 * w4425 + w1733 * w4427 - w1063 * w4430 - w1068 * w4432 + w1071 * w4435
    w4495 = (w4491 - w612 * w1906) * (w4494 + w1065 * w4437 - w1008 * w4440 - w1004 * w4442 - w1000 * w4447 + w798 * w4450 - w4388)
    w4496 = w121 * w1796 + w94 * w1799 + w87 * w1800 + w87 * w1802 + w89 * w1804 + w112 * w1805 + w611 * w1904
    w4497 = w788 * w4277 - w777 * w4273 + w754 * w4282 - w3 * w4286 + w1419 * w4291 - w1435 * w4295 + w1446 * w4300
    w4498 = w4497 - w1455 * w4304 - w1565 * w4309 - w1580 * w4313 - w1592 * w4318 - w1600 * w4322 - w1699 * w4327
    w4499 = w4498 - w1713 * w4331 - w1725 * w4336 + w1733 * w4340 - w1063 * w4345 - w1068 * w4351 + w1071 * w4356
    w4500 = (w4496 - w612 * w1907) * (w4499 + w1065 * w4360 - w1008 * w4366 - w1004 * w4370 - w1000 * w4378 + w798 * w4383 - w4269)
    w4501 = w777 * w2091 - w788 * w2023 - w754 * w2170 + w3 * w2239 - w1419 * w2337 + w1435 * w2438 - w1446 * w2515
    w4502 = w4501 + w1455 * w2601 + w1565 * w2748 + w1580 * w2884 + w1592 * w3009 + w1600 * w3124 + w1699 * w3250
    w4503 = w4502 + w1713 * w3355 + w1725 * w3470 - w1733 * w3575 + w1063 * w3638 + w1068 * w3703 - w1071 * w3749
    w4504 = (w67 * w1856 - w66 * w1850 + hinge1_angle_dot * (w65 * w1852 - w5 * w1858) * 0.5) * (w4074 + (w4503 - w1065 * w3798 + w1008 * w3877 + w1004 * w3982 + w1000 * w4040 - w798 * w4072))
    w4505 = w777 * w4170 - w788 * w4171 - w754 * w4173 + w3 * w4174 - w1419 * w4178 + w1435 * w4181 - w1446 * w4184
    w4506 = w4505 + w1455 * w4187 + w1565 * w4189 + w1580 * w4190 + w1592 * w4192 + w1600 * w4193 + w1699 * w4195
    w4507 = w4506 + w1713 * w4196 + w1725 * w4198 - w1733 * w4199 + w1063 * w4201 + w1068 * w4202 - w1071 * w4204
    w4508 = (w291 * w1869 + w293 * w1887 + hinge2_angle_dot * (w7 * w1891 + w146 * w1873) * 0.5) * (w4169 + (w4507 - w1065 * w4205 + w1008 * w4207 + w1004 * w4213 + w1000 * w4215 - w798 * w4216))
    w4509 = w777 * w4274 - w788 * w4278 - w754 * w4283 + w3 * w4287 - w1419 * w4292 + w1435 * w4296 - w1446 * w4301
    w4510 = w4509 + w1455 * w4305 + w1565 * w4310 + w1580 * w4314 + w1592 * w4319 + w1600 * w4323 + w1699 * w4328
    w4511 = w4510 + w1713 * w4332 + w1725 * w4337 - w1733 * w4341 + w1063 * w4346 + w1068 * w4352 - w1071 * w4357
    w4512 = (w320 * w1914 - w321 * w1908 + hinge4_angle_dot * (w83 * w1910 - w86 * w1916) * 0.5) * (w4270 + (w4511 - w1065 * w4362 + w1008 * w4367 + w1004 * w4371 + w1000 * w4379 - w798 * w4384))
    w4513 = w788 * w4275 - w777 * w4271 + w754 * w4280 - w3 * w4284 + w1419 * w4289 - w1435 * w4293 + w1446 * w4298
    w4514 = w4513 - w1455 * w4302 - w1565 * w4307 - w1580 * w4311 - w1592 * w4316 - w1600 * w4320 - w1699 * w4325
    w4515 = w4514 - w1713 * w4329 - w1725 * w4334 + w1733 * w4338 - w1063 * w4343 - w1068 * w4349 + w1071 * w4354
    w4516 = hinge5_angle_dot * (w117 * w1928 + w102 * w1922) * 0.5 * (w4515 + w1065 * w4358 - w1008 * w4364 - w1004 * w4368 - w1000 * w4373 + w798 * w4381 - w4267)
    dQ_hat_dq_i = ca.vertcat(
        w1930 + (w4480 + w4485 + w4490 + w4495 + w4500 + w4504 + w4508 + w4512 + w4516),
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 4077 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
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
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c50 = c[50]
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
    c103 = c[103]
    c104 = c[104]
    c108 = c[108]
    c109 = c[109]
    c129 = c[129]
    c130 = c[130]
    c135 = c[135]
    c136 = c[136]
    c137 = c[137]
    c138 = c[138]
    c139 = c[139]
    c140 = c[140]
    c141 = c[141]
    c142 = c[142]
    c143 = c[143]
    c144 = c[144]
    c145 = c[145]
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = w2 * c1 * c0 - w2 * c2 * c3
    w4 = bar1_e2 * -2.0
    w5 = ca.sin(w0)
    w6 = w5 / 2.0
    w7 = w6 * c1 * c3 - w6 * c2 * c0
    w8 = w7 * hinge0_angle_dot
    w9 = bar1_e3 * -2.0
    w10 = w6 * c51
    w11 = hinge0_angle_dot * w10
    w12 = w4 * w11
    w13 = w2 * c42
    w14 = hinge0_angle_dot * w13
    w15 = 2 * bar1_e0
    w16 = w14 * w15
    w17 = w3 * hinge0_angle_dot
    w18 = 2 * bar1_e1
    w19 = w8 * w9 - w12 - w16 + w17 * w18
    w20 = 2 * bar1_e2
    w21 = w9 * w10
    w22 = bar1_e1 * -2.0
    w23 = w3 * w15
    w24 = w7 * w20 - w21 - w13 * w22 + w23
    w25 = w24 * c5
    w26 = w9 * w11
    w27 = w15 * w17
    w28 = w8 * w20 - w26 - w14 * w22 + w27
    w29 = w28 * c5
    w30 = w4 * w10
    w31 = w13 * w15
    w32 = w7 * w9 - w30 - w31 + w3 * w18
    w33 = w32 * c4
    w34 = w19 * c4
    w35 = w19 * w25 + w29 * w32 - (w28 * w33 + w24 * w34)
    w36 = w7 * w15 - w10 * w22
    w37 = 2 * bar1_e3
    w38 = w36 - w13 * w37 + w3 * w4
    w39 = w38 * c7
    w40 = w8 * w15 - w11 * w22
    w41 = w40 - w14 * w37 + w4 * w17
    w42 = w41 * c7
    w43 = w28 * w39 + w24 * w42 - (w25 * w41 + w29 * w38)
    w44 = w33 * w41 + w34 * w38 - (w19 * w39 + w32 * w42)
    w45 = w4 * c6
    w46 = w18 * c8
    w47 = w15 * c9
    w48 = w9 * w46 + bar1_e2 * bar1_e0 * c103
    w49 = hinge0_angle_dot * 0.5
    w50 = w1 * w49
    w51 = w50 * c1 * c3 - w50 * c2 * c0
    w52 = bar1_e2 * bar1_e1 * c52 + w9 * w47
    w53 = w1 * hinge0_angle_dot * c108
    w54 = w37 * w45 + bar1_e0 * bar1_e1 * c104
    w55 = w5 * w49
    w56 = w5 * hinge0_angle_dot * c109
    w57 = w55 * c2 * c3 - w55 * c1 * c0
    w58 = w4 * w35 + w18 * w43 + w15 * w44 - (w48 * w51 - w52 * w53 + w54 * w56 + (w4 * w45 + w18 * w46 + w15 * w47) * w57)
    w59 = (bar1_e3 * w15 + bar1_e2 * w18) * c10
    w60 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c10
    w61 = w20 * w59 - w22 * w60
    w62 = 2 * bar2_e0
    w63 = w62 * bar2_e1
    w64 = 2 * bar2_e2
    w65 = w64 * bar2_e3
    w66 = w63 + w65
    w67 = hinge1_angle / 2.0
    w68 = ca.cos(w67)
    w69 = ca.sin(w67)
    w70 = w68 / 2.0
    w71 = w69 / 2.0
    w72 = bar1_e2 * w70 - bar1_e1 * w71
    w73 = 2 * bar4_e3
    w74 = 2 * bar4_e1
    w75 = bar4_e3 * w74
    w76 = 2 * bar4_e0
    w77 = w76 * bar4_e2
    w78 = w75 - w77
    w79 = w78 * c55
    w80 = bar4_e2 * -2.0
    w81 = bar4_e3 * w76
    w82 = w74 * bar4_e2
    w83 = w81 + w82
    w84 = w83 * c55
    w85 = w73 * w79 - w80 * w84
    w86 = hinge4_angle / 2.0
    w87 = ca.sin(w86)
    w88 = w76 * w79
    w89 = w88 - w74 * w84
    w90 = ca.cos(w86)
    w91 = 2 * bar5_e0
    w92 = w91 * bar5_e1
    w93 = 2 * bar5_e2
    w94 = w93 * bar5_e3
    w95 = w92 + w94
    w96 = w95 * c56
    w97 = w91 * w96
    w98 = 2 * bar5_e1
    w99 = 1.0 - 2 * bar5_e1**2
    w100 = 2 * bar5_e3**2
    w101 = w99 - w100
    w102 = w101 * c56
    w103 = w97 - w98 * w102
    w104 = w85 * w87 - w89 * w90 - w103
    w105 = hinge5_angle / 2.0
    w106 = ca.sin(w105)
    w107 = w106 / 2.0
    w108 = w107 * c57 * c58 - w107 * c59 * c60
    w109 = bar4_e1 * -2.0
    w110 = w79 * w109
    w111 = w76 * w84
    w112 = w110 - w111
    w113 = bar4_e3 * -2.0
    w114 = w84 * w113
    w115 = w79 * w80 - w114
    w116 = bar5_e1 * -2.0
    w117 = w96 * w116
    w118 = w91 * w102
    w119 = w117 - w118
    w120 = w90 * w112 + w87 * w115 + w119
    w121 = ca.cos(w105)
    w122 = w121 / 2.0
    w123 = w122 * c59 * c58 - w122 * c57 * c60
    w124 = 2 * bar5_e3
    w125 = bar5_e2 * -2.0
    w126 = w96 * w124 - w102 * w125
    w127 = w87 * w89 + w85 * w90 + w126
    w128 = w122 * c61
    w129 = bar5_e3 * -2.0
    w130 = w102 * w129
    w131 = w96 * w125 - w130
    w132 = w87 * w112 - w90 * w115 - w131
    w133 = w107 * c62
    w134 = w104 * w108 - w120 * w123 + w127 * w128 - w132 * w133
    w135 = 2 * bar3_e3
    w136 = 1.0 - 2 * bar3_e1**2
    w137 = 2 * bar3_e2**2
    w138 = w136 - w137
    w139 = w138 * c63
    w140 = bar3_e2 * -2.0
    w141 = 2 * bar3_e2
    w142 = bar3_e3 * w141
    w143 = 2 * bar3_e0
    w144 = bar3_e1 * w143
    w145 = w142 - w144
    w146 = w145 * c63
    w147 = w135 * w139 - w140 * w146
    w148 = hinge2_angle / 2.0
    w149 = ca.cos(w148)
    w150 = w149 * c16 * c19 - w149 * c18 * c17
    w151 = bar2_e1 * -2.0
    w152 = w66 * c15
    w153 = w151 * w152
    w154 = 1.0 - 2 * bar2_e1**2
    w155 = 2 * bar2_e3**2
    w156 = w154 - w155
    w157 = w156 * c15
    w158 = w62 * w157
    w159 = w153 - w158
    w160 = bar3_e1 * -2.0
    w161 = w139 * w160
    w162 = w143 * w146
    w163 = w161 - w162
    w164 = w149 * c20
    w165 = w139 * w143
    w166 = 2 * bar3_e1
    w167 = w165 - w146 * w166
    w168 = ca.sin(w148)
    w169 = w168 * c22
    w170 = bar3_e3 * -2.0
    w171 = w146 * w170
    w172 = w139 * w140 - w171
    w173 = w168 * c18 * c19 - w168 * c16 * c17
    w174 = w147 * w150 - (w159 + w163 * w164 + w167 * w169) + w172 * w173
    w175 = bar1_e0 * w70 - bar1_e3 * w71
    w176 = w62 * w152
    w177 = 2 * bar2_e1
    w178 = w176 - w157 * w177
    w179 = w163 * w169 - w178 - w164 * w167 - w147 * w173 + w150 * w172
    w180 = bar1_e2 * w71 + bar1_e1 * w70
    w181 = 2 * bar2_e3
    w182 = bar2_e2 * -2.0
    w183 = w152 * w181 - w157 * w182
    w184 = w167 * w173 - (w183 + w150 * w163) - w147 * w164 + w169 * w172
    w185 = bar2_e3 * -2.0
    w186 = w157 * w185
    w187 = w152 * w182 - w186
    w188 = w187 + w163 * w173 + w150 * w167 + w147 * w169 + w164 * w172
    w189 = bar1_e0 * w71 + bar1_e3 * w70
    w190 = w174 * w175 - w179 * w180 + w72 * w184 + w188 * w189
    w191 = bar3_e2 * w143
    w192 = bar3_e3 * w166
    w193 = w191 + w192
    w194 = w193 * c63
    w195 = w140 * w194
    w196 = w195 - w165
    w197 = bar2_e2 * w177
    w198 = w62 * bar2_e3
    w199 = w197 - w198
    w200 = w199 * c15
    w201 = w62 * w200
    w202 = w201 - w64 * w152
    w203 = w143 * w194
    w204 = w203 - w139 * w141
    w205 = w166 * w194 - w139 * w170
    w206 = w170 * w194 - w161
    w207 = w150 * w196 - (w202 + w164 * w204 + w169 * w205) + w173 * w206
    w208 = w177 * w200 - w152 * w185
    w209 = w169 * w204 - w208 - w164 * w205 - w173 * w196 + w150 * w206
    w210 = w182 * w200
    w211 = w210 - w176
    w212 = w173 * w205 - (w211 + w150 * w204) - w164 * w196 + w169 * w206
    w213 = w185 * w200 - w153
    w214 = w213 + w173 * w204 + w150 * w205 + w169 * w196 + w164 * w206
    w215 = w175 * w207 - w180 * w209 + w72 * w212 + w189 * w214
    w216 = w162 - w135 * w194
    w217 = w64 * w157 - w151 * w200
    w218 = w141 * w146 - w160 * w194
    w219 = w171 - w203
    w220 = w146 * w160 - w195
    w221 = w150 * w216 - (w217 + w164 * w218 + w169 * w219) + w173 * w220
    w222 = w186 - w201
    w223 = w169 * w218 - w222 - w164 * w219 - w173 * w216 + w150 * w220
    w224 = w158 - w181 * w200
    w225 = w173 * w219 - (w224 + w150 * w218) - w164 * w216 + w169 * w220
    w226 = w151 * w157 - w210
    w227 = w226 + w173 * w218 + w150 * w219 + w169 * w216 + w164 * w220
    w228 = w175 * w221 - w180 * w223 + w72 * w225 + w189 * w227
    w229 = bar3_e3 * w143
    w230 = bar3_e2 * w166
    w231 = w229 + w230
    w232 = bar4_e1 * w76
    w233 = 2 * bar4_e2
    w234 = bar4_e3 * w233
    w235 = w232 + w234
    w236 = w231 * w235
    w237 = w192 - w191
    w238 = 1.0 - 2 * bar4_e1**2
    w239 = 2 * bar4_e3**2
    w240 = w238 - w239
    w241 = w237 * w240
    w242 = w236 - w241
    w243 = w82 - w81
    w244 = w237 * w243
    w245 = 2 * bar3_e3**2
    w246 = 1.0 - w137 - w245
    w247 = w235 * w246
    w248 = w244 - w247
    w249 = w240 * w246
    w250 = w231 * w243
    w251 = w249 - w250
    w252 = w141 * w242 + w160 * w248 + w143 * w251
    w253 = w170 * w242 + w143 * w248 + w166 * w251
    w254 = w143 * w242 + w135 * w248 + w140 * w251
    w255 = w160 * w242 + w140 * w248 + w170 * w251
    w256 = w164 * w252 + w169 * w253 - w150 * w254 - w173 * w255
    w257 = w164 * w253 - w169 * w252 + w173 * w254 - w150 * w255
    w258 = w150 * w252 - w173 * w253 + w164 * w254 - w169 * w255
    w259 = w173 * w252 + w150 * w253 + w169 * w254 + w164 * w255
    w260 = w175 * w256 - w180 * w257 + w72 * w258 - w189 * w259
    w261 = ca.sqrt(w190**2 + w215**2 + w228**2 + w260**2)
    w262 = w190 / w261
    w263 = 2 * bar4_e2**2
    w264 = 1.0 - w263 - w239
    w265 = w264 * c55
    w266 = w80 * w265
    w267 = w266 - w88
    w268 = w74 * w265 - w79 * w113
    w269 = bar5_e2 * w98
    w270 = w91 * bar5_e3
    w271 = w269 - w270
    w272 = w271 * c56
    w273 = w98 * w272 - w96 * w129
    w274 = w87 * w267 - w90 * w268 - w273
    w275 = w76 * w265
    w276 = w275 - w79 * w233
    w277 = w113 * w265 - w110
    w278 = w91 * w272
    w279 = w278 - w93 * w96
    w280 = w90 * w276 + w87 * w277 + w279
    w281 = w125 * w272
    w282 = w281 - w97
    w283 = w87 * w268 + w90 * w267 + w282
    w284 = w129 * w272 - w117
    w285 = w87 * w276 - w90 * w277 - w284
    w286 = w108 * w274 - w123 * w280 + w128 * w283 - w133 * w285
    w287 = w215 / w261
    w288 = w111 - w73 * w265
    w289 = w114 - w275
    w290 = w130 - w278
    w291 = w87 * w288 - w90 * w289 - w290
    w292 = w84 * w233 - w109 * w265
    w293 = w84 * w109 - w266
    w294 = w93 * w102 - w116 * w272
    w295 = w90 * w292 + w87 * w293 + w294
    w296 = w118 - w124 * w272
    w297 = w87 * w289 + w90 * w288 + w296
    w298 = w102 * w116 - w281
    w299 = w87 * w292 - w90 * w293 - w298
    w300 = w108 * w291 - w123 * w295 + w128 * w297 - w133 * w299
    w301 = w228 / w261
    w302 = w241 - w236
    w303 = w247 - w244
    w304 = w250 - w249
    w305 = w233 * w302 + w109 * w303 + w76 * w304
    w306 = w109 * w302 + w80 * w303 + w113 * w304
    w307 = w90 * w305 + w87 * w306
    w308 = w113 * w302 + w76 * w303 + w74 * w304
    w309 = w76 * w302 + w73 * w303 + w80 * w304
    w310 = w90 * w308 - w87 * w309
    w311 = w87 * w308 + w90 * w309
    w312 = w90 * w306 - w87 * w305
    w313 = w123 * w307 + w108 * w310 - w128 * w311 - w133 * w312
    w314 = w260 / w261
    w315 = w134 * w262 + w286 * w287 + w300 * w301 + w313 * w314
    w316 = w134 - w262 * w315
    w317 = w168 / 2.0
    w318 = w317 * c20
    w319 = w149 / 2.0
    w320 = w319 * c22
    w321 = w317 * c18 * c17 - w317 * c16 * c19
    w322 = w319 * c18 * c19 - w319 * c16 * c17
    w323 = bar2_e0 * w318 + (bar2_e1 * w320 + bar2_e2 * w321 + bar2_e3 * w322)
    w324 = bar2_e0 * w322 - bar2_e3 * w318 + (bar2_e1 * w321 - bar2_e2 * w320)
    w325 = bar2_e0 * w321 - bar2_e2 * w318 + (bar2_e3 * w320 - bar2_e1 * w322)
    w326 = bar2_e0 * w320 - bar2_e1 * w318 + (bar2_e2 * w322 - bar2_e3 * w321)
    w327 = w172 * w323 - (w163 * w324 + w167 * w325 + w147 * w326)
    w328 = w206 * w323 - (w204 * w324 + w205 * w325 + w196 * w326)
    w329 = w220 * w323 - (w218 * w324 + w219 * w325 + w216 * w326)
    w330 = w252 * w324 + w253 * w325 + w254 * w326 - w255 * w323
    w331 = w262 * w327 + w287 * w328 + w301 * w329 + w314 * w330
    w332 = w327 - w262 * w331
    w333 = w328 - w287 * w331
    w334 = w329 - w301 * w331
    w335 = w330 - w314 * w331
    w336 = ca.sqrt(w332**2 + w333**2 + w334**2 + w335**2)
    w337 = w332 / w336
    w338 = w286 - w287 * w315
    w339 = w333 / w336
    w340 = w300 - w301 * w315
    w341 = w334 / w336
    w342 = w313 - w314 * w315
    w343 = w335 / w336
    w344 = w316 * w337 + w338 * w339 + w340 * w341 + w342 * w343
    w345 = w316 - w337 * w344
    w346 = w90 / 2.0
    w347 = w87 / 2.0
    w348 = bar5_e0 * w346 + bar5_e3 * w347
    w349 = bar5_e1 * w346 - bar5_e2 * w347
    w350 = bar5_e1 * w347 + bar5_e2 * w346
    w351 = bar5_e3 * w346 - bar5_e0 * w347
    w352 = w112 * w348 - w89 * w349 + w85 * w350 - w115 * w351
    w353 = w276 * w348 - w268 * w349 + w267 * w350 - w277 * w351
    w354 = w292 * w348 - w289 * w349 + w288 * w350 - w293 * w351
    w355 = w308 * w349 - w305 * w348 - w309 * w350 + w306 * w351
    w356 = w262 * w352 + w287 * w353 + w301 * w354 + w314 * w355
    w357 = w352 - w262 * w356
    w358 = w353 - w287 * w356
    w359 = w354 - w301 * w356
    w360 = w355 - w314 * w356
    w361 = w337 * w357 + w339 * w358 + w341 * w359 + w343 * w360
    w362 = w357 - w337 * w361
    w363 = w358 - w339 * w361
    w364 = w359 - w341 * w361
    w365 = w360 - w343 * w361
    w366 = ca.sqrt(w362**2 + w363**2 + w364**2 + w365**2)
    w367 = w362 / w366
    w368 = w338 - w339 * w344
    w369 = w363 / w366
    w370 = w340 - w341 * w344
    w371 = w364 / w366
    w372 = w342 - w343 * w344
    w373 = w365 / w366
    w374 = w345 * w367 + w368 * w369 + w370 * w371 + w372 * w373
    w375 = w345 - w367 * w374
    w376 = w368 - w369 * w374
    w377 = w370 - w371 * w374
    w378 = w372 - w373 * w374
    w379 = ca.sqrt(w375**2 + w376**2 + w377**2 + w378**2)
    w380 = w375 / w379
    w381 = (bar1_e3 * w18 - bar1_e2 * w15) * c10
    w382 = w22 * w381
    w383 = w15 * w59
    w384 = w382 - w383
    w385 = w68 * w174 - w384 + w69 * w188
    w386 = w15 * w381
    w387 = w386 - w18 * w59
    w388 = w68 * w179 - w387 + w69 * w184
    w389 = w37 * w381 - w4 * w59
    w390 = w68 * w184 - (w389 + w69 * w179)
    w391 = w9 * w59
    w392 = w4 * w381 - w391
    w393 = w69 * w174 - w392 - w68 * w188
    w394 = w3 * w385 - w13 * w388 + w7 * w390 - w10 * w393
    w395 = w376 / w379
    w396 = w15 * w60
    w397 = w396 - w20 * w381
    w398 = w68 * w207 - w397 + w69 * w214
    w399 = w18 * w60 - w9 * w381
    w400 = w68 * w209 - w399 + w69 * w212
    w401 = w4 * w60
    w402 = w401 - w386
    w403 = w68 * w212 - (w402 + w69 * w209)
    w404 = w9 * w60 - w382
    w405 = w69 * w207 - w404 - w68 * w214
    w406 = w3 * w398 - w13 * w400 + w7 * w403 - w10 * w405
    w407 = w377 / w379
    w408 = w68 * w221 - w61 + w69 * w227
    w409 = w391 - w396
    w410 = w68 * w223 - w409 + w69 * w225
    w411 = w383 - w37 * w60
    w412 = w68 * w225 - (w411 + w69 * w223)
    w413 = w22 * w59 - w401
    w414 = w69 * w221 - w413 - w68 * w227
    w415 = w3 * w408 - w13 * w410 + w7 * w412 - w10 * w414
    w416 = w378 / w379
    w417 = w68 * w256 - w69 * w259
    w418 = w68 * w257 + w69 * w258
    w419 = w68 * w258 - w69 * w257
    w420 = w69 * w256 + w68 * w259
    w421 = w3 * w417 - w13 * w418 + w7 * w419 - w10 * w420
    w422 = (w380 * w394 + w395 * w406 + w407 * w415 + w416 * w421) / w379
    w423 = (w374 * w422 - (w367 * w394 + w369 * w406 + w371 * w415 + w373 * w421)) / w366
    w424 = (w344 * w422 - (w337 * w394 + w339 * w406 + w341 * w415 + w343 * w421) - w361 * w423) / w336
    w425 = w315 * w422 - (w262 * w394 + w287 * w406 + w301 * w415 + w314 * w421) - w356 * w423 - w331 * w424
    w426 = w425 / w261
    w427 = hinge0_angle_dot * w426
    w428 = w8 * w68 - w14 * w69 + w72 * w427
    w429 = w11 * w68 + w17 * w69 + w189 * w427
    w430 = w62 * w428 - w151 * w429
    w431 = w8 * w69 + w14 * w68 + w180 * w427
    w432 = w17 * w68 - w11 * w69 + w175 * w427
    w433 = w430 - w181 * w431 + w182 * w432
    w434 = w7 * w68 - w13 * w69 + w72 * w426
    w435 = w10 * w68 + w3 * w69 + w189 * w426
    w436 = w62 * w434 - w151 * w435
    w437 = w7 * w69 + w13 * w68 + w180 * w426
    w438 = w3 * w68 - w10 * w69 + w175 * w426
    w439 = w436 - w181 * w437 + w182 * w438
    w440 = w185 * w429
    w441 = w62 * w432
    w442 = w64 * w428 - w440 - w151 * w431 + w441
    w443 = w185 * w435
    w444 = w62 * w438
    w445 = w64 * w434 - w443 - w151 * w437 + w444
    w446 = w433 * w439 * c135 + w442 * w445 * c135
    w447 = bar2_e3 * w177
    w448 = w62 * bar2_e2
    w449 = w182 * w429
    w450 = w62 * w431
    w451 = w185 * w428 - w449 - w450 + w177 * w432
    w452 = w182 * w435
    w453 = w62 * w437
    w454 = w185 * w434 - w452 - w453 + w177 * w438
    w455 = w439 * c14 * w451 + w433 * c14 * w454
    w456 = 2 * bar2_e2**2
    w457 = w445 * c14 * w451 + w442 * c14 * w454
    w458 = w27 + (w4 * w8 - w26 - w14 * w18)
    w459 = w40 - w9 * w14 + w17 * w20
    w460 = w60 * w458 - w381 * w459
    w461 = w36 - w9 * w13 + w3 * w20
    w462 = w23 + (w4 * w7 - w21 - w13 * w18)
    w463 = w60 * w462 - w381 * w461
    w464 = w8 * w37 - w12 - w16 + w17 * w22
    w465 = w381 * w464 - w59 * w458
    w466 = w7 * w37 - w30 - w31 + w3 * w22
    w467 = w381 * w466 - w59 * w462
    w468 = w460 * w461 + w459 * w463 - (w465 * w466 + w464 * w467)
    w469 = w468 - w53 * w413 + w51 * w411 + w56 * w409 + w57 * w61
    w470 = w156 * c14
    w471 = w199 * c14
    w472 = w182 * w471
    w473 = w151 * w470 - w472
    w474 = w427 * (w426 * 0.5)
    w475 = w69 * w474
    w476 = w68 * w474
    w477 = w6 * hinge0_angle_dot
    w478 = w426 * (w17 * w70) * c136 - w426 * (w71 * w477) * c137
    w479 = bar1_e3 * w475 - bar1_e0 * w476 - w478 - w478
    w480 = hinge0_angle_dot * w424
    w481 = w150 * w431 - (w164 * w429 + w169 * w428) - w173 * w432 - w323 * w480
    w482 = w164 * w428 - w169 * w429 - w173 * w431 - w150 * w432 + w326 * w480
    w483 = w160 * w481 + w143 * w482
    w484 = w169 * w432 - (w150 * w429 + w173 * w428 + w164 * w431) + w325 * w480
    w485 = w150 * w428 - w173 * w429 + w169 * w431 + w164 * w432 + w324 * w480
    w486 = w483 + w170 * w484 + w141 * w485
    w487 = w140 * w481
    w488 = w143 * w484
    w489 = w487 + w135 * w482 + w488 + w160 * w485
    w490 = w146 * w486 - w194 * w489
    w491 = w150 * w437 - (w164 * w435 + w169 * w434) - w173 * w438 - w323 * w424
    w492 = w140 * w491
    w493 = w164 * w434 - w169 * w435 - w173 * w437 - w150 * w438 + w326 * w424
    w494 = w169 * w438 - (w150 * w435 + w173 * w434 + w164 * w437) + w325 * w424
    w495 = w143 * w494
    w496 = w150 * w434 - w173 * w435 + w169 * w437 + w164 * w438 + w324 * w424
    w497 = w492 + w135 * w493 + w495 + w160 * w496
    w498 = w160 * w491 + w143 * w493
    w499 = w498 + w170 * w494 + w141 * w496
    w500 = w146 * w499 - w194 * w497
    w501 = w170 * w481
    w502 = w143 * w485
    w503 = w501 + w140 * w482 + w166 * w484 + w502
    w504 = w194 * w503 - w139 * w486
    w505 = w170 * w491
    w506 = w143 * w496
    w507 = w505 + w140 * w493 + w166 * w494 + w506
    w508 = w194 * w507 - w139 * w499
    w509 = w430 - w185 * w431 + w64 * w432
    w510 = w181 * w428 - w449 - w450 + w151 * w432
    w511 = w157 * w509 - w200 * w510
    w512 = w181 * w434 - w452 - w453 + w151 * w438
    w513 = w436 - w185 * w437 + w64 * w438
    w514 = w157 * w513 - w200 * w512
    w515 = w441 + (w182 * w428 - w440 - w177 * w431)
    w516 = w200 * w515 - w152 * w509
    w517 = w444 + (w182 * w434 - w443 - w177 * w437)
    w518 = w200 * w517 - w152 * w513
    w519 = w511 * w512 + w510 * w514 - (w516 * w517 + w515 * w518)
    w520 = w480 * (w424 * 0.5)
    w521 = w168 * w520
    w522 = w521 * c16 * c17 - w521 * c18 * c19
    w523 = w149 * w520
    w524 = w424 * (w424 * (hinge0_angle_dot * w149)) * c130
    w525 = w523 * c18 * c17 - w523 * c16 * c19
    w526 = w424 * (w424 * (hinge0_angle_dot * w168)) * c129
    w527 = w317 * w480
    w528 = w527 * c18 * c17 - w527 * c16 * c19
    w529 = w317 * w424
    w530 = w529 * c18 * c17 - w529 * c16 * c19
    w531 = w319 * w480
    w532 = w424 * (hinge0_angle_dot * w319) * c22
    w533 = w319 * w424
    w534 = w533 * c22
    w535 = w531 * c18 * c19 - w531 * c16 * c17
    w536 = w533 * c18 * c19 - w533 * c16 * c17
    w537 = w529 * c20
    w538 = w424 * (hinge0_angle_dot * w317) * c20
    w539 = w434 * w528 + w428 * w530 + (w437 * w532 + w431 * w534) - (w435 * w535 + w429 * w536 + (w432 * w537 + w438 * w538))
    w540 = w539 + (bar2_e0 * w522 - bar2_e3 * w524 + (bar2_e1 * w525 + bar2_e2 * w526) + w539)
    w541 = w431 * w537 + w437 * w538 - (w435 * w528 + w429 * w530) + (w438 * w532 + w432 * w534 - (w434 * w535 + w428 * w536))
    w542 = w541 + (bar2_e0 * w525 - bar2_e2 * w524 - (bar2_e3 * w526 + bar2_e1 * w522) + w541)
    w543 = w435 * w532 + w429 * w534 + (w428 * w537 + w434 * w538) + (w437 * w535 + w431 * w536 + (w438 * w528 + w432 * w530))
    w544 = bar2_e2 * w522 - bar2_e3 * w525 - (bar2_e0 * w526 + bar2_e1 * w524) - w543 - w543
    w545 = w490 * w497 + w489 * w500 - (w504 * w507 + w503 * w508) + w519 + w163 * w540 + w167 * w542 + w147 * w544
    w546 = w434 * w532 + w428 * w534 - (w437 * w528 + w431 * w530) + (w438 * w535 + w432 * w536) - (w435 * w538 + w429 * w537)
    w547 = w546 + (bar2_e0 * w524 + (bar2_e2 * w525 - bar2_e1 * w526 + bar2_e3 * w522) + w546)
    w548 = hinge0_angle_dot * w422
    w549 = w133 * w548
    w550 = w123 * w548
    w551 = hinge0_angle_dot * w423
    w552 = w90 * w549 - w87 * w550 + w351 * w551
    w553 = w128 * w548
    w554 = w108 * w548
    w555 = w90 * w553 + w87 * w554 - w350 * w551
    w556 = w109 * w552 + w76 * w555
    w557 = w87 * w553 - w90 * w554 + w349 * w551
    w558 = w87 * w549 + w90 * w550 + w348 * w551
    w559 = w556 + w113 * w557 - w233 * w558
    w560 = w80 * w552
    w561 = w76 * w557
    w562 = w560 + w73 * w555 + w561 - w109 * w558
    w563 = w84 * w559 - w265 * w562
    w564 = w133 * w422
    w565 = w123 * w422
    w566 = w90 * w564 - w87 * w565 + w351 * w423
    w567 = w80 * w566
    w568 = w128 * w422
    w569 = w108 * w422
    w570 = w90 * w568 + w87 * w569 - w350 * w423
    w571 = w87 * w568 - w90 * w569 + w349 * w423
    w572 = w76 * w571
    w573 = w87 * w564 + w90 * w565 + w348 * w423
    w574 = w567 + w73 * w570 + w572 - w109 * w573
    w575 = w109 * w566 + w76 * w570
    w576 = w575 + w113 * w571 - w233 * w573
    w577 = w84 * w576 - w265 * w574
    w578 = w113 * w552
    w579 = w76 * w558
    w580 = w578 + w80 * w555 + w74 * w557 - w579
    w581 = w265 * w580 - w79 * w559
    w582 = w113 * w566
    w583 = w76 * w573
    w584 = w582 + w80 * w570 + w74 * w571 - w583
    w585 = w265 * w584 - w79 * w576
    w586 = w563 * w574 + w562 * w577 - (w581 * w584 + w580 * w585)
    w587 = w551 * (w423 * 0.5)
    w588 = w87 * w587
    w589 = w90 * w587
    w590 = hinge0_angle_dot * w107
    w591 = hinge0_angle_dot * w123
    w592 = w423 * (w422 * (w346 * w590)) * c138 - w423 * (w422 * (w347 * w591)) * c136
    w593 = bar5_e0 * w588 - bar5_e3 * w589 - w592 - w592
    w594 = hinge0_angle_dot * w122
    w595 = hinge0_angle_dot * w108
    w596 = w423 * (w422 * (w346 * w594)) * c139 + w423 * (w422 * (w347 * w595)) * c136
    w597 = w596 + (w596 - (bar5_e2 * w589 + bar5_e1 * w588))
    w598 = w423 * (w422 * (w347 * w594)) * c139 - w423 * (w422 * (w346 * w595)) * c136
    w599 = bar5_e2 * w588 - bar5_e1 * w589 - w598 - w598
    w600 = w423 * (w422 * (w346 * w591)) * c136 + w423 * (w422 * (w347 * w590)) * c138
    w601 = w600 + (w600 + (bar5_e0 * w589 + bar5_e3 * w588))
    w602 = w59 * w459 - w60 * w464
    w603 = w59 * w461 - w60 * w466
    w604 = w466 * w602 + w464 * w603 - (w460 * w462 + w458 * w463)
    w605 = w426 * (w70 * w477) * c137 + w426 * (w17 * w71) * c136
    w606 = w605 + (w605 + (bar1_e0 * w475 + bar1_e3 * w476))
    w607 = w545 - w172 * w547 + w586 + w112 * w593 + w89 * w597 + w85 * w599 - w115 * w601 + w604 + w174 * w606
    w608 = w2 * hinge0_angle_dot
    w609 = w426 * (w8 * w70) * c136 - w426 * (w71 * w608) * c140
    w610 = bar1_e1 * w475 - bar1_e2 * w476 - w609 - w609
    w611 = w426 * (w70 * w608) * c140 + w426 * (w8 * w71) * c136
    w612 = w611 + (w611 + (bar1_e1 * w476 + bar1_e2 * w475))
    w613 = w116 * w549 + w91 * w553
    w614 = w613 - w129 * w554 - w93 * w550
    w615 = w125 * w549
    w616 = w91 * w554
    w617 = w615 + w124 * w553 - w616 - w116 * w550
    w618 = w102 * w614 - w272 * w617
    w619 = w125 * w564
    w620 = w91 * w569
    w621 = w619 + w124 * w568 - w620 - w116 * w565
    w622 = w116 * w564 + w91 * w568
    w623 = w622 - w129 * w569 - w93 * w565
    w624 = w102 * w623 - w272 * w621
    w625 = w129 * w549
    w626 = w91 * w550
    w627 = w625 + w125 * w553 - w98 * w554 - w626
    w628 = w272 * w627 - w96 * w614
    w629 = w129 * w564
    w630 = w91 * w565
    w631 = w629 + w125 * w568 - w98 * w569 - w630
    w632 = w272 * w631 - w96 * w623
    w633 = w618 * w621 + w617 * w624 - (w628 * w631 + w627 * w632)
    w634 = w548 * (w422 * 0.5)
    w635 = w106 * w634
    w636 = w635 * c57 * c60 - w635 * c59 * c58
    w637 = w121 * w634
    w638 = w637 * c57 * c58 - w637 * c59 * c60
    w639 = w422 * (w422 * (hinge0_angle_dot * w106)) * c141
    w640 = w422 * (w422 * (hinge0_angle_dot * w121)) * c142
    w641 = w607 - w179 * w610 + w184 * w612 + w188 * w479 + w633 + w120 * w636 - w104 * w638 + w127 * w639 + w132 * w640
    w642 = w641 - w57 * w385 - w56 * w388 - w51 * w390 + w53 * w393
    w643 = w139 * w489 - w146 * w503
    w644 = w139 * w497 - w146 * w507
    w645 = w152 * w510 - w157 * w515
    w646 = w152 * w512 - w157 * w517
    w647 = w517 * w645 + w515 * w646 - (w511 * w513 + w509 * w514)
    w648 = w507 * w643 + w503 * w644 - (w490 * w499 + w486 * w500) + w647 + w204 * w540 + w205 * w542 + w196 * w544
    w649 = w79 * w562 - w84 * w580
    w650 = w79 * w574 - w84 * w584
    w651 = w584 * w649 + w580 * w650 - (w563 * w576 + w559 * w577)
    w652 = w462 * w465 + w458 * w467 - (w461 * w602 + w459 * w603)
    w653 = w648 - w206 * w547 + w651 + w276 * w593 + w268 * w597 + w267 * w599 - w277 * w601 + w652 + w207 * w606
    w654 = w96 * w617 - w102 * w627
    w655 = w96 * w621 - w102 * w631
    w656 = w631 * w654 + w627 * w655 - (w618 * w623 + w614 * w624)
    w657 = w653 - w209 * w610 + w212 * w612 + w214 * w479 + w656 + w280 * w636 - w274 * w638 + w283 * w639 + w285 * w640
    w658 = w657 - w57 * w398 - w56 * w400 - w51 * w403 + w53 * w405
    w659 = w513 * w516 + w509 * w518 - (w512 * w645 + w510 * w646)
    w660 = w499 * w504 + w486 * w508 - (w497 * w643 + w489 * w644) + w659 + w218 * w540 + w219 * w542 + w216 * w544
    w661 = w576 * w581 + w559 * w585 - (w574 * w649 + w562 * w650)
    w662 = w468 + (w660 - w220 * w547 + w661 + w292 * w593 + w289 * w597 + w288 * w599 - w293 * w601) + w221 * w606
    w663 = w623 * w628 + w614 * w632 - (w621 * w654 + w617 * w655)
    w664 = w662 - w223 * w610 + w225 * w612 + w227 * w479 + w663 + w295 * w636 - w291 * w638 + w297 * w639 + w299 * w640
    w665 = w664 - w57 * w408 - w56 * w410 - w51 * w412 + w53 * w414
    w666 = w240 * w559 - w243 * w562
    w667 = w240 * w576 - w243 * w574
    w668 = w243 * w580 - w235 * w559
    w669 = w243 * w584 - w235 * w576
    w670 = w235 * w562 - w240 * w580
    w671 = w235 * w574 - w240 * w584
    w672 = w246 * (w574 * w666 + w562 * w667 - (w584 * w668 + w580 * w669)) + w231 * (w584 * w670 + w580 * w671 - (w576 * w666 + w559 * w667))
    w673 = w231 * w486 - w246 * w489
    w674 = w231 * w499 - w246 * w497
    w675 = w246 * w503 - w237 * w486
    w676 = w246 * w507 - w237 * w499
    w677 = w672 + w237 * (w576 * w668 + w559 * w669 - (w574 * w670 + w562 * w671)) + w243 * (w497 * w673 + w489 * w674 - (w507 * w675 + w503 * w676))
    w678 = w237 * w489 - w231 * w503
    w679 = w237 * w497 - w231 * w507
    w680 = w677 + w240 * (w507 * w678 + w503 * w679 - (w499 * w673 + w486 * w674)) + w235 * (w499 * w675 + w486 * w676 - (w497 * w678 + w489 * w679))
    w681 = w680 + (w670 * (2 * w679) + w671 * (2 * w678)) + (w668 * (2 * w676) + w669 * (2 * w675)) + (w666 * (2 * w674) + w667 * (2 * w673))
    w682 = w255 * w547 - (w681 + w252 * w540 + w253 * w542 + w254 * w544) - w305 * w593 - w308 * w597 - w309 * w599
    w683 = w682 + w306 * w601 + w256 * w606 - w257 * w610 + w258 * w612 - w259 * w479 - w307 * w636 - w310 * w638
    w684 = w683 - w311 * w639 + w312 * w640 - w57 * w417 - w56 * w418 - w51 * w419 + w53 * w420
    w685 = (w380 * w642 + w395 * w658 + w407 * w665 + w416 * w684) / w379
    w686 = (w367 * w642 + w369 * w658 + w371 * w665 + w373 * w684 - w374 * w685) / w366
    w687 = (w337 * w642 + w339 * w658 + w341 * w665 + w343 * w684 - w344 * w685 - w361 * w686) / w336
    w688 = (w262 * w642 + w287 * w658 + w301 * w665 + w314 * w684 - w315 * w685 - w356 * w686 - w331 * w687) / w261
    w689 = w479 - w53 * w68 - w57 * w69 - w189 * w688
    w690 = w62 * w470
    w691 = w690 - w181 * w471
    w692 = w51 * w68 - w612 + w56 * w69 + w72 * w688
    w693 = w185 * w470
    w694 = w62 * w471
    w695 = w693 - w694
    w696 = w610 - w51 * w69 + w56 * w68 - w180 * w688
    w697 = w64 * w470 - w151 * w471
    w698 = w57 * w68 - (w606 + w53 * w69) + w175 * w688
    w699 = w66 * w446 - (w447 - w448) * w455 - (w154 - w456) * w457 - (w469 * c11 + w473 * w689 + w691 * w692 + w695 * w696 + w697 * w698)
    w700 = w488 + (w487 + w170 * w482) + w166 * w485
    w701 = w495 + (w492 + w170 * w493) + w166 * w496
    w702 = w483 + w135 * w484 + w140 * w485
    w703 = w498 + w135 * w494 + w140 * w496
    w704 = w700 * w701 * c143 + w702 * w703 * c143
    w705 = w502 + (w501 + w141 * w482 + w160 * w484)
    w706 = w506 + (w505 + w141 * w493 + w160 * w494)
    w707 = w703 * c21 * w705 + w702 * c21 * w706
    w708 = w701 * c21 * w705 + w700 * c21 * w706
    w709 = w469 + w659 + w226 * w689 + w224 * w692 + w222 * w696 + w217 * w698
    w710 = w145 * c21
    w711 = w193 * c21
    w712 = w140 * w711
    w713 = w160 * w710 - w712
    w714 = w164 * w689 - w547 - w169 * w692 - w150 * w696 - w173 * w698 - w323 * w687
    w715 = w143 * w710
    w716 = w715 - w135 * w711
    w717 = w544 + w169 * w689 + w164 * w692 + w173 * w696 - w150 * w698 + w326 * w687
    w718 = w170 * w710
    w719 = w143 * w711
    w720 = w718 - w719
    w721 = w542 + w150 * w689 - w173 * w692 + w164 * w696 + w169 * w698 + w325 * w687
    w722 = w141 * w710 - w160 * w711
    w723 = w540 + w173 * w689 + w150 * w692 - w169 * w696 + w164 * w698 + w324 * w687
    w724 = w138 * w704 - (w237 * w707 + (w142 + w144) * w708) - (w709 * c12 + w713 * w714 + w716 * w717 + w720 * w721 + w722 * w723)
    w725 = w699 + w724
    w726 = w652 - w53 * w404 + w51 * w402 + w56 * w399 + w57 * w397
    w727 = w66 * c14
    w728 = w151 * w727
    w729 = w185 * w471 - w728
    w730 = w62 * w727
    w731 = w472 - w730
    w732 = w177 * w471 - w185 * w727
    w733 = w694 - w64 * w727
    w734 = w156 * w446 - w455 * (w197 + w198) - w457 * (w65 - w63) - (w726 * c11 + w689 * w729 + w692 * w731 + w696 * w732 + w698 * w733)
    w735 = w647 + w726 + w213 * w689 + w211 * w692 + w208 * w696 + w202 * w698
    w736 = w138 * c21
    w737 = w160 * w736
    w738 = w170 * w711 - w737
    w739 = w143 * w736
    w740 = w712 - w739
    w741 = w166 * w711 - w170 * w736
    w742 = w719 - w141 * w736
    w743 = w145 * w704 - (w231 * w707 + w708 * (w136 - w245)) - (w735 * c12 + w714 * w738 + w717 * w740 + w721 * w741 + w723 * w742)
    w744 = w734 + w743
    w745 = w604 - w53 * w392 + w51 * w389 + w56 * w387 + w57 * w384
    w746 = w182 * w727 - w693
    w747 = w181 * w727 - w182 * w470
    w748 = w730 - w177 * w470
    w749 = w728 - w690
    w750 = w199 * w446 - w455 * (1.0 - w456 - w155) - w457 * (w447 + w448) - (w745 * c11 + w689 * w746 + w692 * w747 + w696 * w748 + w698 * w749)
    w751 = w519 + w745 + w187 * w689 + w183 * w692 + w178 * w696 + w159 * w698
    w752 = w140 * w736 - w718
    w753 = w135 * w736 - w140 * w710
    w754 = w739 - w166 * w710
    w755 = w737 - w715
    w756 = w193 * w704 - (w246 * w707 + w708 * (w230 - w229)) - (w751 * c12 + w714 * w752 + w717 * w753 + w721 * w754 + w723 * w755)
    w757 = w750 + w756
    w758 = w445 * c24
    w759 = w442 * c24
    w760 = w454 * c23
    w761 = w451 * c23
    w762 = w451 * w758 + w454 * w759 - (w442 * w760 + w445 * w761)
    w763 = w439 * c26
    w764 = w433 * c26
    w765 = w442 * w763 + w445 * w764 - (w433 * w758 + w439 * w759)
    w766 = w433 * w760 + w439 * w761 - (w451 * w763 + w454 * w764)
    w767 = w182 * c25
    w768 = w177 * c27
    w769 = w62 * c28
    w770 = bar2_e1 * bar2_e2 * c41 + w185 * w769
    w771 = w185 * w768 + bar2_e0 * bar2_e2 * c45
    w772 = w181 * w767 + bar2_e0 * bar2_e1 * c44
    w773 = w745 * w749 + w726 * w733 + w469 * w697 + w689 * w770 + w692 * w771 + w696 * w772 + w698 * (w182 * w767 + w177 * w768 + w62 * w769)
    w774 = w706 * c30
    w775 = w705 * c30
    w776 = w701 * c29
    w777 = w700 * c29
    w778 = w700 * w774 + w701 * w775 - (w705 * w776 + w706 * w777)
    w779 = w703 * c32
    w780 = w702 * c32
    w781 = w705 * w779 + w706 * w780 - (w702 * w774 + w703 * w775)
    w782 = w702 * w776 + w703 * w777 - (w700 * w779 + w701 * w780)
    w783 = w140 * c31
    w784 = w166 * c33
    w785 = w143 * c34
    w786 = bar3_e1 * bar3_e2 * c38 + w170 * w785
    w787 = w170 * w784 + bar3_e2 * bar3_e0 * c36
    w788 = w135 * w783 + bar3_e1 * bar3_e0 * c35
    w789 = w751 * w755 + w735 * w742 + w709 * w722 + w714 * w786 + w717 * w787 + w721 * w788 + w723 * (w140 * w783 + w166 * w784 + w143 * w785)
    w790 = w140 * w778 + w166 * w781 + w143 * w782 - w789
    w791 = w182 * w762 + w177 * w765 + w62 * w766 - w773 + w217 * w724 + w202 * w743 + w159 * w756 + w164 * w790
    w792 = w143 * c33
    w793 = w160 * c34
    w794 = w140 * w792 + bar3_e3 * bar3_e1 * c39
    w795 = bar3_e3 * bar3_e0 * c37 + w141 * w793
    w796 = w751 * w754 + w735 * w741 + w709 * w720 + w714 * w794 + w717 * w795 + w721 * (w135 * (w135 * c31) + w143 * w792 + w160 * w793)
    w797 = w135 * w778 + w143 * w781 + w160 * w782 - (w796 + w723 * w788)
    w798 = w143 * c31
    w799 = w160 * w798 + bar3_e3 * bar3_e2 * c40
    w800 = w751 * w753 + w735 * w740 + w709 * w716 + w714 * w799 + w717 * (w143 * w798 + w170 * (w170 * c33) + w141 * (w141 * c34))
    w801 = w143 * w778 + w170 * w781 + w141 * w782 - (w800 + w721 * w795 + w723 * w787)
    w802 = w751 * w752 + w735 * w738 + w709 * w713 + w714 * (w160 * (w160 * c31) + w140 * (w140 * c33) + w170 * (w170 * c34))
    w803 = w160 * w778 + w140 * w781 + w170 * w782 - (w802 + w717 * w799 + w721 * w794 + w723 * w786)
    w804 = w791 + w169 * w797 - w150 * w801 - w173 * w803
    w805 = w745 * w746 + w726 * w729 + w469 * w473 + w689 * (w151 * (w151 * c25) + w182 * (w182 * c27) + w185 * (w185 * c28))
    w806 = w62 * c25
    w807 = w151 * w806 + bar2_e2 * bar2_e3 * c47
    w808 = w62 * c27
    w809 = w151 * c28
    w810 = w182 * w808 + bar2_e1 * bar2_e3 * c46
    w811 = w151 * w762 + w182 * w765 + w185 * w766 - (w805 + w692 * w807 + w696 * w810 + w698 * w770) + w226 * w724
    w812 = w811 + w213 * w743 + w187 * w756 + w173 * w790 + w150 * w797 + w169 * w801 + w164 * w803
    w813 = w15 * c8
    w814 = w22 * c9
    w815 = bar1_e3 * bar1_e0 * c50 + w20 * w814
    w816 = w4 * w813 + bar1_e3 * bar1_e1 * c53
    w817 = w35 * w37 + w15 * w43 + w22 * w44 - (w51 * w815 - w53 * w816 + w56 * (w37 * (w37 * c6) + w15 * w813 + w22 * w814) + w54 * w57)
    w818 = bar2_e0 * bar2_e3 * c48 + w64 * w809
    w819 = w745 * w748 + w726 * w732 + w469 * w695 + w689 * w810 + w692 * w818 + w696 * (w181 * (w181 * c25) + w62 * w808 + w151 * w809)
    w820 = w181 * w762 + w62 * w765 + w151 * w766 - (w819 + w698 * w772) + w222 * w724 + w208 * w743 + w178 * w756
    w821 = w820 - w169 * w790 + w164 * w797 + w173 * w801 - w150 * w803
    w822 = w745 * w747 + w726 * w731 + w469 * w691 + w689 * w807 + w692 * (w62 * w806 + w185 * (w185 * c27) + w64 * (w64 * c28))
    w823 = w62 * w762 + w185 * w765 + w64 * w766 - (w822 + w696 * w818 + w698 * w771) + w224 * w724 + w211 * w743
    w824 = w823 + w183 * w756 + w150 * w790 - w173 * w797 + w164 * w801 - w169 * w803
    w825 = w3 * (w58 + w61 * w725 + w397 * w744 + w384 * w757 + w68 * w804 - w69 * w812) - w13 * (w817 + w409 * w725 + w399 * w744 + w387 * w757 + w68 * w821 + w69 * w824)
    w826 = w15 * c6
    w827 = w22 * w826 + bar1_e2 * bar1_e3 * c54
    w828 = w15 * w35 + w9 * w43 + w20 * w44 - (w51 * (w15 * w826 + w9 * (w9 * c8) + w20 * (w20 * c9)) - w53 * w827 + w56 * w815 + w48 * w57)
    w829 = w22 * w35 + w4 * w43 + w9 * w44 - (w51 * w827 - w53 * (w22 * (w22 * c6) + w4 * (w4 * c8) + w9 * (w9 * c9)) + w56 * w816 + w52 * w57)
    w830 = w825 + w7 * (w828 + w411 * w725 + w402 * w744 + w389 * w757 - w69 * w821 + w68 * w824) - w10 * (w829 + w413 * w725 + w404 * w744 + w392 * w757 + w69 * w804 + w68 * w812)
    w831 = w615 + w129 * w553 - w616 - w98 * w550
    w832 = w629 + w93 * w568 - w116 * w569 - w630
    w833 = w832 * c66
    w834 = w625 + w93 * w553 - w116 * w554 - w626
    w835 = w834 * c66
    w836 = w619 + w129 * w568 - w620 - w98 * w565
    w837 = w836 * c65
    w838 = w831 * c65
    w839 = w831 * w833 + w835 * w836 - (w834 * w837 + w832 * w838)
    w840 = w622 - w124 * w569 - w125 * w565
    w841 = w840 * c68
    w842 = w613 - w124 * w554 - w125 * w550
    w843 = w842 * c68
    w844 = w834 * w841 + w832 * w843 - (w833 * w842 + w835 * w840)
    w845 = w837 * w842 + w838 * w840 - (w831 * w841 + w836 * w843)
    w846 = w95 * c80
    w847 = w116 * w846
    w848 = w101 * c80
    w849 = w91 * w848
    w850 = w847 - w849
    w851 = w640 + w133 * w685
    w852 = w639 - w128 * w685
    w853 = w638 + w108 * w685
    w854 = w636 + w123 * w685
    w855 = w131 * w851 - w633 - w126 * w852 - w103 * w853 - w119 * w854
    w856 = w271 * c80
    w857 = w91 * w856
    w858 = w857 - w93 * w846
    w859 = w284 * w851 - w656 - w282 * w852 - w273 * w853 - w279 * w854
    w860 = w93 * w848 - w116 * w856
    w861 = w298 * w851 - w663 - w296 * w852 - w290 * w853 - w294 * w854
    w862 = w125 * c67
    w863 = w98 * c69
    w864 = w91 * c70
    w865 = bar5_e1 * bar5_e2 * c90 + w129 * w864
    w866 = w129 * w863 + bar5_e0 * bar5_e2 * c88
    w867 = w124 * w862 + bar5_e0 * bar5_e1 * c82
    w868 = w850 * w855 + w858 * w859 + w860 * w861 - w851 * w865 + w852 * w866 + w853 * w867 + w854 * (w125 * w862 + w98 * w863 + w91 * w864)
    w869 = w561 + (w560 + w113 * w555) - w74 * w558
    w870 = w582 + w233 * w570 + w109 * w571 - w583
    w871 = w870 * c72
    w872 = w578 + w233 * w555 + w109 * w557 - w579
    w873 = w872 * c72
    w874 = w572 + (w567 + w113 * w570) - w74 * w573
    w875 = w874 * c71
    w876 = w869 * c71
    w877 = w869 * w871 + w873 * w874 - (w872 * w875 + w870 * w876)
    w878 = w575 + w73 * w571 - w80 * w573
    w879 = w878 * c75
    w880 = w556 + w73 * w557 - w80 * w558
    w881 = w880 * c75
    w882 = w872 * w879 + w870 * w881 - (w871 * w880 + w873 * w878)
    w883 = w875 * w880 + w876 * w878 - (w869 * w879 + w874 * w881)
    w884 = w78 * c78
    w885 = w109 * w884
    w886 = w83 * c78
    w887 = w76 * w886
    w888 = w885 - w887
    w889 = w87 * w854 - (w601 + w90 * w851) + w351 * w686
    w890 = w599 + w90 * w852 - w87 * w853 - w350 * w686
    w891 = w597 + w87 * w852 + w90 * w853 + w349 * w686
    w892 = w593 + w87 * w851 + w90 * w854 - w348 * w686
    w893 = w855 - (w586 + w115 * w889 + w85 * w890 + w89 * w891 + w112 * w892)
    w894 = w264 * c78
    w895 = w76 * w894
    w896 = w895 - w233 * w884
    w897 = w859 - (w651 + w277 * w889 + w267 * w890 + w268 * w891 + w276 * w892)
    w898 = w233 * w886 - w109 * w894
    w899 = w861 - (w661 + w293 * w889 + w288 * w890 + w289 * w891 + w292 * w892)
    w900 = w80 * c73
    w901 = w74 * c76
    w902 = w76 * c77
    w903 = bar4_e1 * bar4_e2 * c79 + w113 * w902
    w904 = w113 * w901 + bar4_e0 * bar4_e2 * c84
    w905 = w73 * w900 + bar4_e1 * bar4_e0 * c83
    w906 = w888 * w893 + w896 * w897 + w898 * w899 + w889 * w903 + w890 * w904 + w891 * w905 + w892 * (w80 * w900 + w74 * w901 + w76 * w902)
    w907 = w870 * w872 * c144 + w869 * w874 * c144
    w908 = w880 * (w874 * c78) + w878 * (w869 * c78)
    w909 = w880 * (w870 * c78) + w878 * (w872 * c78)
    w910 = w80 * w894
    w911 = w109 * w886 - w910
    w912 = w887 - w73 * w894
    w913 = w113 * w886
    w914 = w913 - w895
    w915 = w78 * w907 - w235 * w908 - (w238 - w263) * w909 - (w899 * c74 + w889 * w911 + w890 * w912 + w891 * w914 + w892 * w898)
    w916 = w113 * w894 - w885
    w917 = w76 * w884
    w918 = w910 - w917
    w919 = w74 * w894 - w113 * w884
    w920 = w83 * w907 - w240 * w908 - w909 * (w234 - w232) - (w897 * c74 + w889 * w916 + w890 * w918 + w891 * w919 + w892 * w896)
    w921 = w80 * w884 - w913
    w922 = w73 * w884 - w80 * w886
    w923 = w917 - w74 * w886
    w924 = w264 * w907 - w243 * w908 - w909 * (w75 + w77) - (w893 * c74 + w889 * w921 + w890 * w922 + w891 * w923 + w888 * w892)
    w925 = w80 * w877 + w74 * w882 + w76 * w883 - w906 - w292 * w915 - w276 * w920 - w112 * w924
    w926 = w893 * w921 + w897 * w916 + w899 * w911 + w889 * (w109 * (w109 * c73) + w80 * (w80 * c76) + w113 * (w113 * c77))
    w927 = w76 * c73
    w928 = w109 * w927 + bar4_e3 * bar4_e2 * c86
    w929 = w76 * c76
    w930 = w109 * c77
    w931 = w80 * w929 + bar4_e3 * bar4_e1 * c85
    w932 = w109 * w877 + w80 * w882 + w113 * w883 - (w926 + w890 * w928 + w891 * w931 + w892 * w903) - w293 * w915
    w933 = w932 - w277 * w920 - w115 * w924
    w934 = w840 * w842 * c145 + w832 * w834 * c145
    w935 = bar5_e3 * w98
    w936 = w91 * bar5_e2
    w937 = w831 * (w840 * c80) + w836 * (w842 * c80)
    w938 = 2 * bar5_e2**2
    w939 = w831 * (w832 * c80) + w836 * (w834 * c80)
    w940 = w125 * w856
    w941 = w116 * w848 - w940
    w942 = w849 - w124 * w856
    w943 = w129 * w848
    w944 = w943 - w857
    w945 = w95 * w934 - (w935 - w936) * w937 - (w99 - w938) * w939 - (w861 * c64 - w851 * w941 + w852 * w942 + w853 * w944 + w854 * w860)
    w946 = w915 + w945
    w947 = w129 * w856 - w847
    w948 = w91 * w846
    w949 = w940 - w948
    w950 = w98 * w856 - w129 * w846
    w951 = w101 * w934 - w937 * (w269 + w270) - w939 * (w94 - w92) - (w859 * c64 - w851 * w947 + w852 * w949 + w853 * w950 + w854 * w858)
    w952 = w920 + w951
    w953 = w125 * w839 + w98 * w844 + w91 * w845 - w868 + w90 * w925 + w87 * w933 - w294 * w946 - w279 * w952
    w954 = w125 * w846 - w943
    w955 = w124 * w846 - w125 * w848
    w956 = w948 - w98 * w848
    w957 = w271 * w934 - w937 * (1.0 - w938 - w100) - w939 * (w935 + w936) - (w855 * c64 - w851 * w954 + w852 * w955 + w853 * w956 + w850 * w854)
    w958 = w924 + w957
    w959 = w91 * c69
    w960 = w116 * c70
    w961 = w125 * w959 + bar5_e1 * bar5_e3 * c91
    w962 = bar5_e0 * bar5_e3 * c89 + w93 * w960
    w963 = w855 * w956 + w859 * w950 + w861 * w944 - w851 * w961 + w852 * w962 + w853 * (w124 * (w124 * c67) + w91 * w959 + w116 * w960)
    w964 = bar4_e3 * bar4_e0 * c87 + w233 * w930
    w965 = w893 * w923 + w897 * w919 + w899 * w914 + w889 * w931 + w890 * w964 + w891 * (w73 * (w73 * c73) + w76 * w929 + w109 * w930)
    w966 = w73 * w877 + w76 * w882 + w109 * w883 - (w965 + w892 * w905) - w289 * w915 - w268 * w920 - w89 * w924
    w967 = w893 * w922 + w897 * w918 + w899 * w912 + w889 * w928 + w890 * (w76 * w927 + w113 * (w113 * c76) + w233 * (w233 * c77))
    w968 = w76 * w877 + w113 * w882 + w233 * w883 - (w967 + w891 * w964 + w892 * w904) - w288 * w915 - w267 * w920
    w969 = w968 - w85 * w924
    w970 = w124 * w839 + w91 * w844 + w116 * w845 - (w963 + w854 * w867) + w90 * w966 - w87 * w969 - w290 * w946
    w971 = w91 * c67
    w972 = w116 * w971 + bar5_e2 * bar5_e3 * c92
    w973 = w855 * w955 + w859 * w949 + w861 * w942 - w851 * w972 + w852 * (w91 * w971 + w129 * (w129 * c69) + w93 * (w93 * c70))
    w974 = w91 * w839 + w129 * w844 + w93 * w845 - (w973 + w853 * w962 + w854 * w866) + w87 * w966 + w90 * w969
    w975 = w123 * (w953 - w119 * w958) + w108 * (w970 - w273 * w952 - w103 * w958) - w128 * (w974 - w296 * w946 - w282 * w952 - w126 * w958)
    w976 = w855 * w954 + w859 * w947 + w861 * w941 - w851 * (w116 * (w116 * c67) + w125 * (w125 * c69) + w129 * (w129 * c70))
    w977 = w116 * w839 + w125 * w844 + w129 * w845 - (w976 + w852 * w972 + w853 * w961 + w854 * w865) - w87 * w925
    w978 = w830 - w422 * (w975 - w133 * (w977 + w90 * w933 - w298 * w946 - w284 * w952 - w131 * w958)) + w423 * (w349 * w966 - w348 * w925 - w350 * w969 + w351 * w933)
    w979 = w978 + w424 * (w324 * w790 + w325 * w797 + w326 * w801 - w323 * w803) + w426 * (w175 * w804 - w180 * w821 + w72 * w824 - w189 * w812)
    dQ_hat_dq_i_dot = ca.vertcat(
        w979,
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 7615 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 39)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 154)
    hinge0_angle = q_i[0]
    bar1_e0 = q_d[3]
    bar1_e1 = q_d[4]
    bar1_e2 = q_d[5]
    bar1_e3 = q_d[6]
    bar2_e0 = q_d[10]
    bar2_e1 = q_d[11]
    bar2_e2 = q_d[12]
    bar2_e3 = q_d[13]
    bar3_e0 = q_d[17]
    bar3_e1 = q_d[18]
    bar3_e2 = q_d[19]
    bar3_e3 = q_d[20]
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
    hinge0_angle_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c25 = c[25]
    c27 = c[27]
    c28 = c[28]
    c31 = c[31]
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
    c50 = c[50]
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
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c67 = c[67]
    c69 = c[69]
    c70 = c[70]
    c73 = c[73]
    c74 = c[74]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
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
    c103 = c[103]
    c110 = c[110]
    c111 = c[111]
    c112 = c[112]
    c113 = c[113]
    c114 = c[114]
    c115 = c[115]
    c116 = c[116]
    c117 = c[117]
    c118 = c[118]
    c119 = c[119]
    c120 = c[120]
    c121 = c[121]
    c136 = c[136]
    c137 = c[137]
    c138 = c[138]
    c139 = c[139]
    c140 = c[140]
    c146 = c[146]
    c147 = c[147]
    c148 = c[148]
    c149 = c[149]
    c150 = c[150]
    c151 = c[151]
    c152 = c[152]
    c153 = c[153]
    w0 = hinge0_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = w2 * c1 * c0 - w2 * c2 * c3
    w4 = 2 * bar1_e0
    w5 = bar1_e2 * -2.0
    w6 = w5 * c6
    w7 = bar1_e3 * -2.0
    w8 = 2 * bar1_e1
    w9 = w8 * c8
    w10 = 2 * bar1_e2
    w11 = w4 * c9
    w12 = w7 * w9 + bar1_e0 * bar1_e2 * c103
    w13 = w1 * 0.25
    w14 = w13 * c1 * c3 - w13 * c2 * c0
    w15 = hinge0_angle_ddot * w14
    w16 = bar1_e1 * -2.0
    w17 = bar1_e2 * bar1_e1 * c52 + w7 * w11
    w18 = w1 * c111
    w19 = hinge0_angle_ddot * w18
    w20 = 2 * bar1_e3
    w21 = w6 * w20 + bar1_e0 * bar1_e1 * c43
    w22 = ca.sin(w0)
    w23 = w22 * 0.25
    w24 = w22 * c110
    w25 = hinge0_angle_ddot * w24
    w26 = w5 * w6 + w8 * w9 + w4 * w11
    w27 = w23 * c2 * c3 - w23 * c1 * c0
    w28 = hinge0_angle_ddot * w27
    w29 = (w4 * bar1_e3 + bar1_e2 * w8) * c10
    w30 = (1.0 - 2 * bar1_e2**2 - 2 * bar1_e3**2) * c10
    w31 = w10 * w29 - w16 * w30
    w32 = w4 * w29
    w33 = w32 - w20 * w30
    w34 = w5 * w30
    w35 = w16 * w29 - w34
    w36 = w7 * w29
    w37 = w4 * w30
    w38 = w36 - w37
    w39 = w15 * w33 - w19 * w35 + w25 * w38 + w28 * w31
    w40 = bar2_e1 * -2.0
    w41 = 1.0 - 2 * bar2_e1**2 - 2 * bar2_e3**2
    w42 = w41 * c14
    w43 = bar2_e2 * -2.0
    w44 = 2 * bar2_e1
    w45 = 2 * bar2_e0
    w46 = bar2_e2 * w44 - bar2_e3 * w45
    w47 = w46 * c14
    w48 = w43 * w47
    w49 = w40 * w42 - w48
    w50 = hinge1_angle / 2.0
    w51 = ca.cos(w50)
    w52 = ca.sin(w50)
    w53 = w52 / 2.0
    w54 = w51 / 2.0
    w55 = bar1_e0 * w53 + bar1_e3 * w54
    w56 = 2 * bar4_e3
    w57 = 2 * bar4_e1
    w58 = 2 * bar4_e0
    w59 = bar4_e3 * w57 - w58 * bar4_e2
    w60 = w59 * c55
    w61 = bar4_e2 * -2.0
    w62 = bar4_e3 * w58
    w63 = w57 * bar4_e2
    w64 = w62 + w63
    w65 = w64 * c55
    w66 = w56 * w60 - w61 * w65
    w67 = hinge4_angle / 2.0
    w68 = ca.sin(w67)
    w69 = w58 * w60
    w70 = w69 - w57 * w65
    w71 = ca.cos(w67)
    w72 = 2 * bar5_e0
    w73 = 2 * bar5_e2
    w74 = w72 * bar5_e1 + w73 * bar5_e3
    w75 = w74 * c56
    w76 = w72 * w75
    w77 = 2 * bar5_e1
    w78 = 1.0 - 2 * bar5_e1**2 - 2 * bar5_e3**2
    w79 = w78 * c56
    w80 = w76 - w77 * w79
    w81 = w66 * w68 - w70 * w71 - w80
    w82 = hinge5_angle / 2.0
    w83 = ca.sin(w82)
    w84 = w83 / 2.0
    w85 = w84 * c57 * c58 - w84 * c59 * c60
    w86 = bar4_e1 * -2.0
    w87 = w60 * w86
    w88 = w58 * w65
    w89 = w87 - w88
    w90 = bar4_e3 * -2.0
    w91 = w65 * w90
    w92 = w60 * w61 - w91
    w93 = bar5_e1 * -2.0
    w94 = w75 * w93
    w95 = w72 * w79
    w96 = w94 - w95
    w97 = w71 * w89 + w68 * w92 + w96
    w98 = ca.cos(w82)
    w99 = w98 / 2.0
    w100 = w99 * c59 * c58 - w99 * c57 * c60
    w101 = 2 * bar5_e3
    w102 = bar5_e2 * -2.0
    w103 = w75 * w101 - w79 * w102
    w104 = w68 * w70 + w66 * w71 + w103
    w105 = w99 * c61
    w106 = bar5_e3 * -2.0
    w107 = w79 * w106
    w108 = w75 * w102 - w107
    w109 = w68 * w89 - w71 * w92 - w108
    w110 = w84 * c62
    w111 = w81 * w85 - w97 * w100 + w104 * w105 - w109 * w110
    w112 = 2 * bar3_e3
    w113 = 2 * bar3_e2**2
    w114 = 1.0 - 2 * bar3_e1**2 - w113
    w115 = w114 * c63
    w116 = bar3_e2 * -2.0
    w117 = 2 * bar3_e2
    w118 = 2 * bar3_e0
    w119 = bar3_e3 * w117 - bar3_e1 * w118
    w120 = w119 * c63
    w121 = w112 * w115 - w116 * w120
    w122 = hinge2_angle / 2.0
    w123 = ca.cos(w122)
    w124 = w123 * c16 * c19 - w123 * c18 * c17
    w125 = 2 * bar2_e2
    w126 = bar2_e1 * w45 + bar2_e3 * w125
    w127 = w126 * c15
    w128 = w40 * w127
    w129 = w41 * c15
    w130 = w45 * w129
    w131 = w128 - w130
    w132 = bar3_e1 * -2.0
    w133 = w115 * w132
    w134 = w118 * w120
    w135 = w133 - w134
    w136 = w123 * c20
    w137 = w115 * w118
    w138 = 2 * bar3_e1
    w139 = w137 - w120 * w138
    w140 = ca.sin(w122)
    w141 = w140 * c22
    w142 = bar3_e3 * -2.0
    w143 = w120 * w142
    w144 = w115 * w116 - w143
    w145 = w140 * c18 * c19 - w140 * c16 * c17
    w146 = w121 * w124 - (w131 + w135 * w136 + w139 * w141) + w144 * w145
    w147 = bar1_e0 * w54 - bar1_e3 * w53
    w148 = w45 * w127
    w149 = w148 - w44 * w129
    w150 = w135 * w141 - w149 - w136 * w139 - w121 * w145 + w124 * w144
    w151 = bar1_e2 * w53 + bar1_e1 * w54
    w152 = 2 * bar2_e3
    w153 = w127 * w152 - w43 * w129
    w154 = w139 * w145 - (w153 + w124 * w135) - w121 * w136 + w141 * w144
    w155 = bar1_e2 * w54 - bar1_e1 * w53
    w156 = bar2_e3 * -2.0
    w157 = w129 * w156
    w158 = w43 * w127 - w157
    w159 = w158 + w135 * w145 + w124 * w139 + w121 * w141 + w136 * w144
    w160 = w146 * w147 - w150 * w151 + w154 * w155 + w55 * w159
    w161 = bar3_e2 * w118
    w162 = bar3_e3 * w138
    w163 = w161 + w162
    w164 = w163 * c63
    w165 = w116 * w164
    w166 = w165 - w137
    w167 = w46 * c15
    w168 = w45 * w167
    w169 = w168 - w125 * w127
    w170 = w118 * w164
    w171 = w170 - w115 * w117
    w172 = w138 * w164 - w115 * w142
    w173 = w142 * w164 - w133
    w174 = w124 * w166 - (w169 + w136 * w171 + w141 * w172) + w145 * w173
    w175 = w44 * w167 - w127 * w156
    w176 = w141 * w171 - w175 - w136 * w172 - w145 * w166 + w124 * w173
    w177 = w43 * w167
    w178 = w177 - w148
    w179 = w145 * w172 - (w178 + w124 * w171) - w136 * w166 + w141 * w173
    w180 = w156 * w167 - w128
    w181 = w180 + w145 * w171 + w124 * w172 + w141 * w166 + w136 * w173
    w182 = w147 * w174 - w151 * w176 + w155 * w179 + w55 * w181
    w183 = w134 - w112 * w164
    w184 = w125 * w129 - w40 * w167
    w185 = w117 * w120 - w132 * w164
    w186 = w143 - w170
    w187 = w120 * w132 - w165
    w188 = w124 * w183 - (w184 + w136 * w185 + w141 * w186) + w145 * w187
    w189 = w157 - w168
    w190 = w141 * w185 - w189 - w136 * w186 - w145 * w183 + w124 * w187
    w191 = w130 - w152 * w167
    w192 = w145 * w186 - (w191 + w124 * w185) - w136 * w183 + w141 * w187
    w193 = w40 * w129 - w177
    w194 = w193 + w145 * w185 + w124 * w186 + w141 * w183 + w136 * w187
    w195 = w147 * w188 - w151 * w190 + w155 * w192 + w55 * w194
    w196 = bar3_e3 * w118 + bar3_e2 * w138
    w197 = 2 * bar4_e2
    w198 = bar4_e1 * w58 + bar4_e3 * w197
    w199 = w196 * w198
    w200 = w162 - w161
    w201 = 2 * bar4_e3**2
    w202 = 1.0 - 2 * bar4_e1**2 - w201
    w203 = w200 * w202
    w204 = w199 - w203
    w205 = w63 - w62
    w206 = w200 * w205
    w207 = 1.0 - w113 - 2 * bar3_e3**2
    w208 = w198 * w207
    w209 = w206 - w208
    w210 = w202 * w207
    w211 = w196 * w205
    w212 = w210 - w211
    w213 = w117 * w204 + w132 * w209 + w118 * w212
    w214 = w142 * w204 + w118 * w209 + w138 * w212
    w215 = w118 * w204 + w112 * w209 + w116 * w212
    w216 = w132 * w204 + w116 * w209 + w142 * w212
    w217 = w136 * w213 + w141 * w214 - w124 * w215 - w145 * w216
    w218 = w136 * w214 - w141 * w213 + w145 * w215 - w124 * w216
    w219 = w124 * w213 - w145 * w214 + w136 * w215 - w141 * w216
    w220 = w145 * w213 + w124 * w214 + w141 * w215 + w136 * w216
    w221 = w147 * w217 - w151 * w218 + w155 * w219 - w55 * w220
    w222 = ca.sqrt(w160**2 + w182**2 + w195**2 + w221**2)
    w223 = w160 / w222
    w224 = 1.0 - 2 * bar4_e2**2 - w201
    w225 = w224 * c55
    w226 = w61 * w225
    w227 = w226 - w69
    w228 = w57 * w225 - w60 * w90
    w229 = bar5_e2 * w77 - w72 * bar5_e3
    w230 = w229 * c56
    w231 = w77 * w230 - w75 * w106
    w232 = w68 * w227 - w71 * w228 - w231
    w233 = w58 * w225
    w234 = w233 - w60 * w197
    w235 = w90 * w225 - w87
    w236 = w72 * w230
    w237 = w236 - w73 * w75
    w238 = w71 * w234 + w68 * w235 + w237
    w239 = w102 * w230
    w240 = w239 - w76
    w241 = w68 * w228 + w71 * w227 + w240
    w242 = w106 * w230 - w94
    w243 = w68 * w234 - w71 * w235 - w242
    w244 = w85 * w232 - w100 * w238 + w105 * w241 - w110 * w243
    w245 = w182 / w222
    w246 = w88 - w56 * w225
    w247 = w91 - w233
    w248 = w107 - w236
    w249 = w68 * w246 - w71 * w247 - w248
    w250 = w65 * w197 - w86 * w225
    w251 = w65 * w86 - w226
    w252 = w73 * w79 - w93 * w230
    w253 = w71 * w250 + w68 * w251 + w252
    w254 = w95 - w101 * w230
    w255 = w68 * w247 + w71 * w246 + w254
    w256 = w79 * w93 - w239
    w257 = w68 * w250 - w71 * w251 - w256
    w258 = w85 * w249 - w100 * w253 + w105 * w255 - w110 * w257
    w259 = w195 / w222
    w260 = w203 - w199
    w261 = w208 - w206
    w262 = w211 - w210
    w263 = w197 * w260 + w86 * w261 + w58 * w262
    w264 = w86 * w260 + w61 * w261 + w90 * w262
    w265 = w71 * w263 + w68 * w264
    w266 = w90 * w260 + w58 * w261 + w57 * w262
    w267 = w58 * w260 + w56 * w261 + w61 * w262
    w268 = w71 * w266 - w68 * w267
    w269 = w68 * w266 + w71 * w267
    w270 = w71 * w264 - w68 * w263
    w271 = w100 * w265 + w85 * w268 - w105 * w269 - w110 * w270
    w272 = w221 / w222
    w273 = w111 * w223 + w244 * w245 + w258 * w259 + w271 * w272
    w274 = w111 - w223 * w273
    w275 = w140 / 2.0
    w276 = w275 * c20
    w277 = w123 / 2.0
    w278 = w277 * c22
    w279 = w275 * c18 * c17 - w275 * c16 * c19
    w280 = w277 * c18 * c19 - w277 * c16 * c17
    w281 = bar2_e0 * w276 + (bar2_e1 * w278 + bar2_e2 * w279 + bar2_e3 * w280)
    w282 = bar2_e0 * w280 - bar2_e3 * w276 + (bar2_e1 * w279 - bar2_e2 * w278)
    w283 = bar2_e0 * w279 - bar2_e2 * w276 + (bar2_e3 * w278 - bar2_e1 * w280)
    w284 = bar2_e0 * w278 - bar2_e1 * w276 + (bar2_e2 * w280 - bar2_e3 * w279)
    w285 = w144 * w281 - (w135 * w282 + w139 * w283 + w121 * w284)
    w286 = w173 * w281 - (w171 * w282 + w172 * w283 + w166 * w284)
    w287 = w187 * w281 - (w185 * w282 + w186 * w283 + w183 * w284)
    w288 = w213 * w282 + w214 * w283 + w215 * w284 - w216 * w281
    w289 = w223 * w285 + w245 * w286 + w259 * w287 + w272 * w288
    w290 = w285 - w223 * w289
    w291 = w286 - w245 * w289
    w292 = w287 - w259 * w289
    w293 = w288 - w272 * w289
    w294 = ca.sqrt(w290**2 + w291**2 + w292**2 + w293**2)
    w295 = w290 / w294
    w296 = w244 - w245 * w273
    w297 = w291 / w294
    w298 = w258 - w259 * w273
    w299 = w292 / w294
    w300 = w271 - w272 * w273
    w301 = w293 / w294
    w302 = w274 * w295 + w296 * w297 + w298 * w299 + w300 * w301
    w303 = w274 - w295 * w302
    w304 = w71 / 2.0
    w305 = w68 / 2.0
    w306 = bar5_e0 * w304 + bar5_e3 * w305
    w307 = bar5_e1 * w304 - bar5_e2 * w305
    w308 = bar5_e1 * w305 + bar5_e2 * w304
    w309 = bar5_e3 * w304 - bar5_e0 * w305
    w310 = w89 * w306 - w70 * w307 + w66 * w308 - w92 * w309
    w311 = w234 * w306 - w228 * w307 + w227 * w308 - w235 * w309
    w312 = w250 * w306 - w247 * w307 + w246 * w308 - w251 * w309
    w313 = w266 * w307 - w263 * w306 - w267 * w308 + w264 * w309
    w314 = w223 * w310 + w245 * w311 + w259 * w312 + w272 * w313
    w315 = w310 - w223 * w314
    w316 = w311 - w245 * w314
    w317 = w312 - w259 * w314
    w318 = w313 - w272 * w314
    w319 = w295 * w315 + w297 * w316 + w299 * w317 + w301 * w318
    w320 = w315 - w295 * w319
    w321 = w316 - w297 * w319
    w322 = w317 - w299 * w319
    w323 = w318 - w301 * w319
    w324 = ca.sqrt(w320**2 + w321**2 + w322**2 + w323**2)
    w325 = w320 / w324
    w326 = w296 - w297 * w302
    w327 = w321 / w324
    w328 = w298 - w299 * w302
    w329 = w322 / w324
    w330 = w300 - w301 * w302
    w331 = w323 / w324
    w332 = w303 * w325 + w326 * w327 + w328 * w329 + w330 * w331
    w333 = w303 - w325 * w332
    w334 = w326 - w327 * w332
    w335 = w328 - w329 * w332
    w336 = w330 - w331 * w332
    w337 = ca.sqrt(w333**2 + w334**2 + w335**2 + w336**2)
    w338 = w333 / w337
    w339 = (bar1_e3 * w8 - w4 * bar1_e2) * c10
    w340 = w16 * w339
    w341 = w340 - w32
    w342 = w51 * w146 - w341 + w52 * w159
    w343 = w4 * w339
    w344 = w343 - w8 * w29
    w345 = w51 * w150 - w344 + w52 * w154
    w346 = w20 * w339 - w5 * w29
    w347 = w51 * w154 - (w346 + w52 * w150)
    w348 = w5 * w339 - w36
    w349 = w52 * w146 - w348 - w51 * w159
    w350 = w27 * w342 + w24 * w345 + w14 * w347 - w18 * w349
    w351 = w334 / w337
    w352 = w37 - w10 * w339
    w353 = w51 * w174 - w352 + w52 * w181
    w354 = w8 * w30 - w7 * w339
    w355 = w51 * w176 - w354 + w52 * w179
    w356 = w34 - w343
    w357 = w51 * w179 - (w356 + w52 * w176)
    w358 = w7 * w30 - w340
    w359 = w52 * w174 - w358 - w51 * w181
    w360 = w27 * w353 + w24 * w355 + w14 * w357 - w18 * w359
    w361 = w335 / w337
    w362 = w51 * w188 - w31 + w52 * w194
    w363 = w51 * w190 - w38 + w52 * w192
    w364 = w51 * w192 - (w33 + w52 * w190)
    w365 = w52 * w188 - w35 - w51 * w194
    w366 = w27 * w362 + w24 * w363 + w14 * w364 - w18 * w365
    w367 = w336 / w337
    w368 = w51 * w217 - w52 * w220
    w369 = w51 * w218 + w52 * w219
    w370 = w51 * w219 - w52 * w218
    w371 = w52 * w217 + w51 * w220
    w372 = w27 * w368 + w24 * w369 + w14 * w370 - w18 * w371
    w373 = (w338 * w350 + w351 * w360 + w361 * w366 + w367 * w372) / w337
    w374 = (w332 * w373 - (w325 * w350 + w327 * w360 + w329 * w366 + w331 * w372)) / w324
    w375 = (w302 * w373 - (w295 * w350 + w297 * w360 + w299 * w366 + w301 * w372) - w319 * w374) / w294
    w376 = w273 * w373 - (w223 * w350 + w245 * w360 + w259 * w366 + w272 * w372) - w314 * w374 - w289 * w375
    w377 = w376 / w222
    w378 = hinge0_angle_ddot * w377
    w379 = w19 * w51 + w28 * w52 + w55 * w378
    w380 = w42 * w45
    w381 = w380 - w47 * w152
    w382 = w15 * w51 + w25 * w52 + w155 * w378
    w383 = w42 * w156
    w384 = w45 * w47
    w385 = w383 - w384
    w386 = w15 * w52 - w25 * w51 + w151 * w378
    w387 = w42 * w125 - w40 * w47
    w388 = w28 * w51 - w19 * w52 + w147 * w378
    w389 = w39 - w193 * w379 + w191 * w382 - w189 * w386 + w184 * w388
    w390 = w119 * c21
    w391 = w163 * c21
    w392 = w116 * w391
    w393 = w132 * w390 - w392
    w394 = hinge0_angle_ddot * w375
    w395 = w124 * w386 - (w136 * w379 + w141 * w382) - w145 * w388 - w281 * w394
    w396 = w118 * w390
    w397 = w396 - w112 * w391
    w398 = w136 * w382 - w141 * w379 - w145 * w386 - w124 * w388 + w284 * w394
    w399 = w142 * w390
    w400 = w118 * w391
    w401 = w399 - w400
    w402 = w141 * w388 - (w124 * w379 + w145 * w382 + w136 * w386) + w283 * w394
    w403 = w117 * w390 - w132 * w391
    w404 = w124 * w382 - w145 * w379 + w141 * w386 + w136 * w388 + w282 * w394
    w405 = w389 * c12 + w393 * w395 + w397 * w398 + w401 * w402 + w403 * w404
    w406 = w39 * c11 - w49 * w379 + w381 * w382 - w385 * w386 + w387 * w388 + w405
    w407 = w15 * w356 - w19 * w358 + w25 * w354 + w28 * w352
    w408 = w126 * c14
    w409 = w40 * w408
    w410 = w47 * w156 - w409
    w411 = w45 * w408
    w412 = w48 - w411
    w413 = w44 * w47 - w156 * w408
    w414 = w384 - w125 * w408
    w415 = w407 - w180 * w379 + w178 * w382 - w175 * w386 + w169 * w388
    w416 = w114 * c21
    w417 = w132 * w416
    w418 = w142 * w391 - w417
    w419 = w118 * w416
    w420 = w392 - w419
    w421 = w138 * w391 - w142 * w416
    w422 = w400 - w117 * w416
    w423 = w415 * c12 + w395 * w418 + w398 * w420 + w402 * w421 + w404 * w422
    w424 = w407 * c11 - w379 * w410 + w382 * w412 - w386 * w413 + w388 * w414 + w423
    w425 = w15 * w346 - w19 * w348 + w25 * w344 + w28 * w341
    w426 = w43 * w408 - w383
    w427 = w152 * w408 - w42 * w43
    w428 = w411 - w42 * w44
    w429 = w409 - w380
    w430 = w425 - w158 * w379 + w153 * w382 - w149 * w386 + w131 * w388
    w431 = w116 * w416 - w399
    w432 = w112 * w416 - w116 * w390
    w433 = w419 - w138 * w390
    w434 = w417 - w396
    w435 = w430 * c12 + w395 * w431 + w398 * w432 + w402 * w433 + w404 * w434
    w436 = w425 * c11 - w379 * w426 + w382 * w427 - w386 * w428 + w388 * w429 + w435
    w437 = w43 * c25
    w438 = w44 * c27
    w439 = w45 * c28
    w440 = bar2_e1 * bar2_e2 * c41 + w156 * w439
    w441 = w156 * w438 + bar2_e2 * bar2_e0 * c45
    w442 = w152 * w437 + bar2_e1 * bar2_e0 * c44
    w443 = w43 * w437 + w44 * w438 + w45 * w439
    w444 = w425 * w429 + w407 * w414 + w39 * w387 - w379 * w440 + w382 * w441 - w386 * w442 + w388 * w443 + w184 * w405
    w445 = w116 * c31
    w446 = w138 * c33
    w447 = w118 * c34
    w448 = bar3_e1 * bar3_e2 * c38 + w142 * w447
    w449 = w142 * w446 + bar3_e2 * bar3_e0 * c36
    w450 = w112 * w445 + bar3_e1 * bar3_e0 * c35
    w451 = w116 * w445 + w138 * w446 + w118 * w447
    w452 = w430 * w434 + w415 * w422 + w389 * w403 + w395 * w448 + w398 * w449 + w402 * w450 + w404 * w451
    w453 = w112 * c31
    w454 = w118 * c33
    w455 = w132 * c34
    w456 = w116 * w454 + bar3_e3 * bar3_e1 * c39
    w457 = bar3_e3 * bar3_e0 * c37 + w117 * w455
    w458 = w112 * w453 + w118 * w454 + w132 * w455
    w459 = w430 * w433 + w415 * w421 + w389 * w401 + w395 * w456 + w398 * w457 + w402 * w458 + w404 * w450
    w460 = w118 * c31
    w461 = w142 * c33
    w462 = w117 * c34
    w463 = w132 * w460 + bar3_e3 * bar3_e2 * c40
    w464 = w118 * w460 + w142 * w461 + w117 * w462
    w465 = w430 * w432 + w415 * w420 + w389 * w397 + w395 * w463 + w398 * w464 + w402 * w457 + w404 * w449
    w466 = w132 * (w132 * c31) + w116 * (w116 * c33) + w142 * (w142 * c34)
    w467 = w430 * w431 + w415 * w418 + w389 * w393 + w395 * w466 + w398 * w463 + w402 * w456 + w404 * w448
    w468 = w444 + w169 * w423 + w131 * w435 + w136 * w452 + w141 * w459 - w124 * w465 - w145 * w467
    w469 = w12 * w15 - w17 * w19 + w21 * w25 + w26 * w28 + w31 * w406 + w352 * w424 + w341 * w436 + w51 * w468
    w470 = w40 * (w40 * c25) + w43 * (w43 * c27) + w156 * (w156 * c28)
    w471 = w45 * c25
    w472 = w156 * c27
    w473 = w125 * c28
    w474 = w40 * w471 + bar2_e3 * bar2_e2 * c47
    w475 = w152 * c25
    w476 = w45 * c27
    w477 = w40 * c28
    w478 = w43 * w476 + bar2_e1 * bar2_e3 * c46
    w479 = w425 * w426 + w407 * w410 + w39 * w49 - w379 * w470 + w382 * w474 - w386 * w478 + w388 * w440 + w193 * w405
    w480 = w479 + w180 * w423 + w158 * w435 + w145 * w452 + w124 * w459 + w141 * w465 + w136 * w467
    w481 = w22 / 2.0
    w482 = w481 * c1 * c3 - w481 * c2 * c0
    w483 = hinge0_angle_ddot * w482
    w484 = w481 * c51
    w485 = hinge0_angle_ddot * w484
    w486 = w2 * c42
    w487 = hinge0_angle_ddot * w486
    w488 = w3 * hinge0_angle_ddot
    w489 = w33 * w483 - w35 * w485 - w38 * w487 + w31 * w488
    w490 = w3 * w342 - w345 * w486 + w347 * w482 - w349 * w484
    w491 = w3 * w353 - w355 * w486 + w357 * w482 - w359 * w484
    w492 = w3 * w362 - w363 * w486 + w364 * w482 - w365 * w484
    w493 = w3 * w368 - w369 * w486 + w370 * w482 - w371 * w484
    w494 = (w338 * w490 + w351 * w491 + w361 * w492 + w367 * w493) / w337
    w495 = (w332 * w494 - (w325 * w490 + w327 * w491 + w329 * w492 + w331 * w493)) / w324
    w496 = (w302 * w494 - (w295 * w490 + w297 * w491 + w299 * w492 + w301 * w493) - w319 * w495) / w294
    w497 = w273 * w494 - (w223 * w490 + w245 * w491 + w259 * w492 + w272 * w493) - w314 * w495 - w289 * w496
    w498 = w497 / w222
    w499 = hinge0_angle_ddot * w498
    w500 = w51 * w485 + w52 * w488 + w55 * w499
    w501 = w51 * w483 - w52 * w487 + w155 * w499
    w502 = w52 * w483 + w51 * w487 + w151 * w499
    w503 = w51 * w488 - w52 * w485 + w147 * w499
    w504 = w489 - w193 * w500 + w191 * w501 - w189 * w502 + w184 * w503
    w505 = hinge0_angle_ddot * w496
    w506 = w124 * w502 - (w136 * w500 + w141 * w501) - w145 * w503 - w281 * w505
    w507 = w136 * w501 - w141 * w500 - w145 * w502 - w124 * w503 + w284 * w505
    w508 = w141 * w503 - (w124 * w500 + w145 * w501 + w136 * w502) + w283 * w505
    w509 = w124 * w501 - w145 * w500 + w141 * w502 + w136 * w503 + w282 * w505
    w510 = w504 * c12 + w393 * w506 + w397 * w507 + w401 * w508 + w403 * w509
    w511 = w489 * c11 - w49 * w500 + w381 * w501 - w385 * w502 + w387 * w503 + w510
    w512 = w356 * w483 - w358 * w485 - w354 * w487 + w352 * w488
    w513 = w512 - w180 * w500 + w178 * w501 - w175 * w502 + w169 * w503
    w514 = w513 * c12 + w418 * w506 + w420 * w507 + w421 * w508 + w422 * w509
    w515 = w512 * c11 - w410 * w500 + w412 * w501 - w413 * w502 + w414 * w503 + w514
    w516 = w346 * w483 - w348 * w485 - w344 * w487 + w341 * w488
    w517 = w516 - w158 * w500 + w153 * w501 - w149 * w502 + w131 * w503
    w518 = w517 * c12 + w431 * w506 + w432 * w507 + w433 * w508 + w434 * w509
    w519 = w516 * c11 - w426 * w500 + w427 * w501 - w428 * w502 + w429 * w503 + w518
    w520 = w429 * w516 + w414 * w512 + w387 * w489 - w440 * w500 + w441 * w501 - w442 * w502 + w443 * w503 + w184 * w510
    w521 = w434 * w517 + w422 * w513 + w403 * w504 + w448 * w506 + w449 * w507 + w450 * w508 + w451 * w509
    w522 = w433 * w517 + w421 * w513 + w401 * w504 + w456 * w506 + w457 * w507 + w458 * w508 + w450 * w509
    w523 = w432 * w517 + w420 * w513 + w397 * w504 + w463 * w506 + w464 * w507 + w457 * w508 + w449 * w509
    w524 = w431 * w517 + w418 * w513 + w393 * w504 + w466 * w506 + w463 * w507 + w456 * w508 + w448 * w509
    w525 = w520 + w169 * w514 + w131 * w518 + w136 * w521 + w141 * w522 - w124 * w523 - w145 * w524
    w526 = w12 * w483 - w17 * w485 - w21 * w487 + w26 * w488 + w31 * w511 + w352 * w515 + w341 * w519 + w51 * w525
    w527 = w426 * w516 + w410 * w512 + w49 * w489 - w470 * w500 + w474 * w501 - w478 * w502 + w440 * w503 + w193 * w510
    w528 = w527 + w180 * w514 + w158 * w518 + w145 * w521 + w124 * w522 + w141 * w523 + w136 * w524
    w529 = w20 * c6
    w530 = w4 * c8
    w531 = w16 * c9
    w532 = bar1_e0 * bar1_e3 * c50 + w10 * w531
    w533 = w5 * w530 + bar1_e3 * bar1_e1 * c53
    w534 = w20 * w529 + w4 * w530 + w16 * w531
    w535 = bar2_e3 * bar2_e0 * c48 + w125 * w477
    w536 = w152 * w475 + w45 * w476 + w40 * w477
    w537 = w425 * w428 + w407 * w413 + w39 * w385 - w379 * w478 + w382 * w535 - w386 * w536 + w388 * w442 + w189 * w405
    w538 = w537 + w175 * w423 + w149 * w435 - w141 * w452 + w136 * w459 + w145 * w465 - w124 * w467
    w539 = w15 * w532 - w19 * w533 + w25 * w534 + w21 * w28 + w38 * w406 + w354 * w424 + w344 * w436 + w51 * w538
    w540 = w45 * w471 + w156 * w472 + w125 * w473
    w541 = w425 * w427 + w407 * w412 + w39 * w381 - w379 * w474 + w382 * w540 - w386 * w535 + w388 * w441 + w191 * w405
    w542 = w541 + w178 * w423 + w153 * w435 + w124 * w452 - w145 * w459 + w136 * w465 - w141 * w467
    w543 = w428 * w516 + w413 * w512 + w385 * w489 - w478 * w500 + w501 * w535 - w502 * w536 + w442 * w503 + w189 * w510
    w544 = w543 + w175 * w514 + w149 * w518 - w141 * w521 + w136 * w522 + w145 * w523 - w124 * w524
    w545 = w483 * w532 - w485 * w533 - w487 * w534 + w21 * w488 + w38 * w511 + w354 * w515 + w344 * w519 + w51 * w544
    w546 = w427 * w516 + w412 * w512 + w381 * w489 - w474 * w500 + w501 * w540 - w502 * w535 + w441 * w503 + w191 * w510
    w547 = w546 + w178 * w514 + w153 * w518 + w124 * w521 - w145 * w522 + w136 * w523 - w141 * w524
    w548 = w3 * (w469 - w52 * w480) + w27 * (w526 - w52 * w528) - (w486 * (w539 + w52 * w542) - w24 * (w545 + w52 * w547))
    w549 = w4 * c6
    w550 = w7 * c8
    w551 = w10 * c9
    w552 = w4 * w549 + w7 * w550 + w10 * w551
    w553 = w16 * w549 + bar1_e2 * bar1_e3 * c54
    w554 = w15 * w552 - w19 * w553 + w25 * w532 + w12 * w28 + w33 * w406 + w356 * w424 + w346 * w436 - w52 * w538
    w555 = w483 * w552 - w485 * w553 - w487 * w532 + w12 * w488 + w33 * w511 + w356 * w515 + w346 * w519 - w52 * w544
    w556 = w16 * (w16 * c6) + w5 * (w5 * c8) + w7 * (w7 * c9)
    w557 = w15 * w553 - w19 * w556 + w25 * w533 + w17 * w28 + w35 * w406 + w358 * w424 + w348 * w436 + w52 * w468
    w558 = w483 * w553 - w485 * w556 - w487 * w533 + w17 * w488 + w35 * w511 + w358 * w515 + w348 * w519 + w52 * w525
    w559 = w548 + (w482 * (w554 + w51 * w542) + w14 * (w555 + w51 * w547)) - (w484 * (w557 + w51 * w480) + w18 * (w558 + w51 * w528))
    w560 = w74 * c80
    w561 = w93 * w560
    w562 = w78 * c80
    w563 = w72 * w562
    w564 = w561 - w563
    w565 = hinge0_angle_ddot * w373
    w566 = w85 * w565
    w567 = w110 * w565
    w568 = w105 * w565
    w569 = w100 * w565
    w570 = w80 * w566 - (w108 * w567 + w103 * w568) + w96 * w569
    w571 = w229 * c80
    w572 = w72 * w571
    w573 = w572 - w73 * w560
    w574 = w231 * w566 - (w242 * w567 + w240 * w568) + w237 * w569
    w575 = w73 * w562 - w93 * w571
    w576 = w248 * w566 - (w256 * w567 + w254 * w568) + w252 * w569
    w577 = w102 * c67
    w578 = w77 * c69
    w579 = w72 * c70
    w580 = bar5_e1 * bar5_e2 * c90 + w106 * w579
    w581 = w106 * w578 + bar5_e0 * bar5_e2 * c88
    w582 = w101 * w577 + bar5_e0 * bar5_e1 * c82
    w583 = w102 * w577 + w77 * w578 + w72 * w579
    w584 = w59 * c78
    w585 = w86 * w584
    w586 = w64 * c78
    w587 = w58 * w586
    w588 = w585 - w587
    w589 = hinge0_angle_ddot * w374
    w590 = w68 * w567 + w71 * w569 + w306 * w589
    w591 = w71 * w567 - w68 * w569 + w309 * w589
    w592 = w71 * w568 + w68 * w566 - w308 * w589
    w593 = w68 * w568 - w71 * w566 + w307 * w589
    w594 = w570 + (w89 * w590 - (w92 * w591 + w66 * w592 + w70 * w593))
    w595 = w224 * c78
    w596 = w58 * w595
    w597 = w596 - w197 * w584
    w598 = w574 + (w234 * w590 - (w235 * w591 + w227 * w592 + w228 * w593))
    w599 = w197 * w586 - w86 * w595
    w600 = w576 + (w250 * w590 - (w251 * w591 + w246 * w592 + w247 * w593))
    w601 = w61 * c73
    w602 = w57 * c76
    w603 = w58 * c77
    w604 = bar4_e1 * bar4_e2 * c79 + w90 * w603
    w605 = w90 * w602 + bar4_e0 * bar4_e2 * c84
    w606 = w56 * w601 + bar4_e1 * bar4_e0 * c83
    w607 = w61 * w601 + w57 * w602 + w58 * w603
    w608 = w61 * w595
    w609 = w86 * w586 - w608
    w610 = w587 - w56 * w595
    w611 = w90 * w586
    w612 = w611 - w596
    w613 = w600 * c74 + w591 * w609 + w592 * w610 + w593 * w612 - w590 * w599
    w614 = w588 * w594 + w597 * w598 + w599 * w600 + w591 * w604 + w592 * w605 + w593 * w606 - w590 * w607 - w250 * w613
    w615 = w90 * w595 - w585
    w616 = w58 * w584
    w617 = w608 - w616
    w618 = w57 * w595 - w90 * w584
    w619 = w598 * c74 + w591 * w615 + w592 * w617 + w593 * w618 - w590 * w597
    w620 = w61 * w584 - w611
    w621 = w56 * w584 - w61 * w586
    w622 = w616 - w57 * w586
    w623 = w594 * c74 + w591 * w620 + w592 * w621 + w593 * w622 - w588 * w590
    w624 = w614 - w234 * w619 - w89 * w623
    w625 = w564 * w570 + w573 * w574 + w575 * w576 + w567 * w580 + w568 * w581 - w566 * w582 - w569 * w583 + w71 * w624
    w626 = w86 * (w86 * c73) + w61 * (w61 * c76) + w90 * (w90 * c77)
    w627 = w58 * c73
    w628 = w90 * c76
    w629 = w197 * c77
    w630 = w86 * w627 + bar4_e3 * bar4_e2 * c86
    w631 = w56 * c73
    w632 = w58 * c76
    w633 = w86 * c77
    w634 = w61 * w632 + bar4_e3 * bar4_e1 * c85
    w635 = w594 * w620 + w598 * w615 + w600 * w609 + w591 * w626 + w592 * w630 + w593 * w634 - w590 * w604 - w251 * w613
    w636 = w635 - w235 * w619 - w92 * w623
    w637 = w102 * w571
    w638 = w93 * w562 - w637
    w639 = w563 - w101 * w571
    w640 = w106 * w562
    w641 = w640 - w572
    w642 = w613 + (w576 * c64 + w567 * w638 + w568 * w639 - w566 * w641 - w569 * w575)
    w643 = w106 * w571 - w561
    w644 = w72 * w560
    w645 = w637 - w644
    w646 = w77 * w571 - w106 * w560
    w647 = w619 + (w574 * c64 + w567 * w643 + w568 * w645 - w566 * w646 - w569 * w573)
    w648 = w102 * w560 - w640
    w649 = w101 * w560 - w102 * w562
    w650 = w644 - w77 * w562
    w651 = w623 + (w570 * c64 + w567 * w648 + w568 * w649 - w566 * w650 - w564 * w569)
    w652 = w101 * c67
    w653 = w72 * c69
    w654 = w93 * c70
    w655 = w102 * w653 + bar5_e1 * bar5_e3 * c91
    w656 = bar5_e0 * bar5_e3 * c89 + w73 * w654
    w657 = w101 * w652 + w72 * w653 + w93 * w654
    w658 = bar4_e3 * bar4_e0 * c87 + w197 * w633
    w659 = w56 * w631 + w58 * w632 + w86 * w633
    w660 = w594 * w622 + w598 * w618 + w600 * w612 + w591 * w634 + w592 * w658 + w593 * w659 - w590 * w606 - w247 * w613
    w661 = w660 - w228 * w619 - w70 * w623
    w662 = w570 * w650 + w574 * w646 + w576 * w641 + w567 * w655 + w568 * w656 - w566 * w657 - w569 * w582 + w71 * w661
    w663 = w58 * w627 + w90 * w628 + w197 * w629
    w664 = w594 * w621 + w598 * w617 + w600 * w610 + w591 * w630 + w592 * w663 + w593 * w658 - w590 * w605 - w246 * w613
    w665 = w664 - w227 * w619 - w66 * w623
    w666 = w100 * (w625 + w68 * w636 - w252 * w642 - w237 * w647 - w96 * w651) + w85 * (w662 - w68 * w665 - w248 * w642 - w231 * w647 - w80 * w651)
    w667 = w72 * c67
    w668 = w106 * c69
    w669 = w73 * c70
    w670 = w93 * w667 + bar5_e2 * bar5_e3 * c92
    w671 = w72 * w667 + w106 * w668 + w73 * w669
    w672 = w570 * w649 + w574 * w645 + w576 * w639 + w567 * w670 + w568 * w671 - w566 * w656 - w569 * w581 + w68 * w661
    w673 = w93 * (w93 * c67) + w102 * (w102 * c69) + w106 * (w106 * c70)
    w674 = w570 * w648 + w574 * w643 + w576 * w638 + w567 * w673 + w568 * w670 - w566 * w655 - w569 * w580 - w68 * w624
    w675 = w666 - w105 * (w672 + w71 * w665 - w254 * w642 - w240 * w647 - w103 * w651) - w110 * (w674 + w71 * w636 - w256 * w642 - w242 * w647 - w108 * w651)
    w676 = hinge0_angle_ddot * w494
    w677 = w85 * w676
    w678 = w110 * w676
    w679 = w105 * w676
    w680 = w100 * w676
    w681 = w80 * w677 - (w108 * w678 + w103 * w679) + w96 * w680
    w682 = w231 * w677 - (w242 * w678 + w240 * w679) + w237 * w680
    w683 = w248 * w677 - (w256 * w678 + w254 * w679) + w252 * w680
    w684 = hinge0_angle_ddot * w495
    w685 = w68 * w678 + w71 * w680 + w306 * w684
    w686 = w71 * w678 - w68 * w680 + w309 * w684
    w687 = w71 * w679 + w68 * w677 - w308 * w684
    w688 = w68 * w679 - w71 * w677 + w307 * w684
    w689 = w681 + (w89 * w685 - (w92 * w686 + w66 * w687 + w70 * w688))
    w690 = w682 + (w234 * w685 - (w235 * w686 + w227 * w687 + w228 * w688))
    w691 = w683 + (w250 * w685 - (w251 * w686 + w246 * w687 + w247 * w688))
    w692 = w691 * c74 + w609 * w686 + w610 * w687 + w612 * w688 - w599 * w685
    w693 = w588 * w689 + w597 * w690 + w599 * w691 + w604 * w686 + w605 * w687 + w606 * w688 - w607 * w685 - w250 * w692
    w694 = w690 * c74 + w615 * w686 + w617 * w687 + w618 * w688 - w597 * w685
    w695 = w689 * c74 + w620 * w686 + w621 * w687 + w622 * w688 - w588 * w685
    w696 = w693 - w234 * w694 - w89 * w695
    w697 = w564 * w681 + w573 * w682 + w575 * w683 + w580 * w678 + w581 * w679 - w582 * w677 - w583 * w680 + w71 * w696
    w698 = w620 * w689 + w615 * w690 + w609 * w691 + w626 * w686 + w630 * w687 + w634 * w688 - w604 * w685 - w251 * w692
    w699 = w698 - w235 * w694 - w92 * w695
    w700 = w692 + (w683 * c64 + w638 * w678 + w639 * w679 - w641 * w677 - w575 * w680)
    w701 = w694 + (w682 * c64 + w643 * w678 + w645 * w679 - w646 * w677 - w573 * w680)
    w702 = w695 + (w681 * c64 + w648 * w678 + w649 * w679 - w650 * w677 - w564 * w680)
    w703 = w697 + w68 * w699 - w252 * w700 - w237 * w701 - w96 * w702
    w704 = w622 * w689 + w618 * w690 + w612 * w691 + w634 * w686 + w658 * w687 + w659 * w688 - w606 * w685 - w247 * w692
    w705 = w704 - w228 * w694 - w70 * w695
    w706 = w650 * w681 + w646 * w682 + w641 * w683 + w655 * w678 + w656 * w679 - w657 * w677 - w582 * w680 + w71 * w705
    w707 = w621 * w689 + w617 * w690 + w610 * w691 + w630 * w686 + w663 * w687 + w658 * w688 - w605 * w685 - w246 * w692
    w708 = w707 - w227 * w694 - w66 * w695
    w709 = w706 - w68 * w708 - w248 * w700 - w231 * w701 - w80 * w702
    w710 = w649 * w681 + w645 * w682 + w639 * w683 + w670 * w678 + w671 * w679 - w656 * w677 - w581 * w680 + w68 * w705
    w711 = w710 + w71 * w708 - w254 * w700 - w240 * w701 - w103 * w702
    w712 = w648 * w681 + w643 * w682 + w638 * w683 + w673 * w678 + w670 * w679 - w655 * w677 - w580 * w680 - w68 * w696
    w713 = w712 + w71 * w699 - w256 * w700 - w242 * w701 - w108 * w702
    w714 = w100 * w703 + w85 * w709 - w105 * w711 - w110 * w713
    w715 = w307 * w705 - w306 * w696 - w308 * w708 + w309 * w699
    w716 = w559 - (w494 * w675 + w373 * w714) + (w495 * (w307 * w661 - w306 * w624 - w308 * w665 + w309 * w636) + w374 * w715)
    w717 = w282 * w521 + w283 * w522 + w284 * w523 - w281 * w524
    w718 = w147 * w525 - w151 * w544 + w155 * w547 - w55 * w528
    w719 = w716 + (w496 * (w282 * w452 + w283 * w459 + w284 * w465 - w281 * w467) + w375 * w717) + (w498 * (w147 * w468 - w151 * w538 + w155 * w542 - w55 * w480) + w377 * w718)
    w720 = w85 * w494
    w721 = w110 * w494
    w722 = w105 * w494
    w723 = w100 * w494
    w724 = w80 * w720 - (w108 * w721 + w103 * w722) + w96 * w723
    w725 = w231 * w720 - (w242 * w721 + w240 * w722) + w237 * w723
    w726 = w248 * w720 - (w256 * w721 + w254 * w722) + w252 * w723
    w727 = w71 * w722
    w728 = w308 * w495
    w729 = w68 * w720
    w730 = w727 - w728 + w729
    w731 = w307 * w495
    w732 = w68 * w722
    w733 = w71 * w720
    w734 = w731 + w732 - w733
    w735 = w309 * w495
    w736 = w71 * w721
    w737 = w68 * w723
    w738 = w735 + w736 - w737
    w739 = w306 * w495
    w740 = w68 * w721
    w741 = w71 * w723
    w742 = w739 + w740 + w741
    w743 = w724 - (w66 * w730 + w70 * w734) - w92 * w738 + w89 * w742
    w744 = w725 - (w227 * w730 + w228 * w734) - w235 * w738 + w234 * w742
    w745 = w726 - (w246 * w730 + w247 * w734) - w251 * w738 + w250 * w742
    w746 = w610 * w730 + w612 * w734 + w609 * w738 + w745 * c74 - w599 * w742
    w747 = w630 * w730 + w634 * w734 + w626 * w738 + w620 * w743 + w615 * w744 + w609 * w745 - w604 * w742 - w251 * w746
    w748 = w617 * w730 + w618 * w734 + w615 * w738 + w744 * c74 - w597 * w742
    w749 = w621 * w730 + w622 * w734 + w620 * w738 + w743 * c74 - w588 * w742
    w750 = w747 - w235 * w748 - w92 * w749
    w751 = w607 * w742 - (w605 * w730 + w606 * w734 + w604 * w738 + w588 * w743 + w597 * w744 + w599 * w745)
    w752 = w751 + w250 * w746 + w234 * w748 + w89 * w749
    w753 = w582 * w720 - (w580 * w721 + w581 * w722) - w564 * w724 - w573 * w725 - w575 * w726 - w68 * w750 + w71 * w752
    w754 = w746 + (w638 * w721 + w639 * w722 - w641 * w720 + w726 * c64) - w575 * w723
    w755 = w748 + (w643 * w721 + w645 * w722 - w646 * w720 + w725 * c64) - w573 * w723
    w756 = w749 + (w648 * w721 + w649 * w722 - w650 * w720 + w724 * c64) - w564 * w723
    w757 = w753 + w583 * w723 + w252 * w754 + w237 * w755 + w96 * w756
    w758 = w658 * w730 + w659 * w734 + w634 * w738 + w622 * w743 + w618 * w744 + w612 * w745 - w606 * w742 - w247 * w746
    w759 = w758 - w228 * w748 - w70 * w749
    w760 = w663 * w730 + w658 * w734 + w630 * w738 + w621 * w743 + w617 * w744 + w610 * w745 - w605 * w742 - w246 * w746
    w761 = w760 - w227 * w748 - w66 * w749
    w762 = w670 * w721 + w671 * w722 - w656 * w720 + w649 * w724 + w645 * w725 + w639 * w726 + w68 * w759 + w71 * w761
    w763 = w762 - w581 * w723 - w254 * w754 - w240 * w755 - w103 * w756
    w764 = w673 * w721 + w670 * w722 - w655 * w720 + w648 * w724 + w643 * w725 + w638 * w726 + w71 * w750 + w68 * w752
    w765 = w764 - w580 * w723 - w256 * w754 - w242 * w755 - w108 * w756
    w766 = w657 * w720 - (w655 * w721 + w656 * w722) - w650 * w724 - w646 * w725 - w641 * w726 - w71 * w759 + w68 * w761
    w767 = w766 + w582 * w723 + w248 * w754 + w231 * w755 + w80 * w756
    w768 = w151 * w498
    w769 = w52 * w482
    w770 = w51 * w486
    w771 = w768 + w769 + w770
    w772 = w281 * w496
    w773 = w155 * w498
    w774 = w51 * w482
    w775 = w52 * w486
    w776 = w773 + w774 - w775
    w777 = w55 * w498
    w778 = w51 * w484
    w779 = w3 * w52
    w780 = w777 + w778 + w779
    w781 = w147 * w498
    w782 = w52 * w484
    w783 = w3 * w51
    w784 = w781 - w782 + w783
    w785 = w124 * w771 - (w772 + w141 * w776) - w136 * w780 - w145 * w784
    w786 = w284 * w496
    w787 = w786 + w136 * w776 - w145 * w771 - w141 * w780 - w124 * w784
    w788 = w283 * w496
    w789 = w788 - w145 * w776 - w136 * w771 - w124 * w780 + w141 * w784
    w790 = w282 * w496
    w791 = w790 + w124 * w776 + w141 * w771 - w145 * w780 + w136 * w784
    w792 = w346 * w482 - w348 * w484 - w344 * w486 + w3 * w341
    w793 = w153 * w776 - w149 * w771 - w158 * w780 + w131 * w784 + w792
    w794 = w356 * w482 - w358 * w484 - w354 * w486 + w3 * w352
    w795 = w178 * w776 - w175 * w771 - w180 * w780 + w169 * w784 + w794
    w796 = w33 * w482 - w35 * w484 - w38 * w486 + w3 * w31
    w797 = w191 * w776 - w189 * w771 - w193 * w780 + w184 * w784 + w796
    w798 = w448 * w785 + w449 * w787 + w450 * w789 + w451 * w791 + w434 * w793 + w422 * w795 + w403 * w797
    w799 = w456 * w785 + w457 * w787 + w458 * w789 + w450 * w791 + w433 * w793 + w421 * w795 + w401 * w797
    w800 = w463 * w785 + w464 * w787 + w457 * w789 + w449 * w791 + w432 * w793 + w420 * w795 + w397 * w797
    w801 = w466 * w785 + w463 * w787 + w456 * w789 + w448 * w791 + w431 * w793 + w418 * w795 + w393 * w797
    w802 = w431 * w785 + w432 * w787 + w433 * w789 + w434 * w791 + w793 * c12
    w803 = w418 * w785 + w420 * w787 + w421 * w789 + w422 * w791 + w795 * c12
    w804 = w441 * w776 - w442 * w771 - w440 * w780 + w443 * w784 + w131 * w802 + w429 * w792 + w169 * w803 + w414 * w794
    w805 = w393 * w785 + w397 * w787 + w401 * w789 + w403 * w791 + w797 * c12
    w806 = w804 + w136 * w798 + w141 * w799 - w124 * w800 - w145 * w801 + w184 * w805 + w387 * w796
    w807 = w536 * w771 - w535 * w776 + w478 * w780 - w442 * w784 - w149 * w802 - w428 * w792 - w175 * w803 - w413 * w794
    w808 = w807 + w141 * w798 - w136 * w799 - w145 * w800 + w124 * w801 - w189 * w805 - w385 * w796
    w809 = w540 * w776 - w535 * w771 - w474 * w780 + w441 * w784 + w153 * w802 + w427 * w792 + w178 * w803 + w412 * w794
    w810 = w809 + w124 * w798 - w145 * w799 + w136 * w800 - w141 * w801 + w191 * w805 + w381 * w796
    w811 = w478 * w771 - w474 * w776 + w470 * w780 - w440 * w784 - w158 * w802 - w426 * w792 - w180 * w803 - w410 * w794
    w812 = w811 - w145 * w798 - w124 * w799 - w141 * w800 - w136 * w801 - w193 * w805 - w49 * w796
    w813 = w718 + hinge0_angle_ddot * (w147 * w806 + w151 * w808 + w155 * w810 + w55 * w812)
    w814 = w813 / w222
    w815 = w717 + hinge0_angle_ddot * (w282 * w798 + w283 * w799 + w284 * w800 - w281 * w801) - w289 * w814
    w816 = w815 / w294
    w817 = w715 + hinge0_angle_ddot * (w307 * w759 - w308 * w761 + w309 * w750 + w306 * w752) - w319 * w816 - w314 * w814
    w818 = w817 / w324
    w819 = hinge0_angle_ddot * (w100 * w757 + w105 * w763 + w110 * w765 + w85 * w767) - w714 + w302 * w816 + w332 * w818
    w820 = w819 + w273 * w814
    w821 = w820 / w337
    w822 = w338 * w821 - (w295 * w816 + w325 * w818 + w223 * w814)
    w823 = w484 * w822
    w824 = w802 + (w427 * w776 - w428 * w771 - w426 * w780 + w429 * w784) + w792 * c11
    w825 = w823 - (w484 * w519 + w485 * w824)
    w826 = w351 * w821 - (w297 * w816 + w327 * w818 + w245 * w814)
    w827 = w484 * w826
    w828 = w803 + (w412 * w776 - w413 * w771 - w410 * w780 + w414 * w784) + w794 * c11
    w829 = w827 - (w484 * w515 + w485 * w828)
    w830 = w482 * w826
    w831 = w482 * w515 + w483 * w828 - w830
    w832 = w486 * w826
    w833 = w832 - (w486 * w515 + w487 * w828)
    w834 = w3 * w826
    w835 = w3 * w515 + w488 * w828 - w834
    w836 = w482 * w822
    w837 = w482 * w519 + w483 * w824 - w836
    w838 = w486 * w822
    w839 = w838 - (w486 * w519 + w487 * w824)
    w840 = w3 * w822
    w841 = w3 * w519 + w488 * w824 - w840
    w842 = w5 * w825 - (w16 * w829 + w4 * w831 + w7 * w833 + w10 * w835) + w20 * w837 + w4 * w839 + w16 * w841
    w843 = w842 * c10
    w844 = w493 * w821
    w845 = w492 * w821
    w846 = w491 * w821
    w847 = w490 * w821
    w848 = w820 * (w494 / w337) + w844 * (w367 / w337) + w361 / w337 * w845 + w351 / w337 * w846 + w338 / w337 * w847
    w849 = w848 / (2 * w337)
    w850 = w844 / w337 - 2 * w336 * w849
    w851 = w845 / w337 - w849 * (2 * w335)
    w852 = w846 / w337 - w849 * (2 * w334)
    w853 = w847 / w337 - w849 * (2 * w333)
    w854 = w494 * w818 - w331 * w850 - w329 * w851 - w327 * w852 - w325 * w853
    w855 = w850 + w331 * w854
    w856 = w851 + w329 * w854
    w857 = w852 + w327 * w854
    w858 = w853 + w325 * w854
    w859 = w494 * w816 - w301 * w855 - w299 * w856 - w297 * w857 - w295 * w858
    w860 = w855 + w301 * w859
    w861 = w856 + w299 * w859
    w862 = w857 + w297 * w859
    w863 = w858 + w295 * w859
    w864 = w494 * w814 - w272 * w860 - w259 * w861 - w245 * w862 - w223 * w863
    w865 = w330 * w854 - (w493 * w818 + w332 * w850)
    w866 = w328 * w854 - (w492 * w818 + w332 * w851)
    w867 = w326 * w854 - (w491 * w818 + w332 * w852)
    w868 = w303 * w854 - (w490 * w818 + w332 * w853)
    w869 = w817 * (w495 / w324) + w865 * (w331 / w324) + w329 / w324 * w866 + w327 / w324 * w867 + w325 / w324 * w868
    w870 = w869 / (2 * w324)
    w871 = w865 / w324 - 2 * w323 * w870
    w872 = w866 / w324 - w870 * (2 * w322)
    w873 = w867 / w324 - w870 * (2 * w321)
    w874 = w868 / w324 - w870 * (2 * w320)
    w875 = w495 * w816 + w301 * w871 + w299 * w872 + w297 * w873 + w295 * w874
    w876 = w871 - w301 * w875
    w877 = w872 - w299 * w875
    w878 = w873 - w297 * w875
    w879 = w874 - w295 * w875
    w880 = w495 * w814 + w272 * w876 + w259 * w877 + w245 * w878 + w223 * w879
    w881 = w300 * w859 - (w493 * w816 + w302 * w855 + w319 * w871 + w318 * w875)
    w882 = w298 * w859 - (w492 * w816 + w302 * w856 + w319 * w872 + w317 * w875)
    w883 = w296 * w859 - (w491 * w816 + w302 * w857 + w319 * w873 + w316 * w875)
    w884 = w274 * w859 - (w490 * w816 + w319 * w874 + w315 * w875 + w302 * w858)
    w885 = w815 * (w496 / w294) + w881 * (w301 / w294) + w299 / w294 * w882 + w297 / w294 * w883 + w295 / w294 * w884
    w886 = w885 / (2 * w294)
    w887 = w881 / w294 - 2 * w293 * w886
    w888 = w882 / w294 - w886 * (2 * w292)
    w889 = w883 / w294 - w886 * (2 * w291)
    w890 = w884 / w294 - w886 * (2 * w290)
    w891 = w496 * w814 + w272 * w887 + w259 * w888 + w245 * w889 + w223 * w890
    w892 = w271 * w864 - (w493 * w814 + w314 * w876 + w313 * w880 + w273 * w860 + w289 * w887 + w288 * w891)
    w893 = w258 * w864 - (w492 * w814 + w314 * w877 + w312 * w880 + w273 * w861 + w289 * w888 + w287 * w891)
    w894 = w244 * w864 - (w491 * w814 + w314 * w878 + w311 * w880 + w273 * w862 + w289 * w889 + w286 * w891)
    w895 = w111 * w864 - (w490 * w814 + w314 * w879 + w310 * w880 + w289 * w890 + w285 * w891 + w273 * w863)
    w896 = w813 * (w498 / w222) + w892 * (w272 / w222) + w259 / w222 * w893 + w245 / w222 * w894 + w223 / w222 * w895
    w897 = w896 / (2 * w222)
    w898 = w892 / w222 - 2 * w221 * w897
    w899 = w893 / w222 - w897 * (2 * w195)
    w900 = w894 / w222 - w897 * (2 * w182)
    w901 = w895 / w222 - w897 * (2 * w160)
    w902 = w498 * w547 + w499 * w810 + w219 * w898 + w192 * w899 + w179 * w900 + w154 * w901
    w903 = w499 * w808 - w498 * w544 - w218 * w898 - w190 * w899 - w176 * w900 - w150 * w901
    w904 = w361 * w821 - (w299 * w816 + w329 * w818 + w259 * w814)
    w905 = w3 * w904
    w906 = w805 + (w381 * w776 - w385 * w771 - w49 * w780 + w387 * w784) + w796 * c11
    w907 = w3 * w511 - w905 + w488 * w906
    w908 = w486 * w904
    w909 = w908 - w486 * w511 - w487 * w906
    w910 = w484 * w904
    w911 = w910 - w484 * w511 - w485 * w906
    w912 = w482 * w904
    w913 = w482 * w511 - w912 + w483 * w906
    w914 = w10 * w907 - (w7 * w825 + w5 * w837 + w8 * w839 + w4 * w841) + w7 * w909 + w16 * w911 + w4 * w913
    w915 = w914 * c10
    w916 = w482 * (hinge0_angle_ddot * w481) * c137
    w917 = w486 * w487
    w918 = w2 * hinge0_angle_ddot
    w919 = w481 * w918 * c146
    w920 = w482 * w918 * c140
    w921 = w481 * (w481 * (bar1_e1 * hinge0_angle_ddot)) * c112 - w549 * w916 + w531 * w917 + w529 * w919 + (w16 * w917 + w7 * w919 - w10 * w920) * c9
    w922 = hinge0_angle_ddot * (w2 * w3) * c140
    w923 = w481 * w488 * c137
    w924 = 2 * (bar1_e3 * w843) - w53 * w902 + w54 * w903 + 2 * (bar1_e2 * w915) + (w921 - w339 * w829 + w339 * w841 - w30 * w907 + w29 * w911 - w11 * w922 - w6 * w923) * -2.0
    w925 = w3 * w488
    w926 = w482 * w488 * c136
    w927 = w924 + 2 * (w30 * w833 - w29 * w839 + w9 * w925 + (w8 * w925 - w4 * w922 - w5 * w923 + w7 * w926) * c8)
    w928 = w498 * w525 + w499 * w806 + w217 * w898 + w188 * w899 + w174 * w900 + w146 * w901
    w929 = w499 * w812 - w498 * w528 - w220 * w898 + w194 * w899 + w181 * w900 + w159 * w901
    w930 = w482 * w483
    w931 = w549 * w930 + (w4 * w930 - w16 * w916) * c6 + w530 * w917 + (w4 * w917 + w5 * w919 - w7 * w920) * c8
    w932 = w931 - w529 * w920 - w339 * w831 + w30 * w835 + w339 * w839 - w29 * w841 - w30 * w909 + w29 * w913
    w933 = w932 + w11 * w925 - w9 * w922 + (w4 * w925 - w16 * w922 - w7 * w923 + w10 * w926) * c9 + w6 * w926
    w934 = w482 * w927 - w484 * (2 * -(bar1_e2 * w843) + w54 * w928 + w53 * w929 + 2 * (bar1_e3 * w915) + 2 * w933)
    w935 = (w7 * w829 + w5 * w831 + w8 * w833 + w4 * w835 - w16 * w907 - w4 * w909 - w5 * w911 - w20 * w913) * c147
    w936 = w551 * w930 + (w10 * w930 - w7 * w916) * c9 - w531 * w920 - w339 * w835 + w29 * w907 + w11 * w926
    w937 = w481 * (w481 * (bar1_e2 * hinge0_angle_ddot)) * c113 - w550 * w916 + w530 * w919 + w30 * w831 + w339 * w825
    w938 = w937 - w29 * w837 - w30 * w911 + w6 * w925 - w9 * w923 + (w5 * w925 - w20 * w922 - w16 * w923 + w4 * w926) * c6
    w939 = w934 - w486 * (w54 * w902 - w4 * w843 + w53 * w903 + w10 * w935 + w8 * w915 + 2 * w936 + w938 * -2.0)
    w940 = 2 * (w529 * w917 + (w20 * w917 + w16 * w919 - w4 * w920) * c6 + w339 * w837 - w30 * w913 - w6 * w922)
    w941 = w481 * (w481 * (bar1_e3 * hinge0_angle_ddot)) * c114 - w551 * w916 + w550 * w930 + (w7 * w930 - w5 * w916) * c8
    w942 = w941 + w531 * w919 - w530 * w920 + w30 * w829 - w339 * w833 - w29 * w825 + w29 * w909 - w11 * w923
    w943 = w3 * (w8 * w843 - w53 * w928 + w54 * w929 + w20 * w935 + w4 * w915 + w940 + (w942 + w9 * w926) * -2.0)
    w944 = w887 - w272 * w891
    w945 = w888 - w259 * w891
    w946 = w889 - w245 * w891
    w947 = w890 - w223 * w891
    w948 = w496 * w523 + w505 * w800 + w215 * w944 - w183 * w945 - w166 * w946 - w121 * w947
    w949 = w496 * w522 + w505 * w799 + w214 * w944 - w186 * w945 - w172 * w946 - w139 * w947
    w950 = w496 * w521 + w505 * w798 + w213 * w944 - w185 * w945 - w171 * w946 - w135 * w947
    w951 = w187 * w945 - (w496 * w524 + w505 * w801 + w216 * w944) + w173 * w946 + w144 * w947
    w952 = w501 * w776
    w953 = w502 * w771
    w954 = w502 * w776 + w501 * w771
    w955 = w500 * w771 + w502 * w780
    w956 = w500 * w776 + w501 * w780
    w957 = w471 * w952 + w476 * w953 - w475 * w954 + (w45 * w953 - w156 * w954 + w43 * w955) * c27 + (w45 * w952 - w40 * w956) * c25
    w958 = w503 * w784
    w959 = w503 * w771 + w502 * w784
    w960 = w503 * w776 + w501 * w784
    w961 = w503 * w780 + w500 * w784
    w962 = w957 + w439 * w958 - w438 * w959 + w437 * w960 + (w45 * w958 - w40 * w959 + w125 * w960 - w156 * w961) * c28
    w963 = w516 * w784 + w503 * w792
    w964 = w516 * w771 + w502 * w792
    w965 = w512 * w784 + w503 * w794
    w966 = w512 * w776 + w501 * w794
    w967 = w489 * w771 + w502 * w796
    w968 = w489 * w776 + w501 * w796
    w969 = w51 * w912 - w52 * w908 + w155 * w899
    w970 = w510 * w776 + w501 * w805 - w969
    w971 = w962 - w42 * w963 - w408 * w964 + w47 * w965 - w408 * w966 + w47 * w967 + w42 * w968 + w129 * w970
    w972 = w52 * w912 + w51 * w908 + w151 * w899
    w973 = w972 - (w510 * w771 + w502 * w805)
    w974 = w51 * w830 - w52 * w832 + w155 * w900
    w975 = w514 * w776 + w501 * w803 - w974
    w976 = w51 * w834 - w52 * w827 + w147 * w900
    w977 = w514 * w784 + w503 * w803 - w976
    w978 = w52 * w836 + w51 * w838 + w151 * w901
    w979 = w978 - (w518 * w771 + w502 * w802)
    w980 = w51 * w840 - w52 * w823 + w147 * w901
    w981 = w518 * w784 + w503 * w802 - w980
    w982 = w278 * w948 + w279 * w949 + w280 * w950 + w276 * w951 + 2 * (w971 - w167 * w973 - w127 * w975 + w167 * w977 + w127 * w979 - w129 * w981)
    w983 = w516 * w776 + w501 * w792
    w984 = w516 * w780 + w500 * w792
    w985 = w512 * w771 + w502 * w794
    w986 = w512 * w780 + w500 * w794
    w987 = w40 * w963 - w45 * w964 + w152 * w983 - w43 * w984 - w125 * w965 + w156 * w985 - w45 * w966 + w40 * w986
    w988 = w51 * w823 + w52 * w840 + w55 * w901
    w989 = w988 - (w518 * w780 + w500 * w802)
    w990 = w51 * w827 + w52 * w834 + w55 * w900
    w991 = w990 - (w514 * w780 + w500 * w803)
    w992 = w52 * w830 + w51 * w832 + w151 * w900
    w993 = w992 - (w514 * w771 + w502 * w803)
    w994 = w51 * w836 - w52 * w838 + w155 * w901
    w995 = w518 * w776 + w501 * w802 - w994
    w996 = w43 * w989 - (w40 * w991 + w45 * w975 + w156 * w993 + w125 * w977) + w152 * w995 + w45 * w979 + w40 * w981
    w997 = w987 * c14 + w996 * c15
    w998 = w51 * w910 + w52 * w905 + w55 * w899
    w999 = w998 - (w510 * w780 + w500 * w805)
    w1000 = w51 * w905 - w52 * w910 + w147 * w899
    w1001 = w510 * w784 + w503 * w805 - w1000
    w1002 = w156 * w991 - (w43 * w999 + w152 * w970 + w45 * w973 + w40 * w1001) + w43 * w975 + w44 * w993 + w45 * w977
    w1003 = w489 * w784 + w503 * w796
    w1004 = w489 * w780 + w500 * w796
    w1005 = w45 * w965 - w44 * w985 + w43 * w966 - w156 * w986 - w40 * w1003 + w45 * w967 - w152 * w968 + w43 * w1004
    w1006 = w1002 * c15 + w1005 * c14
    w1007 = w777 + (w778 + w779)
    w1008 = w438 * w958 + (w44 * w958 - w45 * w959 + w156 * w960 - w43 * w961) * c27 + w42 * w964 - w47 * w985
    w1009 = w279 * w950 - (w276 * w948 + w280 * w949) + w278 * w951 + 2 * (w1008 + w167 * w993 - w129 * w979)
    w1010 = w40 * w999 + w45 * w970 + w156 * w973 + w125 * w1001 - w156 * w989 - w43 * w995 - w44 * w979 - w45 * w981
    w1011 = w44 * w964 - w45 * w963 - w43 * w983 + w156 * w984 + w125 * w1003 - w156 * w967 + w45 * w968 - w40 * w1004
    w1012 = 2 * -(w1010 * c15 + w1011 * c14)
    w1013 = w477 * w953 + (w40 * w953 - w125 * w954 + w156 * w955) * c28 + w475 * w955 - w471 * w956 + w780 * (bar2_e1 * w500) * c115
    w1014 = w1013 - w439 * w959 - w437 * w961 + w408 * w963 + w408 * w986 - w47 * w1003 + w129 * w999 - w167 * w1001
    w1015 = w1009 + w45 * w997 + 2 * (bar2_e2 * w1006) + w44 * w1012 + (w1014 - w127 * w991 + w127 * w981 - w42 * w1004) * -2.0
    w1016 = w773 + (w774 - w775)
    w1017 = w473 * w952 - w477 * w954 + (w125 * w952 - w156 * w956) * c28 + w439 * w960 - w408 * w965 + w42 * w1003
    w1018 = w280 * w948 - w276 * w949 - w278 * w950 + w279 * w951 + 2 * (w1017 + w129 * w1001 - w127 * w977) + 2 * (bar2_e3 * w997)
    w1019 = w476 * w955 - w472 * w956 + w780 * (bar2_e2 * w500) * c116 + w437 * w958 - w438 * w961 + (w43 * w958 - w152 * w959 + w45 * w960 - w40 * w961) * c25
    w1020 = w1019 - w42 * w983 - w408 * w984 + w47 * w966 - w167 * w999 + w167 * w975 + w127 * w989 - w129 * w995
    w1021 = w768 + (w769 + w770)
    w1022 = w939 + w943 - (w982 + 2 * (bar2_e1 * w997) + 2 * -(bar2_e3 * w1006)) * w1007 + w1015 * w1016 - (w1018 + w44 * w1006 + (w1020 + w47 * w1004) * -2.0) * w1021
    w1023 = (w156 * w952 - w43 * w956) * c27 + (w472 * w952 - w476 * w954 + w477 * w955 - w473 * w956 + w780 * (bar2_e3 * w500) * c117)
    w1024 = w1023 + w438 * w960 - w439 * w961 + w42 * w984 + w408 * w985 - w47 * w986 - w42 * w967 + w129 * w973
    w1025 = w278 * w949 - w279 * w948 - w276 * w950 + w280 * w951 + (w1024 + w167 * w991 - w127 * w993 - w129 * w989) * -2.0
    w1026 = w475 * w953 + (w152 * w953 - w45 * w954 + w40 * w955) * c25 - w437 * w959 + w408 * w983 - w47 * w968
    w1027 = w781 + (w783 - w782)
    w1028 = (w1025 + 2 * (w1026 - w167 * w970 + w127 * w995) + w125 * w997 - w45 * w1006 + w152 * w1012) * w1027
    w1029 = w876 - w272 * w880
    w1030 = w860 + w272 * w864
    w1031 = w105 * w1030
    w1032 = w85 * w1030
    w1033 = w307 * w1029 - w68 * w1031 + w71 * w1032
    w1034 = w308 * w1029 + w71 * w1031 + w68 * w1032
    w1035 = w110 * w1030
    w1036 = w100 * w1030
    w1037 = w309 * w1029 - w71 * w1035 + w68 * w1036
    w1038 = w68 * w1035 - w306 * w1029 + w71 * w1036
    w1039 = w57 * w1033 - w61 * w1034 + w90 * w1037 + w58 * w1038
    w1040 = w367 * w821 - (w301 * w816 + w331 * w818 + w272 * w814)
    w1041 = w482 * w1040
    w1042 = w486 * w1040
    w1043 = w52 * w1041 + w51 * w1042 + w151 * w898
    w1044 = w484 * w1040
    w1045 = w3 * w1040
    w1046 = w51 * w1044 + w52 * w1045 + w55 * w898
    w1047 = w51 * w1041 - w52 * w1042 + w155 * w898
    w1048 = w51 * w1045 - w52 * w1044 + w147 * w898
    w1049 = w124 * w1043 - (w281 * w944 + w136 * w1046 + w141 * w1047) - w145 * w1048
    w1050 = w284 * w944 - w141 * w1046 + w136 * w1047 - w145 * w1043 - w124 * w1048
    w1051 = w283 * w944 - w124 * w1046 - w145 * w1047 - w136 * w1043 + w141 * w1048
    w1052 = w282 * w944 - w145 * w1046 + w124 * w1047 + w141 * w1043 + w136 * w1048
    w1053 = w142 * w1049 + w116 * w1050 + w138 * w1051 + w118 * w1052
    w1054 = w1039 - w1053
    w1055 = w132 * w1049 + w118 * w1050 + w142 * w1051 + w117 * w1052
    w1056 = w90 * w1033 - w58 * w1034 + w86 * w1037 + w197 * w1038
    w1057 = w1055 - w1056
    w1058 = w205 * w1054 + w198 * w1057
    w1059 = w513 * w791 + w509 * w795
    w1060 = w513 * w789 + w508 * w795
    w1061 = w513 * w787 + w507 * w795
    w1062 = w513 * w785 + w506 * w795
    w1063 = w504 * w791 + w509 * w797
    w1064 = w504 * w789 + w508 * w797
    w1065 = w504 * w787 + w507 * w797
    w1066 = w118 * w1059 + w138 * w1060 + w116 * w1061 + w142 * w1062 - w132 * w1063 - w118 * w1064 - w112 * w1065
    w1067 = w504 * w785 + w506 * w797
    w1068 = w281 * w946 + w136 * w990 + w141 * w974 - w124 * w992 + w145 * w976
    w1069 = w281 * w945 + w136 * w998 + w141 * w969 - w124 * w972 + w145 * w1000
    w1070 = w124 * w998 - w283 * w945 + w145 * w969 + w136 * w972 - w141 * w1000
    w1071 = w145 * w998 - w282 * w945 - w124 * w969 - w141 * w972 - w136 * w1000
    w1072 = w141 * w998 - w284 * w945 - w136 * w969 + w145 * w972 + w124 * w1000
    w1073 = w124 * w990 - w283 * w946 + w145 * w974 + w136 * w992 - w141 * w976
    w1074 = w145 * w990 - w282 * w946 - w124 * w974 - w141 * w992 - w136 * w976
    w1075 = w142 * w1068 - (w116 * w1069 + w118 * w1070 + w132 * w1071 + w112 * w1072) + w138 * w1073 + w118 * w1074
    w1076 = w141 * w990 - w284 * w946 - w136 * w974 + w145 * w992 + w124 * w976
    w1077 = (w1066 - w116 * w1067) * c21 + (w1075 + w116 * w1076) * c63
    w1078 = w116 * w1049 + w112 * w1050 + w118 * w1051 + w132 * w1052
    w1079 = w58 * w1033 - w56 * w1034 + w61 * w1037 + w86 * w1038
    w1080 = w1078 - w1079
    w1081 = w1056 - w1055
    w1082 = w205 * w1080 + w202 * w1081
    w1083 = w1077 - w1082
    w1084 = w507 * w787
    w1085 = w507 * w785 + w506 * w787
    w1086 = w508 * w789
    w1087 = w508 * w787 + w507 * w789
    w1088 = w508 * w785 + w506 * w789
    w1089 = w460 * w1084 + (w118 * w1084 + w132 * w1085) * c31 + w454 * w1086 + w453 * w1087 + (w118 * w1086 + w142 * w1087 + w116 * w1088) * c33
    w1090 = w509 * w791
    w1091 = w509 * w789 + w508 * w791
    w1092 = w509 * w787 + w507 * w791
    w1093 = w509 * w785 + w506 * w791
    w1094 = w1089 + w447 * w1090 + w446 * w1091 + w445 * w1092 + (w118 * w1090 + w132 * w1091 + w117 * w1092 + w142 * w1093) * c34
    w1095 = w517 * w791 + w509 * w793
    w1096 = w517 * w789 + w508 * w793
    w1097 = w1094 - w390 * w1095 + w416 * w1096 + w391 * w1059 - w416 * w1061 - w391 * w1064 + w390 * w1065 + w204 * w1050
    w1098 = w124 * w988 - w283 * w947 + w145 * w994 + w136 * w978 - w141 * w980
    w1099 = w1097 + w209 * w1051 + w212 * w1052 - w164 * w1070 + w120 * w1072 + w164 * w1074 - w115 * w1076 + w115 * w1098
    w1100 = w145 * w988 - w282 * w947 - w124 * w994 - w141 * w978 - w136 * w980
    w1101 = w517 * w787 + w507 * w793
    w1102 = w517 * w785 + w506 * w793
    w1103 = w117 * w1063 - (w118 * w1095 + w138 * w1096 + w116 * w1101 + w142 * w1102) + w142 * w1064 + w118 * w1065
    w1104 = w281 * w947 + w136 * w988 + w141 * w994 - w124 * w978 + w145 * w980
    w1105 = w132 * w1069 + w142 * w1070 + w117 * w1071 + w118 * w1072 - w142 * w1104 - w138 * w1098 - w118 * w1100
    w1106 = w141 * w988 - w284 * w947 - w136 * w994 + w145 * w978 + w124 * w980
    w1107 = (w1103 + w132 * w1067) * c21 + (w1105 - w116 * w1106) * c63
    w1108 = 2 * (bar3_e3 * w1058) + 2 * (bar3_e2 * w1083) + 2 * (w1099 - w120 * w1100) + 2 * -(bar3_e1 * w1107)
    w1109 = w1077 + w1082
    w1110 = w446 * w1090 + (w138 * w1090 + w118 * w1091 + w142 * w1092 + w116 * w1093) * c33 - w390 * w1096 + w391 * w1060
    w1111 = 2 * (bar3_e2 * w1058) + 2 * (bar3_e3 * w1109) + 2 * (w1110 + w212 * w1051 + w164 * w1073 - w120 * w1098)
    w1112 = w785 * (bar3_e1 * w506) * c118 + w460 * w1085 + w455 * w1086 + (w132 * w1086 + w117 * w1087 + w142 * w1088) * c34
    w1113 = w1112 + w453 * w1088 + w447 * w1091 + w445 * w1093 + w416 * w1095 - w416 * w1062 - w391 * w1063 + w390 * w1067
    w1114 = (w1113 + w204 * w1049 + w209 * w1052 + w120 * w1069 - w164 * w1071 - w115 * w1068 + w115 * w1100) * -2.0
    w1115 = w132 * w1095 + w118 * w1096 + w112 * w1101 + w116 * w1102 - w117 * w1059 - w142 * w1060 - w118 * w1061
    w1116 = w116 * w1104 - (w132 * w1068 + w142 * w1073 + w117 * w1074 + w118 * w1076) + w118 * w1098 + w132 * w1100
    w1117 = (w1115 - w132 * w1062) * c21 + (w1116 + w112 * w1106) * c63
    w1118 = (w1111 + w1114 - w118 * w1107 + w138 * (2 * -w1117)) * (w786 + (w136 * w1016 - w141 * w1007 - w145 * w1021 - w124 * w1027))
    w1119 = w1022 + w1028 + w1108 * (w124 * w1021 - (w136 * w1007 + w141 * w1016) - w145 * w1027 - w772) + w1118
    w1120 = w462 * w1084 + (w117 * w1084 + w142 * w1085) * c34 + w455 * w1087 + w447 * w1092 - w416 * w1059 + w390 * w1063
    w1121 = w138 * w1058 + 2 * (w1120 + w204 * w1052 + w120 * w1071 - w115 * w1074) + w118 * w1083 + 2 * (bar3_e3 * w1107)
    w1122 = w785 * (bar3_e2 * w506) * c119 + w461 * w1085 + w454 * w1088 + w445 * w1090 + w446 * w1093 + (w116 * w1090 + w112 * w1091 + w118 * w1092 + w132 * w1093) * c31
    w1123 = w1122 - w390 * w1101 + w416 * w1102 + w391 * w1061 - w391 * w1067 + w209 * w1049 + w212 * w1050 - w164 * w1069
    w1124 = w1053 - w1039
    w1125 = w1079 - w1078
    w1126 = w202 * w1124 + w198 * w1125
    w1127 = w1121 + (w1123 + w164 * w1076 + w115 * w1104 - w120 * w1106) * -2.0 + w117 * (2 * -(w1117 + w1126))
    w1128 = w785 * (bar3_e3 * w506) * c120 + w461 * w1084 + w462 * w1085 + (w142 * w1084 + w116 * w1085) * c33
    w1129 = w1128 + w454 * w1087 + w455 * w1088 + w446 * w1092 + w447 * w1093 - w390 * w1102 - w416 * w1060 + w391 * w1062
    w1130 = w1129 + w390 * w1064 + w212 * w1049 + w204 * w1051 + w120 * w1070 + w164 * w1068 - w115 * w1073 - w120 * w1104
    w1131 = w453 * w1086 + (w112 * w1086 + w118 * w1087 + w132 * w1088) * c31 + w445 * w1091 + w416 * w1101 - w391 * w1065
    w1132 = w112 * (2 * -w1126) + w118 * w1058 + w138 * w1109 + w1130 * -2.0 + w117 * w1107 + 2 * (w1131 + w209 * w1050 - w164 * w1072 + w115 * w1106)
    w1133 = w1119 + w1127 * (w788 + (w141 * w1027 - (w124 * w1007 + w145 * w1016 + w136 * w1021))) + w1132 * (w790 + (w124 * w1016 - w145 * w1007 + w141 * w1021 + w136 * w1027))
    w1134 = w207 * w1125 + w196 * w1057
    w1135 = w687 * w730
    w1136 = w688 * w734
    w1137 = w688 * w730 + w687 * w734
    w1138 = w686 * w734 + w688 * w738
    w1139 = w686 * w730 + w687 * w738
    w1140 = w627 * w1135 + w632 * w1136 + w631 * w1137 + (w58 * w1136 + w90 * w1137 + w61 * w1138) * c76 + (w58 * w1135 + w86 * w1139) * c73
    w1141 = w689 * w734 + w688 * w743
    w1142 = w690 * w730 + w687 * w744
    w1143 = w691 * w734 + w688 * w745
    w1144 = w691 * w730 + w687 * w745
    w1145 = w685 * w742
    w1146 = w685 * w734 + w688 * w742
    w1147 = w685 * w730 + w687 * w742
    w1148 = w1140 + w584 * w1141 - w584 * w1142 - w595 * w1143 + w586 * w1144 + w603 * w1145 - w602 * w1146 - w601 * w1147
    w1149 = w685 * w738 + w686 * w742
    w1150 = w685 * w744 + w690 * w742
    w1151 = w685 * w743 + w689 * w742
    w1152 = w1148 + (w58 * w1145 - w86 * w1146 - w197 * w1147 - w90 * w1149) * c77 - w595 * w1150 + w586 * w1151
    w1153 = w861 + w259 * w864
    w1154 = w105 * w1153
    w1155 = w877 - w259 * w880
    w1156 = w85 * w1153
    w1157 = w68 * w1154 - (w692 * w734 + w688 * w746 + w307 * w1155) - w71 * w1156
    w1158 = w308 * w1155 - (w692 * w730 + w687 * w746) + w71 * w1154 + w68 * w1156
    w1159 = w878 - w245 * w880
    w1160 = w862 + w245 * w864
    w1161 = w110 * w1160
    w1162 = w100 * w1160
    w1163 = w694 * w742 + w685 * w748 + w306 * w1159 - w68 * w1161 - w71 * w1162
    w1164 = w105 * w1160
    w1165 = w85 * w1160
    w1166 = w308 * w1159 - (w694 * w730 + w687 * w748) + w71 * w1164 + w68 * w1165
    w1167 = w1152 - w260 * w1034 + w261 * w1033 + w262 * w1038 - w225 * w1157 + w65 * w1158 + w225 * w1163 - w60 * w1166
    w1168 = w879 - w223 * w880
    w1169 = w863 + w223 * w864
    w1170 = w110 * w1169
    w1171 = w100 * w1169
    w1172 = w695 * w742 + w685 * w749 + w306 * w1168 - w68 * w1170 - w71 * w1171
    w1173 = w105 * w1169
    w1174 = w85 * w1169
    w1175 = w68 * w1173 - (w695 * w734 + w688 * w749 + w307 * w1168) - w71 * w1174
    w1176 = w689 * w730 + w687 * w743
    w1177 = w689 * w738 + w686 * w743
    w1178 = w691 * w738 + w686 * w745
    w1179 = w685 * w745 + w691 * w742
    w1180 = w90 * w1143 - (w57 * w1141 + w61 * w1176 + w90 * w1177) + w58 * w1144 + w86 * w1178 - w197 * w1179
    w1181 = w110 * w1153
    w1182 = w100 * w1153
    w1183 = w71 * w1181 - (w692 * w738 + w686 * w746 + w309 * w1155) - w68 * w1182
    w1184 = w692 * w742 + w685 * w746 + w306 * w1155 - w68 * w1181 - w71 * w1182
    w1185 = w71 * w1170 - (w695 * w738 + w686 * w749 + w309 * w1168) - w68 * w1171
    w1186 = w308 * w1168 - (w695 * w730 + w687 * w749) + w71 * w1173 + w68 * w1174
    w1187 = w86 * w1183 + w197 * w1184 + w90 * w1157 + w58 * w1158 - w90 * w1185 - w58 * w1172 - w57 * w1175 - w61 * w1186
    w1188 = (w1180 + w58 * w1151) * c78 + w1187 * c55
    w1189 = w196 * w1054 + w200 * w1080
    w1190 = w1188 - w1189
    w1191 = w690 * w734 + w688 * w744
    w1192 = w690 * w738 + w686 * w744
    w1193 = w58 * w1141 + w56 * w1176 + w61 * w1177 - w90 * w1191 - w58 * w1142 - w86 * w1192 + w197 * w1150 - w86 * w1151
    w1194 = w71 * w1161 - (w694 * w738 + w686 * w748 + w309 * w1159) - w68 * w1162
    w1195 = w68 * w1164 - (w694 * w734 + w688 * w748 + w307 * w1159) - w71 * w1165
    w1196 = w61 * w1185 - (w86 * w1194 + w197 * w1163 + w90 * w1195 + w58 * w1166) + w86 * w1172 + w58 * w1175
    w1197 = w1193 * c78 + (w1196 + w56 * w1186) * c55
    w1198 = 2 * (bar4_e1 * w1134) + 2 * (w1167 - w65 * w1172 + w60 * w1175) + 2 * (bar4_e3 * w1190) + 2 * -(bar4_e2 * w1197)
    w1199 = w207 * w1124 + w200 * w1081
    w1200 = (w86 * w1136 + w197 * w1137 + w90 * w1138) * c77 + (w633 * w1136 + w738 * (bar4_e1 * w686) * c148)
    w1201 = w627 * w1139 + (w631 * w1138 + w1200) - w584 * w1192 + w586 * w1178 - w603 * w1146 - w601 * w1149
    w1202 = w1201 + w595 * w1179 - w584 * w1151 + w260 * w1037 + w261 * w1038 + w65 * w1183 - w225 * w1184 - w60 * w1194
    w1203 = w595 * w1191 - w586 * w1141 + w602 * w1145 + (w57 * w1145 - w58 * w1146 - w90 * w1147 - w61 * w1149) * c76
    w1204 = w57 * (2 * -w1199) + w58 * w1134 + (w1202 + w60 * w1172) * -2.0 + 2 * (w1203 + w262 * w1033 + w225 * w1195 - w65 * w1175)
    w1205 = w1188 + w1189
    w1206 = w1133 + w1198 * (w735 + (w736 - w737)) + (w1204 + 2 * (bar4_e2 * w1205) + 2 * (bar4_e3 * w1197)) * (w727 + w729 - w728)
    w1207 = w629 * w1135 + w633 * w1137 + (w197 * w1135 + w90 * w1139) * c77 - w603 * w1147 - w586 * w1179 + w584 * w1150
    w1208 = w57 * w1191 + w61 * w1142 + w90 * w1192 - w58 * w1143 - w56 * w1144 - w61 * w1178 + w86 * w1179 - w58 * w1150
    w1209 = w90 * w1194 - (w61 * w1183 + w86 * w1184 + w58 * w1157 + w56 * w1158) + w58 * w1163 + w57 * w1195
    w1210 = w1208 * c78 + (w1209 + w61 * w1166) * c55
    w1211 = 2 * (w1207 + w260 * w1038 + w65 * w1184 - w60 * w1163) + w197 * (2 * -w1210) + 2 * (bar4_e3 * w1134)
    w1212 = w628 * w1139 + (w632 * w1138 + w738 * (bar4_e2 * w686) * c121) - w586 * w1176 + w584 * w1177 + w595 * w1142
    w1213 = w1212 - w595 * w1178 + w601 * w1145 - w602 * w1149 + (w61 * w1145 - w56 * w1146 - w58 * w1147 - w86 * w1149) * c73
    w1214 = (w1213 - w262 * w1034 + w261 * w1037 - w225 * w1183 + w225 * w1166 + w60 * w1185 - w65 * w1186) * -2.0
    w1215 = (w90 * w1135 + w61 * w1139) * c76 + (w629 * w1139 + (w633 * w1138 + (w632 * w1137 + (w628 * w1135 + w738 * (bar4_e3 * w686) * c149))))
    w1216 = w1215 - w586 * w1177 - w584 * w1191 + w595 * w1192 + w586 * w1143 - w602 * w1147 - w603 * w1149 + w260 * w1033
    w1217 = w56 * (2 * -(w1199 + w1210)) + w197 * w1134 + (w1216 + w262 * w1037 + w65 * w1157 + w225 * w1194 - w60 * w1195 - w65 * w1185) * -2.0
    w1218 = w631 * w1136 + (w56 * w1136 + w58 * w1137 + w86 * w1138) * c73 + w584 * w1176 - w595 * w1144 - w601 * w1146
    w1219 = (w1217 + w58 * w1190 + w57 * w1197 + 2 * (w1218 - w261 * w1034 - w225 * w1158 + w60 * w1186)) * (w739 + (w740 + w741))
    w1220 = w684 * w752 - w495 * w696 - w263 * w1029 + w250 * w1155 + w234 * w1159 + w89 * w1168
    w1221 = w495 * w699 + w684 * w750 + w264 * w1029 - w251 * w1155 - w235 * w1159 - w92 * w1168
    w1222 = w682 * w722 + w679 * w725
    w1223 = w682 * w720 + w677 * w725
    w1224 = w682 * w721 + w678 * w725
    w1225 = w683 * w720 + w677 * w726
    w1226 = w683 * w722 + w679 * w726
    w1227 = w683 * w721 + w678 * w726
    w1228 = w680 * w726 + w683 * w723
    w1229 = w102 * w1222 - w77 * w1223 + w106 * w1224 + w72 * w1225 - w101 * w1226 - w102 * w1227 + w93 * w1228
    w1230 = w680 * w725 + w682 * w723
    w1231 = w1161 - (w701 * w721 + w678 * w755)
    w1232 = w1181 - (w700 * w721 + w678 * w754)
    w1233 = w1154 - (w700 * w722 + w679 * w754)
    w1234 = w700 * w723 + w680 * w754 - w1182
    w1235 = w700 * w720 + w677 * w754 - w1156
    w1236 = w1164 - (w701 * w722 + w679 * w755)
    w1237 = w701 * w723 + w680 * w755 - w1162
    w1238 = w106 * w1231 - (w102 * w1232 + w101 * w1233 + w93 * w1234 + w72 * w1235) + w102 * w1236 + w72 * w1237
    w1239 = w701 * w720 + w677 * w755 - w1165
    w1240 = (w1229 - w72 * w1230) * c80 + (w1238 + w77 * w1239) * c56
    w1241 = w681 * w722 + w679 * w724
    w1242 = w681 * w720 + w677 * w724
    w1243 = w681 * w721 + w678 * w724
    w1244 = w101 * w1241 - w72 * w1242 + w102 * w1243 + w106 * w1223 - w72 * w1222 - w93 * w1224 + w73 * w1230
    w1245 = w680 * w724 + w681 * w723
    w1246 = w1170 - (w702 * w721 + w678 * w756)
    w1247 = w1173 - (w702 * w722 + w679 * w756)
    w1248 = w702 * w723 + w680 * w756 - w1171
    w1249 = w102 * w1246 - (w93 * w1231 + w72 * w1236 + w73 * w1237 + w106 * w1239) + w101 * w1247 + w93 * w1248
    w1250 = w702 * w720 + w677 * w756 - w1174
    w1251 = (w1244 - w93 * w1245) * c80 + (w1249 + w72 * w1250) * c56
    w1252 = w679 * w722
    w1253 = hinge0_angle_ddot * w84
    w1254 = w494 * (w494 * (w99 * w1253)) * c150
    w1255 = w677 * w720
    w1256 = hinge0_angle_ddot * w85
    w1257 = w494 * (w494 * (w99 * w1256)) * c139
    w1258 = w494 * (w494 * (w85 * w1253)) * c138
    w1259 = w667 * w1252 + (w72 * w1252 + w93 * w1254) * c67 + w653 * w1255 - w652 * w1257 + (w72 * w1255 - w106 * w1257 - w102 * w1258) * c69
    w1260 = w680 * w723
    w1261 = w494 * (w494 * (w100 * w1256)) * c136
    w1262 = w494 * (w494 * (w100 * (hinge0_angle_ddot * w99))) * c139
    w1263 = w1259 - w560 * w1242 - w560 * w1222 + w571 * w1225 + w562 * w1226 + w579 * w1260 + w578 * w1261 - w577 * w1262
    w1264 = w494 * (w494 * (w100 * w1253)) * c138
    w1265 = w1263 + (w72 * w1260 + w93 * w1261 - w73 * w1262 - w106 * w1264) * c70 - w571 * w1230 + w562 * w1245
    w1266 = 2 * (w1265 + w79 * w1233 - w230 * w1235 - w75 * w1236 + w230 * w1237 - w79 * w1248 + w75 * w1250)
    w1267 = w1206 + (w1211 + w57 * w1205 + w1214 - w58 * w1197) * (w731 + (w732 - w733)) - w1219 + w721 * (w304 * w1220 - w305 * w1221 + 2 * -(bar5_e3 * w1240) + 2 * (bar5_e1 * w1251) + w1266)
    w1268 = w246 * w1155 - (w495 * w708 + w684 * w761 + w267 * w1029) + w227 * w1159 + w66 * w1168
    w1269 = w495 * w705 + w684 * w759 + w266 * w1029 - w247 * w1155 - w228 * w1159 - w70 * w1168
    w1270 = w494 * (w494 * (w84 * (w84 * (hinge0_angle_ddot * bar5_e1)))) * c151 + w667 * w1254 + w654 * w1255
    w1271 = w1270 + (w93 * w1255 - w73 * w1257 - w106 * w1258) * c70 - w652 * w1258 - w560 * w1224 + w562 * w1227
    w1272 = w1271 + w579 * w1261 - w577 * w1264 + w571 * w1228 - w560 * w1245 + w79 * w1232 - w230 * w1234 - w75 * w1231
    w1273 = w77 * w1242 - w102 * w1241 - w106 * w1243 - w106 * w1225 + w72 * w1226 + w93 * w1227 - w73 * w1228
    w1274 = w93 * w1232 + w72 * w1233 + w73 * w1234 + w106 * w1235 - w106 * w1246 - w102 * w1247 - w72 * w1248
    w1275 = 2 * -((w1273 + w72 * w1245) * c80 + (w1274 - w77 * w1250) * c56)
    w1276 = w562 * w1242 - w571 * w1223 + w578 * w1260 + (w77 * w1260 + w72 * w1261 - w106 * w1262 - w102 * w1264) * c69
    w1277 = w305 * w1268 + w304 * w1269 + 2 * (bar5_e2 * w1240) + (w1272 + w75 * w1248) * -2.0 + w77 * w1275 + 2 * (w1276 + w230 * w1239 - w79 * w1250)
    w1278 = w669 * w1252 + (w73 * w1252 + w106 * w1254) * c70 - w654 * w1257 - w579 * w1262 - w562 * w1228 + w560 * w1230
    w1279 = w494 * (w494 * (w84 * (w84 * (hinge0_angle_ddot * bar5_e2)))) * c152 + w668 * w1254 - w653 * w1258
    w1280 = w1279 - w562 * w1241 + w560 * w1243 + w571 * w1222 - w571 * w1227 + w577 * w1260 - w578 * w1264 + (w102 * w1260 + w101 * w1261 - w72 * w1262 - w93 * w1264) * c67
    w1281 = w304 * w1268 - w305 * w1269 + 2 * (w1278 + w79 * w1234 - w75 * w1237) + w77 * w1240 + (w1280 - w230 * w1232 + w230 * w1236 + w75 * w1246 - w79 * w1247) * -2.0
    w1282 = w494 * (w494 * (w84 * (w84 * (hinge0_angle_ddot * bar5_e3)))) * c153 + w668 * w1252 + w669 * w1254
    w1283 = w1282 + (w106 * w1252 + w102 * w1254) * c69 - w653 * w1257 - w654 * w1258 - w562 * w1243 + w560 * w1223
    w1284 = w1283 + w571 * w1224 - w562 * w1225 - w578 * w1262 - w579 * w1264 + w79 * w1235 + w230 * w1231 - w75 * w1239
    w1285 = w652 * w1255 + (w101 * w1255 - w72 * w1257 - w93 * w1258) * c67 + w560 * w1241 - w571 * w1226 + w577 * w1261
    w1286 = w304 * w1221 + w305 * w1220 - w72 * w1240 + (w1284 - w79 * w1246) * -2.0 + 2 * (w1285 - w230 * w1233 + w75 * w1247)
    w1287 = w1267 + w722 * (w1277 + w72 * w1251) - w720 * (w1281 + 2 * (bar5_e3 * w1251)) - w723 * (w1286 + w101 * w1275 + w73 * w1251)
    w1288 = w483 * w808 - (w484 * w525 + w482 * w544 + w486 * w547 + w3 * w528 + w485 * w806) - w487 * w810 - w217 * w1044
    w1289 = w1288 - w218 * w1041 - w219 * w1042 - w220 * w1045 - w188 * w910 - w190 * w912 - w192 * w908 + w194 * w905
    w1290 = w1289 - w174 * w827 - w176 * w830 - w179 * w832 + w181 * w834 - w146 * w823 - w150 * w836 - w154 * w838
    w1291 = w1290 + w159 * w840 + (bar1_e2 * w903 - bar1_e1 * w902 - bar1_e3 * w928 + bar1_e0 * w929) * 0.5 + w488 * w812
    w1292 = w482 * w547 - w484 * w528 - w486 * w544 + w3 * w525 + w488 * w806 + w487 * w808 + w483 * w810 - w220 * w1044
    w1293 = w1292 + w219 * w1041 - w218 * w1042 + w217 * w1045 + w194 * w910 + w192 * w912 - w190 * w908 + w188 * w905
    w1294 = w1293 + w181 * w827 + w179 * w830 - w176 * w832 + w174 * w834 + w159 * w823 + w154 * w836 - w150 * w838
    w1295 = w1294 + w146 * w840 + (bar1_e2 * w902 + bar1_e1 * w903 + bar1_e0 * w928 + bar1_e3 * w929) * 0.5 + w485 * w812
    w1296 = bar2_e0 * w949 - bar2_e3 * w948 + bar2_e1 * w950 + bar2_e2 * w951
    w1297 = bar2_e0 * w951 - (bar2_e1 * w948 + bar2_e2 * w949 + bar2_e3 * w950)
    w1298 = w521 * w771 - w524 * w776 - w523 * w780 + w522 * w784 + w502 * w798 + w503 * w799 - w500 * w800 - w501 * w801
    w1299 = w1298 - w215 * w1046 - w216 * w1047 + w213 * w1043 + w214 * w1048 + w183 * w998 + w187 * w969 - w185 * w972
    w1300 = w1299 - w186 * w1000 + w166 * w990 + w173 * w974 - w171 * w992 - w172 * w976 + w121 * w988 + w144 * w994
    w1301 = w1300 - w135 * w978 - w139 * w980
    w1302 = w522 * w776 + w523 * w771 + w521 * w780 + w524 * w784 + w500 * w798 + w501 * w799 + w502 * w800 + w503 * w801
    w1303 = w185 * w998 - (w1302 + w213 * w1046 + w214 * w1047 + w215 * w1043 + w216 * w1048) + w186 * w969 + w183 * w972
    w1304 = w1303 + w187 * w1000 + w171 * w990 + w172 * w974 + w166 * w992 + w173 * w976 + w135 * w988 + w139 * w994
    w1305 = w1304 + w121 * w978 + w144 * w980
    w1306 = ((w1296 * c17 + w1297 * c19) * c18 + (w1297 * c17 - w1296 * c19) * c16) * 0.5 + (w1301 * c19 - w1305 * c17) * c16
    w1307 = bar2_e0 * w948 + bar2_e3 * w949 - bar2_e2 * w950 + bar2_e1 * w951
    w1308 = bar2_e2 * w948 - bar2_e1 * w949 + bar2_e0 * w950 + bar2_e3 * w951
    w1309 = w523 * w776 - w522 * w771 - w524 * w780 + w521 * w784 + w503 * w798 - w502 * w799 + w501 * w800 - w500 * w801
    w1310 = w1309 - w216 * w1046 + w215 * w1047 - w214 * w1043 + w213 * w1048 + w187 * w998 - w183 * w969 + w186 * w972
    w1311 = w1310 - w185 * w1000 + w173 * w990 - w166 * w974 + w172 * w992 - w171 * w976 + w144 * w988 - w121 * w994
    w1312 = w1311 + w139 * w978 - w135 * w980
    w1313 = w521 * w776 + w524 * w771 - w522 * w780 - w523 * w784 + w501 * w798 - w500 * w799 - w503 * w800 + w502 * w801
    w1314 = w1313 - w214 * w1046 + w213 * w1047 + w216 * w1043 - w215 * w1048 + w186 * w998 - w185 * w969 - w187 * w972
    w1315 = w1314 + w183 * w1000 + w172 * w990 - w171 * w974 - w173 * w992 + w166 * w976 + w139 * w988 - w135 * w994
    w1316 = w1315 - w144 * w978 + w121 * w980
    w1317 = ((w1307 * c19 - w1308 * c17) * c16 + (w1308 * c19 + w1307 * c17) * c18) * 0.5 + (w1312 * c19 - w1316 * c17) * c18
    w1318 = w123 * (w1306 + (w1305 * c19 + w1301 * c17) * c18) - w140 * (w1317 + (w1312 * c17 + w1316 * c19) * c16)
    w1319 = w705 * w722 - w696 * w721 + w708 * w720 - w699 * w723 + w679 * w759 + w677 * w761 - w680 * w750 + w678 * w752
    w1320 = w1319 + (bar5_e1 * w1268 - bar5_e0 * w1221 - bar5_e2 * w1269 + bar5_e3 * w1220) * 0.5 + w263 * w1035
    w1321 = w1320 - w266 * w1031 - w267 * w1032 + w264 * w1036 - w250 * w1181 + w247 * w1154 - w251 * w1182 + w246 * w1156
    w1322 = w1321 - w234 * w1161 + w228 * w1164 - w235 * w1162 + w227 * w1165 - w89 * w1170 + w70 * w1173 - w92 * w1171
    w1323 = w699 * w721 + w708 * w722 - w705 * w720 - w696 * w723 - w677 * w759 + w679 * w761 + w678 * w750 + w680 * w752
    w1324 = w1323 + (bar5_e3 * w1221 + bar5_e2 * w1268 + bar5_e1 * w1269 + bar5_e0 * w1220) * 0.5 - w264 * w1035
    w1325 = w1324 - w267 * w1031 + w266 * w1032 + w263 * w1036 + w251 * w1181 + w246 * w1154 - w250 * w1182 - w247 * w1156
    w1326 = w1325 + w235 * w1161 + w227 * w1164 - w234 * w1162 - w228 * w1165 + w92 * w1170 + w66 * w1173 - w89 * w1171
    w1327 = w1287 + w498 * ((w51 * w1291 - w52 * w1295) * 0.5) + w496 * (w1318 * 0.5) + w495 * ((w71 * (w1322 + w66 * w1174) - w68 * (w1326 - w70 * w1174)) * 0.5)
    w1328 = w494 * w713 + w676 * w765 - w270 * w1030 - w257 * w1153 - w243 * w1160 - w109 * w1169
    w1329 = w676 * w767 - w494 * w709 + w268 * w1030 + w249 * w1153 + w232 * w1160 + w81 * w1169
    w1330 = w494 * w711 + w676 * w763 - w269 * w1030 + w255 * w1153 + w241 * w1160 + w104 * w1169
    w1331 = w676 * w757 - w494 * w703 + w265 * w1030 - w253 * w1153 - w238 * w1160 - w97 * w1169
    w1332 = w98 * (((w1328 * c58 - w1329 * c60) * c59 + (w1328 * c60 + w1329 * c58) * c57) * 0.5) - w83 * (((w1330 * c58 - w1331 * c60) * c57 + (w1330 * c60 + w1331 * c58) * c59) * 0.5)
    dMa_dq_i = ca.vertcat(
        w719 + (w1327 - w494 * (w1332 * 0.5)),
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 165 operations."""
    p = ca.SX.sym("p", 48)
    bar1_end_x = p[30]
    bar2_end_y = p[33]
    bar3_end_z = p[38]
    bar4_end_x = p[41]
    bar5_end_y = p[44]
    ground_P5_z = p[47]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        ground_P5_z,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar1_end_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar2_end_y,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar3_end_z,
        0.0,
        0.0,
        0.0,
        bar4_end_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        bar5_end_y,
        0.0,
    )
    positions = ca.reshape(positions, 3, 13)
    positions = ca.densify(positions)
    axes = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    axes = ca.reshape(axes, 9, 13)
    axes = ca.densify(axes)
    inputs, outputs = [p], [positions, axes]
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
