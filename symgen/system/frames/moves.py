"""The moves that lead from a frame to the next one, and what each does to motions, wrenches, inertia and paths.

A move may depend on coordinates: then it has twists, the motion of the frame after it for a unit rate of each.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Protocol

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, mul, neg
from symgen.algebra.vectors import Vector, cross, plus, scaled, times, transposed_times, zeros
from symgen.system.frames.motion import Composite, Matrix, Motion, Twist, Wrench, turned_back
from symgen.system.frames.paths import Path


class Move(Protocol):
    """From one frame to the next."""

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q, in the axes and at the origin of the frame after the move."""

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move; rates and accelerations by column, zero where absent."""

    def wrench(self, after: Wrench) -> Wrench:
        """A wrench of the frame after the move, seen before it."""

    def powers(self, after: Wrench) -> Row:
        """Power of a wrench of the frame after the move on the twist of each column."""

    def momentum(self, column: int, after: Wrench, composite: Composite) -> Wrench:
        """`wrench` of the momentum that a unit rate of one of the move's columns gives to all beyond (composite)."""

    def composite(self, after: Composite) -> Composite:
        """Inertia of the frame after the move, seen before it."""

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""


def unit(axis: int, value: ca.SX = ONE) -> Vector:
    """value times a unit vector."""
    result = zeros()
    result[axis] = value
    return result


class Plain:
    """A move for which a momentum is a wrench like any other."""

    def powers(self: Move, after: Wrench) -> Row:
        """Power of a wrench on the twist of each column."""
        return {column: after.along(twist) for column, twist in self.twists.items()}

    def momentum(self: Move, column: int, after: Wrench, composite: Composite) -> Wrench:
        """Seen before the move."""
        return self.wrench(after)


@dataclass(frozen=True)
class Turn(Plain):
    """A rotation about coordinate axis `axis`; its angle is sign times the coordinate of `column`, and a constant."""

    axis: int
    cosine: ca.SX
    sine: ca.SX
    column: int | None = None
    rate: ca.SX = ZERO
    sign: ca.SX = ONE

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        return {} if self.column is None else {self.column: Twist(unit(self.axis, self.sign), zeros())}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move."""
        omega, alpha, a = (self.seen(vector) for vector in (before.omega, before.alpha, before.a))
        if self.column is None:
            return Motion(omega, alpha, a)
        spin = unit(self.axis, mul(self.sign, rates.get(self.column, ZERO)))
        alpha = plus(alpha, cross(omega, spin))
        alpha[self.axis] = add(alpha[self.axis], mul(self.sign, accelerations.get(self.column, ZERO)))
        return Motion(plus(omega, spin), alpha, a)

    def steadied(self, after: Motion) -> tuple[Motion, ca.SX]:
        """A motion after the move less what turns it faster about the axis, and the acceleration that does that."""
        alpha = list(after.alpha)
        turning, alpha[self.axis] = alpha[self.axis], ZERO
        return replace(after, alpha=alpha), neg(mul(self.sign, turning))

    def seen(self, vector: Vector) -> Vector:
        """A vector in the axes after the move."""
        return self._rotated(vector, neg(self.sine))

    def _rotated(self, vector: Vector, sine: ca.SX) -> Vector:
        i, j = (self.axis + 1) % 3, (self.axis + 2) % 3
        result = list(vector)
        result[i], result[j] = turned_back(vector[i], vector[j], self.cosine, sine)
        return result

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        return Wrench(self._rotated(after.f, self.sine), self._rotated(after.n, self.sine), after.world)

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        return after.about(self.axis, self.cosine, self.sine)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        if self.column is not None:
            path.spin(self.column, path.axes[self.axis], self.rate, self.sign)
        path.turn(self.axis, self.cosine, self.sine)


@dataclass(frozen=True)
class Slide(Plain):
    """A shift along coordinate axis `axis` by `amount`: factor times the coordinate of `column`, and a constant."""

    axis: int
    amount: ca.SX
    column: int | None = None
    rate: ca.SX = ZERO
    factor: ca.SX = ONE

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        return {} if self.column is None else {self.column: Twist(zeros(), unit(self.axis, self.factor))}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move."""
        a = before.carried(unit(self.axis, self.amount))
        if self.column is not None:
            speed = mul(mul(ca.SX(2), self.factor), rates.get(self.column, ZERO))
            a = plus(a, cross(before.omega, unit(self.axis, speed)))
            a[self.axis] = add(a[self.axis], mul(self.factor, accelerations.get(self.column, ZERO)))
        return Motion(before.omega, before.alpha, a)

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        return Wrench(after.f, plus(after.n, cross(unit(self.axis, self.amount), after.f)), after.world)

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        return after.shifted(unit(self.axis, self.amount))

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.shift(unit(self.axis, self.amount))
        if self.column is not None:
            path.slide(self.column, scaled(self.factor, path.axes[self.axis]), self.rate)


@dataclass(frozen=True)
class Fixed(Plain):
    """A constant shift r and then a constant rotation R, whose columns are the new axes."""

    R: Matrix
    r: Vector

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        return {}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move."""
        vectors = before.omega, before.alpha, before.carried(self.r)
        omega, alpha, a = (transposed_times(self.R, vector) for vector in vectors)
        return Motion(omega, alpha, a)

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        f = times(self.R, after.f)
        return Wrench(f, plus(times(self.R, after.n), cross(self.r, f)), after.world)

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        return after.turned(self.R).shifted(self.r)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.shift(self.r)
        path.turn_by(self.R)
