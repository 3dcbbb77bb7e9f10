"""Belt or chain: two pulleys that turn the same way, or against each other where it is crossed."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Bound, Coordinate, Flag, Meaning, Quantity, about


class Belt(Coupling):
    """A belt or chain that does not slip: radius a times angle a = radius b times angle b [m]."""

    type: Literal["belt"] = "belt"
    coordinate_a: Annotated[Coordinate, about('angle of pulley a, `"joint.angle"`')]
    coordinate_b: Annotated[Coordinate, about('angle of pulley b, `"joint.angle"`')]
    radius_a: Annotated[Quantity, Meaning("radius of pulley a", "m", Bound.POSITIVE)]
    radius_b: Annotated[Quantity, Meaning("radius of pulley b", "m", Bound.POSITIVE)]
    crossed: Annotated[Flag, about("whether the belt crosses, so that the pulleys turn oppositely")] = False

    kinds = {"coordinate_a": "angle", "coordinate_b": "angle"}

    def coefficients(self, of: Read) -> list[Any]:
        """a - r_b / r_a b."""
        ratio = of("radius_b") / of("radius_a")
        return [ratio if self.crossed else -ratio]
