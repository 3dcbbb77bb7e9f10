"""The transforms that lead from a frame to the next one, and what each does to motions, wrenches, inertia and paths.

A transform may depend on coordinates: then it has twists, the motion of the frame after it for a unit rate of each.
What joints leave free, and constant displacements, are one node: X(q) and S.

Transforms that a body makes by its own coordinates: it floats, it is oriented, it bends at its markers.

Transforms by which a body turns with its own absolute angular velocity: to world axes, then to those of the body.

A ball passes neither a moment towards the ground nor an angular motion away from it: omega and alpha beyond it are its
own velocities and their rates, and what is beyond is to all before it a mass at its centre.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import ClassVar

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg
from symgen.algebra.vectors import (
    Matrix,
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
from symgen.bodies.spatial_moments import Deformation
from symgen.system.frames.paths import Path
from symgen.system.frames.spatial_algebra import (
    Force,
    FrameMotion,
    LeverArm,
    Mass,
    Motion,
    WorldFrame,
    only_axis,
    rotated_back,
    transposed,
)


@dataclass(frozen=True)
class TwistColumn:
    """A column of S: a twist of the frame after a transform, at its origin and in its axes.

    shares: of the rates of q in it, by column of q.
    """

    shares: Row
    twist: Motion


class JointTransform(ABC):
    """The transform of a joint, from one frame to the next; S, its motion subspace, is made of `twist_columns`.

    What is not said is that of a transform without coordinates. Names as in R. Featherstone: Rigid Body Dynamics
    Algorithms, Springer 2008, sections 2.8 (Plucker transforms) and 4.4 (joint models).
    """

    @property
    def twist_columns(self) -> list[TwistColumn]:
        """S: twists that rates of columns of q make, each alone or several by their shares."""
        return []

    @property
    def twists(self) -> dict[int, Motion]:
        """S by column of q."""
        found: dict[int, Motion] = {}
        for part in self.twist_columns:
            for column, share in part.shares.items():
                own = part.twist.scaled(share)
                found[column] = found[column].plus(own) if column in found else own
        return found

    def column_powers(self, after: Force) -> Vector:
        """Power of a wrench of the frame after the transform on each twist column."""
        return [after.along(part.twist) for part in self.twist_columns]

    def powers(self, after: Force) -> Row:
        """Power of a wrench of the frame after the transform on the twist of each column: S^T f."""
        found: Row = {}
        for part, value in zip(self.twist_columns, self.column_powers(after), strict=True):
            for column, share in part.shares.items():
                found[column] = add(found[column], mul(share, value)) if column in found else mul(share, value)
        return found

    @abstractmethod
    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Motion after the transform; rates and accelerations by column, zero where absent."""

    @abstractmethod
    def wrench(self, after: Force) -> Force:
        """A wrench of the frame after the transform, seen before it."""

    @abstractmethod
    def composite(self, after: Mass) -> Mass:
        """Inertia of the frame after the transform, seen before it."""

    def lead(self, path: Path) -> None:  # noqa: B027 - nothing for axes of the world, which a ball follows
        """Continue a path through the transform."""


def single(columns: Sequence[int], twists: Sequence[Motion]) -> list[TwistColumn]:
    """Twists of one column each."""
    return [TwistColumn({column: ONE}, twist) for column, twist in zip(columns, twists, strict=True)]


def unit(axis: int, value: ca.SX = ONE) -> Vector:
    """value times a unit vector."""
    result = zeros()
    result[axis] = value
    return result


