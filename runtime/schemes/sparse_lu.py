"""Straight-line factorisation of sparse SX matrices, real or complex, kept for several right-hand sides.

LDL^T of what is symmetric (Cholesky's without roots), LU of what is not.

No pivoting, last unknown first: see below for why that is safe and leaves no fill-in. All is written in
sparse vectors and matrices, so that CasADi, not Python, goes through the entries.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import casadi as ca

Cells = set[tuple[int, int]]


@dataclass(frozen=True)
class Number:
    """A real or complex number, vector or matrix of SX; im is None for a real one."""

    re: ca.SX
    im: ca.SX | None = None

    def each(self, change: Callable[[ca.SX], ca.SX]) -> Number:
        """The same change of the real and of the imaginary part."""
        return Number(change(self.re), None if self.im is None else change(self.im))

    def __getitem__(self, index: Any) -> Number:
        return self.each(lambda part: part[index])

    def __sub__(self, other: Number) -> Number:
        if self.im is None or other.im is None:
            return Number(self.re - other.re)
        return Number(self.re - other.re, self.im - other.im)

    def __matmul__(self, other: Number) -> Number:
        if self.im is None or other.im is None:
            return Number(ca.mtimes(self.re, other.re))
        return Number(
            ca.mtimes(self.re, other.re) - ca.mtimes(self.im, other.im),
            ca.mtimes(self.re, other.im) + ca.mtimes(self.im, other.re),
        )

    def __neg__(self) -> Number:
        return self.each(lambda part: -part)

    def reciprocal(self) -> Number:
        """1 / self, of a number."""
        if self.im is None:
            return Number(1 / self.re)
        scale = 1 / (self.re * self.re + self.im * self.im)
        return Number(self.re * scale, -self.im * scale)


def joined(parts: Iterable[Number], join: Callable[..., ca.SX]) -> Number:
    """Numbers side by side or one above another."""
    parts = list(parts)
    imaginary = [part.im for part in parts if part.im is not None]
    return Number(join(*(part.re for part in parts)), join(*imaginary) if imaginary else None)


def factor(matrix: Number, symmetric: bool = False) -> Number:
    """L below, U above the reversed diagonal, reciprocal pivots on it; symmetric: from the upper triangle of matrix."""
    n, left = matrix.re.shape[0], matrix
    columns, rows = [], []
    for k in reversed(range(n)):
        if symmetric:
            left = left.each(lambda part: ca.triu2symm(ca.triu(part)))
        pivot, row = left[k, k].reciprocal(), left[k, :k]
        column = left[:k, k] @ pivot
        left = left[:k, :k] - column @ row
        columns.append(joined([column, pivot], ca.vertcat).each(_padded(n, 1)))
        rows.append(row.each(_padded(1, n)))
    upper, lower = joined(reversed(columns), ca.horzcat), joined(reversed(rows), ca.vertcat)
    if upper.im is None or lower.im is None:
        return Number(upper.re + lower.re)
    return Number(upper.re + lower.re, upper.im + lower.im)


def _padded(rows: int, columns: int) -> Callable[[ca.SX], ca.SX]:
    """Zeros below and to the right."""

    def pad(part: ca.SX) -> ca.SX:
        return ca.diagcat(part, ca.SX(rows - part.shape[0], columns - part.shape[1]))

    return pad


def solve(factors: Number, b: Number) -> Number:
    """x of A x = b, b dense, from the factors of A."""
    n, left = b.re.shape[0], b
    found: list[Number] = []
    for k in reversed(range(n)):
        found.append(left[k, 0])
        left = left[:k, 0] - factors[:k, k] @ found[-1]
    left = joined(reversed(found), ca.vertcat)
    found = []
    for k in range(n):
        found.append(left[0, 0] @ factors[k, k])
        left = left[1:, 0] - factors[k + 1 :, k] @ found[-1]
    return joined(found, ca.vertcat)


def inverse(matrix: Number) -> Number:
    """The inverse of a matrix of up to three rows, by cofactors.

    More operations than factors, but short of waiting: one reciprocal, and a solution is one product.
    """
    n = matrix.re.shape[0]
    if n == 1:
        return matrix.reciprocal()

    def minor(i: int, j: int) -> Number:
        rows, columns = ([(one + k) % n for k in range(1, n)] for one in (i, j))
        if n == 2:
            return matrix[rows[0], columns[0]] if i == j else -matrix[rows[0], columns[0]]
        first, second = (matrix[rows[0], columns[k]] @ matrix[rows[1], columns[1 - k]] for k in (0, 1))
        return first - second

    cofactors = [[minor(i, j) for j in range(n)] for i in range(n)]
    terms = [matrix[0, j] @ cofactors[0][j] for j in range(n)]
    total = terms[0]
    for term in terms[1:]:
        total = total - (-term)
    scale = total.reciprocal()
    return joined((joined((cofactors[i][j] @ scale for i in range(n)), ca.horzcat) for j in range(n)), ca.vertcat)


def pattern(matrix: ca.SX) -> Cells:
    """Where a matrix is not zero."""
    rows, columns = ca.sparsify(matrix).sparsity().get_triplet()
    return set(zip(rows, columns, strict=True))


def filled(cells: Cells, n: int) -> Cells:
    """Where the factors of a matrix are not zero."""
    found = set(cells)
    for k in reversed(range(n)):
        row = [j for j in range(k) if (k, j) in found]
        found.update((i, j) for i in range(k) if (i, k) in found for j in row)
    return found


# Small linear systems in SX: straight-line factorisations without pivoting.
#
# M_hat is symmetric positive definite, and M_hat - h/2 dQ_hat/dq_i_dot is a small perturbation of it (or has a
# positive definite symmetric part, with dampers), so elimination without pivoting is safe. The last unknown goes first:
# elastic coordinates come last, and their constant block of an arrow-shaped matrix leaves no fill-in that way.


def solve_symmetric(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for symmetric positive definite A (upper triangle used), by L D L^T."""
    return _solved(A, b, symmetric=True)


def solve_general(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for a general matrix that needs no pivoting."""
    return _solved(A, b, symmetric=False)


def _solved(A: ca.SX, b: ca.SX, symmetric: bool) -> ca.SX:
    if not b.numel():
        return ca.SX(0, 1)
    return solve(factor(Number(ca.sparsify(A)), symmetric), Number(ca.densify(b))).re
