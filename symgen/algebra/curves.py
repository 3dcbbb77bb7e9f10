"""Curves through points as sums over the intervals: y = y_0 + sum of p_k(min(max(x - x_k, 0), h_k)).

p_k is what the curve rises within interval k, a polynomial with p_k(0) = 0. Nothing is looked up and nothing cancels;
coefficients depend on the points only, so they are computed once a run. A point belongs to the interval that it begins,
so that derivatives there are those from the right.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, div, mul, sub, total


def curve(x: ca.SX, points: Sequence[ca.SX], values: Sequence[ca.SX], cubic: bool, extend: bool) -> ca.SX:
    """y at x of the straight lines, or the natural cubic spline, through the points.

    Outside it stays at its first and last value, or goes on straight (extend).
    """
    last = len(points) - 1
    h = [sub(after, before) for before, after in zip(points, points[1:], strict=False)]
    slopes = [div(sub(values[k + 1], values[k]), h[k]) for k in range(last)]
    bends = _bends(h, slopes) if cubic else [ZERO] * (last + 1)
    parts, passed = [values[0]], [x >= point for point in points]
    for k in range(last):
        inside = sub(passed[k], passed[k + 1])
        way = add(mul(inside, sub(x, points[k])), mul(passed[k + 1], h[k]))
        begin = sub(slopes[k], mul(h[k], (2 * bends[k] + bends[k + 1]) / 6))
        rise = add(bends[k] / 2, mul(way, div(sub(bends[k + 1], bends[k]), 6 * h[k])))
        parts.append(mul(way, add(begin, mul(way, rise))))
        if extend and k == 0:
            parts.append(mul(begin, mul(sub(ONE, passed[0]), sub(x, points[0]))))
        if extend and k == last - 1:
            end = add(slopes[k], mul(h[k], (bends[k] + 2 * bends[k + 1]) / 6))
            parts.append(mul(end, mul(passed[last], sub(x, points[last]))))
    return total(parts)


def _bends(h: Sequence[ca.SX], slopes: Sequence[ca.SX]) -> list[ca.SX]:
    """Second derivatives at the points, zero at both ends: the tridiagonal system of the natural spline."""
    n = len(h) + 1
    upper, right = [ZERO] * n, [ZERO] * n
    for k in range(1, n - 1):
        pivot = div(ONE, sub(2 * (h[k - 1] + h[k]), mul(h[k - 1], upper[k - 1])))
        upper[k] = mul(h[k], pivot)
        right[k] = mul(sub(6 * (slopes[k] - slopes[k - 1]), mul(h[k - 1], right[k - 1])), pivot)
    for k in range(n - 2, 0, -1):
        right[k] = sub(right[k], mul(upper[k], right[k + 1]))
    return right
