"""Stiff deflections s = B^T q_i of a model, and what it does at a state when forces act along them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from runtime.schemes.sparse_lu import Number, factor, solve


@dataclass(frozen=True)
class StiffDeflections:
    """s = B^T q_i (B n_i x n_s, constant) with stiffness K and damping D, n_s x n_s [SI]."""

    B: ca.SX
    K: ca.SX
    D: ca.SX

    def force(self, q_i: ca.SX, q_i_dot: ca.SX) -> ca.SX:
        """K s + D s' of positions and rates, or of changes of them (n_i)."""
        return ca.mtimes(self.K, ca.mtimes(self.B.T, q_i)) + ca.mtimes(self.D, ca.mtimes(self.B.T, q_i_dot))


@dataclass(frozen=True)
class StiffResponse(StiffDeflections):
    """And q_i_ddot = a (n_i) at a state, and X = M_hat^-1 B (n_i x n_s) there."""

    a: ca.SX
    X: ca.SX

    @cached_property
    def Lambda(self) -> ca.SX:
        """B^T X (n_s x n_s)."""
        return ca.mtimes(self.B.T, self.X)

    def along(self, change: ca.SX) -> ca.SX:
        """X Lambda^-1 change: what q_i does when the deflections change so and nothing else is pushed; n_s x any."""
        factors = factor(Number(self.Lambda), symmetric=True)
        columns = [solve(factors, Number(ca.densify(column))).re for column in ca.horzsplit(change)]
        return ca.mtimes(self.X, ca.horzcat(*columns))
