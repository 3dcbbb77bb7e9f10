"""Inverse dynamics, the recursive Newton-Euler algorithm: the forces that a motion needs (Eqs. 20, 38).

One sweep out and one back along the tree of frames (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 5).

Out: omega, alpha and a of each frame, with -gravity as the acceleration of the ground. Back: the wrench that moves the
masses beyond each transform, whose power on the transform's twists is the generalised force (principle of virtual
power). With joint accelerations of zero that is Featherstone's bias force C(q, v).
"""

from __future__ import annotations

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add
from symgen.algebra.vectors import Vector, zeros
from symgen.system.frames.joint_transforms import Float
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion
from symgen.system.frames.tree import GROUND, FrameTree


def inverse_dynamics(tree: FrameTree, base: Vector, rates: Row, accelerations: Row) -> Row:
    """Generalised force by column that gives the accelerations at these rates.

    base: acceleration of the ground.

    Without the accelerations of the origins of bodies that no joint places, which `floating_forces` adds.
    """
    own, force = own_wrenches(tree, base, rates, accelerations)
    wrenches = [NOTHING] * len(tree.frames)
    for k in reversed(range(len(tree.frames))):
        frame, wrench = tree.frames[k], wrenches[k].plus(own[k])
        for transform in reversed(frame.transforms):
            for column, value in transform.powers(wrench).items():
                add_to(force, column, value)
            wrench = transform.wrench(wrench)
        if frame.parent != GROUND:
            wrenches[frame.parent] = wrenches[frame.parent].plus(wrench)
    return force


def own_wrenches(tree: FrameTree, base: Vector, rates: Row, accelerations: Row) -> tuple[list[Force], Row]:
    """(what moves the masses of each frame, generalised forces on modes by column)."""
    motions: list[FrameMotion] = []
    wrenches: list[Force] = []
    force: Row = {}
    for frame in tree.frames:
        motion = FrameMotion(zeros(), zeros(), base) if frame.parent == GROUND else motions[frame.parent]
        for transform in frame.transforms:
            motion = transform.motion(motion, rates, accelerations)
        motions.append(motion)
        own = NOTHING
        if frame.inertia is not None:
            own, modes = frame.inertia.inertia_force(motion, rates, accelerations)
            for column, value in modes.items():
                add_to(force, column, value)
        wrenches.append(own)
    return wrenches, force


def floating_forces(tree: FrameTree, M: list[Row], base: Vector, accelerations: Row) -> Row:
    """Force that the accelerations of the origins of bodies need that no joint places: their columns of M."""
    force: Row = {}
    for frame in tree.frames:
        for transform in frame.transforms:
            if isinstance(transform, Float):
                for column, ground in zip(transform.columns, base, strict=True):
                    add_scaled(force, add(accelerations.get(column, ZERO), ground), M[column])
    return force
