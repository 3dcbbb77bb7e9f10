"""The equations of a scene: of its bodies in two or three dimensions, or of its linear structure."""

from __future__ import annotations

from symgen.algebra.parameters import ParameterTable
from symgen.scene import Scene
from symgen.system.equations import Equations, blank_equations
from symgen.system.mechanism import Mechanism
from symgen.system.planar import PlanarSpace
from symgen.system.spatial import SpatialSpace
from symgen.system.structure import structure_equations


def build_equations(scene: Scene, table: ParameterTable) -> Equations:
    """Equations (20)-(28), or (3)-(14) for a structure."""
    if scene.structure is not None:
        return structure_equations(scene, table)
    equations = blank_equations(scene.coordinates())
    if scene.space == "spatial":
        return Mechanism(scene, table, SpatialSpace(scene, table, equations), equations).equations
    return Mechanism(scene, table, PlanarSpace(scene, table), equations).equations
