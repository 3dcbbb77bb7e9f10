"""The first two derivatives in time of the rows of a spherical joint that closes a loop, from the ways to its markers.

C = r_b - r_a, so that an entry of C_q is what a coordinate moves the end of a way by, and its rates are those of the
coordinate's field there.

A frame with the way to it: what the coordinates on the way do to the frame, and to the wrench that is there.

k_c'c is what a displacement by coordinate c does to the power of a wrench on coordinate c' of an earlier transform: the
wrench is displaced with the frame. On coordinates of later transforms it does nothing, as all of that is displaced
alike; on those of the same transform only where that bends a body. The force of a spherical joint keeps its direction
instead: a turning tau of the frame changes it by -tau x f as seen there.

Derivatives of inertia forces along directions in which all coordinates of loops follow a few.

With T_i the field of a frame for direction i and w the change of the wrench that moves its masses,

    d(S^T F)_i / dx_j = sum over frames of T_i . w(D T_j, D^2 T_j, T_j) + sum over c', c of S_c'i S_cj k_c'c,

k being geometry (`places`). A body that one spherical joint holds is looked at where the joint is: its force has no
moment there, and the joint's other body gives v where fewer coordinates move it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg
from symgen.algebra.vectors import Vector, cross, negative, plus, times, zeros
from symgen.bodies.spatial_moments import Deformation
from symgen.system.equations import Direction
from symgen.system.frames.fields import (
    Change,
    Field,
    FieldPart,
    TransformState,
    cross_wrench,
    field_along,
    joint_parts,
    share_of,
)
from symgen.system.frames.joint_transforms import JointNode, MarkerNode, Node
from symgen.system.frames.paths import Path
from symgen.system.frames.rnea_derivatives import BendChanges, ForceSweep, Subtree, parts_of
from symgen.system.frames.skeleton import place_of
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion, Motion
from symgen.system.frames.tree import GROUND, BodyFrame, FlexibleNode, FrameTree


@dataclass(frozen=True)
class MarkerWay:
    """Transforms from frame `base` (or GROUND), taken to be at rest, to a marker in `frame`; path: to that frame."""

    base: int
    frame: int
    transforms: list[Node]
    path: Path

    @property
    def end(self) -> Node:
        """From the frame to the marker, without turning."""
        return self.transforms[-1]

    @staticmethod
    def to(tree: FrameTree, base: int, known: BodyFrame, marker: Deformation, path: Path) -> MarkerWay:
        """From a frame (or GROUND) to a marker of a body whose frame is known; path: to the frame of that."""
        frames = tree.path_to(known.frame)
        frames = frames if base == GROUND else frames[frames.index(base) + 1 :]
        place = plus(known.place.r, times(known.place.R, marker.point.position))
        end = JointNode(r=place) if marker.rigid else MarkerNode(place_of(marker))
        return MarkerWay(
            base, known.frame, [*(transform for frame in frames for transform in tree.frames[frame].nodes), end], path
        )

    def parts(self, rates: Row, accelerations: Row) -> list[FieldPart]:
        """What the coordinates on the way do to its end, in the axes there."""
        found: list[FieldPart] = []
        motion = FrameMotion(zeros(), zeros(), zeros())
        for transform in self.transforms:
            before, motion = motion, transform.motion(motion, rates, accelerations)
            moved = TransformState(before, motion, rates, accelerations)
            found = [FieldPart(part.shares, part.field.after(transform, moved)) for part in found] + parts_of(
                transform, moved
            )
        return found


@dataclass(frozen=True)
class Loop:
    """A spherical joint between the ends of two ways from the same frame; base: the way to that, whose rates do not
    count: what is closed in its axes is closed in those of the world, in which the rows are.
    """

    a: MarkerWay
    b: MarkerWay
    base: Path

    def rows(self, rates: Row, accelerations: Row) -> tuple[list[Row], list[Row]]:
        """(dC_q/dt, d^2 C_q/dt^2) by row and column."""
        first: list[Row] = [{}, {}, {}]
        second: list[Row] = [{}, {}, {}]
        for way, back in ((self.a, True), (self.b, False)):
            for part in way.parts(rates, accelerations):
                for rows, vector in ((first, part.field.moving[1]), (second, part.field.moving[2])):
                    for row, value in zip(rows, self.base.along(way.path.along(vector)), strict=True):
                        for column, share in part.shares.items():
                            own = mul(share, value)
                            add_to(row, column, neg(own) if back else own)
        return first, second


@dataclass(frozen=True)
class _Step:
    """A transform on the way to a frame, with what its coordinates do to it; bending: where modes move a marker."""

    transform: Node
    parts: list[FieldPart]
    bending: BendChanges | None

    def after(self, transform: Node, moved: TransformState) -> _Step:
        """For the frame after a further transform."""
        carried = [FieldPart(part.shares, part.field.after(transform, moved)) for part in self.parts]
        return _Step(self.transform, carried, self.bending)


def _step(transform: Node, moved: TransformState) -> _Step:
    if isinstance(transform, MarkerNode):
        bending = BendChanges(transform, moved)
        return _Step(transform, bending.parts, bending)
    return _Step(transform, joint_parts(transform, moved), None)


@dataclass
class FramePlace:
    """Where a frame's masses are looked at: its steps and motion; what moves its masses; forces of joints on it."""

    steps: list[_Step]
    motion: FrameMotion
    state: Subtree | None = None
    forces: list[tuple[Vector, Vector]] = field(default_factory=list)  # (arm, force) in the axes here

    @property
    def parts(self) -> list[FieldPart]:
        """What the coordinates on the way do to the frame."""
        return [part for step in self.steps for part in step.parts]

    @cached_property
    def wrench(self) -> Force:
        """That moves the masses, less the forces of joints."""
        found = NOTHING if self.state is None else self.state.wrench
        for arm, force in self.forces:
            found = found.plus(Force(negative(force), negative(cross(arm, force))))
        return found

    def after(self, transform: Node, rates: Row, accelerations: Row) -> FramePlace:
        """After a transform; without masses."""
        after = transform.motion(self.motion, rates, accelerations)
        moved = TransformState(self.motion, after, rates, accelerations)
        return FramePlace([*(step.after(transform, moved) for step in self.steps), _step(transform, moved)], after)

    def changed(self, change: Change, more: Force) -> Force:
        """Of the wrench that moves the masses, by a change of the motion and a further change."""
        return more if self.state is None else self.state.tangent.wrench(change).plus(more)

    def rotated_forces(self, tau: Vector) -> Force:
        """Change of the wrench of the forces of joints, as seen in a frame that turns by tau."""
        found = NOTHING
        for arm, force in self.forces:
            rotation = cross(tau, force)
            found = found.plus(Force(rotation, cross(arm, rotation)))
        return found

    def carried(self, directions: Sequence[Direction]) -> list[list[ca.SX]]:
        """sum over c of k_c'c S_cj, by part c' and direction j."""
        parts = self.parts
        shares = [[share_of(part, direction.S) for direction in directions] for part in parts]
        return [
            [dot(row, [shares[c][j] for c in range(len(parts))]) for j in range(len(directions))]
            for row in self._geometric
        ]

    @cached_property
    def _geometric(self) -> list[list[ca.SX]]:
        """k of parts, in their order."""
        parts, wrench = self.parts, self.wrench
        found = [[ZERO] * len(parts) for _ in parts]
        start = 0
        for step in self.steps:
            for place, part in enumerate(step.parts, start):
                carried = cross_wrench(part.field.twist, wrench)
                for earlier in range(start):
                    found[earlier][place] = carried.along(parts[earlier].field.twist)
            start += len(step.parts)
        end, rest = len(parts), wrench
        for step in reversed(self.steps):
            if not any(one.bending is not None for one in self.steps):
                break
            end -= len(step.parts)
            if step.bending is not None:
                for i, row in enumerate(step.bending.among(rest)):
                    found[end + i][end : end + len(row)] = row
            rest = step.transform.wrench(rest)
        return found


