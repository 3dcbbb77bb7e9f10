"""Chain of 10 links: equations of motion, emitted by symgen from the scene `chain`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 118 operations."""
    p = ca.SX.sym("p", 12)
    link_length = p[0]
    gravity_y = p[1]
    link1_mass = p[2]
    link2_mass = p[3]
    link3_mass = p[4]
    link4_mass = p[5]
    link5_mass = p[6]
    link6_mass = p[7]
    link7_mass = p[8]
    link8_mass = p[9]
    link9_mass = p[10]
    link10_mass = p[11]
    w0 = link9_mass + link10_mass
    w1 = link8_mass + w0
    w2 = link7_mass + w1
    w3 = link6_mass + w2
    w4 = link5_mass + w3
    w5 = link4_mass + w4
    w6 = link3_mass + w5
    w7 = 0.078 * link_length**2 / 12.0
    w8 = link_length / 2.0
    w9 = w8**2
    c = ca.vertcat(
        link_length,
        link2_mass + w6,
        w7 + link1_mass * w9,
        link2_mass * w8,
        w6,
        link3_mass * w8,
        w5,
        link4_mass * w8,
        w4,
        link5_mass * w8,
        w3,
        link6_mass * w8,
        w2,
        link7_mass * w8,
        w1,
        link8_mass * w8,
        w0,
        link9_mass * w8,
        link10_mass,
        link10_mass * w8,
        w7 + link2_mass * w9,
        w7 + link3_mass * w9,
        w7 + link4_mass * w9,
        w7 + link5_mass * w9,
        w7 + link6_mass * w9,
        w7 + link7_mass * w9,
        w7 + link8_mass * w9,
        w7 + link9_mass * w9,
        link1_mass * w8,
        gravity_y,
        link2_mass * gravity_y,
        link2_mass,
        link3_mass * gravity_y,
        link3_mass,
        link4_mass * gravity_y,
        link4_mass,
        link5_mass * gravity_y,
        link5_mass,
        link6_mass * gravity_y,
        link6_mass,
        link7_mass * gravity_y,
        link7_mass,
        link8_mass * gravity_y,
        link8_mass,
        link9_mass * gravity_y,
        link9_mass,
        link10_mass * gravity_y,
        w7 + link10_mass * w9,
        link1_mass * gravity_y,
        link1_mass,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 645 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link10_theta = q_i[9]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[1]
    link3_theta_dot = q_i_dot[2]
    link4_theta_dot = q_i_dot[3]
    link5_theta_dot = q_i_dot[4]
    link6_theta_dot = q_i_dot[5]
    link7_theta_dot = q_i_dot[6]
    link8_theta_dot = q_i_dot[7]
    link9_theta_dot = q_i_dot[8]
    link10_theta_dot = q_i_dot[9]
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
    w0 = ca.cos(link1_theta)
    w1 = w0 * c0
    w2 = ca.sin(link1_theta) * c0
    w3 = ca.cos(link2_theta)
    w4 = w3 * c3
    w5 = w3 * c0
    w6 = w5 * c4
    w7 = ca.sin(link2_theta)
    w8 = w7 * c3
    w9 = w7 * c0
    w10 = w9 * c4
    w11 = w1 * (w4 + w6) + w2 * (w8 + w10)
    w12 = ca.cos(link3_theta)
    w13 = w12 * c5
    w14 = w12 * c0
    w15 = w14 * c6
    w16 = w13 + w15
    w17 = ca.sin(link3_theta)
    w18 = w17 * c5
    w19 = w17 * c0
    w20 = w19 * c6
    w21 = w18 + w20
    w22 = w1 * w16 + w2 * w21
    w23 = ca.cos(link4_theta)
    w24 = w23 * c7
    w25 = w23 * c0
    w26 = w25 * c8
    w27 = w24 + w26
    w28 = ca.sin(link4_theta)
    w29 = w28 * c7
    w30 = w28 * c0
    w31 = w30 * c8
    w32 = w29 + w31
    w33 = w1 * w27 + w2 * w32
    w34 = ca.cos(link5_theta)
    w35 = w34 * c9
    w36 = w34 * c0
    w37 = w36 * c10
    w38 = w35 + w37
    w39 = ca.sin(link5_theta)
    w40 = w39 * c9
    w41 = w39 * c0
    w42 = w41 * c10
    w43 = w40 + w42
    w44 = w1 * w38 + w2 * w43
    w45 = ca.cos(link6_theta)
    w46 = w45 * c11
    w47 = w45 * c0
    w48 = w47 * c12
    w49 = w46 + w48
    w50 = ca.sin(link6_theta)
    w51 = w50 * c11
    w52 = w50 * c0
    w53 = w52 * c12
    w54 = w51 + w53
    w55 = w1 * w49 + w2 * w54
    w56 = ca.cos(link7_theta)
    w57 = w56 * c13
    w58 = w56 * c0
    w59 = w58 * c14
    w60 = w57 + w59
    w61 = ca.sin(link7_theta)
    w62 = w61 * c13
    w63 = w61 * c0
    w64 = w63 * c14
    w65 = w62 + w64
    w66 = w1 * w60 + w2 * w65
    w67 = ca.cos(link8_theta)
    w68 = w67 * c15
    w69 = w67 * c0
    w70 = w69 * c16
    w71 = w68 + w70
    w72 = ca.sin(link8_theta)
    w73 = w72 * c15
    w74 = w72 * c0
    w75 = w74 * c16
    w76 = w73 + w75
    w77 = w1 * w71 + w2 * w76
    w78 = ca.cos(link9_theta)
    w79 = w78 * c17
    w80 = w78 * c0
    w81 = w80 * c18
    w82 = w79 + w81
    w83 = ca.sin(link9_theta)
    w84 = w83 * c17
    w85 = w83 * c0
    w86 = w85 * c18
    w87 = w84 + w86
    w88 = w1 * w82 + w2 * w87
    w89 = ca.cos(link10_theta) * c19
    w90 = ca.sin(link10_theta) * c19
    w91 = w1 * w89 + w2 * w90
    w92 = w5 * w16 + w9 * w21
    w93 = w5 * w27 + w9 * w32
    w94 = w5 * w38 + w9 * w43
    w95 = w5 * w49 + w9 * w54
    w96 = w5 * w60 + w9 * w65
    w97 = w5 * w71 + w9 * w76
    w98 = w5 * w82 + w9 * w87
    w99 = w5 * w89 + w9 * w90
    w100 = w14 * w27 + w19 * w32
    w101 = w14 * w38 + w19 * w43
    w102 = w14 * w49 + w19 * w54
    w103 = w14 * w60 + w19 * w65
    w104 = w14 * w71 + w19 * w76
    w105 = w14 * w82 + w19 * w87
    w106 = w14 * w89 + w19 * w90
    w107 = w25 * w38 + w30 * w43
    w108 = w25 * w49 + w30 * w54
    w109 = w25 * w60 + w30 * w65
    w110 = w25 * w71 + w30 * w76
    w111 = w25 * w82 + w30 * w87
    w112 = w25 * w89 + w30 * w90
    w113 = w36 * w49 + w41 * w54
    w114 = w36 * w60 + w41 * w65
    w115 = w36 * w71 + w41 * w76
    w116 = w36 * w82 + w41 * w87
    w117 = w36 * w89 + w41 * w90
    w118 = w47 * w60 + w52 * w65
    w119 = w47 * w71 + w52 * w76
    w120 = w47 * w82 + w52 * w87
    w121 = w47 * w89 + w52 * w90
    w122 = w58 * w71 + w63 * w76
    w123 = w58 * w82 + w63 * w87
    w124 = w58 * w89 + w63 * w90
    w125 = w69 * w82 + w74 * w87
    w126 = w69 * w89 + w74 * w90
    w127 = w80 * w89 + w85 * w90
    w128 = link2_theta_dot**2
    w129 = link1_theta_dot**2
    w130 = w2 * w129
    w131 = link3_theta_dot**2
    w132 = w9 * w128 + w130
    w133 = link4_theta_dot**2
    w134 = w19 * w131 + w132
    w135 = link5_theta_dot**2
    w136 = w30 * w133 + w134
    w137 = link6_theta_dot**2
    w138 = w41 * w135 + w136
    w139 = link7_theta_dot**2
    w140 = w52 * w137 + w138
    w141 = link8_theta_dot**2
    w142 = w63 * w139 + w140
    w143 = link9_theta_dot**2
    w144 = w74 * w141 + w142
    w145 = link10_theta_dot**2
    w146 = w85 * w143 + w144
    w147 = w90 * w145 + c46 + c18 * w146
    w148 = w84 * w143 + c44 + c45 * w144 + w147
    w149 = w73 * w141 + c42 + c43 * w142 + w148
    w150 = w62 * w139 + c40 + c41 * w140 + w149
    w151 = w51 * w137 + c38 + c39 * w138 + w150
    w152 = w40 * w135 + c36 + c37 * w136 + w151
    w153 = w29 * w133 + c34 + c35 * w134 + w152
    w154 = w18 * w131 + c32 + c33 * w132 + w153
    w155 = w1 * w129
    w156 = w5 * w128 + w155
    w157 = w14 * w131 + w156
    w158 = w25 * w133 + w157
    w159 = w36 * w135 + w158
    w160 = w47 * w137 + w159
    w161 = w58 * w139 + w160
    w162 = w69 * w141 + w161
    w163 = w80 * w143 + w162
    w164 = w89 * w145 + c18 * w163
    w165 = w79 * w143 + c45 * w162 + w164
    w166 = w68 * w141 + c43 * w161 + w165
    w167 = w57 * w139 + c41 * w160 + w166
    w168 = w46 * w137 + c39 * w159 + w167
    w169 = w35 * w135 + c37 * w158 + w168
    w170 = w24 * w133 + c35 * w157 + w169
    w171 = w13 * w131 + c33 * w156 + w170
    w172 = w0 * c28 * c29 + (w8 * w128 + c30 + c31 * w130 + w154) * w1 - (w4 * w128 + c31 * w155 + w171) * w2
    M_hat = ca.vertcat(
        c2 + w1 * (w1 * c1) + w2 * (w2 * c1),
        w11,
        w22,
        w33,
        w44,
        w55,
        w66,
        w77,
        w88,
        w91,
        w11,
        c20 + w5 * w6 + w9 * w10,
        w92,
        w93,
        w94,
        w95,
        w96,
        w97,
        w98,
        w99,
        w22,
        w92,
        c21 + w14 * w15 + w19 * w20,
        w100,
        w101,
        w102,
        w103,
        w104,
        w105,
        w106,
        w33,
        w93,
        w100,
        c22 + w25 * w26 + w30 * w31,
        w107,
        w108,
        w109,
        w110,
        w111,
        w112,
        w44,
        w94,
        w101,
        w107,
        c23 + w36 * w37 + w41 * w42,
        w113,
        w114,
        w115,
        w116,
        w117,
        w55,
        w95,
        w102,
        w108,
        w113,
        c24 + w47 * w48 + w52 * w53,
        w118,
        w119,
        w120,
        w121,
        w66,
        w96,
        w103,
        w109,
        w114,
        w118,
        c25 + w58 * w59 + w63 * w64,
        w122,
        w123,
        w124,
        w77,
        w97,
        w104,
        w110,
        w115,
        w119,
        w122,
        c26 + w69 * w70 + w74 * w75,
        w125,
        w126,
        w88,
        w98,
        w105,
        w111,
        w116,
        w120,
        w123,
        w125,
        c27 + w80 * w81 + w85 * w86,
        w127,
        w91,
        w99,
        w106,
        w112,
        w117,
        w121,
        w124,
        w126,
        w127,
        c47,
    )
    M_hat = ca.reshape(M_hat, 10, 10)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w172,
        w4 * c29 - (w8 * w155 - w4 * w130) + w154 * w5 - w171 * w9,
        w13 * c29 - (w18 * w156 - w13 * w132) + w153 * w14 - w170 * w19,
        w24 * c29 - (w29 * w157 - w24 * w134) + w152 * w25 - w169 * w30,
        w35 * c29 - (w40 * w158 - w35 * w136) + w151 * w36 - w168 * w41,
        w46 * c29 - (w51 * w159 - w46 * w138) + w150 * w47 - w167 * w52,
        w57 * c29 - (w62 * w160 - w57 * w140) + w149 * w58 - w166 * w63,
        w68 * c29 - (w73 * w161 - w68 * w142) + w148 * w69 - w165 * w74,
        w79 * c29 - (w84 * w162 - w79 * w144) + w147 * w80 - w164 * w85,
        w89 * c29 - (w90 * w163 - w89 * w146),
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d in closed form (Eq. 31); C_loop before the step. 83 operations."""
    q_i = ca.SX.sym("q_i", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    c0 = c[0]
    w0 = ca.cos(link1_theta) * c0
    w1 = ca.sin(link1_theta) * c0
    w2 = w0 + ca.cos(link2_theta) * c0
    w3 = w1 + ca.sin(link2_theta) * c0
    w4 = w2 + ca.cos(link3_theta) * c0
    w5 = w3 + ca.sin(link3_theta) * c0
    w6 = w4 + ca.cos(link4_theta) * c0
    w7 = w5 + ca.sin(link4_theta) * c0
    w8 = w6 + ca.cos(link5_theta) * c0
    w9 = w7 + ca.sin(link5_theta) * c0
    w10 = w8 + ca.cos(link6_theta) * c0
    w11 = w9 + ca.sin(link6_theta) * c0
    w12 = w10 + ca.cos(link7_theta) * c0
    w13 = w11 + ca.sin(link7_theta) * c0
    w14 = w12 + ca.cos(link8_theta) * c0
    w15 = w13 + ca.sin(link8_theta) * c0
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w14 + ca.cos(link9_theta) * c0,
        w15 + ca.sin(link9_theta) * c0,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 119 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[1]
    link3_theta_dot = q_i_dot[2]
    link4_theta_dot = q_i_dot[3]
    link5_theta_dot = q_i_dot[4]
    link6_theta_dot = q_i_dot[5]
    link7_theta_dot = q_i_dot[6]
    link8_theta_dot = q_i_dot[7]
    link9_theta_dot = q_i_dot[8]
    c0 = c[0]
    w0 = ca.sin(link1_theta) * c0 * link1_theta_dot
    w1 = ca.cos(link1_theta) * c0 * link1_theta_dot
    w2 = w0 + ca.sin(link2_theta) * c0 * link2_theta_dot
    w3 = w1 + ca.cos(link2_theta) * c0 * link2_theta_dot
    w4 = w2 + ca.sin(link3_theta) * c0 * link3_theta_dot
    w5 = w3 + ca.cos(link3_theta) * c0 * link3_theta_dot
    w6 = w4 + ca.sin(link4_theta) * c0 * link4_theta_dot
    w7 = w5 + ca.cos(link4_theta) * c0 * link4_theta_dot
    w8 = w6 + ca.sin(link5_theta) * c0 * link5_theta_dot
    w9 = w7 + ca.cos(link5_theta) * c0 * link5_theta_dot
    w10 = w8 + ca.sin(link6_theta) * c0 * link6_theta_dot
    w11 = w9 + ca.cos(link6_theta) * c0 * link6_theta_dot
    w12 = w10 + ca.sin(link7_theta) * c0 * link7_theta_dot
    w13 = w11 + ca.cos(link7_theta) * c0 * link7_theta_dot
    w14 = w12 + ca.sin(link8_theta) * c0 * link8_theta_dot
    w15 = w13 + ca.cos(link8_theta) * c0 * link8_theta_dot
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -w0,
        w1,
        -w2,
        w3,
        -w4,
        w5,
        -w6,
        w7,
        -w8,
        w9,
        -w10,
        w11,
        -w12,
        w13,
        -w14,
        w15,
        -(w14 + ca.sin(link9_theta) * c0 * link9_theta_dot),
        w15 + ca.cos(link9_theta) * c0 * link9_theta_dot,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 173 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[1]
    link3_theta_dot = q_i_dot[2]
    link4_theta_dot = q_i_dot[3]
    link5_theta_dot = q_i_dot[4]
    link6_theta_dot = q_i_dot[5]
    link7_theta_dot = q_i_dot[6]
    link8_theta_dot = q_i_dot[7]
    link9_theta_dot = q_i_dot[8]
    link1_theta_ddot = q_i_ddot[0]
    link2_theta_ddot = q_i_ddot[1]
    link3_theta_ddot = q_i_ddot[2]
    link4_theta_ddot = q_i_ddot[3]
    link5_theta_ddot = q_i_ddot[4]
    link6_theta_ddot = q_i_ddot[5]
    link7_theta_ddot = q_i_ddot[6]
    link8_theta_ddot = q_i_ddot[7]
    link9_theta_ddot = q_i_ddot[8]
    c0 = c[0]
    w0 = ca.cos(link1_theta) * c0
    w1 = link1_theta_dot**2
    w2 = ca.sin(link1_theta) * c0
    w3 = w0 * w1 + w2 * link1_theta_ddot
    w4 = w0 * link1_theta_ddot - w2 * w1
    w5 = ca.cos(link2_theta) * c0
    w6 = link2_theta_dot**2
    w7 = ca.sin(link2_theta) * c0
    w8 = w5 * w6 + w3 + w7 * link2_theta_ddot
    w9 = w4 - w7 * w6 + w5 * link2_theta_ddot
    w10 = ca.cos(link3_theta) * c0
    w11 = link3_theta_dot**2
    w12 = ca.sin(link3_theta) * c0
    w13 = w10 * w11 + w8 + w12 * link3_theta_ddot
    w14 = w9 - w12 * w11 + w10 * link3_theta_ddot
    w15 = ca.cos(link4_theta) * c0
    w16 = link4_theta_dot**2
    w17 = ca.sin(link4_theta) * c0
    w18 = w15 * w16 + w13 + w17 * link4_theta_ddot
    w19 = w14 - w17 * w16 + w15 * link4_theta_ddot
    w20 = ca.cos(link5_theta) * c0
    w21 = link5_theta_dot**2
    w22 = ca.sin(link5_theta) * c0
    w23 = w20 * w21 + w18 + w22 * link5_theta_ddot
    w24 = w19 - w22 * w21 + w20 * link5_theta_ddot
    w25 = ca.cos(link6_theta) * c0
    w26 = link6_theta_dot**2
    w27 = ca.sin(link6_theta) * c0
    w28 = w25 * w26 + w23 + w27 * link6_theta_ddot
    w29 = w24 - w27 * w26 + w25 * link6_theta_ddot
    w30 = ca.cos(link7_theta) * c0
    w31 = link7_theta_dot**2
    w32 = ca.sin(link7_theta) * c0
    w33 = w30 * w31 + w28 + w32 * link7_theta_ddot
    w34 = w29 - w32 * w31 + w30 * link7_theta_ddot
    w35 = ca.cos(link8_theta) * c0
    w36 = link8_theta_dot**2
    w37 = ca.sin(link8_theta) * c0
    w38 = w35 * w36 + w33 + w37 * link8_theta_ddot
    w39 = w34 - w37 * w36 + w35 * link8_theta_ddot
    w40 = ca.cos(link9_theta) * c0
    w41 = link9_theta_dot**2
    w42 = ca.sin(link9_theta) * c0
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -w3,
        w4,
        -w8,
        w9,
        -w13,
        w14,
        -w18,
        w19,
        -w23,
        w24,
        -w28,
        w29,
        -w33,
        w34,
        -w38,
        w39,
        -(w40 * w41 + w38 + w42 * link9_theta_ddot),
        w39 - w42 * w41 + w40 * link9_theta_ddot,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t and gamma in all coordinates (Eqs. 21-27). 828 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 50)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    link2_x = q[3]
    link2_y = q[4]
    link2_theta = q[5]
    link3_x = q[6]
    link3_y = q[7]
    link3_theta = q[8]
    link4_x = q[9]
    link4_y = q[10]
    link4_theta = q[11]
    link5_x = q[12]
    link5_y = q[13]
    link5_theta = q[14]
    link6_x = q[15]
    link6_y = q[16]
    link6_theta = q[17]
    link7_x = q[18]
    link7_y = q[19]
    link7_theta = q[20]
    link8_x = q[21]
    link8_y = q[22]
    link8_theta = q[23]
    link9_x = q[24]
    link9_y = q[25]
    link9_theta = q[26]
    link10_x = q[27]
    link10_y = q[28]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[5]
    link3_theta_dot = q_dot[8]
    link4_theta_dot = q_dot[11]
    link5_theta_dot = q_dot[14]
    link6_theta_dot = q_dot[17]
    link7_theta_dot = q_dot[20]
    link8_theta_dot = q_dot[23]
    link9_theta_dot = q_dot[26]
    c0 = c[0]
    w0 = ca.cos(link1_theta) * c0
    w1 = ca.sin(link1_theta) * c0
    w2 = ca.cos(link2_theta) * c0
    w3 = ca.sin(link2_theta) * c0
    w4 = ca.cos(link3_theta) * c0
    w5 = ca.sin(link3_theta) * c0
    w6 = ca.cos(link4_theta) * c0
    w7 = ca.sin(link4_theta) * c0
    w8 = ca.cos(link5_theta) * c0
    w9 = ca.sin(link5_theta) * c0
    w10 = ca.cos(link6_theta) * c0
    w11 = ca.sin(link6_theta) * c0
    w12 = ca.cos(link7_theta) * c0
    w13 = ca.sin(link7_theta) * c0
    w14 = ca.cos(link8_theta) * c0
    w15 = ca.sin(link8_theta) * c0
    w16 = ca.cos(link9_theta) * c0
    w17 = ca.sin(link9_theta) * c0
    w18 = link1_theta_dot**2
    w19 = link2_theta_dot**2
    w20 = link3_theta_dot**2
    w21 = link4_theta_dot**2
    w22 = link5_theta_dot**2
    w23 = link6_theta_dot**2
    w24 = link7_theta_dot**2
    w25 = link8_theta_dot**2
    w26 = link9_theta_dot**2
    C = ca.vertcat(
        link1_x,
        link1_y,
        link2_x - (link1_x + w0),
        link2_y - (link1_y + w1),
        link3_x - (link2_x + w2),
        link3_y - (link2_y + w3),
        link4_x - (link3_x + w4),
        link4_y - (link3_y + w5),
        link5_x - (link4_x + w6),
        link5_y - (link4_y + w7),
        link6_x - (link5_x + w8),
        link6_y - (link5_y + w9),
        link7_x - (link6_x + w10),
        link7_y - (link6_y + w11),
        link8_x - (link7_x + w12),
        link8_y - (link7_y + w13),
        link9_x - (link8_x + w14),
        link9_y - (link8_y + w15),
        link10_x - (link9_x + w16),
        link10_y - (link9_y + w17),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
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
        1.0,
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
        w1,
        -w0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w3,
        -w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w5,
        -w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w7,
        -w6,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w9,
        -w8,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w11,
        -w10,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w13,
        -w12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w15,
        -w14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        1.0,
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
        w17,
        -w16,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
    )
    C_q = ca.reshape(C_q, 20, 30)
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
    )
    C_t = ca.densify(C_t)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w18),
        -(w1 * w18),
        -(w2 * w19),
        -(w3 * w19),
        -(w4 * w20),
        -(w5 * w20),
        -(w6 * w21),
        -(w7 * w21),
        -(w8 * w22),
        -(w9 * w22),
        -(w10 * w23),
        -(w11 * w23),
        -(w12 * w24),
        -(w13 * w24),
        -(w14 * w25),
        -(w15 * w25),
        -(w16 * w26),
        -(w17 * w26),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "gamma"])


def augmented() -> ca.Function:
    """M and Q* of the augmented form (Eq. 28). 1092 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 50)
    link1_theta = q[2]
    link2_theta = q[5]
    link3_theta = q[8]
    link4_theta = q[11]
    link5_theta = q[14]
    link6_theta = q[17]
    link7_theta = q[20]
    link8_theta = q[23]
    link9_theta = q[26]
    link10_theta = q[29]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[5]
    link3_theta_dot = q_dot[8]
    link4_theta_dot = q_dot[11]
    link5_theta_dot = q_dot[14]
    link6_theta_dot = q_dot[17]
    link7_theta_dot = q_dot[20]
    link8_theta_dot = q_dot[23]
    link9_theta_dot = q_dot[26]
    link10_theta_dot = q_dot[29]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
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
    w0 = ca.sin(link1_theta) * c28
    w1 = -w0
    w2 = ca.cos(link1_theta) * c28
    w3 = ca.sin(link2_theta) * c3
    w4 = -w3
    w5 = ca.cos(link2_theta) * c3
    w6 = ca.sin(link3_theta) * c5
    w7 = -w6
    w8 = ca.cos(link3_theta) * c5
    w9 = ca.sin(link4_theta) * c7
    w10 = -w9
    w11 = ca.cos(link4_theta) * c7
    w12 = ca.sin(link5_theta) * c9
    w13 = -w12
    w14 = ca.cos(link5_theta) * c9
    w15 = ca.sin(link6_theta) * c11
    w16 = -w15
    w17 = ca.cos(link6_theta) * c11
    w18 = ca.sin(link7_theta) * c13
    w19 = -w18
    w20 = ca.cos(link7_theta) * c13
    w21 = ca.sin(link8_theta) * c15
    w22 = -w21
    w23 = ca.cos(link8_theta) * c15
    w24 = ca.sin(link9_theta) * c17
    w25 = -w24
    w26 = ca.cos(link9_theta) * c17
    w27 = ca.sin(link10_theta) * c19
    w28 = -w27
    w29 = ca.cos(link10_theta) * c19
    w30 = link1_theta_dot**2
    w31 = link2_theta_dot**2
    w32 = link3_theta_dot**2
    w33 = link4_theta_dot**2
    w34 = link5_theta_dot**2
    w35 = link6_theta_dot**2
    w36 = link7_theta_dot**2
    w37 = link8_theta_dot**2
    w38 = link9_theta_dot**2
    w39 = link10_theta_dot**2
    M = ca.vertcat(
        c49,
        0.0,
        w1,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c49,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        w2,
        c2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c31,
        0.0,
        w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c31,
        w5,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w4,
        w5,
        c20,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c33,
        0.0,
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c33,
        w8,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w7,
        w8,
        c21,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c35,
        0.0,
        w10,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c35,
        w11,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w10,
        w11,
        c22,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c37,
        0.0,
        w13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c37,
        w14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w14,
        c23,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c39,
        0.0,
        w16,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c39,
        w17,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w16,
        w17,
        c24,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c41,
        0.0,
        w19,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c41,
        w20,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w19,
        w20,
        c25,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c43,
        0.0,
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
        0.0,
        0.0,
        c43,
        w23,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w23,
        c26,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c45,
        0.0,
        w25,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c45,
        w26,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w25,
        w26,
        c27,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c18,
        0.0,
        w28,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c18,
        w29,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w28,
        w29,
        c47,
    )
    M = ca.reshape(M, 30, 30)
    M = ca.densify(M)
    Q_star = ca.vertcat(
        w2 * w30,
        w0 * w30 + c48,
        w2 * c29,
        w5 * w31,
        w3 * w31 + c30,
        w5 * c29,
        w8 * w32,
        w6 * w32 + c32,
        w8 * c29,
        w11 * w33,
        w9 * w33 + c34,
        w11 * c29,
        w14 * w34,
        w12 * w34 + c36,
        w14 * c29,
        w17 * w35,
        w15 * w35 + c38,
        w17 * c29,
        w20 * w36,
        w18 * w36 + c40,
        w20 * c29,
        w23 * w37,
        w21 * w37 + c42,
        w23 * c29,
        w26 * w38,
        w24 * w38 + c44,
        w26 * c29,
        w29 * w39,
        w27 * w39 + c46,
        w29 * c29,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, c], [M, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "Q_star"])


