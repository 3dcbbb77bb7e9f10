"""Alignment: frames that stand where a tree of bodies costs few operations. A rewrite of a tree, not of its meaning.

A rigid body's frame stands on its inboard hinge, its x-axis along the common normal to the hinge of its first child,
its origin at the foot: then the way to that child is two screws.

Inertia on the axis of a hinge moves with the parent as well. A hinge turns nothing of a mass distribution on its own
axis, given by its mass, its first and its second moment along it; a slide leaves the second moments about a centre of
mass as they are. Counted with the parent they cost nothing, because inertia that is fixed in a frame is gathered in
`constants`, and on the ground not at all.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import casadi as ca

from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import zeros
from symgen.system.frames.linkage import STRAIGHT, JointLink, Screw, between_hinges
from symgen.system.frames.moves import Ball, JointNode, Move, Orient
from symgen.system.frames.spatial_algebra import SE3, Inertia
from symgen.system.frames.tree import GROUND, BodyFrame, FlexibleNode, Frame, FrameTree, RigidNode

Numbers = Callable[[ca.SX], float]


@dataclass
class UnalignedFrame:
    """A frame as the joints give it: its way from the parent is a link, or moves."""

    parent: int
    link: JointLink | None = None
    moves: list[Move] = field(default_factory=list)
    inertia: RigidNode | FlexibleNode | None = None

    @property
    def turnable(self) -> bool:
        """May its axes be chosen?"""
        return self.link is not None and self.link.hinged and not isinstance(self.inertia, FlexibleNode)


def aligned(frames: Sequence[UnalignedFrame], seats: Mapping[str, BodyFrame], numbers: Numbers) -> FrameTree:
    """The tree with its frames on their hinges, inertia gathered towards the ground. numbers: values at defaults."""
    way = _Alignment(frames, numbers)
    found = [Frame(frame.parent, way.moves(k), way.inertia(k)) for k, frame in enumerate(frames)]
    for one in reversed(found):
        give_to_parent(one, found)
    return FrameTree(found, {name: way.seated(seat) for name, seat in seats.items()})


class _Alignment:
    """Each frame turned and shifted by a screw, by the hinge of its first child that is not almost parallel."""

    def __init__(self, frames: Sequence[UnalignedFrame], numbers: Numbers) -> None:
        self._frames, self._numbers = frames, numbers
        self._screws: dict[int, Screw] = {}
        self._leading: set[int] = set()  # the children that chose
        for k, frame in enumerate(frames):
            if frame.parent == GROUND or frame.link is None or not frame.link.hinged:
                continue
            chosen = frame.parent in self._screws
            if frames[frame.parent].turnable and not chosen and not self._straight(frame.link):
                self._screws[frame.parent] = between_hinges(frame.link.before).start
                self._leading.add(k)

    def _screw(self, k: int) -> Screw:
        return self._screws.get(k, Screw())

    def moves(self, k: int) -> list[Move]:
        """From the parent to frame k."""
        frame, link = self._frames[k], self._frames[k].link
        if link is None:
            return frame.moves
        if k in self._leading:
            return link.moves(replace(between_hinges(link.before), start=Screw()), self._screw(k))
        before = link.before
        if frame.parent != GROUND:
            before = self._screw(frame.parent).displacement.inverse() * before
        if link.constant:
            return [JointNode(R=before.R, r=before.r)]
        return link.moves(before if self._straight(link) else between_hinges(before), self._screw(k))

    def _straight(self, link: JointLink) -> bool:
        """Are the axes before and beyond almost parallel, but not so by structure?"""
        x, y = link.before.R[0][2], link.before.R[1][2]
        if x.is_zero() and y.is_zero():
            return False
        return self._numbers(ca.sqrt(x * x + y * y)) < STRAIGHT

    def inertia(self, k: int) -> RigidNode | FlexibleNode | None:
        """Of frame k."""
        own = self._frames[k].inertia
        if not isinstance(own, RigidNode):
            return own
        return RigidNode(moved(own.rigid, self._screw(k).displacement.inverse()))

    def seated(self, seat: BodyFrame) -> BodyFrame:
        """Where a body is."""
        if seat.frame == GROUND:
            return seat
        return BodyFrame(seat.frame, self._screw(seat.frame).displacement.inverse() * seat.place)


@dataclass(frozen=True)
class Parts:
    """Inertia split in what the parent can have and what is left."""

    given: Inertia
    kept: Inertia


def give_to_parent(frame: Frame, frames: list[Frame]) -> None:
    """Give the parent what it can have, if it has inertia of a rigid body itself."""
    if not isinstance(frame.inertia, RigidNode):
        return
    parts = _split(frame.inertia.rigid, frame.moves)
    if parts is None:
        return
    given = parts.given
    for move in reversed(frame.moves):
        if not move.twists:
            given = move.composite(given)
    if frame.parent != GROUND:
        parent = frames[frame.parent]
        if not isinstance(parent.inertia, RigidNode):
            return
        parent.inertia = RigidNode(parent.inertia.rigid.plus(given))
    frame.inertia = RigidNode(parts.kept)


def _split(inertia: Inertia, moves: list[Move]) -> Parts | None:
    """By what the moves leave free; None where nothing can be given."""
    free = [move for move in moves if move.twists]
    if not all(isinstance(move, JointNode | Orient | Ball) for move in free):
        return None
    if any(isinstance(move, Orient | Ball) for move in free):  # a mass at the origin does not care how the frame turns
        return Parts(Inertia(inertia.m, zeros(), [zeros() for _ in range(3)]), Inertia(ZERO, inertia.h, inertia.Sigma))
    turns = any(isinstance(move, JointNode) and move.turns for move in free)
    slides = any(isinstance(move, JointNode) and not move.turns for move in free)
    if slides and not turns:
        return Parts(Inertia(ZERO, zeros(), inertia.Sigma), Inertia(inertia.m, inertia.h, [zeros() for _ in range(3)]))
    along = [zeros() for _ in range(3)]
    along[2][2] = inertia.Sigma[2][2]
    rest = [list(row) for row in inertia.Sigma]
    rest[2][2] = ZERO
    if slides:
        return Parts(Inertia(ZERO, zeros(), along), Inertia(inertia.m, inertia.h, rest))
    x, y, z = inertia.h
    return Parts(Inertia(inertia.m, [ZERO, ZERO, z], along), Inertia(ZERO, [x, y, ZERO], rest))


def moved(inertia: Inertia, place: SE3) -> Inertia:
    """Inertia in the axes and about the origin from which its own frame is displaced."""
    return inertia.turned(place.R).shifted(place.r)
