"""Straight-line factorisation of small sparse matrices, real or complex, kept for several right-hand sides.

A matrix is a dictionary {(row, column): entry} of what is not zero. No pivoting, last unknown first: see
linear_solve.py for why that is safe and leaves no fill-in.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca


@dataclass(frozen=True)
class Complex:
    """A complex number of two SX."""

    re: ca.SX
    im: ca.SX

    def __add__(self, other: Complex) -> Complex:
        return Complex(self.re + other.re, self.im + other.im)

    def __sub__(self, other: Complex) -> Complex:
        return Complex(self.re - other.re, self.im - other.im)

    def __mul__(self, other: Complex) -> Complex:
        return Complex(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def reciprocal(self) -> Complex:
        """1 / self."""
        scale = 1 / (self.re * self.re + self.im * self.im)
        return Complex(self.re * scale, -self.im * scale)


@dataclass(frozen=True)
class Real:
    """A real number with the same interface."""

    re: ca.SX

    def __add__(self, other: Real) -> Real:
        return Real(self.re + other.re)

    def __sub__(self, other: Real) -> Real:
        return Real(self.re - other.re)

    def __mul__(self, other: Real) -> Real:
        return Real(self.re * other.re)

    def reciprocal(self) -> Real:
        """1 / self."""
        return Real(1 / self.re)


Number = Real | Complex
Entries = dict[tuple[int, int], Number]


def factor(matrix: Entries, n: int) -> Entries:
    """L below, U above the reversed diagonal, reciprocal pivots on it; keys in sorted order."""
    entries = dict(matrix)
    for k in reversed(range(n)):
        entries[k, k] = entries[k, k].reciprocal()
        row = [j for j in range(k) if (k, j) in entries]
        for i in range(k):
            if (i, k) not in entries:
                continue
            ratio = entries[i, k] * entries[k, k]  # type: ignore[operator]
            entries[i, k] = ratio
            for j in row:
                product = ratio * entries[k, j]  # type: ignore[operator]
                entries[i, j] = entries[i, j] - product if (i, j) in entries else _minus(product)  # type: ignore
    return dict(sorted(entries.items()))


def _minus(value: Number) -> Number:
    return Complex(-value.re, -value.im) if isinstance(value, Complex) else Real(-value.re)


def solve(factors: Entries, b: list[Number]) -> list[Number]:
    """x of A x = b from the factors of A."""
    n, x = len(b), list(b)
    for k in reversed(range(n)):
        for i in range(k):
            if (i, k) in factors:
                x[i] = x[i] - factors[i, k] * x[k]  # type: ignore[operator]
    for k in range(n):
        total = x[k]
        for j in range(k):
            if (k, j) in factors:
                total = total - factors[k, j] * x[j]  # type: ignore[operator]
        x[k] = total * factors[k, k]  # type: ignore[operator]
    return x


def pattern(matrix: ca.SX) -> list[tuple[int, int]]:
    """Where a matrix is not zero."""
    rows, columns = matrix.shape
    return [(i, j) for i in range(rows) for j in range(columns) if not matrix[i, j].is_zero()]
