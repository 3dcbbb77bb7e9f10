"""Newton's method for a balance of forces, kept from running to equilibria that are not stable.

r(x) = 0 with the exact slope H = dr/dx. Where the symmetric part of H (in the metric of the mass matrix) has positive
eigenvalues, x is on a hill of the potential: the step goes down it, with the eigenvalues' absolute values, so that it
ends in a valley unless it starts on a summit. Near the solution the step is Newton's own. Directions without stiffness
are left alone.

Y. N. Dauphin, R. Pascanu, C. Gulcehre, K. Cho, S. Ganguli, Y. Bengio, Identifying and attacking the saddle point
problem in high-dimensional non-convex optimization, NeurIPS 27 (2014) 2933-2941: the saddle-free Newton method.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

MAX_BALANCE_ITERATIONS = 200
LARGEST_STEP = 0.5  # rad or m
NEWTON_TOLERANCE = 1e-12  # of the largest correction, times the largest unknown
STAGNANT_CORRECTION = 1e-9  # a correction that small, but no longer shrinking, is rounding
LEAST_SCALE = 1e-6  # rad or m
UNBALANCED = 1e-9  # force in directions without stiffness, relative to the largest one met
NO_SINGULAR_VALUE = 1e-12  # relative singular value below which a direction has none
HIDDEN = 1e-9  # relative singular value of H itself above which masses of very different size only hide a stiffness
OVERSHOT = 0.9  # force along the step, reversed, relative to that at its start
STEP_HALVINGS = 25

Balance = tuple[np.ndarray, np.ndarray, np.ndarray]  # r (k), H (k x k), M (k x k)
Evaluate = Callable[[np.ndarray], Balance | None]
Advance = Callable[[np.ndarray, np.ndarray], np.ndarray | None]


@dataclass(frozen=True)
class Found:
    """x (n); converged; residual: the r that is left (k); iterations."""

    x: np.ndarray
    converged: bool
    residual: np.ndarray
    iterations: int


def added(x: np.ndarray, step: np.ndarray) -> np.ndarray:
    """x + step: what advancing means where all unknowns are free."""
    return np.asarray(x + step)


def balanced(balance: Evaluate, x: np.ndarray, advance: Advance = added, states: int = 0) -> Found:
    """Solve r(x) = 0 from x (n,).

    states: how many of the last directions are states of controllers. With them there is no potential to go down, and
    steps are Newton's own; no step is too long for a state.

    balance(x) gives (r, H, mass matrix) in k free directions, or None where it cannot be evaluated; advance(x, d) is
    the point that a step d (k,) in them leads to, or None.
    """
    at = balance(x)
    if at is None or not _is_definite(at[2]):
        return Found(x, False, np.zeros(0), 0)
    largest, before = 0.0, np.inf
    for iteration in range(MAX_BALANCE_ITERATIONS):
        r, H, M = at
        if not len(r):
            return Found(x, True, r, iteration)
        L = _metric(H, M)
        g = np.linalg.solve(L, r)
        A = np.linalg.solve(L, np.linalg.solve(L, H.T).T)
        newton, left = _newton(A, g)
        largest = max(largest, float(np.linalg.norm(g)))
        step = np.linalg.solve(L.T, newton)
        size, scale = float(np.abs(step).max()), max(LEAST_SCALE, float(np.abs(x).max()))
        rounding = 1e-14 * float(np.linalg.norm(A, 2)) * max(1.0, float(np.linalg.norm(L)) * scale)
        near = size <= STAGNANT_CORRECTION * scale and left <= UNBALANCED * largest + rounding
        if near and (size <= NEWTON_TOLERANCE * scale or size >= 0.5 * before):
            polished = advance(x, step) if size <= NEWTON_TOLERANCE * scale else None
            return Found(x if polished is None else polished, True, r, iteration)
        before = size
        chosen = newton if near or states else _downhill(A, g)
        moved = _searched(balance, advance, x, np.linalg.solve(L.T, chosen), r, states)
        if moved is None:
            break
        x, at = moved
    return Found(x, False, at[0], iteration)


def _is_definite(M: np.ndarray) -> bool:
    """Is a mass matrix positive definite? Beyond what modes can describe it may not be."""
    try:
        np.linalg.cholesky(M)
    except np.linalg.LinAlgError:
        return False
    return True


def _metric(H: np.ndarray, M: np.ndarray) -> np.ndarray:
    """L with L L^T the metric: M; the unit matrix where M makes directions look slack that are not."""
    L = np.linalg.cholesky(M)
    s = np.linalg.svd(np.linalg.solve(L, np.linalg.solve(L, H.T).T), compute_uv=False)
    if s[-1] > NO_SINGULAR_VALUE * s[0] or not np.linalg.cond(H) * HIDDEN <= 1:
        return np.asarray(L)
    return np.eye(len(H))


def _newton(A: np.ndarray, g: np.ndarray) -> tuple[np.ndarray, float]:
    """(d of least norm with A d = -g, norm of the part of g that no d balances)."""
    U, s, V = np.linalg.svd(A)
    kept = s > NO_SINGULAR_VALUE * max(float(s[0]), 1e-300)
    d = -V[kept].T @ ((U[:, kept].T @ g) / s[kept])
    return d, float(np.linalg.norm(U[:, ~kept].T @ g))


def _downhill(A: np.ndarray, g: np.ndarray) -> np.ndarray:
    """Newton's step in a valley, else the step with the curvatures' absolute values, whatever is flat going on."""
    values, vectors = np.linalg.eigh(0.5 * (A + A.T))
    size = np.abs(values)
    floor = NO_SINGULAR_VALUE * float(size.max())
    parts = vectors.T @ g
    flat = (size <= floor) & (np.abs(parts) > UNBALANCED * np.linalg.norm(g))
    if values.max() <= floor and not flat.any():
        return _newton(A, g)[0]
    steps = np.where(size > floor, parts / np.where(size > floor, size, 1.0), 0.0)
    longest = max(1.0, float(np.abs(steps).max(initial=0.0)))
    return np.asarray(vectors @ np.where(flat, np.sign(parts) * longest, steps))


def _searched(
    balance: Evaluate, advance: Advance, x: np.ndarray, step: np.ndarray, r: np.ndarray, states: int
) -> tuple[np.ndarray, Balance] | None:
    """The step, at most LARGEST_STEP, halved while the force along it reverses by more than OVERSHOT of its start."""
    long = float(np.abs(step[: len(step) - states]).max(initial=0.0))
    step = step * min(1.0, LARGEST_STEP / max(long, 1e-300))
    for _ in range(STEP_HALVINGS):
        there = advance(x, step)
        found = None if there is None else balance(there)
        if there is not None and found is not None and _is_definite(found[2]):
            push = float(r @ step)
            if push <= 0 or float(found[0] @ step) >= -OVERSHOT * push:
                return there, found
        step = 0.5 * step
    return None
