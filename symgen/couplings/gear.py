"""Gear: two angles in a fixed ratio."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Coordinate, Meaning, Quantity, about


class Gear(Coupling):
    """A gear: angle a = ratio times angle b. ratio: turns of a for a turn of b, negative where they turn oppositely.

    Two wheels in mesh on the outside: ratio = -(teeth of b) / (teeth of a).
    """

    type: Literal["gear"] = "gear"
    coordinate_a: Annotated[Coordinate, about('angle of wheel a, `"joint.angle"`')]
    coordinate_b: Annotated[Coordinate, about('angle of wheel b, `"joint.angle"`')]
    ratio: Annotated[Quantity, Meaning("turns of a for a turn of b")]

    kinds = {"coordinate_a": "angle", "coordinate_b": "angle"}
    not_zero = ("ratio",)

    def coefficients(self, of: Read) -> list[Any]:
        """a - ratio b."""
        return [-of("ratio")]
