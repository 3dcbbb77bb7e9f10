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
from symgen.algebra.vectors import Vector, times, transposed_times, zeros
from symgen.system.frames.motion import Composite, Matrix, Motion, Twist, Wrench
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
        return Motion(omega, alpha, transposed_times(self.A, before.a))

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
