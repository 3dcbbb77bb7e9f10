"""Alignment: frames that stand where a tree of bodies costs few operations. A rewrite of a tree, not of its meaning.

A rigid body's frame stands on its inboard hinge, its x-axis along the common normal to the hinge of its first child,
its origin at the foot: then the way to that child is two screws.

Inertia on the axis of a hinge moves with the parent as well. A hinge turns nothing of a mass distribution on its own
axis, given by its mass, its first and its second moment along it; a slide leaves the second moments about a centre of
mass as they are. Counted with the parent they cost nothing, because inertia that is fixed in a frame is gathered in
`constants`, and on the ground not at all.

How placing joints link frames: constant displacements and variable transforms about and along z, one hinge a link.

Constant displacements between frames, written with as few operations as a frame on a hinge axis allows.

From a hinge along z to the next one: a rotation psi about z and a shift e along it, a shift along the common normal
(the new x), a rotation alpha about it, a rotation and a shift about and along the new z. The first two are nothing when
the frame on the first hinge has its x-axis along the common normal, its origin at the foot.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub
from symgen.algebra.vectors import Matrix, Vector, cross, plus, scaled, zeros
from symgen.joints.joint import Turn
from symgen.system.frames.joint_transforms import Ball, JointNode, JointTransform
from symgen.system.frames.spatial_algebra import SE3, Inertia
from symgen.system.frames.tree import GROUND, BodyFrame, FlexibleNode, Frame, FrameTree, RigidNode
from symgen.system.joint_templates import JointCoordinate, JointCoordinates

STRAIGHT = 0.02  # sine of the angle between two axes below which their common normal may be far away


@dataclass(frozen=True)
class FixedAngle:
    """Cosine and sine of a constant angle."""

    cosine: ca.SX = ONE
    sine: ca.SX = ZERO

    def plus(self, other: FixedAngle) -> FixedAngle:
        """The sum."""
        return FixedAngle(
            sub(mul(self.cosine, other.cosine), mul(self.sine, other.sine)),
            add(mul(self.sine, other.cosine), mul(self.cosine, other.sine)),
        )

    @property
    def nothing(self) -> bool:
        """Is it zero by structure?"""
        return self.cosine.is_one() and self.sine.is_zero()

    def with_coordinate(self, value: ca.SX, sign: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Cosine and sine of the angle plus sign times a coordinate; a right angle costs no addition."""
        if self.cosine.is_constant() and self.sine.is_constant():
            cosine, sine = ca.cos(value), mul(sign, ca.sin(value))
            moved = self.plus(FixedAngle(cosine, sine))
            return moved.cosine, moved.sine
        offset = ca.atan2(self.sine, self.cosine)
        whole = add(value, mul(sign, offset))
        return ca.cos(whole), mul(sign, ca.sin(whole))


@dataclass(frozen=True)
class Screw:
    """A rotation about an axis and a shift along it."""

    angle: FixedAngle = FixedAngle()
    shift: ca.SX = ZERO

    @property
    def displacement(self) -> SE3:
        """About z."""
        c, s = self.angle.cosine, self.angle.sine
        return SE3([[c, neg(s), ZERO], [s, c, ZERO], [ZERO, ZERO, ONE]], [ZERO, ZERO, self.shift])


@dataclass(frozen=True)
class BetweenHinges:
    """start about z, a shift and a rotation about the common normal (`across`), end about the new z."""

    start: Screw
    across: Screw
    end: Screw
    offset: Vector  # a shift across the first axis before the others, where the axes are parallel


def between_hinges(displacement: SE3) -> BetweenHinges:
    """The screws of a constant displacement between axes that are parallel by structure, or not at all."""
    R, r = displacement.R, displacement.r
    z = [row[2] for row in R]
    normal = _normal(z)
    if normal is None:
        return _parallel(R, r, z[2])
    n = [*normal[:2], ZERO]
    sine = normal[2]
    across = cross([ZERO, ZERO, ONE], n)
    turned = plus(scaled(z[2], across), [ZERO, ZERO, sine])  # the new z x n
    x = [row[0] for row in R]
    end = FixedAngle(dot(x, n), dot(x, turned))
    tilt = FixedAngle(z[2], sine)
    far = neg(div(dot(r, across), sine))
    start = sub(r[2], mul(far, z[2]))
    return BetweenHinges(Screw(FixedAngle(n[0], n[1]), start), Screw(tilt, dot(r, n)), Screw(end, far), zeros())


def _normal(z: Vector) -> Vector | None:
    """(cosine, sine) of the common normal in the xy-plane and the sine of the angle about it; None: parallel."""
    x, y = z[0], z[1]
    if x.is_zero() and y.is_zero():
        return None
    if x.is_zero():
        return [ONE, ZERO, neg(y)]
    if y.is_zero():
        return [ZERO, ONE, x]
    sine = ca.sqrt(add(mul(x, x), mul(y, y)))
    return [neg(div(y, sine)), div(x, sine), sine]


