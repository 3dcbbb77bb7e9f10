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
    gives c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    158 operations.
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
    # intermediate terms (22)
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
        w1 * link2_mass,  # c18
        w1 * link3_mass,  # c19
        w1 * link4_mass,  # c20
        w1 * link5_mass,  # c21
        w1 * link6_mass,  # c22
        w1 * link7_mass,  # c23
        w1 * link8_mass,  # c24
        w11,  # c25
        w1 * link10_mass,  # c26
        w12 + link_length * (link_length * w10),  # c27
        w13 + link_length * (link_length * w9),  # c28
        w14 + link_length * (link_length * w8),  # c29
        w15 + link_length * (link_length * w7),  # c30
        w16 + link_length * (link_length * w6),  # c31
        w17 + link_length * (link_length * w5),  # c32
        w18 + link_length * (link_length * w4),  # c33
        w19 + w20,  # c34
        w0 + w2 * link10_mass,  # c35
        gravity_y,  # gravity_y
        w21 * gravity_y,  # c37
        link2_mass * gravity_y,  # c38
        link3_mass * gravity_y,  # c39
        link4_mass * gravity_y,  # c40
        link5_mass * gravity_y,  # c41
        link6_mass * gravity_y,  # c42
        link7_mass * gravity_y,  # c43
        link8_mass * gravity_y,  # c44
        link9_mass * gravity_y,  # c45
        link10_mass * gravity_y,  # c46
        link1_mass,  # link1_mass
        w3,  # c48
        w12,  # c49
        w13,  # c50
        w14,  # c51
        w15,  # c52
        w16,  # c53
        w17,  # c54
        w18,  # c55
        w19,  # c56
        w21,  # c57
        link1_mass * gravity_y,  # c58
        w20 + link_length * w11,  # c59
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 10 x 10) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 10) [N, N m]: condensed force S^T (Q* - M s)
    605 operations.
    """
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 20) [mixed]: dependent coordinates after one Newton step
    83 operations.
    """
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 20) [mixed]: rates of the dependent coordinates
    119 operations.
    """
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
    link_length = c[0]
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
        -(w14 + ca.sin(link9_theta) * link_length * link9_theta_dot),  # link10.x
        w15 + link9_theta_dot * (ca.cos(link9_theta) * link_length),  # link10.y
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 20) [mixed]: accelerations of the dependent coordinates
    173 operations.
    """
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 20) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 20 x 30) [SI]: constraint Jacobian
    gives C_t (n_c = 20) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 20) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 20) [m/s^2, rad/s^2]: right-hand side at acceleration level
    848 operations.
    """
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    link1_mass = c[47]
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
    # intermediate terms (106)
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
    M[2, 2] = c48
    # link2.x
    M[3, 3] = link2_mass
    M[3, 5] = w7
    # link2.y
    M[4, 4] = link2_mass
    M[4, 5] = w9
    # link2.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c49
    # link3.x
    M[6, 6] = link3_mass
    M[6, 8] = w12
    # link3.y
    M[7, 7] = link3_mass
    M[7, 8] = w14
    # link3.theta
    M[8, 6] = w12
    M[8, 7] = w14
    M[8, 8] = c50
    # link4.x
    M[9, 9] = link4_mass
    M[9, 11] = w17
    # link4.y
    M[10, 10] = link4_mass
    M[10, 11] = w19
    # link4.theta
    M[11, 9] = w17
    M[11, 10] = w19
    M[11, 11] = c51
    # link5.x
    M[12, 12] = link5_mass
    M[12, 14] = w22
    # link5.y
    M[13, 13] = link5_mass
    M[13, 14] = w24
    # link5.theta
    M[14, 12] = w22
    M[14, 13] = w24
    M[14, 14] = c52
    # link6.x
    M[15, 15] = link6_mass
    M[15, 17] = w27
    # link6.y
    M[16, 16] = link6_mass
    M[16, 17] = w29
    # link6.theta
    M[17, 15] = w27
    M[17, 16] = w29
    M[17, 17] = c53
    # link7.x
    M[18, 18] = link7_mass
    M[18, 20] = w32
    # link7.y
    M[19, 19] = link7_mass
    M[19, 20] = w34
    # link7.theta
    M[20, 18] = w32
    M[20, 19] = w34
    M[20, 20] = c54
    # link8.x
    M[21, 21] = link8_mass
    M[21, 23] = w37
    # link8.y
    M[22, 22] = link8_mass
    M[22, 23] = w39
    # link8.theta
    M[23, 21] = w37
    M[23, 22] = w39
    M[23, 23] = c55
    # link9.x
    M[24, 24] = link9_mass
    M[24, 26] = w42
    # link9.y
    M[25, 25] = link9_mass
    M[25, 26] = w44
    # link9.theta
    M[26, 24] = w42
    M[26, 25] = w44
    M[26, 26] = c56
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
        c58,  # link1.y
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
        w50 + c58,  # link1.y
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 20) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 10) [N, N m]: world force and moment of a joint on its body b, at b
    329 operations.
    """
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
    link1_mass = c[47]
    c57 = c[57]
    c58 = c[58]
    # intermediate terms (50)
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
    w49 = c58 + w0 * w2 - (link1_y_ddot * link1_mass + w1 * link1_theta_ddot) + w48
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    338 operations.
    """
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
    link1_mass = c[47]
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
    # intermediate terms (38)
    w0 = ca.sin(link1_theta) * c57
    w1 = ca.cos(link1_theta) * c57
    w2 = link1_x_dot * (link1_x_dot * link1_mass - w0 * link1_theta_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta_dot * w1)
    w3 = ca.sin(link2_theta) * c18
    w4 = w2 + link1_theta_dot * (link1_y_dot * w1 - link1_x_dot * w0 + link1_theta_dot * c48) + link2_x_dot * (link2_x_dot * link2_mass - w3 * link2_theta_dot)
    w5 = ca.cos(link2_theta) * c18
    w6 = w4 + link2_y_dot * (link2_y_dot * link2_mass + link2_theta_dot * w5) + link2_theta_dot * (link2_y_dot * w5 - link2_x_dot * w3 + link2_theta_dot * c49)
    w7 = ca.sin(link3_theta) * c19
    w8 = ca.cos(link3_theta) * c19
    w9 = w6 + link3_x_dot * (link3_x_dot * link3_mass - w7 * link3_theta_dot) + link3_y_dot * (link3_y_dot * link3_mass + link3_theta_dot * w8)
    w10 = ca.sin(link4_theta) * c20
    w11 = w9 + link3_theta_dot * (link3_y_dot * w8 - link3_x_dot * w7 + link3_theta_dot * c50) + link4_x_dot * (link4_x_dot * link4_mass - w10 * link4_theta_dot)
    w12 = ca.cos(link4_theta) * c20
    w13 = w11 + link4_y_dot * (link4_y_dot * link4_mass + link4_theta_dot * w12) + link4_theta_dot * (link4_y_dot * w12 - link4_x_dot * w10 + link4_theta_dot * c51)
    w14 = ca.sin(link5_theta) * c21
    w15 = ca.cos(link5_theta) * c21
    w16 = w13 + link5_x_dot * (link5_x_dot * link5_mass - w14 * link5_theta_dot) + link5_y_dot * (link5_y_dot * link5_mass + link5_theta_dot * w15)
    w17 = ca.sin(link6_theta) * c22
    w18 = w16 + link5_theta_dot * (link5_y_dot * w15 - link5_x_dot * w14 + link5_theta_dot * c52) + link6_x_dot * (link6_x_dot * link6_mass - w17 * link6_theta_dot)
    w19 = ca.cos(link6_theta) * c22
    w20 = w18 + link6_y_dot * (link6_y_dot * link6_mass + link6_theta_dot * w19) + link6_theta_dot * (link6_y_dot * w19 - link6_x_dot * w17 + link6_theta_dot * c53)
    w21 = ca.sin(link7_theta) * c23
    w22 = ca.cos(link7_theta) * c23
    w23 = w20 + link7_x_dot * (link7_x_dot * link7_mass - w21 * link7_theta_dot) + link7_y_dot * (link7_y_dot * link7_mass + link7_theta_dot * w22)
    w24 = ca.sin(link8_theta) * c24
    w25 = w23 + link7_theta_dot * (link7_y_dot * w22 - link7_x_dot * w21 + link7_theta_dot * c54) + link8_x_dot * (link8_x_dot * link8_mass - w24 * link8_theta_dot)
    w26 = ca.cos(link8_theta) * c24
    w27 = w25 + link8_y_dot * (link8_y_dot * link8_mass + link8_theta_dot * w26) + link8_theta_dot * (link8_y_dot * w26 - link8_x_dot * w24 + link8_theta_dot * c55)
    w28 = ca.sin(link9_theta) * c25
    w29 = ca.cos(link9_theta) * c25
    w30 = w27 + link9_x_dot * (link9_x_dot * link9_mass - w28 * link9_theta_dot) + link9_y_dot * (link9_y_dot * link9_mass + link9_theta_dot * w29)
    w31 = ca.sin(link10_theta) * c26
    w32 = w30 + link9_theta_dot * (link9_y_dot * w29 - link9_x_dot * w28 + link9_theta_dot * c56) + link10_x_dot * (link10_x_dot * link10_mass - w31 * link10_theta_dot)
    w33 = ca.cos(link10_theta) * c26
    w34 = w32 + link10_y_dot * (link10_y_dot * link10_mass + link10_theta_dot * w33) + link10_theta_dot * (link10_y_dot * w33 - link10_x_dot * w31 + link10_theta_dot * c35)
    w35 = (w0 + link1_y * link1_mass) * gravity_y + (w3 + link2_y * link2_mass) * gravity_y + (w7 + link3_y * link3_mass) * gravity_y
    w36 = w35 + (w10 + link4_y * link4_mass) * gravity_y + (w14 + link5_y * link5_mass) * gravity_y + (w17 + link6_y * link6_mass) * gravity_y
    w37 = w36 + (w21 + link7_y * link7_mass) * gravity_y + (w24 + link8_y * link8_mass) * gravity_y + (w28 + link9_y * link9_mass) * gravity_y
    # outputs
    kinetic = ca.vertcat(w34 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(-(w37 + (w31 + link10_y * link10_mass) * gravity_y))
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
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i, through q_d
    1037 operations.
    """
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
    c59 = c[59]
    # intermediate terms (228)
    w0 = ca.cos(link1_theta)
    w1 = w0 * link_length
    w2 = link1_theta_dot**2
    w3 = w1 * w2
    w4 = w3 * link2_mass
    w5 = w3 * link9_mass + w3 * link10_mass
    w6 = w3 * link8_mass + w5
    w7 = w3 * link7_mass + w6
    w8 = w3 * link6_mass + w7
    w9 = w3 * link5_mass + w8
    w10 = w3 * link4_mass + w9
    w11 = w3 * link3_mass + w10
    w12 = link2_theta_dot**2
    w13 = ca.sin(link2_theta)
    w14 = w13 * c18
    w15 = w12 * w14
    w16 = ca.sin(link1_theta)
    w17 = w16 * link_length
    w18 = w2 * w17
    w19 = w18 * link2_mass
    w20 = link3_theta_dot**2
    w21 = ca.sin(link3_theta)
    w22 = w21 * c19
    w23 = w20 * w22
    w24 = w13 * link_length
    w25 = w12 * w24
    w26 = w18 + w25
    w27 = link4_theta_dot**2
    w28 = ca.sin(link4_theta)
    w29 = w28 * c20
    w30 = w27 * w29
    w31 = w21 * link_length
    w32 = w20 * w31
    w33 = w26 + w32
    w34 = link5_theta_dot**2
    w35 = ca.sin(link5_theta)
    w36 = w35 * c21
    w37 = w34 * w36
    w38 = w28 * link_length
    w39 = w27 * w38
    w40 = w33 + w39
    w41 = link6_theta_dot**2
    w42 = ca.sin(link6_theta)
    w43 = w42 * c22
    w44 = w41 * w43
    w45 = w35 * link_length
    w46 = w34 * w45
    w47 = w40 + w46
    w48 = link7_theta_dot**2
    w49 = ca.sin(link7_theta)
    w50 = w49 * c23
    w51 = w48 * w50
    w52 = w42 * link_length
    w53 = w41 * w52
    w54 = w47 + w53
    w55 = link8_theta_dot**2
    w56 = ca.sin(link8_theta)
    w57 = w56 * c24
    w58 = w55 * w57
    w59 = w49 * link_length
    w60 = w48 * w59
    w61 = w54 + w60
    w62 = link9_theta_dot**2
    w63 = ca.sin(link9_theta)
    w64 = w63 * c25
    w65 = w62 * w64
    w66 = w56 * link_length
    w67 = w55 * w66
    w68 = w61 + w67
    w69 = link10_theta_dot**2
    w70 = ca.sin(link10_theta) * c26
    w71 = w69 * w70
    w72 = w63 * link_length
    w73 = w62 * w72
    w74 = w68 + w73
    w75 = c46 + w71 + w74 * link10_mass
    w76 = c45 + w65 + w68 * link9_mass + w75
    w77 = c44 + w58 + w61 * link8_mass + w76
    w78 = c43 + w51 + w54 * link7_mass + w77
    w79 = c42 + w44 + w47 * link6_mass + w78
    w80 = c41 + w37 + w40 * link5_mass + w79
    w81 = c40 + w30 + w33 * link4_mass + w80
    w82 = c39 + w23 + w26 * link3_mass + w81
    w83 = ca.cos(link2_theta)
    w84 = w83 * c18
    w85 = w12 * w84
    w86 = ca.cos(link3_theta)
    w87 = w86 * c19
    w88 = w20 * w87
    w89 = w83 * link_length
    w90 = w12 * w89
    w91 = w3 + w90
    w92 = ca.cos(link4_theta)
    w93 = w92 * c20
    w94 = w27 * w93
    w95 = w86 * link_length
    w96 = w20 * w95
    w97 = w91 + w96
    w98 = ca.cos(link5_theta)
    w99 = w98 * c21
    w100 = w34 * w99
    w101 = w92 * link_length
    w102 = w27 * w101
    w103 = w97 + w102
    w104 = ca.cos(link6_theta)
    w105 = w104 * c22
    w106 = w41 * w105
    w107 = w98 * link_length
    w108 = w34 * w107
    w109 = w103 + w108
    w110 = ca.cos(link7_theta)
    w111 = w110 * c23
    w112 = w48 * w111
    w113 = w104 * link_length
    w114 = w41 * w113
    w115 = w109 + w114
    w116 = ca.cos(link8_theta)
    w117 = w116 * c24
    w118 = w55 * w117
    w119 = w110 * link_length
    w120 = w48 * w119
    w121 = w115 + w120
    w122 = ca.cos(link9_theta)
    w123 = w122 * c25
    w124 = w62 * w123
    w125 = w116 * link_length
    w126 = w55 * w125
    w127 = w121 + w126
    w128 = ca.cos(link10_theta) * c26
    w129 = w69 * w128
    w130 = w122 * link_length
    w131 = w62 * w130
    w132 = w127 + w131
    w133 = w129 + w132 * link10_mass
    w134 = w124 + w127 * link9_mass + w133
    w135 = w118 + w121 * link8_mass + w134
    w136 = w112 + w115 * link7_mass + w135
    w137 = w106 + w109 * link6_mass + w136
    w138 = w100 + w103 * link5_mass + w137
    w139 = w94 + w97 * link4_mass + w138
    w140 = w88 + w91 * link3_mass + w139
    w141 = w18 * link9_mass + w18 * link10_mass
    w142 = w18 * link8_mass + w141
    w143 = w18 * link7_mass + w142
    w144 = w18 * link6_mass + w143
    w145 = w18 * link5_mass + w144
    w146 = w18 * link4_mass + w145
    w147 = w18 * link3_mass + w146
    w148 = w1 * (w4 + w11) - w17 * (c38 + w15 + w19 + w82) - w16 * c37 - (w1 * (w4 + w85 + w140) - w17 * (w19 + w147))
    w149 = w14 * w18 + w3 * w84
    w150 = w90 * link9_mass + w90 * link10_mass
    w151 = w90 * link8_mass + w150
    w152 = w90 * link7_mass + w151
    w153 = w90 * link6_mass + w152
    w154 = w90 * link5_mass + w153
    w155 = w90 * link4_mass + w154
    w156 = w90 * link3_mass + w155
    w157 = w25 * link9_mass + w25 * link10_mass
    w158 = w25 * link8_mass + w157
    w159 = w25 * link7_mass + w158
    w160 = w25 * link6_mass + w159
    w161 = w25 * link5_mass + w160
    w162 = w25 * link4_mass + w161
    w163 = w25 * link3_mass + w162
    w164 = w96 * link9_mass + w96 * link10_mass
    w165 = w96 * link8_mass + w164
    w166 = w96 * link7_mass + w165
    w167 = w96 * link6_mass + w166
    w168 = w96 * link5_mass + w167
    w169 = w96 * link4_mass + w168
    w170 = w88 + w169
    w171 = w32 * link9_mass + w32 * link10_mass
    w172 = w32 * link8_mass + w171
    w173 = w32 * link7_mass + w172
    w174 = w32 * link6_mass + w173
    w175 = w32 * link5_mass + w174
    w176 = w32 * link4_mass + w175
    w177 = w23 + w176
    w178 = w102 * link9_mass + w102 * link10_mass
    w179 = w102 * link8_mass + w178
    w180 = w102 * link7_mass + w179
    w181 = w102 * link6_mass + w180
    w182 = w102 * link5_mass + w181
    w183 = w94 + w182
    w184 = w39 * link9_mass + w39 * link10_mass
    w185 = w39 * link8_mass + w184
    w186 = w39 * link7_mass + w185
    w187 = w39 * link6_mass + w186
    w188 = w39 * link5_mass + w187
    w189 = w30 + w188
    w190 = w101 * w182 - w38 * w80 - (w29 * gravity_y + (w93 * w97 + w29 * w33)) - (w101 * w138 - w38 * w188)
    w191 = w108 * link9_mass + w108 * link10_mass
    w192 = w108 * link8_mass + w191
    w193 = w108 * link7_mass + w192
    w194 = w108 * link6_mass + w193
    w195 = w100 + w194
    w196 = w46 * link9_mass + w46 * link10_mass
    w197 = w46 * link8_mass + w196
    w198 = w46 * link7_mass + w197
    w199 = w46 * link6_mass + w198
    w200 = w37 + w199
    w201 = w107 * w194 - w45 * w79 - (w36 * gravity_y + (w99 * w103 + w36 * w40)) - (w107 * w137 - w45 * w199)
    w202 = w114 * link9_mass + w114 * link10_mass
    w203 = w114 * link8_mass + w202
    w204 = w114 * link7_mass + w203
    w205 = w106 + w204
    w206 = w53 * link9_mass + w53 * link10_mass
    w207 = w53 * link8_mass + w206
    w208 = w53 * link7_mass + w207
    w209 = w44 + w208
    w210 = w113 * w204 - w52 * w78 - (w43 * gravity_y + (w105 * w109 + w43 * w47)) - (w113 * w136 - w52 * w208)
    w211 = w120 * link9_mass + w120 * link10_mass
    w212 = w120 * link8_mass + w211
    w213 = w112 + w212
    w214 = w60 * link9_mass + w60 * link10_mass
    w215 = w60 * link8_mass + w214
    w216 = w51 + w215
    w217 = w119 * w212 - w59 * w77 - (w50 * gravity_y + (w111 * w115 + w50 * w54)) - (w119 * w135 - w59 * w215)
    w218 = w126 * link9_mass + w126 * link10_mass
    w219 = w118 + w218
    w220 = w67 * link9_mass + w67 * link10_mass
    w221 = w58 + w220
    w222 = w125 * w218 - w66 * w76 - (w57 * gravity_y + (w117 * w121 + w57 * w61)) - (w125 * w134 - w66 * w220)
    w223 = w131 * link10_mass
    w224 = w124 + w223
    w225 = w73 * link10_mass
    w226 = w65 + w225
    w227 = w130 * w223 - w72 * w75 - (w64 * gravity_y + (w123 * w127 + w64 * w68)) - (w130 * w133 - w72 * w225)
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta
            w148, w1 * (w85 + w156) + w17 * (w15 + w163), w1 * w170 + w17 * w177, w1 * w183 + w17 * w189,
            w1 * w195 + w17 * w200, w1 * w205 + w17 * w209, w1 * w213 + w17 * w216, w1 * w219 + w17 * w221,
            w1 * w224 + w17 * w226, w1 * w129 + w17 * w71,
        ),
        ca.horzcat(  # link2.theta
            w149 + w11 * w89 + w24 * w147,
            w89 * w156 - w24 * w82 - (w149 + w14 * gravity_y) - (w89 * w140 - w24 * w163), w89 * w170 + w24 * w177,
            w89 * w183 + w24 * w189, w89 * w195 + w24 * w200, w89 * w205 + w24 * w209, w89 * w213 + w24 * w216,
            w89 * w219 + w24 * w221, w89 * w224 + w24 * w226, w89 * w129 + w24 * w71,
        ),
        ca.horzcat(  # link3.theta
            w18 * w22 + w3 * w87 + w10 * w95 + w31 * w146, w22 * w25 + w87 * w90 + w95 * w155 + w31 * w162,
            w95 * w169 - w31 * w81 - (w22 * gravity_y + (w87 * w91 + w22 * w26)) - (w95 * w139 - w31 * w176),
            w95 * w183 + w31 * w189, w95 * w195 + w31 * w200, w95 * w205 + w31 * w209, w95 * w213 + w31 * w216,
            w95 * w219 + w31 * w221, w95 * w224 + w31 * w226, w95 * w129 + w31 * w71,
        ),
        ca.horzcat(  # link4.theta
            w18 * w29 + w3 * w93 + w9 * w101 + w38 * w145, w25 * w29 + w90 * w93 + w101 * w154 + w38 * w161,
            w29 * w32 + w93 * w96 + w101 * w168 + w38 * w175, w190, w101 * w195 + w38 * w200,
            w101 * w205 + w38 * w209, w101 * w213 + w38 * w216, w101 * w219 + w38 * w221, w101 * w224 + w38 * w226,
            w101 * w129 + w38 * w71,
        ),
        ca.horzcat(  # link5.theta
            w18 * w36 + w3 * w99 + w8 * w107 + w45 * w144, w25 * w36 + w90 * w99 + w107 * w153 + w45 * w160,
            w32 * w36 + w96 * w99 + w107 * w167 + w45 * w174, w36 * w39 + w99 * w102 + w107 * w181 + w45 * w187,
            w201, w107 * w205 + w45 * w209, w107 * w213 + w45 * w216, w107 * w219 + w45 * w221,
            w107 * w224 + w45 * w226, w107 * w129 + w45 * w71,
        ),
        ca.horzcat(  # link6.theta
            w18 * w43 + w3 * w105 + w7 * w113 + w52 * w143, w25 * w43 + w90 * w105 + w113 * w152 + w52 * w159,
            w32 * w43 + w96 * w105 + w113 * w166 + w52 * w173, w39 * w43 + w102 * w105 + w113 * w180 + w52 * w186,
            w43 * w46 + w105 * w108 + w113 * w193 + w52 * w198, w210, w113 * w213 + w52 * w216,
            w113 * w219 + w52 * w221, w113 * w224 + w52 * w226, w113 * w129 + w52 * w71,
        ),
        ca.horzcat(  # link7.theta
            w18 * w50 + w3 * w111 + w6 * w119 + w59 * w142, w25 * w50 + w90 * w111 + w119 * w151 + w59 * w158,
            w32 * w50 + w96 * w111 + w119 * w165 + w59 * w172, w39 * w50 + w102 * w111 + w119 * w179 + w59 * w185,
            w46 * w50 + w108 * w111 + w119 * w192 + w59 * w197, w50 * w53 + w111 * w114 + w119 * w203 + w59 * w207,
            w217, w119 * w219 + w59 * w221, w119 * w224 + w59 * w226, w119 * w129 + w59 * w71,
        ),
        ca.horzcat(  # link8.theta
            w18 * w57 + w3 * w117 + w5 * w125 + w66 * w141, w25 * w57 + w90 * w117 + w125 * w150 + w66 * w157,
            w32 * w57 + w96 * w117 + w125 * w164 + w66 * w171, w39 * w57 + w102 * w117 + w125 * w178 + w66 * w184,
            w46 * w57 + w108 * w117 + w125 * w191 + w66 * w196, w53 * w57 + w114 * w117 + w125 * w202 + w66 * w206,
            w57 * w60 + w117 * w120 + w125 * w211 + w66 * w214, w222, w125 * w224 + w66 * w226,
            w125 * w129 + w66 * w71,
        ),
        ca.horzcat(  # link9.theta
            w122 * (link1_theta_dot * (w0 * link1_theta_dot)) * c59 + w63 * (w2 * w16) * c59,
            w122 * (w12 * w83) * c59 + w63 * (w12 * w13) * c59, w122 * (w20 * w86) * c59 + w63 * (w20 * w21) * c59,
            w122 * (w27 * w92) * c59 + w63 * (w27 * w28) * c59, w122 * (w34 * w98) * c59 + w63 * (w34 * w35) * c59,
            w122 * (w41 * w104) * c59 + w63 * (w41 * w42) * c59,
            w122 * (w48 * w110) * c59 + w63 * (w48 * w49) * c59,
            w122 * (w55 * w116) * c59 + w63 * (w55 * w56) * c59, w227, w129 * w130 + w71 * w72,
        ),
        ca.horzcat(  # link10.theta
            w18 * w70 + w3 * w128, w25 * w70 + w90 * w128, w32 * w70 + w96 * w128, w39 * w70 + w102 * w128,
            w46 * w70 + w108 * w128, w53 * w70 + w114 * w128, w60 * w70 + w120 * w128, w67 * w70 + w126 * w128,
            w70 * w73 + w128 * w131, -(w70 * gravity_y + (w128 * w132 + w70 * w74)),
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    870 operations.
    """
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
    # intermediate terms (184)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta) * link_length
    w2 = 2 * link1_theta_dot
    w3 = w1 * w2
    w4 = w3 * link10_mass
    w5 = w3 * link9_mass + w4
    w6 = w3 * link8_mass + w5
    w7 = w3 * link7_mass + w6
    w8 = w3 * link6_mass + w7
    w9 = w3 * link5_mass + w8
    w10 = w3 * link4_mass + w9
    w11 = w3 * link3_mass + w10
    w12 = w0 * w2
    w13 = w12 * link10_mass
    w14 = w12 * link9_mass + w13
    w15 = w12 * link8_mass + w14
    w16 = w12 * link7_mass + w15
    w17 = w12 * link6_mass + w16
    w18 = w12 * link5_mass + w17
    w19 = w12 * link4_mass + w18
    w20 = w12 * link3_mass + w19
    w21 = ca.cos(link2_theta)
    w22 = w21 * link_length
    w23 = ca.sin(link2_theta)
    w24 = w23 * c18
    w25 = w21 * c18
    w26 = w23 * link_length
    w27 = ca.cos(link3_theta)
    w28 = w27 * link_length
    w29 = ca.sin(link3_theta)
    w30 = w29 * c19
    w31 = w27 * c19
    w32 = w29 * link_length
    w33 = ca.cos(link4_theta)
    w34 = w33 * link_length
    w35 = ca.sin(link4_theta)
    w36 = w35 * c20
    w37 = w33 * c20
    w38 = w35 * link_length
    w39 = ca.cos(link5_theta)
    w40 = w39 * link_length
    w41 = ca.sin(link5_theta)
    w42 = w41 * c21
    w43 = w39 * c21
    w44 = w41 * link_length
    w45 = ca.cos(link6_theta)
    w46 = w45 * link_length
    w47 = ca.sin(link6_theta)
    w48 = w47 * c22
    w49 = w45 * c22
    w50 = w47 * link_length
    w51 = ca.cos(link7_theta)
    w52 = w51 * link_length
    w53 = ca.sin(link7_theta)
    w54 = w53 * c23
    w55 = w51 * c23
    w56 = w53 * link_length
    w57 = ca.cos(link8_theta)
    w58 = w57 * link_length
    w59 = ca.sin(link8_theta)
    w60 = w59 * c24
    w61 = w57 * c24
    w62 = w59 * link_length
    w63 = ca.cos(link9_theta)
    w64 = w63 * link_length
    w65 = ca.sin(link9_theta)
    w66 = w65 * c25
    w67 = w63 * c25
    w68 = w65 * link_length
    w69 = ca.sin(link10_theta) * c26
    w70 = ca.cos(link10_theta) * c26
    w71 = 2 * link2_theta_dot
    w72 = w26 * w71
    w73 = w72 * link10_mass
    w74 = w72 * link9_mass + w73
    w75 = w72 * link8_mass + w74
    w76 = w72 * link7_mass + w75
    w77 = w72 * link6_mass + w76
    w78 = w72 * link5_mass + w77
    w79 = w72 * link4_mass + w78
    w80 = w72 * link3_mass + w79
    w81 = w22 * w71
    w82 = w81 * link10_mass
    w83 = w81 * link9_mass + w82
    w84 = w81 * link8_mass + w83
    w85 = w81 * link7_mass + w84
    w86 = w81 * link6_mass + w85
    w87 = w81 * link5_mass + w86
    w88 = w81 * link4_mass + w87
    w89 = w81 * link3_mass + w88
    w90 = 2 * link3_theta_dot
    w91 = w32 * w90
    w92 = w91 * link10_mass
    w93 = w91 * link9_mass + w92
    w94 = w91 * link8_mass + w93
    w95 = w91 * link7_mass + w94
    w96 = w91 * link6_mass + w95
    w97 = w91 * link5_mass + w96
    w98 = w91 * link4_mass + w97
    w99 = w30 * w90 + w98
    w100 = w28 * w90
    w101 = w100 * link10_mass
    w102 = w100 * link9_mass + w101
    w103 = w100 * link8_mass + w102
    w104 = w100 * link7_mass + w103
    w105 = w100 * link6_mass + w104
    w106 = w100 * link5_mass + w105
    w107 = w100 * link4_mass + w106
    w108 = w31 * w90 + w107
    w109 = 2 * link4_theta_dot
    w110 = w38 * w109
    w111 = w110 * link10_mass
    w112 = w110 * link9_mass + w111
    w113 = w110 * link8_mass + w112
    w114 = w110 * link7_mass + w113
    w115 = w110 * link6_mass + w114
    w116 = w110 * link5_mass + w115
    w117 = w36 * w109 + w116
    w118 = w34 * w109
    w119 = w118 * link10_mass
    w120 = w118 * link9_mass + w119
    w121 = w118 * link8_mass + w120
    w122 = w118 * link7_mass + w121
    w123 = w118 * link6_mass + w122
    w124 = w118 * link5_mass + w123
    w125 = w37 * w109 + w124
    w126 = 2 * link5_theta_dot
    w127 = w44 * w126
    w128 = w127 * link10_mass
    w129 = w127 * link9_mass + w128
    w130 = w127 * link8_mass + w129
    w131 = w127 * link7_mass + w130
    w132 = w127 * link6_mass + w131
    w133 = w42 * w126 + w132
    w134 = w40 * w126
    w135 = w134 * link10_mass
    w136 = w134 * link9_mass + w135
    w137 = w134 * link8_mass + w136
    w138 = w134 * link7_mass + w137
    w139 = w134 * link6_mass + w138
    w140 = w43 * w126 + w139
    w141 = 2 * link6_theta_dot
    w142 = w50 * w141
    w143 = w142 * link10_mass
    w144 = w142 * link9_mass + w143
    w145 = w142 * link8_mass + w144
    w146 = w142 * link7_mass + w145
    w147 = w48 * w141 + w146
    w148 = w46 * w141
    w149 = w148 * link10_mass
    w150 = w148 * link9_mass + w149
    w151 = w148 * link8_mass + w150
    w152 = w148 * link7_mass + w151
    w153 = w49 * w141 + w152
    w154 = 2 * link7_theta_dot
    w155 = w56 * w154
    w156 = w155 * link10_mass
    w157 = w155 * link9_mass + w156
    w158 = w155 * link8_mass + w157
    w159 = w54 * w154 + w158
    w160 = w52 * w154
    w161 = w160 * link10_mass
    w162 = w160 * link9_mass + w161
    w163 = w160 * link8_mass + w162
    w164 = w55 * w154 + w163
    w165 = 2 * link8_theta_dot
    w166 = w62 * w165
    w167 = w166 * link10_mass
    w168 = w166 * link9_mass + w167
    w169 = w60 * w165 + w168
    w170 = w58 * w165
    w171 = w170 * link10_mass
    w172 = w170 * link9_mass + w171
    w173 = w61 * w165 + w172
    w174 = 2 * link9_theta_dot
    w175 = w68 * w174
    w176 = w175 * link10_mass
    w177 = w66 * w174 + w176
    w178 = w64 * w174
    w179 = w178 * link10_mass
    w180 = w67 * w174 + w179
    w181 = 2 * link10_theta_dot
    w182 = w69 * w181
    w183 = w70 * w181
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * (w3 * link2_mass + w11) - w1 * (w12 * link2_mass + w20),
            w0 * (w24 * w71 + w80) - w1 * (w25 * w71 + w89), w0 * w99 - w1 * w108, w0 * w117 - w1 * w125,
            w0 * w133 - w1 * w140, w0 * w147 - w1 * w153, w0 * w159 - w1 * w164, w0 * w169 - w1 * w173,
            w0 * w177 - w1 * w180, w0 * w182 - w1 * w183,
        ),
        ca.horzcat(  # link2.theta
            w11 * w22 - (w12 * w24 - w3 * w25) - w20 * w26, w22 * w80 - w26 * w89, w22 * w99 - w26 * w108,
            w22 * w117 - w26 * w125, w22 * w133 - w26 * w140, w22 * w147 - w26 * w153, w22 * w159 - w26 * w164,
            w22 * w169 - w26 * w173, w22 * w177 - w26 * w180, w22 * w182 - w26 * w183,
        ),
        ca.horzcat(  # link3.theta
            w10 * w28 - (w12 * w30 - w3 * w31) - w19 * w32, w28 * w79 - (w30 * w81 - w31 * w72) - w32 * w88,
            w28 * w98 - w32 * w107, w28 * w117 - w32 * w125, w28 * w133 - w32 * w140, w28 * w147 - w32 * w153,
            w28 * w159 - w32 * w164, w28 * w169 - w32 * w173, w28 * w177 - w32 * w180, w28 * w182 - w32 * w183,
        ),
        ca.horzcat(  # link4.theta
            w9 * w34 - (w12 * w36 - w3 * w37) - w18 * w38, w34 * w78 - (w36 * w81 - w37 * w72) - w38 * w87,
            w34 * w97 - (w36 * w100 - w37 * w91) - w38 * w106, w34 * w116 - w38 * w124, w34 * w133 - w38 * w140,
            w34 * w147 - w38 * w153, w34 * w159 - w38 * w164, w34 * w169 - w38 * w173, w34 * w177 - w38 * w180,
            w34 * w182 - w38 * w183,
        ),
        ca.horzcat(  # link5.theta
            w8 * w40 - (w12 * w42 - w3 * w43) - w17 * w44, w40 * w77 - (w42 * w81 - w43 * w72) - w44 * w86,
            w40 * w96 - (w42 * w100 - w43 * w91) - w44 * w105, w40 * w115 - (w42 * w118 - w43 * w110) - w44 * w123,
            w40 * w132 - w44 * w139, w40 * w147 - w44 * w153, w40 * w159 - w44 * w164, w40 * w169 - w44 * w173,
            w40 * w177 - w44 * w180, w40 * w182 - w44 * w183,
        ),
        ca.horzcat(  # link6.theta
            w7 * w46 - (w12 * w48 - w3 * w49) - w16 * w50, w46 * w76 - (w48 * w81 - w49 * w72) - w50 * w85,
            w46 * w95 - (w48 * w100 - w49 * w91) - w50 * w104, w46 * w114 - (w48 * w118 - w49 * w110) - w50 * w122,
            w46 * w131 - (w48 * w134 - w49 * w127) - w50 * w138, w46 * w146 - w50 * w152, w46 * w159 - w50 * w164,
            w46 * w169 - w50 * w173, w46 * w177 - w50 * w180, w46 * w182 - w50 * w183,
        ),
        ca.horzcat(  # link7.theta
            w6 * w52 - (w12 * w54 - w3 * w55) - w15 * w56, w52 * w75 - (w54 * w81 - w55 * w72) - w56 * w84,
            w52 * w94 - (w54 * w100 - w55 * w91) - w56 * w103, w52 * w113 - (w54 * w118 - w55 * w110) - w56 * w121,
            w52 * w130 - (w54 * w134 - w55 * w127) - w56 * w137,
            w52 * w145 - (w54 * w148 - w55 * w142) - w56 * w151, w52 * w158 - w56 * w163, w52 * w169 - w56 * w173,
            w52 * w177 - w56 * w180, w52 * w182 - w56 * w183,
        ),
        ca.horzcat(  # link8.theta
            w5 * w58 - (w12 * w60 - w3 * w61) - w14 * w62, w58 * w74 - (w60 * w81 - w61 * w72) - w62 * w83,
            w58 * w93 - (w60 * w100 - w61 * w91) - w62 * w102, w58 * w112 - (w60 * w118 - w61 * w110) - w62 * w120,
            w58 * w129 - (w60 * w134 - w61 * w127) - w62 * w136,
            w58 * w144 - (w60 * w148 - w61 * w142) - w62 * w150,
            w58 * w157 - (w60 * w160 - w61 * w155) - w62 * w162, w58 * w168 - w62 * w172, w58 * w177 - w62 * w180,
            w58 * w182 - w62 * w183,
        ),
        ca.horzcat(  # link9.theta
            w4 * w64 - (w12 * w66 - w3 * w67) - w13 * w68, w64 * w73 - (w66 * w81 - w67 * w72) - w68 * w82,
            w64 * w92 - (w66 * w100 - w67 * w91) - w68 * w101, w64 * w111 - (w66 * w118 - w67 * w110) - w68 * w119,
            w64 * w128 - (w66 * w134 - w67 * w127) - w68 * w135,
            w64 * w143 - (w66 * w148 - w67 * w142) - w68 * w149,
            w64 * w156 - (w66 * w160 - w67 * w155) - w68 * w161,
            w64 * w167 - (w66 * w170 - w67 * w166) - w68 * w171, w64 * w176 - w68 * w179, w64 * w182 - w68 * w183,
        ),
        ca.horzcat(  # link10.theta
            -(w12 * w69 - w3 * w70), -(w69 * w81 - w70 * w72), -(w69 * w100 - w70 * w91),
            -(w69 * w118 - w70 * w110), -(w69 * w134 - w70 * w127), -(w69 * w148 - w70 * w142),
            -(w69 * w160 - w70 * w155), -(w69 * w170 - w70 * w166), -(w69 * w178 - w70 * w175), 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 10 x 10) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 10 x 10) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    1936 operations.
    """
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
    # intermediate terms (429)
    w0 = ca.cos(link1_theta) * link_length
    w1 = ca.sin(link1_theta)
    w2 = w1 * link_length
    w3 = link1_theta_dot**2
    w4 = link1_theta_ddot * w2 + w0 * w3
    w5 = w4 * link2_mass
    w6 = w4 * link10_mass
    w7 = w4 * link9_mass + w6
    w8 = w4 * link8_mass + w7
    w9 = w4 * link7_mass + w8
    w10 = w4 * link6_mass + w9
    w11 = w4 * link5_mass + w10
    w12 = w4 * link4_mass + w11
    w13 = w4 * link3_mass + w12
    w14 = link2_theta_dot**2
    w15 = ca.sin(link2_theta)
    w16 = w15 * c18
    w17 = w14 * w16
    w18 = w0 * link1_theta_ddot - w2 * w3
    w19 = w18 * link2_mass
    w20 = ca.cos(link2_theta)
    w21 = w20 * c18
    w22 = w21 * link2_theta_ddot
    w23 = link3_theta_dot**2
    w24 = ca.sin(link3_theta)
    w25 = w24 * c19
    w26 = w23 * w25
    w27 = w15 * link_length
    w28 = w14 * w27
    w29 = w20 * link_length
    w30 = link2_theta_ddot * w29
    w31 = w18 - w28 + w30
    w32 = ca.cos(link3_theta)
    w33 = w32 * c19
    w34 = w33 * link3_theta_ddot
    w35 = link4_theta_dot**2
    w36 = ca.sin(link4_theta)
    w37 = w36 * c20
    w38 = w35 * w37
    w39 = w24 * link_length
    w40 = w23 * w39
    w41 = w32 * link_length
    w42 = link3_theta_ddot * w41
    w43 = w31 - w40 + w42
    w44 = ca.cos(link4_theta)
    w45 = w44 * c20
    w46 = w45 * link4_theta_ddot
    w47 = link5_theta_dot**2
    w48 = ca.sin(link5_theta)
    w49 = w48 * c21
    w50 = w47 * w49
    w51 = w36 * link_length
    w52 = w35 * w51
    w53 = w44 * link_length
    w54 = link4_theta_ddot * w53
    w55 = w43 - w52 + w54
    w56 = ca.cos(link5_theta)
    w57 = w56 * c21
    w58 = w57 * link5_theta_ddot
    w59 = link6_theta_dot**2
    w60 = ca.sin(link6_theta)
    w61 = w60 * c22
    w62 = w59 * w61
    w63 = w48 * link_length
    w64 = w47 * w63
    w65 = w56 * link_length
    w66 = link5_theta_ddot * w65
    w67 = w55 - w64 + w66
    w68 = ca.cos(link6_theta)
    w69 = w68 * c22
    w70 = w69 * link6_theta_ddot
    w71 = link7_theta_dot**2
    w72 = ca.sin(link7_theta)
    w73 = w72 * c23
    w74 = w71 * w73
    w75 = w60 * link_length
    w76 = w59 * w75
    w77 = w68 * link_length
    w78 = link6_theta_ddot * w77
    w79 = w67 - w76 + w78
    w80 = ca.cos(link7_theta)
    w81 = w80 * c23
    w82 = w81 * link7_theta_ddot
    w83 = link8_theta_dot**2
    w84 = ca.sin(link8_theta)
    w85 = w84 * c24
    w86 = w83 * w85
    w87 = w72 * link_length
    w88 = w71 * w87
    w89 = w80 * link_length
    w90 = link7_theta_ddot * w89
    w91 = w79 - w88 + w90
    w92 = ca.cos(link8_theta)
    w93 = w92 * c24
    w94 = w93 * link8_theta_ddot
    w95 = link9_theta_dot**2
    w96 = ca.sin(link9_theta)
    w97 = w96 * c25
    w98 = w95 * w97
    w99 = w84 * link_length
    w100 = w83 * w99
    w101 = w92 * link_length
    w102 = link8_theta_ddot * w101
    w103 = w91 - w100 + w102
    w104 = ca.cos(link9_theta)
    w105 = w104 * c25
    w106 = w105 * link9_theta_ddot
    w107 = link10_theta_dot**2
    w108 = ca.sin(link10_theta) * c26
    w109 = w107 * w108
    w110 = w96 * link_length
    w111 = w95 * w110
    w112 = w104 * link_length
    w113 = link9_theta_ddot * w112
    w114 = w103 - w111 + w113
    w115 = ca.cos(link10_theta) * c26
    w116 = w115 * link10_theta_ddot
    w117 = c46 + w109 - (w114 * link10_mass + w116)
    w118 = c45 + w98 - (w103 * link9_mass + w106) + w117
    w119 = c44 + w86 - (w91 * link8_mass + w94) + w118
    w120 = c43 + w74 - (w79 * link7_mass + w82) + w119
    w121 = c42 + w62 - (w67 * link6_mass + w70) + w120
    w122 = c41 + w50 - (w55 * link5_mass + w58) + w121
    w123 = c40 + w38 - (w43 * link4_mass + w46) + w122
    w124 = c39 + w26 - (w31 * link3_mass + w34) + w123
    w125 = w18 * link10_mass
    w126 = w18 * link9_mass + w125
    w127 = w18 * link8_mass + w126
    w128 = w18 * link7_mass + w127
    w129 = w18 * link6_mass + w128
    w130 = w18 * link5_mass + w129
    w131 = w18 * link4_mass + w130
    w132 = w18 * link3_mass + w131
    w133 = w14 * w21
    w134 = w16 * link2_theta_ddot
    w135 = w23 * w33
    w136 = w14 * w29
    w137 = link2_theta_ddot * w27
    w138 = w4 + w136 + w137
    w139 = w25 * link3_theta_ddot
    w140 = w35 * w45
    w141 = w23 * w41
    w142 = link3_theta_ddot * w39
    w143 = w138 + w141 + w142
    w144 = w37 * link4_theta_ddot
    w145 = w47 * w57
    w146 = w35 * w53
    w147 = link4_theta_ddot * w51
    w148 = w143 + w146 + w147
    w149 = w49 * link5_theta_ddot
    w150 = w59 * w69
    w151 = w47 * w65
    w152 = link5_theta_ddot * w63
    w153 = w148 + w151 + w152
    w154 = w61 * link6_theta_ddot
    w155 = w71 * w81
    w156 = w59 * w77
    w157 = link6_theta_ddot * w75
    w158 = w153 + w156 + w157
    w159 = w73 * link7_theta_ddot
    w160 = w83 * w93
    w161 = w71 * w89
    w162 = link7_theta_ddot * w87
    w163 = w158 + w161 + w162
    w164 = w85 * link8_theta_ddot
    w165 = w95 * w105
    w166 = w83 * w101
    w167 = link8_theta_ddot * w99
    w168 = w163 + w166 + w167
    w169 = w97 * link9_theta_ddot
    w170 = w107 * w115
    w171 = w95 * w112
    w172 = link9_theta_ddot * w110
    w173 = w168 + w171 + w172
    w174 = w108 * link10_theta_ddot
    w175 = w170 + (w173 * link10_mass + w174)
    w176 = w165 + (w168 * link9_mass + w169) + w175
    w177 = w160 + (w163 * link8_mass + w164) + w176
    w178 = w155 + (w158 * link7_mass + w159) + w177
    w179 = w150 + (w153 * link6_mass + w154) + w178
    w180 = w145 + (w148 * link5_mass + w149) + w179
    w181 = w140 + (w143 * link4_mass + w144) + w180
    w182 = w135 + (w138 * link3_mass + w139) + w181
    w183 = w0 * (w5 + w13) - w2 * (c38 + w17 - (w19 + w22) + w124) - w1 * c37 - (w2 * (w19 + w132) + w0 * (w133 + (w5 + w134) + w182))
    w184 = w16 * w18
    w185 = w4 * w21
    w186 = w136 + w137
    w187 = w186 * link10_mass
    w188 = w186 * link9_mass + w187
    w189 = w186 * link8_mass + w188
    w190 = w186 * link7_mass + w189
    w191 = w186 * link6_mass + w190
    w192 = w186 * link5_mass + w191
    w193 = w186 * link4_mass + w192
    w194 = w186 * link3_mass + w193
    w195 = w30 - w28
    w196 = w195 * link10_mass
    w197 = w195 * link9_mass + w196
    w198 = w195 * link8_mass + w197
    w199 = w195 * link7_mass + w198
    w200 = w195 * link6_mass + w199
    w201 = w195 * link5_mass + w200
    w202 = w195 * link4_mass + w201
    w203 = w195 * link3_mass + w202
    w204 = w141 + w142
    w205 = w204 * link10_mass
    w206 = w204 * link9_mass + w205
    w207 = w204 * link8_mass + w206
    w208 = w204 * link7_mass + w207
    w209 = w204 * link6_mass + w208
    w210 = w204 * link5_mass + w209
    w211 = w204 * link4_mass + w210
    w212 = w135 + w139 + w211
    w213 = w42 - w40
    w214 = w213 * link10_mass
    w215 = w213 * link9_mass + w214
    w216 = w213 * link8_mass + w215
    w217 = w213 * link7_mass + w216
    w218 = w213 * link6_mass + w217
    w219 = w213 * link5_mass + w218
    w220 = w213 * link4_mass + w219
    w221 = w34 - w26 + w220
    w222 = w41 * w211 - w39 * w123 - (w25 * gravity_y + (w33 * w138 - w25 * w31)) - (w39 * w220 + w41 * w181)
    w223 = w146 + w147
    w224 = w223 * link10_mass
    w225 = w223 * link9_mass + w224
    w226 = w223 * link8_mass + w225
    w227 = w223 * link7_mass + w226
    w228 = w223 * link6_mass + w227
    w229 = w223 * link5_mass + w228
    w230 = w140 + w144 + w229
    w231 = w54 - w52
    w232 = w231 * link10_mass
    w233 = w231 * link9_mass + w232
    w234 = w231 * link8_mass + w233
    w235 = w231 * link7_mass + w234
    w236 = w231 * link6_mass + w235
    w237 = w231 * link5_mass + w236
    w238 = w46 - w38 + w237
    w239 = w53 * w229 - w51 * w122 - (w37 * gravity_y + (w45 * w143 - w37 * w43)) - (w51 * w237 + w53 * w180)
    w240 = w151 + w152
    w241 = w240 * link10_mass
    w242 = w240 * link9_mass + w241
    w243 = w240 * link8_mass + w242
    w244 = w240 * link7_mass + w243
    w245 = w240 * link6_mass + w244
    w246 = w145 + w149 + w245
    w247 = w66 - w64
    w248 = w247 * link10_mass
    w249 = w247 * link9_mass + w248
    w250 = w247 * link8_mass + w249
    w251 = w247 * link7_mass + w250
    w252 = w247 * link6_mass + w251
    w253 = w58 - w50 + w252
    w254 = w65 * w245 - w63 * w121 - (w49 * gravity_y + (w57 * w148 - w49 * w55)) - (w63 * w252 + w65 * w179)
    w255 = w156 + w157
    w256 = w255 * link10_mass
    w257 = w255 * link9_mass + w256
    w258 = w255 * link8_mass + w257
    w259 = w255 * link7_mass + w258
    w260 = w150 + w154 + w259
    w261 = w78 - w76
    w262 = w261 * link10_mass
    w263 = w261 * link9_mass + w262
    w264 = w261 * link8_mass + w263
    w265 = w261 * link7_mass + w264
    w266 = w70 - w62 + w265
    w267 = w77 * w259 - w75 * w120 - (w61 * gravity_y + (w69 * w153 - w61 * w67)) - (w75 * w265 + w77 * w178)
    w268 = w161 + w162
    w269 = w268 * link10_mass
    w270 = w268 * link9_mass + w269
    w271 = w268 * link8_mass + w270
    w272 = w155 + w159 + w271
    w273 = w90 - w88
    w274 = w273 * link10_mass
    w275 = w273 * link9_mass + w274
    w276 = w273 * link8_mass + w275
    w277 = w82 - w74 + w276
    w278 = w89 * w271 - w87 * w119 - (w73 * gravity_y + (w81 * w158 - w73 * w79)) - (w87 * w276 + w89 * w177)
    w279 = w166 + w167
    w280 = w279 * link10_mass
    w281 = w279 * link9_mass + w280
    w282 = w160 + w164 + w281
    w283 = w102 - w100
    w284 = w283 * link10_mass
    w285 = w283 * link9_mass + w284
    w286 = w94 - w86 + w285
    w287 = w101 * w281 - w99 * w118 - (w85 * gravity_y + (w93 * w163 - w85 * w91)) - (w99 * w285 + w101 * w176)
    w288 = w171 + w172
    w289 = w288 * link10_mass
    w290 = w165 + w169 + w289
    w291 = w113 - w111
    w292 = w291 * link10_mass
    w293 = w106 - w98 + w292
    w294 = w112 * w289 - w110 * w117 - (w97 * gravity_y + (w105 * w168 - w97 * w103)) - (w110 * w292 + w112 * w175)
    w295 = w170 + w174
    w296 = w116 - w109
    w297 = 2 * link1_theta_dot
    w298 = w2 * w297
    w299 = w298 * link10_mass
    w300 = w298 * link9_mass + w299
    w301 = w298 * link8_mass + w300
    w302 = w298 * link7_mass + w301
    w303 = w298 * link6_mass + w302
    w304 = w298 * link5_mass + w303
    w305 = w298 * link4_mass + w304
    w306 = w298 * link3_mass + w305
    w307 = w0 * w297
    w308 = w307 * link10_mass
    w309 = w307 * link9_mass + w308
    w310 = w307 * link8_mass + w309
    w311 = w307 * link7_mass + w310
    w312 = w307 * link6_mass + w311
    w313 = w307 * link5_mass + w312
    w314 = w307 * link4_mass + w313
    w315 = w307 * link3_mass + w314
    w316 = 2 * link2_theta_dot
    w317 = w27 * w316
    w318 = w317 * link10_mass
    w319 = w317 * link9_mass + w318
    w320 = w317 * link8_mass + w319
    w321 = w317 * link7_mass + w320
    w322 = w317 * link6_mass + w321
    w323 = w317 * link5_mass + w322
    w324 = w317 * link4_mass + w323
    w325 = w317 * link3_mass + w324
    w326 = w29 * w316
    w327 = w326 * link10_mass
    w328 = w326 * link9_mass + w327
    w329 = w326 * link8_mass + w328
    w330 = w326 * link7_mass + w329
    w331 = w326 * link6_mass + w330
    w332 = w326 * link5_mass + w331
    w333 = w326 * link4_mass + w332
    w334 = w326 * link3_mass + w333
    w335 = 2 * link3_theta_dot
    w336 = w39 * w335
    w337 = w336 * link10_mass
    w338 = w336 * link9_mass + w337
    w339 = w336 * link8_mass + w338
    w340 = w336 * link7_mass + w339
    w341 = w336 * link6_mass + w340
    w342 = w336 * link5_mass + w341
    w343 = w336 * link4_mass + w342
    w344 = w25 * w335 + w343
    w345 = w41 * w335
    w346 = w345 * link10_mass
    w347 = w345 * link9_mass + w346
    w348 = w345 * link8_mass + w347
    w349 = w345 * link7_mass + w348
    w350 = w345 * link6_mass + w349
    w351 = w345 * link5_mass + w350
    w352 = w345 * link4_mass + w351
    w353 = w33 * w335 + w352
    w354 = 2 * link4_theta_dot
    w355 = w51 * w354
    w356 = w355 * link10_mass
    w357 = w355 * link9_mass + w356
    w358 = w355 * link8_mass + w357
    w359 = w355 * link7_mass + w358
    w360 = w355 * link6_mass + w359
    w361 = w355 * link5_mass + w360
    w362 = w37 * w354 + w361
    w363 = w53 * w354
    w364 = w363 * link10_mass
    w365 = w363 * link9_mass + w364
    w366 = w363 * link8_mass + w365
    w367 = w363 * link7_mass + w366
    w368 = w363 * link6_mass + w367
    w369 = w363 * link5_mass + w368
    w370 = w45 * w354 + w369
    w371 = 2 * link5_theta_dot
    w372 = w63 * w371
    w373 = w372 * link10_mass
    w374 = w372 * link9_mass + w373
    w375 = w372 * link8_mass + w374
    w376 = w372 * link7_mass + w375
    w377 = w372 * link6_mass + w376
    w378 = w49 * w371 + w377
    w379 = w65 * w371
    w380 = w379 * link10_mass
    w381 = w379 * link9_mass + w380
    w382 = w379 * link8_mass + w381
    w383 = w379 * link7_mass + w382
    w384 = w379 * link6_mass + w383
    w385 = w57 * w371 + w384
    w386 = 2 * link6_theta_dot
    w387 = w75 * w386
    w388 = w387 * link10_mass
    w389 = w387 * link9_mass + w388
    w390 = w387 * link8_mass + w389
    w391 = w387 * link7_mass + w390
    w392 = w61 * w386 + w391
    w393 = w77 * w386
    w394 = w393 * link10_mass
    w395 = w393 * link9_mass + w394
    w396 = w393 * link8_mass + w395
    w397 = w393 * link7_mass + w396
    w398 = w69 * w386 + w397
    w399 = 2 * link7_theta_dot
    w400 = w87 * w399
    w401 = w400 * link10_mass
    w402 = w400 * link9_mass + w401
    w403 = w400 * link8_mass + w402
    w404 = w73 * w399 + w403
    w405 = w89 * w399
    w406 = w405 * link10_mass
    w407 = w405 * link9_mass + w406
    w408 = w405 * link8_mass + w407
    w409 = w81 * w399 + w408
    w410 = 2 * link8_theta_dot
    w411 = w99 * w410
    w412 = w411 * link10_mass
    w413 = w411 * link9_mass + w412
    w414 = w85 * w410 + w413
    w415 = w101 * w410
    w416 = w415 * link10_mass
    w417 = w415 * link9_mass + w416
    w418 = w93 * w410 + w417
    w419 = 2 * link9_theta_dot
    w420 = w110 * w419
    w421 = w420 * link10_mass
    w422 = w97 * w419 + w421
    w423 = w112 * w419
    w424 = w423 * link10_mass
    w425 = w105 * w419 + w424
    w426 = 2 * link10_theta_dot
    w427 = w108 * w426
    w428 = w115 * w426
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta
            w183, w0 * (w133 + w134 + w194) - w2 * (w22 - w17 + w203), w0 * w212 - w2 * w221, w0 * w230 - w2 * w238,
            w0 * w246 - w2 * w253, w0 * w260 - w2 * w266, w0 * w272 - w2 * w277, w0 * w282 - w2 * w286,
            w0 * w290 - w2 * w293, w0 * w295 - w2 * w296,
        ),
        ca.horzcat(  # link2.theta
            w13 * w29 - (w184 - w185) - w27 * w132,
            w29 * w194 - w27 * w124 - (w16 * gravity_y + (w185 - w184)) - (w27 * w203 + w29 * w182),
            w29 * w212 - w27 * w221, w29 * w230 - w27 * w238, w29 * w246 - w27 * w253, w29 * w260 - w27 * w266,
            w29 * w272 - w27 * w277, w29 * w282 - w27 * w286, w29 * w290 - w27 * w293, w29 * w295 - w27 * w296,
        ),
        ca.horzcat(  # link3.theta
            w12 * w41 - (w18 * w25 - w4 * w33) - w39 * w131, w41 * w193 - (w25 * w195 - w33 * w186) - w39 * w202,
            w222, w41 * w230 - w39 * w238, w41 * w246 - w39 * w253, w41 * w260 - w39 * w266,
            w41 * w272 - w39 * w277, w41 * w282 - w39 * w286, w41 * w290 - w39 * w293, w41 * w295 - w39 * w296,
        ),
        ca.horzcat(  # link4.theta
            w11 * w53 - (w18 * w37 - w4 * w45) - w51 * w130, w53 * w192 - (w37 * w195 - w45 * w186) - w51 * w201,
            w53 * w210 - (w37 * w213 - w45 * w204) - w51 * w219, w239, w53 * w246 - w51 * w253,
            w53 * w260 - w51 * w266, w53 * w272 - w51 * w277, w53 * w282 - w51 * w286, w53 * w290 - w51 * w293,
            w53 * w295 - w51 * w296,
        ),
        ca.horzcat(  # link5.theta
            w10 * w65 - (w18 * w49 - w4 * w57) - w63 * w129, w65 * w191 - (w49 * w195 - w57 * w186) - w63 * w200,
            w65 * w209 - (w49 * w213 - w57 * w204) - w63 * w218,
            w65 * w228 - (w49 * w231 - w57 * w223) - w63 * w236, w254, w65 * w260 - w63 * w266,
            w65 * w272 - w63 * w277, w65 * w282 - w63 * w286, w65 * w290 - w63 * w293, w65 * w295 - w63 * w296,
        ),
        ca.horzcat(  # link6.theta
            w9 * w77 - (w18 * w61 - w4 * w69) - w75 * w128, w77 * w190 - (w61 * w195 - w69 * w186) - w75 * w199,
            w77 * w208 - (w61 * w213 - w69 * w204) - w75 * w217,
            w77 * w227 - (w61 * w231 - w69 * w223) - w75 * w235,
            w77 * w244 - (w61 * w247 - w69 * w240) - w75 * w251, w267, w77 * w272 - w75 * w277,
            w77 * w282 - w75 * w286, w77 * w290 - w75 * w293, w77 * w295 - w75 * w296,
        ),
        ca.horzcat(  # link7.theta
            w8 * w89 - (w18 * w73 - w4 * w81) - w87 * w127, w89 * w189 - (w73 * w195 - w81 * w186) - w87 * w198,
            w89 * w207 - (w73 * w213 - w81 * w204) - w87 * w216,
            w89 * w226 - (w73 * w231 - w81 * w223) - w87 * w234,
            w89 * w243 - (w73 * w247 - w81 * w240) - w87 * w250,
            w89 * w258 - (w73 * w261 - w81 * w255) - w87 * w264, w278, w89 * w282 - w87 * w286,
            w89 * w290 - w87 * w293, w89 * w295 - w87 * w296,
        ),
        ca.horzcat(  # link8.theta
            w7 * w101 - (w18 * w85 - w4 * w93) - w99 * w126, w101 * w188 - (w85 * w195 - w93 * w186) - w99 * w197,
            w101 * w206 - (w85 * w213 - w93 * w204) - w99 * w215,
            w101 * w225 - (w85 * w231 - w93 * w223) - w99 * w233,
            w101 * w242 - (w85 * w247 - w93 * w240) - w99 * w249,
            w101 * w257 - (w85 * w261 - w93 * w255) - w99 * w263,
            w101 * w270 - (w85 * w273 - w93 * w268) - w99 * w275, w287, w101 * w290 - w99 * w293,
            w101 * w295 - w99 * w296,
        ),
        ca.horzcat(  # link9.theta
            w6 * w112 - (w18 * w97 - w4 * w105) - w110 * w125,
            w112 * w187 - (w97 * w195 - w105 * w186) - w110 * w196,
            w112 * w205 - (w97 * w213 - w105 * w204) - w110 * w214,
            w112 * w224 - (w97 * w231 - w105 * w223) - w110 * w232,
            w112 * w241 - (w97 * w247 - w105 * w240) - w110 * w248,
            w112 * w256 - (w97 * w261 - w105 * w255) - w110 * w262,
            w112 * w269 - (w97 * w273 - w105 * w268) - w110 * w274,
            w112 * w280 - (w97 * w283 - w105 * w279) - w110 * w284, w294, w112 * w295 - w110 * w296,
        ),
        ca.horzcat(  # link10.theta
            -(w18 * w108 - w4 * w115), -(w108 * w195 - w115 * w186), -(w108 * w213 - w115 * w204),
            -(w108 * w231 - w115 * w223), -(w108 * w247 - w115 * w240), -(w108 * w261 - w115 * w255),
            -(w108 * w273 - w115 * w268), -(w108 * w283 - w115 * w279), -(w108 * w291 - w115 * w288),
            -(w108 * gravity_y + (w115 * w173 - w108 * w114)),
        ),
    )
    J_v = ca.vertcat(
        ca.horzcat(  # link1.theta
            w0 * (w298 * link2_mass + w306) - w2 * (w307 * link2_mass + w315),
            w0 * (w16 * w316 + w325) - w2 * (w21 * w316 + w334), w0 * w344 - w2 * w353, w0 * w362 - w2 * w370,
            w0 * w378 - w2 * w385, w0 * w392 - w2 * w398, w0 * w404 - w2 * w409, w0 * w414 - w2 * w418,
            w0 * w422 - w2 * w425, w0 * w427 - w2 * w428,
        ),
        ca.horzcat(  # link2.theta
            w29 * w306 - (w16 * w307 - w21 * w298) - w27 * w315, w29 * w325 - w27 * w334, w29 * w344 - w27 * w353,
            w29 * w362 - w27 * w370, w29 * w378 - w27 * w385, w29 * w392 - w27 * w398, w29 * w404 - w27 * w409,
            w29 * w414 - w27 * w418, w29 * w422 - w27 * w425, w29 * w427 - w27 * w428,
        ),
        ca.horzcat(  # link3.theta
            w41 * w305 - (w25 * w307 - w33 * w298) - w39 * w314,
            w41 * w324 - (w25 * w326 - w33 * w317) - w39 * w333, w41 * w343 - w39 * w352, w41 * w362 - w39 * w370,
            w41 * w378 - w39 * w385, w41 * w392 - w39 * w398, w41 * w404 - w39 * w409, w41 * w414 - w39 * w418,
            w41 * w422 - w39 * w425, w41 * w427 - w39 * w428,
        ),
        ca.horzcat(  # link4.theta
            w53 * w304 - (w37 * w307 - w45 * w298) - w51 * w313,
            w53 * w323 - (w37 * w326 - w45 * w317) - w51 * w332,
            w53 * w342 - (w37 * w345 - w45 * w336) - w51 * w351, w53 * w361 - w51 * w369, w53 * w378 - w51 * w385,
            w53 * w392 - w51 * w398, w53 * w404 - w51 * w409, w53 * w414 - w51 * w418, w53 * w422 - w51 * w425,
            w53 * w427 - w51 * w428,
        ),
        ca.horzcat(  # link5.theta
            w65 * w303 - (w49 * w307 - w57 * w298) - w63 * w312,
            w65 * w322 - (w49 * w326 - w57 * w317) - w63 * w331,
            w65 * w341 - (w49 * w345 - w57 * w336) - w63 * w350,
            w65 * w360 - (w49 * w363 - w57 * w355) - w63 * w368, w65 * w377 - w63 * w384, w65 * w392 - w63 * w398,
            w65 * w404 - w63 * w409, w65 * w414 - w63 * w418, w65 * w422 - w63 * w425, w65 * w427 - w63 * w428,
        ),
        ca.horzcat(  # link6.theta
            w77 * w302 - (w61 * w307 - w69 * w298) - w75 * w311,
            w77 * w321 - (w61 * w326 - w69 * w317) - w75 * w330,
            w77 * w340 - (w61 * w345 - w69 * w336) - w75 * w349,
            w77 * w359 - (w61 * w363 - w69 * w355) - w75 * w367,
            w77 * w376 - (w61 * w379 - w69 * w372) - w75 * w383, w77 * w391 - w75 * w397, w77 * w404 - w75 * w409,
            w77 * w414 - w75 * w418, w77 * w422 - w75 * w425, w77 * w427 - w75 * w428,
        ),
        ca.horzcat(  # link7.theta
            w89 * w301 - (w73 * w307 - w81 * w298) - w87 * w310,
            w89 * w320 - (w73 * w326 - w81 * w317) - w87 * w329,
            w89 * w339 - (w73 * w345 - w81 * w336) - w87 * w348,
            w89 * w358 - (w73 * w363 - w81 * w355) - w87 * w366,
            w89 * w375 - (w73 * w379 - w81 * w372) - w87 * w382,
            w89 * w390 - (w73 * w393 - w81 * w387) - w87 * w396, w89 * w403 - w87 * w408, w89 * w414 - w87 * w418,
            w89 * w422 - w87 * w425, w89 * w427 - w87 * w428,
        ),
        ca.horzcat(  # link8.theta
            w101 * w300 - (w85 * w307 - w93 * w298) - w99 * w309,
            w101 * w319 - (w85 * w326 - w93 * w317) - w99 * w328,
            w101 * w338 - (w85 * w345 - w93 * w336) - w99 * w347,
            w101 * w357 - (w85 * w363 - w93 * w355) - w99 * w365,
            w101 * w374 - (w85 * w379 - w93 * w372) - w99 * w381,
            w101 * w389 - (w85 * w393 - w93 * w387) - w99 * w395,
            w101 * w402 - (w85 * w405 - w93 * w400) - w99 * w407, w101 * w413 - w99 * w417,
            w101 * w422 - w99 * w425, w101 * w427 - w99 * w428,
        ),
        ca.horzcat(  # link9.theta
            w112 * w299 - (w97 * w307 - w105 * w298) - w110 * w308,
            w112 * w318 - (w97 * w326 - w105 * w317) - w110 * w327,
            w112 * w337 - (w97 * w345 - w105 * w336) - w110 * w346,
            w112 * w356 - (w97 * w363 - w105 * w355) - w110 * w364,
            w112 * w373 - (w97 * w379 - w105 * w372) - w110 * w380,
            w112 * w388 - (w97 * w393 - w105 * w387) - w110 * w394,
            w112 * w401 - (w97 * w405 - w105 * w400) - w110 * w406,
            w112 * w412 - (w97 * w415 - w105 * w411) - w110 * w416, w112 * w421 - w110 * w424,
            w112 * w427 - w110 * w428,
        ),
        ca.horzcat(  # link10.theta
            -(w108 * w307 - w115 * w298), -(w108 * w326 - w115 * w317), -(w108 * w345 - w115 * w336),
            -(w108 * w363 - w115 * w355), -(w108 * w379 - w115 * w372), -(w108 * w393 - w115 * w387),
            -(w108 * w405 - w115 * w400), -(w108 * w415 - w115 * w411), -(w108 * w423 - w115 * w420), 0.0,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 10) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 10) [mixed]: rates of the independent coordinates
    takes c (n_const = 60) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 10) [mixed]: accelerations of the independent coordinates
    674 operations.
    """
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
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
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
    w46 = c56 + w38 * w41 - (w32 * w45 + w32 * w43)
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
    w66 = c55 + w58 * w61 - (w51 * w65 + w51 * w63)
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
    w86 = c54 + w78 * w81 - (w71 * w85 + w71 * w83)
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
    w106 = c53 + w98 * w101 - (w91 * w105 + w91 * w103)
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
    w126 = c52 + w118 * w121 - (w111 * w125 + w111 * w123)
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
    w146 = c51 + w138 * w141 - (w131 * w145 + w131 * w143)
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
    w166 = c50 + w158 * w161 - (w151 * w165 + w151 * w163)
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
    w186 = c49 + w178 * w181 - (w171 * w185 + w171 * w183)
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
