"""Flexible slider-crank, running freely: equations of motion, emitted by symgen from the scene `flexible_slider_crank_free`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 90 operations."""
    p = ca.SX.sym("p", 36)
    crank_mass = p[0]
    crank_inertia = p[1]
    crank_center_of_mass_x = p[2]
    rod_mass = p[3]
    rod_first_moment_x = p[4]
    rod_inertia = p[5]
    rod_phi_integral_0_2 = p[6]
    rod_phi_integral_0_3 = p[7]
    rod_phi_integral_1_0 = p[8]
    rod_rho_dot_phi_2_0 = p[9]
    rod_rho_dot_phi_3_0 = p[10]
    rod_rho_cross_phi_0_0 = p[11]
    rod_rho_cross_phi_1_0 = p[12]
    rod_M_ff_0_0 = p[13]
    rod_M_ff_1_1 = p[14]
    rod_M_ff_2_2 = p[15]
    rod_M_ff_2_3 = p[16]
    rod_M_ff_3_2 = p[17]
    rod_M_ff_3_3 = p[18]
    rod_phi_cross_phi_0_2 = p[19]
    rod_phi_cross_phi_0_3 = p[20]
    rod_phi_cross_phi_1_3 = p[21]
    rod_phi_cross_phi_2_0 = p[22]
    rod_phi_cross_phi_3_0 = p[23]
    rod_phi_cross_phi_3_1 = p[24]
    rod_K_ff_0_0 = p[25]
    rod_K_ff_1_1 = p[26]
    rod_K_ff_2_2 = p[27]
    rod_K_ff_2_3 = p[28]
    rod_K_ff_3_2 = p[29]
    rod_K_ff_3_3 = p[30]
    slider_mass = p[31]
    slider_inertia = p[32]
    crank_tip_x = p[33]
    rod_end_x = p[34]
    rod_end_shape_0_3 = p[35]
    c = ca.vertcat(
        crank_tip_x,
        rod_mass,
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        rod_mass + slider_mass,
        rod_end_shape_0_3,
        rod_end_x,
        rod_phi_integral_0_2,
        rod_phi_integral_0_3,
        rod_first_moment_x,
        rod_phi_integral_1_0,
        slider_mass,
        rod_M_ff_0_0,
        rod_M_ff_1_1,
        rod_M_ff_2_2,
        rod_M_ff_2_3,
        rod_rho_dot_phi_2_0,
        rod_M_ff_3_2,
        rod_M_ff_3_3,
        rod_rho_dot_phi_3_0,
        rod_inertia,
        rod_phi_cross_phi_0_2,
        rod_phi_cross_phi_0_3,
        rod_rho_cross_phi_0_0,
        rod_phi_cross_phi_1_3,
        rod_rho_cross_phi_1_0,
        rod_phi_cross_phi_2_0,
        rod_phi_cross_phi_3_0,
        rod_phi_cross_phi_3_1,
        rod_K_ff_0_0,
        rod_K_ff_1_1,
        rod_K_ff_2_2,
        rod_K_ff_2_3,
        rod_K_ff_3_2,
        rod_K_ff_3_3,
        crank_mass * crank_center_of_mass_x,
        crank_mass,
        slider_inertia,
        2 * rod_phi_cross_phi_2_0,
        2 * rod_phi_cross_phi_3_0,
        2 * rod_phi_cross_phi_3_1,
        2 * rod_phi_cross_phi_0_2,
        2 * rod_phi_cross_phi_0_3,
        2 * rod_phi_cross_phi_1_3,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 325 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
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
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = ca.cos(rod_theta)
    w3 = c5 + c4 * rod_q4
    w4 = w2 * w3
    w5 = w0 / w4
    w6 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w7 = ca.sin(rod_theta)
    w8 = c9 * rod_q1
    w9 = w2 * w6 - w7 * w8
    w10 = w7 * w6 + w2 * w8
    w11 = w7 * w3
    w12 = w11 * c10
    w13 = w0 * w9 + w1 * (w10 + w12)
    w14 = c11 * rod_q1
    w15 = c12 * rod_q2
    w16 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w17 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w18 = c19 + (rod_q1 * w14 + rod_q2 * w15 + rod_q3 * (c15 + w16) + rod_q4 * (c18 + w17))
    w19 = w18 + w11 * w12
    w20 = w2 * c9
    w21 = w7 * c9
    w22 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w23 = w0 * w20 + w1 * w21 - w5 * w22
    w24 = c24 - c23 * rod_q4
    w25 = -(w5 * w24)
    w26 = w7 * c6
    w27 = w2 * c6
    w28 = c25 * rod_q1
    w29 = w0 * w26 - w1 * w27 + w5 * w28
    w30 = w7 * c7
    w31 = w2 * c7
    w32 = w2 * c4
    w33 = w32 * c10
    w34 = c26 * rod_q1 + c27 * rod_q2
    w35 = w34 + w11 * w33
    w36 = w7 * c4 / w4
    w37 = w35 + w36 * w19
    w38 = w0 * w30 - w1 * (w31 + w33) + (w5 * w37 - w36 * w13)
    w39 = -(w36 * w22)
    w40 = -(w36 * w24)
    w41 = c14 + w36 * w28
    w42 = rod_theta_dot**2
    w43 = c6 * rod_q3_dot + c7 * rod_q4_dot
    w44 = c9 * rod_q1_dot
    w45 = crank_theta_dot**2
    w46 = w1 * w45
    w47 = c4 * rod_q4_dot
    w48 = (2 * (w2 * w47) * rod_theta_dot - w11 * w42 - w46) / w4
    w49 = w0 * w45
    w50 = c10 * (w11 * w48 - (w4 * w42 + 2 * (w7 * w47) * rod_theta_dot + w49))
    w51 = (w10 * w42 - 2 * (w2 * w43 - w7 * w44) * rod_theta_dot + (c1 * w46 + w9 * w48)) * w0 - (w9 * w42 + 2 * (w7 * w43 + w2 * w44) * rod_theta_dot - (w10 * w48 - c1 * w49) - w50) * w1
    w52 = -2.0 * (w14 * rod_q1_dot + w15 * rod_q2_dot + w16 * rod_q3_dot + w17 * rod_q4_dot) * rod_theta_dot
    w53 = w52 - (w10 * w49 - w9 * w46 - w18 * w48) + w50 * w11
    w54 = w14 * w42 + 2 * (c20 * rod_q3_dot + c21 * rod_q4_dot) * rod_theta_dot - c28 * rod_q1 - (w21 * w49 - w20 * w46 - w22 * w48)
    w55 = w16 * w42 + 2 * (c25 * rod_q1_dot) * rod_theta_dot - (c30 * rod_q3 + c31 * rod_q4) - (w28 * w48 - (w27 * w49 + w26 * w46))
    w56 = w17 * w42 + 2 * (c26 * rod_q1_dot + c27 * rod_q2_dot) * rod_theta_dot - (c32 * rod_q3 + c33 * rod_q4)
    M_hat = ca.vertcat(
        c2 + w0 * (w0 * c1) + w1 * (w1 * c3) - (w5 * (w13 - w5 * w19) + w5 * w13),
        w23,
        w25,
        w29,
        w38,
        w23,
        c11,
        0.0,
        0.0,
        w39,
        w25,
        0.0,
        c12,
        0.0,
        w40,
        w29,
        0.0,
        0.0,
        c13,
        w41,
        w38,
        w39,
        w40,
        w41,
        c17 + w32 * w33 + (w36 * w37 + w36 * w35),
    )
    M_hat = ca.reshape(M_hat, 5, 5)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w51 - w53 * w5,
        w54,
        w15 * w42 + 2 * (c23 * rod_q4_dot) * rod_theta_dot - c29 * rod_q2 + w24 * w48,
        w55,
        w56 - (w34 * w48 - (w31 * w49 + w30 * w46)) - w50 * w32 - w53 * w36,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d in closed form (Eq. 31); C_loop before the step. 33 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = c5 + c4 * rod_q4
    w3 = w1 + ca.sin(rod_theta) * w2
    w4 = rod_theta - w3 / (ca.cos(rod_theta) * w2)
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w4,
        w0 + ca.cos(w4) * w2,
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w3,
    )
    C_loop = ca.densify(C_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 42 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    w0 = ca.sin(crank_theta) * c0 * crank_theta_dot
    w1 = ca.cos(crank_theta) * c0
    w2 = ca.cos(rod_theta)
    w3 = c5 + c4 * rod_q4
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w1 / w4 * crank_theta_dot + w5 * c4 / w4 * rod_q4_dot
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -w0,
        w1 * crank_theta_dot,
        -w6,
        w5 * w3 * w6 - w0 + w2 * c4 * rod_q4_dot,
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 66 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q4_ddot = q_i_ddot[4]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    w0 = ca.cos(crank_theta) * c0
    w1 = crank_theta_dot**2
    w2 = ca.sin(crank_theta) * c0
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w2 * w1
    w5 = ca.cos(rod_theta)
    w6 = c4 * rod_q4_dot
    w7 = ca.sin(rod_theta)
    w8 = c5 + c4 * rod_q4
    w9 = w7 * w8
    w10 = rod_theta_dot**2
    w11 = w5 * w8
    w12 = (2 * (w5 * w6) * rod_theta_dot - w9 * w10 - w4) / w11 + w0 / w11 * crank_theta_ddot + w7 * c4 / w11 * rod_q4_ddot
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -w3,
        w0 * crank_theta_ddot - w4,
        -w12,
        w9 * w12 - (w11 * w10 + 2 * (w7 * w6) * rod_theta_dot + w3) + w5 * c4 * rod_q4_ddot,
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t and gamma in all coordinates (Eqs. 21-27). 189 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 43)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q4 = q[9]
    slider_x = q[10]
    slider_y = q[11]
    slider_theta = q[12]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q4_dot = q_dot[9]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = ca.cos(rod_theta)
    w3 = c5 + c4 * rod_q4
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w5 * w3
    w7 = crank_theta_dot**2
    w8 = rod_theta_dot**2
    w9 = c4 * rod_q4_dot
    C = ca.vertcat(
        crank_x,
        crank_y,
        rod_x - (crank_x + w0),
        rod_y - (crank_y + w1),
        slider_y,
        slider_theta,
        slider_x - (rod_x + w4),
        slider_y - (rod_y + w6),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        -w0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w6,
        -w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(w2 * c4),
        -(w5 * c4),
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 13)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w7),
        -(w1 * w7),
        0.0,
        0.0,
        -(w4 * w8 + 2 * (w5 * w9) * rod_theta_dot),
        2 * (w2 * w9) * rod_theta_dot - w6 * w8,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "gamma"])


