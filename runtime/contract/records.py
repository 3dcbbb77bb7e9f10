"""What a model is made of, as records: the generator writes them into the manifest, the runtime reads them there."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal, get_args

import numpy as np

from runtime.contract.orientations import OrientationRecord

# Arrays as text: base64 of the numbers in little-endian order.


def packed(values: np.ndarray, kind: str = "<f4") -> str:
    """The text of an array, whatever its shape."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode("ascii")


def unpacked(text: str, kind: str = "<f4") -> np.ndarray:
    """The numbers of `packed`, flat. Raises ValueError for another text."""
    return np.frombuffer(base64.b64decode(text, validate=True), dtype=kind)


# The names of the time stepping schemes: a scene may ask for one, the runtime has them.

SchemeName = Literal[
    "auto",
    "single_rate",
    "printed",
    "coupled",
    "exponential",
    "exponential_rk4",
    "exponential_adams",
    "rk4",
    "dopri5",
    "dop853",
    "radau",
]
SCHEME_NAMES: tuple[str, ...] = get_args(SchemeName)
# schemes with a step of its own for each group: only they need the ratios m between groups
GROUPED_SCHEMES: tuple[SchemeName, ...] = ("printed", "coupled")


# Places of a flexible body whose stress is known, with what it follows from; and loads under which it buckles.


@dataclass(frozen=True)
class GaugeRecord:
    """A place of `body` at `position` [m] in its axes; stresses in the order xx yy zz yz xz xy [Pa].

    shapes (6, nf): per unit of q_f. fields (6, 9 + 9 nf), forces (6, 6) by marker: per unit of each cause of
    runtime.contract.flexible; empty where they are not known. error_shapes (r, nf), error_fields, error_forces (r, 6):
    rows [Pa] whose sum over the causes has the length of the error that the mesh leaves.
    """

    body: str
    name: str
    position: list[float]
    shapes: list[list[float]]
    fields: list[list[float]] = field(default_factory=list)
    forces: dict[str, list[list[float]]] = field(default_factory=dict)
    error_shapes: list[list[float]] = field(default_factory=list)
    error_fields: list[list[float]] = field(default_factory=list)
    error_forces: dict[str, list[list[float]]] = field(default_factory=dict)


@dataclass(frozen=True)
class StrutRecord:
    """Critical loads [N] of `body` along the line between two of its markers, 0 where there is none.

    held: both markers are held in place; first, second: this one is clamped, the other free.
    """

    body: str
    markers: list[str]
    held: float = 0.0
    first: float = 0.0
    second: float = 0.0


# What a scene says of its events, as records.


@dataclass(frozen=True)
class EventRecord:
    """An event: rising, falling or either; terminal: does it end a run?; inputs that its action sets, in order.

    cool_down: for how long [s] it is not looked for once it has happened. mode: the hidden input of an element that
    begins to stick or to slide there, or of a stop that opens or closes; those of elements come last. row: of the
    element; side: of a stop, gap' = side v, 0 for friction; moves: is a start beyond the stop moved to it?
    """

    name: str
    direction: str
    terminal: bool = False
    sets: list[str] = field(default_factory=list)
    cool_down: float = 0.0
    mode: str = ""
    row: int = 0
    side: int = 0
    moves: bool = False


# A beam as the manifest names it; its shapes follow from the names.


@dataclass(frozen=True)
class ModeSetRecord:
    """Shapes of a beam by name (runtime.contract.flexible): their ends and number.

    axis: direction of the displacements, 0 = x (stretching), 1 = y, 2 = z; 3 = torsion about x.
    """

    axis: int
    ends: str
    modes: int


@dataclass(frozen=True)
class BeamRecord:
    """A beam with exact shapes: its mode sets in the order of its coordinates, and the loads that act on it.

    loads: names of loads and of joints with friction, in the order of their columns in `load_forces`. missing: share of
    the static bending energy of what its ends carry that the shapes miss, 0 if they carry it. stresses: names of the
    measures of its stress. section: area [m^2], section_modulus, section_modulus_z, torsion_modulus [m^3], shear_factor
    by the names of their parameters, where its stress is measured.
    """

    body: str
    sets: list[ModeSetRecord]
    loads: list[str] = field(default_factory=list)
    missing: float = 0.0
    stresses: list[str] = field(default_factory=list)
    section: dict[str, str] = field(default_factory=dict)


def beam_records(plain: Iterable[Mapping[str, Any]]) -> list[BeamRecord]:
    """The records from plain values. Raises KeyError or TypeError for anything else."""
    return [BeamRecord(**{**entry, "sets": [ModeSetRecord(**one) for one in entry["sets"]]}) for entry in plain]


# What pictures of a model are made of, as records.


@dataclass(frozen=True)
class PointRecord:
    """A column of `positions`: a marker of a body, or a station of a beam (name ""), with its modes; has it an H?"""

    body: str
    name: str
    modes: int
    stiffened: bool = False


@dataclass(frozen=True)
class ShapeRecord:
    """How a rigid body looks, in its axes: a box, cylinder, sphere or mesh at `position` [m] turned by `axes` (3 x 3).

    size [m]: three lengths; radius and length; radius. A mesh has vertices [m] and triangles, places of vertices.
    """

    body: str
    type: str
    position: list[float]
    axes: list[list[float]]
    size: list[float] = field(default_factory=list)
    vertices: list[list[float]] = field(default_factory=list)
    triangles: list[list[int]] = field(default_factory=list)


