"""Step (8) of Fig. 5: the sub-steps j = 2 ... m of the fast coordinates, Eqs. (58)-(67).

At a sub-step the slow coordinates are between their own steps. Their values there, (59)-(63), are readings of the paper
in slow_interpolation.py; with them (58) and (62) are (64),

    M_hat_SS q_S_ddot = Q_hat_S - M_hat_SL q_L_ddot,

the matrices being evaluated where (65)-(67) say: at the sub-step's own time, with the interpolated slow values.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.engine.program import Fields
from runtime.schemes.grid import Grid
from runtime.schemes.slow_interpolation import Interpolation
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations


@dataclass(frozen=True)
class Known:
    """What is known at the time of an update, n_i each: q_i, its rates (d / h of the fast ones) and accelerations."""

    q: ca.SX
    half: ca.SX
    q_ddot: ca.SX


def at_sub_step(z: Fields, h: ca.SX, known: Known, grid: Grid, level: int, interpolate: Interpolation) -> Known:
    """The values at a sub-step: slow coordinates by (59) and a reading of (60)-(61), (63), fast ones as known.

    z: fields q_L, q_L_dot, q_L_ddot (at the start of the running step of each group), t_L (when that was) and s (time
    since the start of the major step [s]). h: steps of the groups [s]. level: the first group that takes the sub-step.
    """
    q, v, a = ca.SX(known.q), ca.SX(known.half), ca.SX(known.q_ddot)
    for g in range(level):
        s = z["s"] - z["t_L"][g] if g else z["s"]  # the slowest group's step is the major step
        for k in grid.groups[g]:
            q[k], v[k] = interpolate(z["q_L"][k], z["q_L_dot"][k], z["q_L_ddot"][k], s, h[level], h[g], z["x"][k])
            a[k] = z["q_L_ddot"][k]  # (59)
    return Known(q, v, a)


def rows(
    equations: StageEquations, level: int, motion: ClosedConfiguration, q_i_dot: ca.SX, q_L_ddot: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """(M_hat_SS, Q_hat_S - M_hat_SL q_L_ddot) of (58), (62), (64), evaluated as (65)-(67) say.

    For a linear structure that is (12), and (14) with the readings of (13).

    level: the first group of S, 0 the slowest. q_i_dot: n_i, q_L_ddot: n_L, known. Result: n_S x n_S and n_S [SI].
    """
    return equations.substep(level, motion, q_i_dot, q_L_ddot)
