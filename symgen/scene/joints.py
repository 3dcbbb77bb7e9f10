"""Joints between two markers (Eq. 21)."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from .fields import Bound, MarkerRef, Meaning, Model, Name, Quantity, Scope


class _Joint(Model):
    name: Name
    marker_a: MarkerRef
    marker_b: MarkerRef


class RevoluteJoint(_Joint):
    """Rows (r_b - r_a)_x, (r_b - r_a)_y. damping [N m s/rad] resists the relative rotation."""

    type: Literal["revolute"] = "revolute"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0


class PrismaticJoint(_Joint):
    """Rows n_a.(r_b - r_a), phi_b - phi_a; slides along marker_a's x-axis. damping [N s/m]."""

    type: Literal["prismatic"] = "prismatic"
    damping: Annotated[Quantity, Meaning("damping of the sliding", "N s/m", Bound.NON_NEGATIVE)] = 0.0


class WeldJoint(_Joint):
    """Rows (r_b - r_a)_x, (r_b - r_a)_y, phi_b - phi_a."""

    type: Literal["weld"] = "weld"


class PointOnLineJoint(_Joint):
    """Row n_a.(r_b - r_a): marker_b's point stays on marker_a's x-axis."""

    type: Literal["point_on_line"] = "point_on_line"


class PrescribedAngle(_Joint):
    """Row phi_b - phi_a - f(t), f = motion [rad]."""

    type: Literal["prescribed_angle"] = "prescribed_angle"
    motion: Annotated[Quantity, Meaning("angle as a function of t", "rad", scope=Scope.TIME)]


class PrescribedDisplacement(_Joint):
    """Row t_a.(r_b - r_a) - f(t), f = motion [m], along marker_a's x-axis."""

    type: Literal["prescribed_displacement"] = "prescribed_displacement"
    motion: Annotated[Quantity, Meaning("displacement as a function of t", "m", scope=Scope.TIME)]


Joint = Annotated[
    RevoluteJoint | PrismaticJoint | WeldJoint | PointOnLineJoint | PrescribedAngle | PrescribedDisplacement,
    Field(discriminator="type"),
]
