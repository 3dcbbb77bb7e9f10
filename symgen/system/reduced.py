"""The equations of a spatial mechanism in the coordinates of its tree alone: no row and column for placed bodies.

The columns are those of all coordinates, of which the origins and Euler parameters of placed bodies stay empty. M and
the inertia forces come from the recursions along the frames; joints that close loops, loads and measures are stated by
markers whose motion is given by the tree's coordinates. Rows of placing joints stay as they are: they give the placed
coordinates.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property, partial
from typing import Any

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import ONE, ZERO, neg
from symgen.bodies.deformation import Deformation
from symgen.bodies.outlines import Picture
from symgen.bodies.spatial_body import SpatialMarker
from symgen.bodies.spatial_integrals import spatial_point
from symgen.joints.instance import ConstraintRow
from symgen.scene import Scene
from symgen.scene.joints import Joint
from symgen.scene.placing import PLACING
from symgen.system.equations import Equations
from symgen.system.frames.ball import Ball
from symgen.system.frames.body_moves import Bend
from symgen.system.frames.curvature import COVERED, LoopCurvature
from symgen.system.frames.force_changes import has_force_changes
from symgen.system.frames.free_joints import floats
from symgen.system.frames.inverse_dynamics import mass_rows
from symgen.system.frames.linkage import links_of
from symgen.system.frames.loop_rates import LoopRates, Way
from symgen.system.frames.motion import Matrix
from symgen.system.frames.paths import Path
from symgen.system.frames.skeleton import Skeleton
from symgen.system.frames.tree import GROUND, FrameTree
from symgen.system.mechanism import Mechanism
from symgen.system.orientations import Orientations, Turning, turn_coordinates
from symgen.system.reduced_body import ReducedBody
from symgen.system.spatial import SpatialSpace
from symgen.system.topology import Topology
from symgen.system.tree_forces import TreeForces


class TreeSpace(SpatialSpace):
    """Markers by the coordinates of the tree. whole: the same mechanism in all coordinates."""

    def __init__(
        self,
        scene: Scene,
        table: ParameterTable,
        equations: Equations,
        topology: Topology,
        whole: Equations,
        orientations: Orientations,
    ) -> None:
        super().__init__(scene, table, equations, topology)
        self.whole, self.orientations = whole, orientations
        self._turnings = {turning.body: turning for turning in equations.turnings}
        self._paths: dict[tuple[int, int], Path] = {}
        self.curvatures: dict[str, LoopCurvature] = {}
        self.loop_rates: dict[str, LoopRates] = {}

    def add_body(self, name: str, columns: list[int], q: list[ca.SX], q_dot: list[ca.SX]) -> tuple[Any, int]:
        """Its modal stiffness and damping."""
        body, size = super().add_body(name, columns, q, q_dot)
        return ReducedBody(body), size

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
            if name in balls:
                skeleton.hold(body, *self._hold(balls[name]))
                continue
            if name not in by_child:
                kind = getattr(self.scene.body(name), "orientation", "euler_parameters")
                skeleton.float(body, kind, self._turnings.get(name))
                continue
            placement = by_child[name]
            joint = joints[placement.joint]
            ends = [self._deformation(joint.marker_a), self._deformation(joint.marker_b)]
            near, far = ends if placement.forward else ends[::-1]
            own = {key: self._coordinates[f"{joint.name}.{key}"] for key in PLACING[joint.type]}
            links = partial(links_of, joint.type, own, forward=placement.forward, lead=self._lead(joint))
            skeleton.place(body, placement.parent, links, near, far)
        return skeleton.tree()

    def _hold(self, name: str) -> tuple[str, Turning, Deformation, Deformation, Callable[[], Matrix]]:
        """Parent, turning, near and far marker of a spherical joint of the tree, and the parent's axes in the world."""
        ball = self.orientations.balls[name]
        joint = next(joint for joint in self.scene.joints if joint.name == name)
        ends = [self._deformation(joint.marker_a), self._deformation(joint.marker_b)]
        near, far = ends if ball.forward else ends[::-1]
        return ball.parent, self._turnings[ball.child], near, far, partial(self._axes, ball.parent)

    def _axes(self, body: str) -> Matrix:
        """Of a body in the world, by rows."""
        seat = self.tree.seats[body]
        path = self._path(GROUND, seat.frame).branch()
        path.turn_by(seat.place.R)
        return [[axis[i] for axis in path.axes] for i in range(3)]

    def _number(self, value: ca.SX) -> float:
        """At the default parameters."""
        defaults = np.array([entry.default for entry in self.table.entries])
        return float(ca.Function("number", [self.table.vector()], [value])(defaults))

    def _deformation(self, reference: str) -> Deformation:
        name, point = spatial_point(self.scene, reference, self.table)
        q = self.bodies[name].coordinates
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
        ways = (self.tree.way(self.tree.seats[one.partition(".")[0]].frame) for one in (a, b))
        if base != GROUND and any(self._has_ball(way[way.index(base) + 1 :]) for way in ways):
            return GROUND
        return base

    def _way(self, base: int, reference: str) -> Way:
        seat = self.tree.seats[reference.partition(".")[0]]
        return Way.to(self.tree, base, seat, self._deformation(reference), self._path(base, seat.frame))

    def _has_ball(self, frames: list[int]) -> bool:
        return any(isinstance(move, Ball) for frame in frames for move in self.tree.frames[frame].moves)

    def _seen_from(self, base: int, reference: str) -> SpatialMarker:
        return self._way_to(base, reference).end()

    def _way_to(self, base: int, reference: str) -> Path:
        marker = self._deformation(reference)
        seat = self.tree.seats[reference.partition(".")[0]]
        path = self._path(base, seat.frame).branch()
        if marker.rigid:
            path.shift(seat.place.r)
            path.turn_by(seat.place.R)
            path.shift(marker.point.position)
            path.turn_by(marker.point.axes)
        else:
            Bend(marker).lead(path)
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

    def joint_rows(self, joint: Joint, motion: list[ca.SX]) -> list[ConstraintRow]:
        """Rows of a placing joint as in all coordinates, all others by the tree's coordinates."""
        if joint.name in self.topology.placements or joint.name in self.orientations.balls:
            return [row for row in self.whole.constraints if row.joint == joint.name]
        if joint.type in COVERED:
            ways = (self._way_to(GROUND, reference) for reference in (joint.marker_a, joint.marker_b))
            self.curvatures[joint.name] = LoopCurvature(*ways)
        if joint.type == "spherical":
            base = self._common(joint.marker_a, joint.marker_b)
            self.loop_rates[joint.name] = LoopRates(*(self._way(base, one) for one in (joint.marker_a, joint.marker_b)))
        return super().joint_rows(joint, motion)

    def picture(self) -> Picture:
        """That of all coordinates."""
        return self.whole.picture


