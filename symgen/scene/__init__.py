"""Scenes: what a mechanism consists of, as a Python builder and as a TOML file.

A `Scene` is immutable and checked: whatever is wrong in it surfaces as a `SceneError` with item, problem
and remedy.
"""

from symgen.scene.bodies import (
    AxialModes,
    BeamBody,
    BeamMarker,
    GroundBody,
    LateralModes,
    MarkerDirections,
    RigidBody,
    RigidMarker,
)
from symgen.scene.builder import SceneBuilder
from symgen.scene.errors import SceneError
from symgen.scene.expressions import Expression, parse_expression
from symgen.scene.fields import Quantity
from symgen.scene.flexible import FlexibleBody, FlexibleMarker, FlexibleStiffening
from symgen.scene.joints import (
    CylindricalJoint,
    DistanceJoint,
    Joint,
    PlanarJoint,
    PointOnLineJoint,
    PrescribedAngle,
    PrescribedDisplacement,
    PrismaticJoint,
    RevoluteJoint,
    ScrewJoint,
    SphericalJoint,
    UniversalJoint,
    WeldJoint,
)
from symgen.scene.loads import Bushing, Force, Load, RotationalSpringDamper, SpringDamper, Torque
from symgen.scene.measures import (
    AngleMeasure,
    CoordinateMeasure,
    DistanceMeasure,
    Measure,
    XMeasure,
    YMeasure,
    ZMeasure,
)
from symgen.scene.modal import Foreshortening, ModalBody, ModalMarker
from symgen.scene.parameters import Parameter
from symgen.scene.parts import AnyBody, AnyMarker, Body
from symgen.scene.places import Place
from symgen.scene.scene import Scene
from symgen.scene.simulation import Baumgarte, Group, Initial, InitialValue, Partition, Simulation
from symgen.scene.structure import Structure

__all__ = [
    "AngleMeasure", "AnyBody", "AnyMarker", "AxialModes", "Baumgarte", "BeamBody", "BeamMarker", "Body",
    "Bushing", "CoordinateMeasure", "CylindricalJoint",
    "DistanceJoint", "DistanceMeasure", "Expression", "FlexibleBody", "FlexibleMarker", "FlexibleStiffening",
    "Force", "Foreshortening", "Group", "GroundBody", "Initial",
    "InitialValue",
    "Joint", "LateralModes", "Load", "MarkerDirections", "Measure", "ModalBody", "ModalMarker",
    "Parameter", "Partition", "Place", "PlanarJoint",
    "PointOnLineJoint", "PrescribedAngle", "PrescribedDisplacement", "PrismaticJoint", "Quantity",
    "RevoluteJoint",
    "RigidBody", "RigidMarker", "RotationalSpringDamper", "Scene", "SceneBuilder", "SceneError", "ScrewJoint",
    "Simulation", "SphericalJoint", "SpringDamper", "Structure", "Torque", "UniversalJoint", "WeldJoint", "XMeasure",
    "YMeasure", "ZMeasure", "parse_expression",
]  # fmt: skip
