"""How the motion of a frame, and the powers of a wrench on the modes that lead there, change by those modes.

What several modes do alike is done once and each has its share: all that shift a marker along one axis of the body, and
all that turn it about one axis of psi. What one mode does to the turns of another is a form of their axes of psi too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg, sub
from symgen.algebra.vectors import (
    Vector,
    combination,
    cross,
    minus,
    negative,
    plus,
    scaled,
    times,
    transposed_times,
    zeros,
)
from symgen.bodies.deformation import Bent, Deformation, along_axes
from symgen.system.frames.body_moves import Bend, Unbend
from symgen.system.frames.fields import TWO, Field, FieldPart, Rates, Spot, arm_of, joint_parts
from symgen.system.frames.motion import Motion, Wrench
from symgen.system.frames.moves import Move, unit

HALF = ca.SX(0.5)


@dataclass(frozen=True)
class _Shared:
    """A turning theta of psi and a shape, of which modes have shares by column; fading: the first two rates of it."""

    shares: Row
    theta: Vector
    shape: Vector
    fading: tuple[Vector, Vector]


@dataclass(frozen=True)
class _Bending:
    """A marker's place rho and turning as the modes of its body move them, in body axes, which move with `body`."""

    deformation: Deformation
    body: Motion
    rates: Row
    accelerations: Row

    @cached_property
    def bent(self) -> Bent:
        return self.deformation.at(self.rates)

    @cached_property
    def _own(self) -> tuple[Vector, Vector]:
        return self.deformation.of(self.rates), self.deformation.of(self.accelerations)

    @cached_property
    def shared(self) -> list[_Shared]:
        """By axes where that is fewer than by modes."""
        point, columns, still = self.deformation.point, self.deformation.columns, (zeros(), zeros())
        turns, shapes = along_axes(point.turns, columns), along_axes(point.shapes, columns)
        moving = [b for b in range(len(columns)) if not _nothing([*point.turns[b], *point.shapes[b]])]
        if not point.H and len(turns) + len(shapes) < len(moving):
            by_turn = [_Shared(shares, unit(axis), zeros(), still) for axis, shares in turns.items()]
            return by_turn + [_Shared(shares, zeros(), unit(axis), still) for axis, shares in shapes.items()]
        return [_Shared({columns[b]: ONE}, point.turns[b], self.bent.shapes[b], self._fading(b)) for b in moving]

    def _fading(self, b: int) -> tuple[Vector, Vector]:
        H = self.deformation.point.H
        first, second = ([neg(dot(block[b], values)) for block in H] or zeros() for values in self._own)
        return first, second

    @cached_property
    def _turning(self) -> tuple[Vector, Vector, ca.SX, ca.SX]:
        """psi' and psi'' with 1 / (2 k), k' / k and k'' / k, where k = 1 + psi.psi / 4."""
        turns, (speeds, own) = self.deformation.point.turns, self._own
        first, second, bent = combination(turns, speeds), combination(turns, own), self.bent
        half = mul(HALF, bent.inverse)
        rate = mul(half, dot(bent.psi, first))
        bending = mul(half, add(dot(first, first), dot(bent.psi, second)))
        return scaled(half, first), scaled(half, second), rate, bending

    def turned(self, one: _Shared) -> Rates:
        """The axis about which the marker turns for a unit rate, its D and D^2."""
        if _nothing(one.theta):
            return zeros(), zeros(), zeros()
        bent, theta = self.bent, one.theta
        value = scaled(bent.inverse, plus(theta, scaled(HALF, cross(bent.psi, theta))))
        first, second, rate, bending = self._turning
        own = minus(cross(first, theta), scaled(rate, value))
        more = minus(cross(second, theta), plus(scaled(mul(TWO, rate), own), scaled(bending, value)))
        return self._seen(value, own, more)

    def shape(self, one: _Shared) -> Rates:
        """By what the marker moves for a unit rate, its D and D^2."""
        return self._seen(one.shape, *one.fading)

    def _seen(self, value: Vector, rate: Vector, second: Vector) -> Rates:
        omega = self.body.omega
        first = plus(rate, cross(omega, value))
        return value, first, plus(second, cross(scaled(TWO, omega), rate), times(self.body.G, value))

    def on_turns_changed(self, one: _Shared, moment: Vector) -> Vector:
        """d(on_turns(moment)) for a unit of what is shared, at a fixed moment."""
        half, bent = mul(HALF, self.bent.inverse), self.bent
        fewer = scaled(mul(half, dot(bent.psi, one.theta)), bent.on_turns(moment))
        return minus(scaled(half, cross(moment, one.theta)), fewer)


