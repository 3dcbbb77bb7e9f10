"""Joints, loads and measures of a spatial mechanism by the coordinates of its tree: markers along ways of frames.

A body of a tree of frames, as the scene's equations see it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property, partial

import casadi as ca
import numpy as np

from symgen.algebra.vectors import Matrix
from symgen.bodies.outlines import Picture
from symgen.bodies.spatial_body import SpatialBody, SpatialMarker
from symgen.bodies.spatial_integrals import spatial_point
from symgen.bodies.spatial_moments import Deformation, SpatialPoint
from symgen.joints import Joint
from symgen.system.constraint import ConstraintRow, Motion
from symgen.system.equations import Equations
from symgen.system.frames.alignment import links_of
from symgen.system.frames.loop_derivatives import LoopRates, MarkerWay
from symgen.system.frames.moves import Ball, MarkerNode
from symgen.system.frames.paths import Path
from symgen.system.frames.rnea_derivatives import LoopCurvature
from symgen.system.frames.skeleton import Skeleton
from symgen.system.frames.tree import GROUND, FrameTree
from symgen.system.orientations import Orientations, Turning
from symgen.system.spatial import SpatialSpace


class TreeSpace(SpatialSpace):
    """Markers by the coordinates of the tree. space, whole: the same mechanism in all coordinates."""

    inertia_of_bodies = False  # inertia and weight are in the recursions

    def __init__(self, space: SpatialSpace, equations: Equations, whole: Equations, orientations: Orientations) -> None:
        super().__init__(space.scene, space.table, equations, space.topology)
        self.known, self.whole, self.orientations = space.bodies, whole, orientations
        self._turnings = {turning.body: turning for turning in equations.turnings}
        self._paths: dict[tuple[int, int], Path] = {}
        self.curvatures: dict[str, LoopCurvature] = {}
        self.loop_rates: dict[str, LoopRates] = {}

    def add_body(self, name: str, columns: list[int], q: list[ca.SX], q_dot: list[ca.SX]) -> tuple[SpatialBody, int]:
        """As in all coordinates."""
        body = self.bodies[name] = self.known[name]
        return body, len(body.coordinates.columns)

    @cached_property
    def tree(self) -> FrameTree:
        """The frames, once all bodies are known."""
        skeleton = Skeleton(self._number)
        by_child = {placement.child: placement for placement in self.topology.placements.values()}
        balls = {self.orientations.balls[name].child: name for name in self.orientations.balls}
        parents = {name: self.orientations.balls[joint].parent for name, joint in balls.items()}
        parents |= {name: placement.parent for name, placement in by_child.items()}
        waiting = [name for name in self.bodies if name != "ground"]
        placed = {"ground"}
        joints = {joint.name: joint for joint in self.scene.joints}
        while waiting:
            name = next(name for name in waiting if parents.get(name, "ground") in placed)
            waiting.remove(name)
            placed.add(name)
            body = self.bodies[name]
            if name in self._origins:
                body = body.about(self._origins[name])
            if name in balls:
                skeleton.hold(body, *self._hold(balls[name]))
                continue
            if name not in by_child:
                skeleton.float(body, self._turnings.get(name))
                continue
            placement = by_child[name]
            joint = joints[placement.joint]
            ends = [self._deformation(joint.marker_a), self._deformation(joint.marker_b)]
            near, far = ends if placement.forward else ends[::-1]
            links = partial(links_of, self._own(joint), forward=placement.forward)
            skeleton.place(body, placement.parent, links, near, far)
        return skeleton.tree()

    @cached_property
    def _origins(self) -> dict[str, SpatialPoint]:
        """Of flexible bodies that a joint holds at a moving point: that point, which stands for their origin then.

        Only with shapes of first order, for which this changes no equation.
        """
        joints = {joint.name: joint for joint in self.scene.joints}
        carried = {ball.child: (name, ball.forward) for name, ball in self.orientations.balls.items()}
        carried |= {one.child: (one.joint, one.forward) for one in self.topology.placements.values()}
        found = {}
        for body, (name, forward) in carried.items():
            data, joint = self.bodies[body].integrals, joints[name]
            _, point = spatial_point(self.scene, joint.marker_b if forward else joint.marker_a, self.table)
            moves = any(not value.is_zero() for shape in point.shapes for value in shape)
            if data is not None and data.P and not data.S_H and not point.H and moves:
                found[body] = point
        return found

    def _hold(self, name: str) -> tuple[str, Turning, Deformation, Deformation, Callable[[], Matrix]]:
        """Parent, turning, near and far marker of a spherical joint of the tree, and the parent's axes in the world."""
        ball = self.orientations.balls[name]
        joint = next(joint for joint in self.scene.joints if joint.name == name)
        ends = [self._deformation(joint.marker_a), self._deformation(joint.marker_b)]
        near, far = ends if ball.forward else ends[::-1]
        return ball.parent, self._turnings[ball.child], near, far, partial(self._axes, ball.parent)

    def _axes(self, body: str) -> Matrix:
        """Of a body in the world, by rows."""
        known = self.tree.body_frames[body]
        path = self._path(GROUND, known.frame).branch()
        path.turn_by(known.place.R)
        return [[axis[i] for axis in path.axes] for i in range(3)]

    def _number(self, value: ca.SX) -> float:
        """At the default parameters."""
        defaults = np.array([entry.default for entry in self.table.entries])
        return float(ca.Function("number", [self.table.vector()], [value])(defaults))

    def _deformation(self, reference: str) -> Deformation:
        return self._deformed(*spatial_point(self.scene, reference, self.table))

    def _deformed(self, name: str, point: SpatialPoint) -> Deformation:
        q = self.bodies[name].coordinates
        if name in self._origins:
            point = point.less(self._origins[name])
        return Deformation(point, q.q_f, q.q_f_dot, q.elastic)

    # ---- markers ---------------------------------------------------------------------------------------------

    def marker(self, reference: str) -> SpatialMarker:
        """Motion of "body.marker" seen from the ground."""
        return self._seen_from(GROUND, reference)

    def pair(self, a: str, b: str) -> tuple[SpatialMarker, SpatialMarker]:
        """Two markers seen from the last frame that their ways have in common: what is between them needs no more."""
        base = self._common(a, b)
        return self._seen_from(base, a), self._seen_from(base, b)

    def _common(self, a: str, b: str) -> int:
        base = self.tree.common(a.partition(".")[0], b.partition(".")[0])
        ways = (self.tree.way(self.tree.body_frames[one.partition(".")[0]].frame) for one in (a, b))
        if base != GROUND and any(self._has_ball(way[way.index(base) + 1 :]) for way in ways):
            return GROUND
        return base

    def _way(self, base: int, reference: str) -> MarkerWay:
        known = self.tree.body_frames[reference.partition(".")[0]]
        return MarkerWay.to(self.tree, base, known, self._deformation(reference), self._path(base, known.frame))

    def _has_ball(self, frames: list[int]) -> bool:
        return any(isinstance(move, Ball) for frame in frames for move in self.tree.frames[frame].moves)

    def _seen_from(self, base: int, reference: str) -> SpatialMarker:
        return self._way_to(base, reference).end()

    def body_marker(self, body: str, point: SpatialPoint) -> SpatialMarker:
        """Motion of a point of a body that is no marker of the scene."""
        return self._way_of(GROUND, body, self._deformed(body, point)).end()

    def _way_to(self, base: int, reference: str) -> Path:
        return self._way_of(base, reference.partition(".")[0], self._deformation(reference))

    def _way_of(self, base: int, body: str, marker: Deformation) -> Path:
        known = self.tree.body_frames[body]
        path = self._path(base, known.frame).branch()
        if marker.rigid:
            path.shift(known.place.r)
            path.turn_by(known.place.R)
            path.shift(marker.point.position)
            path.turn_by(marker.point.axes)
        else:
            MarkerNode(marker).lead(path)
        return path

    def _path(self, base: int, frame: int) -> Path:
        if frame == base:
            return Path()
        if (base, frame) not in self._paths:
            path = self._path(base, self.tree.frames[frame].parent).branch()
            for move in self.tree.frames[frame].moves:
                move.lead(path)
            self._paths[base, frame] = path
        return self._paths[base, frame]

    def joint_rows(self, joint: Joint, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
        """Rows of a placing joint as in all coordinates, all others by the tree's coordinates."""
        if joint.name in self.topology.placements or joint.name in self.orientations.balls:
            return [row for row in self.whole.constraints if row.joint == joint.name]
        if joint.points == "together":
            a, b = (self._way_to(GROUND, reference) for reference in (joint.marker_a, joint.marker_b))
            self.curvatures[joint.name] = LoopCurvature(a, b, joint.perpendicular)
        if joint.is_ball():
            base = self._common(joint.marker_a, joint.marker_b)
            one, other = (self._way(base, reference) for reference in (joint.marker_a, joint.marker_b))
            self.loop_rates[joint.name] = LoopRates(one, other, self._path(GROUND, base))
        return super().joint_rows(joint, motions)

    def picture(self) -> Picture:
        """That of all coordinates."""
        return self.whole.picture
