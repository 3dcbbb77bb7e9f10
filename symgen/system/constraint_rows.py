"""Constraint rows of joints between two markers, and those of joints that place a body (Eqs. 21-27)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import casadi as ca
import sympy as sp

from symgen.algebra.rows import Row, add_scaled, add_to, nonzero
from symgen.algebra.scalar import ONE, ZERO, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, cross, minus, quaternion_product, scaled, zeros
from symgen.bodies.beam_places import MovingPlace
from symgen.bodies.planar_body import MarkerMotion
from symgen.bodies.spatial_body import SpatialBody, SpatialMarker, fixed_quaternion, minus_rows, turn_about
from symgen.joints import JOINTS
from symgen.joints.joint import Joint, Slide, Turn
from symgen.system import joint_templates as s
from symgen.system.constraint import ConstraintRow, Motion
from symgen.system.joint_templates import (
    JointCoordinates,
    JointTemplate,
    Travel,
    in_world,
    placing_template,
    planar_template,
    spatial_template,
)

ON_B = tuple(f"{part}_{axis}" for part in ("r_b", "turn_b") for axis in "xyz")


@dataclass(frozen=True)
class _Slot:
    """One quantity of a marker that a template differentiates by: its rows over q and its bias acceleration."""

    name: str
    row: Row
    bias: ca.SX


def planar_rows(joint: Joint, a: MarkerMotion, b: MarkerMotion, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
    """Rows of a joint between markers of planar bodies; motions: of its quantities, by field."""
    slots = [
        _Slot("r_a_x", a.r_columns[0], a.bias[0]),
        _Slot("r_a_y", a.r_columns[1], a.bias[1]),
        _Slot("r_b_x", b.r_columns[0], b.bias[0]),
        _Slot("r_b_y", b.r_columns[1], b.bias[1]),
        _Slot("phi_a", a.phi_row, ZERO),
        _Slot("phi_b", b.phi_row, ZERO),
    ]
    values = {
        **dict(zip(s.r_a, a.r, strict=True)),
        **dict(zip(s.r_b, b.r, strict=True)),
        **dict(zip(s.r_a_dot, a.r_dot, strict=True)),
        **dict(zip(s.r_b_dot, b.r_dot, strict=True)),
        **dict(zip(s.t_a, a.direction, strict=True)),
        s.phi_a: a.phi,
        s.phi_b: b.phi,
        s.phi_a_dot: a.phi_dot,
        s.phi_b_dot: b.phi_dot,
    }
    template = planar_template(type(joint))
    return _template_rows(joint.name, template, values, motions, slots, ("r_b_x", "r_b_y", "phi_b"))


def spatial_rows(
    joint: Joint, a: SpatialMarker, b: SpatialMarker, motions: Mapping[str, Motion]
) -> list[ConstraintRow]:
    """Rows of a joint as equations between markers of spatial bodies; motions: of its quantities, by field."""
    return _spatial(joint.name, spatial_template(type(joint)), a, b, motions, Travel())


def placing_rows(
    joint: Joint,
    own: JointCoordinates,
    markers: tuple[SpatialMarker, SpatialMarker],
    child: SpatialBody,
    parent: SpatialBody,
    forward: bool,
) -> list[ConstraintRow]:
    """Rows that place the body `child`: its position linear in R_o, its Euler parameters in closed form.

    own: the joint's coordinates; markers: a, b; forward: the child is the body of marker b.
    """
    a, b = markers
    rows = _orientation(joint.name, own, a, b, child, parent, forward)
    rows += _spatial(joint.name, placing_template(), a, b, {}, own.travel())
    slides, turns = own.free_axes(a, b)
    return [_without_own_axes(row, slides, turns) for row in rows]


def coordinate_row(name: str, label: str, own: JointCoordinates, motion: Motion, a: SpatialMarker) -> ConstraintRow:
    """A prescribed motion of the coordinate `label` of a joint, about or along an axis of marker a; name: whose row."""
    k = own.place(label)
    found, rotation = own.coordinates[k], isinstance(own.motions[k], Turn)
    axis = in_world(a, own.subspace[k][0 if rotation else 1])
    return ConstraintRow(
        f"{name}.{label}",
        name,
        "angle" if rotation else "distance",
        found.value - motion[0],
        {found.column: ONE},
        neg(motion[1]),
        motion[2],
        (*zeros(), *axis) if rotation else (*axis, *zeros()),
        f"{label} - f(t)",
    )


def holding(joint: Joint, motion: Turn | Slide) -> Joint:
    """The prescribed motion that would hold a motion of a joint where it is zero."""
    record = JOINTS["prescribed_angle" if isinstance(motion, Turn) else "prescribed_displacement"]
    return record.model_validate({**joint.markers, "name": joint.name, "motion": 0.0})


@dataclass(frozen=True)
class LocalPlace:
    """A coordinate of point b in a beam's frame: value, rate, row over q, what rows leave of the acceleration.

    on_b: its change by a displacement and a turn of marker b.
    """

    value: ca.SX
    rate: ca.SX
    row: Row
    bias: ca.SX
    on_b: tuple[ca.SX, ...]


def sliding_rows(
    name: str,
    local: Sequence[LocalPlace],
    place: MovingPlace,
    columns: Sequence[int],
    q_f: Sequence[ca.SX],
    q_f_dot: Sequence[ca.SX],
) -> list[ConstraintRow]:
    """y - phi(x) q_f = 0 of a point on a bent beam, in space z, too; local: its x, y and z in the beam's frame.

    With k = phi' q_f: y'' - k x'' - phi q_f'' = 2 phi' q_f' x' + phi'' q_f x'^2.
    """
    x, length, rows = local[0], place.length, []
    for axis, across in enumerate(local[1:], start=1):
        own = [one for one in place.sets if one[0] == axis]
        deflection = slope = rotation = bending = ZERO
        C_q = dict(across.row)
        for _, first, values, rates, seconds in own:
            part = slice(first, first + len(values))
            q, v = q_f[part], q_f_dot[part]
            deflection = deflection + dot(values, q)
            slope, rotation = slope + dot(rates, q) / length, rotation + dot(rates, v) / length
            bending = bending + dot(seconds, q) / length**2
            for value, column in zip(values, columns[part], strict=True):
                add_to(C_q, column, neg(value))
        add_scaled(C_q, neg(slope), x.row)
        gamma = 2 * rotation * x.rate + bending * x.rate**2 + slope * x.bias - across.bias
        on_b = tuple(one - slope * along for one, along in zip(across.on_b, x.on_b, strict=True))
        label, text = f"{name}.{'xyz'[axis]}", f"{'xyz'[axis]}_b - phi(x_b) q_f"
        rows.append(
            ConstraintRow(label, name, "distance", across.value - deflection, nonzero(C_q), ZERO, gamma, on_b, text)
        )
    return rows


def unit_length(body: SpatialBody) -> ConstraintRow:
    """(e.e - 1) / 2 = 0 for a body whose Euler parameters no joint gives."""
    q = body.coordinates
    row = dict(zip(q.orientation_columns, q.theta, strict=True))
    gamma = neg(dot(q.theta_dot, q.theta_dot))
    return ConstraintRow(
        f"{body.name}.norm", "", "norm", (dot(q.theta, q.theta) - 1) / 2, row, ZERO, gamma, tuple(zeros(6))
    )


def _without_own_axes(row: ConstraintRow, slides: list[Vector], turns: list[Vector]) -> ConstraintRow:
    """What acts along a joint's own coordinates are the loads on them, not the joint. (A screw's axis carries both.)"""
    force, moment = list(row.on_b[:3]), list(row.on_b[3:])
    for axis in slides:
        force = minus(force, scaled(dot(force, axis), axis))
    for axis in turns:
        moment = minus(moment, scaled(dot(moment, axis), axis))
    return replace(row, on_b=(*force, *moment))


def _orientation(
    name: str,
    own: JointCoordinates,
    a: SpatialMarker,
    b: SpatialMarker,
    child: SpatialBody,
    parent: SpatialBody,
    forward: bool,
) -> list[ConstraintRow]:
    """e_child - e_parent K = 0 with K = (marker of the parent) (turns) (marker of the child)^-1."""
    turned = fixed_quaternion([ONE, ZERO, ZERO, ZERO])
    for motion, found in zip(own.motions, own.coordinates, strict=True):
        if isinstance(motion, Turn):
            turned = turned.times(turn_about(motion.axis, found.value, found.rate, found.column))
    near, far = (a, b) if forward else (b, a)
    between = near.local_quaternion.times(turned if forward else turned.conjugate()).times(
        far.local_quaternion.conjugate()
    )
    base, e = parent.quaternion(), child.quaternion()
    given = base.times(between)
    C = minus(e.value, given.value)
    rows = []
    for k in range(4):
        acting = [_turned_by(axis, e.value)[k] for axis in range(3)]
        signed = acting if forward else [neg(value) for value in acting]
        C_q = minus_rows(e.rows[k], given.rows[k])
        rows.append(
            ConstraintRow(
                f"{name}.e{k}", name, "quaternion", C[k], C_q, ZERO, given.bias[k], (*zeros(), *signed)
            )
        )  # fmt: skip
    return rows


def _turned_by(axis: int, value: Vector) -> Vector:
    """Change of a quaternion by a virtual rotation about a world axis: (0, pi) e / 2."""
    unit = zeros(4)
    unit[1 + axis] = ca.SX(0.5)
    return quaternion_product(unit, value)


def _spatial(
    name: str,
    template: JointTemplate,
    a: SpatialMarker,
    b: SpatialMarker,
    motions: Mapping[str, Motion],
    travel: Travel,
) -> list[ConstraintRow]:
    slots = [
        _Slot(f"{point}_{axis}", marker.r_columns[i], marker.bias[i])
        for point, marker in (("r_a", a), ("r_b", b))
        for i, axis in enumerate("xyz")
    ]
    slots += [
        _Slot(f"{turn}_{axis}", marker.turn_rows[i], marker.turn_bias[i])
        for turn, marker in (("turn_a", a), ("turn_b", b))
        for i, axis in enumerate("xyz")
    ]
    slots += [_Slot(f"travel_{axis}", travel.rows[i], travel.bias[i]) for i, axis in enumerate("xyz")]
    given = {"r_a": a.r, "r_b": b.r, "r_a_dot": a.r_dot, "r_b_dot": b.r_dot, "omega_a": a.omega, "omega_b": b.omega,
             "travel": travel.value, "travel_dot": travel.rate}  # fmt: skip
    pairs = [(s.VECTORS[key], vector) for key, vector in given.items()]
    for label, marker in (("a", a), ("b", b)):
        for axis, vector in zip("xyz", marker.axes, strict=True):
            key = f"{axis}_{label}"
            pairs += [
                (s.AXES_OF[key], vector),
                (s.AXIS_RATES[key], cross(marker.omega, vector)),
            ]
    values: dict[sp.Symbol, ca.SX] = {}
    for symbols, vector in pairs:
        values |= dict(zip(symbols, vector, strict=True))
    return _template_rows(name, template, values, motions, slots, ON_B)


def _template_rows(
    name: str,
    template: JointTemplate,
    values: Mapping[sp.Symbol, ca.SX],
    motions: Mapping[str, Motion],
    slots: Sequence[_Slot],
    on_b: Sequence[str],
) -> list[ConstraintRow]:
    """Rows of the joint `name`: C (21), C_q and C_t (24), gamma of (25) and (27); nu = -C_t is (26).

    on_b names the slots that displace and turn marker b.
    """
    given = dict(values)
    for field, symbols in template.fields.items():
        given |= dict(zip(symbols, motions[field], strict=True))
    output = template.template.evaluate(given)
    rows = []
    for k, equation in enumerate(template.rows):
        C_q: Row = {}
        gamma = neg(output[f"drift_{k}"])
        for slot in slots:
            factor = output[f"C_{k}_{slot.name}"]
            add_scaled(C_q, factor, slot.row)
            gamma = sub(gamma, mul(factor, slot.bias))
        acting = tuple(output[f"C_{k}_{slot}"] for slot in on_b)
        C, C_t = output[f"C_{k}"], output[f"C_t_{k}"]
        label = f"{name}.{equation.label}"
        rows.append(ConstraintRow(label, name, equation.kind, C, nonzero(C_q), C_t, gamma, acting, equation.text))
    return rows
