"""Revolute joint: two points coincide; in space the z-axes too, a hinge."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.backlash import Backlash
from symgen.joints.friction import Friction
from symgen.joints.joint import PARALLEL, Equation, InPlane, Joint, Motor, Turn, Z
from symgen.joints.limits import Limits
from symgen.schema.fields import Bound, Meaning, Quantity, about


class RevoluteJoint(Joint):
    """A hinge about marker a's z-axis: rows (r_b - r_a)_x, (r_b - r_a)_y; in space r_b - r_a and z_b parallel to z_a.

    damping [N m s/rad] resists the relative rotation.
    """

    type: Literal["revolute"] = "revolute"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0
    motor: Annotated[Motor | None, about("rotor that the joint carries on the body of marker a, about its axis")] = None
    limits: Annotated[Limits | None, about("stops at the ends of the free motion, rigid or compliant")] = None
    backlash: Annotated[
        Backlash | None, about("play of the free motion: no force within the gap, a spring and damper beyond")
    ] = None
    friction: Annotated[
        Friction | None, about("friction of the free motion (Coulomb, Stribeck, viscous), which sticks at rest")
    ] = None

    equation = "r_b - r_a = 0"
    points = "together"
    perpendicular = PARALLEL
    motions = (Turn(Z, "angle", damping="damping"),)

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """r_b - r_a = 0."""
        return [Equation("x", "distance", m.d[0]), Equation("y", "distance", m.d[1])]
