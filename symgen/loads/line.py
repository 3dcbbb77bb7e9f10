"""Line: a force along the line between two markers, by an expression or table of its length and rate."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.loads.load import Acting, Load, LoadEffect
from symgen.schema.fields import MarkerRef, Meaning, Quantity, Scope, about

MET_POINTS = 1e-24  # m2: points nearer than that have met, and pull nowhere


class Line(Load):
    """A force [N] that pulls two markers together where it is positive: cables, hydraulics, dampers by a table.

    value: an expression of `length` [m] and `rate` [m/s] of the line, and of all that loads may use.
    """

    type: Literal["line"] = "line"
    marker_a: Annotated[MarkerRef, about('marker a, `"body.marker"`')]
    marker_b: Annotated[MarkerRef, about('marker b, `"body.marker"`')]
    value: Annotated[Quantity, Meaning("force that pulls the markers together", "N", scope=Scope.LINE)]

    carries = "force"
    shown_as = "spring_damper"
    directed = "pulls the markers together"

    def effect(self, m: Acting) -> LoadEffect:
        """Force on b: -F(length, rate) e along the unit vector e from a to b, its opposite on a; power -F rate."""
        a, b = m.pair(self.marker_a, self.marker_b)
        d = [of_b - of_a for of_b, of_a in zip(b.r, a.r, strict=True)]
        length = m.larger(m.dot(d, d), MET_POINTS) ** 0.5
        e = [component / length for component in d]
        rate = m.dot(e, [of_b - of_a for of_b, of_a in zip(b.r_dot, a.r_dot, strict=True)])
        pull = m.value("value", length=length, rate=rate)
        force = [-pull * component for component in e]
        row = m.generalised((b, force, ()), (a, [-component for component in force], ()))
        return LoadEffect(row, applied=-pull * rate, action=m.action(force), size=pull)
