"""Stiff deflections: combinations s = B^T q_i of independent coordinates that a constant stiffness acts on.

A modal coordinate of a body is one, and so is the deflection of a spring that is linear in q_i, such as the angle
between the rotor and the link of a stiff joint. What is stiff is the deflection, not the coordinate: a spring between
two angles turns both of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE
from symgen.choice.elimination import Elimination
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations


@dataclass(frozen=True)
class Deflections:
    """rows: B^T by column of q, each a deflection; K, D: stiffness and damping between them, n_s x n_s [SI]."""

    rows: list[Row]
    K: ca.SX
    D: ca.SX


def deflections_of(equations: Equations, choice: Elimination, wanted: tuple[str, ...] | None) -> Deflections | None:
    """Those of the elastic coordinates and linear springs that stand in q_i; None if there are none.

    wanted: names or patterns of them, None for all. Raises DerivationError for one that stands for nothing.

    A coordinate with a constant stiffness of its own counts as elastic, as those of a linear structure do. Springs
    whose deflection depends on dependent coordinates are left out: B would follow the motion.
    """
    modes = {equations.names[column]: column for column in choice.independent if column in equations.K[column]}
    within = {name: one for name, one in equations.springs.items() if _within(one.row, choice.independent)}
    chosen = _chosen([*modes, *within], wanted)
    elastic = [column for name, column in modes.items() if name in chosen]
    springs = [spring for name, spring in within.items() if name in chosen]
    rows: list[Row] = [*({column: ONE} for column in elastic), *(spring.row for spring in springs)]
    if not rows:
        return None
    K, D = ca.SX(len(rows), len(rows)), ca.SX(len(rows), len(rows))  # sparse while they are filled
    place = {column: k for k, column in enumerate(elastic)}
    for i, row in enumerate(elastic):
        for column, value in equations.K[row].items():
            if column in place:
                K[i, place[column]] = value
    for i, j, value in _damping(equations, elastic):
        D[i, j] = value
    for k, spring in enumerate(springs, start=len(elastic)):
        K[k, k], D[k, k] = spring.stiffness, spring.damping
    return Deflections(rows, ca.densify(K), ca.densify(D))


def _damping(equations: Equations, elastic: list[int]) -> Iterator[tuple[int, int, ca.SX]]:
    """Entries of the constant damping between elastic coordinates."""
    if not elastic:
        return
    rates = ca.vertcat(*(equations.q_dot[column] for column in elastic))
    forces = ca.vertcat(*(equations.Q_F[column] for column in elastic))
    damping = -ca.jacobian(forces, rates)
    moving = ca.vertcat(*equations.q, *equations.q_dot, equations.t, *equations.u.values())
    for i, j in zip(*damping.sparsity().get_triplet(), strict=True):
        if not ca.depends_on(damping[i, j], moving):
            yield i, j, damping[i, j]


def _chosen(names: list[str], wanted: tuple[str, ...] | None) -> list[str]:
    if wanted is None:
        return names
    for pattern in wanted:
        if not any(fnmatchcase(name, pattern) for name in names):
            raise DerivationError(
                "partition.stiff",
                f"'{pattern}' is no elastic coordinate and no rotational spring between independent coordinates",
                f"choose among {', '.join(names)}" if names else "leave it out",
            )
    return [name for name in names if any(fnmatchcase(name, pattern) for pattern in wanted)]


def _within(row: Row, independent: list[int]) -> bool:
    """Is a row constant, and does it stand in q_i?"""
    return all(column in independent and value.is_constant() for column, value in row.items())
