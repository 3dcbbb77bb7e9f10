"""Coordinates named in the partition and the initial state, and the step ratios that go with the groups."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase

from runtime.contract.orientations import angle_names
from runtime.contract.records import GROUPED_SCHEMES
from symgen.scene.parts import SceneParts
from symgen.scene.simulation import MAX_STEPS
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean


def matching(pattern: str, names: Sequence[str]) -> list[str]:
    """The names that a coordinate name or a pattern with * and ? stands for, in the order of ``names``."""
    return [name for name in names if fnmatchcase(name, pattern)]


def partition_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Unknown coordinates, coordinates in two groups, step ratios and steps that do not fit."""
    names = scene.coordinates()
    turning = [body.name for body in scene.moving_bodies] if scene.space == "spatial" else []
    spins = [f"{body}.omega_{axis}" for body in turning for axis in "xyz"]
    angles = [name for body in scene.euler_angles() for name in angle_names(body)]
    for section, known in (("coordinates", [*names, *angles]), ("rates", [*names, *angles, *spins])):
        for name in getattr(scene.initial, section):
            if name not in known:
                yield _unknown(f"initial.{section}['{name}']", name, known)
    yield from _angles_twice(scene)
    for index, measure in enumerate(scene.measures):
        if measure.type == "coordinate" and measure.of not in [*names, *angles]:
            yield _unknown(f"{item_path('measures', index, measure.name)}.of", measure.of, names)
    names = [*names, *(f"{body}.turn_{axis}" for body in turning for axis in "xyz")]
    independent = scene.partition.independent
    for index, name in enumerate(independent or ()):
        path = f"partition.independent[{index}]"
        if name in angles:
            yield _angle_error(path, name)
        elif name not in names:
            yield _unknown(path, name, names)
        elif independent and name in independent[:index]:
            yield SceneError(path, f"'{name}' is there twice", "remove one of them")
    if independent is not None and not independent:
        yield SceneError("partition.independent", "is empty", "name coordinates, or leave it out to have them chosen")
    yield from _groups(scene, names, angles)
    yield from _steps(scene)


def _angles_twice(scene: SceneParts) -> Iterator[SceneError]:
    """An orientation, and how it turns, is given in one way: by angles, Euler parameters or angular velocities."""
    for body in scene.euler_angles():
        parameters = {f"{body}.e{k}" for k in range(4)}
        others = {"coordinates": parameters, "rates": parameters | {f"{body}.omega_{axis}" for axis in "xyz"}}
        for section, other in others.items():
            given = getattr(scene.initial, section).keys()
            both = [next((name for name in names if name in given), "") for names in (angle_names(body), sorted(other))]
            if all(both):
                what = "how the body is turned" if section == "coordinates" else "how the body turns"
                yield SceneError(
                    f"initial.{section}['{both[0]}']", f"'{both[1]}' says {what} too", "give one or the other"
                )


def _angle_error(path: str, name: str) -> SceneError:
    body = name.partition(".")[0]
    return SceneError(
        path,
        f"'{name}' is an Euler angle, which is input and output only",
        f"the coordinates are {body}.turn_x, _y, _z, or those of the joint that places the body",
    )


def _groups(scene: SceneParts, names: list[str], angles: list[str]) -> Iterator[SceneError]:
    independent = scene.partition.independent
    owner: dict[str, str] = {}
    for index, group in enumerate(scene.partition.groups or ()):
        path = item_path("partition.groups", index, group.name)
        if not group.coordinates:
            yield SceneError(f"{path}.coordinates", "is empty", "name at least one coordinate, or remove the group")
        for position, pattern in enumerate(group.coordinates):
            item = f"{path}.coordinates[{position}]"
            found = matching(pattern, names)
            if not found and matching(pattern, angles):
                yield _angle_error(item, matching(pattern, angles)[0])
            elif not found:
                yield _unknown(item, pattern, names)
            elif independent is not None and not set(found) & set(independent):
                yield SceneError(item, f"'{pattern}' is not independent", "add it to partition.independent")
            for name in found:
                if name in owner:
                    where = f"in group '{owner[name]}' already"
                    yield SceneError(item, f"'{name}' is {where}", "let each coordinate belong to one group")
                    break
            owner.update(dict.fromkeys(found, group.name))


def _steps(scene: SceneParts) -> Iterator[SceneError]:
    simulation, groups = scene.simulation, scene.partition.groups
    for key in ("t_end", "dt"):
        if getattr(simulation, key) <= 0:
            yield SceneError(f"simulation.{key}", f"{getattr(simulation, key)!r} is not positive", "give a time in s")
    if simulation.t_end > 0 and simulation.dt > 0:
        if simulation.dt > simulation.t_end:
            yield SceneError("simulation.dt", "is longer than the simulation", "give a step below t_end")
        elif simulation.t_end / MAX_STEPS > simulation.dt:
            yield SceneError("simulation.dt", f"needs more than {MAX_STEPS:.0e} steps", "raise dt or lower t_end")
    if groups is not None and not groups:
        yield SceneError("partition.groups", "is empty", "give groups, or leave it out")
    if groups is None:
        return  # the derivation chooses the groups and checks m then
    wanted = max(len(groups) - 1, 0)
    one_step = simulation.scheme not in GROUPED_SCHEMES or simulation.tolerance is not None
    needless = one_step and not simulation.m
    if len(simulation.m) != wanted and not needless:
        yield SceneError(
            "simulation.m",
            f"has {len(simulation.m)} step ratios for {len(groups)} groups",
            f"give {wanted}: one for each group after the first, slow to fast",
        )


def _unknown(path: str, name: str, names: list[str]) -> SceneError:
    problem = f"there is no coordinate '{name}'"
    if "*" in name or "?" in name:
        problem = f"the pattern '{name}' matches no coordinate"
    return SceneError(path, problem, did_you_mean(name, names))
