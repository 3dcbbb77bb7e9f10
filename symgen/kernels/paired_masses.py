"""Derivatives of inertia forces where each entry of M_hat depends on its own two coordinates alone.

So it is for rigid bodies on hinges in the plane, whose independent coordinates are absolute angles: M_ij is a function
of x_i and x_j, and M_ii constant. Lagrange's equations have no products of different rates then, and with them

    F_i = M_ii x_i'' + sum over j of (M_ij x_j'' + dM_ij/dx_j x_j'^2),
    dF_i/dx_j  = d^2/dt^2 of M_ij as x_j alone moves,    dF_i/dx_j' = 2 dM_ij/dx_j x_j'

for j other than i. Where the M_ij of a coordinate depend on differences, dF_i/dx_i is minus the sum of the other
dF_i/dx_j, as turned together they change no inertia force, and d^2 M_ij/dx_j^2 is d^2 M_ij/dx_i^2.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, add, mul, neg, total, vector
from symgen.condensed.condensation import Condensed
from symgen.system.equations import Equations

ROUNDING = 1e-10  # share of two values by which their sum is zero at a random point


def paired_changes(system: Condensed, accelerations: Row) -> tuple[ca.SX, ca.SX] | None:
    """-dF/dx and -dF/dx' (n x n) by the independent coordinates; None where M_hat is not of that form.

    accelerations: of the independent coordinates by column.
    """
    eq, columns = system.reduced, system.choice.independent
    if eq.inertia_forces is not None or system.choice.loop_columns or not all(r.C_t.is_zero() for r in eq.constraints):
        return None
    M, n = system.M_hat(), len(columns)
    if not _of_pairs(M, eq, columns):
        return None
    x, rates, second = ([source[c] for c in columns] for source in (eq.q, eq.q_dot, accelerations))
    slopes, bows, ways = [], [], []  # by j, then i: dM_ij/dx_j, -d^2 M_ij/dx_j^2 and -dF_i/dx_j
    one = ca.SX.sym("one")
    for j in range(n):
        once = ca.jtimes(M[:, j], x[j], one)
        seeds = ca.vertcat(neg(mul(rates[j], rates[j])), neg(second[j]))
        ways.append(vector(ca.substitute(ca.jtimes(once, ca.vertcat(x[j], one), seeds), one, ONE)))
        slopes.append(vector(ca.substitute(once, one, ONE)))
        bows.append(vector(ca.substitute(ca.jtimes(once, x[j], ca.SX(-1)), one, ONE)))
    turning = _of_differences(slopes, [M[i, i] for i in range(n)])
    if turning is None:
        return None
    J_x, J_v = ca.SX(n, n), ca.SX(n, n)
    twice, less = ([mul(ca.SX(factor), rate) for rate in rates] for factor in (2, -2))
    for i in range(n):
        others = [j for j in range(n) if j != i]
        for j in others:
            back = bool(j < i and turning[i, j])
            at_rates = turning[i, j] and second[j].is_zero()
            J_x[i, j] = mul(bows[min(i, j)][max(i, j)], mul(rates[j], rates[j])) if at_rates else ways[j][i]
            J_v[i, j] = mul(slopes[i][j], twice[j]) if back else mul(slopes[j][i], less[j])
        if all(turning[i, j] for j in others):
            J_x[i, i] = neg(total(J_x[i, j] for j in others))
        else:
            force = (add(mul(M[i, j], second[j]), mul(slopes[j][i], mul(rates[j], rates[j]))) for j in others)
            J_x[i, i] = neg(ca.jtimes(total(force), x[i], ONE))
    return ca.sparsify(J_x), ca.sparsify(J_v)


def _of_pairs(M: ca.SX, eq: Equations, columns: list[int]) -> bool:
    """Does each entry depend on its two coordinates at most?"""
    moving = {one.element_hash() for one in (*eq.q, *eq.q_dot, *ca.symvar(ca.vertcat(eq.t, *eq.u.values())))}
    x = [eq.q[column].element_hash() for column in columns]

    def free(i: int, j: int) -> bool:
        return {symbol.element_hash() for symbol in ca.symvar(M[i, j])} & moving <= {x[i], x[j]}

    n = len(columns)
    return all(free(i, i) for i in range(n)) and all(free(i, j) for i in range(n) for j in range(i))


def _of_differences(slopes: list[list[ca.SX]], diagonal: list[ca.SX]) -> np.ndarray | None:
    """Is dM_ij/dx_i = -dM_ij/dx_j? By values at a random point; None where a dM_ii/dx_i is not zero."""
    n, values = len(slopes), ca.vertcat(*(ca.vertcat(*column) for column in slopes), *diagonal)
    symbols = ca.vertcat(*ca.symvar(values))
    numbers = np.random.default_rng(0).uniform(0.3, 1.0, symbols.numel())
    found = np.asarray(ca.Function("slopes", [symbols], [values])(numbers)).ravel()
    by_pair, own = found[: n * n].reshape(n, n), found[n * n :]
    if not np.all(np.abs(np.diag(by_pair)) <= ROUNDING * np.abs(own)):
        return None
    return np.asarray(np.abs(by_pair + by_pair.T) <= ROUNDING * (np.abs(by_pair) + np.abs(by_pair.T)))
