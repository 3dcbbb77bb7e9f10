"""Cylindrical joint: b turns about and slides along the z-axis of marker a (space)."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.joint import PARALLEL, Joint, Slide, Turn, Z
from symgen.schema.fields import Bound, Meaning, Quantity


class CylindricalJoint(Joint):
    """Turns about and slides along marker a's z-axis (spatial). damping [N m s/rad], travel_damping [N s/m]."""

    type: Literal["cylindrical"] = "cylindrical"
    damping: Annotated[Quantity, Meaning("damping of the rotation", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0
    travel_damping: Annotated[Quantity, Meaning("damping of the sliding", "N s/m", Bound.NON_NEGATIVE)] = 0.0

    points = "on_axis"
    perpendicular = PARALLEL
    motions = (Turn(Z, "angle", damping="damping"), Slide(Z, "travel", damping="travel_damping"))
    drawing = "slide"
