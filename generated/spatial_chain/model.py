"""Chain of 3 links in space: equations of motion, emitted by symgen from the scene `spatial_chain`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 link1.theta1 [rad], 1 link1.theta2 [rad], 2 link1.theta3 [rad], 3 link2.theta1 [rad],
    4 link2.theta2 [rad], 5 link2.theta3 [rad], 6 link3.theta1 [rad], 7 link3.theta2 [rad],
    8 link3.theta3 [rad]

q_d, the dependent coordinates by index:
    0 link1.x [m], 1 link1.y [m], 2 link1.z [m], 3 link2.x [m], 4 link2.y [m], 5 link2.z [m], 6 link3.x [m],
    7 link3.y [m], 8 link3.z [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 19) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    138 operations.
    """
    p = ca.SX.sym("p", 19)
    gravity_z = p[0]
    link1_mass = p[1]
    link1_center_of_mass_x = p[2]
    link1_inertia_xx = p[3]
    link1_inertia_yy = p[4]
    link1_inertia_zz = p[5]
    link2_mass = p[6]
    link2_center_of_mass_x = p[7]
    link2_inertia_xx = p[8]
    link2_inertia_yy = p[9]
    link2_inertia_zz = p[10]
    link3_mass = p[11]
    link3_center_of_mass_x = p[12]
    link3_inertia_xx = p[13]
    link3_inertia_yy = p[14]
    link3_inertia_zz = p[15]
    link1_end_x = p[16]
    link2_end_x = p[17]
    # intermediate terms (21)
    w0 = (link1_inertia_xx + link1_inertia_yy + link1_inertia_zz) / 2.0
    w1 = w0 - link1_inertia_yy
    w2 = w0 - link1_inertia_zz
    w3 = w1 + w2
    w4 = w0 - link1_inertia_xx + link1_mass * link1_center_of_mass_x**2
    w5 = link2_mass + link3_mass
    w6 = link2_mass * link2_center_of_mass_x
    w7 = link3_mass * link3_center_of_mass_x
    w8 = (link2_inertia_xx + link2_inertia_yy + link2_inertia_zz) / 2.0
    w9 = w8 - link2_inertia_yy
    w10 = w8 - link2_inertia_zz
    w11 = w9 + w10
    w12 = w8 - link2_inertia_xx + link2_mass * link2_center_of_mass_x**2
    w13 = link3_mass * link2_end_x
    w14 = (link3_inertia_xx + link3_inertia_yy + link3_inertia_zz) / 2.0
    w15 = w14 - link3_inertia_yy
    w16 = w14 - link3_inertia_zz
    w17 = w15 + w16
    w18 = w14 - link3_inertia_xx + link3_mass * link3_center_of_mass_x**2
    w19 = link1_mass * link1_center_of_mass_x
    w20 = w6 + w13
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w3,  # c2
        w4,  # c3
        w2 + w4,  # c4
        w1 + w4,  # c5
        link1_end_x,  # link1_end_x
        link2_mass,  # link2_mass
        link3_mass,  # link3_mass
        w5,  # c9
        link1_end_x * (link1_end_x * w5),  # c10
        w6,  # c11
        link2_end_x,  # link2_end_x
        w7,  # c13
        w9,  # c14
        w10,  # c15
        w11,  # c16
        w12,  # c17
        w10 + w12,  # c18
        w9 + w12,  # c19
        link2_end_x * w13,  # c20
        w15,  # c21
        w16,  # c22
        w17,  # c23
        w18,  # c24
        w16 + w18,  # c25
        w15 + w18,  # c26
        gravity_z,  # gravity_z
        gravity_z * w19,  # c28
        -link2_end_x,  # c29
        link1_mass,  # link1_mass
        w19,  # c31
        -w3,  # c32
        -w11,  # c33
        -w17,  # c34
        link1_mass * gravity_z,  # c35
        link2_mass * gravity_z,  # c36
        link3_mass * gravity_z,  # c37
        -w19,  # c38
        -w6,  # c39
        -w7,  # c40
        -gravity_z,  # c41
        2.0,  # c42
        2 * link1_end_x,  # c43
        w20,  # c44
        w1 - w2,  # c45
        2 * link2_end_x,  # c46
        w9 - w10,  # c47
        w15 - w16,  # c48
        -w1,  # c49
        -w9,  # c50
        -w15,  # c51
        -w20,  # c52
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 9 x 9) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 9) [N, N m]: condensed force S^T (Q* - M s)
    721 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link3_theta1_dot = q_i_dot[6]
    link3_theta2_dot = q_i_dot[7]
    link3_theta3_dot = q_i_dot[8]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    link2_end_x = c[12]
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
    gravity_z = c[27]
    c28 = c[28]
    # intermediate terms (184)
    w0 = ca.sin(link1_theta2)
    w1 = w0 * c2
    w2 = ca.cos(link1_theta2)
    w3 = ca.sin(link1_theta3)
    w4 = w2 * w3
    w5 = w4 * c4
    w6 = ca.cos(link1_theta3)
    w7 = w2 * w6
    w8 = w7 * c5
    w9 = ca.cos(link1_theta1)
    w10 = w2 * w9
    w11 = w10 * link1_end_x
    w12 = ca.sin(link1_theta1)
    w13 = w2 * w12
    w14 = w13 * link1_end_x
    w15 = w0 * link1_end_x
    w16 = w12 * w15
    w17 = w9 * w15
    w18 = w5 * w6 - w3 * w8 - w11 * (w16 * c9) + w14 * (w17 * c9)
    w19 = -w1
    w20 = ca.cos(link2_theta1)
    w21 = ca.cos(link2_theta2)
    w22 = w20 * w21
    w23 = w22 * c11
    w24 = w22 * link2_end_x
    w25 = w23 + w24 * link3_mass
    w26 = ca.sin(link2_theta1)
    w27 = w21 * w26
    w28 = w27 * c11
    w29 = w27 * link2_end_x
    w30 = w28 + w29 * link3_mass
    w31 = w11 * w25 + w14 * w30
    w32 = ca.sin(link2_theta2)
    w33 = w32 * c11
    w34 = w20 * w33
    w35 = w32 * link2_end_x
    w36 = w20 * w35
    w37 = w36 * link3_mass
    w38 = w34 + w37
    w39 = w26 * w33
    w40 = w26 * w35
    w41 = w40 * link3_mass
    w42 = w39 + w41
    w43 = w14 * w38 - w11 * w42
    w44 = ca.cos(link3_theta1)
    w45 = ca.cos(link3_theta2)
    w46 = w44 * w45
    w47 = w46 * c13
    w48 = ca.sin(link3_theta1)
    w49 = w45 * w48
    w50 = w49 * c13
    w51 = w11 * w47 + w14 * w50
    w52 = ca.sin(link3_theta2)
    w53 = w52 * c13
    w54 = w44 * w53
    w55 = w48 * w53
    w56 = w14 * w54 - w11 * w55
    w57 = w2 * link1_end_x
    w58 = w17 * w30 - w16 * w25
    w59 = w21 * c11
    w60 = w21 * link2_end_x
    w61 = w57 * (w59 + w60 * link3_mass) + w16 * w42 + w17 * w38
    w62 = w17 * w50 - w16 * w47
    w63 = w45 * c13
    w64 = w57 * w63 + w16 * w55 + w17 * w54
    w65 = w32 * c16
    w66 = ca.sin(link2_theta3)
    w67 = w21 * w66
    w68 = w67 * c18
    w69 = ca.cos(link2_theta3)
    w70 = w21 * w69
    w71 = w70 * c19
    w72 = w68 * w69 - w66 * w71 - w24 * w41 + w29 * w37
    w73 = -w65
    w74 = w24 * w47 + w29 * w50
    w75 = w29 * w54 - w24 * w55
    w76 = w36 * w50 - w40 * w47
    w77 = w60 * w63 + w40 * w55 + w36 * w54
    w78 = w52 * c23
    w79 = ca.sin(link3_theta3)
    w80 = w45 * w79
    w81 = w80 * c25
    w82 = ca.cos(link3_theta3)
    w83 = w45 * w82
    w84 = w83 * c26
    w85 = w81 * w82 - w79 * w84
    w86 = -w78
    w87 = w26 * w69
    w88 = w66 * (w20 * w32) - w87
    w89 = link2_theta3_dot - w32 * link2_theta1_dot
    w90 = w69 * link2_theta2_dot
    w91 = w67 * link2_theta1_dot + w90
    w92 = w89 * w91
    w93 = w21 * link2_theta3_dot
    w94 = link2_theta3_dot * link2_theta2_dot
    w95 = link2_theta1_dot * (w66 * w93 + w32 * w90) + w69 * w94
    w96 = w92 - w95
    w97 = w96 * c11
    w98 = w70 * link2_theta1_dot - w66 * link2_theta2_dot
    w99 = (w91**2 + w98**2) * c11
    w100 = w20 * w69
    w101 = w26 * w66 + w32 * w100
    w102 = w89 * w98
    w103 = link2_theta1_dot * (w69 * w93 - w66 * (w32 * link2_theta2_dot)) - w66 * w94
    w104 = w102 - w103
    w105 = w104 * c11
    w106 = w9 * link1_theta2_dot + w13 * link1_theta3_dot
    w107 = w10 * link1_theta3_dot - w12 * link1_theta2_dot
    w108 = w14 * w107 - w11 * w106
    w109 = link1_theta1_dot - w0 * link1_theta3_dot
    w110 = w11 * w109 + w15 * w107
    w111 = w6 * w9
    w112 = w2 * link1_theta3_dot
    w113 = link1_theta2_dot * link1_theta3_dot
    w114 = link1_theta1_dot * (w6 * w112 - w3 * (w0 * link1_theta2_dot)) - w3 * w113
    w115 = w2 * (link1_theta2_dot * link1_theta1_dot)
    w116 = w6 * w12
    w117 = w6 * link1_theta2_dot
    w118 = link1_theta1_dot * (w3 * w112 + w0 * w117) + w6 * w113
    w119 = (w111 + w3 * (w0 * w12)) * w114 - w13 * w115 - (w0 * w116 - w3 * w9) * w118
    w120 = w0 * w115 + w4 * w114 - w7 * w118
    w121 = w106 * w108 - w109 * w110 - (w15 * w119 + w14 * w120)
    w122 = w48 * w82
    w123 = link3_theta3_dot - w52 * link3_theta1_dot
    w124 = w82 * link3_theta2_dot
    w125 = w80 * link3_theta1_dot + w124
    w126 = w123 * w125
    w127 = w45 * link3_theta3_dot
    w128 = link3_theta3_dot * link3_theta2_dot
    w129 = link3_theta1_dot * (w79 * w127 + w52 * w124) + w82 * w128
    w130 = w126 - w129
    w131 = w130 * c13
    w132 = w83 * link3_theta1_dot - w79 * link3_theta2_dot
    w133 = (w125**2 + w132**2) * c13
    w134 = w44 * w82
    w135 = w123 * w132
    w136 = link3_theta1_dot * (w82 * w127 - w79 * (w52 * link3_theta2_dot)) - w79 * w128
    w137 = w135 - w136
    w138 = w137 * c13
    w139 = w20 * link2_theta2_dot + w27 * link2_theta3_dot
    w140 = w22 * link2_theta3_dot - w26 * link2_theta2_dot
    w141 = w29 * w140 - w24 * w139
    w142 = link2_theta1_dot - w32 * link2_theta3_dot
    w143 = w24 * w142 + w35 * w140
    w144 = w100 + w66 * (w26 * w32)
    w145 = w21 * (link2_theta1_dot * link2_theta2_dot)
    w146 = w32 * w87 - w20 * w66
    w147 = w103 * w144 - w27 * w145 - w95 * w146
    w148 = w32 * w145 + w67 * w103 - w70 * w95
    w149 = w121 + (w139 * w141 - w142 * w143 - (w35 * w147 + w29 * w148))
    w150 = (w79 * (w44 * w52) - w122) * w131 - w46 * w133 + (w48 * w79 + w52 * w134) * w138 + w149 * link3_mass
    w151 = w88 * w97 - w22 * w99 + w101 * w105 + w121 * link2_mass + w150
    w152 = link1_theta3_dot - w0 * link1_theta1_dot
    w153 = w7 * link1_theta1_dot - w3 * link1_theta2_dot
    w154 = w152 * w153
    w155 = (w114 + w154) * c1 - (w154 - w114) * c3
    w156 = w117 + w4 * link1_theta1_dot
    w157 = w153 * w156
    w158 = (w157 - w115) * c0 - (w115 + w157) * c1
    w159 = w152 * w156
    w160 = (w159 - w118) * c3 - (w118 + w159) * c0
    w161 = w114 * (w3 * (w0 * w9) - w116) - w10 * w115 - w118 * (w3 * w12 + w0 * w111)
    w162 = w15 * w106 + w14 * w109
    w163 = w11 * w120 + w15 * w161 - (w109 * w162 + w107 * w108)
    w164 = w88 * w103 - w22 * w145 - w95 * w101
    w165 = w35 * w139 + w29 * w142
    w166 = w163 + (w24 * w148 + w35 * w164 - (w142 * w165 + w140 * w141))
    w167 = w131 * (w134 + w79 * (w48 * w52)) - w49 * w133 + w138 * (w52 * w122 - w44 * w79) + w166 * link3_mass
    w168 = w97 * w144 - w27 * w99 + w105 * w146 + w163 * link2_mass + w167
    w169 = w14 * w161 - w11 * w119 + (w107 * w110 + w106 * w162)
    w170 = w169 - gravity_z
    w171 = w169 + (w29 * w164 - w24 * w147 + (w140 * w143 + w139 * w165)) - gravity_z
    w172 = w52 * w133 + w80 * w131 + w83 * w138 + w171 * link3_mass
    w173 = w57 * (w32 * w99 + w67 * w97 + w70 * w105 + w170 * link2_mass + w172) - (w6 * w155 - w3 * w160 + w2 * c28)
    w174 = (w102 + w103) * c15 - w104 * c17
    w175 = w91 * w98
    w176 = (w175 - w145) * c14 - (w145 + w175) * c15
    w177 = w96 * c17 - (w92 + w95) * c14
    w178 = w60 * w172 - (w69 * w174 - w66 * w177 - (w34 * w121 + w39 * w163 + w59 * w170)) + w40 * w167 + w36 * w150
    w179 = (w135 + w136) * c22 - w137 * c24
    w180 = w125 * w132
    w181 = w45 * (link3_theta1_dot * link3_theta2_dot)
    w182 = (w180 - w181) * c21 - (w180 + w181) * c22
    w183 = w130 * c24 - (w126 + w129) * c21
    # outputs
    M_hat = ca.SX(9, 9)
    # link1.theta1
    M_hat[0, 0] = w7 * w8 + (w4 * w5 + (w0 * w1 + w2**2 * c10))
    M_hat[0, 1] = w18
    M_hat[0, 2] = w19
    M_hat[0, 3] = w31
    M_hat[0, 4] = w43
    M_hat[0, 6] = w51
    M_hat[0, 7] = w56
    # link1.theta2
    M_hat[1, 0] = w18
    M_hat[1, 1] = w3 * (w3 * c5) + (c10 + w6 * (w6 * c4))
    M_hat[1, 3] = w58
    M_hat[1, 4] = w61
    M_hat[1, 6] = w62
    M_hat[1, 7] = w64
    # link1.theta3
    M_hat[2, 0] = w19
    M_hat[2, 2] = c2
    # link2.theta1
    M_hat[3, 0] = w31
    M_hat[3, 1] = w58
    M_hat[3, 3] = w70 * w71 + (w67 * w68 + (w32 * w65 + w21**2 * c20))
    M_hat[3, 4] = w72
    M_hat[3, 5] = w73
    M_hat[3, 6] = w74
    M_hat[3, 7] = w75
    # link2.theta2
    M_hat[4, 0] = w43
    M_hat[4, 1] = w61
    M_hat[4, 3] = w72
    M_hat[4, 4] = w66 * (w66 * c19) + (c20 + w69 * (w69 * c18))
    M_hat[4, 6] = w76
    M_hat[4, 7] = w77
    # link2.theta3
    M_hat[5, 3] = w73
    M_hat[5, 5] = c16
    # link3.theta1
    M_hat[6, 0] = w51
    M_hat[6, 1] = w62
    M_hat[6, 3] = w74
    M_hat[6, 4] = w76
    M_hat[6, 6] = w52 * w78 + w80 * w81 + w83 * w84
    M_hat[6, 7] = w85
    M_hat[6, 8] = w86
    # link3.theta2
    M_hat[7, 0] = w56
    M_hat[7, 1] = w64
    M_hat[7, 3] = w75
    M_hat[7, 4] = w77
    M_hat[7, 6] = w85
    M_hat[7, 7] = w82 * (w82 * c25) + w79 * (w79 * c26)
    # link3.theta3
    M_hat[8, 6] = w86
    M_hat[8, 8] = c23
    Q_hat = ca.vertcat(
        w14 * w151 - (w4 * w155 - w0 * w158 + w7 * w160 + w11 * w168),  # link1.theta1
        w173 + w16 * w168 + w17 * w151,  # link1.theta2
        -w158,  # link1.theta3
        w29 * w150 - (w67 * w174 - w32 * w176 + w70 * w177 + (w23 * w163 - w28 * w121) + w24 * w167),  # link2.theta1
        w178,  # link2.theta2
        -w176,  # link2.theta3
        w52 * w182 - w80 * w179 - w83 * w183 - (w47 * w166 - w50 * w149),  # link3.theta1
        w54 * w149 + w55 * w166 + w63 * w171 - (w82 * w179 - w79 * w183),  # link3.theta2
        -w182,  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 9) [mixed]: dependent coordinates after one Newton step
    39 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link1_end_x = c[6]
    link2_end_x = c[12]
    c29 = c[29]
    # intermediate terms (5)
    w0 = ca.cos(link1_theta2)
    w1 = ca.cos(link1_theta1) * w0 * link1_end_x
    w2 = w0 * ca.sin(link1_theta1) * link1_end_x
    w3 = ca.sin(link1_theta2) * link1_end_x
    w4 = ca.cos(link2_theta2)
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        w1,  # link2.x
        w2,  # link2.y
        -w3,  # link2.z
        w1 + ca.cos(link2_theta1) * w4 * link2_end_x,  # link3.x
        w2 + w4 * ca.sin(link2_theta1) * link2_end_x,  # link3.y
        ca.sin(link2_theta2) * c29 - w3,  # link3.z
    )
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    64 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link1_end_x = c[6]
    link2_end_x = c[12]
    c29 = c[29]
    # intermediate terms (11)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = ca.cos(link1_theta1)
    w3 = ca.sin(link1_theta2) * link1_end_x
    w4 = w0 * w1 * link1_end_x * link1_theta1_dot + w2 * w3 * link1_theta2_dot
    w5 = link1_theta1_dot * (w0 * w2 * link1_end_x) - link1_theta2_dot * (w1 * w3)
    w6 = link1_theta2_dot * (w0 * link1_end_x)
    w7 = ca.cos(link2_theta2)
    w8 = ca.sin(link2_theta1)
    w9 = ca.cos(link2_theta1)
    w10 = ca.sin(link2_theta2) * link2_end_x
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        -w4,  # link2.x
        w5,  # link2.y
        -w6,  # link2.z
        w7 * w8 * c29 * link2_theta1_dot - w4 - w9 * w10 * link2_theta2_dot,  # link3.x
        w5 + link2_theta1_dot * (w7 * w9 * link2_end_x) - link2_theta2_dot * (w8 * w10),  # link3.y
        w7 * c29 * link2_theta2_dot - w6,  # link3.z
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 9) [mixed]: accelerations of the dependent coordinates
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link1_theta1_ddot = q_i_ddot[0]
    link1_theta2_ddot = q_i_ddot[1]
    link2_theta1_ddot = q_i_ddot[3]
    link2_theta2_ddot = q_i_ddot[4]
    link1_end_x = c[6]
    link2_end_x = c[12]
    # intermediate terms (60)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = ca.sin(link1_theta1)
    w3 = w1 * w2
    w4 = link1_theta2_dot * w0 + link1_theta3_dot * w3
    w5 = w0 * w1
    w6 = link1_theta3_dot * w5 - link1_theta2_dot * w2
    w7 = w3 * link1_end_x
    w8 = w5 * link1_end_x
    w9 = w6 * w7 - w4 * w8
    w10 = ca.sin(link1_theta2)
    w11 = link1_theta1_dot - link1_theta3_dot * w10
    w12 = w10 * link1_end_x
    w13 = w8 * w11 + w6 * w12
    w14 = ca.cos(link1_theta3)
    w15 = w0 * w14
    w16 = ca.sin(link1_theta3)
    w17 = link1_theta3_dot * w1
    w18 = link1_theta2_dot * link1_theta3_dot
    w19 = link1_theta1_dot * (w14 * w17 - w16 * (link1_theta2_dot * w10)) - w16 * w18
    w20 = w1 * (link1_theta2_dot * link1_theta1_dot)
    w21 = w2 * w14
    w22 = link1_theta1_dot * (w16 * w17 + w10 * (link1_theta2_dot * w14)) + w14 * w18
    w23 = (w15 + w2 * w10 * w16) * w19 - w3 * w20 - (w10 * w21 - w0 * w16) * w22
    w24 = w10 * w20 + w19 * (w1 * w16) - w22 * (w1 * w14)
    w25 = w4 * w9 - w11 * w13 - (w12 * w23 + w7 * w24) - w7 * link1_theta1_ddot - w0 * w12 * link1_theta2_ddot
    w26 = w19 * (w16 * (w0 * w10) - w21) - w5 * w20 - w22 * (w2 * w16 + w10 * w15)
    w27 = w4 * w12 + w7 * w11
    w28 = w8 * w24 + w12 * w26 - (w11 * w27 + w6 * w9) + w8 * link1_theta1_ddot - link1_theta2_ddot * (w2 * w12)
    w29 = w7 * w26 - w8 * w23 + (w6 * w13 + w4 * w27) - link1_theta2_ddot * (w1 * link1_end_x)
    w30 = ca.cos(link2_theta1)
    w31 = ca.cos(link2_theta2)
    w32 = ca.sin(link2_theta1)
    w33 = w31 * w32
    w34 = link2_theta2_dot * w30 + link2_theta3_dot * w33
    w35 = w30 * w31
    w36 = link2_theta3_dot * w35 - link2_theta2_dot * w32
    w37 = w33 * link2_end_x
    w38 = w35 * link2_end_x
    w39 = w36 * w37 - w34 * w38
    w40 = ca.sin(link2_theta2)
    w41 = link2_theta1_dot - link2_theta3_dot * w40
    w42 = w40 * link2_end_x
    w43 = w38 * w41 + w36 * w42
    w44 = ca.cos(link2_theta3)
    w45 = w30 * w44
    w46 = ca.sin(link2_theta3)
    w47 = link2_theta3_dot * w31
    w48 = link2_theta2_dot * link2_theta3_dot
    w49 = link2_theta1_dot * (w44 * w47 - w46 * (link2_theta2_dot * w40)) - w46 * w48
    w50 = w31 * (link2_theta2_dot * link2_theta1_dot)
    w51 = w32 * w44
    w52 = link2_theta1_dot * (w46 * w47 + w40 * (link2_theta2_dot * w44)) + w44 * w48
    w53 = (w45 + w32 * w40 * w46) * w49 - w33 * w50 - (w40 * w51 - w30 * w46) * w52
    w54 = w40 * w50 + w49 * (w31 * w46) - w52 * (w31 * w44)
    w55 = w25 + (w34 * w39 - w41 * w43 - (w42 * w53 + w37 * w54)) - w37 * link2_theta1_ddot - w30 * w42 * link2_theta2_ddot
    w56 = w49 * (w46 * (w30 * w40) - w51) - w35 * w50 - w52 * (w32 * w46 + w40 * w45)
    w57 = w34 * w42 + w37 * w41
    w58 = w28 + (w38 * w54 + w42 * w56 - (w41 * w57 + w36 * w39)) + w38 * link2_theta1_ddot - link2_theta2_ddot * (w32 * w42)
    w59 = w29 + (w37 * w56 - w38 * w53 + (w36 * w43 + w34 * w57)) - link2_theta2_ddot * (w31 * link2_end_x)
    # outputs
    q_d_ddot = ca.vertcat(
        0.0,  # link1.x
        0.0,  # link1.y
        0.0,  # link1.z
        w25,  # link2.x
        w28,  # link2.y
        w29,  # link2.z
        w55,  # link3.x
        w58,  # link3.y
        w59,  # link3.z
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 18) [mixed]: rates of all coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 9) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 9 x 18) [SI]: constraint Jacobian
    gives C_t (n_c = 9) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 9) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    440 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 53)
    link1_x = q[0]
    link1_y = q[1]
    link1_z = q[2]
    link1_theta1 = q[3]
    link1_theta2 = q[4]
    link1_theta3 = q[5]
    link2_x = q[6]
    link2_y = q[7]
    link2_z = q[8]
    link2_theta1 = q[9]
    link2_theta2 = q[10]
    link2_theta3 = q[11]
    link3_x = q[12]
    link3_y = q[13]
    link3_z = q[14]
    link1_theta1_dot = q_dot[3]
    link1_theta2_dot = q_dot[4]
    link1_theta3_dot = q_dot[5]
    link2_theta1_dot = q_dot[9]
    link2_theta2_dot = q_dot[10]
    link2_theta3_dot = q_dot[11]
    link1_end_x = c[6]
    link2_end_x = c[12]
    # intermediate terms (54)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.sin(link1_theta1)
    w5 = w1 * w4
    w6 = w5 * link1_end_x
    w7 = ca.sin(link1_theta2)
    w8 = w7 * link1_end_x
    w9 = ca.cos(link2_theta1)
    w10 = ca.cos(link2_theta2)
    w11 = w9 * w10
    w12 = w11 * link2_end_x
    w13 = ca.sin(link2_theta1)
    w14 = w10 * w13
    w15 = w14 * link2_end_x
    w16 = ca.sin(link2_theta2)
    w17 = w16 * link2_end_x
    w18 = w0 * link1_theta2_dot + w5 * link1_theta3_dot
    w19 = w2 * link1_theta3_dot - w4 * link1_theta2_dot
    w20 = w6 * w19 - w3 * w18
    w21 = link1_theta1_dot - w7 * link1_theta3_dot
    w22 = w3 * w21 + w8 * w19
    w23 = ca.cos(link1_theta3)
    w24 = w0 * w23
    w25 = ca.sin(link1_theta3)
    w26 = w1 * link1_theta3_dot
    w27 = link1_theta2_dot * link1_theta3_dot
    w28 = link1_theta1_dot * (w23 * w26 - w25 * (w7 * link1_theta2_dot)) - w25 * w27
    w29 = w1 * (link1_theta2_dot * link1_theta1_dot)
    w30 = w4 * w23
    w31 = link1_theta1_dot * (w25 * w26 + w7 * (link1_theta2_dot * w23)) + w23 * w27
    w32 = (w24 + w4 * w7 * w25) * w28 - w5 * w29 - (w7 * w30 - w0 * w25) * w31
    w33 = w7 * w29 + w28 * (w1 * w25) - w31 * (w1 * w23)
    w34 = w28 * (w25 * (w0 * w7) - w30) - w2 * w29 - w31 * (w4 * w25 + w7 * w24)
    w35 = w8 * w18 + w6 * w21
    w36 = w9 * link2_theta2_dot + w14 * link2_theta3_dot
    w37 = w11 * link2_theta3_dot - w13 * link2_theta2_dot
    w38 = w15 * w37 - w12 * w36
    w39 = link2_theta1_dot - w16 * link2_theta3_dot
    w40 = w12 * w39 + w17 * w37
    w41 = ca.cos(link2_theta3)
    w42 = w9 * w41
    w43 = ca.sin(link2_theta3)
    w44 = w10 * link2_theta3_dot
    w45 = link2_theta2_dot * link2_theta3_dot
    w46 = link2_theta1_dot * (w41 * w44 - w43 * (w16 * link2_theta2_dot)) - w43 * w45
    w47 = w10 * (link2_theta2_dot * link2_theta1_dot)
    w48 = w13 * w41
    w49 = link2_theta1_dot * (w43 * w44 + w16 * (link2_theta2_dot * w41)) + w41 * w45
    w50 = (w42 + w13 * w16 * w43) * w46 - w14 * w47 - (w16 * w48 - w9 * w43) * w49
    w51 = w16 * w47 + w46 * (w10 * w43) - w49 * (w10 * w41)
    w52 = w46 * (w43 * (w9 * w16) - w48) - w11 * w47 - w49 * (w13 * w43 + w16 * w42)
    w53 = w17 * w36 + w15 * w39
    # outputs
    C = ca.vertcat(
        link1_x,  # joint1.x
        link1_y,  # joint1.y
        link1_z,  # joint1.z
        link2_x - (link1_x + w3),  # joint2.x
        link2_y - (link1_y + w6),  # joint2.y
        link2_z - (link1_z - w8),  # joint2.z
        link3_x - (link2_x + w12),  # joint3.x
        link3_y - (link2_y + w15),  # joint3.y
        link3_z - (link2_z - w17),  # joint3.z
    )
    C_q = ca.SX(9, 18)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # joint1.z
    C_q[2, 2] = 1.0
    # joint2.x
    C_q[3, 0] = -1.0
    C_q[3, 3] = w6
    C_q[3, 4] = w0 * w8
    C_q[3, 6] = 1.0
    # joint2.y
    C_q[4, 1] = -1.0
    C_q[4, 3] = -w3
    C_q[4, 4] = w4 * w8
    C_q[4, 7] = 1.0
    # joint2.z
    C_q[5, 2] = -1.0
    C_q[5, 4] = w1 * link1_end_x
    C_q[5, 8] = 1.0
    # joint3.x
    C_q[6, 6] = -1.0
    C_q[6, 9] = w15
    C_q[6, 10] = w9 * w17
    C_q[6, 12] = 1.0
    # joint3.y
    C_q[7, 7] = -1.0
    C_q[7, 9] = -w12
    C_q[7, 10] = w13 * w17
    C_q[7, 13] = 1.0
    # joint3.z
    C_q[8, 8] = -1.0
    C_q[8, 10] = w10 * link2_end_x
    C_q[8, 14] = 1.0
    C_t = ca.SX(9, 1)
    nu = ca.SX(9, 1)
    gamma = ca.vertcat(
        0.0,  # joint1.x
        0.0,  # joint1.y
        0.0,  # joint1.z
        w18 * w20 - w21 * w22 - (w8 * w32 + w6 * w33),  # joint2.x
        w3 * w33 + w8 * w34 - (w21 * w35 + w19 * w20),  # joint2.y
        w19 * w22 + w18 * w35 + (w6 * w34 - w3 * w32),  # joint2.z
        w36 * w38 - w39 * w40 - (w17 * w50 + w15 * w51),  # joint3.x
        w12 * w51 + w17 * w52 - (w39 * w53 + w37 * w38),  # joint3.y
        w37 * w40 + w36 * w53 + (w15 * w52 - w12 * w50),  # joint3.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 18) [mixed]: rates of all coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 18 x 18) [SI]: mass matrix in all coordinates
    gives K (n x n = 18 x 18) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 18) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 18) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 18) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 9 x 18) [SI]: constraint Jacobian
    gives gamma_b (n_c = 9) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    1443 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q[3]
    link1_theta2 = q[4]
    link1_theta3 = q[5]
    link2_theta1 = q[9]
    link2_theta2 = q[10]
    link2_theta3 = q[11]
    link3_theta1 = q[15]
    link3_theta2 = q[16]
    link3_theta3 = q[17]
    link1_theta1_dot = q_dot[3]
    link1_theta2_dot = q_dot[4]
    link1_theta3_dot = q_dot[5]
    link2_theta1_dot = q_dot[9]
    link2_theta2_dot = q_dot[10]
    link2_theta3_dot = q_dot[11]
    link3_theta1_dot = q_dot[15]
    link3_theta2_dot = q_dot[16]
    link3_theta3_dot = q_dot[17]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c11 = c[11]
    link2_end_x = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    gravity_z = c[27]
    link1_mass = c[30]
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
    # intermediate terms (178)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1
    w3 = ca.cos(link1_theta1)
    w4 = ca.sin(link1_theta2)
    w5 = w4 * c31
    w6 = -(w3 * w5)
    w7 = w0 * w3
    w8 = w7 * c31
    w9 = -(w1 * w5)
    w10 = w0 * c31
    w11 = -w10
    w12 = ca.sin(link1_theta3)
    w13 = w0 * w12
    w14 = ca.cos(link1_theta3)
    w15 = w0 * w14
    w16 = w14 * c4
    w17 = w12 * c5
    w18 = w13 * w16 - w15 * w17
    w19 = w4 * c32
    w20 = ca.cos(link2_theta2)
    w21 = ca.sin(link2_theta1)
    w22 = w20 * w21
    w23 = ca.cos(link2_theta1)
    w24 = ca.sin(link2_theta2)
    w25 = w24 * c11
    w26 = -(w23 * w25)
    w27 = w20 * w23
    w28 = w27 * c11
    w29 = -(w21 * w25)
    w30 = w20 * c11
    w31 = -w30
    w32 = ca.sin(link2_theta3)
    w33 = w20 * w32
    w34 = ca.cos(link2_theta3)
    w35 = w20 * w34
    w36 = w34 * c18
    w37 = w32 * c19
    w38 = w33 * w36 - w35 * w37
    w39 = w24 * c33
    w40 = ca.cos(link3_theta2)
    w41 = ca.sin(link3_theta1)
    w42 = w40 * w41
    w43 = ca.cos(link3_theta1)
    w44 = ca.sin(link3_theta2)
    w45 = w44 * c13
    w46 = -(w43 * w45)
    w47 = w40 * w43
    w48 = w47 * c13
    w49 = -(w41 * w45)
    w50 = w40 * c13
    w51 = -w50
    w52 = ca.sin(link3_theta3)
    w53 = w40 * w52
    w54 = ca.cos(link3_theta3)
    w55 = w40 * w54
    w56 = w54 * c25
    w57 = w52 * c26
    w58 = w53 * w56 - w55 * w57
    w59 = w44 * c34
    w60 = w15 * link1_theta1_dot - w12 * link1_theta2_dot
    w61 = w60 * c31
    w62 = w14 * link1_theta2_dot
    w63 = w13 * link1_theta1_dot + w62
    w64 = w63 * c31
    w65 = w60 * w61 + w63 * w64
    w66 = w1 * w14
    w67 = w12 * (w3 * w4) - w66
    w68 = w0 * link1_theta3_dot
    w69 = link1_theta2_dot * link1_theta3_dot
    w70 = link1_theta1_dot * (w12 * w68 + w4 * w62) + w14 * w69
    w71 = link1_theta3_dot - w4 * link1_theta1_dot
    w72 = w70 * c31 - w64 * w71
    w73 = w3 * w14
    w74 = w1 * w12 + w4 * w73
    w75 = link1_theta1_dot * (w14 * w68 - w12 * (w4 * link1_theta2_dot)) - w12 * w69
    w76 = w75 * c31 - w61 * w71
    w77 = w7 * w65 + w67 * w72 + w74 * w76
    w78 = w73 + w12 * (w1 * w4)
    w79 = w4 * w66 - w3 * w12
    w80 = w2 * w65 + w72 * w78 + w76 * w79
    w81 = w13 * w72 - w4 * w65 + w15 * w76
    w82 = w71 * c3
    w83 = w60 * c1
    w84 = w60 * w82 - w71 * w83 - w75 * c4
    w85 = w63 * c0
    w86 = w0 * (link1_theta1_dot * link1_theta2_dot)
    w87 = w63 * w83 - w60 * w85 + w86 * c2
    w88 = w71 * w85 - w63 * w82 + w70 * c5
    w89 = w13 * w84 - w4 * w87 + w15 * w88
    w90 = w14 * w84 - w12 * w88
    w91 = w35 * link2_theta1_dot - w32 * link2_theta2_dot
    w92 = w91 * c11
    w93 = w34 * link2_theta2_dot
    w94 = w33 * link2_theta1_dot + w93
    w95 = w94 * c11
    w96 = w91 * w92 + w94 * w95
    w97 = w21 * w34
    w98 = w32 * (w23 * w24) - w97
    w99 = w20 * link2_theta3_dot
    w100 = link2_theta2_dot * link2_theta3_dot
    w101 = link2_theta1_dot * (w32 * w99 + w24 * w93) + w34 * w100
    w102 = link2_theta3_dot - w24 * link2_theta1_dot
    w103 = w101 * c11 - w95 * w102
    w104 = w23 * w34
    w105 = w21 * w32 + w24 * w104
    w106 = link2_theta1_dot * (w34 * w99 - w32 * (w24 * link2_theta2_dot)) - w32 * w100
    w107 = w106 * c11 - w92 * w102
    w108 = w27 * w96 + w98 * w103 + w105 * w107
    w109 = w104 + w32 * (w21 * w24)
    w110 = w24 * w97 - w23 * w32
    w111 = w22 * w96 + w103 * w109 + w107 * w110
    w112 = w33 * w103 - w24 * w96 + w35 * w107
    w113 = w102 * c17
    w114 = w91 * c15
    w115 = w91 * w113 - w102 * w114 - w106 * c18
    w116 = w94 * c14
    w117 = w20 * (link2_theta1_dot * link2_theta2_dot)
    w118 = w94 * w114 - w91 * w116 + w117 * c16
    w119 = w102 * w116 - w94 * w113 + w101 * c19
    w120 = w33 * w115 - w24 * w118 + w35 * w119
    w121 = w34 * w115 - w32 * w119
    w122 = w55 * link3_theta1_dot - w52 * link3_theta2_dot
    w123 = w122 * c13
    w124 = w54 * link3_theta2_dot
    w125 = w53 * link3_theta1_dot + w124
    w126 = w125 * c13
    w127 = w122 * w123 + w125 * w126
    w128 = w41 * w54
    w129 = w40 * link3_theta3_dot
    w130 = link3_theta2_dot * link3_theta3_dot
    w131 = link3_theta1_dot * (w52 * w129 + w44 * w124) + w54 * w130
    w132 = link3_theta3_dot - w44 * link3_theta1_dot
    w133 = w131 * c13 - w126 * w132
    w134 = w43 * w54
    w135 = link3_theta1_dot * (w54 * w129 - w52 * (w44 * link3_theta2_dot)) - w52 * w130
    w136 = w135 * c13 - w123 * w132
    w137 = w47 * w127 + (w52 * (w43 * w44) - w128) * w133 + (w41 * w52 + w44 * w134) * w136
    w138 = w42 * w127 + w133 * (w134 + w52 * (w41 * w44)) + w136 * (w44 * w128 - w43 * w52)
    w139 = w53 * w133 - w44 * w127 + w55 * w136
    w140 = w132 * c24
    w141 = w122 * c22
    w142 = w122 * w140 - w132 * w141 - w135 * c25
    w143 = w125 * c21
    w144 = w125 * w141 - w122 * w143 + w40 * (link3_theta1_dot * link3_theta2_dot) * c23
    w145 = w132 * w143 - w125 * w140 + w131 * c26
    w146 = w53 * w142 - w44 * w144 + w55 * w145
    w147 = w54 * w142 - w52 * w145
    w148 = w10 * gravity_z
    w149 = w30 * gravity_z
    w150 = w50 * gravity_z
    w151 = w2 * link1_end_x
    w152 = w7 * link1_end_x
    w153 = w4 * link1_end_x
    w154 = w22 * link2_end_x
    w155 = w27 * link2_end_x
    w156 = w24 * link2_end_x
    w157 = w3 * link1_theta2_dot + w2 * link1_theta3_dot
    w158 = w7 * link1_theta3_dot - w1 * link1_theta2_dot
    w159 = w151 * w158 - w152 * w157
    w160 = link1_theta1_dot - w4 * link1_theta3_dot
    w161 = w152 * w160 + w153 * w158
    w162 = w75 * w78 - w2 * w86 - w70 * w79
    w163 = w4 * w86 + w13 * w75 - w15 * w70
    w164 = w67 * w75 - w7 * w86 - w70 * w74
    w165 = w153 * w157 + w151 * w160
    w166 = w23 * link2_theta2_dot + w22 * link2_theta3_dot
    w167 = w27 * link2_theta3_dot - w21 * link2_theta2_dot
    w168 = w154 * w167 - w155 * w166
    w169 = link2_theta1_dot - w24 * link2_theta3_dot
    w170 = w155 * w169 + w156 * w167
    w171 = w106 * w109 - w22 * w117 - w101 * w110
    w172 = w24 * w117 + w33 * w106 - w35 * w101
    w173 = w98 * w106 - w27 * w117 - w101 * w105
    w174 = w156 * w166 + w154 * w169
    w175 = w2 * c38
    w176 = w22 * c39
    w177 = w42 * c40
    # outputs
    M = ca.SX(18, 18)
    # link1.x
    M[0, 0] = link1_mass
    M[0, 3] = w175
    M[0, 4] = w6
    # link1.y
    M[1, 1] = link1_mass
    M[1, 3] = w8
    M[1, 4] = w9
    # link1.z
    M[2, 2] = link1_mass
    M[2, 4] = w11
    # link1.theta1
    M[3, 0] = w175
    M[3, 1] = w8
    M[3, 3] = w4 * (w4 * c2) + w13 * (w13 * c4) + w15 * (w15 * c5)
    M[3, 4] = w18
    M[3, 5] = w19
    # link1.theta2
    M[4, 0] = w6
    M[4, 1] = w9
    M[4, 2] = w11
    M[4, 3] = w18
    M[4, 4] = w14 * w16 + w12 * w17
    # link1.theta3
    M[5, 3] = w19
    M[5, 5] = c2
    # link2.x
    M[6, 6] = link2_mass
    M[6, 9] = w176
    M[6, 10] = w26
    # link2.y
    M[7, 7] = link2_mass
    M[7, 9] = w28
    M[7, 10] = w29
    # link2.z
    M[8, 8] = link2_mass
    M[8, 10] = w31
    # link2.theta1
    M[9, 6] = w176
    M[9, 7] = w28
    M[9, 9] = w24 * (w24 * c16) + w33 * (w33 * c18) + w35 * (w35 * c19)
    M[9, 10] = w38
    M[9, 11] = w39
    # link2.theta2
    M[10, 6] = w26
    M[10, 7] = w29
    M[10, 8] = w31
    M[10, 9] = w38
    M[10, 10] = w34 * w36 + w32 * w37
    # link2.theta3
    M[11, 9] = w39
    M[11, 11] = c16
    # link3.x
    M[12, 12] = link3_mass
    M[12, 15] = w177
    M[12, 16] = w46
    # link3.y
    M[13, 13] = link3_mass
    M[13, 15] = w48
    M[13, 16] = w49
    # link3.z
    M[14, 14] = link3_mass
    M[14, 16] = w51
    # link3.theta1
    M[15, 12] = w177
    M[15, 13] = w48
    M[15, 15] = w44 * (w44 * c23) + w53 * (w53 * c25) + w55 * (w55 * c26)
    M[15, 16] = w58
    M[15, 17] = w59
    # link3.theta2
    M[16, 12] = w46
    M[16, 13] = w49
    M[16, 14] = w51
    M[16, 15] = w58
    M[16, 16] = w54 * w56 + w52 * w57
    # link3.theta3
    M[17, 15] = w59
    M[17, 17] = c23
    K = ca.SX(18, 18)
    Q_v = ca.vertcat(
        w77,  # link1.x
        w80,  # link1.y
        w81,  # link1.z
        w89,  # link1.theta1
        w90,  # link1.theta2
        w87,  # link1.theta3
        w108,  # link2.x
        w111,  # link2.y
        w112,  # link2.z
        w120,  # link2.theta1
        w121,  # link2.theta2
        w118,  # link2.theta3
        w137,  # link3.x
        w138,  # link3.y
        w139,  # link3.z
        w146,  # link3.theta1
        w147,  # link3.theta2
        w144,  # link3.theta3
    )
    Q_F = ca.SX(18, 1)
    Q_F[2] = c35  # link1.z
    Q_F[4] = -w148  # link1.theta2
    Q_F[8] = c36  # link2.z
    Q_F[10] = -w149  # link2.theta2
    Q_F[14] = c37  # link3.z
    Q_F[16] = -w150  # link3.theta2
    Q_star = ca.vertcat(
        w77,  # link1.x
        w80,  # link1.y
        w81 + c35,  # link1.z
        w89,  # link1.theta1
        w90 - w148,  # link1.theta2
        w87,  # link1.theta3
        w108,  # link2.x
        w111,  # link2.y
        w112 + c36,  # link2.z
        w120,  # link2.theta1
        w121 - w149,  # link2.theta2
        w118,  # link2.theta3
        w137,  # link3.x
        w138,  # link3.y
        w139 + c37,  # link3.z
        w146,  # link3.theta1
        w147 - w150,  # link3.theta2
        w144,  # link3.theta3
    )
    C_q = ca.SX(9, 18)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # joint1.z
    C_q[2, 2] = 1.0
    # joint2.x
    C_q[3, 0] = -1.0
    C_q[3, 3] = w151
    C_q[3, 4] = w3 * w153
    C_q[3, 6] = 1.0
    # joint2.y
    C_q[4, 1] = -1.0
    C_q[4, 3] = -w152
    C_q[4, 4] = w1 * w153
    C_q[4, 7] = 1.0
    # joint2.z
    C_q[5, 2] = -1.0
    C_q[5, 4] = w0 * link1_end_x
    C_q[5, 8] = 1.0
    # joint3.x
    C_q[6, 6] = -1.0
    C_q[6, 9] = w154
    C_q[6, 10] = w23 * w156
    C_q[6, 12] = 1.0
    # joint3.y
    C_q[7, 7] = -1.0
    C_q[7, 9] = -w155
    C_q[7, 10] = w21 * w156
    C_q[7, 13] = 1.0
    # joint3.z
    C_q[8, 8] = -1.0
    C_q[8, 10] = w20 * link2_end_x
    C_q[8, 14] = 1.0
    gamma_b = ca.vertcat(
        0.0,  # joint1.x
        0.0,  # joint1.y
        0.0,  # joint1.z
        w157 * w159 - w160 * w161 - (w153 * w162 + w151 * w163),  # joint2.x
        w152 * w163 + w153 * w164 - (w160 * w165 + w158 * w159),  # joint2.y
        w158 * w161 + w157 * w165 + (w151 * w164 - w152 * w162),  # joint2.z
        w166 * w168 - w169 * w170 - (w156 * w171 + w154 * w172),  # joint3.x
        w155 * w172 + w156 * w173 - (w169 * w174 + w167 * w168),  # joint3.y
        w167 * w170 + w166 * w174 + (w154 * w173 - w155 * w171),  # joint3.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 18) [mixed]: rates of all coordinates
    takes q_ddot (n = 18) [mixed]: accelerations of all coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 9) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 3) [N, N m]: world force and moment of a joint on its body b, at b
    373 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    q_ddot = ca.SX.sym("q_ddot", 18)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q[3]
    link1_theta2 = q[4]
    link1_theta3 = q[5]
    link2_theta1 = q[9]
    link2_theta2 = q[10]
    link2_theta3 = q[11]
    link3_theta1 = q[15]
    link3_theta2 = q[16]
    link3_theta3 = q[17]
    link1_theta1_dot = q_dot[3]
    link1_theta2_dot = q_dot[4]
    link1_theta3_dot = q_dot[5]
    link2_theta1_dot = q_dot[9]
    link2_theta2_dot = q_dot[10]
    link2_theta3_dot = q_dot[11]
    link3_theta1_dot = q_dot[15]
    link3_theta2_dot = q_dot[16]
    link3_theta3_dot = q_dot[17]
    link1_x_ddot = q_ddot[0]
    link1_y_ddot = q_ddot[1]
    link1_z_ddot = q_ddot[2]
    link1_theta1_ddot = q_ddot[3]
    link1_theta2_ddot = q_ddot[4]
    link2_x_ddot = q_ddot[6]
    link2_y_ddot = q_ddot[7]
    link2_z_ddot = q_ddot[8]
    link2_theta1_ddot = q_ddot[9]
    link2_theta2_ddot = q_ddot[10]
    link3_x_ddot = q_ddot[12]
    link3_y_ddot = q_ddot[13]
    link3_z_ddot = q_ddot[14]
    link3_theta1_ddot = q_ddot[15]
    link3_theta2_ddot = q_ddot[16]
    link2_mass = c[7]
    link3_mass = c[8]
    c11 = c[11]
    c13 = c[13]
    link1_mass = c[30]
    c31 = c[31]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    # intermediate terms (87)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = ca.cos(link1_theta3)
    w4 = w1 * w3
    w5 = ca.sin(link1_theta3)
    w6 = link1_theta1_dot * w4 - link1_theta2_dot * w5
    w7 = w6 * c31
    w8 = w1 * w5
    w9 = w3 * link1_theta2_dot
    w10 = link1_theta1_dot * w8 + w9
    w11 = w10 * c31
    w12 = w6 * w7 + w10 * w11
    w13 = ca.sin(link1_theta2)
    w14 = ca.sin(link1_theta1)
    w15 = w3 * w14
    w16 = w1 * link1_theta3_dot
    w17 = link1_theta2_dot * link1_theta3_dot
    w18 = link1_theta3_dot - link1_theta1_dot * w13
    w19 = (link1_theta1_dot * (w5 * w16 + w9 * w13) + w3 * w17) * c31 - w11 * w18
    w20 = w0 * w3
    w21 = (link1_theta1_dot * (w3 * w16 - w5 * (link1_theta2_dot * w13)) - w5 * w17) * c31 - w7 * w18
    w22 = w1 * w14
    w23 = w13 * c31
    w24 = w2 * w12 + (w5 * (w0 * w13) - w15) * w19 + (w5 * w14 + w13 * w20) * w21 - (link1_x_ddot * link1_mass - w22 * c31 * link1_theta1_ddot - w0 * w23 * link1_theta2_ddot)
    w25 = ca.cos(link2_theta1)
    w26 = ca.cos(link2_theta2)
    w27 = w25 * w26
    w28 = ca.cos(link2_theta3)
    w29 = w26 * w28
    w30 = ca.sin(link2_theta3)
    w31 = link2_theta1_dot * w29 - link2_theta2_dot * w30
    w32 = w31 * c11
    w33 = w26 * w30
    w34 = w28 * link2_theta2_dot
    w35 = link2_theta1_dot * w33 + w34
    w36 = w35 * c11
    w37 = w31 * w32 + w35 * w36
    w38 = ca.sin(link2_theta2)
    w39 = ca.sin(link2_theta1)
    w40 = w28 * w39
    w41 = w26 * link2_theta3_dot
    w42 = link2_theta2_dot * link2_theta3_dot
    w43 = link2_theta3_dot - link2_theta1_dot * w38
    w44 = (link2_theta1_dot * (w30 * w41 + w34 * w38) + w28 * w42) * c11 - w36 * w43
    w45 = w25 * w28
    w46 = (link2_theta1_dot * (w28 * w41 - w30 * (link2_theta2_dot * w38)) - w30 * w42) * c11 - w32 * w43
    w47 = w26 * w39
    w48 = w38 * c11
    w49 = w27 * w37 + (w30 * (w25 * w38) - w40) * w44 + (w30 * w39 + w38 * w45) * w46 - (link2_x_ddot * link2_mass - w47 * c11 * link2_theta1_ddot - w25 * w48 * link2_theta2_ddot)
    w50 = ca.cos(link3_theta1)
    w51 = ca.cos(link3_theta2)
    w52 = w50 * w51
    w53 = ca.cos(link3_theta3)
    w54 = w51 * w53
    w55 = ca.sin(link3_theta3)
    w56 = link3_theta1_dot * w54 - link3_theta2_dot * w55
    w57 = w56 * c13
    w58 = w51 * w55
    w59 = w53 * link3_theta2_dot
    w60 = link3_theta1_dot * w58 + w59
    w61 = w60 * c13
    w62 = w56 * w57 + w60 * w61
    w63 = ca.sin(link3_theta2)
    w64 = ca.sin(link3_theta1)
    w65 = w53 * w64
    w66 = w51 * link3_theta3_dot
    w67 = link3_theta2_dot * link3_theta3_dot
    w68 = link3_theta3_dot - link3_theta1_dot * w63
    w69 = (link3_theta1_dot * (w55 * w66 + w59 * w63) + w53 * w67) * c13 - w61 * w68
    w70 = w50 * w53
    w71 = (link3_theta1_dot * (w53 * w66 - w55 * (link3_theta2_dot * w63)) - w55 * w67) * c13 - w57 * w68
    w72 = w51 * w64
    w73 = w63 * c13
    w74 = w52 * w62 + (w55 * (w50 * w63) - w65) * w69 + (w55 * w64 + w63 * w70) * w71 - (link3_x_ddot * link3_mass - w72 * c13 * link3_theta1_ddot - w50 * w73 * link3_theta2_ddot)
    w75 = w49 + w74
    w76 = w24 + w75
    w77 = w12 * w22 + w19 * (w20 + w5 * (w13 * w14)) + w21 * (w13 * w15 - w0 * w5) - (link1_y_ddot * link1_mass + link1_theta1_ddot * (w2 * c31) - link1_theta2_ddot * (w14 * w23))
    w78 = w37 * w47 + w44 * (w45 + w30 * (w38 * w39)) + w46 * (w38 * w40 - w25 * w30) - (link2_y_ddot * link2_mass + link2_theta1_ddot * (w27 * c11) - link2_theta2_ddot * (w39 * w48))
    w79 = w62 * w72 + w69 * (w70 + w55 * (w63 * w64)) + w71 * (w63 * w65 - w50 * w55) - (link3_y_ddot * link3_mass + link3_theta1_ddot * (w52 * c13) - link3_theta2_ddot * (w64 * w73))
    w80 = w78 + w79
    w81 = w77 + w80
    w82 = c35 + (w8 * w19 - w12 * w13 + w4 * w21) - (link1_z_ddot * link1_mass - link1_theta2_ddot * (w1 * c31))
    w83 = c36 + (w33 * w44 - w37 * w38 + w29 * w46) - (link2_z_ddot * link2_mass - link2_theta2_ddot * (w26 * c11))
    w84 = c37 + (w58 * w69 - w62 * w63 + w54 * w71) - (link3_z_ddot * link3_mass - link3_theta2_ddot * (w51 * c13))
    w85 = w83 + w84
    w86 = w82 + w85
    # outputs
    lam = ca.vertcat(
        w76,  # joint1.x
        w81,  # joint1.y
        w86,  # joint1.z
        w75,  # joint2.x
        w80,  # joint2.y
        w85,  # joint2.z
        w74,  # joint3.x
        w79,  # joint3.y
        w84,  # joint3.z
    )
    joint_forces = ca.SX(6, 3)
    joint_forces[0, 0] = -w76
    joint_forces[0, 1] = -w75
    joint_forces[0, 2] = -w74
    joint_forces[1, 0] = -w81
    joint_forces[1, 1] = -w80
    joint_forces[1, 2] = -w79
    joint_forces[2, 0] = -w86
    joint_forces[2, 1] = -w85
    joint_forces[2, 2] = -w84
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 18) [mixed]: rates of all coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    296 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 53)
    link1_z = q[2]
    link1_theta1 = q[3]
    link1_theta2 = q[4]
    link1_theta3 = q[5]
    link2_z = q[8]
    link2_theta1 = q[9]
    link2_theta2 = q[10]
    link2_theta3 = q[11]
    link3_z = q[14]
    link3_theta1 = q[15]
    link3_theta2 = q[16]
    link3_theta3 = q[17]
    link1_x_dot = q_dot[0]
    link1_y_dot = q_dot[1]
    link1_z_dot = q_dot[2]
    link1_theta1_dot = q_dot[3]
    link1_theta2_dot = q_dot[4]
    link1_theta3_dot = q_dot[5]
    link2_x_dot = q_dot[6]
    link2_y_dot = q_dot[7]
    link2_z_dot = q_dot[8]
    link2_theta1_dot = q_dot[9]
    link2_theta2_dot = q_dot[10]
    link2_theta3_dot = q_dot[11]
    link3_x_dot = q_dot[12]
    link3_y_dot = q_dot[13]
    link3_z_dot = q_dot[14]
    link3_theta1_dot = q_dot[15]
    link3_theta2_dot = q_dot[16]
    link3_theta3_dot = q_dot[17]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    link2_mass = c[7]
    link3_mass = c[8]
    c11 = c[11]
    c13 = c[13]
    c16 = c[16]
    c18 = c[18]
    c19 = c[19]
    c23 = c[23]
    c25 = c[25]
    c26 = c[26]
    link1_mass = c[30]
    c31 = c[31]
    c41 = c[41]
    # intermediate terms (69)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1 * c31
    w3 = ca.cos(link1_theta1)
    w4 = ca.sin(link1_theta2)
    w5 = w4 * c31
    w6 = w3 * w5
    w7 = w0 * w3 * c31
    w8 = w1 * w5
    w9 = link1_x_dot * (link1_x_dot * link1_mass - w2 * link1_theta1_dot - w6 * link1_theta2_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta1_dot * w7 - link1_theta2_dot * w8)
    w10 = w0 * c31
    w11 = w4 * c2
    w12 = ca.sin(link1_theta3)
    w13 = w0 * w12
    w14 = ca.cos(link1_theta3)
    w15 = w0 * w14
    w16 = link1_y_dot * w7 - link1_x_dot * w2 + link1_theta1_dot * (w4 * w11 + w13 * (w13 * c4) + w15 * (w15 * c5))
    w17 = w14 * c4
    w18 = w12 * c5
    w19 = w13 * w17 - w15 * w18
    w20 = w9 + link1_z_dot * (link1_z_dot * link1_mass - link1_theta2_dot * w10) + link1_theta1_dot * (w16 + link1_theta2_dot * w19 - w11 * link1_theta3_dot)
    w21 = link1_theta1_dot * w19 - (link1_x_dot * w6 + link1_y_dot * w8 + link1_z_dot * w10) + link1_theta2_dot * (w14 * w17 + w12 * w18)
    w22 = w20 + link1_theta2_dot * w21 + link1_theta3_dot * (link1_theta3_dot * c2 - link1_theta1_dot * w11)
    w23 = ca.cos(link2_theta2)
    w24 = ca.sin(link2_theta1)
    w25 = w23 * w24 * c11
    w26 = ca.cos(link2_theta1)
    w27 = ca.sin(link2_theta2)
    w28 = w27 * c11
    w29 = w26 * w28
    w30 = w23 * w26 * c11
    w31 = w24 * w28
    w32 = w22 + link2_x_dot * (link2_x_dot * link2_mass - w25 * link2_theta1_dot - w29 * link2_theta2_dot) + link2_y_dot * (link2_y_dot * link2_mass + link2_theta1_dot * w30 - link2_theta2_dot * w31)
    w33 = w23 * c11
    w34 = w27 * c16
    w35 = ca.sin(link2_theta3)
    w36 = w23 * w35
    w37 = ca.cos(link2_theta3)
    w38 = w23 * w37
    w39 = link2_y_dot * w30 - link2_x_dot * w25 + link2_theta1_dot * (w27 * w34 + w36 * (w36 * c18) + w38 * (w38 * c19))
    w40 = w37 * c18
    w41 = w35 * c19
    w42 = w36 * w40 - w38 * w41
    w43 = w32 + link2_z_dot * (link2_z_dot * link2_mass - link2_theta2_dot * w33) + link2_theta1_dot * (w39 + link2_theta2_dot * w42 - w34 * link2_theta3_dot)
    w44 = link2_theta1_dot * w42 - (link2_x_dot * w29 + link2_y_dot * w31 + link2_z_dot * w33) + link2_theta2_dot * (w37 * w40 + w35 * w41)
    w45 = w43 + link2_theta2_dot * w44 + link2_theta3_dot * (link2_theta3_dot * c16 - link2_theta1_dot * w34)
    w46 = ca.cos(link3_theta2)
    w47 = ca.sin(link3_theta1)
    w48 = w46 * w47 * c13
    w49 = ca.cos(link3_theta1)
    w50 = ca.sin(link3_theta2)
    w51 = w50 * c13
    w52 = w49 * w51
    w53 = w46 * w49 * c13
    w54 = w47 * w51
    w55 = w45 + link3_x_dot * (link3_x_dot * link3_mass - w48 * link3_theta1_dot - w52 * link3_theta2_dot) + link3_y_dot * (link3_y_dot * link3_mass + link3_theta1_dot * w53 - link3_theta2_dot * w54)
    w56 = w46 * c13
    w57 = w50 * c23
    w58 = ca.sin(link3_theta3)
    w59 = w46 * w58
    w60 = ca.cos(link3_theta3)
    w61 = w46 * w60
    w62 = link3_y_dot * w53 - link3_x_dot * w48 + link3_theta1_dot * (w50 * w57 + w59 * (w59 * c25) + w61 * (w61 * c26))
    w63 = w60 * c25
    w64 = w58 * c26
    w65 = w59 * w63 - w61 * w64
    w66 = w55 + link3_z_dot * (link3_z_dot * link3_mass - link3_theta2_dot * w56) + link3_theta1_dot * (w62 + link3_theta2_dot * w65 - w57 * link3_theta3_dot)
    w67 = link3_theta1_dot * w65 - (link3_x_dot * w52 + link3_y_dot * w54 + link3_z_dot * w56) + link3_theta2_dot * (w60 * w63 + w58 * w64)
    w68 = w66 + link3_theta2_dot * w67 + link3_theta3_dot * (link3_theta3_dot * c23 - link3_theta1_dot * w57)
    # outputs
    kinetic = ca.vertcat(w68 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(
        (link1_z * link1_mass - w5 + (link2_z * link2_mass - w28) + (link3_z * link3_mass - w51)) * c41,
    )
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    129 operations.
    """
    q = ca.SX.sym("q", 18)
    link1_x = q[0]
    link1_y = q[1]
    link1_z = q[2]
    link1_theta1 = q[3]
    link1_theta2 = q[4]
    link1_theta3 = q[5]
    link2_x = q[6]
    link2_y = q[7]
    link2_z = q[8]
    link2_theta1 = q[9]
    link2_theta2 = q[10]
    link2_theta3 = q[11]
    link3_x = q[12]
    link3_y = q[13]
    link3_z = q[14]
    link3_theta1 = q[15]
    link3_theta2 = q[16]
    link3_theta3 = q[17]
    # intermediate terms (24)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = ca.sin(link1_theta1)
    w3 = ca.sin(link1_theta2)
    w4 = ca.sin(link1_theta3)
    w5 = ca.cos(link1_theta3)
    w6 = w2 * w5
    w7 = w0 * w5
    w8 = ca.cos(link2_theta1)
    w9 = ca.cos(link2_theta2)
    w10 = ca.sin(link2_theta1)
    w11 = ca.sin(link2_theta2)
    w12 = ca.sin(link2_theta3)
    w13 = ca.cos(link2_theta3)
    w14 = w10 * w13
    w15 = w8 * w13
    w16 = ca.cos(link3_theta1)
    w17 = ca.cos(link3_theta2)
    w18 = ca.sin(link3_theta1)
    w19 = ca.sin(link3_theta2)
    w20 = ca.sin(link3_theta3)
    w21 = ca.cos(link3_theta3)
    w22 = w18 * w21
    w23 = w16 * w21
    # outputs
    poses = ca.vertcat(
        ca.horzcat(link1_x, link2_x, link3_x),
        ca.horzcat(link1_y, link2_y, link3_y),
        ca.horzcat(link1_z, link2_z, link3_z),
        ca.horzcat(w0 * w1, w8 * w9, w16 * w17),
        ca.horzcat(w1 * w2, w9 * w10, w17 * w18),
        ca.horzcat(-w3, -w11, -w19),
        ca.horzcat(w0 * w3 * w4 - w6, w8 * w11 * w12 - w14, w16 * w19 * w20 - w22),
        ca.horzcat(w7 + w4 * (w2 * w3), w15 + w12 * (w10 * w11), w23 + w20 * (w18 * w19)),
        ca.horzcat(w1 * w4, w9 * w12, w17 * w20),
        ca.horzcat(w2 * w4 + w3 * w7, w10 * w12 + w11 * w15, w18 * w20 + w19 * w23),
        ca.horzcat(w3 * w6 - w0 * w4, w11 * w14 - w8 * w12, w19 * w22 - w16 * w20),
        ca.horzcat(w1 * w5, w9 * w13, w17 * w21),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i, through q_d
    1337 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link3_theta1_dot = q_i_dot[6]
    link3_theta2_dot = q_i_dot[7]
    link3_theta3_dot = q_i_dot[8]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c9 = c[9]
    c11 = c[11]
    link2_end_x = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c21 = c[21]
    c22 = c[22]
    c24 = c[24]
    gravity_z = c[27]
    c28 = c[28]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    # intermediate terms (344)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = w0 * link1_theta1_dot
    w5 = link1_theta1_dot * w4
    w6 = ca.sin(link1_theta1)
    w7 = link1_theta1_dot * w6
    w8 = ca.sin(link1_theta2)
    w9 = w8 * link1_theta2_dot
    w10 = w7 * w9
    w11 = w1 * link1_theta2_dot
    w12 = link1_theta2_dot * w11
    w13 = (w1 * w5 - w10 + (w0 * w12 - w10)) * link1_end_x
    w14 = w13 * c9
    w15 = ca.cos(link2_theta1)
    w16 = ca.cos(link2_theta3)
    w17 = w15 * w16
    w18 = ca.sin(link2_theta1)
    w19 = ca.sin(link2_theta2)
    w20 = w18 * w19
    w21 = ca.sin(link2_theta3)
    w22 = w17 + w20 * w21
    w23 = link2_theta3_dot - w19 * link2_theta1_dot
    w24 = ca.cos(link2_theta2)
    w25 = w21 * w24
    w26 = w16 * link2_theta2_dot
    w27 = link2_theta1_dot * w25 + w26
    w28 = w23 * w27
    w29 = link2_theta3_dot * w24
    w30 = w21 * w29
    w31 = link2_theta3_dot * link2_theta2_dot
    w32 = w16 * w31
    w33 = link2_theta1_dot * (w30 + w19 * w26) + w32
    w34 = w28 - w33
    w35 = w34 * c11
    w36 = w22 * w35
    w37 = w18 * w24
    w38 = w27**2
    w39 = w16 * w24
    w40 = w21 * link2_theta2_dot
    w41 = link2_theta1_dot * w39 - w40
    w42 = w41**2
    w43 = (w38 + w42) * c11
    w44 = w37 * w43
    w45 = w16 * w18
    w46 = w19 * w45
    w47 = w15 * w21
    w48 = w46 - w47
    w49 = w23 * w41
    w50 = w16 * w29
    w51 = w19 * link2_theta2_dot
    w52 = w21 * w31
    w53 = link2_theta1_dot * (w50 - w21 * w51) - w52
    w54 = w49 - w53
    w55 = w54 * c11
    w56 = link1_theta1_dot * link1_theta2_dot
    w57 = w1 * w56
    w58 = ca.sin(link1_theta3)
    w59 = w1 * w58
    w60 = w1 * link1_theta3_dot
    w61 = ca.cos(link1_theta3)
    w62 = w60 * w61
    w63 = link1_theta2_dot * link1_theta3_dot
    w64 = w58 * w63
    w65 = link1_theta1_dot * (w62 - w9 * w58) - w64
    w66 = w1 * w61
    w67 = w58 * w60
    w68 = link1_theta2_dot * w61
    w69 = w61 * w63
    w70 = link1_theta1_dot * (w67 + w8 * w68) + w69
    w71 = w8 * w57 + w59 * w65 - w66 * w70
    w72 = w0 * w8
    w73 = w6 * w61
    w74 = w0 * w61
    w75 = w65 * (w58 * w72 - w73) - w2 * w57 - w70 * (w6 * w58 + w8 * w74)
    w76 = w8 * link1_end_x
    w77 = w8 * link1_theta3_dot
    w78 = link1_theta1_dot - w77
    w79 = w1 * w6
    w80 = w0 * link1_theta2_dot + link1_theta3_dot * w79
    w81 = w79 * link1_end_x
    w82 = w76 * w80 + w78 * w81
    w83 = w2 * link1_theta3_dot - w6 * link1_theta2_dot
    w84 = w81 * w83 - w3 * w80
    w85 = w3 * w71 + w75 * w76 - (w78 * w82 + w83 * w84)
    w86 = ca.cos(link3_theta1)
    w87 = ca.cos(link3_theta3)
    w88 = w86 * w87
    w89 = ca.sin(link3_theta1)
    w90 = ca.sin(link3_theta2)
    w91 = w89 * w90
    w92 = ca.sin(link3_theta3)
    w93 = w88 + w91 * w92
    w94 = link3_theta3_dot - w90 * link3_theta1_dot
    w95 = ca.cos(link3_theta2)
    w96 = w92 * w95
    w97 = w87 * link3_theta2_dot
    w98 = link3_theta1_dot * w96 + w97
    w99 = w94 * w98
    w100 = link3_theta3_dot * w95
    w101 = w92 * w100
    w102 = link3_theta3_dot * link3_theta2_dot
    w103 = w87 * w102
    w104 = link3_theta1_dot * (w101 + w90 * w97) + w103
    w105 = w99 - w104
    w106 = w105 * c13
    w107 = w93 * w106
    w108 = w89 * w95
    w109 = w98**2
    w110 = w87 * w95
    w111 = w92 * link3_theta2_dot
    w112 = link3_theta1_dot * w110 - w111
    w113 = w112**2
    w114 = (w109 + w113) * c13
    w115 = w108 * w114
    w116 = w87 * w89
    w117 = w90 * w116
    w118 = w86 * w92
    w119 = w117 - w118
    w120 = w94 * w112
    w121 = w87 * w100
    w122 = w90 * link3_theta2_dot
    w123 = w92 * w102
    w124 = link3_theta1_dot * (w121 - w92 * w122) - w123
    w125 = w120 - w124
    w126 = w125 * c13
    w127 = link2_theta1_dot * link2_theta2_dot
    w128 = w24 * w127
    w129 = w19 * w128 + w25 * w53 - w33 * w39
    w130 = w15 * w24
    w131 = w130 * link2_end_x
    w132 = w15 * w19
    w133 = w21 * w132 - w45
    w134 = w18 * w21
    w135 = w134 + w17 * w19
    w136 = w53 * w133 - w128 * w130 - w33 * w135
    w137 = w19 * link2_end_x
    w138 = w19 * link2_theta3_dot
    w139 = link2_theta1_dot - w138
    w140 = w15 * link2_theta2_dot + link2_theta3_dot * w37
    w141 = w37 * link2_end_x
    w142 = w137 * w140 + w139 * w141
    w143 = link2_theta3_dot * w130 - w18 * link2_theta2_dot
    w144 = w141 * w143 - w131 * w140
    w145 = w85 + (w129 * w131 + w136 * w137 - (w139 * w142 + w143 * w144))
    w146 = w107 - w115 + w119 * w126 + w145 * link3_mass
    w147 = w36 - w44 + w48 * w55 + w85 * link2_mass + w146
    w148 = w35 * w133 - w43 * w130 + w55 * w135
    w149 = w3 * w78 + w76 * w83
    w150 = w6 * w8
    w151 = w65 * (w74 + w58 * w150) - w57 * w79 - w70 * (w8 * w73 - w0 * w58)
    w152 = w80 * w84 - w78 * w149 - (w76 * w151 + w71 * w81)
    w153 = w86 * w90
    w154 = w92 * w153 - w116
    w155 = w86 * w95
    w156 = w89 * w92
    w157 = w156 + w88 * w90
    w158 = w106 * w154 - w114 * w155 + w126 * w157
    w159 = w131 * w139 + w137 * w143
    w160 = w22 * w53 - w37 * w128 - w33 * w48
    w161 = w152 + (w140 * w144 - w139 * w159 - (w137 * w160 + w129 * w141))
    w162 = w158 + w161 * link3_mass
    w163 = w148 + w152 * link2_mass + w162
    w164 = link1_theta1_dot * w7
    w165 = (w6 * w12 + (w1 * w164 + link1_theta2_dot * (w4 * w8) * c42)) * link1_end_x
    w166 = w165 * c9
    w167 = w0 * w76
    w168 = w6 * w76
    w169 = w75 * w81 - w3 * w151 + (w83 * w149 + w80 * w82)
    w170 = w169 - gravity_z
    w171 = w169 + (w136 * w141 - w131 * w160 + (w143 * w159 + w140 * w142)) - gravity_z
    w172 = w90 * w114 + w96 * w106 + w110 * w126 + w171 * link3_mass
    w173 = w130 * c11
    w174 = w173 + w131 * link3_mass
    w175 = w37 * c11
    w176 = w175 + w141 * link3_mass
    w177 = w19 * c11
    w178 = w15 * w137
    w179 = w132 * c44
    w180 = w18 * w137
    w181 = w20 * c44
    w182 = w155 * c13
    w183 = w108 * c13
    w184 = w90 * c13
    w185 = w86 * w184
    w186 = w89 * w184
    w187 = w4 * (w11 * link1_end_x)
    w188 = link1_theta2_dot * w9 * link1_end_x
    w189 = w187 - w76 * w164 + (w187 - w6 * w188)
    w190 = w189 * c9
    w191 = link1_theta3_dot - link1_theta1_dot * w8
    w192 = link1_theta2_dot * w58
    w193 = link1_theta1_dot * w66 - w192
    w194 = w191 * w193
    w195 = (w65 + w194) * c1 - (w194 - w65) * c3
    w196 = w8 * w58
    w197 = w1 * link1_theta1_dot
    w198 = w8 * w61
    w199 = link1_theta1_dot * w198
    w200 = w193 * w197 + w191 * w199
    w201 = link1_theta1_dot * (w61 * w77 + w11 * w58)
    w202 = (w200 + w201) * c1 + (w201 - w200) * c3
    w203 = w68 + link1_theta1_dot * w59
    w204 = w193 * w203
    w205 = w8 * w56
    w206 = link1_theta1_dot * w196
    w207 = w193 * w206 + w199 * w203
    w208 = (w205 - w207) * c0 + (w205 + w207) * c1
    w209 = w191 * w203
    w210 = (w209 - w70) * c3 - (w70 + w209) * c0
    w211 = w197 * w203 + w191 * w206
    w212 = link1_theta1_dot * (w1 * w68 - w58 * w77)
    w213 = (w211 + w212) * c3 + (w212 - w211) * c0
    w214 = w195 * w196 + w59 * w202 + (w1 * ((w204 - w57) * c0 - (w57 + w204) * c1) + w8 * w208) + (w198 * w210 + w66 * w213)
    w215 = w5 * w76 + (w0 * w188 + link1_theta2_dot * (w6 * w197) * c43)
    w216 = w215 * c9
    w217 = w1 * link1_end_x
    w218 = w58 * w213 - w61 * w202 - w8 * c28 - w163 * (w0 * w217) - w147 * (w6 * w217) + w76 * (w19 * w43 + w25 * w35 + w39 * w55 + w170 * link2_mass + w172)
    w219 = w4 * ((w1 * w4 - w6 * w9) * link1_end_x)
    w220 = w7 * ((w1 * w7 + w0 * w9) * link1_end_x)
    w221 = w219 - w81 * w164 + (w219 - w6 * w165) - (w3 * w5 - w220 + (w0 * w13 - w220))
    w222 = w24 * c11
    w223 = w24 * link2_end_x
    w224 = w95 * c13
    w225 = w69 + link1_theta1_dot * (w67 + w9 * w61)
    w226 = (w209 + w225) * c1 + (w225 - w209) * c3
    w227 = (w193**2 - w203**2) * c45
    w228 = link1_theta1_dot * (w62 - w8 * w192) - w64
    w229 = (w194 - w228) * c3 - (w194 + w228) * c0
    w230 = w15 * link2_theta1_dot
    w231 = link2_theta1_dot * w230
    w232 = w18 * link2_theta1_dot
    w233 = w51 * w232
    w234 = w24 * link2_theta2_dot
    w235 = link2_theta2_dot * w234
    w236 = (w24 * w231 - w233 + (w15 * w235 - w233)) * link2_end_x
    w237 = w236 * link3_mass
    w238 = w237 - w148
    w239 = link2_theta1_dot * w232
    w240 = (w18 * w235 + (w24 * w239 + link2_theta2_dot * (link2_theta1_dot * w132) * c42)) * link2_end_x
    w241 = w240 * link3_mass
    w242 = w44 - w36 + w55 * (w47 - w46) + w241
    w243 = w178 * w241 - (w180 * w237 - (w146 * w178 + (w85 * (w15 * w177) - w152 * (w18 * w177) - w162 * w180)))
    w244 = w230 * (w234 * link2_end_x)
    w245 = link2_theta2_dot * w51 * link2_end_x
    w246 = w244 - w137 * w239 + (w244 - w18 * w245)
    w247 = w246 * link3_mass
    w248 = link2_theta1_dot * w24
    w249 = w19 * w21
    w250 = link2_theta1_dot * w249
    w251 = w27 * w248 + w23 * w250
    w252 = link2_theta1_dot * (w24 * w26 - w21 * w138)
    w253 = w251 + w252
    w254 = w253 * c11
    w255 = 2 * w27
    w256 = 2 * w41
    w257 = w16 * w19
    w258 = link2_theta1_dot * w257
    w259 = (w250 * w255 + w256 * w258) * c11
    w260 = link2_theta1_dot * (w16 * w138 + w21 * w234)
    w261 = w41 * w248 + w23 * w258
    w262 = w260 - w261
    w263 = w262 * c11
    w264 = w247 - (w35 * (w21 * w37) - w22 * w254 + (w20 * w43 + w37 * w259) + (w55 * (w24 * w45) + w48 * w263))
    w265 = w35 * (w21 * w130) - w133 * w254 + (w43 * w132 + w130 * w259) + (w55 * (w17 * w24) + w135 * w263)
    w266 = w24 * w232
    w267 = w137 * w231 + (w15 * w245 + link2_theta2_dot * w266 * c46)
    w268 = w267 * link3_mass
    w269 = w265 + w268
    w270 = w230 * ((w24 * w230 - w18 * w51) * link2_end_x)
    w271 = w232 * ((w266 + w15 * w51) * link2_end_x)
    w272 = w270 - w141 * w239 + (w270 - w18 * w240) - (w131 * w231 - w271 + (w15 * w236 - w271))
    w273 = w272 * link3_mass
    w274 = w217 * (w273 - (w24 * w43 - w19 * w259 - (w35 * w249 + w25 * w254) + (w39 * w263 - w55 * w257))) + w168 * w264
    w275 = (w49 + w53) * c15 - w54 * c17
    w276 = (w260 + w261) * c15 + w262 * c17
    w277 = w27 * w41
    w278 = w19 * w127
    w279 = w41 * w250 + w27 * w258
    w280 = (w278 - w279) * c14 + (w278 + w279) * c15
    w281 = w34 * c17 - (w28 + w33) * c14
    w282 = w253 * c17 + (w252 - w251) * c14
    w283 = w249 * w275 + w25 * w276 + (w24 * ((w277 - w128) * c14 - (w128 + w277) * c15) + w19 * w280) + (w257 * w281 + w39 * w282)
    w284 = w152 * (w20 * c11) - w85 * (w132 * c11) - w283 + w162 * (w20 * link2_end_x) - w146 * (w132 * link2_end_x)
    w285 = w21 * w282 - w16 * w276 - (w152 * (w15 * w222) + w85 * (w18 * w222) - w170 * w177) - w162 * (w15 * w223)
    w286 = link2_theta1_dot * (w50 - w19 * w40) - w52
    w287 = w49 - w286
    w288 = w287 * c11
    w289 = (w41 * w255 - w27 * w256) * c11
    w290 = w32 + link2_theta1_dot * (w30 + w16 * w51)
    w291 = w290 - w28
    w292 = w291 * c11
    w293 = w35 * (w134 + w16 * w132) + w133 * w288 - w130 * w289 + (w55 * (w45 - w19 * w47) + w135 * w292)
    w294 = w35 * (w16 * w20 - w47) + w22 * w288 - w37 * w289 + (w48 * w292 - w55 * (w17 + w19 * w134))
    w295 = w217 * (w19 * w289 + (w35 * w39 + w25 * w288) + (w39 * w292 - w25 * w55)) + w168 * w294 + w167 * w293
    w296 = (w28 + w290) * c15 + w291 * c17
    w297 = (w42 - w38) * c47
    w298 = w287 * c17 - (w49 + w286) * c14
    w299 = w115 - w107 + w126 * (w118 - w117)
    w300 = link3_theta1_dot * w95
    w301 = w90 * w92
    w302 = link3_theta1_dot * w301
    w303 = w98 * w300 + w94 * w302
    w304 = w90 * link3_theta3_dot
    w305 = link3_theta1_dot * (w95 * w97 - w92 * w304)
    w306 = w303 + w305
    w307 = w306 * c13
    w308 = 2 * w98
    w309 = 2 * w112
    w310 = w87 * w90
    w311 = link3_theta1_dot * w310
    w312 = (w302 * w308 + w309 * w311) * c13
    w313 = link3_theta1_dot * (w87 * w304 + w92 * (w95 * link3_theta2_dot))
    w314 = w112 * w300 + w94 * w311
    w315 = w313 - w314
    w316 = w315 * c13
    w317 = w106 * (w92 * w155) - w154 * w307 + (w114 * w153 + w155 * w312) + (w126 * (w88 * w95) + w157 * w316)
    w318 = w106 * (w92 * w108) - w93 * w307 + (w91 * w114 + w108 * w312) + (w126 * (w95 * w116) + w119 * w316)
    w319 = w95 * w114 - w90 * w312 - (w106 * w301 + w96 * w307) + (w110 * w316 - w126 * w310)
    w320 = (w120 + w124) * c22 - w125 * c24
    w321 = (w313 + w314) * c22 + w315 * c24
    w322 = w98 * w112
    w323 = link3_theta1_dot * link3_theta2_dot
    w324 = w95 * w323
    w325 = w90 * w323
    w326 = w112 * w302 + w98 * w311
    w327 = (w325 - w326) * c21 + (w325 + w326) * c22
    w328 = w105 * c24 - (w99 + w104) * c21
    w329 = w306 * c24 + (w305 - w303) * c21
    w330 = w301 * w320 + w96 * w321 + (w95 * ((w322 - w324) * c21 - (w322 + w324) * c22) + w90 * w327) + (w310 * w328 + w110 * w329)
    w331 = link3_theta1_dot * (w121 - w90 * w111) - w123
    w332 = w120 - w331
    w333 = w332 * c13
    w334 = (w112 * w308 - w98 * w309) * c13
    w335 = w103 + link3_theta1_dot * (w101 + w87 * w122)
    w336 = w335 - w99
    w337 = w336 * c13
    w338 = w106 * (w156 + w87 * w153) + w154 * w333 - w155 * w334 + (w126 * (w116 - w90 * w118) + w157 * w337)
    w339 = w106 * (w87 * w91 - w118) + w93 * w333 - w108 * w334 + (w119 * w337 - w126 * (w88 + w90 * w156))
    w340 = w90 * w334 + (w106 * w110 + w96 * w333) + (w110 * w337 - w96 * w126)
    w341 = (w99 + w335) * c22 + w336 * c24
    w342 = (w113 - w109) * c48
    w343 = w332 * c24 - (w120 + w331) * c21
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w14 + (w81 * w147 + w3 * w163) + w81 * w166,
            w3 * w190 - (w163 * (w150 * link1_end_x) - w214 - w147 * (w72 * link1_end_x)) + w81 * w216,
            w8 * w227 - (w66 * w195 - w59 * w226) - (w66 * w229 - w59 * w210), w3 * w238 + w81 * w242,
            w3 * w264 + w81 * w269, w81 * w293 - w3 * w294, w81 * w299 - w3 * w158, w81 * w317 - w3 * w318,
            w81 * w338 - w3 * w339,
        ),
        ca.horzcat(  # link1.theta2
            w166 * w167 - (w163 * w168 - w147 * w167 + w14 * w168),
            w167 * w216 - (w218 + w217 * (w221 * c9) + w168 * w190),
            w58 * w195 + w61 * w226 + (w61 * w210 + w58 * w229), w167 * w242 - w168 * w238, w167 * w269 - w274,
            w295, w158 * w168 + w167 * w299, w217 * w319 + w168 * w318 + w167 * w317,
            w217 * w340 + w168 * w339 + w167 * w338,
        ),
        ca.horzcat(0.0, -w208, -w227, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w13 * w174 + w165 * w176, w174 * w189 + w176 * w215, 0.0,
            w131 * w237 + (w141 * w146 + (w131 * w162 + (w85 * w175 + w152 * w173))) + w141 * w241,
            w131 * w247 - w284 + w141 * w268, w19 * w297 - (w39 * w275 - w25 * w296) - (w39 * w298 - w25 * w281),
            w141 * w299 - w131 * w158, w141 * w317 - w131 * w318, w141 * w338 - w131 * w339,
        ),
        ca.horzcat(  # link2.theta2
            w165 * w179 - w13 * w181, w179 * w215 - (w221 * (w24 * c44) + w181 * w189), 0.0, w243,
            w178 * w268 - (w285 - w146 * (w18 * w223) + w137 * w172 + w223 * w273 + w180 * w247),
            w21 * w275 + w16 * w296 + (w16 * w281 + w21 * w298), w158 * w180 + w178 * w299,
            w223 * w319 + w180 * w318 + w178 * w317, w223 * w340 + w180 * w339 + w178 * w338,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w280, -w297, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w13 * w182 + w165 * w183, w182 * w189 + w183 * w215, 0.0, w182 * w236 + w183 * w240,
            w182 * w246 + w183 * w267, 0.0, w145 * w183 + w161 * w182,
            w330 - (w161 * (w91 * c13) - w145 * (w153 * c13)),
            w90 * w342 - (w110 * w320 - w96 * w341) - (w110 * w343 - w96 * w328),
        ),
        ca.horzcat(  # link3.theta2
            w165 * w185 - w13 * w186, w185 * w215 - (w221 * w224 + w186 * w189), 0.0, w185 * w240 - w186 * w236,
            w185 * w267 - (w224 * w272 + w186 * w246), 0.0, w145 * w185 - w161 * w186,
            w161 * (w86 * w224) + w145 * (w89 * w224) - w171 * w184 - (w92 * w329 - w87 * w321),
            w92 * w320 + w87 * w341 + (w87 * w328 + w92 * w343),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w327, -w342),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    794 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link3_theta1_dot = q_i_dot[6]
    link3_theta2_dot = q_i_dot[7]
    link3_theta3_dot = q_i_dot[8]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    link1_end_x = c[6]
    link3_mass = c[8]
    c9 = c[9]
    c11 = c[11]
    link2_end_x = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c21 = c[21]
    c22 = c[22]
    c24 = c[24]
    c44 = c[44]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    # intermediate terms (204)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1 * link1_end_x
    w3 = ca.sin(link1_theta1)
    w4 = w3 * link1_theta1_dot
    w5 = ca.sin(link1_theta2)
    w6 = w5 * link1_theta2_dot
    w7 = (w1 * w4 + w0 * w6) * link1_end_x
    w8 = 2 * w7
    w9 = w8 * c9
    w10 = ca.sin(link1_theta3)
    w11 = w1 * w10
    w12 = link1_theta3_dot - link1_theta1_dot * w5
    w13 = ca.cos(link1_theta3)
    w14 = w1 * w13
    w15 = link1_theta1_dot * w14 - link1_theta2_dot * w10
    w16 = w12 * w14 - w5 * w15
    w17 = w1 * link1_theta3_dot
    w18 = w13 * w17 - w6 * w10
    w19 = (w16 + w18) * c1 - (w16 - w18) * c3
    w20 = link1_theta2_dot * w13
    w21 = link1_theta1_dot * w11 + w20
    w22 = w11 * w15 + w14 * w21
    w23 = w1 * link1_theta2_dot
    w24 = (w22 - w23) * c0 - (w22 + w23) * c1
    w25 = w11 * w12 - w5 * w21
    w26 = w10 * w17 + w5 * w20
    w27 = (w25 - w26) * c3 - (w25 + w26) * c0
    w28 = w1 * w3 * link1_end_x
    w29 = w0 * link1_theta1_dot
    w30 = (w1 * w29 - w3 * w6) * link1_end_x
    w31 = 2 * w30
    w32 = w31 * c9
    w33 = w5 * link1_end_x
    w34 = w3 * w33
    w35 = w0 * w33
    w36 = ca.cos(link2_theta1)
    w37 = ca.cos(link2_theta2)
    w38 = w36 * w37
    w39 = w38 * link2_end_x
    w40 = w38 * c11 + w39 * link3_mass
    w41 = ca.sin(link2_theta1)
    w42 = w37 * w41
    w43 = w42 * link2_end_x
    w44 = w42 * c11 + w43 * link3_mass
    w45 = ca.sin(link2_theta2)
    w46 = w45 * link2_end_x
    w47 = w41 * w46
    w48 = w41 * w45
    w49 = w48 * c44
    w50 = w36 * w46
    w51 = w36 * w45
    w52 = w51 * c44
    w53 = ca.cos(link3_theta1)
    w54 = ca.cos(link3_theta2)
    w55 = w53 * w54
    w56 = w55 * c13
    w57 = ca.sin(link3_theta1)
    w58 = w54 * w57
    w59 = w58 * c13
    w60 = ca.sin(link3_theta2)
    w61 = w60 * c13
    w62 = w57 * w61
    w63 = w53 * w61
    w64 = w23 * link1_end_x
    w65 = 2 * (w29 * w33 + w3 * w64)
    w66 = w65 * c9
    w67 = w12 * w13
    w68 = link1_theta1_dot * (w5 * w13) + link1_theta3_dot * w13
    w69 = (w67 - w68) * c3 - (w67 + w68) * c0
    w70 = w10 * w12
    w71 = link1_theta1_dot * (w5 * w10) + w10 * link1_theta3_dot
    w72 = (w70 + w71) * c1 + (w71 - w70) * c3
    w73 = w13 * w15 - w10 * w21
    w74 = w1 * link1_theta1_dot
    w75 = (w73 - w74) * c0 - (w73 + w74) * c1
    w76 = 2 * (w0 * w64 - w4 * w33)
    w77 = w76 * c9
    w78 = w1 * link1_end_x
    w79 = 2 * (w28 * w29 + w3 * w30 - (w2 * w4 + w0 * w7))
    w80 = w37 * link2_end_x
    w81 = w54 * c13
    w82 = (w15 + w15) * c1
    w83 = (w21 + w21) * c49
    w84 = w41 * link2_theta1_dot
    w85 = w45 * link2_theta2_dot
    w86 = (w37 * w84 + w36 * w85) * link2_end_x
    w87 = 2 * w86
    w88 = w87 * link3_mass
    w89 = ca.cos(link2_theta3)
    w90 = w36 * w89
    w91 = ca.sin(link2_theta3)
    w92 = w90 + w48 * w91
    w93 = link2_theta3_dot - w45 * link2_theta1_dot
    w94 = w37 * w91
    w95 = link2_theta2_dot * w89
    w96 = link2_theta1_dot * w94 + w95
    w97 = w93 * w94 - w45 * w96
    w98 = w37 * link2_theta3_dot
    w99 = w91 * w98 + w45 * w95
    w100 = w97 - w99
    w101 = w100 * c11
    w102 = 2 * w96
    w103 = w37 * w89
    w104 = link2_theta1_dot * w103 - link2_theta2_dot * w91
    w105 = 2 * w104
    w106 = (w94 * w102 + w103 * w105) * c11
    w107 = w41 * w89
    w108 = w45 * w107 - w36 * w91
    w109 = w93 * w103 - w45 * w104
    w110 = w89 * w98 - w85 * w91
    w111 = w109 - w110
    w112 = w111 * c11
    w113 = w88 - (w92 * w101 - w42 * w106 + w108 * w112)
    w114 = w36 * link2_theta1_dot
    w115 = (w37 * w114 - w41 * w85) * link2_end_x
    w116 = 2 * w115
    w117 = w116 * link3_mass
    w118 = w51 * w91 - w107
    w119 = w41 * w91 + w45 * w90
    w120 = w117 - (w101 * w118 - w38 * w106 + w112 * w119)
    w121 = (w109 + w110) * c15 - w111 * c17
    w122 = w94 * w104 + w96 * w103
    w123 = w37 * link2_theta2_dot
    w124 = (w122 - w123) * c14 - (w122 + w123) * c15
    w125 = w100 * c17 - (w97 + w99) * c14
    w126 = w123 * link2_end_x
    w127 = 2 * (w46 * w114 + w41 * w126)
    w128 = w127 * link3_mass
    w129 = w89 * w93
    w130 = link2_theta1_dot * (w45 * w89) + w89 * link2_theta3_dot
    w131 = w129 - w130
    w132 = w131 * c11
    w133 = (w89 * w102 - w91 * w105) * c11
    w134 = link2_theta1_dot * (w45 * w91) + w91 * link2_theta3_dot
    w135 = w91 * w93
    w136 = w134 - w135
    w137 = w136 * c11
    w138 = w128 - (w92 * w132 - w42 * w133 + w108 * w137)
    w139 = 2 * (w36 * w126 - w46 * w84)
    w140 = w139 * link3_mass
    w141 = w140 - (w118 * w132 - w38 * w133 + w119 * w137)
    w142 = 2 * (w43 * w114 + w41 * w115 - (w39 * w84 + w36 * w86))
    w143 = w142 * link3_mass
    w144 = w131 * c17 - (w129 + w130) * c14
    w145 = (w134 + w135) * c15 + w136 * c17
    w146 = w89 * w104 - w91 * w96
    w147 = w37 * link2_theta1_dot
    w148 = (w146 - w147) * c14 - (w146 + w147) * c15
    w149 = (w104 + w104) * c15
    w150 = (w96 + w96) * c50
    w151 = ca.sin(link3_theta3)
    w152 = ca.cos(link3_theta3)
    w153 = w57 * w152
    w154 = w53 * w60 * w151 - w153
    w155 = link3_theta3_dot - w60 * link3_theta1_dot
    w156 = w54 * w151
    w157 = w152 * link3_theta2_dot
    w158 = link3_theta1_dot * w156 + w157
    w159 = w155 * w156 - w60 * w158
    w160 = w54 * link3_theta3_dot
    w161 = w151 * w160 + w60 * w157
    w162 = w159 - w161
    w163 = w162 * c13
    w164 = 2 * w158
    w165 = w54 * w152
    w166 = link3_theta1_dot * w165 - w151 * link3_theta2_dot
    w167 = 2 * w166
    w168 = (w156 * w164 + w165 * w167) * c13
    w169 = w53 * w152
    w170 = w57 * w151 + w60 * w169
    w171 = w155 * w165 - w60 * w166
    w172 = w152 * w160 - w151 * (w60 * link3_theta2_dot)
    w173 = w171 - w172
    w174 = w173 * c13
    w175 = w154 * w163 - w55 * w168 + w170 * w174
    w176 = w169 + w151 * (w57 * w60)
    w177 = w60 * w153 - w53 * w151
    w178 = w163 * w176 - w58 * w168 + w174 * w177
    w179 = w60 * w168 + w156 * w163 + w165 * w174
    w180 = (w171 + w172) * c22 - w173 * c24
    w181 = w156 * w166 + w158 * w165
    w182 = w54 * link3_theta2_dot
    w183 = (w181 - w182) * c21 - (w181 + w182) * c22
    w184 = w162 * c24 - (w159 + w161) * c21
    w185 = w152 * w155
    w186 = link3_theta1_dot * (w60 * w152) + w152 * link3_theta3_dot
    w187 = w185 - w186
    w188 = w187 * c13
    w189 = (w152 * w164 - w151 * w167) * c13
    w190 = link3_theta1_dot * (w60 * w151) + w151 * link3_theta3_dot
    w191 = w151 * w155
    w192 = w190 - w191
    w193 = w192 * c13
    w194 = w154 * w188 - w55 * w189 + w170 * w193
    w195 = w176 * w188 - w58 * w189 + w177 * w193
    w196 = w60 * w189 + w156 * w188 + w165 * w193
    w197 = w187 * c24 - (w185 + w186) * c21
    w198 = (w190 + w191) * c22 + w192 * c24
    w199 = w152 * w166 - w151 * w158
    w200 = w54 * link3_theta1_dot
    w201 = (w199 - w200) * c21 - (w199 + w200) * c22
    w202 = (w166 + w166) * c22
    w203 = (w158 + w158) * c51
    # outputs
    dQ_hat_dq_i_dot = ca.SX(9, 9)
    # link1.theta1
    dQ_hat_dq_i_dot[0, 0] = w2 * w9 - (w11 * w19 - w5 * w24 + w14 * w27) - w28 * w32
    dQ_hat_dq_i_dot[0, 1] = w2 * w66 - (w14 * w69 - (w11 * w72 + w5 * w75)) - w28 * w77
    dQ_hat_dq_i_dot[0, 2] = -(w11 * w82 + w14 * w83)
    dQ_hat_dq_i_dot[0, 3] = w2 * w113 - w28 * w120
    dQ_hat_dq_i_dot[0, 4] = w2 * w138 - w28 * w141
    dQ_hat_dq_i_dot[0, 6] = w28 * w175 - w2 * w178
    dQ_hat_dq_i_dot[0, 7] = w28 * w194 - w2 * w195
    # link1.theta2
    dQ_hat_dq_i_dot[1, 0] = w10 * w27 - w13 * w19 - w9 * w34 - w32 * w35
    dQ_hat_dq_i_dot[1, 1] = w13 * w72 + w10 * w69 - w78 * (w79 * c9) - w34 * w66 - w35 * w77
    dQ_hat_dq_i_dot[1, 2] = w10 * w83 - w13 * w82
    dQ_hat_dq_i_dot[1, 3] = w78 * (w45 * w106 + w94 * w101 + w103 * w112) - w34 * w113 - w35 * w120
    dQ_hat_dq_i_dot[1, 4] = (w45 * w133 + w94 * w132 + w103 * w137 - w143) * w78 - w34 * w138 - w35 * w141
    dQ_hat_dq_i_dot[1, 6] = w78 * w179 + w34 * w178 + w35 * w175
    dQ_hat_dq_i_dot[1, 7] = w78 * w196 + w34 * w195 + w35 * w194
    # link1.theta3
    dQ_hat_dq_i_dot[2, 0] = -w24
    dQ_hat_dq_i_dot[2, 1] = -w75
    # link2.theta1
    dQ_hat_dq_i_dot[3, 0] = w8 * w40 - w31 * w44
    dQ_hat_dq_i_dot[3, 1] = w40 * w65 - w44 * w76
    dQ_hat_dq_i_dot[3, 3] = w39 * w88 - (w94 * w121 - w45 * w124 + w103 * w125) - w43 * w117
    dQ_hat_dq_i_dot[3, 4] = w39 * w128 - (w103 * w144 - (w94 * w145 + w45 * w148)) - w43 * w140
    dQ_hat_dq_i_dot[3, 5] = -(w94 * w149 + w103 * w150)
    dQ_hat_dq_i_dot[3, 6] = w43 * w175 - w39 * w178
    dQ_hat_dq_i_dot[3, 7] = w43 * w194 - w39 * w195
    # link2.theta2
    dQ_hat_dq_i_dot[4, 0] = -(w8 * w49 + w31 * w52)
    dQ_hat_dq_i_dot[4, 1] = w37 * c52 * w79 - w49 * w65 - w52 * w76
    dQ_hat_dq_i_dot[4, 3] = w91 * w125 - w89 * w121 - w47 * w88 - w50 * w117
    dQ_hat_dq_i_dot[4, 4] = w89 * w145 + w91 * w144 - w80 * w143 - w47 * w128 - w50 * w140
    dQ_hat_dq_i_dot[4, 5] = w91 * w150 - w89 * w149
    dQ_hat_dq_i_dot[4, 6] = w80 * w179 + w47 * w178 + w50 * w175
    dQ_hat_dq_i_dot[4, 7] = w80 * w196 + w47 * w195 + w50 * w194
    # link2.theta3
    dQ_hat_dq_i_dot[5, 3] = -w124
    dQ_hat_dq_i_dot[5, 4] = -w148
    # link3.theta1
    dQ_hat_dq_i_dot[6, 0] = w8 * w56 - w31 * w59
    dQ_hat_dq_i_dot[6, 1] = w56 * w65 - w59 * w76
    dQ_hat_dq_i_dot[6, 3] = w56 * w87 - w59 * w116
    dQ_hat_dq_i_dot[6, 4] = w56 * w127 - w59 * w139
    dQ_hat_dq_i_dot[6, 6] = w60 * w183 - w156 * w180 - w165 * w184
    dQ_hat_dq_i_dot[6, 7] = w156 * w198 + w60 * w201 - w165 * w197
    dQ_hat_dq_i_dot[6, 8] = -(w156 * w202 + w165 * w203)
    # link3.theta2
    dQ_hat_dq_i_dot[7, 0] = -(w8 * w62 + w31 * w63)
    dQ_hat_dq_i_dot[7, 1] = -(w79 * w81 + w62 * w65 + w63 * w76)
    dQ_hat_dq_i_dot[7, 3] = -(w62 * w87 + w63 * w116)
    dQ_hat_dq_i_dot[7, 4] = -(w81 * w142 + w62 * w127 + w63 * w139)
    dQ_hat_dq_i_dot[7, 6] = w151 * w184 - w152 * w180
    dQ_hat_dq_i_dot[7, 7] = w152 * w198 + w151 * w197
    dQ_hat_dq_i_dot[7, 8] = w151 * w203 - w152 * w202
    # link3.theta3
    dQ_hat_dq_i_dot[8, 6] = -w183
    dQ_hat_dq_i_dot[8, 7] = -w201
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 9 x 9) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    2025 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link3_theta1_dot = q_i_dot[6]
    link3_theta2_dot = q_i_dot[7]
    link3_theta3_dot = q_i_dot[8]
    link1_theta1_ddot = q_i_ddot[0]
    link1_theta2_ddot = q_i_ddot[1]
    link1_theta3_ddot = q_i_ddot[2]
    link2_theta1_ddot = q_i_ddot[3]
    link2_theta2_ddot = q_i_ddot[4]
    link2_theta3_ddot = q_i_ddot[5]
    link3_theta1_ddot = q_i_ddot[6]
    link3_theta2_ddot = q_i_ddot[7]
    link3_theta3_ddot = q_i_ddot[8]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c9 = c[9]
    c11 = c[11]
    link2_end_x = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c21 = c[21]
    c22 = c[22]
    c24 = c[24]
    gravity_z = c[27]
    c28 = c[28]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    # intermediate terms (469)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = w0 * link1_theta1_dot
    w5 = ca.sin(link1_theta1)
    w6 = link1_theta1_dot * w4 + w5 * link1_theta1_ddot
    w7 = link1_theta1_dot * w5
    w8 = ca.sin(link1_theta2)
    w9 = w8 * link1_theta2_dot
    w10 = w7 * w9
    w11 = w1 * link1_theta2_dot
    w12 = link1_theta2_dot * w11 + w8 * link1_theta2_ddot
    w13 = (w1 * w6 - w10 + (w0 * w12 - w10)) * link1_end_x
    w14 = w13 * c9
    w15 = ca.cos(link2_theta1)
    w16 = ca.cos(link2_theta3)
    w17 = w15 * w16
    w18 = ca.sin(link2_theta1)
    w19 = ca.sin(link2_theta2)
    w20 = w18 * w19
    w21 = ca.sin(link2_theta3)
    w22 = w17 + w20 * w21
    w23 = link2_theta3_dot - w19 * link2_theta1_dot
    w24 = ca.cos(link2_theta2)
    w25 = w21 * w24
    w26 = w16 * link2_theta2_dot
    w27 = link2_theta1_dot * w25 + w26
    w28 = w23 * w27
    w29 = w16 * w24
    w30 = link2_theta1_ddot * w29 - w21 * link2_theta2_ddot
    w31 = link2_theta3_dot * w24
    w32 = w21 * w31
    w33 = w32 + w19 * w26
    w34 = link2_theta3_dot * link2_theta2_dot
    w35 = w16 * w34
    w36 = link2_theta1_dot * w33 + w35
    w37 = w30 - w36
    w38 = w28 + w37
    w39 = w38 * c11
    w40 = w22 * w39
    w41 = w18 * w24
    w42 = w27**2
    w43 = w21 * link2_theta2_dot
    w44 = link2_theta1_dot * w29 - w43
    w45 = w44**2
    w46 = (w42 + w45) * c11
    w47 = w41 * w46
    w48 = w16 * w18
    w49 = w19 * w48
    w50 = w15 * w21
    w51 = w49 - w50
    w52 = w23 * w44
    w53 = w16 * w31
    w54 = w19 * link2_theta2_dot
    w55 = w53 - w21 * w54
    w56 = w21 * w34
    w57 = link2_theta1_dot * w55 - w56
    w58 = w25 * link2_theta1_ddot + w16 * link2_theta2_ddot
    w59 = w57 + w58
    w60 = w52 - w59
    w61 = w60 * c11
    w62 = link1_theta1_dot * link1_theta2_dot
    w63 = w1 * w62
    w64 = ca.sin(link1_theta3)
    w65 = w1 * w64
    w66 = w1 * link1_theta3_dot
    w67 = ca.cos(link1_theta3)
    w68 = w66 * w67
    w69 = w68 - w9 * w64
    w70 = link1_theta2_dot * link1_theta3_dot
    w71 = w64 * w70
    w72 = link1_theta1_dot * w69 - w71
    w73 = w1 * w67
    w74 = w64 * w66
    w75 = link1_theta2_dot * w67
    w76 = w74 + w8 * w75
    w77 = w67 * w70
    w78 = link1_theta1_dot * w76 + w77
    w79 = w8 * w63 + w65 * w72 - w73 * w78
    w80 = w0 * w8
    w81 = w5 * w67
    w82 = w0 * w67
    w83 = w72 * (w64 * w80 - w81) - w2 * w63 - w78 * (w5 * w64 + w8 * w82)
    w84 = w8 * link1_end_x
    w85 = w8 * link1_theta3_dot
    w86 = link1_theta1_dot - w85
    w87 = w1 * w5
    w88 = w0 * link1_theta2_dot + link1_theta3_dot * w87
    w89 = w87 * link1_end_x
    w90 = w84 * w88 + w86 * w89
    w91 = w2 * link1_theta3_dot - w5 * link1_theta2_dot
    w92 = w89 * w91 - w3 * w88
    w93 = w5 * w84
    w94 = w3 * w79 + w83 * w84 - (w86 * w90 + w91 * w92) + w3 * link1_theta1_ddot - link1_theta2_ddot * w93
    w95 = ca.cos(link3_theta1)
    w96 = ca.cos(link3_theta3)
    w97 = w95 * w96
    w98 = ca.sin(link3_theta1)
    w99 = ca.sin(link3_theta2)
    w100 = w98 * w99
    w101 = ca.sin(link3_theta3)
    w102 = w97 + w100 * w101
    w103 = link3_theta3_dot - w99 * link3_theta1_dot
    w104 = ca.cos(link3_theta2)
    w105 = w101 * w104
    w106 = w96 * link3_theta2_dot
    w107 = link3_theta1_dot * w105 + w106
    w108 = w103 * w107
    w109 = w96 * w104
    w110 = link3_theta1_ddot * w109 - w101 * link3_theta2_ddot
    w111 = link3_theta3_dot * w104
    w112 = w101 * w111
    w113 = w112 + w99 * w106
    w114 = link3_theta3_dot * link3_theta2_dot
    w115 = w96 * w114
    w116 = w110 - (link3_theta1_dot * w113 + w115)
    w117 = w108 + w116
    w118 = w117 * c13
    w119 = w102 * w118
    w120 = w98 * w104
    w121 = w107**2
    w122 = w101 * link3_theta2_dot
    w123 = link3_theta1_dot * w109 - w122
    w124 = w123**2
    w125 = (w121 + w124) * c13
    w126 = w120 * w125
    w127 = w96 * w98
    w128 = w99 * w127
    w129 = w95 * w101
    w130 = w128 - w129
    w131 = w103 * w123
    w132 = w96 * w111
    w133 = w99 * link3_theta2_dot
    w134 = w132 - w101 * w133
    w135 = w101 * w114
    w136 = w105 * link3_theta1_ddot + w96 * link3_theta2_ddot
    w137 = link3_theta1_dot * w134 - w135 + w136
    w138 = w131 - w137
    w139 = w138 * c13
    w140 = link2_theta1_dot * link2_theta2_dot
    w141 = w24 * w140
    w142 = w19 * w141 + w25 * w57 - w29 * w36
    w143 = w15 * w24
    w144 = w143 * link2_end_x
    w145 = w15 * w19
    w146 = w21 * w145 - w48
    w147 = w18 * w21
    w148 = w147 + w17 * w19
    w149 = w57 * w146 - w141 * w143 - w36 * w148
    w150 = w19 * link2_end_x
    w151 = w19 * link2_theta3_dot
    w152 = link2_theta1_dot - w151
    w153 = w15 * link2_theta2_dot + link2_theta3_dot * w41
    w154 = w41 * link2_end_x
    w155 = w150 * w153 + w152 * w154
    w156 = link2_theta3_dot * w143 - w18 * link2_theta2_dot
    w157 = w154 * w156 - w144 * w153
    w158 = w18 * w150
    w159 = w94 + (w142 * w144 + w149 * w150 - (w152 * w155 + w156 * w157)) + link2_theta1_ddot * w144 - link2_theta2_ddot * w158
    w160 = w119 - w126 + w130 * w139 + w159 * link3_mass
    w161 = w40 - w47 + w51 * w61 + w94 * link2_mass + w160
    w162 = w39 * w146 - w46 * w143 + w61 * w148
    w163 = w3 * w86 + w84 * w91
    w164 = w5 * w8
    w165 = w72 * (w82 + w64 * w164) - w63 * w87 - w78 * (w8 * w81 - w0 * w64)
    w166 = w0 * w84
    w167 = w88 * w92 - w86 * w163 - (w84 * w165 + w79 * w89) - link1_theta1_ddot * w89 - link1_theta2_ddot * w166
    w168 = w95 * w99
    w169 = w101 * w168 - w127
    w170 = w95 * w104
    w171 = w98 * w101
    w172 = w171 + w97 * w99
    w173 = w118 * w169 - w125 * w170 + w139 * w172
    w174 = w144 * w152 + w150 * w156
    w175 = w22 * w57 - w41 * w141 - w36 * w51
    w176 = w15 * w150
    w177 = w167 + (w153 * w157 - w152 * w174 - (w150 * w175 + w142 * w154)) - link2_theta1_ddot * w154 - link2_theta2_ddot * w176
    w178 = w173 + w177 * link3_mass
    w179 = w162 + w167 * link2_mass + w178
    w180 = w0 * link1_theta1_ddot - link1_theta1_dot * w7
    w181 = w4 * w9
    w182 = (w1 * w180 - w181 - (w181 + w5 * w12)) * link1_end_x
    w183 = w182 * c9
    w184 = w1 * link1_end_x
    w185 = w83 * w89 - w3 * w165 + (w91 * w163 + w88 * w90) - link1_theta2_ddot * w184
    w186 = w185 - gravity_z
    w187 = w24 * link2_end_x
    w188 = w185 + (w149 * w154 - w144 * w175 + (w156 * w174 + w153 * w155)) - link2_theta2_ddot * w187 - gravity_z
    w189 = w99 * w125 + w105 * w118 + w109 * w139 + w188 * link3_mass
    w190 = w143 * c11
    w191 = w190 + w144 * link3_mass
    w192 = w41 * c11
    w193 = w192 + w154 * link3_mass
    w194 = w19 * c11
    w195 = w20 * c44
    w196 = w145 * c44
    w197 = w170 * c13
    w198 = w120 * c13
    w199 = w99 * c13
    w200 = w98 * w199
    w201 = w95 * w199
    w202 = w11 * link1_end_x
    w203 = (w1 * link1_theta2_ddot - link1_theta2_dot * w9) * link1_end_x
    w204 = w5 * w203 + (w84 * w180 + link1_theta2_dot * (w2 * link1_theta1_dot) * c43)
    w205 = w204 * c9
    w206 = link1_theta3_dot - link1_theta1_dot * w8
    w207 = link1_theta2_dot * w64
    w208 = link1_theta1_dot * w73 - w207
    w209 = w206 * w208
    w210 = link1_theta1_ddot * w65 + link1_theta2_ddot * w67
    w211 = w72 + w210
    w212 = (w209 + w211) * c1 - (w209 - w211) * c3
    w213 = w8 * w64
    w214 = w1 * link1_theta1_dot
    w215 = w8 * w67
    w216 = link1_theta1_dot * w215
    w217 = w208 * w214 + w206 * w216
    w218 = link1_theta1_dot * (w67 * w85 + w11 * w64) + link1_theta1_ddot * w213
    w219 = (w217 + w218) * c1 + (w218 - w217) * c3
    w220 = w75 + link1_theta1_dot * w65
    w221 = w208 * w220
    w222 = link1_theta3_ddot - link1_theta1_ddot * w8 - w63
    w223 = w8 * w62 - w1 * link1_theta1_ddot
    w224 = link1_theta1_dot * w213
    w225 = w208 * w224 + w216 * w220
    w226 = (w223 - w225) * c0 + (w223 + w225) * c1
    w227 = w206 * w220
    w228 = link1_theta1_ddot * w73 - link1_theta2_ddot * w64
    w229 = w228 - w78
    w230 = (w227 + w229) * c3 - (w227 - w229) * c0
    w231 = w214 * w220 + w206 * w224
    w232 = link1_theta1_ddot * w215 + link1_theta1_dot * (w1 * w75 - w64 * w85)
    w233 = (w231 + w232) * c3 + (w232 - w231) * c0
    w234 = w212 * w213 + w65 * w219 + (w1 * ((w221 + w222) * c0 - (w221 - w222) * c1) + w8 * w226) + (w215 * w230 + w73 * w233)
    w235 = w7 * w202
    w236 = w0 * w203 - w235 - (w235 + w6 * w84)
    w237 = w236 * c9
    w238 = w1 * w4 - w5 * w9
    w239 = w238 * link1_end_x
    w240 = (w1 * w7 + w0 * w9) * link1_end_x
    w241 = w7 * w240
    w242 = w5 * w182 + (w89 * w180 + w4 * w238 * c43) - (w3 * w6 - w241 + (w0 * w13 - w241))
    w243 = w24 * c11
    w244 = w24 * c44
    w245 = w104 * c13
    w246 = w228 - (w77 + link1_theta1_dot * (w74 + w9 * w67))
    w247 = (w246 - w227) * c1 + (w227 + w246) * c3
    w248 = (w208**2 - w220**2) * c45
    w249 = w210 + (link1_theta1_dot * (w68 - w8 * w207) - w71)
    w250 = (w209 - w249) * c3 - (w209 + w249) * c0
    w251 = w15 * link2_theta1_dot
    w252 = link2_theta1_dot * w251 + w18 * link2_theta1_ddot
    w253 = w18 * link2_theta1_dot
    w254 = w54 * w253
    w255 = w24 * link2_theta2_dot
    w256 = link2_theta2_dot * w255 + w19 * link2_theta2_ddot
    w257 = (w24 * w252 - w254 + (w15 * w256 - w254)) * link2_end_x
    w258 = w257 * link3_mass
    w259 = w258 - w162
    w260 = w15 * link2_theta1_ddot - link2_theta1_dot * w253
    w261 = w54 * w251
    w262 = (w24 * w260 - w261 - (w261 + w18 * w256)) * link2_end_x
    w263 = w262 * link3_mass
    w264 = w263 - (w47 - w40 + w61 * (w50 - w49))
    w265 = w255 * link2_end_x
    w266 = (w24 * link2_theta2_ddot - link2_theta2_dot * w54) * link2_end_x
    w267 = w24 * w251
    w268 = w18 * w266 + (w150 * w260 + link2_theta2_dot * w267 * c46)
    w269 = w268 * link3_mass
    w270 = link2_theta1_dot * w24
    w271 = w19 * w21
    w272 = link2_theta1_dot * w271
    w273 = w27 * w270 + w23 * w272
    w274 = w16 * w19
    w275 = link2_theta1_ddot * w274 + link2_theta1_dot * (w24 * w26 - w21 * w151)
    w276 = w273 + w275
    w277 = w276 * c11
    w278 = 2 * w27
    w279 = 2 * w44
    w280 = link2_theta1_dot * w274
    w281 = (w272 * w278 + w279 * w280) * c11
    w282 = link2_theta1_dot * (w16 * w151 + w21 * w255) + link2_theta1_ddot * w271
    w283 = w44 * w270 + w23 * w280
    w284 = w282 - w283
    w285 = w284 * c11
    w286 = w269 - (w39 * (w21 * w41) - w22 * w277 + (w20 * w46 + w41 * w281) + (w61 * (w24 * w48) + w51 * w285))
    w287 = w253 * w265
    w288 = w15 * w266 - w287 - (w287 + w150 * w252)
    w289 = w288 * link3_mass
    w290 = w39 * (w21 * w143) - w146 * w277 + (w46 * w145 + w143 * w281) + (w61 * (w17 * w24) + w148 * w285)
    w291 = w289 - w290
    w292 = w267 - w18 * w54
    w293 = w292 * link2_end_x
    w294 = (w24 * w253 + w15 * w54) * link2_end_x
    w295 = w253 * w294
    w296 = w18 * w262 + (w154 * w260 + w251 * w292 * c46) - (w144 * w252 - w295 + (w15 * w257 - w295))
    w297 = w296 * link3_mass
    w298 = (w52 + w59) * c15 - w60 * c17
    w299 = (w282 + w283) * c15 + w284 * c17
    w300 = w27 * w44
    w301 = link2_theta3_ddot - w19 * link2_theta1_ddot - w141
    w302 = w19 * w140 - w24 * link2_theta1_ddot
    w303 = w44 * w272 + w27 * w280
    w304 = (w302 - w303) * c14 + (w302 + w303) * c15
    w305 = w38 * c17 - (w28 - w37) * c14
    w306 = w276 * c17 + (w275 - w273) * c14
    w307 = w271 * w298 + w25 * w299 + (w24 * ((w300 + w301) * c14 - (w300 - w301) * c15) + w19 * w304) + (w274 * w305 + w29 * w306)
    w308 = w167 * (w20 * c11) - w94 * (w145 * c11) - w307 + w178 * (w20 * link2_end_x) - w160 * (w145 * link2_end_x)
    w309 = w21 * w306 - w16 * w299 - (w167 * (w15 * w243) + w94 * (w18 * w243) - w186 * w194) - w178 * (w15 * w187)
    w310 = w58 + (link2_theta1_dot * (w53 - w19 * w43) - w56)
    w311 = w52 - w310
    w312 = w311 * c11
    w313 = (w44 * w278 - w27 * w279) * c11
    w314 = w30 - (w35 + link2_theta1_dot * (w32 + w16 * w54))
    w315 = w28 + w314
    w316 = w315 * c11
    w317 = w39 * (w147 + w16 * w145) + w146 * w312 - w143 * w313 + (w61 * (w48 - w19 * w50) - w148 * w316)
    w318 = w39 * (w16 * w20 - w50) + w22 * w312 - w41 * w313 - (w61 * (w17 + w19 * w147) + w51 * w316)
    w319 = w184 * (w19 * w313 + (w29 * w39 + w25 * w312) - (w25 * w61 + w29 * w316)) + w93 * w318 + w166 * w317
    w320 = (w314 - w28) * c15 + w315 * c17
    w321 = (w45 - w42) * c47
    w322 = w311 * c17 - (w52 + w310) * c14
    w323 = w126 - w119 + w139 * (w129 - w128)
    w324 = link3_theta1_dot * w104
    w325 = w99 * w101
    w326 = link3_theta1_dot * w325
    w327 = w107 * w324 + w103 * w326
    w328 = w96 * w99
    w329 = w99 * link3_theta3_dot
    w330 = link3_theta1_ddot * w328 + link3_theta1_dot * (w104 * w106 - w101 * w329)
    w331 = w327 + w330
    w332 = w331 * c13
    w333 = 2 * w107
    w334 = 2 * w123
    w335 = link3_theta1_dot * w328
    w336 = (w326 * w333 + w334 * w335) * c13
    w337 = w104 * link3_theta2_dot
    w338 = link3_theta1_dot * (w96 * w329 + w101 * w337) + link3_theta1_ddot * w325
    w339 = w123 * w324 + w103 * w335
    w340 = w338 - w339
    w341 = w340 * c13
    w342 = w118 * (w101 * w170) - w169 * w332 + (w125 * w168 + w170 * w336) + (w139 * (w97 * w104) + w172 * w341)
    w343 = w118 * (w101 * w120) - w102 * w332 + (w100 * w125 + w120 * w336) + (w139 * (w104 * w127) + w130 * w341)
    w344 = w104 * w125 - w99 * w336 - (w118 * w325 + w105 * w332) + (w109 * w341 - w139 * w328)
    w345 = (w131 + w137) * c22 - w138 * c24
    w346 = (w338 + w339) * c22 + w340 * c24
    w347 = w107 * w123
    w348 = link3_theta1_dot * link3_theta2_dot
    w349 = link3_theta3_ddot - w99 * link3_theta1_ddot - w104 * w348
    w350 = w99 * w348 - w104 * link3_theta1_ddot
    w351 = w123 * w326 + w107 * w335
    w352 = (w350 - w351) * c21 + (w350 + w351) * c22
    w353 = w117 * c24 - (w108 - w116) * c21
    w354 = w331 * c24 + (w330 - w327) * c21
    w355 = w325 * w345 + w105 * w346 + (w104 * ((w347 + w349) * c21 - (w347 - w349) * c22) + w99 * w352) + (w328 * w353 + w109 * w354)
    w356 = w136 + (link3_theta1_dot * (w132 - w99 * w122) - w135)
    w357 = w131 - w356
    w358 = w357 * c13
    w359 = (w123 * w333 - w107 * w334) * c13
    w360 = w110 - (w115 + link3_theta1_dot * (w112 + w96 * w133))
    w361 = w108 + w360
    w362 = w361 * c13
    w363 = w118 * (w171 + w96 * w168) + w169 * w358 - w170 * w359 + (w139 * (w127 - w99 * w129) - w172 * w362)
    w364 = w118 * (w96 * w100 - w129) + w102 * w358 - w120 * w359 - (w139 * (w97 + w99 * w171) + w130 * w362)
    w365 = w99 * w359 + (w109 * w118 + w105 * w358) - (w105 * w139 + w109 * w362)
    w366 = (w360 - w108) * c22 + w361 * c24
    w367 = (w124 - w121) * c48
    w368 = w357 * c24 - (w131 + w356) * c21
    w369 = 2 * w240
    w370 = w369 * c9
    w371 = w73 * w206 - w8 * w208
    w372 = (w69 + w371) * c1 - (w371 - w69) * c3
    w373 = w65 * w208 + w73 * w220
    w374 = (w373 - w11) * c0 - (w11 + w373) * c1
    w375 = w65 * w206 - w8 * w220
    w376 = (w375 - w76) * c3 - (w76 + w375) * c0
    w377 = 2 * w239
    w378 = w377 * c9
    w379 = 2 * (w4 * w84 + w5 * w202)
    w380 = w379 * c9
    w381 = w67 * w206
    w382 = w216 + link1_theta3_dot * w67
    w383 = (w381 - w382) * c3 - (w381 + w382) * c0
    w384 = w64 * w206
    w385 = w224 + w64 * link1_theta3_dot
    w386 = (w384 + w385) * c1 + (w385 - w384) * c3
    w387 = w67 * w208 - w64 * w220
    w388 = (w387 - w214) * c0 - (w214 + w387) * c1
    w389 = 2 * (w0 * w202 - w7 * w84)
    w390 = w389 * c9
    w391 = 2 * (w4 * w89 + w5 * w239 - (w3 * w7 + w0 * w240))
    w392 = (w208 + w208) * c1
    w393 = (w220 + w220) * c49
    w394 = 2 * w294
    w395 = w394 * link3_mass
    w396 = w23 * w25 - w19 * w27
    w397 = w396 - w33
    w398 = w397 * c11
    w399 = (w25 * w278 + w29 * w279) * c11
    w400 = w23 * w29 - w19 * w44
    w401 = w400 - w55
    w402 = w401 * c11
    w403 = w395 - (w22 * w398 - w41 * w399 + w51 * w402)
    w404 = 2 * w293
    w405 = w404 * link3_mass
    w406 = w405 - (w146 * w398 - w143 * w399 + w148 * w402)
    w407 = (w55 + w400) * c15 - w401 * c17
    w408 = w25 * w44 + w27 * w29
    w409 = (w408 - w255) * c14 - (w255 + w408) * c15
    w410 = w397 * c17 - (w33 + w396) * c14
    w411 = 2 * (w150 * w251 + w18 * w265)
    w412 = w411 * link3_mass
    w413 = w16 * w23
    w414 = w280 + w16 * link2_theta3_dot
    w415 = w413 - w414
    w416 = w415 * c11
    w417 = (w16 * w278 - w21 * w279) * c11
    w418 = w272 + w21 * link2_theta3_dot
    w419 = w21 * w23
    w420 = w418 - w419
    w421 = w420 * c11
    w422 = w412 - (w22 * w416 - w41 * w417 + w51 * w421)
    w423 = 2 * (w15 * w265 - w150 * w253)
    w424 = w423 * link3_mass
    w425 = w424 - (w146 * w416 - w143 * w417 + w148 * w421)
    w426 = 2 * (w154 * w251 + w18 * w293 - (w144 * w253 + w15 * w294))
    w427 = w426 * link3_mass
    w428 = w415 * c17 - (w413 + w414) * c14
    w429 = (w418 + w419) * c15 + w420 * c17
    w430 = w16 * w44 - w21 * w27
    w431 = (w430 - w270) * c14 - (w270 + w430) * c15
    w432 = (w44 + w44) * c15
    w433 = (w27 + w27) * c50
    w434 = w103 * w105 - w99 * w107
    w435 = w434 - w113
    w436 = w435 * c13
    w437 = (w105 * w333 + w109 * w334) * c13
    w438 = w103 * w109 - w99 * w123
    w439 = w438 - w134
    w440 = w439 * c13
    w441 = w169 * w436 - w170 * w437 + w172 * w440
    w442 = w102 * w436 - w120 * w437 + w130 * w440
    w443 = w99 * w437 + w105 * w436 + w109 * w440
    w444 = (w134 + w438) * c22 - w439 * c24
    w445 = w105 * w123 + w107 * w109
    w446 = (w445 - w337) * c21 - (w337 + w445) * c22
    w447 = w435 * c24 - (w113 + w434) * c21
    w448 = w96 * w103
    w449 = w335 + w96 * link3_theta3_dot
    w450 = w448 - w449
    w451 = w450 * c13
    w452 = (w96 * w333 - w101 * w334) * c13
    w453 = w326 + w101 * link3_theta3_dot
    w454 = w101 * w103
    w455 = w453 - w454
    w456 = w455 * c13
    w457 = w169 * w451 - w170 * w452 + w172 * w456
    w458 = w102 * w451 - w120 * w452 + w130 * w456
    w459 = w99 * w452 + w105 * w451 + w109 * w456
    w460 = w450 * c24 - (w448 + w449) * c21
    w461 = (w453 + w454) * c22 + w455 * c24
    w462 = w96 * w123 - w101 * w107
    w463 = (w462 - w324) * c21 - (w324 + w462) * c22
    w464 = (w123 + w123) * c22
    w465 = (w107 + w107) * c51
    w466 = w161 * (w5 * w184) - (w64 * w233 - w67 * w219 - w8 * c28 - w179 * (w0 * w184)) - w84 * (w19 * w46 + w25 * w39 + w29 * w61 + w186 * link2_mass + w189)
    w467 = w160 * w176 + (w94 * (w15 * w194) - w167 * (w18 * w194) - w158 * w178) - w158 * w258 - w176 * w263
    w468 = (w24 * w46 - w19 * w281 - (w39 * w271 + w25 * w277) + (w29 * w285 - w61 * w274) - w297) * w184 - w93 * w286
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w14 + (w89 * w161 + w3 * w179) - w89 * w183,
            w3 * w205 - (w179 * (w164 * link1_end_x) - w234 - w161 * (w80 * link1_end_x)) - w89 * w237,
            w8 * w248 - (w73 * w212 + w65 * w247) - (w73 * w250 - w65 * w230), w3 * w259 - w89 * w264,
            w3 * w286 - w89 * w291, w89 * w317 - w3 * w318, w89 * w323 - w3 * w173, w89 * w342 - w3 * w343,
            w89 * w363 - w3 * w364,
        ),
        ca.horzcat(  # link1.theta2
            w161 * w166 - w93 * w179 - w14 * w93 - w166 * w183,
            w466 - w184 * (w242 * c9) - w93 * w205 - w166 * w237,
            w67 * w230 + w64 * w250 - (w67 * w247 - w64 * w212), -(w93 * w259 + w166 * w264), w468 - w166 * w291,
            w319, w93 * w173 + w166 * w323, w184 * w344 + w93 * w343 + w166 * w342,
            w184 * w365 + w93 * w364 + w166 * w363,
        ),
        ca.horzcat(0.0, -w226, -w248, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w13 * w191 - w182 * w193, w191 * w204 - w193 * w236, 0.0,
            w144 * w258 + (w154 * w160 + (w144 * w178 + (w94 * w192 + w167 * w190))) - w154 * w263,
            w144 * w269 - w308 - w154 * w289, w19 * w321 - (w29 * w298 + w25 * w320) - (w29 * w322 - w25 * w305),
            w154 * w323 - w144 * w173, w154 * w342 - w144 * w343, w154 * w363 - w144 * w364,
        ),
        ca.horzcat(  # link2.theta2
            -(w13 * w195 + w182 * w196), -(w242 * w244 + w195 * w204 + w196 * w236), 0.0, w467,
            w160 * (w18 * w187) - w309 - w150 * w189 - w187 * w297 - w158 * w269 - w176 * w289,
            w16 * w305 + w21 * w322 - (w16 * w320 - w21 * w298), w158 * w173 + w176 * w323,
            w187 * w344 + w158 * w343 + w176 * w342, w187 * w365 + w158 * w364 + w176 * w363,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w304, -w321, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w13 * w197 - w182 * w198, w197 * w204 - w198 * w236, 0.0, w197 * w257 - w198 * w262,
            w197 * w268 - w198 * w288, 0.0, w159 * w198 + w177 * w197,
            w355 - (w177 * (w100 * c13) - w159 * (w168 * c13)),
            w99 * w367 - (w109 * w345 + w105 * w366) - (w109 * w368 - w105 * w353),
        ),
        ca.horzcat(  # link3.theta2
            -(w13 * w200 + w182 * w201), -(w242 * w245 + w200 * w204 + w201 * w236), 0.0,
            -(w200 * w257 + w201 * w262), -(w245 * w296 + w200 * w268 + w201 * w288), 0.0,
            w159 * w201 - w177 * w200,
            w177 * (w95 * w245) + w159 * (w98 * w245) - w188 * w199 - (w101 * w354 - w96 * w346),
            w96 * w353 + w101 * w368 - (w96 * w366 - w101 * w345),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w352, -w367),  # link3.theta3
    )
    J_v = ca.SX(9, 9)
    # link1.theta1
    J_v[0, 0] = w3 * w370 - (w65 * w372 - w8 * w374 + w73 * w376) - w89 * w378
    J_v[0, 1] = w3 * w380 - (w73 * w383 - (w65 * w386 + w8 * w388)) - w89 * w390
    J_v[0, 2] = -(w65 * w392 + w73 * w393)
    J_v[0, 3] = w3 * w403 - w89 * w406
    J_v[0, 4] = w3 * w422 - w89 * w425
    J_v[0, 6] = w89 * w441 - w3 * w442
    J_v[0, 7] = w89 * w457 - w3 * w458
    # link1.theta2
    J_v[1, 0] = w64 * w376 - w67 * w372 - w93 * w370 - w166 * w378
    J_v[1, 1] = w67 * w386 + w64 * w383 - w184 * (w391 * c9) - w93 * w380 - w166 * w390
    J_v[1, 2] = w64 * w393 - w67 * w392
    J_v[1, 3] = w184 * (w19 * w399 + w25 * w398 + w29 * w402) - w93 * w403 - w166 * w406
    J_v[1, 4] = (w19 * w417 + w25 * w416 + w29 * w421 - w427) * w184 - w93 * w422 - w166 * w425
    J_v[1, 6] = w184 * w443 + w93 * w442 + w166 * w441
    J_v[1, 7] = w184 * w459 + w93 * w458 + w166 * w457
    # link1.theta3
    J_v[2, 0] = -w374
    J_v[2, 1] = -w388
    # link2.theta1
    J_v[3, 0] = w191 * w369 - w193 * w377
    J_v[3, 1] = w191 * w379 - w193 * w389
    J_v[3, 3] = w144 * w395 - (w25 * w407 - w19 * w409 + w29 * w410) - w154 * w405
    J_v[3, 4] = w144 * w412 - (w29 * w428 - (w25 * w429 + w19 * w431)) - w154 * w424
    J_v[3, 5] = -(w25 * w432 + w29 * w433)
    J_v[3, 6] = w154 * w441 - w144 * w442
    J_v[3, 7] = w154 * w457 - w144 * w458
    # link2.theta2
    J_v[4, 0] = -(w195 * w369 + w196 * w377)
    J_v[4, 1] = -(w244 * w391 + w195 * w379 + w196 * w389)
    J_v[4, 3] = w21 * w410 - w16 * w407 - w158 * w395 - w176 * w405
    J_v[4, 4] = w16 * w429 + w21 * w428 - w187 * w427 - w158 * w412 - w176 * w424
    J_v[4, 5] = w21 * w433 - w16 * w432
    J_v[4, 6] = w187 * w443 + w158 * w442 + w176 * w441
    J_v[4, 7] = w187 * w459 + w158 * w458 + w176 * w457
    # link2.theta3
    J_v[5, 3] = -w409
    J_v[5, 4] = -w431
    # link3.theta1
    J_v[6, 0] = w197 * w369 - w198 * w377
    J_v[6, 1] = w197 * w379 - w198 * w389
    J_v[6, 3] = w197 * w394 - w198 * w404
    J_v[6, 4] = w197 * w411 - w198 * w423
    J_v[6, 6] = w99 * w446 - w105 * w444 - w109 * w447
    J_v[6, 7] = w105 * w461 + w99 * w463 - w109 * w460
    J_v[6, 8] = -(w105 * w464 + w109 * w465)
    # link3.theta2
    J_v[7, 0] = -(w200 * w369 + w201 * w377)
    J_v[7, 1] = -(w245 * w391 + w200 * w379 + w201 * w389)
    J_v[7, 3] = -(w200 * w394 + w201 * w404)
    J_v[7, 4] = -(w245 * w426 + w200 * w411 + w201 * w423)
    J_v[7, 6] = w101 * w447 - w96 * w444
    J_v[7, 7] = w96 * w461 + w101 * w460
    J_v[7, 8] = w101 * w465 - w96 * w464
    # link3.theta3
    J_v[8, 6] = -w446
    J_v[8, 7] = -w463
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 53) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    844 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 53)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link1_theta3_dot = q_i_dot[2]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link2_theta3_dot = q_i_dot[5]
    link3_theta1_dot = q_i_dot[6]
    link3_theta2_dot = q_i_dot[7]
    link3_theta3_dot = q_i_dot[8]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c11 = c[11]
    link2_end_x = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    gravity_z = c[27]
    c28 = c[28]
    c36 = c[36]
    c37 = c[37]
    # intermediate terms (238)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.sin(link3_theta1)
    w5 = ca.sin(link3_theta2)
    w6 = w5 * c13
    w7 = w4 * w6
    w8 = ca.cos(link3_theta3)
    w9 = ca.sin(link3_theta3)
    w10 = w8 * (w8 * c25) + w9 * (w9 * c26)
    w11 = w7 / w10
    w12 = ca.cos(link3_theta2)
    w13 = w4 * w12
    w14 = ca.cos(link3_theta1)
    w15 = w12 * w14
    w16 = w12 * c13
    w17 = w9 * w12
    w18 = w17 * c25
    w19 = w8 * w12
    w20 = w19 * c26
    w21 = w8 * w18 - w9 * w20
    w22 = w15 * c13 + w11 * w21
    w23 = w5 * c23
    w24 = w5 * w23
    w25 = w21 / w10
    w26 = w24 + w17 * w18 + w19 * w20 - w24 - w21 * w25
    w27 = w22 / w26
    w28 = w16 / w10
    w29 = w21 * w28
    w30 = w11 * w16 + w27 * w29
    w31 = ca.cos(link2_theta1)
    w32 = ca.sin(link2_theta2)
    w33 = ca.sin(link2_theta3)
    w34 = ca.cos(link2_theta3)
    w35 = ca.sin(link2_theta1)
    w36 = w34 * w35
    w37 = w31 * w32 * w33 - w36
    w38 = ca.cos(link2_theta2)
    w39 = link2_theta3_dot * w38
    w40 = link2_theta3_dot * link2_theta2_dot
    w41 = link2_theta1_dot * (w34 * w39 - w33 * (w32 * link2_theta2_dot)) - w33 * w40
    w42 = w31 * w38
    w43 = w38 * (link2_theta1_dot * link2_theta2_dot)
    w44 = w31 * w34
    w45 = w33 * w35 + w32 * w44
    w46 = w34 * link2_theta2_dot
    w47 = link2_theta1_dot * (w33 * w39 + w32 * w46) + w34 * w40
    w48 = w37 * w41 - w42 * w43 - w45 * w47
    w49 = w35 * w38
    w50 = w49 * link2_end_x
    w51 = w44 + w33 * (w32 * w35)
    w52 = w32 * w36 - w31 * w33
    w53 = w41 * w51 - w43 * w49 - w47 * w52
    w54 = w42 * link2_end_x
    w55 = link2_theta3_dot * w42 - w35 * link2_theta2_dot
    w56 = link2_theta1_dot - w32 * link2_theta3_dot
    w57 = w32 * link2_end_x
    w58 = w54 * w56 + w55 * w57
    w59 = w31 * link2_theta2_dot + link2_theta3_dot * w49
    w60 = w57 * w59 + w50 * w56
    w61 = w48 * w50 - w53 * w54 + (w55 * w58 + w59 * w60)
    w62 = w8 * w14
    w63 = link3_theta3_dot - w5 * link3_theta1_dot
    w64 = w8 * link3_theta2_dot
    w65 = w17 * link3_theta1_dot + w64
    w66 = w63 * w65
    w67 = w12 * link3_theta3_dot
    w68 = link3_theta3_dot * link3_theta2_dot
    w69 = link3_theta1_dot * (w9 * w67 + w5 * w64) + w8 * w68
    w70 = w66 - w69
    w71 = w70 * c13
    w72 = w19 * link3_theta1_dot - w9 * link3_theta2_dot
    w73 = (w65**2 + w72**2) * c13
    w74 = w4 * w8
    w75 = w63 * w72
    w76 = link3_theta1_dot * (w8 * w67 - w9 * (w5 * link3_theta2_dot)) - w9 * w68
    w77 = w75 - w76
    w78 = w77 * c13
    w79 = (w75 + w76) * c22 - w77 * c24
    w80 = w70 * c24 - (w66 + w69) * c21
    w81 = w8 * w79 - w9 * w80 + w16 * gravity_z
    w82 = w65 * w72
    w83 = w12 * (link3_theta1_dot * link3_theta2_dot)
    w84 = (w82 - w83) * c21 - (w82 + w83) * c22
    w85 = w5 * w84
    w86 = w25 * w81 - (w85 + (w17 * w79 - w85 + w19 * w80))
    w87 = w30 * w61 - ((w62 + w9 * (w4 * w5)) * w71 - w13 * w73 + (w5 * w74 - w9 * w14) * w78 + w11 * w81 + w27 * w86)
    w88 = link3_mass - w7 * w11 - w22 * w27
    w89 = w33 * w38
    w90 = w34 * w38
    w91 = w32 * w43 + w41 * w89 - w47 * w90
    w92 = w50 * w55 - w54 * w59
    w93 = w54 * w91 + w48 * w57 - (w56 * w60 + w55 * w92)
    w94 = w87 - w88 * w93
    w95 = link2_theta3_dot - w32 * link2_theta1_dot
    w96 = w46 + link2_theta1_dot * w89
    w97 = w95 * w96
    w98 = w97 - w47
    w99 = w98 * c11
    w100 = link2_theta1_dot * w90 - w33 * link2_theta2_dot
    w101 = (w96**2 + w100**2) * c11
    w102 = w95 * w100
    w103 = w102 - w41
    w104 = w103 * c11
    w105 = w6 * w14
    w106 = w105 / w10
    w107 = w21 * w106 - w13 * c13
    w108 = w107 / w26
    w109 = w7 * w106 + w22 * w108
    w110 = w59 * w92 - w56 * w58 - (w53 * w57 + w50 * w91)
    w111 = w38 * link2_end_x
    w112 = w30 * w111
    w113 = w35 * w57
    w114 = w112 - w88 * w113
    w115 = w32 * c11
    w116 = w31 * w57
    w117 = w114 - w35 * w115 + w109 * w116
    w118 = w29 / w26
    w119 = link3_mass - w16 * w28 - w29 * w118
    w120 = w111 * w119
    w121 = w16 * w106 + w29 * w108
    w122 = w111 * w121 + w109 * w113
    w123 = link3_mass - w105 * w106 - w107 * w108
    w124 = w122 - w116 * w123
    w125 = w34 * (w34 * c18) + w33 * (w33 * c19) + w111 * w120 - (w113 * w114 + w112 * w113) - (w116 * w124 + w116 * w122)
    w126 = w117 / w125
    w127 = w5 * w73 + w17 * w71 + w19 * w78 - c37 + w28 * w81 + w86 * w118 + w61 * w119
    w128 = (w41 + w102) * c15 - w103 * c17
    w129 = w98 * c17 - (w47 + w97) * c14
    w130 = w38 * c11
    w131 = w111 * w127 - (w34 * w128 - w33 * w129 + w130 * gravity_z) - w93 * w112 - w94 * w113 - w110 * w122
    w132 = w61 * w121 - (w71 * (w9 * (w5 * w14) - w74) - w15 * w73 + w78 * (w4 * w9 + w5 * w62) + w81 * w106 + w86 * w108)
    w133 = w132 + w93 * w109 - w110 * w123
    w134 = w131 - w116 * w133
    w135 = w54 * w88
    w136 = w89 * c18
    w137 = w90 * c19
    w138 = w54 * w109
    w139 = w34 * w136 - w33 * w137 + w54 * w114 + (w116 * w138 - w50 * w124)
    w140 = w42 * c11 + w135 + w50 * w109 - w126 * w139
    w141 = w32 * c16
    w142 = w32 * w141
    w143 = w138 + w50 * w123
    w144 = w139 / w125
    w145 = w142 + w89 * w136 + w90 * w137 + w54 * w135 + (w50 * w143 + w50 * w138) - w142 - w139 * w144
    w146 = w140 / w145
    w147 = w96 * w100
    w148 = (w147 - w43) * c14 - (w43 + w147) * c15
    w149 = w32 * w148
    w150 = w54 * w94 - (w89 * w128 - w149 + w90 * w129) + w110 * w138 - w50 * w133 - w149 - w134 * w144
    w151 = w30 * w113 - (w120 + w130) + w116 * w121
    w152 = w151 / w125
    w153 = w50 * w121 - w30 * w54 - w139 * w152
    w154 = w30 + w126 * w151 + w146 * w153
    w155 = ca.sin(link1_theta2)
    w156 = ca.sin(link1_theta3)
    w157 = ca.cos(link1_theta3)
    w158 = ca.sin(link1_theta1)
    w159 = w157 * w158
    w160 = w1 * link1_theta3_dot
    w161 = link1_theta3_dot * link1_theta2_dot
    w162 = link1_theta1_dot * (w157 * w160 - w156 * (w155 * link1_theta2_dot)) - w156 * w161
    w163 = w1 * (link1_theta1_dot * link1_theta2_dot)
    w164 = w0 * w157
    w165 = w157 * link1_theta2_dot
    w166 = link1_theta1_dot * (w156 * w160 + w155 * w165) + w157 * w161
    w167 = (w0 * w155 * w156 - w159) * w162 - w2 * w163 - (w156 * w158 + w155 * w164) * w166
    w168 = w1 * w158
    w169 = w168 * link1_end_x
    w170 = w162 * (w164 + w156 * (w155 * w158)) - w163 * w168 - w166 * (w155 * w159 - w0 * w156)
    w171 = w2 * link1_theta3_dot - w158 * link1_theta2_dot
    w172 = link1_theta1_dot - w155 * link1_theta3_dot
    w173 = w155 * link1_end_x
    w174 = w3 * w172 + w171 * w173
    w175 = w0 * link1_theta2_dot + link1_theta3_dot * w168
    w176 = w173 * w175 + w169 * w172
    w177 = w167 * w169 - w3 * w170 + (w171 * w174 + w175 * w176)
    w178 = w94 - (w51 * w99 - w49 * w101 + w52 * w104) + w109 * w110 - w126 * w134 - w146 * w150 + w154 * w177
    w179 = link2_mass + w88 - w117 * w126 - w140 * w146
    w180 = w1 * w156
    w181 = w1 * w157
    w182 = w155 * w163 + w162 * w180 - w166 * w181
    w183 = w169 * w171 - w3 * w175
    w184 = w3 * w182 + w167 * w173 - (w172 * w176 + w171 * w183)
    w185 = w178 - w179 * w184
    w186 = link1_theta3_dot - w155 * link1_theta1_dot
    w187 = link1_theta1_dot * w181 - w156 * link1_theta2_dot
    w188 = w186 * w187
    w189 = (w162 + w188) * c1 - (w188 - w162) * c3
    w190 = w165 + link1_theta1_dot * w180
    w191 = w187 * w190
    w192 = (w191 - w163) * c0 - (w163 + w191) * c1
    w193 = w155 * w192
    w194 = w186 * w190
    w195 = (w194 - w166) * c3 - (w166 + w194) * c0
    w196 = w124 - w31 * w115
    w197 = w196 / w125
    w198 = w49 * c11 + w143 + w139 * w197
    w199 = w198 / w145
    w200 = w140 * w199 - (w109 + w117 * w197)
    w201 = w3 * w200
    w202 = w175 * w183 - w172 * w174 - (w170 * w173 + w169 * w182)
    w203 = w153 * w199 - (w121 + w151 * w197)
    w204 = w133 - (w37 * w99 - w42 * w101 + w45 * w104) - w134 * w197 + w150 * w199 - w177 * w203 - w184 * w200
    w205 = link2_mass + w123 - w196 * w197 - w198 * w199
    w206 = w204 - w202 * w205
    w207 = w180 * c4
    w208 = w181 * c5
    w209 = w1 * link1_end_x
    w210 = w154 * w209
    w211 = w158 * w173
    w212 = w210 - w179 * w211
    w213 = w203 * w209 + w200 * w211
    w214 = w0 * w173
    w215 = w213 + w205 * w214
    w216 = w157 * w207 - w156 * w208 + w3 * w212 + (w169 * w215 - w201 * w214)
    w217 = w153 / w145
    w218 = link2_mass + w119 - w151 * w152 - w153 * w217
    w219 = w157 * (w157 * c4) + w156 * (w156 * c5) + w209 * (w209 * w218) - (w211 * w212 + w210 * w211) + (w214 * w215 + w213 * w214)
    w220 = w216 / w219
    w221 = w30 * w93 - (w127 + (w32 * w101 + w89 * w99 + w90 * w104 - c36)) + w110 * w121 - w134 * w152 - w150 * w217
    w222 = w202 * w213 - (w157 * w189 - w156 * w195 + w1 * c28 + w209 * (w221 - w177 * w218) + w184 * w210 + w185 * w211)
    w223 = w222 - w206 * w214
    w224 = w155 * c2
    w225 = w155 * w224
    w226 = w225 + w180 * w207 + w181 * w208 + w3 * (w3 * w179) - (w169 * (w201 - w169 * w205) + w169 * w201)
    w227 = (w3 * w185 - (w180 * w189 - w193 + w181 * w195) - w201 * w202 - w169 * w206 - w193 - w220 * w223) / (w226 - w225 - w216 * w220)
    w228 = (w223 - w216 * w227) / w219
    w229 = w184 + (w3 * w227 - w211 * w228)
    w230 = w202 - (w169 * w227 + w214 * w228)
    w231 = w177 - w209 * w228
    w232 = (w150 - (w140 * w229 - w198 * w230 + w153 * w231)) / w145
    w233 = (w134 - (w139 * w232 + w196 * w230 + w117 * w229 + w151 * w231)) / w125
    w234 = w110 + (w230 - w50 * w232 - w116 * w233)
    w235 = w93 + (w229 + w54 * w232 - w113 * w233)
    w236 = w61 + (w231 - w111 * w233)
    w237 = (w86 - (w107 * w234 + w22 * w235 + w29 * w236)) / w26
    # outputs
    q_i_ddot = ca.vertcat(
        w227,  # link1.theta1
        w228,  # link1.theta2
        (w224 * w227 - w192) / c2,  # link1.theta3
        w232,  # link2.theta1
        w233,  # link2.theta2
        (w141 * w232 - w148) / c16,  # link2.theta3
        w237,  # link3.theta1
        -((w81 + (w21 * w237 - w105 * w234 - w7 * w235 - w16 * w236)) / w10),  # link3.theta2
        (w23 * w237 - w84) / c23,  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 19) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 7) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 7) [1]: columns of the rotation matrix of the marker at a drawn point
    89 operations.
    """
    p = ca.SX.sym("p", 19)
    link1_end_x = p[16]
    link2_end_x = p[17]
    link3_end_x = p[18]
    # outputs
    positions = ca.SX(3, 7)
    positions[0, 2] = link1_end_x
    positions[0, 4] = link2_end_x
    positions[0, 6] = link3_end_x
    axes = ca.SX(9, 7)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
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
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