def parts_of(move: Move, spot: Spot) -> list[FieldPart]:
    """What the coordinates of a move do."""
    if isinstance(move, Bend | Unbend):
        return BendChanges(move.deformation, spot, isinstance(move, Unbend)).parts
    return joint_parts(move, spot)


class BendChanges:
    """From the frame of a flexible body to a marker, or with `back` from such a marker to the frame."""

    def __init__(self, deformation: Deformation, spot: Spot, back: bool) -> None:
        self._back, self._deformation = back, deformation
        self._bending = _Bending(deformation, spot.after if back else spot.before, spot.rates, spot.accelerations)
        self._R = self._bending.bent.R
        self._spot = spot

    @cached_property
    def parts(self) -> list[FieldPart]:
        """By what is shared."""
        return [self._unbent(one) if self._back else self._bent(one) for one in self._bending.shared]

    def _bent(self, one: _Shared) -> FieldPart:
        (t, t1, t2), (s, s1, s2) = self._bending.turned(one), self._bending.shape(one)
        turning, moving = ([transposed_times(self._R, vector) for vector in own] for own in ((t, t1, t2), (s, s1, s2)))
        return FieldPart(one.shares, Field((turning[0], turning[1], turning[2]), (moving[0], moving[1], moving[2])))

    def _unbent(self, one: _Shared) -> FieldPart:
        (t, t1, t2), (s, s1, s2) = self._bending.turned(one), self._bending.shape(one)
        still = Field((negative(t), negative(t1), negative(t2)), (negative(s), negative(s1), negative(s2)))
        return FieldPart(one.shares, still.shifted(arm_of(Unbend(self._deformation), self._spot)))

    def powers(self, column: int, wrench: Wrench, change: Wrench) -> Row:
        """Changes of the powers by a mode, for the wrench after the move and its change, both in the axes there."""
        bending, point = self._bending, self._deformation.point
        shares = [(one, one.shares[column]) for one in bending.shared if column in one.shares]
        f, moment = self._at_marker(wrench)
        df, dn = self._at_marker(change)
        turning = bending.bent.on_turns(plus(dn, *(self._carried(one, share, f, moment) for one, share in shares)))
        for one, share in shares:
            turning = plus(turning, scaled(share, bending.on_turns_changed(one, moment)))
            if not self._back:
                df = plus(df, scaled(share, cross(bending.turned(one)[0], f)))
        found, b = {}, self._deformation.columns.index(column)
        for a, other in enumerate(self._deformation.columns):
            value = add(dot(bending.bent.shapes[a], df), dot(point.turns[a], turning))
            for i, H in enumerate(point.H):
                value = sub(value, mul(H[a][b], f[i]))
            found[other] = neg(value) if self._back else value
        return found

    def among(self, wrench: Wrench) -> list[list[ca.SX]]:
        """Change of the power on each part, by rows, by each part, for a wrench after the move that goes with it."""
        shared, point = self._bending.shared, self._deformation.point
        f, moment = self._at_marker(wrench)
        found = [[ZERO] * len(shared) for _ in shared]
        for k, one in enumerate(shared):
            turning = self._bending.bent.on_turns(self._carried(one, ONE, f, moment))
            turning = plus(turning, self._bending.on_turns_changed(one, moment))
            df = zeros() if self._back else cross(self._bending.turned(one)[0], f)
            for i, row in enumerate(shared):
                value = add(dot(row.shape, df), dot(row.theta, turning))
                for axis, H in enumerate(point.H):
                    a, b = (self._deformation.columns.index(next(iter(mode.shares))) for mode in (row, one))
                    value = sub(value, mul(H[a][b], f[axis]))
                found[i][k] = neg(value) if self._back else value
        return found

    def _at_marker(self, wrench: Wrench) -> tuple[Vector, Vector]:
        """Force and moment about the marker in body axes."""
        if self._back:
            return wrench.f, minus(wrench.n, cross(self._bending.bent.rho, wrench.f))
        return times(self._R, wrench.f), times(self._R, wrench.n)

    def _carried(self, one: _Shared, share: ca.SX, f: Vector, moment: Vector) -> Vector:
        """Change of the moment in body axes: the wrench turns with the marker, or the marker moves along its force."""
        own = negative(cross(one.shape, f)) if self._back else cross(self._bending.turned(one)[0], moment)
        return scaled(share, own)


def _nothing(values: Vector) -> bool:
    return all(value.is_zero() for value in values)
