"""Step (7) of Fig. 5: the common update of all groups at time t, Eqs. (44)-(57).

Unknown is q_i_ddot(t) instead of q_i(t + h); by (40), (42) that is the same. So (44)-(45) read

    M_hat_LL q_L_ddot + M_hat_LS q_S_ddot = Q_hat_L,    M_hat_SL q_L_ddot + M_hat_SS q_S_ddot = Q_hat_S,

which is (39). The paper solves it by a sweep between the groups, (46)-(57); `solved_at_once` and `newton_step` give
what the sweep converges to. Vectors are n_i long [m/s^2 or rad/s^2] unless something else is said.
"""

from __future__ import annotations

import casadi as ca

from runtime.schemes.linear_solve import solve_general, solve_symmetric
from runtime.schemes.rounding import ROUNDING

STALLED = 16  # a sweep wanders about by so many roundings of its terms


def starting_guess(reading: str, d: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """What the sweep starts from, as an acceleration.

    `previous`: q(t + h) = q(t), (48)-(49), is q_ddot = -d / h^2. `taylor`: q(t + h) by (50)-(51) from q, q_dot and the
    last q_ddot. d: last increment [m or rad]; h: step of each coordinate [s].
    """
    return q_ddot if reading == "taylor" else -d / h**2


def sweep(M_hat: ca.SX, Q_hat: ca.SX, q_ddot: ca.SX, groups: list[list[int]]) -> ca.SX:
    """One sweep of (46)-(47): each group from the last iterate of the others, (52)-(53).

    The difference to q_ddot, times h^2, is the increment of the iterate, (54)-(55). M_hat: n_i x n_i, Q_hat: n_i [SI];
    groups: positions in q_i, slow to fast.
    """
    new = ca.SX(q_ddot)
    for group in groups:
        others = [k for k in range(q_ddot.numel()) if k not in group]
        force = Q_hat[group] - ca.mtimes(M_hat[group, others], q_ddot[others]) if others else Q_hat
        solved = solve_symmetric(M_hat[group, group], force)
        for position, k in enumerate(group):
            new[k] = solved[position]
    return new


def allowed_change(new: ca.SX, d: ca.SX, h: ca.SX, eps: float, stopping: str) -> ca.SX:
    """The change of q_ddot of a group by a sweep below which (56) or (57) stops; h^2 times it is that of q(t + h).

    new, d: the group's accelerations and last increments; h: its step [s]. stopping: `absolute` compares
    |q(t + h)_new - q(t + h)_old| with eps [m or rad] as printed, `relative` with eps h^2 |q_ddot|.
    """
    if stopping == "relative":
        # rounding of the increment d is below what a position can show
        return eps * ca.norm_inf(new) + ROUNDING / h**2 * ca.norm_inf(d)
    return ca.SX(eps / h**2)


def rounding_of_sweep(M_hat: ca.SX, q_ddot: ca.SX, q: ca.SX, h: ca.SX, group: list[int]) -> ca.SX:
    """What rounding of the coupling in (46)-(47), and of the positions, can leave of q_ddot of a group.

    A group whose accelerations pass through zero while the others' do not never meets a test relative to its own; once
    its change no longer falls and is below this, the sweep has arrived. q: n_i; h: the group's step [s].
    """
    others = [k for k in range(q_ddot.numel()) if k not in group]
    seen = ca.norm_inf(q[group]) / h**2
    if others:
        seen = seen + ca.norm_inf(ca.mtimes(M_hat[group, others], q_ddot[others]) / ca.diag(M_hat[group, group]))
    return STALLED * ROUNDING * seen


def solved_at_once(M_hat: ca.SX, force: ca.SX) -> ca.SX:
    """q_ddot of (44)-(45), forces known: the limit of the sweep. M_hat: n x n, force: n [SI].

    Without inertia coupling that is (10)-(11), and for one group (39) itself.
    """
    return solve_symmetric(M_hat, force)


def newton_step(M_hat: ca.SX, force: ca.SX, J: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """q_ddot of (44)-(45) with the force at q_dot of (41), (43), which depends on q_ddot; one Newton step.

        (M_hat - J diag(h / 2)) q_ddot_new = Q_hat - J diag(h / 2) q_ddot,    J = dQ_hat/dq_i_dot

    M_hat, J: n x n, force: Q_hat at the last iterate, n [SI]; q_ddot: the last iterate, n; h: n [s].
    """
    half = ca.diag(h / 2)
    return solve_general(M_hat - ca.mtimes(J, half), force - ca.mtimes(J, ca.mtimes(half, q_ddot)))
