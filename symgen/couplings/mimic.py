"""Mimic: a coordinate that follows another one, as in robot descriptions."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Coordinate, Meaning, Quantity, about


class Mimic(Coupling):
    """Ties a coordinate to another one: coordinate = multiplier times that + offset [rad or m]."""

    type: Literal["mimic"] = "mimic"
    coordinate: Annotated[Coordinate, about('coordinate that is tied, `"joint.angle"` or `"joint.travel"`')]
    follows: Annotated[Coordinate, about("coordinate of the same kind that it follows")]
    multiplier: Annotated[Quantity, Meaning("what the coordinate does for a unit of the one that it follows")] = 1.0
    offset: Annotated[Quantity, Meaning("value where the one that it follows is zero", "rad or m")] = 0.0

    coordinates = ("coordinate", "follows")
    not_zero = ("multiplier",)
    from_start = False

    def coefficients(self, of: Read) -> list[Any]:
        """x - multiplier y."""
        return [-of("multiplier")]

    def constant(self, of: Read) -> Any:
        """The offset."""
        return of("offset")
