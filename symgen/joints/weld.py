"""Weld: two markers coincide in position and angle."""

from __future__ import annotations

from typing import Literal

from symgen.joints.joint import ALIGNED, Equation, InPlane, Joint


class WeldJoint(Joint):
    """Fixes b to a: rows (r_b - r_a)_x, (r_b - r_a)_y, phi_b - phi_a; in space r_b - r_a and axes along axes."""

    type: Literal["weld"] = "weld"

    equation = "r_b - r_a = 0, phi_b - phi_a = 0"
    points = "together"
    perpendicular = ALIGNED
    motions = ()
    drawing = "weld"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """r_b - r_a = 0 and phi_b - phi_a = 0."""
        return [
            Equation("x", "distance", m.d[0]),
            Equation("y", "distance", m.d[1]),
            Equation("angle", "angle", m.phi_b - m.phi_a),
        ]
