"""spherical_tree: equations of motion, emitted by symgen from the scene `spherical_tree`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 j2.angle [rad], 1 j4.angle [rad], 2 body1.turn_x [rad], 3 body1.turn_y [rad], 4 body1.turn_z [rad],
    5 body2.turn_x [rad], 6 body2.turn_y [rad], 7 body2.turn_z [rad], 8 body4.turn_x [rad],
    9 body4.turn_y [rad], 10 body4.turn_z [rad]

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

    takes p (n_p = 77) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 92) [SI]: what depends on p only, computed once a run: c = constants(p)
    437 operations.
    """
    p = ca.SX.sym("p", 77)
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
    body5_inertia_xx = p[33]
    body5_inertia_yy = p[34]
    body5_inertia_zz = p[35]
    ground_m0_x = p[36]
    ground_m0_y = p[37]
    ground_m0_z = p[38]
    body1_m1_x = p[39]
    body1_m1_y = p[40]
    body1_m1_z = p[41]
    body1_m2_axes_0_0_0_0 = p[42]
    body1_m2_axes_0_2_0_0 = p[44]
    body1_m2_axes_1_0_0_0 = p[45]
    body1_m2_axes_1_2_0_0 = p[47]
    body1_m2_axes_2_0_0_0 = p[48]
    body1_m2_axes_2_2_0_0 = p[50]
    body1_m2_quaternion_0_0_0 = p[51]
    body1_m2_quaternion_1_0_0 = p[52]
    body1_m2_quaternion_2_0_0 = p[53]
    body1_m2_quaternion_3_0_0 = p[54]
    body1_m2_x = p[55]
    body1_m2_y = p[56]
    body1_m2_z = p[57]
    body1_m3_x = p[58]
    body1_m3_y = p[59]
    body1_m3_z = p[60]
    ground_m4_axes_0_0_0_0 = p[61]
    ground_m4_axes_0_2_0_0 = p[63]
    ground_m4_axes_1_0_0_0 = p[64]
    ground_m4_axes_1_2_0_0 = p[66]
    ground_m4_axes_2_0_0_0 = p[67]
    ground_m4_axes_2_2_0_0 = p[69]
    ground_m4_quaternion_0_0_0 = p[70]
    ground_m4_quaternion_1_0_0 = p[71]
    ground_m4_quaternion_2_0_0 = p[72]
    ground_m4_quaternion_3_0_0 = p[73]
    ground_m4_x = p[74]
    ground_m4_y = p[75]
    ground_m4_z = p[76]
    # intermediate terms (67)
    w0 = (body3_inertia_xx + body3_inertia_yy + body3_inertia_zz) / 2.0
    w1 = w0 - body3_inertia_xx + body3_mass * body3_center_of_mass_x**2
    w2 = w0 - body3_inertia_yy + body3_mass * body3_center_of_mass_y**2
    w3 = w1 + w2
    w4 = ca.sqrt(body1_m2_axes_0_2_0_0**2 + body1_m2_axes_1_2_0_0**2)
    w5 = body1_m2_axes_0_2_0_0 / w4
    w6 = body1_m2_axes_1_2_0_0 / w4
    w7 = body1_m2_axes_0_0_0_0 * (w5 * body1_m2_axes_2_2_0_0) + body1_m2_axes_1_0_0_0 * (body1_m2_axes_2_2_0_0 * w6)
    w8 = ca.atan2(w4 * body1_m2_axes_2_0_0_0 - w7, w5 * body1_m2_axes_1_0_0_0 - body1_m2_axes_0_0_0_0 * w6)
    w9 = body3_mass * (body3_center_of_mass_x * body3_center_of_mass_z)
    w10 = body3_mass * body3_center_of_mass_x
    w11 = (w5 * body1_m2_x + w6 * body1_m2_y) / w4
    w12 = body3_mass * (body3_center_of_mass_y * body3_center_of_mass_z)
    w13 = body3_mass * body3_center_of_mass_y
    w14 = w5 * body1_m2_y - w6 * body1_m2_x
    w15 = body1_m2_z - body1_m2_axes_2_2_0_0 * w11
    w16 = (body5_inertia_xx + body5_inertia_yy + body5_inertia_zz) / 2.0
    w17 = (
        w16
        - body5_inertia_xx
        + body5_mass * body5_center_of_mass_x**2
        + (w16 - body5_inertia_yy + body5_mass * body5_center_of_mass_y**2)
    )
    w18 = body3_mass * (body3_center_of_mass_x * body3_center_of_mass_y)
    w19 = (body1_inertia_xx + body1_inertia_yy + body1_inertia_zz) / 2.0
    w20 = body4_mass * body1_m3_y
    w21 = body3_mass * body3_center_of_mass_z
    w22 = w21 + body3_mass * w11
    w23 = w0 - body3_inertia_zz + body3_mass * body3_center_of_mass_z**2 + (w11 * w21 + w11 * w22)
    w24 = w4 * w23
    w25 = w4 * w24
    w26 = body3_mass * w14
    w27 = w14 * w26
    w28 = w4 * w22
    w29 = w14 * w28
    w30 = w5 * (w27 - w25) - w6 * (2 * -w29)
    w31 = w5 * w30
    w32 = body2_mass * body1_m1_y
    w33 = (
        w19
        - body1_inertia_yy
        + body1_mass * body1_center_of_mass_y**2
        + body1_m3_y * w20
        + (w25 + w31)
        + body1_m1_y * w32
    )
    w34 = body4_mass * body1_m3_z
    w35 = body1_m2_axes_2_2_0_0 * w22
    w36 = w35 + body3_mass * w15
    w37 = (
        w19
        - body1_inertia_zz
        + body1_mass * body1_center_of_mass_z**2
        + body1_m3_z * w34
        + (w23 - w25 + (w15 * w35 + w15 * w36))
    )
    w38 = body2_mass * body1_m1_z
    w39 = body4_mass * body1_m3_x
    w40 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_x) + body1_m3_y * w39 + (w29 - w6 * w30)
    w41 = body2_mass * body1_m1_x
    w42 = body1_m2_axes_2_2_0_0 * w24 + w15 * w28
    w43 = w14 * w35 + w15 * w26
    w44 = body1_mass * (body1_center_of_mass_z * body1_center_of_mass_x) + body1_m3_z * w39 + (w5 * w42 - w6 * w43)
    w45 = (
        w19
        - body1_inertia_xx
        + body1_mass * body1_center_of_mass_x**2
        + body1_m3_x * w39
        + (w27 - w31)
        + body1_m1_x * w41
    )
    w46 = body1_mass * (body1_center_of_mass_y * body1_center_of_mass_z) + w20 * body1_m3_z + (w5 * w43 + w6 * w42)
    w47 = (body2_inertia_xx + body2_inertia_yy + body2_inertia_zz) / 2.0
    w48 = w47 - body2_inertia_yy + body2_mass * body2_center_of_mass_y**2
    w49 = w47 - body2_inertia_zz + body2_mass * body2_center_of_mass_z**2
    w50 = body2_mass * (body2_center_of_mass_y * body2_center_of_mass_x)
    w51 = body2_mass * (body2_center_of_mass_z * body2_center_of_mass_x)
    w52 = w47 - body2_inertia_xx + body2_mass * body2_center_of_mass_x**2
    w53 = body2_mass * (body2_center_of_mass_y * body2_center_of_mass_z)
    w54 = (body4_inertia_xx + body4_inertia_yy + body4_inertia_zz) / 2.0
    w55 = w54 - body4_inertia_yy + body4_mass * body4_center_of_mass_y**2
    w56 = w54 - body4_inertia_zz + body4_mass * body4_center_of_mass_z**2
    w57 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_x)
    w58 = body4_mass * (body4_center_of_mass_z * body4_center_of_mass_x)
    w59 = w54 - body4_inertia_xx + body4_mass * body4_center_of_mass_x**2
    w60 = body4_mass * (body4_center_of_mass_y * body4_center_of_mass_z)
    w61 = ca.sqrt(ground_m4_axes_0_2_0_0**2 + ground_m4_axes_1_2_0_0**2)
    w62 = ground_m4_axes_0_2_0_0 / w61
    w63 = ground_m4_axes_1_2_0_0 / w61
    w64 = ground_m4_axes_0_0_0_0 * (ground_m4_axes_2_2_0_0 * w62) + ground_m4_axes_1_0_0_0 * (
        ground_m4_axes_2_2_0_0 * w63
    )
    w65 = ca.atan2(ground_m4_axes_2_0_0_0 * w61 - w64, w62 * ground_m4_axes_1_0_0_0 - ground_m4_axes_0_0_0_0 * w63)
    w66 = gravity_z * w61
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w3,  # c2
        w4,  # c3
        w5,  # c4
        body1_m2_axes_2_2_0_0,  # body1_m2_axes_2_2_0_0
        w6,  # c6
        w8,  # c7
        w9,  # c8
        w10,  # c9
        w11,  # c10
        w9 + w10 * w11,  # c11
        w12,  # c12
        w13,  # c13
        w12 + w11 * w13,  # c14
        w3 * w4,  # c15
        w14,  # c16
        w4 * w14,  # c17
        w15,  # c18
        w3 * body1_m2_axes_2_2_0_0,  # c19
        w17,  # c20
        w1 - w2,  # c21
        w18,  # c22
        2 * w18,  # c23
        2 * w14,  # c24
        body1_m3_y,  # body1_m3_y
        body1_m1_y,  # body1_m1_y
        w33,  # c27
        2 * w15,  # c28
        body1_m3_z,  # body1_m3_z
        body1_m1_z,  # body1_m1_z
        w37 + body1_m1_z * w38,  # c31
        body1_m3_x,  # body1_m3_x
        body1_m1_x,  # body1_m1_x
        w40 + body1_m1_y * w41,  # c34
        w44 + body1_m1_z * w41,  # c35
        body2_mass * body2_center_of_mass_y,  # c36
        body2_mass * body2_center_of_mass_z,  # c37
        body2_mass * body2_center_of_mass_x,  # c38
        body4_mass * body4_center_of_mass_y,  # c39
        body4_mass * body4_center_of_mass_z,  # c40
        body4_mass * body4_center_of_mass_x,  # c41
        w45,  # c42
        w46 + w32 * body1_m1_z,  # c43
        w48,  # c44
        w49,  # c45
        w48 + w49,  # c46
        w50,  # c47
        -w50,  # c48
        w51,  # c49
        -w51,  # c50
        w52,  # c51
        w49 + w52,  # c52
        w53,  # c53
        -w53,  # c54
        w48 + w52,  # c55
        w55,  # c56
        w56,  # c57
        w55 + w56,  # c58
        w57,  # c59
        -w57,  # c60
        w58,  # c61
        -w58,  # c62
        w59,  # c63
        w56 + w59,  # c64
        w60,  # c65
        -w60,  # c66
        w55 + w59,  # c67
        gravity_z,  # gravity_z
        w65,  # c69
        body5_mass * body5_center_of_mass_y * w66,  # c70
        w66 * (body5_mass * body5_center_of_mass_x),  # c71
        w38 + (w36 + (w34 + body1_mass * body1_center_of_mass_z)),  # c72
        w32 + (w20 + body1_mass * body1_center_of_mass_y + (w5 * w26 + w6 * w28)),  # c73
        w41 + (w39 + body1_mass * body1_center_of_mass_x + (w5 * w28 - w6 * w26)),  # c74
        body1_m2_x,  # body1_m2_x
        body1_m2_y,  # body1_m2_y
        body1_m2_z,  # body1_m2_z
        ground_m0_x,  # ground_m0_x
        ground_m0_y,  # ground_m0_y
        ground_m0_z,  # ground_m0_z
        body1_m2_quaternion_0_0_0,  # body1_m2_quaternion_0_0_0
        body1_m2_quaternion_3_0_0,  # body1_m2_quaternion_3_0_0
        body1_m2_quaternion_1_0_0,  # body1_m2_quaternion_1_0_0
        body1_m2_quaternion_2_0_0,  # body1_m2_quaternion_2_0_0
        ground_m4_x,  # ground_m4_x
        ground_m4_y,  # ground_m4_y
        ground_m4_z,  # ground_m4_z
        ground_m4_quaternion_0_0_0,  # ground_m4_quaternion_0_0_0
        ground_m4_quaternion_3_0_0,  # ground_m4_quaternion_3_0_0
        ground_m4_quaternion_1_0_0,  # ground_m4_quaternion_1_0_0
        ground_m4_quaternion_2_0_0,  # ground_m4_quaternion_2_0_0
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 11) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 11) [mixed]: rates of the independent coordinates
    takes c (n_const = 92) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 11 x 11) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 11) [N, N m]: condensed force S^T (Q* - M s)
    1162 operations.
    """
    q_i = ca.SX.sym("q_i", 11)
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 11)
    c = ca.SX.sym("c", 92)
    j2_angle = q_i[0]
    j4_angle = q_i[1]
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
    j2_angle_dot = q_i_dot[0]
    body1_omega_x = q_i_dot[2]
    body1_omega_y = q_i_dot[3]
    body1_omega_z = q_i_dot[4]
    body2_omega_x = q_i_dot[5]
    body2_omega_y = q_i_dot[6]
    body2_omega_z = q_i_dot[7]
    body4_omega_x = q_i_dot[8]
    body4_omega_y = q_i_dot[9]
    body4_omega_z = q_i_dot[10]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    body1_m2_axes_2_2_0_0 = c[5]
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
    c24 = c[24]
    body1_m3_y = c[25]
    body1_m1_y = c[26]
    c27 = c[27]
    c28 = c[28]
    body1_m3_z = c[29]
    body1_m1_z = c[30]
    c31 = c[31]
    body1_m3_x = c[32]
    body1_m1_x = c[33]
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
    c67 = c[67]
    gravity_z = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    # intermediate terms (271)
    w0 = j2_angle + c7
    w1 = ca.sin(w0)
    w2 = ca.cos(w0)
    w3 = w1 * c11 + w2 * c14
    w4 = w2 * c9 - w1 * c13
    w5 = w2 * c13 + w1 * c9
    w6 = w3 * body1_m2_axes_2_2_0_0 + c15 + w4 * c17 + w5 * c18
    w7 = w1 * c14
    w8 = w2 * c11
    w9 = w4 * body1_m2_axes_2_2_0_0
    w10 = w7 - w8 - w9 * c18
    w11 = w6 * c4 - w10 * c6
    w12 = w10 * c4 + w6 * c6
    w13 = c19 - w3 * c3 + w9 * c16
    w14 = w1 * c21 + w2 * c23
    w15 = w1 * w14
    w16 = c1 + w15
    w17 = w16 * c3 + 2 * w3 * body1_m2_axes_2_2_0_0
    w18 = w17 * c3
    w19 = w16 - w18
    w20 = c0 - w15 + w4 * c24
    w21 = w2 * w14 - c22
    w22 = w8 - w7
    w23 = w5 * body1_m2_axes_2_2_0_0
    w24 = w21 * body1_m2_axes_2_2_0_0 - w22 * c3 + w23 * c16
    w25 = (w20 - w19) * c4 - 2 * w24 * c6
    w26 = w25 * c4
    w27 = w19 + w26 + c27
    w28 = w5 * c3
    w29 = w18 + w28 * c28 + c31
    w30 = -(c34 - (w24 + w25 * c6))
    w31 = w21 * c3 + w22 * body1_m2_axes_2_2_0_0 + w28 * c16 + w4 * c18
    w32 = w17 * body1_m2_axes_2_2_0_0 - w3 + w23 * c18
    w33 = -(c35 - (w31 * c6 + w32 * c4))
    w34 = 2 * body1_e1
    w35 = w34 * body1_e3
    w36 = 2 * body1_e2
    w37 = w36 * body1_e0
    w38 = w35 + w37
    w39 = 2 * body2_e1
    w40 = w39 * body2_e3
    w41 = 2 * body2_e2
    w42 = w41 * body2_e0
    w43 = w40 + w42
    w44 = w39 * body2_e2
    w45 = 2 * body2_e3
    w46 = body2_e0 * w45
    w47 = w44 - w46
    w48 = w43 * c36 - w47 * c37
    w49 = body1_e3 * w36
    w50 = w34 * body1_e0
    w51 = w49 - w50
    w52 = body2_e3 * w41
    w53 = w39 * body2_e0
    w54 = w52 - w53
    w55 = body2_e1 * w39
    w56 = body2_e3 * w45
    w57 = 1.0 - (w55 + w56)
    w58 = w54 * c36 - w57 * c37
    w59 = body1_e1 * w34
    w60 = body1_e2 * w36
    w61 = 1.0 - (w59 + w60)
    w62 = body2_e2 * w41
    w63 = 1.0 - (w55 + w62)
    w64 = w52 + w53
    w65 = w63 * c36 - w64 * c37
    w66 = w38 * w48 + w51 * w58 + w61 * w65
    w67 = w34 * body1_e2
    w68 = 2 * body1_e3
    w69 = body1_e0 * w68
    w70 = w67 - w69
    w71 = body1_e3 * w68
    w72 = 1.0 - (w59 + w71)
    w73 = w49 + w50
    w74 = w48 * w70 + w58 * w72 + w65 * w73
    w75 = w66 * body1_m1_y - w74 * body1_m1_z
    w76 = 1.0 - (w56 + w62)
    w77 = w76 * c37 - w43 * c38
    w78 = w44 + w46
    w79 = w78 * c37 - w54 * c38
    w80 = w40 - w42
    w81 = w80 * c37 - w63 * c38
    w82 = w38 * w77 + w51 * w79 + w61 * w81
    w83 = w70 * w77 + w72 * w79 + w73 * w81
    w84 = w82 * body1_m1_y - w83 * body1_m1_z
    w85 = w47 * c38 - w76 * c36
    w86 = w57 * c38 - w78 * c36
    w87 = w64 * c38 - w80 * c36
    w88 = w38 * w85 + w51 * w86 + w61 * w87
    w89 = w70 * w85 + w72 * w86 + w73 * w87
    w90 = w88 * body1_m1_y - w89 * body1_m1_z
    w91 = 2 * body4_e1
    w92 = w91 * body4_e3
    w93 = 2 * body4_e2
    w94 = w93 * body4_e0
    w95 = w92 + w94
    w96 = w91 * body4_e2
    w97 = 2 * body4_e3
    w98 = body4_e0 * w97
    w99 = w96 - w98
    w100 = w95 * c39 - w99 * c40
    w101 = body4_e3 * w93
    w102 = w91 * body4_e0
    w103 = w101 - w102
    w104 = body4_e1 * w91
    w105 = body4_e3 * w97
    w106 = 1.0 - (w104 + w105)
    w107 = w103 * c39 - w106 * c40
    w108 = body4_e2 * w93
    w109 = 1.0 - (w104 + w108)
    w110 = w101 + w102
    w111 = w109 * c39 - w110 * c40
    w112 = w38 * w100 + w51 * w107 + w61 * w111
    w113 = w70 * w100 + w72 * w107 + w73 * w111
    w114 = w112 * body1_m3_y - w113 * body1_m3_z
    w115 = 1.0 - (w105 + w108)
    w116 = w115 * c40 - w95 * c41
    w117 = w96 + w98
    w118 = w117 * c40 - w103 * c41
    w119 = w92 - w94
    w120 = w119 * c40 - w109 * c41
    w121 = w38 * w116 + w51 * w118 + w61 * w120
    w122 = w70 * w116 + w72 * w118 + w73 * w120
    w123 = w121 * body1_m3_y - w122 * body1_m3_z
    w124 = w99 * c41 - w115 * c39
    w125 = w106 * c41 - w117 * c39
    w126 = w110 * c41 - w119 * c39
    w127 = w38 * w124 + w51 * w125 + w61 * w126
    w128 = w70 * w124 + w72 * w125 + w73 * w126
    w129 = w127 * body1_m3_y - w128 * body1_m3_z
    w130 = w20 - w26 + c42
    w131 = -(w31 * c4 - w32 * c6 + c43)
    w132 = 1.0 - (w60 + w71)
    w133 = w67 + w69
    w134 = w35 - w37
    w135 = w48 * w132 + w58 * w133 + w65 * w134
    w136 = w135 * body1_m1_z - w66 * body1_m1_x
    w137 = w77 * w132 + w79 * w133 + w81 * w134
    w138 = w137 * body1_m1_z - w82 * body1_m1_x
    w139 = w85 * w132 + w86 * w133 + w87 * w134
    w140 = w139 * body1_m1_z - w88 * body1_m1_x
    w141 = w100 * w132 + w107 * w133 + w111 * w134
    w142 = w141 * body1_m3_z - w112 * body1_m3_x
    w143 = w116 * w132 + w118 * w133 + w120 * w134
    w144 = w143 * body1_m3_z - w121 * body1_m3_x
    w145 = w124 * w132 + w125 * w133 + w126 * w134
    w146 = w145 * body1_m3_z - w127 * body1_m3_x
    w147 = w74 * body1_m1_x - w135 * body1_m1_y
    w148 = w83 * body1_m1_x - w137 * body1_m1_y
    w149 = w89 * body1_m1_x - w139 * body1_m1_y
    w150 = w113 * body1_m3_x - w141 * body1_m3_y
    w151 = w122 * body1_m3_x - w143 * body1_m3_y
    w152 = w128 * body1_m3_x - w145 * body1_m3_y
    w153 = w134 * gravity_z
    w154 = w73 * gravity_z
    w155 = body1_omega_x * c4 + body1_omega_y * c6
    w156 = body1_omega_y * c4 - body1_omega_x * c6
    w157 = w153 * c4 + w154 * c6 - w155 * body1_omega_z * c18 - w155 * w156 * c16
    w158 = body1_omega_z * w156
    w159 = w61 * gravity_z
    w160 = w155**2
    w161 = w158 * c16 - (w159 + (w156**2 + w160) * c18)
    w162 = w157 * body1_m2_axes_2_2_0_0 + w161 * c3
    w163 = body1_omega_z**2
    w164 = w153 * c6 - w154 * c4 + w158 * c18 - (w160 + w163) * c16
    w165 = body1_omega_z * c3 - w155 * body1_m2_axes_2_2_0_0
    w166 = w2 * w165 - w1 * w156
    w167 = w155 * c3 + body1_omega_z * body1_m2_axes_2_2_0_0 + j2_angle_dot
    w168 = w166 * w167
    w169 = w166 * j2_angle_dot
    w170 = w168 - w169
    w171 = w2 * w156 + w1 * w165
    w172 = w167 * w171
    w173 = j2_angle_dot * w171
    w174 = w172 - w173
    w175 = w166 * w171
    w176 = w171**2
    w177 = w167**2
    w178 = w176 + w177
    w179 = w166**2
    w180 = w177 + w179
    w181 = (
        (w2 * w162 - w1 * w164 + w170 * c10) * c9
        - (w2 * w164 + w1 * w162 + w174 * c10) * c13
        + (w175 * c0 - w178 * c22 + w170 * c8 - (w175 * c1 - w180 * c22 + w174 * c12))
    )
    w182 = j4_angle + c69
    w183 = body4_omega_x * body4_omega_y
    w184 = body4_omega_y**2
    w185 = body4_omega_z**2
    w186 = w184 + w185
    w187 = body4_omega_x * body4_omega_z
    w188 = w183 * c39 - w186 * c41 + w187 * c40
    w189 = body4_omega_x**2
    w190 = w185 + w189
    w191 = body4_omega_y * body4_omega_z
    w192 = w183 * c41 - w190 * c39 + w191 * c40
    w193 = w184 + w189
    w194 = w187 * c41 + w191 * c39 - w193 * c40
    w195 = w115 * w188 + w99 * w192 + w95 * w194
    w196 = w117 * w188 + w106 * w192 + w103 * w194
    w197 = w119 * w188 + w110 * w192 + w109 * w194
    w198 = w38 * w195 + w51 * w196 + w61 * w197
    w199 = w70 * w195 + w72 * w196 + w73 * w197
    w200 = w176 + w179
    w201 = w161 * body1_m2_axes_2_2_0_0 - w157 * c3 - w200 * c10
    w202 = w172 + w173
    w203 = w168 + w169
    w204 = w175 * c9 - w178 * c13
    w205 = w201 * c13 + (w202 * c22 + w203 * c1 - w200 * c12 - (w175 * c8 - w178 * c12)) - w204 * c10
    w206 = w175 * c13 - w180 * c9
    w207 = w175 * c12 - w180 * c8 - (w202 * c0 + w203 * c22 - w200 * c8) - w201 * c9 + w206 * c10
    w208 = w1 * w206 + w2 * w204
    w209 = w202 * c9 + w203 * c13
    w210 = w208 * body1_m2_axes_2_2_0_0 - w209 * c3
    w211 = w2 * w205 - w1 * w207 - w210 * c18
    w212 = w1 * w205 + w2 * w207
    w213 = (
        w212 * body1_m2_axes_2_2_0_0
        - w181 * c3
        - (w208 * c3 + w209 * body1_m2_axes_2_2_0_0) * c16
        + (w2 * w206 - w1 * w204) * c18
    )
    w214 = body2_omega_x * body2_omega_y
    w215 = body2_omega_y**2
    w216 = body2_omega_z**2
    w217 = w215 + w216
    w218 = body2_omega_x * body2_omega_z
    w219 = w214 * c36 - w217 * c38 + w218 * c37
    w220 = body2_omega_x**2
    w221 = w216 + w220
    w222 = body2_omega_y * body2_omega_z
    w223 = w214 * c38 - w221 * c36 + w222 * c37
    w224 = w215 + w220
    w225 = w218 * c38 + w222 * c36 - w224 * c37
    w226 = w76 * w219 + w47 * w223 + w43 * w225
    w227 = w78 * w219 + w57 * w223 + w54 * w225
    w228 = w80 * w219 + w64 * w223 + w63 * w225
    w229 = w38 * w226 + w51 * w227 + w61 * w228
    w230 = w70 * w226 + w72 * w227 + w73 * w228
    w231 = w198 * body1_m3_y - w199 * body1_m3_z - (w211 * c6 + w213 * c4) + (w229 * body1_m1_y - w230 * body1_m1_z)
    w232 = body1_omega_x * body1_omega_z
    w233 = body1_omega_y * body1_omega_z
    w234 = body1_omega_x**2
    w235 = body1_omega_y**2
    w236 = w234 + w235
    w237 = body1_omega_x * body1_omega_y
    w238 = w163 + w234
    w239 = w154 * c72 - w159 * c73 + (w232 * c34 + w233 * c27 - w236 * c43 - (w237 * c35 - w238 * c43 + w233 * c31))
    w240 = w132 * w195 + w133 * w196 + w134 * w197
    w241 = w132 * w226 + w133 * w227 + w134 * w228
    w242 = w240 * body1_m3_z - w198 * body1_m3_x + (w211 * c4 - w213 * c6) + (w241 * body1_m1_z - w229 * body1_m1_x)
    w243 = w163 + w235
    w244 = w159 * c74 - w153 * c72 + (w237 * c43 - w243 * c35 + w232 * c31 - (w232 * c42 + w233 * c34 - w236 * c35))
    w245 = (
        w199 * body1_m3_x
        - w240 * body1_m3_y
        + (w212 * c3 + w181 * body1_m2_axes_2_2_0_0 + w210 * c16)
        + (w230 * body1_m1_x - w241 * body1_m1_y)
    )
    w246 = w153 * c73 - w154 * c74 + (w237 * c42 - w238 * c34 + w233 * c35 - (w237 * c27 - w243 * c34 + w232 * c43))
    w247 = w237 * body1_m1_y - w243 * body1_m1_x + w232 * body1_m1_z - w153
    w248 = w237 * body1_m1_x - w238 * body1_m1_y + w233 * body1_m1_z - w154
    w249 = w232 * body1_m1_x + w233 * body1_m1_y - w236 * body1_m1_z - w159
    w250 = w132 * w247 + w70 * w248 + w38 * w249
    w251 = w133 * w247 + w72 * w248 + w51 * w249
    w252 = w134 * w247 + w73 * w248 + w61 * w249
    w253 = w43 * w250 + w54 * w251 + w63 * w252
    w254 = w47 * w250 + w57 * w251 + w64 * w252
    w255 = w253 * c36 - w254 * c37 + (w218 * c47 + w222 * c44 - w224 * c53 - (w214 * c49 - w221 * c53 + w222 * c45))
    w256 = w76 * w250 + w78 * w251 + w80 * w252
    w257 = w256 * c37 - w253 * c38 + (w214 * c53 - w217 * c49 + w218 * c45 - (w218 * c51 + w222 * c47 - w224 * c49))
    w258 = w254 * c38 - w256 * c36 + (w214 * c51 - w221 * c47 + w222 * c49 - (w214 * c44 - w217 * c47 + w218 * c53))
    w259 = w237 * body1_m3_y - w243 * body1_m3_x + w232 * body1_m3_z - w153
    w260 = w237 * body1_m3_x - w238 * body1_m3_y + w233 * body1_m3_z - w154
    w261 = w232 * body1_m3_x + w233 * body1_m3_y - w236 * body1_m3_z - w159
    w262 = w132 * w259 + w70 * w260 + w38 * w261
    w263 = w133 * w259 + w72 * w260 + w51 * w261
    w264 = w134 * w259 + w73 * w260 + w61 * w261
    w265 = w95 * w262 + w103 * w263 + w109 * w264
    w266 = w99 * w262 + w106 * w263 + w110 * w264
    w267 = w265 * c39 - w266 * c40 + (w187 * c59 + w191 * c56 - w193 * c65 - (w183 * c61 - w190 * c65 + w191 * c57))
    w268 = w115 * w262 + w117 * w263 + w119 * w264
    w269 = w268 * c40 - w265 * c41 + (w183 * c65 - w186 * c61 + w187 * c57 - (w187 * c63 + w191 * c59 - w193 * c61))
    w270 = w266 * c41 - w268 * c39 + (w183 * c63 - w190 * c59 + w191 * c61 - (w183 * c56 - w186 * c59 + w187 * c65))
    # outputs
    M_hat = ca.SX(11, 11)
    # j2.angle
    M_hat[0, 0] = c2
    M_hat[0, 2] = w11
    M_hat[0, 3] = w12
    M_hat[0, 4] = w13
    # j4.angle
    M_hat[1, 1] = c20
    # body1.turn_x
    M_hat[2, 0] = w11
    M_hat[2, 2] = w27 + w29
    M_hat[2, 3] = w30
    M_hat[2, 4] = w33
    M_hat[2, 5] = w75
    M_hat[2, 6] = w84
    M_hat[2, 7] = w90
    M_hat[2, 8] = w114
    M_hat[2, 9] = w123
    M_hat[2, 10] = w129
    # body1.turn_y
    M_hat[3, 0] = w12
    M_hat[3, 2] = w30
    M_hat[3, 3] = w29 + w130
    M_hat[3, 4] = w131
    M_hat[3, 5] = w136
    M_hat[3, 6] = w138
    M_hat[3, 7] = w140
    M_hat[3, 8] = w142
    M_hat[3, 9] = w144
    M_hat[3, 10] = w146
    # body1.turn_z
    M_hat[4, 0] = w13
    M_hat[4, 2] = w33
    M_hat[4, 3] = w131
    M_hat[4, 4] = w27 + w130
    M_hat[4, 5] = w147
    M_hat[4, 6] = w148
    M_hat[4, 7] = w149
    M_hat[4, 8] = w150
    M_hat[4, 9] = w151
    M_hat[4, 10] = w152
    # body2.turn_x
    M_hat[5, 2] = w75
    M_hat[5, 3] = w136
    M_hat[5, 4] = w147
    M_hat[5, 5] = c46
    M_hat[5, 6] = c48
    M_hat[5, 7] = c50
    # body2.turn_y
    M_hat[6, 2] = w84
    M_hat[6, 3] = w138
    M_hat[6, 4] = w148
    M_hat[6, 5] = c48
    M_hat[6, 6] = c52
    M_hat[6, 7] = c54
    # body2.turn_z
    M_hat[7, 2] = w90
    M_hat[7, 3] = w140
    M_hat[7, 4] = w149
    M_hat[7, 5] = c50
    M_hat[7, 6] = c54
    M_hat[7, 7] = c55
    # body4.turn_x
    M_hat[8, 2] = w114
    M_hat[8, 3] = w142
    M_hat[8, 4] = w150
    M_hat[8, 8] = c58
    M_hat[8, 9] = c60
    M_hat[8, 10] = c62
    # body4.turn_y
    M_hat[9, 2] = w123
    M_hat[9, 3] = w144
    M_hat[9, 4] = w151
    M_hat[9, 8] = c60
    M_hat[9, 9] = c64
    M_hat[9, 10] = c66
    # body4.turn_z
    M_hat[10, 2] = w129
    M_hat[10, 3] = w146
    M_hat[10, 4] = w152
    M_hat[10, 8] = c62
    M_hat[10, 9] = c66
    M_hat[10, 10] = c67
    Q_hat = ca.vertcat(
        -w181,  # j2.angle
        -(ca.sin(w182) * c70 - ca.cos(w182) * c71),  # j4.angle
        -(w231 + w239),  # body1.turn_x
        -(w242 + w244),  # body1.turn_y
        -(w245 + w246),  # body1.turn_z
        -w255,  # body2.turn_x
        -w257,  # body2.turn_y
        -w258,  # body2.turn_z
        -w267,  # body4.turn_x
        -w269,  # body4.turn_y
        -w270,  # body4.turn_z
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 11) [mixed]: independent coordinates, in the order of the partition
    takes chart (4 x orientations = 12) [1]: unit quaternions from which turns are rotation vectors
    takes c (n_const = 92) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 35) [mixed]: dependent coordinates after one Newton step
    352 operations.
    """
    q_i = ca.SX.sym("q_i", 11)
    chart = ca.SX.sym("chart", 12)
    c = ca.SX.sym("c", 92)
    j2_angle = q_i[0]
    j4_angle = q_i[1]
    body1_turn_x = q_i[2]
    body1_turn_y = q_i[3]
    body1_turn_z = q_i[4]
    body2_turn_x = q_i[5]
    body2_turn_y = q_i[6]
    body2_turn_z = q_i[7]
    body4_turn_x = q_i[8]
    body4_turn_y = q_i[9]
    body4_turn_z = q_i[10]
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
    body1_m3_y = c[25]
    body1_m1_y = c[26]
    body1_m3_z = c[29]
    body1_m1_z = c[30]
    body1_m3_x = c[32]
    body1_m1_x = c[33]
    body1_m2_x = c[75]
    body1_m2_y = c[76]
    body1_m2_z = c[77]
    ground_m0_x = c[78]
    ground_m0_y = c[79]
    ground_m0_z = c[80]
    body1_m2_quaternion_0_0_0 = c[81]
    body1_m2_quaternion_3_0_0 = c[82]
    body1_m2_quaternion_1_0_0 = c[83]
    body1_m2_quaternion_2_0_0 = c[84]
    ground_m4_x = c[85]
    ground_m4_y = c[86]
    ground_m4_z = c[87]
    ground_m4_quaternion_0_0_0 = c[88]
    ground_m4_quaternion_3_0_0 = c[89]
    ground_m4_quaternion_1_0_0 = c[90]
    ground_m4_quaternion_2_0_0 = c[91]
    # intermediate terms (52)
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
    w12 = 1.0 - w10 - w11
    w13 = 2 * w7
    w14 = w8 * w13
    w15 = 2 * w6
    w16 = w9 * w15
    w17 = w14 - w16
    w18 = w8 * w15
    w19 = w9 * w13
    w20 = w18 + w19
    w21 = w14 + w16
    w22 = 1.0 - 2 * w7**2
    w23 = w22 - w11
    w24 = w9 * (2 * w8)
    w25 = w7 * w15
    w26 = w24 - w25
    w27 = w19 - w18
    w28 = w24 + w25
    w29 = w22 - w10
    w30 = ca.sqrt(1e-300 + (body2_turn_x**2 + body2_turn_y**2 + body2_turn_z**2) / 4.0)
    w31 = ca.cos(w30)
    w32 = ca.sin(w30) / w30 / 2.0
    w33 = body2_turn_x * w32
    w34 = body2_turn_y * w32
    w35 = body2_turn_z * w32
    w36 = j2_angle / 2.0
    w37 = ca.cos(w36)
    w38 = ca.sin(w36)
    w39 = w37 * body1_m2_quaternion_0_0_0 - w38 * body1_m2_quaternion_3_0_0
    w40 = w37 * body1_m2_quaternion_1_0_0 + w38 * body1_m2_quaternion_2_0_0
    w41 = w37 * body1_m2_quaternion_2_0_0 - w38 * body1_m2_quaternion_1_0_0
    w42 = w38 * body1_m2_quaternion_0_0_0 + w37 * body1_m2_quaternion_3_0_0
    w43 = ca.sqrt(1e-300 + (body4_turn_x**2 + body4_turn_y**2 + body4_turn_z**2) / 4.0)
    w44 = ca.cos(w43)
    w45 = ca.sin(w43) / w43 / 2.0
    w46 = body4_turn_x * w45
    w47 = body4_turn_y * w45
    w48 = body4_turn_z * w45
    w49 = j4_angle / 2.0
    w50 = ca.cos(w49)
    w51 = ca.sin(w49)
    # outputs
    q_d_next = ca.vertcat(
        ground_m0_x,  # body1.x
        ground_m0_y,  # body1.y
        ground_m0_z,  # body1.z
        w6,  # body1.e0
        w7,  # body1.e1
        w8,  # body1.e2
        w9,  # body1.e3
        ground_m0_x + (w12 * body1_m1_x + w17 * body1_m1_y + w20 * body1_m1_z),  # body2.x
        ground_m0_y + (w21 * body1_m1_x + w23 * body1_m1_y + w26 * body1_m1_z),  # body2.y
        ground_m0_z + (w27 * body1_m1_x + w28 * body1_m1_y + w29 * body1_m1_z),  # body2.z
        body2_chart_0 * w31 - (body2_chart_1 * w33 + body2_chart_2 * w34 + body2_chart_3 * w35),  # body2.e0
        body2_chart_0 * w33 + w31 * body2_chart_1 + (body2_chart_2 * w35 - w34 * body2_chart_3),  # body2.e1
        body2_chart_0 * w34 + w31 * body2_chart_2 + (w33 * body2_chart_3 - body2_chart_1 * w35),  # body2.e2
        body2_chart_0 * w35 + w31 * body2_chart_3 + (body2_chart_1 * w34 - w33 * body2_chart_2),  # body2.e3
        ground_m0_x + (w12 * body1_m2_x + w17 * body1_m2_y + w20 * body1_m2_z),  # body3.x
        ground_m0_y + (w21 * body1_m2_x + w23 * body1_m2_y + w26 * body1_m2_z),  # body3.y
        ground_m0_z + (w27 * body1_m2_x + w28 * body1_m2_y + w29 * body1_m2_z),  # body3.z
        w6 * w39 - (w7 * w40 + w8 * w41 + w9 * w42),  # body3.e0
        w6 * w40 + w7 * w39 + (w8 * w42 - w9 * w41),  # body3.e1
        w6 * w41 + w8 * w39 + (w9 * w40 - w7 * w42),  # body3.e2
        w6 * w42 + w9 * w39 + (w7 * w41 - w8 * w40),  # body3.e3
        ground_m0_x + (w12 * body1_m3_x + w17 * body1_m3_y + w20 * body1_m3_z),  # body4.x
        ground_m0_y + (w21 * body1_m3_x + w23 * body1_m3_y + w26 * body1_m3_z),  # body4.y
        ground_m0_z + (w27 * body1_m3_x + w28 * body1_m3_y + w29 * body1_m3_z),  # body4.z
        body4_chart_0 * w44 - (body4_chart_1 * w46 + body4_chart_2 * w47 + body4_chart_3 * w48),  # body4.e0
        body4_chart_0 * w46 + w44 * body4_chart_1 + (body4_chart_2 * w48 - w47 * body4_chart_3),  # body4.e1
        body4_chart_0 * w47 + w44 * body4_chart_2 + (w46 * body4_chart_3 - body4_chart_1 * w48),  # body4.e2
        body4_chart_0 * w48 + w44 * body4_chart_3 + (body4_chart_1 * w47 - w46 * body4_chart_2),  # body4.e3
        ground_m4_x,  # body5.x
        ground_m4_y,  # body5.y
        ground_m4_z,  # body5.z
        w50 * ground_m4_quaternion_0_0_0 - w51 * ground_m4_quaternion_3_0_0,  # body5.e0
        w50 * ground_m4_quaternion_1_0_0 + w51 * ground_m4_quaternion_2_0_0,  # body5.e1
        w50 * ground_m4_quaternion_2_0_0 - w51 * ground_m4_quaternion_1_0_0,  # body5.e2
        w51 * ground_m4_quaternion_0_0_0 + w50 * ground_m4_quaternion_3_0_0,  # body5.e3
    )
    inputs, outputs = [q_i, chart, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "chart", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 11) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 35) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 11) [mixed]: rates of the independent coordinates
    takes c (n_const = 92) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 35) [mixed]: rates of the dependent coordinates
    502 operations.
    """
    q_i = ca.SX.sym("q_i", 11)
    q_d = ca.SX.sym("q_d", 35)
    q_i_dot = ca.SX.sym("q_i_dot", 11)
    c = ca.SX.sym("c", 92)
    j2_angle = q_i[0]
    j4_angle = q_i[1]
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
    j2_angle_dot = q_i_dot[0]
    j4_angle_dot = q_i_dot[1]
    body1_omega_x = q_i_dot[2]
    body1_omega_y = q_i_dot[3]
    body1_omega_z = q_i_dot[4]
    body2_omega_x = q_i_dot[5]
    body2_omega_y = q_i_dot[6]
    body2_omega_z = q_i_dot[7]
    body4_omega_x = q_i_dot[8]
    body4_omega_y = q_i_dot[9]
    body4_omega_z = q_i_dot[10]
    body1_m3_y = c[25]
    body1_m1_y = c[26]
    body1_m3_z = c[29]
    body1_m1_z = c[30]
    body1_m3_x = c[32]
    body1_m1_x = c[33]
    body1_m2_x = c[75]
    body1_m2_y = c[76]
    body1_m2_z = c[77]
    body1_m2_quaternion_0_0_0 = c[81]
    body1_m2_quaternion_3_0_0 = c[82]
    body1_m2_quaternion_1_0_0 = c[83]
    body1_m2_quaternion_2_0_0 = c[84]
    ground_m4_quaternion_0_0_0 = c[88]
    ground_m4_quaternion_3_0_0 = c[89]
    ground_m4_quaternion_1_0_0 = c[90]
    ground_m4_quaternion_2_0_0 = c[91]
    # intermediate terms (88)
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
    w13 = w10 - w12
    w14 = body1_e1 * w11
    w15 = 2 * body1_e2
    w16 = body1_e3 * w15
    w17 = w14 + w16
    w18 = 1.0 - 2 * body1_e1**2
    w19 = 2 * body1_e2**2
    w20 = w18 - w19
    w21 = w13 * body1_m1_x + w17 * body1_m1_y + w20 * body1_m1_z
    w22 = body1_e2 * -2.0
    w23 = body1_e3 * w11
    w24 = body1_e2 * w9
    w25 = w23 + w24
    w26 = 2 * body1_e3**2
    w27 = w18 - w26
    w28 = w16 - w14
    w29 = w25 * body1_m1_x + w27 * body1_m1_y + w28 * body1_m1_z
    w30 = body1_e3 * -2.0
    w31 = w29 * w30
    w32 = w11 * w21
    w33 = body1_e1 * -2.0
    w34 = w21 * w33
    w35 = w11 * w29
    w36 = 1.0 - w19 - w26
    w37 = w24 - w23
    w38 = w10 + w12
    w39 = w36 * body1_m1_x + w37 * body1_m1_y + w38 * body1_m1_z
    w40 = w22 * w39
    w41 = w11 * w39
    w42 = body2_e1 * 0.5
    w43 = body2_e2 * 0.5
    w44 = body2_e3 * 0.5
    w45 = body2_e0 * 0.5
    w46 = w13 * body1_m2_x + w17 * body1_m2_y + w20 * body1_m2_z
    w47 = w25 * body1_m2_x + w27 * body1_m2_y + w28 * body1_m2_z
    w48 = w30 * w47
    w49 = w11 * w46
    w50 = w33 * w46
    w51 = w11 * w47
    w52 = w36 * body1_m2_x + w37 * body1_m2_y + w38 * body1_m2_z
    w53 = w22 * w52
    w54 = w11 * w52
    w55 = j2_angle / 2.0
    w56 = ca.cos(w55)
    w57 = ca.sin(w55)
    w58 = w56 * body1_m2_quaternion_0_0_0 - w57 * body1_m2_quaternion_3_0_0
    w59 = w56 * body1_m2_quaternion_1_0_0 + w57 * body1_m2_quaternion_2_0_0
    w60 = w56 * body1_m2_quaternion_2_0_0 - w57 * body1_m2_quaternion_1_0_0
    w61 = w57 * body1_m2_quaternion_0_0_0 + w56 * body1_m2_quaternion_3_0_0
    w62 = w57 / 2.0
    w63 = w56 / 2.0
    w64 = w62 * body1_m2_quaternion_0_0_0 + w63 * body1_m2_quaternion_3_0_0
    w65 = w63 * body1_m2_quaternion_2_0_0 - w62 * body1_m2_quaternion_1_0_0
    w66 = w62 * body1_m2_quaternion_2_0_0 + w63 * body1_m2_quaternion_1_0_0
    w67 = w63 * body1_m2_quaternion_0_0_0 - w62 * body1_m2_quaternion_3_0_0
    w68 = (
        w3 * w58
        + w5 * w59
        + w6 * w60
        + w7 * w61
        + (body1_e0 * w64 + (body1_e1 * w65 - body1_e2 * w66 + body1_e3 * w67)) * j2_angle_dot
    )
    w69 = (
        w5 * w58
        - w3 * w59
        + w6 * w61
        - w7 * w60
        + j2_angle_dot * (body1_e0 * w65 - body1_e1 * w64 + (body1_e2 * w67 + body1_e3 * w66))
    )
    w70 = (
        w6 * w58
        - (w3 * w60 + w5 * w61)
        + w7 * w59
        + j2_angle_dot * (body1_e3 * w65 - body1_e1 * w67 - (body1_e0 * w66 + body1_e2 * w64))
    )
    w71 = (
        w5 * w60
        - w3 * w61
        - w6 * w59
        + w7 * w58
        + j2_angle_dot * (body1_e0 * w67 - body1_e3 * w64 - (body1_e1 * w66 + body1_e2 * w65))
    )
    w72 = w13 * body1_m3_x + w17 * body1_m3_y + w20 * body1_m3_z
    w73 = w25 * body1_m3_x + w27 * body1_m3_y + w28 * body1_m3_z
    w74 = w30 * w73
    w75 = w11 * w72
    w76 = w33 * w72
    w77 = w11 * w73
    w78 = w36 * body1_m3_x + w37 * body1_m3_y + w38 * body1_m3_z
    w79 = w22 * w78
    w80 = w11 * w78
    w81 = body4_e1 * 0.5
    w82 = body4_e2 * 0.5
    w83 = body4_e3 * 0.5
    w84 = body4_e0 * 0.5
    w85 = j4_angle / 2.0
    w86 = ca.sin(w85) / 2.0
    w87 = ca.cos(w85) / 2.0
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # body1.x
        0.0,  # body1.y
        0.0,  # body1.z
        -w3,  # body1.e0
        w5,  # body1.e1
        w6,  # body1.e2
        w7,  # body1.e3
        w5 * (w8 * w21 - w22 * w29) - w3 * (w21 * w22 - w31) + w6 * (w32 - w9 * w29) + w7 * (w34 - w35),  # body2.x
        w5 * (w40 - w32) - w3 * (w30 * w39 - w34) + w6 * (w9 * w39 - w21 * w30) + w7 * (w41 - w15 * w21),  # body2.y
        w5 * (w35 - w8 * w39) - w3 * (w29 * w33 - w40) + w6 * (w31 - w41) + w7 * (w15 * w29 - w33 * w39),  # body2.z
        -(w42 * body2_omega_x + w43 * body2_omega_y + w44 * body2_omega_z),  # body2.e0
        body2_omega_x * w45 - body2_omega_y * w44 + w43 * body2_omega_z,  # body2.e1
        body2_omega_x * w44 + body2_omega_y * w45 - w42 * body2_omega_z,  # body2.e2
        w42 * body2_omega_y - body2_omega_x * w43 + body2_omega_z * w45,  # body2.e3
        w5 * (w8 * w46 - w22 * w47) - w3 * (w22 * w46 - w48) + w6 * (w49 - w9 * w47) + w7 * (w50 - w51),  # body3.x
        w5 * (w53 - w49) - w3 * (w30 * w52 - w50) + w6 * (w9 * w52 - w30 * w46) + w7 * (w54 - w15 * w46),  # body3.y
        w5 * (w51 - w8 * w52) - w3 * (w33 * w47 - w53) + w6 * (w48 - w54) + w7 * (w15 * w47 - w33 * w52),  # body3.z
        -w68,  # body3.e0
        w69,  # body3.e1
        w70,  # body3.e2
        w71,  # body3.e3
        w5 * (w8 * w72 - w22 * w73) - w3 * (w22 * w72 - w74) + w6 * (w75 - w9 * w73) + w7 * (w76 - w77),  # body4.x
        w5 * (w79 - w75) - w3 * (w30 * w78 - w76) + w6 * (w9 * w78 - w30 * w72) + w7 * (w80 - w15 * w72),  # body4.y
        w5 * (w77 - w8 * w78) - w3 * (w33 * w73 - w79) + w6 * (w74 - w80) + w7 * (w15 * w73 - w33 * w78),  # body4.z
        -(w81 * body4_omega_x + w82 * body4_omega_y + w83 * body4_omega_z),  # body4.e0
        body4_omega_x * w84 - body4_omega_y * w83 + w82 * body4_omega_z,  # body4.e1
        body4_omega_x * w83 + body4_omega_y * w84 - w81 * body4_omega_z,  # body4.e2
        w81 * body4_omega_y - body4_omega_x * w82 + body4_omega_z * w84,  # body4.e3
        0.0,  # body5.x
        0.0,  # body5.y
        0.0,  # body5.z
        -((w86 * ground_m4_quaternion_0_0_0 + w87 * ground_m4_quaternion_3_0_0) * j4_angle_dot),  # body5.e0
        j4_angle_dot * (w87 * ground_m4_quaternion_2_0_0 - w86 * ground_m4_quaternion_1_0_0),  # body5.e1
        -(j4_angle_dot * (w86 * ground_m4_quaternion_2_0_0 + w87 * ground_m4_quaternion_1_0_0)),  # body5.e2
        j4_angle_dot * (w87 * ground_m4_quaternion_0_0_0 - w86 * ground_m4_quaternion_3_0_0),  # body5.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "closure": closure,
    "velocities": velocities,
}