@dataclass(frozen=True)
class SurfaceRecord:
    """The surface of a flexible body as packed arrays (runtime.contract.records), float32 and int32.

    vertices (n, 3) [m] in its axes, triangles (m, 3), shapes (n, 3, nf) per unit of q_f; stresses (n, 6, nf) [Pa] per
    unit of q_f in the order xx yy zz yz xz xy, "" if not known.
    """

    body: str
    vertices: str
    triangles: str
    shapes: str
    stresses: str = ""

    def arrays(self) -> dict[str, np.ndarray]:
        """vertices, triangles, shapes, and stresses if they are known. Raises ValueError if they do not fit."""
        vertices = unpacked(self.vertices).reshape(-1, 3)
        found: dict[str, np.ndarray] = {"vertices": vertices}
        found["triangles"] = unpacked(self.triangles, "<i4").reshape(-1, 3)
        found["shapes"] = unpacked(self.shapes).reshape(len(vertices), 3, -1)
        return found | ({"stresses": unpacked(self.stresses).reshape(len(vertices), 6, -1)} if self.stresses else {})


@dataclass(frozen=True)
class Drawing:
    """What the columns of `poses` (bodies), of `geometry` (points) and of its sections (beams) belong to; looks."""

    space: str
    poses: list[str]
    points: list[PointRecord]
    sections: list[str]
    shapes: list[ShapeRecord] = field(default_factory=list)
    surfaces: list[SurfaceRecord] = field(default_factory=list)


# What a model is made of, as records: the generator writes them into the manifest, the runtime reads them there.
#
# Nothing reads physics out of the spelling of a name: what a coordinate measures or what sign a parameter must have is
# said here. Files of the two halves exchange these records only, as JSON (`as_plain`, `description`).

CoordinateKind = Literal["position", "angle", "euler_parameter", "modal", "state"]
ConstraintKind = Literal["distance", "angle", "direction", "quaternion", "norm"]
ParameterKind = Literal["declared", "scene", "data", "input"]
Bound = Literal["any", "positive", "not negative"]
# A ladder: what a function takes is known at its stage. Stage -> the arguments that are known from there on.
STAGES: dict[str, tuple[str, ...]] = {
    "constants": ("p",),
    "closure": ("c", "t", "u", "side", "chart", "q_i", "q_d"),
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
    hidden: is it one that a run sets by itself, a mode?
    """

    name: str
    unit: str
    meaning: str
    default: float
    rates: bool = False
    filter: float = 0.0
    hidden: bool = False


@dataclass(frozen=True)
class BoundedQuantity:
    """An expression of parameters whose value must have a sign; entry of the output of the function `bounded`."""

    item: str
    expression: str
    bound: Bound


@dataclass(frozen=True)
class Group:
    """A group of the partition (Eqs. 39, 72); groups run from slow to fast.

    Attributes
    ----------
    name : str
        Its name.
    positions : list of int
        Positions of its coordinates in q_i.
    """

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


JointDrawing = Literal["pivot", "slide", "rod", "weld", "drive", "coupling"]


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
    """A load: its type and the markers that it acts at by their role (marker, marker_a, marker_b, reaction).

    along: of a load along a beam where it begins and ends, in fractions of the length, and its power of the place; -1
    for a force at one place that moves.
    """

    name: str
    type: str
    markers: dict[str, str]
    along: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Measure:
    """A scalar of the motion and its SI unit; the rate of a measure is a measure of its own.

    about: what it is, where its name does not tell: axes in which a vector is resolved, an expression.
    accelerated: does it follow from accelerations and joint forces, so that motions cannot use it? These stand behind
    the others.
    """

    name: str
    unit: str
    about: str = ""
    accelerated: bool = False


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
    beams: all of them; flexible: other bodies with modes in space that loads act on; gauges: where
    stresses are known; struts: between which markers bodies buckle;
    switching: the load, joint or state of each output of the function `switching`; events: those of `events`; kinks:
    the load, joint or state of each output of `events` behind those of the events; held: positions in kinks of those
    whose side steps may hold, in the order of the argument `side`.
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
    kinks: list[str] = field(default_factory=list)
    held: list[int] = field(default_factory=list)
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
_MAY_LACK = ("inputs", "beams", "flexible", "switching", "kinks", "held", "events", "orientations", "gauges", "struts")


def as_plain(description: Description) -> dict[str, Any]:
    """The description as plain values for JSON; a model without shapes, inputs, beams, ... has no entry for them.

    Nor has a joint that is drawn as a pivot, a load at markers, a beam whose stress is not measured, an input or event
    of the scene.
    """
    plain = asdict(description)
    for looks in ("shapes", "surfaces"):
        if not plain["drawing"][looks]:
            del plain["drawing"][looks]
    for beam in plain["beams"]:
        if not beam["stresses"]:
            del beam["stresses"]
    for measure in plain["measures"]:
        for key in ("about", "accelerated"):
            if not measure[key]:
                del measure[key]
    for load in plain["loads"]:
        if not load["along"]:
            del load["along"]
    for joint in plain["joints"]:
        if joint["drawing"] == "pivot":
            del joint["drawing"]
    for table, keys in (("inputs", ("hidden",)), ("events", ("mode", "row", "side", "moves"))):
        for entry in plain[table]:
            for key in keys:
                if not entry[key]:
                    del entry[key]
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
