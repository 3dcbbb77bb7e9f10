"""Expressions as polynomials in a few variables: coefficients that hold still while the variables move."""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.scalar import ZERO, add, mul

POINTS = 3  # at which a coefficient that is always zero is told from one that is not
NOTHING = 1e-14  # of the largest coefficient: what cancels leaves no more


def collected(values: list[ca.SX], variables: ca.SX) -> list[ca.SX]:
    """The values as polynomials up to the second degree in the variables; others are left as they are.

    A coefficient counts as zero that cancels at POINTS random values of all symbols: cos^2 + sin^2 - 1 is one.
    """
    return [_collected(value, variables) for value in values]


def _collected(value: ca.SX, variables: ca.SX) -> ca.SX:
    if not ca.depends_on(value, variables):
        return value
    slope = ca.jacobian(value, variables)
    bend = ca.jacobian(slope, variables)
    if ca.depends_on(bend, variables):
        return value
    n, at_zero = variables.numel(), ca.SX.zeros(variables.numel())
    constant, linear = ca.substitute([value, ca.densify(slope)], [variables], [at_zero])
    square = ca.densify(bend)
    alive = _alive(ca.vertcat(constant, ca.vec(linear), ca.vec(square)))
    total = constant if alive[0] else ZERO
    for k in range(n):
        factor = linear[k] if alive[1 + k] else ZERO
        for j in range(k, n):
            if alive[1 + n + k * n + j]:
                factor = add(factor, mul(square[k, j] / (2 if j == k else 1), variables[j]))
        total = add(total, mul(factor, variables[k]))
    return total


def _alive(coefficients: ca.SX) -> np.ndarray:
    """Which of them are not zero, whatever the values of their symbols."""
    symbols = ca.symvar(coefficients)
    function, random = ca.Function("coefficients", symbols, [coefficients]), np.random.default_rng(0)
    found = [
        np.abs(np.array(function.call([float(x) for x in random.uniform(0.3, 1.7, len(symbols))])[0])).ravel()
        for _ in range(POINTS)
    ]
    return np.array(~(np.array(found) <= NOTHING * np.nanmax(found, axis=1, keepdims=True)).all(axis=0))
