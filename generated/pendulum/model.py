"""Simple pendulum: equations of motion, emitted by symgen from the scene `pendulum`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 rod.theta [rad]

q_d, the dependent coordinates by index:
    0 rod.x [m], 1 rod.y [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 3) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    7 operations.
    """
    p = ca.SX.sym("p", 3)
    length = p[0]
    gravity_y = p[1]
    rod_mass = p[2]
    # intermediate terms (2)
    w0 = rod_mass * length
    w1 = w0 * gravity_y
    # outputs
    c = ca.vertcat(
        rod_mass * length**2,  # c0
        w1,  # c1
        rod_mass,  # rod_mass
        w0,  # c3
        gravity_y,  # gravity_y
        rod_mass * gravity_y,  # c5
        -gravity_y,  # c6
        length,  # length
        -w1,  # c8
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 1) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 1) [N, N m]: condensed force S^T (Q* - M s)
    2 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c0 = c[0]
    c1 = c[1]
    # outputs
    M_hat = ca.vertcat(c0)
    Q_hat = ca.vertcat(ca.cos(rod_theta) * c1)
    inputs, outputs = [q_i, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    gives q_d_next (n_d = 2) [mixed]: dependent coordinates after one Newton step
    0 operations.
    """
    # outputs
    q_d_next = ca.SX(2, 1)
    inputs, outputs = [], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, [], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    gives q_d_dot (n_d = 2) [mixed]: rates of the dependent coordinates
    0 operations.
    """
    # outputs
    q_d_dot = ca.SX(2, 1)
    inputs, outputs = [], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, [], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    gives q_d_ddot (n_d = 2) [mixed]: accelerations of the dependent coordinates
    0 operations.
    """
    # outputs
    q_d_ddot = ca.SX(2, 1)
    inputs, outputs = [], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, [], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives C (n_c = 2) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 2 x 3) [SI]: constraint Jacobian
    gives C_t (n_c = 2) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 2) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 2) [m/s^2, rad/s^2]: right-hand side at acceleration level
    0 operations.
    """
    q = ca.SX.sym("q", 3)
    rod_x = q[0]
    rod_y = q[1]
    # outputs
    C = ca.vertcat(rod_x, rod_y)
    C_q = ca.SX(2, 3)
    # hinge.x
    C_q[0, 0] = 1.0
    # hinge.y
    C_q[1, 1] = 1.0
    C_t = ca.SX(2, 1)
    nu = ca.SX(2, 1)
    gamma = ca.SX(2, 1)
    inputs, outputs = [q], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 3 x 3) [SI]: mass matrix in all coordinates
    gives K (n x n = 3 x 3) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 3) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 3) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 3) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 2 x 3) [SI]: constraint Jacobian
    gives gamma (n_c = 2) [m/s^2, rad/s^2]: right-hand side at acceleration level
    10 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_theta = q[2]
    rod_theta_dot = q_dot[2]
    c0 = c[0]
    rod_mass = c[2]
    c3 = c[3]
    gravity_y = c[4]
    c5 = c[5]
    # intermediate terms (7)
    w0 = ca.sin(rod_theta) * c3
    w1 = -w0
    w2 = ca.cos(rod_theta) * c3
    w3 = rod_theta_dot**2
    w4 = w2 * w3
    w5 = w0 * w3
    w6 = w2 * gravity_y
    # outputs
    M = ca.vertcat(
        ca.horzcat(rod_mass, 0.0, w1),  # rod.x
        ca.horzcat(0.0, rod_mass, w2),  # rod.y
        ca.horzcat(w1, w2, c0),  # rod.theta
    )
    K = ca.SX(3, 3)
    Q_v = ca.vertcat(w4, w5, 0.0)
    Q_F = ca.vertcat(0.0, c5, w6)
    Q_star = ca.vertcat(w4, w5 + c5, w6)
    C_q = ca.SX(2, 3)
    # hinge.x
    C_q[0, 0] = 1.0
    # hinge.y
    C_q[1, 1] = 1.0
    gamma = ca.SX(2, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes q_ddot (n = 3) [mixed]: accelerations of all coordinates
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 2) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3) [N, N m]: world force and moment of a joint on its body b, at b
    18 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    q_ddot = ca.SX.sym("q_ddot", 3)
    c = ca.SX.sym("c", 9)
    rod_theta = q[2]
    rod_theta_dot = q_dot[2]
    rod_x_ddot = q_ddot[0]
    rod_y_ddot = q_ddot[1]
    rod_theta_ddot = q_ddot[2]
    rod_mass = c[2]
    c3 = c[3]
    c5 = c[5]
    # intermediate terms (5)
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * c3
    w2 = ca.sin(rod_theta) * c3
    w3 = w0 * w1 - (rod_x_ddot * rod_mass - w2 * rod_theta_ddot)
    w4 = c5 + w0 * w2 - (rod_y_ddot * rod_mass + w1 * rod_theta_ddot)
    # outputs
    lam = ca.vertcat(w3, w4)
    joint_forces = ca.vertcat(-w3, -w4, 0.0)
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    24 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_y = q[1]
    rod_theta = q[2]
    rod_x_dot = q_dot[0]
    rod_y_dot = q_dot[1]
    rod_theta_dot = q_dot[2]
    c0 = c[0]
    rod_mass = c[2]
    c3 = c[3]
    c6 = c[6]
    # intermediate terms (3)
    w0 = ca.sin(rod_theta) * c3
    w1 = ca.cos(rod_theta) * c3
    w2 = rod_x_dot * (rod_x_dot * rod_mass - w0 * rod_theta_dot) + rod_y_dot * (rod_y_dot * rod_mass + rod_theta_dot * w1)
    # outputs
    kinetic = ca.vertcat((w2 + rod_theta_dot * (rod_y_dot * w1 - rod_x_dot * w0 + rod_theta_dot * c0)) / 2.0)
    elastic = ca.SX(1, 1)
    potential = ca.vertcat((w0 + rod_y * rod_mass) * c6)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 3) [mixed]: rates of all coordinates
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives measures (measures = 4) [mixed]: measures of the scene and their rates
    10 operations.
    """
    q = ca.SX.sym("q", 3)
    q_dot = ca.SX.sym("q_dot", 3)
    c = ca.SX.sym("c", 9)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    rod_x_dot = q_dot[0]
    rod_y_dot = q_dot[1]
    rod_theta_dot = q_dot[2]
    length = c[7]
    # intermediate terms (2)
    w0 = ca.cos(rod_theta) * length
    w1 = ca.sin(rod_theta) * length
    # outputs
    measures = ca.vertcat(
        rod_x + w0,  # tip_x
        rod_x_dot - rod_theta_dot * w1,  # tip_x_dot
        rod_y + w1,  # tip_y
        rod_y_dot + w0 * rod_theta_dot,  # tip_y_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 3) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    3 operations.
    """
    q = ca.SX.sym("q", 3)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    # intermediate terms (2)
    w0 = ca.cos(rod_theta)
    w1 = ca.sin(rod_theta)
    # outputs
    poses = ca.SX(12, 1)
    poses[0] = rod_x
    poses[1] = rod_y
    poses[3] = w0
    poses[4] = w1
    poses[6] = -w1
    poses[7] = w0
    poses[11] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i, through q_d
    2 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c8 = c[8]
    # outputs
    dQ_hat_dq_i = ca.vertcat(ca.sin(rod_theta) * c8)
    inputs, outputs = [q_i, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    gives dQ_hat_dq_i_dot (n_i x n_i = 1) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    0 operations.
    """
    # outputs
    dQ_hat_dq_i_dot = ca.SX(1, 1)
    inputs, outputs = [], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, [], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 1) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 1) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    2 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c8 = c[8]
    # outputs
    J_q = ca.vertcat(ca.sin(rod_theta) * c8)
    J_v = ca.SX(1, 1)
    inputs, outputs = [q_i, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "c"], ["J_q", "J_v"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 1) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 9) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 1) [mixed]: accelerations of the independent coordinates
    3 operations.
    """
    q_i = ca.SX.sym("q_i", 1)
    c = ca.SX.sym("c", 9)
    rod_theta = q_i[0]
    c0 = c[0]
    c1 = c[1]
    # outputs
    q_i_ddot = ca.vertcat(ca.cos(rod_theta) * c1 / c0)
    inputs, outputs = [q_i, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 3) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 3) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 3) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 3)
    length = p[0]
    # outputs
    positions = ca.SX(3, 3)
    positions[0, 2] = length
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
    "measures": measures,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
