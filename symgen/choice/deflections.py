"""Stiff deflections: combinations s = B^T q_i of independent coordinates that a constant stiffness acts on.

A modal coordinate of a body is one, and so is the deflection of a spring that is linear in q_i, such as the angle
between the rotor and the link of a stiff joint. What is stiff is the deflection, not the coordinate: a spring between
two angles turns both of them.

Groups of independent coordinates from slow to fast (Eqs. 39, 72). They are data of the scene.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

import casadi as ca

from runtime.contract.records import Group
from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE
from symgen.choice.elimination import Elimination
from symgen.system.build import RequestedGroup, System
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations


def choose_groups(system: System, independent: list[int]) -> list[Group]:
    """The requested groups, or by default rigid (L) and elastic (S), of (39); positions are in q_i = `independent`.

    Raises DerivationError if they do not fit q_i or the step ratios m.
    """
    equations, requested = system.reduced, system.requested
    names = [equations.names[column] for column in independent]
    groups = _as_requested(requested.groups, names, equations) if requested.groups else _by_kind(equations, independent)
    ratios = requested.ratios
    if ratios and len(ratios) != len(groups) - 1:
        raise DerivationError(
            "simulation.m",
            f"has {len(ratios)} step ratios for {len(groups)} groups ({', '.join(group.name for group in groups)})",
            "give one for each group after the first",
        )
    return groups


def _by_kind(equations: Equations, independent: list[int]) -> list[Group]:
    """L = rigid coordinates, S = elastic ones; one group if either is empty, none of nothing."""
    rigid = [k for k, column in enumerate(independent) if column not in equations.elastic_columns]
    elastic = [k for k, column in enumerate(independent) if column in equations.elastic_columns]
    if not independent:
        return []
    if not rigid or not elastic:
        return [Group("all", list(range(len(independent))))]
    return [Group("L", rigid), Group("S", elastic)]


def _as_requested(requested: Sequence[RequestedGroup], names: list[str], equations: Equations) -> list[Group]:
    groups = [
        Group(
            group.name,
            [k for k, name in enumerate(names) if any(fnmatchcase(name, pattern) for pattern in group.patterns)],
        )
        for group in requested
    ]
    grouped = [k for group in groups for k in group.positions]
    states = {equations.names[column] for column in equations.states.values()}
    left = [k for k, name in enumerate(names) if k not in grouped and name in states]
    groups[0].positions.extend(left)  # controllers step with the slowest group unless the scene says otherwise
    grouped += left
    missing = [name for k, name in enumerate(names) if k not in grouped]
    if missing:
        raise DerivationError(
            "partition.groups", f"independent coordinates in no group: {', '.join(missing)}", "add them to a group"
        )
    for rotation in equations.rotation_vectors:
        own = {
            next(g for g, group in enumerate(groups) if names.index(equations.names[c]) in group.positions)
            for c in rotation.columns
            if equations.names[c] in names
        }
        if len(own) > 1:
            raise DerivationError(
                "partition.groups",
                f"the turns of {rotation.body} are in different groups",
                f"put {rotation.body}.turn_x, _y and _z into one: an orientation moves as a whole",
            )
    empty = [group.name for group in groups if not group.positions]
    if empty:
        raise DerivationError(
            "partition.groups",
            f"group {empty[0]} holds no independent coordinate (they are {', '.join(names)})",
            "name independent coordinates or drop the group",
        )
    return groups


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
                f"'{pattern}' is neither an elastic coordinate nor a rotational spring between independent coordinates",
                f"choose among {', '.join(names)}" if names else "leave it out",
            )
    return [name for name in names if any(fnmatchcase(name, pattern) for pattern in wanted)]


def _within(row: Row, independent: list[int]) -> bool:
    """Is a row constant, and does it stand in q_i?"""
    return all(column in independent and value.is_constant() for column, value in row.items())
