"""Tables: piecewise polynomials that straight-line code calls as one operation, at a price that hardly depends on n.

A table is data beside the code. In SX expressions it is a call (ca.OP_CALL) of the Function `table_KEY_ORDER` of
table_function.py, on tapes a node whose value is `mark(key, order)`. The key is a hash of the numbers, so equal tables
are one, in every process; engines take the numbers from here by it.

A knot belongs to the row that it begins, so derivatives there are those from the right. Engines find the row by

    inside = min(x, last)                      NaN is taken to the last row, whose polynomial gives NaN
    bucket = trunc(max((inside - left) scale, 0))
    row = starts[bucket]                       knots in buckets before; of an even grid the bucket itself
    row += 2^l if inside >= knots[row + 2^l]   for l = levels - 1, ..., 0

Rounding is monotone, so what lies in a bucket before is less than x: the row is exact. levels is 1 on an even grid and
at most log2(n) elsewhere.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract import table_function

ORDERS = 8  # of derivatives, the value among them: what a mark has room for
LARGEST = np.finfo(float).max
NAME = re.compile(r"table_(\d+)_(\d)")
_SEARCH, _LEVEL, _ORIGIN, _POWER = 5, 4, 2, 3  # instructions: clamp and bucket, a halving, x - knot, a power


@dataclass(frozen=True, eq=False)
class Table:
    """Row r: the sum of powers[k, r] (x - knots[r])^k, from knots[r] to before knots[r + 1].

    knots (n + 1 and some that no x reaches,): the first twice, as the origin of what is before all of them.
    powers (degree + 1, n + 1). starts (buckets,), of an even grid (0,).
    """

    knots: np.ndarray
    powers: np.ndarray
    starts: np.ndarray
    left: float
    scale: float
    levels: int
    key: int

    @property
    def last(self) -> float:
        """The last knot."""
        return float(self.knots[self.powers.shape[1] - 1])

    def coefficients(self, order: int) -> np.ndarray:
        """(degree + 1 - order, rows) powers of the derivative of this order; (1, rows) zeros beyond the degree."""
        powers = self.powers
        for _ in range(order):
            powers = np.arange(1, len(powers))[:, None] * powers[1:] if len(powers) > 1 else 0 * powers
        return powers

    def __call__(self, x: np.ndarray | complex, order: int = 0) -> np.ndarray:
        """Values at x, or derivatives of this order; x may be complex, its real part chooses the row."""
        row = np.searchsorted(self.knots[1 : self.powers.shape[1]], np.real(x), side="right")
        powers, beyond = self.coefficients(order), x - self.knots[row]
        y = powers[-1][row]
        for power in powers[-2::-1]:
            y = power[row] + beyond * y
        return np.asarray(y)

    def instructions(self, order: int) -> int:
        """Of one evaluation."""
        search = _SEARCH + (self.starts.size > 0) + _LEVEL * self.levels
        return search + _ORIGIN + 1 + _POWER * (len(self.coefficients(order)) - 1)

    def plain(self) -> dict[str, Any]:
        """As data.json has it."""
        return {
            "key": self.key,
            "left": self.left,
            "scale": self.scale,
            "last": self.last,
            "levels": self.levels,
            "starts": self.starts.tolist(),
            "knots": self.knots.tolist(),
            "powers": self.powers.tolist(),
        }

    def shared(self) -> dict[str, Any]:
        """`plain`, as whoever makes Functions of it in this process has it: they are made once."""
        if self.key not in table_function.TABLES:
            table_function.TABLES[self.key] = self.plain()
        found: dict[str, Any] = table_function.TABLES[self.key]
        return found

    def function(self, order: int = 0) -> ca.Function:
        """What stands for it in expressions."""
        self.shared()
        return table_function.table(self.key, order)


_known: dict[int, Table] = {}  # by key, so each is the only one of its numbers


def table_of(points: np.ndarray, powers: np.ndarray) -> Table:
    """Polynomials (degree + 1, n + 1) before, between and behind rising points (n,), of which each begins a row."""
    knots, powers = np.append(points[0], points) + 0.0, np.asarray(powers, dtype=float) + 0.0  # no -0
    key = int.from_bytes(hashlib.sha256(knots.tobytes() + powers.tobytes()).digest()[:6])
    if key not in _known:
        starts, left, scale, levels = _buckets(points)
        knots = np.append(knots, np.full(1 << levels, LARGEST))
        _known[key] = Table(knots, powers, starts, left, scale, levels, key)
    return _known[key]


def table_from(plain: Mapping[str, Any]) -> Table:
    """The table of `Table.plain`, known from now on."""
    knots, powers, starts = (np.array(plain[name], dtype=float) for name in ("knots", "powers", "starts"))
    found = Table(knots, powers, starts, plain["left"], plain["scale"], plain["levels"], plain["key"])
    return _known.setdefault(found.key, found)


def _buckets(points: np.ndarray) -> tuple[np.ndarray, float, float, int]:
    """(starts, left, scale, levels): buckets about each point of an even grid, else as many as points."""
    n, first = len(points), float(points[0])
    with np.errstate(all="ignore"):
        length = (points[-1] - first) / (n - 1)
        for left in (first - length / 2, first):
            scale = float(1 / length) if np.isfinite(1 / length) else 0.0
            placed = np.nan_to_num((points - left) * scale, nan=0.0).astype(int)
            if np.array_equal(placed, np.arange(n)):
                return np.zeros(0), float(left), scale, 1
    counts = np.bincount(placed)
    starts = np.append(0, np.cumsum(counts)[:-1])
    return starts.astype(float), float(left), scale, int(counts.max()).bit_length()


def any_tables() -> bool:
    """Does this process know tables at all?"""
    return bool(_known)


def mark(key: int, order: int) -> float:
    """The value of a node that is a table."""
    return float(ORDERS * key + order)


def marked(value: float) -> tuple[Table, int]:
    """(table, order of the derivative) of a node's value."""
    key, order = divmod(int(value), ORDERS)
    return _known[key], order


def mark_of(function: ca.Function) -> float | None:
    """The value of a node that calls a Function; None if it is no table."""
    found = NAME.fullmatch(function.name())
    return mark(int(found[1]), int(found[2])) if found and int(found[1]) in _known else None
