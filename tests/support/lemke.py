"""Linear complementarity by Lemke's method, written after the textbook: Cottle, Pang, Stone, The Linear
Complementarity Problem, 1992, chapter 4. Forces between bounds are such a problem in twice as many unknowns.
"""

from __future__ import annotations

import numpy as np

ZERO = 1e-10


def lemke(M: np.ndarray, q: np.ndarray) -> np.ndarray:
    """z (n,) with z >= 0, w = q + M z >= 0, z w = 0; ties of the ratio test by the lexicographic rule."""
    n = len(q)
    if (q >= 0).all():
        return np.zeros(n)
    # w - M z - z_0 = q; columns: w (n), z (n), z_0, right-hand side
    T = np.hstack([np.eye(n), -M, -np.ones((n, 1)), q[:, None]])
    basis, row, entering = list(range(n)), int(np.argmin(q)), 2 * n
    for _ in range(1000):
        T[row] /= T[row, entering]
        for k in range(n):
            if k != row:
                T[k] -= T[k, entering] * T[row]
        left, basis[row] = basis[row], entering
        if left == 2 * n:
            z = np.zeros(n)
            for k, one in enumerate(basis):
                if n <= one < 2 * n:
                    z[one - n] = T[k, -1]
            return z
        entering = left + n if left < n else left - n
        able = [k for k in range(n) if T[k, entering] > ZERO]
        if not able:
            raise ArithmeticError("a ray: the problem has no solution that the method finds")
        order = [[T[k, -1] / T[k, entering], *(T[k, :n] / T[k, entering])] for k in able]
        row = able[min(range(len(able)), key=lambda k: order[k])]
        for k, place in enumerate(able):  # z_0 leaves where it may
            if basis[place] == 2 * n and order[k][0] <= min(one[0] for one in order) + ZERO:
                row = place
    raise ArithmeticError("too many pivots")


def between_bounds(A: np.ndarray, b: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """f (n,) with v = b + A f >= 0 at a lower bound, <= 0 at an upper one, 0 between; one bound of each is finite."""
    flip = np.where(np.isfinite(lower), 1.0, -1.0)
    least = np.where(np.isfinite(lower), lower, -upper)
    wide = np.where(np.isfinite(lower), upper, -lower) - least
    own, side = flip[:, None] * A * flip, flip * b
    both = np.flatnonzero(np.isfinite(wide))
    n, m = len(b), len(both)
    M, q = np.zeros((n + m, n + m)), np.concatenate([side + own @ least, wide[both]])
    M[:n, :n] = own
    M[both, n + np.arange(m)], M[n + np.arange(m), both] = 1.0, -1.0
    return flip * (least + lemke(M, q)[:n])
