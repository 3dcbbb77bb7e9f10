"""Constraint rows between two markers of planar bodies (Eqs. 21-27)."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from symgen.bodies.planar_body import MarkerMotion
from symgen.joints import (
    distance,
    point_on_line,
    prescribed_angle,
    prescribed_displacement,
    prismatic,
    revolute,
    weld,
)
from symgen.joints import planar_template as s
from symgen.joints.instance import ConstraintRow, Slot, template_rows
from symgen.joints.joint_type import JointType, f, f_t, f_tt

TYPES: dict[str, Callable[[], JointType]] = {
    "revolute": revolute.planar,
    "prismatic": prismatic.planar,
    "weld": weld.planar,
    "point_on_line": point_on_line.planar,
    "distance": distance.planar,
    "prescribed_angle": prescribed_angle.planar,
    "prescribed_displacement": prescribed_displacement.planar,
}


def planar_rows(name: str, kind: str, a: MarkerMotion, b: MarkerMotion, motion: list[ca.SX]) -> list[ConstraintRow]:
    """Rows of the joint `name` between markers a and b; motion = [f, f', f''] of t (zeros if scleronomic)."""
    return template_rows(name, TYPES[kind](), _values(a, b, motion), _slots(a, b), ("r_b_x", "r_b_y", "phi_b"))


def _slots(a: MarkerMotion, b: MarkerMotion) -> list[Slot]:
    zero = ca.SX(0)
    return [
        Slot("r_a_x", a.r_columns[0], a.bias[0]),
        Slot("r_a_y", a.r_columns[1], a.bias[1]),
        Slot("r_b_x", b.r_columns[0], b.bias[0]),
        Slot("r_b_y", b.r_columns[1], b.bias[1]),
        Slot("phi_a", a.phi_row, zero),
        Slot("phi_b", b.phi_row, zero),
    ]


def _values(a: MarkerMotion, b: MarkerMotion, motion: list[ca.SX]) -> dict:
    return {
        **dict(zip(s.r_a, a.r, strict=True)),
        **dict(zip(s.r_b, b.r, strict=True)),
        **dict(zip(s.r_a_dot, a.r_dot, strict=True)),
        **dict(zip(s.r_b_dot, b.r_dot, strict=True)),
        **dict(zip(s.t_a, a.direction, strict=True)),
        s.phi_a: a.phi,
        s.phi_b: b.phi,
        s.phi_a_dot: a.phi_dot,
        s.phi_b_dot: b.phi_dot,
        f: motion[0],
        f_t: motion[1],
        f_tt: motion[2],
    }
