"""Moving force: at a place of a beam that moves."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from symgen.joints.joint import Surroundings, beam_faults
from symgen.loads.load import Acting, Load, LoadEffect, Vector
from symgen.schema.fields import Fault, Meaning, Name, Quantity, Scope, about, components_fault


class MovingForce(Load):
    """A force [N] at `place` [m] from a beam's start, an expression of t, measures, states; none beyond its ends.

    frame: "world", or "section": turning with the section where it is.
    """

    type: Literal["moving_force"] = "moving_force"
    beam: Annotated[Name, about("name of the beam")]
    place: Annotated[Quantity, Meaning("place on the beam, from its start", "m", scope=Scope.MEASURES)]
    components: Annotated[tuple[Quantity, ...], Meaning("force, (x, y) or (x, y, z)", "N", scope=Scope.MEASURES)]
    frame: Annotated[
        Literal["world", "section"], about("axes of the components: the world's, or those of the section where it is")
    ] = "world"

    carries = "force"

    def effect(self, m: Acting) -> LoadEffect:
        """Q = F . dr/dq at phi(s(t)); power F . r' of the point of the beam that is there."""
        place = m.value("place")
        on, at = m.place_on(self.beam, place)
        given = m.value("components")
        force = [on * component for component in (m.along(at, given) if self.frame == "section" else given)]
        row, power = m.generalised((at, force, ())), m.dot(force, at.r_dot)

        def beyond(at: float) -> Vector:
            there = m.beyond(self.beam, place, at)
            return [there * component for component in force]

        return LoadEffect(row, applied=power, action=m.action(force), along=(0.0, 1.0, -1.0), beyond=beyond)

    @property
    def acts_at(self) -> list[str]:
        """The beam."""
        return [self.beam]

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """No beam with exact shapes; components."""
        yield from beam_faults("beam", self.beam, scene, moving=True)
        yield from components_fault("components", self.components, scene)
        length = next((one.length for one in scene.bodies if one.name == self.beam and one.type == "beam"), None)
        if isinstance(self.place, float) and isinstance(length, float) and not 0 <= self.place <= length:
            yield Fault("place", f"is off '{self.beam}', which is {length:g} m long", "give a place on the beam")