def reduced_equations(
    scene: Scene, table: ParameterTable, whole: Equations, topology: Topology, orientations: Orientations
) -> Equations:
    """The equations of a spatial scene in the coordinates of its tree; whole: in all coordinates.

    Columns of rotation vectors, whose velocities are angular velocities, follow those of all coordinates.
    """
    turns = [entry for body in orientations.bodies for entry in turn_coordinates(body)]
    n = len(whole.q)
    size = n + len(turns)
    q = [*whole.q, *(ca.SX.sym(entry.name) for entry in turns)]
    q_dot = [*whole.q_dot, *(ca.SX.sym(entry.name.replace("turn_", "omega_")) for entry in turns)]
    held = {ball.child for ball in orientations.balls.values()}
    blank = replace(
        whole,
        coordinates=[*whole.coordinates, *turns],
        q=q,
        q_dot=q_dot,
        turnings=[_turning(whole, body, n + 3 * k, q_dot) for k, body in enumerate(orientations.bodies)],
        M=[{} for _ in range(size)],
        K=[{} for _ in range(size)],
        Q_v=[ZERO] * size,
        Q_F=[ZERO] * size,
        constraints=[],
        elastic=ca.SX(0),
        potential=ca.SX(0),
        dissipated=ca.SX(0),
        applied=ca.SX(0),
        measures={},
        body_columns={},
        measure_units={},
        load_forces={},
        load_actions={},
        springs={},
        events={},
        switching=[],
        placed_columns=frozenset(
            column
            for column, coordinate in enumerate(whole.coordinates)
            if (
                (coordinate.owner in topology.placed and not coordinate.elastic)
                or (coordinate.owner in held and coordinate.kind == "position")
            )
            and column not in whole.joint_columns
        ),
    )
    space = TreeSpace(scene, table, blank, topology, whole, orientations)
    equations = Mechanism(scene, table, space, blank, topology).equations
    _tell(whole, equations, ca.vertcat(*q_dot[n:]))
    for turning in equations.turnings:
        equations.body_columns[turning.body] += turning.columns
        equations.constraints += turning.rows([q[column] for column in turning.columns])
    equations.M = mass_rows(space.tree, len(equations.q))
    for column in equations.states.values():  # of controllers, which no body knows of
        equations.M[column] = {column: ONE}
    forces = TreeForces(space.tree, equations)
    equations.inertia_forces = forces.inertia_forces
    if has_force_changes(space.tree):
        equations.force_changes = forces.force_changes
        equations.curvatures, equations.loop_rates = space.curvatures, space.loop_rates
    if not floats(space.tree):
        equations.free_joints = forces.free_joints
    for column, value in equations.inertia_forces({}).items():
        equations.Q_v[column] = neg(value)
    return equations


def _tell(whole: Equations, reduced: Equations, omega: ca.SX) -> None:
    """Actions of loads and events by the coordinates of the tree, which are shorter, where no angular velocity is."""
    for name, action in reduced.load_actions.items():
        if not ca.depends_on(ca.vertcat(*action), omega):
            whole.load_actions[name] = action
    for name, event in reduced.events.items():
        if not ca.depends_on(ca.vertcat(event[0], *event[1].values()), omega):
            whole.events[name] = event


def _turning(whole: Equations, body: str, first: int, q_dot: list[ca.SX]) -> Turning:
    """The columns and symbols of a body whose first turn has the column `first`."""
    columns = list(range(first, first + 3))
    parameters = [whole.names.index(f"{body}.e{k}") for k in range(4)]
    chart = [ca.SX.sym(f"{body}.chart_{k}") for k in range(4)]
    return Turning(body, columns, parameters, [whole.q[k] for k in parameters], [q_dot[k] for k in columns], chart)