@dataclass(frozen=True)
class JointNode(JointTransform):
    """X: a shift r, then a rotation, about coordinate axis `axis` by (cosine, sine) or constant with the new axes in R.

    S: where it has a coordinate, that of `column`, the frame after it turns about its axis `axis` by `sign` for a unit
    rate if the rotation is about that axis, and else slides along it.
    """

    axis: int = 2
    about: tuple[ca.SX, ca.SX] | None = None
    R: Matrix | None = None
    r: Vector = field(default_factory=zeros)
    column: int | None = None
    rate: ca.SX = ZERO
    sign: ca.SX = ONE
    back: ClassVar[bool] = False

    @staticmethod
    def slide(
        axis: int, amount: ca.SX, column: int | None = None, rate: ca.SX = ZERO, factor: ca.SX = ONE
    ) -> JointNode:
        """Along a coordinate axis; amount: factor times the coordinate of `column`, and a constant."""
        return JointNode(axis, r=unit(axis, amount), column=column, rate=rate, sign=factor)

    @property
    def turns(self) -> bool:
        """Is its rotation one about a coordinate axis?"""
        return self.about is not None

    @property
    def S(self) -> Motion:
        """Motion for a unit rate, the same before and after the rotation."""
        own = unit(self.axis, self.sign)
        return Motion(own, zeros()) if self.turns else Motion(zeros(), own)

    @property
    def twist_columns(self) -> list[TwistColumn]:
        """S, where it has a coordinate."""
        return [] if self.column is None else [TwistColumn({self.column: ONE}, self.S)]

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Motion after the transform."""
        omega, alpha, a = (
            self.transformed(before.omega),
            self.transformed(before.alpha),
            self.transformed(self._carried(before)),
        )
        if self.column is None:
            return FrameMotion(omega, alpha, a)
        speed, own = mul(self.sign, rates.get(self.column, ZERO)), mul(self.sign, accelerations.get(self.column, ZERO))
        if self.turns:
            spin = unit(self.axis, speed)
            alpha = plus(alpha, cross(omega, spin), unit(self.axis, own))
            return FrameMotion(plus(omega, spin), alpha, a)
        twice = unit(self.axis, mul(ca.SX(2), speed))
        return FrameMotion(omega, alpha, plus(a, cross(omega, twice), unit(self.axis, own)))

    def _carried(self, before: FrameMotion) -> Vector:
        return before.a if all(value.is_zero() for value in self.r) else before.carried(self.r)

    def transformed(self, vector: Vector) -> Vector:
        """A vector in the axes after the transform."""
        if self.about is None:
            return vector if self.R is None else transposed_times(self.R, vector)
        return rotated_about(vector, self.axis, self.about[0], neg(self.about[1]))

    def _back(self, vector: Vector) -> Vector:
        if self.about is None:
            return vector if self.R is None else times(self.R, vector)
        return rotated_about(vector, self.axis, *self.about)

    def wrench(self, after: Force) -> Force:
        """Seen before the transform."""
        f = self._back(after.f)
        return Force(f, plus(self._back(after.n), cross(self.r, f)), after.world)

    def composite(self, after: Mass) -> Mass:
        """Seen before the transform."""
        if self.about is not None:
            after = after.about(self.axis, *self.about)
        elif self.R is not None:
            after = after.rotated(self.R)
        return after if all(value.is_zero() for value in self.r) else after.shifted(self.r)

    def lead(self, path: Path) -> None:
        """Continue a path through the transform."""
        path.shift(self.r)
        if self.column is not None and self.turns:
            path.spin(self.column, path.axes[self.axis], self.rate, self.sign)
        elif self.column is not None:
            path.slide(self.column, scaled(self.sign, path.axes[self.axis]), self.rate)
        if self.about is not None:
            path.turn(self.axis, *self.about)
        elif self.R is not None:
            path.turn_by(self.R)


def rotated_about(vector: Vector, axis: int, cosine: ca.SX, sine: ca.SX) -> Vector:
    """A vector in the axes from which a frame is turned about one of them, from those in the frame."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = list(vector)
    result[i], result[j] = rotated_back(vector[i], vector[j], cosine, sine)
    return result


