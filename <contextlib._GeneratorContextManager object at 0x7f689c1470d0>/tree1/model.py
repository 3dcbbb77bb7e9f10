"""spherical_tree: equations of motion, emitted by symgen from the scene `spherical_tree`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 j2.angle [rad], 1 body1.turn_x [rad], 2 body1.turn_y [rad], 3 body1.turn_z [rad],
    4 body2.turn_x [rad], 5 body2.turn_y [rad], 6 body2.turn_z [rad], 7 body4.turn_x [rad],
    8 body4.turn_y [rad], 9 body4.turn_z [rad], 10 body5.turn_x [rad], 11 body5.turn_y [rad],
    12 body5.turn_z [rad]

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

    takes p (n_p = 64) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 98) [SI]: what depends on p only, computed once a run: c = constants(p)
    430 operations.
    """
    p = ca.SX.sym("p", 64)
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
    body1_m1_x = p[39]
    body1_m1_y = p[40]
    body1_m1_z = p[41]
    body2_m2_axes_0_0_0_0 = p[42]
    body2_m2_axes_0_2_0_0 = p[44]
    body2_m2_axes_1_0_0_0 = p[45]
    body2_m2_axes_1_2_0_0 = p[47]
    body2_m2_axes_2_0_0_0 = p[48]
    body2_m2_axes_2_2_0_0 = p[50]
    body2_m2_quaternion_0_0_0 = p[51]
    body2_m2_quaternion_1_0_0 = p[52]
    body2_m2_quaternion_2_0_0 = p[53]
    body2_m2_quaternion_3_0_0 = p[54]
    body2_m2_x = p[55]
    body2_m2_y = p[56]
    body2_m2_z = p[57]
    ground_m3_x = p[58]
    ground_m3_y = p[59]
    ground_m3_z = p[60]
    body4_m4_x = p[61]
    body4_m4_y = p[62]
    body4_m4_z = p[63]
    # intermediate terms (62)
    w0 = (body3_inertia_xx + body3_inertia_yy + body3_inertia_zz) / 2.0
    w1 = w0 - body3_inertia_xx + body3_mass * body3_center_of_mass_x**2
    w2 = w0 - body3_inertia_yy + body3_mass * body3_center_of_mass_y**2
    w3 = w1 + w2
    w4 = ca.sqrt(body2_m2_axes_0_2_0_0**2 + body2_m2_axes_1_2_0_0**2)
    w5 = body2_m2_axes_1_2_0_0 / w4
    w6 = body2_m2_axes_0_2_0_0 / w4
    w7 = body2_m2_axes_0_0_0_0 * (body2_m2_axes_2_2_0_0 * w6) + body2_m2_axes_1_0_0_0 * (w5 * body2_m2_axes_2_2_0_0)
    w8 = ca.atan2(w4 * body2_m2_axes_2_0_0_0 - w7, w6 * body2_m2_axes_1_0_0_0 - w5 * body2_m2_axes_0_0_0_0)
    w9 = body3_mass * body3_center_of_mass_y
    w10 = body3_mass * body3_center_of_mass_x
    w11 = body3_mass * (body3_center_of_mass_x * body3_center_of_mass_z)
    w12 = (w6 * body2_m2_x + w5 * body2_m2_y) / w4
    w13 = body3_mass * (body3_center_of_mass_y * body3_center_of_mass_z)
    w14 = w6 * body2_m2_y - w5 * body2_m2_x
    w15 = body2_m2_z - body2_m2_axes_2_2_0_0 * w12
    w16 = (body1_inertia_xx + body1_inertia_yy + body1_inertia_zz) / 2.0
    w17 = body3_mass + body2_mass
    w18 = body1_m1_y * w17
    w19 = w16 - body1_inertia_yy + body1_mass * body1_center_of_mass_y**2 + body1_m1_y * w18
    w20 = body1_m1_z * w17
    w21 = w16 - body1_inertia_zz + body1_mass * body1_center_of_mass_z**2 + body1_m1_z * w20
    w22 = body1_m1_x * w17
    w23 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_x) + body1_m1_y * w22
    w24 = body1_mass * (body1_center_of_mass_z * body1_center_of_mass_x) + body1_m1_z * w22
    w25 = body3_mass * w14
    w26 = body3_mass * body3_center_of_mass_z
    w27 = w26 + body3_mass * w12
    w28 = w4 * w27
    w29 = body2_m2_axes_2_2_0_0 * w27
    w30 = w29 + body3_mass * w15
    w31 = w16 - body1_inertia_xx + body1_mass * body1_center_of_mass_x**2 + body1_m1_x * w22
    w32 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_z) + body1_m1_z * w18
    w33 = body3_mass * (body3_center_of_mass_x * body3_center_of_mass_y)
    w34 = (body2_inertia_xx + body2_inertia_yy + body2_inertia_zz) / 2.0
    w35 = w0 - body3_inertia_zz + body3_mass * body3_center_of_mass_z**2 + (w12 * w26 + w12 * w27)
    w36 = w4 * w35
    w37 = w4 * w36
    w38 = w14 * w25
    w39 = w14 * w28
    w40 = w6 * (w38 - w37) - w5 * (2 * -w39)
    w41 = w6 * w40
    w42 = w34 - body2_inertia_zz + body2_mass * body2_center_of_mass_z**2 + (w35 - w37 + (w15 * w29 + w15 * w30))
    w43 = body2_m2_axes_2_2_0_0 * w36 + w15 * w28
    w44 = w14 * w29 + w15 * w25
    w45 = (body4_inertia_xx + body4_inertia_yy + body4_inertia_zz) / 2.0
    w46 = body5_mass * body4_m4_y
    w47 = w45 - body4_inertia_yy + body4_mass * body4_center_of_mass_y**2 + body4_m4_y * w46
    w48 = body5_mass * body4_m4_z
    w49 = w45 - body4_inertia_zz + body4_mass * body4_center_of_mass_z**2 + body4_m4_z * w48
    w50 = body5_mass * body4_m4_x
    w51 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_x) + body4_m4_y * w50
    w52 = body4_mass * (body4_center_of_mass_z * body4_center_of_mass_x) + body4_m4_z * w50
    w53 = w45 - body4_inertia_xx + body4_mass * body4_center_of_mass_x**2 + body4_m4_x * w50
    w54 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_z) + w46 * body4_m4_z
    w55 = (body5_inertia_xx + body5_inertia_yy + body5_inertia_zz) / 2.0
    w56 = w55 - body5_inertia_yy + body5_mass * body5_center_of_mass_y**2
    w57 = w55 - body5_inertia_zz + body5_mass * body5_center_of_mass_z**2
    w58 = body5_mass * (body5_center_of_mass_y * body5_center_of_mass_x)
    w59 = body5_mass * (body5_center_of_mass_z * body5_center_of_mass_x)
    w60 = w55 - body5_inertia_xx + body5_mass * body5_center_of_mass_x**2
    w61 = body5_mass * (body5_center_of_mass_y * body5_center_of_mass_z)
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w3,  # c2
        body1_m1_y,  # body1_m1_y
        w4,  # c4
        w5,  # c5
        body2_m2_axes_2_2_0_0,  # body2_m2_axes_2_2_0_0
        w6,  # c7
        w8,  # c8
        w9,  # c9
        w10,  # c10
        body1_m1_z,  # body1_m1_z
        body1_m1_x,  # body1_m1_x
        w11,  # c13
        w12,  # c14
        w11 + w10 * w12,  # c15
        w13,  # c16
        w13 + w9 * w12,  # c17
        w3 * w4,  # c18
        w14,  # c19
        w15,  # c20
        w3 * body2_m2_axes_2_2_0_0,  # c21
        w19,  # c22
        w21,  # c23
        w19 + w21,  # c24
        w23,  # c25
        -w23,  # c26
        w24,  # c27
        -w24,  # c28
        body2_mass * body2_center_of_mass_y + (w6 * w25 + w5 * w28),  # c29
        body2_mass * body2_center_of_mass_z + w30,  # c30
        body2_mass * body2_center_of_mass_x + (w6 * w28 - w5 * w25),  # c31
        w31,  # c32
        w21 + w31,  # c33
        w32,  # c34
        -w32,  # c35
        w19 + w31,  # c36
        w1 - w2,  # c37
        w33,  # c38
        2 * w33,  # c39
        2 * w14,  # c40
        w34 - body2_inertia_yy + body2_mass * body2_center_of_mass_y**2 + (w37 + w41),  # c41
        2 * w15,  # c42
        w42,  # c43
        body2_mass * (body2_center_of_mass_y * body2_center_of_mass_x) + (w39 - w5 * w40),  # c44
        body2_mass * (body2_center_of_mass_z * body2_center_of_mass_x) + (w6 * w43 - w5 * w44),  # c45
        w34 - body2_inertia_xx + body2_mass * body2_center_of_mass_x**2 + (w38 - w41),  # c46
        body2_mass * (body2_center_of_mass_y * body2_center_of_mass_z) + (w6 * w44 + w5 * w43),  # c47
        body4_m4_y,  # body4_m4_y
        w47,  # c49
        body4_m4_z,  # body4_m4_z
        w49,  # c51
        w47 + w49,  # c52
        body4_m4_x,  # body4_m4_x
        w51,  # c54
        -w51,  # c55
        w52,  # c56
        -w52,  # c57
        body5_mass * body5_center_of_mass_y,  # c58
        body5_mass * body5_center_of_mass_z,  # c59
        body5_mass * body5_center_of_mass_x,  # c60
        w53,  # c61
        w49 + w53,  # c62
        w54,  # c63
        -w54,  # c64
        w47 + w53,  # c65
        w56,  # c66
        w57,  # c67
        w56 + w57,  # c68
        w58,  # c69
        -w58,  # c70
        w59,  # c71
        -w59,  # c72
        w60,  # c73
        w57 + w60,  # c74
        w61,  # c75
        -w61,  # c76
        w56 + w60,  # c77
        gravity_z,  # gravity_z
        w20 + body1_mass * body1_center_of_mass_z,  # c79
        w18 + body1_mass * body1_center_of_mass_y,  # c80
        w22 + body1_mass * body1_center_of_mass_x,  # c81
        w48 + body4_mass * body4_center_of_mass_z,  # c82
        w46 + body4_mass * body4_center_of_mass_y,  # c83
        w50 + body4_mass * body4_center_of_mass_x,  # c84
        body2_m2_x,  # body2_m2_x
        body2_m2_y,  # body2_m2_y
        body2_m2_z,  # body2_m2_z
        ground_m0_x,  # ground_m0_x
        ground_m0_y,  # ground_m0_y
        ground_m0_z,  # ground_m0_z
        body2_m2_quaternion_0_0_0,  # body2_m2_quaternion_0_0_0
        body2_m2_quaternion_3_0_0,  # body2_m2_quaternion_3_0_0
        body2_m2_quaternion_1_0_0,  # body2_m2_quaternion_1_0_0
        body2_m2_quaternion_2_0_0,  # body2_m2_quaternion_2_0_0
        ground_m3_x,  # ground_m3_x
        ground_m3_y,  # ground_m3_y
        ground_m3_z,  # ground_m3_z
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 13) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 13) [mixed]: rates of the independent coordinates
    takes c (n_const = 98) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 13 x 13) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 13) [N, N m]: condensed force S^T (Q* - M s)
    1369 operations.
    """
    q_i = ca.SX.sym("q_i", 13)
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 13)
    c = ca.SX.sym("c", 98)
    j2_angle = q_i[0]
    body1_e0 = q_d[3]
    body1_e1 = q_d[4]
    body1_e2 = q_d[5]
    body1_e3 = q_d[6]
    body2_e0 = q_d[10]
    body2_e1 = q_d[11]
    body2_e2 = q_d[12]
    body2_e3 = q_d[13]
    body4_e0 = q_d[24]
    body4_e1 = q_d[25]
    body4_e2 = q_d[26]
    body4_e3 = q_d[27]
    body5_e0 = q_d[31]
    body5_e1 = q_d[32]
    body5_e2 = q_d[33]
    body5_e3 = q_d[34]
    j2_angle_dot = q_i_dot[0]
    body1_omega_x = q_i_dot[1]
    body1_omega_y = q_i_dot[2]
    body1_omega_z = q_i_dot[3]
    body2_omega_x = q_i_dot[4]
    body2_omega_y = q_i_dot[5]
    body2_omega_z = q_i_dot[6]
    body4_omega_x = q_i_dot[7]
    body4_omega_y = q_i_dot[8]
    body4_omega_z = q_i_dot[9]
    body5_omega_x = q_i_dot[10]
    body5_omega_y = q_i_dot[11]
    body5_omega_z = q_i_dot[12]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    body1_m1_y = c[3]
    c4 = c[4]
    c5 = c[5]
    body2_m2_axes_2_2_0_0 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    body1_m1_z = c[11]
    body1_m1_x = c[12]
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
    c47 = c[47]
    body4_m4_y = c[48]
    c49 = c[49]
    body4_m4_z = c[50]
    c51 = c[51]
    c52 = c[52]
    body4_m4_x = c[53]
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
    gravity_z = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    # intermediate terms (320)
    w0 = 2 * body1_e1
    w1 = w0 * body1_e3
    w2 = 2 * body1_e2
    w3 = w2 * body1_e0
    w4 = w1 + w3
    w5 = 2 * body2_e2
    w6 = body2_e2 * w5
    w7 = 2 * body2_e3
    w8 = body2_e3 * w7
    w9 = 1.0 - (w6 + w8)
    w10 = j2_angle + c8
    w11 = ca.cos(w10)
    w12 = ca.sin(w10)
    w13 = w11 * c9 + w12 * c10
    w14 = w11 * c10 - w12 * c9
    w15 = w14 * body2_m2_axes_2_2_0_0
    w16 = w13 * c5 - w15 * c7
    w17 = 2 * body2_e1
    w18 = body2_e2 * w17
    w19 = w7 * body2_e0
    w20 = w18 - w19
    w21 = w13 * c7 + w15 * c5
    w22 = body2_e3 * w17
    w23 = w5 * body2_e0
    w24 = w22 + w23
    w25 = w14 * c4
    w26 = w9 * w16 - w20 * w21 + w24 * w25
    w27 = body1_e3 * w2
    w28 = w0 * body1_e0
    w29 = w27 - w28
    w30 = w18 + w19
    w31 = body2_e1 * w17
    w32 = 1.0 - (w8 + w31)
    w33 = w5 * body2_e3
    w34 = w17 * body2_e0
    w35 = w33 - w34
    w36 = w16 * w30 - w21 * w32 + w25 * w35
    w37 = body1_e1 * w0
    w38 = body1_e2 * w2
    w39 = 1.0 - (w37 + w38)
    w40 = w22 - w23
    w41 = w33 + w34
    w42 = 1.0 - (w6 + w31)
    w43 = w16 * w40 - w21 * w41 + w25 * w42
    w44 = w4 * w26 + w29 * w36 + w39 * w43
    w45 = w0 * body1_e2
    w46 = 2 * body1_e3
    w47 = body1_e0 * w46
    w48 = w45 - w47
    w49 = body1_e3 * w46
    w50 = 1.0 - (w37 + w49)
    w51 = w27 + w28
    w52 = w26 * w48 + w36 * w50 + w43 * w51
    w53 = w44 * body1_m1_y - w52 * body1_m1_z
    w54 = 1.0 - (w38 + w49)
    w55 = w45 + w47
    w56 = w1 - w3
    w57 = w26 * w54 + w36 * w55 + w43 * w56
    w58 = w57 * body1_m1_z - w44 * body1_m1_x
    w59 = w52 * body1_m1_x - w57 * body1_m1_y
    w60 = w12 * c15 + w11 * c17
    w61 = w60 * body2_m2_axes_2_2_0_0 + c18 + w25 * c19 + w13 * c20
    w62 = w12 * c17
    w63 = w11 * c15
    w64 = w62 - w63 - w15 * c20
    w65 = w61 * c7 - w64 * c5
    w66 = w64 * c7 + w61 * c5
    w67 = c21 - w60 * c4 + w15 * c19
    w68 = w13 * body2_m2_axes_2_2_0_0
    w69 = w14 * c7 - w68 * c5 + c29
    w70 = w13 * c4
    w71 = w70 + c30
    w72 = w24 * w69 - w20 * w71
    w73 = w35 * w69 - w32 * w71
    w74 = w42 * w69 - w41 * w71
    w75 = w4 * w72 + w29 * w73 + w39 * w74
    w76 = w48 * w72 + w50 * w73 + w51 * w74
    w77 = w75 * body1_m1_y - w76 * body1_m1_z
    w78 = c31 - (w14 * c5 + w68 * c7)
    w79 = w9 * w71 - w24 * w78
    w80 = w30 * w71 - w35 * w78
    w81 = w40 * w71 - w42 * w78
    w82 = w4 * w79 + w29 * w80 + w39 * w81
    w83 = w48 * w79 + w50 * w80 + w51 * w81
    w84 = w82 * body1_m1_y - w83 * body1_m1_z
    w85 = w20 * w78 - w9 * w69
    w86 = w32 * w78 - w30 * w69
    w87 = w41 * w78 - w40 * w69
    w88 = w4 * w85 + w29 * w86 + w39 * w87
    w89 = w48 * w85 + w50 * w86 + w51 * w87
    w90 = w88 * body1_m1_y - w89 * body1_m1_z
    w91 = w54 * w72 + w55 * w73 + w56 * w74
    w92 = w91 * body1_m1_z - w75 * body1_m1_x
    w93 = w54 * w79 + w55 * w80 + w56 * w81
    w94 = w93 * body1_m1_z - w82 * body1_m1_x
    w95 = w54 * w85 + w55 * w86 + w56 * w87
    w96 = w95 * body1_m1_z - w88 * body1_m1_x
    w97 = w76 * body1_m1_x - w91 * body1_m1_y
    w98 = w83 * body1_m1_x - w93 * body1_m1_y
    w99 = w89 * body1_m1_x - w95 * body1_m1_y
    w100 = w12 * c37 + w11 * c39
    w101 = w12 * w100
    w102 = c1 + w101
    w103 = w102 * c4 + 2 * w60 * body2_m2_axes_2_2_0_0
    w104 = w103 * c4
    w105 = w102 - w104
    w106 = c0 - w101 + w14 * c40
    w107 = w11 * w100 - c38
    w108 = w63 - w62
    w109 = w107 * body2_m2_axes_2_2_0_0 - w108 * c4 + w68 * c19
    w110 = (w106 - w105) * c7 - 2 * w109 * c5
    w111 = w110 * c7
    w112 = w105 + w111 + c41
    w113 = w104 + w70 * c42 + c43
    w114 = -(c44 - (w109 + w110 * c5))
    w115 = w107 * c4 + w108 * body2_m2_axes_2_2_0_0 + w70 * c19 + w14 * c20
    w116 = w103 * body2_m2_axes_2_2_0_0 - w60 + w68 * c20
    w117 = -(c45 - (w115 * c5 + w116 * c7))
    w118 = w106 - w111 + c46
    w119 = -(w115 * c7 - w116 * c5 + c47)
    w120 = 2 * body4_e1
    w121 = w120 * body4_e3
    w122 = 2 * body4_e2
    w123 = w122 * body4_e0
    w124 = w121 + w123
    w125 = 2 * body5_e1
    w126 = w125 * body5_e3
    w127 = 2 * body5_e2
    w128 = w127 * body5_e0
    w129 = w126 + w128
    w130 = w125 * body5_e2
    w131 = 2 * body5_e3
    w132 = body5_e0 * w131
    w133 = w130 - w132
    w134 = w129 * c58 - w133 * c59
    w135 = body4_e3 * w122
    w136 = w120 * body4_e0
    w137 = w135 - w136
    w138 = body5_e3 * w127
    w139 = w125 * body5_e0
    w140 = w138 - w139
    w141 = body5_e1 * w125
    w142 = body5_e3 * w131
    w143 = 1.0 - (w141 + w142)
    w144 = w140 * c58 - w143 * c59
    w145 = body4_e1 * w120
    w146 = body4_e2 * w122
    w147 = 1.0 - (w145 + w146)
    w148 = body5_e2 * w127
    w149 = 1.0 - (w141 + w148)
    w150 = w138 + w139
    w151 = w149 * c58 - w150 * c59
    w152 = w124 * w134 + w137 * w144 + w147 * w151
    w153 = w120 * body4_e2
    w154 = 2 * body4_e3
    w155 = body4_e0 * w154
    w156 = w153 - w155
    w157 = body4_e3 * w154
    w158 = 1.0 - (w145 + w157)
    w159 = w135 + w136
    w160 = w134 * w156 + w144 * w158 + w151 * w159
    w161 = w152 * body4_m4_y - w160 * body4_m4_z
    w162 = 1.0 - (w142 + w148)
    w163 = w162 * c59 - w129 * c60
    w164 = w130 + w132
    w165 = w164 * c59 - w140 * c60
    w166 = w126 - w128
    w167 = w166 * c59 - w149 * c60
    w168 = w124 * w163 + w137 * w165 + w147 * w167
    w169 = w156 * w163 + w158 * w165 + w159 * w167
    w170 = w168 * body4_m4_y - w169 * body4_m4_z
    w171 = w133 * c60 - w162 * c58
    w172 = w143 * c60 - w164 * c58
    w173 = w150 * c60 - w166 * c58
    w174 = w124 * w171 + w137 * w172 + w147 * w173
    w175 = w156 * w171 + w158 * w172 + w159 * w173
    w176 = w174 * body4_m4_y - w175 * body4_m4_z
    w177 = 1.0 - (w146 + w157)
    w178 = w153 + w155
    w179 = w121 - w123
    w180 = w134 * w177 + w144 * w178 + w151 * w179
    w181 = w180 * body4_m4_z - w152 * body4_m4_x
    w182 = w163 * w177 + w165 * w178 + w167 * w179
    w183 = w182 * body4_m4_z - w168 * body4_m4_x
    w184 = w171 * w177 + w172 * w178 + w173 * w179
    w185 = w184 * body4_m4_z - w174 * body4_m4_x
    w186 = w160 * body4_m4_x - w180 * body4_m4_y
    w187 = w169 * body4_m4_x - w182 * body4_m4_y
    w188 = w175 * body4_m4_x - w184 * body4_m4_y
    w189 = body1_omega_x * body1_omega_y
    w190 = body1_omega_y**2
    w191 = body1_omega_z**2
    w192 = w190 + w191
    w193 = body1_omega_x * body1_omega_z
    w194 = w56 * gravity_z
    w195 = w189 * body1_m1_y - w192 * body1_m1_x + w193 * body1_m1_z - w194
    w196 = body1_omega_x**2
    w197 = w191 + w196
    w198 = body1_omega_y * body1_omega_z
    w199 = w51 * gravity_z
    w200 = w189 * body1_m1_x - w197 * body1_m1_y + w198 * body1_m1_z - w199
    w201 = w190 + w196
    w202 = w39 * gravity_z
    w203 = w193 * body1_m1_x + w198 * body1_m1_y - w201 * body1_m1_z - w202
    w204 = w54 * w195 + w48 * w200 + w4 * w203
    w205 = w55 * w195 + w50 * w200 + w29 * w203
    w206 = w56 * w195 + w51 * w200 + w39 * w203
    w207 = w24 * w204 + w35 * w205 + w42 * w206
    w208 = body2_omega_y * c7 - body2_omega_x * c5
    w209 = body2_omega_x * c7 + body2_omega_y * c5
    w210 = w209**2
    w211 = w208 * body2_omega_z
    w212 = w207 - (w208**2 + w210) * c20 + w211 * c19
    w213 = w9 * w204 + w30 * w205 + w40 * w206
    w214 = w20 * w204 + w32 * w205 + w41 * w206
    w215 = w213 * c7 + w214 * c5 + w209 * body2_omega_z * c20 + w208 * w209 * c19
    w216 = w212 * c4 - w215 * body2_m2_axes_2_2_0_0
    w217 = body2_omega_z**2
    w218 = w214 * c7 - w213 * c5 + w211 * c20 - (w210 + w217) * c19
    w219 = body2_omega_z * c4 - w209 * body2_m2_axes_2_2_0_0
    w220 = w11 * w219 - w12 * w208
    w221 = w209 * c4 + body2_omega_z * body2_m2_axes_2_2_0_0 + j2_angle_dot
    w222 = w220 * w221
    w223 = w220 * j2_angle_dot
    w224 = w222 - w223
    w225 = w11 * w208 + w12 * w219
    w226 = w221 * w225
    w227 = j2_angle_dot * w225
    w228 = w226 - w227
    w229 = w220 * w225
    w230 = w225**2
    w231 = w221**2
    w232 = w230 + w231
    w233 = w220**2
    w234 = w231 + w233
    w235 = (
        (w11 * w216 - w12 * w218 + w224 * c14) * c10
        - (w11 * w218 + w12 * w216 + w228 * c14) * c9
        + (w229 * c0 - w232 * c38 + w224 * c13 - (w229 * c1 - w234 * c38 + w228 * c16))
    )
    w236 = body2_omega_y * body2_omega_x
    w237 = body2_omega_y**2
    w238 = w217 + w237
    w239 = body2_omega_x * body2_omega_z
    w240 = w229 * c9 - w234 * c10
    w241 = w229 * c10 - w232 * c9
    w242 = w11 * w240 - w12 * w241
    w243 = w12 * w240 + w11 * w241
    w244 = w226 + w227
    w245 = w222 + w223
    w246 = w244 * c10 + w245 * c9
    w247 = w243 * body2_m2_axes_2_2_0_0 - w246 * c4
    w248 = w236 * c29 - w238 * c31 + w239 * c30 - (w242 * c5 + w247 * c7)
    w249 = body2_omega_x**2
    w250 = w217 + w249
    w251 = body2_omega_y * body2_omega_z
    w252 = w242 * c7 - w247 * c5 + (w236 * c31 - w250 * c29 + w251 * c30)
    w253 = w243 * c4 + w246 * body2_m2_axes_2_2_0_0
    w254 = w237 + w249
    w255 = w253 + (w239 * c31 + w251 * c29 - w254 * c30)
    w256 = w9 * w248 + w20 * w252 + w24 * w255
    w257 = w30 * w248 + w32 * w252 + w35 * w255
    w258 = w40 * w248 + w41 * w252 + w42 * w255
    w259 = w4 * w256 + w29 * w257 + w39 * w258
    w260 = w48 * w256 + w50 * w257 + w51 * w258
    w261 = w199 * c79 - w202 * c80 + (w193 * c25 + w198 * c22 - w201 * c34 - (w189 * c27 - w197 * c34 + w198 * c23))
    w262 = w54 * w256 + w55 * w257 + w56 * w258
    w263 = w202 * c81 - w194 * c79 + (w189 * c34 - w192 * c27 + w193 * c23 - (w193 * c32 + w198 * c25 - w201 * c27))
    w264 = w194 * c80 - w199 * c81 + (w189 * c32 - w197 * c25 + w198 * c27 - (w189 * c22 - w192 * c25 + w193 * c34))
    w265 = w207 * c29 - w214 * c30 + (w239 * c44 + w251 * c41 - w254 * c47 - (w236 * c45 - w250 * c47 + w251 * c43))
    w266 = w230 + w233
    w267 = w215 * c4 + w212 * body2_m2_axes_2_2_0_0 - w266 * c14
    w268 = w267 * c9 + (w244 * c38 + w245 * c1 - w266 * c16 - (w229 * c13 - w232 * c16)) - w241 * c14
    w269 = w229 * c16 - w234 * c13 - (w244 * c0 + w245 * c38 - w266 * c13) - w267 * c10 + w240 * c14
    w270 = w11 * w268 - w12 * w269 - w247 * c20
    w271 = w12 * w268 + w11 * w269
    w272 = w271 * body2_m2_axes_2_2_0_0 - w235 * c4 - w253 * c19 + w242 * c20
    w273 = w213 * c30 - w207 * c31 + (w236 * c47 - w238 * c45 + w239 * c43 - (w239 * c46 + w251 * c44 - w254 * c45))
    w274 = w214 * c31 - w213 * c29 + (w236 * c46 - w250 * c44 + w251 * c45 - (w236 * c41 - w238 * c44 + w239 * c47))
    w275 = body5_omega_x * body5_omega_y
    w276 = body5_omega_y**2
    w277 = body5_omega_z**2
    w278 = w276 + w277
    w279 = body5_omega_x * body5_omega_z
    w280 = w275 * c58 - w278 * c60 + w279 * c59
    w281 = body5_omega_x**2
    w282 = w277 + w281
    w283 = body5_omega_y * body5_omega_z
    w284 = w275 * c60 - w282 * c58 + w283 * c59
    w285 = w276 + w281
    w286 = w279 * c60 + w283 * c58 - w285 * c59
    w287 = w162 * w280 + w133 * w284 + w129 * w286
    w288 = w164 * w280 + w143 * w284 + w140 * w286
    w289 = w166 * w280 + w150 * w284 + w149 * w286
    w290 = w124 * w287 + w137 * w288 + w147 * w289
    w291 = w156 * w287 + w158 * w288 + w159 * w289
    w292 = w159 * gravity_z
    w293 = w147 * gravity_z
    w294 = body4_omega_x * body4_omega_z
    w295 = body4_omega_z * body4_omega_y
    w296 = body4_omega_x**2
    w297 = body4_omega_y**2
    w298 = w296 + w297
    w299 = body4_omega_x * body4_omega_y
    w300 = body4_omega_z**2
    w301 = w296 + w300
    w302 = w292 * c82 - w293 * c83 + (w294 * c54 + w295 * c49 - w298 * c63 - (w299 * c56 - w301 * c63 + w295 * c51))
    w303 = w177 * w287 + w178 * w288 + w179 * w289
    w304 = w179 * gravity_z
    w305 = w297 + w300
    w306 = w293 * c84 - w304 * c82 + (w299 * c63 - w305 * c56 + w294 * c51 - (w294 * c61 + w295 * c54 - w298 * c56))
    w307 = w304 * c83 - w292 * c84 + (w299 * c61 - w301 * c54 + w295 * c56 - (w299 * c49 - w305 * c54 + w294 * c63))
    w308 = w299 * body4_m4_y - w305 * body4_m4_x + w294 * body4_m4_z - w304
    w309 = w299 * body4_m4_x - w301 * body4_m4_y + w295 * body4_m4_z - w292
    w310 = w294 * body4_m4_x + w295 * body4_m4_y - w298 * body4_m4_z - w293
    w311 = w177 * w308 + w156 * w309 + w124 * w310
    w312 = w178 * w308 + w158 * w309 + w137 * w310
    w313 = w179 * w308 + w159 * w309 + w147 * w310
    w314 = w129 * w311 + w140 * w312 + w149 * w313
    w315 = w133 * w311 + w143 * w312 + w150 * w313
    w316 = w314 * c58 - w315 * c59 + (w279 * c69 + w283 * c66 - w285 * c75 - (w275 * c71 - w282 * c75 + w283 * c67))
    w317 = w162 * w311 + w164 * w312 + w166 * w313
    w318 = w317 * c59 - w314 * c60 + (w275 * c75 - w278 * c71 + w279 * c67 - (w279 * c73 + w283 * c69 - w285 * c71))
    w319 = w315 * c60 - w317 * c58 + (w275 * c73 - w282 * c69 + w283 * c71 - (w275 * c66 - w278 * c69 + w279 * c75))
    # outputs
    M_hat = ca.SX(13, 13)
    # j2.angle
    M_hat[0, 0] = c2
    M_hat[0, 1] = w53
    M_hat[0, 2] = w58
    M_hat[0, 3] = w59
    M_hat[0, 4] = w65
    M_hat[0, 5] = w66
    M_hat[0, 6] = w67
    # body1.turn_x
    M_hat[1, 0] = w53
    M_hat[1, 1] = c24
    M_hat[1, 2] = c26
    M_hat[1, 3] = c28
    M_hat[1, 4] = w77
    M_hat[1, 5] = w84
    M_hat[1, 6] = w90
    # body1.turn_y
    M_hat[2, 0] = w58
    M_hat[2, 1] = c26
    M_hat[2, 2] = c33
    M_hat[2, 3] = c35
    M_hat[2, 4] = w92
    M_hat[2, 5] = w94
    M_hat[2, 6] = w96
    # body1.turn_z
    M_hat[3, 0] = w59
    M_hat[3, 1] = c28
    M_hat[3, 2] = c35
    M_hat[3, 3] = c36
    M_hat[3, 4] = w97
    M_hat[3, 5] = w98
    M_hat[3, 6] = w99
    # body2.turn_x
    M_hat[4, 0] = w65
    M_hat[4, 1] = w77
    M_hat[4, 2] = w92
    M_hat[4, 3] = w97
    M_hat[4, 4] = w112 + w113
    M_hat[4, 5] = w114
    M_hat[4, 6] = w117
    # body2.turn_y
    M_hat[5, 0] = w66
    M_hat[5, 1] = w84
    M_hat[5, 2] = w94
    M_hat[5, 3] = w98
    M_hat[5, 4] = w114
    M_hat[5, 5] = w113 + w118
    M_hat[5, 6] = w119
    # body2.turn_z
    M_hat[6, 0] = w67
    M_hat[6, 1] = w90
    M_hat[6, 2] = w96
    M_hat[6, 3] = w99
    M_hat[6, 4] = w117
    M_hat[6, 5] = w119
    M_hat[6, 6] = w112 + w118
    # body4.turn_x
    M_hat[7, 7] = c52
    M_hat[7, 8] = c55
    M_hat[7, 9] = c57
    M_hat[7, 10] = w161
    M_hat[7, 11] = w170
    M_hat[7, 12] = w176
    # body4.turn_y
    M_hat[8, 7] = c55
    M_hat[8, 8] = c62
    M_hat[8, 9] = c64
    M_hat[8, 10] = w181
    M_hat[8, 11] = w183
    M_hat[8, 12] = w185
    # body4.turn_z
    M_hat[9, 7] = c57
    M_hat[9, 8] = c64
    M_hat[9, 9] = c65
    M_hat[9, 10] = w186
    M_hat[9, 11] = w187
    M_hat[9, 12] = w188
    # body5.turn_x
    M_hat[10, 7] = w161
    M_hat[10, 8] = w181
    M_hat[10, 9] = w186
    M_hat[10, 10] = c68
    M_hat[10, 11] = c70
    M_hat[10, 12] = c72
    # body5.turn_y
    M_hat[11, 7] = w170
    M_hat[11, 8] = w183
    M_hat[11, 9] = w187
    M_hat[11, 10] = c70
    M_hat[11, 11] = c74
    M_hat[11, 12] = c76
    # body5.turn_z
    M_hat[12, 7] = w176
    M_hat[12, 8] = w185
    M_hat[12, 9] = w188
    M_hat[12, 10] = c72
    M_hat[12, 11] = c76
    M_hat[12, 12] = c77
    Q_hat = ca.vertcat(
        -w235,  # j2.angle
        -(w259 * body1_m1_y - w260 * body1_m1_z + w261),  # body1.turn_x
        -(w262 * body1_m1_z - w259 * body1_m1_x + w263),  # body1.turn_y
        -(w260 * body1_m1_x - w262 * body1_m1_y + w264),  # body1.turn_z
        -(w265 - (w270 * c5 + w272 * c7)),  # body2.turn_x
        -(w270 * c7 - w272 * c5 + w273),  # body2.turn_y
        -(w271 * c4 + w235 * body2_m2_axes_2_2_0_0 + w247 * c19 + w274),  # body2.turn_z
        -(w290 * body4_m4_y - w291 * body4_m4_z + w302),  # body4.turn_x
        -(w303 * body4_m4_z - w290 * body4_m4_x + w306),  # body4.turn_y
        -(w291 * body4_m4_x - w303 * body4_m4_y + w307),  # body4.turn_z
        -w316,  # body5.turn_x
        -w318,  # body5.turn_y
        -w319,  # body5.turn_z
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 13) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 16) [1]: unit quaternions from which turns are rotation vectors
    takes c (n_const = 98) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 35) [mixed]: dependent coordinates after one Newton step
    434 operations.
    """
    q_i = ca.SX.sym("q_i", 13)
    chart = ca.SX.sym("chart", 16)
    c = ca.SX.sym("c", 98)
    j2_angle = q_i[0]
    body1_turn_x = q_i[1]
    body1_turn_y = q_i[2]
    body1_turn_z = q_i[3]
    body2_turn_x = q_i[4]
    body2_turn_y = q_i[5]
    body2_turn_z = q_i[6]
    body4_turn_x = q_i[7]
    body4_turn_y = q_i[8]
    body4_turn_z = q_i[9]
    body5_turn_x = q_i[10]
    body5_turn_y = q_i[11]
    body5_turn_z = q_i[12]
    body1_chart_0 = chart[0]
    body1_chart_1 = chart[1]
    body1_chart_2 = chart[2]
    body1_chart_3 = chart[3]
    body2_chart_0 = chart[4]
    body2_chart_1 = chart[5]
    body2_chart_2 = chart[6]
    body2_chart_3 = chart[7]
    body4_chart_0 = chart[8]
    body4_chart_1 = chart[9]
    body4_chart_2 = chart[10]
    body4_chart_3 = chart[11]
    body5_chart_0 = chart[12]
    body5_chart_1 = chart[13]
    body5_chart_2 = chart[14]
    body5_chart_3 = chart[15]
    body1_m1_y = c[3]
    body1_m1_z = c[11]
    body1_m1_x = c[12]
    body4_m4_y = c[48]
    body4_m4_z = c[50]
    body4_m4_x = c[53]
    body2_m2_x = c[85]
    body2_m2_y = c[86]
    body2_m2_z = c[87]
    ground_m0_x = c[88]
    ground_m0_y = c[89]
    ground_m0_z = c[90]
    body2_m2_quaternion_0_0_0 = c[91]
    body2_m2_quaternion_3_0_0 = c[92]
    body2_m2_quaternion_1_0_0 = c[93]
    body2_m2_quaternion_2_0_0 = c[94]
    ground_m3_x = c[95]
    ground_m3_y = c[96]
    ground_m3_z = c[97]
    # intermediate terms (80)
    w0 = ca.sqrt((body1_turn_x**2 + body1_turn_y**2 + body1_turn_z**2) / 4.0 + 1e-300)
    w1 = ca.cos(w0)
    w2 = ca.sin(w0) / w0 / 2.0
    w3 = body1_turn_x * w2
    w4 = body1_turn_y * w2
    w5 = body1_turn_z * w2
    w6 = body1_chart_0 * w1 - (body1_chart_1 * w3 + body1_chart_2 * w4 + body1_chart_3 * w5)
    w7 = body1_chart_0 * w3 + w1 * body1_chart_1 + (body1_chart_2 * w5 - w4 * body1_chart_3)
    w8 = body1_chart_0 * w4 + w1 * body1_chart_2 + (w3 * body1_chart_3 - body1_chart_1 * w5)
    w9 = body1_chart_0 * w5 + w1 * body1_chart_3 + (body1_chart_1 * w4 - w3 * body1_chart_2)
    w10 = 2 * w8**2
    w11 = 2 * w9**2
    w12 = 2 * w7
    w13 = w8 * w12
    w14 = 2 * w6
    w15 = w9 * w14
    w16 = w8 * w14
    w17 = w9 * w12
    w18 = ground_m0_x + ((1.0 - w10 - w11) * body1_m1_x + (w13 - w15) * body1_m1_y + (w16 + w17) * body1_m1_z)
    w19 = 1.0 - 2 * w7**2
    w20 = w9 * (2 * w8)
    w21 = w7 * w14
    w22 = ground_m0_y + ((w13 + w15) * body1_m1_x + (w19 - w11) * body1_m1_y + (w20 - w21) * body1_m1_z)
    w23 = ground_m0_z + ((w17 - w16) * body1_m1_x + (w20 + w21) * body1_m1_y + (w19 - w10) * body1_m1_z)
    w24 = ca.sqrt(1e-300 + (body2_turn_x**2 + body2_turn_y**2 + body2_turn_z**2) / 4.0)
    w25 = ca.cos(w24)
    w26 = ca.sin(w24) / w24 / 2.0
    w27 = body2_turn_x * w26
    w28 = body2_turn_y * w26
    w29 = body2_turn_z * w26
    w30 = body2_chart_0 * w25 - (body2_chart_1 * w27 + body2_chart_2 * w28 + body2_chart_3 * w29)
    w31 = body2_chart_0 * w27 + w25 * body2_chart_1 + (body2_chart_2 * w29 - w28 * body2_chart_3)
    w32 = body2_chart_0 * w28 + w25 * body2_chart_2 + (w27 * body2_chart_3 - body2_chart_1 * w29)
    w33 = body2_chart_0 * w29 + w25 * body2_chart_3 + (body2_chart_1 * w28 - w27 * body2_chart_2)
    w34 = 2 * w32**2
    w35 = 2 * w33**2
    w36 = 2 * w31
    w37 = w32 * w36
    w38 = 2 * w30
    w39 = w33 * w38
    w40 = w32 * w38
    w41 = w33 * w36
    w42 = 1.0 - 2 * w31**2
    w43 = w33 * (2 * w32)
    w44 = w31 * w38
    w45 = j2_angle / 2.0
    w46 = ca.cos(w45)
    w47 = ca.sin(w45)
    w48 = w46 * body2_m2_quaternion_0_0_0 - w47 * body2_m2_quaternion_3_0_0
    w49 = w46 * body2_m2_quaternion_1_0_0 + w47 * body2_m2_quaternion_2_0_0
    w50 = w46 * body2_m2_quaternion_2_0_0 - w47 * body2_m2_quaternion_1_0_0
    w51 = w47 * body2_m2_quaternion_0_0_0 + w46 * body2_m2_quaternion_3_0_0
    w52 = ca.sqrt(1e-300 + (body4_turn_x**2 + body4_turn_y**2 + body4_turn_z**2) / 4.0)
    w53 = ca.cos(w52)
    w54 = ca.sin(w52) / w52 / 2.0
    w55 = body4_turn_x * w54
    w56 = body4_turn_y * w54
    w57 = body4_turn_z * w54
    w58 = body4_chart_0 * w53 - (body4_chart_1 * w55 + body4_chart_2 * w56 + body4_chart_3 * w57)
    w59 = body4_chart_0 * w55 + w53 * body4_chart_1 + (body4_chart_2 * w57 - w56 * body4_chart_3)
    w60 = body4_chart_0 * w56 + w53 * body4_chart_2 + (w55 * body4_chart_3 - body4_chart_1 * w57)
    w61 = body4_chart_0 * w57 + w53 * body4_chart_3 + (body4_chart_1 * w56 - w55 * body4_chart_2)
    w62 = 2 * w60**2
    w63 = 2 * w61**2
    w64 = 2 * w59
    w65 = w60 * w64
    w66 = 2 * w58
    w67 = w61 * w66
    w68 = w60 * w66
    w69 = w61 * w64
    w70 = ground_m3_x + ((1.0 - w62 - w63) * body4_m4_x + (w65 - w67) * body4_m4_y + (w68 + w69) * body4_m4_z)
    w71 = 1.0 - 2 * w59**2
    w72 = w61 * (2 * w60)
    w73 = w59 * w66
    w74 = ca.sqrt(1e-300 + (body5_turn_x**2 + body5_turn_y**2 + body5_turn_z**2) / 4.0)
    w75 = ca.cos(w74)
    w76 = ca.sin(w74) / w74 / 2.0
    w77 = body5_turn_x * w76
    w78 = body5_turn_y * w76
    w79 = body5_turn_z * w76
    # outputs
    q_d_next = ca.vertcat(
        ground_m0_x,  # body1.x
        ground_m0_y,  # body1.y
        ground_m0_z,  # body1.z
        w6,  # body1.e0
        w7,  # body1.e1
        w8,  # body1.e2
        w9,  # body1.e3
        w18,  # body2.x
        w22,  # body2.y
        w23,  # body2.z
        w30,  # body2.e0
        w31,  # body2.e1
        w32,  # body2.e2
        w33,  # body2.e3
        w18 + ((1.0 - w34 - w35) * body2_m2_x + (w37 - w39) * body2_m2_y + (w40 + w41) * body2_m2_z),  # body3.x
        w22 + ((w37 + w39) * body2_m2_x + (w42 - w35) * body2_m2_y + (w43 - w44) * body2_m2_z),  # body3.y
        w23 + ((w41 - w40) * body2_m2_x + (w43 + w44) * body2_m2_y + (w42 - w34) * body2_m2_z),  # body3.z
        w30 * w48 - (w31 * w49 + w32 * w50 + w33 * w51),  # body3.e0
        w30 * w49 + w31 * w48 + (w32 * w51 - w33 * w50),  # body3.e1
        w30 * w50 + w32 * w48 + (w33 * w49 - w31 * w51),  # body3.e2
        w30 * w51 + w33 * w48 + (w31 * w50 - w32 * w49),  # body3.e3
        ground_m3_x,  # body4.x
        ground_m3_y,  # body4.y
        ground_m3_z,  # body4.z
        w58,  # body4.e0
        w59,  # body4.e1
        w60,  # body4.e2
        w61,  # body4.e3
        w70,  # body5.x
        ground_m3_y + ((w65 + w67) * body4_m4_x + (w71 - w63) * body4_m4_y + (w72 - w73) * body4_m4_z),  # body5.y
        ground_m3_z + ((w69 - w68) * body4_m4_x + (w72 + w73) * body4_m4_y + (w71 - w62) * body4_m4_z),  # body5.z
        body5_chart_0 * w75 - (body5_chart_1 * w77 + body5_chart_2 * w78 + body5_chart_3 * w79),  # body5.e0
        body5_chart_0 * w77 + w75 * body5_chart_1 + (body5_chart_2 * w79 - w78 * body5_chart_3),  # body5.e1
        body5_chart_0 * w78 + w75 * body5_chart_2 + (w77 * body5_chart_3 - body5_chart_1 * w79),  # body5.e2
        body5_chart_0 * w79 + w75 * body5_chart_3 + (body5_chart_1 * w78 - w77 * body5_chart_2),  # body5.e3
    )
    inputs, outputs = [q_i, chart, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 13) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 13) [mixed]: rates of the independent coordinates
    takes c (n_const = 98) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 35) [mixed]: rates of the dependent coordinates
    568 operations.
    """
    q_i = ca.SX.sym("q_i", 13)
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 13)
    c = ca.SX.sym("c", 98)
    j2_angle = q_i[0]
    body1_e0 = q_d[3]
    body1_e1 = q_d[4]
    body1_e2 = q_d[5]
    body1_e3 = q_d[6]
    body2_e0 = q_d[10]
    body2_e1 = q_d[11]
    body2_e2 = q_d[12]
    body2_e3 = q_d[13]
    body4_e0 = q_d[24]
    body4_e1 = q_d[25]
    body4_e2 = q_d[26]
    body4_e3 = q_d[27]
    body5_e0 = q_d[31]
    body5_e1 = q_d[32]
    body5_e2 = q_d[33]
    body5_e3 = q_d[34]
    j2_angle_dot = q_i_dot[0]
    body1_omega_x = q_i_dot[1]
    body1_omega_y = q_i_dot[2]
    body1_omega_z = q_i_dot[3]
    body2_omega_x = q_i_dot[4]
    body2_omega_y = q_i_dot[5]
    body2_omega_z = q_i_dot[6]
    body4_omega_x = q_i_dot[7]
    body4_omega_y = q_i_dot[8]
    body4_omega_z = q_i_dot[9]
    body5_omega_x = q_i_dot[10]
    body5_omega_y = q_i_dot[11]
    body5_omega_z = q_i_dot[12]
    body1_m1_y = c[3]
    body1_m1_z = c[11]
    body1_m1_x = c[12]
    body4_m4_y = c[48]
    body4_m4_z = c[50]
    body4_m4_x = c[53]
    body2_m2_x = c[85]
    body2_m2_y = c[86]
    body2_m2_z = c[87]
    body2_m2_quaternion_0_0_0 = c[91]
    body2_m2_quaternion_3_0_0 = c[92]
    body2_m2_quaternion_1_0_0 = c[93]
    body2_m2_quaternion_2_0_0 = c[94]
    # intermediate terms (129)
    w0 = body1_e1 * 0.5
    w1 = body1_e2 * 0.5
    w2 = body1_e3 * 0.5
    w3 = w0 * body1_omega_x + w1 * body1_omega_y + w2 * body1_omega_z
    w4 = body1_e0 * 0.5
    w5 = body1_omega_x * w4 - body1_omega_y * w2 + w1 * body1_omega_z
    w6 = body1_omega_x * w2 + body1_omega_y * w4 - w0 * body1_omega_z
    w7 = w0 * body1_omega_y - body1_omega_x * w1 + body1_omega_z * w4
    w8 = 2 * body1_e3
    w9 = 2 * body1_e1
    w10 = body1_e3 * w9
    w11 = 2 * body1_e0
    w12 = body1_e2 * w11
    w13 = body1_e1 * w11
    w14 = 2 * body1_e2
    w15 = body1_e3 * w14
    w16 = 1.0 - 2 * body1_e1**2
    w17 = 2 * body1_e2**2
    w18 = (w10 - w12) * body1_m1_x + (w13 + w15) * body1_m1_y + (w16 - w17) * body1_m1_z
    w19 = body1_e2 * -2.0
    w20 = body1_e3 * w11
    w21 = body1_e2 * w9
    w22 = 2 * body1_e3**2
    w23 = (w20 + w21) * body1_m1_x + (w16 - w22) * body1_m1_y + (w15 - w13) * body1_m1_z
    w24 = body1_e3 * -2.0
    w25 = w23 * w24
    w26 = w11 * w18
    w27 = body1_e1 * -2.0
    w28 = w18 * w27
    w29 = w11 * w23
    w30 = w5 * (w8 * w18 - w19 * w23) - w3 * (w18 * w19 - w25) + w6 * (w26 - w9 * w23) + w7 * (w28 - w29)
    w31 = (1.0 - w17 - w22) * body1_m1_x + (w21 - w20) * body1_m1_y + (w10 + w12) * body1_m1_z
    w32 = w19 * w31
    w33 = w11 * w31
    w34 = w5 * (w32 - w26) - w3 * (w24 * w31 - w28) + w6 * (w9 * w31 - w18 * w24) + w7 * (w33 - w14 * w18)
    w35 = w5 * (w29 - w8 * w31) - w3 * (w23 * w27 - w32) + w6 * (w25 - w33) + w7 * (w14 * w23 - w27 * w31)
    w36 = body2_e1 * 0.5
    w37 = body2_e2 * 0.5
    w38 = body2_e3 * 0.5
    w39 = w36 * body2_omega_x + w37 * body2_omega_y + w38 * body2_omega_z
    w40 = body2_e0 * 0.5
    w41 = body2_omega_x * w40 - body2_omega_y * w38 + w37 * body2_omega_z
    w42 = body2_omega_x * w38 + body2_omega_y * w40 - w36 * body2_omega_z
    w43 = w36 * body2_omega_y - body2_omega_x * w37 + body2_omega_z * w40
    w44 = body2_e2 * -2.0
    w45 = 2 * body2_e1
    w46 = body2_e3 * w45
    w47 = 2 * body2_e0
    w48 = body2_e2 * w47
    w49 = body2_e1 * w47
    w50 = 2 * body2_e2
    w51 = body2_e3 * w50
    w52 = 1.0 - 2 * body2_e1**2
    w53 = 2 * body2_e2**2
    w54 = (w46 - w48) * body2_m2_x + (w49 + w51) * body2_m2_y + (w52 - w53) * body2_m2_z
    w55 = body2_e3 * -2.0
    w56 = body2_e3 * w47
    w57 = body2_e2 * w45
    w58 = 2 * body2_e3**2
    w59 = (w56 + w57) * body2_m2_x + (w52 - w58) * body2_m2_y + (w51 - w49) * body2_m2_z
    w60 = w55 * w59
    w61 = 2 * body2_e3
    w62 = w47 * w54
    w63 = body2_e1 * -2.0
    w64 = w54 * w63
    w65 = w47 * w59
    w66 = w30 - w39 * (w44 * w54 - w60) + w41 * (w54 * w61 - w44 * w59) + w42 * (w62 - w45 * w59) + w43 * (w64 - w65)
    w67 = (1.0 - w53 - w58) * body2_m2_x + (w57 - w56) * body2_m2_y + (w46 + w48) * body2_m2_z
    w68 = w44 * w67
    w69 = w47 * w67
    w70 = w34 - w39 * (w55 * w67 - w64) + w41 * (w68 - w62) + w42 * (w45 * w67 - w54 * w55) + w43 * (w69 - w50 * w54)
    w71 = w35 - w39 * (w59 * w63 - w68) + w41 * (w65 - w61 * w67) + w42 * (w60 - w69) + w43 * (w50 * w59 - w63 * w67)
    w72 = j2_angle / 2.0
    w73 = ca.cos(w72)
    w74 = ca.sin(w72)
    w75 = w73 * body2_m2_quaternion_0_0_0 - w74 * body2_m2_quaternion_3_0_0
    w76 = w73 * body2_m2_quaternion_1_0_0 + w74 * body2_m2_quaternion_2_0_0
    w77 = w73 * body2_m2_quaternion_2_0_0 - w74 * body2_m2_quaternion_1_0_0
    w78 = w74 * body2_m2_quaternion_0_0_0 + w73 * body2_m2_quaternion_3_0_0
    w79 = w74 / 2.0
    w80 = w73 / 2.0
    w81 = w79 * body2_m2_quaternion_0_0_0 + w80 * body2_m2_quaternion_3_0_0
    w82 = w80 * body2_m2_quaternion_2_0_0 - w79 * body2_m2_quaternion_1_0_0
    w83 = w79 * body2_m2_quaternion_2_0_0 + w80 * body2_m2_quaternion_1_0_0
    w84 = w80 * body2_m2_quaternion_0_0_0 - w79 * body2_m2_quaternion_3_0_0
    w85 = (
        w39 * w75
        + w41 * w76
        + w42 * w77
        + w43 * w78
        + (body2_e0 * w81 + (body2_e1 * w82 - body2_e2 * w83 + body2_e3 * w84)) * j2_angle_dot
    )
    w86 = (
        w41 * w75
        - w39 * w76
        + w42 * w78
        - w43 * w77
        + j2_angle_dot * (body2_e0 * w82 - body2_e1 * w81 + (body2_e2 * w84 + body2_e3 * w83))
    )
    w87 = (
        w42 * w75
        - (w39 * w77 + w41 * w78)
        + w43 * w76
        + j2_angle_dot * (body2_e3 * w82 - body2_e1 * w84 - (body2_e0 * w83 + body2_e2 * w81))
    )
    w88 = (
        w41 * w77
        - w39 * w78
        - w42 * w76
        + w43 * w75
        + j2_angle_dot * (body2_e0 * w84 - body2_e3 * w81 - (body2_e1 * w83 + body2_e2 * w82))
    )
    w89 = body4_e1 * 0.5
    w90 = body4_e2 * 0.5
    w91 = body4_e3 * 0.5
    w92 = w89 * body4_omega_x + w90 * body4_omega_y + w91 * body4_omega_z
    w93 = body4_e0 * 0.5
    w94 = body4_omega_x * w93 - body4_omega_y * w91 + w90 * body4_omega_z
    w95 = body4_omega_x * w91 + body4_omega_y * w93 - w89 * body4_omega_z
    w96 = w89 * body4_omega_y - body4_omega_x * w90 + body4_omega_z * w93
    w97 = 2 * body4_e3
    w98 = 2 * body4_e1
    w99 = body4_e3 * w98
    w100 = 2 * body4_e0
    w101 = body4_e2 * w100
    w102 = body4_e1 * w100
    w103 = 2 * body4_e2
    w104 = body4_e3 * w103
    w105 = 1.0 - 2 * body4_e1**2
    w106 = 2 * body4_e2**2
    w107 = (w99 - w101) * body4_m4_x + (w102 + w104) * body4_m4_y + (w105 - w106) * body4_m4_z
    w108 = body4_e2 * -2.0
    w109 = body4_e3 * w100
    w110 = body4_e2 * w98
    w111 = 2 * body4_e3**2
    w112 = (w109 + w110) * body4_m4_x + (w105 - w111) * body4_m4_y + (w104 - w102) * body4_m4_z
    w113 = body4_e3 * -2.0
    w114 = w112 * w113
    w115 = w100 * w107
    w116 = body4_e1 * -2.0
    w117 = w107 * w116
    w118 = w100 * w112
    w119 = (
        w94 * (w97 * w107 - w108 * w112) - w92 * (w107 * w108 - w114) + w95 * (w115 - w98 * w112) + w96 * (w117 - w118)
    )
    w120 = (1.0 - w106 - w111) * body4_m4_x + (w110 - w109) * body4_m4_y + (w99 + w101) * body4_m4_z
    w121 = w108 * w120
    w122 = w100 * w120
    w123 = (
        w94 * (w121 - w115) - w92 * (w113 * w120 - w117) + w95 * (w98 * w120 - w107 * w113) + w96 * (w122 - w103 * w107)
    )
    w124 = (
        w94 * (w118 - w97 * w120) - w92 * (w112 * w116 - w121) + w95 * (w114 - w122) + w96 * (w103 * w112 - w116 * w120)
    )
    w125 = body5_e1 * 0.5
    w126 = body5_e2 * 0.5
    w127 = body5_e3 * 0.5
    w128 = body5_e0 * 0.5
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # body1.x
        0.0,  # body1.y
        0.0,  # body1.z
        -w3,  # body1.e0
        w5,  # body1.e1
        w6,  # body1.e2
        w7,  # body1.e3
        w30,  # body2.x
        w34,  # body2.y
        w35,  # body2.z
        -w39,  # body2.e0
        w41,  # body2.e1
        w42,  # body2.e2
        w43,  # body2.e3
        w66,  # body3.x
        w70,  # body3.y
        w71,  # body3.z
        -w85,  # body3.e0
        w86,  # body3.e1
        w87,  # body3.e2
        w88,  # body3.e3
        0.0,  # body4.x
        0.0,  # body4.y
        0.0,  # body4.z
        -w92,  # body4.e0
        w94,  # body4.e1
        w95,  # body4.e2
        w96,  # body4.e3
        w119,  # body5.x
        w123,  # body5.y
        w124,  # body5.z
        -(w125 * body5_omega_x + w126 * body5_omega_y + w127 * body5_omega_z),  # body5.e0
        body5_omega_x * w128 - body5_omega_y * w127 + w126 * body5_omega_z,  # body5.e1
        body5_omega_x * w127 + body5_omega_y * w128 - w125 * body5_omega_z,  # body5.e2
        w125 * body5_omega_y - body5_omega_x * w126 + body5_omega_z * w128,  # body5.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "closure": closure,
    "velocities": velocities,
}
