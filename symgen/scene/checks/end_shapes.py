"""A beam has at least the static shapes of what is attached to its ends."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.attachments import with_ends
from symgen.scene.bodies import BeamBody
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError

STATIC_SHAPES = {"welded-welded": 2, "welded-heavy": 2}  # two are more than the one that every set has


def end_shape_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Fewer modes than the ends have static shapes."""
    for index, body in enumerate(with_ends(scene).bodies):
        if not isinstance(body, BeamBody):
            continue
        for key in ("lateral", "lateral_z"):
            modes = getattr(body, key)
            least = STATIC_SHAPES.get(modes.ends, 1) if modes else 0
            if modes and modes.modes < least:
                yield SceneError(
                    f"{item_path('bodies', index, body.name)}.{key}.modes",
                    f"both ends carry moments, which takes {least} shapes, not {modes.modes}",
                    f"ask for at least {least}, or name other ends",
                )
