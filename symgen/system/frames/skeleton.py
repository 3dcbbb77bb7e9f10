"""From bodies and the joints that place them to the tree of frames.

A rigid body's frame stands on its inboard hinge, its x-axis along the common normal to the hinge of its first child,
its origin at the foot: then the way to that child is two screws. What is on a hinge's axis, a mass, its first and its
second moment along it, moves with either of the two bodies: it is counted with the parent (`sharing`), and on the
ground not at all.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import casadi as ca

from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import identity, zeros
from symgen.bodies.deformation import Deformation
from symgen.bodies.spatial_body import SpatialBody
from symgen.system.frames.ball import Across, Ball, ToWorld
from symgen.system.frames.body_moves import Bend, Float, Orient, Unbend
from symgen.system.frames.flexible import FlexibleInertia, RigidInertia
from symgen.system.frames.linkage import JointLink
from symgen.system.frames.motion import Composite, Matrix, no_masses
from symgen.system.frames.moves import Fixed, Move
from symgen.system.frames.screws import STRAIGHT, Displacement, Screw, between_hinges
from symgen.system.frames.sharing import give_to_parent
from symgen.system.frames.tree import GROUND, Frame, FrameTree, Seat
from symgen.system.orientations import Turning

Numbers = Callable[[ca.SX], float]


@dataclass
class _Rough:
    """A frame before it is aligned: its way from the parent is a link, or moves; `screw` aligns it."""

    parent: int
    link: JointLink | None = None
    moves: list[Move] = field(default_factory=list)
    inertia: RigidInertia | FlexibleInertia | None = None
    screw: Screw = field(default_factory=Screw)
    aligned: bool = False
    aligns: bool = False

    @property
    def turnable(self) -> bool:
        """May its axes be chosen?"""
        return self.link is not None and self.link.hinged and not isinstance(self.inertia, FlexibleInertia)


class Skeleton:
    """Collects bodies, parents first; `tree` is the result."""

    def __init__(self, numbers: Numbers) -> None:
        self._rough: list[_Rough] = []
        self._seats: dict[str, Seat] = {"ground": Seat()}
        self._numbers = numbers

    def float(self, body: SpatialBody, turning: Turning | None) -> None:
        """A body that no joint places. Its mass stands at its origin, which moves without turning."""
        q, data = body.coordinates, body.integrals
        assert data is not None
        point = Composite(data.mass, zeros(), no_masses().Sigma)
        floats = Float(q.columns[:3], q.R_o, q.R_o_dot)
        self._add(_Rough(GROUND, moves=[floats], inertia=RigidInertia(point)))
        turns: Move = Orient(q.turning, q.theta, q.theta_dot) if turning is None else _ball(turning)
        self._add(_Rough(len(self._rough) - 1, moves=[turns], inertia=_inertia(body, ZERO)))
        self._seats[body.name] = Seat(len(self._rough) - 1)

    def place(
        self,
        body: SpatialBody,
        parent: str,
        links: Callable[[Displacement], tuple[list[JointLink], Displacement]],
        near: Deformation,
        far: Deformation,
    ) -> None:
        """A body on a joint: links gives them from the displacement of the near marker.

        near, far: the joint's markers on the parent and on the body.
        """
        frame, before = self._at(parent, near)
        chain, beyond = links(before)
        for link in chain:
            self._add(_Rough(frame, link))
            frame = len(self._rough) - 1
        data = body.integrals
        assert data is not None
        if not far.rigid:
            self._add(_Rough(frame, JointLink(beyond)))
            frame = len(self._rough) - 1
            self._add(_Rough(frame, moves=_from_marker(far), inertia=_inertia(body, data.mass)))
            self._seats[body.name] = Seat(len(self._rough) - 1)
            return
        place = beyond.then(_marker(far).back())
        if data.nf:
            self._add(_Rough(frame, JointLink(place), inertia=_inertia(body, data.mass)))
            self._seats[body.name] = Seat(len(self._rough) - 1)
            return
        if frame == GROUND or isinstance(self._rough[frame].inertia, FlexibleInertia):
            self._add(_Rough(frame, JointLink(place)))
            frame, place = len(self._rough) - 1, Displacement.none()
        own = moved(Composite(data.mass, data.S1, data.J0), place)
        known = self._rough[frame].inertia
        self._rough[frame].inertia = RigidInertia(own if known is None else known.rigid.plus(own))
        self._seats[body.name] = Seat(frame, place)

    def hold(
        self,
        body: SpatialBody,
        parent: str,
        turning: Turning,
        near: Deformation,
        far: Deformation,
        axes: Callable[[], Matrix],
    ) -> None:
        """A body on a spherical joint, turning by itself: its frame is at the joint. axes: the parent's, by rows.

        near, far: the joint's markers, of which only the place counts.
        """
        frame, before = self._at(parent, place_of(near))
        holder = self._rough[frame].moves[-1:] if frame != GROUND else []
        if holder and isinstance(holder[0], Ball):
            moves: list[Move] = [Across(before.r, holder[0].A), _ball(turning)]
        else:
            self._add(_Rough(frame, JointLink(before), inertia=RigidInertia(no_masses())))
            frame, moves = len(self._rough) - 1, [ToWorld(axes), _ball(turning)]
        data, at = body.integrals, place_of(far)
        assert data is not None
        if data.nf:
            moves = [*moves, *_from_marker(at)]
            place, inertia = Displacement.none(), _inertia(body, data.mass)
        else:
            place = _marker(at).back()
            inertia = RigidInertia(moved(Composite(data.mass, data.S1, data.J0), place))
        self._add(_Rough(frame, moves=moves, inertia=inertia))
        self._seats[body.name] = Seat(len(self._rough) - 1, place)

    def _add(self, rough: _Rough) -> None:
        self._rough.append(rough)

    def _at(self, body: str, marker: Deformation) -> tuple[int, Displacement]:
        """The frame that carries a marker, and the marker's displacement there."""
        seat = self._seats[body]
        if marker.rigid:
            return seat.frame, seat.place.then(_marker(marker))
        self._add(_Rough(seat.frame, moves=_to_marker(marker)))
        return len(self._rough) - 1, Displacement.none()

    # ---- alignment -------------------------------------------------------------------------------------------

    def tree(self) -> FrameTree:
        """The frames on their hinges, inertia gathered towards the ground."""
        self._align()
        frames = [Frame(rough.parent, self._moves(rough), _aligned(rough)) for rough in self._rough]
        for frame in reversed(frames):
            give_to_parent(frame, frames)
        seats = {name: self._seated(seat) for name, seat in self._seats.items()}
        return FrameTree(frames, seats)

    def _align(self) -> None:
        """Each frame by the hinge of its first child."""
        for rough in self._rough:
            if rough.parent == GROUND or rough.link is None or not rough.link.hinged:
                continue
            parent = self._rough[rough.parent]
            if parent.turnable and not parent.aligned and not self._straight(rough.link):
                parent.aligned = rough.aligns = True
                parent.screw = between_hinges(rough.link.before).start

    def _moves(self, rough: _Rough) -> list[Move]:
        link = rough.link
        if link is None:
            return rough.moves
        if rough.aligns:
            return link.moves(replace(between_hinges(link.before), start=Screw()), rough.screw)
        before = link.before
        if rough.parent != GROUND:
            before = self._rough[rough.parent].screw.displacement.back().then(before)
        if link.constant:
            return [Fixed(before.R, before.r)]
        return link.moves(before if self._straight(link) else between_hinges(before), rough.screw)

    def _straight(self, link: JointLink) -> bool:
        """Are the axes before and beyond almost parallel, but not so by structure?"""
        x, y = link.before.R[0][2], link.before.R[1][2]
        if x.is_zero() and y.is_zero():
            return False
        return self._numbers(ca.sqrt(x * x + y * y)) < STRAIGHT

    def _seated(self, seat: Seat) -> Seat:
        if seat.frame == GROUND:
            return seat
        return Seat(seat.frame, self._rough[seat.frame].screw.displacement.back().then(seat.place))


