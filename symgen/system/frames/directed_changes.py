"""Derivatives of inertia forces along directions in which all coordinates of loops follow a few.

With T_i the field of a frame for direction i and w the change of the wrench that moves its masses,

    d(S^T F)_i / dx_j = sum over frames of T_i . w(D T_j, D^2 T_j, T_j) + sum over c', c of S_c'i S_cj k_c'c,

k being geometry (`places`). A body that one spherical joint ties is looked at where the joint is: its force has no
moment there, and the joint's other body gives v where fewer coordinates move it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul
from symgen.algebra.vectors import Vector, identity, negative, zeros
from symgen.system.frames.body_moves import Bend, Unbend
from symgen.system.frames.directions import Direction
from symgen.system.frames.fields import Field, Spot
from symgen.system.frames.flexible import FlexibleInertia
from symgen.system.frames.force_changes import ForceSweep
from symgen.system.frames.loop_rates import MarkerWay
from symgen.system.frames.motion import NOTHING, Motion, Twist, Wrench
from symgen.system.frames.moves import Fixed, Move
from symgen.system.frames.places import FramePlace
from symgen.system.frames.tangents import Change
from symgen.system.frames.tree import GROUND, FrameTree

_Power = tuple[Row, Callable[[Change, Wrench, Wrench], ca.SX]]  # shares by column; (change, further w, w) -> power


@dataclass(frozen=True)
class Tie:
    """A spherical joint between the ends of two ways from the ground; force: lambda in world axes."""

    a: MarkerWay
    b: MarkerWay
    force: Vector


@dataclass(frozen=True)
class _End:
    """Of a tie, with the force on it in the axes of its frame."""

    own: MarkerWay
    other: MarkerWay
    force: Vector


def tied_changes(
    tree: FrameTree, n: int, base: Vector, moving: tuple[Row, Row], ties: Sequence[Tie], directions: Sequence[Direction]
) -> tuple[ca.SX, ca.SX] | None:
    """F_q and F_v (n x directions), of which S^T F_q and S^T F_v are the derivatives by all x and x'.

    moving: rates and accelerations of the coordinates by column. None where several joints tie bent markers of a body.
    """
    sums = _Sums(tree, n, base, moving, directions)
    for k, frame in enumerate(tree.frames):
        ends = [end for tie in ties for end in _ends(tie) if end.own.frame == k]
        if len(ends) > 1 and any(isinstance(end.own.end, Bend) for end in ends):
            return None
        if frame.inertia is not None or ends:
            sums.add(k, ends)
    return _matrix(sums.F_q), _matrix(sums.F_v)


def _matrix(rows: list[Vector]) -> ca.SX:
    return ca.sparsify(ca.vertcat(*(ca.horzcat(*row) for row in rows)))


def _ends(tie: Tie) -> list[_End]:
    found = []
    for own, other, force in ((tie.a, tie.b, tie.force), (tie.b, tie.a, negative(tie.force))):
        found.append(_End(own, other, [dot(axis, force) for axis in own.path.axes]))
    return found


class _Sums:
    """F_q and F_v are the result, by column and direction."""

    def __init__(
        self, tree: FrameTree, n: int, base: Vector, moving: tuple[Row, Row], directions: Sequence[Direction]
    ) -> None:
        self._tree, self._moving, self._directions = tree, moving, directions
        self._sweep = ForceSweep(n, *moving)
        self._ground = FramePlace([], Motion(zeros(), zeros(), base))
        self._places: list[FramePlace] = []
        for frame in tree.frames:
            place = self._place(frame.parent)
            for move in frame.moves:
                place = place.beyond(move, *moving)
            self._places.append(place)
        self.F_q, self.F_v = ([zeros(len(directions)) for _ in range(n)] for _ in range(2))

    def _place(self, frame: int) -> FramePlace:
        return self._ground if frame == GROUND else self._places[frame]

    def add(self, k: int, ends: list[_End]) -> None:
        """What a frame adds that joints may tie."""
        inertia, place = self._tree.frames[k].inertia, self._places[k]
        seen = FramePlace(place.steps, place.motion)
        if inertia is not None:
            seen.state = self._sweep.body(inertia, place.motion)
        closed = len(ends) == 1 and len(place.parts) > len(self._place(ends[0].other.frame).parts)
        if len(ends) == 1 and (closed or isinstance(inertia, FlexibleInertia)):
            seen = self._seated(seen, ends[0])
        else:
            seen.forces = [(end.own.end.r, end.force) for end in ends if isinstance(end.own.end, Fixed)]
        fields = [direction.along(seen.parts) for direction in self._directions]
        if closed:
            fields = self._closed(fields, ends[0])
        self._contract(seen, fields, self._powers(seen, fields, closed))

    def _seated(self, place: FramePlace, end: _End) -> FramePlace:
        """The same masses looked at from the marker that a joint ties."""
        seat = place.beyond(end.own.end, *self._moving)
        seat.state, seat.forces = place.state, [(zeros(), end.force)]
        if place.state is not None:
            move = end.own.end
            back = Unbend(move.deformation) if isinstance(move, Bend) else _back(move)
            self._sweep.through(back, Spot(seat.motion, place.motion, *self._moving), place.state)
        return seat

    def _closed(self, fields: list[Field], end: _End) -> list[Field]:
        """With v as the joint's other body gives it."""
        other = self._place(end.other.frame).beyond(end.other.end, *self._moving)
        found = []
        for known, direction in zip(fields, self._directions, strict=True):
            v, v1, v2 = (
                [dot(axis, end.other.path.along(vector)) for axis in end.own.path.axes]
                for vector in direction.along(other.parts).moving
            )
            found.append(Field(known.turning, (v, v1, v2)))
        return found

    def _contract(self, place: FramePlace, fields: list[Field], powers: list[_Power]) -> None:
        geometric, state = place.carried(self._directions), place.state
        for j, (one, direction) in enumerate(zip(fields, self._directions, strict=True)):
            by_position, by_rate = one.by_position(place.motion.a), one.by_rate
            more_q, more_v = place.turned_forces(one.turning[0]), NOTHING
            if state is not None and direction.column in state.rows:
                more_q = more_q.plus(state.by_position[direction.column])
                more_v = more_v.plus(state.by_rate[direction.column])
            for F, change, more in ((self.F_q, by_position, more_q), (self.F_v, by_rate, more_v)):
                w = place.changed(change, more)
                for shares, power in powers:
                    _share(F, j, shares, power(change, more, w))
                for column, row in state.rows.items() if state is not None else ():
                    F[column][j] = add(F[column][j], row.of(change))
            for part, values in zip(place.parts, geometric, strict=True):
                _share(self.F_q, j, part.shares, values[j])
            for column in state.rows if state is not None else ():
                for F, known in ((self.F_q, self._sweep.K), (self.F_v, self._sweep.D)):
                    F[column][j] = add(F[column][j], known[column].get(direction.column, ZERO))

    def _powers(self, place: FramePlace, fields: list[Field], closed: bool) -> list[_Power]:
        """On what the coordinates on the way do; where the way is closed by fields, on those of the directions."""
        if not closed:
            return [(part.shares, partial(_power, part.field.twist)) for part in place.parts]
        moved = [i for i, one in enumerate(fields) if not all(value.is_zero() for value in one.moving[0])]
        alone = moved if len(moved) == 1 < len(fields) and place.state is not None else []
        found: list[_Power] = []
        for i, (one, direction) in enumerate(zip(fields, self._directions, strict=True)):
            power = partial(_power_of_row, place, one.twist) if i in alone else partial(_power, one.twist)
            found.append(({direction.column: ONE}, power))
        return found


def _back(move: Move) -> Fixed:
    assert isinstance(move, Fixed)
    return Fixed(identity(), negative(move.r))


def _power(twist: Twist, change: Change, more: Wrench, w: Wrench) -> ca.SX:
    return w.along(twist)


def _power_of_row(place: FramePlace, twist: Twist, change: Change, more: Wrench, w: Wrench) -> ca.SX:
    """Without the force of w, where that does work on one twist alone."""
    assert place.state is not None
    row = place.state.tangent.row(Twist(zeros(), twist.v))
    return add(dot(twist.omega, w.n), add(row.of(change), dot(twist.v, more.f)))


def _share(F: list[Vector], j: int, shares: Row, value: ca.SX) -> None:
    for column, share in shares.items():
        F[column][j] = add(F[column][j], mul(share, value))
