"""Scenes that name Euler parameters as their independent coordinates: a run exchanges these where they must be."""

from __future__ import annotations

from symgen.scene import SceneRecord


def with_parameters(scene: SceneRecord, body: str) -> SceneRecord:
    """The scene of one body with e1, e2, e3, and what else is free, as q_i."""
    data, free = scene.to_dict(), [] if scene.joints else [f"{body}.{axis}" for axis in "xyz"]
    data["partition"] = {"independent": [*free, *(f"{body}.e{k}" for k in (1, 2, 3))]}
    return SceneRecord.from_dict(data)
