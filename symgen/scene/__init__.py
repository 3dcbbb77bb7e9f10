"""Scenes: what a mechanism consists of, as a Python builder and as a TOML file.

A `Scene` is immutable and checked: whatever is wrong in it surfaces as a `SceneError` with item, problem
and remedy.
"""

from .bodies import AxialModes, BeamBody, BeamMarker, GroundBody, LateralModes, MarkerDirections, RigidBody, RigidMarker
from .builder import SceneBuilder
from .errors import SceneError
from .expressions import Expression, parse_expression
from .fields import Quantity
from .flexible import FlexibleBody, FlexibleMarker, FlexibleStiffening
from .joints import (
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
from .loads import Bushing, Force, Load, RotationalSpringDamper, SpringDamper, Torque
from .measures import AngleMeasure, CoordinateMeasure, DistanceMeasure, Measure, XMeasure, YMeasure, ZMeasure
from .modal import Foreshortening, ModalBody, ModalMarker
from .parameters import Parameter
from .places import Place
from .scene import AnyBody, AnyMarker, Body, Scene
from .simulation import Baumgarte, Group, Initial, InitialValue, Partition, Simulation
from .structure import Structure

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
