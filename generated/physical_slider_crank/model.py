"""Flexible slider-crank, crank prescribed, physical axial mass: equations of motion, emitted by symgen from the scene `physical_slider_crank`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 96 operations."""
    p = ca.SX.sym("p", 68)
    omega = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    rod_mass = p[4]
    rod_first_moment_x = p[5]
    rod_inertia = p[6]
    rod_phi_integral_0_2 = p[7]
    rod_phi_integral_0_3 = p[8]
    rod_phi_integral_1_0 = p[9]
    rod_rho_dot_phi_2_0 = p[10]
    rod_rho_dot_phi_3_0 = p[11]
    rod_rho_cross_phi_0_0 = p[12]
    rod_rho_cross_phi_1_0 = p[13]
    rod_M_ff_0_0 = p[14]
    rod_M_ff_1_1 = p[15]
    rod_M_ff_2_2 = p[16]
    rod_M_ff_2_3 = p[17]
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
    rod_K_ff_3_3 = p[29]
    slider_mass = p[30]
    slider_inertia = p[31]
    crank_tip_x = p[32]
    rod_end_x = p[33]
    rod_end_shape_0_3 = p[34]
    c = ca.vertcat(
        rod_M_ff_0_0,
        rod_end_shape_0_3,
        rod_end_x,
        rod_rho_cross_phi_0_0,
        rod_phi_cross_phi_0_2,
        rod_phi_cross_phi_0_3,
        rod_M_ff_1_1,
        rod_rho_cross_phi_1_0,
        rod_phi_cross_phi_1_3,
        rod_M_ff_2_2,
        rod_M_ff_2_3,
        rod_phi_cross_phi_2_0,
        rod_M_ff_3_3,
        slider_mass,
        rod_phi_cross_phi_3_0,
        rod_phi_cross_phi_3_1,
        rod_inertia,
        rod_rho_dot_phi_2_0,
        rod_rho_dot_phi_3_0,
        rod_K_ff_0_0,
        rod_phi_integral_1_0,
        crank_tip_x,
        rod_K_ff_1_1,
        rod_K_ff_2_2,
        rod_K_ff_2_3,
        rod_phi_integral_0_2,
        rod_K_ff_3_3,
        rod_phi_integral_0_3,
        rod_first_moment_x,
        omega,
        crank_tip_x * omega,
        -rod_end_shape_0_3,
        -omega,
        crank_mass,
        crank_mass * crank_center_of_mass_x,
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        rod_mass,
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
    """M_hat and Q_hat (Eq. 38). 236 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
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
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = c2 + rod_q4 * c1
    w3 = w1 * w2
    w4 = w0 * c1 / w3
    w5 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w6 = -(w4 * w5)
    w7 = c7 - rod_q4 * c8
    w8 = -(w4 * w7)
    w9 = rod_q1 * c11
    w10 = c10 + w4 * w9
    w11 = w1 * c1
    w12 = w11 * c13
    w13 = rod_q1 * c14 + rod_q2 * c15
    w14 = w0 * w2
    w15 = w13 + w12 * w14
    w16 = rod_q1 * c0
    w17 = rod_q2 * c6
    w18 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w19 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w20 = c16 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c17 + w18) + rod_q4 * (c18 + w19))
    w21 = rod_theta_dot**2
    w22 = 2 * rod_theta_dot
    w23 = crank_theta_dot**2
    w24 = w23 * (ca.cos(crank_theta) * c21)
    w25 = w23 * (ca.sin(crank_theta) * c21)
    w26 = rod_q4_dot * c1
    w27 = (w22 * (w1 * w26) - w14 * w21 - w25) / w3
    w28 = w16 * w21 + w22 * (rod_q3_dot * c4 + rod_q4_dot * c5) - rod_q1 * c19 - (w0 * c20 * w24 - w1 * c20 * w25 - w5 * w27)
    w29 = w18 * w21 + w22 * (rod_q1_dot * c11) - (rod_q3 * c23 + rod_q4 * c24) - (w9 * w27 - (w24 * (w1 * c25) + w25 * (w0 * c25)))
    w30 = w19 * w21 + w22 * (rod_q1_dot * c14 + rod_q2_dot * c15) - (rod_q3 * c24 + rod_q4 * c26) - (w13 * w27 - (w24 * (w1 * c27) + w25 * (w0 * c27)))
    w31 = (w14 * w27 - (w24 + (w3 * w21 + w22 * (w0 * w26)))) * c13
    w32 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w33 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w34 = rod_q1 * c20
    w35 = w30 - w11 * w31 - w4 * (w32 - (w24 * (w0 * w33 + w1 * w34) - w25 * (w1 * w33 - w0 * w34) - w20 * w27) + w14 * w31)
    M_hat = ca.vertcat(
        c0,
        0.0,
        0.0,
        w6,
        0.0,
        c6,
        0.0,
        w8,
        0.0,
        0.0,
        c9,
        w10,
        w6,
        w8,
        w10,
        c12 + w11 * w12 + (w4 * (w15 + w4 * (w20 + w14 * (w14 * c13))) + w4 * w15),
    )
    M_hat = ca.reshape(M_hat, 4, 4)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w28,
        w17 * w21 + w22 * (rod_q4_dot * c8) - rod_q2 * c22 + w7 * w27,
        w29,
        w35,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 38 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 46)
    rod_q4 = q_i[3]
    rod_theta = q_d[5]
    c1 = c[1]
    c2 = c[2]
    c21 = c[21]
    c29 = c[29]
    w0 = t * c29
    w1 = ca.cos(w0) * c21
    w2 = ca.sin(w0) * c21
    w3 = c2 + rod_q4 * c1
    w4 = w2 + ca.sin(rod_theta) * w3
    w5 = w3 * ca.cos(rod_theta)
    w6 = rod_theta - w4 / w5
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w2,
        w6,
        w1 + w3 * ca.cos(w6),
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w4,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        -w5,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, t, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "t", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 40 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 46)
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q4_dot = q_i_dot[3]
    c1 = c[1]
    c2 = c[2]
    c29 = c[29]
    c30 = c[30]
    w0 = ca.sin(crank_theta) * c30
    w1 = ca.cos(crank_theta) * c30
    w2 = ca.cos(rod_theta)
    w3 = c2 + rod_q4 * c1
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w1 / w4 + w5 * c1 / w4 * rod_q4_dot
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        c29,
        -w0,
        w1,
        -w6,
        w6 * (w3 * w5) - w0 + rod_q4_dot * (w2 * c1),
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 59 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 46)
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_q4_ddot = q_i_ddot[3]
    c1 = c[1]
    c2 = c[2]
    c21 = c[21]
    w0 = crank_theta_dot**2
    w1 = w0 * (ca.cos(crank_theta) * c21)
    w2 = w0 * (ca.sin(crank_theta) * c21)
    w3 = 2 * rod_theta_dot
    w4 = ca.cos(rod_theta)
    w5 = rod_q4_dot * c1
    w6 = rod_theta_dot**2
    w7 = ca.sin(rod_theta)
    w8 = c2 + rod_q4 * c1
    w9 = w7 * w8
    w10 = w4 * w8
    w11 = (w3 * (w4 * w5) - w6 * w9 - w2) / w10 + w7 * c1 / w10 * rod_q4_ddot
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        -w1,
        -w2,
        -w11,
        w9 * w11 - (w1 + (w6 * w10 + w3 * (w5 * w7))) + rod_q4_ddot * (w4 * c1),
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 217 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 46)
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
    c2 = c[2]
    c21 = c[21]
    c29 = c[29]
    c31 = c[31]
    c32 = c[32]
    w0 = ca.cos(crank_theta) * c21
    w1 = ca.sin(crank_theta) * c21
    w2 = ca.cos(rod_theta)
    w3 = c2 + rod_q4 * c1
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = w3 * w5
    w7 = crank_theta_dot**2
    w8 = rod_theta_dot**2
    w9 = 2 * rod_theta_dot
    w10 = rod_q4_dot * c1
    C = ca.vertcat(
        crank_x,
        crank_y,
        rod_x - (crank_x + w0),
        rod_y - (crank_y + w1),
        slider_y,
        slider_theta,
        slider_x - (rod_x + w4),
        slider_y - (rod_y + w6),
        crank_theta - t * c29,
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
        0.0,
        w1,
        -w0,
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
        -1.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        w2 * c31,
        w5 * c31,
        0.0,
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
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 9, 13)
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
        c32,
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
        c29,
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
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, t, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "t", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 698 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 46)
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
    c31 = c[31]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    w0 = ca.sin(crank_theta)
    w1 = w0 * c34
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c34
    w5 = ca.sin(rod_theta)
    w6 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w7 = ca.cos(rod_theta)
    w8 = rod_q1 * c20
    w9 = w5 * w6 + w7 * w8
    w10 = -w9
    w11 = w5 * c37
    w12 = w7 * c25
    w13 = w7 * c27
    w14 = w6 * w7 - w5 * w8
    w15 = w7 * c20
    w16 = w5 * c25
    w17 = w5 * c27
    w18 = rod_q1 * c0
    w19 = rod_q2 * c6
    w20 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w21 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w22 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w23 = c7 - rod_q4 * c8
    w24 = rod_q1 * c38
    w25 = -(rod_q1 * c14 + rod_q2 * c15)
    w26 = crank_theta_dot**2
    w27 = w4 * w26
    w28 = w1 * w26
    w29 = rod_theta_dot**2
    w30 = 2 * rod_theta_dot
    w31 = rod_q3_dot * c25 + rod_q4_dot * c27
    w32 = rod_q1_dot * c20
    w33 = w14 * w29 + w30 * (w5 * w31 + w7 * w32)
    w34 = w9 * w29 - w30 * (w7 * w31 - w5 * w32)
    w35 = rod_theta_dot * -2.0 * (w18 * rod_q1_dot + w19 * rod_q2_dot + w20 * rod_q3_dot + w21 * rod_q4_dot)
    w36 = w18 * w29 + w30 * (rod_q3_dot * c4 + rod_q4_dot * c5)
    w37 = w19 * w29 + w30 * (rod_q4_dot * c8)
    w38 = w20 * w29 + w30 * (rod_q1_dot * c11)
    w39 = w21 * w29 + w30 * (rod_q1_dot * c14 + rod_q2_dot * c15)
    w40 = w0 * c21
    w41 = w3 * c21
    w42 = c2 + rod_q4 * c1
    w43 = w5 * w42
    w44 = w7 * w42
    w45 = rod_q4_dot * c1
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
        c35,
        0.0,
        0.0,
        0.0,
        0.0,
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
        c36,
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
        c16 + (rod_q1 * w18 + rod_q2 * w19 + rod_q3 * (c17 + w20) + rod_q4 * (c18 + w21)),
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
        w23,
        0.0,
        c6,
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
        c9,
        c10,
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
        c10,
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
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c39,
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
        c19,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c22,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c23,
        c24,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c24,
        c26,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w36 - rod_q1 * c19,
        w37 - rod_q2 * c22,
        w38 - (rod_q3 * c23 + rod_q4 * c24),
        w39 - (rod_q3 * c24 + rod_q4 * c26),
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
        0.0,
        w40,
        -w41,
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
        -1.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        w7 * c31,
        w5 * c31,
        0.0,
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
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 9, 13)
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
        0.0,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 240 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    q_ddot = ca.SX.sym("q_ddot", 13)
    c = ca.SX.sym("c", 46)
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
    c20 = c[20]
    c21 = c[21]
    c25 = c[25]
    c27 = c[27]
    c28 = c[28]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c39 = c[39]
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta)
    w2 = w1 * c34
    w3 = ca.sin(crank_theta)
    w4 = w3 * c34
    w5 = rod_theta_dot**2
    w6 = ca.cos(rod_theta)
    w7 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w8 = ca.sin(rod_theta)
    w9 = rod_q1 * c20
    w10 = w6 * w7 - w8 * w9
    w11 = 2 * rod_theta_dot
    w12 = rod_q3_dot * c25 + rod_q4_dot * c27
    w13 = rod_q1_dot * c20
    w14 = w7 * w8 + w6 * w9
    w15 = rod_x_ddot * c36 - w14 * rod_theta_ddot - w8 * c20 * rod_q1_ddot + w6 * c25 * rod_q3_ddot + w6 * c27 * rod_q4_ddot
    w16 = slider_x_ddot * c13
    w17 = w5 * w10 + w11 * (w8 * w12 + w6 * w13) - w15 - w16
    w18 = w0 * w2 - (crank_x_ddot * c33 - w4 * crank_theta_ddot) + w17
    w19 = rod_y_ddot * c36 + w10 * rod_theta_ddot + rod_q1_ddot * (w6 * c20) + rod_q3_ddot * (w8 * c25) + rod_q4_ddot * (w8 * c27)
    w20 = rod_q1 * c0
    w21 = rod_q2 * c6
    w22 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w23 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w24 = rod_theta_dot * -2.0 * (rod_q1_dot * w20 + w21 * rod_q2_dot + rod_q3_dot * w22 + rod_q4_dot * w23)
    w25 = rod_theta_ddot * (c16 + (rod_q1 * w20 + rod_q2 * w21 + rod_q3 * (c17 + w22) + rod_q4 * (c18 + w23)))
    w26 = w10 * rod_y_ddot - rod_x_ddot * w14 + w25 + rod_q1_ddot * (c3 - (rod_q3 * c4 + rod_q4 * c5)) + (c7 - rod_q4 * c8) * rod_q2_ddot
    w27 = c2 + rod_q4 * c1
    w28 = w24 - (w26 - rod_q3_ddot * (rod_q1 * c11) - rod_q4_ddot * (rod_q1 * c14 + rod_q2 * c15)) + w16 * (w8 * w27)
    w29 = w28 / (w6 * w27)
    w30 = w5 * w14 - w11 * (w6 * w12 - w8 * w13) - w19 - w29
    w31 = w0 * w4 - (crank_y_ddot * c33 + w2 * crank_theta_ddot) + w30
    w32 = w29 - slider_y_ddot * c13
    w33 = slider_theta_ddot * c39
    w34 = w30 * (w1 * c21) - (w2 * crank_y_ddot - crank_x_ddot * w4 + crank_theta_ddot * c35) - w17 * (w3 * c21)
    lam = ca.vertcat(
        w18,
        w31,
        w17,
        w30,
        w32,
        -w33,
        -w16,
        -w29,
        w34,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w18,
        -w31,
        0.0,
        -w17,
        -w30,
        0.0,
        0.0,
        -w32,
        w33,
        w16,
        w29,
        0.0,
        0.0,
        0.0,
        -w34,
    )
    joint_forces = ca.reshape(joint_forces, 3, 5)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 222 operations."""
    q = ca.SX.sym("q", 13)
    q_dot = ca.SX.sym("q_dot", 13)
    c = ca.SX.sym("c", 46)
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
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c23 = c[23]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    w0 = ca.sin(crank_theta) * c34
    w1 = ca.cos(crank_theta) * c34
    w2 = crank_x_dot * (crank_x_dot * c33 - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * c33 + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta)
    w4 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w5 = ca.cos(rod_theta)
    w6 = rod_q1 * c20
    w7 = w3 * w4 + w5 * w6
    w8 = w3 * c20
    w9 = w5 * c25
    w10 = w5 * c27
    w11 = rod_x_dot * (rod_x_dot * c36 - w7 * rod_theta_dot - w8 * rod_q1_dot + w9 * rod_q3_dot + w10 * rod_q4_dot)
    w12 = w4 * w5 - w3 * w6
    w13 = w5 * c20
    w14 = w3 * c25
    w15 = w3 * c27
    w16 = rod_y_dot * (rod_y_dot * c36 + rod_theta_dot * w12 + rod_q1_dot * w13 + rod_q3_dot * w14 + rod_q4_dot * w15)
    w17 = rod_q1 * (rod_q1 * c0) + rod_q2 * (rod_q2 * c6) + rod_q3 * (rod_q4 * c10 + (rod_q3 * c9 + c40)) + rod_q4 * (rod_q4 * c12 + (rod_q3 * c10 + c41))
    w18 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w19 = c7 - rod_q4 * c8
    w20 = rod_y_dot * w12 - rod_x_dot * w7 + rod_theta_dot * (c16 + w17) + rod_q1_dot * w18 + w19 * rod_q2_dot
    w21 = rod_q1 * c11
    w22 = rod_q1 * c14 + rod_q2 * c15
    w23 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c35) + w11 + w16 + rod_theta_dot * (w20 - rod_q3_dot * w21 - rod_q4_dot * w22)
    w24 = w23 + rod_q1_dot * (rod_y_dot * w13 - rod_x_dot * w8 + rod_theta_dot * w18 + rod_q1_dot * c0) + rod_q2_dot * (rod_theta_dot * w19 + rod_q2_dot * c6)
    w25 = rod_q3_dot * (rod_x_dot * w9 + rod_y_dot * w14 - rod_theta_dot * w21 + rod_q3_dot * c9 + rod_q4_dot * c10)
    w26 = rod_q4_dot * (rod_q3_dot * c10 + rod_x_dot * w10 + rod_y_dot * w15 - rod_theta_dot * w22 + rod_q4_dot * c12)
    w27 = w24 + w25 + w26 + slider_x_dot * (slider_x_dot * c13) + slider_y_dot * (slider_y_dot * c13) + slider_theta_dot * (slider_theta_dot * c39)
    w28 = rod_q3 * (rod_q3 * c23) + (rod_q2 * (rod_q2 * c22) + (rod_q1 * (rod_q1 * c19) + rod_q3 * rod_q4 * c42))
    kinetic = ca.vertcat(
        w27 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (w28 + rod_q4 * (rod_q4 * c26)) / 2.0,
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
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 363 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
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
    c38 = c[38]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    w0 = rod_theta_dot**2
    w1 = 2 * rod_theta_dot
    w2 = ca.cos(rod_theta)
    w3 = rod_q4_dot * c1
    w4 = w2 * w3
    w5 = ca.sin(rod_theta)
    w6 = c2 + rod_q4 * c1
    w7 = w5 * w6
    w8 = w1 * w4 - w0 * w7
    w9 = crank_theta_dot**2
    w10 = w9 * (ca.sin(crank_theta) * c21)
    w11 = w8 - w10
    w12 = w2 * w6
    w13 = w11 / w12
    w14 = w5 * c1
    w15 = w14 / w12
    w16 = rod_theta_dot * -2.0
    w17 = ca.cos(crank_theta) * c21
    w18 = w9 * w17
    w19 = w18 * (w2 * c20) + w10 * (w5 * c20)
    w20 = rod_q1 * c0
    w21 = rod_q2 * c6
    w22 = w0 * c10 - c24
    w23 = w18 * (w5 * c25)
    w24 = w10 * (w2 * c25)
    w25 = rod_q3 * c9
    w26 = rod_q4 * c10
    w27 = c17 + (w25 + w26)
    w28 = c17 + w27
    w29 = w22 - w15 * (w16 * (rod_q3_dot * c9 + rod_q4_dot * c10) - (w23 - w24 - w13 * (w26 + (w25 + w28))))
    w30 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w31 = w13 / w12
    w32 = w3 * w5
    w33 = w1 * w32 + w0 * w12
    w34 = w7 * w31 - w33 / w12
    w35 = w2 * c1
    w36 = w0 * w14 / w12 + w31 * w35
    w37 = (2 * w4 - w1 * w7) / w12
    w38 = w17 * c29 / w12 / w12
    w39 = w15 / w12
    w40 = w35 * w39
    w41 = w35 / w12 + w7 * w39
    w42 = w35 * w38 + rod_q4_dot * w40 + w15 * (w7 * w38 + rod_q4_dot * w41)
    w43 = w15 * (w19 - w30 * w34) - (w13 * c5 + w30 * w36) + (w1 * w20 + 2 * (rod_q3_dot * c4 + rod_q4_dot * c5) + w30 * w37) * w42
    w44 = c7 - rod_q4 * c8
    w45 = rod_q1 * c11
    w46 = w22 + w36 * w45 + w15 * (w34 * w45 - (w24 - w23)) + w42 * (w1 * w27 + rod_q1_dot * c44 - w37 * w45)
    w47 = rod_q1 * c14 + rod_q2 * c15
    w48 = (w13 * w14 - w7 * w36 - w0 * w35) * c13
    w49 = w18 * (w5 * c27)
    w50 = w10 * (w2 * c27)
    w51 = rod_q3 * c10
    w52 = rod_q4 * c12
    w53 = c18 + (w51 + w52)
    w54 = c18 + w53
    w55 = c16 + (rod_q1 * w20 + rod_q2 * w21 + rod_q3 * w28 + rod_q4 * w54)
    w56 = w16 * (rod_q3_dot * c10 + rod_q4_dot * c12) - (w49 - w50 - (w13 * (w51 + (w52 + w54)) - w36 * w55))
    w57 = (w7 * w13 - (w18 + w33)) * c13
    w58 = w14 * w57
    w59 = rod_q1_dot * w20 + rod_q2_dot * w21 + rod_q3_dot * w27 + rod_q4_dot * w53
    w60 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w61 = rod_q1 * c20
    w62 = w5 * w60 + w2 * w61
    w63 = w2 * w60 - w5 * w61
    w64 = w16 * w59 - (w18 * w62 - w10 * w63 - w13 * w55) + w7 * w57
    w65 = (w11 + w7 * w34 - w8) * c13
    w66 = w34 * w47 - (w50 - w49) + (w35 * w65 - w58) + (w15 * (w7 * w65 + w12 * w57 - (w18 * w63 + w10 * w62 - w34 * w55)) + w41 * w64)
    w67 = w0 * c12 - c26 + w36 * w47 - w35 * w48 - (w15 * (w56 + (w7 * w48 + w58)) - w40 * w64) + w15 * w66
    w68 = (w7 * w37 - (w1 * w12 + 2 * w32)) * c13
    w69 = w1 * w53 + 2 * (rod_q1_dot * c14 + rod_q2_dot * c15) - w37 * w47 - w35 * w68 - w15 * (w59 * -2.0 + w37 * w55 + w7 * w68)
    dQ_hat_dq_i = ca.vertcat(
        w0 * c0 - c19,
        0.0,
        w13 * c38,
        -(w13 * c14 + w15 * (w16 * (rod_q1_dot * c0) - (w19 - w13 * (2 * w20)))),
        0.0,
        w0 * c6 - c22,
        0.0,
        -(w13 * c15 + w15 * (w16 * (rod_q2_dot * c6) + w13 * (2 * w21))),
        w13 * c45,
        0.0,
        w0 * c9 - c23,
        w29,
        w43,
        w42 * (w1 * w21 + rod_q4_dot * c43 + w37 * w44) - (w13 * c8 + w36 * w44 + w15 * (w34 * w44)),
        w46,
        w67 + w42 * w69,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 4, 4)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 179 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
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
    c30 = c[30]
    w0 = ca.cos(rod_theta)
    w1 = c2 + rod_q4 * c1
    w2 = w0 * w1
    w3 = ca.sin(rod_theta)
    w4 = w3 * c1
    w5 = w4 / w2
    w6 = ca.cos(crank_theta) * c30 / w2 + w5 * rod_q4_dot
    w7 = 2 * -w6
    w8 = w6 * -2.0
    w9 = rod_q1 * c0
    w10 = rod_q2 * c6
    w11 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w12 = w5 * (2 * w6)
    w13 = 2 * -w5
    w14 = rod_q4_dot * c1
    w15 = w0 * c1
    w16 = w1 * w3
    w17 = (w13 * (w0 * w14) + w7 * w15 - w12 * w16) / w2
    w18 = w9 * w12 + ((rod_q3_dot * c4 + rod_q4_dot * c5) * w13 + w7 * c5) + (c3 - (rod_q3 * c4 + rod_q4 * c5)) * w17
    w19 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w20 = (w16 * w17 - (w2 * w12 + (w13 * (w3 * w14) + w4 * w7))) * c13
    w21 = w12 * w19 + w13 * (rod_q1_dot * c14 + rod_q2_dot * c15) - w17 * (rod_q1 * c14 + rod_q2 * c15) - w15 * w20
    w22 = (w9 * rod_q1_dot + w10 * rod_q2_dot + w11 * rod_q3_dot + rod_q4_dot * w19) * (w5 * -2.0) + w8 * w19
    w23 = w16 * w20 - (w22 - w17 * (c16 + (rod_q1 * w9 + rod_q2 * w10 + rod_q3 * (c17 + w11) + rod_q4 * (c18 + w19))))
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
        0.0,
        w7 * c11,
        w7 * c14 + w5 * (w8 * w9),
        0.0,
        0.0,
        0.0,
        w7 * c15 + w5 * (w8 * w10),
        w7 * c4,
        0.0,
        0.0,
        w5 * (w8 * w11),
        w18,
        w10 * w12 + (w13 * (rod_q4_dot * c8) + w7 * c8) + w17 * (c7 - rod_q4 * c8),
        w11 * w12 + w13 * (rod_q1_dot * c11) - w17 * (rod_q1 * c11),
        w21 - w5 * w23,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 4, 4)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 191 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    rod_theta = q_d[5]
    rod_q1_ddot = q_i_ddot[0]
    rod_q2_ddot = q_i_ddot[1]
    rod_q3_ddot = q_i_ddot[2]
    rod_q4_ddot = q_i_ddot[3]
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
    c40 = c[40]
    c41 = c[41]
    w0 = ca.sin(rod_theta)
    w1 = w0 * c1
    w2 = ca.cos(rod_theta)
    w3 = c2 + rod_q4 * c1
    w4 = w2 * w3
    w5 = w1 / w4
    w6 = w5 * rod_q4_ddot
    w7 = rod_q1 * c0
    w8 = rod_q2 * c6
    w9 = rod_q3 * c9
    w10 = rod_q4 * c10
    w11 = w10 + (c40 + w9)
    w12 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w13 = w5 / w4
    w14 = w2 * c1
    w15 = w13 * w14
    w16 = rod_q4_ddot * w15
    w17 = w0 * w3
    w18 = w14 / w4 + w13 * w17
    w19 = rod_q4_ddot * w18
    w20 = c7 - rod_q4 * c8
    w21 = rod_q1 * c11
    w22 = (w1 * w6 - w16 * w17) * c13
    w23 = rod_q1 * c14 + rod_q2 * c15
    w24 = rod_q3 * c10
    w25 = rod_q4 * c12
    w26 = w25 + (c41 + w24)
    w27 = c16 + (rod_q1 * w7 + rod_q2 * w8 + rod_q3 * w11 + rod_q4 * w26)
    w28 = (w6 * w17 + rod_q4_ddot * w14) * c13
    w29 = w1 * w28
    w30 = w5 * (rod_q1_ddot * c5 + (w6 * (w24 + (w25 + w26)) - w16 * w27) + rod_q2_ddot * c8 + (w17 * w22 + w29))
    w31 = rod_q1_ddot * w12 - w6 * w27 + w20 * rod_q2_ddot - rod_q3_ddot * w21 - rod_q4_ddot * w23 - w17 * w28
    w32 = (w4 * w6 + w17 * w19 - w1 * rod_q4_ddot) * c13
    w33 = w14 * w22 - w16 * w23 + (w30 + w15 * w31) - w5 * (w19 * w23 + (w14 * w32 - w29) - (w18 * w31 - w5 * (w19 * w27 + (w17 * w32 + w4 * w28))))
    dMa_dq_i = ca.vertcat(
        0.0,
        0.0,
        w6 * c11,
        w6 * c14 + w5 * (w6 * (2 * w7) + rod_q3_ddot * c11 + rod_q4_ddot * c14),
        0.0,
        0.0,
        0.0,
        w6 * c15 + w5 * (w6 * (2 * w8) + rod_q4_ddot * c15),
        w6 * c4,
        0.0,
        0.0,
        w5 * (rod_q1_ddot * c4 + w6 * (w10 + (w9 + w11))),
        w6 * c5 + w12 * w16 + w5 * (w12 * w19),
        w6 * c8 + w16 * w20 + w5 * (w19 * w20),
        -(w16 * w21 + w5 * (w19 * w21)),
        w33,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 4, 4)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 236 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
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
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = c2 + rod_q4 * c1
    w3 = w1 * w2
    w4 = w0 * c1 / w3
    w5 = c3 - (rod_q3 * c4 + rod_q4 * c5)
    w6 = -(w4 * w5)
    w7 = c7 - rod_q4 * c8
    w8 = -(w4 * w7)
    w9 = rod_q1 * c11
    w10 = c10 + w4 * w9
    w11 = w1 * c1
    w12 = w11 * c13
    w13 = rod_q1 * c14 + rod_q2 * c15
    w14 = w0 * w2
    w15 = w13 + w12 * w14
    w16 = rod_q1 * c0
    w17 = rod_q2 * c6
    w18 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w19 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w20 = c16 + (rod_q1 * w16 + rod_q2 * w17 + rod_q3 * (c17 + w18) + rod_q4 * (c18 + w19))
    w21 = rod_theta_dot**2
    w22 = 2 * rod_theta_dot
    w23 = crank_theta_dot**2
    w24 = w23 * (ca.cos(crank_theta) * c21)
    w25 = w23 * (ca.sin(crank_theta) * c21)
    w26 = rod_q4_dot * c1
    w27 = (w22 * (w1 * w26) - w14 * w21 - w25) / w3
    w28 = w16 * w21 + w22 * (rod_q3_dot * c4 + rod_q4_dot * c5) - rod_q1 * c19 - (w0 * c20 * w24 - w1 * c20 * w25 - w5 * w27)
    w29 = w18 * w21 + w22 * (rod_q1_dot * c11) - (rod_q3 * c23 + rod_q4 * c24) - (w9 * w27 - (w24 * (w1 * c25) + w25 * (w0 * c25)))
    w30 = w19 * w21 + w22 * (rod_q1_dot * c14 + rod_q2_dot * c15) - (rod_q3 * c24 + rod_q4 * c26) - (w13 * w27 - (w24 * (w1 * c27) + w25 * (w0 * c27)))
    w31 = (w14 * w27 - (w24 + (w3 * w21 + w22 * (w0 * w26)))) * c13
    w32 = rod_theta_dot * -2.0 * (w16 * rod_q1_dot + w17 * rod_q2_dot + w18 * rod_q3_dot + w19 * rod_q4_dot)
    w33 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w34 = rod_q1 * c20
    w35 = w30 - w11 * w31 - w4 * (w32 - (w24 * (w0 * w33 + w1 * w34) - w25 * (w1 * w33 - w0 * w34) - w20 * w27) + w14 * w31)
    M_hat_LL = ca.vertcat(
        c0,
        0.0,
        0.0,
        c6,
    )
    M_hat_LL = ca.reshape(M_hat_LL, 2, 2)
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        0.0,
        0.0,
        w6,
        w8,
    )
    M_hat_LS = ca.reshape(M_hat_LS, 2, 2)
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        0.0,
        w6,
        0.0,
        w8,
    )
    M_hat_SL = ca.reshape(M_hat_SL, 2, 2)
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c9,
        w10,
        w10,
        c12 + w11 * w12 + (w4 * (w15 + w4 * (w20 + w14 * (w14 * c13))) + w4 * w15),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 2, 2)
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        w28,
        w17 * w21 + w22 * (rod_q4_dot * c8) - rod_q2 * c22 + w7 * w27,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        w29,
        w35,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 197 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d = ca.SX.sym("q_d", 9)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 9)
    q_L_ddot = ca.SX.sym("q_L_ddot", 2)
    c = ca.SX.sym("c", 46)
    rod_q1 = q_i[0]
    rod_q2 = q_i[1]
    rod_q3 = q_i[2]
    rod_q4 = q_i[3]
    crank_theta = q_d[2]
    rod_theta = q_d[5]
    rod_q1_dot = q_i_dot[0]
    rod_q2_dot = q_i_dot[1]
    rod_q3_dot = q_i_dot[2]
    rod_q4_dot = q_i_dot[3]
    crank_theta_dot = q_d_dot[2]
    rod_theta_dot = q_d_dot[5]
    rod_q1_ddot = q_L_ddot[0]
    rod_q2_ddot = q_L_ddot[1]
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
    c20 = c[20]
    c21 = c[21]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    w0 = ca.sin(rod_theta)
    w1 = ca.cos(rod_theta)
    w2 = c2 + rod_q4 * c1
    w3 = w1 * w2
    w4 = w0 * c1 / w3
    w5 = rod_q1 * c11
    w6 = c10 + w4 * w5
    w7 = w1 * c1
    w8 = w7 * c13
    w9 = rod_q1 * c14 + rod_q2 * c15
    w10 = w0 * w2
    w11 = w9 + w8 * w10
    w12 = rod_q1 * c0
    w13 = rod_q2 * c6
    w14 = c17 + (rod_q3 * c9 + rod_q4 * c10)
    w15 = c18 + (rod_q3 * c10 + rod_q4 * c12)
    w16 = c16 + (rod_q1 * w12 + rod_q2 * w13 + rod_q3 * (c17 + w14) + rod_q4 * (c18 + w15))
    w17 = rod_theta_dot**2
    w18 = 2 * rod_theta_dot
    w19 = rod_q4_dot * c1
    w20 = crank_theta_dot**2
    w21 = w20 * (ca.sin(crank_theta) * c21)
    w22 = (w18 * (w1 * w19) - w10 * w17 - w21) / w3
    w23 = w20 * (ca.cos(crank_theta) * c21)
    w24 = w14 * w17 + w18 * (rod_q1_dot * c11) - (rod_q3 * c23 + rod_q4 * c24) - (w5 * w22 - (w1 * c25 * w23 + w21 * (w0 * c25)))
    w25 = w15 * w17 + w18 * (rod_q1_dot * c14 + rod_q2_dot * c15) - (rod_q3 * c24 + rod_q4 * c26) - (w9 * w22 - (w23 * (w1 * c27) + w21 * (w0 * c27)))
    w26 = (w10 * w22 - (w23 + (w3 * w17 + w18 * (w0 * w19)))) * c13
    w27 = rod_theta_dot * -2.0 * (w12 * rod_q1_dot + w13 * rod_q2_dot + w14 * rod_q3_dot + w15 * rod_q4_dot)
    w28 = c28 + (rod_q3 * c25 + rod_q4 * c27)
    w29 = rod_q1 * c20
    w30 = w23 * (w0 * w28 + w1 * w29) - w21 * (w1 * w28 - w0 * w29) - w16 * w22 + (c3 - (rod_q3 * c4 + rod_q4 * c5)) * rod_q1_ddot
    M_hat_SS = ca.vertcat(
        c9,
        w6,
        w6,
        c12 + w7 * w8 + (w4 * (w11 + w4 * (w16 + w10 * (w10 * c13))) + w4 * w11),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 2, 2)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w24,
        w25 - w7 * w26 - w4 * (w27 - (w30 + (c7 - rod_q4 * c8) * rod_q2_ddot) + w10 * w26),
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 410 operations."""
    p = ca.SX.sym("p", 68)
    crank_tip_x = p[32]
    rod_end_x = p[33]
    rod_end_shape_0_3 = p[34]
    rod_at1_x = p[35]
    rod_at1_shape_0_2 = p[36]
    rod_at1_shape_0_3 = p[37]
    rod_at1_shape_1_0 = p[38]
    rod_at1_shape_1_1 = p[39]
    rod_at2_x = p[40]
    rod_at2_shape_0_2 = p[41]
    rod_at2_shape_0_3 = p[42]
    rod_at2_shape_1_0 = p[43]
    rod_at2_shape_1_1 = p[44]
    rod_at3_x = p[45]
    rod_at3_shape_0_2 = p[46]
    rod_at3_shape_0_3 = p[47]
    rod_at3_shape_1_0 = p[48]
    rod_at3_shape_1_1 = p[49]
    rod_at4_x = p[50]
    rod_at4_shape_0_2 = p[51]
    rod_at4_shape_1_0 = p[52]
    rod_at5_x = p[53]
    rod_at5_shape_0_2 = p[54]
    rod_at5_shape_0_3 = p[55]
    rod_at5_shape_1_0 = p[56]
    rod_at5_shape_1_1 = p[57]
    rod_at6_x = p[58]
    rod_at6_shape_0_2 = p[59]
    rod_at6_shape_0_3 = p[60]
    rod_at6_shape_1_0 = p[61]
    rod_at6_shape_1_1 = p[62]
    rod_at7_x = p[63]
    rod_at7_shape_0_2 = p[64]
    rod_at7_shape_0_3 = p[65]
    rod_at7_shape_1_0 = p[66]
    rod_at7_shape_1_1 = p[67]
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
