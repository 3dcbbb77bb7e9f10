"""Limits of a joint's one free direction: a spring and damper beyond them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field

from symgen.schema.fields import Bound, Fault, Meaning, Number, Quantity, StrictModel


class Limits(StrictModel):
    """Stops at `lower` and `upper` [m or rad], one of them or both.

    Beyond one of them by d: the force k d^n max(0, 1 + D d') of Hunt and Crossley (1975) pushes back, and never pulls;
    stiffness k [N/m^n or N m/rad^n], damping D [s/m or s/rad], exponent n, from 1 to 5.
    """

    lower: Annotated[Quantity | None, Meaning("lower end of the way", "m or rad")] = None
    upper: Annotated[Quantity | None, Meaning("upper end of the way", "m or rad")] = None
    stiffness: Annotated[Quantity, Meaning("stiffness of the stop", "N/m^n or N m/rad^n", Bound.POSITIVE)]
    damping: Annotated[Quantity, Meaning("damping of the stop", "s/m or s/rad", Bound.NON_NEGATIVE)] = 0.0
    exponent: Annotated[Number, Field(ge=1, le=5)] = 1.0

    def faults(self, scene: Any) -> Iterator[Fault]:
        """No end at all, or ends that are crossed. Of numbers; the rest is bounded."""
        if self.lower is None and self.upper is None:
            yield Fault("limits", "has no end", "give lower or upper, or leave the limits out")
        ends = [one for one in (self.lower, self.upper) if isinstance(one, float | int)]
        if len(ends) == 2 and ends[0] >= ends[1]:
            yield Fault("limits", f"lower {ends[0]:g} is not below upper {ends[1]:g}", "exchange or move them")
