"""2 four-bar windows side by side: equations of motion, emitted by symgen from the scene `n_four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 94 operations."""
    p = ca.SX.sym("p", 18)
    gravity_y = p[0]
    upright0_mass = p[1]
    upright0_center_of_mass_x = p[2]
    top1_mass = p[3]
    top1_center_of_mass_x = p[4]
    upright1_mass = p[5]
    upright1_center_of_mass_x = p[6]
    top2_mass = p[7]
    top2_center_of_mass_x = p[8]
    upright2_mass = p[9]
    upright2_center_of_mass_x = p[10]
    upright0_tip_x = p[11]
    top1_tip_x = p[12]
    upright1_tip_x = p[13]
    ground_foot1_x = p[14]
    top2_tip_x = p[15]
    upright2_tip_x = p[16]
    ground_foot2_x = p[17]
    w0 = 0.08333333333333333 + upright0_mass * upright0_center_of_mass_x**2
    w1 = 0.08333333333333333 + upright1_mass * upright1_center_of_mass_x**2
    w2 = 0.08333333333333333 + upright2_mass * upright2_center_of_mass_x**2
    w3 = top2_mass * top2_center_of_mass_x
    w4 = top1_mass * top1_center_of_mass_x
    w5 = upright0_mass * upright0_center_of_mass_x
    w6 = upright1_mass * upright1_center_of_mass_x
    w7 = upright2_mass * upright2_center_of_mass_x
    c = ca.vertcat(
        upright0_tip_x,
        top1_mass,
        w0 + upright0_tip_x * (upright0_tip_x * top1_mass),
        top1_tip_x,
        upright1_tip_x,
        w1,
        top2_mass,
        w1 + upright1_tip_x * (upright1_tip_x * top2_mass),
        top2_tip_x,
        upright2_tip_x,
        w2,
        w3,
        0.08333333333333333 + top2_mass * top2_center_of_mass_x**2,
        w4,
        0.08333333333333333 + top1_mass * top1_center_of_mass_x**2,
        gravity_y,
        w5 * gravity_y,
        top1_mass * gravity_y,
        gravity_y * w6,
        top2_mass * gravity_y,
        gravity_y * w7,
        ground_foot1_x,
        ground_foot2_x,
        upright0_mass,
        w0,
        upright1_mass,
        upright2_mass,
        w5,
        w6,
        w7,
        upright0_mass * gravity_y,
        upright1_mass * gravity_y,
        upright2_mass * gravity_y,
        w4 * (upright0_tip_x + upright0_tip_x),
        w2 + w2,
        w3 * (upright1_tip_x + upright1_tip_x),
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 209 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    top1_theta_dot = q_d_dot[4]
    upright1_theta_dot = q_d_dot[7]
    top2_theta_dot = q_d_dot[10]
    upright2_theta_dot = q_d_dot[13]
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
    w0 = ca.cos(upright0_theta)
    w1 = w0 * c0
    w2 = ca.sin(upright0_theta) * c0
    w3 = ca.sin(top1_theta)
    w4 = w3 * c3
    w5 = ca.cos(top1_theta)
    w6 = w5 * c3
    w7 = ca.cos(upright1_theta)
    w8 = w7 * c4
    w9 = ca.sin(upright1_theta) * c4
    w10 = w4 * w8 - w6 * w9
    w11 = (w1 * w4 - w2 * w6) / w10
    w12 = ca.sin(top2_theta)
    w13 = w12 * c8
    w14 = ca.cos(top2_theta)
    w15 = w14 * c8
    w16 = ca.cos(upright2_theta)
    w17 = w16 * c9
    w18 = ca.sin(upright2_theta) * c9
    w19 = w13 * w17 - w15 * w18
    w20 = (w8 * w13 - w9 * w15) / w19
    w21 = (w8 * w18 - w9 * w17) / w19
    w22 = w14 * c11
    w23 = w12 * c11
    w24 = w8 * w22 + w9 * w23
    w25 = (w1 * w9 - w2 * w8) / w10
    w26 = w5 * c13
    w27 = w3 * c13
    w28 = w1 * w26 + w2 * w27
    w29 = c2 + w11 * (w11 * (c7 + w20 * (w20 * c10) + (w21 * (w24 + w21 * c12) + w21 * w24))) + (w25 * (w28 + w25 * c14) + w25 * w28)
    w30 = top1_theta_dot**2
    w31 = upright1_theta_dot**2
    w32 = w8 * w31
    w33 = upright0_theta_dot**2
    w34 = w1 * w33
    w35 = w32 - w6 * w30 - w34
    w36 = w9 * w31
    w37 = w2 * w33
    w38 = w36 - w4 * w30 - w37
    w39 = (w8 * w35 + w9 * w38) / w10
    w40 = w0 * c16 + w1 * (w27 * w30 + c17 - (w26 * w39 - w37 * c1)) - w2 * (w26 * w30 + (w34 * c1 + w27 * w39))
    w41 = (w6 * w35 + w4 * w38) / w10
    w42 = top2_theta_dot**2
    w43 = w8 * w41 - w36
    w44 = upright2_theta_dot**2
    w45 = w17 * w44 - w15 * w42 - w32
    w46 = w18 * w44 - w13 * w42 - w36
    w47 = (w17 * w45 + w18 * w46) / w19 + w21 * w41
    w48 = w32 + w9 * w41
    w49 = w7 * c18 - w41 * c5 + w8 * (w23 * w42 + c19 - (w43 * c6 + w22 * w47)) - w9 * (w22 * w42 + (w48 * c6 + w23 * w47))
    w50 = w49 + w20 * (w16 * c20 - ((w15 * w45 + w13 * w46) / w19 + w20 * w41) * c10) + w21 * (w22 * c15 - (w23 * w48 + w22 * w43 + w47 * c12))
    M_hat = ca.vertcat(
        w29,
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w40 + w11 * w50 + w25 * (w26 * c15 - (w27 * w34 - w26 * w37 + w39 * c14)),
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 98 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c8 = c[8]
    c9 = c[9]
    c21 = c[21]
    c22 = c[22]
    w0 = ca.cos(upright0_theta) * c0
    w1 = ca.sin(upright0_theta) * c0
    w2 = ca.cos(upright1_theta) * c4
    w3 = w2 + c21
    w4 = ca.cos(top1_theta) * c3
    w5 = w3 - (w0 + w4)
    w6 = ca.sin(upright1_theta) * c4
    w7 = ca.sin(top1_theta) * c3
    w8 = w6 - (w1 + w7)
    w9 = w2 * w7 - w4 * w6
    w10 = (w4 * w5 + w7 * w8) / w9
    w11 = upright1_theta - w10
    w12 = ca.cos(upright2_theta) * c9
    w13 = ca.cos(top2_theta) * c8
    w14 = w12 + c22 - (w3 + w13)
    w15 = w14 - w6 * w10
    w16 = ca.sin(upright2_theta) * c9
    w17 = ca.sin(top2_theta) * c8
    w18 = w16 - (w6 + w17)
    w19 = w18 + w2 * w10
    w20 = w12 * w17 - w13 * w16
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        top1_theta - (w2 * w5 + w6 * w8) / w9,
        c21,
        0.0,
        w11,
        c21 + ca.cos(w11) * c4,
        ca.sin(w11) * c4,
        top2_theta - (w12 * w15 + w16 * w19) / w20,
        c22,
        0.0,
        upright2_theta - (w13 * w15 + w17 * w19) / w20,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        w5,
        w8,
        w14,
        w18,
    )
    C_loop = ca.densify(C_loop)
    det_loop = ca.vertcat(
        w9,
        w20,
    )
    det_loop = ca.densify(det_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop, det_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 78 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c8 = c[8]
    c9 = c[9]
    w0 = ca.sin(upright0_theta) * c0
    w1 = ca.cos(upright0_theta) * c0
    w2 = ca.sin(upright1_theta) * c4
    w3 = ca.cos(upright1_theta) * c4
    w4 = ca.sin(top1_theta) * c3
    w5 = ca.cos(top1_theta) * c3
    w6 = w3 * w4 - w2 * w5
    w7 = upright0_theta_dot * ((w1 * w4 - w0 * w5) / w6)
    w8 = ca.sin(upright2_theta) * c9
    w9 = ca.cos(upright2_theta) * c9
    w10 = ca.sin(top2_theta) * c8
    w11 = ca.cos(top2_theta) * c8
    w12 = w9 * w10 - w8 * w11
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -(w0 * upright0_theta_dot),
        upright0_theta_dot * w1,
        upright0_theta_dot * ((w1 * w2 - w0 * w3) / w6),
        0.0,
        0.0,
        w7,
        -(w2 * w7),
        w3 * w7,
        w7 * ((w3 * w8 - w2 * w9) / w12),
        0.0,
        0.0,
        w7 * ((w3 * w10 - w2 * w11) / w12),
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 130 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    top1_theta_dot = q_d_dot[4]
    upright1_theta_dot = q_d_dot[7]
    top2_theta_dot = q_d_dot[10]
    upright2_theta_dot = q_d_dot[13]
    upright0_theta_ddot = q_i_ddot[0]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c8 = c[8]
    c9 = c[9]
    w0 = upright0_theta_dot**2
    w1 = ca.cos(upright0_theta) * c0
    w2 = w0 * w1
    w3 = ca.sin(upright0_theta) * c0
    w4 = w0 * w3
    w5 = ca.cos(upright1_theta) * c4
    w6 = upright1_theta_dot**2
    w7 = w5 * w6
    w8 = top1_theta_dot**2
    w9 = ca.cos(top1_theta) * c3
    w10 = w7 - w8 * w9 - w2
    w11 = ca.sin(upright1_theta) * c4
    w12 = w6 * w11
    w13 = ca.sin(top1_theta) * c3
    w14 = w12 - w8 * w13 - w4
    w15 = w5 * w13 - w9 * w11
    w16 = (w9 * w10 + w13 * w14) / w15 + upright0_theta_ddot * ((w1 * w13 - w3 * w9) / w15)
    w17 = ca.cos(upright2_theta) * c9
    w18 = upright2_theta_dot**2
    w19 = top2_theta_dot**2
    w20 = ca.cos(top2_theta) * c8
    w21 = w17 * w18 - w19 * w20 - w7
    w22 = ca.sin(upright2_theta) * c9
    w23 = ca.sin(top2_theta) * c8
    w24 = w18 * w22 - w19 * w23 - w12
    w25 = w17 * w23 - w20 * w22
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -(w2 + w3 * upright0_theta_ddot),
        w1 * upright0_theta_ddot - w4,
        (w5 * w10 + w11 * w14) / w15 + upright0_theta_ddot * ((w1 * w11 - w3 * w5) / w15),
        0.0,
        0.0,
        w16,
        -(w7 + w11 * w16),
        w5 * w16 - w12,
        (w17 * w21 + w22 * w24) / w25 + w16 * ((w5 * w22 - w11 * w17) / w25),
        0.0,
        0.0,
        (w20 * w21 + w23 * w24) / w25 + w16 * ((w5 * w23 - w11 * w20) / w25),
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 365 operations."""
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 36)
    upright0_x = q[0]
    upright0_y = q[1]
    upright0_theta = q[2]
    top1_x = q[3]
    top1_y = q[4]
    top1_theta = q[5]
    upright1_x = q[6]
    upright1_y = q[7]
    upright1_theta = q[8]
    top2_x = q[9]
    top2_y = q[10]
    top2_theta = q[11]
    upright2_x = q[12]
    upright2_y = q[13]
    upright2_theta = q[14]
    upright0_theta_dot = q_dot[2]
    top1_theta_dot = q_dot[5]
    upright1_theta_dot = q_dot[8]
    top2_theta_dot = q_dot[11]
    upright2_theta_dot = q_dot[14]
    c0 = c[0]
    c3 = c[3]
    c4 = c[4]
    c8 = c[8]
    c9 = c[9]
    c21 = c[21]
    c22 = c[22]
    w0 = ca.cos(upright0_theta) * c0
    w1 = ca.sin(upright0_theta) * c0
    w2 = ca.cos(upright1_theta) * c4
    w3 = upright1_x + w2
    w4 = ca.cos(top1_theta) * c3
    w5 = ca.sin(upright1_theta) * c4
    w6 = upright1_y + w5
    w7 = ca.sin(top1_theta) * c3
    w8 = ca.cos(upright2_theta) * c9
    w9 = ca.cos(top2_theta) * c8
    w10 = ca.sin(upright2_theta) * c9
    w11 = ca.sin(top2_theta) * c8
    w12 = upright0_theta_dot**2
    w13 = upright1_theta_dot**2
    w14 = w2 * w13
    w15 = top1_theta_dot**2
    w16 = w5 * w13
    w17 = upright2_theta_dot**2
    w18 = top2_theta_dot**2
    C = ca.vertcat(
        upright0_x,
        upright0_y,
        top1_x - (upright0_x + w0),
        top1_y - (upright0_y + w1),
        w3 - (top1_x + w4),
        w6 - (top1_y + w7),
        upright1_x - c21,
        upright1_y,
        top2_x - w3,
        top2_y - w6,
        upright2_x + w8 - (top2_x + w9),
        upright2_y + w10 - (top2_y + w11),
        upright2_x - c22,
        upright2_y,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w7,
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
        1.0,
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
        0.0,
        0.0,
        0.0,
        1.0,
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
        0.0,
        -w5,
        w2,
        0.0,
        0.0,
        w5,
        -w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w11,
        -w9,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w10,
        w8,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 14, 15)
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
        -(w0 * w12),
        -(w1 * w12),
        w14 - w4 * w15,
        w16 - w7 * w15,
        0.0,
        0.0,
        -w14,
        -w16,
        w8 * w17 - w9 * w18,
        w10 * w17 - w11 * w18,
        0.0,
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 842 operations."""
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 36)
    upright0_theta = q[2]
    top1_theta = q[5]
    upright1_theta = q[8]
    top2_theta = q[11]
    upright2_theta = q[14]
    upright0_theta_dot = q_dot[2]
    top1_theta_dot = q_dot[5]
    upright1_theta_dot = q_dot[8]
    top2_theta_dot = q_dot[11]
    upright2_theta_dot = q_dot[14]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c19 = c[19]
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
    w0 = ca.sin(upright0_theta)
    w1 = w0 * c27
    w2 = -w1
    w3 = ca.cos(upright0_theta)
    w4 = w3 * c27
    w5 = ca.sin(top1_theta)
    w6 = w5 * c13
    w7 = -w6
    w8 = ca.cos(top1_theta)
    w9 = w8 * c13
    w10 = ca.sin(upright1_theta)
    w11 = w10 * c28
    w12 = -w11
    w13 = ca.cos(upright1_theta)
    w14 = w13 * c28
    w15 = ca.sin(top2_theta)
    w16 = w15 * c11
    w17 = -w16
    w18 = ca.cos(top2_theta)
    w19 = w18 * c11
    w20 = ca.sin(upright2_theta)
    w21 = w20 * c29
    w22 = -w21
    w23 = ca.cos(upright2_theta)
    w24 = w23 * c29
    w25 = upright0_theta_dot**2
    w26 = w4 * w25
    w27 = w1 * w25
    w28 = top1_theta_dot**2
    w29 = w9 * w28
    w30 = w6 * w28
    w31 = upright1_theta_dot**2
    w32 = w14 * w31
    w33 = w11 * w31
    w34 = top2_theta_dot**2
    w35 = w19 * w34
    w36 = w16 * w34
    w37 = upright2_theta_dot**2
    w38 = w24 * w37
    w39 = w21 * w37
    w40 = w4 * c15
    w41 = w9 * c15
    w42 = w14 * c15
    w43 = w19 * c15
    w44 = w24 * c15
    w45 = w0 * c0
    w46 = w3 * c0
    w47 = w5 * c3
    w48 = w8 * c3
    w49 = w10 * c4
    w50 = w13 * c4
    w51 = w15 * c8
    w52 = w18 * c8
    w53 = w20 * c9
    w54 = w23 * c9
    w55 = w31 * w50
    w56 = w31 * w49
    M = ca.vertcat(
        c23,
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
        0.0,
        0.0,
        c23,
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
        0.0,
        0.0,
        w2,
        w4,
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
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        0.0,
        w7,
        0.0,
        0.0,
        0.0,
        0.0,
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
        w9,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w7,
        w9,
        c14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c25,
        0.0,
        w12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c25,
        w14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w14,
        c5,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c6,
        0.0,
        w17,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c6,
        w19,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w17,
        w19,
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
        0.0,
        0.0,
        c26,
        0.0,
        w22,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c26,
        w24,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w22,
        w24,
        c10,
    )
    M = ca.reshape(M, 15, 15)
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
    K = ca.reshape(K, 15, 15)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w26,
        w27,
        0.0,
        w29,
        w30,
        0.0,
        w32,
        w33,
        0.0,
        w35,
        w36,
        0.0,
        w38,
        w39,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c30,
        w40,
        0.0,
        c17,
        w41,
        0.0,
        c31,
        w42,
        0.0,
        c19,
        w43,
        0.0,
        c32,
        w44,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w26,
        w27 + c30,
        w40,
        w29,
        c17 + w30,
        w41,
        w32,
        w33 + c31,
        w42,
        w35,
        c19 + w36,
        w43,
        w38,
        w39 + c32,
        w44,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w45,
        -w46,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w47,
        -w48,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
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
        0.0,
        0.0,
        0.0,
        1.0,
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
        0.0,
        -w49,
        w50,
        0.0,
        0.0,
        w49,
        -w50,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w51,
        -w52,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -w53,
        w54,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 14, 15)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w25 * w46),
        -(w25 * w45),
        w55 - w28 * w48,
        w56 - w28 * w47,
        0.0,
        0.0,
        -w55,
        -w56,
        w37 * w54 - w34 * w52,
        w37 * w53 - w34 * w51,
        0.0,
        0.0,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 257 operations."""
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    q_ddot = ca.SX.sym("q_ddot", 15)
    c = ca.SX.sym("c", 36)
    upright0_theta = q[2]
    top1_theta = q[5]
    upright1_theta = q[8]
    top2_theta = q[11]
    upright2_theta = q[14]
    upright0_theta_dot = q_dot[2]
    top1_theta_dot = q_dot[5]
    upright1_theta_dot = q_dot[8]
    top2_theta_dot = q_dot[11]
    upright2_theta_dot = q_dot[14]
    upright0_x_ddot = q_ddot[0]
    upright0_y_ddot = q_ddot[1]
    upright0_theta_ddot = q_ddot[2]
    top1_x_ddot = q_ddot[3]
    top1_y_ddot = q_ddot[4]
    top1_theta_ddot = q_ddot[5]
    upright1_x_ddot = q_ddot[6]
    upright1_y_ddot = q_ddot[7]
    upright1_theta_ddot = q_ddot[8]
    top2_x_ddot = q_ddot[9]
    top2_y_ddot = q_ddot[10]
    top2_theta_ddot = q_ddot[11]
    upright2_x_ddot = q_ddot[12]
    upright2_y_ddot = q_ddot[13]
    upright2_theta_ddot = q_ddot[14]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c19 = c[19]
    c23 = c[23]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    w0 = upright0_theta_dot**2
    w1 = ca.cos(upright0_theta) * c27
    w2 = ca.sin(upright0_theta) * c27
    w3 = top1_theta_dot**2
    w4 = ca.cos(top1_theta)
    w5 = w4 * c13
    w6 = ca.sin(top1_theta)
    w7 = w6 * c13
    w8 = ca.cos(upright1_theta)
    w9 = w8 * c4
    w10 = w5 * c15 - (w5 * top1_y_ddot - top1_x_ddot * w7 + top1_theta_ddot * c14)
    w11 = w4 * c3
    w12 = w8 * c28
    w13 = ca.sin(upright1_theta)
    w14 = w13 * c28
    w15 = top2_theta_dot**2
    w16 = ca.sin(top2_theta)
    w17 = w16 * c11
    w18 = ca.cos(top2_theta)
    w19 = w18 * c11
    w20 = c19 + w15 * w17 - (top2_y_ddot * c6 + w19 * top2_theta_ddot)
    w21 = w12 * c15 - (w12 * upright1_y_ddot - w14 * upright1_x_ddot + upright1_theta_ddot * c5) + w9 * w20
    w22 = w13 * c4
    w23 = w15 * w19 - (top2_x_ddot * c6 - w17 * top2_theta_ddot)
    w24 = ca.cos(upright2_theta)
    w25 = w24 * c9
    w26 = w19 * c15 - (top2_y_ddot * w19 - w17 * top2_x_ddot + top2_theta_ddot * c12)
    w27 = w18 * c8
    w28 = w24 * c29
    w29 = ca.sin(upright2_theta)
    w30 = w29 * c29
    w31 = w28 * c15 - (w28 * upright2_y_ddot - w30 * upright2_x_ddot + upright2_theta_ddot * c10)
    w32 = w16 * c8
    w33 = w29 * c9
    w34 = w25 * w32 - w27 * w33
    w35 = (w25 * w26 + w27 * w31) / w34
    w36 = (w26 * w33 + w31 * w32) / w34
    w37 = w21 - w22 * w23 - w22 * w35 + w9 * w36
    w38 = w6 * c3
    w39 = w9 * w38 - w11 * w22
    w40 = (w9 * w10 + w11 * w37) / w39
    w41 = w3 * w5 - (top1_x_ddot * c1 - w7 * top1_theta_ddot) + w40
    w42 = w0 * w1 - (upright0_x_ddot * c23 - w2 * upright0_theta_ddot) + w41
    w43 = (w10 * w22 + w37 * w38) / w39
    w44 = c17 + w3 * w7 - (top1_y_ddot * c1 + w5 * top1_theta_ddot) + w43
    w45 = c30 + w0 * w2 - (upright0_y_ddot * c23 + w1 * upright0_theta_ddot) + w44
    w46 = upright1_theta_dot**2
    w47 = w23 + w35
    w48 = w12 * w46 - (upright1_x_ddot * c25 - w14 * upright1_theta_ddot) - w40 + w47
    w49 = w20 + w36
    w50 = c31 + w14 * w46 - (upright1_y_ddot * c25 + w12 * upright1_theta_ddot) - w43 + w49
    w51 = upright2_theta_dot**2
    w52 = w28 * w51 - (upright2_x_ddot * c26 - w30 * upright2_theta_ddot) - w35
    w53 = c32 + w30 * w51 - (upright2_y_ddot * c26 + w28 * upright2_theta_ddot) - w36
    lam = ca.vertcat(
        w42,
        w45,
        w41,
        w44,
        w40,
        w43,
        w48,
        w50,
        w47,
        w49,
        w35,
        w36,
        w52,
        w53,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w42,
        -w45,
        0.0,
        -w41,
        -w44,
        0.0,
        -w40,
        -w43,
        0.0,
        -w48,
        -w50,
        0.0,
        -w47,
        -w49,
        0.0,
        -w35,
        -w36,
        0.0,
        -w52,
        -w53,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 7)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 173 operations."""
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 36)
    upright0_y = q[1]
    upright0_theta = q[2]
    top1_y = q[4]
    top1_theta = q[5]
    upright1_y = q[7]
    upright1_theta = q[8]
    top2_y = q[10]
    top2_theta = q[11]
    upright2_y = q[13]
    upright2_theta = q[14]
    upright0_x_dot = q_dot[0]
    upright0_y_dot = q_dot[1]
    upright0_theta_dot = q_dot[2]
    top1_x_dot = q_dot[3]
    top1_y_dot = q_dot[4]
    top1_theta_dot = q_dot[5]
    upright1_x_dot = q_dot[6]
    upright1_y_dot = q_dot[7]
    upright1_theta_dot = q_dot[8]
    top2_x_dot = q_dot[9]
    top2_y_dot = q_dot[10]
    top2_theta_dot = q_dot[11]
    upright2_x_dot = q_dot[12]
    upright2_y_dot = q_dot[13]
    upright2_theta_dot = q_dot[14]
    c1 = c[1]
    c5 = c[5]
    c6 = c[6]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    w0 = ca.sin(upright0_theta) * c27
    w1 = ca.cos(upright0_theta) * c27
    w2 = upright0_x_dot * (upright0_x_dot * c23 - w0 * upright0_theta_dot) + upright0_y_dot * (upright0_y_dot * c23 + upright0_theta_dot * w1)
    w3 = ca.sin(top1_theta) * c13
    w4 = w2 + upright0_theta_dot * (upright0_y_dot * w1 - upright0_x_dot * w0 + upright0_theta_dot * c24) + top1_x_dot * (top1_x_dot * c1 - w3 * top1_theta_dot)
    w5 = ca.cos(top1_theta) * c13
    w6 = w4 + top1_y_dot * (top1_y_dot * c1 + top1_theta_dot * w5) + top1_theta_dot * (top1_y_dot * w5 - top1_x_dot * w3 + top1_theta_dot * c14)
    w7 = ca.sin(upright1_theta) * c28
    w8 = ca.cos(upright1_theta) * c28
    w9 = w6 + upright1_x_dot * (upright1_x_dot * c25 - w7 * upright1_theta_dot) + upright1_y_dot * (upright1_y_dot * c25 + upright1_theta_dot * w8)
    w10 = ca.sin(top2_theta) * c11
    w11 = w9 + upright1_theta_dot * (upright1_y_dot * w8 - upright1_x_dot * w7 + upright1_theta_dot * c5) + top2_x_dot * (top2_x_dot * c6 - w10 * top2_theta_dot)
    w12 = ca.cos(top2_theta) * c11
    w13 = w11 + top2_y_dot * (top2_y_dot * c6 + top2_theta_dot * w12) + top2_theta_dot * (top2_y_dot * w12 - top2_x_dot * w10 + top2_theta_dot * c12)
    w14 = ca.sin(upright2_theta) * c29
    w15 = ca.cos(upright2_theta) * c29
    w16 = w13 + upright2_x_dot * (upright2_x_dot * c26 - w14 * upright2_theta_dot) + upright2_y_dot * (upright2_y_dot * c26 + upright2_theta_dot * w15)
    w17 = w16 + upright2_theta_dot * (upright2_y_dot * w15 - upright2_x_dot * w14 + upright2_theta_dot * c10)
    w18 = (w0 + upright0_y * c23) * c15 + (w3 + top1_y * c1) * c15 + (w7 + upright1_y * c25) * c15 + (w10 + top2_y * c6) * c15
    kinetic = ca.vertcat(
        w17 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(w18 + (w14 + upright2_y * c26) * c15),
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
    """Origin and rotation matrix of each body, for pictures. 92 operations."""
    q = ca.SX.sym("q", 15)
    upright0_x = q[0]
    upright0_y = q[1]
    upright0_theta = q[2]
    top1_x = q[3]
    top1_y = q[4]
    top1_theta = q[5]
    upright1_x = q[6]
    upright1_y = q[7]
    upright1_theta = q[8]
    top2_x = q[9]
    top2_y = q[10]
    top2_theta = q[11]
    upright2_x = q[12]
    upright2_y = q[13]
    upright2_theta = q[14]
    w0 = ca.cos(upright0_theta)
    w1 = ca.sin(upright0_theta)
    w2 = ca.cos(top1_theta)
    w3 = ca.sin(top1_theta)
    w4 = ca.cos(upright1_theta)
    w5 = ca.sin(upright1_theta)
    w6 = ca.cos(top2_theta)
    w7 = ca.sin(top2_theta)
    w8 = ca.cos(upright2_theta)
    w9 = ca.sin(upright2_theta)
    poses = ca.vertcat(
        upright0_x,
        upright0_y,
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
        top1_x,
        top1_y,
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
        upright1_x,
        upright1_y,
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
        top2_x,
        top2_y,
        0.0,
        w6,
        w7,
        0.0,
        -w7,
        w6,
        0.0,
        0.0,
        0.0,
        1.0,
        upright2_x,
        upright2_y,
        0.0,
        w8,
        w9,
        0.0,
        -w9,
        w8,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    poses = ca.reshape(poses, 12, 5)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 563 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    top1_theta_dot = q_d_dot[4]
    upright1_theta_dot = q_d_dot[7]
    top2_theta_dot = q_d_dot[10]
    upright2_theta_dot = q_d_dot[13]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
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
    w0 = ca.cos(top1_theta)
    w1 = ca.cos(upright0_theta) * c0
    w2 = ca.cos(upright1_theta)
    w3 = w0 * c3
    w4 = upright1_theta_dot**2
    w5 = w2 * c4
    w6 = w4 * w5
    w7 = top1_theta_dot**2
    w8 = upright0_theta_dot**2
    w9 = w1 * w8
    w10 = w6 - w3 * w7 - w9
    w11 = ca.sin(top1_theta)
    w12 = w11 * c3
    w13 = ca.sin(upright1_theta)
    w14 = w13 * c4
    w15 = w4 * w14
    w16 = ca.sin(upright0_theta)
    w17 = w16 * c0
    w18 = w8 * w17
    w19 = w15 - w7 * w12 - w18
    w20 = w5 * w12 - w3 * w14
    w21 = (w3 * w10 + w12 * w19) / w20
    w22 = top2_theta_dot**2
    w23 = ca.sin(top2_theta)
    w24 = w23 * c11
    w25 = w5 * w21 - w15
    w26 = ca.cos(top2_theta)
    w27 = w26 * c11
    w28 = ca.cos(upright2_theta)
    w29 = w28 * c9
    w30 = upright2_theta_dot**2
    w31 = w26 * c8
    w32 = w29 * w30 - w22 * w31 - w6
    w33 = ca.sin(upright2_theta)
    w34 = w33 * c9
    w35 = w23 * c8
    w36 = w30 * w34 - w22 * w35 - w15
    w37 = w29 * w35 - w31 * w34
    w38 = (w29 * w32 + w34 * w36) / w37
    w39 = (w5 * w34 - w14 * w29) / w37
    w40 = w38 + w21 * w39
    w41 = c19 + w22 * w24 - (w25 * c6 + w27 * w40)
    w42 = w6 + w14 * w21
    w43 = w22 * w27 + (w42 * c6 + w24 * w40)
    w44 = (w31 * w32 + w35 * w36) / w37
    w45 = (w5 * w35 - w14 * w31) / w37
    w46 = w28 * c20 - (w44 + w21 * w45) * c10
    w47 = w27 * c15 - (w24 * w42 + w25 * w27 + w40 * c12)
    w48 = w2 * c18 - w21 * c5 + w5 * w41 - w14 * w43 + w45 * w46 + w39 * w47
    w49 = w48 / w20
    w50 = (w1 * w12 - w3 * w17) / w20
    w51 = w45 * w50
    w52 = w51 * c10
    w53 = w39 * w50
    w54 = w14 * w50
    w55 = w24 * w53 + w54 * c6
    w56 = w5 * w50
    w57 = w53 * c12 + w24 * w54 + w27 * w56
    w58 = w27 * w53 + w56 * c6
    w59 = w45 * w52 + w14 * w55 + w39 * w57 + w5 * w58 + w50 * c5
    w60 = w59 / w20
    w61 = (w1 * w14 - w5 * w17) / w20
    w62 = w61 / w20
    w63 = w0 * c13
    w64 = w11 * c13
    w65 = (w5 * w10 + w14 * w19) / w20
    w66 = w63 * c15 - (w9 * w64 - w18 * w63 + w65 * c14)
    w67 = w50 / w20
    w68 = w61 * c14 + w17 * w64 + w1 * w63
    w69 = w59 * (w21 / w20) - (w62 * w66 + w48 * w67) + w65 / w20 * w68
    w70 = w68 / w20
    w71 = w12 * w60 + w14 * w70
    w72 = w0 * ((w1 * w49 - w19 * w60 + w5 * w69 + w7 * w71) * c3 + (w1 * w7 - (w9 * w61 + w17 * w65)) * c13)
    w73 = w3 * w60 + w5 * w70
    w74 = (w7 * w73 - (w17 * w49 + w10 * w60 + w14 * w69)) * c3 + (w18 * w61 + w61 * c15 - w7 * w17 - w1 * w65) * c13
    w75 = w66 / w20
    w76 = w46 * w50 - w21 * w52
    w77 = w76 / w37
    w78 = w47 * w50 - w21 * w57
    w79 = w78 / w37
    w80 = w52 / w37
    w81 = w57 / w37
    w82 = w35 * w80 + w34 * w81
    w83 = w58 + w82 - w71
    w84 = (w1 * w75 - w31 * w77 - w43 * w50 - w21 * w55 - w29 * w79 - w3 * w69 - w19 * w70 + w4 * w83) * c4
    w85 = w31 * w80 + w29 * w81
    w86 = w85 - w55 - w73
    w87 = (w35 * w77 - w17 * w75 + w41 * w50 + w34 * w79 - w21 * w58 + w12 * w69 - w10 * w70 + w4 * w86) * c4
    w88 = w45 / w37
    w89 = w39 / w37
    w90 = w52 * (w44 / w37) - w76 * w88 - w78 * w89 + w57 * (w38 / w37)
    w91 = (w5 * w77 - w36 * w80 + w29 * w90 + w22 * w82) * c8 + (w22 * w56 - (w42 * w53 + w40 * w54)) * c11
    w92 = (w22 * w85 - (w14 * w77 + w32 * w80 + w34 * w90)) * c8 + (w53 * c15 - w25 * w53 - w22 * w54 - w40 * w56) * c11
    w93 = w61 * (w72 - w11 * w74) + w50 * (w2 * w84 - w13 * (w50 * c18 + w87)) + w53 * (w26 * w91 - w23 * w92)
    w94 = w28 * ((w5 * w79 - w31 * w90 - w36 * w81 - w30 * w82) * c9) - w33 * (w51 * c20 + (w35 * w90 - w14 * w79 - w32 * w81 - w30 * w85) * c9)
    w95 = (w5 * w18 - w9 * w14) / w20
    w96 = w9 * c1
    w97 = w18 * c1
    w98 = w16 * c16 + (w1 * (w63 * w95 - w96) + w17 * (c17 + w7 * w64 - (w63 * w65 - w97))) + (w17 * (w64 * w95 - w97) + w1 * (w7 * w63 + (w96 + w64 * w65)))
    w99 = (w3 * w18 - w9 * w12) / w20
    w100 = w5 * w99
    w101 = w39 * w99
    w102 = w14 * w99
    w103 = w99 * c5 + w5 * (w100 * c6 + w27 * w101) + w14 * (w102 * c6 + w24 * w101) + w45 * (w45 * w99 * c10)
    w104 = (w12 * w17 + w1 * w3) / w20
    w105 = (w14 * w17 + w1 * w5) / w20
    w106 = w98 + (w50 * (w103 + w39 * (w24 * w102 + w27 * w100 + w101 * c12)) + w48 * w104) + (w61 * (w95 * c14 - (w18 * w64 + w9 * w63)) + w66 * w105)
    w107 = 2 * top1_theta_dot
    w108 = w12 * w14 + w3 * w5
    w109 = w62 * w108
    w110 = w50 * (upright0_theta_dot * (w105 + w109)) - w61 * (upright0_theta_dot * w109) - upright0_theta_dot * w105
    w111 = w67 * w108
    w112 = upright0_theta_dot * (w104 - w111)
    w113 = upright0_theta_dot * w111
    w114 = upright0_theta_dot * w104
    w115 = (w107 * (w12 * w71 + w3 * w73) + w107 * (w1 * w64 - w17 * w63)) * w110 + 2 * upright1_theta_dot * (w14 * w83 + w5 * w86) * (w61 * w112 + w50 * w113 - w114)
    w116 = 2 * top2_theta_dot
    w117 = upright0_theta_dot * w50
    w118 = (w14 * w34 + w5 * w29) / w37
    w119 = w29 * w31 + w34 * w35
    w120 = w89 * w119
    w121 = w61 * (w39 * w112) + w50 * (w39 * w113 - w117 * w118) - w53 * (w117 * w120) + w51 * (w117 * (w118 + w120))
    w122 = (w14 * w35 + w5 * w31) / w37
    w123 = w88 * w119
    w124 = w61 * (w45 * w112) + w50 * (w45 * w113 - w117 * w122) + w53 * (w117 * (w122 - w123)) + w51 * (w117 * w123)
    w125 = w115 + (w116 * (w35 * w82 + w31 * w85) + w116 * (w24 * w56 - w27 * w54)) * (w121 - w39 * w114) - 2 * upright2_theta_dot * (w34 * w82 + w29 * w85) * (w124 - w45 * w114)
    dQ_hat_dq_i = ca.vertcat(
        w93 + w51 * w94 - w106 + w125,
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 170 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    w0 = ca.cos(upright0_theta) * c0
    w1 = ca.sin(top1_theta)
    w2 = w1 * c13
    w3 = ca.sin(upright1_theta) * c4
    w4 = ca.cos(upright1_theta) * c4
    w5 = ca.sin(upright0_theta) * c0
    w6 = w1 * c3
    w7 = ca.cos(top1_theta)
    w8 = w7 * c3
    w9 = w4 * w6 - w3 * w8
    w10 = (w0 * w3 - w4 * w5) / w9
    w11 = w10 * (2 * (w10 * upright0_theta_dot))
    w12 = w7 * c13
    w13 = (w0 * w6 - w5 * w8) / w9
    w14 = upright0_theta_dot * w13
    w15 = w13 * (2 * w14)
    w16 = w4 * w15
    w17 = 2 * upright0_theta_dot
    w18 = w0 * w17
    w19 = w16 - w8 * w11 - w18
    w20 = w3 * w15
    w21 = w5 * w17
    w22 = w20 - w6 * w11 - w21
    w23 = (w4 * w19 + w3 * w22) / w9
    w24 = ca.sin(top2_theta)
    w25 = w24 * c11
    w26 = ca.sin(upright2_theta) * c9
    w27 = ca.cos(upright2_theta) * c9
    w28 = w24 * c8
    w29 = ca.cos(top2_theta)
    w30 = w29 * c8
    w31 = w27 * w28 - w26 * w30
    w32 = (w4 * w26 - w3 * w27) / w31
    w33 = 2 * (w14 * w32) * (w13 * w32)
    w34 = (w8 * w19 + w6 * w22) / w9
    w35 = w4 * w34 - w20
    w36 = w29 * c11
    w37 = (w4 * w28 - w3 * w30) / w31
    w38 = 2 * (w14 * w37) * (w13 * w37)
    w39 = w27 * w38 - w30 * w33 - w16
    w40 = w26 * w38 - w28 * w33 - w20
    w41 = (w27 * w39 + w26 * w40) / w31 + w32 * w34
    w42 = w16 + w3 * w34
    w43 = w4 * (w25 * w33 - (w35 * c6 + w36 * w41)) - w34 * c5 - w3 * (w33 * w36 + (w42 * c6 + w25 * w41)) - w37 * (((w30 * w39 + w28 * w40) / w31 + w34 * w37) * c10)
    w44 = w0 * (w2 * w11 - (w12 * w23 - w21 * c1)) - w5 * (w11 * w12 + (w18 * c1 + w2 * w23)) + w13 * (w43 - w32 * (w25 * w42 + w35 * w36 + w41 * c12))
    dQ_hat_dq_i_dot = ca.vertcat(
        w44 - w10 * (w2 * w18 - w12 * w21 + w23 * c14),
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 310 operations."""
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 36)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_ddot = q_i_ddot[0]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    w0 = ca.sin(upright0_theta)
    w1 = w0 * c0
    w2 = ca.cos(upright0_theta)
    w3 = w2 * c0
    w4 = upright0_theta_ddot * w3
    w5 = w4 * c1
    w6 = ca.sin(top1_theta)
    w7 = w6 * c13
    w8 = ca.sin(upright1_theta)
    w9 = w8 * c4
    w10 = ca.cos(upright1_theta)
    w11 = w10 * c4
    w12 = w6 * c3
    w13 = ca.cos(top1_theta)
    w14 = w13 * c3
    w15 = w11 * w12 - w9 * w14
    w16 = (w1 * w9 + w3 * w11) / w15
    w17 = upright0_theta_ddot * w16
    w18 = w1 * upright0_theta_ddot
    w19 = w18 * c1
    w20 = (w3 * w9 - w1 * w11) / w15
    w21 = upright0_theta_ddot * w20
    w22 = w13 * c13
    w23 = (w3 * w12 - w1 * w14) / w15
    w24 = (w1 * w12 + w3 * w14) / w15
    w25 = upright0_theta_ddot * w24
    w26 = w11 * w25
    w27 = ca.cos(top2_theta)
    w28 = w27 * c11
    w29 = ca.sin(upright2_theta)
    w30 = w29 * c9
    w31 = ca.cos(upright2_theta)
    w32 = w31 * c9
    w33 = ca.sin(top2_theta)
    w34 = w33 * c8
    w35 = w27 * c8
    w36 = w32 * w34 - w30 * w35
    w37 = (w11 * w30 - w9 * w32) / w36
    w38 = w25 * w37
    w39 = w9 * w25
    w40 = w33 * c11
    w41 = (w11 * w34 - w9 * w35) / w36
    w42 = w25 * c5 + w11 * (w26 * c6 + w28 * w38) + w9 * (w39 * c6 + w38 * w40) + w41 * (w25 * w41 * c10) + w37 * (w39 * w40 + w26 * w28 + w38 * c12)
    w43 = upright0_theta_ddot * w23
    w44 = w11 * w43
    w45 = w37 * w43
    w46 = w44 * c6 + w28 * w45
    w47 = w9 * w43
    w48 = w47 * c6 + w40 * w45
    w49 = w40 * w47 + w28 * w44 + w45 * c12
    w50 = w43 * c5 + w11 * w46 + w9 * w48 + w41 * (w41 * w43 * c10) + w37 * w49
    w51 = w1 * (w5 - w7 * w17) + w3 * (w19 + w7 * w21) - (w3 * (w19 + w17 * w22) + w1 * (w5 + w21 * w22)) - (w23 * w42 + w24 * w50)
    w52 = w7 * w18 + w4 * w22 + w21 * c14
    w53 = w23 * w41
    w54 = w23 * w37
    w55 = w9 * w23
    w56 = w40 * w54 + w55 * c6
    w57 = w11 * w23
    w58 = w54 * c12 + w40 * w55 + w28 * w57
    w59 = w28 * w54 + w57 * c6
    w60 = w50 + upright0_theta_ddot * (w41 * (w53 * c10) + w9 * w56 + w37 * w58 + w11 * w59 + w23 * c5)
    w61 = w60 / w15
    w62 = w52 + upright0_theta_ddot * (w20 * c14 + w1 * w7 + w3 * w22)
    w63 = w60 * (w23 / w15) + w20 / w15 * w62
    w64 = w13 * (w20 * (w0 * upright0_theta_ddot) * c33 + (w3 * w61 - w11 * w63) * c3) - w6 * ((w9 * w63 - w1 * w61) * c3 + w20 * (upright0_theta_ddot * w2) * c33)
    w65 = w41 * (w23 * w43) * c34
    w66 = w65 / w36
    w67 = w23 * w49 + w43 * w58
    w68 = w67 / w36
    w69 = w62 / w15
    w70 = w10 * ((w23 * w48 - w35 * w66 + w43 * w56 - w32 * w68 + w14 * w63 + w3 * w69) * c4) - w8 * ((w34 * w66 + w23 * w46 + w30 * w68 + w43 * w59 - w12 * w63 - w1 * w69) * c4)
    w71 = w65 * (w41 / w36) + w67 * (w37 / w36)
    w72 = w27 * (w37 * (w23 * (w23 * (upright0_theta_ddot * w8))) * c35 + (w11 * w66 - w32 * w71) * c8) - w33 * ((w30 * w71 - w9 * w66) * c8 + w37 * (w23 * (w23 * (upright0_theta_ddot * w10))) * c35)
    w73 = w20 * w64 + w23 * w70 + w54 * w72 + w53 * (w29 * ((w34 * w71 + w9 * w68) * c9) + w31 * ((w35 * w71 + w11 * w68) * c9))
    dMa_dq_i = ca.vertcat(
        w51 + (w20 * (w4 * w7 - w18 * w22 - w17 * c14) - w16 * w52) + w73,
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 165 operations."""
    p = ca.SX.sym("p", 18)
    upright0_tip_x = p[11]
    top1_tip_x = p[12]
    upright1_tip_x = p[13]
    ground_foot1_x = p[14]
    top2_tip_x = p[15]
    upright2_tip_x = p[16]
    ground_foot2_x = p[17]
    positions = ca.vertcat(
        ground_foot1_x,
        0.0,
        0.0,
        ground_foot2_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        upright0_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        top1_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        upright1_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        top2_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        upright2_tip_x,
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
    inputs, outputs = [p], [positions, axes]
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
    "geometry": geometry,
}
