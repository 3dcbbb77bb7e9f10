"""Pendulum with an overdamped joint: equations of motion, emitted by symgen from the scene `overdamped_joint`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 rod.theta [rad], 1 finger.theta [rad]

q_d, the dependent coordinates by index:
    0 rod.x [m], 1 rod.y [m], 2 finger.x [m], 3 finger.y [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 10) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    30 operations.
    """
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
    # intermediate terms (4)
    w0 = rod_tip_x * finger_mass
    w1 = finger_mass * finger_center_of_mass_x
    w2 = rod_mass * rod_center_of_mass_x
    w3 = w2 * gravity_y
    # outputs
    c = ca.vertcat(
        spring_stiffness,  # spring_stiffness
        spring_damping,  # spring_damping
        rod_inertia + rod_center_of_mass_x * w2 + finger_mass * rod_tip_x**2,  # c2
        w0 * finger_center_of_mass_x,  # c3
        finger_inertia + finger_center_of_mass_x * w1,  # c4
        w3 + w0 * gravity_y,  # c5
        w1 * gravity_y,  # c6
        rod_tip_x,  # rod_tip_x
        -rod_tip_x,  # c8
        rod_mass,  # rod_mass
        rod_inertia + rod_mass * rod_center_of_mass_x**2,  # c10
        finger_mass,  # finger_mass
        w1,  # c12
        finger_inertia + finger_mass * finger_center_of_mass_x**2,  # c13
        w2,  # c14
        gravity_y,  # gravity_y
        finger_mass * gravity_y,  # c16
        rod_mass * gravity_y,  # c17
        -gravity_y,  # c18
        -spring_stiffness,  # c19
        -spring_damping,  # c20
        finger_center_of_mass_x * (finger_mass * (2 * rod_tip_x)),  # c21
        w3,  # c22
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 2 x 2) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 2) [N, N m]: condensed force S^T (Q* - M s)
    26 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    spring_stiffness = c[0]
    spring_damping = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    # intermediate terms (5)
    w0 = finger_theta - rod_theta
    w1 = ca.cos(w0) * c3
    w2 = ca.sin(w0) * c3
    w3 = w0 * spring_stiffness + ((finger_theta_dot - rod_theta_dot) * spring_damping + ca.cos(rod_theta) * c5)
    w4 = (rod_theta - finger_theta) * spring_stiffness + (ca.cos(finger_theta) * c6 + (rod_theta_dot - finger_theta_dot) * spring_damping)
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(c2, w1),  # rod.theta
        ca.horzcat(w1, c4),  # finger.theta
    )
    Q_hat = ca.vertcat(finger_theta_dot**2 * w2 + w3, w4 - rod_theta_dot**2 * w2)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 4) [mixed]: dependent coordinates after one Newton step
    4 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    rod_tip_x = c[7]
    # outputs
    q_d_next = ca.SX(4, 1)
    q_d_next[2] = ca.cos(rod_theta) * rod_tip_x  # finger.x
    q_d_next[3] = ca.sin(rod_theta) * rod_tip_x  # finger.y
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 4) [mixed]: rates of the dependent coordinates
    6 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    rod_theta_dot = q_i_dot[0]
    rod_tip_x = c[7]
    c8 = c[8]
    # outputs
    q_d_dot = ca.SX(4, 1)
    q_d_dot[2] = ca.sin(rod_theta) * c8 * rod_theta_dot  # finger.x
    q_d_dot[3] = rod_theta_dot * (ca.cos(rod_theta) * rod_tip_x)  # finger.y
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 4) [mixed]: accelerations of the dependent coordinates
    12 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    rod_theta_dot = q_i_dot[0]
    rod_theta_ddot = q_i_ddot[0]
    rod_tip_x = c[7]
    # intermediate terms (3)
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * rod_tip_x
    w2 = ca.sin(rod_theta) * rod_tip_x
    # outputs
    q_d_ddot = ca.SX(4, 1)
    q_d_ddot[2] = -(w0 * w1 + w2 * rod_theta_ddot)  # finger.x
    q_d_ddot[3] = w1 * rod_theta_ddot - w0 * w2  # finger.y
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 4) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 4 x 6) [SI]: constraint Jacobian
    gives C_t (n_c = 4) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 4) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    14 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 23)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    finger_x = q[3]
    finger_y = q[4]
    rod_theta_dot = q_dot[2]
    rod_tip_x = c[7]
    # intermediate terms (3)
    w0 = ca.cos(rod_theta) * rod_tip_x
    w1 = ca.sin(rod_theta) * rod_tip_x
    w2 = rod_theta_dot**2
    # outputs
    C = ca.vertcat(
        rod_x,  # hinge.x
        rod_y,  # hinge.y
        finger_x - (rod_x + w0),  # knuckle.x
        finger_y - (rod_y + w1),  # knuckle.y
    )
    C_q = ca.SX(4, 6)
    # hinge.x
    C_q[0, 0] = 1.0
    # hinge.y
    C_q[1, 1] = 1.0
    # knuckle.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w1
    C_q[2, 3] = 1.0
    # knuckle.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w0
    C_q[3, 4] = 1.0
    C_t = ca.SX(4, 1)
    nu = ca.SX(4, 1)
    gamma = ca.SX(4, 1)
    gamma[2] = -(w0 * w2)  # knuckle.x
    gamma[3] = -(w1 * w2)  # knuckle.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 6 x 6) [SI]: mass matrix in all coordinates
    gives K (n x n = 6 x 6) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 6) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 6) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 6) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 4 x 6) [SI]: constraint Jacobian
    gives gamma (n_c = 4) [m/s^2, rad/s^2]: right-hand side at acceleration level
    34 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 23)
    rod_theta = q[2]
    finger_theta = q[5]
    rod_theta_dot = q_dot[2]
    finger_theta_dot = q_dot[5]
    spring_stiffness = c[0]
    spring_damping = c[1]
    rod_tip_x = c[7]
    rod_mass = c[9]
    c10 = c[10]
    finger_mass = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    gravity_y = c[15]
    c16 = c[16]
    c17 = c[17]
    # intermediate terms (19)
    w0 = ca.sin(rod_theta)
    w1 = w0 * c14
    w2 = -w1
    w3 = ca.cos(rod_theta)
    w4 = w3 * c14
    w5 = ca.sin(finger_theta) * c12
    w6 = -w5
    w7 = ca.cos(finger_theta) * c12
    w8 = rod_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = finger_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = (finger_theta - rod_theta) * spring_stiffness + (finger_theta_dot - rod_theta_dot) * spring_damping
    w15 = w4 * gravity_y + w14
    w16 = w7 * gravity_y - w14
    w17 = w0 * rod_tip_x
    w18 = w3 * rod_tip_x
    # outputs
    M = ca.SX(6, 6)
    # rod.x
    M[0, 0] = rod_mass
    M[0, 2] = w2
    # rod.y
    M[1, 1] = rod_mass
    M[1, 2] = w4
    # rod.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c10
    # finger.x
    M[3, 3] = finger_mass
    M[3, 5] = w6
    # finger.y
    M[4, 4] = finger_mass
    M[4, 5] = w7
    # finger.theta
    M[5, 3] = w6
    M[5, 4] = w7
    M[5, 5] = c13
    K = ca.SX(6, 6)
    Q_v = ca.vertcat(
        w9,  # rod.x
        w10,  # rod.y
        0.0,  # rod.theta
        w12,  # finger.x
        w13,  # finger.y
        0.0,  # finger.theta
    )
    Q_F = ca.vertcat(
        0.0,  # rod.x
        c17,  # rod.y
        w15,  # rod.theta
        0.0,  # finger.x
        c16,  # finger.y
        w16,  # finger.theta
    )
    Q_star = ca.vertcat(
        w9,  # rod.x
        w10 + c17,  # rod.y
        w15,  # rod.theta
        w12,  # finger.x
        c16 + w13,  # finger.y
        w16,  # finger.theta
    )
    C_q = ca.SX(4, 6)
    # hinge.x
    C_q[0, 0] = 1.0
    # hinge.y
    C_q[1, 1] = 1.0
    # knuckle.x
    C_q[2, 0] = -1.0
    C_q[2, 2] = w17
    C_q[2, 3] = 1.0
    # knuckle.y
    C_q[3, 1] = -1.0
    C_q[3, 2] = -w18
    C_q[3, 4] = 1.0
    gamma = ca.SX(4, 1)
    gamma[2] = -(w8 * w18)  # knuckle.x
    gamma[3] = -(w8 * w17)  # knuckle.y
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes q_ddot (n = 6) [mixed]: accelerations of all coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 4) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 2) [N, N m]: world force and moment of a joint on its body b, at b
    38 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    q_ddot = ca.SX.sym("q_ddot", 6)
    c = ca.SX.sym("c", 23)
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
    rod_mass = c[9]
    finger_mass = c[11]
    c12 = c[12]
    c14 = c[14]
    c16 = c[16]
    c17 = c[17]
    # intermediate terms (10)
    w0 = rod_theta_dot**2
    w1 = ca.cos(rod_theta) * c14
    w2 = ca.sin(rod_theta) * c14
    w3 = finger_theta_dot**2
    w4 = ca.cos(finger_theta) * c12
    w5 = ca.sin(finger_theta) * c12
    w6 = w3 * w4 - (finger_x_ddot * finger_mass - w5 * finger_theta_ddot)
    w7 = w0 * w1 - (rod_x_ddot * rod_mass - w2 * rod_theta_ddot) + w6
    w8 = c16 + w3 * w5 - (finger_y_ddot * finger_mass + w4 * finger_theta_ddot)
    w9 = c17 + w0 * w2 - (rod_y_ddot * rod_mass + w1 * rod_theta_ddot) + w8
    # outputs
    lam = ca.vertcat(
        w7,  # hinge.x
        w9,  # hinge.y
        w6,  # knuckle.x
        w8,  # knuckle.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w7, -w9, 0.0),  # hinge
        ca.vertcat(-w6, -w8, 0.0),  # knuckle
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    55 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 23)
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
    spring_stiffness = c[0]
    spring_damping = c[1]
    rod_mass = c[9]
    c10 = c[10]
    finger_mass = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c18 = c[18]
    # intermediate terms (7)
    w0 = ca.sin(rod_theta) * c14
    w1 = ca.cos(rod_theta) * c14
    w2 = rod_x_dot * (rod_x_dot * rod_mass - w0 * rod_theta_dot) + rod_y_dot * (rod_y_dot * rod_mass + rod_theta_dot * w1)
    w3 = ca.sin(finger_theta) * c12
    w4 = w2 + rod_theta_dot * (rod_y_dot * w1 - rod_x_dot * w0 + rod_theta_dot * c10) + finger_x_dot * (finger_x_dot * finger_mass - w3 * finger_theta_dot)
    w5 = ca.cos(finger_theta) * c12
    w6 = w4 + finger_y_dot * (finger_y_dot * finger_mass + finger_theta_dot * w5) + finger_theta_dot * (finger_y_dot * w5 - finger_x_dot * w3 + finger_theta_dot * c13)
    # outputs
    kinetic = ca.vertcat(w6 / 2.0)
    elastic = ca.vertcat((finger_theta - rod_theta)**2 * spring_stiffness / 2.0)
    potential = ca.vertcat((w0 + rod_y * rod_mass + (w3 + finger_y * finger_mass)) * c18)
    power_dissipated = ca.vertcat((finger_theta_dot - rod_theta_dot)**2 * spring_damping)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 6) [mixed]: rates of all coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3) [N, N m]: world force and moment of a load on its marker, or b
    5 operations.
    """
    q = ca.SX.sym("q", 6)
    q_dot = ca.SX.sym("q_dot", 6)
    c = ca.SX.sym("c", 23)
    rod_theta = q[2]
    finger_theta = q[5]
    rod_theta_dot = q_dot[2]
    finger_theta_dot = q_dot[5]
    spring_stiffness = c[0]
    spring_damping = c[1]
    # intermediate terms (1)
    w0 = (rod_theta - finger_theta) * spring_stiffness + (rod_theta_dot - finger_theta_dot) * spring_damping
    # outputs
    load_actions = ca.vertcat(0.0, 0.0, w0)
    inputs, outputs = [q, q_dot, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["q", "q_dot", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 6) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 2) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    6 operations.
    """
    q = ca.SX.sym("q", 6)
    rod_x = q[0]
    rod_y = q[1]
    rod_theta = q[2]
    finger_x = q[3]
    finger_y = q[4]
    finger_theta = q[5]
    # intermediate terms (4)
    w0 = ca.cos(rod_theta)
    w1 = ca.sin(rod_theta)
    w2 = ca.cos(finger_theta)
    w3 = ca.sin(finger_theta)
    # outputs
    poses = ca.SX(12, 2)
    poses[0, 0] = rod_x
    poses[0, 1] = finger_x
    poses[1, 0] = rod_y
    poses[1, 1] = finger_y
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
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i, through q_d
    17 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    spring_stiffness = c[0]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c19 = c[19]
    # intermediate terms (3)
    w0 = ca.cos(finger_theta - rod_theta) * c3
    w1 = finger_theta_dot**2 * w0
    w2 = rod_theta_dot**2 * w0
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(c19 - ca.sin(rod_theta) * c5 - w1, spring_stiffness + w1),  # rod.theta
        ca.horzcat(spring_stiffness + w2, c19 - ca.sin(finger_theta) * c6 - w2),  # finger.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    7 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    spring_damping = c[1]
    c20 = c[20]
    c21 = c[21]
    # intermediate terms (1)
    w0 = ca.sin(finger_theta - rod_theta) * c21
    # outputs
    dQ_hat_dq_i_dot = ca.vertcat(
        ca.horzcat(c20, spring_damping + finger_theta_dot * w0),  # rod.theta
        ca.horzcat(spring_damping - rod_theta_dot * w0, c20),  # finger.theta
    )
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 2 x 2) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    30 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_i_ddot = ca.SX.sym("q_i_ddot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    rod_theta_ddot = q_i_ddot[0]
    finger_theta_ddot = q_i_ddot[1]
    spring_stiffness = c[0]
    spring_damping = c[1]
    c3 = c[3]
    c5 = c[5]
    c6 = c[6]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    # intermediate terms (9)
    w0 = finger_theta - rod_theta
    w1 = ca.sin(w0)
    w2 = ca.cos(w0) * c3
    w3 = finger_theta_dot**2 * w2
    w4 = w1 * c3
    w5 = finger_theta_ddot * w4
    w6 = rod_theta_dot**2 * w2
    w7 = rod_theta_ddot * w4
    w8 = w1 * c21
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(c19 - ca.sin(rod_theta) * c5 - w3 - w5, w5 + (spring_stiffness + w3)),  # rod.theta
        ca.horzcat(spring_stiffness + w6 - w7, w7 - spring_stiffness - ca.sin(finger_theta) * c6 - w6),  # finger.theta
    )
    J_v = ca.vertcat(
        ca.horzcat(c20, spring_damping + finger_theta_dot * w8),  # rod.theta
        ca.horzcat(spring_damping - rod_theta_dot * w8, c20),  # finger.theta
    )
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 2) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 1) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 1) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 23)
    spring_stiffness = c[0]
    spring_damping = c[1]
    # outputs
    B = ca.vertcat(-1.0, 1.0)
    K_s = ca.vertcat(spring_stiffness)
    D_s = ca.vertcat(spring_damping)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 2) [mixed]: accelerations of the independent coordinates
    67 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    spring_stiffness = c[0]
    spring_damping = c[1]
    rod_tip_x = c[7]
    c10 = c[10]
    finger_mass = c[11]
    c12 = c[12]
    c13 = c[13]
    gravity_y = c[15]
    c16 = c[16]
    c22 = c[22]
    # intermediate terms (19)
    w0 = ca.cos(rod_theta)
    w1 = (finger_theta - rod_theta) * spring_stiffness + (finger_theta_dot - rod_theta_dot) * spring_damping
    w2 = w0 * rod_tip_x
    w3 = finger_theta_dot**2
    w4 = ca.sin(finger_theta) * c12
    w5 = ca.cos(finger_theta) * c12
    w6 = w5 / c13
    w7 = w5 * gravity_y - w1
    w8 = finger_mass - w5 * w6
    w9 = rod_theta_dot**2
    w10 = ca.sin(rod_theta) * rod_tip_x
    w11 = w9 * w10
    w12 = w4 / c13
    w13 = w5 * w12
    w14 = w2 * w13
    w15 = w2 * w9
    w16 = finger_mass - w4 * w12
    w17 = w0 * c22 + w1 + w2 * (c16 + w3 * w4 - w6 * w7 + w8 * w11) + w14 * w15 - w10 * (w3 * w5 + w7 * w12 + w11 * w13 + w15 * w16)
    w18 = w17 / (c10 + w2 * (w2 * w8) - (w10 * (w14 - w10 * w16) + w10 * w14))
    # outputs
    q_i_ddot = ca.vertcat(w18, w7 / c13 - w12 * (w15 + w10 * w18) - w6 * (w2 * w18 - w11))
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 1) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 1) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 1) [N, N m]: part of Q_hat of S
    26 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    spring_stiffness = c[0]
    spring_damping = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    # intermediate terms (5)
    w0 = finger_theta - rod_theta
    w1 = ca.cos(w0) * c3
    w2 = ca.sin(w0) * c3
    w3 = w0 * spring_stiffness + ((finger_theta_dot - rod_theta_dot) * spring_damping + ca.cos(rod_theta) * c5)
    w4 = (rod_theta - finger_theta) * spring_stiffness + (ca.cos(finger_theta) * c6 + (rod_theta_dot - finger_theta_dot) * spring_damping)
    # outputs
    M_hat_LL = ca.vertcat(c2)
    M_hat_LS = ca.vertcat(w1)
    M_hat_SL = ca.vertcat(w1)
    M_hat_SS = ca.vertcat(c4)
    Q_hat_L = ca.vertcat(finger_theta_dot**2 * w2 + w3)
    Q_hat_S = ca.vertcat(w4 - rod_theta_dot**2 * w2)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 23) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 1) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 1) [N, N m]: right-hand side of a sub-step, slow q'' given
    17 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 23)
    rod_theta = q_i[0]
    finger_theta = q_i[1]
    rod_theta_dot = q_i_dot[0]
    finger_theta_dot = q_i_dot[1]
    rod_theta_ddot = q_L_ddot[0]
    spring_stiffness = c[0]
    spring_damping = c[1]
    c3 = c[3]
    c4 = c[4]
    c6 = c[6]
    # intermediate terms (2)
    w0 = rod_theta - finger_theta
    w1 = rod_theta_dot**2 * (ca.sin(w0) * c3) + (ca.cos(finger_theta) * c6 + (rod_theta_dot - finger_theta_dot) * spring_damping)
    # outputs
    M_hat_SS = ca.vertcat(c4)
    rhs_S = ca.vertcat(w0 * spring_stiffness + w1 - rod_theta_ddot * (ca.cos(w0) * c3))
    inputs, outputs = [q_i, q_i_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_i_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 10) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 4) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 4) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 10)
    rod_tip_x = p[7]
    # outputs
    positions = ca.SX(3, 4)
    positions[0, 2] = rod_tip_x
    axes = ca.SX(9, 4)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
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
    "load_actions": load_actions,
    "poses": poses,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "forward_dynamics": forward_dynamics,
    "blocks": blocks,
    "substep_2": substep_2,
    "geometry": geometry,
}
