"""Forces on coordinates at the ends of a tree of frames: what they see of the rest is how their carriers move.

The frames that some columns move, and all beyond them, stand on carriers: frames that do not depend on these columns.
omega, alpha and a of a carrier and the accelerations of other coordinates of the frames themselves are what crosses:
a few numbers, whatever the tree.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import Vector, zeros
from symgen.system.frames.rnea import inverse_dynamics
from symgen.system.frames.spatial_algebra import FrameMotion
from symgen.system.frames.tree import GROUND, Frame, FrameTree, columns_of

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
            if frame.parent in found or _columns(frame) & self.columns:
                found.append(k)
        return found

    @cached_property
    def _carriers(self) -> list[int]:
        parents = {self.tree.frames[k].parent for k in self._carried}
        return sorted(parents - set(self._carried) - {GROUND})

    @cached_property
    def _others(self) -> list[int]:
        return sorted(set().union(*(_columns(self.tree.frames[k]) for k in self._carried)) - self.columns)

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


def _columns(frame: Frame) -> set[int]:
    inertia = set() if frame.inertia is None else set(frame.inertia.momenta)
    return columns_of(frame.moves) | inertia
