"""Coupled sub-steps: the whole condensed system is solved in each, with the slow coordinates held.

The solution eliminates q_L: (M_SS - M_SL M_LL^-1 M_LS) a_S = Q_S - M_SL M_LL^-1 Q_L, a_L = M_LL^-1 (Q_L - M_LS a_S);
on large trees the elimination is that of the tree, in O(N).
"""

from __future__ import annotations

import casadi as ca

from runtime.engine.program import Fields
from runtime.schemes.held_slow import HeldSlow
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations


class Coupled(HeldSlow):
    """Schur complement in every sub-step."""

    def accelerations(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """All accelerations from M_hat and Q_hat of this sub-step."""
        if equations.tree_is_shorter:
            return equations.tree_accelerations(motion, v)
        M_hat, Q_hat = equations.condensed(motion, v)
        order = [*self.fast, *self.slow]  # the last are eliminated first: q_L
        solved = solve_symmetric(M_hat[order, order], Q_hat[order])
        a = ca.SX(len(order), 1)
        for position, k in enumerate(order):
            a[k] = solved[position]
        return a
