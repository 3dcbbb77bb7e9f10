"""Measures: scalars of the motion that expressions may use, with their rates ``<measure>_dot``; forces of loads."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from symgen.scene.bodies import BeamBody
from symgen.scene.flexible import ALL_GAUGES, SpatialModalBody
from symgen.scene.simulation import unknown_coordinate
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import (
    SPATIAL,
    WORLD,
    AxesRef,
    Coordinate,
    Fault,
    GaugeRef,
    MarkerRef,
    Meaning,
    Name,
    Quantity,
    Scope,
    StrictModel,
    about,
)
from symgen.schema.texts import Text

AXES_OF_FORCES = ("x", "y", "z")
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

    @property
    def note(self) -> str:
        """What pages say of it where its name and unit do not tell."""
        return ""


class MarkerMeasure(_Measure):
    """From marker `relative_to` to marker `of`: the components x, y, z [m] or the length [m] of r_b - r_a, or the angle
    phi_b - phi_a [rad].

    axes: "world", or a marker in whose axes x, y, z are taken; rates are those of the components, as somebody sees them
    who turns with these axes.
    In space the angle is that about the z-axis of `relative_to`, between -pi and pi; between the markers of a joint
    with an angle of its own it is that angle, over any number of turns.
    """

    type: Literal["angle", "distance", "x", "y", "z"]
    of: MarkerRef
    relative_to: MarkerRef = "ground.origin"
    axes: AxesRef = WORLD

    @property
    def markers(self) -> dict[str, str]:
        """From and to, and whose axes."""
        return {"relative_to": self.relative_to, "of": self.of, **own_axes(self.axes)}

    @property
    def note(self) -> str:
        """Ends and axes, where these are not those of the world."""
        if self.axes == WORLD:
            return ""
        return f"{self.type} from {self.relative_to} to {self.of} in the axes of {self.axes}"

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A height in the plane, axes of what has none."""
        if self.axes != WORLD and self.type in ("angle", "distance"):
            yield Fault("axes", f"the {self.type} is the same in all axes", "leave them out, or take x, y or z")
        if self.type == "z" and scene.space == "planar":
            yield Fault("type", "a planar scene has no z", SPATIAL)


def own_axes(axes: str) -> dict[str, str]:
    """The marker whose axes these are, by its key."""
    return {} if axes == WORLD else {"axes": axes}


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
            yield Fault("of", f"'{body.name}' is not a beam", "name a marker of a beam")
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
    largest along it, `beam.all`, by its shapes, and its normal force by equilibrium where no shape stretches it, which
    loads, states and events cannot use; see symgen/bodies/stresses.py.
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


NAMED = re.compile(r"[A-Za-z][\w.]*")


