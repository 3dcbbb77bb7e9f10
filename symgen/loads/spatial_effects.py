"""Loads between markers of spatial bodies as generalised forces, with potential and powers (Q_F of Eq. 20)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ZERO, add, dot, mul, neg, total
from symgen.algebra.vectors import Vector, combination, cross, minus, scaled, zeros
from symgen.bodies.spatial_body import SpatialMarker
from symgen.loads import spring_template
from symgen.loads.effect import LinearSpring, LoadEffect


@dataclass(frozen=True)
class StateVector:
    """The symbols of all coordinates and rates: what potentials are differentiated by."""

    q: ca.SX
    q_dot: ca.SX


@dataclass(frozen=True)
class Angle:
    """An angle between two markers: value, rate, and its row over q."""

    value: ca.SX
    rate: ca.SX
    row: Row


def point_force(marker: SpatialMarker, components: Vector, frame: str) -> LoadEffect:
    """Force at a marker, in world components or turning with the marker."""
    force = combination(marker.axes, components) if frame == "body" else components
    row: Row = {}
    for i in range(3):
        add_scaled(row, force[i], marker.r_columns[i])
    return LoadEffect(row, applied=dot(force, marker.r_dot), action=[*force, ZERO, ZERO, ZERO])


def torque(marker: SpatialMarker, value: ca.SX, reaction: SpatialMarker | None) -> LoadEffect:
    """Torque about a marker's z-axis, with its reaction on another body if named."""
    row: Row = {}
    axis = marker.axes[2]
    rate = dot(axis, marker.omega)
    for i in range(3):
        add_scaled(row, mul(value, axis[i]), marker.turn_rows[i])
        if reaction is not None:
            add_scaled(row, neg(mul(value, axis[i])), reaction.turn_rows[i])
    if reaction is not None:
        rate = rate - dot(axis, reaction.omega)
    return LoadEffect(row, applied=value * rate, action=[ZERO, ZERO, ZERO, *scaled(value, axis)])


def effort(row: Row, rate: ca.SX, value: ca.SX, axis: Vector, turning: bool) -> LoadEffect:
    """Torque about or force along an axis on marker b, on a scalar of the motion with this row and rate."""
    acting = [*zeros(), *scaled(value, axis)] if turning else [*scaled(value, axis), *zeros()]
    force: Row = {}
    add_scaled(force, value, row)
    return LoadEffect(force, applied=value * rate, action=acting)


def relative_travel(a: SpatialMarker, b: SpatialMarker, axis: Vector) -> tuple[Row, ca.SX]:
    """Row and rate of the travel of b along an axis of marker a, where b is on that axis."""
    row: Row = {}
    for i in range(3):
        add_scaled(row, axis[i], b.r_columns[i])
        add_scaled(row, neg(axis[i]), a.r_columns[i])
    return row, dot(axis, minus(b.r_dot, a.r_dot))


def relative_turn(a: SpatialMarker, b: SpatialMarker, axis: Vector) -> tuple[Row, ca.SX]:
    """Row and rate of the turn of b about an axis of marker a."""
    row: Row = {}
    for i in range(3):
        add_scaled(row, axis[i], b.turn_rows[i])
        add_scaled(row, neg(axis[i]), a.turn_rows[i])
    return row, dot(axis, minus(b.omega, a.omega))


def spring_damper(
    a: SpatialMarker, b: SpatialMarker, stiffness: ca.SX, damping: ca.SX, free_length: ca.SX
) -> LoadEffect:
    """Translational spring-damper between the points a and b."""
    out = spring_template.evaluate(minus(b.r, a.r), minus(b.r_dot, a.r_dot), stiffness, damping, free_length)
    row: Row = {}
    for i in range(3):
        add_scaled(row, out.force[i], b.r_columns[i])
        add_scaled(row, -out.force[i], a.r_columns[i])
    return LoadEffect(row, potential=out.potential, dissipated=out.dissipated, action=[*out.force, ZERO, ZERO, ZERO])


