"""Screw joint: b turns about the z-axis of marker a and travels along it in proportion (space)."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.joint import Joint, Turn, Z
from symgen.schema.fields import Meaning, Quantity


class ScrewJoint(Joint):
    """A cylindrical joint whose travel is lead times the turns (spatial): travel = lead angle / 2 pi. lead [m]."""

    type: Literal["screw"] = "screw"
    lead: Annotated[Quantity, Meaning("travel of a turn", "m")]

    motions = (Turn(Z, "angle", lead="lead"),)
    drawing = "slide"
