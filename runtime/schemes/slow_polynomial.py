"""Slow accelerations y'' over a major step H as the polynomial through their values in the middles of major steps.

In units of H from the middle of a step: the values of this step and of those before it stand at 0, -1, -2, ..., the
step lasts from -1/2 to 1/2. From its start to a time e

    y' <- y' + H sum_k v_k y''_k,   y <- y + (e + 1/2) H y' + H^2 sum_k x_k y''_k,

v_k and x_k the integrals of the Lagrange polynomials L_k and of (e - s) L_k. With one value y'' is held. With four, and
three to predict the middle, the order is 4: for q'' = -w^2 q a step decays by (w H)^6 / 700, its phase is off by
(w H)^5 / 51, and it is stable up to w H = 1.22; with y'' held it decays by (w H)^4 / 16.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache

import casadi as ca
from numpy.polynomial import Polynomial

START = -0.5  # of the step, from its middle
FROM = (0.0, 0.5, 1.0)  # steps after the start from which values before it are extrapolated


def lagrange(nodes: Sequence[float]) -> list[Polynomial]:
    """Polynomials that are 1 at one node and 0 at the others."""
    found = []
    for node in nodes:
        one = Polynomial([1.0])
        for other in nodes:
            if other != node:
                one = one * Polynomial([-other, 1.0]) / (node - other)
        found.append(one)
    return found


@cache
def weights(first: int, count: int, end: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """(x_k, v_k) up to `end` for values at first, first - 1, ..."""
    polynomials = lagrange([float(first - k) for k in range(count)])
    rates = [one.integ() for one in polynomials]
    moved = [(Polynomial([end, -1.0]) * one).integ() for one in polynomials]
    return tuple(float(one(end) - one(START)) for one in moved), tuple(float(one(end) - one(START)) for one in rates)


def moved(values: Sequence[ca.SX], first: int, end: float, H: ca.SX) -> tuple[ca.SX, ca.SX]:
    """What values at first, first - 1, ... add to y beside (e + 1/2) H y', and to y', up to e = `end`."""
    by_position, by_rate = weights(first, len(values), end)
    scaled = ((by_position, H * H), (by_rate, H))  # products of H alone are made once a run
    x, v = (sum((w * by * y for w, y in zip(ones, values, strict=True)), ca.SX(0)) for ones, by in scaled)
    return x, v


def values_before(at: Callable[[ca.SX, ca.SX], ca.SX], y_ddot: ca.SX, H: ca.SX, count: int) -> list[ca.SX]:
    """y'' in the middles of `count` steps before the start of a run, by its parabola through the first step.

    at: (tau, third rate of y) -> y'' when y has moved so long. Nothing before the start is asked for: loads may have
    jumped there.
    """
    bend = (at(H / 2, ca.SX.zeros(y_ddot.numel())) - y_ddot) / (H / 2)
    seen = [y_ddot, *(at(share * H, bend) for share in FROM[1:])]
    polynomials = lagrange(FROM)
    return [
        sum((float(one(START - k)) * y for one, y in zip(polynomials, seen, strict=True)), ca.SX(0))
        for k in range(count)
    ]
