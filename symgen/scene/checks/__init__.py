"""Checks across the parts of a scene, in the order in which a person would mend them.

Each module yields `SceneError`s; a stage runs only when the stages before it found nothing, because
it relies on them.
"""

from __future__ import annotations

from symgen.scene.checks.end_shapes import end_shape_errors
from symgen.scene.checks.events import event_errors
from symgen.scene.checks.matrices import matrix_errors
from symgen.scene.checks.names import name_errors
from symgen.scene.checks.partition import partition_errors
from symgen.scene.checks.references import load_faults, reference_errors
from symgen.scene.checks.section_measures import section_measure_errors
from symgen.scene.checks.shapes import shape_errors
from symgen.scene.checks.sizes import size_errors
from symgen.scene.checks.space import loop_errors, space_errors
from symgen.scene.checks.stress_measures import stress_measure_errors
from symgen.scene.checks.topology import topology_errors
from symgen.scene.checks.values import value_errors
from symgen.scene.parts import SceneParts
from symgen.schema.errors import raise_all

STAGES = (
    (size_errors, name_errors, shape_errors, space_errors),
    (reference_errors, load_faults, topology_errors, partition_errors, event_errors, value_errors),
    (matrix_errors, loop_errors, end_shape_errors, section_measure_errors, stress_measure_errors),
)


def check_scene(scene: SceneParts) -> None:
    """Raise SceneError with everything the first failing stage finds; return if the scene is sound."""
    for stage in STAGES:
        raise_all(error for check in stage for error in check(scene))
