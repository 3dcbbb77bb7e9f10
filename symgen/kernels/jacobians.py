"""Total Jacobians of the condensed equations, through q_d = f(q_i, t) and q_d_dot = f'(q_i, q_i_dot, t)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import casadi as ca

from symgen.algebra.scalar import length
from symgen.condensed.condensation import Condensed
from symgen.kernels.held_multipliers import held_jacobians, loops_alone
from symgen.kernels.kernel import Kernel

if TYPE_CHECKING:
    from symgen.kernels.arguments import Arguments

SMALL_SYSTEM = 8  # independent coordinates up to which two forms of a Jacobian are compared


def jacobian_kernels(system: Condensed, a: Arguments) -> dict[str, Callable[[], Kernel]]:
    """Builders of dQ_hat/dq_i, dQ_hat/dq_i_dot, and both of Q_hat - M_hat q_i_ddot."""
    return {
        "dQ_hat_dq_i": lambda: Kernel(
            a.select("q_i", "q_d", "q_i_dot", "q_d_dot"),
            {"dQ_hat_dq_i": ca.densify(_by_position(system, a, system.generalised_force({})))},
        ),
        "dQ_hat_dq_i_dot": lambda: Kernel(
            a.select("q_i", "q_d", "q_i_dot", "q_d_dot"),
            {"dQ_hat_dq_i_dot": ca.densify(_by_velocity(system, a, system.generalised_force({})))},
        ),
        "residual_jacobian": lambda: _residual_jacobian(system, a),
    }


def _residual_jacobian(system: Condensed, a: Arguments) -> Kernel:
    """J_q and J_v of Q_hat - M_hat q_i_ddot together, which share what both need."""
    if loops_alone(system):
        J_q, J_v = held_jacobians(system, a)
    else:
        given = {column: a.q_i_ddot[k] for k, column in enumerate(system.choice.independent)}
        residual = system.generalised_force(given)
        J_q, J_v = _by_position(system, a, residual), _by_velocity(system, a, residual)
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", q_i_ddot=a.q_i_ddot)
    return Kernel(inputs, {"J_q": ca.densify(J_q), "J_v": ca.densify(J_v)})


def _following(system: Condensed, a: Arguments) -> tuple[list[int], ca.SX, ca.SX]:
    """(columns, q, q_dot) of the dependent coordinates that have masses or constraints."""
    placed = system.reduced.placed_columns
    kept = [k for k, column in enumerate(a.dependent) if column not in placed]
    return [a.dependent[k] for k in kept], a.q_d[kept], a.q_d_dot[kept]


def _tangents(system: Condensed, columns: list[int]) -> ca.SX:
    """dq_d/dq_i, the rows of S that belong to some of q_d, by column of q."""
    tangents = [system.tangent({column: ca.SX(1)}) for column in system.choice.independent]
    return ca.horzcat(*(ca.vertcat(*(moved.get(c, ca.SX(0)) for c in columns)) for moved in tangents))


def _by_position(system: Condensed, a: Arguments, force: ca.SX) -> ca.SX:
    total = ca.jacobian(force, a.q_i)
    columns, q_d, q_d_dot = _following(system, a)
    if not columns:
        return total
    B = _tangents(system, columns)
    total = total + _product(ca.jacobian(force, q_d), B)
    through_rates = ca.jacobian(force, q_d_dot)
    if through_rates.nnz():
        rates = _rates(system, a, columns)
        total = total + _product(through_rates, ca.jacobian(rates, a.q_i) + _product(ca.jacobian(rates, q_d), B))
    return total


def _by_velocity(system: Condensed, a: Arguments, force: ca.SX) -> ca.SX:
    """By the chain rule through q_d_dot, or with q_d_dot substituted: for a small system whichever is shorter."""
    total = ca.jacobian(force, a.q_i_dot)
    columns, _, q_d_dot = _following(system, a)
    if not columns:
        return total
    chained = total + _product(ca.jacobian(force, q_d_dot), _tangents(system, columns))
    if a.q_i.numel() > SMALL_SYSTEM:
        return chained
    substituted = ca.jacobian(ca.substitute(force, q_d_dot, _rates(system, a, columns)), a.q_i_dot)
    return min(chained, substituted, key=lambda form: length([form]))


def _rates(system: Condensed, a: Arguments, columns: list[int]) -> ca.SX:
    """q_dot of some dependent coordinates, by column, as a function of (q_i, q_d, q_i_dot, t)."""
    values = system.dependent_velocities({c: a.q_i_dot[k] for k, c in enumerate(system.choice.independent)})
    return ca.vertcat(*(values.get(c, ca.SX(0)) for c in columns))


def _product(left: ca.SX, right: ca.SX) -> ca.SX:
    return ca.mtimes(ca.sparsify(left), ca.sparsify(right))
