"""The curves of a run in groups that share an axis: by unit and body, in the order in which one looks at them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.records import Coordinate
from runtime.results.friction import friction_columns, friction_units, rubbing, stopping
from runtime.views.mechanism import scenery

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

STILL = 1e-12  # m or rad: what moves less than this against its own size has nothing to show
OWN_AXIS_RATIO = 20.0  # times as far as another moves a curve that gets an axis of its own
SAME_CURVE = 1e-9  # of a curve's size, by which it differs from one that covers it
# colours of Okabe and Ito, told apart with every usual kind of colour vision; black is kept for totals
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#6a4c93")
SPECIALS = {"fold": "#d1495b", "flip": "#2e7d32", "Neimark-Sacker": "#7b1fa2", "branch point": "#ef6c00"}
SMALL = 1e-3  # of the largest modal coordinate of a body: what stays below is left out


@dataclass(frozen=True, eq=False)
class Curves:
    """Curves that share an axis: names, values (curves, samples) in the SI unit; of: how many there would be."""

    title: str
    unit: str
    names: list[str]
    values: np.ndarray
    of: int = 0

    def largest(self, most: int) -> Curves:
        """At most so many curves: those that reach farthest, in their own order."""
        if len(self.names) <= most:
            return self
        order = np.sort(np.argsort(-np.abs(self.values).max(axis=1, initial=0.0), kind="stable")[:most])
        return replace(self, names=[self.names[k] for k in order], values=self.values[order], of=len(self.names))

    def merged(self) -> Curves:
        """Curves that are the same to rounding as one, by all their names: one would hide the other."""
        groups: list[list[int]] = []
        for k, values in enumerate(self.values):
            size = float(np.abs(values).max(initial=0.0))
            same = (own for own in groups if np.abs(self.values[own[0]] - values).max(initial=0.0) <= SAME_CURVE * size)
            found = next(same, None)
            groups.append([k]) if found is None else found.append(k)
        names = [", ".join(self.names[k] for k in own) for own in groups]
        return replace(self, names=names, values=self.values[[own[0] for own in groups]])

    def by_span(self) -> list[Curves]:
        """Curves that move about as far share an axis: what moves by millimetres does not show beside metres."""
        spans = np.ptp(self.values, axis=1) if self.values.size else np.zeros(len(self.names))
        order = np.argsort(-spans, kind="stable")
        parts = np.split(order, np.flatnonzero(spans[order[:-1]] > OWN_AXIS_RATIO * spans[order[1:]]) + 1)
        return [
            replace(self, names=[self.names[k] for k in own], values=self.values[own]) for own in map(np.sort, parts)
        ]

    @property
    def heading(self) -> str:
        """The title, with how many of how many are shown."""
        return f"{self.title} ({len(self.names)} of {self.of})" if self.of > len(self.names) else self.title


def energy(solution: Solution) -> Curves:
    """Kinetic, elastic and potential energy that are there, and the total."""
    parts = {name: solution.energy[name] for name in ("kinetic", "elastic", "potential")}
    largest = max(float(np.abs(values).max(initial=0.0)) for values in parts.values())
    parts = {name: values for name, values in parts.items() if np.abs(values).max(initial=0.0) > STILL * largest}
    parts["total"] = solution.total_energy
    return Curves("energy", "J", list(parts), np.array(list(parts.values())))


def motion(solution: Solution) -> list[Curves]:
    """Angles, travels and measures. Euler parameters and coordinates that follow from others are left out.

    In a plane all angles of bodies are shown, in space those of joints and of bodies that have angles.
    """
    model = solution.model
    owners = {joint.name for joint in model.description.joints}
    records = [entry for entry in _moving(solution) if not entry.elastic]
    angles = [entry for entry in records if entry.kind == "angle"]
    travels = [entry for entry in records if entry.kind == "position"]
    travels = [entry for entry in travels if entry.owner in owners or entry.name in model.q_i]
    groups = [_group(solution, "angles", angles), _group(solution, "travels", travels), *_measures(solution)]
    return [part for group in groups if group.names for part in group.by_span()]


def _measures(solution: Solution) -> list[Curves]:
    """Of each unit; rates of other measures, and whether a stop is closed, are left out."""
    described = solution.model.description.measures
    rates = {f"{entry.name}_dot" for entry in described}
    stops = {event.mode for event in solution.model.mode_events if event.side}
    measures = [entry for entry in described if entry.name not in rates | stops]
    groups = []
    for unit in dict.fromkeys(entry.unit for entry in measures):
        names = [entry.name for entry in measures if entry.unit == unit]
        groups.append(Curves("measures", unit, names, np.array([solution[name] for name in names])))
    return groups


def every_motion(solution: Solution) -> list[Curves]:
    """All coordinates that move, and measures: angles, positions, Euler parameters, measures, modes of each body."""
    records = _moving(solution) or list(solution.model.description.coordinates)
    groups = [
        _group(solution, title, [entry for entry in records if entry.kind == kind])
        for title, kind in (("angles", "angle"), ("positions", "position"), ("Euler parameters", "euler_parameter"))
    ]
    groups += [part for group in _measures(solution) for part in group.by_span()]
    return [group for group in groups if group.names] + _modes(solution, records, "deformation")


def deformation(solution: Solution) -> list[Curves]:
    """Modal coordinates of each body, small ones left out, and the largest deflection of its drawn points."""
    groups = []
    for group in _modes(solution, solution.model.description.coordinates, "modal coordinates"):
        size = np.abs(group.values).max(axis=1, initial=0.0)
        kept = np.flatnonzero(size > SMALL * size.max(initial=0.0))
        names = [f"q{k + 1}" for k in kept]
        groups.append(replace(group, names=names, values=group.values[kept], of=len(group.names)))
    deflections = drawn_deflections(solution) if groups else {}
    if deflections:
        values = np.array(list(deflections.values()))
        groups.append(Curves("largest deflection of drawn points", "m", list(deflections), values))
    return [group for group in groups if group.names]


def forces(solution: Solution) -> list[Curves]:
    """Size of the force of each joint and load; of its moment in space, or the moment itself about z in a plane.

    Behind them what the motors of prescribed motions give, along the motion, and friction in joints with its heat.
    """
    loads = [load.name for load in solution.model.description.loads]
    return [
        *_forces("joint", list(solution.model.joints), solution.joint_forces),
        *_forces("load", loads, solution.load_forces),
        *_motors(solution),
        *_frictions(solution),
    ]


def _frictions(solution: Solution) -> list[Curves]:
    """Along the coordinates of joints with friction, the heat that it makes, and forces of stops."""
    model, columns, found = solution.model, friction_columns(solution), list[Curves]()
    kinds = [(f"{part} of friction", rubbing(model), f"friction_{part}") for part in ("force", "heat")]
    units = friction_units(model)
    for title, joints, part in [*kinds, ("force of stops", stopping(model), "stop_force")]:
        names = {joint: f"{joint}.{part}" for joint in joints}
        for unit in dict.fromkeys(units[name] for name in names.values()):
            own = {joint: columns[name] for joint, name in names.items() if units[name] == unit}
            found.append(Curves(title, unit, list(own), np.array(list(own.values()))))
    return found


def _motors(solution: Solution) -> list[Curves]:
    """Torques and forces of prescribed motions."""
    described = solution.model.description
    drives = {joint.name for joint in described.joints if joint.drawing == "drive"}
    found = []
    for kind, title, unit in (("angle", "motor torques", "N m"), ("distance", "motor forces", "N")):
        names = [row.joint for row in described.constraints if row.joint in drives and row.kind == kind]
        if names:
            found.append(Curves(title, unit, names, np.array([solution.motor(name) for name in names])))
    return found


def _forces(what: str, names: list[str], every: np.ndarray) -> list[Curves]:
    """Those of `every` (N, names, 3 or 6) that are not zero throughout."""
    if not every.size:
        return []
    sizes = np.linalg.norm(force_vectors(every), axis=2).T
    moments = every[:, :, 2].T if every.shape[2] == 3 else np.linalg.norm(every[:, :, 3:], axis=2).T
    title = f"{what} moments about z" if every.shape[2] == 3 else f"{what} moments |M|"
    turning = np.abs(moments).max(axis=1, initial=0.0) > 1e-9 * max(float(np.abs(moments).max()), 1e-300)
    pulling = np.abs(sizes).max(axis=1, initial=0.0) > 1e-9 * max(float(np.abs(sizes).max()), 1e-300)
    pulled = [name for name, pulls in zip(names, pulling, strict=True) if pulls]
    groups = [Curves(f"{what} forces |F|", "N", pulled, sizes[pulling])] if pulled else []
    acting = [name for name, turns in zip(names, turning, strict=True) if turns]
    return groups + ([Curves(title, "N m", acting, moments[turning])] if acting else [])


def force_vectors(every: np.ndarray) -> np.ndarray:
    """(N, parts, 3) the world forces [N] in `every` (N, parts, 3 or 6), without the moments."""
    found = np.array(every[:, :, :3], dtype=float)
    if every.shape[2] == 3:
        found[:, :, 2] = 0.0
    return found


def moment_vectors(every: np.ndarray) -> np.ndarray:
    """(N, parts, 3) the world moments [N m] in `every` (N, parts, 3 or 6)."""
    if every.shape[2] == 6:
        return np.array(every[:, :, 3:], dtype=float)
    return np.stack([0 * every[:, :, 2], 0 * every[:, :, 2], every[:, :, 2]], axis=-1)


def moves(values: np.ndarray, size: float = 1e-3) -> bool:
    """Does a coordinate, values (N,), change by more than rounding, of the largest value and at least of `size`?"""
    return bool(np.ptp(values) > STILL * max(size, float(np.abs(values).max())))


def _moving(solution: Solution) -> list[Coordinate]:
    """Those that move, angles by more than the rounding of a radian."""
    sizes = {"angle": 1.0}
    return [
        entry
        for entry in solution.model.description.coordinates
        if moves(solution[entry.name], sizes.get(entry.kind, 1e-3))
    ]


def _group(solution: Solution, title: str, entries: list[Coordinate]) -> Curves:
    names = [entry.name for entry in entries]
    unit = entries[0].unit if entries else ""
    return Curves(title, unit, names, np.array([solution[name] for name in names]))


def _modes(solution: Solution, records: list[Coordinate], what: str) -> list[Curves]:
    elastic = [entry for entry in records if entry.elastic]
    return [
        _group(solution, f"{body}: {what}", [entry for entry in elastic if entry.owner == body])
        for body in dict.fromkeys(entry.owner for entry in elastic)
    ]


def drawn_deflections(solution: Solution) -> dict[str, np.ndarray]:
    """(N,) of each flexible body: the largest displacement of its points that its joints do not make [m]."""
    if not solution.model.has("geometry"):
        return {}
    shown = scenery(solution, solution.t)
    found = {}
    for body, follow in zip(shown.bodies, shown.follow, strict=True):
        points = body.stations if body.stations.names else body.markers
        if not body.elastic or not points.names:
            continue
        q_f = shown.q_f(body)
        own = np.linalg.norm(points.linear(q_f) - follow.displacement(points.position, q_f), axis=2).max(axis=1)
        if own.max() > STILL * shown.size():
            found[body.name] = own
    return found
