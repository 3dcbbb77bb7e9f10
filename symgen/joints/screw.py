"""Screw joint: b turns about the z-axis of marker a and travels along it in proportion (space)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from symgen.joints.joint import Joint, Turn, Z
from symgen.schema.fields import Fault, Meaning, Quantity


class ScrewJoint(Joint):
    """A cylindrical joint whose travel is lead times the turns (spatial): travel = lead angle / 2 pi. lead [m]."""

    type: Literal["screw"] = "screw"
    lead: Annotated[Quantity, Meaning("travel of a turn", "m")]

    motions = (Turn(Z, "angle", lead="lead"),)
    drawing = "slide"

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A lead of zero, which is a revolute joint."""
        yield from super().faults(scene)
        if self.lead == 0:
            yield Fault("lead", "is zero, so that the joint cannot travel", "give a lead, or take a revolute joint")
