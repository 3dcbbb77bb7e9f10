"""What a finite-element body bears between two of its markers before it buckles."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator

from symgen.schema.fields import Name, Number, StrictModel, refuse


def _positive(value: float) -> float:
    if value <= 0.0:
        raise refuse(f"{value:g} is not positive", "leave it out where the body does not buckle")
    return value


Load = Annotated[Number, AfterValidator(_positive)]


class FlexibleStrut(StrictModel):
    """Critical loads [N] along the line between two markers, as FlexibleBody.fields gives them.

    held: both markers are held in place; first, second: this one is clamped, the other free. Left out: no such load.
    """

    markers: tuple[Name, Name]
    held: Load | None = None
    first: Load | None = None
    second: Load | None = None
