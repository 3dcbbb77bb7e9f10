"""How the rows of constraints change: C_q x' - nu and C_q x'' - gamma by coordinates, rates and accelerations."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add, mul, sub, vector
from symgen.system.equations import Equations


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


def rates_of(eq: Equations, rows: Sequence[int], accelerations: Row) -> tuple[list[ca.SX], list[ca.SX]]:
    """C_q x' - nu and C_q x'' - gamma of some constraint rows."""
    constraints, rates = [eq.constraints[row] for row in rows], dict(enumerate(eq.q_dot))
    first = [add(along(row.C_q, rates), row.C_t) for row in constraints]
    return first, [sub(along(row.C_q, accelerations), row.gamma) for row in constraints]


def row_changes(eq: Equations, rows: Sequence[int], accelerations: Row) -> dict[int, ConstraintChange]:
    """Rates and derivatives commute: d(C')/dq_j = (C_qj)', d(C'')/dq_j = (C_qj)'' and d(C'')/dq_j' = 2 (C_qj)'.

    With velocities that are no rates of coordinates they do not, and in the plane, where a row has few coordinates,
    C' and C'' themselves take fewer operations to differentiate.
    """
    if eq.turnings or eq.inertia_forces is None:
        return _by_differentiation(eq, rows, accelerations)
    known = _by_fields(eq, rows, accelerations)
    return known | _by_rates(eq, [row for row in rows if row not in known], accelerations)


def _by_fields(eq: Equations, rows: Sequence[int], accelerations: Row) -> dict[int, ConstraintChange]:
    """Of the joints whose rows have rates known by geometry."""
    found = {}
    for joint, known in eq.loop_rates.items():
        own = [row for row, constraint in enumerate(eq.constraints) if constraint.joint == joint]
        for row, first, second in zip(own, *known.rows(dict(enumerate(eq.q_dot)), accelerations), strict=True):
            if row in rows:
                entries = eq.constraints[row].C_q
                g, h = (_of(entries.keys() & accelerations.keys(), change) for change in (first, second))
                k = {c: mul(ca.SX(2), value) for c, value in g.items()}
                found[row] = ConstraintChange(dict(entries), g, h, k)
    return found


def _by_rates(eq: Equations, rows: Sequence[int], accelerations: Row) -> dict[int, ConstraintChange]:
    if not rows:
        return {}
    columns = sorted(accelerations)
    places = [(row, column) for row in rows for column in eq.constraints[row].C_q if column in accelerations]
    q, rates = (ca.vertcat(*(source[c] for c in columns)) for source in (eq.q, eq.q_dot))
    second = ca.vertcat(*(accelerations[c] for c in columns))
    entries = ca.SX(ca.vertcat(*(eq.constraints[row].C_q[column] for row, column in places)))
    first = ca.jtimes(entries, q, rates)
    changes = [first, ca.jtimes(first, ca.vertcat(q, rates), ca.vertcat(rates, second)), 2 * first]
    found = {row: ConstraintChange(dict(eq.constraints[row].C_q), {}, {}, {}) for row in rows}
    for (row, column), *values in zip(places, *(vector(value) for value in changes), strict=True):
        for target, value in zip((found[row].g, found[row].h, found[row].k), values, strict=True):
            add_to(target, column, value)
    return found


def _by_differentiation(eq: Equations, rows: Sequence[int], accelerations: Row) -> dict[int, ConstraintChange]:
    columns = sorted(accelerations)
    entries = [eq.constraints[row].C_q for row in rows]
    first, second = rates_of(eq, rows, accelerations)
    by_q = derivative_rows([*first, *second], columns, eq.q)
    by_rate = derivative_rows(second, columns, eq.q_dot)
    n = len(rows)
    return {
        row: ConstraintChange(dict(own), *(_of(_places(eq, own), change) for change in (g, h, k)))
        for row, own, g, h, k in zip(rows, entries, by_q[:n], by_q[n:], by_rate, strict=True)
    }


def _places(eq: Equations, entries: Row) -> set[int]:
    """Columns that a row depends on: those of its entries, and all turns and Euler parameters of bodies that it turns.

    A turn about the line to a marker does not move the marker, and yet omega x (omega x r) has its rate.
    """
    turned = [one for one in eq.turnings if not entries.keys().isdisjoint(one.columns)]
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
