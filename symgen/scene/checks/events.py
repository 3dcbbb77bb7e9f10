"""Events: what they act on are inputs."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.errors import SceneError, did_you_mean
from symgen.scene.parts import SceneParts


def event_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Actions on what is no input, and events of a structure or of a mechanism that cannot move freely."""
    if scene.events and scene.structure is not None:
        yield SceneError("events", "a structure has no measures to look at", "remove them, or build it from bodies")
    for name, event in scene.events.items():
        for target in event.action:
            if target in scene.inputs:
                continue
            remedy = did_you_mean(target, scene.inputs)
            if target in scene.parameters:
                remedy = f"move '{target}' from parameters to inputs: a parameter stays as it is during a run"
            yield SceneError(f"events.{name}.action", f"'{target}' is not an input", remedy)
