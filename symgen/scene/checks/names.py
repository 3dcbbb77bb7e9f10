"""Names: unique, not reserved, and not those of implicit markers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from symgen.scene.bodies import GroundBody
from symgen.scene.parts import SceneParts
from symgen.scene.translate import SECTIONS, item_path
from symgen.schema.errors import SceneError
from symgen.schema.expressions import RESERVED


def name_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Names that clash, and a scene with nothing in it or with two kinds of content."""
    for section in SECTIONS:
        yield from _duplicates(section, (entry.name for entry in getattr(scene, section)))
    yield from _duplicates("partition.groups", (group.name for group in scene.partition.groups or ()))
    for index, body in enumerate(scene.bodies):
        path = item_path("bodies", index, body.name)
        if body.name == "ground" and not isinstance(body, GroundBody):
            yield SceneError(path, "only the ground may have this name", 'rename the body, or give it type = "ground"')
        for marker in body.implicit_markers().keys() & body.markers.keys():
            yield SceneError(
                f"{path}.markers.{marker}",
                f"every {body.type} body has its own marker '{marker}'",
                "rename yours",
            )
    yield from _expression_names(scene)
    yield from _contents(scene)


def _duplicates(section: str, names: Iterable[str]) -> Iterator[SceneError]:
    seen: dict[str, int] = {}
    for index, name in enumerate(names):
        if name in seen:
            yield SceneError(
                item_path(section, index, name),
                f"the name is taken by {section}[{seen[name]}]",
                "rename one of them",
            )
        seen.setdefault(name, index)


def _expression_names(scene: SceneParts) -> Iterator[SceneError]:
    taken = {name: "the expression language" for name in RESERVED}
    entries = [(f"parameters.{name}", name) for name in scene.parameters]
    entries += [(f"inputs.{name}", part) for name, entry in scene.inputs.items() for part in entry.names(name)]
    entries += [(f"states.{name}", part) for name in scene.states for part in (name, f"{name}_dot")]
    for index, measure in enumerate(scene.measures):
        path = item_path("measures", index, measure.name)
        entries += [(path, measure.name), (path, f"{measure.name}_dot")]
    for path, name in entries:
        if name in taken and taken[name] != path:
            yield SceneError(path, f"'{name}' is already used by {taken[name]}", "choose another name")
        taken.setdefault(name, path)


def _contents(scene: SceneParts) -> Iterator[SceneError]:
    if scene.structure is None:
        if not scene.moving_bodies:
            yield SceneError("bodies", "nothing in this scene can move", "add a body, or a structure")
        return
    for section in SECTIONS:
        if getattr(scene, section):
            yield SceneError(
                section,
                "a scene with a structure has no bodies, joints, loads or measures",
                f"remove {section}",
            )
    if any(component != 0 for component in scene.gravity):
        yield SceneError("gravity", "has no effect on a structure", "remove it; give forces in structure.force")
    if scene.states:
        yield SceneError("states", "a structure has no controllers", "remove them, or build the scene from bodies")
    if scene.baumgarte is not None:
        yield SceneError("baumgarte", "a structure has no constraints to stabilise", "remove it")
