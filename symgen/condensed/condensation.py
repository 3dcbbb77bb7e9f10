"""Condensation to independent (minimal) coordinates along the structure (Eqs. 29-38).

Every dependent acceleration is one substitution  x_d'' = sum e_j x_j'' + c.  With S collecting the e and s the c,
M_hat = S^T M S and Q_hat = S^T (Q* - M s). Neither S nor an inverse is ever formed: M_hat comes from one congruence
per substitution (tip to root, which is the composite-body recursion for a chain), Q_hat from one sweep out and one
back. Loop closures are solved block by block and then are substitutions like any other.

The DAE of index 3 becomes an ordinary differential equation so (index reduction by coordinate partitioning, Wehage &
Haug 1982): the columns of S span the null space of the constraint Jacobian C_q, onto which the equations are projected.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to, nonzero
from symgen.algebra.scalar import ZERO, add, div, mul, neg, sub
from symgen.choice.deflections import Deflections
from symgen.choice.elimination import Elimination
from symgen.condensed.loops import Loops, ReducedRow, order_blocks, solve_block
from symgen.system.equations import Equations


@dataclass(frozen=True)
class Substitution:
    """x_d' = sum e_j x_j' + c_velocity and x_d'' = sum e_j x_j'' + c_acceleration (Eqs. 36, 35)."""

    column: int
    e: Row
    c_velocity: ca.SX
    c_acceleration: ca.SX


@dataclass(frozen=True)
class Condensed:
    """A system with its substitutions, in the order of evaluation (independent coordinates to the tips).

    equations: in all coordinates; reduced: without those of placed bodies' frames, which nothing below
    needs but the forces that depend on `felt_columns`.
    deflections: the stiff ones among its coordinates.
    """

    equations: Equations
    reduced: Equations
    choice: Elimination
    substitutions: list[Substitution]
    loops: Loops
    deflections: Deflections | None = None

    @cached_property
    def inner(self) -> list[Substitution]:
        """The substitutions between coordinates that have masses or constraints, or that forces depend on."""
        left_out = self.reduced.placed_columns - self.reduced.felt_columns
        return [s for s in self.substitutions if s.column not in left_out]

    def dependent_velocities(self, independent: Mapping[int, ca.SX]) -> dict[int, ca.SX]:
        """q_dot of every coordinate from q_i_dot (Eq. 36)."""
        return _sweep(independent, self.substitutions, [s.c_velocity for s in self.substitutions])

    def accelerations(self, independent: Mapping[int, ca.SX]) -> dict[int, ca.SX]:
        """q_ddot of every coordinate from q_i_ddot (Eq. 35)."""
        return _sweep(independent, self.substitutions, [s.c_acceleration for s in self.substitutions])

    def following(self, independent: Row, changes: Sequence[ca.SX]) -> Row:
        """x of C_q x = -changes by column, changes by constraint row, for the given entries of x."""
        rows = zip(self.reduced.constraints, changes, strict=True)
        changed = replace(self.reduced, constraints=[replace(row, gamma=neg(change)) for row, change in rows])
        return condense(self.equations, changed, self.choice).accelerations(independent)

    def M_hat(self) -> ca.SX:
        """M_hat = S^T M S of Eq. (38), dense n_i x n_i."""
        M = [dict(row) for row in self.reduced.M]
        for substitution in reversed(self.inner):
            congruence(M, substitution.column, substitution.e)
        independent = self.choice.independent
        columns = [M[row].get(column, ZERO) for column in independent for row in independent]
        return ca.densify(ca.reshape(ca.vertcat(*columns), len(independent), len(independent)))

    def generalised_force(self, accelerations: Mapping[int, ca.SX]) -> ca.SX:
        """S^T (Q* - M x'') for the x'' that `accelerations` of some q_i imply: Q_hat of Eq. (38) when all are zero.

        With the slow accelerations given, it is the right-hand side of a sub-step (Eq. 64) without forming
        M_hat_SL.
        """
        constants = [s.c_acceleration for s in self.inner]
        return self.project(dict(enumerate(self.reduced.force(_sweep(accelerations, self.inner, constants)))))

    def projected(self, force: Row) -> Row:
        """S^T force by column, S of (29)-(30)."""
        work = dict(force)
        for substitution in reversed(self.inner):
            value = work.pop(substitution.column, ZERO)
            if not value.is_zero():
                add_scaled(work, value, substitution.e)
        return work

    def project(self, force: Row) -> ca.SX:
        """S^T force: a generalised force on q as one on q_i."""
        work = self.projected(force)
        return ca.densify(ca.vertcat(*(work.get(column, ZERO) for column in self.choice.independent)))


def _sweep(
    independent: Mapping[int, ca.SX], substitutions: list[Substitution], constants: list[ca.SX]
) -> dict[int, ca.SX]:
    values = dict(independent)
    for substitution, constant in zip(substitutions, constants, strict=True):
        total = constant
        for column, factor in substitution.e.items():
            if column in values:
                total = add(total, mul(factor, values[column]))
        if not total.is_zero():
            values[substitution.column] = total
    return values


def congruence(M: list[Row], d: int, e: Row) -> None:
    """M <- E^T M E for x_d = sum e_j x_j, in place; row and column d vanish."""
    row = M[d]
    M[d] = {}
    M_dd = row.pop(d, ZERO)
    for column in row:
        M[column].pop(d, None)
    carried = {j: add(row.get(j, ZERO), mul(e_j, M_dd)) for j, e_j in e.items()}
    for i, e_i in e.items():
        for j, value in row.items():
            if j not in e:
                _add_symmetric(M, i, j, mul(e_i, value))
        for j, e_j in e.items():
            if i <= j:
                _add_symmetric(M, i, j, add(mul(e_i, carried[j]), mul(e_j, row.get(i, ZERO))))


def _add_symmetric(M: list[Row], i: int, j: int, value: ca.SX) -> None:
    add_to(M[i], j, value)
    if i != j and j in M[i]:
        M[j][i] = M[i][j]


def condense(
    equations: Equations, reduced: Equations, choice: Elimination, deflections: Deflections | None = None
) -> Condensed:
    """Substitutions for every dependent coordinate of the choice: (34) solved for it, so that (32)-(33) become (38).

    equations, reduced, deflections: as in `Condensed`.
    """
    structural = [_structural(reduced, row, column) for row, column in choice.structural]
    rows = _reduced_rows(reduced, choice, structural)
    entries = {row: _with_all_turns(reduced, one.entries) for row, one in rows.items()}
    loops = Loops(order_blocks(choice.loop_rows, choice.loop_columns, entries), rows)
    return Condensed(equations, reduced, choice, _loop_substitutions(loops) + structural, loops, deflections)


def _with_all_turns(equations: Equations, entries: Row) -> Row:
    """Entries of a row, with all turns of a body where there is one: away from zero theta they come together."""
    found = dict(entries)
    for rotation in equations.rotation_vectors:
        own = [column for column in rotation.columns if column in entries]
        found |= {column: found.get(column, entries[own[0]]) for column in rotation.columns if own}
    return found


def _structural(equations: Equations, row: int, column: int) -> Substitution:
    constraint = equations.constraints[row]
    pivot = constraint.C_q[column]
    e = {c: div(neg(value), pivot) for c, value in constraint.C_q.items() if c != column}
    return Substitution(column, e, div(neg(constraint.C_t), pivot), div(constraint.gamma, pivot))


def _reduced_rows(equations: Equations, choice: Elimination, structural: list[Substitution]) -> dict[int, ReducedRow]:
    """Loop rows of C_q, nu and gamma in the coordinates that are not structurally eliminated."""
    result = {}
    for row in choice.loop_rows:
        constraint = equations.constraints[row]
        entries, nu, gamma = dict(constraint.C_q), neg(constraint.C_t), constraint.gamma
        for substitution in reversed(structural):
            factor = entries.pop(substitution.column, None)
            if factor is not None:
                add_scaled(entries, factor, substitution.e)
                nu = sub(nu, mul(factor, substitution.c_velocity))
                gamma = sub(gamma, mul(factor, substitution.c_acceleration))
        result[row] = ReducedRow(nonzero(entries), nu, gamma)
    return result


def _loop_substitutions(loops: Loops) -> list[Substitution]:
    """x_block'' = U^-1 (gamma - R x''): each block is solved whole, so that only a singular position is singular."""
    substitutions = []
    for block in loops.blocks:
        e, c_velocity, c_acceleration = solve_block(block, loops)
        substitutions += [
            Substitution(column, e[column], c_velocity[k], c_acceleration[k]) for k, column in enumerate(block.columns)
        ]
    return substitutions
