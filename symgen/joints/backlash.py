"""Play between two parts, as of teeth: a spring and damper act where it is used up."""

from __future__ import annotations

from typing import Annotated

from symgen.schema.fields import Bound, Meaning, Quantity, StrictModel


class Backlash(StrictModel):
    """No force within gap/2 to both sides of zero [m or rad]; beyond it by d: k d + c d', no less than 0 and no more
    than 2 k d, so that it never pulls. stiffness k [N/m or N m/rad], damping c [N s/m or N m s/rad].
    """

    gap: Annotated[Quantity, Meaning("play from side to side", "m or rad", Bound.NON_NEGATIVE)]
    stiffness: Annotated[Quantity, Meaning("stiffness beyond the play", "N/m or N m/rad", Bound.POSITIVE)]
    damping: Annotated[Quantity, Meaning("damping beyond the play", "N s/m or N m s/rad", Bound.NON_NEGATIVE)] = 0.0
