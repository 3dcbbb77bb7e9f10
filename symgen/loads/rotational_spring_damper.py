"""Rotational spring-damper: on the angle between two markers."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

from symgen.loads.load import Acting, LinearSpring, Load, LoadEffect, on
from symgen.schema.fields import Bound, MarkerRef, Meaning, Quantity, about


class RotationalSpringDamper(Load):
    """A spring and damper on the angle phi_b - phi_a; in space on the angle about marker a's z-axis.

    In space the angle is that of the joint between the two markers, or else one between -pi and pi.
    """

    type: Literal["rotational_spring_damper"] = "rotational_spring_damper"
    marker_a: Annotated[MarkerRef, about('marker a, `"body.marker"`')]
    marker_b: Annotated[MarkerRef, about('marker b, `"body.marker"`')]
    stiffness: Annotated[Quantity, Meaning("stiffness", "N m/rad", Bound.NON_NEGATIVE)]
    damping: Annotated[Quantity, Meaning("damping", "N m s/rad", Bound.NON_NEGATIVE)] = 0.0
    free_angle: Annotated[Quantity, Meaning("angle without torque", "rad")] = 0.0

    carries = "moment"
    directed = "turns marker b on"

    def effect(self, m: Acting) -> LoadEffect:
        """Moment on b: -k (angle - free angle) - c angle'."""
        angle = m.angle(self.marker_a, self.marker_b)
        stiffness, damping = m.constant("stiffness"), m.constant("damping")
        turn = angle.value - m.constant("free_angle")
        powers = {"potential": stiffness * turn**2 / 2, "dissipated": damping * angle.rate**2}
        effect = on(angle, m, -stiffness * turn - damping * angle.rate, **powers)
        return replace(effect, spring=LinearSpring(angle.row, stiffness, damping))
