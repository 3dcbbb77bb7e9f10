"""Double pendulum: equations of motion, emitted by symgen from the scene `double_pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 upper.theta [rad], 1 lower.theta [rad]

q_d, the dependent coordinates by index:
    0 upper.x [m], 1 upper.y [m], 2 lower.x [m], 3 lower.y [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 9) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    30 operations.
    """
    p = ca.SX.sym("p", 9)
    gravity_y = p[0]
    upper_mass = p[1]
    upper_inertia = p[2]
    upper_center_of_mass_x = p[3]
    lower_mass = p[4]
    lower_inertia = p[5]
    lower_center_of_mass_x = p[6]
    upper_tip_x = p[7]
    # intermediate terms (6)
    w0 = upper_tip_x * lower_mass
    w1 = lower_mass * lower_center_of_mass_x
    w2 = upper_mass * upper_center_of_mass_x
    w3 = w2 * gravity_y
    w4 = w3 + w0 * gravity_y
    w5 = w1 * gravity_y
    # outputs
    c = ca.vertcat(
        upper_inertia + upper_center_of_mass_x * w2 + lower_mass * upper_tip_x**2,  # c0
        w0 * lower_center_of_mass_x,  # c1
        lower_inertia + lower_center_of_mass_x * w1,  # c2
        w4,  # c3
        w5,  # c4
        upper_tip_x,  # upper_tip_x
        -upper_tip_x,  # c6
        upper_mass,  # upper_mass
        upper_inertia + upper_mass * upper_center_of_mass_x**2,  # c8
        lower_mass,  # lower_mass
        w1,  # c10
        lower_inertia + lower_mass * lower_center_of_mass_x**2,  # c11
        w2,  # c12
        gravity_y,  # gravity_y
        lower_mass * gravity_y,  # c14
        upper_mass * gravity_y,  # c15
        -gravity_y,  # c16
        -w4,  # c17
        -w5,  # c18
        lower_center_of_mass_x * (lower_mass * (2 * upper_tip_x)),  # c19
        w3,  # c20
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 2 x 2) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 2) [N, N m]: condensed force S^T (Q* - M s)
    15 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    # intermediate terms (3)
    w0 = lower_theta - upper_theta
    w1 = ca.cos(w0) * c1
    w2 = ca.sin(w0) * c1
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(c0, w1),  # upper.theta
        ca.horzcat(w1, c2),  # lower.theta
    )
    Q_hat = ca.vertcat(
        ca.cos(upper_theta) * c3 + lower_theta_dot**2 * w2,  # upper.theta
        ca.cos(lower_theta) * c4 - upper_theta_dot**2 * w2,  # lower.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 4) [mixed]: dependent coordinates after one Newton step
    4 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    upper_tip_x = c[5]
    # outputs
    q_d_next = ca.SX(4, 1)
    q_d_next[2] = ca.cos(upper_theta) * upper_tip_x  # lower.x
    q_d_next[3] = ca.sin(upper_theta) * upper_tip_x  # lower.y
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    6 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    upper_theta_dot = q_i_dot[0]
    upper_tip_x = c[5]
    c6 = c[6]
    # outputs
    q_d_dot = ca.SX(4, 1)
    q_d_dot[2] = ca.sin(upper_theta) * c6 * upper_theta_dot  # lower.x
    q_d_dot[3] = upper_theta_dot * (ca.cos(upper_theta) * upper_tip_x)  # lower.y
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 4) [mixed]: accelerations of the dependent coordinates
    12 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    upper_theta_dot = q_i_dot[0]
    upper_theta_ddot = q_i_ddot[0]
    upper_tip_x = c[5]
    # intermediate terms (3)
    w0 = upper_theta_dot**2
    w1 = ca.cos(upper_theta) * upper_tip_x
    w2 = ca.sin(upper_theta) * upper_tip_x
    # outputs
    q_d_ddot = ca.SX(4, 1)
    q_d_ddot[2] = -(w0 * w1 + w2 * upper_theta_ddot)  # lower.x
    q_d_ddot[3] = w1 * upper_theta_ddot - w0 * w2  # lower.y
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 4) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 4 x 6) [SI]: constraint Jacobian
    gives C_t (n_c = 4) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 4) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    14 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    upper_x = q[0]
    upper_y = q[1]
    upper_theta = q[2]
    lower_x = q[3]
    lower_y = q[4]
    upper_theta_dot = q_dot[2]
    upper_tip_x = c[5]
    # intermediate terms (3)
    w0 = ca.cos(upper_theta) * upper_tip_x
    w1 = ca.sin(upper_theta) * upper_tip_x
    w2 = upper_theta_dot**2
    # outputs
    C = ca.vertcat(
        upper_x,  # shoulder.x
        upper_y,  # shoulder.y
        lower_x - (upper_x + w0),  # elbow.x
        lower_y - (upper_y + w1),  # elbow.y
    )
    C_q = ca.SX(4, 6)
    # shoulder.x
    C_q[0, 0] = 1.0
    # shoulder.y
    C_q[1, 1] = 1.0
    # elbow.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # elbow.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    C_t = ca.SX(4, 1)
    nu = ca.SX(4, 1)
    gamma = ca.SX(4, 1)
    gamma[2] = -(w0 * w2)  # elbow.x
    gamma[3] = -(w1 * w2)  # elbow.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 6 x 6) [SI]: mass matrix in all coordinates
    gives K (n x n = 6 x 6) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 6) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 6) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 6) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 4 x 6) [SI]: constraint Jacobian
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    27 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    upper_theta = q[2]
    lower_theta = q[5]
    upper_theta_dot = q_dot[2]
    lower_theta_dot = q_dot[5]
    upper_tip_x = c[5]
    upper_mass = c[7]
    c8 = c[8]
    lower_mass = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    gravity_y = c[13]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (18)
    w0 = ca.sin(upper_theta)
    w1 = w0 * c12
    w2 = -w1
    w3 = ca.cos(upper_theta)
    w4 = w3 * c12
    w5 = ca.sin(lower_theta) * c10
    w6 = -w5
    w7 = ca.cos(lower_theta) * c10
    w8 = upper_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = lower_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = w4 * gravity_y
    w15 = w7 * gravity_y
    w16 = w0 * upper_tip_x
    w17 = w3 * upper_tip_x
    # outputs
    M = ca.SX(6, 6)
    # upper.x
    M[0, 0] = upper_mass
    M[0, 2] = w2
    # upper.y
    M[1, 1] = upper_mass
    M[1, 2] = w4
    # upper.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c8
    # lower.x
    M[3, 3] = lower_mass
    M[3, 5] = w6
    # lower.y
    M[4, 4] = lower_mass
    M[4, 5] = w7
    # lower.theta
    M[5, 3] = w6
    M[5, 4] = w7
    M[5, 5] = c11
    K = ca.SX(6, 6)
    Q_v = ca.vertcat(
        w9,  # upper.x
        w10,  # upper.y
        0.0,  # upper.theta
        w12,  # lower.x
        w13,  # lower.y
        0.0,  # lower.theta
    )
    Q_F = ca.vertcat(
        0.0,  # upper.x
        c15,  # upper.y
        w14,  # upper.theta
        0.0,  # lower.x
        c14,  # lower.y
        w15,  # lower.theta
    )
    Q_star = ca.vertcat(
        w9,  # upper.x
        w10 + c15,  # upper.y
        w14,  # upper.theta
        w12,  # lower.x
        c14 + w13,  # lower.y
        w15,  # lower.theta
    )
    C_q = ca.SX(4, 6)
    # shoulder.x
    C_q[0, 0] = 1.0
    # shoulder.y
    C_q[1, 1] = 1.0
    # elbow.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w16
    C_q[2, 3] = 1.0
    # elbow.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w17
    C_q[3, 4] = 1.0
    gamma = ca.SX(4, 1)
    gamma[2] = -(w8 * w17)  # elbow.x
    gamma[3] = -(w8 * w16)  # elbow.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes q_ddot (n = 6) [mixed]: accelerations of all coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 4) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 2) [N, N m]: world force and moment of a joint on its body b, at b
    38 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    q_ddot = ca.SX.sym("q_ddot", 6)
    c = ca.SX.sym("c", 21)
    upper_theta = q[2]
    lower_theta = q[5]
    upper_theta_dot = q_dot[2]
    lower_theta_dot = q_dot[5]
    upper_x_ddot = q_ddot[0]
    upper_y_ddot = q_ddot[1]
    upper_theta_ddot = q_ddot[2]
    lower_x_ddot = q_ddot[3]
    lower_y_ddot = q_ddot[4]
    lower_theta_ddot = q_ddot[5]
    upper_mass = c[7]
    lower_mass = c[9]
    c10 = c[10]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    # intermediate terms (10)
    w0 = upper_theta_dot**2
    w1 = ca.cos(upper_theta) * c12
    w2 = ca.sin(upper_theta) * c12
    w3 = lower_theta_dot**2
    w4 = ca.cos(lower_theta) * c10
    w5 = ca.sin(lower_theta) * c10
    w6 = w3 * w4 - (lower_x_ddot * lower_mass - w5 * lower_theta_ddot)
    w7 = w0 * w1 - (upper_x_ddot * upper_mass - w2 * upper_theta_ddot) + w6
    w8 = c14 + w3 * w5 - (lower_y_ddot * lower_mass + w4 * lower_theta_ddot)
    w9 = c15 + w0 * w2 - (upper_y_ddot * upper_mass + w1 * upper_theta_ddot) + w8
    # outputs
    lam = ca.vertcat(
        w7,  # shoulder.x
        w9,  # shoulder.y
        w6,  # elbow.x
        w8,  # elbow.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w7, -w9, 0.0),  # shoulder
        ca.vertcat(-w6, -w8, 0.0),  # elbow
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    48 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    upper_y = q[1]
    upper_theta = q[2]
    lower_y = q[4]
    lower_theta = q[5]
    upper_x_dot = q_dot[0]
    upper_y_dot = q_dot[1]
    upper_theta_dot = q_dot[2]
    lower_x_dot = q_dot[3]
    lower_y_dot = q_dot[4]
    lower_theta_dot = q_dot[5]
    upper_mass = c[7]
    c8 = c[8]
    lower_mass = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c16 = c[16]
    # intermediate terms (7)
    w0 = ca.sin(upper_theta) * c12
    w1 = ca.cos(upper_theta) * c12
    w2 = upper_x_dot * (upper_x_dot * upper_mass - w0 * upper_theta_dot) + upper_y_dot * (upper_y_dot * upper_mass + upper_theta_dot * w1)
    w3 = ca.sin(lower_theta) * c10
    w4 = w2 + upper_theta_dot * (upper_y_dot * w1 - upper_x_dot * w0 + upper_theta_dot * c8) + lower_x_dot * (lower_x_dot * lower_mass - w3 * lower_theta_dot)
    w5 = ca.cos(lower_theta) * c10
    w6 = w4 + lower_y_dot * (lower_y_dot * lower_mass + lower_theta_dot * w5) + lower_theta_dot * (lower_y_dot * w5 - lower_x_dot * w3 + lower_theta_dot * c11)
    # outputs
    kinetic = ca.vertcat(w6 / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w0 + upper_y * upper_mass + (w3 + lower_y * lower_mass)) * c16)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 2) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    6 operations.
    """
    q = ca.SX.sym("q", 6)
    upper_x = q[0]
    upper_y = q[1]
    upper_theta = q[2]
    lower_x = q[3]
    lower_y = q[4]
    lower_theta = q[5]
    # intermediate terms (4)
    w0 = ca.cos(upper_theta)
    w1 = ca.sin(upper_theta)
    w2 = ca.cos(lower_theta)
    w3 = ca.sin(lower_theta)
    # outputs
    poses = ca.SX(12, 2)
    poses[0, 0] = upper_x
    poses[0, 1] = lower_x
    poses[1, 0] = upper_y
    poses[1, 1] = lower_y
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


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i, through q_d
    13 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c1 = c[1]
    c17 = c[17]
    c18 = c[18]
    # intermediate terms (3)
    w0 = ca.cos(lower_theta - upper_theta) * c1
    w1 = lower_theta_dot**2 * w0
    w2 = upper_theta_dot**2 * w0
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(ca.sin(upper_theta) * c17 - w1, w1),  # upper.theta
        ca.horzcat(w2, ca.sin(lower_theta) * c18 - w2),  # lower.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    6 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c19 = c[19]
    # intermediate terms (1)
    w0 = ca.sin(lower_theta - upper_theta) * c19
    # outputs
    dQ_hat_dq_i_dot = ca.SX(2, 2)
    # upper.theta
    dQ_hat_dq_i_dot[0, 1] = lower_theta_dot * w0
    # lower.theta
    dQ_hat_dq_i_dot[1, 0] = -(upper_theta_dot * w0)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 2 x 2) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    25 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    upper_theta_ddot = q_i_ddot[0]
    lower_theta_ddot = q_i_ddot[1]
    c1 = c[1]
    c4 = c[4]
    c17 = c[17]
    c19 = c[19]
    # intermediate terms (9)
    w0 = lower_theta - upper_theta
    w1 = ca.sin(w0)
    w2 = ca.cos(w0) * c1
    w3 = lower_theta_dot**2 * w2
    w4 = w1 * c1
    w5 = lower_theta_ddot * w4
    w6 = upper_theta_dot**2 * w2
    w7 = upper_theta_ddot * w4
    w8 = w1 * c19
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(ca.sin(upper_theta) * c17 - w3 - w5, w3 + w5),  # upper.theta
        ca.horzcat(w6 - w7, w7 - ca.sin(lower_theta) * c4 - w6),  # lower.theta
    )
    J_v = ca.SX(2, 2)
    # upper.theta
    J_v[0, 1] = lower_theta_dot * w8
    # lower.theta
    J_v[1, 0] = -(upper_theta_dot * w8)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 21) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    60 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    upper_tip_x = c[5]
    c8 = c[8]
    lower_mass = c[9]
    c10 = c[10]
    c11 = c[11]
    gravity_y = c[13]
    c14 = c[14]
    c20 = c[20]
    # intermediate terms (18)
    w0 = ca.cos(upper_theta)
    w1 = w0 * upper_tip_x
    w2 = lower_theta_dot**2
    w3 = ca.sin(lower_theta) * c10
    w4 = ca.cos(lower_theta) * c10
    w5 = w4 / c11
    w6 = w4 * gravity_y
    w7 = lower_mass - w4 * w5
    w8 = upper_theta_dot**2
    w9 = ca.sin(upper_theta) * upper_tip_x
    w10 = w8 * w9
    w11 = w3 / c11
    w12 = w4 * w11
    w13 = w1 * w12
    w14 = w1 * w8
    w15 = lower_mass - w3 * w11
    w16 = w0 * c20 + w1 * (c14 + w2 * w3 - w5 * w6 + w7 * w10) + w13 * w14 - w9 * (w2 * w4 + w6 * w11 + w10 * w12 + w14 * w15)
    w17 = w16 / (c8 + w1 * (w1 * w7) - (w9 * (w13 - w9 * w15) + w9 * w13))
    # outputs
    q_i_ddot = ca.vertcat(w17, w6 / c11 - w11 * (w14 + w9 * w17) - w5 * (w1 * w17 - w10))
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 9) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 5) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 5) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 9)
    upper_tip_x = p[7]
    lower_tip_x = p[8]
    # outputs
    positions = ca.SX(3, 5)
    positions[0, 2] = upper_tip_x
    positions[0, 4] = lower_tip_x
    axes = ca.SX(9, 5)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
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
