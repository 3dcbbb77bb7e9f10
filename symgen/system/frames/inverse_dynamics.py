"""Forces that a motion needs, and the mass matrix: one sweep out and one back along the tree of frames (Eqs. 20, 38).

Out: omega, alpha and a of each frame, with -gravity as the acceleration of the ground. Back: the wrench that moves the
masses beyond each move, whose power on the move's twists is the generalised force. The mass matrix comes from the
composites of all that is beyond a move: their momentum for a unit rate of a coordinate, passed to the root.
"""

from __future__ import annotations

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to
from symgen.algebra.scalar import ZERO, add
from symgen.algebra.vectors import Vector, zeros
from symgen.system.frames.body_moves import Float
from symgen.system.frames.motion import NOTHING, Composite, Motion, Wrench, no_masses
from symgen.system.frames.moves import Move
from symgen.system.frames.tree import GROUND, FrameTree


def inverse_dynamics(tree: FrameTree, base: Vector, rates: Row, accelerations: Row) -> Row:
    """Generalised force by column that gives the accelerations at these rates; base: acceleration of the ground.

    Without the accelerations of the origins of bodies that no joint places, which `floating_forces` adds.
    """
    own, force = own_wrenches(tree, base, rates, accelerations)
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


def own_wrenches(tree: FrameTree, base: Vector, rates: Row, accelerations: Row) -> tuple[list[Wrench], Row]:
    """(what moves the masses of each frame, generalised forces on modes by column)."""
    motions: list[Motion] = []
    wrenches: list[Wrench] = []
    force: Row = {}
    for frame in tree.frames:
        motion = Motion(zeros(), zeros(), base) if frame.parent == GROUND else motions[frame.parent]
        for move in frame.moves:
            motion = move.motion(motion, rates, accelerations)
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
        for move in frame.moves:
            if isinstance(move, Float):
                for column, ground in zip(move.columns, base, strict=True):
                    add_scaled(force, add(accelerations.get(column, ZERO), ground), M[column])
    return force


def mass_rows(tree: FrameTree, n: int) -> list[Row]:
    """M of all coordinates (n columns), both triangles; rows of coordinates that the tree does not have are empty."""
    sweep = _Composites(tree, n)
    return sweep.M


class _Composites:
    """Composites and the momenta of unit rates, from the tips to the root."""

    def __init__(self, tree: FrameTree, n: int) -> None:
        self.M: list[Row] = [{} for _ in range(n)]
        beyond = [no_masses() for _ in tree.frames]
        momenta: list[dict[int, Wrench]] = [{} for _ in tree.frames]
        for k in reversed(range(len(tree.frames))):
            frame = tree.frames[k]
            if frame.inertia is not None:
                beyond[k] = beyond[k].plus(frame.inertia.rigid)
                _gather(momenta[k], frame.inertia.momenta)
                for (row, column), value in frame.inertia.own_masses().items():
                    self._add(row, column, value)
            composite, moved = beyond[k], momenta[k]
            for move in reversed(frame.moves):
                composite, moved = self._through(move, composite, moved)
            if frame.parent != GROUND:
                beyond[frame.parent] = beyond[frame.parent].plus(composite)
                _gather(momenta[frame.parent], moved)

    def _through(
        self, move: Move, composite: Composite, moved: dict[int, Wrench]
    ) -> tuple[Composite, dict[int, Wrench]]:
        own = {column: composite.momentum(twist) for column, twist in move.twists.items()}
        powers = {column: move.powers(wrench) for column, wrench in moved.items()}
        for column in (column for column in moved if column not in own):
            for k, value in powers[column].items():
                self._add(k, column, value)
        before = {column: move.wrench(wrench) for column, wrench in moved.items() if column not in own}
        columns = list(own)
        for place, k in enumerate(columns):
            whole = own[k].plus(moved[k]) if k in moved else own[k]
            for other, value in move.powers(whole).items():
                if other in columns[place:]:
                    self._add(k, other, add(value, powers[other][k]) if other in powers else value)
            before[k] = move.wrench(whole) if k in moved else move.momentum(k, whole, composite)
        return move.composite(composite), before

    def _add(self, i: int, j: int, value: ca.SX) -> None:
        add_to(self.M[i], j, value)
        if i != j and j in self.M[i]:
            self.M[j][i] = self.M[i][j]


def _gather(target: dict[int, Wrench], more: dict[int, Wrench]) -> None:
    for column, wrench in more.items():
        target[column] = target[column].plus(wrench) if column in target else wrench
