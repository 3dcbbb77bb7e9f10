"""A scene in a notebook: what joins what as a drawing; bodies, joints, loads and parameters as tables."""

from __future__ import annotations

from runtime.contract.status import card, fold, table
from symgen.scene.parts import SceneParts
from symgen.scene.scene_sketch import scene_sketch


def scene_card(scene: SceneParts) -> str:
    """HTML of a scene."""
    about = f"{scene.name}: {scene.space}, {len(scene.moving_bodies)} bodies, {len(scene.joints)} joints"
    bodies = [
        (body.name, body.type, f"{body.nf} modes" if body.nf else "", ", ".join(body.markers))
        for body in (scene.ground, *scene.moving_bodies)
    ]
    joints = [(joint.name, joint.type, f"{joint.marker_a} - {joint.marker_b}") for joint in scene.joints]
    roles = ("marker", "marker_a", "marker_b", "reaction", "coordinate")
    loads = [
        (load.name, load.type, " - ".join(getattr(load, role) for role in roles if getattr(load, role, None)))
        for load in scene.loads
    ]
    measures = [(measure.name, measure.type) for measure in scene.measures]
    parameters = [
        (name, f"{entry.default:.6g}", entry.unit, entry.description) for name, entry in scene.parameters.items()
    ]
    parts = [
        fold(f"{len(rows)} {title}", table(rows)) if title in ("measures", "parameters") else table(rows, (title,))
        for title, rows in (
            ("bodies", bodies),
            ("joints", joints),
            ("loads", loads),
            ("measures", measures),
            ("parameters", parameters),
        )
        if rows
    ]
    return card(scene.title or scene.name, about, scene_sketch(scene), *parts)
