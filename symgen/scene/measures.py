"""Measures: scalars of the motion that load expressions may use, with their rates ``<measure>_dot``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from symgen.scene.bodies import BeamBody
from symgen.scene.flexible import ALL_GAUGES, SpatialModalBody
from symgen.scene.simulation import unknown_coordinate
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import SPATIAL, Coordinate, Fault, GaugeRef, MarkerRef, Name, StrictModel

KNOWN_BY = {  # which shapes of a beam know a section force
    "normal_force": "axial",
    "shear_force": "lateral",
    "bending_moment": "lateral",
    "shear_force_z": "lateral_z",
    "bending_moment_y": "lateral_z",
    "torsion_moment": "torsion",
}


class _Measure(StrictModel):
    name: Name

    @property
    def markers(self) -> dict[str, str]:
        """The markers that it names, by key."""
        return {}


class MarkerMeasure(_Measure):
    """From marker `relative_to` to marker `of`: the world components x, y, z [m] or the length [m] of r_b - r_a, or the
    angle phi_b - phi_a [rad].

    In space the angle is that about the z-axis of `relative_to`, between -pi and pi; between the markers of a joint
    with an angle of its own it is that angle, over any number of turns.
    """

    type: Literal["angle", "distance", "x", "y", "z"]
    of: MarkerRef
    relative_to: MarkerRef = "ground.origin"

    @property
    def markers(self) -> dict[str, str]:
        """From and to."""
        return {"relative_to": self.relative_to, "of": self.of}

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A height in the plane."""
        if self.type == "z" and scene.space == "planar":
            yield Fault("type", "a planar scene has no z", SPATIAL)


class CoordinateMeasure(_Measure):
    """A coordinate itself [m, rad], for instance a mode or the second angle of a universal joint."""

    type: Literal["coordinate"] = "coordinate"
    of: Coordinate

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A coordinate that is not there."""
        names = scene.coordinates()
        if self.of not in [*names, *scene.angles()]:
            yield unknown_coordinate("of", self.of, names, scene.joints)


class SectionForceMeasure(_Measure):
    """Normal force E A u', shear force -E I w''' [N] or bending moment E I w'' [N m] of a beam at a marker.

    In space also `shear_force_z`, `bending_moment_y`, which is -E I w_z'', and `torsion_moment` G J tau'. From its
    shapes: what the part beyond the marker does to the part before it. `Solution.section_forces` has what equilibrium
    says.
    """

    type: Literal[
        "normal_force", "shear_force", "bending_moment", "shear_force_z", "bending_moment_y", "torsion_moment"
    ]
    of: MarkerRef

    @property
    def markers(self) -> dict[str, str]:
        """On the beam."""
        return {"of": self.of}

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A marker that is on no beam with shapes of the kind that is asked for."""
        body, kind = scene.marker(self.of)[0], KNOWN_BY[self.type]
        if not isinstance(body, BeamBody):
            yield Fault("of", f"'{body.name}' is no beam", "name a marker of a beam")
        elif getattr(body, kind) is None:
            problem = f"'{body.name}' has no {kind} shapes, which would know its {self.type.replace('_', ' ')}"
            yield Fault("type", problem, f"give it {kind} modes, or take Solution.section_forces")


STRESSED_BY = {  # what a stress of a beam needs of its section, by the shapes that it has
    "lateral": ("section_modulus", "the second moment of area over the distance of the outermost fibre"),
    "lateral_z": ("section_modulus_z", "the second moment for the xz-plane over the distance of the outermost fibre"),
    "torsion": ("torsion_modulus", "the torque over the largest shear stress, pi d^3 / 16 of a round bar"),
}


MESH_ERROR = "mesh_error"


class StressMeasure(_Measure):
    """Stress [Pa] of a finite-element body at a gauge `body.gauge` by its modes, in the body's axes; or of a beam.

    component: von_mises, or xx, yy, zz, yz, xz, xy, or mesh_error, what the mesh leaves unknown of it. `body.all`: the
    largest von Mises stress, or error, of all its gauges.
    `Solution.stresses` has what equilibrium says. Of a beam the von Mises stress at a marker `beam.marker`, or the
    largest along it, `beam.all`, by its shapes; see symgen/bodies/stresses.py.
    """

    type: Literal["stress"] = "stress"
    of: GaugeRef
    component: Literal["von_mises", "xx", "yy", "zz", "yz", "xz", "xy", "mesh_error"] = "von_mises"

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A gauge that is not there, or a beam whose section is not known."""
        beams = {body.name: body for body in scene.bodies if isinstance(body, BeamBody)}
        if (beam := beams.get(self.of.partition(".")[0])) is not None:
            yield from self._of_beam(beam)
            return
        gauges = {body.name: [*body.gauges] for body in scene.bodies if isinstance(body, SpatialModalBody)}
        name, _, gauge = self.of.partition(".")
        if not gauges.get(name):
            known = [name for name, own in gauges.items() if own]
            remedy = did_you_mean(name, known) if known else "give FlexibleBody.fields(gauges=...) to its body"
            yield Fault("of", f"there is no body '{name}' with gauges", remedy)
        elif gauge not in (*gauges[name], ALL_GAUGES):
            remedy = did_you_mean(gauge, [*gauges[name], ALL_GAUGES])
            yield Fault("of", f"body '{name}' has no gauge '{gauge}'", remedy)
        elif self.component == MESH_ERROR:
            yield from self._unknown_errors(scene.body(name))
        elif gauge == ALL_GAUGES and self.component != "von_mises":
            yield Fault("component", "the largest of all gauges has no sign", 'take "von_mises", or name one gauge')

    def _unknown_errors(self, body: SpatialModalBody) -> Iterator[Fault]:
        gauge = self.of.partition(".")[2]
        lacking = [name for name, one in body.gauges.items() if gauge in (name, ALL_GAUGES) and not one.error_shapes]
        if lacking:
            remedy = "take what FlexibleBody.fields(gauges=...) gives now"
            yield Fault("component", f"gauge '{lacking[0]}' does not know the error of its mesh", remedy)

    def _of_beam(self, beam: BeamBody) -> Iterator[Fault]:
        place, known = self.of.partition(".")[2], {**beam.implicit_markers(), **beam.markers}
        if place not in (*known, ALL_GAUGES):
            yield Fault("of", f"beam '{beam.name}' has no marker '{place}'", did_you_mean(place, [*known, ALL_GAUGES]))
        if self.component != "von_mises":
            yield Fault("component", "a beam has its von Mises stress only", "leave it out, or divide a section force")
        for kind, (key, meaning) in STRESSED_BY.items():
            if getattr(beam, kind) is not None and getattr(beam, key) is None:
                yield Fault("of", f"'{beam.name}' has no {key}, which its stress needs", f"give it {key}: {meaning}")


Measure = Annotated[
    MarkerMeasure | CoordinateMeasure | SectionForceMeasure | StressMeasure, Field(discriminator="type")
]
