"""Elastic pendulum: equations of motion, emitted by symgen from the scene `elastic_pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 bob.x [m], 1 bob.y [m], 2 bob.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    3 operations.
    """
    p = ca.SX.sym("p", 6)
    gravity_y = p[0]
    bob_mass = p[1]
    bob_inertia = p[2]
    spring_stiffness = p[3]
    spring_damping = p[4]
    spring_free_length = p[5]
    # intermediate terms (1)
    w0 = bob_mass * gravity_y
    # outputs
    c = ca.vertcat(
        bob_mass,  # bob_mass
        bob_inertia,  # bob_inertia
        spring_stiffness,  # spring_stiffness
        spring_free_length,  # spring_free_length
        spring_damping,  # spring_damping
        w0,  # c5
        -w0,  # c6
        -spring_damping,  # c7
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 3 x 3) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 3) [N, N m]: condensed force S^T (Q* - M s)
    20 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    bob_mass = c[0]
    bob_inertia = c[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    c5 = c[5]
    # intermediate terms (3)
    w0 = bob_x**2 + bob_y**2
    w1 = (1.0 - spring_free_length / ca.sqrt(w0)) * spring_stiffness
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0 * spring_damping
    # outputs
    M_hat = ca.SX(3, 3)
    # bob.x
    M_hat[0, 0] = bob_mass
    # bob.y
    M_hat[1, 1] = bob_mass
    # bob.theta
    M_hat[2, 2] = bob_inertia
    Q_hat = ca.vertcat(-(bob_x * w1 + bob_x * w2), c5 - (bob_y * w1 + bob_y * w2), 0.0)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 3 x 3) [SI]: mass matrix in all coordinates
    gives K (n x n = 3 x 3) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 3) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 3) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 3) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    20 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    bob_mass = c[0]
    bob_inertia = c[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    c5 = c[5]
    # intermediate terms (5)
    w0 = bob_x**2 + bob_y**2
    w1 = (1.0 - spring_free_length / ca.sqrt(w0)) * spring_stiffness
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0 * spring_damping
    w3 = -(bob_x * w1 + bob_x * w2)
    w4 = c5 - (bob_y * w1 + bob_y * w2)
    # outputs
    M = ca.SX(3, 3)
    # bob.x
    M[0, 0] = bob_mass
    # bob.y
    M[1, 1] = bob_mass
    # bob.theta
    M[2, 2] = bob_inertia
    K = ca.SX(3, 3)
    Q_v = ca.SX(3, 1)
    Q_F = ca.vertcat(w3, w4, 0.0)
    Q_star = ca.vertcat(w3, w4, 0.0)
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    24 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    bob_theta_dot = q_dot[2]
    bob_mass = c[0]
    bob_inertia = c[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    c6 = c[6]
    # intermediate terms (3)
    w0 = bob_x_dot * (bob_x_dot * bob_mass) + bob_y_dot * (bob_y_dot * bob_mass) + bob_theta_dot * (bob_theta_dot * bob_inertia)
    w1 = bob_x**2 + bob_y**2
    w2 = bob_x_dot * bob_x + bob_y_dot * bob_y
    # outputs
    kinetic = ca.vertcat(w0 / 2.0)
    elastic = ca.vertcat((ca.sqrt(w1) - spring_free_length)**2 * spring_stiffness / 2.0)
    potential = ca.vertcat(bob_y * c6)
    power_dissipated = ca.vertcat(w2 * (w2 / w1 * spring_damping))
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    gives measures (measures = 2) [mixed]: measures of the scene and their rates
    19 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    # intermediate terms (3)
    w0 = bob_x**2 + bob_y**2
    w1 = w0 < 1e-24
    w2 = ca.if_else(ca.logic_not(w1), (bob_x * bob_x_dot + bob_y * bob_y_dot) / ca.sqrt(ca.fmax(w0, 1e-24)), 0)
    # outputs
    measures = ca.vertcat(ca.sqrt(w0), ca.if_else(w1, ca.sqrt(bob_x_dot**2 + bob_y_dot**2), 0) + w2)
    inputs, outputs = [q, q_dot], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot"], ["measures"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3) [N, N m]: world force and moment of a load on its marker, or b
    20 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q[0]
    bob_y = q[1]
    bob_x_dot = q_dot[0]
    bob_y_dot = q_dot[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    # intermediate terms (3)
    w0 = bob_x**2 + bob_y**2
    w1 = (1.0 - spring_free_length / ca.sqrt(w0)) * spring_stiffness
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0 * spring_damping
    # outputs
    load_actions = ca.vertcat(-(bob_x * w1 + bob_x * w2), -(bob_y * w1 + bob_y * w2), 0.0)
    inputs, outputs = [q, q_dot, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["q", "q_dot", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    3 operations.
    """
    q = ca.SX.sym("q", 3)
    bob_x = q[0]
    bob_y = q[1]
    bob_theta = q[2]
    # intermediate terms (2)
    w0 = ca.cos(bob_theta)
    w1 = ca.sin(bob_theta)
    # outputs
    poses = ca.SX(12, 1)
    poses[0] = bob_x
    poses[1] = bob_y
    poses[3] = w0
    poses[4] = w1
    poses[6] = -w1
    poses[7] = w0
    poses[11] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i, through q_d
    50 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    # intermediate terms (12)
    w0 = bob_x**2 + bob_y**2
    w1 = ca.sqrt(w0)
    w2 = spring_free_length / w1
    w3 = w2 / w1
    w4 = w3 * (bob_x / w1) * spring_stiffness
    w5 = (1.0 - w2) * spring_stiffness
    w6 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0
    w7 = w6 / w0
    w8 = (bob_x_dot / w0 - w7 * (2 * bob_x)) * spring_damping
    w9 = w6 * spring_damping
    w10 = w3 * (bob_y / w1) * spring_stiffness
    w11 = (bob_y_dot / w0 - w7 * (2 * bob_y)) * spring_damping
    # outputs
    dQ_hat_dq_i = ca.SX(3, 3)
    # bob.x
    dQ_hat_dq_i[0, 0] = -(bob_x * w4 + w5 + (bob_x * w8 + w9))
    dQ_hat_dq_i[0, 1] = -(bob_x * w10 + bob_x * w11)
    # bob.y
    dQ_hat_dq_i[1, 0] = -(bob_y * w4 + bob_y * w8)
    dQ_hat_dq_i[1, 1] = -(w5 + bob_y * w10 + (w9 + bob_y * w11))
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    13 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q_i[0]
    bob_y = q_i[1]
    c7 = c[7]
    # intermediate terms (3)
    w0 = bob_x**2 + bob_y**2
    w1 = bob_x / w0
    w2 = bob_y / w0
    # outputs
    dQ_hat_dq_i_dot = ca.SX(3, 3)
    # bob.x
    dQ_hat_dq_i_dot[0, 0] = bob_x * w1 * c7
    dQ_hat_dq_i_dot[0, 1] = bob_x * w2 * c7
    # bob.y
    dQ_hat_dq_i_dot[1, 0] = bob_y * w1 * c7
    dQ_hat_dq_i_dot[1, 1] = bob_y * w2 * c7
    inputs, outputs = [q_i, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 3 x 3) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 3 x 3) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    62 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    # intermediate terms (14)
    w0 = bob_x**2 + bob_y**2
    w1 = ca.sqrt(w0)
    w2 = spring_free_length / w1
    w3 = w2 / w1
    w4 = w3 * (bob_x / w1) * spring_stiffness
    w5 = (1.0 - w2) * spring_stiffness
    w6 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0
    w7 = w6 / w0
    w8 = (bob_x_dot / w0 - w7 * (2 * bob_x)) * spring_damping
    w9 = w6 * spring_damping
    w10 = w3 * (bob_y / w1) * spring_stiffness
    w11 = (bob_y_dot / w0 - w7 * (2 * bob_y)) * spring_damping
    w12 = bob_x / w0 * spring_damping
    w13 = bob_y / w0 * spring_damping
    # outputs
    J_q = ca.SX(3, 3)
    # bob.x
    J_q[0, 0] = -(bob_x * w4 + w5 + (bob_x * w8 + w9))
    J_q[0, 1] = -(bob_x * w10 + bob_x * w11)
    # bob.y
    J_q[1, 0] = -(bob_y * w4 + bob_y * w8)
    J_q[1, 1] = -(w5 + bob_y * w10 + (w9 + bob_y * w11))
    J_v = ca.SX(3, 3)
    # bob.x
    J_v[0, 0] = -(bob_x * w12)
    J_v[0, 1] = -(bob_x * w13)
    # bob.y
    J_v[1, 0] = -(bob_y * w12)
    J_v[1, 1] = -(bob_y * w13)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 3) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 3) [mixed]: rates of the independent coordinates
    takes c (n_const = 8) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 3) [mixed]: accelerations of the independent coordinates
    22 operations.
    """
    q_i = ca.SX.sym("q_i", 3)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 8)
    bob_x = q_i[0]
    bob_y = q_i[1]
    bob_x_dot = q_i_dot[0]
    bob_y_dot = q_i_dot[1]
    bob_mass = c[0]
    spring_stiffness = c[2]
    spring_free_length = c[3]
    spring_damping = c[4]
    c5 = c[5]
    # intermediate terms (3)
    w0 = bob_x**2 + bob_y**2
    w1 = (1.0 - spring_free_length / ca.sqrt(w0)) * spring_stiffness
    w2 = (bob_x * bob_x_dot + bob_y * bob_y_dot) / w0 * spring_damping
    # outputs
    q_i_ddot = ca.vertcat(-((bob_x * w1 + bob_x * w2) / bob_mass), (c5 - (bob_y * w1 + bob_y * w2)) / bob_mass, 0.0)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 2) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 2) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 6)
    # outputs
    positions = ca.SX(3, 2)
    axes = ca.SX(9, 2)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "augmented": augmented,
    "energy": energy,
    "measures": measures,
    "load_actions": load_actions,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
