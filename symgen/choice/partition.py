"""Groups of independent coordinates from slow to fast (Eqs. 39, 72). The partition is data of the scene."""

from __future__ import annotations

from dataclasses import dataclass
from fnmatch import fnmatchcase

from symgen.scene import Scene, SceneError
from symgen.system.equations import Equations


@dataclass(frozen=True)
class Group:
    """A group: its name and the positions of its coordinates in q_i."""

    name: str
    positions: list[int]


def choose_groups(scene: Scene, equations: Equations, independent: list[int]) -> list[Group]:
    """The scene's groups, or by default rigid (L) and elastic (S). Raises SceneError if they do not fit q_i or m."""
    names = [equations.names[column] for column in independent]
    groups = _from_scene(scene, names) if scene.partition.groups else _by_kind(equations, independent)
    ratios = scene.simulation.m
    if ratios and len(ratios) != len(groups) - 1:
        raise SceneError(
            "simulation.m",
            f"has {len(ratios)} step ratios for {len(groups)} groups ({', '.join(group.name for group in groups)})",
            "give one for each group after the first",
        )
    return groups


def _by_kind(equations: Equations, independent: list[int]) -> list[Group]:
    """L = rigid coordinates, S = elastic ones; one group if either is empty."""
    rigid = [k for k, column in enumerate(independent) if column not in equations.elastic_columns]
    elastic = [k for k, column in enumerate(independent) if column in equations.elastic_columns]
    if not rigid or not elastic:
        return [Group("all", list(range(len(independent))))]
    return [Group("L", rigid), Group("S", elastic)]


def _from_scene(scene: Scene, names: list[str]) -> list[Group]:
    groups = [
        Group(
            group.name,
            [k for k, name in enumerate(names) if any(fnmatchcase(name, pattern) for pattern in group.coordinates)],
        )
        for group in scene.partition.groups or []
    ]
    grouped = [k for group in groups for k in group.positions]
    missing = [name for k, name in enumerate(names) if k not in grouped]
    if missing:
        raise SceneError(
            "partition.groups", f"independent coordinates in no group: {', '.join(missing)}", "add them to a group"
        )
    empty = [group.name for group in groups if not group.positions]
    if empty:
        raise SceneError(
            "partition.groups",
            f"group {empty[0]} holds no independent coordinate (they are {', '.join(names)})",
            "name independent coordinates or drop the group",
        )
    return groups
