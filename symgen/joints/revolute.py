"""Revolute joint: two points coincide; in space the z-axes too, a hinge."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.backlash import Backlash
from symgen.joints.friction import Friction
from symgen.joints.joint import PARALLEL, Equation, InPlane, Joint, Motor, Turn, Z
from symgen.joints.limits import Limits
from symgen.schema.fields import Bound, Meaning, Quantity


class RevoluteJoint(Joint):
    """A hinge about marker a's z-axis: rows (r_b - r_a)_x, (r_b - r_a)_y; in space r_b - r_a and z_b parallel to z_a.

    damping [N m s/rad] resists the relative rotation.
    """

    type: Literal["revolute"] = "revolute"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0
    motor: Motor | None = None
    limits: Limits | None = None
    backlash: Backlash | None = None
    friction: Friction | None = None

    equation = "r_b - r_a = 0"
    points = "together"
    perpendicular = PARALLEL
    motions = (Turn(Z, "angle", damping="damping"),)

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """r_b - r_a = 0."""
        return [Equation("x", "distance", m.d[0]), Equation("y", "distance", m.d[1])]
