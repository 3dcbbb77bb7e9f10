"""Two coupled oscillators (L1): equations of motion, emitted by symgen from the scene `two_oscillators`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 x_L [m], 1 x_S [m]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 6) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    9 operations.
    """
    p = ca.SX.sym("p", 6)
    x_c = p[0]
    k_L = p[1]
    w = p[2]
    zeta = p[3]
    x_M_0_0 = p[4]
    x_M_1_1 = p[5]
    # intermediate terms (3)
    w0 = w**2
    w1 = zeta * (2 * w)
    w2 = w * (2 * zeta)
    # outputs
    c = ca.vertcat(
        x_M_0_0,  # x_M_0_0
        x_c,  # x_c
        x_M_1_1,  # x_M_1_1
        -k_L,  # c3
        w1,  # c4
        -w0,  # c5
        k_L,  # k_L
        w0,  # c7
        -w1,  # c8
        w2,  # c9
        -w2,  # c10
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 2 x 2) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 2) [N, N m]: condensed force S^T (Q* - M s)
    4 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q_i[0]
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    x_M_0_0 = c[0]
    x_c = c[1]
    x_M_1_1 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    # outputs
    M_hat = ca.vertcat(
        ca.horzcat(x_M_0_0, x_c),  # x_L
        ca.horzcat(x_c, x_M_1_1),  # x_S
    )
    Q_hat = ca.vertcat(x_L * c3, x_S * c5 - x_S_dot * c4)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 2) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 2) [mixed]: rates of all coordinates
    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 2 x 2) [SI]: mass matrix in all coordinates
    gives K (n x n = 2 x 2) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 2) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 2) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 2) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    4 operations.
    """
    q = ca.SX.sym("q", 2)
    q_dot = ca.SX.sym("q_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q[0]
    x_S = q[1]
    x_S_dot = q_dot[1]
    x_M_0_0 = c[0]
    x_c = c[1]
    x_M_1_1 = c[2]
    c3 = c[3]
    k_L = c[6]
    c7 = c[7]
    c8 = c[8]
    # intermediate terms (1)
    w0 = x_S_dot * c8
    # outputs
    M = ca.vertcat(
        ca.horzcat(x_M_0_0, x_c),  # x_L
        ca.horzcat(x_c, x_M_1_1),  # x_S
    )
    K = ca.SX(2, 2)
    # x_L
    K[0, 0] = k_L
    # x_S
    K[1, 1] = c7
    Q_v = ca.SX(2, 1)
    Q_F = ca.vertcat(0.0, w0)
    Q_star = ca.vertcat(x_L * c3, w0 - x_S * c7)
    inputs, outputs = [q, q_dot, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 2) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 2) [mixed]: rates of all coordinates
    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    19 operations.
    """
    q = ca.SX.sym("q", 2)
    q_dot = ca.SX.sym("q_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q[0]
    x_S = q[1]
    x_L_dot = q_dot[0]
    x_S_dot = q_dot[1]
    x_M_0_0 = c[0]
    x_c = c[1]
    x_M_1_1 = c[2]
    k_L = c[6]
    c7 = c[7]
    c9 = c[9]
    # intermediate terms (1)
    w0 = (x_L_dot * (x_L_dot * x_M_0_0 + x_S_dot * x_c) + x_S_dot * (x_L_dot * x_c + x_S_dot * x_M_1_1)) / 2.0
    # outputs
    kinetic = ca.vertcat(w0)
    elastic = ca.vertcat(x_L * (x_L * k_L) / 2.0 + x_S * (x_S * c7) / 2.0)
    potential = ca.SX(1, 1)
    power_dissipated = ca.vertcat(x_S_dot * (x_S_dot * c9))
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i, through q_d
    0 operations.
    """
    c = ca.SX.sym("c", 11)
    c3 = c[3]
    c5 = c[5]
    # outputs
    dQ_hat_dq_i = ca.SX(2, 2)
    # x_L
    dQ_hat_dq_i[0, 0] = c3
    # x_S
    dQ_hat_dq_i[1, 1] = c5
    inputs, outputs = [c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i_dot (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    0 operations.
    """
    c = ca.SX.sym("c", 11)
    c10 = c[10]
    # outputs
    dQ_hat_dq_i_dot = ca.SX(2, 2)
    # x_S
    dQ_hat_dq_i_dot[1, 1] = c10
    inputs, outputs = [c], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["c"], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 2 x 2) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 2 x 2) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    0 operations.
    """
    c = ca.SX.sym("c", 11)
    c3 = c[3]
    c5 = c[5]
    c10 = c[10]
    # outputs
    J_q = ca.SX(2, 2)
    # x_L
    J_q[0, 0] = c3
    # x_S
    J_q[1, 1] = c5
    J_v = ca.SX(2, 2)
    # x_S
    J_v[1, 1] = c10
    inputs, outputs = [c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 2 x 2) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 2 x 2) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 2 x 2) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 11)
    k_L = c[6]
    c7 = c[7]
    c9 = c[9]
    # outputs
    B = ca.SX(2, 2)
    # x_L
    B[0, 0] = 1.0
    # x_S
    B[1, 1] = 1.0
    K_s = ca.SX(2, 2)
    K_s[0, 0] = k_L
    K_s[1, 1] = c7
    D_s = ca.SX(2, 2)
    D_s[1, 1] = c9
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_LL (n_L x n_L = 1) [SI]: block of M_hat, rows of L, columns of L
    gives M_hat_LS (n_L x n_S = 1) [SI]: block of M_hat, rows of L, columns of S
    gives M_hat_SL (n_S x n_L = 1) [SI]: block of M_hat, rows of S, columns of L
    gives M_hat_SS (n_S x n_S = 1) [SI]: block of M_hat, rows of S, columns of S
    gives Q_hat_L (n_L = 1) [N, N m]: part of Q_hat of L
    gives Q_hat_S (n_S = 1) [N, N m]: part of Q_hat of S
    4 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q_i[0]
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    x_M_0_0 = c[0]
    x_c = c[1]
    x_M_1_1 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    # outputs
    M_hat_LL = ca.vertcat(x_M_0_0)
    M_hat_LS = ca.vertcat(x_c)
    M_hat_SL = ca.vertcat(x_c)
    M_hat_SS = ca.vertcat(x_M_1_1)
    Q_hat_L = ca.vertcat(x_L * c3)
    Q_hat_S = ca.vertcat(x_S * c5 - x_S_dot * c4)
    inputs, outputs = [q_i, q_i_dot, c], [ca.densify(M_hat_LL), ca.densify(M_hat_LS), ca.densify(M_hat_SL), ca.densify(M_hat_SS), ca.densify(Q_hat_L), ca.densify(Q_hat_S)]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64).

    takes q_i (n_i = 2) [mixed]: independent coordinates, in the order of the partition
    takes q_i_dot (n_i = 2) [mixed]: rates of the independent coordinates
    takes q_L_ddot (n_L = 1) [mixed]: accelerations of the slower groups, frozen over their step
    takes c (n_const = 11) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat_SS (n_S x n_S = 1) [SI]: block of M_hat of the groups that take a sub-step
    gives rhs_S (n_S = 1) [N, N m]: right-hand side of a sub-step, slow q'' given
    5 operations.
    """
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 11)
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    x_L_ddot = q_L_ddot[0]
    x_c = c[1]
    x_M_1_1 = c[2]
    c4 = c[4]
    c5 = c[5]
    # outputs
    M_hat_SS = ca.vertcat(x_M_1_1)
    rhs_S = ca.vertcat(x_S * c5 - x_S_dot * c4 - x_L_ddot * x_c)
    inputs, outputs = [q_i, q_i_dot, q_L_ddot, c], [ca.densify(M_hat_SS), ca.densify(rhs_S)]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_i_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "augmented": augmented,
    "energy": energy,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "blocks": blocks,
    "substep_2": substep_2,
}
