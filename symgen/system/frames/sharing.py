"""Inertia that moves with a frame's parent as well: what lies on the axis of the hinge between them.

A hinge turns nothing of a mass distribution on its own axis, given by its mass, its first and its second moment along
it; a slide leaves the second moments about a centre of mass as they are. Counted with the parent they cost nothing,
because inertia that is fixed in a frame is gathered in `constants`.
"""

from __future__ import annotations

from dataclasses import dataclass

from symgen.algebra.scalar import ZERO
from symgen.algebra.vectors import zeros
from symgen.system.frames.ball import Ball
from symgen.system.frames.body_moves import Orient
from symgen.system.frames.flexible import RigidInertia
from symgen.system.frames.motion import Composite
from symgen.system.frames.moves import Fixed, Move, Slide, Turn
from symgen.system.frames.tree import GROUND, Frame


@dataclass(frozen=True)
class Parts:
    """Inertia split in what the parent can have and what is left."""

    given: Composite
    kept: Composite


def give_to_parent(frame: Frame, frames: list[Frame]) -> None:
    """Give the parent what it can have, if it has inertia of a rigid body itself."""
    if not isinstance(frame.inertia, RigidInertia):
        return
    parts = _split(frame.inertia.rigid, frame.moves)
    if parts is None:
        return
    given = parts.given
    for move in reversed(frame.moves):
        if not move.twists:
            given = move.composite(given)
    if frame.parent != GROUND:
        parent = frames[frame.parent]
        if not isinstance(parent.inertia, RigidInertia):
            return
        parent.inertia = RigidInertia(parent.inertia.rigid.plus(given))
    frame.inertia = RigidInertia(parts.kept)


def _split(inertia: Composite, moves: list[Move]) -> Parts | None:
    """By what the moves leave free; None where nothing can be given."""
    free = [move for move in moves if move.twists]
    if not all(isinstance(move, Turn | Slide | Fixed | Orient | Ball) for move in free):
        return None
    if any(isinstance(move, Orient | Ball) for move in free):  # a mass at the origin does not care how the frame turns
        return Parts(
            Composite(inertia.m, zeros(), [zeros() for _ in range(3)]), Composite(ZERO, inertia.h, inertia.Sigma)
        )
    turns = any(isinstance(move, Turn) for move in free)
    slides = any(isinstance(move, Slide) for move in free)
    if slides and not turns:
        return Parts(
            Composite(ZERO, zeros(), inertia.Sigma), Composite(inertia.m, inertia.h, [zeros() for _ in range(3)])
        )
    along = [zeros() for _ in range(3)]
    along[2][2] = inertia.Sigma[2][2]
    rest = [list(row) for row in inertia.Sigma]
    rest[2][2] = ZERO
    if slides:
        return Parts(Composite(ZERO, zeros(), along), Composite(inertia.m, inertia.h, rest))
    x, y, z = inertia.h
    return Parts(Composite(inertia.m, [ZERO, ZERO, z], along), Composite(ZERO, [x, y, ZERO], rest))
