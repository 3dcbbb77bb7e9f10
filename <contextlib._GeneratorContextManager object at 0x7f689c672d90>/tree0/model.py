"""spherical_tree: equations of motion, emitted by symgen from the scene `spherical_tree`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 body1.turn_x [rad], 1 body1.turn_y [rad], 2 body1.turn_z [rad], 3 body2.turn_x [rad],
    4 body2.turn_y [rad], 5 body2.turn_z [rad], 6 body3.turn_x [rad], 7 body3.turn_y [rad],
    8 body3.turn_z [rad], 9 body4.turn_x [rad], 10 body4.turn_y [rad], 11 body4.turn_z [rad],
    12 body5.turn_x [rad], 13 body5.turn_y [rad], 14 body5.turn_z [rad]

q_d, the dependent coordinates by index:
    0 body1.x [m], 1 body1.y [m], 2 body1.z [m], 3 body1.e0 [1], 4 body1.e1 [1], 5 body1.e2 [1],
    6 body1.e3 [1], 7 body2.x [m], 8 body2.y [m], 9 body2.z [m], 10 body2.e0 [1], 11 body2.e1 [1],
    12 body2.e2 [1], 13 body2.e3 [1], 14 body3.x [m], 15 body3.y [m], 16 body3.z [m], 17 body3.e0 [1],
    18 body3.e1 [1], 19 body3.e2 [1], 20 body3.e3 [1], 21 body4.x [m], 22 body4.y [m], 23 body4.z [m],
    24 body4.e0 [1], 25 body4.e1 [1], 26 body4.e2 [1], 27 body4.e3 [1], 28 body5.x [m], 29 body5.y [m],
    30 body5.z [m], 31 body5.e0 [1], 32 body5.e1 [1], 33 body5.e2 [1], 34 body5.e3 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 51) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 91) [SI]: what depends on p only, computed once a run: c = constants(p)
    311 operations.
    """
    p = ca.SX.sym("p", 51)
    gravity_z = p[0]
    body1_mass = p[1]
    body1_center_of_mass_x = p[2]
    body1_center_of_mass_y = p[3]
    body1_center_of_mass_z = p[4]
    body1_inertia_xx = p[5]
    body1_inertia_yy = p[6]
    body1_inertia_zz = p[7]
    body2_mass = p[8]
    body2_center_of_mass_x = p[9]
    body2_center_of_mass_y = p[10]
    body2_center_of_mass_z = p[11]
    body2_inertia_xx = p[12]
    body2_inertia_yy = p[13]
    body2_inertia_zz = p[14]
    body3_mass = p[15]
    body3_center_of_mass_x = p[16]
    body3_center_of_mass_y = p[17]
    body3_center_of_mass_z = p[18]
    body3_inertia_xx = p[19]
    body3_inertia_yy = p[20]
    body3_inertia_zz = p[21]
    body4_mass = p[22]
    body4_center_of_mass_x = p[23]
    body4_center_of_mass_y = p[24]
    body4_center_of_mass_z = p[25]
    body4_inertia_xx = p[26]
    body4_inertia_yy = p[27]
    body4_inertia_zz = p[28]
    body5_mass = p[29]
    body5_center_of_mass_x = p[30]
    body5_center_of_mass_y = p[31]
    body5_center_of_mass_z = p[32]
    body5_inertia_xx = p[33]
    body5_inertia_yy = p[34]
    body5_inertia_zz = p[35]
    ground_m0_x = p[36]
    ground_m0_y = p[37]
    ground_m0_z = p[38]
    ground_m1_x = p[39]
    ground_m1_y = p[40]
    ground_m1_z = p[41]
    ground_m2_x = p[42]
    ground_m2_y = p[43]
    ground_m2_z = p[44]
    ground_m3_x = p[45]
    ground_m3_y = p[46]
    ground_m3_z = p[47]
    body3_m4_x = p[48]
    body3_m4_y = p[49]
    body3_m4_z = p[50]
    # intermediate terms (38)
    w0 = (body1_inertia_xx + body1_inertia_yy + body1_inertia_zz) / 2.0
    w1 = w0 - body1_inertia_yy + body1_mass * body1_center_of_mass_y**2
    w2 = w0 - body1_inertia_zz + body1_mass * body1_center_of_mass_z**2
    w3 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_x)
    w4 = body1_mass * (body1_center_of_mass_z * body1_center_of_mass_x)
    w5 = w0 - body1_inertia_xx + body1_mass * body1_center_of_mass_x**2
    w6 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_z)
    w7 = (body2_inertia_xx + body2_inertia_yy + body2_inertia_zz) / 2.0
    w8 = w7 - body2_inertia_yy + body2_mass * body2_center_of_mass_y**2
    w9 = w7 - body2_inertia_zz + body2_mass * body2_center_of_mass_z**2
    w10 = body2_mass * (body2_center_of_mass_y * body2_center_of_mass_x)
    w11 = body2_mass * (body2_center_of_mass_z * body2_center_of_mass_x)
    w12 = w7 - body2_inertia_xx + body2_mass * body2_center_of_mass_x**2
    w13 = body2_mass * (body2_center_of_mass_y * body2_center_of_mass_z)
    w14 = (body3_inertia_xx + body3_inertia_yy + body3_inertia_zz) / 2.0
    w15 = body5_mass * body3_m4_y
    w16 = w14 - body3_inertia_yy + body3_mass * body3_center_of_mass_y**2 + body3_m4_y * w15
    w17 = body5_mass * body3_m4_z
    w18 = w14 - body3_inertia_zz + body3_mass * body3_center_of_mass_z**2 + body3_m4_z * w17
    w19 = body5_mass * body3_m4_x
    w20 = body3_mass * (body3_center_of_mass_y * body3_center_of_mass_x) + body3_m4_y * w19
    w21 = body3_mass * (body3_center_of_mass_z * body3_center_of_mass_x) + body3_m4_z * w19
    w22 = w14 - body3_inertia_xx + body3_mass * body3_center_of_mass_x**2 + body3_m4_x * w19
    w23 = body3_mass * (body3_center_of_mass_y * body3_center_of_mass_z) + w15 * body3_m4_z
    w24 = (body4_inertia_xx + body4_inertia_yy + body4_inertia_zz) / 2.0
    w25 = w24 - body4_inertia_yy + body4_mass * body4_center_of_mass_y**2
    w26 = w24 - body4_inertia_zz + body4_mass * body4_center_of_mass_z**2
    w27 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_x)
    w28 = body4_mass * (body4_center_of_mass_z * body4_center_of_mass_x)
    w29 = w24 - body4_inertia_xx + body4_mass * body4_center_of_mass_x**2
    w30 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_z)
    w31 = (body5_inertia_xx + body5_inertia_yy + body5_inertia_zz) / 2.0
    w32 = w31 - body5_inertia_yy + body5_mass * body5_center_of_mass_y**2
    w33 = w31 - body5_inertia_zz + body5_mass * body5_center_of_mass_z**2
    w34 = body5_mass * (body5_center_of_mass_y * body5_center_of_mass_x)
    w35 = body5_mass * (body5_center_of_mass_z * body5_center_of_mass_x)
    w36 = w31 - body5_inertia_xx + body5_mass * body5_center_of_mass_x**2
    w37 = body5_mass * (body5_center_of_mass_y * body5_center_of_mass_z)
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w1 + w2,  # c2
        w3,  # c3
        -w3,  # c4
        w4,  # c5
        -w4,  # c6
        w5,  # c7
        w2 + w5,  # c8
        w6,  # c9
        -w6,  # c10
        w1 + w5,  # c11
        w8,  # c12
        w9,  # c13
        w8 + w9,  # c14
        w10,  # c15
        -w10,  # c16
        w11,  # c17
        -w11,  # c18
        w12,  # c19
        w9 + w12,  # c20
        w13,  # c21
        -w13,  # c22
        w8 + w12,  # c23
        body3_m4_y,  # body3_m4_y
        w16,  # c25
        body3_m4_z,  # body3_m4_z
        w18,  # c27
        w16 + w18,  # c28
        body3_m4_x,  # body3_m4_x
        w20,  # c30
        -w20,  # c31
        w21,  # c32
        -w21,  # c33
        body5_mass * body5_center_of_mass_y,  # c34
        body5_mass * body5_center_of_mass_z,  # c35
        body5_mass * body5_center_of_mass_x,  # c36
        w22,  # c37
        w18 + w22,  # c38
        w23,  # c39
        -w23,  # c40
        w16 + w22,  # c41
        w25,  # c42
        w26,  # c43
        w25 + w26,  # c44
        w27,  # c45
        -w27,  # c46
        w28,  # c47
        -w28,  # c48
        w29,  # c49
        w26 + w29,  # c50
        w30,  # c51
        -w30,  # c52
        w25 + w29,  # c53
        w32,  # c54
        w33,  # c55
        w32 + w33,  # c56
        w34,  # c57
        -w34,  # c58
        w35,  # c59
        -w35,  # c60
        w36,  # c61
        w33 + w36,  # c62
        w37,  # c63
        -w37,  # c64
        w32 + w36,  # c65
        body1_mass * body1_center_of_mass_z,  # c66
        gravity_z,  # gravity_z
        body1_mass * body1_center_of_mass_y,  # c68
        body1_mass * body1_center_of_mass_x,  # c69
        body2_mass * body2_center_of_mass_z,  # c70
        body2_mass * body2_center_of_mass_y,  # c71
        body2_mass * body2_center_of_mass_x,  # c72
        w17 + body3_mass * body3_center_of_mass_z,  # c73
        w15 + body3_mass * body3_center_of_mass_y,  # c74
        w19 + body3_mass * body3_center_of_mass_x,  # c75
        body4_mass * body4_center_of_mass_z,  # c76
        body4_mass * body4_center_of_mass_y,  # c77
        body4_mass * body4_center_of_mass_x,  # c78
        ground_m0_x,  # ground_m0_x
        ground_m0_y,  # ground_m0_y
        ground_m0_z,  # ground_m0_z
        ground_m1_x,  # ground_m1_x
        ground_m1_y,  # ground_m1_y
        ground_m1_z,  # ground_m1_z
        ground_m2_x,  # ground_m2_x
        ground_m2_y,  # ground_m2_y
        ground_m2_z,  # ground_m2_z
        ground_m3_x,  # ground_m3_x
        ground_m3_y,  # ground_m3_y
        ground_m3_z,  # ground_m3_z
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 15) [mixed]: rates of the independent coordinates
    takes c (n_const = 91) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 15 x 15) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 15) [N, N m]: condensed force S^T (Q* - M s)
    941 operations.
    """
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 15)
    c = ca.SX.sym("c", 91)
    body1_e0 = q_d[3]
    body1_e1 = q_d[4]
    body1_e2 = q_d[5]
    body1_e3 = q_d[6]
    body2_e0 = q_d[10]
    body2_e1 = q_d[11]
    body2_e2 = q_d[12]
    body2_e3 = q_d[13]
    body3_e0 = q_d[17]
    body3_e1 = q_d[18]
    body3_e2 = q_d[19]
    body3_e3 = q_d[20]
    body4_e0 = q_d[24]
    body4_e1 = q_d[25]
    body4_e2 = q_d[26]
    body4_e3 = q_d[27]
    body5_e0 = q_d[31]
    body5_e1 = q_d[32]
    body5_e2 = q_d[33]
    body5_e3 = q_d[34]
    body1_omega_x = q_i_dot[0]
    body1_omega_y = q_i_dot[1]
    body1_omega_z = q_i_dot[2]
    body2_omega_x = q_i_dot[3]
    body2_omega_y = q_i_dot[4]
    body2_omega_z = q_i_dot[5]
    body3_omega_x = q_i_dot[6]
    body3_omega_y = q_i_dot[7]
    body3_omega_z = q_i_dot[8]
    body4_omega_x = q_i_dot[9]
    body4_omega_y = q_i_dot[10]
    body4_omega_z = q_i_dot[11]
    body5_omega_x = q_i_dot[12]
    body5_omega_y = q_i_dot[13]
    body5_omega_z = q_i_dot[14]
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
    body3_m4_y = c[24]
    c25 = c[25]
    body3_m4_z = c[26]
    c27 = c[27]
    c28 = c[28]
    body3_m4_x = c[29]
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
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    gravity_z = c[67]
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
    c78 = c[78]
    # intermediate terms (162)
    w0 = 2 * body3_e1
    w1 = w0 * body3_e3
    w2 = 2 * body3_e2
    w3 = w2 * body3_e0
    w4 = w1 + w3
    w5 = 2 * body5_e1
    w6 = w5 * body5_e3
    w7 = 2 * body5_e2
    w8 = w7 * body5_e0
    w9 = w6 + w8
    w10 = w5 * body5_e2
    w11 = 2 * body5_e3
    w12 = body5_e0 * w11
    w13 = w10 - w12
    w14 = w9 * c34 - w13 * c35
    w15 = body3_e3 * w2
    w16 = w0 * body3_e0
    w17 = w15 - w16
    w18 = body5_e3 * w7
    w19 = w5 * body5_e0
    w20 = w18 - w19
    w21 = body5_e1 * w5
    w22 = body5_e3 * w11
    w23 = 1.0 - (w21 + w22)
    w24 = w20 * c34 - w23 * c35
    w25 = body3_e1 * w0
    w26 = body3_e2 * w2
    w27 = 1.0 - (w25 + w26)
    w28 = body5_e2 * w7
    w29 = 1.0 - (w21 + w28)
    w30 = w18 + w19
    w31 = w29 * c34 - w30 * c35
    w32 = w4 * w14 + w17 * w24 + w27 * w31
    w33 = w0 * body3_e2
    w34 = 2 * body3_e3
    w35 = body3_e0 * w34
    w36 = w33 - w35
    w37 = body3_e3 * w34
    w38 = 1.0 - (w25 + w37)
    w39 = w15 + w16
    w40 = w14 * w36 + w24 * w38 + w31 * w39
    w41 = w32 * body3_m4_y - w40 * body3_m4_z
    w42 = 1.0 - (w22 + w28)
    w43 = w42 * c35 - w9 * c36
    w44 = w10 + w12
    w45 = w44 * c35 - w20 * c36
    w46 = w6 - w8
    w47 = w46 * c35 - w29 * c36
    w48 = w4 * w43 + w17 * w45 + w27 * w47
    w49 = w36 * w43 + w38 * w45 + w39 * w47
    w50 = w48 * body3_m4_y - w49 * body3_m4_z
    w51 = w13 * c36 - w42 * c34
    w52 = w23 * c36 - w44 * c34
    w53 = w30 * c36 - w46 * c34
    w54 = w4 * w51 + w17 * w52 + w27 * w53
    w55 = w36 * w51 + w38 * w52 + w39 * w53
    w56 = w54 * body3_m4_y - w55 * body3_m4_z
    w57 = 1.0 - (w26 + w37)
    w58 = w33 + w35
    w59 = w1 - w3
    w60 = w14 * w57 + w24 * w58 + w31 * w59
    w61 = w60 * body3_m4_z - w32 * body3_m4_x
    w62 = w43 * w57 + w45 * w58 + w47 * w59
    w63 = w62 * body3_m4_z - w48 * body3_m4_x
    w64 = w51 * w57 + w52 * w58 + w53 * w59
    w65 = w64 * body3_m4_z - w54 * body3_m4_x
    w66 = w40 * body3_m4_x - w60 * body3_m4_y
    w67 = w49 * body3_m4_x - w62 * body3_m4_y
    w68 = w55 * body3_m4_x - w64 * body3_m4_y
    w69 = 2 * body1_e2
    w70 = 2 * body1_e1
    w71 = (w69 * body1_e3 + w70 * body1_e0) * gravity_z
    w72 = (1.0 - (body1_e1 * w70 + body1_e2 * w69)) * gravity_z
    w73 = body1_omega_x * body1_omega_z
    w74 = body1_omega_z * body1_omega_y
    w75 = body1_omega_x**2
    w76 = body1_omega_y**2
    w77 = w75 + w76
    w78 = body1_omega_x * body1_omega_y
    w79 = body1_omega_z**2
    w80 = w75 + w79
    w81 = (body1_e3 * w70 - w69 * body1_e0) * gravity_z
    w82 = w76 + w79
    w83 = 2 * body2_e2
    w84 = 2 * body2_e1
    w85 = (w83 * body2_e3 + w84 * body2_e0) * gravity_z
    w86 = (1.0 - (body2_e1 * w84 + body2_e2 * w83)) * gravity_z
    w87 = body2_omega_x * body2_omega_z
    w88 = body2_omega_z * body2_omega_y
    w89 = body2_omega_x**2
    w90 = body2_omega_y**2
    w91 = w89 + w90
    w92 = body2_omega_x * body2_omega_y
    w93 = body2_omega_z**2
    w94 = w89 + w93
    w95 = w85 * c70 - w86 * c71 + (w87 * c15 + w88 * c12 - w91 * c21 - (w92 * c17 - w94 * c21 + w88 * c13))
    w96 = (body2_e3 * w84 - w83 * body2_e0) * gravity_z
    w97 = w90 + w93
    w98 = w86 * c72 - w96 * c70 + (w92 * c21 - w97 * c17 + w87 * c13 - (w87 * c19 + w88 * c15 - w91 * c17))
    w99 = w96 * c71 - w85 * c72 + (w92 * c19 - w94 * c15 + w88 * c17 - (w92 * c12 - w97 * c15 + w87 * c21))
    w100 = body5_omega_x * body5_omega_y
    w101 = body5_omega_y**2
    w102 = body5_omega_z**2
    w103 = w101 + w102
    w104 = body5_omega_x * body5_omega_z
    w105 = w100 * c34 - w103 * c36 + w104 * c35
    w106 = body5_omega_x**2
    w107 = w102 + w106
    w108 = body5_omega_y * body5_omega_z
    w109 = w100 * c36 - w107 * c34 + w108 * c35
    w110 = w101 + w106
    w111 = w104 * c36 + w108 * c34 - w110 * c35
    w112 = w42 * w105 + w13 * w109 + w9 * w111
    w113 = w44 * w105 + w23 * w109 + w20 * w111
    w114 = w46 * w105 + w30 * w109 + w29 * w111
    w115 = w4 * w112 + w17 * w113 + w27 * w114
    w116 = w36 * w112 + w38 * w113 + w39 * w114
    w117 = w39 * gravity_z
    w118 = w27 * gravity_z
    w119 = body3_omega_x * body3_omega_z
    w120 = body3_omega_z * body3_omega_y
    w121 = body3_omega_x**2
    w122 = body3_omega_y**2
    w123 = w121 + w122
    w124 = body3_omega_x * body3_omega_y
    w125 = body3_omega_z**2
    w126 = w121 + w125
    w127 = w117 * c73 - w118 * c74 + (w119 * c30 + w120 * c25 - w123 * c39 - (w124 * c32 - w126 * c39 + w120 * c27))
    w128 = w57 * w112 + w58 * w113 + w59 * w114
    w129 = w59 * gravity_z
    w130 = w122 + w125
    w131 = w118 * c75 - w129 * c73 + (w124 * c39 - w130 * c32 + w119 * c27 - (w119 * c37 + w120 * c30 - w123 * c32))
    w132 = w129 * c74 - w117 * c75 + (w124 * c37 - w126 * c30 + w120 * c32 - (w124 * c25 - w130 * c30 + w119 * c39))
    w133 = 2 * body4_e2
    w134 = 2 * body4_e1
    w135 = (w133 * body4_e3 + w134 * body4_e0) * gravity_z
    w136 = (1.0 - (body4_e1 * w134 + body4_e2 * w133)) * gravity_z
    w137 = body4_omega_x * body4_omega_z
    w138 = body4_omega_z * body4_omega_y
    w139 = body4_omega_x**2
    w140 = body4_omega_y**2
    w141 = w139 + w140
    w142 = body4_omega_x * body4_omega_y
    w143 = body4_omega_z**2
    w144 = w139 + w143
    w145 = w135 * c76 - w136 * c77 + (w137 * c45 + w138 * c42 - w141 * c51 - (w142 * c47 - w144 * c51 + w138 * c43))
    w146 = (body4_e3 * w134 - w133 * body4_e0) * gravity_z
    w147 = w140 + w143
    w148 = w136 * c78 - w146 * c76 + (w142 * c51 - w147 * c47 + w137 * c43 - (w137 * c49 + w138 * c45 - w141 * c47))
    w149 = w146 * c77 - w135 * c78 + (w142 * c49 - w144 * c45 + w138 * c47 - (w142 * c42 - w147 * c45 + w137 * c51))
    w150 = w124 * body3_m4_y - w130 * body3_m4_x + w119 * body3_m4_z - w129
    w151 = w124 * body3_m4_x - w126 * body3_m4_y + w120 * body3_m4_z - w117
    w152 = w119 * body3_m4_x + w120 * body3_m4_y - w123 * body3_m4_z - w118
    w153 = w57 * w150 + w36 * w151 + w4 * w152
    w154 = w58 * w150 + w38 * w151 + w17 * w152
    w155 = w59 * w150 + w39 * w151 + w27 * w152
    w156 = w9 * w153 + w20 * w154 + w29 * w155
    w157 = w13 * w153 + w23 * w154 + w30 * w155
    w158 = w156 * c34 - w157 * c35 + (w104 * c57 + w108 * c54 - w110 * c63 - (w100 * c59 - w107 * c63 + w108 * c55))
    w159 = w42 * w153 + w44 * w154 + w46 * w155
    w160 = w159 * c35 - w156 * c36 + (w100 * c63 - w103 * c59 + w104 * c55 - (w104 * c61 + w108 * c57 - w110 * c59))
    w161 = w157 * c36 - w159 * c34 + (w100 * c61 - w107 * c57 + w108 * c59 - (w100 * c54 - w103 * c57 + w104 * c63))
    # outputs
    M_hat = ca.SX(15, 15)
    # body1.turn_x
    M_hat[0, 0] = c2
    M_hat[0, 1] = c4
    M_hat[0, 2] = c6
    # body1.turn_y
    M_hat[1, 0] = c4
    M_hat[1, 1] = c8
    M_hat[1, 2] = c10
    # body1.turn_z
    M_hat[2, 0] = c6
    M_hat[2, 1] = c10
    M_hat[2, 2] = c11
    # body2.turn_x
    M_hat[3, 3] = c14
    M_hat[3, 4] = c16
    M_hat[3, 5] = c18
    # body2.turn_y
    M_hat[4, 3] = c16
    M_hat[4, 4] = c20
    M_hat[4, 5] = c22
    # body2.turn_z
    M_hat[5, 3] = c18
    M_hat[5, 4] = c22
    M_hat[5, 5] = c23
    # body3.turn_x
    M_hat[6, 6] = c28
    M_hat[6, 7] = c31
    M_hat[6, 8] = c33
    M_hat[6, 12] = w41
    M_hat[6, 13] = w50
    M_hat[6, 14] = w56
    # body3.turn_y
    M_hat[7, 6] = c31
    M_hat[7, 7] = c38
    M_hat[7, 8] = c40
    M_hat[7, 12] = w61
    M_hat[7, 13] = w63
    M_hat[7, 14] = w65
    # body3.turn_z
    M_hat[8, 6] = c33
    M_hat[8, 7] = c40
    M_hat[8, 8] = c41
    M_hat[8, 12] = w66
    M_hat[8, 13] = w67
    M_hat[8, 14] = w68
    # body4.turn_x
    M_hat[9, 9] = c44
    M_hat[9, 10] = c46
    M_hat[9, 11] = c48
    # body4.turn_y
    M_hat[10, 9] = c46
    M_hat[10, 10] = c50
    M_hat[10, 11] = c52
    # body4.turn_z
    M_hat[11, 9] = c48
    M_hat[11, 10] = c52
    M_hat[11, 11] = c53
    # body5.turn_x
    M_hat[12, 6] = w41
    M_hat[12, 7] = w61
    M_hat[12, 8] = w66
    M_hat[12, 12] = c56
    M_hat[12, 13] = c58
    M_hat[12, 14] = c60
    # body5.turn_y
    M_hat[13, 6] = w50
    M_hat[13, 7] = w63
    M_hat[13, 8] = w67
    M_hat[13, 12] = c58
    M_hat[13, 13] = c62
    M_hat[13, 14] = c64
    # body5.turn_z
    M_hat[14, 6] = w56
    M_hat[14, 7] = w65
    M_hat[14, 8] = w68
    M_hat[14, 12] = c60
    M_hat[14, 13] = c64
    M_hat[14, 14] = c65
    Q_hat = ca.vertcat(
        -(w71 * c66 - w72 * c68 + (w73 * c3 + w74 * c0 - w77 * c9 - (w78 * c5 - w80 * c9 + w74 * c1))),  # body1.turn_x
        -(w72 * c69 - w81 * c66 + (w78 * c9 - w82 * c5 + w73 * c1 - (w73 * c7 + w74 * c3 - w77 * c5))),  # body1.turn_y
        -(w81 * c68 - w71 * c69 + (w78 * c7 - w80 * c3 + w74 * c5 - (w78 * c0 - w82 * c3 + w73 * c9))),  # body1.turn_z
        -w95,  # body2.turn_x
        -w98,  # body2.turn_y
        -w99,  # body2.turn_z
        -(w115 * body3_m4_y - w116 * body3_m4_z + w127),  # body3.turn_x
        -(w128 * body3_m4_z - w115 * body3_m4_x + w131),  # body3.turn_y
        -(w116 * body3_m4_x - w128 * body3_m4_y + w132),  # body3.turn_z
        -w145,  # body4.turn_x
        -w148,  # body4.turn_y
        -w149,  # body4.turn_z
        -w158,  # body5.turn_x
        -w160,  # body5.turn_y
        -w161,  # body5.turn_z
    )
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_d", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 15) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 20) [1]: unit quaternions from which turns are rotation vectors
    takes c (n_const = 91) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 35) [mixed]: dependent coordinates after one Newton step
    348 operations.
    """
    q_i = ca.SX.sym("q_i", 15)
    chart = ca.SX.sym("chart", 20)
    c = ca.SX.sym("c", 91)
    body1_turn_x = q_i[0]
    body1_turn_y = q_i[1]
    body1_turn_z = q_i[2]
    body2_turn_x = q_i[3]
    body2_turn_y = q_i[4]
    body2_turn_z = q_i[5]
    body3_turn_x = q_i[6]
    body3_turn_y = q_i[7]
    body3_turn_z = q_i[8]
    body4_turn_x = q_i[9]
    body4_turn_y = q_i[10]
    body4_turn_z = q_i[11]
    body5_turn_x = q_i[12]
    body5_turn_y = q_i[13]
    body5_turn_z = q_i[14]
    body1_chart_0 = chart[0]
    body1_chart_1 = chart[1]
    body1_chart_2 = chart[2]
    body1_chart_3 = chart[3]
    body2_chart_0 = chart[4]
    body2_chart_1 = chart[5]
    body2_chart_2 = chart[6]
    body2_chart_3 = chart[7]
    body3_chart_0 = chart[8]
    body3_chart_1 = chart[9]
    body3_chart_2 = chart[10]
    body3_chart_3 = chart[11]
    body4_chart_0 = chart[12]
    body4_chart_1 = chart[13]
    body4_chart_2 = chart[14]
    body4_chart_3 = chart[15]
    body5_chart_0 = chart[16]
    body5_chart_1 = chart[17]
    body5_chart_2 = chart[18]
    body5_chart_3 = chart[19]
    body3_m4_y = c[24]
    body3_m4_z = c[26]
    body3_m4_x = c[29]
    ground_m0_x = c[79]
    ground_m0_y = c[80]
    ground_m0_z = c[81]
    ground_m1_x = c[82]
    ground_m1_y = c[83]
    ground_m1_z = c[84]
    ground_m2_x = c[85]
    ground_m2_y = c[86]
    ground_m2_z = c[87]
    ground_m3_x = c[88]
    ground_m3_y = c[89]
    ground_m3_z = c[90]
    # intermediate terms (46)
    w0 = ca.sqrt((body1_turn_x**2 + body1_turn_y**2 + body1_turn_z**2) / 4.0 + 1e-300)
    w1 = ca.cos(w0)
    w2 = ca.sin(w0) / w0 / 2.0
    w3 = body1_turn_x * w2
    w4 = body1_turn_y * w2
    w5 = body1_turn_z * w2
    w6 = ca.sqrt(1e-300 + (body2_turn_x**2 + body2_turn_y**2 + body2_turn_z**2) / 4.0)
    w7 = ca.cos(w6)
    w8 = ca.sin(w6) / w6 / 2.0
    w9 = body2_turn_x * w8
    w10 = body2_turn_y * w8
    w11 = body2_turn_z * w8
    w12 = ca.sqrt(1e-300 + (body3_turn_x**2 + body3_turn_y**2 + body3_turn_z**2) / 4.0)
    w13 = ca.cos(w12)
    w14 = ca.sin(w12) / w12 / 2.0
    w15 = body3_turn_x * w14
    w16 = body3_turn_y * w14
    w17 = body3_turn_z * w14
    w18 = body3_chart_0 * w13 - (body3_chart_1 * w15 + body3_chart_2 * w16 + body3_chart_3 * w17)
    w19 = body3_chart_0 * w15 + w13 * body3_chart_1 + (body3_chart_2 * w17 - w16 * body3_chart_3)
    w20 = body3_chart_0 * w16 + w13 * body3_chart_2 + (w15 * body3_chart_3 - body3_chart_1 * w17)
    w21 = body3_chart_0 * w17 + w13 * body3_chart_3 + (body3_chart_1 * w16 - w15 * body3_chart_2)
    w22 = ca.sqrt(1e-300 + (body4_turn_x**2 + body4_turn_y**2 + body4_turn_z**2) / 4.0)
    w23 = ca.cos(w22)
    w24 = ca.sin(w22) / w22 / 2.0
    w25 = body4_turn_x * w24
    w26 = body4_turn_y * w24
    w27 = body4_turn_z * w24
    w28 = 2 * w20**2
    w29 = 2 * w21**2
    w30 = 2 * w19
    w31 = w20 * w30
    w32 = 2 * w18
    w33 = w21 * w32
    w34 = w20 * w32
    w35 = w21 * w30
    w36 = ground_m2_x + ((1.0 - w28 - w29) * body3_m4_x + (w31 - w33) * body3_m4_y + (w34 + w35) * body3_m4_z)
    w37 = 1.0 - 2 * w19**2
    w38 = w21 * (2 * w20)
    w39 = w19 * w32
    w40 = ca.sqrt(1e-300 + (body5_turn_x**2 + body5_turn_y**2 + body5_turn_z**2) / 4.0)
    w41 = ca.cos(w40)
    w42 = ca.sin(w40) / w40 / 2.0
    w43 = body5_turn_x * w42
    w44 = body5_turn_y * w42
    w45 = body5_turn_z * w42
    # outputs
    q_d_next = ca.vertcat(
        ground_m0_x,  # body1.x
        ground_m0_y,  # body1.y
        ground_m0_z,  # body1.z
        body1_chart_0 * w1 - (body1_chart_1 * w3 + body1_chart_2 * w4 + body1_chart_3 * w5),  # body1.e0
        body1_chart_0 * w3 + w1 * body1_chart_1 + (body1_chart_2 * w5 - w4 * body1_chart_3),  # body1.e1
        body1_chart_0 * w4 + w1 * body1_chart_2 + (w3 * body1_chart_3 - body1_chart_1 * w5),  # body1.e2
        body1_chart_0 * w5 + w1 * body1_chart_3 + (body1_chart_1 * w4 - w3 * body1_chart_2),  # body1.e3
        ground_m1_x,  # body2.x
        ground_m1_y,  # body2.y
        ground_m1_z,  # body2.z
        body2_chart_0 * w7 - (body2_chart_1 * w9 + body2_chart_2 * w10 + body2_chart_3 * w11),  # body2.e0
        body2_chart_0 * w9 + w7 * body2_chart_1 + (body2_chart_2 * w11 - w10 * body2_chart_3),  # body2.e1
        body2_chart_0 * w10 + w7 * body2_chart_2 + (w9 * body2_chart_3 - body2_chart_1 * w11),  # body2.e2
        body2_chart_0 * w11 + w7 * body2_chart_3 + (body2_chart_1 * w10 - w9 * body2_chart_2),  # body2.e3
        ground_m2_x,  # body3.x
        ground_m2_y,  # body3.y
        ground_m2_z,  # body3.z
        w18,  # body3.e0
        w19,  # body3.e1
        w20,  # body3.e2
        w21,  # body3.e3
        ground_m3_x,  # body4.x
        ground_m3_y,  # body4.y
        ground_m3_z,  # body4.z
        body4_chart_0 * w23 - (body4_chart_1 * w25 + body4_chart_2 * w26 + body4_chart_3 * w27),  # body4.e0
        body4_chart_0 * w25 + w23 * body4_chart_1 + (body4_chart_2 * w27 - w26 * body4_chart_3),  # body4.e1
        body4_chart_0 * w26 + w23 * body4_chart_2 + (w25 * body4_chart_3 - body4_chart_1 * w27),  # body4.e2
        body4_chart_0 * w27 + w23 * body4_chart_3 + (body4_chart_1 * w26 - w25 * body4_chart_2),  # body4.e3
        w36,  # body5.x
        ground_m2_y + ((w31 + w33) * body3_m4_x + (w37 - w29) * body3_m4_y + (w38 - w39) * body3_m4_z),  # body5.y
        ground_m2_z + ((w35 - w34) * body3_m4_x + (w38 + w39) * body3_m4_y + (w37 - w28) * body3_m4_z),  # body5.z
        body5_chart_0 * w41 - (body5_chart_1 * w43 + body5_chart_2 * w44 + body5_chart_3 * w45),  # body5.e0
        body5_chart_0 * w43 + w41 * body5_chart_1 + (body5_chart_2 * w45 - w44 * body5_chart_3),  # body5.e1
        body5_chart_0 * w44 + w41 * body5_chart_2 + (w43 * body5_chart_3 - body5_chart_1 * w45),  # body5.e2
        body5_chart_0 * w45 + w41 * body5_chart_3 + (body5_chart_1 * w44 - w43 * body5_chart_2),  # body5.e3
    )
    inputs, outputs = [q_i, chart, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 15) [mixed]: rates of the independent coordinates
    takes c (n_const = 91) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 35) [mixed]: rates of the dependent coordinates
    298 operations.
    """
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 15)
    c = ca.SX.sym("c", 91)
    body1_e0 = q_d[3]
    body1_e1 = q_d[4]
    body1_e2 = q_d[5]
    body1_e3 = q_d[6]
    body2_e0 = q_d[10]
    body2_e1 = q_d[11]
    body2_e2 = q_d[12]
    body2_e3 = q_d[13]
    body3_e0 = q_d[17]
    body3_e1 = q_d[18]
    body3_e2 = q_d[19]
    body3_e3 = q_d[20]
    body4_e0 = q_d[24]
    body4_e1 = q_d[25]
    body4_e2 = q_d[26]
    body4_e3 = q_d[27]
    body5_e0 = q_d[31]
    body5_e1 = q_d[32]
    body5_e2 = q_d[33]
    body5_e3 = q_d[34]
    body1_omega_x = q_i_dot[0]
    body1_omega_y = q_i_dot[1]
    body1_omega_z = q_i_dot[2]
    body2_omega_x = q_i_dot[3]
    body2_omega_y = q_i_dot[4]
    body2_omega_z = q_i_dot[5]
    body3_omega_x = q_i_dot[6]
    body3_omega_y = q_i_dot[7]
    body3_omega_z = q_i_dot[8]
    body4_omega_x = q_i_dot[9]
    body4_omega_y = q_i_dot[10]
    body4_omega_z = q_i_dot[11]
    body5_omega_x = q_i_dot[12]
    body5_omega_y = q_i_dot[13]
    body5_omega_z = q_i_dot[14]
    body3_m4_y = c[24]
    body3_m4_z = c[26]
    body3_m4_x = c[29]
    # intermediate terms (52)
    w0 = body1_e1 * 0.5
    w1 = body1_e2 * 0.5
    w2 = body1_e3 * 0.5
    w3 = body1_e0 * 0.5
    w4 = body2_e1 * 0.5
    w5 = body2_e2 * 0.5
    w6 = body2_e3 * 0.5
    w7 = body2_e0 * 0.5
    w8 = body3_e1 * 0.5
    w9 = body3_e2 * 0.5
    w10 = body3_e3 * 0.5
    w11 = w8 * body3_omega_x + w9 * body3_omega_y + w10 * body3_omega_z
    w12 = body3_e0 * 0.5
    w13 = body3_omega_x * w12 - body3_omega_y * w10 + w9 * body3_omega_z
    w14 = body3_omega_x * w10 + body3_omega_y * w12 - w8 * body3_omega_z
    w15 = w8 * body3_omega_y - body3_omega_x * w9 + body3_omega_z * w12
    w16 = body4_e1 * 0.5
    w17 = body4_e2 * 0.5
    w18 = body4_e3 * 0.5
    w19 = body4_e0 * 0.5
    w20 = 2 * body3_e3
    w21 = 2 * body3_e1
    w22 = body3_e3 * w21
    w23 = 2 * body3_e0
    w24 = body3_e2 * w23
    w25 = body3_e1 * w23
    w26 = 2 * body3_e2
    w27 = body3_e3 * w26
    w28 = 1.0 - 2 * body3_e1**2
    w29 = 2 * body3_e2**2
    w30 = (w22 - w24) * body3_m4_x + (w25 + w27) * body3_m4_y + (w28 - w29) * body3_m4_z
    w31 = body3_e2 * -2.0
    w32 = body3_e3 * w23
    w33 = body3_e2 * w21
    w34 = 2 * body3_e3**2
    w35 = (w32 + w33) * body3_m4_x + (w28 - w34) * body3_m4_y + (w27 - w25) * body3_m4_z
    w36 = body3_e3 * -2.0
    w37 = w35 * w36
    w38 = w23 * w30
    w39 = body3_e1 * -2.0
    w40 = w30 * w39
    w41 = w23 * w35
    w42 = w13 * (w20 * w30 - w31 * w35) - w11 * (w30 * w31 - w37) + w14 * (w38 - w21 * w35) + w15 * (w40 - w41)
    w43 = (1.0 - w29 - w34) * body3_m4_x + (w33 - w32) * body3_m4_y + (w22 + w24) * body3_m4_z
    w44 = w31 * w43
    w45 = w23 * w43
    w46 = w13 * (w44 - w38) - w11 * (w36 * w43 - w40) + w14 * (w21 * w43 - w30 * w36) + w15 * (w45 - w26 * w30)
    w47 = w13 * (w41 - w20 * w43) - w11 * (w35 * w39 - w44) + w14 * (w37 - w45) + w15 * (w26 * w35 - w39 * w43)
    w48 = body5_e1 * 0.5
    w49 = body5_e2 * 0.5
    w50 = body5_e3 * 0.5
    w51 = body5_e0 * 0.5
    # outputs
    q_d_dot = ca.SX(35, 1)
    q_d_dot[3] = -(w0 * body1_omega_x + w1 * body1_omega_y + w2 * body1_omega_z)  # body1.e0
    q_d_dot[4] = body1_omega_x * w3 - body1_omega_y * w2 + w1 * body1_omega_z  # body1.e1
    q_d_dot[5] = body1_omega_x * w2 + body1_omega_y * w3 - w0 * body1_omega_z  # body1.e2
    q_d_dot[6] = w0 * body1_omega_y - body1_omega_x * w1 + body1_omega_z * w3  # body1.e3
    q_d_dot[10] = -(w4 * body2_omega_x + w5 * body2_omega_y + w6 * body2_omega_z)  # body2.e0
    q_d_dot[11] = body2_omega_x * w7 - body2_omega_y * w6 + w5 * body2_omega_z  # body2.e1
    q_d_dot[12] = body2_omega_x * w6 + body2_omega_y * w7 - w4 * body2_omega_z  # body2.e2
    q_d_dot[13] = w4 * body2_omega_y - body2_omega_x * w5 + body2_omega_z * w7  # body2.e3
    q_d_dot[17] = -w11  # body3.e0
    q_d_dot[18] = w13  # body3.e1
    q_d_dot[19] = w14  # body3.e2
    q_d_dot[20] = w15  # body3.e3
    q_d_dot[24] = -(w16 * body4_omega_x + w17 * body4_omega_y + w18 * body4_omega_z)  # body4.e0
    q_d_dot[25] = body4_omega_x * w19 - body4_omega_y * w18 + w17 * body4_omega_z  # body4.e1
    q_d_dot[26] = body4_omega_x * w18 + body4_omega_y * w19 - w16 * body4_omega_z  # body4.e2
    q_d_dot[27] = w16 * body4_omega_y - body4_omega_x * w17 + body4_omega_z * w19  # body4.e3
    q_d_dot[28] = w42  # body5.x
    q_d_dot[29] = w46  # body5.y
    q_d_dot[30] = w47  # body5.z
    q_d_dot[31] = -(w48 * body5_omega_x + w49 * body5_omega_y + w50 * body5_omega_z)  # body5.e0
    q_d_dot[32] = body5_omega_x * w51 - body5_omega_y * w50 + w49 * body5_omega_z  # body5.e1
    q_d_dot[33] = body5_omega_x * w50 + body5_omega_y * w51 - w48 * body5_omega_z  # body5.e2
    q_d_dot[34] = w48 * body5_omega_y - body5_omega_x * w49 + body5_omega_z * w51  # body5.e3
    inputs, outputs = [q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_d", "q_i_dot", "c"], ["q_d_dot"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "closure": closure,
    "velocities": velocities,
}
