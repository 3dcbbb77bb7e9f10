"""Total Jacobians of the condensed equations, through q_d = f(q_i, t) and q_d_dot = f'(q_i, q_i_dot, t)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import casadi as ca

from symgen.condensed.condensation import Condensed
from symgen.kernels.kernel import Kernel

if TYPE_CHECKING:
    from symgen.kernels.arguments import Arguments

SMALL_SYSTEM = 8  # independent coordinates up to which two forms of a Jacobian are compared


def jacobian_kernels(system: Condensed, a: Arguments) -> dict[str, Callable[[], Kernel]]:
    """Builders of dQ_hat/dq_i, dQ_hat/dq_i_dot and d(M_hat q_i_ddot)/dq_i."""
    return {
        "dQ_hat_dq_i": lambda: Kernel(
            a.select("q_i", "q_d", "q_i_dot", "q_d_dot"),
            {"dQ_hat_dq_i": ca.densify(_by_position(system, a, system.generalised_force({})))},
        ),
        "dQ_hat_dq_i_dot": lambda: Kernel(
            a.select("q_i", "q_d", "q_i_dot", "q_d_dot"),
            {"dQ_hat_dq_i_dot": ca.densify(_by_velocity(system, a, system.generalised_force({})))},
        ),
        "dMa_dq_i": lambda: Kernel(
            a.select("q_i", "q_d", q_i_ddot=a.q_i_ddot),
            {"dMa_dq_i": ca.densify(_by_position(system, a, _inertia_force(system, a)))},
        ),
    }


def _inertia_force(system: Condensed, a: Arguments) -> ca.SX:
    """M_hat q_i_ddot as S^T M S q_i_ddot."""
    eq = system.equations
    values = {column: a.q_i_ddot[k] for k, column in enumerate(system.choice.independent)}
    moved = system.tangent(values)
    force = {}
    for row, entries in enumerate(eq.M):
        force[row] = sum((value * moved[c] for c, value in entries.items() if c in moved), ca.SX(0))
    return system.project(force)


def _tangents(system: Condensed, a: Arguments) -> ca.SX:
    """dq_d/dq_i (n_d x n_i), the rows of S that belong to q_d."""
    columns = []
    for column in system.choice.independent:
        moved = system.tangent({column: ca.SX(1)})
        columns.append(ca.vertcat(*(moved.get(c, ca.SX(0)) for c in a.dependent)) if a.dependent else ca.SX(0, 1))
    return ca.horzcat(*columns)


def _by_position(system: Condensed, a: Arguments, force: ca.SX) -> ca.SX:
    total = ca.jacobian(force, a.q_i)
    if not a.dependent:
        return total
    B = _tangents(system, a)
    total = total + _product(ca.jacobian(force, a.q_d), B)
    through_rates = ca.jacobian(force, a.q_d_dot)
    if through_rates.nnz():
        rates = _dependent_rates(system, a)
        total = total + _product(through_rates, ca.jacobian(rates, a.q_i) + _product(ca.jacobian(rates, a.q_d), B))
    return total


def _by_velocity(system: Condensed, a: Arguments, force: ca.SX) -> ca.SX:
    """By the chain rule through q_d_dot, or with q_d_dot substituted: for a small system whichever is shorter."""
    total = ca.jacobian(force, a.q_i_dot)
    if not a.dependent:
        return total
    chained = total + _product(ca.jacobian(force, a.q_d_dot), _tangents(system, a))
    if a.q_i.numel() > SMALL_SYSTEM:
        return chained
    substituted = ca.jacobian(ca.substitute(force, a.q_d_dot, _dependent_rates(system, a)), a.q_i_dot)
    return min(chained, substituted, key=_length)


def _length(expression: ca.SX) -> int:
    """Number of distinct operations of an expression."""
    return int(ca.n_nodes(ca.cse(ca.densify(expression))))


def _dependent_rates(system: Condensed, a: Arguments) -> ca.SX:
    """q_d_dot as a function of (q_i, q_d, q_i_dot, t)."""
    values = system.dependent_velocities({c: a.q_i_dot[k] for k, c in enumerate(system.choice.independent)})
    return ca.vertcat(*(values.get(c, ca.SX(0)) for c in a.dependent))


def _product(left: ca.SX, right: ca.SX) -> ca.SX:
    return ca.mtimes(ca.sparsify(left), ca.sparsify(right))
