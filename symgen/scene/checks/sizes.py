"""Sizes: limits above which deriving a scene would take hours or all memory, each with a name."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError

MAX_COORDINATES = 2000  # 1,000 take 20 s to derive where nothing joins them; time grows with the square
MAX_BODY_MODES = 150  # 100 take 6 s, the square of the modes in memory


def size_errors(scene: SceneParts) -> Iterator[SceneError]:
    """More coordinates, or more modes of a body, than a derivation is made for."""
    for index, body in enumerate(scene.bodies):
        if body.nf > MAX_BODY_MODES:
            yield SceneError(
                item_path("bodies", index, body.name),
                f"it has {body.nf} modes, more than {MAX_BODY_MODES}",
                "keep the modes that the motion excites; `symgen modes` lists their frequencies",
            )
    count = 0 if scene.structure is None else len(scene.structure.coordinates)
    count += sum(len(scene.frame_coordinates(body)) + body.nf for body in scene.moving_bodies)
    if count > MAX_COORDINATES:
        yield SceneError(
            "bodies",
            f"the scene has {count} coordinates, more than {MAX_COORDINATES}",
            "divide it, or give bodies fewer modes",
        )