def reactions() -> ca.Function:
    """Lagrange multipliers lam (Eq. 37). 278 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    q_ddot = ca.SX.sym("q_ddot", 30)
    c = ca.SX.sym("c", 50)
    link1_theta = q[2]
    link2_theta = q[5]
    link3_theta = q[8]
    link4_theta = q[11]
    link5_theta = q[14]
    link6_theta = q[17]
    link7_theta = q[20]
    link8_theta = q[23]
    link9_theta = q[26]
    link10_theta = q[29]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[5]
    link3_theta_dot = q_dot[8]
    link4_theta_dot = q_dot[11]
    link5_theta_dot = q_dot[14]
    link6_theta_dot = q_dot[17]
    link7_theta_dot = q_dot[20]
    link8_theta_dot = q_dot[23]
    link9_theta_dot = q_dot[26]
    link10_theta_dot = q_dot[29]
    link1_x_ddot = q_ddot[0]
    link1_y_ddot = q_ddot[1]
    link1_theta_ddot = q_ddot[2]
    link2_x_ddot = q_ddot[3]
    link2_y_ddot = q_ddot[4]
    link2_theta_ddot = q_ddot[5]
    link3_x_ddot = q_ddot[6]
    link3_y_ddot = q_ddot[7]
    link3_theta_ddot = q_ddot[8]
    link4_x_ddot = q_ddot[9]
    link4_y_ddot = q_ddot[10]
    link4_theta_ddot = q_ddot[11]
    link5_x_ddot = q_ddot[12]
    link5_y_ddot = q_ddot[13]
    link5_theta_ddot = q_ddot[14]
    link6_x_ddot = q_ddot[15]
    link6_y_ddot = q_ddot[16]
    link6_theta_ddot = q_ddot[17]
    link7_x_ddot = q_ddot[18]
    link7_y_ddot = q_ddot[19]
    link7_theta_ddot = q_ddot[20]
    link8_x_ddot = q_ddot[21]
    link8_y_ddot = q_ddot[22]
    link8_theta_ddot = q_ddot[23]
    link9_x_ddot = q_ddot[24]
    link9_y_ddot = q_ddot[25]
    link9_theta_ddot = q_ddot[26]
    link10_x_ddot = q_ddot[27]
    link10_y_ddot = q_ddot[28]
    link10_theta_ddot = q_ddot[29]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c28 = c[28]
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
    c48 = c[48]
    c49 = c[49]
    w0 = ca.cos(link1_theta) * c28
    w1 = link1_theta_dot**2
    w2 = ca.sin(link1_theta) * c28
    w3 = ca.cos(link2_theta) * c3
    w4 = link2_theta_dot**2
    w5 = ca.sin(link2_theta) * c3
    w6 = ca.cos(link3_theta) * c5
    w7 = link3_theta_dot**2
    w8 = ca.sin(link3_theta) * c5
    w9 = ca.cos(link4_theta) * c7
    w10 = link4_theta_dot**2
    w11 = ca.sin(link4_theta) * c7
    w12 = ca.cos(link5_theta) * c9
    w13 = link5_theta_dot**2
    w14 = ca.sin(link5_theta) * c9
    w15 = ca.cos(link6_theta) * c11
    w16 = link6_theta_dot**2
    w17 = ca.sin(link6_theta) * c11
    w18 = ca.cos(link7_theta) * c13
    w19 = link7_theta_dot**2
    w20 = ca.sin(link7_theta) * c13
    w21 = ca.cos(link8_theta) * c15
    w22 = link8_theta_dot**2
    w23 = ca.sin(link8_theta) * c15
    w24 = ca.cos(link9_theta) * c17
    w25 = link9_theta_dot**2
    w26 = ca.sin(link9_theta) * c17
    w27 = ca.cos(link10_theta) * c19
    w28 = link10_theta_dot**2
    w29 = ca.sin(link10_theta) * c19
    w30 = w27 * w28 - (c18 * link10_x_ddot - w29 * link10_theta_ddot)
    w31 = w24 * w25 - (c45 * link9_x_ddot - w26 * link9_theta_ddot) + w30
    w32 = w21 * w22 - (c43 * link8_x_ddot - w23 * link8_theta_ddot) + w31
    w33 = w18 * w19 - (c41 * link7_x_ddot - w20 * link7_theta_ddot) + w32
    w34 = w15 * w16 - (c39 * link6_x_ddot - w17 * link6_theta_ddot) + w33
    w35 = w12 * w13 - (c37 * link5_x_ddot - w14 * link5_theta_ddot) + w34
    w36 = w9 * w10 - (c35 * link4_x_ddot - w11 * link4_theta_ddot) + w35
    w37 = w6 * w7 - (c33 * link3_x_ddot - w8 * link3_theta_ddot) + w36
    w38 = w3 * w4 - (c31 * link2_x_ddot - w5 * link2_theta_ddot) + w37
    w39 = w29 * w28 + c46 - (c18 * link10_y_ddot + w27 * link10_theta_ddot)
    w40 = w26 * w25 + c44 - (c45 * link9_y_ddot + w24 * link9_theta_ddot) + w39
    w41 = w23 * w22 + c42 - (c43 * link8_y_ddot + w21 * link8_theta_ddot) + w40
    w42 = w20 * w19 + c40 - (c41 * link7_y_ddot + w18 * link7_theta_ddot) + w41
    w43 = w17 * w16 + c38 - (c39 * link6_y_ddot + w15 * link6_theta_ddot) + w42
    w44 = w14 * w13 + c36 - (c37 * link5_y_ddot + w12 * link5_theta_ddot) + w43
    w45 = w11 * w10 + c34 - (c35 * link4_y_ddot + w9 * link4_theta_ddot) + w44
    w46 = w8 * w7 + c32 - (c33 * link3_y_ddot + w6 * link3_theta_ddot) + w45
    w47 = w5 * w4 + c30 - (c31 * link2_y_ddot + w3 * link2_theta_ddot) + w46
    lam = ca.vertcat(
        w0 * w1 - (c49 * link1_x_ddot - w2 * link1_theta_ddot) + w38,
        w2 * w1 + c48 - (c49 * link1_y_ddot + w0 * link1_theta_ddot) + w47,
        w38,
        w47,
        w37,
        w46,
        w36,
        w45,
        w35,
        w44,
        w34,
        w43,
        w33,
        w42,
        w32,
        w41,
        w31,
        w40,
        w30,
        w39,
    )
    lam = ca.densify(lam)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 338 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 50)
    link1_y = q[1]
    link1_theta = q[2]
    link2_y = q[4]
    link2_theta = q[5]
    link3_y = q[7]
    link3_theta = q[8]
    link4_y = q[10]
    link4_theta = q[11]
    link5_y = q[13]
    link5_theta = q[14]
    link6_y = q[16]
    link6_theta = q[17]
    link7_y = q[19]
    link7_theta = q[20]
    link8_y = q[22]
    link8_theta = q[23]
    link9_y = q[25]
    link9_theta = q[26]
    link10_y = q[28]
    link10_theta = q[29]
    link1_x_dot = q_dot[0]
    link1_y_dot = q_dot[1]
    link1_theta_dot = q_dot[2]
    link2_x_dot = q_dot[3]
    link2_y_dot = q_dot[4]
    link2_theta_dot = q_dot[5]
    link3_x_dot = q_dot[6]
    link3_y_dot = q_dot[7]
    link3_theta_dot = q_dot[8]
    link4_x_dot = q_dot[9]
    link4_y_dot = q_dot[10]
    link4_theta_dot = q_dot[11]
    link5_x_dot = q_dot[12]
    link5_y_dot = q_dot[13]
    link5_theta_dot = q_dot[14]
    link6_x_dot = q_dot[15]
    link6_y_dot = q_dot[16]
    link6_theta_dot = q_dot[17]
    link7_x_dot = q_dot[18]
    link7_y_dot = q_dot[19]
    link7_theta_dot = q_dot[20]
    link8_x_dot = q_dot[21]
    link8_y_dot = q_dot[22]
    link8_theta_dot = q_dot[23]
    link9_x_dot = q_dot[24]
    link9_y_dot = q_dot[25]
    link9_theta_dot = q_dot[26]
    link10_x_dot = q_dot[27]
    link10_y_dot = q_dot[28]
    link10_theta_dot = q_dot[29]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
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
    c31 = c[31]
    c33 = c[33]
    c35 = c[35]
    c37 = c[37]
    c39 = c[39]
    c41 = c[41]
    c43 = c[43]
    c45 = c[45]
    c47 = c[47]
    c49 = c[49]
    w0 = ca.sin(link1_theta) * c28
    w1 = ca.cos(link1_theta) * c28
    w2 = link1_x_dot * (c49 * link1_x_dot - w0 * link1_theta_dot) + link1_y_dot * (c49 * link1_y_dot + w1 * link1_theta_dot)
    w3 = ca.sin(link2_theta) * c3
    w4 = w2 + link1_theta_dot * (w1 * link1_y_dot - w0 * link1_x_dot + c2 * link1_theta_dot) + link2_x_dot * (c31 * link2_x_dot - w3 * link2_theta_dot)
    w5 = ca.cos(link2_theta) * c3
    w6 = w4 + link2_y_dot * (c31 * link2_y_dot + w5 * link2_theta_dot) + link2_theta_dot * (w5 * link2_y_dot - w3 * link2_x_dot + c20 * link2_theta_dot)
    w7 = ca.sin(link3_theta) * c5
    w8 = ca.cos(link3_theta) * c5
    w9 = w6 + link3_x_dot * (c33 * link3_x_dot - w7 * link3_theta_dot) + link3_y_dot * (c33 * link3_y_dot + w8 * link3_theta_dot)
    w10 = ca.sin(link4_theta) * c7
    w11 = w9 + link3_theta_dot * (w8 * link3_y_dot - w7 * link3_x_dot + c21 * link3_theta_dot) + link4_x_dot * (c35 * link4_x_dot - w10 * link4_theta_dot)
    w12 = ca.cos(link4_theta) * c7
    w13 = w11 + link4_y_dot * (c35 * link4_y_dot + w12 * link4_theta_dot) + link4_theta_dot * (w12 * link4_y_dot - w10 * link4_x_dot + c22 * link4_theta_dot)
    w14 = ca.sin(link5_theta) * c9
    w15 = ca.cos(link5_theta) * c9
    w16 = w13 + link5_x_dot * (c37 * link5_x_dot - w14 * link5_theta_dot) + link5_y_dot * (c37 * link5_y_dot + w15 * link5_theta_dot)
    w17 = ca.sin(link6_theta) * c11
    w18 = w16 + link5_theta_dot * (w15 * link5_y_dot - w14 * link5_x_dot + c23 * link5_theta_dot) + link6_x_dot * (c39 * link6_x_dot - w17 * link6_theta_dot)
    w19 = ca.cos(link6_theta) * c11
    w20 = w18 + link6_y_dot * (c39 * link6_y_dot + w19 * link6_theta_dot) + link6_theta_dot * (w19 * link6_y_dot - w17 * link6_x_dot + c24 * link6_theta_dot)
    w21 = ca.sin(link7_theta) * c13
    w22 = ca.cos(link7_theta) * c13
    w23 = w20 + link7_x_dot * (c41 * link7_x_dot - w21 * link7_theta_dot) + link7_y_dot * (c41 * link7_y_dot + w22 * link7_theta_dot)
    w24 = ca.sin(link8_theta) * c15
    w25 = w23 + link7_theta_dot * (w22 * link7_y_dot - w21 * link7_x_dot + c25 * link7_theta_dot) + link8_x_dot * (c43 * link8_x_dot - w24 * link8_theta_dot)
    w26 = ca.cos(link8_theta) * c15
    w27 = w25 + link8_y_dot * (c43 * link8_y_dot + w26 * link8_theta_dot) + link8_theta_dot * (w26 * link8_y_dot - w24 * link8_x_dot + c26 * link8_theta_dot)
    w28 = ca.sin(link9_theta) * c17
    w29 = ca.cos(link9_theta) * c17
    w30 = w27 + link9_x_dot * (c45 * link9_x_dot - w28 * link9_theta_dot) + link9_y_dot * (c45 * link9_y_dot + w29 * link9_theta_dot)
    w31 = ca.sin(link10_theta) * c19
    w32 = w30 + link9_theta_dot * (w29 * link9_y_dot - w28 * link9_x_dot + c27 * link9_theta_dot) + link10_x_dot * (c18 * link10_x_dot - w31 * link10_theta_dot)
    w33 = ca.cos(link10_theta) * c19
    w34 = w32 + link10_y_dot * (c18 * link10_y_dot + w33 * link10_theta_dot) + link10_theta_dot * (w33 * link10_y_dot - w31 * link10_x_dot + c47 * link10_theta_dot)
    w35 = c29 * (c49 * link1_y + w0) + c29 * (c31 * link2_y + w3) + c29 * (c33 * link3_y + w7) + c29 * (c35 * link4_y + w10)
    w36 = w35 + c29 * (c37 * link5_y + w14) + c29 * (c39 * link6_y + w17) + c29 * (c41 * link7_y + w21) + c29 * (c43 * link8_y + w24)
    kinetic = ca.vertcat(
        w34 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(w36 + c29 * (c45 * link9_y + w28) + c29 * (c18 * link10_y + w31)),
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


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 131 operations."""
    q = ca.SX.sym("q", 30)
    c = ca.SX.sym("c", 50)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    link2_x = q[3]
    link2_y = q[4]
    link2_theta = q[5]
    link3_x = q[6]
    link3_y = q[7]
    link3_theta = q[8]
    link4_x = q[9]
    link4_y = q[10]
    link4_theta = q[11]
    link5_x = q[12]
    link5_y = q[13]
    link5_theta = q[14]
    link6_x = q[15]
    link6_y = q[16]
    link6_theta = q[17]
    link7_x = q[18]
    link7_y = q[19]
    link7_theta = q[20]
    link8_x = q[21]
    link8_y = q[22]
    link8_theta = q[23]
    link9_x = q[24]
    link9_y = q[25]
    link9_theta = q[26]
    link10_x = q[27]
    link10_y = q[28]
    link10_theta = q[29]
    c0 = c[0]
    xy = ca.vertcat(
        link1_x,
        link1_y,
        link1_x + ca.cos(link1_theta) * c0,
        link1_y + ca.sin(link1_theta) * c0,
        link2_x,
        link2_y,
        link2_x + ca.cos(link2_theta) * c0,
        link2_y + ca.sin(link2_theta) * c0,
        link3_x,
        link3_y,
        link3_x + ca.cos(link3_theta) * c0,
        link3_y + ca.sin(link3_theta) * c0,
        link4_x,
        link4_y,
        link4_x + ca.cos(link4_theta) * c0,
        link4_y + ca.sin(link4_theta) * c0,
        link5_x,
        link5_y,
        link5_x + ca.cos(link5_theta) * c0,
        link5_y + ca.sin(link5_theta) * c0,
        link6_x,
        link6_y,
        link6_x + ca.cos(link6_theta) * c0,
        link6_y + ca.sin(link6_theta) * c0,
        link7_x,
        link7_y,
        link7_x + ca.cos(link7_theta) * c0,
        link7_y + ca.sin(link7_theta) * c0,
        link8_x,
        link8_y,
        link8_x + ca.cos(link8_theta) * c0,
        link8_y + ca.sin(link8_theta) * c0,
        link9_x,
        link9_y,
        link9_x + ca.cos(link9_theta) * c0,
        link9_y + ca.sin(link9_theta) * c0,
        link10_x,
        link10_y,
        link10_x + ca.cos(link10_theta) * c0,
        link10_y + ca.sin(link10_theta) * c0,
    )
    xy = ca.reshape(xy, 2, 20)
    xy = ca.densify(xy)
    inputs, outputs = [q, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 1113 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link10_theta = q_i[9]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[1]
    link3_theta_dot = q_i_dot[2]
    link4_theta_dot = q_i_dot[3]
    link5_theta_dot = q_i_dot[4]
    link6_theta_dot = q_i_dot[5]
    link7_theta_dot = q_i_dot[6]
    link8_theta_dot = q_i_dot[7]
    link9_theta_dot = q_i_dot[8]
    link10_theta_dot = q_i_dot[9]
    c0 = c[0]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
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
    w0 = ca.cos(link1_theta)
    w1 = w0 * c0
    w2 = link1_theta_dot**2
    w3 = c0 * w0
    w4 = w2 * w3
    w5 = c18 * w4
    w6 = c45 * w4 + w5
    w7 = c43 * w4 + w6
    w8 = c41 * w4 + w7
    w9 = c39 * w4 + w8
    w10 = c37 * w4 + w9
    w11 = c35 * w4 + w10
    w12 = c33 * w4 + w11
    w13 = ca.sin(link2_theta)
    w14 = w13 * c3
    w15 = link2_theta_dot**2
    w16 = ca.sin(link1_theta)
    w17 = w16 * c0
    w18 = w17 * w2
    w19 = ca.sin(link3_theta)
    w20 = w19 * c5
    w21 = link3_theta_dot**2
    w22 = w13 * c0
    w23 = w22 * w15 + w18
    w24 = ca.sin(link4_theta)
    w25 = w24 * c7
    w26 = link4_theta_dot**2
    w27 = w19 * c0
    w28 = w27 * w21 + w23
    w29 = ca.sin(link5_theta)
    w30 = w29 * c9
    w31 = link5_theta_dot**2
    w32 = w24 * c0
    w33 = w32 * w26 + w28
    w34 = ca.sin(link6_theta)
    w35 = w34 * c11
    w36 = link6_theta_dot**2
    w37 = w29 * c0
    w38 = w37 * w31 + w33
    w39 = ca.sin(link7_theta)
    w40 = w39 * c13
    w41 = link7_theta_dot**2
    w42 = w34 * c0
    w43 = w42 * w36 + w38
    w44 = ca.sin(link8_theta)
    w45 = w44 * c15
    w46 = link8_theta_dot**2
    w47 = w39 * c0
    w48 = w47 * w41 + w43
    w49 = ca.sin(link9_theta)
    w50 = w49 * c17
    w51 = link9_theta_dot**2
    w52 = w44 * c0
    w53 = w52 * w46 + w48
    w54 = ca.sin(link10_theta)
    w55 = w54 * c19
    w56 = link10_theta_dot**2
    w57 = w49 * c0
    w58 = w57 * w51 + w53
    w59 = w55 * w56 + c46 + c18 * w58
    w60 = w50 * w51 + c44 + c45 * w53 + w59
    w61 = w45 * w46 + c42 + c43 * w48 + w60
    w62 = w40 * w41 + c40 + c41 * w43 + w61
    w63 = w35 * w36 + c38 + c39 * w38 + w62
    w64 = w30 * w31 + c36 + c37 * w33 + w63
    w65 = w25 * w26 + c34 + c35 * w28 + w64
    w66 = w20 * w21 + c32 + c33 * w23 + w65
    w67 = c0 * w16
    w68 = ca.cos(link2_theta)
    w69 = w68 * c3
    w70 = w1 * w2
    w71 = ca.cos(link3_theta)
    w72 = w71 * c5
    w73 = w68 * c0
    w74 = w73 * w15 + w70
    w75 = ca.cos(link4_theta)
    w76 = w75 * c7
    w77 = w71 * c0
    w78 = w77 * w21 + w74
    w79 = ca.cos(link5_theta)
    w80 = w79 * c9
    w81 = w75 * c0
    w82 = w81 * w26 + w78
    w83 = ca.cos(link6_theta)
    w84 = w83 * c11
    w85 = w79 * c0
    w86 = w85 * w31 + w82
    w87 = ca.cos(link7_theta)
    w88 = w87 * c13
    w89 = w83 * c0
    w90 = w89 * w36 + w86
    w91 = ca.cos(link8_theta)
    w92 = w91 * c15
    w93 = w87 * c0
    w94 = w93 * w41 + w90
    w95 = ca.cos(link9_theta)
    w96 = w95 * c17
    w97 = w91 * c0
    w98 = w97 * w46 + w94
    w99 = ca.cos(link10_theta)
    w100 = w99 * c19
    w101 = w95 * c0
    w102 = w101 * w51 + w98
    w103 = w100 * w56 + c18 * w102
    w104 = w96 * w51 + c45 * w98 + w103
    w105 = w92 * w46 + c43 * w94 + w104
    w106 = w88 * w41 + c41 * w90 + w105
    w107 = w84 * w36 + c39 * w86 + w106
    w108 = w80 * w31 + c37 * w82 + w107
    w109 = w76 * w26 + c35 * w78 + w108
    w110 = w72 * w21 + c33 * w74 + w109
    w111 = w2 * w67
    w112 = c18 * w111
    w113 = c45 * w111 + w112
    w114 = c43 * w111 + w113
    w115 = c41 * w111 + w114
    w116 = c39 * w111 + w115
    w117 = c37 * w111 + w116
    w118 = c35 * w111 + w117
    w119 = c33 * w111 + w118
    w120 = w1 * (c31 * w4 + w12) - (w14 * w15 + c30 + c31 * w18 + w66) * w67 - c29 * (c28 * w16) - ((w69 * w15 + c31 * w70 + w110) * w3 - w17 * (c31 * w111 + w119))
    w121 = c3 * w68
    w122 = c0 * w68
    w123 = w15 * w122
    w124 = c18 * w123
    w125 = c45 * w123 + w124
    w126 = c43 * w123 + w125
    w127 = c41 * w123 + w126
    w128 = c39 * w123 + w127
    w129 = c37 * w123 + w128
    w130 = c35 * w123 + w129
    w131 = c33 * w123 + w130
    w132 = c3 * w13
    w133 = c0 * w13
    w134 = w15 * w133
    w135 = c18 * w134
    w136 = c45 * w134 + w135
    w137 = c43 * w134 + w136
    w138 = c41 * w134 + w137
    w139 = c39 * w134 + w138
    w140 = c37 * w134 + w139
    w141 = c35 * w134 + w140
    w142 = c33 * w134 + w141
    w143 = c5 * w71
    w144 = c0 * w71
    w145 = w21 * w144
    w146 = c18 * w145
    w147 = c45 * w145 + w146
    w148 = c43 * w145 + w147
    w149 = c41 * w145 + w148
    w150 = c39 * w145 + w149
    w151 = c37 * w145 + w150
    w152 = c35 * w145 + w151
    w153 = w21 * w143 + w152
    w154 = c5 * w19
    w155 = c0 * w19
    w156 = w21 * w155
    w157 = c18 * w156
    w158 = c45 * w156 + w157
    w159 = c43 * w156 + w158
    w160 = c41 * w156 + w159
    w161 = c39 * w156 + w160
    w162 = c37 * w156 + w161
    w163 = c35 * w156 + w162
    w164 = w21 * w154 + w163
    w165 = c7 * w75
    w166 = c0 * w75
    w167 = w26 * w166
    w168 = c18 * w167
    w169 = c45 * w167 + w168
    w170 = c43 * w167 + w169
    w171 = c41 * w167 + w170
    w172 = c39 * w167 + w171
    w173 = c37 * w167 + w172
    w174 = w26 * w165 + w173
    w175 = c7 * w24
    w176 = c0 * w24
    w177 = w26 * w176
    w178 = c18 * w177
    w179 = c45 * w177 + w178
    w180 = c43 * w177 + w179
    w181 = c41 * w177 + w180
    w182 = c39 * w177 + w181
    w183 = c37 * w177 + w182
    w184 = w26 * w175 + w183
    w185 = c9 * w79
    w186 = c0 * w79
    w187 = w31 * w186
    w188 = c18 * w187
    w189 = c45 * w187 + w188
    w190 = c43 * w187 + w189
    w191 = c41 * w187 + w190
    w192 = c39 * w187 + w191
    w193 = w31 * w185 + w192
    w194 = c9 * w29
    w195 = c0 * w29
    w196 = w31 * w195
    w197 = c18 * w196
    w198 = c45 * w196 + w197
    w199 = c43 * w196 + w198
    w200 = c41 * w196 + w199
    w201 = c39 * w196 + w200
    w202 = w31 * w194 + w201
    w203 = c11 * w83
    w204 = c0 * w83
    w205 = w36 * w204
    w206 = c18 * w205
    w207 = c45 * w205 + w206
    w208 = c43 * w205 + w207
    w209 = c41 * w205 + w208
    w210 = w36 * w203 + w209
    w211 = c11 * w34
    w212 = c0 * w34
    w213 = w36 * w212
    w214 = c18 * w213
    w215 = c45 * w213 + w214
    w216 = c43 * w213 + w215
    w217 = c41 * w213 + w216
    w218 = w36 * w211 + w217
    w219 = c13 * w87
    w220 = c0 * w87
    w221 = w41 * w220
    w222 = c18 * w221
    w223 = c45 * w221 + w222
    w224 = c43 * w221 + w223
    w225 = w41 * w219 + w224
    w226 = c13 * w39
    w227 = c0 * w39
    w228 = w41 * w227
    w229 = c18 * w228
    w230 = c45 * w228 + w229
    w231 = c43 * w228 + w230
    w232 = w41 * w226 + w231
    w233 = c15 * w91
    w234 = c0 * w91
    w235 = w46 * w234
    w236 = c18 * w235
    w237 = c45 * w235 + w236
    w238 = w46 * w233 + w237
    w239 = c15 * w44
    w240 = c0 * w44
    w241 = w46 * w240
    w242 = c18 * w241
    w243 = c45 * w241 + w242
    w244 = w46 * w239 + w243
    w245 = c17 * w95
    w246 = c0 * w95
    w247 = w51 * w246
    w248 = c18 * w247
    w249 = w51 * w245 + w248
    w250 = c17 * w49
    w251 = c0 * w49
    w252 = w51 * w251
    w253 = c18 * w252
    w254 = w51 * w250 + w253
    w255 = c19 * w99
    w256 = w56 * w255
    w257 = c19 * w54
    w258 = w56 * w257
    dQ_hat_dq_i = ca.vertcat(
        w120,
        w14 * w111 + w69 * w4 + w73 * w12 + w22 * w119,
        w20 * w111 + w72 * w4 + w77 * w11 + w27 * w118,
        w25 * w111 + w76 * w4 + w81 * w10 + w32 * w117,
        w30 * w111 + w80 * w4 + w85 * w9 + w37 * w116,
        w35 * w111 + w84 * w4 + w89 * w8 + w42 * w115,
        w40 * w111 + w88 * w4 + w93 * w7 + w47 * w114,
        w45 * w111 + w92 * w4 + w97 * w6 + w52 * w113,
        w50 * w111 + w96 * w4 + w101 * w5 + w57 * w112,
        w55 * w111 + w100 * w4,
        w1 * (w15 * w121 + w131) + w17 * (w15 * w132 + w142),
        w73 * w131 - w66 * w133 - (c29 * w132 + (w70 * w121 + w18 * w132)) - (w110 * w122 - w22 * w142),
        w20 * w134 + w72 * w123 + w77 * w130 + w27 * w141,
        w25 * w134 + w76 * w123 + w81 * w129 + w32 * w140,
        w30 * w134 + w80 * w123 + w85 * w128 + w37 * w139,
        w35 * w134 + w84 * w123 + w89 * w127 + w42 * w138,
        w40 * w134 + w88 * w123 + w93 * w126 + w47 * w137,
        w45 * w134 + w92 * w123 + w97 * w125 + w52 * w136,
        w50 * w134 + w96 * w123 + w101 * w124 + w57 * w135,
        w55 * w134 + w100 * w123,
        w1 * w153 + w17 * w164,
        w73 * w153 + w22 * w164,
        w77 * w152 - w65 * w155 - (c29 * w154 + (w74 * w143 + w23 * w154)) - (w109 * w144 - w27 * w163),
        w25 * w156 + w76 * w145 + w81 * w151 + w32 * w162,
        w30 * w156 + w80 * w145 + w85 * w150 + w37 * w161,
        w35 * w156 + w84 * w145 + w89 * w149 + w42 * w160,
        w40 * w156 + w88 * w145 + w93 * w148 + w47 * w159,
        w45 * w156 + w92 * w145 + w97 * w147 + w52 * w158,
        w50 * w156 + w96 * w145 + w101 * w146 + w57 * w157,
        w55 * w156 + w100 * w145,
        w1 * w174 + w17 * w184,
        w73 * w174 + w22 * w184,
        w77 * w174 + w27 * w184,
        w81 * w173 - w64 * w176 - (c29 * w175 + (w78 * w165 + w28 * w175)) - (w108 * w166 - w32 * w183),
        w30 * w177 + w80 * w167 + w85 * w172 + w37 * w182,
        w35 * w177 + w84 * w167 + w89 * w171 + w42 * w181,
        w40 * w177 + w88 * w167 + w93 * w170 + w47 * w180,
        w45 * w177 + w92 * w167 + w97 * w169 + w52 * w179,
        w50 * w177 + w96 * w167 + w101 * w168 + w57 * w178,
        w55 * w177 + w100 * w167,
        w1 * w193 + w17 * w202,
        w73 * w193 + w22 * w202,
        w77 * w193 + w27 * w202,
        w81 * w193 + w32 * w202,
        w85 * w192 - w63 * w195 - (c29 * w194 + (w82 * w185 + w33 * w194)) - (w107 * w186 - w37 * w201),
        w35 * w196 + w84 * w187 + w89 * w191 + w42 * w200,
        w40 * w196 + w88 * w187 + w93 * w190 + w47 * w199,
        w45 * w196 + w92 * w187 + w97 * w189 + w52 * w198,
        w50 * w196 + w96 * w187 + w101 * w188 + w57 * w197,
        w55 * w196 + w100 * w187,
        w1 * w210 + w17 * w218,
        w73 * w210 + w22 * w218,
        w77 * w210 + w27 * w218,
        w81 * w210 + w32 * w218,
        w85 * w210 + w37 * w218,
        w89 * w209 - w62 * w212 - (c29 * w211 + (w86 * w203 + w38 * w211)) - (w106 * w204 - w42 * w217),
        w40 * w213 + w88 * w205 + w93 * w208 + w47 * w216,
        w45 * w213 + w92 * w205 + w97 * w207 + w52 * w215,
        w50 * w213 + w96 * w205 + w101 * w206 + w57 * w214,
        w55 * w213 + w100 * w205,
        w1 * w225 + w17 * w232,
        w73 * w225 + w22 * w232,
        w77 * w225 + w27 * w232,
        w81 * w225 + w32 * w232,
        w85 * w225 + w37 * w232,
        w89 * w225 + w42 * w232,
        w93 * w224 - w61 * w227 - (c29 * w226 + (w90 * w219 + w43 * w226)) - (w105 * w220 - w47 * w231),
        w45 * w228 + w92 * w221 + w97 * w223 + w52 * w230,
        w50 * w228 + w96 * w221 + w101 * w222 + w57 * w229,
        w55 * w228 + w100 * w221,
        w1 * w238 + w17 * w244,
        w73 * w238 + w22 * w244,
        w77 * w238 + w27 * w244,
        w81 * w238 + w32 * w244,
        w85 * w238 + w37 * w244,
        w89 * w238 + w42 * w244,
        w93 * w238 + w47 * w244,
        w97 * w237 - w60 * w240 - (c29 * w239 + (w94 * w233 + w48 * w239)) - (w104 * w234 - w52 * w243),
        w50 * w241 + w96 * w235 + w101 * w236 + w57 * w242,
        w55 * w241 + w100 * w235,
        w1 * w249 + w17 * w254,
        w73 * w249 + w22 * w254,
        w77 * w249 + w27 * w254,
        w81 * w249 + w32 * w254,
        w85 * w249 + w37 * w254,
        w89 * w249 + w42 * w254,
        w93 * w249 + w47 * w254,
        w97 * w249 + w52 * w254,
        w101 * w248 - w59 * w251 - (c29 * w250 + (w98 * w245 + w53 * w250)) - (w103 * w246 - w57 * w253),
        w55 * w252 + w100 * w247,
        w1 * w256 + w17 * w258,
        w73 * w256 + w22 * w258,
        w77 * w256 + w27 * w258,
        w81 * w256 + w32 * w258,
        w85 * w256 + w37 * w258,
        w89 * w256 + w42 * w258,
        w93 * w256 + w47 * w258,
        w97 * w256 + w52 * w258,
        w101 * w256 + w57 * w258,
        -(c29 * w257 + (w102 * w255 + w58 * w257)),
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 10, 10)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 870 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link10_theta = q_i[9]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[1]
    link3_theta_dot = q_i_dot[2]
    link4_theta_dot = q_i_dot[3]
    link5_theta_dot = q_i_dot[4]
    link6_theta_dot = q_i_dot[5]
    link7_theta_dot = q_i_dot[6]
    link8_theta_dot = q_i_dot[7]
    link9_theta_dot = q_i_dot[8]
    link10_theta_dot = q_i_dot[9]
    c0 = c[0]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c31 = c[31]
    c33 = c[33]
    c35 = c[35]
    c37 = c[37]
    c39 = c[39]
    c41 = c[41]
    c43 = c[43]
    c45 = c[45]
    w0 = ca.cos(link1_theta) * c0
    w1 = ca.sin(link1_theta) * c0
    w2 = 2 * link1_theta_dot
    w3 = w1 * w2
    w4 = c18 * w3
    w5 = c45 * w3 + w4
    w6 = c43 * w3 + w5
    w7 = c41 * w3 + w6
    w8 = c39 * w3 + w7
    w9 = c37 * w3 + w8
    w10 = c35 * w3 + w9
    w11 = c33 * w3 + w10
    w12 = w0 * w2
    w13 = c18 * w12
    w14 = c45 * w12 + w13
    w15 = c43 * w12 + w14
    w16 = c41 * w12 + w15
    w17 = c39 * w12 + w16
    w18 = c37 * w12 + w17
    w19 = c35 * w12 + w18
    w20 = c33 * w12 + w19
    w21 = ca.cos(link2_theta)
    w22 = w21 * c0
    w23 = ca.sin(link2_theta)
    w24 = w23 * c3
    w25 = w21 * c3
    w26 = w23 * c0
    w27 = ca.cos(link3_theta)
    w28 = w27 * c0
    w29 = ca.sin(link3_theta)
    w30 = w29 * c5
    w31 = w27 * c5
    w32 = w29 * c0
    w33 = ca.cos(link4_theta)
    w34 = w33 * c0
    w35 = ca.sin(link4_theta)
    w36 = w35 * c7
    w37 = w33 * c7
    w38 = w35 * c0
    w39 = ca.cos(link5_theta)
    w40 = w39 * c0
    w41 = ca.sin(link5_theta)
    w42 = w41 * c9
    w43 = w39 * c9
    w44 = w41 * c0
    w45 = ca.cos(link6_theta)
    w46 = w45 * c0
    w47 = ca.sin(link6_theta)
    w48 = w47 * c11
    w49 = w45 * c11
    w50 = w47 * c0
    w51 = ca.cos(link7_theta)
    w52 = w51 * c0
    w53 = ca.sin(link7_theta)
    w54 = w53 * c13
    w55 = w51 * c13
    w56 = w53 * c0
    w57 = ca.cos(link8_theta)
    w58 = w57 * c0
    w59 = ca.sin(link8_theta)
    w60 = w59 * c15
    w61 = w57 * c15
    w62 = w59 * c0
    w63 = ca.cos(link9_theta)
    w64 = w63 * c0
    w65 = ca.sin(link9_theta)
    w66 = w65 * c17
    w67 = w63 * c17
    w68 = w65 * c0
    w69 = ca.sin(link10_theta) * c19
    w70 = ca.cos(link10_theta) * c19
    w71 = 2 * link2_theta_dot
    w72 = w26 * w71
    w73 = c18 * w72
    w74 = c45 * w72 + w73
    w75 = c43 * w72 + w74
    w76 = c41 * w72 + w75
    w77 = c39 * w72 + w76
    w78 = c37 * w72 + w77
    w79 = c35 * w72 + w78
    w80 = c33 * w72 + w79
    w81 = w22 * w71
    w82 = c18 * w81
    w83 = c45 * w81 + w82
    w84 = c43 * w81 + w83
    w85 = c41 * w81 + w84
    w86 = c39 * w81 + w85
    w87 = c37 * w81 + w86
    w88 = c35 * w81 + w87
    w89 = c33 * w81 + w88
    w90 = 2 * link3_theta_dot
    w91 = w32 * w90
    w92 = c18 * w91
    w93 = c45 * w91 + w92
    w94 = c43 * w91 + w93
    w95 = c41 * w91 + w94
    w96 = c39 * w91 + w95
    w97 = c37 * w91 + w96
    w98 = c35 * w91 + w97
    w99 = w30 * w90 + w98
    w100 = w28 * w90
    w101 = c18 * w100
    w102 = c45 * w100 + w101
    w103 = c43 * w100 + w102
    w104 = c41 * w100 + w103
    w105 = c39 * w100 + w104
    w106 = c37 * w100 + w105
    w107 = c35 * w100 + w106
    w108 = w31 * w90 + w107
    w109 = 2 * link4_theta_dot
    w110 = w38 * w109
    w111 = c18 * w110
    w112 = c45 * w110 + w111
    w113 = c43 * w110 + w112
    w114 = c41 * w110 + w113
    w115 = c39 * w110 + w114
    w116 = c37 * w110 + w115
    w117 = w36 * w109 + w116
    w118 = w34 * w109
    w119 = c18 * w118
    w120 = c45 * w118 + w119
    w121 = c43 * w118 + w120
    w122 = c41 * w118 + w121
    w123 = c39 * w118 + w122
    w124 = c37 * w118 + w123
    w125 = w37 * w109 + w124
    w126 = 2 * link5_theta_dot
    w127 = w44 * w126
    w128 = c18 * w127
    w129 = c45 * w127 + w128
    w130 = c43 * w127 + w129
    w131 = c41 * w127 + w130
    w132 = c39 * w127 + w131
    w133 = w42 * w126 + w132
    w134 = w40 * w126
    w135 = c18 * w134
    w136 = c45 * w134 + w135
    w137 = c43 * w134 + w136
    w138 = c41 * w134 + w137
    w139 = c39 * w134 + w138
    w140 = w43 * w126 + w139
    w141 = 2 * link6_theta_dot
    w142 = w50 * w141
    w143 = c18 * w142
    w144 = c45 * w142 + w143
    w145 = c43 * w142 + w144
    w146 = c41 * w142 + w145
    w147 = w48 * w141 + w146
    w148 = w46 * w141
    w149 = c18 * w148
    w150 = c45 * w148 + w149
    w151 = c43 * w148 + w150
    w152 = c41 * w148 + w151
    w153 = w49 * w141 + w152
    w154 = 2 * link7_theta_dot
    w155 = w56 * w154
    w156 = c18 * w155
    w157 = c45 * w155 + w156
    w158 = c43 * w155 + w157
    w159 = w54 * w154 + w158
    w160 = w52 * w154
    w161 = c18 * w160
    w162 = c45 * w160 + w161
    w163 = c43 * w160 + w162
    w164 = w55 * w154 + w163
    w165 = 2 * link8_theta_dot
    w166 = w62 * w165
    w167 = c18 * w166
    w168 = c45 * w166 + w167
    w169 = w60 * w165 + w168
    w170 = w58 * w165
    w171 = c18 * w170
    w172 = c45 * w170 + w171
    w173 = w61 * w165 + w172
    w174 = 2 * link9_theta_dot
    w175 = w68 * w174
    w176 = c18 * w175
    w177 = w66 * w174 + w176
    w178 = w64 * w174
    w179 = c18 * w178
    w180 = w67 * w174 + w179
    w181 = 2 * link10_theta_dot
    w182 = w69 * w181
    w183 = w70 * w181
    dQ_hat_dq_i_dot = ca.vertcat(
        w0 * (c31 * w3 + w11) - w1 * (c31 * w12 + w20),
        w22 * w11 - (w24 * w12 - w25 * w3) - w26 * w20,
        w28 * w10 - (w30 * w12 - w31 * w3) - w32 * w19,
        w34 * w9 - (w36 * w12 - w37 * w3) - w38 * w18,
        w40 * w8 - (w42 * w12 - w43 * w3) - w44 * w17,
        w46 * w7 - (w48 * w12 - w49 * w3) - w50 * w16,
        w52 * w6 - (w54 * w12 - w55 * w3) - w56 * w15,
        w58 * w5 - (w60 * w12 - w61 * w3) - w62 * w14,
        w64 * w4 - (w66 * w12 - w67 * w3) - w68 * w13,
        -(w69 * w12 - w70 * w3),
        w0 * (w24 * w71 + w80) - w1 * (w25 * w71 + w89),
        w22 * w80 - w26 * w89,
        w28 * w79 - (w30 * w81 - w31 * w72) - w32 * w88,
        w34 * w78 - (w36 * w81 - w37 * w72) - w38 * w87,
        w40 * w77 - (w42 * w81 - w43 * w72) - w44 * w86,
        w46 * w76 - (w48 * w81 - w49 * w72) - w50 * w85,
        w52 * w75 - (w54 * w81 - w55 * w72) - w56 * w84,
        w58 * w74 - (w60 * w81 - w61 * w72) - w62 * w83,
        w64 * w73 - (w66 * w81 - w67 * w72) - w68 * w82,
        -(w69 * w81 - w70 * w72),
        w0 * w99 - w1 * w108,
        w22 * w99 - w26 * w108,
        w28 * w98 - w32 * w107,
        w34 * w97 - (w36 * w100 - w37 * w91) - w38 * w106,
        w40 * w96 - (w42 * w100 - w43 * w91) - w44 * w105,
        w46 * w95 - (w48 * w100 - w49 * w91) - w50 * w104,
        w52 * w94 - (w54 * w100 - w55 * w91) - w56 * w103,
        w58 * w93 - (w60 * w100 - w61 * w91) - w62 * w102,
        w64 * w92 - (w66 * w100 - w67 * w91) - w68 * w101,
        -(w69 * w100 - w70 * w91),
        w0 * w117 - w1 * w125,
        w22 * w117 - w26 * w125,
        w28 * w117 - w32 * w125,
        w34 * w116 - w38 * w124,
        w40 * w115 - (w42 * w118 - w43 * w110) - w44 * w123,
        w46 * w114 - (w48 * w118 - w49 * w110) - w50 * w122,
        w52 * w113 - (w54 * w118 - w55 * w110) - w56 * w121,
        w58 * w112 - (w60 * w118 - w61 * w110) - w62 * w120,
        w64 * w111 - (w66 * w118 - w67 * w110) - w68 * w119,
        -(w69 * w118 - w70 * w110),
        w0 * w133 - w1 * w140,
        w22 * w133 - w26 * w140,
        w28 * w133 - w32 * w140,
        w34 * w133 - w38 * w140,
        w40 * w132 - w44 * w139,
        w46 * w131 - (w48 * w134 - w49 * w127) - w50 * w138,
        w52 * w130 - (w54 * w134 - w55 * w127) - w56 * w137,
        w58 * w129 - (w60 * w134 - w61 * w127) - w62 * w136,
        w64 * w128 - (w66 * w134 - w67 * w127) - w68 * w135,
        -(w69 * w134 - w70 * w127),
        w0 * w147 - w1 * w153,
        w22 * w147 - w26 * w153,
        w28 * w147 - w32 * w153,
        w34 * w147 - w38 * w153,
        w40 * w147 - w44 * w153,
        w46 * w146 - w50 * w152,
        w52 * w145 - (w54 * w148 - w55 * w142) - w56 * w151,
        w58 * w144 - (w60 * w148 - w61 * w142) - w62 * w150,
        w64 * w143 - (w66 * w148 - w67 * w142) - w68 * w149,
        -(w69 * w148 - w70 * w142),
        w0 * w159 - w1 * w164,
        w22 * w159 - w26 * w164,
        w28 * w159 - w32 * w164,
        w34 * w159 - w38 * w164,
        w40 * w159 - w44 * w164,
        w46 * w159 - w50 * w164,
        w52 * w158 - w56 * w163,
        w58 * w157 - (w60 * w160 - w61 * w155) - w62 * w162,
        w64 * w156 - (w66 * w160 - w67 * w155) - w68 * w161,
        -(w69 * w160 - w70 * w155),
        w0 * w169 - w1 * w173,
        w22 * w169 - w26 * w173,
        w28 * w169 - w32 * w173,
        w34 * w169 - w38 * w173,
        w40 * w169 - w44 * w173,
        w46 * w169 - w50 * w173,
        w52 * w169 - w56 * w173,
        w58 * w168 - w62 * w172,
        w64 * w167 - (w66 * w170 - w67 * w166) - w68 * w171,
        -(w69 * w170 - w70 * w166),
        w0 * w177 - w1 * w180,
        w22 * w177 - w26 * w180,
        w28 * w177 - w32 * w180,
        w34 * w177 - w38 * w180,
        w40 * w177 - w44 * w180,
        w46 * w177 - w50 * w180,
        w52 * w177 - w56 * w180,
        w58 * w177 - w62 * w180,
        w64 * w176 - w68 * w179,
        -(w69 * w178 - w70 * w175),
        w0 * w182 - w1 * w183,
        w22 * w182 - w26 * w183,
        w28 * w182 - w32 * w183,
        w34 * w182 - w38 * w183,
        w40 * w182 - w44 * w183,
        w46 * w182 - w50 * w183,
        w52 * w182 - w56 * w183,
        w58 * w182 - w62 * w183,
        w64 * w182 - w68 * w183,
        0.0,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 10, 10)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 1061 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 50)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link10_theta = q_i[9]
    link1_theta_ddot = q_i_ddot[0]
    link2_theta_ddot = q_i_ddot[1]
    link3_theta_ddot = q_i_ddot[2]
    link4_theta_ddot = q_i_ddot[3]
    link5_theta_ddot = q_i_ddot[4]
    link6_theta_ddot = q_i_ddot[5]
    link7_theta_ddot = q_i_ddot[6]
    link8_theta_ddot = q_i_ddot[7]
    link9_theta_ddot = q_i_ddot[8]
    link10_theta_ddot = q_i_ddot[9]
    c0 = c[0]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c31 = c[31]
    c33 = c[33]
    c35 = c[35]
    c37 = c[37]
    c39 = c[39]
    c41 = c[41]
    c43 = c[43]
    c45 = c[45]
    w0 = ca.sin(link1_theta)
    w1 = w0 * c0
    w2 = ca.cos(link1_theta)
    w3 = c0 * w2
    w4 = link1_theta_ddot * w3
    w5 = c18 * w4
    w6 = c45 * w4 + w5
    w7 = c43 * w4 + w6
    w8 = c41 * w4 + w7
    w9 = c39 * w4 + w8
    w10 = c37 * w4 + w9
    w11 = c35 * w4 + w10
    w12 = c33 * w4 + w11
    w13 = w1 * link1_theta_ddot
    w14 = ca.sin(link2_theta)
    w15 = w14 * c3
    w16 = w14 * c0
    w17 = w13 + w16 * link2_theta_ddot
    w18 = ca.sin(link3_theta)
    w19 = w18 * c5
    w20 = w18 * c0
    w21 = w17 + w20 * link3_theta_ddot
    w22 = ca.sin(link4_theta)
    w23 = w22 * c7
    w24 = w22 * c0
    w25 = w21 + w24 * link4_theta_ddot
    w26 = ca.sin(link5_theta)
    w27 = w26 * c9
    w28 = w26 * c0
    w29 = w25 + w28 * link5_theta_ddot
    w30 = ca.sin(link6_theta)
    w31 = w30 * c11
    w32 = w30 * c0
    w33 = w29 + w32 * link6_theta_ddot
    w34 = ca.sin(link7_theta)
    w35 = w34 * c13
    w36 = w34 * c0
    w37 = w33 + w36 * link7_theta_ddot
    w38 = ca.sin(link8_theta)
    w39 = w38 * c15
    w40 = w38 * c0
    w41 = w37 + w40 * link8_theta_ddot
    w42 = ca.sin(link9_theta)
    w43 = w42 * c17
    w44 = w42 * c0
    w45 = w41 + w44 * link9_theta_ddot
    w46 = ca.sin(link10_theta)
    w47 = w46 * c19
    w48 = c18 * w45 + w47 * link10_theta_ddot
    w49 = c45 * w41 + w43 * link9_theta_ddot + w48
    w50 = c43 * w37 + w39 * link8_theta_ddot + w49
    w51 = c41 * w33 + w35 * link7_theta_ddot + w50
    w52 = c39 * w29 + w31 * link6_theta_ddot + w51
    w53 = c37 * w25 + w27 * link5_theta_ddot + w52
    w54 = c35 * w21 + w23 * link4_theta_ddot + w53
    w55 = c33 * w17 + w19 * link3_theta_ddot + w54
    w56 = w2 * c0
    w57 = c0 * w0
    w58 = link1_theta_ddot * w57
    w59 = c18 * w58
    w60 = c45 * w58 + w59
    w61 = c43 * w58 + w60
    w62 = c41 * w58 + w61
    w63 = c39 * w58 + w62
    w64 = c37 * w58 + w63
    w65 = c35 * w58 + w64
    w66 = c33 * w58 + w65
    w67 = w56 * link1_theta_ddot
    w68 = ca.cos(link2_theta)
    w69 = w68 * c3
    w70 = w68 * c0
    w71 = w67 + w70 * link2_theta_ddot
    w72 = ca.cos(link3_theta)
    w73 = w72 * c5
    w74 = w72 * c0
    w75 = w71 + w74 * link3_theta_ddot
    w76 = ca.cos(link4_theta)
    w77 = w76 * c7
    w78 = w76 * c0
    w79 = w75 + w78 * link4_theta_ddot
    w80 = ca.cos(link5_theta)
    w81 = w80 * c9
    w82 = w80 * c0
    w83 = w79 + w82 * link5_theta_ddot
    w84 = ca.cos(link6_theta)
    w85 = w84 * c11
    w86 = w84 * c0
    w87 = w83 + w86 * link6_theta_ddot
    w88 = ca.cos(link7_theta)
    w89 = w88 * c13
    w90 = w88 * c0
    w91 = w87 + w90 * link7_theta_ddot
    w92 = ca.cos(link8_theta)
    w93 = w92 * c15
    w94 = w92 * c0
    w95 = w91 + w94 * link8_theta_ddot
    w96 = ca.cos(link9_theta)
    w97 = w96 * c17
    w98 = w96 * c0
    w99 = w95 + w98 * link9_theta_ddot
    w100 = ca.cos(link10_theta)
    w101 = w100 * c19
    w102 = c18 * w99 + w101 * link10_theta_ddot
    w103 = c45 * w95 + w97 * link9_theta_ddot + w102
    w104 = c43 * w91 + w93 * link8_theta_ddot + w103
    w105 = c41 * w87 + w89 * link7_theta_ddot + w104
    w106 = c39 * w83 + w85 * link6_theta_ddot + w105
    w107 = c37 * w79 + w81 * link5_theta_ddot + w106
    w108 = c35 * w75 + w77 * link4_theta_ddot + w107
    w109 = c33 * w71 + w73 * link3_theta_ddot + w108
    w110 = w1 * (c31 * w4 + w12) + (c31 * w13 + w15 * link2_theta_ddot + w55) * w3 - (w56 * (c31 * w58 + w66) + (c31 * w67 + w69 * link2_theta_ddot + w109) * w57)
    w111 = c3 * w68
    w112 = c0 * w68
    w113 = link2_theta_ddot * w112
    w114 = c18 * w113
    w115 = c45 * w113 + w114
    w116 = c43 * w113 + w115
    w117 = c41 * w113 + w116
    w118 = c39 * w113 + w117
    w119 = c37 * w113 + w118
    w120 = c35 * w113 + w119
    w121 = c33 * w113 + w120
    w122 = c3 * w14
    w123 = c0 * w14
    w124 = link2_theta_ddot * w123
    w125 = c18 * w124
    w126 = c45 * w124 + w125
    w127 = c43 * w124 + w126
    w128 = c41 * w124 + w127
    w129 = c39 * w124 + w128
    w130 = c37 * w124 + w129
    w131 = c35 * w124 + w130
    w132 = c33 * w124 + w131
    w133 = c5 * w72
    w134 = c0 * w72
    w135 = link3_theta_ddot * w134
    w136 = c18 * w135
    w137 = c45 * w135 + w136
    w138 = c43 * w135 + w137
    w139 = c41 * w135 + w138
    w140 = c39 * w135 + w139
    w141 = c37 * w135 + w140
    w142 = c35 * w135 + w141
    w143 = link3_theta_ddot * w133 + w142
    w144 = c5 * w18
    w145 = c0 * w18
    w146 = link3_theta_ddot * w145
    w147 = c18 * w146
    w148 = c45 * w146 + w147
    w149 = c43 * w146 + w148
    w150 = c41 * w146 + w149
    w151 = c39 * w146 + w150
    w152 = c37 * w146 + w151
    w153 = c35 * w146 + w152
    w154 = link3_theta_ddot * w144 + w153
    w155 = c7 * w76
    w156 = c0 * w76
    w157 = link4_theta_ddot * w156
    w158 = c18 * w157
    w159 = c45 * w157 + w158
    w160 = c43 * w157 + w159
    w161 = c41 * w157 + w160
    w162 = c39 * w157 + w161
    w163 = c37 * w157 + w162
    w164 = link4_theta_ddot * w155 + w163
    w165 = c7 * w22
    w166 = c0 * w22
    w167 = link4_theta_ddot * w166
    w168 = c18 * w167
    w169 = c45 * w167 + w168
    w170 = c43 * w167 + w169
    w171 = c41 * w167 + w170
    w172 = c39 * w167 + w171
    w173 = c37 * w167 + w172
    w174 = link4_theta_ddot * w165 + w173
    w175 = c9 * w80
    w176 = c0 * w80
    w177 = link5_theta_ddot * w176
    w178 = c18 * w177
    w179 = c45 * w177 + w178
    w180 = c43 * w177 + w179
    w181 = c41 * w177 + w180
    w182 = c39 * w177 + w181
    w183 = link5_theta_ddot * w175 + w182
    w184 = c9 * w26
    w185 = c0 * w26
    w186 = link5_theta_ddot * w185
    w187 = c18 * w186
    w188 = c45 * w186 + w187
    w189 = c43 * w186 + w188
    w190 = c41 * w186 + w189
    w191 = c39 * w186 + w190
    w192 = link5_theta_ddot * w184 + w191
    w193 = c11 * w84
    w194 = c0 * w84
    w195 = link6_theta_ddot * w194
    w196 = c18 * w195
    w197 = c45 * w195 + w196
    w198 = c43 * w195 + w197
    w199 = c41 * w195 + w198
    w200 = link6_theta_ddot * w193 + w199
    w201 = c11 * w30
    w202 = c0 * w30
    w203 = link6_theta_ddot * w202
    w204 = c18 * w203
    w205 = c45 * w203 + w204
    w206 = c43 * w203 + w205
    w207 = c41 * w203 + w206
    w208 = link6_theta_ddot * w201 + w207
    w209 = c13 * w88
    w210 = c0 * w88
    w211 = link7_theta_ddot * w210
    w212 = c18 * w211
    w213 = c45 * w211 + w212
    w214 = c43 * w211 + w213
    w215 = link7_theta_ddot * w209 + w214
    w216 = c13 * w34
    w217 = c0 * w34
    w218 = link7_theta_ddot * w217
    w219 = c18 * w218
    w220 = c45 * w218 + w219
    w221 = c43 * w218 + w220
    w222 = link7_theta_ddot * w216 + w221
    w223 = c15 * w92
    w224 = c0 * w92
    w225 = link8_theta_ddot * w224
    w226 = c18 * w225
    w227 = c45 * w225 + w226
    w228 = link8_theta_ddot * w223 + w227
    w229 = c15 * w38
    w230 = c0 * w38
    w231 = link8_theta_ddot * w230
    w232 = c18 * w231
    w233 = c45 * w231 + w232
    w234 = link8_theta_ddot * w229 + w233
    w235 = c17 * w96
    w236 = c0 * w96
    w237 = link9_theta_ddot * w236
    w238 = c18 * w237
    w239 = link9_theta_ddot * w235 + w238
    w240 = c17 * w42
    w241 = c0 * w42
    w242 = link9_theta_ddot * w241
    w243 = c18 * w242
    w244 = link9_theta_ddot * w240 + w243
    w245 = c19 * w100
    w246 = link10_theta_ddot * w245
    w247 = c19 * w46
    w248 = link10_theta_ddot * w247
    dMa_dq_i = ca.vertcat(
        w110,
        w15 * w4 - w69 * w58 - w70 * w66 + w16 * w12,
        w19 * w4 - w73 * w58 - w74 * w65 + w20 * w11,
        w23 * w4 - w77 * w58 - w78 * w64 + w24 * w10,
        w27 * w4 - w81 * w58 - w82 * w63 + w28 * w9,
        w31 * w4 - w85 * w58 - w86 * w62 + w32 * w8,
        w35 * w4 - w89 * w58 - w90 * w61 + w36 * w7,
        w39 * w4 - w93 * w58 - w94 * w60 + w40 * w6,
        w43 * w4 - w97 * w58 - w98 * w59 + w44 * w5,
        w47 * w4 - w101 * w58,
        w1 * (link2_theta_ddot * w111 + w121) - w56 * (link2_theta_ddot * w122 + w132),
        w13 * w111 - w67 * w122 - (w70 * w132 + w109 * w123) + (w16 * w121 + w55 * w112),
        w19 * w113 - w73 * w124 - w74 * w131 + w20 * w120,
        w23 * w113 - w77 * w124 - w78 * w130 + w24 * w119,
        w27 * w113 - w81 * w124 - w82 * w129 + w28 * w118,
        w31 * w113 - w85 * w124 - w86 * w128 + w32 * w117,
        w35 * w113 - w89 * w124 - w90 * w127 + w36 * w116,
        w39 * w113 - w93 * w124 - w94 * w126 + w40 * w115,
        w43 * w113 - w97 * w124 - w98 * w125 + w44 * w114,
        w47 * w113 - w101 * w124,
        w1 * w143 - w56 * w154,
        w16 * w143 - w70 * w154,
        w17 * w133 - w71 * w144 - (w74 * w153 + w108 * w145) + (w20 * w142 + w54 * w134),
        w23 * w135 - w77 * w146 - w78 * w152 + w24 * w141,
        w27 * w135 - w81 * w146 - w82 * w151 + w28 * w140,
        w31 * w135 - w85 * w146 - w86 * w150 + w32 * w139,
        w35 * w135 - w89 * w146 - w90 * w149 + w36 * w138,
        w39 * w135 - w93 * w146 - w94 * w148 + w40 * w137,
        w43 * w135 - w97 * w146 - w98 * w147 + w44 * w136,
        w47 * w135 - w101 * w146,
        w1 * w164 - w56 * w174,
        w16 * w164 - w70 * w174,
        w20 * w164 - w74 * w174,
        w21 * w155 - w75 * w165 - (w78 * w173 + w107 * w166) + (w24 * w163 + w53 * w156),
        w27 * w157 - w81 * w167 - w82 * w172 + w28 * w162,
        w31 * w157 - w85 * w167 - w86 * w171 + w32 * w161,
        w35 * w157 - w89 * w167 - w90 * w170 + w36 * w160,
        w39 * w157 - w93 * w167 - w94 * w169 + w40 * w159,
        w43 * w157 - w97 * w167 - w98 * w168 + w44 * w158,
        w47 * w157 - w101 * w167,
        w1 * w183 - w56 * w192,
        w16 * w183 - w70 * w192,
        w20 * w183 - w74 * w192,
        w24 * w183 - w78 * w192,
        w25 * w175 - w79 * w184 - (w82 * w191 + w106 * w185) + (w28 * w182 + w52 * w176),
        w31 * w177 - w85 * w186 - w86 * w190 + w32 * w181,
        w35 * w177 - w89 * w186 - w90 * w189 + w36 * w180,
        w39 * w177 - w93 * w186 - w94 * w188 + w40 * w179,
        w43 * w177 - w97 * w186 - w98 * w187 + w44 * w178,
        w47 * w177 - w101 * w186,
        w1 * w200 - w56 * w208,
        w16 * w200 - w70 * w208,
        w20 * w200 - w74 * w208,
        w24 * w200 - w78 * w208,
        w28 * w200 - w82 * w208,
        w29 * w193 - w83 * w201 - (w86 * w207 + w105 * w202) + (w32 * w199 + w51 * w194),
        w35 * w195 - w89 * w203 - w90 * w206 + w36 * w198,
        w39 * w195 - w93 * w203 - w94 * w205 + w40 * w197,
        w43 * w195 - w97 * w203 - w98 * w204 + w44 * w196,
        w47 * w195 - w101 * w203,
        w1 * w215 - w56 * w222,
        w16 * w215 - w70 * w222,
        w20 * w215 - w74 * w222,
        w24 * w215 - w78 * w222,
        w28 * w215 - w82 * w222,
        w32 * w215 - w86 * w222,
        w33 * w209 - w87 * w216 - (w90 * w221 + w104 * w217) + (w36 * w214 + w50 * w210),
        w39 * w211 - w93 * w218 - w94 * w220 + w40 * w213,
        w43 * w211 - w97 * w218 - w98 * w219 + w44 * w212,
        w47 * w211 - w101 * w218,
        w1 * w228 - w56 * w234,
        w16 * w228 - w70 * w234,
        w20 * w228 - w74 * w234,
        w24 * w228 - w78 * w234,
        w28 * w228 - w82 * w234,
        w32 * w228 - w86 * w234,
        w36 * w228 - w90 * w234,
        w37 * w223 - w91 * w229 - (w94 * w233 + w103 * w230) + (w40 * w227 + w49 * w224),
        w43 * w225 - w97 * w231 - w98 * w232 + w44 * w226,
        w47 * w225 - w101 * w231,
        w1 * w239 - w56 * w244,
        w16 * w239 - w70 * w244,
        w20 * w239 - w74 * w244,
        w24 * w239 - w78 * w244,
        w28 * w239 - w82 * w244,
        w32 * w239 - w86 * w244,
        w36 * w239 - w90 * w244,
        w40 * w239 - w94 * w244,
        w41 * w235 - w95 * w240 - (w98 * w243 + w102 * w241) + (w44 * w238 + w48 * w236),
        w47 * w237 - w101 * w242,
        w1 * w246 - w56 * w248,
        w16 * w246 - w70 * w248,
        w20 * w246 - w74 * w248,
        w24 * w246 - w78 * w248,
        w28 * w246 - w82 * w248,
        w32 * w246 - w86 * w248,
        w36 * w246 - w90 * w248,
        w40 * w246 - w94 * w248,
        w44 * w246 - w98 * w248,
        w45 * w245 - w99 * w247,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 10, 10)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


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
    "drawing": drawing,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
}
