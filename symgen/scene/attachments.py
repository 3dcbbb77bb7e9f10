"""What a beam's ends carry, seen from the joints and loads at them, and the mode sets that follow from it.

An end carries a force, a moment, both or nothing, in each plane of bending. That decides which shapes the beam needs
(runtime/contract/flexible.py), unless the scene names `ends` itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple, TypeVar

from symgen.joints import Joint
from symgen.joints.joint import Reaction, Y
from symgen.loads import Load
from symgen.scene.bodies import BeamBody, BeamMarker, MarkerDirections
from symgen.scene.parts import SceneParts

AnyScene = TypeVar("AnyScene", bound=SceneParts)
# a moment about it bends in that plane, or twists
NORMALS = {"lateral": (0.0, 0.0, 1.0), "lateral_z": (0.0, 1.0, 0.0), "torsion": (1.0, 0.0, 0.0)}
ALIGNED_SINE = 1e-9  # squared sine of the angle between two directions that are taken for one
LATERAL = {
    ("welded", "free"): "clamped-free",
    ("free", "welded"): "free-clamped",
}
AXIAL = {(True, True): "fixed-loaded", (True, False): "fixed-free", (False, True): "free-fixed"}


class Carried(NamedTuple):
    """What one end carries: a force, a moment; free_about: the direction about which that moment is none, if any."""

    force: bool
    moment: bool
    free_about: tuple[float, ...] | None = None


def with_ends(scene: AnyScene) -> AnyScene:
    """The scene with `ends` of every mode set filled in."""
    bodies = tuple(_with_ends(scene, body) if isinstance(body, BeamBody) else body for body in scene.bodies)
    found = scene.model_copy(update={"bodies": bodies})
    for name in ("moving_bodies", "_bodies"):  # what the scene remembers of its bodies is copied with it
        found.__dict__.pop(name, None)
    return found


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
    return size - along * along <= ALIGNED_SINE * size


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
    parts: tuple[Joint | Load, ...] = (*scene.joints, *scene.loads)
    for part in parts:
        for side, reference in part.markers.items():
            yield reference, part, side


def _by(part: Joint | Load, side: str, scene: SceneParts, reference: str) -> Carried:
    """What a joint or load carries at the marker that is its `side`."""
    if isinstance(part, Joint):
        return _by_joint(part, side, scene, reference)
    return _both(part.carries)


def _both(carried: Reaction) -> Carried:
    return Carried("force" in carried, "moment" in carried)


def _by_joint(joint: Joint, side: str, scene: SceneParts, reference: str) -> Carried:
    carried = joint.at_a if side == "marker_a" else joint.at_b
    if carried != "force and moment":
        return _both(carried)
    turn = joint.turn_at("marker_a" if side == "marker_a" else "marker_b")
    carries = turn is None or turn.lead or getattr(joint, turn.damping, 0) != 0 or joint.rubs() is not None
    if turn is None or carries or _driven(scene, f"{joint.name}.{turn.name}"):
        return Carried(True, True)
    if scene.space == "planar":
        return Carried(True, False)
    return Carried(True, True, _axis(turn.axis, scene, reference))


def _driven(scene: SceneParts, coordinate: str) -> bool:
    """Does an effort act on it?"""
    return any(load.drives(coordinate) for load in scene.loads)


def _axis(own: int, scene: SceneParts, reference: str) -> tuple[float, ...] | None:
    """An axis of a marker in its body; None where it is not given."""
    marker = scene.marker(reference)[1]
    assert isinstance(marker, MarkerDirections)
    z, x = marker.axis, marker.x_axis
    if own == Y and x is not None:
        return (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
    return (x, None, z)[own]


@dataclass(frozen=True)
class StaticResidual:
    """A beam whose shapes of one plane do not carry what is attached to it.

    asked: the `ends` that the joints and loads at its ends ask for. share: part of the bending energy of the worst
    end loads that the shapes miss, 0 to 1.
    """

    body: str
    plane: str
    ends: str
    modes: int
    asked: str
    share: float

    def __str__(self) -> str:
        return (
            f"{self.body}.{self.plane}: {self.modes} {self.ends} shapes miss {100 * self.share:.2g} % of the static "
            f"bending energy of what its ends carry; leave ends out ({self.asked}), or ask for more modes"
        )
