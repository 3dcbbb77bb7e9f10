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
from collections.abc import Collection

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add
from symgen.algebra.vectors import Vector, zeros
from symgen.system.frames.moves import Float, JointNode
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion
from symgen.system.frames.tree import GROUND, FrameTree


def inverse_dynamics(tree: FrameTree, base: Vector, rates: Row, accelerations: Row) -> Row:
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
    base: Vector,
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
    for frame in tree.frames:
        motion = FrameMotion(zeros(), zeros(), base) if frame.parent == GROUND else motions[frame.parent]
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
