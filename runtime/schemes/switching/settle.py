"""Which elements stick and which move, where that is open: at the start of a run, and where forces or rates jump.

An element is a direction v = G q_i' with a force f on it between two bounds: of friction -F and F, of a stop 0 and
infinity. Among those at rest, with v' = b + A f and A = G M_hat^-1 G^T,

    f at its lower bound: v' >= 0,    f between its bounds: v' = 0,    f at its upper bound: v' <= 0.

This box-constrained complementarity problem is solved by pivots: all hold; the one whose force is beyond its bound by
most, measured by what that would accelerate, lets go; one that would then accelerate against its force holds again.
Where rows say the same, A is singular: then those that hold do so with the least sum of (f / bound)^2.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.model import Model

HOLDS = 0
MOST = 20  # solutions beyond two for each element
SINGULAR = 1e-11  # of the largest of the diagonal: what is left of that of a row that follows from others
ROUNDING = 1e-12  # of the largest bound, and of the accelerations that forces make
AT_REST = 1e-9  # m/s or rad/s, and of the largest rate: what is slower has come to rest
PIVOT = 1e-9
# of the largest rate: what stops one that rests is less; an element whose rate is zero since its G is passes on
PASSES = 1e-6


@dataclass(frozen=True)
class Settled:
    """modes (n_e,): 0 stuck, else the sign of the rate; push (n_i,): what is added to q_i' so that they rest."""

    modes: np.ndarray
    push: np.ndarray


def complementary(
    A: np.ndarray, b: np.ndarray, lower: np.ndarray, upper: np.ndarray, let_go: np.ndarray | None = None
) -> np.ndarray | None:
    """(n,) -1 at the lower bound, 0 between, 1 at the upper one, of v' = b + A f; None where no set was found.

    let_go (n,): those that are at a bound, where rounding leaves it open.
    """
    n, at = len(b), np.zeros(len(b), dtype=int)
    if not n:
        return at
    named = np.zeros(n, dtype=bool) if let_go is None else let_go.astype(bool)
    largest = max(float(np.abs(one[np.isfinite(one)]).max(initial=0.0)) for one in (lower, upper))
    dust, still = ROUNDING * largest, ROUNDING * (np.abs(b).max() + np.abs(A).max() * largest)
    at[named] = _nearest(balancing(A, b, lower, upper, at), lower, upper)[named]
    slack = np.where(named, 1e6 * still, still)
    for _ in range(2 * n + MOST):
        f = balancing(A, b, lower, upper, at)
        beyond = np.where(at == HOLDS, np.maximum(f - upper, lower - f) + dust, -np.inf)
        worst = int(np.argmax(beyond * np.diag(A)))
        if beyond[worst] > 0:
            at[worst] = _nearest(f, lower, upper)[worst]
            continue
        wrong = np.where(at != HOLDS, at * (b + A @ f), -np.inf) - slack
        worst = int(np.argmax(wrong))
        if wrong[worst] <= 0:
            return at
        at[worst] = HOLDS
    return None


