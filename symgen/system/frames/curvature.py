"""Second derivatives of the ways to the markers of a joint that closes a loop, weighted by its multipliers.

Of two coordinates on a way the one that comes first turns what the other does, d^2 r / dq_j dq_k = t_j x dr/dq_k, and
an axis n alike with dn/dq_k = t_k x n. Between modes of one body at one marker there is more: its axes there turn by
`Bent.turned`, which depends on the modes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ZERO, add, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, cross, plus, scaled, zeros
from symgen.joints.joint import AxisPair
from symgen.system.frames.paths import ModesOnWay, Path, PathColumn


@dataclass(frozen=True)
class LoopCurvature:
    """Of a joint between the ends of two ways: r_b - r_a = 0, and products of axes of a and of b that vanish."""

    a: Path
    b: Path
    products: Sequence[AxisPair]

    def weighted(self, multipliers: list[ca.SX]) -> dict[int, Row]:
        """Rows by column of sum lambda_r d^2 C_r / dq^2."""
        F = multipliers[:3]
        found = _Entries()
        _point(found, self.b, F)
        _point(found, self.a, scaled(ca.SX(-1), F))
        for n, weighted in self._by_axis(multipliers[3:]):
            u = plus(*weighted)
            _direction(found, self.b, n, u)
            _direction(found, self.a, u, n)
            of_a, of_b = _turned(self.a, u), _turned(self.b, n)
            for j, first in of_a.items():
                for k, second in of_b.items():
                    found.pair(j, k, dot(first, second))
        return found.rows

    def _by_axis(self, multipliers: list[ca.SX]) -> list[tuple[Vector, list[Vector]]]:
        """Axes of b, each with what it is multiplied by: axes of a, weighted."""
        found: dict[int, list[Vector]] = {}
        for (_, of_a, of_b), value in zip(self.products, multipliers, strict=True):
            found.setdefault(of_b, []).append(scaled(value, self.a.axes[of_a]))
        return [(self.b.axes[axis], weighted) for axis, weighted in found.items()]


class _Entries:
    """Both triangles of a symmetric matrix."""

    def __init__(self) -> None:
        self.rows: dict[int, Row] = {}

    def pair(self, j: int, k: int, value: ca.SX) -> None:
        """A second derivative by two coordinates of different moves; both may be the same column."""
        self.single(j, k, value)
        self.single(k, j, value)

    def single(self, j: int, k: int, value: ca.SX) -> None:
        """One entry."""
        add_to(self.rows.setdefault(j, {}), k, value)


def _turned(path: Path, n: Vector) -> dict[int, Vector]:
    """Change of an axis at the end of a path, by column."""
    found: dict[int, Vector] = {}
    for cause in path.causes:
        if cause.turns is not None:
            change = cross(cause.turns, n)
            found[cause.column] = plus(found[cause.column], change) if cause.column in found else change
    return found


def _point(found: _Entries, path: Path, F: Vector) -> None:
    """F . d^2 r / dq^2 of the end."""
    to_end = path.to_end()
    changes = [path.moved(cause, to_end) for cause in path.causes]
    rests = [to_end[cause.before] for cause in path.causes]
    _way(found, path, F, changes, rests, moving=True)


def _direction(found: _Entries, path: Path, n: Vector, u: Vector) -> None:
    """u . d^2 n / dq^2 of an axis at the end."""
    changes = [zeros() if cause.turns is None else cross(cause.turns, n) for cause in path.causes]
    _way(found, path, u, changes, [n] * len(changes), moving=False)


def _way(found: _Entries, path: Path, weight: Vector, changes: list[Vector], rests: list[Vector], moving: bool) -> None:
    """changes: what each cause does; rests: what it turns; moving: are the shapes of modes part of it?"""
    later: dict[int, Vector] = {}
    causes = path.causes
    k = len(causes) - 1
    while k >= 0:
        group = _same_move(causes, k)
        for place in group:
            cause = causes[place]
            if cause.turns is not None:
                arm = cross(weight, cause.turns)
                for column, change in later.items():
                    found.pair(cause.column, column, dot(arm, change))
                if cause.modes is None:
                    found.single(cause.column, cause.column, dot(arm, changes[place]))
        modes = causes[k].modes
        if modes is not None:
            _modes(found, modes, weight, rests[k], moving)
        for place in group:
            column, change = causes[place].column, changes[place]
            later[column] = plus(later[column], change) if column in later else change
        k -= len(group)


def _same_move(causes: list[PathColumn], last: int) -> range:
    """The places of the causes that belong to the move of one of them, its last."""
    modes = causes[last].modes
    return range(last, last - 1, -1) if modes is None else range(last - len(modes.columns) + 1, last + 1)


def _modes(found: _Entries, modes: ModesOnWay, weight: Vector, rest: Vector, moving: bool) -> None:
    """Between modes of one move, in the body's axes."""
    bent = modes.bent
    w, y = ([dot(axis, vector) for axis in modes.axes] for vector in (weight, rest))
    across = cross(y, w)
    for b, column in enumerate(modes.columns):
        turned = cross(w, bent.turned[b])
        for a in range(b + 1):
            shapes = (bent.shapes[a], bent.shapes[b]) if moving else (zeros(), zeros())
            bending = neg(_bending(modes, a, b, w)) if moving else ZERO
            value = dot(turned, plus(cross(bent.turned[a], y), shapes[0] if modes.back else zeros()))
            more = bent.twice_turned(a, b, across) if modes.back else bent.twice_turned(b, a, across)
            if modes.back:
                value = sub(add(value, dot(bent.turned[a], cross(shapes[1], w))), add(more, bending))
            else:
                value = add(add(value, more), bending)
            if a == b:
                found.single(column, column, value)
            else:
                found.pair(modes.columns[a], column, value)


def _bending(modes: ModesOnWay, a: int, b: int, w: Vector) -> ca.SX:
    """H of the marker along w: what its shapes lose as modes a and b grow."""
    total = ZERO
    for i, H in enumerate(modes.bent.point.H):
        total = add(total, mul(H[a][b], w[i]))
    return total
