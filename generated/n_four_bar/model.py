"""2 four-bar windows side by side: equations of motion, emitted by symgen from the scene `n_four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 upright0.theta [rad]

q_d, the dependent coordinates by index:
    0 upright0.x [m], 1 upright0.y [m], 2 top1.x [m], 3 top1.y [m], 4 top1.theta [rad], 5 upright1.x [m],
    6 upright1.y [m], 7 upright1.theta [rad], 8 top2.x [m], 9 top2.y [m], 10 top2.theta [rad],
    11 upright2.x [m], 12 upright2.y [m], 13 upright2.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 18) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    35 operations.
    """
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
    # intermediate terms (5)
    w0 = 0.08333333333333333 + upright0_mass * upright0_center_of_mass_x**2
    w1 = 0.08333333333333333 + upright1_mass * upright1_center_of_mass_x**2
    w2 = upright0_mass * upright0_center_of_mass_x
    w3 = upright1_mass * upright1_center_of_mass_x
    w4 = upright2_mass * upright2_center_of_mass_x
    # outputs
    c = ca.vertcat(
        upright0_tip_x,  # upright0_tip_x
        top1_mass,  # top1_mass
        w0 + upright0_tip_x * (upright0_tip_x * top1_mass),  # c2
        top1_tip_x,  # top1_tip_x
        upright1_tip_x,  # upright1_tip_x
        w1,  # c5
        top2_mass,  # top2_mass
        w1 + upright1_tip_x * (upright1_tip_x * top2_mass),  # c7
        top2_tip_x,  # top2_tip_x
        upright2_tip_x,  # upright2_tip_x
        0.08333333333333333 + upright2_mass * upright2_center_of_mass_x**2,  # c10
        top2_mass * top2_center_of_mass_x,  # c11
        0.08333333333333333 + top2_mass * top2_center_of_mass_x**2,  # c12
        top1_mass * top1_center_of_mass_x,  # c13
        0.08333333333333333 + top1_mass * top1_center_of_mass_x**2,  # c14
        gravity_y,  # gravity_y
        w2 * gravity_y,  # c16
        top1_mass * gravity_y,  # c17
        gravity_y * w3,  # c18
        top2_mass * gravity_y,  # c19
        gravity_y * w4,  # c20
        ground_foot1_x,  # ground_foot1_x
        ground_foot2_x,  # ground_foot2_x
        upright0_mass,  # upright0_mass
        w0,  # c24
        upright1_mass,  # upright1_mass
        upright2_mass,  # upright2_mass
        w2,  # c27
        w3,  # c28
        w4,  # c29
        upright0_mass * gravity_y,  # c30
        upright1_mass * gravity_y,  # c31
        upright2_mass * gravity_y,  # c32
        -gravity_y,  # c33
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    176 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_mass = c[1]
    c2 = c[2]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    c7 = c[7]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (51)
    w0 = ca.cos(upright0_theta)
    w1 = w0 * upright0_tip_x
    w2 = ca.sin(upright0_theta) * upright0_tip_x
    w3 = ca.sin(top1_theta)
    w4 = w3 * top1_tip_x
    w5 = ca.cos(top1_theta)
    w6 = w5 * top1_tip_x
    w7 = ca.cos(upright1_theta)
    w8 = w7 * upright1_tip_x
    w9 = ca.sin(upright1_theta) * upright1_tip_x
    w10 = w4 * w8 - w6 * w9
    w11 = (w1 * w4 - w2 * w6) / w10
    w12 = ca.sin(top2_theta)
    w13 = w12 * top2_tip_x
    w14 = ca.cos(top2_theta)
    w15 = w14 * top2_tip_x
    w16 = ca.cos(upright2_theta)
    w17 = w16 * upright2_tip_x
    w18 = ca.sin(upright2_theta) * upright2_tip_x
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
    w40 = w0 * c16 + w1 * (w27 * w30 + c17 - (w26 * w39 - w37 * top1_mass)) - w2 * (w26 * w30 + (w34 * top1_mass + w27 * w39))
    w41 = (w6 * w35 + w4 * w38) / w10
    w42 = top2_theta_dot**2
    w43 = w8 * w41 - w36
    w44 = upright2_theta_dot**2
    w45 = w17 * w44 - w15 * w42 - w32
    w46 = w18 * w44 - w13 * w42 - w36
    w47 = (w17 * w45 + w18 * w46) / w19 + w21 * w41
    w48 = w32 + w9 * w41
    w49 = w7 * c18 - w41 * c5 + w8 * (w23 * w42 + c19 - (w43 * top2_mass + w22 * w47)) - w9 * (w22 * w42 + (w48 * top2_mass + w23 * w47))
    w50 = w49 + w20 * (w16 * c20 - ((w15 * w45 + w13 * w46) / w19 + w20 * w41) * c10) + w21 * (w22 * gravity_y - (w23 * w48 + w22 * w43 + w47 * c12))
    # outputs
    M_hat = ca.vertcat(w29)
    Q_hat = ca.vertcat(w40 + w11 * w50 + w25 * (w26 * gravity_y - (w27 * w34 - w26 * w37 + w39 * c14)))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 14) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 4) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 2) [SI]: determinants of the loop blocks, zero if singular
    65 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    c = ca.SX.sym("c", 34)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_tip_x = c[0]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    ground_foot1_x = c[21]
    ground_foot2_x = c[22]
    # intermediate terms (21)
    w0 = ca.cos(upright0_theta) * upright0_tip_x
    w1 = ca.sin(upright0_theta) * upright0_tip_x
    w2 = ca.cos(upright1_theta) * upright1_tip_x
    w3 = w2 + ground_foot1_x
    w4 = ca.cos(top1_theta) * top1_tip_x
    w5 = w3 - (w0 + w4)
    w6 = ca.sin(upright1_theta) * upright1_tip_x
    w7 = ca.sin(top1_theta) * top1_tip_x
    w8 = w6 - (w1 + w7)
    w9 = w2 * w7 - w4 * w6
    w10 = (w4 * w5 + w7 * w8) / w9
    w11 = upright1_theta - w10
    w12 = ca.cos(upright2_theta) * upright2_tip_x
    w13 = ca.cos(top2_theta) * top2_tip_x
    w14 = w12 + ground_foot2_x - (w3 + w13)
    w15 = w14 - w6 * w10
    w16 = ca.sin(upright2_theta) * upright2_tip_x
    w17 = ca.sin(top2_theta) * top2_tip_x
    w18 = w16 - (w6 + w17)
    w19 = w18 + w2 * w10
    w20 = w12 * w17 - w13 * w16
    # outputs
    q_d_next = ca.vertcat(
        0.0,  # upright0.x
        0.0,  # upright0.y
        w0,  # top1.x
        w1,  # top1.y
        top1_theta - (w2 * w5 + w6 * w8) / w9,  # top1.theta
        ground_foot1_x,  # upright1.x
        0.0,  # upright1.y
        w11,  # upright1.theta
        ground_foot1_x + ca.cos(w11) * upright1_tip_x,  # top2.x
        ca.sin(w11) * upright1_tip_x,  # top2.y
        top2_theta - (w12 * w15 + w16 * w19) / w20,  # top2.theta
        ground_foot2_x,  # upright2.x
        0.0,  # upright2.y
        upright2_theta - (w13 * w15 + w17 * w19) / w20,  # upright2.theta
    )
    C_loop = ca.vertcat(
        w5,  # C1.x
        w8,  # C1.y
        w14,  # C2.x
        w18,  # C2.y
    )
    det_loop = ca.vertcat(w9, w20)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    52 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 34)
    upright0_theta = q_i[0]
    top1_theta = q_d[4]
    upright1_theta = q_d[7]
    top2_theta = q_d[10]
    upright2_theta = q_d[13]
    upright0_theta_dot = q_i_dot[0]
    upright0_tip_x = c[0]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    # intermediate terms (13)
    w0 = ca.sin(upright0_theta) * upright0_tip_x
    w1 = ca.cos(upright0_theta) * upright0_tip_x
    w2 = ca.sin(upright1_theta) * upright1_tip_x
    w3 = ca.cos(upright1_theta) * upright1_tip_x
    w4 = ca.sin(top1_theta) * top1_tip_x
    w5 = ca.cos(top1_theta) * top1_tip_x
    w6 = w3 * w4 - w2 * w5
    w7 = upright0_theta_dot * ((w1 * w4 - w0 * w5) / w6)
    w8 = ca.sin(upright2_theta) * upright2_tip_x
    w9 = ca.cos(upright2_theta) * upright2_tip_x
    w10 = ca.sin(top2_theta) * top2_tip_x
    w11 = ca.cos(top2_theta) * top2_tip_x
    w12 = w9 * w10 - w8 * w11
    # outputs
    q_d_dot = ca.SX(14, 1)
    q_d_dot[2] = -(w0 * upright0_theta_dot)  # top1.x
    q_d_dot[3] = upright0_theta_dot * w1  # top1.y
    q_d_dot[4] = upright0_theta_dot * ((w1 * w2 - w0 * w3) / w6)  # top1.theta
    q_d_dot[7] = w7  # upright1.theta
    q_d_dot[8] = -(w2 * w7)  # top2.x
    q_d_dot[9] = w3 * w7  # top2.y
    q_d_dot[10] = w7 * ((w3 * w8 - w2 * w9) / w12)  # top2.theta
    q_d_dot[13] = w7 * ((w3 * w10 - w2 * w11) / w12)  # upright2.theta
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 14) [mixed]: accelerations of the dependent coordinates
    99 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    # intermediate terms (26)
    w0 = upright0_theta_dot**2
    w1 = ca.cos(upright0_theta) * upright0_tip_x
    w2 = w0 * w1
    w3 = ca.sin(upright0_theta) * upright0_tip_x
    w4 = w0 * w3
    w5 = ca.cos(upright1_theta) * upright1_tip_x
    w6 = upright1_theta_dot**2
    w7 = w5 * w6
    w8 = top1_theta_dot**2
    w9 = ca.cos(top1_theta) * top1_tip_x
    w10 = w7 - w8 * w9 - w2
    w11 = ca.sin(upright1_theta) * upright1_tip_x
    w12 = w6 * w11
    w13 = ca.sin(top1_theta) * top1_tip_x
    w14 = w12 - w8 * w13 - w4
    w15 = w5 * w13 - w9 * w11
    w16 = (w9 * w10 + w13 * w14) / w15 + upright0_theta_ddot * ((w1 * w13 - w3 * w9) / w15)
    w17 = ca.cos(upright2_theta) * upright2_tip_x
    w18 = upright2_theta_dot**2
    w19 = top2_theta_dot**2
    w20 = ca.cos(top2_theta) * top2_tip_x
    w21 = w17 * w18 - w19 * w20 - w7
    w22 = ca.sin(upright2_theta) * upright2_tip_x
    w23 = ca.sin(top2_theta) * top2_tip_x
    w24 = w18 * w22 - w19 * w23 - w12
    w25 = w17 * w23 - w20 * w22
    # outputs
    q_d_ddot = ca.SX(14, 1)
    q_d_ddot[2] = -(w2 + w3 * upright0_theta_ddot)  # top1.x
    q_d_ddot[3] = w1 * upright0_theta_ddot - w4  # top1.y
    q_d_ddot[4] = (w5 * w10 + w11 * w14) / w15 + upright0_theta_ddot * ((w1 * w11 - w3 * w5) / w15)  # top1.theta
    q_d_ddot[7] = w16  # upright1.theta
    q_d_ddot[8] = -(w7 + w11 * w16)  # top2.x
    q_d_ddot[9] = w5 * w16 - w12  # top2.y
    q_d_ddot[10] = (w17 * w21 + w22 * w24) / w25 + w16 * ((w5 * w22 - w11 * w17) / w25)  # top2.theta
    q_d_ddot[13] = (w20 * w21 + w23 * w24) / w25 + w16 * ((w5 * w23 - w11 * w20) / w25)  # upright2.theta
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 15) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 15) [mixed]: rates of all coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 14) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 14 x 15) [SI]: constraint Jacobian
    gives C_t (n_c = 14) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 14) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 14) [m/s^2, rad/s^2]: right-hand side at acceleration level
    69 operations.
    """
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    ground_foot1_x = c[21]
    ground_foot2_x = c[22]
    # intermediate terms (19)
    w0 = ca.cos(upright0_theta) * upright0_tip_x
    w1 = ca.sin(upright0_theta) * upright0_tip_x
    w2 = ca.cos(upright1_theta) * upright1_tip_x
    w3 = upright1_x + w2
    w4 = ca.cos(top1_theta) * top1_tip_x
    w5 = ca.sin(upright1_theta) * upright1_tip_x
    w6 = upright1_y + w5
    w7 = ca.sin(top1_theta) * top1_tip_x
    w8 = ca.cos(upright2_theta) * upright2_tip_x
    w9 = ca.cos(top2_theta) * top2_tip_x
    w10 = ca.sin(upright2_theta) * upright2_tip_x
    w11 = ca.sin(top2_theta) * top2_tip_x
    w12 = upright0_theta_dot**2
    w13 = upright1_theta_dot**2
    w14 = w2 * w13
    w15 = top1_theta_dot**2
    w16 = w5 * w13
    w17 = upright2_theta_dot**2
    w18 = top2_theta_dot**2
    # outputs
    C = ca.vertcat(
        upright0_x,  # A0.x
        upright0_y,  # A0.y
        top1_x - (upright0_x + w0),  # B0.x
        top1_y - (upright0_y + w1),  # B0.y
        w3 - (top1_x + w4),  # C1.x
        w6 - (top1_y + w7),  # C1.y
        upright1_x - ground_foot1_x,  # A1.x
        upright1_y,  # A1.y
        top2_x - w3,  # B1.x
        top2_y - w6,  # B1.y
        upright2_x + w8 - (top2_x + w9),  # C2.x
        upright2_y + w10 - (top2_y + w11),  # C2.y
        upright2_x - ground_foot2_x,  # A2.x
        upright2_y,  # A2.y
    )
    C_q = ca.SX(14, 15)
    # A0.x
    C_q[0, 0] = 1.0
    # A0.y
    C_q[1, 1] = 1.0
    # B0.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # B0.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    # C1.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w7
    C_q[4, 6] = 1.0
    C_q[4, 8] = -w5
    # C1.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w4
    C_q[5, 7] = 1.0
    C_q[5, 8] = w2
    # A1.x
    C_q[6, 6] = 1.0
    # A1.y
    C_q[7, 7] = 1.0
    # B1.x
    C_q[8, 6] = -1.0
    C_q[8, 8] = w5
    C_q[8, 9] = 1.0
    # B1.y
    C_q[9, 7] = -1.0
    C_q[9, 8] = -w2
    C_q[9, 10] = 1.0
    # C2.x
    C_q[10, 9] = -1.0
    C_q[10, 11] = w11
    C_q[10, 12] = 1.0
    C_q[10, 14] = -w10
    # C2.y
    C_q[11, 10] = -1.0
    C_q[11, 11] = -w9
    C_q[11, 13] = 1.0
    C_q[11, 14] = w8
    # A2.x
    C_q[12, 12] = 1.0
    # A2.y
    C_q[13, 13] = 1.0
    C_t = ca.SX(14, 1)
    nu = ca.SX(14, 1)
    gamma = ca.SX(14, 1)
    gamma[2] = -(w0 * w12)  # B0.x
    gamma[3] = -(w1 * w12)  # B0.y
    gamma[4] = w14 - w4 * w15  # C1.x
    gamma[5] = w16 - w7 * w15  # C1.y
    gamma[8] = -w14  # B1.x
    gamma[9] = -w16  # B1.y
    gamma[10] = w8 * w17 - w9 * w18  # C2.x
    gamma[11] = w10 * w17 - w11 * w18  # C2.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 15) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 15) [mixed]: rates of all coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 15 x 15) [SI]: mass matrix in all coordinates
    gives K (n x n = 15 x 15) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 15) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 15) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 15) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 14 x 15) [SI]: constraint Jacobian
    gives gamma (n_c = 14) [m/s^2, rad/s^2]: right-hand side at acceleration level
    84 operations.
    """
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_mass = c[1]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c17 = c[17]
    c19 = c[19]
    upright0_mass = c[23]
    c24 = c[24]
    upright1_mass = c[25]
    upright2_mass = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    # intermediate terms (57)
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
    w40 = w4 * gravity_y
    w41 = w9 * gravity_y
    w42 = w14 * gravity_y
    w43 = w19 * gravity_y
    w44 = w24 * gravity_y
    w45 = w0 * upright0_tip_x
    w46 = w3 * upright0_tip_x
    w47 = w5 * top1_tip_x
    w48 = w8 * top1_tip_x
    w49 = w10 * upright1_tip_x
    w50 = w13 * upright1_tip_x
    w51 = w15 * top2_tip_x
    w52 = w18 * top2_tip_x
    w53 = w20 * upright2_tip_x
    w54 = w23 * upright2_tip_x
    w55 = w31 * w50
    w56 = w31 * w49
    # outputs
    M = ca.SX(15, 15)
    # upright0.x
    M[0, 0] = upright0_mass
    M[0, 2] = w2
    # upright0.y
    M[1, 1] = upright0_mass
    M[1, 2] = w4
    # upright0.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c24
    # top1.x
    M[3, 3] = top1_mass
    M[3, 5] = w7
    # top1.y
    M[4, 4] = top1_mass
    M[4, 5] = w9
    # top1.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c14
    # upright1.x
    M[6, 6] = upright1_mass
    M[6, 8] = w12
    # upright1.y
    M[7, 7] = upright1_mass
    M[7, 8] = w14
    # upright1.theta
    M[8, 6] = w12
    M[8, 7] = w14
    M[8, 8] = c5
    # top2.x
    M[9, 9] = top2_mass
    M[9, 11] = w17
    # top2.y
    M[10, 10] = top2_mass
    M[10, 11] = w19
    # top2.theta
    M[11, 9] = w17
    M[11, 10] = w19
    M[11, 11] = c12
    # upright2.x
    M[12, 12] = upright2_mass
    M[12, 14] = w22
    # upright2.y
    M[13, 13] = upright2_mass
    M[13, 14] = w24
    # upright2.theta
    M[14, 12] = w22
    M[14, 13] = w24
    M[14, 14] = c10
    K = ca.SX(15, 15)
    Q_v = ca.vertcat(
        w26,  # upright0.x
        w27,  # upright0.y
        0.0,  # upright0.theta
        w29,  # top1.x
        w30,  # top1.y
        0.0,  # top1.theta
        w32,  # upright1.x
        w33,  # upright1.y
        0.0,  # upright1.theta
        w35,  # top2.x
        w36,  # top2.y
        0.0,  # top2.theta
        w38,  # upright2.x
        w39,  # upright2.y
        0.0,  # upright2.theta
    )
    Q_F = ca.vertcat(
        0.0,  # upright0.x
        c30,  # upright0.y
        w40,  # upright0.theta
        0.0,  # top1.x
        c17,  # top1.y
        w41,  # top1.theta
        0.0,  # upright1.x
        c31,  # upright1.y
        w42,  # upright1.theta
        0.0,  # top2.x
        c19,  # top2.y
        w43,  # top2.theta
        0.0,  # upright2.x
        c32,  # upright2.y
        w44,  # upright2.theta
    )
    Q_star = ca.vertcat(
        w26,  # upright0.x
        w27 + c30,  # upright0.y
        w40,  # upright0.theta
        w29,  # top1.x
        c17 + w30,  # top1.y
        w41,  # top1.theta
        w32,  # upright1.x
        w33 + c31,  # upright1.y
        w42,  # upright1.theta
        w35,  # top2.x
        c19 + w36,  # top2.y
        w43,  # top2.theta
        w38,  # upright2.x
        w39 + c32,  # upright2.y
        w44,  # upright2.theta
    )
    C_q = ca.SX(14, 15)
    # A0.x
    C_q[0, 0] = 1.0
    # A0.y
    C_q[1, 1] = 1.0
    # B0.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w45
    C_q[2, 3] = 1.0
    # B0.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w46
    C_q[3, 4] = 1.0
    # C1.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w47
    C_q[4, 6] = 1.0
    C_q[4, 8] = -w49
    # C1.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w48
    C_q[5, 7] = 1.0
    C_q[5, 8] = w50
    # A1.x
    C_q[6, 6] = 1.0
    # A1.y
    C_q[7, 7] = 1.0
    # B1.x
    C_q[8, 6] = -1.0
    C_q[8, 8] = w49
    C_q[8, 9] = 1.0
    # B1.y
    C_q[9, 7] = -1.0
    C_q[9, 8] = -w50
    C_q[9, 10] = 1.0
    # C2.x
    C_q[10, 9] = -1.0
    C_q[10, 11] = w51
    C_q[10, 12] = 1.0
    C_q[10, 14] = -w53
    # C2.y
    C_q[11, 10] = -1.0
    C_q[11, 11] = -w52
    C_q[11, 13] = 1.0
    C_q[11, 14] = w54
    # A2.x
    C_q[12, 12] = 1.0
    # A2.y
    C_q[13, 13] = 1.0
    gamma = ca.SX(14, 1)
    gamma[2] = -(w25 * w46)  # B0.x
    gamma[3] = -(w25 * w45)  # B0.y
    gamma[4] = w55 - w28 * w48  # C1.x
    gamma[5] = w56 - w28 * w47  # C1.y
    gamma[8] = -w55  # B1.x
    gamma[9] = -w56  # B1.y
    gamma[10] = w37 * w54 - w34 * w52  # C2.x
    gamma[11] = w37 * w53 - w34 * w51  # C2.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 15) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 15) [mixed]: rates of all coordinates
    takes q_ddot (n = 15) [mixed]: accelerations of all coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 14) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 7) [N, N m]: world force and moment of a joint on its body b, at b
    172 operations.
    """
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    q_ddot = ca.SX.sym("q_ddot", 15)
    c = ca.SX.sym("c", 34)
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
    top1_mass = c[1]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c17 = c[17]
    c19 = c[19]
    upright0_mass = c[23]
    upright1_mass = c[25]
    upright2_mass = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    # intermediate terms (54)
    w0 = upright0_theta_dot**2
    w1 = ca.cos(upright0_theta) * c27
    w2 = ca.sin(upright0_theta) * c27
    w3 = top1_theta_dot**2
    w4 = ca.cos(top1_theta)
    w5 = w4 * c13
    w6 = ca.sin(top1_theta)
    w7 = w6 * c13
    w8 = ca.cos(upright1_theta)
    w9 = w8 * upright1_tip_x
    w10 = w5 * gravity_y - (w5 * top1_y_ddot - top1_x_ddot * w7 + top1_theta_ddot * c14)
    w11 = w4 * top1_tip_x
    w12 = w8 * c28
    w13 = ca.sin(upright1_theta)
    w14 = w13 * c28
    w15 = top2_theta_dot**2
    w16 = ca.sin(top2_theta)
    w17 = w16 * c11
    w18 = ca.cos(top2_theta)
    w19 = w18 * c11
    w20 = c19 + w15 * w17 - (top2_y_ddot * top2_mass + w19 * top2_theta_ddot)
    w21 = w12 * gravity_y - (w12 * upright1_y_ddot - w14 * upright1_x_ddot + upright1_theta_ddot * c5) + w9 * w20
    w22 = w13 * upright1_tip_x
    w23 = w15 * w19 - (top2_x_ddot * top2_mass - w17 * top2_theta_ddot)
    w24 = ca.cos(upright2_theta)
    w25 = w24 * upright2_tip_x
    w26 = w19 * gravity_y - (top2_y_ddot * w19 - w17 * top2_x_ddot + top2_theta_ddot * c12)
    w27 = w18 * top2_tip_x
    w28 = w24 * c29
    w29 = ca.sin(upright2_theta)
    w30 = w29 * c29
    w31 = w28 * gravity_y - (w28 * upright2_y_ddot - w30 * upright2_x_ddot + upright2_theta_ddot * c10)
    w32 = w16 * top2_tip_x
    w33 = w29 * upright2_tip_x
    w34 = w25 * w32 - w27 * w33
    w35 = (w25 * w26 + w27 * w31) / w34
    w36 = (w26 * w33 + w31 * w32) / w34
    w37 = w21 - w22 * w23 - w22 * w35 + w9 * w36
    w38 = w6 * top1_tip_x
    w39 = w9 * w38 - w11 * w22
    w40 = (w9 * w10 + w11 * w37) / w39
    w41 = w3 * w5 - (top1_x_ddot * top1_mass - w7 * top1_theta_ddot) + w40
    w42 = w0 * w1 - (upright0_x_ddot * upright0_mass - w2 * upright0_theta_ddot) + w41
    w43 = (w10 * w22 + w37 * w38) / w39
    w44 = c17 + w3 * w7 - (top1_y_ddot * top1_mass + w5 * top1_theta_ddot) + w43
    w45 = c30 + w0 * w2 - (upright0_y_ddot * upright0_mass + w1 * upright0_theta_ddot) + w44
    w46 = upright1_theta_dot**2
    w47 = w23 + w35
    w48 = w12 * w46 - (upright1_x_ddot * upright1_mass - w14 * upright1_theta_ddot) - w40 + w47
    w49 = w20 + w36
    w50 = c31 + w14 * w46 - (upright1_y_ddot * upright1_mass + w12 * upright1_theta_ddot) - w43 + w49
    w51 = upright2_theta_dot**2
    w52 = w28 * w51 - (upright2_x_ddot * upright2_mass - w30 * upright2_theta_ddot) - w35
    w53 = c32 + w30 * w51 - (upright2_y_ddot * upright2_mass + w28 * upright2_theta_ddot) - w36
    # outputs
    lam = ca.vertcat(
        w42,  # A0.x
        w45,  # A0.y
        w41,  # B0.x
        w44,  # B0.y
        w40,  # C1.x
        w43,  # C1.y
        w48,  # A1.x
        w50,  # A1.y
        w47,  # B1.x
        w49,  # B1.y
        w35,  # C2.x
        w36,  # C2.y
        w52,  # A2.x
        w53,  # A2.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w42, -w45, 0.0),  # A0
        ca.vertcat(-w41, -w44, 0.0),  # B0
        ca.vertcat(-w40, -w43, 0.0),  # C1
        ca.vertcat(-w48, -w50, 0.0),  # A1
        ca.vertcat(-w47, -w49, 0.0),  # B1
        ca.vertcat(-w35, -w36, 0.0),  # C2
        ca.vertcat(-w52, -w53, 0.0),  # A2
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 15) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 15) [mixed]: rates of all coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    120 operations.
    """
    q = ca.SX.sym("q", 15)
    q_dot = ca.SX.sym("q_dot", 15)
    c = ca.SX.sym("c", 34)
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
    top1_mass = c[1]
    c5 = c[5]
    top2_mass = c[6]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    upright0_mass = c[23]
    c24 = c[24]
    upright1_mass = c[25]
    upright2_mass = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c33 = c[33]
    # intermediate terms (19)
    w0 = ca.sin(upright0_theta) * c27
    w1 = ca.cos(upright0_theta) * c27
    w2 = upright0_x_dot * (upright0_x_dot * upright0_mass - w0 * upright0_theta_dot) + upright0_y_dot * (upright0_y_dot * upright0_mass + upright0_theta_dot * w1)
    w3 = ca.sin(top1_theta) * c13
    w4 = w2 + upright0_theta_dot * (upright0_y_dot * w1 - upright0_x_dot * w0 + upright0_theta_dot * c24) + top1_x_dot * (top1_x_dot * top1_mass - w3 * top1_theta_dot)
    w5 = ca.cos(top1_theta) * c13
    w6 = w4 + top1_y_dot * (top1_y_dot * top1_mass + top1_theta_dot * w5) + top1_theta_dot * (top1_y_dot * w5 - top1_x_dot * w3 + top1_theta_dot * c14)
    w7 = ca.sin(upright1_theta) * c28
    w8 = ca.cos(upright1_theta) * c28
    w9 = w6 + upright1_x_dot * (upright1_x_dot * upright1_mass - w7 * upright1_theta_dot) + upright1_y_dot * (upright1_y_dot * upright1_mass + upright1_theta_dot * w8)
    w10 = ca.sin(top2_theta) * c11
    w11 = w9 + upright1_theta_dot * (upright1_y_dot * w8 - upright1_x_dot * w7 + upright1_theta_dot * c5) + top2_x_dot * (top2_x_dot * top2_mass - w10 * top2_theta_dot)
    w12 = ca.cos(top2_theta) * c11
    w13 = w11 + top2_y_dot * (top2_y_dot * top2_mass + top2_theta_dot * w12) + top2_theta_dot * (top2_y_dot * w12 - top2_x_dot * w10 + top2_theta_dot * c12)
    w14 = ca.sin(upright2_theta) * c29
    w15 = ca.cos(upright2_theta) * c29
    w16 = w13 + upright2_x_dot * (upright2_x_dot * upright2_mass - w14 * upright2_theta_dot) + upright2_y_dot * (upright2_y_dot * upright2_mass + upright2_theta_dot * w15)
    w17 = w16 + upright2_theta_dot * (upright2_y_dot * w15 - upright2_x_dot * w14 + upright2_theta_dot * c10)
    w18 = w0 + upright0_y * upright0_mass + (w3 + top1_y * top1_mass) + (w7 + upright1_y * upright1_mass) + (w10 + top2_y * top2_mass)
    # outputs
    kinetic = ca.vertcat(w17 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w18 + (w14 + upright2_y * upright2_mass)) * c33)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 15) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 5) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    15 operations.
    """
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
    # intermediate terms (10)
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
    # outputs
    poses = ca.SX(12, 5)
    poses[0, 0] = upright0_x
    poses[0, 1] = top1_x
    poses[0, 2] = upright1_x
    poses[0, 3] = top2_x
    poses[0, 4] = upright2_x
    poses[1, 0] = upright0_y
    poses[1, 1] = top1_y
    poses[1, 2] = upright1_y
    poses[1, 3] = top2_y
    poses[1, 4] = upright2_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[3, 2] = w4
    poses[3, 3] = w6
    poses[3, 4] = w8
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[4, 2] = w5
    poses[4, 3] = w7
    poses[4, 4] = w9
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[6, 2] = -w5
    poses[6, 3] = -w7
    poses[6, 4] = -w9
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[7, 2] = w4
    poses[7, 3] = w6
    poses[7, 4] = w8
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    poses[11, 2] = 1.0
    poses[11, 3] = 1.0
    poses[11, 4] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    410 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_mass = c[1]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (113)
    w0 = ca.sin(upright0_theta)
    w1 = w0 * upright0_tip_x
    w2 = ca.cos(top1_theta)
    w3 = w2 * c13
    w4 = ca.cos(upright1_theta)
    w5 = w4 * upright1_tip_x
    w6 = ca.sin(upright1_theta)
    w7 = w6 * upright1_tip_x
    w8 = ca.cos(upright0_theta) * upright0_tip_x
    w9 = ca.sin(top1_theta)
    w10 = w9 * top1_tip_x
    w11 = w2 * top1_tip_x
    w12 = w5 * w10 - w7 * w11
    w13 = (w7 * w8 - w1 * w5) / w12
    w14 = w2 * w13
    w15 = w14 * top1_tip_x
    w16 = (w8 * w10 - w1 * w11) / w12
    w17 = w4 * w16 * upright1_tip_x
    w18 = upright1_theta_dot * w17
    w19 = top1_theta_dot * w15 - w18 + w8 * upright0_theta_dot
    w20 = w9 * w13
    w21 = w20 * top1_tip_x
    w22 = w6 * w16
    w23 = w22 * upright1_tip_x
    w24 = upright1_theta_dot * w23
    w25 = top1_theta_dot * w21 - w24 + w1 * upright0_theta_dot
    w26 = 2 * top1_theta_dot * ((w5 * w19 + w7 * w25) / w12)
    w27 = top1_theta_dot**2
    w28 = w20 * c13
    w29 = upright0_theta_dot**2
    w30 = w1 * w29
    w31 = w30 * top1_mass
    w32 = upright1_theta_dot**2
    w33 = w5 * w32
    w34 = w8 * w29
    w35 = w33 - w11 * w27 - w34
    w36 = w7 * w32
    w37 = w36 - w10 * w27 - w30
    w38 = (w5 * w35 + w7 * w37) / w12
    w39 = w14 * c13
    w40 = w9 * c13
    w41 = (w11 * w35 + w10 * w37) / w12
    w42 = w17 * w41
    w43 = (w11 * w19 + w10 * w25) / w12
    w44 = 2 * upright1_theta_dot * w43
    w45 = w5 * w44 + w23 * w32
    w46 = w30 - (w15 * w38 - w42 - (w11 * w26 + w21 * w27 - w45))
    w47 = w23 * w41
    w48 = w17 * w32 - w7 * w44
    w49 = w34 + (w21 * w38 - w47 - (w48 - (w15 * w27 - w10 * w26)))
    w50 = (w5 * w46 - w7 * w49) / w12
    w51 = w34 * top1_mass
    w52 = w3 * gravity_y - (w34 * w40 - w3 * w30 + w38 * c14)
    w53 = top2_theta_dot**2
    w54 = ca.sin(top2_theta)
    w55 = w54 * c11
    w56 = w5 * w41 - w36
    w57 = ca.cos(top2_theta)
    w58 = w57 * c11
    w59 = ca.cos(upright2_theta)
    w60 = w59 * upright2_tip_x
    w61 = upright2_theta_dot**2
    w62 = w57 * top2_tip_x
    w63 = w60 * w61 - w53 * w62 - w33
    w64 = ca.sin(upright2_theta)
    w65 = w64 * upright2_tip_x
    w66 = w54 * top2_tip_x
    w67 = w61 * w65 - w53 * w66 - w36
    w68 = w60 * w66 - w62 * w65
    w69 = (w5 * w65 - w7 * w60) / w68
    w70 = (w60 * w63 + w65 * w67) / w68 + w41 * w69
    w71 = c19 + w53 * w55 - (w56 * top2_mass + w58 * w70)
    w72 = w33 + w7 * w41
    w73 = w53 * w58 + (w72 * top2_mass + w55 * w70)
    w74 = w58 * gravity_y - (w56 * w58 + w55 * w72 + w70 * c12)
    w75 = (w5 * w66 - w7 * w62) / w68
    w76 = (w62 * w63 + w66 * w67) / w68 + w41 * w75
    w77 = w59 * c20 - w76 * c10
    w78 = (w60 * w74 + w62 * w77) / w68
    w79 = (w65 * w74 + w66 * w77) / w68
    w80 = w4 * c18 - w41 * c5 + w5 * w71 - w7 * w73 - w7 * w78 + w5 * w79
    w81 = (w5 * w52 + w11 * w80) / w12
    w82 = (w7 * w52 + w10 * w80) / w12
    w83 = w0 * c16 + w8 * (w3 * w27 + (w51 + w38 * w40) + w81) + w1 * (c17 + w27 * w40 - (w3 * w38 - w31) + w82)
    w84 = w1 * (w3 * w26 + w27 * w28 + (w31 - (w38 * w39 + w40 * w50))) - w83 + w8 * (w27 * w39 - w26 * w40 - (w3 * w50 - w28 * w38 - w51))
    w85 = w28 * gravity_y + (w50 * c14 - (w3 * w34 - w28 * w30 + (w30 * w40 - w34 * w39))) + w15 * w81 + w21 * w82
    w86 = (w11 * w46 - w10 * w49) / w12
    w87 = w84 - w13 * w85 + w16 * (w17 * w81 - (w22 * c18 + w86 * c5) + w23 * w82 - w17 * (w73 + w78) - w23 * (w71 + w79))
    w88 = w42 - w45
    w89 = w88 + w7 * w86
    w90 = w16 * w69
    w91 = w57 * w90
    w92 = w91 * c11
    w93 = w91 * top2_tip_x
    w94 = w16 * w75
    w95 = w59 * w94 * upright2_tip_x
    w96 = w18 + (top2_theta_dot * w93 - upright2_theta_dot * w95)
    w97 = w54 * w90
    w98 = w97 * top2_tip_x
    w99 = w64 * w94
    w100 = w99 * upright2_tip_x
    w101 = w24 + (top2_theta_dot * w98 - upright2_theta_dot * w100)
    w102 = 2 * top2_theta_dot * ((w60 * w96 + w65 * w101) / w68 + w43 * w69)
    w103 = 2 * upright2_theta_dot * ((w62 * w96 + w66 * w101) / w68 + w43 * w75)
    w104 = w88 + (w70 * w93 - w76 * w95 - (w62 * w102 + w53 * w98 - (w60 * w103 + w61 * w100)))
    w105 = w47 + w48
    w106 = w70 * w98 - w76 * w100 - (w61 * w95 - w65 * w103 - (w53 * w93 - w66 * w102)) + w105
    w107 = w69 * w86 - (w60 * w104 + w65 * w106) / w68
    w108 = w97 * c11
    w109 = w5 * w86 - w105
    w110 = w87 - w7 * w16 * (w89 * top2_mass + (w70 * w92 + w55 * w107) - (w58 * w102 + w53 * w108)) + w5 * w16 * (w53 * w92 - w55 * w102 - (w109 * top2_mass + (w58 * w107 - w70 * w108)))
    w111 = w108 * gravity_y + (w58 * w109 - w56 * w108 + (w72 * w92 + w55 * w89) + w107 * c12) + w78 * w93 + w79 * w98
    w112 = w94 * (w78 * w95 - (w99 * c20 + (w75 * w86 - (w62 * w104 + w66 * w106) / w68) * c10) + w79 * w100)
    # outputs
    dQ_hat_dq_i = ca.vertcat(w110 - w90 * w111 + w112)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    148 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_mass = c[1]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    # intermediate terms (47)
    w0 = ca.cos(upright0_theta) * upright0_tip_x
    w1 = ca.sin(top1_theta)
    w2 = w1 * c13
    w3 = ca.sin(upright1_theta) * upright1_tip_x
    w4 = ca.cos(upright1_theta) * upright1_tip_x
    w5 = ca.sin(upright0_theta) * upright0_tip_x
    w6 = w1 * top1_tip_x
    w7 = ca.cos(top1_theta)
    w8 = w7 * top1_tip_x
    w9 = w4 * w6 - w3 * w8
    w10 = (w0 * w3 - w4 * w5) / w9
    w11 = 2 * top1_theta_dot * w10
    w12 = w7 * c13
    w13 = (w0 * w6 - w5 * w8) / w9
    w14 = 2 * upright1_theta_dot * w13
    w15 = w4 * w14
    w16 = 2 * upright0_theta_dot
    w17 = w0 * w16
    w18 = w15 - w8 * w11 - w17
    w19 = w3 * w14
    w20 = w5 * w16
    w21 = w19 - w6 * w11 - w20
    w22 = (w4 * w18 + w3 * w21) / w9
    w23 = w0 * (w2 * w11 - (w12 * w22 - w20 * top1_mass)) - w5 * (w11 * w12 + (w17 * top1_mass + w2 * w22))
    w24 = (w8 * w18 + w6 * w21) / w9
    w25 = ca.cos(top2_theta)
    w26 = w25 * c11
    w27 = ca.sin(upright2_theta) * upright2_tip_x
    w28 = ca.cos(upright2_theta) * upright2_tip_x
    w29 = ca.sin(top2_theta)
    w30 = w29 * top2_tip_x
    w31 = w25 * top2_tip_x
    w32 = w28 * w30 - w27 * w31
    w33 = (w4 * w27 - w3 * w28) / w32
    w34 = w13 * w33
    w35 = 2 * top2_theta_dot * w34
    w36 = w15 + w3 * w24
    w37 = w29 * c11
    w38 = (w4 * w30 - w3 * w31) / w32
    w39 = w13 * w38
    w40 = 2 * upright2_theta_dot * w39
    w41 = w28 * w40 - w31 * w35 - w15
    w42 = w27 * w40 - w30 * w35 - w19
    w43 = (w28 * w41 + w27 * w42) / w32 + w24 * w33
    w44 = w23 - w10 * (w2 * w17 - w12 * w20 + w22 * c14) - w13 * (w24 * c5) - w3 * w13 * (w26 * w35 + (w36 * top2_mass + w37 * w43))
    w45 = w4 * w24 - w19
    w46 = w44 + w4 * w13 * (w35 * w37 - (w45 * top2_mass + w26 * w43)) - w34 * (w26 * w45 + w36 * w37 + w43 * c12)
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w46 - w39 * (((w31 * w41 + w30 * w42) / w32 + w24 * w38) * c10))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 14) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 14) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 34) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    455 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 14)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 14)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 34)
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
    upright0_tip_x = c[0]
    top1_mass = c[1]
    top1_tip_x = c[3]
    upright1_tip_x = c[4]
    c5 = c[5]
    top2_mass = c[6]
    c7 = c[7]
    top2_tip_x = c[8]
    upright2_tip_x = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (124)
    w0 = ca.cos(upright0_theta) * upright0_tip_x
    w1 = ca.sin(upright0_theta)
    w2 = w1 * upright0_tip_x
    w3 = upright0_theta_dot**2
    w4 = w0 * w3
    w5 = upright0_theta_ddot * w2 + w4
    w6 = w5 * top1_mass
    w7 = top1_theta_dot**2
    w8 = ca.cos(top1_theta)
    w9 = w8 * c13
    w10 = w7 * w9
    w11 = ca.sin(top1_theta)
    w12 = w11 * c13
    w13 = ca.cos(upright1_theta)
    w14 = w13 * upright1_tip_x
    w15 = upright1_theta_dot**2
    w16 = w14 * w15
    w17 = w8 * top1_tip_x
    w18 = w7 * w17
    w19 = w16 - w18 - w4
    w20 = ca.sin(upright1_theta)
    w21 = w20 * upright1_tip_x
    w22 = w15 * w21
    w23 = w11 * top1_tip_x
    w24 = w7 * w23
    w25 = w2 * w3
    w26 = w22 - w24 - w25
    w27 = w14 * w23 - w17 * w21
    w28 = (w0 * w21 - w2 * w14) / w27
    w29 = (w14 * w19 + w21 * w26) / w27 + upright0_theta_ddot * w28
    w30 = w12 * w29
    w31 = w0 * upright0_theta_ddot - w25
    w32 = w9 * gravity_y - (w9 * w31 + w5 * w12 + w29 * c14)
    w33 = (w0 * w23 - w2 * w17) / w27
    w34 = (w17 * w19 + w23 * w26) / w27 + upright0_theta_ddot * w33
    w35 = top2_theta_dot**2
    w36 = ca.sin(top2_theta)
    w37 = w36 * c11
    w38 = w35 * w37
    w39 = w14 * w34
    w40 = w39 - w22
    w41 = w40 * top2_mass
    w42 = ca.cos(top2_theta)
    w43 = w42 * c11
    w44 = ca.cos(upright2_theta)
    w45 = w44 * upright2_tip_x
    w46 = upright2_theta_dot**2
    w47 = w45 * w46
    w48 = w42 * top2_tip_x
    w49 = w35 * w48
    w50 = w47 - w49 - w16
    w51 = ca.sin(upright2_theta)
    w52 = w51 * upright2_tip_x
    w53 = w46 * w52
    w54 = w36 * top2_tip_x
    w55 = w35 * w54
    w56 = w53 - w55 - w22
    w57 = w45 * w54 - w48 * w52
    w58 = (w14 * w52 - w21 * w45) / w57
    w59 = (w45 * w50 + w52 * w56) / w57 + w34 * w58
    w60 = w43 * w59
    w61 = c19 + w38 - (w41 + w60)
    w62 = w35 * w43
    w63 = w16 + w21 * w34
    w64 = w63 * top2_mass
    w65 = w37 * w59
    w66 = w62 + (w64 + w65)
    w67 = w43 * gravity_y - (w40 * w43 + w37 * w63 + w59 * c12)
    w68 = (w14 * w54 - w21 * w48) / w57
    w69 = (w48 * w50 + w54 * w56) / w57 + w34 * w68
    w70 = w44 * c20 - w69 * c10
    w71 = (w45 * w67 + w48 * w70) / w57
    w72 = (w52 * w67 + w54 * w70) / w57
    w73 = w13 * c18 - w34 * c5 + w14 * w61 - w21 * w66 - w21 * w71 + w14 * w72
    w74 = (w14 * w32 + w17 * w73) / w27
    w75 = w7 * w12
    w76 = w31 * top1_mass
    w77 = w9 * w29
    w78 = (w21 * w32 + w23 * w73) / w27
    w79 = w0 * w6 - (w1 * c16 + w0 * (w10 + (w6 + w30) + w74) + w2 * (c17 + w75 - (w76 + w77) + w78)) - w2 * w76
    w80 = w14 * w43 + w21 * w37
    w81 = c7 + w68 * (w68 * c10) + (w58 * (w80 + w58 * c12) + w58 * w80)
    w82 = 2 * top1_theta_dot
    w83 = w14 * upright1_theta_dot
    w84 = w0 * upright0_theta_dot + w28 * (top1_theta_dot * w17) - w33 * w83
    w85 = upright1_theta_dot * w21
    w86 = w2 * upright0_theta_dot + w28 * (top1_theta_dot * w23) - w33 * w85
    w87 = (w14 * w84 + w21 * w86) / w27
    w88 = 2 * upright1_theta_dot
    w89 = w14 * w88
    w90 = (w17 * w84 + w23 * w86) / w27
    w91 = w31 - w17 * w82 * w87 + w28 * (w17 * w29 - w24) + w89 * w90 + w33 * (w22 - w39)
    w92 = w21 * w88
    w93 = w5 - w87 * (w23 * w82) + w28 * (w18 + w23 * w29) + w90 * w92 - w33 * w63
    w94 = w83 + w58 * (top2_theta_dot * w48) - w68 * (w45 * upright2_theta_dot)
    w95 = w85 + w58 * (top2_theta_dot * w54) - w68 * (upright2_theta_dot * w52)
    w96 = (w48 * w94 + w54 * w95) / w57
    w97 = (w45 * w94 + w52 * w95) / w57
    w98 = 2 * -w97
    w99 = 2 * top2_theta_dot
    w100 = w14 * (w37 * w99) - w21 * (w43 * w99)
    w101 = w14 * (w92 * top2_mass) - w21 * (w89 * top2_mass) - w68 * (2 * -w96 * c10) - w80 * w98 + w58 * w100
    w102 = w101 + w58 * (w43 * w92 - w37 * w89 - w98 * c12)
    w103 = w14 * w74 - w20 * c18 + w21 * w78 - w14 * (w66 + w71) - w21 * (w61 + w72) + w14 * w64 - w21 * w41
    w104 = 2 * upright2_theta_dot
    w105 = w40 - w97 * (w48 * w99) + w58 * (w48 * w59 - w55) + w96 * (w45 * w104) + w68 * (w53 - w45 * w69)
    w106 = w63 - w97 * (w54 * w99) + w58 * (w49 + w54 * w59) + w96 * (w52 * w104) - w68 * (w47 + w52 * w69)
    w107 = (w45 * w105 + w52 * w106) / w57
    w108 = w103 + w68 * ((w48 * w105 + w54 * w106) / w57 * c10 + w68 * (w45 * w71 - w51 * c20 + w52 * w72)) + w80 * w107
    w109 = w43 * w63
    w110 = w37 * w40
    w111 = w108 - w97 * w100 + w58 * (w14 * (w62 + w65) - w21 * (w60 - w38)) + w58 * (w109 - w110 + w107 * c12 + w58 * (w110 - w109 - w37 * gravity_y - w48 * w71 - w54 * w72))
    w112 = w0 * w9 + w2 * w12
    w113 = (w14 * w91 + w21 * w93) / w27
    w114 = w0 * (w12 * w82) - w2 * (w9 * w82)
    w115 = w79 + w33 * (w81 * ((w17 * w91 + w23 * w93) / w27) - w90 * w102 + w33 * w111) + w112 * w113 - w87 * w114
    w116 = w5 * w9
    w117 = w12 * w31
    w118 = w115 + w28 * (w0 * (w10 + w30) - w2 * (w77 - w75)) + w28 * (w116 - w117 + w113 * c14 + w28 * (w117 - w116 - w12 * gravity_y - w17 * w74 - w23 * w78))
    w119 = 2 * upright0_theta_dot
    w120 = w2 * w119
    w121 = w0 * w119
    w122 = 2 * -w87
    w123 = w0 * (w120 * top1_mass) - w2 * (w121 * top1_mass) + w33 * (w33 * w102 - w81 * (2 * -w90)) - w112 * w122
    # outputs
    J_q = ca.vertcat(w118)
    J_v = ca.vertcat(w123 + w28 * w114 + w28 * (w9 * w120 - w12 * w121 - w122 * c14))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 18) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 13) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 13) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 18)
    upright0_tip_x = p[11]
    top1_tip_x = p[12]
    upright1_tip_x = p[13]
    ground_foot1_x = p[14]
    top2_tip_x = p[15]
    upright2_tip_x = p[16]
    ground_foot2_x = p[17]
    # outputs
    positions = ca.SX(3, 13)
    positions[0, 0] = ground_foot1_x
    positions[0, 1] = ground_foot2_x
    positions[0, 4] = upright0_tip_x
    positions[0, 6] = top1_tip_x
    positions[0, 8] = upright1_tip_x
    positions[0, 10] = top2_tip_x
    positions[0, 12] = upright2_tip_x
    axes = ca.SX(9, 13)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
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
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[4, 7] = 1.0
    axes[4, 8] = 1.0
    axes[4, 9] = 1.0
    axes[4, 10] = 1.0
    axes[4, 11] = 1.0
    axes[4, 12] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
    axes[8, 7] = 1.0
    axes[8, 8] = 1.0
    axes[8, 9] = 1.0
    axes[8, 10] = 1.0
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
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "geometry": geometry,
}
