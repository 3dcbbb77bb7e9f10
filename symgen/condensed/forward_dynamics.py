"""Forward dynamics, accelerations of a tree in O(N): constraint substitutions and mass pivots interleaved from the
tips to the root.

Eliminating a body's dependent coordinates carries its inertia to its parent; eliminating its independent ones right
after that (block L D L^T in topological order) leaves fill on the parent only. M_hat is never formed. This is the
articulated-body recursion, obtained from the same substitutions as the condensed form.

One elimination serves several right-hand sides, each some operations a body more: M_hat^-1 B for the columns of B.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ONE, ZERO, add, div, mul, neg, sub
from symgen.condensed.condensation import Condensed, congruence
from symgen.system.equations import FreeJointAccelerations, NoInertia
from symgen.system.topology import Topology

LONGEST_ELIMINATION = 24  # coordinates of joints up to which it may be the shorter way


@dataclass(frozen=True)
class Side:
    """A right-hand side: a force on q, and c of x_d'' = sum e_j x_j'' + c by the column of each substitution."""

    force: Row
    constants: Row


@dataclass
class _Pivot:
    """An eliminated coordinate: x'' = sum weights_j x_j'' + a constant in each right-hand side."""

    weights: Row
    constants: list[ca.SX]


@dataclass(frozen=True)
class Lock:
    """An element that may stick, as the pivot of a column: moves is one, or zero where x'' = sum e_j x_j'' + c.

    It multiplies 1 / pivot; what is held passes its row on by e.
    """

    moves: ca.SX
    e: Row
    c: ca.SX

    @property
    def alone(self) -> bool:
        """Is x'' zero where it is held?"""
        return not self.e and self.c.is_zero()


FREE = Lock(ONE, {}, ZERO)


def is_tree(system: Condensed, topology: Topology) -> bool:
    """Does every dependent coordinate follow from those of its own body and of bodies closer to the ground?

    Only then do the bodies have an order from the tips to the root. Joints may need loop unknowns of their own.
    """
    body_of = {column: body for body, columns in system.reduced.body_columns.items() for column in columns}

    def follows(column: int, other: int) -> bool:
        body, source = body_of[column], body_of[other]
        return body == source or topology.distance_of(source) < topology.distance_of(body)

    return (
        bool(body_of)
        and not topology.rings
        and all(follows(s.column, other) for s in system.substitutions for other in s.e)
    )


def forces_side(system: Condensed) -> Side:
    """Q*, and the accelerations that the constraints impose: the right-hand side of the motion itself."""
    constants = {s.column: s.c_acceleration for s in system.substitutions}
    return Side(dict(enumerate(system.reduced.Q_star)), constants)


def force_side(force: Row) -> Side:
    """A force on q alone: its solution is M_hat^-1 S^T force."""
    return Side(force, {})


def tree_accelerations(system: Condensed, topology: Topology, locked: Mapping[int, Lock]) -> list[dict[int, ca.SX]]:
    """q_ddot of every independent coordinate of a tree, by column, in one or two ways of which the shorter is wanted.

    Elimination of M, which has no fill, or the articulated bodies' recursion where joints place all. locked: by column.
    """
    columns = system.choice.independent
    solve = free_joints(system) if all(lock.alone for lock in locked.values()) else None
    if solve is None:
        return tree_solutions(system, topology, [forces_side(system)], locked=locked)
    imposed = {s.column: s.c_acceleration for s in system.inner}
    force = system.projected(dict(enumerate(system.reduced.outer_forces)))
    other = solve(force, frozenset(columns), {column: lock.moves for column, lock in locked.items()}, imposed)
    other |= {column: force[column] for column in system.reduced.states.values()}  # of controllers: unit inertia
    if len(columns) > LONGEST_ELIMINATION:
        return [other]
    return [*tree_solutions(system, topology, [forces_side(system)], locked=locked), other]


def free_joints(system: Condensed) -> FreeJointAccelerations | None:
    """The recursion of articulated bodies, where joints place all bodies and no other coordinate follows."""
    following = {column for rotation in system.reduced.rotation_vectors for column in rotation.parameters}
    following |= system.reduced.placed_columns
    if any(s.e for s in system.inner if s.column not in following):
        return None
    return system.reduced.free_joints


def tree_solutions(
    system: Condensed,
    topology: Topology,
    sides: Sequence[Side],
    attached: Sequence[tuple[int, int, ca.SX]] = (),
    locked: Mapping[int, Lock] | None = None,
) -> list[dict[int, ca.SX]]:
    """q_ddot of every coordinate of a tree, by column, for each right-hand side, from one elimination.

    attached: further entries (row, column, value) of M, both triangles; locked: elements that may stick, by column.
    Raises NoInertia.
    """
    by_column, locked = {one.column: one for one in system.substitutions}, locked or {}
    M = [dict(row) for row in system.reduced.M]
    for row, column, value in attached:
        add_to(M[row], column, value)
    forces = [dict(side.force) for side in sides]
    order, pivots = _elimination_order(system, topology, locked), dict[int, _Pivot]()
    for column in order:
        if column in by_column:
            _substitute(M, forces, column, by_column[column].e, [side.constants.get(column, ZERO) for side in sides])
        else:
            pivots[column] = _eliminate(M, forces, column, locked.get(column, FREE))
    solutions: list[dict[int, ca.SX]] = []
    for k, side in enumerate(sides):  # from the root to the tips
        found: dict[int, ca.SX] = {}
        for column in reversed(order):
            if column in pivots:
                total, weights = pivots[column].constants[k], pivots[column].weights
            else:
                total, weights = side.constants.get(column, ZERO), by_column[column].e
            for other, weight in weights.items():  # what is known last is waited for last
                total = add(total, mul(weight, found.get(other, ZERO)))
            found[column] = total
        solutions.append(found)
    return solutions


def _elimination_order(system: Condensed, topology: Topology, locked: Mapping[int, Lock]) -> list[int]:
    """All columns, from the tips to the root."""
    evaluated = {substitution.column: k for k, substitution in enumerate(system.substitutions)}
    follows = {one.column: one.e for one in system.substitutions}
    order: list[int] = []
    for body in sorted(system.reduced.body_columns, key=lambda name: -topology.distance_of(name)):
        columns = system.reduced.body_columns[body]
        dependent = sorted((c for c in columns if c in follows), key=lambda c: -evaluated[c])
        own = {other for c in dependent for other in follows[c]}
        own |= {other for c in own.intersection(columns, locked) for other in locked[c].e}
        independent = [c for c in reversed(columns) if c not in follows]
        # what the body's place does not depend on has no neighbours on the parent yet: its pivots are short
        order += [*(c for c in independent if c not in own), *dependent, *(c for c in independent if c in own)]
    return order


def _substitute(M: list[Row], forces: list[Row], d: int, e: Row, constants: Sequence[ca.SX]) -> None:
    """x_d'' = sum e_j x_j'' + c: rows j lose M_jd c and gain e_j times row d; constants: c by right-hand side."""
    for force, c in zip(forces, constants, strict=True):
        if not c.is_zero():
            for column, value in M[d].items():
                force[column] = sub(force.get(column, ZERO), mul(value, c))
        value = force.pop(d, ZERO)
        if not value.is_zero():
            for column, factor in e.items():
                force[column] = add(force.get(column, ZERO), mul(factor, value))
    if M[d]:
        congruence(M, d, e)


def _eliminate(M: list[Row], forces: list[Row], k: int, lock: Lock) -> _Pivot:
    """Gauss elimination of column k, which may be held."""
    row = M[k]
    M[k] = {}
    if k not in row:
        raise NoInertia(k)
    whole = dict(row)
    inverse = mul(lock.moves, div(ONE, row.pop(k)))
    values = [force.pop(k, ZERO) for force in forces]
    for column in row:
        M[column].pop(k, None)
    columns, weights = sorted(row), {}
    for position, i in enumerate(columns):
        factor = weights[i] = neg(mul(row[i], inverse))
        for force, value in zip(forces, values, strict=True):
            if not value.is_zero():
                force[i] = add(force.get(i, ZERO), mul(factor, value))
        for j in columns[position:]:
            add_to(M[i], j, mul(factor, row[j]))
            if i != j and j in M[i]:
                M[j][i] = M[i][j]
    constants = [mul(value, inverse) for value in values]
    if not lock.alone:
        held = sub(ONE, lock.moves)
        M[k] = {column: mul(held, value) for column, value in whole.items()}
        for force, value in zip(forces, values, strict=True):
            force[k] = mul(held, value)
        _substitute(M, forces, k, lock.e, [lock.c] * len(forces))
        for column, factor in lock.e.items():
            weights[column] = add(weights.get(column, ZERO), mul(held, factor))
        constants = [add(own, mul(held, lock.c)) for own in constants]
    return _Pivot(weights, constants)