def turning_spring_damper(
    angle: Angle, stiffness: ca.SX, damping: ca.SX, free_angle: ca.SX, axis: Sequence[ca.SX] = ()
) -> LoadEffect:
    """Spring-damper on an angle about an axis; with zero stiffness it is a joint's viscous friction."""
    turn = angle.value - free_angle
    moment = -stiffness * turn - damping * angle.rate
    row: Row = {}
    add_scaled(row, moment, angle.row)
    spring = LinearSpring(angle.row, stiffness, damping)
    return LoadEffect(
        row,
        potential=stiffness * turn**2 / 2,
        dissipated=damping * angle.rate**2,
        spring=spring,
        action=[ZERO, ZERO, ZERO, *scaled(moment, axis)],
    )


def angle_about_z(a: SpatialMarker, b: SpatialMarker, motion: StateVector) -> Angle:
    """Angle of b's x-axis in the xy-plane of marker a, between -pi and pi."""
    value = ca.atan2(dot(b.axes[0], a.axes[1]), dot(b.axes[0], a.axes[0]))
    return Angle(value, ca.jtimes(value, motion.q, motion.q_dot), gradient(value, motion.q))


def hinge_friction(a: SpatialMarker, b: SpatialMarker, damping: ca.SX, axis: Vector) -> LoadEffect:
    """Viscous friction of the relative rotation about an axis."""
    rate = dot(axis, minus(b.omega, a.omega))
    row: Row = {}
    for i in range(3):
        moment = neg(mul(mul(damping, rate), axis[i]))
        add_scaled(row, moment, b.turn_rows[i])
        add_scaled(row, neg(moment), a.turn_rows[i])
    return LoadEffect(row, dissipated=damping * rate**2)


def slide_friction(a: SpatialMarker, b: SpatialMarker, damping: ca.SX, axis: Vector, motion: StateVector) -> LoadEffect:
    """Viscous friction of the travel of b along an axis."""
    travel = dot(axis, minus(b.r, a.r))
    rate = ca.jtimes(travel, motion.q, motion.q_dot)
    row: Row = {}
    add_scaled(row, -damping * rate, gradient(travel, motion.q))
    return LoadEffect(row, dissipated=damping * rate**2)


def bushing(
    a: SpatialMarker, b: SpatialMarker, stiffness: Sequence[Vector], damping: Sequence[Vector], motion: StateVector
) -> LoadEffect:
    """Springs and dampers along and about marker a's axes: (translation, rotation) constants, three each.

    The rotation is the axial vector of the relative rotation matrix, sin(angle) times its axis; force and moment are
    the gradient of the stored energy, so nothing is gained or lost at large rotations.
    """
    travel = [dot(axis, minus(b.r, a.r)) for axis in a.axes]
    cosines = [[dot(mine, other) for other in b.axes] for mine in a.axes]
    turn = [(cosines[k][j] - cosines[j][k]) / 2 for j, k in ((1, 2), (2, 0), (0, 1))]
    values = [*travel, *turn]
    rates = [ca.jtimes(value, motion.q, motion.q_dot) for value in values]
    potential = total(k * value**2 / 2 for k, value in zip([*stiffness[0], *stiffness[1]], values, strict=True))
    dissipated = total(c * rate**2 for c, rate in zip([*damping[0], *damping[1]], rates, strict=True))
    row: Row = {}
    add_scaled(row, ca.SX(-1), gradient(potential, motion.q))
    add_scaled(row, ca.SX(-0.5), gradient(dissipated, motion.q_dot))
    pulls = [
        neg(add(mul(k, value), mul(c, rate)))
        for k, c, value, rate in zip(
            [*stiffness[0], *stiffness[1]], [*damping[0], *damping[1]], values, rates, strict=True
        )
    ]
    force, moment = combination(a.axes, pulls[:3]), combination(_turning_axes(a, b), pulls[3:])
    return LoadEffect(row, potential=potential, dissipated=dissipated, action=[*force, *moment])


def _turning_axes(a: SpatialMarker, b: SpatialMarker) -> list[Vector]:
    """d(turn_i) = axis_i . d(phi) for a small rotation d(phi) of marker b: (b_j x a_k - b_k x a_j) / 2."""
    return [
        scaled(ca.SX(0.5), minus(cross(b.axes[j], a.axes[k]), cross(b.axes[k], a.axes[j])))
        for j, k in ((1, 2), (2, 0), (0, 1))
    ]


def gradient(value: ca.SX, variables: ca.SX) -> Row:
    """Non-zero partial derivatives by position in `variables`."""
    slope = ca.jacobian(value, variables)
    return {column: slope[0, column] + ZERO for column in range(variables.numel()) if not slope[0, column].is_zero()}
