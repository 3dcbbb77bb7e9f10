"""Small dense linear systems in SX: straight-line factorisations without pivoting.

M_hat is symmetric positive definite, and M_hat - h/2 dQ_hat/dq_i_dot is a small perturbation of it (or has a
positive definite symmetric part, with dampers), so elimination without pivoting is safe.
"""

from __future__ import annotations

import casadi as ca


def solve_symmetric(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for symmetric positive definite A (upper triangle used), by L D L^T."""
    n = A.shape[0]
    rows = [[A[min(i, j), max(i, j)] + 0 for j in range(n)] for i in range(n)]
    x = [b[i] + 0 for i in range(n)]
    inverse: list[ca.SX] = []
    for k in range(n):
        inverse.append(1 / rows[k][k])
        for i in range(k + 1, n):
            if rows[k][i].is_zero():
                continue
            factor = rows[k][i] * inverse[k]
            for j in range(i, n):
                if not rows[k][j].is_zero():
                    rows[i][j] = rows[i][j] - factor * rows[k][j]
            x[i] = x[i] - factor * x[k]
    for k in reversed(range(n)):
        total = x[k]
        for j in range(k + 1, n):
            if not rows[k][j].is_zero():
                total = total - rows[k][j] * x[j]
        x[k] = total * inverse[k]
    return ca.vertcat(*x)


def solve_general(A: ca.SX, b: ca.SX) -> ca.SX:
    """x of A x = b for a general matrix that needs no pivoting."""
    n = A.shape[0]
    rows = [[A[i, j] + 0 for j in range(n)] for i in range(n)]
    x = [b[i] + 0 for i in range(n)]
    inverse: list[ca.SX] = []
    for k in range(n):
        inverse.append(1 / rows[k][k])
        for i in range(k + 1, n):
            if rows[i][k].is_zero():
                continue
            factor = rows[i][k] * inverse[k]
            for j in range(k + 1, n):
                if not rows[k][j].is_zero():
                    rows[i][j] = rows[i][j] - factor * rows[k][j]
            x[i] = x[i] - factor * x[k]
    for k in reversed(range(n)):
        total = x[k]
        for j in range(k + 1, n):
            if not rows[k][j].is_zero():
                total = total - rows[k][j] * x[j]
        x[k] = total * inverse[k]
    return ca.vertcat(*x)
