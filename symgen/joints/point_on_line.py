"""Point on line: b stays on the line of marker a and may turn."""

from __future__ import annotations

from typing import Literal

from symgen.joints.joint import Equation, InPlane, Joint


class PointOnLineJoint(Joint):
    """Keeps marker_b's point on marker_a's x-axis, in space its z-axis: row n_a.(r_b - r_a), in space two."""

    type: Literal["point_on_line"] = "point_on_line"

    equation = "n_a . (r_b - r_a) = 0"
    points = "on_axis"
    at_b = "force"
    drawing = "slide"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """n_a . (r_b - r_a) = 0."""
        return [Equation("normal", "distance", m.dot(m.n_a, m.d))]