def _nearest(f: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """(n,) the bound that each force is at, or beyond: 1 the upper one, -1 the lower one."""
    return np.where(upper - f <= f - lower, 1, -1)


def balancing(A: np.ndarray, b: np.ndarray, lower: np.ndarray, upper: np.ndarray, at: np.ndarray) -> np.ndarray:
    """(n,) forces: at the bounds, and what keeps the others from accelerating."""
    f, held = np.where(at > 0, upper, np.where(at < 0, lower, 0.0)), at == HOLDS
    if held.any():
        bound = np.where(np.isfinite(upper), upper, np.where(np.isfinite(lower), -lower, 0.0))[held]
        H = np.where(bound > 0, bound, bound.max(initial=0.0) or 1.0)
        own = H[:, None] * A[np.ix_(held, held)] * H
        side = -H * (b + A @ np.where(held, 0.0, f))[held]
        f[held] = H * _least(own, side)
    return f


def _least(A: np.ndarray, side: np.ndarray) -> np.ndarray:
    """x (n,) of least norm with A x = side, A (n, n) symmetric: a combination of columns of A that are independent."""
    left, largest, chosen = A.copy(), float(np.diag(A).max()), list[int]()
    while len(chosen) < len(A):
        k = int(np.argmax(np.diag(left)))
        if left[k, k] <= SINGULAR * largest:
            own = A[:, chosen]
            return np.asarray(own @ np.linalg.solve(own.T @ own, side[chosen])) if chosen else np.zeros(len(A))
        left = left - np.outer(left[:, k], left[k]) / left[k, k]
        chosen.append(k)
        left[chosen, chosen] = -1.0
    return np.asarray(np.linalg.solve(A, side))


def settled(
    model: Model, at: Mapping[str, np.ndarray], c: np.ndarray, let_go: np.ndarray, come: np.ndarray
) -> Settled | None:
    """The modes at a state, and what makes at rest what has come to rest; None where no modes are consistent.

    at: q_i, q_d, q_i_dot, q_d_dot, t; c (c_size,): constants, with the modes until now in it. let_go (n_e,): those that
    stick no longer; come (n_e,): rates below which one has come to rest.
    """
    start = at["q_i_dot"]
    c, own, v = c.copy(), elements(model, at, c), at["q_i_dot"]
    rate = own["v_rel"]
    rest = np.abs(rate) <= np.maximum(come, AT_REST * (1.0 + np.abs(v).max(initial=0.0)))
    found = np.where(rest, 0.0, np.sign(rate))
    c[len(c) - model.signals.size + model.element_modes] = found
    for _ in range(2 if rest.any() else 1):  # the second time what the first one rounded
        stops = rest & (
            np.abs(own["v_rel"]) <= PASSES * np.abs(own["G"]).max(axis=1) * (1.0 + np.abs(v).max(initial=0.0))
        )
        v = v + _at_rest(own["G"][stops], own["v_rel"][stops])
        q_d_dot = np.asarray(model.evaluate("velocities", **at, c=c)["q_d_dot"]).ravel() if model.q_d else at["q_d_dot"]
        at = {**at, "q_i_dot": v, "q_d_dot": q_d_dot}
        own = elements(model, at, c)  # with the laws of those that move
    G, M_hat = own["G"], own["M_hat"]
    free, by = np.linalg.solve(M_hat, own["Q_hat"]), np.linalg.solve(M_hat, G.T)
    A, b = (G @ by)[np.ix_(rest, rest)], (G @ free + own["G_bias"])[rest]
    holds = own["holds"][rest]
    sides = complementary(A, b, -holds, holds, let_go[rest])
    if sides is None:
        return None
    found[rest] = -sides
    return Settled(found, v - start)


def _at_rest(G: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """(n_i,) what takes these rates to zero; where a coordinate can do it alone, to the last bit."""
    push, left, side = np.zeros(G.shape[1]), G.copy(), rate.copy()
    pivots: list[tuple[int, int]] = []
    for k in range(len(left)):
        places = np.flatnonzero(np.abs(left[k]) > PIVOT * np.abs(G[k]).max(initial=0.0))
        if not len(places):
            continue
        column = int(places[-1])
        pivots.append((k, column))
        for other in range(len(left)):
            if other != k and left[other, column]:
                factor = left[other, column] / left[k, column]
                left[other] -= factor * left[k]
                side[other] -= factor * side[k]
    for k, column in pivots:
        push[column] = -side[k] / left[k, column]
    return push


def elements(model: Model, at: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """The function `elements` at a state with constants c; vectors are flat."""
    found = model.evaluate("elements", **at, c=c)
    shaped = {name: np.asarray(value, dtype=float) for name, value in found.items()}
    return {name: value if name in ("M_hat", "G") else value.ravel() for name, value in shaped.items()}
