"""Moves that a body makes by its own coordinates: it floats, it is oriented, it bends at its markers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, dot, neg
from symgen.algebra.vectors import Vector, combination, cross, minus, plus, scaled, times, transposed_times, zeros
from symgen.bodies.deformation import Deformation
from symgen.bodies.spatial_orientation import Orientation, orientation
from symgen.system.frames.motion import Composite, Motion, Twist, Wrench, no_masses
from symgen.system.frames.moves import Plain, unit
from symgen.system.frames.paths import Path


@dataclass(frozen=True)
class Float(Plain):
    """The origin R_o of a body that no joint places, in world axes."""

    columns: list[int]
    R_o: Vector
    R_o_dot: Vector

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        return {column: Twist(zeros(), unit(i)) for i, column in enumerate(self.columns)}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Without the acceleration of the origin: its force on any coordinate is an entry of M times it."""
        return Motion(zeros(), zeros(), zeros())

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        return after

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        return after

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.shift(self.R_o)
        for i, column in enumerate(self.columns):
            path.slide(column, unit(i), self.R_o_dot[i])


@dataclass(frozen=True)
class Orient(Plain):
    """The orientation of such a body by Euler parameters theta that are coordinates like others."""

    columns: list[int]
    theta: Vector
    theta_dot: Vector

    def at(self, rates: Vector) -> Orientation:
        """The orientation with these rates of theta."""
        return orientation(self.theta, rates)

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        axes = self.at(self.theta_dot).body_axes
        return {column: Twist(axes[k], zeros()) for k, column in enumerate(self.columns)}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """From the frame at the origin, which neither turns nor, for `Float`, accelerates."""
        turning = self.at([rates.get(column, ZERO) for column in self.columns])
        own = combination(turning.body_axes, [accelerations.get(column, ZERO) for column in self.columns])
        return Motion(turning.omega_body, plus(turning.bias_body, own), before.a)

    def wrench(self, after: Wrench) -> Wrench:
        """Nothing before this move turns, so that no moment does work there."""
        return Wrench(self.at(self.theta_dot).rotate(after.f), zeros())

    def momentum(self, column: int, after: Wrench, composite: Composite) -> Wrench:
        """d(A h)/dtheta."""
        turning = self.at(self.theta_dot)
        return Wrench(turning.turned(self.columns.index(column), turning.rotate(composite.h)), zeros())

    def composite(self, after: Composite) -> Composite:
        """Nothing before this move turns: the mass alone counts."""
        return Composite(after.m, zeros(), no_masses().Sigma)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        turning = self.at(self.theta_dot)
        path.orient(self.columns, turning)


@dataclass(frozen=True)
class Shared:
    """A twist of the frame after a move of which the rates of several modes have shares, by column."""

    shares: Row
    twist: Twist


