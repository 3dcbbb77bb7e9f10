"""Rack and pinion: a travel in a fixed ratio to an angle."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Coordinate, Meaning, Quantity, about


class Rack(Coupling):
    """A rack and pinion: travel = radius times angle; radius [m] negative where the rack runs against the pinion."""

    type: Literal["rack"] = "rack"
    rack: Annotated[Coordinate, about('travel of the rack, `"joint.travel"`')]
    pinion: Annotated[Coordinate, about('angle of the pinion, `"joint.angle"`')]
    radius: Annotated[Quantity, Meaning("pitch radius of the pinion", "m")]

    coordinates = ("rack", "pinion")
    kinds = {"rack": "position", "pinion": "angle"}
    not_zero = ("radius",)

    def coefficients(self, of: Read) -> list[Any]:
        """travel - radius angle."""
        return [-of("radius")]
