"""Universal joint: two points coincide, x_b stays perpendicular to z_a (space)."""

from __future__ import annotations

from typing import Literal

from symgen.joints.joint import AxisPair, Joint, Turn, X, Z


class UniversalJoint(Joint):
    """Turns about marker a's z-axis, then about b's x-axis: rows r_b - r_a and x_b perpendicular to z_a (spatial)."""

    type: Literal["universal"] = "universal"

    points = "together"
    perpendicular = (AxisPair("cross", Z, X),)
    motions = (Turn(Z, "angle1"), Turn(X, "angle2"))
