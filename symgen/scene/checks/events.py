"""Events: what they act on are inputs and parameters."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.parts import SceneParts
from symgen.schema.errors import SceneError, did_you_mean


def event_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Actions on what is neither, and events of a structure or of a mechanism that cannot move freely."""
    if scene.events and scene.structure is not None:
        yield SceneError("events", "a structure has no measures to look at", "remove them, or build it from bodies")
    known = [*scene.inputs, *scene.parameters]
    for name, event in scene.events.items():
        for target in event.action:
            if target not in known:
                problem = f"'{target}' is neither an input nor a parameter"
                yield SceneError(f"events.{name}.action", problem, did_you_mean(target, known))
