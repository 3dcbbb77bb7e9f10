"""The records that the runtime gets of a derived model.

manifest.json (what the model is: its records, hashes) and data.json (its numbers).
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from runtime.contract import loading as contract
from runtime.contract.orientations import OrientationRecord, angle_names
from runtime.contract.records import (
    BeamRecord,
    BodyRecord,
    Description,
    Drawing,
    EventRecord,
    FunctionSpec,
    GaugeRecord,
    JointDrawing,
    JointRecord,
    LoadedBody,
    LoadRecord,
    Measure,
    PointRecord,
    ShapeRecord,
    StrutRecord,
    SurfaceRecord,
)
from symgen.pipeline import Derived
from symgen.scene import BeamBody, GroundBody, RigidBody
from symgen.scene.appearance import BoxShape, CylinderShape, MeshShape, SphereShape
from symgen.scene.flexible import SpatialModalBody

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


def describe(derived: Derived, functions: Sequence[FunctionSpec] | None = None) -> Description:
    """Coordinates, rows, parts, parameters and functions of a derived model (these, where they are given)."""
    eq, choice, scene = derived.system.equations, derived.system.choice, derived.scene
    reduced = derived.system.reduced
    missing: dict[str, float] = {}
    for one in eq.static_residuals:
        missing[one.body] = max(missing.get(one.body, 0.0), float(f"{one.share:.3g}"))
    return Description(
        name=scene.name,
        title=scene.title or scene.name,
        coordinates=eq.coordinates,
        q_i=[reduced.names[c] for c in choice.independent],
        q_d=[reduced.names[c] for c in derived.dependent],
        loop_unknowns=[reduced.names[c] for c in choice.loop_columns],
        groups=derived.groups,
        constraints=[row.record for row in eq.constraints],
        redundant=[eq.constraints[row].label for row in derived.redundant],
        bodies=_bodies(derived),
        joints=_joints(scene),
        loads=[LoadRecord(load.name, *load.record(scene), eq.load_spans[load.name]) for load in scene.loads],
        measures=_measures(scene, eq.measure_units, eq.measures)
        + [replace(one, accelerated=True) for one in _measures(scene, eq.measure_units, eq.accelerated)],
        drawing=_drawing(derived),
        gravity=_gravity(derived),
        parameters=derived.parameters,
        bounded=derived.bounded,
        functions=list(derived.functions.values() if functions is None else functions),
        inputs=eq.inputs,
        events=[
            EventRecord(name, event.direction, event.terminal, list(event.action), event.cool_down)
            for name, event in scene.events.items()
        ]
        + [part.record(row) for row, one in enumerate(eq.elements) for part in one.parts],
        switching=[item for item, _ in eq.switching],
        kinks=[item for item, _ in eq.kinks.values()],
        held=[[*eq.kinks].index(name) for name in eq.sides],
        flexible=[LoadedBody(body, loads) for body in eq.flexible if (loads := eq.loads_on(body))],
        simulation=scene.simulation.model_dump(mode="json", exclude_none=True),
        orientations=[
            OrientationRecord(
                rotation.body,
                [reduced.names[c] for c in rotation.columns],
                [eq.names[c] for c in rotation.parameters],
            )
            for rotation in reduced.rotation_vectors
        ],
        gauges=[
            GaugeRecord(body.name, name, **gauge.model_dump(mode="json"))
            for body in scene.moving_bodies
            if isinstance(body, SpatialModalBody)
            for name, gauge in body.gauges.items()
        ],
        struts=[
            StrutRecord(body.name, **strut.model_dump(mode="json", exclude_none=True))
            for body in scene.moving_bodies
            if isinstance(body, SpatialModalBody)
            for strut in body.struts
        ],
        beams=[
            BeamRecord(body, sets, eq.loads_on(body), missing.get(body, 0.0), *_stresses(scene, body))
            for body, sets in eq.beams.items()
        ],
    )


def _measures(scene: SceneRecord, units: Mapping[str, str], names: Iterable[str]) -> list[Measure]:
    """Measures with their units, and with what pages say of them."""
    notes = {one.name: one.note for one in scene.measures if one.note}
    notes |= {f"{name}_dot": f"rate of {note}" for name, note in notes.items()}
    return [Measure(name, units[name], notes.get(name, "")) for name in names]


SECTION = ("area", "section_modulus", "section_modulus_z", "torsion_modulus", "shear_factor")


def _stresses(scene: SceneRecord, body: str) -> tuple[list[str], dict[str, str]]:
    """Names of the measures of the stress of a beam, and the names of the parameters that its section has."""
    measures = [one.name for one in scene.measures if one.type == "stress" and one.of.partition(".")[0] == body]
    beam = scene.body(body)
    if not measures or not isinstance(beam, BeamBody):
        return measures, {}
    given = {key: getattr(beam, key) for key in SECTION}
    names = {key: value if isinstance(value, str) else f"{body}.{key}" for key, value in given.items()}
    return measures, {key: name for key, name in names.items() if given[key] is not None}


def _bodies(derived: Derived) -> list[BodyRecord]:
    scene, found = derived.scene, []
    if scene.structure is not None:
        return []
    by_angles = scene.euler_angles()
    for body in (scene.ground, *scene.moving_bodies):
        markers = sorted({**body.implicit_markers(), **body.markers})
        orientation = "" if scene.space == "planar" else str(getattr(body, "orientation", ""))
        angles = angle_names(body.name) if body.name in by_angles else []
        found.append(BodyRecord(body.name, body.type, markers, orientation, angles))
    return found


def _joints(scene: SceneRecord) -> list[JointRecord]:
    own = {placement.joint: placement.coordinates for placement in scene.placements()}

    def record(name: str, type: str, a: str, b: str, drawing: JointDrawing) -> JointRecord:
        bodies = scene.marker(a)[0].name, scene.marker(b)[0].name
        return JointRecord(name, type, a, b, *bodies, own.get(name, []), drawing)

    found = [record(one.name, one.type, one.marker_a, one.marker_b, one.drawing) for one in scene.joints]
    for coupling in scene.couplings:  # from the last wheel to the first, which follows
        first, last = (scene.joint_of(coupling.named[k])[0].marker_b for k in (0, -1))
        found.append(record(coupling.name, coupling.type, last, first, "coupling"))
    return found


def _drawing(derived: Derived) -> Drawing:
    picture = derived.system.equations.picture
    points = [PointRecord(point.body, point.name, len(point.shapes), bool(point.H)) for point in picture.points]
    shapes = [
        _shape(body.name, shape)
        for body in (derived.scene.ground, *derived.scene.moving_bodies)
        if isinstance(body, GroundBody | RigidBody)
        for shape in body.shape
    ]
    surfaces = [
        SurfaceRecord(body.name, **body.surface.model_dump())
        for body in derived.scene.moving_bodies
        if isinstance(body, SpatialModalBody) and body.surface is not None
    ]
    return Drawing(derived.scene.space, list(picture.poses), points, list(picture.sections), shapes, surfaces)


def _shape(body: str, shape: BoxShape | CylinderShape | SphereShape | MeshShape) -> ShapeRecord:
    record = ShapeRecord(body, shape.type, list(shape.position), shape.axes().tolist())
    match shape:
        case BoxShape():
            return replace(record, size=list(shape.size))
        case CylinderShape():
            return replace(record, size=[shape.radius, shape.length])
        case SphereShape():
            return replace(record, size=[shape.radius])
        case MeshShape():
            return replace(record, vertices=[*map(list, shape.vertices)], triangles=[*map(list, shape.triangles)])


def _gravity(derived: Derived) -> list[float]:
    """Components at default parameters."""
    gravity = derived.system.equations.gravity
    if not gravity:
        return []
    symbols = ca.symvar(ca.vertcat(*gravity))
    defaults = {entry.name: entry.default for entry in derived.parameters}
    evaluate = ca.Function("gravity", symbols, [ca.densify(ca.vertcat(*gravity))])
    (values,) = evaluate.call([ca.DM(defaults[symbol.name()]) for symbol in symbols])
    return [float(value) for value in np.asarray(values).ravel()]


def data_text(derived: Derived) -> str:
    """Default parameters, the consistent initial state, tables; floats by repr, one entry a line."""
    initial = derived.initial
    names = derived.system.equations.names
    data: dict[str, Any] = {
        "p": {entry.name: entry.default for entry in derived.parameters},
        "q": dict(zip(names, map(clean, initial.q), strict=True)),
        "q_dot": dict(zip(names, map(clean, initial.q_dot), strict=True)),
        "changed": {name: list(pair) for name, pair in initial.changed.items()},
    }
    if initial.reported:
        data["assembled"] = [text for _, text in initial.reported]
    text = json.dumps(data, indent=1)
    if derived.scene.tables:  # each on a line
        parts = derived.scene.curves().items()
        tables = (f"  {json.dumps(name)}: {json.dumps(table.plain())}" for name, table in parts)
        text = text[: -len("\n}")] + ',\n "tables": {\n' + ",\n".join(tables) + "\n }\n}"
    return text + "\n"


def clean(value: float) -> float:
    """Rounding dust of the assembly as an exact zero."""
    return 0.0 if abs(value) < 1e-15 else float(value)


def manifest_text(derived: Derived, files: Mapping[str, str]) -> str:
    """The manifest, with sha256 of every other file of the model."""
    scene = derived.scene
    more: dict[str, Any] = {"description": scene.description}
    if derived.left_out:
        more["left_out"] = derived.left_out
    versions = {package: version(package) for package in ("casadi", "sympy", "symgen")}
    return contract.manifest_text(describe(derived), files, versions, more)
