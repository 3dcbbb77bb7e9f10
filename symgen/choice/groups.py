"""Groups of independent coordinates from slow to fast (Eqs. 39, 72). They are data of the scene."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase

from runtime.contract.records import Group
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
    for turning in equations.turnings:
        own = {
            next(g for g, group in enumerate(groups) if names.index(equations.names[c]) in group.positions)
            for c in turning.columns
            if equations.names[c] in names
        }
        if len(own) > 1:
            raise DerivationError(
                "partition.groups",
                f"the turns of {turning.body} are in different groups",
                f"put {turning.body}.turn_x, _y and _z into one: an orientation moves as a whole",
            )
    empty = [group.name for group in groups if not group.positions]
    if empty:
        raise DerivationError(
            "partition.groups",
            f"group {empty[0]} holds no independent coordinate (they are {', '.join(names)})",
            "name independent coordinates or drop the group",
        )
    return groups
