"""Small linear systems in symbols: Cramer's rule up to 4x4, QR beyond; the determinant comes with the solution.

Expressions as polynomials in a few variables: coefficients that hold still while the variables move.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub

CRAMER_LIMIT = 4  # larger systems are solved by QR, which needs no pivoting either
SIGNED_LIMIT = 6  # up to here the determinant is expanded by minors (192 products), which gives its sign


def solve_small(U: list[list[ca.SX]], sides: list[list[ca.SX]]) -> tuple[list[list[ca.SX]], ca.SX]:
    """(solutions of U x = side for several sides, det U). Above 6x6 the determinant comes without its sign."""
    n = len(U)
    if n > CRAMER_LIMIT:
        return _solve_by_qr(U, sides)
    if n == 1:
        inverse = div(ONE, U[0][0])
        return [[mul(side[0], inverse)] for side in sides], U[0][0]
    adjugate = _adjugate(U)
    determinant = dot(U[0], [adjugate[j][0] for j in range(n)])
    inverse = div(ONE, determinant)
    return [[mul(dot(adjugate[i], side), inverse) for i in range(n)] for side in sides], determinant


def _solve_by_qr(U: list[list[ca.SX]], sides: list[list[ca.SX]]) -> tuple[list[list[ca.SX]], ca.SX]:
    """By orthogonalisation: a fixed order of pivots could become bad later, this has none."""
    n = len(U)
    Q, R = ca.qr(ca.vertcat(*(ca.horzcat(*row) for row in U)))
    solution = ca.solve(R, Q.T @ ca.horzcat(*(ca.vertcat(*side) for side in sides)))
    determinant = expanded_determinant(U) if n <= SIGNED_LIMIT else product_of(R[k, k] + 0 for k in range(n))
    return [[solution[row, k] + 0 for row in range(n)] for k in range(len(sides))], determinant


def product_of(factors: Iterable[ca.SX]) -> ca.SX:
    """Product of the factors in order."""
    result = ONE
    for factor in factors:
        result = mul(result, factor)
    return result


def expanded_determinant(U: list[list[ca.SX]]) -> ca.SX:
    """det U from the minors of its last rows, each over a set of columns and computed once."""
    n = len(U)
    minors: dict[tuple[int, ...], ca.SX] = {(): ONE}
    for size in range(1, n + 1):
        row = U[n - size]
        minors = {columns: _expanded(row, columns, minors) for columns in combinations(range(n), size)}
    return minors[tuple(range(n))]


def _expanded(row: list[ca.SX], columns: tuple[int, ...], minors: dict[tuple[int, ...], ca.SX]) -> ca.SX:
    result = ZERO
    for place, column in enumerate(columns):
        term = mul(row[column], minors[columns[:place] + columns[place + 1 :]])
        result = sub(result, term) if place % 2 else add(result, term)
    return result


def _adjugate(U: list[list[ca.SX]]) -> list[list[ca.SX]]:
    n = len(U)
    if n == 2:
        return [[U[1][1], -U[0][1]], [-U[1][0], U[0][0]]]
    if n == 4:
        return _adjugate_of_four(U)

    def cofactor(i: int, j: int) -> ca.SX:
        a, b = [k for k in range(3) if k != i], [k for k in range(3) if k != j]
        minor = U[a[0]][b[0]] * U[a[1]][b[1]] - U[a[0]][b[1]] * U[a[1]][b[0]]
        return minor if (i + j) % 2 == 0 else -minor

    return [[cofactor(j, i) for j in range(3)] for i in range(3)]


def _adjugate_of_four(U: list[list[ca.SX]]) -> list[list[ca.SX]]:
    """From the minors of the first two rows and of the last two, each of which four cofactors share."""
    minors = [
        {(j, k): sub(mul(U[r][j], U[r + 1][k]), mul(U[r][k], U[r + 1][j])) for j, k in combinations(range(4), 2)}
        for r in (0, 2)
    ]

    def cofactor(i: int, j: int) -> ca.SX:
        left, pair = (U[1 - i], minors[1]) if i < 2 else (U[5 - i], minors[0])
        a, b, c = (k for k in range(4) if k != j)
        value = add(sub(mul(left[a], pair[b, c]), mul(left[b], pair[a, c])), mul(left[c], pair[a, b]))
        return value if (i + j) % 2 == 0 else neg(value)

    return [[cofactor(j, i) for j in range(4)] for i in range(4)]
