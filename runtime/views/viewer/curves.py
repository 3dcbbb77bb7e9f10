"""The curves beside the picture: energies, measures, coordinates, modes and joint forces, grouped by unit and body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.records import Coordinate

if TYPE_CHECKING:
    from runtime.results.solution import Solution

MOST = 8  # curves in a group, the largest first
KINDS = (
    ("angles", "angle", "rad"),
    ("travels", "position", "m"),
    ("independent Euler parameters", "euler_parameter", "1"),
)


@dataclass(frozen=True, eq=False)
class Curves:
    """Curves that share an axis: names, and values (curves, samples) in the unit."""

    title: str
    unit: str
    names: list[str]
    values: np.ndarray


def curves(solution: Solution) -> list[Curves]:
    """Groups that have something to show, in the order in which one looks at them."""
    energy = {name: solution.energy[name] for name in ("kinetic", "elastic", "potential")}
    energy = {name: values for name, values in energy.items() if np.any(values)} | {"total": solution.total_energy}
    groups = [Curves("energy", "J", list(energy), np.array(list(energy.values())))]
    model = solution.model
    for unit in dict.fromkeys(entry.unit for entry in model.description.measures if not entry.unit.endswith("/s")):
        names = [entry.name for entry in model.description.measures if entry.unit == unit]
        groups.append(_of(solution, "measures", unit, names))
    independent = [model.coordinate(name) for name in model.q_i]
    for title, kind, unit in KINDS:
        names = [entry.name for entry in independent if entry.kind == kind]
        if names:
            groups.append(_of(solution, title, unit, names))
    elastic: list[Coordinate] = [entry for entry in model.description.coordinates if entry.elastic]
    for body in dict.fromkeys(entry.owner for entry in elastic):
        names = [entry.name for entry in elastic if entry.owner == body]
        groups.append(_of(solution, f"{body}: modes", "m", names))
    if solution.joint_forces.size:
        forces = joint_force_vectors(solution)
        groups.append(_largest("joint forces", "N", list(model.joints), np.linalg.norm(forces, axis=2).T))
    return groups


def joint_force_vectors(solution: Solution) -> np.ndarray:
    """(N, joints, 3) world force of each joint on its body b [N]; the moment of a planar joint is left out."""
    forces = np.array(solution.joint_forces[:, :, :3], dtype=float)
    if solution.joint_forces.shape[2] == 3:
        forces[:, :, 2] = 0.0
    return forces


def _of(solution: Solution, title: str, unit: str, names: list[str]) -> Curves:
    """Curves of coordinates or measures; angles in degrees."""
    values = np.array([solution[name] for name in names])
    return _largest(title, "deg", names, np.degrees(values)) if unit == "rad" else _largest(title, unit, names, values)


def _largest(title: str, unit: str, names: list[str], values: np.ndarray) -> Curves:
    """At most MOST curves: those that reach farthest, in their own order."""
    order = np.sort(np.argsort(-np.abs(values).max(axis=1, initial=0.0), kind="stable")[:MOST])
    named = f"{title} ({MOST} of {len(names)})" if len(names) > MOST else title
    return Curves(named, unit, [names[k] for k in order], values[order])
