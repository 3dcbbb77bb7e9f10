"""From bodies and the joints that place them to frames, one at each joint and at each deformed marker."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import casadi as ca

from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import Matrix, identity, zeros
from symgen.bodies.spatial_body import SpatialBody
from symgen.bodies.spatial_moments import Deformation
from symgen.system.frames.alignment import JointLink, Numbers, UnalignedFrame, aligned, moved
from symgen.system.frames.joint_transforms import Across, Ball, Float, JointTransform, MarkerNode, ToWorld
from symgen.system.frames.spatial_algebra import SE3, Inertia, no_masses
from symgen.system.frames.tree import GROUND, BodyFrame, FlexibleNode, FrameTree, RigidNode
from symgen.system.orientations import RotationVector


class Skeleton:
    """Collects bodies, parents first; `tree` is the result."""

    def __init__(self, numbers: Numbers) -> None:
        self._rough: list[UnalignedFrame] = []
        self._body_frames: dict[str, BodyFrame] = {"ground": BodyFrame()}
        self._numbers = numbers

    def float(self, body: SpatialBody, rotation: RotationVector) -> None:
        """A body that no joint places. Its mass stands at its origin, which moves without turning."""
        q, data = body.coordinates, body.integrals
        assert data is not None
        point = Inertia(data.mass, zeros(), no_masses().Sigma)
        floats = Float(q.columns[:3], q.R_o, q.R_o_dot)
        self._add(UnalignedFrame(GROUND, transforms=[floats], inertia=RigidNode(point)))
        self._add(UnalignedFrame(len(self._rough) - 1, transforms=[_ball(rotation)], inertia=_inertia(body, ZERO)))
        self._body_frames[body.name] = BodyFrame(len(self._rough) - 1)

    def place(
        self,
        body: SpatialBody,
        parent: str,
        links: Callable[[SE3], tuple[list[JointLink], SE3]],
        near: Deformation,
        far: Deformation,
    ) -> None:
        """A body on a joint: links gives them from the displacement of the near marker.

        near, far: the joint's markers on the parent and on the body.
        """
        frame, before = self._at(parent, near)
        chain, rest = links(before)
        for link in chain:
            self._add(UnalignedFrame(frame, link))
            frame = len(self._rough) - 1
        data = body.integrals
        assert data is not None
        if not far.rigid:
            self._add(UnalignedFrame(frame, JointLink(rest)))
            frame = len(self._rough) - 1
            self._add(UnalignedFrame(frame, transforms=[MarkerNode(far, back=True)], inertia=_inertia(body, data.mass)))
            self._body_frames[body.name] = BodyFrame(len(self._rough) - 1)
            return
        place = rest * _marker(far).inverse()
        if data.nf:
            self._add(UnalignedFrame(frame, JointLink(place), inertia=_inertia(body, data.mass)))
            self._body_frames[body.name] = BodyFrame(len(self._rough) - 1)
            return
        if frame == GROUND or isinstance(self._rough[frame].inertia, FlexibleNode):
            self._add(UnalignedFrame(frame, JointLink(place)))
            frame, place = len(self._rough) - 1, SE3.identity()
        own = moved(Inertia(data.mass, data.S1, data.J0), place)
        known = self._rough[frame].inertia
        self._rough[frame].inertia = RigidNode(own if known is None else known.rigid.plus(own))
        self._body_frames[body.name] = BodyFrame(frame, place)

    def hold(
        self,
        body: SpatialBody,
        parent: str,
        rotation: RotationVector,
        near: Deformation,
        far: Deformation,
        axes: Callable[[], Matrix],
    ) -> None:
        """A body on a spherical joint, turning by itself: its frame is at the joint. axes: the parent's, by rows.

        near, far: the joint's markers, of which only the place counts.
        """
        frame, before = self._at(parent, place_of(near))
        holder = self._rough[frame].transforms[-1:] if frame != GROUND else []
        if holder and isinstance(holder[0], Ball):
            transforms: list[JointTransform] = [Across(before.r, holder[0].A), _ball(rotation)]
        else:
            self._add(UnalignedFrame(frame, JointLink(before), inertia=RigidNode(no_masses())))
            frame, transforms = len(self._rough) - 1, [ToWorld(axes), _ball(rotation)]
        data, at = body.integrals, place_of(far)
        assert data is not None
        if data.nf:
            transforms = [*transforms, MarkerNode(at, back=True)]
            place, inertia = SE3.identity(), _inertia(body, data.mass)
        else:
            place = _marker(at).inverse()
            inertia = RigidNode(moved(Inertia(data.mass, data.S1, data.J0), place))
        self._add(UnalignedFrame(frame, transforms=transforms, inertia=inertia))
        self._body_frames[body.name] = BodyFrame(len(self._rough) - 1, place)

    def _add(self, rough: UnalignedFrame) -> None:
        self._rough.append(rough)

    def _at(self, body: str, marker: Deformation) -> tuple[int, SE3]:
        """The frame that carries a marker, and the marker's displacement there."""
        known = self._body_frames[body]
        if marker.rigid:
            return known.frame, known.place * _marker(marker)
        self._add(UnalignedFrame(known.frame, transforms=[MarkerNode(marker)]))
        return len(self._rough) - 1, SE3.identity()

    def tree(self) -> FrameTree:
        """The frames on their hinges."""
        return aligned(self._rough, self._body_frames, self._numbers)


def _ball(rotation: RotationVector) -> Ball:
    return Ball(rotation.columns, rotation.A, rotation.omega)


def place_of(marker: Deformation) -> Deformation:
    """A marker whose axes are those of its body, however it is deformed."""
    point = replace(marker.point, axes=identity(), turns=[zeros() for _ in marker.point.turns])
    return replace(marker, point=point)


def _marker(marker: Deformation) -> SE3:
    return SE3(marker.point.axes, marker.point.position)


def _inertia(body: SpatialBody, mass: ca.SX) -> RigidNode | FlexibleNode:
    data = body.integrals
    assert data is not None
    if data.nf:
        return FlexibleNode(replace(data, mass=mass), body.coordinates.q_f, body.coordinates.elastic)
    return RigidNode(Inertia(mass, data.S1, data.J0))
