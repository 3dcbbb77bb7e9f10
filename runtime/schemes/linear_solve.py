"""Small dense linear systems in SX: straight-line factorisations without pivoting.

M_hat is symmetric positive definite, and M_hat - h/2 dQ_hat/dq_i_dot is a small perturbation of it (or has a
positive definite symmetric part, with dampers), so elimination without pivoting is safe. The last unknown goes first:
elastic coordinates come last, and their constant block of an arrow-shaped matrix leaves no fill-in that way.
"""

from __future__ import annotations

import casadi as ca


def solve_symmetric(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for symmetric positive definite A (upper triangle used), by L D L^T."""
    n = A.shape[0]
    rows = [[A[min(i, j), max(i, j)] + 0 for j in range(n)] for i in range(n)]
    return _eliminate(rows, [b[i] + 0 for i in range(n)], symmetric=True)


def solve_general(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for a general matrix that needs no pivoting."""
    n = A.shape[0]
    rows = [[A[i, j] + 0 for j in range(n)] for i in range(n)]
    return _eliminate(rows, [b[i] + 0 for i in range(n)], symmetric=False)


def _eliminate(rows: list[list[ca.SX]], x: list[ca.SX], symmetric: bool) -> ca.SX:
    n = len(x)
    inverse = [ca.SX(0)] * n
    for k in reversed(range(n)):
        inverse[k] = 1 / rows[k][k]
        for i in range(k):
            below = rows[k][i] if symmetric else rows[i][k]
            if below.is_zero():
                continue
            factor = below * inverse[k]
            for j in range(i if symmetric else 0, k):
                if not rows[k][j].is_zero():
                    rows[i][j] = rows[i][j] - factor * rows[k][j]
                    if symmetric:
                        rows[j][i] = rows[i][j]
            x[i] = x[i] - factor * x[k]
    for k in range(n):
        total = x[k]
        for j in range(k):
            if not rows[k][j].is_zero():
                total = total - rows[k][j] * x[j]
        x[k] = total * inverse[k]
    return ca.vertcat(*x)
