"""Elastic pendulum: equations of motion, emitted by symgen from the scene `elastic_pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 20 operations."""
    p = ca.SX.sym("p", 6)
    gravity_y = p[0]
    bob_mass = p[1]
    bob_inertia = p[2]
    spring_stiffness = p[3]
    spring_damping = p[4]
    spring_free_length = p[5]
    w0 = bob_mass * gravity_y
    c = ca.vertcat(
        bob_mass,
        bob_inertia,
        spring_free_length,
        spring_stiffness,
        spring_damping,
        w0,
        spring_stiffness * 0.5,
        -w0,
        2 * spring_damping,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 46 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    w0 = bob_x**2 + bob_y**2
    w1 = 1.0 - c2 / ca.sqrt(w0)
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) * c4
    M_hat = ca.vertcat(
        c0,
        0.0,
        0.0,
        0.0,
        c0,
        0.0,
        0.0,
        0.0,
        c1,
    )
    M_hat = ca.reshape(M_hat, 3, 3)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        -(bob_x * w1 * c3 + bob_x * w2 / w0),
        c5 - (bob_y * w1 * c3 + bob_y * w2 / w0),
        0.0,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 61 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    w0 = bob_x**2 + bob_y**2
    w1 = 1.0 - c2 / ca.sqrt(w0)
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) * c4
    w3 = -(bob_x * w1 * c3 + bob_x * w2 / w0)
    w4 = c5 - (bob_y * w1 * c3 + bob_y * w2 / w0)
    M = ca.vertcat(
        c0,
        0.0,
        0.0,
        0.0,
        c0,
        0.0,
        0.0,
        0.0,
        c1,
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
        0.0,
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        w3,
        w4,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w3,
        w4,
        0.0,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 51 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    bob_theta_dot = q_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c4 = c[4]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    w0 = bob_x_dot * (bob_x_dot * c0) + bob_y_dot * (bob_y_dot * c0) + bob_theta_dot * (bob_theta_dot * c1)
    w1 = bob_x**2
    w2 = bob_y**2
    w3 = w1 + w2
    w4 = w1 * (bob_x_dot**2 * c4) / w3 + w2 * (bob_y_dot**2 * c4) / w3 + bob_y * (bob_x * (bob_y_dot * (bob_x_dot * c8))) / w3
    kinetic = ca.vertcat(
        w0 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (ca.sqrt(w3) - c2)**2 * c6,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        bob_y * c7,
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        w4,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates. 17 operations."""
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    w0 = ca.sqrt(bob_x**2 + bob_y**2)
    measures = ca.vertcat(
        w0,
        (2 * bob_x * bob_x_dot + 2 * bob_y * bob_y_dot) / (2 * w0),
    )
    measures = ca.densify(measures)
    inputs, outputs = [q, q_dot], [measures]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures. 20 operations."""
    q = ca.SX.sym("q", 3)
    bob_x = q[0]
    bob_y = q[1]
    bob_theta = q[2]
    w0 = ca.cos(bob_theta)
    w1 = ca.sin(bob_theta)
    poses = ca.vertcat(
        bob_x,
        bob_y,
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
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 78 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    w0 = bob_x**2 + bob_y**2
    w1 = ca.sqrt(w0)
    w2 = c2 / w1
    w3 = w2 / w1
    w4 = bob_x / w1
    w5 = bob_x_dot * c4
    w6 = (bob_x * bob_x_dot + bob_y * bob_y_dot) * c4
    w7 = bob_x * w6 / w0 / w0
    w8 = bob_y * w6 / w0 / w0
    w9 = bob_y / w1
    w10 = bob_y_dot * c4
    w11 = bob_x * w3
    w12 = w2 * c3
    w13 = bob_y * w3
    dQ_hat_dq_i = ca.vertcat(
        2 * (bob_x * w7) + w12 - c3 - w4 * w11 * c3 - (bob_x * w5 + w6) / w0,
        2 * (bob_x * w8) - w4 * w13 * c3 - bob_y * w5 / w0,
        0.0,
        2 * (bob_y * w7) - w9 * w11 * c3 - bob_x * w10 / w0,
        w12 + 2 * (bob_y * w8) - c3 - w9 * w13 * c3 - (w6 + bob_y * w10) / w0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 3, 3)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_i_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 30 operations."""
    q_i = ca.SX.sym("q_i", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q_i[0]
    bob_y = q_i[1]
    c4 = c[4]
    w0 = bob_x * c4
    w1 = bob_x**2 + bob_y**2
    w2 = bob_y * c4
    dQ_hat_dq_i_dot = ca.vertcat(
        -(bob_x * w0 / w1),
        -(w0 * bob_y / w1),
        0.0,
        -(bob_x * w2 / w1),
        -(bob_y * w2 / w1),
        0.0,
        0.0,
        0.0,
        0.0,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 3, 3)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 10 operations."""
    dMa_dq_i = ca.vertcat(
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
    dMa_dq_i = ca.reshape(dMa_dq_i, 3, 3)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, [], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 38 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 9)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    w0 = bob_x**2 + bob_y**2
    w1 = 1.0 - c2 / ca.sqrt(w0)
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) * c4
    q_i_ddot = ca.vertcat(
        -((bob_x * w1 * c3 + bob_x * w2 / w0) / c0),
        (c5 - (bob_y * w1 * c3 + bob_y * w2 / w0)) / c0,
        0.0,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures. 26 operations."""
    p = ca.SX.sym("p", 6)
    positions = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    positions = ca.reshape(positions, 3, 2)
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
    )
    axes = ca.reshape(axes, 9, 2)
    axes = ca.densify(axes)
    inputs, outputs = [p], [positions, axes]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "augmented": augmented,
    "energy": energy,
    "measures": measures,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
