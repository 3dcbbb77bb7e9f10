"""Jacobians of closed loops with the multipliers held: S is never differentiated.

With rho = Q* - M a - C_q^T lambda, where a are accelerations that satisfy the constraints and lambda makes the rows of
the dependent coordinates vanish, Q_hat - M_hat a = S^T rho, and

    d(S^T rho) = S^T d(rho) at fixed lambda,

because dS has rows of dependent coordinates only. The rates and accelerations of these change with q and q' as the
constraints of first and second order say, U dw_d = -d(C_q w - nu) and U da_d = -d(C_q a - gamma), with
the U that gave S.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, mul, sub, total
from symgen.condensed.condensation import Condensed
from symgen.condensed.loops import solve_forward, solve_transposed

if TYPE_CHECKING:
    from symgen.kernels.arguments import Arguments


def loops_alone(system: Condensed) -> bool:
    """Do closed loops give all dependent coordinates that have masses, but for those that a motion prescribes?"""
    loops = system.choice.loop_columns
    return bool(loops) and all(s.column in loops or not s.e for s in system.inner)


def held_jacobians(system: Condensed, a: Arguments) -> tuple[ca.SX, ca.SX]:
    """(J_q, J_v): total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot."""
    rows, loops = system.loops, system.choice.loop_columns
    independent, eq = system.choice.independent, system.reduced
    lam = {row: ca.SX.sym(f"lam_{row}") for row in rows.rows}
    given = {column: a.q_i_ddot[k] for k, column in enumerate(independent)}
    known = system.accelerations(given)
    a_d = {column: ca.SX.sym(f"a_{column}") for column in loops}
    force = eq.force({**{c: value for c, value in known.items() if c not in eq.placed_columns}, **a_d})
    columns = [*independent, *loops]
    rho = ca.vertcat(
        *(sub(force[c], total(mul(row.entries.get(c, ZERO), lam[k]) for k, row in rows.rows.items())) for c in columns)
    )
    rates = {c: eq.q_dot[c] for c in columns}
    first = [sub(_along(row.entries, rates), row.nu) for row in rows.rows.values()]
    second = [sub(_along(row.entries, {**given, **a_d}), row.gamma) for row in rows.rows.values()]
    found = _Derivatives(system, a, rho, ca.vertcat(*first), ca.vertcat(*second), ca.vertcat(*a_d.values())).both()
    values = solve_transposed(rows.blocks, rows.entries(), {c: force[c] for c in loops})
    multipliers = [ca.vertcat(*lam.values()), ca.vertcat(*(values[k] for k in lam))]
    accelerations = [ca.vertcat(*a_d.values()), ca.vertcat(*(known.get(c, ZERO) for c in a_d))]
    J_q, J_v = ca.substitute(list(found), [multipliers[0]], [multipliers[1]])
    J_q, J_v = ca.substitute([J_q, J_v], [accelerations[0]], [accelerations[1]])
    return J_q, J_v


def _along(entries: Row, values: Row) -> ca.SX:
    result = ZERO
    for column, value in entries.items():
        if column in values:
            result = add(result, mul(value, values[column]))
    return result


@dataclass(frozen=True)
class _Derivatives:
    """rho (rows of q_i, then of the loop unknowns), and the constraints' first and second rates, by all they hold."""

    system: Condensed
    a: Arguments
    rho: ca.SX
    first: ca.SX
    second: ca.SX
    a_d: ca.SX

    def both(self) -> tuple[ca.SX, ca.SX]:
        """By q_i and by q_i_dot."""
        eq, loops = self.system.reduced, self.system.choice.loop_columns
        q_d, w_d = (ca.vertcat(*(source[c] for c in loops)) for source in (eq.q, eq.q_dot))
        B = self._tangents()

        def by(value: ca.SX, own: ca.SX, following: ca.SX) -> ca.SX:
            return ca.jacobian(value, own) + _product(ca.jacobian(value, following), B)

        W_q = self._solved(by(self.first, self.a.q_i, q_d))
        A_q = self._solved(by(self.second, self.a.q_i, q_d) + _product(ca.jacobian(self.second, w_d), W_q))
        A_v = self._solved(by(self.second, self.a.q_i_dot, w_d))
        through_w, through_a = ca.jacobian(self.rho, w_d), ca.jacobian(self.rho, self.a_d)
        by_q = by(self.rho, self.a.q_i, q_d) + _product(through_w, W_q) + _product(through_a, A_q)
        by_v = by(self.rho, self.a.q_i_dot, w_d) + _product(through_a, A_v)
        n = self.a.q_i.numel()
        return tuple(value[:n, :] + _product(B.T, value[n:, :]) for value in (by_q, by_v))  # type: ignore[return-value]

    def _tangents(self) -> ca.SX:
        choice = self.system.choice
        moved = [self.system.tangent({column: ca.SX(1)}) for column in choice.independent]
        return ca.horzcat(*(ca.vertcat(*(one.get(c, ZERO) for c in choice.loop_columns)) for one in moved))

    def _solved(self, change: ca.SX) -> ca.SX:
        """-U^-1 of the changes of the loop rows, column by column."""
        loops = self.system.loops
        sides = [{row: -change[k, j] + 0 for k, row in enumerate(loops.rows)} for j in range(change.shape[1])]
        solved, _ = solve_forward(loops.blocks, loops.entries(), sides)
        columns = self.system.choice.loop_columns
        return ca.horzcat(*(ca.vertcat(*(one[c] for c in columns)) for one in solved))


def _product(left: ca.SX, right: ca.SX) -> ca.SX:
    return ca.mtimes(ca.sparsify(left), ca.sparsify(right))