@dataclass(frozen=True)
class Float(JointTransform):
    """The origin R_o of a body that no joint places, in world axes."""

    columns: list[int]
    R_o: Vector
    R_o_dot: Vector

    @property
    def twist_columns(self) -> list[TwistColumn]:
        """The directions of the world."""
        return single(self.columns, [Motion(zeros(), unit(i)) for i in range(3)])

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Without the acceleration of the origin: its force on any coordinate is an entry of M times it."""
        return FrameMotion(zeros(), zeros(), zeros())

    def wrench(self, after: Force) -> Force:
        """Seen before the transform."""
        return after

    def composite(self, after: Mass) -> Mass:
        """Seen before the transform."""
        return after

    def lead(self, path: Path) -> None:
        """Continue a path through the transform."""
        path.shift(self.R_o)
        for i, column in enumerate(self.columns):
            path.slide(column, unit(i), self.R_o_dot[i])


@dataclass(frozen=True)
class MarkerNode(JointTransform):
    """From the frame of a flexible body to a marker that its modes shift and turn (Eq. 19), or `back` from there."""

    deformation: Deformation
    back: bool = False

    @property
    def twist_columns(self) -> list[TwistColumn]:
        """By what modes do to the marker; with the marker at rest, the frame moves against that."""
        deformed, found = self.deformation.still, []
        for one in self.deformation.shared:
            spin = one.spin(deformed)
            if self.back:
                twist = Motion(negative(spin), minus(cross(spin, deformed.rho), one.shape))
            else:
                twist = Motion(transposed_times(deformed.R, spin), transposed_times(deformed.R, one.shape))
            found.append(TwistColumn(one.shares, twist))
        return found

    def column_powers(self, after: Force) -> Vector:
        """Power of a wrench on each twist column."""
        f, moment = self.at_marker(after)
        rotation = self.deformation.still.on_turns(moment)
        found = [add(dot(one.shape, f), dot(one.theta, rotation)) for one in self.deformation.shared]
        return negative(found) if self.back else found

    def at_marker(self, after: Force) -> tuple[Vector, Vector]:
        """Force and moment about the marker of a wrench of the frame after the transform, in body axes."""
        deformed = self.deformation.still
        if self.back:
            return after.f, minus(after.n, cross(deformed.rho, after.f))
        return times(deformed.R, after.f), times(deformed.R, after.n)

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Motion after the transform."""
        deformed, own = self.deformation.at(rates), self.deformation.of(accelerations)
        given = before.omega, before.alpha, before.a
        omega, alpha, a = [times(deformed.R, vector) for vector in given] if self.back else given
        body = minus(omega, deformed.omega) if self.back else omega
        rotation = plus(combination(deformed.spins, own), deformed.fading, cross(body, deformed.omega))
        moving = plus(deformed.drift(body), combination(deformed.shapes, own))
        if self.back:
            alpha = minus(alpha, rotation)
            return FrameMotion(
                body, alpha, minus(a, plus(FrameMotion(body, alpha, zeros()).carried(deformed.rho), moving))
            )
        marker = plus(omega, deformed.omega), plus(alpha, rotation), plus(before.carried(deformed.rho), moving)
        omega, alpha, a = (transposed_times(deformed.R, vector) for vector in marker)
        return FrameMotion(omega, alpha, a)

    def transformed(self, vector: Vector) -> Vector:
        """A vector in the axes after the transform."""
        R = self.deformation.still.R
        return times(R, vector) if self.back else transposed_times(R, vector)

    def wrench(self, after: Force) -> Force:
        """Seen before the transform."""
        deformed, (f, n) = self.deformation.still, self.at_marker(after)
        if self.back:
            return Force(transposed_times(deformed.R, f), transposed_times(deformed.R, n))
        return Force(f, plus(n, cross(deformed.rho, f)))

    def composite(self, after: Mass) -> Mass:
        """Seen before the transform."""
        deformed = self.deformation.still
        if self.back:
            return after.shifted(negative(deformed.rho)).rotated(transposed(deformed.R))
        return after.rotated(deformed.R).shifted(deformed.rho)

    def lead(self, path: Path) -> None:
        """Continue a path through the transform."""
        path.bend(self.deformation.columns, self.deformation.now, self.back)


Node = JointNode | MarkerNode  # what leads through a tree whose rotations are all coordinates


