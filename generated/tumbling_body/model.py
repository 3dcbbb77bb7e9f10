"""Free body turning over: equations of motion, emitted by symgen from the scene `tumbling_body`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 body.x [m], 1 body.y [m], 2 body.z [m], 3 body.e1 [1], 4 body.e2 [1], 5 body.e3 [1]

q_d, the dependent coordinates by index:
    0 body.e0 [1]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    58 operations.
    """
    p = ca.SX.sym("p", 6)
    body_mass = p[0]
    body_inertia_xx = p[1]
    body_inertia_yy = p[2]
    body_inertia_zz = p[3]
    # intermediate terms (9)
    w0 = (body_inertia_xx + body_inertia_yy + body_inertia_zz) / 2.0
    w1 = w0 - body_inertia_yy
    w2 = w0 - body_inertia_zz
    w3 = w1 + w2
    w4 = w0 - body_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = -4.0 * w6
    w8 = -4.0 * w5
    # outputs
    c = ca.vertcat(
        body_mass,  # body_mass
        w1,  # c1
        w2,  # c2
        w3,  # c3
        w4,  # c4
        w5,  # c5
        w6,  # c6
        4.0 * w5 + w7,  # c7
        4.0 * w3 + w8,  # c8
        4.0 * w6 + -4.0 * w3,  # c9
        4.0 * w6 + -4.0 * w3,  # c10
        4.0 * w3 + w8,  # c11
        w7 + 4.0 * w5,  # c12
        2 * w3,  # c13
        -2.0 * w5,  # c14
        2 * w6,  # c15
        -2.0 * w3,  # c16
        -2.0 * w6,  # c17
        2 * w5,  # c18
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 6 x 6) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 6) [N, N m]: condensed force S^T (Q* - M s)
    236 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
    body_mass = c[0]
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
    # intermediate terms (36)
    w0 = 2 * body_e0
    w1 = w0 * c3
    w2 = body_e3 * -2.0
    w3 = 2 * body_e2
    w4 = body_e1 / body_e0
    w5 = body_e1 * -2.0
    w6 = body_e2 * -2.0
    w7 = w1 * w5 + body_e3 * body_e2 * c7
    w8 = w5 * (w5 * c3) + w6 * (w6 * c5) + w2 * (w2 * c6)
    w9 = 2 * body_e3
    w10 = w0 * c5
    w11 = w5 * c6
    w12 = w6 * w10 + body_e3 * body_e1 * c9
    w13 = body_e2 / body_e0
    w14 = w12 - w8 * w13
    w15 = body_e0 * body_e3 * c8 + w3 * w11 - (w4 * w14 + w7 * w13)
    w16 = w6 * c3
    w17 = 2 * body_e1
    w18 = w17 * c5
    w19 = w0 * c6
    w20 = body_e2 * body_e1 * c11 + w2 * w19
    w21 = body_e3 / body_e0
    w22 = w20 - w8 * w21
    w23 = w2 * w18 + body_e0 * body_e2 * c10 - (w4 * w22 + w7 * w21)
    w24 = w9 * w16 + body_e0 * body_e1 * c12 - (w13 * w22 + w12 * w21)
    w25 = w2 * body_e0_dot + w3 * body_e1_dot + w5 * body_e2_dot + w0 * body_e3_dot
    w26 = w25 * c2
    w27 = w6 * body_e0_dot + w2 * body_e1_dot + w0 * body_e2_dot + w17 * body_e3_dot
    w28 = w27 * c1
    w29 = w26 * w27 - w25 * w28
    w30 = w5 * body_e0_dot + w0 * body_e1_dot + w9 * body_e2_dot + w6 * body_e3_dot
    w31 = w30 * c4
    w32 = w25 * w31 - w26 * w30
    w33 = w28 * w30 - w27 * w31
    w34 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w35 = w5 * w29 + w6 * w32 + w2 * w33 + w8 * w34
    # outputs
    M_hat = ca.SX(6, 6)
    # body.x
    M_hat[0, 0] = body_mass
    # body.y
    M_hat[1, 1] = body_mass
    # body.z
    M_hat[2, 2] = body_mass
    # body.e1
    M_hat[3, 3] = w0 * w1 + w2 * (w2 * c5) + w3 * (w3 * c6) - (w4 * (w7 - w4 * w8) + w4 * w7)
    M_hat[3, 4] = w15
    M_hat[3, 5] = w23
    # body.e2
    M_hat[4, 3] = w15
    M_hat[4, 4] = w9 * (w9 * c3) + w0 * w10 + w5 * w11 - (w13 * w14 + w12 * w13)
    M_hat[4, 5] = w24
    # body.e3
    M_hat[5, 3] = w23
    M_hat[5, 4] = w24
    M_hat[5, 5] = w6 * w16 + w17 * w18 + w0 * w19 - (w21 * w22 + w20 * w21)
    Q_hat = ca.SX(6, 1)
    Q_hat[3] = w0 * w29 + w2 * w32 + w3 * w33 + w7 * w34 - w4 * w35  # body.e1
    Q_hat[4] = w9 * w29 + w0 * w32 + w5 * w33 + w12 * w34 - w13 * w35  # body.e2
    Q_hat[5] = w6 * w29 + w17 * w32 + w0 * w33 + w20 * w34 - w21 * w35  # body.e3
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    gives q_d_next (n_d = 1) [mixed]: dependent coordinates after one Newton step
    gives C_loop (loops = 1) [m, rad]: loop closure error before a Newton step
    gives det_loop (loop blocks = 1) [SI]: determinants of the loop blocks, zero if singular
    20 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    # intermediate terms (1)
    w0 = (body_e0**2 + body_e1**2 + body_e2**2 + body_e3**2 - 1.0) / 2.0
    # outputs
    q_d_next = ca.vertcat(body_e0 - w0 / body_e0)
    C_loop = ca.vertcat(w0)
    det_loop = ca.vertcat(body_e0)
    inputs, outputs = [q_i, q_d], [ca.densify(q_d_next), ca.densify(C_loop), ca.densify(det_loop)]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d"], ["q_d_next", "C_loop", "det_loop"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    gives q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    17 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    # intermediate terms (1)
    w0 = body_e1 / body_e0 * body_e1_dot + body_e2 / body_e0 * body_e2_dot + body_e3 / body_e0 * body_e3_dot
    # outputs
    q_d_dot = ca.vertcat(-w0)
    inputs, outputs = [q_i, q_d, q_i_dot], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    gives q_d_ddot (n_d = 1) [mixed]: accelerations of the dependent coordinates
    30 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
    body_e1_ddot = q_i_ddot[3]
    body_e2_ddot = q_i_ddot[4]
    body_e3_ddot = q_i_ddot[5]
    # intermediate terms (1)
    w0 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0 + body_e1 / body_e0 * body_e1_ddot
    # outputs
    q_d_ddot = ca.vertcat(-(w0 + body_e2 / body_e0 * body_e2_ddot + body_e3 / body_e0 * body_e3_ddot))
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    gives C (n_c = 1) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 1 x 7) [SI]: constraint Jacobian
    gives C_t (n_c = 1) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 1) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 1) [m/s^2, rad/s^2]: right-hand side at acceleration level
    39 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    # outputs
    C = ca.vertcat((body_e0**2 + body_e1**2 + body_e2**2 + body_e3**2 - 1.0) / 2.0)
    C_q = ca.SX(1, 7)
    # body.norm
    C_q[0, 3] = body_e0
    C_q[0, 4] = body_e1
    C_q[0, 5] = body_e2
    C_q[0, 6] = body_e3
    C_t = ca.SX(1, 1)
    nu = ca.SX(1, 1)
    gamma = ca.vertcat(-(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2))
    inputs, outputs = [q, q_dot], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q, gamma_b with Baumgarte terms (Eq. 28).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 7 x 7) [SI]: mass matrix in all coordinates
    gives K (n x n = 7 x 7) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 7) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 7) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 7) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 1 x 7) [SI]: constraint Jacobian
    gives gamma_b (n_c = 1) [m/s^2, rad/s^2]: gamma with Baumgarte terms
    274 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    body_mass = c[0]
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
    # intermediate terms (32)
    w0 = body_e1 * -2.0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e0
    w4 = w3 * c3
    w5 = 2 * body_e2
    w6 = w0 * w4 + body_e2 * body_e3 * c7
    w7 = 2 * body_e3
    w8 = w3 * c5
    w9 = w0 * c6
    w10 = w1 * w8 + body_e1 * body_e3 * c9
    w11 = w1 * c3
    w12 = 2 * body_e1
    w13 = w12 * c5
    w14 = w3 * c6
    w15 = body_e1 * body_e2 * c11 + w2 * w14
    w16 = body_e3 * body_e0 * c8 + w5 * w9
    w17 = w2 * w13 + body_e2 * body_e0 * c10
    w18 = w7 * w11 + body_e1 * body_e0 * c12
    w19 = w2 * body_e0_dot + w5 * body_e1_dot + w0 * body_e2_dot + w3 * body_e3_dot
    w20 = w19 * c2
    w21 = w1 * body_e0_dot + w2 * body_e1_dot + w3 * body_e2_dot + w12 * body_e3_dot
    w22 = w21 * c1
    w23 = w20 * w21 - w19 * w22
    w24 = w0 * body_e0_dot + w3 * body_e1_dot + w7 * body_e2_dot + w1 * body_e3_dot
    w25 = w24 * c4
    w26 = w19 * w25 - w20 * w24
    w27 = w22 * w24 - w21 * w25
    w28 = w0 * w23 + w1 * w26 + w2 * w27
    w29 = w3 * w23 + w2 * w26 + w5 * w27
    w30 = w7 * w23 + w3 * w26 + w0 * w27
    w31 = w1 * w23 + w12 * w26 + w3 * w27
    # outputs
    M = ca.SX(7, 7)
    # body.x
    M[0, 0] = body_mass
    # body.y
    M[1, 1] = body_mass
    # body.z
    M[2, 2] = body_mass
    # body.e0
    M[3, 3] = w0 * (w0 * c3) + w1 * (w1 * c5) + w2 * (w2 * c6)
    M[3, 4] = w6
    M[3, 5] = w10
    M[3, 6] = w15
    # body.e1
    M[4, 3] = w6
    M[4, 4] = w3 * w4 + w2 * (w2 * c5) + w5 * (w5 * c6)
    M[4, 5] = w16
    M[4, 6] = w17
    # body.e2
    M[5, 3] = w10
    M[5, 4] = w16
    M[5, 5] = w7 * (w7 * c3) + w3 * w8 + w0 * w9
    M[5, 6] = w18
    # body.e3
    M[6, 3] = w15
    M[6, 4] = w17
    M[6, 5] = w18
    M[6, 6] = w1 * w11 + w12 * w13 + w3 * w14
    K = ca.SX(7, 7)
    Q_v = ca.SX(7, 1)
    Q_v[3] = w28  # body.e0
    Q_v[4] = w29  # body.e1
    Q_v[5] = w30  # body.e2
    Q_v[6] = w31  # body.e3
    Q_F = ca.SX(7, 1)
    Q_star = ca.SX(7, 1)
    Q_star[3] = w28  # body.e0
    Q_star[4] = w29  # body.e1
    Q_star[5] = w30  # body.e2
    Q_star[6] = w31  # body.e3
    C_q = ca.SX(1, 7)
    # body.norm
    C_q[0, 3] = body_e0
    C_q[0, 4] = body_e1
    C_q[0, 5] = body_e2
    C_q[0, 6] = body_e3
    gamma_b = ca.vertcat(-(body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2))
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma_b)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes q_ddot (n = 7) [mixed]: accelerations of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 1) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 0) [N, N m]: world force and moment of a joint on its body b, at b
    100 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    body_e0_ddot = q_ddot[3]
    body_e1_ddot = q_ddot[4]
    body_e2_ddot = q_ddot[5]
    body_e3_ddot = q_ddot[6]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    # intermediate terms (12)
    w0 = body_e1 * -2.0
    w1 = body_e3 * -2.0
    w2 = 2 * body_e0
    w3 = body_e0_dot * w1 + body_e1_dot * (2 * body_e2) + w0 * body_e2_dot + body_e3_dot * w2
    w4 = w3 * c2
    w5 = body_e2 * -2.0
    w6 = body_e0_dot * w5 + w1 * body_e1_dot + body_e2_dot * w2 + body_e3_dot * (2 * body_e1)
    w7 = w6 * c1
    w8 = w0 * body_e0_dot + body_e1_dot * w2 + body_e2_dot * (2 * body_e3) + body_e3_dot * w5
    w9 = w8 * c4
    w10 = (w0 * (w0 * c3) + w5 * (w5 * c5) + w1 * (w1 * c6)) * body_e0_ddot + (w0 * (w2 * c3) + body_e3 * body_e2 * c7) * body_e1_ddot
    w11 = w10 + (w5 * (w2 * c5) + body_e1 * body_e3 * c9) * body_e2_ddot + (body_e1 * body_e2 * c11 + w1 * (w2 * c6)) * body_e3_ddot
    # outputs
    lam = ca.vertcat((w0 * (w4 * w6 - w3 * w7) + w5 * (w3 * w9 - w4 * w8) + w1 * (w7 * w8 - w6 * w9) - w11) / body_e0)
    joint_forces = ca.SX(6, 0)
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 7) [mixed]: rates of all coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    137 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 19)
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    body_x_dot = q_dot[0]
    body_y_dot = q_dot[1]
    body_z_dot = q_dot[2]
    body_e0_dot = q_dot[3]
    body_e1_dot = q_dot[4]
    body_e2_dot = q_dot[5]
    body_e3_dot = q_dot[6]
    body_mass = c[0]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    # intermediate terms (25)
    w0 = body_x_dot * (body_x_dot * body_mass) + body_y_dot * (body_y_dot * body_mass) + body_z_dot * (body_z_dot * body_mass)
    w1 = body_e1 * -2.0
    w2 = body_e2 * -2.0
    w3 = body_e3 * -2.0
    w4 = 2 * body_e0
    w5 = w4 * c3
    w6 = 2 * body_e2
    w7 = w1 * w5 + body_e2 * body_e3 * c7
    w8 = 2 * body_e3
    w9 = w4 * c5
    w10 = w1 * c6
    w11 = w2 * w9 + body_e1 * body_e3 * c9
    w12 = body_e0_dot * (w1 * (w1 * c3) + w2 * (w2 * c5) + w3 * (w3 * c6)) + w7 * body_e1_dot + w11 * body_e2_dot
    w13 = w2 * c3
    w14 = 2 * body_e1
    w15 = w14 * c5
    w16 = w4 * c6
    w17 = body_e1 * body_e2 * c11 + w3 * w16
    w18 = body_e3 * body_e0 * c8 + w6 * w10
    w19 = w3 * w15 + body_e2 * body_e0 * c10
    w20 = body_e0_dot * w7 + body_e1_dot * (w4 * w5 + w3 * (w3 * c5) + w6 * (w6 * c6)) + body_e2_dot * w18 + body_e3_dot * w19
    w21 = w8 * w13 + body_e1 * body_e0 * c12
    w22 = body_e0_dot * w11 + body_e1_dot * w18 + body_e2_dot * (w8 * (w8 * c3) + w4 * w9 + w1 * w10) + body_e3_dot * w21
    w23 = body_e0_dot * w17 + body_e1_dot * w19 + body_e2_dot * w21 + body_e3_dot * (w2 * w13 + w14 * w15 + w4 * w16)
    w24 = w0 + body_e0_dot * (w12 + w17 * body_e3_dot) + body_e1_dot * w20 + body_e2_dot * w22 + body_e3_dot * w23
    # outputs
    kinetic = ca.vertcat(w24 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.SX(1, 1)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 7) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    46 operations.
    """
    q = ca.SX.sym("q", 7)
    body_x = q[0]
    body_y = q[1]
    body_z = q[2]
    body_e0 = q[3]
    body_e1 = q[4]
    body_e2 = q[5]
    body_e3 = q[6]
    # intermediate terms (11)
    w0 = 2 * body_e2**2
    w1 = 2 * body_e3**2
    w2 = 2 * body_e0
    w3 = body_e3 * w2
    w4 = 2 * body_e1
    w5 = body_e2 * w4
    w6 = body_e3 * w4
    w7 = body_e2 * w2
    w8 = 1.0 - 2 * body_e1**2
    w9 = w2 * body_e1
    w10 = body_e3 * (2 * body_e2)
    # outputs
    poses = ca.vertcat(
        body_x, body_y, body_z, 1.0 - w0 - w1, w3 + w5, w6 - w7, w5 - w3, w8 - w1, w9 + w10, w6 + w7, w10 - w9,
        w8 - w0,
    )
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i, through q_d
    556 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    # intermediate terms (114)
    w0 = 2 * body_e0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e1
    w4 = body_e0_dot * w1 + body_e1_dot * w2 + w0 * body_e2_dot + body_e3_dot * w3
    w5 = body_e2_dot * -2.0
    w6 = w5 * c2
    w7 = 2 * body_e2
    w8 = body_e1 * -2.0
    w9 = body_e0_dot * w2 + body_e1_dot * w7 + body_e2_dot * w8 + w0 * body_e3_dot
    w10 = w9 * c2
    w11 = 2 * body_e3_dot
    w12 = w11 * c1
    w13 = w4 * c1
    w14 = w4 * w6 + w10 * w11 - (w9 * w12 + w5 * w13)
    w15 = body_e0_dot * -2.0
    w16 = w15 * c4
    w17 = 2 * body_e3
    w18 = body_e0_dot * w8 + w0 * body_e1_dot + body_e2_dot * w17 + w1 * body_e3_dot
    w19 = w18 * c4
    w20 = w10 * w15
    w21 = w9 * w16 + w5 * w19 - (w6 * w18 + w20)
    w22 = w13 * w15
    w23 = w11 * w19
    w24 = w12 * w18 + w22 - (w4 * w16 + w23)
    w25 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w26 = w0 * c3
    w27 = body_e1 / body_e0
    w28 = w4 * w10 - w9 * w13
    w29 = w28 * -2.0
    w30 = w8 * c3
    w31 = w8 * c16
    w32 = w29 + w8 * w14 + w1 * w21 + w2 * w24 + w25 * (w30 * -2.0 + w31)
    w33 = w9 * w19 - w10 * w18
    w34 = w13 * w18 - w4 * w19
    w35 = w1 * c5
    w36 = w2 * c6
    w37 = w8 * w30 + w1 * w35 + w2 * w36
    w38 = w8 * w28 + w1 * w33 + w2 * w34 + w25 * w37
    w39 = w38 / body_e0
    w40 = 2 * w28
    w41 = w11 * c2
    w42 = 2 * body_e2_dot
    w43 = w10 * w42
    w44 = w42 * c1
    w45 = w4 * w41 + w43 - (w9 * w44 + w11 * w13)
    w46 = 2 * body_e1_dot
    w47 = w46 * c4
    w48 = w23 + w9 * w47 - (w18 * w41 + w10 * w46)
    w49 = w13 * w46
    w50 = w18 * w44 + w49 - (w4 * w47 + w19 * w42)
    w51 = w8 * c13
    w52 = w8 * w26 + body_e2 * body_e3 * c7
    w53 = w25 / body_e0
    w54 = w8 * w45 + w1 * w48 + w2 * w50 - w37 * w53
    w55 = w27 / body_e0
    w56 = w40 + w0 * w45 + w2 * w48 + w7 * w50 + (w25 * w51 - w52 * w53) - (w27 * w54 - w38 * w55)
    w57 = w2 * c2
    w58 = w1 * c1
    w59 = w4 * w57 + w1 * w10 - (w9 * w58 + w2 * w13)
    w60 = w8 * c4
    w61 = w9 * w60 + w2 * w19 - (w18 * w57 + w8 * w10)
    w62 = w18 * w58 + w8 * w13 - (w4 * w60 + w1 * w19)
    w63 = 2 * body_e0_dot / body_e0
    w64 = w8 * w59 + w1 * w61 + w2 * w62 + w37 * w63
    w65 = w0 * w59 + w2 * w61 + w7 * w62 + w52 * w63 - w27 * w64
    w66 = body_e2 / body_e0
    w67 = w66 / body_e0
    w68 = body_e3 / body_e0
    w69 = w68 / body_e0
    w70 = body_e1_dot * w55 + body_e2_dot * w67 + body_e3_dot * w69
    w71 = body_e1_dot / body_e0 + w27 * w70
    w72 = w34 * -2.0
    w73 = w2 * c17
    w74 = 2 * w33
    w75 = w1 * c18
    w76 = w0 * c5
    w77 = w1 * w76 + body_e3 * body_e1 * c9
    w78 = w17 * w45 + (w74 + w0 * w48) + w8 * w50 + (w25 * w75 - w53 * w77) - (w54 * w66 - w38 * w67)
    w79 = w17 * w59 + w0 * w61 + w8 * w62 + w63 * w77 - w64 * w66
    w80 = w14 * w17 + w0 * w21 + (w72 + w8 * w24) + w25 * (w17 * c3 * -2.0 + w73) - w32 * w66 - w27 * w78 - w71 * w79
    w81 = 2 * w34
    w82 = w2 * c15
    w83 = w0 * c6
    w84 = body_e2 * body_e1 * c11 + w2 * w83
    w85 = w1 * w45 + w3 * w48 + (w81 + w0 * w50) + (w25 * w82 - w53 * w84) - (w54 * w68 - w38 * w69)
    w86 = w1 * w59 + w3 * w61 + w0 * w62 + w63 * w84 - w64 * w68
    w87 = w1 * w14 + (w74 + w3 * w21) + w0 * w24 + w25 * (w75 + w1 * c3 * -2.0) - w32 * w68 - w27 * w85 - w71 * w86
    w88 = w46 * c2
    w89 = w15 * c1
    w90 = w20 + w4 * w88 - (w49 + w9 * w89)
    w91 = body_e3_dot * -2.0
    w92 = w91 * c4
    w93 = w9 * w92 + w19 * w46 - (w18 * w88 + w10 * w91)
    w94 = w15 * w19
    w95 = w18 * w89 + w13 * w91 - (w4 * w92 + w94)
    w96 = w33 * -2.0
    w97 = w1 * c14
    w98 = w8 * w90 + (w96 + w1 * w93) + w2 * w95 + w25 * (w35 * -2.0 + w97)
    w99 = body_e2_dot / body_e0 + w66 * w70
    w100 = w0 * w90 + w2 * w93 + (w81 + w7 * w95) + w25 * (w82 + w2 * c5 * -2.0) - w27 * w98 - w56 * w66 - w65 * w99
    w101 = w29 + w1 * w90 + w3 * w93 + w0 * w95 + w25 * (w31 + w3 * c5 * -2.0) - w68 * w98 - w66 * w85 - w86 * w99
    w102 = w15 * c2
    w103 = body_e1_dot * -2.0
    w104 = w103 * c1
    w105 = w4 * w102 + w10 * w103 - (w22 + w9 * w104)
    w106 = w42 * c4
    w107 = w94 + w9 * w106 - (w43 + w18 * w102)
    w108 = w18 * w104 + w13 * w42 - (w4 * w106 + w19 * w103)
    w109 = w8 * w105 + w1 * w107 + (w72 + w2 * w108) + w25 * (w73 + w36 * -2.0)
    w110 = w0 * w105 + (w96 + w2 * w107) + w7 * w108 + w25 * (w97 + w7 * c6 * -2.0) - w27 * w109 - w56 * w68
    w111 = body_e3_dot / body_e0 + w68 * w70
    w112 = w40 + w17 * w105 + w0 * w107 + w8 * w108 + w25 * (w51 + w8 * c6 * -2.0) - w66 * w109 - w68 * w78 - w79 * w111
    w113 = w1 * w105 + w3 * w107 + w0 * w108 + w25 * (w83 * -2.0) - (w39 + w68 * w109) - w68 * w85 - w86 * w111
    # outputs
    dQ_hat_dq_i = ca.SX(6, 6)
    # body.e1
    dQ_hat_dq_i[3, 3] = w0 * w14 + w2 * w21 + w7 * w24 + w25 * (w26 * -2.0) - (w27 * w32 + w39) - w27 * w56 - w65 * w71
    dQ_hat_dq_i[3, 4] = w100
    dQ_hat_dq_i[3, 5] = w110 - w65 * w111
    # body.e2
    dQ_hat_dq_i[4, 3] = w80
    dQ_hat_dq_i[4, 4] = w17 * w90 + w0 * w93 + w8 * w95 + w25 * (w76 * -2.0) - (w39 + w66 * w98) - w66 * w78 - w79 * w99
    dQ_hat_dq_i[4, 5] = w112
    # body.e3
    dQ_hat_dq_i[5, 3] = w87
    dQ_hat_dq_i[5, 4] = w101
    dQ_hat_dq_i[5, 5] = w113
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    321 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    # intermediate terms (55)
    w0 = 2 * body_e0
    w1 = body_e3 * -2.0
    w2 = body_e1 / body_e0
    w3 = body_e2 / body_e0
    w4 = body_e3 / body_e0
    w5 = body_e1_dot * w2 + w3 * body_e2_dot + w4 * body_e3_dot
    w6 = body_e2 * -2.0
    w7 = 2 * body_e1
    w8 = body_e1_dot * w1 - w5 * w6 + w0 * body_e2_dot + body_e3_dot * w7
    w9 = 2 * body_e2
    w10 = w9 - w1 * w2
    w11 = w10 * c2
    w12 = body_e1 * -2.0
    w13 = body_e1_dot * w9 - w1 * w5 + body_e2_dot * w12 + w0 * body_e3_dot
    w14 = w13 * c2
    w15 = w1 - w2 * w6
    w16 = w15 * c1
    w17 = w8 * c1
    w18 = w8 * w11 + w14 * w15 - (w13 * w16 + w10 * w17)
    w19 = w0 - w2 * w12
    w20 = w19 * c4
    w21 = 2 * body_e3
    w22 = w0 * body_e1_dot - w5 * w12 + body_e2_dot * w21 + body_e3_dot * w6
    w23 = w22 * c4
    w24 = w13 * w20 + w10 * w23 - (w11 * w22 + w14 * w19)
    w25 = w16 * w22 + w17 * w19 - (w8 * w20 + w15 * w23)
    w26 = w12 * (w0 * c3) + body_e3 * body_e2 * c7
    w27 = 2 * w5
    w28 = (w2 * w27 + 2 * body_e1_dot) / body_e0
    w29 = w12 * (w12 * c3) + w6 * (w6 * c5) + w1 * (w1 * c6)
    w30 = w12 * w18 + w6 * w24 + w1 * w25 + w28 * w29
    w31 = w6 * (w0 * c5) + body_e3 * body_e1 * c9
    w32 = body_e1 * body_e2 * c11 + w1 * (w0 * c6)
    w33 = w12 - w1 * w3
    w34 = w33 * c2
    w35 = w0 - w3 * w6
    w36 = w35 * c1
    w37 = w8 * w34 + w14 * w35 - (w13 * w36 + w17 * w33)
    w38 = w21 - w3 * w12
    w39 = w38 * c4
    w40 = w13 * w39 + w23 * w33 - (w22 * w34 + w14 * w38)
    w41 = w22 * w36 + w17 * w38 - (w8 * w39 + w23 * w35)
    w42 = (w3 * w27 + 2 * body_e2_dot) / body_e0
    w43 = w12 * w37 + w6 * w40 + w1 * w41 + w29 * w42
    w44 = w0 - w1 * w4
    w45 = w44 * c2
    w46 = w7 - w4 * w6
    w47 = w46 * c1
    w48 = w8 * w45 + w14 * w46 - (w13 * w47 + w17 * w44)
    w49 = w6 - w4 * w12
    w50 = w49 * c4
    w51 = w13 * w50 + w23 * w44 - (w22 * w45 + w14 * w49)
    w52 = w22 * w47 + w17 * w49 - (w8 * w50 + w23 * w46)
    w53 = (w4 * w27 + 2 * body_e3_dot) / body_e0
    w54 = w12 * w48 + w6 * w51 + w1 * w52 + w29 * w53
    # outputs
    dQ_hat_dq_i_dot = ca.SX(6, 6)
    # body.e1
    dQ_hat_dq_i_dot[3, 3] = w0 * w18 + w1 * w24 + w9 * w25 + w26 * w28 - w2 * w30
    dQ_hat_dq_i_dot[3, 4] = w0 * w37 + w1 * w40 + w9 * w41 + w26 * w42 - w2 * w43
    dQ_hat_dq_i_dot[3, 5] = w0 * w48 + w1 * w51 + w9 * w52 + w26 * w53 - w2 * w54
    # body.e2
    dQ_hat_dq_i_dot[4, 3] = w18 * w21 + w0 * w24 + w12 * w25 + w28 * w31 - w3 * w30
    dQ_hat_dq_i_dot[4, 4] = w21 * w37 + w0 * w40 + w12 * w41 + w31 * w42 - w3 * w43
    dQ_hat_dq_i_dot[4, 5] = w21 * w48 + w0 * w51 + w12 * w52 + w31 * w53 - w3 * w54
    # body.e3
    dQ_hat_dq_i_dot[5, 3] = w6 * w18 + w7 * w24 + w0 * w25 + w28 * w32 - w4 * w30
    dQ_hat_dq_i_dot[5, 4] = w6 * w37 + w7 * w40 + w0 * w41 + w32 * w42 - w4 * w43
    dQ_hat_dq_i_dot[5, 5] = w6 * w48 + w7 * w51 + w0 * w52 + w32 * w53 - w4 * w54
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot.

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dMa_dq_i (n_i x n_i = 6 x 6) [SI]: total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot
    371 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_ddot = q_i_ddot[3]
    body_e2_ddot = q_i_ddot[4]
    body_e3_ddot = q_i_ddot[5]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    # intermediate terms (86)
    w0 = 2 * body_e2
    w1 = w0 * c17
    w2 = body_e1 / body_e0
    w3 = body_e2 / body_e0
    w4 = body_e3 / body_e0
    w5 = w2 * body_e1_ddot + body_e2_ddot * w3 + w4 * body_e3_ddot
    w6 = 2 * body_e0
    w7 = w6 * c3
    w8 = w7 * -2.0
    w9 = body_e1 * -2.0
    w10 = body_e2 * -2.0
    w11 = body_e3 * -2.0
    w12 = w0 * c6
    w13 = w7 * w9 + body_e2 * body_e3 * c7
    w14 = body_e1_ddot / body_e0
    w15 = w11 * c18
    w16 = w9 * c3
    w17 = w9 * c16
    w18 = w10 * c5
    w19 = w11 * c6
    w20 = w9 * w16 + w10 * w18 + w11 * w19
    w21 = 2 * body_e3
    w22 = w21 * c3
    w23 = w11 * c17
    w24 = w22 * -2.0 + w23
    w25 = w10 * c3
    w26 = w25 * -2.0
    w27 = w10 * c18
    w28 = w26 + w27
    w29 = body_e1_ddot * w8 - (w5 * (w16 * -2.0 + w17) + w14 * w20) + body_e2_ddot * w24 + body_e3_ddot * w28
    w30 = w6 * c5
    w31 = w9 * c6
    w32 = w10 * w30 + body_e1 * body_e3 * c9
    w33 = 2 * body_e1
    w34 = w33 * c5
    w35 = w6 * c6
    w36 = body_e2 * body_e1 * c11 + w11 * w35
    w37 = body_e1_ddot * w13 - w5 * w20 + body_e2_ddot * w32 + body_e3_ddot * w36
    w38 = w37 / body_e0
    w39 = w6 * c13
    w40 = w9 * c13
    w41 = w2 / body_e0
    w42 = w3 / body_e0
    w43 = w4 / body_e0
    w44 = body_e1_ddot * w41 + body_e2_ddot * w42 + body_e3_ddot * w43
    w45 = 2 * w22
    w46 = w15 + w45
    w47 = 2 * w25
    w48 = w0 * c15
    w49 = w47 + w48
    w50 = w11 * c15
    w51 = body_e1_ddot * w40 + w20 * w44 + body_e2_ddot * w27 + body_e3_ddot * w50
    w52 = body_e1_ddot * (2 * w7 + w39) - (w5 * w40 - w13 * w44) + body_e2_ddot * w46 + body_e3_ddot * w49 - (w2 * w51 - w37 * w41)
    w53 = w31 * -2.0
    w54 = w6 * c18
    w55 = w35 * -2.0
    w56 = w54 + w55
    w57 = w1 * body_e1_ddot - (w5 * w24 + w14 * w32) + body_e2_ddot * (w53 + w9 * c17) + body_e3_ddot * w56
    w58 = 2 * w34
    w59 = w58 + w9 * c15
    w60 = body_e1_ddot * w46 - (w5 * w27 - w32 * w44) + body_e2_ddot * (w54 + 2 * w30) + body_e3_ddot * w59
    w61 = w60 - (w3 * w51 - w37 * w42)
    w62 = body_e1_ddot * w15 - (w5 * w28 + w14 * w36) + body_e2_ddot * w56 + body_e3_ddot * (w58 + w33 * c18)
    w63 = 2 * w35
    w64 = body_e1_ddot * w49 - (w5 * w50 - w36 * w44) + body_e2_ddot * w59 + body_e3_ddot * (w63 + w6 * c15)
    w65 = w64 - (w4 * w51 - w37 * w43)
    w66 = w11 * c5 * -2.0
    w67 = w50 + w66
    w68 = body_e2_ddot / body_e0
    w69 = 2 * w31
    w70 = w63 + w6 * c16
    w71 = body_e1_ddot * (w48 + 2 * w12) - (w5 * w67 + w13 * w68) + body_e2_ddot * w69 + body_e3_ddot * w70
    w72 = w10 * c14
    w73 = w30 * -2.0
    w74 = w34 * -2.0
    w75 = w17 + w74
    w76 = body_e1_ddot * w67 - (w5 * (w18 * -2.0 + w72) + w20 * w68) + body_e2_ddot * w73 + body_e3_ddot * w75
    w77 = w21 * c16
    w78 = body_e1_ddot * w70 - (w5 * w75 + w36 * w68) + body_e2_ddot * w77 + body_e3_ddot * (w26 + w10 * c16)
    w79 = w72 + w12 * -2.0
    w80 = body_e3_ddot / body_e0
    w81 = w39 + w73
    w82 = body_e1_ddot * (w66 + w11 * c14) - (w5 * w79 + w13 * w80) + body_e2_ddot * w81 + body_e3_ddot * w74
    w83 = w40 + w53
    w84 = body_e1_ddot * w79 - (w5 * (w23 + w19 * -2.0) + w20 * w80) + body_e2_ddot * w83 + body_e3_ddot * w55
    w85 = body_e1_ddot * w81 - (w5 * w83 + w32 * w80) + body_e2_ddot * (w45 + w21 * c13) + body_e3_ddot * w47
    # outputs
    dMa_dq_i = ca.SX(6, 6)
    # body.e1
    dMa_dq_i[3, 3] = body_e2_ddot * w1 - (w5 * w8 + w13 * w14) + body_e3_ddot * w15 - (w2 * w29 + w38) - w2 * w52
    dMa_dq_i[3, 4] = w71 - w2 * w76 - w3 * w52
    dMa_dq_i[3, 5] = w82 - w2 * w84 - w4 * w52
    # body.e2
    dMa_dq_i[4, 3] = w57 - w3 * w29 - w2 * w61
    dMa_dq_i[4, 4] = body_e1_ddot * w69 - (w5 * w73 + w32 * w68) + body_e3_ddot * w77 - (w38 + w3 * w76) - w3 * w61
    dMa_dq_i[4, 5] = w85 - w3 * w84 - w4 * w61
    # body.e3
    dMa_dq_i[5, 3] = w62 - w4 * w29 - w2 * w65
    dMa_dq_i[5, 4] = w78 - w4 * w76 - w3 * w65
    dMa_dq_i[5, 5] = body_e1_ddot * w74 - (w5 * w55 + w36 * w80) + body_e2_ddot * w47 - (w38 + w4 * w84) - w4 * w65
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [ca.densify(dMa_dq_i)]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes c (n_const = 19) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    225 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 19)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    body_e0_dot = q_d_dot[0]
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
    # intermediate terms (46)
    w0 = 2 * body_e0
    w1 = body_e3 * -2.0
    w2 = 2 * body_e2
    w3 = body_e1 * -2.0
    w4 = body_e0_dot * w1 + body_e1_dot * w2 + body_e2_dot * w3 + w0 * body_e3_dot
    w5 = w4 * c2
    w6 = body_e2 * -2.0
    w7 = 2 * body_e1
    w8 = body_e0_dot * w6 + w1 * body_e1_dot + w0 * body_e2_dot + body_e3_dot * w7
    w9 = w8 * c1
    w10 = w5 * w8 - w4 * w9
    w11 = 2 * body_e3
    w12 = body_e0_dot * w3 + w0 * body_e1_dot + body_e2_dot * w11 + body_e3_dot * w6
    w13 = w12 * c4
    w14 = w4 * w13 - w5 * w12
    w15 = w9 * w12 - w8 * w13
    w16 = w0 * c3
    w17 = w3 * w16 + body_e3 * body_e2 * c7
    w18 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w19 = body_e1 / body_e0
    w20 = w3 * (w3 * c3) + w6 * (w6 * c5) + w1 * (w1 * c6)
    w21 = w3 * w10 + w6 * w14 + w1 * w15 + w18 * w20
    w22 = w6 * c3
    w23 = w7 * c5
    w24 = w0 * c6
    w25 = body_e2 * body_e1 * c11 + w1 * w24
    w26 = body_e3 / body_e0
    w27 = w25 - w20 * w26
    w28 = w1 * w23 + body_e0 * body_e2 * c10 - (w19 * w27 + w17 * w26)
    w29 = w6 * w22 + w7 * w23 + w0 * w24 - (w26 * w27 + w25 * w26)
    w30 = w28 / w29
    w31 = w6 * w10 + w7 * w14 + w0 * w15 + w18 * w25 - w21 * w26
    w32 = w0 * c5
    w33 = w3 * c6
    w34 = w6 * w32 + body_e3 * body_e1 * c9
    w35 = body_e2 / body_e0
    w36 = w34 - w20 * w35
    w37 = w11 * w22 + body_e0 * body_e1 * c12 - (w27 * w35 + w26 * w34)
    w38 = body_e0 * body_e3 * c8 + w2 * w33 - (w19 * w36 + w17 * w35) - w30 * w37
    w39 = w37 / w29
    w40 = w11 * (w11 * c3) + w0 * w32 + w3 * w33 - (w35 * w36 + w34 * w35) - w37 * w39
    w41 = w38 / w40
    w42 = w10 * w11 + w0 * w14 + w3 * w15 + w18 * w34 - w21 * w35 - w31 * w39
    w43 = w0 * w16 + w1 * (w1 * c5) + w2 * (w2 * c6) - (w19 * (w17 - w19 * w20) + w17 * w19) - w28 * w30 - w38 * w41
    w44 = (w0 * w10 + w1 * w14 + w2 * w15 + w17 * w18 - w19 * w21 - w30 * w31 - w41 * w42) / w43
    w45 = (w42 - w38 * w44) / w40
    # outputs
    q_i_ddot = ca.SX(6, 1)
    q_i_ddot[3] = w44  # body.e1
    q_i_ddot[4] = w45  # body.e2
    q_i_ddot[5] = (w31 - (w28 * w44 + w37 * w45)) / w29  # body.e3
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 3) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 3) [1]: columns of the rotation matrix of the marker at a drawn point
    40 operations.
    """
    p = ca.SX.sym("p", 6)
    body_tip_x_x = p[4]
    body_tip_y_y = p[5]
    # outputs
    positions = ca.SX(3, 3)
    positions[0, 1] = body_tip_x_x
    positions[1, 2] = body_tip_y_y
    axes = ca.SX(9, 3)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
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
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
