"""What a scene consists of, and its accessors; nothing here is checked across parts.

Which joints of a spatial scene place a body by coordinates of their own.

Along a spanning tree from the ground, a joint that fixes an orientation up to its own angles gives them as coordinates:
body b then follows in closed form from body a and the joint, over any number of turns and without a singular angle.
Joints that close loops stay equations between the bodies; a joint that is none without its coordinates, a screw, comes
before those that could.

Parameters: named run-time inputs of the emitted functions.

States: numbers of controllers, filters and actuators that follow first-order equations of their own.

Inputs: named numbers that come from outside during a run, arguments u of the emitted functions.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal, Protocol, Self

from pydantic import Discriminator, Field, Tag

from runtime.contract.orientations import angle_names, is_sequence
from runtime.contract.records import UNITS, Coordinate, CoordinateKind
from runtime.contract.tape import Table
from symgen.couplings import COUPLINGS, Coupling
from symgen.joints import JOINTS, Joint
from symgen.joints.joint import Slide, Turn
from symgen.loads import LOADS, Load
from symgen.scene.bodies import BeamBody, BeamMarker, GroundBody, RigidBody, RigidMarker
from symgen.scene.flexible import FlexibleMarker, ModalBody, ModalMarker, SpatialModalBody, Structure
from symgen.scene.measures import Measure
from symgen.scene.simulation import DeclaredEvent, Initial, Partition, Simulation
from symgen.scene.surfaces import SurfaceTable
from symgen.scene.tables import CurveTable
from symgen.schema.errors import SceneError, did_you_mean
from symgen.schema.expressions import Expression, parse_expression, table_name
from symgen.schema.fields import Flag, Meaning, Name, Number, Quantity, Scope, StrictModel
from symgen.schema.texts import Line, Text


class DeclaredParameter(StrictModel):
    """A number that stays an input of the emitted functions.

    ``default`` is in SI units (``unit`` names them for people). Expressions use the parameter by its name.
    """

    default: Number
    unit: Line = ""
    description: Text = ""


class DeclaredState(StrictModel):
    """s' = rate: an integrator, a filter, an actuator. Expressions of loads and of other states use s by its name.

    ``initial`` is its value at the start, ``unit`` that of s, for people.
    """

    rate: Annotated[Quantity, Meaning("rate of the state", "its unit a second", scope=Scope.STATES)]
    initial: Number = 0.0
    unit: Line = ""
    description: Text = ""


class DeclaredInput(StrictModel):
    """A number that may change during a run; expressions of loads and prescribed motions use it by its name.

    ``default`` is in SI units (``unit`` names them for people). With ``rates`` it comes with its rate and acceleration,
    ``<name>_dot`` and ``<name>_ddot``, as a prescribed motion needs. With ``filter`` [rad/s] what is given from outside
    is the target r of x'' = filter^2 (r - x) - 2 filter x', and the name stands for x, with x' and x''.
    """

    default: Number = 0.0
    unit: Line = ""
    description: Text = ""
    rates: Flag = False
    filter: Annotated[Number, Field(gt=0)] | None = None

    def names(self, name: str) -> list[str]:
        """The entries of u: the value, then rate and acceleration where it has them."""
        return [name, f"{name}_dot", f"{name}_ddot"] if self.has_rates else [name]

    @property
    def has_rates(self) -> bool:
        """Does it come with its rate and acceleration, given or filtered?"""
        return self.rates or self.filter is not None


class Named(Protocol):
    """A body, as far as placing is concerned."""

    @property
    def name(self) -> str:
        """Of the body."""


@dataclass(frozen=True)
class Placement:
    """Joint `joint` places body `child` relative to body `parent` by coordinates of its own, `records`.

    forward: the child is the body of marker b.
    """

    joint: str
    parent: str
    child: str
    forward: bool
    records: tuple[Coordinate, ...]

    @property
    def coordinates(self) -> list[str]:
        """Names of the joint's coordinates."""
        return [entry.name for entry in self.records]


def placements_of(bodies: Sequence[Named], joints: Sequence[Joint], coupled: Collection[str] = ()) -> list[Placement]:
    """The placing joints, in scene order; those coupled by their coordinates are taken first.

    What placing joints do not reach from the ground is oriented by itself.
    """
    found: dict[str, Placement] = {}
    reached, queue = {"ground"}, ["ground"]
    roots = [body.name for body in bodies]

    def place(parent: str, needed: bool) -> None:
        """Reach the bodies on the joints of one, at once those beyond joints that must place a body."""
        for joint, child, forward in _placing_from(joints, parent):
            if child not in reached and (not needed or not joint.closes_loops() or joint.name in coupled):
                reached.add(child)
                queue.append(child)
                found[joint.name] = Placement(joint.name, parent, child, forward, _coordinates(joint))
                place(child, needed=True)

    place("ground", needed=True)
    while queue or roots:
        if not queue:
            root = _next_root(joints, roots, reached)
            roots.remove(root)
            if root not in reached:
                reached.add(root)
                queue.append(root)
                place(root, needed=True)
            continue
        place(queue.pop(0), needed=False)
    return [found[joint.name] for joint in joints if joint.name in found]


