"""Two coupled oscillators (L1): equations of motion, emitted by symgen from the scene `two_oscillators`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 26 operations."""
    p = ca.SX.sym("p", 6)
    x_c = p[0]
    k_L = p[1]
    w = p[2]
    zeta = p[3]
    x_M_0_0 = p[4]
    x_M_1_1 = p[5]
    w0 = w**2
    w1 = zeta * (2 * w)
    w2 = w * (2 * zeta)
    c = ca.vertcat(
        x_M_0_0,
        x_c,
        x_M_1_1,
        -k_L,
        w1,
        -w0,
        k_L,
        w0,
        -w1,
        w2,
        -w2,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 19 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q_i[0]
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    M_hat = ca.vertcat(
        c0,
        c1,
        c1,
        c2,
    )
    M_hat = ca.reshape(M_hat, 2, 2)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        x_L * c3,
        x_S * c5 - x_S_dot * c4,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat", "Q_hat"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 29 operations."""
    q = ca.SX.sym("q", 2)
    q_dot = ca.SX.sym("q_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q[0]
    x_S = q[1]
    x_S_dot = q_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    w0 = x_S_dot * c8
    M = ca.vertcat(
        c0,
        c1,
        c1,
        c2,
    )
    M = ca.reshape(M, 2, 2)
    M = ca.densify(M)
    K = ca.vertcat(
        c6,
        0.0,
        0.0,
        c7,
    )
    K = ca.reshape(K, 2, 2)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        0.0,
        0.0,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        w0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        x_L * c3,
        w0 - x_S * c7,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, c], [M, K, Q_v, Q_F, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "c"], ["M", "K", "Q_v", "Q_F", "Q_star"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 36 operations."""
    q = ca.SX.sym("q", 2)
    q_dot = ca.SX.sym("q_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q[0]
    x_S = q[1]
    x_L_dot = q_dot[0]
    x_S_dot = q_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c6 = c[6]
    c7 = c[7]
    c9 = c[9]
    kinetic = ca.vertcat(
        (x_L_dot * (x_L_dot * c0 + x_S_dot * c1) + x_S_dot * (x_L_dot * c1 + x_S_dot * c2)) / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        x_L * (x_L * c6) / 2.0 + x_S * (x_S * c7) / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        0.0,
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        x_S_dot * (x_S_dot * c9),
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 7 operations."""
    c = ca.SX.sym("c", 11)
    c3 = c[3]
    c5 = c[5]
    dQ_hat_dq_i = ca.vertcat(
        c3,
        0.0,
        0.0,
        c5,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 2, 2)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 6 operations."""
    c = ca.SX.sym("c", 11)
    c10 = c[10]
    dQ_hat_dq_i_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        c10,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 2, 2)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 5 operations."""
    dMa_dq_i = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 2, 2)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, [], ["dMa_dq_i"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 19 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    c = ca.SX.sym("c", 11)
    x_L = q_i[0]
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    M_hat_LL = ca.vertcat(
        c0,
    )
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        c1,
    )
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        c1,
    )
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c2,
    )
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        x_L * c3,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        x_S * c5 - x_S_dot * c4,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_i_dot, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 14 operations."""
    q_i = ca.SX.sym("q_i", 2)
    q_i_dot = ca.SX.sym("q_i_dot", 2)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 11)
    x_S = q_i[1]
    x_S_dot = q_i_dot[1]
    x_L_ddot = q_L_ddot[0]
    c1 = c[1]
    c2 = c[2]
    c4 = c[4]
    c5 = c[5]
    M_hat_SS = ca.vertcat(
        c2,
    )
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        x_S * c5 - x_S_dot * c4 - x_L_ddot * c1,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_i_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_i_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "augmented": augmented,
    "energy": energy,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "blocks": blocks,
    "substep_2": substep_2,
}
