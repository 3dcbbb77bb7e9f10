"""How frames move for a unit rate of a coordinate, and the rates of that: twists with their first two derivatives.

A coordinate displaces a frame by a turning tau and a shift v, in the axes of the frame. With D the rate as seen from
the ground, D x = x' + omega x x, D^2 x = x'' + 2 omega x x' + G x, a point that is at r from the origin and moves with
V relative to it, with A its acceleration relative to it, is displaced by v + tau x r, and

    D(v + tau x r)   = D v + D tau x r + tau x V,
    D^2(v + tau x r) = D^2 v + D^2 tau x r + 2 D tau x V + tau x A.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, mul
from symgen.algebra.vectors import (
    Vector,
    combination,
    cross,
    negative,
    plus,
    scaled,
    times,
    transposed_times,
    zeros,
)
from symgen.system.frames.body_moves import Bend, Unbend
from symgen.system.frames.motion import Motion, Twist, Wrench
from symgen.system.frames.moves import Fixed, Move, Slide, Turn, unit
from symgen.system.frames.tangents import Change

TWO = ca.SX(2)
Rates = tuple[Vector, Vector, Vector]  # x, D x, D^2 x


@dataclass(frozen=True)
class Spot:
    """A move with the motion before and after it, and the rates and accelerations of the coordinates by column."""

    before: Motion
    after: Motion
    rates: Row
    accelerations: Row


@dataclass(frozen=True)
class MovingArm:
    """From the origin before a move to the one after it, as seen from the ground: where, velocity, acceleration.

    In the axes before the move; for `Unbend` in those after it.
    """

    r: Vector
    V: Vector
    A: Vector


@dataclass(frozen=True)
class Field:
    """tau and v of a frame with their rates; doubled: 2 D tau and 2 D v where they come for less."""

    turning: Rates
    moving: Rates
    doubled: tuple[Vector, Vector] | None = None

    @property
    def twist(self) -> Twist:
        """tau and v."""
        return Twist(self.turning[0], self.moving[0])

    def by_position(self, a: Vector) -> Change:
        """Change of the frame's motion by the coordinate, seen in the frame; a: acceleration of its origin."""
        return Change(self.turning[1], self.turning[2], plus(self.moving[2], cross(a, self.turning[0])))

    @property
    def by_rate(self) -> Change:
        """Change by the rate of the coordinate."""
        beta, d = self.doubled or (scaled(TWO, self.turning[1]), scaled(TWO, self.moving[1]))
        return Change(self.turning[0], beta, d)

    def beyond(self, move: Move, spot: Spot) -> Field:
        """Of the frame after a move."""
        if isinstance(move, Unbend):
            return self._seen(move).shifted(arm_of(move, spot))
        return self.shifted(arm_of(move, spot))._seen(move)

    def shifted(self, arm: MovingArm) -> Field:
        """About the end of an arm."""
        t, t1, t2 = self.turning
        v, v1, v2 = self.moving
        first = plus(v1, cross(t1, arm.r), cross(t, arm.V))
        second = plus(v2, cross(t2, arm.r), cross(scaled(TWO, t1), arm.V), cross(t, arm.A))
        return Field(self.turning, (plus(v, cross(t, arm.r)), first, second))

    def _seen(self, move: Move) -> Field:
        t, t1, t2 = (seen_beyond(move, vector) for vector in self.turning)
        v, v1, v2 = (seen_beyond(move, vector) for vector in self.moving)
        return Field((t, t1, t2), (v, v1, v2))


@dataclass(frozen=True)
class FieldPart:
    """What the coordinates of some columns do to the frame after a move, each its share of it."""

    shares: Row
    field: Field


def seen_beyond(move: Move, vector: Vector) -> Vector:
    """A vector in the axes after a move."""
    if isinstance(move, Turn):
        return move.seen(vector)
    if isinstance(move, Fixed):
        return transposed_times(move.R, vector)
    if isinstance(move, Bend):
        return transposed_times(move.deformation.at({}).R, vector)
    return times(move.deformation.at({}).R, vector) if isinstance(move, Unbend) else vector


def arm_of(move: Move, spot: Spot) -> MovingArm:
    """Of a move."""
    if isinstance(move, Bend | Unbend):
        body = spot.after if isinstance(move, Unbend) else spot.before
        bent = move.deformation.at(spot.rates)
        r, V = bent.rho, plus(bent.rho_dot, cross(body.omega, bent.rho))
        own = combination(bent.shapes, move.deformation.of(spot.accelerations))
        A = plus(times(body.G, r), bent.drift(body.omega), own)
        return MovingArm(negative(r), negative(V), negative(A)) if isinstance(move, Unbend) else MovingArm(r, V, A)
    r, speed, own = zeros(), zeros(), zeros()
    if isinstance(move, Slide):
        r = unit(move.axis, move.amount)
        if move.column is not None:
            speed = unit(move.axis, mul(move.factor, spot.rates.get(move.column, ZERO)))
            own = unit(move.axis, mul(move.factor, spot.accelerations.get(move.column, ZERO)))
    elif isinstance(move, Fixed):
        r = move.r
    omega = spot.before.omega
    A = plus(times(spot.before.G, r), cross(scaled(TWO, omega), speed), own)
    return MovingArm(r, plus(cross(omega, r), speed), A)


def joint_parts(move: Move, spot: Spot) -> list[FieldPart]:
    """Of a hinge or a slide."""
    if isinstance(move, Turn | Slide) and move.column is not None:
        axis = unit(move.axis, move.sign if isinstance(move, Turn) else move.factor)
        rates = axis, cross(spot.after.omega, axis), times(spot.after.G, axis)
        twice, still = cross(scaled(TWO, spot.after.omega), axis), (zeros(), zeros(), zeros())
        turns, slides = Field(rates, still, (twice, zeros())), Field(still, rates, (zeros(), twice))
        return [FieldPart({move.column: ONE}, turns if isinstance(move, Turn) else slides)]
    return []


def turned(twist: Twist, wrench: Wrench) -> Wrench:
    """What a displacement of the frame after a move does to the wrench there, which goes with it."""
    return Wrench(cross(twist.omega, wrench.f), plus(cross(twist.omega, wrench.n), cross(twist.v, wrench.f)))
