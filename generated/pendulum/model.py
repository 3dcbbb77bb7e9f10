"""Simple pendulum: equations of motion, emitted by symgen from the scene `pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 19 operations."""
    p = ca.SX.sym("p", 3)
    length = p[0]
    gravity_y = p[1]
    rod_mass = p[2]
    w0 = rod_mass * length
    w1 = w0 * gravity_y
    c = ca.vertcat(
        rod_mass * length**2,
        w1,
        rod_mass,
        w0,
        gravity_y,
        rod_mass * gravity_y,
        -gravity_y,
        length,
        -w1,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 7 operations."""
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c0 = c[0]
    c1 = c[1]
    M_hat = ca.vertcat(
        c0,
    )
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        ca.cos(rod_theta) * c1,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 3 operations."""
    q_d_next = ca.vertcat(
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [], [q_d_next]
    return ca.Function("closure", inputs, outputs, [], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 3 operations."""
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, [], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 3 operations."""
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, [], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 18 operations."""
    q = ca.SX.sym("q", 3)
    rod_x = q[0]
    rod_y = q[1]
    C = ca.vertcat(
        rod_x,
        rod_y,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 2, 3)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 54 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_theta = q[2]
    rod_theta_dot = q_dot[2]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    w0 = ca.sin(rod_theta) * c3
    w1 = -w0
    w2 = ca.cos(rod_theta) * c3
    w3 = rod_theta_dot**2
    w4 = w2 * w3
    w5 = w0 * w3
    w6 = w2 * c4
    M = ca.vertcat(
        c2,
        0.0,
        w1,
        0.0,
        c2,
        w2,
        w1,
        w2,
        c0,
    )
    M = ca.reshape(M, 3, 3)
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
    )
    K = ca.reshape(K, 3, 3)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w4,
        w5,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        c5,
        w6,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w4,
        w5 + c5,
        w6,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 2, 3)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 32 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    q_ddot = ca.SX.sym("q_ddot", 3)
    c = ca.SX.sym("c", 9)
    rod_theta = q[2]
    rod_theta_dot = q_dot[2]
    rod_x_ddot = q_ddot[0]
    rod_y_ddot = q_ddot[1]
    rod_theta_ddot = q_ddot[2]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * c3
    w2 = ca.sin(rod_theta) * c3
    w3 = w0 * w1 - (rod_x_ddot * c2 - w2 * rod_theta_ddot)
    w4 = c5 + w0 * w2 - (rod_y_ddot * c2 + w1 * rod_theta_ddot)
    lam = ca.vertcat(
        w3,
        w4,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w3,
        -w4,
        0.0,
    )
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 40 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_y = q[1]
    rod_theta = q[2]
    rod_x_dot = q_dot[0]
    rod_y_dot = q_dot[1]
    rod_theta_dot = q_dot[2]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c6 = c[6]
    w0 = ca.sin(rod_theta) * c3
    w1 = ca.cos(rod_theta) * c3
    w2 = rod_x_dot * (rod_x_dot * c2 - w0 * rod_theta_dot) + rod_y_dot * (rod_y_dot * c2 + rod_theta_dot * w1)
    kinetic = ca.vertcat(
        (w2 + rod_theta_dot * (rod_y_dot * w1 - rod_x_dot * w0 + rod_theta_dot * c0)) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        0.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        (w0 + rod_y * c2) * c6,
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


def measures() -> ca.Function:
    """The scene's measures and their rates. 21 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    rod_x_dot = q_dot[0]
    rod_y_dot = q_dot[1]
    rod_theta_dot = q_dot[2]
    c7 = c[7]
    w0 = ca.cos(rod_theta) * c7
    w1 = ca.sin(rod_theta) * c7
    measures = ca.vertcat(
        rod_x + w0,
        rod_x_dot - rod_theta_dot * w1,
        rod_y + w1,
        rod_y_dot + w0 * rod_theta_dot,
    )
    measures = ca.densify(measures)
    inputs, outputs = [q, q_dot, c], [measures]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 20 operations."""
    q = ca.SX.sym("q", 3)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    w0 = ca.cos(rod_theta)
    w1 = ca.sin(rod_theta)
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
    )
    poses = ca.densify(poses)
    inputs, outputs = [q], [poses]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 5 operations."""
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c8 = c[8]
    dQ_hat_dq_i = ca.vertcat(
        ca.sin(rod_theta) * c8,
    )
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 2 operations."""
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
    )
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, [], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 2 operations."""
    dMa_dq_i = ca.vertcat(
        0.0,
    )
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, [], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 7 operations."""
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c0 = c[0]
    c1 = c[1]
    q_i_ddot = ca.vertcat(
        ca.cos(rod_theta) * c1 / c0,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 39 operations."""
    p = ca.SX.sym("p", 3)
    length = p[0]
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        length,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 3)
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
    )
    axes = ca.reshape(axes, 9, 3)
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
    "measures": measures,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
