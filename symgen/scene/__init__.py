"""Scenes: what a mechanism consists of, as a Python builder and as a TOML file.

A `SceneRecord` is immutable and checked: whatever is wrong in it surfaces as a `SceneError` with item, problem
and remedy.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from symgen.couplings import COUPLINGS, Coupling
from symgen.joints import JOINTS, Joint
from symgen.loads import LOADS, Load
from symgen.scene.attachments import lateral_ends, with_ends
from symgen.scene.bodies import (
    AxialModes,
    BeamBody,
    BeamMarker,
    GroundBody,
    LateralModes,
    MarkerDirections,
    RigidBody,
    RigidMarker,
    TorsionModes,
)
from symgen.scene.flexible import (
    FlexibleMarker,
    FlexibleStiffening,
    Foreshortening,
    ModalBody,
    ModalMarker,
    SpatialModalBody,
    Structure,
)
from symgen.scene.measures import (
    CoordinateMeasure,
    MarkerMeasure,
    Measure,
    SectionForceMeasure,
    StressMeasure,
)
from symgen.scene.parts import AnyBody, AnyMarker, Body, DeclaredInput, DeclaredParameter, DeclaredState, Placement
from symgen.scene.simulation import (
    CoordinateGroup,
    DeclaredEvent,
    Initial,
    InitialValue,
    Partition,
    Simulation,
)
from symgen.scene.surfaces import SurfaceTable
from symgen.scene.tables import CurveTable, s_curve, trapezoid
from symgen.scene.toml_io import read_mesh
from symgen.schema.errors import SceneError
from symgen.schema.expressions import Expression, parse_expression
from symgen.schema.fields import Quantity

if TYPE_CHECKING:
    from symgen.mechanism.builder import Scene
    from symgen.mechanism.scene import SceneRecord

__all__ = [
    "AnyBody", "AnyMarker", "AxialModes", "BeamBody", "BeamMarker", "Body",
    "CoordinateMeasure", "MarkerMeasure", "CurveTable", "SurfaceTable", "COUPLINGS", "Coupling",
    "Expression", "SpatialModalBody", "FlexibleMarker", "FlexibleStiffening",
    "Foreshortening", "CoordinateGroup", "GroundBody", "Initial",
    "InitialValue",
    "JOINTS", "Joint", "LOADS", "LateralModes", "Load", "MarkerDirections", "Measure", "ModalBody", "ModalMarker",
    "DeclaredEvent", "DeclaredInput", "DeclaredParameter", "DeclaredState", "Partition", "Placement",
    "Quantity",
   
    "RigidBody", "RigidMarker", "Scene", "SceneError", "SceneRecord",
    "SectionForceMeasure",
    "Simulation", "StressMeasure", "Structure", "TorsionModes",
    "lateral_ends", "parse_expression", "read_mesh", "s_curve", "trapezoid",
    "with_ends",
]  # fmt: skip

_HOMES = {"Scene": "symgen.mechanism.builder", "SceneRecord": "symgen.mechanism.scene"}  # what stands above


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'symgen.scene' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