class ExpressionMeasure(_Measure):
    """An expression of coordinates and their rates, measures, states, inputs, t, parameters and tables.

    It may use all measures but expressions that are declared below it. Its rate `<name>_dot` is known where it uses
    no rates, nor inputs without rates, nor forces.
    """

    type: Literal["expression"] = "expression"
    of: Annotated[Quantity, Meaning("value of the expression", "its unit", scope=Scope.MOTION)]
    unit: Annotated[Text, about("SI unit of its value")] = ""

    @property
    def note(self) -> str:
        """The expression."""
        return str(self.of)

    def uses(self) -> set[str]:
        """All names in it, those of measures among them."""
        return set(NAMED.findall(self.of)) if isinstance(self.of, str) else set()

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Itself, or an expression below it."""
        expressions = [one.name for one in scene.measures if isinstance(one, ExpressionMeasure)]
        for name in expressions[expressions.index(self.name) :]:
            if {name, f"{name}_dot"} & self.uses():
                itself = "itself" if name == self.name else f"'{name}', which is declared below it"
                yield Fault("of", f"uses {itself}", "let expressions use those above them")


class ForceMeasure(_Measure):
    """Force [N] or moment [N m] of the load `of`, along its own line or about its own axis, or a component of it.

    Or of the compliant stops and the play of a joint, on body b along its coordinate, and of a coupling with play.
    component: "own": of a spring or a line what pulls the markers together; of an effort what acts on marker b along
    the coordinate; of a torque, or a rotational spring, what turns the marker, or marker b, on. "normal", "friction":
    of a contact, what presses and the size of what rubs. Or x, y, z of what acts at the marker, or marker b.
    axes: "world", or a marker in whose axes the component is taken.
    """

    type: Literal["force", "moment"]
    of: Name
    component: Literal["own", "normal", "friction", "x", "y", "z"] = "own"
    axes: AxesRef = WORLD

    @property
    def markers(self) -> dict[str, str]:
        """Whose axes."""
        return own_axes(self.axes)

    @property
    def note(self) -> str:
        """Load, component and axes."""
        if self.component not in AXES_OF_FORCES:
            return f"{self.type} of {self.of}" + (f", {self.component}" if self.component != "own" else "")
        return f"{self.type} of {self.of}, {self.component} in the axes of {self.axes}"

    def faults(self, scene: Any) -> Iterator[Fault]:
        """What is not a load, has no such force, or no direction of its own."""
        loads = {load.name: load for load in scene.loads}
        if (kind := pushing(scene).get(self.of)) is not None:
            if self.type != kind:
                yield Fault("type", f"'{self.of}' has a {kind}", f'take "{kind}"')
            elif self.component != "own" or self.axes != WORLD:
                yield Fault("component", f"the {kind} of '{self.of}' is along its coordinate", "leave it out")
            return
        if self.of not in loads:
            yield self._no_load(scene, [*loads])
            return
        load = loads[self.of]
        kind = load.reaction_kind(scene)
        if self.component in ("normal", "friction"):
            if load.type != "contact" or self.type != "force":
                yield Fault("component", f"only the force of a contact has a {self.component} part", "take x, y or z")
            elif self.axes != WORLD:
                yield Fault("axes", "apply to x, y and z only", "leave them out")
        elif self.type not in kind:
            yield Fault("type", f"the {load.type} '{self.of}' has a {kind} only", f'take "{kind}"')
        elif self.component == "own" and not load.directed:
            yield Fault("component", f"the {load.type} '{self.of}' has no line of its own", "take x, y or z")
        elif self.component == "own" and self.axes != WORLD:
            yield Fault("axes", "apply to a component only", "leave them out, or take x, y or z")
        elif scene.space == "planar" and self.component in (("x", "y") if self.type == "moment" else ("z",)):
            what = "moments have z alone" if self.type == "moment" else "forces have x and y"
            yield Fault("component", f"in a planar scene {what}", SPATIAL)

    def _no_load(self, scene: Any, loads: list[str]) -> Fault:
        if self.of in [entry.name for entry in (*scene.joints, *scene.couplings)]:
            remedy = f"results have it: run.joint_force('{self.of}'), columns '{self.of}.force_x', ..."
            return Fault(
                "of", f"the force of '{self.of}' follows from accelerations, which measures do not know", remedy
            )
        return Fault("of", f"there is no load '{self.of}'", did_you_mean(self.of, loads))


def pushing(scene: Any) -> dict[str, str]:
    """Joints and couplings with compliant stops or play, by name: have they a "force" or a "moment"?"""
    found = {}
    for joint in scene.joints:
        limits, backlash = getattr(joint, "limits", None), getattr(joint, "backlash", None)
        if backlash is not None or (limits is not None and not limits.rigid):
            found[joint.name] = "moment" if joint.motions[0].kind == "angle" else "force"
    for coupling in scene.couplings:
        if coupling.backlash is not None:
            turns = scene.joint_of(coupling.named[0])[1].kind == "angle"
            found[coupling.name] = "moment" if turns else "force"
    return found


def known_late(measures: Iterable[_Measure]) -> set[str]:
    """Forces of loads, and expressions of them: measures that loads, states and motions cannot use."""
    late: set[str] = set()
    for one in measures:
        if isinstance(one, ForceMeasure):
            late.add(one.name)
    for one in measures:
        if isinstance(one, ExpressionMeasure) and one.uses() & {*late, *(f"{name}_dot" for name in late)}:
            late.add(one.name)
    return late


def accelerated(scene: Any) -> set[str]:
    """Measures that accelerations make known: stresses of beams without axial modes, and expressions of them."""
    beams = {body.name for body in scene.bodies if isinstance(body, BeamBody) and body.axial is None}
    found: set[str] = set()
    for one in scene.measures:
        if isinstance(one, StressMeasure) and one.of.partition(".")[0] in beams:
            found.add(one.name)
    for one in scene.measures:
        if isinstance(one, ExpressionMeasure) and one.uses() & found:
            found.add(one.name)
    return found


Measure = Annotated[
    MarkerMeasure | CoordinateMeasure | SectionForceMeasure | StressMeasure | ExpressionMeasure | ForceMeasure,
    Field(discriminator="type"),
]
