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
    gives c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    77 operations.
    """
    p = ca.SX.sym("p", 6)
    body_mass = p[0]
    body_inertia_xx = p[1]
    body_inertia_yy = p[2]
    body_inertia_zz = p[3]
    # intermediate terms (21)
    w0 = (body_inertia_xx + body_inertia_yy + body_inertia_zz) / 2.0
    w1 = w0 - body_inertia_yy
    w2 = w0 - body_inertia_zz
    w3 = w1 + w2
    w4 = w0 - body_inertia_xx
    w5 = w2 + w4
    w6 = w1 + w4
    w7 = 4.0 * w5
    w8 = -4.0 * w6
    w9 = 4.0 * w3
    w10 = -4.0 * w3
    w11 = 4.0 * w6
    w12 = -4.0 * w5
    w13 = 4.0 * w5
    w14 = -4.0 * w6
    w15 = -2.0 * w1
    w16 = -2.0 * w2
    w17 = w15 + w16
    w18 = -2.0 * w4
    w19 = w16 + w18
    w20 = w15 + w18
    # outputs
    c = ca.vertcat(
        body_mass,  # body_mass
        w1,  # c1
        w2,  # c2
        w3,  # c3
        w4,  # c4
        w5,  # c5
        w6,  # c6
        w7 + w8,  # c7
        w9 + -4.0 * w5,  # c8
        4.0 * w6 + w10,  # c9
        w11 + -4.0 * w3,  # c10
        4.0 * w3 + w12,  # c11
        w8 + w13,  # c12
        w7 + w14,  # c13
        w9 + w12,  # c14
        w13 + w14,  # c15
        w17,  # c16
        w19,  # c17
        w20,  # c18
        -2.0 * w19 + 2 * w20,  # c19
        2 * w17 + -2.0 * w20,  # c20
        -2.0 * w17 + 2 * w19,  # c21
        w11 + w10,  # c22
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 6 x 6) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 6) [N, N m]: condensed force S^T (Q* - M s)
    237 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 23)
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
    # intermediate terms (39)
    w0 = 2 * body_e0
    w1 = body_e3 * -2.0
    w2 = w1 * c5
    w3 = 2 * body_e2
    w4 = w3 * c6
    w5 = body_e1 / body_e0
    w6 = body_e1 * -2.0
    w7 = w6 * c3
    w8 = body_e2 * -2.0
    w9 = w8 * c5
    w10 = w1 * c6
    w11 = w0 * w7 + body_e3 * body_e2 * c7
    w12 = w6 * w7 + w8 * w9 + w1 * w10
    w13 = 2 * body_e3
    w14 = w0 * w9 + body_e3 * body_e1 * c9
    w15 = body_e2 / body_e0
    w16 = w14 - w12 * w15
    w17 = body_e0 * body_e3 * c8 + w4 * w6 - (w5 * w16 + w11 * w15)
    w18 = 2 * body_e1
    w19 = body_e2 * body_e1 * c11 + w0 * w10
    w20 = body_e3 / body_e0
    w21 = w19 - w12 * w20
    w22 = w2 * w18 + body_e0 * body_e2 * c10 - (w5 * w21 + w11 * w20)
    w23 = w13 * c3
    w24 = w8 * w23 + body_e0 * body_e1 * c12 - (w15 * w21 + w14 * w20)
    w25 = w8 * body_e0_dot + w1 * body_e1_dot + w0 * body_e2_dot + w18 * body_e3_dot
    w26 = w1 * body_e0_dot + w3 * body_e1_dot + w6 * body_e2_dot + w0 * body_e3_dot
    w27 = w25 * w26
    w28 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w29 = w6 * w28
    w30 = (w27 - w29) * c1 - (w27 + w29) * c2
    w31 = w6 * body_e0_dot + w0 * body_e1_dot + w13 * body_e2_dot + w8 * body_e3_dot
    w32 = w26 * w31
    w33 = w8 * w28
    w34 = (w32 - w33) * c2 - (w32 + w33) * c4
    w35 = w25 * w31
    w36 = w1 * w28
    w37 = (w35 - w36) * c4 - (w35 + w36) * c1
    w38 = w6 * w30 + w8 * w34 + w1 * w37
    # outputs
    M_hat = ca.SX(6, 6)
    # body.x
    M_hat[0, 0] = body_mass
    # body.y
    M_hat[1, 1] = body_mass
    # body.z
    M_hat[2, 2] = body_mass
    # body.e1
    M_hat[3, 3] = w0 * (w0 * c3) + w1 * w2 + w3 * w4 - (w5 * (w11 - w5 * w12) + w5 * w11)
    M_hat[3, 4] = w17
    M_hat[3, 5] = w22
    # body.e2
    M_hat[4, 3] = w17
    M_hat[4, 4] = w13 * w23 + w0 * (w0 * c5) + w6 * (w6 * c6) - (w15 * w16 + w14 * w15)
    M_hat[4, 5] = w24
    # body.e3
    M_hat[5, 3] = w22
    M_hat[5, 4] = w24
    M_hat[5, 5] = w8 * (w8 * c3) + w18 * (w18 * c5) + w0 * (w0 * c6) - (w20 * w21 + w19 * w20)
    Q_hat = ca.SX(6, 1)
    Q_hat[3] = w5 * w38 - (w0 * w30 + w1 * w34 + w3 * w37)  # body.e1
    Q_hat[4] = w15 * w38 - (w13 * w30 + w0 * w34 + w6 * w37)  # body.e2
    Q_hat[5] = w20 * w38 - (w8 * w30 + w18 * w34 + w0 * w37)  # body.e3
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
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
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
    c = ca.SX.sym("c", 23)
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
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (32)
    w0 = body_e1 * -2.0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e0
    w4 = w3 * c3
    w5 = 2 * body_e2
    w6 = w0 * w4 + body_e2 * body_e3 * c13
    w7 = 2 * body_e3
    w8 = w3 * c5
    w9 = w0 * c6
    w10 = w1 * w8 + body_e1 * body_e3 * c9
    w11 = w1 * c3
    w12 = 2 * body_e1
    w13 = w12 * c5
    w14 = w3 * c6
    w15 = body_e1 * body_e2 * c11 + w2 * w14
    w16 = body_e3 * body_e0 * c14 + w5 * w9
    w17 = w2 * w13 + body_e2 * body_e0 * c10
    w18 = w7 * w11 + body_e1 * body_e0 * c15
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
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 1) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 6 x 0) [N, N m]: world force and moment of a joint on its body b, at b
    100 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    q_ddot = ca.SX.sym("q_ddot", 7)
    c = ca.SX.sym("c", 23)
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
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
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
    w10 = (w0 * (w0 * c3) + w5 * (w5 * c5) + w1 * (w1 * c6)) * body_e0_ddot + (w0 * (w2 * c3) + body_e3 * body_e2 * c13) * body_e1_ddot
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
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    137 operations.
    """
    q = ca.SX.sym("q", 7)
    q_dot = ca.SX.sym("q_dot", 7)
    c = ca.SX.sym("c", 23)
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
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (25)
    w0 = body_x_dot * (body_x_dot * body_mass) + body_y_dot * (body_y_dot * body_mass) + body_z_dot * (body_z_dot * body_mass)
    w1 = body_e1 * -2.0
    w2 = body_e2 * -2.0
    w3 = body_e3 * -2.0
    w4 = 2 * body_e0
    w5 = w4 * c3
    w6 = 2 * body_e2
    w7 = w1 * w5 + body_e2 * body_e3 * c13
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
    w18 = body_e3 * body_e0 * c14 + w6 * w10
    w19 = w3 * w15 + body_e2 * body_e0 * c10
    w20 = body_e0_dot * w7 + body_e1_dot * (w4 * w5 + w3 * (w3 * c5) + w6 * (w6 * c6)) + body_e2_dot * w18 + body_e3_dot * w19
    w21 = w8 * w13 + body_e1 * body_e0 * c15
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
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i, through q_d
    444 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 23)
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
    c4 = c[4]
    # intermediate terms (101)
    w0 = body_e1 / body_e0
    w1 = body_e2 * -2.0
    w2 = body_e3 * -2.0
    w3 = 2 * body_e0
    w4 = 2 * body_e1
    w5 = body_e0_dot * w1 + body_e1_dot * w2 + body_e2_dot * w3 + body_e3_dot * w4
    w6 = 2 * body_e2
    w7 = body_e1 * -2.0
    w8 = body_e0_dot * w2 + body_e1_dot * w6 + body_e2_dot * w7 + w3 * body_e3_dot
    w9 = w5 * w8
    w10 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w11 = w7 * w10
    w12 = (w9 - w11) * c1 - (w9 + w11) * c2
    w13 = w12 * -2.0
    w14 = 2 * body_e3_dot
    w15 = body_e2_dot * -2.0
    w16 = w8 * w14 + w5 * w15
    w17 = w10 * -2.0
    w18 = (w16 - w17) * c1 - (w16 + w17) * c2
    w19 = body_e0_dot * -2.0
    w20 = w8 * w19
    w21 = 2 * body_e3
    w22 = body_e0_dot * w7 + body_e1_dot * w3 + body_e2_dot * w21 + w1 * body_e3_dot
    w23 = w20 + w15 * w22
    w24 = w23 * c2 - w23 * c4
    w25 = w5 * w19
    w26 = w14 * w22
    w27 = w25 + w26
    w28 = w27 * c4 - w27 * c1
    w29 = w13 + w7 * w18 + w1 * w24 + w2 * w28
    w30 = w8 * w22
    w31 = w1 * w10
    w32 = (w30 - w31) * c2 - (w30 + w31) * c4
    w33 = w5 * w22
    w34 = w2 * w10
    w35 = (w33 - w34) * c4 - (w33 + w34) * c1
    w36 = w7 * w12 + w1 * w32 + w2 * w35
    w37 = w36 / body_e0
    w38 = 2 * body_e2_dot
    w39 = w8 * w38
    w40 = w39 + w5 * w14
    w41 = w10 / body_e0
    w42 = w7 * w41
    w43 = (w40 + w42) * c1 - (w40 - w42) * c2
    w44 = 2 * body_e1_dot
    w45 = w26 + w8 * w44
    w46 = w1 * w41
    w47 = (w45 + w46) * c2 - (w45 - w46) * c4
    w48 = w5 * w44
    w49 = w48 + w22 * w38
    w50 = w2 * w41
    w51 = (w49 + w50) * c4 - (w49 - w50) * c1
    w52 = w7 * w43 + w1 * w47 + w2 * w51
    w53 = w0 / body_e0
    w54 = 2 * w12
    w55 = w0 * w52 - w36 * w53 - (w54 + w3 * w43 + w2 * w47 + w6 * w51)
    w56 = w1 * w8 + w2 * w5
    w57 = 2 * body_e0_dot / body_e0
    w58 = w7 * w57
    w59 = (w56 - w58) * c1 - (w56 + w58) * c2
    w60 = w7 * w8 + w2 * w22
    w61 = w1 * w57
    w62 = (w60 - w61) * c2 - (w60 + w61) * c4
    w63 = w5 * w7 + w1 * w22
    w64 = w2 * w57
    w65 = (w63 - w64) * c4 - (w63 + w64) * c1
    w66 = w7 * w59 + w1 * w62 + w2 * w65
    w67 = w0 * w66 - (w3 * w59 + w2 * w62 + w6 * w65)
    w68 = body_e2 / body_e0
    w69 = w68 / body_e0
    w70 = body_e3 / body_e0
    w71 = w70 / body_e0
    w72 = body_e1_dot * w53 + body_e2_dot * w69 + body_e3_dot * w71
    w73 = body_e1_dot / body_e0 + w0 * w72
    w74 = w35 * -2.0
    w75 = 2 * w32
    w76 = w52 * w68 - w36 * w69 - (w21 * w43 + (w75 + w3 * w47) + w7 * w51)
    w77 = w66 * w68 - (w21 * w59 + w3 * w62 + w7 * w65)
    w78 = 2 * w35
    w79 = w52 * w70 - w36 * w71 - (w1 * w43 + w4 * w47 + (w78 + w3 * w51))
    w80 = w66 * w70 - (w1 * w59 + w4 * w62 + w3 * w65)
    w81 = w20 + w48
    w82 = w81 * c1 - w81 * c2
    w83 = w32 * -2.0
    w84 = body_e3_dot * -2.0
    w85 = w8 * w84 + w22 * w44
    w86 = (w85 - w17) * c2 - (w17 + w85) * c4
    w87 = w19 * w22
    w88 = w5 * w84 + w87
    w89 = w88 * c4 - w88 * c1
    w90 = w7 * w82 + (w83 + w1 * w86) + w2 * w89
    w91 = body_e2_dot / body_e0 + w68 * w72
    w92 = body_e1_dot * -2.0
    w93 = w25 + w8 * w92
    w94 = w93 * c1 - w93 * c2
    w95 = w39 + w87
    w96 = w95 * c2 - w95 * c4
    w97 = w5 * w38 + w22 * w92
    w98 = (w97 - w17) * c4 - (w17 + w97) * c1
    w99 = w7 * w94 + w1 * w96 + (w74 + w2 * w98)
    w100 = body_e3_dot / body_e0 + w70 * w72
    # outputs
    dQ_hat_dq_i = ca.SX(6, 6)
    # body.e1
    dQ_hat_dq_i[3, 3] = w0 * w29 + w37 - (w3 * w18 + w2 * w24 + w6 * w28) - w0 * w55 - w67 * w73
    dQ_hat_dq_i[3, 4] = w0 * w90 - (w3 * w82 + w2 * w86 + (w78 + w6 * w89)) - w55 * w68 - w67 * w91
    dQ_hat_dq_i[3, 5] = w0 * w99 - (w3 * w94 + (w83 + w2 * w96) + w6 * w98) - w55 * w70 - w67 * w100
    # body.e2
    dQ_hat_dq_i[4, 3] = w29 * w68 - (w18 * w21 + w3 * w24 + (w74 + w7 * w28)) - w0 * w76 - w73 * w77
    dQ_hat_dq_i[4, 4] = w37 + w68 * w90 - (w21 * w82 + w3 * w86 + w7 * w89) - w68 * w76 - w77 * w91
    dQ_hat_dq_i[4, 5] = w68 * w99 - (w54 + w21 * w94 + w3 * w96 + w7 * w98) - w70 * w76 - w77 * w100
    # body.e3
    dQ_hat_dq_i[5, 3] = w29 * w70 - (w1 * w18 + (w75 + w4 * w24) + w3 * w28) - w0 * w79 - w73 * w80
    dQ_hat_dq_i[5, 4] = w70 * w90 - (w13 + w1 * w82 + w4 * w86 + w3 * w89) - w68 * w79 - w80 * w91
    dQ_hat_dq_i[5, 5] = w37 + w70 * w99 - (w1 * w94 + w4 * w96 + w3 * w98) - w70 * w79 - w80 * w100
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    274 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    c = ca.SX.sym("c", 23)
    body_e1 = q_i[3]
    body_e2 = q_i[4]
    body_e3 = q_i[5]
    body_e0 = q_d[0]
    body_e1_dot = q_i_dot[3]
    body_e2_dot = q_i_dot[4]
    body_e3_dot = q_i_dot[5]
    c1 = c[1]
    c2 = c[2]
    c4 = c[4]
    # intermediate terms (57)
    w0 = body_e1 / body_e0
    w1 = body_e1 * -2.0
    w2 = 2 * body_e2
    w3 = body_e2 / body_e0
    w4 = body_e3 / body_e0
    w5 = w0 * body_e1_dot + w3 * body_e2_dot + w4 * body_e3_dot
    w6 = body_e3 * -2.0
    w7 = 2 * body_e0
    w8 = body_e1_dot * w2 - w5 * w6 + w1 * body_e2_dot + body_e3_dot * w7
    w9 = body_e2 * -2.0
    w10 = w6 - w0 * w9
    w11 = 2 * body_e1
    w12 = body_e1_dot * w6 - w5 * w9 + body_e2_dot * w7 + body_e3_dot * w11
    w13 = w2 - w0 * w6
    w14 = w8 * w10 + w12 * w13
    w15 = 2 * w5
    w16 = (w0 * w15 + 2 * body_e1_dot) / body_e0
    w17 = w1 * w16
    w18 = (w14 - w17) * c1 - (w14 + w17) * c2
    w19 = w7 - w0 * w1
    w20 = 2 * body_e3
    w21 = body_e1_dot * w7 - w1 * w5 + body_e2_dot * w20 + body_e3_dot * w9
    w22 = w8 * w19 + w13 * w21
    w23 = w9 * w16
    w24 = (w22 - w23) * c2 - (w22 + w23) * c4
    w25 = w12 * w19 + w10 * w21
    w26 = w6 * w16
    w27 = (w25 - w26) * c4 - (w25 + w26) * c1
    w28 = w1 * w18 + w9 * w24 + w6 * w27
    w29 = w7 - w3 * w9
    w30 = w1 - w3 * w6
    w31 = w8 * w29 + w12 * w30
    w32 = (w3 * w15 + 2 * body_e2_dot) / body_e0
    w33 = w1 * w32
    w34 = (w31 - w33) * c1 - (w31 + w33) * c2
    w35 = w20 - w1 * w3
    w36 = w8 * w35 + w21 * w30
    w37 = w9 * w32
    w38 = (w36 - w37) * c2 - (w36 + w37) * c4
    w39 = w12 * w35 + w21 * w29
    w40 = w6 * w32
    w41 = (w39 - w40) * c4 - (w39 + w40) * c1
    w42 = w1 * w34 + w9 * w38 + w6 * w41
    w43 = w11 - w4 * w9
    w44 = w7 - w4 * w6
    w45 = w8 * w43 + w12 * w44
    w46 = (w4 * w15 + 2 * body_e3_dot) / body_e0
    w47 = w1 * w46
    w48 = (w45 - w47) * c1 - (w45 + w47) * c2
    w49 = w9 - w1 * w4
    w50 = w8 * w49 + w21 * w44
    w51 = w9 * w46
    w52 = (w50 - w51) * c2 - (w50 + w51) * c4
    w53 = w12 * w49 + w21 * w43
    w54 = w6 * w46
    w55 = (w53 - w54) * c4 - (w53 + w54) * c1
    w56 = w1 * w48 + w9 * w52 + w6 * w55
    # outputs
    dQ_hat_dq_i_dot = ca.SX(6, 6)
    # body.e1
    dQ_hat_dq_i_dot[3, 3] = w0 * w28 - (w7 * w18 + w6 * w24 + w2 * w27)
    dQ_hat_dq_i_dot[3, 4] = w0 * w42 - (w7 * w34 + w6 * w38 + w2 * w41)
    dQ_hat_dq_i_dot[3, 5] = w0 * w56 - (w7 * w48 + w6 * w52 + w2 * w55)
    # body.e2
    dQ_hat_dq_i_dot[4, 3] = w3 * w28 - (w18 * w20 + w7 * w24 + w1 * w27)
    dQ_hat_dq_i_dot[4, 4] = w3 * w42 - (w20 * w34 + w7 * w38 + w1 * w41)
    dQ_hat_dq_i_dot[4, 5] = w3 * w56 - (w20 * w48 + w7 * w52 + w1 * w55)
    # body.e3
    dQ_hat_dq_i_dot[5, 3] = w4 * w28 - (w9 * w18 + w11 * w24 + w7 * w27)
    dQ_hat_dq_i_dot[5, 4] = w4 * w42 - (w9 * w34 + w11 * w38 + w7 * w41)
    dQ_hat_dq_i_dot[5, 5] = w4 * w56 - (w9 * w48 + w11 * w52 + w7 * w55)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 6 x 6) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 6 x 6) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    746 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    q_i_ddot = ca.SX.sym("q_i_ddot", 6)
    c = ca.SX.sym("c", 23)
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
    c1 = c[1]
    c2 = c[2]
    c4 = c[4]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    # intermediate terms (136)
    w0 = body_e2 * -2.0
    w1 = body_e3 * -2.0
    w2 = 2 * body_e0
    w3 = 2 * body_e1
    w4 = body_e0_dot * w0 + body_e1_dot * w1 + body_e2_dot * w2 + body_e3_dot * w3
    w5 = 2 * body_e2
    w6 = body_e1 * -2.0
    w7 = body_e0_dot * w1 + body_e1_dot * w5 + body_e2_dot * w6 + w2 * body_e3_dot
    w8 = w4 * w7
    w9 = body_e1 / body_e0
    w10 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0 + body_e1_ddot * w9
    w11 = body_e2 / body_e0
    w12 = body_e3 / body_e0
    w13 = w10 + w11 * body_e2_ddot + w12 * body_e3_ddot
    w14 = 2 * body_e3
    w15 = w2 * body_e1_ddot - w6 * w13 + body_e2_ddot * w14 + w0 * body_e3_ddot
    w16 = (w8 + w15) * c1 - (w8 - w15) * c2
    w17 = 2 * w16
    w18 = 2 * body_e2_dot
    w19 = w7 * w18
    w20 = 2 * body_e3_dot
    w21 = w19 + w4 * w20
    w22 = 2 * body_e1_ddot
    w23 = (w21 + w22) * c1 - (w21 - w22) * c2
    w24 = 2 * body_e1_dot
    w25 = body_e0_dot * w6 + body_e1_dot * w2 + body_e2_dot * w14 + w0 * body_e3_dot
    w26 = w20 * w25
    w27 = w7 * w24 + w26
    w28 = 2 * body_e2_ddot
    w29 = (w27 + w28) * c2 - (w27 - w28) * c4
    w30 = w4 * w24
    w31 = w30 + w18 * w25
    w32 = 2 * body_e3_ddot
    w33 = (w31 + w32) * c4 - (w31 - w32) * c1
    w34 = w17 + w2 * w23 + w1 * w29 + w5 * w33
    w35 = body_e2_dot * -2.0
    w36 = w7 * w20 + w4 * w35
    w37 = w13 * -2.0
    w38 = (w36 - w37) * c1 - (w36 + w37) * c2
    w39 = body_e0_dot * -2.0
    w40 = w7 * w39
    w41 = w40 + w25 * w35
    w42 = (w32 + w41) * c2 - (w41 - w32) * c4
    w43 = w4 * w39
    w44 = w26 + w43
    w45 = body_e2_ddot * -2.0
    w46 = (w44 + w45) * c4 - (w44 - w45) * c1
    w47 = w7 * w25
    w48 = w1 * body_e1_ddot - w0 * w13 + w2 * body_e2_ddot + w3 * body_e3_ddot
    w49 = (w47 + w48) * c2 - (w47 - w48) * c4
    w50 = w4 * w25
    w51 = w5 * body_e1_ddot - w1 * w13 + w6 * body_e2_ddot + w2 * body_e3_ddot
    w52 = (w50 + w51) * c4 - (w50 - w51) * c1
    w53 = (w6 * w16 + w0 * w49 + w1 * w52) / body_e0
    w54 = w0 * w7
    w55 = w54 + w1 * w4
    w56 = w55 * c1 - w55 * c2
    w57 = w1 * w25
    w58 = w6 * w7 + w57
    w59 = w58 * c2 - w58 * c4
    w60 = w4 * w6
    w61 = w60 + w0 * w25
    w62 = w61 * c4 - w61 * c1
    w63 = w2 * w56 + w1 * w59 + w5 * w62
    w64 = (body_e1_dot - body_e0_dot * w9) / body_e0
    w65 = body_e1 * c16
    w66 = body_e2 * c17
    w67 = body_e3 * c18
    w68 = w2 * w65 + body_e2 * body_e3 * c19
    w69 = 2 * body_e0_dot
    w70 = (body_e1_ddot + w9 * w13 - w64 * w69) / body_e0
    w71 = w6 * w23 + w0 * w29 + w1 * w33 - w53
    w72 = w16 * -2.0
    w73 = w6 * w56 + w0 * w59 + w1 * w62
    w74 = w6 * w65 + w0 * w66 + w1 * w67
    w75 = w9 * w71 - (w72 + w6 * w38 + w0 * w42 + w1 * w46) + w64 * w73 + w70 * w74
    w76 = 2 * w49
    w77 = w14 * w23 + (w76 + w2 * w29) + w6 * w33
    w78 = w52 * -2.0
    w79 = w14 * w56 + w2 * w59 + w6 * w62
    w80 = w2 * w66 + body_e3 * body_e1 * c20
    w81 = 2 * w52
    w82 = w0 * w23 + w3 * w29 + (w81 + w2 * w33)
    w83 = w0 * w56 + w3 * w59 + w2 * w62
    w84 = body_e2 * body_e1 * c21 + w2 * w67
    w85 = w30 + w40
    w86 = body_e3_ddot * -2.0
    w87 = (w85 + w86) * c1 - (w85 - w86) * c2
    w88 = body_e3_dot * -2.0
    w89 = w7 * w88 + w24 * w25
    w90 = (w89 - w37) * c2 - (w37 + w89) * c4
    w91 = w25 * w39
    w92 = w4 * w88 + w91
    w93 = (w22 + w92) * c4 - (w92 - w22) * c1
    w94 = (body_e2_dot - body_e0_dot * w11) / body_e0
    w95 = (body_e2_ddot + w11 * w13 - w69 * w94) / body_e0
    w96 = w49 * -2.0
    w97 = w11 * w71 - (w6 * w87 + (w96 + w0 * w90) + w1 * w93) + w73 * w94 + w74 * w95
    w98 = body_e1_dot * -2.0
    w99 = w43 + w7 * w98
    w100 = (w28 + w99) * c1 - (w99 - w28) * c2
    w101 = w19 + w91
    w102 = body_e1_ddot * -2.0
    w103 = (w101 + w102) * c2 - (w101 - w102) * c4
    w104 = w4 * w18 + w25 * w98
    w105 = (w104 - w37) * c4 - (w37 + w104) * c1
    w106 = (body_e3_dot - body_e0_dot * w12) / body_e0
    w107 = (body_e3_ddot + w12 * w13 - w69 * w106) / body_e0
    w108 = w12 * w71 - (w6 * w100 + w0 * w103 + (w78 + w1 * w105)) + w73 * w106 + w74 * w107
    w109 = w1 * w7 + w4 * w5
    w110 = w109 * c1 - w109 * c2
    w111 = w2 * w7
    w112 = w111 + w5 * w25
    w113 = w112 * c2 - w112 * c4
    w114 = w2 * w4
    w115 = w57 + w114
    w116 = w115 * c4 - w115 * c1
    w117 = (w24 - w9 * w69) / body_e0
    w118 = w9 * w73 - (w6 * w110 + w0 * w113 + w1 * w116) + w74 * w117
    w119 = w60 + w111
    w120 = w119 * c1 - w119 * c2
    w121 = w7 * w14 + w6 * w25
    w122 = w121 * c2 - w121 * c4
    w123 = w2 * w25
    w124 = w4 * w14 + w123
    w125 = w124 * c4 - w124 * c1
    w126 = (w18 - w11 * w69) / body_e0
    w127 = w11 * w73 - (w6 * w120 + w0 * w122 + w1 * w125) + w74 * w126
    w128 = w114 + w3 * w7
    w129 = w128 * c1 - w128 * c2
    w130 = w54 + w123
    w131 = w130 * c2 - w130 * c4
    w132 = w0 * w4 + w3 * w25
    w133 = w132 * c4 - w132 * c1
    w134 = (w20 - w12 * w69) / body_e0
    w135 = w12 * w73 - (w6 * w129 + w0 * w131 + w1 * w133) + w74 * w134
    # outputs
    J_q = ca.SX(6, 6)
    # body.e1
    J_q[3, 3] = w9 * w34 - (w2 * w38 + w1 * w42 + w5 * w46 - w53) + w63 * w64 + w68 * w70 - w9 * w75
    J_q[3, 4] = w11 * w34 - (w2 * w87 + w1 * w90 + (w81 + w5 * w93)) + w63 * w94 + w68 * w95 - w9 * w97
    J_q[3, 5] = w12 * w34 - (w2 * w100 + (w96 + w1 * w103) + w5 * w105) + w63 * w106 + w68 * w107 - w9 * w108
    # body.e2
    J_q[4, 3] = w9 * w77 - (w14 * w38 + w2 * w42 + (w78 + w6 * w46)) + w64 * w79 + w70 * w80 - w11 * w75
    J_q[4, 4] = w11 * w77 - (w14 * w87 + w2 * w90 + w6 * w93 - w53) + w79 * w94 + w80 * w95 - w11 * w97
    J_q[4, 5] = w12 * w77 - (w17 + w14 * w100 + w2 * w103 + w6 * w105) + w79 * w106 + w80 * w107 - w11 * w108
    # body.e3
    J_q[5, 3] = w9 * w82 - (w0 * w38 + (w76 + w3 * w42) + w2 * w46) + w64 * w83 + w70 * w84 - w12 * w75
    J_q[5, 4] = w11 * w82 - (w72 + w0 * w87 + w3 * w90 + w2 * w93) + w83 * w94 + w84 * w95 - w12 * w97
    J_q[5, 5] = w12 * w82 - (w0 * w100 + w3 * w103 + w2 * w105 - w53) + w83 * w106 + w84 * w107 - w12 * w108
    J_v = ca.SX(6, 6)
    # body.e1
    J_v[3, 3] = w9 * w63 - (w2 * w110 + w1 * w113 + w5 * w116) + w68 * w117 - w9 * w118
    J_v[3, 4] = w11 * w63 - (w2 * w120 + w1 * w122 + w5 * w125) + w68 * w126 - w9 * w127
    J_v[3, 5] = w12 * w63 - (w2 * w129 + w1 * w131 + w5 * w133) + w68 * w134 - w9 * w135
    # body.e2
    J_v[4, 3] = w9 * w79 - (w14 * w110 + w2 * w113 + w6 * w116) + w80 * w117 - w11 * w118
    J_v[4, 4] = w11 * w79 - (w14 * w120 + w2 * w122 + w6 * w125) + w80 * w126 - w11 * w127
    J_v[4, 5] = w12 * w79 - (w14 * w129 + w2 * w131 + w6 * w133) + w80 * w134 - w11 * w135
    # body.e3
    J_v[5, 3] = w9 * w83 - (w0 * w110 + w3 * w113 + w2 * w116) + w84 * w117 - w12 * w118
    J_v[5, 4] = w11 * w83 - (w0 * w120 + w3 * w122 + w2 * w125) + w84 * w126 - w12 * w127
    J_v[5, 5] = w12 * w83 - (w0 * w129 + w3 * w131 + w2 * w133) + w84 * w134 - w12 * w135
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 6) [mixed]: independent coordinates, in the order of the partition
    takes q_d (n_d = 1) [mixed]: dependent coordinates, q_d = f(q_i, t)
    takes q_i_dot (n_i = 6) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 1) [mixed]: rates of the dependent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 6) [mixed]: accelerations of the independent coordinates
    225 operations.
    """
    q_i = ca.SX.sym("q_i", 6)
    q_d = ca.SX.sym("q_d", 1)
    q_i_dot = ca.SX.sym("q_i_dot", 6)
    q_d_dot = ca.SX.sym("q_d_dot", 1)
    c = ca.SX.sym("c", 23)
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
    c11 = c[11]
    c12 = c[12]
    c22 = c[22]
    # intermediate terms (46)
    w0 = 2 * body_e0
    w1 = body_e1 * -2.0
    w2 = w1 * c3
    w3 = body_e3 * -2.0
    w4 = body_e2 * -2.0
    w5 = w4 * c5
    w6 = 2 * body_e2
    w7 = w3 * c6
    w8 = w0 * w2 + body_e3 * body_e2 * c7
    w9 = (body_e0_dot**2 + body_e1_dot**2 + body_e2_dot**2 + body_e3_dot**2) / body_e0
    w10 = 2 * body_e1
    w11 = w4 * body_e0_dot + w3 * body_e1_dot + w0 * body_e2_dot + body_e3_dot * w10
    w12 = w3 * body_e0_dot + w6 * body_e1_dot + w1 * body_e2_dot + w0 * body_e3_dot
    w13 = w11 * w12
    w14 = w13 * c1 - w13 * c2
    w15 = 2 * body_e3
    w16 = w1 * body_e0_dot + w0 * body_e1_dot + body_e2_dot * w15 + w4 * body_e3_dot
    w17 = w12 * w16
    w18 = w17 * c2 - w17 * c4
    w19 = w11 * w16
    w20 = w19 * c4 - w19 * c1
    w21 = body_e1 / body_e0
    w22 = w1 * w2 + w4 * w5 + w3 * w7
    w23 = w9 * w22 - (w1 * w14 + w4 * w18 + w3 * w20)
    w24 = w3 * c5
    w25 = w6 * c6
    w26 = body_e1 * body_e2 * c11 + w0 * w7
    w27 = body_e3 / body_e0
    w28 = w26 - w22 * w27
    w29 = w10 * w24 + body_e0 * body_e2 * c22 - (w21 * w28 + w8 * w27)
    w30 = w4 * (w4 * c3) + w10 * (w10 * c5) + w0 * (w0 * c6) - (w27 * w28 + w26 * w27)
    w31 = w29 / w30
    w32 = w9 * w26 - (w4 * w14 + w10 * w18 + w0 * w20) - w23 * w27
    w33 = w0 * w5 + body_e1 * body_e3 * c9
    w34 = body_e2 / body_e0
    w35 = w33 - w22 * w34
    w36 = w15 * c3
    w37 = w4 * w36 + body_e0 * body_e1 * c12 - (w28 * w34 + w27 * w33)
    w38 = body_e0 * body_e3 * c8 + w1 * w25 - (w21 * w35 + w8 * w34) - w31 * w37
    w39 = w37 / w30
    w40 = w15 * w36 + w0 * (w0 * c5) + w1 * (w1 * c6) - (w34 * w35 + w33 * w34) - w37 * w39
    w41 = w38 / w40
    w42 = w9 * w33 - (w14 * w15 + w0 * w18 + w1 * w20) - w23 * w34 - w32 * w39
    w43 = w0 * (w0 * c3) + w3 * w24 + w6 * w25 - (w21 * (w8 - w21 * w22) + w8 * w21) - w29 * w31 - w38 * w41
    w44 = (w8 * w9 - (w0 * w14 + w3 * w18 + w6 * w20) - w21 * w23 - w31 * w32 - w41 * w42) / w43
    w45 = (w42 - w38 * w44) / w40
    # outputs
    q_i_ddot = ca.SX(6, 1)
    q_i_ddot[3] = w44  # body.e1
    q_i_ddot[4] = w45  # body.e2
    q_i_ddot[5] = (w32 - (w29 * w44 + w37 * w45)) / w30  # body.e3
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
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
