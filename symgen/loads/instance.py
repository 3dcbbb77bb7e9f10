"""Loads of the scene as generalised forces, with their potential, dissipated and applied power (Q_F of Eq. 20)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import casadi as ca

from symgen.bodies.planar_body import MarkerMotion
from symgen.loads import spring_template
from symgen.rows import Row, add_scaled


@dataclass(frozen=True)
class LoadEffect:
    """Generalised force by system column [N, N m]; potential [J]; dissipated and applied power [W]."""

    force: Row = field(default_factory=dict)
    potential: ca.SX = field(default_factory=lambda: ca.SX(0))
    dissipated: ca.SX = field(default_factory=lambda: ca.SX(0))
    applied: ca.SX = field(default_factory=lambda: ca.SX(0))


def point_force(marker: MarkerMotion, components: list[ca.SX], frame: str) -> LoadEffect:
    """Force at a marker, in world components or turning with the marker."""
    f_x, f_y = components
    if frame == "body":
        cosine, sine = marker.direction
        f_x, f_y = cosine * f_x - sine * f_y, sine * f_x + cosine * f_y
    row: Row = {}
    add_scaled(row, f_x, marker.r_columns[0])
    add_scaled(row, f_y, marker.r_columns[1])
    return LoadEffect(row, applied=f_x * marker.r_dot[0] + f_y * marker.r_dot[1])


def torque(marker: MarkerMotion, value: ca.SX, reaction: MarkerMotion | None) -> LoadEffect:
    """Torque on a marker, with its reaction on another body if named."""
    row: Row = {}
    add_scaled(row, value, marker.phi_row)
    rate = marker.phi_dot
    if reaction is not None:
        add_scaled(row, -value, reaction.phi_row)
        rate = rate - reaction.phi_dot
    return LoadEffect(row, applied=value * rate)


def spring_damper(a: MarkerMotion, b: MarkerMotion, stiffness: ca.SX, damping: ca.SX, free_length: ca.SX) -> LoadEffect:
    """Translational spring-damper between the points a and b."""
    s = spring_template
    values: Mapping = {
        s.d[0]: b.r[0] - a.r[0], s.d[1]: b.r[1] - a.r[1],
        s.d_dot[0]: b.r_dot[0] - a.r_dot[0], s.d_dot[1]: b.r_dot[1] - a.r_dot[1],
        s.k: stiffness, s.c: damping, s.l_0: free_length,
    }
    length = s.template().evaluate(values, ["length"])["length"]
    out = s.template().evaluate({**values, s.length: length}, ["force_x", "force_y", "potential", "dissipated"])
    row: Row = {}
    for axis, name in enumerate(("force_x", "force_y")):
        add_scaled(row, out[name], b.r_columns[axis])
        add_scaled(row, -out[name], a.r_columns[axis])
    return LoadEffect(row, potential=out["potential"], dissipated=out["dissipated"])


def rotational_spring_damper(
    a: MarkerMotion, b: MarkerMotion, stiffness: ca.SX, damping: ca.SX, free_angle: ca.SX
) -> LoadEffect:
    """Rotational spring-damper on phi_b - phi_a; with zero stiffness it is a joint's viscous friction."""
    turn, rate = b.phi - a.phi - free_angle, b.phi_dot - a.phi_dot
    moment = -stiffness * turn - damping * rate
    row: Row = {}
    add_scaled(row, moment, b.phi_row)
    add_scaled(row, -moment, a.phi_row)
    return LoadEffect(row, potential=stiffness * turn**2 / 2, dissipated=damping * rate**2)


def slide_friction(a: MarkerMotion, b: MarkerMotion, damping: ca.SX) -> LoadEffect:
    """Viscous friction along the line of marker a (prismatic joint)."""
    t_x, t_y = a.direction
    rate = t_x * (b.r_dot[0] - a.r_dot[0]) + t_y * (b.r_dot[1] - a.r_dot[1])
    row: Row = {}
    for axis, component in enumerate((t_x, t_y)):
        add_scaled(row, -damping * rate * component, b.r_columns[axis])
        add_scaled(row, damping * rate * component, a.r_columns[axis])
    return LoadEffect(row, dissipated=damping * rate**2)
