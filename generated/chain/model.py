"""Chain of 10 links: equations of motion, emitted by symgen from the scene `chain`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 158 operations."""
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
    w0 = link_length**2 * 0.078 / 12.0
    w1 = link_length / 2.0
    w2 = w1**2
    w3 = w0 + link1_mass * w2
    w4 = link9_mass + link10_mass
    w5 = link8_mass + w4
    w6 = link7_mass + w5
    w7 = link6_mass + w6
    w8 = link5_mass + w7
    w9 = link4_mass + w8
    w10 = link3_mass + w9
    w11 = w1 * link9_mass
    w12 = w0 + w2 * link2_mass
    w13 = w0 + w2 * link3_mass
    w14 = w0 + w2 * link4_mass
    w15 = w0 + w2 * link5_mass
    w16 = w0 + w2 * link6_mass
    w17 = w0 + w2 * link7_mass
    w18 = w0 + w2 * link8_mass
    w19 = w0 + w2 * link9_mass
    w20 = link_length * (link_length * link10_mass)
    w21 = link1_mass * w1
    c = ca.vertcat(
        link_length,
        link2_mass,
        link3_mass,
        link4_mass,
        link5_mass,
        link6_mass,
        link7_mass,
        link8_mass,
        link9_mass,
        link10_mass,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w3 + link_length * (link_length * (link2_mass + w10)),
        w1 * link2_mass,
        w1 * link3_mass,
        w1 * link4_mass,
        w1 * link5_mass,
        w1 * link6_mass,
        w1 * link7_mass,
        w1 * link8_mass,
        w11,
        w1 * link10_mass,
        w12 + link_length * (link_length * w10),
        w13 + link_length * (link_length * w9),
        w14 + link_length * (link_length * w8),
        w15 + link_length * (link_length * w7),
        w16 + link_length * (link_length * w6),
        w17 + link_length * (link_length * w5),
        w18 + link_length * (link_length * w4),
        w19 + w20,
        w0 + w2 * link10_mass,
        gravity_y,
        w21 * gravity_y,
        link2_mass * gravity_y,
        link3_mass * gravity_y,
        link4_mass * gravity_y,
        link5_mass * gravity_y,
        link6_mass * gravity_y,
        link7_mass * gravity_y,
        link8_mass * gravity_y,
        link9_mass * gravity_y,
        link10_mass * gravity_y,
        link1_mass,
        w3,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w21,
        link1_mass * gravity_y,
        w20 + link_length * w11,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 605 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 60)
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
    w0 = ca.cos(link1_theta)
    w1 = w0 * c0
    w2 = ca.sin(link1_theta) * c0
    w3 = ca.cos(link2_theta)
    w4 = w3 * c18
    w5 = w3 * c0
    w6 = ca.sin(link2_theta)
    w7 = w6 * c18
    w8 = w6 * c0
    w9 = w1 * (w4 + w5 * c16) + w2 * (w7 + w8 * c16)
    w10 = ca.cos(link3_theta)
    w11 = w10 * c19
    w12 = w10 * c0
    w13 = w11 + w12 * c15
    w14 = ca.sin(link3_theta)
    w15 = w14 * c19
    w16 = w14 * c0
    w17 = w15 + w16 * c15
    w18 = w1 * w13 + w2 * w17
    w19 = ca.cos(link4_theta)
    w20 = w19 * c20
    w21 = w19 * c0
    w22 = w20 + w21 * c14
    w23 = ca.sin(link4_theta)
    w24 = w23 * c20
    w25 = w23 * c0
    w26 = w24 + w25 * c14
    w27 = w1 * w22 + w2 * w26
    w28 = ca.cos(link5_theta)
    w29 = w28 * c21
    w30 = w28 * c0
    w31 = w29 + w30 * c13
    w32 = ca.sin(link5_theta)
    w33 = w32 * c21
    w34 = w32 * c0
    w35 = w33 + w34 * c13
    w36 = w1 * w31 + w2 * w35
    w37 = ca.cos(link6_theta)
    w38 = w37 * c22
    w39 = w37 * c0
    w40 = w38 + w39 * c12
    w41 = ca.sin(link6_theta)
    w42 = w41 * c22
    w43 = w41 * c0
    w44 = w42 + w43 * c12
    w45 = w1 * w40 + w2 * w44
    w46 = ca.cos(link7_theta)
    w47 = w46 * c23
    w48 = w46 * c0
    w49 = w47 + w48 * c11
    w50 = ca.sin(link7_theta)
    w51 = w50 * c23
    w52 = w50 * c0
    w53 = w51 + w52 * c11
    w54 = w1 * w49 + w2 * w53
    w55 = ca.cos(link8_theta)
    w56 = w55 * c24
    w57 = w55 * c0
    w58 = w56 + w57 * c10
    w59 = ca.sin(link8_theta)
    w60 = w59 * c24
    w61 = w59 * c0
    w62 = w60 + w61 * c10
    w63 = w1 * w58 + w2 * w62
    w64 = ca.cos(link9_theta)
    w65 = w64 * c25
    w66 = w64 * c0
    w67 = w65 + w66 * c9
    w68 = ca.sin(link9_theta)
    w69 = w68 * c25
    w70 = w68 * c0
    w71 = w69 + w70 * c9
    w72 = w1 * w67 + w2 * w71
    w73 = ca.cos(link10_theta) * c26
    w74 = ca.sin(link10_theta) * c26
    w75 = w1 * w73 + w2 * w74
    w76 = w5 * w13 + w8 * w17
    w77 = w5 * w22 + w8 * w26
    w78 = w5 * w31 + w8 * w35
    w79 = w5 * w40 + w8 * w44
    w80 = w5 * w49 + w8 * w53
    w81 = w5 * w58 + w8 * w62
    w82 = w5 * w67 + w8 * w71
    w83 = w5 * w73 + w8 * w74
    w84 = w12 * w22 + w16 * w26
    w85 = w12 * w31 + w16 * w35
    w86 = w12 * w40 + w16 * w44
    w87 = w12 * w49 + w16 * w53
    w88 = w12 * w58 + w16 * w62
    w89 = w12 * w67 + w16 * w71
    w90 = w12 * w73 + w16 * w74
    w91 = w21 * w31 + w25 * w35
    w92 = w21 * w40 + w25 * w44
    w93 = w21 * w49 + w25 * w53
    w94 = w21 * w58 + w25 * w62
    w95 = w21 * w67 + w25 * w71
    w96 = w21 * w73 + w25 * w74
    w97 = w30 * w40 + w34 * w44
    w98 = w30 * w49 + w34 * w53
    w99 = w30 * w58 + w34 * w62
    w100 = w30 * w67 + w34 * w71
    w101 = w30 * w73 + w34 * w74
    w102 = w39 * w49 + w43 * w53
    w103 = w39 * w58 + w43 * w62
    w104 = w39 * w67 + w43 * w71
    w105 = w39 * w73 + w43 * w74
    w106 = w48 * w58 + w52 * w62
    w107 = w48 * w67 + w52 * w71
    w108 = w48 * w73 + w52 * w74
    w109 = w57 * w67 + w61 * w71
    w110 = w57 * w73 + w61 * w74
    w111 = w66 * w73 + w70 * w74
    w112 = link2_theta_dot**2
    w113 = link1_theta_dot**2
    w114 = w2 * w113
    w115 = link3_theta_dot**2
    w116 = w114 + w8 * w112
    w117 = link4_theta_dot**2
    w118 = w116 + w16 * w115
    w119 = link5_theta_dot**2
    w120 = w118 + w25 * w117
    w121 = link6_theta_dot**2
    w122 = w120 + w34 * w119
    w123 = link7_theta_dot**2
    w124 = w122 + w43 * w121
    w125 = link8_theta_dot**2
    w126 = w124 + w52 * w123
    w127 = link9_theta_dot**2
    w128 = w126 + w61 * w125
    w129 = link10_theta_dot**2
    w130 = w128 + w70 * w127
    w131 = w74 * w129 + c46 + w130 * c9
    w132 = w69 * w127 + c45 + w128 * c8 + w131
    w133 = w60 * w125 + c44 + w126 * c7 + w132
    w134 = w51 * w123 + c43 + w124 * c6 + w133
    w135 = w42 * w121 + c42 + w122 * c5 + w134
    w136 = w33 * w119 + c41 + w120 * c4 + w135
    w137 = w24 * w117 + c40 + w118 * c3 + w136
    w138 = w15 * w115 + c39 + w116 * c2 + w137
    w139 = w1 * w113
    w140 = w139 + w5 * w112
    w141 = w140 + w12 * w115
    w142 = w141 + w21 * w117
    w143 = w142 + w30 * w119
    w144 = w143 + w39 * w121
    w145 = w144 + w48 * w123
    w146 = w145 + w57 * w125
    w147 = w146 + w66 * w127
    w148 = w73 * w129 + w147 * c9
    w149 = w65 * w127 + w146 * c8 + w148
    w150 = w56 * w125 + w145 * c7 + w149
    w151 = w47 * w123 + w144 * c6 + w150
    w152 = w38 * w121 + w143 * c5 + w151
    w153 = w29 * w119 + w142 * c4 + w152
    w154 = w20 * w117 + w141 * c3 + w153
    w155 = w11 * w115 + w140 * c2 + w154
    M_hat = ca.vertcat(
        c17,
        w9,
        w18,
        w27,
        w36,
        w45,
        w54,
        w63,
        w72,
        w75,
        w9,
        c27,
        w76,
        w77,
        w78,
        w79,
        w80,
        w81,
        w82,
        w83,
        w18,
        w76,
        c28,
        w84,
        w85,
        w86,
        w87,
        w88,
        w89,
        w90,
        w27,
        w77,
        w84,
        c29,
        w91,
        w92,
        w93,
        w94,
        w95,
        w96,
        w36,
        w78,
        w85,
        w91,
        c30,
        w97,
        w98,
        w99,
        w100,
        w101,
        w45,
        w79,
        w86,
        w92,
        w97,
        c31,
        w102,
        w103,
        w104,
        w105,
        w54,
        w80,
        w87,
        w93,
        w98,
        w102,
        c32,
        w106,
        w107,
        w108,
        w63,
        w81,
        w88,
        w94,
        w99,
        w103,
        w106,
        c33,
        w109,
        w110,
        w72,
        w82,
        w89,
        w95,
        w100,
        w104,
        w107,
        w109,
        c34,
        w111,
        w75,
        w83,
        w90,
        w96,
        w101,
        w105,
        w108,
        w110,
        w111,
        c35,
    )
    M_hat = ca.reshape(M_hat, 10, 10)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w0 * c37 + w1 * (w7 * w112 + c38 + w114 * c1 + w138) - w2 * (w4 * w112 + w139 * c1 + w155),
        w4 * c36 - (w7 * w139 - w4 * w114) + w5 * w138 - w8 * w155,
        w11 * c36 - (w15 * w140 - w11 * w116) + w12 * w137 - w16 * w154,
        w20 * c36 - (w24 * w141 - w20 * w118) + w21 * w136 - w25 * w153,
        w29 * c36 - (w33 * w142 - w29 * w120) + w30 * w135 - w34 * w152,
        w38 * c36 - (w42 * w143 - w38 * w122) + w39 * w134 - w43 * w151,
        w47 * c36 - (w51 * w144 - w47 * w124) + w48 * w133 - w52 * w150,
        w56 * c36 - (w60 * w145 - w56 * w126) + w57 * w132 - w61 * w149,
        w65 * c36 - (w69 * w146 - w65 * w128) + w66 * w131 - w70 * w148,
        w73 * c36 - (w74 * w147 - w73 * w130),
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 83 operations."""
    q_i = ca.SX.sym("q_i", 10)
    c = ca.SX.sym("c", 60)
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
    c = ca.SX.sym("c", 60)
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
    w1 = link1_theta_dot * (ca.cos(link1_theta) * c0)
    w2 = w0 + ca.sin(link2_theta) * c0 * link2_theta_dot
    w3 = w1 + link2_theta_dot * (ca.cos(link2_theta) * c0)
    w4 = w2 + ca.sin(link3_theta) * c0 * link3_theta_dot
    w5 = w3 + link3_theta_dot * (ca.cos(link3_theta) * c0)
    w6 = w4 + ca.sin(link4_theta) * c0 * link4_theta_dot
    w7 = w5 + link4_theta_dot * (ca.cos(link4_theta) * c0)
    w8 = w6 + ca.sin(link5_theta) * c0 * link5_theta_dot
    w9 = w7 + link5_theta_dot * (ca.cos(link5_theta) * c0)
    w10 = w8 + ca.sin(link6_theta) * c0 * link6_theta_dot
    w11 = w9 + link6_theta_dot * (ca.cos(link6_theta) * c0)
    w12 = w10 + ca.sin(link7_theta) * c0 * link7_theta_dot
    w13 = w11 + link7_theta_dot * (ca.cos(link7_theta) * c0)
    w14 = w12 + ca.sin(link8_theta) * c0 * link8_theta_dot
    w15 = w13 + link8_theta_dot * (ca.cos(link8_theta) * c0)
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
        w15 + link9_theta_dot * (ca.cos(link9_theta) * c0),
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 173 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 60)
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
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c0
    w2 = ca.sin(link1_theta) * c0
    w3 = w0 * w1 + w2 * link1_theta_ddot
    w4 = w1 * link1_theta_ddot - w0 * w2
    w5 = link2_theta_dot**2
    w6 = ca.cos(link2_theta) * c0
    w7 = ca.sin(link2_theta) * c0
    w8 = w3 + w5 * w6 + w7 * link2_theta_ddot
    w9 = w4 - w5 * w7 + w6 * link2_theta_ddot
    w10 = link3_theta_dot**2
    w11 = ca.cos(link3_theta) * c0
    w12 = ca.sin(link3_theta) * c0
    w13 = w8 + w10 * w11 + w12 * link3_theta_ddot
    w14 = w9 - w10 * w12 + w11 * link3_theta_ddot
    w15 = link4_theta_dot**2
    w16 = ca.cos(link4_theta) * c0
    w17 = ca.sin(link4_theta) * c0
    w18 = w13 + w15 * w16 + w17 * link4_theta_ddot
    w19 = w14 - w15 * w17 + w16 * link4_theta_ddot
    w20 = link5_theta_dot**2
    w21 = ca.cos(link5_theta) * c0
    w22 = ca.sin(link5_theta) * c0
    w23 = w18 + w20 * w21 + w22 * link5_theta_ddot
    w24 = w19 - w20 * w22 + w21 * link5_theta_ddot
    w25 = link6_theta_dot**2
    w26 = ca.cos(link6_theta) * c0
    w27 = ca.sin(link6_theta) * c0
    w28 = w23 + w25 * w26 + w27 * link6_theta_ddot
    w29 = w24 - w25 * w27 + w26 * link6_theta_ddot
    w30 = link7_theta_dot**2
    w31 = ca.cos(link7_theta) * c0
    w32 = ca.sin(link7_theta) * c0
    w33 = w28 + w30 * w31 + w32 * link7_theta_ddot
    w34 = w29 - w30 * w32 + w31 * link7_theta_ddot
    w35 = link8_theta_dot**2
    w36 = ca.cos(link8_theta) * c0
    w37 = ca.sin(link8_theta) * c0
    w38 = w33 + w35 * w36 + w37 * link8_theta_ddot
    w39 = w34 - w35 * w37 + w36 * link8_theta_ddot
    w40 = link9_theta_dot**2
    w41 = ca.cos(link9_theta) * c0
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
        -(w38 + w40 * w41 + w42 * link9_theta_ddot),
        w39 - w40 * w42 + w41 * link9_theta_ddot,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 848 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 60)
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
    )
    nu = ca.densify(nu)
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
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 2738 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 60)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c35 = c[35]
    c36 = c[36]
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
    w0 = ca.sin(link1_theta)
    w1 = w0 * c57
    w2 = -w1
    w3 = ca.cos(link1_theta)
    w4 = w3 * c57
    w5 = ca.sin(link2_theta)
    w6 = w5 * c18
    w7 = -w6
    w8 = ca.cos(link2_theta)
    w9 = w8 * c18
    w10 = ca.sin(link3_theta)
    w11 = w10 * c19
    w12 = -w11
    w13 = ca.cos(link3_theta)
    w14 = w13 * c19
    w15 = ca.sin(link4_theta)
    w16 = w15 * c20
    w17 = -w16
    w18 = ca.cos(link4_theta)
    w19 = w18 * c20
    w20 = ca.sin(link5_theta)
    w21 = w20 * c21
    w22 = -w21
    w23 = ca.cos(link5_theta)
    w24 = w23 * c21
    w25 = ca.sin(link6_theta)
    w26 = w25 * c22
    w27 = -w26
    w28 = ca.cos(link6_theta)
    w29 = w28 * c22
    w30 = ca.sin(link7_theta)
    w31 = w30 * c23
    w32 = -w31
    w33 = ca.cos(link7_theta)
    w34 = w33 * c23
    w35 = ca.sin(link8_theta)
    w36 = w35 * c24
    w37 = -w36
    w38 = ca.cos(link8_theta)
    w39 = w38 * c24
    w40 = ca.sin(link9_theta)
    w41 = w40 * c25
    w42 = -w41
    w43 = ca.cos(link9_theta)
    w44 = w43 * c25
    w45 = ca.sin(link10_theta) * c26
    w46 = -w45
    w47 = ca.cos(link10_theta) * c26
    w48 = link1_theta_dot**2
    w49 = w4 * w48
    w50 = w1 * w48
    w51 = link2_theta_dot**2
    w52 = w9 * w51
    w53 = w6 * w51
    w54 = link3_theta_dot**2
    w55 = w14 * w54
    w56 = w11 * w54
    w57 = link4_theta_dot**2
    w58 = w19 * w57
    w59 = w16 * w57
    w60 = link5_theta_dot**2
    w61 = w24 * w60
    w62 = w21 * w60
    w63 = link6_theta_dot**2
    w64 = w29 * w63
    w65 = w26 * w63
    w66 = link7_theta_dot**2
    w67 = w34 * w66
    w68 = w31 * w66
    w69 = link8_theta_dot**2
    w70 = w39 * w69
    w71 = w36 * w69
    w72 = link9_theta_dot**2
    w73 = w44 * w72
    w74 = w41 * w72
    w75 = link10_theta_dot**2
    w76 = w47 * w75
    w77 = w45 * w75
    w78 = w4 * c36
    w79 = w9 * c36
    w80 = w14 * c36
    w81 = w19 * c36
    w82 = w24 * c36
    w83 = w29 * c36
    w84 = w34 * c36
    w85 = w39 * c36
    w86 = w44 * c36
    w87 = w47 * c36
    w88 = w0 * c0
    w89 = w3 * c0
    w90 = w5 * c0
    w91 = w8 * c0
    w92 = w10 * c0
    w93 = w13 * c0
    w94 = w15 * c0
    w95 = w18 * c0
    w96 = w20 * c0
    w97 = w23 * c0
    w98 = w25 * c0
    w99 = w28 * c0
    w100 = w30 * c0
    w101 = w33 * c0
    w102 = w35 * c0
    w103 = w38 * c0
    w104 = w40 * c0
    w105 = w43 * c0
    M = ca.vertcat(
        c47,
        0.0,
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
        0.0,
        c47,
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
        w2,
        w4,
        c48,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
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
        c1,
        w9,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w9,
        c49,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
        0.0,
        w12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
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
        w12,
        w14,
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
        c3,
        0.0,
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
        0.0,
        c3,
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
        w17,
        w19,
        c51,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c4,
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
        c4,
        w24,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w24,
        c52,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c5,
        0.0,
        w27,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c5,
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
        w27,
        w29,
        c53,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c6,
        0.0,
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
        c6,
        w34,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w32,
        w34,
        c54,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c7,
        0.0,
        w37,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c7,
        w39,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w37,
        w39,
        c55,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w42,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w44,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w42,
        w44,
        c56,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c9,
        0.0,
        w46,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c9,
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
        w46,
        w47,
        c35,
    )
    M = ca.reshape(M, 30, 30)
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
    )
    K = ca.reshape(K, 30, 30)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w49,
        w50,
        0.0,
        w52,
        w53,
        0.0,
        w55,
        w56,
        0.0,
        w58,
        w59,
        0.0,
        w61,
        w62,
        0.0,
        w64,
        w65,
        0.0,
        w67,
        w68,
        0.0,
        w70,
        w71,
        0.0,
        w73,
        w74,
        0.0,
        w76,
        w77,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c58,
        w78,
        0.0,
        c38,
        w79,
        0.0,
        c39,
        w80,
        0.0,
        c40,
        w81,
        0.0,
        c41,
        w82,
        0.0,
        c42,
        w83,
        0.0,
        c43,
        w84,
        0.0,
        c44,
        w85,
        0.0,
        c45,
        w86,
        0.0,
        c46,
        w87,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w49,
        w50 + c58,
        w78,
        w52,
        c38 + w53,
        w79,
        w55,
        c39 + w56,
        w80,
        w58,
        c40 + w59,
        w81,
        w61,
        c41 + w62,
        w82,
        w64,
        c42 + w65,
        w83,
        w67,
        c43 + w68,
        w84,
        w70,
        c44 + w71,
        w85,
        w73,
        c45 + w74,
        w86,
        w76,
        c46 + w77,
        w87,
    )
    Q_star = ca.densify(Q_star)
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
        w88,
        -w89,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w90,
        -w91,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w92,
        -w93,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w94,
        -w95,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w96,
        -w97,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w98,
        -w99,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w100,
        -w101,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w102,
        -w103,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w104,
        -w105,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w48 * w89),
        -(w48 * w88),
        -(w51 * w91),
        -(w51 * w90),
        -(w54 * w93),
        -(w54 * w92),
        -(w57 * w95),
        -(w57 * w94),
        -(w60 * w97),
        -(w60 * w96),
        -(w63 * w99),
        -(w63 * w98),
        -(w66 * w101),
        -(w66 * w100),
        -(w69 * w103),
        -(w69 * w102),
        -(w72 * w105),
        -(w72 * w104),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 329 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    q_ddot = ca.SX.sym("q_ddot", 30)
    c = ca.SX.sym("c", 60)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
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
    c57 = c[57]
    c58 = c[58]
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c57
    w2 = ca.sin(link1_theta) * c57
    w3 = link2_theta_dot**2
    w4 = ca.cos(link2_theta) * c18
    w5 = ca.sin(link2_theta) * c18
    w6 = link3_theta_dot**2
    w7 = ca.cos(link3_theta) * c19
    w8 = ca.sin(link3_theta) * c19
    w9 = link4_theta_dot**2
    w10 = ca.cos(link4_theta) * c20
    w11 = ca.sin(link4_theta) * c20
    w12 = link5_theta_dot**2
    w13 = ca.cos(link5_theta) * c21
    w14 = ca.sin(link5_theta) * c21
    w15 = link6_theta_dot**2
    w16 = ca.cos(link6_theta) * c22
    w17 = ca.sin(link6_theta) * c22
    w18 = link7_theta_dot**2
    w19 = ca.cos(link7_theta) * c23
    w20 = ca.sin(link7_theta) * c23
    w21 = link8_theta_dot**2
    w22 = ca.cos(link8_theta) * c24
    w23 = ca.sin(link8_theta) * c24
    w24 = link9_theta_dot**2
    w25 = ca.cos(link9_theta) * c25
    w26 = ca.sin(link9_theta) * c25
    w27 = link10_theta_dot**2
    w28 = ca.cos(link10_theta) * c26
    w29 = ca.sin(link10_theta) * c26
    w30 = w27 * w28 - (link10_x_ddot * c9 - w29 * link10_theta_ddot)
    w31 = w24 * w25 - (link9_x_ddot * c8 - w26 * link9_theta_ddot) + w30
    w32 = w21 * w22 - (link8_x_ddot * c7 - w23 * link8_theta_ddot) + w31
    w33 = w18 * w19 - (link7_x_ddot * c6 - w20 * link7_theta_ddot) + w32
    w34 = w15 * w16 - (link6_x_ddot * c5 - w17 * link6_theta_ddot) + w33
    w35 = w12 * w13 - (link5_x_ddot * c4 - w14 * link5_theta_ddot) + w34
    w36 = w9 * w10 - (link4_x_ddot * c3 - w11 * link4_theta_ddot) + w35
    w37 = w6 * w7 - (link3_x_ddot * c2 - w8 * link3_theta_ddot) + w36
    w38 = w3 * w4 - (link2_x_ddot * c1 - w5 * link2_theta_ddot) + w37
    w39 = w0 * w1 - (link1_x_ddot * c47 - w2 * link1_theta_ddot) + w38
    w40 = c46 + w27 * w29 - (link10_y_ddot * c9 + w28 * link10_theta_ddot)
    w41 = c45 + w24 * w26 - (link9_y_ddot * c8 + w25 * link9_theta_ddot) + w40
    w42 = c44 + w21 * w23 - (link8_y_ddot * c7 + w22 * link8_theta_ddot) + w41
    w43 = c43 + w18 * w20 - (link7_y_ddot * c6 + w19 * link7_theta_ddot) + w42
    w44 = c42 + w15 * w17 - (link6_y_ddot * c5 + w16 * link6_theta_ddot) + w43
    w45 = c41 + w12 * w14 - (link5_y_ddot * c4 + w13 * link5_theta_ddot) + w44
    w46 = c40 + w9 * w11 - (link4_y_ddot * c3 + w10 * link4_theta_ddot) + w45
    w47 = c39 + w6 * w8 - (link3_y_ddot * c2 + w7 * link3_theta_ddot) + w46
    w48 = c38 + w3 * w5 - (link2_y_ddot * c1 + w4 * link2_theta_ddot) + w47
    w49 = c58 + w0 * w2 - (link1_y_ddot * c47 + w1 * link1_theta_ddot) + w48
    lam = ca.vertcat(
        w39,
        w49,
        w38,
        w48,
        w37,
        w47,
        w36,
        w46,
        w35,
        w45,
        w34,
        w44,
        w33,
        w43,
        w32,
        w42,
        w31,
        w41,
        w30,
        w40,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w39,
        -w49,
        0.0,
        -w38,
        -w48,
        0.0,
        -w37,
        -w47,
        0.0,
        -w36,
        -w46,
        0.0,
        -w35,
        -w45,
        0.0,
        -w34,
        -w44,
        0.0,
        -w33,
        -w43,
        0.0,
        -w32,
        -w42,
        0.0,
        -w31,
        -w41,
        0.0,
        -w30,
        -w40,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 10)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 338 operations."""
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 60)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c35 = c[35]
    c36 = c[36]
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
    w0 = ca.sin(link1_theta) * c57
    w1 = ca.cos(link1_theta) * c57
    w2 = link1_x_dot * (link1_x_dot * c47 - w0 * link1_theta_dot) + link1_y_dot * (link1_y_dot * c47 + link1_theta_dot * w1)
    w3 = ca.sin(link2_theta) * c18
    w4 = w2 + link1_theta_dot * (link1_y_dot * w1 - link1_x_dot * w0 + link1_theta_dot * c48) + link2_x_dot * (link2_x_dot * c1 - w3 * link2_theta_dot)
    w5 = ca.cos(link2_theta) * c18
    w6 = w4 + link2_y_dot * (link2_y_dot * c1 + link2_theta_dot * w5) + link2_theta_dot * (link2_y_dot * w5 - link2_x_dot * w3 + link2_theta_dot * c49)
    w7 = ca.sin(link3_theta) * c19
    w8 = ca.cos(link3_theta) * c19
    w9 = w6 + link3_x_dot * (link3_x_dot * c2 - w7 * link3_theta_dot) + link3_y_dot * (link3_y_dot * c2 + link3_theta_dot * w8)
    w10 = ca.sin(link4_theta) * c20
    w11 = w9 + link3_theta_dot * (link3_y_dot * w8 - link3_x_dot * w7 + link3_theta_dot * c50) + link4_x_dot * (link4_x_dot * c3 - w10 * link4_theta_dot)
    w12 = ca.cos(link4_theta) * c20
    w13 = w11 + link4_y_dot * (link4_y_dot * c3 + link4_theta_dot * w12) + link4_theta_dot * (link4_y_dot * w12 - link4_x_dot * w10 + link4_theta_dot * c51)
    w14 = ca.sin(link5_theta) * c21
    w15 = ca.cos(link5_theta) * c21
    w16 = w13 + link5_x_dot * (link5_x_dot * c4 - w14 * link5_theta_dot) + link5_y_dot * (link5_y_dot * c4 + link5_theta_dot * w15)
    w17 = ca.sin(link6_theta) * c22
    w18 = w16 + link5_theta_dot * (link5_y_dot * w15 - link5_x_dot * w14 + link5_theta_dot * c52) + link6_x_dot * (link6_x_dot * c5 - w17 * link6_theta_dot)
    w19 = ca.cos(link6_theta) * c22
    w20 = w18 + link6_y_dot * (link6_y_dot * c5 + link6_theta_dot * w19) + link6_theta_dot * (link6_y_dot * w19 - link6_x_dot * w17 + link6_theta_dot * c53)
    w21 = ca.sin(link7_theta) * c23
    w22 = ca.cos(link7_theta) * c23
    w23 = w20 + link7_x_dot * (link7_x_dot * c6 - w21 * link7_theta_dot) + link7_y_dot * (link7_y_dot * c6 + link7_theta_dot * w22)
    w24 = ca.sin(link8_theta) * c24
    w25 = w23 + link7_theta_dot * (link7_y_dot * w22 - link7_x_dot * w21 + link7_theta_dot * c54) + link8_x_dot * (link8_x_dot * c7 - w24 * link8_theta_dot)
    w26 = ca.cos(link8_theta) * c24
    w27 = w25 + link8_y_dot * (link8_y_dot * c7 + link8_theta_dot * w26) + link8_theta_dot * (link8_y_dot * w26 - link8_x_dot * w24 + link8_theta_dot * c55)
    w28 = ca.sin(link9_theta) * c25
    w29 = ca.cos(link9_theta) * c25
    w30 = w27 + link9_x_dot * (link9_x_dot * c8 - w28 * link9_theta_dot) + link9_y_dot * (link9_y_dot * c8 + link9_theta_dot * w29)
    w31 = ca.sin(link10_theta) * c26
    w32 = w30 + link9_theta_dot * (link9_y_dot * w29 - link9_x_dot * w28 + link9_theta_dot * c56) + link10_x_dot * (link10_x_dot * c9 - w31 * link10_theta_dot)
    w33 = ca.cos(link10_theta) * c26
    w34 = w32 + link10_y_dot * (link10_y_dot * c9 + link10_theta_dot * w33) + link10_theta_dot * (link10_y_dot * w33 - link10_x_dot * w31 + link10_theta_dot * c35)
    w35 = (w0 + link1_y * c47) * c36 + (w3 + link2_y * c1) * c36 + (w7 + link3_y * c2) * c36 + (w10 + link4_y * c3) * c36
    w36 = w35 + (w14 + link5_y * c4) * c36 + (w17 + link6_y * c5) * c36 + (w21 + link7_y * c6) * c36 + (w24 + link8_y * c7) * c36
    kinetic = ca.vertcat(
        w34 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(w36 + (w28 + link9_y * c8) * c36 + (w31 + link10_y * c9) * c36),
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


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 182 operations."""
    q = ca.SX.sym("q", 30)
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
    w0 = ca.cos(link1_theta)
    w1 = ca.sin(link1_theta)
    w2 = ca.cos(link2_theta)
    w3 = ca.sin(link2_theta)
    w4 = ca.cos(link3_theta)
    w5 = ca.sin(link3_theta)
    w6 = ca.cos(link4_theta)
    w7 = ca.sin(link4_theta)
    w8 = ca.cos(link5_theta)
    w9 = ca.sin(link5_theta)
    w10 = ca.cos(link6_theta)
    w11 = ca.sin(link6_theta)
    w12 = ca.cos(link7_theta)
    w13 = ca.sin(link7_theta)
    w14 = ca.cos(link8_theta)
    w15 = ca.sin(link8_theta)
    w16 = ca.cos(link9_theta)
    w17 = ca.sin(link9_theta)
    w18 = ca.cos(link10_theta)
    w19 = ca.sin(link10_theta)
    poses = ca.vertcat(
        link1_x,
        link1_y,
        0.0,
        w0,
        w1,
        0.0,
        -w1,
        w0,
        0.0,
        0.0,
        0.0,
        1.0,
        link2_x,
        link2_y,
        0.0,
        w2,
        w3,
        0.0,
        -w3,
        w2,
        0.0,
        0.0,
        0.0,
        1.0,
        link3_x,
        link3_y,
        0.0,
        w4,
        w5,
        0.0,
        -w5,
        w4,
        0.0,
        0.0,
        0.0,
        1.0,
        link4_x,
        link4_y,
        0.0,
        w6,
        w7,
        0.0,
        -w7,
        w6,
        0.0,
        0.0,
        0.0,
        1.0,
        link5_x,
        link5_y,
        0.0,
        w8,
        w9,
        0.0,
        -w9,
        w8,
        0.0,
        0.0,
        0.0,
        1.0,
        link6_x,
        link6_y,
        0.0,
        w10,
        w11,
        0.0,
        -w11,
        w10,
        0.0,
        0.0,
        0.0,
        1.0,
        link7_x,
        link7_y,
        0.0,
        w12,
        w13,
        0.0,
        -w13,
        w12,
        0.0,
        0.0,
        0.0,
        1.0,
        link8_x,
        link8_y,
        0.0,
        w14,
        w15,
        0.0,
        -w15,
        w14,
        0.0,
        0.0,
        0.0,
        1.0,
        link9_x,
        link9_y,
        0.0,
        w16,
        w17,
        0.0,
        -w17,
        w16,
        0.0,
        0.0,
        0.0,
        1.0,
        link10_x,
        link10_y,
        0.0,
        w18,
        w19,
        0.0,
        -w19,
        w18,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    poses = ca.reshape(poses, 12, 10)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 1037 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 60)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
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
    c59 = c[59]
    w0 = ca.cos(link1_theta)
    w1 = w0 * c0
    w2 = link1_theta_dot**2
    w3 = w1 * w2
    w4 = w3 * c1
    w5 = w3 * c8 + w3 * c9
    w6 = w3 * c7 + w5
    w7 = w3 * c6 + w6
    w8 = w3 * c5 + w7
    w9 = w3 * c4 + w8
    w10 = w3 * c3 + w9
    w11 = w3 * c2 + w10
    w12 = link2_theta_dot**2
    w13 = ca.sin(link2_theta)
    w14 = w13 * c18
    w15 = w12 * w14
    w16 = ca.sin(link1_theta)
    w17 = w16 * c0
    w18 = w2 * w17
    w19 = w18 * c1
    w20 = link3_theta_dot**2
    w21 = ca.sin(link3_theta)
    w22 = w21 * c19
    w23 = w20 * w22
    w24 = w13 * c0
    w25 = w12 * w24
    w26 = w18 + w25
    w27 = link4_theta_dot**2
    w28 = ca.sin(link4_theta)
    w29 = w28 * c20
    w30 = w27 * w29
    w31 = w21 * c0
    w32 = w20 * w31
    w33 = w26 + w32
    w34 = link5_theta_dot**2
    w35 = ca.sin(link5_theta)
    w36 = w35 * c21
    w37 = w34 * w36
    w38 = w28 * c0
    w39 = w27 * w38
    w40 = w33 + w39
    w41 = link6_theta_dot**2
    w42 = ca.sin(link6_theta)
    w43 = w42 * c22
    w44 = w41 * w43
    w45 = w35 * c0
    w46 = w34 * w45
    w47 = w40 + w46
    w48 = link7_theta_dot**2
    w49 = ca.sin(link7_theta)
    w50 = w49 * c23
    w51 = w48 * w50
    w52 = w42 * c0
    w53 = w41 * w52
    w54 = w47 + w53
    w55 = link8_theta_dot**2
    w56 = ca.sin(link8_theta)
    w57 = w56 * c24
    w58 = w55 * w57
    w59 = w49 * c0
    w60 = w48 * w59
    w61 = w54 + w60
    w62 = link9_theta_dot**2
    w63 = ca.sin(link9_theta)
    w64 = w63 * c25
    w65 = w62 * w64
    w66 = w56 * c0
    w67 = w55 * w66
    w68 = w61 + w67
    w69 = link10_theta_dot**2
    w70 = ca.sin(link10_theta) * c26
    w71 = w69 * w70
    w72 = w63 * c0
    w73 = w62 * w72
    w74 = w68 + w73
    w75 = c46 + w71 + w74 * c9
    w76 = c45 + w65 + w68 * c8 + w75
    w77 = c44 + w58 + w61 * c7 + w76
    w78 = c43 + w51 + w54 * c6 + w77
    w79 = c42 + w44 + w47 * c5 + w78
    w80 = c41 + w37 + w40 * c4 + w79
    w81 = c40 + w30 + w33 * c3 + w80
    w82 = c39 + w23 + w26 * c2 + w81
    w83 = ca.cos(link2_theta)
    w84 = w83 * c18
    w85 = w12 * w84
    w86 = ca.cos(link3_theta)
    w87 = w86 * c19
    w88 = w20 * w87
    w89 = w83 * c0
    w90 = w12 * w89
    w91 = w3 + w90
    w92 = ca.cos(link4_theta)
    w93 = w92 * c20
    w94 = w27 * w93
    w95 = w86 * c0
    w96 = w20 * w95
    w97 = w91 + w96
    w98 = ca.cos(link5_theta)
    w99 = w98 * c21
    w100 = w34 * w99
    w101 = w92 * c0
    w102 = w27 * w101
    w103 = w97 + w102
    w104 = ca.cos(link6_theta)
    w105 = w104 * c22
    w106 = w41 * w105
    w107 = w98 * c0
    w108 = w34 * w107
    w109 = w103 + w108
    w110 = ca.cos(link7_theta)
    w111 = w110 * c23
    w112 = w48 * w111
    w113 = w104 * c0
    w114 = w41 * w113
    w115 = w109 + w114
    w116 = ca.cos(link8_theta)
    w117 = w116 * c24
    w118 = w55 * w117
    w119 = w110 * c0
    w120 = w48 * w119
    w121 = w115 + w120
    w122 = ca.cos(link9_theta)
    w123 = w122 * c25
    w124 = w62 * w123
    w125 = w116 * c0
    w126 = w55 * w125
    w127 = w121 + w126
    w128 = ca.cos(link10_theta) * c26
    w129 = w69 * w128
    w130 = w122 * c0
    w131 = w62 * w130
    w132 = w127 + w131
    w133 = w129 + w132 * c9
    w134 = w124 + w127 * c8 + w133
    w135 = w118 + w121 * c7 + w134
    w136 = w112 + w115 * c6 + w135
    w137 = w106 + w109 * c5 + w136
    w138 = w100 + w103 * c4 + w137
    w139 = w94 + w97 * c3 + w138
    w140 = w88 + w91 * c2 + w139
    w141 = w18 * c8 + w18 * c9
    w142 = w18 * c7 + w141
    w143 = w18 * c6 + w142
    w144 = w18 * c5 + w143
    w145 = w18 * c4 + w144
    w146 = w18 * c3 + w145
    w147 = w18 * c2 + w146
    w148 = w1 * (w4 + w11) - w17 * (c38 + w15 + w19 + w82) - w16 * c37 - (w1 * (w4 + w85 + w140) - w17 * (w19 + w147))
    w149 = w14 * w18 + w3 * w84
    w150 = w90 * c8 + w90 * c9
    w151 = w90 * c7 + w150
    w152 = w90 * c6 + w151
    w153 = w90 * c5 + w152
    w154 = w90 * c4 + w153
    w155 = w90 * c3 + w154
    w156 = w90 * c2 + w155
    w157 = w25 * c8 + w25 * c9
    w158 = w25 * c7 + w157
    w159 = w25 * c6 + w158
    w160 = w25 * c5 + w159
    w161 = w25 * c4 + w160
    w162 = w25 * c3 + w161
    w163 = w25 * c2 + w162
    w164 = w96 * c8 + w96 * c9
    w165 = w96 * c7 + w164
    w166 = w96 * c6 + w165
    w167 = w96 * c5 + w166
    w168 = w96 * c4 + w167
    w169 = w96 * c3 + w168
    w170 = w88 + w169
    w171 = w32 * c8 + w32 * c9
    w172 = w32 * c7 + w171
    w173 = w32 * c6 + w172
    w174 = w32 * c5 + w173
    w175 = w32 * c4 + w174
    w176 = w32 * c3 + w175
    w177 = w23 + w176
    w178 = w102 * c8 + w102 * c9
    w179 = w102 * c7 + w178
    w180 = w102 * c6 + w179
    w181 = w102 * c5 + w180
    w182 = w102 * c4 + w181
    w183 = w94 + w182
    w184 = w39 * c8 + w39 * c9
    w185 = w39 * c7 + w184
    w186 = w39 * c6 + w185
    w187 = w39 * c5 + w186
    w188 = w39 * c4 + w187
    w189 = w30 + w188
    w190 = w108 * c8 + w108 * c9
    w191 = w108 * c7 + w190
    w192 = w108 * c6 + w191
    w193 = w108 * c5 + w192
    w194 = w100 + w193
    w195 = w46 * c8 + w46 * c9
    w196 = w46 * c7 + w195
    w197 = w46 * c6 + w196
    w198 = w46 * c5 + w197
    w199 = w37 + w198
    w200 = w114 * c8 + w114 * c9
    w201 = w114 * c7 + w200
    w202 = w114 * c6 + w201
    w203 = w106 + w202
    w204 = w53 * c8 + w53 * c9
    w205 = w53 * c7 + w204
    w206 = w53 * c6 + w205
    w207 = w44 + w206
    w208 = w120 * c8 + w120 * c9
    w209 = w120 * c7 + w208
    w210 = w112 + w209
    w211 = w60 * c8 + w60 * c9
    w212 = w60 * c7 + w211
    w213 = w51 + w212
    w214 = w126 * c8 + w126 * c9
    w215 = w118 + w214
    w216 = w67 * c8 + w67 * c9
    w217 = w58 + w216
    w218 = w131 * c9
    w219 = w124 + w218
    w220 = w73 * c9
    w221 = w65 + w220
    dQ_hat_dq_i = ca.vertcat(
        w148,
        w149 + w11 * w89 + w24 * w147,
        w18 * w22 + w3 * w87 + w10 * w95 + w31 * w146,
        w18 * w29 + w3 * w93 + w9 * w101 + w38 * w145,
        w18 * w36 + w3 * w99 + w8 * w107 + w45 * w144,
        w18 * w43 + w3 * w105 + w7 * w113 + w52 * w143,
        w18 * w50 + w3 * w111 + w6 * w119 + w59 * w142,
        w18 * w57 + w3 * w117 + w5 * w125 + w66 * w141,
        w122 * (link1_theta_dot * (w0 * link1_theta_dot)) * c59 + w63 * (w2 * w16) * c59,
        w18 * w70 + w3 * w128,
        w1 * (w85 + w156) + w17 * (w15 + w163),
        w89 * w156 - w24 * w82 - (w149 + w14 * c36) - (w89 * w140 - w24 * w163),
        w22 * w25 + w87 * w90 + w95 * w155 + w31 * w162,
        w25 * w29 + w90 * w93 + w101 * w154 + w38 * w161,
        w25 * w36 + w90 * w99 + w107 * w153 + w45 * w160,
        w25 * w43 + w90 * w105 + w113 * w152 + w52 * w159,
        w25 * w50 + w90 * w111 + w119 * w151 + w59 * w158,
        w25 * w57 + w90 * w117 + w125 * w150 + w66 * w157,
        w122 * (w12 * w83) * c59 + w63 * (w12 * w13) * c59,
        w25 * w70 + w90 * w128,
        w1 * w170 + w17 * w177,
        w89 * w170 + w24 * w177,
        w95 * w169 - w31 * w81 - (w22 * c36 + (w87 * w91 + w22 * w26)) - (w95 * w139 - w31 * w176),
        w29 * w32 + w93 * w96 + w101 * w168 + w38 * w175,
        w32 * w36 + w96 * w99 + w107 * w167 + w45 * w174,
        w32 * w43 + w96 * w105 + w113 * w166 + w52 * w173,
        w32 * w50 + w96 * w111 + w119 * w165 + w59 * w172,
        w32 * w57 + w96 * w117 + w125 * w164 + w66 * w171,
        w122 * (w20 * w86) * c59 + w63 * (w20 * w21) * c59,
        w32 * w70 + w96 * w128,
        w1 * w183 + w17 * w189,
        w89 * w183 + w24 * w189,
        w95 * w183 + w31 * w189,
        w101 * w182 - w38 * w80 - (w29 * c36 + (w93 * w97 + w29 * w33)) - (w101 * w138 - w38 * w188),
        w36 * w39 + w99 * w102 + w107 * w181 + w45 * w187,
        w39 * w43 + w102 * w105 + w113 * w180 + w52 * w186,
        w39 * w50 + w102 * w111 + w119 * w179 + w59 * w185,
        w39 * w57 + w102 * w117 + w125 * w178 + w66 * w184,
        w122 * (w27 * w92) * c59 + w63 * (w27 * w28) * c59,
        w39 * w70 + w102 * w128,
        w1 * w194 + w17 * w199,
        w89 * w194 + w24 * w199,
        w95 * w194 + w31 * w199,
        w101 * w194 + w38 * w199,
        w107 * w193 - w45 * w79 - (w36 * c36 + (w99 * w103 + w36 * w40)) - (w107 * w137 - w45 * w198),
        w43 * w46 + w105 * w108 + w113 * w192 + w52 * w197,
        w46 * w50 + w108 * w111 + w119 * w191 + w59 * w196,
        w46 * w57 + w108 * w117 + w125 * w190 + w66 * w195,
        w122 * (w34 * w98) * c59 + w63 * (w34 * w35) * c59,
        w46 * w70 + w108 * w128,
        w1 * w203 + w17 * w207,
        w89 * w203 + w24 * w207,
        w95 * w203 + w31 * w207,
        w101 * w203 + w38 * w207,
        w107 * w203 + w45 * w207,
        w113 * w202 - w52 * w78 - (w43 * c36 + (w105 * w109 + w43 * w47)) - (w113 * w136 - w52 * w206),
        w50 * w53 + w111 * w114 + w119 * w201 + w59 * w205,
        w53 * w57 + w114 * w117 + w125 * w200 + w66 * w204,
        w122 * (w41 * w104) * c59 + w63 * (w41 * w42) * c59,
        w53 * w70 + w114 * w128,
        w1 * w210 + w17 * w213,
        w89 * w210 + w24 * w213,
        w95 * w210 + w31 * w213,
        w101 * w210 + w38 * w213,
        w107 * w210 + w45 * w213,
        w113 * w210 + w52 * w213,
        w119 * w209 - w59 * w77 - (w50 * c36 + (w111 * w115 + w50 * w54)) - (w119 * w135 - w59 * w212),
        w57 * w60 + w117 * w120 + w125 * w208 + w66 * w211,
        w122 * (w48 * w110) * c59 + w63 * (w48 * w49) * c59,
        w60 * w70 + w120 * w128,
        w1 * w215 + w17 * w217,
        w89 * w215 + w24 * w217,
        w95 * w215 + w31 * w217,
        w101 * w215 + w38 * w217,
        w107 * w215 + w45 * w217,
        w113 * w215 + w52 * w217,
        w119 * w215 + w59 * w217,
        w125 * w214 - w66 * w76 - (w57 * c36 + (w117 * w121 + w57 * w61)) - (w125 * w134 - w66 * w216),
        w122 * (w55 * w116) * c59 + w63 * (w55 * w56) * c59,
        w67 * w70 + w126 * w128,
        w1 * w219 + w17 * w221,
        w89 * w219 + w24 * w221,
        w95 * w219 + w31 * w221,
        w101 * w219 + w38 * w221,
        w107 * w219 + w45 * w221,
        w113 * w219 + w52 * w221,
        w119 * w219 + w59 * w221,
        w125 * w219 + w66 * w221,
        w130 * w218 - w72 * w75 - (w64 * c36 + (w123 * w127 + w64 * w68)) - (w130 * w133 - w72 * w220),
        w70 * w73 + w128 * w131,
        w1 * w129 + w17 * w71,
        w89 * w129 + w24 * w71,
        w95 * w129 + w31 * w71,
        w101 * w129 + w38 * w71,
        w107 * w129 + w45 * w71,
        w113 * w129 + w52 * w71,
        w119 * w129 + w59 * w71,
        w125 * w129 + w66 * w71,
        w129 * w130 + w71 * w72,
        -(w70 * c36 + (w128 * w132 + w70 * w74)),
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 10, 10)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 870 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 60)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    w0 = ca.cos(link1_theta) * c0
    w1 = ca.sin(link1_theta) * c0
    w2 = 2 * link1_theta_dot
    w3 = w1 * w2
    w4 = w3 * c9
    w5 = w3 * c8 + w4
    w6 = w3 * c7 + w5
    w7 = w3 * c6 + w6
    w8 = w3 * c5 + w7
    w9 = w3 * c4 + w8
    w10 = w3 * c3 + w9
    w11 = w3 * c2 + w10
    w12 = w0 * w2
    w13 = w12 * c9
    w14 = w12 * c8 + w13
    w15 = w12 * c7 + w14
    w16 = w12 * c6 + w15
    w17 = w12 * c5 + w16
    w18 = w12 * c4 + w17
    w19 = w12 * c3 + w18
    w20 = w12 * c2 + w19
    w21 = ca.cos(link2_theta)
    w22 = w21 * c0
    w23 = ca.sin(link2_theta)
    w24 = w23 * c18
    w25 = w21 * c18
    w26 = w23 * c0
    w27 = ca.cos(link3_theta)
    w28 = w27 * c0
    w29 = ca.sin(link3_theta)
    w30 = w29 * c19
    w31 = w27 * c19
    w32 = w29 * c0
    w33 = ca.cos(link4_theta)
    w34 = w33 * c0
    w35 = ca.sin(link4_theta)
    w36 = w35 * c20
    w37 = w33 * c20
    w38 = w35 * c0
    w39 = ca.cos(link5_theta)
    w40 = w39 * c0
    w41 = ca.sin(link5_theta)
    w42 = w41 * c21
    w43 = w39 * c21
    w44 = w41 * c0
    w45 = ca.cos(link6_theta)
    w46 = w45 * c0
    w47 = ca.sin(link6_theta)
    w48 = w47 * c22
    w49 = w45 * c22
    w50 = w47 * c0
    w51 = ca.cos(link7_theta)
    w52 = w51 * c0
    w53 = ca.sin(link7_theta)
    w54 = w53 * c23
    w55 = w51 * c23
    w56 = w53 * c0
    w57 = ca.cos(link8_theta)
    w58 = w57 * c0
    w59 = ca.sin(link8_theta)
    w60 = w59 * c24
    w61 = w57 * c24
    w62 = w59 * c0
    w63 = ca.cos(link9_theta)
    w64 = w63 * c0
    w65 = ca.sin(link9_theta)
    w66 = w65 * c25
    w67 = w63 * c25
    w68 = w65 * c0
    w69 = ca.sin(link10_theta) * c26
    w70 = ca.cos(link10_theta) * c26
    w71 = 2 * link2_theta_dot
    w72 = w26 * w71
    w73 = w72 * c9
    w74 = w72 * c8 + w73
    w75 = w72 * c7 + w74
    w76 = w72 * c6 + w75
    w77 = w72 * c5 + w76
    w78 = w72 * c4 + w77
    w79 = w72 * c3 + w78
    w80 = w72 * c2 + w79
    w81 = w22 * w71
    w82 = w81 * c9
    w83 = w81 * c8 + w82
    w84 = w81 * c7 + w83
    w85 = w81 * c6 + w84
    w86 = w81 * c5 + w85
    w87 = w81 * c4 + w86
    w88 = w81 * c3 + w87
    w89 = w81 * c2 + w88
    w90 = 2 * link3_theta_dot
    w91 = w32 * w90
    w92 = w91 * c9
    w93 = w91 * c8 + w92
    w94 = w91 * c7 + w93
    w95 = w91 * c6 + w94
    w96 = w91 * c5 + w95
    w97 = w91 * c4 + w96
    w98 = w91 * c3 + w97
    w99 = w30 * w90 + w98
    w100 = w28 * w90
    w101 = w100 * c9
    w102 = w100 * c8 + w101
    w103 = w100 * c7 + w102
    w104 = w100 * c6 + w103
    w105 = w100 * c5 + w104
    w106 = w100 * c4 + w105
    w107 = w100 * c3 + w106
    w108 = w31 * w90 + w107
    w109 = 2 * link4_theta_dot
    w110 = w38 * w109
    w111 = w110 * c9
    w112 = w110 * c8 + w111
    w113 = w110 * c7 + w112
    w114 = w110 * c6 + w113
    w115 = w110 * c5 + w114
    w116 = w110 * c4 + w115
    w117 = w36 * w109 + w116
    w118 = w34 * w109
    w119 = w118 * c9
    w120 = w118 * c8 + w119
    w121 = w118 * c7 + w120
    w122 = w118 * c6 + w121
    w123 = w118 * c5 + w122
    w124 = w118 * c4 + w123
    w125 = w37 * w109 + w124
    w126 = 2 * link5_theta_dot
    w127 = w44 * w126
    w128 = w127 * c9
    w129 = w127 * c8 + w128
    w130 = w127 * c7 + w129
    w131 = w127 * c6 + w130
    w132 = w127 * c5 + w131
    w133 = w42 * w126 + w132
    w134 = w40 * w126
    w135 = w134 * c9
    w136 = w134 * c8 + w135
    w137 = w134 * c7 + w136
    w138 = w134 * c6 + w137
    w139 = w134 * c5 + w138
    w140 = w43 * w126 + w139
    w141 = 2 * link6_theta_dot
    w142 = w50 * w141
    w143 = w142 * c9
    w144 = w142 * c8 + w143
    w145 = w142 * c7 + w144
    w146 = w142 * c6 + w145
    w147 = w48 * w141 + w146
    w148 = w46 * w141
    w149 = w148 * c9
    w150 = w148 * c8 + w149
    w151 = w148 * c7 + w150
    w152 = w148 * c6 + w151
    w153 = w49 * w141 + w152
    w154 = 2 * link7_theta_dot
    w155 = w56 * w154
    w156 = w155 * c9
    w157 = w155 * c8 + w156
    w158 = w155 * c7 + w157
    w159 = w54 * w154 + w158
    w160 = w52 * w154
    w161 = w160 * c9
    w162 = w160 * c8 + w161
    w163 = w160 * c7 + w162
    w164 = w55 * w154 + w163
    w165 = 2 * link8_theta_dot
    w166 = w62 * w165
    w167 = w166 * c9
    w168 = w166 * c8 + w167
    w169 = w60 * w165 + w168
    w170 = w58 * w165
    w171 = w170 * c9
    w172 = w170 * c8 + w171
    w173 = w61 * w165 + w172
    w174 = 2 * link9_theta_dot
    w175 = w68 * w174
    w176 = w175 * c9
    w177 = w66 * w174 + w176
    w178 = w64 * w174
    w179 = w178 * c9
    w180 = w67 * w174 + w179
    w181 = 2 * link10_theta_dot
    w182 = w69 * w181
    w183 = w70 * w181
    dQ_hat_dq_i_dot = ca.vertcat(
        w0 * (w3 * c1 + w11) - w1 * (w12 * c1 + w20),
        w11 * w22 - (w12 * w24 - w3 * w25) - w20 * w26,
        w10 * w28 - (w12 * w30 - w3 * w31) - w19 * w32,
        w9 * w34 - (w12 * w36 - w3 * w37) - w18 * w38,
        w8 * w40 - (w12 * w42 - w3 * w43) - w17 * w44,
        w7 * w46 - (w12 * w48 - w3 * w49) - w16 * w50,
        w6 * w52 - (w12 * w54 - w3 * w55) - w15 * w56,
        w5 * w58 - (w12 * w60 - w3 * w61) - w14 * w62,
        w4 * w64 - (w12 * w66 - w3 * w67) - w13 * w68,
        -(w12 * w69 - w3 * w70),
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
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 985 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 60)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    w0 = ca.sin(link1_theta) * c0
    w1 = ca.cos(link1_theta) * c0
    w2 = link1_theta_ddot * w1
    w3 = w2 * c1
    w4 = w2 * c9
    w5 = w2 * c8 + w4
    w6 = w2 * c7 + w5
    w7 = w2 * c6 + w6
    w8 = w2 * c5 + w7
    w9 = w2 * c4 + w8
    w10 = w2 * c3 + w9
    w11 = w2 * c2 + w10
    w12 = w0 * link1_theta_ddot
    w13 = w12 * c1
    w14 = ca.sin(link2_theta)
    w15 = w14 * c18
    w16 = w15 * link2_theta_ddot
    w17 = w14 * c0
    w18 = link2_theta_ddot * w17
    w19 = w12 + w18
    w20 = ca.sin(link3_theta)
    w21 = w20 * c19
    w22 = w21 * link3_theta_ddot
    w23 = w20 * c0
    w24 = link3_theta_ddot * w23
    w25 = w19 + w24
    w26 = ca.sin(link4_theta)
    w27 = w26 * c20
    w28 = w27 * link4_theta_ddot
    w29 = w26 * c0
    w30 = link4_theta_ddot * w29
    w31 = w25 + w30
    w32 = ca.sin(link5_theta)
    w33 = w32 * c21
    w34 = w33 * link5_theta_ddot
    w35 = w32 * c0
    w36 = link5_theta_ddot * w35
    w37 = w31 + w36
    w38 = ca.sin(link6_theta)
    w39 = w38 * c22
    w40 = w39 * link6_theta_ddot
    w41 = w38 * c0
    w42 = link6_theta_ddot * w41
    w43 = w37 + w42
    w44 = ca.sin(link7_theta)
    w45 = w44 * c23
    w46 = w45 * link7_theta_ddot
    w47 = w44 * c0
    w48 = link7_theta_ddot * w47
    w49 = w43 + w48
    w50 = ca.sin(link8_theta)
    w51 = w50 * c24
    w52 = w51 * link8_theta_ddot
    w53 = w50 * c0
    w54 = link8_theta_ddot * w53
    w55 = w49 + w54
    w56 = ca.sin(link9_theta)
    w57 = w56 * c25
    w58 = w57 * link9_theta_ddot
    w59 = w56 * c0
    w60 = link9_theta_ddot * w59
    w61 = w55 + w60
    w62 = ca.sin(link10_theta) * c26
    w63 = w62 * link10_theta_ddot
    w64 = w61 * c9 + w63
    w65 = w55 * c8 + w58 + w64
    w66 = w49 * c7 + w52 + w65
    w67 = w43 * c6 + w46 + w66
    w68 = w37 * c5 + w40 + w67
    w69 = w31 * c4 + w34 + w68
    w70 = w25 * c3 + w28 + w69
    w71 = w19 * c2 + w22 + w70
    w72 = w12 * c9
    w73 = w12 * c8 + w72
    w74 = w12 * c7 + w73
    w75 = w12 * c6 + w74
    w76 = w12 * c5 + w75
    w77 = w12 * c4 + w76
    w78 = w12 * c3 + w77
    w79 = w12 * c2 + w78
    w80 = ca.cos(link2_theta)
    w81 = w80 * c18
    w82 = link2_theta_ddot * w81
    w83 = w80 * c0
    w84 = link2_theta_ddot * w83
    w85 = w2 + w84
    w86 = ca.cos(link3_theta)
    w87 = w86 * c19
    w88 = link3_theta_ddot * w87
    w89 = w86 * c0
    w90 = link3_theta_ddot * w89
    w91 = w85 + w90
    w92 = ca.cos(link4_theta)
    w93 = w92 * c20
    w94 = link4_theta_ddot * w93
    w95 = w92 * c0
    w96 = link4_theta_ddot * w95
    w97 = w91 + w96
    w98 = ca.cos(link5_theta)
    w99 = w98 * c21
    w100 = link5_theta_ddot * w99
    w101 = w98 * c0
    w102 = link5_theta_ddot * w101
    w103 = w97 + w102
    w104 = ca.cos(link6_theta)
    w105 = w104 * c22
    w106 = link6_theta_ddot * w105
    w107 = w104 * c0
    w108 = link6_theta_ddot * w107
    w109 = w103 + w108
    w110 = ca.cos(link7_theta)
    w111 = w110 * c23
    w112 = link7_theta_ddot * w111
    w113 = w110 * c0
    w114 = link7_theta_ddot * w113
    w115 = w109 + w114
    w116 = ca.cos(link8_theta)
    w117 = w116 * c24
    w118 = link8_theta_ddot * w117
    w119 = w116 * c0
    w120 = link8_theta_ddot * w119
    w121 = w115 + w120
    w122 = ca.cos(link9_theta)
    w123 = w122 * c25
    w124 = link9_theta_ddot * w123
    w125 = w122 * c0
    w126 = link9_theta_ddot * w125
    w127 = w121 + w126
    w128 = ca.cos(link10_theta) * c26
    w129 = link10_theta_ddot * w128
    w130 = w127 * c9 + w129
    w131 = w121 * c8 + w124 + w130
    w132 = w115 * c7 + w118 + w131
    w133 = w109 * c6 + w112 + w132
    w134 = w103 * c5 + w106 + w133
    w135 = w97 * c4 + w100 + w134
    w136 = w91 * c3 + w94 + w135
    w137 = w85 * c2 + w88 + w136
    w138 = w2 * w15
    w139 = w12 * w81
    w140 = w84 * c9
    w141 = w84 * c8 + w140
    w142 = w84 * c7 + w141
    w143 = w84 * c6 + w142
    w144 = w84 * c5 + w143
    w145 = w84 * c4 + w144
    w146 = w84 * c3 + w145
    w147 = w84 * c2 + w146
    w148 = w18 * c9
    w149 = w18 * c8 + w148
    w150 = w18 * c7 + w149
    w151 = w18 * c6 + w150
    w152 = w18 * c5 + w151
    w153 = w18 * c4 + w152
    w154 = w18 * c3 + w153
    w155 = w18 * c2 + w154
    w156 = w90 * c9
    w157 = w90 * c8 + w156
    w158 = w90 * c7 + w157
    w159 = w90 * c6 + w158
    w160 = w90 * c5 + w159
    w161 = w90 * c4 + w160
    w162 = w90 * c3 + w161
    w163 = w88 + w162
    w164 = w24 * c9
    w165 = w24 * c8 + w164
    w166 = w24 * c7 + w165
    w167 = w24 * c6 + w166
    w168 = w24 * c5 + w167
    w169 = w24 * c4 + w168
    w170 = w24 * c3 + w169
    w171 = w22 + w170
    w172 = w96 * c9
    w173 = w96 * c8 + w172
    w174 = w96 * c7 + w173
    w175 = w96 * c6 + w174
    w176 = w96 * c5 + w175
    w177 = w96 * c4 + w176
    w178 = w94 + w177
    w179 = w30 * c9
    w180 = w30 * c8 + w179
    w181 = w30 * c7 + w180
    w182 = w30 * c6 + w181
    w183 = w30 * c5 + w182
    w184 = w30 * c4 + w183
    w185 = w28 + w184
    w186 = w102 * c9
    w187 = w102 * c8 + w186
    w188 = w102 * c7 + w187
    w189 = w102 * c6 + w188
    w190 = w102 * c5 + w189
    w191 = w100 + w190
    w192 = w36 * c9
    w193 = w36 * c8 + w192
    w194 = w36 * c7 + w193
    w195 = w36 * c6 + w194
    w196 = w36 * c5 + w195
    w197 = w34 + w196
    w198 = w108 * c9
    w199 = w108 * c8 + w198
    w200 = w108 * c7 + w199
    w201 = w108 * c6 + w200
    w202 = w106 + w201
    w203 = w42 * c9
    w204 = w42 * c8 + w203
    w205 = w42 * c7 + w204
    w206 = w42 * c6 + w205
    w207 = w40 + w206
    w208 = w114 * c9
    w209 = w114 * c8 + w208
    w210 = w114 * c7 + w209
    w211 = w112 + w210
    w212 = w48 * c9
    w213 = w48 * c8 + w212
    w214 = w48 * c7 + w213
    w215 = w46 + w214
    w216 = w120 * c9
    w217 = w120 * c8 + w216
    w218 = w118 + w217
    w219 = w54 * c9
    w220 = w54 * c8 + w219
    w221 = w52 + w220
    w222 = w126 * c9
    w223 = w124 + w222
    w224 = w60 * c9
    w225 = w58 + w224
    dMa_dq_i = ca.vertcat(
        w0 * (w3 + w11) + w1 * (w13 + w16 + w71) - (w1 * (w13 + w79) + w0 * (w3 + w82 + w137)),
        w138 - w139 - w79 * w83 + w11 * w17,
        w2 * w21 - w12 * w87 - w78 * w89 + w10 * w23,
        w2 * w27 - w12 * w93 - w77 * w95 + w9 * w29,
        w2 * w33 - w12 * w99 - w76 * w101 + w8 * w35,
        w2 * w39 - w12 * w105 - w75 * w107 + w7 * w41,
        w2 * w45 - w12 * w111 - w74 * w113 + w6 * w47,
        w2 * w51 - w12 * w117 - w73 * w119 + w5 * w53,
        w2 * w57 - w12 * w123 - w72 * w125 + w4 * w59,
        w2 * w62 - w12 * w128,
        w0 * (w82 + w147) - w1 * (w16 + w155),
        w139 - w138 - (w83 * w155 + w17 * w137) + (w17 * w147 + w71 * w83),
        w21 * w84 - w18 * w87 - w89 * w154 + w23 * w146,
        w27 * w84 - w18 * w93 - w95 * w153 + w29 * w145,
        w33 * w84 - w18 * w99 - w101 * w152 + w35 * w144,
        w39 * w84 - w18 * w105 - w107 * w151 + w41 * w143,
        w45 * w84 - w18 * w111 - w113 * w150 + w47 * w142,
        w51 * w84 - w18 * w117 - w119 * w149 + w53 * w141,
        w57 * w84 - w18 * w123 - w125 * w148 + w59 * w140,
        w62 * w84 - w18 * w128,
        w0 * w163 - w1 * w171,
        w17 * w163 - w83 * w171,
        w19 * w87 - w21 * w85 - (w89 * w170 + w23 * w136) + (w23 * w162 + w70 * w89),
        w27 * w90 - w24 * w93 - w95 * w169 + w29 * w161,
        w33 * w90 - w24 * w99 - w101 * w168 + w35 * w160,
        w39 * w90 - w24 * w105 - w107 * w167 + w41 * w159,
        w45 * w90 - w24 * w111 - w113 * w166 + w47 * w158,
        w51 * w90 - w24 * w117 - w119 * w165 + w53 * w157,
        w57 * w90 - w24 * w123 - w125 * w164 + w59 * w156,
        w62 * w90 - w24 * w128,
        w0 * w178 - w1 * w185,
        w17 * w178 - w83 * w185,
        w23 * w178 - w89 * w185,
        w25 * w93 - w27 * w91 - (w95 * w184 + w29 * w135) + (w29 * w177 + w69 * w95),
        w33 * w96 - w30 * w99 - w101 * w183 + w35 * w176,
        w39 * w96 - w30 * w105 - w107 * w182 + w41 * w175,
        w45 * w96 - w30 * w111 - w113 * w181 + w47 * w174,
        w51 * w96 - w30 * w117 - w119 * w180 + w53 * w173,
        w57 * w96 - w30 * w123 - w125 * w179 + w59 * w172,
        w62 * w96 - w30 * w128,
        w0 * w191 - w1 * w197,
        w17 * w191 - w83 * w197,
        w23 * w191 - w89 * w197,
        w29 * w191 - w95 * w197,
        w31 * w99 - w33 * w97 - (w101 * w196 + w35 * w134) + (w35 * w190 + w68 * w101),
        w39 * w102 - w36 * w105 - w107 * w195 + w41 * w189,
        w45 * w102 - w36 * w111 - w113 * w194 + w47 * w188,
        w51 * w102 - w36 * w117 - w119 * w193 + w53 * w187,
        w57 * w102 - w36 * w123 - w125 * w192 + w59 * w186,
        w62 * w102 - w36 * w128,
        w0 * w202 - w1 * w207,
        w17 * w202 - w83 * w207,
        w23 * w202 - w89 * w207,
        w29 * w202 - w95 * w207,
        w35 * w202 - w101 * w207,
        w37 * w105 - w39 * w103 - (w107 * w206 + w41 * w133) + (w41 * w201 + w67 * w107),
        w45 * w108 - w42 * w111 - w113 * w205 + w47 * w200,
        w51 * w108 - w42 * w117 - w119 * w204 + w53 * w199,
        w57 * w108 - w42 * w123 - w125 * w203 + w59 * w198,
        w62 * w108 - w42 * w128,
        w0 * w211 - w1 * w215,
        w17 * w211 - w83 * w215,
        w23 * w211 - w89 * w215,
        w29 * w211 - w95 * w215,
        w35 * w211 - w101 * w215,
        w41 * w211 - w107 * w215,
        w43 * w111 - w45 * w109 - (w113 * w214 + w47 * w132) + (w47 * w210 + w66 * w113),
        w51 * w114 - w48 * w117 - w119 * w213 + w53 * w209,
        w57 * w114 - w48 * w123 - w125 * w212 + w59 * w208,
        w62 * w114 - w48 * w128,
        w0 * w218 - w1 * w221,
        w17 * w218 - w83 * w221,
        w23 * w218 - w89 * w221,
        w29 * w218 - w95 * w221,
        w35 * w218 - w101 * w221,
        w41 * w218 - w107 * w221,
        w47 * w218 - w113 * w221,
        w49 * w117 - w51 * w115 - (w119 * w220 + w53 * w131) + (w53 * w217 + w65 * w119),
        w57 * w120 - w54 * w123 - w125 * w219 + w59 * w216,
        w62 * w120 - w54 * w128,
        w0 * w223 - w1 * w225,
        w17 * w223 - w83 * w225,
        w23 * w223 - w89 * w225,
        w29 * w223 - w95 * w225,
        w35 * w223 - w101 * w225,
        w41 * w223 - w107 * w225,
        w47 * w223 - w113 * w225,
        w53 * w223 - w119 * w225,
        w55 * w123 - w57 * w121 - (w125 * w224 + w59 * w130) + (w59 * w222 + w64 * w125),
        w62 * w126 - w60 * w128,
        w0 * w129 - w1 * w63,
        w17 * w129 - w63 * w83,
        w23 * w129 - w63 * w89,
        w29 * w129 - w63 * w95,
        w35 * w129 - w63 * w101,
        w41 * w129 - w63 * w107,
        w47 * w129 - w63 * w113,
        w53 * w129 - w63 * w119,
        w59 * w129 - w63 * w125,
        w61 * w128 - w62 * w127,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 10, 10)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 674 operations."""
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 60)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
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
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    w0 = ca.cos(link1_theta)
    w1 = w0 * c0
    w2 = link2_theta_dot**2
    w3 = ca.sin(link2_theta)
    w4 = w3 * c18
    w5 = link3_theta_dot**2
    w6 = ca.sin(link3_theta)
    w7 = w6 * c19
    w8 = link4_theta_dot**2
    w9 = ca.sin(link4_theta)
    w10 = w9 * c20
    w11 = link5_theta_dot**2
    w12 = ca.sin(link5_theta)
    w13 = w12 * c21
    w14 = link6_theta_dot**2
    w15 = ca.sin(link6_theta)
    w16 = w15 * c22
    w17 = link7_theta_dot**2
    w18 = ca.sin(link7_theta)
    w19 = w18 * c23
    w20 = link8_theta_dot**2
    w21 = ca.sin(link8_theta)
    w22 = w21 * c24
    w23 = link9_theta_dot**2
    w24 = ca.sin(link9_theta)
    w25 = w24 * c25
    w26 = link10_theta_dot**2
    w27 = ca.sin(link10_theta) * c26
    w28 = ca.cos(link10_theta) * c26
    w29 = w28 / c35
    w30 = w28 * c36
    w31 = c9 - w28 * w29
    w32 = w24 * c0
    w33 = w23 * w32
    w34 = c46 + w26 * w27 - w29 * w30 + w31 * w33
    w35 = w27 / c35
    w36 = w28 * w35
    w37 = ca.cos(link9_theta)
    w38 = w37 * c0
    w39 = w23 * w38
    w40 = w37 * c25
    w41 = w31 * w38
    w42 = w40 + w41 - w32 * w36
    w43 = w36 * w38
    w44 = c9 - w27 * w35
    w45 = w43 - w32 * w44
    w46 = c56 + w38 * w41 - (w32 * w45 + w32 * w43)
    w47 = w42 / w46
    w48 = w26 * w28 + w30 * w35 + w33 * w36 + w39 * w44
    w49 = w40 * c36 + w34 * w38 + w39 * w43 - w32 * w48
    w50 = c8 + w31 - w42 * w47
    w51 = w21 * c0
    w52 = w20 * w51
    w53 = c45 + w23 * w25 + w34 + w36 * w39 - w47 * w49 + w50 * w52
    w54 = w45 - w25
    w55 = w54 / w46
    w56 = w36 - w42 * w55
    w57 = ca.cos(link8_theta)
    w58 = w57 * c0
    w59 = w20 * w58
    w60 = w57 * c24
    w61 = w50 * w58
    w62 = w60 + w61 - w51 * w56
    w63 = w56 * w58
    w64 = c8 + w44 - w54 * w55
    w65 = w63 - w51 * w64
    w66 = c55 + w58 * w61 - (w51 * w65 + w51 * w63)
    w67 = w62 / w66
    w68 = w48 + w23 * w40 - w49 * w55 + w52 * w56 + w59 * w64
    w69 = w60 * c36 + w53 * w58 + w59 * w63 - w51 * w68
    w70 = c7 + w50 - w62 * w67
    w71 = w18 * c0
    w72 = w17 * w71
    w73 = c44 + w20 * w22 + w53 + w56 * w59 - w67 * w69 + w70 * w72
    w74 = w65 - w22
    w75 = w74 / w66
    w76 = w56 - w62 * w75
    w77 = ca.cos(link7_theta)
    w78 = w77 * c0
    w79 = w17 * w78
    w80 = w77 * c23
    w81 = w70 * w78
    w82 = w80 + w81 - w71 * w76
    w83 = w76 * w78
    w84 = c7 + w64 - w74 * w75
    w85 = w83 - w71 * w84
    w86 = c54 + w78 * w81 - (w71 * w85 + w71 * w83)
    w87 = w82 / w86
    w88 = w68 + w20 * w60 - w69 * w75 + w72 * w76 + w79 * w84
    w89 = w80 * c36 + w73 * w78 + w79 * w83 - w71 * w88
    w90 = c6 + w70 - w82 * w87
    w91 = w15 * c0
    w92 = w14 * w91
    w93 = c43 + w17 * w19 + w73 + w76 * w79 - w87 * w89 + w90 * w92
    w94 = w85 - w19
    w95 = w94 / w86
    w96 = w76 - w82 * w95
    w97 = ca.cos(link6_theta)
    w98 = w97 * c0
    w99 = w14 * w98
    w100 = w97 * c22
    w101 = w90 * w98
    w102 = w100 + w101 - w91 * w96
    w103 = w96 * w98
    w104 = c6 + w84 - w94 * w95
    w105 = w103 - w91 * w104
    w106 = c53 + w98 * w101 - (w91 * w105 + w91 * w103)
    w107 = w102 / w106
    w108 = w88 + w17 * w80 - w89 * w95 + w92 * w96 + w99 * w104
    w109 = w100 * c36 + w93 * w98 + w99 * w103 - w91 * w108
    w110 = c5 + w90 - w102 * w107
    w111 = w12 * c0
    w112 = w11 * w111
    w113 = c42 + w14 * w16 + w93 + w96 * w99 - w107 * w109 + w110 * w112
    w114 = w105 - w16
    w115 = w114 / w106
    w116 = w96 - w102 * w115
    w117 = ca.cos(link5_theta)
    w118 = w117 * c0
    w119 = w11 * w118
    w120 = w117 * c21
    w121 = w110 * w118
    w122 = w120 + w121 - w111 * w116
    w123 = w116 * w118
    w124 = c5 + w104 - w114 * w115
    w125 = w123 - w111 * w124
    w126 = c52 + w118 * w121 - (w111 * w125 + w111 * w123)
    w127 = w122 / w126
    w128 = w108 + w14 * w100 - w109 * w115 + w112 * w116 + w119 * w124
    w129 = w120 * c36 + w113 * w118 + w119 * w123 - w111 * w128
    w130 = c4 + w110 - w122 * w127
    w131 = w9 * c0
    w132 = w8 * w131
    w133 = c41 + w11 * w13 + w113 + w116 * w119 - w127 * w129 + w130 * w132
    w134 = w125 - w13
    w135 = w134 / w126
    w136 = w116 - w122 * w135
    w137 = ca.cos(link4_theta)
    w138 = w137 * c0
    w139 = w8 * w138
    w140 = w137 * c20
    w141 = w130 * w138
    w142 = w140 + w141 - w131 * w136
    w143 = w136 * w138
    w144 = c4 + w124 - w134 * w135
    w145 = w143 - w131 * w144
    w146 = c51 + w138 * w141 - (w131 * w145 + w131 * w143)
    w147 = w142 / w146
    w148 = w128 + w11 * w120 - w129 * w135 + w132 * w136 + w139 * w144
    w149 = w140 * c36 + w133 * w138 + w139 * w143 - w131 * w148
    w150 = c3 + w130 - w142 * w147
    w151 = w6 * c0
    w152 = w5 * w151
    w153 = c40 + w8 * w10 + w133 + w136 * w139 - w147 * w149 + w150 * w152
    w154 = w145 - w10
    w155 = w154 / w146
    w156 = w136 - w142 * w155
    w157 = ca.cos(link3_theta)
    w158 = w157 * c0
    w159 = w5 * w158
    w160 = w157 * c19
    w161 = w150 * w158
    w162 = w160 + w161 - w151 * w156
    w163 = w156 * w158
    w164 = c3 + w144 - w154 * w155
    w165 = w163 - w151 * w164
    w166 = c50 + w158 * w161 - (w151 * w165 + w151 * w163)
    w167 = w162 / w166
    w168 = w148 + w8 * w140 - w149 * w155 + w152 * w156 + w159 * w164
    w169 = w160 * c36 + w153 * w158 + w159 * w163 - w151 * w168
    w170 = c2 + w150 - w162 * w167
    w171 = w3 * c0
    w172 = w2 * w171
    w173 = c39 + w5 * w7 + w153 + w156 * w159 - w167 * w169 + w170 * w172
    w174 = w165 - w7
    w175 = w174 / w166
    w176 = w156 - w162 * w175
    w177 = ca.cos(link2_theta)
    w178 = w177 * c0
    w179 = w2 * w178
    w180 = w177 * c18
    w181 = w170 * w178
    w182 = w180 + w181 - w171 * w176
    w183 = w176 * w178
    w184 = c2 + w164 - w174 * w175
    w185 = w183 - w171 * w184
    w186 = c49 + w178 * w181 - (w171 * w185 + w171 * w183)
    w187 = w182 / w186
    w188 = w168 + w5 * w160 - w169 * w175 + w172 * w176 + w179 * w184
    w189 = w180 * c36 + w173 * w178 + w179 * w183 - w171 * w188
    w190 = c1 + w170 - w182 * w187
    w191 = link1_theta_dot**2
    w192 = ca.sin(link1_theta) * c0
    w193 = w191 * w192
    w194 = w185 - w4
    w195 = w194 / w186
    w196 = w176 - w182 * w195
    w197 = w1 * w196
    w198 = w1 * w191
    w199 = c1 + w184 - w194 * w195
    w200 = w0 * c37 + w1 * (c38 + w2 * w4 + w173 + w176 * w179 - w187 * w189 + w190 * w193) + w197 * w198 - w192 * (w188 + w2 * w180 - w189 * w195 + w193 * w196 + w198 * w199)
    w201 = w200 / (c48 + w1 * (w1 * w190) - (w192 * (w197 - w192 * w199) + w192 * w197))
    w202 = w1 * w201 - w193
    w203 = w198 + w192 * w201
    w204 = (w189 - (w182 * w202 - w194 * w203)) / w186
    w205 = w202 + w178 * w204 - w172
    w206 = w179 + (w203 + w171 * w204)
    w207 = (w169 - (w162 * w205 - w174 * w206)) / w166
    w208 = w205 + w158 * w207 - w152
    w209 = w159 + (w206 + w151 * w207)
    w210 = (w149 - (w142 * w208 - w154 * w209)) / w146
    w211 = w208 + w138 * w210 - w132
    w212 = w139 + (w209 + w131 * w210)
    w213 = (w129 - (w122 * w211 - w134 * w212)) / w126
    w214 = w211 + w118 * w213 - w112
    w215 = w119 + (w212 + w111 * w213)
    w216 = (w109 - (w102 * w214 - w114 * w215)) / w106
    w217 = w214 + w98 * w216 - w92
    w218 = w99 + (w215 + w91 * w216)
    w219 = (w89 - (w82 * w217 - w94 * w218)) / w86
    w220 = w217 + w78 * w219 - w72
    w221 = w79 + (w218 + w71 * w219)
    w222 = (w69 - (w62 * w220 - w74 * w221)) / w66
    w223 = w220 + w58 * w222 - w52
    w224 = w59 + (w221 + w51 * w222)
    w225 = (w49 - (w42 * w223 - w54 * w224)) / w46
    q_i_ddot = ca.vertcat(
        w201,
        w204,
        w207,
        w210,
        w213,
        w216,
        w219,
        w222,
        w225,
        (w30 - (w27 * (w39 + (w224 + w32 * w225)) + w28 * (w223 + w38 * w225 - w33))) / c35,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 255 operations."""
    p = ca.SX.sym("p", 12)
    link_length = p[0]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        link_length,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 21)
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
    )
    axes = ca.reshape(axes, 9, 21)
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
