"""How placing joints link frames: constant displacements and variable moves about and along z, one hinge a link."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, mul, neg
from symgen.joints.joint import Slide as SlideOf
from symgen.joints.joint import Turn as TurnOf
from symgen.system.frames.moves import Fixed, Move, Slide, Turn
from symgen.system.frames.screws import BetweenHinges, FixedAngle, Screw
from symgen.system.frames.spatial_algebra import SE3
from symgen.system.joint_coordinates import JointCoordinate, JointCoordinates

TO_Z = (  # axes whose z-axis is the old x-axis (columns y, z, x), or the old y-axis (columns z, x, y)
    SE3([[ZERO, ZERO, ONE], [ONE, ZERO, ZERO], [ZERO, ONE, ZERO]], [ZERO] * 3),
    SE3([[ZERO, ONE, ZERO], [ZERO, ZERO, ONE], [ONE, ZERO, ZERO]], [ZERO] * 3),
    None,
)


@dataclass(frozen=True)
class JointLink:
    """From a frame to the next: a constant displacement to the axis z, then what the joint leaves free.

    turn, travel: coordinates about and along z; crosswise: travels along x and y, before the turn or after it. sign: of
    the coordinates as they move the far frame. lead: travel of a screw for a unit of its angle.
    """

    before: SE3
    turn: JointCoordinate | None = None
    travel: JointCoordinate | None = None
    crosswise: tuple[JointCoordinate, JointCoordinate] | None = None
    sign: ca.SX = ONE
    lead: ca.SX = ZERO

    @property
    def constant(self) -> bool:
        """Does nothing move?"""
        return self.turn is None and self.travel is None and self.crosswise is None

    @property
    def hinged(self) -> bool:
        """May the frame beyond be turned about z and shifted along it by a constant?"""
        return self.crosswise is None and not self.constant

    def moves(self, way: BetweenHinges | SE3, beyond: Screw) -> list[Move]:
        """As moves to the frame that stands on the hinge, displaced by the screw `beyond`.

        way: the screws of the constant displacement, or the displacement itself where they are useless.
        """
        if isinstance(way, SE3):
            return [Fixed(way.R, way.r), *self._variable(Screw(), beyond)]
        moves: list[Move] = [
            *_constant(2, way.start),
            *(Slide(axis, value) for axis, value in enumerate(way.offset) if not value.is_zero()),
            *_constant(0, way.across, slide_first=True),
        ]
        return [*moves, *self._variable(way.end, beyond)]

    def _variable(self, end: Screw, beyond: Screw) -> list[Move]:
        if self.crosswise is not None:
            slides = [
                Slide(axis, mul(self.sign, own.value), own.column, own.rate, self.sign)
                for axis, own in enumerate(self.crosswise)
            ]
            forward = self.sign.is_one()
            moves: list[Move] = [*_constant(2, end)] if forward else [*_constant(2, Screw(FixedAngle(), end.shift))]
            turn = self._turn(FixedAngle() if forward else end.angle)
            return [*moves, *slides, *turn] if forward else [*moves, *turn, *slides]
        shift = add(end.shift, beyond.shift)
        turn = self._turn(end.angle.plus(beyond.angle))
        return [*turn, *self._slide(shift)]

    def _turn(self, angle: FixedAngle) -> list[Turn]:
        if self.turn is None:
            return [] if angle.nothing else [Turn(2, angle.cosine, angle.sine)]
        cosine, sine = angle.with_coordinate(self.turn.value, self.sign)
        return [Turn(2, cosine, sine, self.turn.column, self.turn.rate, self.sign)]

    def _slide(self, shift: ca.SX) -> list[Slide]:
        own, factor = self.travel, self.sign
        if not self.lead.is_zero():
            own, factor = self.turn, mul(self.sign, self.lead)
        if own is None:
            return [] if shift.is_zero() else [Slide(2, shift)]
        return [Slide(2, add(shift, mul(factor, own.value)), own.column, own.rate, factor)]


def _constant(axis: int, screw: Screw, slide_first: bool = False) -> list[Move]:
    turn = [] if screw.angle.nothing else [Turn(axis, screw.angle.cosine, screw.angle.sine)]
    slide = [] if screw.shift.is_zero() else [Slide(axis, screw.shift)]
    return [*slide, *turn] if slide_first else [*turn, *slide]


def links_of(own: JointCoordinates, before: SE3, forward: bool) -> tuple[list[JointLink], SE3]:
    """(links of a joint, constant displacement beyond the last one to the far marker).

    before: from the near frame to the near marker; forward: the near one is marker a.
    """
    sign = ONE if forward else neg(ONE)
    links, place = [], before
    groups = list(_groups(own))
    for axis, turn, travel, crosswise, lead in groups if forward else reversed(groups):
        aside = TO_Z[axis]
        near = place if aside is None else place * aside
        links.append(JointLink(near, turn, travel, crosswise, sign, lead))
        place = SE3.identity() if aside is None else aside.inverse()
    return links, place


Pair = tuple[JointCoordinate, JointCoordinate]


def _groups(
    own: JointCoordinates,
) -> Iterator[tuple[int, JointCoordinate | None, JointCoordinate | None, Pair | None, ca.SX]]:
    """(axis, turn, travel, crosswise, lead) of the motions that one link makes.

    A turn and a slide about one axis go together, and two slides across an axis with the turn about it after them.
    """
    motions, found, k = own.motions, own.coordinates, 0
    while k < len(motions):
        here, after = motions[k], motions[k + 1] if k + 1 < len(motions) else None
        turns = isinstance(here, TurnOf)
        if [(type(one), one.axis) for one in motions[k : k + 3]] == [(SlideOf, 0), (SlideOf, 1), (TurnOf, 2)]:
            yield 2, found[k + 2], None, (found[k], found[k + 1]), ZERO
            k += 3
        elif (
            after is not None
            and after.axis == here.axis
            and turns is not isinstance(after, TurnOf)
            and not (here.lead or after.lead)
        ):
            turn, travel = (k, k + 1) if turns else (k + 1, k)
            yield here.axis, found[turn], found[travel], None, ZERO
            k += 2
        else:
            yield here.axis, found[k] if turns else None, None if turns else found[k], None, own.leads[k]
            k += 1
