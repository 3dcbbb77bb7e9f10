"""Contact: a ball or disc that touches a plane, or another one, by a penalty force of its penetration depth."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from symgen.joints.joint import Surroundings
from symgen.loads.load import Acting, Load, LoadEffect, Vector
from symgen.schema.fields import Bound, Fault, MarkerRef, Meaning, Number, Quantity, about

MET_CENTRES = 1e-24  # m2: centres nearer than that push nowhere


class Contact(Load):
    """A ball (in the plane a disc) about `marker`, pressed by d against the plane of the marker `plane`, through it and
    across its z-axis (in the plane: its y-axis), on the side of that axis; or against the ball about `other`.

    Normal force k d^n max(0, 1 + D d'), which never pulls; stiffness k [N/m^n], damping D [s/m], exponent n. Friction
    -friction N v_t / sqrt(v_t^2 + slip_speed^2) of the points that touch: it is smooth and creeps, and holds nothing.
    """

    references = (
        "K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, "
        "J. Appl. Mech. 42 (1975) 440-445.",
    )
    type: Literal["contact"] = "contact"
    marker: Annotated[MarkerRef, about('centre of the ball, `"body.marker"`')]
    radius: Annotated[Quantity, Meaning("radius of the ball", "m", Bound.NON_NEGATIVE)]
    plane: Annotated[MarkerRef | None, about("marker of the plane that the ball meets; this or `other`")] = None
    other: Annotated[MarkerRef | None, about("centre of another ball that it meets; this or `plane`")] = None
    other_radius: Annotated[Quantity, Meaning("radius of the other ball", "m", Bound.NON_NEGATIVE)] = 0.0
    stiffness: Annotated[Quantity, Meaning("stiffness of the contact", "N/m^n", Bound.POSITIVE)]
    damping: Annotated[Quantity, Meaning("damping of the contact", "s/m", Bound.NON_NEGATIVE)] = 0.0
    exponent: Annotated[
        Number, Field(ge=1, le=5), about("exponent n of the force [1], from 1 (linear) to 5; 1.5 of Hertz")
    ] = 1.0
    friction: Annotated[Quantity, Meaning("coefficient of friction", "1", Bound.NON_NEGATIVE)] = 0.0
    slip_speed: Annotated[Quantity, Meaning("speed at which friction is 0.7 of its value", "m/s", Bound.POSITIVE)] = (
        1e-3
    )

    carries = "force and moment"

    def effect(self, m: Acting) -> LoadEffect:
        """Force and moment on both bodies at the point r_a - R n of the ball."""
        a, b = m.marker(self.marker), m.marker(self.plane or self.other or "")
        d = [of_a - of_b for of_a, of_b in zip(a.r, b.r, strict=True)]
        n, gap = self._normal(m, b, d)
        radius = m.constant("radius")
        levers = [-radius * one for one in n], [of_d - radius * one for of_d, one in zip(d, n, strict=True)]
        ends = [
            [of_r + turned for of_r, turned in zip(at.r_dot, cross(m.spin(at), lever), strict=True)]
            for at, lever in zip((a, b), levers, strict=True)
        ]
        v = [of_a - of_b for of_a, of_b in zip(*ends, strict=True)]
        away = m.dot(n, v)
        push = m.push(radius - gap, -away, self.exponent)
        slip = [one - away * of_n for one, of_n in zip(v, n, strict=True)]
        held = m.constant("friction") * push.force / (m.dot(slip, slip) + m.constant("slip_speed") ** 2) ** 0.5
        force = [push.force * of_n - held * one for of_n, one in zip(n, slip, strict=True)]
        back = [-one for one in force]
        row = m.generalised((a, force, cross(levers[0], force)), (b, back, cross(levers[1], back)))
        lost = push.lost + held * m.dot(slip, slip)
        rubs = held * m.dot(slip, slip) ** 0.5
        acts = m.action(force, cross(levers[0], force))
        return LoadEffect(row, push.stored, dissipated=lost, action=acts, touching=(push.force, rubs, away))

    def _normal(self, m: Acting, b: Any, d: Vector) -> tuple[Vector, Any]:
        """(n towards the ball, distance of its centre [m])."""
        if self.plane is not None:
            n = m.along(b, [0.0, 1.0]) if len(d) == 2 else m.z(b)
            return n, m.dot(n, d)
        length = m.larger(m.dot(d, d), MET_CENTRES) ** 0.5
        return [one / length for one in d], length - m.constant("other_radius")

    @property
    def markers(self) -> dict[str, str]:
        """The centre, and what it touches."""
        named = {"marker": self.marker, "plane": self.plane, "other": self.other}
        return {key: reference for key, reference in named.items() if reference is not None}

    def record(self, scene: Surroundings) -> tuple[str, dict[str, str]]:
        """A force on the ball and its reaction."""
        return "force", {"marker": self.marker, "reaction": self.plane or self.other or ""}

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """Nothing to touch, or two things; a ball without size against another."""
        if (self.plane is None) == (self.other is None):
            yield Fault("plane", "needs plane or other, and not both", "give one of them")
        elif self.marker.partition(".")[0] == (self.plane or self.other or "").partition(".")[0]:
            body, key = self.marker.partition(".")[0], "plane" if self.plane is not None else "other"
            yield Fault(key, f"is on the body '{body}' of the ball: a body does not touch itself", "name another body")
        elif self.plane is not None and self.other_radius != 0:
            yield Fault("other_radius", "applies to a second ball, but a plane is given", "leave it out")
        elif self.other is not None and self.radius == 0 and self.other_radius == 0:
            yield Fault("radius", "is zero, and so is other_radius: two points never touch", "give one a radius")


def cross(u: Vector, v: Vector) -> list[Any]:
    """u x v: of a turn and a vector in the plane a vector, of two vectors there a moment."""
    if len(u) == 1:
        return [-u[0] * v[1], u[0] * v[0]]
    if len(u) == 2:
        return [u[0] * v[1] - u[1] * v[0]]
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
