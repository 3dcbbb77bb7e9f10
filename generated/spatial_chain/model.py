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
    gives c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    116 operations.
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
        w6 + w12,  # c37
        2.0,  # c38
        -w1,  # c39
        -w8,  # c40
        -w14,  # c41
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 9 x 9) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 9) [N, N m]: condensed force S^T (Q* - M s)
    723 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 9) [mixed]: dependent coordinates after one Newton step
    39 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    65 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 9) [mixed]: accelerations of the dependent coordinates
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 9) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 9 x 18) [SI]: constraint Jacobian
    gives C_t (n_c = 9) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 9) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    440 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 9) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 3) [N, N m]: world force and moment of a joint on its body b, at b
    373 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    q_ddot = ca.SX.sym("q_ddot", 18)
    c = ca.SX.sym("c", 42)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    299 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 42)
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
    gravity_z = c[27]
    link1_mass = c[29]
    c30 = c[30]
    # intermediate terms (70)
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
    w69 = (link1_z * link1_mass - w5) * gravity_z + (link2_z * link2_mass - w28) * gravity_z + (link3_z * link3_mass - w51) * gravity_z
    # outputs
    kinetic = ca.vertcat(w68 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(-w69)
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
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i, through q_d
    1457 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 42)
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
    c37 = c[37]
    c38 = c[38]
    # intermediate terms (368)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.cos(link1_theta1)
    w5 = w0 * w4
    w6 = link1_theta3_dot * w5 - w1 * link1_theta2_dot
    w7 = w4 * link1_theta2_dot + w2 * link1_theta3_dot
    w8 = w5 * link1_end_x
    w9 = w3 * w6 - w7 * w8
    w10 = ca.sin(link1_theta2)
    w11 = link1_theta3_dot * w10
    w12 = link1_theta1_dot - w11
    w13 = w10 * link1_end_x
    w14 = w3 * w12 + w7 * w13
    w15 = w6 * w9 + w12 * w14
    w16 = w0 * link1_theta3_dot
    w17 = ca.cos(link1_theta3)
    w18 = w16 * w17
    w19 = link1_theta2_dot * w10
    w20 = ca.sin(link1_theta3)
    w21 = link1_theta3_dot * link1_theta2_dot
    w22 = w20 * w21
    w23 = link1_theta1_dot * (w18 - w19 * w20) - w22
    w24 = w4 * w10
    w25 = w1 * w17
    w26 = w20 * w24 - w25
    w27 = link1_theta2_dot * link1_theta1_dot
    w28 = w0 * w27
    w29 = w16 * w20
    w30 = link1_theta2_dot * w17
    w31 = w17 * w21
    w32 = link1_theta1_dot * (w29 + w10 * w30) + w31
    w33 = w4 * w17
    w34 = w10 * w33 + w1 * w20
    w35 = w23 * w26 - w5 * w28 - w32 * w34
    w36 = w0 * w20
    w37 = w0 * w17
    w38 = w10 * w28 + w23 * w36 - w32 * w37
    w39 = w13 * w35 + w8 * w38
    w40 = w15 - w39
    w41 = w40 * c9
    w42 = w2 * w28
    w43 = w1 * w10
    w44 = w33 + w20 * w43
    w45 = w23 * w44
    w46 = w4 * w20
    w47 = w10 * w25
    w48 = w3 * w38
    w49 = w6 * w13 + w8 * w12
    w50 = w12 * w49
    w51 = w7 * w9
    w52 = w13 * (w42 - w45 - w32 * (w46 - w47)) - w48 - (w50 - w51)
    w53 = w52 * c9
    w54 = ca.cos(link2_theta1)
    w55 = ca.cos(link2_theta3)
    w56 = w54 * w55
    w57 = ca.sin(link2_theta1)
    w58 = ca.sin(link2_theta2)
    w59 = w57 * w58
    w60 = ca.sin(link2_theta3)
    w61 = w56 + w59 * w60
    w62 = link2_theta3_dot - w58 * link2_theta1_dot
    w63 = ca.cos(link2_theta2)
    w64 = w60 * w63
    w65 = w55 * link2_theta2_dot
    w66 = link2_theta1_dot * w64 + w65
    w67 = w62 * w66
    w68 = link2_theta3_dot * w63
    w69 = w60 * w68
    w70 = link2_theta3_dot * link2_theta2_dot
    w71 = w55 * w70
    w72 = link2_theta1_dot * (w69 + w58 * w65) + w71
    w73 = w67 - w72
    w74 = w73 * c11
    w75 = w61 * w74
    w76 = w57 * w63
    w77 = w66**2
    w78 = w55 * w63
    w79 = w60 * link2_theta2_dot
    w80 = link2_theta1_dot * w78 - w79
    w81 = w80**2
    w82 = (w77 + w81) * c11
    w83 = w76 * w82
    w84 = w55 * w57
    w85 = w58 * w84
    w86 = w54 * w60
    w87 = w85 - w86
    w88 = w62 * w80
    w89 = w55 * w68
    w90 = w58 * link2_theta2_dot
    w91 = w60 * w70
    w92 = link2_theta1_dot * (w89 - w60 * w90) - w91
    w93 = w88 - w92
    w94 = w93 * c11
    w95 = w39 - w15
    w96 = ca.cos(link3_theta1)
    w97 = ca.cos(link3_theta3)
    w98 = w96 * w97
    w99 = ca.sin(link3_theta1)
    w100 = ca.sin(link3_theta2)
    w101 = w99 * w100
    w102 = ca.sin(link3_theta3)
    w103 = w98 + w101 * w102
    w104 = link3_theta3_dot - w100 * link3_theta1_dot
    w105 = ca.cos(link3_theta2)
    w106 = w102 * w105
    w107 = w97 * link3_theta2_dot
    w108 = link3_theta1_dot * w106 + w107
    w109 = w104 * w108
    w110 = link3_theta3_dot * w105
    w111 = w102 * w110
    w112 = link3_theta3_dot * link3_theta2_dot
    w113 = w97 * w112
    w114 = link3_theta1_dot * (w111 + w100 * w107) + w113
    w115 = w109 - w114
    w116 = w115 * c13
    w117 = w103 * w116
    w118 = w99 * w105
    w119 = w108**2
    w120 = w97 * w105
    w121 = w102 * link3_theta2_dot
    w122 = link3_theta1_dot * w120 - w121
    w123 = w122**2
    w124 = (w119 + w123) * c13
    w125 = w118 * w124
    w126 = w97 * w99
    w127 = w100 * w126
    w128 = w96 * w102
    w129 = w127 - w128
    w130 = w104 * w122
    w131 = w97 * w110
    w132 = w100 * link3_theta2_dot
    w133 = w102 * w112
    w134 = link3_theta1_dot * (w131 - w102 * w132) - w133
    w135 = w130 - w134
    w136 = w135 * c13
    w137 = link2_theta1_dot * link2_theta2_dot
    w138 = w63 * w137
    w139 = w58 * w138 + w64 * w92 - w72 * w78
    w140 = w54 * w63
    w141 = w140 * link2_end_x
    w142 = w54 * w58
    w143 = w60 * w142 - w84
    w144 = w57 * w60
    w145 = w144 + w56 * w58
    w146 = w92 * w143 - w138 * w140 - w72 * w145
    w147 = w58 * link2_end_x
    w148 = w139 * w141 + w146 * w147
    w149 = w58 * link2_theta3_dot
    w150 = link2_theta1_dot - w149
    w151 = w54 * link2_theta2_dot + link2_theta3_dot * w76
    w152 = w76 * link2_end_x
    w153 = w147 * w151 + w150 * w152
    w154 = link2_theta3_dot * w140 - w57 * link2_theta2_dot
    w155 = w152 * w154 - w141 * w151
    w156 = w150 * w153 + w154 * w155
    w157 = w95 + (w148 - w156)
    w158 = w117 - w125 + w129 * w136 + w157 * link3_mass
    w159 = w75 - w83 + w87 * w94 + w95 * link2_mass + w158
    w160 = w74 * w143 - w82 * w140 + w94 * w145
    w161 = w47 - w46
    w162 = w45 - w42 - w32 * w161
    w163 = w51 - w50 - (w48 + w13 * w162)
    w164 = w96 * w100
    w165 = w102 * w164 - w126
    w166 = w96 * w105
    w167 = w99 * w102
    w168 = w167 + w98 * w100
    w169 = w116 * w165 - w124 * w166 + w136 * w168
    w170 = w151 * w155
    w171 = w141 * w150 + w147 * w154
    w172 = w150 * w171
    w173 = w61 * w92
    w174 = w76 * w138
    w175 = w173 - w174 - w72 * w87
    w176 = w139 * w152
    w177 = w163 + (w170 - w172 - (w147 * w175 + w176))
    w178 = w169 + w177 * link3_mass
    w179 = w160 + w163 * link2_mass + w178
    w180 = w1 * w13
    w181 = w4 * w13
    w182 = w3 * w35 - w8 * w162 + (w6 * w49 + w7 * w14)
    w183 = w182 - gravity_z
    w184 = w182 + (w146 * w152 - w141 * w175 + (w154 * w171 + w151 * w153)) - gravity_z
    w185 = w100 * w124 + w106 * w116 + w120 * w136 + w184 * link3_mass
    w186 = w76 * c11
    w187 = w186 + w152 * link3_mass
    w188 = w140 * c11
    w189 = w188 + w141 * link3_mass
    w190 = w58 * c11
    w191 = w57 * w147
    w192 = w59 * c37
    w193 = w54 * w147
    w194 = w142 * c37
    w195 = w118 * c13
    w196 = w166 * c13
    w197 = w100 * c13
    w198 = w99 * w197
    w199 = w96 * w197
    w200 = link1_theta3_dot * w43
    w201 = w24 * link1_end_x
    w202 = link1_theta3_dot * w24
    w203 = w43 * link1_end_x
    w204 = w8 * w200 + w7 * w201 - (w3 * w202 + w6 * w203)
    w205 = w0 * link1_end_x
    w206 = w6 * w205 - w13 * w202 - (w8 * w16 + w12 * w201)
    w207 = link1_theta1_dot * (w11 * w17 + w20 * (w0 * link1_theta2_dot))
    w208 = w10 * w27
    w209 = link1_theta1_dot * (w0 * w30 - w11 * w20)
    w210 = w23 * (w2 * w20) - w44 * w207 + w10 * (link1_theta1_dot * (w2 * link1_theta2_dot)) * c38 - (w32 * (w0 * w25) + w161 * w209)
    w211 = w10 * w20
    w212 = w10 * w17
    w213 = w0 * w28 - w10 * w208 - (w23 * w211 + w36 * w207) - (w37 * w209 - w32 * w212)
    w214 = w7 * w204 - w9 * w200 - (w12 * w206 - w16 * w49) - (w13 * w210 + w162 * w205 + (w3 * w213 - w38 * w203))
    w215 = w214 * c9
    w216 = link1_theta3_dot - link1_theta1_dot * w10
    w217 = link1_theta2_dot * w20
    w218 = link1_theta1_dot * w37 - w217
    w219 = w216 * w218
    w220 = (w23 + w219) * c1 - (w219 - w23) * c3
    w221 = w0 * link1_theta1_dot
    w222 = link1_theta1_dot * w212
    w223 = w218 * w221 + w216 * w222
    w224 = (w207 + w223) * c1 + (w207 - w223) * c3
    w225 = w30 + link1_theta1_dot * w36
    w226 = w218 * w225
    w227 = link1_theta1_dot * w211
    w228 = w218 * w227 + w222 * w225
    w229 = (w208 - w228) * c0 + (w208 + w228) * c1
    w230 = w216 * w225
    w231 = (w230 - w32) * c3 - (w32 + w230) * c0
    w232 = w221 * w225 + w216 * w227
    w233 = (w209 + w232) * c3 + (w209 - w232) * c0
    w234 = w211 * w220 + w36 * w224 + (w0 * ((w226 - w28) * c0 - (w28 + w226) * c1) + w10 * w229) + (w212 * w231 + w37 * w233)
    w235 = w23 * (w5 * w20) - w26 * w207 + w10 * (link1_theta1_dot * (w5 * link1_theta2_dot)) * c38 - (w32 * (w0 * w33) + w34 * w209)
    w236 = w7 * w205 - w13 * w200 - (w3 * w16 + w12 * w203)
    w237 = w8 * w213 - w38 * w201 + (w13 * w235 + w35 * w205) - (w12 * w236 - w14 * w16 + (w6 * w204 - w9 * w202))
    w238 = w237 * c9
    w239 = w3 * w235 - w35 * w203 - (w8 * w210 - w162 * w201) + (w6 * w206 - w49 * w202 + (w7 * w236 - w14 * w200))
    w240 = w20 * w233 - w17 * w224 - w10 * c28 - w179 * (w4 * w205) - w159 * (w1 * w205) + w13 * (w58 * w82 + w64 * w74 + w78 * w94 + w183 * link2_mass + w185)
    w241 = w63 * c11
    w242 = w63 * link2_end_x
    w243 = w105 * c13
    w244 = w31 + link1_theta1_dot * (w29 + w17 * w19)
    w245 = (w230 + w244) * c1 + (w244 - w230) * c3
    w246 = w218**2 - w225**2
    w247 = w246 * c0 - w246 * c1
    w248 = link1_theta1_dot * (w18 - w10 * w217) - w22
    w249 = (w219 - w248) * c3 - (w219 + w248) * c0
    w250 = w86 - w85
    w251 = w156 - w148
    w252 = w251 * link3_mass
    w253 = w83 - w75 + w94 * w250 + w252
    w254 = w147 * (w174 - w173 - w72 * w250) - w176 - (w172 - w170)
    w255 = w254 * link3_mass
    w256 = w160 + w255
    w257 = w191 * w255 + (w158 * w193 + (w95 * (w54 * w190) - w163 * (w57 * w190) - w178 * w191)) + w193 * w252
    w258 = w60 * w140
    w259 = link2_theta1_dot * w63
    w260 = w58 * w60
    w261 = link2_theta1_dot * w260
    w262 = w66 * w259 + w62 * w261
    w263 = link2_theta1_dot * (w63 * w65 - w60 * w149)
    w264 = w262 + w263
    w265 = w264 * c11
    w266 = 2 * w66
    w267 = 2 * w80
    w268 = w55 * w58
    w269 = link2_theta1_dot * w268
    w270 = (w261 * w266 + w267 * w269) * c11
    w271 = w56 * w63
    w272 = link2_theta1_dot * (w55 * w149 + w60 * (w63 * link2_theta2_dot))
    w273 = w80 * w259 + w62 * w269
    w274 = w272 - w273
    w275 = w274 * c11
    w276 = w59 * link2_theta3_dot
    w277 = w142 * link2_end_x
    w278 = link2_theta3_dot * w142
    w279 = w59 * link2_end_x
    w280 = w141 * w276 + w151 * w277 - (w152 * w278 + w154 * w279)
    w281 = w154 * w242 - w147 * w278 - (w68 * w141 + w150 * w277)
    w282 = w60 * w76
    w283 = w58 * w137
    w284 = w63 * w84
    w285 = w92 * w282 - w61 * w272 + link2_theta2_dot * (w63 * (w59 * link2_theta1_dot)) * c38 - (w72 * w284 + w87 * w263)
    w286 = w63 * w138 - w58 * w283 - (w92 * w260 + w64 * w272) - (w78 * w263 - w72 * w268)
    w287 = w151 * w280 - w155 * w276 - (w150 * w281 - w68 * w171) - (w147 * w285 + w175 * w242 + (w152 * w286 - w139 * w279))
    w288 = w287 * link3_mass
    w289 = w74 * w258 - w143 * w265 + (w82 * w142 + w140 * w270) + (w94 * w271 + w145 * w275) + w288
    w290 = w92 * w258 - w143 * w272 + link2_theta2_dot * (w63 * (link2_theta1_dot * w142)) * c38 - (w72 * w271 + w145 * w263)
    w291 = w151 * w242 - w147 * w276 - (w68 * w152 + w150 * w279)
    w292 = w141 * w286 - w139 * w277 + (w147 * w290 + w146 * w242) - (w150 * w291 - w68 * w153 + (w154 * w280 - w155 * w278))
    w293 = w292 * link3_mass
    w294 = w74 * w282 - w61 * w265 + (w59 * w82 + w76 * w270) + (w94 * w284 + w87 * w275) + w293
    w295 = w152 * w290 - w146 * w279 - (w141 * w285 - w175 * w277) + (w154 * w281 - w171 * w278 + (w151 * w291 - w153 * w276))
    w296 = w295 * link3_mass
    w297 = w205 * (w63 * w82 - w58 * w270 - (w74 * w260 + w64 * w265) + (w78 * w275 - w94 * w268) + w296) + w180 * w294
    w298 = (w88 + w92) * c15 - w93 * c17
    w299 = (w272 + w273) * c15 + w274 * c17
    w300 = w66 * w80
    w301 = w80 * w261 + w66 * w269
    w302 = (w283 - w301) * c14 + (w283 + w301) * c15
    w303 = w73 * c17 - (w67 + w72) * c14
    w304 = w264 * c17 + (w263 - w262) * c14
    w305 = w260 * w298 + w64 * w299 + (w63 * ((w300 - w138) * c14 - (w138 + w300) * c15) + w58 * w302) + (w268 * w303 + w78 * w304)
    w306 = w152 * w288 - (w163 * (w59 * c11) - w95 * (w142 * c11) - w305 + w178 * w279 - w158 * w277 + w141 * w293)
    w307 = w60 * w304 - w55 * w299 - (w163 * (w54 * w241) + w95 * (w57 * w241) - w183 * w190) - w178 * (w54 * w242)
    w308 = link2_theta1_dot * (w89 - w58 * w79) - w91
    w309 = w88 - w308
    w310 = w309 * c11
    w311 = (w80 * w266 - w66 * w267) * c11
    w312 = w71 + link2_theta1_dot * (w69 + w55 * w90)
    w313 = w312 - w67
    w314 = w313 * c11
    w315 = w74 * (w144 + w55 * w142) + w143 * w310 - w140 * w311 + (w94 * (w84 - w58 * w86) + w145 * w314)
    w316 = w74 * (w55 * w59 - w86) + w61 * w310 - w76 * w311 + (w87 * w314 - w94 * (w56 + w58 * w144))
    w317 = w205 * (w58 * w311 + (w74 * w78 + w64 * w310) + (w78 * w314 - w64 * w94)) + w180 * w316 + w181 * w315
    w318 = (w67 + w312) * c15 + w313 * c17
    w319 = w81 - w77
    w320 = w319 * c14 - w319 * c15
    w321 = w309 * c17 - (w88 + w308) * c14
    w322 = w125 - w117 + w136 * (w128 - w127)
    w323 = link3_theta1_dot * w105
    w324 = w100 * w102
    w325 = link3_theta1_dot * w324
    w326 = w108 * w323 + w104 * w325
    w327 = w100 * link3_theta3_dot
    w328 = link3_theta1_dot * (w105 * w107 - w102 * w327)
    w329 = w326 + w328
    w330 = w329 * c13
    w331 = 2 * w108
    w332 = 2 * w122
    w333 = w97 * w100
    w334 = link3_theta1_dot * w333
    w335 = (w325 * w331 + w332 * w334) * c13
    w336 = link3_theta1_dot * (w97 * w327 + w102 * (w105 * link3_theta2_dot))
    w337 = w122 * w323 + w104 * w334
    w338 = w336 - w337
    w339 = w338 * c13
    w340 = w116 * (w102 * w166) - w165 * w330 + (w124 * w164 + w166 * w335) + (w136 * (w98 * w105) + w168 * w339)
    w341 = w116 * (w102 * w118) - w103 * w330 + (w101 * w124 + w118 * w335) + (w136 * (w105 * w126) + w129 * w339)
    w342 = w105 * w124 - w100 * w335 - (w116 * w324 + w106 * w330) + (w120 * w339 - w136 * w333)
    w343 = (w130 + w134) * c22 - w135 * c24
    w344 = (w336 + w337) * c22 + w338 * c24
    w345 = w108 * w122
    w346 = link3_theta1_dot * link3_theta2_dot
    w347 = w105 * w346
    w348 = w100 * w346
    w349 = w122 * w325 + w108 * w334
    w350 = (w348 - w349) * c21 + (w348 + w349) * c22
    w351 = w115 * c24 - (w109 + w114) * c21
    w352 = w329 * c24 + (w328 - w326) * c21
    w353 = w324 * w343 + w106 * w344 + (w105 * ((w345 - w347) * c21 - (w345 + w347) * c22) + w100 * w350) + (w333 * w351 + w120 * w352)
    w354 = link3_theta1_dot * (w131 - w100 * w121) - w133
    w355 = w130 - w354
    w356 = w355 * c13
    w357 = (w122 * w331 - w108 * w332) * c13
    w358 = w113 + link3_theta1_dot * (w111 + w97 * w132)
    w359 = w358 - w109
    w360 = w359 * c13
    w361 = w116 * (w167 + w97 * w164) + w165 * w356 - w166 * w357 + (w136 * (w126 - w100 * w128) + w168 * w360)
    w362 = w116 * (w97 * w101 - w128) + w103 * w356 - w118 * w357 + (w129 * w360 - w136 * (w98 + w100 * w167))
    w363 = w100 * w357 + (w116 * w120 + w106 * w356) + (w120 * w360 - w106 * w136)
    w364 = (w109 + w358) * c22 + w359 * c24
    w365 = w123 - w119
    w366 = w365 * c21 - w365 * c22
    w367 = w355 * c24 - (w130 + w354) * c21
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w41 - (w8 * w53 - (w3 * w159 + w8 * w179)),
            w3 * w215 - (w179 * w203 - w234 - w159 * w201 + w8 * w238),
            -(w37 * w220 - w36 * w245 - w10 * w247 + (w37 * w249 - w36 * w231)), w3 * w253 - w8 * w256,
            w3 * w289 - w8 * w294, w3 * w315 - w8 * w316, w3 * w322 - w8 * w169, w3 * w340 - w8 * w341,
            w3 * w361 - w8 * w362,
        ),
        ca.horzcat(  # link1.theta2
            w53 * w180 - (w179 * w180 - w159 * w181) + w41 * w181,
            w205 * (w239 * c9) - w240 + w180 * w238 + w181 * w215,
            w20 * w220 + w17 * w245 + (w17 * w231 + w20 * w249), w180 * w256 + w181 * w253, w297 + w181 * w289,
            w317, w169 * w180 + w181 * w322, w205 * w342 + w180 * w341 + w181 * w340,
            w205 * w363 + w180 * w362 + w181 * w361,
        ),
        ca.horzcat(0.0, -w229, -w247, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w40 * w187 - w52 * w189, w187 * w214 - w189 * w237, 0.0,
            w152 * w252 - (w141 * w255 - (w152 * w158 + (w141 * w178 + (w95 * w186 + w163 * w188)))), w306,
            -(w78 * w298 - w64 * w318 - w58 * w320 + (w78 * w321 - w64 * w303)), w152 * w322 - w141 * w169,
            w152 * w340 - w141 * w341, w152 * w361 - w141 * w362,
        ),
        ca.horzcat(  # link2.theta2
            w52 * w192 + w40 * w194, w239 * (w63 * c37) + w192 * w237 + w194 * w214, 0.0, w257,
            w242 * w296 - (w307 - w158 * (w57 * w242) + w147 * w185) + w191 * w293 + w193 * w288,
            w60 * w298 + w55 * w318 + (w55 * w303 + w60 * w321), w169 * w191 + w193 * w322,
            w242 * w342 + w191 * w341 + w193 * w340, w242 * w363 + w191 * w362 + w193 * w361,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w302, -w320, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w40 * w195 - w52 * w196, w195 * w214 - w196 * w237, 0.0, w195 * w251 - w196 * w254,
            w195 * w287 - w196 * w292, 0.0, w157 * w195 + w177 * w196,
            -(w177 * (w101 * c13) - w157 * (w164 * c13) - w353),
            -(w120 * w343 - w106 * w364 - w100 * w366 + (w120 * w367 - w106 * w351)),
        ),
        ca.horzcat(  # link3.theta2
            w52 * w198 + w40 * w199, w239 * w243 + w198 * w237 + w199 * w214, 0.0, w198 * w254 + w199 * w251,
            w243 * w295 + w198 * w292 + w199 * w287, 0.0, w157 * w199 - w177 * w198,
            -(w102 * w352 - w97 * w344 - (w177 * (w96 * w243) + w157 * (w99 * w243) - w184 * w197)),
            w102 * w343 + w97 * w364 + (w97 * w351 + w102 * w367),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w350, -w366),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    928 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 42)
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
    c37 = c[37]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    # intermediate terms (224)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta3)
    w2 = w0 * w1
    w3 = ca.sin(link1_theta2)
    w4 = link1_theta3_dot - link1_theta1_dot * w3
    w5 = ca.cos(link1_theta3)
    w6 = w0 * w5
    w7 = link1_theta1_dot * w6 - w1 * link1_theta2_dot
    w8 = w4 * w6 - w3 * w7
    w9 = w0 * link1_theta3_dot
    w10 = w5 * w9 - w1 * (w3 * link1_theta2_dot)
    w11 = (w8 + w10) * c1 - (w8 - w10) * c3
    w12 = w5 * link1_theta2_dot
    w13 = w2 * link1_theta1_dot + w12
    w14 = w2 * w7 + w6 * w13
    w15 = w0 * link1_theta2_dot
    w16 = (w14 - w15) * c0 - (w14 + w15) * c1
    w17 = w2 * w4 - w3 * w13
    w18 = w1 * w9 + w3 * w12
    w19 = (w17 - w18) * c3 - (w17 + w18) * c0
    w20 = ca.cos(link1_theta1)
    w21 = w0 * w20
    w22 = w21 * link1_end_x
    w23 = w3 * w15 + w2 * w10 - w6 * w18
    w24 = w3 * link1_end_x
    w25 = ca.sin(link1_theta1)
    w26 = w5 * w25
    w27 = w1 * (w3 * w20) - w26
    w28 = w5 * w20
    w29 = w1 * w25 + w3 * w28
    w30 = w0 * w25
    w31 = link1_theta2_dot * w20 + link1_theta3_dot * w30
    w32 = link1_theta1_dot - link1_theta3_dot * w3
    w33 = w30 * link1_end_x
    w34 = w32 * w33
    w35 = w24 * w31 + w34
    w36 = w22 * w23 + w24 * (w10 * w27 - w15 * w21 - w18 * w29) - (w34 + w35)
    w37 = w36 * c9
    w38 = w22 * w32
    w39 = link1_theta3_dot * w21 - link1_theta2_dot * w25
    w40 = w38 + w24 * w39
    w41 = w28 + w1 * (w3 * w25)
    w42 = w3 * w26 - w1 * w20
    w43 = w38 + w40 + (w24 * (w10 * w41 - w15 * w30 - w18 * w42) + w23 * w33)
    w44 = w43 * c9
    w45 = w24 * w25
    w46 = w20 * w24
    w47 = ca.cos(link2_theta1)
    w48 = ca.cos(link2_theta2)
    w49 = w47 * w48
    w50 = w49 * link2_end_x
    w51 = w49 * c11 + w50 * link3_mass
    w52 = ca.sin(link2_theta1)
    w53 = w48 * w52
    w54 = w53 * link2_end_x
    w55 = w53 * c11 + w54 * link3_mass
    w56 = ca.sin(link2_theta2)
    w57 = w56 * link2_end_x
    w58 = w52 * w57
    w59 = w52 * w56
    w60 = w59 * c37
    w61 = w47 * w57
    w62 = w47 * w56
    w63 = w62 * c37
    w64 = ca.cos(link3_theta1)
    w65 = ca.cos(link3_theta2)
    w66 = w64 * w65
    w67 = w66 * c13
    w68 = ca.sin(link3_theta1)
    w69 = w65 * w68
    w70 = w69 * c13
    w71 = ca.sin(link3_theta2)
    w72 = w71 * c13
    w73 = w68 * w72
    w74 = w64 * w72
    w75 = w33 * w39 - w22 * w31
    w76 = w0 * link1_end_x
    w77 = w0 * link1_theta1_dot
    w78 = link1_theta1_dot * (w1 * w3) + w1 * link1_theta3_dot
    w79 = link1_theta1_dot * (w3 * w5) + link1_theta3_dot * w5
    w80 = w3 * w77 - w2 * w78 - w6 * w79
    w81 = w41 * w78 + w30 * w77 + w42 * w79
    w82 = w20 * w75 - w31 * w76 + w32 * w45 - (w33 * w80 - w24 * w81)
    w83 = w82 * c9
    w84 = w4 * w5
    w85 = (w84 - w79) * c3 - (w79 + w84) * c0
    w86 = w1 * w4
    w87 = (w78 + w86) * c1 + (w78 - w86) * c3
    w88 = w5 * w7 - w1 * w13
    w89 = (w88 - w77) * c0 - (w77 + w88) * c1
    w90 = w27 * w78 + w21 * w77 + w29 * w79
    w91 = w22 * w80 - w24 * w90 - (w32 * w46 - (w25 * w75 + w39 * w76))
    w92 = w91 * c9
    w93 = w22 * w81 - w33 * w90 + (w20 * w35 + w31 * w46 - (w25 * w40 + w39 * w45))
    w94 = w48 * link2_end_x
    w95 = w65 * c13
    w96 = (w7 + w7) * c1
    w97 = (w13 + w13) * c39
    w98 = ca.cos(link2_theta3)
    w99 = w47 * w98
    w100 = ca.sin(link2_theta3)
    w101 = w99 + w59 * w100
    w102 = link2_theta3_dot - w56 * link2_theta1_dot
    w103 = w48 * w100
    w104 = w98 * link2_theta2_dot
    w105 = link2_theta1_dot * w103 + w104
    w106 = w102 * w103 - w56 * w105
    w107 = w48 * link2_theta3_dot
    w108 = w100 * w107 + w56 * w104
    w109 = w106 - w108
    w110 = w109 * c11
    w111 = 2 * w105
    w112 = w48 * w98
    w113 = link2_theta1_dot * w112 - w100 * link2_theta2_dot
    w114 = 2 * w113
    w115 = (w103 * w111 + w112 * w114) * c11
    w116 = w52 * w98
    w117 = w56 * w116 - w47 * w100
    w118 = w102 * w112 - w56 * w113
    w119 = w98 * w107 - w100 * (w56 * link2_theta2_dot)
    w120 = w118 - w119
    w121 = w120 * c11
    w122 = w48 * link2_theta2_dot
    w123 = w56 * w122 + w103 * w119 - w108 * w112
    w124 = w62 * w100 - w116
    w125 = w52 * w100 + w56 * w99
    w126 = w47 * link2_theta2_dot + w53 * link2_theta3_dot
    w127 = link2_theta1_dot - w56 * link2_theta3_dot
    w128 = w54 * w127
    w129 = w57 * w126 + w128
    w130 = w50 * w123 + w57 * (w119 * w124 - w49 * w122 - w108 * w125) - (w128 + w129)
    w131 = w130 * link3_mass
    w132 = w101 * w110 - w53 * w115 + w117 * w121 + w131
    w133 = w50 * w127
    w134 = w49 * link2_theta3_dot - w52 * link2_theta2_dot
    w135 = w133 + w57 * w134
    w136 = w133 + w135 + (w57 * (w101 * w119 - w53 * w122 - w108 * w117) + w54 * w123)
    w137 = w136 * link3_mass
    w138 = w137 - (w110 * w124 - w49 * w115 + w121 * w125)
    w139 = (w118 + w119) * c15 - w120 * c17
    w140 = w103 * w113 + w105 * w112
    w141 = (w140 - w122) * c14 - (w122 + w140) * c15
    w142 = w109 * c17 - (w106 + w108) * c14
    w143 = w98 * w102
    w144 = link2_theta1_dot * (w56 * w98) + w98 * link2_theta3_dot
    w145 = w143 - w144
    w146 = w145 * c11
    w147 = (w98 * w111 - w100 * w114) * c11
    w148 = link2_theta1_dot * (w56 * w100) + w100 * link2_theta3_dot
    w149 = w100 * w102
    w150 = w148 - w149
    w151 = w150 * c11
    w152 = w54 * w134 - w50 * w126
    w153 = w48 * link2_theta1_dot
    w154 = w56 * w153 - w103 * w148 - w112 * w144
    w155 = w101 * w148 + w53 * w153 + w117 * w144
    w156 = w47 * w152 - w94 * w126 + w58 * w127 - (w54 * w154 - w57 * w155)
    w157 = w156 * link3_mass
    w158 = w124 * w146 - w49 * w147 + w125 * w151 + w157
    w159 = w124 * w148 + w49 * w153 + w125 * w144
    w160 = w50 * w154 - w57 * w159 - (w61 * w127 - (w52 * w152 + w94 * w134))
    w161 = w160 * link3_mass
    w162 = w101 * w146 - w53 * w147 + w117 * w151 + w161
    w163 = w50 * w155 - w54 * w159 + (w47 * w129 + w61 * w126 - (w52 * w135 + w58 * w134))
    w164 = w163 * link3_mass
    w165 = w145 * c17 - (w143 + w144) * c14
    w166 = (w148 + w149) * c15 + w150 * c17
    w167 = w98 * w113 - w100 * w105
    w168 = (w167 - w153) * c14 - (w153 + w167) * c15
    w169 = (w113 + w113) * c15
    w170 = (w105 + w105) * c40
    w171 = ca.sin(link3_theta3)
    w172 = ca.cos(link3_theta3)
    w173 = w68 * w172
    w174 = w64 * w71 * w171 - w173
    w175 = link3_theta3_dot - w71 * link3_theta1_dot
    w176 = w65 * w171
    w177 = w172 * link3_theta2_dot
    w178 = link3_theta1_dot * w176 + w177
    w179 = w175 * w176 - w71 * w178
    w180 = w65 * link3_theta3_dot
    w181 = w171 * w180 + w71 * w177
    w182 = w179 - w181
    w183 = w182 * c13
    w184 = 2 * w178
    w185 = w65 * w172
    w186 = link3_theta1_dot * w185 - w171 * link3_theta2_dot
    w187 = 2 * w186
    w188 = (w176 * w184 + w185 * w187) * c13
    w189 = w64 * w172
    w190 = w68 * w171 + w71 * w189
    w191 = w175 * w185 - w71 * w186
    w192 = w172 * w180 - w171 * (w71 * link3_theta2_dot)
    w193 = w191 - w192
    w194 = w193 * c13
    w195 = w174 * w183 - w66 * w188 + w190 * w194
    w196 = w189 + w171 * (w68 * w71)
    w197 = w71 * w173 - w64 * w171
    w198 = w183 * w196 - w69 * w188 + w194 * w197
    w199 = w71 * w188 + w176 * w183 + w185 * w194
    w200 = (w191 + w192) * c22 - w193 * c24
    w201 = w176 * w186 + w178 * w185
    w202 = w65 * link3_theta2_dot
    w203 = (w201 - w202) * c21 - (w201 + w202) * c22
    w204 = w182 * c24 - (w179 + w181) * c21
    w205 = w172 * w175
    w206 = link3_theta1_dot * (w71 * w172) + w172 * link3_theta3_dot
    w207 = w205 - w206
    w208 = w207 * c13
    w209 = (w172 * w184 - w171 * w187) * c13
    w210 = link3_theta1_dot * (w71 * w171) + w171 * link3_theta3_dot
    w211 = w171 * w175
    w212 = w210 - w211
    w213 = w212 * c13
    w214 = w174 * w208 - w66 * w209 + w190 * w213
    w215 = w196 * w208 - w69 * w209 + w197 * w213
    w216 = w71 * w209 + w176 * w208 + w185 * w213
    w217 = w207 * c24 - (w205 + w206) * c21
    w218 = (w210 + w211) * c22 + w212 * c24
    w219 = w172 * w186 - w171 * w178
    w220 = w65 * link3_theta1_dot
    w221 = (w219 - w220) * c21 - (w219 + w220) * c22
    w222 = (w186 + w186) * c22
    w223 = (w178 + w178) * c41
    # outputs
    dQ_hat_dq_i_dot = ca.SX(9, 9)
    # link1.theta1
    dQ_hat_dq_i_dot[0, 0] = -(w2 * w11 - w3 * w16 + w6 * w19 + w22 * w37 + w33 * w44)
    dQ_hat_dq_i_dot[0, 1] = w33 * w83 - (w6 * w85 - (w2 * w87 + w3 * w89) + w22 * w92)
    dQ_hat_dq_i_dot[0, 2] = -(w2 * w96 + w6 * w97)
    dQ_hat_dq_i_dot[0, 3] = -(w22 * w132 + w33 * w138)
    dQ_hat_dq_i_dot[0, 4] = w33 * w158 - w22 * w162
    dQ_hat_dq_i_dot[0, 6] = w33 * w195 - w22 * w198
    dQ_hat_dq_i_dot[0, 7] = w33 * w214 - w22 * w215
    # link1.theta2
    dQ_hat_dq_i_dot[1, 0] = w37 * w45 - (w5 * w11 - w1 * w19) - w44 * w46
    dQ_hat_dq_i_dot[1, 1] = w5 * w87 + w1 * w85 + w76 * (w93 * c9) + w45 * w92 + w46 * w83
    dQ_hat_dq_i_dot[1, 2] = -(w5 * w96 - w1 * w97)
    dQ_hat_dq_i_dot[1, 3] = w76 * (w56 * w115 + w103 * w110 + w112 * w121) + w45 * w132 - w46 * w138
    dQ_hat_dq_i_dot[1, 4] = w76 * (w56 * w147 + w103 * w146 + w112 * w151 + w164) + w45 * w162 + w46 * w158
    dQ_hat_dq_i_dot[1, 6] = w76 * w199 + w45 * w198 + w46 * w195
    dQ_hat_dq_i_dot[1, 7] = w76 * w216 + w45 * w215 + w46 * w214
    # link1.theta3
    dQ_hat_dq_i_dot[2, 0] = -w16
    dQ_hat_dq_i_dot[2, 1] = -w89
    # link2.theta1
    dQ_hat_dq_i_dot[3, 0] = -(w36 * w51 + w43 * w55)
    dQ_hat_dq_i_dot[3, 1] = w55 * w82 - w51 * w91
    dQ_hat_dq_i_dot[3, 3] = -(w103 * w139 - w56 * w141 + w112 * w142 + w50 * w131 + w54 * w137)
    dQ_hat_dq_i_dot[3, 4] = w54 * w157 - (w112 * w165 - (w103 * w166 + w56 * w168) + w50 * w161)
    dQ_hat_dq_i_dot[3, 5] = -(w103 * w169 + w112 * w170)
    dQ_hat_dq_i_dot[3, 6] = w54 * w195 - w50 * w198
    dQ_hat_dq_i_dot[3, 7] = w54 * w214 - w50 * w215
    # link2.theta2
    dQ_hat_dq_i_dot[4, 0] = w36 * w60 - w43 * w63
    dQ_hat_dq_i_dot[4, 1] = w93 * (w48 * c37) + w60 * w91 + w63 * w82
    dQ_hat_dq_i_dot[4, 3] = w58 * w131 - (w98 * w139 - w100 * w142) - w61 * w137
    dQ_hat_dq_i_dot[4, 4] = w98 * w166 + w100 * w165 + w94 * w164 + w58 * w161 + w61 * w157
    dQ_hat_dq_i_dot[4, 5] = -(w98 * w169 - w100 * w170)
    dQ_hat_dq_i_dot[4, 6] = w94 * w199 + w58 * w198 + w61 * w195
    dQ_hat_dq_i_dot[4, 7] = w94 * w216 + w58 * w215 + w61 * w214
    # link2.theta3
    dQ_hat_dq_i_dot[5, 3] = -w141
    dQ_hat_dq_i_dot[5, 4] = -w168
    # link3.theta1
    dQ_hat_dq_i_dot[6, 0] = -(w36 * w67 + w43 * w70)
    dQ_hat_dq_i_dot[6, 1] = w70 * w82 - w67 * w91
    dQ_hat_dq_i_dot[6, 3] = -(w67 * w130 + w70 * w136)
    dQ_hat_dq_i_dot[6, 4] = w70 * w156 - w67 * w160
    dQ_hat_dq_i_dot[6, 6] = -(w176 * w200 - w71 * w203 + w185 * w204)
    dQ_hat_dq_i_dot[6, 7] = -(w185 * w217 - (w176 * w218 + w71 * w221))
    dQ_hat_dq_i_dot[6, 8] = -(w176 * w222 + w185 * w223)
    # link3.theta2
    dQ_hat_dq_i_dot[7, 0] = w36 * w73 - w43 * w74
    dQ_hat_dq_i_dot[7, 1] = w93 * w95 + w73 * w91 + w74 * w82
    dQ_hat_dq_i_dot[7, 3] = w73 * w130 - w74 * w136
    dQ_hat_dq_i_dot[7, 4] = w95 * w163 + w73 * w160 + w74 * w156
    dQ_hat_dq_i_dot[7, 6] = -(w172 * w200 - w171 * w204)
    dQ_hat_dq_i_dot[7, 7] = w172 * w218 + w171 * w217
    dQ_hat_dq_i_dot[7, 8] = -(w172 * w222 - w171 * w223)
    # link3.theta3
    dQ_hat_dq_i_dot[8, 6] = -w203
    dQ_hat_dq_i_dot[8, 7] = -w221
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 9 x 9) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    2267 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 42)
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
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    # intermediate terms (527)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.sin(link1_theta2)
    w5 = w4 * link1_end_x
    w6 = w0 * w5
    w7 = link1_theta2_ddot * w6
    w8 = ca.sin(link1_theta1)
    w9 = w1 * w8
    w10 = w9 * link1_end_x
    w11 = link1_theta1_ddot * w10
    w12 = link1_theta1_dot * link1_theta2_dot
    w13 = w1 * w12
    w14 = w9 * w13
    w15 = w1 * link1_theta3_dot
    w16 = ca.cos(link1_theta3)
    w17 = w15 * w16
    w18 = w4 * link1_theta2_dot
    w19 = ca.sin(link1_theta3)
    w20 = w17 - w18 * w19
    w21 = link1_theta2_dot * link1_theta3_dot
    w22 = w19 * w21
    w23 = link1_theta1_dot * w20 - w22
    w24 = w4 * w8
    w25 = w0 * w16
    w26 = w19 * w24 + w25
    w27 = w23 * w26
    w28 = w15 * w19
    w29 = link1_theta2_dot * w16
    w30 = w28 + w4 * w29
    w31 = w16 * w21
    w32 = link1_theta1_dot * w30 + w31
    w33 = w0 * w19
    w34 = w8 * w16
    w35 = w4 * w34
    w36 = w1 * w19
    w37 = w1 * w16
    w38 = w4 * w13 + w23 * w36 - w32 * w37
    w39 = w10 * w38
    w40 = w4 * link1_theta3_dot
    w41 = link1_theta1_dot - w40
    w42 = w2 * link1_theta3_dot - w8 * link1_theta2_dot
    w43 = w3 * w41
    w44 = w5 * w42 + w43
    w45 = w41 * w44
    w46 = w9 * link1_theta3_dot + w0 * link1_theta2_dot
    w47 = w10 * w42 - w3 * w46
    w48 = w46 * w47
    w49 = w7 + w11 - (w5 * (w14 - w27 - w32 * (w33 - w35)) - w39 - (w45 - w48))
    w50 = w49 * c9
    w51 = ca.cos(link2_theta1)
    w52 = ca.cos(link2_theta3)
    w53 = w51 * w52
    w54 = ca.sin(link2_theta1)
    w55 = ca.sin(link2_theta2)
    w56 = w54 * w55
    w57 = ca.sin(link2_theta3)
    w58 = w53 + w56 * w57
    w59 = link2_theta3_dot - w55 * link2_theta1_dot
    w60 = ca.cos(link2_theta2)
    w61 = w57 * w60
    w62 = w52 * link2_theta2_dot
    w63 = link2_theta1_dot * w61 + w62
    w64 = w59 * w63
    w65 = w52 * w60
    w66 = link2_theta1_ddot * w65 - w57 * link2_theta2_ddot
    w67 = link2_theta3_dot * w60
    w68 = w57 * w67
    w69 = w68 + w55 * w62
    w70 = link2_theta3_dot * link2_theta2_dot
    w71 = w52 * w70
    w72 = link2_theta1_dot * w69 + w71
    w73 = w66 - w72
    w74 = w64 + w73
    w75 = w74 * c11
    w76 = w58 * w75
    w77 = w54 * w60
    w78 = w63**2
    w79 = w57 * link2_theta2_dot
    w80 = link2_theta1_dot * w65 - w79
    w81 = w80**2
    w82 = (w78 + w81) * c11
    w83 = w77 * w82
    w84 = w52 * w54
    w85 = w55 * w84
    w86 = w51 * w57
    w87 = w85 - w86
    w88 = w59 * w80
    w89 = w52 * w67
    w90 = w55 * link2_theta2_dot
    w91 = w89 - w57 * w90
    w92 = w57 * w70
    w93 = link2_theta1_dot * w91 - w92
    w94 = w61 * link2_theta1_ddot + w52 * link2_theta2_ddot
    w95 = w93 + w94
    w96 = w88 - w95
    w97 = w96 * c11
    w98 = w0 * w4
    w99 = w19 * w98 - w34
    w100 = w8 * w19 + w4 * w25
    w101 = w23 * w99 - w2 * w13 - w32 * w100
    w102 = w3 * w38 + w5 * w101
    w103 = w10 * w41
    w104 = w5 * w46 + w103
    w105 = w41 * w104 + w42 * w47
    w106 = w3 * link1_theta1_ddot
    w107 = w5 * w8
    w108 = link1_theta2_ddot * w107
    w109 = w102 - w105 + w106 - w108
    w110 = ca.cos(link3_theta1)
    w111 = ca.cos(link3_theta3)
    w112 = w110 * w111
    w113 = ca.sin(link3_theta1)
    w114 = ca.sin(link3_theta2)
    w115 = w113 * w114
    w116 = ca.sin(link3_theta3)
    w117 = w112 + w115 * w116
    w118 = link3_theta3_dot - w114 * link3_theta1_dot
    w119 = ca.cos(link3_theta2)
    w120 = w116 * w119
    w121 = w111 * link3_theta2_dot
    w122 = link3_theta1_dot * w120 + w121
    w123 = w118 * w122
    w124 = w111 * w119
    w125 = link3_theta1_ddot * w124 - w116 * link3_theta2_ddot
    w126 = link3_theta3_dot * w119
    w127 = w116 * w126
    w128 = w127 + w114 * w121
    w129 = link3_theta3_dot * link3_theta2_dot
    w130 = w111 * w129
    w131 = w125 - (link3_theta1_dot * w128 + w130)
    w132 = w123 + w131
    w133 = w132 * c13
    w134 = w117 * w133
    w135 = w113 * w119
    w136 = w122**2
    w137 = w116 * link3_theta2_dot
    w138 = link3_theta1_dot * w124 - w137
    w139 = w138**2
    w140 = (w136 + w139) * c13
    w141 = w135 * w140
    w142 = w111 * w113
    w143 = w114 * w142
    w144 = w110 * w116
    w145 = w143 - w144
    w146 = w118 * w138
    w147 = w111 * w126
    w148 = w114 * link3_theta2_dot
    w149 = w147 - w116 * w148
    w150 = w116 * w129
    w151 = w120 * link3_theta1_ddot + w111 * link3_theta2_ddot
    w152 = link3_theta1_dot * w149 - w150 + w151
    w153 = w146 - w152
    w154 = w153 * c13
    w155 = link2_theta1_dot * link2_theta2_dot
    w156 = w60 * w155
    w157 = w55 * w156 + w61 * w93 - w65 * w72
    w158 = w51 * w60
    w159 = w158 * link2_end_x
    w160 = w51 * w55
    w161 = w57 * w160 - w84
    w162 = w54 * w57
    w163 = w162 + w53 * w55
    w164 = w93 * w161 - w156 * w158 - w72 * w163
    w165 = w55 * link2_end_x
    w166 = w157 * w159 + w164 * w165
    w167 = w55 * link2_theta3_dot
    w168 = link2_theta1_dot - w167
    w169 = w51 * link2_theta2_dot + link2_theta3_dot * w77
    w170 = w77 * link2_end_x
    w171 = w168 * w170
    w172 = w165 * w169 + w171
    w173 = link2_theta3_dot * w158 - w54 * link2_theta2_dot
    w174 = w170 * w173 - w159 * w169
    w175 = w168 * w172 + w173 * w174
    w176 = link2_theta1_ddot * w159
    w177 = w54 * w165
    w178 = link2_theta2_ddot * w177
    w179 = w109 + (w166 - w175) + w176 - w178
    w180 = w134 - w141 + w145 * w154 + w179 * link3_mass
    w181 = w76 - w83 + w87 * w97 + w109 * link2_mass + w180
    w182 = w75 * w161 - w82 * w158 + w97 * w163
    w183 = w35 - w33
    w184 = w27 - w14 - w32 * w183
    w185 = w48 - w45 - (w39 + w5 * w184) - w11 - w7
    w186 = w110 * w114
    w187 = w116 * w186 - w142
    w188 = w110 * w119
    w189 = w113 * w116
    w190 = w189 + w112 * w114
    w191 = w133 * w187 - w140 * w188 + w154 * w190
    w192 = w169 * w174
    w193 = w159 * w168
    w194 = w193 + w165 * w173
    w195 = w168 * w194
    w196 = w58 * w93
    w197 = w77 * w156
    w198 = w196 - w197 - w72 * w87
    w199 = w157 * w170
    w200 = link2_theta1_ddot * w170
    w201 = w51 * w165
    w202 = link2_theta2_ddot * w201
    w203 = w185 + (w192 - w195 - (w165 * w198 + w199)) - w200 - w202
    w204 = w191 + w203 * link3_mass
    w205 = w182 + w185 * link2_mass + w204
    w206 = w106 - w108 - (w105 - w102)
    w207 = w206 * c9
    w208 = w1 * link1_end_x
    w209 = w10 * w101 - w3 * w184 + (w42 * w44 + w46 * w104) - link1_theta2_ddot * w208
    w210 = w209 - gravity_z
    w211 = w60 * link2_end_x
    w212 = w209 + (w164 * w170 - w159 * w198 + (w173 * w194 + w169 * w172)) - link2_theta2_ddot * w211 - gravity_z
    w213 = w114 * w140 + w120 * w133 + w124 * w154 + w212 * link3_mass
    w214 = w158 * c11
    w215 = w214 + w159 * link3_mass
    w216 = w77 * c11
    w217 = w216 + w170 * link3_mass
    w218 = w55 * c11
    w219 = w56 * c37
    w220 = w160 * c37
    w221 = w188 * c13
    w222 = w135 * c13
    w223 = w114 * c13
    w224 = w113 * w223
    w225 = w110 * w223
    w226 = w8 * w208
    w227 = w98 * link1_end_x
    w228 = w4 * w12
    w229 = w4 * w19
    w230 = w1 * link1_theta2_dot
    w231 = link1_theta1_dot * (w16 * w40 + w19 * w230)
    w232 = link1_theta1_dot * (w1 * w29 - w19 * w40)
    w233 = w4 * w16
    w234 = w1 * w13 - w4 * w228 - (w23 * w229 + w36 * w231) - (w37 * w232 - w32 * w233)
    w235 = w23 * (w2 * w19) - w99 * w231 + link1_theta2_dot * (link1_theta1_dot * (w2 * w4)) * c38 - (w32 * (w1 * w25) + w100 * w232)
    w236 = w46 * w208
    w237 = link1_theta3_dot * w24
    w238 = w24 * link1_end_x
    w239 = w236 - w5 * w237 - (w10 * w15 + w41 * w238)
    w240 = link1_theta3_dot * w98
    w241 = w3 * w237 + w46 * w227 - (w10 * w240 + w42 * w238)
    w242 = w3 * w234 - w38 * w227 + (w5 * w235 + w101 * w208) - (w41 * w239 - w15 * w104 + (w42 * w241 - w47 * w240))
    w243 = link1_theta2_ddot * w226 + link1_theta1_ddot * w227 - w242
    w244 = w243 * c9
    w245 = link1_theta3_dot - w4 * link1_theta1_dot
    w246 = link1_theta2_dot * w19
    w247 = link1_theta1_dot * w37 - w246
    w248 = w245 * w247
    w249 = link1_theta1_ddot * w36 + link1_theta2_ddot * w16
    w250 = w23 + w249
    w251 = (w248 + w250) * c1 - (w248 - w250) * c3
    w252 = w1 * link1_theta1_dot
    w253 = link1_theta1_dot * w233
    w254 = w247 * w252 + w245 * w253
    w255 = w231 + link1_theta1_ddot * w229
    w256 = (w254 + w255) * c1 + (w255 - w254) * c3
    w257 = w29 + link1_theta1_dot * w36
    w258 = w247 * w257
    w259 = link1_theta3_ddot - w4 * link1_theta1_ddot - w13
    w260 = w228 - w1 * link1_theta1_ddot
    w261 = link1_theta1_dot * w229
    w262 = w247 * w261 + w253 * w257
    w263 = (w260 - w262) * c0 + (w260 + w262) * c1
    w264 = w245 * w257
    w265 = link1_theta1_ddot * w37 - link1_theta2_ddot * w19
    w266 = w265 - w32
    w267 = (w264 + w266) * c3 - (w264 - w266) * c0
    w268 = w252 * w257 + w245 * w261
    w269 = w232 + link1_theta1_ddot * w233
    w270 = (w268 + w269) * c3 + (w269 - w268) * c0
    w271 = w229 * w251 + w36 * w256 + (w1 * ((w258 + w259) * c0 - (w258 - w259) * c1) + w4 * w263) + (w233 * w267 + w37 * w270)
    w272 = w0 * w208
    w273 = w42 * w208
    w274 = w273 - w5 * w240 - (w3 * w15 + w41 * w227)
    w275 = w23 * (w9 * w19) - w26 * w231 + link1_theta2_dot * (link1_theta1_dot * (w8 * (w1 * w4))) * c38 - (w32 * (w1 * w34) + w183 * w232)
    w276 = w46 * w241 - w47 * w237 - (w41 * w274 - w15 * w44) - (w5 * w275 + w184 * w208 + (w10 * w234 - w38 * w238))
    w277 = link1_theta2_ddot * w272 - link1_theta1_ddot * w238 - w276
    w278 = w277 * c9
    w279 = w10 * w235 - w101 * w238 - (w3 * w275 - w184 * w227) + (w42 * w274 - w44 * w240 + (w46 * w239 - w104 * w237))
    w280 = link1_theta2_ddot * w5 + w279
    w281 = w19 * w270 - w16 * w256 - w4 * c28 - w205 * w272 - w181 * w226 + w5 * (w55 * w82 + w61 * w75 + w65 * w97 + w210 * link2_mass + w213)
    w282 = w60 * c11
    w283 = w60 * c37
    w284 = w119 * c13
    w285 = w265 - (w31 + link1_theta1_dot * (w28 + w16 * w18))
    w286 = (w285 - w264) * c1 + (w264 + w285) * c3
    w287 = w247**2 - w257**2
    w288 = w287 * c0 - w287 * c1
    w289 = w249 + (link1_theta1_dot * (w17 - w4 * w246) - w22)
    w290 = (w248 - w289) * c3 - (w248 + w289) * c0
    w291 = w86 - w85
    w292 = w200 + w202 - (w165 * (w197 - w196 - w72 * w291) - w199 - (w195 - w192))
    w293 = w292 * link3_mass
    w294 = w293 - w182
    w295 = w176 - w178 - (w175 - w166)
    w296 = w295 * link3_mass
    w297 = w296 - (w83 - w76 + w97 * w291)
    w298 = w177 * w293 - (w180 * w201 + (w109 * (w51 * w218) - w185 * (w54 * w218) - w177 * w204)) + w201 * w296
    w299 = w54 * w211
    w300 = w160 * link2_end_x
    w301 = w55 * w155
    w302 = w55 * w57
    w303 = w60 * link2_theta2_dot
    w304 = link2_theta1_dot * (w52 * w167 + w57 * w303)
    w305 = link2_theta1_dot * (w60 * w62 - w57 * w167)
    w306 = w52 * w55
    w307 = w60 * w156 - w55 * w301 - (w93 * w302 + w61 * w304) - (w65 * w305 - w72 * w306)
    w308 = w57 * w158
    w309 = w53 * w60
    w310 = w93 * w308 - w161 * w304 + link2_theta2_dot * (w60 * (link2_theta1_dot * w160)) * c38 - (w72 * w309 + w163 * w305)
    w311 = w169 * w211
    w312 = w56 * link2_theta3_dot
    w313 = w56 * link2_end_x
    w314 = w311 - w165 * w312 - (w67 * w170 + w168 * w313)
    w315 = link2_theta3_dot * w160
    w316 = w159 * w312 + w169 * w300 - (w170 * w315 + w173 * w313)
    w317 = w159 * w307 - w157 * w300 + (w165 * w310 + w164 * w211) - (w168 * w314 - w67 * w172 + (w173 * w316 - w174 * w315))
    w318 = link2_theta2_ddot * w299 + link2_theta1_ddot * w300 - w317
    w319 = w318 * link3_mass
    w320 = w57 * w77
    w321 = link2_theta1_dot * w60
    w322 = link2_theta1_dot * w302
    w323 = w63 * w321 + w59 * w322
    w324 = w305 + link2_theta1_ddot * w306
    w325 = w323 + w324
    w326 = w325 * c11
    w327 = 2 * w63
    w328 = 2 * w80
    w329 = link2_theta1_dot * w306
    w330 = (w322 * w327 + w328 * w329) * c11
    w331 = w60 * w84
    w332 = w304 + link2_theta1_ddot * w302
    w333 = w80 * w321 + w59 * w329
    w334 = w332 - w333
    w335 = w334 * c11
    w336 = w319 - (w75 * w320 - w58 * w326 + (w56 * w82 + w77 * w330) + (w97 * w331 + w87 * w335))
    w337 = w51 * w211
    w338 = w173 * w211
    w339 = w338 - w165 * w315 - (w67 * w159 + w168 * w300)
    w340 = w93 * w320 - w58 * w304 + link2_theta2_dot * (w60 * (w56 * link2_theta1_dot)) * c38 - (w72 * w331 + w87 * w305)
    w341 = w169 * w316 - w174 * w312 - (w168 * w339 - w67 * w194) - (w165 * w340 + w198 * w211 + (w170 * w307 - w157 * w313))
    w342 = link2_theta2_ddot * w337 - link2_theta1_ddot * w313 - w341
    w343 = w342 * link3_mass
    w344 = w343 - (w75 * w308 - w161 * w326 + (w82 * w160 + w158 * w330) + (w97 * w309 + w163 * w335))
    w345 = w170 * w310 - w164 * w313 - (w159 * w340 - w198 * w300) + (w173 * w339 - w194 * w315 + (w169 * w314 - w172 * w312))
    w346 = link2_theta2_ddot * w165 + w345
    w347 = w346 * link3_mass
    w348 = w208 * (w60 * w82 - w55 * w330 - (w75 * w302 + w61 * w326) + (w65 * w335 - w97 * w306) + w347) - w107 * w336
    w349 = (w88 + w95) * c15 - w96 * c17
    w350 = (w332 + w333) * c15 + w334 * c17
    w351 = w63 * w80
    w352 = link2_theta3_ddot - w55 * link2_theta1_ddot - w156
    w353 = w301 - w60 * link2_theta1_ddot
    w354 = w80 * w322 + w63 * w329
    w355 = (w353 - w354) * c14 + (w353 + w354) * c15
    w356 = w74 * c17 - (w64 - w73) * c14
    w357 = w325 * c17 + (w324 - w323) * c14
    w358 = w302 * w349 + w61 * w350 + (w60 * ((w351 + w352) * c14 - (w351 - w352) * c15) + w55 * w355) + (w306 * w356 + w65 * w357)
    w359 = w159 * w319 - (w185 * (w56 * c11) - w109 * (w160 * c11) - w358 + w204 * w313 - w180 * w300) - w170 * w343
    w360 = w57 * w357 - w52 * w350 - (w185 * (w51 * w282) + w109 * (w54 * w282) - w210 * w218) - w204 * w337
    w361 = w94 + (link2_theta1_dot * (w89 - w55 * w79) - w92)
    w362 = w88 - w361
    w363 = w362 * c11
    w364 = (w80 * w327 - w63 * w328) * c11
    w365 = w66 - (w71 + link2_theta1_dot * (w68 + w52 * w90))
    w366 = w64 + w365
    w367 = w366 * c11
    w368 = w75 * (w162 + w52 * w160) + w161 * w363 - w158 * w364 + (w97 * (w84 - w55 * w86) - w163 * w367)
    w369 = w75 * (w52 * w56 - w86) + w58 * w363 - w77 * w364 - (w97 * (w53 + w55 * w162) + w87 * w367)
    w370 = w208 * (w55 * w364 + (w65 * w75 + w61 * w363) - (w61 * w97 + w65 * w367)) + w107 * w369 + w6 * w368
    w371 = (w365 - w64) * c15 + w366 * c17
    w372 = w81 - w78
    w373 = w372 * c14 - w372 * c15
    w374 = w362 * c17 - (w88 + w361) * c14
    w375 = w141 - w134 + w154 * (w144 - w143)
    w376 = link3_theta1_dot * w119
    w377 = w114 * w116
    w378 = link3_theta1_dot * w377
    w379 = w122 * w376 + w118 * w378
    w380 = w111 * w114
    w381 = w114 * link3_theta3_dot
    w382 = link3_theta1_ddot * w380 + link3_theta1_dot * (w119 * w121 - w116 * w381)
    w383 = w379 + w382
    w384 = w383 * c13
    w385 = 2 * w122
    w386 = 2 * w138
    w387 = link3_theta1_dot * w380
    w388 = (w378 * w385 + w386 * w387) * c13
    w389 = w119 * link3_theta2_dot
    w390 = link3_theta1_dot * (w111 * w381 + w116 * w389) + link3_theta1_ddot * w377
    w391 = w138 * w376 + w118 * w387
    w392 = w390 - w391
    w393 = w392 * c13
    w394 = w133 * (w116 * w188) - w187 * w384 + (w140 * w186 + w188 * w388) + (w154 * (w112 * w119) + w190 * w393)
    w395 = w133 * (w116 * w135) - w117 * w384 + (w115 * w140 + w135 * w388) + (w154 * (w119 * w142) + w145 * w393)
    w396 = w119 * w140 - w114 * w388 - (w133 * w377 + w120 * w384) + (w124 * w393 - w154 * w380)
    w397 = (w146 + w152) * c22 - w153 * c24
    w398 = (w390 + w391) * c22 + w392 * c24
    w399 = w122 * w138
    w400 = link3_theta1_dot * link3_theta2_dot
    w401 = link3_theta3_ddot - w114 * link3_theta1_ddot - w119 * w400
    w402 = w114 * w400 - w119 * link3_theta1_ddot
    w403 = w138 * w378 + w122 * w387
    w404 = (w402 - w403) * c21 + (w402 + w403) * c22
    w405 = w132 * c24 - (w123 - w131) * c21
    w406 = w383 * c24 + (w382 - w379) * c21
    w407 = w377 * w397 + w120 * w398 + (w119 * ((w399 + w401) * c21 - (w399 - w401) * c22) + w114 * w404) + (w380 * w405 + w124 * w406)
    w408 = w151 + (link3_theta1_dot * (w147 - w114 * w137) - w150)
    w409 = w146 - w408
    w410 = w409 * c13
    w411 = (w138 * w385 - w122 * w386) * c13
    w412 = w125 - (w130 + link3_theta1_dot * (w127 + w111 * w148))
    w413 = w123 + w412
    w414 = w413 * c13
    w415 = w133 * (w189 + w111 * w186) + w187 * w410 - w188 * w411 + (w154 * (w142 - w114 * w144) - w190 * w414)
    w416 = w133 * (w111 * w115 - w144) + w117 * w410 - w135 * w411 - (w154 * (w112 + w114 * w189) + w145 * w414)
    w417 = w114 * w411 + (w124 * w133 + w120 * w410) - (w120 * w154 + w124 * w414)
    w418 = (w412 - w123) * c22 + w413 * c24
    w419 = w139 - w136
    w420 = w419 * c21 - w419 * c22
    w421 = w409 * c24 - (w146 + w408) * c21
    w422 = w37 * w245 - w4 * w247
    w423 = (w20 + w422) * c1 - (w422 - w20) * c3
    w424 = w36 * w247 + w37 * w257
    w425 = (w424 - w230) * c0 - (w230 + w424) * c1
    w426 = w36 * w245 - w4 * w257
    w427 = (w426 - w30) * c3 - (w30 + w426) * c0
    w428 = w4 * w230 + w20 * w36 - w30 * w37
    w429 = w3 * w428 + w5 * (w20 * w99 - w2 * w230 - w30 * w100) - (w103 + w104)
    w430 = w429 * c9
    w431 = w43 + w44 + (w5 * (w20 * w26 - w9 * w230 - w30 * w183) + w10 * w428)
    w432 = w431 * c9
    w433 = w261 + link1_theta3_dot * w19
    w434 = w253 + link1_theta3_dot * w16
    w435 = w4 * w252 - w36 * w433 - w37 * w434
    w436 = w26 * w433 + w9 * w252 + w183 * w434
    w437 = w0 * w47 - w236 + w41 * w107 - (w10 * w435 - w5 * w436)
    w438 = w437 * c9
    w439 = w16 * w245
    w440 = (w439 - w434) * c3 - (w434 + w439) * c0
    w441 = w19 * w245
    w442 = (w433 + w441) * c1 + (w433 - w441) * c3
    w443 = w16 * w247 - w19 * w257
    w444 = (w443 - w252) * c0 - (w252 + w443) * c1
    w445 = w99 * w433 + w2 * w252 + w100 * w434
    w446 = w3 * w435 - w5 * w445 - (w6 * w41 - (w273 + w8 * w47))
    w447 = w446 * c9
    w448 = w3 * w436 - w10 * w445 + (w0 * w104 + w6 * w46 - (w8 * w44 + w42 * w107))
    w449 = (w247 + w247) * c1
    w450 = (w257 + w257) * c39
    w451 = w59 * w61 - w55 * w63
    w452 = w451 - w69
    w453 = w452 * c11
    w454 = (w61 * w327 + w65 * w328) * c11
    w455 = w59 * w65 - w55 * w80
    w456 = w455 - w91
    w457 = w456 * c11
    w458 = w55 * w303 + w61 * w91 - w65 * w69
    w459 = w159 * w458 + w165 * (w91 * w161 - w158 * w303 - w69 * w163) - (w171 + w172)
    w460 = w459 * link3_mass
    w461 = w58 * w453 - w77 * w454 + w87 * w457 + w460
    w462 = w193 + w194 + (w165 * (w58 * w91 - w77 * w303 - w69 * w87) + w170 * w458)
    w463 = w462 * link3_mass
    w464 = w463 - (w161 * w453 - w158 * w454 + w163 * w457)
    w465 = (w91 + w455) * c15 - w456 * c17
    w466 = w61 * w80 + w63 * w65
    w467 = (w466 - w303) * c14 - (w303 + w466) * c15
    w468 = w452 * c17 - (w69 + w451) * c14
    w469 = w52 * w59
    w470 = w329 + w52 * link2_theta3_dot
    w471 = w469 - w470
    w472 = w471 * c11
    w473 = (w52 * w327 - w57 * w328) * c11
    w474 = w322 + w57 * link2_theta3_dot
    w475 = w57 * w59
    w476 = w474 - w475
    w477 = w476 * c11
    w478 = w55 * w321 - w61 * w474 - w65 * w470
    w479 = w58 * w474 + w77 * w321 + w87 * w470
    w480 = w51 * w174 - w311 + w168 * w177 - (w170 * w478 - w165 * w479)
    w481 = w480 * link3_mass
    w482 = w161 * w472 - w158 * w473 + w163 * w477 + w481
    w483 = w161 * w474 + w158 * w321 + w163 * w470
    w484 = w159 * w478 - w165 * w483 - (w168 * w201 - (w338 + w54 * w174))
    w485 = w484 * link3_mass
    w486 = w58 * w472 - w77 * w473 + w87 * w477 + w485
    w487 = w159 * w479 - w170 * w483 + (w51 * w172 + w169 * w201 - (w54 * w194 + w173 * w177))
    w488 = w487 * link3_mass
    w489 = w471 * c17 - (w469 + w470) * c14
    w490 = (w474 + w475) * c15 + w476 * c17
    w491 = w52 * w80 - w57 * w63
    w492 = (w491 - w321) * c14 - (w321 + w491) * c15
    w493 = (w80 + w80) * c15
    w494 = (w63 + w63) * c40
    w495 = w118 * w120 - w114 * w122
    w496 = w495 - w128
    w497 = w496 * c13
    w498 = (w120 * w385 + w124 * w386) * c13
    w499 = w118 * w124 - w114 * w138
    w500 = w499 - w149
    w501 = w500 * c13
    w502 = w187 * w497 - w188 * w498 + w190 * w501
    w503 = w117 * w497 - w135 * w498 + w145 * w501
    w504 = w114 * w498 + w120 * w497 + w124 * w501
    w505 = (w149 + w499) * c22 - w500 * c24
    w506 = w120 * w138 + w122 * w124
    w507 = (w506 - w389) * c21 - (w389 + w506) * c22
    w508 = w496 * c24 - (w128 + w495) * c21
    w509 = w111 * w118
    w510 = w387 + w111 * link3_theta3_dot
    w511 = w509 - w510
    w512 = w511 * c13
    w513 = (w111 * w385 - w116 * w386) * c13
    w514 = w378 + w116 * link3_theta3_dot
    w515 = w116 * w118
    w516 = w514 - w515
    w517 = w516 * c13
    w518 = w187 * w512 - w188 * w513 + w190 * w517
    w519 = w117 * w512 - w135 * w513 + w145 * w517
    w520 = w114 * w513 + w120 * w512 + w124 * w517
    w521 = w511 * c24 - (w509 + w510) * c21
    w522 = (w514 + w515) * c22 + w516 * c24
    w523 = w111 * w138 - w116 * w122
    w524 = (w523 - w376) * c21 - (w376 + w523) * c22
    w525 = (w138 + w138) * c22
    w526 = (w122 + w122) * c41
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w50 + (w10 * w181 + w3 * w205) - w10 * w207,
            w3 * w244 - (w205 * w238 - w271 - w181 * w227) - w10 * w278,
            -(w37 * w251 + w36 * w286 - w4 * w288 + (w37 * w290 - w36 * w267)), w3 * w294 - w10 * w297,
            w3 * w336 - w10 * w344, w10 * w368 - w3 * w369, w10 * w375 - w3 * w191, w10 * w394 - w3 * w395,
            w10 * w415 - w3 * w416,
        ),
        ca.horzcat(  # link1.theta2
            -(w107 * w205 - w6 * w181 + w50 * w107 + w6 * w207),
            w208 * (w280 * c9) - w281 - w107 * w244 - w6 * w278,
            -(w16 * w286 - w19 * w251 - (w16 * w267 + w19 * w290)), -(w107 * w294 + w6 * w297), w348 - w6 * w344,
            w370, w107 * w191 + w6 * w375, w208 * w396 + w107 * w395 + w6 * w394,
            w208 * w417 + w107 * w416 + w6 * w415,
        ),
        ca.horzcat(0.0, -w263, -w288, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w49 * w215 - w206 * w217, w215 * w243 - w217 * w277, 0.0,
            w159 * w293 + (w170 * w180 + (w159 * w204 + (w109 * w216 + w185 * w214))) - w170 * w296, w359,
            -(w65 * w349 + w61 * w371 - w55 * w373 + (w65 * w374 - w61 * w356)), w170 * w375 - w159 * w191,
            w170 * w394 - w159 * w395, w170 * w415 - w159 * w416,
        ),
        ca.horzcat(  # link2.theta2
            -(w49 * w219 + w206 * w220), w280 * w283 - w219 * w243 - w220 * w277, 0.0, -w298,
            w211 * w347 - (w360 - w180 * w299 + w165 * w213) - w177 * w319 - w201 * w343,
            -(w52 * w371 - w57 * w349 - (w52 * w356 + w57 * w374)), w177 * w191 + w201 * w375,
            w211 * w396 + w177 * w395 + w201 * w394, w211 * w417 + w177 * w416 + w201 * w415,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w355, -w373, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            w49 * w221 - w206 * w222, w221 * w243 - w222 * w277, 0.0, w221 * w292 - w222 * w295,
            w221 * w318 - w222 * w342, 0.0, w179 * w222 + w203 * w221,
            -(w203 * (w115 * c13) - w179 * (w186 * c13) - w407),
            -(w124 * w397 + w120 * w418 - w114 * w420 + (w124 * w421 - w120 * w405)),
        ),
        ca.horzcat(  # link3.theta2
            -(w49 * w224 + w206 * w225), w280 * w284 - w224 * w243 - w225 * w277, 0.0, -(w224 * w292 + w225 * w295),
            w284 * w346 - w224 * w318 - w225 * w342, 0.0, w179 * w225 - w203 * w224,
            -(w116 * w406 - w111 * w398 - (w203 * (w110 * w284) + w179 * (w113 * w284) - w212 * w223)),
            -(w111 * w418 - w116 * w397 - (w111 * w405 + w116 * w421)),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w404, -w420),  # link3.theta3
    )
    J_v = ca.SX(9, 9)
    # link1.theta1
    J_v[0, 0] = -(w36 * w423 - w4 * w425 + w37 * w427 + w3 * w430 + w10 * w432)
    J_v[0, 1] = w10 * w438 - (w37 * w440 - (w36 * w442 + w4 * w444) + w3 * w447)
    J_v[0, 2] = -(w36 * w449 + w37 * w450)
    J_v[0, 3] = -(w3 * w461 + w10 * w464)
    J_v[0, 4] = w10 * w482 - w3 * w486
    J_v[0, 6] = w10 * w502 - w3 * w503
    J_v[0, 7] = w10 * w518 - w3 * w519
    # link1.theta2
    J_v[1, 0] = w107 * w430 - (w16 * w423 - w19 * w427) - w6 * w432
    J_v[1, 1] = w16 * w442 + w19 * w440 + w208 * (w448 * c9) + w107 * w447 + w6 * w438
    J_v[1, 2] = -(w16 * w449 - w19 * w450)
    J_v[1, 3] = w208 * (w55 * w454 + w61 * w453 + w65 * w457) + w107 * w461 - w6 * w464
    J_v[1, 4] = w208 * (w55 * w473 + w61 * w472 + w65 * w477 + w488) + w107 * w486 + w6 * w482
    J_v[1, 6] = w208 * w504 + w107 * w503 + w6 * w502
    J_v[1, 7] = w208 * w520 + w107 * w519 + w6 * w518
    # link1.theta3
    J_v[2, 0] = -w425
    J_v[2, 1] = -w444
    # link2.theta1
    J_v[3, 0] = -(w215 * w429 + w217 * w431)
    J_v[3, 1] = w217 * w437 - w215 * w446
    J_v[3, 3] = -(w61 * w465 - w55 * w467 + w65 * w468 + w159 * w460 + w170 * w463)
    J_v[3, 4] = w170 * w481 - (w65 * w489 - (w61 * w490 + w55 * w492) + w159 * w485)
    J_v[3, 5] = -(w61 * w493 + w65 * w494)
    J_v[3, 6] = w170 * w502 - w159 * w503
    J_v[3, 7] = w170 * w518 - w159 * w519
    # link2.theta2
    J_v[4, 0] = w219 * w429 - w220 * w431
    J_v[4, 1] = w283 * w448 + w219 * w446 + w220 * w437
    J_v[4, 3] = w177 * w460 - (w52 * w465 - w57 * w468) - w201 * w463
    J_v[4, 4] = w52 * w490 + w57 * w489 + w211 * w488 + w177 * w485 + w201 * w481
    J_v[4, 5] = -(w52 * w493 - w57 * w494)
    J_v[4, 6] = w211 * w504 + w177 * w503 + w201 * w502
    J_v[4, 7] = w211 * w520 + w177 * w519 + w201 * w518
    # link2.theta3
    J_v[5, 3] = -w467
    J_v[5, 4] = -w492
    # link3.theta1
    J_v[6, 0] = -(w221 * w429 + w222 * w431)
    J_v[6, 1] = w222 * w437 - w221 * w446
    J_v[6, 3] = -(w221 * w459 + w222 * w462)
    J_v[6, 4] = w222 * w480 - w221 * w484
    J_v[6, 6] = -(w120 * w505 - w114 * w507 + w124 * w508)
    J_v[6, 7] = -(w124 * w521 - (w120 * w522 + w114 * w524))
    J_v[6, 8] = -(w120 * w525 + w124 * w526)
    # link3.theta2
    J_v[7, 0] = w224 * w429 - w225 * w431
    J_v[7, 1] = w284 * w448 + w224 * w446 + w225 * w437
    J_v[7, 3] = w224 * w459 - w225 * w462
    J_v[7, 4] = w284 * w487 + w224 * w484 + w225 * w480
    J_v[7, 6] = -(w111 * w505 - w116 * w508)
    J_v[7, 7] = w111 * w522 + w116 * w521
    J_v[7, 8] = -(w111 * w525 - w116 * w526)
    # link3.theta3
    J_v[8, 6] = -w507
    J_v[8, 7] = -w524
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    844 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 42)
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
