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
    gives c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    132 operations.
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
    # intermediate terms (26)
    w0 = (link1_inertia_xx + link1_inertia_yy + link1_inertia_zz) / 2.0
    w1 = w0 - link1_inertia_yy
    w2 = w0 - link1_inertia_zz
    w3 = w1 + w2
    w4 = w0 - link1_inertia_xx + link1_mass * link1_center_of_mass_x**2
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = link2_mass + link3_mass
    w8 = link2_mass * link2_center_of_mass_x
    w9 = link3_mass * link3_center_of_mass_x
    w10 = (link2_inertia_xx + link2_inertia_yy + link2_inertia_zz) / 2.0
    w11 = w10 - link2_inertia_yy
    w12 = w10 - link2_inertia_zz
    w13 = w11 + w12
    w14 = w10 - link2_inertia_xx + link2_mass * link2_center_of_mass_x**2
    w15 = w12 + w14
    w16 = w11 + w14
    w17 = link3_mass * link2_end_x
    w18 = (link3_inertia_xx + link3_inertia_yy + link3_inertia_zz) / 2.0
    w19 = w18 - link3_inertia_yy
    w20 = w18 - link3_inertia_zz
    w21 = w19 + w20
    w22 = w18 - link3_inertia_xx + link3_mass * link3_center_of_mass_x**2
    w23 = w20 + w22
    w24 = w19 + w22
    w25 = link1_mass * link1_center_of_mass_x
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w3,  # c2
        w4,  # c3
        w5,  # c4
        w6,  # c5
        link1_end_x,  # link1_end_x
        link2_mass,  # link2_mass
        link3_mass,  # link3_mass
        w7,  # c9
        link1_end_x * (link1_end_x * w7),  # c10
        -w3,  # c11
        w8,  # c12
        link2_end_x,  # link2_end_x
        w9,  # c14
        w11,  # c15
        w12,  # c16
        w13,  # c17
        w14,  # c18
        w15,  # c19
        w16,  # c20
        link2_end_x * w17,  # c21
        -w13,  # c22
        w19,  # c23
        w20,  # c24
        w21,  # c25
        w22,  # c26
        w23,  # c27
        w24,  # c28
        -w21,  # c29
        gravity_z,  # gravity_z
        w25 * gravity_z,  # c31
        link2_mass * gravity_z,  # c32
        link3_mass * gravity_z,  # c33
        link1_mass,  # link1_mass
        w25,  # c35
        link1_mass * gravity_z,  # c36
        w8 + w17,  # c37
        2.0,  # c38
        2 * w8,  # c39
        2 * w9,  # c40
        2 * w3,  # c41
        2 * w5,  # c42
        2 * w6,  # c43
        2 * w13,  # c44
        2 * w15,  # c45
        2 * w16,  # c46
        2 * w21,  # c47
        2 * w23,  # c48
        2 * w24,  # c49
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 9 x 9) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 9) [N, N m]: condensed force S^T (Q* - M s)
    737 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    link2_end_x = c[13]
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
    gravity_z = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    # intermediate terms (179)
    w0 = ca.sin(link1_theta2)
    w1 = ca.cos(link1_theta2)
    w2 = ca.sin(link1_theta3)
    w3 = w1 * w2
    w4 = ca.cos(link1_theta3)
    w5 = w1 * w4
    w6 = ca.cos(link1_theta1)
    w7 = w1 * w6
    w8 = w7 * link1_end_x
    w9 = ca.sin(link1_theta1)
    w10 = w1 * w9
    w11 = w10 * link1_end_x
    w12 = w4 * c4
    w13 = w2 * c5
    w14 = w0 * link1_end_x
    w15 = w9 * w14
    w16 = w6 * w14
    w17 = w3 * w12 - w5 * w13 - w8 * (w15 * c9) + w11 * (w16 * c9)
    w18 = w0 * c11
    w19 = ca.cos(link2_theta1)
    w20 = ca.cos(link2_theta2)
    w21 = w19 * w20
    w22 = w21 * c12
    w23 = w21 * link2_end_x
    w24 = w22 + w23 * link3_mass
    w25 = ca.sin(link2_theta1)
    w26 = w20 * w25
    w27 = w26 * c12
    w28 = w26 * link2_end_x
    w29 = w27 + w28 * link3_mass
    w30 = w8 * w24 + w11 * w29
    w31 = ca.sin(link2_theta2)
    w32 = w31 * c12
    w33 = w19 * w32
    w34 = w31 * link2_end_x
    w35 = w19 * w34
    w36 = w35 * link3_mass
    w37 = w33 + w36
    w38 = w25 * w32
    w39 = w25 * w34
    w40 = w39 * link3_mass
    w41 = w38 + w40
    w42 = w11 * w37 - w8 * w41
    w43 = ca.cos(link3_theta1)
    w44 = ca.cos(link3_theta2)
    w45 = w43 * w44
    w46 = w45 * c14
    w47 = ca.sin(link3_theta1)
    w48 = w44 * w47
    w49 = w48 * c14
    w50 = w8 * w46 + w11 * w49
    w51 = ca.sin(link3_theta2)
    w52 = w51 * c14
    w53 = w43 * w52
    w54 = w47 * w52
    w55 = w11 * w53 - w8 * w54
    w56 = w1 * link1_end_x
    w57 = w16 * w29 - w15 * w24
    w58 = w20 * c12
    w59 = w20 * link2_end_x
    w60 = w56 * (w58 + w59 * link3_mass) + w15 * w41 + w16 * w37
    w61 = w16 * w49 - w15 * w46
    w62 = w44 * c14
    w63 = w56 * w62 + w15 * w54 + w16 * w53
    w64 = ca.sin(link2_theta3)
    w65 = w20 * w64
    w66 = ca.cos(link2_theta3)
    w67 = w20 * w66
    w68 = w66 * c19
    w69 = w64 * c20
    w70 = w65 * w68 - w67 * w69 - w23 * w40 + w28 * w36
    w71 = w31 * c22
    w72 = w23 * w46 + w28 * w49
    w73 = w28 * w53 - w23 * w54
    w74 = w35 * w49 - w39 * w46
    w75 = w59 * w62 + w39 * w54 + w35 * w53
    w76 = ca.sin(link3_theta3)
    w77 = w44 * w76
    w78 = ca.cos(link3_theta3)
    w79 = w44 * w78
    w80 = w78 * c27
    w81 = w76 * c28
    w82 = w77 * w80 - w79 * w81
    w83 = w51 * c29
    w84 = link1_theta3_dot - w0 * link1_theta1_dot
    w85 = w84 * c3
    w86 = w5 * link1_theta1_dot - w2 * link1_theta2_dot
    w87 = w86 * c1
    w88 = w1 * link1_theta3_dot
    w89 = link1_theta3_dot * link1_theta2_dot
    w90 = link1_theta1_dot * (w4 * w88 - w2 * (w0 * link1_theta2_dot)) - w2 * w89
    w91 = w85 * w86 - w84 * w87 - w90 * c4
    w92 = w4 * link1_theta2_dot
    w93 = w3 * link1_theta1_dot + w92
    w94 = w93 * c0
    w95 = w1 * (link1_theta1_dot * link1_theta2_dot)
    w96 = w87 * w93 - w86 * w94 + w95 * c2
    w97 = link1_theta1_dot * (w2 * w88 + w0 * w92) + w4 * w89
    w98 = w84 * w94 - w85 * w93 + w97 * c5
    w99 = w67 * link2_theta1_dot - w64 * link2_theta2_dot
    w100 = w99 * c12
    w101 = w66 * link2_theta2_dot
    w102 = w65 * link2_theta1_dot + w101
    w103 = w102 * c12
    w104 = w99 * w100 + w102 * w103
    w105 = w19 * w66
    w106 = w105 + w64 * (w25 * w31)
    w107 = w20 * link2_theta3_dot
    w108 = link2_theta2_dot * link2_theta3_dot
    w109 = link2_theta1_dot * (w64 * w107 + w31 * w101) + w66 * w108
    w110 = link2_theta3_dot - w31 * link2_theta1_dot
    w111 = w109 * c12 - w103 * w110
    w112 = w25 * w66
    w113 = w31 * w112 - w19 * w64
    w114 = link2_theta1_dot * (w66 * w107 - w64 * (w31 * link2_theta2_dot)) - w64 * w108
    w115 = w114 * c12 - w100 * w110
    w116 = w0 * w95 + w3 * w90 - w5 * w97
    w117 = w4 * w9
    w118 = w4 * w6
    w119 = w90 * (w2 * (w0 * w6) - w117) - w7 * w95 - w97 * (w2 * w9 + w0 * w118)
    w120 = link1_theta1_dot - w0 * link1_theta3_dot
    w121 = w6 * link1_theta2_dot + w10 * link1_theta3_dot
    w122 = w14 * w121 + w11 * w120
    w123 = w7 * link1_theta3_dot - w9 * link1_theta2_dot
    w124 = w11 * w123 - w8 * w121
    w125 = w8 * w116 + w14 * w119 - (w120 * w122 + w123 * w124)
    w126 = w79 * link3_theta1_dot - w76 * link3_theta2_dot
    w127 = w126 * c14
    w128 = w78 * link3_theta2_dot
    w129 = w77 * link3_theta1_dot + w128
    w130 = w129 * c14
    w131 = w126 * w127 + w129 * w130
    w132 = w43 * w78
    w133 = w44 * link3_theta3_dot
    w134 = link3_theta2_dot * link3_theta3_dot
    w135 = link3_theta1_dot * (w76 * w133 + w51 * w128) + w78 * w134
    w136 = link3_theta3_dot - w51 * link3_theta1_dot
    w137 = w135 * c14 - w130 * w136
    w138 = w47 * w78
    w139 = link3_theta1_dot * (w78 * w133 - w76 * (w51 * link3_theta2_dot)) - w76 * w134
    w140 = w139 * c14 - w127 * w136
    w141 = w20 * (link2_theta1_dot * link2_theta2_dot)
    w142 = w31 * w141 + w65 * w114 - w67 * w109
    w143 = w64 * (w19 * w31) - w112
    w144 = w25 * w64 + w31 * w105
    w145 = w114 * w143 - w21 * w141 - w109 * w144
    w146 = link2_theta1_dot - w31 * link2_theta3_dot
    w147 = w19 * link2_theta2_dot + w26 * link2_theta3_dot
    w148 = w34 * w147 + w28 * w146
    w149 = w21 * link2_theta3_dot - w25 * link2_theta2_dot
    w150 = w28 * w149 - w23 * w147
    w151 = w125 + (w23 * w142 + w34 * w145 - (w146 * w148 + w149 * w150))
    w152 = w48 * w131 + (w132 + w76 * (w47 * w51)) * w137 + (w51 * w138 - w43 * w76) * w140 - w151 * link3_mass
    w153 = w26 * w104 + w106 * w111 + w113 * w115 - w125 * link2_mass + w152
    w154 = w8 * w120 + w14 * w123
    w155 = w90 * (w118 + w2 * (w0 * w9)) - w10 * w95 - w97 * (w0 * w117 - w2 * w6)
    w156 = w121 * w124 - w120 * w154 - (w14 * w155 + w11 * w116)
    w157 = w23 * w146 + w34 * w149
    w158 = w106 * w114 - w26 * w141 - w109 * w113
    w159 = w156 + (w147 * w150 - w146 * w157 - (w34 * w158 + w28 * w142))
    w160 = w45 * w131 + w137 * (w76 * (w43 * w51) - w138) + w140 * (w47 * w76 + w51 * w132) - w159 * link3_mass
    w161 = w21 * w104 + w111 * w143 + w115 * w144 - w156 * link2_mass + w160
    w162 = w123 * w154 + w121 * w122 + (w11 * w119 - w8 * w155)
    w163 = w162 + (w149 * w157 + w147 * w148 + (w28 * w145 - w23 * w158))
    w164 = w77 * w137 - w51 * w131 + w79 * w140 + c33 - w163 * link3_mass
    w165 = w4 * w91 - w2 * w98 - w1 * c31 - w56 * (w65 * w111 - w31 * w104 + w67 * w115 + c32 - w162 * link2_mass + w164)
    w166 = w110 * c18
    w167 = w99 * c16
    w168 = w99 * w166 - w110 * w167 - w114 * c19
    w169 = w102 * c15
    w170 = w102 * w167 - w99 * w169 + w141 * c17
    w171 = w110 * w169 - w102 * w166 + w109 * c20
    w172 = w66 * w168 - w64 * w171 - w58 * gravity_z + (w33 * w156 + w38 * w125 + w58 * w162) - w59 * w164 - w39 * w152
    w173 = w136 * c26
    w174 = w126 * c24
    w175 = w126 * w173 - w136 * w174 - w139 * c27
    w176 = w129 * c23
    w177 = w129 * w174 - w126 * w176 + w44 * (link3_theta1_dot * link3_theta2_dot) * c25
    w178 = w136 * w176 - w129 * w173 + w135 * c28
    # outputs
    M_hat = ca.SX(9, 9)
    # link1.theta1
    M_hat[0, 0] = w5 * (w5 * c5) + (w3 * (w3 * c4) + (w0 * (w0 * c2) + w1**2 * c10))
    M_hat[0, 1] = w17
    M_hat[0, 2] = w18
    M_hat[0, 3] = w30
    M_hat[0, 4] = w42
    M_hat[0, 6] = w50
    M_hat[0, 7] = w55
    # link1.theta2
    M_hat[1, 0] = w17
    M_hat[1, 1] = w2 * w13 + (c10 + w4 * w12)
    M_hat[1, 3] = w57
    M_hat[1, 4] = w60
    M_hat[1, 6] = w61
    M_hat[1, 7] = w63
    # link1.theta3
    M_hat[2, 0] = w18
    M_hat[2, 2] = c2
    # link2.theta1
    M_hat[3, 0] = w30
    M_hat[3, 1] = w57
    M_hat[3, 3] = w67 * (w67 * c20) + (w65 * (w65 * c19) + (w31 * (w31 * c17) + w20**2 * c21))
    M_hat[3, 4] = w70
    M_hat[3, 5] = w71
    M_hat[3, 6] = w72
    M_hat[3, 7] = w73
    # link2.theta2
    M_hat[4, 0] = w42
    M_hat[4, 1] = w60
    M_hat[4, 3] = w70
    M_hat[4, 4] = w64 * w69 + (c21 + w66 * w68)
    M_hat[4, 6] = w74
    M_hat[4, 7] = w75
    # link2.theta3
    M_hat[5, 3] = w71
    M_hat[5, 5] = c17
    # link3.theta1
    M_hat[6, 0] = w50
    M_hat[6, 1] = w61
    M_hat[6, 3] = w72
    M_hat[6, 4] = w74
    M_hat[6, 6] = w51 * (w51 * c25) + w77 * (w77 * c27) + w79 * (w79 * c28)
    M_hat[6, 7] = w82
    M_hat[6, 8] = w83
    # link3.theta2
    M_hat[7, 0] = w55
    M_hat[7, 1] = w63
    M_hat[7, 3] = w73
    M_hat[7, 4] = w75
    M_hat[7, 6] = w82
    M_hat[7, 7] = w78 * w80 + w76 * w81
    # link3.theta3
    M_hat[8, 6] = w83
    M_hat[8, 8] = c25
    Q_hat = ca.vertcat(
        w3 * w91 - w0 * w96 + w5 * w98 + w8 * w153 - w11 * w161,  # link1.theta1
        w165 - w15 * w153 - w16 * w161,  # link1.theta2
        w96,  # link1.theta3
        w65 * w168 - w31 * w170 + w67 * w171 - (w22 * w125 - w27 * w156) + w23 * w152 - w28 * w160,  # link2.theta1
        w172 - w35 * w160,  # link2.theta2
        w170,  # link2.theta3
        w77 * w175 - w51 * w177 + w79 * w178 - (w46 * w151 - w49 * w159),  # link3.theta1
        w78 * w175 - w76 * w178 - w62 * gravity_z + (w53 * w159 + w54 * w151 + w62 * w163),  # link3.theta2
        w177,  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 9) [mixed]: dependent coordinates after one Newton step
    39 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    c = ca.SX.sym("c", 50)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link1_end_x = c[6]
    link2_end_x = c[13]
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 9) [mixed]: rates of the dependent coordinates
    65 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 50)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link1_theta1_dot = q_i_dot[0]
    link1_theta2_dot = q_i_dot[1]
    link2_theta1_dot = q_i_dot[3]
    link2_theta2_dot = q_i_dot[4]
    link1_end_x = c[6]
    link2_end_x = c[13]
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 9) [mixed]: accelerations of the dependent coordinates
    253 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 50)
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
    link2_end_x = c[13]
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
    w29 = w6 * w13 + w4 * w27 + (w7 * w26 - w8 * w23) - link1_theta2_ddot * (w1 * link1_end_x)
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
    w59 = w29 + (w36 * w43 + w34 * w57 + (w37 * w56 - w38 * w53)) - link2_theta2_ddot * (w31 * link2_end_x)
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 9) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 9 x 18) [SI]: constraint Jacobian
    gives C_t (n_c = 9) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 9) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 9) [m/s^2, rad/s^2]: right-hand side at acceleration level
    440 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 50)
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
    link2_end_x = c[13]
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    link2_end_x = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    gravity_z = c[30]
    c32 = c[32]
    c33 = c[33]
    link1_mass = c[34]
    c35 = c[35]
    c36 = c[36]
    # intermediate terms (178)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1
    w3 = -(w2 * c35)
    w4 = ca.cos(link1_theta1)
    w5 = ca.sin(link1_theta2)
    w6 = w5 * c35
    w7 = -(w4 * w6)
    w8 = w0 * w4
    w9 = w8 * c35
    w10 = -(w1 * w6)
    w11 = w0 * c35
    w12 = -w11
    w13 = ca.sin(link1_theta3)
    w14 = w0 * w13
    w15 = ca.cos(link1_theta3)
    w16 = w0 * w15
    w17 = w15 * c4
    w18 = w13 * c5
    w19 = w14 * w17 - w16 * w18
    w20 = w5 * c11
    w21 = ca.cos(link2_theta2)
    w22 = ca.sin(link2_theta1)
    w23 = w21 * w22
    w24 = -(w23 * c12)
    w25 = ca.cos(link2_theta1)
    w26 = ca.sin(link2_theta2)
    w27 = w26 * c12
    w28 = -(w25 * w27)
    w29 = w21 * w25
    w30 = w29 * c12
    w31 = -(w22 * w27)
    w32 = w21 * c12
    w33 = -w32
    w34 = ca.sin(link2_theta3)
    w35 = w21 * w34
    w36 = ca.cos(link2_theta3)
    w37 = w21 * w36
    w38 = w36 * c19
    w39 = w34 * c20
    w40 = w35 * w38 - w37 * w39
    w41 = w26 * c22
    w42 = ca.cos(link3_theta2)
    w43 = ca.sin(link3_theta1)
    w44 = w42 * w43
    w45 = -(w44 * c14)
    w46 = ca.cos(link3_theta1)
    w47 = ca.sin(link3_theta2)
    w48 = w47 * c14
    w49 = -(w46 * w48)
    w50 = w42 * w46
    w51 = w50 * c14
    w52 = -(w43 * w48)
    w53 = w42 * c14
    w54 = -w53
    w55 = ca.sin(link3_theta3)
    w56 = w42 * w55
    w57 = ca.cos(link3_theta3)
    w58 = w42 * w57
    w59 = w57 * c27
    w60 = w55 * c28
    w61 = w56 * w59 - w58 * w60
    w62 = w47 * c29
    w63 = w16 * link1_theta1_dot - w13 * link1_theta2_dot
    w64 = w63 * c35
    w65 = w15 * link1_theta2_dot
    w66 = w14 * link1_theta1_dot + w65
    w67 = w66 * c35
    w68 = w63 * w64 + w66 * w67
    w69 = w1 * w15
    w70 = w13 * (w4 * w5) - w69
    w71 = w0 * link1_theta3_dot
    w72 = link1_theta2_dot * link1_theta3_dot
    w73 = link1_theta1_dot * (w13 * w71 + w5 * w65) + w15 * w72
    w74 = link1_theta3_dot - w5 * link1_theta1_dot
    w75 = w73 * c35 - w67 * w74
    w76 = w4 * w15
    w77 = w1 * w13 + w5 * w76
    w78 = link1_theta1_dot * (w15 * w71 - w13 * (w5 * link1_theta2_dot)) - w13 * w72
    w79 = w78 * c35 - w64 * w74
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
    w95 = w94 * c12
    w96 = w36 * link2_theta2_dot
    w97 = w35 * link2_theta1_dot + w96
    w98 = w97 * c12
    w99 = w94 * w95 + w97 * w98
    w100 = w22 * w36
    w101 = w34 * (w25 * w26) - w100
    w102 = w21 * link2_theta3_dot
    w103 = link2_theta2_dot * link2_theta3_dot
    w104 = link2_theta1_dot * (w34 * w102 + w26 * w96) + w36 * w103
    w105 = link2_theta3_dot - w26 * link2_theta1_dot
    w106 = w104 * c12 - w98 * w105
    w107 = w25 * w36
    w108 = w22 * w34 + w26 * w107
    w109 = link2_theta1_dot * (w36 * w102 - w34 * (w26 * link2_theta2_dot)) - w34 * w103
    w110 = w109 * c12 - w95 * w105
    w111 = w29 * w99 + w101 * w106 + w108 * w110
    w112 = w107 + w34 * (w22 * w26)
    w113 = w26 * w100 - w25 * w34
    w114 = w23 * w99 + w106 * w112 + w110 * w113
    w115 = w35 * w106 - w26 * w99 + w37 * w110
    w116 = w105 * c18
    w117 = w94 * c16
    w118 = w94 * w116 - w105 * w117 - w109 * c19
    w119 = w97 * c15
    w120 = w21 * (link2_theta1_dot * link2_theta2_dot)
    w121 = w97 * w117 - w94 * w119 + w120 * c17
    w122 = w105 * w119 - w97 * w116 + w104 * c20
    w123 = w35 * w118 - w26 * w121 + w37 * w122
    w124 = w36 * w118 - w34 * w122
    w125 = w58 * link3_theta1_dot - w55 * link3_theta2_dot
    w126 = w125 * c14
    w127 = w57 * link3_theta2_dot
    w128 = w56 * link3_theta1_dot + w127
    w129 = w128 * c14
    w130 = w125 * w126 + w128 * w129
    w131 = w43 * w57
    w132 = w42 * link3_theta3_dot
    w133 = link3_theta2_dot * link3_theta3_dot
    w134 = link3_theta1_dot * (w55 * w132 + w47 * w127) + w57 * w133
    w135 = link3_theta3_dot - w47 * link3_theta1_dot
    w136 = w134 * c14 - w129 * w135
    w137 = w46 * w57
    w138 = link3_theta1_dot * (w57 * w132 - w55 * (w47 * link3_theta2_dot)) - w55 * w133
    w139 = w138 * c14 - w126 * w135
    w140 = w50 * w130 + (w55 * (w46 * w47) - w131) * w136 + (w43 * w55 + w47 * w137) * w139
    w141 = w44 * w130 + w136 * (w137 + w55 * (w43 * w47)) + w139 * (w47 * w131 - w46 * w55)
    w142 = w56 * w136 - w47 * w130 + w58 * w139
    w143 = w135 * c26
    w144 = w125 * c24
    w145 = w125 * w143 - w135 * w144 - w138 * c27
    w146 = w128 * c23
    w147 = w128 * w144 - w125 * w146 + w42 * (link3_theta1_dot * link3_theta2_dot) * c25
    w148 = w135 * w146 - w128 * w143 + w134 * c28
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
    M[9, 9] = w26 * (w26 * c17) + w35 * (w35 * c19) + w37 * (w37 * c20)
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
    M[11, 11] = c17
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
    M[15, 15] = w47 * (w47 * c25) + w56 * (w56 * c27) + w58 * (w58 * c28)
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
    M[17, 17] = c25
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
    Q_F[2] = c36  # link1.z
    Q_F[4] = -w151  # link1.theta2
    Q_F[8] = c32  # link2.z
    Q_F[10] = -w152  # link2.theta2
    Q_F[14] = c33  # link3.z
    Q_F[16] = -w153  # link3.theta2
    Q_star = ca.vertcat(
        w80,  # link1.x
        w83,  # link1.y
        w84 + c36,  # link1.z
        w92,  # link1.theta1
        w93 - w151,  # link1.theta2
        w90,  # link1.theta3
        w111,  # link2.x
        w114,  # link2.y
        c32 + w115,  # link2.z
        w123,  # link2.theta1
        w124 - w152,  # link2.theta2
        w121,  # link2.theta3
        w140,  # link3.x
        w141,  # link3.y
        c33 + w142,  # link3.z
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 9) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 3) [N, N m]: world force and moment of a joint on its body b, at b
    373 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    q_ddot = ca.SX.sym("q_ddot", 18)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    c14 = c[14]
    c32 = c[32]
    c33 = c[33]
    link1_mass = c[34]
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
    w7 = w6 * c35
    w8 = w1 * w5
    w9 = w3 * link1_theta2_dot
    w10 = link1_theta1_dot * w8 + w9
    w11 = w10 * c35
    w12 = w6 * w7 + w10 * w11
    w13 = ca.sin(link1_theta2)
    w14 = ca.sin(link1_theta1)
    w15 = w3 * w14
    w16 = w1 * link1_theta3_dot
    w17 = link1_theta2_dot * link1_theta3_dot
    w18 = link1_theta3_dot - link1_theta1_dot * w13
    w19 = (link1_theta1_dot * (w5 * w16 + w9 * w13) + w3 * w17) * c35 - w11 * w18
    w20 = w0 * w3
    w21 = (link1_theta1_dot * (w3 * w16 - w5 * (link1_theta2_dot * w13)) - w5 * w17) * c35 - w7 * w18
    w22 = w1 * w14
    w23 = w13 * c35
    w24 = w2 * w12 + (w5 * (w0 * w13) - w15) * w19 + (w5 * w14 + w13 * w20) * w21 - (link1_x_ddot * link1_mass - w22 * c35 * link1_theta1_ddot - w0 * w23 * link1_theta2_ddot)
    w25 = ca.cos(link2_theta1)
    w26 = ca.cos(link2_theta2)
    w27 = w25 * w26
    w28 = ca.cos(link2_theta3)
    w29 = w26 * w28
    w30 = ca.sin(link2_theta3)
    w31 = link2_theta1_dot * w29 - link2_theta2_dot * w30
    w32 = w31 * c12
    w33 = w26 * w30
    w34 = w28 * link2_theta2_dot
    w35 = link2_theta1_dot * w33 + w34
    w36 = w35 * c12
    w37 = w31 * w32 + w35 * w36
    w38 = ca.sin(link2_theta2)
    w39 = ca.sin(link2_theta1)
    w40 = w28 * w39
    w41 = w26 * link2_theta3_dot
    w42 = link2_theta2_dot * link2_theta3_dot
    w43 = link2_theta3_dot - link2_theta1_dot * w38
    w44 = (link2_theta1_dot * (w30 * w41 + w34 * w38) + w28 * w42) * c12 - w36 * w43
    w45 = w25 * w28
    w46 = (link2_theta1_dot * (w28 * w41 - w30 * (link2_theta2_dot * w38)) - w30 * w42) * c12 - w32 * w43
    w47 = w26 * w39
    w48 = w38 * c12
    w49 = w27 * w37 + (w30 * (w25 * w38) - w40) * w44 + (w30 * w39 + w38 * w45) * w46 - (link2_x_ddot * link2_mass - w47 * c12 * link2_theta1_ddot - w25 * w48 * link2_theta2_ddot)
    w50 = ca.cos(link3_theta1)
    w51 = ca.cos(link3_theta2)
    w52 = w50 * w51
    w53 = ca.cos(link3_theta3)
    w54 = w51 * w53
    w55 = ca.sin(link3_theta3)
    w56 = link3_theta1_dot * w54 - link3_theta2_dot * w55
    w57 = w56 * c14
    w58 = w51 * w55
    w59 = w53 * link3_theta2_dot
    w60 = link3_theta1_dot * w58 + w59
    w61 = w60 * c14
    w62 = w56 * w57 + w60 * w61
    w63 = ca.sin(link3_theta2)
    w64 = ca.sin(link3_theta1)
    w65 = w53 * w64
    w66 = w51 * link3_theta3_dot
    w67 = link3_theta2_dot * link3_theta3_dot
    w68 = link3_theta3_dot - link3_theta1_dot * w63
    w69 = (link3_theta1_dot * (w55 * w66 + w59 * w63) + w53 * w67) * c14 - w61 * w68
    w70 = w50 * w53
    w71 = (link3_theta1_dot * (w53 * w66 - w55 * (link3_theta2_dot * w63)) - w55 * w67) * c14 - w57 * w68
    w72 = w51 * w64
    w73 = w63 * c14
    w74 = w52 * w62 + (w55 * (w50 * w63) - w65) * w69 + (w55 * w64 + w63 * w70) * w71 - (link3_x_ddot * link3_mass - w72 * c14 * link3_theta1_ddot - w50 * w73 * link3_theta2_ddot)
    w75 = w49 + w74
    w76 = w24 + w75
    w77 = w12 * w22 + w19 * (w20 + w5 * (w13 * w14)) + w21 * (w13 * w15 - w0 * w5) - (link1_y_ddot * link1_mass + link1_theta1_ddot * (w2 * c35) - link1_theta2_ddot * (w14 * w23))
    w78 = w37 * w47 + w44 * (w45 + w30 * (w38 * w39)) + w46 * (w38 * w40 - w25 * w30) - (link2_y_ddot * link2_mass + link2_theta1_ddot * (w27 * c12) - link2_theta2_ddot * (w39 * w48))
    w79 = w62 * w72 + w69 * (w70 + w55 * (w63 * w64)) + w71 * (w63 * w65 - w50 * w55) - (link3_y_ddot * link3_mass + link3_theta1_ddot * (w52 * c14) - link3_theta2_ddot * (w64 * w73))
    w80 = w78 + w79
    w81 = w77 + w80
    w82 = c36 + (w8 * w19 - w12 * w13 + w4 * w21) - (link1_z_ddot * link1_mass - link1_theta2_ddot * (w1 * c35))
    w83 = c32 + (w33 * w44 - w37 * w38 + w29 * w46) - (link2_z_ddot * link2_mass - link2_theta2_ddot * (w26 * c12))
    w84 = c33 + (w58 * w69 - w62 * w63 + w54 * w71) - (link3_z_ddot * link3_mass - link3_theta2_ddot * (w51 * c14))
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    299 operations.
    """
    q = ca.SX.sym("q", 18)
    q_dot = ca.SX.sym("q_dot", 18)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    c14 = c[14]
    c17 = c[17]
    c19 = c[19]
    c20 = c[20]
    c25 = c[25]
    c27 = c[27]
    c28 = c[28]
    gravity_z = c[30]
    link1_mass = c[34]
    c35 = c[35]
    # intermediate terms (70)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1 * c35
    w3 = ca.cos(link1_theta1)
    w4 = ca.sin(link1_theta2)
    w5 = w4 * c35
    w6 = w3 * w5
    w7 = w0 * w3 * c35
    w8 = w1 * w5
    w9 = link1_x_dot * (link1_x_dot * link1_mass - w2 * link1_theta1_dot - w6 * link1_theta2_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta1_dot * w7 - link1_theta2_dot * w8)
    w10 = w0 * c35
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
    w25 = w23 * w24 * c12
    w26 = ca.cos(link2_theta1)
    w27 = ca.sin(link2_theta2)
    w28 = w27 * c12
    w29 = w26 * w28
    w30 = w23 * w26 * c12
    w31 = w24 * w28
    w32 = w22 + link2_x_dot * (link2_x_dot * link2_mass - w25 * link2_theta1_dot - w29 * link2_theta2_dot) + link2_y_dot * (link2_y_dot * link2_mass + link2_theta1_dot * w30 - link2_theta2_dot * w31)
    w33 = w23 * c12
    w34 = w27 * c17
    w35 = ca.sin(link2_theta3)
    w36 = w23 * w35
    w37 = ca.cos(link2_theta3)
    w38 = w23 * w37
    w39 = link2_y_dot * w30 - link2_x_dot * w25 + link2_theta1_dot * (w27 * w34 + w36 * (w36 * c19) + w38 * (w38 * c20))
    w40 = w37 * c19
    w41 = w35 * c20
    w42 = w36 * w40 - w38 * w41
    w43 = w32 + link2_z_dot * (link2_z_dot * link2_mass - link2_theta2_dot * w33) + link2_theta1_dot * (w39 + link2_theta2_dot * w42 - w34 * link2_theta3_dot)
    w44 = link2_theta1_dot * w42 - (link2_x_dot * w29 + link2_y_dot * w31 + link2_z_dot * w33) + link2_theta2_dot * (w37 * w40 + w35 * w41)
    w45 = w43 + link2_theta2_dot * w44 + link2_theta3_dot * (link2_theta3_dot * c17 - link2_theta1_dot * w34)
    w46 = ca.cos(link3_theta2)
    w47 = ca.sin(link3_theta1)
    w48 = w46 * w47 * c14
    w49 = ca.cos(link3_theta1)
    w50 = ca.sin(link3_theta2)
    w51 = w50 * c14
    w52 = w49 * w51
    w53 = w46 * w49 * c14
    w54 = w47 * w51
    w55 = w45 + link3_x_dot * (link3_x_dot * link3_mass - w48 * link3_theta1_dot - w52 * link3_theta2_dot) + link3_y_dot * (link3_y_dot * link3_mass + link3_theta1_dot * w53 - link3_theta2_dot * w54)
    w56 = w46 * c14
    w57 = w50 * c25
    w58 = ca.sin(link3_theta3)
    w59 = w46 * w58
    w60 = ca.cos(link3_theta3)
    w61 = w46 * w60
    w62 = link3_y_dot * w53 - link3_x_dot * w48 + link3_theta1_dot * (w50 * w57 + w59 * (w59 * c27) + w61 * (w61 * c28))
    w63 = w60 * c27
    w64 = w58 * c28
    w65 = w59 * w63 - w61 * w64
    w66 = w55 + link3_z_dot * (link3_z_dot * link3_mass - link3_theta2_dot * w56) + link3_theta1_dot * (w62 + link3_theta2_dot * w65 - w57 * link3_theta3_dot)
    w67 = link3_theta1_dot * w65 - (link3_x_dot * w52 + link3_y_dot * w54 + link3_z_dot * w56) + link3_theta2_dot * (w60 * w63 + w58 * w64)
    w68 = w66 + link3_theta2_dot * w67 + link3_theta3_dot * (link3_theta3_dot * c25 - link3_theta1_dot * w57)
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
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i, through q_d
    1702 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    link2_end_x = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    gravity_z = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    # intermediate terms (395)
    w0 = ca.cos(link1_theta1)
    w1 = ca.cos(link1_theta2)
    w2 = w0 * w1
    w3 = w2 * link1_end_x
    w4 = ca.sin(link1_theta2)
    w5 = w4 * link1_end_x
    w6 = link1_theta1_dot * link1_theta2_dot
    w7 = w1 * w6
    w8 = ca.sin(link1_theta1)
    w9 = w1 * w8
    w10 = w7 * w9
    w11 = w1 * link1_theta3_dot
    w12 = ca.cos(link1_theta3)
    w13 = w11 * w12
    w14 = w4 * link1_theta2_dot
    w15 = ca.sin(link1_theta3)
    w16 = link1_theta2_dot * link1_theta3_dot
    w17 = w15 * w16
    w18 = link1_theta1_dot * (w13 - w14 * w15) - w17
    w19 = w4 * w8
    w20 = w0 * w12
    w21 = w15 * w19 + w20
    w22 = w18 * w21
    w23 = w11 * w15
    w24 = link1_theta2_dot * w12
    w25 = w12 * w16
    w26 = link1_theta1_dot * (w23 + w4 * w24) + w25
    w27 = w0 * w15
    w28 = w8 * w12
    w29 = w4 * w28
    w30 = w10 - w22 - w26 * (w27 - w29)
    w31 = w1 * w15
    w32 = w1 * w12
    w33 = w4 * w7 + w18 * w31 - w26 * w32
    w34 = w9 * link1_end_x
    w35 = w33 * w34
    w36 = w4 * link1_theta3_dot
    w37 = link1_theta1_dot - w36
    w38 = w2 * link1_theta3_dot - link1_theta2_dot * w8
    w39 = w5 * w38 + w3 * w37
    w40 = w37 * w39
    w41 = w9 * link1_theta3_dot + w0 * link1_theta2_dot
    w42 = w34 * w38 - w3 * w41
    w43 = w41 * w42
    w44 = w5 * w30 - w35 - (w40 - w43)
    w45 = w44 * link3_mass
    w46 = w44 * link2_mass + w45
    w47 = ca.cos(link2_theta2)
    w48 = ca.sin(link2_theta1)
    w49 = w47 * w48
    w50 = ca.cos(link2_theta3)
    w51 = w47 * w50
    w52 = ca.sin(link2_theta3)
    w53 = link2_theta2_dot * w52
    w54 = link2_theta1_dot * w51 - w53
    w55 = w54 * c12
    w56 = w47 * w52
    w57 = w50 * link2_theta2_dot
    w58 = link2_theta1_dot * w56 + w57
    w59 = w58 * c12
    w60 = w54 * w55 + w58 * w59
    w61 = ca.cos(link2_theta1)
    w62 = w50 * w61
    w63 = ca.sin(link2_theta2)
    w64 = w48 * w63
    w65 = w62 + w52 * w64
    w66 = w47 * link2_theta3_dot
    w67 = w52 * w66
    w68 = link2_theta2_dot * link2_theta3_dot
    w69 = w50 * w68
    w70 = link2_theta1_dot * (w67 + w57 * w63) + w69
    w71 = link2_theta3_dot - link2_theta1_dot * w63
    w72 = w59 * w71
    w73 = w70 * c12 - w72
    w74 = w49 * w60 + w65 * w73
    w75 = w48 * w50
    w76 = w63 * w75
    w77 = w52 * w61
    w78 = w76 - w77
    w79 = w50 * w66
    w80 = link2_theta2_dot * w63
    w81 = w52 * w68
    w82 = link2_theta1_dot * (w79 - w52 * w80) - w81
    w83 = w55 * w71
    w84 = w82 * c12 - w83
    w85 = w0 * w4
    w86 = w15 * w85 - w28
    w87 = w8 * w15
    w88 = w87 + w4 * w20
    w89 = w18 * w86 - w2 * w7 - w26 * w88
    w90 = w3 * w33 + w5 * w89
    w91 = w5 * w41 + w34 * w37
    w92 = w37 * w91 + w38 * w42
    w93 = w90 - w92
    w94 = ca.cos(link3_theta2)
    w95 = ca.sin(link3_theta1)
    w96 = w94 * w95
    w97 = ca.cos(link3_theta3)
    w98 = w94 * w97
    w99 = ca.sin(link3_theta3)
    w100 = link3_theta2_dot * w99
    w101 = link3_theta1_dot * w98 - w100
    w102 = w101 * c14
    w103 = w94 * w99
    w104 = w97 * link3_theta2_dot
    w105 = link3_theta1_dot * w103 + w104
    w106 = w105 * c14
    w107 = w101 * w102 + w105 * w106
    w108 = ca.cos(link3_theta1)
    w109 = w97 * w108
    w110 = ca.sin(link3_theta2)
    w111 = w95 * w110
    w112 = w109 + w99 * w111
    w113 = w94 * link3_theta3_dot
    w114 = w99 * w113
    w115 = link3_theta2_dot * link3_theta3_dot
    w116 = w97 * w115
    w117 = link3_theta1_dot * (w114 + w104 * w110) + w116
    w118 = link3_theta3_dot - link3_theta1_dot * w110
    w119 = w106 * w118
    w120 = w117 * c14 - w119
    w121 = w96 * w107 + w112 * w120
    w122 = w95 * w97
    w123 = w110 * w122
    w124 = w99 * w108
    w125 = w123 - w124
    w126 = w97 * w113
    w127 = link3_theta2_dot * w110
    w128 = w99 * w115
    w129 = link3_theta1_dot * (w126 - w99 * w127) - w128
    w130 = w102 * w118
    w131 = w129 * c14 - w130
    w132 = link2_theta1_dot * link2_theta2_dot
    w133 = w47 * w132
    w134 = w63 * w133 + w56 * w82 - w51 * w70
    w135 = w47 * w61
    w136 = w135 * link2_end_x
    w137 = w61 * w63
    w138 = w52 * w137 - w75
    w139 = w48 * w52
    w140 = w139 + w62 * w63
    w141 = w82 * w138 - w133 * w135 - w70 * w140
    w142 = w63 * link2_end_x
    w143 = w134 * w136 + w141 * w142
    w144 = w63 * link2_theta3_dot
    w145 = link2_theta1_dot - w144
    w146 = link2_theta2_dot * w61 + w49 * link2_theta3_dot
    w147 = w49 * link2_end_x
    w148 = w142 * w146 + w145 * w147
    w149 = link2_theta3_dot * w135 - w48 * link2_theta2_dot
    w150 = w147 * w149 - w136 * w146
    w151 = w145 * w148 + w149 * w150
    w152 = w93 + (w143 - w151)
    w153 = w121 + w125 * w131 - w152 * link3_mass
    w154 = w74 + w78 * w84 - w93 * link2_mass + w153
    w155 = w60 * w135 + w73 * w138 + w84 * w140
    w156 = w29 - w27
    w157 = w22 - w10 - w26 * w156
    w158 = w43 - w40 - (w35 + w5 * w157)
    w159 = w94 * w108
    w160 = w108 * w110
    w161 = w99 * w160 - w122
    w162 = w95 * w99
    w163 = w162 + w109 * w110
    w164 = w107 * w159 + w120 * w161 + w131 * w163
    w165 = w146 * w150
    w166 = w136 * w145 + w142 * w149
    w167 = w145 * w166
    w168 = w65 * w82
    w169 = w49 * w133
    w170 = w168 - w169 - w70 * w78
    w171 = w134 * w147
    w172 = w158 + (w165 - w167 - (w142 * w170 + w171))
    w173 = w164 - w172 * link3_mass
    w174 = w155 - w158 * link2_mass + w173
    w175 = w92 - w90
    w176 = w175 * link3_mass
    w177 = w175 * link2_mass + w176
    w178 = w0 * w5
    w179 = w5 * w8
    w180 = w38 * w39 + w41 * w91 + (w34 * w89 - w3 * w157)
    w181 = w180 + (w149 * w166 + w146 * w148 + (w141 * w147 - w136 * w170))
    w182 = c33 + (w103 * w120 - w107 * w110 + w98 * w131) - w181 * link3_mass
    w183 = w1 * link1_end_x
    w184 = w3 * w89
    w185 = w30 * w34 + w184 - (w184 - w34 * w157)
    w186 = w177 * w178 + w174 * w179 - (w154 * w178 - w46 * w179 - w183 * (w185 * link2_mass + w185 * link3_mass))
    w187 = w135 * c12
    w188 = w49 * c12
    w189 = w63 * c12
    w190 = w61 * w189
    w191 = w48 * w189
    w192 = w47 * c12
    w193 = w47 * link2_end_x
    w194 = w48 * w142
    w195 = w61 * w142
    w196 = w159 * c14
    w197 = w96 * c14
    w198 = w110 * c14
    w199 = w108 * w198
    w200 = w95 * w198
    w201 = w94 * c14
    w202 = link1_theta3_dot - w4 * link1_theta1_dot
    w203 = w4 * w12
    w204 = link1_theta1_dot * w203
    w205 = w204 * c1
    w206 = link1_theta2_dot * w15
    w207 = link1_theta1_dot * w32 - w206
    w208 = w207 * c1
    w209 = w1 * link1_theta1_dot
    w210 = w209 * c3
    w211 = w202 * c3
    w212 = link1_theta1_dot * (w12 * w36 + w15 * (w1 * link1_theta2_dot))
    w213 = w202 * w205 + w208 * w209 - (w207 * w210 + w204 * w211) + w212 * c4
    w214 = w207 * w211
    w215 = w214 - w202 * w208 - w18 * c4
    w216 = w4 * w15
    w217 = w24 + link1_theta1_dot * w31
    w218 = w217 * c0
    w219 = link1_theta1_dot * w216
    w220 = w219 * c0
    w221 = w4 * w6
    w222 = w207 * w220 + w204 * w218 - (w205 * w217 + w208 * w219) - w221 * c2
    w223 = link1_theta1_dot * (w1 * w24 - w15 * w36)
    w224 = w210 * w217 + w211 * w219 - (w202 * w220 + w209 * w218) + w223 * c5
    w225 = w211 * w217
    w226 = w202 * w218 - w225 + w26 * c5
    w227 = w31 * w213 - w215 * w216 - (w1 * (w208 * w217 - w207 * w218 + w7 * c2) + w4 * w222) + (w32 * w224 - w203 * w226)
    w228 = w1 * w7 - w4 * w221 - (w18 * w216 + w31 * w212) - (w32 * w223 - w26 * w203)
    w229 = w85 * link1_end_x
    w230 = w18 * (w2 * w15) - w86 * w212 + link1_theta2_dot * (link1_theta1_dot * (w2 * w4)) * c38 - (w26 * (w1 * w20) + w88 * w223)
    w231 = link1_theta3_dot * w19
    w232 = w19 * link1_end_x
    w233 = w41 * w183 - w5 * w231 - (w11 * w34 + w37 * w232)
    w234 = link1_theta3_dot * w85
    w235 = w3 * w231 + w41 * w229 - (w34 * w234 + w38 * w232)
    w236 = w3 * w228 - w33 * w229 + (w5 * w230 + w89 * w183) - (w37 * w233 - w11 * w91 + (w38 * w235 - w42 * w234))
    w237 = w236 * link3_mass
    w238 = w236 * link2_mass + w237
    w239 = w38 * w183 - w5 * w234 - (w3 * w11 + w37 * w229)
    w240 = w18 * (w9 * w15) - w21 * w212 + w8 * (link1_theta2_dot * (link1_theta1_dot * (w1 * w4))) * c38 - (w26 * (w1 * w28) + w156 * w223)
    w241 = w41 * w235 - w42 * w231 - (w37 * w239 - w11 * w39) - (w5 * w240 + w157 * w183 + (w34 * w228 - w33 * w232))
    w242 = w241 * link3_mass
    w243 = w241 * link2_mass + w242
    w244 = w38 * w239 - w39 * w234 + (w41 * w233 - w91 * w231) + (w34 * w230 - w89 * w232 - (w3 * w240 - w157 * w229))
    w245 = w183 * (w244 * link2_mass + w244 * link3_mass) + w5 * (c32 + (w56 * w73 - w60 * w63 + w51 * w84) - w180 * link2_mass + w182)
    w246 = w12 * w213 - w15 * w224 + w4 * c31 + w245 - (w154 * (w8 * w183) - w179 * w238) - (w174 * (w0 * w183) - w178 * w243)
    w247 = w217 * c1
    w248 = w25 + link1_theta1_dot * (w23 + w12 * w14)
    w249 = w202 * w247 - w225 + w248 * c4
    w250 = w207 * c0
    w251 = w207 * w208 - w217 * w247 - (w207 * w250 - w217 * w218)
    w252 = link1_theta1_dot * (w13 - w4 * w206) - w17
    w253 = w202 * w250 - w214 + w252 * c5
    w254 = w18 * w32 - w31 * w248 - (w32 * w252 - w26 * w31)
    w255 = w18 * (w87 + w12 * w85) - w86 * w248 - (w26 * (w28 - w4 * w27) + w88 * w252)
    w256 = w3 * w254 + w5 * w255
    w257 = w256 * link3_mass
    w258 = w256 * link2_mass + w257
    w259 = w18 * (w12 * w19 - w27) - w21 * w248 - (w156 * w252 - w26 * (w20 + w4 * w87))
    w260 = w5 * w259 + w34 * w254
    w261 = w260 * link3_mass
    w262 = w260 * link2_mass + w261
    w263 = w34 * w255 - w3 * w259
    w264 = w12 * w249 - w15 * w215 - (w12 * w226 + w15 * w253) + w183 * (w263 * link2_mass + w263 * link3_mass)
    w265 = w77 - w76
    w266 = w169 - w168 - w70 * w265
    w267 = w142 * w266 - w171 - (w167 - w165)
    w268 = w267 * link3_mass
    w269 = w155 - w268
    w270 = w151 - w143
    w271 = w270 * link3_mass
    w272 = w84 * w265 - w74 - w271
    w273 = w136 * w141
    w274 = w147 * w266 + w273 - (w273 - w147 * w170)
    w275 = w274 * link3_mass
    w276 = w93 * w190 - w158 * w191 + w193 * w275 - (w153 * w195 - w194 * w268) + (w195 * w271 + w173 * w194)
    w277 = w49 * w52
    w278 = link2_theta1_dot * (w47 * w57 - w52 * w144)
    w279 = w52 * w63
    w280 = link2_theta1_dot * w279
    w281 = w47 * link2_theta1_dot
    w282 = w278 * c12 + (w71 * (w280 * c12) + w59 * w281)
    w283 = w50 * w63
    w284 = link2_theta1_dot * w283
    w285 = w63 * (w54 * (link2_theta1_dot * w50)) * c39 + w63 * (w58 * (link2_theta1_dot * w52)) * c39
    w286 = w47 * w75
    w287 = link2_theta1_dot * (w50 * w144 + w52 * (w47 * link2_theta2_dot))
    w288 = w71 * (w284 * c12) + w55 * w281 - w287 * c12
    w289 = w63 * w132
    w290 = w47 * w133 - w63 * w289 - (w82 * w279 + w56 * w287) - (w51 * w278 - w70 * w283)
    w291 = w137 * link2_end_x
    w292 = w52 * w135
    w293 = w47 * w62
    w294 = w82 * w292 - w138 * w287 + w63 * (w61 * (link2_theta2_dot * w281)) * c38 - (w70 * w293 + w140 * w278)
    w295 = w64 * link2_theta3_dot
    w296 = w64 * link2_end_x
    w297 = w146 * w193 - w142 * w295 - (w66 * w147 + w145 * w296)
    w298 = link2_theta3_dot * w137
    w299 = w136 * w295 + w146 * w291 - (w147 * w298 + w149 * w296)
    w300 = w136 * w290 - w134 * w291 + (w142 * w294 + w141 * w193) - (w145 * w297 - w66 * w148 + (w149 * w299 - w150 * w298))
    w301 = w300 * link3_mass
    w302 = w73 * w277 + w65 * w282 - (w60 * w64 + w49 * w285) + (w84 * w286 + w78 * w288) - w301
    w303 = w149 * w193 - w142 * w298 - (w66 * w136 + w145 * w291)
    w304 = w82 * w277 - w65 * w287 + w63 * (link2_theta2_dot * (w49 * link2_theta1_dot)) * c38 - (w70 * w286 + w78 * w278)
    w305 = w146 * w299 - w150 * w295 - (w145 * w303 - w66 * w166) - (w142 * w304 + w170 * w193 + (w147 * w290 - w134 * w296))
    w306 = w305 * link3_mass
    w307 = w73 * w292 + w138 * w282 - (w60 * w137 + w135 * w285) + (w84 * w293 + w140 * w288) - w306
    w308 = w149 * w303 - w166 * w298 + (w146 * w297 - w148 * w295) + (w147 * w294 - w141 * w296 - (w136 * w304 - w170 * w291))
    w309 = w308 * link3_mass
    w310 = w183 * (w56 * w282 - w73 * w279 - (w47 * w60 - w63 * w285) + (w51 * w288 - w84 * w283) - w309) + w179 * w302
    w311 = w284 * c16
    w312 = w54 * c16
    w313 = w281 * c18
    w314 = w71 * c18
    w315 = w71 * w311 + w281 * w312 - (w54 * w313 + w284 * w314) + w287 * c19
    w316 = w54 * w314
    w317 = w316 - w71 * w312 - w82 * c19
    w318 = w58 * c15
    w319 = w280 * c15
    w320 = w54 * w319 + w284 * w318 - (w58 * w311 + w280 * w312) - w289 * c17
    w321 = w58 * w313 + w280 * w314 - (w71 * w319 + w281 * w318) + w278 * c20
    w322 = w58 * w314
    w323 = w71 * w318 - w322 + w70 * c20
    w324 = w56 * w315 - w279 * w317 - (w47 * (w58 * w312 - w54 * w318 + w133 * c17) + w63 * w320) + (w51 * w321 - w283 * w323)
    w325 = w324 - (w158 * (w64 * c12) - w93 * (w137 * c12)) - (w136 * w301 + w153 * w291) + (w147 * w306 + w173 * w296)
    w326 = w50 * w315 - w52 * w321 + w189 * gravity_z + (w158 * (w61 * w192) + w93 * (w48 * w192) - w180 * w189)
    w327 = w326 + (w193 * w309 + w142 * w182) - (w153 * (w48 * w193) - w194 * w301) - (w173 * (w61 * w193) - w195 * w306)
    w328 = w50 * w64 - w77
    w329 = link2_theta1_dot * (w79 - w53 * w63) - w81
    w330 = w329 * c12 - w83
    w331 = w69 + link2_theta1_dot * (w67 + w50 * w80)
    w332 = w72 - w331 * c12
    w333 = w62 + w63 * w139
    w334 = w51 * w82 - w56 * w331 - (w51 * w329 - w56 * w70)
    w335 = w139 + w50 * w137
    w336 = w75 - w63 * w77
    w337 = w82 * w335 - w138 * w331 - (w70 * w336 + w140 * w329)
    w338 = w136 * w334 + w142 * w337
    w339 = w338 * link3_mass
    w340 = w73 * w328 + w65 * w330 + (w78 * w332 - w84 * w333) - w339
    w341 = w82 * w328 - w65 * w331 - (w78 * w329 - w70 * w333)
    w342 = w142 * w341 + w147 * w334
    w343 = w342 * link3_mass
    w344 = w73 * w335 + w138 * w330 + (w84 * w336 + w140 * w332) + w343
    w345 = w147 * w337 - w136 * w341
    w346 = w345 * link3_mass
    w347 = w58 * c16
    w348 = w71 * w347 - w322 + w331 * c19
    w349 = w54 * c15
    w350 = w54 * w312 - w58 * w347 - (w54 * w349 - w58 * w318)
    w351 = w71 * w349 - w316 + w329 * c20
    w352 = w131 * (w124 - w123) - w121
    w353 = w110 * link3_theta3_dot
    w354 = link3_theta1_dot * (w94 * w104 - w99 * w353)
    w355 = w99 * w110
    w356 = link3_theta1_dot * w355
    w357 = w94 * link3_theta1_dot
    w358 = w354 * c14 + (w118 * (w356 * c14) + w106 * w357)
    w359 = w97 * w110
    w360 = link3_theta1_dot * w359
    w361 = w110 * (w101 * (link3_theta1_dot * w97)) * c40 + w110 * (w105 * (link3_theta1_dot * w99)) * c40
    w362 = link3_theta1_dot * (w97 * w353 + w99 * (w94 * link3_theta2_dot))
    w363 = w118 * (w360 * c14) + w102 * w357 - w362 * c14
    w364 = w120 * (w96 * w99) + w112 * w358 - (w107 * w111 + w96 * w361) + (w131 * (w94 * w122) + w125 * w363)
    w365 = w120 * (w99 * w159) + w161 * w358 - (w107 * w160 + w159 * w361) + (w131 * (w94 * w109) + w163 * w363)
    w366 = w103 * w358 - w120 * w355 - (w94 * w107 - w110 * w361) + (w98 * w363 - w131 * w359)
    w367 = w360 * c24
    w368 = w101 * c24
    w369 = w357 * c26
    w370 = w118 * c26
    w371 = w118 * w367 + w357 * w368 - (w101 * w369 + w360 * w370) + w362 * c27
    w372 = w101 * w370
    w373 = w372 - w118 * w368 - w129 * c27
    w374 = w105 * c23
    w375 = link3_theta1_dot * link3_theta2_dot
    w376 = w356 * c23
    w377 = w101 * w376 + w360 * w374 - (w105 * w367 + w356 * w368) - w110 * w375 * c25
    w378 = w105 * w369 + w356 * w370 - (w118 * w376 + w357 * w374) + w354 * c28
    w379 = w105 * w370
    w380 = w118 * w374 - w379 + w117 * c28
    w381 = w103 * w371 - w355 * w373 - (w94 * (w105 * w368 - w101 * w374 + w94 * w375 * c25) + w110 * w377) + (w98 * w378 - w359 * w380)
    w382 = w97 * w371 - w99 * w378 + w198 * gravity_z + (w172 * (w108 * w201) + w152 * (w95 * w201) - w181 * w198)
    w383 = link3_theta1_dot * (w126 - w100 * w110) - w128
    w384 = w383 * c14 - w130
    w385 = w116 + link3_theta1_dot * (w114 + w97 * w127)
    w386 = w119 - w385 * c14
    w387 = w120 * (w97 * w111 - w124) + w112 * w384 + (w125 * w386 - w131 * (w109 + w110 * w162))
    w388 = w120 * (w162 + w97 * w160) + w161 * w384 + (w131 * (w122 - w110 * w124) + w163 * w386)
    w389 = w98 * w120 + w103 * w384 + (w98 * w386 - w103 * w131)
    w390 = w105 * c24
    w391 = w118 * w390 - w379 + w385 * c27
    w392 = w101 * c23
    w393 = w101 * w368 - w105 * w390 - (w101 * w392 - w105 * w374)
    w394 = w118 * w392 - w372 + w383 * c28
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # link1.theta1
            -(w3 * w46 + w34 * w154 + (w3 * w174 - w34 * w177)),
            w227 - (w3 * w238 + w154 * w229) + (w34 * w243 + w174 * w232),
            w32 * w215 + w31 * w249 - w4 * w251 + (w32 * w253 - w31 * w226) - w3 * w258 - w34 * w262,
            w3 * w269 - w34 * w272, w3 * w302 - w34 * w307, w3 * w340 - w34 * w344, w3 * w164 - w34 * w352,
            w3 * w364 - w34 * w365, w3 * w387 - w34 * w388,
        ),
        ca.horzcat(  # link1.theta2
            w186, w246, w264 + w179 * w258 - w178 * w262, w183 * w275 - w179 * w269 - w178 * w272,
            -(w310 + w178 * w307),
            -(w183 * (w51 * w73 + w56 * w330 + (w51 * w332 - w56 * w84) - w346) + w179 * w340 + w178 * w344),
            -(w164 * w179 + w178 * w352), -(w183 * w366 + w179 * w364 + w178 * w365),
            -(w183 * w389 + w179 * w387 + w178 * w388),
        ),
        ca.horzcat(0.0, w222, w251, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            w147 * w176 - (w44 * w187 - w175 * w188 + w45 * w136),
            w147 * w242 - (w187 * w236 - w188 * w241 + w136 * w237), -(w135 * w256 * c37 + w49 * w260 * c37),
            w93 * w188 + w158 * w187 - (w136 * w268 + w147 * w153) - (w136 * w173 - w147 * w271), w325,
            w51 * w317 + w56 * w348 - w63 * w350 + (w51 * w351 - w56 * w323) - w136 * w339 - w147 * w343,
            w136 * w164 - w147 * w352, w136 * w364 - w147 * w365, w136 * w387 - w147 * w388,
        ),
        ca.horzcat(  # link2.theta2
            w63 * (w44 * w48) * c37 + (w47 * w185 * c37 + w137 * w175 * c37),
            w64 * w236 * c37 + (w47 * w244 * c37 + w137 * w241 * c37),
            w191 * w256 - w190 * w260 + w47 * w263 * c37 + w194 * w257 - w195 * w261, w276, w327,
            w50 * w348 - w52 * w317 - (w50 * w323 + w52 * w351) + w193 * w346 + w194 * w339 - w195 * w343,
            -(w164 * w194 + w195 * w352), -(w193 * w366 + w194 * w364 + w195 * w365),
            -(w193 * w389 + w194 * w387 + w195 * w388),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, w320, w350, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w44 * w196 - w175 * w197), -(w196 * w236 - w197 * w241), -(w196 * w256 + w197 * w260),
            -(w196 * w267 - w197 * w270), -(w196 * w300 - w197 * w305), -(w196 * w338 + w197 * w342),
            w152 * w197 + w172 * w196, w381 - (w172 * (w111 * c14) - w152 * (w160 * c14)),
            w98 * w373 + w103 * w391 - w110 * w393 + (w98 * w394 - w103 * w380),
        ),
        ca.horzcat(  # link3.theta2
            w175 * w199 + w44 * w200 + w185 * w201, w199 * w241 + w200 * w236 + w201 * w244,
            w200 * w256 - w199 * w260 + w201 * w263, w199 * w270 + w200 * w267 + w201 * w274,
            w199 * w305 + w200 * w300 + w201 * w308, w200 * w338 - w199 * w342 + w201 * w345,
            w152 * w199 - w172 * w200, w382, w97 * w391 - w99 * w373 - (w97 * w380 + w99 * w394),
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, w377, w393),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 9 x 9) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    1230 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    link2_end_x = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c37 = c[37]
    c39 = c[39]
    c40 = c[40]
    # intermediate terms (251)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta3)
    w2 = w0 * w1
    w3 = ca.sin(link1_theta2)
    w4 = link1_theta3_dot - link1_theta1_dot * w3
    w5 = w4 * c3
    w6 = ca.cos(link1_theta3)
    w7 = w0 * w6
    w8 = link1_theta1_dot * w7 - w1 * link1_theta2_dot
    w9 = w3 * c3
    w10 = w7 * c1
    w11 = w8 * c1
    w12 = w0 * link1_theta3_dot
    w13 = w6 * w12 - w1 * (w3 * link1_theta2_dot)
    w14 = w5 * w7 - w8 * w9 - (w4 * w10 - w3 * w11) - w13 * c4
    w15 = w6 * link1_theta2_dot
    w16 = w2 * link1_theta1_dot + w15
    w17 = w2 * c0
    w18 = w16 * c0
    w19 = w0 * link1_theta2_dot
    w20 = w10 * w16 + w2 * w11 - (w8 * w17 + w7 * w18) + w19 * c2
    w21 = w1 * w12 + w3 * w15
    w22 = w4 * w17 - w3 * w18 - (w2 * w5 - w9 * w16) + w21 * c5
    w23 = ca.cos(link1_theta1)
    w24 = w0 * w23
    w25 = w24 * link1_end_x
    w26 = w3 * w19 + w2 * w13 - w7 * w21
    w27 = w3 * link1_end_x
    w28 = ca.sin(link1_theta1)
    w29 = w6 * w28
    w30 = w1 * (w3 * w23) - w29
    w31 = w6 * w23
    w32 = w1 * w28 + w3 * w31
    w33 = w13 * w30 - w19 * w24 - w21 * w32
    w34 = w0 * w28
    w35 = link1_theta2_dot * w23 + link1_theta3_dot * w34
    w36 = link1_theta1_dot - link1_theta3_dot * w3
    w37 = w34 * link1_end_x
    w38 = w36 * w37
    w39 = w27 * w35 + w38
    w40 = w25 * w26 + w27 * w33 - (w38 + w39)
    w41 = w40 * link3_mass
    w42 = w40 * link2_mass + w41
    w43 = w25 * w36
    w44 = link1_theta3_dot * w24 - link1_theta2_dot * w28
    w45 = w43 + w27 * w44
    w46 = w31 + w1 * (w3 * w28)
    w47 = w3 * w29 - w1 * w23
    w48 = w13 * w46 - w19 * w34 - w21 * w47
    w49 = w43 + w45 + (w27 * w48 + w26 * w37)
    w50 = w49 * link3_mass
    w51 = w49 * link2_mass + w50
    w52 = w0 * link1_end_x
    w53 = w25 * w44 + w35 * w37 + (w33 * w37 - w25 * w48)
    w54 = w27 * w28
    w55 = w23 * w27
    w56 = ca.cos(link2_theta1)
    w57 = ca.cos(link2_theta2)
    w58 = w56 * w57
    w59 = w58 * c12
    w60 = ca.sin(link2_theta1)
    w61 = w57 * w60
    w62 = w61 * c12
    w63 = w58 * link2_end_x
    w64 = w61 * link2_end_x
    w65 = ca.sin(link2_theta2)
    w66 = w65 * c12
    w67 = w57 * link2_end_x
    w68 = w65 * link2_end_x
    w69 = w60 * w68
    w70 = w56 * w68
    w71 = ca.cos(link3_theta1)
    w72 = ca.cos(link3_theta2)
    w73 = w71 * w72
    w74 = w73 * c14
    w75 = ca.sin(link3_theta1)
    w76 = w72 * w75
    w77 = w76 * c14
    w78 = ca.sin(link3_theta2)
    w79 = w78 * c14
    w80 = w75 * w79
    w81 = w71 * w79
    w82 = w72 * c14
    w83 = w1 * c1
    w84 = link1_theta1_dot * (w1 * w3) + w1 * link1_theta3_dot
    w85 = w4 * w83 - w1 * w5 + w84 * c4
    w86 = w6 * c0
    w87 = w0 * link1_theta1_dot
    w88 = w6 * w11 - w16 * w83 - (w8 * w86 - w1 * w18) + w87 * c2
    w89 = link1_theta1_dot * (w3 * w6) + link1_theta3_dot * w6
    w90 = w4 * w86 - w5 * w6 + w89 * c5
    w91 = w3 * w87 - w2 * w84 - w7 * w89
    w92 = w30 * w84 + w24 * w87 + w32 * w89
    w93 = w37 * w44 - w25 * w35
    w94 = w25 * w91 - w27 * w92 - (w36 * w55 - (w28 * w93 + w44 * w52))
    w95 = w94 * link3_mass
    w96 = w94 * link2_mass + w95
    w97 = w46 * w84 + w34 * w87 + w47 * w89
    w98 = w23 * w93 - w35 * w52 + w36 * w54 - (w37 * w91 - w27 * w97)
    w99 = w98 * link3_mass
    w100 = w98 * link2_mass + w99
    w101 = w23 * w39 + w35 * w55 - (w28 * w45 + w44 * w54) + (w25 * w97 - w37 * w92)
    w102 = w60 * w65
    w103 = w56 * w65
    w104 = w8 * c3 - w11 - w8 * c4
    w105 = w18 - w16 * c3 + w16 * c5
    w106 = w2 * w8 - w7 * w16
    w107 = w8 * w30 - w16 * w32
    w108 = w27 * w34 - w3 * w37
    w109 = w24 * w37 - w25 * w34
    w110 = w25 * w106 + w27 * w107 - (w36 * w108 - w3 * w39 + (w24 * w93 + w44 * w109))
    w111 = w110 * link3_mass
    w112 = w110 * link2_mass + w111
    w113 = w24 * w27 - w3 * w25
    w114 = w8 * w46 - w16 * w47
    w115 = w34 * w93 + w35 * w109 - (w36 * w113 - w3 * w45) - (w27 * w114 + w37 * w106)
    w116 = w115 * link3_mass
    w117 = w115 * link2_mass + w116
    w118 = w24 * w45 + w44 * w113 + (w34 * w39 + w35 * w108) + (w37 * w107 - w25 * w114)
    w119 = ca.cos(link2_theta3)
    w120 = w57 * w119
    w121 = ca.sin(link2_theta3)
    w122 = link2_theta1_dot * w120 - link2_theta2_dot * w121
    w123 = w57 * w121
    w124 = w119 * link2_theta2_dot
    w125 = link2_theta1_dot * w123 + w124
    w126 = w120 * w122 * c39 + w123 * w125 * c39
    w127 = w56 * w119
    w128 = w127 + w102 * w121
    w129 = w57 * link2_theta3_dot
    w130 = w121 * w129 + w65 * w124
    w131 = link2_theta3_dot - w65 * link2_theta1_dot
    w132 = w130 * c12 - (w123 * c12 * w131 - w65 * (w125 * c12))
    w133 = w60 * w119
    w134 = w65 * w133 - w56 * w121
    w135 = w119 * w129 - w121 * (w65 * link2_theta2_dot)
    w136 = w135 * c12 - (w120 * c12 * w131 - w65 * (w122 * c12))
    w137 = w57 * link2_theta2_dot
    w138 = w65 * w137 + w123 * w135 - w120 * w130
    w139 = w103 * w121 - w133
    w140 = w60 * w121 + w65 * w127
    w141 = w135 * w139 - w58 * w137 - w130 * w140
    w142 = w56 * link2_theta2_dot + w61 * link2_theta3_dot
    w143 = link2_theta1_dot - w65 * link2_theta3_dot
    w144 = w64 * w143
    w145 = w68 * w142 + w144
    w146 = w63 * w138 + w68 * w141 - (w144 + w145)
    w147 = w146 * link3_mass
    w148 = w61 * w126 + w128 * w132 + w134 * w136 - w147
    w149 = w63 * w143
    w150 = w58 * link2_theta3_dot - w60 * link2_theta2_dot
    w151 = w149 + w68 * w150
    w152 = w128 * w135 - w61 * w137 - w130 * w134
    w153 = w149 + w151 + (w68 * w152 + w64 * w138)
    w154 = w153 * link3_mass
    w155 = w58 * w126 + w132 * w139 + w136 * w140 + w154
    w156 = w63 * w150 + w64 * w142 + (w64 * w141 - w63 * w152)
    w157 = w156 * link3_mass
    w158 = w131 * c18
    w159 = w65 * c18
    w160 = w120 * c16
    w161 = w122 * c16
    w162 = w120 * w158 - w122 * w159 - (w131 * w160 - w65 * w161) - w135 * c19
    w163 = w123 * c15
    w164 = w125 * c15
    w165 = w125 * w160 + w123 * w161 - (w122 * w163 + w120 * w164) + w137 * c17
    w166 = w131 * w163 - w65 * w164 - (w123 * w158 - w125 * w159) + w130 * c20
    w167 = w119 * w125 * c39 - w121 * w122 * c39
    w168 = link2_theta1_dot * (w65 * w119) + w119 * link2_theta3_dot
    w169 = w168 * c12 - w131 * (w119 * c12)
    w170 = link2_theta1_dot * (w65 * w121) + w121 * link2_theta3_dot
    w171 = w131 * (w121 * c12) - w170 * c12
    w172 = w57 * link2_theta1_dot
    w173 = w65 * w172 - w123 * w170 - w120 * w168
    w174 = w139 * w170 + w58 * w172 + w140 * w168
    w175 = w64 * w150 - w63 * w142
    w176 = w63 * w173 - w68 * w174 - (w70 * w143 - (w60 * w175 + w67 * w150))
    w177 = w176 * link3_mass
    w178 = w61 * w167 + w128 * w169 + w134 * w171 - w177
    w179 = w128 * w170 + w61 * w172 + w134 * w168
    w180 = w56 * w175 - w67 * w142 + w69 * w143 - (w64 * w173 - w68 * w179)
    w181 = w180 * link3_mass
    w182 = w58 * w167 + w139 * w169 + w140 * w171 - w181
    w183 = w56 * w145 + w70 * w142 - (w60 * w151 + w69 * w150) + (w63 * w179 - w64 * w174)
    w184 = w183 * link3_mass
    w185 = w121 * c16
    w186 = w131 * w185 - w121 * w158 + w170 * c19
    w187 = w119 * c15
    w188 = w119 * w161 - w125 * w185 - (w122 * w187 - w121 * w164) + w172 * c17
    w189 = w131 * w187 - w119 * w158 + w168 * c20
    w190 = w122 * w123 - w120 * w125
    w191 = w122 * w139 - w125 * w140
    w192 = w61 * w68 - w64 * w65
    w193 = w58 * w64 - w61 * w63
    w194 = w63 * w190 + w68 * w191 - (w143 * w192 - w65 * w145 + (w58 * w175 + w150 * w193))
    w195 = w194 * link3_mass
    w196 = w58 * w68 - w63 * w65
    w197 = w122 * w128 - w125 * w134
    w198 = w61 * w175 + w142 * w193 - (w143 * w196 - w65 * w151) - (w68 * w197 + w64 * w190)
    w199 = w198 * link3_mass
    w200 = w58 * w151 + w150 * w196 + (w61 * w145 + w142 * w192) + (w64 * w191 - w63 * w197)
    w201 = w200 * link3_mass
    w202 = w122 * c18 - w161 - w122 * c19
    w203 = w164 - w125 * c18 + w125 * c20
    w204 = ca.cos(link3_theta3)
    w205 = w72 * w204
    w206 = ca.sin(link3_theta3)
    w207 = link3_theta1_dot * w205 - link3_theta2_dot * w206
    w208 = w72 * w206
    w209 = w204 * link3_theta2_dot
    w210 = link3_theta1_dot * w208 + w209
    w211 = w205 * w207 * c40 + w208 * w210 * c40
    w212 = w71 * w204
    w213 = w212 + w206 * (w75 * w78)
    w214 = w72 * link3_theta3_dot
    w215 = w206 * w214 + w78 * w209
    w216 = link3_theta3_dot - w78 * link3_theta1_dot
    w217 = w215 * c14 - (w208 * c14 * w216 - w78 * (w210 * c14))
    w218 = w75 * w204
    w219 = w78 * w218 - w71 * w206
    w220 = w204 * w214 - w206 * (w78 * link3_theta2_dot)
    w221 = w220 * c14 - (w205 * c14 * w216 - w78 * (w207 * c14))
    w222 = w76 * w211 + w213 * w217 + w219 * w221
    w223 = w206 * (w71 * w78) - w218
    w224 = w75 * w206 + w78 * w212
    w225 = w73 * w211 + w217 * w223 + w221 * w224
    w226 = w208 * w217 - w78 * w211 + w205 * w221
    w227 = w216 * c26
    w228 = w78 * c26
    w229 = w205 * c24
    w230 = w207 * c24
    w231 = w205 * w227 - w207 * w228 - (w216 * w229 - w78 * w230) - w220 * c27
    w232 = w208 * c23
    w233 = w210 * c23
    w234 = w210 * w229 + w208 * w230 - (w207 * w232 + w205 * w233) + w72 * link3_theta2_dot * c25
    w235 = w216 * w232 - w78 * w233 - (w208 * w227 - w210 * w228) + w215 * c28
    w236 = w204 * w210 * c40 - w206 * w207 * c40
    w237 = link3_theta1_dot * (w78 * w204) + w204 * link3_theta3_dot
    w238 = w237 * c14 - w216 * (w204 * c14)
    w239 = link3_theta1_dot * (w78 * w206) + w206 * link3_theta3_dot
    w240 = w216 * (w206 * c14) - w239 * c14
    w241 = w76 * w236 + w213 * w238 + w219 * w240
    w242 = w73 * w236 + w223 * w238 + w224 * w240
    w243 = w208 * w238 - w78 * w236 + w205 * w240
    w244 = w206 * c24
    w245 = w216 * w244 - w206 * w227 + w239 * c27
    w246 = w204 * c23
    w247 = w204 * w230 - w210 * w244 - (w207 * w246 - w206 * w233) + w72 * link3_theta1_dot * c25
    w248 = w216 * w246 - w204 * w227 + w237 * c28
    w249 = w207 * c26 - w230 - w207 * c27
    w250 = w233 - w210 * c26 + w210 * c28
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # link1.theta1
            w2 * w14 - w3 * w20 + w7 * w22 - w25 * w42 - w37 * w51,
            w2 * w85 - w3 * w88 + w7 * w90 - w25 * w96 + w37 * w100,
            w2 * w104 + w7 * w105 - w25 * w112 + w37 * w117, w25 * w148 - w37 * w155, w25 * w178 - w37 * w182,
            w37 * w199 - w25 * w195, w25 * w222 - w37 * w225, w25 * w241 - w37 * w242, 0.0,
        ),
        ca.horzcat(  # link1.theta2
            w6 * w14 - w1 * w22 + w52 * (w53 * link2_mass + w53 * link3_mass) + w42 * w54 - w51 * w55,
            w6 * w85 - w1 * w90 + w52 * (w101 * link2_mass + w101 * link3_mass) + w54 * w96 + w55 * w100,
            w6 * w104 - w1 * w105 + w52 * (w118 * link2_mass + w118 * link3_mass) + w54 * w112 + w55 * w117,
            -(w52 * (w123 * w132 - w65 * w126 + w120 * w136 - w157) + w54 * w148 + w55 * w155),
            -(w52 * (w123 * w169 - w65 * w167 + w120 * w171 - w184) + w54 * w178 + w55 * w182),
            w52 * w201 + w54 * w195 + w55 * w199, -(w52 * w226 + w54 * w222 + w55 * w225),
            -(w52 * w243 + w54 * w241 + w55 * w242), 0.0,
        ),
        ca.horzcat(w20, w88, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),  # link1.theta3
        ca.horzcat(  # link2.theta1
            -(w57 * (w40 * w56) * c37 + w60 * (w49 * w57) * c37), w64 * w99 - (w59 * w94 - w62 * w98 + w63 * w95),
            w64 * w116 - (w59 * w110 - w62 * w115 + w63 * w111),
            w123 * w162 - w65 * w165 + w120 * w166 - w63 * w147 - w64 * w154,
            w123 * w186 - w65 * w188 + w120 * w189 - w63 * w177 + w64 * w181,
            w123 * w202 + w120 * w203 - w63 * w195 + w64 * w199, w63 * w222 - w64 * w225, w63 * w241 - w64 * w242,
            0.0,
        ),
        ca.horzcat(  # link2.theta2
            w40 * (w60 * w66) - w49 * (w56 * w66) + w53 * w57 * c37 + w41 * w69 - w50 * w70,
            w94 * w102 * c37 + (w57 * w101 * c37 + w98 * w103 * c37),
            w102 * w110 * c37 + (w57 * w118 * c37 + w103 * w115 * c37),
            w119 * w162 - w121 * w166 + w67 * w157 + w69 * w147 - w70 * w154,
            w119 * w186 - w121 * w189 + w67 * w184 + w69 * w177 + w70 * w181,
            w119 * w202 - w121 * w203 + w67 * w201 + w69 * w195 + w70 * w199,
            -(w67 * w226 + w69 * w222 + w70 * w225), -(w67 * w243 + w69 * w241 + w70 * w242), 0.0,
        ),
        ca.horzcat(0.0, 0.0, 0.0, w165, w188, 0.0, 0.0, 0.0, 0.0),  # link2.theta3
        ca.horzcat(  # link3.theta1
            -(w40 * w74 + w49 * w77), -(w74 * w94 - w77 * w98), -(w74 * w110 - w77 * w115),
            -(w74 * w146 + w77 * w153), -(w74 * w176 - w77 * w180), -(w74 * w194 - w77 * w198),
            w208 * w231 - w78 * w234 + w205 * w235, w208 * w245 - w78 * w247 + w205 * w248,
            w208 * w249 + w205 * w250,
        ),
        ca.horzcat(  # link3.theta2
            w40 * w80 - w49 * w81 + w53 * w82, w81 * w98 + w80 * w94 + w82 * w101,
            w81 * w115 + w80 * w110 + w82 * w118, w80 * w146 - w81 * w153 + w82 * w156,
            w81 * w180 + w80 * w176 + w82 * w183, w81 * w198 + w80 * w194 + w82 * w200, w204 * w231 - w206 * w235,
            w204 * w245 - w206 * w248, w204 * w249 - w206 * w250,
        ),
        ca.horzcat(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, w234, w247, 0.0),  # link3.theta3
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot.

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dMa_dq_i (n_i x n_i = 9 x 9) [SI]: total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot
    660 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 9)
    c = ca.SX.sym("c", 50)
    link1_theta1 = q_i[0]
    link1_theta2 = q_i[1]
    link1_theta3 = q_i[2]
    link2_theta1 = q_i[3]
    link2_theta2 = q_i[4]
    link2_theta3 = q_i[5]
    link3_theta1 = q_i[6]
    link3_theta2 = q_i[7]
    link3_theta3 = q_i[8]
    link1_theta1_ddot = q_i_ddot[0]
    link1_theta2_ddot = q_i_ddot[1]
    link1_theta3_ddot = q_i_ddot[2]
    link2_theta1_ddot = q_i_ddot[3]
    link2_theta2_ddot = q_i_ddot[4]
    link2_theta3_ddot = q_i_ddot[5]
    link3_theta1_ddot = q_i_ddot[6]
    link3_theta2_ddot = q_i_ddot[7]
    link3_theta3_ddot = q_i_ddot[8]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    link1_end_x = c[6]
    link2_mass = c[7]
    link3_mass = c[8]
    c12 = c[12]
    link2_end_x = c[13]
    c14 = c[14]
    c17 = c[17]
    c19 = c[19]
    c20 = c[20]
    c25 = c[25]
    c27 = c[27]
    c28 = c[28]
    c37 = c[37]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    # intermediate terms (156)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta1)
    w2 = w0 * w1 * link1_end_x
    w3 = ca.cos(link1_theta1)
    w4 = w0 * w3 * link1_end_x
    w5 = ca.sin(link1_theta2)
    w6 = w5 * link1_end_x
    w7 = w1 * w6
    w8 = link1_theta1_ddot * w4 - link1_theta2_ddot * w7
    w9 = w8 * link2_mass
    w10 = w8 * link3_mass
    w11 = w9 + w10
    w12 = w3 * w6
    w13 = w2 * link1_theta1_ddot + link1_theta2_ddot * w12
    w14 = w13 * link2_mass
    w15 = ca.cos(link2_theta2)
    w16 = ca.sin(link2_theta1)
    w17 = w15 * w16
    w18 = w17 * c12
    w19 = w18 * link2_theta1_ddot
    w20 = ca.cos(link2_theta1)
    w21 = ca.sin(link2_theta2)
    w22 = w21 * c12
    w23 = w20 * w22
    w24 = w23 * link2_theta2_ddot
    w25 = w17 * link2_end_x
    w26 = link2_theta1_ddot * w25
    w27 = w21 * link2_end_x
    w28 = w20 * w27
    w29 = link2_theta2_ddot * w28
    w30 = w13 + w26 + w29
    w31 = ca.cos(link3_theta2)
    w32 = ca.sin(link3_theta1)
    w33 = w31 * w32 * c14
    w34 = w33 * link3_theta1_ddot
    w35 = ca.cos(link3_theta1)
    w36 = ca.sin(link3_theta2)
    w37 = w36 * c14
    w38 = w35 * w37
    w39 = w38 * link3_theta2_ddot
    w40 = w30 * link3_mass + w34 + w39
    w41 = w14 + w19 + w24 + w40
    w42 = w13 * link3_mass
    w43 = w14 + w42
    w44 = w15 * w20
    w45 = w44 * c12
    w46 = link2_theta1_ddot * w45
    w47 = w16 * w22
    w48 = link2_theta2_ddot * w47
    w49 = w44 * link2_end_x
    w50 = link2_theta1_ddot * w49
    w51 = w16 * w27
    w52 = link2_theta2_ddot * w51
    w53 = w8 + w50 - w52
    w54 = w31 * w35 * c14
    w55 = link3_theta1_ddot * w54
    w56 = w32 * w37
    w57 = link3_theta2_ddot * w56
    w58 = w53 * link3_mass + w55 - w57
    w59 = w9 + w46 - w48 + w58
    w60 = w0 * link1_end_x
    w61 = link1_theta2_ddot * w60
    w62 = w15 * c12
    w63 = w15 * link2_end_x
    w64 = w61 + link2_theta2_ddot * w63
    w65 = w31 * c14
    w66 = w64 * link3_mass + link3_theta2_ddot * w65
    w67 = w8 * w18
    w68 = w13 * w45
    w69 = w0 * c2
    w70 = w0 * w5
    w71 = ca.sin(link1_theta3)
    w72 = w0 * w71
    w73 = ca.cos(link1_theta3)
    w74 = w0 * w73
    w75 = w71 * c5
    w76 = w73 * c4
    w77 = w5 * w73 * w75 - w5 * w71 * w76
    w78 = link1_theta1_ddot * (w70 * c41 - w71 * (w70 * w71) * c42 - w73 * (w70 * w73) * c43) + link1_theta2_ddot * w77
    w79 = w3 * w5 * link1_end_x
    w80 = w1 * w60
    w81 = link1_theta1_ddot * w79 + link1_theta2_ddot * w80
    w82 = w81 * link3_mass
    w83 = w81 * link2_mass + w82
    w84 = w3 * w60
    w85 = w1 * w5 * link1_end_x
    w86 = link1_theta2_ddot * w84 - link1_theta1_ddot * w85
    w87 = w86 * link3_mass
    w88 = w86 * link2_mass + w87
    w89 = link1_theta2_ddot * w6
    w90 = w89 * link3_mass
    w91 = link1_theta1_ddot * w77 - (w60 * (w89 * link2_mass + w90) + w6 * (w61 * link2_mass + link2_theta2_ddot * w62 + w66))
    w92 = w73 * (w71 * w0**2)
    w93 = w74 * w76 - w72 * (w71 * c4) - (w74 * (w73 * c5) - w72 * w75)
    w94 = w71 * w73
    w95 = w50 - w52
    w96 = w95 * link3_mass
    w97 = w46 - w48 + w96
    w98 = w26 + w29
    w99 = w98 * link3_mass
    w100 = w19 + w24 + w99
    w101 = w20 * w62
    w102 = w16 * w21
    w103 = w102 * c12
    w104 = w20 * w63
    w105 = w102 * link2_end_x
    w106 = link2_theta2_ddot * w104 - link2_theta1_ddot * w105
    w107 = w106 * link3_mass
    w108 = link2_theta2_ddot * w101 - link2_theta1_ddot * w103 + w107
    w109 = w20 * w21
    w110 = w109 * c12
    w111 = w16 * w62
    w112 = w109 * link2_end_x
    w113 = w16 * w63
    w114 = link2_theta1_ddot * w112 + link2_theta2_ddot * w113
    w115 = w114 * link3_mass
    w116 = link2_theta1_ddot * w110 + link2_theta2_ddot * w111 + w115
    w117 = link2_theta2_ddot * w27
    w118 = w117 * link3_mass
    w119 = w15 * c17
    w120 = w15 * w21
    w121 = ca.sin(link2_theta3)
    w122 = w15 * w121
    w123 = ca.cos(link2_theta3)
    w124 = w15 * w123
    w125 = link2_theta1_ddot * (w120 * c44 - w121 * (w120 * w121) * c45 - w123 * (w120 * w123) * c46) - (w13 * w103 + w8 * w110)
    w126 = w121 * c20
    w127 = w123 * c19
    w128 = w21 * w123 * w126 - w21 * w121 * w127
    w129 = w125 + link2_theta2_ddot * w128 - w119 * link2_theta3_ddot - (w49 * w115 + w58 * w112) + (w25 * w107 - w40 * w105)
    w130 = w13 * w101 - w8 * w111 - w22 * w61 + link2_theta1_ddot * w128 - (w63 * w118 + w27 * w66) - (w58 * w113 - w51 * w115)
    w131 = w123 * (w121 * w15**2)
    w132 = w124 * w127 - w122 * (w121 * c19) - (w124 * (w123 * c20) - w122 * w126)
    w133 = w121 * w123
    w134 = w55 - w57
    w135 = w34 + w39
    w136 = w35 * w65
    w137 = w32 * w36 * c14
    w138 = link3_theta2_ddot * w136 - link3_theta1_ddot * w137
    w139 = w35 * w36 * c14
    w140 = w32 * w65
    w141 = link3_theta1_ddot * w139 + link3_theta2_ddot * w140
    w142 = w37 * link3_theta2_ddot
    w143 = w31 * c25
    w144 = w31 * w36
    w145 = ca.sin(link3_theta3)
    w146 = w31 * w145
    w147 = ca.cos(link3_theta3)
    w148 = w31 * w147
    w149 = link3_theta1_ddot * (w144 * c47 - w145 * (w144 * w145) * c48 - w147 * (w144 * w147) * c49) - (w30 * w137 + w53 * w139)
    w150 = w145 * c28
    w151 = w147 * c27
    w152 = w36 * w147 * w150 - w36 * w145 * w151
    w153 = w147 * (w145 * w31**2)
    w154 = w148 * w151 - w146 * (w145 * c27) - (w148 * (w147 * c28) - w146 * w150)
    w155 = w145 * w147
    # outputs
    dMa_dq_i = ca.SX(9, 9)
    # link1.theta1
    dMa_dq_i[0, 0] = w2 * w11 + w4 * w41 - (w4 * w43 + w2 * w59)
    dMa_dq_i[0, 1] = w78 - w69 * link1_theta3_ddot - (w4 * w83 + w59 * w79) + (w2 * w88 - w41 * w85)
    dMa_dq_i[0, 2] = link1_theta1_ddot * (w92 * c42 - w92 * c43) + link1_theta2_ddot * w93
    dMa_dq_i[0, 3] = w2 * w97 - w4 * w100
    dMa_dq_i[0, 4] = w2 * w108 - w4 * w116
    dMa_dq_i[0, 6] = w2 * w134 - w4 * w135
    dMa_dq_i[0, 7] = w2 * w138 - w4 * w141
    # link1.theta2
    dMa_dq_i[1, 0] = w11 * w12 - w7 * w41 - (w12 * w59 - w7 * w43)
    dMa_dq_i[1, 1] = w91 - (w59 * w80 - w7 * w83) + (w12 * w88 + w41 * w84)
    dMa_dq_i[1, 2] = link1_theta1_ddot * w93 + link1_theta2_ddot * (w94 * c43 - w94 * c42)
    dMa_dq_i[1, 3] = w7 * w100 + w12 * w97
    dMa_dq_i[1, 4] = w7 * w116 - w60 * (w22 * link2_theta2_ddot + w118) + w12 * w108
    dMa_dq_i[1, 6] = w7 * w135 + w12 * w134
    dMa_dq_i[1, 7] = w7 * w141 - w60 * w142 + w12 * w138
    # link1.theta3
    dMa_dq_i[2, 1] = -(link1_theta1_ddot * w69)
    # link2.theta1
    dMa_dq_i[3, 0] = w67 - w68 - w42 * w49 + w10 * w25
    dMa_dq_i[3, 1] = w18 * w86 - w45 * w81 - w49 * w82 + w25 * w87
    dMa_dq_i[3, 3] = w68 - w67 - (w49 * w99 + w25 * w58) + (w25 * w96 + w40 * w49)
    dMa_dq_i[3, 4] = w129
    dMa_dq_i[3, 5] = link2_theta1_ddot * (w131 * c45 - w131 * c46) + link2_theta2_ddot * w132
    dMa_dq_i[3, 6] = w25 * w134 - w49 * w135
    dMa_dq_i[3, 7] = w25 * w138 - w49 * w141
    # link2.theta2
    dMa_dq_i[4, 0] = w21 * (w13 * w16) * c37 + w21 * (w8 * w20) * c37
    dMa_dq_i[4, 1] = w23 * w86 + w47 * w81 - w62 * w89 - w63 * w90 + w51 * w82 + w28 * w87
    dMa_dq_i[4, 3] = w28 * w96 - w40 * w51 - (w8 * w23 + w13 * w47 + (w28 * w58 - w51 * w99))
    dMa_dq_i[4, 4] = w130 + (w28 * w107 + w40 * w104)
    dMa_dq_i[4, 5] = link2_theta1_ddot * w132 + link2_theta2_ddot * (w133 * c46 - w133 * c45)
    dMa_dq_i[4, 6] = w51 * w135 + w28 * w134
    dMa_dq_i[4, 7] = w51 * w141 - w63 * w142 + w28 * w138
    # link2.theta3
    dMa_dq_i[5, 4] = -(link2_theta1_ddot * w119)
    # link3.theta1
    dMa_dq_i[6, 0] = w8 * w33 - w13 * w54
    dMa_dq_i[6, 1] = w33 * w86 - w54 * w81
    dMa_dq_i[6, 3] = w33 * w95 - w54 * w98
    dMa_dq_i[6, 4] = w33 * w106 - w54 * w114
    dMa_dq_i[6, 6] = w30 * w54 - w33 * w53
    dMa_dq_i[6, 7] = w149 + link3_theta2_ddot * w152 - w143 * link3_theta3_ddot
    dMa_dq_i[6, 8] = link3_theta1_ddot * (w153 * c48 - w153 * c49) + link3_theta2_ddot * w154
    # link3.theta2
    dMa_dq_i[7, 0] = w8 * w38 + w13 * w56
    dMa_dq_i[7, 1] = w38 * w86 + w56 * w81 - w65 * w89
    dMa_dq_i[7, 3] = w38 * w95 + w56 * w98
    dMa_dq_i[7, 4] = w38 * w106 + w56 * w114 - w65 * w117
    dMa_dq_i[7, 6] = -(w30 * w56 + w38 * w53)
    dMa_dq_i[7, 7] = w30 * w136 - w53 * w140 - w37 * w64 + link3_theta1_ddot * w152
    dMa_dq_i[7, 8] = link3_theta1_ddot * w154 + link3_theta2_ddot * (w155 * c49 - w155 * c48)
    # link3.theta3
    dMa_dq_i[8, 7] = -(link3_theta1_ddot * w143)
    inputs, outputs = [q_i, q_i_ddot, c], [ca.densify(dMa_dq_i)]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 9) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 9) [mixed]: rates of the independent coordinates
    takes c (n_const = 50) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 9) [mixed]: accelerations of the independent coordinates
    853 operations.
    """
    q_i = ca.SX.sym("q_i", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 9)
    c = ca.SX.sym("c", 50)
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
    c12 = c[12]
    link2_end_x = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    gravity_z = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    # intermediate terms (236)
    w0 = ca.cos(link1_theta2)
    w1 = ca.sin(link1_theta3)
    w2 = w0 * w1
    w3 = ca.sin(link1_theta2)
    w4 = link1_theta3_dot - link1_theta1_dot * w3
    w5 = w4 * c3
    w6 = ca.cos(link1_theta3)
    w7 = w0 * w6
    w8 = link1_theta1_dot * w7 - w1 * link1_theta2_dot
    w9 = w8 * c1
    w10 = w0 * link1_theta3_dot
    w11 = link1_theta3_dot * link1_theta2_dot
    w12 = link1_theta1_dot * (w6 * w10 - w1 * (w3 * link1_theta2_dot)) - w1 * w11
    w13 = w5 * w8 - w4 * w9 - w12 * c4
    w14 = w6 * link1_theta2_dot
    w15 = w2 * link1_theta1_dot + w14
    w16 = w15 * c0
    w17 = w0 * (link1_theta1_dot * link1_theta2_dot)
    w18 = w9 * w15 - w8 * w16 + w17 * c2
    w19 = w3 * w18
    w20 = link1_theta1_dot * (w1 * w10 + w3 * w14) + w6 * w11
    w21 = w4 * w16 - w5 * w15 + w20 * c5
    w22 = ca.cos(link1_theta1)
    w23 = w0 * w22
    w24 = w23 * link1_end_x
    w25 = ca.cos(link2_theta2)
    w26 = ca.sin(link2_theta1)
    w27 = w25 * w26
    w28 = ca.cos(link2_theta3)
    w29 = w25 * w28
    w30 = ca.sin(link2_theta3)
    w31 = link2_theta1_dot * w29 - link2_theta2_dot * w30
    w32 = w31 * c12
    w33 = w25 * w30
    w34 = w28 * link2_theta2_dot
    w35 = link2_theta1_dot * w33 + w34
    w36 = w35 * c12
    w37 = w31 * w32 + w35 * w36
    w38 = ca.cos(link2_theta1)
    w39 = w28 * w38
    w40 = ca.sin(link2_theta2)
    w41 = w39 + w30 * (w26 * w40)
    w42 = w25 * link2_theta3_dot
    w43 = link2_theta2_dot * link2_theta3_dot
    w44 = link2_theta1_dot * (w30 * w42 + w34 * w40) + w28 * w43
    w45 = link2_theta3_dot - link2_theta1_dot * w40
    w46 = w44 * c12 - w36 * w45
    w47 = w26 * w28
    w48 = w40 * w47 - w30 * w38
    w49 = link2_theta1_dot * (w28 * w42 - w30 * (link2_theta2_dot * w40)) - w30 * w43
    w50 = w49 * c12 - w32 * w45
    w51 = ca.cos(link3_theta2)
    w52 = ca.sin(link3_theta1)
    w53 = w51 * w52
    w54 = ca.cos(link3_theta3)
    w55 = w51 * w54
    w56 = ca.sin(link3_theta3)
    w57 = link3_theta1_dot * w55 - link3_theta2_dot * w56
    w58 = w57 * c14
    w59 = w51 * w56
    w60 = w54 * link3_theta2_dot
    w61 = link3_theta1_dot * w59 + w60
    w62 = w61 * c14
    w63 = w57 * w58 + w61 * w62
    w64 = ca.cos(link3_theta1)
    w65 = w54 * w64
    w66 = ca.sin(link3_theta2)
    w67 = w51 * link3_theta3_dot
    w68 = link3_theta2_dot * link3_theta3_dot
    w69 = link3_theta1_dot * (w56 * w67 + w60 * w66) + w54 * w68
    w70 = link3_theta3_dot - link3_theta1_dot * w66
    w71 = w69 * c14 - w62 * w70
    w72 = w52 * w54
    w73 = link3_theta1_dot * (w54 * w67 - w56 * (link3_theta2_dot * w66)) - w56 * w68
    w74 = w73 * c14 - w58 * w70
    w75 = w66 * c14
    w76 = w52 * w75
    w77 = w54 * c27
    w78 = w56 * c28
    w79 = w54 * w77 + w56 * w78
    w80 = w76 / w79
    w81 = w70 * c26
    w82 = w57 * c24
    w83 = w57 * w81 - w70 * w82 - w73 * c27
    w84 = w61 * c23
    w85 = w70 * w84 - w61 * w81 + w69 * c28
    w86 = w51 * w64
    w87 = w51 * c14
    w88 = w54 * w83 - w56 * w85 - w87 * gravity_z
    w89 = w59 * w77 - w55 * w78
    w90 = w86 * c14 + w80 * w89
    w91 = w66 * c25
    w92 = w66 * w91
    w93 = w89 / w79
    w94 = w92 + w59 * (w59 * c27) + w55 * (w55 * c28) - w92 - w89 * w93
    w95 = w90 / w94
    w96 = w61 * w82 - w57 * w84 + w51 * (link3_theta1_dot * link3_theta2_dot) * c25
    w97 = w66 * w96
    w98 = w97 + (w59 * w83 - w97 + w55 * w85) - w88 * w93
    w99 = w53 * w63 + (w65 + w56 * (w52 * w66)) * w71 + (w66 * w72 - w56 * w64) * w74 + w80 * w88 - w95 * w98
    w100 = w87 / w79
    w101 = w89 * w100
    w102 = w80 * w87 + w95 * w101
    w103 = w25 * w38
    w104 = link2_theta3_dot * w103 - w26 * link2_theta2_dot
    w105 = link2_theta1_dot - w40 * link2_theta3_dot
    w106 = w103 * link2_end_x
    w107 = w40 * link2_end_x
    w108 = w105 * w106 + w104 * w107
    w109 = link2_theta2_dot * w38 + w27 * link2_theta3_dot
    w110 = w27 * link2_end_x
    w111 = w107 * w109 + w105 * w110
    w112 = w30 * (w38 * w40) - w47
    w113 = w25 * (link2_theta1_dot * link2_theta2_dot)
    w114 = w26 * w30 + w39 * w40
    w115 = w49 * w112 - w103 * w113 - w44 * w114
    w116 = w41 * w49 - w27 * w113 - w44 * w48
    w117 = w104 * w108 + w109 * w111 + (w110 * w115 - w106 * w116)
    w118 = link3_mass - w76 * w80 - w90 * w95
    w119 = w40 * w113 + w33 * w49 - w29 * w44
    w120 = w104 * w110 - w106 * w109
    w121 = w106 * w119 + w107 * w115 - (w105 * w111 + w104 * w120)
    w122 = w99 + w102 * w117 - w118 * w121
    w123 = w64 * w75
    w124 = w123 / w79
    w125 = w89 * w124 - w53 * c14
    w126 = w125 / w94
    w127 = w76 * w124 + w90 * w126
    w128 = w109 * w120 - w105 * w108 - (w107 * w116 + w110 * w119)
    w129 = w25 * link2_end_x
    w130 = w102 * w129
    w131 = w26 * w107
    w132 = w130 - w118 * w131
    w133 = w40 * c12
    w134 = w38 * w107
    w135 = w132 - w26 * w133 + w127 * w134
    w136 = w28 * c19
    w137 = w30 * c20
    w138 = w101 / w94
    w139 = link3_mass - w87 * w100 - w101 * w138
    w140 = w129 * w139
    w141 = w87 * w124 + w101 * w126
    w142 = w129 * w141 + w127 * w131
    w143 = link3_mass - w123 * w124 - w125 * w126
    w144 = w142 - w134 * w143
    w145 = w28 * w136 + w30 * w137 + w129 * w140 - (w131 * w132 + w130 * w131) - (w134 * w144 + w134 * w142)
    w146 = w135 / w145
    w147 = w45 * c18
    w148 = w31 * c16
    w149 = w31 * w147 - w45 * w148 - w49 * c19
    w150 = w35 * c15
    w151 = w45 * w150 - w35 * w147 + w44 * c20
    w152 = w25 * c12
    w153 = c33 + (w59 * w71 - w63 * w66 + w55 * w74) + w88 * w100 - w98 * w138 - w117 * w139
    w154 = w28 * w149 - w30 * w151 - w152 * gravity_z - w129 * w153 - w121 * w130 - w122 * w131 - w128 * w142
    w155 = w63 * w86 + w71 * (w56 * (w64 * w66) - w72) + w74 * (w52 * w56 + w65 * w66) + w88 * w124 - w98 * w126
    w156 = w155 + w117 * w141 + w121 * w127 - w128 * w143
    w157 = w154 - w134 * w156
    w158 = w106 * w118
    w159 = w106 * w127
    w160 = w33 * w136 - w29 * w137 + w106 * w132 + (w134 * w159 - w110 * w144)
    w161 = w103 * c12 + w158 + w110 * w127 - w146 * w160
    w162 = w40 * c17
    w163 = w40 * w162
    w164 = w159 + w110 * w143
    w165 = w160 / w145
    w166 = w163 + w33 * (w33 * c19) + w29 * (w29 * c20) + w106 * w158 + (w110 * w164 + w110 * w159) - w163 - w160 * w165
    w167 = w161 / w166
    w168 = w35 * w148 - w31 * w150 + w113 * c17
    w169 = w40 * w168
    w170 = w169 + (w33 * w149 - w169 + w29 * w151 + w106 * w122 + w128 * w159 - w110 * w156) - w157 * w165
    w171 = w102 * w131 - (w140 + w152) + w134 * w141
    w172 = w171 / w145
    w173 = w110 * w141 - w102 * w106 - w160 * w172
    w174 = w102 + w146 * w171 + w167 * w173
    w175 = ca.sin(link1_theta1)
    w176 = link1_theta3_dot * w23 - link1_theta2_dot * w175
    w177 = link1_theta1_dot - link1_theta3_dot * w3
    w178 = w3 * link1_end_x
    w179 = w24 * w177 + w176 * w178
    w180 = w0 * w175
    w181 = link1_theta2_dot * w22 + link1_theta3_dot * w180
    w182 = w180 * link1_end_x
    w183 = w178 * w181 + w177 * w182
    w184 = w6 * w175
    w185 = w6 * w22
    w186 = w12 * (w1 * (w3 * w22) - w184) - w17 * w23 - w20 * (w1 * w175 + w3 * w185)
    w187 = w12 * (w185 + w1 * (w3 * w175)) - w17 * w180 - w20 * (w3 * w184 - w1 * w22)
    w188 = w176 * w179 + w181 * w183 + (w182 * w186 - w24 * w187)
    w189 = link2_mass + w118 - w135 * w146 - w161 * w167
    w190 = w3 * w17 + w2 * w12 - w7 * w20
    w191 = w176 * w182 - w24 * w181
    w192 = w24 * w190 + w178 * w186 - (w177 * w183 + w176 * w191)
    w193 = w27 * w37 + w41 * w46 + w48 * w50 + w122 + w127 * w128 - w146 * w157 - w167 * w170 + w174 * w188 - w189 * w192
    w194 = w144 - w38 * w133
    w195 = w194 / w145
    w196 = w27 * c12 + w164 + w160 * w195
    w197 = w196 / w166
    w198 = w161 * w197 - (w127 + w135 * w195)
    w199 = w24 * w198
    w200 = w181 * w191 - w177 * w179 - (w178 * w187 + w182 * w190)
    w201 = w173 * w197 - (w141 + w171 * w195)
    w202 = w156 + (w37 * w103 + w46 * w112 + w50 * w114) - w157 * w195 + w170 * w197 - w188 * w201 - w192 * w198
    w203 = link2_mass + w143 - w194 * w195 - w196 * w197
    w204 = w202 - w200 * w203
    w205 = w6 * c4
    w206 = w1 * c5
    w207 = w0 * link1_end_x
    w208 = w174 * w207
    w209 = w175 * w178
    w210 = w208 - w189 * w209
    w211 = w201 * w207 + w198 * w209
    w212 = w22 * w178
    w213 = w211 + w203 * w212
    w214 = w2 * w205 - w7 * w206 + w24 * w210 + (w182 * w213 - w199 * w212)
    w215 = w173 / w166
    w216 = link2_mass + w139 - w171 * w172 - w173 * w215
    w217 = w6 * w205 + w1 * w206 + w207 * (w207 * w216) - (w209 * w210 + w208 * w209) + (w212 * w213 + w211 * w212)
    w218 = w214 / w217
    w219 = w153 + (c32 + (w33 * w46 - w37 * w40 + w29 * w50)) + w102 * w121 + w128 * w141 - w157 * w172 - w170 * w215
    w220 = w6 * w13 - w1 * w21 - w0 * c31 - w207 * (w219 - w188 * w216) - w192 * w208 - w193 * w209 + w200 * w211
    w221 = w220 - w204 * w212
    w222 = w3 * c2
    w223 = w3 * w222
    w224 = w223 + w2 * (w2 * c4) + w7 * (w7 * c5) + w24 * (w24 * w189) - (w182 * (w199 - w182 * w203) + w182 * w199)
    w225 = (w19 + (w2 * w13 - w19 + w7 * w21 + w24 * w193 - w199 * w200 - w182 * w204) - w218 * w221) / (w224 - w223 - w214 * w218)
    w226 = (w221 - w214 * w225) / w217
    w227 = w192 + (w24 * w225 - w209 * w226)
    w228 = w200 - (w182 * w225 + w212 * w226)
    w229 = w188 - w207 * w226
    w230 = (w170 - (w161 * w227 - w196 * w228 + w173 * w229)) / w166
    w231 = (w157 - (w194 * w228 + w135 * w227 + w171 * w229 + w160 * w230)) / w145
    w232 = w128 + (w228 - w110 * w230 - w134 * w231)
    w233 = w121 + (w227 + w106 * w230 - w131 * w231)
    w234 = w117 + (w229 - w129 * w231)
    w235 = (w98 - (w125 * w232 + w90 * w233 + w101 * w234)) / w94
    # outputs
    q_i_ddot = ca.vertcat(
        w225,  # link1.theta1
        w226,  # link1.theta2
        (w18 + w222 * w225) / c2,  # link1.theta3
        w230,  # link2.theta1
        w231,  # link2.theta2
        (w168 + w162 * w230) / c17,  # link2.theta3
        w235,  # link3.theta1
        (w88 - (w89 * w235 - (w123 * w232 + w76 * w233 + w87 * w234))) / w79,  # link3.theta2
        (w96 + w91 * w235) / c25,  # link3.theta3
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
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
