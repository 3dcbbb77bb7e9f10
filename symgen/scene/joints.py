"""Joints between two markers (Eq. 21)."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from symgen.scene.fields import Bound, MarkerRef, Meaning, Name, Quantity, Scope, StrictModel


class _Joint(StrictModel):
    name: Name
    marker_a: MarkerRef
    marker_b: MarkerRef


class RevoluteJoint(_Joint):
    """Rows (r_b - r_a)_x, (r_b - r_a)_y; in space r_b - r_a and z_b parallel to z_a: a hinge about marker a's z-axis.

    damping [N m s/rad] resists the relative rotation.
    """

    type: Literal["revolute"] = "revolute"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0


class PrismaticJoint(_Joint):
    """Rows n_a.(r_b - r_a), phi_b - phi_a: slides along marker_a's x-axis, in space its z-axis. damping [N s/m]."""

    type: Literal["prismatic"] = "prismatic"
    damping: Annotated[Quantity, Meaning("damping of the sliding", "N s/m", Bound.NON_NEGATIVE)] = 0.0


class WeldJoint(_Joint):
    """Rows (r_b - r_a)_x, (r_b - r_a)_y, phi_b - phi_a."""

    type: Literal["weld"] = "weld"


class PointOnLineJoint(_Joint):
    """Row n_a.(r_b - r_a): marker_b's point stays on marker_a's x-axis; in space two rows, on its z-axis."""

    type: Literal["point_on_line"] = "point_on_line"


class PrescribedAngle(_Joint):
    """Row phi_b - phi_a - f(t), f = motion [rad]; in space the angle about marker a's z-axis.

    Between the markers of a joint with an angle of its own it prescribes that angle, over any number of turns.
    """

    type: Literal["prescribed_angle"] = "prescribed_angle"
    motion: Annotated[Quantity, Meaning("angle as a function of t", "rad", scope=Scope.TIME)]


class PrescribedDisplacement(_Joint):
    """Row t_a.(r_b - r_a) - f(t), f = motion [m], along marker_a's x-axis; in space along its z-axis."""

    type: Literal["prescribed_displacement"] = "prescribed_displacement"
    motion: Annotated[Quantity, Meaning("displacement as a function of t", "m", scope=Scope.TIME)]


class DistanceJoint(_Joint):
    """Row |r_b - r_a|^2 - length^2: a massless rod between two points. length [m]."""

    type: Literal["distance"] = "distance"
    length: Annotated[Quantity, Meaning("length of the rod", "m", Bound.POSITIVE)]


class SphericalJoint(_Joint):
    """Rows r_b - r_a (spatial scenes)."""

    type: Literal["spherical"] = "spherical"


class UniversalJoint(_Joint):
    """Rows r_b - r_a and x_b perpendicular to z_a (spatial): turns about marker a's z-axis, then about b's x-axis."""

    type: Literal["universal"] = "universal"


class CylindricalJoint(_Joint):
    """Turns about and slides along marker a's z-axis (spatial). damping [N m s/rad], travel_damping [N s/m]."""

    type: Literal["cylindrical"] = "cylindrical"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0
    travel_damping: Annotated[Quantity, Meaning("damping of the sliding", "N s/m", Bound.NON_NEGATIVE)] = 0.0


class ScrewJoint(_Joint):
    """A cylindrical joint whose travel is lead times the turns (spatial): travel = lead angle / 2 pi. lead [m]."""

    type: Literal["screw"] = "screw"
    lead: Annotated[Quantity, Meaning("travel of a turn", "m")]


class PlanarJoint(_Joint):
    """Moves in marker a's xy-plane and turns about its z-axis (spatial)."""

    type: Literal["planar"] = "planar"


Joint = Annotated[
    RevoluteJoint
    | PrismaticJoint
    | WeldJoint
    | PointOnLineJoint
    | PrescribedAngle
    | PrescribedDisplacement
    | DistanceJoint
    | SphericalJoint
    | UniversalJoint
    | CylindricalJoint
    | ScrewJoint
    | PlanarJoint,
    Field(discriminator="type"),
]