def _parallel(R: Matrix, r: Vector, cosine: ca.SX) -> BetweenHinges:
    """Axes that are parallel by structure: a shift in the plane across them."""
    x = [row[0] for row in R]
    end = FixedAngle(x[0], mul(cosine, x[1]))
    return BetweenHinges(Screw(shift=r[2]), Screw(FixedAngle(cosine)), Screw(end), [r[0], r[1], ZERO])


TO_Z = (  # axes whose z-axis is the old x-axis (columns y, z, x), or the old y-axis (columns z, x, y)
    SE3([[ZERO, ZERO, ONE], [ONE, ZERO, ZERO], [ZERO, ONE, ZERO]], [ZERO] * 3),
    SE3([[ZERO, ONE, ZERO], [ZERO, ZERO, ONE], [ONE, ZERO, ZERO]], [ZERO] * 3),
    None,
)


@dataclass(frozen=True)
class JointLink:
    """From a frame to the next: a constant displacement to the axis z, then what the joint leaves free.

    turn, travel: coordinates about and along z. sign: of the coordinates as they move the far frame. lead: travel of a
    screw for a unit of its angle.
    """

    before: SE3
    turn: JointCoordinate | None = None
    travel: JointCoordinate | None = None
    sign: ca.SX = ONE
    lead: ca.SX = ZERO

    @property
    def constant(self) -> bool:
        """Does nothing move?"""
        return self.turn is None and self.travel is None

    def transforms(self, way: BetweenHinges | SE3, last: Screw) -> list[JointTransform]:
        """As transforms to the frame that stands on the hinge, displaced by the screw `last`.

        way: the screws of the constant displacement, or the displacement itself where they are useless.
        """
        if isinstance(way, SE3):
            return [JointNode(R=way.R, r=way.r), *self._variable(Screw(), last)]
        transforms: list[JointTransform] = [
            *_constant(2, way.start),
            *(JointNode.slide(axis, value) for axis, value in enumerate(way.offset) if not value.is_zero()),
            *_constant(0, way.across, slide_first=True),
        ]
        return [*transforms, *self._variable(way.end, last)]

    def _variable(self, end: Screw, last: Screw) -> list[JointTransform]:
        shift = add(end.shift, last.shift)
        turn = self._turn(end.angle.plus(last.angle))
        return [*turn, *self._slide(shift)]

    def _turn(self, angle: FixedAngle) -> list[JointNode]:
        if self.turn is None:
            return [] if angle.nothing else [JointNode(2, (angle.cosine, angle.sine))]
        cosine, sine = angle.with_coordinate(self.turn.value, self.sign)
        return [JointNode(2, (cosine, sine), column=self.turn.column, rate=self.turn.rate, sign=self.sign)]

    def _slide(self, shift: ca.SX) -> list[JointNode]:
        own, factor = self.travel, self.sign
        if not self.lead.is_zero():
            own, factor = self.turn, mul(self.sign, self.lead)
        if own is None:
            return [] if shift.is_zero() else [JointNode.slide(2, shift)]
        return [JointNode.slide(2, add(shift, mul(factor, own.value)), own.column, own.rate, factor)]


def _constant(axis: int, screw: Screw, slide_first: bool = False) -> list[JointTransform]:
    turn = [] if screw.angle.nothing else [JointNode(axis, (screw.angle.cosine, screw.angle.sine))]
    slide = [] if screw.shift.is_zero() else [JointNode.slide(axis, screw.shift)]
    return [*slide, *turn] if slide_first else [*turn, *slide]


def links_of(own: JointCoordinates, before: SE3, forward: bool) -> tuple[list[JointLink], SE3]:
    """(links of a joint, constant displacement beyond the last one to the far marker).

    before: from the near frame to the near marker; forward: the near one is marker a.
    """
    sign = ONE if forward else neg(ONE)
    links, place = [], before
    groups = list(_groups(own))
    for axis, link in groups if forward else reversed(groups):
        aside = TO_Z[axis]
        links.append(replace(link, before=place if aside is None else place * aside, sign=sign))
        place = SE3.identity() if aside is None else aside.inverse()
    return links, place


