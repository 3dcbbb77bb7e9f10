"""Forces that a motion needs: one sweep out and one back along the tree of frames (Eqs. 20, 38).

Out: omega, alpha and a of each frame, with -gravity as the acceleration of the ground. Back: the wrench that moves the
masses beyond each move, whose power on the move's twists is the generalised force.

Forces on coordinates at the ends of a tree of frames: what they see of the rest is how their carriers move.

The frames that some columns move, and all beyond them, stand on carriers: frames that do not depend on these columns.
omega, alpha and a of a carrier and the accelerations of other coordinates of the frames themselves are what crosses:
a few numbers, whatever the tree.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add
from symgen.algebra.vectors import Vector, zeros
from symgen.system.frames.moves import Float, JointNode
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion
from symgen.system.frames.tree import GROUND, FrameTree


def inverse_dynamics(tree: FrameTree, base: Vector | Mapping[int, FrameMotion], rates: Row, accelerations: Row) -> Row:
    """Generalised force by column that gives the accelerations at these rates.

    base: acceleration of the ground, or how what each frame on the ground stands on moves, by frame.

    Without the accelerations of the origins of bodies that no joint places, which `floating_forces` adds.
    """
    own, force, _ = own_wrenches(tree, base, rates, accelerations)
    wrenches = [NOTHING] * len(tree.frames)
    for k in reversed(range(len(tree.frames))):
        frame, wrench = tree.frames[k], wrenches[k].plus(own[k])
        for move in reversed(frame.moves):
            for column, value in move.powers(wrench).items():
                add_to(force, column, value)
            wrench = move.wrench(wrench)
        if frame.parent != GROUND:
            wrenches[frame.parent] = wrenches[frame.parent].plus(wrench)
    return force


def own_wrenches(
    tree: FrameTree,
    base: Vector | Mapping[int, FrameMotion],
    rates: Row,
    accelerations: Row,
    chosen: Collection[int] = (),
) -> tuple[list[Force], Row, Row]:
    """(what moves the masses of each frame, generalised forces on modes by column, accelerations of `chosen` columns).

    chosen: hinges whose accelerations are those that leave no angular acceleration about their axes.
    """
    motions: list[FrameMotion] = []
    wrenches: list[Force] = []
    force: Row = {}
    found: Row = {}
    for k, frame in enumerate(tree.frames):
        motion = _begun(base, k) if frame.parent == GROUND else motions[frame.parent]
        for move in frame.moves:
            motion = move.motion(motion, rates, accelerations)
            if isinstance(move, JointNode) and move.turns and move.column is not None and move.column in chosen:
                motion, found[move.column] = move.steadied(motion)
        motions.append(motion)
        own = NOTHING
        if frame.inertia is not None:
            own, modes = frame.inertia.inertia_force(motion, rates, accelerations)
            for column, value in modes.items():
                add_to(force, column, value)
        wrenches.append(own)
    return wrenches, force, found


def _begun(base: Vector | Mapping[int, FrameMotion], frame: int) -> FrameMotion:
    return base[frame] if isinstance(base, Mapping) else FrameMotion(zeros(), zeros(), base)


def lone_hinges(tree: FrameTree) -> set[int]:
    """Columns of turns that no other move depends on."""
    met = Counter(column for frame in tree.frames for move in frame.moves for column in move.twists)
    return {
        move.column
        for frame in tree.frames
        for move in frame.moves
        if isinstance(move, JointNode) and move.turns and move.column is not None and met[move.column] == 1
    }


def floating_forces(tree: FrameTree, M: list[Row], base: Vector, accelerations: Row) -> Row:
    """Force that the accelerations of the origins of bodies need that no joint places: their columns of M."""
    force: Row = {}
    for frame in tree.frames:
        for move in frame.moves:
            if isinstance(move, Float):
                for column, ground in zip(move.columns, base, strict=True):
                    add_scaled(force, add(accelerations.get(column, ZERO), ground), M[column])
    return force


NUMBERS = 9  # of a motion: omega, alpha, a


@dataclass(frozen=True)
class CarriedFrames:
    """Those that `columns` move in a tree without balls; base: acceleration of the ground, rates: by column."""

    tree: FrameTree
    columns: frozenset[int]
    base: Vector
    rates: Row

    @cached_property
    def _carried(self) -> list[int]:
        found: list[int] = []
        for k, frame in enumerate(self.tree.frames):
            if frame.parent in found or frame.columns & self.columns:
                found.append(k)
        return found

    @cached_property
    def _carriers(self) -> list[int]:
        parents = {self.tree.frames[k].parent for k in self._carried}
        return sorted(parents - set(self._carried) - {GROUND})

    @cached_property
    def _others(self) -> list[int]:
        return sorted(set().union(*(self.tree.frames[k].columns for k in self._carried)) - self.columns)

    @property
    def size(self) -> int:
        """How many numbers cross."""
        return NUMBERS * len(self._carriers) + len(self._others)

    def crossing(self, accelerations: Row, still: bool = False) -> list[ca.SX]:
        """They, of a motion with these accelerations; still: without rates and weight."""
        base, rates = (zeros(), {}) if still else (self.base, self.rates)
        motions = {GROUND: FrameMotion(zeros(), zeros(), base)}
        needed = {k for carrier in self._carriers for k in self.tree.way(carrier)}
        for k in sorted(needed):
            motions[k] = motions[self.tree.frames[k].parent]
            for move in self.tree.frames[k].moves:
                motions[k] = move.motion(motions[k], rates, accelerations)
        found = [value for k in self._carriers for value in (*motions[k].omega, *motions[k].alpha, *motions[k].a)]
        return [*found, *(accelerations.get(column, ZERO) for column in self._others)]

    def forces(self, crossing: Sequence[ca.SX], accelerations: Row, still: bool = False) -> Row:
        """Generalised inertia force and weight by column of the carried frames, which these numbers cross to."""
        base, rates = (zeros(), {}) if still else (self.base, self.rates)
        motions = {GROUND: FrameMotion(zeros(), zeros(), base)}
        for position, k in enumerate(self._carriers):
            omega, alpha, a = (list(crossing[NUMBERS * position + i : NUMBERS * position + i + 3]) for i in (0, 3, 6))
            motions[k] = FrameMotion(zeros() if still else omega, alpha, a)
        others = zip(self._others, crossing[NUMBERS * len(self._carriers) :], strict=True)
        place = {k: position for position, k in enumerate(self._carried)}
        frames = [self.tree.frames[k] for k in self._carried]
        own = FrameTree([replace(frame, parent=place.get(frame.parent, GROUND)) for frame in frames], {})
        begun = {k: motions[frame.parent] for k, frame in enumerate(frames) if frame.parent in motions}
        return inverse_dynamics(own, begun, rates, {**dict(others), **accelerations})
