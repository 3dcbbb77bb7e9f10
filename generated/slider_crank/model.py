"""Rigid slider-crank: equations of motion, emitted by symgen from the scene `slider_crank`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 crank.theta [rad]

q_d, the dependent coordinates by index:
    0 crank.x [m], 1 crank.y [m], 2 rod.x [m], 3 rod.y [m], 4 rod.theta [rad], 5 slider.x [m],
    6 slider.y [m], 7 slider.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 11) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    15 operations.
    """
    p = ca.SX.sym("p", 11)
    gravity_y = p[0]
    crank_mass = p[1]
    crank_inertia = p[2]
    crank_center_of_mass_x = p[3]
    rod_mass = p[4]
    rod_inertia = p[5]
    rod_center_of_mass_x = p[6]
    slider_mass = p[7]
    slider_inertia = p[8]
    crank_tip_x = p[9]
    rod_tip_x = p[10]
    # intermediate terms (2)
    w0 = crank_mass * crank_center_of_mass_x
    w1 = w0 * gravity_y
    # outputs
    c = ca.vertcat(
        crank_inertia + crank_mass * crank_center_of_mass_x**2,  # c0
        crank_tip_x,  # crank_tip_x
        rod_mass,  # rod_mass
        slider_mass,  # slider_mass
        rod_mass + slider_mass,  # c4
        rod_tip_x,  # rod_tip_x
        rod_mass * rod_center_of_mass_x,  # c6
        rod_inertia + rod_mass * rod_center_of_mass_x**2,  # c7
        gravity_y,  # gravity_y
        w1,  # c9
        rod_mass * gravity_y,  # c10
        crank_mass,  # crank_mass
        w0,  # c12
        slider_inertia,  # slider_inertia
        crank_mass * gravity_y,  # c14
        slider_mass * gravity_y,  # c15
        -gravity_y,  # c16
        -w1,  # c17
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    70 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c9 = c[9]
    c10 = c[10]
    # intermediate terms (19)
    w0 = ca.cos(crank_theta)
    w1 = w0 * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = ca.cos(rod_theta)
    w4 = w3 * rod_tip_x
    w5 = w1 / w4
    w6 = w3 * c6
    w7 = ca.sin(rod_theta)
    w8 = w7 * c6
    w9 = w7 * rod_tip_x
    w10 = w9 * slider_mass
    w11 = w1 * w6 + w2 * (w8 + w10)
    w12 = rod_theta_dot**2
    w13 = crank_theta_dot**2
    w14 = w2 * w13
    w15 = (w9 * w12 + w14) / w4
    w16 = w1 * w13
    w17 = (w16 + w4 * w12 + w9 * w15) * slider_mass
    w18 = w0 * c9 + w1 * (w8 * w12 + c10 - (w6 * w15 - w14 * rod_mass)) - w2 * (w6 * w12 + (w16 * rod_mass + w8 * w15) + w17)
    # outputs
    M_hat = ca.vertcat(c0 + w1 * (w1 * rod_mass) + w2 * (w2 * c4) - (w5 * (w11 - w5 * (c7 + w9 * w10)) + w5 * w11))
    Q_hat = ca.vertcat(w18 - w5 * (w6 * gravity_y - (w8 * w16 - w6 * w14 + w15 * c7) - w9 * w17))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    16 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_tip_x = c[1]
    rod_tip_x = c[5]
    # intermediate terms (5)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = w1 + ca.sin(rod_theta) * rod_tip_x
    w3 = ca.cos(rod_theta) * rod_tip_x
    w4 = rod_theta - w2 / w3
    # outputs
    q_d_next = ca.SX(8, 1)
    q_d_next[2] = w0  # rod.x
    q_d_next[3] = w1  # rod.y
    q_d_next[4] = w4  # rod.theta
    q_d_next[5] = w0 + ca.cos(w4) * rod_tip_x  # slider.x
    C_loop = ca.vertcat(-w2)
    det_loop = ca.vertcat(-w3)
    inputs, outputs = [q_i, q_d, c], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    16 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    crank_tip_x = c[1]
    rod_tip_x = c[5]
    # intermediate terms (3)
    w0 = ca.sin(crank_theta) * crank_tip_x * crank_theta_dot
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = crank_theta_dot * (w1 / (ca.cos(rod_theta) * rod_tip_x))
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[2] = -w0  # rod.x
    q_d_dot[3] = crank_theta_dot * w1  # rod.y
    q_d_dot[4] = -w2  # rod.theta
    q_d_dot[5] = w2 * (ca.sin(rod_theta) * rod_tip_x) - w0  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    28 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    crank_tip_x = c[1]
    rod_tip_x = c[5]
    # intermediate terms (9)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * crank_tip_x
    w2 = ca.sin(crank_theta) * crank_tip_x
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w0 * w2
    w5 = rod_theta_dot**2
    w6 = ca.sin(rod_theta) * rod_tip_x
    w7 = ca.cos(rod_theta) * rod_tip_x
    w8 = (w4 + w5 * w6) / w7 - crank_theta_ddot * (w1 / w7)
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[2] = -w3  # rod.x
    q_d_ddot[3] = w1 * crank_theta_ddot - w4  # rod.y
    q_d_ddot[4] = w8  # rod.theta
    q_d_ddot[5] = -(w3 + w5 * w7 + w6 * w8)  # slider.x
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 9) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    28 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[6]
    slider_y = q[7]
    slider_theta = q[8]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    crank_tip_x = c[1]
    rod_tip_x = c[5]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta) * crank_tip_x
    w2 = ca.cos(rod_theta) * rod_tip_x
    w3 = ca.sin(rod_theta) * rod_tip_x
    w4 = crank_theta_dot**2
    w5 = rod_theta_dot**2
    # outputs
    C = ca.vertcat(
        crank_x,  # A.x
        crank_y,  # A.y
        rod_x - (crank_x + w0),  # B.x
        rod_y - (crank_y + w1),  # B.y
        slider_y,  # slide.normal
        slider_theta,  # slide.angle
        slider_x - (rod_x + w2),  # C.x
        slider_y - (rod_y + w3),  # C.y
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
    # slide.normal
    C_q[4, 7] = 1.0
    # slide.angle
    C_q[5, 8] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w3
    C_q[6, 6] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w2
    C_q[7, 7] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[2] = -(w0 * w4)  # B.x
    gamma[3] = -(w1 * w4)  # B.y
    gamma[6] = -(w2 * w5)  # C.x
    gamma[7] = -(w3 * w5)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 9 x 9) [SI]: mass matrix in all coordinates
    gives K (n x n = 9 x 9) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 9) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 9) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 9) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 9) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    34 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_theta = q[2]
    rod_theta = q[5]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    c0 = c[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c10 = c[10]
    crank_mass = c[11]
    c12 = c[12]
    slider_inertia = c[13]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (22)
    w0 = ca.sin(crank_theta)
    w1 = w0 * c12
    w2 = -w1
    w3 = ca.cos(crank_theta)
    w4 = w3 * c12
    w5 = ca.sin(rod_theta)
    w6 = w5 * c6
    w7 = -w6
    w8 = ca.cos(rod_theta)
    w9 = w8 * c6
    w10 = crank_theta_dot**2
    w11 = w4 * w10
    w12 = w1 * w10
    w13 = rod_theta_dot**2
    w14 = w9 * w13
    w15 = w6 * w13
    w16 = w4 * gravity_y
    w17 = w9 * gravity_y
    w18 = w0 * crank_tip_x
    w19 = w3 * crank_tip_x
    w20 = w5 * rod_tip_x
    w21 = w8 * rod_tip_x
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
    M[2, 2] = c0
    # rod.x
    M[3, 3] = rod_mass
    M[3, 5] = w7
    # rod.y
    M[4, 4] = rod_mass
    M[4, 5] = w9
    # rod.theta
    M[5, 3] = w7
    M[5, 4] = w9
    M[5, 5] = c7
    # slider.x
    M[6, 6] = slider_mass
    # slider.y
    M[7, 7] = slider_mass
    # slider.theta
    M[8, 8] = slider_inertia
    K = ca.SX(9, 9)
    Q_v = ca.SX(9, 1)
    Q_v[0] = w11  # crank.x
    Q_v[1] = w12  # crank.y
    Q_v[3] = w14  # rod.x
    Q_v[4] = w15  # rod.y
    Q_F = ca.SX(9, 1)
    Q_F[1] = c14  # crank.y
    Q_F[2] = w16  # crank.theta
    Q_F[4] = c10  # rod.y
    Q_F[5] = w17  # rod.theta
    Q_F[7] = c15  # slider.y
    Q_star = ca.vertcat(
        w11,  # crank.x
        w12 + c14,  # crank.y
        w16,  # crank.theta
        w14,  # rod.x
        c10 + w15,  # rod.y
        w17,  # rod.theta
        0.0,  # slider.x
        c15,  # slider.y
        0.0,  # slider.theta
    )
    C_q = ca.SX(8, 9)
    # A.x
    C_q[0, 0] = 1.0
    # A.y
    C_q[1, 1] = 1.0
    # B.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w18
    C_q[2, 3] = 1.0
    # B.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w19
    C_q[3, 4] = 1.0
    # slide.normal
    C_q[4, 7] = 1.0
    # slide.angle
    C_q[5, 8] = 1.0
    # C.x
    C_q[6, 3] = -1.0
    C_q[6, 5] = w20
    C_q[6, 6] = 1.0
    # C.y
    C_q[7, 4] = -1.0
    C_q[7, 5] = -w21
    C_q[7, 7] = 1.0
    gamma = ca.SX(8, 1)
    gamma[2] = -(w10 * w19)  # B.x
    gamma[3] = -(w10 * w18)  # B.y
    gamma[6] = -(w13 * w21)  # C.x
    gamma[7] = -(w13 * w20)  # C.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes q_ddot (n = 9) [mixed]: accelerations of all coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    61 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 18)
    crank_theta = q[2]
    rod_theta = q[5]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    slider_x_ddot = q_ddot[6]
    slider_y_ddot = q_ddot[7]
    slider_theta_ddot = q_ddot[8]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c10 = c[10]
    crank_mass = c[11]
    c12 = c[12]
    slider_inertia = c[13]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (17)
    w0 = crank_theta_dot**2
    w1 = ca.cos(crank_theta) * c12
    w2 = ca.sin(crank_theta) * c12
    w3 = rod_theta_dot**2
    w4 = ca.cos(rod_theta)
    w5 = w4 * c6
    w6 = ca.sin(rod_theta)
    w7 = w6 * c6
    w8 = slider_x_ddot * slider_mass
    w9 = w3 * w5 - (rod_x_ddot * rod_mass - w7 * rod_theta_ddot) - w8
    w10 = w0 * w1 - (crank_x_ddot * crank_mass - w2 * crank_theta_ddot) + w9
    w11 = w5 * gravity_y - (w5 * rod_y_ddot - rod_x_ddot * w7 + rod_theta_ddot * c7) + w8 * (w6 * rod_tip_x)
    w12 = w11 / (w4 * rod_tip_x)
    w13 = c10 + w3 * w7 - (rod_y_ddot * rod_mass + w5 * rod_theta_ddot) - w12
    w14 = c14 + w0 * w2 - (crank_y_ddot * crank_mass + w1 * crank_theta_ddot) + w13
    w15 = w12 + (c15 - slider_y_ddot * slider_mass)
    w16 = slider_theta_ddot * slider_inertia
    # outputs
    lam = ca.vertcat(
        w10,  # A.x
        w14,  # A.y
        w9,  # B.x
        w13,  # B.y
        w15,  # slide.normal
        -w16,  # slide.angle
        -w8,  # C.x
        -w12,  # C.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w10, -w14, 0.0),  # A
        ca.vertcat(-w9, -w13, 0.0),  # B
        ca.vertcat(0.0, -w15, w16),  # slide
        ca.vertcat(w8, w12, 0.0),  # C
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    59 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 18)
    crank_y = q[1]
    crank_theta = q[2]
    rod_y = q[4]
    rod_theta = q[5]
    slider_y = q[7]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    slider_x_dot = q_dot[6]
    slider_y_dot = q_dot[7]
    slider_theta_dot = q_dot[8]
    c0 = c[0]
    rod_mass = c[2]
    slider_mass = c[3]
    c6 = c[6]
    c7 = c[7]
    crank_mass = c[11]
    c12 = c[12]
    slider_inertia = c[13]
    c15 = c[15]
    c16 = c[16]
    # intermediate terms (8)
    w0 = ca.sin(crank_theta) * c12
    w1 = ca.cos(crank_theta) * c12
    w2 = crank_x_dot * (crank_x_dot * crank_mass - w0 * crank_theta_dot) + crank_y_dot * (crank_y_dot * crank_mass + crank_theta_dot * w1)
    w3 = ca.sin(rod_theta) * c6
    w4 = w2 + crank_theta_dot * (crank_y_dot * w1 - crank_x_dot * w0 + crank_theta_dot * c0) + rod_x_dot * (rod_x_dot * rod_mass - w3 * rod_theta_dot)
    w5 = ca.cos(rod_theta) * c6
    w6 = w4 + rod_y_dot * (rod_y_dot * rod_mass + rod_theta_dot * w5) + rod_theta_dot * (rod_y_dot * w5 - rod_x_dot * w3 + rod_theta_dot * c7)
    w7 = w6 + slider_x_dot * (slider_x_dot * slider_mass) + slider_y_dot * (slider_y_dot * slider_mass) + slider_theta_dot * (slider_theta_dot * slider_inertia)
    # outputs
    kinetic = ca.vertcat(w7 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w0 + crank_y * crank_mass + (w3 + rod_y * rod_mass)) * c16 - slider_y * c15)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


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
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    slider_x = q[6]
    slider_y = q[7]
    slider_theta = q[8]
    # intermediate terms (6)
    w0 = ca.cos(crank_theta)
    w1 = ca.sin(crank_theta)
    w2 = ca.cos(rod_theta)
    w3 = ca.sin(rod_theta)
    w4 = ca.cos(slider_theta)
    w5 = ca.sin(slider_theta)
    # outputs
    poses = ca.SX(12, 3)
    poses[0, 0] = crank_x
    poses[0, 1] = rod_x
    poses[0, 2] = slider_x
    poses[1, 0] = crank_y
    poses[1, 1] = rod_y
    poses[1, 2] = slider_y
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
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    120 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c10 = c[10]
    c17 = c[17]
    # intermediate terms (31)
    w0 = ca.sin(crank_theta)
    w1 = rod_theta_dot**2
    w2 = ca.cos(rod_theta)
    w3 = w2 * c6
    w4 = crank_theta_dot**2
    w5 = ca.cos(crank_theta) * crank_tip_x
    w6 = w4 * w5
    w7 = w6 * rod_mass
    w8 = ca.sin(rod_theta)
    w9 = w8 * c6
    w10 = w8 * rod_tip_x
    w11 = w0 * crank_tip_x
    w12 = w4 * w11
    w13 = w2 * rod_tip_x
    w14 = (w1 * w10 + w12) / w13
    w15 = (w6 + w1 * w13 + w10 * w14) * slider_mass
    w16 = w12 * rod_mass
    w17 = (w3 * gravity_y - (w6 * w9 - w3 * w12 + w14 * c7) - w10 * w15) / w13
    w18 = w5 / w13
    w19 = w8 * w18
    w20 = w19 * c6
    w21 = w19 * rod_tip_x
    w22 = 2 * rod_theta_dot * ((rod_theta_dot * w21 - crank_theta_dot * w11) / w13)
    w23 = w2 * w18
    w24 = w23 * c6
    w25 = w23 * rod_tip_x
    w26 = (w14 * w21 + (w10 * w22 + w1 * w25) - w6) / w13
    w27 = w20 * gravity_y + (w12 * w20 + w3 * w6 + (w9 * w12 + w6 * w24) + w26 * c7) - w17 * w21 + w15 * w25
    w28 = w0 * c17 - w5 * (w1 * w3 + (w7 + w9 * w14) + w15) - w11 * (c10 + w1 * w9 - (w3 * w14 - w16) - w17)
    w29 = w28 - w11 * (w1 * w20 - w3 * w22 - (w16 + (w14 * w24 + w9 * w26))) - w5 * (w9 * w22 + w1 * w24 + (w14 * w20 - w3 * w26 - w7))
    w30 = w29 - w18 * w27 - (w10 * w18 - w11) * ((w12 - (w1 * w21 - w13 * w22 - w14 * w25) + w10 * w26) * slider_mass)
    # outputs
    dQ_hat_dq_i = ca.vertcat(w30)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    48 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    # intermediate terms (15)
    w0 = ca.sin(crank_theta) * crank_tip_x
    w1 = ca.cos(rod_theta)
    w2 = w1 * c6
    w3 = ca.cos(crank_theta) * crank_tip_x
    w4 = w1 * rod_tip_x
    w5 = w3 / w4
    w6 = 2 * rod_theta_dot * w5
    w7 = ca.sin(rod_theta)
    w8 = w7 * c6
    w9 = w7 * rod_tip_x
    w10 = 2 * crank_theta_dot
    w11 = w0 * w10
    w12 = (w6 * w9 - w11) / w4
    w13 = w3 * w10
    w14 = w0 * (w2 * w6 + (w8 * w12 - w13 * rod_mass)) + w3 * (w11 * rod_mass + w2 * w12 - w6 * w8) + w5 * (w8 * w13 - w2 * w11 - w12 * c7)
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(w14 - (w5 * w9 - w0) * ((w4 * w6 - w13 + w9 * w12) * slider_mass))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 8) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 1) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 18) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    149 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 1)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 1)
    c = ca.SX.sym("c", 18)
    crank_theta = q_i[0]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    crank_tip_x = c[1]
    rod_mass = c[2]
    slider_mass = c[3]
    c4 = c[4]
    rod_tip_x = c[5]
    c6 = c[6]
    c7 = c[7]
    gravity_y = c[8]
    c9 = c[9]
    c10 = c[10]
    # intermediate terms (46)
    w0 = ca.cos(crank_theta) * crank_tip_x
    w1 = ca.sin(crank_theta)
    w2 = w1 * crank_tip_x
    w3 = crank_theta_dot**2
    w4 = crank_theta_ddot * w2 + w0 * w3
    w5 = w4 * rod_mass
    w6 = rod_theta_dot**2
    w7 = ca.cos(rod_theta)
    w8 = w7 * c6
    w9 = w6 * w8
    w10 = ca.sin(rod_theta)
    w11 = w10 * c6
    w12 = w10 * rod_tip_x
    w13 = w6 * w12
    w14 = w2 * w3
    w15 = w7 * rod_tip_x
    w16 = w0 / w15
    w17 = (w13 + w14) / w15 - crank_theta_ddot * w16
    w18 = w11 * w17
    w19 = w6 * w15
    w20 = w12 * w17
    w21 = (w4 + w19 + w20) * slider_mass
    w22 = w6 * w11
    w23 = w0 * crank_theta_ddot - w14
    w24 = w8 * w17
    w25 = (w8 * gravity_y - (w8 * w23 + w4 * w11 + w17 * c7) - w12 * w21) / w15
    w26 = w0 * w5 - (w1 * c9 + w0 * (w9 + (w5 + w18) + w21) + w2 * (c10 + w22 - (w23 * rod_mass + w24) - w25))
    w27 = w12 * slider_mass
    w28 = w11 + w27
    w29 = w0 * w8 + w2 * w28
    w30 = 2 * rod_theta_dot
    w31 = (w2 * crank_theta_dot - w16 * (rod_theta_dot * w12)) / w15
    w32 = (w4 + w12 * w30 * w31 - w16 * (w19 + w20)) / w15
    w33 = w15 * w30 * slider_mass
    w34 = w0 * (w11 * w30) - w2 * (w8 * w30 + w33)
    w35 = (w15 * w17 - w13) * slider_mass
    w36 = w4 * w8
    w37 = c7 + w12 * w27
    w38 = w12 * w33
    w39 = w36 - w23 * w28 - w32 * w37 - w31 * w38 - w16 * (w11 * w23 - w36 - w11 * gravity_y + w12 * w25 - w15 * w21 - w12 * w35)
    w40 = w26 - w2 * (w23 * c4) - w29 * w32 + w31 * w34 - w16 * (w0 * (w9 + w18) - w2 * (w24 - w22 + w35)) - w16 * w39
    w41 = 2 * crank_theta_dot
    w42 = w2 * w41
    w43 = w0 * w41
    w44 = 2 * w31
    w45 = w0 * (w42 * rod_mass) - w2 * (w43 * c4) - w29 * w44 - w16 * w34 - w16 * (w8 * w42 - w28 * w43 - w37 * w44 + w16 * w38)
    # outputs
    J_q = ca.vertcat(w40)
    J_v = ca.vertcat(w45)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 11) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 6) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 6) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 11)
    crank_tip_x = p[9]
    rod_tip_x = p[10]
    # outputs
    positions = ca.SX(3, 6)
    positions[0, 2] = crank_tip_x
    positions[0, 4] = rod_tip_x
    axes = ca.SX(9, 6)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
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
