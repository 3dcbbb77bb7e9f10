"""Section forces are measured on beams whose shapes know them."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.bodies import BeamBody
from symgen.scene.measures import SectionForceMeasure
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError

SETS = {
    "normal_force": "axial",
    "shear_force": "lateral",
    "bending_moment": "lateral",
    "shear_force_z": "lateral_z",
    "bending_moment_y": "lateral_z",
    "torsion_moment": "torsion",
}  # which shapes know it


def section_measure_errors(scene: SceneParts) -> Iterator[SceneError]:
    """A marker that is on no beam with exact shapes of the kind that the measure asks for."""
    for index, measure in enumerate(scene.measures):
        if not isinstance(measure, SectionForceMeasure):
            continue
        path = item_path("measures", index, measure.name)
        body = scene.marker(measure.of)[0]
        if not isinstance(body, BeamBody) or body.lumped_elements is not None:
            yield SceneError(
                f"{path}.of",
                f"'{body.name}' is no beam with exact shapes",
                "name a marker of such a beam, without mesh and elements",
            )
        elif getattr(body, kind := SETS[measure.type]) is None:
            yield SceneError(
                f"{path}.type",
                f"'{body.name}' has no {kind} shapes, which would know its {measure.type.replace('_', ' ')}",
                f"give it {kind} modes, or take Solution.section_forces",
            )
