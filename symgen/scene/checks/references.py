"""References: every marker that is named exists, and the two ends of a connection differ."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from symgen.couplings import Coupling
from symgen.loads import Load
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean


def reference_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Unknown markers, and connections from something to itself."""
    known = _known_markers(scene)
    for section in ("joints", "loads", "measures"):
        for index, entry in enumerate(getattr(scene, section)):
            path = item_path(section, index, entry.name)
            unknown = list(_unknown(path, entry, known))
            yield from unknown or _pair(section, path, entry)


def load_faults(scene: SceneParts) -> Iterator[SceneError]:
    """What loads and couplings find wrong with themselves in this scene."""
    sections: dict[str, Sequence[Load | Coupling]] = {"loads": scene.loads, "couplings": scene.couplings}
    for section, parts in sections.items():
        for index, part in enumerate(parts):
            path = item_path(section, index, part.name)
            for key, problem, remedy in part.faults(scene):
                yield SceneError(f"{path}.{key}" if key else path, problem, remedy)


def _known_markers(scene: SceneParts) -> dict[str, list[str]]:
    bodies = (scene.ground, *scene.moving_bodies)
    return {body.name: [*body.implicit_markers(), *body.markers] for body in bodies}


def _unknown(path: str, entry: Any, known: dict[str, list[str]]) -> Iterator[SceneError]:
    for key, reference in entry.markers.items():
        body, _, marker = reference.partition(".")
        if body not in known:
            yield SceneError(f"{path}.{key}", f"there is no body '{body}'", did_you_mean(body, known))
        elif marker not in known[body]:
            remedy = did_you_mean(marker, known[body])
            yield SceneError(f"{path}.{key}", f"body '{body}' has no marker '{marker}'", remedy)


def _pair(section: str, path: str, entry: Any) -> Iterator[SceneError]:
    """What is wrong with the one or two ends that an entry has, whatever its type."""
    ends = list(entry.markers.values())
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
