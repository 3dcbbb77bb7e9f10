"""How rates and accelerations of dependent coordinates change with those of the others, along the structure.

With x_d = f(x, t), all of it linear and sparse, in the order of the substitutions,

    dx_d   = sum e_j dx_j
    dx_d'  = sum e_j dx_j'  + sum g_j dx_j
    dx_d'' = sum e_j dx_j'' + sum k_j dx_j' + sum h_j dx_j,

from the changes of C_q x' - nu and C_q x'' - gamma, Eqs. (25) and (27), solved for dx_d' and dx_d'' with what gave e.
Where velocities are rates of coordinates, k = 2 g, which saves loops a solution.
"""

from __future__ import annotations

from dataclasses import replace

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add, div, mul, neg, sub
from symgen.algebra.small_systems import solve_small
from symgen.condensed.condensation import Condensed, Substitution
from symgen.condensed.loops import LoopBlock, solve_forward
from symgen.condensed.row_changes import ConstraintChange, Variation, along, rates_of, row_changes


def variations(system: Condensed, accelerations: Row) -> list[Variation]:
    """Of all dependent coordinates that have masses or constraints; accelerations: their symbols, by column."""
    eq, choice, inner = system.reduced, system.choice, system.inner
    structural = [(row, one) for (row, _), one in zip(choice.structural, _structural(system), strict=True)]
    kept = {one.column for one in inner}
    structural = [(row, one) for row, one in structural if one.column in kept]
    changes = row_changes(eq, [*choice.loop_rows, *(row for row, _ in structural)], accelerations)
    following = {}
    parameters = {column for turning in eq.turnings for column in turning.parameters}
    turned = [Variation(one.column, one.e, {}, {}, {}) for one in inner if one.column in parameters]
    for row, one in structural:
        change, pivot = changes[row], eq.constraints[row].C_q[one.column]
        for other in turned if one.column in parameters else []:  # e' = e o omega / 2 has all four
            change.folded(other)
        following[one.column] = _solved_row(one, change, pivot)
    for _, one in reversed(structural):
        for row in choice.loop_rows:
            changes[row].substituted(following[one.column])
    found: list[Variation] = []
    by_column = {one.column: one for one in inner}
    for block in system.loops.blocks:
        solved = _solved_block(block, changes, system, by_column)
        found += solved if eq.turnings else [_of_rates(one) for one in solved]
    return [*found, *(following[one.column] for _, one in structural)]


def _of_rates(one: Variation) -> Variation:
    return replace(one, k={column: mul(ca.SX(2), value) for column, value in one.g.items()})


def _structural(system: Condensed) -> list[Substitution]:
    count = len(system.choice.structural)
    return system.substitutions[len(system.substitutions) - count :]


def constraint_rates(system: Condensed, accelerations: Row) -> tuple[list[int], ca.SX, ca.SX]:
    """(rows that count, C_q x' - nu, C_q x'' - gamma of those rows)."""
    eq, kept = system.reduced, {one.column for one in system.inner}
    rows = [*system.choice.loop_rows, *(row for row, column in system.choice.structural if column in kept)]
    first, second = rates_of(eq, rows, accelerations)
    return rows, ca.vertcat(*first), ca.vertcat(*second)


def particular(system: Condensed, changes: Row) -> Row:
    """x of C_q x = -changes with x_i = 0, changes by constraint row."""
    eq, found = system.reduced, dict[int, ca.SX]()
    one_by_column = {one.column: one for one in system.inner}
    constants = {
        column: div(neg(changes[row]), eq.constraints[row].C_q[column])
        for row, column in system.choice.structural
        if column in one_by_column
    }
    sides: Row = {}
    for row in system.choice.loop_rows:
        entries, side = dict(eq.constraints[row].C_q), neg(changes[row])
        for _, column in reversed(system.choice.structural):
            factor = entries.pop(column, None) if column in one_by_column else None
            if factor is not None:
                add_scaled(entries, factor, one_by_column[column].e)
                side = sub(side, mul(factor, constants[column]))
        sides[row] = side
    if sides:
        (found,), _ = solve_forward(system.loops.blocks, system.loops.entries(), [sides])
    for _, column in system.choice.structural:
        if column in one_by_column:
            found[column] = add(constants[column], along(one_by_column[column].e, found))
    return found


def _solved_row(one: Substitution, change: ConstraintChange, pivot: ca.SX) -> Variation:
    g, h, k = ({c: neg(div(value, pivot)) for c, value in row.items()} for row in (change.g, change.h, change.k))
    add_scaled(g, g.pop(one.column, ZERO), one.e)
    row = ConstraintChange({}, g, h, k)
    row.folded(Variation(one.column, one.e, g, {}, {}))
    return Variation(one.column, one.e, row.g, row.h, row.k)


def _solved_block(
    block: LoopBlock, changes: dict[int, ConstraintChange], system: Condensed, by_column: dict[int, Substitution]
) -> list[Variation]:
    """-U^-1 of the changes of the block's rows."""
    entries = system.loops.entries()
    U = [[entries[row].get(column, ZERO) for column in block.columns] for row in block.rows]
    own = [Variation(column, by_column[column].e, {}, {}, {}) for column in block.columns]
    rows = [changes[row] for row in block.rows]
    for row in rows:
        for one in own:
            value = row.g.pop(one.column, ZERO)
            add_scaled(row.g, value, one.e)
    g = _solutions(U, [row.g for row in rows])
    own = [Variation(one.column, one.e, g_one, {}, {}) for one, g_one in zip(own, g, strict=True)]
    for row in rows:
        for one in own:
            row.folded(one)
    both = zip(own, _solutions(U, [row.h for row in rows]), _solutions(U, [row.k for row in rows]), strict=True)
    return [Variation(one.column, one.e, one.g, h, k) for one, h, k in both]


def _solutions(U: list[list[ca.SX]], rows: list[Row]) -> list[Row]:
    """Rows x of U x = -rows."""
    columns = sorted({column for row in rows for column in row})
    if not columns:
        return [{} for _ in rows]
    solved, _ = solve_small(U, [[neg(row.get(column, ZERO)) for row in rows] for column in columns])
    found: list[Row] = [{} for _ in rows]
    for column, values in zip(columns, solved, strict=True):
        for row, value in zip(found, values, strict=True):
            add_to(row, column, value)
    return found
