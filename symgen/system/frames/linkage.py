"""How placing joints link frames: constant displacements and variable moves about and along z, one hinge a link."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, mul, neg
from symgen.algebra.vectors import identity
from symgen.joints.spatial_rows import JointCoordinate
from symgen.system.frames.moves import Fixed, Move, Slide, Turn
from symgen.system.frames.screws import BetweenHinges, FixedAngle, Screw
from symgen.system.frames.spatial_algebra import SE3

X_TO_Z = [[ZERO, ZERO, ONE], [ONE, ZERO, ZERO], [ZERO, ONE, ZERO]]  # columns y, z, x: its z-axis is the old x-axis


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


def links_of(
    kind: str, own: Mapping[str, JointCoordinate], before: SE3, forward: bool, lead: ca.SX
) -> tuple[list[JointLink], SE3]:
    """(links of a joint, constant displacement beyond the last one to the far marker).

    before: from the near frame to the near marker; forward: the near one is marker a.
    """
    sign = ONE if forward else neg(ONE)
    if kind == "weld":
        return [], before
    if kind == "universal":
        to_x = SE3(X_TO_Z, [ZERO] * 3)
        about_z, about_x = own["angle1"], own["angle2"]
        if forward:
            return [JointLink(before, about_z), JointLink(to_x, about_x)], to_x.inverse()
        first = JointLink(before * to_x, about_x, sign=sign)
        return [first, JointLink(to_x.inverse(), about_z, sign=sign)], SE3.identity()
    if kind == "planar":
        return [JointLink(before, own["angle"], None, (own["x"], own["y"]), sign)], SE3.identity()
    link = JointLink(before, own.get("angle"), own.get("travel"), None, sign, lead)
    return [link], SE3(identity(), [ZERO] * 3)