def _coordinates(joint: Joint) -> tuple[Coordinate, ...]:
    return tuple(
        Coordinate(f"{joint.name}.{motion.name}", joint.name, motion.kind, UNITS[motion.kind])
        for motion in joint.motions or ()
    )


def _next_root(joints: Sequence[Joint], roots: list[str], reached: set[str]) -> str:
    """A body joined to what has been reached, if there is one."""
    for joint in joints:
        ends = (joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0])
        for near, far in (ends, ends[::-1]):
            if near in reached and far in roots and far not in reached:
                return far
    return roots[0]


def _placing_from(joints: Sequence[Joint], body: str) -> Iterator[tuple[Joint, str, bool]]:
    """Placing joints of a body with the body at their other end."""
    for joint in joints:
        ends = (joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0])
        if joint.motions is not None and body in ends:
            yield joint, ends[1] if ends[0] == body else ends[0], ends[0] == body


AnyBody = GroundBody | RigidBody | BeamBody | ModalBody | SpatialModalBody
AnyMarker = RigidMarker | BeamMarker | ModalMarker | FlexibleMarker
# the coordinates that orient a body: names within the body, and what they measure
ORIENTATIONS: dict[str, tuple[tuple[str, CoordinateKind], ...]] = {
    "plane": (("theta", "angle"),),
    "parameters": tuple((f"e{k}", "euler_parameter") for k in range(4)),
}
Body = Annotated[AnyBody, Field(discriminator="type")]
AnyTable = Annotated[
    Annotated[CurveTable, Tag("curve")] | Annotated[SurfaceTable, Tag("surface")],
    Discriminator(lambda given: "surface" if _has_z(given) else "curve"),
]
if TYPE_CHECKING:
    AnyJoint = Joint
    AnyLoad = Load
    AnyCoupling = Coupling
else:
    AnyJoint = Annotated[reduce(or_, JOINTS.values()), Field(discriminator="type")]
    AnyCoupling = Annotated[reduce(or_, COUPLINGS.values()), Field(discriminator="type")]
    AnyLoad = Annotated[reduce(or_, LOADS.values()), Field(discriminator="type")]


def _has_z(given: object) -> bool:
    return isinstance(given, SurfaceTable) or (isinstance(given, Mapping) and "z" in given)


