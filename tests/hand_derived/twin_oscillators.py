"""Case L1: two coupled oscillators and the exact amplification matrices of two schemes.

Model: M = [[1, c], [c, 1]], K = diag(k_L, w^2), damping 2 zeta w on S only:
    row L: q_L'' + c q_S'' + k_L q_L = 0,   row S: c q_L'' + q_S'' + 2 zeta w q_S' + w^2 q_S = 0.
Coupled frequency (k_L = 0): w_c = w / sqrt(1 - c^2).

State of both schemes: s(t) = (q_L(t - dt_L), q_L(t), q_S(t - dt_S), q_S(t)).
Differences (Eqs. 40-43): q'' = (q_next - 2 q + q_prev)/dt^2, q' = (q_next - q_prev)/(2 dt),
each group with its own step.
Damping: the velocity at the time of the force is the central one of Eq. 43, (q_S_next - q_S_prev)/(2 dt_S);
q_S_next is solved from the row in which it stands (implicitly, second-order accurate), in the common update
and in every sub-step alike.

Single rate: the unknowns (x, y) = (q_L_next, q_S_next) solve
    (x - 2 q_L + q_L_prev)/dt^2 + c (y - 2 q_S + q_S_prev)/dt^2 + k_L q_L = 0
    c (x - 2 q_L + q_L_prev)/dt^2 + (y - 2 q_S + q_S_prev)/dt^2 + zeta w (y - q_S_prev)/dt + w^2 q_S = 0.

Printed sub-cycling, dt_L = m dt_S:
  common update (Eqs. 44-57, at its fixed point, which is the solution of Eq. 39): the same two rows, with
  dt_L in the differences of q_L and dt_S in those of q_S; it gives q_L(t + dt_L) and q_S(t + dt_S).
  sub-steps j = 2..m (Eqs. 58-64), only the S row, with
  q_L'' = (q_L(t + dt_L) - 2 q_L(t) + q_L(t - dt_L))/dt_L^2 frozen:
    c q_L'' + (y - 2 q_S + q_S_prev)/dt_S^2 + zeta w (y - q_S_prev)/dt_S + w^2 q_S = 0.
  q_L enters the S row through c q_L'' only: K and D are diagonal, so the interpolation of q_L (Eqs. 60, 63)
  plays no part here.

Growth law (docs/theory/schemes.md; k_L = zeta = 0, w_c dt_L small): a frozen q_L'' lags by (m - 1) dt_S / 2 on
average, which is negative damping; the amplitude grows like exp(sigma t) with
sigma = 1/4 c^2 (1 - 1/m) w_c^2 dt_L.

Each matrix is built column by column: the scheme is linear, so its action on the unit states is its matrix.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True)
class Params:
    """c dimensionless (|c| < 1), w rad/s, k_L 1/s^2, zeta dimensionless."""

    c: float = 0.5
    w: float = 1.0
    k_L: float = 0.0
    zeta: float = 0.0


def _common(p: Params, state: Array, dt_L: float, dt_S: float) -> tuple[Array, Array]:
    """(q_L_next, q_S_next) from both rows, for each column of `state` (4, n)."""
    q_L_prev, q_L, q_S_prev, q_S = state
    lead = np.array(
        [
            [1 / dt_L**2, p.c / dt_S**2],
            [p.c / dt_L**2, 1 / dt_S**2 + p.zeta * p.w / dt_S],
        ]
    )
    known_L, known_S = (2 * q_L - q_L_prev) / dt_L**2, (2 * q_S - q_S_prev) / dt_S**2
    row_L = known_L + p.c * known_S - p.k_L * q_L
    row_S = p.c * known_L + known_S + p.zeta * p.w * q_S_prev / dt_S - p.w**2 * q_S
    solution = np.linalg.solve(lead, np.array([row_L, row_S]))
    return solution[0], solution[1]


def central_difference_matrix(params: Params, dt: float) -> Array:
    """Amplification matrix (4, 4) of one single-rate step dt on s(t) (dt_L = dt_S = dt)."""
    state = np.eye(4)
    q_L_next, q_S_next = _common(params, state, dt, dt)
    return np.array([state[1], q_L_next, state[3], q_S_next])


def printed_subcycling_matrix(params: Params, dt_S: float, m: int) -> Array:
    """Amplification matrix (4, 4) of one major step dt_L = m dt_S of the printed scheme on s(t)."""
    p, dt_L, state = params, m * dt_S, np.eye(4)
    q_L_next, q_S_next = _common(p, state, dt_L, dt_S)
    q_L_ddot = (q_L_next - 2 * state[1] + state[0]) / dt_L**2
    q_S_prev, q_S = state[3], q_S_next
    for _ in range(2, m + 1):
        damped = p.zeta * p.w * dt_S
        force = -(p.w**2) * q_S - p.c * q_L_ddot
        q_S_next = (2 * q_S - (1 - damped) * q_S_prev + dt_S**2 * force) / (1 + damped)
        q_S_prev, q_S = q_S, q_S_next
    return np.array([state[1], q_L_next, q_S_prev, q_S])


def growth_rate(matrix: Array, step: float) -> float:
    """Exact exponential rate (1/s): log of the spectral radius over the step."""
    return float(np.log(np.max(np.abs(np.linalg.eigvals(matrix)))) / step)


def growth_rate_law(c: float, w: float, m: int, dt_L: float) -> float:
    """sigma = 1/4 c^2 (1 - 1/m) w_c^2 dt_L (docs/theory/schemes.md), leading order in w_c dt_L."""
    return 0.25 * c**2 * (1 - 1 / m) * w**2 / (1 - c**2) * dt_L


def stabilising_damping_law(c: float, w: float, m: int, dt_L: float) -> float:
    """Least zeta (of 2 zeta w on row S) that stabilises the printed scheme: 1/4 c^2 (1 - 1/m) w dt_L.

    Leading order, k_L = 0. Row L gives q_L'' = -c q_S'', so (1 - c^2) q_S'' + 2 zeta w q_S' + w^2 q_S = 0
    decays at zeta w / (1 - c^2); setting this equal to the growth rate gives the law. The damping ratio of
    the coupled mode is zeta w_c / w; for it the law reads 1/4 c^2 (1 - 1/m) w_c dt_L, the form often quoted.
    """
    return 0.25 * c**2 * (1 - 1 / m) * w * dt_L
