"""The tree of frames of a spatial mechanism: data for the recursions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from symgen.system.frames.moves import Move
from symgen.system.frames.nodes import FlexibleNode, RigidNode
from symgen.system.frames.spatial_algebra import SE3

GROUND = -1


@dataclass
class Frame:
    """A frame: its parent (GROUND or an earlier one), the moves that lead from there, the inertia that goes with it."""

    parent: int
    moves: list[Move]
    inertia: RigidNode | FlexibleNode | None


@dataclass(frozen=True)
class BodyFrame:
    """Where a body's own frame is: in which frame of the tree, and where in that."""

    frame: int = GROUND
    place: SE3 = field(default_factory=SE3.identity)


@dataclass(frozen=True)
class FrameTree:
    """Frames, parents first, and the seat of each body by name (the ground too)."""

    frames: list[Frame]
    seats: dict[str, BodyFrame]

    def way(self, frame: int) -> list[int]:
        """The frames from the ground to one, itself included."""
        found: list[int] = []
        while frame != GROUND:
            found.append(frame)
            frame = self.frames[frame].parent
        return found[::-1]

    def common(self, a: str, b: str) -> int:
        """The last frame that the ways to two bodies have in common."""
        shared = [
            first
            for first, second in zip(self.way(self.seats[a].frame), self.way(self.seats[b].frame), strict=False)
            if first == second
        ]
        return shared[-1] if shared else GROUND

    def children(self) -> list[list[int]]:
        """Of each frame."""
        found: list[list[int]] = [[] for _ in self.frames]
        for k, frame in enumerate(self.frames):
            if frame.parent != GROUND:
                found[frame.parent].append(k)
        return found


def columns_of(moves: Sequence[Move]) -> set[int]:
    """The columns of q on which moves depend."""
    return {column for move in moves for column in move.twists}
