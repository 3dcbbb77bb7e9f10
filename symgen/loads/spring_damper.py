"""Spring-damper: along the line between two markers."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.loads.load import Acting, Load, LoadEffect
from symgen.schema.fields import Bound, MarkerRef, Meaning, Quantity, about


class SpringDamper(Load):
    """A spring and damper along the line between two markers."""

    type: Literal["spring_damper"] = "spring_damper"
    marker_a: Annotated[MarkerRef, about('marker a, `"body.marker"`')]
    marker_b: Annotated[MarkerRef, about('marker b, `"body.marker"`')]
    stiffness: Annotated[Quantity, Meaning("stiffness", "N/m", Bound.NON_NEGATIVE)]
    damping: Annotated[Quantity, Meaning("damping", "N s/m", Bound.NON_NEGATIVE)] = 0.0
    free_length: Annotated[Quantity, Meaning("length without force", "m", Bound.NON_NEGATIVE)] = 0.0

    carries = "force"
    directed = "pulls the markers together"

    def effect(self, m: Acting) -> LoadEffect:
        """Force on b: -(k (l - l_0) + c l') along the line."""
        a, b = m.pair(self.marker_a, self.marker_b)
        out = m.spring(a, b, m.constant("stiffness"), m.constant("damping"), m.constant("free_length"))
        row = m.generalised((b, out.force, ()), (a, [-component for component in out.force], ()))
        action = m.action(out.force)
        return LoadEffect(row, out.potential, out.dissipated, action=action, size=out.pull)
