"""Stiff deflections: combinations s = B^T q_i of independent coordinates that a constant stiffness acts on.

A modal coordinate of a body is one, and so is the deflection of a spring that is linear in q_i, such as the angle
between the rotor and the link of a stiff joint. What is stiff is the deflection, not the coordinate: a spring between
two angles turns both of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from fnmatch import fnmatchcase

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO
from symgen.choice.elimination import Elimination
from symgen.system.equations import Equations
from symgen.system.errors import DerivationError


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
    rates = ca.vertcat(*(equations.q_dot[column] for column in elastic))
    forces = ca.vertcat(*(equations.Q_F[column] for column in elastic))
    damping = -ca.jacobian(forces, rates) if elastic else ca.SX(0, 0)
    moving = ca.vertcat(*equations.q, *equations.q_dot, equations.t, *equations.u.values())
    K, D = ca.SX.zeros(len(rows), len(rows)), ca.SX.zeros(len(rows), len(rows))
    for i, row in enumerate(elastic):
        for j, column in enumerate(elastic):
            K[i, j] = equations.K[row].get(column, ZERO)
            if not ca.depends_on(damping[i, j], moving):
                D[i, j] = damping[i, j]
    for k, spring in enumerate(springs, start=len(elastic)):
        K[k, k], D[k, k] = spring.stiffness, spring.damping
    return Deflections(rows, K, D)


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
