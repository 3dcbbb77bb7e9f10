"""Slides on: a point of b stays on the bent line of a beam, along which it is free to move."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from symgen.joints.joint import Joint, Surroundings, beam_faults
from symgen.schema.fields import Fault


class SlidesOn(Joint):
    """Point b slides along the centre line of the beam of marker_a, which bends under it; it may turn.

    Rows y - phi(x) q_f = 0, in space also z - phi(x) q_f = 0, for the place (x, y, z) of point b in the beam's frame.
    """

    type: Literal["slides_on"] = "slides_on"

    equation = "y_b - phi(x_b) q_f = 0"
    points = "on_axis"
    at_a = at_b = "force"
    drawing = "slide"
    on_beam = True

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """Marker a on no beam, or on one whose points move along it by bending or stretching."""
        yield from super().faults(scene)
        name = self.marker_a.partition(".")[0]
        found = list(beam_faults("marker_a", name, scene, moving=True))
        yield from found
        if not found and next(one for one in scene.bodies if one.name == name).axial is not None:
            yield Fault("marker_a", f"the points of '{name}' move along it", "take a beam without axial modes")
