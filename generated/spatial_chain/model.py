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
    1643 operations.
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
    # intermediate terms (405)
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
    w34 = w1 * w20
    w35 = w10 * w33 + w34
    w36 = w23 * w26 - w5 * w28 - w32 * w35
    w37 = w0 * w20
    w38 = w0 * w17
    w39 = w10 * w28 + w23 * w37 - w32 * w38
    w40 = w13 * w36 + w8 * w39
    w41 = w15 - w40
    w42 = w41 * link3_mass
    w43 = w41 * link2_mass + w42
    w44 = ca.cos(link2_theta1)
    w45 = ca.sin(link2_theta2)
    w46 = w44 * w45
    w47 = ca.sin(link2_theta3)
    w48 = ca.cos(link2_theta3)
    w49 = ca.sin(link2_theta1)
    w50 = w48 * w49
    w51 = w46 * w47 - w50
    w52 = link2_theta3_dot - w45 * link2_theta1_dot
    w53 = ca.cos(link2_theta2)
    w54 = w47 * w53
    w55 = w48 * link2_theta2_dot
    w56 = link2_theta1_dot * w54 + w55
    w57 = w52 * w56
    w58 = link2_theta3_dot * w53
    w59 = w47 * w58
    w60 = link2_theta3_dot * link2_theta2_dot
    w61 = w48 * w60
    w62 = link2_theta1_dot * (w59 + w45 * w55) + w61
    w63 = w57 - w62
    w64 = w63 * c11
    w65 = w44 * w53
    w66 = w56**2
    w67 = w48 * w53
    w68 = w47 * link2_theta2_dot
    w69 = link2_theta1_dot * w67 - w68
    w70 = w69**2
    w71 = (w66 + w70) * c11
    w72 = w47 * w49
    w73 = w44 * w48
    w74 = w72 + w45 * w73
    w75 = w52 * w69
    w76 = w48 * w58
    w77 = w45 * link2_theta2_dot
    w78 = w47 * w60
    w79 = link2_theta1_dot * (w76 - w47 * w77) - w78
    w80 = w75 - w79
    w81 = w80 * c11
    w82 = w51 * w64 - w65 * w71 + w74 * w81
    w83 = w7 * w9
    w84 = w8 * w12 + w6 * w13
    w85 = w12 * w84
    w86 = w1 * w10
    w87 = w33 + w20 * w86
    w88 = w23 * w87
    w89 = w2 * w28
    w90 = w10 * w25
    w91 = w4 * w20
    w92 = w90 - w91
    w93 = w88 - w89 - w32 * w92
    w94 = w3 * w39
    w95 = w83 - w85 - (w13 * w93 + w94)
    w96 = ca.cos(link3_theta1)
    w97 = ca.sin(link3_theta2)
    w98 = w96 * w97
    w99 = ca.sin(link3_theta3)
    w100 = ca.cos(link3_theta3)
    w101 = ca.sin(link3_theta1)
    w102 = w100 * w101
    w103 = w98 * w99 - w102
    w104 = link3_theta3_dot - w97 * link3_theta1_dot
    w105 = ca.cos(link3_theta2)
    w106 = w99 * w105
    w107 = w100 * link3_theta2_dot
    w108 = link3_theta1_dot * w106 + w107
    w109 = w104 * w108
    w110 = link3_theta3_dot * w105
    w111 = w99 * w110
    w112 = link3_theta3_dot * link3_theta2_dot
    w113 = w100 * w112
    w114 = link3_theta1_dot * (w111 + w97 * w107) + w113
    w115 = w109 - w114
    w116 = w115 * c13
    w117 = w96 * w105
    w118 = w108**2
    w119 = w100 * w105
    w120 = w99 * link3_theta2_dot
    w121 = link3_theta1_dot * w119 - w120
    w122 = w121**2
    w123 = (w118 + w122) * c13
    w124 = w99 * w101
    w125 = w96 * w100
    w126 = w124 + w97 * w125
    w127 = w104 * w121
    w128 = w100 * w110
    w129 = w97 * link3_theta2_dot
    w130 = w99 * w112
    w131 = link3_theta1_dot * (w128 - w99 * w129) - w130
    w132 = w127 - w131
    w133 = w132 * c13
    w134 = w103 * w116 - w117 * w123 + w126 * w133
    w135 = w49 * w53
    w136 = w44 * link2_theta2_dot + link2_theta3_dot * w135
    w137 = link2_theta3_dot * w65 - w49 * link2_theta2_dot
    w138 = w135 * link2_end_x
    w139 = w65 * link2_end_x
    w140 = w137 * w138 - w136 * w139
    w141 = w136 * w140
    w142 = w45 * link2_theta3_dot
    w143 = link2_theta1_dot - w142
    w144 = w45 * link2_end_x
    w145 = w139 * w143 + w137 * w144
    w146 = w143 * w145
    w147 = w45 * w49
    w148 = w73 + w47 * w147
    w149 = w79 * w148
    w150 = link2_theta1_dot * link2_theta2_dot
    w151 = w53 * w150
    w152 = w135 * w151
    w153 = w45 * w50
    w154 = w44 * w47
    w155 = w153 - w154
    w156 = w149 - w152 - w62 * w155
    w157 = w45 * w151 + w54 * w79 - w62 * w67
    w158 = w138 * w157
    w159 = w95 + (w141 - w146 - (w144 * w156 + w158))
    w160 = w134 + w159 * link3_mass
    w161 = w82 + w95 * link2_mass + w160
    w162 = w89 - w88 - w32 * (w91 - w90)
    w163 = w13 * w162 - w94 - (w85 - w83)
    w164 = w163 * link3_mass
    w165 = w163 * link2_mass + w164
    w166 = w64 * w148
    w167 = w71 * w135
    w168 = w40 - w15
    w169 = w97 * w101
    w170 = w125 + w99 * w169
    w171 = w116 * w170
    w172 = w101 * w105
    w173 = w123 * w172
    w174 = w97 * w102
    w175 = w96 * w99
    w176 = w174 - w175
    w177 = w51 * w79 - w65 * w151 - w62 * w74
    w178 = w139 * w157 + w144 * w177
    w179 = w136 * w144 + w138 * w143
    w180 = w143 * w179 + w137 * w140
    w181 = w168 + (w178 - w180)
    w182 = w171 - w173 + w133 * w176 + w181 * link3_mass
    w183 = w166 - w167 + w81 * w155 + w168 * link2_mass + w182
    w184 = w0 * link1_end_x
    w185 = w8 * w36
    w186 = w3 * w162 + w185 - (w185 - w3 * w93)
    w187 = w3 * w36 - w8 * w93 + (w6 * w84 + w7 * w14)
    w188 = w187 - gravity_z
    w189 = w187 + (w138 * w177 - w139 * w156 + (w137 * w145 + w136 * w179)) - gravity_z
    w190 = w97 * w123 + w106 * w116 + w119 * w133 + w189 * link3_mass
    w191 = w1 * w13
    w192 = w4 * w13
    w193 = w184 * (w186 * link2_mass + w186 * link3_mass) + (w165 * w191 + w183 * w192) + (w43 * w192 - w161 * w191)
    w194 = w65 * c11
    w195 = w135 * c11
    w196 = w53 * link2_end_x
    w197 = w45 * c11
    w198 = w44 * w197
    w199 = w49 * w197
    w200 = w53 * c11
    w201 = w49 * w144
    w202 = w44 * w144
    w203 = w117 * c13
    w204 = w172 * c13
    w205 = w97 * c13
    w206 = w96 * w205
    w207 = w101 * w205
    w208 = w105 * c13
    w209 = link1_theta3_dot * w86
    w210 = w24 * link1_end_x
    w211 = link1_theta3_dot * w24
    w212 = w86 * link1_end_x
    w213 = w8 * w209 + w7 * w210 - (w3 * w211 + w6 * w212)
    w214 = w6 * w184 - w13 * w211 - (w8 * w16 + w12 * w210)
    w215 = link1_theta1_dot * (w11 * w17 + w20 * (w0 * link1_theta2_dot))
    w216 = w10 * w27
    w217 = link1_theta1_dot * (w0 * w30 - w11 * w20)
    w218 = w23 * (w2 * w20) - w87 * w215 + w10 * (link1_theta1_dot * (w2 * link1_theta2_dot)) * c38 - (w32 * (w0 * w25) + w92 * w217)
    w219 = w10 * w20
    w220 = w10 * w17
    w221 = w0 * w28 - w10 * w216 - (w23 * w219 + w37 * w215) - (w38 * w217 - w32 * w220)
    w222 = w7 * w213 - w9 * w209 - (w12 * w214 - w16 * w84) - (w13 * w218 + w93 * w184 + (w3 * w221 - w39 * w212))
    w223 = w222 * link3_mass
    w224 = w222 * link2_mass + w223
    w225 = w23 * (w5 * w20) - w26 * w215 + w10 * (link1_theta1_dot * (w5 * link1_theta2_dot)) * c38 - (w32 * (w0 * w33) + w35 * w217)
    w226 = w7 * w184 - w13 * w209 - (w3 * w16 + w12 * w212)
    w227 = w8 * w221 - w39 * w210 + (w13 * w225 + w36 * w184) - (w12 * w226 - w14 * w16 + (w6 * w213 - w9 * w211))
    w228 = w227 * link3_mass
    w229 = w227 * link2_mass + w228
    w230 = link1_theta3_dot - link1_theta1_dot * w10
    w231 = link1_theta2_dot * w20
    w232 = link1_theta1_dot * w38 - w231
    w233 = w230 * w232
    w234 = (w23 + w233) * c1 - (w233 - w23) * c3
    w235 = w0 * link1_theta1_dot
    w236 = link1_theta1_dot * w220
    w237 = w232 * w235 + w230 * w236
    w238 = (w215 + w237) * c1 + (w215 - w237) * c3
    w239 = w30 + link1_theta1_dot * w37
    w240 = w232 * w239
    w241 = link1_theta1_dot * w219
    w242 = w232 * w241 + w236 * w239
    w243 = (w216 - w242) * c0 + (w216 + w242) * c1
    w244 = w230 * w239
    w245 = (w244 - w32) * c3 - (w32 + w244) * c0
    w246 = w235 * w239 + w230 * w241
    w247 = (w217 + w246) * c3 + (w217 - w246) * c0
    w248 = w219 * w234 + w37 * w238 + (w0 * ((w240 - w28) * c0 - (w28 + w240) * c1) + w10 * w243) + (w220 * w245 + w38 * w247)
    w249 = w3 * w225 - w36 * w212 - (w8 * w218 - w93 * w210) + (w6 * w214 - w84 * w211 + (w7 * w226 - w14 * w209))
    w250 = w184 * (w249 * link2_mass + w249 * link3_mass) - w13 * (w45 * w71 + w54 * w64 + w67 * w81 + w188 * link2_mass + w190)
    w251 = w250 - (w20 * w247 - w17 * w238 - w10 * c28) + (w191 * w229 + w183 * (w1 * w184)) + (w192 * w224 + w161 * (w4 * w184))
    w252 = w31 + link1_theta1_dot * (w29 + w17 * w19)
    w253 = link1_theta1_dot * (w18 - w10 * w231) - w22
    w254 = w23 * (w17 * w86 - w91) - w87 * w252 - (w92 * w253 - w32 * (w33 + w10 * w34))
    w255 = w23 * w38 - w37 * w252 - (w38 * w253 - w32 * w37)
    w256 = w13 * w254 + w3 * w255
    w257 = w256 * link3_mass
    w258 = w256 * link2_mass + w257
    w259 = (w244 + w252) * c1 + (w252 - w244) * c3
    w260 = w232**2 - w239**2
    w261 = w260 * c0 - w260 * c1
    w262 = (w233 - w253) * c3 - (w233 + w253) * c0
    w263 = w23 * (w34 + w17 * w24) - w26 * w252 - (w32 * (w25 - w10 * w91) + w35 * w253)
    w264 = w8 * w255 + w13 * w263
    w265 = w264 * link3_mass
    w266 = w264 * link2_mass + w265
    w267 = w3 * w263 - w8 * w254
    w268 = w184 * (w267 * link2_mass + w267 * link3_mass) + (w20 * w234 + w17 * w259 + (w17 * w245 + w20 * w262))
    w269 = w154 - w153
    w270 = w180 - w178
    w271 = w270 * link3_mass
    w272 = w167 - w166 + w81 * w269 + w271
    w273 = w152 - w149 - w62 * w269
    w274 = w144 * w273 - w158 - (w146 - w141)
    w275 = w274 * link3_mass
    w276 = w82 + w275
    w277 = w139 * w177
    w278 = w138 * w273 + w277 - (w277 - w138 * w156)
    w279 = w278 * link3_mass
    w280 = w196 * w279 + (w168 * w198 - w95 * w199) + (w201 * w275 + w182 * w202) + (w202 * w271 - w160 * w201)
    w281 = w47 * w65
    w282 = link2_theta1_dot * w53
    w283 = w45 * w47
    w284 = link2_theta1_dot * w283
    w285 = w56 * w282 + w52 * w284
    w286 = link2_theta1_dot * (w53 * w55 - w47 * w142)
    w287 = w285 + w286
    w288 = w287 * c11
    w289 = 2 * w56
    w290 = 2 * w69
    w291 = w45 * w48
    w292 = link2_theta1_dot * w291
    w293 = (w284 * w289 + w290 * w292) * c11
    w294 = w53 * w73
    w295 = link2_theta1_dot * (w48 * w142 + w47 * (w53 * link2_theta2_dot))
    w296 = w69 * w282 + w52 * w292
    w297 = w295 - w296
    w298 = w297 * c11
    w299 = link2_theta3_dot * w147
    w300 = w46 * link2_end_x
    w301 = w46 * link2_theta3_dot
    w302 = w147 * link2_end_x
    w303 = w139 * w299 + w136 * w300 - (w138 * w301 + w137 * w302)
    w304 = w137 * w196 - w144 * w301 - (w58 * w139 + w143 * w300)
    w305 = w47 * w135
    w306 = w45 * w150
    w307 = w50 * w53
    w308 = w79 * w305 - w148 * w295 + link2_theta2_dot * (w53 * (link2_theta1_dot * w147)) * c38 - (w62 * w307 + w155 * w286)
    w309 = w53 * w151 - w45 * w306 - (w79 * w283 + w54 * w295) - (w67 * w286 - w62 * w291)
    w310 = w136 * w303 - w140 * w299 - (w143 * w304 - w58 * w145) - (w144 * w308 + w156 * w196 + (w138 * w309 - w157 * w302))
    w311 = w310 * link3_mass
    w312 = w64 * w281 - w51 * w288 + (w46 * w71 + w65 * w293) + (w81 * w294 + w74 * w298) + w311
    w313 = w79 * w281 - w51 * w295 + link2_theta2_dot * (w53 * (w46 * link2_theta1_dot)) * c38 - (w62 * w294 + w74 * w286)
    w314 = w136 * w196 - w144 * w299 - (w58 * w138 + w143 * w302)
    w315 = w139 * w309 - w157 * w300 + (w144 * w313 + w177 * w196) - (w143 * w314 - w58 * w179 + (w137 * w303 - w140 * w301))
    w316 = w315 * link3_mass
    w317 = w64 * w305 - w148 * w288 + (w71 * w147 + w135 * w293) + (w81 * w307 + w155 * w298) + w316
    w318 = w138 * w313 - w177 * w302 - (w139 * w308 - w156 * w300) + (w137 * w304 - w145 * w301 + (w136 * w314 - w179 * w299))
    w319 = w318 * link3_mass
    w320 = w184 * (w53 * w71 - w45 * w293 - (w64 * w283 + w54 * w288) + (w67 * w298 - w81 * w291) + w319) + w191 * w317
    w321 = (w75 + w79) * c15 - w80 * c17
    w322 = (w295 + w296) * c15 + w297 * c17
    w323 = w56 * w69
    w324 = w69 * w284 + w56 * w292
    w325 = (w306 - w324) * c14 + (w306 + w324) * c15
    w326 = w63 * c17 - (w57 + w62) * c14
    w327 = w287 * c17 + (w286 - w285) * c14
    w328 = w283 * w321 + w54 * w322 + (w53 * ((w323 - w151) * c14 - (w151 + w323) * c15) + w45 * w325) + (w291 * w326 + w67 * w327)
    w329 = w138 * w311 - w160 * w302 - (w95 * (w147 * c11) - w168 * (w46 * c11) - w328 + (w139 * w316 - w182 * w300))
    w330 = w196 * w319 - w144 * w190 - (w47 * w327 - w48 * w322 - (w95 * (w44 * w200) + w168 * (w49 * w200) - w188 * w197))
    w331 = w72 + w46 * w48
    w332 = link2_theta1_dot * (w76 - w45 * w68) - w78
    w333 = w75 - w332
    w334 = w333 * c11
    w335 = (w69 * w289 - w56 * w290) * c11
    w336 = w50 - w45 * w154
    w337 = w61 + link2_theta1_dot * (w59 + w48 * w77)
    w338 = w337 - w57
    w339 = w338 * c11
    w340 = w48 * w147 - w154
    w341 = w73 + w45 * w72
    w342 = w79 * w340 - w148 * w337 - (w155 * w332 - w62 * w341)
    w343 = w67 * w79 - w54 * w337 - (w67 * w332 - w54 * w62)
    w344 = w144 * w342 + w138 * w343
    w345 = w344 * link3_mass
    w346 = w64 * w331 + w51 * w334 - w65 * w335 + (w81 * w336 + w74 * w339) - w345
    w347 = w79 * w331 - w51 * w337 - (w62 * w336 + w74 * w332)
    w348 = w139 * w343 + w144 * w347
    w349 = w348 * link3_mass
    w350 = w64 * w340 + w148 * w334 - w135 * w335 + (w155 * w339 - w81 * w341) + w349
    w351 = w138 * w347 - w139 * w342
    w352 = w351 * link3_mass
    w353 = w184 * (w45 * w335 + (w64 * w67 + w54 * w334) + (w67 * w339 - w54 * w81) + w352) + w191 * w350 + w192 * w346
    w354 = (w57 + w337) * c15 + w338 * c17
    w355 = w70 - w66
    w356 = w355 * c14 - w355 * c15
    w357 = w333 * c17 - (w75 + w332) * c14
    w358 = -(w138 * w345 + (w67 * w321 - w54 * w354 - w45 * w356 + (w67 * w357 - w54 * w326) + w139 * w349))
    w359 = w173 - w171 + w133 * (w175 - w174)
    w360 = link3_theta1_dot * w105
    w361 = w97 * w99
    w362 = link3_theta1_dot * w361
    w363 = w108 * w360 + w104 * w362
    w364 = w97 * link3_theta3_dot
    w365 = link3_theta1_dot * (w105 * w107 - w99 * w364)
    w366 = w363 + w365
    w367 = w366 * c13
    w368 = 2 * w108
    w369 = 2 * w121
    w370 = w97 * w100
    w371 = link3_theta1_dot * w370
    w372 = (w362 * w368 + w369 * w371) * c13
    w373 = link3_theta1_dot * (w100 * w364 + w99 * (w105 * link3_theta2_dot))
    w374 = w121 * w360 + w104 * w371
    w375 = w373 - w374
    w376 = w375 * c13
    w377 = w116 * (w99 * w117) - w103 * w367 + (w98 * w123 + w117 * w372) + (w133 * (w105 * w125) + w126 * w376)
    w378 = w116 * (w99 * w172) - w170 * w367 + (w123 * w169 + w172 * w372) + (w133 * (w102 * w105) + w176 * w376)
    w379 = w105 * w123 - w97 * w372 - (w116 * w361 + w106 * w367) + (w119 * w376 - w133 * w370)
    w380 = (w127 + w131) * c22 - w132 * c24
    w381 = (w373 + w374) * c22 + w375 * c24
    w382 = w108 * w121
    w383 = link3_theta1_dot * link3_theta2_dot
    w384 = w105 * w383
    w385 = w97 * w383
    w386 = w121 * w362 + w108 * w371
    w387 = (w385 - w386) * c21 + (w385 + w386) * c22
    w388 = w115 * c24 - (w109 + w114) * c21
    w389 = w366 * c24 + (w365 - w363) * c21
    w390 = w361 * w380 + w106 * w381 + (w105 * ((w382 - w384) * c21 - (w382 + w384) * c22) + w97 * w387) + (w370 * w388 + w119 * w389)
    w391 = link3_theta1_dot * (w128 - w97 * w120) - w130
    w392 = w127 - w391
    w393 = w392 * c13
    w394 = (w121 * w368 - w108 * w369) * c13
    w395 = w113 + link3_theta1_dot * (w111 + w100 * w129)
    w396 = w395 - w109
    w397 = w396 * c13
    w398 = w116 * (w124 + w98 * w100) + w103 * w393 - w117 * w394 + (w133 * (w102 - w97 * w175) + w126 * w397)
    w399 = w116 * (w100 * w169 - w175) + w170 * w393 - w172 * w394 + (w176 * w397 - w133 * (w125 + w97 * w124))
    w400 = w97 * w394 + (w116 * w119 + w106 * w393) + (w119 * w397 - w106 * w133)
    w401 = (w109 + w395) * c22 + w396 * c24
    w402 = w122 - w118
    w403 = w402 * c21 - w402 * c22
    w404 = w392 * c24 - (w127 + w391) * c21
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w43 + w8 * w161 - (w8 * w165 - w3 * w183),
            w3 * w224 - w161 * w212 - (w8 * w229 - w183 * w210 - w248),
            -(w3 * w258 + (w38 * w234 - w37 * w259 - w10 * w261 + (w38 * w262 - w37 * w245) + w8 * w266)),
            w3 * w272 - w8 * w276, w3 * w312 - w8 * w317, w3 * w346 - w8 * w350, w3 * w359 - w8 * w134,
            w3 * w377 - w8 * w378, w3 * w398 - w8 * w399,
        ),
        ca.horzcat(  # link1.theta2
            w193, w251, w268 + w191 * w266 - w192 * w258, w184 * w279 + w191 * w276 + w192 * w272,
            w320 + w192 * w312, w353, w134 * w191 + w192 * w359, w184 * w379 + w191 * w378 + w192 * w377,
            w184 * w400 + w191 * w399 + w192 * w398,
        ),
        ca.horzcat(0.0, -w243, -w261, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w42 * w138 - (w163 * w194 - w41 * w195 + w139 * w164),
            w138 * w223 - (w194 * w227 - w195 * w222 + w139 * w228), -(w65 * w264 * c37 + w135 * w256 * c37),
            w138 * w271 + w139 * w160 - (w139 * w275 - w138 * w182 - (w168 * w195 + w95 * w194)), w329, w358,
            w138 * w359 - w134 * w139, w138 * w377 - w139 * w378, w138 * w398 - w139 * w399,
        ),
        ca.horzcat(  # link2.theta2
            w147 * w163 * c37 + (w53 * w186 * c37 + w45 * (w41 * w44) * c37),
            w147 * w227 * c37 + (w53 * w249 * c37 + w46 * w222 * c37),
            w199 * w264 - w198 * w256 + w53 * w267 * c37 + w201 * w265 - w202 * w257, w280,
            w330 + (w201 * w316 + w182 * (w49 * w196)) + (w202 * w311 + w160 * (w44 * w196)),
            w196 * w352 + (w47 * w321 + w48 * w354 + (w48 * w326 + w47 * w357)) + w201 * w349 - w202 * w345,
            w134 * w201 + w202 * w359, w196 * w379 + w201 * w378 + w202 * w377,
            w196 * w400 + w201 * w399 + w202 * w398,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w325, -w356, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w163 * w203 - w41 * w204), -(w203 * w227 - w204 * w222), -(w203 * w264 + w204 * w256),
            -(w203 * w274 - w204 * w270), -(w203 * w315 - w204 * w310), -(w203 * w348 + w204 * w344),
            w181 * w204 + w159 * w203, -(w159 * (w169 * c13) - w181 * (w98 * c13) - w390),
            -(w119 * w380 - w106 * w401 - w97 * w403 + (w119 * w404 - w106 * w388)),
        ),
        ca.horzcat(  # link3.theta2
            w41 * w206 + w163 * w207 + w186 * w208, w206 * w222 + w207 * w227 + w208 * w249,
            w207 * w264 - w206 * w256 + w208 * w267, w206 * w270 + w207 * w274 + w208 * w278,
            w206 * w310 + w207 * w315 + w208 * w318, w207 * w348 - w206 * w344 + w208 * w351,
            w181 * w206 - w159 * w207,
            -(w99 * w389 - w100 * w381 - (w159 * (w96 * w208) + w181 * (w101 * w208) - w189 * w205)),
            w99 * w380 + w100 * w401 + (w100 * w388 + w99 * w404),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w387, -w403),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 42) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    1147 operations.
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
    # intermediate terms (264)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.sin(link1_theta2)
    w5 = link1_theta1_dot - link1_theta3_dot * w4
    w6 = ca.cos(link1_theta1)
    w7 = w0 * w6
    w8 = w7 * link1_end_x
    w9 = w5 * w8
    w10 = link1_theta3_dot * w7 - w1 * link1_theta2_dot
    w11 = w4 * link1_end_x
    w12 = w9 + w10 * w11
    w13 = ca.cos(link1_theta3)
    w14 = w6 * w13
    w15 = ca.sin(link1_theta3)
    w16 = w14 + w1 * w4 * w15
    w17 = w0 * link1_theta3_dot
    w18 = w13 * w17 - w15 * (w4 * link1_theta2_dot)
    w19 = w0 * link1_theta2_dot
    w20 = w1 * w13
    w21 = w4 * w20 - w6 * w15
    w22 = link1_theta2_dot * w13
    w23 = w15 * w17 + w4 * w22
    w24 = w16 * w18 - w2 * w19 - w21 * w23
    w25 = w0 * w15
    w26 = w0 * w13
    w27 = w4 * w19 + w18 * w25 - w23 * w26
    w28 = w9 + w12 + (w11 * w24 + w3 * w27)
    w29 = w28 * link3_mass
    w30 = w28 * link2_mass + w29
    w31 = link1_theta3_dot - link1_theta1_dot * w4
    w32 = link1_theta1_dot * w26 - link1_theta2_dot * w15
    w33 = w26 * w31 - w4 * w32
    w34 = (w18 + w33) * c1 - (w33 - w18) * c3
    w35 = w25 * w32
    w36 = w22 + link1_theta1_dot * w25
    w37 = w26 * w36
    w38 = w35 + w37
    w39 = (w38 - w19) * c0 - (w19 + w38) * c1
    w40 = w25 * w31 - w4 * w36
    w41 = (w40 - w23) * c3 - (w23 + w40) * c0
    w42 = w15 * (w4 * w6) - w20
    w43 = w1 * w15 + w4 * w14
    w44 = w18 * w42 - w7 * w19 - w23 * w43
    w45 = w6 * link1_theta2_dot + w2 * link1_theta3_dot
    w46 = w3 * w5
    w47 = w11 * w45 + w46
    w48 = w8 * w27 + w11 * w44 - (w46 + w47)
    w49 = w48 * link3_mass
    w50 = w48 * link2_mass + w49
    w51 = w0 * link1_end_x
    w52 = w3 * w44 - w8 * w24 + (w8 * w10 + w3 * w45)
    w53 = w1 * w11
    w54 = w6 * w11
    w55 = ca.cos(link2_theta2)
    w56 = ca.sin(link2_theta1)
    w57 = w55 * w56
    w58 = w57 * link2_end_x
    w59 = ca.cos(link2_theta1)
    w60 = w55 * w59
    w61 = w60 * c11
    w62 = w57 * c11
    w63 = w60 * link2_end_x
    w64 = w55 * link2_end_x
    w65 = ca.sin(link2_theta2)
    w66 = w65 * c11
    w67 = w65 * link2_end_x
    w68 = w56 * w67
    w69 = w59 * w67
    w70 = ca.cos(link3_theta1)
    w71 = ca.cos(link3_theta2)
    w72 = w70 * w71
    w73 = w72 * c13
    w74 = ca.sin(link3_theta1)
    w75 = w71 * w74
    w76 = w75 * c13
    w77 = ca.sin(link3_theta2)
    w78 = w77 * c13
    w79 = w74 * w78
    w80 = w70 * w78
    w81 = w71 * c13
    w82 = w3 * w10 - w8 * w45
    w83 = w0 * link1_theta1_dot
    w84 = link1_theta1_dot * (w4 * w15) + link1_theta3_dot * w15
    w85 = link1_theta1_dot * (w4 * w13) + link1_theta3_dot * w13
    w86 = w4 * w83 - w25 * w84 - w26 * w85
    w87 = w16 * w84 + w2 * w83 + w21 * w85
    w88 = w6 * w82 - w45 * w51 + w5 * w53 - (w3 * w86 - w11 * w87)
    w89 = w88 * link3_mass
    w90 = w88 * link2_mass + w89
    w91 = w13 * w31
    w92 = (w91 - w85) * c3 - (w85 + w91) * c0
    w93 = w15 * w31
    w94 = (w84 + w93) * c1 + (w84 - w93) * c3
    w95 = w13 * w32 - w15 * w36
    w96 = (w95 - w83) * c0 - (w83 + w95) * c1
    w97 = w42 * w84 + w7 * w83 + w43 * w85
    w98 = w8 * w86 - w11 * w97 - (w5 * w54 - (w1 * w82 + w10 * w51))
    w99 = w98 * link3_mass
    w100 = w98 * link2_mass + w99
    w101 = w8 * w87 - w3 * w97 + (w6 * w47 + w45 * w54 - (w1 * w12 + w10 * w53))
    w102 = w56 * w65
    w103 = w59 * w65
    w104 = w3 * w7 - w2 * w8
    w105 = w7 * w11 - w4 * w8
    w106 = w16 * w32 - w21 * w36
    w107 = w35 - w37
    w108 = w2 * w82 + w45 * w104 - (w5 * w105 - w4 * w12) - (w11 * w106 + w3 * w107)
    w109 = w108 * link3_mass
    w110 = w108 * link2_mass + w109
    w111 = (w32 + w32) * c1
    w112 = (w36 + w36) * c39
    w113 = w32 * w42 - w36 * w43
    w114 = w2 * w11 - w3 * w4
    w115 = w8 * w107 + w11 * w113 - (w5 * w114 - w4 * w47 + (w7 * w82 + w10 * w104))
    w116 = w115 * link3_mass
    w117 = w115 * link2_mass + w116
    w118 = w3 * w113 - w8 * w106 + (w7 * w12 + w10 * w105 + (w2 * w47 + w45 * w114))
    w119 = w51 * (w118 * link2_mass + w118 * link3_mass) - (w13 * w111 - w15 * w112) + w53 * w117 + w54 * w110
    w120 = ca.sin(link2_theta3)
    w121 = ca.cos(link2_theta3)
    w122 = w56 * w121
    w123 = w103 * w120 - w122
    w124 = link2_theta3_dot - w65 * link2_theta1_dot
    w125 = w55 * w120
    w126 = w121 * link2_theta2_dot
    w127 = link2_theta1_dot * w125 + w126
    w128 = w124 * w125 - w65 * w127
    w129 = w55 * link2_theta3_dot
    w130 = w120 * w129 + w65 * w126
    w131 = w128 - w130
    w132 = w131 * c11
    w133 = 2 * w127
    w134 = w55 * w121
    w135 = link2_theta1_dot * w134 - w120 * link2_theta2_dot
    w136 = 2 * w135
    w137 = (w125 * w133 + w134 * w136) * c11
    w138 = w59 * w121
    w139 = w56 * w120 + w65 * w138
    w140 = w124 * w134 - w65 * w135
    w141 = w121 * w129 - w120 * (w65 * link2_theta2_dot)
    w142 = w140 - w141
    w143 = w142 * c11
    w144 = link2_theta1_dot - w65 * link2_theta3_dot
    w145 = w63 * w144
    w146 = w60 * link2_theta3_dot - w56 * link2_theta2_dot
    w147 = w145 + w67 * w146
    w148 = w138 + w102 * w120
    w149 = w55 * link2_theta2_dot
    w150 = w65 * w122 - w59 * w120
    w151 = w141 * w148 - w57 * w149 - w130 * w150
    w152 = w65 * w149 + w125 * w141 - w130 * w134
    w153 = w145 + w147 + (w67 * w151 + w58 * w152)
    w154 = w153 * link3_mass
    w155 = w123 * w132 - w60 * w137 + w139 * w143 - w154
    w156 = w123 * w141 - w60 * w149 - w130 * w139
    w157 = w59 * link2_theta2_dot + w57 * link2_theta3_dot
    w158 = w58 * w144
    w159 = w67 * w157 + w158
    w160 = w63 * w152 + w67 * w156 - (w158 + w159)
    w161 = w160 * link3_mass
    w162 = w132 * w148 - w57 * w137 + w143 * w150 + w161
    w163 = w58 * w156 - w63 * w151 + (w63 * w146 + w58 * w157)
    w164 = w163 * link3_mass
    w165 = (w140 + w141) * c15 - w142 * c17
    w166 = w125 * w135
    w167 = w127 * w134
    w168 = w166 + w167
    w169 = (w168 - w149) * c14 - (w149 + w168) * c15
    w170 = w131 * c17 - (w128 + w130) * c14
    w171 = w121 * w124
    w172 = link2_theta1_dot * (w65 * w121) + w121 * link2_theta3_dot
    w173 = w171 - w172
    w174 = w173 * c11
    w175 = (w121 * w133 - w120 * w136) * c11
    w176 = link2_theta1_dot * (w65 * w120) + w120 * link2_theta3_dot
    w177 = w120 * w124
    w178 = w176 - w177
    w179 = w178 * c11
    w180 = w58 * w146 - w63 * w157
    w181 = w55 * link2_theta1_dot
    w182 = w65 * w181 - w125 * w176 - w134 * w172
    w183 = w148 * w176 + w57 * w181 + w150 * w172
    w184 = w59 * w180 - w64 * w157 + w68 * w144 - (w58 * w182 - w67 * w183)
    w185 = w184 * link3_mass
    w186 = w123 * w174 - w60 * w175 + w139 * w179 + w185
    w187 = w123 * w176 + w60 * w181 + w139 * w172
    w188 = w63 * w182 - w67 * w187 - (w69 * w144 - (w56 * w180 + w64 * w146))
    w189 = w188 * link3_mass
    w190 = w148 * w174 - w57 * w175 + w150 * w179 + w189
    w191 = w63 * w183 - w58 * w187 + (w59 * w159 + w69 * w157 - (w56 * w147 + w68 * w146))
    w192 = w191 * link3_mass
    w193 = w173 * c17 - (w171 + w172) * c14
    w194 = (w176 + w177) * c15 + w178 * c17
    w195 = w121 * w135 - w120 * w127
    w196 = (w195 - w181) * c14 - (w181 + w195) * c15
    w197 = w58 * w60 - w57 * w63
    w198 = w60 * w67 - w63 * w65
    w199 = w135 * w148 - w127 * w150
    w200 = w166 - w167
    w201 = w57 * w180 + w157 * w197 - (w144 * w198 - w65 * w147) - (w67 * w199 + w58 * w200)
    w202 = w201 * link3_mass
    w203 = w123 * w135 - w127 * w139
    w204 = w57 * w67 - w58 * w65
    w205 = w63 * w200 + w67 * w203 - (w144 * w204 - w65 * w159 + (w60 * w180 + w146 * w197))
    w206 = w205 * link3_mass
    w207 = w58 * w203 - w63 * w199 + (w60 * w147 + w146 * w198 + (w57 * w159 + w157 * w204))
    w208 = w207 * link3_mass
    w209 = (w135 + w135) * c15
    w210 = (w127 + w127) * c40
    w211 = ca.sin(link3_theta3)
    w212 = ca.cos(link3_theta3)
    w213 = w74 * w212
    w214 = w70 * w77 * w211 - w213
    w215 = link3_theta3_dot - w77 * link3_theta1_dot
    w216 = w71 * w211
    w217 = w212 * link3_theta2_dot
    w218 = link3_theta1_dot * w216 + w217
    w219 = w215 * w216 - w77 * w218
    w220 = w71 * link3_theta3_dot
    w221 = w211 * w220 + w77 * w217
    w222 = w219 - w221
    w223 = w222 * c13
    w224 = 2 * w218
    w225 = w71 * w212
    w226 = link3_theta1_dot * w225 - w211 * link3_theta2_dot
    w227 = 2 * w226
    w228 = (w216 * w224 + w225 * w227) * c13
    w229 = w70 * w212
    w230 = w74 * w211 + w77 * w229
    w231 = w215 * w225 - w77 * w226
    w232 = w212 * w220 - w211 * (w77 * link3_theta2_dot)
    w233 = w231 - w232
    w234 = w233 * c13
    w235 = w214 * w223 - w72 * w228 + w230 * w234
    w236 = w229 + w211 * (w74 * w77)
    w237 = w77 * w213 - w70 * w211
    w238 = w223 * w236 - w75 * w228 + w234 * w237
    w239 = w77 * w228 + w216 * w223 + w225 * w234
    w240 = (w231 + w232) * c22 - w233 * c24
    w241 = w216 * w226 + w218 * w225
    w242 = w71 * link3_theta2_dot
    w243 = (w241 - w242) * c21 - (w241 + w242) * c22
    w244 = w222 * c24 - (w219 + w221) * c21
    w245 = w212 * w215
    w246 = link3_theta1_dot * (w77 * w212) + w212 * link3_theta3_dot
    w247 = w245 - w246
    w248 = w247 * c13
    w249 = (w212 * w224 - w211 * w227) * c13
    w250 = link3_theta1_dot * (w77 * w211) + w211 * link3_theta3_dot
    w251 = w211 * w215
    w252 = w250 - w251
    w253 = w252 * c13
    w254 = w214 * w248 - w72 * w249 + w230 * w253
    w255 = w236 * w248 - w75 * w249 + w237 * w253
    w256 = w77 * w249 + w216 * w248 + w225 * w253
    w257 = w247 * c24 - (w245 + w246) * c21
    w258 = (w250 + w251) * c22 + w252 * c24
    w259 = w212 * w226 - w211 * w218
    w260 = w71 * link3_theta1_dot
    w261 = (w259 - w260) * c21 - (w259 + w260) * c22
    w262 = (w226 + w226) * c22
    w263 = (w218 + w218) * c41
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.theta1
            -(w3 * w30 + (w25 * w34 - w4 * w39 + w26 * w41 + w8 * w50)),
            w3 * w90 - (w26 * w92 - (w25 * w94 + w4 * w96) + w8 * w100),
            w3 * w110 - (w25 * w111 + w26 * w112 + w8 * w117), w3 * w155 - w8 * w162, w3 * w186 - w8 * w190,
            w3 * w202 - w8 * w206, w3 * w235 - w8 * w238, w3 * w254 - w8 * w255, 0.0,
        ),
        ca.horzcat(  # link1.theta2
            w51 * (w52 * link2_mass + w52 * link3_mass) - (w13 * w34 - w15 * w41) + w50 * w53 - w30 * w54,
            w51 * (w101 * link2_mass + w101 * link3_mass) + (w13 * w94 + w15 * w92) + w53 * w100 + w54 * w90, w119,
            w51 * (w65 * w137 + w125 * w132 + w134 * w143 + w164) + w53 * w162 + w54 * w155,
            w51 * (w65 * w175 + w125 * w174 + w134 * w179 + w192) + w53 * w190 + w54 * w186,
            w51 * w208 + w53 * w206 + w54 * w202, w51 * w239 + w53 * w238 + w54 * w235,
            w51 * w256 + w53 * w255 + w54 * w254, 0.0,
        ),
        ca.horzcat(-w39, -w96, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            -(w59 * (w48 * w55) * c37 + w56 * (w28 * w55) * c37), w58 * w89 - (w61 * w98 - w62 * w88 + w63 * w99),
            w58 * w109 - (w61 * w115 - w62 * w108 + w63 * w116),
            -(w58 * w154 + (w125 * w165 - w65 * w169 + w134 * w170 + w63 * w161)),
            w58 * w185 - (w134 * w193 - (w125 * w194 + w65 * w196) + w63 * w189),
            w58 * w202 - (w125 * w209 + w134 * w210 + w63 * w206), w58 * w235 - w63 * w238, w58 * w254 - w63 * w255,
            0.0,
        ),
        ca.horzcat(  # link2.theta2
            w48 * (w56 * w66) - w28 * (w59 * w66) + w52 * w55 * c37 + w49 * w68 - w29 * w69,
            w98 * w102 * c37 + (w55 * w101 * c37 + w88 * w103 * c37),
            w102 * w115 * c37 + (w55 * w118 * c37 + w103 * w108 * c37),
            w64 * w164 - (w121 * w165 - w120 * w170) + w68 * w161 - w69 * w154,
            w64 * w192 + (w121 * w194 + w120 * w193) + w68 * w189 + w69 * w185,
            w64 * w208 - (w121 * w209 - w120 * w210) + w68 * w206 + w69 * w202,
            w64 * w239 + w68 * w238 + w69 * w235, w64 * w256 + w68 * w255 + w69 * w254, 0.0,
        ),
        ca.horzcat(0.0, 0.0, 0.0, -w169, -w196, 0.0, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w48 * w73 + w28 * w76), -(w73 * w98 - w76 * w88), -(w73 * w115 - w76 * w108),
            -(w73 * w160 + w76 * w153), -(w73 * w188 - w76 * w184), -(w73 * w205 - w76 * w201),
            -(w216 * w240 - w77 * w243 + w225 * w244), -(w225 * w257 - (w216 * w258 + w77 * w261)),
            -(w216 * w262 + w225 * w263),
        ),
        ca.horzcat(  # link3.theta2
            w48 * w79 - w28 * w80 + w52 * w81, w80 * w88 + w79 * w98 + w81 * w101,
            w80 * w108 + w79 * w115 + w81 * w118, w79 * w160 - w80 * w153 + w81 * w163,
            w80 * w184 + w79 * w188 + w81 * w191, w80 * w201 + w79 * w205 + w81 * w207,
            -(w212 * w240 - w211 * w244), w212 * w258 + w211 * w257, -(w212 * w262 - w211 * w263),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w243, -w261, 0.0),  # link3.theta3
    )
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
    2665 operations.
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
    # intermediate terms (610)
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
    w13 = w3 * w12
    w14 = w10 * link1_end_x
    w15 = w13 + w7 * w14
    w16 = w6 * w9 + w12 * w15
    w17 = w0 * link1_theta3_dot
    w18 = ca.cos(link1_theta3)
    w19 = w17 * w18
    w20 = link1_theta2_dot * w10
    w21 = ca.sin(link1_theta3)
    w22 = w19 - w20 * w21
    w23 = link1_theta3_dot * link1_theta2_dot
    w24 = w21 * w23
    w25 = link1_theta1_dot * w22 - w24
    w26 = w4 * w10
    w27 = w1 * w18
    w28 = w21 * w26 - w27
    w29 = link1_theta2_dot * link1_theta1_dot
    w30 = w0 * w29
    w31 = w17 * w21
    w32 = link1_theta2_dot * w18
    w33 = w31 + w10 * w32
    w34 = w18 * w23
    w35 = link1_theta1_dot * w33 + w34
    w36 = w4 * w18
    w37 = w1 * w21
    w38 = w10 * w36 + w37
    w39 = w25 * w28 - w5 * w30 - w35 * w38
    w40 = w0 * w21
    w41 = w0 * w18
    w42 = w10 * w30 + w25 * w40 - w35 * w41
    w43 = w14 * w39 + w8 * w42
    w44 = w8 * link1_theta1_ddot
    w45 = w1 * w14
    w46 = link1_theta2_ddot * w45
    w47 = w16 - w43 - w44 + w46
    w48 = w47 * link3_mass
    w49 = w47 * link2_mass + w48
    w50 = ca.cos(link2_theta1)
    w51 = ca.sin(link2_theta2)
    w52 = w50 * w51
    w53 = ca.sin(link2_theta3)
    w54 = ca.cos(link2_theta3)
    w55 = ca.sin(link2_theta1)
    w56 = w54 * w55
    w57 = w52 * w53 - w56
    w58 = link2_theta3_dot - w51 * link2_theta1_dot
    w59 = ca.cos(link2_theta2)
    w60 = w53 * w59
    w61 = w54 * link2_theta2_dot
    w62 = link2_theta1_dot * w60 + w61
    w63 = w58 * w62
    w64 = w54 * w59
    w65 = link2_theta1_ddot * w64 - w53 * link2_theta2_ddot
    w66 = link2_theta3_dot * w59
    w67 = w53 * w66
    w68 = w67 + w51 * w61
    w69 = link2_theta3_dot * link2_theta2_dot
    w70 = w54 * w69
    w71 = link2_theta1_dot * w68 + w70
    w72 = w65 - w71
    w73 = w63 + w72
    w74 = w73 * c11
    w75 = w50 * w59
    w76 = w62**2
    w77 = w53 * link2_theta2_dot
    w78 = link2_theta1_dot * w64 - w77
    w79 = w78**2
    w80 = (w76 + w79) * c11
    w81 = w53 * w55
    w82 = w50 * w54
    w83 = w81 + w51 * w82
    w84 = w58 * w78
    w85 = w54 * w66
    w86 = w51 * link2_theta2_dot
    w87 = w85 - w53 * w86
    w88 = w53 * w69
    w89 = link2_theta1_dot * w87 - w88
    w90 = w60 * link2_theta1_ddot + w54 * link2_theta2_ddot
    w91 = w89 + w90
    w92 = w84 - w91
    w93 = w92 * c11
    w94 = w57 * w74 - w75 * w80 + w83 * w93
    w95 = w7 * w9
    w96 = w8 * w12
    w97 = w96 + w6 * w14
    w98 = w12 * w97
    w99 = w1 * w10
    w100 = w36 + w21 * w99
    w101 = w25 * w100
    w102 = w2 * w30
    w103 = w10 * w27
    w104 = w4 * w21
    w105 = w103 - w104
    w106 = w101 - w102 - w35 * w105
    w107 = w3 * w42
    w108 = w3 * link1_theta1_ddot
    w109 = w4 * w14
    w110 = link1_theta2_ddot * w109
    w111 = w95 - w98 - (w14 * w106 + w107) - w108 - w110
    w112 = ca.cos(link3_theta1)
    w113 = ca.sin(link3_theta2)
    w114 = w112 * w113
    w115 = ca.sin(link3_theta3)
    w116 = ca.cos(link3_theta3)
    w117 = ca.sin(link3_theta1)
    w118 = w116 * w117
    w119 = w114 * w115 - w118
    w120 = link3_theta3_dot - w113 * link3_theta1_dot
    w121 = ca.cos(link3_theta2)
    w122 = w115 * w121
    w123 = w116 * link3_theta2_dot
    w124 = link3_theta1_dot * w122 + w123
    w125 = w120 * w124
    w126 = w116 * w121
    w127 = link3_theta1_ddot * w126 - w115 * link3_theta2_ddot
    w128 = link3_theta3_dot * w121
    w129 = w115 * w128
    w130 = w129 + w113 * w123
    w131 = link3_theta3_dot * link3_theta2_dot
    w132 = w116 * w131
    w133 = w127 - (link3_theta1_dot * w130 + w132)
    w134 = w125 + w133
    w135 = w134 * c13
    w136 = w112 * w121
    w137 = w124**2
    w138 = w115 * link3_theta2_dot
    w139 = link3_theta1_dot * w126 - w138
    w140 = w139**2
    w141 = (w137 + w140) * c13
    w142 = w115 * w117
    w143 = w112 * w116
    w144 = w142 + w113 * w143
    w145 = w120 * w139
    w146 = w116 * w128
    w147 = w113 * link3_theta2_dot
    w148 = w146 - w115 * w147
    w149 = w115 * w131
    w150 = w122 * link3_theta1_ddot + w116 * link3_theta2_ddot
    w151 = link3_theta1_dot * w148 - w149 + w150
    w152 = w145 - w151
    w153 = w152 * c13
    w154 = w119 * w135 - w136 * w141 + w144 * w153
    w155 = w55 * w59
    w156 = w50 * link2_theta2_dot + link2_theta3_dot * w155
    w157 = link2_theta3_dot * w75 - w55 * link2_theta2_dot
    w158 = w155 * link2_end_x
    w159 = w75 * link2_end_x
    w160 = w157 * w158 - w156 * w159
    w161 = w156 * w160
    w162 = w51 * link2_theta3_dot
    w163 = link2_theta1_dot - w162
    w164 = w159 * w163
    w165 = w51 * link2_end_x
    w166 = w164 + w157 * w165
    w167 = w163 * w166
    w168 = w51 * w55
    w169 = w82 + w53 * w168
    w170 = w89 * w169
    w171 = link2_theta1_dot * link2_theta2_dot
    w172 = w59 * w171
    w173 = w155 * w172
    w174 = w51 * w56
    w175 = w50 * w53
    w176 = w174 - w175
    w177 = w170 - w173 - w71 * w176
    w178 = w51 * w172 + w60 * w89 - w64 * w71
    w179 = w158 * w178
    w180 = link2_theta1_ddot * w158
    w181 = w50 * w165
    w182 = link2_theta2_ddot * w181
    w183 = w111 + (w161 - w167 - (w165 * w177 + w179)) - w180 - w182
    w184 = w154 + w183 * link3_mass
    w185 = w94 + w111 * link2_mass + w184
    w186 = w102 - w101 - w35 * (w104 - w103)
    w187 = w14 * w186 - w107 - (w98 - w95) - w108 - w110
    w188 = w187 * link3_mass
    w189 = w187 * link2_mass + w188
    w190 = w74 * w169
    w191 = w80 * w155
    w192 = w44 + (w43 - w16) - w46
    w193 = w113 * w117
    w194 = w143 + w115 * w193
    w195 = w135 * w194
    w196 = w117 * w121
    w197 = w141 * w196
    w198 = w113 * w118
    w199 = w112 * w115
    w200 = w198 - w199
    w201 = w57 * w89 - w75 * w172 - w71 * w83
    w202 = w159 * w178 + w165 * w201
    w203 = w158 * w163
    w204 = w156 * w165 + w203
    w205 = w163 * w204 + w157 * w160
    w206 = link2_theta1_ddot * w159
    w207 = w55 * w165
    w208 = link2_theta2_ddot * w207
    w209 = w192 + (w202 - w205) + w206 - w208
    w210 = w195 - w197 + w153 * w200 + w209 * link3_mass
    w211 = w190 - w191 + w93 * w176 + w192 * link2_mass + w210
    w212 = w0 * link1_end_x
    w213 = w8 * w39
    w214 = w3 * w186 + w213 - (w213 - w3 * w106)
    w215 = w3 * w39 - w8 * w106 + (w6 * w97 + w7 * w15) - link1_theta2_ddot * w212
    w216 = w215 - gravity_z
    w217 = w59 * link2_end_x
    w218 = w215 + (w158 * w201 - w159 * w177 + (w157 * w166 + w156 * w204)) - link2_theta2_ddot * w217 - gravity_z
    w219 = w113 * w141 + w122 * w135 + w126 * w153 + w218 * link3_mass
    w220 = w212 * (w214 * link2_mass + w214 * link3_mass) + (w45 * w189 + w109 * w211) + (w49 * w109 - w45 * w185)
    w221 = w75 * c11
    w222 = w155 * c11
    w223 = w51 * c11
    w224 = w50 * w223
    w225 = w55 * w223
    w226 = w59 * c11
    w227 = w136 * c13
    w228 = w196 * c13
    w229 = w113 * c13
    w230 = w112 * w229
    w231 = w117 * w229
    w232 = w121 * c13
    w233 = link1_theta3_dot * w99
    w234 = w26 * link1_end_x
    w235 = link1_theta3_dot * w26
    w236 = w99 * link1_end_x
    w237 = w8 * w233 + w7 * w234 - (w3 * w235 + w6 * w236)
    w238 = w6 * w212
    w239 = w238 - w14 * w235 - (w8 * w17 + w12 * w234)
    w240 = w0 * link1_theta2_dot
    w241 = link1_theta1_dot * (w11 * w18 + w21 * w240)
    w242 = w10 * w29
    w243 = link1_theta1_dot * (w0 * w32 - w11 * w21)
    w244 = w25 * (w2 * w21) - w100 * w241 + w10 * (link1_theta1_dot * (w2 * link1_theta2_dot)) * c38 - (w35 * (w0 * w27) + w105 * w243)
    w245 = w10 * w21
    w246 = w10 * w18
    w247 = w0 * w30 - w10 * w242 - (w25 * w245 + w40 * w241) - (w41 * w243 - w35 * w246)
    w248 = w7 * w237 - w9 * w233 - (w12 * w239 - w17 * w97) - (w14 * w244 + w106 * w212 + (w3 * w247 - w42 * w236))
    w249 = w4 * w212
    w250 = w248 + link1_theta1_ddot * w236 - link1_theta2_ddot * w249
    w251 = w250 * link3_mass
    w252 = w250 * link2_mass + w251
    w253 = w25 * (w5 * w21) - w28 * w241 + w10 * (link1_theta1_dot * (w5 * link1_theta2_dot)) * c38 - (w35 * (w0 * w36) + w38 * w243)
    w254 = w7 * w212
    w255 = w254 - w14 * w233 - (w3 * w17 + w12 * w236)
    w256 = w8 * w247 - w42 * w234 + (w14 * w253 + w39 * w212) - (w12 * w255 - w15 * w17 + (w6 * w237 - w9 * w235))
    w257 = w1 * w212
    w258 = w256 - link1_theta1_ddot * w234 - link1_theta2_ddot * w257
    w259 = w258 * link3_mass
    w260 = w258 * link2_mass + w259
    w261 = link1_theta3_dot - link1_theta1_dot * w10
    w262 = link1_theta2_dot * w21
    w263 = link1_theta1_dot * w41 - w262
    w264 = w261 * w263
    w265 = w40 * link1_theta1_ddot + w18 * link1_theta2_ddot
    w266 = w25 + w265
    w267 = (w264 + w266) * c1 - (w264 - w266) * c3
    w268 = w0 * link1_theta1_dot
    w269 = link1_theta1_dot * w246
    w270 = w263 * w268 + w261 * w269
    w271 = w241 + link1_theta1_ddot * w245
    w272 = (w270 + w271) * c1 + (w271 - w270) * c3
    w273 = w32 + link1_theta1_dot * w40
    w274 = w263 * w273
    w275 = link1_theta3_ddot - w10 * link1_theta1_ddot - w30
    w276 = w242 - w0 * link1_theta1_ddot
    w277 = link1_theta1_dot * w245
    w278 = w263 * w277 + w269 * w273
    w279 = (w276 - w278) * c0 + (w276 + w278) * c1
    w280 = w261 * w273
    w281 = w41 * link1_theta1_ddot - w21 * link1_theta2_ddot
    w282 = w281 - w35
    w283 = (w280 + w282) * c3 - (w280 - w282) * c0
    w284 = w268 * w273 + w261 * w277
    w285 = w243 + link1_theta1_ddot * w246
    w286 = (w284 + w285) * c3 + (w285 - w284) * c0
    w287 = w245 * w267 + w40 * w272 + (w0 * ((w274 + w275) * c0 - (w274 - w275) * c1) + w10 * w279) + (w246 * w283 + w41 * w286)
    w288 = w3 * w253 - w39 * w236 - (w8 * w244 - w106 * w234) + (w6 * w239 - w97 * w235 + (w7 * w255 - w15 * w233))
    w289 = w288 + w14 * link1_theta2_ddot
    w290 = w212 * (w289 * link2_mass + w289 * link3_mass) - w14 * (w51 * w80 + w60 * w74 + w64 * w93 + w216 * link2_mass + w219)
    w291 = w290 - (w21 * w286 - w18 * w272 - w10 * c28) + (w45 * w260 + w211 * w257) + (w109 * w252 + w185 * w249)
    w292 = w34 + link1_theta1_dot * (w31 + w18 * w20)
    w293 = link1_theta1_dot * (w19 - w10 * w262) - w24
    w294 = w25 * (w18 * w99 - w104) - w100 * w292 - (w105 * w293 - w35 * (w36 + w10 * w37))
    w295 = w25 * w41 - w40 * w292 - (w41 * w293 - w35 * w40)
    w296 = w14 * w294 + w3 * w295
    w297 = w296 * link3_mass
    w298 = w296 * link2_mass + w297
    w299 = w281 - w292
    w300 = (w299 - w280) * c1 + (w280 + w299) * c3
    w301 = w263**2 - w273**2
    w302 = w301 * c0 - w301 * c1
    w303 = w265 + w293
    w304 = (w264 - w303) * c3 - (w264 + w303) * c0
    w305 = w25 * (w37 + w18 * w26) - w28 * w292 - (w35 * (w27 - w10 * w104) + w38 * w293)
    w306 = w8 * w295 + w14 * w305
    w307 = w306 * link3_mass
    w308 = w306 * link2_mass + w307
    w309 = w3 * w305 - w8 * w294
    w310 = w212 * (w309 * link2_mass + w309 * link3_mass) - (w18 * w300 - w21 * w267 - (w18 * w283 + w21 * w304))
    w311 = w175 - w174
    w312 = w208 + (w205 - w202 - w206)
    w313 = w312 * link3_mass
    w314 = w191 - w190 + w93 * w311 + w313
    w315 = w173 - w170 - w71 * w311
    w316 = w165 * w315 - w179 - (w167 - w161) - w180 - w182
    w317 = w316 * link3_mass
    w318 = w94 + w317
    w319 = w159 * w201
    w320 = w158 * w315 + w319 - (w319 - w158 * w177)
    w321 = w320 * link3_mass
    w322 = w217 * w321 + (w192 * w224 - w111 * w225) + (w207 * w317 + w181 * w210) + (w181 * w313 - w184 * w207)
    w323 = w53 * w75
    w324 = link2_theta1_dot * w59
    w325 = w51 * w53
    w326 = link2_theta1_dot * w325
    w327 = w62 * w324 + w58 * w326
    w328 = w51 * w54
    w329 = link2_theta1_dot * (w59 * w61 - w53 * w162)
    w330 = link2_theta1_ddot * w328 + w329
    w331 = w327 + w330
    w332 = w331 * c11
    w333 = 2 * w62
    w334 = 2 * w78
    w335 = link2_theta1_dot * w328
    w336 = (w326 * w333 + w334 * w335) * c11
    w337 = w59 * w82
    w338 = w59 * link2_theta2_dot
    w339 = link2_theta1_dot * (w54 * w162 + w53 * w338)
    w340 = w339 + link2_theta1_ddot * w325
    w341 = w78 * w324 + w58 * w335
    w342 = w340 - w341
    w343 = w342 * c11
    w344 = link2_theta3_dot * w168
    w345 = w52 * link2_end_x
    w346 = w52 * link2_theta3_dot
    w347 = w168 * link2_end_x
    w348 = w159 * w344 + w156 * w345 - (w158 * w346 + w157 * w347)
    w349 = w157 * w217
    w350 = w349 - w165 * w346 - (w66 * w159 + w163 * w345)
    w351 = w53 * w155
    w352 = w51 * w171
    w353 = w56 * w59
    w354 = w89 * w351 - w169 * w339 + link2_theta2_dot * (w59 * (link2_theta1_dot * w168)) * c38 - (w71 * w353 + w176 * w329)
    w355 = w59 * w172 - w51 * w352 - (w89 * w325 + w60 * w339) - (w64 * w329 - w71 * w328)
    w356 = w156 * w348 - w160 * w344 - (w163 * w350 - w66 * w166) - (w165 * w354 + w177 * w217 + (w158 * w355 - w178 * w347))
    w357 = w50 * w217
    w358 = w356 + link2_theta1_ddot * w347 - link2_theta2_ddot * w357
    w359 = w358 * link3_mass
    w360 = w74 * w323 - w57 * w332 + (w52 * w80 + w75 * w336) + (w93 * w337 + w83 * w343) + w359
    w361 = w89 * w323 - w57 * w339 + link2_theta2_dot * (w59 * (w52 * link2_theta1_dot)) * c38 - (w71 * w337 + w83 * w329)
    w362 = w156 * w217
    w363 = w362 - w165 * w344 - (w66 * w158 + w163 * w347)
    w364 = w159 * w355 - w178 * w345 + (w165 * w361 + w201 * w217) - (w163 * w363 - w66 * w204 + (w157 * w348 - w160 * w346))
    w365 = w55 * w217
    w366 = w364 - link2_theta1_ddot * w345 - link2_theta2_ddot * w365
    w367 = w366 * link3_mass
    w368 = w74 * w351 - w169 * w332 + (w80 * w168 + w155 * w336) + (w93 * w353 + w176 * w343) + w367
    w369 = w158 * w361 - w201 * w347 - (w159 * w354 - w177 * w345) + (w157 * w350 - w166 * w346 + (w156 * w363 - w204 * w344))
    w370 = w369 + link2_theta2_ddot * w165
    w371 = w370 * link3_mass
    w372 = w212 * (w59 * w80 - w51 * w336 - (w74 * w325 + w60 * w332) + (w64 * w343 - w93 * w328) + w371) + w45 * w368
    w373 = (w84 + w91) * c15 - w92 * c17
    w374 = (w340 + w341) * c15 + w342 * c17
    w375 = w62 * w78
    w376 = link2_theta3_ddot - w51 * link2_theta1_ddot - w172
    w377 = w352 - w59 * link2_theta1_ddot
    w378 = w78 * w326 + w62 * w335
    w379 = (w377 - w378) * c14 + (w377 + w378) * c15
    w380 = w73 * c17 - (w63 - w72) * c14
    w381 = w331 * c17 + (w330 - w327) * c14
    w382 = w325 * w373 + w60 * w374 + (w59 * ((w375 + w376) * c14 - (w375 - w376) * c15) + w51 * w379) + (w328 * w380 + w64 * w381)
    w383 = w158 * w359 - w184 * w347 - (w111 * (w168 * c11) - w192 * (w52 * c11) - w382 + (w159 * w367 - w210 * w345))
    w384 = w217 * w371 - w165 * w219 - (w53 * w381 - w54 * w374 - (w111 * (w50 * w226) + w192 * (w55 * w226) - w216 * w223))
    w385 = w81 + w52 * w54
    w386 = link2_theta1_dot * (w85 - w51 * w77) - w88
    w387 = w90 + w386
    w388 = w84 - w387
    w389 = w388 * c11
    w390 = (w78 * w333 - w62 * w334) * c11
    w391 = w56 - w51 * w175
    w392 = w70 + link2_theta1_dot * (w67 + w54 * w86)
    w393 = w65 - w392
    w394 = w63 + w393
    w395 = w394 * c11
    w396 = w54 * w168 - w175
    w397 = w82 + w51 * w81
    w398 = w89 * w396 - w169 * w392 - (w176 * w386 - w71 * w397)
    w399 = w64 * w89 - w60 * w392 - (w64 * w386 - w60 * w71)
    w400 = w165 * w398 + w158 * w399
    w401 = w400 * link3_mass
    w402 = w74 * w385 + w57 * w389 - w75 * w390 + (w93 * w391 - w83 * w395) - w401
    w403 = w89 * w385 - w57 * w392 - (w71 * w391 + w83 * w386)
    w404 = w159 * w399 + w165 * w403
    w405 = w404 * link3_mass
    w406 = w74 * w396 + w169 * w389 - w155 * w390 - (w93 * w397 + w176 * w395) + w405
    w407 = w158 * w403 - w159 * w398
    w408 = w407 * link3_mass
    w409 = w212 * (w51 * w390 + (w64 * w74 + w60 * w389) - (w60 * w93 + w64 * w395) + w408) + w45 * w406 + w109 * w402
    w410 = (w393 - w63) * c15 + w394 * c17
    w411 = w79 - w76
    w412 = w411 * c14 - w411 * c15
    w413 = w388 * c17 - (w84 + w387) * c14
    w414 = -(w158 * w401 + (w64 * w373 + w60 * w410 - w51 * w412 + (w64 * w413 - w60 * w380) + w159 * w405))
    w415 = w197 - w195 + w153 * (w199 - w198)
    w416 = link3_theta1_dot * w121
    w417 = w113 * w115
    w418 = link3_theta1_dot * w417
    w419 = w124 * w416 + w120 * w418
    w420 = w113 * w116
    w421 = w113 * link3_theta3_dot
    w422 = link3_theta1_ddot * w420 + link3_theta1_dot * (w121 * w123 - w115 * w421)
    w423 = w419 + w422
    w424 = w423 * c13
    w425 = 2 * w124
    w426 = 2 * w139
    w427 = link3_theta1_dot * w420
    w428 = (w418 * w425 + w426 * w427) * c13
    w429 = w121 * link3_theta2_dot
    w430 = link3_theta1_dot * (w116 * w421 + w115 * w429) + link3_theta1_ddot * w417
    w431 = w139 * w416 + w120 * w427
    w432 = w430 - w431
    w433 = w432 * c13
    w434 = w135 * (w115 * w136) - w119 * w424 + (w114 * w141 + w136 * w428) + (w153 * (w121 * w143) + w144 * w433)
    w435 = w135 * (w115 * w196) - w194 * w424 + (w141 * w193 + w196 * w428) + (w153 * (w118 * w121) + w200 * w433)
    w436 = w121 * w141 - w113 * w428 - (w135 * w417 + w122 * w424) + (w126 * w433 - w153 * w420)
    w437 = (w145 + w151) * c22 - w152 * c24
    w438 = (w430 + w431) * c22 + w432 * c24
    w439 = w124 * w139
    w440 = link3_theta1_dot * link3_theta2_dot
    w441 = link3_theta3_ddot - w113 * link3_theta1_ddot - w121 * w440
    w442 = w113 * w440 - w121 * link3_theta1_ddot
    w443 = w139 * w418 + w124 * w427
    w444 = (w442 - w443) * c21 + (w442 + w443) * c22
    w445 = w134 * c24 - (w125 - w133) * c21
    w446 = w423 * c24 + (w422 - w419) * c21
    w447 = w417 * w437 + w122 * w438 + (w121 * ((w439 + w441) * c21 - (w439 - w441) * c22) + w113 * w444) + (w420 * w445 + w126 * w446)
    w448 = w150 + (link3_theta1_dot * (w146 - w113 * w138) - w149)
    w449 = w145 - w448
    w450 = w449 * c13
    w451 = (w139 * w425 - w124 * w426) * c13
    w452 = w127 - (w132 + link3_theta1_dot * (w129 + w116 * w147))
    w453 = w125 + w452
    w454 = w453 * c13
    w455 = w135 * (w142 + w114 * w116) + w119 * w450 - w136 * w451 + (w153 * (w118 - w113 * w199) - w144 * w454)
    w456 = w135 * (w116 * w193 - w199) + w194 * w450 - w196 * w451 - (w153 * (w143 + w113 * w142) + w200 * w454)
    w457 = w113 * w451 + (w126 * w135 + w122 * w450) - (w122 * w153 + w126 * w454)
    w458 = (w452 - w125) * c22 + w453 * c24
    w459 = w140 - w137
    w460 = w459 * c21 - w459 * c22
    w461 = w449 * c24 - (w145 + w448) * c21
    w462 = w22 * w100 - w2 * w240 - w33 * w105
    w463 = w10 * w240 + w22 * w40 - w33 * w41
    w464 = w96 + w97 + (w14 * w462 + w3 * w463)
    w465 = w464 * link3_mass
    w466 = w464 * link2_mass + w465
    w467 = w41 * w261 - w10 * w263
    w468 = (w22 + w467) * c1 - (w467 - w22) * c3
    w469 = w40 * w263
    w470 = w41 * w273
    w471 = w469 + w470
    w472 = (w471 - w240) * c0 - (w240 + w471) * c1
    w473 = w40 * w261 - w10 * w273
    w474 = (w473 - w33) * c3 - (w33 + w473) * c0
    w475 = w22 * w28 - w5 * w240 - w33 * w38
    w476 = w8 * w463 + w14 * w475 - (w13 + w15)
    w477 = w476 * link3_mass
    w478 = w476 * link2_mass + w477
    w479 = w3 * w475 - w8 * w462 + (w6 * w8 + w3 * w7)
    w480 = w212 * (w479 * link2_mass + w479 * link3_mass) - (w18 * w468 - w21 * w474) + w45 * w478 - w109 * w466
    w481 = w277 + link1_theta3_dot * w21
    w482 = w269 + link1_theta3_dot * w18
    w483 = w10 * w268 - w40 * w481 - w41 * w482
    w484 = w100 * w481 + w2 * w268 + w105 * w482
    w485 = w4 * w9 - w254 + w12 * w45 - (w3 * w483 - w14 * w484)
    w486 = w485 * link3_mass
    w487 = w485 * link2_mass + w486
    w488 = w18 * w261
    w489 = (w488 - w482) * c3 - (w482 + w488) * c0
    w490 = w21 * w261
    w491 = (w481 + w490) * c1 + (w481 - w490) * c3
    w492 = w18 * w263 - w21 * w273
    w493 = (w492 - w268) * c0 - (w268 + w492) * c1
    w494 = w28 * w481 + w5 * w268 + w38 * w482
    w495 = w8 * w483 - w14 * w494 - (w12 * w109 - (w238 + w1 * w9))
    w496 = w495 * link3_mass
    w497 = w495 * link2_mass + w496
    w498 = w8 * w484 - w3 * w494 + (w4 * w15 + w7 * w109 - (w1 * w97 + w6 * w45))
    w499 = w212 * (w498 * link2_mass + w498 * link3_mass) + (w18 * w491 + w21 * w489) + w45 * w497 + w109 * w487
    w500 = w3 * w5 - w2 * w8
    w501 = w5 * w14 - w8 * w10
    w502 = w100 * w263 - w105 * w273
    w503 = w469 - w470
    w504 = w2 * w9 + w7 * w500 - (w12 * w501 - w10 * w97) - (w14 * w502 + w3 * w503)
    w505 = w504 * link3_mass
    w506 = w504 * link2_mass + w505
    w507 = (w263 + w263) * c1
    w508 = (w273 + w273) * c39
    w509 = w28 * w263 - w38 * w273
    w510 = w2 * w14 - w3 * w10
    w511 = w8 * w503 + w14 * w509 - (w12 * w510 - w10 * w15 + (w5 * w9 + w6 * w500))
    w512 = w511 * link3_mass
    w513 = w511 * link2_mass + w512
    w514 = w3 * w509 - w8 * w502 + (w5 * w97 + w6 * w501 + (w2 * w15 + w7 * w510))
    w515 = w212 * (w514 * link2_mass + w514 * link3_mass) - (w18 * w507 - w21 * w508) + w45 * w513 + w109 * w506
    w516 = w58 * w60 - w51 * w62
    w517 = w516 - w68
    w518 = w517 * c11
    w519 = (w60 * w333 + w64 * w334) * c11
    w520 = w58 * w64 - w51 * w78
    w521 = w520 - w87
    w522 = w521 * c11
    w523 = w87 * w169 - w155 * w338 - w68 * w176
    w524 = w51 * w338 + w60 * w87 - w64 * w68
    w525 = w164 + w166 + (w165 * w523 + w158 * w524)
    w526 = w525 * link3_mass
    w527 = w57 * w518 - w75 * w519 + w83 * w522 - w526
    w528 = w57 * w87 - w75 * w338 - w68 * w83
    w529 = w159 * w524 + w165 * w528 - (w203 + w204)
    w530 = w529 * link3_mass
    w531 = w169 * w518 - w155 * w519 + w176 * w522 + w530
    w532 = w158 * w528 - w159 * w523 + (w157 * w159 + w156 * w158)
    w533 = w532 * link3_mass
    w534 = (w87 + w520) * c15 - w521 * c17
    w535 = w60 * w78
    w536 = w62 * w64
    w537 = w535 + w536
    w538 = (w537 - w338) * c14 - (w338 + w537) * c15
    w539 = w517 * c17 - (w68 + w516) * c14
    w540 = w54 * w58
    w541 = w335 + w54 * link2_theta3_dot
    w542 = w540 - w541
    w543 = w542 * c11
    w544 = (w54 * w333 - w53 * w334) * c11
    w545 = w326 + w53 * link2_theta3_dot
    w546 = w53 * w58
    w547 = w545 - w546
    w548 = w547 * c11
    w549 = w51 * w324 - w60 * w545 - w64 * w541
    w550 = w169 * w545 + w155 * w324 + w176 * w541
    w551 = w50 * w160 - w362 + w163 * w207 - (w158 * w549 - w165 * w550)
    w552 = w551 * link3_mass
    w553 = w57 * w543 - w75 * w544 + w83 * w548 + w552
    w554 = w57 * w545 + w75 * w324 + w83 * w541
    w555 = w159 * w549 - w165 * w554 - (w163 * w181 - (w349 + w55 * w160))
    w556 = w555 * link3_mass
    w557 = w169 * w543 - w155 * w544 + w176 * w548 + w556
    w558 = w159 * w550 - w158 * w554 + (w50 * w204 + w156 * w181 - (w55 * w166 + w157 * w207))
    w559 = w558 * link3_mass
    w560 = w542 * c17 - (w540 + w541) * c14
    w561 = (w545 + w546) * c15 + w547 * c17
    w562 = w54 * w78 - w53 * w62
    w563 = (w562 - w324) * c14 - (w324 + w562) * c15
    w564 = w75 * w158 - w155 * w159
    w565 = w75 * w165 - w51 * w159
    w566 = w78 * w169 - w62 * w176
    w567 = w535 - w536
    w568 = w155 * w160 + w156 * w564 - (w163 * w565 - w51 * w166) - (w165 * w566 + w158 * w567)
    w569 = w568 * link3_mass
    w570 = w57 * w78 - w62 * w83
    w571 = w155 * w165 - w51 * w158
    w572 = w159 * w567 + w165 * w570 - (w163 * w571 - w51 * w204 + (w75 * w160 + w157 * w564))
    w573 = w572 * link3_mass
    w574 = w158 * w570 - w159 * w566 + (w75 * w166 + w157 * w565 + (w155 * w204 + w156 * w571))
    w575 = w574 * link3_mass
    w576 = (w78 + w78) * c15
    w577 = (w62 + w62) * c40
    w578 = w120 * w122 - w113 * w124
    w579 = w578 - w130
    w580 = w579 * c13
    w581 = (w122 * w425 + w126 * w426) * c13
    w582 = w120 * w126 - w113 * w139
    w583 = w582 - w148
    w584 = w583 * c13
    w585 = w119 * w580 - w136 * w581 + w144 * w584
    w586 = w194 * w580 - w196 * w581 + w200 * w584
    w587 = w113 * w581 + w122 * w580 + w126 * w584
    w588 = (w148 + w582) * c22 - w583 * c24
    w589 = w122 * w139 + w124 * w126
    w590 = (w589 - w429) * c21 - (w429 + w589) * c22
    w591 = w579 * c24 - (w130 + w578) * c21
    w592 = w116 * w120
    w593 = w427 + w116 * link3_theta3_dot
    w594 = w592 - w593
    w595 = w594 * c13
    w596 = (w116 * w425 - w115 * w426) * c13
    w597 = w418 + w115 * link3_theta3_dot
    w598 = w115 * w120
    w599 = w597 - w598
    w600 = w599 * c13
    w601 = w119 * w595 - w136 * w596 + w144 * w600
    w602 = w194 * w595 - w196 * w596 + w200 * w600
    w603 = w113 * w596 + w122 * w595 + w126 * w600
    w604 = w594 * c24 - (w592 + w593) * c21
    w605 = (w597 + w598) * c22 + w599 * c24
    w606 = w116 * w139 - w115 * w124
    w607 = (w606 - w416) * c21 - (w416 + w606) * c22
    w608 = (w139 + w139) * c22
    w609 = (w124 + w124) * c41
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w3 * w49 + w8 * w185 - (w8 * w189 - w3 * w211),
            w3 * w252 - w185 * w236 - (w8 * w260 - w211 * w234 - w287),
            -(w3 * w298 + (w41 * w267 + w40 * w300 - w10 * w302 + (w41 * w304 - w40 * w283) + w8 * w308)),
            w3 * w314 - w8 * w318, w3 * w360 - w8 * w368, w3 * w402 - w8 * w406, w3 * w415 - w8 * w154,
            w3 * w434 - w8 * w435, w3 * w455 - w8 * w456,
        ),
        ca.horzcat(  # link1.theta2
            w220, w291, w310 + w45 * w308 - w109 * w298, w212 * w321 + w45 * w318 + w109 * w314, w372 + w109 * w360,
            w409, w45 * w154 + w109 * w415, w212 * w436 + w45 * w435 + w109 * w434,
            w212 * w457 + w45 * w456 + w109 * w455,
        ),
        ca.horzcat(0.0, -w279, -w302, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w48 * w158 - (w187 * w221 - w47 * w222 + w159 * w188),
            w158 * w251 - (w221 * w258 - w222 * w250 + w159 * w259), -(w75 * w306 * c37 + w155 * w296 * c37),
            w158 * w313 + w159 * w184 - (w159 * w317 - w158 * w210 - (w192 * w222 + w111 * w221)), w383, w414,
            w158 * w415 - w154 * w159, w158 * w434 - w159 * w435, w158 * w455 - w159 * w456,
        ),
        ca.horzcat(  # link2.theta2
            w168 * w187 * c37 + (w59 * w214 * c37 + w51 * (w47 * w50) * c37),
            w168 * w258 * c37 + (w59 * w289 * c37 + w52 * w250 * c37),
            w225 * w306 - w224 * w296 + w59 * w309 * c37 + w207 * w307 - w181 * w297, w322,
            w384 + (w207 * w367 + w210 * w365) + (w181 * w359 + w184 * w357),
            w217 * w408 - (w54 * w410 - w53 * w373 - (w54 * w380 + w53 * w413)) + w207 * w405 - w181 * w401,
            w154 * w207 + w181 * w415, w217 * w436 + w207 * w435 + w181 * w434,
            w217 * w457 + w207 * w456 + w181 * w455,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, -w379, -w412, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w187 * w227 - w47 * w228), -(w227 * w258 - w228 * w250), -(w227 * w306 + w228 * w296),
            -(w227 * w316 - w228 * w312), -(w227 * w366 - w228 * w358), -(w227 * w404 + w228 * w400),
            w209 * w228 + w183 * w227, -(w183 * (w193 * c13) - w209 * (w114 * c13) - w447),
            -(w126 * w437 + w122 * w458 - w113 * w460 + (w126 * w461 - w122 * w445)),
        ),
        ca.horzcat(  # link3.theta2
            w47 * w230 + w187 * w231 + w214 * w232, w230 * w250 + w231 * w258 + w232 * w289,
            w231 * w306 - w230 * w296 + w232 * w309, w230 * w312 + w231 * w316 + w232 * w320,
            w230 * w358 + w231 * w366 + w232 * w370, w231 * w404 - w230 * w400 + w232 * w407,
            w209 * w230 - w183 * w231,
            -(w115 * w446 - w116 * w438 - (w183 * (w112 * w232) + w209 * (w117 * w232) - w218 * w229)),
            -(w116 * w458 - w115 * w437 - (w116 * w445 + w115 * w461)),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w444, -w460),  # link3.theta3
    )
    J_v = ca.vertcat(
        ca.horzcat(  # link1.theta1
            -(w3 * w466 + (w40 * w468 - w10 * w472 + w41 * w474 + w8 * w478)),
            w3 * w487 - (w41 * w489 - (w40 * w491 + w10 * w493) + w8 * w497),
            w3 * w506 - (w40 * w507 + w41 * w508 + w8 * w513), w3 * w527 - w8 * w531, w3 * w553 - w8 * w557,
            w3 * w569 - w8 * w573, w3 * w585 - w8 * w586, w3 * w601 - w8 * w602, 0.0,
        ),
        ca.horzcat(  # link1.theta2
            w480, w499, w515, w212 * (w51 * w519 + w60 * w518 + w64 * w522 + w533) + w45 * w531 + w109 * w527,
            w212 * (w51 * w544 + w60 * w543 + w64 * w548 + w559) + w45 * w557 + w109 * w553,
            w212 * w575 + w45 * w573 + w109 * w569, w212 * w587 + w45 * w586 + w109 * w585,
            w212 * w603 + w45 * w602 + w109 * w601, 0.0,
        ),
        ca.horzcat(-w472, -w493, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            -(w75 * w476 * c37 + w155 * w464 * c37), w158 * w486 - (w221 * w495 - w222 * w485 + w159 * w496),
            w158 * w505 - (w221 * w511 - w222 * w504 + w159 * w512),
            -(w158 * w526 + (w60 * w534 - w51 * w538 + w64 * w539 + w159 * w530)),
            w158 * w552 - (w64 * w560 - (w60 * w561 + w51 * w563) + w159 * w556),
            w158 * w569 - (w60 * w576 + w64 * w577 + w159 * w573), w158 * w585 - w159 * w586,
            w158 * w601 - w159 * w602, 0.0,
        ),
        ca.horzcat(  # link2.theta2
            w225 * w476 - w224 * w464 + w59 * w479 * c37 + w207 * w477 - w181 * w465,
            w168 * w495 * c37 + (w59 * w498 * c37 + w52 * w485 * c37),
            w168 * w511 * c37 + (w59 * w514 * c37 + w52 * w504 * c37),
            w217 * w533 - (w54 * w534 - w53 * w539) + w207 * w530 - w181 * w526,
            w217 * w559 + (w54 * w561 + w53 * w560) + w207 * w556 + w181 * w552,
            w217 * w575 - (w54 * w576 - w53 * w577) + w207 * w573 + w181 * w569,
            w217 * w587 + w207 * w586 + w181 * w585, w217 * w603 + w207 * w602 + w181 * w601, 0.0,
        ),
        ca.horzcat(0.0, 0.0, 0.0, -w538, -w563, 0.0, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w227 * w476 + w228 * w464), -(w227 * w495 - w228 * w485), -(w227 * w511 - w228 * w504),
            -(w227 * w529 + w228 * w525), -(w227 * w555 - w228 * w551), -(w227 * w572 - w228 * w568),
            -(w122 * w588 - w113 * w590 + w126 * w591), -(w126 * w604 - (w122 * w605 + w113 * w607)),
            -(w122 * w608 + w126 * w609),
        ),
        ca.horzcat(  # link3.theta2
            w231 * w476 - w230 * w464 + w232 * w479, w230 * w485 + w231 * w495 + w232 * w498,
            w230 * w504 + w231 * w511 + w232 * w514, w231 * w529 - w230 * w525 + w232 * w532,
            w230 * w551 + w231 * w555 + w232 * w558, w230 * w568 + w231 * w572 + w232 * w574,
            -(w116 * w588 - w115 * w591), w116 * w605 + w115 * w604, -(w116 * w608 - w115 * w609),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w590, -w607, 0.0),  # link3.theta3
    )
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
