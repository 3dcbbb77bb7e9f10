"""A joint of the scene: its type's template at the two markers, chained to the system columns (Eqs. 21-27)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from symgen.bodies.planar_body import MarkerMotion
from symgen.joints import (
    planar_template as symbols,
)
from symgen.joints import (
    point_on_line,
    prescribed_angle,
    prescribed_displacement,
    prismatic,
    revolute,
    weld,
)
from symgen.joints.planar_template import JointType
from symgen.rows import Row, add_scaled, nonzero
from symgen.scalar import mul, neg, sub

JOINT_TYPES: dict[str, Callable[[], JointType]] = {
    "revolute": revolute.template,
    "prismatic": prismatic.template,
    "weld": weld.template,
    "point_on_line": point_on_line.template,
    "prescribed_angle": prescribed_angle.template,
    "prescribed_displacement": prescribed_displacement.template,
}


@dataclass(frozen=True)
class ConstraintRow:
    """One row of the constraints: C (m or rad), C_q by column, C_t, gamma; label `joint.row`.

    on_b: dC/d(r_b_x, r_b_y, phi_b); the joint acts on body b with -lam times that, at marker b.
    """

    label: str
    joint: str
    C: ca.SX
    C_q: Row
    C_t: ca.SX
    gamma: ca.SX
    on_b: tuple[ca.SX, ca.SX, ca.SX]


def constraint_rows(name: str, kind: str, a: MarkerMotion, b: MarkerMotion, motion: list[ca.SX]) -> list[ConstraintRow]:
    """Rows of the joint `name` between markers a and b; motion = [f, f', f''] of t (zeros if scleronomic)."""
    joint = JOINT_TYPES[kind]()
    output = joint.template.evaluate(_values(a, b, motion))
    rows = []
    for k, label in enumerate(joint.labels):
        C_q: Row = {}
        gamma = neg(output[f"drift_{k}"])
        for slot, jacobian, bias in _slots(a, b):
            factor = output[f"C_{k}_{slot}"]
            add_scaled(C_q, factor, jacobian)
            gamma = sub(gamma, mul(factor, bias))
        on_b = output[f"C_{k}_r_b_x"], output[f"C_{k}_r_b_y"], output[f"C_{k}_phi_b"]
        rows.append(ConstraintRow(f"{name}.{label}", name, output[f"C_{k}"], nonzero(C_q), output[f"C_t_{k}"], gamma,
                                  on_b))
    return rows


def _slots(a: MarkerMotion, b: MarkerMotion) -> list[tuple[str, Row, ca.SX]]:
    zero = ca.SX(0)
    return [
        ("r_a_x", a.r_columns[0], a.bias[0]), ("r_a_y", a.r_columns[1], a.bias[1]),
        ("r_b_x", b.r_columns[0], b.bias[0]), ("r_b_y", b.r_columns[1], b.bias[1]),
        ("phi_a", a.phi_row, zero), ("phi_b", b.phi_row, zero),
    ]


def _values(a: MarkerMotion, b: MarkerMotion, motion: list[ca.SX]) -> dict:
    s = symbols
    return {
        **dict(zip(s.r_a, a.r, strict=True)), **dict(zip(s.r_b, b.r, strict=True)),
        **dict(zip(s.r_a_dot, a.r_dot, strict=True)), **dict(zip(s.r_b_dot, b.r_dot, strict=True)),
        **dict(zip(s.t_a, a.direction, strict=True)),
        s.phi_a: a.phi, s.phi_b: b.phi, s.phi_a_dot: a.phi_dot, s.phi_b_dot: b.phi_dot,
        s.f: motion[0], s.f_t: motion[1], s.f_tt: motion[2],
    }
