"""The first two derivatives in time of the rows of a spherical joint that closes a loop, from the ways to its markers.

C = r_b - r_a, so that an entry of C_q is what a coordinate moves the end of a way by, and its rates are those of the
coordinate's field there.
"""

from __future__ import annotations

from dataclasses import dataclass

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import mul, neg
from symgen.algebra.vectors import identity, plus, times, zeros
from symgen.bodies.deformation import Deformation
from symgen.system.frames.bend_changes import parts_of
from symgen.system.frames.body_moves import Bend
from symgen.system.frames.fields import FieldPart, Spot
from symgen.system.frames.motion import Motion
from symgen.system.frames.moves import Fixed, Move
from symgen.system.frames.paths import Path
from symgen.system.frames.skeleton import place_of
from symgen.system.frames.tree import GROUND, FrameTree, Seat


@dataclass(frozen=True)
class MarkerWay:
    """Moves from frame `base` (or GROUND), taken to be at rest, to a marker in `frame`; path: to that frame."""

    base: int
    frame: int
    moves: list[Move]
    path: Path

    @property
    def end(self) -> Move:
        """From the frame to the marker, without turning."""
        return self.moves[-1]

    @staticmethod
    def to(tree: FrameTree, base: int, seat: Seat, marker: Deformation, path: Path) -> MarkerWay:
        """From a frame (or GROUND) to a marker of a body with some seat; path: to the frame of that."""
        frames = tree.way(seat.frame)
        frames = frames if base == GROUND else frames[frames.index(base) + 1 :]
        place = plus(seat.place.r, times(seat.place.R, marker.point.position))
        end = Fixed(identity(), place) if marker.rigid else Bend(place_of(marker))
        return MarkerWay(
            base, seat.frame, [*(move for frame in frames for move in tree.frames[frame].moves), end], path
        )

    def parts(self, rates: Row, accelerations: Row) -> list[FieldPart]:
        """What the coordinates on the way do to its end, in the axes there."""
        found: list[FieldPart] = []
        motion = Motion(zeros(), zeros(), zeros())
        for move in self.moves:
            before, motion = motion, move.motion(motion, rates, accelerations)
            spot = Spot(before, motion, rates, accelerations)
            found = [FieldPart(part.shares, part.field.beyond(move, spot)) for part in found] + parts_of(move, spot)
        return found


@dataclass(frozen=True)
class LoopRates:
    """Of a spherical joint between the ends of two ways from the same frame; base: the way to that, whose rates do not
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
