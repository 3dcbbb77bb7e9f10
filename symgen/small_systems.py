"""Small linear systems in symbols: Cramer's rule up to 3x3, QR beyond; the determinant comes with the solution."""

from __future__ import annotations

import casadi as ca

from symgen.scalar import ONE, div, dot, mul

CRAMER_LIMIT = 3  # larger systems are solved by QR, which needs no pivoting either


def solve_small(U: list[list[ca.SX]], sides: list[list[ca.SX]]) -> tuple[list[list[ca.SX]], ca.SX]:
    """(solutions of U x = side for several sides, det U). Above 3x3 the determinant comes without its sign."""
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
    determinant = R[0, 0] + 0
    for k in range(1, n):
        determinant = mul(determinant, R[k, k] + 0)
    return [[solution[row, k] + 0 for row in range(n)] for k in range(len(sides))], determinant


def _adjugate(U: list[list[ca.SX]]) -> list[list[ca.SX]]:
    n = len(U)
    if n == 2:
        return [[U[1][1], -U[0][1]], [-U[1][0], U[0][0]]]

    def cofactor(i: int, j: int) -> ca.SX:
        a, b = [k for k in range(3) if k != i], [k for k in range(3) if k != j]
        minor = U[a[0]][b[0]] * U[a[1]][b[1]] - U[a[0]][b[1]] * U[a[1]][b[0]]
        return minor if (i + j) % 2 == 0 else -minor

    return [[cofactor(j, i) for j in range(3)] for i in range(3)]
