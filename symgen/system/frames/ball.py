"""Moves by which a body turns with its own absolute angular velocity: to world axes, then to those of the body.

A ball passes neither a moment towards the ground nor an angular motion away from it: omega and alpha beyond it are its
own velocities and their rates, and what is beyond is to all before it a mass at its centre.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import Vector, cross, plus, scaled, times, transposed_times, zeros
from symgen.system.frames.motion import Composite, Held, Lever, Matrix, Motion, Twist, Wrench, only_axis
from symgen.system.frames.moves import Plain, unit
from symgen.system.frames.paths import Path


@dataclass(frozen=True)
class ToWorld(Plain):
    """From the axes of a frame to those of the world; `axes` gives the frame's axes there (rows of a rotation)."""

    axes: Callable[[], Matrix]

    @cached_property
    def _P(self) -> Matrix:
        return self.axes()

    @property
    def twists(self) -> Mapping[int, Twist]:
        """None: the axes follow from what is before."""
        return {}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Of the origin alone: a ball follows."""
        return Motion(zeros(), zeros(), times(self._P, before.a))

    def wrench(self, after: Wrench) -> Wrench:
        """The force in the frame's axes; that in the world's goes with it."""
        return Wrench(transposed_times(self._P, after.f), zeros(), world=after.f)

    def composite(self, after: Composite) -> Composite:
        """A mass at the origin."""
        return after.turned_mass(lambda: [list(row) for row in zip(*self._P, strict=True)])

    def lead(self, path: Path) -> None:
        """The path ends in the world's axes when the ball is reached."""


@dataclass(frozen=True)
class Across(Plain):
    """From a body that a ball holds to a point of it at `arm`, in world axes; A: of the body, by rows.

    Accelerations and forces stay in world axes all along a chain of such bodies: only moments arm x A^T F of them are
    taken in body axes. A whole matrix lies between the axes of two such bodies, so that the world's cost least.
    """

    arm: Vector
    A: Matrix

    @property
    def twists(self) -> Mapping[int, Twist]:
        """None: the place follows from what is before."""
        return {}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Of the point alone: a ball follows."""
        held = before.held or Held(self.A, times(self.A, before.a), True)
        return Motion(zeros(), zeros(), plus(held.a, before.swung(held, self.arm)), held)

    def wrench(self, after: Wrench) -> Wrench:
        """The force at the body's origin, and its lever."""
        f = transposed_times(self.A, after.f)
        return Wrench(f, cross(self.arm, f), after.f, (Lever(self.arm, after.f),), zeros())

    def composite(self, after: Composite) -> Composite:
        """A mass at the point."""
        return after.turned_mass(lambda: [list(row) for row in zip(*self.A, strict=True)]).shifted(self.arm)

    def lead(self, path: Path) -> None:
        """Continue a path to the point."""
        path.shift(self.arm)


@dataclass(frozen=True)
class Ball(Plain):
    """From world axes to those of a body: A by rows, omega [rad/s] in body axes, its columns."""

    columns: list[int]
    A: Matrix
    omega: Vector

    @property
    def twists(self) -> Mapping[int, Twist]:
        """By column of q."""
        return {column: Twist(unit(i), zeros()) for i, column in enumerate(self.columns)}

    def motion(self, before: Motion, rates: Row, accelerations: Row) -> Motion:
        """Angular motion as it is, the origin's acceleration in body axes."""
        omega, alpha = ([source.get(c, ZERO) for c in self.columns] for source in (rates, accelerations))
        return Motion(omega, alpha, transposed_times(self.A, before.a), Held(self.A, before.a, before.held is not None))

    def powers(self, after: Wrench) -> Row:
        """The moment: A (e_i x arm) . F of each lever, of those along one axis e that of A^T sum(arm_k F) at e."""
        if not after.levers:
            return super().powers(after)
        assert after.rest is not None
        moment, levers = after.rest, [lever for lever in after.levers if any(not x.is_zero() for x in lever.arm)]
        along = only_axis([lever.arm for lever in levers])
        if along is not None and len(levers) > 1:
            F = plus(*(scaled(lever.arm[along], lever.F) for lever in levers))
            moment = plus(moment, cross(unit(along), transposed_times(self.A, F)))
        else:
            for lever in levers:
                speeds = [times(self.A, cross(unit(i), lever.arm)) for i in range(3)]
                moment = plus(moment, times(speeds, lever.F))
        return dict(zip(self.columns, moment, strict=True))

    def wrench(self, after: Wrench) -> Wrench:
        """The force alone, in world axes."""
        f = times(self.A, after.f) if after.world is None else after.world
        return Wrench(f, zeros())

    def composite(self, after: Composite) -> Composite:
        """The mass alone."""
        return after.turned_mass(lambda: self.A)

    def lead(self, path: Path) -> None:
        """Continue a path through the move."""
        path.ball(self.columns, self.A, self.omega)
