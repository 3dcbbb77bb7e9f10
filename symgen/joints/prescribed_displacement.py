"""Prescribed displacement (rheonomic): the travel of b along the line of marker a follows f(t)."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.joint import Equation, InPlane, InSpace, Joint, Z
from symgen.schema.fields import Meaning, Quantity, Scope


class PrescribedDisplacement(Joint):
    """Prescribes a way along marker_a's x-axis, in space its z-axis: row t_a.(r_b - r_a) - f(t), f = motion [m]."""

    type: Literal["prescribed_displacement"] = "prescribed_displacement"
    motion: Annotated[Quantity, Meaning("displacement as a function of t", "m", scope=Scope.TIME)]

    equation = "t_a . (r_b - r_a) - f(t) = 0"
    drives = "travel"
    at_b = "force"
    drawing = "drive"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """t_a . (r_b - r_a) - f(t) = 0."""
        return [Equation("travel", "distance", m.dot(m.t_a, m.d) - m.field("motion"))]

    @classmethod
    def rows_in_space(cls, m: InSpace) -> list[Equation]:
        """z_a . (r_b - r_a) - f(t) = 0."""
        return [Equation("travel", "distance", m.dot(m.a[Z], m.d) - m.field("motion"), "travel - f(t)")]
