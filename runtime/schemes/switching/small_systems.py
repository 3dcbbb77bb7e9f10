"""Sums and eliminations of a few unknowns in an order that is written down: exported C has it, and so the same bits."""

from __future__ import annotations

import numpy as np


def times(A: np.ndarray, x: np.ndarray) -> np.ndarray:
    """(n,) or (n, k) of A (n, m) and x (m,) or (m, k), summed from the first column on."""
    found = np.zeros((len(A), *x.shape[1:]))
    for k in range(A.shape[1]):
        found = found + np.multiply.outer(A[:, k], x[k])
    return found


def solved(A: np.ndarray, b: np.ndarray) -> np.ndarray:
    """x (n,) of A (n, n) x = b, by elimination with the largest pivot of each column."""
    A, x, n = A.copy(), b.copy(), len(b)
    for k in range(n):
        p = k + int(np.argmax(np.abs(A[k:, k])))
        A[[k, p]], x[[k, p]] = A[[p, k]], x[[p, k]]
        factors = A[k + 1 :, k] / A[k, k]
        A[k + 1 :, k:] -= factors[:, None] * A[k, k:]
        x[k + 1 :] -= factors * x[k]
    for k in reversed(range(n)):
        for i in range(k + 1, n):
            x[k] -= A[k, i] * x[i]
        x[k] /= A[k, k]
    return x
