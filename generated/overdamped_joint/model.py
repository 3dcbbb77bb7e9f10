"""Pendulum with an overdamped joint: equations of motion, emitted by symgen from the scene `overdamped_joint`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 59 operations."""
    p = ca.SX.sym("p", 10)
    gravity_y = p[0]
    rod_mass = p[1]
    rod_inertia = p[2]
    rod_center_of_mass_x = p[3]
    finger_mass = p[4]
    finger_inertia = p[5]
    finger_center_of_mass_x = p[6]
    rod_tip_x = p[7]
    spring_stiffness = p[8]
    spring_damping = p[9]
    w0 = rod_tip_x * finger_mass
    w1 = finger_mass * finger_center_of_mass_x
    w2 = rod_mass * rod_center_of_mass_x
    w3 = w2 * gravity_y
    c = ca.vertcat(
        spring_stiffness,
        spring_damping,
        rod_inertia + rod_center_of_mass_x * w2 + finger_mass * rod_tip_x**2,
        w0 * finger_center_of_mass_x,
        finger_inertia + finger_center_of_mass_x * w1,
        w3 + w0 * gravity_y,
        w1 * gravity_y,
        rod_tip_x,
        rod_mass,
        rod_inertia + rod_mass * rod_center_of_mass_x**2,
        finger_mass,
        w1,
        finger_inertia + finger_mass * finger_center_of_mass_x**2,
        w2,
        gravity_y,
        finger_mass * gravity_y,
        rod_mass * gravity_y,
        -spring_stiffness,
        -spring_damping,
        finger_center_of_mass_x * (finger_mass * (2 * rod_tip_x)),
        w3,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 44 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = finger_theta - rod_theta
    w1 = ca.cos(w0) * c3
    w2 = rod_theta * c0
    w3 = finger_theta * c0
    w4 = finger_theta_dot * c1
    w5 = ca.sin(w0) * c3
    w6 = rod_theta_dot * c1
    M_hat = ca.vertcat(
        c2,
        w1,
        w1,
        c4,
    )
    M_hat = ca.reshape(M_hat, 2, 2)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        finger_theta_dot**2 * w5 + (w4 + (ca.cos(rod_theta) * c5 + w3)) - w2 - w6,
        w6 + (w2 + ca.cos(finger_theta) * c6) - w3 - w4 - rod_theta_dot**2 * w5,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 11 operations."""
    q_i = ca.SX.sym("q_i", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    c7 = c[7]
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        ca.cos(rod_theta) * c7,
        ca.sin(rod_theta) * c7,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 15 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    rod_theta_dot = q_i_dot[0]
    c7 = c[7]
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -(ca.sin(rod_theta) * c7 * rod_theta_dot),
        rod_theta_dot * (ca.cos(rod_theta) * c7),
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 21 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    rod_theta_dot = q_i_dot[0]
    rod_theta_ddot = q_i_ddot[0]
    c7 = c[7]
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * c7
    w2 = ca.sin(rod_theta) * c7
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w1 + w2 * rod_theta_ddot),
        w1 * rod_theta_ddot - w0 * w2,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 64 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    finger_x = q[3]
    finger_y = q[4]
    rod_theta_dot = q_dot[2]
    c7 = c[7]
    w0 = ca.cos(rod_theta) * c7
    w1 = ca.sin(rod_theta) * c7
    w2 = rod_theta_dot**2
    C = ca.vertcat(
        rod_x,
        rod_y,
        finger_x - (rod_x + w0),
        finger_y - (rod_y + w1),
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
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 171 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    rod_theta = q[2]
    finger_theta = q[5]
    rod_theta_dot = q_dot[2]
    finger_theta_dot = q_dot[5]
    c0 = c[0]
    c1 = c[1]
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
    w0 = ca.sin(rod_theta)
    w1 = w0 * c13
    w2 = -w1
    w3 = ca.cos(rod_theta)
    w4 = w3 * c13
    w5 = ca.sin(finger_theta) * c11
    w6 = -w5
    w7 = ca.cos(finger_theta) * c11
    w8 = rod_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = finger_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = (finger_theta - rod_theta) * c0 + (finger_theta_dot - rod_theta_dot) * c1
    w15 = w4 * c14 + w14
    w16 = w7 * c14 - w14
    w17 = w0 * c7
    w18 = w3 * c7
    M = ca.vertcat(
        c8,
        0.0,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        c8,
        w4,
        0.0,
        0.0,
        0.0,
        w2,
        w4,
        c9,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c10,
        0.0,
        w6,
        0.0,
        0.0,
        0.0,
        0.0,
        c10,
        w7,
        0.0,
        0.0,
        0.0,
        w6,
        w7,
        c12,
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
        c16,
        w15,
        0.0,
        c15,
        w16,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w9,
        w10 + c16,
        w15,
        w12,
        c15 + w13,
        w16,
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
        w17,
        -w18,
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
        -(w8 * w18),
        -(w8 * w17),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 65 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    q_ddot = ca.SX.sym("q_ddot", 6)
    c = ca.SX.sym("c", 21)
    rod_theta = q[2]
    finger_theta = q[5]
    rod_theta_dot = q_dot[2]
    finger_theta_dot = q_dot[5]
    rod_x_ddot = q_ddot[0]
    rod_y_ddot = q_ddot[1]
    rod_theta_ddot = q_ddot[2]
    finger_x_ddot = q_ddot[3]
    finger_y_ddot = q_ddot[4]
    finger_theta_ddot = q_ddot[5]
    c8 = c[8]
    c10 = c[10]
    c11 = c[11]
    c13 = c[13]
    c15 = c[15]
    c16 = c[16]
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * c13
    w2 = ca.sin(rod_theta) * c13
    w3 = finger_theta_dot**2
    w4 = ca.cos(finger_theta) * c11
    w5 = ca.sin(finger_theta) * c11
    w6 = w3 * w4 - (finger_x_ddot * c10 - w5 * finger_theta_ddot)
    w7 = w0 * w1 - (rod_x_ddot * c8 - w2 * rod_theta_ddot) + w6
    w8 = c15 + w3 * w5 - (finger_y_ddot * c10 + w4 * finger_theta_ddot)
    w9 = c16 + w0 * w2 - (rod_y_ddot * c8 + w1 * rod_theta_ddot) + w8
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
    """Energies in J and powers in W. 83 operations."""
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 21)
    rod_y = q[1]
    rod_theta = q[2]
    finger_y = q[4]
    finger_theta = q[5]
    rod_x_dot = q_dot[0]
    rod_y_dot = q_dot[1]
    rod_theta_dot = q_dot[2]
    finger_x_dot = q_dot[3]
    finger_y_dot = q_dot[4]
    finger_theta_dot = q_dot[5]
    c0 = c[0]
    c1 = c[1]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    w0 = ca.sin(rod_theta) * c13
    w1 = ca.cos(rod_theta) * c13
    w2 = rod_x_dot * (rod_x_dot * c8 - w0 * rod_theta_dot) + rod_y_dot * (rod_y_dot * c8 + rod_theta_dot * w1)
    w3 = ca.sin(finger_theta) * c11
    w4 = w2 + rod_theta_dot * (rod_y_dot * w1 - rod_x_dot * w0 + rod_theta_dot * c9) + finger_x_dot * (finger_x_dot * c10 - w3 * finger_theta_dot)
    w5 = ca.cos(finger_theta) * c11
    w6 = w4 + finger_y_dot * (finger_y_dot * c10 + finger_theta_dot * w5) + finger_theta_dot * (finger_y_dot * w5 - finger_x_dot * w3 + finger_theta_dot * c12)
    kinetic = ca.vertcat(
        w6 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (finger_theta - rod_theta)**2 * c0 / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -((w0 + rod_y * c8) * c14 + (w3 + finger_y * c10) * c14),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        (finger_theta_dot - rod_theta_dot)**2 * c1,
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
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    finger_x = q[3]
    finger_y = q[4]
    finger_theta = q[5]
    w0 = ca.cos(rod_theta)
    w1 = ca.sin(rod_theta)
    w2 = ca.cos(finger_theta)
    w3 = ca.sin(finger_theta)
    poses = ca.vertcat(
        rod_x,
        rod_y,
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
        finger_x,
        finger_y,
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
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 30 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    c0 = c[0]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c17 = c[17]
    w0 = ca.cos(finger_theta - rod_theta) * c3
    w1 = finger_theta_dot**2 * w0
    w2 = rod_theta_dot**2 * w0
    dQ_hat_dq_i = ca.vertcat(
        c17 - w1 - ca.sin(rod_theta) * c5,
        c0 + w2,
        c0 + w1,
        c17 - w2 - ca.sin(finger_theta) * c6,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 2, 2)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 18 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    c1 = c[1]
    c18 = c[18]
    c19 = c[19]
    w0 = ca.sin(finger_theta - rod_theta) * c19
    dQ_hat_dq_i_dot = ca.vertcat(
        c18,
        c1 - rod_theta_dot * w0,
        c1 + finger_theta_dot * w0,
        c18,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 2, 2)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 16 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_ddot = q_i_ddot[0]
    finger_theta_ddot = q_i_ddot[1]
    c3 = c[3]
    w0 = ca.sin(finger_theta - rod_theta) * c3
    w1 = finger_theta_ddot * w0
    w2 = rod_theta_ddot * w0
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
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 83 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
    c12 = c[12]
    c14 = c[14]
    c15 = c[15]
    c20 = c[20]
    w0 = ca.cos(rod_theta)
    w1 = (finger_theta - rod_theta) * c0 + (finger_theta_dot - rod_theta_dot) * c1
    w2 = w0 * c7
    w3 = finger_theta_dot**2
    w4 = ca.sin(finger_theta) * c11
    w5 = ca.cos(finger_theta) * c11
    w6 = w5 / c12
    w7 = w5 * c14 - w1
    w8 = c10 - w5 * w6
    w9 = rod_theta_dot**2
    w10 = ca.sin(rod_theta) * c7
    w11 = w9 * w10
    w12 = w4 / c12
    w13 = w5 * w12
    w14 = w2 * w13
    w15 = w2 * w9
    w16 = c10 - w4 * w12
    w17 = w0 * c20 + w1 + w2 * (c15 + w3 * w4 - w6 * w7 + w8 * w11) + w14 * w15 - w10 * (w3 * w5 + w7 * w12 + w11 * w13 + w15 * w16)
    w18 = w17 / (c9 + w2 * (w2 * w8) - (w10 * (w14 - w10 * w16) + w10 * w14))
    q_i_ddot = ca.vertcat(
        w18,
        (w7 - (w4 * (w15 + w10 * w18) + w5 * (w2 * w18 - w11))) / c12,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 44 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = finger_theta - rod_theta
    w1 = ca.cos(w0) * c3
    w2 = rod_theta * c0
    w3 = finger_theta * c0
    w4 = finger_theta_dot * c1
    w5 = ca.sin(w0) * c3
    w6 = rod_theta_dot * c1
    M_hat_LL = ca.vertcat(
        c2,
    )
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        w1,
    )
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        w1,
    )
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c4,
    )
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        finger_theta_dot**2 * w5 + (w4 + (ca.cos(rod_theta) * c5 + w3)) - w2 - w6,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        w6 + (w2 + ca.cos(finger_theta) * c6) - w3 - w4 - rod_theta_dot**2 * w5,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 32 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 21)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    rod_theta_ddot = q_L_ddot[0]
    c0 = c[0]
    c1 = c[1]
    c3 = c[3]
    c4 = c[4]
    c6 = c[6]
    w0 = rod_theta - finger_theta
    w1 = rod_theta_dot**2 * (ca.sin(w0) * c3) + (rod_theta_dot * c1 + (ca.cos(finger_theta) * c6 + rod_theta * c0))
    M_hat_SS = ca.vertcat(
        c4,
    )
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w1 - finger_theta * c0 - finger_theta_dot * c1 - rod_theta_ddot * (ca.cos(w0) * c3),
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_i_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_i_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 51 operations."""
    p = ca.SX.sym("p", 10)
    rod_tip_x = p[7]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        rod_tip_x,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 4)
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
    )
    axes = ca.reshape(axes, 9, 4)
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
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