@dataclass(frozen=True)
class Bend(Plain):
    """From the frame of a flexible body to a marker that its deformation shifts and turns (Eq. 19)."""

    deformation: Deformation

    @property
    def shared(self) -> list[Shared]:
        """By the axes along and about which modes move the marker, where these are fewer; empty otherwise."""
        bent = self.deformation.at({})
        return [
            Shared(one.shares, Twist(transposed_times(bent.R, one.turned(bent)), transposed_times(bent.R, one.shape)))
            for one in self.deformation.shared
        ]

    def shared_powers(self, after: Wrench) -> Vector:
        """Power of a wrench on these twists."""
        bent = self.deformation.at({})
        f, turning = times(bent.R, after.f), bent.on_turns(times(bent.R, after.n))
        return [add(dot(one.shape, f), dot(one.theta, turning)) for one in self.deformation.shared]

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        bent = self.deformation.at({})
        return {
            column: Twist(transposed_times(bent.R, bent.turned[a]), transposed_times(bent.R, bent.shapes[a]))
            for a, column in enumerate(self.deformation.columns)
        }

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move."""
        bent, own = self.deformation.at(rates), self.deformation.of(accelerations)
        omega = plus(before.omega, bent.omega)
        alpha = plus(before.alpha, combination(bent.turned, own), bent.fading, cross(before.omega, bent.omega))
        a = plus(before.carried(bent.rho), bent.drift(before.omega), combination(bent.shapes, own))
        omega, alpha, a = (transposed_times(bent.R, vector) for vector in (omega, alpha, a))
        return Motion(omega, alpha, a)

    def powers(self, after: Wrench) -> Row:
        """Power of a wrench on the twist of each column."""
        bent = self.deformation.at({})
        f, turning = times(bent.R, after.f), bent.on_turns(times(bent.R, after.n))
        turns = self.deformation.point.turns
        return {
            column: add(dot(bent.shapes[a], f), dot(turns[a], turning))
            for a, column in enumerate(self.deformation.columns)
        }

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        bent = self.deformation.at({})
        f = times(bent.R, after.f)
        return Wrench(f, plus(times(bent.R, after.n), cross(bent.rho, f)))

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        bent = self.deformation.at({})
        return after.turned(bent.R).shifted(bent.rho)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.bend(self.deformation.columns, self.deformation.now)


@dataclass(frozen=True)
class Unbend(Plain):
    """From such a marker to the frame of its body."""

    deformation: Deformation

    @property
    def shared(self) -> list[Shared]:
        """By the axes along and about which modes move the marker, where these are fewer; empty otherwise."""
        bent, found = self.deformation.at({}), []
        for one in self.deformation.shared:
            turned = one.turned(bent)
            twist = Twist(scaled(neg(ONE), turned), minus(cross(turned, bent.rho), one.shape))
            found.append(Shared(one.shares, twist))
        return found

    def shared_powers(self, after: Wrench) -> Vector:
        """Power of a wrench on these twists."""
        bent = self.deformation.at({})
        turning = bent.on_turns(minus(after.n, cross(bent.rho, after.f)))
        return [neg(add(dot(one.shape, after.f), dot(one.theta, turning))) for one in self.deformation.shared]

    @property
    def twists(self) -> Mapping[int, Twist]:
        """With the marker held, the frame moves against the marker's motion in it."""
        bent, result = self.deformation.at({}), {}
        for a, column in enumerate(self.deformation.columns):
            back = scaled(neg(ONE), bent.turned[a])
            result[column] = Twist(back, minus(cross(bent.turned[a], bent.rho), bent.shapes[a]))
        return result

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Motion after the move."""
        bent, own = self.deformation.at(rates), self.deformation.of(accelerations)
        omega, alpha, a = (times(bent.R, vector) for vector in (before.omega, before.alpha, before.a))
        omega = minus(omega, bent.omega)
        alpha = minus(alpha, plus(combination(bent.turned, own), bent.fading, cross(omega, bent.omega)))
        turning = Motion(omega, alpha, zeros())
        relative = plus(turning.carried(bent.rho), bent.drift(omega), combination(bent.shapes, own))
        return Motion(omega, alpha, minus(a, relative))

    def powers(self, after: Wrench) -> Row:
        """Power of a wrench on the twist of each column."""
        bent = self.deformation.at({})
        turning = bent.on_turns(minus(after.n, cross(bent.rho, after.f)))
        turns = self.deformation.point.turns
        return {
            column: neg(add(dot(bent.shapes[a], after.f), dot(turns[a], turning)))
            for a, column in enumerate(self.deformation.columns)
        }

    def wrench(self, after: Wrench) -> Wrench:
        """Seen before the move."""
        bent = self.deformation.at({})
        moment = minus(after.n, cross(bent.rho, after.f))
        return Wrench(transposed_times(bent.R, after.f), transposed_times(bent.R, moment))

    def composite(self, after: Composite) -> Composite:
        """Seen before the move."""
        bent = self.deformation.at({})
        back = [list(column) for column in zip(*bent.R, strict=True)]
        return after.shifted(scaled(neg(ONE), bent.rho)).turned(back)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.unbend(self.deformation.columns, self.deformation.now)
