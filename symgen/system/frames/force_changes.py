"""Derivatives of the inertia forces of a tree of frames by its coordinates and rates, at fixed accelerations.

From the tips to the ground each frame carries what is beyond it: its `Tangent`, for each coordinate there the change of
the wrench that the frame passes on, and for each force there the row that gives it for a change of the frame's motion.
Composite bodies make this O(1) a pair of coordinates, one of which is beyond the other.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ZERO, mul, neg
from symgen.algebra.vectors import Vector, cross, negative, plus, scaled, zeros
from symgen.system.frames.bend_changes import BendChanges
from symgen.system.frames.body_moves import Bend, Unbend
from symgen.system.frames.fields import FieldPart, Spot, joint_parts, turned
from symgen.system.frames.flexible import FlexibleInertia, RigidInertia
from symgen.system.frames.inertia_changes import TWO, by_mode_rates, by_modes, mode_rows, tangent_of
from symgen.system.frames.motion import NOTHING, Motion, Wrench, no_masses
from symgen.system.frames.moves import Fixed, Move, Slide, Turn
from symgen.system.frames.tangents import RowChange, Tangent
from symgen.system.frames.tree import GROUND, FrameTree


def has_force_changes(tree: FrameTree) -> bool:
    """Are all moves of the kinds that are differentiated here: hinges, slides, markers of flexible bodies?"""
    return all(isinstance(move, Turn | Slide | Fixed | Bend | Unbend) for frame in tree.frames for move in frame.moves)


def force_changes(tree: FrameTree, n: int, base: Vector, rates: Row, accelerations: Row) -> tuple[list[Row], list[Row]]:
    """(d/dq, d/dq') of `inverse_dynamics`, n rows by column."""
    sweep = ForceSweep(n, rates, accelerations)
    sweep.tree(tree, base)
    return sweep.K, sweep.D


@dataclass
class Beyond:
    """What a frame carries: by column, the changes of its wrench and the rows of forces."""

    tangent: Tangent
    wrench: Wrench = NOTHING
    by_position: dict[int, Wrench] = field(default_factory=dict)
    by_rate: dict[int, Wrench] = field(default_factory=dict)
    rows: dict[int, RowChange] = field(default_factory=dict)

    def add(self, other: Beyond) -> None:
        """Of both."""
        self.tangent = self.tangent.plus(other.tangent)
        self.wrench = self.wrench.plus(other.wrench)
        gather(self.by_position, other.by_position)
        gather(self.by_rate, other.by_rate)
        for column, row in other.rows.items():
            self.rows[column] = self.rows[column].plus(row) if column in self.rows else row


def gather(target: dict[int, Wrench], more: dict[int, Wrench]) -> None:
    """Sums by column."""
    for column, wrench in more.items():
        target[column] = target[column].plus(wrench) if column in target else wrench


def _nothing() -> Beyond:
    return Beyond(Tangent(no_masses(), zeros(), [zeros() for _ in range(3)]))


class ForceSweep:
    """From the tips to the ground at some rates and accelerations; K and D, n rows by column, are the result."""

    def __init__(self, n: int, rates: Row, accelerations: Row) -> None:
        self.K: list[Row] = [{} for _ in range(n)]
        self.D: list[Row] = [{} for _ in range(n)]
        self._rates, self._accelerations = rates, accelerations

    def tree(self, tree: FrameTree, base: Vector) -> None:
        """All frames; base: acceleration of the ground."""
        spots: list[list[Spot]] = []
        motions: list[Motion] = []
        for frame in tree.frames:
            motion = Motion(zeros(), zeros(), base) if frame.parent == GROUND else motions[frame.parent]
            spots.append([])
            for move in frame.moves:
                before, motion = motion, move.motion(motion, self._rates, self._accelerations)
                spots[-1].append(Spot(before, motion, self._rates, self._accelerations))
            motions.append(motion)
        states = [_nothing() for _ in tree.frames]
        for k in reversed(range(len(tree.frames))):
            frame, state = tree.frames[k], states[k]
            if frame.inertia is not None:
                state.add(self.body(frame.inertia, motions[k]))
            for move, spot in zip(reversed(frame.moves), reversed(spots[k]), strict=True):
                self.through(move, spot, state)
            if frame.parent != GROUND:
                states[frame.parent].add(state)

    def body(self, inertia: RigidInertia | FlexibleInertia, motion: Motion) -> Beyond:
        """A body at its frame."""
        wrench, _ = inertia.inertia_force(motion, self._rates, self._accelerations)
        places = by_modes(inertia, motion, self._rates, self._accelerations)
        speeds = by_mode_rates(inertia, motion, self._rates)
        for target, changes in ((self.K, places), (self.D, speeds)):
            for column, change in changes.items():
                for row, value in change.modes.items():
                    add_to(target[row], column, value)
        return Beyond(
            tangent_of(inertia, motion, self._rates),
            wrench,
            {column: change.wrench for column, change in places.items()},
            {column: change.wrench for column, change in speeds.items()},
            mode_rows(inertia, motion, self._rates),
        )

    def through(self, move: Move, spot: Spot, state: Beyond) -> None:
        """All that is beyond a move, as seen before it, in place."""
        bending = None
        if isinstance(move, Bend | Unbend):
            bending = BendChanges(move.deformation, spot, isinstance(move, Unbend))
        parts = joint_parts(move, spot) if bending is None else bending.parts
        carried: dict[int, Wrench] = {}
        for part in parts:
            by_position, by_rate = part.field.by_position(spot.after.a), part.field.by_rate
            for row, form in state.rows.items():
                self._shared(self.K, row, part, form.of(by_position))
                self._shared(self.D, row, part, form.of(by_rate))
            gather(state.by_position, _shares(part, state.tangent.wrench(by_position)))
            gather(state.by_rate, _shares(part, state.tangent.wrench(by_rate)))
            gather(carried, _shares(part, turned(part.field.twist, state.wrench)))
        for column, wrench in state.by_position.items():
            own = bending is not None and column in carried
            powers = bending.powers(column, state.wrench, wrench) if bending and own else move.powers(wrench)
            for row, value in powers.items():
                add_to(self.K[row], column, value)
            state.by_position[column] = move.wrench(wrench.plus(carried.get(column, NOTHING)))
        for column, wrench in state.by_rate.items():
            for row, value in move.powers(wrench).items():
                add_to(self.D[row], column, value)
            state.by_rate[column] = move.wrench(wrench)
        self._before(move, spot, state, parts)

    def _shared(self, target: list[Row], row: int, part: FieldPart, value: ca.SX) -> None:
        for column, share in part.shares.items():
            add_to(target[row], column, mul(share, value))

    def _before(self, move: Move, spot: Spot, state: Beyond, parts: list[FieldPart]) -> None:
        """Rows, inertia and wrench as seen before a move."""
        for part in parts:
            row = state.tangent.row(part.field.twist)
            for column, share in part.shares.items():
                own = row.scaled(share)
                state.rows[column] = state.rows[column].plus(own) if column in state.rows else own
        velocity = _twice_velocity(move, spot)
        state.rows = {column: _row_before(move, row, velocity) for column, row in state.rows.items()}
        state.tangent = _tangent_before(move, velocity, state.tangent)
        state.wrench = move.wrench(state.wrench)


def _shares(part: FieldPart, wrench: Wrench) -> dict[int, Wrench]:
    """Of a wrench, by column."""
    return {column: Wrench(scaled(share, wrench.f), scaled(share, wrench.n)) for column, share in part.shares.items()}


def _twice_velocity(move: Move, spot: Spot) -> Vector:
    """Of the origin after a move, seen from the frame before it, in the axes there; for `Unbend`, in those after it."""
    twice, arm, speed = scaled(TWO, spot.before.omega), zeros(), zeros()
    if isinstance(move, Slide):
        arm[move.axis] = move.amount
        if move.column is not None:
            speed[move.axis] = mul(move.factor, spot.rates.get(move.column, ZERO))
    elif isinstance(move, Fixed):
        arm = move.r
    elif isinstance(move, Bend | Unbend):
        bent = move.deformation.at(spot.rates)
        arm, speed = bent.rho, bent.rho_dot
        if isinstance(move, Unbend):
            twice = scaled(neg(TWO), spot.after.omega)
            return plus(cross(twice, arm), scaled(neg(TWO), speed))
    return plus(cross(twice, arm), scaled(TWO, speed))


def _row_before(move: Move, row: RowChange, velocity: Vector) -> RowChange:
    """Seen before a move."""
    r = plus(row.r, cross(velocity, row.phi)) if isinstance(move, Unbend) else row.r
    seen, r = move.wrench(Wrench(row.phi, row.nu)), move.wrench(Wrench(r, zeros())).f
    return RowChange(seen.n, seen.f, r if isinstance(move, Unbend) else plus(r, cross(velocity, seen.f)))


def _tangent_before(move: Move, velocity: Vector, tangent: Tangent) -> Tangent:
    """Seen before a move."""
    if isinstance(move, Turn):
        return tangent.about(move.axis, move.cosine, move.sine)
    if isinstance(move, Slide):
        arm = zeros()
        arm[move.axis] = move.amount
        return tangent.shifted(arm, velocity)
    if isinstance(move, Fixed):
        return tangent.turned(move.R).shifted(move.r, velocity)
    assert isinstance(move, Bend | Unbend)
    bent = move.deformation.at({})
    if isinstance(move, Bend):
        return tangent.turned(bent.R).shifted(bent.rho, velocity)
    back = [list(column) for column in zip(*bent.R, strict=True)]
    return tangent.shifted(negative(bent.rho), velocity).turned(back)
