"""A frame with the way to it: what the coordinates on the way do to the frame, and to the wrench that is there.

k_c'c is what a displacement by coordinate c does to the power of a wrench on coordinate c' of an earlier move: the
wrench is displaced with the frame. On coordinates of later moves it does nothing, as all of that is displaced alike;
on those of the same move only where that bends a body. The force of a spherical joint keeps its direction instead: a
turning tau of the frame changes it by -tau x f as seen there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, dot
from symgen.algebra.vectors import Vector, cross, negative
from symgen.system.frames.bend_changes import BendChanges
from symgen.system.frames.body_moves import Bend, Unbend
from symgen.system.frames.directions import Direction, share_of
from symgen.system.frames.fields import FieldPart, Spot, joint_parts, turned
from symgen.system.frames.force_changes import Beyond
from symgen.system.frames.motion import NOTHING, Motion, Wrench
from symgen.system.frames.moves import Move
from symgen.system.frames.tangents import Change


@dataclass(frozen=True)
class _Step:
    """A move on the way to a frame with what its coordinates do to the frame; bending: where modes move a marker."""

    move: Move
    parts: list[FieldPart]
    bending: BendChanges | None

    def beyond(self, move: Move, spot: Spot) -> _Step:
        """For the frame after a further move."""
        carried = [FieldPart(part.shares, part.field.beyond(move, spot)) for part in self.parts]
        return _Step(self.move, carried, self.bending)


def _step(move: Move, spot: Spot) -> _Step:
    if isinstance(move, Bend | Unbend):
        bending = BendChanges(move.deformation, spot, isinstance(move, Unbend))
        return _Step(move, bending.parts, bending)
    return _Step(move, joint_parts(move, spot), None)


@dataclass
class FramePlace:
    """Where a frame's masses are looked at: its steps and motion; what moves its masses; forces of joints on it."""

    steps: list[_Step]
    motion: Motion
    state: Beyond | None = None
    forces: list[tuple[Vector, Vector]] = field(default_factory=list)  # (arm, force) in the axes here

    @property
    def parts(self) -> list[FieldPart]:
        """What the coordinates on the way do to the frame."""
        return [part for step in self.steps for part in step.parts]

    @cached_property
    def wrench(self) -> Wrench:
        """That moves the masses, less the forces of joints."""
        found = NOTHING if self.state is None else self.state.wrench
        for arm, force in self.forces:
            found = found.plus(Wrench(negative(force), negative(cross(arm, force))))
        return found

    def beyond(self, move: Move, rates: Row, accelerations: Row) -> FramePlace:
        """After a move; without masses."""
        after = move.motion(self.motion, rates, accelerations)
        spot = Spot(self.motion, after, rates, accelerations)
        return FramePlace([*(step.beyond(move, spot) for step in self.steps), _step(move, spot)], after)

    def changed(self, change: Change, more: Wrench) -> Wrench:
        """Of the wrench that moves the masses, by a change of the motion and a further change."""
        return more if self.state is None else self.state.tangent.wrench(change).plus(more)

    def turned_forces(self, tau: Vector) -> Wrench:
        """Change of the wrench of the forces of joints, as seen in a frame that turns by tau."""
        found = NOTHING
        for arm, force in self.forces:
            turning = cross(tau, force)
            found = found.plus(Wrench(turning, cross(arm, turning)))
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
                carried = turned(part.field.twist, wrench)
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
            rest = step.move.wrench(rest)
        return found
