"""Flexible slider-crank, running freely: equations of motion, emitted by symgen from the scene `flexible_slider_crank_free`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 92 operations."""
    p = ca.SX.sym("p", 67)
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
    rod_M_ff_3_3 = p[17]
    rod_phi_cross_phi_0_2 = p[18]
    rod_phi_cross_phi_0_3 = p[19]
    rod_phi_cross_phi_1_3 = p[20]
    rod_phi_cross_phi_2_0 = p[21]
    rod_phi_cross_phi_3_0 = p[22]
    rod_phi_cross_phi_3_1 = p[23]
    rod_K_ff_0_0 = p[24]
    rod_K_ff_1_1 = p[25]
    rod_K_ff_2_2 = p[26]
    rod_K_ff_2_3 = p[27]
    rod_K_ff_3_3 = p[28]
    slider_mass = p[29]
    slider_inertia = p[30]
    crank_tip_x = p[31]
    rod_end_x = p[32]
    rod_end_shape_0_3 = p[33]
    c = ca.vertcat(
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        crank_tip_x,
        rod_mass,
        slider_mass,
        rod_mass + slider_mass,
        rod_end_x,
        rod_end_shape_0_3,
        rod_first_moment_x,
        rod_phi_integral_0_2,
        rod_phi_integral_0_3,
        rod_phi_integral_1_0,
        rod_inertia,
        rod_M_ff_0_0,
        rod_M_ff_1_1,
        rod_rho_dot_phi_2_0,
        rod_M_ff_2_2,
        rod_M_ff_2_3,
        rod_rho_dot_phi_3_0,
        rod_M_ff_3_3,
        rod_rho_cross_phi_0_0,
        rod_phi_cross_phi_0_2,
        rod_phi_cross_phi_0_3,
        rod_rho_cross_phi_1_0,
        rod_phi_cross_phi_1_3,
        rod_phi_cross_phi_2_0,
        rod_phi_cross_phi_3_0,
        rod_phi_cross_phi_3_1,
        rod_K_ff_0_0,
        rod_K_ff_1_1,
        rod_K_ff_2_2,
        rod_K_ff_2_3,
        rod_K_ff_3_3,
        -rod_end_shape_0_3,
        crank_mass,
        crank_mass * crank_center_of_mass_x,
        -rod_phi_integral_1_0,
        -rod_phi_cross_phi_2_0,
        slider_inertia,
        rod_rho_dot_phi_2_0 + rod_rho_dot_phi_2_0,
        rod_rho_dot_phi_3_0 + rod_rho_dot_phi_3_0,
        rod_K_ff_2_3 + rod_K_ff_2_3,
        2 * rod_phi_cross_phi_1_3,
        2 * rod_phi_cross_phi_2_0,
        -rod_phi_cross_phi_0_2,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 316 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 44)
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
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = ca.cos(rod_theta)
    w3 = c5 + rod_q4 * c6
    w4 = w2 * w3
    w5 = w0 / w4
    w6 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w7 = ca.sin(rod_theta)
    w8 = rod_q1 * c10
    w9 = w2 * w6 - w7 * w8
    w10 = w6 * w7 + w2 * w8
    w11 = w3 * w7
    w12 = w11 * c3
    w13 = w0 * w9 + w1 * (w10 + w12)
    w14 = rod_q1 * c12
    w15 = rod_q2 * c13
    w16 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w17 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w18 = c11 + (rod_q1 * w14 + rod_q2 * w15 + rod_q3 * (c14 + w16) + rod_q4 * (c17 + w17))
    w19 = w18 + w11 * w12
    w20 = w2 * c10
    w21 = w7 * c10
    w22 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w23 = w0 * w20 + w1 * w21 - w5 * w22
    w24 = c22 - rod_q4 * c23
    w25 = -(w5 * w24)
    w26 = w7 * c8
    w27 = w2 * c8
    w28 = rod_q1 * c24
    w29 = w0 * w26 - w1 * w27 + w5 * w28
    w30 = w7 * c9
    w31 = w2 * c9
    w32 = w2 * c6
    w33 = w32 * c3
    w34 = rod_q1 * c25 + rod_q2 * c26
    w35 = w34 + w11 * w33
    w36 = w7 * c6 / w4
    w37 = w35 + w19 * w36
    w38 = w0 * w30 - w1 * (w31 + w33) + (w5 * w37 - w13 * w36)
    w39 = -(w22 * w36)
    w40 = -(w24 * w36)
    w41 = c16 + w28 * w36
    w42 = rod_theta_dot**2
    w43 = 2 * rod_theta_dot
    w44 = rod_q3_dot * c8 + rod_q4_dot * c9
    w45 = rod_q1_dot * c10
    w46 = crank_theta_dot**2
    w47 = w1 * w46
    w48 = rod_q4_dot * c6
    w49 = (w43 * (w2 * w48) - w11 * w42 - w47) / w4
    w50 = w0 * w46
    w51 = (w11 * w49 - (w50 + (w4 * w42 + w43 * (w7 * w48)))) * c3
    w52 = w0 * (w10 * w42 - w43 * (w2 * w44 - w7 * w45) + (w47 * c2 + w9 * w49)) - w1 * (w9 * w42 + w43 * (w7 * w44 + w2 * w45) - (w10 * w49 - w50 * c2) - w51)
    w53 = rod_theta_dot * -2.0 * (w14 * rod_q1_dot + w15 * rod_q2_dot + w16 * rod_q3_dot + w17 * rod_q4_dot)
    w54 = w53 - (w10 * w50 - w9 * w47 - w18 * w49) + w11 * w51
    w55 = w14 * w42 + w43 * (rod_q3_dot * c20 + rod_q4_dot * c21) - rod_q1 * c27 - (w21 * w50 - w20 * w47 - w22 * w49)
    w56 = w16 * w42 + w43 * (rod_q1_dot * c24) - (rod_q3 * c29 + rod_q4 * c30) - (w28 * w49 - (w27 * w50 + w26 * w47))
    w57 = w17 * w42 + w43 * (rod_q1_dot * c25 + rod_q2_dot * c26) - (rod_q3 * c30 + rod_q4 * c31) - (w34 * w49 - (w31 * w50 + w30 * w47))
    M_hat = ca.vertcat(
        c0 + w0 * (w0 * c2) + w1 * (w1 * c4) - (w5 * (w13 - w5 * w19) + w5 * w13),
        w23,
        w25,
        w29,
        w38,
        w23,
        c12,
        0.0,
        0.0,
        w39,
        w25,
        0.0,
        c13,
        0.0,
        w40,
        w29,
        0.0,
        0.0,
        c15,
        w41,
        w38,
        w39,
        w40,
        w41,
        c18 + w32 * w33 + (w36 * w37 + w35 * w36),
    )
    M_hat = ca.reshape(M_hat, 5, 5)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w52 - w5 * w54,
        w55,
        w15 * w42 + w43 * (rod_q4_dot * c23) - rod_q2 * c28 + w24 * w49,
        w56,
        w57 - w32 * w51 - w36 * w54,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 35 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 44)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    c1 = c[1]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = c5 + rod_q4 * c6
    w3 = w1 + ca.sin(rod_theta) * w2
    w4 = w2 * ca.cos(rod_theta)
    w5 = rod_theta - w3 / w4
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w5,
        w0 + w2 * ca.cos(w5),
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w3,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        -w4,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 42 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 44)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    c1 = c[1]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.sin(crank_theta) * c1 * crank_theta_dot
    w1 = ca.cos(crank_theta) * c1
    w2 = ca.cos(rod_theta)
    w3 = c5 + rod_q4 * c6
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = crank_theta_dot * (w1 / w4) + w5 * c6 / w4 * rod_q4_dot
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -w0,
        crank_theta_dot * w1,
        -w6,
        w6 * (w3 * w5) - w0 + rod_q4_dot * (w2 * c6),
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 65 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 44)
    crank_theta = q_i[0]
    rod_q4 = q_i[4]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q4_dot = q_i_dot[4]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q4_ddot = q_i_ddot[4]
    c1 = c[1]
    c5 = c[5]
    c6 = c[6]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c1
    w2 = ca.sin(crank_theta) * c1
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w0 * w2
    w5 = 2 * rod_theta_dot
    w6 = ca.cos(rod_theta)
    w7 = rod_q4_dot * c6
    w8 = rod_theta_dot**2
    w9 = ca.sin(rod_theta)
    w10 = c5 + rod_q4 * c6
    w11 = w9 * w10
    w12 = w6 * w10
    w13 = (w5 * (w6 * w7) - w8 * w11 - w4) / w12 + crank_theta_ddot * (w1 / w12) + w9 * c6 / w12 * rod_q4_ddot
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -w3,
        w1 * crank_theta_ddot - w4,
        -w13,
        w11 * w13 - (w3 + (w8 * w12 + w5 * (w7 * w9))) + rod_q4_ddot * (w6 * c6),
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 195 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 44)
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
    c1 = c[1]
    c5 = c[5]
    c6 = c[6]
    c32 = c[32]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = ca.cos(rod_theta)
    w3 = c5 + rod_q4 * c6
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w3 * w5
    w7 = crank_theta_dot**2
    w8 = rod_theta_dot**2
    w9 = 2 * rod_theta_dot
    w10 = rod_q4_dot * c6
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
        w2 * c32,
        w5 * c32,
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
    nu = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w7),
        -(w1 * w7),
        0.0,
        0.0,
        -(w4 * w8 + w9 * (w5 * w10)),
        w9 * (w2 * w10) - w6 * w8,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 684 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 44)
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
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
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
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    w0 = ca.sin(crank_theta)
    w1 = w0 * c34
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c34
    w5 = ca.sin(rod_theta)
    w6 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * c10
    w9 = w5 * w6 + w7 * w8
    w10 = -w9
    w11 = w5 * c35
    w12 = w7 * c8
    w13 = w7 * c9
    w14 = w6 * w7 - w5 * w8
    w15 = w7 * c10
    w16 = w5 * c8
    w17 = w5 * c9
    w18 = rod_q1 * c12
    w19 = rod_q2 * c13
    w20 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w21 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w22 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w23 = c22 - rod_q4 * c23
    w24 = rod_q1 * c36
    w25 = -(rod_q1 * c25 + rod_q2 * c26)
    w26 = crank_theta_dot**2
    w27 = w4 * w26
    w28 = w1 * w26
    w29 = rod_theta_dot**2
    w30 = 2 * rod_theta_dot
    w31 = rod_q3_dot * c8 + rod_q4_dot * c9
    w32 = rod_q1_dot * c10
    w33 = w14 * w29 + w30 * (w5 * w31 + w7 * w32)
    w34 = w9 * w29 - w30 * (w7 * w31 - w5 * w32)
    w35 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot + w20 * rod_q3_dot + w21 * rod_q4_dot)
    w36 = w18 * w29 + w30 * (rod_q3_dot * c20 + rod_q4_dot * c21)
    w37 = w19 * w29 + w30 * (rod_q4_dot * c23)
    w38 = w20 * w29 + w30 * (rod_q1_dot * c24)
    w39 = w21 * w29 + w30 * (rod_q1_dot * c25 + rod_q2_dot * c26)
    w40 = w0 * c1
    w41 = w3 * c1
    w42 = c5 + rod_q4 * c6
    w43 = w5 * w42
    w44 = w7 * w42
    w45 = rod_q4_dot * c6
    M = ca.vertcat(
        c33,
        0.0,
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
        0.0,
        c33,
        w4,
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
        w2,
        w4,
        c0,
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
        c2,
        0.0,
        w10,
        w11,
        0.0,
        w12,
        w13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
        w14,
        w15,
        0.0,
        w16,
        w17,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w10,
        w14,
        c11 + (rod_q1 * w18 + rod_q2 * w19 + rod_q3 * (c14 + w20) + rod_q4 * (c17 + w21)),
        w22,
        w23,
        w24,
        w25,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w11,
        w15,
        w22,
        c12,
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
        w23,
        0.0,
        c13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w16,
        w24,
        0.0,
        0.0,
        c15,
        c16,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w13,
        w17,
        w25,
        0.0,
        0.0,
        c16,
        c18,
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
        c3,
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
        c3,
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
        c37,
    )
    M = ca.reshape(M, 13, 13)
    M = ca.densify(M)
    K = ca.vertcat(
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
        c27,
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
        c28,
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
        c29,
        c30,
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
        c30,
        c31,
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
    )
    K = ca.reshape(K, 13, 13)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w27,
        w28,
        0.0,
        w33,
        w34,
        w35,
        w36,
        w37,
        w38,
        w39,
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
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
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w27,
        w28,
        0.0,
        w33,
        w34,
        w35,
        w36 - rod_q1 * c27,
        w37 - rod_q2 * c28,
        w38 - (rod_q3 * c29 + rod_q4 * c30),
        w39 - (rod_q3 * c30 + rod_q4 * c31),
        0.0,
        0.0,
        0.0,
    )
    Q_star = ca.densify(Q_star)
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
        w40,
        -w41,
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
        w43,
        -w44,
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
        w7 * c32,
        w5 * c32,
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
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w26 * w41),
        -(w26 * w40),
        0.0,
        0.0,
        -(w29 * w44 + w30 * (w5 * w45)),
        w30 * (w7 * w45) - w29 * w43,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 222 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 44)
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
    c2 = c[2]
    c3 = c[3]
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
    c33 = c[33]
    c34 = c[34]
    c37 = c[37]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c34
    w2 = ca.sin(crank_theta) * c34
    w3 = rod_theta_dot**2
    w4 = ca.cos(rod_theta)
    w5 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w6 = ca.sin(rod_theta)
    w7 = rod_q1 * c10
    w8 = w4 * w5 - w6 * w7
    w9 = 2 * rod_theta_dot
    w10 = rod_q3_dot * c8 + rod_q4_dot * c9
    w11 = rod_q1_dot * c10
    w12 = w5 * w6 + w4 * w7
    w13 = rod_x_ddot * c2 - w12 * rod_theta_ddot - w6 * c10 * rod_q1_ddot + w4 * c8 * rod_q3_ddot + w4 * c9 * rod_q4_ddot
    w14 = slider_x_ddot * c3
    w15 = w3 * w8 + w9 * (w6 * w10 + w4 * w11) - w13 - w14
    w16 = w0 * w1 - (crank_x_ddot * c33 - w2 * crank_theta_ddot) + w15
    w17 = rod_y_ddot * c2 + w8 * rod_theta_ddot + rod_q1_ddot * (w4 * c10) + rod_q3_ddot * (w6 * c8) + rod_q4_ddot * (w6 * c9)
    w18 = rod_q1 * c12
    w19 = rod_q2 * c13
    w20 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w21 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w22 = rod_theta_dot * -2.0 * (rod_q1_dot * w18 + w19 * rod_q2_dot + rod_q3_dot * w20 + rod_q4_dot * w21)
    w23 = rod_theta_ddot * (c11 + (rod_q1 * w18 + rod_q2 * w19 + rod_q3 * (c14 + w20) + rod_q4 * (c17 + w21)))
    w24 = w8 * rod_y_ddot - rod_x_ddot * w12 + w23 + rod_q1_ddot * (c19 - (rod_q3 * c20 + rod_q4 * c21)) + (c22 - rod_q4 * c23) * rod_q2_ddot
    w25 = c5 + rod_q4 * c6
    w26 = w22 - (w24 - rod_q3_ddot * (rod_q1 * c24) - rod_q4_ddot * (rod_q1 * c25 + rod_q2 * c26)) + w14 * (w6 * w25)
    w27 = w26 / (w4 * w25)
    w28 = w3 * w12 - w9 * (w4 * w10 - w6 * w11) - w17 - w27
    w29 = w0 * w2 - (crank_y_ddot * c33 + w1 * crank_theta_ddot) + w28
    w30 = w27 - slider_y_ddot * c3
    w31 = slider_theta_ddot * c37
    lam = ca.vertcat(
        w16,
        w29,
        w15,
        w28,
        w30,
        -w31,
        -w14,
        -w27,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w16,
        -w29,
        0.0,
        -w15,
        -w28,
        0.0,
        0.0,
        -w30,
        w31,
        w14,
        w27,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 4)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 222 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 44)
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
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c15 = c[15]
    c16 = c[16]
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
    c31 = c[31]
    c33 = c[33]
    c34 = c[34]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    w0 = ca.sin(crank_theta) * c34
    w1 = ca.cos(crank_theta) * c34
    w2 = crank_x_dot * (crank_x_dot * c33 - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * c33 + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta)
    w4 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w5 = ca.cos(rod_theta)
    w6 = rod_q1 * c10
    w7 = w3 * w4 + w5 * w6
    w8 = w3 * c10
    w9 = w5 * c8
    w10 = w5 * c9
    w11 = rod_x_dot * (rod_x_dot * c2 - w7 * rod_theta_dot - w8 * rod_q1_dot + w9 * rod_q3_dot + w10 * rod_q4_dot)
    w12 = w4 * w5 - w3 * w6
    w13 = w5 * c10
    w14 = w3 * c8
    w15 = w3 * c9
    w16 = rod_y_dot * (rod_y_dot * c2 + rod_theta_dot * w12 + rod_q1_dot * w13 + rod_q3_dot * w14 + rod_q4_dot * w15)
    w17 = rod_q1 * (rod_q1 * c12) + rod_q2 * (rod_q2 * c13) + rod_q3 * (rod_q4 * c16 + (rod_q3 * c15 + c38))
    w18 = rod_y_dot * w12 - rod_x_dot * w7 + rod_theta_dot * (c11 + (w17 + rod_q4 * (rod_q4 * c18 + (rod_q3 * c16 + c39))))
    w19 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w20 = c22 - rod_q4 * c23
    w21 = rod_q1 * c24
    w22 = rod_q1 * c25 + rod_q2 * c26
    w23 = rod_theta_dot * (w18 + rod_q1_dot * w19 + w20 * rod_q2_dot - rod_q3_dot * w21 - rod_q4_dot * w22)
    w24 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c0) + w11 + w16 + w23
    w25 = w24 + rod_q1_dot * (rod_y_dot * w13 - rod_x_dot * w8 + rod_theta_dot * w19 + rod_q1_dot * c12) + rod_q2_dot * (rod_theta_dot * w20 + rod_q2_dot * c13)
    w26 = rod_q3_dot * (rod_x_dot * w9 + rod_y_dot * w14 - rod_theta_dot * w21 + rod_q3_dot * c15 + rod_q4_dot * c16)
    w27 = rod_q4_dot * (rod_q3_dot * c16 + rod_x_dot * w10 + rod_y_dot * w15 - rod_theta_dot * w22 + rod_q4_dot * c18)
    w28 = w25 + w26 + w27 + slider_x_dot * (slider_x_dot * c3) + slider_y_dot * (slider_y_dot * c3) + slider_theta_dot * (slider_theta_dot * c37)
    w29 = rod_q3 * (rod_q3 * c29) + (rod_q2 * (rod_q2 * c28) + (rod_q1 * (rod_q1 * c27) + rod_q3 * rod_q4 * c40))
    kinetic = ca.vertcat(
        w28 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (w29 + rod_q4 * (rod_q4 * c31)) / 2.0,
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


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 56 operations."""
    q = ca.SX.sym("q", 13)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[10]
    slider_y = q[11]
    slider_theta = q[12]
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(rod_theta)
    w3 = ca.sin(rod_theta)
    w4 = ca.cos(slider_theta)
    w5 = ca.sin(slider_theta)
    poses = ca.vertcat(
        crank_x,
        crank_y,
        0.0,
        w0,
        w1,
        0.0,
        -w1,
        w0,
        0.0,
        0.0,
        0.0,
        1.0,
        rod_x,
        rod_y,
        0.0,
        w2,
        w3,
        0.0,
        -w3,
        w2,
        0.0,
        0.0,
        0.0,
        1.0,
        slider_x,
        slider_y,
        0.0,
        w4,
        w5,
        0.0,
        -w5,
        w4,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    poses = ca.reshape(poses, 12, 3)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 534 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 44)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
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
    c36 = c[36]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    w0 = ca.cos(crank_theta) * c1
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * c2
    w4 = ca.cos(rod_theta)
    w5 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w6 = ca.sin(rod_theta)
    w7 = rod_q1 * c10
    w8 = w4 * w5 - w6 * w7
    w9 = c5 + rod_q4 * c6
    w10 = w4 * w9
    w11 = w2 / w10
    w12 = rod_theta_dot**2
    w13 = w5 * w6 + w4 * w7
    w14 = w12 * w13
    w15 = 2 * rod_theta_dot
    w16 = rod_q3_dot * c8 + rod_q4_dot * c9
    w17 = rod_q1_dot * c10
    w18 = w4 * w16 - w6 * w17
    w19 = w15 * w18
    w20 = ca.sin(crank_theta) * c1
    w21 = w1 * w20
    w22 = w21 * c2
    w23 = rod_q4_dot * c6
    w24 = w4 * w23
    w25 = w6 * w9
    w26 = w15 * w24 - w12 * w25
    w27 = w26 - w21
    w28 = w27 / w10
    w29 = w8 * w28
    w30 = w6 * w16 + w4 * w17
    w31 = w8 * w12 + w15 * w30
    w32 = w13 * w28
    w33 = w6 * w23
    w34 = w10 * w12 + w15 * w33
    w35 = (w25 * w28 - (w2 + w34)) * c3
    w36 = (w21 - w11 * w25) * c3
    w37 = w0 * (w3 - w8 * w11) - w20 * (w14 - w19 + (w22 + w29)) - (w0 * (w31 - (w32 - w3) - w35) - w20 * (w22 - w11 * w13 + w36))
    w38 = w0 / w10
    w39 = rod_q1 * c12
    w40 = rod_q2 * c13
    w41 = rod_q3 * c15
    w42 = rod_q4 * c16
    w43 = c14 + (w41 + w42)
    w44 = c14 + w43
    w45 = rod_q3 * c16
    w46 = rod_q4 * c18
    w47 = c17 + (w45 + w46)
    w48 = c17 + w47
    w49 = c11 + (rod_q1 * w39 + rod_q2 * w40 + rod_q3 * w44 + rod_q4 * w48)
    w50 = w13 * w21 + w2 * w8
    w51 = w25 * w36 - (w11 * w49 - w50)
    w52 = rod_theta_dot * -2.0
    w53 = rod_q1_dot * w39 + w40 * rod_q2_dot + rod_q3_dot * w43 + rod_q4_dot * w47
    w54 = w52 * w53 - (w2 * w13 - w8 * w21 - w28 * w49) + w25 * w35
    w55 = w20 / w10
    w56 = w28 / w10
    w57 = w25 * w56 - w34 / w10
    w58 = (w27 + w25 * w57 - w26) * c3
    w59 = w25 * w58 + w10 * w35 - (w50 - w49 * w57)
    w60 = w38 / w10
    w61 = w25 * w60
    w62 = w0 * (w31 + (w8 * w57 - w32)) - w20 * (w19 - w14 - (w29 + w13 * w57) - w58) - (w38 * w59 + w54 * w61)
    w63 = (2 * w24 - w15 * w25) / w10
    w64 = (w25 * w63 - (w10 * w15 + 2 * w33)) * c3
    w65 = w53 * -2.0 + w49 * w63 + w25 * w64
    w66 = w0 * (w13 * w15 - 2 * w18 + w8 * w63) - w20 * (w8 * w15 + 2 * w30 - w13 * w63 - w64) - w38 * w65
    w67 = w4 * c6
    w68 = w6 * c6
    w69 = w68 / w10
    w70 = w69 / w10
    w71 = w67 / w10 + w25 * w70
    w72 = crank_theta_dot * w61 + rod_q4_dot * w71
    w73 = crank_theta_dot * w55 + w38 * w72
    w74 = w4 * c10
    w75 = w6 * c10
    w76 = w2 * w74 + w21 * w75
    w77 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w78 = w76 - w57 * w77
    w79 = w15 * w39 + 2 * (rod_q3_dot * c20 + rod_q4_dot * c21) + w63 * w77
    w80 = c22 - rod_q4 * c23
    w81 = w15 * w40 + rod_q4_dot * c41 + w63 * w80
    w82 = w57 * w80
    w83 = rod_q1 * c24
    w84 = w6 * c8
    w85 = w2 * w84
    w86 = w4 * c8
    w87 = w21 * w86
    w88 = w85 - w87
    w89 = w57 * w83 - (w87 - w85)
    w90 = w15 * w43 + rod_q1_dot * c42 - w63 * w83
    w91 = rod_q1 * c25 + rod_q2 * c26
    w92 = w6 * c9
    w93 = w2 * w92
    w94 = w4 * c9
    w95 = w21 * w94
    w96 = w93 - w95
    w97 = w35 * w68
    w98 = w57 * w91 - (w95 - w93) + (w58 * w67 - w97) + (w59 * w69 + w54 * w71)
    w99 = w15 * w47 + 2 * (rod_q1_dot * c25 + rod_q2_dot * c26) - w63 * w91 - w64 * w67 - w65 * w69
    w100 = w52 * (rod_q1_dot * c12) - (w76 - w28 * (2 * w39))
    w101 = w52 * (rod_q2_dot * c13) + w28 * (2 * w40)
    w102 = w52 * (rod_q3_dot * c15 + rod_q4_dot * c16) - (w88 - w28 * (w42 + (w41 + w44)))
    w103 = w12 * c16 - c30
    w104 = w12 * w68 / w10 + w56 * w67
    w105 = (w28 * w68 - w25 * w104 - w12 * w67) * c3
    w106 = w52 * (rod_q3_dot * c16 + rod_q4_dot * c18) - (w96 - (w28 * (w45 + (w46 + w48)) - w49 * w104)) + (w97 + w25 * w105)
    w107 = w60 * w67
    w108 = w0 * (w12 * w92 + (w28 * w94 - w8 * w104)) - w20 * (w12 * w94 - (w28 * w92 - w13 * w104) - w105) - (w38 * w106 - w54 * w107)
    w109 = w67 * w70
    w110 = crank_theta_dot * w107 + rod_q4_dot * w109 + w69 * w72
    dQ_hat_dq_i = ca.vertcat(
        w37 - (w38 * w51 - w54 * w55) - w38 * w62 + w66 * w73,
        w38 * w78 - (w11 * w77 - w76) + w73 * w79,
        w73 * w81 - (w11 * w80 + w38 * w82),
        w11 * w83 + w88 + w38 * w89 + w73 * w90,
        w11 * w91 + w96 - w36 * w67 - w51 * w69 + w38 * w98 + w73 * w99,
        w0 * (w12 * w74 - w28 * w75) + w20 * (w12 * w75 + w28 * w74) - w38 * w100,
        w12 * c12 - c27,
        0.0,
        w28 * c36,
        -(w28 * c25 + w69 * w100),
        -(w38 * w101),
        0.0,
        w12 * c13 - c28,
        0.0,
        -(w28 * c26 + w69 * w101),
        w0 * (w12 * w84 + w28 * w86) - w20 * (w12 * w86 - w28 * w84) - w38 * w102,
        w28 * c43,
        0.0,
        w12 * c15 - c29,
        w103 - w69 * w102,
        w108 - w62 * w69 + w66 * w110,
        w69 * w78 - (w28 * c21 + w77 * w104) + w79 * w110,
        w81 * w110 - (w28 * c23 + w80 * w104 + w69 * w82),
        w103 + w83 * w104 + w69 * w89 + w90 * w110,
        w12 * c18 - c31 + w91 * w104 - w67 * w105 - (w69 * w106 - w54 * w109) + w69 * w98 + w99 * w110,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 5, 5)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 343 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    c = ca.SX.sym("c", 44)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
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
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(rod_theta)
    w2 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w3 = ca.cos(rod_theta)
    w4 = rod_q1 * c10
    w5 = w1 * w2 + w3 * w4
    w6 = c5 + rod_q4 * c6
    w7 = w3 * w6
    w8 = w0 / w7
    w9 = w1 * c6
    w10 = w9 / w7
    w11 = w8 * crank_theta_dot + w10 * rod_q4_dot
    w12 = 2 * w11
    w13 = w8 * w12
    w14 = rod_q3_dot * c8 + rod_q4_dot * c9
    w15 = rod_q1_dot * c10
    w16 = w3 * w14 - w1 * w15
    w17 = 2 * -w8
    w18 = ca.sin(crank_theta) * c1
    w19 = 2 * crank_theta_dot
    w20 = w18 * w19
    w21 = w2 * w3 - w1 * w4
    w22 = rod_q4_dot * c6
    w23 = w3 * w22
    w24 = w1 * w6
    w25 = (w17 * w23 - w13 * w24 - w20) / w7
    w26 = w1 * w14 + w3 * w15
    w27 = w0 * w19
    w28 = w1 * w22
    w29 = (w24 * w25 - (w27 + (w7 * w13 + w17 * w28))) * c3
    w30 = w0 * (w5 * w13 - w16 * w17 + (w20 * c2 + w21 * w25)) - w18 * (w13 * w21 + w17 * w26 - (w5 * w25 - w27 * c2) - w29)
    w31 = rod_q1 * c12
    w32 = rod_q2 * c13
    w33 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w34 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w35 = rod_q1_dot * w31 + w32 * rod_q2_dot + rod_q3_dot * w33 + rod_q4_dot * w34
    w36 = c11 + (rod_q1 * w31 + rod_q2 * w32 + rod_q3 * (c14 + w33) + rod_q4 * (c17 + w34))
    w37 = w24 * w29 - (w35 * (w8 * -2.0) + (w5 * w27 - w20 * w21 - w25 * w36))
    w38 = rod_q3_dot * c20 + rod_q4_dot * c21
    w39 = w1 * c10
    w40 = w3 * c10
    w41 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w42 = rod_q4_dot * c23
    w43 = c22 - rod_q4 * c23
    w44 = rod_q1_dot * c24
    w45 = rod_q1 * c24
    w46 = w3 * c8
    w47 = w1 * c8
    w48 = rod_q1_dot * c25 + rod_q2_dot * c26
    w49 = rod_q1 * c25 + rod_q2 * c26
    w50 = w3 * c9
    w51 = w1 * c9
    w52 = w3 * c6
    w53 = 2 * -w11
    w54 = w11 * -2.0
    w55 = w31 * w54
    w56 = w32 * w54
    w57 = w33 * w54
    w58 = w10 * w12
    w59 = 2 * -w10
    w60 = (w23 * w59 + w52 * w53 - w24 * w58) / w7
    w61 = (w24 * w60 - (w7 * w58 + (w28 * w59 + w9 * w53))) * c3
    w62 = w0 * (w5 * w58 - (w16 * w59 + w50 * w53) + w21 * w60) - w18 * (w21 * w58 + (w26 * w59 + w51 * w53) - w5 * w60 - w61)
    w63 = w24 * w61 - (w35 * (w10 * -2.0) + w34 * w54 - w36 * w60)
    dQ_hat_dq_i_dot = ca.vertcat(
        w30 - w8 * w37,
        w13 * w31 + w17 * w38 - (w27 * w39 - w20 * w40 - w25 * w41),
        w13 * w32 + w17 * w42 + w25 * w43,
        w13 * w33 + w17 * w44 - (w25 * w45 - (w27 * w46 + w20 * w47)),
        w13 * w34 + w17 * w48 - (w25 * w49 - (w27 * w50 + w20 * w51)) - w29 * w52 - w10 * w37,
        w0 * (w39 * w53) - w18 * (w40 * w53) + w8 * w55,
        0.0,
        0.0,
        w53 * c24,
        w53 * c25 + w10 * w55,
        w8 * w56,
        0.0,
        0.0,
        0.0,
        w53 * c26 + w10 * w56,
        w8 * w57 - (w0 * (w46 * w53) + w18 * (w47 * w53)),
        w53 * c20,
        0.0,
        0.0,
        w10 * w57,
        w62 - w8 * w63,
        w31 * w58 + (w38 * w59 + w53 * c21) + w41 * w60,
        w32 * w58 + (w42 * w59 + w53 * c23) + w43 * w60,
        w33 * w58 + w44 * w59 - w45 * w60,
        w34 * w58 + w48 * w59 - w49 * w60 - w52 * w61 - w10 * w63,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 5, 5)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 386 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 5)
    c = ca.SX.sym("c", 44)
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
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c15 = c[15]
    c16 = c[16]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c38 = c[38]
    c39 = c[39]
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.cos(rod_theta)
    w2 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w3 = ca.sin(rod_theta)
    w4 = rod_q1 * c10
    w5 = w1 * w2 - w3 * w4
    w6 = ca.sin(crank_theta) * c1
    w7 = c5 + rod_q4 * c6
    w8 = w1 * w7
    w9 = w6 / w8
    w10 = crank_theta_ddot * w9
    w11 = crank_theta_ddot * w6
    w12 = w11 * c2
    w13 = w0 * crank_theta_ddot
    w14 = w13 * c2
    w15 = w0 / w8
    w16 = w3 * c6
    w17 = w16 / w8
    w18 = crank_theta_ddot * w15 + w17 * rod_q4_ddot
    w19 = w5 * w18
    w20 = w1 * c10
    w21 = w20 * rod_q1_ddot
    w22 = w3 * c8
    w23 = w22 * rod_q3_ddot
    w24 = w3 * c9
    w25 = rod_q4_ddot * w24
    w26 = w2 * w3 + w1 * w4
    w27 = w18 * w26
    w28 = w3 * c10
    w29 = rod_q1_ddot * w28
    w30 = w1 * c8
    w31 = rod_q3_ddot * w30
    w32 = w1 * c9
    w33 = rod_q4_ddot * w32
    w34 = w3 * w7
    w35 = w1 * c6
    w36 = (w18 * w34 - w11 + rod_q4_ddot * w35) * c3
    w37 = (w13 + w10 * w34) * c3
    w38 = w0 * (w5 * w10 - w12) - w6 * (w14 - w19 + w21 + w23 + w25) - (w0 * (w27 - w12 - w29 + w31 + w33 + w36) - w6 * (w14 + w10 * w26 + w37))
    w39 = w13 * w26
    w40 = w5 * w11
    w41 = rod_q1 * c12
    w42 = rod_q2 * c13
    w43 = rod_q3 * c15
    w44 = rod_q4 * c16
    w45 = w44 + (c38 + w43)
    w46 = rod_q3 * c16
    w47 = rod_q4 * c18
    w48 = w47 + (c39 + w46)
    w49 = c11 + (rod_q1 * w41 + rod_q2 * w42 + rod_q3 * w45 + rod_q4 * w48)
    w50 = w39 - w40 + w10 * w49 + w34 * w37
    w51 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w52 = c22 - rod_q4 * c23
    w53 = rod_q1 * c24
    w54 = rod_q1 * c25 + rod_q2 * c26
    w55 = w11 * w26 + w5 * w13 - w18 * w49 + rod_q1_ddot * w51 + w52 * rod_q2_ddot - rod_q3_ddot * w53 - rod_q4_ddot * w54
    w56 = w55 - w34 * w36
    w57 = w15 / w8
    w58 = w34 * w57
    w59 = w17 / w8
    w60 = w35 / w8 + w34 * w59
    w61 = crank_theta_ddot * w58 + rod_q4_ddot * w60
    w62 = (w8 * w18 + w34 * w61 - w16 * rod_q4_ddot) * c3
    w63 = w40 - w39 - w49 * w61 - (w34 * w62 + w8 * w36)
    w64 = w0 * (w33 + (w31 - (w29 + (w5 * w61 - w27)))) - w6 * (w19 + w26 * w61 - w21 - w23 - w25 + w62) - (w15 * w63 + w56 * w58)
    w65 = w13 * w28
    w66 = w11 * w20
    w67 = w66 - w65
    w68 = w67 - w51 * w61
    w69 = w52 * w61
    w70 = w11 * w22 + w13 * w30
    w71 = w70 + w53 * w61
    w72 = w13 * w32 + w11 * w24
    w73 = w16 * w36
    w74 = w72 + w54 * w61 + (w35 * w62 - w73) - (w17 * w63 + w56 * w60)
    w75 = w67 - w18 * (2 * w41) - rod_q3_ddot * c24 - rod_q4_ddot * c25
    w76 = w18 * (2 * w42) + rod_q4_ddot * c26
    w77 = w70 - w18 * (w44 + (w43 + w45)) - rod_q1_ddot * c20
    w78 = w35 * w57
    w79 = w35 * w59
    w80 = crank_theta_ddot * w78 + rod_q4_ddot * w79
    w81 = (w16 * w18 - w34 * w80) * c3
    w82 = w72 - (w18 * (w46 + (w47 + w48)) - w49 * w80) - rod_q1_ddot * c21 - rod_q2_ddot * c23 - (w73 + w34 * w81)
    w83 = w0 * (w18 * w32 - w5 * w80) + w6 * (w18 * w24 - w26 * w80 + w81) + (w15 * w82 - w56 * w78) + w17 * w64
    dMa_dq_i = ca.vertcat(
        w38 - (w15 * w50 - w9 * w56) - w15 * w64,
        w65 - w66 + w10 * w51 - w15 * w68,
        w10 * w52 + w15 * w69,
        -(w70 + w10 * w53 + w15 * w71),
        -(w72 + w10 * w54 + w35 * w37 + w17 * w50 + w15 * w74),
        w0 * (w18 * w28) - w6 * (w18 * w20) - w15 * w75,
        0.0,
        0.0,
        w18 * c24,
        w18 * c25 - w17 * w75,
        w15 * w76,
        0.0,
        0.0,
        0.0,
        w18 * c26 + w17 * w76,
        -(w0 * (w18 * w30) + w6 * (w18 * w22) + w15 * w77),
        w18 * c20,
        0.0,
        0.0,
        -(w17 * w77),
        -w83,
        w18 * c21 + w51 * w80 - w17 * w68,
        w18 * c23 + w52 * w80 + w17 * w69,
        -(w53 * w80 + w17 * w71),
        w35 * w81 - w54 * w80 - (w17 * w82 - w56 * w79) - w17 * w74,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 5, 5)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 316 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 44)
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
    w0 = ca.cos(crank_theta) * c1
    w1 = ca.sin(crank_theta) * c1
    w2 = ca.cos(rod_theta)
    w3 = c5 + rod_q4 * c6
    w4 = w2 * w3
    w5 = w0 / w4
    w6 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w7 = ca.sin(rod_theta)
    w8 = rod_q1 * c10
    w9 = w2 * w6 - w7 * w8
    w10 = w6 * w7 + w2 * w8
    w11 = w3 * w7
    w12 = w11 * c3
    w13 = w0 * w9 + w1 * (w10 + w12)
    w14 = rod_q1 * c12
    w15 = rod_q2 * c13
    w16 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w17 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w18 = c11 + (rod_q1 * w14 + rod_q2 * w15 + rod_q3 * (c14 + w16) + rod_q4 * (c17 + w17))
    w19 = w18 + w11 * w12
    w20 = w2 * c10
    w21 = w7 * c10
    w22 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w23 = w0 * w20 + w1 * w21 - w5 * w22
    w24 = c22 - rod_q4 * c23
    w25 = -(w5 * w24)
    w26 = w7 * c8
    w27 = w2 * c8
    w28 = rod_q1 * c24
    w29 = w0 * w26 - w1 * w27 + w5 * w28
    w30 = w7 * c9
    w31 = w2 * c9
    w32 = w2 * c6
    w33 = w32 * c3
    w34 = rod_q1 * c25 + rod_q2 * c26
    w35 = w34 + w11 * w33
    w36 = w7 * c6 / w4
    w37 = w35 + w19 * w36
    w38 = w0 * w30 - w1 * (w31 + w33) + (w5 * w37 - w13 * w36)
    w39 = -(w22 * w36)
    w40 = -(w24 * w36)
    w41 = c16 + w28 * w36
    w42 = rod_theta_dot**2
    w43 = 2 * rod_theta_dot
    w44 = rod_q3_dot * c8 + rod_q4_dot * c9
    w45 = rod_q1_dot * c10
    w46 = crank_theta_dot**2
    w47 = w1 * w46
    w48 = rod_q4_dot * c6
    w49 = (w43 * (w2 * w48) - w11 * w42 - w47) / w4
    w50 = w0 * w46
    w51 = (w11 * w49 - (w50 + (w4 * w42 + w43 * (w7 * w48)))) * c3
    w52 = w0 * (w10 * w42 - w43 * (w2 * w44 - w7 * w45) + (w47 * c2 + w9 * w49)) - w1 * (w9 * w42 + w43 * (w7 * w44 + w2 * w45) - (w10 * w49 - w50 * c2) - w51)
    w53 = rod_theta_dot * -2.0 * (w14 * rod_q1_dot + w15 * rod_q2_dot + w16 * rod_q3_dot + w17 * rod_q4_dot)
    w54 = w53 - (w10 * w50 - w9 * w47 - w18 * w49) + w11 * w51
    w55 = w14 * w42 + w43 * (rod_q3_dot * c20 + rod_q4_dot * c21) - rod_q1 * c27 - (w21 * w50 - w20 * w47 - w22 * w49)
    w56 = w16 * w42 + w43 * (rod_q1_dot * c24) - (rod_q3 * c29 + rod_q4 * c30) - (w28 * w49 - (w27 * w50 + w26 * w47))
    w57 = w17 * w42 + w43 * (rod_q1_dot * c25 + rod_q2_dot * c26) - (rod_q3 * c30 + rod_q4 * c31) - (w34 * w49 - (w31 * w50 + w30 * w47))
    M_hat_LL = ca.vertcat(
        c0 + w0 * (w0 * c2) + w1 * (w1 * c4) - (w5 * (w13 - w5 * w19) + w5 * w13),
    )
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        w23,
        w25,
        w29,
        w38,
    )
    M_hat_LS = ca.reshape(M_hat_LS, 1, 4)
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        w23,
        w25,
        w29,
        w38,
    )
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c12,
        0.0,
        0.0,
        w39,
        0.0,
        c13,
        0.0,
        w40,
        0.0,
        0.0,
        c15,
        w41,
        w39,
        w40,
        w41,
        c18 + w32 * w33 + (w36 * w37 + w35 * w36),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 4, 4)
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        w52 - w5 * w54,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        w55,
        w15 * w42 + w43 * (rod_q4_dot * c23) - rod_q2 * c28 + w24 * w49,
        w56,
        w57 - w32 * w51 - w36 * w54,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 244 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 44)
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
    c1 = c[1]
    c3 = c[3]
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
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = c5 + rod_q4 * c6
    w3 = w1 * w2
    w4 = w0 * c6 / w3
    w5 = c19 - (rod_q3 * c20 + rod_q4 * c21)
    w6 = -(w4 * w5)
    w7 = c22 - rod_q4 * c23
    w8 = -(w4 * w7)
    w9 = rod_q1 * c24
    w10 = c16 + w4 * w9
    w11 = w1 * c6
    w12 = w11 * c3
    w13 = rod_q1 * c25 + rod_q2 * c26
    w14 = w0 * w2
    w15 = w13 + w12 * w14
    w16 = rod_q1 * c12
    w17 = rod_q2 * c13
    w18 = c14 + (rod_q3 * c15 + rod_q4 * c16)
    w19 = c17 + (rod_q3 * c16 + rod_q4 * c18)
    w20 = c11 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c14 + w18) + rod_q4 * (c17 + w19))
    w21 = rod_theta_dot**2
    w22 = 2 * rod_theta_dot
    w23 = crank_theta_dot**2
    w24 = ca.cos(crank_theta) * c1
    w25 = ca.sin(crank_theta) * c1
    w26 = w23 * w24 + w25 * crank_theta_ddot
    w27 = w23 * w25
    w28 = w24 * crank_theta_ddot - w27
    w29 = rod_q4_dot * c6
    w30 = (w22 * (w1 * w29) - w14 * w21 - w27) / w3 + crank_theta_ddot * (w24 / w3)
    w31 = w16 * w21 + w22 * (rod_q3_dot * c20 + rod_q4_dot * c21) - rod_q1 * c27 - (w0 * c10 * w26 + w1 * c10 * w28 - w5 * w30)
    w32 = w18 * w21 + w22 * (rod_q1_dot * c24) - (rod_q3 * c29 + rod_q4 * c30) - (w28 * (w0 * c8) - w26 * (w1 * c8) + w9 * w30)
    w33 = w19 * w21 + w22 * (rod_q1_dot * c25 + rod_q2_dot * c26) - (rod_q3 * c30 + rod_q4 * c31) - (w28 * (w0 * c9) - w26 * (w1 * c9) + w13 * w30)
    w34 = (w14 * w30 - (w26 + (w3 * w21 + w22 * (w0 * w29)))) * c3
    w35 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w36 = c7 + (rod_q3 * c8 + rod_q4 * c9)
    w37 = rod_q1 * c10
    w38 = w33 - w11 * w34 - w4 * (w35 - (w26 * (w0 * w36 + w1 * w37) + w28 * (w1 * w36 - w0 * w37) - w20 * w30) + w14 * w34)
    M_hat_SS = ca.vertcat(
        c12,
        0.0,
        0.0,
        w6,
        0.0,
        c13,
        0.0,
        w8,
        0.0,
        0.0,
        c15,
        w10,
        w6,
        w8,
        w10,
        c18 + w11 * w12 + (w4 * (w15 + w4 * (w20 + w14 * (w14 * c3))) + w4 * w15),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 4, 4)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w31,
        w17 * w21 + w22 * (rod_q4_dot * c23) - rod_q2 * c28 + w7 * w30,
        w32,
        w38,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 410 operations."""
    p = ca.SX.sym("p", 67)
    crank_tip_x = p[31]
    rod_end_x = p[32]
    rod_end_shape_0_3 = p[33]
    rod_at1_x = p[34]
    rod_at1_shape_0_2 = p[35]
    rod_at1_shape_0_3 = p[36]
    rod_at1_shape_1_0 = p[37]
    rod_at1_shape_1_1 = p[38]
    rod_at2_x = p[39]
    rod_at2_shape_0_2 = p[40]
    rod_at2_shape_0_3 = p[41]
    rod_at2_shape_1_0 = p[42]
    rod_at2_shape_1_1 = p[43]
    rod_at3_x = p[44]
    rod_at3_shape_0_2 = p[45]
    rod_at3_shape_0_3 = p[46]
    rod_at3_shape_1_0 = p[47]
    rod_at3_shape_1_1 = p[48]
    rod_at4_x = p[49]
    rod_at4_shape_0_2 = p[50]
    rod_at4_shape_1_0 = p[51]
    rod_at5_x = p[52]
    rod_at5_shape_0_2 = p[53]
    rod_at5_shape_0_3 = p[54]
    rod_at5_shape_1_0 = p[55]
    rod_at5_shape_1_1 = p[56]
    rod_at6_x = p[57]
    rod_at6_shape_0_2 = p[58]
    rod_at6_shape_0_3 = p[59]
    rod_at6_shape_1_0 = p[60]
    rod_at6_shape_1_1 = p[61]
    rod_at7_x = p[62]
    rod_at7_shape_0_2 = p[63]
    rod_at7_shape_0_3 = p[64]
    rod_at7_shape_1_0 = p[65]
    rod_at7_shape_1_1 = p[66]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        crank_tip_x,
        0.0,
        0.0,
        rod_at1_x,
        0.0,
        0.0,
        rod_at2_x,
        0.0,
        0.0,
        rod_at3_x,
        0.0,
        0.0,
        rod_at4_x,
        0.0,
        0.0,
        rod_at5_x,
        0.0,
        0.0,
        rod_at6_x,
        0.0,
        0.0,
        rod_at7_x,
        0.0,
        0.0,
        rod_end_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 13)
    positions = ca.densify(positions)
    axes = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    axes = ca.reshape(axes, 9, 13)
    axes = ca.densify(axes)
    shapes = ca.vertcat(
        0.0,
        rod_at1_shape_1_0,
        0.0,
        0.0,
        rod_at1_shape_1_1,
        0.0,
        rod_at1_shape_0_2,
        0.0,
        0.0,
        rod_at1_shape_0_3,
        0.0,
        0.0,
        0.0,
        rod_at2_shape_1_0,
        0.0,
        0.0,
        rod_at2_shape_1_1,
        0.0,
        rod_at2_shape_0_2,
        0.0,
        0.0,
        rod_at2_shape_0_3,
        0.0,
        0.0,
        0.0,
        rod_at3_shape_1_0,
        0.0,
        0.0,
        rod_at3_shape_1_1,
        0.0,
        rod_at3_shape_0_2,
        0.0,
        0.0,
        rod_at3_shape_0_3,
        0.0,
        0.0,
        0.0,
        rod_at4_shape_1_0,
        0.0,
        0.0,
        0.0,
        0.0,
        rod_at4_shape_0_2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        rod_at5_shape_1_0,
        0.0,
        0.0,
        rod_at5_shape_1_1,
        0.0,
        rod_at5_shape_0_2,
        0.0,
        0.0,
        rod_at5_shape_0_3,
        0.0,
        0.0,
        0.0,
        rod_at6_shape_1_0,
        0.0,
        0.0,
        rod_at6_shape_1_1,
        0.0,
        rod_at6_shape_0_2,
        0.0,
        0.0,
        rod_at6_shape_0_3,
        0.0,
        0.0,
        0.0,
        rod_at7_shape_1_0,
        0.0,
        0.0,
        rod_at7_shape_1_1,
        0.0,
        rod_at7_shape_0_2,
        0.0,
        0.0,
        rod_at7_shape_0_3,
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
        rod_end_shape_0_3,
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
    )
    shapes = ca.reshape(shapes, 3, 36)
    shapes = ca.densify(shapes)
    turns = ca.vertcat(
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
    )
    turns = ca.reshape(turns, 3, 36)
    turns = ca.densify(turns)
    inputs, outputs = [p], [positions, axes, shapes, turns]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes", "shapes", "turns"])


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
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
