"""Constraint rows between two markers of spatial bodies, and those of joints that place a body (Eqs. 21-27)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, dot, mul, neg
from symgen.algebra.vectors import Vector, cross, minus, quaternion_product, scaled, zeros
from symgen.bodies.quaternion_motion import fixed_quaternion, minus_rows, turn_about
from symgen.bodies.spatial_body import SpatialBody, SpatialMarker
from symgen.joints import (
    cylindrical,
    distance,
    place,
    planar,
    point_on_line,
    prescribed_angle,
    prescribed_displacement,
    prismatic,
    revolute,
    spherical,
    universal,
    weld,
)
from symgen.joints import spatial_template as s
from symgen.joints.instance import ConstraintRow, Slot, template_rows
from symgen.joints.joint_type import JointType, f, f_t, f_tt

TYPES: dict[str, Callable[[], JointType]] = {
    "revolute": revolute.spatial,
    "prismatic": prismatic.spatial,
    "weld": weld.spatial,
    "spherical": spherical.spatial,
    "universal": universal.spatial,
    "cylindrical": cylindrical.spatial,
    "planar": planar.spatial,
    "point_on_line": point_on_line.spatial,
    "distance": distance.spatial,
    "prescribed_angle": prescribed_angle.spatial,
    "prescribed_displacement": prescribed_displacement.spatial,
    "place": place.spatial,
}
ON_B = tuple(f"{part}_{axis}" for part in ("r_b", "turn_b") for axis in "xyz")
TURNS: dict[str, tuple[tuple[int, str], ...]] = {  # (axis, coordinate) of the rotations of a placing joint, in order
    "revolute": ((2, "angle"),),
    "cylindrical": ((2, "angle"),),
    "screw": ((2, "angle"),),
    "planar": ((2, "angle"),),
    "universal": ((2, "angle1"), (0, "angle2")),
    "prismatic": (),
    "weld": (),
}
TRAVELS: dict[str, dict[int, str]] = {
    "prismatic": {2: "travel"},
    "cylindrical": {2: "travel"},
    "planar": {0: "x", 1: "y"},
}


@dataclass(frozen=True)
class JointCoordinate:
    """A coordinate of a joint: value, rate and column in q."""

    value: ca.SX
    rate: ca.SX
    column: int


@dataclass(frozen=True)
class Travel:
    """How far a joint has moved along the axes of marker a: values, rates, and rows over q."""

    value: Vector = field(default_factory=zeros)
    rate: Vector = field(default_factory=zeros)
    rows: list[Row] = field(default_factory=lambda: [{}, {}, {}])


def spatial_rows(name: str, kind: str, a: SpatialMarker, b: SpatialMarker, motion: list[ca.SX]) -> list[ConstraintRow]:
    """Rows of a joint as equations between its markers; motion = [f, f', f''] of t."""
    return _rows(name, kind, a, b, motion, Travel())


def placing_rows(
    name: str,
    kind: str,
    a: SpatialMarker,
    b: SpatialMarker,
    coordinates: Mapping[str, JointCoordinate],
    child: SpatialBody,
    parent: SpatialBody,
    forward: bool,
    lead: ca.SX,
) -> list[ConstraintRow]:
    """Rows that place the body `child`: its position linear in R_o, its Euler parameters in closed form.

    forward: the child is the body of marker b. lead: travel of a turn of a screw, over 2 pi.
    """
    travel = Travel()
    slides = dict(TRAVELS.get(kind, {}))
    for axis, key in slides.items():
        found = coordinates[key]
        travel.value[axis], travel.rate[axis], travel.rows[axis][found.column] = found.value, found.rate, ONE
    if kind == "screw":
        angle = coordinates["angle"]
        travel.value[2], travel.rate[2] = mul(lead, angle.value), mul(lead, angle.rate)
        travel.rows[2][angle.column] = lead
    turns = [(axis, coordinates[key]) for axis, key in TURNS[kind]]
    free_turns = [(a if axis == 2 else b).axes[axis] for axis, _ in TURNS[kind] if kind != "screw"]
    rows = _orientation(name, a, b, turns, child, parent, forward)
    rows += _rows(name, "place", a, b, [ZERO] * 3, travel)
    return [_without_own_axes(row, [a.axes[axis] for axis in slides], free_turns) for row in rows]


def _without_own_axes(row: ConstraintRow, slides: list[Vector], turns: list[Vector]) -> ConstraintRow:
    """What acts along a joint's own coordinates are the loads on them, not the joint. (A screw's axis carries both.)"""
    force, moment = list(row.on_b[:3]), list(row.on_b[3:])
    for axis in slides:
        force = minus(force, scaled(dot(force, axis), axis))
    for axis in turns:
        moment = minus(moment, scaled(dot(moment, axis), axis))
    return replace(row, on_b=(*force, *moment))


def coordinate_row(
    name: str, label: str, found: JointCoordinate, motion: list[ca.SX], a: SpatialMarker
) -> ConstraintRow:
    """A prescribed motion of a joint's own coordinate about (angle) or along (travel) marker a's z-axis."""
    acting = (*zeros(), *a.axes[2]) if label == "angle" else (*a.axes[2], *zeros())
    return ConstraintRow(
        f"{name}.{label}",
        name,
        found.value - motion[0],
        {found.column: ONE},
        neg(motion[1]),
        motion[2],
        tuple(acting),
        label,
    )


def unit_length(body: SpatialBody) -> ConstraintRow:
    """(e.e - 1) / 2 = 0 for a body whose Euler parameters no joint gives."""
    q = body.coordinates
    row = dict(zip(q.turning, q.theta, strict=True))
    return ConstraintRow(
        f"{body.name}.norm",
        "",
        (dot(q.theta, q.theta) - 1) / 2,
        row,
        ZERO,
        neg(dot(q.theta_dot, q.theta_dot)),
        tuple(zeros(6)),
        "norm",
    )


def _orientation(
    name: str,
    a: SpatialMarker,
    b: SpatialMarker,
    turns: list[tuple[int, JointCoordinate]],
    child: SpatialBody,
    parent: SpatialBody,
    forward: bool,
) -> list[ConstraintRow]:
    """e_child - e_parent K = 0 with K = (marker of the parent) (turns) (marker of the child)^-1."""
    turned = fixed_quaternion([ONE, ZERO, ZERO, ZERO])
    for axis, found in turns:
        turned = turned.times(turn_about(axis, found.value, found.rate, found.column))
    near, far = (a, b) if forward else (b, a)
    between = near.local_quaternion.times(turned if forward else turned.conjugate()).times(
        far.local_quaternion.conjugate()
    )
    base, own = parent.quaternion(), child.quaternion()
    given = base.times(between)
    C = minus(own.value, given.value)
    rows = []
    for k in range(4):
        acting = [_turned_by(axis, own.value)[k] for axis in range(3)]
        signed = acting if forward else [neg(value) for value in acting]
        rows.append(
            ConstraintRow(
                f"{name}.e{k}",
                name,
                C[k],
                minus_rows(own.rows[k], given.rows[k]),
                ZERO,
                given.bias[k],
                (*zeros(), *signed),
                f"e{k}",
            )
        )
    return rows


def _turned_by(axis: int, value: Vector) -> Vector:
    """Change of a quaternion by a virtual rotation about a world axis: (0, pi) e / 2."""
    unit = zeros(4)
    unit[1 + axis] = ca.SX(0.5)
    return quaternion_product(unit, value)


def _rows(
    name: str, kind: str, a: SpatialMarker, b: SpatialMarker, motion: list[ca.SX], travel: Travel
) -> list[ConstraintRow]:
    slots = [
        Slot(f"{point}_{axis}", marker.r_columns[i], marker.bias[i])
        for point, marker in (("r_a", a), ("r_b", b))
        for i, axis in enumerate("xyz")
    ]
    slots += [
        Slot(f"{turn}_{axis}", marker.turn_rows[i], marker.turn_bias[i])
        for turn, marker in (("turn_a", a), ("turn_b", b))
        for i, axis in enumerate("xyz")
    ]
    slots += [Slot(f"travel_{axis}", travel.rows[i], ZERO) for i, axis in enumerate("xyz")]
    values = dict(zip((f, f_t, f_tt), motion, strict=True))
    pairs = [
        (s.r_a, a.r),
        (s.r_b, b.r),
        (s.r_a_dot, a.r_dot),
        (s.r_b_dot, b.r_dot),
        (s.omega_a, a.omega),
        (s.omega_b, b.omega),
        (s.travel, travel.value),
        (s.travel_dot, travel.rate),
    ]
    for label, marker in (("a", a), ("b", b)):
        for axis, vector in zip("xyz", marker.axes, strict=True):
            key = f"{axis}_{label}"
            pairs += [(s.axes[key], vector), (s.axis_rates[key], cross(marker.omega, vector))]
    for symbols, vector in pairs:
        values |= dict(zip(symbols, vector, strict=True))
    return template_rows(name, TYPES[kind](), values, slots, ON_B)
