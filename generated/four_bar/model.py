"""Four-bar linkage: equations of motion, emitted by symgen from the scene `four_bar`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 crank.theta [rad]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 coupler.x [m], 3 coupler.y [m], 4 coupler.theta [rad], 5 rocker.x [m],
    6 rocker.y [m], 7 rocker.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 15) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    29 operations.
    """
    p = ca.SX.sym("p", 15)
    gravity_y = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    coupler_mass = p[4]
    coupler_inertia = p[5]
    coupler_center_of_mass_x = p[6]
    rocker_mass = p[7]
    rocker_inertia = p[8]
    rocker_center_of_mass_x = p[9]
    crank_tip_x = p[10]
    coupler_tip_x = p[11]
    rocker_tip_x = p[12]
    ground_right_x = p[13]
    motor_value = p[14]
    # intermediate terms (5)
    w0 = crank_inertia + crank_mass * crank_center_of_mass_x**2
    w1 = crank_tip_x * coupler_mass
    w2 = coupler_mass * coupler_center_of_mass_x
    w3 = crank_mass * crank_center_of_mass_x
    w4 = rocker_mass * rocker_center_of_mass_x
    # outputs
    c = ca.vertcat(
        crank_tip_x,  # crank_tip_x
        coupler_mass,  # coupler_mass
        w0 + crank_tip_x * w1,  # c2
        coupler_tip_x,  # coupler_tip_x
        rocker_tip_x,  # rocker_tip_x
        rocker_inertia + rocker_mass * rocker_center_of_mass_x**2,  # c5
        w2,  # c6
        coupler_inertia + coupler_mass * coupler_center_of_mass_x**2,  # c7
        gravity_y,  # gravity_y
        w3 * gravity_y,  # c9
        motor_value,  # motor_value
        coupler_mass * gravity_y,  # c11
        gravity_y * w4,  # c12
        ground_right_x,  # ground_right_x
        crank_mass,  # crank_mass
        w0,  # c15
        rocker_mass,  # rocker_mass
        w3,  # c17
        w4,  # c18
        crank_mass * gravity_y,  # c19
        rocker_mass * gravity_y,  # c20
        -gravity_y,  # c21
        coupler_inertia + coupler_center_of_mass_x * w2,  # c22
        rocker_inertia + rocker_center_of_mass_x * w4,  # c23
        coupler_center_of_mass_x * (coupler_mass * (2 * crank_tip_x)),  # c24
        w1 * coupler_center_of_mass_x,  # c25
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    89 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_mass = c[1]
    c2 = c[2]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c9 = c[9]
    motor_value = c[10]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (26)
    w0 = ca.cos(crank_theta)
    w1 = w0 * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = ca.sin(coupler_theta)
    w4 = w3 * coupler_tip_x
    w5 = ca.cos(coupler_theta)
    w6 = w5 * coupler_tip_x
    w7 = ca.cos(rocker_theta)
    w8 = w7 * rocker_tip_x
    w9 = ca.sin(rocker_theta) * rocker_tip_x
    w10 = w4 * w8 - w6 * w9
    w11 = (w1 * w4 - w2 * w6) / w10
    w12 = (w1 * w9 - w2 * w8) / w10
    w13 = w5 * c6
    w14 = w3 * c6
    w15 = w1 * w13 + w2 * w14
    w16 = coupler_theta_dot**2
    w17 = rocker_theta_dot**2
    w18 = crank_theta_dot**2
    w19 = w1 * w18
    w20 = w8 * w17 - w6 * w16 - w19
    w21 = w2 * w18
    w22 = w9 * w17 - w4 * w16 - w21
    w23 = (w8 * w20 + w9 * w22) / w10
    w24 = w0 * c9 + motor_value + w1 * (w14 * w16 + c11 - (w13 * w23 - w21 * coupler_mass)) - w2 * (w13 * w16 + (w19 * coupler_mass + w14 * w23))
    w25 = w24 + w11 * (w7 * c12 - (w6 * w20 + w4 * w22) / w10 * c5) + w12 * (w13 * gravity_y - (w14 * w19 - w13 * w21 + w23 * c7))
    # outputs
    M_hat = ca.vertcat(c2 + w11 * (w11 * c5) + (w12 * (w15 + w12 * c7) + w12 * w15))
    Q_hat = ca.vertcat(w25)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 2) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    30 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_tip_x = c[0]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    ground_right_x = c[13]
    # intermediate terms (9)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rocker_theta) * rocker_tip_x
    w3 = ca.cos(coupler_theta) * coupler_tip_x
    w4 = w2 + ground_right_x - (w0 + w3)
    w5 = ca.sin(rocker_theta) * rocker_tip_x
    w6 = ca.sin(coupler_theta) * coupler_tip_x
    w7 = w5 - (w1 + w6)
    w8 = w2 * w6 - w3 * w5
    # outputs
    q_d_next = ca.SX(8, 1)
    q_d_next[2] = w0  # coupler.x
    q_d_next[3] = w1  # coupler.y
    q_d_next[4] = coupler_theta - (w2 * w4 + w5 * w7) / w8  # coupler.theta
    q_d_next[5] = ground_right_x  # rocker.x
    q_d_next[7] = rocker_theta - (w3 * w4 + w6 * w7) / w8  # rocker.theta
    C_loop = ca.vertcat(w4, w7)
    det_loop = ca.vertcat(w8)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    28 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    crank_tip_x = c[0]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    # intermediate terms (7)
    w0 = ca.sin(crank_theta) * crank_tip_x
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(rocker_theta) * rocker_tip_x
    w3 = ca.cos(rocker_theta) * rocker_tip_x
    w4 = ca.sin(coupler_theta) * coupler_tip_x
    w5 = ca.cos(coupler_theta) * coupler_tip_x
    w6 = w3 * w4 - w2 * w5
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[2] = -(w0 * crank_theta_dot)  # coupler.x
    q_d_dot[3] = crank_theta_dot * w1  # coupler.y
    q_d_dot[4] = crank_theta_dot * ((w1 * w2 - w0 * w3) / w6)  # coupler.theta
    q_d_dot[7] = crank_theta_dot * ((w1 * w4 - w0 * w5) / w6)  # rocker.theta
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    53 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_i_ddot[0]
    crank_tip_x = c[0]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    # intermediate terms (14)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = w0 * w1
    w3 = ca.sin(crank_theta) * crank_tip_x
    w4 = w0 * w3
    w5 = ca.cos(rocker_theta) * rocker_tip_x
    w6 = rocker_theta_dot**2
    w7 = coupler_theta_dot**2
    w8 = ca.cos(coupler_theta) * coupler_tip_x
    w9 = w5 * w6 - w7 * w8 - w2
    w10 = ca.sin(rocker_theta) * rocker_tip_x
    w11 = ca.sin(coupler_theta) * coupler_tip_x
    w12 = w6 * w10 - w7 * w11 - w4
    w13 = w5 * w11 - w8 * w10
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[2] = -(w2 + w3 * crank_theta_ddot)  # coupler.x
    q_d_ddot[3] = w1 * crank_theta_ddot - w4  # coupler.y
    q_d_ddot[4] = (w5 * w9 + w10 * w12) / w13 + crank_theta_ddot * ((w1 * w10 - w3 * w5) / w13)  # coupler.theta
    q_d_ddot[7] = (w8 * w9 + w11 * w12) / w13 + crank_theta_ddot * ((w1 * w11 - w3 * w8) / w13)  # rocker.theta
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 9) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    39 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 26)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[6]
    rocker_y = q[7]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    crank_tip_x = c[0]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    ground_right_x = c[13]
    # intermediate terms (9)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rocker_theta) * rocker_tip_x
    w3 = ca.cos(coupler_theta) * coupler_tip_x
    w4 = ca.sin(rocker_theta) * rocker_tip_x
    w5 = ca.sin(coupler_theta) * coupler_tip_x
    w6 = crank_theta_dot**2
    w7 = rocker_theta_dot**2
    w8 = coupler_theta_dot**2
    # outputs
    C = ca.vertcat(
        crank_x,  # A.x
        crank_y,  # A.y
        coupler_x - (crank_x + w0),  # B.x
        coupler_y - (crank_y + w1),  # B.y
        rocker_x + w2 - (coupler_x + w3),  # C.x
        rocker_y + w4 - (coupler_y + w5),  # C.y
        rocker_x - ground_right_x,  # D.x
        rocker_y,  # D.y
    )
    C_q = ca.SX(8, 9)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    # C.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w5
    C_q[4, 6] = 1.0
    C_q[4, 8] = -w4
    # C.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w3
    C_q[5, 7] = 1.0
    C_q[5, 8] = w2
    # D.x
    C_q[6, 6] = 1.0
    # D.y
    C_q[7, 7] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[2] = -(w0 * w6)  # B.x
    gamma[3] = -(w1 * w6)  # B.y
    gamma[4] = w2 * w7 - w3 * w8  # C.x
    gamma[5] = w4 * w7 - w5 * w8  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 9 x 9) [SI]: mass matrix in all coordinates
    gives K (n x n = 9 x 9) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 9) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 9) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 9) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 9) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    50 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 26)
    crank_theta = q[2]
    coupler_theta = q[5]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    crank_tip_x = c[0]
    coupler_mass = c[1]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    motor_value = c[10]
    c11 = c[11]
    crank_mass = c[14]
    c15 = c[15]
    rocker_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (33)
    w0 = ca.sin(crank_theta)
    w1 = w0 * c17
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c17
    w5 = ca.sin(coupler_theta)
    w6 = w5 * c6
    w7 = -w6
    w8 = ca.cos(coupler_theta)
    w9 = w8 * c6
    w10 = ca.sin(rocker_theta)
    w11 = w10 * c18
    w12 = -w11
    w13 = ca.cos(rocker_theta)
    w14 = w13 * c18
    w15 = crank_theta_dot**2
    w16 = w4 * w15
    w17 = w1 * w15
    w18 = coupler_theta_dot**2
    w19 = w9 * w18
    w20 = w6 * w18
    w21 = rocker_theta_dot**2
    w22 = w14 * w21
    w23 = w11 * w21
    w24 = motor_value + w4 * gravity_y
    w25 = w9 * gravity_y
    w26 = w14 * gravity_y
    w27 = w0 * crank_tip_x
    w28 = w3 * crank_tip_x
    w29 = w5 * coupler_tip_x
    w30 = w8 * coupler_tip_x
    w31 = w10 * rocker_tip_x
    w32 = w13 * rocker_tip_x
    # outputs
    M = ca.SX(9, 9)
    # crank.x
    M[0, 0] = crank_mass
    M[0, 2] = w2
    # crank.y
    M[1, 1] = crank_mass
    M[1, 2] = w4
    # crank.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c15
    # coupler.x
    M[3, 3] = coupler_mass
    M[3, 5] = w7
    # coupler.y
    M[4, 4] = coupler_mass
    M[4, 5] = w9
    # coupler.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c7
    # rocker.x
    M[6, 6] = rocker_mass
    M[6, 8] = w12
    # rocker.y
    M[7, 7] = rocker_mass
    M[7, 8] = w14
    # rocker.theta
    M[8, 6] = w12
    M[8, 7] = w14
    M[8, 8] = c5
    K = ca.SX(9, 9)
    Q_v = ca.vertcat(
        w16,  # crank.x
        w17,  # crank.y
        0.0,  # crank.theta
        w19,  # coupler.x
        w20,  # coupler.y
        0.0,  # coupler.theta
        w22,  # rocker.x
        w23,  # rocker.y
        0.0,  # rocker.theta
    )
    Q_F = ca.vertcat(
        0.0,  # crank.x
        c19,  # crank.y
        w24,  # crank.theta
        0.0,  # coupler.x
        c11,  # coupler.y
        w25,  # coupler.theta
        0.0,  # rocker.x
        c20,  # rocker.y
        w26,  # rocker.theta
    )
    Q_star = ca.vertcat(
        w16,  # crank.x
        w17 + c19,  # crank.y
        w24,  # crank.theta
        w19,  # coupler.x
        c11 + w20,  # coupler.y
        w25,  # coupler.theta
        w22,  # rocker.x
        w23 + c20,  # rocker.y
        w26,  # rocker.theta
    )
    C_q = ca.SX(8, 9)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w27
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w28
    C_q[3, 4] = 1.0
    # C.x
    C_q[4, 3] = -1.0
    C_q[4, 5] = w29
    C_q[4, 6] = 1.0
    C_q[4, 8] = -w31
    # C.y
    C_q[5, 4] = -1.0
    C_q[5, 5] = -w30
    C_q[5, 7] = 1.0
    C_q[5, 8] = w32
    # D.x
    C_q[6, 6] = 1.0
    # D.y
    C_q[7, 7] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w15 * w28)  # B.x
    gamma[3] = -(w15 * w27)  # B.y
    gamma[4] = w21 * w32 - w18 * w30  # C.x
    gamma[5] = w21 * w31 - w18 * w29  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes q_ddot (n = 9) [mixed]: accelerations of all coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    91 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 26)
    crank_theta = q[2]
    coupler_theta = q[5]
    rocker_theta = q[8]
    crank_theta_dot = q_dot[2]
    coupler_theta_dot = q_dot[5]
    rocker_theta_dot = q_dot[8]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    coupler_x_ddot = q_ddot[3]
    coupler_y_ddot = q_ddot[4]
    coupler_theta_ddot = q_ddot[5]
    rocker_x_ddot = q_ddot[6]
    rocker_y_ddot = q_ddot[7]
    rocker_theta_ddot = q_ddot[8]
    coupler_mass = c[1]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c11 = c[11]
    crank_mass = c[14]
    rocker_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    # intermediate terms (28)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c17
    w2 = ca.sin(crank_theta) * c17
    w3 = coupler_theta_dot**2
    w4 = ca.cos(coupler_theta)
    w5 = w4 * c6
    w6 = ca.sin(coupler_theta)
    w7 = w6 * c6
    w8 = ca.cos(rocker_theta)
    w9 = w8 * rocker_tip_x
    w10 = w5 * gravity_y - (w5 * coupler_y_ddot - coupler_x_ddot * w7 + coupler_theta_ddot * c7)
    w11 = w4 * coupler_tip_x
    w12 = w8 * c18
    w13 = ca.sin(rocker_theta)
    w14 = w13 * c18
    w15 = w12 * gravity_y - (w12 * rocker_y_ddot - w14 * rocker_x_ddot + rocker_theta_ddot * c5)
    w16 = w6 * coupler_tip_x
    w17 = w13 * rocker_tip_x
    w18 = w9 * w16 - w11 * w17
    w19 = (w9 * w10 + w11 * w15) / w18
    w20 = w3 * w5 - (coupler_x_ddot * coupler_mass - w7 * coupler_theta_ddot) + w19
    w21 = w0 * w1 - (crank_x_ddot * crank_mass - w2 * crank_theta_ddot) + w20
    w22 = (w10 * w17 + w15 * w16) / w18
    w23 = c11 + w3 * w7 - (coupler_y_ddot * coupler_mass + w5 * coupler_theta_ddot) + w22
    w24 = c19 + w0 * w2 - (crank_y_ddot * crank_mass + w1 * crank_theta_ddot) + w23
    w25 = rocker_theta_dot**2
    w26 = w12 * w25 - (rocker_x_ddot * rocker_mass - w14 * rocker_theta_ddot) - w19
    w27 = c20 + w14 * w25 - (rocker_y_ddot * rocker_mass + w12 * rocker_theta_ddot) - w22
    # outputs
    lam = ca.vertcat(
        w21,  # A.x
        w24,  # A.y
        w20,  # B.x
        w23,  # B.y
        w19,  # C.x
        w22,  # C.y
        w26,  # D.x
        w27,  # D.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w21, -w24, 0.0),  # A
        ca.vertcat(-w20, -w23, 0.0),  # B
        ca.vertcat(-w19, -w22, 0.0),  # C
        ca.vertcat(-w26, -w27, 0.0),  # D
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    73 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 26)
    crank_y = q[1]
    crank_theta = q[2]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_y = q[7]
    rocker_theta = q[8]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    coupler_x_dot = q_dot[3]
    coupler_y_dot = q_dot[4]
    coupler_theta_dot = q_dot[5]
    rocker_x_dot = q_dot[6]
    rocker_y_dot = q_dot[7]
    rocker_theta_dot = q_dot[8]
    coupler_mass = c[1]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    motor_value = c[10]
    crank_mass = c[14]
    c15 = c[15]
    rocker_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    c21 = c[21]
    # intermediate terms (11)
    w0 = ca.sin(crank_theta) * c17
    w1 = ca.cos(crank_theta) * c17
    w2 = crank_x_dot * (crank_x_dot * crank_mass - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * crank_mass + crank_theta_dot * w1)
    w3 = ca.sin(coupler_theta) * c6
    w4 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c15) + coupler_x_dot * (coupler_x_dot * coupler_mass - w3 * coupler_theta_dot)
    w5 = ca.cos(coupler_theta) * c6
    w6 = w4 + coupler_y_dot * (coupler_y_dot * coupler_mass + coupler_theta_dot * w5) + coupler_theta_dot * (coupler_y_dot * w5 - coupler_x_dot * w3 + coupler_theta_dot * c7)
    w7 = ca.sin(rocker_theta) * c18
    w8 = ca.cos(rocker_theta) * c18
    w9 = w6 + rocker_x_dot * (rocker_x_dot * rocker_mass - w7 * rocker_theta_dot) + rocker_y_dot * (rocker_y_dot * rocker_mass + rocker_theta_dot * w8)
    w10 = (w0 + crank_y * crank_mass + (w3 + coupler_y * coupler_mass) + (w7 + rocker_y * rocker_mass)) * c21
    # outputs
    kinetic = ca.vertcat(
        (w9 + rocker_theta_dot * (rocker_y_dot * w8 - rocker_x_dot * w7 + rocker_theta_dot * c5)) / 2.0,
    )
    elastic = ca.SX(1, 1)
    potential = ca.vertcat(w10)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.vertcat(crank_theta_dot * motor_value)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3) [N, N m]: world force and moment of a load on its marker, or b
    0 operations.
    """
    c = ca.SX.sym("c", 26)
    motor_value = c[10]
    # outputs
    load_actions = ca.vertcat(0.0, 0.0, motor_value)
    inputs, outputs = [c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 3) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    9 operations.
    """
    q = ca.SX.sym("q", 9)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    coupler_x = q[3]
    coupler_y = q[4]
    coupler_theta = q[5]
    rocker_x = q[6]
    rocker_y = q[7]
    rocker_theta = q[8]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(coupler_theta)
    w3 = ca.sin(coupler_theta)
    w4 = ca.cos(rocker_theta)
    w5 = ca.sin(rocker_theta)
    # outputs
    poses = ca.SX(12, 3)
    poses[0, 0] = crank_x
    poses[0, 1] = coupler_x
    poses[0, 2] = rocker_x
    poses[1, 0] = crank_y
    poses[1, 1] = coupler_y
    poses[1, 2] = rocker_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[3, 2] = w4
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[4, 2] = w5
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[6, 2] = -w5
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[7, 2] = w4
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    poses[11, 2] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    190 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_mass = c[1]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c9 = c[9]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (52)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = crank_theta_dot**2
    w2 = w0 * w1
    w3 = w2 * coupler_mass
    w4 = ca.sin(crank_theta)
    w5 = coupler_theta_dot**2
    w6 = ca.cos(coupler_theta)
    w7 = w6 * c6
    w8 = w5 * w7
    w9 = ca.sin(coupler_theta)
    w10 = w9 * c6
    w11 = ca.cos(rocker_theta)
    w12 = w11 * rocker_tip_x
    w13 = rocker_theta_dot**2
    w14 = w12 * w13
    w15 = w6 * coupler_tip_x
    w16 = w5 * w15
    w17 = w14 - w16 - w2
    w18 = ca.sin(rocker_theta)
    w19 = w18 * rocker_tip_x
    w20 = w13 * w19
    w21 = w9 * coupler_tip_x
    w22 = w5 * w21
    w23 = w4 * crank_tip_x
    w24 = w1 * w23
    w25 = w20 - w22 - w24
    w26 = w12 * w21 - w15 * w19
    w27 = (w12 * w17 + w19 * w25) / w26
    w28 = w10 * w27
    w29 = w7 * gravity_y - (w2 * w10 - w7 * w24 + w27 * c7)
    w30 = (w15 * w17 + w21 * w25) / w26
    w31 = w11 * c12 - w30 * c5
    w32 = (w12 * w29 + w15 * w31) / w26
    w33 = w5 * w10
    w34 = w7 * w27
    w35 = w24 * coupler_mass
    w36 = (w19 * w29 + w21 * w31) / w26
    w37 = w0 * w3 - (w4 * c9 + w0 * (w8 + (w3 + w28) + w32) + w23 * (c11 + w33 - (w34 - w35) + w36)) + w23 * w35
    w38 = (w0 * w21 - w15 * w23) / w26
    w39 = (w0 * w19 - w12 * w23) / w26
    w40 = 2 * coupler_theta_dot
    w41 = w0 * crank_theta_dot + w39 * (coupler_theta_dot * w15) - w38 * (w12 * rocker_theta_dot)
    w42 = crank_theta_dot * w23 + w39 * (coupler_theta_dot * w21) - w38 * (rocker_theta_dot * w19)
    w43 = (w12 * w41 + w19 * w42) / w26
    w44 = 2 * rocker_theta_dot
    w45 = (w15 * w41 + w21 * w42) / w26
    w46 = (w15 * w27 - w22) * w39 - (w24 + w15 * w40 * w43) + w12 * w44 * w45 + w38 * (w20 - w12 * w30)
    w47 = w2 - w43 * (w21 * w40) + w39 * (w16 + w21 * w27) + w45 * (w19 * w44) - w38 * (w14 + w19 * w30)
    w48 = (w12 * w46 + w19 * w47) / w26
    w49 = w37 + w38 * ((w15 * w46 + w21 * w47) / w26 * c5 + w38 * (w12 * w32 - w18 * c12 + w19 * w36)) + (w0 * w7 + w10 * w23) * w48
    w50 = w2 * w7 + w10 * w24
    w51 = w49 - w43 * (w0 * (w10 * w40) - w23 * (w7 * w40)) + w39 * (w0 * (w8 + w28) - w23 * (w34 - w33)) + w39 * (w50 + w48 * c7 - w39 * (w50 + w10 * gravity_y + w15 * w32 + w21 * w36))
    # outputs
    dQ_hat_dq_i = ca.vertcat(w51)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    64 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_tip_x = c[0]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    # intermediate terms (18)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(rocker_theta) * rocker_tip_x
    w2 = ca.cos(rocker_theta) * rocker_tip_x
    w3 = ca.sin(crank_theta) * crank_tip_x
    w4 = ca.sin(coupler_theta) * coupler_tip_x
    w5 = ca.cos(coupler_theta) * coupler_tip_x
    w6 = w2 * w4 - w1 * w5
    w7 = (w0 * w1 - w2 * w3) / w6
    w8 = 2 * coupler_theta_dot * w7
    w9 = (w0 * w4 - w3 * w5) / w6
    w10 = 2 * rocker_theta_dot * w9
    w11 = 2 * crank_theta_dot
    w12 = w2 * w10 - w5 * w8 - w0 * w11
    w13 = w1 * w10 - w4 * w8 - w3 * w11
    w14 = (w2 * w12 + w1 * w13) / w6
    w15 = coupler_theta - crank_theta
    w16 = ca.sin(w15) * c24
    w17 = w16 * (coupler_theta_dot * w7) - w16 * (w7 * crank_theta_dot) - w7 * w14 * c22 - w9 * ((w5 * w12 + w4 * w13) / w6) * c23
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w17 - w14 * (ca.cos(w15) * c25))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 26) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    225 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 26)
    crank_theta = q_i[0]
    coupler_theta = q_d[4]
    rocker_theta = q_d[7]
    crank_theta_dot = q_i_dot[0]
    coupler_theta_dot = q_d_dot[4]
    rocker_theta_dot = q_d_dot[7]
    crank_theta_ddot = q_i_ddot[0]
    crank_tip_x = c[0]
    coupler_mass = c[1]
    coupler_tip_x = c[3]
    rocker_tip_x = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c9 = c[9]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (62)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta)
    w2 = w1 * crank_tip_x
    w3 = crank_theta_dot**2
    w4 = w0 * w3
    w5 = crank_theta_ddot * w2 + w4
    w6 = w5 * coupler_mass
    w7 = coupler_theta_dot**2
    w8 = ca.cos(coupler_theta)
    w9 = w8 * c6
    w10 = w7 * w9
    w11 = ca.sin(coupler_theta)
    w12 = w11 * c6
    w13 = ca.cos(rocker_theta)
    w14 = w13 * rocker_tip_x
    w15 = rocker_theta_dot**2
    w16 = w14 * w15
    w17 = w8 * coupler_tip_x
    w18 = w7 * w17
    w19 = w16 - w18 - w4
    w20 = ca.sin(rocker_theta)
    w21 = w20 * rocker_tip_x
    w22 = w15 * w21
    w23 = w11 * coupler_tip_x
    w24 = w7 * w23
    w25 = w2 * w3
    w26 = w22 - w24 - w25
    w27 = w14 * w23 - w17 * w21
    w28 = (w0 * w21 - w2 * w14) / w27
    w29 = (w14 * w19 + w21 * w26) / w27 + crank_theta_ddot * w28
    w30 = w12 * w29
    w31 = w0 * crank_theta_ddot - w25
    w32 = w9 * gravity_y - (w9 * w31 + w5 * w12 + w29 * c7)
    w33 = (w0 * w23 - w2 * w17) / w27
    w34 = (w17 * w19 + w23 * w26) / w27 + crank_theta_ddot * w33
    w35 = w13 * c12 - w34 * c5
    w36 = (w14 * w32 + w17 * w35) / w27
    w37 = w7 * w12
    w38 = w31 * coupler_mass
    w39 = w9 * w29
    w40 = (w21 * w32 + w23 * w35) / w27
    w41 = w0 * w6 - (w1 * c9 + w0 * (w10 + (w6 + w30) + w36) + w2 * (c11 + w37 - (w38 + w39) + w40)) - w2 * w38
    w42 = 2 * coupler_theta_dot
    w43 = w0 * crank_theta_dot + w28 * (coupler_theta_dot * w17) - w33 * (w14 * rocker_theta_dot)
    w44 = w2 * crank_theta_dot + w28 * (coupler_theta_dot * w23) - w33 * (rocker_theta_dot * w21)
    w45 = (w14 * w43 + w21 * w44) / w27
    w46 = 2 * rocker_theta_dot
    w47 = (w17 * w43 + w23 * w44) / w27
    w48 = w31 - w17 * w42 * w45 + w28 * (w17 * w29 - w24) + w14 * w46 * w47 + w33 * (w22 - w14 * w34)
    w49 = w5 - w45 * (w23 * w42) + w28 * (w18 + w23 * w29) + w47 * (w21 * w46) - w33 * (w16 + w21 * w34)
    w50 = w0 * w9 + w2 * w12
    w51 = (w14 * w48 + w21 * w49) / w27
    w52 = w41 + w33 * ((w17 * w48 + w23 * w49) / w27 * c5 + w33 * (w14 * w36 - w20 * c12 + w21 * w40)) + w50 * w51
    w53 = w0 * (w12 * w42) - w2 * (w9 * w42)
    w54 = w5 * w9
    w55 = w12 * w31
    w56 = w52 - w45 * w53 + w28 * (w0 * (w10 + w30) - w2 * (w39 - w37)) + w28 * (w54 - w55 + w51 * c7 + w28 * (w55 - w54 - w12 * gravity_y - w17 * w36 - w23 * w40))
    w57 = 2 * crank_theta_dot
    w58 = w2 * w57
    w59 = w0 * w57
    w60 = 2 * -w45
    w61 = w0 * (w58 * coupler_mass) - w2 * (w59 * coupler_mass) - w33 * (2 * -w47 * c5) - w50 * w60 + w28 * w53
    # outputs
    J_q = ca.vertcat(w56)
    J_v = ca.vertcat(w61 + w28 * (w9 * w58 - w12 * w59 - w60 * c7))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 15) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 8) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 8) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 15)
    crank_tip_x = p[10]
    coupler_tip_x = p[11]
    rocker_tip_x = p[12]
    ground_right_x = p[13]
    # outputs
    positions = ca.SX(3, 8)
    positions[0, 1] = ground_right_x
    positions[0, 3] = crank_tip_x
    positions[0, 5] = coupler_tip_x
    positions[0, 7] = rocker_tip_x
    axes = ca.SX(9, 8)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[0, 7] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[4, 7] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
    axes[8, 7] = 1.0
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
    "geometry": geometry,
}
