"""What a model is made of, as records: the generator writes them into the manifest, the runtime reads them there.

Nothing reads physics out of the spelling of a name: what a coordinate measures or what sign a parameter must have is
said here. Files of the two halves exchange these records only, as JSON (`as_plain`, `description`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from runtime.contract.beams.records import BeamRecord, beam_records
from runtime.contract.drawing_records import Drawing as Drawing
from runtime.contract.drawing_records import PointRecord as PointRecord
from runtime.contract.drawing_records import ShapeRecord as ShapeRecord
from runtime.contract.drawing_records import SurfaceRecord as SurfaceRecord
from runtime.contract.event_records import EventRecord as EventRecord
from runtime.contract.orientations import OrientationRecord
from runtime.contract.stress_records import GaugeRecord as GaugeRecord
from runtime.contract.stress_records import StrutRecord as StrutRecord

CoordinateKind = Literal["position", "angle", "euler_parameter", "modal", "state"]
ConstraintKind = Literal["distance", "angle", "direction", "quaternion", "norm"]
ParameterKind = Literal["declared", "scene", "data", "input"]
Bound = Literal["any", "positive", "not negative"]
# A ladder: what a function takes is known at its stage. Stage -> the arguments that are known from there on.
STAGES: dict[str, tuple[str, ...]] = {
    "constants": ("p",),
    "closure": ("c", "t", "u", "chart", "q_i", "q_d"),
    "velocities": ("q_i_dot",),
    "condensed": ("q_d_dot", "q", "q_dot"),
    "accelerations": ("q_i_ddot", "q_L_ddot", "crossing", "interface", "shift", "push"),
    "reactions": ("q_ddot", "lam_R"),
    "report": (),
}
RATES = ("", "/s", "/s^2")
UNITS: dict[CoordinateKind, str] = {"position": "m", "angle": "rad", "euler_parameter": "1", "modal": "m", "state": "s"}
ROW_UNITS: dict[ConstraintKind, str] = dict(distance="m", angle="rad", direction="1", quaternion="1", norm="1")


@dataclass(frozen=True)
class Coordinate:
    """An entry of q: its owner ("" in a structure), SI unit, value at rest. Of kind `state`: its rate is the owner."""

    name: str
    owner: str
    kind: CoordinateKind
    unit: str
    at_rest: float = 0.0

    @property
    def elastic(self) -> bool:
        """Is it a modal coordinate of a flexible body?"""
        return self.kind == "modal"

    @property
    def turns(self) -> bool:
        """Is it an angle or an Euler parameter?"""
        return self.kind in ("angle", "euler_parameter")

    def unit_of(self, derivative: int = 0) -> str:
        """SI unit of the coordinate (0), its rate (1) or its acceleration (2)."""
        return self.unit + RATES[derivative]


@dataclass(frozen=True)
class Constraint:
    """A row of C(q, t) = 0: its label, the joint that it belongs to ("" for a body's own), what it measures."""

    label: str
    joint: str
    kind: ConstraintKind
    unit: str


@dataclass(frozen=True)
class Parameter:
    """An entry of p: SI unit, meaning, where it comes from (declared, scene, data), default value.

    bound: the sign that its uses ask for. array: the array whose entry it is, "" for a single number.
    """

    name: str
    unit: str
    meaning: str
    kind: ParameterKind
    default: float
    bound: Bound = "any"
    array: str = ""


@dataclass(frozen=True)
class InputRecord:
    """A number that comes from outside during a run: SI unit, meaning, default.

    rates: rate and acceleration stand behind it in u; filter [rad/s]: see runtime/contract/signals.py, 0 for none.
    """

    name: str
    unit: str
    meaning: str
    default: float
    rates: bool = False
    filter: float = 0.0


@dataclass(frozen=True)
class BoundedQuantity:
    """An expression of parameters whose value must have a sign; entry of the output of the function `bounded`."""

    item: str
    expression: str
    bound: Bound


@dataclass(frozen=True)
class Group:
    """A group of the partition (Eqs. 39, 72): its name and positions in q_i. Groups run from slow to fast."""

    name: str
    positions: list[int]


@dataclass(frozen=True)
class BodyRecord:
    """A body: its type and markers; orientation: sequence of its Euler angles, "euler_parameters", "" in the plane.

    angles: names of its Euler angles, which are input and output, in order.
    """

    name: str
    type: str
    markers: list[str]
    orientation: str = ""
    angles: list[str] = field(default_factory=list)


JointDrawing = Literal["pivot", "slide", "rod", "weld", "drive"]


@dataclass(frozen=True)
class JointRecord:
    """A joint between two markers "body.marker"; coordinates: names of those that it has itself.

    drawing: what pictures show; a drive prescribes a motion between markers at which another joint is drawn.
    """

    name: str
    type: str
    marker_a: str
    marker_b: str
    body_a: str
    body_b: str
    coordinates: list[str] = field(default_factory=list)
    drawing: JointDrawing = "pivot"


@dataclass(frozen=True)
class LoadRecord:
    """A load: its type and the markers that it acts at by their role (marker, marker_a, marker_b, reaction)."""

    name: str
    type: str
    markers: dict[str, str]


@dataclass(frozen=True)
class Measure:
    """A scalar of the motion and its SI unit; the rate of a measure is a measure of its own."""

    name: str
    unit: str


@dataclass(frozen=True)
class Signal:
    """An argument or output of a function: shape in the symbols of the names page and as numbers, SI unit, meaning."""

    name: str
    shape: str
    unit: str
    meaning: str
    size: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class FunctionSpec:
    """An emitted function: paper's equation ("38", "" for none), meaning, stage, arguments and outputs, operations."""

    name: str
    equation: str
    meaning: str
    stage: str
    inputs: list[Signal]
    outputs: list[Signal]
    operations: int = 0


@dataclass(frozen=True)
class LoadedBody:
    """A body with modes of its own in space: names of its loads and frictions, in the order of `load_forces`.

    Their columns come after those of the beams.
    """

    body: str
    loads: list[str]


@dataclass(frozen=True)
class Description:
    """All that is said of a model in words: everything but its functions and its numbers.

    q_i, q_d, loop_unknowns: names of coordinates; redundant: labels of the rows that the others imply; gravity: its
    components [m/s^2] at default parameters; simulation: what runs use where nothing else is said; inputs: those of u;
    beams: those with exact shapes; flexible: other bodies with modes in space that loads act on; gauges: where
    stresses are known; struts: between which markers bodies buckle;
    switching: the load, joint or state of each output of the function `switching`; events: those of `events`.
    """

    name: str
    title: str
    coordinates: list[Coordinate]
    q_i: list[str]
    q_d: list[str]
    loop_unknowns: list[str]
    groups: list[Group]
    constraints: list[Constraint]
    redundant: list[str]
    bodies: list[BodyRecord]
    joints: list[JointRecord]
    loads: list[LoadRecord]
    measures: list[Measure]
    drawing: Drawing
    gravity: list[float]
    parameters: list[Parameter]
    bounded: list[BoundedQuantity]
    functions: list[FunctionSpec]
    simulation: Mapping[str, Any]
    inputs: list[InputRecord] = field(default_factory=list)
    beams: list[BeamRecord] = field(default_factory=list)
    flexible: list[LoadedBody] = field(default_factory=list)
    events: list[EventRecord] = field(default_factory=list)
    switching: list[str] = field(default_factory=list)
    orientations: list[OrientationRecord] = field(default_factory=list)
    gauges: list[GaugeRecord] = field(default_factory=list)
    struts: list[StrutRecord] = field(default_factory=list)

    @property
    def load_columns(self) -> list[tuple[str, str]]:
        """(body, load or joint with friction) of each column of `load_forces`."""
        beams = [(record.body, name) for record in self.beams for name in record.loads]
        return beams + [(record.body, name) for record in self.flexible for name in record.loads]


_TABLES: dict[str, type] = {
    "coordinates": Coordinate,
    "groups": Group,
    "constraints": Constraint,
    "bodies": BodyRecord,
    "joints": JointRecord,
    "loads": LoadRecord,
    "measures": Measure,
    "parameters": Parameter,
    "bounded": BoundedQuantity,
    "inputs": InputRecord,
    "events": EventRecord,
    "flexible": LoadedBody,
    "orientations": OrientationRecord,
    "gauges": GaugeRecord,
    "struts": StrutRecord,
}
# tables that are not written where they are empty
_MAY_LACK = ("inputs", "beams", "flexible", "switching", "events", "orientations", "gauges", "struts")


def as_plain(description: Description) -> dict[str, Any]:
    """The description as plain values for JSON; a model without shapes, inputs, beams, ... has no entry for them.

    Nor has a joint that is drawn as a pivot.
    """
    plain = asdict(description)
    for looks in ("shapes", "surfaces"):
        if not plain["drawing"][looks]:
            del plain["drawing"][looks]
    for joint in plain["joints"]:
        if joint["drawing"] == "pivot":
            del joint["drawing"]
    return {key: value for key, value in plain.items() if value or key not in _MAY_LACK}


def description(plain: Mapping[str, Any]) -> Description:
    """The description that `as_plain` wrote. Raises KeyError or TypeError for anything else."""
    values: dict[str, Any] = {
        key: plain.get(key, []) if key in _MAY_LACK else plain[key] for key in Description.__dataclass_fields__
    }
    for key, record in _TABLES.items():
        values[key] = [record(**entry) for entry in values[key]]
    values["functions"] = [
        FunctionSpec(
            **{**entry, **{side: [Signal(**signal) for signal in entry[side]] for side in ("inputs", "outputs")}}
        )
        for entry in values["functions"]
    ]
    values["beams"] = beam_records(values["beams"])
    points = [PointRecord(**entry) for entry in plain["drawing"]["points"]]
    shapes = [ShapeRecord(**entry) for entry in plain["drawing"].get("shapes", [])]
    surfaces = [SurfaceRecord(**entry) for entry in plain["drawing"].get("surfaces", [])]
    values["drawing"] = Drawing(**{**plain["drawing"], "points": points, "shapes": shapes, "surfaces": surfaces})
    return Description(**values)