def _to_marker(marker: Deformation) -> list[Move]:
    """From the frame of a flexible body: to where the marker is, then to its axes."""
    shifts, turns = _apart(marker)
    return [Bend(shifts), Bend(turns)]


def _from_marker(marker: Deformation) -> list[Move]:
    """To the frame of a flexible body: to its axes, then to its origin."""
    shifts, turns = _apart(marker)
    return [Unbend(turns), Unbend(shifts)]


def _apart(marker: Deformation) -> tuple[Deformation, Deformation]:
    """How the modes shift a marker, and how they turn it: each part has fewer entries than both together."""
    point, still = marker.point, [zeros() for _ in marker.point.turns]
    shifts = replace(point, axes=identity(), turns=still)
    turns = replace(point, position=zeros(), shapes=still, H=[])
    return replace(marker, point=shifts), replace(marker, point=turns)


def _ball(turning: Turning) -> Ball:
    return Ball(turning.columns, turning.A, turning.omega)


def place_of(marker: Deformation) -> Deformation:
    """A marker whose axes are those of its body, however it is bent."""
    point = replace(marker.point, axes=identity(), turns=[zeros() for _ in marker.point.turns])
    return replace(marker, point=point)


def _marker(marker: Deformation) -> Displacement:
    return Displacement(marker.point.axes, marker.point.position)


def _inertia(body: SpatialBody, mass: ca.SX) -> RigidInertia | FlexibleInertia:
    data = body.integrals
    assert data is not None
    if data.nf:
        return FlexibleInertia(replace(data, mass=mass), body.coordinates.q_f, body.coordinates.elastic)
    return RigidInertia(Composite(mass, data.S1, data.J0))


def _aligned(rough: _Rough) -> RigidInertia | FlexibleInertia | None:
    if not isinstance(rough.inertia, RigidInertia):
        return rough.inertia
    return RigidInertia(moved(rough.inertia.rigid, rough.screw.displacement.back()))


def moved(inertia: Composite, place: Displacement) -> Composite:
    """Inertia in the axes and about the origin from which its own frame is displaced."""
    return inertia.turned(place.R).shifted(place.r)
