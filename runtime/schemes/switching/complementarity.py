"""Forces between bounds on directions that are at rest: a box-constrained linear complementarity problem
(LCP).

With v' = b + A f, where A = G M_hat^-1 G^T is the Delassus matrix,

    f at its lower bound: v' >= 0,    f between its bounds: v' = 0,    f at its upper bound: v' <= 0.

It is solved by pivots on the active set of those that hold: all hold; the one whose force is beyond its bound by most,
measured by what that would accelerate, lets go; one that would then accelerate against its force holds again. Where
rows say the same, A is singular: then those that hold do so with the least sum of (f / bound)^2.

These are principal pivots of one index, where the violation is largest; not Lemke's complementary pivots, which trace a
path from an artificial variable. Where they do not end there is no answer, and the run says so.
"""

from __future__ import annotations

import numpy as np

HOLDS = 0
MOST_PIVOTS = 20  # solutions beyond two for each direction
DEPENDENT_ROW = 1e-11  # of the largest of the diagonal: what is left of that of a row that follows from others
FORCE_ROUNDING = 1e-12  # of the largest bound, and of the accelerations that forces make


def complementary(
    A: np.ndarray,
    b: np.ndarray,
    lower: np.ndarray,
    upper: np.ndarray,
    released: np.ndarray | None = None,
    shares: np.ndarray | None = None,
) -> np.ndarray | None:
    """(n,) -1 at the lower bound, 0 between, 1 at the upper one, of v' = b + A f; None where no set was found.

    released (n,): those that are at a bound, where rounding leaves it open; shares (n,): see `balancing`.
    """
    n, at = len(b), np.zeros(len(b), dtype=int)
    if not n:
        return at
    named = np.zeros(n, dtype=bool) if released is None else released.astype(bool)
    largest = max(float(np.abs(one[np.isfinite(one)]).max(initial=0.0)) for one in (lower, upper))
    # what presses on a stop by rounding only does not hold it closed
    alone = FORCE_ROUNDING * np.abs(b).max() / np.maximum(np.diag(A), 1e-300)
    dust = FORCE_ROUNDING * largest + np.where(np.isfinite(lower) & np.isfinite(upper), 0.0, alone + 1e-300)
    still = FORCE_ROUNDING * (np.abs(b).max() + np.abs(A).max() * largest)
    at[named] = _nearest(balancing(A, b, lower, upper, at, shares), lower, upper)[named]
    without = upper <= lower  # friction whose coefficient is zero holds nothing, and goes where it is pulled
    at[without] = 1
    slack = np.where(named, 1e6 * still, still)
    for _ in range(2 * n + MOST_PIVOTS):
        f = balancing(A, b, lower, upper, at, shares)
        beyond = np.where(at == HOLDS, np.maximum(f - upper, lower - f) + dust, 0.0) * np.diag(A)
        worst = int(np.argmax(beyond))
        if beyond[worst] > 0:
            at[worst] = _nearest(f, lower, upper)[worst]
            continue
        accelerations = b + times(A, f)
        wrong = np.where((at != HOLDS) & ~without, at * accelerations, -np.inf) - slack
        worst = int(np.argmax(wrong))
        if wrong[worst] <= 0:
            return np.where(without, np.where(accelerations > 0, -1, 1), at)
        at[worst] = HOLDS
    return None


def _nearest(f: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """(n,) the bound that each force is at, or beyond: 1 the upper one, -1 the lower one."""
    return np.where(upper - f <= f - lower, 1, -1)


def balancing(
    A: np.ndarray,
    b: np.ndarray,
    lower: np.ndarray,
    upper: np.ndarray,
    at: np.ndarray,
    shares: np.ndarray | None = None,
) -> np.ndarray:
    """(n,) forces: at the bounds, and what keeps the others from accelerating.

    shares (n,): what those that hold one motion share it by, instead of their bounds: of what has none, zero.
    """
    f, held = np.where(at > 0, upper, np.where(at < 0, lower, 0.0)), at == HOLDS
    if held.any():
        finite = np.where(np.isfinite(upper), upper, np.where(np.isfinite(lower), -lower, 0.0))
        bound = (finite if shares is None else shares)[held]
        H = np.where(bound > 0, bound, bound.max(initial=0.0) or 1.0)
        own = H[:, None] * A[np.ix_(held, held)] * H
        side = -H * (b + times(A, np.where(held, 0.0, f)))[held]
        f[held] = H * _least(own, side)
    return f


def _least(A: np.ndarray, side: np.ndarray) -> np.ndarray:
    """x (n,) of least norm with A x = side, A (n, n) symmetric: a combination of columns of A that are independent."""
    left, largest, chosen = A.copy(), float(np.diag(A).max()), list[int]()
    while len(chosen) < len(A):
        k = int(np.argmax(np.diag(left)))
        if left[k, k] <= DEPENDENT_ROW * largest:
            own = A[:, chosen]
            return times(own, solved(times(own.T, own), side[chosen])) if chosen else np.zeros(len(A))
        left = left - np.outer(left[:, k], left[k]) / left[k, k]
        chosen.append(k)
        left[chosen, chosen] = -1.0
    return solved(A, side)


# Sums and eliminations of a few unknowns in an order that is written down: exported C has it, and so the same bits.


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
