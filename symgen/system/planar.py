"""Bodies, joints and loads of a planar scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, dot, entries, neg
from symgen.algebra.vectors import minus
from symgen.bodies.beam_places import MovingPlace, frame_shape, mean_point, moving_place, place_shape
from symgen.bodies.beam_sets import beam_integrals_of, section_force
from symgen.bodies.outlines import BEAM_FRACTIONS, DrawnPoint, Picture, drawn_references, rectangle
from symgen.bodies.planar_body import BodyCoordinates, MarkerMotion, PlanarBody
from symgen.bodies.shape_integrals import (
    PointShape,
    beam_point,
    beam_section,
    body_integrals,
    marker_shape,
    mesh_key,
    shape_of,
)
from symgen.joints import Joint
from symgen.joints.joint import Turn
from symgen.loads import Load
from symgen.loads.load import LoadEffect, Scalar
from symgen.scene import BeamBody
from symgen.schema.fields import WORLD
from symgen.system.acting import PlanarActing, distance_between, turn_between
from symgen.system.axial_force import BeamFrame
from symgen.system.constraint import STILL, ConstraintRow, Motion
from symgen.system.constraint_rows import LocalPlace, holding, planar_rows, sliding_rows
from symgen.system.equations import Equations
from symgen.system.mechanism import Space, Spin
from symgen.system.structure import ExpressionReader, Read
from symgen.system.topology import Topology

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


class PlanarSpace(Space[MarkerMotion]):
    """Three rigid coordinates a body; a marker is a point and an angle."""

    axes = "xy"

    def __init__(self, scene: SceneRecord, table: ParameterTable, equations: Equations, topology: Topology) -> None:
        self.scene, self.table = scene, table
        self.bodies = {"ground": PlanarBody("ground", BodyCoordinates.ground(), None)}
        self._markers: dict[str, MarkerMotion] = {}

    def add_body(self, name: str, columns: list[int], q: list[ca.SX], q_dot: list[ca.SX]) -> tuple[PlanarBody, int]:
        """x, y, theta, q_f."""
        integrals = body_integrals(self.scene, name, self.table)
        size = 3 + integrals.nf
        body = PlanarBody(
            name, BodyCoordinates(columns[:size], q[:2], q[2], q[3:size], q_dot[:2], q_dot[2], q_dot[3:size]), integrals
        )
        self.bodies[name] = body
        return body, size

    def marker(self, reference: str) -> MarkerMotion:
        """Motion of "body.marker", built once."""
        if reference not in self._markers:
            body, shape = marker_shape(self.scene, reference, self.table)
            self._markers[reference] = self.bodies[body].marker(shape)
        return self._markers[reference]

    def joint_rows(self, joint: Joint, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
        """Rows between the joint's markers."""
        if joint.on_beam:
            return self._sliding_rows(joint)
        return planar_rows(joint, self.marker(joint.marker_a), self.marker(joint.marker_b), motions)

    def coordinate_row(self, name: str) -> ConstraintRow:
        """The coordinate "joint.angle" of a joint as a row that would hold it at zero."""
        joint, motion = self.scene.joint_of(name)
        a, b = self.marker(joint.marker_a), self.marker(joint.marker_b)
        return planar_rows(holding(joint, motion), a, b, {"motion": STILL})[0]

    def carrier_spin(self, joint: Joint) -> Spin:
        """Of the body of marker a."""
        a = self.marker(joint.marker_a)
        return Spin(a.phi_row, a.phi_dot, ZERO, {})

    def coordinate(self, name: str) -> Scalar:
        """The angle between a joint's markers, or the travel along the x-axis of marker a."""
        joint, motion = self.scene.joint_of(name)
        a, b = self.marker(joint.marker_a), self.marker(joint.marker_b)
        if isinstance(motion, Turn):
            return turn_between(a, b)
        row: Row = {}
        for axis, component in enumerate(a.direction):
            add_scaled(row, component, b.r_columns[axis])
            add_scaled(row, neg(component), a.r_columns[axis])
        value, rate = dot(a.direction, minus(b.r, a.r)), dot(a.direction, minus(b.r_dot, a.r_dot))
        return Scalar(value, rate, row, a.direction, rotation=False)

    def measure(self, kind: str, a: str, b: str, axes: str) -> ca.SX:
        """Angle, x or y."""
        first, second = self.marker(a), self.marker(b)
        if kind == "angle":
            return second.phi - first.phi
        return self.resolved(minus(second.r, first.r), axes)["xy".index(kind)]

    def resolved(self, vector: Sequence[ca.SX], axes: str) -> list[ca.SX]:
        """By the transpose of the marker's rotation."""
        if axes == WORLD:
            return list(vector)
        (cosine, sine), (x, y) = self.marker(axes).direction, vector
        return [cosine * x + sine * y, cosine * y - sine * x]

    def distance(self, a: str, b: str) -> tuple[ca.SX, ca.SX]:
        """The distance between two markers, and its rate."""
        first, second = self.marker(a), self.marker(b)
        return distance_between(minus(second.r, first.r), minus(second.r_dot, first.r_dot))

    def section_force(self, body: BeamBody, kind: str, at: float) -> ca.SX:
        """Of a beam at a fraction of its length, by its shapes."""
        return section_force(body, mesh_key(body), kind, at, self.bodies[body.name].coordinates.q_f, self.table)

    def beam_frame(self, body: BeamBody, q_ddot: Sequence[ca.SX]) -> BeamFrame:
        """Its z-axis stays."""
        own = self.bodies[body.name].coordinates
        x, y, theta, *elastic = own.columns
        c, s = ca.cos(own.theta), ca.sin(own.theta)
        A = [[c, neg(s), ZERO], [s, c, ZERO], [ZERO, ZERO, ONE]]
        omega, alpha = [ZERO, ZERO, own.theta_dot], [ZERO, ZERO, q_ddot[theta]]
        a_o = [c * q_ddot[x] + s * q_ddot[y], c * q_ddot[y] - s * q_ddot[x], ZERO]
        return BeamFrame(mesh_key(body), [x, y], [theta], elastic, A, [[ZERO, ZERO, ONE]], 1.0, omega, alpha, a_o)

    def load(self, load: Load, read: Read, reader: ExpressionReader, q: ca.SX, q_dot: ca.SX) -> LoadEffect:
        """As its record says."""
        return load.effect(PlanarActing(self.marker, self, load, self.scene, self.table, read, reader, q, q_dot))

    def mean(self, body: BeamBody, xi: np.ndarray, weights: np.ndarray) -> MarkerMotion:
        """A mean of points of a beam by weights."""
        point = mean_point(beam_integrals_of(body), xi, weights)
        at = float(weights @ xi / weights.sum())
        key = f"{mesh_key(body)}@mean of {len(xi)} from {xi[0]!r} to {xi[-1]!r} about {at!r}"
        return self.bodies[body.name].marker(shape_of(body, point, at, key, self.table))

    def frame(self, body: BeamBody) -> MarkerMotion:
        """The frame of a beam, which does not bend."""
        return self.bodies[body.name].marker(frame_shape(body.nf))

    def place(self, body: BeamBody, place: MovingPlace) -> MarkerMotion:
        """A place that moves: the point of the beam that is there."""
        return self.bodies[body.name].marker(place_shape(body.nf, place))

    def _sliding_rows(self, joint: Joint) -> list[ConstraintRow]:
        beam = self.scene.marker(joint.marker_a)[0]
        assert isinstance(beam, BeamBody)
        a, b, flexible = self.frame(beam), self.marker(joint.marker_b), self.bodies[beam.name].coordinates
        (c, s), d = a.direction, minus(b.r, a.r)
        v, bias = minus(b.r_dot, a.r_dot), minus(b.bias, a.bias)
        t, n = [c, s], [neg(s), c]
        x, y, w = dot(t, d), dot(n, d), a.phi_dot
        local = []
        for axis, value, turned, rate, still in (
            (t, x, y, dot(t, v) + w * y, dot(t, bias) + 2 * w * dot(n, v) - w**2 * x),
            (n, y, -x, dot(n, v) - w * x, dot(n, bias) - 2 * w * dot(t, v) - w**2 * y),
        ):
            row: Row = {}
            for k in range(2):
                add_scaled(row, axis[k], b.r_columns[k])
                add_scaled(row, neg(axis[k]), a.r_columns[k])
            add_scaled(row, turned, a.phi_row)
            local.append(LocalPlace(value, rate, row, still, (*axis, ZERO)))
        elastic = flexible.columns[3:], flexible.q_f, flexible.q_f_dot
        return sliding_rows(joint.name, local, moving_place(beam, x, self.table), *elastic)

    def picture(self) -> Picture:
        """Stations of beams, markers, poses."""
        points: list[DrawnPoint] = []
        sections, rigidities = {}, {}
        for body in self.scene.bodies:
            if isinstance(body, BeamBody):
                data = beam_integrals_of(body)
                shapes = [beam_point(body, data, at, self.table) for at in BEAM_FRACTIONS]
                points += [_drawn(body.name, "", shape) for shape in shapes]
                area, *seconds = beam_section(body, self.table)
                sections[body.name] = rectangle(area, *seconds)
                rigidities[body.name] = [self.table.of(body, "youngs_modulus") * second for second in seconds]
        for reference in drawn_references(self.scene):
            name, shape = marker_shape(self.scene, reference, self.table)
            points.append(_drawn(name, reference.partition(".")[2], shape))
        poses = {}
        for name, placed in self.bodies.items():
            if placed.coordinates.columns:
                c, s = placed.cosine, placed.sine
                poses[name] = ([*placed.coordinates.R_o, ZERO], [[c, -s, ZERO], [s, c, ZERO], [ZERO, ZERO, ONE]])
        return Picture(points, poses, sections, rigidities)


def _drawn(body: str, name: str, shape: PointShape) -> DrawnPoint:
    """A planar point with a third component."""
    c, s = ca.cos(shape.angle), ca.sin(shape.angle)
    modes = range(shape.Phi.shape[1])
    return DrawnPoint(
        body,
        name,
        [shape.position[0], shape.position[1], ZERO],
        [[c, -s, ZERO], [s, c, ZERO], [ZERO, ZERO, ONE]],
        [[shape.Phi[0, a], shape.Phi[1, a], ZERO] for a in modes],
        [[ZERO, ZERO, shape.slope[a]] for a in modes],
        [] if shape.H.nnz() == 0 else entries(shape.H),
    )