def augmented() -> ca.Function:
    """M and Q* of the augmented form (Eq. 28). 354 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 43)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    c1 = c[1]
    c2 = c[2]
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
    w0 = ca.sin(crank_theta) * c34
    w1 = -w0
    w2 = ca.cos(crank_theta) * c34
    w3 = ca.sin(rod_theta)
    w4 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w5 = ca.cos(rod_theta)
    w6 = c9 * rod_q1
    w7 = w3 * w4 + w5 * w6
    w8 = -w7
    w9 = -(w3 * c9)
    w10 = w5 * c6
    w11 = w5 * c7
    w12 = w5 * w4 - w3 * w6
    w13 = w5 * c9
    w14 = w3 * c6
    w15 = w3 * c7
    w16 = c11 * rod_q1
    w17 = c12 * rod_q2
    w18 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w19 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w20 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w21 = c24 - c23 * rod_q4
    w22 = -(c25 * rod_q1)
    w23 = -(c26 * rod_q1 + c27 * rod_q2)
    w24 = crank_theta_dot**2
    w25 = rod_theta_dot**2
    w26 = c6 * rod_q3_dot + c7 * rod_q4_dot
    w27 = c9 * rod_q1_dot
    w28 = -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot) * rod_theta_dot
    w29 = w19 * w25 + 2 * (c26 * rod_q1_dot + c27 * rod_q2_dot) * rod_theta_dot - (c32 * rod_q3 + c33 * rod_q4)
    M = ca.vertcat(
        c35,
        0.0,
        w1,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c35,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        w2,
        c2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        0.0,
        w8,
        w9,
        0.0,
        w10,
        w11,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        w12,
        w13,
        0.0,
        w14,
        w15,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w8,
        w12,
        c19 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c15 + w18) + rod_q4 * (c18 + w19)),
        w20,
        w21,
        w22,
        w23,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w9,
        w13,
        w20,
        c11,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w21,
        0.0,
        c12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w10,
        w14,
        w22,
        0.0,
        0.0,
        c13,
        c14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w11,
        w15,
        w23,
        0.0,
        0.0,
        c14,
        c17,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c10,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c10,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c36,
    )
    M = ca.reshape(M, 13, 13)
    M = ca.densify(M)
    Q_star = ca.vertcat(
        w2 * w24,
        w0 * w24,
        0.0,
        w12 * w25 + 2 * (w3 * w26 + w5 * w27) * rod_theta_dot,
        w7 * w25 - 2 * (w5 * w26 - w3 * w27) * rod_theta_dot,
        w28,
        w16 * w25 + 2 * (c20 * rod_q3_dot + c21 * rod_q4_dot) * rod_theta_dot - c28 * rod_q1,
        w17 * w25 + 2 * (c23 * rod_q4_dot) * rod_theta_dot - c29 * rod_q2,
        w18 * w25 + 2 * (c25 * rod_q1_dot) * rod_theta_dot - (c30 * rod_q3 + c31 * rod_q4),
        w29,
        0.0,
        0.0,
        0.0,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, c], [M, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "Q_star"])


def reactions() -> ca.Function:
    """Lagrange multipliers lam (Eq. 37). 206 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 43)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    rod_q1_ddot = q_ddot[6]
    rod_q2_ddot = q_ddot[7]
    rod_q3_ddot = q_ddot[8]
    rod_q4_ddot = q_ddot[9]
    slider_x_ddot = q_ddot[10]
    slider_y_ddot = q_ddot[11]
    slider_theta_ddot = q_ddot[12]
    c1 = c[1]
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
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    w0 = ca.cos(crank_theta) * c34
    w1 = crank_theta_dot**2
    w2 = ca.sin(crank_theta) * c34
    w3 = ca.cos(rod_theta)
    w4 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w5 = ca.sin(rod_theta)
    w6 = c9 * rod_q1
    w7 = w3 * w4 - w5 * w6
    w8 = rod_theta_dot**2
    w9 = c6 * rod_q3_dot + c7 * rod_q4_dot
    w10 = c9 * rod_q1_dot
    w11 = w5 * w4 + w3 * w6
    w12 = c1 * rod_x_ddot - w11 * rod_theta_ddot - w5 * c9 * rod_q1_ddot + w3 * c6 * rod_q3_ddot + w3 * c7 * rod_q4_ddot
    w13 = c10 * slider_x_ddot
    w14 = w7 * w8 + 2 * (w5 * w9 + w3 * w10) * rod_theta_dot - w12 - w13
    w15 = c1 * rod_y_ddot + w7 * rod_theta_ddot + w3 * c9 * rod_q1_ddot + w5 * c6 * rod_q3_ddot + w5 * c7 * rod_q4_ddot
    w16 = c11 * rod_q1
    w17 = c12 * rod_q2
    w18 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w19 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w20 = -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot) * rod_theta_dot
    w21 = (c19 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c15 + w18) + rod_q4 * (c18 + w19))) * rod_theta_ddot
    w22 = w7 * rod_y_ddot - w11 * rod_x_ddot + w21 + (c22 - (c20 * rod_q3 + c21 * rod_q4)) * rod_q1_ddot + (c24 - c23 * rod_q4) * rod_q2_ddot
    w23 = c5 + c4 * rod_q4
    w24 = w20 - (w22 - c25 * rod_q1 * rod_q3_ddot - (c26 * rod_q1 + c27 * rod_q2) * rod_q4_ddot) + w5 * w23 * w13
    w25 = w24 / (w3 * w23)
    w26 = w11 * w8 - 2 * (w3 * w9 - w5 * w10) * rod_theta_dot - w15 - w25
    lam = ca.vertcat(
        w0 * w1 - (c35 * crank_x_ddot - w2 * crank_theta_ddot) + w14,
        w2 * w1 - (c35 * crank_y_ddot + w0 * crank_theta_ddot) + w26,
        w14,
        w26,
        w25 - c10 * slider_y_ddot,
        -(c36 * slider_theta_ddot),
        -w13,
        -w25,
    )
    lam = ca.densify(lam)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 229 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 43)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    rod_q3 = q[8]
    rod_q4 = q[9]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    rod_q3_dot = q_dot[8]
    rod_q4_dot = q_dot[9]
    slider_x_dot = q_dot[10]
    slider_y_dot = q_dot[11]
    slider_theta_dot = q_dot[12]
    c1 = c[1]
    c2 = c[2]
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
    w0 = ca.sin(crank_theta) * c34
    w1 = ca.cos(crank_theta) * c34
    w2 = crank_x_dot * (c35 * crank_x_dot - w0 * crank_theta_dot) + crank_y_dot * (c35 * crank_y_dot + w1 * crank_theta_dot)
    w3 = ca.sin(rod_theta)
    w4 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w5 = ca.cos(rod_theta)
    w6 = c9 * rod_q1
    w7 = w3 * w4 + w5 * w6
    w8 = w3 * c9
    w9 = w5 * c6
    w10 = w5 * c7
    w11 = rod_x_dot * (c1 * rod_x_dot - w7 * rod_theta_dot - w8 * rod_q1_dot + w9 * rod_q3_dot + w10 * rod_q4_dot)
    w12 = w5 * w4 - w3 * w6
    w13 = w5 * c9
    w14 = w3 * c6
    w15 = w3 * c7
    w16 = rod_y_dot * (c1 * rod_y_dot + w12 * rod_theta_dot + w13 * rod_q1_dot + w14 * rod_q3_dot + w15 * rod_q4_dot)
    w17 = rod_q1 * (c11 * rod_q1) + rod_q2 * (c12 * rod_q2) + rod_q3 * (c15 + (c15 + (c13 * rod_q3 + c14 * rod_q4)))
    w18 = w12 * rod_y_dot - w7 * rod_x_dot + (c19 + (w17 + rod_q4 * (c18 + (c18 + (c16 * rod_q3 + c17 * rod_q4))))) * rod_theta_dot
    w19 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w20 = c24 - c23 * rod_q4
    w21 = c25 * rod_q1
    w22 = c26 * rod_q1 + c27 * rod_q2
    w23 = rod_theta_dot * (w18 + w19 * rod_q1_dot + w20 * rod_q2_dot - w21 * rod_q3_dot - w22 * rod_q4_dot)
    w24 = w2 + crank_theta_dot * (w1 * crank_y_dot - w0 * crank_x_dot + c2 * crank_theta_dot) + w11 + w16 + w23
    w25 = w24 + rod_q1_dot * (w13 * rod_y_dot - w8 * rod_x_dot + w19 * rod_theta_dot + c11 * rod_q1_dot) + rod_q2_dot * (w20 * rod_theta_dot + c12 * rod_q2_dot)
    w26 = rod_q3_dot * (w9 * rod_x_dot + w14 * rod_y_dot - w21 * rod_theta_dot + c13 * rod_q3_dot + c14 * rod_q4_dot)
    w27 = rod_q4_dot * (c14 * rod_q3_dot + w10 * rod_x_dot + w15 * rod_y_dot - w22 * rod_theta_dot + c17 * rod_q4_dot)
    w28 = w25 + w26 + w27 + slider_x_dot * (c10 * slider_x_dot) + slider_y_dot * (c10 * slider_y_dot) + slider_theta_dot * (c36 * slider_theta_dot)
    w29 = rod_q1 * c28 * rod_q1 + rod_q2 * c29 * rod_q2 + rod_q3 * c30 * rod_q3 + rod_q4 * c32 * rod_q3 + rod_q3 * c31 * rod_q4
    kinetic = ca.vertcat(
        w28 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (w29 + rod_q4 * c33 * rod_q4) / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        0.0,
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 38 operations."""
    q = ca.SX.sym("q", 13)
    exaggeration = ca.SX.sym("exaggeration", 1)
    c = ca.SX.sym("c", 43)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q4 = q[9]
    slider_x = q[10]
    slider_y = q[11]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    w0 = c5 + c4 * (rod_q4 * exaggeration)
    xy = ca.vertcat(
        crank_x,
        crank_y,
        crank_x + ca.cos(crank_theta) * c0,
        crank_y + ca.sin(crank_theta) * c0,
        rod_x,
        rod_y,
        rod_x + ca.cos(rod_theta) * w0,
        rod_y + ca.sin(rod_theta) * w0,
        slider_x,
        slider_y,
    )
    xy = ca.reshape(xy, 2, 5)
    xy = ca.densify(xy)
    inputs, outputs = [q, exaggeration, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "exaggeration", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 614 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    c1 = c[1]
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
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = crank_theta_dot**2
    w3 = c0 * w0
    w4 = w2 * w3
    w5 = ca.cos(rod_theta)
    w6 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w7 = ca.sin(rod_theta)
    w8 = c9 * rod_q1
    w9 = w5 * w6 - w7 * w8
    w10 = c5 + c4 * rod_q4
    w11 = w5 * w10
    w12 = w4 / w11
    w13 = w7 * w6 + w5 * w8
    w14 = rod_theta_dot**2
    w15 = c6 * rod_q3_dot + c7 * rod_q4_dot
    w16 = c9 * rod_q1_dot
    w17 = 2 * (w5 * w15 - w7 * w16)
    w18 = ca.sin(crank_theta)
    w19 = w18 * c0
    w20 = w19 * w2
    w21 = c4 * rod_q4_dot
    w22 = 2 * (w5 * w21)
    w23 = w7 * w10
    w24 = w22 * rod_theta_dot - w23 * w14 - w20
    w25 = w24 / w11
    w26 = c0 * w18
    w27 = 2 * (w7 * w15 + w5 * w16)
    w28 = w1 * w2
    w29 = 2 * (w7 * w21)
    w30 = c10 * (w23 * w25 - (w11 * w14 + w29 * rod_theta_dot + w28))
    w31 = w2 * w26
    w32 = c10 * (w31 - w23 * w12)
    w33 = (w9 * w14 + w27 * rod_theta_dot - (w13 * w25 - c1 * w28) - w30) * w3 - w19 * (c1 * w31 - w13 * w12 + w32)
    w34 = w1 * (c1 * w4 - w9 * w12) - (w13 * w14 - w17 * rod_theta_dot + (c1 * w20 + w9 * w25)) * w26 - w33
    w35 = w1 / w11
    w36 = c11 * rod_q1
    w37 = c12 * rod_q2
    w38 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w39 = c15 + w38
    w40 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w41 = c18 + w40
    w42 = c19 + (rod_q1 * w36 + rod_q2 * w37 + rod_q3 * w39 + rod_q4 * w41)
    w43 = w23 * w32 - (w42 * w12 - (w13 * w31 + w9 * w4))
    w44 = -2.0 * (w36 * rod_q1_dot + w37 * rod_q2_dot + w38 * rod_q3_dot + w40 * rod_q4_dot)
    w45 = w44 * rod_theta_dot - (w13 * w28 - w9 * w20 - w42 * w25) + w30 * w23
    w46 = w26 / w11
    w47 = w6 * w5 - w8 * w7
    w48 = w10 * w5
    w49 = w25 / w11
    w50 = w10 * w7
    w51 = (rod_theta_dot * (2 * -(w21 * w7)) - w14 * w48) / w11 + w49 * w50
    w52 = w6 * w7 + w8 * w5
    w53 = c10 * (w24 + w23 * w51 - (rod_theta_dot * (2 * (w21 * w5)) - w14 * w50))
    w54 = w1 * (w14 * w47 - rod_theta_dot * (2 * -(w15 * w7 + w16 * w5)) + (w9 * w51 - w25 * w52)) - w19 * (rod_theta_dot * (2 * (w15 * w5 - w16 * w7)) - w14 * w52 - (w25 * w47 + w13 * w51) - w53)
    w55 = w23 * w53 + w30 * w48 - (w28 * w47 + w20 * w52 - w42 * w51)
    w56 = w35 / w11
    w57 = w56 * w50
    w58 = w54 - (w35 * w55 + w45 * w57)
    w59 = 2 * rod_theta_dot
    w60 = (w22 - w23 * w59) / w11
    w61 = c10 * (w23 * w60 - (w11 * w59 + w29))
    w62 = w44 + w42 * w60 + w23 * w61
    w63 = w1 * (w13 * w59 - w17 + w9 * w60) - w19 * (w9 * w59 + w27 - w13 * w60 - w61) - w35 * w62
    w64 = w7 * c4
    w65 = w64 / w11
    w66 = w65 / w11
    w67 = c4 * w5 / w11 + w66 * w50
    w68 = crank_theta_dot * w57 + rod_q4_dot * w67
    w69 = crank_theta_dot * w46 + w68 * w35
    w70 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w71 = w28 * (c9 * w5) + w20 * (c9 * w7) - w70 * w51
    w72 = w7 * c9
    w73 = w5 * c9
    w74 = w36 * w59 + 2 * (c20 * rod_q3_dot + c21 * rod_q4_dot) + w70 * w60
    w75 = c24 - c23 * rod_q4
    w76 = w37 * w59 + 2 * (c23 * rod_q4_dot) + w75 * w60
    w77 = w75 * w51
    w78 = c25 * rod_q1
    w79 = w7 * c6
    w80 = w5 * c6
    w81 = w78 * w51 - (w20 * (c6 * w5) - w28 * (c6 * w7))
    w82 = w38 * w59 + 2 * (c25 * rod_q1_dot) - w78 * w60
    w83 = c26 * rod_q1 + c27 * rod_q2
    w84 = w7 * c7
    w85 = w5 * c7
    w86 = w5 * c4
    w87 = w83 * w51 - (w20 * (c7 * w5) - w28 * (c7 * w7)) + (w86 * w53 - w30 * (c4 * w7)) + (w65 * w55 + w45 * w67)
    w88 = w40 * w59 + 2 * (c26 * rod_q1_dot + c27 * rod_q2_dot) - w83 * w60 - w86 * w61 - w65 * w62
    w89 = rod_theta_dot * (-2.0 * (rod_q1_dot * c11)) - (w28 * w73 + w20 * w72 - w25 * (2 * w36))
    w90 = rod_theta_dot * (-2.0 * (rod_q2_dot * c12)) + w25 * (2 * w37)
    w91 = rod_theta_dot * (-2.0 * (rod_q3_dot * c13 + rod_q4_dot * c16)) - (w28 * w79 - w20 * w80 - w25 * (w39 + rod_q3 * c13 + rod_q4 * c16))
    w92 = w14 * w64 / w11 + w49 * w86
    w93 = c10 * (w25 * w64 - w23 * w92 - w14 * w86)
    w94 = rod_theta_dot * (-2.0 * (rod_q3_dot * c14 + rod_q4_dot * c17)) - (w28 * w84 - w20 * w85 - (w25 * (rod_q3 * c14 + (w41 + rod_q4 * c17)) - w42 * w92))
    w95 = w94 + (w23 * w93 + w30 * w64)
    w96 = w56 * w86
    w97 = w1 * (w14 * w84 + (w25 * w85 - w9 * w92)) - w19 * (w14 * w85 - (w25 * w84 - w13 * w92) - w93) - (w35 * w95 - w45 * w96)
    w98 = w66 * w86
    w99 = crank_theta_dot * w96 + rod_q4_dot * w98 + w68 * w65
    dQ_hat_dq_i = ca.vertcat(
        w34 - (w35 * w43 - w45 * w46) - w58 * w35 + w63 * w69,
        w71 * w35 - (w70 * w12 - (w72 * w31 + w73 * w4)) + w74 * w69,
        w76 * w69 - (w75 * w12 + w77 * w35),
        w78 * w12 + (w79 * w4 - w80 * w31) + w81 * w35 + w82 * w69,
        w83 * w12 + (w84 * w4 - w85 * w31) - w86 * w32 - w65 * w43 + w87 * w35 + w88 * w69,
        w1 * (w14 * w73 - w25 * w72) + w19 * (w14 * w72 + w25 * w73) - w35 * w89,
        w14 * c11 - c28,
        0.0,
        -(w25 * c25),
        -(w25 * c26 + w65 * w89),
        -(w35 * w90),
        0.0,
        w14 * c12 - c29,
        0.0,
        -(w25 * c27 + w65 * w90),
        w1 * (w14 * w79 + w25 * w80) - w19 * (w14 * w80 - w25 * w79) - w35 * w91,
        -(w25 * c20),
        0.0,
        w14 * c13 - c30,
        w14 * c16 - c32 - w65 * w91,
        w97 - w58 * w65 + w63 * w99,
        w71 * w65 - (w25 * c21 + w70 * w92) + w74 * w99,
        w76 * w99 - (w25 * c23 + w75 * w92 + w77 * w65),
        w14 * c14 - c31 + w78 * w92 + w81 * w65 + w82 * w99,
        w14 * c17 - c33 + w83 * w92 - w86 * w93 - (w65 * w95 - w45 * w98) + w87 * w65 + w88 * w99,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 5, 5)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 365 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    c1 = c[1]
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
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = 2 * crank_theta_dot
    w3 = w1 * w2
    w4 = ca.cos(rod_theta)
    w5 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w6 = ca.sin(rod_theta)
    w7 = c9 * rod_q1
    w8 = w4 * w5 - w6 * w7
    w9 = c5 + c4 * rod_q4
    w10 = w4 * w9
    w11 = w3 / w10
    w12 = w6 * w5 + w4 * w7
    w13 = w0 * w2
    w14 = w6 * w9
    w15 = c10 * (w14 * w11 + w13)
    w16 = w0 / w10
    w17 = c11 * rod_q1
    w18 = c12 * rod_q2
    w19 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w20 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w21 = c19 + (rod_q1 * w17 + rod_q2 * w18 + rod_q3 * (c15 + w19) + rod_q4 * (c18 + w20))
    w22 = w12 * w13 - w8 * w3 + w21 * w11 + w14 * w15
    w23 = 2 * rod_theta_dot
    w24 = c6 * rod_q3_dot + c7 * rod_q4_dot
    w25 = c9 * rod_q1_dot
    w26 = c4 * rod_q4_dot
    w27 = (2 * (w4 * w26) - w14 * w23) / w10
    w28 = c10 * (w14 * w27 - (w10 * w23 + 2 * (w6 * w26)))
    w29 = w0 * (w12 * w23 - 2 * (w4 * w24 - w6 * w25) + w8 * w27) - w1 * (w8 * w23 + 2 * (w6 * w24 + w4 * w25) - w12 * w27 - w28)
    w30 = -2.0 * (w17 * rod_q1_dot + w18 * rod_q2_dot + w19 * rod_q3_dot + w20 * rod_q4_dot) + w21 * w27 + w14 * w28
    w31 = w29 - w16 * w30
    w32 = w6 * c9
    w33 = w4 * c9
    w34 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w35 = w17 * w23 + 2 * (c20 * rod_q3_dot + c21 * rod_q4_dot) + w34 * w27
    w36 = c24 - c23 * rod_q4
    w37 = w18 * w23 + 2 * (c23 * rod_q4_dot) + w36 * w27
    w38 = c25 * rod_q1
    w39 = w4 * c6
    w40 = w6 * c6
    w41 = w19 * w23 + 2 * (c25 * rod_q1_dot) - w38 * w27
    w42 = c26 * rod_q1 + c27 * rod_q2
    w43 = w4 * c7
    w44 = w6 * c7
    w45 = w4 * c4
    w46 = w6 * c4
    w47 = w46 / w10
    w48 = w20 * w23 + 2 * (c26 * rod_q1_dot + c27 * rod_q2_dot) - w42 * w27 - w45 * w28 - w47 * w30
    w49 = rod_theta_dot * (-2.0 * w17)
    w50 = rod_theta_dot * (-2.0 * w18)
    w51 = rod_theta_dot * (-2.0 * w19)
    w52 = rod_theta_dot * (2 * w45) / w10
    w53 = c10 * (w14 * w52 - rod_theta_dot * (2 * w46))
    w54 = rod_theta_dot * (-2.0 * w20) + w21 * w52 + w14 * w53
    w55 = w0 * (w8 * w52 - rod_theta_dot * (2 * w43)) - w1 * (rod_theta_dot * (2 * w44) - w12 * w52 - w53) - w16 * w54
    dQ_hat_dq_i_dot = ca.vertcat(
        w0 * (c1 * w3 - w8 * w11) - w1 * (w12 * w11 + c1 * w13 + w15) + w16 * w22 - w31 * w16,
        -(w32 * w13 - w33 * w3 + w34 * w11 + w35 * w16),
        -(w36 * w11 + w37 * w16),
        w38 * w11 + (w39 * w13 + w40 * w3) - w41 * w16,
        w42 * w11 + (w43 * w13 + w44 * w3) + w45 * w15 + w47 * w22 - w48 * w16,
        -(w0 * (rod_theta_dot * (2 * -w32)) + w1 * (rod_theta_dot * (2 * w33)) + w16 * w49),
        0.0,
        0.0,
        rod_theta_dot * c37,
        rod_theta_dot * c38 - w47 * w49,
        -(w16 * w50),
        0.0,
        0.0,
        0.0,
        rod_theta_dot * c39 - w47 * w50,
        -(w0 * (rod_theta_dot * (2 * w39)) + w1 * (rod_theta_dot * (2 * w40)) + w16 * w51),
        rod_theta_dot * c40,
        0.0,
        0.0,
        -(w47 * w51),
        w55 - w31 * w47,
        rod_theta_dot * c41 + w34 * w52 - w35 * w47,
        rod_theta_dot * c42 + w36 * w52 - w37 * w47,
        -(w38 * w52 + w41 * w47),
        -(w42 * w52 + w45 * w53 + w47 * w54 + w48 * w47),
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 5, 5)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 443 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    rod_q3_ddot = q_i_ddot[3]
    rod_q4_ddot = q_i_ddot[4]
    c0 = c[0]
    c1 = c[1]
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
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = ca.cos(rod_theta)
    w3 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w4 = ca.sin(rod_theta)
    w5 = c9 * rod_q1
    w6 = w2 * w3 - w4 * w5
    w7 = ca.sin(crank_theta)
    w8 = c0 * w7
    w9 = c5 + c4 * rod_q4
    w10 = w2 * w9
    w11 = w8 / w10
    w12 = crank_theta_ddot * w11
    w13 = crank_theta_ddot * w8
    w14 = w1 * crank_theta_ddot
    w15 = w1 / w10
    w16 = w4 * c4
    w17 = w16 / w10
    w18 = w15 * crank_theta_ddot + w17 * rod_q4_ddot
    w19 = w2 * c9
    w20 = w4 * c6
    w21 = w4 * c7
    w22 = w1 * (w6 * w12 - c1 * w13) - (c1 * w14 - w6 * w18 + w19 * rod_q1_ddot + w20 * rod_q3_ddot + w21 * rod_q4_ddot) * w8
    w23 = w4 * w3 + w2 * w5
    w24 = w7 * c0
    w25 = w24 * crank_theta_ddot
    w26 = w4 * c9
    w27 = w2 * c6
    w28 = w2 * c7
    w29 = w4 * w9
    w30 = w2 * c4
    w31 = c10 * (w29 * w18 - w25 + w30 * rod_q4_ddot)
    w32 = c0 * w0
    w33 = crank_theta_ddot * w32
    w34 = c10 * (w29 * w12 + w33)
    w35 = (w23 * w18 - c1 * w25 - w26 * rod_q1_ddot + w27 * rod_q3_ddot + w28 * rod_q4_ddot + w31) * w32 - w24 * (w23 * w12 + c1 * w33 + w34)
    w36 = c11 * rod_q1
    w37 = c12 * rod_q2
    w38 = c15 + (c15 + (c13 * rod_q3 + c14 * rod_q4))
    w39 = c18 + (c18 + (c16 * rod_q3 + c17 * rod_q4))
    w40 = c19 + (rod_q1 * w36 + rod_q2 * w37 + rod_q3 * w38 + rod_q4 * w39)
    w41 = w23 * w33 - w6 * w13 + w40 * w12 + w29 * w34
    w42 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w43 = c24 - c23 * rod_q4
    w44 = c25 * rod_q1
    w45 = c26 * rod_q1 + c27 * rod_q2
    w46 = w23 * w25 + w6 * w14 - w40 * w18 + w42 * rod_q1_ddot + w43 * rod_q2_ddot - w44 * rod_q3_ddot - w45 * rod_q4_ddot
    w47 = w46 - w31 * w29
    w48 = c6 * w2
    w49 = w15 / w10
    w50 = w9 * w4
    w51 = w49 * w50
    w52 = w17 / w10
    w53 = c4 * w2 / w10 + w52 * w50
    w54 = crank_theta_ddot * w51 + rod_q4_ddot * w53
    w55 = w3 * w4 + w5 * w2
    w56 = c9 * w4
    w57 = c7 * w2
    w58 = w3 * w2 - w5 * w4
    w59 = c9 * w2
    w60 = c6 * w4
    w61 = c7 * w4
    w62 = w9 * w2
    w63 = c4 * w4
    w64 = c10 * (w18 * w62 + w29 * w54 - rod_q4_ddot * w63)
    w65 = w1 * (rod_q3_ddot * w48 - (w6 * w54 - w18 * w55 + rod_q1_ddot * w56) + rod_q4_ddot * w57) - w24 * (w18 * w58 + w23 * w54 - rod_q1_ddot * w59 - rod_q3_ddot * w60 - rod_q4_ddot * w61 + w64)
    w66 = w25 * w58 - w14 * w55 - w40 * w54 - (w29 * w64 + w31 * w62)
    w67 = w65 - (w15 * w66 + w47 * w51)
    w68 = w25 * w59 - w14 * w56 - w42 * w54
    w69 = w43 * w54
    w70 = w14 * w48 + w25 * w60 + w44 * w54
    w71 = w25 * w61 + w14 * w57 + w45 * w54 + (w30 * w64 - w31 * w63) - (w17 * w66 + w47 * w53)
    w72 = w25 * w19 - w14 * w26 - w18 * (2 * w36) - rod_q3_ddot * c25 - rod_q4_ddot * c26
    w73 = w18 * (2 * w37) + rod_q4_ddot * c27
    w74 = w25 * w20 + w14 * w27 - w18 * (w38 + rod_q3 * c13 + rod_q4 * c16) - rod_q1_ddot * c20
    w75 = w49 * w30
    w76 = w52 * w30
    w77 = crank_theta_ddot * w75 + rod_q4_ddot * w76
    w78 = c10 * (w18 * w16 - w29 * w77)
    w79 = w25 * w21 + w14 * w28 - (w18 * (rod_q3 * c14 + (w39 + rod_q4 * c17)) - w40 * w77) - rod_q1_ddot * c21
    w80 = w79 - rod_q2_ddot * c23 - (w29 * w78 + w31 * w16)
    w81 = w1 * (w18 * w28 - w6 * w77) + w24 * (w18 * w21 - w23 * w77 + w78) + (w15 * w80 - w47 * w75) + w67 * w17
    dMa_dq_i = ca.vertcat(
        w22 - w35 - (w15 * w41 - w47 * w11) - w67 * w15,
        w26 * w33 - w19 * w13 + w42 * w12 - w68 * w15,
        w43 * w12 + w69 * w15,
        -(w20 * w13 + w27 * w33 + w44 * w12 + w70 * w15),
        -(w28 * w33 + w21 * w13 + w45 * w12 + w30 * w34 + w17 * w41 + w71 * w15),
        w1 * (w18 * w26) - w24 * (w18 * w19) - w15 * w72,
        0.0,
        0.0,
        w18 * c25,
        w18 * c26 - w17 * w72,
        w15 * w73,
        0.0,
        0.0,
        0.0,
        w18 * c27 + w17 * w73,
        -(w1 * (w18 * w27) + w24 * (w18 * w20) + w15 * w74),
        w18 * c20,
        0.0,
        0.0,
        -(w17 * w74),
        -w81,
        w18 * c21 + w42 * w77 - w68 * w17,
        w18 * c23 + w43 * w77 + w69 * w17,
        -(w44 * w77 + w70 * w17),
        w30 * w78 - w45 * w77 - (w17 * w80 - w47 * w76) - w71 * w17,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 5, 5)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 251 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 43)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_q3 = q_i[3]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_q3_dot = q_i_dot[3]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_L_ddot[0]
    c0 = c[0]
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
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = c5 + c4 * rod_q4
    w3 = w1 * w2
    w4 = w0 * c4 / w3
    w5 = c22 - (c20 * rod_q3 + c21 * rod_q4)
    w6 = -(w4 * w5)
    w7 = c24 - c23 * rod_q4
    w8 = -(w4 * w7)
    w9 = c25 * rod_q1
    w10 = c14 + w4 * w9
    w11 = w1 * c4
    w12 = w11 * c10
    w13 = c26 * rod_q1 + c27 * rod_q2
    w14 = w0 * w2
    w15 = w13 + w14 * w12
    w16 = c11 * rod_q1
    w17 = c12 * rod_q2
    w18 = c15 + (c13 * rod_q3 + c14 * rod_q4)
    w19 = c18 + (c16 * rod_q3 + c17 * rod_q4)
    w20 = c19 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c15 + w18) + rod_q4 * (c18 + w19))
    w21 = rod_theta_dot**2
    w22 = ca.cos(crank_theta) * c0
    w23 = crank_theta_dot**2
    w24 = ca.sin(crank_theta) * c0
    w25 = w22 * w23 + w24 * crank_theta_ddot
    w26 = w24 * w23
    w27 = w22 * crank_theta_ddot - w26
    w28 = c4 * rod_q4_dot
    w29 = (2 * (w1 * w28) * rod_theta_dot - w14 * w21 - w26) / w3 + w22 / w3 * crank_theta_ddot
    w30 = w16 * w21 + 2 * (c20 * rod_q3_dot + c21 * rod_q4_dot) * rod_theta_dot - c28 * rod_q1 - (w0 * c9 * w25 + w1 * c9 * w27 - w5 * w29)
    w31 = w18 * w21 + 2 * (c25 * rod_q1_dot) * rod_theta_dot - (c30 * rod_q3 + c31 * rod_q4) - (w0 * c6 * w27 - w1 * c6 * w25 + w9 * w29)
    w32 = w19 * w21 + 2 * (c26 * rod_q1_dot + c27 * rod_q2_dot) * rod_theta_dot - (c32 * rod_q3 + c33 * rod_q4)
    w33 = c10 * (w14 * w29 - (w3 * w21 + 2 * (w0 * w28) * rod_theta_dot + w25))
    w34 = -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot) * rod_theta_dot
    w35 = c8 + (c6 * rod_q3 + c7 * rod_q4)
    w36 = c9 * rod_q1
    w37 = w32 - (w0 * c7 * w27 - w1 * c7 * w25 + w13 * w29) - w33 * w11 - (w34 - ((w0 * w35 + w1 * w36) * w25 + (w1 * w35 - w0 * w36) * w27 - w20 * w29) + w33 * w14) * w4
    M_hat_SS = ca.vertcat(
        c11,
        0.0,
        0.0,
        w6,
        0.0,
        c12,
        0.0,
        w8,
        0.0,
        0.0,
        c13,
        w10,
        w6,
        w8,
        w10,
        c17 + w11 * w12 + (w4 * (w15 + w4 * (w20 + w14 * (w14 * c10))) + w4 * w15),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 4, 4)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w30,
        w17 * w21 + 2 * (c23 * rod_q4_dot) * rod_theta_dot - c29 * rod_q2 + w7 * w29,
        w31,
        w37,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


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
    "drawing": drawing,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "substep_2": substep_2,
}
