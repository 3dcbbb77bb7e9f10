"""Loads between markers of planar bodies as generalised forces, with potential and powers (Q_F of Eq. 20)."""

from __future__ import annotations

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, nonzero
from symgen.algebra.scalar import ZERO
from symgen.bodies.planar_body import MarkerMotion
from symgen.loads import spring_template
from symgen.loads.effect import LinearSpring, LoadEffect


def point_force(marker: MarkerMotion, components: list[ca.SX], frame: str) -> LoadEffect:
    """Force at a marker, in world components or turning with the marker."""
    f_x, f_y = components
    if frame == "body":
        cosine, sine = marker.direction
        f_x, f_y = cosine * f_x - sine * f_y, sine * f_x + cosine * f_y
    row: Row = {}
    add_scaled(row, f_x, marker.r_columns[0])
    add_scaled(row, f_y, marker.r_columns[1])
    return LoadEffect(row, applied=f_x * marker.r_dot[0] + f_y * marker.r_dot[1], action=[f_x, f_y, ZERO])


def torque(marker: MarkerMotion, value: ca.SX, reaction: MarkerMotion | None) -> LoadEffect:
    """Torque on a marker, with its reaction on another body if named."""
    row: Row = {}
    add_scaled(row, value, marker.phi_row)
    rate = marker.phi_dot
    if reaction is not None:
        add_scaled(row, -value, reaction.phi_row)
        rate = rate - reaction.phi_dot
    return LoadEffect(row, applied=value * rate, action=[ZERO, ZERO, value])


def push(a: MarkerMotion, b: MarkerMotion, value: ca.SX) -> LoadEffect:
    """Force on b along the x-axis of marker a, its opposite on a (prismatic joint)."""
    direction = a.direction
    row: Row = {}
    for axis, component in enumerate(direction):
        add_scaled(row, value * component, b.r_columns[axis])
        add_scaled(row, -value * component, a.r_columns[axis])
    rate = sum(t * (of_b - of_a) for t, of_b, of_a in zip(direction, b.r_dot, a.r_dot, strict=True))
    return LoadEffect(row, applied=value * rate, action=[*(value * t for t in direction), ZERO])


def spring_damper(a: MarkerMotion, b: MarkerMotion, stiffness: ca.SX, damping: ca.SX, free_length: ca.SX) -> LoadEffect:
    """Translational spring-damper between the points a and b."""
    d, d_dot = (
        [first - second for first, second in zip(of_b, of_a, strict=True)]
        for of_b, of_a in ((b.r, a.r), (b.r_dot, a.r_dot))
    )
    out = spring_template.evaluate(d, d_dot, stiffness, damping, free_length)
    row: Row = {}
    for axis in range(2):
        add_scaled(row, out.force[axis], b.r_columns[axis])
        add_scaled(row, -out.force[axis], a.r_columns[axis])
    return LoadEffect(row, potential=out.potential, dissipated=out.dissipated, action=[*out.force, ZERO])


def rotational_spring_damper(
    a: MarkerMotion, b: MarkerMotion, stiffness: ca.SX, damping: ca.SX, free_angle: ca.SX
) -> LoadEffect:
    """Rotational spring-damper on phi_b - phi_a; with zero stiffness it is a joint's viscous friction."""
    turn, rate = b.phi - a.phi - free_angle, b.phi_dot - a.phi_dot
    moment = -stiffness * turn - damping * rate
    row: Row = {}
    add_scaled(row, moment, b.phi_row)
    add_scaled(row, -moment, a.phi_row)
    deflection: Row = {}
    add_scaled(deflection, ca.SX(1), b.phi_row)
    add_scaled(deflection, ca.SX(-1), a.phi_row)
    spring = LinearSpring(nonzero(deflection), stiffness, damping)
    potential, dissipated = stiffness * turn**2 / 2, damping * rate**2
    return LoadEffect(row, potential=potential, dissipated=dissipated, spring=spring, action=[ZERO, ZERO, moment])


def slide_friction(a: MarkerMotion, b: MarkerMotion, damping: ca.SX) -> LoadEffect:
    """Viscous friction along the line of marker a (prismatic joint)."""
    t_x, t_y = a.direction
    rate = t_x * (b.r_dot[0] - a.r_dot[0]) + t_y * (b.r_dot[1] - a.r_dot[1])
    row: Row = {}
    for axis, component in enumerate((t_x, t_y)):
        add_scaled(row, -damping * rate * component, b.r_columns[axis])
        add_scaled(row, damping * rate * component, a.r_columns[axis])
    return LoadEffect(row, dissipated=damping * rate**2)
