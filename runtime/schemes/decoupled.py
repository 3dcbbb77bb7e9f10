"""Inertially decoupled sub-steps: y = q_L + M_LL^-1 M_LS q_S moves with M_LL^-1 Q_L, renewed each major step.

The sub-steps evaluate the rows of q_S only: (M_SS - M_SL N) a_S = Q_S - M_SL y_ddot, N = M_LL^-1 M_LS, and q_L follows
from a_L = y_ddot - N a_S. So Q_L must not change much with q_S inside a major step.
"""

from __future__ import annotations

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields
from runtime.schemes.grid import Grid
from runtime.schemes.held_slow import HeldSlow
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.options import ClosureOptions, SchemeError
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, work


class Decoupled(HeldSlow):
    """Two groups."""

    def __init__(self, model: Model, grid: Grid, options: ClosureOptions) -> None:
        if len(grid.groups) > 2:
            raise SchemeError(f"decoupled works on two groups, not {len(grid.groups)}; use coupled")
        super().__init__(model, grid, options)

    def further_fields(self) -> dict[str, StateField]:
        """And N, column by column, and y_ddot."""
        slow = len(self.slow)
        return {**super().further_fields(), "N": work(slow * (len(self.model.q_i) - slow)), "y_ddot": work(slow)}

    def renewed(self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> dict[str, ca.SX]:
        """N and y_ddot at the state ahead."""
        L, S = self.slow, self.fast
        if not L:
            return {}
        M_hat, Q_hat = equations.condensed(motion, v)
        columns = [solve_symmetric(M_hat[L, L], M_hat[L, k]) for k in S]
        return {"N": ca.vertcat(*columns), "y_ddot": solve_symmetric(M_hat[L, L], Q_hat[L])}

    def accelerations(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """The rows of q_S, then q_L."""
        L, S = self.slow, self.fast
        M_hat, Q_hat = equations.condensed(motion, v)
        if not L:
            return solve_symmetric(M_hat, Q_hat)
        N = ca.reshape(z["N"], len(L), len(S))
        M_SL = M_hat[S, L]
        a_S = solve_symmetric(M_hat[S, S] - ca.mtimes(M_SL, N), Q_hat[S] - ca.mtimes(M_SL, z["y_ddot"]))
        a_L, a = z["y_ddot"] - ca.mtimes(N, a_S), ca.SX(len(self.model.q_i), 1)
        for part, members in ((a_L, L), (a_S, S)):
            for position, k in enumerate(members):
                a[k] = part[position]
        return a
