"""The equations of a spatial mechanism in the coordinates of its tree alone: no row and column for placed bodies.

The columns are those of all coordinates, of which the origins and Euler parameters of placed bodies stay empty. M and
the inertia forces come from the recursions along the frames; joints that close loops, loads and measures are stated by
markers whose motion is given by the tree's coordinates. Rows of placing joints stay as they are: they give the placed
coordinates.

Joints, loads and measures see the bodies by markers along ways of frames.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.records import Coordinate
from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, neg
from symgen.algebra.vectors import Matrix, Vector
from symgen.bodies.outlines import Picture
from symgen.bodies.spatial_body import SpatialBody, SpatialMarker
from symgen.bodies.spatial_integrals import spatial_point
from symgen.bodies.spatial_moments import Deformation, SpatialPoint
from symgen.joints import Joint
from symgen.system.constraint import ConstraintRow, Motion
from symgen.system.equations import Direction, Equations, InertiaForces, Rotor
from symgen.system.frames.aba import floats, free_joint_accelerations
from symgen.system.frames.alignment import links_of
from symgen.system.frames.crba import mass_rows
from symgen.system.frames.joint_transforms import Ball, MarkerNode
from symgen.system.frames.loop_derivatives import Loop, MarkerWay, loop_changes
from symgen.system.frames.paths import Path
from symgen.system.frames.rnea import floating_forces, inverse_dynamics, own_wrenches
from symgen.system.frames.rnea_derivatives import force_changes, has_force_changes
from symgen.system.frames.skeleton import Skeleton
from symgen.system.frames.tree import GROUND, FrameTree
from symgen.system.mechanism import Mechanism, with_rotors, with_states
from symgen.system.orientations import Orientations, RotationVector, turn_coordinates
from symgen.system.spatial import SpatialSpace
from symgen.system.topology import Topology


class TreeSpace(SpatialSpace):
    """Markers by the coordinates of the tree. space, whole: the same mechanism in all coordinates."""

    inertia_of_bodies = False  # inertia and weight are in the recursions

    def __init__(self, space: SpatialSpace, equations: Equations, whole: Equations, orientations: Orientations) -> None:
        super().__init__(space.scene, space.table, equations, space.topology)
        self.known, self.whole, self.orientations = space.bodies, whole, orientations
        self._rotation_vectors = {rotation.body: rotation for rotation in equations.rotation_vectors}
        self._paths: dict[tuple[int, int], Path] = {}
        self.loops: dict[str, Loop] = {}

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
                skeleton.float(body, self._rotation_vectors[name])
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

    def _hold(self, name: str) -> tuple[str, RotationVector, Deformation, Deformation, Callable[[], Matrix]]:
        """Parent, turning, near and far marker of a spherical joint of the tree, and the parent's axes in the world."""
        ball = self.orientations.balls[name]
        joint = next(joint for joint in self.scene.joints if joint.name == name)
        ends = [self._deformation(joint.marker_a), self._deformation(joint.marker_b)]
        near, far = ends if ball.forward else ends[::-1]
        return ball.parent, self._rotation_vectors[ball.child], near, far, partial(self._axes, ball.parent)

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
        return self._relative_to(GROUND, reference)

    def pair(self, a: str, b: str) -> tuple[SpatialMarker, SpatialMarker]:
        """Two markers seen from the last frame that their ways have in common: what is between them needs no more."""
        base = self._common(a, b)
        return self._relative_to(base, a), self._relative_to(base, b)

    def _common(self, a: str, b: str) -> int:
        base = self.tree.common(a.partition(".")[0], b.partition(".")[0])
        ways = (self.tree.path_to(self.tree.body_frames[one.partition(".")[0]].frame) for one in (a, b))
        if base != GROUND and any(self._has_ball(way[way.index(base) + 1 :]) for way in ways):
            return GROUND
        return base

    def _way(self, base: int, reference: str) -> MarkerWay:
        known = self.tree.body_frames[reference.partition(".")[0]]
        return MarkerWay.to(self.tree, base, known, self._deformation(reference), self._path(base, known.frame))

    def _has_ball(self, frames: list[int]) -> bool:
        return any(isinstance(transform, Ball) for frame in frames for transform in self.tree.frames[frame].transforms)

    def _relative_to(self, base: int, reference: str) -> SpatialMarker:
        return self._path_to(base, reference).end()

    def body_marker(self, body: str, point: SpatialPoint) -> SpatialMarker:
        """Motion of a point of a body that is not a marker of the scene."""
        return self._path_of(GROUND, body, self._deformed(body, point)).end()

    def _path_to(self, base: int, reference: str) -> Path:
        return self._path_of(base, reference.partition(".")[0], self._deformation(reference))

    def _path_of(self, base: int, body: str, marker: Deformation) -> Path:
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
            for transform in self.tree.frames[frame].transforms:
                transform.lead(path)
            self._paths[base, frame] = path
        return self._paths[base, frame]

    def joint_rows(self, joint: Joint, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
        """Rows of a placing joint as in all coordinates, all others by the tree's coordinates."""
        if joint.name in self.topology.placements or joint.name in self.orientations.balls:
            return [row for row in self.whole.constraints if row.joint == joint.name]
        if joint.is_ball():
            base = self._common(joint.marker_a, joint.marker_b)
            one, other = (self._way(base, reference) for reference in (joint.marker_a, joint.marker_b))
            self.loops[joint.name] = Loop(one, other, self._path(GROUND, base))
        return super().joint_rows(joint, motions)

    def picture(self) -> Picture:
        """That of all coordinates."""
        return self.whole.picture


@dataclass(frozen=True)
class TreeForces:
    """Of a tree of frames that moves by the coordinates of some equations; loops: what closes it, by joint."""

    tree: FrameTree
    equations: Equations
    loops: Mapping[str, Loop]

    @property
    def _base(self) -> Vector:
        return [neg(component) for component in self.equations.gravity]

    @property
    def _rates(self) -> Row:
        return dict(enumerate(self.equations.q_dot))

    def inertia_forces(self, accelerations: Row) -> Row:
        """M x'' - Q_v and the weight, by column."""
        force = inverse_dynamics(self.tree, self._base, self._rates, accelerations)
        add_scaled(force, ONE, floating_forces(self.tree, self.equations.M, self._base, accelerations))
        for column in self.equations.states.values():
            if column in accelerations:
                force[column] = accelerations[column]
        return force

    def force_changes(self, accelerations: Row) -> tuple[list[Row], list[Row]]:
        """Derivatives of `inertia_forces` by q and by q_dot."""
        return force_changes(self.tree, len(self.equations.q), self._base, self._rates, accelerations)

    def loop_changes(
        self, accelerations: Row, multipliers: Mapping[str, Vector], directions: Sequence[Direction]
    ) -> tuple[ca.SX, ca.SX] | None:
        """Derivatives of `inertia_forces` + C_q^T lambda of spherical loops along directions."""
        found = [(loop, multipliers[joint]) for joint, loop in self.loops.items()]
        moving = self._rates, accelerations
        return loop_changes(self.tree, len(self.equations.q), self._base, moving, found, directions)

    def free_joints(self, force: Row, free: frozenset[int], masks: Row, imposed: Row | None = None) -> Row:
        """Accelerations by a force, and with `imposed` ones of the others by rates and weight too."""
        if imposed is None:
            return free_joint_accelerations(self.tree, force, free, masks)
        wrenches, modes = own_wrenches(self.tree, self._base, self._rates, imposed)
        left = dict(force)
        add_scaled(left, neg(ONE), modes)
        return free_joint_accelerations(self.tree, left, free, masks, wrenches)


def reduced_equations(built: Mechanism[SpatialMarker], space: SpatialSpace, orientations: Orientations) -> Equations:
    """The equations of a spatial mechanism that was built in all coordinates, in those of its tree.

    Columns of rotation vectors, whose velocities are angular velocities, follow those of all coordinates.
    """
    whole, topology = built.equations, built.topology
    turns = [entry for body in orientations.bodies for entry in turn_coordinates(body)]
    n = len(whole.q)
    size = n + len(turns)
    q = [*whole.q, *(ca.SX.sym(entry.name) for entry in turns)]
    q_dot = [*whole.q_dot, *(ca.SX.sym(entry.name.replace("turn_", "omega_")) for entry in turns)]
    blank = Equations(
        [*whole.coordinates, *turns],
        q,
        q_dot,
        whole.t,
        [{} for _ in q],
        [ZERO] * size,
        [],
        u=whole.u,
        sides=whole.sides,
        held=whole.held,
        inputs=whole.inputs,
        beams=whole.beams,
        flexible=whole.flexible,
        rotation_vectors=[
            _rotation_vector(whole, body, n + 3 * k, q_dot) for k, body in enumerate(orientations.bodies)
        ],
        placed_columns=_placed(whole, topology, orientations),
    )
    tree_space = TreeSpace(space, blank, whole, orientations)
    found = Mechanism(built.scene, built.table, tree_space, blank, topology).equations
    _set_rates(whole, found, ca.vertcat(*q_dot[n:]))
    constraints = list(found.constraints)
    for rotation in found.rotation_vectors:
        found.body_columns[rotation.body] += rotation.columns
        constraints += rotation.rows([q[column] for column in rotation.columns])
    equations = replace(found, constraints=constraints)
    return replace(equations, felt_columns=_felt(equations, topology, orientations), **_dynamics(equations, tree_space))


def _dynamics(equations: Equations, space: TreeSpace) -> dict[str, Any]:
    """Masses and inertia forces of a tree of frames, with what else its recursions give, by fields of `Equations`."""
    tree, size, rotors = space.tree, len(equations.q), equations.rotors
    bodies = replace(equations, masses=lambda: with_states(mass_rows(tree, size), equations))
    forces = TreeForces(tree, bodies, space.loops)
    inertia_forces: InertiaForces = forces.inertia_forces
    found: dict[str, Any] = {"masses": lambda: bodies.M}
    if rotors:
        found["masses"] = lambda: with_rotors(with_states(mass_rows(tree, size), equations), equations)
        inertia_forces = partial(_inertia_with_rotors, forces, rotors)
    elif has_force_changes(tree):
        found |= {"force_changes": forces.force_changes, "loop_changes": forces.loop_changes}
        found["loop_rates"] = {joint: loop.rows for joint, loop in space.loops.items()}
    if not floats(tree) and not rotors:
        found["free_joints"] = forces.free_joints
    negated: Callable[[], list[ca.SX]] = lambda: _negated(inertia_forces({}), size)  # noqa: E731
    return found | {"inertia_forces": inertia_forces, "velocity_forces": negated}


def _placed(whole: Equations, topology: Topology, orientations: Orientations) -> frozenset[int]:
    """Coordinates of the frames of bodies that joints place, and origins of those that spherical joints hold."""
    on_balls = {ball.child for ball in orientations.balls.values()}

    def placed(entry: Coordinate) -> bool:
        own = entry.owner in topology.placed and not entry.elastic
        return own or (entry.owner in on_balls and entry.kind == "position")

    return frozenset(k for k, entry in enumerate(whole.coordinates) if placed(entry)) - whole.joint_columns


def _negated(row: Row, n: int) -> list[ca.SX]:
    return [neg(row[column]) if column in row else ZERO for column in range(n)]


def _inertia_with_rotors(forces: TreeForces, rotors: list[Rotor], accelerations: Row) -> Row:
    """Inertia forces of the bodies and of the rotors of motors, which no recursion along the frames knows of."""
    found = forces.inertia_forces(accelerations)
    for rotor in rotors:
        add_scaled(found, ONE, rotor.force(accelerations))
    return found


def _felt(equations: Equations, topology: Topology, orientations: Orientations) -> frozenset[int]:
    """Coordinates of the frames of placed bodies that forces depend on, and those of the bodies before these."""
    forces = ca.vertcat(*equations.Q_F)
    known = {symbol.element_hash() for symbol in ca.symvar(forces)}
    parents = {one.child: one.parent for one in topology.placements.values()}
    parents |= {ball.child: ball.parent for ball in orientations.balls.values()}
    felt: set[int] = set()
    for body, columns in equations.body_columns.items():
        own: str | None = body
        if any(known & {equations.q[c].element_hash(), equations.q_dot[c].element_hash()} for c in columns):
            while own is not None:
                felt |= equations.placed_columns.intersection(equations.body_columns.get(own, ()))
                own = parents.get(own)
    return frozenset(felt)


def _set_rates(whole: Equations, reduced: Equations, omega: ca.SX) -> None:
    """Actions of loads, events and kinks by the shorter coordinates of the tree, where no angular velocity is."""
    for name, action in reduced.load_actions.items():
        if not ca.depends_on(ca.vertcat(*action), omega):
            whole.load_actions[name] = action
    for name, event in reduced.events.items():
        if not ca.depends_on(ca.vertcat(event[0], *event[1].values()), omega):
            whole.events[name] = event
    for name, kink in reduced.kinks.items() if [*reduced.kinks] == [*whole.kinks] else ():
        if not ca.depends_on(kink[1], omega):
            whole.kinks[name] = kink


def _rotation_vector(whole: Equations, body: str, first: int, q_dot: list[ca.SX]) -> RotationVector:
    """The columns and symbols of a body whose first turn has the column `first`."""
    columns = list(range(first, first + 3))
    parameters = [whole.names.index(f"{body}.e{k}") for k in range(4)]
    chart = [ca.SX.sym(f"{body}.chart_{k}") for k in range(4)]
    return RotationVector(
        body, columns, parameters, [whole.q[k] for k in parameters], [q_dot[k] for k in columns], chart
    )
