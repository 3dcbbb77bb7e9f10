"""Double pendulum: equations of motion, emitted by symgen from the scene `double_pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 51 operations."""
    p = ca.SX.sym("p", 9)
    gravity_y = p[0]
    upper_mass = p[1]
    upper_inertia = p[2]
    upper_center_of_mass_x = p[3]
    lower_mass = p[4]
    lower_inertia = p[5]
    lower_center_of_mass_x = p[6]
    upper_tip_x = p[7]
    w0 = upper_tip_x * lower_mass
    w1 = lower_mass * lower_center_of_mass_x
    w2 = upper_mass * upper_center_of_mass_x
    w3 = w2 * gravity_y
    c = ca.vertcat(
        upper_inertia + upper_center_of_mass_x * w2 + lower_mass * upper_tip_x**2,
        w0 * lower_center_of_mass_x,
        lower_inertia + lower_center_of_mass_x * w1,
        w3 + w0 * gravity_y,
        w1 * gravity_y,
        upper_tip_x,
        upper_mass,
        upper_inertia + upper_mass * upper_center_of_mass_x**2,
        lower_mass,
        w1,
        lower_inertia + lower_mass * lower_center_of_mass_x**2,
        w2,
        gravity_y,
        lower_mass * gravity_y,
        upper_mass * gravity_y,
        lower_center_of_mass_x * (lower_mass * (2 * upper_tip_x)),
        w3,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 30 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    w0 = lower_theta - upper_theta
    w1 = ca.cos(w0) * c1
    w2 = ca.sin(w0) * c1
    M_hat = ca.vertcat(
        c0,
        w1,
        w1,
        c2,
    )
    M_hat = ca.reshape(M_hat, 2, 2)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        ca.cos(upper_theta) * c3 + lower_theta_dot**2 * w2,
        ca.cos(lower_theta) * c4 - upper_theta_dot**2 * w2,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 11 operations."""
    q_i = ca.SX.sym("q_i", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    c5 = c[5]
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        ca.cos(upper_theta) * c5,
        ca.sin(upper_theta) * c5,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 15 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    upper_theta_dot = q_i_dot[0]
    c5 = c[5]
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -(ca.sin(upper_theta) * c5 * upper_theta_dot),
        upper_theta_dot * (ca.cos(upper_theta) * c5),
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 21 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    upper_theta_dot = q_i_dot[0]
    upper_theta_ddot = q_i_ddot[0]
    c5 = c[5]
    w0 = upper_theta_dot**2
    w1 = ca.cos(upper_theta) * c5
    w2 = ca.sin(upper_theta) * c5
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w1 + w2 * upper_theta_ddot),
        w1 * upper_theta_ddot - w0 * w2,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 64 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 17)
    upper_x = q[0]
    upper_y = q[1]
    upper_theta = q[2]
    lower_x = q[3]
    lower_y = q[4]
    upper_theta_dot = q_dot[2]
    c5 = c[5]
    w0 = ca.cos(upper_theta) * c5
    w1 = ca.sin(upper_theta) * c5
    w2 = upper_theta_dot**2
    C = ca.vertcat(
        upper_x,
        upper_y,
        lower_x - (upper_x + w0),
        lower_y - (upper_y + w1),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        w1,
        -w0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 4, 6)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
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
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w2),
        -(w1 * w2),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 162 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 17)
    upper_theta = q[2]
    lower_theta = q[5]
    upper_theta_dot = q_dot[2]
    lower_theta_dot = q_dot[5]
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
    w0 = ca.sin(upper_theta)
    w1 = w0 * c11
    w2 = -w1
    w3 = ca.cos(upper_theta)
    w4 = w3 * c11
    w5 = ca.sin(lower_theta) * c9
    w6 = -w5
    w7 = ca.cos(lower_theta) * c9
    w8 = upper_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = lower_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = w4 * c12
    w15 = w7 * c12
    w16 = w0 * c5
    w17 = w3 * c5
    M = ca.vertcat(
        c6,
        0.0,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        c6,
        w4,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        c7,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        0.0,
        w6,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        w7,
        0.0,
        0.0,
        0.0,
        w6,
        w7,
        c10,
    )
    M = ca.reshape(M, 6, 6)
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
    )
    K = ca.reshape(K, 6, 6)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w9,
        w10,
        0.0,
        w12,
        w13,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c14,
        w14,
        0.0,
        c13,
        w15,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w9,
        w10 + c14,
        w14,
        w12,
        c13 + w13,
        w15,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        w16,
        -w17,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 4, 6)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        -(w8 * w17),
        -(w8 * w16),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 65 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    q_ddot = ca.SX.sym("q_ddot", 6)
    c = ca.SX.sym("c", 17)
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
    c6 = c[6]
    c8 = c[8]
    c9 = c[9]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    w0 = upper_theta_dot**2
    w1 = ca.cos(upper_theta) * c11
    w2 = ca.sin(upper_theta) * c11
    w3 = lower_theta_dot**2
    w4 = ca.cos(lower_theta) * c9
    w5 = ca.sin(lower_theta) * c9
    w6 = w3 * w4 - (lower_x_ddot * c8 - w5 * lower_theta_ddot)
    w7 = w0 * w1 - (upper_x_ddot * c6 - w2 * upper_theta_ddot) + w6
    w8 = c13 + w3 * w5 - (lower_y_ddot * c8 + w4 * lower_theta_ddot)
    w9 = c14 + w0 * w2 - (upper_y_ddot * c6 + w1 * upper_theta_ddot) + w8
    lam = ca.vertcat(
        w7,
        w9,
        w6,
        w8,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w7,
        -w9,
        0.0,
        -w6,
        -w8,
        0.0,
    )
    joint_forces = ca.reshape(joint_forces, 3, 2)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 74 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 17)
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
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    w0 = ca.sin(upper_theta) * c11
    w1 = ca.cos(upper_theta) * c11
    w2 = upper_x_dot * (upper_x_dot * c6 - w0 * upper_theta_dot) + upper_y_dot * (upper_y_dot * c6 + upper_theta_dot * w1)
    w3 = ca.sin(lower_theta) * c9
    w4 = w2 + upper_theta_dot * (upper_y_dot * w1 - upper_x_dot * w0 + upper_theta_dot * c7) + lower_x_dot * (lower_x_dot * c8 - w3 * lower_theta_dot)
    w5 = ca.cos(lower_theta) * c9
    w6 = w4 + lower_y_dot * (lower_y_dot * c8 + lower_theta_dot * w5) + lower_theta_dot * (lower_y_dot * w5 - lower_x_dot * w3 + lower_theta_dot * c10)
    kinetic = ca.vertcat(
        w6 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -((w0 + upper_y * c6) * c12 + (w3 + lower_y * c8) * c12),
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
    """Origin and rotation matrix of each body, for pictures. 38 operations."""
    q = ca.SX.sym("q", 6)
    upper_x = q[0]
    upper_y = q[1]
    upper_theta = q[2]
    lower_x = q[3]
    lower_y = q[4]
    lower_theta = q[5]
    w0 = ca.cos(upper_theta)
    w1 = ca.sin(upper_theta)
    w2 = ca.cos(lower_theta)
    w3 = ca.sin(lower_theta)
    poses = ca.vertcat(
        upper_x,
        upper_y,
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
        lower_x,
        lower_y,
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
    )
    poses = ca.reshape(poses, 12, 2)
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 26 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    w0 = ca.cos(lower_theta - upper_theta) * c1
    w1 = lower_theta_dot**2 * w0
    w2 = upper_theta_dot**2 * w0
    dQ_hat_dq_i = ca.vertcat(
        -(w1 + ca.sin(upper_theta) * c3),
        w2,
        w1,
        -(w2 + ca.sin(lower_theta) * c4),
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 2, 2)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 16 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c15 = c[15]
    w0 = ca.sin(lower_theta - upper_theta) * c15
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
        -(upper_theta_dot * w0),
        lower_theta_dot * w0,
        0.0,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 2, 2)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 16 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_ddot = q_i_ddot[0]
    lower_theta_ddot = q_i_ddot[1]
    c1 = c[1]
    w0 = ca.sin(lower_theta - upper_theta) * c1
    w1 = lower_theta_ddot * w0
    w2 = upper_theta_ddot * w0
    dMa_dq_i = ca.vertcat(
        w1,
        w2,
        -w1,
        -w2,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 2, 2)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 74 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 17)
    upper_theta = q_i[0]
    lower_theta = q_i[1]
    upper_theta_dot = q_i_dot[0]
    lower_theta_dot = q_i_dot[1]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c12 = c[12]
    c13 = c[13]
    c16 = c[16]
    w0 = ca.cos(upper_theta)
    w1 = w0 * c5
    w2 = lower_theta_dot**2
    w3 = ca.sin(lower_theta) * c9
    w4 = ca.cos(lower_theta) * c9
    w5 = w4 / c10
    w6 = w4 * c12
    w7 = c8 - w4 * w5
    w8 = upper_theta_dot**2
    w9 = ca.sin(upper_theta) * c5
    w10 = w8 * w9
    w11 = w3 / c10
    w12 = w4 * w11
    w13 = w1 * w12
    w14 = w1 * w8
    w15 = c8 - w3 * w11
    w16 = w0 * c16 + w1 * (c13 + w2 * w3 - w5 * w6 + w7 * w10) + w13 * w14 - w9 * (w2 * w4 + w6 * w11 + w10 * w12 + w14 * w15)
    w17 = w16 / (c7 + w1 * (w1 * w7) - (w9 * (w13 - w9 * w15) + w9 * w13))
    q_i_ddot = ca.vertcat(
        w17,
        (w6 - (w3 * (w14 + w9 * w17) + w4 * (w1 * w17 - w10))) / c10,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 64 operations."""
    p = ca.SX.sym("p", 9)
    upper_tip_x = p[7]
    lower_tip_x = p[8]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        upper_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        lower_tip_x,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 5)
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
    )
    axes = ca.reshape(axes, 9, 5)
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
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
