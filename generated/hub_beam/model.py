"""Hub with a flexible beam (F2): equations of motion, emitted by symgen from the scene `hub_beam`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 hub.theta [rad], 1 beam.q1 [m], 2 beam.q2 [m], 3 beam.q3 [m]

q_d, the dependent coordinates by index:
    0 hub.x [m], 1 hub.y [m], 2 beam.x [m], 3 beam.y [m], 4 beam.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 295) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    68 operations.
    """
    p = ca.SX.sym("p", 295)
    torque = p[0]
    hub_mass = p[1]
    hub_inertia = p[2]
    beam_length = p[3]
    beam_density = p[4]
    beam_area = p[5]
    beam_youngs_modulus = p[6]
    beam_second_moment = p[7]
    beam_clamped_free3_kappa_lateral_0_0 = p[8]
    beam_clamped_free3_kappa_lateral_1_1 = p[9]
    beam_clamped_free3_kappa_lateral_2_2 = p[10]
    beam_clamped_free3_mass_0_0 = p[11]
    beam_clamped_free3_mass_1_1 = p[12]
    beam_clamped_free3_mass_2_2 = p[13]
    beam_clamped_free3_s1_0_0 = p[14]
    beam_clamped_free3_i0_0_0 = p[15]
    beam_clamped_free3_phi_y_0_0 = p[16]
    beam_clamped_free3_phi_y_1_0 = p[17]
    beam_clamped_free3_phi_y_2_0 = p[18]
    beam_clamped_free3_xi_phi_y_0_0 = p[19]
    beam_clamped_free3_xi_phi_y_1_0 = p[20]
    beam_clamped_free3_xi_phi_y_2_0 = p[21]
    beam_clamped_free3_H_0_0 = p[22]
    beam_clamped_free3_H_0_1 = p[23]
    beam_clamped_free3_H_0_2 = p[24]
    beam_clamped_free3_H_1_0 = p[25]
    beam_clamped_free3_H_1_1 = p[26]
    beam_clamped_free3_H_1_2 = p[27]
    beam_clamped_free3_H_2_0 = p[28]
    beam_clamped_free3_H_2_1 = p[29]
    beam_clamped_free3_H_2_2 = p[30]
    beam_clamped_free3_xH_0_0 = p[31]
    beam_clamped_free3_xH_0_1 = p[32]
    beam_clamped_free3_xH_0_2 = p[33]
    beam_clamped_free3_xH_1_0 = p[34]
    beam_clamped_free3_xH_1_1 = p[35]
    beam_clamped_free3_xH_1_2 = p[36]
    beam_clamped_free3_xH_2_0 = p[37]
    beam_clamped_free3_xH_2_1 = p[38]
    beam_clamped_free3_xH_2_2 = p[39]
    beam_clamped_free3_1_0_shape_1_0 = p[40]
    beam_clamped_free3_1_0_shape_1_1 = p[41]
    beam_clamped_free3_1_0_shape_1_2 = p[42]
    beam_clamped_free3_1_0_H_0_0 = p[46]
    beam_clamped_free3_1_0_H_0_1 = p[47]
    beam_clamped_free3_1_0_H_0_2 = p[48]
    beam_clamped_free3_1_0_H_1_0 = p[49]
    beam_clamped_free3_1_0_H_1_1 = p[50]
    beam_clamped_free3_1_0_H_1_2 = p[51]
    beam_clamped_free3_1_0_H_2_0 = p[52]
    beam_clamped_free3_1_0_H_2_1 = p[53]
    beam_clamped_free3_1_0_H_2_2 = p[54]
    # intermediate terms (27)
    w0 = beam_density * beam_area
    w1 = w0 * beam_length
    w2 = beam_length**2
    w3 = w1 * w2 * beam_clamped_free3_i0_0_0
    w4 = w1 * beam_clamped_free3_mass_0_0
    w5 = w1 * beam_clamped_free3_xH_0_0
    w6 = w1 * beam_clamped_free3_xH_0_1
    w7 = w1 * beam_clamped_free3_xH_0_2
    w8 = w1 * beam_clamped_free3_mass_1_1
    w9 = w1 * beam_clamped_free3_xH_1_0
    w10 = w1 * beam_clamped_free3_xH_1_1
    w11 = w1 * beam_clamped_free3_xH_1_2
    w12 = w1 * beam_clamped_free3_mass_2_2
    w13 = w1 * beam_clamped_free3_xH_2_0
    w14 = w1 * beam_clamped_free3_xH_2_1
    w15 = w1 * beam_clamped_free3_xH_2_2
    w16 = beam_length * w1
    w17 = w16 * beam_clamped_free3_xi_phi_y_0_0
    w18 = w16 * beam_clamped_free3_xi_phi_y_1_0
    w19 = w16 * beam_clamped_free3_xi_phi_y_2_0
    w20 = beam_youngs_modulus * beam_second_moment / (beam_length * w2)
    w21 = w1 * beam_clamped_free3_phi_y_0_0
    w22 = w1 * beam_clamped_free3_phi_y_1_0
    w23 = w1 * beam_clamped_free3_phi_y_2_0
    w24 = w19 / w12
    w25 = w18 / w8
    w26 = w17 / w4
    # outputs
    c = ca.vertcat(
        w4,  # c0
        w5,  # c1
        w6,  # c2
        w7,  # c3
        w8,  # c4
        w9,  # c5
        w10,  # c6
        w11,  # c7
        w12,  # c8
        w13,  # c9
        w14,  # c10
        w15,  # c11
        hub_inertia + w3,  # c12
        w17,  # c13
        w18,  # c14
        w19,  # c15
        torque,  # torque
        w20 * beam_clamped_free3_kappa_lateral_0_0,  # c17
        w20 * beam_clamped_free3_kappa_lateral_1_1,  # c18
        w20 * beam_clamped_free3_kappa_lateral_2_2,  # c19
        hub_inertia,  # hub_inertia
        w1,  # c21
        w3,  # c22
        hub_mass,  # hub_mass
        w16 * beam_clamped_free3_s1_0_0,  # c24
        w0 * beam_clamped_free3_H_0_0,  # c25
        w0 * beam_clamped_free3_H_0_1,  # c26
        w0 * beam_clamped_free3_H_0_2,  # c27
        w0 * beam_clamped_free3_H_1_0,  # c28
        w0 * beam_clamped_free3_H_1_1,  # c29
        w0 * beam_clamped_free3_H_1_2,  # c30
        w0 * beam_clamped_free3_H_2_0,  # c31
        w0 * beam_clamped_free3_H_2_1,  # c32
        w0 * beam_clamped_free3_H_2_2,  # c33
        w21,  # c34
        w22,  # c35
        w23,  # c36
        -w21,  # c37
        -w22,  # c38
        -w23,  # c39
        beam_length,  # beam_length
        beam_clamped_free3_1_0_H_0_0 / beam_length,  # c41
        beam_clamped_free3_1_0_H_0_1 / beam_length,  # c42
        beam_clamped_free3_1_0_H_0_2 / beam_length,  # c43
        beam_clamped_free3_1_0_H_1_0 / beam_length,  # c44
        beam_clamped_free3_1_0_H_1_1 / beam_length,  # c45
        beam_clamped_free3_1_0_H_1_2 / beam_length,  # c46
        beam_clamped_free3_1_0_H_2_0 / beam_length,  # c47
        beam_clamped_free3_1_0_H_2_1 / beam_length,  # c48
        beam_clamped_free3_1_0_H_2_2 / beam_length,  # c49
        beam_clamped_free3_1_0_shape_1_0,  # beam_clamped_free3_1_0_shape_1_0
        beam_clamped_free3_1_0_shape_1_1,  # beam_clamped_free3_1_0_shape_1_1
        beam_clamped_free3_1_0_shape_1_2,  # beam_clamped_free3_1_0_shape_1_2
        w4 - w5,  # c53
        w8 - w10,  # c54
        w12 - w15,  # c55
        -w9,  # c56
        -w13,  # c57
        -w6,  # c58
        -w14,  # c59
        -w7,  # c60
        -w11,  # c61
        w24,  # c62
        w25,  # c63
        w26,  # c64
        w19 * w24,  # c65
        w18 * w25,  # c66
        w17 * w26,  # c67
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 4 x 4) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 4) [N, N m]: condensed force S^T (Q* - M s)
    50 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    torque = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    # intermediate terms (5)
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * torque, 0) + beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot)
    w4 = beam_theta_dot**2
    # outputs
    M_hat = ca.SX(4, 4)
    # hub.theta
    M_hat[0, 0] = beam_q3 * w2 + (beam_q2 * w1 + (beam_q1 * w0 + c12))
    M_hat[0, 1] = c13
    M_hat[0, 2] = c14
    M_hat[0, 3] = c15
    # beam.q1
    M_hat[1, 0] = c13
    M_hat[1, 1] = c0
    # beam.q2
    M_hat[2, 0] = c14
    M_hat[2, 2] = c4
    # beam.q3
    M_hat[3, 0] = c15
    M_hat[3, 3] = c8
    Q_hat = ca.vertcat(
        w3,  # hub.theta
        w0 * w4 - beam_q1 * c17,  # beam.q1
        w1 * w4 - beam_q2 * c18,  # beam.q2
        w2 * w4 - beam_q3 * c19,  # beam.q3
    )
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    gives q_d_next (n_d = 5) [mixed]: dependent coordinates after one Newton step
    0 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    hub_theta = q_i[0]
    # outputs
    q_d_next = ca.SX(5, 1)
    q_d_next[4] = hub_theta  # beam.theta
    inputs, outputs = [q_i], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    gives q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    0 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    hub_theta_dot = q_i_dot[0]
    # outputs
    q_d_dot = ca.SX(5, 1)
    q_d_dot[4] = hub_theta_dot  # beam.theta
    inputs, outputs = [q_i_dot], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i_dot"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    gives q_d_ddot (n_d = 5) [mixed]: accelerations of the dependent coordinates
    0 operations.
    """
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    hub_theta_ddot = q_i_ddot[0]
    # outputs
    q_d_ddot = ca.SX(5, 1)
    q_d_ddot[4] = hub_theta_ddot  # beam.theta
    inputs, outputs = [q_i_ddot], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i_ddot"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives C (n_c = 5) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 5 x 9) [SI]: constraint Jacobian
    gives C_t (n_c = 5) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 5) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 5) [m/s^2, rad/s^2]: right-hand side at acceleration level
    3 operations.
    """
    q = ca.SX.sym("q", 9)
    hub_x = q[0]
    hub_y = q[1]
    hub_theta = q[2]
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    # outputs
    C = ca.vertcat(
        hub_x,  # pivot.x
        hub_y,  # pivot.y
        beam_x - hub_x,  # clamp.x
        beam_y - hub_y,  # clamp.y
        beam_theta - hub_theta,  # clamp.angle
    )
    C_q = ca.SX(5, 9)
    # pivot.x
    C_q[0, 0] = 1.0
    # pivot.y
    C_q[1, 1] = 1.0
    # clamp.x
    C_q[2, 0] = -1.0
    C_q[2, 3] = 1.0
    # clamp.y
    C_q[3, 1] = -1.0
    C_q[3, 4] = 1.0
    # clamp.angle
    C_q[4, 2] = -1.0
    C_q[4, 5] = 1.0
    C_t = ca.SX(5, 1)
    nu = ca.SX(5, 1)
    gamma = ca.SX(5, 1)
    inputs, outputs = [q], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 9 x 9) [SI]: mass matrix in all coordinates
    gives K (n x n = 9 x 9) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 9) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 9) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 9) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 5 x 9) [SI]: constraint Jacobian
    gives gamma (n_c = 5) [m/s^2, rad/s^2]: right-hand side at acceleration level
    150 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
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
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    torque = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    hub_inertia = c[20]
    c21 = c[21]
    c22 = c[22]
    hub_mass = c[23]
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
    c38 = c[38]
    c39 = c[39]
    # intermediate terms (32)
    w0 = ca.sin(beam_theta)
    w1 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w2 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w3 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w4 = c24 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3) * 0.5
    w5 = ca.cos(beam_theta)
    w6 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w7 = w0 * w4 + w5 * w6
    w8 = -w7
    w9 = w4 * w5 - w0 * w6
    w10 = w5 * c34 - w0 * w1
    w11 = w5 * c35 - w0 * w2
    w12 = w5 * c36 - w0 * w3
    w13 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w14 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w15 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w16 = beam_theta_dot**2
    w17 = 2 * beam_theta_dot
    w18 = beam_q1_dot * c34 + beam_q2_dot * c35 + beam_q3_dot * c36
    w19 = w1 * beam_q1_dot + w2 * beam_q2_dot + w3 * beam_q3_dot
    w20 = beam_q1_dot * (beam_q1_dot * c25 + beam_q2_dot * c26 + beam_q3_dot * c27) + beam_q2_dot * (beam_q1_dot * c28 + beam_q2_dot * c29 + beam_q3_dot * c30)
    w21 = w20 + beam_q3_dot * (beam_q1_dot * c31 + beam_q2_dot * c32 + beam_q3_dot * c33)
    w22 = w9 * w16 + w17 * (w5 * w18 - w0 * w19) + w5 * w21
    w23 = w7 * w16 + w0 * w21 + w17 * (w5 * w19 + w0 * w18)
    w24 = beam_theta_dot * -2.0 * (w13 * beam_q1_dot + w14 * beam_q2_dot + w15 * beam_q3_dot)
    w25 = w13 * w16
    w26 = w14 * w16
    w27 = w15 * w16
    w28 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * torque, 0)
    w29 = w0 * c37 - w1 * w5
    w30 = w0 * c38 - w2 * w5
    w31 = w0 * c39 - w3 * w5
    # outputs
    M = ca.SX(9, 9)
    # hub.x
    M[0, 0] = hub_mass
    # hub.y
    M[1, 1] = hub_mass
    # hub.theta
    M[2, 2] = hub_inertia
    # beam.x
    M[3, 3] = c21
    M[3, 5] = w8
    M[3, 6] = w29
    M[3, 7] = w30
    M[3, 8] = w31
    # beam.y
    M[4, 4] = c21
    M[4, 5] = w9
    M[4, 6] = w10
    M[4, 7] = w11
    M[4, 8] = w12
    # beam.theta
    M[5, 3] = w8
    M[5, 4] = w9
    M[5, 5] = c22 + (beam_q1 * w13 + beam_q2 * w14 + beam_q3 * w15)
    M[5, 6] = c13
    M[5, 7] = c14
    M[5, 8] = c15
    # beam.q1
    M[6, 3] = w29
    M[6, 4] = w10
    M[6, 5] = c13
    M[6, 6] = c0
    # beam.q2
    M[7, 3] = w30
    M[7, 4] = w11
    M[7, 5] = c14
    M[7, 7] = c4
    # beam.q3
    M[8, 3] = w31
    M[8, 4] = w12
    M[8, 5] = c15
    M[8, 8] = c8
    K = ca.SX(9, 9)
    # beam.q1
    K[6, 6] = c17
    # beam.q2
    K[7, 7] = c18
    # beam.q3
    K[8, 8] = c19
    Q_v = ca.vertcat(
        0.0,  # hub.x
        0.0,  # hub.y
        0.0,  # hub.theta
        w22,  # beam.x
        w23,  # beam.y
        w24,  # beam.theta
        w25,  # beam.q1
        w26,  # beam.q2
        w27,  # beam.q3
    )
    Q_F = ca.SX(9, 1)
    Q_F[2] = w28  # hub.theta
    Q_star = ca.vertcat(
        0.0,  # hub.x
        0.0,  # hub.y
        w28,  # hub.theta
        w22,  # beam.x
        w23,  # beam.y
        w24,  # beam.theta
        w25 - beam_q1 * c17,  # beam.q1
        w26 - beam_q2 * c18,  # beam.q2
        w27 - beam_q3 * c19,  # beam.q3
    )
    C_q = ca.SX(5, 9)
    # pivot.x
    C_q[0, 0] = 1.0
    # pivot.y
    C_q[1, 1] = 1.0
    # clamp.x
    C_q[2, 0] = -1.0
    C_q[2, 3] = 1.0
    # clamp.y
    C_q[3, 1] = -1.0
    C_q[3, 4] = 1.0
    # clamp.angle
    C_q[4, 2] = -1.0
    C_q[4, 5] = 1.0
    gamma = ca.SX(5, 1)
    inputs, outputs = [q, q_dot, t, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes q_ddot (n = 9) [mixed]: accelerations of all coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 5) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 2) [N, N m]: world force and moment of a joint on its body b, at b
    176 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 68)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
    hub_x_ddot = q_ddot[0]
    hub_y_ddot = q_ddot[1]
    beam_x_ddot = q_ddot[3]
    beam_y_ddot = q_ddot[4]
    beam_theta_ddot = q_ddot[5]
    beam_q1_ddot = q_ddot[6]
    beam_q2_ddot = q_ddot[7]
    beam_q3_ddot = q_ddot[8]
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
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c21 = c[21]
    c22 = c[22]
    hub_mass = c[23]
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
    # intermediate terms (26)
    w0 = beam_theta_dot**2
    w1 = ca.cos(beam_theta)
    w2 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w3 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w4 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w5 = c24 - (beam_q1 * w2 + beam_q2 * w3 + beam_q3 * w4) * 0.5
    w6 = ca.sin(beam_theta)
    w7 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w8 = w1 * w5 - w6 * w7
    w9 = 2 * beam_theta_dot
    w10 = beam_q1_dot * c34 + beam_q2_dot * c35 + beam_q3_dot * c36
    w11 = w2 * beam_q1_dot + w3 * beam_q2_dot + w4 * beam_q3_dot
    w12 = beam_q1_dot * (beam_q1_dot * c25 + beam_q2_dot * c26 + beam_q3_dot * c27) + beam_q2_dot * (beam_q1_dot * c28 + beam_q2_dot * c29 + beam_q3_dot * c30)
    w13 = w12 + beam_q3_dot * (beam_q1_dot * c31 + beam_q2_dot * c32 + beam_q3_dot * c33)
    w14 = w5 * w6 + w1 * w7
    w15 = beam_x_ddot * c21 - w14 * beam_theta_ddot - (w1 * w2 + w6 * c34) * beam_q1_ddot - (w1 * w3 + w6 * c35) * beam_q2_ddot
    w16 = w0 * w8 + w9 * (w1 * w10 - w6 * w11) + w1 * w13 - (w15 - (w1 * w4 + w6 * c36) * beam_q3_ddot)
    w17 = w16 - hub_x_ddot * hub_mass
    w18 = beam_y_ddot * c21 + w8 * beam_theta_ddot + beam_q1_ddot * (w1 * c34 - w2 * w6) + beam_q2_ddot * (w1 * c35 - w3 * w6)
    w19 = w0 * w14 + w6 * w13 + w9 * (w1 * w11 + w6 * w10) - (w18 + beam_q3_ddot * (w1 * c36 - w4 * w6))
    w20 = w19 - hub_y_ddot * hub_mass
    w21 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w22 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w23 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w24 = w8 * beam_y_ddot - beam_x_ddot * w14 + beam_theta_ddot * (c22 + (beam_q1 * w21 + beam_q2 * w22 + beam_q3 * w23))
    w25 = beam_theta_dot * -2.0 * (beam_q1_dot * w21 + beam_q2_dot * w22 + beam_q3_dot * w23) - (w24 + beam_q1_ddot * c13 + beam_q2_ddot * c14 + beam_q3_ddot * c15)
    # outputs
    lam = ca.vertcat(
        w17,  # pivot.x
        w20,  # pivot.y
        w16,  # clamp.x
        w19,  # clamp.y
        w25,  # clamp.angle
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w17, -w20, 0.0),  # pivot
        ca.vertcat(-w16, -w19, -w25),  # clamp
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    166 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    hub_x_dot = q_dot[0]
    hub_y_dot = q_dot[1]
    hub_theta_dot = q_dot[2]
    beam_x_dot = q_dot[3]
    beam_y_dot = q_dot[4]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
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
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    torque = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    hub_inertia = c[20]
    c21 = c[21]
    c22 = c[22]
    hub_mass = c[23]
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
    # intermediate terms (24)
    w0 = hub_x_dot * (hub_x_dot * hub_mass) + hub_y_dot * (hub_y_dot * hub_mass) + hub_theta_dot * (hub_theta_dot * hub_inertia)
    w1 = ca.sin(beam_theta)
    w2 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w3 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w4 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w5 = c24 - (beam_q1 * w2 + beam_q2 * w3 + beam_q3 * w4) * 0.5
    w6 = ca.cos(beam_theta)
    w7 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w8 = w1 * w5 + w6 * w7
    w9 = w2 * w6 + w1 * c34
    w10 = w3 * w6 + w1 * c35
    w11 = w4 * w6 + w1 * c36
    w12 = beam_x_dot * c21 - w8 * beam_theta_dot - w9 * beam_q1_dot - w10 * beam_q2_dot - w11 * beam_q3_dot
    w13 = w5 * w6 - w1 * w7
    w14 = w6 * c34 - w1 * w2
    w15 = w6 * c35 - w1 * w3
    w16 = w6 * c36 - w1 * w4
    w17 = beam_y_dot * c21 + beam_theta_dot * w13 + beam_q1_dot * w14 + beam_q2_dot * w15 + beam_q3_dot * w16
    w18 = beam_q1 * (beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)) + beam_q2 * (beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7))
    w19 = beam_theta_dot * (c22 + (w18 + beam_q3 * (beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11))))
    w20 = beam_y_dot * w13 - beam_x_dot * w8 + w19 + beam_q1_dot * c13 + beam_q2_dot * c14 + beam_q3_dot * c15
    w21 = w0 + beam_x_dot * w12 + beam_y_dot * w17 + beam_theta_dot * w20 + beam_q1_dot * (beam_y_dot * w14 - beam_x_dot * w9 + beam_theta_dot * c13 + beam_q1_dot * c0)
    w22 = w21 + beam_q2_dot * (beam_y_dot * w15 - beam_x_dot * w10 + beam_theta_dot * c14 + beam_q2_dot * c4)
    w23 = w22 + beam_q3_dot * (beam_y_dot * w16 - beam_x_dot * w11 + beam_theta_dot * c15 + beam_q3_dot * c8)
    # outputs
    kinetic = ca.vertcat(w23 / 2.0)
    elastic = ca.vertcat((beam_q1 * (beam_q1 * c17) + beam_q2 * (beam_q2 * c18) + beam_q3 * (beam_q3 * c19)) / 2.0)
    potential = ca.SX(1, 1)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.vertcat(ca.if_else(t < 2.0, hub_theta_dot * (ca.sin(t * 3.141592653589793) * torque), 0))
    inputs, outputs = [q, q_dot, t, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 9) [mixed]: rates of all coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives measures (measures = 4) [mixed]: measures of the scene and their rates
    87 operations.
    """
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 68)
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_x_dot = q_dot[3]
    beam_y_dot = q_dot[4]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
    beam_length = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    beam_clamped_free3_1_0_shape_1_0 = c[50]
    beam_clamped_free3_1_0_shape_1_1 = c[51]
    beam_clamped_free3_1_0_shape_1_2 = c[52]
    # intermediate terms (12)
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * c41 + beam_q2 * c42 + beam_q3 * c43
    w2 = beam_q1 * c44 + beam_q2 * c45 + beam_q3 * c46
    w3 = beam_q1 * c47 + beam_q2 * c48 + beam_q3 * c49
    w4 = beam_length - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3) * 0.5
    w5 = ca.sin(beam_theta)
    w6 = beam_q1 * beam_clamped_free3_1_0_shape_1_0 + beam_q2 * beam_clamped_free3_1_0_shape_1_1 + beam_q3 * beam_clamped_free3_1_0_shape_1_2
    w7 = w5 * beam_theta_dot
    w8 = w1 * beam_q1_dot + beam_q1 * (beam_q1_dot * c41 + beam_q2_dot * c42 + beam_q3_dot * c43) + (w2 * beam_q2_dot + beam_q2 * (beam_q1_dot * c44 + beam_q2_dot * c45 + beam_q3_dot * c46))
    w9 = (w8 + (w3 * beam_q3_dot + beam_q3 * (beam_q1_dot * c47 + beam_q2_dot * c48 + beam_q3_dot * c49))) * 0.5
    w10 = w0 * beam_theta_dot
    w11 = beam_q1_dot * beam_clamped_free3_1_0_shape_1_0 + beam_q2_dot * beam_clamped_free3_1_0_shape_1_1 + beam_q3_dot * beam_clamped_free3_1_0_shape_1_2
    # outputs
    measures = ca.vertcat(
        beam_x + (w0 * w4 - w5 * w6),  # tip_x
        beam_x_dot - (w4 * w7 + w0 * w9 + (w6 * w10 + w5 * w11)),  # tip_x_dot
        beam_y + (w4 * w5 + w0 * w6),  # tip_y
        beam_y_dot + (w4 * w10 - w5 * w9 + (w0 * w11 - w6 * w7)),  # tip_y_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3) [N, N m]: world force and moment of a load on its marker, or b
    5 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    torque = c[16]
    # outputs
    load_actions = ca.vertcat(0.0, 0.0, ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * torque, 0))
    inputs, outputs = [t, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["t", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 9) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 2) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    6 operations.
    """
    q = ca.SX.sym("q", 9)
    hub_x = q[0]
    hub_y = q[1]
    hub_theta = q[2]
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    # intermediate terms (4)
    w0 = ca.cos(hub_theta)
    w1 = ca.sin(hub_theta)
    w2 = ca.cos(beam_theta)
    w3 = ca.sin(beam_theta)
    # outputs
    poses = ca.SX(12, 2)
    poses[0, 0] = hub_x
    poses[0, 1] = beam_x
    poses[1, 0] = hub_y
    poses[1, 1] = beam_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def switching() -> ca.Function:
    """Where in time loads and prescribed motions jump or kink: where one of these changes its sign.

    takes t (1) [s]: time
    gives switching (conditions in t = 1) [SI]: zero where a load or a prescribed motion jumps or kinks
    1 operations.
    """
    t = ca.SX.sym("t", 1)
    # outputs
    switching = ca.vertcat(t - 2.0)
    inputs, outputs = [t], [ca.densify(switching)]
    return ca.Function("switching", inputs, outputs, ["t"], ["switching"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i, through q_d
    32 operations.
    """
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    c = ca.SX.sym("c", 68)
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (2)
    w0 = beam_theta_dot * -2.0
    w1 = beam_theta_dot**2
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(  # hub.theta
            0.0, w0 * (beam_q1_dot * c53 - beam_q2_dot * c5 - beam_q3_dot * c9),
            w0 * (beam_q2_dot * c54 - beam_q1_dot * c2 - beam_q3_dot * c10),
            w0 * (beam_q3_dot * c55 - (beam_q1_dot * c3 + beam_q2_dot * c7)),
        ),
        ca.horzcat(0.0, w1 * c53 - c17, w1 * c58, w1 * c60),  # beam.q1
        ca.horzcat(0.0, w1 * c56, w1 * c54 - c18, w1 * c61),  # beam.q2
        ca.horzcat(0.0, w1 * c57, w1 * c59, w1 * c55 - c19),  # beam.q3
    )
    inputs, outputs = [q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    35 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    # intermediate terms (5)
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = 2 * beam_theta_dot
    w4 = beam_theta_dot * -2.0
    # outputs
    dQ_hat_dq_i_dot = ca.SX(4, 4)
    # hub.theta
    dQ_hat_dq_i_dot[0, 0] = (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot) * -2.0
    dQ_hat_dq_i_dot[0, 1] = w0 * w4
    dQ_hat_dq_i_dot[0, 2] = w1 * w4
    dQ_hat_dq_i_dot[0, 3] = w2 * w4
    # beam.q1
    dQ_hat_dq_i_dot[1, 0] = w0 * w3
    # beam.q2
    dQ_hat_dq_i_dot[2, 0] = w1 * w3
    # beam.q3
    dQ_hat_dq_i_dot[3, 0] = w2 * w3
    inputs, outputs = [q_i, q_i_dot, q_d_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 4 x 4) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    90 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
    hub_theta_ddot = q_i_ddot[0]
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
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    # intermediate terms (9)
    w0 = beam_theta_dot * -2.0
    w1 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w2 = w0 * (beam_q1_dot * c53 - beam_q2_dot * c5 - beam_q3_dot * c9) - hub_theta_ddot * (w1 + beam_q1 * c53 - beam_q2 * c5 - beam_q3 * c9)
    w3 = beam_theta_dot**2
    w4 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w5 = w0 * (beam_q2_dot * c54 - beam_q1_dot * c2 - beam_q3_dot * c10) - hub_theta_ddot * (w4 + beam_q2 * c54 - beam_q1 * c2 - beam_q3 * c10)
    w6 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w7 = w0 * (beam_q3_dot * c55 - (beam_q1_dot * c3 + beam_q2_dot * c7)) - hub_theta_ddot * (w6 + beam_q3 * c55 - (beam_q1 * c3 + beam_q2 * c7))
    w8 = 2 * beam_theta_dot
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(0.0, w2, w5, w7),  # hub.theta
        ca.horzcat(0.0, w3 * c53 - c17, w3 * c58, w3 * c60),  # beam.q1
        ca.horzcat(0.0, w3 * c56, w3 * c54 - c18, w3 * c61),  # beam.q2
        ca.horzcat(0.0, w3 * c57, w3 * c59, w3 * c55 - c19),  # beam.q3
    )
    J_v = ca.SX(4, 4)
    # hub.theta
    J_v[0, 0] = (beam_q1_dot * w1 + beam_q2_dot * w4 + beam_q3_dot * w6) * -2.0
    J_v[0, 1] = w0 * w1
    J_v[0, 2] = w0 * w4
    J_v[0, 3] = w0 * w6
    # beam.q1
    J_v[1, 0] = w1 * w8
    # beam.q2
    J_v[2, 0] = w4 * w8
    # beam.q3
    J_v[3, 0] = w6 * w8
    inputs, outputs = [q_i, q_i_dot, q_d_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 4 x 3) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 3 x 3) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 3 x 3) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 68)
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    # outputs
    B = ca.SX(4, 3)
    # beam.q1
    B[1, 0] = 1.0
    # beam.q2
    B[2, 1] = 1.0
    # beam.q3
    B[3, 2] = 1.0
    K_s = ca.SX(3, 3)
    K_s[0, 0] = c17
    K_s[1, 1] = c18
    K_s[2, 2] = c19
    D_s = ca.SX(3, 3)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    70 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    torque = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    hub_inertia = c[20]
    c22 = c[22]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    # intermediate terms (9)
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = beam_theta_dot**2
    w4 = w2 * w3 - beam_q3 * c19
    w5 = w1 * w3 - beam_q2 * c18
    w6 = beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot) - w4 * c62 - w5 * c63
    w7 = w0 * w3 - beam_q1 * c17
    w8 = (ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * torque, 0) + (w6 - w7 * c64)) / (hub_inertia + (c22 + (beam_q1 * w0 + beam_q2 * w1 + beam_q3 * w2) - c65 - c66 - c67))
    # outputs
    q_i_ddot = ca.vertcat(
        w8,  # hub.theta
        w7 / c0 - w8 * c64,  # beam.q1
        w5 / c4 - w8 * c63,  # beam.q2
        w4 / c8 - w8 * c62,  # beam.q3
    )
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1 x 3) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 3) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 3 x 3) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 3) [N, N m]: part of Q_hat of S
    50 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    torque = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    # intermediate terms (5)
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * torque, 0) + beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot)
    w4 = beam_theta_dot**2
    # outputs
    M_hat_LL = ca.vertcat(beam_q3 * w2 + (beam_q2 * w1 + (c12 + beam_q1 * w0)))
    M_hat_LS = ca.horzcat(
        c13, c14, c15,
    )
    M_hat_SL = ca.vertcat(c13, c14, c15)
    M_hat_SS = ca.SX(3, 3)
    # beam.q1
    M_hat_SS[0, 0] = c0
    # beam.q2
    M_hat_SS[1, 1] = c4
    # beam.q3
    M_hat_SS[2, 2] = c8
    Q_hat_L = ca.vertcat(w3)
    Q_hat_S = ca.vertcat(w0 * w4 - beam_q1 * c17, w1 * w4 - beam_q2 * c18, w2 * w4 - beam_q3 * c19)
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_d_dot (n_d = 5) [mixed]: rates of the dependent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 68) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 3 x 3) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 3) [N, N m]: right-hand side of a sub-step, slow q'' given
    31 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 68)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_theta_dot = q_d_dot[4]
    hub_theta_ddot = q_L_ddot[0]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    # intermediate terms (4)
    w0 = beam_theta_dot**2
    w1 = w0 * beam_q1
    w2 = w0 * beam_q2
    w3 = w0 * beam_q3
    # outputs
    M_hat_SS = ca.SX(3, 3)
    # beam.q1
    M_hat_SS[0, 0] = c0
    # beam.q2
    M_hat_SS[1, 1] = c4
    # beam.q3
    M_hat_SS[2, 2] = c8
    rhs_S = ca.vertcat(
        w1 * c53 - w2 * c2 - w3 * c3 - beam_q1 * c17 - hub_theta_ddot * c13,  # beam.q1
        w2 * c54 - w1 * c5 - w3 * c7 - beam_q2 * c18 - hub_theta_ddot * c14,  # beam.q2
        w3 * c55 - w1 * c9 - w2 * c10 - beam_q3 * c19 - hub_theta_ddot * c15,  # beam.q3
    )
    inputs, outputs = [q_i, q_d_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 295) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 21) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 21) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 57) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 57) [1/m]: rotation at a drawn point by each mode of its body
    gives H (1 x entries = 1 x 153) [1/m]: foreshortening of the drawn points that have it, nf x nf each
    gives sections (2 x beams = 2) [m]: height and width of a rectangle that stands for a beam's section
    gives rigidities (2 x beams = 2) [N m^2]: E I of a beam for bending along y and along z
    212 operations.
    """
    p = ca.SX.sym("p", 295)
    beam_length = p[3]
    beam_area = p[5]
    beam_youngs_modulus = p[6]
    beam_second_moment = p[7]
    beam_clamped_free3_1_0_shape_1_0 = p[40]
    beam_clamped_free3_1_0_shape_1_1 = p[41]
    beam_clamped_free3_1_0_shape_1_2 = p[42]
    beam_clamped_free3_1_0_slope_0_0 = p[43]
    beam_clamped_free3_1_0_slope_1_0 = p[44]
    beam_clamped_free3_1_0_slope_2_0 = p[45]
    beam_clamped_free3_1_0_H_0_0 = p[46]
    beam_clamped_free3_1_0_H_0_1 = p[47]
    beam_clamped_free3_1_0_H_0_2 = p[48]
    beam_clamped_free3_1_0_H_1_0 = p[49]
    beam_clamped_free3_1_0_H_1_1 = p[50]
    beam_clamped_free3_1_0_H_1_2 = p[51]
    beam_clamped_free3_1_0_H_2_0 = p[52]
    beam_clamped_free3_1_0_H_2_1 = p[53]
    beam_clamped_free3_1_0_H_2_2 = p[54]
    beam_clamped_free3_0_0625_at_0_0 = p[55]
    beam_clamped_free3_0_0625_shape_1_0 = p[56]
    beam_clamped_free3_0_0625_shape_1_1 = p[57]
    beam_clamped_free3_0_0625_shape_1_2 = p[58]
    beam_clamped_free3_0_0625_slope_0_0 = p[59]
    beam_clamped_free3_0_0625_slope_1_0 = p[60]
    beam_clamped_free3_0_0625_slope_2_0 = p[61]
    beam_clamped_free3_0_0625_H_0_0 = p[62]
    beam_clamped_free3_0_0625_H_0_1 = p[63]
    beam_clamped_free3_0_0625_H_0_2 = p[64]
    beam_clamped_free3_0_0625_H_1_0 = p[65]
    beam_clamped_free3_0_0625_H_1_1 = p[66]
    beam_clamped_free3_0_0625_H_1_2 = p[67]
    beam_clamped_free3_0_0625_H_2_0 = p[68]
    beam_clamped_free3_0_0625_H_2_1 = p[69]
    beam_clamped_free3_0_0625_H_2_2 = p[70]
    beam_clamped_free3_0_125_at_0_0 = p[71]
    beam_clamped_free3_0_125_shape_1_0 = p[72]
    beam_clamped_free3_0_125_shape_1_1 = p[73]
    beam_clamped_free3_0_125_shape_1_2 = p[74]
    beam_clamped_free3_0_125_slope_0_0 = p[75]
    beam_clamped_free3_0_125_slope_1_0 = p[76]
    beam_clamped_free3_0_125_slope_2_0 = p[77]
    beam_clamped_free3_0_125_H_0_0 = p[78]
    beam_clamped_free3_0_125_H_0_1 = p[79]
    beam_clamped_free3_0_125_H_0_2 = p[80]
    beam_clamped_free3_0_125_H_1_0 = p[81]
    beam_clamped_free3_0_125_H_1_1 = p[82]
    beam_clamped_free3_0_125_H_1_2 = p[83]
    beam_clamped_free3_0_125_H_2_0 = p[84]
    beam_clamped_free3_0_125_H_2_1 = p[85]
    beam_clamped_free3_0_125_H_2_2 = p[86]
    beam_clamped_free3_0_1875_at_0_0 = p[87]
    beam_clamped_free3_0_1875_shape_1_0 = p[88]
    beam_clamped_free3_0_1875_shape_1_1 = p[89]
    beam_clamped_free3_0_1875_shape_1_2 = p[90]
    beam_clamped_free3_0_1875_slope_0_0 = p[91]
    beam_clamped_free3_0_1875_slope_1_0 = p[92]
    beam_clamped_free3_0_1875_slope_2_0 = p[93]
    beam_clamped_free3_0_1875_H_0_0 = p[94]
    beam_clamped_free3_0_1875_H_0_1 = p[95]
    beam_clamped_free3_0_1875_H_0_2 = p[96]
    beam_clamped_free3_0_1875_H_1_0 = p[97]
    beam_clamped_free3_0_1875_H_1_1 = p[98]
    beam_clamped_free3_0_1875_H_1_2 = p[99]
    beam_clamped_free3_0_1875_H_2_0 = p[100]
    beam_clamped_free3_0_1875_H_2_1 = p[101]
    beam_clamped_free3_0_1875_H_2_2 = p[102]
    beam_clamped_free3_0_25_at_0_0 = p[103]
    beam_clamped_free3_0_25_shape_1_0 = p[104]
    beam_clamped_free3_0_25_shape_1_1 = p[105]
    beam_clamped_free3_0_25_shape_1_2 = p[106]
    beam_clamped_free3_0_25_slope_0_0 = p[107]
    beam_clamped_free3_0_25_slope_1_0 = p[108]
    beam_clamped_free3_0_25_slope_2_0 = p[109]
    beam_clamped_free3_0_25_H_0_0 = p[110]
    beam_clamped_free3_0_25_H_0_1 = p[111]
    beam_clamped_free3_0_25_H_0_2 = p[112]
    beam_clamped_free3_0_25_H_1_0 = p[113]
    beam_clamped_free3_0_25_H_1_1 = p[114]
    beam_clamped_free3_0_25_H_1_2 = p[115]
    beam_clamped_free3_0_25_H_2_0 = p[116]
    beam_clamped_free3_0_25_H_2_1 = p[117]
    beam_clamped_free3_0_25_H_2_2 = p[118]
    beam_clamped_free3_0_3125_at_0_0 = p[119]
    beam_clamped_free3_0_3125_shape_1_0 = p[120]
    beam_clamped_free3_0_3125_shape_1_1 = p[121]
    beam_clamped_free3_0_3125_shape_1_2 = p[122]
    beam_clamped_free3_0_3125_slope_0_0 = p[123]
    beam_clamped_free3_0_3125_slope_1_0 = p[124]
    beam_clamped_free3_0_3125_slope_2_0 = p[125]
    beam_clamped_free3_0_3125_H_0_0 = p[126]
    beam_clamped_free3_0_3125_H_0_1 = p[127]
    beam_clamped_free3_0_3125_H_0_2 = p[128]
    beam_clamped_free3_0_3125_H_1_0 = p[129]
    beam_clamped_free3_0_3125_H_1_1 = p[130]
    beam_clamped_free3_0_3125_H_1_2 = p[131]
    beam_clamped_free3_0_3125_H_2_0 = p[132]
    beam_clamped_free3_0_3125_H_2_1 = p[133]
    beam_clamped_free3_0_3125_H_2_2 = p[134]
    beam_clamped_free3_0_375_at_0_0 = p[135]
    beam_clamped_free3_0_375_shape_1_0 = p[136]
    beam_clamped_free3_0_375_shape_1_1 = p[137]
    beam_clamped_free3_0_375_shape_1_2 = p[138]
    beam_clamped_free3_0_375_slope_0_0 = p[139]
    beam_clamped_free3_0_375_slope_1_0 = p[140]
    beam_clamped_free3_0_375_slope_2_0 = p[141]
    beam_clamped_free3_0_375_H_0_0 = p[142]
    beam_clamped_free3_0_375_H_0_1 = p[143]
    beam_clamped_free3_0_375_H_0_2 = p[144]
    beam_clamped_free3_0_375_H_1_0 = p[145]
    beam_clamped_free3_0_375_H_1_1 = p[146]
    beam_clamped_free3_0_375_H_1_2 = p[147]
    beam_clamped_free3_0_375_H_2_0 = p[148]
    beam_clamped_free3_0_375_H_2_1 = p[149]
    beam_clamped_free3_0_375_H_2_2 = p[150]
    beam_clamped_free3_0_4375_at_0_0 = p[151]
    beam_clamped_free3_0_4375_shape_1_0 = p[152]
    beam_clamped_free3_0_4375_shape_1_1 = p[153]
    beam_clamped_free3_0_4375_shape_1_2 = p[154]
    beam_clamped_free3_0_4375_slope_0_0 = p[155]
    beam_clamped_free3_0_4375_slope_1_0 = p[156]
    beam_clamped_free3_0_4375_slope_2_0 = p[157]
    beam_clamped_free3_0_4375_H_0_0 = p[158]
    beam_clamped_free3_0_4375_H_0_1 = p[159]
    beam_clamped_free3_0_4375_H_0_2 = p[160]
    beam_clamped_free3_0_4375_H_1_0 = p[161]
    beam_clamped_free3_0_4375_H_1_1 = p[162]
    beam_clamped_free3_0_4375_H_1_2 = p[163]
    beam_clamped_free3_0_4375_H_2_0 = p[164]
    beam_clamped_free3_0_4375_H_2_1 = p[165]
    beam_clamped_free3_0_4375_H_2_2 = p[166]
    beam_clamped_free3_0_5_at_0_0 = p[167]
    beam_clamped_free3_0_5_shape_1_0 = p[168]
    beam_clamped_free3_0_5_shape_1_1 = p[169]
    beam_clamped_free3_0_5_shape_1_2 = p[170]
    beam_clamped_free3_0_5_slope_0_0 = p[171]
    beam_clamped_free3_0_5_slope_1_0 = p[172]
    beam_clamped_free3_0_5_slope_2_0 = p[173]
    beam_clamped_free3_0_5_H_0_0 = p[174]
    beam_clamped_free3_0_5_H_0_1 = p[175]
    beam_clamped_free3_0_5_H_0_2 = p[176]
    beam_clamped_free3_0_5_H_1_0 = p[177]
    beam_clamped_free3_0_5_H_1_1 = p[178]
    beam_clamped_free3_0_5_H_1_2 = p[179]
    beam_clamped_free3_0_5_H_2_0 = p[180]
    beam_clamped_free3_0_5_H_2_1 = p[181]
    beam_clamped_free3_0_5_H_2_2 = p[182]
    beam_clamped_free3_0_5625_at_0_0 = p[183]
    beam_clamped_free3_0_5625_shape_1_0 = p[184]
    beam_clamped_free3_0_5625_shape_1_1 = p[185]
    beam_clamped_free3_0_5625_shape_1_2 = p[186]
    beam_clamped_free3_0_5625_slope_0_0 = p[187]
    beam_clamped_free3_0_5625_slope_1_0 = p[188]
    beam_clamped_free3_0_5625_slope_2_0 = p[189]
    beam_clamped_free3_0_5625_H_0_0 = p[190]
    beam_clamped_free3_0_5625_H_0_1 = p[191]
    beam_clamped_free3_0_5625_H_0_2 = p[192]
    beam_clamped_free3_0_5625_H_1_0 = p[193]
    beam_clamped_free3_0_5625_H_1_1 = p[194]
    beam_clamped_free3_0_5625_H_1_2 = p[195]
    beam_clamped_free3_0_5625_H_2_0 = p[196]
    beam_clamped_free3_0_5625_H_2_1 = p[197]
    beam_clamped_free3_0_5625_H_2_2 = p[198]
    beam_clamped_free3_0_625_at_0_0 = p[199]
    beam_clamped_free3_0_625_shape_1_0 = p[200]
    beam_clamped_free3_0_625_shape_1_1 = p[201]
    beam_clamped_free3_0_625_shape_1_2 = p[202]
    beam_clamped_free3_0_625_slope_0_0 = p[203]
    beam_clamped_free3_0_625_slope_1_0 = p[204]
    beam_clamped_free3_0_625_slope_2_0 = p[205]
    beam_clamped_free3_0_625_H_0_0 = p[206]
    beam_clamped_free3_0_625_H_0_1 = p[207]
    beam_clamped_free3_0_625_H_0_2 = p[208]
    beam_clamped_free3_0_625_H_1_0 = p[209]
    beam_clamped_free3_0_625_H_1_1 = p[210]
    beam_clamped_free3_0_625_H_1_2 = p[211]
    beam_clamped_free3_0_625_H_2_0 = p[212]
    beam_clamped_free3_0_625_H_2_1 = p[213]
    beam_clamped_free3_0_625_H_2_2 = p[214]
    beam_clamped_free3_0_6875_at_0_0 = p[215]
    beam_clamped_free3_0_6875_shape_1_0 = p[216]
    beam_clamped_free3_0_6875_shape_1_1 = p[217]
    beam_clamped_free3_0_6875_shape_1_2 = p[218]
    beam_clamped_free3_0_6875_slope_0_0 = p[219]
    beam_clamped_free3_0_6875_slope_1_0 = p[220]
    beam_clamped_free3_0_6875_slope_2_0 = p[221]
    beam_clamped_free3_0_6875_H_0_0 = p[222]
    beam_clamped_free3_0_6875_H_0_1 = p[223]
    beam_clamped_free3_0_6875_H_0_2 = p[224]
    beam_clamped_free3_0_6875_H_1_0 = p[225]
    beam_clamped_free3_0_6875_H_1_1 = p[226]
    beam_clamped_free3_0_6875_H_1_2 = p[227]
    beam_clamped_free3_0_6875_H_2_0 = p[228]
    beam_clamped_free3_0_6875_H_2_1 = p[229]
    beam_clamped_free3_0_6875_H_2_2 = p[230]
    beam_clamped_free3_0_75_at_0_0 = p[231]
    beam_clamped_free3_0_75_shape_1_0 = p[232]
    beam_clamped_free3_0_75_shape_1_1 = p[233]
    beam_clamped_free3_0_75_shape_1_2 = p[234]
    beam_clamped_free3_0_75_slope_0_0 = p[235]
    beam_clamped_free3_0_75_slope_1_0 = p[236]
    beam_clamped_free3_0_75_slope_2_0 = p[237]
    beam_clamped_free3_0_75_H_0_0 = p[238]
    beam_clamped_free3_0_75_H_0_1 = p[239]
    beam_clamped_free3_0_75_H_0_2 = p[240]
    beam_clamped_free3_0_75_H_1_0 = p[241]
    beam_clamped_free3_0_75_H_1_1 = p[242]
    beam_clamped_free3_0_75_H_1_2 = p[243]
    beam_clamped_free3_0_75_H_2_0 = p[244]
    beam_clamped_free3_0_75_H_2_1 = p[245]
    beam_clamped_free3_0_75_H_2_2 = p[246]
    beam_clamped_free3_0_8125_at_0_0 = p[247]
    beam_clamped_free3_0_8125_shape_1_0 = p[248]
    beam_clamped_free3_0_8125_shape_1_1 = p[249]
    beam_clamped_free3_0_8125_shape_1_2 = p[250]
    beam_clamped_free3_0_8125_slope_0_0 = p[251]
    beam_clamped_free3_0_8125_slope_1_0 = p[252]
    beam_clamped_free3_0_8125_slope_2_0 = p[253]
    beam_clamped_free3_0_8125_H_0_0 = p[254]
    beam_clamped_free3_0_8125_H_0_1 = p[255]
    beam_clamped_free3_0_8125_H_0_2 = p[256]
    beam_clamped_free3_0_8125_H_1_0 = p[257]
    beam_clamped_free3_0_8125_H_1_1 = p[258]
    beam_clamped_free3_0_8125_H_1_2 = p[259]
    beam_clamped_free3_0_8125_H_2_0 = p[260]
    beam_clamped_free3_0_8125_H_2_1 = p[261]
    beam_clamped_free3_0_8125_H_2_2 = p[262]
    beam_clamped_free3_0_875_at_0_0 = p[263]
    beam_clamped_free3_0_875_shape_1_0 = p[264]
    beam_clamped_free3_0_875_shape_1_1 = p[265]
    beam_clamped_free3_0_875_shape_1_2 = p[266]
    beam_clamped_free3_0_875_slope_0_0 = p[267]
    beam_clamped_free3_0_875_slope_1_0 = p[268]
    beam_clamped_free3_0_875_slope_2_0 = p[269]
    beam_clamped_free3_0_875_H_0_0 = p[270]
    beam_clamped_free3_0_875_H_0_1 = p[271]
    beam_clamped_free3_0_875_H_0_2 = p[272]
    beam_clamped_free3_0_875_H_1_0 = p[273]
    beam_clamped_free3_0_875_H_1_1 = p[274]
    beam_clamped_free3_0_875_H_1_2 = p[275]
    beam_clamped_free3_0_875_H_2_0 = p[276]
    beam_clamped_free3_0_875_H_2_1 = p[277]
    beam_clamped_free3_0_875_H_2_2 = p[278]
    beam_clamped_free3_0_9375_at_0_0 = p[279]
    beam_clamped_free3_0_9375_shape_1_0 = p[280]
    beam_clamped_free3_0_9375_shape_1_1 = p[281]
    beam_clamped_free3_0_9375_shape_1_2 = p[282]
    beam_clamped_free3_0_9375_slope_0_0 = p[283]
    beam_clamped_free3_0_9375_slope_1_0 = p[284]
    beam_clamped_free3_0_9375_slope_2_0 = p[285]
    beam_clamped_free3_0_9375_H_0_0 = p[286]
    beam_clamped_free3_0_9375_H_0_1 = p[287]
    beam_clamped_free3_0_9375_H_0_2 = p[288]
    beam_clamped_free3_0_9375_H_1_0 = p[289]
    beam_clamped_free3_0_9375_H_1_1 = p[290]
    beam_clamped_free3_0_9375_H_1_2 = p[291]
    beam_clamped_free3_0_9375_H_2_0 = p[292]
    beam_clamped_free3_0_9375_H_2_1 = p[293]
    beam_clamped_free3_0_9375_H_2_2 = p[294]
    # intermediate terms (13)
    w0 = beam_clamped_free3_1_0_slope_0_0 / beam_length
    w1 = beam_clamped_free3_1_0_slope_1_0 / beam_length
    w2 = beam_clamped_free3_1_0_slope_2_0 / beam_length
    w3 = beam_clamped_free3_1_0_H_0_0 / beam_length
    w4 = beam_clamped_free3_1_0_H_0_1 / beam_length
    w5 = beam_clamped_free3_1_0_H_0_2 / beam_length
    w6 = beam_clamped_free3_1_0_H_1_0 / beam_length
    w7 = beam_clamped_free3_1_0_H_1_1 / beam_length
    w8 = beam_clamped_free3_1_0_H_1_2 / beam_length
    w9 = beam_clamped_free3_1_0_H_2_0 / beam_length
    w10 = beam_clamped_free3_1_0_H_2_1 / beam_length
    w11 = beam_clamped_free3_1_0_H_2_2 / beam_length
    w12 = ca.sqrt(12.0 * beam_second_moment / beam_area)
    # outputs
    positions = ca.SX(3, 21)
    positions[0, 1] = beam_length * beam_clamped_free3_0_0625_at_0_0
    positions[0, 2] = beam_length * beam_clamped_free3_0_125_at_0_0
    positions[0, 3] = beam_length * beam_clamped_free3_0_1875_at_0_0
    positions[0, 4] = beam_length * beam_clamped_free3_0_25_at_0_0
    positions[0, 5] = beam_length * beam_clamped_free3_0_3125_at_0_0
    positions[0, 6] = beam_length * beam_clamped_free3_0_375_at_0_0
    positions[0, 7] = beam_length * beam_clamped_free3_0_4375_at_0_0
    positions[0, 8] = beam_length * beam_clamped_free3_0_5_at_0_0
    positions[0, 9] = beam_length * beam_clamped_free3_0_5625_at_0_0
    positions[0, 10] = beam_length * beam_clamped_free3_0_625_at_0_0
    positions[0, 11] = beam_length * beam_clamped_free3_0_6875_at_0_0
    positions[0, 12] = beam_length * beam_clamped_free3_0_75_at_0_0
    positions[0, 13] = beam_length * beam_clamped_free3_0_8125_at_0_0
    positions[0, 14] = beam_length * beam_clamped_free3_0_875_at_0_0
    positions[0, 15] = beam_length * beam_clamped_free3_0_9375_at_0_0
    positions[0, 16] = beam_length
    positions[0, 20] = beam_length
    axes = ca.SX(9, 21)
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
    axes[0, 13] = 1.0
    axes[0, 14] = 1.0
    axes[0, 15] = 1.0
    axes[0, 16] = 1.0
    axes[0, 17] = 1.0
    axes[0, 18] = 1.0
    axes[0, 19] = 1.0
    axes[0, 20] = 1.0
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
    axes[4, 13] = 1.0
    axes[4, 14] = 1.0
    axes[4, 15] = 1.0
    axes[4, 16] = 1.0
    axes[4, 17] = 1.0
    axes[4, 18] = 1.0
    axes[4, 19] = 1.0
    axes[4, 20] = 1.0
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
    axes[8, 13] = 1.0
    axes[8, 14] = 1.0
    axes[8, 15] = 1.0
    axes[8, 16] = 1.0
    axes[8, 17] = 1.0
    axes[8, 18] = 1.0
    axes[8, 19] = 1.0
    axes[8, 20] = 1.0
    shapes = ca.SX(3, 57)
    shapes[1, 3] = beam_clamped_free3_0_0625_shape_1_0
    shapes[1, 4] = beam_clamped_free3_0_0625_shape_1_1
    shapes[1, 5] = beam_clamped_free3_0_0625_shape_1_2
    shapes[1, 6] = beam_clamped_free3_0_125_shape_1_0
    shapes[1, 7] = beam_clamped_free3_0_125_shape_1_1
    shapes[1, 8] = beam_clamped_free3_0_125_shape_1_2
    shapes[1, 9] = beam_clamped_free3_0_1875_shape_1_0
    shapes[1, 10] = beam_clamped_free3_0_1875_shape_1_1
    shapes[1, 11] = beam_clamped_free3_0_1875_shape_1_2
    shapes[1, 12] = beam_clamped_free3_0_25_shape_1_0
    shapes[1, 13] = beam_clamped_free3_0_25_shape_1_1
    shapes[1, 14] = beam_clamped_free3_0_25_shape_1_2
    shapes[1, 15] = beam_clamped_free3_0_3125_shape_1_0
    shapes[1, 16] = beam_clamped_free3_0_3125_shape_1_1
    shapes[1, 17] = beam_clamped_free3_0_3125_shape_1_2
    shapes[1, 18] = beam_clamped_free3_0_375_shape_1_0
    shapes[1, 19] = beam_clamped_free3_0_375_shape_1_1
    shapes[1, 20] = beam_clamped_free3_0_375_shape_1_2
    shapes[1, 21] = beam_clamped_free3_0_4375_shape_1_0
    shapes[1, 22] = beam_clamped_free3_0_4375_shape_1_1
    shapes[1, 23] = beam_clamped_free3_0_4375_shape_1_2
    shapes[1, 24] = beam_clamped_free3_0_5_shape_1_0
    shapes[1, 25] = beam_clamped_free3_0_5_shape_1_1
    shapes[1, 26] = beam_clamped_free3_0_5_shape_1_2
    shapes[1, 27] = beam_clamped_free3_0_5625_shape_1_0
    shapes[1, 28] = beam_clamped_free3_0_5625_shape_1_1
    shapes[1, 29] = beam_clamped_free3_0_5625_shape_1_2
    shapes[1, 30] = beam_clamped_free3_0_625_shape_1_0
    shapes[1, 31] = beam_clamped_free3_0_625_shape_1_1
    shapes[1, 32] = beam_clamped_free3_0_625_shape_1_2
    shapes[1, 33] = beam_clamped_free3_0_6875_shape_1_0
    shapes[1, 34] = beam_clamped_free3_0_6875_shape_1_1
    shapes[1, 35] = beam_clamped_free3_0_6875_shape_1_2
    shapes[1, 36] = beam_clamped_free3_0_75_shape_1_0
    shapes[1, 37] = beam_clamped_free3_0_75_shape_1_1
    shapes[1, 38] = beam_clamped_free3_0_75_shape_1_2
    shapes[1, 39] = beam_clamped_free3_0_8125_shape_1_0
    shapes[1, 40] = beam_clamped_free3_0_8125_shape_1_1
    shapes[1, 41] = beam_clamped_free3_0_8125_shape_1_2
    shapes[1, 42] = beam_clamped_free3_0_875_shape_1_0
    shapes[1, 43] = beam_clamped_free3_0_875_shape_1_1
    shapes[1, 44] = beam_clamped_free3_0_875_shape_1_2
    shapes[1, 45] = beam_clamped_free3_0_9375_shape_1_0
    shapes[1, 46] = beam_clamped_free3_0_9375_shape_1_1
    shapes[1, 47] = beam_clamped_free3_0_9375_shape_1_2
    shapes[1, 48] = beam_clamped_free3_1_0_shape_1_0
    shapes[1, 49] = beam_clamped_free3_1_0_shape_1_1
    shapes[1, 50] = beam_clamped_free3_1_0_shape_1_2
    shapes[1, 54] = beam_clamped_free3_1_0_shape_1_0
    shapes[1, 55] = beam_clamped_free3_1_0_shape_1_1
    shapes[1, 56] = beam_clamped_free3_1_0_shape_1_2
    turns = ca.SX(3, 57)
    turns[2, 3] = beam_clamped_free3_0_0625_slope_0_0 / beam_length
    turns[2, 4] = beam_clamped_free3_0_0625_slope_1_0 / beam_length
    turns[2, 5] = beam_clamped_free3_0_0625_slope_2_0 / beam_length
    turns[2, 6] = beam_clamped_free3_0_125_slope_0_0 / beam_length
    turns[2, 7] = beam_clamped_free3_0_125_slope_1_0 / beam_length
    turns[2, 8] = beam_clamped_free3_0_125_slope_2_0 / beam_length
    turns[2, 9] = beam_clamped_free3_0_1875_slope_0_0 / beam_length
    turns[2, 10] = beam_clamped_free3_0_1875_slope_1_0 / beam_length
    turns[2, 11] = beam_clamped_free3_0_1875_slope_2_0 / beam_length
    turns[2, 12] = beam_clamped_free3_0_25_slope_0_0 / beam_length
    turns[2, 13] = beam_clamped_free3_0_25_slope_1_0 / beam_length
    turns[2, 14] = beam_clamped_free3_0_25_slope_2_0 / beam_length
    turns[2, 15] = beam_clamped_free3_0_3125_slope_0_0 / beam_length
    turns[2, 16] = beam_clamped_free3_0_3125_slope_1_0 / beam_length
    turns[2, 17] = beam_clamped_free3_0_3125_slope_2_0 / beam_length
    turns[2, 18] = beam_clamped_free3_0_375_slope_0_0 / beam_length
    turns[2, 19] = beam_clamped_free3_0_375_slope_1_0 / beam_length
    turns[2, 20] = beam_clamped_free3_0_375_slope_2_0 / beam_length
    turns[2, 21] = beam_clamped_free3_0_4375_slope_0_0 / beam_length
    turns[2, 22] = beam_clamped_free3_0_4375_slope_1_0 / beam_length
    turns[2, 23] = beam_clamped_free3_0_4375_slope_2_0 / beam_length
    turns[2, 24] = beam_clamped_free3_0_5_slope_0_0 / beam_length
    turns[2, 25] = beam_clamped_free3_0_5_slope_1_0 / beam_length
    turns[2, 26] = beam_clamped_free3_0_5_slope_2_0 / beam_length
    turns[2, 27] = beam_clamped_free3_0_5625_slope_0_0 / beam_length
    turns[2, 28] = beam_clamped_free3_0_5625_slope_1_0 / beam_length
    turns[2, 29] = beam_clamped_free3_0_5625_slope_2_0 / beam_length
    turns[2, 30] = beam_clamped_free3_0_625_slope_0_0 / beam_length
    turns[2, 31] = beam_clamped_free3_0_625_slope_1_0 / beam_length
    turns[2, 32] = beam_clamped_free3_0_625_slope_2_0 / beam_length
    turns[2, 33] = beam_clamped_free3_0_6875_slope_0_0 / beam_length
    turns[2, 34] = beam_clamped_free3_0_6875_slope_1_0 / beam_length
    turns[2, 35] = beam_clamped_free3_0_6875_slope_2_0 / beam_length
    turns[2, 36] = beam_clamped_free3_0_75_slope_0_0 / beam_length
    turns[2, 37] = beam_clamped_free3_0_75_slope_1_0 / beam_length
    turns[2, 38] = beam_clamped_free3_0_75_slope_2_0 / beam_length
    turns[2, 39] = beam_clamped_free3_0_8125_slope_0_0 / beam_length
    turns[2, 40] = beam_clamped_free3_0_8125_slope_1_0 / beam_length
    turns[2, 41] = beam_clamped_free3_0_8125_slope_2_0 / beam_length
    turns[2, 42] = beam_clamped_free3_0_875_slope_0_0 / beam_length
    turns[2, 43] = beam_clamped_free3_0_875_slope_1_0 / beam_length
    turns[2, 44] = beam_clamped_free3_0_875_slope_2_0 / beam_length
    turns[2, 45] = beam_clamped_free3_0_9375_slope_0_0 / beam_length
    turns[2, 46] = beam_clamped_free3_0_9375_slope_1_0 / beam_length
    turns[2, 47] = beam_clamped_free3_0_9375_slope_2_0 / beam_length
    turns[2, 48] = w0
    turns[2, 49] = w1
    turns[2, 50] = w2
    turns[2, 54] = w0
    turns[2, 55] = w1
    turns[2, 56] = w2
    H = ca.horzcat(
        beam_clamped_free3_0_0625_H_0_0 / beam_length, beam_clamped_free3_0_0625_H_0_1 / beam_length,
        beam_clamped_free3_0_0625_H_0_2 / beam_length, beam_clamped_free3_0_0625_H_1_0 / beam_length,
        beam_clamped_free3_0_0625_H_1_1 / beam_length, beam_clamped_free3_0_0625_H_1_2 / beam_length,
        beam_clamped_free3_0_0625_H_2_0 / beam_length, beam_clamped_free3_0_0625_H_2_1 / beam_length,
        beam_clamped_free3_0_0625_H_2_2 / beam_length, beam_clamped_free3_0_125_H_0_0 / beam_length,
        beam_clamped_free3_0_125_H_0_1 / beam_length, beam_clamped_free3_0_125_H_0_2 / beam_length,
        beam_clamped_free3_0_125_H_1_0 / beam_length, beam_clamped_free3_0_125_H_1_1 / beam_length,
        beam_clamped_free3_0_125_H_1_2 / beam_length, beam_clamped_free3_0_125_H_2_0 / beam_length,
        beam_clamped_free3_0_125_H_2_1 / beam_length, beam_clamped_free3_0_125_H_2_2 / beam_length,
        beam_clamped_free3_0_1875_H_0_0 / beam_length, beam_clamped_free3_0_1875_H_0_1 / beam_length,
        beam_clamped_free3_0_1875_H_0_2 / beam_length, beam_clamped_free3_0_1875_H_1_0 / beam_length,
        beam_clamped_free3_0_1875_H_1_1 / beam_length, beam_clamped_free3_0_1875_H_1_2 / beam_length,
        beam_clamped_free3_0_1875_H_2_0 / beam_length, beam_clamped_free3_0_1875_H_2_1 / beam_length,
        beam_clamped_free3_0_1875_H_2_2 / beam_length, beam_clamped_free3_0_25_H_0_0 / beam_length,
        beam_clamped_free3_0_25_H_0_1 / beam_length, beam_clamped_free3_0_25_H_0_2 / beam_length,
        beam_clamped_free3_0_25_H_1_0 / beam_length, beam_clamped_free3_0_25_H_1_1 / beam_length,
        beam_clamped_free3_0_25_H_1_2 / beam_length, beam_clamped_free3_0_25_H_2_0 / beam_length,
        beam_clamped_free3_0_25_H_2_1 / beam_length, beam_clamped_free3_0_25_H_2_2 / beam_length,
        beam_clamped_free3_0_3125_H_0_0 / beam_length, beam_clamped_free3_0_3125_H_0_1 / beam_length,
        beam_clamped_free3_0_3125_H_0_2 / beam_length, beam_clamped_free3_0_3125_H_1_0 / beam_length,
        beam_clamped_free3_0_3125_H_1_1 / beam_length, beam_clamped_free3_0_3125_H_1_2 / beam_length,
        beam_clamped_free3_0_3125_H_2_0 / beam_length, beam_clamped_free3_0_3125_H_2_1 / beam_length,
        beam_clamped_free3_0_3125_H_2_2 / beam_length, beam_clamped_free3_0_375_H_0_0 / beam_length,
        beam_clamped_free3_0_375_H_0_1 / beam_length, beam_clamped_free3_0_375_H_0_2 / beam_length,
        beam_clamped_free3_0_375_H_1_0 / beam_length, beam_clamped_free3_0_375_H_1_1 / beam_length,
        beam_clamped_free3_0_375_H_1_2 / beam_length, beam_clamped_free3_0_375_H_2_0 / beam_length,
        beam_clamped_free3_0_375_H_2_1 / beam_length, beam_clamped_free3_0_375_H_2_2 / beam_length,
        beam_clamped_free3_0_4375_H_0_0 / beam_length, beam_clamped_free3_0_4375_H_0_1 / beam_length,
        beam_clamped_free3_0_4375_H_0_2 / beam_length, beam_clamped_free3_0_4375_H_1_0 / beam_length,
        beam_clamped_free3_0_4375_H_1_1 / beam_length, beam_clamped_free3_0_4375_H_1_2 / beam_length,
        beam_clamped_free3_0_4375_H_2_0 / beam_length, beam_clamped_free3_0_4375_H_2_1 / beam_length,
        beam_clamped_free3_0_4375_H_2_2 / beam_length, beam_clamped_free3_0_5_H_0_0 / beam_length,
        beam_clamped_free3_0_5_H_0_1 / beam_length, beam_clamped_free3_0_5_H_0_2 / beam_length,
        beam_clamped_free3_0_5_H_1_0 / beam_length, beam_clamped_free3_0_5_H_1_1 / beam_length,
        beam_clamped_free3_0_5_H_1_2 / beam_length, beam_clamped_free3_0_5_H_2_0 / beam_length,
        beam_clamped_free3_0_5_H_2_1 / beam_length, beam_clamped_free3_0_5_H_2_2 / beam_length,
        beam_clamped_free3_0_5625_H_0_0 / beam_length, beam_clamped_free3_0_5625_H_0_1 / beam_length,
        beam_clamped_free3_0_5625_H_0_2 / beam_length, beam_clamped_free3_0_5625_H_1_0 / beam_length,
        beam_clamped_free3_0_5625_H_1_1 / beam_length, beam_clamped_free3_0_5625_H_1_2 / beam_length,
        beam_clamped_free3_0_5625_H_2_0 / beam_length, beam_clamped_free3_0_5625_H_2_1 / beam_length,
        beam_clamped_free3_0_5625_H_2_2 / beam_length, beam_clamped_free3_0_625_H_0_0 / beam_length,
        beam_clamped_free3_0_625_H_0_1 / beam_length, beam_clamped_free3_0_625_H_0_2 / beam_length,
        beam_clamped_free3_0_625_H_1_0 / beam_length, beam_clamped_free3_0_625_H_1_1 / beam_length,
        beam_clamped_free3_0_625_H_1_2 / beam_length, beam_clamped_free3_0_625_H_2_0 / beam_length,
        beam_clamped_free3_0_625_H_2_1 / beam_length, beam_clamped_free3_0_625_H_2_2 / beam_length,
        beam_clamped_free3_0_6875_H_0_0 / beam_length, beam_clamped_free3_0_6875_H_0_1 / beam_length,
        beam_clamped_free3_0_6875_H_0_2 / beam_length, beam_clamped_free3_0_6875_H_1_0 / beam_length,
        beam_clamped_free3_0_6875_H_1_1 / beam_length, beam_clamped_free3_0_6875_H_1_2 / beam_length,
        beam_clamped_free3_0_6875_H_2_0 / beam_length, beam_clamped_free3_0_6875_H_2_1 / beam_length,
        beam_clamped_free3_0_6875_H_2_2 / beam_length, beam_clamped_free3_0_75_H_0_0 / beam_length,
        beam_clamped_free3_0_75_H_0_1 / beam_length, beam_clamped_free3_0_75_H_0_2 / beam_length,
        beam_clamped_free3_0_75_H_1_0 / beam_length, beam_clamped_free3_0_75_H_1_1 / beam_length,
        beam_clamped_free3_0_75_H_1_2 / beam_length, beam_clamped_free3_0_75_H_2_0 / beam_length,
        beam_clamped_free3_0_75_H_2_1 / beam_length, beam_clamped_free3_0_75_H_2_2 / beam_length,
        beam_clamped_free3_0_8125_H_0_0 / beam_length, beam_clamped_free3_0_8125_H_0_1 / beam_length,
        beam_clamped_free3_0_8125_H_0_2 / beam_length, beam_clamped_free3_0_8125_H_1_0 / beam_length,
        beam_clamped_free3_0_8125_H_1_1 / beam_length, beam_clamped_free3_0_8125_H_1_2 / beam_length,
        beam_clamped_free3_0_8125_H_2_0 / beam_length, beam_clamped_free3_0_8125_H_2_1 / beam_length,
        beam_clamped_free3_0_8125_H_2_2 / beam_length, beam_clamped_free3_0_875_H_0_0 / beam_length,
        beam_clamped_free3_0_875_H_0_1 / beam_length, beam_clamped_free3_0_875_H_0_2 / beam_length,
        beam_clamped_free3_0_875_H_1_0 / beam_length, beam_clamped_free3_0_875_H_1_1 / beam_length,
        beam_clamped_free3_0_875_H_1_2 / beam_length, beam_clamped_free3_0_875_H_2_0 / beam_length,
        beam_clamped_free3_0_875_H_2_1 / beam_length, beam_clamped_free3_0_875_H_2_2 / beam_length,
        beam_clamped_free3_0_9375_H_0_0 / beam_length, beam_clamped_free3_0_9375_H_0_1 / beam_length,
        beam_clamped_free3_0_9375_H_0_2 / beam_length, beam_clamped_free3_0_9375_H_1_0 / beam_length,
        beam_clamped_free3_0_9375_H_1_1 / beam_length, beam_clamped_free3_0_9375_H_1_2 / beam_length,
        beam_clamped_free3_0_9375_H_2_0 / beam_length, beam_clamped_free3_0_9375_H_2_1 / beam_length,
        beam_clamped_free3_0_9375_H_2_2 / beam_length, w3, w4, w5, w6, w7, w8, w9, w10, w11, w3, w4, w5, w6, w7,
        w8, w9, w10, w11,
    )
    sections = ca.vertcat(w12, beam_area / w12)
    rigidities = ca.vertcat(beam_youngs_modulus * beam_second_moment, 0.0)
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes), ca.densify(shapes), ca.densify(turns), ca.densify(H), ca.densify(sections), ca.densify(rigidities)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes", "shapes", "turns", "H", "sections", "rigidities"])


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
    "measures": measures,
    "load_actions": load_actions,
    "poses": poses,
    "switching": switching,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "forward_dynamics": forward_dynamics,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