def _groups(own: JointCoordinates) -> Iterator[tuple[int, JointLink]]:
    """(axis, what one link leaves free) of the motions in their order.

    A turn and a slide about one axis go together.
    """
    motions, found, k, start = own.motions, own.coordinates, 0, SE3.identity()
    while k < len(motions):
        here, after = motions[k], motions[k + 1] if k + 1 < len(motions) else None
        turns = isinstance(here, Turn)
        if after and after.axis == here.axis and turns is not isinstance(after, Turn) and not (here.lead or after.lead):
            turn, travel = (k, k + 1) if turns else (k + 1, k)
            yield here.axis, JointLink(start, found[turn], found[travel])
            k += 2
        else:
            alone = (found[k], None) if turns else (None, found[k])
            yield here.axis, JointLink(start, alone[0], alone[1], lead=own.leads[k])
            k += 1


Numbers = Callable[[ca.SX], float]


@dataclass
class UnalignedFrame:
    """A frame as the joints give it: its way from the parent is a link, or transforms."""

    parent: int
    link: JointLink | None = None
    transforms: list[JointTransform] = field(default_factory=list)
    inertia: RigidNode | FlexibleNode | None = None

    @property
    def turnable(self) -> bool:
        """May its axes be chosen?"""
        return self.link is not None and not self.link.constant and not isinstance(self.inertia, FlexibleNode)


def aligned(frames: Sequence[UnalignedFrame], body_frames: Mapping[str, BodyFrame], numbers: Numbers) -> FrameTree:
    """The tree with its frames on their hinges, inertia gathered towards the ground. numbers: values at defaults."""
    way = _Alignment(frames, numbers)
    found = [Frame(frame.parent, way.transforms(k), way.inertia(k)) for k, frame in enumerate(frames)]
    for one in reversed(found):
        give_to_parent(one, found)
    return FrameTree(found, {name: way.body_frame(known) for name, known in body_frames.items()})


class _Alignment:
    """Each frame turned and shifted by a screw, by the hinge of its first child that is not almost parallel."""

    def __init__(self, frames: Sequence[UnalignedFrame], numbers: Numbers) -> None:
        self._frames, self._numbers = frames, numbers
        self._screws: dict[int, Screw] = {}
        self._leading: set[int] = set()  # the children that chose
        for k, frame in enumerate(frames):
            if frame.parent == GROUND or frame.link is None or frame.link.constant:
                continue
            chosen = frame.parent in self._screws
            if frames[frame.parent].turnable and not chosen and not self._straight(frame.link):
                self._screws[frame.parent] = between_hinges(frame.link.before).start
                self._leading.add(k)

    def _screw(self, k: int) -> Screw:
        return self._screws.get(k, Screw())

    def transforms(self, k: int) -> list[JointTransform]:
        """From the parent to frame k."""
        frame, link = self._frames[k], self._frames[k].link
        if link is None:
            return frame.transforms
        if k in self._leading:
            return link.transforms(replace(between_hinges(link.before), start=Screw()), self._screw(k))
        before = link.before
        if frame.parent != GROUND:
            before = self._screw(frame.parent).displacement.inverse() * before
        if link.constant:
            return [JointNode(R=before.R, r=before.r)]
        return link.transforms(before if self._straight(link) else between_hinges(before), self._screw(k))

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

    def body_frame(self, known: BodyFrame) -> BodyFrame:
        """Where a body is."""
        if known.frame == GROUND:
            return known
        return BodyFrame(known.frame, self._screw(known.frame).displacement.inverse() * known.place)


@dataclass(frozen=True)
class Parts:
    """Inertia split in what the parent can have and what is left."""

    given: Inertia
    kept: Inertia


def give_to_parent(frame: Frame, frames: list[Frame]) -> None:
    """Give the parent what it can have, if it has inertia of a rigid body itself."""
    if not isinstance(frame.inertia, RigidNode):
        return
    parts = _split(frame.inertia.rigid, frame.transforms)
    if parts is None:
        return
    given = parts.given
    for transform in reversed(frame.transforms):
        if not transform.twists:
            given = transform.composite(given)
    if frame.parent != GROUND:
        parent = frames[frame.parent]
        if not isinstance(parent.inertia, RigidNode):
            return
        parent.inertia = RigidNode(parent.inertia.rigid.plus(given))
    frame.inertia = RigidNode(parts.kept)


def _split(inertia: Inertia, transforms: list[JointTransform]) -> Parts | None:
    """By what the transforms leave free; None where nothing can be given."""
    free = [transform for transform in transforms if transform.twists]
    if not all(isinstance(transform, JointNode | Ball) for transform in free):
        return None
    if any(isinstance(transform, Ball) for transform in free):  # a mass at the origin does not care how the frame turns
        return Parts(Inertia(inertia.m, zeros(), [zeros() for _ in range(3)]), Inertia(ZERO, inertia.h, inertia.Sigma))
    turns = any(isinstance(transform, JointNode) and transform.turns for transform in free)
    slides = any(isinstance(transform, JointNode) and not transform.turns for transform in free)
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
    return inertia.rotated(place.R).shifted(place.r)
