"""Stiff flyball governor: equations of motion, emitted by symgen from the scene `flyball_governor`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 spin.angle [rad], 1 height.travel [m], 2 right_swing.angle [rad], 3 left_swing.angle [rad]

q_d, the dependent coordinates by index:
    0 shaft.x [m], 1 shaft.y [m], 2 shaft.z [m], 3 shaft.e0 [1], 4 shaft.e1 [1], 5 shaft.e2 [1],
    6 shaft.e3 [1], 7 slider.x [m], 8 slider.y [m], 9 slider.z [m], 10 slider.e0 [1], 11 slider.e1 [1],
    12 slider.e2 [1], 13 slider.e3 [1], 14 right_rod.x [m], 15 right_rod.y [m], 16 right_rod.z [m],
    17 right_rod.e0 [1], 18 right_rod.e1 [1], 19 right_rod.e2 [1], 20 right_rod.e3 [1], 21 left_rod.x [m],
    22 left_rod.y [m], 23 left_rod.z [m], 24 left_rod.e0 [1], 25 left_rod.e1 [1], 26 left_rod.e2 [1],
    27 left_rod.e3 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 44) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    121 operations.
    """
    p = ca.SX.sym("p", 44)
    gravity_z = p[0]
    shaft_mass = p[1]
    shaft_center_of_mass_z = p[2]
    shaft_inertia_xx = p[3]
    shaft_inertia_yy = p[4]
    shaft_inertia_zz = p[5]
    slider_mass = p[6]
    slider_inertia_xx = p[7]
    slider_inertia_yy = p[8]
    slider_inertia_zz = p[9]
    right_rod_mass = p[10]
    right_rod_center_of_mass_x = p[11]
    right_rod_inertia_xx = p[12]
    right_rod_inertia_yy = p[13]
    right_rod_inertia_zz = p[14]
    left_rod_mass = p[15]
    left_rod_center_of_mass_x = p[16]
    left_rod_inertia_xx = p[17]
    left_rod_inertia_yy = p[18]
    left_rod_inertia_zz = p[19]
    shaft_right_quaternion_0_0_0 = p[20]
    shaft_right_quaternion_1_0_0 = p[21]
    shaft_right_x = p[22]
    shaft_right_z = p[23]
    right_rod_hinge_quaternion_0_0_0 = p[24]
    right_rod_hinge_quaternion_1_0_0 = p[25]
    shaft_left_quaternion_2_0_0 = p[26]
    shaft_left_quaternion_3_0_0 = p[27]
    shaft_left_x = p[28]
    shaft_left_z = p[29]
    left_rod_hinge_quaternion_0_0_0 = p[30]
    left_rod_hinge_quaternion_1_0_0 = p[31]
    right_rod_middle_x = p[32]
    slider_right_x = p[33]
    right_spring_stiffness = p[34]
    right_spring_damping = p[35]
    right_spring_free_length = p[36]
    left_rod_middle_x = p[37]
    slider_left_x = p[38]
    left_spring_stiffness = p[39]
    left_spring_damping = p[40]
    left_spring_free_length = p[41]
    # intermediate terms (56)
    w0 = (left_rod_inertia_xx + left_rod_inertia_yy + left_rod_inertia_zz) / 2.0
    w1 = w0 - left_rod_inertia_xx + left_rod_mass * left_rod_center_of_mass_x**2
    w2 = w0 - left_rod_inertia_zz
    w3 = left_rod_mass * left_rod_center_of_mass_x
    w4 = shaft_left_x * w3
    w5 = (right_rod_inertia_xx + right_rod_inertia_yy + right_rod_inertia_zz) / 2.0
    w6 = w5 - right_rod_inertia_xx + right_rod_mass * right_rod_center_of_mass_x**2
    w7 = w5 - right_rod_inertia_zz
    w8 = right_rod_mass * right_rod_center_of_mass_x
    w9 = shaft_right_x * w8
    w10 = (shaft_inertia_xx + shaft_inertia_yy + shaft_inertia_zz) / 2.0
    w11 = w10 - shaft_inertia_xx
    w12 = w11 + shaft_left_x * (left_rod_mass * shaft_left_x) + shaft_right_x * (right_rod_mass * shaft_right_x)
    w13 = (slider_inertia_xx + slider_inertia_yy + slider_inertia_zz) / 2.0
    w14 = w13 - slider_inertia_xx
    w15 = w10 - shaft_inertia_yy
    w16 = w0 - left_rod_inertia_yy
    w17 = w5 - right_rod_inertia_yy
    w18 = w13 - slider_inertia_yy
    w19 = w6 + w7
    w20 = w1 + w2
    w21 = slider_mass * gravity_z
    w22 = shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0
    w23 = shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w24 = w22 + w23
    w25 = right_rod_hinge_quaternion_0_0_0 * shaft_right_quaternion_1_0_0
    w26 = shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w27 = w25 + w26
    w28 = shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w29 = shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    w30 = left_rod_hinge_quaternion_1_0_0 * shaft_left_quaternion_3_0_0
    w31 = shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w32 = w10 - shaft_inertia_zz + shaft_mass * shaft_center_of_mass_z**2
    w33 = w15 + w32
    w34 = w11 + w32
    w35 = w11 + w15
    w36 = 4.0 * w34
    w37 = 4.0 * w35
    w38 = 4.0 * w33
    w39 = w13 - slider_inertia_zz
    w40 = w18 + w39
    w41 = w14 + w39
    w42 = w14 + w18
    w43 = 4.0 * w41
    w44 = 4.0 * w42
    w45 = 4.0 * w40
    w46 = w7 + w17
    w47 = w6 + w17
    w48 = 4.0 * w19
    w49 = 4.0 * w47
    w50 = 4.0 * w46
    w51 = w2 + w16
    w52 = w1 + w16
    w53 = 4.0 * w20
    w54 = 4.0 * w52
    w55 = 4.0 * w51
    # outputs
    c = ca.vertcat(
        w1,  # c0
        w2,  # c1
        w1 - w2,  # c2
        shaft_left_x,  # shaft_left_x
        w3,  # c4
        w4,  # c5
        2 * w4,  # c6
        w6,  # c7
        w7,  # c8
        w6 - w7,  # c9
        shaft_right_x,  # shaft_right_x
        w9,  # c11
        2 * w9,  # c12
        w12 + w14 + (w15 + w16 + w17 + w18),  # c13
        slider_mass,  # slider_mass
        w19,  # c15
        w20,  # c16
        gravity_z,  # gravity_z
        w21,  # c18
        right_spring_stiffness,  # right_spring_stiffness
        right_spring_free_length,  # right_spring_free_length
        slider_right_x,  # slider_right_x
        right_rod_middle_x,  # right_rod_middle_x
        shaft_right_z,  # shaft_right_z
        right_spring_damping,  # right_spring_damping
        left_spring_stiffness,  # left_spring_stiffness
        left_spring_free_length,  # left_spring_free_length
        slider_left_x,  # slider_left_x
        left_rod_middle_x,  # left_rod_middle_x
        shaft_left_z,  # shaft_left_z
        left_spring_damping,  # left_spring_damping
        -w8,  # c31
        w24,  # c32
        w27,  # c33
        w28 + w29,  # c34
        w30 + w31,  # c35
        2 * shaft_right_x,  # c36
        w22 - w23,  # c37
        w26 - w25,  # c38
        -w27,  # c39
        2 * shaft_left_x,  # c40
        w29 - w28,  # c41
        w31 - w30,  # c42
        shaft_right_quaternion_0_0_0,  # shaft_right_quaternion_0_0_0
        right_rod_hinge_quaternion_0_0_0,  # right_rod_hinge_quaternion_0_0_0
        shaft_right_quaternion_1_0_0,  # shaft_right_quaternion_1_0_0
        right_rod_hinge_quaternion_1_0_0,  # right_rod_hinge_quaternion_1_0_0
        shaft_left_quaternion_2_0_0,  # shaft_left_quaternion_2_0_0
        left_rod_hinge_quaternion_1_0_0,  # left_rod_hinge_quaternion_1_0_0
        shaft_left_quaternion_3_0_0,  # shaft_left_quaternion_3_0_0
        left_rod_hinge_quaternion_0_0_0,  # left_rod_hinge_quaternion_0_0_0
        left_rod_mass,  # left_rod_mass
        right_rod_mass,  # right_rod_mass
        w8,  # c53
        w11,  # c54
        w14,  # c55
        w15,  # c56
        w16,  # c57
        w17,  # c58
        w18,  # c59
        shaft_mass,  # shaft_mass
        shaft_mass * shaft_center_of_mass_z,  # c61
        w32,  # c62
        w33,  # c63
        w34,  # c64
        w35,  # c65
        w36 - w37,  # c66
        w37 - w38,  # c67
        w38 - w36,  # c68
        w39,  # c69
        w40,  # c70
        w41,  # c71
        w42,  # c72
        w43 - w44,  # c73
        w44 - w45,  # c74
        w45 - w43,  # c75
        w46,  # c76
        w47,  # c77
        w48 - w49,  # c78
        w49 - w50,  # c79
        w50 - w48,  # c80
        w51,  # c81
        w52,  # c82
        w53 - w54,  # c83
        w54 - w55,  # c84
        w55 - w53,  # c85
        gravity_z * shaft_mass,  # c86
        right_rod_mass * gravity_z,  # c87
        left_rod_mass * gravity_z,  # c88
        -w24,  # c89
        -w21,  # c90
        2 * w6 - 2 * w7,  # c91
        2 * w1 - 2 * w2,  # c92
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 4 x 4) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 4) [N, N m]: condensed force S^T (Q* - M s)
    124 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 93)
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    shaft_left_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    shaft_right_x = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    slider_mass = c[14]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    c18 = c[18]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c31 = c[31]
    # intermediate terms (32)
    w0 = ca.sin(left_swing_angle)
    w1 = ca.cos(left_swing_angle)
    w2 = ca.sin(right_swing_angle)
    w3 = ca.cos(right_swing_angle)
    w4 = w1 * spin_angle_dot
    w5 = w0 * spin_angle_dot
    w6 = 2 * (left_swing_angle_dot * w5)
    w7 = w2 * spin_angle_dot
    w8 = 2 * (w7 * right_swing_angle_dot)
    w9 = w3 * spin_angle_dot
    w10 = w3 * right_rod_middle_x
    w11 = slider_right_x - (shaft_right_x + w10)
    w12 = w2 * right_rod_middle_x
    w13 = height_travel - (shaft_right_z - w12)
    w14 = w11**2 + w13**2
    w15 = (1.0 - right_spring_free_length / ca.sqrt(w14)) * right_spring_stiffness
    w16 = (w11 * (right_swing_angle_dot * w12) + w13 * (height_travel_dot + right_swing_angle_dot * w10)) / w14
    w17 = w16 * right_spring_damping
    w18 = w13 * w15 + w13 * w17
    w19 = w1 * left_rod_middle_x
    w20 = slider_left_x - (shaft_left_x - w19)
    w21 = w0 * left_rod_middle_x
    w22 = height_travel - (shaft_left_z - w21)
    w23 = w20**2 + w22**2
    w24 = (1.0 - left_spring_free_length / ca.sqrt(w23)) * left_spring_stiffness
    w25 = (w22 * (height_travel_dot + left_swing_angle_dot * w19) - w20 * (left_swing_angle_dot * w21)) / w23
    w26 = w25 * left_spring_damping
    w27 = w22 * w24 + w22 * w26
    w28 = spin_angle_dot**2
    w29 = w21 * (w20 * w24 + w20 * w26) - w19 * w27 - ((w1 * gravity_z - w0 * (w28 * shaft_left_x)) * c4 + w4 * w5 * c2)
    w30 = w3 * (w8 * c7) - w2 * (2 * (right_swing_angle_dot * w9) * c8) + w8 * c11 - (w0 * (2 * (w4 * left_swing_angle_dot) * c1) - w1 * (w6 * c0) + w6 * c5)
    w31 = (w2 * (w28 * shaft_right_x) + w3 * gravity_z) * c31 - w7 * w9 * c9 - (w12 * (w11 * w15 + w11 * w17) + w10 * w18)
    # outputs
    M_hat = ca.SX(4, 4)
    # spin.angle
    M_hat[0, 0] = w3 * c12 + (c7 - w2 * (w2 * c9) + (c0 - w0 * (w0 * c2) - w1 * c6 + c13))
    # height.travel
    M_hat[1, 1] = slider_mass
    # right_swing.angle
    M_hat[2, 2] = c15
    # left_swing.angle
    M_hat[3, 3] = c16
    Q_hat = ca.vertcat(
        w30,  # spin.angle
        c18 - (w18 + w27),  # height.travel
        w31,  # right_swing.angle
        w29,  # left_swing.angle
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 28) [mixed]: dependent coordinates after one Newton step
    49 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    c = ca.SX.sym("c", 93)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_left_x = c[3]
    shaft_right_x = c[10]
    shaft_right_z = c[23]
    shaft_left_z = c[29]
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
    # intermediate terms (19)
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = ca.sin(w0)
    w3 = right_swing_angle / 2.0
    w4 = ca.cos(w3)
    w5 = ca.sin(w3)
    w6 = left_swing_angle / 2.0
    w7 = ca.sin(w6)
    w8 = ca.cos(w6)
    w9 = w2**2
    w10 = w1 * w2
    w11 = w1 * w4
    w12 = w2 * w5
    w13 = w1 * w5
    w14 = w2 * w4
    w15 = w1 * w7
    w16 = w2 * w8
    w17 = w1 * w8
    w18 = w2 * w7
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # shaft.x
        0.0,  # shaft.y
        0.0,  # shaft.z
        w1,  # shaft.e0
        0.0,  # shaft.e1
        0.0,  # shaft.e2
        w2,  # shaft.e3
        0.0,  # slider.x
        0.0,  # slider.y
        height_travel,  # slider.z
        w1,  # slider.e0
        0.0,  # slider.e1
        0.0,  # slider.e2
        w2,  # slider.e3
        shaft_right_x - w9 * c36,  # right_rod.x
        w10 * c36,  # right_rod.y
        shaft_right_z,  # right_rod.z
        w11 * c32 - w12 * c37,  # right_rod.e0
        w12 * c33 - w11 * c38,  # right_rod.e1
        w13 * c39 - w14 * c38,  # right_rod.e2
        w13 * c37 + w14 * c32,  # right_rod.e3
        shaft_left_x - w9 * c40,  # left_rod.x
        w10 * c40,  # left_rod.y
        shaft_left_z,  # left_rod.z
        w15 * c41 - w16 * c34,  # left_rod.e0
        w15 * c35 - w16 * c42,  # left_rod.e1
        w17 * c42 + w18 * c35,  # left_rod.e2
        w17 * c34 + w18 * c41,  # left_rod.e3
    )
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 28) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 28) [mixed]: rates of the dependent coordinates
    294 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 93)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_left_x = c[3]
    shaft_right_x = c[10]
    shaft_right_z = c[23]
    shaft_left_z = c[29]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    shaft_right_quaternion_0_0_0 = c[43]
    right_rod_hinge_quaternion_0_0_0 = c[44]
    shaft_right_quaternion_1_0_0 = c[45]
    right_rod_hinge_quaternion_1_0_0 = c[46]
    shaft_left_quaternion_2_0_0 = c[47]
    left_rod_hinge_quaternion_1_0_0 = c[48]
    shaft_left_quaternion_3_0_0 = c[49]
    left_rod_hinge_quaternion_0_0_0 = c[50]
    # intermediate terms (66)
    w0 = spin_angle / 2.0
    w1 = ca.sin(w0) / 2.0 * spin_angle_dot
    w2 = -w1
    w3 = spin_angle_dot * (ca.cos(w0) / 2.0)
    w4 = 2 * shaft_e2
    w5 = 2 * shaft_e1
    w6 = w4 * shaft_e3 - w5 * shaft_e0
    w7 = height_travel * w6
    w8 = 2 * -shaft_e3
    w9 = shaft_e2 * w4
    w10 = 1.0 - (shaft_e1 * w5 + w9)
    w11 = height_travel * w10
    w12 = 2 * -shaft_e2
    w13 = 2 * shaft_e0
    w14 = 2 * -shaft_e1
    w15 = w11 * w14
    w16 = shaft_e3 * w5
    w17 = w4 * shaft_e0
    w18 = w16 + w17
    w19 = height_travel * w18
    w20 = w16 - w17
    w21 = w20 * shaft_right_x + w10 * shaft_right_z
    w22 = w14 * w21
    w23 = 2 * shaft_e3
    w24 = shaft_e2 * w5 + shaft_e0 * w23
    w25 = w24 * shaft_right_x + w6 * shaft_right_z
    w26 = 1.0 - (w9 + shaft_e3 * w23)
    w27 = w26 * shaft_right_x + w18 * shaft_right_z
    w28 = right_swing_angle / 2.0
    w29 = ca.cos(w28)
    w30 = w29 * c32
    w31 = ca.sin(w28)
    w32 = w31 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w31 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w33 = w31 / 2.0
    w34 = w33 * c32
    w35 = w33 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w33 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w36 = w29 / 2.0
    w37 = w36 * c33
    w38 = w36 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w36 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w39 = w31 * c33
    w40 = w29 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0 - w29 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w41 = w3 * w39 - w1 * w40 + right_swing_angle_dot * (shaft_e0 * w35 - shaft_e1 * w34 + (shaft_e2 * w38 + shaft_e3 * w37))
    w42 = w1 * w39 + w3 * w40 + right_swing_angle_dot * (shaft_e3 * w35 - shaft_e1 * w38 - (shaft_e0 * w37 + shaft_e2 * w34))
    w43 = w3 * w30 - w1 * w32 + right_swing_angle_dot * (shaft_e0 * w38 - shaft_e3 * w34 - (shaft_e1 * w37 + shaft_e2 * w35))
    w44 = w20 * shaft_left_x + w10 * shaft_left_z
    w45 = w14 * w44
    w46 = w24 * shaft_left_x + w6 * shaft_left_z
    w47 = w26 * shaft_left_x + w18 * shaft_left_z
    w48 = left_swing_angle / 2.0
    w49 = ca.cos(w48)
    w50 = w49 / 2.0
    w51 = w50 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w50 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w52 = w50 * c35
    w53 = ca.sin(w48)
    w54 = w53 / 2.0
    w55 = w54 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w54 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w56 = w54 * c34
    w57 = w53 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w53 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w58 = w49 * c34
    w59 = (shaft_e0 * w51 - (shaft_e1 * w52 + shaft_e2 * w55 - shaft_e3 * w56)) * left_swing_angle_dot - (w1 * w57 + w3 * w58)
    w60 = w53 * c35
    w61 = w49 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0 - w49 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0
    w62 = left_swing_angle_dot * (shaft_e0 * w52 + shaft_e1 * w51 - (shaft_e2 * w56 + shaft_e3 * w55)) - (w1 * w60 + w3 * w61)
    w63 = w3 * w60 - w1 * w61 + left_swing_angle_dot * (shaft_e0 * w55 + shaft_e2 * w51 + (shaft_e3 * w52 + shaft_e1 * w56))
    w64 = w3 * w57 - w1 * w58 + left_swing_angle_dot * (shaft_e3 * w51 - shaft_e0 * w56 + (shaft_e1 * w55 - shaft_e2 * w52))
    w65 = (shaft_e2 * w37 - shaft_e1 * w35 - shaft_e3 * w38 - shaft_e0 * w34) * right_swing_angle_dot - (w1 * w30 + w3 * w32)
    # outputs
    q_d_dot = ca.vertcat(
        0.0,  # shaft.x
        0.0,  # shaft.y
        0.0,  # shaft.z
        w2,  # shaft.e0
        0.0,  # shaft.e1
        0.0,  # shaft.e2
        w3,  # shaft.e3
        w1 * (w7 * w8 - w11 * w12) - w3 * (w7 * w13 - w15) + w18 * height_travel_dot,  # slider.x
        w1 * (w15 - w8 * w19) - w3 * (w4 * w11 - w13 * w19) + w6 * height_travel_dot,  # slider.y
        w1 * (w12 * w19 - w7 * w14) - w3 * (w14 * w19 - w4 * w7) + w10 * height_travel_dot,  # slider.z
        w2,  # slider.e0
        0.0,  # slider.e1
        0.0,  # slider.e2
        w3,  # slider.e3
        w3 * (w22 - w13 * w25) - w1 * (w12 * w21 - w8 * w25),  # right_rod.x
        w3 * (w13 * w27 - w4 * w21) - w1 * (w8 * w27 - w22),  # right_rod.y
        w3 * (w4 * w25 - w14 * w27) - w1 * (w14 * w25 - w12 * w27),  # right_rod.z
        w65,  # right_rod.e0
        w41,  # right_rod.e1
        w42,  # right_rod.e2
        w43,  # right_rod.e3
        w3 * (w45 - w13 * w46) - w1 * (w12 * w44 - w8 * w46),  # left_rod.x
        w3 * (w13 * w47 - w4 * w44) - w1 * (w8 * w47 - w45),  # left_rod.y
        w3 * (w4 * w46 - w14 * w47) - w1 * (w14 * w46 - w12 * w47),  # left_rod.z
        w59,  # left_rod.e0
        w62,  # left_rod.e1
        w63,  # left_rod.e2
        w64,  # left_rod.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 28) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 28) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 28) [mixed]: accelerations of the dependent coordinates
    590 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 28)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 28)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 93)
    spin_angle = q_i[0]
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    shaft_e0 = q_d[3]
    shaft_e1 = q_d[4]
    shaft_e2 = q_d[5]
    shaft_e3 = q_d[6]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    shaft_e0_dot = q_d_dot[3]
    shaft_e1_dot = q_d_dot[4]
    shaft_e2_dot = q_d_dot[5]
    shaft_e3_dot = q_d_dot[6]
    spin_angle_ddot = q_i_ddot[0]
    height_travel_ddot = q_i_ddot[1]
    right_swing_angle_ddot = q_i_ddot[2]
    left_swing_angle_ddot = q_i_ddot[3]
    shaft_left_x = c[3]
    shaft_right_x = c[10]
    shaft_right_z = c[23]
    shaft_left_z = c[29]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    shaft_right_quaternion_0_0_0 = c[43]
    right_rod_hinge_quaternion_0_0_0 = c[44]
    shaft_right_quaternion_1_0_0 = c[45]
    right_rod_hinge_quaternion_1_0_0 = c[46]
    shaft_left_quaternion_2_0_0 = c[47]
    left_rod_hinge_quaternion_1_0_0 = c[48]
    shaft_left_quaternion_3_0_0 = c[49]
    left_rod_hinge_quaternion_0_0_0 = c[50]
    # intermediate terms (127)
    w0 = (spin_angle_dot / 2.0)**2
    w1 = spin_angle / 2.0
    w2 = ca.cos(w1)
    w3 = ca.sin(w1)
    w4 = w0 * w2 + w3 / 2.0 * spin_angle_ddot
    w5 = -w4
    w6 = spin_angle_ddot * (w2 / 2.0) - w0 * w3
    w7 = 2 * -shaft_e2
    w8 = 2 * shaft_e3
    w9 = 2 * shaft_e0
    w10 = 2 * -shaft_e1
    w11 = shaft_e0_dot * w7 + shaft_e1_dot * w8 + shaft_e2_dot * w9 + shaft_e3_dot * w10
    w12 = 2 * -shaft_e3
    w13 = 2 * shaft_e2
    w14 = shaft_e0_dot * w10 + shaft_e1_dot * w9 + shaft_e2_dot * w12 + shaft_e3_dot * w13
    w15 = 2 * shaft_e1
    w16 = shaft_e3 * w13 - shaft_e0 * w15
    w17 = shaft_e3 * w15
    w18 = shaft_e0 * w13
    w19 = w17 + w18
    w20 = w14 * w16 - w11 * w19
    w21 = shaft_e0_dot * w12 + w7 * shaft_e1_dot + shaft_e2_dot * w15 + w9 * shaft_e3_dot
    w22 = shaft_e2 * w13
    w23 = 1.0 - (shaft_e1 * w15 + w22)
    w24 = w19 * w21 - w14 * w23
    w25 = 2 * height_travel_dot
    w26 = w11 * w23 - w16 * w21
    w27 = w16 * height_travel
    w28 = w23 * height_travel
    w29 = w10 * w28
    w30 = (w11 * w20 - w21 * w24) * height_travel + w25 * w26 + w4 * (w12 * w27 - w7 * w28) - w6 * (w9 * w27 - w29)
    w31 = w19 * height_travel
    w32 = height_travel * (w21 * w26 - w14 * w20) + w24 * w25 + w4 * (w29 - w12 * w31) - w6 * (w13 * w28 - w9 * w31)
    w33 = height_travel * (w14 * w24 - w11 * w26) + w20 * w25 + w4 * (w7 * w31 - w10 * w27) - w6 * (w10 * w31 - w13 * w27)
    w34 = shaft_e2 * w15 + w8 * shaft_e0
    w35 = w34 * shaft_right_x + w16 * shaft_right_z
    w36 = 1.0 - (w22 + shaft_e3 * w8)
    w37 = w36 * shaft_right_x + w19 * shaft_right_z
    w38 = w14 * w35 - w11 * w37
    w39 = w17 - w18
    w40 = w39 * shaft_right_x + w23 * shaft_right_z
    w41 = w21 * w37 - w14 * w40
    w42 = w10 * w40
    w43 = w11 * w40 - w21 * w35
    w44 = (right_swing_angle_dot / 2.0)**2
    w45 = right_swing_angle / 2.0
    w46 = ca.cos(w45)
    w47 = w44 * w46
    w48 = w47 * c32
    w49 = w47 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w47 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w50 = ca.sin(w45)
    w51 = w44 * w50
    w52 = w51 * c33
    w53 = w51 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0 - w51 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0
    w54 = w50 / 2.0
    w55 = right_swing_angle_dot * w54
    w56 = w55 * c32
    w57 = w55 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w55 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w58 = w46 / 2.0
    w59 = right_swing_angle_dot * w58
    w60 = w59 * c33
    w61 = w59 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w59 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w62 = shaft_e0_dot * w56 + (shaft_e1_dot * w57 - shaft_e2_dot * w60 + shaft_e3_dot * w61)
    w63 = w46 * c32
    w64 = w50 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w50 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w65 = w62 + (shaft_e0 * w48 + (shaft_e1 * w49 + shaft_e2 * w52 + shaft_e3 * w53) + w62) + w4 * w63 + w6 * w64
    w66 = w54 * c32
    w67 = w54 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w54 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w68 = w58 * c33
    w69 = w58 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w58 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w70 = shaft_e0_dot * w57 - shaft_e1_dot * w56 + (shaft_e2_dot * w61 + shaft_e3_dot * w60)
    w71 = w46 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0 - w46 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w72 = w50 * c33
    w73 = w70 + (shaft_e0 * w49 - shaft_e1 * w48 + (shaft_e2 * w53 - shaft_e3 * w52) + w70) - w4 * w71 + w6 * w72
    w74 = w73 + right_swing_angle_ddot * (shaft_e0 * w67 - shaft_e1 * w66 + (shaft_e2 * w69 + shaft_e3 * w68))
    w75 = shaft_e3_dot * w57 - shaft_e1_dot * w61 - (shaft_e0_dot * w60 + shaft_e2_dot * w56)
    w76 = w75 + (shaft_e0 * w52 - shaft_e2 * w48 + (shaft_e3 * w49 - shaft_e1 * w53) + w75) + w4 * w72 + w6 * w71
    w77 = w76 + right_swing_angle_ddot * (shaft_e3 * w67 - shaft_e1 * w69 - (shaft_e0 * w68 + shaft_e2 * w66))
    w78 = shaft_e0_dot * w61 - shaft_e3_dot * w56 - (shaft_e1_dot * w60 + shaft_e2_dot * w57)
    w79 = w78 + (shaft_e0 * w53 - shaft_e3 * w48 + (shaft_e1 * w52 - shaft_e2 * w49) + w78) - w4 * w64 + w6 * w63
    w80 = w79 + right_swing_angle_ddot * (shaft_e0 * w69 - shaft_e3 * w66 - (shaft_e1 * w68 + shaft_e2 * w67))
    w81 = w34 * shaft_left_x + w16 * shaft_left_z
    w82 = w36 * shaft_left_x + w19 * shaft_left_z
    w83 = w14 * w81 - w11 * w82
    w84 = w39 * shaft_left_x + w23 * shaft_left_z
    w85 = w21 * w82 - w14 * w84
    w86 = w10 * w84
    w87 = w11 * w84 - w21 * w81
    w88 = (left_swing_angle_dot / 2.0)**2
    w89 = left_swing_angle / 2.0
    w90 = ca.sin(w89)
    w91 = w88 * w90
    w92 = w91 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0 - w91 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    w93 = ca.cos(w89)
    w94 = w88 * w93
    w95 = w94 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w94 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w96 = w91 * c35
    w97 = w94 * c34
    w98 = w93 / 2.0
    w99 = left_swing_angle_dot * w98
    w100 = w99 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w99 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w101 = w99 * c35
    w102 = w90 / 2.0
    w103 = left_swing_angle_dot * w102
    w104 = w103 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w103 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w105 = w103 * c34
    w106 = shaft_e0_dot * w100 - (shaft_e1_dot * w101 + shaft_e2_dot * w104 - shaft_e3_dot * w105)
    w107 = w90 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w90 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w108 = w93 * c34
    w109 = w106 + (shaft_e0 * w92 - (shaft_e2 * w95 - shaft_e1 * w96 - shaft_e3 * w97) + w106) - w4 * w107 - w6 * w108
    w110 = w98 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w98 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w111 = w98 * c35
    w112 = w102 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w102 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w113 = w102 * c34
    w114 = (shaft_e0 * w110 - (shaft_e1 * w111 + shaft_e2 * w112 - shaft_e3 * w113)) * left_swing_angle_ddot
    w115 = shaft_e0_dot * w101 + shaft_e1_dot * w100 - (shaft_e2_dot * w105 + shaft_e3_dot * w104)
    w116 = w90 * c35
    w117 = w93 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0 - w93 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0
    w118 = w115 + (shaft_e1 * w92 - shaft_e0 * w96 - (shaft_e2 * w97 + shaft_e3 * w95) + w115) - w4 * w116 - w6 * w117
    w119 = left_swing_angle_ddot * (shaft_e0 * w111 + shaft_e1 * w110 - (shaft_e2 * w113 + shaft_e3 * w112))
    w120 = shaft_e0_dot * w104 + shaft_e2_dot * w100 + (shaft_e3_dot * w101 + shaft_e1_dot * w105)
    w121 = w120 + (shaft_e0 * w95 + shaft_e2 * w92 + (shaft_e1 * w97 - shaft_e3 * w96) + w120) - w4 * w117 + w6 * w116
    w122 = left_swing_angle_ddot * (shaft_e0 * w112 + shaft_e2 * w110 + (shaft_e3 * w111 + shaft_e1 * w113))
    w123 = shaft_e3_dot * w100 - shaft_e0_dot * w105 + (shaft_e1_dot * w104 - shaft_e2_dot * w101)
    w124 = w123 + (shaft_e3 * w92 - shaft_e0 * w97 + (shaft_e1 * w95 + shaft_e2 * w96) + w123) - w4 * w108 + w6 * w107
    w125 = left_swing_angle_ddot * (shaft_e3 * w110 - shaft_e0 * w113 + (shaft_e1 * w112 - shaft_e2 * w111))
    w126 = (shaft_e2 * w68 - shaft_e1 * w67 - shaft_e3 * w69 - shaft_e0 * w66) * right_swing_angle_ddot - w65
    # outputs
    q_d_ddot = ca.vertcat(
        0.0,  # shaft.x
        0.0,  # shaft.y
        0.0,  # shaft.z
        w5,  # shaft.e0
        0.0,  # shaft.e1
        0.0,  # shaft.e2
        w6,  # shaft.e3
        w30 + w19 * height_travel_ddot,  # slider.x
        w32 + w16 * height_travel_ddot,  # slider.y
        w33 + w23 * height_travel_ddot,  # slider.z
        w5,  # slider.e0
        0.0,  # slider.e1
        0.0,  # slider.e2
        w6,  # slider.e3
        w11 * w38 - w21 * w41 - w4 * (w7 * w40 - w12 * w35) + w6 * (w42 - w9 * w35),  # right_rod.x
        w21 * w43 - w14 * w38 - w4 * (w12 * w37 - w42) + w6 * (w9 * w37 - w13 * w40),  # right_rod.y
        w14 * w41 - w11 * w43 - w4 * (w10 * w35 - w7 * w37) + w6 * (w13 * w35 - w10 * w37),  # right_rod.z
        w126,  # right_rod.e0
        w74,  # right_rod.e1
        w77,  # right_rod.e2
        w80,  # right_rod.e3
        w11 * w83 - w21 * w85 - w4 * (w7 * w84 - w12 * w81) + w6 * (w86 - w9 * w81),  # left_rod.x
        w21 * w87 - w14 * w83 - w4 * (w12 * w82 - w86) + w6 * (w9 * w82 - w13 * w84),  # left_rod.y
        w14 * w85 - w11 * w87 - w4 * (w10 * w81 - w7 * w82) + w6 * (w13 * w81 - w10 * w82),  # left_rod.z
        w109 + w114,  # left_rod.e0
        w118 + w119,  # left_rod.e1
        w121 + w122,  # left_rod.e2
        w124 + w125,  # left_rod.e3
    )
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 32) [mixed]: rates of all coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 28) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 28 x 32) [SI]: constraint Jacobian
    gives C_t (n_c = 28) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 28) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 28) [m/s^2, rad/s^2]: right-hand side at acceleration level
    646 operations.
    """
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 93)
    shaft_x = q[0]
    shaft_y = q[1]
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    spin_angle = q[28]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    spin_angle_dot = q_dot[28]
    height_travel_dot = q_dot[29]
    right_swing_angle_dot = q_dot[30]
    left_swing_angle_dot = q_dot[31]
    shaft_left_x = c[3]
    shaft_right_x = c[10]
    shaft_right_z = c[23]
    shaft_left_z = c[29]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    shaft_right_quaternion_0_0_0 = c[43]
    right_rod_hinge_quaternion_0_0_0 = c[44]
    shaft_right_quaternion_1_0_0 = c[45]
    right_rod_hinge_quaternion_1_0_0 = c[46]
    shaft_left_quaternion_2_0_0 = c[47]
    left_rod_hinge_quaternion_1_0_0 = c[48]
    shaft_left_quaternion_3_0_0 = c[49]
    left_rod_hinge_quaternion_0_0_0 = c[50]
    # intermediate terms (130)
    w0 = spin_angle / 2.0
    w1 = ca.cos(w0)
    w2 = ca.sin(w0)
    w3 = 2 * shaft_e1
    w4 = shaft_e3 * w3
    w5 = 2 * shaft_e2
    w6 = shaft_e0 * w5
    w7 = w4 + w6
    w8 = height_travel * w7
    w9 = shaft_e3 * w5 - shaft_e0 * w3
    w10 = height_travel * w9
    w11 = shaft_e2 * w5
    w12 = 1.0 - (shaft_e1 * w3 + w11)
    w13 = height_travel * w12
    w14 = right_swing_angle / 2.0
    w15 = ca.cos(w14)
    w16 = w15 * c32
    w17 = w15 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0 - w15 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w18 = ca.sin(w14)
    w19 = w18 * c33
    w20 = w18 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w18 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w21 = 2 * shaft_e3
    w22 = 1.0 - (w11 + shaft_e3 * w21)
    w23 = w22 * shaft_right_x + w7 * shaft_right_z
    w24 = shaft_e2 * w3 + shaft_e0 * w21
    w25 = w24 * shaft_right_x + w9 * shaft_right_z
    w26 = w4 - w6
    w27 = w26 * shaft_right_x + w12 * shaft_right_z
    w28 = left_swing_angle / 2.0
    w29 = ca.sin(w28)
    w30 = w29 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w29 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w31 = w29 * c35
    w32 = ca.cos(w28)
    w33 = w32 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0 - w32 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0
    w34 = w32 * c34
    w35 = w22 * shaft_left_x + w7 * shaft_left_z
    w36 = w24 * shaft_left_x + w9 * shaft_left_z
    w37 = w26 * shaft_left_x + w12 * shaft_left_z
    w38 = 2 * -shaft_e3
    w39 = w10 * w38
    w40 = 2 * -shaft_e2
    w41 = 2 * -shaft_e1
    w42 = w13 * w41
    w43 = w8 * w40
    w44 = -w16
    w45 = -w17
    w46 = -w20
    w47 = w25 * w38
    w48 = w27 * w41
    w49 = w23 * w40
    w50 = -w30
    w51 = -w31
    w52 = -w33
    w53 = -w34
    w54 = w36 * w38
    w55 = w37 * w41
    w56 = w35 * w40
    w57 = 2 * shaft_e0
    w58 = w13 * w57
    w59 = w10 * w57
    w60 = w27 * w57
    w61 = w25 * w57
    w62 = w37 * w57
    w63 = w36 * w57
    w64 = w8 * w57
    w65 = -w19
    w66 = w23 * w57
    w67 = w35 * w57
    w68 = w18 / 2.0
    w69 = w68 * c32
    w70 = w68 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w68 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w71 = w15 / 2.0
    w72 = w71 * c33
    w73 = w71 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w71 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w74 = w32 / 2.0
    w75 = w74 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w74 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w76 = w74 * c35
    w77 = w29 / 2.0
    w78 = w77 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w77 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w79 = w77 * c34
    w80 = (spin_angle_dot / 2.0)**2
    w81 = w40 * shaft_e0_dot + w21 * shaft_e1_dot + w57 * shaft_e2_dot + w41 * shaft_e3_dot
    w82 = w41 * shaft_e0_dot + w57 * shaft_e1_dot + w38 * shaft_e2_dot + w5 * shaft_e3_dot
    w83 = w9 * w82 - w7 * w81
    w84 = w38 * shaft_e0_dot + w40 * shaft_e1_dot + w3 * shaft_e2_dot + w57 * shaft_e3_dot
    w85 = w7 * w84 - w12 * w82
    w86 = 2 * height_travel_dot
    w87 = w12 * w81 - w9 * w84
    w88 = right_swing_angle_dot / 2.0
    w89 = w88**2
    w90 = w15 * w89
    w91 = w88 * (w15 * w88) * c32
    w92 = w90 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w90 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w93 = w18 * w89
    w94 = w88 * (w18 * w88) * c33
    w95 = w93 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0 - w93 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0
    w96 = w68 * right_swing_angle_dot
    w97 = w96 * c32
    w98 = w96 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w96 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w99 = w71 * right_swing_angle_dot
    w100 = w99 * c33
    w101 = w99 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w99 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w102 = shaft_e0_dot * w97 + (shaft_e1_dot * w98 - shaft_e2_dot * w100 + shaft_e3_dot * w101)
    w103 = shaft_e0_dot * w98 - shaft_e1_dot * w97 + (shaft_e2_dot * w101 + shaft_e3_dot * w100)
    w104 = shaft_e3_dot * w98 - shaft_e1_dot * w101 - (shaft_e0_dot * w100 + shaft_e2_dot * w97)
    w105 = shaft_e0_dot * w101 - shaft_e3_dot * w97 - (shaft_e1_dot * w100 + shaft_e2_dot * w98)
    w106 = w25 * w82 - w23 * w81
    w107 = w23 * w84 - w27 * w82
    w108 = w27 * w81 - w25 * w84
    w109 = left_swing_angle_dot / 2.0
    w110 = w109**2
    w111 = w29 * w110
    w112 = w111 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0 - w111 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    w113 = w32 * w110
    w114 = w113 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w113 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w115 = w109 * (w29 * w109) * c35
    w116 = w109 * (w32 * w109) * c34
    w117 = w74 * left_swing_angle_dot
    w118 = w117 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w117 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w119 = w117 * c35
    w120 = w77 * left_swing_angle_dot
    w121 = w120 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w120 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w122 = w120 * c34
    w123 = shaft_e0_dot * w118 - (shaft_e1_dot * w119 + shaft_e2_dot * w121 - shaft_e3_dot * w122)
    w124 = shaft_e0_dot * w119 + shaft_e1_dot * w118 - (shaft_e2_dot * w122 + shaft_e3_dot * w121)
    w125 = shaft_e0_dot * w121 + shaft_e2_dot * w118 + (shaft_e3_dot * w119 + shaft_e1_dot * w122)
    w126 = shaft_e3_dot * w118 - shaft_e0_dot * w122 + (shaft_e1_dot * w121 - shaft_e2_dot * w119)
    w127 = w36 * w82 - w35 * w81
    w128 = w35 * w84 - w37 * w82
    w129 = w37 * w81 - w36 * w84
    # outputs
    C = ca.vertcat(
        shaft_e0 - w1,  # spin.e0
        shaft_e1,  # spin.e1
        shaft_e2,  # spin.e2
        shaft_e3 - w2,  # spin.e3
        shaft_x,  # spin.x
        shaft_y,  # spin.y
        shaft_z,  # spin.z
        slider_e0 - shaft_e0,  # height.e0
        slider_e1 - shaft_e1,  # height.e1
        slider_e2 - shaft_e2,  # height.e2
        slider_e3 - shaft_e3,  # height.e3
        slider_x - shaft_x - w8,  # height.x
        slider_y - shaft_y - w10,  # height.y
        slider_z - shaft_z - w13,  # height.z
        right_rod_e0 - (shaft_e0 * w16 - (shaft_e1 * w17 - shaft_e2 * w19 + shaft_e3 * w20)),  # right_swing.e0
        right_rod_e1 - (shaft_e0 * w17 + shaft_e1 * w16 + (shaft_e2 * w20 + shaft_e3 * w19)),  # right_swing.e1
        right_rod_e2 - (shaft_e2 * w16 - shaft_e0 * w19 + (shaft_e3 * w17 - shaft_e1 * w20)),  # right_swing.e2
        right_rod_e3 - (shaft_e0 * w20 + shaft_e3 * w16 - (shaft_e1 * w19 + shaft_e2 * w17)),  # right_swing.e3
        right_rod_x - (shaft_x + w23),  # right_swing.x
        right_rod_y - (shaft_y + w25),  # right_swing.y
        right_rod_z - (shaft_z + w27),  # right_swing.z
        left_rod_e0 - (shaft_e0 * w30 - (shaft_e1 * w31 + shaft_e2 * w33 + shaft_e3 * w34)),  # left_swing.e0
        left_rod_e1 - (shaft_e0 * w31 + shaft_e1 * w30 + (shaft_e2 * w34 - shaft_e3 * w33)),  # left_swing.e1
        left_rod_e2 - (shaft_e0 * w33 + shaft_e2 * w30 + (shaft_e3 * w31 - shaft_e1 * w34)),  # left_swing.e2
        left_rod_e3 - (shaft_e0 * w34 + shaft_e3 * w30 + (shaft_e1 * w33 - shaft_e2 * w31)),  # left_swing.e3
        left_rod_x - (shaft_x + w35),  # left_swing.x
        left_rod_y - (shaft_y + w36),  # left_swing.y
        left_rod_z - (shaft_z + w37),  # left_swing.z
    )
    C_q = ca.SX(28, 32)
    # spin.e0
    C_q[0, 3] = 1.0
    C_q[0, 28] = w2 / 2.0
    # spin.e1
    C_q[1, 4] = 1.0
    # spin.e2
    C_q[2, 5] = 1.0
    # spin.e3
    C_q[3, 6] = 1.0
    C_q[3, 28] = -(w1 / 2.0)
    # spin.x
    C_q[4, 0] = 1.0
    # spin.y
    C_q[5, 1] = 1.0
    # spin.z
    C_q[6, 2] = 1.0
    # height.e0
    C_q[7, 3] = -1.0
    C_q[7, 10] = 1.0
    # height.e1
    C_q[8, 4] = -1.0
    C_q[8, 11] = 1.0
    # height.e2
    C_q[9, 5] = -1.0
    C_q[9, 12] = 1.0
    # height.e3
    C_q[10, 6] = -1.0
    C_q[10, 13] = 1.0
    # height.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = w39 - w13 * w40
    C_q[11, 4] = w10 * w40 - w13 * w21
    C_q[11, 5] = w3 * w10 - w58
    C_q[11, 6] = w59 - w42
    C_q[11, 7] = 1.0
    C_q[11, 29] = -w7
    # height.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w42 - w8 * w38
    C_q[12, 4] = w58 - w43
    C_q[12, 5] = w13 * w38 - w3 * w8
    C_q[12, 6] = w5 * w13 - w64
    C_q[12, 8] = 1.0
    C_q[12, 29] = -w9
    # height.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w43 - w10 * w41
    C_q[13, 4] = w8 * w21 - w59
    C_q[13, 5] = w64 - w39
    C_q[13, 6] = w8 * w41 - w5 * w10
    C_q[13, 9] = 1.0
    C_q[13, 29] = -w12
    # right_swing.e0
    C_q[14, 3] = w44
    C_q[14, 4] = w17
    C_q[14, 5] = w65
    C_q[14, 6] = w20
    C_q[14, 17] = 1.0
    C_q[14, 30] = shaft_e0 * w69 + (shaft_e1 * w70 - shaft_e2 * w72 + shaft_e3 * w73)
    # right_swing.e1
    C_q[15, 3] = w45
    C_q[15, 4] = w44
    C_q[15, 5] = w46
    C_q[15, 6] = w65
    C_q[15, 18] = 1.0
    C_q[15, 30] = shaft_e1 * w69 - shaft_e0 * w70 - (shaft_e2 * w73 + shaft_e3 * w72)
    # right_swing.e2
    C_q[16, 3] = w19
    C_q[16, 4] = w20
    C_q[16, 5] = w44
    C_q[16, 6] = w45
    C_q[16, 19] = 1.0
    C_q[16, 30] = shaft_e0 * w72 + shaft_e2 * w69 - (shaft_e3 * w70 - shaft_e1 * w73)
    # right_swing.e3
    C_q[17, 3] = w46
    C_q[17, 4] = w19
    C_q[17, 5] = w17
    C_q[17, 6] = w44
    C_q[17, 20] = 1.0
    C_q[17, 30] = shaft_e1 * w72 + shaft_e2 * w70 - (shaft_e0 * w73 - shaft_e3 * w69)
    # right_swing.x
    C_q[18, 0] = -1.0
    C_q[18, 3] = w47 - w27 * w40
    C_q[18, 4] = w25 * w40 - w21 * w27
    C_q[18, 5] = w3 * w25 - w60
    C_q[18, 6] = w61 - w48
    C_q[18, 14] = 1.0
    # right_swing.y
    C_q[19, 1] = -1.0
    C_q[19, 3] = w48 - w23 * w38
    C_q[19, 4] = w60 - w49
    C_q[19, 5] = w27 * w38 - w3 * w23
    C_q[19, 6] = w5 * w27 - w66
    C_q[19, 15] = 1.0
    # right_swing.z
    C_q[20, 2] = -1.0
    C_q[20, 3] = w49 - w25 * w41
    C_q[20, 4] = w21 * w23 - w61
    C_q[20, 5] = w66 - w47
    C_q[20, 6] = w23 * w41 - w5 * w25
    C_q[20, 16] = 1.0
    # left_swing.e0
    C_q[21, 3] = w50
    C_q[21, 4] = w31
    C_q[21, 5] = w33
    C_q[21, 6] = w34
    C_q[21, 24] = 1.0
    C_q[21, 31] = shaft_e1 * w76 + shaft_e2 * w78 - shaft_e3 * w79 - shaft_e0 * w75
    # left_swing.e1
    C_q[22, 3] = w51
    C_q[22, 4] = w50
    C_q[22, 5] = w53
    C_q[22, 6] = w33
    C_q[22, 25] = 1.0
    C_q[22, 31] = shaft_e2 * w79 + shaft_e3 * w78 - (shaft_e0 * w76 + shaft_e1 * w75)
    # left_swing.e2
    C_q[23, 3] = w52
    C_q[23, 4] = w34
    C_q[23, 5] = w50
    C_q[23, 6] = w51
    C_q[23, 26] = 1.0
    C_q[23, 31] = -(shaft_e0 * w78 + shaft_e2 * w75 + (shaft_e3 * w76 + shaft_e1 * w79))
    # left_swing.e3
    C_q[24, 3] = w53
    C_q[24, 4] = w52
    C_q[24, 5] = w31
    C_q[24, 6] = w50
    C_q[24, 27] = 1.0
    C_q[24, 31] = shaft_e0 * w79 - shaft_e3 * w75 - (shaft_e1 * w78 - shaft_e2 * w76)
    # left_swing.x
    C_q[25, 0] = -1.0
    C_q[25, 3] = w54 - w37 * w40
    C_q[25, 4] = w36 * w40 - w21 * w37
    C_q[25, 5] = w3 * w36 - w62
    C_q[25, 6] = w63 - w55
    C_q[25, 21] = 1.0
    # left_swing.y
    C_q[26, 1] = -1.0
    C_q[26, 3] = w55 - w35 * w38
    C_q[26, 4] = w62 - w56
    C_q[26, 5] = w37 * w38 - w3 * w35
    C_q[26, 6] = w5 * w37 - w67
    C_q[26, 22] = 1.0
    # left_swing.z
    C_q[27, 2] = -1.0
    C_q[27, 3] = w56 - w36 * w41
    C_q[27, 4] = w21 * w35 - w63
    C_q[27, 5] = w67 - w54
    C_q[27, 6] = w35 * w41 - w5 * w36
    C_q[27, 23] = 1.0
    C_t = ca.SX(28, 1)
    nu = ca.SX(28, 1)
    gamma = ca.vertcat(
        -(w1 * w80),  # spin.e0
        0.0,  # spin.e1
        0.0,  # spin.e2
        -(w2 * w80),  # spin.e3
        0.0,  # spin.x
        0.0,  # spin.y
        0.0,  # spin.z
        0.0,  # height.e0
        0.0,  # height.e1
        0.0,  # height.e2
        0.0,  # height.e3
        height_travel * (w81 * w83 - w84 * w85) + w86 * w87,  # height.x
        height_travel * (w84 * w87 - w82 * w83) + w85 * w86,  # height.y
        height_travel * (w82 * w85 - w81 * w87) + w83 * w86,  # height.z
        -(w102 + (shaft_e0 * w91 + (shaft_e1 * w92 + shaft_e2 * w94 + shaft_e3 * w95) + w102)),  # right_swing.e0
        w103 + (shaft_e0 * w92 - shaft_e1 * w91 + (shaft_e2 * w95 - shaft_e3 * w94) + w103),  # right_swing.e1
        w104 + (shaft_e0 * w94 - shaft_e2 * w91 + (shaft_e3 * w92 - shaft_e1 * w95) + w104),  # right_swing.e2
        w105 + (shaft_e0 * w95 - shaft_e3 * w91 + (shaft_e1 * w94 - shaft_e2 * w92) + w105),  # right_swing.e3
        w81 * w106 - w84 * w107,  # right_swing.x
        w84 * w108 - w82 * w106,  # right_swing.y
        w82 * w107 - w81 * w108,  # right_swing.z
        w123 + (shaft_e0 * w112 - (shaft_e2 * w114 - shaft_e1 * w115 - shaft_e3 * w116) + w123),  # left_swing.e0
        w124 + (shaft_e1 * w112 - shaft_e0 * w115 - (shaft_e2 * w116 + shaft_e3 * w114) + w124),  # left_swing.e1
        w125 + (shaft_e0 * w114 + shaft_e2 * w112 + (shaft_e1 * w116 - shaft_e3 * w115) + w125),  # left_swing.e2
        w126 + (shaft_e3 * w112 - shaft_e0 * w116 + (shaft_e1 * w114 + shaft_e2 * w115) + w126),  # left_swing.e3
        w81 * w127 - w84 * w128,  # left_swing.x
        w84 * w129 - w82 * w127,  # left_swing.y
        w82 * w128 - w81 * w129,  # left_swing.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 32) [mixed]: rates of all coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 32 x 32) [SI]: mass matrix in all coordinates
    gives K (n x n = 32 x 32) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 32) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 32) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 32) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 28 x 32) [SI]: constraint Jacobian
    gives gamma (n_c = 28) [m/s^2, rad/s^2]: right-hand side at acceleration level
    1671 operations.
    """
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 93)
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    spin_angle = q[28]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    spin_angle_dot = q_dot[28]
    height_travel_dot = q_dot[29]
    right_swing_angle_dot = q_dot[30]
    left_swing_angle_dot = q_dot[31]
    c0 = c[0]
    c1 = c[1]
    shaft_left_x = c[3]
    c4 = c[4]
    c7 = c[7]
    c8 = c[8]
    shaft_right_x = c[10]
    slider_mass = c[14]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    c18 = c[18]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    shaft_right_quaternion_0_0_0 = c[43]
    right_rod_hinge_quaternion_0_0_0 = c[44]
    shaft_right_quaternion_1_0_0 = c[45]
    right_rod_hinge_quaternion_1_0_0 = c[46]
    shaft_left_quaternion_2_0_0 = c[47]
    left_rod_hinge_quaternion_1_0_0 = c[48]
    shaft_left_quaternion_3_0_0 = c[49]
    left_rod_hinge_quaternion_0_0_0 = c[50]
    left_rod_mass = c[51]
    right_rod_mass = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    shaft_mass = c[60]
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
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    c89 = c[89]
    # intermediate terms (479)
    w0 = 2 * -shaft_e2
    w1 = 2 * shaft_e1
    w2 = shaft_e1 * w1
    w3 = 2 * shaft_e2
    w4 = shaft_e2 * w3
    w5 = 1.0 - (w2 + w4)
    w6 = w5 * c61
    w7 = 2 * -shaft_e3
    w8 = w3 * shaft_e3
    w9 = w1 * shaft_e0
    w10 = w8 - w9
    w11 = w10 * c61
    w12 = w7 * w11
    w13 = w0 * w6 - w12
    w14 = 2 * shaft_e3
    w15 = w6 * w14 - w0 * w11
    w16 = 2 * shaft_e0
    w17 = w6 * w16
    w18 = w17 - w1 * w11
    w19 = 2 * -shaft_e1
    w20 = w6 * w19
    w21 = w11 * w16
    w22 = w20 - w21
    w23 = w1 * shaft_e3
    w24 = w3 * shaft_e0
    w25 = w23 + w24
    w26 = w25 * c61
    w27 = w7 * w26 - w20
    w28 = w0 * w26
    w29 = w28 - w17
    w30 = w1 * w26 - w6 * w7
    w31 = w16 * w26
    w32 = w31 - w3 * w6
    w33 = w11 * w19 - w28
    w34 = w21 - w14 * w26
    w35 = w12 - w31
    w36 = w3 * w11 - w19 * w26
    w37 = w16 * c63
    w38 = w19 * w37 + shaft_e2 * shaft_e3 * c66
    w39 = w16 * c64
    w40 = w19 * c65
    w41 = w0 * w39 + shaft_e1 * shaft_e3 * c67
    w42 = w0 * c63
    w43 = w1 * c64
    w44 = w16 * c65
    w45 = shaft_e2 * shaft_e1 * c68 + w7 * w44
    w46 = shaft_e3 * shaft_e0 * c68 + w3 * w40
    w47 = w7 * w43 + shaft_e2 * shaft_e0 * c67
    w48 = w14 * w42 + shaft_e1 * shaft_e0 * c66
    w49 = 2 * -slider_e1
    w50 = 2 * -slider_e2
    w51 = 2 * -slider_e3
    w52 = 2 * slider_e0
    w53 = w52 * c70
    w54 = 2 * slider_e2
    w55 = w49 * w53 + slider_e2 * slider_e3 * c73
    w56 = 2 * slider_e3
    w57 = w52 * c71
    w58 = w49 * c72
    w59 = w50 * w57 + slider_e1 * slider_e3 * c74
    w60 = w50 * c70
    w61 = 2 * slider_e1
    w62 = w61 * c71
    w63 = w52 * c72
    w64 = slider_e1 * slider_e2 * c75 + w51 * w63
    w65 = slider_e3 * slider_e0 * c75 + w54 * w58
    w66 = w51 * w62 + slider_e2 * slider_e0 * c74
    w67 = w56 * w60 + slider_e1 * slider_e0 * c73
    w68 = 2 * -right_rod_e2
    w69 = 2 * right_rod_e1
    w70 = w69 * right_rod_e3
    w71 = 2 * right_rod_e2
    w72 = w71 * right_rod_e0
    w73 = w70 - w72
    w74 = w73 * c53
    w75 = 2 * -right_rod_e3
    w76 = right_rod_e2 * w69
    w77 = 2 * right_rod_e3
    w78 = right_rod_e0 * w77
    w79 = w76 + w78
    w80 = w79 * c53
    w81 = w75 * w80
    w82 = w68 * w74 - w81
    w83 = w74 * w77 - w68 * w80
    w84 = 2 * right_rod_e0
    w85 = w74 * w84
    w86 = w85 - w69 * w80
    w87 = 2 * -right_rod_e1
    w88 = w74 * w87
    w89 = w80 * w84
    w90 = w88 - w89
    w91 = right_rod_e2 * w71
    w92 = right_rod_e3 * w77
    w93 = 1.0 - (w91 + w92)
    w94 = w93 * c53
    w95 = w75 * w94 - w88
    w96 = w68 * w94
    w97 = w96 - w85
    w98 = w69 * w94 - w74 * w75
    w99 = w84 * w94
    w100 = w99 - w71 * w74
    w101 = w80 * w87 - w96
    w102 = w89 - w77 * w94
    w103 = w81 - w99
    w104 = w71 * w80 - w87 * w94
    w105 = w84 * c76
    w106 = w87 * w105 + right_rod_e2 * right_rod_e3 * c78
    w107 = w84 * c15
    w108 = w87 * c77
    w109 = w68 * w107 + right_rod_e1 * right_rod_e3 * c79
    w110 = w68 * c76
    w111 = w69 * c15
    w112 = w84 * c77
    w113 = right_rod_e2 * right_rod_e1 * c80 + w75 * w112
    w114 = right_rod_e3 * right_rod_e0 * c80 + w71 * w108
    w115 = w75 * w111 + right_rod_e2 * right_rod_e0 * c79
    w116 = w77 * w110 + right_rod_e1 * right_rod_e0 * c78
    w117 = 2 * -left_rod_e2
    w118 = 2 * left_rod_e1
    w119 = w118 * left_rod_e3
    w120 = 2 * left_rod_e2
    w121 = w120 * left_rod_e0
    w122 = w119 - w121
    w123 = w122 * c4
    w124 = 2 * -left_rod_e3
    w125 = left_rod_e2 * w118
    w126 = 2 * left_rod_e3
    w127 = left_rod_e0 * w126
    w128 = w125 + w127
    w129 = w128 * c4
    w130 = w124 * w129
    w131 = w117 * w123 - w130
    w132 = w123 * w126 - w117 * w129
    w133 = 2 * left_rod_e0
    w134 = w123 * w133
    w135 = w134 - w118 * w129
    w136 = 2 * -left_rod_e1
    w137 = w123 * w136
    w138 = w129 * w133
    w139 = w137 - w138
    w140 = left_rod_e2 * w120
    w141 = left_rod_e3 * w126
    w142 = 1.0 - (w140 + w141)
    w143 = w142 * c4
    w144 = w124 * w143 - w137
    w145 = w117 * w143
    w146 = w145 - w134
    w147 = w118 * w143 - w123 * w124
    w148 = w133 * w143
    w149 = w148 - w120 * w123
    w150 = w129 * w136 - w145
    w151 = w138 - w126 * w143
    w152 = w130 - w148
    w153 = w120 * w129 - w136 * w143
    w154 = w133 * c81
    w155 = w136 * w154 + left_rod_e2 * left_rod_e3 * c83
    w156 = w133 * c16
    w157 = w136 * c82
    w158 = w117 * w156 + left_rod_e1 * left_rod_e3 * c84
    w159 = w117 * c81
    w160 = w118 * c16
    w161 = w133 * c82
    w162 = left_rod_e2 * left_rod_e1 * c85 + w124 * w161
    w163 = left_rod_e3 * left_rod_e0 * c85 + w120 * w157
    w164 = w124 * w160 + left_rod_e2 * left_rod_e0 * c84
    w165 = w126 * w159 + left_rod_e1 * left_rod_e0 * c83
    w166 = w0 * shaft_e0_dot
    w167 = w16 * shaft_e2_dot
    w168 = w166 + w7 * shaft_e1_dot + w167 + w1 * shaft_e3_dot
    w169 = w168 * c61
    w170 = w19 * shaft_e0_dot + w16 * shaft_e1_dot
    w171 = w170 + w14 * shaft_e2_dot + w0 * shaft_e3_dot
    w172 = w171 * c61
    w173 = w168 * w169 + w171 * w172
    w174 = shaft_e3 * w14
    w175 = 1.0 - (w4 + w174)
    w176 = w7 * shaft_e0_dot
    w177 = w16 * shaft_e3_dot
    w178 = w176 + w3 * shaft_e1_dot + w19 * shaft_e2_dot + w177
    w179 = w172 * w178
    w180 = shaft_e2 * w1
    w181 = shaft_e0 * w14
    w182 = w169 * w178
    w183 = w25 * w173 - (w175 * w179 + (w180 - w181) * w182)
    w184 = w180 + w181
    w185 = w10 * w173 - (w179 * w184 + w182 * (1.0 - (w2 + w174)))
    w186 = w23 - w24
    w187 = w5 * w173 - (w179 * w186 + w182 * (w8 + w9))
    w188 = w178 * c62
    w189 = w168 * c56
    w190 = w168 * w188 - w178 * w189
    w191 = w171 * c54
    w192 = w178 * w191 - w171 * w188
    w193 = w171 * w189 - w168 * w191
    w194 = w19 * w190 + w0 * w192 + w7 * w193
    w195 = w16 * w190 + w7 * w192 + w3 * w193
    w196 = w14 * w190 + w16 * w192 + w19 * w193
    w197 = w0 * w190 + w1 * w192 + w16 * w193
    w198 = w50 * slider_e0_dot
    w199 = w52 * slider_e2_dot
    w200 = w198 + w51 * slider_e1_dot + w199 + w61 * slider_e3_dot
    w201 = w51 * slider_e0_dot
    w202 = w52 * slider_e3_dot
    w203 = w201 + w54 * slider_e1_dot + w49 * slider_e2_dot + w202
    w204 = w203 * c69
    w205 = w200 * c59
    w206 = w200 * w204 - w203 * w205
    w207 = w49 * slider_e0_dot + w52 * slider_e1_dot
    w208 = w207 + w56 * slider_e2_dot + w50 * slider_e3_dot
    w209 = w208 * c55
    w210 = w203 * w209 - w204 * w208
    w211 = w205 * w208 - w200 * w209
    w212 = w49 * w206 + w50 * w210 + w51 * w211
    w213 = w52 * w206 + w51 * w210 + w54 * w211
    w214 = w56 * w206 + w52 * w210 + w49 * w211
    w215 = w50 * w206 + w61 * w210 + w52 * w211
    w216 = w75 * right_rod_e0_dot
    w217 = w84 * right_rod_e3_dot
    w218 = w216 + w71 * right_rod_e1_dot + w87 * right_rod_e2_dot + w217
    w219 = w218 * c53
    w220 = w68 * right_rod_e0_dot
    w221 = w84 * right_rod_e2_dot
    w222 = w220 + w75 * right_rod_e1_dot + w221 + w69 * right_rod_e3_dot
    w223 = w222 * c53
    w224 = w218 * w219 + w222 * w223
    w225 = w87 * right_rod_e0_dot + w84 * right_rod_e1_dot
    w226 = w225 + w77 * right_rod_e2_dot + w68 * right_rod_e3_dot
    w227 = w223 * w226
    w228 = w219 * w226
    w229 = w93 * w224 - (w76 - w78) * w227 - (w70 + w72) * w228
    w230 = right_rod_e1 * w69
    w231 = right_rod_e3 * w71
    w232 = w69 * right_rod_e0
    w233 = w79 * w224 - w227 * (1.0 - (w92 + w230)) - w228 * (w231 - w232)
    w234 = w73 * w224 - w227 * (w231 + w232) - w228 * (1.0 - (w91 + w230))
    w235 = w218 * c8
    w236 = w222 * c58
    w237 = w222 * w235 - w218 * w236
    w238 = w226 * c7
    w239 = w218 * w238 - w226 * w235
    w240 = w226 * w236 - w222 * w238
    w241 = w87 * w237 + w68 * w239 + w75 * w240
    w242 = w84 * w237 + w75 * w239 + w71 * w240
    w243 = w77 * w237 + w84 * w239 + w87 * w240
    w244 = w68 * w237 + w69 * w239 + w84 * w240
    w245 = w124 * left_rod_e0_dot
    w246 = w133 * left_rod_e3_dot
    w247 = w245 + w120 * left_rod_e1_dot + w136 * left_rod_e2_dot + w246
    w248 = w247 * c4
    w249 = w117 * left_rod_e0_dot
    w250 = w133 * left_rod_e2_dot
    w251 = w249 + w124 * left_rod_e1_dot + w250 + w118 * left_rod_e3_dot
    w252 = w251 * c4
    w253 = w247 * w248 + w251 * w252
    w254 = w136 * left_rod_e0_dot + w133 * left_rod_e1_dot
    w255 = w254 + w126 * left_rod_e2_dot + w117 * left_rod_e3_dot
    w256 = w252 * w255
    w257 = w248 * w255
    w258 = w142 * w253 - (w125 - w127) * w256 - (w119 + w121) * w257
    w259 = left_rod_e1 * w118
    w260 = left_rod_e3 * w120
    w261 = w118 * left_rod_e0
    w262 = w128 * w253 - w256 * (1.0 - (w141 + w259)) - w257 * (w260 - w261)
    w263 = w122 * w253 - w256 * (w260 + w261) - w257 * (1.0 - (w140 + w259))
    w264 = w247 * c1
    w265 = w251 * c57
    w266 = w251 * w264 - w247 * w265
    w267 = w255 * c0
    w268 = w247 * w267 - w255 * w264
    w269 = w255 * w265 - w251 * w267
    w270 = w136 * w266 + w117 * w268 + w124 * w269
    w271 = w133 * w266 + w124 * w268 + w120 * w269
    w272 = w126 * w266 + w133 * w268 + w136 * w269
    w273 = w117 * w266 + w118 * w268 + w133 * w269
    w274 = w33 * gravity_z
    w275 = w34 * gravity_z
    w276 = w35 * gravity_z
    w277 = w36 * gravity_z
    w278 = 1.0 - (slider_e2 * w54 + slider_e3 * w56)
    w279 = w278 * slider_right_x
    w280 = w93 * right_rod_middle_x
    w281 = slider_x + w279 - (right_rod_x + w280)
    w282 = slider_e2 * w61 + slider_e0 * w56
    w283 = w282 * slider_right_x
    w284 = w79 * right_rod_middle_x
    w285 = slider_y + w283 - (right_rod_y + w284)
    w286 = slider_e3 * w61 - slider_e0 * w54
    w287 = w286 * slider_right_x
    w288 = w73 * right_rod_middle_x
    w289 = slider_z + w287 - (right_rod_z + w288)
    w290 = w281**2 + w285**2 + w289**2
    w291 = (1.0 - right_spring_free_length / ca.sqrt(w290)) * right_spring_stiffness
    w292 = w199 + (w198 + w56 * slider_e1_dot) + w49 * slider_e3_dot
    w293 = w202 + (w201 + w50 * slider_e1_dot + w61 * slider_e2_dot)
    w294 = w221 + (w220 + w77 * right_rod_e1_dot) + w87 * right_rod_e3_dot
    w295 = w217 + (w216 + w68 * right_rod_e1_dot + w69 * right_rod_e2_dot)
    w296 = w281 * (slider_x_dot + (w287 * w292 - w283 * w293) - (right_rod_x_dot + (w288 * w294 - w284 * w295)))
    w297 = w207 + w51 * slider_e2_dot + w54 * slider_e3_dot
    w298 = w225 + w75 * right_rod_e2_dot + w71 * right_rod_e3_dot
    w299 = w285 * (slider_y_dot + (w279 * w293 - w287 * w297) - (right_rod_y_dot + (w280 * w295 - w288 * w298)))
    w300 = w289 * (slider_z_dot + (w283 * w297 - w279 * w292) - (right_rod_z_dot + (w284 * w298 - w280 * w294)))
    w301 = (w296 + w299 + w300) / w290 * right_spring_damping
    w302 = w281 * w291 + w281 * w301
    w303 = w278 * slider_left_x
    w304 = w142 * left_rod_middle_x
    w305 = slider_x + w303 - (left_rod_x + w304)
    w306 = w282 * slider_left_x
    w307 = w128 * left_rod_middle_x
    w308 = slider_y + w306 - (left_rod_y + w307)
    w309 = w286 * slider_left_x
    w310 = w122 * left_rod_middle_x
    w311 = slider_z + w309 - (left_rod_z + w310)
    w312 = w305**2 + w308**2 + w311**2
    w313 = (1.0 - left_spring_free_length / ca.sqrt(w312)) * left_spring_stiffness
    w314 = w250 + (w249 + w126 * left_rod_e1_dot) + w136 * left_rod_e3_dot
    w315 = w246 + (w245 + w117 * left_rod_e1_dot + w118 * left_rod_e2_dot)
    w316 = w305 * (slider_x_dot + (w292 * w309 - w293 * w306) - (left_rod_x_dot + (w310 * w314 - w307 * w315)))
    w317 = w254 + w124 * left_rod_e2_dot + w120 * left_rod_e3_dot
    w318 = w308 * (slider_y_dot + (w293 * w303 - w297 * w309) - (left_rod_y_dot + (w304 * w315 - w310 * w317)))
    w319 = w311 * (slider_z_dot + (w297 * w306 - w292 * w303) - (left_rod_z_dot + (w307 * w317 - w304 * w314)))
    w320 = (w316 + w318 + w319) / w312 * left_spring_damping
    w321 = w305 * w313 + w305 * w320
    w322 = -(w302 + w321)
    w323 = w285 * w291 + w285 * w301
    w324 = w308 * w313 + w308 * w320
    w325 = -(w323 + w324)
    w326 = w289 * w291 + w289 * w301
    w327 = w311 * w313 + w311 * w320
    w328 = c18 - w326 - w327
    w329 = w51 * w283
    w330 = w49 * w287
    w331 = w50 * w279
    w332 = w51 * w306
    w333 = w49 * w309
    w334 = w50 * w303
    w335 = w302 * (w50 * w287 - w329) + w323 * (w51 * w279 - w330) + w326 * (w49 * w283 - w331) + (w321 * (w50 * w309 - w332) + w324 * (w51 * w303 - w333) + w327 * (w49 * w306 - w334))
    w336 = w52 * w287
    w337 = w52 * w283
    w338 = w52 * w309
    w339 = w52 * w306
    w340 = w302 * (w56 * w287 - w50 * w283) + w323 * (w331 - w336) + w326 * (w337 - w56 * w279) + (w321 * (w56 * w309 - w50 * w306) + w324 * (w334 - w338) + w327 * (w339 - w56 * w303))
    w341 = w52 * w279
    w342 = w52 * w303
    w343 = w302 * (w336 - w61 * w283) + w323 * (w61 * w279 - w51 * w287) + w326 * (w329 - w341) + (w321 * (w338 - w61 * w306) + w324 * (w61 * w303 - w51 * w309) + w327 * (w332 - w342))
    w344 = w302 * (w330 - w337) + w323 * (w341 - w54 * w287) + w326 * (w54 * w283 - w49 * w279) + (w321 * (w333 - w339) + w324 * (w342 - w54 * w309) + w327 * (w54 * w306 - w49 * w303))
    w345 = w326 + c87
    w346 = w75 * w284
    w347 = w87 * w288
    w348 = w68 * w280
    w349 = w101 * gravity_z + (w302 * (w68 * w288 - w346) + w323 * (w75 * w280 - w347) + w326 * (w87 * w284 - w348))
    w350 = w84 * w288
    w351 = w84 * w284
    w352 = w102 * gravity_z + (w302 * (w77 * w288 - w68 * w284) + w323 * (w348 - w350) + w326 * (w351 - w77 * w280))
    w353 = w84 * w280
    w354 = w103 * gravity_z + (w302 * (w350 - w69 * w284) + w323 * (w69 * w280 - w75 * w288) + w326 * (w346 - w353))
    w355 = w104 * gravity_z + (w302 * (w347 - w351) + w323 * (w353 - w71 * w288) + w326 * (w71 * w284 - w87 * w280))
    w356 = w327 + c88
    w357 = w124 * w307
    w358 = w136 * w310
    w359 = w117 * w304
    w360 = w150 * gravity_z + (w321 * (w117 * w310 - w357) + w324 * (w124 * w304 - w358) + w327 * (w136 * w307 - w359))
    w361 = w133 * w310
    w362 = w133 * w307
    w363 = w151 * gravity_z + (w321 * (w126 * w310 - w117 * w307) + w324 * (w359 - w361) + w327 * (w362 - w126 * w304))
    w364 = w133 * w304
    w365 = w152 * gravity_z + (w321 * (w361 - w118 * w307) + w324 * (w118 * w304 - w124 * w310) + w327 * (w357 - w364))
    w366 = w153 * gravity_z + (w321 * (w358 - w362) + w324 * (w364 - w120 * w310) + w327 * (w120 * w307 - w136 * w304))
    w367 = w10 * height_travel
    w368 = w7 * w367
    w369 = w5 * height_travel
    w370 = w19 * w369
    w371 = w25 * height_travel
    w372 = w0 * w371
    w373 = right_swing_angle / 2.0
    w374 = ca.cos(w373)
    w375 = w374 * c89
    w376 = w374 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0 - w374 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w377 = -w376
    w378 = ca.sin(w373)
    w379 = w378 * c33
    w380 = w378 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w378 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w381 = -w380
    w382 = w186 * shaft_right_x + w5 * shaft_right_z
    w383 = w184 * shaft_right_x + w10 * shaft_right_z
    w384 = w7 * w383
    w385 = w175 * shaft_right_x + w25 * shaft_right_z
    w386 = w19 * w382
    w387 = w0 * w385
    w388 = left_swing_angle / 2.0
    w389 = ca.sin(w388)
    w390 = w389 * c35
    w391 = -w390
    w392 = ca.cos(w388)
    w393 = w392 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0 - w392 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0
    w394 = -w393
    w395 = w392 * c34
    w396 = -w395
    w397 = w186 * shaft_left_x + w5 * shaft_left_z
    w398 = w184 * shaft_left_x + w10 * shaft_left_z
    w399 = w7 * w398
    w400 = w175 * shaft_left_x + w25 * shaft_left_z
    w401 = w19 * w397
    w402 = w0 * w400
    w403 = w16 * w369
    w404 = w16 * w367
    w405 = w16 * w382
    w406 = w16 * w383
    w407 = w16 * w397
    w408 = w16 * w398
    w409 = w16 * w371
    w410 = -w379
    w411 = w16 * w385
    w412 = w16 * w400
    w413 = spin_angle / 2.0
    w414 = ca.sin(w413)
    w415 = ca.cos(w413)
    w416 = w378 / 2.0
    w417 = w416 * c32
    w418 = w416 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w416 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w419 = w374 / 2.0
    w420 = w419 * c33
    w421 = w419 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w419 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w422 = w392 / 2.0
    w423 = w422 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w422 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w424 = w422 * c35
    w425 = w389 / 2.0
    w426 = w425 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w425 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w427 = w425 * c34
    w428 = (spin_angle_dot / 2.0)**2
    w429 = w167 + (w166 + w14 * shaft_e1_dot) + w19 * shaft_e3_dot
    w430 = w170 + w7 * shaft_e2_dot + w3 * shaft_e3_dot
    w431 = w10 * w430 - w25 * w429
    w432 = w177 + (w176 + w0 * shaft_e1_dot + w1 * shaft_e2_dot)
    w433 = w25 * w432 - w5 * w430
    w434 = 2 * height_travel_dot
    w435 = w5 * w429 - w10 * w432
    w436 = right_swing_angle_dot / 2.0
    w437 = w436**2
    w438 = w374 * w437
    w439 = w436 * (w374 * w436) * c32
    w440 = w438 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w438 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w441 = w378 * w437
    w442 = w436 * (w378 * w436) * c33
    w443 = w441 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0 - w441 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0
    w444 = w416 * right_swing_angle_dot
    w445 = w444 * c32
    w446 = w444 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0 - w444 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0
    w447 = w419 * right_swing_angle_dot
    w448 = w447 * c33
    w449 = w447 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w447 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w450 = shaft_e0_dot * w445 + (shaft_e1_dot * w446 - shaft_e2_dot * w448 + shaft_e3_dot * w449)
    w451 = shaft_e0_dot * w446 - shaft_e1_dot * w445 + (shaft_e2_dot * w449 + shaft_e3_dot * w448)
    w452 = shaft_e3_dot * w446 - shaft_e1_dot * w449 - (shaft_e0_dot * w448 + shaft_e2_dot * w445)
    w453 = shaft_e0_dot * w449 - shaft_e3_dot * w445 - (shaft_e1_dot * w448 + shaft_e2_dot * w446)
    w454 = w383 * w430 - w385 * w429
    w455 = w385 * w432 - w382 * w430
    w456 = w382 * w429 - w383 * w432
    w457 = left_swing_angle_dot / 2.0
    w458 = w457**2
    w459 = w389 * w458
    w460 = w459 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0 - w459 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    w461 = w392 * w458
    w462 = w461 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w461 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w463 = w457 * (w389 * w457) * c35
    w464 = w457 * (w392 * w457) * c34
    w465 = w422 * left_swing_angle_dot
    w466 = w465 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w465 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w467 = w465 * c35
    w468 = w425 * left_swing_angle_dot
    w469 = w468 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0 - w468 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0
    w470 = w468 * c34
    w471 = shaft_e0_dot * w466 - (shaft_e1_dot * w467 + shaft_e2_dot * w469 - shaft_e3_dot * w470)
    w472 = shaft_e0_dot * w467 + shaft_e1_dot * w466 - (shaft_e2_dot * w470 + shaft_e3_dot * w469)
    w473 = shaft_e0_dot * w469 + shaft_e2_dot * w466 + (shaft_e3_dot * w467 + shaft_e1_dot * w470)
    w474 = shaft_e3_dot * w466 - shaft_e0_dot * w470 + (shaft_e1_dot * w469 - shaft_e2_dot * w467)
    w475 = w398 * w430 - w400 * w429
    w476 = w400 * w432 - w397 * w430
    w477 = w397 * w429 - w398 * w432
    w478 = w389 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0 - w389 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0
    # outputs
    M = ca.SX(32, 32)
    # shaft.x
    M[0, 0] = shaft_mass
    M[0, 3] = w13
    M[0, 4] = w15
    M[0, 5] = w18
    M[0, 6] = w22
    # shaft.y
    M[1, 1] = shaft_mass
    M[1, 3] = w27
    M[1, 4] = w29
    M[1, 5] = w30
    M[1, 6] = w32
    # shaft.z
    M[2, 2] = shaft_mass
    M[2, 3] = w33
    M[2, 4] = w34
    M[2, 5] = w35
    M[2, 6] = w36
    # shaft.e0
    M[3, 0] = w13
    M[3, 1] = w27
    M[3, 2] = w33
    M[3, 3] = w19 * (w19 * c63) + w0 * (w0 * c64) + w7 * (w7 * c65)
    M[3, 4] = w38
    M[3, 5] = w41
    M[3, 6] = w45
    # shaft.e1
    M[4, 0] = w15
    M[4, 1] = w29
    M[4, 2] = w34
    M[4, 3] = w38
    M[4, 4] = w16 * w37 + w7 * (w7 * c64) + w3 * (w3 * c65)
    M[4, 5] = w46
    M[4, 6] = w47
    # shaft.e2
    M[5, 0] = w18
    M[5, 1] = w30
    M[5, 2] = w35
    M[5, 3] = w41
    M[5, 4] = w46
    M[5, 5] = w14 * (w14 * c63) + w16 * w39 + w19 * w40
    M[5, 6] = w48
    # shaft.e3
    M[6, 0] = w22
    M[6, 1] = w32
    M[6, 2] = w36
    M[6, 3] = w45
    M[6, 4] = w47
    M[6, 5] = w48
    M[6, 6] = w0 * w42 + w1 * w43 + w16 * w44
    # slider.x
    M[7, 7] = slider_mass
    # slider.y
    M[8, 8] = slider_mass
    # slider.z
    M[9, 9] = slider_mass
    # slider.e0
    M[10, 10] = w49 * (w49 * c70) + w50 * (w50 * c71) + w51 * (w51 * c72)
    M[10, 11] = w55
    M[10, 12] = w59
    M[10, 13] = w64
    # slider.e1
    M[11, 10] = w55
    M[11, 11] = w52 * w53 + w51 * (w51 * c71) + w54 * (w54 * c72)
    M[11, 12] = w65
    M[11, 13] = w66
    # slider.e2
    M[12, 10] = w59
    M[12, 11] = w65
    M[12, 12] = w56 * (w56 * c70) + w52 * w57 + w49 * w58
    M[12, 13] = w67
    # slider.e3
    M[13, 10] = w64
    M[13, 11] = w66
    M[13, 12] = w67
    M[13, 13] = w50 * w60 + w61 * w62 + w52 * w63
    # right_rod.x
    M[14, 14] = right_rod_mass
    M[14, 17] = w82
    M[14, 18] = w83
    M[14, 19] = w86
    M[14, 20] = w90
    # right_rod.y
    M[15, 15] = right_rod_mass
    M[15, 17] = w95
    M[15, 18] = w97
    M[15, 19] = w98
    M[15, 20] = w100
    # right_rod.z
    M[16, 16] = right_rod_mass
    M[16, 17] = w101
    M[16, 18] = w102
    M[16, 19] = w103
    M[16, 20] = w104
    # right_rod.e0
    M[17, 14] = w82
    M[17, 15] = w95
    M[17, 16] = w101
    M[17, 17] = w87 * (w87 * c76) + w68 * (w68 * c15) + w75 * (w75 * c77)
    M[17, 18] = w106
    M[17, 19] = w109
    M[17, 20] = w113
    # right_rod.e1
    M[18, 14] = w83
    M[18, 15] = w97
    M[18, 16] = w102
    M[18, 17] = w106
    M[18, 18] = w84 * w105 + w75 * (w75 * c15) + w71 * (w71 * c77)
    M[18, 19] = w114
    M[18, 20] = w115
    # right_rod.e2
    M[19, 14] = w86
    M[19, 15] = w98
    M[19, 16] = w103
    M[19, 17] = w109
    M[19, 18] = w114
    M[19, 19] = w77 * (w77 * c76) + w84 * w107 + w87 * w108
    M[19, 20] = w116
    # right_rod.e3
    M[20, 14] = w90
    M[20, 15] = w100
    M[20, 16] = w104
    M[20, 17] = w113
    M[20, 18] = w115
    M[20, 19] = w116
    M[20, 20] = w68 * w110 + w69 * w111 + w84 * w112
    # left_rod.x
    M[21, 21] = left_rod_mass
    M[21, 24] = w131
    M[21, 25] = w132
    M[21, 26] = w135
    M[21, 27] = w139
    # left_rod.y
    M[22, 22] = left_rod_mass
    M[22, 24] = w144
    M[22, 25] = w146
    M[22, 26] = w147
    M[22, 27] = w149
    # left_rod.z
    M[23, 23] = left_rod_mass
    M[23, 24] = w150
    M[23, 25] = w151
    M[23, 26] = w152
    M[23, 27] = w153
    # left_rod.e0
    M[24, 21] = w131
    M[24, 22] = w144
    M[24, 23] = w150
    M[24, 24] = w136 * (w136 * c81) + w117 * (w117 * c16) + w124 * (w124 * c82)
    M[24, 25] = w155
    M[24, 26] = w158
    M[24, 27] = w162
    # left_rod.e1
    M[25, 21] = w132
    M[25, 22] = w146
    M[25, 23] = w151
    M[25, 24] = w155
    M[25, 25] = w133 * w154 + w124 * (w124 * c16) + w120 * (w120 * c82)
    M[25, 26] = w163
    M[25, 27] = w164
    # left_rod.e2
    M[26, 21] = w135
    M[26, 22] = w147
    M[26, 23] = w152
    M[26, 24] = w158
    M[26, 25] = w163
    M[26, 26] = w126 * (w126 * c81) + w133 * w156 + w136 * w157
    M[26, 27] = w165
    # left_rod.e3
    M[27, 21] = w139
    M[27, 22] = w149
    M[27, 23] = w153
    M[27, 24] = w162
    M[27, 25] = w164
    M[27, 26] = w165
    M[27, 27] = w117 * w159 + w118 * w160 + w133 * w161
    K = ca.SX(32, 32)
    Q_v = ca.vertcat(
        w183,  # shaft.x
        w185,  # shaft.y
        w187,  # shaft.z
        w194,  # shaft.e0
        w195,  # shaft.e1
        w196,  # shaft.e2
        w197,  # shaft.e3
        0.0,  # slider.x
        0.0,  # slider.y
        0.0,  # slider.z
        w212,  # slider.e0
        w213,  # slider.e1
        w214,  # slider.e2
        w215,  # slider.e3
        w229,  # right_rod.x
        w233,  # right_rod.y
        w234,  # right_rod.z
        w241,  # right_rod.e0
        w242,  # right_rod.e1
        w243,  # right_rod.e2
        w244,  # right_rod.e3
        w258,  # left_rod.x
        w262,  # left_rod.y
        w263,  # left_rod.z
        w270,  # left_rod.e0
        w271,  # left_rod.e1
        w272,  # left_rod.e2
        w273,  # left_rod.e3
        0.0,  # spin.angle
        0.0,  # height.travel
        0.0,  # right_swing.angle
        0.0,  # left_swing.angle
    )
    Q_F = ca.vertcat(
        0.0,  # shaft.x
        0.0,  # shaft.y
        c86,  # shaft.z
        w274,  # shaft.e0
        w275,  # shaft.e1
        w276,  # shaft.e2
        w277,  # shaft.e3
        w322,  # slider.x
        w325,  # slider.y
        w328,  # slider.z
        -w335,  # slider.e0
        -w340,  # slider.e1
        -w343,  # slider.e2
        -w344,  # slider.e3
        w302,  # right_rod.x
        w323,  # right_rod.y
        w345,  # right_rod.z
        w349,  # right_rod.e0
        w352,  # right_rod.e1
        w354,  # right_rod.e2
        w355,  # right_rod.e3
        w321,  # left_rod.x
        w324,  # left_rod.y
        w356,  # left_rod.z
        w360,  # left_rod.e0
        w363,  # left_rod.e1
        w365,  # left_rod.e2
        w366,  # left_rod.e3
        0.0,  # spin.angle
        0.0,  # height.travel
        0.0,  # right_swing.angle
        0.0,  # left_swing.angle
    )
    Q_star = ca.vertcat(
        w183,  # shaft.x
        w185,  # shaft.y
        w187 + c86,  # shaft.z
        w194 + w274,  # shaft.e0
        w195 + w275,  # shaft.e1
        w196 + w276,  # shaft.e2
        w197 + w277,  # shaft.e3
        w322,  # slider.x
        w325,  # slider.y
        w328,  # slider.z
        w212 - w335,  # slider.e0
        w213 - w340,  # slider.e1
        w214 - w343,  # slider.e2
        w215 - w344,  # slider.e3
        w229 + w302,  # right_rod.x
        w233 + w323,  # right_rod.y
        w234 + w345,  # right_rod.z
        w241 + w349,  # right_rod.e0
        w242 + w352,  # right_rod.e1
        w243 + w354,  # right_rod.e2
        w244 + w355,  # right_rod.e3
        w258 + w321,  # left_rod.x
        w262 + w324,  # left_rod.y
        w263 + w356,  # left_rod.z
        w270 + w360,  # left_rod.e0
        w271 + w363,  # left_rod.e1
        w272 + w365,  # left_rod.e2
        w273 + w366,  # left_rod.e3
        0.0,  # spin.angle
        0.0,  # height.travel
        0.0,  # right_swing.angle
        0.0,  # left_swing.angle
    )
    C_q = ca.SX(28, 32)
    # spin.e0
    C_q[0, 3] = 1.0
    C_q[0, 28] = w414 / 2.0
    # spin.e1
    C_q[1, 4] = 1.0
    # spin.e2
    C_q[2, 5] = 1.0
    # spin.e3
    C_q[3, 6] = 1.0
    C_q[3, 28] = -(w415 / 2.0)
    # spin.x
    C_q[4, 0] = 1.0
    # spin.y
    C_q[5, 1] = 1.0
    # spin.z
    C_q[6, 2] = 1.0
    # height.e0
    C_q[7, 3] = -1.0
    C_q[7, 10] = 1.0
    # height.e1
    C_q[8, 4] = -1.0
    C_q[8, 11] = 1.0
    # height.e2
    C_q[9, 5] = -1.0
    C_q[9, 12] = 1.0
    # height.e3
    C_q[10, 6] = -1.0
    C_q[10, 13] = 1.0
    # height.x
    C_q[11, 0] = -1.0
    C_q[11, 3] = w368 - w0 * w369
    C_q[11, 4] = w0 * w367 - w14 * w369
    C_q[11, 5] = w1 * w367 - w403
    C_q[11, 6] = w404 - w370
    C_q[11, 7] = 1.0
    C_q[11, 29] = -w25
    # height.y
    C_q[12, 1] = -1.0
    C_q[12, 3] = w370 - w7 * w371
    C_q[12, 4] = w403 - w372
    C_q[12, 5] = w7 * w369 - w1 * w371
    C_q[12, 6] = w3 * w369 - w409
    C_q[12, 8] = 1.0
    C_q[12, 29] = -w10
    # height.z
    C_q[13, 2] = -1.0
    C_q[13, 3] = w372 - w19 * w367
    C_q[13, 4] = w14 * w371 - w404
    C_q[13, 5] = w409 - w368
    C_q[13, 6] = w19 * w371 - w3 * w367
    C_q[13, 9] = 1.0
    C_q[13, 29] = -w5
    # right_swing.e0
    C_q[14, 3] = w375
    C_q[14, 4] = w376
    C_q[14, 5] = w410
    C_q[14, 6] = w380
    C_q[14, 17] = 1.0
    C_q[14, 30] = shaft_e0 * w417 + (shaft_e1 * w418 - shaft_e2 * w420 + shaft_e3 * w421)
    # right_swing.e1
    C_q[15, 3] = w377
    C_q[15, 4] = w375
    C_q[15, 5] = w381
    C_q[15, 6] = w410
    C_q[15, 18] = 1.0
    C_q[15, 30] = shaft_e1 * w417 - shaft_e0 * w418 - (shaft_e2 * w421 + shaft_e3 * w420)
    # right_swing.e2
    C_q[16, 3] = w379
    C_q[16, 4] = w380
    C_q[16, 5] = w375
    C_q[16, 6] = w377
    C_q[16, 19] = 1.0
    C_q[16, 30] = shaft_e0 * w420 + shaft_e2 * w417 - (shaft_e3 * w418 - shaft_e1 * w421)
    # right_swing.e3
    C_q[17, 3] = w381
    C_q[17, 4] = w379
    C_q[17, 5] = w376
    C_q[17, 6] = w375
    C_q[17, 20] = 1.0
    C_q[17, 30] = shaft_e1 * w420 + shaft_e2 * w418 - (shaft_e0 * w421 - shaft_e3 * w417)
    # right_swing.x
    C_q[18, 0] = -1.0
    C_q[18, 3] = w384 - w0 * w382
    C_q[18, 4] = w0 * w383 - w14 * w382
    C_q[18, 5] = w1 * w383 - w405
    C_q[18, 6] = w406 - w386
    C_q[18, 14] = 1.0
    # right_swing.y
    C_q[19, 1] = -1.0
    C_q[19, 3] = w386 - w7 * w385
    C_q[19, 4] = w405 - w387
    C_q[19, 5] = w7 * w382 - w1 * w385
    C_q[19, 6] = w3 * w382 - w411
    C_q[19, 15] = 1.0
    # right_swing.z
    C_q[20, 2] = -1.0
    C_q[20, 3] = w387 - w19 * w383
    C_q[20, 4] = w14 * w385 - w406
    C_q[20, 5] = w411 - w384
    C_q[20, 6] = w19 * w385 - w3 * w383
    C_q[20, 16] = 1.0
    # left_swing.e0
    C_q[21, 3] = w478
    C_q[21, 4] = w390
    C_q[21, 5] = w393
    C_q[21, 6] = w395
    C_q[21, 24] = 1.0
    C_q[21, 31] = shaft_e1 * w424 + shaft_e2 * w426 - shaft_e3 * w427 - shaft_e0 * w423
    # left_swing.e1
    C_q[22, 3] = w391
    C_q[22, 4] = w478
    C_q[22, 5] = w396
    C_q[22, 6] = w393
    C_q[22, 25] = 1.0
    C_q[22, 31] = shaft_e2 * w427 + shaft_e3 * w426 - (shaft_e0 * w424 + shaft_e1 * w423)
    # left_swing.e2
    C_q[23, 3] = w394
    C_q[23, 4] = w395
    C_q[23, 5] = w478
    C_q[23, 6] = w391
    C_q[23, 26] = 1.0
    C_q[23, 31] = -(shaft_e0 * w426 + shaft_e2 * w423 + (shaft_e3 * w424 + shaft_e1 * w427))
    # left_swing.e3
    C_q[24, 3] = w396
    C_q[24, 4] = w394
    C_q[24, 5] = w390
    C_q[24, 6] = w478
    C_q[24, 27] = 1.0
    C_q[24, 31] = shaft_e0 * w427 - shaft_e3 * w423 - (shaft_e1 * w426 - shaft_e2 * w424)
    # left_swing.x
    C_q[25, 0] = -1.0
    C_q[25, 3] = w399 - w0 * w397
    C_q[25, 4] = w0 * w398 - w14 * w397
    C_q[25, 5] = w1 * w398 - w407
    C_q[25, 6] = w408 - w401
    C_q[25, 21] = 1.0
    # left_swing.y
    C_q[26, 1] = -1.0
    C_q[26, 3] = w401 - w7 * w400
    C_q[26, 4] = w407 - w402
    C_q[26, 5] = w7 * w397 - w1 * w400
    C_q[26, 6] = w3 * w397 - w412
    C_q[26, 22] = 1.0
    # left_swing.z
    C_q[27, 2] = -1.0
    C_q[27, 3] = w402 - w19 * w398
    C_q[27, 4] = w14 * w400 - w408
    C_q[27, 5] = w412 - w399
    C_q[27, 6] = w19 * w400 - w3 * w398
    C_q[27, 23] = 1.0
    gamma = ca.vertcat(
        -(w415 * w428),  # spin.e0
        0.0,  # spin.e1
        0.0,  # spin.e2
        -(w414 * w428),  # spin.e3
        0.0,  # spin.x
        0.0,  # spin.y
        0.0,  # spin.z
        0.0,  # height.e0
        0.0,  # height.e1
        0.0,  # height.e2
        0.0,  # height.e3
        height_travel * (w429 * w431 - w432 * w433) + w434 * w435,  # height.x
        height_travel * (w432 * w435 - w430 * w431) + w433 * w434,  # height.y
        height_travel * (w430 * w433 - w429 * w435) + w431 * w434,  # height.z
        -(w450 + (shaft_e0 * w439 + (shaft_e1 * w440 + shaft_e2 * w442 + shaft_e3 * w443) + w450)),  # right_swing.e0
        w451 + (shaft_e0 * w440 - shaft_e1 * w439 + (shaft_e2 * w443 - shaft_e3 * w442) + w451),  # right_swing.e1
        w452 + (shaft_e0 * w442 - shaft_e2 * w439 + (shaft_e3 * w440 - shaft_e1 * w443) + w452),  # right_swing.e2
        w453 + (shaft_e0 * w443 - shaft_e3 * w439 + (shaft_e1 * w442 - shaft_e2 * w440) + w453),  # right_swing.e3
        w429 * w454 - w432 * w455,  # right_swing.x
        w432 * w456 - w430 * w454,  # right_swing.y
        w430 * w455 - w429 * w456,  # right_swing.z
        w471 + (shaft_e0 * w460 - (shaft_e2 * w462 - shaft_e1 * w463 - shaft_e3 * w464) + w471),  # left_swing.e0
        w472 + (shaft_e1 * w460 - shaft_e0 * w463 - (shaft_e2 * w464 + shaft_e3 * w462) + w472),  # left_swing.e1
        w473 + (shaft_e0 * w462 + shaft_e2 * w460 + (shaft_e1 * w464 - shaft_e3 * w463) + w473),  # left_swing.e2
        w474 + (shaft_e3 * w460 - shaft_e0 * w464 + (shaft_e1 * w462 + shaft_e2 * w463) + w474),  # left_swing.e3
        w429 * w475 - w432 * w476,  # left_swing.x
        w432 * w477 - w430 * w475,  # left_swing.y
        w430 * w476 - w429 * w477,  # left_swing.z
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 32) [mixed]: rates of all coordinates
    takes q_ddot (n = 32) [mixed]: accelerations of all coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 28) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    1945 operations.
    """
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    q_ddot = ca.SX.sym("q_ddot", 32)
    c = ca.SX.sym("c", 93)
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    shaft_x_ddot = q_ddot[0]
    shaft_y_ddot = q_ddot[1]
    shaft_z_ddot = q_ddot[2]
    shaft_e0_ddot = q_ddot[3]
    shaft_e1_ddot = q_ddot[4]
    shaft_e2_ddot = q_ddot[5]
    shaft_e3_ddot = q_ddot[6]
    slider_x_ddot = q_ddot[7]
    slider_y_ddot = q_ddot[8]
    slider_z_ddot = q_ddot[9]
    slider_e0_ddot = q_ddot[10]
    slider_e1_ddot = q_ddot[11]
    slider_e2_ddot = q_ddot[12]
    slider_e3_ddot = q_ddot[13]
    right_rod_x_ddot = q_ddot[14]
    right_rod_y_ddot = q_ddot[15]
    right_rod_z_ddot = q_ddot[16]
    right_rod_e0_ddot = q_ddot[17]
    right_rod_e1_ddot = q_ddot[18]
    right_rod_e2_ddot = q_ddot[19]
    right_rod_e3_ddot = q_ddot[20]
    left_rod_x_ddot = q_ddot[21]
    left_rod_y_ddot = q_ddot[22]
    left_rod_z_ddot = q_ddot[23]
    left_rod_e0_ddot = q_ddot[24]
    left_rod_e1_ddot = q_ddot[25]
    left_rod_e2_ddot = q_ddot[26]
    left_rod_e3_ddot = q_ddot[27]
    c0 = c[0]
    c1 = c[1]
    shaft_left_x = c[3]
    c4 = c[4]
    c7 = c[7]
    c8 = c[8]
    shaft_right_x = c[10]
    slider_mass = c[14]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    c18 = c[18]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    shaft_right_quaternion_0_0_0 = c[43]
    right_rod_hinge_quaternion_0_0_0 = c[44]
    shaft_right_quaternion_1_0_0 = c[45]
    right_rod_hinge_quaternion_1_0_0 = c[46]
    shaft_left_quaternion_2_0_0 = c[47]
    left_rod_hinge_quaternion_1_0_0 = c[48]
    shaft_left_quaternion_3_0_0 = c[49]
    left_rod_hinge_quaternion_0_0_0 = c[50]
    left_rod_mass = c[51]
    right_rod_mass = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    shaft_mass = c[60]
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
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    # intermediate terms (479)
    w0 = 2 * -shaft_e1
    w1 = 2 * -shaft_e2
    w2 = 2 * -shaft_e3
    w3 = 2 * shaft_e0
    w4 = 2 * shaft_e1
    w5 = shaft_e0_dot * w1 + shaft_e1_dot * w2 + shaft_e2_dot * w3 + shaft_e3_dot * w4
    w6 = 2 * shaft_e2
    w7 = shaft_e0_dot * w2 + shaft_e1_dot * w6 + w0 * shaft_e2_dot + w3 * shaft_e3_dot
    w8 = w7 * c62
    w9 = w5 * c56
    w10 = w5 * w8 - w7 * w9
    w11 = 2 * shaft_e3
    w12 = w0 * shaft_e0_dot + shaft_e1_dot * w3 + shaft_e2_dot * w11 + w1 * shaft_e3_dot
    w13 = w12 * c54
    w14 = w7 * w13 - w8 * w12
    w15 = w9 * w12 - w5 * w13
    w16 = shaft_e3 * w6
    w17 = shaft_e0 * w4
    w18 = w16 - w17
    w19 = w18 * c61
    w20 = shaft_e3 * w4
    w21 = shaft_e0 * w6
    w22 = w20 + w21
    w23 = w22 * c61
    w24 = w1 * w23
    w25 = w0 * w19 - w24
    w26 = shaft_e1 * w4
    w27 = shaft_e2 * w6
    w28 = 1.0 - (w26 + w27)
    w29 = w28 * c61
    w30 = w2 * w19
    w31 = w1 * w29 - w30
    w32 = w0 * w29
    w33 = w2 * w23 - w32
    w34 = w31 * shaft_x_ddot + w33 * shaft_y_ddot + w25 * shaft_z_ddot + (w0 * (w0 * c63) + w1 * (w1 * c64) + w2 * (w2 * c65)) * shaft_e0_ddot
    w35 = w3 * c63
    w36 = w0 * w35 + shaft_e2 * shaft_e3 * c66
    w37 = w3 * c64
    w38 = w0 * c65
    w39 = w1 * w37 + shaft_e1 * shaft_e3 * c67
    w40 = w1 * c63
    w41 = w4 * c64
    w42 = w3 * c65
    w43 = shaft_e1 * shaft_e2 * c68 + w2 * w42
    w44 = w0 * w10 + w1 * w14 + w2 * w15 + w25 * gravity_z - (w34 + w36 * shaft_e1_ddot + w39 * shaft_e2_ddot + w43 * shaft_e3_ddot)
    w45 = shaft_e2 * w4
    w46 = shaft_e0 * w11
    w47 = w45 + w46
    w48 = w47 * shaft_left_x + w18 * shaft_left_z
    w49 = shaft_e3 * w11
    w50 = 1.0 - (w27 + w49)
    w51 = w50 * shaft_left_x + w22 * shaft_left_z
    w52 = w1 * w51
    w53 = 2 * left_rod_e1
    w54 = w53 * left_rod_e3
    w55 = 2 * left_rod_e2
    w56 = w55 * left_rod_e0
    w57 = w54 - w56
    w58 = 2 * -left_rod_e3
    w59 = left_rod_e0_dot * w58
    w60 = 2 * -left_rod_e1
    w61 = 2 * left_rod_e0
    w62 = left_rod_e3_dot * w61
    w63 = w59 + w55 * left_rod_e1_dot + left_rod_e2_dot * w60 + w62
    w64 = w63 * c4
    w65 = 2 * -left_rod_e2
    w66 = left_rod_e0_dot * w65
    w67 = left_rod_e2_dot * w61
    w68 = w66 + w58 * left_rod_e1_dot + w67 + w53 * left_rod_e3_dot
    w69 = w68 * c4
    w70 = w63 * w64 + w68 * w69
    w71 = left_rod_e3 * w55
    w72 = w53 * left_rod_e0
    w73 = left_rod_e0_dot * w60 + left_rod_e1_dot * w61
    w74 = 2 * left_rod_e3
    w75 = w73 + left_rod_e2_dot * w74 + left_rod_e3_dot * w65
    w76 = w69 * w75
    w77 = left_rod_e1 * w53
    w78 = left_rod_e2 * w55
    w79 = w64 * w75
    w80 = 2 * slider_e2
    w81 = 2 * slider_e3
    w82 = 1.0 - (slider_e2 * w80 + slider_e3 * w81)
    w83 = w82 * slider_left_x
    w84 = left_rod_e3 * w74
    w85 = 1.0 - (w78 + w84)
    w86 = w85 * left_rod_middle_x
    w87 = slider_x + w83 - (left_rod_x + w86)
    w88 = 2 * slider_e1
    w89 = slider_e2 * w88 + w81 * slider_e0
    w90 = w89 * slider_left_x
    w91 = w53 * left_rod_e2
    w92 = left_rod_e0 * w74
    w93 = w91 + w92
    w94 = w93 * left_rod_middle_x
    w95 = slider_y + w90 - (left_rod_y + w94)
    w96 = slider_e3 * w88 - w80 * slider_e0
    w97 = w96 * slider_left_x
    w98 = w57 * left_rod_middle_x
    w99 = slider_z + w97 - (left_rod_z + w98)
    w100 = w87**2 + w95**2 + w99**2
    w101 = (1.0 - left_spring_free_length / ca.sqrt(w100)) * left_spring_stiffness
    w102 = 2 * -slider_e2
    w103 = slider_e0_dot * w102
    w104 = 2 * slider_e0
    w105 = slider_e2_dot * w104
    w106 = 2 * -slider_e1
    w107 = w103 + w81 * slider_e1_dot + w105 + slider_e3_dot * w106
    w108 = 2 * -slider_e3
    w109 = slider_e0_dot * w108
    w110 = w104 * slider_e3_dot
    w111 = w109 + w102 * slider_e1_dot + w88 * slider_e2_dot + w110
    w112 = w67 + (w66 + left_rod_e1_dot * w74) + w60 * left_rod_e3_dot
    w113 = w62 + (w59 + left_rod_e1_dot * w65 + w53 * left_rod_e2_dot)
    w114 = slider_e0_dot * w106 + slider_e1_dot * w104
    w115 = w114 + slider_e2_dot * w108 + w80 * slider_e3_dot
    w116 = w73 + w58 * left_rod_e2_dot + w55 * left_rod_e3_dot
    w117 = w87 * (slider_x_dot + (w97 * w107 - w90 * w111) - (left_rod_x_dot + (w98 * w112 - w94 * w113))) + w95 * (slider_y_dot + (w83 * w111 - w97 * w115) - (left_rod_y_dot + (w86 * w113 - w98 * w116)))
    w118 = w117 + w99 * (slider_z_dot + (w90 * w115 - w83 * w107) - (left_rod_z_dot + (w94 * w116 - w86 * w112)))
    w119 = w118 / w100 * left_spring_damping
    w120 = w99 * w101 + w99 * w119
    w121 = w93 * c4
    w122 = w85 * c4
    w123 = w65 * w122
    w124 = w60 * w121 - w123
    w125 = w61 * w121
    w126 = w125 - w74 * w122
    w127 = w58 * w121
    w128 = w61 * w122
    w129 = w127 - w128
    w130 = left_rod_z_ddot * left_rod_mass + w124 * left_rod_e0_ddot + w126 * left_rod_e1_ddot + w129 * left_rod_e2_ddot
    w131 = w55 * w121 - w60 * w122
    w132 = w57 * w70 - (w71 + w72) * w76 - (1.0 - (w77 + w78)) * w79 + (c88 + w120) - (w130 + w131 * left_rod_e3_ddot)
    w133 = w20 - w21
    w134 = w133 * shaft_left_x + w28 * shaft_left_z
    w135 = w0 * w134
    w136 = w95 * w101 + w95 * w119
    w137 = w57 * c4
    w138 = w60 * w137
    w139 = w58 * w122 - w138
    w140 = w61 * w137
    w141 = w123 - w140
    w142 = w53 * w122 - w58 * w137
    w143 = left_rod_y_ddot * left_rod_mass + left_rod_e0_ddot * w139 + left_rod_e1_ddot * w141 + left_rod_e2_ddot * w142
    w144 = w128 - w55 * w137
    w145 = w70 * w93 - w76 * (1.0 - (w77 + w84)) - w79 * (w71 - w72) + w136 - (w143 + left_rod_e3_ddot * w144)
    w146 = w2 * w48
    w147 = w87 * w101 + w87 * w119
    w148 = w65 * w137 - w127
    w149 = w74 * w137 - w65 * w121
    w150 = w140 - w53 * w121
    w151 = left_rod_x_ddot * left_rod_mass + left_rod_e0_ddot * w148 + left_rod_e1_ddot * w149 + left_rod_e2_ddot * w150
    w152 = w138 - w125
    w153 = w70 * w85 - w76 * (w91 - w92) - w79 * (w54 + w56) + w147 - (w151 + left_rod_e3_ddot * w152)
    w154 = left_swing_angle / 2.0
    w155 = ca.cos(w154)
    w156 = w155 * c34
    w157 = w63 * c1
    w158 = w68 * c57
    w159 = w68 * w157 - w63 * w158
    w160 = w75 * c0
    w161 = w63 * w160 - w75 * w157
    w162 = w75 * w158 - w68 * w160
    w163 = w60 * w98
    w164 = w61 * w94
    w165 = w61 * w86
    w166 = w131 * gravity_z + (w147 * (w163 - w164) + w136 * (w165 - w55 * w98) + w120 * (w55 * w94 - w60 * w86))
    w167 = w65 * c81
    w168 = w53 * c16
    w169 = w61 * c82
    w170 = left_rod_e1 * left_rod_e2 * c85 + w58 * w169
    w171 = left_rod_x_ddot * w152 + left_rod_y_ddot * w144 + left_rod_z_ddot * w131 + left_rod_e0_ddot * w170
    w172 = w58 * w168 + left_rod_e2 * left_rod_e0 * c84
    w173 = w74 * w167 + left_rod_e1 * left_rod_e0 * c83
    w174 = w171 + left_rod_e1_ddot * w172 + left_rod_e2_ddot * w173 + left_rod_e3_ddot * (w65 * w167 + w53 * w168 + w61 * w169)
    w175 = w65 * w159 + w53 * w161 + w61 * w162 + w166 - w174
    w176 = w44 + (w0 * w48 - w52) * w132 + (w2 * w51 - w135) * w145 + (w1 * w134 - w146) * w153 + w156 * w175
    w177 = w155 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_0_0_0 - w155 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_1_0_0
    w178 = w61 * w98
    w179 = w58 * w94
    w180 = w129 * gravity_z + (w147 * (w178 - w53 * w94) + w136 * (w53 * w86 - w58 * w98) + w120 * (w179 - w165))
    w181 = w61 * c16
    w182 = w60 * c82
    w183 = w65 * w181 + left_rod_e1 * left_rod_e3 * c84
    w184 = left_rod_x_ddot * w150 + left_rod_y_ddot * w142 + left_rod_z_ddot * w129 + left_rod_e0_ddot * w183
    w185 = left_rod_e3 * left_rod_e0 * c85 + w55 * w182
    w186 = w184 + left_rod_e1_ddot * w185 + left_rod_e2_ddot * (w74 * (w74 * c81) + w61 * w181 + w60 * w182)
    w187 = w74 * w159 + w61 * w161 + w60 * w162 + w180 - (w186 + left_rod_e3_ddot * w173)
    w188 = ca.sin(w154)
    w189 = w188 * c35
    w190 = w65 * w86
    w191 = w126 * gravity_z + (w147 * (w74 * w98 - w65 * w94) + w136 * (w190 - w178) + w120 * (w164 - w74 * w86))
    w192 = w61 * c81
    w193 = w60 * w192 + left_rod_e3 * left_rod_e2 * c83
    w194 = left_rod_x_ddot * w149 + left_rod_y_ddot * w141 + left_rod_z_ddot * w126 + left_rod_e0_ddot * w193
    w195 = w194 + left_rod_e1_ddot * (w61 * w192 + w58 * (w58 * c16) + w55 * (w55 * c82)) + left_rod_e2_ddot * w185
    w196 = w61 * w159 + w58 * w161 + w55 * w162 + w191 - (w195 + left_rod_e3_ddot * w172)
    w197 = w188 * shaft_left_quaternion_2_0_0 * left_rod_hinge_quaternion_1_0_0 - w188 * shaft_left_quaternion_3_0_0 * left_rod_hinge_quaternion_0_0_0
    w198 = w124 * gravity_z + (w147 * (w65 * w98 - w179) + w136 * (w58 * w86 - w163) + w120 * (w60 * w94 - w190))
    w199 = left_rod_x_ddot * w148 + left_rod_y_ddot * w139 + left_rod_z_ddot * w124 + left_rod_e0_ddot * (w60 * (w60 * c81) + w65 * (w65 * c16) + w58 * (w58 * c82))
    w200 = w60 * w159 + w65 * w161 + w58 * w162 + w198 - (w199 + left_rod_e1_ddot * w193 + left_rod_e2_ddot * w183 + left_rod_e3_ddot * w170)
    w201 = w47 * shaft_right_x + w18 * shaft_right_z
    w202 = w50 * shaft_right_x + w22 * shaft_right_z
    w203 = w1 * w202
    w204 = 2 * right_rod_e1
    w205 = w204 * right_rod_e3
    w206 = 2 * right_rod_e2
    w207 = w206 * right_rod_e0
    w208 = w205 - w207
    w209 = 2 * -right_rod_e3
    w210 = right_rod_e0_dot * w209
    w211 = 2 * -right_rod_e1
    w212 = 2 * right_rod_e0
    w213 = right_rod_e3_dot * w212
    w214 = w210 + w206 * right_rod_e1_dot + right_rod_e2_dot * w211 + w213
    w215 = w214 * c53
    w216 = 2 * -right_rod_e2
    w217 = right_rod_e0_dot * w216
    w218 = right_rod_e2_dot * w212
    w219 = w217 + w209 * right_rod_e1_dot + w218 + w204 * right_rod_e3_dot
    w220 = w219 * c53
    w221 = w214 * w215 + w219 * w220
    w222 = right_rod_e3 * w206
    w223 = w204 * right_rod_e0
    w224 = right_rod_e0_dot * w211 + right_rod_e1_dot * w212
    w225 = 2 * right_rod_e3
    w226 = w224 + right_rod_e2_dot * w225 + right_rod_e3_dot * w216
    w227 = w220 * w226
    w228 = right_rod_e1 * w204
    w229 = right_rod_e2 * w206
    w230 = w215 * w226
    w231 = w82 * slider_right_x
    w232 = right_rod_e3 * w225
    w233 = 1.0 - (w229 + w232)
    w234 = w233 * right_rod_middle_x
    w235 = slider_x + w231 - (right_rod_x + w234)
    w236 = w89 * slider_right_x
    w237 = w204 * right_rod_e2
    w238 = right_rod_e0 * w225
    w239 = w237 + w238
    w240 = w239 * right_rod_middle_x
    w241 = slider_y + w236 - (right_rod_y + w240)
    w242 = w96 * slider_right_x
    w243 = w208 * right_rod_middle_x
    w244 = slider_z + w242 - (right_rod_z + w243)
    w245 = w235**2 + w241**2 + w244**2
    w246 = (1.0 - right_spring_free_length / ca.sqrt(w245)) * right_spring_stiffness
    w247 = w218 + (w217 + right_rod_e1_dot * w225) + w211 * right_rod_e3_dot
    w248 = w213 + (w210 + right_rod_e1_dot * w216 + w204 * right_rod_e2_dot)
    w249 = w235 * (slider_x_dot + (w107 * w242 - w111 * w236) - (right_rod_x_dot + (w243 * w247 - w240 * w248)))
    w250 = w224 + w209 * right_rod_e2_dot + w206 * right_rod_e3_dot
    w251 = w241 * (slider_y_dot + (w111 * w231 - w115 * w242) - (right_rod_y_dot + (w234 * w248 - w243 * w250)))
    w252 = w244 * (slider_z_dot + (w115 * w236 - w107 * w231) - (right_rod_z_dot + (w240 * w250 - w234 * w247)))
    w253 = (w249 + w251 + w252) / w245 * right_spring_damping
    w254 = w244 * w246 + w244 * w253
    w255 = w239 * c53
    w256 = w233 * c53
    w257 = w216 * w256
    w258 = w211 * w255 - w257
    w259 = w212 * w255
    w260 = w259 - w225 * w256
    w261 = w209 * w255
    w262 = w212 * w256
    w263 = w261 - w262
    w264 = right_rod_z_ddot * right_rod_mass + w258 * right_rod_e0_ddot + w260 * right_rod_e1_ddot + w263 * right_rod_e2_ddot
    w265 = w206 * w255 - w211 * w256
    w266 = w208 * w221 - (w222 + w223) * w227 - (1.0 - (w228 + w229)) * w230 + (c87 + w254) - (w264 + w265 * right_rod_e3_ddot)
    w267 = w133 * shaft_right_x + w28 * shaft_right_z
    w268 = w0 * w267
    w269 = w241 * w246 + w241 * w253
    w270 = w208 * c53
    w271 = w211 * w270
    w272 = w209 * w256 - w271
    w273 = w212 * w270
    w274 = w257 - w273
    w275 = w204 * w256 - w209 * w270
    w276 = right_rod_y_ddot * right_rod_mass + right_rod_e0_ddot * w272 + right_rod_e1_ddot * w274 + right_rod_e2_ddot * w275
    w277 = w262 - w206 * w270
    w278 = w221 * w239 - w227 * (1.0 - (w228 + w232)) - w230 * (w222 - w223) + w269 - (w276 + right_rod_e3_ddot * w277)
    w279 = w176 + w177 * w187 + w189 * w196 + w197 * w200 + (w0 * w201 - w203) * w266 + (w2 * w202 - w268) * w278
    w280 = w2 * w201
    w281 = w235 * w246 + w235 * w253
    w282 = w216 * w270 - w261
    w283 = w225 * w270 - w216 * w255
    w284 = w273 - w204 * w255
    w285 = right_rod_x_ddot * right_rod_mass + right_rod_e0_ddot * w282 + right_rod_e1_ddot * w283 + right_rod_e2_ddot * w284
    w286 = w271 - w259
    w287 = w221 * w233 - w227 * (w237 - w238) - w230 * (w205 + w207) + w281 - (w285 + right_rod_e3_ddot * w286)
    w288 = right_swing_angle / 2.0
    w289 = ca.sin(w288)
    w290 = w289 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_0_0_0 - w289 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_1_0_0
    w291 = w214 * c8
    w292 = w219 * c58
    w293 = w219 * w291 - w214 * w292
    w294 = w226 * c7
    w295 = w214 * w294 - w226 * w291
    w296 = w226 * w292 - w219 * w294
    w297 = w211 * w243
    w298 = w212 * w240
    w299 = w212 * w234
    w300 = w265 * gravity_z + (w281 * (w297 - w298) + w269 * (w299 - w206 * w243) + w254 * (w206 * w240 - w211 * w234))
    w301 = w216 * c76
    w302 = w204 * c15
    w303 = w212 * c77
    w304 = right_rod_e1 * right_rod_e2 * c80 + w209 * w303
    w305 = right_rod_x_ddot * w286 + right_rod_y_ddot * w277 + right_rod_z_ddot * w265 + right_rod_e0_ddot * w304
    w306 = w209 * w302 + right_rod_e2 * right_rod_e0 * c79
    w307 = w225 * w301 + right_rod_e1 * right_rod_e0 * c78
    w308 = w305 + right_rod_e1_ddot * w306 + right_rod_e2_ddot * w307 + right_rod_e3_ddot * (w216 * w301 + w204 * w302 + w212 * w303)
    w309 = w216 * w293 + w204 * w295 + w212 * w296 + w300 - w308
    w310 = w289 * c33
    w311 = w212 * w243
    w312 = w209 * w240
    w313 = w263 * gravity_z + (w281 * (w311 - w204 * w240) + w269 * (w204 * w234 - w209 * w243) + w254 * (w312 - w299))
    w314 = w212 * c15
    w315 = w211 * c77
    w316 = w216 * w314 + right_rod_e1 * right_rod_e3 * c79
    w317 = right_rod_x_ddot * w284 + right_rod_y_ddot * w275 + right_rod_z_ddot * w263 + right_rod_e0_ddot * w316
    w318 = right_rod_e3 * right_rod_e0 * c80 + w206 * w315
    w319 = w317 + right_rod_e1_ddot * w318 + right_rod_e2_ddot * (w225 * (w225 * c76) + w212 * w314 + w211 * w315)
    w320 = w225 * w293 + w212 * w295 + w211 * w296 + w313 - (w319 + right_rod_e3_ddot * w307)
    w321 = ca.cos(w288)
    w322 = w321 * shaft_right_quaternion_1_0_0 * right_rod_hinge_quaternion_0_0_0 - w321 * shaft_right_quaternion_0_0_0 * right_rod_hinge_quaternion_1_0_0
    w323 = w216 * w234
    w324 = w260 * gravity_z + (w281 * (w225 * w243 - w216 * w240) + w269 * (w323 - w311) + w254 * (w298 - w225 * w234))
    w325 = w212 * c76
    w326 = w211 * w325 + right_rod_e3 * right_rod_e2 * c78
    w327 = right_rod_x_ddot * w283 + right_rod_y_ddot * w274 + right_rod_z_ddot * w260 + right_rod_e0_ddot * w326
    w328 = w327 + right_rod_e1_ddot * (w212 * w325 + w209 * (w209 * c15) + w206 * (w206 * c77)) + right_rod_e2_ddot * w318
    w329 = w212 * w293 + w209 * w295 + w206 * w296 + w324 - (w328 + right_rod_e3_ddot * w306)
    w330 = w321 * c32
    w331 = w258 * gravity_z + (w281 * (w216 * w243 - w312) + w269 * (w209 * w234 - w297) + w254 * (w211 * w240 - w323))
    w332 = right_rod_x_ddot * w282 + right_rod_y_ddot * w272 + right_rod_z_ddot * w258 + right_rod_e0_ddot * (w211 * (w211 * c76) + w216 * (w216 * c15) + w209 * (w209 * c77))
    w333 = w211 * w293 + w216 * w295 + w209 * w296 + w331 - (w332 + right_rod_e1_ddot * w326 + right_rod_e2_ddot * w316 + right_rod_e3_ddot * w304)
    w334 = w22 * height_travel
    w335 = w1 * w334
    w336 = w18 * height_travel
    w337 = c18 - w254 - w120 - slider_z_ddot * slider_mass
    w338 = w279 + (w1 * w267 - w280) * w287 + w290 * w309 - w310 * w320 + w322 * w329 + w330 * w333 - (w335 - w0 * w336) * w337
    w339 = w28 * height_travel
    w340 = w0 * w339
    w341 = w136 + w269 + slider_y_ddot * slider_mass
    w342 = w2 * w336
    w343 = w147 + w281 + slider_x_ddot * slider_mass
    w344 = w105 + (w103 + slider_e1_dot * w108) + w88 * slider_e3_dot
    w345 = w110 + (w109 + w80 * slider_e1_dot + slider_e2_dot * w106)
    w346 = w345 * c69
    w347 = w344 * c59
    w348 = w344 * w346 - w345 * w347
    w349 = w114 + w81 * slider_e2_dot + w102 * slider_e3_dot
    w350 = w349 * c55
    w351 = w345 * w350 - w346 * w349
    w352 = w347 * w349 - w344 * w350
    w353 = w108 * w236
    w354 = w106 * w242
    w355 = w102 * w231
    w356 = w90 * w108
    w357 = w97 * w106
    w358 = w83 * w102
    w359 = w281 * (w102 * w242 - w353) + w269 * (w108 * w231 - w354) + w254 * (w106 * w236 - w355) + (w147 * (w97 * w102 - w356) + w136 * (w83 * w108 - w357) + w120 * (w90 * w106 - w358))
    w360 = w104 * c70
    w361 = w106 * w360 + slider_e2 * slider_e3 * c73
    w362 = (w106 * (w106 * c70) + w102 * (w102 * c71) + w108 * (w108 * c72)) * slider_e0_ddot + w361 * slider_e1_ddot
    w363 = w104 * c71
    w364 = w106 * c72
    w365 = w102 * w363 + slider_e3 * slider_e1 * c74
    w366 = w102 * c70
    w367 = w88 * c71
    w368 = w104 * c72
    w369 = slider_e2 * slider_e1 * c75 + w108 * w368
    w370 = w106 * w348 + w102 * w351 + w108 * w352 - w359 - (w362 + w365 * slider_e2_ddot + w369 * slider_e3_ddot)
    w371 = w338 + (w340 - w2 * w334) * w341 + (w342 - w1 * w339) * w343 + w370
    w372 = w3 * w19
    w373 = w372 - w11 * w23
    w374 = w11 * w29 - w1 * w19
    w375 = w3 * w29
    w376 = w24 - w375
    w377 = shaft_x_ddot * w374 + shaft_y_ddot * w376 + shaft_z_ddot * w373 + shaft_e0_ddot * w36 + shaft_e1_ddot * (w3 * w35 + w2 * (w2 * c64) + w6 * (w6 * c65))
    w378 = shaft_e3 * shaft_e0 * c68 + w6 * w38
    w379 = w2 * w41 + shaft_e2 * shaft_e0 * c67
    w380 = w3 * w10 + w2 * w14 + w6 * w15 + w373 * gravity_z - (w377 + shaft_e2_ddot * w378 + shaft_e3_ddot * w379)
    w381 = w3 * w48
    w382 = w3 * w134
    w383 = w380 + w132 * (w381 - w11 * w51) + w145 * (w52 - w382) + w153 * (w11 * w134 - w1 * w48) + w175 * w177
    w384 = w3 * w201
    w385 = w3 * w267
    w386 = w383 - w156 * w187 + w196 * w197 - w189 * w200 + w266 * (w384 - w11 * w202) + w278 * (w203 - w385)
    w387 = w3 * w336
    w388 = w386 + w287 * (w11 * w267 - w1 * w201) - w309 * w310 - w290 * w320 + w329 * w330 - w322 * w333 - w337 * (w11 * w334 - w387)
    w389 = w3 * w339
    w390 = w104 * w242
    w391 = w104 * w236
    w392 = w97 * w104
    w393 = w90 * w104
    w394 = w281 * (w81 * w242 - w102 * w236) + w269 * (w355 - w390) + w254 * (w391 - w81 * w231) + (w147 * (w81 * w97 - w90 * w102) + w136 * (w358 - w392) + w120 * (w393 - w81 * w83))
    w395 = slider_e3 * slider_e0 * c75 + w80 * w364
    w396 = slider_e0_ddot * w361 + slider_e1_ddot * (w104 * w360 + w108 * (w108 * c71) + w80 * (w80 * c72)) + slider_e2_ddot * w395
    w397 = w108 * w367 + slider_e2 * slider_e0 * c74
    w398 = w104 * w348 + w108 * w351 + w80 * w352 - w394 - (w396 + slider_e3_ddot * w397)
    w399 = w388 + w341 * (w389 - w335) + w343 * (w1 * w336 - w11 * w339) + w398
    w400 = w3 * w23
    w401 = w30 - w400
    w402 = w375 - w4 * w19
    w403 = w4 * w23 - w2 * w29
    w404 = shaft_x_ddot * w402 + shaft_y_ddot * w403 + shaft_z_ddot * w401 + shaft_e0_ddot * w39 + shaft_e1_ddot * w378
    w405 = w11 * w40 + shaft_e1 * shaft_e0 * c66
    w406 = w10 * w11 + w3 * w14 + w0 * w15 + w401 * gravity_z - (w404 + shaft_e2_ddot * (w11 * (w11 * c63) + w3 * w37 + w0 * w38) + shaft_e3_ddot * w405)
    w407 = w3 * w51
    w408 = w406 + w132 * (w146 - w407) + w145 * (w4 * w51 - w2 * w134) + w153 * (w382 - w4 * w48) - w175 * w189
    w409 = w3 * w202
    w410 = w408 + w187 * w197 + w156 * w196 - w177 * w200 + w266 * (w280 - w409) + w278 * (w4 * w202 - w2 * w267)
    w411 = w3 * w334
    w412 = w410 + w287 * (w385 - w4 * w201) - w309 * w322 + w320 * w330 + w290 * w329 + w310 * w333 - w337 * (w411 - w342)
    w413 = w104 * w231
    w414 = w83 * w104
    w415 = w281 * (w390 - w88 * w236) + w269 * (w88 * w231 - w108 * w242) + w254 * (w353 - w413) + (w147 * (w392 - w88 * w90) + w136 * (w83 * w88 - w97 * w108) + w120 * (w356 - w414))
    w416 = slider_e0_ddot * w365 + slider_e1_ddot * w395 + slider_e2_ddot * (w81 * (w81 * c70) + w104 * w363 + w106 * w364)
    w417 = w81 * w366 + slider_e1 * slider_e0 * c73
    w418 = w81 * w348 + w104 * w351 + w106 * w352 - w415 - (w416 + slider_e3_ddot * w417)
    w419 = w412 + w341 * (w2 * w339 - w4 * w334) + w343 * (w4 * w336 - w389) + w418
    w420 = w6 * w19 - w0 * w23
    w421 = w32 - w372
    w422 = w400 - w6 * w29
    w423 = shaft_x_ddot * w421 + shaft_y_ddot * w422 + shaft_z_ddot * w420 + shaft_e0_ddot * w43 + shaft_e1_ddot * w379
    w424 = w1 * w10 + w4 * w14 + w3 * w15 + w420 * gravity_z - (w423 + shaft_e2_ddot * w405 + shaft_e3_ddot * (w1 * w40 + w4 * w41 + w3 * w42))
    w425 = w424 + w132 * (w6 * w48 - w0 * w51) + w145 * (w407 - w6 * w134) + w153 * (w135 - w381) + w175 * w197
    w426 = w425 + w187 * w189 - w177 * w196 - w156 * w200 + w266 * (w6 * w201 - w0 * w202) + w278 * (w409 - w6 * w267)
    w427 = w426 + w287 * (w268 - w384) + w309 * w330 + w320 * w322 + w310 * w329 - w290 * w333 - w337 * (w0 * w334 - w6 * w336)
    w428 = w281 * (w354 - w391) + w269 * (w413 - w80 * w242) + w254 * (w80 * w236 - w106 * w231) + (w147 * (w357 - w393) + w136 * (w414 - w80 * w97) + w120 * (w80 * w90 - w83 * w106))
    w429 = slider_e0_ddot * w369 + slider_e1_ddot * w397 + slider_e2_ddot * w417 + slider_e3_ddot * (w102 * w366 + w88 * w367 + w104 * w368)
    w430 = w102 * w348 + w88 * w351 + w104 * w352 - w428 - w429
    w431 = w427 + w341 * (w6 * w339 - w411) + w343 * (w387 - w340) + w430
    w432 = w5 * c61
    w433 = w12 * c61
    w434 = w5 * w432 + w12 * w433
    w435 = w7 * w433
    w436 = w45 - w46
    w437 = w7 * w432
    w438 = shaft_x_ddot * shaft_mass + w31 * shaft_e0_ddot + shaft_e1_ddot * w374 + shaft_e2_ddot * w402 + shaft_e3_ddot * w421
    w439 = w287 + (w153 + (w22 * w434 - (w50 * w435 + w436 * w437) - w438)) - w343
    w440 = 1.0 - (w26 + w49)
    w441 = shaft_y_ddot * shaft_mass + w33 * shaft_e0_ddot + shaft_e1_ddot * w376 + shaft_e2_ddot * w403 + shaft_e3_ddot * w422
    w442 = w278 + (w145 + (w18 * w434 - (w47 * w435 + w437 * w440) - w441)) - w341
    w443 = w16 + w17
    w444 = shaft_z_ddot * shaft_mass + w25 * shaft_e0_ddot + shaft_e1_ddot * w373 + shaft_e2_ddot * w401 + shaft_e3_ddot * w420
    w445 = w337 + (w266 + (w132 + (c86 + (w28 * w434 - (w133 * w435 + w437 * w443)) - w444)))
    w446 = shaft_e1 * 0.5
    w447 = shaft_e0 * 0.5
    w448 = shaft_e3 * 0.5
    w449 = shaft_e2 * 0.5
    w450 = w18 * w22
    w451 = w22 * w28
    w452 = w18 * w28
    w453 = slider_e1 * 0.5
    w454 = slider_e0 * 0.5
    w455 = slider_e3 * 0.5
    w456 = slider_e2 * 0.5
    w457 = right_rod_e3 * 0.5
    w458 = right_rod_e0 * 0.5
    w459 = right_rod_e1 * 0.5
    w460 = w440 * w458 - w436 * w457 + w443 * w459
    w461 = right_rod_e2 * 0.5
    w462 = w436 * w459 + w440 * w461 + w443 * w457
    w463 = w436 * w458 + w440 * w457 - w443 * w461
    w464 = w436 * w461 - w440 * w459 + w443 * w458
    w465 = w320 * (w457 + w436 * w460) - (w333 * (w436 * w462 - w459) + w329 * (w458 - w436 * w463)) - w309 * (w461 - w436 * w464)
    w466 = w309 * (w459 + w440 * w464) - (w333 * (w440 * w462 - w461) + w329 * (w457 - w440 * w463) + w320 * (w458 - w440 * w460))
    w467 = w329 * (w461 + w443 * w463) - w333 * (w443 * w462 - w457) - w320 * (w459 - w443 * w460) - w309 * (w458 - w443 * w464)
    w468 = left_rod_e1 * 0.5
    w469 = left_rod_e2 * 0.5
    w470 = left_rod_e3 * 0.5
    w471 = w436 * w468 + w440 * w469 + w443 * w470
    w472 = left_rod_e0 * 0.5
    w473 = w443 * w469 - (w436 * w472 + w440 * w470)
    w474 = w436 * w470 - w440 * w472 - w443 * w468
    w475 = w440 * w468 - w436 * w469 - w443 * w472
    w476 = (w468 - w436 * w471) * w200 - w196 * (w472 + w436 * w473) - w187 * (w436 * w474 - w470) - w175 * (w469 + w436 * w475)
    w477 = (w469 - w440 * w471) * w200 - w196 * (w470 + w440 * w473) - w187 * (w472 + w440 * w474) - w175 * (w440 * w475 - w468)
    w478 = (w470 - w443 * w471) * w200 - w196 * (w443 * w473 - w469) - w187 * (w468 + w443 * w474) - w175 * (w472 + w443 * w475)
    # outputs
    lam = ca.vertcat(
        w371,  # spin.e0
        w399,  # spin.e1
        w419,  # spin.e2
        w431,  # spin.e3
        w439,  # spin.x
        w442,  # spin.y
        w445,  # spin.z
        w370,  # height.e0
        w398,  # height.e1
        w418,  # height.e2
        w430,  # height.e3
        -w343,  # height.x
        -w341,  # height.y
        w337,  # height.z
        w333,  # right_swing.e0
        w329,  # right_swing.e1
        w320,  # right_swing.e2
        w309,  # right_swing.e3
        w287,  # right_swing.x
        w278,  # right_swing.y
        w266,  # right_swing.z
        w200,  # left_swing.e0
        w196,  # left_swing.e1
        w187,  # left_swing.e2
        w175,  # left_swing.e3
        w153,  # left_swing.x
        w145,  # left_swing.y
        w132,  # left_swing.z
    )
    joint_forces = ca.horzcat(
        ca.vertcat(  # spin
            -w439, -w442, -w445, w371 * w446 - w399 * w447 + w419 * w448 - w431 * w449,
            w371 * w449 - w399 * w448 - w419 * w447 + w431 * w446, 0.0,
        ),
        ca.vertcat(  # height
            w343 * (1.0 - w22**2) - w341 * w450 + w337 * w451, w341 * (1.0 - w18**2) - w343 * w450 + w337 * w452,
            (w28**2 - 1.0) * w337 - (w343 * w451 + w341 * w452),
            w370 * w453 - w398 * w454 + w418 * w455 - w430 * w456,
            w370 * w456 - w398 * w455 - w418 * w454 + w430 * w453,
            w370 * w455 + w398 * w456 - w418 * w453 - w430 * w454,
        ),
        ca.vertcat(-w287, -w278, -w266, w465, w466, w467),  # right_swing
        ca.vertcat(-w153, -w145, -w132, w476, w477, w478),  # left_swing
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 32) [mixed]: rates of all coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    923 operations.
    """
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 93)
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    shaft_x_dot = q_dot[0]
    shaft_y_dot = q_dot[1]
    shaft_z_dot = q_dot[2]
    shaft_e0_dot = q_dot[3]
    shaft_e1_dot = q_dot[4]
    shaft_e2_dot = q_dot[5]
    shaft_e3_dot = q_dot[6]
    slider_x_dot = q_dot[7]
    slider_y_dot = q_dot[8]
    slider_z_dot = q_dot[9]
    slider_e0_dot = q_dot[10]
    slider_e1_dot = q_dot[11]
    slider_e2_dot = q_dot[12]
    slider_e3_dot = q_dot[13]
    right_rod_x_dot = q_dot[14]
    right_rod_y_dot = q_dot[15]
    right_rod_z_dot = q_dot[16]
    right_rod_e0_dot = q_dot[17]
    right_rod_e1_dot = q_dot[18]
    right_rod_e2_dot = q_dot[19]
    right_rod_e3_dot = q_dot[20]
    left_rod_x_dot = q_dot[21]
    left_rod_y_dot = q_dot[22]
    left_rod_z_dot = q_dot[23]
    left_rod_e0_dot = q_dot[24]
    left_rod_e1_dot = q_dot[25]
    left_rod_e2_dot = q_dot[26]
    left_rod_e3_dot = q_dot[27]
    c4 = c[4]
    slider_mass = c[14]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    left_spring_damping = c[30]
    left_rod_mass = c[51]
    right_rod_mass = c[52]
    c53 = c[53]
    shaft_mass = c[60]
    c61 = c[61]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    c85 = c[85]
    c90 = c[90]
    # intermediate terms (229)
    w0 = 2 * -shaft_e2
    w1 = 2 * shaft_e1
    w2 = 2 * shaft_e2
    w3 = (1.0 - (shaft_e1 * w1 + shaft_e2 * w2)) * c61
    w4 = 2 * -shaft_e3
    w5 = (w2 * shaft_e3 - w1 * shaft_e0) * c61
    w6 = w4 * w5
    w7 = w0 * w3 - w6
    w8 = 2 * shaft_e3
    w9 = w3 * w8 - w0 * w5
    w10 = 2 * shaft_e0
    w11 = w3 * w10
    w12 = w11 - w1 * w5
    w13 = 2 * -shaft_e1
    w14 = w3 * w13
    w15 = w5 * w10
    w16 = w14 - w15
    w17 = shaft_x_dot * shaft_mass + w7 * shaft_e0_dot + w9 * shaft_e1_dot + w12 * shaft_e2_dot + w16 * shaft_e3_dot
    w18 = (w1 * shaft_e3 + w2 * shaft_e0) * c61
    w19 = w4 * w18 - w14
    w20 = w0 * w18
    w21 = w20 - w11
    w22 = w1 * w18 - w3 * w4
    w23 = w10 * w18
    w24 = w23 - w2 * w3
    w25 = shaft_y_dot * shaft_mass + shaft_e0_dot * w19 + shaft_e1_dot * w21 + shaft_e2_dot * w22 + shaft_e3_dot * w24
    w26 = w5 * w13 - w20
    w27 = w15 - w8 * w18
    w28 = w6 - w23
    w29 = w2 * w5 - w13 * w18
    w30 = shaft_z_dot * shaft_mass + shaft_e0_dot * w26 + shaft_e1_dot * w27 + shaft_e2_dot * w28 + shaft_e3_dot * w29
    w31 = shaft_x_dot * w7 + shaft_y_dot * w19 + shaft_z_dot * w26 + shaft_e0_dot * (w13 * (w13 * c63) + w0 * (w0 * c64) + w4 * (w4 * c65))
    w32 = w10 * c63
    w33 = w13 * w32 + shaft_e2 * shaft_e3 * c66
    w34 = w10 * c64
    w35 = w13 * c65
    w36 = w0 * w34 + shaft_e1 * shaft_e3 * c67
    w37 = w0 * c63
    w38 = w1 * c64
    w39 = w10 * c65
    w40 = shaft_e2 * shaft_e1 * c68 + w4 * w39
    w41 = shaft_x_dot * w17 + shaft_y_dot * w25 + shaft_z_dot * w30 + shaft_e0_dot * (w31 + shaft_e1_dot * w33 + shaft_e2_dot * w36 + shaft_e3_dot * w40)
    w42 = shaft_x_dot * w9 + shaft_y_dot * w21 + shaft_z_dot * w27 + shaft_e0_dot * w33 + shaft_e1_dot * (w10 * w32 + w4 * (w4 * c64) + w2 * (w2 * c65))
    w43 = shaft_e3 * shaft_e0 * c68 + w2 * w35
    w44 = w4 * w38 + shaft_e2 * shaft_e0 * c67
    w45 = shaft_x_dot * w12 + shaft_y_dot * w22 + shaft_z_dot * w28 + shaft_e0_dot * w36 + shaft_e1_dot * w43
    w46 = w8 * w37 + shaft_e1 * shaft_e0 * c66
    w47 = shaft_e2_dot * (w45 + shaft_e2_dot * (w8 * (w8 * c63) + w10 * w34 + w13 * w35) + shaft_e3_dot * w46)
    w48 = shaft_x_dot * w16 + shaft_y_dot * w24 + shaft_z_dot * w29 + shaft_e0_dot * w40 + shaft_e1_dot * w44
    w49 = w41 + shaft_e1_dot * (w42 + shaft_e2_dot * w43 + shaft_e3_dot * w44) + w47 + shaft_e3_dot * (w48 + shaft_e2_dot * w46 + shaft_e3_dot * (w0 * w37 + w1 * w38 + w10 * w39))
    w50 = w49 + slider_x_dot * (slider_x_dot * slider_mass) + slider_y_dot * (slider_y_dot * slider_mass) + slider_z_dot * (slider_z_dot * slider_mass)
    w51 = 2 * -slider_e1
    w52 = 2 * -slider_e2
    w53 = 2 * -slider_e3
    w54 = 2 * slider_e0
    w55 = w54 * c70
    w56 = 2 * slider_e2
    w57 = w51 * w55 + slider_e2 * slider_e3 * c73
    w58 = slider_e0_dot * (w51 * (w51 * c70) + w52 * (w52 * c71) + w53 * (w53 * c72)) + w57 * slider_e1_dot
    w59 = 2 * slider_e3
    w60 = w54 * c71
    w61 = w51 * c72
    w62 = w52 * w60 + slider_e1 * slider_e3 * c74
    w63 = w52 * c70
    w64 = 2 * slider_e1
    w65 = w64 * c71
    w66 = w54 * c72
    w67 = slider_e1 * slider_e2 * c75 + w53 * w66
    w68 = slider_e3 * slider_e0 * c75 + w56 * w61
    w69 = slider_e0_dot * w57 + slider_e1_dot * (w54 * w55 + w53 * (w53 * c71) + w56 * (w56 * c72)) + slider_e2_dot * w68
    w70 = w53 * w65 + slider_e2 * slider_e0 * c74
    w71 = w50 + slider_e0_dot * (w58 + w62 * slider_e2_dot + w67 * slider_e3_dot) + slider_e1_dot * (w69 + slider_e3_dot * w70)
    w72 = slider_e0_dot * w62 + slider_e1_dot * w68 + slider_e2_dot * (w59 * (w59 * c70) + w54 * w60 + w51 * w61)
    w73 = w59 * w63 + slider_e1 * slider_e0 * c73
    w74 = slider_e0_dot * w67 + slider_e1_dot * w70 + slider_e2_dot * w73 + slider_e3_dot * (w52 * w63 + w64 * w65 + w54 * w66)
    w75 = 2 * -right_rod_e2
    w76 = 2 * right_rod_e1
    w77 = 2 * right_rod_e2
    w78 = w76 * right_rod_e3 - w77 * right_rod_e0
    w79 = w78 * c53
    w80 = 2 * -right_rod_e3
    w81 = 2 * right_rod_e3
    w82 = right_rod_e2 * w76 + right_rod_e0 * w81
    w83 = w82 * c53
    w84 = w80 * w83
    w85 = w75 * w79 - w84
    w86 = w79 * w81 - w75 * w83
    w87 = 2 * right_rod_e0
    w88 = w79 * w87
    w89 = w88 - w76 * w83
    w90 = right_rod_x_dot * right_rod_mass + w85 * right_rod_e0_dot + w86 * right_rod_e1_dot + w89 * right_rod_e2_dot
    w91 = 2 * -right_rod_e1
    w92 = w79 * w91
    w93 = w83 * w87
    w94 = w92 - w93
    w95 = w71 + slider_e2_dot * (w72 + slider_e3_dot * w73) + slider_e3_dot * w74 + right_rod_x_dot * (w90 + w94 * right_rod_e3_dot)
    w96 = 1.0 - (right_rod_e2 * w77 + right_rod_e3 * w81)
    w97 = w96 * c53
    w98 = w80 * w97 - w92
    w99 = w75 * w97
    w100 = w99 - w88
    w101 = w76 * w97 - w79 * w80
    w102 = right_rod_y_dot * right_rod_mass + right_rod_e0_dot * w98 + right_rod_e1_dot * w100 + right_rod_e2_dot * w101
    w103 = w87 * w97
    w104 = w103 - w77 * w79
    w105 = w83 * w91 - w99
    w106 = w93 - w81 * w97
    w107 = w84 - w103
    w108 = right_rod_z_dot * right_rod_mass + right_rod_e0_dot * w105 + right_rod_e1_dot * w106 + right_rod_e2_dot * w107
    w109 = w77 * w83 - w91 * w97
    w110 = w95 + right_rod_y_dot * (w102 + right_rod_e3_dot * w104) + right_rod_z_dot * (w108 + right_rod_e3_dot * w109)
    w111 = right_rod_x_dot * w85 + right_rod_y_dot * w98 + right_rod_z_dot * w105 + right_rod_e0_dot * (w91 * (w91 * c76) + w75 * (w75 * c15) + w80 * (w80 * c77))
    w112 = w87 * c76
    w113 = w91 * w112 + right_rod_e2 * right_rod_e3 * c78
    w114 = w87 * c15
    w115 = w91 * c77
    w116 = w75 * w114 + right_rod_e1 * right_rod_e3 * c79
    w117 = w75 * c76
    w118 = w76 * c15
    w119 = w87 * c77
    w120 = right_rod_e2 * right_rod_e1 * c80 + w80 * w119
    w121 = right_rod_e0_dot * (w111 + right_rod_e1_dot * w113 + right_rod_e2_dot * w116 + right_rod_e3_dot * w120)
    w122 = right_rod_x_dot * w86 + right_rod_y_dot * w100 + right_rod_z_dot * w106 + right_rod_e0_dot * w113
    w123 = right_rod_e3 * right_rod_e0 * c80 + w77 * w115
    w124 = w122 + right_rod_e1_dot * (w87 * w112 + w80 * (w80 * c15) + w77 * (w77 * c77)) + right_rod_e2_dot * w123
    w125 = w80 * w118 + right_rod_e2 * right_rod_e0 * c79
    w126 = right_rod_x_dot * w89 + right_rod_y_dot * w101 + right_rod_z_dot * w107 + right_rod_e0_dot * w116
    w127 = w126 + right_rod_e1_dot * w123 + right_rod_e2_dot * (w81 * (w81 * c76) + w87 * w114 + w91 * w115)
    w128 = w81 * w117 + right_rod_e1 * right_rod_e0 * c78
    w129 = w110 + w121 + right_rod_e1_dot * (w124 + right_rod_e3_dot * w125) + right_rod_e2_dot * (w127 + right_rod_e3_dot * w128)
    w130 = right_rod_x_dot * w94 + right_rod_y_dot * w104 + right_rod_z_dot * w109 + right_rod_e0_dot * w120
    w131 = w130 + right_rod_e1_dot * w125 + right_rod_e2_dot * w128 + right_rod_e3_dot * (w75 * w117 + w76 * w118 + w87 * w119)
    w132 = 2 * -left_rod_e2
    w133 = 2 * left_rod_e1
    w134 = 2 * left_rod_e2
    w135 = w133 * left_rod_e3 - w134 * left_rod_e0
    w136 = w135 * c4
    w137 = 2 * -left_rod_e3
    w138 = 2 * left_rod_e3
    w139 = left_rod_e2 * w133 + left_rod_e0 * w138
    w140 = w139 * c4
    w141 = w137 * w140
    w142 = w132 * w136 - w141
    w143 = w136 * w138 - w132 * w140
    w144 = 2 * left_rod_e0
    w145 = w136 * w144
    w146 = w145 - w133 * w140
    w147 = left_rod_x_dot * left_rod_mass + w142 * left_rod_e0_dot + w143 * left_rod_e1_dot + w146 * left_rod_e2_dot
    w148 = 2 * -left_rod_e1
    w149 = w136 * w148
    w150 = w140 * w144
    w151 = w149 - w150
    w152 = 1.0 - (left_rod_e2 * w134 + left_rod_e3 * w138)
    w153 = w152 * c4
    w154 = w137 * w153 - w149
    w155 = w132 * w153
    w156 = w155 - w145
    w157 = w133 * w153 - w136 * w137
    w158 = left_rod_y_dot * left_rod_mass + left_rod_e0_dot * w154 + left_rod_e1_dot * w156 + left_rod_e2_dot * w157
    w159 = w144 * w153
    w160 = w159 - w134 * w136
    w161 = w129 + right_rod_e3_dot * w131 + left_rod_x_dot * (w147 + w151 * left_rod_e3_dot) + left_rod_y_dot * (w158 + left_rod_e3_dot * w160)
    w162 = w140 * w148 - w155
    w163 = w150 - w138 * w153
    w164 = w141 - w159
    w165 = left_rod_z_dot * left_rod_mass + left_rod_e0_dot * w162 + left_rod_e1_dot * w163 + left_rod_e2_dot * w164
    w166 = w134 * w140 - w148 * w153
    w167 = left_rod_x_dot * w142 + left_rod_y_dot * w154 + left_rod_z_dot * w162 + left_rod_e0_dot * (w148 * (w148 * c81) + w132 * (w132 * c16) + w137 * (w137 * c82))
    w168 = w144 * c81
    w169 = w148 * w168 + left_rod_e2 * left_rod_e3 * c83
    w170 = w144 * c16
    w171 = w148 * c82
    w172 = w132 * w170 + left_rod_e1 * left_rod_e3 * c84
    w173 = w132 * c81
    w174 = w133 * c16
    w175 = w144 * c82
    w176 = left_rod_e2 * left_rod_e1 * c85 + w137 * w175
    w177 = left_rod_e0_dot * (w167 + left_rod_e1_dot * w169 + left_rod_e2_dot * w172 + left_rod_e3_dot * w176)
    w178 = left_rod_x_dot * w143 + left_rod_y_dot * w156 + left_rod_z_dot * w163 + left_rod_e0_dot * w169 + left_rod_e1_dot * (w144 * w168 + w137 * (w137 * c16) + w134 * (w134 * c82))
    w179 = left_rod_e3 * left_rod_e0 * c85 + w134 * w171
    w180 = w137 * w174 + left_rod_e2 * left_rod_e0 * c84
    w181 = w161 + left_rod_z_dot * (w165 + left_rod_e3_dot * w166) + w177 + left_rod_e1_dot * (w178 + left_rod_e2_dot * w179 + left_rod_e3_dot * w180)
    w182 = left_rod_x_dot * w146 + left_rod_y_dot * w157 + left_rod_z_dot * w164 + left_rod_e0_dot * w172 + left_rod_e1_dot * w179
    w183 = w138 * w173 + left_rod_e1 * left_rod_e0 * c83
    w184 = w182 + left_rod_e2_dot * (w138 * (w138 * c81) + w144 * w170 + w148 * w171) + left_rod_e3_dot * w183
    w185 = left_rod_x_dot * w151 + left_rod_y_dot * w160 + left_rod_z_dot * w166 + left_rod_e0_dot * w176 + left_rod_e1_dot * w180
    w186 = left_rod_e3_dot * (w185 + left_rod_e2_dot * w183 + left_rod_e3_dot * (w132 * w173 + w133 * w174 + w144 * w175))
    w187 = 1.0 - (slider_e2 * w56 + slider_e3 * w59)
    w188 = w187 * slider_right_x
    w189 = w96 * right_rod_middle_x
    w190 = slider_x + w188 - (right_rod_x + w189)
    w191 = slider_e2 * w64 + slider_e0 * w59
    w192 = w191 * slider_right_x
    w193 = w82 * right_rod_middle_x
    w194 = slider_y + w192 - (right_rod_y + w193)
    w195 = slider_e3 * w64 - slider_e0 * w56
    w196 = w195 * slider_right_x
    w197 = w78 * right_rod_middle_x
    w198 = slider_z + w196 - (right_rod_z + w197)
    w199 = w190**2 + w194**2 + w198**2
    w200 = w187 * slider_left_x
    w201 = w152 * left_rod_middle_x
    w202 = slider_x + w200 - (left_rod_x + w201)
    w203 = w191 * slider_left_x
    w204 = w139 * left_rod_middle_x
    w205 = slider_y + w203 - (left_rod_y + w204)
    w206 = w195 * slider_left_x
    w207 = w135 * left_rod_middle_x
    w208 = slider_z + w206 - (left_rod_z + w207)
    w209 = w202**2 + w205**2 + w208**2
    w210 = (ca.sqrt(w199) - right_spring_free_length)**2 * right_spring_stiffness / 2.0 + (ca.sqrt(w209) - left_spring_free_length)**2 * left_spring_stiffness / 2.0
    w211 = w3 + shaft_z * shaft_mass + (w79 + right_rod_z * right_rod_mass) + (w136 + left_rod_z * left_rod_mass)
    w212 = slider_e0_dot * w52 + slider_e1_dot * w59 + w54 * slider_e2_dot + w51 * slider_e3_dot
    w213 = slider_e0_dot * w53 + w52 * slider_e1_dot + slider_e2_dot * w64 + w54 * slider_e3_dot
    w214 = w75 * right_rod_e0_dot + w81 * right_rod_e1_dot + w87 * right_rod_e2_dot + w91 * right_rod_e3_dot
    w215 = w80 * right_rod_e0_dot + w75 * right_rod_e1_dot + w76 * right_rod_e2_dot + w87 * right_rod_e3_dot
    w216 = w190 * (slider_x_dot + (w196 * w212 - w192 * w213) - (right_rod_x_dot + (w197 * w214 - w193 * w215)))
    w217 = slider_e0_dot * w51 + w54 * slider_e1_dot + w53 * slider_e2_dot + w56 * slider_e3_dot
    w218 = right_rod_e0_dot * w91 + right_rod_e1_dot * w87 + w80 * right_rod_e2_dot + w77 * right_rod_e3_dot
    w219 = w194 * (slider_y_dot + (w188 * w213 - w196 * w217) - (right_rod_y_dot + (w189 * w215 - w197 * w218)))
    w220 = w198 * (slider_z_dot + (w192 * w217 - w188 * w212) - (right_rod_z_dot + (w193 * w218 - w189 * w214)))
    w221 = w216 + w219 + w220
    w222 = w132 * left_rod_e0_dot + w138 * left_rod_e1_dot + w144 * left_rod_e2_dot + w148 * left_rod_e3_dot
    w223 = w137 * left_rod_e0_dot + w132 * left_rod_e1_dot + w133 * left_rod_e2_dot + w144 * left_rod_e3_dot
    w224 = w202 * (slider_x_dot + (w206 * w212 - w203 * w213) - (left_rod_x_dot + (w207 * w222 - w204 * w223)))
    w225 = left_rod_e0_dot * w148 + left_rod_e1_dot * w144 + w137 * left_rod_e2_dot + w134 * left_rod_e3_dot
    w226 = w205 * (slider_y_dot + (w200 * w213 - w206 * w217) - (left_rod_y_dot + (w201 * w223 - w207 * w225)))
    w227 = w208 * (slider_z_dot + (w203 * w217 - w200 * w212) - (left_rod_z_dot + (w204 * w225 - w201 * w222)))
    w228 = w224 + w226 + w227
    # outputs
    kinetic = ca.vertcat((w181 + left_rod_e2_dot * w184 + w186) / 2.0)
    elastic = ca.vertcat(w210)
    potential = ca.vertcat(slider_z * c90 - w211 * gravity_z)
    power_dissipated = ca.vertcat(
        w221 * (w221 / w199 * right_spring_damping) + w228 * (w228 / w209 * left_spring_damping),
    )
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 32) [mixed]: rates of all coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 6 x 2) [N, N m]: world force and moment of a load on its marker, or b
    62 operations.
    """
    q = ca.SX.sym("q", 32)
    q_dot = ca.SX.sym("q_dot", 32)
    c = ca.SX.sym("c", 93)
    height_travel = q[29]
    right_swing_angle = q[30]
    left_swing_angle = q[31]
    height_travel_dot = q_dot[29]
    right_swing_angle_dot = q_dot[30]
    left_swing_angle_dot = q_dot[31]
    shaft_left_x = c[3]
    shaft_right_x = c[10]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    # intermediate terms (14)
    w0 = ca.cos(right_swing_angle) * right_rod_middle_x
    w1 = slider_right_x - (shaft_right_x + w0)
    w2 = ca.sin(right_swing_angle) * right_rod_middle_x
    w3 = height_travel - (shaft_right_z - w2)
    w4 = w1**2 + w3**2
    w5 = (1.0 - right_spring_free_length / ca.sqrt(w4)) * right_spring_stiffness
    w6 = (w1 * (w2 * right_swing_angle_dot) + w3 * (height_travel_dot + w0 * right_swing_angle_dot)) / w4 * right_spring_damping
    w7 = ca.cos(left_swing_angle) * left_rod_middle_x
    w8 = slider_left_x - (shaft_left_x - w7)
    w9 = ca.sin(left_swing_angle) * left_rod_middle_x
    w10 = height_travel - (shaft_left_z - w9)
    w11 = w8**2 + w10**2
    w12 = (1.0 - left_spring_free_length / ca.sqrt(w11)) * left_spring_stiffness
    w13 = (w10 * (height_travel_dot + w7 * left_swing_angle_dot) - w8 * (w9 * left_swing_angle_dot)) / w11 * left_spring_damping
    # outputs
    load_actions = ca.SX(6, 2)
    load_actions[0, 0] = -(w1 * w5 + w1 * w6)
    load_actions[0, 1] = -(w8 * w12 + w8 * w13)
    load_actions[2, 0] = -(w3 * w5 + w3 * w6)
    load_actions[2, 1] = -(w10 * w12 + w10 * w13)
    inputs, outputs = [q, q_dot, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["q", "q_dot", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 32) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 4) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    96 operations.
    """
    q = ca.SX.sym("q", 32)
    shaft_x = q[0]
    shaft_y = q[1]
    shaft_z = q[2]
    shaft_e0 = q[3]
    shaft_e1 = q[4]
    shaft_e2 = q[5]
    shaft_e3 = q[6]
    slider_x = q[7]
    slider_y = q[8]
    slider_z = q[9]
    slider_e0 = q[10]
    slider_e1 = q[11]
    slider_e2 = q[12]
    slider_e3 = q[13]
    right_rod_x = q[14]
    right_rod_y = q[15]
    right_rod_z = q[16]
    right_rod_e0 = q[17]
    right_rod_e1 = q[18]
    right_rod_e2 = q[19]
    right_rod_e3 = q[20]
    left_rod_x = q[21]
    left_rod_y = q[22]
    left_rod_z = q[23]
    left_rod_e0 = q[24]
    left_rod_e1 = q[25]
    left_rod_e2 = q[26]
    left_rod_e3 = q[27]
    # intermediate terms (48)
    w0 = 2 * shaft_e2
    w1 = shaft_e2 * w0
    w2 = 2 * shaft_e3
    w3 = shaft_e3 * w2
    w4 = 2 * shaft_e1
    w5 = shaft_e2 * w4
    w6 = w2 * shaft_e0
    w7 = shaft_e3 * w4
    w8 = w0 * shaft_e0
    w9 = shaft_e1 * w4
    w10 = w0 * shaft_e3
    w11 = w4 * shaft_e0
    w12 = 2 * slider_e2
    w13 = slider_e2 * w12
    w14 = 2 * slider_e3
    w15 = slider_e3 * w14
    w16 = 2 * slider_e1
    w17 = slider_e2 * w16
    w18 = w14 * slider_e0
    w19 = slider_e3 * w16
    w20 = w12 * slider_e0
    w21 = slider_e1 * w16
    w22 = w12 * slider_e3
    w23 = w16 * slider_e0
    w24 = 2 * right_rod_e2
    w25 = right_rod_e2 * w24
    w26 = 2 * right_rod_e3
    w27 = right_rod_e3 * w26
    w28 = 2 * right_rod_e1
    w29 = right_rod_e2 * w28
    w30 = w26 * right_rod_e0
    w31 = right_rod_e3 * w28
    w32 = w24 * right_rod_e0
    w33 = right_rod_e1 * w28
    w34 = w24 * right_rod_e3
    w35 = w28 * right_rod_e0
    w36 = 2 * left_rod_e2
    w37 = left_rod_e2 * w36
    w38 = 2 * left_rod_e3
    w39 = left_rod_e3 * w38
    w40 = 2 * left_rod_e1
    w41 = left_rod_e2 * w40
    w42 = w38 * left_rod_e0
    w43 = left_rod_e3 * w40
    w44 = w36 * left_rod_e0
    w45 = left_rod_e1 * w40
    w46 = w36 * left_rod_e3
    w47 = w40 * left_rod_e0
    # outputs
    poses = ca.vertcat(
        ca.horzcat(shaft_x, slider_x, right_rod_x, left_rod_x),
        ca.horzcat(shaft_y, slider_y, right_rod_y, left_rod_y),
        ca.horzcat(shaft_z, slider_z, right_rod_z, left_rod_z),
        ca.horzcat(1.0 - (w1 + w3), 1.0 - (w13 + w15), 1.0 - (w25 + w27), 1.0 - (w37 + w39)),
        ca.horzcat(w5 + w6, w17 + w18, w29 + w30, w41 + w42),
        ca.horzcat(w7 - w8, w19 - w20, w31 - w32, w43 - w44),
        ca.horzcat(w5 - w6, w17 - w18, w29 - w30, w41 - w42),
        ca.horzcat(1.0 - (w3 + w9), 1.0 - (w15 + w21), 1.0 - (w27 + w33), 1.0 - (w39 + w45)),
        ca.horzcat(w10 + w11, w22 + w23, w34 + w35, w46 + w47),
        ca.horzcat(w7 + w8, w19 + w20, w31 + w32, w43 + w44),
        ca.horzcat(w10 - w11, w22 - w23, w34 - w35, w46 - w47),
        ca.horzcat(1.0 - (w1 + w9), 1.0 - (w13 + w21), 1.0 - (w25 + w33), 1.0 - (w37 + w45)),
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i, through q_d
    266 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 93)
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    c0 = c[0]
    c1 = c[1]
    shaft_left_x = c[3]
    c4 = c[4]
    c7 = c[7]
    c8 = c[8]
    shaft_right_x = c[10]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c53 = c[53]
    # intermediate terms (63)
    w0 = ca.sin(right_swing_angle)
    w1 = w0 * right_rod_middle_x
    w2 = height_travel - (shaft_right_z - w1)
    w3 = ca.cos(right_swing_angle)
    w4 = w3 * right_rod_middle_x
    w5 = slider_right_x - (shaft_right_x + w4)
    w6 = w5**2 + w2**2
    w7 = ca.sqrt(w6)
    w8 = right_spring_free_length / w7
    w9 = w8 / w7
    w10 = w9 * (w2 / w7) * right_spring_stiffness
    w11 = (1.0 - w8) * right_spring_stiffness
    w12 = w4 * right_swing_angle_dot
    w13 = height_travel_dot + w12
    w14 = w1 * right_swing_angle_dot
    w15 = (w5 * w14 + w2 * w13) / w6
    w16 = w15 / w6
    w17 = 2 * w2
    w18 = (w13 / w6 - w16 * w17) * right_spring_damping
    w19 = w15 * right_spring_damping
    w20 = w2 * w10 + w11 + (w2 * w18 + w19)
    w21 = ca.sin(left_swing_angle)
    w22 = w21 * left_rod_middle_x
    w23 = height_travel - (shaft_left_z - w22)
    w24 = ca.cos(left_swing_angle)
    w25 = w24 * left_rod_middle_x
    w26 = slider_left_x - (shaft_left_x - w25)
    w27 = w26**2 + w23**2
    w28 = ca.sqrt(w27)
    w29 = left_spring_free_length / w28
    w30 = w29 / w28
    w31 = w30 * (w23 / w28) * left_spring_stiffness
    w32 = (1.0 - w29) * left_spring_stiffness
    w33 = w25 * left_swing_angle_dot
    w34 = height_travel_dot + w33
    w35 = w22 * left_swing_angle_dot
    w36 = (w23 * w34 - w26 * w35) / w27
    w37 = w36 / w27
    w38 = 2 * w23
    w39 = (w34 / w27 - w37 * w38) * left_spring_damping
    w40 = w36 * left_spring_damping
    w41 = w23 * w31 + w32 + (w23 * w39 + w40)
    w42 = 2 * right_swing_angle_dot
    w43 = w0 * spin_angle_dot
    w44 = w3 * spin_angle_dot
    w45 = w0 * (w42 * c8 * w43 - 2 * (right_swing_angle_dot * w43) * c7) + w3 * (w42 * c7 * w44 - 2 * (right_swing_angle_dot * w44) * c8)
    w46 = w1 * (2 * w5) + w4 * w17
    w47 = w9 * (w46 / (2 * w7)) * right_spring_stiffness
    w48 = ((w1 * w14 + w5 * w12 + (w4 * w13 - w2 * w14)) / w6 - w16 * w46) * right_spring_damping
    w49 = w2 * w47 + w4 * w11 + (w2 * w48 + w4 * w19)
    w50 = spin_angle_dot**2
    w51 = (w0 * gravity_z - w3 * (w50 * shaft_right_x)) * c53 + w50 * c15 + (w44 * (2 * -w44 * c7) + w43 * (2 * -w43 * c8))
    w52 = w1 * (w5 * w47 + w1 * w11 + (w5 * w48 + w1 * w19)) + w4 * (w5 * w11 + w5 * w19) + (w4 * w49 - w1 * (w2 * w11 + w2 * w19))
    w53 = w24 * spin_angle_dot
    w54 = 2 * left_swing_angle_dot
    w55 = w21 * spin_angle_dot
    w56 = w21 * (w54 * c1 * w55 - 2 * (left_swing_angle_dot * w55) * c0) + w24 * (w53 * (w54 * c0) - 2 * (left_swing_angle_dot * w53) * c1)
    w57 = w25 * w38 - w22 * (2 * w26)
    w58 = w30 * (w57 / (2 * w28)) * left_spring_stiffness
    w59 = ((w25 * w34 - w23 * w35 - (w26 * w33 - w22 * w35)) / w27 - w37 * w57) * left_spring_damping
    w60 = w23 * w58 + w25 * w32 + (w23 * w59 + w25 * w40)
    w61 = w22 * (w26 * w58 - w22 * w32 + (w26 * w59 - w22 * w40)) + w25 * (w26 * w32 + w26 * w40) - (w25 * w60 - w22 * (w23 * w32 + w23 * w40))
    w62 = (w24 * (w50 * shaft_left_x) + w21 * gravity_z) * c4 + w50 * c16 + (w53 * (2 * -w53 * c0) + w55 * (2 * -w55 * c1))
    # outputs
    dQ_hat_dq_i = ca.SX(4, 4)
    # spin.angle
    dQ_hat_dq_i[0, 2] = w45 + w44 * (w42 * c53) * shaft_right_x
    dQ_hat_dq_i[0, 3] = w56 - w53 * (w54 * c4) * shaft_left_x
    # height.travel
    dQ_hat_dq_i[1, 1] = -(w20 + w41)
    dQ_hat_dq_i[1, 2] = -w49
    dQ_hat_dq_i[1, 3] = -w60
    # right_swing.angle
    dQ_hat_dq_i[2, 1] = -(w1 * (w5 * w10 + w5 * w18) + w4 * w20)
    dQ_hat_dq_i[2, 2] = w51 - w52
    # left_swing.angle
    dQ_hat_dq_i[3, 1] = w22 * (w26 * w31 + w26 * w39) - w25 * w41
    dQ_hat_dq_i[3, 3] = w61 + w62
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    121 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 93)
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    spin_angle_dot = q_i_dot[0]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    shaft_left_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    shaft_right_x = c[10]
    c11 = c[11]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c36 = c[36]
    c40 = c[40]
    c53 = c[53]
    c91 = c[91]
    c92 = c[92]
    # intermediate terms (28)
    w0 = ca.sin(left_swing_angle)
    w1 = 2 * left_swing_angle_dot
    w2 = ca.cos(left_swing_angle)
    w3 = ca.sin(right_swing_angle)
    w4 = ca.cos(right_swing_angle)
    w5 = 2 * right_swing_angle_dot
    w6 = w3 * spin_angle_dot
    w7 = w0 * spin_angle_dot
    w8 = w3 * right_rod_middle_x
    w9 = height_travel - (shaft_right_z - w8)
    w10 = w4 * right_rod_middle_x
    w11 = slider_right_x - (shaft_right_x + w10)
    w12 = w11**2 + w9**2
    w13 = w9 / w12 * right_spring_damping
    w14 = w9 * w13
    w15 = w0 * left_rod_middle_x
    w16 = height_travel - (shaft_left_z - w15)
    w17 = w2 * left_rod_middle_x
    w18 = slider_left_x - (shaft_left_x - w17)
    w19 = w18**2 + w16**2
    w20 = w16 / w19 * left_spring_damping
    w21 = w16 * w20
    w22 = (w8 * w11 + w9 * w10) / w12 * right_spring_damping
    w23 = w9 * w22
    w24 = (w16 * w17 - w15 * w18) / w19 * left_spring_damping
    w25 = w16 * w24
    w26 = w3 * (w4 * (w5 * c9)) + w3 * (w5 * c53) * shaft_right_x - (w0 * (w1 * c4) * shaft_left_x - w0 * (w2 * (w1 * c2)))
    w27 = spin_angle_dot * c40 * (w0 * c4) - (w2 * (2 * -w7 * c1) - w0 * (2 * -(w2 * spin_angle_dot) * c0))
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(  # spin.angle
            w26, 0.0, spin_angle_dot * (w3 * w4) * c91 + 2 * w6 * c11,
            spin_angle_dot * (w0 * w2) * c92 - 2 * w7 * c5,
        ),
        ca.horzcat(0.0, -(w14 + w21), -w23, -w25),  # height.travel
        ca.horzcat(  # right_swing.angle
            w3 * (2 * -(w4 * spin_angle_dot) * c7) - w4 * (2 * -w6 * c8) - spin_angle_dot * c36 * (w3 * c53),
            -(w8 * (w11 * w13) + w10 * w14), -(w8 * (w11 * w22) + w10 * w23), 0.0,
        ),
        ca.horzcat(w27, w15 * (w18 * w20) - w17 * w21, 0.0, w15 * (w18 * w24) - w17 * w25),  # left_swing.angle
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 4 x 4) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    371 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 93)
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    spin_angle_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    shaft_left_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    shaft_right_x = c[10]
    c11 = c[11]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c36 = c[36]
    c40 = c[40]
    c53 = c[53]
    c91 = c[91]
    c92 = c[92]
    # intermediate terms (89)
    w0 = ca.sin(right_swing_angle)
    w1 = w0 * right_rod_middle_x
    w2 = height_travel - (shaft_right_z - w1)
    w3 = ca.cos(right_swing_angle)
    w4 = w3 * right_rod_middle_x
    w5 = slider_right_x - (shaft_right_x + w4)
    w6 = w5**2 + w2**2
    w7 = ca.sqrt(w6)
    w8 = right_spring_free_length / w7
    w9 = w8 / w7
    w10 = w9 * (w2 / w7) * right_spring_stiffness
    w11 = (1.0 - w8) * right_spring_stiffness
    w12 = w4 * right_swing_angle_dot
    w13 = height_travel_dot + w12
    w14 = w1 * right_swing_angle_dot
    w15 = (w5 * w14 + w2 * w13) / w6
    w16 = w15 / w6
    w17 = 2 * w2
    w18 = (w13 / w6 - w16 * w17) * right_spring_damping
    w19 = w15 * right_spring_damping
    w20 = w2 * w10 + w11 + (w2 * w18 + w19)
    w21 = ca.sin(left_swing_angle)
    w22 = w21 * left_rod_middle_x
    w23 = height_travel - (shaft_left_z - w22)
    w24 = ca.cos(left_swing_angle)
    w25 = w24 * left_rod_middle_x
    w26 = slider_left_x - (shaft_left_x - w25)
    w27 = w26**2 + w23**2
    w28 = ca.sqrt(w27)
    w29 = left_spring_free_length / w28
    w30 = w29 / w28
    w31 = w30 * (w23 / w28) * left_spring_stiffness
    w32 = (1.0 - w29) * left_spring_stiffness
    w33 = w25 * left_swing_angle_dot
    w34 = height_travel_dot + w33
    w35 = w22 * left_swing_angle_dot
    w36 = (w23 * w34 - w26 * w35) / w27
    w37 = w36 / w27
    w38 = 2 * w23
    w39 = (w34 / w27 - w37 * w38) * left_spring_damping
    w40 = w36 * left_spring_damping
    w41 = w23 * w31 + w32 + (w23 * w39 + w40)
    w42 = w0 * spin_angle_dot
    w43 = right_swing_angle_dot * w42
    w44 = w43 - w3 * spin_angle_ddot
    w45 = 2 * right_swing_angle_dot
    w46 = w45 * c8
    w47 = w0 * spin_angle_ddot
    w48 = w45 * c7
    w49 = w3 * spin_angle_dot
    w50 = right_swing_angle_dot * w49
    w51 = w0 * ((w44 - w43) * c8 + w42 * w46 - ((w43 + w44) * c7 - spin_angle_ddot * c11)) + w3 * (w47 * c7 + w48 * w49 - (w50 + (w47 + w50)) * c8)
    w52 = w45 * c53
    w53 = w1 * (2 * w5) + w4 * w17
    w54 = w9 * (w53 / (2 * w7)) * right_spring_stiffness
    w55 = ((w1 * w14 + w5 * w12 + (w4 * w13 - w2 * w14)) / w6 - w16 * w53) * right_spring_damping
    w56 = w2 * w54 + w4 * w11 + (w2 * w55 + w4 * w19)
    w57 = spin_angle_dot**2
    w58 = 2 * -w49 * c7
    w59 = 2 * -w42 * c8
    w60 = w1 * (w5 * w54 + w1 * w11 + (w5 * w55 + w1 * w19)) + w4 * (w5 * w11 + w5 * w19) + (w4 * w56 - w1 * (w2 * w11 + w2 * w19))
    w61 = w21 * spin_angle_ddot
    w62 = w24 * spin_angle_dot
    w63 = 2 * left_swing_angle_dot
    w64 = w63 * c4
    w65 = w21 * spin_angle_dot
    w66 = left_swing_angle_dot * w65
    w67 = w66 - w24 * spin_angle_ddot
    w68 = w63 * c1
    w69 = w63 * c0
    w70 = left_swing_angle_dot * w62
    w71 = w21 * ((w67 - w66) * c1 + w65 * w68 - (spin_angle_ddot * c5 + (w66 + w67) * c0)) + w24 * (w61 * c0 + w62 * w69 - (w70 + (w61 + w70)) * c1)
    w72 = w25 * w38 - w22 * (2 * w26)
    w73 = w30 * (w72 / (2 * w28)) * left_spring_stiffness
    w74 = ((w25 * w34 - w23 * w35 - (w26 * w33 - w22 * w35)) / w27 - w37 * w72) * left_spring_damping
    w75 = w23 * w73 + w25 * w32 + (w23 * w74 + w25 * w40)
    w76 = w22 * (w26 * w73 - w22 * w32 + (w26 * w74 - w22 * w40)) + w25 * (w26 * w32 + w26 * w40) - (w25 * w75 - w22 * (w23 * w32 + w23 * w40))
    w77 = 2 * -w62 * c0
    w78 = 2 * -w65 * c1
    w79 = w76 + ((w24 * (w57 * shaft_left_x) + w21 * gravity_z) * c4 + w57 * c16 + (w62 * w77 + w65 * w78))
    w80 = w2 / w6 * right_spring_damping
    w81 = w2 * w80
    w82 = w23 / w27 * left_spring_damping
    w83 = w23 * w82
    w84 = (w1 * w5 + w2 * w4) / w6 * right_spring_damping
    w85 = w2 * w84
    w86 = (w23 * w25 - w22 * w26) / w27 * left_spring_damping
    w87 = w23 * w86
    w88 = w0 * (w3 * (w48 - w46)) + w0 * w52 * shaft_right_x - (w21 * w64 * shaft_left_x - w21 * (w24 * (w69 - w68)))
    # outputs
    J_q = ca.SX(4, 4)
    # spin.angle
    J_q[0, 2] = w51 + (w47 * c53 + w49 * w52) * shaft_right_x
    J_q[0, 3] = w71 - (w61 * c4 + w62 * w64) * shaft_left_x
    # height.travel
    J_q[1, 1] = -(w20 + w41)
    J_q[1, 2] = -w56
    J_q[1, 3] = -w75
    # right_swing.angle
    J_q[2, 1] = -(w1 * (w5 * w10 + w5 * w18) + w4 * w20)
    J_q[2, 2] = (w0 * gravity_z - w3 * (w57 * shaft_right_x)) * c53 + w57 * c15 + (w49 * w58 + w42 * w59) - w60
    # left_swing.angle
    J_q[3, 1] = w22 * (w26 * w31 + w26 * w39) - w25 * w41
    J_q[3, 3] = w79
    J_v = ca.vertcat(
        ca.horzcat(  # spin.angle
            w88, 0.0, spin_angle_dot * (w0 * w3) * c91 + 2 * w42 * c11,
            spin_angle_dot * (w21 * w24) * c92 - 2 * w65 * c5,
        ),
        ca.horzcat(0.0, -(w81 + w83), -w85, -w87),  # height.travel
        ca.horzcat(  # right_swing.angle
            w0 * w58 - w3 * w59 - spin_angle_dot * c36 * (w0 * c53), -(w1 * (w5 * w80) + w4 * w81),
            -(w1 * (w5 * w84) + w4 * w85), 0.0,
        ),
        ca.horzcat(  # left_swing.angle
            spin_angle_dot * c40 * (w21 * c4) - (w24 * w78 - w21 * w77), w22 * (w26 * w82) - w25 * w83, 0.0,
            w22 * (w26 * w86) - w25 * w87,
        ),
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 93) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    130 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 93)
    height_travel = q_i[1]
    right_swing_angle = q_i[2]
    left_swing_angle = q_i[3]
    spin_angle_dot = q_i_dot[0]
    height_travel_dot = q_i_dot[1]
    right_swing_angle_dot = q_i_dot[2]
    left_swing_angle_dot = q_i_dot[3]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    shaft_left_x = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    shaft_right_x = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    slider_mass = c[14]
    c15 = c[15]
    c16 = c[16]
    gravity_z = c[17]
    c18 = c[18]
    right_spring_stiffness = c[19]
    right_spring_free_length = c[20]
    slider_right_x = c[21]
    right_rod_middle_x = c[22]
    shaft_right_z = c[23]
    right_spring_damping = c[24]
    left_spring_stiffness = c[25]
    left_spring_free_length = c[26]
    slider_left_x = c[27]
    left_rod_middle_x = c[28]
    shaft_left_z = c[29]
    left_spring_damping = c[30]
    c53 = c[53]
    # intermediate terms (32)
    w0 = ca.sin(left_swing_angle)
    w1 = ca.cos(left_swing_angle)
    w2 = w1 * spin_angle_dot
    w3 = w0 * spin_angle_dot
    w4 = 2 * (left_swing_angle_dot * w3)
    w5 = ca.cos(right_swing_angle)
    w6 = ca.sin(right_swing_angle)
    w7 = spin_angle_dot * w6
    w8 = 2 * (w7 * right_swing_angle_dot)
    w9 = spin_angle_dot * w5
    w10 = w0 * (2 * (w2 * left_swing_angle_dot) * c1) - w1 * (w4 * c0) + w4 * c5 - (w5 * (w8 * c7) - w6 * (2 * (right_swing_angle_dot * w9) * c8) + w8 * c11)
    w11 = w5 * right_rod_middle_x
    w12 = slider_right_x - (shaft_right_x + w11)
    w13 = w6 * right_rod_middle_x
    w14 = height_travel - (shaft_right_z - w13)
    w15 = w12**2 + w14**2
    w16 = (1.0 - right_spring_free_length / ca.sqrt(w15)) * right_spring_stiffness
    w17 = (w12 * (right_swing_angle_dot * w13) + w14 * (height_travel_dot + right_swing_angle_dot * w11)) / w15
    w18 = w17 * right_spring_damping
    w19 = w14 * w16 + w14 * w18
    w20 = w1 * left_rod_middle_x
    w21 = slider_left_x - (shaft_left_x - w20)
    w22 = w0 * left_rod_middle_x
    w23 = height_travel - (shaft_left_z - w22)
    w24 = w21**2 + w23**2
    w25 = (1.0 - left_spring_free_length / ca.sqrt(w24)) * left_spring_stiffness
    w26 = (w23 * (height_travel_dot + left_swing_angle_dot * w20) - w21 * (left_swing_angle_dot * w22)) / w24
    w27 = w26 * left_spring_damping
    w28 = w23 * w25 + w23 * w27
    w29 = spin_angle_dot**2
    w30 = (w6 * (w29 * shaft_right_x) + w5 * gravity_z) * c53 + w7 * w9 * c9 + (w13 * (w12 * w16 + w12 * w18) + w11 * w19)
    w31 = w22 * (w21 * w25 + w21 * w27) - w20 * w28 - ((w1 * gravity_z - w0 * (w29 * shaft_left_x)) * c4 + w2 * w3 * c2)
    # outputs
    q_i_ddot = ca.vertcat(
        -(w10 / (w5 * c12 + (c7 - w6 * (w6 * c9) + (c13 + (c0 - w0 * (w0 * c2) - w1 * c6))))),  # spin.angle
        (c18 - (w19 + w28)) / slider_mass,  # height.travel
        -(w30 / c15),  # right_swing.angle
        w31 / c16,  # left_swing.angle
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 44) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 44)
    shaft_right_x = p[22]
    shaft_right_z = p[23]
    shaft_left_x = p[28]
    shaft_left_z = p[29]
    right_rod_middle_x = p[32]
    slider_right_x = p[33]
    left_rod_middle_x = p[37]
    slider_left_x = p[38]
    right_rod_ball_x = p[42]
    left_rod_ball_x = p[43]
    # outputs
    positions = ca.SX(3, 13)
    positions[0, 1] = shaft_right_x
    positions[0, 2] = shaft_left_x
    positions[0, 4] = slider_right_x
    positions[0, 5] = slider_left_x
    positions[0, 8] = right_rod_middle_x
    positions[0, 9] = right_rod_ball_x
    positions[0, 11] = left_rod_middle_x
    positions[0, 12] = left_rod_ball_x
    positions[2, 1] = shaft_right_z
    positions[2, 2] = shaft_left_z
    axes = ca.SX(9, 13)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = -1.0
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
    axes[4, 0] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[4, 8] = 1.0
    axes[4, 9] = 1.0
    axes[4, 11] = 1.0
    axes[4, 12] = 1.0
    axes[5, 1] = -1.0
    axes[5, 2] = -1.0
    axes[5, 7] = -1.0
    axes[5, 10] = -1.0
    axes[7, 1] = 1.0
    axes[7, 2] = -1.0
    axes[7, 7] = 1.0
    axes[7, 10] = 1.0
    axes[8, 0] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
    axes[8, 8] = 1.0
    axes[8, 9] = 1.0
    axes[8, 11] = 1.0
    axes[8, 12] = 1.0
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
    "load_actions": load_actions,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
