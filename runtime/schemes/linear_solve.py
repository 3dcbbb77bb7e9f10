"""Small linear systems in SX: straight-line factorisations without pivoting.

M_hat is symmetric positive definite, and M_hat - h/2 dQ_hat/dq_i_dot is a small perturbation of it (or has a
positive definite symmetric part, with dampers), so elimination without pivoting is safe. The last unknown goes first:
elastic coordinates come last, and their constant block of an arrow-shaped matrix leaves no fill-in that way.
"""

from __future__ import annotations

import casadi as ca

from runtime.schemes.sparse_lu import Number, factor, solve


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
