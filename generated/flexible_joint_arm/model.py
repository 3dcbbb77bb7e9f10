"""Manipulator with flexible joints: equations of motion, emitted by symgen from the scene `flexible_joint_arm`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 link1.theta [rad], 1 rotor1.theta [rad], 2 link2.theta [rad], 3 rotor2.theta [rad]

q_d, the dependent coordinates by index:
    0 link1.x [m], 1 link1.y [m], 2 rotor1.x [m], 3 rotor1.y [m], 4 link2.x [m], 5 link2.y [m],
    6 rotor2.x [m], 7 rotor2.y [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 17) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    38 operations.
    """
    p = ca.SX.sym("p", 17)
    shoulder_torque = p[0]
    elbow_torque = p[1]
    gravity_y = p[2]
    link1_mass = p[3]
    link1_inertia = p[4]
    link1_center_of_mass_x = p[5]
    rotor1_mass = p[6]
    rotor1_inertia = p[7]
    link2_mass = p[8]
    link2_inertia = p[9]
    link2_center_of_mass_x = p[10]
    rotor2_mass = p[11]
    rotor2_inertia = p[12]
    link1_tip_x = p[13]
    gear1_stiffness = p[14]
    gear2_stiffness = p[15]
    # intermediate terms (7)
    w0 = link1_tip_x * rotor2_mass
    w1 = link1_tip_x * link2_mass
    w2 = link2_mass * link2_center_of_mass_x
    w3 = link1_mass * link1_center_of_mass_x
    w4 = w3 * gravity_y
    w5 = link1_tip_x**2
    w6 = gravity_y * rotor1_mass
    # outputs
    c = ca.vertcat(
        rotor1_inertia,  # rotor1_inertia
        rotor2_inertia,  # rotor2_inertia
        gear1_stiffness,  # gear1_stiffness
        elbow_torque,  # elbow_torque
        shoulder_torque,  # shoulder_torque
        gear2_stiffness,  # gear2_stiffness
        link1_inertia + link1_center_of_mass_x * w3 + rotor2_mass * w5 + link2_mass * w5,  # c6
        w1 * link2_center_of_mass_x,  # c7
        link2_inertia + link2_center_of_mass_x * w2,  # c8
        w4 + w0 * gravity_y + w1 * gravity_y,  # c9
        w2 * gravity_y,  # c10
        link1_tip_x,  # link1_tip_x
        -link1_tip_x,  # c12
        link1_mass,  # link1_mass
        link1_inertia + link1_mass * link1_center_of_mass_x**2,  # c14
        rotor2_mass,  # rotor2_mass
        link2_mass,  # link2_mass
        w2,  # c17
        link2_inertia + link2_mass * link2_center_of_mass_x**2,  # c18
        w3,  # c19
        gravity_y,  # gravity_y
        rotor2_mass * gravity_y,  # c21
        link2_mass * gravity_y,  # c22
        rotor1_mass,  # rotor1_mass
        link1_mass * gravity_y,  # c24
        w6,  # c25
        -w6,  # c26
        -gear1_stiffness,  # c27
        -gear2_stiffness,  # c28
        link2_center_of_mass_x * (link2_mass * (2 * link1_tip_x)),  # c29
        link1_tip_x * w0,  # c30
        w4,  # c31
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 4 x 4) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 4) [N, N m]: condensed force S^T (Q* - M s)
    34 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    # intermediate terms (6)
    w0 = ca.sin(t * 6.283185307179586) * elbow_torque
    w1 = link2_theta - link1_theta
    w2 = ca.cos(w1) * c7
    w3 = ca.sin(w1) * c7
    w4 = ca.cos(link1_theta) * c9 + (link2_theta_dot**2 * w3 + (rotor1_theta - link1_theta) * gear1_stiffness)
    w5 = ca.cos(link2_theta) * c10 + (rotor2_theta - link2_theta) * gear2_stiffness - link1_theta_dot**2 * w3
    # outputs
    M_hat = ca.SX(4, 4)
    # link1.theta
    M_hat[0, 0] = c6
    M_hat[0, 2] = w2
    # rotor1.theta
    M_hat[1, 1] = rotor1_inertia
    # link2.theta
    M_hat[2, 0] = w2
    M_hat[2, 2] = c8
    # rotor2.theta
    M_hat[3, 3] = rotor2_inertia
    Q_hat = ca.vertcat(
        w4 - w0,  # link1.theta
        (link1_theta - rotor1_theta) * gear1_stiffness + ca.sin(t * 3.141592653589793) * shoulder_torque,  # rotor1.theta
        w5,  # link2.theta
        w0 + (link2_theta - rotor2_theta) * gear2_stiffness,  # rotor2.theta
    )
    inputs, outputs = [q_i, q_i_dot, t, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 8) [mixed]: dependent coordinates after one Newton step
    4 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link1_tip_x = c[11]
    # intermediate terms (2)
    w0 = ca.cos(link1_theta) * link1_tip_x
    w1 = ca.sin(link1_theta) * link1_tip_x
    # outputs
    q_d_next = ca.SX(8, 1)
    q_d_next[4] = w0  # link2.x
    q_d_next[5] = w1  # link2.y
    q_d_next[6] = w0  # rotor2.x
    q_d_next[7] = w1  # rotor2.y
    inputs, outputs = [q_i, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["q_i", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 8) [mixed]: rates of the dependent coordinates
    6 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link1_theta_dot = q_i_dot[0]
    link1_tip_x = c[11]
    c12 = c[12]
    # intermediate terms (2)
    w0 = link1_theta_dot * (ca.cos(link1_theta) * link1_tip_x)
    w1 = ca.sin(link1_theta) * c12 * link1_theta_dot
    # outputs
    q_d_dot = ca.SX(8, 1)
    q_d_dot[4] = w1  # link2.x
    q_d_dot[5] = w0  # link2.y
    q_d_dot[6] = w1  # rotor2.x
    q_d_dot[7] = w0  # rotor2.y
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 8) [mixed]: accelerations of the dependent coordinates
    12 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link1_theta_dot = q_i_dot[0]
    link1_theta_ddot = q_i_ddot[0]
    link1_tip_x = c[11]
    # intermediate terms (5)
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * link1_tip_x
    w2 = ca.sin(link1_theta) * link1_tip_x
    w3 = -(w0 * w1 + w2 * link1_theta_ddot)
    w4 = w1 * link1_theta_ddot - w0 * w2
    # outputs
    q_d_ddot = ca.SX(8, 1)
    q_d_ddot[4] = w3  # link2.x
    q_d_ddot[5] = w4  # link2.y
    q_d_ddot[6] = w3  # rotor2.x
    q_d_ddot[7] = w4  # rotor2.y
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 12) [mixed]: rates of all coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 8) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 8 x 12) [SI]: constraint Jacobian
    gives C_t (n_c = 8) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 8) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    16 operations.
    """
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    c = ca.SX.sym("c", 32)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_x = q[3]
    rotor1_y = q[4]
    link2_x = q[6]
    link2_y = q[7]
    rotor2_x = q[9]
    rotor2_y = q[10]
    link1_theta_dot = q_dot[2]
    link1_tip_x = c[11]
    # intermediate terms (8)
    w0 = ca.cos(link1_theta) * link1_tip_x
    w1 = link1_x + w0
    w2 = ca.sin(link1_theta) * link1_tip_x
    w3 = link1_y + w2
    w4 = -w0
    w5 = link1_theta_dot**2
    w6 = -(w0 * w5)
    w7 = -(w2 * w5)
    # outputs
    C = ca.vertcat(
        link1_x,  # joint1.x
        link1_y,  # joint1.y
        rotor1_x,  # motor1.x
        rotor1_y,  # motor1.y
        link2_x - w1,  # joint2.x
        link2_y - w3,  # joint2.y
        rotor2_x - w1,  # motor2.x
        rotor2_y - w3,  # motor2.y
    )
    C_q = ca.SX(8, 12)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # motor1.x
    C_q[2, 3] = 1.0
    # motor1.y
    C_q[3, 4] = 1.0
    # joint2.x
    C_q[4, 0] = -1.0
    C_q[4, 2] = w2
    C_q[4, 6] = 1.0
    # joint2.y
    C_q[5, 1] = -1.0
    C_q[5, 2] = w4
    C_q[5, 7] = 1.0
    # motor2.x
    C_q[6, 0] = -1.0
    C_q[6, 2] = w2
    C_q[6, 9] = 1.0
    # motor2.y
    C_q[7, 1] = -1.0
    C_q[7, 2] = w4
    C_q[7, 10] = 1.0
    C_t = ca.SX(8, 1)
    nu = ca.SX(8, 1)
    gamma = ca.SX(8, 1)
    gamma[4] = w6  # joint2.x
    gamma[5] = w7  # joint2.y
    gamma[6] = w6  # motor2.x
    gamma[7] = w7  # motor2.y
    inputs, outputs = [q, q_dot, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 12) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 12 x 12) [SI]: mass matrix in all coordinates
    gives K (n x n = 12 x 12) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 12) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 12) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 12) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 8 x 12) [SI]: constraint Jacobian
    gives gamma (n_c = 8) [m/s^2, rad/s^2]: right-hand side at acceleration level
    42 operations.
    """
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q[2]
    rotor1_theta = q[5]
    link2_theta = q[8]
    rotor2_theta = q[11]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[8]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    link1_tip_x = c[11]
    link1_mass = c[13]
    c14 = c[14]
    rotor2_mass = c[15]
    link2_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    gravity_y = c[20]
    c21 = c[21]
    c22 = c[22]
    rotor1_mass = c[23]
    c24 = c[24]
    c25 = c[25]
    # intermediate terms (26)
    w0 = ca.sin(link1_theta)
    w1 = w0 * c19
    w2 = -w1
    w3 = ca.cos(link1_theta)
    w4 = w3 * c19
    w5 = ca.sin(link2_theta) * c17
    w6 = -w5
    w7 = ca.cos(link2_theta) * c17
    w8 = link1_theta_dot**2
    w9 = w4 * w8
    w10 = w1 * w8
    w11 = link2_theta_dot**2
    w12 = w7 * w11
    w13 = w5 * w11
    w14 = (link1_theta - rotor1_theta) * gear1_stiffness
    w15 = ca.sin(t * 6.283185307179586) * elbow_torque
    w16 = w4 * gravity_y - w14 - w15
    w17 = w14 + ca.sin(t * 3.141592653589793) * shoulder_torque
    w18 = (link2_theta - rotor2_theta) * gear2_stiffness
    w19 = w7 * gravity_y - w18
    w20 = w15 + w18
    w21 = w0 * link1_tip_x
    w22 = w3 * link1_tip_x
    w23 = -w22
    w24 = -(w8 * w22)
    w25 = -(w8 * w21)
    # outputs
    M = ca.SX(12, 12)
    # link1.x
    M[0, 0] = link1_mass
    M[0, 2] = w2
    # link1.y
    M[1, 1] = link1_mass
    M[1, 2] = w4
    # link1.theta
    M[2, 0] = w2
    M[2, 1] = w4
    M[2, 2] = c14
    # rotor1.x
    M[3, 3] = rotor1_mass
    # rotor1.y
    M[4, 4] = rotor1_mass
    # rotor1.theta
    M[5, 5] = rotor1_inertia
    # link2.x
    M[6, 6] = link2_mass
    M[6, 8] = w6
    # link2.y
    M[7, 7] = link2_mass
    M[7, 8] = w7
    # link2.theta
    M[8, 6] = w6
    M[8, 7] = w7
    M[8, 8] = c18
    # rotor2.x
    M[9, 9] = rotor2_mass
    # rotor2.y
    M[10, 10] = rotor2_mass
    # rotor2.theta
    M[11, 11] = rotor2_inertia
    K = ca.SX(12, 12)
    Q_v = ca.SX(12, 1)
    Q_v[0] = w9  # link1.x
    Q_v[1] = w10  # link1.y
    Q_v[6] = w12  # link2.x
    Q_v[7] = w13  # link2.y
    Q_F = ca.vertcat(
        0.0,  # link1.x
        c24,  # link1.y
        w16,  # link1.theta
        0.0,  # rotor1.x
        c25,  # rotor1.y
        w17,  # rotor1.theta
        0.0,  # link2.x
        c22,  # link2.y
        w19,  # link2.theta
        0.0,  # rotor2.x
        c21,  # rotor2.y
        w20,  # rotor2.theta
    )
    Q_star = ca.vertcat(
        w9,  # link1.x
        w10 + c24,  # link1.y
        w16,  # link1.theta
        0.0,  # rotor1.x
        c25,  # rotor1.y
        w17,  # rotor1.theta
        w12,  # link2.x
        c22 + w13,  # link2.y
        w19,  # link2.theta
        0.0,  # rotor2.x
        c21,  # rotor2.y
        w20,  # rotor2.theta
    )
    C_q = ca.SX(8, 12)
    # joint1.x
    C_q[0, 0] = 1.0
    # joint1.y
    C_q[1, 1] = 1.0
    # motor1.x
    C_q[2, 3] = 1.0
    # motor1.y
    C_q[3, 4] = 1.0
    # joint2.x
    C_q[4, 0] = -1.0
    C_q[4, 2] = w21
    C_q[4, 6] = 1.0
    # joint2.y
    C_q[5, 1] = -1.0
    C_q[5, 2] = w23
    C_q[5, 7] = 1.0
    # motor2.x
    C_q[6, 0] = -1.0
    C_q[6, 2] = w21
    C_q[6, 9] = 1.0
    # motor2.y
    C_q[7, 1] = -1.0
    C_q[7, 2] = w23
    C_q[7, 10] = 1.0
    gamma = ca.SX(8, 1)
    gamma[4] = w24  # joint2.x
    gamma[5] = w25  # joint2.y
    gamma[6] = w24  # motor2.x
    gamma[7] = w25  # motor2.y
    inputs, outputs = [q, q_dot, t, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 12) [mixed]: rates of all coordinates
    takes q_ddot (n = 12) [mixed]: accelerations of all coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 8) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 4) [N, N m]: world force and moment of a joint on its body b, at b
    50 operations.
    """
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    q_ddot = ca.SX.sym("q_ddot", 12)
    c = ca.SX.sym("c", 32)
    link1_theta = q[2]
    link2_theta = q[8]
    link1_theta_dot = q_dot[2]
    link2_theta_dot = q_dot[8]
    link1_x_ddot = q_ddot[0]
    link1_y_ddot = q_ddot[1]
    link1_theta_ddot = q_ddot[2]
    rotor1_x_ddot = q_ddot[3]
    rotor1_y_ddot = q_ddot[4]
    link2_x_ddot = q_ddot[6]
    link2_y_ddot = q_ddot[7]
    link2_theta_ddot = q_ddot[8]
    rotor2_x_ddot = q_ddot[9]
    rotor2_y_ddot = q_ddot[10]
    link1_mass = c[13]
    rotor2_mass = c[15]
    link2_mass = c[16]
    c17 = c[17]
    c19 = c[19]
    c21 = c[21]
    c22 = c[22]
    rotor1_mass = c[23]
    c24 = c[24]
    c25 = c[25]
    # intermediate terms (14)
    w0 = link1_theta_dot**2
    w1 = ca.cos(link1_theta) * c19
    w2 = ca.sin(link1_theta) * c19
    w3 = rotor2_x_ddot * rotor2_mass
    w4 = link2_theta_dot**2
    w5 = ca.cos(link2_theta) * c17
    w6 = ca.sin(link2_theta) * c17
    w7 = w4 * w5 - (link2_x_ddot * link2_mass - w6 * link2_theta_ddot)
    w8 = w0 * w1 - (link1_x_ddot * link1_mass - w2 * link1_theta_ddot) - w3 + w7
    w9 = c21 - rotor2_y_ddot * rotor2_mass
    w10 = c22 + w4 * w6 - (link2_y_ddot * link2_mass + w5 * link2_theta_ddot)
    w11 = c24 + w0 * w2 - (link1_y_ddot * link1_mass + w1 * link1_theta_ddot) + w9 + w10
    w12 = rotor1_x_ddot * rotor1_mass
    w13 = c25 - rotor1_y_ddot * rotor1_mass
    # outputs
    lam = ca.vertcat(
        w8,  # joint1.x
        w11,  # joint1.y
        -w12,  # motor1.x
        w13,  # motor1.y
        w7,  # joint2.x
        w10,  # joint2.y
        -w3,  # motor2.x
        w9,  # motor2.y
    )
    joint_forces = ca.horzcat(
        ca.vertcat(-w8, -w11, 0.0),  # joint1
        ca.vertcat(w12, -w13, 0.0),  # motor1
        ca.vertcat(-w7, -w10, 0.0),  # joint2
        ca.vertcat(w3, -w9, 0.0),  # motor2
    )
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 12) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    89 operations.
    """
    q = ca.SX.sym("q", 12)
    q_dot = ca.SX.sym("q_dot", 12)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_y = q[4]
    rotor1_theta = q[5]
    link2_y = q[7]
    link2_theta = q[8]
    rotor2_y = q[10]
    rotor2_theta = q[11]
    link1_x_dot = q_dot[0]
    link1_y_dot = q_dot[1]
    link1_theta_dot = q_dot[2]
    rotor1_x_dot = q_dot[3]
    rotor1_y_dot = q_dot[4]
    rotor1_theta_dot = q_dot[5]
    link2_x_dot = q_dot[6]
    link2_y_dot = q_dot[7]
    link2_theta_dot = q_dot[8]
    rotor2_x_dot = q_dot[9]
    rotor2_y_dot = q_dot[10]
    rotor2_theta_dot = q_dot[11]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    link1_mass = c[13]
    c14 = c[14]
    rotor2_mass = c[15]
    link2_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    gravity_y = c[20]
    c21 = c[21]
    rotor1_mass = c[23]
    c26 = c[26]
    # intermediate terms (13)
    w0 = ca.sin(link1_theta) * c19
    w1 = ca.cos(link1_theta) * c19
    w2 = link1_x_dot * (link1_x_dot * link1_mass - w0 * link1_theta_dot) + link1_y_dot * (link1_y_dot * link1_mass + link1_theta_dot * w1)
    w3 = w2 + link1_theta_dot * (link1_y_dot * w1 - link1_x_dot * w0 + link1_theta_dot * c14) + rotor1_x_dot * (rotor1_x_dot * rotor1_mass)
    w4 = w3 + rotor1_y_dot * (rotor1_y_dot * rotor1_mass) + rotor1_theta_dot * (rotor1_theta_dot * rotor1_inertia)
    w5 = ca.sin(link2_theta) * c17
    w6 = ca.cos(link2_theta) * c17
    w7 = w4 + link2_x_dot * (link2_x_dot * link2_mass - w5 * link2_theta_dot) + link2_y_dot * (link2_y_dot * link2_mass + link2_theta_dot * w6)
    w8 = w7 + link2_theta_dot * (link2_y_dot * w6 - link2_x_dot * w5 + link2_theta_dot * c18) + rotor2_x_dot * (rotor2_x_dot * rotor2_mass)
    w9 = w8 + rotor2_y_dot * (rotor2_y_dot * rotor2_mass) + rotor2_theta_dot * (rotor2_theta_dot * rotor2_inertia)
    w10 = (link1_theta - rotor1_theta)**2 * gear1_stiffness / 2.0 + (link2_theta - rotor2_theta)**2 * gear2_stiffness / 2.0
    w11 = rotor1_theta_dot * (ca.sin(t * 3.141592653589793) * shoulder_torque) + ca.sin(t * 6.283185307179586) * elbow_torque * (rotor2_theta_dot - link1_theta_dot)
    w12 = rotor1_y * c26 - (w0 + link1_y * link1_mass + (w5 + link2_y * link2_mass)) * gravity_y - rotor2_y * c21
    # outputs
    kinetic = ca.vertcat(w9 / 2.0)
    elastic = ca.vertcat(w10)
    potential = ca.vertcat(w12)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.vertcat(w11)
    inputs, outputs = [q, q_dot, t, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def load_actions() -> ca.Function:
    """What the loads do at their markers.

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives load_actions (3 or 6 x loads = 3 x 4) [N, N m]: world force and moment of a load on its marker, or b
    10 operations.
    """
    q = ca.SX.sym("q", 12)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q[2]
    rotor1_theta = q[5]
    link2_theta = q[8]
    rotor2_theta = q[11]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    c27 = c[27]
    c28 = c[28]
    # outputs
    load_actions = ca.SX(3, 4)
    load_actions[2, 0] = (link1_theta - rotor1_theta) * c27
    load_actions[2, 1] = (link2_theta - rotor2_theta) * c28
    load_actions[2, 2] = ca.sin(t * 3.141592653589793) * shoulder_torque
    load_actions[2, 3] = ca.sin(t * 6.283185307179586) * elbow_torque
    inputs, outputs = [q, t, c], [ca.densify(load_actions)]
    return ca.Function("load_actions", inputs, outputs, ["q", "t", "c"], ["load_actions"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 12) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12 x 4) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    12 operations.
    """
    q = ca.SX.sym("q", 12)
    link1_x = q[0]
    link1_y = q[1]
    link1_theta = q[2]
    rotor1_x = q[3]
    rotor1_y = q[4]
    rotor1_theta = q[5]
    link2_x = q[6]
    link2_y = q[7]
    link2_theta = q[8]
    rotor2_x = q[9]
    rotor2_y = q[10]
    rotor2_theta = q[11]
    # intermediate terms (8)
    w0 = ca.cos(link1_theta)
    w1 = ca.sin(link1_theta)
    w2 = ca.cos(rotor1_theta)
    w3 = ca.sin(rotor1_theta)
    w4 = ca.cos(link2_theta)
    w5 = ca.sin(link2_theta)
    w6 = ca.cos(rotor2_theta)
    w7 = ca.sin(rotor2_theta)
    # outputs
    poses = ca.SX(12, 4)
    poses[0, 0] = link1_x
    poses[0, 1] = rotor1_x
    poses[0, 2] = link2_x
    poses[0, 3] = rotor2_x
    poses[1, 0] = link1_y
    poses[1, 1] = rotor1_y
    poses[1, 2] = link2_y
    poses[1, 3] = rotor2_y
    poses[3, 0] = w0
    poses[3, 1] = w2
    poses[3, 2] = w4
    poses[3, 3] = w6
    poses[4, 0] = w1
    poses[4, 1] = w3
    poses[4, 2] = w5
    poses[4, 3] = w7
    poses[6, 0] = -w1
    poses[6, 1] = -w3
    poses[6, 2] = -w5
    poses[6, 3] = -w7
    poses[7, 0] = w0
    poses[7, 1] = w2
    poses[7, 2] = w4
    poses[7, 3] = w6
    poses[11, 0] = 1.0
    poses[11, 1] = 1.0
    poses[11, 2] = 1.0
    poses[11, 3] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i, through q_d
    15 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    gear1_stiffness = c[2]
    gear2_stiffness = c[5]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c27 = c[27]
    c28 = c[28]
    # intermediate terms (3)
    w0 = ca.cos(link2_theta - link1_theta) * c7
    w1 = link2_theta_dot**2 * w0
    w2 = link1_theta_dot**2 * w0
    # outputs
    dQ_hat_dq_i = ca.SX(4, 4)
    # link1.theta
    dQ_hat_dq_i[0, 0] = c27 - ca.sin(link1_theta) * c9 - w1
    dQ_hat_dq_i[0, 1] = gear1_stiffness
    dQ_hat_dq_i[0, 2] = w1
    # rotor1.theta
    dQ_hat_dq_i[1, 0] = gear1_stiffness
    dQ_hat_dq_i[1, 1] = c27
    # link2.theta
    dQ_hat_dq_i[2, 0] = w2
    dQ_hat_dq_i[2, 2] = c28 - ca.sin(link2_theta) * c10 - w2
    dQ_hat_dq_i[2, 3] = gear2_stiffness
    # rotor2.theta
    dQ_hat_dq_i[3, 2] = gear2_stiffness
    dQ_hat_dq_i[3, 3] = c28
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    6 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    c29 = c[29]
    # intermediate terms (1)
    w0 = ca.sin(link2_theta - link1_theta) * c29
    # outputs
    dQ_hat_dq_i_dot = ca.SX(4, 4)
    # link1.theta
    dQ_hat_dq_i_dot[0, 2] = link2_theta_dot * w0
    # link2.theta
    dQ_hat_dq_i_dot[2, 0] = -(link1_theta_dot * w0)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 4 x 4) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 4 x 4) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    27 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    link2_theta = q_i[2]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    link1_theta_ddot = q_i_ddot[0]
    link2_theta_ddot = q_i_ddot[2]
    gear1_stiffness = c[2]
    gear2_stiffness = c[5]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    # intermediate terms (9)
    w0 = link2_theta - link1_theta
    w1 = ca.sin(w0)
    w2 = ca.cos(w0) * c7
    w3 = link2_theta_dot**2 * w2
    w4 = w1 * c7
    w5 = link2_theta_ddot * w4
    w6 = link1_theta_dot**2 * w2
    w7 = link1_theta_ddot * w4
    w8 = w1 * c29
    # outputs
    J_q = ca.SX(4, 4)
    # link1.theta
    J_q[0, 0] = c27 - ca.sin(link1_theta) * c9 - w3 - w5
    J_q[0, 1] = gear1_stiffness
    J_q[0, 2] = w3 + w5
    # rotor1.theta
    J_q[1, 0] = gear1_stiffness
    J_q[1, 1] = c27
    # link2.theta
    J_q[2, 0] = w6 - w7
    J_q[2, 2] = w7 - gear2_stiffness - ca.sin(link2_theta) * c10 - w6
    J_q[2, 3] = gear2_stiffness
    # rotor2.theta
    J_q[3, 2] = gear2_stiffness
    J_q[3, 3] = c28
    J_v = ca.SX(4, 4)
    # link1.theta
    J_v[0, 2] = link2_theta_dot * w8
    # link2.theta
    J_v[2, 0] = -(link1_theta_dot * w8)
    inputs, outputs = [q_i, q_i_dot, q_i_ddot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_i", "q_i_dot", "q_i_ddot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 4 x 2) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 2 x 2) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 2 x 2) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 32)
    gear1_stiffness = c[2]
    gear2_stiffness = c[5]
    # outputs
    B = ca.SX(4, 2)
    # link1.theta
    B[0, 0] = 1.0
    # rotor1.theta
    B[1, 0] = -1.0
    # link2.theta
    B[2, 1] = 1.0
    # rotor2.theta
    B[3, 1] = -1.0
    K_s = ca.SX(2, 2)
    K_s[0, 0] = gear1_stiffness
    K_s[1, 1] = gear2_stiffness
    D_s = ca.SX(2, 2)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 4) [mixed]: accelerations of the independent coordinates
    85 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    link1_tip_x = c[11]
    c14 = c[14]
    rotor2_mass = c[15]
    link2_mass = c[16]
    c17 = c[17]
    c18 = c[18]
    gravity_y = c[20]
    c21 = c[21]
    c22 = c[22]
    c30 = c[30]
    c31 = c[31]
    # intermediate terms (21)
    w0 = ca.cos(link1_theta)
    w1 = (link1_theta - rotor1_theta) * gear1_stiffness
    w2 = ca.sin(t * 6.283185307179586) * elbow_torque
    w3 = w0 * link1_tip_x
    w4 = link2_theta_dot**2
    w5 = ca.sin(link2_theta) * c17
    w6 = ca.cos(link2_theta) * c17
    w7 = w6 / c18
    w8 = (link2_theta - rotor2_theta) * gear2_stiffness
    w9 = w6 * gravity_y - w8
    w10 = link2_mass - w6 * w7
    w11 = link1_theta_dot**2
    w12 = ca.sin(link1_theta) * link1_tip_x
    w13 = w11 * w12
    w14 = w5 / c18
    w15 = w6 * w14
    w16 = w3 * w15
    w17 = w3 * w11
    w18 = link2_mass - w5 * w14
    w19 = w0 * c31 - w1 - w2 + w3 * (c22 + w4 * w5 - w7 * w9 + w10 * w13) + w16 * w17 - w12 * (w4 * w6 + w9 * w14 + w13 * w15 + w17 * w18)
    w20 = (w19 + w3 * (c21 + w13 * rotor2_mass) - w12 * (w17 * rotor2_mass)) / (c30 + (c14 + w3 * (w3 * w10) - (w12 * (w16 - w12 * w18) + w12 * w16)))
    # outputs
    q_i_ddot = ca.vertcat(
        w20,  # link1.theta
        (w1 + ca.sin(t * 3.141592653589793) * shoulder_torque) / rotor1_inertia,  # rotor1.theta
        w9 / c18 - w14 * (w17 + w12 * w20) - w7 * (w3 * w20 - w13),  # link2.theta
        (w2 + w8) / rotor2_inertia,  # rotor2.theta
    )
    inputs, outputs = [q_i, q_i_dot, t, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 4) [mixed]: rates of the independent coordinates
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 2 x 2) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 2 x 2) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 2 x 2) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 2) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 2) [N, N m]: part of Q_hat of S
    34 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    link1_theta_dot = q_i_dot[0]
    link2_theta_dot = q_i_dot[2]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    # intermediate terms (6)
    w0 = ca.sin(t * 6.283185307179586) * elbow_torque
    w1 = link2_theta - link1_theta
    w2 = ca.cos(w1) * c7
    w3 = ca.sin(w1) * c7
    w4 = ca.cos(link1_theta) * c9 + (link2_theta_dot**2 * w3 + (rotor1_theta - link1_theta) * gear1_stiffness)
    w5 = ca.cos(link2_theta) * c10 + (rotor2_theta - link2_theta) * gear2_stiffness - link1_theta_dot**2 * w3
    # outputs
    M_hat_LL = ca.vertcat(
        ca.horzcat(c6, w2),  # link1.theta
        ca.horzcat(w2, c8),  # link2.theta
    )
    M_hat_LS = ca.SX(2, 2)
    M_hat_SL = ca.SX(2, 2)
    M_hat_SS = ca.SX(2, 2)
    # rotor1.theta
    M_hat_SS[0, 0] = rotor1_inertia
    # rotor2.theta
    M_hat_SS[1, 1] = rotor2_inertia
    Q_hat_L = ca.vertcat(w4 - w0, w5)
    Q_hat_S = ca.vertcat(
        (link1_theta - rotor1_theta) * gear1_stiffness + ca.sin(t * 3.141592653589793) * shoulder_torque,  # rotor1.theta
        w0 + (link2_theta - rotor2_theta) * gear2_stiffness,  # rotor2.theta
    )
    inputs, outputs = [q_i, q_i_dot, t, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "t", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 4) [mixed]: independent coordinates, in the order of the partition
    takes t (1) [s]: time
    takes c (n_const = 32) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 2 x 2) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 2) [N, N m]: right-hand side of a sub-step, slow q'' given
    12 operations.
    """
    q_i = ca.SX.sym("q_i", 4)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 32)
    link1_theta = q_i[0]
    rotor1_theta = q_i[1]
    link2_theta = q_i[2]
    rotor2_theta = q_i[3]
    rotor1_inertia = c[0]
    rotor2_inertia = c[1]
    gear1_stiffness = c[2]
    elbow_torque = c[3]
    shoulder_torque = c[4]
    gear2_stiffness = c[5]
    # outputs
    M_hat_SS = ca.SX(2, 2)
    # rotor1.theta
    M_hat_SS[0, 0] = rotor1_inertia
    # rotor2.theta
    M_hat_SS[1, 1] = rotor2_inertia
    rhs_S = ca.vertcat(
        (link1_theta - rotor1_theta) * gear1_stiffness + ca.sin(t * 3.141592653589793) * shoulder_torque,  # rotor1.theta
        (link2_theta - rotor2_theta) * gear2_stiffness + ca.sin(t * 6.283185307179586) * elbow_torque,  # rotor2.theta
    )
    inputs, outputs = [q_i, t, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "t", "c"], ["M_hat_SS", "rhs_S"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 17) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 7) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 7) [1]: columns of the rotation matrix of the marker at a drawn point
    0 operations.
    """
    p = ca.SX.sym("p", 17)
    link1_tip_x = p[13]
    link2_tip_x = p[16]
    # outputs
    positions = ca.SX(3, 7)
    positions[0, 2] = link1_tip_x
    positions[0, 5] = link2_tip_x
    axes = ca.SX(9, 7)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
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
