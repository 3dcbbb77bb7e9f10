"""Chain of 10 links: equations of motion, emitted by symgen from the scene `chain`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 link1.theta [rad], 1 link2.theta [rad], 2 link3.theta [rad], 3 link4.theta [rad], 4 link5.theta [rad],
    5 link6.theta [rad], 6 link7.theta [rad], 7 link8.theta [rad], 8 link9.theta [rad], 9 link10.theta [rad]

q_d, the dependent coordinates by index:
    0 link1.x [m], 1 link1.y [m], 2 link2.x [m], 3 link2.y [m], 4 link3.x [m], 5 link3.y [m], 6 link4.x [m],
    7 link4.y [m], 8 link5.x [m], 9 link5.y [m], 10 link6.x [m], 11 link6.y [m], 12 link7.x [m],
    13 link7.y [m], 14 link8.x [m], 15 link8.y [m], 16 link9.x [m], 17 link9.y [m], 18 link10.x [m],
    19 link10.y [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 12) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    134 operations.
    """
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
    # intermediate terms (53)
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
    w11 = w1 * link2_mass
    w12 = link_length * w10
    w13 = w1 * link3_mass
    w14 = link_length * w9
    w15 = w1 * link4_mass
    w16 = link_length * w8
    w17 = w1 * link5_mass
    w18 = link_length * w7
    w19 = w1 * link6_mass
    w20 = link_length * w6
    w21 = w1 * link7_mass
    w22 = link_length * w5
    w23 = w1 * link8_mass
    w24 = link_length * w4
    w25 = w1 * link9_mass
    w26 = link_length * link10_mass
    w27 = w0 + w2 * link2_mass
    w28 = w0 + w2 * link3_mass
    w29 = w0 + w2 * link4_mass
    w30 = w0 + w2 * link5_mass
    w31 = w0 + w2 * link6_mass
    w32 = w0 + w2 * link7_mass
    w33 = w0 + w2 * link8_mass
    w34 = w0 + w2 * link9_mass
    w35 = link1_mass * w1
    w36 = w35 * gravity_y
    w37 = link2_mass * gravity_y
    w38 = link3_mass * gravity_y
    w39 = link4_mass * gravity_y
    w40 = link5_mass * gravity_y
    w41 = link6_mass * gravity_y
    w42 = link7_mass * gravity_y
    w43 = link8_mass * gravity_y
    w44 = link9_mass * gravity_y
    w45 = link10_mass * gravity_y
    w46 = w44 + w45
    w47 = w43 + w46
    w48 = w42 + w47
    w49 = w41 + w48
    w50 = w40 + w49
    w51 = w39 + w50
    w52 = w38 + w51
    # outputs
    c = ca.vertcat(
        link_length,  # link_length
        link2_mass,  # link2_mass
        link3_mass,  # link3_mass
        link4_mass,  # link4_mass
        link5_mass,  # link5_mass
        link6_mass,  # link6_mass
        link7_mass,  # link7_mass
        link8_mass,  # link8_mass
        link9_mass,  # link9_mass
        link10_mass,  # link10_mass
        w4,  # c10
        w5,  # c11
        w6,  # c12
        w7,  # c13
        w8,  # c14
        w9,  # c15
        w10,  # c16
        w3 + link_length * (link_length * (link2_mass + w10)),  # c17
        w11,  # c18
        w13,  # c19
        w15,  # c20
        w17,  # c21
        w19,  # c22
        w21,  # c23
        w23,  # c24
        w25,  # c25
        w1 * link10_mass,  # c26
        w27 + link_length * w12,  # c27
        w28 + link_length * w14,  # c28
        w29 + link_length * w16,  # c29
        w30 + link_length * w18,  # c30
        w31 + link_length * w20,  # c31
        w32 + link_length * w22,  # c32
        w33 + link_length * w24,  # c33
        w34 + link_length * w26,  # c34
        w0 + w2 * link10_mass,  # c35
        gravity_y,  # gravity_y
        w36,  # c37
        w37,  # c38
        w38,  # c39
        w39,  # c40
        w40,  # c41
        w41,  # c42
        w42,  # c43
        w43,  # c44
        w44,  # c45
        w45,  # c46
        -link_length,  # c47
        link1_mass,  # link1_mass
        w3,  # c49
        w27,  # c50
        w28,  # c51
        w29,  # c52
        w30,  # c53
        w31,  # c54
        w32,  # c55
        w33,  # c56
        w34,  # c57
        w35,  # c58
        link1_mass * gravity_y,  # c59
        -gravity_y,  # c60
        w11 + w12,  # c61
        w13 + w14,  # c62
        w15 + w16,  # c63
        w17 + w18,  # c64
        w19 + w20,  # c65
        w21 + w22,  # c66
        w23 + w24,  # c67
        w25 + w26,  # c68
        -(w36 + link_length * (w37 + w52)),  # c69
        -(w11 * gravity_y + link_length * w52),  # c70
        -(w13 * gravity_y + link_length * w51),  # c71
        -(w15 * gravity_y + link_length * w50),  # c72
        -(w17 * gravity_y + link_length * w49),  # c73
        -(w19 * gravity_y + link_length * w48),  # c74
        -(w21 * gravity_y + link_length * w47),  # c75
        -(w23 * gravity_y + link_length * w46),  # c76
        -(w25 * gravity_y + link_length * w45),  # c77
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 10 x 10) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 10) [N, N m]: condensed force S^T (Q* - M s)
    428 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    link2_mass = c[1]
    link3_mass = c[2]
    link4_mass = c[3]
    link5_mass = c[4]
    link6_mass = c[5]
    link7_mass = c[6]
    link8_mass = c[7]
    link9_mass = c[8]
    link10_mass = c[9]
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
    gravity_y = c[36]
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
    # intermediate terms (157)
    w0 = ca.cos(link1_theta)
    w1 = w0 * link_length
    w2 = ca.sin(link1_theta) * link_length
    w3 = ca.cos(link2_theta)
    w4 = w3 * c18
    w5 = w3 * link_length
    w6 = ca.sin(link2_theta)
    w7 = w6 * c18
    w8 = w6 * link_length
    w9 = w1 * (w4 + w5 * c16) + w2 * (w7 + w8 * c16)
    w10 = ca.cos(link3_theta)
    w11 = w10 * c19
    w12 = w10 * link_length
    w13 = w11 + w12 * c15
    w14 = ca.sin(link3_theta)
    w15 = w14 * c19
    w16 = w14 * link_length
    w17 = w15 + w16 * c15
    w18 = w1 * w13 + w2 * w17
    w19 = ca.cos(link4_theta)
    w20 = w19 * c20
    w21 = w19 * link_length
    w22 = w20 + w21 * c14
    w23 = ca.sin(link4_theta)
    w24 = w23 * c20
    w25 = w23 * link_length
    w26 = w24 + w25 * c14
    w27 = w1 * w22 + w2 * w26
    w28 = ca.cos(link5_theta)
    w29 = w28 * c21
    w30 = w28 * link_length
    w31 = w29 + w30 * c13
    w32 = ca.sin(link5_theta)
    w33 = w32 * c21
    w34 = w32 * link_length
    w35 = w33 + w34 * c13
    w36 = w1 * w31 + w2 * w35
    w37 = ca.cos(link6_theta)
    w38 = w37 * c22
    w39 = w37 * link_length
    w40 = w38 + w39 * c12
    w41 = ca.sin(link6_theta)
    w42 = w41 * c22
    w43 = w41 * link_length
    w44 = w42 + w43 * c12
    w45 = w1 * w40 + w2 * w44
    w46 = ca.cos(link7_theta)
    w47 = w46 * c23
    w48 = w46 * link_length
    w49 = w47 + w48 * c11
    w50 = ca.sin(link7_theta)
    w51 = w50 * c23
    w52 = w50 * link_length
    w53 = w51 + w52 * c11
    w54 = w1 * w49 + w2 * w53
    w55 = ca.cos(link8_theta)
    w56 = w55 * c24
    w57 = w55 * link_length
    w58 = w56 + w57 * c10
    w59 = ca.sin(link8_theta)
    w60 = w59 * c24
    w61 = w59 * link_length
    w62 = w60 + w61 * c10
    w63 = w1 * w58 + w2 * w62
    w64 = ca.cos(link9_theta)
    w65 = w64 * c25
    w66 = w64 * link_length
    w67 = w65 + w66 * link10_mass
    w68 = ca.sin(link9_theta)
    w69 = w68 * c25
    w70 = w68 * link_length
    w71 = w69 + w70 * link10_mass
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
    w131 = w74 * w129 + c46 + w130 * link10_mass
    w132 = w69 * w127 + c45 + w128 * link9_mass + w131
    w133 = w60 * w125 + c44 + w126 * link8_mass + w132
    w134 = w51 * w123 + c43 + w124 * link7_mass + w133
    w135 = w42 * w121 + c42 + w122 * link6_mass + w134
    w136 = w33 * w119 + c41 + w120 * link5_mass + w135
    w137 = w24 * w117 + c40 + w118 * link4_mass + w136
    w138 = w15 * w115 + c39 + w116 * link3_mass + w137
    w139 = w1 * w113
    w140 = w139 + w5 * w112
    w141 = w140 + w12 * w115
    w142 = w141 + w21 * w117
    w143 = w142 + w30 * w119
    w144 = w143 + w39 * w121
    w145 = w144 + w48 * w123
    w146 = w145 + w57 * w125
    w147 = w146 + w66 * w127
    w148 = w73 * w129 + w147 * link10_mass
    w149 = w65 * w127 + w146 * link9_mass + w148
    w150 = w56 * w125 + w145 * link8_mass + w149
    w151 = w47 * w123 + w144 * link7_mass + w150
    w152 = w38 * w121 + w143 * link6_mass + w151
    w153 = w29 * w119 + w142 * link5_mass + w152
    w154 = w20 * w117 + w141 * link4_mass + w153
    w155 = w11 * w115 + w140 * link3_mass + w154
    w156 = w0 * c37 + w1 * (w7 * w112 + c38 + w114 * link2_mass + w138) - w2 * (w4 * w112 + w139 * link2_mass + w155)
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(c17, w9, w18, w27, w36, w45, w54, w63, w72, w75),  # link1.theta
        ca.horzcat(w9, c27, w76, w77, w78, w79, w80, w81, w82, w83),  # link2.theta
        ca.horzcat(w18, w76, c28, w84, w85, w86, w87, w88, w89, w90),  # link3.theta
        ca.horzcat(w27, w77, w84, c29, w91, w92, w93, w94, w95, w96),  # link4.theta
        ca.horzcat(w36, w78, w85, w91, c30, w97, w98, w99, w100, w101),  # link5.theta
        ca.horzcat(w45, w79, w86, w92, w97, c31, w102, w103, w104, w105),  # link6.theta
        ca.horzcat(w54, w80, w87, w93, w98, w102, c32, w106, w107, w108),  # link7.theta
        ca.horzcat(w63, w81, w88, w94, w99, w103, w106, c33, w109, w110),  # link8.theta
        ca.horzcat(w72, w82, w89, w95, w100, w104, w107, w109, c34, w111),  # link9.theta
        ca.horzcat(w75, w83, w90, w96, w101, w105, w108, w110, w111, c35),  # link10.theta
    )
    Q_hat = ca.vertcat(
        w156,  # link1.theta
        w4 * gravity_y - (w7 * w139 - w4 * w114) + w5 * w138 - w8 * w155,  # link2.theta
        w11 * gravity_y - (w15 * w140 - w11 * w116) + w12 * w137 - w16 * w154,  # link3.theta
        w20 * gravity_y - (w24 * w141 - w20 * w118) + w21 * w136 - w25 * w153,  # link4.theta
        w29 * gravity_y - (w33 * w142 - w29 * w120) + w30 * w135 - w34 * w152,  # link5.theta
        w38 * gravity_y - (w42 * w143 - w38 * w122) + w39 * w134 - w43 * w151,  # link6.theta
        w47 * gravity_y - (w51 * w144 - w47 * w124) + w48 * w133 - w52 * w150,  # link7.theta
        w56 * gravity_y - (w60 * w145 - w56 * w126) + w57 * w132 - w61 * w149,  # link8.theta
        w65 * gravity_y - (w69 * w146 - w65 * w128) + w66 * w131 - w70 * w148,  # link9.theta
        w73 * gravity_y - (w74 * w147 - w73 * w130),  # link10.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 20) [mixed]: dependent coordinates after one Newton step
    52 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    c = ca.SX.sym("c", 78)
    link1_theta = q_i[0]
    link2_theta = q_i[1]
    link3_theta = q_i[2]
    link4_theta = q_i[3]
    link5_theta = q_i[4]
    link6_theta = q_i[5]
    link7_theta = q_i[6]
    link8_theta = q_i[7]
    link9_theta = q_i[8]
    link_length = c[0]
    # intermediate terms (16)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta) * link_length
    w2 = w0 + ca.cos(link2_theta) * link_length
    w3 = w1 + ca.sin(link2_theta) * link_length
    w4 = w2 + ca.cos(link3_theta) * link_length
    w5 = w3 + ca.sin(link3_theta) * link_length
    w6 = w4 + ca.cos(link4_theta) * link_length
    w7 = w5 + ca.sin(link4_theta) * link_length
    w8 = w6 + ca.cos(link5_theta) * link_length
    w9 = w7 + ca.sin(link5_theta) * link_length
    w10 = w8 + ca.cos(link6_theta) * link_length
    w11 = w9 + ca.sin(link6_theta) * link_length
    w12 = w10 + ca.cos(link7_theta) * link_length
    w13 = w11 + ca.sin(link7_theta) * link_length
    w14 = w12 + ca.cos(link8_theta) * link_length
    w15 = w13 + ca.sin(link8_theta) * link_length
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        w0,  # link2.x
        w1,  # link2.y
        w2,  # link3.x
        w3,  # link3.y
        w4,  # link4.x
        w5,  # link4.y
        w6,  # link5.x
        w7,  # link5.y
        w8,  # link6.x
        w9,  # link6.y
        w10,  # link7.x
        w11,  # link7.y
        w12,  # link8.x
        w13,  # link8.y
        w14,  # link9.x
        w15,  # link9.y
        w14 + ca.cos(link9_theta) * link_length,  # link10.x
        w15 + ca.sin(link9_theta) * link_length,  # link10.y
    )
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 20) [mixed]: rates of the dependent coordinates
    78 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    c47 = c[47]
    # intermediate terms (16)
    w0 = ca.sin(link1_theta) * link_length * link1_theta_dot
    w1 = link1_theta_dot * (ca.cos(link1_theta) * link_length)
    w2 = w0 + ca.sin(link2_theta) * link_length * link2_theta_dot
    w3 = w1 + link2_theta_dot * (ca.cos(link2_theta) * link_length)
    w4 = w2 + ca.sin(link3_theta) * link_length * link3_theta_dot
    w5 = w3 + link3_theta_dot * (ca.cos(link3_theta) * link_length)
    w6 = w4 + ca.sin(link4_theta) * link_length * link4_theta_dot
    w7 = w5 + link4_theta_dot * (ca.cos(link4_theta) * link_length)
    w8 = w6 + ca.sin(link5_theta) * link_length * link5_theta_dot
    w9 = w7 + link5_theta_dot * (ca.cos(link5_theta) * link_length)
    w10 = w8 + ca.sin(link6_theta) * link_length * link6_theta_dot
    w11 = w9 + link6_theta_dot * (ca.cos(link6_theta) * link_length)
    w12 = w10 + ca.sin(link7_theta) * link_length * link7_theta_dot
    w13 = w11 + link7_theta_dot * (ca.cos(link7_theta) * link_length)
    w14 = w12 + ca.sin(link8_theta) * link_length * link8_theta_dot
    w15 = w13 + link8_theta_dot * (ca.cos(link8_theta) * link_length)
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        -w0,  # link2.x
        w1,  # link2.y
        -w2,  # link3.x
        w3,  # link3.y
        -w4,  # link4.x
        w5,  # link4.y
        -w6,  # link5.x
        w7,  # link5.y
        -w8,  # link6.x
        w9,  # link6.y
        -w10,  # link7.x
        w11,  # link7.y
        -w12,  # link8.x
        w13,  # link8.y
        -w14,  # link9.x
        w15,  # link9.y
        ca.sin(link9_theta) * c47 * link9_theta_dot - w14,  # link10.x
        w15 + link9_theta_dot * (ca.cos(link9_theta) * link_length),  # link10.y
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 20) [mixed]: accelerations of the dependent coordinates
    124 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    # intermediate terms (43)
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * link_length
    w2 = ca.sin(link1_theta) * link_length
    w3 = w0 * w1 + w2 * link1_theta_ddot
    w4 = w1 * link1_theta_ddot - w0 * w2
    w5 = link2_theta_dot**2
    w6 = ca.cos(link2_theta) * link_length
    w7 = ca.sin(link2_theta) * link_length
    w8 = w3 + w5 * w6 + w7 * link2_theta_ddot
    w9 = w4 - w5 * w7 + w6 * link2_theta_ddot
    w10 = link3_theta_dot**2
    w11 = ca.cos(link3_theta) * link_length
    w12 = ca.sin(link3_theta) * link_length
    w13 = w8 + w10 * w11 + w12 * link3_theta_ddot
    w14 = w9 - w10 * w12 + w11 * link3_theta_ddot
    w15 = link4_theta_dot**2
    w16 = ca.cos(link4_theta) * link_length
    w17 = ca.sin(link4_theta) * link_length
    w18 = w13 + w15 * w16 + w17 * link4_theta_ddot
    w19 = w14 - w15 * w17 + w16 * link4_theta_ddot
    w20 = link5_theta_dot**2
    w21 = ca.cos(link5_theta) * link_length
    w22 = ca.sin(link5_theta) * link_length
    w23 = w18 + w20 * w21 + w22 * link5_theta_ddot
    w24 = w19 - w20 * w22 + w21 * link5_theta_ddot
    w25 = link6_theta_dot**2
    w26 = ca.cos(link6_theta) * link_length
    w27 = ca.sin(link6_theta) * link_length
    w28 = w23 + w25 * w26 + w27 * link6_theta_ddot
    w29 = w24 - w25 * w27 + w26 * link6_theta_ddot
    w30 = link7_theta_dot**2
    w31 = ca.cos(link7_theta) * link_length
    w32 = ca.sin(link7_theta) * link_length
    w33 = w28 + w30 * w31 + w32 * link7_theta_ddot
    w34 = w29 - w30 * w32 + w31 * link7_theta_ddot
    w35 = link8_theta_dot**2
    w36 = ca.cos(link8_theta) * link_length
    w37 = ca.sin(link8_theta) * link_length
    w38 = w33 + w35 * w36 + w37 * link8_theta_ddot
    w39 = w34 - w35 * w37 + w36 * link8_theta_ddot
    w40 = link9_theta_dot**2
    w41 = ca.cos(link9_theta) * link_length
    w42 = ca.sin(link9_theta) * link_length
    # outputs
    q_d_ddot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        -w3,  # link2.x
        w4,  # link2.y
        -w8,  # link3.x
        w9,  # link3.y
        -w13,  # link4.x
        w14,  # link4.y
        -w18,  # link5.x
        w19,  # link5.y
        -w23,  # link6.x
        w24,  # link6.y
        -w28,  # link7.x
        w29,  # link7.y
        -w33,  # link8.x
        w34,  # link8.y
        -w38,  # link9.x
        w39,  # link9.y
        -(w38 + w40 * w41 + w42 * link9_theta_ddot),  # link10.x
        w39 - w40 * w42 + w41 * link9_theta_ddot,  # link10.y
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 20) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 20 x 30) [SI]: constraint Jacobian
    gives C_t (n_c = 20) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 20) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 20) [m/s^2, rad/s^2]: right-hand side at acceleration level
    126 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    # intermediate terms (27)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta) * link_length
    w2 = ca.cos(link2_theta) * link_length
    w3 = ca.sin(link2_theta) * link_length
    w4 = ca.cos(link3_theta) * link_length
    w5 = ca.sin(link3_theta) * link_length
    w6 = ca.cos(link4_theta) * link_length
    w7 = ca.sin(link4_theta) * link_length
    w8 = ca.cos(link5_theta) * link_length
    w9 = ca.sin(link5_theta) * link_length
    w10 = ca.cos(link6_theta) * link_length
    w11 = ca.sin(link6_theta) * link_length
    w12 = ca.cos(link7_theta) * link_length
    w13 = ca.sin(link7_theta) * link_length
    w14 = ca.cos(link8_theta) * link_length
    w15 = ca.sin(link8_theta) * link_length
    w16 = ca.cos(link9_theta) * link_length
    w17 = ca.sin(link9_theta) * link_length
    w18 = link1_theta_dot**2
    w19 = link2_theta_dot**2
    w20 = link3_theta_dot**2
    w21 = link4_theta_dot**2
    w22 = link5_theta_dot**2
    w23 = link6_theta_dot**2
    w24 = link7_theta_dot**2
    w25 = link8_theta_dot**2
    w26 = link9_theta_dot**2
    # outputs
    C = ca.vertcat(
        link1_x,  # hinge1.x
        link1_y,  # hinge1.y
        link2_x - (link1_x + w0),  # hinge2.x
        link2_y - (link1_y + w1),  # hinge2.y
        link3_x - (link2_x + w2),  # hinge3.x
        link3_y - (link2_y + w3),  # hinge3.y
        link4_x - (link3_x + w4),  # hinge4.x
        link4_y - (link3_y + w5),  # hinge4.y
        link5_x - (link4_x + w6),  # hinge5.x
        link5_y - (link4_y + w7),  # hinge5.y
        link6_x - (link5_x + w8),  # hinge6.x
        link6_y - (link5_y + w9),  # hinge6.y
        link7_x - (link6_x + w10),  # hinge7.x
        link7_y - (link6_y + w11),  # hinge7.y
        link8_x - (link7_x + w12),  # hinge8.x
        link8_y - (link7_y + w13),  # hinge8.y
        link9_x - (link8_x + w14),  # hinge9.x
        link9_y - (link8_y + w15),  # hinge9.y
        link10_x - (link9_x + w16),  # hinge10.x
        link10_y - (link9_y + w17),  # hinge10.y
    )
    C_q = ca.SX(20, 30)
    # hinge1.x
    C_q[0, 0] = 1.0
    # hinge1.y
    C_q[1, 1] = 1.0
    # hinge2.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # hinge2.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    # hinge3.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w3
    C_q[4, 6] = 1.0
    # hinge3.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w2
    C_q[5, 7] = 1.0
    # hinge4.x
    C_q[6, 6] = -1.0
    C_q[6, 8] = w5
    C_q[6, 9] = 1.0
    # hinge4.y
    C_q[7, 7] = -1.0
    C_q[7, 8] = -w4
    C_q[7, 10] = 1.0
    # hinge5.x
    C_q[8, 9] = -1.0
    C_q[8, 11] = w7
    C_q[8, 12] = 1.0
    # hinge5.y
    C_q[9, 10] = -1.0
    C_q[9, 11] = -w6
    C_q[9, 13] = 1.0
    # hinge6.x
    C_q[10, 12] = -1.0
    C_q[10, 14] = w9
    C_q[10, 15] = 1.0
    # hinge6.y
    C_q[11, 13] = -1.0
    C_q[11, 14] = -w8
    C_q[11, 16] = 1.0
    # hinge7.x
    C_q[12, 15] = -1.0
    C_q[12, 17] = w11
    C_q[12, 18] = 1.0
    # hinge7.y
    C_q[13, 16] = -1.0
    C_q[13, 17] = -w10
    C_q[13, 19] = 1.0
    # hinge8.x
    C_q[14, 18] = -1.0
    C_q[14, 20] = w13
    C_q[14, 21] = 1.0
    # hinge8.y
    C_q[15, 19] = -1.0
    C_q[15, 20] = -w12
    C_q[15, 22] = 1.0
    # hinge9.x
    C_q[16, 21] = -1.0
    C_q[16, 23] = w15
    C_q[16, 24] = 1.0
    # hinge9.y
    C_q[17, 22] = -1.0
    C_q[17, 23] = -w14
    C_q[17, 25] = 1.0
    # hinge10.x
    C_q[18, 24] = -1.0
    C_q[18, 26] = w17
    C_q[18, 27] = 1.0
    # hinge10.y
    C_q[19, 25] = -1.0
    C_q[19, 26] = -w16
    C_q[19, 28] = 1.0
    C_t = ca.SX(20, 1)
    nu = ca.SX(20, 1)
    gamma = ca.vertcat(
        0.0,  # hinge1.x
        0.0,  # hinge1.y
        -(w0 * w18),  # hinge2.x
        -(w1 * w18),  # hinge2.y
        -(w2 * w19),  # hinge3.x
        -(w3 * w19),  # hinge3.y
        -(w4 * w20),  # hinge4.x
        -(w5 * w20),  # hinge4.y
        -(w6 * w21),  # hinge5.x
        -(w7 * w21),  # hinge5.y
        -(w8 * w22),  # hinge6.x
        -(w9 * w22),  # hinge6.y
        -(w10 * w23),  # hinge7.x
        -(w11 * w23),  # hinge7.y
        -(w12 * w24),  # hinge8.x
        -(w13 * w24),  # hinge8.y
        -(w14 * w25),  # hinge9.x
        -(w15 * w25),  # hinge9.y
        -(w16 * w26),  # hinge10.x
        -(w17 * w26),  # hinge10.y
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 30 x 30) [SI]: mass matrix in all coordinates
    gives K (n x n = 30 x 30) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 30) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 30) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 30) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 20 x 30) [SI]: constraint Jacobian
    gives gamma (n_c = 20) [m/s^2, rad/s^2]: right-hand side at acceleration level
    163 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    link2_mass = c[1]
    link3_mass = c[2]
    link4_mass = c[3]
    link5_mass = c[4]
    link6_mass = c[5]
    link7_mass = c[6]
    link8_mass = c[7]
    link9_mass = c[8]
    link10_mass = c[9]
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
    gravity_y = c[36]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    link1_mass = c[48]
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
    # intermediate terms (106)
    w0 = ca.sin(link1_theta)
    w1 = w0 * c58
    w2 = -w1
    w3 = ca.cos(link1_theta)
    w4 = w3 * c58
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
    w78 = w4 * gravity_y
    w79 = w9 * gravity_y
    w80 = w14 * gravity_y
    w81 = w19 * gravity_y
    w82 = w24 * gravity_y
    w83 = w29 * gravity_y
    w84 = w34 * gravity_y
    w85 = w39 * gravity_y
    w86 = w44 * gravity_y
    w87 = w47 * gravity_y
    w88 = w0 * link_length
    w89 = w3 * link_length
    w90 = w5 * link_length
    w91 = w8 * link_length
    w92 = w10 * link_length
    w93 = w13 * link_length
    w94 = w15 * link_length
    w95 = w18 * link_length
    w96 = w20 * link_length
    w97 = w23 * link_length
    w98 = w25 * link_length
    w99 = w28 * link_length
    w100 = w30 * link_length
    w101 = w33 * link_length
    w102 = w35 * link_length
    w103 = w38 * link_length
    w104 = w40 * link_length
    w105 = w43 * link_length
    # outputs
    M = ca.SX(30, 30)
    # link1.x
    M[0, 0] = link1_mass
    M[0, 2] = w2
    # link1.y
    M[1, 1] = link1_mass
    M[1, 2] = w4
    # link1.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c49
    # link2.x
    M[3, 3] = link2_mass
    M[3, 5] = w7
    # link2.y
    M[4, 4] = link2_mass
    M[4, 5] = w9
    # link2.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c50
    # link3.x
    M[6, 6] = link3_mass
    M[6, 8] = w12
    # link3.y
    M[7, 7] = link3_mass
    M[7, 8] = w14
    # link3.theta
    M[8, 6] = w12
    M[8, 7] = w14
    M[8, 8] = c51
    # link4.x
    M[9, 9] = link4_mass
    M[9, 11] = w17
    # link4.y
    M[10, 10] = link4_mass
    M[10, 11] = w19
    # link4.theta
    M[11, 9] = w17
    M[11, 10] = w19
    M[11, 11] = c52
    # link5.x
    M[12, 12] = link5_mass
    M[12, 14] = w22
    # link5.y
    M[13, 13] = link5_mass
    M[13, 14] = w24
    # link5.theta
    M[14, 12] = w22
    M[14, 13] = w24
    M[14, 14] = c53
    # link6.x
    M[15, 15] = link6_mass
    M[15, 17] = w27
    # link6.y
    M[16, 16] = link6_mass
    M[16, 17] = w29
    # link6.theta
    M[17, 15] = w27
    M[17, 16] = w29
    M[17, 17] = c54
    # link7.x
    M[18, 18] = link7_mass
    M[18, 20] = w32
    # link7.y
    M[19, 19] = link7_mass
    M[19, 20] = w34
    # link7.theta
    M[20, 18] = w32
    M[20, 19] = w34
    M[20, 20] = c55
    # link8.x
    M[21, 21] = link8_mass
    M[21, 23] = w37
    # link8.y
    M[22, 22] = link8_mass
    M[22, 23] = w39
    # link8.theta
    M[23, 21] = w37
    M[23, 22] = w39
    M[23, 23] = c56
    # link9.x
    M[24, 24] = link9_mass
    M[24, 26] = w42
    # link9.y
    M[25, 25] = link9_mass
    M[25, 26] = w44
    # link9.theta
    M[26, 24] = w42
    M[26, 25] = w44
    M[26, 26] = c57
    # link10.x
    M[27, 27] = link10_mass
    M[27, 29] = w46
    # link10.y
    M[28, 28] = link10_mass
    M[28, 29] = w47
    # link10.theta
    M[29, 27] = w46
    M[29, 28] = w47
    M[29, 29] = c35
    K = ca.SX(30, 30)
    Q_v = ca.vertcat(
        w49,  # link1.x
        w50,  # link1.y
        0.0,  # link1.theta
        w52,  # link2.x
        w53,  # link2.y
        0.0,  # link2.theta
        w55,  # link3.x
        w56,  # link3.y
        0.0,  # link3.theta
        w58,  # link4.x
        w59,  # link4.y
        0.0,  # link4.theta
        w61,  # link5.x
        w62,  # link5.y
        0.0,  # link5.theta
        w64,  # link6.x
        w65,  # link6.y
        0.0,  # link6.theta
        w67,  # link7.x
        w68,  # link7.y
        0.0,  # link7.theta
        w70,  # link8.x
        w71,  # link8.y
        0.0,  # link8.theta
        w73,  # link9.x
        w74,  # link9.y
        0.0,  # link9.theta
        w76,  # link10.x
        w77,  # link10.y
        0.0,  # link10.theta
    )
    Q_F = ca.vertcat(
        0.0,  # link1.x
        c59,  # link1.y
        w78,  # link1.theta
        0.0,  # link2.x
        c38,  # link2.y
        w79,  # link2.theta
        0.0,  # link3.x
        c39,  # link3.y
        w80,  # link3.theta
        0.0,  # link4.x
        c40,  # link4.y
        w81,  # link4.theta
        0.0,  # link5.x
        c41,  # link5.y
        w82,  # link5.theta
        0.0,  # link6.x
        c42,  # link6.y
        w83,  # link6.theta
        0.0,  # link7.x
        c43,  # link7.y
        w84,  # link7.theta
        0.0,  # link8.x
        c44,  # link8.y
        w85,  # link8.theta
        0.0,  # link9.x
        c45,  # link9.y
        w86,  # link9.theta
        0.0,  # link10.x
        c46,  # link10.y
        w87,  # link10.theta
    )
    Q_star = ca.vertcat(
        w49,  # link1.x
        w50 + c59,  # link1.y
        w78,  # link1.theta
        w52,  # link2.x
        c38 + w53,  # link2.y
        w79,  # link2.theta
        w55,  # link3.x
        c39 + w56,  # link3.y
        w80,  # link3.theta
        w58,  # link4.x
        c40 + w59,  # link4.y
        w81,  # link4.theta
        w61,  # link5.x
        c41 + w62,  # link5.y
        w82,  # link5.theta
        w64,  # link6.x
        c42 + w65,  # link6.y
        w83,  # link6.theta
        w67,  # link7.x
        c43 + w68,  # link7.y
        w84,  # link7.theta
        w70,  # link8.x
        c44 + w71,  # link8.y
        w85,  # link8.theta
        w73,  # link9.x
        c45 + w74,  # link9.y
        w86,  # link9.theta
        w76,  # link10.x
        c46 + w77,  # link10.y
        w87,  # link10.theta
    )
    C_q = ca.SX(20, 30)
    # hinge1.x
    C_q[0, 0] = 1.0
    # hinge1.y
    C_q[1, 1] = 1.0
    # hinge2.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w88
    C_q[2, 3] = 1.0
    # hinge2.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w89
    C_q[3, 4] = 1.0
    # hinge3.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w90
    C_q[4, 6] = 1.0
    # hinge3.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w91
    C_q[5, 7] = 1.0
    # hinge4.x
    C_q[6, 6] = -1.0
    C_q[6, 8] = w92
    C_q[6, 9] = 1.0
    # hinge4.y
    C_q[7, 7] = -1.0
    C_q[7, 8] = -w93
    C_q[7, 10] = 1.0
    # hinge5.x
    C_q[8, 9] = -1.0
    C_q[8, 11] = w94
    C_q[8, 12] = 1.0
    # hinge5.y
    C_q[9, 10] = -1.0
    C_q[9, 11] = -w95
    C_q[9, 13] = 1.0
    # hinge6.x
    C_q[10, 12] = -1.0
    C_q[10, 14] = w96
    C_q[10, 15] = 1.0
    # hinge6.y
    C_q[11, 13] = -1.0
    C_q[11, 14] = -w97
    C_q[11, 16] = 1.0
    # hinge7.x
    C_q[12, 15] = -1.0
    C_q[12, 17] = w98
    C_q[12, 18] = 1.0
    # hinge7.y
    C_q[13, 16] = -1.0
    C_q[13, 17] = -w99
    C_q[13, 19] = 1.0
    # hinge8.x
    C_q[14, 18] = -1.0
    C_q[14, 20] = w100
    C_q[14, 21] = 1.0
    # hinge8.y
    C_q[15, 19] = -1.0
    C_q[15, 20] = -w101
    C_q[15, 22] = 1.0
    # hinge9.x
    C_q[16, 21] = -1.0
    C_q[16, 23] = w102
    C_q[16, 24] = 1.0
    # hinge9.y
    C_q[17, 22] = -1.0
    C_q[17, 23] = -w103
    C_q[17, 25] = 1.0
    # hinge10.x
    C_q[18, 24] = -1.0
    C_q[18, 26] = w104
    C_q[18, 27] = 1.0
    # hinge10.y
    C_q[19, 25] = -1.0
    C_q[19, 26] = -w105
    C_q[19, 28] = 1.0
    gamma = ca.vertcat(
        0.0,  # hinge1.x
        0.0,  # hinge1.y
        -(w48 * w89),  # hinge2.x
        -(w48 * w88),  # hinge2.y
        -(w51 * w91),  # hinge3.x
        -(w51 * w90),  # hinge3.y
        -(w54 * w93),  # hinge4.x
        -(w54 * w92),  # hinge4.y
        -(w57 * w95),  # hinge5.x
        -(w57 * w94),  # hinge5.y
        -(w60 * w97),  # hinge6.x
        -(w60 * w96),  # hinge6.y
        -(w63 * w99),  # hinge7.x
        -(w63 * w98),  # hinge7.y
        -(w66 * w101),  # hinge8.x
        -(w66 * w100),  # hinge8.y
        -(w69 * w103),  # hinge9.x
        -(w69 * w102),  # hinge9.y
        -(w72 * w105),  # hinge10.x
        -(w72 * w104),  # hinge10.y
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes q_ddot (n = 30) [mixed]: accelerations of all coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 20) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 10) [N, N m]: world force and moment of a joint on its body b, at b
    198 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    q_ddot = ca.SX.sym("q_ddot", 30)
    c = ca.SX.sym("c", 78)
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
    link2_mass = c[1]
    link3_mass = c[2]
    link4_mass = c[3]
    link5_mass = c[4]
    link6_mass = c[5]
    link7_mass = c[6]
    link8_mass = c[7]
    link9_mass = c[8]
    link10_mass = c[9]
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
    link1_mass = c[48]
    c58 = c[58]
    c59 = c[59]
    # intermediate terms (50)
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c58
    w2 = ca.sin(link1_theta) * c58
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
    w30 = w27 * w28 - (link10_x_ddot * link10_mass - w29 * link10_theta_ddot)
    w31 = w24 * w25 - (link9_x_ddot * link9_mass - w26 * link9_theta_ddot) + w30
    w32 = w21 * w22 - (link8_x_ddot * link8_mass - w23 * link8_theta_ddot) + w31
    w33 = w18 * w19 - (link7_x_ddot * link7_mass - w20 * link7_theta_ddot) + w32
    w34 = w15 * w16 - (link6_x_ddot * link6_mass - w17 * link6_theta_ddot) + w33
    w35 = w12 * w13 - (link5_x_ddot * link5_mass - w14 * link5_theta_ddot) + w34
    w36 = w9 * w10 - (link4_x_ddot * link4_mass - w11 * link4_theta_ddot) + w35
    w37 = w6 * w7 - (link3_x_ddot * link3_mass - w8 * link3_theta_ddot) + w36
    w38 = w3 * w4 - (link2_x_ddot * link2_mass - w5 * link2_theta_ddot) + w37
    w39 = w0 * w1 - (link1_x_ddot * link1_mass - w2 * link1_theta_ddot) + w38
    w40 = c46 + w27 * w29 - (link10_y_ddot * link10_mass + w28 * link10_theta_ddot)
    w41 = c45 + w24 * w26 - (link9_y_ddot * link9_mass + w25 * link9_theta_ddot) + w40
    w42 = c44 + w21 * w23 - (link8_y_ddot * link8_mass + w22 * link8_theta_ddot) + w41
    w43 = c43 + w18 * w20 - (link7_y_ddot * link7_mass + w19 * link7_theta_ddot) + w42
    w44 = c42 + w15 * w17 - (link6_y_ddot * link6_mass + w16 * link6_theta_ddot) + w43
    w45 = c41 + w12 * w14 - (link5_y_ddot * link5_mass + w13 * link5_theta_ddot) + w44
    w46 = c40 + w9 * w11 - (link4_y_ddot * link4_mass + w10 * link4_theta_ddot) + w45
    w47 = c39 + w6 * w8 - (link3_y_ddot * link3_mass + w7 * link3_theta_ddot) + w46
    w48 = c38 + w3 * w5 - (link2_y_ddot * link2_mass + w4 * link2_theta_ddot) + w47
    w49 = c59 + w0 * w2 - (link1_y_ddot * link1_mass + w1 * link1_theta_ddot) + w48
    # outputs
    lam = ca.vertcat(
        w39,  # hinge1.x
        w49,  # hinge1.y
        w38,  # hinge2.x
        w48,  # hinge2.y
        w37,  # hinge3.x
        w47,  # hinge3.y
        w36,  # hinge4.x
        w46,  # hinge4.y
        w35,  # hinge5.x
        w45,  # hinge5.y
        w34,  # hinge6.x
        w44,  # hinge6.y
        w33,  # hinge7.x
        w43,  # hinge7.y
        w32,  # hinge8.x
        w42,  # hinge8.y
        w31,  # hinge9.x
        w41,  # hinge9.y
        w30,  # hinge10.x
        w40,  # hinge10.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w39, -w49, 0.0),  # hinge1
        ca.vertcat(-w38, -w48, 0.0),  # hinge2
        ca.vertcat(-w37, -w47, 0.0),  # hinge3
        ca.vertcat(-w36, -w46, 0.0),  # hinge4
        ca.vertcat(-w35, -w45, 0.0),  # hinge5
        ca.vertcat(-w34, -w44, 0.0),  # hinge6
        ca.vertcat(-w33, -w43, 0.0),  # hinge7
        ca.vertcat(-w32, -w42, 0.0),  # hinge8
        ca.vertcat(-w31, -w41, 0.0),  # hinge9
        ca.vertcat(-w30, -w40, 0.0),  # hinge10
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    240 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 78)
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
    link2_mass = c[1]
    link3_mass = c[2]
    link4_mass = c[3]
    link5_mass = c[4]
    link6_mass = c[5]
    link7_mass = c[6]
    link8_mass = c[7]
    link9_mass = c[8]
    link10_mass = c[9]
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
    link1_mass = c[48]
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
    c60 = c[60]
    # intermediate terms (37)
    w0 = ca.sin(link1_theta) * c58
    w1 = ca.cos(link1_theta) * c58
    w2 = link1_x_dot * (link1_x_dot * link1_mass - w0 * link1_theta_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta_dot * w1)
    w3 = ca.sin(link2_theta) * c18
    w4 = w2 + link1_theta_dot * (link1_y_dot * w1 - link1_x_dot * w0 + link1_theta_dot * c49) + link2_x_dot * (link2_x_dot * link2_mass - w3 * link2_theta_dot)
    w5 = ca.cos(link2_theta) * c18
    w6 = w4 + link2_y_dot * (link2_y_dot * link2_mass + link2_theta_dot * w5) + link2_theta_dot * (link2_y_dot * w5 - link2_x_dot * w3 + link2_theta_dot * c50)
    w7 = ca.sin(link3_theta) * c19
    w8 = ca.cos(link3_theta) * c19
    w9 = w6 + link3_x_dot * (link3_x_dot * link3_mass - w7 * link3_theta_dot) + link3_y_dot * (link3_y_dot * link3_mass + link3_theta_dot * w8)
    w10 = ca.sin(link4_theta) * c20
    w11 = w9 + link3_theta_dot * (link3_y_dot * w8 - link3_x_dot * w7 + link3_theta_dot * c51) + link4_x_dot * (link4_x_dot * link4_mass - w10 * link4_theta_dot)
    w12 = ca.cos(link4_theta) * c20
    w13 = w11 + link4_y_dot * (link4_y_dot * link4_mass + link4_theta_dot * w12) + link4_theta_dot * (link4_y_dot * w12 - link4_x_dot * w10 + link4_theta_dot * c52)
    w14 = ca.sin(link5_theta) * c21
    w15 = ca.cos(link5_theta) * c21
    w16 = w13 + link5_x_dot * (link5_x_dot * link5_mass - w14 * link5_theta_dot) + link5_y_dot * (link5_y_dot * link5_mass + link5_theta_dot * w15)
    w17 = ca.sin(link6_theta) * c22
    w18 = w16 + link5_theta_dot * (link5_y_dot * w15 - link5_x_dot * w14 + link5_theta_dot * c53) + link6_x_dot * (link6_x_dot * link6_mass - w17 * link6_theta_dot)
    w19 = ca.cos(link6_theta) * c22
    w20 = w18 + link6_y_dot * (link6_y_dot * link6_mass + link6_theta_dot * w19) + link6_theta_dot * (link6_y_dot * w19 - link6_x_dot * w17 + link6_theta_dot * c54)
    w21 = ca.sin(link7_theta) * c23
    w22 = ca.cos(link7_theta) * c23
    w23 = w20 + link7_x_dot * (link7_x_dot * link7_mass - w21 * link7_theta_dot) + link7_y_dot * (link7_y_dot * link7_mass + link7_theta_dot * w22)
    w24 = ca.sin(link8_theta) * c24
    w25 = w23 + link7_theta_dot * (link7_y_dot * w22 - link7_x_dot * w21 + link7_theta_dot * c55) + link8_x_dot * (link8_x_dot * link8_mass - w24 * link8_theta_dot)
    w26 = ca.cos(link8_theta) * c24
    w27 = w25 + link8_y_dot * (link8_y_dot * link8_mass + link8_theta_dot * w26) + link8_theta_dot * (link8_y_dot * w26 - link8_x_dot * w24 + link8_theta_dot * c56)
    w28 = ca.sin(link9_theta) * c25
    w29 = ca.cos(link9_theta) * c25
    w30 = w27 + link9_x_dot * (link9_x_dot * link9_mass - w28 * link9_theta_dot) + link9_y_dot * (link9_y_dot * link9_mass + link9_theta_dot * w29)
    w31 = ca.sin(link10_theta) * c26
    w32 = w30 + link9_theta_dot * (link9_y_dot * w29 - link9_x_dot * w28 + link9_theta_dot * c57) + link10_x_dot * (link10_x_dot * link10_mass - w31 * link10_theta_dot)
    w33 = ca.cos(link10_theta) * c26
    w34 = w32 + link10_y_dot * (link10_y_dot * link10_mass + link10_theta_dot * w33) + link10_theta_dot * (link10_y_dot * w33 - link10_x_dot * w31 + link10_theta_dot * c35)
    w35 = w0 + link1_y * link1_mass + (w3 + link2_y * link2_mass) + (w7 + link3_y * link3_mass) + (w10 + link4_y * link4_mass)
    w36 = w35 + (w14 + link5_y * link5_mass) + (w17 + link6_y * link6_mass) + (w21 + link7_y * link7_mass) + (w24 + link8_y * link8_mass)
    # outputs
    kinetic = ca.vertcat(w34 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w36 + (w28 + link9_y * link9_mass) + (w31 + link10_y * link10_mass)) * c60)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 10) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    30 operations.
    """
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
    # intermediate terms (20)
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
    # outputs
    poses = ca.SX(12, 10)
    poses[0, 0] = link1_x
    poses[0, 1] = link2_x
    poses[0, 2] = link3_x
    poses[0, 3] = link4_x
    poses[0, 4] = link5_x
    poses[0, 5] = link6_x
    poses[0, 6] = link7_x
    poses[0, 7] = link8_x
    poses[0, 8] = link9_x
    poses[0, 9] = link10_x
    poses[1, 0] = link1_y
    poses[1, 1] = link2_y
    poses[1, 2] = link3_y
    poses[1, 3] = link4_y
    poses[1, 4] = link5_y
    poses[1, 5] = link6_y
    poses[1, 6] = link7_y
    poses[1, 7] = link8_y
    poses[1, 8] = link9_y
    poses[1, 9] = link10_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[3, 2] = w4
    poses[3, 3] = w6
    poses[3, 4] = w8
    poses[3, 5] = w10
    poses[3, 6] = w12
    poses[3, 7] = w14
    poses[3, 8] = w16
    poses[3, 9] = w18
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[4, 2] = w5
    poses[4, 3] = w7
    poses[4, 4] = w9
    poses[4, 5] = w11
    poses[4, 6] = w13
    poses[4, 7] = w15
    poses[4, 8] = w17
    poses[4, 9] = w19
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[6, 2] = -w5
    poses[6, 3] = -w7
    poses[6, 4] = -w9
    poses[6, 5] = -w11
    poses[6, 6] = -w13
    poses[6, 7] = -w15
    poses[6, 8] = -w17
    poses[6, 9] = -w19
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[7, 2] = w4
    poses[7, 3] = w6
    poses[7, 4] = w8
    poses[7, 5] = w10
    poses[7, 6] = w12
    poses[7, 7] = w14
    poses[7, 8] = w16
    poses[7, 9] = w18
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    poses[11, 2] = 1.0
    poses[11, 3] = 1.0
    poses[11, 4] = 1.0
    poses[11, 5] = 1.0
    poses[11, 6] = 1.0
    poses[11, 7] = 1.0
    poses[11, 8] = 1.0
    poses[11, 9] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i, through q_d
    391 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    c26 = c[26]
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
    # intermediate terms (194)
    w0 = ca.sin(link1_theta)
    w1 = w0 * link_length
    w2 = ca.sin(link2_theta)
    w3 = w2 * link_length
    w4 = ca.cos(link2_theta)
    w5 = w4 * link_length
    w6 = ca.cos(link1_theta) * link_length
    w7 = w1 * (w2 * c61) + w4 * c61 * w6
    w8 = link2_theta_dot**2
    w9 = w7 * w8
    w10 = ca.sin(link3_theta)
    w11 = w10 * link_length
    w12 = w10 * c62
    w13 = ca.cos(link3_theta)
    w14 = w13 * link_length
    w15 = w13 * c62
    w16 = w1 * w12 + w6 * w15
    w17 = link3_theta_dot**2
    w18 = w16 * w17
    w19 = ca.sin(link4_theta)
    w20 = w19 * link_length
    w21 = w19 * c63
    w22 = ca.cos(link4_theta)
    w23 = w22 * link_length
    w24 = w22 * c63
    w25 = w1 * w21 + w6 * w24
    w26 = link4_theta_dot**2
    w27 = w25 * w26
    w28 = ca.sin(link5_theta)
    w29 = w28 * link_length
    w30 = w28 * c64
    w31 = ca.cos(link5_theta)
    w32 = w31 * link_length
    w33 = w31 * c64
    w34 = w1 * w30 + w6 * w33
    w35 = link5_theta_dot**2
    w36 = w34 * w35
    w37 = ca.sin(link6_theta)
    w38 = w37 * link_length
    w39 = w37 * c65
    w40 = ca.cos(link6_theta)
    w41 = w40 * link_length
    w42 = w40 * c65
    w43 = w1 * w39 + w6 * w42
    w44 = link6_theta_dot**2
    w45 = w43 * w44
    w46 = ca.sin(link7_theta)
    w47 = w46 * link_length
    w48 = w46 * c66
    w49 = ca.cos(link7_theta)
    w50 = w49 * link_length
    w51 = w49 * c66
    w52 = w1 * w48 + w6 * w51
    w53 = link7_theta_dot**2
    w54 = w52 * w53
    w55 = ca.sin(link8_theta)
    w56 = w55 * link_length
    w57 = w55 * c67
    w58 = ca.cos(link8_theta)
    w59 = w58 * link_length
    w60 = w58 * c67
    w61 = w1 * w57 + w6 * w60
    w62 = link8_theta_dot**2
    w63 = w61 * w62
    w64 = ca.sin(link9_theta)
    w65 = w64 * c68
    w66 = ca.cos(link9_theta)
    w67 = w66 * c68
    w68 = w1 * w65 + w6 * w67
    w69 = link9_theta_dot**2
    w70 = w68 * w69
    w71 = ca.sin(link10_theta) * c26
    w72 = ca.cos(link10_theta) * c26
    w73 = w1 * w71 + w6 * w72
    w74 = link10_theta_dot**2
    w75 = w73 * w74
    w76 = link1_theta_dot**2
    w77 = w7 * w76
    w78 = w16 * w76
    w79 = w25 * w76
    w80 = w34 * w76
    w81 = w43 * w76
    w82 = w52 * w76
    w83 = w61 * w76
    w84 = w68 * w76
    w85 = w73 * w76
    w86 = w3 * w12 + w5 * w15
    w87 = w17 * w86
    w88 = w3 * w21 + w5 * w24
    w89 = w26 * w88
    w90 = w3 * w30 + w5 * w33
    w91 = w35 * w90
    w92 = w3 * w39 + w5 * w42
    w93 = w44 * w92
    w94 = w3 * w48 + w5 * w51
    w95 = w53 * w94
    w96 = w3 * w57 + w5 * w60
    w97 = w62 * w96
    w98 = w3 * w65 + w5 * w67
    w99 = w69 * w98
    w100 = w3 * w71 + w5 * w72
    w101 = w74 * w100
    w102 = w8 * w86
    w103 = w8 * w88
    w104 = w8 * w90
    w105 = w8 * w92
    w106 = w8 * w94
    w107 = w8 * w96
    w108 = w8 * w98
    w109 = w8 * w100
    w110 = w11 * w21 + w14 * w24
    w111 = w26 * w110
    w112 = w11 * w30 + w14 * w33
    w113 = w35 * w112
    w114 = w11 * w39 + w14 * w42
    w115 = w44 * w114
    w116 = w11 * w48 + w14 * w51
    w117 = w53 * w116
    w118 = w11 * w57 + w14 * w60
    w119 = w62 * w118
    w120 = w11 * w65 + w14 * w67
    w121 = w69 * w120
    w122 = w11 * w71 + w14 * w72
    w123 = w74 * w122
    w124 = w17 * w110
    w125 = w17 * w112
    w126 = w17 * w114
    w127 = w17 * w116
    w128 = w17 * w118
    w129 = w17 * w120
    w130 = w17 * w122
    w131 = w20 * w30 + w23 * w33
    w132 = w35 * w131
    w133 = w20 * w39 + w23 * w42
    w134 = w44 * w133
    w135 = w20 * w48 + w23 * w51
    w136 = w53 * w135
    w137 = w20 * w57 + w23 * w60
    w138 = w62 * w137
    w139 = w20 * w65 + w23 * w67
    w140 = w69 * w139
    w141 = w20 * w71 + w23 * w72
    w142 = w74 * w141
    w143 = w26 * w131
    w144 = w26 * w133
    w145 = w26 * w135
    w146 = w26 * w137
    w147 = w26 * w139
    w148 = w26 * w141
    w149 = w29 * w39 + w32 * w42
    w150 = w44 * w149
    w151 = w29 * w48 + w32 * w51
    w152 = w53 * w151
    w153 = w29 * w57 + w32 * w60
    w154 = w62 * w153
    w155 = w29 * w65 + w32 * w67
    w156 = w69 * w155
    w157 = w29 * w71 + w32 * w72
    w158 = w74 * w157
    w159 = w35 * w149
    w160 = w35 * w151
    w161 = w35 * w153
    w162 = w35 * w155
    w163 = w35 * w157
    w164 = w38 * w48 + w41 * w51
    w165 = w53 * w164
    w166 = w38 * w57 + w41 * w60
    w167 = w62 * w166
    w168 = w38 * w65 + w41 * w67
    w169 = w69 * w168
    w170 = w38 * w71 + w41 * w72
    w171 = w74 * w170
    w172 = w44 * w164
    w173 = w44 * w166
    w174 = w44 * w168
    w175 = w44 * w170
    w176 = w47 * w57 + w50 * w60
    w177 = w62 * w176
    w178 = w47 * w65 + w50 * w67
    w179 = w69 * w178
    w180 = w47 * w71 + w50 * w72
    w181 = w74 * w180
    w182 = w53 * w176
    w183 = w53 * w178
    w184 = w53 * w180
    w185 = w56 * w65 + w59 * w67
    w186 = w69 * w185
    w187 = w56 * w71 + w59 * w72
    w188 = w74 * w187
    w189 = w62 * w185
    w190 = w62 * w187
    w191 = w64 * link_length * w71 + w66 * link_length * w72
    w192 = w74 * w191
    w193 = w69 * w191
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * c69 - (w9 + w18 + w27 + w36 + w45 + w54 + w63 + w70 + w75), w9, w18, w27, w36, w45, w54, w63, w70,
            w75,
        ),
        ca.horzcat(  # link2.theta
            w77, w2 * c70 - (w77 + w87 + w89 + w91 + w93 + w95 + w97 + w99 + w101), w87, w89, w91, w93, w95, w97,
            w99, w101,
        ),
        ca.horzcat(  # link3.theta
            w78, w102, w10 * c71 - (w78 + w102 + w111 + w113 + w115 + w117 + w119 + w121 + w123), w111, w113, w115,
            w117, w119, w121, w123,
        ),
        ca.horzcat(  # link4.theta
            w79, w103, w124, w19 * c72 - (w124 + (w79 + w103) + w132 + w134 + w136 + w138 + w140 + w142), w132,
            w134, w136, w138, w140, w142,
        ),
        ca.horzcat(  # link5.theta
            w80, w104, w125, w143, w28 * c73 - (w143 + (w125 + (w80 + w104)) + w150 + w152 + w154 + w156 + w158),
            w150, w152, w154, w156, w158,
        ),
        ca.horzcat(  # link6.theta
            w81, w105, w126, w144, w159,
            w37 * c74 - (w159 + (w144 + (w126 + (w81 + w105))) + w165 + w167 + w169 + w171), w165, w167, w169, w171,
        ),
        ca.horzcat(  # link7.theta
            w82, w106, w127, w145, w160, w172,
            w46 * c75 - (w172 + (w160 + (w145 + (w127 + (w82 + w106)))) + w177 + w179 + w181), w177, w179, w181,
        ),
        ca.horzcat(  # link8.theta
            w83, w107, w128, w146, w161, w173, w182,
            w55 * c76 - (w182 + (w173 + (w161 + (w146 + (w128 + (w83 + w107))))) + w186 + w188), w186, w188,
        ),
        ca.horzcat(  # link9.theta
            w84, w108, w129, w147, w162, w174, w183, w189,
            w64 * c77 - (w189 + (w183 + (w174 + (w162 + (w147 + (w129 + (w84 + w108)))))) + w192), w192,
        ),
        ca.horzcat(  # link10.theta
            w85, w109, w130, w148, w163, w175, w184, w190, w193,
            w71 * c60 - (w193 + (w190 + (w184 + (w175 + (w163 + (w148 + (w130 + (w85 + w109)))))))),
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    299 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    c26 = c[26]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    # intermediate terms (109)
    w0 = ca.sin(link1_theta) * link_length
    w1 = ca.cos(link2_theta)
    w2 = w1 * link_length
    w3 = ca.cos(link1_theta) * link_length
    w4 = ca.sin(link2_theta)
    w5 = w4 * link_length
    w6 = w0 * (w1 * c61) - w3 * (w4 * c61)
    w7 = 2 * link1_theta_dot
    w8 = ca.cos(link3_theta)
    w9 = w8 * link_length
    w10 = w8 * c62
    w11 = ca.sin(link3_theta)
    w12 = w11 * link_length
    w13 = w11 * c62
    w14 = w0 * w10 - w3 * w13
    w15 = ca.cos(link4_theta)
    w16 = w15 * link_length
    w17 = w15 * c63
    w18 = ca.sin(link4_theta)
    w19 = w18 * link_length
    w20 = w18 * c63
    w21 = w0 * w17 - w3 * w20
    w22 = ca.cos(link5_theta)
    w23 = w22 * link_length
    w24 = w22 * c64
    w25 = ca.sin(link5_theta)
    w26 = w25 * link_length
    w27 = w25 * c64
    w28 = w0 * w24 - w3 * w27
    w29 = ca.cos(link6_theta)
    w30 = w29 * link_length
    w31 = w29 * c65
    w32 = ca.sin(link6_theta)
    w33 = w32 * link_length
    w34 = w32 * c65
    w35 = w0 * w31 - w3 * w34
    w36 = ca.cos(link7_theta)
    w37 = w36 * link_length
    w38 = w36 * c66
    w39 = ca.sin(link7_theta)
    w40 = w39 * link_length
    w41 = w39 * c66
    w42 = w0 * w38 - w3 * w41
    w43 = ca.cos(link8_theta)
    w44 = w43 * link_length
    w45 = w43 * c67
    w46 = ca.sin(link8_theta)
    w47 = w46 * link_length
    w48 = w46 * c67
    w49 = w0 * w45 - w3 * w48
    w50 = ca.cos(link9_theta)
    w51 = w50 * c68
    w52 = ca.sin(link9_theta)
    w53 = w52 * c68
    w54 = w0 * w51 - w3 * w53
    w55 = ca.cos(link10_theta) * c26
    w56 = ca.sin(link10_theta) * c26
    w57 = w0 * w55 - w3 * w56
    w58 = w5 * w10 - w2 * w13
    w59 = 2 * link2_theta_dot
    w60 = w5 * w17 - w2 * w20
    w61 = w5 * w24 - w2 * w27
    w62 = w5 * w31 - w2 * w34
    w63 = w5 * w38 - w2 * w41
    w64 = w5 * w45 - w2 * w48
    w65 = w5 * w51 - w2 * w53
    w66 = w5 * w55 - w2 * w56
    w67 = link3_theta_dot * -2.0
    w68 = w12 * w17 - w9 * w20
    w69 = 2 * link3_theta_dot
    w70 = w12 * w24 - w9 * w27
    w71 = w12 * w31 - w9 * w34
    w72 = w12 * w38 - w9 * w41
    w73 = w12 * w45 - w9 * w48
    w74 = w12 * w51 - w9 * w53
    w75 = w12 * w55 - w9 * w56
    w76 = link4_theta_dot * -2.0
    w77 = w19 * w24 - w16 * w27
    w78 = 2 * link4_theta_dot
    w79 = w19 * w31 - w16 * w34
    w80 = w19 * w38 - w16 * w41
    w81 = w19 * w45 - w16 * w48
    w82 = w19 * w51 - w16 * w53
    w83 = w19 * w55 - w16 * w56
    w84 = link5_theta_dot * -2.0
    w85 = w26 * w31 - w23 * w34
    w86 = 2 * link5_theta_dot
    w87 = w26 * w38 - w23 * w41
    w88 = w26 * w45 - w23 * w48
    w89 = w26 * w51 - w23 * w53
    w90 = w26 * w55 - w23 * w56
    w91 = link6_theta_dot * -2.0
    w92 = w33 * w38 - w30 * w41
    w93 = 2 * link6_theta_dot
    w94 = w33 * w45 - w30 * w48
    w95 = w33 * w51 - w30 * w53
    w96 = w33 * w55 - w30 * w56
    w97 = link7_theta_dot * -2.0
    w98 = w40 * w45 - w37 * w48
    w99 = 2 * link7_theta_dot
    w100 = w40 * w51 - w37 * w53
    w101 = w40 * w55 - w37 * w56
    w102 = link8_theta_dot * -2.0
    w103 = w47 * w51 - w44 * w53
    w104 = 2 * link8_theta_dot
    w105 = w47 * w55 - w44 * w56
    w106 = link9_theta_dot * -2.0
    w107 = w52 * link_length * w55 - w50 * link_length * w56
    w108 = link10_theta_dot * -2.0
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.theta
            0.0, w6 * (link2_theta_dot * -2.0), w14 * w67, w21 * w76, w28 * w84, w35 * w91, w42 * w97, w49 * w102,
            w54 * w106, w57 * w108,
        ),
        ca.horzcat(  # link2.theta
            w6 * w7, 0.0, w58 * w67, w60 * w76, w61 * w84, w62 * w91, w63 * w97, w64 * w102, w65 * w106, w66 * w108,
        ),
        ca.horzcat(  # link3.theta
            w7 * w14, w58 * w59, 0.0, w68 * w76, w70 * w84, w71 * w91, w72 * w97, w73 * w102, w74 * w106,
            w75 * w108,
        ),
        ca.horzcat(  # link4.theta
            w7 * w21, w59 * w60, w68 * w69, 0.0, w77 * w84, w79 * w91, w80 * w97, w81 * w102, w82 * w106,
            w83 * w108,
        ),
        ca.horzcat(  # link5.theta
            w7 * w28, w59 * w61, w69 * w70, w77 * w78, 0.0, w85 * w91, w87 * w97, w88 * w102, w89 * w106,
            w90 * w108,
        ),
        ca.horzcat(  # link6.theta
            w7 * w35, w59 * w62, w69 * w71, w78 * w79, w85 * w86, 0.0, w92 * w97, w94 * w102, w95 * w106,
            w96 * w108,
        ),
        ca.horzcat(  # link7.theta
            w7 * w42, w59 * w63, w69 * w72, w78 * w80, w86 * w87, w92 * w93, 0.0, w98 * w102, w100 * w106,
            w101 * w108,
        ),
        ca.horzcat(  # link8.theta
            w7 * w49, w59 * w64, w69 * w73, w78 * w81, w86 * w88, w93 * w94, w98 * w99, 0.0, w103 * w106,
            w105 * w108,
        ),
        ca.horzcat(  # link9.theta
            w7 * w54, w59 * w65, w69 * w74, w78 * w82, w86 * w89, w93 * w95, w99 * w100, w103 * w104, 0.0,
            w107 * w108,
        ),
        ca.horzcat(  # link10.theta
            w7 * w57, w59 * w66, w69 * w75, w78 * w83, w86 * w90, w93 * w96, w99 * w101, w104 * w105,
            w107 * (2 * link9_theta_dot), 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 10 x 10) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    799 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    link10_mass = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
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
    # intermediate terms (271)
    w0 = ca.sin(link1_theta)
    w1 = w0 * link_length
    w2 = ca.sin(link2_theta)
    w3 = link2_theta_dot**2
    w4 = ca.cos(link2_theta)
    w5 = w2 * w3 - w4 * link2_theta_ddot
    w6 = w5 * link_length
    w7 = ca.cos(link1_theta)
    w8 = w7 * link_length
    w9 = w3 * w4 + w2 * link2_theta_ddot
    w10 = w9 * link_length
    w11 = w1 * (w5 * c61) + w8 * (w9 * c61)
    w12 = ca.sin(link3_theta)
    w13 = link3_theta_dot**2
    w14 = ca.cos(link3_theta)
    w15 = w12 * w13 - w14 * link3_theta_ddot
    w16 = w15 * link_length
    w17 = w15 * c62
    w18 = w13 * w14 + w12 * link3_theta_ddot
    w19 = w18 * link_length
    w20 = w18 * c62
    w21 = w1 * w17 + w8 * w20
    w22 = ca.sin(link4_theta)
    w23 = link4_theta_dot**2
    w24 = ca.cos(link4_theta)
    w25 = w22 * w23 - w24 * link4_theta_ddot
    w26 = w25 * link_length
    w27 = w25 * c63
    w28 = w23 * w24 + w22 * link4_theta_ddot
    w29 = w28 * link_length
    w30 = w28 * c63
    w31 = w1 * w27 + w8 * w30
    w32 = ca.sin(link5_theta)
    w33 = link5_theta_dot**2
    w34 = ca.cos(link5_theta)
    w35 = w32 * w33 - w34 * link5_theta_ddot
    w36 = w35 * link_length
    w37 = w35 * c64
    w38 = w33 * w34 + w32 * link5_theta_ddot
    w39 = w38 * link_length
    w40 = w38 * c64
    w41 = w1 * w37 + w8 * w40
    w42 = ca.sin(link6_theta)
    w43 = link6_theta_dot**2
    w44 = ca.cos(link6_theta)
    w45 = w42 * w43 - w44 * link6_theta_ddot
    w46 = w45 * link_length
    w47 = w45 * c65
    w48 = w43 * w44 + w42 * link6_theta_ddot
    w49 = w48 * link_length
    w50 = w48 * c65
    w51 = w1 * w47 + w8 * w50
    w52 = ca.sin(link7_theta)
    w53 = link7_theta_dot**2
    w54 = ca.cos(link7_theta)
    w55 = w52 * w53 - w54 * link7_theta_ddot
    w56 = w55 * link_length
    w57 = w55 * c66
    w58 = w53 * w54 + w52 * link7_theta_ddot
    w59 = w58 * link_length
    w60 = w58 * c66
    w61 = w1 * w57 + w8 * w60
    w62 = ca.sin(link8_theta)
    w63 = link8_theta_dot**2
    w64 = ca.cos(link8_theta)
    w65 = w62 * w63 - w64 * link8_theta_ddot
    w66 = w65 * link_length
    w67 = w65 * c67
    w68 = w63 * w64 + w62 * link8_theta_ddot
    w69 = w68 * link_length
    w70 = w68 * c67
    w71 = w1 * w67 + w8 * w70
    w72 = ca.sin(link9_theta)
    w73 = link9_theta_dot**2
    w74 = ca.cos(link9_theta)
    w75 = w72 * w73 - w74 * link9_theta_ddot
    w76 = w75 * c68
    w77 = w73 * w74 + w72 * link9_theta_ddot
    w78 = w77 * c68
    w79 = w1 * w76 + w8 * w78
    w80 = ca.sin(link10_theta)
    w81 = link10_theta_dot**2
    w82 = ca.cos(link10_theta)
    w83 = (w80 * w81 - w82 * link10_theta_ddot) * c26
    w84 = (w81 * w82 + w80 * link10_theta_ddot) * c26
    w85 = w1 * w83 + w8 * w84
    w86 = w2 * link_length
    w87 = link1_theta_dot**2
    w88 = (w0 * w87 - w7 * link1_theta_ddot) * link_length
    w89 = w4 * link_length
    w90 = w4 * c61
    w91 = (w7 * w87 + w0 * link1_theta_ddot) * link_length
    w92 = w2 * c61 * w88 + w90 * w91
    w93 = w12 * link_length
    w94 = w12 * c62
    w95 = w14 * link_length
    w96 = w14 * c62
    w97 = w88 * w94 + w91 * w96
    w98 = w22 * link_length
    w99 = w22 * c63
    w100 = w24 * link_length
    w101 = w24 * c63
    w102 = w88 * w99 + w91 * w101
    w103 = w32 * link_length
    w104 = w32 * c64
    w105 = w34 * link_length
    w106 = w34 * c64
    w107 = w88 * w104 + w91 * w106
    w108 = w42 * link_length
    w109 = w42 * c65
    w110 = w44 * link_length
    w111 = w44 * c65
    w112 = w88 * w109 + w91 * w111
    w113 = w52 * link_length
    w114 = w52 * c66
    w115 = w54 * link_length
    w116 = w54 * c66
    w117 = w88 * w114 + w91 * w116
    w118 = w62 * link_length
    w119 = w62 * c67
    w120 = w64 * link_length
    w121 = w64 * c67
    w122 = w88 * w119 + w91 * w121
    w123 = w72 * link_length
    w124 = w72 * c68
    w125 = w74 * link_length
    w126 = w74 * c68
    w127 = w88 * w124 + w91 * w126
    w128 = w80 * c26
    w129 = w82 * c26
    w130 = w88 * w128 + w91 * w129
    w131 = w17 * w86 + w20 * w89
    w132 = w27 * w86 + w30 * w89
    w133 = w37 * w86 + w40 * w89
    w134 = w47 * w86 + w50 * w89
    w135 = w57 * w86 + w60 * w89
    w136 = w67 * w86 + w70 * w89
    w137 = w76 * w86 + w78 * w89
    w138 = w83 * w86 + w84 * w89
    w139 = w6 * w94 + w10 * w96
    w140 = w6 * w99 + w10 * w101
    w141 = w6 * w104 + w10 * w106
    w142 = w6 * w109 + w10 * w111
    w143 = w6 * w114 + w10 * w116
    w144 = w6 * w119 + w10 * w121
    w145 = w6 * w124 + w10 * w126
    w146 = w6 * w128 + w10 * w129
    w147 = w27 * w93 + w30 * w95
    w148 = w37 * w93 + w40 * w95
    w149 = w47 * w93 + w50 * w95
    w150 = w57 * w93 + w60 * w95
    w151 = w67 * w93 + w70 * w95
    w152 = w76 * w93 + w78 * w95
    w153 = w83 * w93 + w84 * w95
    w154 = w16 * w99 + w19 * w101
    w155 = w16 * w104 + w19 * w106
    w156 = w16 * w109 + w19 * w111
    w157 = w16 * w114 + w19 * w116
    w158 = w16 * w119 + w19 * w121
    w159 = w16 * w124 + w19 * w126
    w160 = w16 * w128 + w19 * w129
    w161 = w37 * w98 + w40 * w100
    w162 = w47 * w98 + w50 * w100
    w163 = w57 * w98 + w60 * w100
    w164 = w67 * w98 + w70 * w100
    w165 = w76 * w98 + w78 * w100
    w166 = w83 * w98 + w84 * w100
    w167 = w26 * w104 + w29 * w106
    w168 = w26 * w109 + w29 * w111
    w169 = w26 * w114 + w29 * w116
    w170 = w26 * w119 + w29 * w121
    w171 = w26 * w124 + w29 * w126
    w172 = w26 * w128 + w29 * w129
    w173 = w47 * w103 + w50 * w105
    w174 = w57 * w103 + w60 * w105
    w175 = w67 * w103 + w70 * w105
    w176 = w76 * w103 + w78 * w105
    w177 = w83 * w103 + w84 * w105
    w178 = w36 * w109 + w39 * w111
    w179 = w36 * w114 + w39 * w116
    w180 = w36 * w119 + w39 * w121
    w181 = w36 * w124 + w39 * w126
    w182 = w36 * w128 + w39 * w129
    w183 = w57 * w108 + w60 * w110
    w184 = w67 * w108 + w70 * w110
    w185 = w76 * w108 + w78 * w110
    w186 = w83 * w108 + w84 * w110
    w187 = w46 * w114 + w49 * w116
    w188 = w46 * w119 + w49 * w121
    w189 = w46 * w124 + w49 * w126
    w190 = w46 * w128 + w49 * w129
    w191 = w67 * w113 + w70 * w115
    w192 = w76 * w113 + w78 * w115
    w193 = w83 * w113 + w84 * w115
    w194 = w56 * w119 + w59 * w121
    w195 = w56 * w124 + w59 * w126
    w196 = w56 * w128 + w59 * w129
    w197 = w76 * w118 + w78 * w120
    w198 = w83 * w118 + w84 * w120
    w199 = w66 * w124 + w69 * w126
    w200 = w66 * w128 + w69 * w129
    w201 = w83 * w123 + w84 * w125
    w202 = w75 * link_length * w128 + w77 * link_length * w129
    w203 = w1 * w90 - w8 * (w2 * c18 + w86 * c16)
    w204 = 2 * link1_theta_dot
    w205 = w12 * c19 + w93 * c15
    w206 = w1 * w96 - w8 * w205
    w207 = w22 * c20 + w98 * c14
    w208 = w1 * w101 - w8 * w207
    w209 = w32 * c21 + w103 * c13
    w210 = w1 * w106 - w8 * w209
    w211 = w42 * c22 + w108 * c12
    w212 = w1 * w111 - w8 * w211
    w213 = w52 * c23 + w113 * c11
    w214 = w1 * w116 - w8 * w213
    w215 = w62 * c24 + w118 * c10
    w216 = w1 * w121 - w8 * w215
    w217 = w72 * c25 + w123 * link10_mass
    w218 = w1 * w126 - w8 * w217
    w219 = w1 * w129 - w8 * w128
    w220 = w86 * w96 - w89 * w205
    w221 = 2 * link2_theta_dot
    w222 = w86 * w101 - w89 * w207
    w223 = w86 * w106 - w89 * w209
    w224 = w86 * w111 - w89 * w211
    w225 = w86 * w116 - w89 * w213
    w226 = w86 * w121 - w89 * w215
    w227 = w86 * w126 - w89 * w217
    w228 = w86 * w129 - w89 * w128
    w229 = link3_theta_dot * -2.0
    w230 = w93 * w101 - w95 * w207
    w231 = 2 * link3_theta_dot
    w232 = w93 * w106 - w95 * w209
    w233 = w93 * w111 - w95 * w211
    w234 = w93 * w116 - w95 * w213
    w235 = w93 * w121 - w95 * w215
    w236 = w93 * w126 - w95 * w217
    w237 = w93 * w129 - w95 * w128
    w238 = link4_theta_dot * -2.0
    w239 = w98 * w106 - w100 * w209
    w240 = 2 * link4_theta_dot
    w241 = w98 * w111 - w100 * w211
    w242 = w98 * w116 - w100 * w213
    w243 = w98 * w121 - w100 * w215
    w244 = w98 * w126 - w100 * w217
    w245 = w98 * w129 - w100 * w128
    w246 = link5_theta_dot * -2.0
    w247 = w103 * w111 - w105 * w211
    w248 = 2 * link5_theta_dot
    w249 = w103 * w116 - w105 * w213
    w250 = w103 * w121 - w105 * w215
    w251 = w103 * w126 - w105 * w217
    w252 = w103 * w129 - w105 * w128
    w253 = link6_theta_dot * -2.0
    w254 = w108 * w116 - w110 * w213
    w255 = 2 * link6_theta_dot
    w256 = w108 * w121 - w110 * w215
    w257 = w108 * w126 - w110 * w217
    w258 = w108 * w129 - w110 * w128
    w259 = link7_theta_dot * -2.0
    w260 = w113 * w121 - w115 * w215
    w261 = 2 * link7_theta_dot
    w262 = w113 * w126 - w115 * w217
    w263 = w113 * w129 - w115 * w128
    w264 = link8_theta_dot * -2.0
    w265 = w118 * w126 - w120 * w217
    w266 = 2 * link8_theta_dot
    w267 = w118 * w129 - w120 * w128
    w268 = link9_theta_dot * -2.0
    w269 = w123 * w129 - w125 * w128
    w270 = link10_theta_dot * -2.0
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * c69 - (w11 + w21 + w31 + w41 + w51 + w61 + w71 + w79 + w85), w11, w21, w31, w41, w51, w61, w71,
            w79, w85,
        ),
        ca.horzcat(  # link2.theta
            w92, w2 * c70 - (w92 + w131 + w132 + w133 + w134 + w135 + w136 + w137 + w138), w131, w132, w133, w134,
            w135, w136, w137, w138,
        ),
        ca.horzcat(  # link3.theta
            w97, w139, w12 * c71 - (w97 + w139 + w147 + w148 + w149 + w150 + w151 + w152 + w153), w147, w148, w149,
            w150, w151, w152, w153,
        ),
        ca.horzcat(  # link4.theta
            w102, w140, w154, w22 * c72 - (w154 + (w102 + w140) + w161 + w162 + w163 + w164 + w165 + w166), w161,
            w162, w163, w164, w165, w166,
        ),
        ca.horzcat(  # link5.theta
            w107, w141, w155, w167, w32 * c73 - (w167 + (w155 + (w107 + w141)) + w173 + w174 + w175 + w176 + w177),
            w173, w174, w175, w176, w177,
        ),
        ca.horzcat(  # link6.theta
            w112, w142, w156, w168, w178,
            w42 * c74 - (w178 + (w168 + (w156 + (w112 + w142))) + w183 + w184 + w185 + w186), w183, w184, w185,
            w186,
        ),
        ca.horzcat(  # link7.theta
            w117, w143, w157, w169, w179, w187,
            w52 * c75 - (w187 + (w179 + (w169 + (w157 + (w117 + w143)))) + w191 + w192 + w193), w191, w192, w193,
        ),
        ca.horzcat(  # link8.theta
            w122, w144, w158, w170, w180, w188, w194,
            w62 * c76 - (w194 + (w188 + (w180 + (w170 + (w158 + (w122 + w144))))) + w197 + w198), w197, w198,
        ),
        ca.horzcat(  # link9.theta
            w127, w145, w159, w171, w181, w189, w195, w199,
            w72 * c77 - (w199 + (w195 + (w189 + (w181 + (w171 + (w159 + (w127 + w145)))))) + w201), w201,
        ),
        ca.horzcat(  # link10.theta
            w130, w146, w160, w172, w182, w190, w196, w200, w202,
            w128 * c60 - (w202 + (w200 + (w196 + (w190 + (w182 + (w172 + (w160 + (w130 + w146)))))))),
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # link1.theta
            0.0, w203 * (link2_theta_dot * -2.0), w206 * w229, w208 * w238, w210 * w246, w212 * w253, w214 * w259,
            w216 * w264, w218 * w268, w219 * w270,
        ),
        ca.horzcat(  # link2.theta
            w203 * w204, 0.0, w220 * w229, w222 * w238, w223 * w246, w224 * w253, w225 * w259, w226 * w264,
            w227 * w268, w228 * w270,
        ),
        ca.horzcat(  # link3.theta
            w204 * w206, w220 * w221, 0.0, w230 * w238, w232 * w246, w233 * w253, w234 * w259, w235 * w264,
            w236 * w268, w237 * w270,
        ),
        ca.horzcat(  # link4.theta
            w204 * w208, w221 * w222, w230 * w231, 0.0, w239 * w246, w241 * w253, w242 * w259, w243 * w264,
            w244 * w268, w245 * w270,
        ),
        ca.horzcat(  # link5.theta
            w204 * w210, w221 * w223, w231 * w232, w239 * w240, 0.0, w247 * w253, w249 * w259, w250 * w264,
            w251 * w268, w252 * w270,
        ),
        ca.horzcat(  # link6.theta
            w204 * w212, w221 * w224, w231 * w233, w240 * w241, w247 * w248, 0.0, w254 * w259, w256 * w264,
            w257 * w268, w258 * w270,
        ),
        ca.horzcat(  # link7.theta
            w204 * w214, w221 * w225, w231 * w234, w240 * w242, w248 * w249, w254 * w255, 0.0, w260 * w264,
            w262 * w268, w263 * w270,
        ),
        ca.horzcat(  # link8.theta
            w204 * w216, w221 * w226, w231 * w235, w240 * w243, w248 * w250, w255 * w256, w260 * w261, 0.0,
            w265 * w268, w267 * w270,
        ),
        ca.horzcat(  # link9.theta
            w204 * w218, w221 * w227, w231 * w236, w240 * w244, w248 * w251, w255 * w257, w261 * w262, w265 * w266,
            0.0, w269 * w270,
        ),
        ca.horzcat(  # link10.theta
            w204 * w219, w221 * w228, w231 * w237, w240 * w245, w248 * w252, w255 * w258, w261 * w263, w266 * w267,
            w269 * (2 * link9_theta_dot), 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 78) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    604 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 78)
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
    link_length = c[0]
    link2_mass = c[1]
    link3_mass = c[2]
    link4_mass = c[3]
    link5_mass = c[4]
    link6_mass = c[5]
    link7_mass = c[6]
    link8_mass = c[7]
    link9_mass = c[8]
    link10_mass = c[9]
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
    gravity_y = c[36]
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
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    # intermediate terms (226)
    w0 = ca.cos(link1_theta)
    w1 = w0 * link_length
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
    w30 = w28 * gravity_y
    w31 = link10_mass - w28 * w29
    w32 = w24 * link_length
    w33 = w23 * w32
    w34 = c46 + w26 * w27 - w29 * w30 + w31 * w33
    w35 = w27 / c35
    w36 = w28 * w35
    w37 = ca.cos(link9_theta)
    w38 = w37 * link_length
    w39 = w23 * w38
    w40 = w37 * c25
    w41 = w31 * w38
    w42 = w40 + w41 - w32 * w36
    w43 = w36 * w38
    w44 = link10_mass - w27 * w35
    w45 = w43 - w32 * w44
    w46 = c57 + w38 * w41 - (w32 * w45 + w32 * w43)
    w47 = w42 / w46
    w48 = w26 * w28 + w30 * w35 + w33 * w36 + w39 * w44
    w49 = w40 * gravity_y + w34 * w38 + w39 * w43 - w32 * w48
    w50 = link9_mass + w31 - w42 * w47
    w51 = w21 * link_length
    w52 = w20 * w51
    w53 = c45 + w23 * w25 + w34 + w36 * w39 - w47 * w49 + w50 * w52
    w54 = w45 - w25
    w55 = w54 / w46
    w56 = w36 - w42 * w55
    w57 = ca.cos(link8_theta)
    w58 = w57 * link_length
    w59 = w20 * w58
    w60 = w57 * c24
    w61 = w50 * w58
    w62 = w60 + w61 - w51 * w56
    w63 = w56 * w58
    w64 = link9_mass + w44 - w54 * w55
    w65 = w63 - w51 * w64
    w66 = c56 + w58 * w61 - (w51 * w65 + w51 * w63)
    w67 = w62 / w66
    w68 = w48 + w23 * w40 - w49 * w55 + w52 * w56 + w59 * w64
    w69 = w60 * gravity_y + w53 * w58 + w59 * w63 - w51 * w68
    w70 = link8_mass + w50 - w62 * w67
    w71 = w18 * link_length
    w72 = w17 * w71
    w73 = c44 + w20 * w22 + w53 + w56 * w59 - w67 * w69 + w70 * w72
    w74 = w65 - w22
    w75 = w74 / w66
    w76 = w56 - w62 * w75
    w77 = ca.cos(link7_theta)
    w78 = w77 * link_length
    w79 = w17 * w78
    w80 = w77 * c23
    w81 = w70 * w78
    w82 = w80 + w81 - w71 * w76
    w83 = w76 * w78
    w84 = link8_mass + w64 - w74 * w75
    w85 = w83 - w71 * w84
    w86 = c55 + w78 * w81 - (w71 * w85 + w71 * w83)
    w87 = w82 / w86
    w88 = w68 + w20 * w60 - w69 * w75 + w72 * w76 + w79 * w84
    w89 = w80 * gravity_y + w73 * w78 + w79 * w83 - w71 * w88
    w90 = link7_mass + w70 - w82 * w87
    w91 = w15 * link_length
    w92 = w14 * w91
    w93 = c43 + w17 * w19 + w73 + w76 * w79 - w87 * w89 + w90 * w92
    w94 = w85 - w19
    w95 = w94 / w86
    w96 = w76 - w82 * w95
    w97 = ca.cos(link6_theta)
    w98 = w97 * link_length
    w99 = w14 * w98
    w100 = w97 * c22
    w101 = w90 * w98
    w102 = w100 + w101 - w91 * w96
    w103 = w96 * w98
    w104 = link7_mass + w84 - w94 * w95
    w105 = w103 - w91 * w104
    w106 = c54 + w98 * w101 - (w91 * w105 + w91 * w103)
    w107 = w102 / w106
    w108 = w88 + w17 * w80 - w89 * w95 + w92 * w96 + w99 * w104
    w109 = w100 * gravity_y + w93 * w98 + w99 * w103 - w91 * w108
    w110 = link6_mass + w90 - w102 * w107
    w111 = w12 * link_length
    w112 = w11 * w111
    w113 = c42 + w14 * w16 + w93 + w96 * w99 - w107 * w109 + w110 * w112
    w114 = w105 - w16
    w115 = w114 / w106
    w116 = w96 - w102 * w115
    w117 = ca.cos(link5_theta)
    w118 = w117 * link_length
    w119 = w11 * w118
    w120 = w117 * c21
    w121 = w110 * w118
    w122 = w120 + w121 - w111 * w116
    w123 = w116 * w118
    w124 = link6_mass + w104 - w114 * w115
    w125 = w123 - w111 * w124
    w126 = c53 + w118 * w121 - (w111 * w125 + w111 * w123)
    w127 = w122 / w126
    w128 = w108 + w14 * w100 - w109 * w115 + w112 * w116 + w119 * w124
    w129 = w120 * gravity_y + w113 * w118 + w119 * w123 - w111 * w128
    w130 = link5_mass + w110 - w122 * w127
    w131 = w9 * link_length
    w132 = w8 * w131
    w133 = c41 + w11 * w13 + w113 + w116 * w119 - w127 * w129 + w130 * w132
    w134 = w125 - w13
    w135 = w134 / w126
    w136 = w116 - w122 * w135
    w137 = ca.cos(link4_theta)
    w138 = w137 * link_length
    w139 = w8 * w138
    w140 = w137 * c20
    w141 = w130 * w138
    w142 = w140 + w141 - w131 * w136
    w143 = w136 * w138
    w144 = link5_mass + w124 - w134 * w135
    w145 = w143 - w131 * w144
    w146 = c52 + w138 * w141 - (w131 * w145 + w131 * w143)
    w147 = w142 / w146
    w148 = w128 + w11 * w120 - w129 * w135 + w132 * w136 + w139 * w144
    w149 = w140 * gravity_y + w133 * w138 + w139 * w143 - w131 * w148
    w150 = link4_mass + w130 - w142 * w147
    w151 = w6 * link_length
    w152 = w5 * w151
    w153 = c40 + w8 * w10 + w133 + w136 * w139 - w147 * w149 + w150 * w152
    w154 = w145 - w10
    w155 = w154 / w146
    w156 = w136 - w142 * w155
    w157 = ca.cos(link3_theta)
    w158 = w157 * link_length
    w159 = w5 * w158
    w160 = w157 * c19
    w161 = w150 * w158
    w162 = w160 + w161 - w151 * w156
    w163 = w156 * w158
    w164 = link4_mass + w144 - w154 * w155
    w165 = w163 - w151 * w164
    w166 = c51 + w158 * w161 - (w151 * w165 + w151 * w163)
    w167 = w162 / w166
    w168 = w148 + w8 * w140 - w149 * w155 + w152 * w156 + w159 * w164
    w169 = w160 * gravity_y + w153 * w158 + w159 * w163 - w151 * w168
    w170 = link3_mass + w150 - w162 * w167
    w171 = w3 * link_length
    w172 = w2 * w171
    w173 = c39 + w5 * w7 + w153 + w156 * w159 - w167 * w169 + w170 * w172
    w174 = w165 - w7
    w175 = w174 / w166
    w176 = w156 - w162 * w175
    w177 = ca.cos(link2_theta)
    w178 = w177 * link_length
    w179 = w2 * w178
    w180 = w177 * c18
    w181 = w170 * w178
    w182 = w180 + w181 - w171 * w176
    w183 = w176 * w178
    w184 = link3_mass + w164 - w174 * w175
    w185 = w183 - w171 * w184
    w186 = c50 + w178 * w181 - (w171 * w185 + w171 * w183)
    w187 = w182 / w186
    w188 = w168 + w5 * w160 - w169 * w175 + w172 * w176 + w179 * w184
    w189 = w180 * gravity_y + w173 * w178 + w179 * w183 - w171 * w188
    w190 = link2_mass + w170 - w182 * w187
    w191 = link1_theta_dot**2
    w192 = ca.sin(link1_theta) * link_length
    w193 = w191 * w192
    w194 = w185 - w4
    w195 = w194 / w186
    w196 = w176 - w182 * w195
    w197 = w1 * w196
    w198 = w1 * w191
    w199 = link2_mass + w184 - w194 * w195
    w200 = w0 * c37 + w1 * (c38 + w2 * w4 + w173 + w176 * w179 - w187 * w189 + w190 * w193) + w197 * w198 - w192 * (w188 + w2 * w180 - w189 * w195 + w193 * w196 + w198 * w199)
    w201 = w200 / (c49 + w1 * (w1 * w190) - (w192 * (w197 - w192 * w199) + w192 * w197))
    w202 = w198 + w192 * w201
    w203 = w1 * w201 - w193
    w204 = w189 / w186 + w195 * w202 - w187 * w203
    w205 = w179 + w202 + w171 * w204
    w206 = w203 - w172 + w178 * w204
    w207 = w169 / w166 + w175 * w205 - w167 * w206
    w208 = w159 + w205 + w151 * w207
    w209 = w206 - w152 + w158 * w207
    w210 = w149 / w146 + w155 * w208 - w147 * w209
    w211 = w139 + w208 + w131 * w210
    w212 = w209 - w132 + w138 * w210
    w213 = w129 / w126 + w135 * w211 - w127 * w212
    w214 = w119 + w211 + w111 * w213
    w215 = w212 - w112 + w118 * w213
    w216 = w109 / w106 + w115 * w214 - w107 * w215
    w217 = w99 + w214 + w91 * w216
    w218 = w215 - w92 + w98 * w216
    w219 = w89 / w86 + w95 * w217 - w87 * w218
    w220 = w79 + w217 + w71 * w219
    w221 = w218 - w72 + w78 * w219
    w222 = w69 / w66 + w75 * w220 - w67 * w221
    w223 = w59 + w220 + w51 * w222
    w224 = w221 - w52 + w58 * w222
    w225 = w49 / w46 + w55 * w223 - w47 * w224
    # outputs
    q_i_ddot = ca.vertcat(
        w201,  # link1.theta
        w204,  # link2.theta
        w207,  # link3.theta
        w210,  # link4.theta
        w213,  # link5.theta
        w216,  # link6.theta
        w219,  # link7.theta
        w222,  # link8.theta
        w225,  # link9.theta
        w30 / c35 - w35 * (w39 + w223 + w32 * w225) - w29 * (w224 - w33 + w38 * w225),  # link10.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 12) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 21) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 21) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 12)
    link_length = p[0]
    # outputs
    positions = ca.SX(3, 21)
    positions[0, 2] = link_length
    positions[0, 4] = link_length
    positions[0, 6] = link_length
    positions[0, 8] = link_length
    positions[0, 10] = link_length
    positions[0, 12] = link_length
    positions[0, 14] = link_length
    positions[0, 16] = link_length
    positions[0, 18] = link_length
    positions[0, 20] = link_length
    axes = ca.SX(9, 21)
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
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes"])


def bounded() -> ca.Function:
    """Expressions whose sign must not change with the parameters.

    takes p (n_p = 12) [SI]: parameters: every physical number of a scene that is not zero
    gives bounded (expressions = 10) [SI]: expressions of the scene that must keep their sign
    3 operations.
    """
    p = ca.SX.sym("p", 12)
    link_length = p[0]
    # intermediate terms (1)
    w0 = 0.078 * link_length**2 / 12.0
    # outputs
    bounded = ca.vertcat(
        w0, w0, w0, w0, w0, w0, w0, w0, w0, w0,
    )
    inputs, outputs = [p], [ca.densify(bounded)]
    return ca.Function("bounded", inputs, outputs, ["p"], ["bounded"])


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
    "bounded": bounded,
}
