"""Interval arithmetic on straight-line code: what a function of one number may be over whole intervals of it.

Vectorised over intervals. Where a comparison, a sign or a rounding is not decided over an interval, the function may
jump there, which is said beside its bounds. An operation that is not listed may be anything.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import comb

import casadi as ca
import numpy as np

from runtime.contract.tape import UNUSED, Tape, marked, read_tape

Interval = tuple[np.ndarray, np.ndarray]
OPERATION_ROUNDING = 8 * np.finfo(float).eps  # relative: rounding of one operation, several times


class Enclosure:
    """Bounds of the outputs of an SX Function of one number, over intervals."""

    def __init__(self, function: ca.Function) -> None:
        self._tape: Tape = read_tape(function)

    def bounds(self, low: np.ndarray, high: np.ndarray) -> tuple[list[Interval], np.ndarray]:
        """(bounds of each entry of the first output, may it jump there?), each (N,), over [low, high] (N,)."""
        jumps = np.zeros(len(low), dtype=bool)
        values: list[Interval] = []
        with np.errstate(all="ignore"):
            for node in self._tape.nodes:
                if node.op == ca.OP_INPUT:
                    found = (low, high)
                elif node.op == ca.OP_CONST:
                    found = (np.full(len(low), node.value), np.full(len(low), node.value))
                elif node.op in COMPARISONS:
                    found = COMPARISONS[node.op](values[node.a], values[node.b] if node.b != UNUSED else values[node.a])
                    jumps |= found[0] != found[1]
                elif node.op == ca.OP_CALL:
                    least, most, jump = bounds_of(node.value)(*values[node.a])
                    found, jumps = (least, most), jumps | jump
                elif node.op in UNARY and node.b == UNUSED:
                    found = UNARY[node.op](*values[node.a])
                elif node.op in BINARY_BOUNDS:
                    found = BINARY_BOUNDS[node.op](values[node.a], values[node.b])
                else:
                    found = _anything(low)
                    jumps |= True
                values.append(found if node.op in EXACT_OPERATIONS else _widened(found))
        return [values[entry] for entry in self._tape.outputs[0]], jumps


def _anything(like: np.ndarray) -> Interval:
    return np.full(len(like), -np.inf), np.full(len(like), np.inf)


def _widened(found: Interval) -> Interval:
    """By rounding; what is not a number may be anything."""
    low, high = found
    low = np.where(np.isnan(low), -np.inf, low - OPERATION_ROUNDING * np.abs(np.where(np.isfinite(low), low, 0.0)))
    high = np.where(np.isnan(high), np.inf, high + OPERATION_ROUNDING * np.abs(np.where(np.isfinite(high), high, 0.0)))
    return low, high


def _monotone(function: Callable[[np.ndarray], np.ndarray]) -> Callable[[np.ndarray, np.ndarray], Interval]:
    return lambda low, high: (function(low), function(high))


def _extremes(*corners: np.ndarray) -> Interval:
    stacked = np.array(corners)
    unknown = np.isnan(stacked).any(axis=0)
    return np.where(unknown, -np.inf, stacked.min(axis=0)), np.where(unknown, np.inf, stacked.max(axis=0))


def _times(a: Interval, b: Interval) -> Interval:
    return _extremes(a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1])


def _inverse(low: np.ndarray, high: np.ndarray) -> Interval:
    through = (low <= 0) & (high >= 0)
    return np.where(through, -np.inf, 1 / high), np.where(through, np.inf, 1 / low)


def _magnitude(low: np.ndarray, high: np.ndarray) -> Interval:
    through = (low <= 0) & (high >= 0)
    return np.where(through, 0.0, np.minimum(np.abs(low), np.abs(high))), np.maximum(np.abs(low), np.abs(high))


def _square(low: np.ndarray, high: np.ndarray) -> Interval:
    least, most = _magnitude(low, high)
    return least * least, most * most


def _cosine(low: np.ndarray, high: np.ndarray) -> Interval:
    turn = 2 * np.pi
    top = np.ceil(low / turn) * turn <= high
    bottom = np.ceil((low - np.pi) / turn) * turn + np.pi <= high
    at = np.cos(low), np.cos(high)
    slack = OPERATION_ROUNDING * (1 + np.maximum(np.abs(low), np.abs(high)))  # of the argument, which may be large
    return np.where(bottom, -1.0, np.minimum(*at) - slack), np.where(top, 1.0, np.maximum(*at) + slack)


def _tangent(low: np.ndarray, high: np.ndarray) -> Interval:
    pole = np.floor(low / np.pi + 0.5) != np.floor(high / np.pi + 0.5)
    return np.where(pole, -np.inf, np.tan(low)), np.where(pole, np.inf, np.tan(high))


def _power(a: Interval, b: Interval) -> Interval:
    """Of a base that is not negative by its corners; a whole exponent takes any base by its magnitude."""
    corners = _extremes(a[0] ** b[0], a[0] ** b[1], a[1] ** b[0], a[1] ** b[1])
    most = np.maximum(np.abs(a[0]), np.abs(a[1])) ** b[0]
    whole = (b[0] == b[1]) & (np.rint(b[0]) == b[0]) & (b[0] >= 0)
    low, high = np.where(whole, -most, -np.inf), np.where(whole, most, np.inf)
    return np.where(a[0] >= 0, corners[0], low), np.where(a[0] >= 0, corners[1], high)


def _where(condition: Interval, value: Interval) -> Interval:
    """value where the condition holds, zero elsewhere."""
    never, always = (condition[0] == 0) & (condition[1] == 0), (condition[0] > 0) | (condition[1] < 0)
    low = np.where(always, value[0], np.where(never, 0.0, np.minimum(value[0], 0.0)))
    return low, np.where(always, value[1], np.where(never, 0.0, np.maximum(value[1], 0.0)))


def _truth(sure: np.ndarray, possible: np.ndarray) -> Interval:
    return sure.astype(float), possible.astype(float)


def _equal(a: Interval, b: Interval) -> Interval:
    return _truth((a[0] == a[1]) & (b[0] == b[1]) & (a[0] == b[0]), (a[0] <= b[1]) & (b[0] <= a[1]))


def _opposite(truth: Interval) -> Interval:
    return 1 - truth[1], 1 - truth[0]


COMPARISONS: dict[int, Callable[[Interval, Interval], Interval]] = {
    ca.OP_LT: lambda a, b: _truth(a[1] < b[0], a[0] < b[1]),
    ca.OP_LE: lambda a, b: _truth(a[1] <= b[0], a[0] <= b[1]),
    ca.OP_EQ: _equal,
    ca.OP_NE: lambda a, b: _opposite(_equal(a, b)),
    ca.OP_SIGN: lambda a, b: (np.sign(a[0]), np.sign(a[1])),
    ca.OP_FLOOR: lambda a, b: (np.floor(a[0]), np.floor(a[1])),
    ca.OP_CEIL: lambda a, b: (np.ceil(a[0]), np.ceil(a[1])),
}
UNARY: dict[int, Callable[[np.ndarray, np.ndarray], Interval]] = {
    ca.OP_NEG: lambda low, high: (-high, -low),
    ca.OP_TWICE: lambda low, high: (2 * low, 2 * high),
    ca.OP_NOT: lambda low, high: (1 - high, 1 - low),
    ca.OP_SQ: _square,
    ca.OP_FABS: _magnitude,
    ca.OP_INV: _inverse,
    ca.OP_SQRT: _monotone(np.sqrt),
    ca.OP_EXP: _monotone(np.exp),
    ca.OP_LOG: _monotone(np.log),
    ca.OP_SIN: lambda low, high: _cosine(low - np.pi / 2, high - np.pi / 2),
    ca.OP_COS: _cosine,
    ca.OP_TAN: _tangent,
    ca.OP_ASIN: _monotone(np.arcsin),
    ca.OP_ACOS: lambda low, high: (np.arccos(high), np.arccos(low)),
    ca.OP_ATAN: _monotone(np.arctan),
    ca.OP_SINH: _monotone(np.sinh),
    ca.OP_COSH: lambda low, high: _monotone(np.cosh)(*_magnitude(low, high)),
    ca.OP_TANH: _monotone(np.tanh),
}
BINARY_BOUNDS: dict[int, Callable[[Interval, Interval], Interval]] = {
    ca.OP_ADD: lambda a, b: (a[0] + b[0], a[1] + b[1]),
    ca.OP_SUB: lambda a, b: (a[0] - b[1], a[1] - b[0]),
    ca.OP_MUL: _times,
    ca.OP_DIV: lambda a, b: _times(a, _inverse(*b)),
    ca.OP_POW: _power,
    ca.OP_CONSTPOW: _power,
    ca.OP_FMIN: lambda a, b: (np.minimum(a[0], b[0]), np.minimum(a[1], b[1])),
    ca.OP_FMAX: lambda a, b: (np.maximum(a[0], b[0]), np.maximum(a[1], b[1])),
    ca.OP_AND: lambda a, b: (a[0] * b[0], a[1] * b[1]),
    ca.OP_OR: lambda a, b: (np.maximum(a[0], b[0]), np.maximum(a[1], b[1])),
    ca.OP_IF_ELSE_ZERO: _where,
}
EXACT_OPERATIONS = {*COMPARISONS, ca.OP_NOT, ca.OP_AND, ca.OP_OR, ca.OP_FMIN, ca.OP_FMAX, ca.OP_NEG, ca.OP_FABS}


# Bounds of a table over intervals: of part of a row by Bernstein's coefficients, of whole rows by their extremes.

TABLE_SLACK = 32 * np.finfo(float).eps  # relative: rounding of a polynomial
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
        self._least, self._most = np.append(low, np.inf), np.append(high, -np.inf)
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
        whole = last > first + 1  # rows between
        rows = np.minimum(np.column_stack([first, last - 1]), len(self._least) - 1)[whole].ravel()
        if len(rows):
            least[whole] = np.minimum(least[whole], np.minimum.reduceat(self._least, rows)[::2])
            most[whole] = np.maximum(most[whole], np.maximum.reduceat(self._most, rows)[::2])
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
            slack = TABLE_SLACK * sum(
                np.abs(powers[k]) * np.maximum(np.abs(begin), np.abs(end)) ** k for k in range(degree + 1)
            )
        return np.min(found, axis=0) - slack, np.max(found, axis=0) + slack


@cache
def bounds_of(value: float) -> TableBounds:
    """Of the table with this mark."""
    return TableBounds(value)
