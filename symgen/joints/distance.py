"""Distance: a massless rod of fixed length between two points."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.joints.joint import Equation, InPlane, InSpace, Joint
from symgen.schema.fields import Bound, Meaning, Quantity


class DistanceJoint(Joint):
    """A massless rod between two points: row |r_b - r_a|^2 - length^2. length [m]."""

    type: Literal["distance"] = "distance"
    length: Annotated[Quantity, Meaning("length of the rod", "m", Bound.POSITIVE)]

    equation = "|r_b - r_a| - length = 0"
    at_a = at_b = "force"
    drawing = "rod"

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """(d.d - length^2) / (2 length) = 0, in metres."""
        length = m.field("length")
        return [Equation("length", "distance", (m.dot(m.d, m.d) - length**2) / (2 * length))]

    @classmethod
    def rows_in_space(cls, m: InSpace) -> list[Equation]:
        """The same."""
        length = m.field("length")
        C = (m.dot(m.d, m.d) - length**2) / (2 * length)
        return [Equation("length", "distance", C, "|r_b - r_a| - length")]
