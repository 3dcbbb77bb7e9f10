"""Step (6) of Fig. 5: start-up, Eqs. (68)-(71)."""

from __future__ import annotations

import casadi as ca

from runtime.schemes.linear_solve import solve_symmetric


def initial_acceleration(M_hat: ca.SX, Q_hat: ca.SX) -> ca.SX:
    """q_i_ddot = M_hat^-1 Q_hat (68), of the state that a motion starts from.

    M_hat: n_i x n_i, Q_hat: n_i [SI]. Result: n_i [m/s^2 or rad/s^2].
    """
    return solve_symmetric(M_hat, Q_hat)


def initial_increment(q_i_dot: ca.SX, q_i_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """d = q_i(t) - q_i(t - h) = h q_i_dot - h^2 / 2 q_i_ddot: (69), each group with its own step as (70), (71) say.

    q_i_dot, q_i_ddot: n_i; h: n_i [s], the step of each coordinate. Result: n_i [m or rad].
    """
    return h * q_i_dot - h**2 / 2 * q_i_ddot
