"""Bodies, joints and loads of a spatial scene."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, dot, neg
from symgen.algebra.vectors import combination, cross, minus, plus, transposed_times, zeros
from symgen.bodies.beam_places import MovingPlace, frame_point, mean_point, moving_place, place_point
from symgen.bodies.beam_sets import beam_integrals_of, section_force
from symgen.bodies.outlines import BEAM_FRACTIONS, DrawnPoint, Picture, drawn_references, rectangle
from symgen.bodies.shape_integrals import beam_section
from symgen.bodies.spatial_body import SpatialBody, SpatialCoordinates, SpatialMarker
from symgen.bodies.spatial_integrals import (
    beam_spatial_point,
    spatial_integrals,
    spatial_mesh_key,
    spatial_point,
    spatial_point_of,
)
from symgen.bodies.spatial_moments import SpatialPoint
from symgen.bodies.spatial_orientation import orientation
from symgen.joints import Joint
from symgen.joints.joint import Turn
from symgen.loads import Load
from symgen.loads.load import LoadEffect, Scalar
from symgen.scene import BeamBody
from symgen.schema.fields import WORLD
from symgen.system.acting import SpatialActing, angle_about_z, axis_of, distance_between, gradient
from symgen.system.axial_force import BeamFrame
from symgen.system.constraint import STILL, ConstraintRow, Motion
from symgen.system.constraint_rows import (
    LocalPlace,
    coordinate_row,
    holding,
    placing_rows,
    sliding_rows,
    spatial_rows,
    unit_length,
)
from symgen.system.equations import Equations
from symgen.system.joint_templates import JointCoordinate, JointCoordinates
from symgen.system.mechanism import Space, Spin
from symgen.system.structure import ExpressionReader, Read
from symgen.system.topology import Topology

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


class SpatialSpace(Space[SpatialMarker]):
    """Six or seven rigid coordinates a body; a marker is a point and three axes. Some joints have coordinates too."""

    axes = "xyz"

    def __init__(self, scene: SceneRecord, table: ParameterTable, equations: Equations, topology: Topology) -> None:
        self.scene, self.table, self.topology = scene, table, topology
        self.motion = ca.vertcat(*equations.q), ca.vertcat(*equations.q_dot)
        self.bodies = {"ground": SpatialBody.ground()}
        self._markers: dict[str, SpatialMarker] = {}
        self._coordinates: dict[str, JointCoordinate] = {}
        for name in (name for placement in topology.placements.values() for name in placement.coordinates):
            column = equations.names.index(name)
            self._coordinates[name] = JointCoordinate(equations.q[column], equations.q_dot[column], column)

    def add_body(self, name: str, columns: list[int], q: list[ca.SX], q_dot: list[ca.SX]) -> tuple[SpatialBody, int]:
        """x, y, z, Euler parameters, q_f."""
        description, integrals = self.scene.body(name), spatial_integrals(self.scene, name, self.table)
        rotation = len(self.scene.frame_coordinates(description))
        size = rotation + integrals.nf
        coordinates = SpatialCoordinates(
            columns[:size], q[:3], q[3:rotation], q[rotation:size], q_dot[:3], q_dot[3:rotation], q_dot[rotation:size]
        )
        body = SpatialBody(name, coordinates, orientation(coordinates.theta, coordinates.theta_dot), integrals)
        self.bodies[name] = body
        return body, size

    def marker(self, reference: str) -> SpatialMarker:
        """Motion of "body.marker", built once."""
        if reference not in self._markers:
            body, point = spatial_point(self.scene, reference, self.table)
            self._markers[reference] = self.bodies[body].marker(point)
        return self._markers[reference]

    def pair(self, a: str, b: str) -> tuple[SpatialMarker, SpatialMarker]:
        """Two markers of which only the motion between them counts."""
        return self.marker(a), self.marker(b)

    def joint_rows(self, joint: Joint, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
        """Rows that place a body, prescribe a joint's coordinate, or stand between the markers."""
        a, b = self.marker(joint.marker_a), self.marker(joint.marker_b)
        placement = self.topology.placements.get(joint.name)
        if placement is not None:
            child, parent = self.bodies[placement.child], self.bodies[placement.parent]
            return placing_rows(joint, self._own(joint), (a, b), child, parent, placement.forward)
        if joint.on_beam:
            return self._sliding_rows(joint)
        driven = self._driven(joint)
        if driven is not None:
            motion = next(iter(motions.values()))
            return [coordinate_row(joint.name, joint.drives, self._own(driven), motion, a)]
        return spatial_rows(joint, a, b, motions)

    def coordinate_row(self, name: str) -> ConstraintRow:
        """The coordinate "joint.angle" of a joint as a row that would hold it at zero."""
        joint, motion = self.scene.joint_of(name)
        a, b = self.marker(joint.marker_a), self.marker(joint.marker_b)
        if name in self._coordinates:
            return coordinate_row(joint.name, motion.name, self._own(joint), STILL, a)
        return spatial_rows(holding(joint, motion), a, b, {"motion": STILL})[0]

    def carrier_spin(self, joint: Joint) -> Spin:
        """Of the body of marker a about the axis of the joint's first motion."""
        motions, a = joint.motions or (), self.marker(joint.marker_a)
        axis = a.axes[motions[0].axis]
        row: Row = {}
        for component, turns in zip(axis, a.turn_rows, strict=True):
            add_scaled(row, component, turns)
        rotation: Row = {}
        for component, turns in zip(cross(a.omega, axis), a.turn_rows, strict=True):
            add_scaled(rotation, component, turns)
        return Spin(row, dot(axis, a.omega), dot(axis, a.turn_bias), rotation)

    def _own(self, joint: Joint) -> JointCoordinates:
        """The coordinates of a joint that places a body."""
        motions = joint.motions or ()
        leads = [self.table.of(joint, motion.lead) / (2 * math.pi) if motion.lead else ZERO for motion in motions]
        return JointCoordinates(motions, [self._coordinates[f"{joint.name}.{own.name}"] for own in motions], leads)

    def _driven(self, drive: Joint) -> Joint | None:
        """The placing joint between the same markers whose coordinate a prescribed motion gives."""
        for joint in self.scene.joints:
            same = (joint.marker_a, joint.marker_b) == (drive.marker_a, drive.marker_b)
            if same and drive.drives and f"{joint.name}.{drive.drives}" in self._coordinates:
                return joint
        return None

    def _between(self, a: str, b: str, label: str) -> JointCoordinate | None:
        """The coordinate `label` of a placing joint between two markers."""
        for joint in self.scene.joints:
            if (joint.marker_a, joint.marker_b) == (a, b) and f"{joint.name}.{label}" in self._coordinates:
                return self._coordinates[f"{joint.name}.{label}"]
        return None

    def _joint_angle(self, a: str, b: str) -> Scalar | None:
        """The angle of a placing joint between two markers, its negative where the joint names them the other way."""
        own, opposite = self._between(a, b, "angle"), self._between(b, a, "angle")
        if own is not None or opposite is None:
            return None if own is None else _scalar(own)
        return Scalar(-opposite.value, -opposite.rate, {opposite.column: -ONE}, (), rotation=True)

    def body_rows(self) -> list[ConstraintRow]:
        """Unit length of Euler parameters that no joint gives."""
        return [
            unit_length(body)
            for name, body in self.bodies.items()
            if name not in self.topology.placed and body.coordinates.theta
        ]

    def coordinate(self, name: str) -> Scalar:
        """A coordinate of q, or the turn or travel between the markers of a joint that closes a loop."""
        joint, motion = self.scene.joint_of(name)
        a, b = self.pair(joint.marker_a, joint.marker_b)
        own, axis = self._coordinates.get(name), axis_of(joint, motion, a, b)
        if own is not None:
            return replace(_scalar(own), axis=axis, rotation=isinstance(motion, Turn))
        if isinstance(motion, Turn):
            row: Row = {}
            for component, ahead, behind in zip(axis, b.turn_rows, a.turn_rows, strict=True):
                add_scaled(row, component, ahead)
                add_scaled(row, neg(component), behind)
            return Scalar(angle_about_z(a, b), dot(axis, minus(b.omega, a.omega)), row, axis, rotation=True)
        travel = dot(axis, minus(b.r, a.r))
        return Scalar(travel, ca.jtimes(travel, *self.motion), gradient(travel, self.motion[0]), axis, rotation=False)

    def section_force(self, body: BeamBody, kind: str, at: float) -> ca.SX:
        """Of a beam at a fraction of its length, by its shapes."""
        return section_force(body, spatial_mesh_key(body), kind, at, self.bodies[body.name].coordinates.q_f, self.table)

    def beam_frame(self, body: BeamBody, q_ddot: Sequence[ca.SX]) -> BeamFrame:
        """By Euler parameters, whose axes add up to four along each direction."""
        own, turned = self.bodies[body.name].coordinates, self.bodies[body.name].orientation
        place, turning, A = own.columns[:3], own.orientation_columns, turned.A
        alpha = combination(turned.body_axes, [q_ddot[column] for column in turning])
        a_o = transposed_times(A, [q_ddot[column] for column in place])
        return BeamFrame(
            spatial_mesh_key(body),
            place,
            turning,
            own.elastic,
            A,
            turned.body_axes,
            4.0,
            turned.omega_body,
            alpha,
            a_o,
        )

    def resolved(self, vector: Sequence[ca.SX], axes: str) -> list[ca.SX]:
        """By the transpose of the marker's rotation."""
        return list(vector) if axes == WORLD else [dot(axis, vector) for axis in self.marker(axes).axes]

    def measure(self, kind: str, a: str, b: str, axes: str) -> ca.SX:
        """Angle about marker a's z-axis (that of the joint between the markers, if it has one), x, y or z."""
        if kind == "angle":
            own = self._joint_angle(a, b)
            return angle_about_z(*self.pair(a, b)) if own is None else own.value
        return self.resolved(minus(self.marker(b).r, self.marker(a).r), axes)["xyz".index(kind)]

    def distance(self, a: str, b: str) -> tuple[ca.SX, ca.SX]:
        """The distance between two markers, and its rate."""
        first, second = self.pair(a, b)
        return distance_between(minus(second.r, first.r), minus(second.r_dot, first.r_dot))

    def load(self, load: Load, read: Read, reader: ExpressionReader, q: ca.SX, q_dot: ca.SX) -> LoadEffect:
        """As its record says."""
        markers = self.marker, self.pair, self._joint_angle
        return load.effect(SpatialActing(*markers, self, load, self.scene, self.table, read, reader, q, q_dot))

    def body_marker(self, body: str, point: SpatialPoint) -> SpatialMarker:
        """Motion of a point of a body that is not a marker of the scene."""
        return self.bodies[body].marker(point)

    def mean(self, body: BeamBody, xi: np.ndarray, weights: np.ndarray) -> SpatialMarker:
        """A mean of points of a beam by weights."""
        point = mean_point(beam_integrals_of(body), xi, weights)
        at = float(weights @ xi / weights.sum())
        key = f"{spatial_mesh_key(body)}@mean of {len(xi)} from {xi[0]!r} to {xi[-1]!r} about {at!r}"
        return self.body_marker(body.name, spatial_point_of(body, point, at, key, self.table))

    def frame(self, body: BeamBody) -> SpatialMarker:
        """The frame of a beam, which does not bend."""
        return self.body_marker(body.name, frame_point(body.nf))

    def place(self, body: BeamBody, place: MovingPlace) -> SpatialMarker:
        """A place that moves: the point of the beam that is there."""
        return self.body_marker(body.name, place_point(body.nf, place))

    def _sliding_rows(self, joint: Joint) -> list[ConstraintRow]:
        beam = self.scene.marker(joint.marker_a)[0]
        assert isinstance(beam, BeamBody)
        a, b, flexible = self.frame(beam), self.marker(joint.marker_b), self.bodies[beam.name].coordinates
        d, v, bias = minus(b.r, a.r), minus(b.r_dot, a.r_dot), minus(b.bias, a.bias)
        local = []
        for axis in a.axes:
            turned, w_axis = cross(axis, d), cross(a.omega, axis)
            still = (
                dot(axis, bias) + 2 * dot(w_axis, v) + dot(plus(cross(a.turn_bias, axis), cross(a.omega, w_axis)), d)
            )
            row: Row = {}
            for k in range(3):
                add_scaled(row, axis[k], b.r_columns[k])
                add_scaled(row, neg(axis[k]), a.r_columns[k])
                add_scaled(row, turned[k], a.turn_rows[k])
            rate = dot(axis, v) + dot(w_axis, d)
            local.append(LocalPlace(dot(axis, d), rate, row, still, (*axis, *zeros())))
        elastic = flexible.elastic, flexible.q_f, flexible.q_f_dot
        return sliding_rows(joint.name, local, moving_place(beam, local[0].value, self.table), *elastic)

    def picture(self) -> Picture:
        """Stations of beams, markers, poses."""
        points: list[DrawnPoint] = []
        sections, rigidities = {}, {}
        for body in self.scene.bodies:
            if isinstance(body, BeamBody):
                stations = [beam_spatial_point(body, at, self.table) for at in BEAM_FRACTIONS]
                points += [_drawn(body.name, "", station) for station in stations]
                area, *seconds = beam_section(body, self.table)
                sections[body.name] = rectangle(area, *seconds)
                rigidities[body.name] = [self.table.of(body, "youngs_modulus") * second for second in seconds]
        for reference in drawn_references(self.scene):
            name, point = spatial_point(self.scene, reference, self.table)
            points.append(_drawn(name, reference.partition(".")[2], point))
        placed = [body for body in self.bodies.values() if body.coordinates.columns]
        poses = {body.name: (body.coordinates.R_o, body.orientation.A) for body in placed}
        return Picture(points, poses, sections, rigidities)


def _drawn(body: str, name: str, point: SpatialPoint) -> DrawnPoint:
    return DrawnPoint(body, name, point.position, point.axes, point.shapes, point.turns, point.H[0] if point.H else [])


def _scalar(own: JointCoordinate) -> Scalar:
    return Scalar(own.value, own.rate, {own.column: ONE}, (), rotation=True)
