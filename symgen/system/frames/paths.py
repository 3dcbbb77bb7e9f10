"""Ways along frames in the axes of the frame where they begin: where a point is, how it moves, what moves it.

A path begins at a frame that is taken to be at rest: the ground, or the last frame that two bodies have in common.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, replace

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ONE, ZERO, neg
from symgen.algebra.vectors import Matrix, Vector, combination, cross, plus, scaled, zeros
from symgen.bodies.spatial_body import SpatialMarker, fixed_quaternion
from symgen.bodies.spatial_moments import DeformedMarker


@dataclass(frozen=True)
class PathColumn:
    """What a unit rate of a coordinate does to all that follows: it turns about an axis, or it slides.

    before: how many arms of the path come before it.
    until: how many arms come before the ball beyond which it turns nothing; None: there is none.
    turning: what rates of the components of psi turn and the share of each, where that is less than what modes do.
    """

    column: int
    turns: Vector | None
    slides: Vector | None
    before: int
    until: int | None = None
    rotation: tuple[list[Vector], Vector] | None = None


class Path:
    """The way so far: axes (columns), angular velocity, and what is left of its rates without second derivatives."""

    def __init__(self) -> None:
        self.axes = [[ONE if i == j else ZERO for i in range(3)] for j in range(3)]
        self.omega, self.alpha = zeros(), zeros()
        self.r_dot, self.a = zeros(), zeros()
        self.entries: list[PathColumn] = []
        self._arms: list[Vector] = []
        self._reached = 0  # arms whose end has been given its velocity

    def branch(self) -> Path:
        """A copy that goes on by itself."""
        other = copy(self)
        other.entries, other._arms = list(self.entries), list(self._arms)
        return other

    def along(self, vector: Vector) -> Vector:
        """A vector in the axes reached, in those of the beginning."""
        return plus(*(scaled(value, axis) for value, axis in zip(vector, self.axes, strict=True)))

    # ---- the transforms -------------------------------------------------------------------------------------------

    def shift(self, arm: Vector) -> None:
        """Along an arm in the axes reached."""
        for value, axis in zip(arm, self.axes, strict=True):
            if not value.is_zero():
                self._arms.append(scaled(value, axis))

    def turn(self, axis: int, cosine: ca.SX, sine: ca.SX) -> None:
        """Turn the axes about one of them."""
        i, j = (axis + 1) % 3, (axis + 2) % 3
        first, second = self.axes[i], self.axes[j]
        self.axes = list(self.axes)
        self.axes[i] = plus(scaled(cosine, first), scaled(sine, second))
        self.axes[j] = plus(scaled(neg(sine), first), scaled(cosine, second))

    def turn_by(self, R: Matrix) -> None:
        """Turn the axes by a rotation, whose columns are the new axes."""
        self.axes = [self.along([row[j] for row in R]) for j in range(3)]

    def spin(self, column: int, axis: Vector, rate: ca.SX, sign: ca.SX) -> None:
        """What follows turns about an axis."""
        self._reach()
        turns = scaled(sign, axis)
        spin = scaled(rate, turns)
        self.entries.append(PathColumn(column, turns, None, len(self._arms)))
        self.alpha = plus(self.alpha, cross(self.omega, spin))
        self.omega = plus(self.omega, spin)

    def slide(self, column: int, axis: Vector, rate: ca.SX) -> None:
        """What follows slides along an axis that turns with the frame."""
        speed = scaled(rate, axis)
        self.entries.append(PathColumn(column, None, axis, len(self._arms)))
        self.r_dot = plus(self.r_dot, speed)
        self.a = plus(self.a, scaled(ca.SX(2), cross(self.omega, speed)))

    def ball(self, columns: list[int], A: Matrix, omega: Vector) -> None:
        """What follows has the absolute orientation A (rows) and the angular velocity omega in body axes."""
        self._reach()
        end = len(self._arms)
        self.entries = [one if one.until is not None else replace(one, until=end) for one in self.entries]
        self.axes = [[row[j] for row in A] for j in range(3)]
        for column, axis in zip(columns, self.axes, strict=True):
            self.entries.append(PathColumn(column, axis, None, end))
        self.omega, self.alpha = self.along(omega), zeros()

    def bend(self, columns: list[int], deformed: DeformedMarker, back: bool) -> None:
        """To a marker of a flexible body, or `back` from there to the body's frame."""
        sign = neg(ONE) if back else ONE
        if back:
            self.turn_by([list(column) for column in zip(*deformed.R, strict=True)])
        else:
            self.shift(deformed.rho)
        self._reach()
        own, speed = scaled(sign, self.along(deformed.omega)), self.along(deformed.rho_dot)
        omega = plus(self.omega, own)
        body = omega if back else self.omega
        drift = plus(scaled(ca.SX(2), cross(body, speed)), self.along(deformed.nu))
        self.alpha = plus(self.alpha, cross(body, own), scaled(sign, self.along(deformed.fading)))
        self.a, self.r_dot = plus(self.a, scaled(sign, drift)), plus(self.r_dot, scaled(sign, speed))
        self.omega = omega
        self._add_modes(columns, deformed, back)
        if back:
            self.shift(scaled(sign, deformed.rho))
        else:
            self.turn_by(deformed.R)

    def _add_modes(self, columns: list[int], deformed: DeformedMarker, back: bool) -> None:
        sign, rotation = neg(ONE) if back else ONE, None
        if deformed.common_axes:
            rotation = [scaled(sign, self.along(axis)) for axis in deformed.psi_spins]
        for a, column in enumerate(columns):
            slides, shared = scaled(sign, self.along(deformed.shapes[a])), None
            if rotation is None:
                turns = scaled(sign, self.along(deformed.spins[a]))
            else:
                shared = rotation, deformed.point.turns[a]
                turns = combination(*shared)
            self.entries.append(PathColumn(column, turns, slides, len(self._arms), rotation=shared))

    def _reach(self) -> None:
        """The arm so far is done: what turns from here on does not move its end."""
        if self._reached == len(self._arms):
            return
        arm = plus(*self._arms[self._reached :])
        speed = cross(self.omega, arm)
        self.r_dot = plus(self.r_dot, speed)
        self.a = plus(self.a, cross(self.alpha, arm), cross(self.omega, speed))
        self._reached = len(self._arms)

    # ---- its end ---------------------------------------------------------------------------------------------

    def end(self) -> SpatialMarker:
        """The motion of the point and the axes that are reached."""
        self._reach()
        to_end = self._to_end()
        moved: list[Row] = [{}, {}, {}]
        turned: list[Row] = [{}, {}, {}]
        for entry in self.entries:
            for i, value in enumerate(self._moved(entry, to_end)):
                add_to(moved[i], entry.column, value)
            for i, value in enumerate(entry.turns or () if entry.until is None else ()):
                add_to(turned[i], entry.column, value)
        none = fixed_quaternion([ONE, ZERO, ZERO, ZERO])
        return SpatialMarker(to_end[0], self.r_dot, self.a, moved, self.axes, self.omega, turned, self.alpha, none)

    def _to_end(self) -> list[Vector]:
        """From the end of each arm, and before them from the beginning, to the end of the path."""
        found = [zeros()]
        for arm in reversed(self._arms):
            found.append(plus(arm, found[-1]))
        return found[::-1]

    def _moved(self, entry: PathColumn, to_end: list[Vector]) -> Vector:
        """The velocity of the end for a unit rate of its coordinate."""
        parts = []
        if entry.turns is not None:
            across = self._across(entry, to_end)
            if entry.rotation is None:
                parts.append(cross(entry.turns, across))
            else:
                axes, share = entry.rotation
                parts.append(combination([cross(axis, across) for axis in axes], share))
        return plus(*parts, *([] if entry.slides is None else [entry.slides]))

    def _across(self, entry: PathColumn, to_end: list[Vector]) -> Vector:
        """From its axis to the end of what it turns."""
        return to_end[entry.before] if entry.until is None else plus(zeros(), *self._arms[entry.before : entry.until])

    def point(self, R: Matrix, r: Vector) -> SpatialMarker:
        """Of a marker fixed in the frame reached, by its place and axes there."""
        own = self.branch()
        own.shift(r)
        own.turn_by(R)
        return own.end()
