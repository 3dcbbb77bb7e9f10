"""What loads are written in (`symgen.loads.load.Acting`), in the plane and in space: markers and quantities as SX."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row, add_scaled, nonzero
from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, combination, minus, negative, plus, scaled, zeros
from symgen.bodies.beam_places import moving_place, stations
from symgen.bodies.planar_body import MarkerMotion
from symgen.bodies.spatial_body import SpatialMarker
from symgen.bodies.spatial_integrals import three
from symgen.joints.joint import Joint, Slide, Turn
from symgen.loads import Load
from symgen.loads.load import Scalar
from symgen.scene import BeamBody
from symgen.system.one_sided import Push, hunt_crossley
from symgen.system.structure import ExpressionReader, Read

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

MET_POINTS = 1e-24  # m2: points nearer than that have met


@dataclass(frozen=True)
class SpringForce:
    """Force on point b and what pulls the points together [N], stored energy [J], dissipated power [W]."""

    force: list[ca.SX]
    pull: ca.SX
    potential: ca.SX
    dissipated: ca.SX


def spring_between(d: Vector, d_dot: Vector, stiffness: ca.SX, damping: ca.SX, free_length: ca.SX) -> SpringForce:
    """Between points a distance vector d apart: -k (1 - l_0/l) d - c l' d/l on b, with l = |d|.

    A spring of zero free length needs no square root, and its points may meet: l' d/l, the part of d' along d, has the
    limit d' there.
    """
    squared, along = dot(d, d), dot(d, d_dot)
    length, rate = distance_between(d, d_dot)
    pull = add(mul(stiffness, sub(length, free_length)), mul(damping, rate))
    if free_length.is_zero():
        spring, stored = stiffness, div(mul(stiffness, squared), ca.SX(2))
        if not damping.is_zero():
            share = div(along, ca.fmax(squared, MET_POINTS))
            force = [
                ca.if_else(squared < MET_POINTS, mul(damping, rate), mul(damping, mul(share, part)))
                for part, rate in zip(d, d_dot, strict=True)
            ]
            lost = mul(damping, ca.if_else(squared < MET_POINTS, dot(d_dot, d_dot), mul(share, along)))
            return SpringForce(negative(plus(scaled(spring, d), force)), pull, stored, lost)
    else:
        length = ca.sqrt(squared)
        stretch = sub(length, free_length)
        spring, stored = (
            mul(stiffness, sub(ONE, div(free_length, length))),
            div(mul(stiffness, mul(stretch, stretch)), ca.SX(2)),
        )
    damper = mul(damping, div(along, squared))
    return SpringForce(negative(plus(scaled(spring, d), scaled(damper, d))), pull, stored, mul(damper, along))


def distance_between(d: Vector, d_dot: Vector) -> tuple[ca.SX, ca.SX]:
    """(l, l') of points a distance vector d apart, l = |d|, l' = d . d' / l.

    Where the points meet, l' is its limit from the right, the speed |d'| with which they part.
    """
    squared = dot(d, d)
    rate = div(dot(d, d_dot), ca.sqrt(ca.fmax(squared, MET_POINTS)))
    return ca.sqrt(squared), ca.if_else(squared < MET_POINTS, ca.sqrt(dot(d_dot, d_dot)), rate)


HIGHEST_POWER = 6  # power of a polynomial along a beam


class _Acting:
    """Of one load; space: of all markers, read: its expressions; q, q_dot: what potentials are differentiated by."""

    axes: str

    def __init__(
        self,
        space: Any,
        load: Load,
        scene: SceneRecord,
        table: ParameterTable,
        read: Read,
        reader: ExpressionReader,
        q: ca.SX,
        q_dot: ca.SX,
    ) -> None:
        self.load, self.scene, self.table, self._read, self._reader = load, scene, table, read, reader
        self._space, self.q, self.q_dot = space, q, q_dot

    def value(self, key: str, **local: ca.SX) -> Any:
        """An expression, or the components of a vector; a z left out is zero."""
        given, item = getattr(self.load, key), f"{self.load.name}.{key}"
        if not isinstance(given, tuple):
            return self._read(given, item, local)
        padded = [*given, 0.0][: len(self.axes)]
        return [self._read(text, f"{item}.{axis}", local) for text, axis in zip(padded, self.axes, strict=True)]

    def constant(self, key: str) -> Any:
        """A quantity, or three."""
        given, meaning = getattr(self.load, key), self.load.meaning(key)
        if not isinstance(given, tuple):
            return self.table.of(self.load, key)
        what, item = key.replace("_", " "), f"{self.load.name}.{key}"
        return three(given, item, meaning.unit, self.table, what, meaning.bound.value)

    def dot(self, u: Sequence[ca.SX], v: Sequence[ca.SX]) -> ca.SX:
        """u . v."""
        return dot(u, v)

    def part_of_beam(self, beam: str, power: int, start: float, end: float) -> tuple[ca.SX, Any]:
        """Its mean point, weighted by s^power, and the weight."""
        body = self._beam(beam)
        xi, weights = stations(body, start, end)
        weights = weights * xi**power
        return self.table.of(body, "length") ** (power + 1) * float(weights.sum()), self._space.mean(body, xi, weights)

    def stations(self, beam: str, start: float, end: float) -> list[tuple[ca.SX, ca.SX, Any]]:
        """Gauss points of a part of a beam."""
        body = self._beam(beam)
        length = self.table.of(body, "length")
        return [
            (length * float(at), length * float(weight), self._space.mean(body, np.array([at]), np.ones(1)))
            for at, weight in zip(*stations(body, start, end), strict=True)
        ]

    def frame_of(self, beam: str) -> Any:
        """The frame at the start, which does not bend."""
        return self._space.frame(self._beam(beam))

    def place_on(self, beam: str, place: ca.SX) -> tuple[ca.SX, Any]:
        """The point there, or at the nearer end with a zero."""
        body = self._beam(beam)
        length = self.table.of(body, "length")
        for end in (place, place - length):
            self._reader.switch(self.load.name, end)
        on = ca.if_else(place < 0, 0, ca.if_else(place > length, 0, 1))
        return on, self._space.place(body, moving_place(body, ca.fmin(ca.fmax(place, 0), length), self.table))

    def beyond(self, beam: str, place: ca.SX, at: float) -> ca.SX:
        """One, or zero where the place is not beyond."""
        return ca.if_else(place > self.table.of(self._beam(beam), "length") * at, 1, 0)

    def _beam(self, name: str) -> BeamBody:
        body = self.scene.body(name)
        assert isinstance(body, BeamBody)
        return body

    def symbol(self, name: str) -> ca.SX:
        """A variable."""
        return ca.SX.sym(name)

    def coefficients(self, values: Sequence[ca.SX], variable: ca.SX) -> list[Vector] | None:
        """Taylor's, where the seventh derivative is zero."""
        found, slope, factorial = [], ca.vertcat(*values), 1.0
        for power in range(HIGHEST_POWER + 1):
            found.append(ca.vertsplit(ca.substitute(slope, variable, ZERO) / factorial))
            slope = ca.jacobian(slope, variable)
            if not ca.depends_on(slope, variable) and slope.nnz() == 0:
                return found
            slope, factorial = ca.densify(slope), factorial * (power + 1)
        return None

    def at_value(self, values: Sequence[ca.SX], variable: ca.SX, value: ca.SX) -> Vector:
        """By substitution."""
        return ca.vertsplit(ca.substitute(ca.vertcat(*values), variable, value))

    def larger(self, a: ca.SX, b: float) -> ca.SX:
        """The larger of two."""
        return ca.fmax(a, b)

    def push(self, depth: ca.SX, rate: ca.SX, exponent: float) -> Push:
        """By Hunt and Crossley; steps end where it kinks."""
        found = hunt_crossley(depth, rate, self.constant("stiffness"), self.constant("damping"), exponent)
        for value in found.kinks:
            self._reader.switch(self.load.name, value)
        return found

    def spring(self, a: Any, b: Any, stiffness: ca.SX, damping: ca.SX, free_length: ca.SX) -> SpringForce:
        """Along the line from a to b."""
        return spring_between(minus(b.r, a.r), minus(b.r_dot, a.r_dot), stiffness, damping, free_length)

    def coordinate(self, name: str) -> Scalar:
        """Of a joint."""
        found: Scalar = self._space.coordinate(name)
        return found

    def rate(self, value: ca.SX) -> ca.SX:
        """Along the motion."""
        return ca.jtimes(value, self.q, self.q_dot)

    def by_q(self, value: ca.SX) -> Row:
        """Non-zero partial derivatives by column."""
        return gradient(value, self.q)

    def by_rates(self, value: ca.SX) -> Row:
        """The same by the rates."""
        return gradient(value, self.q_dot)


class PlanarActing(_Acting):
    """In the plane: forces have two components, moments one."""

    axes = "xy"

    def __init__(self, marker: Callable[[str], MarkerMotion], *given: Any) -> None:
        super().__init__(*given)
        self.marker = marker

    def pair(self, a: str, b: str) -> tuple[MarkerMotion, MarkerMotion]:
        """Both markers."""
        return self.marker(a), self.marker(b)

    def along(self, marker: MarkerMotion, components: Sequence[ca.SX]) -> Vector:
        """(cos, -sin; sin, cos) (x, y)."""
        (cosine, sine), (x, y) = marker.direction, components
        return [cosine * x - sine * y, sine * x + cosine * y]

    def z(self, marker: MarkerMotion) -> Vector:
        """The plane's normal."""
        return [ONE]

    def spin(self, marker: MarkerMotion) -> Vector:
        """Rate of its angle."""
        return [marker.phi_dot]

    def generalised(self, *acting: tuple[MarkerMotion, Sequence[ca.SX], Sequence[ca.SX]]) -> Row:
        """F . dr/dq + M dphi/dq."""
        row: Row = {}
        for marker, force, moment in acting:
            for component, columns in zip(force, marker.r_columns, strict=False):
                add_scaled(row, component, columns)
            for component in moment:
                add_scaled(row, component, marker.phi_row)
        return row

    def action(self, force: Sequence[ca.SX] = (), moment: Sequence[ca.SX] = ()) -> list[ca.SX]:
        """x, y and about z."""
        return [*(force or zeros(2)), *(moment or zeros(1))]

    def angle(self, a: str, b: str) -> Scalar:
        """phi_b - phi_a."""
        return turn_between(self.marker(a), self.marker(b))


def turn_between(a: MarkerMotion, b: MarkerMotion) -> Scalar:
    """phi_b - phi_a of two planar markers."""
    row: Row = {}
    add_scaled(row, ONE, b.phi_row)
    add_scaled(row, neg(ONE), a.phi_row)
    return Scalar(b.phi - a.phi, b.phi_dot - a.phi_dot, nonzero(row), [ONE], rotation=True)


class SpatialActing(_Acting):
    """In space; joint_angle: of a joint between two markers that has one."""

    axes = "xyz"

    def __init__(
        self,
        marker: Callable[[str], SpatialMarker],
        pair: Callable[[str, str], tuple[SpatialMarker, SpatialMarker]],
        joint_angle: Callable[[str, str], Scalar | None],
        *given: Any,
    ) -> None:
        super().__init__(*given)
        self.marker, self.pair, self._joint_angle = marker, pair, joint_angle

    def along(self, marker: SpatialMarker, components: Sequence[ca.SX]) -> Vector:
        """Sum of components times axes."""
        return combination(marker.axes, components)

    def z(self, marker: SpatialMarker) -> Vector:
        """The third of its axes."""
        return marker.axes[2]

    def spin(self, marker: SpatialMarker) -> Vector:
        """omega."""
        return marker.omega

    def generalised(self, *acting: tuple[SpatialMarker, Sequence[ca.SX], Sequence[ca.SX]]) -> Row:
        """F . dr/dq + M . (virtual turn)/dq."""
        row: Row = {}
        for marker, force, moment in acting:
            for components, rows in ((force, marker.r_columns), (moment, marker.turn_rows)):
                for component, columns in zip(components, rows, strict=False):
                    add_scaled(row, component, columns)
        return row

    def action(self, force: Sequence[ca.SX] = (), moment: Sequence[ca.SX] = ()) -> list[ca.SX]:
        """Three and three."""
        return [*(force or zeros()), *(moment or zeros())]

    def angle(self, a: str, b: str) -> Scalar:
        """Of the joint between the markers, or of b's x-axis in the xy-plane of marker a, between -pi and pi."""
        first, second = self.pair(a, b)
        own = self._joint_angle(a, b)
        if own is not None:
            return Scalar(own.value, own.rate, own.row, first.axes[2], rotation=True)
        value = angle_about_z(first, second)
        return Scalar(value, self.rate(value), self.by_q(value), first.axes[2], rotation=True)


def angle_about_z(a: SpatialMarker, b: SpatialMarker) -> ca.SX:
    """Angle of b's x-axis in the xy-plane of marker a, between -pi and pi."""
    return ca.atan2(dot(b.axes[0], a.axes[1]), dot(b.axes[0], a.axes[0]))


def axis_of(joint: Joint, motion: Turn | Slide, a: SpatialMarker, b: SpatialMarker) -> Vector:
    """Of a motion: an axis of marker a, or of b where turns about another axis come before."""
    motions = joint.motions or ()
    before = motions[: motions.index(motion)]
    turned = any(isinstance(one, Turn) and one.axis != motion.axis for one in before)
    return (b if turned else a).axes[motion.axis]


def gradient(value: ca.SX, variables: ca.SX) -> Row:
    """Non-zero partial derivatives by position in `variables`."""
    slope = ca.jacobian(value, variables)
    return {column: slope[0, column] + ZERO for column in range(variables.numel()) if not slope[0, column].is_zero()}
