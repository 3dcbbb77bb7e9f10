"""Accelerations of a tree in O(N): constraint substitutions and mass pivots interleaved from the tips to the root.

Eliminating a body's dependent coordinates carries its inertia to its parent; eliminating its independent ones right
after that (block L D L^T in topological order) leaves fill on the parent only. M_hat is never formed. This is the
articulated-body recursion, obtained from the same substitutions as the condensed form.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub
from symgen.condensed.condensation import Condensed, Substitution, congruence
from symgen.system.topology import Topology


class NoInertia(Exception):
    """An independent coordinate (its column) has no inertia at all."""


def is_tree(system: Condensed, topology: Topology) -> bool:
    """Does every dependent coordinate follow from those of its own body and of bodies closer to the ground?

    Only then do the bodies have an order from the tips to the root. Joints may need loop unknowns of their own.
    """
    body_of = {column: body for body, columns in system.equations.body_columns.items() for column in columns}

    def follows(column: int, other: int) -> bool:
        body, source = body_of[column], body_of[other]
        return body == source or topology.distance_of(source) < topology.distance_of(body)

    return (
        bool(body_of)
        and not topology.rings
        and all(follows(s.column, other) for s in system.substitutions for other in s.e)
    )


def tree_accelerations(system: Condensed, topology: Topology) -> dict[int, ca.SX]:
    """q_ddot of every coordinate of a tree, by column."""
    eq = system.equations
    M = [dict(row) for row in eq.M]
    force: Row = dict(enumerate(eq.Q_star))
    by_column = {substitution.column: substitution for substitution in system.substitutions}
    evaluated = {substitution.column: k for k, substitution in enumerate(system.substitutions)}
    pivots: list[tuple[int, Row, ca.SX, ca.SX]] = []
    order: list[int] = []
    for body in sorted(eq.body_columns, key=lambda name: -topology.distance_of(name)):
        columns = eq.body_columns[body]
        dependent = sorted((c for c in columns if c in by_column), key=lambda c: -evaluated[c])
        own = {other for c in dependent for other in by_column[c].e}
        independent = [c for c in reversed(columns) if c not in by_column]
        # what the body's place does not depend on has no neighbours on the parent yet: its pivots are short
        for column in (*(c for c in independent if c not in own), *dependent, *(c for c in independent if c in own)):
            if column in by_column:
                _substitute(M, force, by_column[column])
            else:
                pivots.append(_pivot(M, force, column))
            order.append(column)
    return _back_substitute(order, by_column, {pivot[0]: pivot for pivot in pivots})


def _substitute(M: list[Row], force: Row, substitution: Substitution) -> None:
    """x_d'' = sum e_j x_j'' + c: rows j lose M_jd c and gain e_j times row d."""
    d, c = substitution.column, substitution.c_acceleration
    if not c.is_zero():
        for column, value in M[d].items():
            force[column] = sub(force[column], mul(value, c))
    value = force.pop(d)
    for column, factor in substitution.e.items():
        force[column] = add(force[column], mul(factor, value))
    congruence(M, d, substitution.e)


def _pivot(M: list[Row], force: Row, k: int) -> tuple[int, Row, ca.SX, ca.SX]:
    """Gauss elimination of column k: (k, its row, 1 / pivot, its force) for the way back."""
    row = M[k]
    M[k] = {}
    if k not in row:
        raise NoInertia(k)
    inverse = div(ONE, row.pop(k))
    value = force.pop(k)
    for column in row:
        M[column].pop(k, None)
    columns = sorted(row)
    for position, i in enumerate(columns):
        factor = neg(mul(row[i], inverse))
        force[i] = add(force[i], mul(factor, value))
        for j in columns[position:]:
            add_to(M[i], j, mul(factor, row[j]))
            if i != j and j in M[i]:
                M[j][i] = M[i][j]
    return k, row, inverse, value


def _back_substitute(
    order: list[int], by_column: Mapping[int, Substitution], pivots: Mapping[int, tuple[int, Row, ca.SX, ca.SX]]
) -> dict[int, ca.SX]:
    found: dict[int, ca.SX] = {}
    for column in reversed(order):
        if column in pivots:
            _, row, inverse, value = pivots[column]
            rest = dot(list(row.values()), [found[c] for c in row])
            found[column] = mul(sub(value, rest), inverse)
        else:
            substitution = by_column[column]
            known = [found.get(c, ZERO) for c in substitution.e]
            found[column] = add(substitution.c_acceleration, dot(list(substitution.e.values()), known))
    return found
