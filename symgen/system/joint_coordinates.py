"""The coordinates of a joint that places a body: X(q), the motion subspace S(q) and its rate, from its motions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, dot, mul, neg
from symgen.algebra.vectors import Vector, cross, identity, minus, plus, scaled, zeros
from symgen.bodies.spatial_body import SpatialMarker
from symgen.joints.joint import Slide, Turn


@dataclass(frozen=True)
class JointCoordinate:
    """A coordinate of a joint: value, rate and column in q."""

    value: ca.SX
    rate: ca.SX
    column: int


@dataclass(frozen=True)
class Travel:
    """How far a joint has moved along the axes of marker a: values, rates, rows over q, and what rows and rates leave
    of the acceleration."""

    value: Vector = field(default_factory=zeros)
    rate: Vector = field(default_factory=zeros)
    rows: list[Row] = field(default_factory=lambda: [{}, {}, {}])
    bias: Vector = field(default_factory=zeros)


@dataclass(frozen=True)
class JointCoordinates:
    """The motions of a joint, each with its coordinate and the travel along its axis for a unit of a turn (lead)."""

    motions: Sequence[Turn | Slide]
    coordinates: Sequence[JointCoordinate]
    leads: Sequence[ca.SX]

    def place(self, name: str) -> int:
        """Place of a coordinate by its name within the joint."""
        return next(k for k, motion in enumerate(self.motions) if motion.name == name)

    @property
    def subspace(self) -> list[tuple[Vector, Vector]]:
        """S(q) by coordinate: (angular velocity of b, velocity of point b) for a unit rate, both in marker a's axes."""
        R = identity()
        found: list[tuple[Vector, Vector]] = []
        for motion, own, lead in zip(self.motions, self.coordinates, self.leads, strict=True):
            axis = [row[motion.axis] for row in R]
            along = own.value if isinstance(motion, Slide) else mul(lead, own.value)
            way = scaled(along, axis)
            found = [(omega, plus(v, cross(omega, way))) for omega, v in found]
            found.append((axis, scaled(lead, axis)) if isinstance(motion, Turn) else (zeros(), axis))
            if isinstance(motion, Turn):
                R = _turned(R, motion.axis, own.value)
        return found

    def travel(self) -> Travel:
        """Of point b: the translation of X(q), with S(q) as its rows."""
        value, R = zeros(), identity()
        for motion, own, lead in zip(self.motions, self.coordinates, self.leads, strict=True):
            along = own.value if isinstance(motion, Slide) else mul(lead, own.value)
            value = plus(value, scaled(along, [row[motion.axis] for row in R]))
            if isinstance(motion, Turn):
                R = _turned(R, motion.axis, own.value)
        rows: list[Row] = [{}, {}, {}]
        rate = zeros()
        for own, (_, v) in zip(self.coordinates, self.subspace, strict=True):
            for axis in range(3):
                if not v[axis].is_zero():
                    rows[axis][own.column] = v[axis]
                    rate[axis] = add(rate[axis], mul(v[axis], own.rate))
        return Travel(value, rate, rows, self._changes(rate))

    def free_axes(self, a: SpatialMarker, b: SpatialMarker) -> tuple[list[Vector], list[Vector]]:
        """Directions in the world along which the joint passes on no force, and about which no moment (for virtual
        work, at right angles to each other); none for a screw, whose axis carries both."""
        S = self.subspace
        sliding = [k for k, motion in enumerate(self.motions) if isinstance(motion, Slide)]
        turning = [k for k, motion in enumerate(self.motions) if isinstance(motion, Turn) and not motion.lead]
        slides = [in_world(a, S[k][1]) for k in sliding]
        turns = [in_world(a, S[k][0]) for k in turning[:-1]]
        turns += [(b if turns else a).axes[self.motions[k].axis] for k in turning[-1:]]
        return _apart(slides, [S[k][1] for k in sliding]), _apart(turns, [S[k][0] for k in turning])

    def _changes(self, rate: Vector) -> Vector:
        """Derivatives in time at constant rates."""
        if not self.coordinates:
            return zeros()
        values, rates = (ca.vertcat(*(getattr(own, key) for own in self.coordinates)) for key in ("value", "rate"))
        changes = [ca.jtimes(part, values, rates) for part in rate]
        return [ZERO if change.is_zero() else change for change in changes]


def _turned(R: list[Vector], axis: int, angle: ca.SX) -> list[Vector]:
    """R times a turn about one of its axes."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    c, s = ca.cos(angle), ca.sin(angle)
    found = [list(row) for row in R]
    for row in found:
        row[i], row[j] = add(mul(c, row[i]), mul(s, row[j])), add(neg(mul(s, row[i])), mul(c, row[j]))
    return found


def in_world(a: SpatialMarker, direction: Vector) -> Vector:
    """A direction given in the axes of marker a."""
    return plus(*(scaled(share, axis) for share, axis in zip(direction, a.axes, strict=True)))


def _apart(axes: list[Vector], seen: list[Vector]) -> list[Vector]:
    """What two or three directions span, at right angles to each other; seen: the same in the axes of marker a."""
    if len(axes) == 3:
        return identity()
    if len(axes) < 2 or (along := dot(*seen)).is_zero():
        return axes
    if along.is_one():
        return axes[:1]
    across = minus(axes[1], scaled(dot(*axes), axes[0]))
    return [axes[0], scaled(1 / ca.sqrt(dot(across, across)), across)]
