"""Prescribed angle (rheonomic): the angle between two markers follows f(t)."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.joint import Equation, InPlane, InSpace, Joint, X, Y
from symgen.schema.fields import Meaning, Quantity, Scope


class PrescribedAngle(Joint):
    """Prescribes an angle, in space about marker a's z-axis: row phi_b - phi_a - f(t), f = motion [rad].

    Between the markers of a joint with an angle of its own it prescribes that angle, over any number of turns.
    """

    type: Literal["prescribed_angle"] = "prescribed_angle"
    motion: Annotated[Quantity, Meaning("angle as a function of t", "rad", scope=Scope.TIME)]

    equation = "phi_b - phi_a - f(t) = 0"
    drives = "angle"
    at_a = at_b = "moment"
    drawing = "drive"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """phi_b - phi_a - f(t) = 0."""
        return [Equation("angle", "angle", m.phi_b - m.phi_a - m.field("motion"))]

    @classmethod
    def rows_in_space(cls, m: InSpace) -> list[Equation]:
        """sin(angle - f) = 0 for the angle of x_b in the xy-plane of marker a."""
        cosine, sine = m.cos_sin(m.field("motion"))
        C = m.dot(m.b[X], m.a[Y]) * cosine - m.dot(m.b[X], m.a[X]) * sine
        return [Equation("angle", "angle", C, "angle - f(t)")]
