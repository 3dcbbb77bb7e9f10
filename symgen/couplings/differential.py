"""Differential: an angle that is the mean of two others, times a ratio."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from symgen.couplings.coupling import Coupling, Read
from symgen.schema.fields import Coordinate, Meaning, Quantity, about


class Differential(Coupling):
    """A differential: input angle = ratio (angle a + angle b) / 2, with equal torques on a and b."""

    type: Literal["differential"] = "differential"
    input: Annotated[Coordinate, about('angle of the input, `"joint.angle"`')]
    output_a: Annotated[Coordinate, about('angle of output a, `"joint.angle"`')]
    output_b: Annotated[Coordinate, about('angle of output b, `"joint.angle"`')]
    ratio: Annotated[Quantity, Meaning("turns of the input for a turn of both outputs")] = 1.0

    coordinates = ("input", "output_a", "output_b")
    kinds = {"input": "angle", "output_a": "angle", "output_b": "angle"}
    not_zero = ("ratio",)

    def coefficients(self, of: Read) -> list[Any]:
        """input - ratio/2 (a + b)."""
        half = -of("ratio") / 2
        return [half, half]
