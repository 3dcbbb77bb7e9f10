"""How rates and accelerations of dependent coordinates change with those of the others, along the structure.

With x_d = f(x, t), all of it linear and sparse, in the order of the substitutions,

    dx_d   = sum e_j dx_j
    dx_d'  = sum e_j dx_j'  + sum g_j dx_j
    dx_d'' = sum e_j dx_j'' + sum k_j dx_j' + sum h_j dx_j,

from the changes of C_q x' - nu and C_q x'' - gamma, Eqs. (25) and (27), by coordinates, rates and accelerations, solved
for dx_d' and dx_d'' with what gave e. Where velocities are rates of coordinates, k = 2 g, which saves loops a solution.
Derivatives of forces lose a dependent coordinate after another by them (`TakenOut`).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ONE, ZERO, add, div, mul, neg, sub, total, vector
from symgen.algebra.small_systems import solve_small
from symgen.condensed.condensation import Condensed, Substitution, congruence
from symgen.condensed.loops import LoopBlock
from symgen.system.constraint import ConstraintRow
from symgen.system.equations import Direction, Equations


@dataclass(frozen=True)
class Variation:
    """Of one dependent coordinate; see the module for e, g, h and k."""

    column: int
    e: Row
    g: Row
    h: Row
    k: Row


@dataclass(frozen=True)
class ConstraintChange:
    """entries dx' + g dx and entries dx'' + k dx' + h dx of one constraint row."""

    entries: Row
    g: Row
    h: Row
    k: Row

    def substituted(self, one: Variation) -> None:
        """Without a dependent coordinate, in place."""
        factor = self.entries.pop(one.column, ZERO)
        if not factor.is_zero():
            for own, more in ((self.entries, one.e), (self.g, one.g), (self.k, one.k), (self.h, one.h)):
                add_scaled(own, factor, more)
        self.folded(one)

    def folded(self, one: Variation) -> None:
        """Without what is multiplied by changes of lower order of a dependent coordinate, in place."""
        rate = self.k.pop(one.column, ZERO)
        if not rate.is_zero():
            add_scaled(self.k, rate, one.e)
            add_scaled(self.h, rate, one.g)
        for row in (self.g, self.h):
            value = row.pop(one.column, ZERO)
            if not value.is_zero():
                add_scaled(row, value, one.e)


def derivative_rows(values: Sequence[ca.SX], columns: Sequence[int], symbols: Sequence[ca.SX]) -> list[Row]:
    """Derivatives of each value by the symbols of some columns, which `symbols` has by column."""
    found: list[Row] = [{} for _ in values]
    if values and columns:
        matrix = ca.sparsify(ca.jacobian(ca.vertcat(*values), ca.vertcat(*(symbols[c] for c in columns))))
        places = matrix.sparsity().get_triplet()
        elements = ca.vertsplit(ca.vec(matrix.nz[:])) if matrix.nnz() else []
        for row, place, value in zip(*places, elements, strict=True):
            found[row][columns[place]] = value
    return found


def row_changes(eq: Equations, rows: Sequence[int], accelerations: Row) -> dict[int, ConstraintChange]:
    """Of some constraint rows, by differentiation."""
    columns = sorted(accelerations)
    entries = [eq.constraints[row].C_q for row in rows]
    first, second = _rates(eq, [eq.constraints[row] for row in rows], accelerations)
    by_q = derivative_rows([*first, *second], columns, eq.q)
    by_rate = derivative_rows(second, columns, eq.q_dot)
    n = len(rows)
    return {
        row: ConstraintChange(dict(own), *(_of(_places(eq, own), change) for change in (g, h, k)))
        for row, own, g, h, k in zip(rows, entries, by_q[:n], by_q[n:], by_rate, strict=True)
    }


def _known_changes(eq: Equations, accelerations: Row) -> dict[int, ConstraintChange]:
    """Of the joints whose rows have rates known by geometry, which commute with derivatives:

    d(C')/dq_j = (C_qj)', d(C'')/dq_j = (C_qj)'' and d(C'')/dq_j' = 2 (C_qj)'.
    """
    found = {}
    for joint, known in eq.loop_rates.items():
        own = [row for row, constraint in enumerate(eq.constraints) if constraint.joint == joint]
        for row, first, second in zip(own, *known(dict(enumerate(eq.q_dot)), accelerations), strict=True):
            entries = eq.constraints[row].C_q
            g, h = (_of(entries.keys() & accelerations.keys(), change) for change in (first, second))
            found[row] = ConstraintChange(dict(entries), g, h, _twice(g))
    return found


def _rates(eq: Equations, constraints: Sequence[ConstraintRow], accelerations: Row) -> tuple[list[ca.SX], list[ca.SX]]:
    """C_q x' - nu and C_q x'' - gamma."""
    rates = dict(enumerate(eq.q_dot))
    first = [add(along(row.C_q, rates), row.C_t) for row in constraints]
    return first, [sub(along(row.C_q, accelerations), row.gamma) for row in constraints]


def _twice(row: Row) -> Row:
    return {column: mul(ca.SX(2), value) for column, value in row.items()}


def _places(eq: Equations, entries: Row) -> set[int]:
    """Columns that a row depends on: those of its entries, and all turns and Euler parameters of bodies that it turns.

    A turn about the line to a marker does not move the marker, and yet omega x (omega x r) has its rate.
    """
    turned = [one for one in eq.rotation_vectors if not entries.keys().isdisjoint(one.columns)]
    return {*entries, *(column for one in turned for column in (*one.columns, *one.parameters))}


def _of(entries: Collection[int], change: Row) -> Row:
    """What a row does not depend on changes nothing, whatever stands in its terms."""
    return {column: value for column, value in change.items() if column in entries}


def along(entries: Row, values: Row) -> ca.SX:
    """Sum of entries times values of the same columns."""
    result = ZERO
    for column, value in entries.items():
        if column in values:
            result = add(result, mul(value, values[column]))
    return result


def variations(system: Condensed, accelerations: Row) -> list[Variation]:
    """Of all dependent coordinates that have masses or constraints; accelerations: their symbols, by column."""
    eq, choice, inner = system.reduced, system.choice, system.inner
    structural = [(row, one) for (row, _), one in zip(choice.structural, _structural(system), strict=True)]
    kept = {one.column for one in inner}
    structural = [(row, one) for row, one in structural if one.column in kept]
    changes = row_changes(eq, [*choice.loop_rows, *(row for row, _ in structural)], accelerations)
    following = {}
    parameters = {column for rotation in eq.rotation_vectors for column in rotation.parameters}
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
        found += solved if eq.rotation_vectors else [_of_rates(one) for one in solved]
    return [*found, *(following[one.column] for _, one in structural)]


def _of_rates(one: Variation) -> Variation:
    return replace(one, k=_twice(one.g))


def _structural(system: Condensed) -> list[Substitution]:
    count = len(system.choice.structural)
    return system.substitutions[len(system.substitutions) - count :]


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


def directions(system: Condensed, accelerations: Row) -> list[Direction]:
    """Each independent coordinate with all that follow it: each direction by itself, for loops with few of them."""
    eq, columns = system.reduced, sorted(accelerations)
    known = {} if eq.rotation_vectors else _known_changes(eq, accelerations)
    first, second = (ca.vertcat(*values) for values in _rates(eq, eq.constraints, accelerations))
    q, rates = (ca.vertcat(*(source[c] for c in columns)) for source in (eq.q, eq.q_dot))

    def following(values: ca.SX, *moved: tuple[str, ca.SX, Row]) -> Row:
        seeds = ca.vertcat(*(row.get(c, ZERO) for _, _, row in moved for c in columns))
        changes = vector(ca.jtimes(values, ca.vertcat(*(symbols for _, symbols, _ in moved)), seeds))
        for place, change in known.items():
            changes[place] = total(along(getattr(change, name), row) for name, _, row in moved)
        return system.following({}, changes)

    found = []
    for column in system.choice.independent:
        S = system.following({column: ONE}, [ZERO] * len(eq.constraints))
        S_dot = following(first, ("g", q, S))
        S_ddot = following(second, ("h", q, S), ("k", rates, S_dot))
        by_rate = (
            following(second, ("k", rates, S)) if eq.rotation_vectors or eq.inertia_forces is None else _twice(S_dot)
        )
        found.append(Direction(column, S, S_dot, S_ddot, by_rate))
    return found


@dataclass
class TakenOut:
    """Rows of M (symmetric), K and D by column, in the coordinates that are left."""

    M: list[Row]
    K: dict[int, Row]
    D: dict[int, Row]

    def take_out(self, one: Variation) -> None:
        """A dependent coordinate: its columns, then its rows."""
        d = one.column
        for row, value in self.M[d].items():
            if row in self.K:
                add_scaled(self.K[row], neg(value), one.h)
                add_scaled(self.D[row], neg(value), one.k)
        for row, rates in self.D.items():
            value = rates.pop(d, ZERO)
            if not value.is_zero():
                add_scaled(self.K[row], value, one.g)
                add_scaled(rates, value, one.e)
        for places in self.K.values():
            value = places.pop(d, ZERO)
            if not value.is_zero():
                add_scaled(places, value, one.e)
        for rows in (self.K, self.D):
            own = rows.pop(d)
            for column, factor in one.e.items():
                if column in rows:
                    add_scaled(rows[column], factor, own)
        congruence(self.M, d, one.e)
