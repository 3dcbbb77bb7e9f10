"""Scenes: what a mechanism consists of, as a Python builder and as a TOML file.

A `Scene` is immutable and checked: whatever is wrong in it surfaces as a `SceneError` with item, problem
and remedy.
"""

from .bodies import AxialModes, BeamBody, BeamMarker, GroundBody, LateralModes, RigidBody, RigidMarker
from .builder import SceneBuilder
from .errors import SceneError
from .expressions import Expression, parse_expression
from .fields import Quantity
from .joints import (
    Joint,
    PointOnLineJoint,
    PrescribedAngle,
    PrescribedDisplacement,
    PrismaticJoint,
    RevoluteJoint,
    WeldJoint,
)
from .loads import Force, Load, RotationalSpringDamper, SpringDamper, Torque
from .measures import AngleMeasure, DistanceMeasure, Measure, XMeasure, YMeasure
from .modal import Foreshortening, ModalBody, ModalMarker
from .parameters import Parameter
from .scene import AnyBody, AnyMarker, Body, Scene
from .simulation import Baumgarte, Group, Initial, InitialValue, Partition, Simulation
from .structure import Structure

__all__ = [
    "AngleMeasure", "AnyBody", "AnyMarker", "AxialModes", "Baumgarte", "BeamBody", "BeamMarker", "Body",
    "DistanceMeasure", "Expression", "Force", "Foreshortening", "Group", "GroundBody", "Initial",
    "InitialValue",
    "Joint", "LateralModes", "Load", "Measure", "ModalBody", "ModalMarker", "Parameter", "Partition",
    "PointOnLineJoint", "PrescribedAngle", "PrescribedDisplacement", "PrismaticJoint", "Quantity",
    "RevoluteJoint",
    "RigidBody", "RigidMarker", "RotationalSpringDamper", "Scene", "SceneBuilder", "SceneError", "Simulation",
    "SpringDamper", "Structure", "Torque", "WeldJoint", "XMeasure", "YMeasure", "parse_expression",
]  # fmt: skip
