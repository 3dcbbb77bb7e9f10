"""The mass matrix of a tree of frames: the composite-rigid-body algorithm, from the tips to the root (Eq. 38).

R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, ch. 6.

The composite inertia I^C of all that is beyond a transform has the momentum I^C S for a unit rate of each of its
coordinates, which goes to the root and is met there by the other coordinates: a transform costs each momentum two
rotations. What rates of several modes do alike (`TwistColumn`) is met once, and each has its share. Where a flexible
body has more modes than there are coordinates before it, the twists of those come to the body instead (`_meetings`), in
whose axes they meet the momenta; of its mass, a point mass at its origin goes on.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ZERO, add, dot, length
from symgen.algebra.vectors import plus, scaled, zeros
from symgen.system.frames.joint_transforms import JointTransform
from symgen.system.frames.spatial_algebra import NOTHING, Force, FrameMotion, Inertia, Motion, gather, no_masses
from symgen.system.frames.tree import GROUND, FrameTree

FEW_COORDINATES = 3  # coordinates before a flexible body, up to which their twists may be the shorter way

Meetings = Mapping[tuple[int, int], dict[int, Motion]]  # by frame and one of its transforms: twists by column
Momenta = dict[int, Force]


def mass_rows(tree: FrameTree, n: int) -> list[Row]:
    """M of all coordinates (n columns), both triangles; rows of coordinates that the tree does not have are empty."""
    meetings = _meetings(tree)
    ways = [_Composites(tree, n, chosen).M for chosen in ({}, meetings)[: 1 + bool(meetings)]]
    return min(ways, key=lambda M: length([value for row in M for value in row.values()])) if meetings else ways[0]


class _Composites:
    """meetings: twists that come to momenta; `M` is the result."""

    def __init__(self, tree: FrameTree, n: int, meetings: Meetings) -> None:
        self.M: list[Row] = [{} for _ in range(n)]
        inertias = [no_masses() for _ in tree.frames]
        momenta: list[Momenta] = [{} for _ in tree.frames]
        for k in reversed(range(len(tree.frames))):
            frame = tree.frames[k]
            if frame.inertia is not None:
                inertias[k] = inertias[k].plus(frame.inertia.rigid)
                gather(momenta[k], frame.inertia.momenta)
                for (row, column), value in frame.inertia.own_masses().items():
                    self._add(row, column, value)
            I_C, h = inertias[k], momenta[k]
            for place, transform in reversed(list(enumerate(frame.transforms))):
                own = self._own(transform, I_C, h)
                h = h | own
                if (k, place) in meetings:
                    I_C, h = self._meet(meetings[k, place], I_C, h), {}
                h = {column: transform.wrench(one) for column, one in h.items()}
                I_C = transform.composite(I_C)
            if frame.parent != GROUND:
                inertias[frame.parent] = inertias[frame.parent].plus(I_C)
                gather(momenta[frame.parent], h)

    def _own(self, transform: JointTransform, I_C: Inertia, h: Momenta) -> Momenta:
        """Momenta of the transform's coordinates, with what is beyond it; they meet each other and all others."""
        columns, parts = list(transform.twists), transform.twist_columns
        for column, wrench in h.items():
            for k, value in transform.powers(wrench).items() if column not in columns else ():
                self._add(k, column, value)
        shares = {column: [part.shares.get(column, ZERO) for part in parts] for column in columns}
        momenta = [I_C.momentum(part.twist) for part in parts]
        common = [transform.column_powers(one) for one in momenta]
        known = {column: transform.column_powers(h[column]) if column in h else zeros(len(parts)) for column in columns}
        own: Momenta = {}
        for place, a in enumerate(columns):
            found = plus(known[a], *(scaled(share, row) for share, row in zip(shares[a], common, strict=True)))
            for b in columns[place:]:
                self._add(a, b, add(dot(shares[b], found), dot(shares[a], known[b])))
            mine = [one.scaled(share) for share, one in zip(shares[a], momenta, strict=True) if not share.is_zero()]
            own[a] = reduce(Force.plus, mine, h.get(a, NOTHING))
        return own

    def _meet(self, twists: Mapping[int, Motion], I_C: Inertia, h: Momenta) -> Inertia:
        """What coordinates nearer to the ground have in common with momenta, and with each other by this inertia."""
        rest = Inertia(ZERO, I_C.h, I_C.Sigma)
        columns = sorted(twists, key=lambda c: all(value.is_zero() for value in twists[c].omega), reverse=True)
        for place, column in enumerate(columns):
            own = rest.momentum(twists[column])
            for other in columns[place:]:
                self._add(min(column, other), max(column, other), own.along(twists[other]))
            for other, wrench in h.items():
                self._add(min(column, other), max(column, other), wrench.along(twists[column]))
        return Inertia(I_C.m, zeros(), no_masses().Sigma)

    def _add(self, i: int, j: int, value: ca.SX) -> None:
        add_to(self.M[i], j, value)
        if i != j and j in self.M[i]:
            self.M[j][i] = self.M[i][j]


def _meetings(tree: FrameTree) -> Meetings:
    """Twists of the coordinates before a flexible body after the transform by its modes, where they are few."""
    found: dict[tuple[int, int], dict[int, Motion]] = {}
    twists: list[dict[int, Motion]] = []
    for k, frame in enumerate(tree.frames if tree.flexible else []):
        known = {} if frame.parent == GROUND else dict(twists[frame.parent])
        modes = frame.modes
        for place, transform in enumerate(frame.transforms):
            known = {column: _through(transform, twist) for column, twist in known.items()}
            own = transform.twists
            if modes & own.keys():
                if 0 < len(known) <= FEW_COORDINATES and len(known) < len(modes):
                    found[k, place] = dict(known)
                modes = set()
            known |= own
        twists.append(known)
    return found


def _through(transform: JointTransform, twist: Motion) -> Motion:
    """A twist of the frame before a transform, seen after it: accelerations at rest are moved alike."""
    moved = transform.motion(FrameMotion(zeros(), twist.omega, twist.v), {}, {})
    return Motion(moved.alpha, moved.a)
