"""Directions in which all coordinates follow a few, and the fields of frames along them.

A direction has S of Eq. (30) for each coordinate and its first two derivatives in time, so that a frame has the field
tau = sum S tau_c, D tau = sum (S D tau_c + S' tau_c), D^2 tau = sum (S D^2 tau_c + 2 S' D tau_c + S'' tau_c), alike v.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, mul
from symgen.algebra.vectors import plus, scaled, zeros
from symgen.system.frames.fields import TWO, Field, FieldPart, Rates


@dataclass(frozen=True)
class Direction:
    """dx_c/dx_i of each coordinate, and its first two derivatives in time, by column; column: of x_i."""

    column: int
    S: Row
    S_dot: Row
    S_ddot: Row

    def along(self, parts: Sequence[FieldPart]) -> Field:
        """The field of a frame that has these parts."""
        turning, moving = (zeros(), zeros(), zeros()), (zeros(), zeros(), zeros())
        for part in parts:
            s, s1, s2 = (share_of(part, row) for row in (self.S, self.S_dot, self.S_ddot))
            turning = _added(turning, part.field.turning, s, s1, s2)
            moving = _added(moving, part.field.moving, s, s1, s2)
        return Field(turning, moving)


def share_of(part: FieldPart, row: Row) -> ca.SX:
    """Of what a part's coordinates do."""
    found = ZERO
    for column, share in part.shares.items():
        if column in row:
            found = add(found, mul(share, row[column]))
    return found


def _added(known: Rates, own: Rates, s: ca.SX, s1: ca.SX, s2: ca.SX) -> Rates:
    x, x1, x2 = own
    first = plus(known[1], scaled(s, x1), scaled(s1, x))
    second = plus(known[2], scaled(s, x2), scaled(mul(TWO, s1), x1), scaled(s2, x))
    return plus(known[0], scaled(s, x)), first, second
