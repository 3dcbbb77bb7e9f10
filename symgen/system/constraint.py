"""One row of the constraints (Eqs. 21-27), and what makes a derivation impossible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from runtime.contract.errors import SymgenError
from runtime.contract.records import ROW_UNITS, Constraint, ConstraintKind
from symgen.algebra.rows import Row, add_scaled, nonzero
from symgen.algebra.scalar import ZERO, dot, mul, sub

Motion = Sequence[ca.SX]  # f, f', f'' of a quantity of a joint
STILL: Motion = (ZERO, ZERO, ZERO)


@dataclass(frozen=True)
class ConstraintRow:
    """One row of the constraints: C, C_q by column, C_t, gamma; label `joint.row`, row without the joint.

    joint: the joint's name, empty for the unit length of a body's Euler parameters. on_b: dC by a displacement and a
    rotation of marker b (planar: x, y, angle; spatial: x, y, z and about them); the joint acts on body b with -lam
    times that, at marker b. text: C as pages say it.
    """

    label: str
    joint: str
    kind: ConstraintKind
    C: ca.SX
    C_q: Row
    C_t: ca.SX
    gamma: ca.SX
    on_b: tuple[ca.SX, ...]
    text: str = ""

    @property
    def record(self) -> Constraint:
        """What the row is, without its expressions."""
        return Constraint(self.label, self.joint, self.kind, ROW_UNITS[self.kind])


def combined(name: str, rows: Sequence[ConstraintRow], factors: Sequence[ca.SX], constant: ca.SX) -> ConstraintRow:
    """The row sum of factors times rows = constant, of the coupling `name`; it acts on marker b of the first."""
    C_q: Row = {}
    for row, factor in zip(rows, factors, strict=True):
        add_scaled(C_q, factor, row.C_q)
    return ConstraintRow(
        f"{name}.ratio",
        name,
        rows[0].kind,
        sub(dot(factors, [row.C for row in rows]), constant),
        nonzero(C_q),
        ZERO,
        dot(factors, [row.gamma for row in rows]),
        tuple(mul(factors[0], value) for value in rows[0].on_b),
        " + ".join(f"a_{k} {row.label}" for k, row in enumerate(rows, start=1)) + " = constant",
    )


class DerivationError(SymgenError):
    """Names the item, what is wrong with it, and what to do; the pipeline gives it to the user as a SceneError."""
