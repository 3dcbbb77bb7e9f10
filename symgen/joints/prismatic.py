"""Prismatic (translational) joint: b slides on a line of marker a without turning."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.backlash import Backlash
from symgen.joints.friction import Friction
from symgen.joints.joint import ALIGNED, Equation, InPlane, Joint, Motor, Slide, Z
from symgen.joints.limits import Limits
from symgen.schema.fields import Bound, Meaning, Quantity, about


class PrismaticJoint(Joint):
    """A slide along marker_a's x-axis, in space its z-axis: rows n_a.(r_b - r_a), phi_b - phi_a. damping [N s/m]."""

    type: Literal["prismatic"] = "prismatic"
    damping: Annotated[Quantity, Meaning("damping of the sliding", "N s/m", Bound.NON_NEGATIVE)] = 0.0
    motor: Annotated[Motor | None, about("rotor that the joint carries on the body of marker a, about its axis")] = None
    limits: Annotated[Limits | None, about("stops at the ends of the free motion, rigid or compliant")] = None
    backlash: Annotated[
        Backlash | None, about("play of the free motion: no force within the gap, a spring and damper beyond")
    ] = None
    friction: Annotated[
        Friction | None, about("friction of the free motion (Coulomb, Stribeck, viscous), which sticks at rest")
    ] = None

    equation = "n_a . (r_b - r_a) = 0, phi_b - phi_a = 0"
    points = "on_axis"
    perpendicular = ALIGNED
    motions = (Slide(Z, "travel", damping="damping"),)
    drawing = "slide"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """n_a . (r_b - r_a) = 0 and phi_b - phi_a = 0."""
        return [Equation("normal", "distance", m.dot(m.n_a, m.d)), Equation("angle", "angle", m.phi_b - m.phi_a)]
