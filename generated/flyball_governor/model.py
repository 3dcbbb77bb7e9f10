"""Stiff flyball governor: equations of motion, emitted by symgen from the scene `flyball_governor`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 360 operations."""
    p = ca.SX.sym("p", 44)
    gravity_z = p[0]
    shaft_mass = p[1]
    shaft_center_of_mass_z = p[2]
    shaft_inertia_xx = p[3]
    shaft_inertia_yy = p[4]
    shaft_inertia_zz = p[5]
    slider_mass = p[6]
    slider_inertia_xx = p[7]
    slider_inertia_yy = p[8]
    slider_inertia_zz = p[9]
    right_rod_mass = p[10]
    right_rod_center_of_mass_x = p[11]
    right_rod_inertia_xx = p[12]
    right_rod_inertia_yy = p[13]
    right_rod_inertia_zz = p[14]
    left_rod_mass = p[15]
    left_rod_center_of_mass_x = p[16]
    left_rod_inertia_xx = p[17]
    left_rod_inertia_yy = p[18]
    left_rod_inertia_zz = p[19]
    shaft_right_quaternion_0_0_0 = p[20]
    shaft_right_quaternion_1_0_0 = p[21]
    shaft_right_x = p[22]
    shaft_right_z = p[23]
    right_rod_hinge_quaternion_0_0_0 = p[24]
    right_rod_hinge_quaternion_1_0_0 = p[25]
    shaft_left_quaternion_2_0_0 = p[26]
    shaft_left_quaternion_3_0_0 = p[27]
    shaft_left_x = p[28]
    shaft_left_z = p[29]
    left_rod_hinge_quaternion_0_0_0 = p[30]
    left_rod_hinge_quaternion_1_0_0 = p[31]
    right_rod_middle_x = p[32]
    slider_right_x = p[33]
    right_spring_stiffness = p[34]
    right_spring_damping = p[35]
    right_spring_free_length = p[36]
    left_rod_middle_x = p[37]
    slider_left_x = p[38]
    left_spring_stiffness = p[39]
    left_spring_damping = p[40]
    left_spring_free_length = p[41]
    w0 = (shaft_inertia_xx + shaft_inertia_yy + shaft_inertia_zz) / 2.0
    w1 = w0 - shaft_inertia_yy
    w2 = w0 - shaft_inertia_zz + shaft_mass * shaft_center_of_mass_z**2
    w3 = w1 + w2
    w4 = w0 - shaft_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = left_rod_mass * left_rod_center_of_mass_x
    w8 = (left_rod_inertia_xx + left_rod_inertia_yy + left_rod_inertia_zz) / 2.0
    w9 = w8 - left_rod_inertia_yy
    w10 = w8 - left_rod_inertia_zz
    w11 = w9 + w10
    w12 = w8 - left_rod_inertia_xx + left_rod_mass * left_rod_center_of_mass_x**2
    w13 = w10 + w12
    w14 = w9 + w12
    w15 = left_rod_hinge_quaternion_1_0_0 * shaft_left_quaternion_3_0_0
    w16 = shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w17 = -4.0 * w14
    w18 = -4.0 * w13
    w19 = shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w20 = shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    w21 = shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0
    w22 = shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w23 = w21 + w22
    w24 = right_rod_mass * right_rod_center_of_mass_x
    w25 = (right_rod_inertia_xx + right_rod_inertia_yy + right_rod_inertia_zz) / 2.0
    w26 = w25 - right_rod_inertia_yy
    w27 = w25 - right_rod_inertia_zz
    w28 = w26 + w27
    w29 = w25 - right_rod_inertia_xx + right_rod_mass * right_rod_center_of_mass_x**2
    w30 = w27 + w29
    w31 = w26 + w29
    w32 = -4.0 * w31
    w33 = right_rod_hinge_quaternion_0_0_0 * shaft_right_quaternion_1_0_0
    w34 = shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w35 = w33 + w34
    w36 = -4.0 * w30
    w37 = (slider_inertia_xx + slider_inertia_yy + slider_inertia_zz) / 2.0
    w38 = w37 - slider_inertia_yy
    w39 = w37 - slider_inertia_zz
    w40 = w38 + w39
    w41 = w37 - slider_inertia_xx
    w42 = w39 + w41
    w43 = w38 + w41
    w44 = -4.0 * w5
    w45 = -4.0 * w42
    w46 = 2 * shaft_right_x
    w47 = 2 * shaft_left_x
    w48 = -4.0 * w6
    w49 = -4.0 * w43
    c = ca.vertcat(
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        shaft_left_x,
        shaft_left_z,
        left_rod_mass,
        shaft_left_quaternion_2_0_0,
        left_rod_hinge_quaternion_1_0_0,
        shaft_left_quaternion_3_0_0,
        left_rod_hinge_quaternion_0_0_0,
        w7,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15 + w16,
        4.0 * w13 + w17,
        4.0 * w14 + -4.0 * w11,
        4.0 * w11 + w18,
        w19 + w20,
        4.0 * w11 + w18,
        -4.0 * w11 + 4.0 * w14,
        w17 + 4.0 * w13,
        shaft_right_x,
        shaft_right_z,
        right_rod_mass,
        shaft_right_quaternion_0_0_0,
        right_rod_hinge_quaternion_0_0_0,
        shaft_right_quaternion_1_0_0,
        right_rod_hinge_quaternion_1_0_0,
        w23,
        w24,
        w26,
        w27,
        w28,
        w29,
        w30,
        w31,
        4.0 * w30 + w32,
        w35,
        4.0 * w31 + -4.0 * w28,
        4.0 * w28 + w36,
        4.0 * w28 + w36,
        -4.0 * w28 + 4.0 * w31,
        w32 + 4.0 * w30,
        slider_mass,
        w38,
        w39,
        w40,
        w41,
        w42,
        w43,
        4.0 * w3 + w44,
        4.0 * w40 + w45,
        shaft_mass * shaft_center_of_mass_z,
        gravity_z,
        left_rod_mass * gravity_z,
        left_spring_free_length,
        slider_left_x,
        left_rod_middle_x,
        left_spring_stiffness,
        left_spring_damping,
        right_rod_mass * gravity_z,
        right_spring_free_length,
        slider_right_x,
        right_rod_middle_x,
        right_spring_stiffness,
        right_spring_damping,
        slider_mass * gravity_z,
        w46,
        w21 - w22,
        w34 - w33,
        -w35,
        w47,
        w20 - w19,
        w16 - w15,
        shaft_mass,
        4.0 * w5 + w48,
        4.0 * w6 + -4.0 * w3,
        w44 + 4.0 * w3,
        4.0 * w6 + -4.0 * w3,
        4.0 * w5 + w48,
        4.0 * w42 + w49,
        4.0 * w43 + -4.0 * w40,
        w45 + 4.0 * w40,
        4.0 * w43 + -4.0 * w40,
        4.0 * w42 + w49,
        shaft_mass * gravity_z,
        -w23,
        0.5 * right_spring_stiffness,
        0.5 * left_spring_stiffness,
        2 * right_spring_damping,
        2 * left_spring_damping,
        -4.0 * w6,
        -4.0 * w43,
        -4.0 * w28,
        -4.0 * w30,
        -4.0 * w31,
        -4.0 * w11,
        -4.0 * w13,
        -4.0 * w14,
        -(2 * right_rod_middle_x),
        -(2 * left_rod_middle_x),
        -w46,
        -(2 * slider_right_x),
        -w47,
        -(2 * slider_left_x),
        0.5 * w33 + 0.5 * w34,
        0.5 * w21 + 0.5 * w22,
        0.25 * w21 + 0.25 * w22,
        0.25 * w33 + 0.25 * w34,
        0.5 * w15 + 0.5 * w16,
        0.5 * w19 + 0.5 * w20,
        0.25 * w15 + 0.25 * w16,
        0.25 * w19 + 0.25 * w20,
        2 * w7,
        2 * w24,
        2.0,
        -(2 * w24),
        -(2 * w7),
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 2414 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 28)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    slider_x = q_d[7]
    slider_y = q_d[8]
    slider_z = q_d[9]
    slider_e0 = q_d[10]
    slider_e1 = q_d[11]
    slider_e2 = q_d[12]
    slider_e3 = q_d[13]
    right_rod_x = q_d[14]
    right_rod_y = q_d[15]
    right_rod_z = q_d[16]
    right_rod_e0 = q_d[17]
    right_rod_e1 = q_d[18]
    right_rod_e2 = q_d[19]
    right_rod_e3 = q_d[20]
    left_rod_x = q_d[21]
    left_rod_y = q_d[22]
    left_rod_z = q_d[23]
    left_rod_e0 = q_d[24]
    left_rod_e1 = q_d[25]
    left_rod_e2 = q_d[26]
    left_rod_e3 = q_d[27]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_e0_dot = q_d_dot[3]
    shaft_e1_dot = q_d_dot[4]
    shaft_e2_dot = q_d_dot[5]
    shaft_e3_dot = q_d_dot[6]
    slider_x_dot = q_d_dot[7]
    slider_y_dot = q_d_dot[8]
    slider_z_dot = q_d_dot[9]
    slider_e0_dot = q_d_dot[10]
    slider_e1_dot = q_d_dot[11]
    slider_e2_dot = q_d_dot[12]
    slider_e3_dot = q_d_dot[13]
    right_rod_x_dot = q_d_dot[14]
    right_rod_y_dot = q_d_dot[15]
    right_rod_z_dot = q_d_dot[16]
    right_rod_e0_dot = q_d_dot[17]
    right_rod_e1_dot = q_d_dot[18]
    right_rod_e2_dot = q_d_dot[19]
    right_rod_e3_dot = q_d_dot[20]
    left_rod_x_dot = q_d_dot[21]
    left_rod_y_dot = q_d_dot[22]
    left_rod_z_dot = q_d_dot[23]
    left_rod_e0_dot = q_d_dot[24]
    left_rod_e1_dot = q_d_dot[25]
    left_rod_e2_dot = q_d_dot[26]
    left_rod_e3_dot = q_d_dot[27]
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
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = shaft_e2 * -2.0
    w4 = 2 * shaft_e1
    w5 = 2 * shaft_e0
    w6 = w5 * c5
    w7 = w3 * (w3 * c2) + w4 * (w4 * c4) + w5 * w6
    w8 = 2 * shaft_e2
    w9 = w5 * shaft_e3 + shaft_e2 * w4
    w10 = w8 * shaft_e3 - shaft_e1 * w5
    w11 = w9 * c6 + w10 * c7
    w12 = shaft_e1 * -2.0
    w13 = 2 * shaft_e2**2
    w14 = 1.0 - w13 - 2 * shaft_e3**2
    w15 = shaft_e2 * w5
    w16 = w4 * shaft_e3
    w17 = w15 + w16
    w18 = w14 * c6 + w17 * c7
    w19 = w8 * w11 - w12 * w18
    w20 = w19 * c8
    w21 = w16 - w15
    w22 = 1.0 - 2 * shaft_e1**2 - w13
    w23 = w21 * c6 + w22 * c7
    w24 = w5 * w18 - w8 * w23
    w25 = w24 * c8
    w26 = w12 * w23
    w27 = w26 - w5 * w11
    w28 = w27 * c8
    w29 = left_swing_angle / 2.0
    w30 = ca.sin(w29)
    w31 = w30 * c9 * c10 - w30 * c11 * c12
    w32 = 2 * left_rod_e2
    w33 = 2 * left_rod_e0
    w34 = w33 * left_rod_e3
    w35 = 2 * left_rod_e1
    w36 = left_rod_e2 * w35
    w37 = w34 + w36
    w38 = w37 * c13
    w39 = left_rod_e1 * -2.0
    w40 = 2 * left_rod_e2**2
    w41 = 2 * left_rod_e3**2
    w42 = 1.0 - w40 - w41
    w43 = w42 * c13
    w44 = w32 * w38 - w39 * w43
    w45 = w33 * w43
    w46 = left_rod_e3 * w35
    w47 = left_rod_e2 * w33
    w48 = w46 - w47
    w49 = w48 * c13
    w50 = w45 - w32 * w49
    w51 = w39 * w49
    w52 = w33 * w38
    w53 = w51 - w52
    w54 = w19 * w44 + w24 * w50 + w27 * w53
    w55 = left_rod_e2 * -2.0
    w56 = w55 * c16
    w57 = w35 * c18
    w58 = w33 * c19
    w59 = w55 * w56 + w35 * w57 + w33 * w58
    w60 = w54 + w31 * w59
    w61 = w30 * c20
    w62 = left_rod_e3 * -2.0
    w63 = w38 * w62
    w64 = w63 - w45
    w65 = w35 * w43 - w49 * w62
    w66 = w33 * w49
    w67 = w66 - w35 * w38
    w68 = 2 * left_rod_e3
    w69 = w56 * w68 + left_rod_e0 * left_rod_e1 * c21
    w70 = w19 * w64 + w24 * w65 + w27 * w67 + w31 * w69
    w71 = w33 * c18
    w72 = w39 * c19
    w73 = w68 * (w68 * c16) + w33 * w71 + w39 * w72
    w74 = w70 + w61 * w73
    w75 = ca.cos(w29)
    w76 = w75 * c9 * c12 - w75 * c11 * c10
    w77 = w52 - w43 * w68
    w78 = w43 * w55
    w79 = w78 - w66
    w80 = w49 * w68 - w38 * w55
    w81 = w57 * w62 + left_rod_e2 * left_rod_e0 * c22
    w82 = left_rod_e0 * left_rod_e3 * c23 + w32 * w72
    w83 = w19 * w77 + w24 * w79 + w27 * w80 + w31 * w81 + w61 * w82
    w84 = w33 * c16
    w85 = w33 * w84 + w62 * (w62 * c18) + w32 * (w32 * c19)
    w86 = w83 - w76 * w85
    w87 = w7 + w19 * w20 + w24 * w25 + w27 * w28 + (w31 * w60 + w31 * w54) + (w61 * w74 + w61 * w70) - (w76 * w86 + w76 * w83)
    w88 = w75 * c24
    w89 = w38 * w39 - w78
    w90 = w43 * w62 - w51
    w91 = w49 * w55 - w63
    w92 = left_rod_e2 * left_rod_e1 * c25 + w58 * w62
    w93 = w55 * w71 + left_rod_e3 * left_rod_e1 * c26
    w94 = w39 * w84 + left_rod_e2 * left_rod_e3 * c27
    w95 = w19 * w89 + w24 * w90 + w27 * w91 + w31 * w92 + w61 * w93 - w76 * w94
    w96 = w39 * (w39 * c16) + w55 * (w55 * c18) + w62 * (w62 * c19)
    w97 = w95 - w88 * w96
    w98 = w9 * c28 + w10 * c29
    w99 = w14 * c28 + w17 * c29
    w100 = w8 * w98 - w12 * w99
    w101 = w100 * c30
    w102 = w21 * c28 + w22 * c29
    w103 = w5 * w99 - w8 * w102
    w104 = w103 * c30
    w105 = w12 * w102
    w106 = w105 - w5 * w98
    w107 = w106 * c30
    w108 = right_swing_angle / 2.0
    w109 = ca.cos(w108)
    w110 = w109 * c35
    w111 = 2 * right_rod_e2
    w112 = 2 * right_rod_e0
    w113 = w112 * right_rod_e3
    w114 = 2 * right_rod_e1
    w115 = right_rod_e2 * w114
    w116 = w113 + w115
    w117 = w116 * c36
    w118 = right_rod_e1 * -2.0
    w119 = 2 * right_rod_e2**2
    w120 = 2 * right_rod_e3**2
    w121 = 1.0 - w119 - w120
    w122 = w121 * c36
    w123 = w111 * w117 - w118 * w122
    w124 = w112 * w122
    w125 = right_rod_e3 * w114
    w126 = right_rod_e2 * w112
    w127 = w125 - w126
    w128 = w127 * c36
    w129 = w124 - w111 * w128
    w130 = w118 * w128
    w131 = w112 * w117
    w132 = w130 - w131
    w133 = w100 * w123 + w103 * w129 + w106 * w132
    w134 = right_rod_e2 * -2.0
    w135 = w134 * c39
    w136 = w114 * c41
    w137 = w112 * c42
    w138 = w134 * w135 + w114 * w136 + w112 * w137
    w139 = w133 + w110 * w138
    w140 = w87 - (w88 * w97 + w88 * w95) + w100 * w101 + w103 * w104 + w106 * w107 + (w110 * w139 + w110 * w133)
    w141 = w109 * c33 * c32 - w109 * c31 * c34
    w142 = right_rod_e3 * -2.0
    w143 = w117 * w142
    w144 = w143 - w124
    w145 = w114 * w122 - w128 * w142
    w146 = w112 * w128
    w147 = w146 - w114 * w117
    w148 = 2 * right_rod_e3
    w149 = w135 * w148 + right_rod_e0 * right_rod_e1 * c43
    w150 = w100 * w144 + w103 * w145 + w106 * w147 + w110 * w149
    w151 = w112 * c41
    w152 = w118 * c42
    w153 = w148 * (w148 * c39) + w112 * w151 + w118 * w152
    w154 = w150 + w141 * w153
    w155 = ca.sin(w108)
    w156 = w155 * c44
    w157 = w131 - w122 * w148
    w158 = w122 * w134
    w159 = w158 - w146
    w160 = w128 * w148 - w117 * w134
    w161 = w136 * w142 + right_rod_e2 * right_rod_e0 * c45
    w162 = right_rod_e0 * right_rod_e3 * c46 + w111 * w152
    w163 = w100 * w157 + w103 * w159 + w106 * w160 + w110 * w161 + w141 * w162
    w164 = w112 * c39
    w165 = w112 * w164 + w142 * (w142 * c41) + w111 * (w111 * c42)
    w166 = w163 + w156 * w165
    w167 = w155 * c31 * c32 - w155 * c33 * c34
    w168 = w117 * w118 - w158
    w169 = w122 * w142 - w130
    w170 = w128 * w134 - w143
    w171 = right_rod_e2 * right_rod_e1 * c47 + w137 * w142
    w172 = w134 * w151 + right_rod_e3 * right_rod_e1 * c48
    w173 = w118 * w164 + right_rod_e2 * right_rod_e3 * c49
    w174 = w100 * w168 + w103 * w169 + w106 * w170 + w110 * w171 + w141 * w172 + w156 * w173
    w175 = w118 * (w118 * c39) + w134 * (w134 * c41) + w142 * (w142 * c42)
    w176 = w174 - w167 * w175
    w177 = w17 * height_travel
    w178 = w10 * height_travel
    w179 = w12 * w177 - w8 * w178
    w180 = w179 * c50
    w181 = w140 + (w141 * w154 + w141 * w150) + (w156 * w166 + w156 * w163) - (w167 * w176 + w167 * w174) + w179 * w180
    w182 = w22 * height_travel
    w183 = w8 * w182 - w5 * w177
    w184 = w183 * c50
    w185 = w12 * w182
    w186 = w5 * w178 - w185
    w187 = w186 * c50
    w188 = slider_e2 * -2.0
    w189 = 2 * slider_e1
    w190 = 2 * slider_e0
    w191 = w190 * c56
    w192 = w188 * (w188 * c53) + w189 * (w189 * c55) + w190 * w191
    w193 = ca.sin(w0)
    w194 = w193 / 2.0
    w195 = shaft_e3 * -2.0
    w196 = shaft_e2 * shaft_e1 * c57 + w6 * w195
    w197 = w11 * w12 - w3 * w18
    w198 = w18 * w195 - w26
    w199 = w3 * w23 - w11 * w195
    w200 = w44 * w197 + w50 * w198 + w53 * w199
    w201 = w64 * w197 + w65 * w198 + w67 * w199 + w69 * w88
    w202 = w196 + w20 * w197 + w25 * w198 + w28 * w199 + (w60 * w88 + w31 * w200) + (w74 * w76 + w61 * w201)
    w203 = w77 * w197 + w79 * w198 + w80 * w199 + w81 * w88 + w76 * w82
    w204 = w89 * w197 + w90 * w198 + w91 * w199 + w88 * w92 + w76 * w93 + w61 * w94
    w205 = w12 * w98 - w3 * w99
    w206 = w99 * w195 - w105
    w207 = w3 * w102 - w98 * w195
    w208 = w202 + (w61 * w86 - w76 * w203) + (w31 * w97 - w88 * w204) + w101 * w205 + w104 * w206 + w107 * w207
    w209 = w123 * w205 + w129 * w206 + w132 * w207
    w210 = w144 * w205 + w145 * w206 + w147 * w207 + w149 * w167
    w211 = w157 * w205 + w159 * w206 + w160 * w207 + w161 * w167 - w156 * w162
    w212 = w168 * w205 + w169 * w206 + w170 * w207 + w167 * w171 - w156 * w172 + w141 * w173
    w213 = w208 + (w139 * w167 + w110 * w209) + (w141 * w210 - w154 * w156) + (w141 * w166 + w156 * w211) + (w110 * w176 - w167 * w212)
    w214 = w3 * w177 - w12 * w178
    w215 = w185 - w177 * w195
    w216 = w178 * w195 - w3 * w182
    w217 = slider_e1 * -2.0
    w218 = slider_e3 * -2.0
    w219 = slider_e2 * slider_e1 * c58 + w191 * w218
    w220 = w2 * (w213 + w180 * w214 + w184 * w215 + w187 * w216 + w219)
    w221 = w12 * (w12 * c2) + w3 * (w3 * c4) + w195 * (w195 * c5)
    w222 = w221 + w197 * (w197 * c8) + w198 * (w198 * c8) + w199 * (w199 * c8) + (w88 * (w200 + w59 * w88) + w88 * w200)
    w223 = w222 + (w76 * (w201 + w73 * w76) + w76 * w201) + (w61 * (w203 + w61 * w85) + w61 * w203) + (w31 * (w204 + w31 * w96) + w31 * w204)
    w224 = w223 + w205 * (w205 * c30) + w206 * (w206 * c30) + w207 * (w207 * c30) + (w167 * (w209 + w138 * w167) + w167 * w209)
    w225 = w224 - (w156 * (w210 - w153 * w156) + w156 * w210) + (w141 * (w211 + w141 * w165) + w141 * w211) + (w110 * (w212 + w110 * w175) + w110 * w212)
    w226 = w217 * (w217 * c53) + w188 * (w188 * c55) + w218 * (w218 * c56)
    w227 = w194 * (w220 - w194 * (w225 + w214 * (w214 * c50) + w215 * (w215 * c50) + w216 * (w216 * c50) + w226))
    w228 = w22 * c50
    w229 = w10 * c50
    w230 = w17 * c50
    w231 = w194 * (w214 * w228 + w215 * w229 + w216 * w230) - w2 * (w179 * w228 + w183 * w229 + w186 * w230)
    w232 = w109 / 2.0
    w233 = w232 * c31 * c32 - w232 * c33 * c34
    w234 = w155 / 2.0
    w235 = w234 * c35
    w236 = w232 * c44
    w237 = w234 * c31 * c34 - w234 * c33 * c32
    w238 = shaft_e0 * w233 - shaft_e3 * w235 - (shaft_e1 * w236 + shaft_e2 * w237)
    w239 = w138 * w238
    w240 = w149 * w238
    w241 = shaft_e3 * w237 - shaft_e1 * w233 - (shaft_e0 * w236 + shaft_e2 * w235)
    w242 = w240 + w153 * w241
    w243 = w161 * w238 + w162 * w241
    w244 = shaft_e0 * w237 - shaft_e1 * w235 + (shaft_e2 * w233 + shaft_e3 * w236)
    w245 = w243 + w165 * w244
    w246 = w171 * w238 + w172 * w241 + w173 * w244
    w247 = shaft_e0 * w235 + (shaft_e1 * w237 - shaft_e2 * w236 + shaft_e3 * w233)
    w248 = w246 - w175 * w247
    w249 = w110 * w239 + w133 * w238 + (w141 * w242 + w150 * w241) + (w156 * w245 + w163 * w244) - (w167 * w248 + w174 * w247)
    w250 = w167 * w239 + w209 * w238 + (w210 * w241 - w156 * w242) + (w141 * w245 + w211 * w244) + (w110 * w248 - w212 * w247)
    w251 = w2 * w249 - w194 * w250
    w252 = w75 / 2.0
    w253 = w252 * c9 * c10 - w252 * c11 * c12
    w254 = w30 / 2.0
    w255 = w254 * c24
    w256 = w254 * c11 * c10 - w254 * c9 * c12
    w257 = w252 * c20
    w258 = shaft_e3 * w253 - shaft_e0 * w255 + (shaft_e1 * w256 - shaft_e2 * w257)
    w259 = w59 * w258
    w260 = w69 * w258
    w261 = shaft_e0 * w256 + shaft_e2 * w253 + (shaft_e3 * w257 + shaft_e1 * w255)
    w262 = w260 + w73 * w261
    w263 = shaft_e0 * w257 + shaft_e1 * w253 - (shaft_e2 * w255 + shaft_e3 * w256)
    w264 = w81 * w258 + w82 * w261
    w265 = w264 + w85 * w263
    w266 = shaft_e0 * w253 - (shaft_e1 * w257 + shaft_e2 * w256 - shaft_e3 * w255)
    w267 = w92 * w258 + w93 * w261 + w94 * w263
    w268 = w267 + w96 * w266
    w269 = w31 * w259 + w54 * w258 + (w61 * w262 + w70 * w261) + (w83 * w263 - w76 * w265) + (w95 * w266 - w88 * w268)
    w270 = w88 * w259 + w200 * w258 + (w76 * w262 + w201 * w261) + (w61 * w265 + w203 * w263) + (w31 * w268 + w204 * w266)
    w271 = w2 * w269 - w194 * w270
    w272 = w238 * w239 + (w241 * w242 + w240 * w241) + (w244 * w245 + w243 * w244) - (w247 * w248 + w246 * w247)
    w273 = w258 * w259 + (w261 * w262 + w260 * w261) + (w263 * w265 + w263 * w264) + (w266 * w268 + w266 * w267)
    w274 = w195 * shaft_e0_dot
    w275 = w5 * shaft_e3_dot
    w276 = w274 + w8 * shaft_e1_dot + w12 * shaft_e2_dot + w275
    w277 = w276 * c1
    w278 = w3 * shaft_e0_dot
    w279 = w5 * shaft_e2_dot
    w280 = w278 + w195 * shaft_e1_dot + w279 + w4 * shaft_e3_dot
    w281 = w280 * c0
    w282 = w277 * w280 - w276 * w281
    w283 = w12 * shaft_e0_dot + w5 * shaft_e1_dot
    w284 = 2 * shaft_e3
    w285 = w283 + shaft_e2_dot * w284 + w3 * shaft_e3_dot
    w286 = w285 * c3
    w287 = w276 * w286 - w277 * w285
    w288 = w281 * w285 - w280 * w286
    w289 = w10 * c59
    w290 = w17 * c59
    w291 = (spin_angle_dot / 2.0)**2
    w292 = w1 * w291
    w293 = w193 * w291
    w294 = w62 * left_rod_e0_dot
    w295 = w33 * left_rod_e3_dot
    w296 = w294 + w32 * left_rod_e1_dot + w39 * left_rod_e2_dot + w295
    w297 = w296 * c13
    w298 = w55 * left_rod_e0_dot
    w299 = w33 * left_rod_e2_dot
    w300 = w298 + w62 * left_rod_e1_dot + w299 + w35 * left_rod_e3_dot
    w301 = w300 * c13
    w302 = w296 * w297 + w300 * w301
    w303 = w33 * left_rod_e1
    w304 = w32 * left_rod_e3
    w305 = w39 * left_rod_e0_dot + w33 * left_rod_e1_dot
    w306 = w305 + w68 * left_rod_e2_dot + w55 * left_rod_e3_dot
    w307 = w301 * w306
    w308 = 1.0 - 2 * left_rod_e1**2
    w309 = w297 * w306
    w310 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w311 = w310 * c63
    w312 = w42 * c64
    w313 = slider_x + w311 - (left_rod_x + w312)
    w314 = w190 * slider_e3 + slider_e2 * w189
    w315 = w314 * c63
    w316 = w37 * c64
    w317 = slider_y + w315 - (left_rod_y + w316)
    w318 = w189 * slider_e3 - slider_e2 * w190
    w319 = w318 * c63
    w320 = w48 * c64
    w321 = slider_z + w319 - (left_rod_z + w320)
    w322 = w313**2 + w317**2 + w321**2
    w323 = 1.0 - c62 / ca.sqrt(w322)
    w324 = w188 * slider_e0_dot
    w325 = 2 * slider_e3
    w326 = w190 * slider_e2_dot
    w327 = w324 + slider_e1_dot * w325 + w326 + w217 * slider_e3_dot
    w328 = w218 * slider_e0_dot
    w329 = w190 * slider_e3_dot
    w330 = w328 + w188 * slider_e1_dot + w189 * slider_e2_dot + w329
    w331 = w299 + (w298 + w68 * left_rod_e1_dot) + w39 * left_rod_e3_dot
    w332 = w295 + (w294 + w55 * left_rod_e1_dot + w35 * left_rod_e2_dot)
    w333 = w313 * (slider_x_dot + (w319 * w327 - w315 * w330) - (left_rod_x_dot + (w320 * w331 - w316 * w332)))
    w334 = w217 * slider_e0_dot + w190 * slider_e1_dot
    w335 = 2 * slider_e2
    w336 = w334 + w218 * slider_e2_dot + slider_e3_dot * w335
    w337 = w305 + w62 * left_rod_e2_dot + w32 * left_rod_e3_dot
    w338 = w317 * (slider_y_dot + (w311 * w330 - w319 * w336) - (left_rod_y_dot + (w312 * w332 - w320 * w337)))
    w339 = w321 * (slider_z_dot + (w315 * w336 - w311 * w327) - (left_rod_z_dot + (w316 * w337 - w312 * w331)))
    w340 = (w333 + w338 + w339) * c66
    w341 = w321 * w323 * c65 + w321 * w340 / w322
    w342 = w283 + w195 * shaft_e2_dot + w8 * shaft_e3_dot
    w343 = w275 + (w274 + w3 * shaft_e1_dot + w4 * shaft_e2_dot)
    w344 = w18 * w343 - w23 * w342
    w345 = w279 + (w278 + shaft_e1_dot * w284) + w12 * shaft_e3_dot
    w346 = w23 * w345 - w11 * w343
    w347 = w342 * w344 - w345 * w346 - w197 * w292 - w19 * w293
    w348 = left_swing_angle_dot / 2.0
    w349 = w348**2
    w350 = w30 * w349
    w351 = w350 * c11 * c12 - w350 * c9 * c10
    w352 = w75 * w349
    w353 = w352 * c11 * c10 - w352 * c9 * c12
    w354 = w348 * (w30 * w348) * c20
    w355 = w348 * (w75 * w348) * c24
    w356 = w252 * left_swing_angle_dot
    w357 = w356 * c9 * c10 - w356 * c11 * c12
    w358 = w356 * c20
    w359 = w254 * left_swing_angle_dot
    w360 = w359 * c11 * c10 - w359 * c9 * c12
    w361 = w359 * c24
    w362 = shaft_e0_dot * w357 - (shaft_e1_dot * w358 + shaft_e2_dot * w360 - shaft_e3_dot * w361)
    w363 = w362 + (shaft_e0 * w351 - (shaft_e2 * w353 - shaft_e1 * w354 - shaft_e3 * w355) + w362) - w31 * w292
    w364 = w363 + w88 * w293
    w365 = shaft_e0_dot * w358 + shaft_e1_dot * w357 - (shaft_e2_dot * w361 + shaft_e3_dot * w360)
    w366 = w365 + (shaft_e1 * w351 - shaft_e0 * w354 - (shaft_e2 * w355 + shaft_e3 * w353) + w365) - w61 * w292
    w367 = w366 + w76 * w293
    w368 = shaft_e0_dot * w360 + shaft_e2_dot * w357 + (shaft_e3_dot * w358 + shaft_e1_dot * w361)
    w369 = w368 + (shaft_e0 * w353 + shaft_e2 * w351 + (shaft_e1 * w355 - shaft_e3 * w354) + w368) - w76 * w292
    w370 = w369 - w61 * w293
    w371 = shaft_e3_dot * w357 - shaft_e0_dot * w361 + (shaft_e1_dot * w360 - shaft_e2_dot * w358)
    w372 = w371 + (shaft_e3 * w351 - shaft_e0 * w355 + (shaft_e1 * w353 + shaft_e2 * w354) + w371) - w88 * w292
    w373 = w372 - w31 * w293
    w374 = w48 * w302 - (w303 + w304) * w307 - (w308 - w40) * w309 + (c61 + w341) - (w347 * c8 + w89 * w364 + w77 * w367 + w64 * w370 + w44 * w373)
    w375 = w3 * w282 + w4 * w287 + w5 * w288 + (w8 * w289 - w12 * w290) * c60 + (w196 * w292 + w7 * w293) + w19 * w374
    w376 = w317 * w323 * c65 + w317 * w340 / w322
    w377 = w11 * w342 - w18 * w345
    w378 = w343 * w346 - w342 * w377 - w198 * w292 - w24 * w293
    w379 = w37 * w302 - w307 * (w308 - w41) - w309 * (w304 - w303) + w376 - (w378 * c8 + w90 * w364 + w79 * w367 + w65 * w370 + w50 * w373)
    w380 = w313 * w323 * c65 + w313 * w340 / w322
    w381 = w345 * w377 - w343 * w344 - w199 * w292 - w27 * w293
    w382 = w42 * w302 - w307 * (w36 - w34) - w309 * (w46 + w47) + w380 - (w381 * c8 + w91 * w364 + w80 * w367 + w67 * w370 + w53 * w373)
    w383 = w296 * c15
    w384 = w300 * c14
    w385 = w300 * w383 - w296 * w384
    w386 = w306 * c17
    w387 = w296 * w386 - w306 * w383
    w388 = w306 * w384 - w300 * w386
    w389 = w39 * w320
    w390 = w33 * w316
    w391 = w33 * w312
    w392 = w44 * c60 + (w380 * (w389 - w390) + w376 * (w391 - w32 * w320) + w341 * (w32 * w316 - w39 * w312))
    w393 = w55 * w385 + w35 * w387 + w33 * w388 + w392 - (w53 * w381 + w50 * w378 + w44 * w347 + w92 * w364 + w81 * w367 + w69 * w370 + w59 * w373)
    w394 = w33 * w320
    w395 = w62 * w316
    w396 = w64 * c60 + (w380 * (w394 - w35 * w316) + w376 * (w35 * w312 - w62 * w320) + w341 * (w395 - w391))
    w397 = w68 * w385 + w33 * w387 + w39 * w388 + w396 - (w67 * w381 + w65 * w378 + w64 * w347 + w93 * w364 + w82 * w367 + w73 * w370 + w69 * w373)
    w398 = w55 * w312
    w399 = w77 * c60 + (w380 * (w68 * w320 - w55 * w316) + w376 * (w398 - w394) + w341 * (w390 - w68 * w312))
    w400 = w33 * w385 + w62 * w387 + w32 * w388 + w399 - (w80 * w381 + w79 * w378 + w77 * w347 + w94 * w364 + w85 * w367 + w82 * w370 + w81 * w373)
    w401 = w89 * c60 + (w380 * (w55 * w320 - w395) + w376 * (w62 * w312 - w389) + w341 * (w39 * w316 - w398))
    w402 = w39 * w385 + w55 * w387 + w62 * w388 + w401 - (w91 * w381 + w90 * w378 + w89 * w347 + w96 * w364 + w94 * w367 + w93 * w370 + w92 * w373)
    w403 = w142 * right_rod_e0_dot
    w404 = w112 * right_rod_e3_dot
    w405 = w403 + w111 * right_rod_e1_dot + w118 * right_rod_e2_dot + w404
    w406 = w405 * c36
    w407 = w134 * right_rod_e0_dot
    w408 = w112 * right_rod_e2_dot
    w409 = w407 + w142 * right_rod_e1_dot + w408 + w114 * right_rod_e3_dot
    w410 = w409 * c36
    w411 = w405 * w406 + w409 * w410
    w412 = w112 * right_rod_e1
    w413 = w111 * right_rod_e3
    w414 = w118 * right_rod_e0_dot + w112 * right_rod_e1_dot
    w415 = w414 + w148 * right_rod_e2_dot + w134 * right_rod_e3_dot
    w416 = w410 * w415
    w417 = 1.0 - 2 * right_rod_e1**2
    w418 = w406 * w415
    w419 = w310 * c69
    w420 = w121 * c70
    w421 = slider_x + w419 - (right_rod_x + w420)
    w422 = w314 * c69
    w423 = w116 * c70
    w424 = slider_y + w422 - (right_rod_y + w423)
    w425 = w318 * c69
    w426 = w127 * c70
    w427 = slider_z + w425 - (right_rod_z + w426)
    w428 = w421**2 + w424**2 + w427**2
    w429 = 1.0 - c68 / ca.sqrt(w428)
    w430 = w408 + (w407 + w148 * right_rod_e1_dot) + w118 * right_rod_e3_dot
    w431 = w404 + (w403 + w134 * right_rod_e1_dot + w114 * right_rod_e2_dot)
    w432 = w421 * (slider_x_dot + (w327 * w425 - w330 * w422) - (right_rod_x_dot + (w426 * w430 - w423 * w431)))
    w433 = w414 + w142 * right_rod_e2_dot + w111 * right_rod_e3_dot
    w434 = w424 * (slider_y_dot + (w330 * w419 - w336 * w425) - (right_rod_y_dot + (w420 * w431 - w426 * w433)))
    w435 = w427 * (slider_z_dot + (w336 * w422 - w327 * w419) - (right_rod_z_dot + (w423 * w433 - w420 * w430)))
    w436 = (w432 + w434 + w435) * c72
    w437 = w427 * w429 * c71 + w427 * w436 / w428
    w438 = w99 * w343 - w102 * w342
    w439 = w102 * w345 - w98 * w343
    w440 = w342 * w438 - w345 * w439 - w205 * w292 - w100 * w293
    w441 = right_swing_angle_dot / 2.0
    w442 = w441**2
    w443 = w109 * w442
    w444 = w441 * (w109 * w441) * c35
    w445 = w443 * c31 * c34 - w443 * c33 * c32
    w446 = w155 * w442
    w447 = w441 * (w155 * w441) * c44
    w448 = w446 * c33 * c34 - w446 * c31 * c32
    w449 = w234 * right_swing_angle_dot
    w450 = w449 * c35
    w451 = w449 * c31 * c34 - w449 * c33 * c32
    w452 = w232 * right_swing_angle_dot
    w453 = w452 * c44
    w454 = w452 * c31 * c32 - w452 * c33 * c34
    w455 = shaft_e0_dot * w450 + (shaft_e1_dot * w451 - shaft_e2_dot * w453 + shaft_e3_dot * w454)
    w456 = w455 + (shaft_e0 * w444 + (shaft_e1 * w445 + shaft_e2 * w447 + shaft_e3 * w448) + w455) + w110 * w292
    w457 = w167 * w293 - w456
    w458 = shaft_e0_dot * w451 - shaft_e1_dot * w450 + (shaft_e2_dot * w454 + shaft_e3_dot * w453)
    w459 = w458 + (shaft_e0 * w445 - shaft_e1 * w444 + (shaft_e2 * w448 - shaft_e3 * w447) + w458) - w141 * w292
    w460 = w459 - w156 * w293
    w461 = shaft_e3_dot * w451 - shaft_e1_dot * w454 - (shaft_e0_dot * w453 + shaft_e2_dot * w450)
    w462 = w461 + (shaft_e0 * w447 - shaft_e2 * w444 + (shaft_e3 * w445 - shaft_e1 * w448) + w461) + w156 * w292
    w463 = w462 - w141 * w293
    w464 = shaft_e0_dot * w454 - shaft_e3_dot * w450 - (shaft_e1_dot * w453 + shaft_e2_dot * w451)
    w465 = w464 + (shaft_e0 * w448 - shaft_e3 * w444 + (shaft_e1 * w447 - shaft_e2 * w445) + w464) - w167 * w292
    w466 = w465 - w110 * w293
    w467 = w127 * w411 - (w412 + w413) * w416 - (w417 - w119) * w418 + (c67 + w437) - (w440 * c30 + w168 * w457 + w157 * w460 + w144 * w463 + w123 * w466)
    w468 = w424 * w429 * c71 + w424 * w436 / w428
    w469 = w98 * w342 - w99 * w345
    w470 = w343 * w439 - w342 * w469 - w206 * w292 - w103 * w293
    w471 = w116 * w411 - w416 * (w417 - w120) - w418 * (w413 - w412) + w468 - (w470 * c30 + w169 * w457 + w159 * w460 + w145 * w463 + w129 * w466)
    w472 = w375 + w24 * w379 + w27 * w382 + w31 * w393 + w61 * w397 - w76 * w400 - w88 * w402 + w100 * w467 + w103 * w471
    w473 = w421 * w429 * c71 + w421 * w436 / w428
    w474 = w345 * w469 - w343 * w438 - w207 * w292 - w106 * w293
    w475 = w121 * w411 - w416 * (w115 - w113) - w418 * (w125 + w126) + w473 - (w474 * c30 + w170 * w457 + w160 * w460 + w147 * w463 + w132 * w466)
    w476 = w405 * c38
    w477 = w409 * c37
    w478 = w409 * w476 - w405 * w477
    w479 = w415 * c40
    w480 = w405 * w479 - w415 * w476
    w481 = w415 * w477 - w409 * w479
    w482 = w118 * w426
    w483 = w112 * w423
    w484 = w112 * w420
    w485 = w123 * c60 + (w473 * (w482 - w483) + w468 * (w484 - w111 * w426) + w437 * (w111 * w423 - w118 * w420))
    w486 = w134 * w478 + w114 * w480 + w112 * w481 + w485 - (w132 * w474 + w129 * w470 + w123 * w440 + w171 * w457 + w161 * w460 + w149 * w463 + w138 * w466)
    w487 = w112 * w426
    w488 = w142 * w423
    w489 = w144 * c60 + (w473 * (w487 - w114 * w423) + w468 * (w114 * w420 - w142 * w426) + w437 * (w488 - w484))
    w490 = w148 * w478 + w112 * w480 + w118 * w481 + w489 - (w147 * w474 + w145 * w470 + w144 * w440 + w172 * w457 + w162 * w460 + w153 * w463 + w149 * w466)
    w491 = w134 * w420
    w492 = w157 * c60 + (w473 * (w148 * w426 - w134 * w423) + w468 * (w491 - w487) + w437 * (w483 - w148 * w420))
    w493 = w112 * w478 + w142 * w480 + w111 * w481 + w492 - (w160 * w474 + w159 * w470 + w157 * w440 + w173 * w457 + w165 * w460 + w162 * w463 + w161 * w466)
    w494 = w168 * c60 + (w473 * (w134 * w426 - w488) + w468 * (w142 * w420 - w482) + w437 * (w118 * w423 - w491))
    w495 = w118 * w478 + w134 * w480 + w142 * w481 + w494 - (w170 * w474 + w169 * w470 + w168 * w440 + w175 * w457 + w173 * w460 + w172 * w463 + w171 * w466)
    w496 = w17 * w343 - w22 * w342
    w497 = w22 * w345 - w10 * w343
    w498 = 2 * height_travel_dot
    w499 = w10 * w342 - w17 * w345
    w500 = c73 - w437 - w341 - (height_travel * (w342 * w496 - w345 * w497) + w498 * w499 + w214 * w292 + w179 * w293) * c50
    w501 = w376 + w468 + (height_travel * (w343 * w497 - w342 * w499) + w496 * w498 + w215 * w292 + w183 * w293) * c50
    w502 = w472 + w106 * w475 + w110 * w486 + w141 * w490 + w156 * w493 - w167 * w495 - w179 * w500 + w183 * w501
    w503 = w380 + w473 + (height_travel * (w345 * w499 - w343 * w496) + w497 * w498 + w216 * w292 + w186 * w293) * c50
    w504 = w329 + (w328 + slider_e1_dot * w335 + w217 * slider_e2_dot)
    w505 = w504 * c52
    w506 = w326 + (w324 + w218 * slider_e1_dot) + w189 * slider_e3_dot
    w507 = w506 * c51
    w508 = w505 * w506 - w504 * w507
    w509 = w334 + w325 * slider_e2_dot + w188 * slider_e3_dot
    w510 = w509 * c54
    w511 = w504 * w510 - w505 * w509
    w512 = w507 * w509 - w506 * w510
    w513 = w217 * w425
    w514 = w473 * (w513 - w190 * w422) + w468 * (w190 * w419 - w335 * w425) + w437 * (w335 * w422 - w217 * w419)
    w515 = w217 * w319
    w516 = w380 * (w515 - w190 * w315) + w376 * (w190 * w311 - w319 * w335) + w341 * (w315 * w335 - w217 * w311)
    w517 = w502 + w186 * w503 + (w188 * w508 + w189 * w511 + w190 * w512 - (w514 + w516) + (w219 * w292 + w192 * w293))
    w518 = w12 * w282 + w3 * w287 + w195 * w288 + (w12 * w289 - w3 * w290) * c60 + (w221 * w292 + w196 * w293)
    w519 = w518 + w197 * w374 + w198 * w379 + w199 * w382 + w88 * w393 + w76 * w397 + w61 * w400 + w31 * w402
    w520 = w519 + w205 * w467 + w206 * w471 + w207 * w475 + w167 * w486 - w156 * w490 + w141 * w493 + w110 * w495
    w521 = w473 * (w188 * w425 - w218 * w422) + w468 * (w218 * w419 - w513) + w437 * (w217 * w422 - w188 * w419)
    w522 = w380 * (w188 * w319 - w218 * w315) + w376 * (w218 * w311 - w515) + w341 * (w217 * w315 - w188 * w311)
    w523 = w520 - w214 * w500 + w215 * w501 + w216 * w503 + (w217 * w508 + w188 * w511 + w218 * w512 - (w521 + w522) + (w226 * w292 + w219 * w293))
    M_hat = ca.vertcat(
        w2 * (w2 * (w181 + w183 * w184 + w186 * w187 + w192)) - (w227 + w194 * w220),
        w231,
        w251,
        w271,
        w231,
        w22 * w228 + w10 * w229 + w17 * w230,
        0.0,
        0.0,
        w251,
        0.0,
        w272,
        0.0,
        w271,
        0.0,
        0.0,
        w273,
    )
    M_hat = ca.reshape(M_hat, 4, 4)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w2 * w517 - w194 * w523,
        w22 * w500 - w10 * w501 - w17 * w503,
        w238 * w486 + w241 * w490 + w244 * w493 - w247 * w495,
        w258 * w393 + w261 * w397 + w263 * w400 + w266 * w402,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 98 operations."""
    q_i = ca.SX.sym("q_i", 4)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    c6 = c[6]
    c7 = c[7]
    c20 = c[20]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    c35 = c[35]
    c44 = c[44]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = ca.sin(w0)
    w3 = w2**2
    w4 = right_swing_angle / 2.0
    w5 = ca.cos(w4)
    w6 = ca.sin(w4)
    w7 = left_swing_angle / 2.0
    w8 = ca.sin(w7)
    w9 = ca.cos(w7)
    w10 = w1 * w2
    w11 = w1 * w5
    w12 = w2 * w6
    w13 = w1 * w6
    w14 = w2 * w5
    w15 = w1 * w8
    w16 = w2 * w9
    w17 = w1 * w9
    w18 = w2 * w8
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w1,
        0.0,
        0.0,
        w2,
        0.0,
        0.0,
        height_travel,
        w1,
        0.0,
        0.0,
        w2,
        c28 - w3 * c74,
        w10 * c74,
        c29,
        w11 * c35 - w12 * c75,
        w12 * c44 - w11 * c76,
        w13 * c77 - w14 * c76,
        w13 * c75 + w14 * c35,
        c6 - w3 * c78,
        w10 * c78,
        c7,
        w15 * c79 - w16 * c24,
        w15 * c20 - w16 * c80,
        w17 * c80 + w18 * c20,
        w17 * c24 + w18 * c79,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 354 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c20 = c[20]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c44 = c[44]
    w0 = spin_angle / 2.0
    w1 = ca.sin(w0) / 2.0 * spin_angle_dot
    w2 = -w1
    w3 = spin_angle_dot * (ca.cos(w0) / 2.0)
    w4 = 2 * shaft_e2
    w5 = 2 * shaft_e0
    w6 = w4 * shaft_e3 - w5 * shaft_e1
    w7 = height_travel * w6
    w8 = shaft_e3 * -2.0
    w9 = 2 * shaft_e2**2
    w10 = 1.0 - 2 * shaft_e1**2 - w9
    w11 = height_travel * w10
    w12 = shaft_e2 * -2.0
    w13 = shaft_e1 * -2.0
    w14 = w11 * w13
    w15 = shaft_e2 * w5
    w16 = 2 * shaft_e1
    w17 = shaft_e3 * w16
    w18 = w15 + w17
    w19 = height_travel * w18
    w20 = w17 - w15
    w21 = w20 * c28 + w10 * c29
    w22 = w13 * w21
    w23 = shaft_e3 * w5 + shaft_e2 * w16
    w24 = w23 * c28 + w6 * c29
    w25 = 1.0 - w9 - 2 * shaft_e3**2
    w26 = w25 * c28 + w18 * c29
    w27 = right_swing_angle / 2.0
    w28 = ca.cos(w27)
    w29 = w28 * c35
    w30 = ca.sin(w27)
    w31 = w30 * c31 * c32 - w30 * c33 * c34
    w32 = w30 / 2.0
    w33 = w32 * c35
    w34 = w32 * c31 * c34 - w32 * c33 * c32
    w35 = w28 / 2.0
    w36 = w35 * c44
    w37 = w35 * c31 * c32 - w35 * c33 * c34
    w38 = w1 * w29 + w3 * w31 + (shaft_e0 * w33 + (shaft_e1 * w34 - shaft_e2 * w36 + shaft_e3 * w37)) * right_swing_angle_dot
    w39 = w30 * c44
    w40 = w28 * c33 * c32 - w28 * c31 * c34
    w41 = w3 * w39 - w1 * w40 + right_swing_angle_dot * (shaft_e0 * w34 - shaft_e1 * w33 + (shaft_e2 * w37 + shaft_e3 * w36))
    w42 = w1 * w39 + w3 * w40 + right_swing_angle_dot * (shaft_e3 * w34 - shaft_e1 * w37 - (shaft_e0 * w36 + shaft_e2 * w33))
    w43 = w3 * w29 - w1 * w31 + right_swing_angle_dot * (shaft_e0 * w37 - shaft_e3 * w33 - (shaft_e1 * w36 + shaft_e2 * w34))
    w44 = w20 * c6 + w10 * c7
    w45 = w13 * w44
    w46 = w23 * c6 + w6 * c7
    w47 = w25 * c6 + w18 * c7
    w48 = left_swing_angle / 2.0
    w49 = ca.cos(w48)
    w50 = w49 / 2.0
    w51 = w50 * c9 * c10 - w50 * c11 * c12
    w52 = w50 * c20
    w53 = ca.sin(w48)
    w54 = w53 / 2.0
    w55 = w54 * c11 * c10 - w54 * c9 * c12
    w56 = w54 * c24
    w57 = w53 * c9 * c10 - w53 * c11 * c12
    w58 = w49 * c24
    w59 = (shaft_e0 * w51 - (shaft_e1 * w52 + shaft_e2 * w55 - shaft_e3 * w56)) * left_swing_angle_dot - (w1 * w57 + w3 * w58)
    w60 = w53 * c20
    w61 = w49 * c9 * c12 - w49 * c11 * c10
    w62 = left_swing_angle_dot * (shaft_e0 * w52 + shaft_e1 * w51 - (shaft_e2 * w56 + shaft_e3 * w55)) - (w1 * w60 + w3 * w61)
    w63 = w3 * w60 - w1 * w61 + left_swing_angle_dot * (shaft_e0 * w55 + shaft_e2 * w51 + (shaft_e3 * w52 + shaft_e1 * w56))
    w64 = w3 * w57 - w1 * w58 + left_swing_angle_dot * (shaft_e3 * w51 - shaft_e0 * w56 + (shaft_e1 * w55 - shaft_e2 * w52))
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w2,
        0.0,
        0.0,
        w3,
        w1 * (w7 * w8 - w11 * w12) - w3 * (w5 * w7 - w14) + w18 * height_travel_dot,
        w1 * (w14 - w8 * w19) - w3 * (w4 * w11 - w5 * w19) + w6 * height_travel_dot,
        w1 * (w12 * w19 - w7 * w13) - w3 * (w13 * w19 - w4 * w7) + w10 * height_travel_dot,
        w2,
        0.0,
        0.0,
        w3,
        w3 * (w22 - w5 * w24) - w1 * (w12 * w21 - w8 * w24),
        w3 * (w5 * w26 - w4 * w21) - w1 * (w8 * w26 - w22),
        w3 * (w4 * w24 - w13 * w26) - w1 * (w13 * w24 - w12 * w26),
        -w38,
        w41,
        w42,
        w43,
        w3 * (w45 - w5 * w46) - w1 * (w12 * w44 - w8 * w46),
        w3 * (w5 * w47 - w4 * w44) - w1 * (w8 * w47 - w45),
        w3 * (w4 * w46 - w13 * w47) - w1 * (w13 * w46 - w12 * w47),
        w59,
        w62,
        w63,
        w64,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 659 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 28)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_e0_dot = q_d_dot[3]
    shaft_e1_dot = q_d_dot[4]
    shaft_e2_dot = q_d_dot[5]
    shaft_e3_dot = q_d_dot[6]
    spin_angle_ddot = q_i_ddot[0]
    height_travel_ddot = q_i_ddot[1]
    right_swing_angle_ddot = q_i_ddot[2]
    left_swing_angle_ddot = q_i_ddot[3]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c20 = c[20]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c44 = c[44]
    w0 = (spin_angle_dot / 2.0)**2
    w1 = spin_angle / 2.0
    w2 = ca.cos(w1)
    w3 = ca.sin(w1)
    w4 = w0 * w2 + w3 / 2.0 * spin_angle_ddot
    w5 = -w4
    w6 = spin_angle_ddot * (w2 / 2.0) - w0 * w3
    w7 = shaft_e2 * -2.0
    w8 = 2 * shaft_e0
    w9 = shaft_e1 * -2.0
    w10 = shaft_e0_dot * w7 + shaft_e1_dot * (2 * shaft_e3) + shaft_e2_dot * w8 + shaft_e3_dot * w9
    w11 = shaft_e3 * -2.0
    w12 = 2 * shaft_e2
    w13 = shaft_e0_dot * w9 + shaft_e1_dot * w8 + shaft_e2_dot * w11 + shaft_e3_dot * w12
    w14 = shaft_e3 * w12 - w8 * shaft_e1
    w15 = shaft_e2 * w8
    w16 = 2 * shaft_e1
    w17 = shaft_e3 * w16
    w18 = w15 + w17
    w19 = w13 * w14 - w10 * w18
    w20 = shaft_e0_dot * w11 + w7 * shaft_e1_dot + shaft_e2_dot * w16 + w8 * shaft_e3_dot
    w21 = 2 * shaft_e2**2
    w22 = 1.0 - 2 * shaft_e1**2 - w21
    w23 = w18 * w20 - w13 * w22
    w24 = 2 * height_travel_dot
    w25 = w10 * w22 - w14 * w20
    w26 = w14 * height_travel
    w27 = w22 * height_travel
    w28 = w9 * w27
    w29 = (w10 * w19 - w20 * w23) * height_travel + w24 * w25 + w4 * (w11 * w26 - w7 * w27) - w6 * (w8 * w26 - w28)
    w30 = w18 * height_travel
    w31 = height_travel * (w20 * w25 - w13 * w19) + w23 * w24 + w4 * (w28 - w11 * w30) - w6 * (w12 * w27 - w8 * w30)
    w32 = height_travel * (w13 * w23 - w10 * w25) + w19 * w24 + w4 * (w7 * w30 - w9 * w26) - w6 * (w9 * w30 - w12 * w26)
    w33 = shaft_e3 * w8 + shaft_e2 * w16
    w34 = w33 * c28 + w14 * c29
    w35 = 1.0 - w21 - 2 * shaft_e3**2
    w36 = w35 * c28 + w18 * c29
    w37 = w13 * w34 - w10 * w36
    w38 = w17 - w15
    w39 = w38 * c28 + w22 * c29
    w40 = w20 * w36 - w13 * w39
    w41 = w9 * w39
    w42 = w10 * w39 - w20 * w34
    w43 = (right_swing_angle_dot / 2.0)**2
    w44 = right_swing_angle / 2.0
    w45 = ca.cos(w44)
    w46 = w43 * w45
    w47 = w46 * c35
    w48 = w46 * c31 * c34 - w46 * c33 * c32
    w49 = ca.sin(w44)
    w50 = w43 * w49
    w51 = w50 * c44
    w52 = w50 * c33 * c34 - w50 * c31 * c32
    w53 = w49 / 2.0
    w54 = right_swing_angle_dot * w53
    w55 = w54 * c35
    w56 = w54 * c31 * c34 - w54 * c33 * c32
    w57 = w45 / 2.0
    w58 = right_swing_angle_dot * w57
    w59 = w58 * c44
    w60 = w58 * c31 * c32 - w58 * c33 * c34
    w61 = shaft_e0_dot * w55 + (shaft_e1_dot * w56 - shaft_e2_dot * w59 + shaft_e3_dot * w60)
    w62 = w45 * c35
    w63 = w49 * c31 * c32 - w49 * c33 * c34
    w64 = w61 + (shaft_e0 * w47 + (shaft_e1 * w48 + shaft_e2 * w51 + shaft_e3 * w52) + w61) + w4 * w62 + w6 * w63
    w65 = w53 * c35
    w66 = w53 * c31 * c34 - w53 * c33 * c32
    w67 = w57 * c44
    w68 = w57 * c31 * c32 - w57 * c33 * c34
    w69 = w64 + (shaft_e0 * w65 + (shaft_e1 * w66 - shaft_e2 * w67 + shaft_e3 * w68)) * right_swing_angle_ddot
    w70 = shaft_e0_dot * w56 - shaft_e1_dot * w55 + (shaft_e2_dot * w60 + shaft_e3_dot * w59)
    w71 = w45 * c33 * c32 - w45 * c31 * c34
    w72 = w49 * c44
    w73 = w70 + (shaft_e0 * w48 - shaft_e1 * w47 + (shaft_e2 * w52 - shaft_e3 * w51) + w70) - w4 * w71 + w6 * w72
    w74 = w73 + right_swing_angle_ddot * (shaft_e0 * w66 - shaft_e1 * w65 + (shaft_e2 * w68 + shaft_e3 * w67))
    w75 = shaft_e3_dot * w56 - shaft_e1_dot * w60 - (shaft_e0_dot * w59 + shaft_e2_dot * w55)
    w76 = w75 + (shaft_e0 * w51 - shaft_e2 * w47 + (shaft_e3 * w48 - shaft_e1 * w52) + w75) + w4 * w72 + w6 * w71
    w77 = w76 + right_swing_angle_ddot * (shaft_e3 * w66 - shaft_e1 * w68 - (shaft_e0 * w67 + shaft_e2 * w65))
    w78 = shaft_e0_dot * w60 - shaft_e3_dot * w55 - (shaft_e1_dot * w59 + shaft_e2_dot * w56)
    w79 = w78 + (shaft_e0 * w52 - shaft_e3 * w47 + (shaft_e1 * w51 - shaft_e2 * w48) + w78) - w4 * w63 + w6 * w62
    w80 = w79 + right_swing_angle_ddot * (shaft_e0 * w68 - shaft_e3 * w65 - (shaft_e1 * w67 + shaft_e2 * w66))
    w81 = w33 * c6 + w14 * c7
    w82 = w35 * c6 + w18 * c7
    w83 = w13 * w81 - w10 * w82
    w84 = w38 * c6 + w22 * c7
    w85 = w20 * w82 - w13 * w84
    w86 = w9 * w84
    w87 = w10 * w84 - w20 * w81
    w88 = (left_swing_angle_dot / 2.0)**2
    w89 = left_swing_angle / 2.0
    w90 = ca.sin(w89)
    w91 = w88 * w90
    w92 = w91 * c11 * c12 - w91 * c9 * c10
    w93 = ca.cos(w89)
    w94 = w88 * w93
    w95 = w94 * c11 * c10 - w94 * c9 * c12
    w96 = w91 * c20
    w97 = w94 * c24
    w98 = w93 / 2.0
    w99 = left_swing_angle_dot * w98
    w100 = w99 * c9 * c10 - w99 * c11 * c12
    w101 = w99 * c20
    w102 = w90 / 2.0
    w103 = left_swing_angle_dot * w102
    w104 = w103 * c11 * c10 - w103 * c9 * c12
    w105 = w103 * c24
    w106 = shaft_e0_dot * w100 - (shaft_e1_dot * w101 + shaft_e2_dot * w104 - shaft_e3_dot * w105)
    w107 = w90 * c9 * c10 - w90 * c11 * c12
    w108 = w93 * c24
    w109 = w106 + (shaft_e0 * w92 - (shaft_e2 * w95 - shaft_e1 * w96 - shaft_e3 * w97) + w106) - w4 * w107 - w6 * w108
    w110 = w98 * c9 * c10 - w98 * c11 * c12
    w111 = w98 * c20
    w112 = w102 * c11 * c10 - w102 * c9 * c12
    w113 = w102 * c24
    w114 = (shaft_e0 * w110 - (shaft_e1 * w111 + shaft_e2 * w112 - shaft_e3 * w113)) * left_swing_angle_ddot
    w115 = shaft_e0_dot * w101 + shaft_e1_dot * w100 - (shaft_e2_dot * w105 + shaft_e3_dot * w104)
    w116 = w90 * c20
    w117 = w93 * c9 * c12 - w93 * c11 * c10
    w118 = w115 + (shaft_e1 * w92 - shaft_e0 * w96 - (shaft_e2 * w97 + shaft_e3 * w95) + w115) - w4 * w116 - w6 * w117
    w119 = left_swing_angle_ddot * (shaft_e0 * w111 + shaft_e1 * w110 - (shaft_e2 * w113 + shaft_e3 * w112))
    w120 = shaft_e0_dot * w104 + shaft_e2_dot * w100 + (shaft_e3_dot * w101 + shaft_e1_dot * w105)
    w121 = w120 + (shaft_e0 * w95 + shaft_e2 * w92 + (shaft_e1 * w97 - shaft_e3 * w96) + w120) - w4 * w117 + w6 * w116
    w122 = left_swing_angle_ddot * (shaft_e0 * w112 + shaft_e2 * w110 + (shaft_e3 * w111 + shaft_e1 * w113))
    w123 = shaft_e3_dot * w100 - shaft_e0_dot * w105 + (shaft_e1_dot * w104 - shaft_e2_dot * w101)
    w124 = w123 + (shaft_e3 * w92 - shaft_e0 * w97 + (shaft_e1 * w95 + shaft_e2 * w96) + w123) - w4 * w108 + w6 * w107
    w125 = left_swing_angle_ddot * (shaft_e3 * w110 - shaft_e0 * w113 + (shaft_e1 * w112 - shaft_e2 * w111))
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w5,
        0.0,
        0.0,
        w6,
        w29 + w18 * height_travel_ddot,
        w31 + w14 * height_travel_ddot,
        w32 + w22 * height_travel_ddot,
        w5,
        0.0,
        0.0,
        w6,
        w10 * w37 - w20 * w40 - w4 * (w7 * w39 - w11 * w34) + w6 * (w41 - w8 * w34),
        w20 * w42 - w13 * w37 - w4 * (w11 * w36 - w41) + w6 * (w8 * w36 - w12 * w39),
        w13 * w40 - w10 * w42 - w4 * (w9 * w34 - w7 * w36) + w6 * (w12 * w34 - w9 * w36),
        -w69,
        w74,
        w77,
        w80,
        w10 * w83 - w20 * w85 - w4 * (w7 * w84 - w11 * w81) + w6 * (w86 - w8 * w81),
        w20 * w87 - w13 * w83 - w4 * (w11 * w82 - w86) + w6 * (w8 * w82 - w12 * w84),
        w13 * w85 - w10 * w87 - w4 * (w9 * w81 - w7 * w82) + w6 * (w12 * w81 - w9 * w82),
        w109 + w114,
        w118 + w119,
        w121 + w122,
        w124 + w125,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 1745 operations."""
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 125)
    shaft_x = q[0]
    shaft_y = q[1]
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    spin_angle = q[28]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    spin_angle_dot = q_dot[28]
    height_travel_dot = q_dot[29]
    right_swing_angle_dot = q_dot[30]
    left_swing_angle_dot = q_dot[31]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c20 = c[20]
    c24 = c[24]
    c28 = c[28]
    c29 = c[29]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c44 = c[44]
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = ca.sin(w0)
    w3 = 2 * shaft_e0
    w4 = shaft_e2 * w3
    w5 = 2 * shaft_e1
    w6 = shaft_e3 * w5
    w7 = w4 + w6
    w8 = height_travel * w7
    w9 = 2 * shaft_e2
    w10 = shaft_e3 * w9 - shaft_e1 * w3
    w11 = height_travel * w10
    w12 = 2 * shaft_e2**2
    w13 = 1.0 - 2 * shaft_e1**2 - w12
    w14 = height_travel * w13
    w15 = right_swing_angle / 2.0
    w16 = ca.cos(w15)
    w17 = w16 * c35
    w18 = w16 * c33 * c32 - w16 * c31 * c34
    w19 = ca.sin(w15)
    w20 = w19 * c44
    w21 = w19 * c31 * c32 - w19 * c33 * c34
    w22 = 1.0 - w12 - 2 * shaft_e3**2
    w23 = w22 * c28 + w7 * c29
    w24 = shaft_e3 * w3 + shaft_e2 * w5
    w25 = w24 * c28 + w10 * c29
    w26 = w6 - w4
    w27 = w26 * c28 + w13 * c29
    w28 = left_swing_angle / 2.0
    w29 = ca.sin(w28)
    w30 = w29 * c9 * c10 - w29 * c11 * c12
    w31 = w29 * c20
    w32 = ca.cos(w28)
    w33 = w32 * c9 * c12 - w32 * c11 * c10
    w34 = w32 * c24
    w35 = w22 * c6 + w7 * c7
    w36 = w24 * c6 + w10 * c7
    w37 = w26 * c6 + w13 * c7
    w38 = shaft_e3 * -2.0
    w39 = w11 * w38
    w40 = shaft_e2 * -2.0
    w41 = shaft_e1 * -2.0
    w42 = w14 * w41
    w43 = w8 * w40
    w44 = -w17
    w45 = -w18
    w46 = -w21
    w47 = w25 * w38
    w48 = w27 * w41
    w49 = w23 * w40
    w50 = -w30
    w51 = -w31
    w52 = -w33
    w53 = -w34
    w54 = w36 * w38
    w55 = w37 * w41
    w56 = w35 * w40
    w57 = 2 * shaft_e3
    w58 = w3 * w14
    w59 = w3 * w11
    w60 = w3 * w27
    w61 = w3 * w25
    w62 = w3 * w37
    w63 = w3 * w36
    w64 = w3 * w8
    w65 = -w20
    w66 = w3 * w23
    w67 = w3 * w35
    w68 = w19 / 2.0
    w69 = w68 * c35
    w70 = w68 * c31 * c34 - w68 * c33 * c32
    w71 = w16 / 2.0
    w72 = w71 * c44
    w73 = w71 * c31 * c32 - w71 * c33 * c34
    w74 = w32 / 2.0
    w75 = w74 * c9 * c10 - w74 * c11 * c12
    w76 = w74 * c20
    w77 = w29 / 2.0
    w78 = w77 * c11 * c10 - w77 * c9 * c12
    w79 = w77 * c24
    w80 = (spin_angle_dot / 2.0)**2
    w81 = w40 * shaft_e0_dot + w57 * shaft_e1_dot + w3 * shaft_e2_dot + w41 * shaft_e3_dot
    w82 = w41 * shaft_e0_dot + w3 * shaft_e1_dot + w38 * shaft_e2_dot + w9 * shaft_e3_dot
    w83 = w10 * w82 - w7 * w81
    w84 = w38 * shaft_e0_dot + w40 * shaft_e1_dot + w5 * shaft_e2_dot + w3 * shaft_e3_dot
    w85 = w7 * w84 - w13 * w82
    w86 = 2 * height_travel_dot
    w87 = w13 * w81 - w10 * w84
    w88 = right_swing_angle_dot / 2.0
    w89 = w88**2
    w90 = w16 * w89
    w91 = w88 * (w16 * w88) * c35
    w92 = w90 * c31 * c34 - w90 * c33 * c32
    w93 = w19 * w89
    w94 = w88 * (w19 * w88) * c44
    w95 = w93 * c33 * c34 - w93 * c31 * c32
    w96 = w68 * right_swing_angle_dot
    w97 = w96 * c35
    w98 = w96 * c31 * c34 - w96 * c33 * c32
    w99 = w71 * right_swing_angle_dot
    w100 = w99 * c44
    w101 = w99 * c31 * c32 - w99 * c33 * c34
    w102 = shaft_e0_dot * w97 + (shaft_e1_dot * w98 - shaft_e2_dot * w100 + shaft_e3_dot * w101)
    w103 = shaft_e0_dot * w98 - shaft_e1_dot * w97 + (shaft_e2_dot * w101 + shaft_e3_dot * w100)
    w104 = shaft_e3_dot * w98 - shaft_e1_dot * w101 - (shaft_e0_dot * w100 + shaft_e2_dot * w97)
    w105 = shaft_e0_dot * w101 - shaft_e3_dot * w97 - (shaft_e1_dot * w100 + shaft_e2_dot * w98)
    w106 = w25 * w82 - w23 * w81
    w107 = w23 * w84 - w27 * w82
    w108 = w27 * w81 - w25 * w84
    w109 = left_swing_angle_dot / 2.0
    w110 = w109**2
    w111 = w29 * w110
    w112 = w111 * c11 * c12 - w111 * c9 * c10
    w113 = w32 * w110
    w114 = w113 * c11 * c10 - w113 * c9 * c12
    w115 = w109 * (w29 * w109) * c20
    w116 = w109 * (w32 * w109) * c24
    w117 = w74 * left_swing_angle_dot
    w118 = w117 * c9 * c10 - w117 * c11 * c12
    w119 = w117 * c20
    w120 = w77 * left_swing_angle_dot
    w121 = w120 * c11 * c10 - w120 * c9 * c12
    w122 = w120 * c24
    w123 = shaft_e0_dot * w118 - (shaft_e1_dot * w119 + shaft_e2_dot * w121 - shaft_e3_dot * w122)
    w124 = shaft_e0_dot * w119 + shaft_e1_dot * w118 - (shaft_e2_dot * w122 + shaft_e3_dot * w121)
    w125 = shaft_e0_dot * w121 + shaft_e2_dot * w118 + (shaft_e3_dot * w119 + shaft_e1_dot * w122)
    w126 = shaft_e3_dot * w118 - shaft_e0_dot * w122 + (shaft_e1_dot * w121 - shaft_e2_dot * w119)
    w127 = w36 * w82 - w35 * w81
    w128 = w35 * w84 - w37 * w82
    w129 = w37 * w81 - w36 * w84
    C = ca.vertcat(
        shaft_e0 - w1,
        shaft_e1,
        shaft_e2,
        shaft_e3 - w2,
        shaft_x,
        shaft_y,
        shaft_z,
        slider_e0 - shaft_e0,
        slider_e1 - shaft_e1,
        slider_e2 - shaft_e2,
        slider_e3 - shaft_e3,
        slider_x - shaft_x - w8,
        slider_y - shaft_y - w11,
        slider_z - shaft_z - w14,
        right_rod_e0 - (shaft_e0 * w17 - (shaft_e1 * w18 - shaft_e2 * w20 + shaft_e3 * w21)),
        right_rod_e1 - (shaft_e0 * w18 + shaft_e1 * w17 + (shaft_e2 * w21 + shaft_e3 * w20)),
        right_rod_e2 - (shaft_e2 * w17 - shaft_e0 * w20 + (shaft_e3 * w18 - shaft_e1 * w21)),
        right_rod_e3 - (shaft_e0 * w21 + shaft_e3 * w17 - (shaft_e1 * w20 + shaft_e2 * w18)),
        right_rod_x - (shaft_x + w23),
        right_rod_y - (shaft_y + w25),
        right_rod_z - (shaft_z + w27),
        left_rod_e0 - (shaft_e0 * w30 - (shaft_e1 * w31 + shaft_e2 * w33 + shaft_e3 * w34)),
        left_rod_e1 - (shaft_e0 * w31 + shaft_e1 * w30 + (shaft_e2 * w34 - shaft_e3 * w33)),
        left_rod_e2 - (shaft_e0 * w33 + shaft_e2 * w30 + (shaft_e3 * w31 - shaft_e1 * w34)),
        left_rod_e3 - (shaft_e0 * w34 + shaft_e3 * w30 + (shaft_e1 * w33 - shaft_e2 * w31)),
        left_rod_x - (shaft_x + w35),
        left_rod_y - (shaft_y + w36),
        left_rod_z - (shaft_z + w37),
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
        -1.0,
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
        -1.0,
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
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
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
        w39 - w14 * w40,
        w42 - w8 * w38,
        w43 - w11 * w41,
        w44,
        w45,
        w20,
        w46,
        -(w27 * w40 - w47),
        -(w23 * w38 - w48),
        -(w25 * w41 - w49),
        w50,
        w51,
        w52,
        w53,
        -(w37 * w40 - w54),
        -(w35 * w38 - w55),
        -(w36 * w41 - w56),
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
        w11 * w40 - w14 * w57,
        w58 - w43,
        w8 * w57 - w59,
        w18,
        w44,
        w21,
        w20,
        -(w27 * w57 - w25 * w40),
        -(w49 - w60),
        -(w61 - w23 * w57),
        w31,
        w50,
        w34,
        w52,
        -(w37 * w57 - w36 * w40),
        -(w56 - w62),
        -(w63 - w35 * w57),
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
        w5 * w11 - w58,
        w14 * w38 - w5 * w8,
        w64 - w39,
        w65,
        w46,
        w44,
        w18,
        -(w60 - w5 * w25),
        -(w5 * w23 - w27 * w38),
        -(w47 - w66),
        w33,
        w53,
        w50,
        w31,
        -(w62 - w5 * w36),
        -(w5 * w35 - w37 * w38),
        -(w54 - w67),
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
        w59 - w42,
        w9 * w14 - w64,
        w8 * w41 - w9 * w11,
        w21,
        w65,
        w45,
        w44,
        -(w48 - w61),
        -(w66 - w9 * w27),
        -(w9 * w25 - w23 * w41),
        w34,
        w33,
        w51,
        w50,
        -(w55 - w63),
        -(w67 - w9 * w37),
        -(w9 * w36 - w35 * w41),
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w2 / 2.0,
        0.0,
        0.0,
        -(w1 / 2.0),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w7,
        -w10,
        -w13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        shaft_e0 * w69 + (shaft_e1 * w70 - shaft_e2 * w72 + shaft_e3 * w73),
        -(shaft_e0 * w70 - shaft_e1 * w69 + (shaft_e2 * w73 + shaft_e3 * w72)),
        -(shaft_e3 * w70 - shaft_e1 * w73 - (shaft_e0 * w72 + shaft_e2 * w69)),
        -(shaft_e0 * w73 - shaft_e3 * w69 - (shaft_e1 * w72 + shaft_e2 * w70)),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(shaft_e0 * w75 - (shaft_e1 * w76 + shaft_e2 * w78 - shaft_e3 * w79)),
        -(shaft_e0 * w76 + shaft_e1 * w75 - (shaft_e2 * w79 + shaft_e3 * w78)),
        -(shaft_e0 * w78 + shaft_e2 * w75 + (shaft_e3 * w76 + shaft_e1 * w79)),
        -(shaft_e3 * w75 - shaft_e0 * w79 + (shaft_e1 * w78 - shaft_e2 * w76)),
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 28, 32)
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
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        -(w1 * w80),
        0.0,
        0.0,
        -(w2 * w80),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        height_travel * (w81 * w83 - w84 * w85) + w86 * w87,
        height_travel * (w84 * w87 - w82 * w83) + w85 * w86,
        height_travel * (w82 * w85 - w81 * w87) + w83 * w86,
        -(w102 + (shaft_e0 * w91 + (shaft_e1 * w92 + shaft_e2 * w94 + shaft_e3 * w95) + w102)),
        w103 + (shaft_e0 * w92 - shaft_e1 * w91 + (shaft_e2 * w95 - shaft_e3 * w94) + w103),
        w104 + (shaft_e0 * w94 - shaft_e2 * w91 + (shaft_e3 * w92 - shaft_e1 * w95) + w104),
        w105 + (shaft_e0 * w95 - shaft_e3 * w91 + (shaft_e1 * w94 - shaft_e2 * w92) + w105),
        w81 * w106 - w84 * w107,
        w84 * w108 - w82 * w106,
        w82 * w107 - w81 * w108,
        w123 + (shaft_e0 * w112 - (shaft_e2 * w114 - shaft_e1 * w115 - shaft_e3 * w116) + w123),
        w124 + (shaft_e1 * w112 - shaft_e0 * w115 - (shaft_e2 * w116 + shaft_e3 * w114) + w124),
        w125 + (shaft_e0 * w114 + shaft_e2 * w112 + (shaft_e1 * w116 - shaft_e3 * w115) + w125),
        w126 + (shaft_e3 * w112 - shaft_e0 * w116 + (shaft_e1 * w114 + shaft_e2 * w115) + w126),
        w81 * w127 - w84 * w128,
        w84 * w129 - w82 * w127,
        w82 * w128 - w81 * w129,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 4924 operations."""
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 125)
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    spin_angle = q[28]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    spin_angle_dot = q_dot[28]
    height_travel_dot = q_dot[29]
    right_swing_angle_dot = q_dot[30]
    left_swing_angle_dot = q_dot[31]
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
    w0 = shaft_e2 * -2.0
    w1 = 1.0 - 2 * shaft_e1**2
    w2 = 2 * shaft_e2**2
    w3 = w1 - w2
    w4 = w3 * c59
    w5 = shaft_e3 * -2.0
    w6 = 2 * shaft_e2
    w7 = shaft_e3 * w6
    w8 = 2 * shaft_e0
    w9 = shaft_e1 * w8
    w10 = w7 - w9
    w11 = w10 * c59
    w12 = w5 * w11
    w13 = w0 * w4 - w12
    w14 = 2 * shaft_e3
    w15 = w4 * w14 - w0 * w11
    w16 = w4 * w8
    w17 = 2 * shaft_e1
    w18 = w16 - w11 * w17
    w19 = shaft_e1 * -2.0
    w20 = w4 * w19
    w21 = w8 * w11
    w22 = w20 - w21
    w23 = shaft_e2 * w8
    w24 = shaft_e3 * w17
    w25 = w23 + w24
    w26 = w25 * c59
    w27 = w5 * w26 - w20
    w28 = w0 * w26
    w29 = w28 - w16
    w30 = w17 * w26 - w4 * w5
    w31 = w8 * w26
    w32 = w31 - w4 * w6
    w33 = w11 * w19 - w28
    w34 = w21 - w14 * w26
    w35 = w12 - w31
    w36 = w6 * w11 - w19 * w26
    w37 = w8 * c2
    w38 = w19 * w37 + shaft_e2 * shaft_e3 * c82
    w39 = w8 * c4
    w40 = w19 * c5
    w41 = w0 * w39 + shaft_e1 * shaft_e3 * c83
    w42 = w0 * c2
    w43 = w17 * c4
    w44 = w8 * c5
    w45 = shaft_e2 * shaft_e1 * c57 + w5 * w44
    w46 = shaft_e3 * shaft_e0 * c84 + w6 * w40
    w47 = w5 * w43 + shaft_e2 * shaft_e0 * c85
    w48 = w14 * w42 + shaft_e1 * shaft_e0 * c86
    w49 = slider_e1 * -2.0
    w50 = slider_e2 * -2.0
    w51 = slider_e3 * -2.0
    w52 = 2 * slider_e0
    w53 = w52 * c53
    w54 = 2 * slider_e2
    w55 = w49 * w53 + slider_e2 * slider_e3 * c87
    w56 = 2 * slider_e3
    w57 = w52 * c55
    w58 = w49 * c56
    w59 = w50 * w57 + slider_e1 * slider_e3 * c88
    w60 = w50 * c53
    w61 = 2 * slider_e1
    w62 = w61 * c55
    w63 = w52 * c56
    w64 = slider_e1 * slider_e2 * c58 + w51 * w63
    w65 = slider_e3 * slider_e0 * c89 + w54 * w58
    w66 = w51 * w62 + slider_e2 * slider_e0 * c90
    w67 = w56 * w60 + slider_e1 * slider_e0 * c91
    w68 = right_rod_e2 * -2.0
    w69 = 2 * right_rod_e1
    w70 = w69 * right_rod_e3
    w71 = 2 * right_rod_e0
    w72 = right_rod_e2 * w71
    w73 = w70 - w72
    w74 = w73 * c36
    w75 = right_rod_e3 * -2.0
    w76 = right_rod_e3 * w71
    w77 = right_rod_e2 * w69
    w78 = w76 + w77
    w79 = w78 * c36
    w80 = w75 * w79
    w81 = w68 * w74 - w80
    w82 = 2 * right_rod_e3
    w83 = w74 * w82 - w68 * w79
    w84 = w71 * w74
    w85 = w84 - w69 * w79
    w86 = right_rod_e1 * -2.0
    w87 = w74 * w86
    w88 = w71 * w79
    w89 = w87 - w88
    w90 = 2 * right_rod_e2**2
    w91 = 2 * right_rod_e3**2
    w92 = 1.0 - w90 - w91
    w93 = w92 * c36
    w94 = w75 * w93 - w87
    w95 = w68 * w93
    w96 = w95 - w84
    w97 = w69 * w93 - w74 * w75
    w98 = w71 * w93
    w99 = 2 * right_rod_e2
    w100 = w98 - w74 * w99
    w101 = w79 * w86 - w95
    w102 = w88 - w82 * w93
    w103 = w80 - w98
    w104 = w79 * w99 - w86 * w93
    w105 = w71 * c39
    w106 = w86 * w105 + right_rod_e2 * right_rod_e3 * c49
    w107 = w71 * c41
    w108 = w86 * c42
    w109 = w68 * w107 + right_rod_e1 * right_rod_e3 * c48
    w110 = w68 * c39
    w111 = w69 * c41
    w112 = w71 * c42
    w113 = right_rod_e2 * right_rod_e1 * c47 + w75 * w112
    w114 = right_rod_e3 * right_rod_e0 * c46 + w99 * w108
    w115 = w75 * w111 + right_rod_e2 * right_rod_e0 * c45
    w116 = w82 * w110 + right_rod_e1 * right_rod_e0 * c43
    w117 = left_rod_e2 * -2.0
    w118 = 2 * left_rod_e1
    w119 = w118 * left_rod_e3
    w120 = 2 * left_rod_e0
    w121 = left_rod_e2 * w120
    w122 = w119 - w121
    w123 = w122 * c13
    w124 = left_rod_e3 * -2.0
    w125 = left_rod_e3 * w120
    w126 = left_rod_e2 * w118
    w127 = w125 + w126
    w128 = w127 * c13
    w129 = w124 * w128
    w130 = w117 * w123 - w129
    w131 = 2 * left_rod_e3
    w132 = w123 * w131 - w117 * w128
    w133 = w120 * w123
    w134 = w133 - w118 * w128
    w135 = left_rod_e1 * -2.0
    w136 = w123 * w135
    w137 = w120 * w128
    w138 = w136 - w137
    w139 = 2 * left_rod_e2**2
    w140 = 2 * left_rod_e3**2
    w141 = 1.0 - w139 - w140
    w142 = w141 * c13
    w143 = w124 * w142 - w136
    w144 = w117 * w142
    w145 = w144 - w133
    w146 = w118 * w142 - w123 * w124
    w147 = w120 * w142
    w148 = 2 * left_rod_e2
    w149 = w147 - w123 * w148
    w150 = w128 * w135 - w144
    w151 = w137 - w131 * w142
    w152 = w129 - w147
    w153 = w128 * w148 - w135 * w142
    w154 = w120 * c16
    w155 = w135 * w154 + left_rod_e2 * left_rod_e3 * c27
    w156 = w120 * c18
    w157 = w135 * c19
    w158 = w117 * w156 + left_rod_e1 * left_rod_e3 * c26
    w159 = w117 * c16
    w160 = w118 * c18
    w161 = w120 * c19
    w162 = left_rod_e2 * left_rod_e1 * c25 + w124 * w161
    w163 = left_rod_e3 * left_rod_e0 * c23 + w148 * w157
    w164 = w124 * w160 + left_rod_e2 * left_rod_e0 * c22
    w165 = w131 * w159 + left_rod_e1 * left_rod_e0 * c21
    w166 = w0 * shaft_e0_dot
    w167 = w8 * shaft_e2_dot
    w168 = w166 + w5 * shaft_e1_dot + w167 + w17 * shaft_e3_dot
    w169 = w168 * c59
    w170 = w19 * shaft_e0_dot + w8 * shaft_e1_dot
    w171 = w170 + w14 * shaft_e2_dot + w0 * shaft_e3_dot
    w172 = w171 * c59
    w173 = w168 * w169 + w171 * w172
    w174 = 2 * shaft_e3**2
    w175 = 1.0 - w2 - w174
    w176 = w5 * shaft_e0_dot
    w177 = w8 * shaft_e3_dot
    w178 = w176 + w6 * shaft_e1_dot + w19 * shaft_e2_dot + w177
    w179 = w172 * w178
    w180 = shaft_e2 * w17
    w181 = shaft_e3 * w8
    w182 = w169 * w178
    w183 = w25 * w173 - (w175 * w179 + (w180 - w181) * w182)
    w184 = w180 + w181
    w185 = w10 * w173 - (w179 * w184 + w182 * (w1 - w174))
    w186 = w24 - w23
    w187 = w3 * w173 - (w179 * w186 + w182 * (w7 + w9))
    w188 = w178 * c1
    w189 = w168 * c0
    w190 = w168 * w188 - w178 * w189
    w191 = w171 * c3
    w192 = w178 * w191 - w171 * w188
    w193 = w171 * w189 - w168 * w191
    w194 = w19 * w190 + w0 * w192 + w5 * w193
    w195 = w8 * w190 + w5 * w192 + w6 * w193
    w196 = w14 * w190 + w8 * w192 + w19 * w193
    w197 = w0 * w190 + w17 * w192 + w8 * w193
    w198 = w51 * slider_e0_dot
    w199 = w52 * slider_e3_dot
    w200 = w198 + w54 * slider_e1_dot + w49 * slider_e2_dot + w199
    w201 = w200 * c52
    w202 = w50 * slider_e0_dot
    w203 = w52 * slider_e2_dot
    w204 = w202 + w51 * slider_e1_dot + w203 + w61 * slider_e3_dot
    w205 = w204 * c51
    w206 = w201 * w204 - w200 * w205
    w207 = w49 * slider_e0_dot + w52 * slider_e1_dot
    w208 = w207 + w56 * slider_e2_dot + w50 * slider_e3_dot
    w209 = w208 * c54
    w210 = w200 * w209 - w201 * w208
    w211 = w205 * w208 - w204 * w209
    w212 = w49 * w206 + w50 * w210 + w51 * w211
    w213 = w52 * w206 + w51 * w210 + w54 * w211
    w214 = w56 * w206 + w52 * w210 + w49 * w211
    w215 = w50 * w206 + w61 * w210 + w52 * w211
    w216 = w75 * right_rod_e0_dot
    w217 = w71 * right_rod_e3_dot
    w218 = w216 + w99 * right_rod_e1_dot + w86 * right_rod_e2_dot + w217
    w219 = w218 * c36
    w220 = w68 * right_rod_e0_dot
    w221 = w71 * right_rod_e2_dot
    w222 = w220 + w75 * right_rod_e1_dot + w221 + w69 * right_rod_e3_dot
    w223 = w222 * c36
    w224 = w218 * w219 + w222 * w223
    w225 = w86 * right_rod_e0_dot + w71 * right_rod_e1_dot
    w226 = w225 + w82 * right_rod_e2_dot + w68 * right_rod_e3_dot
    w227 = w223 * w226
    w228 = w219 * w226
    w229 = w92 * w224 - (w77 - w76) * w227 - (w70 + w72) * w228
    w230 = 1.0 - 2 * right_rod_e1**2
    w231 = right_rod_e3 * w99
    w232 = right_rod_e1 * w71
    w233 = w78 * w224 - w227 * (w230 - w91) - w228 * (w231 - w232)
    w234 = w73 * w224 - w227 * (w231 + w232) - w228 * (w230 - w90)
    w235 = w218 * c38
    w236 = w222 * c37
    w237 = w222 * w235 - w218 * w236
    w238 = w226 * c40
    w239 = w218 * w238 - w226 * w235
    w240 = w226 * w236 - w222 * w238
    w241 = w86 * w237 + w68 * w239 + w75 * w240
    w242 = w71 * w237 + w75 * w239 + w99 * w240
    w243 = w82 * w237 + w71 * w239 + w86 * w240
    w244 = w68 * w237 + w69 * w239 + w71 * w240
    w245 = w124 * left_rod_e0_dot
    w246 = w120 * left_rod_e3_dot
    w247 = w245 + w148 * left_rod_e1_dot + w135 * left_rod_e2_dot + w246
    w248 = w247 * c13
    w249 = w117 * left_rod_e0_dot
    w250 = w120 * left_rod_e2_dot
    w251 = w249 + w124 * left_rod_e1_dot + w250 + w118 * left_rod_e3_dot
    w252 = w251 * c13
    w253 = w247 * w248 + w251 * w252
    w254 = w135 * left_rod_e0_dot + w120 * left_rod_e1_dot
    w255 = w254 + w131 * left_rod_e2_dot + w117 * left_rod_e3_dot
    w256 = w252 * w255
    w257 = w248 * w255
    w258 = w141 * w253 - (w126 - w125) * w256 - (w119 + w121) * w257
    w259 = 1.0 - 2 * left_rod_e1**2
    w260 = left_rod_e3 * w148
    w261 = left_rod_e1 * w120
    w262 = w127 * w253 - w256 * (w259 - w140) - w257 * (w260 - w261)
    w263 = w122 * w253 - w256 * (w260 + w261) - w257 * (w259 - w139)
    w264 = w247 * c15
    w265 = w251 * c14
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c17
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w135 * w266 + w117 * w268 + w124 * w269
    w271 = w120 * w266 + w124 * w268 + w148 * w269
    w272 = w131 * w266 + w120 * w268 + w135 * w269
    w273 = w117 * w266 + w118 * w268 + w120 * w269
    w274 = w33 * c60
    w275 = w34 * c60
    w276 = w35 * c60
    w277 = w36 * c60
    w278 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w279 = w278 * c69
    w280 = w92 * c70
    w281 = slider_x + w279 - (right_rod_x + w280)
    w282 = slider_e3 * w52 + slider_e2 * w61
    w283 = w282 * c69
    w284 = w78 * c70
    w285 = slider_y + w283 - (right_rod_y + w284)
    w286 = slider_e3 * w61 - slider_e2 * w52
    w287 = w286 * c69
    w288 = w73 * c70
    w289 = slider_z + w287 - (right_rod_z + w288)
    w290 = w281**2 + w285**2 + w289**2
    w291 = 1.0 - c68 / ca.sqrt(w290)
    w292 = w203 + (w202 + w56 * slider_e1_dot) + w49 * slider_e3_dot
    w293 = w199 + (w198 + w50 * slider_e1_dot + w61 * slider_e2_dot)
    w294 = w221 + (w220 + w82 * right_rod_e1_dot) + w86 * right_rod_e3_dot
    w295 = w217 + (w216 + w68 * right_rod_e1_dot + w69 * right_rod_e2_dot)
    w296 = w281 * (slider_x_dot + (w287 * w292 - w283 * w293) - (right_rod_x_dot + (w288 * w294 - w284 * w295)))
    w297 = w207 + w51 * slider_e2_dot + w54 * slider_e3_dot
    w298 = w225 + w75 * right_rod_e2_dot + w99 * right_rod_e3_dot
    w299 = w285 * (slider_y_dot + (w279 * w293 - w287 * w297) - (right_rod_y_dot + (w280 * w295 - w288 * w298)))
    w300 = w289 * (slider_z_dot + (w283 * w297 - w279 * w292) - (right_rod_z_dot + (w284 * w298 - w280 * w294)))
    w301 = (w296 + w299 + w300) * c72
    w302 = w281 * w291 * c71 + w281 * w301 / w290
    w303 = w278 * c63
    w304 = w141 * c64
    w305 = slider_x + w303 - (left_rod_x + w304)
    w306 = w282 * c63
    w307 = w127 * c64
    w308 = slider_y + w306 - (left_rod_y + w307)
    w309 = w286 * c63
    w310 = w122 * c64
    w311 = slider_z + w309 - (left_rod_z + w310)
    w312 = w305**2 + w308**2 + w311**2
    w313 = 1.0 - c62 / ca.sqrt(w312)
    w314 = w250 + (w249 + w131 * left_rod_e1_dot) + w135 * left_rod_e3_dot
    w315 = w246 + (w245 + w117 * left_rod_e1_dot + w118 * left_rod_e2_dot)
    w316 = w305 * (slider_x_dot + (w292 * w309 - w293 * w306) - (left_rod_x_dot + (w310 * w314 - w307 * w315)))
    w317 = w254 + w124 * left_rod_e2_dot + w148 * left_rod_e3_dot
    w318 = w308 * (slider_y_dot + (w293 * w303 - w297 * w309) - (left_rod_y_dot + (w304 * w315 - w310 * w317)))
    w319 = w311 * (slider_z_dot + (w297 * w306 - w292 * w303) - (left_rod_z_dot + (w307 * w317 - w304 * w314)))
    w320 = (w316 + w318 + w319) * c66
    w321 = w305 * w313 * c65 + w305 * w320 / w312
    w322 = -(w302 + w321)
    w323 = w285 * w291 * c71 + w285 * w301 / w290
    w324 = w308 * w313 * c65 + w308 * w320 / w312
    w325 = -(w323 + w324)
    w326 = w289 * w291 * c71 + w289 * w301 / w290
    w327 = w311 * w313 * c65 + w311 * w320 / w312
    w328 = c73 - w326 - w327
    w329 = w51 * w283
    w330 = w49 * w287
    w331 = w50 * w279
    w332 = w51 * w306
    w333 = w49 * w309
    w334 = w50 * w303
    w335 = w302 * (w50 * w287 - w329) + w323 * (w51 * w279 - w330) + w326 * (w49 * w283 - w331) + (w321 * (w50 * w309 - w332) + w324 * (w51 * w303 - w333) + w327 * (w49 * w306 - w334))
    w336 = w52 * w287
    w337 = w52 * w283
    w338 = w52 * w309
    w339 = w52 * w306
    w340 = w302 * (w56 * w287 - w50 * w283) + w323 * (w331 - w336) + w326 * (w337 - w56 * w279) + (w321 * (w56 * w309 - w50 * w306) + w324 * (w334 - w338) + w327 * (w339 - w56 * w303))
    w341 = w52 * w279
    w342 = w52 * w303
    w343 = w302 * (w336 - w61 * w283) + w323 * (w61 * w279 - w51 * w287) + w326 * (w329 - w341) + (w321 * (w338 - w61 * w306) + w324 * (w61 * w303 - w51 * w309) + w327 * (w332 - w342))
    w344 = w302 * (w330 - w337) + w323 * (w341 - w54 * w287) + w326 * (w54 * w283 - w49 * w279) + (w321 * (w333 - w339) + w324 * (w342 - w54 * w309) + w327 * (w54 * w306 - w49 * w303))
    w345 = c67 + w326
    w346 = w75 * w284
    w347 = w86 * w288
    w348 = w68 * w280
    w349 = w101 * c60 + (w302 * (w68 * w288 - w346) + w323 * (w75 * w280 - w347) + w326 * (w86 * w284 - w348))
    w350 = w71 * w288
    w351 = w71 * w284
    w352 = w102 * c60 + (w302 * (w82 * w288 - w68 * w284) + w323 * (w348 - w350) + w326 * (w351 - w82 * w280))
    w353 = w71 * w280
    w354 = w103 * c60 + (w302 * (w350 - w69 * w284) + w323 * (w69 * w280 - w75 * w288) + w326 * (w346 - w353))
    w355 = w104 * c60 + (w302 * (w347 - w351) + w323 * (w353 - w99 * w288) + w326 * (w99 * w284 - w86 * w280))
    w356 = c61 + w327
    w357 = w124 * w307
    w358 = w135 * w310
    w359 = w117 * w304
    w360 = w150 * c60 + (w321 * (w117 * w310 - w357) + w324 * (w124 * w304 - w358) + w327 * (w135 * w307 - w359))
    w361 = w120 * w310
    w362 = w120 * w307
    w363 = w151 * c60 + (w321 * (w131 * w310 - w117 * w307) + w324 * (w359 - w361) + w327 * (w362 - w131 * w304))
    w364 = w120 * w304
    w365 = w152 * c60 + (w321 * (w361 - w118 * w307) + w324 * (w118 * w304 - w124 * w310) + w327 * (w357 - w364))
    w366 = w153 * c60 + (w321 * (w358 - w362) + w324 * (w364 - w148 * w310) + w327 * (w148 * w307 - w135 * w304))
    w367 = w10 * height_travel
    w368 = w5 * w367
    w369 = w3 * height_travel
    w370 = w19 * w369
    w371 = w25 * height_travel
    w372 = w0 * w371
    w373 = right_swing_angle / 2.0
    w374 = ca.cos(w373)
    w375 = w374 * c93
    w376 = w374 * c33 * c32 - w374 * c31 * c34
    w377 = -w376
    w378 = ca.sin(w373)
    w379 = w378 * c44
    w380 = w378 * c31 * c32 - w378 * c33 * c34
    w381 = -w380
    w382 = w186 * c28 + w3 * c29
    w383 = w184 * c28 + w10 * c29
    w384 = w5 * w383
    w385 = w175 * c28 + w25 * c29
    w386 = w19 * w382
    w387 = w0 * w385
    w388 = left_swing_angle / 2.0
    w389 = ca.sin(w388)
    w390 = -(w389 * c9 * c10 - w389 * c11 * c12)
    w391 = w389 * c20
    w392 = -w391
    w393 = ca.cos(w388)
    w394 = w393 * c9 * c12 - w393 * c11 * c10
    w395 = -w394
    w396 = w393 * c24
    w397 = -w396
    w398 = w186 * c6 + w3 * c7
    w399 = w184 * c6 + w10 * c7
    w400 = w5 * w399
    w401 = w175 * c6 + w25 * c7
    w402 = w19 * w398
    w403 = w0 * w401
    w404 = w8 * w369
    w405 = w8 * w367
    w406 = w8 * w382
    w407 = w8 * w383
    w408 = w8 * w398
    w409 = w8 * w399
    w410 = w8 * w371
    w411 = -w379
    w412 = w8 * w385
    w413 = w8 * w401
    w414 = spin_angle / 2.0
    w415 = ca.sin(w414)
    w416 = ca.cos(w414)
    w417 = w378 / 2.0
    w418 = w417 * c35
    w419 = w417 * c31 * c34 - w417 * c33 * c32
    w420 = w374 / 2.0
    w421 = w420 * c44
    w422 = w420 * c31 * c32 - w420 * c33 * c34
    w423 = w393 / 2.0
    w424 = w423 * c9 * c10 - w423 * c11 * c12
    w425 = w423 * c20
    w426 = w389 / 2.0
    w427 = w426 * c11 * c10 - w426 * c9 * c12
    w428 = w426 * c24
    w429 = (spin_angle_dot / 2.0)**2
    w430 = w167 + (w166 + w14 * shaft_e1_dot) + w19 * shaft_e3_dot
    w431 = w170 + w5 * shaft_e2_dot + w6 * shaft_e3_dot
    w432 = w10 * w431 - w25 * w430
    w433 = w177 + (w176 + w0 * shaft_e1_dot + w17 * shaft_e2_dot)
    w434 = w25 * w433 - w3 * w431
    w435 = 2 * height_travel_dot
    w436 = w3 * w430 - w10 * w433
    w437 = right_swing_angle_dot / 2.0
    w438 = w437**2
    w439 = w374 * w438
    w440 = w437 * (w374 * w437) * c35
    w441 = w439 * c31 * c34 - w439 * c33 * c32
    w442 = w378 * w438
    w443 = w437 * (w378 * w437) * c44
    w444 = w442 * c33 * c34 - w442 * c31 * c32
    w445 = w417 * right_swing_angle_dot
    w446 = w445 * c35
    w447 = w445 * c31 * c34 - w445 * c33 * c32
    w448 = w420 * right_swing_angle_dot
    w449 = w448 * c44
    w450 = w448 * c31 * c32 - w448 * c33 * c34
    w451 = shaft_e0_dot * w446 + (shaft_e1_dot * w447 - shaft_e2_dot * w449 + shaft_e3_dot * w450)
    w452 = shaft_e0_dot * w447 - shaft_e1_dot * w446 + (shaft_e2_dot * w450 + shaft_e3_dot * w449)
    w453 = shaft_e3_dot * w447 - shaft_e1_dot * w450 - (shaft_e0_dot * w449 + shaft_e2_dot * w446)
    w454 = shaft_e0_dot * w450 - shaft_e3_dot * w446 - (shaft_e1_dot * w449 + shaft_e2_dot * w447)
    w455 = w383 * w431 - w385 * w430
    w456 = w385 * w433 - w382 * w431
    w457 = w382 * w430 - w383 * w433
    w458 = left_swing_angle_dot / 2.0
    w459 = w458**2
    w460 = w389 * w459
    w461 = w460 * c11 * c12 - w460 * c9 * c10
    w462 = w393 * w459
    w463 = w462 * c11 * c10 - w462 * c9 * c12
    w464 = w458 * (w389 * w458) * c20
    w465 = w458 * (w393 * w458) * c24
    w466 = w423 * left_swing_angle_dot
    w467 = w466 * c9 * c10 - w466 * c11 * c12
    w468 = w466 * c20
    w469 = w426 * left_swing_angle_dot
    w470 = w469 * c11 * c10 - w469 * c9 * c12
    w471 = w469 * c24
    w472 = shaft_e0_dot * w467 - (shaft_e1_dot * w468 + shaft_e2_dot * w470 - shaft_e3_dot * w471)
    w473 = shaft_e0_dot * w468 + shaft_e1_dot * w467 - (shaft_e2_dot * w471 + shaft_e3_dot * w470)
    w474 = shaft_e0_dot * w470 + shaft_e2_dot * w467 + (shaft_e3_dot * w468 + shaft_e1_dot * w471)
    w475 = shaft_e3_dot * w467 - shaft_e0_dot * w471 + (shaft_e1_dot * w470 - shaft_e2_dot * w468)
    w476 = w399 * w431 - w401 * w430
    w477 = w401 * w433 - w398 * w431
    w478 = w398 * w430 - w399 * w433
    M = ca.vertcat(
        c81,
        0.0,
        0.0,
        w13,
        w15,
        w18,
        w22,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c81,
        0.0,
        w27,
        w29,
        w30,
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
        c81,
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
        w13,
        w27,
        w33,
        w19 * (w19 * c2) + w0 * (w0 * c4) + w5 * (w5 * c5),
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
        w15,
        w29,
        w34,
        w38,
        w8 * w37 + w5 * (w5 * c4) + w6 * (w6 * c5),
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
        w18,
        w30,
        w35,
        w41,
        w46,
        w14 * (w14 * c2) + w8 * w39 + w19 * w40,
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
        w22,
        w32,
        w36,
        w45,
        w47,
        w48,
        w0 * w42 + w17 * w43 + w8 * w44,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c50,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c50,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c50,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w49 * (w49 * c53) + w50 * (w50 * c55) + w51 * (w51 * c56),
        w55,
        w59,
        w64,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w55,
        w52 * w53 + w51 * (w51 * c55) + w54 * (w54 * c56),
        w65,
        w66,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w59,
        w65,
        w56 * (w56 * c53) + w52 * w57 + w49 * w58,
        w67,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w66,
        w67,
        w50 * w60 + w61 * w62 + w52 * w63,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c30,
        0.0,
        0.0,
        w81,
        w83,
        w85,
        w89,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c30,
        0.0,
        w94,
        w96,
        w97,
        w100,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c30,
        w101,
        w102,
        w103,
        w104,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w81,
        w94,
        w101,
        w86 * (w86 * c39) + w68 * (w68 * c41) + w75 * (w75 * c42),
        w106,
        w109,
        w113,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w83,
        w96,
        w102,
        w106,
        w71 * w105 + w75 * (w75 * c41) + w99 * (w99 * c42),
        w114,
        w115,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w85,
        w97,
        w103,
        w109,
        w114,
        w82 * (w82 * c39) + w71 * w107 + w86 * w108,
        w116,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w89,
        w100,
        w104,
        w113,
        w115,
        w116,
        w68 * w110 + w69 * w111 + w71 * w112,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        0.0,
        0.0,
        w130,
        w132,
        w134,
        w138,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        0.0,
        w143,
        w145,
        w146,
        w149,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        w150,
        w151,
        w152,
        w153,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w130,
        w143,
        w150,
        w135 * (w135 * c16) + w117 * (w117 * c18) + w124 * (w124 * c19),
        w155,
        w158,
        w162,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w132,
        w145,
        w151,
        w155,
        w120 * w154 + w124 * (w124 * c18) + w148 * (w148 * c19),
        w163,
        w164,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w146,
        w152,
        w158,
        w163,
        w131 * (w131 * c16) + w120 * w156 + w135 * w157,
        w165,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w138,
        w149,
        w153,
        w162,
        w164,
        w165,
        w117 * w159 + w118 * w160 + w120 * w161,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
    M = ca.reshape(M, 32, 32)
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
    )
    K = ca.reshape(K, 32, 32)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w183,
        w185,
        w187,
        w194,
        w195,
        w196,
        w197,
        0.0,
        0.0,
        0.0,
        w212,
        w213,
        w214,
        w215,
        w229,
        w233,
        w234,
        w241,
        w242,
        w243,
        w244,
        w258,
        w262,
        w263,
        w270,
        w271,
        w272,
        w273,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        0.0,
        c92,
        w274,
        w275,
        w276,
        w277,
        w322,
        w325,
        w328,
        -w335,
        -w340,
        -w343,
        -w344,
        w302,
        w323,
        w345,
        w349,
        w352,
        w354,
        w355,
        w321,
        w324,
        w356,
        w360,
        w363,
        w365,
        w366,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w183,
        w185,
        w187 + c92,
        w194 + w274,
        w195 + w275,
        w196 + w276,
        w197 + w277,
        w322,
        w325,
        w328,
        w212 - w335,
        w213 - w340,
        w214 - w343,
        w215 - w344,
        w229 + w302,
        w233 + w323,
        w234 + w345,
        w241 + w349,
        w242 + w352,
        w243 + w354,
        w244 + w355,
        w258 + w321,
        w262 + w324,
        w263 + w356,
        w270 + w360,
        w271 + w363,
        w272 + w365,
        w273 + w366,
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
        -1.0,
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
        -1.0,
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
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
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
        w368 - w0 * w369,
        w370 - w5 * w371,
        w372 - w19 * w367,
        w375,
        w377,
        w379,
        w381,
        -(w0 * w382 - w384),
        -(w5 * w385 - w386),
        -(w19 * w383 - w387),
        w390,
        w392,
        w395,
        w397,
        -(w0 * w398 - w400),
        -(w5 * w401 - w402),
        -(w19 * w399 - w403),
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
        w0 * w367 - w14 * w369,
        w404 - w372,
        w14 * w371 - w405,
        w376,
        w375,
        w380,
        w379,
        -(w14 * w382 - w0 * w383),
        -(w387 - w406),
        -(w407 - w14 * w385),
        w391,
        w390,
        w396,
        w395,
        -(w14 * w398 - w0 * w399),
        -(w403 - w408),
        -(w409 - w14 * w401),
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
        w17 * w367 - w404,
        w5 * w369 - w17 * w371,
        w410 - w368,
        w411,
        w381,
        w375,
        w376,
        -(w406 - w17 * w383),
        -(w17 * w385 - w5 * w382),
        -(w384 - w412),
        w394,
        w397,
        w390,
        w391,
        -(w408 - w17 * w399),
        -(w17 * w401 - w5 * w398),
        -(w400 - w413),
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
        w405 - w370,
        w6 * w369 - w410,
        w19 * w371 - w6 * w367,
        w380,
        w411,
        w377,
        w375,
        -(w386 - w407),
        -(w412 - w6 * w382),
        -(w6 * w383 - w19 * w385),
        w396,
        w394,
        w392,
        w390,
        -(w402 - w409),
        -(w413 - w6 * w398),
        -(w6 * w399 - w19 * w401),
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w415 / 2.0,
        0.0,
        0.0,
        -(w416 / 2.0),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w25,
        -w10,
        -w3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        shaft_e0 * w418 + (shaft_e1 * w419 - shaft_e2 * w421 + shaft_e3 * w422),
        -(shaft_e0 * w419 - shaft_e1 * w418 + (shaft_e2 * w422 + shaft_e3 * w421)),
        -(shaft_e3 * w419 - shaft_e1 * w422 - (shaft_e0 * w421 + shaft_e2 * w418)),
        -(shaft_e0 * w422 - shaft_e3 * w418 - (shaft_e1 * w421 + shaft_e2 * w419)),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(shaft_e0 * w424 - (shaft_e1 * w425 + shaft_e2 * w427 - shaft_e3 * w428)),
        -(shaft_e0 * w425 + shaft_e1 * w424 - (shaft_e2 * w428 + shaft_e3 * w427)),
        -(shaft_e0 * w427 + shaft_e2 * w424 + (shaft_e3 * w425 + shaft_e1 * w428)),
        -(shaft_e3 * w424 - shaft_e0 * w428 + (shaft_e1 * w427 - shaft_e2 * w425)),
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 28, 32)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        -(w416 * w429),
        0.0,
        0.0,
        -(w415 * w429),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        height_travel * (w430 * w432 - w433 * w434) + w435 * w436,
        height_travel * (w433 * w436 - w431 * w432) + w434 * w435,
        height_travel * (w431 * w434 - w430 * w436) + w432 * w435,
        -(w451 + (shaft_e0 * w440 + (shaft_e1 * w441 + shaft_e2 * w443 + shaft_e3 * w444) + w451)),
        w452 + (shaft_e0 * w441 - shaft_e1 * w440 + (shaft_e2 * w444 - shaft_e3 * w443) + w452),
        w453 + (shaft_e0 * w443 - shaft_e2 * w440 + (shaft_e3 * w441 - shaft_e1 * w444) + w453),
        w454 + (shaft_e0 * w444 - shaft_e3 * w440 + (shaft_e1 * w443 - shaft_e2 * w441) + w454),
        w430 * w455 - w433 * w456,
        w433 * w457 - w431 * w455,
        w431 * w456 - w430 * w457,
        w472 + (shaft_e0 * w461 - (shaft_e2 * w463 - shaft_e1 * w464 - shaft_e3 * w465) + w472),
        w473 + (shaft_e1 * w461 - shaft_e0 * w464 - (shaft_e2 * w465 + shaft_e3 * w463) + w473),
        w474 + (shaft_e0 * w463 + shaft_e2 * w461 + (shaft_e1 * w465 - shaft_e3 * w464) + w474),
        w475 + (shaft_e3 * w461 - shaft_e0 * w465 + (shaft_e1 * w463 + shaft_e2 * w464) + w475),
        w430 * w476 - w433 * w477,
        w433 * w478 - w431 * w476,
        w431 * w477 - w430 * w478,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 2177 operations."""
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    q_ddot = ca.SX.sym("q_ddot", 32)
    c = ca.SX.sym("c", 125)
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    shaft_x_ddot = q_ddot[0]
    shaft_y_ddot = q_ddot[1]
    shaft_z_ddot = q_ddot[2]
    shaft_e0_ddot = q_ddot[3]
    shaft_e1_ddot = q_ddot[4]
    shaft_e2_ddot = q_ddot[5]
    shaft_e3_ddot = q_ddot[6]
    slider_x_ddot = q_ddot[7]
    slider_y_ddot = q_ddot[8]
    slider_z_ddot = q_ddot[9]
    slider_e0_ddot = q_ddot[10]
    slider_e1_ddot = q_ddot[11]
    slider_e2_ddot = q_ddot[12]
    slider_e3_ddot = q_ddot[13]
    right_rod_x_ddot = q_ddot[14]
    right_rod_y_ddot = q_ddot[15]
    right_rod_z_ddot = q_ddot[16]
    right_rod_e0_ddot = q_ddot[17]
    right_rod_e1_ddot = q_ddot[18]
    right_rod_e2_ddot = q_ddot[19]
    right_rod_e3_ddot = q_ddot[20]
    left_rod_x_ddot = q_ddot[21]
    left_rod_y_ddot = q_ddot[22]
    left_rod_z_ddot = q_ddot[23]
    left_rod_e0_ddot = q_ddot[24]
    left_rod_e1_ddot = q_ddot[25]
    left_rod_e2_ddot = q_ddot[26]
    left_rod_e3_ddot = q_ddot[27]
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
    w0 = shaft_e1 * -2.0
    w1 = shaft_e3 * -2.0
    w2 = 2 * shaft_e2
    w3 = 2 * shaft_e0
    w4 = shaft_e0_dot * w1 + shaft_e1_dot * w2 + w0 * shaft_e2_dot + shaft_e3_dot * w3
    w5 = w4 * c1
    w6 = shaft_e2 * -2.0
    w7 = 2 * shaft_e1
    w8 = shaft_e0_dot * w6 + w1 * shaft_e1_dot + shaft_e2_dot * w3 + shaft_e3_dot * w7
    w9 = w8 * c0
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * shaft_e3
    w12 = w0 * shaft_e0_dot + shaft_e1_dot * w3 + shaft_e2_dot * w11 + shaft_e3_dot * w6
    w13 = w12 * c3
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = shaft_e3 * w2
    w17 = shaft_e1 * w3
    w18 = w16 - w17
    w19 = w18 * c59
    w20 = shaft_e2 * w3
    w21 = shaft_e3 * w7
    w22 = w20 + w21
    w23 = w22 * c59
    w24 = w6 * w23
    w25 = w0 * w19 - w24
    w26 = 1.0 - 2 * shaft_e1**2
    w27 = 2 * shaft_e2**2
    w28 = w26 - w27
    w29 = w28 * c59
    w30 = w1 * w19
    w31 = w6 * w29 - w30
    w32 = w0 * w29
    w33 = w1 * w23 - w32
    w34 = w31 * shaft_x_ddot + w33 * shaft_y_ddot + w25 * shaft_z_ddot + (w0 * (w0 * c2) + w6 * (w6 * c4) + w1 * (w1 * c5)) * shaft_e0_ddot
    w35 = w3 * c2
    w36 = w0 * w35 + shaft_e3 * shaft_e2 * c82
    w37 = w3 * c4
    w38 = w0 * c5
    w39 = w6 * w37 + shaft_e1 * shaft_e3 * c83
    w40 = w6 * c2
    w41 = w7 * c4
    w42 = w3 * c5
    w43 = shaft_e1 * shaft_e2 * c57 + w1 * w42
    w44 = w0 * w10 + w6 * w14 + w1 * w15 + w25 * c60 - (w34 + w36 * shaft_e1_ddot + w39 * shaft_e2_ddot + w43 * shaft_e3_ddot)
    w45 = shaft_e3 * w3
    w46 = shaft_e2 * w7
    w47 = w45 + w46
    w48 = w47 * c6 + w18 * c7
    w49 = 2 * shaft_e3**2
    w50 = 1.0 - w27 - w49
    w51 = w50 * c6 + w22 * c7
    w52 = w6 * w51
    w53 = 2 * left_rod_e1
    w54 = w53 * left_rod_e3
    w55 = 2 * left_rod_e0
    w56 = w55 * left_rod_e2
    w57 = w54 - w56
    w58 = left_rod_e3 * -2.0
    w59 = left_rod_e0_dot * w58
    w60 = 2 * left_rod_e2
    w61 = left_rod_e1 * -2.0
    w62 = w55 * left_rod_e3_dot
    w63 = w59 + left_rod_e1_dot * w60 + left_rod_e2_dot * w61 + w62
    w64 = w63 * c13
    w65 = left_rod_e2 * -2.0
    w66 = left_rod_e0_dot * w65
    w67 = w55 * left_rod_e2_dot
    w68 = w66 + w58 * left_rod_e1_dot + w67 + w53 * left_rod_e3_dot
    w69 = w68 * c13
    w70 = w63 * w64 + w68 * w69
    w71 = left_rod_e1 * w55
    w72 = left_rod_e3 * w60
    w73 = left_rod_e0_dot * w61 + w55 * left_rod_e1_dot
    w74 = 2 * left_rod_e3
    w75 = w73 + left_rod_e2_dot * w74 + left_rod_e3_dot * w65
    w76 = w69 * w75
    w77 = 1.0 - 2 * left_rod_e1**2
    w78 = 2 * left_rod_e2**2
    w79 = w64 * w75
    w80 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w81 = w80 * c63
    w82 = 2 * left_rod_e3**2
    w83 = 1.0 - w78 - w82
    w84 = w83 * c64
    w85 = slider_x + w81 - (left_rod_x + w84)
    w86 = 2 * slider_e0
    w87 = 2 * slider_e1
    w88 = slider_e3 * w86 + slider_e2 * w87
    w89 = w88 * c63
    w90 = left_rod_e3 * w55
    w91 = w53 * left_rod_e2
    w92 = w90 + w91
    w93 = w92 * c64
    w94 = slider_y + w89 - (left_rod_y + w93)
    w95 = slider_e3 * w87 - slider_e2 * w86
    w96 = w95 * c63
    w97 = w57 * c64
    w98 = slider_z + w96 - (left_rod_z + w97)
    w99 = w85**2 + w94**2 + w98**2
    w100 = 1.0 - c62 / ca.sqrt(w99)
    w101 = slider_e2 * -2.0
    w102 = slider_e0_dot * w101
    w103 = 2 * slider_e3
    w104 = w86 * slider_e2_dot
    w105 = slider_e1 * -2.0
    w106 = w102 + slider_e1_dot * w103 + w104 + slider_e3_dot * w105
    w107 = slider_e3 * -2.0
    w108 = slider_e0_dot * w107
    w109 = w86 * slider_e3_dot
    w110 = w108 + w101 * slider_e1_dot + w87 * slider_e2_dot + w109
    w111 = w67 + (w66 + left_rod_e1_dot * w74) + w61 * left_rod_e3_dot
    w112 = w62 + (w59 + left_rod_e1_dot * w65 + w53 * left_rod_e2_dot)
    w113 = slider_e0_dot * w105 + w86 * slider_e1_dot
    w114 = 2 * slider_e2
    w115 = w113 + slider_e2_dot * w107 + slider_e3_dot * w114
    w116 = w73 + w58 * left_rod_e2_dot + w60 * left_rod_e3_dot
    w117 = w85 * (slider_x_dot + (w96 * w106 - w89 * w110) - (left_rod_x_dot + (w97 * w111 - w93 * w112))) + w94 * (slider_y_dot + (w81 * w110 - w96 * w115) - (left_rod_y_dot + (w84 * w112 - w97 * w116)))
    w118 = w117 + w98 * (slider_z_dot + (w89 * w115 - w81 * w106) - (left_rod_z_dot + (w93 * w116 - w84 * w111)))
    w119 = w118 * c66
    w120 = w98 * w100 * c65 + w98 * w119 / w99
    w121 = w92 * c13
    w122 = w83 * c13
    w123 = w65 * w122
    w124 = w61 * w121 - w123
    w125 = w55 * w121
    w126 = w125 - w74 * w122
    w127 = w58 * w121
    w128 = w55 * w122
    w129 = w127 - w128
    w130 = left_rod_z_ddot * c8 + w124 * left_rod_e0_ddot + w126 * left_rod_e1_ddot + w129 * left_rod_e2_ddot
    w131 = w60 * w121 - w61 * w122
    w132 = w57 * w70 - (w71 + w72) * w76 - (w77 - w78) * w79 + (c61 + w120) - (w130 + w131 * left_rod_e3_ddot)
    w133 = w21 - w20
    w134 = w133 * c6 + w28 * c7
    w135 = w0 * w134
    w136 = w94 * w100 * c65 + w94 * w119 / w99
    w137 = w57 * c13
    w138 = w61 * w137
    w139 = w58 * w122 - w138
    w140 = w55 * w137
    w141 = w123 - w140
    w142 = w53 * w122 - w58 * w137
    w143 = left_rod_y_ddot * c8 + left_rod_e0_ddot * w139 + left_rod_e1_ddot * w141 + left_rod_e2_ddot * w142
    w144 = w128 - w60 * w137
    w145 = w70 * w92 - w76 * (w77 - w82) - w79 * (w72 - w71) + w136 - (w143 + left_rod_e3_ddot * w144)
    w146 = w1 * w48
    w147 = w85 * w100 * c65 + w85 * w119 / w99
    w148 = w65 * w137 - w127
    w149 = w74 * w137 - w65 * w121
    w150 = w140 - w53 * w121
    w151 = left_rod_x_ddot * c8 + left_rod_e0_ddot * w148 + left_rod_e1_ddot * w149 + left_rod_e2_ddot * w150
    w152 = w138 - w125
    w153 = w70 * w83 - w76 * (w91 - w90) - w79 * (w54 + w56) + w147 - (w151 + left_rod_e3_ddot * w152)
    w154 = left_swing_angle / 2.0
    w155 = ca.cos(w154)
    w156 = w155 * c24
    w157 = w63 * c15
    w158 = w68 * c14
    w159 = w68 * w157 - w63 * w158
    w160 = w75 * c17
    w161 = w63 * w160 - w75 * w157
    w162 = w75 * w158 - w68 * w160
    w163 = w61 * w97
    w164 = w55 * w93
    w165 = w55 * w84
    w166 = w65 * w159 + w53 * w161 + w55 * w162 + (w131 * c60 + (w147 * (w163 - w164) + w136 * (w165 - w60 * w97) + w120 * (w60 * w93 - w61 * w84)))
    w167 = w65 * c16
    w168 = w53 * c18
    w169 = w55 * c19
    w170 = left_rod_e1 * left_rod_e2 * c25 + w58 * w169
    w171 = left_rod_x_ddot * w152 + left_rod_y_ddot * w144 + left_rod_z_ddot * w131 + left_rod_e0_ddot * w170
    w172 = w58 * w168 + left_rod_e0 * left_rod_e2 * c22
    w173 = w74 * w167 + left_rod_e1 * left_rod_e0 * c21
    w174 = w171 + left_rod_e1_ddot * w172 + left_rod_e2_ddot * w173 + left_rod_e3_ddot * (w65 * w167 + w53 * w168 + w55 * w169)
    w175 = w166 - w174
    w176 = w44 + (w0 * w48 - w52) * w132 + (w1 * w51 - w135) * w145 + (w6 * w134 - w146) * w153 + w156 * w175
    w177 = w155 * c9 * c12 - w155 * c11 * c10
    w178 = w55 * w97
    w179 = w58 * w93
    w180 = w74 * w159 + w55 * w161 + w61 * w162 + (w129 * c60 + (w147 * (w178 - w53 * w93) + w136 * (w53 * w84 - w58 * w97) + w120 * (w179 - w165)))
    w181 = w55 * c18
    w182 = w61 * c19
    w183 = w65 * w181 + left_rod_e1 * left_rod_e3 * c26
    w184 = left_rod_x_ddot * w150 + left_rod_y_ddot * w142 + left_rod_z_ddot * w129 + left_rod_e0_ddot * w183
    w185 = left_rod_e3 * left_rod_e0 * c23 + w60 * w182
    w186 = w184 + left_rod_e1_ddot * w185 + left_rod_e2_ddot * (w74 * (w74 * c16) + w55 * w181 + w61 * w182)
    w187 = w180 - (w186 + left_rod_e3_ddot * w173)
    w188 = ca.sin(w154)
    w189 = w188 * c20
    w190 = w65 * w84
    w191 = w55 * w159 + w58 * w161 + w60 * w162 + (w126 * c60 + (w147 * (w74 * w97 - w65 * w93) + w136 * (w190 - w178) + w120 * (w164 - w74 * w84)))
    w192 = w55 * c16
    w193 = w61 * w192 + left_rod_e3 * left_rod_e2 * c27
    w194 = left_rod_x_ddot * w149 + left_rod_y_ddot * w141 + left_rod_z_ddot * w126 + left_rod_e0_ddot * w193
    w195 = w194 + left_rod_e1_ddot * (w55 * w192 + w58 * (w58 * c18) + w60 * (w60 * c19)) + left_rod_e2_ddot * w185
    w196 = w191 - (w195 + left_rod_e3_ddot * w172)
    w197 = w188 * c9 * c10 - w188 * c11 * c12
    w198 = w61 * w159 + w65 * w161 + w58 * w162 + (w124 * c60 + (w147 * (w65 * w97 - w179) + w136 * (w58 * w84 - w163) + w120 * (w61 * w93 - w190)))
    w199 = left_rod_x_ddot * w148 + left_rod_y_ddot * w139 + left_rod_z_ddot * w124 + left_rod_e0_ddot * (w61 * (w61 * c16) + w65 * (w65 * c18) + w58 * (w58 * c19))
    w200 = w198 - (w199 + left_rod_e1_ddot * w193 + left_rod_e2_ddot * w183 + left_rod_e3_ddot * w170)
    w201 = w47 * c28 + w18 * c29
    w202 = w50 * c28 + w22 * c29
    w203 = w6 * w202
    w204 = 2 * right_rod_e1
    w205 = w204 * right_rod_e3
    w206 = 2 * right_rod_e0
    w207 = w206 * right_rod_e2
    w208 = w205 - w207
    w209 = right_rod_e3 * -2.0
    w210 = right_rod_e0_dot * w209
    w211 = 2 * right_rod_e2
    w212 = right_rod_e1 * -2.0
    w213 = w206 * right_rod_e3_dot
    w214 = w210 + right_rod_e1_dot * w211 + right_rod_e2_dot * w212 + w213
    w215 = w214 * c36
    w216 = right_rod_e2 * -2.0
    w217 = right_rod_e0_dot * w216
    w218 = w206 * right_rod_e2_dot
    w219 = w217 + w209 * right_rod_e1_dot + w218 + w204 * right_rod_e3_dot
    w220 = w219 * c36
    w221 = w214 * w215 + w219 * w220
    w222 = right_rod_e1 * w206
    w223 = right_rod_e3 * w211
    w224 = right_rod_e0_dot * w212 + w206 * right_rod_e1_dot
    w225 = 2 * right_rod_e3
    w226 = w224 + right_rod_e2_dot * w225 + right_rod_e3_dot * w216
    w227 = w220 * w226
    w228 = 1.0 - 2 * right_rod_e1**2
    w229 = 2 * right_rod_e2**2
    w230 = w215 * w226
    w231 = w80 * c69
    w232 = 2 * right_rod_e3**2
    w233 = 1.0 - w229 - w232
    w234 = w233 * c70
    w235 = slider_x + w231 - (right_rod_x + w234)
    w236 = w88 * c69
    w237 = right_rod_e3 * w206
    w238 = w204 * right_rod_e2
    w239 = w237 + w238
    w240 = w239 * c70
    w241 = slider_y + w236 - (right_rod_y + w240)
    w242 = w95 * c69
    w243 = w208 * c70
    w244 = slider_z + w242 - (right_rod_z + w243)
    w245 = w235**2 + w241**2 + w244**2
    w246 = 1.0 - c68 / ca.sqrt(w245)
    w247 = w218 + (w217 + right_rod_e1_dot * w225) + w212 * right_rod_e3_dot
    w248 = w213 + (w210 + right_rod_e1_dot * w216 + w204 * right_rod_e2_dot)
    w249 = w235 * (slider_x_dot + (w106 * w242 - w110 * w236) - (right_rod_x_dot + (w243 * w247 - w240 * w248)))
    w250 = w224 + w209 * right_rod_e2_dot + w211 * right_rod_e3_dot
    w251 = w241 * (slider_y_dot + (w110 * w231 - w115 * w242) - (right_rod_y_dot + (w234 * w248 - w243 * w250)))
    w252 = w244 * (slider_z_dot + (w115 * w236 - w106 * w231) - (right_rod_z_dot + (w240 * w250 - w234 * w247)))
    w253 = (w249 + w251 + w252) * c72
    w254 = w244 * w246 * c71 + w244 * w253 / w245
    w255 = w239 * c36
    w256 = w233 * c36
    w257 = w216 * w256
    w258 = w212 * w255 - w257
    w259 = w206 * w255
    w260 = w259 - w225 * w256
    w261 = w209 * w255
    w262 = w206 * w256
    w263 = w261 - w262
    w264 = right_rod_z_ddot * c30 + w258 * right_rod_e0_ddot + w260 * right_rod_e1_ddot + w263 * right_rod_e2_ddot
    w265 = w211 * w255 - w212 * w256
    w266 = w208 * w221 - (w222 + w223) * w227 - (w228 - w229) * w230 + (c67 + w254) - (w264 + w265 * right_rod_e3_ddot)
    w267 = w133 * c28 + w28 * c29
    w268 = w0 * w267
    w269 = w241 * w246 * c71 + w241 * w253 / w245
    w270 = w208 * c36
    w271 = w212 * w270
    w272 = w209 * w256 - w271
    w273 = w206 * w270
    w274 = w257 - w273
    w275 = w204 * w256 - w209 * w270
    w276 = right_rod_y_ddot * c30 + right_rod_e0_ddot * w272 + right_rod_e1_ddot * w274 + right_rod_e2_ddot * w275
    w277 = w262 - w211 * w270
    w278 = w221 * w239 - w227 * (w228 - w232) - w230 * (w223 - w222) + w269 - (w276 + right_rod_e3_ddot * w277)
    w279 = w176 + w177 * w187 + w189 * w196 + w197 * w200 + (w0 * w201 - w203) * w266 + (w1 * w202 - w268) * w278
    w280 = w1 * w201
    w281 = w235 * w246 * c71 + w235 * w253 / w245
    w282 = w216 * w270 - w261
    w283 = w225 * w270 - w216 * w255
    w284 = w273 - w204 * w255
    w285 = right_rod_x_ddot * c30 + right_rod_e0_ddot * w282 + right_rod_e1_ddot * w283 + right_rod_e2_ddot * w284
    w286 = w271 - w259
    w287 = w221 * w233 - w227 * (w238 - w237) - w230 * (w205 + w207) + w281 - (w285 + right_rod_e3_ddot * w286)
    w288 = right_swing_angle / 2.0
    w289 = ca.sin(w288)
    w290 = w289 * c31 * c32 - w289 * c33 * c34
    w291 = w214 * c38
    w292 = w219 * c37
    w293 = w219 * w291 - w214 * w292
    w294 = w226 * c40
    w295 = w214 * w294 - w226 * w291
    w296 = w226 * w292 - w219 * w294
    w297 = w212 * w243
    w298 = w206 * w240
    w299 = w206 * w234
    w300 = w265 * c60 + (w281 * (w297 - w298) + w269 * (w299 - w211 * w243) + w254 * (w211 * w240 - w212 * w234))
    w301 = w216 * c39
    w302 = w204 * c41
    w303 = w206 * c42
    w304 = right_rod_e1 * right_rod_e2 * c47 + w209 * w303
    w305 = right_rod_x_ddot * w286 + right_rod_y_ddot * w277 + right_rod_z_ddot * w265 + right_rod_e0_ddot * w304
    w306 = w209 * w302 + right_rod_e0 * right_rod_e2 * c45
    w307 = w225 * w301 + right_rod_e1 * right_rod_e0 * c43
    w308 = w305 + right_rod_e1_ddot * w306 + right_rod_e2_ddot * w307 + right_rod_e3_ddot * (w216 * w301 + w204 * w302 + w206 * w303)
    w309 = w216 * w293 + w204 * w295 + w206 * w296 + w300 - w308
    w310 = w289 * c44
    w311 = w206 * w243
    w312 = w209 * w240
    w313 = w263 * c60 + (w281 * (w311 - w204 * w240) + w269 * (w204 * w234 - w209 * w243) + w254 * (w312 - w299))
    w314 = w206 * c41
    w315 = w212 * c42
    w316 = w216 * w314 + right_rod_e1 * right_rod_e3 * c48
    w317 = right_rod_x_ddot * w284 + right_rod_y_ddot * w275 + right_rod_z_ddot * w263 + right_rod_e0_ddot * w316
    w318 = right_rod_e3 * right_rod_e0 * c46 + w211 * w315
    w319 = w317 + right_rod_e1_ddot * w318 + right_rod_e2_ddot * (w225 * (w225 * c39) + w206 * w314 + w212 * w315)
    w320 = w225 * w293 + w206 * w295 + w212 * w296 + w313 - (w319 + right_rod_e3_ddot * w307)
    w321 = ca.cos(w288)
    w322 = w321 * c33 * c32 - w321 * c31 * c34
    w323 = w216 * w234
    w324 = w260 * c60 + (w281 * (w225 * w243 - w216 * w240) + w269 * (w323 - w311) + w254 * (w298 - w225 * w234))
    w325 = w206 * c39
    w326 = w212 * w325 + right_rod_e3 * right_rod_e2 * c49
    w327 = right_rod_x_ddot * w283 + right_rod_y_ddot * w274 + right_rod_z_ddot * w260 + right_rod_e0_ddot * w326
    w328 = w327 + right_rod_e1_ddot * (w206 * w325 + w209 * (w209 * c41) + w211 * (w211 * c42)) + right_rod_e2_ddot * w318
    w329 = w206 * w293 + w209 * w295 + w211 * w296 + w324 - (w328 + right_rod_e3_ddot * w306)
    w330 = w321 * c35
    w331 = w258 * c60 + (w281 * (w216 * w243 - w312) + w269 * (w209 * w234 - w297) + w254 * (w212 * w240 - w323))
    w332 = right_rod_x_ddot * w282 + right_rod_y_ddot * w272 + right_rod_z_ddot * w258 + right_rod_e0_ddot * (w212 * (w212 * c39) + w216 * (w216 * c41) + w209 * (w209 * c42))
    w333 = w212 * w293 + w216 * w295 + w209 * w296 + w331 - (w332 + right_rod_e1_ddot * w326 + right_rod_e2_ddot * w316 + right_rod_e3_ddot * w304)
    w334 = w22 * height_travel
    w335 = w6 * w334
    w336 = w18 * height_travel
    w337 = c73 - w254 - w120 - slider_z_ddot * c50
    w338 = w279 + (w6 * w267 - w280) * w287 + w290 * w309 - w310 * w320 + w322 * w329 + w330 * w333 - (w335 - w0 * w336) * w337
    w339 = w28 * height_travel
    w340 = w0 * w339
    w341 = w136 + w269 + slider_y_ddot * c50
    w342 = w1 * w336
    w343 = w147 + w281 + slider_x_ddot * c50
    w344 = w109 + (w108 + slider_e1_dot * w114 + slider_e2_dot * w105)
    w345 = w344 * c52
    w346 = w104 + (w102 + slider_e1_dot * w107) + w87 * slider_e3_dot
    w347 = w346 * c51
    w348 = w345 * w346 - w344 * w347
    w349 = w113 + w103 * slider_e2_dot + w101 * slider_e3_dot
    w350 = w349 * c54
    w351 = w344 * w350 - w345 * w349
    w352 = w347 * w349 - w346 * w350
    w353 = w107 * w236
    w354 = w105 * w242
    w355 = w101 * w231
    w356 = w89 * w107
    w357 = w96 * w105
    w358 = w81 * w101
    w359 = w281 * (w101 * w242 - w353) + w269 * (w107 * w231 - w354) + w254 * (w105 * w236 - w355) + (w147 * (w96 * w101 - w356) + w136 * (w81 * w107 - w357) + w120 * (w89 * w105 - w358))
    w360 = w86 * c53
    w361 = w105 * w360 + slider_e2 * slider_e3 * c87
    w362 = (w105 * (w105 * c53) + w101 * (w101 * c55) + w107 * (w107 * c56)) * slider_e0_ddot + w361 * slider_e1_ddot
    w363 = w86 * c55
    w364 = w105 * c56
    w365 = w101 * w363 + slider_e3 * slider_e1 * c88
    w366 = w101 * c53
    w367 = w87 * c55
    w368 = w86 * c56
    w369 = slider_e2 * slider_e1 * c58 + w107 * w368
    w370 = w105 * w348 + w101 * w351 + w107 * w352 - w359 - (w362 + w365 * slider_e2_ddot + w369 * slider_e3_ddot)
    w371 = w338 + (w340 - w1 * w334) * w341 + (w342 - w6 * w339) * w343 + w370
    w372 = w3 * w19
    w373 = w372 - w11 * w23
    w374 = w11 * w29 - w6 * w19
    w375 = w3 * w29
    w376 = w24 - w375
    w377 = shaft_x_ddot * w374 + shaft_y_ddot * w376 + shaft_z_ddot * w373 + shaft_e0_ddot * w36 + shaft_e1_ddot * (w3 * w35 + w1 * (w1 * c4) + w2 * (w2 * c5))
    w378 = shaft_e3 * shaft_e0 * c84 + w2 * w38
    w379 = w1 * w41 + shaft_e2 * shaft_e0 * c85
    w380 = w3 * w10 + w1 * w14 + w2 * w15 + w373 * c60 - (w377 + shaft_e2_ddot * w378 + shaft_e3_ddot * w379)
    w381 = w3 * w48
    w382 = w3 * w134
    w383 = w380 + w132 * (w381 - w11 * w51) + w145 * (w52 - w382) + w153 * (w11 * w134 - w6 * w48) + w175 * w177
    w384 = w3 * w201
    w385 = w3 * w267
    w386 = w383 - w156 * w187 + w196 * w197 - w189 * w200 + w266 * (w384 - w11 * w202) + w278 * (w203 - w385)
    w387 = w3 * w336
    w388 = w386 + w287 * (w11 * w267 - w6 * w201) - w309 * w310 - w290 * w320 + w329 * w330 - w322 * w333 - w337 * (w11 * w334 - w387)
    w389 = w3 * w339
    w390 = w86 * w242
    w391 = w86 * w236
    w392 = w86 * w96
    w393 = w86 * w89
    w394 = w281 * (w103 * w242 - w101 * w236) + w269 * (w355 - w390) + w254 * (w391 - w103 * w231) + (w147 * (w96 * w103 - w89 * w101) + w136 * (w358 - w392) + w120 * (w393 - w81 * w103))
    w395 = slider_e0_ddot * w361 + slider_e1_ddot * (w86 * w360 + w107 * (w107 * c55) + w114 * (w114 * c56))
    w396 = slider_e3 * slider_e0 * c89 + w114 * w364
    w397 = w107 * w367 + slider_e2 * slider_e0 * c90
    w398 = w86 * w348 + w107 * w351 + w114 * w352 - w394 - (w395 + slider_e2_ddot * w396 + slider_e3_ddot * w397)
    w399 = w388 + w341 * (w389 - w335) + w343 * (w6 * w336 - w11 * w339) + w398
    w400 = w3 * w23
    w401 = w30 - w400
    w402 = w375 - w7 * w19
    w403 = w7 * w23 - w1 * w29
    w404 = shaft_x_ddot * w402 + shaft_y_ddot * w403 + shaft_z_ddot * w401 + shaft_e0_ddot * w39 + shaft_e1_ddot * w378
    w405 = w11 * w40 + shaft_e1 * shaft_e0 * c86
    w406 = w10 * w11 + w3 * w14 + w0 * w15 + w401 * c60 - (w404 + shaft_e2_ddot * (w11 * (w11 * c2) + w3 * w37 + w0 * w38) + shaft_e3_ddot * w405)
    w407 = w3 * w51
    w408 = w406 + w132 * (w146 - w407) + w145 * (w7 * w51 - w1 * w134) + w153 * (w382 - w7 * w48) - w175 * w189
    w409 = w3 * w202
    w410 = w408 + w187 * w197 + w156 * w196 - w177 * w200 + w266 * (w280 - w409) + w278 * (w7 * w202 - w1 * w267)
    w411 = w3 * w334
    w412 = w410 + w287 * (w385 - w7 * w201) - w309 * w322 + w320 * w330 + w290 * w329 + w310 * w333 - w337 * (w411 - w342)
    w413 = w86 * w231
    w414 = w81 * w86
    w415 = w281 * (w390 - w87 * w236) + w269 * (w87 * w231 - w107 * w242) + w254 * (w353 - w413) + (w147 * (w392 - w87 * w89) + w136 * (w81 * w87 - w96 * w107) + w120 * (w356 - w414))
    w416 = slider_e0_ddot * w365 + slider_e1_ddot * w396 + slider_e2_ddot * (w103 * (w103 * c53) + w86 * w363 + w105 * w364)
    w417 = w103 * w366 + slider_e0 * slider_e1 * c91
    w418 = w103 * w348 + w86 * w351 + w105 * w352 - w415 - (w416 + slider_e3_ddot * w417)
    w419 = w412 + w341 * (w1 * w339 - w7 * w334) + w343 * (w7 * w336 - w389) + w418
    w420 = w2 * w19 - w0 * w23
    w421 = w32 - w372
    w422 = w400 - w2 * w29
    w423 = shaft_x_ddot * w421 + shaft_y_ddot * w422 + shaft_z_ddot * w420 + shaft_e0_ddot * w43 + shaft_e1_ddot * w379
    w424 = w6 * w10 + w7 * w14 + w3 * w15 + w420 * c60 - (w423 + shaft_e2_ddot * w405 + shaft_e3_ddot * (w6 * w40 + w7 * w41 + w3 * w42))
    w425 = w424 + w132 * (w2 * w48 - w0 * w51) + w145 * (w407 - w2 * w134) + w153 * (w135 - w381) + w175 * w197
    w426 = w425 + w187 * w189 - w177 * w196 - w156 * w200 + w266 * (w2 * w201 - w0 * w202) + w278 * (w409 - w2 * w267)
    w427 = w426 + w287 * (w268 - w384) + w309 * w330 + w320 * w322 + w310 * w329 - w290 * w333 - w337 * (w0 * w334 - w2 * w336)
    w428 = w281 * (w354 - w391) + w269 * (w413 - w114 * w242) + w254 * (w114 * w236 - w105 * w231) + (w147 * (w357 - w393) + w136 * (w414 - w96 * w114) + w120 * (w89 * w114 - w81 * w105))
    w429 = slider_e0_ddot * w369 + slider_e1_ddot * w397 + slider_e2_ddot * w417 + slider_e3_ddot * (w101 * w366 + w87 * w367 + w86 * w368)
    w430 = w101 * w348 + w87 * w351 + w86 * w352 - w428 - w429
    w431 = w427 + w341 * (w2 * w339 - w411) + w343 * (w387 - w340) + w430
    w432 = w8 * c59
    w433 = w12 * c59
    w434 = w8 * w432 + w12 * w433
    w435 = w4 * w433
    w436 = w46 - w45
    w437 = w4 * w432
    w438 = shaft_x_ddot * c81 + w31 * shaft_e0_ddot + shaft_e1_ddot * w374 + shaft_e2_ddot * w402 + shaft_e3_ddot * w421
    w439 = w287 + (w153 + (w22 * w434 - (w50 * w435 + w436 * w437) - w438)) - w343
    w440 = w26 - w49
    w441 = shaft_y_ddot * c81 + w33 * shaft_e0_ddot + shaft_e1_ddot * w376 + shaft_e2_ddot * w403 + shaft_e3_ddot * w422
    w442 = w278 + (w145 + (w18 * w434 - (w47 * w435 + w437 * w440) - w441)) - w341
    w443 = w16 + w17
    w444 = shaft_z_ddot * c81 + w25 * shaft_e0_ddot + shaft_e1_ddot * w373 + shaft_e2_ddot * w401 + shaft_e3_ddot * w420
    w445 = w337 + (w266 + (w132 + (c92 + (w28 * w434 - (w133 * w435 + w437 * w443)) - w444)))
    w446 = shaft_e1 * 0.5
    w447 = shaft_e0 * 0.5
    w448 = shaft_e3 * 0.5
    w449 = shaft_e2 * 0.5
    w450 = w18 * w22
    w451 = w22 * w28
    w452 = w18 * w28
    w453 = slider_e1 * 0.5
    w454 = slider_e0 * 0.5
    w455 = slider_e3 * 0.5
    w456 = slider_e2 * 0.5
    w457 = right_rod_e3 * 0.5
    w458 = right_rod_e0 * 0.5
    w459 = right_rod_e1 * 0.5
    w460 = w440 * w458 - w436 * w457 + w443 * w459
    w461 = right_rod_e2 * 0.5
    w462 = w436 * w459 + w440 * w461 + w443 * w457
    w463 = w436 * w458 + w440 * w457 - w443 * w461
    w464 = w436 * w461 - w440 * w459 + w443 * w458
    w465 = w320 * (w457 + w436 * w460) - (w333 * (w436 * w462 - w459) + w329 * (w458 - w436 * w463)) - w309 * (w461 - w436 * w464)
    w466 = w309 * (w459 + w440 * w464) - (w333 * (w440 * w462 - w461) + w329 * (w457 - w440 * w463) + w320 * (w458 - w440 * w460))
    w467 = w329 * (w461 + w443 * w463) - w333 * (w443 * w462 - w457) - w320 * (w459 - w443 * w460) - w309 * (w458 - w443 * w464)
    w468 = left_rod_e1 * 0.5
    w469 = left_rod_e2 * 0.5
    w470 = left_rod_e3 * 0.5
    w471 = w436 * w468 + w440 * w469 + w443 * w470
    w472 = left_rod_e0 * 0.5
    w473 = w443 * w469 - (w436 * w472 + w440 * w470)
    w474 = w436 * w470 - w440 * w472 - w443 * w468
    w475 = w440 * w468 - w436 * w469 - w443 * w472
    w476 = w200 * (w436 * w471 - w468) + w196 * (w472 + w436 * w473) + w187 * (w436 * w474 - w470) + w175 * (w469 + w436 * w475)
    w477 = w200 * (w440 * w471 - w469) + w196 * (w470 + w440 * w473) + w187 * (w472 + w440 * w474) + w175 * (w440 * w475 - w468)
    w478 = w200 * (w443 * w471 - w470) + w196 * (w443 * w473 - w469) + w187 * (w468 + w443 * w474) + w175 * (w472 + w443 * w475)
    lam = ca.vertcat(
        w371,
        w399,
        w419,
        w431,
        w439,
        w442,
        w445,
        w370,
        w398,
        w418,
        w430,
        -w343,
        -w341,
        w337,
        w333,
        w329,
        w320,
        w309,
        w287,
        w278,
        w266,
        w200,
        w196,
        w187,
        w175,
        w153,
        w145,
        w132,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w439,
        -w442,
        -w445,
        w371 * w446 - w399 * w447 + w419 * w448 - w431 * w449,
        w371 * w449 - w399 * w448 - w419 * w447 + w431 * w446,
        0.0,
        w343 * (1.0 - w22**2) - w341 * w450 + w337 * w451,
        w341 * (1.0 - w18**2) - w343 * w450 + w337 * w452,
        -(w343 * w451 + w341 * w452 + w337 * (1.0 - w28**2)),
        w370 * w453 - w398 * w454 + w418 * w455 - w430 * w456,
        w370 * w456 - w398 * w455 - w418 * w454 + w430 * w453,
        w370 * w455 + w398 * w456 - w418 * w453 - w430 * w454,
        -w287,
        -w278,
        -w266,
        w465,
        w466,
        w467,
        -w153,
        -w145,
        -w132,
        -w476,
        -w477,
        -w478,
    )
    joint_forces = ca.reshape(joint_forces, 6, 4)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 1086 operations."""
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 125)
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    shaft_x_dot = q_dot[0]
    shaft_y_dot = q_dot[1]
    shaft_z_dot = q_dot[2]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    c8 = c[8]
    c13 = c[13]
    c16 = c[16]
    c18 = c[18]
    c19 = c[19]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c30 = c[30]
    c36 = c[36]
    c39 = c[39]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c53 = c[53]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c66 = c[66]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c72 = c[72]
    c73 = c[73]
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
    c94 = c[94]
    c95 = c[95]
    c96 = c[96]
    c97 = c[97]
    w0 = shaft_e2 * -2.0
    w1 = (1.0 - 2 * shaft_e1**2 - 2 * shaft_e2**2) * c59
    w2 = shaft_e3 * -2.0
    w3 = 2 * shaft_e2
    w4 = 2 * shaft_e0
    w5 = (shaft_e3 * w3 - shaft_e1 * w4) * c59
    w6 = w2 * w5
    w7 = w0 * w1 - w6
    w8 = 2 * shaft_e3
    w9 = w1 * w8 - w0 * w5
    w10 = w1 * w4
    w11 = 2 * shaft_e1
    w12 = w10 - w5 * w11
    w13 = shaft_e1 * -2.0
    w14 = w1 * w13
    w15 = w4 * w5
    w16 = w14 - w15
    w17 = shaft_x_dot * c81 + w7 * shaft_e0_dot + w9 * shaft_e1_dot + w12 * shaft_e2_dot + w16 * shaft_e3_dot
    w18 = (shaft_e2 * w4 + shaft_e3 * w11) * c59
    w19 = w2 * w18 - w14
    w20 = w0 * w18
    w21 = w20 - w10
    w22 = w11 * w18 - w1 * w2
    w23 = w4 * w18
    w24 = w23 - w1 * w3
    w25 = shaft_y_dot * c81 + shaft_e0_dot * w19 + shaft_e1_dot * w21 + shaft_e2_dot * w22 + shaft_e3_dot * w24
    w26 = w5 * w13 - w20
    w27 = w15 - w8 * w18
    w28 = w6 - w23
    w29 = w3 * w5 - w13 * w18
    w30 = shaft_z_dot * c81 + shaft_e0_dot * w26 + shaft_e1_dot * w27 + shaft_e2_dot * w28 + shaft_e3_dot * w29
    w31 = shaft_x_dot * w7 + shaft_y_dot * w19 + shaft_z_dot * w26 + shaft_e0_dot * (w13 * (w13 * c2) + w0 * (w0 * c4) + w2 * (w2 * c5))
    w32 = w4 * c2
    w33 = w13 * w32 + shaft_e2 * shaft_e3 * c82
    w34 = w4 * c4
    w35 = w13 * c5
    w36 = w0 * w34 + shaft_e1 * shaft_e3 * c83
    w37 = w0 * c2
    w38 = w11 * c4
    w39 = w4 * c5
    w40 = shaft_e2 * shaft_e1 * c57 + w2 * w39
    w41 = shaft_x_dot * w17 + shaft_y_dot * w25 + shaft_z_dot * w30 + shaft_e0_dot * (w31 + shaft_e1_dot * w33 + shaft_e2_dot * w36 + shaft_e3_dot * w40)
    w42 = shaft_x_dot * w9 + shaft_y_dot * w21 + shaft_z_dot * w27 + shaft_e0_dot * w33 + shaft_e1_dot * (w4 * w32 + w2 * (w2 * c4) + w3 * (w3 * c5))
    w43 = shaft_e3 * shaft_e0 * c84 + w3 * w35
    w44 = w2 * w38 + shaft_e2 * shaft_e0 * c85
    w45 = shaft_x_dot * w12 + shaft_y_dot * w22 + shaft_z_dot * w28 + shaft_e0_dot * w36 + shaft_e1_dot * w43
    w46 = w8 * w37 + shaft_e1 * shaft_e0 * c86
    w47 = shaft_e2_dot * (w45 + shaft_e2_dot * (w8 * (w8 * c2) + w4 * w34 + w13 * w35) + shaft_e3_dot * w46)
    w48 = shaft_x_dot * w16 + shaft_y_dot * w24 + shaft_z_dot * w29 + shaft_e0_dot * w40 + shaft_e1_dot * w44
    w49 = w41 + shaft_e1_dot * (w42 + shaft_e2_dot * w43 + shaft_e3_dot * w44) + w47 + shaft_e3_dot * (w48 + shaft_e2_dot * w46 + shaft_e3_dot * (w0 * w37 + w11 * w38 + w4 * w39))
    w50 = w49 + slider_x_dot * (slider_x_dot * c50) + slider_y_dot * (slider_y_dot * c50) + slider_z_dot * (slider_z_dot * c50)
    w51 = slider_e1 * -2.0
    w52 = slider_e2 * -2.0
    w53 = slider_e3 * -2.0
    w54 = 2 * slider_e0
    w55 = w54 * c53
    w56 = 2 * slider_e2
    w57 = w51 * w55 + slider_e2 * slider_e3 * c87
    w58 = slider_e0_dot * (w51 * (w51 * c53) + w52 * (w52 * c55) + w53 * (w53 * c56)) + w57 * slider_e1_dot
    w59 = 2 * slider_e3
    w60 = w54 * c55
    w61 = w51 * c56
    w62 = w52 * w60 + slider_e1 * slider_e3 * c88
    w63 = w52 * c53
    w64 = 2 * slider_e1
    w65 = w64 * c55
    w66 = w54 * c56
    w67 = slider_e1 * slider_e2 * c58 + w53 * w66
    w68 = slider_e3 * slider_e0 * c89 + w56 * w61
    w69 = slider_e0_dot * w57 + slider_e1_dot * (w54 * w55 + w53 * (w53 * c55) + w56 * (w56 * c56)) + slider_e2_dot * w68
    w70 = w53 * w65 + slider_e2 * slider_e0 * c90
    w71 = w50 + slider_e0_dot * (w58 + w62 * slider_e2_dot + w67 * slider_e3_dot) + slider_e1_dot * (w69 + slider_e3_dot * w70)
    w72 = slider_e0_dot * w62 + slider_e1_dot * w68 + slider_e2_dot * (w59 * (w59 * c53) + w54 * w60 + w51 * w61)
    w73 = w59 * w63 + slider_e1 * slider_e0 * c91
    w74 = slider_e0_dot * w67 + slider_e1_dot * w70 + slider_e2_dot * w73 + slider_e3_dot * (w52 * w63 + w64 * w65 + w54 * w66)
    w75 = right_rod_e2 * -2.0
    w76 = 2 * right_rod_e1
    w77 = 2 * right_rod_e0
    w78 = w76 * right_rod_e3 - right_rod_e2 * w77
    w79 = w78 * c36
    w80 = right_rod_e3 * -2.0
    w81 = right_rod_e3 * w77 + right_rod_e2 * w76
    w82 = w81 * c36
    w83 = w80 * w82
    w84 = w75 * w79 - w83
    w85 = 2 * right_rod_e3
    w86 = w79 * w85 - w75 * w82
    w87 = w77 * w79
    w88 = w87 - w76 * w82
    w89 = right_rod_e1 * -2.0
    w90 = w79 * w89
    w91 = w77 * w82
    w92 = w90 - w91
    w93 = right_rod_x_dot * c30 + w84 * right_rod_e0_dot + w86 * right_rod_e1_dot + w88 * right_rod_e2_dot + w92 * right_rod_e3_dot
    w94 = 1.0 - 2 * right_rod_e2**2 - 2 * right_rod_e3**2
    w95 = w94 * c36
    w96 = w80 * w95 - w90
    w97 = w75 * w95
    w98 = w97 - w87
    w99 = w76 * w95 - w79 * w80
    w100 = w77 * w95
    w101 = 2 * right_rod_e2
    w102 = w100 - w79 * w101
    w103 = right_rod_y_dot * c30 + right_rod_e0_dot * w96 + right_rod_e1_dot * w98 + right_rod_e2_dot * w99 + right_rod_e3_dot * w102
    w104 = w71 + slider_e2_dot * (w72 + slider_e3_dot * w73) + slider_e3_dot * w74 + right_rod_x_dot * w93 + right_rod_y_dot * w103
    w105 = w82 * w89 - w97
    w106 = w91 - w85 * w95
    w107 = w83 - w100
    w108 = right_rod_z_dot * c30 + right_rod_e0_dot * w105 + right_rod_e1_dot * w106 + right_rod_e2_dot * w107
    w109 = w82 * w101 - w89 * w95
    w110 = right_rod_x_dot * w84 + right_rod_y_dot * w96 + right_rod_z_dot * w105 + right_rod_e0_dot * (w89 * (w89 * c39) + w75 * (w75 * c41) + w80 * (w80 * c42))
    w111 = w77 * c39
    w112 = w89 * w111 + right_rod_e2 * right_rod_e3 * c49
    w113 = w77 * c41
    w114 = w89 * c42
    w115 = w75 * w113 + right_rod_e1 * right_rod_e3 * c48
    w116 = w75 * c39
    w117 = w76 * c41
    w118 = w77 * c42
    w119 = right_rod_e2 * right_rod_e1 * c47 + w80 * w118
    w120 = right_rod_e0_dot * (w110 + right_rod_e1_dot * w112 + right_rod_e2_dot * w115 + right_rod_e3_dot * w119)
    w121 = right_rod_x_dot * w86 + right_rod_y_dot * w98 + right_rod_z_dot * w106 + right_rod_e0_dot * w112 + right_rod_e1_dot * (w77 * w111 + w80 * (w80 * c41) + w101 * (w101 * c42))
    w122 = right_rod_e3 * right_rod_e0 * c46 + w101 * w114
    w123 = w80 * w117 + right_rod_e2 * right_rod_e0 * c45
    w124 = w104 + right_rod_z_dot * (w108 + right_rod_e3_dot * w109) + w120 + right_rod_e1_dot * (w121 + right_rod_e2_dot * w122 + right_rod_e3_dot * w123)
    w125 = right_rod_x_dot * w88 + right_rod_y_dot * w99 + right_rod_z_dot * w107 + right_rod_e0_dot * w115 + right_rod_e1_dot * w122
    w126 = w85 * w116 + right_rod_e1 * right_rod_e0 * c43
    w127 = w125 + right_rod_e2_dot * (w85 * (w85 * c39) + w77 * w113 + w89 * w114) + right_rod_e3_dot * w126
    w128 = right_rod_x_dot * w92 + right_rod_y_dot * w102 + right_rod_z_dot * w109 + right_rod_e0_dot * w119
    w129 = w128 + right_rod_e1_dot * w123 + right_rod_e2_dot * w126 + right_rod_e3_dot * (w75 * w116 + w76 * w117 + w77 * w118)
    w130 = left_rod_e2 * -2.0
    w131 = 2 * left_rod_e1
    w132 = 2 * left_rod_e0
    w133 = w131 * left_rod_e3 - left_rod_e2 * w132
    w134 = w133 * c13
    w135 = left_rod_e3 * -2.0
    w136 = left_rod_e3 * w132 + left_rod_e2 * w131
    w137 = w136 * c13
    w138 = w135 * w137
    w139 = w130 * w134 - w138
    w140 = 2 * left_rod_e3
    w141 = w134 * w140 - w130 * w137
    w142 = w132 * w134
    w143 = w142 - w131 * w137
    w144 = left_rod_e1 * -2.0
    w145 = w134 * w144
    w146 = w132 * w137
    w147 = w145 - w146
    w148 = left_rod_x_dot * c8 + w139 * left_rod_e0_dot + w141 * left_rod_e1_dot + w143 * left_rod_e2_dot + w147 * left_rod_e3_dot
    w149 = 1.0 - 2 * left_rod_e2**2 - 2 * left_rod_e3**2
    w150 = w149 * c13
    w151 = w135 * w150 - w145
    w152 = w130 * w150
    w153 = w152 - w142
    w154 = w131 * w150 - w134 * w135
    w155 = w132 * w150
    w156 = 2 * left_rod_e2
    w157 = w155 - w134 * w156
    w158 = left_rod_y_dot * c8 + left_rod_e0_dot * w151 + left_rod_e1_dot * w153 + left_rod_e2_dot * w154 + left_rod_e3_dot * w157
    w159 = w124 + right_rod_e2_dot * w127 + right_rod_e3_dot * w129 + left_rod_x_dot * w148 + left_rod_y_dot * w158
    w160 = w137 * w144 - w152
    w161 = w146 - w140 * w150
    w162 = w138 - w155
    w163 = w137 * w156 - w144 * w150
    w164 = left_rod_z_dot * c8 + left_rod_e0_dot * w160 + left_rod_e1_dot * w161 + left_rod_e2_dot * w162 + left_rod_e3_dot * w163
    w165 = left_rod_x_dot * w139 + left_rod_y_dot * w151 + left_rod_z_dot * w160 + left_rod_e0_dot * (w144 * (w144 * c16) + w130 * (w130 * c18) + w135 * (w135 * c19))
    w166 = w132 * c16
    w167 = w144 * w166 + left_rod_e2 * left_rod_e3 * c27
    w168 = w132 * c18
    w169 = w144 * c19
    w170 = w130 * w168 + left_rod_e1 * left_rod_e3 * c26
    w171 = w130 * c16
    w172 = w131 * c18
    w173 = w132 * c19
    w174 = left_rod_e2 * left_rod_e1 * c25 + w135 * w173
    w175 = left_rod_e0_dot * (w165 + left_rod_e1_dot * w167 + left_rod_e2_dot * w170 + left_rod_e3_dot * w174)
    w176 = left_rod_x_dot * w141 + left_rod_y_dot * w153 + left_rod_z_dot * w161 + left_rod_e0_dot * w167 + left_rod_e1_dot * (w132 * w166 + w135 * (w135 * c18) + w156 * (w156 * c19))
    w177 = left_rod_e3 * left_rod_e0 * c23 + w156 * w169
    w178 = w135 * w172 + left_rod_e2 * left_rod_e0 * c22
    w179 = w159 + left_rod_z_dot * w164 + w175 + left_rod_e1_dot * (w176 + left_rod_e2_dot * w177 + left_rod_e3_dot * w178)
    w180 = left_rod_x_dot * w143 + left_rod_y_dot * w154 + left_rod_z_dot * w162 + left_rod_e0_dot * w170 + left_rod_e1_dot * w177
    w181 = w140 * w171 + left_rod_e1 * left_rod_e0 * c21
    w182 = w180 + left_rod_e2_dot * (w140 * (w140 * c16) + w132 * w168 + w144 * w169) + left_rod_e3_dot * w181
    w183 = left_rod_x_dot * w147 + left_rod_y_dot * w157 + left_rod_z_dot * w163 + left_rod_e0_dot * w174 + left_rod_e1_dot * w178
    w184 = left_rod_e3_dot * (w183 + left_rod_e2_dot * w181 + left_rod_e3_dot * (w130 * w171 + w131 * w172 + w132 * w173))
    w185 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w186 = w185 * c69
    w187 = w94 * c70
    w188 = slider_x + w186 - (right_rod_x + w187)
    w189 = w188**2
    w190 = slider_e3 * w54 + slider_e2 * w64
    w191 = w190 * c69
    w192 = w81 * c70
    w193 = slider_y + w191 - (right_rod_y + w192)
    w194 = w193**2
    w195 = slider_e3 * w64 - slider_e2 * w54
    w196 = w195 * c69
    w197 = w78 * c70
    w198 = slider_z + w196 - (right_rod_z + w197)
    w199 = w198**2
    w200 = w189 + w194 + w199
    w201 = w185 * c63
    w202 = w149 * c64
    w203 = slider_x + w201 - (left_rod_x + w202)
    w204 = w203**2
    w205 = w190 * c63
    w206 = w136 * c64
    w207 = slider_y + w205 - (left_rod_y + w206)
    w208 = w207**2
    w209 = w195 * c63
    w210 = w133 * c64
    w211 = slider_z + w209 - (left_rod_z + w210)
    w212 = w211**2
    w213 = w204 + w208 + w212
    w214 = (w1 + shaft_z * c81) * c60 + slider_z * c73 + (w79 + right_rod_z * c30) * c60 + (w134 + left_rod_z * c8) * c60
    w215 = slider_e0_dot * w52 + slider_e1_dot * w59 + w54 * slider_e2_dot + w51 * slider_e3_dot
    w216 = slider_e0_dot * w53 + w52 * slider_e1_dot + slider_e2_dot * w64 + w54 * slider_e3_dot
    w217 = w75 * right_rod_e0_dot + w85 * right_rod_e1_dot + w77 * right_rod_e2_dot + w89 * right_rod_e3_dot
    w218 = w80 * right_rod_e0_dot + w75 * right_rod_e1_dot + w76 * right_rod_e2_dot + w77 * right_rod_e3_dot
    w219 = slider_x_dot + (w196 * w215 - w191 * w216) - (right_rod_x_dot + (w197 * w217 - w192 * w218))
    w220 = slider_e0_dot * w51 + w54 * slider_e1_dot + w53 * slider_e2_dot + w56 * slider_e3_dot
    w221 = right_rod_e0_dot * w89 + w77 * right_rod_e1_dot + w80 * right_rod_e2_dot + right_rod_e3_dot * w101
    w222 = slider_y_dot + (w186 * w216 - w196 * w220) - (right_rod_y_dot + (w187 * w218 - w197 * w221))
    w223 = slider_z_dot + (w191 * w220 - w186 * w215) - (right_rod_z_dot + (w192 * w221 - w187 * w217))
    w224 = w219 * c96
    w225 = w189 * (w219**2 * c72) / w200 + w194 * (w222**2 * c72) / w200 + w199 * (w223**2 * c72) / w200 + w193 * (w188 * (w222 * w224)) / w200
    w226 = w130 * left_rod_e0_dot + w140 * left_rod_e1_dot + w132 * left_rod_e2_dot + w144 * left_rod_e3_dot
    w227 = w135 * left_rod_e0_dot + w130 * left_rod_e1_dot + w131 * left_rod_e2_dot + w132 * left_rod_e3_dot
    w228 = slider_x_dot + (w209 * w215 - w205 * w216) - (left_rod_x_dot + (w210 * w226 - w206 * w227))
    w229 = left_rod_e0_dot * w144 + w132 * left_rod_e1_dot + w135 * left_rod_e2_dot + left_rod_e3_dot * w156
    w230 = slider_y_dot + (w201 * w216 - w209 * w220) - (left_rod_y_dot + (w202 * w227 - w210 * w229))
    w231 = slider_z_dot + (w205 * w220 - w201 * w215) - (left_rod_z_dot + (w206 * w229 - w202 * w226))
    w232 = w228 * c97
    w233 = w204 * (w228**2 * c66) / w213 + w208 * (w230**2 * c66) / w213 + w212 * (w231**2 * c66) / w213 + w207 * (w203 * (w230 * w232)) / w213
    w234 = w225 + w198 * (w188 * (w223 * w224)) / w200 + w198 * (w193 * (w223 * (w222 * c96))) / w200 + (w233 + w211 * (w203 * (w231 * w232)) / w213 + w211 * (w207 * (w231 * (w230 * c97))) / w213)
    kinetic = ca.vertcat(
        (w179 + left_rod_e2_dot * w182 + w184) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (ca.sqrt(w200) - c68)**2 * c94 + (ca.sqrt(w213) - c62)**2 * c95,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -w214,
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        w234,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 181 operations."""
    q = ca.SX.sym("q", 32)
    shaft_x = q[0]
    shaft_y = q[1]
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    w0 = 2 * shaft_e2**2
    w1 = 2 * shaft_e3**2
    w2 = 2 * shaft_e0
    w3 = shaft_e3 * w2
    w4 = 2 * shaft_e1
    w5 = shaft_e2 * w4
    w6 = shaft_e3 * w4
    w7 = shaft_e2 * w2
    w8 = 1.0 - 2 * shaft_e1**2
    w9 = w2 * shaft_e1
    w10 = shaft_e3 * (2 * shaft_e2)
    w11 = 2 * slider_e2**2
    w12 = 2 * slider_e3**2
    w13 = 2 * slider_e0
    w14 = slider_e3 * w13
    w15 = 2 * slider_e1
    w16 = slider_e2 * w15
    w17 = slider_e3 * w15
    w18 = slider_e2 * w13
    w19 = 1.0 - 2 * slider_e1**2
    w20 = w13 * slider_e1
    w21 = slider_e3 * (2 * slider_e2)
    w22 = 2 * right_rod_e2**2
    w23 = 2 * right_rod_e3**2
    w24 = 2 * right_rod_e0
    w25 = right_rod_e3 * w24
    w26 = 2 * right_rod_e1
    w27 = right_rod_e2 * w26
    w28 = right_rod_e3 * w26
    w29 = right_rod_e2 * w24
    w30 = 1.0 - 2 * right_rod_e1**2
    w31 = w24 * right_rod_e1
    w32 = right_rod_e3 * (2 * right_rod_e2)
    w33 = 2 * left_rod_e2**2
    w34 = 2 * left_rod_e3**2
    w35 = 2 * left_rod_e0
    w36 = left_rod_e3 * w35
    w37 = 2 * left_rod_e1
    w38 = left_rod_e2 * w37
    w39 = left_rod_e3 * w37
    w40 = left_rod_e2 * w35
    w41 = 1.0 - 2 * left_rod_e1**2
    w42 = w35 * left_rod_e1
    w43 = left_rod_e3 * (2 * left_rod_e2)
    poses = ca.vertcat(
        shaft_x,
        shaft_y,
        shaft_z,
        1.0 - w0 - w1,
        w3 + w5,
        w6 - w7,
        w5 - w3,
        w8 - w1,
        w9 + w10,
        w6 + w7,
        w10 - w9,
        w8 - w0,
        slider_x,
        slider_y,
        slider_z,
        1.0 - w11 - w12,
        w14 + w16,
        w17 - w18,
        w16 - w14,
        w19 - w12,
        w20 + w21,
        w17 + w18,
        w21 - w20,
        w19 - w11,
        right_rod_x,
        right_rod_y,
        right_rod_z,
        1.0 - w22 - w23,
        w25 + w27,
        w28 - w29,
        w27 - w25,
        w30 - w23,
        w31 + w32,
        w28 + w29,
        w32 - w31,
        w30 - w22,
        left_rod_x,
        left_rod_y,
        left_rod_z,
        1.0 - w33 - w34,
        w36 + w38,
        w39 - w40,
        w38 - w36,
        w41 - w34,
        w42 + w43,
        w39 + w40,
        w43 - w42,
        w41 - w33,
    )
    poses = ca.reshape(poses, 12, 4)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 8582 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 28)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    slider_x = q_d[7]
    slider_y = q_d[8]
    slider_z = q_d[9]
    slider_e0 = q_d[10]
    slider_e1 = q_d[11]
    slider_e2 = q_d[12]
    slider_e3 = q_d[13]
    right_rod_x = q_d[14]
    right_rod_y = q_d[15]
    right_rod_z = q_d[16]
    right_rod_e0 = q_d[17]
    right_rod_e1 = q_d[18]
    right_rod_e2 = q_d[19]
    right_rod_e3 = q_d[20]
    left_rod_x = q_d[21]
    left_rod_y = q_d[22]
    left_rod_z = q_d[23]
    left_rod_e0 = q_d[24]
    left_rod_e1 = q_d[25]
    left_rod_e2 = q_d[26]
    left_rod_e3 = q_d[27]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_e0_dot = q_d_dot[3]
    shaft_e1_dot = q_d_dot[4]
    shaft_e2_dot = q_d_dot[5]
    shaft_e3_dot = q_d_dot[6]
    slider_x_dot = q_d_dot[7]
    slider_y_dot = q_d_dot[8]
    slider_z_dot = q_d_dot[9]
    slider_e0_dot = q_d_dot[10]
    slider_e1_dot = q_d_dot[11]
    slider_e2_dot = q_d_dot[12]
    slider_e3_dot = q_d_dot[13]
    right_rod_x_dot = q_d_dot[14]
    right_rod_y_dot = q_d_dot[15]
    right_rod_z_dot = q_d_dot[16]
    right_rod_e0_dot = q_d_dot[17]
    right_rod_e1_dot = q_d_dot[18]
    right_rod_e2_dot = q_d_dot[19]
    right_rod_e3_dot = q_d_dot[20]
    left_rod_x_dot = q_d_dot[21]
    left_rod_y_dot = q_d_dot[22]
    left_rod_z_dot = q_d_dot[23]
    left_rod_e0_dot = q_d_dot[24]
    left_rod_e1_dot = q_d_dot[25]
    left_rod_e2_dot = q_d_dot[26]
    left_rod_e3_dot = q_d_dot[27]
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
    c119 = c[119]
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = shaft_e2 * -2.0
    w4 = 2 * shaft_e1
    w5 = 2 * shaft_e0
    w6 = w5 * c5
    w7 = w3 * (w3 * c2) + w4 * (w4 * c4) + w5 * w6
    w8 = spin_angle_dot / 2.0
    w9 = w8**2
    w10 = w9 * (w1 * 0.5)
    w11 = shaft_e1 * -2.0
    w12 = shaft_e3 * -2.0
    w13 = shaft_e2 * shaft_e1 * c57 + w6 * w12
    w14 = ca.sin(w0)
    w15 = w9 * (w14 * 0.5)
    w16 = 2 * shaft_e2
    w17 = w5 * shaft_e3 + shaft_e2 * w4
    w18 = shaft_e3 * w16 - shaft_e1 * w5
    w19 = w17 * c6 + w18 * c7
    w20 = 2 * shaft_e2**2
    w21 = 1.0 - w20 - 2 * shaft_e3**2
    w22 = shaft_e2 * w5
    w23 = w4 * shaft_e3
    w24 = w22 + w23
    w25 = w21 * c6 + w24 * c7
    w26 = w16 * w19 - w11 * w25
    w27 = w11 * w19 - w3 * w25
    w28 = w15 * w27 - w10 * w26
    w29 = left_rod_e1 * -2.0
    w30 = 2 * left_rod_e0
    w31 = w30 * left_rod_e3
    w32 = 2 * left_rod_e1
    w33 = w32 * left_rod_e2
    w34 = w31 + w33
    w35 = w34 * c13
    w36 = left_rod_e2 * -2.0
    w37 = 2 * left_rod_e2**2
    w38 = 2 * left_rod_e3**2
    w39 = 1.0 - w37 - w38
    w40 = w39 * c13
    w41 = w36 * w40
    w42 = w29 * w35 - w41
    w43 = left_swing_angle / 2.0
    w44 = ca.sin(w43)
    w45 = w44 * c9 * c10 - w44 * c11 * c12
    w46 = ca.cos(w43)
    w47 = w46 * c24
    w48 = w15 * w45 + w10 * w47
    w49 = w30 * w35
    w50 = 2 * left_rod_e3
    w51 = w49 - w40 * w50
    w52 = w44 * c20
    w53 = w46 * c9 * c12 - w46 * c11 * c10
    w54 = w15 * w52 + w10 * w53
    w55 = left_rod_e3 * -2.0
    w56 = w35 * w55
    w57 = w30 * w40
    w58 = w56 - w57
    w59 = w15 * w53 - w10 * w52
    w60 = 2 * left_rod_e2
    w61 = w35 * w60 - w29 * w40
    w62 = w15 * w47 - w10 * w45
    w63 = w28 * c8 + w42 * w48 + w51 * w54 + w58 * w59 + w61 * w62
    w64 = w23 - w22
    w65 = 1.0 - 2 * shaft_e1**2 - w20
    w66 = w64 * c6 + w65 * c7
    w67 = w5 * w25 - w16 * w66
    w68 = w11 * w66
    w69 = w12 * w25 - w68
    w70 = w15 * w69 - w10 * w67
    w71 = left_rod_e3 * w32
    w72 = w30 * left_rod_e2
    w73 = w71 - w72
    w74 = w73 * c13
    w75 = w29 * w74
    w76 = w40 * w55 - w75
    w77 = w30 * w74
    w78 = w41 - w77
    w79 = w32 * w40 - w55 * w74
    w80 = w57 - w60 * w74
    w81 = w70 * c8 + w48 * w76 + w54 * w78 + w59 * w79 + w62 * w80
    w82 = w68 - w5 * w19
    w83 = w3 * w66 - w12 * w19
    w84 = w15 * w83 - w10 * w82
    w85 = w36 * w74 - w56
    w86 = w50 * w74 - w35 * w36
    w87 = w77 - w32 * w35
    w88 = w75 - w49
    w89 = w84 * c8 + w48 * w85 + w54 * w86 + w59 * w87 + w62 * w88
    w90 = w36 * c16
    w91 = w32 * c18
    w92 = w30 * c19
    w93 = left_rod_e1 * left_rod_e2 * c25 + w55 * w92
    w94 = w55 * w91 + left_rod_e0 * left_rod_e2 * c22
    w95 = w50 * w90 + left_rod_e1 * left_rod_e0 * c21
    w96 = w36 * w90 + w32 * w91 + w30 * w92
    w97 = w84 * w88 + w70 * w80 + w28 * w61 + w48 * w93 + w54 * w94 + w59 * w95 + w62 * w96
    w98 = w50 * c16
    w99 = w30 * c18
    w100 = w29 * c19
    w101 = w36 * w99 + left_rod_e1 * left_rod_e3 * c26
    w102 = left_rod_e0 * left_rod_e3 * c23 + w60 * w100
    w103 = w50 * w98 + w30 * w99 + w29 * w100
    w104 = w84 * w87 + w70 * w79 + w28 * w58 + w48 * w101 + w54 * w102 + w59 * w103 + w62 * w95
    w105 = w30 * c16
    w106 = w55 * c18
    w107 = w60 * c19
    w108 = w29 * w105 + left_rod_e3 * left_rod_e2 * c27
    w109 = w30 * w105 + w55 * w106 + w60 * w107
    w110 = w84 * w86 + w70 * w78 + w28 * w51 + w48 * w108 + w54 * w109 + w59 * w102 + w62 * w94
    w111 = w29 * (w29 * c16) + w36 * (w36 * c18) + w55 * (w55 * c19)
    w112 = w84 * w85 + w70 * w76 + w28 * w42 + w48 * w111 + w54 * w108 + w59 * w101 + w62 * w93
    w113 = w7 * w10 - w13 * w15 - w26 * w63 - w67 * w81 - w82 * w89 - w45 * w97 - w52 * w104 + w53 * w110 + w47 * w112
    w114 = w17 * c28 + w18 * c29
    w115 = w21 * c28 + w24 * c29
    w116 = w16 * w114 - w11 * w115
    w117 = w11 * w114 - w3 * w115
    w118 = w15 * w117 - w10 * w116
    w119 = right_rod_e1 * -2.0
    w120 = 2 * right_rod_e0
    w121 = w120 * right_rod_e3
    w122 = 2 * right_rod_e1
    w123 = w122 * right_rod_e2
    w124 = w121 + w123
    w125 = w124 * c36
    w126 = right_rod_e2 * -2.0
    w127 = 2 * right_rod_e2**2
    w128 = 2 * right_rod_e3**2
    w129 = 1.0 - w127 - w128
    w130 = w129 * c36
    w131 = w126 * w130
    w132 = w119 * w125 - w131
    w133 = right_swing_angle / 2.0
    w134 = ca.sin(w133)
    w135 = w134 * c31 * c32 - w134 * c33 * c34
    w136 = ca.cos(w133)
    w137 = w136 * c35
    w138 = w10 * w135 + w15 * w137
    w139 = w120 * w125
    w140 = 2 * right_rod_e3
    w141 = w139 - w130 * w140
    w142 = w136 * c33 * c32 - w136 * c31 * c34
    w143 = w134 * c44
    w144 = w15 * w142 - w10 * w143
    w145 = right_rod_e3 * -2.0
    w146 = w125 * w145
    w147 = w120 * w130
    w148 = w146 - w147
    w149 = w15 * w143 + w10 * w142
    w150 = 2 * right_rod_e2
    w151 = w125 * w150 - w119 * w130
    w152 = w15 * w135 - w10 * w137
    w153 = w118 * c30 + w132 * w138 + w141 * w144 - w148 * w149 + w151 * w152
    w154 = w64 * c28 + w65 * c29
    w155 = w5 * w115 - w16 * w154
    w156 = w11 * w154
    w157 = w12 * w115 - w156
    w158 = w15 * w157 - w10 * w155
    w159 = right_rod_e3 * w122
    w160 = w120 * right_rod_e2
    w161 = w159 - w160
    w162 = w161 * c36
    w163 = w119 * w162
    w164 = w130 * w145 - w163
    w165 = w120 * w162
    w166 = w131 - w165
    w167 = w122 * w130 - w145 * w162
    w168 = w147 - w150 * w162
    w169 = w158 * c30 + w138 * w164 + w144 * w166 - w149 * w167 + w152 * w168
    w170 = w156 - w5 * w114
    w171 = w3 * w154 - w12 * w114
    w172 = w15 * w171 - w10 * w170
    w173 = w126 * w162 - w146
    w174 = w140 * w162 - w125 * w126
    w175 = w165 - w122 * w125
    w176 = w163 - w139
    w177 = w172 * c30 + w138 * w173 + w144 * w174 - w149 * w175 + w152 * w176
    w178 = w126 * c39
    w179 = w122 * c41
    w180 = w120 * c42
    w181 = right_rod_e1 * right_rod_e2 * c47 + w145 * w180
    w182 = w145 * w179 + right_rod_e0 * right_rod_e2 * c45
    w183 = w140 * w178 + right_rod_e1 * right_rod_e0 * c43
    w184 = w126 * w178 + w122 * w179 + w120 * w180
    w185 = w172 * w176 + w158 * w168 + w118 * w151 + w138 * w181 + w144 * w182 - w149 * w183 + w152 * w184
    w186 = w140 * c39
    w187 = w120 * c41
    w188 = w119 * c42
    w189 = w126 * w187 + right_rod_e1 * right_rod_e3 * c48
    w190 = right_rod_e0 * right_rod_e3 * c46 + w150 * w188
    w191 = w140 * w186 + w120 * w187 + w119 * w188
    w192 = w172 * w175 + w158 * w167 + w118 * w148 + w138 * w189 + w144 * w190 - w149 * w191 + w152 * w183
    w193 = w120 * c39
    w194 = w145 * c41
    w195 = w150 * c42
    w196 = w119 * w193 + right_rod_e3 * right_rod_e2 * c49
    w197 = w120 * w193 + w145 * w194 + w150 * w195
    w198 = w172 * w174 + w158 * w166 + w118 * w141 + w138 * w196 + w144 * w197 - w149 * w190 + w152 * w182
    w199 = w119 * (w119 * c39) + w126 * (w126 * c41) + w145 * (w145 * c42)
    w200 = w172 * w173 + w158 * w164 + w118 * w132 + w138 * w199 + w144 * w196 - w149 * w189 + w152 * w181
    w201 = w113 - w116 * w153 - w155 * w169 - w170 * w177 - w137 * w185 - w142 * w192 - w143 * w198 + w135 * w200
    w202 = w24 * height_travel
    w203 = w18 * height_travel
    w204 = w11 * w202 - w16 * w203
    w205 = w3 * w202 - w11 * w203
    w206 = (w10 * w204 - w15 * w205) * c50
    w207 = w65 * height_travel
    w208 = w16 * w207 - w5 * w202
    w209 = w11 * w207
    w210 = w209 - w12 * w202
    w211 = (w10 * w208 - w15 * w210) * c50
    w212 = w5 * w203 - w209
    w213 = w12 * w203 - w3 * w207
    w214 = (w10 * w212 - w15 * w213) * c50
    w215 = slider_e2 * -2.0
    w216 = 2 * slider_e1
    w217 = 2 * slider_e0
    w218 = w217 * c56
    w219 = w215 * (w215 * c53) + w216 * (w216 * c55) + w217 * w218
    w220 = slider_e1 * -2.0
    w221 = slider_e3 * -2.0
    w222 = slider_e2 * slider_e1 * c58 + w218 * w221
    w223 = w12 * shaft_e0_dot
    w224 = w5 * shaft_e3_dot
    w225 = w223 + w16 * shaft_e1_dot + w11 * shaft_e2_dot + w224
    w226 = w225 * c1
    w227 = w3 * shaft_e0_dot
    w228 = w5 * shaft_e2_dot
    w229 = w227 + w12 * shaft_e1_dot + w228 + w4 * shaft_e3_dot
    w230 = w229 * c0
    w231 = w226 * w229 - w225 * w230
    w232 = w11 * shaft_e0_dot + w5 * shaft_e1_dot
    w233 = 2 * shaft_e3
    w234 = w232 + shaft_e2_dot * w233 + w3 * shaft_e3_dot
    w235 = w234 * c3
    w236 = w225 * w235 - w226 * w234
    w237 = w230 * w234 - w229 * w235
    w238 = w18 * c59
    w239 = w24 * c59
    w240 = w1 * w9
    w241 = w9 * w14
    w242 = w55 * left_rod_e0_dot
    w243 = w30 * left_rod_e3_dot
    w244 = w242 + w60 * left_rod_e1_dot + w29 * left_rod_e2_dot + w243
    w245 = w244 * c13
    w246 = w36 * left_rod_e0_dot
    w247 = w30 * left_rod_e2_dot
    w248 = w246 + w55 * left_rod_e1_dot + w247 + w32 * left_rod_e3_dot
    w249 = w248 * c13
    w250 = w244 * w245 + w248 * w249
    w251 = left_rod_e1 * w30
    w252 = left_rod_e3 * w60
    w253 = w251 + w252
    w254 = w29 * left_rod_e0_dot + w30 * left_rod_e1_dot
    w255 = w254 + w50 * left_rod_e2_dot + w36 * left_rod_e3_dot
    w256 = w249 * w255
    w257 = 1.0 - 2 * left_rod_e1**2
    w258 = w257 - w37
    w259 = w245 * w255
    w260 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w261 = w260 * c63
    w262 = w39 * c64
    w263 = slider_x + w261 - (left_rod_x + w262)
    w264 = w217 * slider_e3 + slider_e2 * w216
    w265 = w264 * c63
    w266 = w34 * c64
    w267 = slider_y + w265 - (left_rod_y + w266)
    w268 = w216 * slider_e3 - slider_e2 * w217
    w269 = w268 * c63
    w270 = w73 * c64
    w271 = slider_z + w269 - (left_rod_z + w270)
    w272 = w263**2 + w267**2 + w271**2
    w273 = ca.sqrt(w272)
    w274 = c62 / w273
    w275 = 1.0 - w274
    w276 = w215 * slider_e0_dot
    w277 = 2 * slider_e3
    w278 = w217 * slider_e2_dot
    w279 = w276 + slider_e1_dot * w277 + w278 + w220 * slider_e3_dot
    w280 = w221 * slider_e0_dot
    w281 = w217 * slider_e3_dot
    w282 = w280 + w215 * slider_e1_dot + w216 * slider_e2_dot + w281
    w283 = w247 + (w246 + w50 * left_rod_e1_dot) + w29 * left_rod_e3_dot
    w284 = w243 + (w242 + w36 * left_rod_e1_dot + w32 * left_rod_e2_dot)
    w285 = slider_x_dot + (w269 * w279 - w265 * w282) - (left_rod_x_dot + (w270 * w283 - w266 * w284))
    w286 = w220 * slider_e0_dot + w217 * slider_e1_dot
    w287 = 2 * slider_e2
    w288 = w286 + w221 * slider_e2_dot + slider_e3_dot * w287
    w289 = w254 + w55 * left_rod_e2_dot + w60 * left_rod_e3_dot
    w290 = slider_y_dot + (w261 * w282 - w269 * w288) - (left_rod_y_dot + (w262 * w284 - w270 * w289))
    w291 = slider_z_dot + (w265 * w288 - w261 * w279) - (left_rod_z_dot + (w266 * w289 - w262 * w283))
    w292 = (w263 * w285 + w267 * w290 + w271 * w291) * c66
    w293 = w271 * w292 / w272
    w294 = w271 * w275 * c65 + w293
    w295 = w232 + w12 * shaft_e2_dot + w16 * shaft_e3_dot
    w296 = w224 + (w223 + w3 * shaft_e1_dot + w4 * shaft_e2_dot)
    w297 = w25 * w296 - w66 * w295
    w298 = w228 + (w227 + shaft_e1_dot * w233) + w11 * shaft_e3_dot
    w299 = w66 * w298 - w19 * w296
    w300 = w295 * w297 - w298 * w299 - w27 * w240 - w26 * w241
    w301 = left_swing_angle_dot / 2.0
    w302 = w301**2
    w303 = w44 * w302
    w304 = w303 * c11 * c12 - w303 * c9 * c10
    w305 = w46 * w302
    w306 = w305 * c11 * c10 - w305 * c9 * c12
    w307 = w301 * (w44 * w301)
    w308 = w307 * c20
    w309 = w301 * (w46 * w301)
    w310 = w309 * c24
    w311 = w46 / 2.0
    w312 = left_swing_angle_dot * w311
    w313 = w312 * c9 * c10 - w312 * c11 * c12
    w314 = w312 * c20
    w315 = w44 / 2.0
    w316 = left_swing_angle_dot * w315
    w317 = w316 * c11 * c10 - w316 * c9 * c12
    w318 = w316 * c24
    w319 = shaft_e0_dot * w313 - (shaft_e1_dot * w314 + shaft_e2_dot * w317 - shaft_e3_dot * w318)
    w320 = w319 + (shaft_e0 * w304 - (shaft_e2 * w306 - shaft_e1 * w308 - shaft_e3 * w310) + w319) - w45 * w240
    w321 = w320 + w47 * w241
    w322 = shaft_e0_dot * w314 + shaft_e1_dot * w313 - (shaft_e2_dot * w318 + shaft_e3_dot * w317)
    w323 = w322 + (shaft_e1 * w304 - shaft_e0 * w308 - (shaft_e2 * w310 + shaft_e3 * w306) + w322) - w52 * w240
    w324 = w323 + w53 * w241
    w325 = shaft_e0_dot * w317 + shaft_e2_dot * w313 + (shaft_e3_dot * w314 + shaft_e1_dot * w318)
    w326 = w325 + (shaft_e0 * w306 + shaft_e2 * w304 + (shaft_e1 * w310 - shaft_e3 * w308) + w325) - w53 * w240
    w327 = w326 - w52 * w241
    w328 = shaft_e3_dot * w313 - shaft_e0_dot * w318 + (shaft_e1_dot * w317 - shaft_e2_dot * w314)
    w329 = w328 + (shaft_e3 * w304 - shaft_e0 * w310 + (shaft_e1 * w306 + shaft_e2 * w308) + w328) - w47 * w240
    w330 = w329 - w45 * w241
    w331 = w73 * w250 - w253 * w256 - w258 * w259 + (c61 + w294) - (w300 * c8 + w42 * w321 + w51 * w324 + w58 * w327 + w61 * w330)
    w332 = w3 * w231 + w4 * w236 + w5 * w237 + (w16 * w238 - w11 * w239) * c60 + (w13 * w240 + w7 * w241) + w26 * w331
    w333 = w257 - w38
    w334 = w252 - w251
    w335 = w267 * w292 / w272
    w336 = w267 * w275 * c65 + w335
    w337 = w19 * w295 - w25 * w298
    w338 = w296 * w299 - w295 * w337 - w69 * w240 - w67 * w241
    w339 = w34 * w250 - w256 * w333 - w259 * w334 + w336 - (w338 * c8 + w76 * w321 + w78 * w324 + w79 * w327 + w80 * w330)
    w340 = w33 - w31
    w341 = w71 + w72
    w342 = w263 * w292 / w272
    w343 = w263 * w275 * c65 + w342
    w344 = w298 * w337 - w296 * w297 - w83 * w240 - w82 * w241
    w345 = w39 * w250 - w256 * w340 - w259 * w341 + w343 - (w344 * c8 + w85 * w321 + w86 * w324 + w87 * w327 + w88 * w330)
    w346 = w244 * c15
    w347 = w248 * c14
    w348 = w248 * w346 - w244 * w347
    w349 = w255 * c17
    w350 = w244 * w349 - w255 * w346
    w351 = w255 * w347 - w248 * w349
    w352 = w29 * w270
    w353 = w30 * w266
    w354 = w352 - w353
    w355 = w30 * w262
    w356 = w355 - w60 * w270
    w357 = w60 * w266 - w29 * w262
    w358 = w36 * w348 + w32 * w350 + w30 * w351 + (w61 * c60 + (w343 * w354 + w336 * w356 + w294 * w357)) - (w88 * w344 + w80 * w338 + w61 * w300 + w93 * w321 + w94 * w324 + w95 * w327 + w96 * w330)
    w359 = w30 * w270
    w360 = w359 - w32 * w266
    w361 = w32 * w262 - w55 * w270
    w362 = w55 * w266
    w363 = w362 - w355
    w364 = w50 * w348 + w30 * w350 + w29 * w351 + (w58 * c60 + (w343 * w360 + w336 * w361 + w294 * w363)) - (w87 * w344 + w79 * w338 + w58 * w300 + w101 * w321 + w102 * w324 + w103 * w327 + w95 * w330)
    w365 = w50 * w270 - w36 * w266
    w366 = w36 * w262
    w367 = w366 - w359
    w368 = w353 - w50 * w262
    w369 = w30 * w348 + w55 * w350 + w60 * w351 + (w51 * c60 + (w343 * w365 + w336 * w367 + w294 * w368)) - (w86 * w344 + w78 * w338 + w51 * w300 + w108 * w321 + w109 * w324 + w102 * w327 + w94 * w330)
    w370 = w36 * w270 - w362
    w371 = w55 * w262 - w352
    w372 = w29 * w266 - w366
    w373 = w29 * w348 + w36 * w350 + w55 * w351 + (w42 * c60 + (w343 * w370 + w336 * w371 + w294 * w372)) - (w85 * w344 + w76 * w338 + w42 * w300 + w111 * w321 + w108 * w324 + w101 * w327 + w93 * w330)
    w374 = w145 * right_rod_e0_dot
    w375 = w120 * right_rod_e3_dot
    w376 = w374 + w150 * right_rod_e1_dot + w119 * right_rod_e2_dot + w375
    w377 = w376 * c36
    w378 = w126 * right_rod_e0_dot
    w379 = w120 * right_rod_e2_dot
    w380 = w378 + w145 * right_rod_e1_dot + w379 + w122 * right_rod_e3_dot
    w381 = w380 * c36
    w382 = w376 * w377 + w380 * w381
    w383 = right_rod_e1 * w120
    w384 = right_rod_e3 * w150
    w385 = w383 + w384
    w386 = w119 * right_rod_e0_dot + w120 * right_rod_e1_dot
    w387 = w386 + w140 * right_rod_e2_dot + w126 * right_rod_e3_dot
    w388 = w381 * w387
    w389 = 1.0 - 2 * right_rod_e1**2
    w390 = w389 - w127
    w391 = w377 * w387
    w392 = w260 * c69
    w393 = w129 * c70
    w394 = slider_x + w392 - (right_rod_x + w393)
    w395 = w264 * c69
    w396 = w124 * c70
    w397 = slider_y + w395 - (right_rod_y + w396)
    w398 = w268 * c69
    w399 = w161 * c70
    w400 = slider_z + w398 - (right_rod_z + w399)
    w401 = w394**2 + w397**2 + w400**2
    w402 = ca.sqrt(w401)
    w403 = c68 / w402
    w404 = 1.0 - w403
    w405 = w379 + (w378 + w140 * right_rod_e1_dot) + w119 * right_rod_e3_dot
    w406 = w375 + (w374 + w126 * right_rod_e1_dot + w122 * right_rod_e2_dot)
    w407 = slider_x_dot + (w279 * w398 - w282 * w395) - (right_rod_x_dot + (w399 * w405 - w396 * w406))
    w408 = w386 + w145 * right_rod_e2_dot + w150 * right_rod_e3_dot
    w409 = slider_y_dot + (w282 * w392 - w288 * w398) - (right_rod_y_dot + (w393 * w406 - w399 * w408))
    w410 = slider_z_dot + (w288 * w395 - w279 * w392) - (right_rod_z_dot + (w396 * w408 - w393 * w405))
    w411 = (w394 * w407 + w397 * w409 + w400 * w410) * c72
    w412 = w400 * w411 / w401
    w413 = w400 * w404 * c71 + w412
    w414 = w115 * w296 - w154 * w295
    w415 = w154 * w298 - w114 * w296
    w416 = w295 * w414 - w298 * w415 - w117 * w240 - w116 * w241
    w417 = right_swing_angle_dot / 2.0
    w418 = w417**2
    w419 = w136 * w418
    w420 = w417 * (w136 * w417)
    w421 = w420 * c35
    w422 = w419 * c31 * c34 - w419 * c33 * c32
    w423 = w134 * w418
    w424 = w417 * (w134 * w417)
    w425 = w424 * c44
    w426 = w423 * c33 * c34 - w423 * c31 * c32
    w427 = w134 / 2.0
    w428 = right_swing_angle_dot * w427
    w429 = w428 * c35
    w430 = w428 * c31 * c34 - w428 * c33 * c32
    w431 = w136 / 2.0
    w432 = right_swing_angle_dot * w431
    w433 = w432 * c44
    w434 = w432 * c31 * c32 - w432 * c33 * c34
    w435 = shaft_e0_dot * w429 + (shaft_e1_dot * w430 - shaft_e2_dot * w433 + shaft_e3_dot * w434)
    w436 = w435 + (shaft_e0 * w421 + (shaft_e1 * w422 + shaft_e2 * w425 + shaft_e3 * w426) + w435) + w137 * w240
    w437 = w135 * w241 - w436
    w438 = shaft_e0_dot * w430 - shaft_e1_dot * w429 + (shaft_e2_dot * w434 + shaft_e3_dot * w433)
    w439 = w438 + (shaft_e0 * w422 - shaft_e1 * w421 + (shaft_e2 * w426 - shaft_e3 * w425) + w438) - w142 * w240
    w440 = w439 - w143 * w241
    w441 = shaft_e3_dot * w430 - shaft_e1_dot * w434 - (shaft_e0_dot * w433 + shaft_e2_dot * w429)
    w442 = w441 + (shaft_e0 * w425 - shaft_e2 * w421 + (shaft_e3 * w422 - shaft_e1 * w426) + w441) + w143 * w240
    w443 = w442 - w142 * w241
    w444 = shaft_e0_dot * w434 - shaft_e3_dot * w429 - (shaft_e1_dot * w433 + shaft_e2_dot * w430)
    w445 = w444 + (shaft_e0 * w426 - shaft_e3 * w421 + (shaft_e1 * w425 - shaft_e2 * w422) + w444) - w135 * w240
    w446 = w445 - w137 * w241
    w447 = w161 * w382 - w385 * w388 - w390 * w391 + (c67 + w413) - (w416 * c30 + w132 * w437 + w141 * w440 + w148 * w443 + w151 * w446)
    w448 = w389 - w128
    w449 = w384 - w383
    w450 = w397 * w411 / w401
    w451 = w397 * w404 * c71 + w450
    w452 = w114 * w295 - w115 * w298
    w453 = w296 * w415 - w295 * w452 - w157 * w240 - w155 * w241
    w454 = w124 * w382 - w388 * w448 - w391 * w449 + w451 - (w453 * c30 + w164 * w437 + w166 * w440 + w167 * w443 + w168 * w446)
    w455 = w332 + w67 * w339 + w82 * w345 + w45 * w358 + w52 * w364 - w53 * w369 - w47 * w373 + w116 * w447 + w155 * w454
    w456 = w123 - w121
    w457 = w159 + w160
    w458 = w394 * w411 / w401
    w459 = w394 * w404 * c71 + w458
    w460 = w298 * w452 - w296 * w414 - w171 * w240 - w170 * w241
    w461 = w129 * w382 - w388 * w456 - w391 * w457 + w459 - (w460 * c30 + w173 * w437 + w174 * w440 + w175 * w443 + w176 * w446)
    w462 = w376 * c38
    w463 = w380 * c37
    w464 = w380 * w462 - w376 * w463
    w465 = w387 * c40
    w466 = w376 * w465 - w387 * w462
    w467 = w387 * w463 - w380 * w465
    w468 = w119 * w399
    w469 = w120 * w396
    w470 = w468 - w469
    w471 = w120 * w393
    w472 = w471 - w150 * w399
    w473 = w150 * w396 - w119 * w393
    w474 = w126 * w464 + w122 * w466 + w120 * w467 + (w151 * c60 + (w459 * w470 + w451 * w472 + w413 * w473))
    w475 = w474 - (w176 * w460 + w168 * w453 + w151 * w416 + w181 * w437 + w182 * w440 + w183 * w443 + w184 * w446)
    w476 = w120 * w399
    w477 = w476 - w122 * w396
    w478 = w122 * w393 - w145 * w399
    w479 = w145 * w396
    w480 = w479 - w471
    w481 = w140 * w464 + w120 * w466 + w119 * w467 + (w148 * c60 + (w459 * w477 + w451 * w478 + w413 * w480))
    w482 = w481 - (w175 * w460 + w167 * w453 + w148 * w416 + w189 * w437 + w190 * w440 + w191 * w443 + w183 * w446)
    w483 = w140 * w399 - w126 * w396
    w484 = w126 * w393
    w485 = w484 - w476
    w486 = w469 - w140 * w393
    w487 = w120 * w464 + w145 * w466 + w150 * w467 + (w141 * c60 + (w459 * w483 + w451 * w485 + w413 * w486))
    w488 = w487 - (w174 * w460 + w166 * w453 + w141 * w416 + w196 * w437 + w197 * w440 + w190 * w443 + w182 * w446)
    w489 = w126 * w399 - w479
    w490 = w145 * w393 - w468
    w491 = w119 * w396 - w484
    w492 = w119 * w464 + w126 * w466 + w145 * w467 + (w132 * c60 + (w459 * w489 + w451 * w490 + w413 * w491))
    w493 = w492 - (w173 * w460 + w164 * w453 + w132 * w416 + w199 * w437 + w196 * w440 + w189 * w443 + w181 * w446)
    w494 = w24 * w296 - w65 * w295
    w495 = w65 * w298 - w18 * w296
    w496 = w295 * w494 - w298 * w495
    w497 = 2 * height_travel_dot
    w498 = w18 * w295 - w24 * w298
    w499 = c73 - w413 - w294 - (height_travel * w496 + w497 * w498 + w205 * w240 + w204 * w241) * c50
    w500 = w296 * w495 - w295 * w498
    w501 = w336 + w451 + (height_travel * w500 + w494 * w497 + w210 * w240 + w208 * w241) * c50
    w502 = w455 + w170 * w461 + w137 * w475 + w142 * w482 + w143 * w488 - w135 * w493 - w204 * w499 + w208 * w501
    w503 = w298 * w498 - w296 * w494
    w504 = w343 + w459 + (height_travel * w503 + w495 * w497 + w213 * w240 + w212 * w241) * c50
    w505 = w281 + (w280 + slider_e1_dot * w287 + w220 * slider_e2_dot)
    w506 = w505 * c52
    w507 = w278 + (w276 + w221 * slider_e1_dot) + w216 * slider_e3_dot
    w508 = w507 * c51
    w509 = w506 * w507 - w505 * w508
    w510 = w286 + w277 * slider_e2_dot + w215 * slider_e3_dot
    w511 = w510 * c54
    w512 = w505 * w511 - w506 * w510
    w513 = w508 * w510 - w507 * w511
    w514 = w220 * w398
    w515 = w514 - w217 * w395
    w516 = w217 * w392 - w287 * w398
    w517 = w287 * w395 - w220 * w392
    w518 = w220 * w269
    w519 = w518 - w217 * w265
    w520 = w217 * w261 - w269 * w287
    w521 = w265 * w287 - w220 * w261
    w522 = w215 * w509 + w216 * w512 + w217 * w513 - (w459 * w515 + w451 * w516 + w413 * w517 + (w343 * w519 + w336 * w520 + w294 * w521))
    w523 = w14 * 0.25
    w524 = w2 * (w201 + w204 * w206 + w208 * w211 + w212 * w214 + (w10 * w219 - w15 * w222)) - (w502 + w212 * w504 + (w522 + (w222 * w240 + w219 * w241))) * w523
    w525 = w14 / 2.0
    w526 = w11 * (w11 * c2) + w3 * (w3 * c4) + w12 * (w12 * c5)
    w527 = w10 * w13 - w15 * w526 - w27 * w63 - w69 * w81 - w83 * w89 - w47 * w97 - w53 * w104 - w52 * w110 - w45 * w112
    w528 = w527 - w117 * w153 - w157 * w169 - w171 * w177 - w135 * w185 + w143 * w192 - w142 * w198 - w137 * w200
    w529 = w220 * (w220 * c53) + w215 * (w215 * c55) + w221 * (w221 * c56)
    w530 = w11 * w231 + w3 * w236 + w12 * w237 + (w11 * w238 - w3 * w239) * c60 + (w240 * w526 + w13 * w241)
    w531 = w530 + w27 * w331 + w69 * w339 + w83 * w345 + w47 * w358 + w53 * w364 + w52 * w369 + w45 * w373 + w117 * w447
    w532 = w531 + w157 * w454 + w171 * w461 + w135 * w475 - w143 * w482 + w142 * w488 + w137 * w493 - w205 * w499
    w533 = w215 * w398 - w221 * w395
    w534 = w221 * w392 - w514
    w535 = w220 * w395 - w215 * w392
    w536 = w215 * w269 - w221 * w265
    w537 = w221 * w261 - w518
    w538 = w220 * w265 - w215 * w261
    w539 = w220 * w509 + w215 * w512 + w221 * w513 - (w459 * w533 + w451 * w534 + w413 * w535 + (w343 * w536 + w336 * w537 + w294 * w538))
    w540 = w1 * 0.25
    w541 = w525 * (w528 + w205 * w206 + w210 * w211 + w213 * w214 + (w10 * w222 - w15 * w529)) + (w532 + w210 * w501 + w213 * w504 + (w539 + (w240 * w529 + w222 * w241))) * w540
    w542 = w137 * w525 + w2 * w135
    w543 = w2 * w143 - w142 * w525
    w544 = w143 * w525 + w2 * w142
    w545 = w2 * w137 - w135 * w525
    w546 = w2 * w170 - w171 * w525
    w547 = w2 * w155 - w157 * w525
    w548 = w2 * w116 - w117 * w525
    w549 = w189 * w542 - w190 * w543 - w191 * w544 - w183 * w545 - w175 * w546 - w167 * w547 - w148 * w548
    w550 = w181 * w542 - w182 * w543 - w183 * w544 - w184 * w545 - w176 * w546 - w168 * w547 - w151 * w548
    w551 = w196 * w542 - w197 * w543 - w190 * w544 - w182 * w545 - w174 * w546 - w166 * w547 - w141 * w548
    w552 = w199 * w542 - w196 * w543 - w189 * w544 - w181 * w545 - w173 * w546 - w164 * w547 - w132 * w548
    w553 = w45 * w525 + w2 * w47
    w554 = w52 * w525 + w2 * w53
    w555 = w2 * w52 - w53 * w525
    w556 = w2 * w45 - w47 * w525
    w557 = w2 * w82 - w83 * w525
    w558 = w2 * w67 - w69 * w525
    w559 = w2 * w26 - w27 * w525
    w560 = w93 * w553 + w94 * w554 - w95 * w555 - w96 * w556 - w88 * w557 - w80 * w558 - w61 * w559
    w561 = w101 * w553 + w102 * w554 - w103 * w555 - w95 * w556 - w87 * w557 - w79 * w558 - w58 * w559
    w562 = w108 * w553 + w109 * w554 - w102 * w555 - w94 * w556 - w86 * w557 - w78 * w558 - w51 * w559
    w563 = w111 * w553 + w108 * w554 - w101 * w555 - w93 * w556 - w85 * w557 - w76 * w558 - w42 * w559
    w564 = w422 * w549 - w421 * w550 - w425 * w551 - w426 * w552 + w304 * w560 - w308 * w561 - w306 * w562 + w310 * w563
    w565 = w173 * w542 - w174 * w543 - w175 * w544 - w176 * w545 - w546 * c30
    w566 = w461 * w525 + w240 * w565
    w567 = w2 * w461 - w241 * w565
    w568 = w164 * w542 - w166 * w543 - w167 * w544 - w168 * w545 - w547 * c30
    w569 = w298 * w565 - w295 * w568
    w570 = w132 * w542 - w141 * w543 - w148 * w544 - w151 * w545 - w548 * c30
    w571 = w2 * w447 - w241 * w570
    w572 = w447 * w525 + w240 * w570
    w573 = w296 * w568 - w298 * w570
    w574 = w12 * w566 - w5 * w567 + w295 * w569 + w16 * w571 - w11 * w572 - w296 * w573
    w575 = w85 * w553 + w86 * w554 - w87 * w555 - w88 * w556 - w557 * c8
    w576 = w345 * w525 + w240 * w575
    w577 = w2 * w345 - w241 * w575
    w578 = w76 * w553 + w78 * w554 - w79 * w555 - w80 * w556 - w558 * c8
    w579 = w298 * w575 - w295 * w578
    w580 = w42 * w553 + w51 * w554 - w58 * w555 - w61 * w556 - w559 * c8
    w581 = w2 * w331 - w241 * w580
    w582 = w331 * w525 + w240 * w580
    w583 = w296 * w578 - w298 * w580
    w584 = w12 * w576 - w5 * w577 + w295 * w579 + w16 * w581 - w11 * w582 - w296 * w583
    w585 = w574 * c28 + w584 * c6
    w586 = w2 * w454 - w241 * w568
    w587 = w454 * w525 + w240 * w568
    w588 = w295 * w570 - w296 * w565
    w589 = w5 * w586 - w12 * w587 - w298 * w569 - w11 * w571 + w3 * w572 + w296 * w588
    w590 = w2 * w339 - w241 * w578
    w591 = w339 * w525 + w240 * w578
    w592 = w295 * w580 - w296 * w575
    w593 = w5 * w590 - w12 * w591 - w298 * w579 - w11 * w581 + w3 * w582 + w296 * w592
    w594 = (w11 * w567 - w3 * w566 - w16 * w586 + w11 * w587 + w298 * w573 - w295 * w588) * c28 + (w11 * w577 - w3 * w576 - w16 * w590 + w11 * w591 + w298 * w583 - w295 * w592) * c6
    w595 = w205 * w525 - w2 * w204
    w596 = w595 * c50
    w597 = w499 * w525 - w240 * w596
    w598 = w2 * w208
    w599 = w210 * w525
    w600 = w598 - w599
    w601 = w600 * c50
    w602 = w2 * w501 + w241 * w601
    w603 = w240 * w601 - w501 * w525
    w604 = w2 * w499 + w241 * w596
    w605 = w2 * w212
    w606 = w213 * w525
    w607 = w605 - w606
    w608 = w607 * c50
    w609 = height_travel * w608
    w610 = height_travel * w601
    w611 = w298 * w609 - w295 * w610 - w497 * w596
    w612 = height_travel * w596
    w613 = w497 * w601 - w296 * w609 - w295 * w612
    w614 = height_travel * (w3 * w597 - (w5 * w602 + w12 * w603 + w11 * w604)) - w298 * w611 + w296 * w613 + w589 * c29
    w615 = w525 * c60
    w616 = w2 * c60
    w617 = w614 + w593 * c7 + (w3 * w615 - w11 * w616) * c59
    w618 = w2 * w504 + w241 * w608
    w619 = w240 * w608 - w504 * w525
    w620 = w497 * w608 + w296 * w610 + w298 * w612
    w621 = height_travel * (w5 * w618 + w12 * w619 + w16 * w604 - w11 * w597) + w295 * w611 - w296 * w620 + w574 * c29
    w622 = w621 + w584 * c7 + (w16 * w616 - w11 * w615) * c59
    w623 = w498 * w609 - w24 * w611 + w495 * w612 + w65 * w620 + w452 * w565 - w115 * w569 - w415 * w570 + w154 * w573
    w624 = w623 + w337 * w575 - w25 * w579 - w299 * w580 + w66 * w583
    w625 = w2 * w5 - w12 * w525
    w626 = w2 * w4 - w3 * w525
    w627 = w230 * w625 - w226 * w626 + (w225 * w626 - w229 * w625) * c3
    w628 = w564 + w5 * w585 + w233 * (2 * -(w589 * c28 + w593 * c6)) + w4 * (w594 + w617) + w16 * w622 + 2 * (shaft_e1_dot * w624 + shaft_e2_dot * w627)
    w629 = w8 * (w1 * w8)
    w630 = w203 * w619 - (w525 * (shaft_e3 * w629) * c98 + w237 * w525) - w202 * w603 + w114 * w566 - w115 * w587
    w631 = w495 * w610 - w494 * w609 - w18 * w620 + w24 * w613 - w414 * w565 + w415 * w568 - w114 * w573 + w115 * w588
    w632 = w631 - w297 * w575 + w299 * w578 - w19 * w583 + w25 * w592
    w633 = w18 * w611 - w498 * w610 - w494 * w612 - w65 * w613 - w452 * w568 + w114 * w569 + w414 * w570 - w154 * w588
    w634 = w633 - w337 * w578 + w19 * w579 + w297 * w580 - w66 * w592
    w635 = w2 * w240 - w241 * w525
    w636 = w2 * w3 - w11 * w525
    w637 = (w234 * w625 - w225 * w636) * c0 - w235 * w625 + w226 * w636
    w638 = w630 + w19 * w576 - w25 * w591 + shaft_e0_dot * w632 + shaft_e2_dot * w634 + w6 * w635 + shaft_e1_dot * w637
    w639 = w235 * w626 - w230 * w636 + (w229 * w636 - w234 * w626) * c1
    w640 = w426 * w550 + w425 * w549 + w422 * w551 - w421 * w552 - w310 * w560 + w306 * w561 - w308 * w562 + w304 * w563
    w641 = w203 * w618 - w202 * w602 - w114 * w567 + w115 * w586 - w19 * w577 + w25 * w590 + shaft_e2_dot * w624
    w642 = w2 * w241
    w643 = w641 + shaft_e3_dot * w632 + shaft_e1_dot * w634 + w6 * w642 + (w5 * w642 + w12 * w635) * c5 + w2 * w237
    w644 = w640 + 2 * (shaft_e3 * w585) + 2 * (shaft_e2 * (w617 - w594)) + 2 * -(shaft_e1 * w622) + 2 * (w643 + shaft_e1_dot * w627 + shaft_e2_dot * w637 + shaft_e3_dot * w639)
    w645 = w546 + (w607 + (w525 * w533 - w2 * w515) - w489 * w542 + w483 * w543 + w477 * w544 + w470 * w545)
    w646 = w645 / w401
    w647 = w645 * c71
    w648 = w547 + (w600 + (w525 * w534 - w2 * w516) - w490 * w542 + w485 * w543 + w478 * w544 + w472 * w545)
    w649 = w648 / w401
    w650 = w548 + (w525 * w535 - w2 * w517 - w595 - w491 * w542 + w486 * w543 + w480 * w544 + w473 * w545)
    w651 = w650 / w401
    w652 = w394 * w646 * c72 + w397 * w649 * c72 + w400 * w651 * c72
    w653 = 2 * w394
    w654 = w403 / w402
    w655 = w648 * c71
    w656 = w650 * c71
    w657 = 2 * w402
    w658 = w458 / w401
    w659 = w450 / w401
    w660 = w412 / w401
    w661 = w654 * (w394 * w647 + w397 * w655 + w400 * w656) / w657 - (w645 * w658 + w648 * w659 + w650 * w660)
    w662 = w411 * w646 + w404 * w647 + w407 * w652 + w653 * w661
    w663 = w557 + (w607 + (w525 * w536 - w2 * w519) - w370 * w553 - w365 * w554 + w360 * w555 + w354 * w556)
    w664 = w663 / w272
    w665 = w663 * c65
    w666 = w558 + (w600 + (w525 * w537 - w2 * w520) - w371 * w553 - w367 * w554 + w361 * w555 + w356 * w556)
    w667 = w666 / w272
    w668 = w559 + (w525 * w538 - w2 * w521 - w595 - w372 * w553 - w368 * w554 + w363 * w555 + w357 * w556)
    w669 = w668 / w272
    w670 = w263 * w664 * c66 + w267 * w667 * c66 + w271 * w669 * c66
    w671 = 2 * w263
    w672 = w274 / w273
    w673 = w666 * c65
    w674 = w668 * c65
    w675 = 2 * w273
    w676 = w342 / w272
    w677 = w335 / w272
    w678 = w293 / w272
    w679 = w672 * (w263 * w665 + w267 * w673 + w271 * w674) / w675 - (w663 * w676 + w666 * w677 + w668 * w678)
    w680 = w292 * w664 + w275 * w665 + w285 * w670 + w671 * w679
    w681 = w662 + w680
    w682 = w606 - w605
    w683 = 2 * w397
    w684 = w411 * w649 + w404 * w655 + w409 * w652 + w661 * w683
    w685 = 2 * w267
    w686 = w292 * w667 + w275 * w673 + w290 * w670 + w679 * w685
    w687 = w684 + w686
    w688 = w599 - w598
    w689 = 2 * w400
    w690 = w411 * w651 + w410 * w652 + w404 * w656 + w661 * w689
    w691 = 2 * w271
    w692 = w292 * w669 + w291 * w670 + w275 * w674 + w679 * w691
    w693 = w690 + w692
    w694 = w2 * (w628 + (w638 + shaft_e0_dot * w639) * -2.0) - w525 * w644 + w681 * w682 + w687 * w688 + w595 * w693
    w695 = w2 * w336
    w696 = w2 * w343
    w697 = w2 * w451
    w698 = w2 * w459
    w699 = w218 * w642 + (w217 * w642 + w221 * w635) * c56 - w261 * w695 + w265 * w696 - w392 * w697 + w395 * w698
    w700 = w2 * w217 - w221 * w525
    w701 = w2 * w216 - w215 * w525
    w702 = w508 * w700 - w506 * w701 + (w505 * w701 - w507 * w700) * c54
    w703 = w2 * w215 - w220 * w525
    w704 = (w510 * w700 - w505 * w703) * c51 - w511 * w700 + w506 * w703
    w705 = w511 * w701 - w508 * w703 + (w507 * w703 - w510 * w701) * c52
    w706 = w400 * w652
    w707 = w397 * w652
    w708 = w271 * w670
    w709 = w267 * w670
    w710 = w395 * w706 - w398 * w707 + w265 * w708 - w269 * w709
    w711 = w699 + w2 * w513 + slider_e1_dot * w702 + slider_e2_dot * w704 + slider_e3_dot * w705 + slider_e1_dot * w710
    w712 = w394 * w652
    w713 = w263 * w670
    w714 = w392 * w707 - w395 * w712 + w261 * w709 - w265 * w713
    w715 = w398 * w712 - w392 * w706 - w261 * w708 + w269 * w713
    w716 = w459 * w525
    w717 = w451 * w525
    w718 = (w690 + (w215 * w716 - w220 * w717 + w287 * w697 - w220 * w698 - w288 * w707 + w279 * w712)) * c69
    w719 = w343 * w525
    w720 = w336 * w525
    w721 = (w692 + (w215 * w719 - w220 * w720 + w287 * w695 - w220 * w696 - w288 * w709 + w279 * w713)) * c63
    w722 = w718 + w721
    w723 = w413 * w525
    w724 = w2 * w413
    w725 = (w684 + (w220 * w723 - w221 * w716 - w287 * w724 + w217 * w698 + w288 * w706 - w282 * w712)) * c69
    w726 = w294 * w525
    w727 = w2 * w294
    w728 = (w686 + (w220 * w726 - w221 * w719 - w287 * w727 + w217 * w696 + w288 * w708 - w282 * w713)) * c63
    w729 = w725 + w728
    w730 = 2 * (w711 + slider_e3_dot * w714 + slider_e2_dot * w715) + 2 * -(slider_e2 * w722) + 2 * (slider_e3 * w729)
    w731 = w261 * w720 - w525 * (slider_e3 * w629) * c99 - w265 * w719 + w392 * w717 - w395 * w716 - w513 * w525
    w732 = w731 + w218 * w635 + slider_e1_dot * w704 + slider_e0_dot * w705 + slider_e2_dot * w710 + slider_e0_dot * w714
    w733 = (w662 + (w221 * w717 - w215 * w723 + w220 * w724 - w217 * w697 - w279 * w706 + w282 * w707)) * c69
    w734 = (w680 + (w221 * w720 - w215 * w726 + w220 * w727 - w217 * w695 - w279 * w708 + w282 * w709)) * c63
    w735 = w732 * -2.0 + 2 * (slider_e2_dot * w702 + slider_e1_dot * w715) + w216 * w722 + w217 * w729 + w277 * (2 * -(w733 + w734))
    w736 = w388 * w546
    w737 = w460 * w545 + w446 * w546
    w738 = w460 * w544 + w443 * w546
    w739 = w460 * w543 + w440 * w546
    w740 = w460 * w542 - w437 * w546
    w741 = w545 * c60 - w416 * w545 - w446 * w548
    w742 = w544 * c60 - w416 * w544 - w443 * w548
    w743 = w543 * c60 - w416 * w543 - w440 * w548
    w744 = w416 * w542 - w542 * c60 - w437 * w548
    w745 = w120 * w737 + w122 * w738 + w126 * w739 - w145 * w740 + w150 * w741 + w145 * w742 + w120 * w743 + w119 * w744
    w746 = w459 * w542
    w747 = w413 * w542
    w748 = w413 * w543
    w749 = w459 * w543
    w750 = w413 * w544
    w751 = w459 * w544
    w752 = w413 * w545
    w753 = w459 * w545
    w754 = w145 * w746 - w119 * w747 + w120 * w748 - w126 * w749 + w145 * w750 - w122 * w751 + w150 * w752 - w120 * w753
    w755 = w382 * w547 + w745 * c36 + (w754 - w408 * w706 + w406 * w712 - w684) * c70
    w756 = w736 + w755
    w757 = w391 * w547
    w758 = w388 * w548
    w759 = w757 - w758
    w760 = w440 * w542 - w437 * w543
    w761 = w440 * w543
    w762 = w451 * w543
    w763 = w443 * w544
    w764 = (w119 * w760 - w120 * w761) * c39 - w193 * w761 + w396 * w748 - w399 * w762 + w464 * w543 - w187 * w763
    w765 = w443 * w543 + w440 * w544
    w766 = w443 * w542 - w437 * w544
    w767 = w764 - w186 * w765 + (w126 * w766 - (w120 * w763 + w145 * w765)) * c41 - w393 * w750 + w399 * w751
    w768 = w446 * w545
    w769 = w446 * w544 + w443 * w545
    w770 = w446 * w543 + w440 * w545
    w771 = w446 * w542 - w437 * w545
    w772 = w767 + w466 * w544 - w180 * w768 - w179 * w769 - w178 * w770 + (w145 * w771 - (w120 * w768 + w119 * w769 + w150 * w770)) * c42
    w773 = w451 * w545
    w774 = w453 * w545 + w446 * w547
    w775 = w453 * w543 + w440 * w547
    w776 = w772 + w393 * w773 - w396 * w753 + w467 * w545 + w125 * w737 - w162 * w738 - w130 * w774 + w162 * w775
    w777 = w399 * w707 - w396 * w706
    w778 = w396 * w712 - w393 * w707
    w779 = w393 * w706 - w399 * w712
    w780 = w776 - w130 * w742 + w125 * w743 + right_rod_e1_dot * w777 + right_rod_e3_dot * w778 + right_rod_e2_dot * w779
    w781 = w150 * w543 - w145 * w542 + w119 * w544 + w120 * w545
    w782 = w145 * w543 - w126 * w542 + w120 * w544 + w122 * w545
    w783 = w457 * w546 + w449 * w547 + w390 * w548
    w784 = w456 * w546 + w448 * w547 + w385 * w548
    w785 = w463 * w781 - w462 * w782 + (w376 * w782 - w380 * w781) * c40 - w377 * w783 - w381 * w784
    w786 = w120 * w543 - w119 * w542 + w140 * w544 + w126 * w545
    w787 = w129 * w546 + w124 * w547 + w161 * w548
    w788 = (w387 * w781 - w376 * w786) * c37 - w465 * w781 + w462 * w786 + w381 * w787 + (w380 * w787 - w387 * w784) * c36
    w789 = w465 * w782 - w463 * w786 + (w380 * w786 - w387 * w782) * c38 + w377 * w787 + (w376 * w787 - w387 * w783) * c36
    w790 = 2 * (right_rod_e3 * w756) + 2 * (right_rod_e1 * w759) + 2 * (w780 + right_rod_e1_dot * w785 + right_rod_e2_dot * w788 + right_rod_e3_dot * w789)
    w791 = w391 * w546
    w792 = w453 * w544 + w443 * w547
    w793 = w126 * w740 - (w119 * w737 + w120 * w738 + w140 * w739) + w150 * w774 + w145 * w792 + w120 * w775
    w794 = w453 * w542 - w437 * w547
    w795 = w451 * w542
    w796 = w451 * w544
    w797 = w119 * w795 - w126 * w746 - w120 * w762 + w140 * w749 - w145 * w796 + w120 * w751 - w150 * w773 + w119 * w753
    w798 = (w793 - w119 * w794) * c36 + (w797 + w408 * w707 - w405 * w712 - w690) * c70 + w382 * w548
    w799 = w791 + w798
    w800 = w790 + 2 * -(right_rod_e2 * w799)
    w801 = w755 - w736
    w802 = w388 * w547
    w803 = w391 * w548
    w804 = w393 * w796 - w396 * w751 - w179 * w768 + (w126 * w771 - (w122 * w768 + w120 * w769 + w145 * w770)) * c41
    w805 = w804 + w466 * w545 + w125 * w738 - w130 * w792 + right_rod_e2_dot * w778 + right_rod_e3_dot * w788
    w806 = right_rod_e1 * w437
    w807 = w542 * w806 * c100 - w396 * w747 + w399 * w795 - w464 * w542 + w193 * w760 - w188 * w763 + (w145 * w766 - (w119 * w763 + w150 * w765)) * c42
    w808 = w807 + w186 * w766 + w467 * w544 - w180 * w769 + w178 * w771 - w393 * w752 + w399 * w753 - w162 * w737
    w809 = w808 - w162 * w794 - w130 * w741 + w125 * w744 + right_rod_e0_dot * w777 + right_rod_e3_dot * w779
    w810 = 2 * (right_rod_e2 * w801) + w122 * (2 * (w802 + w803)) + w120 * w759 + 2 * w805 + (w809 + right_rod_e0_dot * w785 + right_rod_e2_dot * w789) * -2.0
    w811 = w798 - w791
    w812 = w810 + 2 * (right_rod_e3 * w811)
    w813 = w694 - w525 * w730 + w2 * w735 - w546 * w662 - w547 * w684 - w548 * w690 - w542 * w800 + w543 * w812
    w814 = w145 * w794 - (w120 * w774 + w122 * w792 + w126 * w775) - w119 * w741 - w120 * w742 - w140 * w743
    w815 = w126 * w747 - w145 * w795 - w140 * w748 + w126 * w762 - w120 * w750 + w122 * w796 - w119 * w752 + w120 * w773
    w816 = w382 * w546 + (w814 - w126 * w744) * c36 + (w815 + w405 * w706 - w406 * w707 - w662) * c70
    w817 = w757 + w758
    w818 = right_rod_e2 * w437
    w819 = w542 * w818 * c101 + w393 * w747 - w399 * w746 - w466 * w542 + w194 * w760 + w393 * w762 - w396 * w749
    w820 = w819 + w187 * w766 - w178 * w768 + w179 * w771 + (w119 * w771 - (w126 * w768 + w140 * w769 + w120 * w770)) * c39
    w821 = w820 + w464 * w545 + w125 * w739 + w162 * w740 - w130 * w775 - w130 * w744 + right_rod_e1_dot * w778
    w822 = w122 * w801 + w150 * (2 * (w803 - w816)) + 2 * -(right_rod_e3 * w817) + (w821 + right_rod_e0_dot * w779 + right_rod_e3_dot * w785 + right_rod_e0_dot * w788) * -2.0
    w823 = (w145 * w760 - w150 * w761) * c42 - w195 * w761 + w467 * w543 - w188 * w765 - w180 * w770 + w396 * w752
    w824 = w823 - w399 * w773 + w162 * w774 + w125 * w741 + right_rod_e3_dot * w777 + right_rod_e1_dot * w789
    w825 = w822 + 2 * w824 - w120 * w799
    w826 = w399 * w749 - w393 * w748 - w186 * w763 + (w119 * w766 - (w140 * w763 + w120 * w765)) * c39 + w464 * w544
    w827 = w826 - w178 * w769 - w162 * w739 - w130 * w743 + right_rod_e1_dot * w779 + right_rod_e2_dot * w785
    w828 = right_rod_e3 * w437
    w829 = w542 * w828 * c102 - w393 * w795 + w396 * w746 - w467 * w542 - w194 * w761 + w195 * w760 + (w126 * w760 - w145 * w761) * c41
    w830 = w829 + w466 * w543 - w187 * w765 + w188 * w766 + w396 * w750 - w399 * w796 - w179 * w770 + w180 * w771
    w831 = w830 - w125 * w740 + w162 * w792 + w130 * w794 + w125 * w742 + right_rod_e2_dot * w777 + right_rod_e0_dot * w778
    w832 = w120 * w756 + w140 * (2 * (w802 - w816)) + 2 * w827 - w150 * w817 + (w831 + right_rod_e1_dot * w788 + right_rod_e0_dot * w789) * -2.0
    w833 = w832 + w122 * w811
    w834 = w256 * w557
    w835 = w344 * w556 + w330 * w557
    w836 = w344 * w555 + w327 * w557
    w837 = w344 * w554 - w324 * w557
    w838 = w344 * w553 - w321 * w557
    w839 = w556 * c60 - w300 * w556 - w330 * w559
    w840 = w555 * c60 - w300 * w555 - w327 * w559
    w841 = w300 * w554 - w554 * c60 - w324 * w559
    w842 = w300 * w553 - w553 * c60 - w321 * w559
    w843 = w30 * w835 + w32 * w836 - w36 * w837 - w55 * w838 + w60 * w839 + w55 * w840 + w30 * w841 + w29 * w842
    w844 = w343 * w553
    w845 = w294 * w553
    w846 = w294 * w554
    w847 = w343 * w554
    w848 = w294 * w555
    w849 = w343 * w555
    w850 = w294 * w556
    w851 = w343 * w556
    w852 = w55 * w844 - w29 * w845 - w30 * w846 + w36 * w847 + w55 * w848 - w32 * w849 + w60 * w850 - w30 * w851
    w853 = w250 * w558 + w843 * c13 + (w852 - w289 * w708 + w284 * w713 - w686) * c64
    w854 = w834 + w853
    w855 = w259 * w558
    w856 = w256 * w559
    w857 = w855 - w856
    w858 = w324 * w554
    w859 = w324 * w553 + w321 * w554
    w860 = w336 * w554
    w861 = w327 * w555
    w862 = w105 * w858 + (w30 * w858 + w29 * w859) * c16 - w266 * w846 + w270 * w860 - w348 * w554 - w99 * w861
    w863 = w327 * w554 - w324 * w555
    w864 = w327 * w553 - w321 * w555
    w865 = w862 + w98 * w863 + (w55 * w863 - w30 * w861 + w36 * w864) * c18 - w262 * w848 + w270 * w849 + w350 * w555
    w866 = w330 * w556
    w867 = w330 * w555 + w327 * w556
    w868 = w330 * w554 - w324 * w556
    w869 = w330 * w553 - w321 * w556
    w870 = w865 - w92 * w866 - w91 * w867 + w90 * w868 + (w60 * w868 - (w30 * w866 + w29 * w867) + w55 * w869) * c19
    w871 = w336 * w556
    w872 = w338 * w556 + w330 * w558
    w873 = w338 * w554 - w324 * w558
    w874 = w870 + w262 * w871 - w266 * w851 + w351 * w556 + w35 * w835 - w74 * w836 - w40 * w872 - w74 * w873
    w875 = w270 * w709 - w266 * w708
    w876 = w266 * w713 - w262 * w709
    w877 = w262 * w708 - w270 * w713
    w878 = w874 - w40 * w840 + w35 * w841 + left_rod_e1_dot * w875 + left_rod_e3_dot * w876 + left_rod_e2_dot * w877
    w879 = w29 * w555 - (w55 * w553 + w60 * w554) + w30 * w556
    w880 = w30 * w555 - (w36 * w553 + w55 * w554) + w32 * w556
    w881 = w341 * w557 + w334 * w558 + w258 * w559
    w882 = w340 * w557 + w333 * w558 + w253 * w559
    w883 = w347 * w879 - w346 * w880 + (w244 * w880 - w248 * w879) * c17 - w245 * w881 - w249 * w882
    w884 = w50 * w555 - (w29 * w553 + w30 * w554) + w36 * w556
    w885 = w39 * w557 + w34 * w558 + w73 * w559
    w886 = (w255 * w879 - w244 * w884) * c14 - w349 * w879 + w346 * w884 + w249 * w885 + (w248 * w885 - w255 * w882) * c13
    w887 = w349 * w880 - w347 * w884 + (w248 * w884 - w255 * w880) * c15 + w245 * w885 + (w244 * w885 - w255 * w881) * c13
    w888 = 2 * (left_rod_e3 * w854) + 2 * (left_rod_e1 * w857) + 2 * (w878 + left_rod_e1_dot * w883 + left_rod_e2_dot * w886 + left_rod_e3_dot * w887)
    w889 = w259 * w557
    w890 = w338 * w555 + w327 * w558
    w891 = w338 * w553 - w321 * w558
    w892 = w50 * w837 - (w29 * w835 + w30 * w836) + w36 * w838 + w60 * w872 + w55 * w890 - w30 * w873 - w29 * w891
    w893 = w336 * w553
    w894 = w336 * w555
    w895 = w29 * w893 - w36 * w844 + w30 * w860 - w50 * w847 - w55 * w894 + w30 * w849 - w60 * w871 + w29 * w851
    w896 = w892 * c13 + (w895 + w289 * w709 - w283 * w713 - w692) * c64 + w250 * w559
    w897 = w889 + w896
    w898 = w888 + 2 * -(left_rod_e2 * w897)
    w899 = w853 - w834
    w900 = w256 * w558
    w901 = w259 * w559
    w902 = w262 * w894 - w266 * w849 - w91 * w866 + (w55 * w868 - (w32 * w866 + w30 * w867) + w36 * w869) * c18
    w903 = 2 * (w902 + w350 * w556 + w35 * w836 - w40 * w890 + left_rod_e2_dot * w876 + left_rod_e3_dot * w886)
    w904 = left_rod_e1 * w321
    w905 = w553 * w904 * c103 - w266 * w845 + w270 * w893 - w348 * w553 + w105 * w859 - w100 * w861 + (w60 * w863 - w29 * w861 + w55 * w864) * c19
    w906 = w905 + w98 * w864 + w351 * w555 - w92 * w867 + w90 * w869 - w262 * w850 + w270 * w851 - w74 * w835
    w907 = w906 - w74 * w891 - w40 * w839 + w35 * w842 + left_rod_e0_dot * w875 + left_rod_e3_dot * w877 + left_rod_e0_dot * w883
    w908 = 2 * (left_rod_e2 * w899) + w32 * (2 * (w900 + w901)) + w30 * w857 + w903 + (w907 + left_rod_e2_dot * w887) * -2.0
    w909 = w896 - w889
    w910 = w908 + 2 * (left_rod_e3 * w909)
    w911 = w813 + w544 * w825 + w545 * w833 - w557 * w680 - w558 * w686 - w559 * w692 - w553 * w898 - w554 * w910
    w912 = w36 * w873 - (w30 * w872 + w32 * w890) + w55 * w891 - w29 * w839 - w30 * w840 - w50 * w841 - w36 * w842
    w913 = w36 * w845 - w55 * w893 + w50 * w846 - w36 * w860 - w30 * w848 + w32 * w894 - w29 * w850 + w30 * w871
    w914 = w250 * w557 + w912 * c13 + (w913 + w283 * w708 - w284 * w709 - w680) * c64
    w915 = w855 + w856
    w916 = left_rod_e2 * w321
    w917 = w553 * w916 * c104 + w262 * w845 - w270 * w844 - w350 * w553 + w106 * w859 - w262 * w860 + w266 * w847
    w918 = w917 + w99 * w864 - w90 * w866 + w91 * w869 + (w30 * w868 - (w36 * w866 + w50 * w867) + w29 * w869) * c16
    w919 = w918 + w348 * w556 - w35 * w837 + w74 * w838 + w40 * w873 - w40 * w842 + left_rod_e1_dot * w876 + left_rod_e0_dot * w877
    w920 = w32 * w899 + w60 * (2 * (w901 - w914)) + 2 * -(left_rod_e3 * w915) + (w919 + left_rod_e3_dot * w883 + left_rod_e0_dot * w886) * -2.0
    w921 = w107 * w858 + (w60 * w858 + w55 * w859) * c19 - w351 * w554 + w100 * w863 + w92 * w868 + w266 * w850
    w922 = 2 * (w921 - w270 * w871 + w74 * w872 + w35 * w839 + left_rod_e3_dot * w875 + left_rod_e1_dot * w887)
    w923 = w920 + w922 - w30 * w897
    w924 = w262 * w846 - w270 * w847 - w98 * w861 + (w30 * w863 - w50 * w861 + w29 * w864) * c16 + w348 * w555
    w925 = 2 * (w924 - w90 * w867 + w74 * w837 - w40 * w841 + left_rod_e1_dot * w877 + left_rod_e2_dot * w883)
    w926 = left_rod_e3 * w321
    w927 = w553 * w926 * c105 - w262 * w893 + w266 * w844 - w351 * w553 + w106 * w858 + w107 * w859 + (w55 * w858 + w36 * w859) * c18
    w928 = w927 - w350 * w554 + w99 * w863 + w100 * w864 + w266 * w848 - w270 * w894 + w91 * w868 + w92 * w869
    w929 = w928 - w35 * w838 + w74 * w890 + w40 * w891 + w35 * w840 + left_rod_e2_dot * w875 + left_rod_e0_dot * w876
    w930 = w30 * w854 + w50 * (2 * (w900 - w914)) + w925 - w60 * w915 + (w929 + left_rod_e1_dot * w886 + left_rod_e0_dot * w887) * -2.0
    w931 = w930 + w32 * w909
    w932 = w712 + w713
    w933 = spin_angle_dot * w540
    w934 = spin_angle_dot * w523
    w935 = spin_angle_dot * w525
    w936 = w16 * height_travel
    w937 = w12 * w936
    w938 = w2 * spin_angle_dot
    w939 = w5 * w936
    w940 = w4 * height_travel_dot
    w941 = w16 * height_travel_dot
    w942 = w4 * height_travel
    w943 = w12 * w942
    w944 = w5 * w942
    w945 = w2 * (w935 * (w937 + w203 * -2.0) - w938 * w939 + w940) - w525 * (w941 - (w935 * w943 + w938 * (2 * w203 - w944)))
    w946 = w213 * w933 + w212 * w934 + w945
    w947 = 2 * w550
    w948 = 2 * w549
    w949 = 2 * w551
    w950 = 2 * w552
    w951 = 2 * w560
    w952 = 2 * w561
    w953 = 2 * w562
    w954 = 2 * w563
    w955 = w434 * w947 - w433 * w948 + w430 * w949 - w429 * w950 - w318 * w951 + w317 * w952 + w314 * w953 + w313 * w954
    w956 = w430 * w948 - w429 * w947 + w433 * w949 - w434 * w950 + w313 * w951 + w314 * w952 - w317 * w953 + w318 * w954
    w957 = w933 * (w955 + w3 * w624 + w12 * w632 + w11 * w634 + w11 * w627 + w3 * w637 + w12 * w639) + w934 * (w956 + w11 * w624 + w5 * w632 + w16 * w634 + w3 * w627 + w4 * w637 + w5 * w639)
    w958 = w707 + w709
    w959 = w2 * (w941 + (w938 * w944 - w935 * (w943 + w202 * -2.0))) - w525 * (w938 * (w939 + 2 * w202) - w935 * w937 - w940)
    w960 = w210 * w933 + w208 * w934 + w959
    w961 = w706 + w708
    w962 = w11 * w936
    w963 = w11 * w942
    w964 = w2 * (w935 * (w3 * w942 - w962) - w938 * (w963 - w16 * w936)) - w525 * (w935 * (w963 + w3 * w936) - w938 * (w962 + w16 * w942))
    w965 = w205 * w933 + w204 * w934 + w964
    w966 = w932 * w946 - w957 + w958 * w960 + w961 * w965 - w933 * (w220 * w702 + w215 * w704 + w221 * w705 + w220 * w710 + w221 * w714 + w215 * w715)
    w967 = w966 - w934 * (w215 * w702 + w216 * w704 + w217 * w705 + w287 * w710 + w217 * w714 + w220 * w715)
    w968 = w4 * c28
    w969 = w11 * w968
    w970 = w16 * c29
    w971 = w5 * c28 + w970
    w972 = w16 * c28
    w973 = w4 * c29
    w974 = w233 * c28 - w973
    w975 = w11 * w972
    w976 = w2 * (w938 * (w969 - w5 * w971) - w935 * (w3 * w968 - (w114 * -2.0 + w12 * w971))) - w525 * (w935 * (w3 * w972 + w12 * w974) - w938 * (w975 + (2 * w114 + w5 * w974)))
    w977 = w976 - (w170 * w934 + w171 * w933)
    w978 = shaft_e3 * 4.0
    w979 = w973 - w978 * c28
    w980 = w2 * (w938 * (w5 * w979 - w16 * w968) - w935 * (w115 * -2.0 + w12 * w979 - w969)) - w525 * (w938 * (2 * w115 + w5 * w970 + w16 * w972) - w935 * (w975 + w12 * w970))
    w981 = w980 - (w155 * w934 + w157 * w933)
    w982 = w2 * (w938 * (w16 * w971 - w11 * w979) - w935 * (w11 * w971 - w3 * w979)) - w525 * (w938 * (w16 * w974 - w11 * w970) - w935 * (w11 * w974 - w3 * w970))
    w983 = w982 - (w116 * w934 + w117 * w933)
    w984 = w119 * w777 + w145 * w778 + w126 * w779 + w119 * w785 + w126 * w788 + w145 * w789
    w985 = w427 * c35
    w986 = right_swing_angle_dot * w985
    w987 = w431 * c31 * c32 - w431 * c33 * c34
    w988 = right_swing_angle_dot * w987
    w989 = w525 * w986 - w2 * w988 - (w137 * w933 - w135 * w934)
    w990 = w120 * w777 + w126 * w778 + w140 * w779 + w120 * w785 + w145 * w788 + w150 * w789
    w991 = w431 * c44
    w992 = right_swing_angle_dot * w991
    w993 = w427 * c31 * c34 - w427 * c33 * c32
    w994 = right_swing_angle_dot * w993
    w995 = w2 * w992 - w525 * w994 - (w143 * w934 + w142 * w933)
    w996 = w145 * w777 + w122 * w778 + w120 * w779 + w140 * w785 + w120 * w788 + w119 * w789
    w997 = w143 * w933 - w142 * w934 + (w525 * w992 + w2 * w994)
    w998 = w150 * w777 + w120 * w778 + w119 * w779 + w126 * w785 + w122 * w788 + w120 * w789
    w999 = w137 * w934 + w135 * w933 + (w525 * w988 + w2 * w986)
    w1000 = w967 - w712 * w977 - w707 * w981 - w706 * w983 + w984 * w989 + w990 * w995 + w996 * w997 - w998 * w999
    w1001 = w4 * c6
    w1002 = w11 * w1001
    w1003 = w16 * c7
    w1004 = w5 * c6 + w1003
    w1005 = w16 * c6
    w1006 = w4 * c7
    w1007 = w233 * c6 - w1006
    w1008 = w11 * w1005
    w1009 = w2 * (w938 * (w1002 - w5 * w1004) - w935 * (w3 * w1001 - (w19 * -2.0 + w12 * w1004))) - w525 * (w935 * (w3 * w1005 + w12 * w1007) - w938 * (w1008 + (2 * w19 + w5 * w1007)))
    w1010 = w1009 - (w82 * w934 + w83 * w933)
    w1011 = w1006 - w978 * c6
    w1012 = w2 * (w938 * (w5 * w1011 - w16 * w1001) - w935 * (w25 * -2.0 + w12 * w1011 - w1002)) - w525 * (w938 * (2 * w25 + w5 * w1003 + w16 * w1005) - w935 * (w1008 + w12 * w1003))
    w1013 = w1012 - (w67 * w934 + w69 * w933)
    w1014 = w2 * (w938 * (w16 * w1004 - w11 * w1011) - w935 * (w11 * w1004 - w3 * w1011)) - w525 * (w938 * (w16 * w1007 - w11 * w1003) - w935 * (w11 * w1007 - w3 * w1003))
    w1015 = w1014 - (w26 * w934 + w27 * w933)
    w1016 = w29 * w875 + w55 * w876 + w36 * w877 + w29 * w883 + w36 * w886 + w55 * w887
    w1017 = w315 * c24
    w1018 = left_swing_angle_dot * w1017
    w1019 = w311 * c9 * c10 - w311 * c11 * c12
    w1020 = left_swing_angle_dot * w1019
    w1021 = w2 * w1018 - w525 * w1020 - (w45 * w933 - w47 * w934)
    w1022 = w30 * w875 + w36 * w876 + w50 * w877 + w30 * w883 + w55 * w886 + w60 * w887
    w1023 = w311 * c20
    w1024 = left_swing_angle_dot * w1023
    w1025 = w315 * c11 * c10 - w315 * c9 * c12
    w1026 = left_swing_angle_dot * w1025
    w1027 = w52 * w933 - w53 * w934 + (w525 * w1024 + w2 * w1026)
    w1028 = w55 * w875 + w32 * w876 + w30 * w877 + w50 * w883 + w30 * w886 + w29 * w887
    w1029 = w2 * w1024 - w525 * w1026 - (w52 * w934 + w53 * w933)
    w1030 = w1000 - w713 * w1010 - w709 * w1013 - w708 * w1015 + w1016 * w1021 - w1022 * w1027 + w1028 * w1029
    w1031 = w60 * w875 + w30 * w876 + w29 * w877 + w36 * w883 + w32 * w886 + w30 * w887
    w1032 = w525 * w1018 + w2 * w1020 - (w45 * w934 + w47 * w933)
    w1033 = w18 * c50
    w1034 = w241 * w1033
    w1035 = w240 * w1033
    w1036 = w65 * c50
    w1037 = w241 * w1036
    w1038 = w240 * w1036
    w1039 = height_travel * w1033
    w1040 = w24 * c50
    w1041 = height_travel * w1040
    w1042 = w295 * w1039 - w298 * w1041 - w497 * w1036
    w1043 = height_travel * w1036
    w1044 = w296 * w1041 - w497 * w1033 - w295 * w1043
    w1045 = height_travel * (w5 * w1034 + w12 * w1035 - w11 * w1037 - w3 * w1038) - w504 - w298 * w1042 + w296 * w1044
    w1046 = w241 * w1040
    w1047 = w240 * w1040
    w1048 = w298 * w1043 - (w497 * w1040 + w296 * w1039)
    w1049 = height_travel * (w16 * w1037 - (w5 * w1046 + w12 * w1047) + w11 * w1038) - w501 + w295 * w1042 - w296 * w1048
    w1050 = w495 * w1043 - (w498 * w1041 + w24 * w1042) + w65 * w1048
    w1051 = w494 * w1041 - w495 * w1039 - w18 * w1048 + w24 * w1044
    w1052 = w498 * w1039 + w18 * w1042 - w494 * w1043 - w65 * w1044
    w1053 = w4 * w1045 + w16 * w1049 + 2 * (shaft_e1_dot * w1050) + (w202 * w1035 - w203 * w1047 + shaft_e0_dot * w1051 + shaft_e2_dot * w1052) * -2.0
    w1054 = 2 * (w202 * w1034 - w203 * w1046 + shaft_e2_dot * w1050 + shaft_e3_dot * w1051 + shaft_e1_dot * w1052)
    w1055 = w24 * c71
    w1056 = w18 * c71
    w1057 = w65 * c71
    w1058 = w24 * w658 + w18 * w659 + w65 * w660 - w654 * (w394 * w1055 + w397 * w1056 + w400 * w1057) / w657
    w1059 = w24 / w401
    w1060 = w18 / w401
    w1061 = w65 / w401
    w1062 = w394 * w1059 * c72 + w397 * w1060 * c72 + w400 * w1061 * c72
    w1063 = w653 * w1058 - (w411 * w1059 + w404 * w1055 + w407 * w1062)
    w1064 = w24 * c65
    w1065 = w18 * c65
    w1066 = w65 * c65
    w1067 = w24 * w676 + w18 * w677 + w65 * w678 - w672 * (w263 * w1064 + w267 * w1065 + w271 * w1066) / w675
    w1068 = w24 / w272
    w1069 = w18 / w272
    w1070 = w65 / w272
    w1071 = w263 * w1068 * c66 + w267 * w1069 * c66 + w271 * w1070 * c66
    w1072 = w671 * w1067 - (w292 * w1068 + w275 * w1064 + w285 * w1071)
    w1073 = w1063 + w1072
    w1074 = w683 * w1058 - (w411 * w1060 + w404 * w1056 + w409 * w1062)
    w1075 = w685 * w1067 - (w292 * w1069 + w275 * w1065 + w290 * w1071)
    w1076 = w1074 + w1075
    w1077 = w2 * w1053 - w525 * (2 * (shaft_e2 * w1045) + 2 * -(shaft_e1 * w1049) + w1054) + w682 * w1073 + w688 * w1076
    w1078 = w689 * w1058 - (w411 * w1061 + w410 * w1062 + w404 * w1057)
    w1079 = w691 * w1067 - (w292 * w1070 + w291 * w1071 + w275 * w1066)
    w1080 = w1078 + w1079
    w1081 = w397 * w1062
    w1082 = w400 * w1062
    w1083 = w271 * w1071
    w1084 = w267 * w1071
    w1085 = w398 * w1081 - w395 * w1082 - w265 * w1083 + w269 * w1084
    w1086 = w394 * w1062
    w1087 = w263 * w1071
    w1088 = w395 * w1086 - w392 * w1081 - w261 * w1084 + w265 * w1087
    w1089 = w392 * w1082 - w398 * w1086 + w261 * w1083 - w269 * w1087
    w1090 = (w1078 + (w288 * w1081 - w279 * w1086)) * c69 + (w1079 + (w288 * w1084 - w279 * w1087)) * c63
    w1091 = 2 * (slider_e1_dot * w1085 + slider_e3_dot * w1088 + slider_e2_dot * w1089) + 2 * -(slider_e2 * w1090)
    w1092 = (w1074 + (w282 * w1086 - w288 * w1082)) * c69 + (w1075 + (w282 * w1087 - w288 * w1083)) * c63
    w1093 = (slider_e2_dot * w1085 + slider_e0_dot * w1088) * -2.0 + 2 * (slider_e1_dot * w1089) + w216 * w1090
    w1094 = 2 * -((w1063 + (w279 * w1082 - w282 * w1081)) * c69 + (w1072 + (w279 * w1083 - w282 * w1084)) * c63)
    w1095 = w1077 + w595 * w1080 - w525 * (w1091 + 2 * (slider_e3 * w1092)) + w2 * (w1093 + w217 * w1092 + w277 * w1094)
    w1096 = (w408 * w1082 - w406 * w1086 - w1074) * c70
    w1097 = w396 * w1082 - w399 * w1081
    w1098 = w393 * w1081 - w396 * w1086
    w1099 = w399 * w1086 - w393 * w1082
    w1100 = 2 * (right_rod_e3 * w1096) + 2 * (right_rod_e1_dot * w1097 + right_rod_e3_dot * w1098 + right_rod_e2_dot * w1099)
    w1101 = (w405 * w1086 - w408 * w1081 - w1078) * c70
    w1102 = w1100 + 2 * -(right_rod_e2 * w1101)
    w1103 = 2 * (right_rod_e2 * w1096) + 2 * (right_rod_e2_dot * w1098) + (right_rod_e0_dot * w1097 + right_rod_e3_dot * w1099) * -2.0
    w1104 = w1103 + 2 * (right_rod_e3 * w1101)
    w1105 = (w406 * w1081 - w405 * w1082 - w1063) * c106
    w1106 = w122 * w1096 + w150 * w1105 + (right_rod_e1_dot * w1098 + right_rod_e0_dot * w1099) * -2.0 + 2 * (right_rod_e3_dot * w1097)
    w1107 = w1106 - w120 * w1101
    w1108 = w120 * w1096 + w140 * w1105 + 2 * (right_rod_e1_dot * w1099) + (right_rod_e2_dot * w1097 + right_rod_e0_dot * w1098) * -2.0
    w1109 = w1108 + w122 * w1101
    w1110 = w1095 - w546 * w1063 - w547 * w1074 - w548 * w1078 - w542 * w1102 + w543 * w1104 + w544 * w1107 + w545 * w1109
    w1111 = (w289 * w1083 - w284 * w1087 - w1075) * c64
    w1112 = w266 * w1083 - w270 * w1084
    w1113 = w262 * w1084 - w266 * w1087
    w1114 = w270 * w1087 - w262 * w1083
    w1115 = 2 * (left_rod_e3 * w1111) + 2 * (left_rod_e1_dot * w1112 + left_rod_e3_dot * w1113 + left_rod_e2_dot * w1114)
    w1116 = (w283 * w1087 - w289 * w1084 - w1079) * c64
    w1117 = w1115 + 2 * -(left_rod_e2 * w1116)
    w1118 = 2 * (left_rod_e2 * w1111) + 2 * (left_rod_e2_dot * w1113) + (left_rod_e0_dot * w1112 + left_rod_e3_dot * w1114) * -2.0
    w1119 = w1118 + 2 * (left_rod_e3 * w1116)
    w1120 = (w284 * w1084 - w283 * w1083 - w1072) * c107
    w1121 = w32 * w1111 + w60 * w1120 + (left_rod_e1_dot * w1113 + left_rod_e0_dot * w1114) * -2.0 + 2 * (left_rod_e3_dot * w1112)
    w1122 = w1121 - w30 * w1116
    w1123 = w30 * w1111 + w50 * w1120 + 2 * (left_rod_e1_dot * w1114) + (left_rod_e2_dot * w1112 + left_rod_e0_dot * w1113) * -2.0
    w1124 = w1123 + w32 * w1116
    w1125 = w1110 - w557 * w1072 - w558 * w1075 - w559 * w1079 - w553 * w1117 - w554 * w1119 + w555 * w1122 + w556 * w1124
    w1126 = w933 * (w3 * w1050 + w12 * w1051 + w11 * w1052) + w934 * (w11 * w1050 + w5 * w1051 + w16 * w1052)
    w1127 = w1086 + w1087
    w1128 = w1081 + w1084
    w1129 = w1082 + w1083
    w1130 = w1126 + w946 * w1127 + w960 * w1128 + w965 * w1129 + w933 * (w220 * w1085 + w221 * w1088 + w215 * w1089)
    w1131 = w977 * w1086 - (w1130 + w934 * (w287 * w1085 + w217 * w1088 + w220 * w1089)) + w981 * w1081 + w983 * w1082
    w1132 = w119 * w1097 + w145 * w1098 + w126 * w1099
    w1133 = w120 * w1097 + w126 * w1098 + w140 * w1099
    w1134 = w145 * w1097 + w122 * w1098 + w120 * w1099
    w1135 = w150 * w1097 + w120 * w1098 + w119 * w1099
    w1136 = w1131 + w989 * w1132 + w995 * w1133 + w997 * w1134 - w999 * w1135 + w1010 * w1087 + w1013 * w1084
    w1137 = w29 * w1112 + w55 * w1113 + w36 * w1114
    w1138 = w30 * w1112 + w36 * w1113 + w50 * w1114
    w1139 = w55 * w1112 + w32 * w1113 + w30 * w1114
    w1140 = w60 * w1112 + w30 * w1113 + w29 * w1114
    w1141 = w1125 - (w65 * w206 + w18 * w211 + w24 * w214) + (w1136 + w1015 * w1083 + w1021 * w1137 - w1027 * w1138 + w1029 * w1139 + w1032 * w1140)
    w1142 = shaft_e0 * w985 + (shaft_e1 * w993 - shaft_e2 * w991 + shaft_e3 * w987)
    w1143 = shaft_e0 * w987 - shaft_e3 * w985 - (shaft_e1 * w991 + shaft_e2 * w993)
    w1144 = shaft_e3 * w993 - shaft_e1 * w987 - (shaft_e0 * w991 + shaft_e2 * w985)
    w1145 = shaft_e0 * w993 - shaft_e1 * w985 + (shaft_e2 * w987 + shaft_e3 * w991)
    w1146 = w181 * w1142 - w182 * w1145 - w183 * w1144 - w184 * w1143
    w1147 = w189 * w1142 - w190 * w1145 - w191 * w1144 - w183 * w1143
    w1148 = w196 * w1142 - w197 * w1145 - w190 * w1144 - w182 * w1143
    w1149 = w488 * w991 - w493 * w987 + w482 * w993 - w475 * w985 - w421 * w1146 + w422 * w1147 - w425 * w1148
    w1150 = w199 * w1142 - w196 * w1145 - w189 * w1144 - w181 * w1143
    w1151 = w173 * w1142 - w174 * w1145 - w175 * w1144 - w176 * w1143
    w1152 = w241 * w1151
    w1153 = w240 * w1151
    w1154 = w164 * w1142 - w166 * w1145 - w167 * w1144 - w168 * w1143
    w1155 = w298 * w1151 - w295 * w1154
    w1156 = w132 * w1142 - w141 * w1145 - w148 * w1144 - w151 * w1143
    w1157 = w241 * w1156
    w1158 = w240 * w1156
    w1159 = w296 * w1154 - w298 * w1156
    w1160 = w5 * w1152 + w12 * w1153 + w295 * w1155 - w16 * w1157 - w11 * w1158 - w296 * w1159
    w1161 = w1160 * c28
    w1162 = w241 * w1154
    w1163 = w240 * w1154
    w1164 = w295 * w1156 - w296 * w1151
    w1165 = w11 * w1157 - (w5 * w1162 + w12 * w1163 + w298 * w1155) + w3 * w1158 + w296 * w1164
    w1166 = (w16 * w1162 - (w11 * w1152 + w3 * w1153) + w11 * w1163 + w298 * w1159 - w295 * w1164) * c28
    w1167 = w1165 * c29
    w1168 = w1160 * c29
    w1169 = w452 * w1151 - w115 * w1155 - w415 * w1156 + w154 * w1159
    w1170 = w1149 - w426 * w1150 + w5 * w1161 + w233 * (w1165 * c108) + w4 * (w1166 + w1167) + w16 * w1168 + 2 * (shaft_e1_dot * w1169)
    w1171 = w415 * w1154 - w414 * w1151 - w114 * w1159 + w115 * w1164
    w1172 = w114 * w1155 - w452 * w1154 + w414 * w1156 - w154 * w1164
    w1173 = w2 * (w1170 + (w114 * w1153 - w115 * w1163 + shaft_e0_dot * w1171 + shaft_e2_dot * w1172) * -2.0)
    w1174 = w488 * w993 - w493 * w985 - w482 * w991 + w475 * w987 + w426 * w1146 + w425 * w1147 + w422 * w1148
    w1175 = w1174 - w421 * w1150 + 2 * (shaft_e3 * w1161) + 2 * (shaft_e2 * (w1167 - w1166)) + 2 * -(shaft_e1 * w1168)
    w1176 = 2 * (w114 * w1152 - w115 * w1162 + shaft_e2_dot * w1169 + shaft_e3_dot * w1171 + shaft_e1_dot * w1172)
    w1177 = w483 * w1145 - w489 * w1142 + w477 * w1144 + w470 * w1143
    w1178 = w1177 / w401
    w1179 = w1177 * c71
    w1180 = w485 * w1145 - w490 * w1142 + w478 * w1144 + w472 * w1143
    w1181 = w1180 / w401
    w1182 = w486 * w1145 - w491 * w1142 + w480 * w1144 + w473 * w1143
    w1183 = w1182 / w401
    w1184 = w394 * w1178 * c72 + w397 * w1181 * c72 + w400 * w1183 * c72
    w1185 = w1180 * c71
    w1186 = w1182 * c71
    w1187 = w654 * (w394 * w1179 + w397 * w1185 + w400 * w1186) / w657 - (w658 * w1177 + w659 * w1180 + w660 * w1182)
    w1188 = w411 * w1178 + w404 * w1179 + w407 * w1184 + w653 * w1187
    w1189 = w411 * w1181 + w404 * w1185 + w409 * w1184 + w683 * w1187
    w1190 = w411 * w1183 + w410 * w1184 + w404 * w1186 + w689 * w1187
    w1191 = w400 * w1184
    w1192 = w397 * w1184
    w1193 = w395 * w1191 - w398 * w1192
    w1194 = w394 * w1184
    w1195 = w392 * w1192 - w395 * w1194
    w1196 = w398 * w1194 - w392 * w1191
    w1197 = (w1190 + (w279 * w1194 - w288 * w1192)) * c69
    w1198 = 2 * (slider_e1_dot * w1193 + slider_e3_dot * w1195 + slider_e2_dot * w1196) + 2 * -(slider_e2 * w1197)
    w1199 = (w1189 + (w288 * w1191 - w282 * w1194)) * c69
    w1200 = w1173 - w525 * (w1175 + w1176) + w682 * w1188 + w688 * w1189 + w595 * w1190 - w525 * (w1198 + 2 * (slider_e3 * w1199))
    w1201 = (slider_e2_dot * w1193 + slider_e0_dot * w1195) * -2.0 + 2 * (slider_e1_dot * w1196) + w216 * w1197
    w1202 = w1200 + w2 * (w1201 + w217 * w1199 + w277 * ((w1188 + (w282 * w1192 - w279 * w1191)) * c109)) - w546 * w1188
    w1203 = w460 * w1143
    w1204 = w460 * w1144
    w1205 = w460 * w1145
    w1206 = w460 * w1142
    w1207 = w1143 * c60 - w416 * w1143
    w1208 = w1144 * c60 - w416 * w1144
    w1209 = w1145 * c60 - w416 * w1145
    w1210 = w120 * w1203 + w122 * w1204 + w126 * w1205 - w145 * w1206 + w150 * w1207 + w145 * w1208 + w120 * w1209
    w1211 = w416 * w1142 - w1142 * c60
    w1212 = w459 * w1142
    w1213 = w413 * w1142
    w1214 = w413 * w1145
    w1215 = w459 * w1145
    w1216 = w413 * w1144
    w1217 = w459 * w1144
    w1218 = w413 * w1143
    w1219 = w145 * w1212 - w119 * w1213 + w120 * w1214 - w126 * w1215 + w145 * w1216 - w122 * w1217 + w150 * w1218
    w1220 = w459 * w1143
    w1221 = (w1210 + w119 * w1211) * c36 + (w1219 - w120 * w1220 - w408 * w1191 + w406 * w1194 - w1189) * c70
    w1222 = w440 * w1142 - w437 * w1145
    w1223 = w440 * w1145
    w1224 = w451 * w1145
    w1225 = w443 * w1144
    w1226 = (w119 * w1222 - w120 * w1223) * c39 - w193 * w1223 + w396 * w1214 - w399 * w1224 + w464 * w1145 - w187 * w1225
    w1227 = w443 * w1145 + w440 * w1144
    w1228 = w443 * w1142 - w437 * w1144
    w1229 = w1226 - w186 * w1227 + (w126 * w1228 - (w120 * w1225 + w145 * w1227)) * c41 - w393 * w1216 + w399 * w1217
    w1230 = w446 * w1143
    w1231 = w446 * w1144 + w443 * w1143
    w1232 = w446 * w1145 + w440 * w1143
    w1233 = w446 * w1142 - w437 * w1143
    w1234 = w1229 + w466 * w1144 - w180 * w1230 - w179 * w1231 - w178 * w1232 + (w145 * w1233 - (w120 * w1230 + w119 * w1231 + w150 * w1232)) * c42
    w1235 = w451 * w1143
    w1236 = w453 * w1143
    w1237 = w453 * w1145
    w1238 = w1234 + w393 * w1235 - w396 * w1220 + w467 * w1143 + w125 * w1203 - w162 * w1204 - w130 * w1236 + w162 * w1237
    w1239 = w399 * w1192 - w396 * w1191
    w1240 = w396 * w1194 - w393 * w1192
    w1241 = w393 * w1191 - w399 * w1194
    w1242 = w1238 - w130 * w1208 + w125 * w1209 + right_rod_e1_dot * w1239 + right_rod_e3_dot * w1240 + right_rod_e2_dot * w1241
    w1243 = w150 * w1145 - w145 * w1142 + w119 * w1144 + w120 * w1143
    w1244 = w145 * w1145 - w126 * w1142 + w120 * w1144 + w122 * w1143
    w1245 = w463 * w1243 - w462 * w1244 + (w376 * w1244 - w380 * w1243) * c40
    w1246 = w120 * w1145 - w119 * w1142 + w140 * w1144 + w126 * w1143
    w1247 = (w387 * w1243 - w376 * w1246) * c37 - w465 * w1243 + w462 * w1246
    w1248 = w465 * w1244 - w463 * w1246 + (w380 * w1246 - w387 * w1244) * c38
    w1249 = 2 * (right_rod_e3 * w1221) + 2 * (w1242 + right_rod_e1_dot * w1245 + right_rod_e2_dot * w1247 + right_rod_e3_dot * w1248)
    w1250 = w453 * w1144
    w1251 = w126 * w1206 - (w119 * w1203 + w120 * w1204 + w140 * w1205) + w150 * w1236 + w145 * w1250 + w120 * w1237
    w1252 = w453 * w1142
    w1253 = w451 * w1142
    w1254 = w451 * w1144
    w1255 = w119 * w1253 - w126 * w1212 - w120 * w1224 + w140 * w1215 - w145 * w1254 + w120 * w1217 - w150 * w1235
    w1256 = (w1251 - w119 * w1252) * c36 + (w1255 + w119 * w1220 + w408 * w1192 - w405 * w1194 - w1190) * c70
    w1257 = w1249 + 2 * -(right_rod_e2 * w1256)
    w1258 = w393 * w1254 - w396 * w1217 - w179 * w1230 + (w126 * w1233 - (w122 * w1230 + w120 * w1231 + w145 * w1232)) * c41
    w1259 = w1258 + w466 * w1143 + w125 * w1204 - w130 * w1250 + right_rod_e2_dot * w1240 + right_rod_e3_dot * w1247
    w1260 = w806 * w1142 * c100 - w396 * w1213 + w399 * w1253 - w464 * w1142 + w193 * w1222 - w188 * w1225 + (w145 * w1228 - (w119 * w1225 + w150 * w1227)) * c42
    w1261 = w1260 + w186 * w1228 + w467 * w1144 - w180 * w1231 + w178 * w1233 - w393 * w1218 + w399 * w1220 - w162 * w1203
    w1262 = w1261 - w162 * w1252 - w130 * w1207 + w125 * w1211 + right_rod_e0_dot * w1239 + right_rod_e3_dot * w1241
    w1263 = 2 * (right_rod_e2 * w1221) + 2 * w1259 + (w1262 + right_rod_e0_dot * w1245 + right_rod_e2_dot * w1248) * -2.0
    w1264 = w1263 + 2 * (right_rod_e3 * w1256)
    w1265 = w145 * w1252 - (w120 * w1236 + w122 * w1250 + w126 * w1237) - w119 * w1207 - w120 * w1208 - w140 * w1209
    w1266 = w126 * w1213 - w145 * w1253 - w140 * w1214 + w126 * w1224 - w120 * w1216 + w122 * w1254 - w119 * w1218
    w1267 = (w1265 - w126 * w1211) * c36 + (w1266 + w120 * w1235 + w405 * w1191 - w406 * w1192 - w1188) * c70
    w1268 = 2 * -w1267
    w1269 = w818 * w1142 * c101 + w393 * w1213 - w399 * w1212 - w466 * w1142 + w194 * w1222 + w393 * w1224 - w396 * w1215
    w1270 = w1269 + w187 * w1228 - w178 * w1230 + w179 * w1233 + (w119 * w1233 - (w126 * w1230 + w140 * w1231 + w120 * w1232)) * c39
    w1271 = w1270 + w464 * w1143 + w125 * w1205 + w162 * w1206 - w130 * w1237 - w130 * w1211 + right_rod_e1_dot * w1240
    w1272 = w122 * w1221 + w150 * w1268 + (w1271 + right_rod_e0_dot * w1241 + right_rod_e3_dot * w1245 + right_rod_e0_dot * w1247) * -2.0
    w1273 = (w145 * w1222 - w150 * w1223) * c42 - w195 * w1223 + w467 * w1145 - w188 * w1227 - w180 * w1232 + w396 * w1218
    w1274 = w1273 - w399 * w1235 + w162 * w1236 + w125 * w1207 + right_rod_e3_dot * w1239 + right_rod_e1_dot * w1248
    w1275 = w1272 + 2 * w1274 - w120 * w1256
    w1276 = w399 * w1215 - w393 * w1214 - w186 * w1225 + (w119 * w1228 - (w140 * w1225 + w120 * w1227)) * c39
    w1277 = w1276 + w464 * w1144 - w178 * w1231 - w162 * w1205 - w130 * w1209 + right_rod_e1_dot * w1241 + right_rod_e2_dot * w1245
    w1278 = w828 * w1142 * c102 - w393 * w1253 + w396 * w1212 - w467 * w1142 - w194 * w1223 + w195 * w1222 + (w126 * w1222 - w145 * w1223) * c41
    w1279 = w1278 + w466 * w1145 - w187 * w1227 + w188 * w1228 + w396 * w1216 - w399 * w1254 - w179 * w1232 + w180 * w1233
    w1280 = w1279 - w125 * w1206 + w162 * w1250 + w130 * w1252 + w125 * w1208 + right_rod_e2_dot * w1239 + right_rod_e0_dot * w1240
    w1281 = w120 * w1221 + w140 * w1268 + 2 * w1277 + (w1280 + right_rod_e1_dot * w1247 + right_rod_e0_dot * w1248) * -2.0
    w1282 = w1281 + w122 * w1256
    w1283 = w200 * w1142 - (w185 * w1143 + w192 * w1144 + w198 * w1145) + (w1202 - w547 * w1189 - w548 * w1190 - w542 * w1257 + w543 * w1264 + w544 * w1275 + w545 * w1282)
    w1284 = 2 * w1146
    w1285 = 2 * w1147
    w1286 = 2 * w1148
    w1287 = 2 * w1150
    w1288 = w434 * w1284 - w433 * w1285 + w430 * w1286 - w429 * w1287 + w3 * w1169 + w12 * w1171 + w11 * w1172
    w1289 = w430 * w1285 - w429 * w1284 + w433 * w1286 - w434 * w1287 + w11 * w1169 + w5 * w1171 + w16 * w1172
    w1290 = w946 * w1194 - (w933 * w1288 + w934 * w1289) + w960 * w1192 + w965 * w1191 - w933 * (w220 * w1193 + w221 * w1195 + w215 * w1196)
    w1291 = w1290 - w934 * (w287 * w1193 + w217 * w1195 + w220 * w1196) - w977 * w1194 - w981 * w1192 - w983 * w1191
    w1292 = w119 * w1239 + w145 * w1240 + w126 * w1241 + w119 * w1245 + w126 * w1247 + w145 * w1248
    w1293 = w120 * w1239 + w126 * w1240 + w140 * w1241 + w120 * w1245 + w145 * w1247 + w150 * w1248
    w1294 = w145 * w1239 + w122 * w1240 + w120 * w1241 + w140 * w1245 + w120 * w1247 + w119 * w1248
    w1295 = w150 * w1239 + w120 * w1240 + w119 * w1241 + w126 * w1245 + w122 * w1247 + w120 * w1248
    w1296 = shaft_e0 * w1019 - (shaft_e1 * w1023 + shaft_e2 * w1025 - shaft_e3 * w1017)
    w1297 = shaft_e0 * w1023 + shaft_e1 * w1019 - (shaft_e2 * w1017 + shaft_e3 * w1025)
    w1298 = shaft_e0 * w1025 + shaft_e2 * w1019 + (shaft_e3 * w1023 + shaft_e1 * w1017)
    w1299 = shaft_e3 * w1019 - shaft_e0 * w1017 + (shaft_e1 * w1025 - shaft_e2 * w1023)
    w1300 = w93 * w1296 + w94 * w1297 + w95 * w1298 + w96 * w1299
    w1301 = w101 * w1296 + w102 * w1297 + w103 * w1298 + w95 * w1299
    w1302 = w108 * w1296 + w109 * w1297 + w102 * w1298 + w94 * w1299
    w1303 = w373 * w1017 - w369 * w1025 + w364 * w1023 + w358 * w1019 - w304 * w1300 + w308 * w1301 + w306 * w1302
    w1304 = w111 * w1296 + w108 * w1297 + w101 * w1298 + w93 * w1299
    w1305 = w76 * w1296 + w78 * w1297 + w79 * w1298 + w80 * w1299
    w1306 = w85 * w1296 + w86 * w1297 + w87 * w1298 + w88 * w1299
    w1307 = w295 * w1305 - w298 * w1306
    w1308 = w241 * w1306
    w1309 = w240 * w1306
    w1310 = w42 * w1296 + w51 * w1297 + w58 * w1298 + w61 * w1299
    w1311 = w241 * w1310
    w1312 = w240 * w1310
    w1313 = w298 * w1310 - w296 * w1305
    w1314 = w295 * w1307 - (w5 * w1308 + w12 * w1309) + w16 * w1311 + w11 * w1312 - w296 * w1313
    w1315 = w1314 * c6
    w1316 = w241 * w1305
    w1317 = w240 * w1305
    w1318 = w296 * w1306 - w295 * w1310
    w1319 = w5 * w1316 + w12 * w1317 - w298 * w1307 - w11 * w1311 - w3 * w1312 + w296 * w1318
    w1320 = (w11 * w1308 + w3 * w1309 - w16 * w1316 - w11 * w1317 + w298 * w1313 - w295 * w1318) * c6
    w1321 = w1319 * c7
    w1322 = w1314 * c7
    w1323 = w299 * w1310 - (w337 * w1306 + w25 * w1307) + w66 * w1313
    w1324 = w1303 - w310 * w1304 + w5 * w1315 + w233 * (w1319 * c110) + w4 * (w1320 + w1321) + w16 * w1322 + 2 * (shaft_e1_dot * w1323)
    w1325 = w297 * w1306 - w299 * w1305 - w19 * w1313 + w25 * w1318
    w1326 = w337 * w1305 + w19 * w1307 - w297 * w1310 - w66 * w1318
    w1327 = w373 * w1019 + w369 * w1023 + w364 * w1025 - w358 * w1017 + w310 * w1300 - w306 * w1301 + w308 * w1302
    w1328 = w1327 - w304 * w1304 + 2 * (shaft_e3 * w1315) + 2 * (shaft_e2 * (w1321 - w1320)) + 2 * -(shaft_e1 * w1322)
    w1329 = 2 * (w25 * w1316 - w19 * w1308 + shaft_e2_dot * w1323 + shaft_e3_dot * w1325 + shaft_e1_dot * w1326)
    w1330 = w2 * (w1324 + (w25 * w1317 - w19 * w1309 + shaft_e0_dot * w1325 + shaft_e2_dot * w1326) * -2.0) - w525 * (w1328 + w1329)
    w1331 = w370 * w1296 + w365 * w1297 + w360 * w1298 + w354 * w1299
    w1332 = w1331 / w272
    w1333 = w1331 * c65
    w1334 = w371 * w1296 + w367 * w1297 + w361 * w1298 + w356 * w1299
    w1335 = w1334 / w272
    w1336 = w372 * w1296 + w368 * w1297 + w363 * w1298 + w357 * w1299
    w1337 = w1336 / w272
    w1338 = w263 * w1332 * c66 + w267 * w1335 * c66 + w271 * w1337 * c66
    w1339 = w1334 * c65
    w1340 = w1336 * c65
    w1341 = w672 * (w263 * w1333 + w267 * w1339 + w271 * w1340) / w675 - (w676 * w1331 + w677 * w1334 + w678 * w1336)
    w1342 = w292 * w1332 + w275 * w1333 + w285 * w1338 + w671 * w1341
    w1343 = w292 * w1335 + w275 * w1339 + w290 * w1338 + w685 * w1341
    w1344 = w292 * w1337 + w291 * w1338 + w275 * w1340 + w691 * w1341
    w1345 = w271 * w1338
    w1346 = w267 * w1338
    w1347 = w265 * w1345 - w269 * w1346
    w1348 = w263 * w1338
    w1349 = w261 * w1346 - w265 * w1348
    w1350 = w269 * w1348 - w261 * w1345
    w1351 = (w1344 + (w279 * w1348 - w288 * w1346)) * c63
    w1352 = 2 * (slider_e1_dot * w1347 + slider_e3_dot * w1349 + slider_e2_dot * w1350) + 2 * -(slider_e2 * w1351)
    w1353 = (w1343 + (w288 * w1345 - w282 * w1348)) * c63
    w1354 = (slider_e2_dot * w1347 + slider_e0_dot * w1349) * -2.0 + 2 * (slider_e1_dot * w1350) + w216 * w1351
    w1355 = w1330 + w682 * w1342 + w688 * w1343 + w595 * w1344 - w525 * (w1352 + 2 * (slider_e3 * w1353)) + w2 * (w1354 + w217 * w1353 + w277 * ((w1342 + (w282 * w1346 - w279 * w1345)) * c111))
    w1356 = w344 * w1299
    w1357 = w344 * w1298
    w1358 = w344 * w1297
    w1359 = w344 * w1296
    w1360 = w1299 * c60 - w300 * w1299
    w1361 = w1298 * c60 - w300 * w1298
    w1362 = w1297 * c60 - w300 * w1297
    w1363 = w1296 * c60 - w300 * w1296
    w1364 = w30 * w1356 + w32 * w1357 + w36 * w1358 + w55 * w1359 + w60 * w1360 + w55 * w1361 + w30 * w1362 + w29 * w1363
    w1365 = w294 * w1296
    w1366 = w343 * w1296
    w1367 = w294 * w1297
    w1368 = w343 * w1297
    w1369 = w294 * w1298
    w1370 = w343 * w1298
    w1371 = w294 * w1299
    w1372 = w343 * w1299
    w1373 = w29 * w1365 - w55 * w1366 + w30 * w1367 - w36 * w1368 + w55 * w1369 - w32 * w1370 + w60 * w1371 - w30 * w1372
    w1374 = w1364 * c13 + (w1373 - w289 * w1345 + w284 * w1348 - w1343) * c64
    w1375 = w324 * w1297
    w1376 = w324 * w1296 + w321 * w1297
    w1377 = w336 * w1297
    w1378 = w327 * w1298
    w1379 = w266 * w1367 - (w105 * w1375 + (w30 * w1375 + w29 * w1376) * c16) - w270 * w1377 + w348 * w1297 - w99 * w1378
    w1380 = w327 * w1297 + w324 * w1298
    w1381 = w327 * w1296 + w321 * w1298
    w1382 = w1379 - w98 * w1380 - (w30 * w1378 + w55 * w1380 + w36 * w1381) * c18 - w262 * w1369 + w270 * w1370
    w1383 = w330 * w1299
    w1384 = w330 * w1298 + w327 * w1299
    w1385 = w330 * w1297 + w324 * w1299
    w1386 = w330 * w1296 + w321 * w1299
    w1387 = w1382 + w350 * w1298 - w92 * w1383 - w91 * w1384 - w90 * w1385 - (w30 * w1383 + w29 * w1384 + w60 * w1385 + w55 * w1386) * c19
    w1388 = w336 * w1299
    w1389 = w338 * w1299
    w1390 = w338 * w1297
    w1391 = w1387 + w262 * w1388 - w266 * w1372 + w351 * w1299 + w35 * w1356 - w74 * w1357 - w40 * w1389 + w74 * w1390
    w1392 = w270 * w1346 - w266 * w1345
    w1393 = w266 * w1348 - w262 * w1346
    w1394 = w262 * w1345 - w270 * w1348
    w1395 = w1391 - w40 * w1361 + w35 * w1362 + left_rod_e1_dot * w1392 + left_rod_e3_dot * w1393 + left_rod_e2_dot * w1394
    w1396 = w55 * w1296 + w60 * w1297 + w29 * w1298 + w30 * w1299
    w1397 = w36 * w1296 + w55 * w1297 + w30 * w1298 + w32 * w1299
    w1398 = w347 * w1396 - w346 * w1397 + (w244 * w1397 - w248 * w1396) * c17
    w1399 = w29 * w1296 + w30 * w1297 + w50 * w1298 + w36 * w1299
    w1400 = (w255 * w1396 - w244 * w1399) * c14 - w349 * w1396 + w346 * w1399
    w1401 = w349 * w1397 - w347 * w1399 + (w248 * w1399 - w255 * w1397) * c15
    w1402 = 2 * (left_rod_e3 * w1374) + 2 * (w1395 + left_rod_e1_dot * w1398 + left_rod_e2_dot * w1400 + left_rod_e3_dot * w1401)
    w1403 = w338 * w1298
    w1404 = w60 * w1389 - (w29 * w1356 + w30 * w1357 + w50 * w1358 + w36 * w1359) + w55 * w1403 + w30 * w1390
    w1405 = w338 * w1296
    w1406 = w336 * w1296
    w1407 = w336 * w1298
    w1408 = w36 * w1366 - w29 * w1406 - w30 * w1377 + w50 * w1368 - w55 * w1407 + w30 * w1370 - w60 * w1388 + w29 * w1372
    w1409 = (w1404 + w29 * w1405) * c13 + (w1408 + w289 * w1346 - w283 * w1348 - w1344) * c64
    w1410 = w1402 + 2 * -(left_rod_e2 * w1409)
    w1411 = w262 * w1407 - w266 * w1370 - w91 * w1383 - (w32 * w1383 + w30 * w1384 + w55 * w1385 + w36 * w1386) * c18
    w1412 = w1411 + w350 * w1299 + w35 * w1357 - w40 * w1403 + left_rod_e2_dot * w1393 + left_rod_e3_dot * w1400
    w1413 = w266 * w1365 - w904 * w1296 * c103 - w270 * w1406 + w348 * w1296 - w105 * w1376 - w100 * w1378 - (w29 * w1378 + w60 * w1380 + w55 * w1381) * c19
    w1414 = w1413 - w98 * w1381 + w351 * w1298 - w92 * w1384 - w90 * w1386 - w262 * w1371 + w270 * w1372 - w74 * w1356
    w1415 = w1414 + w74 * w1405 - w40 * w1360 + w35 * w1363 + left_rod_e0_dot * w1392 + left_rod_e3_dot * w1394
    w1416 = 2 * (left_rod_e2 * w1374) + 2 * w1412 + (w1415 + left_rod_e0_dot * w1398 + left_rod_e2_dot * w1401) * -2.0
    w1417 = w1416 + 2 * (left_rod_e3 * w1409)
    w1418 = w55 * w1406 - w36 * w1365 - w50 * w1367 + w36 * w1377 - w30 * w1369 + w32 * w1407 - w29 * w1371 + w30 * w1388
    w1419 = w30 * w1389 + w32 * w1403 + w36 * w1390 + w55 * w1405 + w29 * w1360 + w30 * w1361 + w50 * w1362 + w36 * w1363
    w1420 = 2 * -((w1418 + w283 * w1345 - w284 * w1346 - w1342) * c64 - w1419 * c13)
    w1421 = w270 * w1366 - (w916 * w1296 * c104 + w262 * w1365) + w350 * w1296 - w106 * w1376 + w262 * w1377 - w266 * w1368
    w1422 = w1421 - w99 * w1381 - w90 * w1383 - w91 * w1386 - (w36 * w1383 + w50 * w1384 + w30 * w1385 + w29 * w1386) * c16
    w1423 = w1422 + w348 * w1299 + w35 * w1358 - w74 * w1359 - w40 * w1390 - w40 * w1363 + left_rod_e1_dot * w1393
    w1424 = w32 * w1374 + w60 * w1420 + (w1423 + left_rod_e0_dot * w1394 + left_rod_e3_dot * w1398 + left_rod_e0_dot * w1400) * -2.0
    w1425 = w351 * w1297 - (w107 * w1375 + (w60 * w1375 + w55 * w1376) * c19) - w100 * w1380 - w92 * w1385 + w266 * w1371
    w1426 = w1425 - w270 * w1388 + w74 * w1389 + w35 * w1360 + left_rod_e3_dot * w1392 + left_rod_e1_dot * w1401
    w1427 = w1424 + 2 * w1426 - w30 * w1409
    w1428 = w270 * w1368 - w262 * w1367 - w98 * w1378 - (w50 * w1378 + w30 * w1380 + w29 * w1381) * c16 + w348 * w1298
    w1429 = w1428 - w90 * w1384 - w74 * w1358 - w40 * w1362 + left_rod_e1_dot * w1394 + left_rod_e2_dot * w1398
    w1430 = w262 * w1406 - w926 * w1296 * c105 - w266 * w1366 + w351 * w1296 - w106 * w1375 - w107 * w1376 - (w55 * w1375 + w36 * w1376) * c18
    w1431 = w1430 + w350 * w1297 - w99 * w1380 - w100 * w1381 + w266 * w1369 - w270 * w1407 - w91 * w1385 - w92 * w1386
    w1432 = w1431 + w35 * w1359 + w74 * w1403 - w40 * w1405 + w35 * w1361 + left_rod_e2_dot * w1392 + left_rod_e0_dot * w1393
    w1433 = w30 * w1374 + w50 * w1420 + 2 * w1429 + (w1432 + left_rod_e1_dot * w1400 + left_rod_e0_dot * w1401) * -2.0
    w1434 = w1433 + w32 * w1409
    w1435 = w1355 - w557 * w1342 - w558 * w1343 - w559 * w1344 - w553 * w1410 - w554 * w1417 + w555 * w1427 + w556 * w1434
    w1436 = 2 * w1300
    w1437 = 2 * w1301
    w1438 = 2 * w1302
    w1439 = 2 * w1304
    w1440 = w318 * w1436 - w317 * w1437 - w314 * w1438 - w313 * w1439 + w3 * w1323 + w12 * w1325 + w11 * w1326
    w1441 = w317 * w1438 - (w313 * w1436 + w314 * w1437) - w318 * w1439 + w11 * w1323 + w5 * w1325 + w16 * w1326
    w1442 = w946 * w1348 - (w933 * w1440 + w934 * w1441) + w960 * w1346 + w965 * w1345 - w933 * (w220 * w1347 + w221 * w1349 + w215 * w1350)
    w1443 = w1442 - w934 * (w287 * w1347 + w217 * w1349 + w220 * w1350) - w1010 * w1348 - w1013 * w1346 - w1015 * w1345
    w1444 = w29 * w1392 + w55 * w1393 + w36 * w1394 + w29 * w1398 + w36 * w1400 + w55 * w1401
    w1445 = w30 * w1392 + w36 * w1393 + w50 * w1394 + w30 * w1398 + w55 * w1400 + w60 * w1401
    w1446 = w55 * w1392 + w32 * w1393 + w30 * w1394 + w50 * w1398 + w30 * w1400 + w29 * w1401
    w1447 = w60 * w1392 + w30 * w1393 + w29 * w1394 + w36 * w1398 + w32 * w1400 + w30 * w1401
    w1448 = w1435 - (w97 * w1299 + w104 * w1298 + w110 * w1297 + w112 * w1296) + (w1443 + w1021 * w1444 - w1027 * w1445 + w1029 * w1446 + w1032 * w1447)
    w1449 = w11 * w65
    w1450 = w1449 - w12 * w24
    w1451 = w16 * w65 - w5 * w24
    w1452 = (w500 + w240 * w1450 + w241 * w1451) * c50
    w1453 = w11 * w24 - w16 * w18
    w1454 = w3 * w24 - w11 * w18
    w1455 = (w496 + w240 * w1454 + w241 * w1453) * c50
    w1456 = w12 * w18 - w3 * w65
    w1457 = w5 * w18 - w1449
    w1458 = (w503 + w240 * w1456 + w241 * w1457) * c50
    w1459 = w2 * (w208 * w1452 + w501 * w1451 - (w499 * w1453 - w204 * w1455) + (w212 * w1458 + w504 * w1457))
    w1460 = w525 * (w210 * w1452 + w501 * w1450 - (w499 * w1454 - w205 * w1455) + (w213 * w1458 + w504 * w1456))
    w1461 = w935 * w1456 - w938 * w1457
    w1462 = w935 * w1450 - w938 * w1451
    w1463 = w935 * w1454 - w938 * w1453
    w1464 = w1459 - w1460 + (w24 * w681 + w18 * w687 + w65 * w693) + (w932 * w1461 + w958 * w1462 + w961 * w1463)
    w1465 = w24 * w1073 + w18 * w1076 + w65 * w1080 - (w65 * w1455 + w18 * w1452 + w24 * w1458) - (w1127 * w1461 + w1128 * w1462 + w1129 * w1463)
    w1466 = w134 * 0.5
    w1467 = w1466 * c31 * c34 - w1466 * c33 * c32
    w1468 = w136 * 0.5
    w1469 = w1468 * c31 * c32 - w1468 * c33 * c34
    w1470 = w418 * w1466
    w1471 = w1470 * c33 * c32 - w1470 * c31 * c34
    w1472 = w418 * w1468
    w1473 = w420 * c112
    w1474 = w1472 * c33 * c34 - w1472 * c31 * c32
    w1475 = w424 * c113
    w1476 = w136 * 0.25
    w1477 = right_swing_angle_dot * w1476
    w1478 = w136 * right_swing_angle_dot * c114
    w1479 = w1477 * c31 * c34 - w1477 * c33 * c32
    w1480 = w134 * 0.25
    w1481 = right_swing_angle_dot * w1480
    w1482 = w134 * right_swing_angle_dot * c115
    w1483 = w1481 * c33 * c34 - w1481 * c31 * c32
    w1484 = shaft_e0_dot * w1478 + (shaft_e1_dot * w1479 + shaft_e2_dot * w1482 + shaft_e3_dot * w1483)
    w1485 = w134 * c113
    w1486 = w1484 + (shaft_e1 * w1471 + shaft_e2 * w1473 + shaft_e3 * w1474 - shaft_e0 * w1475 + w1484) - w240 * w1485
    w1487 = w241 * w1469 - w1486
    w1488 = shaft_e0_dot * w1479 - shaft_e1_dot * w1478 + (shaft_e2_dot * w1483 - shaft_e3_dot * w1482)
    w1489 = w1488 + (shaft_e0 * w1471 + shaft_e1 * w1475 + (shaft_e2 * w1474 - shaft_e3 * w1473) + w1488) - w240 * w1467
    w1490 = w136 * c112
    w1491 = w1489 - w241 * w1490
    w1492 = shaft_e3_dot * w1479 - shaft_e1_dot * w1483 - (shaft_e2_dot * w1478 - shaft_e0_dot * w1482)
    w1493 = w1492 + (shaft_e0 * w1473 + shaft_e2 * w1475 + (shaft_e3 * w1471 - shaft_e1 * w1474) + w1492) + w240 * w1490
    w1494 = w1493 - w241 * w1467
    w1495 = shaft_e0_dot * w1483 - shaft_e3_dot * w1478 - (shaft_e2_dot * w1479 - shaft_e1_dot * w1482)
    w1496 = w1495 + (shaft_e0 * w1474 + shaft_e3 * w1475 + (shaft_e1 * w1473 - shaft_e2 * w1471) + w1495) - w240 * w1469
    w1497 = w1496 + w241 * w1485
    w1498 = w189 * w1487 + w190 * w1491 + w191 * w1494 + w183 * w1497
    w1499 = w132 * w1487 + w141 * w1491 + w148 * w1494 + w151 * w1497
    w1500 = w164 * w1487 + w166 * w1491 + w167 * w1494 + w168 * w1497
    w1501 = w173 * w1487 + w174 * w1491 + w175 * w1494 + w176 * w1497
    w1502 = w181 * w1487 + w182 * w1491 + w183 * w1494 + w184 * w1497
    w1503 = w482 * w1467 - w142 * w1498 - (w116 * w1499 + w155 * w1500 + w170 * w1501 + (w137 * w1502 + w475 * w1485))
    w1504 = w196 * w1487 + w197 * w1491 + w190 * w1494 + w182 * w1497
    w1505 = w199 * w1487 + w196 * w1491 + w189 * w1494 + w181 * w1497
    w1506 = w475 * w1469 - w135 * w1502 - (w117 * w1499 + w157 * w1500 + w171 * w1501) - (w482 * w1490 - w143 * w1498)
    w1507 = w2 * (w1503 + (w488 * w1490 - w143 * w1504) - (w493 * w1469 - w135 * w1505)) - w525 * (w1506 + (w488 * w1467 - w142 * w1504) - (w137 * w1505 + w493 * w1485))
    w1508 = w1476 * c31 * c34 - w1476 * c33 * c32
    w1509 = w136 * c114
    w1510 = w1480 * c33 * c34 - w1480 * c31 * c32
    w1511 = w134 * c115
    w1512 = shaft_e0 * w1508 - shaft_e1 * w1509 + (shaft_e2 * w1510 - shaft_e3 * w1511)
    w1513 = w938 * w1490 - w935 * w1467 + right_swing_angle_dot * w1512
    w1514 = shaft_e0 * w1509 + (shaft_e1 * w1508 + shaft_e2 * w1511 + shaft_e3 * w1510)
    w1515 = w938 * w1469 - w935 * w1485 + right_swing_angle_dot * w1514
    w1516 = shaft_e3 * w1508 - shaft_e1 * w1510 - (shaft_e2 * w1509 - shaft_e0 * w1511)
    w1517 = w935 * w1490 + w938 * w1467 + right_swing_angle_dot * w1516
    w1518 = shaft_e0 * w1510 - shaft_e3 * w1509 - (shaft_e2 * w1508 - shaft_e1 * w1511)
    w1519 = right_swing_angle_dot * w1518 - (w938 * w1485 + w935 * w1469)
    w1520 = w1507 + (w812 * w1145 - w800 * w1142 + w825 * w1144 + w833 * w1143) + (w990 * w1513 - w984 * w1515 + w996 * w1517 + w998 * w1519)
    w1521 = w1104 * w1145 - w1102 * w1142 + w1107 * w1144 + w1109 * w1143 + (w1133 * w1513 - w1132 * w1515 + w1134 * w1517 + w1135 * w1519)
    w1522 = w475 * w1518 - w1143 * w1502 + (w482 * w1516 - w1144 * w1498) + (w488 * w1512 - w1145 * w1504) - (w493 * w1514 - w1142 * w1505)
    w1523 = w1522 + (w1145 * w1264 - w1142 * w1257 + w1144 * w1275 + w1143 * w1282) + (w1293 * w1513 - w1292 * w1515 + w1294 * w1517 + w1295 * w1519)
    w1524 = w46 * 0.5
    w1525 = w1524 * c9 * c10 - w1524 * c11 * c12
    w1526 = w302 * w1524
    w1527 = w1526 * c11 * c12 - w1526 * c9 * c10
    w1528 = w44 * 0.5
    w1529 = w302 * w1528
    w1530 = w1529 * c9 * c12 - w1529 * c11 * c10
    w1531 = w309 * c116
    w1532 = w307 * c117
    w1533 = w44 * 0.25
    w1534 = left_swing_angle_dot * w1533
    w1535 = w1534 * c11 * c12 - w1534 * c9 * c10
    w1536 = w46 * 0.25
    w1537 = left_swing_angle_dot * w1536
    w1538 = w1537 * c11 * c10 - w1537 * c9 * c12
    w1539 = w44 * left_swing_angle_dot * c118
    w1540 = w46 * left_swing_angle_dot * c119
    w1541 = shaft_e0_dot * w1535 - (shaft_e2_dot * w1538 - shaft_e1_dot * w1539 - shaft_e3_dot * w1540)
    w1542 = w1541 + (shaft_e0 * w1527 - (shaft_e2 * w1530 - shaft_e1 * w1531 + shaft_e3 * w1532) + w1541) - w240 * w1525
    w1543 = w44 * c117
    w1544 = w1542 - w241 * w1543
    w1545 = shaft_e1_dot * w1535 - shaft_e0_dot * w1539 - (shaft_e2_dot * w1540 + shaft_e3_dot * w1538)
    w1546 = w46 * c116
    w1547 = w1545 + (shaft_e1 * w1527 - shaft_e0 * w1531 - (shaft_e3 * w1530 - shaft_e2 * w1532) + w1545) - w240 * w1546
    w1548 = w1528 * c11 * c10 - w1528 * c9 * c12
    w1549 = w1547 + w241 * w1548
    w1550 = shaft_e0_dot * w1538 + shaft_e2_dot * w1535 + (shaft_e1_dot * w1540 - shaft_e3_dot * w1539)
    w1551 = w1550 + (shaft_e0 * w1530 + shaft_e2 * w1527 - (shaft_e1 * w1532 + shaft_e3 * w1531) + w1550) - w240 * w1548
    w1552 = w1551 - w241 * w1546
    w1553 = shaft_e3_dot * w1535 - shaft_e0_dot * w1540 + (shaft_e1_dot * w1538 + shaft_e2_dot * w1539)
    w1554 = w1553 + (shaft_e3 * w1527 + shaft_e0 * w1532 + (shaft_e1 * w1530 + shaft_e2 * w1531) + w1553) + w240 * w1543
    w1555 = w1554 - w241 * w1525
    w1556 = w93 * w1544 + w94 * w1549 + w95 * w1552 + w96 * w1555
    w1557 = w42 * w1544 + w51 * w1549 + w58 * w1552 + w61 * w1555
    w1558 = w76 * w1544 + w78 * w1549 + w79 * w1552 + w80 * w1555
    w1559 = w85 * w1544 + w86 * w1549 + w87 * w1552 + w88 * w1555
    w1560 = w101 * w1544 + w102 * w1549 + w103 * w1552 + w95 * w1555
    w1561 = w358 * w1525 - w45 * w1556 - (w26 * w1557 + w67 * w1558 + w82 * w1559) + (w364 * w1546 - w52 * w1560)
    w1562 = w108 * w1544 + w109 * w1549 + w102 * w1552 + w94 * w1555
    w1563 = w111 * w1544 + w108 * w1549 + w101 * w1552 + w93 * w1555
    w1564 = w364 * w1548 - w53 * w1560 - (w27 * w1557 + w69 * w1558 + w83 * w1559 + (w47 * w1556 + w358 * w1543))
    w1565 = w2 * (w1561 - (w369 * w1548 - w53 * w1562) + (w47 * w1563 + w373 * w1543)) - w525 * (w1564 + (w369 * w1546 - w52 * w1562) + (w373 * w1525 - w45 * w1563))
    w1566 = w1533 * c11 * c12 - w1533 * c9 * c10
    w1567 = w1536 * c11 * c10 - w1536 * c9 * c12
    w1568 = w44 * c118
    w1569 = w46 * c119
    w1570 = shaft_e0 * w1566 - (shaft_e2 * w1567 - shaft_e1 * w1568 - shaft_e3 * w1569)
    w1571 = left_swing_angle_dot * w1570 - (w935 * w1525 - w938 * w1543)
    w1572 = shaft_e1 * w1566 - shaft_e0 * w1568 - (shaft_e2 * w1569 + shaft_e3 * w1567)
    w1573 = left_swing_angle_dot * w1572 - (w935 * w1546 + w938 * w1548)
    w1574 = shaft_e0 * w1567 + shaft_e2 * w1566 + (shaft_e1 * w1569 - shaft_e3 * w1568)
    w1575 = w938 * w1546 - w935 * w1548 + left_swing_angle_dot * w1574
    w1576 = shaft_e3 * w1566 - shaft_e0 * w1569 + (shaft_e1 * w1567 + shaft_e2 * w1568)
    w1577 = w938 * w1525 + w935 * w1543 + left_swing_angle_dot * w1576
    w1578 = w1565 + (w898 * w1296 + w910 * w1297 + w923 * w1298 + w931 * w1299) + (w1016 * w1571 + w1022 * w1573 + w1028 * w1575 + w1031 * w1577)
    w1579 = w1117 * w1296 + w1119 * w1297 + w1122 * w1298 + w1124 * w1299 + (w1137 * w1571 + w1138 * w1573 + w1139 * w1575 + w1140 * w1577)
    w1580 = w358 * w1576 - w1299 * w1556 + (w364 * w1574 - w1298 * w1560) + (w369 * w1572 - w1297 * w1562) + (w373 * w1570 - w1296 * w1563)
    w1581 = w1580 + (w1296 * w1410 + w1297 * w1417 + w1298 * w1427 + w1299 * w1434) + (w1444 * w1571 + w1445 * w1573 + w1446 * w1575 + w1447 * w1577)
    dQ_hat_dq_i = ca.vertcat(
        w524 - w541 + (w911 + w555 * w923 + w556 * w931) + (w1030 + w1031 * w1032),
        w1141,
        w1283 + (w1291 + w989 * w1292 + w995 * w1293 + w997 * w1294 - w999 * w1295),
        w1448,
        w1464,
        w1465,
        w24 * w1188 + w18 * w1189 + w65 * w1190 + (w1194 * w1461 + w1192 * w1462 + w1191 * w1463),
        w24 * w1342 + w18 * w1343 + w65 * w1344 + (w1348 * w1461 + w1346 * w1462 + w1345 * w1463),
        w1520,
        w1521,
        w1523,
        0.0,
        w1578,
        w1579,
        0.0,
        w1581,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 4, 4)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 2832 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    slider_x = q_d[7]
    slider_y = q_d[8]
    slider_z = q_d[9]
    slider_e0 = q_d[10]
    slider_e1 = q_d[11]
    slider_e2 = q_d[12]
    slider_e3 = q_d[13]
    right_rod_x = q_d[14]
    right_rod_y = q_d[15]
    right_rod_z = q_d[16]
    right_rod_e0 = q_d[17]
    right_rod_e1 = q_d[18]
    right_rod_e2 = q_d[19]
    right_rod_e3 = q_d[20]
    left_rod_x = q_d[21]
    left_rod_y = q_d[22]
    left_rod_z = q_d[23]
    left_rod_e0 = q_d[24]
    left_rod_e1 = q_d[25]
    left_rod_e2 = q_d[26]
    left_rod_e3 = q_d[27]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
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
    c63 = c[63]
    c64 = c[64]
    c66 = c[66]
    c69 = c[69]
    c70 = c[70]
    c72 = c[72]
    c112 = c[112]
    c113 = c[113]
    c116 = c[116]
    c117 = c[117]
    c120 = c[120]
    c121 = c[121]
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = shaft_e2 * -2.0
    w4 = w2 * spin_angle_dot
    w5 = 2 * shaft_e1
    w6 = ca.sin(w0)
    w7 = w6 / 2.0
    w8 = spin_angle_dot * w7
    w9 = w3 * w8
    w10 = w4 * w5 - w9
    w11 = 2 * shaft_e0
    w12 = shaft_e3 * -2.0
    w13 = w2 * w11 - w7 * w12
    w14 = w13 * c1
    w15 = w4 * w11 - w8 * w12
    w16 = w15 * c1
    w17 = w3 * w7
    w18 = w2 * w5 - w17
    w19 = w18 * c0
    w20 = w10 * c0
    w21 = w10 * w14 + w16 * w18 - (w15 * w19 + w13 * w20)
    w22 = shaft_e1 * -2.0
    w23 = w7 * w22
    w24 = w2 * w3 - w23
    w25 = w24 * c3
    w26 = w8 * w22
    w27 = w3 * w4 - w26
    w28 = w27 * c3
    w29 = w15 * w25 + w13 * w28 - (w14 * w27 + w16 * w24)
    w30 = w19 * w27 + w20 * w24 - (w10 * w25 + w18 * w28)
    w31 = w11 * c5
    w32 = shaft_e2 * shaft_e1 * c57 + w12 * w31
    w33 = spin_angle_dot * 0.5
    w34 = w1 * w33
    w35 = w6 * w33
    w36 = w3 * w21 + w5 * w29 + w11 * w30 + (w32 * w34 + (w3 * (w3 * c2) + w5 * (w5 * c4) + w11 * w31) * w35)
    w37 = 2 * shaft_e2
    w38 = w11 * shaft_e3 + shaft_e2 * w5
    w39 = shaft_e3 * w37 - shaft_e1 * w11
    w40 = w38 * c6 + w39 * c7
    w41 = 2 * shaft_e2**2
    w42 = 1.0 - w41 - 2 * shaft_e3**2
    w43 = shaft_e2 * w11
    w44 = w5 * shaft_e3
    w45 = w43 + w44
    w46 = w42 * c6 + w45 * c7
    w47 = w37 * w40 - w22 * w46
    w48 = 2 * left_rod_e1
    w49 = w48 * left_rod_e3
    w50 = 2 * left_rod_e0
    w51 = w50 * left_rod_e2
    w52 = w49 - w51
    w53 = left_swing_angle / 2.0
    w54 = ca.cos(w53)
    w55 = w54 / 2.0
    w56 = w55 * c9
    w57 = w55 * c11
    w58 = w56 * c10 - w57 * c12
    w59 = w57 * c10 + w56 * c12
    w60 = ca.sin(w53)
    w61 = w60 / 2.0
    w62 = w61 * c11 * c10 - w61 * c9 * c12
    w63 = w61 * c24
    w64 = shaft_e0 * w58 - (shaft_e1 * w59 + shaft_e2 * w62 - shaft_e3 * w63)
    w65 = w60 * c9 * c10 - w60 * c11 * c12
    w66 = w54 * c24
    w67 = w64 * left_swing_angle_dot - (w8 * w65 + w4 * w66)
    w68 = left_rod_e3 * -2.0
    w69 = shaft_e0 * w59 + shaft_e1 * w58 - (shaft_e2 * w63 + shaft_e3 * w62)
    w70 = w60 * c20
    w71 = w54 * c9 * c12 - w54 * c11 * c10
    w72 = left_swing_angle_dot * w69 - (w8 * w70 + w4 * w71)
    w73 = 2 * left_rod_e2
    w74 = shaft_e0 * w62 + shaft_e2 * w58 + (shaft_e3 * w59 + shaft_e1 * w63)
    w75 = w4 * w70 - w8 * w71 + left_swing_angle_dot * w74
    w76 = left_rod_e1 * -2.0
    w77 = shaft_e3 * w58 - shaft_e0 * w63 + (shaft_e1 * w62 - shaft_e2 * w59)
    w78 = w4 * w65 - w8 * w66 + left_swing_angle_dot * w77
    w79 = w67 * w68 + w72 * w73 + w75 * w76 + w50 * w78
    w80 = w2 * w70 - w7 * w71
    w81 = w7 * w65 + w2 * w66
    w82 = w68 * w81
    w83 = w7 * w70 + w2 * w71
    w84 = w2 * w65 - w7 * w66
    w85 = w50 * w84
    w86 = w76 * w80 - (w82 + w73 * w83) + w85
    w87 = w79 * c13
    w88 = left_rod_e2 * -2.0
    w89 = w67 * w88 + w68 * w72 + w50 * w75 + w48 * w78
    w90 = w50 * w80
    w91 = w81 * w88
    w92 = w90 - (w91 + w68 * w83) + w48 * w84
    w93 = w89 * c13
    w94 = w79 * w86 * c120 + w89 * w92 * c120
    w95 = left_rod_e1 * w50
    w96 = left_rod_e3 * w73
    w97 = w95 + w96
    w98 = 2 * left_rod_e3
    w99 = w67 * w76 + w50 * w72 + w75 * w98 + w78 * w88
    w100 = w76 * w81 + w50 * w83
    w101 = w80 * w98 - w100 + w84 * w88
    w102 = w92 * c13 * w99 + w93 * w101
    w103 = 1.0 - 2 * left_rod_e1**2
    w104 = 2 * left_rod_e2**2
    w105 = w103 - w104
    w106 = w86 * c13 * w99 + w87 * w101
    w107 = 2 * slider_e1
    w108 = 2 * slider_e0
    w109 = w107 * slider_e3 - w108 * slider_e2
    w110 = w109 * c63
    w111 = w52 * c64
    w112 = slider_z + w110 - (left_rod_z + w111)
    w113 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w114 = w113 * c63
    w115 = 2 * left_rod_e3**2
    w116 = 1.0 - w104 - w115
    w117 = w116 * c64
    w118 = slider_x + w114 - (left_rod_x + w117)
    w119 = w39 * height_travel
    w120 = 1.0 - 2 * shaft_e1**2 - w41
    w121 = height_travel * w120
    w122 = w12 * w119 - w3 * w121
    w123 = w22 * w121
    w124 = w11 * w119 - w123
    w125 = w7 * w122 - w2 * w124
    w126 = slider_e1 * -2.0
    w127 = slider_e2 * -2.0
    w128 = w7 * w127
    w129 = w2 * w126 - w128
    w130 = slider_e3 * w108 + w107 * slider_e2
    w131 = w130 * c63
    w132 = slider_e3 * -2.0
    w133 = w2 * w108 - w7 * w132
    w134 = w44 - w43
    w135 = w134 * c6 + w120 * c7
    w136 = w22 * w135
    w137 = w136 - w11 * w40
    w138 = w3 * w135 - w12 * w40
    w139 = w90 - (w91 + w83 * w98) + w76 * w84
    w140 = left_rod_e3 * w50
    w141 = w48 * left_rod_e2
    w142 = w140 + w141
    w143 = w142 * c64
    w144 = w85 + (w48 * w80 - (w82 + w83 * w88))
    w145 = w118 * (w125 + (w110 * w129 - w131 * w133) - (w2 * w137 - w7 * w138 + (w111 * w139 - w143 * w144)))
    w146 = w131 + slider_y - (w143 + left_rod_y)
    w147 = w45 * height_travel
    w148 = w123 - w12 * w147
    w149 = w37 * w121 - w11 * w147
    w150 = w7 * w148 - w2 * w149
    w151 = 2 * slider_e2
    w152 = w7 * w126
    w153 = w2 * w151 - w152
    w154 = w11 * w46 - w37 * w135
    w155 = w12 * w46 - w136
    w156 = w68 * w80 - w100 + w73 * w84
    w157 = w146 * (w150 + (w114 * w133 - w110 * w153) - (w2 * w154 - w7 * w155 + (w117 * w144 - w111 * w156)))
    w158 = w3 * w147 - w22 * w119
    w159 = w22 * w147 - w37 * w119
    w160 = w7 * w158 - w2 * w159
    w161 = w22 * w40 - w3 * w46
    w162 = w112 * (w160 + (w131 * w153 - w114 * w129) - (w2 * w47 - w7 * w161 + (w143 * w156 - w117 * w139)))
    w163 = (w145 + w157 + w162) * c66
    w164 = w118**2 + w146**2 + w112**2
    w165 = w112 * w163 / w164
    w166 = w4 * w37 - w26
    w167 = w15 * w46 - w135 * w166
    w168 = w2 * w37 - w23
    w169 = w13 * w46 - w135 * w168
    w170 = w4 * w22 - w9
    w171 = w135 * w170 - w15 * w40
    w172 = w2 * w22 - w17
    w173 = w135 * w172 - w13 * w40
    w174 = w167 * w168 + w166 * w169 - (w171 * w172 + w170 * w173) - w34 * w161 - w35 * w47
    w175 = w142 * c13
    w176 = w116 * c13
    w177 = w88 * w176
    w178 = w76 * w175 - w177
    w179 = w61 * left_swing_angle_dot
    w180 = w179 * c24
    w181 = w55 * left_swing_angle_dot
    w182 = w181 * c9 * c10 - w181 * c11 * c12
    w183 = 2 * (w2 * w180 - w7 * w182) - w34 * w65 + w35 * w66
    w184 = w50 * w175
    w185 = w184 - w98 * w176
    w186 = w181 * c20
    w187 = w179 * c11 * c10 - w179 * c9 * c12
    w188 = w35 * w71 - (2 * (w7 * w186 + w2 * w187) + w34 * w70)
    w189 = w68 * w175
    w190 = w50 * w176
    w191 = w189 - w190
    w192 = 2 * (w2 * w186 - w7 * w187) - w34 * w71 - w35 * w70
    w193 = w73 * w175 - w76 * w176
    w194 = 2 * (w2 * w182 + w7 * w180) - w34 * w66 - w35 * w65
    w195 = w52 * w94 - w97 * w102 - w105 * w106 + w165 - (w174 * c8 + w178 * w183 + w185 * w188 + w191 * w192 + w193 * w194)
    w196 = w103 - w115
    w197 = w96 - w95
    w198 = w146 * w163 / w164
    w199 = w40 * w166 - w46 * w170
    w200 = w40 * w168 - w46 * w172
    w201 = w13 * w171 + w15 * w173 - (w168 * w199 + w166 * w200) - w34 * w155 - w35 * w154
    w202 = w52 * c13
    w203 = w76 * w202
    w204 = w68 * w176 - w203
    w205 = w50 * w202
    w206 = w177 - w205
    w207 = w48 * w176 - w68 * w202
    w208 = w190 - w73 * w202
    w209 = w94 * w142 - w102 * w196 - w106 * w197 + w198 - (w201 * c8 + w183 * w204 + w188 * w206 + w192 * w207 + w194 * w208)
    w210 = w141 - w140
    w211 = w49 + w51
    w212 = w118 * w163 / w164
    w213 = w172 * w199 + w170 * w200 - (w13 * w167 + w15 * w169) - w34 * w138 - w35 * w137
    w214 = w88 * w202 - w189
    w215 = w98 * w202 - w88 * w175
    w216 = w205 - w48 * w175
    w217 = w203 - w184
    w218 = w94 * w116 - w102 * w210 - w106 * w211 + w212 - (w213 * c8 + w183 * w214 + w188 * w215 + w192 * w216 + w194 * w217)
    w219 = w86 * c15
    w220 = w79 * c15
    w221 = w92 * c14
    w222 = w89 * c14
    w223 = w89 * w219 + w92 * w220 - (w79 * w221 + w86 * w222)
    w224 = w101 * c17
    w225 = w99 * c17
    w226 = w79 * w224 + w86 * w225 - (w99 * w219 + w101 * w220)
    w227 = w99 * w221 + w101 * w222 - (w89 * w224 + w92 * w225)
    w228 = w76 * w111
    w229 = w50 * w143
    w230 = w228 - w229
    w231 = w50 * w117
    w232 = w231 - w73 * w111
    w233 = w73 * w143 - w76 * w117
    w234 = w88 * c16
    w235 = w48 * c18
    w236 = w50 * c19
    w237 = left_rod_e1 * left_rod_e2 * c25 + w68 * w236
    w238 = w68 * w235 + left_rod_e0 * left_rod_e2 * c22
    w239 = w98 * w234 + left_rod_e1 * left_rod_e0 * c21
    w240 = w88 * w234 + w48 * w235 + w50 * w236
    w241 = w88 * w223 + w48 * w226 + w50 * w227 + (w212 * w230 + w198 * w232 + w165 * w233) - (w213 * w217 + w201 * w208 + w174 * w193 + w183 * w237 + w188 * w238 + w192 * w239 + w194 * w240)
    w242 = w50 * w111
    w243 = w242 - w48 * w143
    w244 = w48 * w117 - w68 * w111
    w245 = w68 * w143
    w246 = w245 - w231
    w247 = w50 * c18
    w248 = w76 * c19
    w249 = w88 * w247 + left_rod_e1 * left_rod_e3 * c26
    w250 = left_rod_e3 * left_rod_e0 * c23 + w73 * w248
    w251 = w98 * (w98 * c16) + w50 * w247 + w76 * w248
    w252 = w98 * w223 + w50 * w226 + w76 * w227 + (w212 * w243 + w198 * w244 + w165 * w246) - (w213 * w216 + w201 * w207 + w174 * w191 + w183 * w249 + w188 * w250 + w192 * w251 + w194 * w239)
    w253 = w98 * w111 - w88 * w143
    w254 = w88 * w117
    w255 = w254 - w242
    w256 = w229 - w98 * w117
    w257 = w50 * c16
    w258 = w76 * w257 + left_rod_e3 * left_rod_e2 * c27
    w259 = w50 * w257 + w68 * (w68 * c18) + w73 * (w73 * c19)
    w260 = w50 * w223 + w68 * w226 + w73 * w227 + (w212 * w253 + w198 * w255 + w165 * w256) - (w213 * w215 + w201 * w206 + w174 * w185 + w183 * w258 + w188 * w259 + w192 * w250 + w194 * w238)
    w261 = w88 * w111 - w245
    w262 = w68 * w117 - w228
    w263 = w76 * w143 - w254
    w264 = w76 * (w76 * c16) + w88 * (w88 * c18) + w68 * (w68 * c19)
    w265 = w76 * w223 + w88 * w226 + w68 * w227 + (w212 * w261 + w198 * w262 + w165 * w263) - (w213 * w214 + w201 * w204 + w174 * w178 + w183 * w264 + w188 * w258 + w192 * w249 + w194 * w237)
    w266 = w38 * c28 + w39 * c29
    w267 = w42 * c28 + w45 * c29
    w268 = w37 * w266 - w22 * w267
    w269 = 2 * right_rod_e1
    w270 = w269 * right_rod_e3
    w271 = 2 * right_rod_e0
    w272 = w271 * right_rod_e2
    w273 = w270 - w272
    w274 = right_swing_angle / 2.0
    w275 = ca.sin(w274)
    w276 = w275 * c44
    w277 = ca.cos(w274)
    w278 = w277 * c33 * c32 - w277 * c31 * c34
    w279 = w275 / 2.0
    w280 = w279 * c31 * c34 - w279 * c33 * c32
    w281 = w279 * c35
    w282 = w277 / 2.0
    w283 = w282 * c31
    w284 = w282 * c33
    w285 = w283 * c32 - w284 * c34
    w286 = w284 * c32 + w283 * c34
    w287 = shaft_e0 * w280 - shaft_e1 * w281 + (shaft_e2 * w285 + shaft_e3 * w286)
    w288 = w4 * w276 - w8 * w278 + w287 * right_swing_angle_dot
    w289 = 2 * right_rod_e2
    w290 = w277 * c35
    w291 = w275 * c31 * c32 - w275 * c33 * c34
    w292 = shaft_e0 * w281 + (shaft_e1 * w280 - shaft_e2 * w286 + shaft_e3 * w285)
    w293 = w8 * w290 + w4 * w291 + right_swing_angle_dot * w292
    w294 = right_rod_e3 * -2.0
    w295 = shaft_e3 * w280 - shaft_e1 * w285 - (shaft_e0 * w286 + shaft_e2 * w281)
    w296 = w8 * w276 + w4 * w278 + right_swing_angle_dot * w295
    w297 = right_rod_e1 * -2.0
    w298 = shaft_e0 * w285 - shaft_e3 * w281 - (shaft_e1 * w286 + shaft_e2 * w280)
    w299 = w4 * w290 - w8 * w291 + right_swing_angle_dot * w298
    w300 = w288 * w289 - w293 * w294 + w296 * w297 + w271 * w299
    w301 = w2 * w276 - w7 * w278
    w302 = w7 * w290 + w2 * w291
    w303 = w294 * w302
    w304 = w7 * w276 + w2 * w278
    w305 = w2 * w290 - w7 * w291
    w306 = w271 * w305
    w307 = w289 * w301 - w303 + w297 * w304 + w306
    w308 = w300 * c36
    w309 = right_rod_e2 * -2.0
    w310 = w288 * w294 - w293 * w309 + w271 * w296 + w269 * w299
    w311 = w302 * w309
    w312 = w271 * w304
    w313 = w294 * w301 - w311 + w312 + w269 * w305
    w314 = w310 * c36
    w315 = w300 * w307 * c121 + w310 * w313 * c121
    w316 = right_rod_e1 * w271
    w317 = right_rod_e3 * w289
    w318 = w316 + w317
    w319 = 2 * right_rod_e3
    w320 = w271 * w288 - w293 * w297 + w296 * w319 + w299 * w309
    w321 = w271 * w301 - w297 * w302
    w322 = w321 + w304 * w319 + w305 * w309
    w323 = w313 * c36 * w320 + w314 * w322
    w324 = 1.0 - 2 * right_rod_e1**2
    w325 = 2 * right_rod_e2**2
    w326 = w324 - w325
    w327 = w307 * c36 * w320 + w308 * w322
    w328 = w109 * c69
    w329 = w273 * c70
    w330 = slider_z + w328 - (right_rod_z + w329)
    w331 = w113 * c69
    w332 = 2 * right_rod_e3**2
    w333 = 1.0 - w325 - w332
    w334 = w333 * c70
    w335 = slider_x + w331 - (right_rod_x + w334)
    w336 = w130 * c69
    w337 = w134 * c28 + w120 * c29
    w338 = w22 * w337
    w339 = w338 - w11 * w266
    w340 = w3 * w337 - w12 * w266
    w341 = w312 + (w301 * w319 - w311) + w297 * w305
    w342 = right_rod_e3 * w271
    w343 = w269 * right_rod_e2
    w344 = w342 + w343
    w345 = w344 * c70
    w346 = w306 + (w301 * w309 - w303 + w269 * w304)
    w347 = w335 * (w125 + (w129 * w328 - w133 * w336) - (w2 * w339 - w7 * w340 + (w329 * w341 - w345 * w346)))
    w348 = slider_y + w336 - (w345 + right_rod_y)
    w349 = w11 * w267 - w37 * w337
    w350 = w12 * w267 - w338
    w351 = w321 + w294 * w304 + w289 * w305
    w352 = w348 * (w150 + (w133 * w331 - w153 * w328) - (w2 * w349 - w7 * w350 + (w334 * w346 - w329 * w351)))
    w353 = w22 * w266 - w3 * w267
    w354 = w330 * (w160 + (w153 * w336 - w129 * w331) - (w2 * w268 - w7 * w353 + (w345 * w351 - w334 * w341)))
    w355 = (w347 + w352 + w354) * c72
    w356 = w335**2 + w348**2 + w330**2
    w357 = w330 * w355 / w356
    w358 = w15 * w267 - w166 * w337
    w359 = w13 * w267 - w168 * w337
    w360 = w170 * w337 - w15 * w266
    w361 = w172 * w337 - w13 * w266
    w362 = w168 * w358 + w166 * w359 - (w172 * w360 + w170 * w361) - w34 * w353 - w35 * w268
    w363 = w344 * c36
    w364 = w333 * c36
    w365 = w309 * w364
    w366 = w297 * w363 - w365
    w367 = w282 * right_swing_angle_dot
    w368 = w367 * c31 * c32 - w367 * c33 * c34
    w369 = w279 * right_swing_angle_dot
    w370 = w369 * c35
    w371 = w35 * w291 - (2 * (w2 * w368 - w7 * w370) + w34 * w290)
    w372 = w271 * w363
    w373 = w372 - w319 * w364
    w374 = w367 * c44
    w375 = w369 * c31 * c34 - w369 * c33 * c32
    w376 = 2 * (w2 * w374 - w7 * w375) - w34 * w278 - w35 * w276
    w377 = w294 * w363
    w378 = w271 * w364
    w379 = w377 - w378
    w380 = 2 * (w2 * w375 + w7 * w374) + w34 * w276 - w35 * w278
    w381 = w289 * w363 - w297 * w364
    w382 = 2 * (w7 * w368 + w2 * w370) + w34 * w291 + w35 * w290
    w383 = w273 * w315 - w318 * w323 - w326 * w327 + w357 - (w362 * c30 + w366 * w371 + w373 * w376 + w379 * w380 - w381 * w382)
    w384 = w36 + w47 * w195 + w154 * w209 + w137 * w218 + w65 * w241 + w70 * w252 - w71 * w260 - w66 * w265 + w268 * w383
    w385 = w324 - w332
    w386 = w317 - w316
    w387 = w348 * w355 / w356
    w388 = w166 * w266 - w170 * w267
    w389 = w168 * w266 - w172 * w267
    w390 = w13 * w360 + w15 * w361 - (w168 * w388 + w166 * w389) - w34 * w350 - w35 * w349
    w391 = w273 * c36
    w392 = w297 * w391
    w393 = w294 * w364 - w392
    w394 = w271 * w391
    w395 = w365 - w394
    w396 = w269 * w364 - w294 * w391
    w397 = w378 - w289 * w391
    w398 = w315 * w344 - w323 * w385 - w327 * w386 + w387 - (w390 * c30 + w371 * w393 + w376 * w395 + w380 * w396 - w382 * w397)
    w399 = w343 - w342
    w400 = w270 + w272
    w401 = w335 * w355 / w356
    w402 = w172 * w388 + w170 * w389 - (w13 * w358 + w15 * w359) - w34 * w340 - w35 * w339
    w403 = w309 * w391 - w377
    w404 = w319 * w391 - w309 * w363
    w405 = w394 - w269 * w363
    w406 = w392 - w372
    w407 = w315 * w333 - w323 * w399 - w327 * w400 + w401 - (w402 * c30 + w371 * w403 + w376 * w404 + w380 * w405 - w382 * w406)
    w408 = w307 * c38
    w409 = w300 * c38
    w410 = w313 * c37
    w411 = w310 * c37
    w412 = w310 * w408 + w313 * w409 - (w300 * w410 + w307 * w411)
    w413 = w322 * c40
    w414 = w320 * c40
    w415 = w300 * w413 + w307 * w414 - (w320 * w408 + w322 * w409)
    w416 = w320 * w410 + w322 * w411 - (w310 * w413 + w313 * w414)
    w417 = w297 * w329
    w418 = w271 * w345
    w419 = w417 - w418
    w420 = w271 * w334
    w421 = w420 - w289 * w329
    w422 = w289 * w345 - w297 * w334
    w423 = w309 * c39
    w424 = w269 * c41
    w425 = w271 * c42
    w426 = right_rod_e1 * right_rod_e2 * c47 + w294 * w425
    w427 = w294 * w424 + right_rod_e0 * right_rod_e2 * c45
    w428 = w319 * w423 + right_rod_e1 * right_rod_e0 * c43
    w429 = w309 * w423 + w269 * w424 + w271 * w425
    w430 = w309 * w412 + w269 * w415 + w271 * w416 + (w401 * w419 + w387 * w421 + w357 * w422) - (w402 * w406 + w390 * w397 + w362 * w381 + w371 * w426 + w376 * w427 + w380 * w428 - w382 * w429)
    w431 = w271 * w329
    w432 = w431 - w269 * w345
    w433 = w269 * w334 - w294 * w329
    w434 = w294 * w345
    w435 = w434 - w420
    w436 = w271 * c41
    w437 = w297 * c42
    w438 = w309 * w436 + right_rod_e1 * right_rod_e3 * c48
    w439 = right_rod_e3 * right_rod_e0 * c46 + w289 * w437
    w440 = w319 * (w319 * c39) + w271 * w436 + w297 * w437
    w441 = w319 * w412 + w271 * w415 + w297 * w416 + (w401 * w432 + w387 * w433 + w357 * w435) - (w402 * w405 + w390 * w396 + w362 * w379 + w371 * w438 + w376 * w439 + w380 * w440 - w382 * w428)
    w442 = w319 * w329 - w309 * w345
    w443 = w309 * w334
    w444 = w443 - w431
    w445 = w418 - w319 * w334
    w446 = w271 * c39
    w447 = w297 * w446 + right_rod_e3 * right_rod_e2 * c49
    w448 = w271 * w446 + w294 * (w294 * c41) + w289 * (w289 * c42)
    w449 = w271 * w412 + w294 * w415 + w289 * w416 + (w401 * w442 + w387 * w444 + w357 * w445) - (w402 * w404 + w390 * w395 + w362 * w373 + w371 * w447 + w376 * w448 + w380 * w439 - w382 * w427)
    w450 = w309 * w329 - w434
    w451 = w294 * w334 - w417
    w452 = w297 * w345 - w443
    w453 = w297 * (w297 * c39) + w309 * (w309 * c41) + w294 * (w294 * c42)
    w454 = w297 * w412 + w309 * w415 + w294 * w416 + (w401 * w450 + w387 * w451 + w357 * w452) - (w402 * w403 + w390 * w393 + w362 * w366 + w371 * w453 + w376 * w447 + w380 * w438 - w382 * w426)
    w455 = w15 * w45 - w120 * w166
    w456 = w13 * w45 - w120 * w168
    w457 = w120 * w170 - w15 * w39
    w458 = w120 * w172 - w13 * w39
    w459 = 2 * height_travel_dot
    w460 = w39 * w168 - w45 * w172
    w461 = height_travel * (w168 * w455 + w166 * w456 - (w172 * w457 + w170 * w458)) + w459 * w460 + w34 * w158
    w462 = w165 + w357 + (w461 + w35 * w159) * c50
    w463 = w384 + w349 * w398 + w339 * w407 + w290 * w430 + w278 * w441 + w276 * w449 - w291 * w454 + w159 * w462
    w464 = w39 * w166 - w45 * w170
    w465 = height_travel * (w13 * w457 + w15 * w458 - (w168 * w464 + w166 * w460)) + w456 * w459 + w34 * w148
    w466 = w198 + w387 + (w465 + w35 * w149) * c50
    w467 = height_travel * (w172 * w464 + w170 * w460 - (w13 * w455 + w15 * w456)) + w458 * w459 + w34 * w122
    w468 = w212 + w401 + (w467 + w35 * w124) * c50
    w469 = w4 * w107 - w8 * w127
    w470 = w133 * c52
    w471 = w4 * w108 - w8 * w132
    w472 = w471 * c52
    w473 = w2 * w107 - w128
    w474 = w473 * c51
    w475 = w469 * c51
    w476 = w469 * w470 + w472 * w473 - (w471 * w474 + w133 * w475)
    w477 = w2 * w127 - w152
    w478 = w477 * c54
    w479 = w4 * w127 - w8 * w126
    w480 = w479 * c54
    w481 = w471 * w478 + w133 * w480 - (w470 * w479 + w472 * w477)
    w482 = w474 * w479 + w475 * w477 - (w469 * w478 + w473 * w480)
    w483 = w126 * w328
    w484 = w483 - w108 * w336
    w485 = w108 * w331 - w151 * w328
    w486 = w151 * w336 - w126 * w331
    w487 = w110 * w126
    w488 = w487 - w108 * w131
    w489 = w108 * w114 - w110 * w151
    w490 = w131 * w151 - w114 * w126
    w491 = w127 * w476 + w107 * w481 + w108 * w482 - (w401 * w484 + w387 * w485 + w357 * w486 + (w212 * w488 + w198 * w489 + w165 * w490))
    w492 = w108 * c56
    w493 = slider_e1 * slider_e2 * c58 + w132 * w492
    w494 = w463 + w149 * w466 + w124 * w468 + (w491 + (w34 * w493 + w35 * (w127 * (w127 * c53) + w107 * (w107 * c55) + w108 * w492)))
    w495 = w21 * w22 + w3 * w29 + w12 * w30 + (w34 * (w22 * (w22 * c2) + w3 * (w3 * c4) + w12 * (w12 * c5)) + w32 * w35)
    w496 = w495 + w161 * w195 + w155 * w209 + w138 * w218 + w66 * w241 + w71 * w252 + w70 * w260 + w65 * w265
    w497 = w496 + w353 * w383 + w350 * w398 + w340 * w407 + w291 * w430 - w276 * w441 + w278 * w449 + w290 * w454
    w498 = w127 * w328 - w132 * w336
    w499 = w132 * w331 - w483
    w500 = w126 * w336 - w127 * w331
    w501 = w110 * w127 - w131 * w132
    w502 = w114 * w132 - w487
    w503 = w126 * w131 - w114 * w127
    w504 = w126 * w476 + w127 * w481 + w132 * w482 - (w401 * w498 + w387 * w499 + w357 * w500 + (w212 * w501 + w198 * w502 + w165 * w503))
    w505 = w497 + w158 * w462 + w148 * w466 + w122 * w468 + (w504 + (w34 * (w126 * (w126 * c53) + w127 * (w127 * c55) + w132 * (w132 * c56)) + w35 * w493))
    w506 = (w45 * w118 + w39 * w146 + w112 * w120) * c66
    w507 = w112 * w506 / w164
    w508 = w146 * w506 / w164
    w509 = w118 * w506 / w164
    w510 = w230 * w509 + w232 * w508 + w233 * w507
    w511 = w243 * w509 + w244 * w508 + w246 * w507
    w512 = w253 * w509 + w255 * w508 + w256 * w507
    w513 = w261 * w509 + w262 * w508 + w263 * w507
    w514 = (w45 * w335 + w39 * w348 + w120 * w330) * c72
    w515 = w330 * w514 / w356
    w516 = w47 * w507 + w154 * w508 + w137 * w509 + w65 * w510 + w70 * w511 - w71 * w512 - w66 * w513 + w268 * w515
    w517 = w348 * w514 / w356
    w518 = w335 * w514 / w356
    w519 = w419 * w518 + w421 * w517 + w422 * w515
    w520 = w432 * w518 + w433 * w517 + w435 * w515
    w521 = w442 * w518 + w444 * w517 + w445 * w515
    w522 = w450 * w518 + w451 * w517 + w452 * w515
    w523 = w507 + w515 + 2 * w464 * c50
    w524 = w516 + w349 * w517 + w339 * w518 + w290 * w519 + w278 * w520 + w276 * w521 - w291 * w522 + w159 * w523
    w525 = w508 + w517 + 2 * w455 * c50
    w526 = w509 + w518 + 2 * w457 * c50
    w527 = w524 + w149 * w525 + w124 * w526 - (w484 * w518 + w485 * w517 + w486 * w515 + (w488 * w509 + w489 * w508 + w490 * w507))
    w528 = w161 * w507 + w155 * w508 + w138 * w509 + w66 * w510 + w71 * w511 + w70 * w512 + w65 * w513 + w353 * w515
    w529 = w528 + w350 * w517 + w340 * w518 + w291 * w519 - w276 * w520 + w278 * w521 + w290 * w522 + w158 * w523
    w530 = w529 + w148 * w525 + w122 * w526 - (w498 * w518 + w499 * w517 + w500 * w515 + (w501 * w509 + w502 * w508 + w503 * w507))
    w531 = w292 * w294
    w532 = w271 * w298
    w533 = w287 * w289 - w531 + w295 * w297 + w532
    w534 = w292 * w309
    w535 = w271 * w295
    w536 = w287 * w294 - w534 + w535 + w269 * w298
    w537 = w300 * w533 * c121 + w310 * w536 * c121
    w538 = w271 * w287 - w292 * w297
    w539 = w538 + w295 * w319 + w298 * w309
    w540 = w320 * (w536 * c36) + w314 * w539
    w541 = w320 * (w533 * c36) + w308 * w539
    w542 = w535 + (w287 * w319 - w534) + w297 * w298
    w543 = w532 + (w287 * w309 - w531 + w269 * w295)
    w544 = w538 + w294 * w295 + w289 * w298
    w545 = w335 * (w329 * w542 - w345 * w543) + w348 * (w334 * w543 - w329 * w544) + w330 * (w345 * w544 - w334 * w542)
    w546 = w545 * c72
    w547 = w330 * w546 / w356
    w548 = right_swing_angle_dot * 0.5
    w549 = w277 * w548
    w550 = w549 * c31 * c34 - w549 * c33 * c32
    w551 = w277 * right_swing_angle_dot * c113
    w552 = w275 * w548
    w553 = w552 * c33 * c34 - w552 * c31 * c32
    w554 = w275 * right_swing_angle_dot * c112
    w555 = w4 * w286 - w8 * w280
    w556 = w555 + (shaft_e0 * w550 - shaft_e1 * w551 + (shaft_e2 * w553 - shaft_e3 * w554) + w555)
    w557 = w4 * w285 - w8 * w281
    w558 = w557 + (shaft_e0 * w551 + (shaft_e1 * w550 + shaft_e2 * w554 + shaft_e3 * w553) + w557)
    w559 = w4 * w280 + w8 * w286
    w560 = w559 + (shaft_e0 * w554 - shaft_e2 * w551 + (shaft_e3 * w550 - shaft_e1 * w553) + w559)
    w561 = w8 * w285 + w4 * w281
    w562 = shaft_e0 * w553 - shaft_e3 * w551 + (shaft_e1 * w554 - shaft_e2 * w550) - w561 - w561
    w563 = w273 * w537 - w318 * w540 - w326 * w541 - w547 - (w373 * w556 - w366 * w558 + w379 * w560 + w381 * w562)
    w564 = w348 * w546 / w356
    w565 = w344 * w537 - w385 * w540 - w386 * w541 - w564 - (w395 * w556 - w393 * w558 + w396 * w560 + w397 * w562)
    w566 = w335 * w546 / w356
    w567 = w333 * w537 - w399 * w540 - w400 * w541 - w566 - (w404 * w556 - w403 * w558 + w405 * w560 + w406 * w562)
    w568 = w533 * c38
    w569 = w536 * c37
    w570 = w310 * w568 + w409 * w536 - (w300 * w569 + w411 * w533)
    w571 = w539 * c40
    w572 = w300 * w571 + w414 * w533 - (w320 * w568 + w409 * w539)
    w573 = w320 * w569 + w411 * w539 - (w310 * w571 + w414 * w536)
    w574 = w309 * w570 + w269 * w572 + w271 * w573 - (w419 * w566 + w421 * w564 + w422 * w547) - (w427 * w556 - w426 * w558 + w428 * w560 + w429 * w562)
    w575 = w319 * w570 + w271 * w572 + w297 * w573 - (w432 * w566 + w433 * w564 + w435 * w547) - (w439 * w556 - w438 * w558 + w440 * w560 + w428 * w562)
    w576 = w271 * w570 + w294 * w572 + w289 * w573 - (w442 * w566 + w444 * w564 + w445 * w547) - (w448 * w556 - w447 * w558 + w439 * w560 + w427 * w562)
    w577 = w297 * w570 + w309 * w572 + w294 * w573 - (w450 * w566 + w451 * w564 + w452 * w547) - (w447 * w556 - w453 * w558 + w438 * w560 + w426 * w562)
    w578 = w268 * w563 + w349 * w565 + w339 * w567 + w290 * w574 + w278 * w575 + w276 * w576 - w291 * w577 - w159 * w547
    w579 = w353 * w563 + w350 * w565 + w340 * w567 + w291 * w574 - w276 * w575 + w278 * w576 + w290 * w577 - w158 * w547
    w580 = w2 * (w578 - w149 * w564 - w124 * w566 + (w484 * w566 + w485 * w564 + w486 * w547)) - w7 * (w579 - w148 * w564 - w122 * w566 + (w498 * w566 + w499 * w564 + w500 * w547))
    w581 = w64 * w68
    w582 = w50 * w77
    w583 = w581 + w69 * w73 + w74 * w76 + w582
    w584 = w64 * w88
    w585 = w50 * w74
    w586 = w584 + w68 * w69 + w585 + w48 * w77
    w587 = w79 * w583 * c120 + w89 * w586 * c120
    w588 = w64 * w76 + w50 * w69
    w589 = w588 + w74 * w98 + w77 * w88
    w590 = w99 * (w586 * c13) + w93 * w589
    w591 = w99 * (w583 * c13) + w87 * w589
    w592 = w585 + (w584 + w69 * w98) + w76 * w77
    w593 = w582 + (w581 + w69 * w88 + w48 * w74)
    w594 = w588 + w68 * w74 + w73 * w77
    w595 = w118 * (w111 * w592 - w143 * w593) + w146 * (w117 * w593 - w111 * w594) + w112 * (w143 * w594 - w117 * w592)
    w596 = w595 * c66
    w597 = w112 * w596 / w164
    w598 = left_swing_angle_dot * 0.5
    w599 = w60 * w598
    w600 = w599 * c11 * c12 - w599 * c9 * c10
    w601 = w54 * w598
    w602 = w601 * c11 * c10 - w601 * c9 * c12
    w603 = w60 * left_swing_angle_dot * c116
    w604 = w54 * left_swing_angle_dot * c117
    w605 = w4 * w63 - w8 * w58
    w606 = w605 + (shaft_e0 * w600 - (shaft_e2 * w602 - shaft_e1 * w603 - shaft_e3 * w604) + w605)
    w607 = w8 * w59 + w4 * w62
    w608 = shaft_e1 * w600 - shaft_e0 * w603 - (shaft_e2 * w604 + shaft_e3 * w602) - w607 - w607
    w609 = w4 * w59 - w8 * w62
    w610 = w609 + (shaft_e0 * w602 + shaft_e2 * w600 + (shaft_e1 * w604 - shaft_e3 * w603) + w609)
    w611 = w4 * w58 + w8 * w63
    w612 = w611 + (shaft_e3 * w600 - shaft_e0 * w604 + (shaft_e1 * w602 + shaft_e2 * w603) + w611)
    w613 = w52 * w587 - w97 * w590 - w105 * w591 - w597 - (w178 * w606 + w185 * w608 + w191 * w610 + w193 * w612)
    w614 = w146 * w596 / w164
    w615 = w142 * w587 - w196 * w590 - w197 * w591 - w614 - (w204 * w606 + w206 * w608 + w207 * w610 + w208 * w612)
    w616 = w118 * w596 / w164
    w617 = w116 * w587 - w210 * w590 - w211 * w591 - w616 - (w214 * w606 + w215 * w608 + w216 * w610 + w217 * w612)
    w618 = w583 * c15
    w619 = w586 * c14
    w620 = w89 * w618 + w220 * w586 - (w79 * w619 + w222 * w583)
    w621 = w589 * c17
    w622 = w79 * w621 + w225 * w583 - (w99 * w618 + w220 * w589)
    w623 = w99 * w619 + w222 * w589 - (w89 * w621 + w225 * w586)
    w624 = w88 * w620 + w48 * w622 + w50 * w623 - (w230 * w616 + w232 * w614 + w233 * w597) - (w237 * w606 + w238 * w608 + w239 * w610 + w240 * w612)
    w625 = w98 * w620 + w50 * w622 + w76 * w623 - (w243 * w616 + w244 * w614 + w246 * w597) - (w249 * w606 + w250 * w608 + w251 * w610 + w239 * w612)
    w626 = w50 * w620 + w68 * w622 + w73 * w623 - (w253 * w616 + w255 * w614 + w256 * w597) - (w258 * w606 + w259 * w608 + w250 * w610 + w238 * w612)
    w627 = w76 * w620 + w88 * w622 + w68 * w623 - (w261 * w616 + w262 * w614 + w263 * w597) - (w264 * w606 + w258 * w608 + w249 * w610 + w237 * w612)
    w628 = w47 * w613 + w154 * w615 + w137 * w617 + w65 * w624 + w70 * w625 - w71 * w626 - w66 * w627 - w159 * w597
    w629 = w161 * w613 + w155 * w615 + w138 * w617 + w66 * w624 + w71 * w625 + w70 * w626 + w65 * w627 - w158 * w597
    w630 = w2 * (w628 - w149 * w614 - w124 * w616 + (w488 * w616 + w489 * w614 + w490 * w597)) - w7 * (w629 - w148 * w614 - w122 * w616 + (w501 * w616 + w502 * w614 + w503 * w597))
    dQ_hat_dq_i_dot = ca.vertcat(
        w2 * w494 - w7 * w505,
        -(w120 * w462 + w39 * w466 + w45 * w468),
        w298 * w430 + w295 * w441 + w287 * w449 - w292 * w454,
        w77 * w241 + w74 * w252 + w69 * w260 + w64 * w265,
        w2 * w527 - w7 * w530,
        -(w120 * w523 + w39 * w525 + w45 * w526),
        w298 * w519 + w295 * w520 + w287 * w521 - w292 * w522,
        w77 * w510 + w74 * w511 + w69 * w512 + w64 * w513,
        w580,
        w120 * w547 + w39 * w564 + w45 * w566,
        w298 * w574 + w295 * w575 + w287 * w576 - w292 * w577,
        0.0,
        w630,
        w120 * w597 + w39 * w614 + w45 * w616,
        0.0,
        w77 * w624 + w74 * w625 + w69 * w626 + w64 * w627,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 4, 4)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 3718 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    slider_e0 = q_d[10]
    slider_e1 = q_d[11]
    slider_e2 = q_d[12]
    slider_e3 = q_d[13]
    right_rod_e0 = q_d[17]
    right_rod_e1 = q_d[18]
    right_rod_e2 = q_d[19]
    right_rod_e3 = q_d[20]
    left_rod_e0 = q_d[24]
    left_rod_e1 = q_d[25]
    left_rod_e2 = q_d[26]
    left_rod_e3 = q_d[27]
    spin_angle_ddot = q_i_ddot[0]
    height_travel_ddot = q_i_ddot[1]
    right_swing_angle_ddot = q_i_ddot[2]
    left_swing_angle_ddot = q_i_ddot[3]
    c2 = c[2]
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
    c16 = c[16]
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
    c39 = c[39]
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
    c53 = c[53]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c98 = c[98]
    c99 = c[99]
    c100 = c[100]
    c101 = c[101]
    c102 = c[102]
    c103 = c[103]
    c104 = c[104]
    c105 = c[105]
    c108 = c[108]
    c110 = c[110]
    c112 = c[112]
    c113 = c[113]
    c114 = c[114]
    c115 = c[115]
    c116 = c[116]
    c117 = c[117]
    c118 = c[118]
    c119 = c[119]
    c122 = c[122]
    c123 = c[123]
    c124 = c[124]
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = left_swing_angle / 2.0
    w4 = ca.cos(w3)
    w5 = w4 * c9 * c12 - w4 * c11 * c10
    w6 = 2 * left_rod_e3
    w7 = 2 * left_rod_e1
    w8 = 2 * left_rod_e0
    w9 = (left_rod_e3 * w7 - w8 * left_rod_e2) * c13
    w10 = left_rod_e2 * -2.0
    w11 = (left_rod_e3 * w8 + w7 * left_rod_e2) * c13
    w12 = w6 * w9 - w10 * w11
    w13 = shaft_e1 * -2.0
    w14 = 2 * shaft_e1
    w15 = w14 * shaft_e3
    w16 = 2 * shaft_e0
    w17 = w16 * shaft_e2
    w18 = w15 - w17
    w19 = 2 * shaft_e2**2
    w20 = 1.0 - 2 * shaft_e1**2 - w19
    w21 = w18 * c6 + w20 * c7
    w22 = w13 * w21
    w23 = shaft_e3 * w16 + w14 * shaft_e2
    w24 = 2 * shaft_e2
    w25 = shaft_e3 * w24 - shaft_e1 * w16
    w26 = w23 * c6 + w25 * c7
    w27 = w22 - w16 * w26
    w28 = ca.sin(w0)
    w29 = w28 * 0.25
    w30 = spin_angle_ddot * w29
    w31 = shaft_e2 * -2.0
    w32 = shaft_e3 * -2.0
    w33 = w21 * w31 - w26 * w32
    w34 = w1 * 0.25
    w35 = spin_angle_ddot * w34
    w36 = w27 * w30 + w33 * w35
    w37 = (1.0 - 2 * left_rod_e2**2 - 2 * left_rod_e3**2) * c13
    w38 = w10 * w37
    w39 = w8 * w9
    w40 = w38 - w39
    w41 = 1.0 - w19 - 2 * shaft_e3**2
    w42 = w15 + w17
    w43 = w41 * c6 + w42 * c7
    w44 = w16 * w43 - w21 * w24
    w45 = w32 * w43 - w22
    w46 = w30 * w44 + w35 * w45
    w47 = w8 * w11
    w48 = w47 - w6 * w37
    w49 = w24 * w26 - w13 * w43
    w50 = w13 * w26 - w31 * w43
    w51 = w30 * w49 + w35 * w50
    w52 = left_rod_e1 * -2.0
    w53 = w8 * c16
    w54 = left_rod_e3 * -2.0
    w55 = w54 * c18
    w56 = 2 * left_rod_e2
    w57 = w56 * c19
    w58 = w52 * w53 + left_rod_e3 * left_rod_e2 * c27
    w59 = ca.sin(w3)
    w60 = w59 * c9 * c10 - w59 * c11 * c12
    w61 = w4 * c24
    w62 = w35 * w60 - w30 * w61
    w63 = w8 * w53 + w54 * w55 + w56 * w57
    w64 = w59 * c20
    w65 = w35 * w64 - w5 * w30
    w66 = w6 * c16
    w67 = w8 * c18
    w68 = w52 * c19
    w69 = left_rod_e3 * left_rod_e0 * c23 + w56 * w68
    w70 = w30 * w64 + w5 * w35
    w71 = w10 * c16
    w72 = w7 * c18
    w73 = w8 * c19
    w74 = w54 * w72 + left_rod_e0 * left_rod_e2 * c22
    w75 = w30 * w60 + w35 * w61
    w76 = w12 * w36 + w40 * w46 + w48 * w51 + w58 * w62 + w63 * w65 + w69 * w70 + w74 * w75
    w77 = w16 * c5
    w78 = w31 * (w31 * c2) + w14 * (w14 * c4) + w16 * w77
    w79 = shaft_e1 * shaft_e2 * c57 + w32 * w77
    w80 = w11 * w52 - w38
    w81 = w11 * w54
    w82 = w8 * w37
    w83 = w81 - w82
    w84 = w11 * w56 - w37 * w52
    w85 = w51 * c8 + w62 * w80 + w48 * w65 + w70 * w83 + w75 * w84
    w86 = w9 * w52
    w87 = w37 * w54 - w86
    w88 = w7 * w37 - w9 * w54
    w89 = w82 - w9 * w56
    w90 = w46 * c8 + w62 * w87 + w40 * w65 + w70 * w88 + w75 * w89
    w91 = w9 * w10 - w81
    w92 = w39 - w7 * w11
    w93 = w86 - w47
    w94 = w36 * c8 + w62 * w91 + w12 * w65 + w70 * w92 + w75 * w93
    w95 = left_rod_e1 * left_rod_e2 * c25 + w54 * w73
    w96 = w6 * w71 + left_rod_e1 * left_rod_e0 * c21
    w97 = w10 * w71 + w7 * w72 + w8 * w73
    w98 = w36 * w93 + w46 * w89 + w51 * w84 + w62 * w95 + w65 * w74 + w70 * w96 + w75 * w97
    w99 = w10 * w67 + left_rod_e3 * left_rod_e1 * c26
    w100 = w6 * w66 + w8 * w67 + w52 * w68
    w101 = w36 * w92 + w46 * w88 + w51 * w83 + w62 * w99 + w65 * w69 + w70 * w100 + w75 * w96
    w102 = w52 * (w52 * c16) + w10 * (w10 * c18) + w54 * (w54 * c19)
    w103 = w36 * w91 + w46 * w87 + w51 * w80 + w62 * w102 + w58 * w65 + w70 * w99 + w75 * w95
    w104 = w5 * w76 - (w30 * w78 + w35 * w79 + w49 * w85 + w44 * w90 + w27 * w94 + w60 * w98 + w64 * w101) + w61 * w103
    w105 = w23 * c28 + w25 * c29
    w106 = w41 * c28 + w42 * c29
    w107 = w24 * w105 - w13 * w106
    w108 = right_rod_e3 * -2.0
    w109 = 2 * right_rod_e0
    w110 = 2 * right_rod_e1
    w111 = (right_rod_e3 * w109 + w110 * right_rod_e2) * c36
    w112 = w108 * w111
    w113 = (1.0 - 2 * right_rod_e2**2 - 2 * right_rod_e3**2) * c36
    w114 = w109 * w113
    w115 = w112 - w114
    w116 = right_swing_angle / 2.0
    w117 = ca.sin(w116)
    w118 = w117 * c44
    w119 = ca.cos(w116)
    w120 = w119 * c33 * c32 - w119 * c31 * c34
    w121 = w35 * w118 - w30 * w120
    w122 = w13 * w105 - w31 * w106
    w123 = w30 * w107 + w35 * w122
    w124 = right_rod_e1 * -2.0
    w125 = right_rod_e2 * -2.0
    w126 = w113 * w125
    w127 = w111 * w124 - w126
    w128 = w119 * c35
    w129 = w117 * c31 * c32 - w117 * c33 * c34
    w130 = w35 * w128 - w30 * w129
    w131 = w109 * w111
    w132 = 2 * right_rod_e3
    w133 = w131 - w113 * w132
    w134 = w30 * w118 + w35 * w120
    w135 = 2 * right_rod_e2
    w136 = w111 * w135 - w113 * w124
    w137 = w30 * w128 + w35 * w129
    w138 = w115 * w121 - (w123 * c30 + w127 * w130 + w133 * w134) - w136 * w137
    w139 = w18 * c28 + w20 * c29
    w140 = w16 * w106 - w24 * w139
    w141 = (right_rod_e3 * w110 - w109 * right_rod_e2) * c36
    w142 = w110 * w113 - w108 * w141
    w143 = w13 * w139
    w144 = w32 * w106 - w143
    w145 = w30 * w140 + w35 * w144
    w146 = w124 * w141
    w147 = w108 * w113 - w146
    w148 = w109 * w141
    w149 = w126 - w148
    w150 = w114 - w135 * w141
    w151 = w121 * w142 - (w145 * c30 + w130 * w147 + w134 * w149) - w137 * w150
    w152 = w143 - w16 * w105
    w153 = w148 - w110 * w111
    w154 = w31 * w139 - w32 * w105
    w155 = w30 * w152 + w35 * w154
    w156 = w125 * w141 - w112
    w157 = w132 * w141 - w111 * w125
    w158 = w146 - w131
    w159 = w121 * w153 - (w155 * c30 + w130 * w156 + w134 * w157) - w137 * w158
    w160 = w125 * c39
    w161 = w110 * c41
    w162 = w109 * c42
    w163 = w132 * w160 + right_rod_e0 * right_rod_e1 * c43
    w164 = right_rod_e1 * right_rod_e2 * c47 + w108 * w162
    w165 = w108 * w161 + right_rod_e0 * right_rod_e2 * c45
    w166 = w125 * w160 + w110 * w161 + w109 * w162
    w167 = w121 * w163 - (w155 * w158 + w145 * w150 + w123 * w136 + w130 * w164 + w134 * w165) - w137 * w166
    w168 = w132 * c39
    w169 = w109 * c41
    w170 = w124 * c42
    w171 = w132 * w168 + w109 * w169 + w124 * w170
    w172 = w125 * w169 + right_rod_e3 * right_rod_e1 * c48
    w173 = right_rod_e3 * right_rod_e0 * c46 + w135 * w170
    w174 = w121 * w171 - (w153 * w155 + w142 * w145 + w115 * w123 + w130 * w172 + w134 * w173) - w137 * w163
    w175 = w109 * c39
    w176 = w108 * c41
    w177 = w135 * c42
    w178 = w124 * w175 + right_rod_e3 * right_rod_e2 * c49
    w179 = w109 * w175 + w108 * w176 + w135 * w177
    w180 = w121 * w173 - (w155 * w157 + w145 * w149 + w123 * w133 + w130 * w178 + w134 * w179) - w137 * w165
    w181 = w124 * (w124 * c39) + w125 * (w125 * c41) + w108 * (w108 * c42)
    w182 = w121 * w172 - (w155 * w156 + w145 * w147 + w123 * w127 + w130 * w181 + w134 * w178) - w137 * w164
    w183 = w104 + w107 * w138 + w140 * w151 + w152 * w159 + w128 * w167 + w120 * w174 + w118 * w180 - w129 * w182
    w184 = w42 * height_travel
    w185 = w25 * height_travel
    w186 = w13 * w184 - w24 * w185
    w187 = w31 * w184 - w13 * w185
    w188 = (w35 * w187 + w30 * w186) * c50
    w189 = w20 * height_travel
    w190 = w24 * w189 - w16 * w184
    w191 = w13 * w189
    w192 = w191 - w32 * w184
    w193 = (w35 * w192 + w30 * w190) * c50
    w194 = w16 * w185 - w191
    w195 = w32 * w185 - w31 * w189
    w196 = (w35 * w195 + w30 * w194) * c50
    w197 = slider_e2 * -2.0
    w198 = 2 * slider_e1
    w199 = 2 * slider_e0
    w200 = w199 * c56
    w201 = w197 * (w197 * c53) + w198 * (w198 * c55) + w199 * w200
    w202 = slider_e1 * -2.0
    w203 = slider_e3 * -2.0
    w204 = slider_e2 * slider_e1 * c58 + w200 * w203
    w205 = w2 * spin_angle_ddot
    w206 = w28 / 2.0
    w207 = spin_angle_ddot * w206
    w208 = w49 * w205 - w50 * w207
    w209 = w4 / 2.0
    w210 = w209 * c9 * c10 - w209 * c11 * c12
    w211 = w209 * c20
    w212 = w59 / 2.0
    w213 = w212 * c11 * c10 - w212 * c9 * c12
    w214 = w212 * c24
    w215 = shaft_e0 * w210 - (shaft_e1 * w211 + shaft_e2 * w213 - shaft_e3 * w214)
    w216 = w215 * left_swing_angle_ddot - (w60 * w207 + w61 * w205)
    w217 = shaft_e0 * w211 + shaft_e1 * w210 - (shaft_e2 * w214 + shaft_e3 * w213)
    w218 = left_swing_angle_ddot * w217 - (w64 * w207 + w5 * w205)
    w219 = shaft_e0 * w213 + shaft_e2 * w210 + (shaft_e3 * w211 + shaft_e1 * w214)
    w220 = w64 * w205 - w5 * w207 + left_swing_angle_ddot * w219
    w221 = shaft_e3 * w210 - shaft_e0 * w214 + (shaft_e1 * w213 - shaft_e2 * w211)
    w222 = w60 * w205 - w61 * w207 + left_swing_angle_ddot * w221
    w223 = w208 * c8 + w80 * w216 + w48 * w218 + w83 * w220 + w84 * w222
    w224 = w44 * w205 - w45 * w207
    w225 = w224 * c8 + w87 * w216 + w40 * w218 + w88 * w220 + w89 * w222
    w226 = w27 * w205 - w33 * w207
    w227 = w226 * c8 + w91 * w216 + w12 * w218 + w92 * w220 + w93 * w222
    w228 = w93 * w226 + w89 * w224 + w84 * w208 + w95 * w216 + w74 * w218 + w96 * w220 + w97 * w222
    w229 = w92 * w226 + w88 * w224 + w83 * w208 + w99 * w216 + w69 * w218 + w100 * w220 + w96 * w222
    w230 = w12 * w226 + w40 * w224 + w48 * w208 + w58 * w216 + w63 * w218 + w69 * w220 + w74 * w222
    w231 = w78 * w205 - w79 * w207 + w49 * w223 + w44 * w225 + w27 * w227 + w60 * w228 + w64 * w229 - w5 * w230
    w232 = w91 * w226 + w87 * w224 + w80 * w208 + w102 * w216 + w58 * w218 + w99 * w220 + w95 * w222
    w233 = w107 * w205 - w122 * w207
    w234 = w117 / 2.0
    w235 = w234 * c35
    w236 = w234 * c31 * c34 - w234 * c33 * c32
    w237 = w119 / 2.0
    w238 = w237 * c44
    w239 = w237 * c31 * c32 - w237 * c33 * c34
    w240 = shaft_e0 * w235 + (shaft_e1 * w236 - shaft_e2 * w238 + shaft_e3 * w239)
    w241 = w128 * w207 + w129 * w205 + w240 * right_swing_angle_ddot
    w242 = shaft_e0 * w236 - shaft_e1 * w235 + (shaft_e2 * w239 + shaft_e3 * w238)
    w243 = w118 * w205 - w120 * w207 + right_swing_angle_ddot * w242
    w244 = shaft_e3 * w236 - shaft_e1 * w239 - (shaft_e0 * w238 + shaft_e2 * w235)
    w245 = w118 * w207 + w120 * w205 + right_swing_angle_ddot * w244
    w246 = shaft_e0 * w239 - shaft_e3 * w235 - (shaft_e1 * w238 + shaft_e2 * w236)
    w247 = w128 * w205 - w129 * w207 + right_swing_angle_ddot * w246
    w248 = w233 * c30 - w127 * w241 + w133 * w243 + w115 * w245 + w136 * w247
    w249 = w140 * w205 - w144 * w207
    w250 = w249 * c30 - w147 * w241 + w149 * w243 + w142 * w245 + w150 * w247
    w251 = w152 * w205 - w154 * w207
    w252 = w251 * c30 - w156 * w241 + w157 * w243 + w153 * w245 + w158 * w247
    w253 = w158 * w251 + w150 * w249 + w136 * w233 - w164 * w241 + w165 * w243 + w163 * w245 + w166 * w247
    w254 = w153 * w251 + w142 * w249 + w115 * w233 - w172 * w241 + w173 * w243 + w171 * w245 + w163 * w247
    w255 = w157 * w251 + w149 * w249 + w133 * w233 - w178 * w241 + w179 * w243 + w173 * w245 + w165 * w247
    w256 = w231 - w61 * w232 + w107 * w248 + w140 * w250 + w152 * w252 + w128 * w253 + w120 * w254 + w118 * w255
    w257 = w156 * w251 + w147 * w249 + w127 * w233 - w181 * w241 + w178 * w243 + w172 * w245 + w164 * w247
    w258 = (w187 * w207 - w186 * w205 + w20 * height_travel_ddot) * c50
    w259 = (w192 * w207 - w190 * w205 + w25 * height_travel_ddot) * c50
    w260 = (w195 * w207 - w194 * w205 + w42 * height_travel_ddot) * c50
    w261 = w29 * (w256 - w129 * w257 - w186 * w258 - w190 * w259 - w194 * w260 + (w201 * w205 - w204 * w207))
    w262 = w13 * (w13 * c2) + w31 * (w31 * c4) + w32 * (w32 * c5)
    w263 = w30 * w79 + w35 * w262 + w50 * w85 + w45 * w90 + w33 * w94 + w61 * w98 + w5 * w101 + w64 * w76 + w60 * w103
    w264 = w122 * w138 - w263 + w144 * w151 + w154 * w159 + w129 * w167 - w118 * w174 + w120 * w180 + w128 * w182
    w265 = w202 * (w202 * c53) + w197 * (w197 * c55) + w203 * (w203 * c56)
    w266 = w79 * w205 - w207 * w262 + w50 * w223 + w45 * w225 + w33 * w227 + w61 * w228 + w5 * w229 + w64 * w230
    w267 = w266 + w60 * w232 + w122 * w248 + w144 * w250 + w154 * w252 + w129 * w253 - w118 * w254 + w120 * w255
    w268 = w34 * (w267 + w128 * w257 - w187 * w258 - w192 * w259 - w195 * w260 + (w204 * w205 - w207 * w265))
    w269 = w2 * (w183 - w186 * w188 - w190 * w193 - w194 * w196 - (w30 * w201 + w35 * w204)) - w261 - (w206 * (w264 - w187 * w188 - w192 * w193 - w195 * w196 - (w30 * w204 + w35 * w265)) + w268)
    w270 = w2 * w118 - w120 * w206
    w271 = w128 * w206 + w2 * w129
    w272 = w118 * w206 + w2 * w120
    w273 = w2 * w128 - w129 * w206
    w274 = w2 * w152 - w154 * w206
    w275 = w2 * w140 - w144 * w206
    w276 = w2 * w107 - w122 * w206
    w277 = right_swing_angle_ddot * (w173 * w270 - w172 * w271 + w171 * w272 + w163 * w273 + w153 * w274 + w142 * w275 + w115 * w276)
    w278 = right_swing_angle_ddot * (w165 * w270 - w164 * w271 + w163 * w272 + w166 * w273 + w158 * w274 + w150 * w275 + w136 * w276)
    w279 = right_swing_angle_ddot * (w179 * w270 - w178 * w271 + w173 * w272 + w165 * w273 + w157 * w274 + w149 * w275 + w133 * w276)
    w280 = right_swing_angle_ddot * (w181 * w271 - w178 * w270 - w172 * w272 - w164 * w273 - w156 * w274 - w147 * w275 - w127 * w276)
    w281 = w2 * w64 - w5 * w206
    w282 = w60 * w206 + w2 * w61
    w283 = w64 * w206 + w2 * w5
    w284 = w2 * w60 - w61 * w206
    w285 = w2 * w27 - w33 * w206
    w286 = w2 * w44 - w45 * w206
    w287 = w2 * w49 - w50 * w206
    w288 = left_swing_angle_ddot * (w96 * w281 - (w95 * w282 + w74 * w283) + w97 * w284 + w93 * w285 + w89 * w286 + w84 * w287)
    w289 = left_swing_angle_ddot * (w100 * w281 - (w99 * w282 + w69 * w283) + w96 * w284 + w92 * w285 + w88 * w286 + w83 * w287)
    w290 = left_swing_angle_ddot * (w69 * w281 - (w58 * w282 + w63 * w283) + w74 * w284 + w12 * w285 + w40 * w286 + w48 * w287)
    w291 = left_swing_angle_ddot * (w99 * w281 - (w102 * w282 + w58 * w283) + w95 * w284 + w91 * w285 + w87 * w286 + w80 * w287)
    w292 = w236 * w277 - w235 * w278 + w238 * w279 + w239 * w280 + w210 * w288 + w211 * w289 - w213 * w290 + w214 * w291
    w293 = w157 * w270 - w156 * w271 + w153 * w272 + w158 * w273 + w274 * c30
    w294 = w2 * w252 + w205 * w293
    w295 = w206 * w252 + w207 * w293
    w296 = w149 * w270 - w147 * w271 + w142 * w272 + w150 * w273 + w275 * c30
    w297 = w206 * w250 + w207 * w296
    w298 = w2 * w250 + w205 * w296
    w299 = w92 * w281 - (w91 * w282 + w12 * w283) + w93 * w284 + w285 * c8
    w300 = w2 * w227 + w205 * w299
    w301 = w206 * w227 + w207 * w299
    w302 = w88 * w281 - (w87 * w282 + w40 * w283) + w89 * w284 + w286 * c8
    w303 = w206 * w225 + w207 * w302
    w304 = w2 * w225 + w205 * w302
    w305 = (w13 * w294 - w31 * w295 + w13 * w297 - w24 * w298) * c28 + (w13 * w300 - w31 * w301 + w13 * w303 - w24 * w304) * c6
    w306 = (w195 * w206 - w2 * w194) * c50
    w307 = (w192 * w206 - w2 * w190) * c50
    w308 = w2 * w259 + w205 * w307
    w309 = w206 * w259 + w207 * w307
    w310 = (w187 * w206 - w2 * w186) * c50
    w311 = w2 * w258 + w205 * w310
    w312 = w206 * w258 + w207 * w310
    w313 = w133 * w270 - w127 * w271 + w115 * w272 + w136 * w273 + w276 * c30
    w314 = w206 * w248 + w207 * w313
    w315 = w2 * w248 + w205 * w313
    w316 = w16 * w298 - w32 * w297 + w31 * w314 - w13 * w315
    w317 = height_travel_ddot * w306 + height_travel * (w16 * w308 - w32 * w309 - w13 * w311 + w31 * w312) + w316 * c29
    w318 = w83 * w281 - (w80 * w282 + w48 * w283) + w84 * w284 + w287 * c8
    w319 = w206 * w223 + w207 * w318
    w320 = w2 * w223 + w205 * w318
    w321 = w16 * w304 - w32 * w303 + w31 * w319 - w13 * w320
    w322 = w317 + w321 * c7
    w323 = 2 * shaft_e3
    w324 = w206 * w260 + w207 * w306
    w325 = w2 * w260 + w205 * w306
    w326 = w32 * w295 - w16 * w294 - w13 * w314 + w24 * w315
    w327 = height_travel_ddot * w307 + height_travel * (w32 * w324 - w16 * w325 + w24 * w311 - w13 * w312) + w326 * c29
    w328 = w32 * w301 - w16 * w300 - w13 * w319 + w24 * w320
    w329 = w327 + w328 * c7
    w330 = w326 * c28 + w328 * c6
    w331 = w206 * (w206 * (shaft_e3 * spin_angle_ddot)) * c98 + w185 * w324 - w184 * w309 + w105 * w295 - w106 * w297
    w332 = w205 * w206 * c122
    w333 = w292 + w14 * (w305 + w322) + w323 * (2 * -(w316 * c28 + w321 * c6)) + w24 * w329 + w16 * w330 + (w331 + w26 * w301 - w43 * w303 - w77 * w332) * -2.0
    w334 = w239 * w278 - w238 * w277 + w236 * w279 + w235 * w280 - w214 * w288 + w213 * w289 + w211 * w290 + w210 * w291
    w335 = w2 * w205
    w336 = w184 * w308 - w185 * w325 - w105 * w294 + w106 * w298 - w26 * w300 + w43 * w304 + w77 * w335 + (w16 * w335 - w32 * w332) * c5
    w337 = w334 + 2 * (shaft_e2 * (w322 - w305)) + 2 * -(shaft_e1 * w329) + 2 * (shaft_e3 * w330) + 2 * w336
    w338 = w2 * w333 - w206 * w337 - w206 * (2 * (w200 * w335 + (w199 * w335 - w203 * w332) * c56)) + w2 * ((w206 * (w206 * (spin_angle_ddot * slider_e3)) * c99 - w200 * w332) * -2.0)
    w339 = w251 * w273 + w247 * w274
    w340 = w251 * w272 + w245 * w274
    w341 = w251 * w270 + w243 * w274
    w342 = w251 * w271 + w241 * w274
    w343 = w249 * w273 + w247 * w275
    w344 = w249 * w272 + w245 * w275
    w345 = w249 * w270 + w243 * w275
    w346 = w249 * w271 + w241 * w275
    w347 = w124 * w339 + w109 * w340 + w132 * w341 - w125 * w342 - w135 * w343 - w108 * w344 - w109 * w345 + w124 * w346
    w348 = w347 * c36
    w349 = w243 * w270
    w350 = w243 * w271 + w241 * w270
    w351 = w245 * w272
    w352 = w245 * w270 + w243 * w272
    w353 = w245 * w271 + w241 * w272
    w354 = w175 * w349 + (w109 * w349 - w124 * w350) * c39 + w169 * w351 + w168 * w352 + (w109 * w351 + w108 * w352 - w125 * w353) * c41
    w355 = w247 * w273
    w356 = w247 * w272 + w245 * w273
    w357 = w247 * w270 + w243 * w273
    w358 = w247 * w271 + w241 * w273
    w359 = w354 + w162 * w355 + w161 * w356 + w160 * w357 + (w109 * w355 + w124 * w356 + w135 * w357 - w108 * w358) * c42
    w360 = w233 * w272 + w245 * w276
    w361 = w233 * w270 + w243 * w276
    w362 = 2 * -(right_rod_e2 * w348) + 2 * (w359 - w111 * w339 + w141 * w340 + w113 * w343 - w141 * w345 - w113 * w360 + w111 * w361)
    w363 = w233 * w273 + w247 * w276
    w364 = w108 * w342 - (w109 * w339 + w110 * w340 + w125 * w341) + w135 * w363 + w108 * w360 + w109 * w361
    w365 = w233 * w271 + w241 * w276
    w366 = (w364 - w124 * w365) * c36
    w367 = w362 + 2 * (right_rod_e3 * w366)
    w368 = w161 * w355 + (w110 * w355 + w109 * w356 + w108 * w357 - w125 * w358) * c41 - w111 * w340 + w113 * w344
    w369 = w271 * (right_rod_e1 * w241) * c100 - w175 * w350 + w170 * w351 + (w124 * w351 + w135 * w352 - w108 * w353) * c42
    w370 = w369 - w168 * w353 + w162 * w356 - w160 * w358 + w141 * w339 + w141 * w346 - w113 * w363 - w111 * w365
    w371 = 2 * w368 + 2 * (right_rod_e3 * w348) + 2 * (right_rod_e2 * w366) + w370 * -2.0
    w372 = w177 * w349 + (w135 * w349 - w108 * w350) * c42 + w170 * w352 + w162 * w357 - w141 * w343 + w111 * w363
    w373 = w109 * w343 + w110 * w344 + w125 * w345 - w108 * w346 - w124 * w363 - w109 * w360 - w132 * w361 + w125 * w365
    w374 = w373 * c123
    w375 = w271 * (right_rod_e2 * w241) * c101 - w176 * w350 - w169 * w353 + w160 * w355 - w161 * w358 + (w125 * w355 + w132 * w356 + w109 * w357 - w124 * w358) * c39
    w376 = 2 * w372 - w109 * w348 + w135 * w374 + (w375 - w111 * w341 - w141 * w342 + w113 * w345 + w113 * w365) * -2.0
    w377 = w376 + w110 * w366
    w378 = w271 * (right_rod_e3 * w241) * c102 + w176 * w349 - w177 * w350 + (w108 * w349 - w125 * w350) * c41
    w379 = w378 + w169 * w352 - w170 * w353 + w161 * w357 - w162 * w358 + w111 * w342 - w141 * w344 - w113 * w346
    w380 = w168 * w351 + (w132 * w351 + w109 * w352 - w124 * w353) * c39 + w160 * w356 + w141 * w341 - w113 * w361
    w381 = w110 * w348 + (w379 + w111 * w360) * -2.0 + 2 * w380 + w132 * w374 + w109 * w366
    w382 = w226 * w284 + w222 * w285
    w383 = w226 * w281 + w220 * w285
    w384 = w218 * w285 - w226 * w283
    w385 = w216 * w285 - w226 * w282
    w386 = w224 * w284 + w222 * w286
    w387 = w224 * w281 + w220 * w286
    w388 = w218 * w286 - w224 * w283
    w389 = w216 * w286 - w224 * w282
    w390 = w52 * w382 + w8 * w383 + w6 * w384 + w10 * w385 - w56 * w386 - w54 * w387 - w8 * w388 - w52 * w389
    w391 = w390 * c13
    w392 = w220 * w281
    w393 = w218 * w283
    w394 = w218 * w282 + w216 * w283
    w395 = w218 * w281 - w220 * w283
    w396 = w216 * w281 - w220 * w282
    w397 = w67 * w392 - (w53 * w393 + (w8 * w393 + w52 * w394) * c16) + w66 * w395 + (w8 * w392 + w54 * w395 + w10 * w396) * c18
    w398 = w222 * w284
    w399 = w222 * w281 + w220 * w284
    w400 = w218 * w284 - w222 * w283
    w401 = w216 * w284 - w222 * w282
    w402 = w397 + w73 * w398 + w72 * w399 + w71 * w400 + (w8 * w398 + w52 * w399 + w56 * w400 + w54 * w401) * c19
    w403 = w208 * w281 + w220 * w287
    w404 = w218 * w287 - w208 * w283
    w405 = 2 * -(left_rod_e2 * w391) + 2 * (w402 - w11 * w382 + w9 * w383 + w37 * w386 - w9 * w388 - w37 * w403 + w11 * w404)
    w406 = w208 * w284 + w222 * w287
    w407 = w216 * w287 - w208 * w282
    w408 = w56 * w406 - (w8 * w382 + w7 * w383 + w10 * w384 + w54 * w385) + w54 * w403 + w8 * w404 + w52 * w407
    w409 = w408 * c13
    w410 = w405 + 2 * (left_rod_e3 * w409)
    w411 = 2 * (w72 * w398 + (w7 * w398 + w8 * w399 + w54 * w400 + w10 * w401) * c18 - w11 * w383 + w37 * w387)
    w412 = w68 * w392 - (w282 * (left_rod_e1 * w216) * c103 + w53 * w394) + (w52 * w392 + w56 * w395 + w54 * w396) * c19
    w413 = (w412 + w66 * w396 + w73 * w399 + w71 * w401 + w9 * w382 - w9 * w389 - w37 * w406 + w11 * w407) * -2.0
    w414 = w411 + 2 * (left_rod_e3 * w391) + 2 * (left_rod_e2 * w409) + w413
    w415 = w68 * w395 - (w57 * w393 + (w56 * w393 + w54 * w394) * c19) + w73 * w400 - w9 * w386 + w11 * w406
    w416 = w8 * w386 + w7 * w387 + w10 * w388 + w54 * w389 - w52 * w406 - w8 * w403 - w6 * w404 - w10 * w407
    w417 = w416 * c124
    w418 = w67 * w396 - (w282 * (left_rod_e2 * w216) * c104 + w55 * w394) + w71 * w398 + w72 * w401 + (w10 * w398 + w6 * w399 + w8 * w400 + w52 * w401) * c16
    w419 = 2 * w415 - w8 * w391 + w56 * w417 + (w418 - w11 * w384 + w9 * w385 + w37 * w388 - w37 * w407) * -2.0
    w420 = w419 + w7 * w409
    w421 = w338 - w271 * w367 + w270 * w371 + w272 * w377 + w273 * w381 - w282 * w410 - w283 * w414 + w281 * w420
    w422 = w67 * w395 - (w282 * (left_rod_e3 * w216) * c105 + w55 * w393 + w57 * w394 + (w54 * w393 + w10 * w394) * c18)
    w423 = (w422 + w68 * w396 + w72 * w400 + w73 * w401 - w11 * w385 - w9 * w387 + w37 * w389 + w11 * w403) * -2.0
    w424 = 2 * (w66 * w392 + (w6 * w392 + w8 * w395 + w52 * w396) * c16 + w71 * w399 + w9 * w384 - w37 * w404)
    w425 = w7 * w391 + w423 + w424 + w6 * w417 + w8 * w409
    w426 = w42 * c50
    w427 = w25 * c50
    w428 = w205 * w427
    w429 = w207 * w427
    w430 = w20 * c50
    w431 = w205 * w430
    w432 = w207 * w430
    w433 = w260 + height_travel_ddot * w426 + height_travel * (w16 * w428 - w32 * w429 - w13 * w431 + w31 * w432)
    w434 = w207 * w426
    w435 = w205 * w426
    w436 = w259 + height_travel_ddot * w427 + height_travel * (w32 * w434 - w16 * w435 + w24 * w431 - w13 * w432)
    w437 = w2 * (w14 * w433 + w24 * w436 + (w185 * w434 - w184 * w429) * -2.0) - w206 * (2 * (shaft_e2 * w433) + 2 * -(shaft_e1 * w436) + 2 * (w184 * w428 - w185 * w435))
    w438 = w254 + right_swing_angle_ddot * (w173 * w242 - w172 * w240 + w171 * w244 + w163 * w246)
    w439 = w253 + right_swing_angle_ddot * (w165 * w242 - w164 * w240 + w163 * w244 + w166 * w246)
    w440 = w255 + right_swing_angle_ddot * (w179 * w242 - w178 * w240 + w173 * w244 + w165 * w246)
    w441 = right_swing_angle_ddot * (w181 * w240 - w178 * w242 - w172 * w244 - w164 * w246) - w257
    w442 = w157 * w242 - w156 * w240 + w153 * w244 + w158 * w246
    w443 = w205 * w442
    w444 = w207 * w442
    w445 = w149 * w242 - w147 * w240 + w142 * w244 + w150 * w246
    w446 = w207 * w445
    w447 = w205 * w445
    w448 = (w13 * w443 - w31 * w444 + w13 * w446 - w24 * w447) * c28
    w449 = w133 * w242 - w127 * w240 + w115 * w244 + w136 * w246
    w450 = w207 * w449
    w451 = w205 * w449
    w452 = w16 * w447 - w32 * w446 + w31 * w450 - w13 * w451
    w453 = w452 * c29
    w454 = w236 * w438 - w235 * w439 + w238 * w440 + w239 * w441 + w14 * (w448 + w453) + w323 * (w452 * c108)
    w455 = w32 * w444 - w16 * w443 - w13 * w450 + w24 * w451
    w456 = w455 * c29
    w457 = w455 * c28
    w458 = w239 * w439 - w238 * w438 + w236 * w440 + w235 * w441 + 2 * (shaft_e2 * (w453 - w448)) + 2 * -(shaft_e1 * w456)
    w459 = w2 * (w454 + w24 * w456 + w16 * w457 + (w105 * w444 - w106 * w446) * -2.0) - w206 * (w458 + 2 * (shaft_e3 * w457) + 2 * (w106 * w447 - w105 * w443))
    w460 = w246 * w251
    w461 = w244 * w251
    w462 = w242 * w251
    w463 = w240 * w251
    w464 = w246 * w249
    w465 = w244 * w249
    w466 = w242 * w249
    w467 = w240 * w249
    w468 = w124 * w460 + w109 * w461 + w132 * w462 - w125 * w463 - w135 * w464 - w108 * w465 - w109 * w466 + w124 * w467
    w469 = w468 * c36
    w470 = w242 * w243
    w471 = w240 * w243 + w241 * w242
    w472 = w244 * w245
    w473 = w242 * w245 + w243 * w244
    w474 = w240 * w245 + w241 * w244
    w475 = w175 * w470 + (w109 * w470 - w124 * w471) * c39 + w169 * w472 + w168 * w473 + (w109 * w472 + w108 * w473 - w125 * w474) * c41
    w476 = w246 * w247
    w477 = w244 * w247 + w245 * w246
    w478 = w242 * w247 + w243 * w246
    w479 = w240 * w247 + w241 * w246
    w480 = w475 + w162 * w476 + w161 * w477 + w160 * w478 + (w109 * w476 + w124 * w477 + w135 * w478 - w108 * w479) * c42
    w481 = w233 * w244
    w482 = w233 * w242
    w483 = 2 * -(right_rod_e2 * w469) + 2 * (w480 - w111 * w460 + w141 * w461 + w113 * w464 - w141 * w466 - w113 * w481 + w111 * w482)
    w484 = w233 * w246
    w485 = w108 * w463 - (w109 * w460 + w110 * w461 + w125 * w462) + w135 * w484 + w108 * w481 + w109 * w482
    w486 = w233 * w240
    w487 = (w485 - w124 * w486) * c36
    w488 = w483 + 2 * (right_rod_e3 * w487)
    w489 = w161 * w476 + (w110 * w476 + w109 * w477 + w108 * w478 - w125 * w479) * c41 - w111 * w461 + w113 * w465
    w490 = w241 * (right_rod_e1 * w240) * c100 - w175 * w471 + w170 * w472 + (w124 * w472 + w135 * w473 - w108 * w474) * c42
    w491 = w490 - w168 * w474 + w162 * w477 - w160 * w479 + w141 * w460 + w141 * w467 - w113 * w484 - w111 * w486
    w492 = 2 * w489 + 2 * (right_rod_e3 * w469) + 2 * (right_rod_e2 * w487) + w491 * -2.0
    w493 = w177 * w470 + (w135 * w470 - w108 * w471) * c42 + w170 * w473 + w162 * w478 - w141 * w464 + w111 * w484
    w494 = w109 * w464 + w110 * w465 + w125 * w466 - w108 * w467 - w124 * w484 - w109 * w481 - w132 * w482 + w125 * w486
    w495 = w494 * c123
    w496 = w241 * (right_rod_e2 * w240) * c101 - w176 * w471 - w169 * w474 + w160 * w476 - w161 * w479 + (w125 * w476 + w132 * w477 + w109 * w478 - w124 * w479) * c39
    w497 = 2 * w493 - w109 * w469 + w135 * w495 + (w496 - w111 * w462 - w141 * w463 + w113 * w466 + w113 * w486) * -2.0
    w498 = w497 + w110 * w487
    w499 = w241 * (right_rod_e3 * w240) * c102 + w176 * w470 - w177 * w471 + (w108 * w470 - w125 * w471) * c41
    w500 = w499 + w169 * w473 - w170 * w474 + w161 * w478 - w162 * w479 + w111 * w463 - w141 * w465 - w113 * w467
    w501 = w168 * w472 + (w132 * w472 + w109 * w473 - w124 * w474) * c39 + w160 * w477 + w141 * w462 - w113 * w482
    w502 = w110 * w469 + (w500 + w111 * w481) * -2.0 + 2 * w501 + w132 * w495 + w109 * w487
    w503 = w167 * w246 + w174 * w244 + w180 * w242 - w182 * w240 + (w459 - w271 * w488 + w270 * w492 + w272 * w498 + w273 * w502)
    w504 = w228 + left_swing_angle_ddot * (w95 * w215 + w74 * w217 + w96 * w219 + w97 * w221)
    w505 = w229 + left_swing_angle_ddot * (w99 * w215 + w69 * w217 + w100 * w219 + w96 * w221)
    w506 = w230 + left_swing_angle_ddot * (w58 * w215 + w63 * w217 + w69 * w219 + w74 * w221)
    w507 = w232 + left_swing_angle_ddot * (w102 * w215 + w58 * w217 + w99 * w219 + w95 * w221)
    w508 = w91 * w215 + w12 * w217 + w92 * w219 + w93 * w221
    w509 = w205 * w508
    w510 = w207 * w508
    w511 = w87 * w215 + w40 * w217 + w88 * w219 + w89 * w221
    w512 = w207 * w511
    w513 = w205 * w511
    w514 = (w13 * w509 - w31 * w510 + w13 * w512 - w24 * w513) * c6
    w515 = w80 * w215 + w48 * w217 + w83 * w219 + w84 * w221
    w516 = w207 * w515
    w517 = w205 * w515
    w518 = w16 * w513 - w32 * w512 + w31 * w516 - w13 * w517
    w519 = w518 * c7
    w520 = w210 * w504 + w211 * w505 - w213 * w506 + w214 * w507 + w14 * (w514 + w519) + w323 * (w518 * c110)
    w521 = w32 * w510 - w16 * w509 - w13 * w516 + w24 * w517
    w522 = w521 * c7
    w523 = w521 * c6
    w524 = w213 * w505 - w214 * w504 + w211 * w506 + w210 * w507 + 2 * (shaft_e2 * (w519 - w514)) + 2 * -(shaft_e1 * w522)
    w525 = w2 * (w520 + w24 * w522 + w16 * w523 + (w26 * w510 - w43 * w512) * -2.0) - w206 * (w524 + 2 * (shaft_e3 * w523) + 2 * (w43 * w513 - w26 * w509))
    w526 = w221 * w226
    w527 = w219 * w226
    w528 = w217 * w226
    w529 = w215 * w226
    w530 = w221 * w224
    w531 = w219 * w224
    w532 = w217 * w224
    w533 = w215 * w224
    w534 = w52 * w526 + w8 * w527 + w6 * w528 + w10 * w529 - w56 * w530 - w54 * w531 - w8 * w532 - w52 * w533
    w535 = w534 * c13
    w536 = w217 * w218
    w537 = w215 * w218 + w216 * w217
    w538 = w219 * w220
    w539 = w217 * w220 + w218 * w219
    w540 = w215 * w220 + w216 * w219
    w541 = w53 * w536 + (w8 * w536 + w52 * w537) * c16 + w67 * w538 + w66 * w539 + (w8 * w538 + w54 * w539 + w10 * w540) * c18
    w542 = w221 * w222
    w543 = w219 * w222 + w220 * w221
    w544 = w217 * w222 + w218 * w221
    w545 = w215 * w222 + w216 * w221
    w546 = w541 + w73 * w542 + w72 * w543 + w71 * w544 + (w8 * w542 + w52 * w543 + w56 * w544 + w54 * w545) * c19
    w547 = w208 * w219
    w548 = w208 * w217
    w549 = 2 * -(left_rod_e2 * w535) + 2 * (w546 - w11 * w526 + w9 * w527 + w37 * w530 - w9 * w532 - w37 * w547 + w11 * w548)
    w550 = w208 * w221
    w551 = w208 * w215
    w552 = w56 * w550 - (w8 * w526 + w7 * w527 + w10 * w528 + w54 * w529) + w54 * w547 + w8 * w548 + w52 * w551
    w553 = w552 * c13
    w554 = w549 + 2 * (left_rod_e3 * w553)
    w555 = 2 * (w72 * w542 + (w7 * w542 + w8 * w543 + w54 * w544 + w10 * w545) * c18 - w11 * w527 + w37 * w531)
    w556 = w216 * (left_rod_e1 * w215) * c103 + w53 * w537 + w68 * w538 + (w52 * w538 + w56 * w539 + w54 * w540) * c19
    w557 = (w556 + w66 * w540 + w73 * w543 + w71 * w545 + w9 * w526 - w9 * w533 - w37 * w550 + w11 * w551) * -2.0
    w558 = w555 + 2 * (left_rod_e3 * w535) + 2 * (left_rod_e2 * w553) + w557
    w559 = 2 * (w57 * w536 + (w56 * w536 + w54 * w537) * c19 + w68 * w539 + w73 * w544 - w9 * w530 + w11 * w550)
    w560 = w8 * w530 + w7 * w531 + w10 * w532 + w54 * w533 - w52 * w550 - w8 * w547 - w6 * w548 - w10 * w551
    w561 = w560 * c124
    w562 = w216 * (left_rod_e2 * w215) * c104 + w55 * w537 + w67 * w540 + w71 * w542 + w72 * w545 + (w10 * w542 + w6 * w543 + w8 * w544 + w52 * w545) * c16
    w563 = w559 - w8 * w535 + w56 * w561 + (w562 - w11 * w528 + w9 * w529 + w37 * w532 - w37 * w551) * -2.0 + w7 * w553
    w564 = w216 * (left_rod_e3 * w215) * c105 + w55 * w536 + w57 * w537 + (w54 * w536 + w10 * w537) * c18 + w67 * w539
    w565 = (w564 + w68 * w540 + w72 * w544 + w73 * w545 - w11 * w529 - w9 * w531 + w37 * w533 + w11 * w547) * -2.0
    w566 = 2 * (w66 * w538 + (w6 * w538 + w8 * w539 + w52 * w540) * c16 + w71 * w543 + w9 * w528 - w37 * w548)
    w567 = w7 * w535 + w565 + w566 + w6 * w561 + w8 * w553
    w568 = w525 - w282 * w554 - w283 * w558 + w281 * w563 + w284 * w567 - (w98 * w221 + w101 * w219 + w76 * w217 + w103 * w215)
    w569 = w31 * w42 - w13 * w25
    w570 = w13 * w42 - w24 * w25
    w571 = (w207 * w569 - w205 * w570) * c50
    w572 = w13 * w20
    w573 = w572 - w32 * w42
    w574 = w20 * w24 - w16 * w42
    w575 = (w207 * w573 - w205 * w574) * c50
    w576 = w25 * w32 - w20 * w31
    w577 = w16 * w25 - w572
    w578 = (w207 * w576 - w205 * w577) * c50
    w579 = w206 * (w187 * w571 + w258 * w569 + (w192 * w575 + w259 * w573) + (w195 * w578 + w260 * w576)) - w2 * (w186 * w571 + w258 * w570 + (w190 * w575 + w259 * w574) + (w194 * w578 + w260 * w577))
    w580 = w119 * 0.5
    w581 = w119 * c112
    w582 = w117 * 0.5
    w583 = w582 * c31 * c34 - w582 * c33 * c32
    w584 = w119 * 0.25
    w585 = w584 * c31 * c34 - w584 * c33 * c32
    w586 = w119 * c114
    w587 = w117 * 0.25
    w588 = w587 * c33 * c34 - w587 * c31 * c32
    w589 = w117 * c115
    w590 = shaft_e0 * w585 - shaft_e1 * w586 + (shaft_e2 * w588 - shaft_e3 * w589)
    w591 = w205 * w581 - w207 * w583 + right_swing_angle_ddot * w590
    w592 = w580 * c31 * c32 - w580 * c33 * c34
    w593 = w117 * c113
    w594 = shaft_e0 * w586 + (shaft_e1 * w585 + shaft_e2 * w589 + shaft_e3 * w588)
    w595 = w205 * w592 - w207 * w593 + right_swing_angle_ddot * w594
    w596 = shaft_e3 * w585 - shaft_e1 * w588 - (shaft_e2 * w586 - shaft_e0 * w589)
    w597 = w207 * w581 + w205 * w583 + right_swing_angle_ddot * w596
    w598 = shaft_e0 * w588 - shaft_e3 * w586 - (shaft_e2 * w585 - shaft_e1 * w589)
    w599 = right_swing_angle_ddot * w598 - (w205 * w593 + w207 * w592)
    w600 = w133 * w591 - w127 * w595 + w115 * w597 + w136 * w599
    w601 = w149 * w591 - w147 * w595 + w142 * w597 + w150 * w599
    w602 = w157 * w591 - w156 * w595 + w153 * w597 + w158 * w599
    w603 = w165 * w591 - w164 * w595 + w163 * w597 + w166 * w599
    w604 = w173 * w591 - w172 * w595 + w171 * w597 + w163 * w599
    w605 = w107 * w600 + w140 * w601 + w152 * w602 + (w128 * w603 - w253 * w593) + (w120 * w604 + w254 * w583)
    w606 = w179 * w591 - w178 * w595 + w173 * w597 + w165 * w599
    w607 = w178 * w591 - w181 * w595 + w172 * w597 + w164 * w599
    w608 = w122 * w600 + w144 * w601 + w154 * w602 + (w129 * w603 + w253 * w592) - (w118 * w604 + w254 * w581)
    w609 = w2 * (w605 + (w118 * w606 + w255 * w581) - (w129 * w607 + w257 * w592)) - w206 * (w608 + (w120 * w606 + w255 * w583) + (w128 * w607 - w257 * w593))
    w610 = w246 * w603 + w253 * w598 + (w244 * w604 + w254 * w596) + (w242 * w606 + w255 * w590) - (w240 * w607 + w257 * w594)
    w611 = w59 * 0.25
    w612 = w611 * c11 * c12 - w611 * c9 * c10
    w613 = w4 * 0.25
    w614 = w613 * c11 * c10 - w613 * c9 * c12
    w615 = w59 * c118
    w616 = w4 * c119
    w617 = shaft_e0 * w612 - (shaft_e2 * w614 - shaft_e1 * w615 - shaft_e3 * w616)
    w618 = w4 * 0.5
    w619 = w618 * c9 * c10 - w618 * c11 * c12
    w620 = w59 * 0.5
    w621 = w59 * c117
    w622 = left_swing_angle_ddot * w617 - (w207 * w619 - w205 * w621)
    w623 = shaft_e1 * w612 - shaft_e0 * w615 - (shaft_e2 * w616 + shaft_e3 * w614)
    w624 = w4 * c116
    w625 = w620 * c11 * c10 - w620 * c9 * c12
    w626 = left_swing_angle_ddot * w623 - (w207 * w624 + w205 * w625)
    w627 = shaft_e0 * w614 + shaft_e2 * w612 + (shaft_e1 * w616 - shaft_e3 * w615)
    w628 = w205 * w624 - w207 * w625 + left_swing_angle_ddot * w627
    w629 = shaft_e3 * w612 - shaft_e0 * w616 + (shaft_e1 * w614 + shaft_e2 * w615)
    w630 = w205 * w619 + w207 * w621 + left_swing_angle_ddot * w629
    w631 = w80 * w622 + w48 * w626 + w83 * w628 + w84 * w630
    w632 = w87 * w622 + w40 * w626 + w88 * w628 + w89 * w630
    w633 = w91 * w622 + w12 * w626 + w92 * w628 + w93 * w630
    w634 = w95 * w622 + w74 * w626 + w96 * w628 + w97 * w630
    w635 = w99 * w622 + w69 * w626 + w100 * w628 + w96 * w630
    w636 = w58 * w622 + w63 * w626 + w69 * w628 + w74 * w630
    w637 = w49 * w631 + w44 * w632 + w27 * w633 + (w60 * w634 + w228 * w619) + (w64 * w635 + w229 * w624) - (w5 * w636 + w230 * w625)
    w638 = w102 * w622 + w58 * w626 + w99 * w628 + w95 * w630
    w639 = w50 * w631 + w45 * w632 + w33 * w633 + (w61 * w634 - w228 * w621) + (w5 * w635 + w229 * w625) + (w64 * w636 + w230 * w624)
    w640 = w2 * (w637 - (w61 * w638 - w232 * w621)) - w206 * (w639 + (w60 * w638 + w232 * w619)) + (w215 * w410 + w217 * w414 + w219 * w420 + w221 * w425)
    w641 = w221 * w634 + w228 * w629 + (w219 * w635 + w229 * w627) + (w217 * w636 + w230 * w623) + (w215 * w638 + w232 * w617)
    dMa_dq_i = ca.vertcat(
        w269 + (w421 + w284 * w425),
        w20 * w188 + w25 * w193 + w42 * w196 + w437,
        w503,
        w568,
        w579,
        w20 * w571 + w25 * w575 + w42 * w578,
        0.0,
        0.0,
        w609 + (w242 * w371 - w240 * w367 + w244 * w377 + w246 * w381),
        0.0,
        w610 + (w242 * w492 - w240 * w488 + w244 * w498 + w246 * w502),
        0.0,
        w640,
        0.0,
        0.0,
        w641 + (w215 * w554 + w217 * w558 + w219 * w563 + w221 * w567),
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 4, 4)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 2332 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 28)
    c = ca.SX.sym("c", 125)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    slider_x = q_d[7]
    slider_y = q_d[8]
    slider_z = q_d[9]
    slider_e0 = q_d[10]
    slider_e1 = q_d[11]
    slider_e2 = q_d[12]
    slider_e3 = q_d[13]
    right_rod_x = q_d[14]
    right_rod_y = q_d[15]
    right_rod_z = q_d[16]
    right_rod_e0 = q_d[17]
    right_rod_e1 = q_d[18]
    right_rod_e2 = q_d[19]
    right_rod_e3 = q_d[20]
    left_rod_x = q_d[21]
    left_rod_y = q_d[22]
    left_rod_z = q_d[23]
    left_rod_e0 = q_d[24]
    left_rod_e1 = q_d[25]
    left_rod_e2 = q_d[26]
    left_rod_e3 = q_d[27]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_e0_dot = q_d_dot[3]
    shaft_e1_dot = q_d_dot[4]
    shaft_e2_dot = q_d_dot[5]
    shaft_e3_dot = q_d_dot[6]
    slider_x_dot = q_d_dot[7]
    slider_y_dot = q_d_dot[8]
    slider_z_dot = q_d_dot[9]
    slider_e0_dot = q_d_dot[10]
    slider_e1_dot = q_d_dot[11]
    slider_e2_dot = q_d_dot[12]
    slider_e3_dot = q_d_dot[13]
    right_rod_x_dot = q_d_dot[14]
    right_rod_y_dot = q_d_dot[15]
    right_rod_z_dot = q_d_dot[16]
    right_rod_e0_dot = q_d_dot[17]
    right_rod_e1_dot = q_d_dot[18]
    right_rod_e2_dot = q_d_dot[19]
    right_rod_e3_dot = q_d_dot[20]
    left_rod_x_dot = q_d_dot[21]
    left_rod_y_dot = q_d_dot[22]
    left_rod_z_dot = q_d_dot[23]
    left_rod_e0_dot = q_d_dot[24]
    left_rod_e1_dot = q_d_dot[25]
    left_rod_e2_dot = q_d_dot[26]
    left_rod_e3_dot = q_d_dot[27]
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
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = w1 / 2.0
    w3 = shaft_e2 * -2.0
    w4 = shaft_e3 * -2.0
    w5 = shaft_e0_dot * w4
    w6 = 2 * shaft_e2
    w7 = shaft_e1 * -2.0
    w8 = 2 * shaft_e0
    w9 = shaft_e3_dot * w8
    w10 = w5 + shaft_e1_dot * w6 + shaft_e2_dot * w7 + w9
    w11 = w10 * c1
    w12 = w3 * shaft_e0_dot
    w13 = shaft_e2_dot * w8
    w14 = 2 * shaft_e1
    w15 = w12 + w4 * shaft_e1_dot + w13 + shaft_e3_dot * w14
    w16 = w15 * c0
    w17 = w11 * w15 - w10 * w16
    w18 = shaft_e0_dot * w7 + shaft_e1_dot * w8
    w19 = 2 * shaft_e3
    w20 = w18 + shaft_e2_dot * w19 + w3 * shaft_e3_dot
    w21 = w20 * c3
    w22 = w10 * w21 - w11 * w20
    w23 = w16 * w20 - w15 * w21
    w24 = shaft_e3 * w6 - shaft_e1 * w8
    w25 = w24 * c59
    w26 = shaft_e2 * w8
    w27 = shaft_e3 * w14
    w28 = w26 + w27
    w29 = w28 * c59
    w30 = w28 * height_travel
    w31 = w24 * height_travel
    w32 = w7 * w30 - w6 * w31
    w33 = 1.0 - 2 * slider_e2**2 - 2 * slider_e3**2
    w34 = w33 * c69
    w35 = 2 * right_rod_e2**2
    w36 = 2 * right_rod_e3**2
    w37 = 1.0 - w35 - w36
    w38 = w37 * c70
    w39 = slider_x + w34 - (right_rod_x + w38)
    w40 = 2 * slider_e0
    w41 = 2 * slider_e1
    w42 = slider_e3 * w40 + slider_e2 * w41
    w43 = w42 * c69
    w44 = 2 * right_rod_e0
    w45 = right_rod_e3 * w44
    w46 = 2 * right_rod_e1
    w47 = right_rod_e2 * w46
    w48 = w45 + w47
    w49 = w48 * c70
    w50 = slider_y + w43 - (right_rod_y + w49)
    w51 = slider_e3 * w41 - slider_e2 * w40
    w52 = w51 * c69
    w53 = right_rod_e3 * w46
    w54 = right_rod_e2 * w44
    w55 = w53 - w54
    w56 = w55 * c70
    w57 = slider_z + w52 - (right_rod_z + w56)
    w58 = w39**2 + w50**2 + w57**2
    w59 = 1.0 - c68 / ca.sqrt(w58)
    w60 = slider_e2 * -2.0
    w61 = slider_e0_dot * w60
    w62 = 2 * slider_e3
    w63 = w40 * slider_e2_dot
    w64 = slider_e1 * -2.0
    w65 = w61 + slider_e1_dot * w62 + w63 + slider_e3_dot * w64
    w66 = slider_e3 * -2.0
    w67 = slider_e0_dot * w66
    w68 = w40 * slider_e3_dot
    w69 = w67 + w60 * slider_e1_dot + w41 * slider_e2_dot + w68
    w70 = right_rod_e2 * -2.0
    w71 = right_rod_e0_dot * w70
    w72 = 2 * right_rod_e3
    w73 = w44 * right_rod_e2_dot
    w74 = right_rod_e1 * -2.0
    w75 = w71 + right_rod_e1_dot * w72 + w73 + right_rod_e3_dot * w74
    w76 = right_rod_e3 * -2.0
    w77 = right_rod_e0_dot * w76
    w78 = w44 * right_rod_e3_dot
    w79 = w77 + w70 * right_rod_e1_dot + w46 * right_rod_e2_dot + w78
    w80 = slider_e0_dot * w64 + w40 * slider_e1_dot
    w81 = 2 * slider_e2
    w82 = w80 + slider_e2_dot * w66 + slider_e3_dot * w81
    w83 = right_rod_e0_dot * w74 + w44 * right_rod_e1_dot
    w84 = 2 * right_rod_e2
    w85 = w83 + right_rod_e2_dot * w76 + right_rod_e3_dot * w84
    w86 = w39 * (slider_x_dot + (w52 * w65 - w43 * w69) - (right_rod_x_dot + (w56 * w75 - w49 * w79))) + w50 * (slider_y_dot + (w34 * w69 - w52 * w82) - (right_rod_y_dot + (w38 * w79 - w56 * w85)))
    w87 = w86 + w57 * (slider_z_dot + (w43 * w82 - w34 * w65) - (right_rod_z_dot + (w49 * w85 - w38 * w75)))
    w88 = w87 * c72
    w89 = w57 * w59 * c71 + w57 * w88 / w58
    w90 = w33 * c63
    w91 = 2 * left_rod_e2**2
    w92 = 2 * left_rod_e3**2
    w93 = 1.0 - w91 - w92
    w94 = w93 * c64
    w95 = slider_x + w90 - (left_rod_x + w94)
    w96 = w42 * c63
    w97 = 2 * left_rod_e0
    w98 = left_rod_e3 * w97
    w99 = 2 * left_rod_e1
    w100 = left_rod_e2 * w99
    w101 = w98 + w100
    w102 = w101 * c64
    w103 = slider_y + w96 - (left_rod_y + w102)
    w104 = w51 * c63
    w105 = left_rod_e3 * w99
    w106 = left_rod_e2 * w97
    w107 = w105 - w106
    w108 = w107 * c64
    w109 = slider_z + w104 - (left_rod_z + w108)
    w110 = w95**2 + w103**2 + w109**2
    w111 = 1.0 - c62 / ca.sqrt(w110)
    w112 = left_rod_e2 * -2.0
    w113 = left_rod_e0_dot * w112
    w114 = 2 * left_rod_e3
    w115 = w97 * left_rod_e2_dot
    w116 = left_rod_e1 * -2.0
    w117 = w113 + left_rod_e1_dot * w114 + w115 + left_rod_e3_dot * w116
    w118 = left_rod_e3 * -2.0
    w119 = left_rod_e0_dot * w118
    w120 = w97 * left_rod_e3_dot
    w121 = w119 + w112 * left_rod_e1_dot + w99 * left_rod_e2_dot + w120
    w122 = left_rod_e0_dot * w116 + w97 * left_rod_e1_dot
    w123 = 2 * left_rod_e2
    w124 = w122 + left_rod_e2_dot * w118 + left_rod_e3_dot * w123
    w125 = w95 * (slider_x_dot + (w65 * w104 - w69 * w96) - (left_rod_x_dot + (w108 * w117 - w102 * w121))) + w103 * (slider_y_dot + (w69 * w90 - w82 * w104) - (left_rod_y_dot + (w94 * w121 - w108 * w124)))
    w126 = w125 + w109 * (slider_z_dot + (w82 * w96 - w65 * w90) - (left_rod_z_dot + (w102 * w124 - w94 * w117)))
    w127 = w126 * c66
    w128 = w109 * w111 * c65 + w109 * w127 / w110
    w129 = w18 + w4 * shaft_e2_dot + w6 * shaft_e3_dot
    w130 = w9 + (w5 + w3 * shaft_e1_dot + shaft_e2_dot * w14)
    w131 = 2 * shaft_e2**2
    w132 = 1.0 - 2 * shaft_e1**2 - w131
    w133 = w28 * w130 - w129 * w132
    w134 = w13 + (w12 + shaft_e1_dot * w19) + w7 * shaft_e3_dot
    w135 = w132 * w134 - w24 * w130
    w136 = 2 * height_travel_dot
    w137 = w24 * w129 - w28 * w134
    w138 = c73 - w89 - w128 - (height_travel * (w129 * w133 - w134 * w135) + w136 * w137) * c50
    w139 = height_travel * w132
    w140 = w6 * w139 - w8 * w30
    w141 = w50 * w59 * c71 + w50 * w88 / w58
    w142 = w103 * w111 * c65 + w103 * w127 / w110
    w143 = w141 + w142 + (height_travel * (w130 * w135 - w129 * w137) + w133 * w136) * c50
    w144 = w7 * w139
    w145 = w8 * w31 - w144
    w146 = w39 * w59 * c71 + w39 * w88 / w58
    w147 = w95 * w111 * c65 + w95 * w127 / w110
    w148 = w146 + w147 + (height_travel * (w134 * w137 - w130 * w133) + w135 * w136) * c50
    w149 = w3 * w17 + w14 * w22 + w8 * w23 + (w6 * w25 - w7 * w29) * c60 - w32 * w138 + w140 * w143 + w145 * w148
    w150 = w68 + (w67 + slider_e1_dot * w81 + slider_e2_dot * w64)
    w151 = w150 * c52
    w152 = w63 + (w61 + slider_e1_dot * w66) + w41 * slider_e3_dot
    w153 = w152 * c51
    w154 = w151 * w152 - w150 * w153
    w155 = w80 + w62 * slider_e2_dot + w60 * slider_e3_dot
    w156 = w155 * c54
    w157 = w150 * w156 - w151 * w155
    w158 = w153 * w155 - w152 * w156
    w159 = w52 * w64
    w160 = w64 * w104
    w161 = w146 * (w159 - w40 * w43) + w141 * (w34 * w40 - w52 * w81) + w89 * (w43 * w81 - w34 * w64) + (w147 * (w160 - w40 * w96) + w142 * (w40 * w90 - w81 * w104) + w128 * (w81 * w96 - w64 * w90))
    w162 = w132 * c50
    w163 = w24 * c50
    w164 = w28 * c50
    w165 = w32 * w162 + w140 * w163 + w145 * w164
    w166 = w132 * w162 + w24 * w163 + w28 * w164
    w167 = w165 / w166
    w168 = w132 * w138 - w24 * w143 - w28 * w148
    w169 = shaft_e3 * w8 + shaft_e2 * w14
    w170 = w169 * c28 + w24 * c29
    w171 = 1.0 - w131 - 2 * shaft_e3**2
    w172 = w171 * c28 + w28 * c29
    w173 = w6 * w170 - w7 * w172
    w174 = w78 + (w77 + right_rod_e1_dot * w84 + right_rod_e2_dot * w74)
    w175 = w174 * c36
    w176 = w73 + (w71 + right_rod_e1_dot * w76) + w46 * right_rod_e3_dot
    w177 = w176 * c36
    w178 = w174 * w175 + w176 * w177
    w179 = w44 * right_rod_e1
    w180 = right_rod_e3 * w84
    w181 = w83 + w72 * right_rod_e2_dot + w70 * right_rod_e3_dot
    w182 = w177 * w181
    w183 = 1.0 - 2 * right_rod_e1**2
    w184 = w175 * w181
    w185 = w27 - w26
    w186 = w185 * c28 + w132 * c29
    w187 = w130 * w172 - w129 * w186
    w188 = w134 * w186 - w130 * w170
    w189 = w129 * w187 - w134 * w188
    w190 = w55 * w178 - (w179 + w180) * w182 - (w183 - w35) * w184 + (c67 + w89) - w189 * c30
    w191 = w8 * w172 - w6 * w186
    w192 = w129 * w170 - w134 * w172
    w193 = w130 * w188 - w129 * w192
    w194 = w141 + (w48 * w178 - w182 * (w183 - w36) - w184 * (w180 - w179)) - w193 * c30
    w195 = w7 * w186
    w196 = w195 - w8 * w170
    w197 = w134 * w192 - w130 * w187
    w198 = w146 + (w37 * w178 - w182 * (w47 - w45) - w184 * (w53 + w54)) - w197 * c30
    w199 = w149 + (w60 * w154 + w41 * w157 + w40 * w158 - w161) + w167 * w168 + w173 * w190 + w191 * w194 + w196 * w198
    w200 = w48 * c36
    w201 = w37 * c36
    w202 = w84 * w200 - w74 * w201
    w203 = w44 * w201
    w204 = w55 * c36
    w205 = w203 - w84 * w204
    w206 = w74 * w204
    w207 = w44 * w200
    w208 = w206 - w207
    w209 = w173 * w202 + w191 * w205 + w196 * w208
    w210 = (right_swing_angle_dot / 2.0)**2
    w211 = right_swing_angle / 2.0
    w212 = ca.sin(w211)
    w213 = w210 * w212
    w214 = w213 * c33 * c34 - w213 * c31 * c32
    w215 = ca.cos(w211)
    w216 = w210 * w215
    w217 = w216 * c35
    w218 = w213 * c44
    w219 = w216 * c31 * c34 - w216 * c33 * c32
    w220 = w215 / 2.0
    w221 = right_swing_angle_dot * w220
    w222 = w221 * c31 * c32 - w221 * c33 * c34
    w223 = w212 / 2.0
    w224 = right_swing_angle_dot * w223
    w225 = w224 * c35
    w226 = w221 * c44
    w227 = w224 * c31 * c34 - w224 * c33 * c32
    w228 = shaft_e0_dot * w222 - shaft_e3_dot * w225 - (shaft_e1_dot * w226 + shaft_e2_dot * w227)
    w229 = w228 + (shaft_e0 * w214 - shaft_e3 * w217 + (shaft_e1 * w218 - shaft_e2 * w219) + w228)
    w230 = w215 * c35
    w231 = w174 * c38
    w232 = w176 * c37
    w233 = w176 * w231 - w174 * w232
    w234 = w181 * c40
    w235 = w174 * w234 - w181 * w231
    w236 = w181 * w232 - w176 * w234
    w237 = w56 * w74
    w238 = w44 * w49
    w239 = w38 * w44
    w240 = w70 * w233 + w46 * w235 + w44 * w236 + (w202 * c60 + (w146 * (w237 - w238) + w141 * (w239 - w56 * w84) + w89 * (w49 * w84 - w38 * w74)))
    w241 = w70 * c39
    w242 = w46 * c41
    w243 = w44 * c42
    w244 = w70 * w241 + w46 * w242 + w44 * w243
    w245 = w240 - w189 * w202 - w193 * w205 - w197 * w208 - w229 * w244
    w246 = w76 * w200
    w247 = w246 - w203
    w248 = w46 * w201 - w76 * w204
    w249 = w44 * w204
    w250 = w249 - w46 * w200
    w251 = w72 * w241 + right_rod_e0 * right_rod_e1 * c43
    w252 = w173 * w247 + w191 * w248 + w196 * w250 + w230 * w251
    w253 = shaft_e3_dot * w227 - shaft_e1_dot * w222 - (shaft_e0_dot * w226 + shaft_e2_dot * w225)
    w254 = w253 + (shaft_e0 * w218 - shaft_e2 * w217 + (shaft_e3 * w219 - shaft_e1 * w214) + w253)
    w255 = w215 * c33 * c32 - w215 * c31 * c34
    w256 = w44 * w56
    w257 = w49 * w76
    w258 = w72 * w233 + w44 * w235 + w74 * w236 + (w247 * c60 + (w146 * (w256 - w46 * w49) + w141 * (w38 * w46 - w56 * w76) + w89 * (w257 - w239)))
    w259 = w44 * c41
    w260 = w74 * c42
    w261 = w72 * (w72 * c39) + w44 * w259 + w74 * w260
    w262 = w258 - w189 * w247 - w193 * w248 - w197 * w250 - w229 * w251 - w254 * w261
    w263 = w207 - w72 * w201
    w264 = w70 * w201
    w265 = w264 - w249
    w266 = w72 * w204 - w70 * w200
    w267 = w76 * w242 + right_rod_e2 * right_rod_e0 * c45
    w268 = right_rod_e3 * right_rod_e0 * c46 + w84 * w260
    w269 = w173 * w263 + w191 * w265 + w196 * w266 + w230 * w267 + w255 * w268
    w270 = shaft_e0_dot * w227 - shaft_e1_dot * w225 + (shaft_e2_dot * w222 + shaft_e3_dot * w226)
    w271 = w270 + (shaft_e0 * w219 - shaft_e1 * w217 + (shaft_e2 * w214 - shaft_e3 * w218) + w270)
    w272 = w212 * c44
    w273 = w38 * w70
    w274 = w44 * w233 + w76 * w235 + w84 * w236 + (w263 * c60 + (w146 * (w56 * w72 - w49 * w70) + w141 * (w273 - w256) + w89 * (w238 - w38 * w72)))
    w275 = w44 * c39
    w276 = w44 * w275 + w76 * (w76 * c41) + w84 * (w84 * c42)
    w277 = w274 - w189 * w263 - w193 * w265 - w197 * w266 - w229 * w267 - w254 * w268 - w271 * w276
    w278 = w74 * w200 - w264
    w279 = w76 * w201 - w206
    w280 = w70 * w204 - w246
    w281 = right_rod_e2 * right_rod_e1 * c47 + w76 * w243
    w282 = w70 * w259 + right_rod_e3 * right_rod_e1 * c48
    w283 = w74 * w275 + right_rod_e2 * right_rod_e3 * c49
    w284 = w173 * w278 + w191 * w279 + w196 * w280 + w230 * w281 + w255 * w282 + w272 * w283
    w285 = shaft_e0_dot * w225 + (shaft_e1_dot * w227 - shaft_e2_dot * w226 + shaft_e3_dot * w222)
    w286 = w285 + (shaft_e0 * w217 + (shaft_e1 * w219 + shaft_e2 * w218 + shaft_e3 * w214) + w285)
    w287 = w199 - w209 * w229 + w230 * w245 - w252 * w254 + w255 * w262 - w269 * w271 + w272 * w277 + w284 * w286
    w288 = w212 * c31 * c32 - w212 * c33 * c34
    w289 = w74 * w233 + w70 * w235 + w76 * w236 + (w278 * c60 + (w146 * (w56 * w70 - w257) + w141 * (w38 * w76 - w237) + w89 * (w49 * w74 - w273)))
    w290 = w74 * (w74 * c39) + w70 * (w70 * c41) + w76 * (w76 * c42)
    w291 = w289 - w189 * w278 - w193 * w279 - w197 * w280 - w229 * w281 - w254 * w282 - w271 * w283 + w286 * w290
    w292 = w220 * c31 * c32 - w220 * c33 * c34
    w293 = w223 * c35
    w294 = w220 * c44
    w295 = w223 * c31 * c34 - w223 * c33 * c32
    w296 = shaft_e0 * w292 - shaft_e3 * w293 - (shaft_e1 * w294 + shaft_e2 * w295)
    w297 = w244 * w296
    w298 = w251 * w296
    w299 = shaft_e3 * w295 - shaft_e1 * w292 - (shaft_e0 * w294 + shaft_e2 * w293)
    w300 = w298 + w261 * w299
    w301 = w267 * w296 + w268 * w299
    w302 = shaft_e0 * w295 - shaft_e1 * w293 + (shaft_e2 * w292 + shaft_e3 * w294)
    w303 = w301 + w276 * w302
    w304 = w281 * w296 + w282 * w299 + w283 * w302
    w305 = shaft_e0 * w293 + (shaft_e1 * w295 - shaft_e2 * w294 + shaft_e3 * w292)
    w306 = w304 - w290 * w305
    w307 = w230 * w297 + w209 * w296 + (w255 * w300 + w252 * w299) + (w272 * w303 + w269 * w302) - (w288 * w306 + w284 * w305)
    w308 = w296 * w297 + (w299 * w300 + w298 * w299) + (w302 * w303 + w301 * w302) - (w305 * w306 + w304 * w305)
    w309 = w307 / w308
    w310 = w245 * w296 - w254 * w298 + w262 * w299 - w271 * w301 + w277 * w302 + w286 * w304 - w291 * w305
    w311 = w169 * c6 + w24 * c7
    w312 = w171 * c6 + w28 * c7
    w313 = w6 * w311 - w7 * w312
    w314 = w120 + (w119 + left_rod_e1_dot * w123 + left_rod_e2_dot * w116)
    w315 = w314 * c13
    w316 = w115 + (w113 + left_rod_e1_dot * w118) + w99 * left_rod_e3_dot
    w317 = w316 * c13
    w318 = w314 * w315 + w316 * w317
    w319 = w97 * left_rod_e1
    w320 = left_rod_e3 * w123
    w321 = w122 + w114 * left_rod_e2_dot + w112 * left_rod_e3_dot
    w322 = w317 * w321
    w323 = 1.0 - 2 * left_rod_e1**2
    w324 = w315 * w321
    w325 = w185 * c6 + w132 * c7
    w326 = w130 * w312 - w129 * w325
    w327 = w134 * w325 - w130 * w311
    w328 = w129 * w326 - w134 * w327
    w329 = w107 * w318 - (w319 + w320) * w322 - (w323 - w91) * w324 + (c61 + w128) - w328 * c8
    w330 = w8 * w312 - w6 * w325
    w331 = w129 * w311 - w134 * w312
    w332 = w130 * w327 - w129 * w331
    w333 = w142 + (w101 * w318 - w322 * (w323 - w92) - w324 * (w320 - w319)) - w332 * c8
    w334 = w7 * w325
    w335 = w334 - w8 * w311
    w336 = w134 * w331 - w130 * w326
    w337 = w147 + (w93 * w318 - w322 * (w100 - w98) - w324 * (w105 + w106)) - w336 * c8
    w338 = w101 * c13
    w339 = w93 * c13
    w340 = w123 * w338 - w116 * w339
    w341 = w97 * w339
    w342 = w107 * c13
    w343 = w341 - w123 * w342
    w344 = w116 * w342
    w345 = w97 * w338
    w346 = w344 - w345
    w347 = w313 * w340 + w330 * w343 + w335 * w346
    w348 = (left_swing_angle_dot / 2.0)**2
    w349 = left_swing_angle / 2.0
    w350 = ca.sin(w349)
    w351 = w348 * w350
    w352 = w351 * c11 * c12 - w351 * c9 * c10
    w353 = ca.cos(w349)
    w354 = w348 * w353
    w355 = w354 * c24
    w356 = w354 * c11 * c10 - w354 * c9 * c12
    w357 = w351 * c20
    w358 = w353 / 2.0
    w359 = left_swing_angle_dot * w358
    w360 = w359 * c9 * c10 - w359 * c11 * c12
    w361 = w350 / 2.0
    w362 = left_swing_angle_dot * w361
    w363 = w362 * c24
    w364 = w362 * c11 * c10 - w362 * c9 * c12
    w365 = w359 * c20
    w366 = shaft_e3_dot * w360 - shaft_e0_dot * w363 + (shaft_e1_dot * w364 - shaft_e2_dot * w365)
    w367 = w366 + (shaft_e3 * w352 - shaft_e0 * w355 + (shaft_e1 * w356 + shaft_e2 * w357) + w366)
    w368 = w350 * c9 * c10 - w350 * c11 * c12
    w369 = w314 * c15
    w370 = w316 * c14
    w371 = w316 * w369 - w314 * w370
    w372 = w321 * c17
    w373 = w314 * w372 - w321 * w369
    w374 = w321 * w370 - w316 * w372
    w375 = w108 * w116
    w376 = w97 * w102
    w377 = w94 * w97
    w378 = w340 * c60 + (w147 * (w375 - w376) + w142 * (w377 - w108 * w123) + w128 * (w102 * w123 - w94 * w116))
    w379 = w112 * c16
    w380 = w99 * c18
    w381 = w97 * c19
    w382 = w112 * w379 + w99 * w380 + w97 * w381
    w383 = w112 * w371 + w99 * w373 + w97 * w374 + w378 - w328 * w340 - w332 * w343 - w336 * w346 - w367 * w382
    w384 = w287 - w288 * w291 - w309 * w310 + w313 * w329 + w330 * w333 + w335 * w337 - w347 * w367 + w368 * w383
    w385 = w118 * w338
    w386 = w385 - w341
    w387 = w99 * w339 - w118 * w342
    w388 = w97 * w342
    w389 = w388 - w99 * w338
    w390 = w114 * w379 + left_rod_e0 * left_rod_e1 * c21
    w391 = w313 * w386 + w330 * w387 + w335 * w389 + w368 * w390
    w392 = shaft_e0_dot * w364 + shaft_e2_dot * w360 + (shaft_e3_dot * w365 + shaft_e1_dot * w363)
    w393 = w392 + (shaft_e0 * w356 + shaft_e2 * w352 + (shaft_e1 * w355 - shaft_e3 * w357) + w392)
    w394 = w350 * c20
    w395 = w97 * w108
    w396 = w102 * w118
    w397 = w386 * c60 + (w147 * (w395 - w99 * w102) + w142 * (w94 * w99 - w108 * w118) + w128 * (w396 - w377))
    w398 = w114 * w371 + w97 * w373 + w116 * w374 + w397 - w328 * w386 - w332 * w387 - w336 * w389 - w367 * w390
    w399 = w97 * c18
    w400 = w116 * c19
    w401 = w114 * (w114 * c16) + w97 * w399 + w116 * w400
    w402 = w398 - w393 * w401
    w403 = w345 - w114 * w339
    w404 = w112 * w339
    w405 = w404 - w388
    w406 = w114 * w342 - w112 * w338
    w407 = w118 * w380 + left_rod_e2 * left_rod_e0 * c22
    w408 = left_rod_e3 * left_rod_e0 * c23 + w123 * w400
    w409 = w313 * w403 + w330 * w405 + w335 * w406 + w368 * w407 + w394 * w408
    w410 = shaft_e0_dot * w365 + shaft_e1_dot * w360 - (shaft_e2_dot * w363 + shaft_e3_dot * w364)
    w411 = w410 + (shaft_e1 * w352 - shaft_e0 * w357 - (shaft_e2 * w355 + shaft_e3 * w356) + w410)
    w412 = w353 * c9 * c12 - w353 * c11 * c10
    w413 = w94 * w112
    w414 = w403 * c60 + (w147 * (w108 * w114 - w102 * w112) + w142 * (w413 - w395) + w128 * (w376 - w94 * w114))
    w415 = w97 * w371 + w118 * w373 + w123 * w374 + w414 - w328 * w403 - w332 * w405 - w336 * w406 - w367 * w407
    w416 = w97 * c16
    w417 = w97 * w416 + w118 * (w118 * c18) + w123 * (w123 * c19)
    w418 = w415 - w393 * w408 - w411 * w417
    w419 = w116 * w338 - w404
    w420 = w118 * w339 - w344
    w421 = w112 * w342 - w385
    w422 = left_rod_e2 * left_rod_e1 * c25 + w118 * w381
    w423 = w112 * w399 + left_rod_e3 * left_rod_e1 * c26
    w424 = w116 * w416 + left_rod_e2 * left_rod_e3 * c27
    w425 = w313 * w419 + w330 * w420 + w335 * w421 + w368 * w422 + w394 * w423 - w412 * w424
    w426 = shaft_e0_dot * w360 - (shaft_e1_dot * w365 + shaft_e2_dot * w364 - shaft_e3_dot * w363)
    w427 = w426 + (shaft_e0 * w352 - (shaft_e2 * w356 - shaft_e1 * w357 - shaft_e3 * w355) + w426)
    w428 = w353 * c24
    w429 = w419 * c60 + (w147 * (w108 * w112 - w396) + w142 * (w94 * w118 - w375) + w128 * (w102 * w116 - w413))
    w430 = w116 * w371 + w112 * w373 + w118 * w374 + w429 - w328 * w419 - w332 * w420 - w336 * w421 - w367 * w422
    w431 = w116 * (w116 * c16) + w112 * (w112 * c18) + w118 * (w118 * c19)
    w432 = w430 - w393 * w423 - w411 * w424 - w427 * w431
    w433 = w358 * c9 * c10 - w358 * c11 * c12
    w434 = w361 * c24
    w435 = w361 * c11 * c10 - w361 * c9 * c12
    w436 = w358 * c20
    w437 = shaft_e3 * w433 - shaft_e0 * w434 + (shaft_e1 * w435 - shaft_e2 * w436)
    w438 = w382 * w437
    w439 = w390 * w437
    w440 = shaft_e0 * w435 + shaft_e2 * w433 + (shaft_e3 * w436 + shaft_e1 * w434)
    w441 = w439 + w401 * w440
    w442 = shaft_e0 * w436 + shaft_e1 * w433 - (shaft_e2 * w434 + shaft_e3 * w435)
    w443 = w407 * w437 + w408 * w440
    w444 = w443 + w417 * w442
    w445 = shaft_e0 * w433 - (shaft_e1 * w436 + shaft_e2 * w435 - shaft_e3 * w434)
    w446 = w422 * w437 + w423 * w440 + w424 * w442
    w447 = w446 + w431 * w445
    w448 = w368 * w438 + w347 * w437 + (w394 * w441 + w391 * w440) + (w409 * w442 - w412 * w444) + (w425 * w445 - w428 * w447)
    w449 = w437 * w438 + (w440 * w441 + w439 * w440) + (w442 * w444 + w442 * w443) + (w445 * w447 + w445 * w446)
    w450 = w448 / w449
    w451 = w383 * w437 - w393 * w439 + w402 * w440 - w411 * w443 + w418 * w442 - w427 * w446 + w432 * w445
    w452 = w384 - w391 * w393 + w394 * w402 - w409 * w411 - w412 * w418 - w425 * w427 - w428 * w432 - w450 * w451
    w453 = w8 * c5
    w454 = w32 * c50
    w455 = w140 * c50
    w456 = w145 * c50
    w457 = w40 * c56
    w458 = w3 * (w3 * c2) + w14 * (w14 * c4) + w8 * w453 + w32 * w454 + w140 * w455 + w145 * w456 + (w60 * (w60 * c53) + w41 * (w41 * c55) + w40 * w457)
    w459 = w173 * c30
    w460 = w191 * c30
    w461 = w196 * c30
    w462 = w209 + w230 * w244
    w463 = w252 + w255 * w261
    w464 = w458 - w165 * w167 + w173 * w459 + w191 * w460 + w196 * w461 + (w230 * w462 + w209 * w230) + (w255 * w463 + w252 * w255)
    w465 = w269 + w272 * w276
    w466 = w284 - w288 * w290
    w467 = w313 * c8
    w468 = w330 * c8
    w469 = w464 + (w272 * w465 + w269 * w272) - (w288 * w466 + w284 * w288) - w307 * w309 + w313 * w467 + w330 * w468
    w470 = w335 * c8
    w471 = w347 + w368 * w382
    w472 = w391 + w394 * w401
    w473 = w409 - w412 * w417
    w474 = w469 + w335 * w470 + (w368 * w471 + w347 * w368) + (w394 * w472 + w391 * w394) - (w412 * w473 + w409 * w412)
    w475 = w425 - w428 * w431
    w476 = w474 - (w428 * w475 + w425 * w428) - w448 * w450
    w477 = (spin_angle_dot / 2.0)**2
    w478 = ca.sin(w0)
    w479 = w477 * w478
    w480 = w3 * w30 - w7 * w31
    w481 = w144 - w4 * w30
    w482 = w4 * w31 - w3 * w139
    w483 = shaft_e2 * shaft_e1 * c57 + w4 * w453 + w454 * w480 + w455 * w481 + w456 * w482 + (slider_e2 * slider_e1 * c58 + w66 * w457)
    w484 = w162 * w480 + w163 * w481 + w164 * w482
    w485 = w484 / w166
    w486 = w7 * w170 - w3 * w172
    w487 = w4 * w172 - w195
    w488 = w3 * w186 - w4 * w170
    w489 = w202 * w486 + w205 * w487 + w208 * w488
    w490 = w247 * w486 + w248 * w487 + w250 * w488 + w251 * w288
    w491 = w483 - w165 * w485 + w459 * w486 + w460 * w487 + w461 * w488 + (w288 * w462 + w230 * w489) + (w255 * w490 - w272 * w463)
    w492 = w263 * w486 + w265 * w487 + w266 * w488 + w267 * w288 - w268 * w272
    w493 = w278 * w486 + w279 * w487 + w280 * w488 + w281 * w288 - w272 * w282 + w255 * w283
    w494 = w288 * w297 + w296 * w489 + (w299 * w490 - w272 * w300) + (w255 * w303 + w302 * w492) + (w230 * w306 - w305 * w493)
    w495 = w494 / w308
    w496 = w7 * w311 - w3 * w312
    w497 = w4 * w312 - w334
    w498 = w491 + (w255 * w465 + w272 * w492) + (w230 * w466 - w288 * w493) - w307 * w495 + w467 * w496 + w468 * w497
    w499 = w3 * w325 - w4 * w311
    w500 = w340 * w496 + w343 * w497 + w346 * w499
    w501 = w386 * w496 + w387 * w497 + w389 * w499 + w390 * w428
    w502 = w403 * w496 + w405 * w497 + w406 * w499 + w407 * w428 + w408 * w412
    w503 = w498 + w470 * w499 + (w428 * w471 + w368 * w500) + (w412 * w472 + w394 * w501) + (w394 * w473 - w412 * w502)
    w504 = w419 * w496 + w420 * w497 + w421 * w499 + w422 * w428 + w412 * w423 + w394 * w424
    w505 = w428 * w438 + w437 * w500 + (w412 * w441 + w440 * w501) + (w394 * w444 + w442 * w502) + (w368 * w447 + w445 * w504)
    w506 = w505 / w449
    w507 = w503 + (w368 * w475 - w428 * w504) - w448 * w506
    w508 = w2 * w507
    w509 = w1 * w477
    w510 = w478 / 2.0
    w511 = w7 * w17 + w3 * w22 + w4 * w23 + (w7 * w25 - w3 * w29) * c60 - w138 * w480 + w143 * w481 + w148 * w482
    w512 = w146 * (w52 * w60 - w43 * w66) + w141 * (w34 * w66 - w159) + w89 * (w43 * w64 - w34 * w60) + (w147 * (w60 * w104 - w66 * w96) + w142 * (w66 * w90 - w160) + w128 * (w64 * w96 - w60 * w90))
    w513 = w511 + (w64 * w154 + w60 * w157 + w66 * w158 - w512) + w168 * w485 + w190 * w486 + w194 * w487 + w198 * w488
    w514 = w513 - w229 * w489 + w245 * w288 - w254 * w490 - w262 * w272 - w271 * w492 + w255 * w277 + w286 * w493
    w515 = w514 + w230 * w291 - w310 * w495 + w329 * w496 + w333 * w497 + w337 * w499 - w367 * w500 + w383 * w428
    w516 = w515 - w393 * w501 + w402 * w412 - w411 * w502 + w394 * w418 - w427 * w504 + w368 * w432 - w451 * w506
    w517 = w7 * (w7 * c2) + w3 * (w3 * c4) + w4 * (w4 * c5) + w480 * (w480 * c50) + w481 * (w481 * c50) + w482 * (w482 * c50)
    w518 = w517 + (w64 * (w64 * c53) + w60 * (w60 * c55) + w66 * (w66 * c56)) - w484 * w485 + w486 * (w486 * c30)
    w519 = w518 + w487 * (w487 * c30) + w488 * (w488 * c30) + (w288 * (w489 + w244 * w288) + w288 * w489) - (w272 * (w490 - w261 * w272) + w272 * w490)
    w520 = w519 + (w255 * (w492 + w255 * w276) + w255 * w492) + (w230 * (w493 + w230 * w290) + w230 * w493) - w494 * w495
    w521 = w520 + w496 * (w496 * c8) + w497 * (w497 * c8) + w499 * (w499 * c8) + (w428 * (w500 + w382 * w428) + w428 * w500)
    w522 = w521 + (w412 * (w501 + w401 * w412) + w412 * w501) + (w394 * (w502 + w394 * w417) + w394 * w502) + (w368 * (w504 + w368 * w431) + w368 * w504)
    w523 = w522 - w505 * w506
    w524 = (w2 * (w452 + w476 * w479) + w508 * w509 - w510 * (w516 + w479 * w507 + w509 * w523)) / (w2 * (w2 * w476) - (w510 * (w508 - w510 * w523) + w508 * w510))
    w525 = w509 + w510 * w524
    w526 = w2 * w524 - w479
    q_i_ddot = ca.vertcat(
        w524,
        (w168 - (w484 * w525 - w165 * w526)) / w166,
        (w310 - (w307 * w526 - w494 * w525)) / w308,
        (w451 - (w448 * w526 - w505 * w525)) / w449,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 169 operations."""
    p = ca.SX.sym("p", 44)
    shaft_right_x = p[22]
    shaft_right_z = p[23]
    shaft_left_x = p[28]
    shaft_left_z = p[29]
    right_rod_middle_x = p[32]
    slider_right_x = p[33]
    left_rod_middle_x = p[37]
    slider_left_x = p[38]
    right_rod_ball_x = p[42]
    left_rod_ball_x = p[43]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        shaft_right_x,
        0.0,
        shaft_right_z,
        shaft_left_x,
        0.0,
        shaft_left_z,
        0.0,
        0.0,
        0.0,
        slider_right_x,
        0.0,
        0.0,
        slider_left_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        right_rod_middle_x,
        0.0,
        0.0,
        right_rod_ball_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        left_rod_middle_x,
        0.0,
        0.0,
        left_rod_ball_x,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 13)
    positions = ca.densify(positions)
    axes = ca.vertcat(
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
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        -1.0,
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
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
