"""What a beam's ends carry, seen from the joints and loads at them, and the mode sets that follow from it.

An end carries a force, a moment, both or nothing, in each plane of bending. That decides which shapes the beam needs
(runtime/contract/beams/end_shapes.py), unless the scene names `ends` itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple, TypeVar

from symgen.scene.bodies import BeamBody, BeamMarker, MarkerDirections
from symgen.scene.joints import Joint
from symgen.scene.loads import Load
from symgen.scene.parts import SceneParts

AnyScene = TypeVar("AnyScene", bound=SceneParts)
# a moment about it bends in that plane, or twists
NORMALS = {"lateral": (0.0, 0.0, 1.0), "lateral_z": (0.0, 1.0, 0.0), "torsion": (1.0, 0.0, 0.0)}
ALIGNED = 1e-9  # squared sine of the angle between two directions that are taken for one
LATERAL = {
    ("welded", "free"): "clamped-free",
    ("free", "welded"): "free-clamped",
}
AXIAL = {(True, True): "fixed-loaded", (True, False): "fixed-free", (False, True): "free-fixed"}
FREE_ROTATION = {"revolute": "z", "cylindrical": "z", "universal": "zx"}  # about the z of marker a, the x of marker b
FORCES_ONLY = ("spherical", "distance", "spring_damper", "force")


class Carried(NamedTuple):
    """What one end carries: a force, a moment; free_about: the direction about which that moment is none, if any."""

    force: bool
    moment: bool
    free_about: tuple[float, ...] | None = None


def with_ends(scene: AnyScene) -> AnyScene:
    """The scene with `ends` of every mode set filled in."""
    bodies = tuple(_with_ends(scene, body) if isinstance(body, BeamBody) else body for body in scene.bodies)
    return scene.model_copy(update={"bodies": bodies})


def _with_ends(scene: SceneParts, beam: BeamBody) -> BeamBody:
    chosen = {}
    for key, ends_of in ENDS_OF.items():
        modes = getattr(beam, key)
        if modes is not None and modes.ends is None:
            ends = ends_of(scene, beam)
            chosen[key] = modes.model_copy(update={"ends": ends})
    return beam.model_copy(update=chosen) if chosen else beam


def lateral_ends(scene: SceneParts, beam: BeamBody, plane: str = "lateral") -> str:
    """The `ends` of bending in a plane that the joints and loads at the beam's ends ask for."""
    start, end = (_held(_at(scene, beam, at), plane) for at in (0.0, 1.0))
    return LATERAL.get((start, end), f"{start}-{end}")


def axial_ends(scene: SceneParts, beam: BeamBody) -> str:
    """The `ends` of stretching that they ask for."""
    start, end = (any(carried.force for carried in _at(scene, beam, at)) for at in (0.0, 1.0))
    return AXIAL.get((start, end), "free-free")


def torsion_ends(scene: SceneParts, beam: BeamBody) -> str:
    """The `ends` of torsion that they ask for."""
    start, end = (any(_moment(carried, "torsion") for carried in _at(scene, beam, at)) for at in (0.0, 1.0))
    return AXIAL.get((start, end), "free-free")


ENDS_OF: dict[str, Callable[[SceneParts, BeamBody], str]] = {
    "lateral": lateral_ends,
    "lateral_z": partial(lateral_ends, plane="lateral_z"),
    "axial": axial_ends,
    "torsion": torsion_ends,
}


def _moment(carried: Carried, plane: str) -> bool:
    return carried.moment and not _turns_freely(carried, plane)


def _held(found: list[Carried], plane: str) -> str:
    """ "welded", "pinned" or "free"."""
    if any(_moment(carried, plane) for carried in found):
        return "welded"
    return "pinned" if any(carried.force for carried in found) else "free"


def _turns_freely(carried: Carried, plane: str) -> bool:
    axis, normal = carried.free_about, NORMALS[plane]
    if axis is None:
        return False
    size, along = sum(a * a for a in axis), sum(a * n for a, n in zip(axis, normal, strict=True))
    return size - along * along <= ALIGNED * size


def _at(scene: SceneParts, beam: BeamBody, at: float) -> list[Carried]:
    """What the joints and loads at one end of the beam carry."""
    return [
        _by(part, side, scene, reference)
        for reference, part, side in _attached(scene)
        if reference.partition(".")[0] == beam.name
        and isinstance(marker := scene.marker(reference)[1], BeamMarker)
        and marker.at == at
    ]


def _attached(scene: SceneParts) -> Iterator[tuple[str, Joint | Load, str]]:
    """(marker, joint or load, the side of it that is there)."""
    for part in (*scene.joints, *scene.loads):
        for side in ("marker_a", "marker_b", "marker", "reaction"):
            reference = getattr(part, side, None)
            if reference is not None:
                yield reference, part, side


def _by(part: Joint | Load, side: str, scene: SceneParts, reference: str) -> Carried:
    """What a joint or load carries at the marker that is its `side`."""
    kind = part.type
    if kind in FORCES_ONLY or (kind in ("point_on_line", "prescribed_displacement") and side == "marker_b"):
        return Carried(True, False)
    if kind in ("torque", "rotational_spring_damper", "prescribed_angle"):
        return Carried(False, True)
    if kind in FREE_ROTATION:
        driven = any(load.type == "effort" and load.coordinate.startswith(f"{part.name}.angle") for load in scene.loads)
        damped = driven or getattr(part, "damping", 0) != 0
        if scene.space == "planar":
            return Carried(True, damped)
        return Carried(True, True, None if damped else _free_axis(kind, side, scene, reference))
    return Carried(True, True)


def _free_axis(kind: str, side: str, scene: SceneParts, reference: str) -> tuple[float, ...] | None:
    """Direction in the body about which the joint passes on no moment; None where it is not given."""
    marker = scene.marker(reference)[1]
    assert isinstance(marker, MarkerDirections)
    own = FREE_ROTATION[kind][0 if side == "marker_a" else -1]
    return marker.axis if own == "z" else marker.x_axis
