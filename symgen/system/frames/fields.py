"""How frames move for a unit rate of a coordinate, and the rates of that: twists with their first two derivatives.

A coordinate displaces a frame by a turning tau and a shift v, in the axes of the frame. With D the rate as seen from
the ground, D x = x' + omega x x, D^2 x = x'' + 2 omega x x' + G x, a point that is at r from the origin and moves with
V relative to it, with A its acceleration relative to it, is displaced by v + tau x r, and

    D(v + tau x r)   = D v + D tau x r + tau x V,
    D^2(v + tau x r) = D^2 v + D^2 tau x r + 2 D tau x V + tau x A.

Directions in which all coordinates follow a few, and the fields of frames along them.

A direction has S of Eq. (30) for each coordinate and its first two derivatives in time, so that a frame has the field
tau = sum S tau_c, D tau = sum (S D tau_c + S' tau_c), D^2 tau = sum (S D^2 tau_c + 2 S' D tau_c + S'' tau_c), alike v.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, mul
from symgen.algebra.vectors import (
    Vector,
    combination,
    cross,
    negative,
    plus,
    scaled,
    times,
    zeros,
)
from symgen.system.equations import Direction
from symgen.system.frames.joint_transforms import JointNode, MarkerNode, Node, unit
from symgen.system.frames.spatial_algebra import Force, FrameMotion, Motion

TWO = ca.SX(2)
Rates = tuple[Vector, Vector, Vector]  # x, D x, D^2 x


@dataclass(frozen=True)
class TransformState:
    """A transform with the motion before and after it, and the rates and accelerations of the coordinates by column."""

    before: FrameMotion
    after: FrameMotion
    rates: Row
    accelerations: Row


@dataclass(frozen=True)
class RelativeMotion:
    """From the origin before a transform to the one after it, as seen from the ground: where, velocity, acceleration.

    In the axes before the transform; for one `back` from a marker in those after it.
    """

    r: Vector
    V: Vector
    A: Vector


@dataclass(frozen=True)
class Change:
    """(u, beta, d) of a frame: changes of omega, of alpha with omega x u, and of a; see `rnea_derivatives`."""

    u: Vector
    beta: Vector
    d: Vector


@dataclass(frozen=True)
class Field:
    """tau and v of a frame with their rates."""

    rotation: Rates
    moving: Rates

    @property
    def twist(self) -> Motion:
        """tau and v."""
        return Motion(self.rotation[0], self.moving[0])

    def by_position(self, a: Vector) -> Change:
        """Change of the frame's motion by the coordinate, seen in the frame; a: acceleration of its origin."""
        return Change(self.rotation[1], self.rotation[2], plus(self.moving[2], cross(a, self.rotation[0])))

    @property
    def by_rate(self) -> Change:
        """Change by the rate of the coordinate."""
        return Change(self.rotation[0], scaled(TWO, self.rotation[1]), scaled(TWO, self.moving[1]))

    def after(self, transform: Node, moved: TransformState) -> Field:
        """Of the frame after a transform."""
        if transform.back:
            return self.transformed(transform).shifted(relative_motion(transform, moved))
        return self.shifted(relative_motion(transform, moved)).transformed(transform)

    def shifted(self, arm: RelativeMotion) -> Field:
        """About the end of an arm."""
        t, t1, t2 = self.rotation
        v, v1, v2 = self.moving
        first = plus(v1, cross(t1, arm.r), cross(t, arm.V))
        second = plus(v2, cross(t2, arm.r), cross(scaled(TWO, t1), arm.V), cross(t, arm.A))
        return Field(self.rotation, (plus(v, cross(t, arm.r)), first, second))

    def transformed(self, transform: Node) -> Field:
        """In the axes after a transform."""
        t, t1, t2 = (transform.transformed(vector) for vector in self.rotation)
        v, v1, v2 = (transform.transformed(vector) for vector in self.moving)
        return Field((t, t1, t2), (v, v1, v2))


@dataclass(frozen=True)
class FieldPart:
    """What the coordinates of some columns do to the frame after a transform, each its share of it."""

    shares: Row
    field: Field


def relative_motion(transform: Node, moved: TransformState) -> RelativeMotion:
    """Of a transform."""
    if isinstance(transform, MarkerNode):
        body = moved.after if transform.back else moved.before
        deformed = transform.deformation.at(moved.rates)
        r, V = deformed.rho, plus(deformed.rho_dot, cross(body.omega, deformed.rho))
        own = combination(deformed.shapes, transform.deformation.of(moved.accelerations))
        A = plus(times(body.G, r), deformed.drift(body.omega), own)
        return RelativeMotion(negative(r), negative(V), negative(A)) if transform.back else RelativeMotion(r, V, A)
    r, speed, own = transform.r, zeros(), zeros()
    if transform.column is not None and not transform.turns:
        speed = scaled(moved.rates.get(transform.column, ZERO), transform.S.v)
        own = scaled(moved.accelerations.get(transform.column, ZERO), transform.S.v)
    omega = moved.before.omega
    A = plus(times(moved.before.G, r), cross(scaled(TWO, omega), speed), own)
    return RelativeMotion(r, plus(cross(omega, r), speed), A)


def joint_parts(transform: JointNode, moved: TransformState) -> list[FieldPart]:
    """Of a hinge or a slide."""
    if transform.column is not None:
        axis = unit(transform.axis, transform.sign)
        rates = axis, cross(moved.after.omega, axis), times(moved.after.G, axis)
        still = zeros(), zeros(), zeros()
        return [FieldPart({transform.column: ONE}, Field(rates, still) if transform.turns else Field(still, rates))]
    return []


def cross_wrench(twist: Motion, wrench: Force) -> Force:
    """twist x* wrench: what a displacement of the frame after a transform does to the wrench there, which goes with it.

    The spatial cross product for forces of R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 2.9.
    """
    return Force(cross(twist.omega, wrench.f), plus(cross(twist.omega, wrench.n), cross(twist.v, wrench.f)))


def field_along(direction: Direction, parts: Sequence[FieldPart]) -> Field:
    """The field of a frame that has these parts, as a direction moves them."""
    rotation, moving = (zeros(), zeros(), zeros()), (zeros(), zeros(), zeros())
    for part in parts:
        s, s1, s2 = (share_of(part, row) for row in (direction.S, direction.S_dot, direction.S_ddot))
        rotation = _added(rotation, part.field.rotation, s, s1, s2)
        moving = _added(moving, part.field.moving, s, s1, s2)
    return Field(rotation, moving)


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
