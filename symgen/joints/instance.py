"""Constraint rows of a joint: its type's template at the two markers, chained to the system columns (Eqs. 21-27)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import sympy as sp

from runtime.contract.records import ROW_UNITS, Constraint
from symgen.algebra.rows import Row, add_scaled, nonzero
from symgen.algebra.scalar import mul, neg, sub
from symgen.joints.joint_type import ROW_KINDS, JointType


@dataclass(frozen=True)
class ConstraintRow:
    """One row of the constraints: C (m or rad), C_q by column, C_t, gamma; label `joint.row`, row without the joint.

    joint: the joint's name, empty for the unit length of a body's Euler parameters. on_b: dC by a displacement and a
    rotation of marker b (planar: x, y, angle; spatial: x, y, z and about them); the joint acts on body b with -lam
    times that, at marker b.
    """

    label: str
    joint: str
    C: ca.SX
    C_q: Row
    C_t: ca.SX
    gamma: ca.SX
    on_b: tuple[ca.SX, ...]
    row: str

    @property
    def record(self) -> Constraint:
        """What the row is, without its expressions."""
        kind = ROW_KINDS[self.row]
        return Constraint(self.label, self.joint, kind, ROW_UNITS[kind])


@dataclass(frozen=True)
class Slot:
    """One quantity of a marker that a template differentiates by: its rows over q and its bias acceleration."""

    name: str
    row: Row
    bias: ca.SX


def template_rows(
    name: str, joint: JointType, values: Mapping[sp.Symbol, ca.SX], slots: Sequence[Slot], on_b: Sequence[str]
) -> list[ConstraintRow]:
    """Rows of the joint `name`: C (21), C_q and C_t (24), gamma of (25) and (27); nu = -C_t is (26).

    on_b names the slots that displace and turn marker b.
    """
    output = joint.template.evaluate(values)
    rows = []
    for k, label in enumerate(joint.labels):
        C_q: Row = {}
        gamma = neg(output[f"drift_{k}"])
        for slot in slots:
            factor = output[f"C_{k}_{slot.name}"]
            add_scaled(C_q, factor, slot.row)
            gamma = sub(gamma, mul(factor, slot.bias))
        acting = tuple(output[f"C_{k}_{slot}"] for slot in on_b)
        rows.append(
            ConstraintRow(
                f"{name}.{label}", name, output[f"C_{k}"], nonzero(C_q), output[f"C_t_{k}"], gamma, acting, label
            )
        )
    return rows