@dataclass(frozen=True)
class _End:
    """Of a joint, with the force on it in the axes of its frame."""

    own: MarkerWay
    other: MarkerWay
    force: Vector


def loop_changes(
    tree: FrameTree,
    n: int,
    base: Vector,
    moving: tuple[Row, Row],
    loops: Sequence[tuple[Loop, Vector]],
    directions: Sequence[Direction],
) -> tuple[ca.SX, ca.SX] | None:
    """F_q and F_v (n x directions), of which S^T F_q and S^T F_v are the derivatives by all x and x'.

    moving: rates and accelerations of the coordinates by column. loops: each with its force in world axes. None where
    several joints bind deformed markers of a body, or ways do not begin at the ground.
    """
    if not loops or any(way.base != GROUND for loop, _ in loops for way in (loop.a, loop.b)):
        return None
    sums = _Sums(tree, n, base, moving, directions)
    for k, frame in enumerate(tree.frames):
        ends = [end for loop, force in loops for end in _ends(loop, force) if end.own.frame == k]
        if len(ends) > 1 and any(isinstance(end.own.end, MarkerNode) for end in ends):
            return None
        if frame.inertia is not None or ends:
            sums.add(k, ends)
    return _matrix(sums.F_q), _matrix(sums.F_v)


def _matrix(rows: list[Vector]) -> ca.SX:
    return ca.sparsify(ca.vertcat(*(ca.horzcat(*row) for row in rows)))


def _ends(loop: Loop, given: Vector) -> list[_End]:
    found = []
    for own, other, force in ((loop.a, loop.b, given), (loop.b, loop.a, negative(given))):
        found.append(_End(own, other, [dot(axis, force) for axis in own.path.axes]))
    return found