@dataclass(frozen=True)
class ToWorld(JointTransform):
    """From the axes of a frame to those of the world; `axes` gives the frame's axes there (rows of a rotation)."""

    axes: Callable[[], Matrix]

    @cached_property
    def _P(self) -> Matrix:
        return self.axes()

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Of the origin alone: a ball follows."""
        return FrameMotion(zeros(), zeros(), times(self._P, before.a))

    def wrench(self, after: Force) -> Force:
        """The force in the frame's axes; that in the world's goes with it."""
        return Force(transposed_times(self._P, after.f), zeros(), world=after.f)

    def composite(self, after: Mass) -> Mass:
        """A mass at the origin."""
        return after.rotated_mass(lambda: [list(row) for row in zip(*self._P, strict=True)])


@dataclass(frozen=True)
class Across(JointTransform):
    """From a body that a ball holds to a point of it at `arm`, in world axes; A: of the body, by rows.

    Accelerations and forces stay in world axes all along a chain of such bodies: only moments arm x A^T F of them are
    taken in body axes. A whole matrix lies between the axes of two such bodies, so that the world's cost least.
    """

    arm: Vector
    A: Matrix

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Of the point alone: a ball follows."""
        in_world = before.in_world or WorldFrame(self.A, times(self.A, before.a), True)
        return FrameMotion(zeros(), zeros(), plus(in_world.a, before.swung(in_world, self.arm)), in_world)

    def wrench(self, after: Force) -> Force:
        """The force at the body's origin, and its lever arm."""
        f = transposed_times(self.A, after.f)
        return Force(f, cross(self.arm, f), after.f, (LeverArm(self.arm, after.f),), zeros())

    def composite(self, after: Mass) -> Mass:
        """A mass at the point."""
        return after.rotated_mass(lambda: [list(row) for row in zip(*self.A, strict=True)]).shifted(self.arm)

    def lead(self, path: Path) -> None:
        """Continue a path to the point."""
        path.shift(self.arm)


@dataclass(frozen=True)
class Ball(JointTransform):
    """From world axes to those of a body: A by rows, omega [rad/s] in body axes, its columns."""

    columns: list[int]
    A: Matrix
    omega: Vector

    @property
    def twist_columns(self) -> list[TwistColumn]:
        """Its axes."""
        return single(self.columns, [Motion(unit(i), zeros()) for i in range(3)])

    def motion(self, before: FrameMotion, rates: Row, accelerations: Row) -> FrameMotion:
        """Angular motion as it is, the origin's acceleration in body axes."""
        omega, alpha = ([source.get(c, ZERO) for c in self.columns] for source in (rates, accelerations))
        return FrameMotion(
            omega, alpha, transposed_times(self.A, before.a), WorldFrame(self.A, before.a, before.in_world is not None)
        )

    def column_powers(self, after: Force) -> Vector:
        """The moment: A (e_i x arm) . F of each lever arm, of those along one axis e that of A^T sum(arm_k F) at e."""
        if not after.lever_arms:
            return super().column_powers(after)
        assert after.rest is not None
        moment, lever_arms = after.rest, [one for one in after.lever_arms if any(not x.is_zero() for x in one.arm)]
        along = only_axis([one.arm for one in lever_arms])
        if along is not None and len(lever_arms) > 1:
            F = plus(*(scaled(one.arm[along], one.F) for one in lever_arms))
            moment = plus(moment, cross(unit(along), transposed_times(self.A, F)))
        else:
            for one in lever_arms:
                speeds = [times(self.A, cross(unit(i), one.arm)) for i in range(3)]
                moment = plus(moment, times(speeds, one.F))
        return moment

    def wrench(self, after: Force) -> Force:
        """The force alone, in world axes."""
        f = times(self.A, after.f) if after.world is None else after.world
        return Force(f, zeros())

    def composite(self, after: Mass) -> Mass:
        """The mass alone."""
        return after.rotated_mass(lambda: self.A)

    def lead(self, path: Path) -> None:
        """Continue a path through the transform."""
        path.ball(self.columns, self.A, self.omega)
