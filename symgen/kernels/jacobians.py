"""Jacobians of the condensed residual: total ones, through q_d = f(q_i, t) and q_d_dot = f'(q_i, q_i_dot, t).

The multipliers are held, and S is never differentiated. With rho = Q* - M a - C_q^T lambda, where a are accelerations
that satisfy the constraints and lambda makes the rows of the dependent coordinates vanish,

    Q_hat - M_hat a = S^T rho,    d(S^T rho) = S^T d(rho) at fixed lambda,

because dS has rows of dependent coordinates only. With K = d(rho)/dq and D = d(rho)/dq', sparse, and d(rho)/da = -M,
each dependent coordinate is taken out once, from the tips to the root: its columns by `variations`, its rows by S^T.

Where each entry of M_hat depends on its own two coordinates alone (`paired_changes`), it goes by pairs. So it is for
rigid bodies on hinges in the plane, whose independent coordinates are absolute angles: M_ij is a function of x_i and
x_j, and M_ii constant. Lagrange's equations have no products of different rates then, and with them

    F_i = M_ii x_i'' + sum over j of (M_ij x_j'' + dM_ij/dx_j x_j'^2),
    dF_i/dx_j  = d^2/dt^2 of M_ij as x_j alone moves,    dF_i/dx_j' = 2 dM_ij/dx_j x_j'

for j other than i. Where the M_ij of a coordinate depend on differences, dF_i/dx_i is minus the sum of the other
dF_i/dx_j, as turned together they change no inertia force, and d^2 M_ij/dx_j^2 is d^2 M_ij/dx_i^2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from symgen.algebra.rows import Row, add_scaled, to_matrix
from symgen.algebra.scalar import ONE, ZERO, add, div, mul, neg, total, vector
from symgen.condensed.condensation import Condensed
from symgen.condensed.loops import solve_transposed
from symgen.condensed.variations import (
    TakenOut,
    derivative_rows,
    directions,
    variations,
)
from symgen.kernels.kernel import Arguments, Kernel, shortest
from symgen.system.equations import Direction, Equations

FEW_DIRECTIONS = 8  # independent coordinates up to which derivatives along each are tried


def held_jacobians(system: Condensed, q_i_ddot: Sequence[ca.SX]) -> list[tuple[ca.SX, ca.SX]]:
    """(J_q, J_v): total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot, by each way that may be short."""
    given = dict(zip(system.choice.independent, q_i_ddot, strict=True))
    held = _held(system, given)
    found = [ca.substitute(_eliminated(held), *held.values)]
    if system.choice.loop_columns and len(system.choice.independent) <= FEW_DIRECTIONS:
        ways = directions(system, held.accelerations)
        found.append(ca.substitute(_along_loops(held, ways) or _directed(held, ways), *held.values))
    inertia = paired_changes(system, given)
    if inertia is not None:
        found.append(_with(system, given, inertia))
    return [(ca.densify(J_q), ca.densify(J_v)) for J_q, J_v in found]


def _with(system: Condensed, given: Row, inertia: tuple[ca.SX, ca.SX]) -> list[ca.SX]:
    """Of all forces but those of inertia by elimination, and of these."""
    held = _held(system, given, massless=True)
    rest = ca.substitute(_eliminated(held), *held.values)
    return [other + own for other, own in zip(rest, inertia, strict=True)]


@dataclass(frozen=True)
class _Held:
    """rho by column, accelerations by column (of dependent coordinates: symbols), and what the symbols stand for.

    lam: multipliers by constraint row.
    massless: without inertia forces, in rho and lambda.
    """

    system: Condensed
    rho: Row
    lam: Row
    accelerations: Row
    values: tuple[list[ca.SX], list[ca.SX]]
    massless: bool = False


def _held(system: Condensed, given: Row, massless: bool = False) -> _Held:
    eq = system.reduced
    a_d = {one.column: ca.SX.sym(f"a_{one.column}") for one in system.inner}
    accelerations = {**given, **a_d}
    force = eq.outer_forces if massless else eq.force(accelerations)
    rows = _rows(system)
    lam = {row: ca.SX.sym(f"lam_{row}") for row in rows}
    rho = {column: force[column] for column in accelerations}
    for row, value in lam.items():
        add_scaled(rho, neg(value), {c: entry for c, entry in eq.constraints[row].C_q.items() if c in rho})
    found = system.accelerations(given)
    known = ca.SX(ca.vertcat(*(found.get(column, ZERO) for column in a_d)))
    symbols = ca.SX(ca.vertcat(*a_d.values()))
    multipliers = ca.substitute(ca.SX(ca.vertcat(*_multipliers(system, rows, force))), symbols, known)
    values = [symbols, ca.SX(ca.vertcat(*lam.values()))], [known, multipliers]
    return _Held(system, rho, lam, accelerations, values, massless)


def _eliminated(held: _Held) -> list[ca.SX]:
    """All of K and D, and each dependent coordinate taken out: for trees, and where there are many directions."""
    system, eq = held.system, held.system.reduced
    columns = sorted(held.rho)
    K, D = (dict(zip(columns, rows, strict=True)) for rows in _derivatives(held, columns))
    left = TakenOut([{} if held.massless else dict(row) for row in eq.M], K, D)
    for one in reversed(variations(system, held.accelerations)):
        left.take_out(one)
    kept = system.choice.independent
    return [to_matrix([rows[column] for column in kept], kept) for rows in (left.K, left.D)]


def _derivatives(held: _Held, columns: list[int]) -> list[list[Row]]:
    """Rows of K and D: of inertia forces by composites, where known."""
    eq = held.system.reduced
    if eq.force_changes is None:
        values = [held.rho[column] for column in columns]
        return [derivative_rows(values, columns, by) for by in (eq.q, eq.q_dot)]
    K, D = _outer(held, columns)
    for rows, change in zip((K, D), eq.force_changes(held.accelerations), strict=True):
        for row, column in zip(rows, columns, strict=True):
            add_scaled(row, neg(ONE), {c: value for c, value in change[column].items() if c in held.rho})
    return [K, D]


def _outer(held: _Held, columns: list[int], known: frozenset[str] = frozenset()) -> list[list[Row]]:
    """Of all but the inertia forces and the rows of known joints."""
    eq, work = held.system.reduced, {column: held.system.reduced.outer_forces[column] for column in columns}
    for row, value in held.lam.items():
        if eq.constraints[row].joint not in known:
            add_scaled(work, neg(value), {c: entry for c, entry in eq.constraints[row].C_q.items() if c in work})
    return [derivative_rows(list(work.values()), columns, by) for by in (eq.q, eq.q_dot)]


def _multipliers_of(held: _Held, joint: str) -> list[ca.SX]:
    rows = [k for k, row in enumerate(held.system.reduced.constraints) if row.joint == joint]
    return [held.lam.get(k, ZERO) for k in rows]


def _along_loops(held: _Held, ways: Sequence[Direction]) -> list[ca.SX] | None:
    """By the fields of frames along each independent coordinate, where spherical joints close loops."""
    system, eq = held.system, held.system.reduced
    independent = system.choice.independent
    modes = eq.elastic_columns & held.rho.keys()
    if eq.loop_changes is None or not eq.loop_rates or eq.rotation_vectors or not modes <= set(independent):
        return None
    known = {joint: _multipliers_of(held, joint) for joint in eq.loop_rates}
    inertia = eq.loop_changes(held.accelerations, known, ways)
    if inertia is None:
        return None
    columns = sorted(held.rho)
    S, S_dot = _columns([one.S for one in ways], columns), _columns([one.S_dot for one in ways], columns)
    K, D = (to_matrix(rows, columns) for rows in _outer(held, columns, frozenset(eq.loop_rates)))
    F_q, F_v = (change[columns, :] for change in inertia)
    return [_product(S.T, _product(K, S) + _product(D, S_dot) - F_q), _product(S.T, _product(D, S) - F_v)]


def _directed(held: _Held, ways: Sequence[Direction]) -> list[ca.SX]:
    """d(rho) along each independent coordinate, which the dependent ones follow."""
    system, eq, columns = held.system, held.system.reduced, sorted(held.rho)
    dependent = [column for column in columns if column not in system.choice.independent]
    S, S_dot = _columns([one.S for one in ways], columns), _columns([one.S_dot for one in ways], columns)
    S_ddot, by_rate = (
        _columns(rows, dependent) for rows in ([one.S_ddot for one in ways], [one.by_rate for one in ways])
    )
    q, rates = (ca.vertcat(*(source[c] for c in columns)) for source in (eq.q, eq.q_dot))
    a, rho = _columns([held.accelerations], dependent), _columns([held.rho], columns)
    by_q = ca.jtimes(rho, ca.vertcat(q, rates, a), ca.vertcat(S, S_dot, S_ddot))
    by_v = ca.jtimes(rho, ca.vertcat(rates, a), ca.vertcat(S, by_rate))
    return [_product(S.T, by_q), _product(S.T, by_v)]


def _columns(rows: Sequence[Row], columns: list[int]) -> ca.SX:
    """Each as a column of a matrix."""
    return ca.horzcat(*(ca.vertcat(*(row.get(c, ZERO) for c in columns)) for row in rows))


def _product(left: ca.SX, right: ca.SX) -> ca.SX:
    return ca.mtimes(ca.sparsify(left), ca.sparsify(right))


def _rows(system: Condensed) -> list[int]:
    """Constraint rows whose multipliers count: of loops, then of the structural coordinates."""
    kept = {one.column for one in system.inner}
    return [*system.loops.rows, *(row for row, column in system.choice.structural if column in kept)]


def _multipliers(system: Condensed, rows: list[int], force: list[ca.SX]) -> list[ca.SX]:
    """lambda of these rows from those rows of rho that vanish (Eq. 37)."""
    eq = system.reduced
    structural = {row: column for row, column in system.choice.structural if row in rows}
    found: dict[int, ca.SX] = {}
    if system.loops.rows:
        work = dict(enumerate(force))
        for one in reversed(system.inner):
            if one.column not in system.choice.loop_columns:
                add_scaled(work, work.pop(one.column, ZERO), one.e)
        side = {column: work.get(column, ZERO) for column in system.choice.loop_columns}
        found = solve_transposed(system.loops.blocks, system.loops.entries(), side)
    rest = dict(enumerate(force))
    for row, value in found.items():
        add_scaled(rest, neg(value), eq.constraints[row].C_q)
    for row, column in reversed(list(structural.items())):
        found[row] = div(rest.pop(column, ZERO), eq.constraints[row].C_q[column])
        add_scaled(rest, neg(found[row]), {c: v for c, v in eq.constraints[row].C_q.items() if c != column})
    return [found[row] for row in rows]


CANCELLATION_ROUNDING = 1e-10  # share of two values by which their sum is zero at a random point


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
    rotation = _of_differences(slopes, [M[i, i] for i in range(n)])
    if rotation is None:
        return None
    J_x, J_v = ca.SX(n, n), ca.SX(n, n)
    twice, less = ([mul(ca.SX(factor), rate) for rate in rates] for factor in (2, -2))
    for i in range(n):
        others = [j for j in range(n) if j != i]
        for j in others:
            back = bool(j < i and rotation[i, j])
            at_rates = rotation[i, j] and second[j].is_zero()
            J_x[i, j] = mul(bows[min(i, j)][max(i, j)], mul(rates[j], rates[j])) if at_rates else ways[j][i]
            J_v[i, j] = mul(slopes[i][j], twice[j]) if back else mul(slopes[j][i], less[j])
        if all(rotation[i, j] for j in others):
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
    if not np.all(np.abs(np.diag(by_pair)) <= CANCELLATION_ROUNDING * np.abs(own)):
        return None
    return np.asarray(np.abs(by_pair + by_pair.T) <= CANCELLATION_ROUNDING * (np.abs(by_pair) + np.abs(by_pair.T)))


def jacobian_kernels(system: Condensed, a: Arguments) -> dict[str, Callable[[], Kernel]]:
    """Builders of dQ_hat/dq_i, dQ_hat/dq_i_dot, and both of Q_hat - M_hat q_i_ddot, which share what both need."""
    state = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    moving = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", q_i_ddot=a.q_i_ddot)

    def of_force(name: str, which: int) -> Kernel:
        forms = held_jacobians(system, [ZERO] * a.q_i.numel())
        return shortest(state, [{name: form[which]} for form in forms])

    def of_residual() -> Kernel:
        forms = held_jacobians(system, ca.vertsplit(a.q_i_ddot))
        return shortest(moving, [{"J_q": J_q, "J_v": J_v} for J_q, J_v in forms])

    return {
        "dQ_hat_dq_i": lambda: of_force("dQ_hat_dq_i", 0),
        "dQ_hat_dq_i_dot": lambda: of_force("dQ_hat_dq_i_dot", 1),
        "residual_jacobian": of_residual,
    }