class _Sums:
    """F_q and F_v are the result, by column and direction."""

    def __init__(
        self, tree: FrameTree, n: int, base: Vector, moving: tuple[Row, Row], directions: Sequence[Direction]
    ) -> None:
        self._tree, self._moving, self._directions = tree, moving, directions
        self._sweep = ForceSweep(n, *moving)
        self._ground = FramePlace([], FrameMotion(zeros(), zeros(), base))
        self._places: list[FramePlace] = []
        for frame in tree.frames:
            place = self._place(frame.parent)
            for transform in frame.nodes:
                place = place.after(transform, *moving)
            self._places.append(place)
        self.F_q, self.F_v = ([zeros(len(directions)) for _ in range(n)] for _ in range(2))

    def _place(self, frame: int) -> FramePlace:
        return self._ground if frame == GROUND else self._places[frame]

    def add(self, k: int, ends: list[_End]) -> None:
        """What a frame adds, with the forces of joints on it."""
        inertia, place = self._tree.frames[k].inertia, self._places[k]
        state = None if inertia is None else self._sweep.body(inertia, place.motion)
        transformed = FramePlace(place.steps, place.motion, state)
        closed = len(ends) == 1 and len(place.parts) > len(self._place(ends[0].other.frame).parts)
        if len(ends) == 1 and (closed or isinstance(inertia, FlexibleNode)):
            transformed = self._at_marker(transformed, ends[0])
        else:
            forces = [(end.own.end.r, end.force) for end in ends if isinstance(end.own.end, JointNode)]
            transformed = FramePlace(place.steps, place.motion, state, forces)
        fields = [field_along(direction, transformed.parts) for direction in self._directions]
        if closed:
            fields = self._closed(fields, ends[0])
        self._contract(transformed, fields, self._powers(transformed, fields, closed))

    def _at_marker(self, place: FramePlace, end: _End) -> FramePlace:
        """The same masses looked at from the marker of a joint."""
        after = place.after(end.own.end, *self._moving)
        transformed = replace(after, state=place.state, forces=[(zeros(), end.force)])
        if place.state is not None:
            transform = end.own.end
            back = (
                replace(transform, back=True)
                if isinstance(transform, MarkerNode)
                else JointNode(r=negative(transform.r))
            )
            self._sweep.through(back, TransformState(transformed.motion, place.motion, *self._moving), place.state)
        return transformed

    def _closed(self, fields: list[Field], end: _End) -> list[Field]:
        """With v as the joint's other body gives it."""
        other = self._place(end.other.frame).after(end.other.end, *self._moving)
        found = []
        for known, direction in zip(fields, self._directions, strict=True):
            v, v1, v2 = (
                [dot(axis, end.other.path.along(vector)) for axis in end.own.path.axes]
                for vector in field_along(direction, other.parts).moving
            )
            found.append(Field(known.rotation, (v, v1, v2)))
        return found

    def _contract(self, place: FramePlace, fields: list[Field], powers: list[tuple[Row, Motion]]) -> None:
        geometric, state = place.carried(self._directions), place.state
        for j, (one, direction) in enumerate(zip(fields, self._directions, strict=True)):
            by_position, by_rate = one.by_position(place.motion.a), one.by_rate
            more_q, more_v = place.rotated_forces(one.rotation[0]), NOTHING
            if state is not None and direction.column in state.rows:
                more_q = more_q.plus(state.by_position[direction.column])
                more_v = more_v.plus(state.by_rate[direction.column])
            for F, change, more in ((self.F_q, by_position, more_q), (self.F_v, by_rate, more_v)):
                w = place.changed(change, more)
                for shares, twist in powers:
                    _share(F, j, shares, w.along(twist))
                for column, row in state.rows.items() if state is not None else ():
                    F[column][j] = add(F[column][j], row.of(change))
            for part, values in zip(place.parts, geometric, strict=True):
                _share(self.F_q, j, part.shares, values[j])
            for column in state.rows if state is not None else ():
                for F, known in ((self.F_q, self._sweep.K), (self.F_v, self._sweep.D)):
                    F[column][j] = add(F[column][j], known[column].get(direction.column, ZERO))

    def _powers(self, place: FramePlace, fields: list[Field], closed: bool) -> list[tuple[Row, Motion]]:
        """Shares and twists of coordinates on the way; where the way is closed by fields, of the directions."""
        if not closed:
            return [(part.shares, part.field.twist) for part in place.parts]
        found = zip(self._directions, fields, strict=True)
        return [({direction.column: ONE}, one.twist) for direction, one in found]


def _share(F: list[Vector], j: int, shares: Row, value: ca.SX) -> None:
    for column, share in shares.items():
        F[column][j] = add(F[column][j], mul(share, value))