class SceneParts(StrictModel):
    """The parts of a scene: each sound by itself. `SceneRecord` adds the checks across them."""

    name: Name
    title: Line = ""
    description: Text = ""
    space: Literal["planar", "spatial"] = "planar"
    gravity: Annotated[tuple[Quantity, ...], Meaning("acceleration of gravity, (x, y) or (x, y, z)", "m/s^2")] = (
        0.0,
        0.0,
    )
    parameters: dict[Name, DeclaredParameter] = Field(default_factory=dict)
    inputs: dict[Name, DeclaredInput] = Field(default_factory=dict)
    tables: dict[Name, AnyTable] = Field(default_factory=dict)
    states: dict[Name, DeclaredState] = Field(default_factory=dict)
    events: dict[Name, DeclaredEvent] = Field(default_factory=dict)
    bodies: tuple[Body, ...] = ()
    joints: tuple[AnyJoint, ...] = ()
    couplings: tuple[AnyCoupling, ...] = ()
    loads: tuple[AnyLoad, ...] = ()
    measures: tuple[Measure, ...] = ()
    structure: Structure | None = None
    partition: Partition = Partition()
    initial: Initial = Initial()
    simulation: Simulation = Simulation()

    @property
    def ground(self) -> GroundBody:
        """The ground, also when the scene does not mention it."""
        return next((body for body in self.bodies if isinstance(body, GroundBody)), GroundBody())

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy with other parts, which looks for its bodies anew."""
        copied = super().model_copy(update=update, deep=deep)
        for known in ("moving_bodies", "_bodies"):
            copied.__dict__.pop(known, None)
        return copied

    @cached_property
    def moving_bodies(self) -> tuple[RigidBody | BeamBody | ModalBody | SpatialModalBody, ...]:
        """All bodies but the ground, in the scene's order."""
        return tuple(body for body in self.bodies if not isinstance(body, GroundBody))

    def body(self, name: str) -> AnyBody:
        """The body of that name ("ground" included); raises SceneError."""
        if name not in self._bodies:
            raise SceneError("bodies", f"there is no body '{name}'", did_you_mean(name, self._bodies))
        return self._bodies[name]

    @cached_property
    def _bodies(self) -> dict[str, AnyBody]:
        return {body.name: body for body in (self.ground, *self.moving_bodies)}

    def marker(self, reference: str) -> tuple[AnyBody, AnyMarker]:
        """The body and the marker behind "body.marker", implicit markers included; raises SceneError."""
        name, _, marker = reference.partition(".")
        body = self.body(name)
        markers: dict[str, AnyMarker] = {**body.implicit_markers(), **body.markers}
        if marker not in markers:
            raise SceneError(f"body '{name}'", f"it has no marker '{marker}'", did_you_mean(marker, markers))
        return body, markers[marker]

    def joint_of(self, coordinate: str) -> tuple[Joint, Turn | Slide]:
        """The joint and its motion behind "joint.angle"; raises SceneError."""
        name, _, motion = coordinate.partition(".")
        for joint in self.joints:
            if joint.name == name:
                return joint, joint.motion_of(motion)
        remedy = did_you_mean(name, [joint.name for joint in self.joints])
        raise SceneError("joints", f"there is no joint '{name}'", remedy)

    def coordinates(self) -> list[str]:
        """The names of the coordinates q, in order: R_o, theta, q1 ... of each body, those of joints, of states."""
        return [entry.name for entry in self.coordinate_records()]

    def coordinate_records(self) -> list[Coordinate]:
        """The coordinates q, in the same order: what each measures and whose it is."""
        if self.structure is not None:
            return [Coordinate(name, "", "position", UNITS["position"]) for name in self.structure.coordinates]
        found = []
        for body in self.moving_bodies:
            found += [
                Coordinate(f"{body.name}.{part}", body.name, kind, UNITS[kind], 1.0 if part == "e0" else 0.0)
                for part, kind in self.frame_parts(body)
            ]
            twisting = body.torsion.modes if isinstance(body, BeamBody) and body.torsion else 0
            units = [UNITS["modal"]] * (body.nf - twisting) + [UNITS["angle"]] * twisting
            found += [Coordinate(f"{body.name}.q{k + 1}", body.name, "modal", unit) for k, unit in enumerate(units)]
        found += [entry for placement in self.placements() for entry in placement.records]
        return found + [
            Coordinate(f"{name}.integral", name, "state", f"{state.unit} s".strip())
            for name, state in self.states.items()
        ]

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return 3 if self.space == "spatial" else 2

    def frame_coordinates(self, body: AnyBody) -> tuple[str, ...]:
        """The names of R_o and of the orientation of a body's frame."""
        return tuple(part for part, _ in self.frame_parts(body))

    def frame_parts(self, body: AnyBody) -> list[tuple[str, CoordinateKind]]:
        """R_o and the orientation of a body's frame: (name within the body, what it measures)."""
        turning = ORIENTATIONS["plane" if self.space == "planar" else "parameters"]
        return [*((axis, "position") for axis in "xyz"[: self.dimension]), *turning]

    def euler_angles(self) -> dict[str, str]:
        """Sequence of axes of each body of a spatial scene that is described by Euler angles."""
        kinds = {body.name: str(getattr(body, "orientation", "")) for body in self.moving_bodies}
        return {name: kind for name, kind in kinds.items() if self.space == "spatial" and is_sequence(kind)}

    def angles(self) -> list[str]:
        """Names of all Euler angles, which are input and output only."""
        return [name for body in self.euler_angles() for name in angle_names(body)]

    def placements(self) -> list[Placement]:
        """The joints that place a body by coordinates of their own, in scene order (spatial scenes)."""
        if self.space == "planar":
            return []
        coupled = {name.partition(".")[0] for coupling in self.couplings for name in coupling.named}
        return placements_of(self.moving_bodies, self.joints, coupled)

    def placing(self) -> set[str]:
        """Names of those joints."""
        return {placement.joint for placement in self.placements()}

    def switched_parameters(self) -> set[str]:
        """Parameters that actions of events set: they are held as inputs are, and stand where inputs may."""
        return {target for event in self.events.values() for target in event.action} & set(self.parameters)

    def all_inputs(self) -> dict[str, DeclaredInput]:
        """The declared inputs, and the parameters that events set as inputs."""
        switched = self.switched_parameters()
        found = {name: entry for name, entry in self.parameters.items() if name in switched}
        return {**self.inputs, **{name: DeclaredInput(**entry.model_dump()) for name, entry in found.items()}}

    def fixed_parameters(self) -> dict[str, DeclaredParameter]:
        """Parameters that stay as they are during a run."""
        switched = self.switched_parameters()
        return {name: parameter for name, parameter in self.parameters.items() if name not in switched}

    def parameter_defaults(self) -> dict[str, float]:
        """Their names and default values, in SI units."""
        return {name: parameter.default for name, parameter in self.fixed_parameters().items()}

    def input_defaults(self) -> dict[str, float]:
        """The entries of u by name and what they are at rest: defaults, rates zero."""
        inputs = self.all_inputs()
        names = {name: entry.names(name) for name, entry in inputs.items()}
        return {part: inputs[name].default if part == name else 0.0 for name in names for part in names[name]}

    def expression(self, text: str | float, item: str, extra_names: tuple[str, ...] = ()) -> Expression:
        """Parse a quantity that may use the parameters, tables and ``extra_names`` ("t"); raises SceneError."""
        names = (*self.fixed_parameters(), *self.table_names(), *extra_names)
        return parse_expression(text, frozenset(names), item)

    def table_names(self) -> dict[str, AnyTable]:
        """The tables by what expressions know them by."""
        return {table_name(name, len(table.kinks())): table for name, table in self.tables.items()}

    def curves(self) -> dict[str, Table]:
        """The tables of one value that all tables are made of, by what emitted code calls them."""
        return {name: curve for table, one in self.tables.items() for name, curve in one.tables(table).items()}
