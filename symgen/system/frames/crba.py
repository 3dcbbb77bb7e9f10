"""The mass matrix of a tree of frames: momenta of unit rates, from the tips to the root (Eq. 38).

The composite of all that is beyond a move has a momentum for a unit rate of each of its coordinates, which goes to the
root and is met there by the other coordinates: a move costs each momentum two rotations. Where a flexible body has more
modes than there are coordinates before it, the twists of those come to the body instead (`outward`), in whose axes
they meet the momenta; of its mass, a point mass at its origin goes on.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ZERO, add, dot, length
from symgen.algebra.vectors import plus, scaled, zeros
from symgen.system.frames.moves import Bend, Move, Unbend
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion, Inertia, Motion, no_masses
from symgen.system.frames.tree import GROUND, FrameTree

FEW = 3  # coordinates before a flexible body, up to which their twists may be the shorter way

Place = tuple[int, int]  # a frame, and one of its moves
Momenta = dict[int, Force]


def mass_rows(tree: FrameTree, n: int) -> list[Row]:
    """M of all coordinates (n columns), both triangles; rows of coordinates that the tree does not have are empty."""
    M = _Composites(tree, n, {}).M
    meeting = _meetings(tree)
    return M if not meeting else min(M, _Composites(tree, n, meeting).M, key=_length)


def _length(M: list[Row]) -> int:
    return length([value for row in M for value in row.values()])


def _meetings(tree: FrameTree) -> dict[Place, dict[int, Motion]]:
    """Twists of the coordinates before a flexible body after the move that its modes make first, where they are few."""
    found: dict[Place, dict[int, Motion]] = {}
    if all(frame.inertia is None or not frame.inertia.momenta for frame in tree.frames):
        return found
    twists: list[dict[int, Motion]] = []
    for k, frame in enumerate(tree.frames):
        known = {} if frame.parent == GROUND else dict(twists[frame.parent])
        modes = set() if frame.inertia is None else set(frame.inertia.momenta)
        for place, move in enumerate(frame.moves):
            known = {column: _through(move, twist) for column, twist in known.items()}
            if modes & set(move.twists):
                if 0 < len(known) <= FEW and len(known) < len(modes):
                    found[k, place] = dict(known)
                modes = set()
            known |= move.twists
        twists.append(known)
    return found


def _through(move: Move, twist: Motion) -> Motion:
    """A twist of the frame before a move, seen after it: accelerations at rest are moved alike."""
    moved = move.motion(FrameMotion(zeros(), twist.omega, twist.v), {}, {})
    return Motion(moved.alpha, moved.a)


class _Composites:
    """meetings: twists by column and frame that come to momenta there; `M` is the result."""

    def __init__(self, tree: FrameTree, n: int, meetings: Mapping[Place, Mapping[int, Motion]]) -> None:
        self.M: list[Row] = [{} for _ in range(n)]
        beyond = [no_masses() for _ in tree.frames]
        momenta: list[Momenta] = [{} for _ in tree.frames]
        for k in reversed(range(len(tree.frames))):
            frame = tree.frames[k]
            if frame.inertia is not None:
                beyond[k] = beyond[k].plus(frame.inertia.rigid)
                _gather(momenta[k], frame.inertia.momenta)
                for (row, column), value in frame.inertia.own_masses().items():
                    self._add(row, column, value)
            composite, moved = beyond[k], momenta[k]
            for place, move in reversed(list(enumerate(frame.moves))):
                moved = self._whole(move, composite, moved)
                if (k, place) in meetings:
                    composite, moved = self._meet(meetings[k, place], composite, moved), {}
                before = {}
                for column, wrench in moved.items():
                    only = column in move.twists and column not in momenta[k]
                    before[column] = move.momentum(column, wrench, composite) if only else move.wrench(wrench)
                composite, moved = move.composite(composite), before
            if frame.parent != GROUND:
                beyond[frame.parent] = beyond[frame.parent].plus(composite)
                _gather(momenta[frame.parent], moved)

    def _whole(self, move: Move, composite: Inertia, moved: Momenta) -> Momenta:
        """Momenta after a move with those of its own coordinates, which the others meet here."""
        for column, wrench in moved.items():
            if column not in move.twists:
                for k, value in move.powers(wrench).items():
                    self._add(k, column, value)
        if isinstance(move, Bend | Unbend) and move.shared:
            return moved | self._by_parts(move, composite, moved)
        own = {column: composite.momentum(twist) for column, twist in move.twists.items()}
        powers = {column: move.powers(moved[column]) for column in own if column in moved}
        whole, columns = dict(moved), list(own)
        for place, k in enumerate(columns):
            whole[k] = own[k].plus(moved[k]) if k in moved else own[k]
            for other, value in move.powers(whole[k]).items():
                if other in columns[place:]:
                    self._add(k, other, add(value, powers[other][k]) if other in powers else value)
        return whole

    def _by_parts(self, move: Bend | Unbend, composite: Inertia, moved: Momenta) -> Momenta:
        """Of the modes of a move by their shares in common twists, of which each pair meets once."""
        parts = move.shared
        own = [composite.momentum(part.twist) for part in parts]
        common = [move.shared_powers(wrench) for wrench in own]
        known = {a: move.shared_powers(moved[a]) if a in moved else zeros(len(parts)) for a in move.twists}
        whole, columns = {}, list(move.twists)
        for place, a in enumerate(columns):
            shares = [part.shares.get(a, ZERO) for part in parts]
            found = plus(known[a], *(scaled(share, row) for share, row in zip(shares, common, strict=True)))
            for b in columns[place:]:
                value = dot([part.shares.get(b, ZERO) for part in parts], found)
                self._add(a, b, add(value, dot(shares, known[b])))
            mine = [Force(scaled(share, one.f), scaled(share, one.n)) for share, one in zip(shares, own, strict=True)]
            whole[a] = reduce(Force.plus, mine, moved.get(a, NOTHING))
        return whole

    def _meet(self, twists: Mapping[int, Motion], composite: Inertia, moved: Momenta) -> Inertia:
        """What coordinates nearer to the ground have in common with momenta, and with each other by this inertia."""
        rest = Inertia(ZERO, composite.h, composite.Sigma)
        columns = sorted(twists, key=lambda c: all(value.is_zero() for value in twists[c].omega), reverse=True)
        for place, column in enumerate(columns):
            own = rest.momentum(twists[column])
            for other in columns[place:]:
                self._add(min(column, other), max(column, other), own.along(twists[other]))
            for other, wrench in moved.items():
                self._add(min(column, other), max(column, other), wrench.along(twists[column]))
        return Inertia(composite.m, zeros(), no_masses().Sigma)

    def _add(self, i: int, j: int, value: ca.SX) -> None:
        add_to(self.M[i], j, value)
        if i != j and j in self.M[i]:
            self.M[j][i] = self.M[i][j]


def _gather(target: Momenta, more: Mapping[int, Force]) -> None:
    for column, wrench in more.items():
        target[column] = target[column].plus(wrench) if column in target else wrench
