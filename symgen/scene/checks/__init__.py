"""Checks across the parts of a scene, in the order in which a person would mend them.

Each module yields `SceneError`s; a stage runs only when the stages before it found nothing, because
it relies on them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import raise_all
from .matrices import matrix_errors
from .names import name_errors
from .partition import partition_errors
from .references import reference_errors
from .shapes import shape_errors
from .space import screw_errors, space_errors
from .topology import topology_errors
from .values import value_errors

if TYPE_CHECKING:
    from ..scene import Scene

STAGES = (
    (name_errors, shape_errors, space_errors),
    (reference_errors, topology_errors, partition_errors, value_errors),
    (matrix_errors, screw_errors),
)


def check_scene(scene: Scene) -> None:
    """Raise SceneError with everything the first failing stage finds; return if the scene is sound."""
    for stage in STAGES:
        raise_all(error for check in stage for error in check(scene))
