"""Gear: two angles in a fixed ratio."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Coordinate, Meaning, Quantity


class Gear(Coupling):
    """A gear: angle a = ratio times angle b. ratio: turns of a for a turn of b, negative where they turn oppositely.

    Two wheels in mesh on the outside: ratio = -(teeth of b) / (teeth of a).
    """

    type: Literal["gear"] = "gear"
    coordinate_a: Coordinate
    coordinate_b: Coordinate
    ratio: Annotated[Quantity, Meaning("turns of a for a turn of b")]

    kinds = {"coordinate_a": "angle", "coordinate_b": "angle"}
    not_zero = ("ratio",)

    def coefficients(self, of: Read) -> list[Any]:
        """a - ratio b."""
        return [-of("ratio")]
