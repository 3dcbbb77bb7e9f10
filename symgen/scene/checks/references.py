"""References: every marker that is named exists, and the two ends of a connection differ."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean

_REFERENCES = ("marker", "marker_a", "marker_b", "reaction")


def reference_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Unknown markers, and connections from something to itself."""
    known = _known_markers(scene)
    for section in ("joints", "loads", "measures"):
        for index, entry in enumerate(getattr(scene, section)):
            path = item_path(section, index, entry.name)
            unknown = list(_unknown(path, entry, known))
            yield from unknown or _pair(section, path, entry)
    yield from _efforts(scene)


def _efforts(scene: SceneParts) -> Iterator[SceneError]:
    """Efforts on what no joint has."""
    efforts = [(k, load) for k, load in enumerate(scene.loads) if load.type == "effort"]
    placing = {placement.joint for placement in scene.placements()} if efforts else set()
    joints = {joint.name: joint for joint in scene.joints}
    for index, load in efforts:
        path = f"{item_path('loads', index, load.name)}.coordinate"
        name, _, part = load.coordinate.partition(".")
        joint = joints.get(name)
        if joint is None:
            yield SceneError(path, f"there is no joint '{name}'", did_you_mean(name, joints))
            continue
        known = [motion.name for motion in joint.motions or () if name in placing or joint.relative()]
        if part not in known:
            has = did_you_mean(part, known) if known else "put a force or a torque on a marker instead"
            yield SceneError(path, f"the {joint.type} joint '{name}' has no coordinate '{part}' here", has)


def _known_markers(scene: SceneParts) -> dict[str, list[str]]:
    bodies = (scene.ground, *scene.moving_bodies)
    return {body.name: [*body.implicit_markers(), *body.markers] for body in bodies}


def _unknown(path: str, entry: Any, known: dict[str, list[str]]) -> Iterator[SceneError]:
    for key, reference in _markers(entry).items():
        body, _, marker = reference.partition(".")
        if body not in known:
            yield SceneError(f"{path}.{key}", f"there is no body '{body}'", did_you_mean(body, known))
        elif marker not in known[body]:
            remedy = did_you_mean(marker, known[body])
            yield SceneError(f"{path}.{key}", f"body '{body}' has no marker '{marker}'", remedy)


def _markers(entry: Any) -> dict[str, str]:
    """The markers that an entry names, by key, whatever its type."""
    if hasattr(entry, "markers"):
        return dict(entry.markers)
    return {key: reference for key in _REFERENCES if (reference := getattr(entry, key, None)) is not None}


def _pair(section: str, path: str, entry: Any) -> Iterator[SceneError]:
    """What is wrong with the one or two ends that an entry has, whatever its type."""
    ends = list(_markers(entry).values())
    if len(ends) == 1 and section == "loads" and _body(ends[0]) == "ground":
        yield SceneError(f"{path}.marker", "a load on the ground has no effect", "name a marker of a moving body")
    if len(ends) != 2:
        return
    first, second = ends
    if first == second:
        yield SceneError(path, f"both ends are the marker '{first}'", "name two different markers")
    elif _body(first) == _body(second) == "ground":
        yield SceneError(path, "both markers are on the ground", "name a marker of a moving body")
    elif section == "joints" and _body(first) == _body(second):
        yield SceneError(path, f"joins the body '{_body(first)}' to itself", "name markers of two bodies")


def _body(reference: str) -> str:
    return reference.partition(".")[0]
