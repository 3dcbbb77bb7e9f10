"""Limits of a joint's one free direction: rigid with a restitution, or a spring and damper beyond them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from symgen.schema.fields import Bound, Fault, Meaning, Number, Quantity, StrictModel


class Limits(StrictModel):
    """Stops at `lower` and `upper` [m or rad], one of them or both: rigid or compliant.

    restitution e, from 0 to 1: rigid; who comes with v leaves with e v, and rests there while it is pressed. A start
    `beyond` an end is refused, or moved to it.
    Else, beyond one of them by d: the force k d^n max(0, 1 + D d') of Hunt and Crossley (1975) pushes back, and never
    pulls; stiffness k [N/m^n or N m/rad^n], damping D [s/m or s/rad], exponent n, from 1 to 5, 1 unless given.
    """

    references = (
        "K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, "
        "J. Appl. Mech. 42 (1975) 440-445.",
    )
    example: ClassVar[str] = "limits = {lower = -0.3, upper = 0.3, restitution = 0.5}"

    lower: Annotated[Quantity | None, Meaning("lower end of the way", "m or rad")] = None
    upper: Annotated[Quantity | None, Meaning("upper end of the way", "m or rad")] = None
    restitution: Annotated[
        Quantity | None, Meaning("ratio of the speeds after and before an impact", "1", Bound.NON_NEGATIVE)
    ] = None
    beyond: Literal["refused", "moved"] | None = None
    stiffness: Annotated[Quantity | None, Meaning("stiffness of the stop", "N/m^n or N m/rad^n", Bound.POSITIVE)] = None
    damping: Annotated[Quantity | None, Meaning("damping of the stop", "s/m or s/rad", Bound.NON_NEGATIVE)] = None
    exponent: Annotated[Number, Field(ge=1, le=5)] | None = None

    @property
    def rigid(self) -> bool:
        """Are they stops that give no way?"""
        return self.restitution is not None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """No end at all, or ends that are crossed; neither rigid nor compliant, or both. The rest is bounded."""
        yield from self._law_faults()
        if self.lower is None and self.upper is None:
            yield Fault("limits", "have neither lower nor upper", "give lower or upper, or leave the limits out")
        ends = [one for one in (self.lower, self.upper) if isinstance(one, float | int)]
        if len(ends) == 2 and ends[0] >= ends[1]:
            yield Fault("limits", f"lower {ends[0]:g} is not below upper {ends[1]:g}", "exchange or move them")

    def _law_faults(self) -> Iterator[Fault]:
        compliant = [key for key in ("stiffness", "damping", "exponent") if getattr(self, key) is not None]
        if self.rigid and compliant:
            both = "a restitution and a stiffness" if "stiffness" in compliant else f"a restitution and {compliant[0]}"
            yield Fault("limits", f"has {both}", f"leave {' and '.join(compliant)} out of a rigid stop")
        elif not self.rigid and self.stiffness is None:
            yield Fault("limits", "have neither restitution nor stiffness", "give a restitution, or a stiffness")
        elif not self.rigid and self.beyond is not None:
            yield Fault(
                "limits.beyond", "applies to rigid stops only", "leave it out, or give a restitution for the stiffness"
            )
        if isinstance(self.restitution, float | int) and self.restitution > 1:
            problem = f"{self.restitution:g} is above 1: an impact would make energy"
            yield Fault("limits.restitution", problem, "give 0 (plastic) to 1 (elastic)")
