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
    gives c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    160 operations.
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
    # intermediate terms (21)
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
    w11 = link2_mass + w10
    w12 = w0 + w2 * link2_mass
    w13 = w0 + w2 * link3_mass
    w14 = w0 + w2 * link4_mass
    w15 = w0 + w2 * link5_mass
    w16 = w0 + w2 * link6_mass
    w17 = w0 + w2 * link7_mass
    w18 = w0 + w2 * link8_mass
    w19 = w0 + w2 * link9_mass
    w20 = link1_mass * w1
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
        w3 + link_length * (link_length * w11),  # c17
        w1 * link2_mass,  # c18
        w1 * link3_mass,  # c19
        w1 * link4_mass,  # c20
        w1 * link5_mass,  # c21
        w1 * link6_mass,  # c22
        w1 * link7_mass,  # c23
        w1 * link8_mass,  # c24
        w1 * link9_mass,  # c25
        w1 * link10_mass,  # c26
        w12 + link_length * (link_length * w10),  # c27
        w13 + link_length * (link_length * w9),  # c28
        w14 + link_length * (link_length * w8),  # c29
        w15 + link_length * (link_length * w7),  # c30
        w16 + link_length * (link_length * w6),  # c31
        w17 + link_length * (link_length * w5),  # c32
        w18 + link_length * (link_length * w4),  # c33
        w19 + link_length * (link_length * link10_mass),  # c34
        w0 + w2 * link10_mass,  # c35
        gravity_y,  # gravity_y
        w20 * gravity_y,  # c37
        link2_mass * gravity_y,  # c38
        link3_mass * gravity_y,  # c39
        link4_mass * gravity_y,  # c40
        link5_mass * gravity_y,  # c41
        link6_mass * gravity_y,  # c42
        link7_mass * gravity_y,  # c43
        link8_mass * gravity_y,  # c44
        link9_mass * gravity_y,  # c45
        link10_mass * gravity_y,  # c46
        -link_length,  # c47
        link1_mass,  # link1_mass
        w3,  # c49
        w12,  # c50
        w13,  # c51
        w14,  # c52
        w15,  # c53
        w16,  # c54
        w17,  # c55
        w18,  # c56
        w19,  # c57
        w20,  # c58
        link1_mass * gravity_y,  # c59
        -gravity_y,  # c60
        w11,  # c61
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 10 x 10) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 10) [N, N m]: condensed force S^T (Q* - M s)
    605 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 62)
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 20) [mixed]: dependent coordinates after one Newton step
    83 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    c = ca.SX.sym("c", 62)
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 20) [mixed]: rates of the dependent coordinates
    119 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 62)
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 20) [mixed]: accelerations of the dependent coordinates
    173 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 62)
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 20) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 20 x 30) [SI]: constraint Jacobian
    gives C_t (n_c = 20) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 20) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 20) [m/s^2, rad/s^2]: right-hand side at acceleration level
    848 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 62)
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
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 30 x 30) [SI]: mass matrix in all coordinates
    gives K (n x n = 30 x 30) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 30) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 30) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 30) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 20 x 30) [SI]: constraint Jacobian
    gives gamma_b (n_c = 20) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    2738 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 62)
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
    gamma_b = ca.vertcat(
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
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 30) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 30) [mixed]: rates of all coordinates
    takes q_ddot (n = 30) [mixed]: accelerations of all coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 20) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 10) [N, N m]: world force and moment of a joint on its body b, at b
    329 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    q_ddot = ca.SX.sym("q_ddot", 30)
    c = ca.SX.sym("c", 62)
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    328 operations.
    """
    q = ca.SX.sym("q", 30)
    q_dot = ca.SX.sym("q_dot", 30)
    c = ca.SX.sym("c", 62)
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
    182 operations.
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
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i, through q_d
    792 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 62)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
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
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (179)
    w0 = ca.cos(link1_theta) * link_length
    w1 = link1_theta_dot**2
    w2 = w0 * w1
    w3 = ca.sin(link1_theta)
    w4 = link2_theta_dot**2
    w5 = ca.cos(link2_theta)
    w6 = w5 * c18
    w7 = w4 * w6
    w8 = link3_theta_dot**2
    w9 = ca.cos(link3_theta)
    w10 = w9 * c19
    w11 = w8 * w10
    w12 = w5 * link_length
    w13 = w4 * w12
    w14 = w2 + w13
    w15 = link4_theta_dot**2
    w16 = ca.cos(link4_theta)
    w17 = w16 * c20
    w18 = w15 * w17
    w19 = w9 * link_length
    w20 = w8 * w19
    w21 = w14 + w20
    w22 = link5_theta_dot**2
    w23 = ca.cos(link5_theta)
    w24 = w23 * c21
    w25 = w22 * w24
    w26 = w16 * link_length
    w27 = w15 * w26
    w28 = w21 + w27
    w29 = link6_theta_dot**2
    w30 = ca.cos(link6_theta)
    w31 = w30 * c22
    w32 = w29 * w31
    w33 = w23 * link_length
    w34 = w22 * w33
    w35 = w28 + w34
    w36 = link7_theta_dot**2
    w37 = ca.cos(link7_theta)
    w38 = w37 * c23
    w39 = w36 * w38
    w40 = w30 * link_length
    w41 = w29 * w40
    w42 = w35 + w41
    w43 = link8_theta_dot**2
    w44 = ca.cos(link8_theta)
    w45 = w44 * c24
    w46 = w43 * w45
    w47 = w37 * link_length
    w48 = w36 * w47
    w49 = w42 + w48
    w50 = link9_theta_dot**2
    w51 = ca.cos(link9_theta)
    w52 = w51 * c25
    w53 = w50 * w52
    w54 = w44 * link_length
    w55 = w43 * w54
    w56 = w49 + w55
    w57 = link10_theta_dot**2
    w58 = ca.cos(link10_theta) * c26
    w59 = w57 * w58
    w60 = w51 * link_length
    w61 = w50 * w60
    w62 = w56 + w61
    w63 = w59 + w62 * link10_mass
    w64 = w53 + w56 * link9_mass + w63
    w65 = w46 + w49 * link8_mass + w64
    w66 = w39 + w42 * link7_mass + w65
    w67 = w32 + w35 * link6_mass + w66
    w68 = w25 + w28 * link5_mass + w67
    w69 = w18 + w21 * link4_mass + w68
    w70 = w11 + w14 * link3_mass + w69
    w71 = ca.sin(link2_theta)
    w72 = w71 * c18
    w73 = w4 * w72
    w74 = w3 * link_length
    w75 = w1 * w74
    w76 = ca.sin(link3_theta)
    w77 = w76 * c19
    w78 = w8 * w77
    w79 = w71 * link_length
    w80 = w4 * w79
    w81 = w75 + w80
    w82 = ca.sin(link4_theta)
    w83 = w82 * c20
    w84 = w15 * w83
    w85 = w76 * link_length
    w86 = w8 * w85
    w87 = w81 + w86
    w88 = ca.sin(link5_theta)
    w89 = w88 * c21
    w90 = w22 * w89
    w91 = w82 * link_length
    w92 = w15 * w91
    w93 = w87 + w92
    w94 = ca.sin(link6_theta)
    w95 = w94 * c22
    w96 = w29 * w95
    w97 = w88 * link_length
    w98 = w22 * w97
    w99 = w93 + w98
    w100 = ca.sin(link7_theta)
    w101 = w100 * c23
    w102 = w36 * w101
    w103 = w94 * link_length
    w104 = w29 * w103
    w105 = w99 + w104
    w106 = ca.sin(link8_theta)
    w107 = w106 * c24
    w108 = w43 * w107
    w109 = w100 * link_length
    w110 = w36 * w109
    w111 = w105 + w110
    w112 = ca.sin(link9_theta)
    w113 = w112 * c25
    w114 = w50 * w113
    w115 = w106 * link_length
    w116 = w43 * w115
    w117 = w111 + w116
    w118 = ca.sin(link10_theta) * c26
    w119 = w57 * w118
    w120 = w112 * link_length
    w121 = w50 * w120
    w122 = w117 + w121
    w123 = c46 + w119 + w122 * link10_mass
    w124 = c45 + w114 + w117 * link9_mass + w123
    w125 = c44 + w108 + w111 * link8_mass + w124
    w126 = c43 + w102 + w105 * link7_mass + w125
    w127 = c42 + w96 + w99 * link6_mass + w126
    w128 = c41 + w90 + w93 * link5_mass + w127
    w129 = c40 + w84 + w87 * link4_mass + w128
    w130 = c39 + w78 + w81 * link3_mass + w129
    w131 = w0 * (w2 * c61) - (w3 * c37 + w0 * (w7 + w2 * link2_mass + w70) + w74 * (c38 + w73 + w75 * link2_mass + w130))
    w132 = w10 + w19 * c15
    w133 = w77 + w85 * c15
    w134 = w17 + w26 * c14
    w135 = w83 + w91 * c14
    w136 = w24 + w33 * c13
    w137 = w89 + w97 * c13
    w138 = w31 + w40 * c12
    w139 = w95 + w103 * c12
    w140 = w38 + w47 * c11
    w141 = w101 + w109 * c11
    w142 = w45 + w54 * c10
    w143 = w107 + w115 * c10
    w144 = w52 + w60 * link10_mass
    w145 = w113 + w120 * link10_mass
    w146 = w13 * c16
    w147 = w80 * c16
    w148 = w20 * c15
    w149 = w11 + w148
    w150 = w86 * c15
    w151 = w78 + w150
    w152 = w27 * c14
    w153 = w18 + w152
    w154 = w92 * c14
    w155 = w84 + w154
    w156 = w34 * c13
    w157 = w25 + w156
    w158 = w98 * c13
    w159 = w90 + w158
    w160 = w41 * c12
    w161 = w32 + w160
    w162 = w104 * c12
    w163 = w96 + w162
    w164 = w48 * c11
    w165 = w39 + w164
    w166 = w110 * c11
    w167 = w102 + w166
    w168 = w47 * w164 - (w101 * w105 + w38 * w42 + w101 * gravity_y + w47 * w65 + w109 * w125) + w109 * w166
    w169 = w55 * c10
    w170 = w46 + w169
    w171 = w116 * c10
    w172 = w108 + w171
    w173 = w54 * w169 - (w107 * w111 + w45 * w49 + w107 * gravity_y + w54 * w64 + w115 * w124) + w115 * w171
    w174 = w61 * link10_mass
    w175 = w53 + w174
    w176 = w121 * link10_mass
    w177 = w114 + w176
    w178 = w60 * w174 - (w113 * w117 + w52 * w56 + w113 * gravity_y + w60 * w63 + w120 * w123) + w120 * w176
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta
            w131 + w74 * (w75 * c61), w0 * (w7 + w146) + w74 * (w73 + w147), w0 * w149 + w74 * w151,
            w0 * w153 + w74 * w155, w0 * w157 + w74 * w159, w0 * w161 + w74 * w163, w0 * w165 + w74 * w167,
            w0 * w170 + w74 * w172, w0 * w175 + w74 * w177, w0 * w59 + w74 * w119,
        ),
        ca.horzcat(  # link2.theta
            w2 * (w6 + w12 * c16) + w75 * (w72 + w79 * c16),
            w12 * w146 - (w72 * w75 + w2 * w6 + w72 * gravity_y + w12 * w70 + w79 * w130) + w79 * w147,
            w12 * w149 + w79 * w151, w12 * w153 + w79 * w155, w12 * w157 + w79 * w159, w12 * w161 + w79 * w163,
            w12 * w165 + w79 * w167, w12 * w170 + w79 * w172, w12 * w175 + w79 * w177, w12 * w59 + w79 * w119,
        ),
        ca.horzcat(  # link3.theta
            w2 * w132 + w75 * w133, w13 * w132 + w80 * w133,
            w19 * w148 - (w77 * w81 + w10 * w14 + w77 * gravity_y + w19 * w69 + w85 * w129) + w85 * w150,
            w19 * w153 + w85 * w155, w19 * w157 + w85 * w159, w19 * w161 + w85 * w163, w19 * w165 + w85 * w167,
            w19 * w170 + w85 * w172, w19 * w175 + w85 * w177, w19 * w59 + w85 * w119,
        ),
        ca.horzcat(  # link4.theta
            w2 * w134 + w75 * w135, w13 * w134 + w80 * w135, w20 * w134 + w86 * w135,
            w26 * w152 - (w83 * w87 + w17 * w21 + w83 * gravity_y + w26 * w68 + w91 * w128) + w91 * w154,
            w26 * w157 + w91 * w159, w26 * w161 + w91 * w163, w26 * w165 + w91 * w167, w26 * w170 + w91 * w172,
            w26 * w175 + w91 * w177, w26 * w59 + w91 * w119,
        ),
        ca.horzcat(  # link5.theta
            w2 * w136 + w75 * w137, w13 * w136 + w80 * w137, w20 * w136 + w86 * w137, w27 * w136 + w92 * w137,
            w33 * w156 - (w89 * w93 + w24 * w28 + w89 * gravity_y + w33 * w67 + w97 * w127) + w97 * w158,
            w33 * w161 + w97 * w163, w33 * w165 + w97 * w167, w33 * w170 + w97 * w172, w33 * w175 + w97 * w177,
            w33 * w59 + w97 * w119,
        ),
        ca.horzcat(  # link6.theta
            w2 * w138 + w75 * w139, w13 * w138 + w80 * w139, w20 * w138 + w86 * w139, w27 * w138 + w92 * w139,
            w34 * w138 + w98 * w139,
            w40 * w160 - (w95 * w99 + w31 * w35 + w95 * gravity_y + w40 * w66 + w103 * w126) + w103 * w162,
            w40 * w165 + w103 * w167, w40 * w170 + w103 * w172, w40 * w175 + w103 * w177, w40 * w59 + w103 * w119,
        ),
        ca.horzcat(  # link7.theta
            w2 * w140 + w75 * w141, w13 * w140 + w80 * w141, w20 * w140 + w86 * w141, w27 * w140 + w92 * w141,
            w34 * w140 + w98 * w141, w41 * w140 + w104 * w141, w168, w47 * w170 + w109 * w172,
            w47 * w175 + w109 * w177, w47 * w59 + w109 * w119,
        ),
        ca.horzcat(  # link8.theta
            w2 * w142 + w75 * w143, w13 * w142 + w80 * w143, w20 * w142 + w86 * w143, w27 * w142 + w92 * w143,
            w34 * w142 + w98 * w143, w41 * w142 + w104 * w143, w48 * w142 + w110 * w143, w173,
            w54 * w175 + w115 * w177, w54 * w59 + w115 * w119,
        ),
        ca.horzcat(  # link9.theta
            w2 * w144 + w75 * w145, w13 * w144 + w80 * w145, w20 * w144 + w86 * w145, w27 * w144 + w92 * w145,
            w34 * w144 + w98 * w145, w41 * w144 + w104 * w145, w48 * w144 + w110 * w145, w55 * w144 + w116 * w145,
            w178, w59 * w60 + w119 * w120,
        ),
        ca.horzcat(  # link10.theta
            w2 * w58 + w75 * w118, w13 * w58 + w80 * w118, w20 * w58 + w86 * w118, w27 * w58 + w92 * w118,
            w34 * w58 + w98 * w118, w41 * w58 + w104 * w118, w48 * w58 + w110 * w118, w55 * w58 + w116 * w118,
            w58 * w61 + w118 * w121, w118 * c60 - (w118 * w122 + w58 * w62),
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    605 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 62)
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
    c61 = c[61]
    # intermediate terms (126)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta) * link_length
    w2 = 2 * link1_theta_dot
    w3 = w1 * w2
    w4 = w0 * w2
    w5 = ca.cos(link2_theta)
    w6 = w5 * c18
    w7 = w5 * link_length
    w8 = ca.sin(link2_theta)
    w9 = w8 * c18
    w10 = w8 * link_length
    w11 = ca.cos(link3_theta)
    w12 = w11 * c19
    w13 = w11 * link_length
    w14 = w12 + w13 * c15
    w15 = ca.sin(link3_theta)
    w16 = w15 * c19
    w17 = w15 * link_length
    w18 = w16 + w17 * c15
    w19 = ca.cos(link4_theta)
    w20 = w19 * c20
    w21 = w19 * link_length
    w22 = w20 + w21 * c14
    w23 = ca.sin(link4_theta)
    w24 = w23 * c20
    w25 = w23 * link_length
    w26 = w24 + w25 * c14
    w27 = ca.cos(link5_theta)
    w28 = w27 * c21
    w29 = w27 * link_length
    w30 = w28 + w29 * c13
    w31 = ca.sin(link5_theta)
    w32 = w31 * c21
    w33 = w31 * link_length
    w34 = w32 + w33 * c13
    w35 = ca.cos(link6_theta)
    w36 = w35 * c22
    w37 = w35 * link_length
    w38 = w36 + w37 * c12
    w39 = ca.sin(link6_theta)
    w40 = w39 * c22
    w41 = w39 * link_length
    w42 = w40 + w41 * c12
    w43 = ca.cos(link7_theta)
    w44 = w43 * c23
    w45 = w43 * link_length
    w46 = w44 + w45 * c11
    w47 = ca.sin(link7_theta)
    w48 = w47 * c23
    w49 = w47 * link_length
    w50 = w48 + w49 * c11
    w51 = ca.cos(link8_theta)
    w52 = w51 * c24
    w53 = w51 * link_length
    w54 = w52 + w53 * c10
    w55 = ca.sin(link8_theta)
    w56 = w55 * c24
    w57 = w55 * link_length
    w58 = w56 + w57 * c10
    w59 = ca.cos(link9_theta)
    w60 = w59 * c25
    w61 = w59 * link_length
    w62 = w60 + w61 * link10_mass
    w63 = ca.sin(link9_theta)
    w64 = w63 * c25
    w65 = w63 * link_length
    w66 = w64 + w65 * link10_mass
    w67 = ca.cos(link10_theta) * c26
    w68 = ca.sin(link10_theta) * c26
    w69 = 2 * link2_theta_dot
    w70 = w10 * w69
    w71 = w70 * c16
    w72 = w7 * w69
    w73 = w72 * c16
    w74 = 2 * link3_theta_dot
    w75 = w17 * w74
    w76 = w75 * c15
    w77 = w16 * w74 + w76
    w78 = w13 * w74
    w79 = w78 * c15
    w80 = w12 * w74 + w79
    w81 = 2 * link4_theta_dot
    w82 = w25 * w81
    w83 = w82 * c14
    w84 = w24 * w81 + w83
    w85 = w21 * w81
    w86 = w85 * c14
    w87 = w20 * w81 + w86
    w88 = 2 * link5_theta_dot
    w89 = w33 * w88
    w90 = w89 * c13
    w91 = w32 * w88 + w90
    w92 = w29 * w88
    w93 = w92 * c13
    w94 = w28 * w88 + w93
    w95 = 2 * link6_theta_dot
    w96 = w41 * w95
    w97 = w96 * c12
    w98 = w40 * w95 + w97
    w99 = w37 * w95
    w100 = w99 * c12
    w101 = w36 * w95 + w100
    w102 = 2 * link7_theta_dot
    w103 = w49 * w102
    w104 = w103 * c11
    w105 = w48 * w102 + w104
    w106 = w45 * w102
    w107 = w106 * c11
    w108 = w44 * w102 + w107
    w109 = 2 * link8_theta_dot
    w110 = w57 * w109
    w111 = w110 * c10
    w112 = w56 * w109 + w111
    w113 = w53 * w109
    w114 = w113 * c10
    w115 = w52 * w109 + w114
    w116 = 2 * link9_theta_dot
    w117 = w65 * w116
    w118 = w117 * link10_mass
    w119 = w64 * w116 + w118
    w120 = w61 * w116
    w121 = w120 * link10_mass
    w122 = w60 * w116 + w121
    w123 = 2 * link10_theta_dot
    w124 = w68 * w123
    w125 = w67 * w123
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * (w3 * c61) - w1 * (w4 * c61), w0 * (w9 * w69 + w71) - w1 * (w6 * w69 + w73), w0 * w77 - w1 * w80,
            w0 * w84 - w1 * w87, w0 * w91 - w1 * w94, w0 * w98 - w1 * w101, w0 * w105 - w1 * w108,
            w0 * w112 - w1 * w115, w0 * w119 - w1 * w122, w0 * w124 - w1 * w125,
        ),
        ca.horzcat(  # link2.theta
            w3 * (w6 + w7 * c16) - w4 * (w9 + w10 * c16), w7 * w71 - w10 * w73, w7 * w77 - w10 * w80,
            w7 * w84 - w10 * w87, w7 * w91 - w10 * w94, w7 * w98 - w10 * w101, w7 * w105 - w10 * w108,
            w7 * w112 - w10 * w115, w7 * w119 - w10 * w122, w7 * w124 - w10 * w125,
        ),
        ca.horzcat(  # link3.theta
            w3 * w14 - w4 * w18, w14 * w70 - w18 * w72, w13 * w76 - w17 * w79, w13 * w84 - w17 * w87,
            w13 * w91 - w17 * w94, w13 * w98 - w17 * w101, w13 * w105 - w17 * w108, w13 * w112 - w17 * w115,
            w13 * w119 - w17 * w122, w13 * w124 - w17 * w125,
        ),
        ca.horzcat(  # link4.theta
            w3 * w22 - w4 * w26, w22 * w70 - w26 * w72, w22 * w75 - w26 * w78, w21 * w83 - w25 * w86,
            w21 * w91 - w25 * w94, w21 * w98 - w25 * w101, w21 * w105 - w25 * w108, w21 * w112 - w25 * w115,
            w21 * w119 - w25 * w122, w21 * w124 - w25 * w125,
        ),
        ca.horzcat(  # link5.theta
            w3 * w30 - w4 * w34, w30 * w70 - w34 * w72, w30 * w75 - w34 * w78, w30 * w82 - w34 * w85,
            w29 * w90 - w33 * w93, w29 * w98 - w33 * w101, w29 * w105 - w33 * w108, w29 * w112 - w33 * w115,
            w29 * w119 - w33 * w122, w29 * w124 - w33 * w125,
        ),
        ca.horzcat(  # link6.theta
            w3 * w38 - w4 * w42, w38 * w70 - w42 * w72, w38 * w75 - w42 * w78, w38 * w82 - w42 * w85,
            w38 * w89 - w42 * w92, w37 * w97 - w41 * w100, w37 * w105 - w41 * w108, w37 * w112 - w41 * w115,
            w37 * w119 - w41 * w122, w37 * w124 - w41 * w125,
        ),
        ca.horzcat(  # link7.theta
            w3 * w46 - w4 * w50, w46 * w70 - w50 * w72, w46 * w75 - w50 * w78, w46 * w82 - w50 * w85,
            w46 * w89 - w50 * w92, w46 * w96 - w50 * w99, w45 * w104 - w49 * w107, w45 * w112 - w49 * w115,
            w45 * w119 - w49 * w122, w45 * w124 - w49 * w125,
        ),
        ca.horzcat(  # link8.theta
            w3 * w54 - w4 * w58, w54 * w70 - w58 * w72, w54 * w75 - w58 * w78, w54 * w82 - w58 * w85,
            w54 * w89 - w58 * w92, w54 * w96 - w58 * w99, w54 * w103 - w58 * w106, w53 * w111 - w57 * w114,
            w53 * w119 - w57 * w122, w53 * w124 - w57 * w125,
        ),
        ca.horzcat(  # link9.theta
            w3 * w62 - w4 * w66, w62 * w70 - w66 * w72, w62 * w75 - w66 * w78, w62 * w82 - w66 * w85,
            w62 * w89 - w66 * w92, w62 * w96 - w66 * w99, w62 * w103 - w66 * w106, w62 * w110 - w66 * w113,
            w61 * w118 - w65 * w121, w61 * w124 - w65 * w125,
        ),
        ca.horzcat(  # link10.theta
            w3 * w67 - w4 * w68, w67 * w70 - w68 * w72, w67 * w75 - w68 * w78, w67 * w82 - w68 * w85,
            w67 * w89 - w68 * w92, w67 * w96 - w68 * w99, w67 * w103 - w68 * w106, w67 * w110 - w68 * w113,
            w67 * w117 - w68 * w120, 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 10 x 10) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1385 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    q_i_ddot = ca.SX.sym("q_i_ddot", 10)
    c = ca.SX.sym("c", 62)
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
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
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
    c61 = c[61]
    # intermediate terms (290)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta)
    w2 = w1 * link_length
    w3 = link1_theta_dot**2
    w4 = link1_theta_ddot * w2 + w0 * w3
    w5 = link2_theta_dot**2
    w6 = ca.cos(link2_theta)
    w7 = w6 * c18
    w8 = w5 * w7
    w9 = ca.sin(link2_theta)
    w10 = w9 * c18
    w11 = w10 * link2_theta_ddot
    w12 = link3_theta_dot**2
    w13 = ca.cos(link3_theta)
    w14 = w13 * c19
    w15 = w12 * w14
    w16 = w6 * link_length
    w17 = w5 * w16
    w18 = w9 * link_length
    w19 = link2_theta_ddot * w18
    w20 = w4 + w17 + w19
    w21 = ca.sin(link3_theta)
    w22 = w21 * c19
    w23 = w22 * link3_theta_ddot
    w24 = link4_theta_dot**2
    w25 = ca.cos(link4_theta)
    w26 = w25 * c20
    w27 = w24 * w26
    w28 = w13 * link_length
    w29 = w12 * w28
    w30 = w21 * link_length
    w31 = link3_theta_ddot * w30
    w32 = w20 + w29 + w31
    w33 = ca.sin(link4_theta)
    w34 = w33 * c20
    w35 = w34 * link4_theta_ddot
    w36 = link5_theta_dot**2
    w37 = ca.cos(link5_theta)
    w38 = w37 * c21
    w39 = w36 * w38
    w40 = w25 * link_length
    w41 = w24 * w40
    w42 = w33 * link_length
    w43 = link4_theta_ddot * w42
    w44 = w32 + w41 + w43
    w45 = ca.sin(link5_theta)
    w46 = w45 * c21
    w47 = w46 * link5_theta_ddot
    w48 = link6_theta_dot**2
    w49 = ca.cos(link6_theta)
    w50 = w49 * c22
    w51 = w48 * w50
    w52 = w37 * link_length
    w53 = w36 * w52
    w54 = w45 * link_length
    w55 = link5_theta_ddot * w54
    w56 = w44 + w53 + w55
    w57 = ca.sin(link6_theta)
    w58 = w57 * c22
    w59 = w58 * link6_theta_ddot
    w60 = link7_theta_dot**2
    w61 = ca.cos(link7_theta)
    w62 = w61 * c23
    w63 = w60 * w62
    w64 = w49 * link_length
    w65 = w48 * w64
    w66 = w57 * link_length
    w67 = link6_theta_ddot * w66
    w68 = w56 + w65 + w67
    w69 = ca.sin(link7_theta)
    w70 = w69 * c23
    w71 = w70 * link7_theta_ddot
    w72 = link8_theta_dot**2
    w73 = ca.cos(link8_theta)
    w74 = w73 * c24
    w75 = w72 * w74
    w76 = w61 * link_length
    w77 = w60 * w76
    w78 = w69 * link_length
    w79 = link7_theta_ddot * w78
    w80 = w68 + w77 + w79
    w81 = ca.sin(link8_theta)
    w82 = w81 * c24
    w83 = w82 * link8_theta_ddot
    w84 = link9_theta_dot**2
    w85 = ca.cos(link9_theta)
    w86 = w85 * c25
    w87 = w84 * w86
    w88 = w73 * link_length
    w89 = w72 * w88
    w90 = w81 * link_length
    w91 = link8_theta_ddot * w90
    w92 = w80 + w89 + w91
    w93 = ca.sin(link9_theta)
    w94 = w93 * c25
    w95 = w94 * link9_theta_ddot
    w96 = link10_theta_dot**2
    w97 = ca.cos(link10_theta) * c26
    w98 = w96 * w97
    w99 = w85 * link_length
    w100 = w84 * w99
    w101 = w93 * link_length
    w102 = link9_theta_ddot * w101
    w103 = w92 + w100 + w102
    w104 = ca.sin(link10_theta) * c26
    w105 = w104 * link10_theta_ddot
    w106 = w98 + (w103 * link10_mass + w105)
    w107 = w87 + (w92 * link9_mass + w95) + w106
    w108 = w75 + (w80 * link8_mass + w83) + w107
    w109 = w63 + (w68 * link7_mass + w71) + w108
    w110 = w51 + (w56 * link6_mass + w59) + w109
    w111 = w39 + (w44 * link5_mass + w47) + w110
    w112 = w27 + (w32 * link4_mass + w35) + w111
    w113 = w15 + (w20 * link3_mass + w23) + w112
    w114 = w5 * w10
    w115 = w0 * link1_theta_ddot - w2 * w3
    w116 = w7 * link2_theta_ddot
    w117 = w12 * w22
    w118 = w5 * w18
    w119 = link2_theta_ddot * w16
    w120 = w115 - w118 + w119
    w121 = w14 * link3_theta_ddot
    w122 = w24 * w34
    w123 = w12 * w30
    w124 = link3_theta_ddot * w28
    w125 = w120 - w123 + w124
    w126 = w26 * link4_theta_ddot
    w127 = w36 * w46
    w128 = w24 * w42
    w129 = link4_theta_ddot * w40
    w130 = w125 - w128 + w129
    w131 = w38 * link5_theta_ddot
    w132 = w48 * w58
    w133 = w36 * w54
    w134 = link5_theta_ddot * w52
    w135 = w130 - w133 + w134
    w136 = w50 * link6_theta_ddot
    w137 = w60 * w70
    w138 = w48 * w66
    w139 = link6_theta_ddot * w64
    w140 = w135 - w138 + w139
    w141 = w62 * link7_theta_ddot
    w142 = w72 * w82
    w143 = w60 * w78
    w144 = link7_theta_ddot * w76
    w145 = w140 - w143 + w144
    w146 = w74 * link8_theta_ddot
    w147 = w84 * w94
    w148 = w72 * w90
    w149 = link8_theta_ddot * w88
    w150 = w145 - w148 + w149
    w151 = w86 * link9_theta_ddot
    w152 = w96 * w104
    w153 = w84 * w101
    w154 = link9_theta_ddot * w99
    w155 = w150 - w153 + w154
    w156 = w97 * link10_theta_ddot
    w157 = c46 + w152 - (w155 * link10_mass + w156)
    w158 = c45 + w147 - (w150 * link9_mass + w151) + w157
    w159 = c44 + w142 - (w145 * link8_mass + w146) + w158
    w160 = c43 + w137 - (w140 * link7_mass + w141) + w159
    w161 = c42 + w132 - (w135 * link6_mass + w136) + w160
    w162 = c41 + w127 - (w130 * link5_mass + w131) + w161
    w163 = c40 + w122 - (w125 * link4_mass + w126) + w162
    w164 = c39 + w117 - (w120 * link3_mass + w121) + w163
    w165 = w1 * c37 + w0 * (w8 + (w4 * link2_mass + w11) + w113) + w2 * (c38 + w114 - (w115 * link2_mass + w116) + w164)
    w166 = w7 + w16 * c16
    w167 = w10 + w18 * c16
    w168 = w14 + w28 * c15
    w169 = w22 + w30 * c15
    w170 = w26 + w40 * c14
    w171 = w34 + w42 * c14
    w172 = w38 + w52 * c13
    w173 = w46 + w54 * c13
    w174 = w50 + w64 * c12
    w175 = w58 + w66 * c12
    w176 = w62 + w76 * c11
    w177 = w70 + w78 * c11
    w178 = w74 + w88 * c10
    w179 = w82 + w90 * c10
    w180 = w86 + w99 * link10_mass
    w181 = w94 + w101 * link10_mass
    w182 = w17 + w19
    w183 = w182 * c16
    w184 = w119 - w118
    w185 = w184 * c16
    w186 = w29 + w31
    w187 = w186 * c15
    w188 = w15 + w23 + w187
    w189 = w124 - w123
    w190 = w189 * c15
    w191 = w121 - w117 + w190
    w192 = w41 + w43
    w193 = w192 * c14
    w194 = w27 + w35 + w193
    w195 = w129 - w128
    w196 = w195 * c14
    w197 = w126 - w122 + w196
    w198 = w53 + w55
    w199 = w198 * c13
    w200 = w39 + w47 + w199
    w201 = w134 - w133
    w202 = w201 * c13
    w203 = w131 - w127 + w202
    w204 = w65 + w67
    w205 = w204 * c12
    w206 = w51 + w59 + w205
    w207 = w139 - w138
    w208 = w207 * c12
    w209 = w136 - w132 + w208
    w210 = w77 + w79
    w211 = w210 * c11
    w212 = w63 + w71 + w211
    w213 = w144 - w143
    w214 = w213 * c11
    w215 = w141 - w137 + w214
    w216 = w89 + w91
    w217 = w216 * c10
    w218 = w75 + w83 + w217
    w219 = w149 - w148
    w220 = w219 * c10
    w221 = w146 - w142 + w220
    w222 = w100 + w102
    w223 = w222 * link10_mass
    w224 = w87 + w95 + w223
    w225 = w154 - w153
    w226 = w225 * link10_mass
    w227 = w151 - w147 + w226
    w228 = w98 + w105
    w229 = w156 - w152
    w230 = 2 * link1_theta_dot
    w231 = w2 * w230
    w232 = w0 * w230
    w233 = 2 * link2_theta_dot
    w234 = w18 * w233
    w235 = w234 * c16
    w236 = w16 * w233
    w237 = w236 * c16
    w238 = 2 * link3_theta_dot
    w239 = w30 * w238
    w240 = w239 * c15
    w241 = w22 * w238 + w240
    w242 = w28 * w238
    w243 = w242 * c15
    w244 = w14 * w238 + w243
    w245 = 2 * link4_theta_dot
    w246 = w42 * w245
    w247 = w246 * c14
    w248 = w34 * w245 + w247
    w249 = w40 * w245
    w250 = w249 * c14
    w251 = w26 * w245 + w250
    w252 = 2 * link5_theta_dot
    w253 = w54 * w252
    w254 = w253 * c13
    w255 = w46 * w252 + w254
    w256 = w52 * w252
    w257 = w256 * c13
    w258 = w38 * w252 + w257
    w259 = 2 * link6_theta_dot
    w260 = w66 * w259
    w261 = w260 * c12
    w262 = w58 * w259 + w261
    w263 = w64 * w259
    w264 = w263 * c12
    w265 = w50 * w259 + w264
    w266 = 2 * link7_theta_dot
    w267 = w78 * w266
    w268 = w267 * c11
    w269 = w70 * w266 + w268
    w270 = w76 * w266
    w271 = w270 * c11
    w272 = w62 * w266 + w271
    w273 = 2 * link8_theta_dot
    w274 = w90 * w273
    w275 = w274 * c10
    w276 = w82 * w273 + w275
    w277 = w88 * w273
    w278 = w277 * c10
    w279 = w74 * w273 + w278
    w280 = 2 * link9_theta_dot
    w281 = w101 * w280
    w282 = w281 * link10_mass
    w283 = w94 * w280 + w282
    w284 = w99 * w280
    w285 = w284 * link10_mass
    w286 = w86 * w280 + w285
    w287 = 2 * link10_theta_dot
    w288 = w104 * w287
    w289 = w97 * w287
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * (w4 * c61) - w165 - w2 * (w115 * c61), w0 * (w8 + w11 + w183) - w2 * (w116 - w114 + w185),
            w0 * w188 - w2 * w191, w0 * w194 - w2 * w197, w0 * w200 - w2 * w203, w0 * w206 - w2 * w209,
            w0 * w212 - w2 * w215, w0 * w218 - w2 * w221, w0 * w224 - w2 * w227, w0 * w228 - w2 * w229,
        ),
        ca.horzcat(  # link2.theta
            w4 * w166 - w115 * w167,
            w10 * w115 - w4 * w7 - w10 * gravity_y - w16 * w113 - w18 * w164 + w16 * w183 - w18 * w185,
            w16 * w188 - w18 * w191, w16 * w194 - w18 * w197, w16 * w200 - w18 * w203, w16 * w206 - w18 * w209,
            w16 * w212 - w18 * w215, w16 * w218 - w18 * w221, w16 * w224 - w18 * w227, w16 * w228 - w18 * w229,
        ),
        ca.horzcat(  # link3.theta
            w4 * w168 - w115 * w169, w168 * w182 - w169 * w184,
            w22 * w120 - w14 * w20 - w22 * gravity_y - w28 * w112 - w30 * w163 + w28 * w187 - w30 * w190,
            w28 * w194 - w30 * w197, w28 * w200 - w30 * w203, w28 * w206 - w30 * w209, w28 * w212 - w30 * w215,
            w28 * w218 - w30 * w221, w28 * w224 - w30 * w227, w28 * w228 - w30 * w229,
        ),
        ca.horzcat(  # link4.theta
            w4 * w170 - w115 * w171, w170 * w182 - w171 * w184, w170 * w186 - w171 * w189,
            w34 * w125 - w26 * w32 - w34 * gravity_y - w40 * w111 - w42 * w162 + w40 * w193 - w42 * w196,
            w40 * w200 - w42 * w203, w40 * w206 - w42 * w209, w40 * w212 - w42 * w215, w40 * w218 - w42 * w221,
            w40 * w224 - w42 * w227, w40 * w228 - w42 * w229,
        ),
        ca.horzcat(  # link5.theta
            w4 * w172 - w115 * w173, w172 * w182 - w173 * w184, w172 * w186 - w173 * w189,
            w172 * w192 - w173 * w195,
            w46 * w130 - w38 * w44 - w46 * gravity_y - w52 * w110 - w54 * w161 + w52 * w199 - w54 * w202,
            w52 * w206 - w54 * w209, w52 * w212 - w54 * w215, w52 * w218 - w54 * w221, w52 * w224 - w54 * w227,
            w52 * w228 - w54 * w229,
        ),
        ca.horzcat(  # link6.theta
            w4 * w174 - w115 * w175, w174 * w182 - w175 * w184, w174 * w186 - w175 * w189,
            w174 * w192 - w175 * w195, w174 * w198 - w175 * w201,
            w58 * w135 - w50 * w56 - w58 * gravity_y - w64 * w109 - w66 * w160 + w64 * w205 - w66 * w208,
            w64 * w212 - w66 * w215, w64 * w218 - w66 * w221, w64 * w224 - w66 * w227, w64 * w228 - w66 * w229,
        ),
        ca.horzcat(  # link7.theta
            w4 * w176 - w115 * w177, w176 * w182 - w177 * w184, w176 * w186 - w177 * w189,
            w176 * w192 - w177 * w195, w176 * w198 - w177 * w201, w176 * w204 - w177 * w207,
            w70 * w140 - w62 * w68 - w70 * gravity_y - w76 * w108 - w78 * w159 + w76 * w211 - w78 * w214,
            w76 * w218 - w78 * w221, w76 * w224 - w78 * w227, w76 * w228 - w78 * w229,
        ),
        ca.horzcat(  # link8.theta
            w4 * w178 - w115 * w179, w178 * w182 - w179 * w184, w178 * w186 - w179 * w189,
            w178 * w192 - w179 * w195, w178 * w198 - w179 * w201, w178 * w204 - w179 * w207,
            w178 * w210 - w179 * w213,
            w82 * w145 - w74 * w80 - w82 * gravity_y - w88 * w107 - w90 * w158 + w88 * w217 - w90 * w220,
            w88 * w224 - w90 * w227, w88 * w228 - w90 * w229,
        ),
        ca.horzcat(  # link9.theta
            w4 * w180 - w115 * w181, w180 * w182 - w181 * w184, w180 * w186 - w181 * w189,
            w180 * w192 - w181 * w195, w180 * w198 - w181 * w201, w180 * w204 - w181 * w207,
            w180 * w210 - w181 * w213, w180 * w216 - w181 * w219,
            w94 * w150 - w86 * w92 - w94 * gravity_y - w99 * w106 - w101 * w157 + w99 * w223 - w101 * w226,
            w99 * w228 - w101 * w229,
        ),
        ca.horzcat(  # link10.theta
            w4 * w97 - w104 * w115, w97 * w182 - w104 * w184, w97 * w186 - w104 * w189, w97 * w192 - w104 * w195,
            w97 * w198 - w104 * w201, w97 * w204 - w104 * w207, w97 * w210 - w104 * w213, w97 * w216 - w104 * w219,
            w97 * w222 - w104 * w225, w104 * w155 - w97 * w103 - w104 * gravity_y,
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * (w231 * c61) - w2 * (w232 * c61), w0 * (w10 * w233 + w235) - w2 * (w7 * w233 + w237),
            w0 * w241 - w2 * w244, w0 * w248 - w2 * w251, w0 * w255 - w2 * w258, w0 * w262 - w2 * w265,
            w0 * w269 - w2 * w272, w0 * w276 - w2 * w279, w0 * w283 - w2 * w286, w0 * w288 - w2 * w289,
        ),
        ca.horzcat(  # link2.theta
            w166 * w231 - w167 * w232, w16 * w235 - w18 * w237, w16 * w241 - w18 * w244, w16 * w248 - w18 * w251,
            w16 * w255 - w18 * w258, w16 * w262 - w18 * w265, w16 * w269 - w18 * w272, w16 * w276 - w18 * w279,
            w16 * w283 - w18 * w286, w16 * w288 - w18 * w289,
        ),
        ca.horzcat(  # link3.theta
            w168 * w231 - w169 * w232, w168 * w234 - w169 * w236, w28 * w240 - w30 * w243, w28 * w248 - w30 * w251,
            w28 * w255 - w30 * w258, w28 * w262 - w30 * w265, w28 * w269 - w30 * w272, w28 * w276 - w30 * w279,
            w28 * w283 - w30 * w286, w28 * w288 - w30 * w289,
        ),
        ca.horzcat(  # link4.theta
            w170 * w231 - w171 * w232, w170 * w234 - w171 * w236, w170 * w239 - w171 * w242,
            w40 * w247 - w42 * w250, w40 * w255 - w42 * w258, w40 * w262 - w42 * w265, w40 * w269 - w42 * w272,
            w40 * w276 - w42 * w279, w40 * w283 - w42 * w286, w40 * w288 - w42 * w289,
        ),
        ca.horzcat(  # link5.theta
            w172 * w231 - w173 * w232, w172 * w234 - w173 * w236, w172 * w239 - w173 * w242,
            w172 * w246 - w173 * w249, w52 * w254 - w54 * w257, w52 * w262 - w54 * w265, w52 * w269 - w54 * w272,
            w52 * w276 - w54 * w279, w52 * w283 - w54 * w286, w52 * w288 - w54 * w289,
        ),
        ca.horzcat(  # link6.theta
            w174 * w231 - w175 * w232, w174 * w234 - w175 * w236, w174 * w239 - w175 * w242,
            w174 * w246 - w175 * w249, w174 * w253 - w175 * w256, w64 * w261 - w66 * w264, w64 * w269 - w66 * w272,
            w64 * w276 - w66 * w279, w64 * w283 - w66 * w286, w64 * w288 - w66 * w289,
        ),
        ca.horzcat(  # link7.theta
            w176 * w231 - w177 * w232, w176 * w234 - w177 * w236, w176 * w239 - w177 * w242,
            w176 * w246 - w177 * w249, w176 * w253 - w177 * w256, w176 * w260 - w177 * w263,
            w76 * w268 - w78 * w271, w76 * w276 - w78 * w279, w76 * w283 - w78 * w286, w76 * w288 - w78 * w289,
        ),
        ca.horzcat(  # link8.theta
            w178 * w231 - w179 * w232, w178 * w234 - w179 * w236, w178 * w239 - w179 * w242,
            w178 * w246 - w179 * w249, w178 * w253 - w179 * w256, w178 * w260 - w179 * w263,
            w178 * w267 - w179 * w270, w88 * w275 - w90 * w278, w88 * w283 - w90 * w286, w88 * w288 - w90 * w289,
        ),
        ca.horzcat(  # link9.theta
            w180 * w231 - w181 * w232, w180 * w234 - w181 * w236, w180 * w239 - w181 * w242,
            w180 * w246 - w181 * w249, w180 * w253 - w181 * w256, w180 * w260 - w181 * w263,
            w180 * w267 - w181 * w270, w180 * w274 - w181 * w277, w99 * w282 - w101 * w285,
            w99 * w288 - w101 * w289,
        ),
        ca.horzcat(  # link10.theta
            w97 * w231 - w104 * w232, w97 * w234 - w104 * w236, w97 * w239 - w104 * w242, w97 * w246 - w104 * w249,
            w97 * w253 - w104 * w256, w97 * w260 - w104 * w263, w97 * w267 - w104 * w270, w97 * w274 - w104 * w277,
            w97 * w281 - w104 * w284, 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 62) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    674 operations.
    """
    q_i = ca.SX.sym("q_i", 10)
    q_i_dot = ca.SX.sym("q_i_dot", 10)
    c = ca.SX.sym("c", 62)
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
        (w30 - (w27 * (w39 + (w224 + w32 * w225)) + w28 * (w223 + w38 * w225 - w33))) / c35,  # link10.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 12) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 21) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 21) [1]: columns of the rotation matrix of the marker at a drawn point
    255 operations.
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
    16 operations.
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
