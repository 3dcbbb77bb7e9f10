"""Bounds of a table over intervals: of part of a row by Bernstein's coefficients, of many rows by their extremes."""

from __future__ import annotations

from functools import cache
from math import comb

import numpy as np

from runtime.contract.tape import marked

SLACK = 32 * np.finfo(float).eps  # relative: rounding of a polynomial
CONTINUOUS = 1e-10  # relative: what two rows may differ by at their knot


class TableBounds:
    """What a table, by its mark, may be over intervals."""

    def __init__(self, value: float) -> None:
        table, order = marked(value)
        self._powers = table.coefficients(order)
        rows = self._powers.shape[1]
        self._knots = table.knots[:rows]
        inner = np.arange(1, rows - 1)
        width = np.diff(self._knots)[1:]
        low, high = self._over(inner, np.zeros(rows - 2), width)
        self._least, self._most = _doubling(low, np.minimum), _doubling(high, np.maximum)
        ends = self._at(np.arange(1, rows - 1), width) - self._powers[0, 2:]
        begin = self._powers[0, 1] - self._powers[0, 0]
        size = np.abs(self._powers[0]).max()
        self.jumps = bool(max(np.abs(ends).max(initial=0.0), abs(begin)) > CONTINUOUS * size)

    def __call__(self, low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(least, most, does it jump there?) over [low, high], each (N,)."""
        first, last = (np.searchsorted(self._knots[1:], x, side="right") for x in (low, high))
        several = last > first
        ends = np.where(several, self._knots[np.minimum(first + 1, len(self._knots) - 1)], high)
        least, most = self._over(first, low - self._knots[first], ends - self._knots[first])
        begin, end = self._over(last, 0.0 * high, high - self._knots[last])
        least, most = np.where(several, np.minimum(least, begin), least), np.where(several, np.maximum(most, end), most)
        count = np.maximum(last - first - 1, 0)  # whole rows between
        k = np.frexp(np.maximum(count, 1))[1] - 1
        one, other = np.minimum(first, len(self._least[0]) - 1), np.maximum(last - 1 - (1 << k), 0)
        inside = np.minimum(self._least[k, one], self._least[k, other])
        beyond = np.maximum(self._most[k, one], self._most[k, other])
        least, most = (
            np.where(count > 0, np.minimum(least, inside), least),
            np.where(count > 0, np.maximum(most, beyond), most),
        )
        return least, most, several & self.jumps

    def _at(self, rows: np.ndarray, s: np.ndarray) -> np.ndarray:
        y = self._powers[-1, rows]
        for power in self._powers[-2::-1]:
            y = power[rows] + s * y
        return np.asarray(y)

    def _over(self, rows: np.ndarray, begin: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(least, most) of rows from `begin` to `end` behind their knots: those of the Bernstein coefficients."""
        powers, degree = self._powers[:, rows], len(self._powers) - 1
        with np.errstate(all="ignore"):
            shifted = [
                sum(comb(j, k) * powers[j] * begin ** (j - k) for j in range(k, degree + 1)) for k in range(degree + 1)
            ]
            terms = [shifted[k] * (end - begin) ** k if k else shifted[0] for k in range(degree + 1)]
            found = [sum(comb(i, j) / comb(degree, j) * terms[j] for j in range(i + 1)) for i in range(degree + 1)]
            slack = SLACK * sum(
                np.abs(powers[k]) * np.maximum(np.abs(begin), np.abs(end)) ** k for k in range(degree + 1)
            )
        return np.min(found, axis=0) - slack, np.max(found, axis=0) + slack


def _doubling(values: np.ndarray, extreme: np.ufunc) -> np.ndarray:
    """[k, r]: the extreme of rows r to r + 2^k - 1, as far as there are so many."""
    found = [values if len(values) else np.zeros(1)]
    while 2 << (len(found) - 1) <= len(values):
        before, half = found[-1], 1 << (len(found) - 1)
        found.append(np.append(extreme(before[:-half], before[half:]), before[-half:]))
    return np.array(found)


@cache
def bounds_of(value: float) -> TableBounds:
    """Of the table with this mark."""
    return TableBounds(value)
