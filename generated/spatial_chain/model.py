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
    gives c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    122 operations.
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
    # intermediate terms (19)
    w0 = (link1_inertia_xx + link1_inertia_yy + link1_inertia_zz) / 2.0
    w1 = w0 - link1_inertia_yy
    w2 = w0 - link1_inertia_zz
    w3 = w1 + w2
    w4 = w0 - link1_inertia_xx + link1_mass * link1_center_of_mass_x**2
    w5 = link2_mass + link3_mass
    w6 = link2_mass * link2_center_of_mass_x
    w7 = (link2_inertia_xx + link2_inertia_yy + link2_inertia_zz) / 2.0
    w8 = w7 - link2_inertia_yy
    w9 = w7 - link2_inertia_zz
    w10 = w8 + w9
    w11 = w7 - link2_inertia_xx + link2_mass * link2_center_of_mass_x**2
    w12 = link3_mass * link2_end_x
    w13 = (link3_inertia_xx + link3_inertia_yy + link3_inertia_zz) / 2.0
    w14 = w13 - link3_inertia_yy
    w15 = w13 - link3_inertia_zz
    w16 = w14 + w15
    w17 = w13 - link3_inertia_xx + link3_mass * link3_center_of_mass_x**2
    w18 = link1_mass * link1_center_of_mass_x
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
        link3_mass * link3_center_of_mass_x,  # c13
        w8,  # c14
        w9,  # c15
        w10,  # c16
        w11,  # c17
        w9 + w11,  # c18
        w8 + w11,  # c19
        link2_end_x * w12,  # c20
        w14,  # c21
        w15,  # c22
        w16,  # c23
        w17,  # c24
        w15 + w17,  # c25
        w14 + w17,  # c26
        gravity_z,  # gravity_z
        gravity_z * w18,  # c28
        link1_mass,  # link1_mass
        w18,  # c30
        -w3,  # c31
        -w10,  # c32
        -w16,  # c33
        link1_mass * gravity_z,  # c34
        link2_mass * gravity_z,  # c35
        link3_mass * gravity_z,  # c36
        -gravity_z,  # c37
        2.0,  # c38
        2 * link1_end_x,  # c39
        w6 + w12,  # c40
        2 * link2_end_x,  # c41
        -w1,  # c42
        -w8,  # c43
        -w14,  # c44
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 9 x 9) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 9) [N, N m]: condensed force S^T (Q* - M s)
    723 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 45)
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
        -(w80 * w179 - w52 * w182 + w83 * w183 + (w47 * w166 - w50 * w149)),  # link3.theta1
        -(w82 * w179 - w79 * w183 - (w54 * w149 + w55 * w166 + w63 * w171)),  # link3.theta2
        -w182,  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 9) [mixed]: dependent coordinates after one Newton step
    39 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    c = ca.SX.sym("c", 45)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link1_end_x = c[6]
    link2_end_x = c[12]
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
        -(w3 + ca.sin(link2_theta2) * link2_end_x),  # link3.z
    )
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    65 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 45)
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
        -(w4 + w7 * w8 * link2_end_x * link2_theta1_dot + w9 * w10 * link2_theta2_dot),  # link3.x
        w5 + link2_theta1_dot * (w7 * w9 * link2_end_x) - link2_theta2_dot * (w8 * w10),  # link3.y
        -(w6 + link2_theta2_dot * (w7 * link2_end_x)),  # link3.z
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 9) [mixed]: accelerations of the dependent coordinates
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 45)
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
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 9) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 9 x 18) [SI]: constraint Jacobian
    gives C_t (n_c = 9) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 9) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    440 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 45)
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
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    c = ca.SX.sym("c", 45)
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
    link1_mass = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    # intermediate terms (178)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1
    w3 = -(w2 * c30)
    w4 = ca.cos(link1_theta1)
    w5 = ca.sin(link1_theta2)
    w6 = w5 * c30
    w7 = -(w4 * w6)
    w8 = w0 * w4
    w9 = w8 * c30
    w10 = -(w1 * w6)
    w11 = w0 * c30
    w12 = -w11
    w13 = ca.sin(link1_theta3)
    w14 = w0 * w13
    w15 = ca.cos(link1_theta3)
    w16 = w0 * w15
    w17 = w15 * c4
    w18 = w13 * c5
    w19 = w14 * w17 - w16 * w18
    w20 = w5 * c31
    w21 = ca.cos(link2_theta2)
    w22 = ca.sin(link2_theta1)
    w23 = w21 * w22
    w24 = -(w23 * c11)
    w25 = ca.cos(link2_theta1)
    w26 = ca.sin(link2_theta2)
    w27 = w26 * c11
    w28 = -(w25 * w27)
    w29 = w21 * w25
    w30 = w29 * c11
    w31 = -(w22 * w27)
    w32 = w21 * c11
    w33 = -w32
    w34 = ca.sin(link2_theta3)
    w35 = w21 * w34
    w36 = ca.cos(link2_theta3)
    w37 = w21 * w36
    w38 = w36 * c18
    w39 = w34 * c19
    w40 = w35 * w38 - w37 * w39
    w41 = w26 * c32
    w42 = ca.cos(link3_theta2)
    w43 = ca.sin(link3_theta1)
    w44 = w42 * w43
    w45 = -(w44 * c13)
    w46 = ca.cos(link3_theta1)
    w47 = ca.sin(link3_theta2)
    w48 = w47 * c13
    w49 = -(w46 * w48)
    w50 = w42 * w46
    w51 = w50 * c13
    w52 = -(w43 * w48)
    w53 = w42 * c13
    w54 = -w53
    w55 = ca.sin(link3_theta3)
    w56 = w42 * w55
    w57 = ca.cos(link3_theta3)
    w58 = w42 * w57
    w59 = w57 * c25
    w60 = w55 * c26
    w61 = w56 * w59 - w58 * w60
    w62 = w47 * c33
    w63 = w16 * link1_theta1_dot - w13 * link1_theta2_dot
    w64 = w63 * c30
    w65 = w15 * link1_theta2_dot
    w66 = w14 * link1_theta1_dot + w65
    w67 = w66 * c30
    w68 = w63 * w64 + w66 * w67
    w69 = w1 * w15
    w70 = w13 * (w4 * w5) - w69
    w71 = w0 * link1_theta3_dot
    w72 = link1_theta2_dot * link1_theta3_dot
    w73 = link1_theta1_dot * (w13 * w71 + w5 * w65) + w15 * w72
    w74 = link1_theta3_dot - w5 * link1_theta1_dot
    w75 = w73 * c30 - w67 * w74
    w76 = w4 * w15
    w77 = w1 * w13 + w5 * w76
    w78 = link1_theta1_dot * (w15 * w71 - w13 * (w5 * link1_theta2_dot)) - w13 * w72
    w79 = w78 * c30 - w64 * w74
    w80 = w8 * w68 + w70 * w75 + w77 * w79
    w81 = w76 + w13 * (w1 * w5)
    w82 = w5 * w69 - w4 * w13
    w83 = w2 * w68 + w75 * w81 + w79 * w82
    w84 = w14 * w75 - w5 * w68 + w16 * w79
    w85 = w74 * c3
    w86 = w63 * c1
    w87 = w63 * w85 - w74 * w86 - w78 * c4
    w88 = w66 * c0
    w89 = w0 * (link1_theta1_dot * link1_theta2_dot)
    w90 = w66 * w86 - w63 * w88 + w89 * c2
    w91 = w74 * w88 - w66 * w85 + w73 * c5
    w92 = w14 * w87 - w5 * w90 + w16 * w91
    w93 = w15 * w87 - w13 * w91
    w94 = w37 * link2_theta1_dot - w34 * link2_theta2_dot
    w95 = w94 * c11
    w96 = w36 * link2_theta2_dot
    w97 = w35 * link2_theta1_dot + w96
    w98 = w97 * c11
    w99 = w94 * w95 + w97 * w98
    w100 = w22 * w36
    w101 = w34 * (w25 * w26) - w100
    w102 = w21 * link2_theta3_dot
    w103 = link2_theta2_dot * link2_theta3_dot
    w104 = link2_theta1_dot * (w34 * w102 + w26 * w96) + w36 * w103
    w105 = link2_theta3_dot - w26 * link2_theta1_dot
    w106 = w104 * c11 - w98 * w105
    w107 = w25 * w36
    w108 = w22 * w34 + w26 * w107
    w109 = link2_theta1_dot * (w36 * w102 - w34 * (w26 * link2_theta2_dot)) - w34 * w103
    w110 = w109 * c11 - w95 * w105
    w111 = w29 * w99 + w101 * w106 + w108 * w110
    w112 = w107 + w34 * (w22 * w26)
    w113 = w26 * w100 - w25 * w34
    w114 = w23 * w99 + w106 * w112 + w110 * w113
    w115 = w35 * w106 - w26 * w99 + w37 * w110
    w116 = w105 * c17
    w117 = w94 * c15
    w118 = w94 * w116 - w105 * w117 - w109 * c18
    w119 = w97 * c14
    w120 = w21 * (link2_theta1_dot * link2_theta2_dot)
    w121 = w97 * w117 - w94 * w119 + w120 * c16
    w122 = w105 * w119 - w97 * w116 + w104 * c19
    w123 = w35 * w118 - w26 * w121 + w37 * w122
    w124 = w36 * w118 - w34 * w122
    w125 = w58 * link3_theta1_dot - w55 * link3_theta2_dot
    w126 = w125 * c13
    w127 = w57 * link3_theta2_dot
    w128 = w56 * link3_theta1_dot + w127
    w129 = w128 * c13
    w130 = w125 * w126 + w128 * w129
    w131 = w43 * w57
    w132 = w42 * link3_theta3_dot
    w133 = link3_theta2_dot * link3_theta3_dot
    w134 = link3_theta1_dot * (w55 * w132 + w47 * w127) + w57 * w133
    w135 = link3_theta3_dot - w47 * link3_theta1_dot
    w136 = w134 * c13 - w129 * w135
    w137 = w46 * w57
    w138 = link3_theta1_dot * (w57 * w132 - w55 * (w47 * link3_theta2_dot)) - w55 * w133
    w139 = w138 * c13 - w126 * w135
    w140 = w50 * w130 + (w55 * (w46 * w47) - w131) * w136 + (w43 * w55 + w47 * w137) * w139
    w141 = w44 * w130 + w136 * (w137 + w55 * (w43 * w47)) + w139 * (w47 * w131 - w46 * w55)
    w142 = w56 * w136 - w47 * w130 + w58 * w139
    w143 = w135 * c24
    w144 = w125 * c22
    w145 = w125 * w143 - w135 * w144 - w138 * c25
    w146 = w128 * c21
    w147 = w128 * w144 - w125 * w146 + w42 * (link3_theta1_dot * link3_theta2_dot) * c23
    w148 = w135 * w146 - w128 * w143 + w134 * c26
    w149 = w56 * w145 - w47 * w147 + w58 * w148
    w150 = w57 * w145 - w55 * w148
    w151 = w11 * gravity_z
    w152 = w32 * gravity_z
    w153 = w53 * gravity_z
    w154 = w2 * link1_end_x
    w155 = w8 * link1_end_x
    w156 = w5 * link1_end_x
    w157 = w23 * link2_end_x
    w158 = w29 * link2_end_x
    w159 = w26 * link2_end_x
    w160 = w4 * link1_theta2_dot + w2 * link1_theta3_dot
    w161 = w8 * link1_theta3_dot - w1 * link1_theta2_dot
    w162 = w154 * w161 - w155 * w160
    w163 = link1_theta1_dot - w5 * link1_theta3_dot
    w164 = w155 * w163 + w156 * w161
    w165 = w78 * w81 - w2 * w89 - w73 * w82
    w166 = w5 * w89 + w14 * w78 - w16 * w73
    w167 = w70 * w78 - w8 * w89 - w73 * w77
    w168 = w156 * w160 + w154 * w163
    w169 = w25 * link2_theta2_dot + w23 * link2_theta3_dot
    w170 = w29 * link2_theta3_dot - w22 * link2_theta2_dot
    w171 = w157 * w170 - w158 * w169
    w172 = link2_theta1_dot - w26 * link2_theta3_dot
    w173 = w158 * w172 + w159 * w170
    w174 = w109 * w112 - w23 * w120 - w104 * w113
    w175 = w26 * w120 + w35 * w109 - w37 * w104
    w176 = w101 * w109 - w29 * w120 - w104 * w108
    w177 = w159 * w169 + w157 * w172
    # outputs
    M = ca.SX(18, 18)
    # link1.x
    M[0, 0] = link1_mass
    M[0, 3] = w3
    M[0, 4] = w7
    # link1.y
    M[1, 1] = link1_mass
    M[1, 3] = w9
    M[1, 4] = w10
    # link1.z
    M[2, 2] = link1_mass
    M[2, 4] = w12
    # link1.theta1
    M[3, 0] = w3
    M[3, 1] = w9
    M[3, 3] = w5 * (w5 * c2) + w14 * (w14 * c4) + w16 * (w16 * c5)
    M[3, 4] = w19
    M[3, 5] = w20
    # link1.theta2
    M[4, 0] = w7
    M[4, 1] = w10
    M[4, 2] = w12
    M[4, 3] = w19
    M[4, 4] = w15 * w17 + w13 * w18
    # link1.theta3
    M[5, 3] = w20
    M[5, 5] = c2
    # link2.x
    M[6, 6] = link2_mass
    M[6, 9] = w24
    M[6, 10] = w28
    # link2.y
    M[7, 7] = link2_mass
    M[7, 9] = w30
    M[7, 10] = w31
    # link2.z
    M[8, 8] = link2_mass
    M[8, 10] = w33
    # link2.theta1
    M[9, 6] = w24
    M[9, 7] = w30
    M[9, 9] = w26 * (w26 * c16) + w35 * (w35 * c18) + w37 * (w37 * c19)
    M[9, 10] = w40
    M[9, 11] = w41
    # link2.theta2
    M[10, 6] = w28
    M[10, 7] = w31
    M[10, 8] = w33
    M[10, 9] = w40
    M[10, 10] = w36 * w38 + w34 * w39
    # link2.theta3
    M[11, 9] = w41
    M[11, 11] = c16
    # link3.x
    M[12, 12] = link3_mass
    M[12, 15] = w45
    M[12, 16] = w49
    # link3.y
    M[13, 13] = link3_mass
    M[13, 15] = w51
    M[13, 16] = w52
    # link3.z
    M[14, 14] = link3_mass
    M[14, 16] = w54
    # link3.theta1
    M[15, 12] = w45
    M[15, 13] = w51
    M[15, 15] = w47 * (w47 * c23) + w56 * (w56 * c25) + w58 * (w58 * c26)
    M[15, 16] = w61
    M[15, 17] = w62
    # link3.theta2
    M[16, 12] = w49
    M[16, 13] = w52
    M[16, 14] = w54
    M[16, 15] = w61
    M[16, 16] = w57 * w59 + w55 * w60
    # link3.theta3
    M[17, 15] = w62
    M[17, 17] = c23
    K = ca.SX(18, 18)
    Q_v = ca.vertcat(
        w80,  # link1.x
        w83,  # link1.y
        w84,  # link1.z
        w92,  # link1.theta1
        w93,  # link1.theta2
        w90,  # link1.theta3
        w111,  # link2.x
        w114,  # link2.y
        w115,  # link2.z
        w123,  # link2.theta1
        w124,  # link2.theta2
        w121,  # link2.theta3
        w140,  # link3.x
        w141,  # link3.y
        w142,  # link3.z
        w149,  # link3.theta1
        w150,  # link3.theta2
        w147,  # link3.theta3
    )
    Q_F = ca.SX(18, 1)
    Q_F[2] = c34  # link1.z
    Q_F[4] = -w151  # link1.theta2
    Q_F[8] = c35  # link2.z
    Q_F[10] = -w152  # link2.theta2
    Q_F[14] = c36  # link3.z
    Q_F[16] = -w153  # link3.theta2
    Q_star = ca.vertcat(
        w80,  # link1.x
        w83,  # link1.y
        w84 + c34,  # link1.z
        w92,  # link1.theta1
        w93 - w151,  # link1.theta2
        w90,  # link1.theta3
        w111,  # link2.x
        w114,  # link2.y
        w115 + c35,  # link2.z
        w123,  # link2.theta1
        w124 - w152,  # link2.theta2
        w121,  # link2.theta3
        w140,  # link3.x
        w141,  # link3.y
        w142 + c36,  # link3.z
        w149,  # link3.theta1
        w150 - w153,  # link3.theta2
        w147,  # link3.theta3
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
    C_q[3, 3] = w154
    C_q[3, 4] = w4 * w156
    C_q[3, 6] = 1.0
    # joint2.y
    C_q[4, 1] = -1.0
    C_q[4, 3] = -w155
    C_q[4, 4] = w1 * w156
    C_q[4, 7] = 1.0
    # joint2.z
    C_q[5, 2] = -1.0
    C_q[5, 4] = w0 * link1_end_x
    C_q[5, 8] = 1.0
    # joint3.x
    C_q[6, 6] = -1.0
    C_q[6, 9] = w157
    C_q[6, 10] = w25 * w159
    C_q[6, 12] = 1.0
    # joint3.y
    C_q[7, 7] = -1.0
    C_q[7, 9] = -w158
    C_q[7, 10] = w22 * w159
    C_q[7, 13] = 1.0
    # joint3.z
    C_q[8, 8] = -1.0
    C_q[8, 10] = w21 * link2_end_x
    C_q[8, 14] = 1.0
    gamma_b = ca.vertcat(
        0.0,  # joint1.x
        0.0,  # joint1.y
        0.0,  # joint1.z
        w160 * w162 - w163 * w164 - (w156 * w165 + w154 * w166),  # joint2.x
        w155 * w166 + w156 * w167 - (w163 * w168 + w161 * w162),  # joint2.y
        w161 * w164 + w160 * w168 + (w154 * w167 - w155 * w165),  # joint2.z
        w169 * w171 - w172 * w173 - (w159 * w174 + w157 * w175),  # joint3.x
        w158 * w175 + w159 * w176 - (w172 * w177 + w170 * w171),  # joint3.y
        w170 * w173 + w169 * w177 + (w157 * w176 - w158 * w174),  # joint3.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 18) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 18) [mixed]: rates of all coordinates
    takes q_ddot (n = 18) [mixed]: accelerations of all coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 9) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 3) [N, N m]: world force and moment of a joint on its body b, at b
    373 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    q_ddot = ca.SX.sym("q_ddot", 18)
    c = ca.SX.sym("c", 45)
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
    link1_mass = c[29]
    c30 = c[30]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    # intermediate terms (87)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = ca.cos(link1_theta3)
    w4 = w1 * w3
    w5 = ca.sin(link1_theta3)
    w6 = link1_theta1_dot * w4 - link1_theta2_dot * w5
    w7 = w6 * c30
    w8 = w1 * w5
    w9 = w3 * link1_theta2_dot
    w10 = link1_theta1_dot * w8 + w9
    w11 = w10 * c30
    w12 = w6 * w7 + w10 * w11
    w13 = ca.sin(link1_theta2)
    w14 = ca.sin(link1_theta1)
    w15 = w3 * w14
    w16 = w1 * link1_theta3_dot
    w17 = link1_theta2_dot * link1_theta3_dot
    w18 = link1_theta3_dot - link1_theta1_dot * w13
    w19 = (link1_theta1_dot * (w5 * w16 + w9 * w13) + w3 * w17) * c30 - w11 * w18
    w20 = w0 * w3
    w21 = (link1_theta1_dot * (w3 * w16 - w5 * (link1_theta2_dot * w13)) - w5 * w17) * c30 - w7 * w18
    w22 = w1 * w14
    w23 = w13 * c30
    w24 = w2 * w12 + (w5 * (w0 * w13) - w15) * w19 + (w5 * w14 + w13 * w20) * w21 - (link1_x_ddot * link1_mass - w22 * c30 * link1_theta1_ddot - w0 * w23 * link1_theta2_ddot)
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
    w77 = w12 * w22 + w19 * (w20 + w5 * (w13 * w14)) + w21 * (w13 * w15 - w0 * w5) - (link1_y_ddot * link1_mass + link1_theta1_ddot * (w2 * c30) - link1_theta2_ddot * (w14 * w23))
    w78 = w37 * w47 + w44 * (w45 + w30 * (w38 * w39)) + w46 * (w38 * w40 - w25 * w30) - (link2_y_ddot * link2_mass + link2_theta1_ddot * (w27 * c11) - link2_theta2_ddot * (w39 * w48))
    w79 = w62 * w72 + w69 * (w70 + w55 * (w63 * w64)) + w71 * (w63 * w65 - w50 * w55) - (link3_y_ddot * link3_mass + link3_theta1_ddot * (w52 * c13) - link3_theta2_ddot * (w64 * w73))
    w80 = w78 + w79
    w81 = w77 + w80
    w82 = c34 + (w8 * w19 - w12 * w13 + w4 * w21) - (link1_z_ddot * link1_mass - link1_theta2_ddot * (w1 * c30))
    w83 = c35 + (w33 * w44 - w37 * w38 + w29 * w46) - (link2_z_ddot * link2_mass - link2_theta2_ddot * (w26 * c11))
    w84 = c36 + (w58 * w69 - w62 * w63 + w54 * w71) - (link3_z_ddot * link3_mass - link3_theta2_ddot * (w51 * c13))
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
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    296 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 45)
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
    link1_mass = c[29]
    c30 = c[30]
    c37 = c[37]
    # intermediate terms (69)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1 * c30
    w3 = ca.cos(link1_theta1)
    w4 = ca.sin(link1_theta2)
    w5 = w4 * c30
    w6 = w3 * w5
    w7 = w0 * w3 * c30
    w8 = w1 * w5
    w9 = link1_x_dot * (link1_x_dot * link1_mass - w2 * link1_theta1_dot - w6 * link1_theta2_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta1_dot * w7 - link1_theta2_dot * w8)
    w10 = w0 * c30
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
        (link1_z * link1_mass - w5 + (link2_z * link2_mass - w28) + (link3_z * link3_mass - w51)) * c37,
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
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i, through q_d
    1345 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 45)
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
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    # intermediate terms (347)
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
    w165 = (w6 * w12 + (w1 * w164 + link1_theta2_dot * (w4 * w8) * c38)) * link1_end_x
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
    w179 = w132 * c40
    w180 = w18 * w137
    w181 = w20 * c40
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
    w215 = w5 * w76 + (w0 * w188 + link1_theta2_dot * (w6 * w197) * c39)
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
    w227 = w193**2 - w203**2
    w228 = w227 * c0 - w227 * c1
    w229 = link1_theta1_dot * (w62 - w8 * w192) - w64
    w230 = (w194 - w229) * c3 - (w194 + w229) * c0
    w231 = w15 * link2_theta1_dot
    w232 = link2_theta1_dot * w231
    w233 = w18 * link2_theta1_dot
    w234 = w51 * w233
    w235 = w24 * link2_theta2_dot
    w236 = link2_theta2_dot * w235
    w237 = (w24 * w232 - w234 + (w15 * w236 - w234)) * link2_end_x
    w238 = w237 * link3_mass
    w239 = w238 - w148
    w240 = link2_theta1_dot * w233
    w241 = (w18 * w236 + (w24 * w240 + link2_theta2_dot * (link2_theta1_dot * w132) * c38)) * link2_end_x
    w242 = w241 * link3_mass
    w243 = w44 - w36 + w55 * (w47 - w46) + w242
    w244 = w178 * w242 - (w180 * w238 - (w146 * w178 + (w85 * (w15 * w177) - w152 * (w18 * w177) - w162 * w180)))
    w245 = w231 * (w235 * link2_end_x)
    w246 = link2_theta2_dot * w51 * link2_end_x
    w247 = w245 - w137 * w240 + (w245 - w18 * w246)
    w248 = w247 * link3_mass
    w249 = link2_theta1_dot * w24
    w250 = w19 * w21
    w251 = link2_theta1_dot * w250
    w252 = w27 * w249 + w23 * w251
    w253 = link2_theta1_dot * (w24 * w26 - w21 * w138)
    w254 = w252 + w253
    w255 = w254 * c11
    w256 = 2 * w27
    w257 = 2 * w41
    w258 = w16 * w19
    w259 = link2_theta1_dot * w258
    w260 = (w251 * w256 + w257 * w259) * c11
    w261 = link2_theta1_dot * (w16 * w138 + w21 * w235)
    w262 = w41 * w249 + w23 * w259
    w263 = w261 - w262
    w264 = w263 * c11
    w265 = w248 - (w35 * (w21 * w37) - w22 * w255 + (w20 * w43 + w37 * w260) + (w55 * (w24 * w45) + w48 * w264))
    w266 = w35 * (w21 * w130) - w133 * w255 + (w43 * w132 + w130 * w260) + (w55 * (w17 * w24) + w135 * w264)
    w267 = w24 * w233
    w268 = w137 * w232 + (w15 * w246 + link2_theta2_dot * w267 * c41)
    w269 = w268 * link3_mass
    w270 = w266 + w269
    w271 = w231 * ((w24 * w231 - w18 * w51) * link2_end_x)
    w272 = w233 * ((w267 + w15 * w51) * link2_end_x)
    w273 = w271 - w141 * w240 + (w271 - w18 * w241) - (w131 * w232 - w272 + (w15 * w237 - w272))
    w274 = w273 * link3_mass
    w275 = w217 * (w274 - (w24 * w43 - w19 * w260 - (w35 * w250 + w25 * w255) + (w39 * w264 - w55 * w258))) + w168 * w265
    w276 = (w49 + w53) * c15 - w54 * c17
    w277 = (w261 + w262) * c15 + w263 * c17
    w278 = w27 * w41
    w279 = w19 * w127
    w280 = w41 * w251 + w27 * w259
    w281 = (w279 - w280) * c14 + (w279 + w280) * c15
    w282 = w34 * c17 - (w28 + w33) * c14
    w283 = w254 * c17 + (w253 - w252) * c14
    w284 = w250 * w276 + w25 * w277 + (w24 * ((w278 - w128) * c14 - (w128 + w278) * c15) + w19 * w281) + (w258 * w282 + w39 * w283)
    w285 = w152 * (w20 * c11) - w85 * (w132 * c11) - w284 + w162 * (w20 * link2_end_x) - w146 * (w132 * link2_end_x)
    w286 = w21 * w283 - w16 * w277 - (w152 * (w15 * w222) + w85 * (w18 * w222) - w170 * w177) - w162 * (w15 * w223)
    w287 = link2_theta1_dot * (w50 - w19 * w40) - w52
    w288 = w49 - w287
    w289 = w288 * c11
    w290 = (w41 * w256 - w27 * w257) * c11
    w291 = w32 + link2_theta1_dot * (w30 + w16 * w51)
    w292 = w291 - w28
    w293 = w292 * c11
    w294 = w35 * (w134 + w16 * w132) + w133 * w289 - w130 * w290 + (w55 * (w45 - w19 * w47) + w135 * w293)
    w295 = w35 * (w16 * w20 - w47) + w22 * w289 - w37 * w290 + (w48 * w293 - w55 * (w17 + w19 * w134))
    w296 = w217 * (w19 * w290 + (w35 * w39 + w25 * w289) + (w39 * w293 - w25 * w55)) + w168 * w295 + w167 * w294
    w297 = (w28 + w291) * c15 + w292 * c17
    w298 = w42 - w38
    w299 = w298 * c14 - w298 * c15
    w300 = w288 * c17 - (w49 + w287) * c14
    w301 = w115 - w107 + w126 * (w118 - w117)
    w302 = link3_theta1_dot * w95
    w303 = w90 * w92
    w304 = link3_theta1_dot * w303
    w305 = w98 * w302 + w94 * w304
    w306 = w90 * link3_theta3_dot
    w307 = link3_theta1_dot * (w95 * w97 - w92 * w306)
    w308 = w305 + w307
    w309 = w308 * c13
    w310 = 2 * w98
    w311 = 2 * w112
    w312 = w87 * w90
    w313 = link3_theta1_dot * w312
    w314 = (w304 * w310 + w311 * w313) * c13
    w315 = link3_theta1_dot * (w87 * w306 + w92 * (w95 * link3_theta2_dot))
    w316 = w112 * w302 + w94 * w313
    w317 = w315 - w316
    w318 = w317 * c13
    w319 = w106 * (w92 * w155) - w154 * w309 + (w114 * w153 + w155 * w314) + (w126 * (w88 * w95) + w157 * w318)
    w320 = w106 * (w92 * w108) - w93 * w309 + (w91 * w114 + w108 * w314) + (w126 * (w95 * w116) + w119 * w318)
    w321 = w95 * w114 - w90 * w314 - (w106 * w303 + w96 * w309) + (w110 * w318 - w126 * w312)
    w322 = (w120 + w124) * c22 - w125 * c24
    w323 = (w315 + w316) * c22 + w317 * c24
    w324 = w98 * w112
    w325 = link3_theta1_dot * link3_theta2_dot
    w326 = w95 * w325
    w327 = w90 * w325
    w328 = w112 * w304 + w98 * w313
    w329 = (w327 - w328) * c21 + (w327 + w328) * c22
    w330 = w105 * c24 - (w99 + w104) * c21
    w331 = w308 * c24 + (w307 - w305) * c21
    w332 = w303 * w322 + w96 * w323 + (w95 * ((w324 - w326) * c21 - (w324 + w326) * c22) + w90 * w329) + (w312 * w330 + w110 * w331)
    w333 = link3_theta1_dot * (w121 - w90 * w111) - w123
    w334 = w120 - w333
    w335 = w334 * c13
    w336 = (w112 * w310 - w98 * w311) * c13
    w337 = w103 + link3_theta1_dot * (w101 + w87 * w122)
    w338 = w337 - w99
    w339 = w338 * c13
    w340 = w106 * (w156 + w87 * w153) + w154 * w335 - w155 * w336 + (w126 * (w116 - w90 * w118) + w157 * w339)
    w341 = w106 * (w87 * w91 - w118) + w93 * w335 - w108 * w336 + (w119 * w339 - w126 * (w88 + w90 * w156))
    w342 = w90 * w336 + (w106 * w110 + w96 * w335) + (w110 * w339 - w96 * w126)
    w343 = (w99 + w337) * c22 + w338 * c24
    w344 = w113 - w109
    w345 = w344 * c21 - w344 * c22
    w346 = w334 * c24 - (w120 + w333) * c21
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w14 + (w81 * w147 + w3 * w163) + w81 * w166,
            w3 * w190 - (w163 * (w150 * link1_end_x) - w214 - w147 * (w72 * link1_end_x)) + w81 * w216,
            -(w66 * w195 - w59 * w226 - w8 * w228 + (w66 * w230 - w59 * w210)), w3 * w239 + w81 * w243,
            w3 * w265 + w81 * w270, w81 * w294 - w3 * w295, w81 * w301 - w3 * w158, w81 * w319 - w3 * w320,
            w81 * w340 - w3 * w341,
        ),
        ca.horzcat(  # link1.theta2
            w166 * w167 - (w163 * w168 - w147 * w167 + w14 * w168),
            w167 * w216 - (w218 + w217 * (w221 * c9) + w168 * w190),
            w58 * w195 + w61 * w226 + (w61 * w210 + w58 * w230), w167 * w243 - w168 * w239, w167 * w270 - w275,
            w296, w158 * w168 + w167 * w301, w217 * w321 + w168 * w320 + w167 * w319,
            w217 * w342 + w168 * w341 + w167 * w340,
        ),
        ca.horzcat(0.0, -w208, -w228, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w13 * w174 + w165 * w176, w174 * w189 + w176 * w215, 0.0,
            w131 * w238 + (w141 * w146 + (w131 * w162 + (w85 * w175 + w152 * w173))) + w141 * w242,
            w131 * w248 - w285 + w141 * w269, -(w39 * w276 - w25 * w297 - w19 * w299 + (w39 * w300 - w25 * w282)),
            w141 * w301 - w131 * w158, w141 * w319 - w131 * w320, w141 * w340 - w131 * w341,
        ),
        ca.horzcat(  # link2.theta2
            w165 * w179 - w13 * w181, w179 * w215 - (w221 * (w24 * c40) + w181 * w189), 0.0, w244,
            w178 * w269 - (w286 - w146 * (w18 * w223) + w137 * w172 + w223 * w274 + w180 * w248),
            w21 * w276 + w16 * w297 + (w16 * w282 + w21 * w300), w158 * w180 + w178 * w301,
            w223 * w321 + w180 * w320 + w178 * w319, w223 * w342 + w180 * w341 + w178 * w340,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w281, -w299, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w13 * w182 + w165 * w183, w182 * w189 + w183 * w215, 0.0, w182 * w237 + w183 * w241,
            w182 * w247 + w183 * w268, 0.0, w145 * w183 + w161 * w182,
            -(w161 * (w91 * c13) - w145 * (w153 * c13) - w332),
            -(w110 * w322 - w96 * w343 - w90 * w345 + (w110 * w346 - w96 * w330)),
        ),
        ca.horzcat(  # link3.theta2
            w165 * w185 - w13 * w186, w185 * w215 - (w221 * w224 + w186 * w189), 0.0, w185 * w241 - w186 * w237,
            w185 * w268 - (w224 * w273 + w186 * w247), 0.0, w145 * w185 - w161 * w186,
            -(w92 * w331 - w87 * w323 - (w161 * (w86 * w224) + w145 * (w89 * w224) - w171 * w184)),
            w92 * w322 + w87 * w343 + (w87 * w330 + w92 * w346),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w329, -w345),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    803 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 45)
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
    c40 = c[40]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
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
    w49 = w48 * c40
    w50 = w36 * w46
    w51 = w36 * w45
    w52 = w51 * c40
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
    w83 = (w21 + w21) * c42
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
    w150 = (w96 + w96) * c43
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
    w203 = (w158 + w158) * c44
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
    dQ_hat_dq_i_dot[1, 0] = -(w13 * w19 - w10 * w27 + w9 * w34 + w32 * w35)
    dQ_hat_dq_i_dot[1, 1] = w13 * w72 + w10 * w69 - w78 * (w79 * c9) - w34 * w66 - w35 * w77
    dQ_hat_dq_i_dot[1, 2] = -(w13 * w82 - w10 * w83)
    dQ_hat_dq_i_dot[1, 3] = w78 * (w45 * w106 + w94 * w101 + w103 * w112) - w34 * w113 - w35 * w120
    dQ_hat_dq_i_dot[1, 4] = -(w78 * (w143 - (w45 * w133 + w94 * w132 + w103 * w137)) + w34 * w138 + w35 * w141)
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
    dQ_hat_dq_i_dot[4, 1] = -(w79 * (w37 * c40) + w49 * w65 + w52 * w76)
    dQ_hat_dq_i_dot[4, 3] = -(w89 * w121 - w91 * w125 + w47 * w88 + w50 * w117)
    dQ_hat_dq_i_dot[4, 4] = w89 * w145 + w91 * w144 - w80 * w143 - w47 * w128 - w50 * w140
    dQ_hat_dq_i_dot[4, 5] = -(w89 * w149 - w91 * w150)
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
    dQ_hat_dq_i_dot[6, 6] = -(w156 * w180 - w60 * w183 + w165 * w184)
    dQ_hat_dq_i_dot[6, 7] = -(w165 * w197 - (w156 * w198 + w60 * w201))
    dQ_hat_dq_i_dot[6, 8] = -(w156 * w202 + w165 * w203)
    # link3.theta2
    dQ_hat_dq_i_dot[7, 0] = -(w8 * w62 + w31 * w63)
    dQ_hat_dq_i_dot[7, 1] = -(w79 * w81 + w62 * w65 + w63 * w76)
    dQ_hat_dq_i_dot[7, 3] = -(w62 * w87 + w63 * w116)
    dQ_hat_dq_i_dot[7, 4] = -(w81 * w142 + w62 * w127 + w63 * w139)
    dQ_hat_dq_i_dot[7, 6] = -(w152 * w180 - w151 * w184)
    dQ_hat_dq_i_dot[7, 7] = w152 * w198 + w151 * w197
    dQ_hat_dq_i_dot[7, 8] = -(w152 * w202 - w151 * w203)
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
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 9 x 9) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    2050 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 45)
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
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    # intermediate terms (472)
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
    w195 = w20 * c40
    w196 = w145 * c40
    w197 = w170 * c13
    w198 = w120 * c13
    w199 = w99 * c13
    w200 = w98 * w199
    w201 = w95 * w199
    w202 = w11 * link1_end_x
    w203 = (w1 * link1_theta2_ddot - link1_theta2_dot * w9) * link1_end_x
    w204 = w5 * w203 + (w84 * w180 + link1_theta2_dot * (w2 * link1_theta1_dot) * c39)
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
    w238 = w64 * w233 - w67 * w219 - w8 * c28 - w179 * (w0 * w184) - w161 * (w5 * w184) + w84 * (w19 * w46 + w25 * w39 + w29 * w61 + w186 * link2_mass + w189)
    w239 = w1 * w4 - w5 * w9
    w240 = w239 * link1_end_x
    w241 = (w1 * w7 + w0 * w9) * link1_end_x
    w242 = w7 * w241
    w243 = w5 * w182 + (w89 * w180 + w4 * w239 * c39) - (w3 * w6 - w242 + (w0 * w13 - w242))
    w244 = w24 * c11
    w245 = w24 * c40
    w246 = w104 * c13
    w247 = w228 - (w77 + link1_theta1_dot * (w74 + w9 * w67))
    w248 = (w247 - w227) * c1 + (w227 + w247) * c3
    w249 = w208**2 - w220**2
    w250 = w249 * c0 - w249 * c1
    w251 = w210 + (link1_theta1_dot * (w68 - w8 * w207) - w71)
    w252 = (w209 - w251) * c3 - (w209 + w251) * c0
    w253 = w15 * link2_theta1_dot
    w254 = link2_theta1_dot * w253 + w18 * link2_theta1_ddot
    w255 = w18 * link2_theta1_dot
    w256 = w54 * w255
    w257 = w24 * link2_theta2_dot
    w258 = link2_theta2_dot * w257 + w19 * link2_theta2_ddot
    w259 = (w24 * w254 - w256 + (w15 * w258 - w256)) * link2_end_x
    w260 = w259 * link3_mass
    w261 = w260 - w162
    w262 = w15 * link2_theta1_ddot - link2_theta1_dot * w255
    w263 = w54 * w253
    w264 = (w24 * w262 - w263 - (w263 + w18 * w258)) * link2_end_x
    w265 = w264 * link3_mass
    w266 = w265 - (w47 - w40 + w61 * (w50 - w49))
    w267 = w158 * w260 - (w160 * w176 + (w94 * (w15 * w194) - w167 * (w18 * w194) - w158 * w178)) + w176 * w265
    w268 = w257 * link2_end_x
    w269 = (w24 * link2_theta2_ddot - link2_theta2_dot * w54) * link2_end_x
    w270 = w24 * w253
    w271 = w18 * w269 + (w150 * w262 + link2_theta2_dot * w270 * c41)
    w272 = w271 * link3_mass
    w273 = link2_theta1_dot * w24
    w274 = w19 * w21
    w275 = link2_theta1_dot * w274
    w276 = w27 * w273 + w23 * w275
    w277 = w16 * w19
    w278 = link2_theta1_ddot * w277 + link2_theta1_dot * (w24 * w26 - w21 * w151)
    w279 = w276 + w278
    w280 = w279 * c11
    w281 = 2 * w27
    w282 = 2 * w44
    w283 = link2_theta1_dot * w277
    w284 = (w275 * w281 + w282 * w283) * c11
    w285 = link2_theta1_dot * (w16 * w151 + w21 * w257) + link2_theta1_ddot * w274
    w286 = w44 * w273 + w23 * w283
    w287 = w285 - w286
    w288 = w287 * c11
    w289 = w272 - (w39 * (w21 * w41) - w22 * w280 + (w20 * w46 + w41 * w284) + (w61 * (w24 * w48) + w51 * w288))
    w290 = w255 * w268
    w291 = w15 * w269 - w290 - (w290 + w150 * w254)
    w292 = w291 * link3_mass
    w293 = w39 * (w21 * w143) - w146 * w280 + (w46 * w145 + w143 * w284) + (w61 * (w17 * w24) + w148 * w288)
    w294 = w292 - w293
    w295 = w270 - w18 * w54
    w296 = w295 * link2_end_x
    w297 = (w24 * w255 + w15 * w54) * link2_end_x
    w298 = w255 * w297
    w299 = w18 * w264 + (w154 * w262 + w253 * w295 * c41) - (w144 * w254 - w298 + (w15 * w259 - w298))
    w300 = w299 * link3_mass
    w301 = w184 * (w300 - (w24 * w46 - w19 * w284 - (w39 * w274 + w25 * w280) + (w29 * w288 - w61 * w277))) + w93 * w289
    w302 = (w52 + w59) * c15 - w60 * c17
    w303 = (w285 + w286) * c15 + w287 * c17
    w304 = w27 * w44
    w305 = link2_theta3_ddot - w19 * link2_theta1_ddot - w141
    w306 = w19 * w140 - w24 * link2_theta1_ddot
    w307 = w44 * w275 + w27 * w283
    w308 = (w306 - w307) * c14 + (w306 + w307) * c15
    w309 = w38 * c17 - (w28 - w37) * c14
    w310 = w279 * c17 + (w278 - w276) * c14
    w311 = w274 * w302 + w25 * w303 + (w24 * ((w304 + w305) * c14 - (w304 - w305) * c15) + w19 * w308) + (w277 * w309 + w29 * w310)
    w312 = w167 * (w20 * c11) - w94 * (w145 * c11) - w311 + w178 * (w20 * link2_end_x) - w160 * (w145 * link2_end_x)
    w313 = w21 * w310 - w16 * w303 - (w167 * (w15 * w244) + w94 * (w18 * w244) - w186 * w194) - w178 * (w15 * w187)
    w314 = w58 + (link2_theta1_dot * (w53 - w19 * w43) - w56)
    w315 = w52 - w314
    w316 = w315 * c11
    w317 = (w44 * w281 - w27 * w282) * c11
    w318 = w30 - (w35 + link2_theta1_dot * (w32 + w16 * w54))
    w319 = w28 + w318
    w320 = w319 * c11
    w321 = w39 * (w147 + w16 * w145) + w146 * w316 - w143 * w317 + (w61 * (w48 - w19 * w50) - w148 * w320)
    w322 = w39 * (w16 * w20 - w50) + w22 * w316 - w41 * w317 - (w61 * (w17 + w19 * w147) + w51 * w320)
    w323 = w184 * (w19 * w317 + (w29 * w39 + w25 * w316) - (w25 * w61 + w29 * w320)) + w93 * w322 + w166 * w321
    w324 = (w318 - w28) * c15 + w319 * c17
    w325 = w45 - w42
    w326 = w325 * c14 - w325 * c15
    w327 = w315 * c17 - (w52 + w314) * c14
    w328 = w126 - w119 + w139 * (w129 - w128)
    w329 = link3_theta1_dot * w104
    w330 = w99 * w101
    w331 = link3_theta1_dot * w330
    w332 = w107 * w329 + w103 * w331
    w333 = w96 * w99
    w334 = w99 * link3_theta3_dot
    w335 = link3_theta1_ddot * w333 + link3_theta1_dot * (w104 * w106 - w101 * w334)
    w336 = w332 + w335
    w337 = w336 * c13
    w338 = 2 * w107
    w339 = 2 * w123
    w340 = link3_theta1_dot * w333
    w341 = (w331 * w338 + w339 * w340) * c13
    w342 = w104 * link3_theta2_dot
    w343 = link3_theta1_dot * (w96 * w334 + w101 * w342) + link3_theta1_ddot * w330
    w344 = w123 * w329 + w103 * w340
    w345 = w343 - w344
    w346 = w345 * c13
    w347 = w118 * (w101 * w170) - w169 * w337 + (w125 * w168 + w170 * w341) + (w139 * (w97 * w104) + w172 * w346)
    w348 = w118 * (w101 * w120) - w102 * w337 + (w100 * w125 + w120 * w341) + (w139 * (w104 * w127) + w130 * w346)
    w349 = w104 * w125 - w99 * w341 - (w118 * w330 + w105 * w337) + (w109 * w346 - w139 * w333)
    w350 = (w131 + w137) * c22 - w138 * c24
    w351 = (w343 + w344) * c22 + w345 * c24
    w352 = w107 * w123
    w353 = link3_theta1_dot * link3_theta2_dot
    w354 = link3_theta3_ddot - w99 * link3_theta1_ddot - w104 * w353
    w355 = w99 * w353 - w104 * link3_theta1_ddot
    w356 = w123 * w331 + w107 * w340
    w357 = (w355 - w356) * c21 + (w355 + w356) * c22
    w358 = w117 * c24 - (w108 - w116) * c21
    w359 = w336 * c24 + (w335 - w332) * c21
    w360 = w330 * w350 + w105 * w351 + (w104 * ((w352 + w354) * c21 - (w352 - w354) * c22) + w99 * w357) + (w333 * w358 + w109 * w359)
    w361 = w136 + (link3_theta1_dot * (w132 - w99 * w122) - w135)
    w362 = w131 - w361
    w363 = w362 * c13
    w364 = (w123 * w338 - w107 * w339) * c13
    w365 = w110 - (w115 + link3_theta1_dot * (w112 + w96 * w133))
    w366 = w108 + w365
    w367 = w366 * c13
    w368 = w118 * (w171 + w96 * w168) + w169 * w363 - w170 * w364 + (w139 * (w127 - w99 * w129) - w172 * w367)
    w369 = w118 * (w96 * w100 - w129) + w102 * w363 - w120 * w364 - (w139 * (w97 + w99 * w171) + w130 * w367)
    w370 = w99 * w364 + (w109 * w118 + w105 * w363) - (w105 * w139 + w109 * w367)
    w371 = (w365 - w108) * c22 + w366 * c24
    w372 = w124 - w121
    w373 = w372 * c21 - w372 * c22
    w374 = w362 * c24 - (w131 + w361) * c21
    w375 = 2 * w241
    w376 = w375 * c9
    w377 = w73 * w206 - w8 * w208
    w378 = (w69 + w377) * c1 - (w377 - w69) * c3
    w379 = w65 * w208 + w73 * w220
    w380 = (w379 - w11) * c0 - (w11 + w379) * c1
    w381 = w65 * w206 - w8 * w220
    w382 = (w381 - w76) * c3 - (w76 + w381) * c0
    w383 = 2 * w240
    w384 = w383 * c9
    w385 = 2 * (w4 * w84 + w5 * w202)
    w386 = w385 * c9
    w387 = w67 * w206
    w388 = w216 + link1_theta3_dot * w67
    w389 = (w387 - w388) * c3 - (w387 + w388) * c0
    w390 = w64 * w206
    w391 = w224 + w64 * link1_theta3_dot
    w392 = (w390 + w391) * c1 + (w391 - w390) * c3
    w393 = w67 * w208 - w64 * w220
    w394 = (w393 - w214) * c0 - (w214 + w393) * c1
    w395 = 2 * (w0 * w202 - w7 * w84)
    w396 = w395 * c9
    w397 = 2 * (w4 * w89 + w5 * w240 - (w3 * w7 + w0 * w241))
    w398 = (w208 + w208) * c1
    w399 = (w220 + w220) * c42
    w400 = 2 * w297
    w401 = w400 * link3_mass
    w402 = w23 * w25 - w19 * w27
    w403 = w402 - w33
    w404 = w403 * c11
    w405 = (w25 * w281 + w29 * w282) * c11
    w406 = w23 * w29 - w19 * w44
    w407 = w406 - w55
    w408 = w407 * c11
    w409 = w401 - (w22 * w404 - w41 * w405 + w51 * w408)
    w410 = 2 * w296
    w411 = w410 * link3_mass
    w412 = w411 - (w146 * w404 - w143 * w405 + w148 * w408)
    w413 = (w55 + w406) * c15 - w407 * c17
    w414 = w25 * w44 + w27 * w29
    w415 = (w414 - w257) * c14 - (w257 + w414) * c15
    w416 = w403 * c17 - (w33 + w402) * c14
    w417 = 2 * (w150 * w253 + w18 * w268)
    w418 = w417 * link3_mass
    w419 = w16 * w23
    w420 = w283 + w16 * link2_theta3_dot
    w421 = w419 - w420
    w422 = w421 * c11
    w423 = (w16 * w281 - w21 * w282) * c11
    w424 = w275 + w21 * link2_theta3_dot
    w425 = w21 * w23
    w426 = w424 - w425
    w427 = w426 * c11
    w428 = w418 - (w22 * w422 - w41 * w423 + w51 * w427)
    w429 = 2 * (w15 * w268 - w150 * w255)
    w430 = w429 * link3_mass
    w431 = w430 - (w146 * w422 - w143 * w423 + w148 * w427)
    w432 = 2 * (w154 * w253 + w18 * w296 - (w144 * w255 + w15 * w297))
    w433 = w432 * link3_mass
    w434 = w421 * c17 - (w419 + w420) * c14
    w435 = (w424 + w425) * c15 + w426 * c17
    w436 = w16 * w44 - w21 * w27
    w437 = (w436 - w273) * c14 - (w273 + w436) * c15
    w438 = (w44 + w44) * c15
    w439 = (w27 + w27) * c43
    w440 = w103 * w105 - w99 * w107
    w441 = w440 - w113
    w442 = w441 * c13
    w443 = (w105 * w338 + w109 * w339) * c13
    w444 = w103 * w109 - w99 * w123
    w445 = w444 - w134
    w446 = w445 * c13
    w447 = w169 * w442 - w170 * w443 + w172 * w446
    w448 = w102 * w442 - w120 * w443 + w130 * w446
    w449 = w99 * w443 + w105 * w442 + w109 * w446
    w450 = (w134 + w444) * c22 - w445 * c24
    w451 = w105 * w123 + w107 * w109
    w452 = (w451 - w342) * c21 - (w342 + w451) * c22
    w453 = w441 * c24 - (w113 + w440) * c21
    w454 = w96 * w103
    w455 = w340 + w96 * link3_theta3_dot
    w456 = w454 - w455
    w457 = w456 * c13
    w458 = (w96 * w338 - w101 * w339) * c13
    w459 = w331 + w101 * link3_theta3_dot
    w460 = w101 * w103
    w461 = w459 - w460
    w462 = w461 * c13
    w463 = w169 * w457 - w170 * w458 + w172 * w462
    w464 = w102 * w457 - w120 * w458 + w130 * w462
    w465 = w99 * w458 + w105 * w457 + w109 * w462
    w466 = w456 * c24 - (w454 + w455) * c21
    w467 = (w459 + w460) * c22 + w461 * c24
    w468 = w96 * w123 - w101 * w107
    w469 = (w468 - w329) * c21 - (w329 + w468) * c22
    w470 = (w123 + w123) * c22
    w471 = (w107 + w107) * c44
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w14 + (w89 * w161 + w3 * w179) - w89 * w183,
            w3 * w205 - (w179 * (w164 * link1_end_x) - w234 - w161 * (w80 * link1_end_x)) - w89 * w237,
            -(w73 * w212 + w65 * w248 - w8 * w250 + (w73 * w252 - w65 * w230)), w3 * w261 - w89 * w266,
            w3 * w289 - w89 * w294, w89 * w321 - w3 * w322, w89 * w328 - w3 * w173, w89 * w347 - w3 * w348,
            w89 * w368 - w3 * w369,
        ),
        ca.horzcat(  # link1.theta2
            -(w93 * w179 - w161 * w166 + w14 * w93 + w166 * w183),
            -(w238 + w184 * (w243 * c9) + w93 * w205 + w166 * w237),
            -(w67 * w248 - w64 * w212 - (w67 * w230 + w64 * w252)), -(w93 * w261 + w166 * w266),
            -(w301 + w166 * w294), w323, w93 * w173 + w166 * w328, w184 * w349 + w93 * w348 + w166 * w347,
            w184 * w370 + w93 * w369 + w166 * w368,
        ),
        ca.horzcat(0.0, -w226, -w250, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w13 * w191 - w182 * w193, w191 * w204 - w193 * w236, 0.0,
            w144 * w260 + (w154 * w160 + (w144 * w178 + (w94 * w192 + w167 * w190))) - w154 * w265,
            w144 * w272 - w312 - w154 * w292, -(w29 * w302 + w25 * w324 - w19 * w326 + (w29 * w327 - w25 * w309)),
            w154 * w328 - w144 * w173, w154 * w347 - w144 * w348, w154 * w368 - w144 * w369,
        ),
        ca.horzcat(  # link2.theta2
            -(w13 * w195 + w182 * w196), -(w243 * w245 + w195 * w204 + w196 * w236), 0.0, -w267,
            -(w313 - w160 * (w18 * w187) + w150 * w189 + w187 * w300 + w158 * w272 + w176 * w292),
            -(w16 * w324 - w21 * w302 - (w16 * w309 + w21 * w327)), w158 * w173 + w176 * w328,
            w187 * w349 + w158 * w348 + w176 * w347, w187 * w370 + w158 * w369 + w176 * w368,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w308, -w326, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w13 * w197 - w182 * w198, w197 * w204 - w198 * w236, 0.0, w197 * w259 - w198 * w264,
            w197 * w271 - w198 * w291, 0.0, w159 * w198 + w177 * w197,
            -(w177 * (w100 * c13) - w159 * (w168 * c13) - w360),
            -(w109 * w350 + w105 * w371 - w99 * w373 + (w109 * w374 - w105 * w358)),
        ),
        ca.horzcat(  # link3.theta2
            -(w13 * w200 + w182 * w201), -(w243 * w246 + w200 * w204 + w201 * w236), 0.0,
            -(w200 * w259 + w201 * w264), -(w246 * w299 + w200 * w271 + w201 * w291), 0.0,
            w159 * w201 - w177 * w200,
            -(w101 * w359 - w96 * w351 - (w177 * (w95 * w246) + w159 * (w98 * w246) - w188 * w199)),
            -(w96 * w371 - w101 * w350 - (w96 * w358 + w101 * w374)),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w357, -w373),  # link3.theta3
    )
    J_v = ca.SX(9, 9)
    # link1.theta1
    J_v[0, 0] = w3 * w376 - (w65 * w378 - w8 * w380 + w73 * w382) - w89 * w384
    J_v[0, 1] = w3 * w386 - (w73 * w389 - (w65 * w392 + w8 * w394)) - w89 * w396
    J_v[0, 2] = -(w65 * w398 + w73 * w399)
    J_v[0, 3] = w3 * w409 - w89 * w412
    J_v[0, 4] = w3 * w428 - w89 * w431
    J_v[0, 6] = w89 * w447 - w3 * w448
    J_v[0, 7] = w89 * w463 - w3 * w464
    # link1.theta2
    J_v[1, 0] = -(w67 * w378 - w64 * w382 + w93 * w376 + w166 * w384)
    J_v[1, 1] = w67 * w392 + w64 * w389 - w184 * (w397 * c9) - w93 * w386 - w166 * w396
    J_v[1, 2] = -(w67 * w398 - w64 * w399)
    J_v[1, 3] = w184 * (w19 * w405 + w25 * w404 + w29 * w408) - w93 * w409 - w166 * w412
    J_v[1, 4] = -(w184 * (w433 - (w19 * w423 + w25 * w422 + w29 * w427)) + w93 * w428 + w166 * w431)
    J_v[1, 6] = w184 * w449 + w93 * w448 + w166 * w447
    J_v[1, 7] = w184 * w465 + w93 * w464 + w166 * w463
    # link1.theta3
    J_v[2, 0] = -w380
    J_v[2, 1] = -w394
    # link2.theta1
    J_v[3, 0] = w191 * w375 - w193 * w383
    J_v[3, 1] = w191 * w385 - w193 * w395
    J_v[3, 3] = w144 * w401 - (w25 * w413 - w19 * w415 + w29 * w416) - w154 * w411
    J_v[3, 4] = w144 * w418 - (w29 * w434 - (w25 * w435 + w19 * w437)) - w154 * w430
    J_v[3, 5] = -(w25 * w438 + w29 * w439)
    J_v[3, 6] = w154 * w447 - w144 * w448
    J_v[3, 7] = w154 * w463 - w144 * w464
    # link2.theta2
    J_v[4, 0] = -(w195 * w375 + w196 * w383)
    J_v[4, 1] = -(w245 * w397 + w195 * w385 + w196 * w395)
    J_v[4, 3] = -(w16 * w413 - w21 * w416 + w158 * w401 + w176 * w411)
    J_v[4, 4] = w16 * w435 + w21 * w434 - w187 * w433 - w158 * w418 - w176 * w430
    J_v[4, 5] = -(w16 * w438 - w21 * w439)
    J_v[4, 6] = w187 * w449 + w158 * w448 + w176 * w447
    J_v[4, 7] = w187 * w465 + w158 * w464 + w176 * w463
    # link2.theta3
    J_v[5, 3] = -w415
    J_v[5, 4] = -w437
    # link3.theta1
    J_v[6, 0] = w197 * w375 - w198 * w383
    J_v[6, 1] = w197 * w385 - w198 * w395
    J_v[6, 3] = w197 * w400 - w198 * w410
    J_v[6, 4] = w197 * w417 - w198 * w429
    J_v[6, 6] = -(w105 * w450 - w99 * w452 + w109 * w453)
    J_v[6, 7] = -(w109 * w466 - (w105 * w467 + w99 * w469))
    J_v[6, 8] = -(w105 * w470 + w109 * w471)
    # link3.theta2
    J_v[7, 0] = -(w200 * w375 + w201 * w383)
    J_v[7, 1] = -(w246 * w397 + w200 * w385 + w201 * w395)
    J_v[7, 3] = -(w200 * w400 + w201 * w410)
    J_v[7, 4] = -(w246 * w432 + w200 * w417 + w201 * w429)
    J_v[7, 6] = -(w96 * w450 - w101 * w453)
    J_v[7, 7] = w96 * w467 + w101 * w466
    J_v[7, 8] = -(w96 * w470 - w101 * w471)
    # link3.theta3
    J_v[8, 6] = -w452
    J_v[8, 7] = -w469
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 45) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    844 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 45)
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
    c35 = c[35]
    c36 = c[36]
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
    w127 = w5 * w73 + w17 * w71 + w19 * w78 - c36 + w28 * w81 + w86 * w118 + w61 * w119
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
    w221 = w30 * w93 - (w127 + (w32 * w101 + w89 * w99 + w90 * w104 - c35)) + w110 * w121 - w134 * w152 - w150 * w217
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
