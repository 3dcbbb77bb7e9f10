"""Which elements are held and which move, where that is open: at the start of a run, and where forces or rates jump.

An element is a direction v = G q_i' with a force f on it between two bounds: of friction -F and F, of a stop that is
touched 0 and infinity, of both the sums. First what comes upon a stop is thrown back, see stops.py. Then what is at
rest is held or moves, see complementarity.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.tape import shared
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.schemes.switching.complementarity import balancing, complementary
from runtime.schemes.switching.small_systems import times
from runtime.schemes.switching.stops import AT_REST, Hit, Stops

PIVOT = 1e-9
# of the largest rate: what stops one that rests is less; an element whose rate is zero since its G is passes on
PASSES = 1e-6


@dataclass(frozen=True)
class Settled:
    """modes (n_m,): of friction 0 stuck, else the sign of the rate; of stops 0 closed, 1 open, -1 left at rest.

    push (n_i,): what is added to q_i'; hits: what stops did; q_d_dot (n_d,): rates afterwards.
    """

    modes: np.ndarray
    push: np.ndarray
    hits: list[Hit]
    q_d_dot: np.ndarray


def settled(
    model: Model,
    at: Mapping[str, np.ndarray],
    c: np.ndarray,
    let_go: np.ndarray,
    come: np.ndarray,
    hit: np.ndarray | None = None,
) -> Settled | None:
    """The modes at a state, and what makes at rest what has come to rest; None where no modes are consistent.

    at: q_i, q_d, q_i_dot, q_d_dot, t; c (c_size,): constants, with the modes until now in it. let_go (n_m,): those that
    are held no longer; come (n_m,): rates below which one has come to rest; hit (n_m,): stops that are just reached.
    A stop whose bounces come too close takes them all at once: it is hit again without restitution.
    """
    stops = Stops.of(model, c, hit)
    soon = dict[int, float]()
    while True:
        found = _once(model, at, c, let_go, come, stops, soon)
        if found is None:
            return None
        new = stops.too_close(found[0].hits, *found[1:])
        if not new:
            return found[0]
        soon |= new


def _once(
    model: Model,
    at: Mapping[str, np.ndarray],
    c: np.ndarray,
    let_go: np.ndarray,
    come: np.ndarray,
    stops: Stops,
    soon: Mapping[int, float],
) -> tuple[Settled, np.ndarray, np.ndarray] | None:
    """Settled, and by row of G rates v and accelerations v'; soon: stops without restitution, and when they close."""
    start, c, own = at["q_i_dot"], c.copy(), weighed(model, at, c)
    slow = AT_REST * (1.0 + np.abs(start).max(initial=0.0))
    struck = stops.struck(own, slow, soon)
    if struck is None:
        return None
    push, hits = struck
    rate = own["v_rel"] + times(own["G"], push)
    bounds = _Bounds(stops, rate, np.maximum(come, slow), stops.touched(own, rate, slow))
    rest, rubs, modes = bounds.rest, stops.side == 0, np.ones(len(stops.side))
    modes[rubs] = np.where(rest, 0.0, np.sign(rate))[stops.row[rubs]]
    c[len(c) - model.signals.size + model.element_modes] = modes
    at = _moved(model, at, start + push, c)
    for _ in range(2 if rest.any() else 1):  # the second time what the first one rounded
        own, v = weighed(model, at, c), at["q_i_dot"]
        most = PASSES * np.abs(own["G"]).max(axis=1) * (1.0 + np.abs(v).max(initial=0.0))
        stay = rest & (np.abs(own["v_rel"]) <= most)
        at = _moved(model, at, v + _at_rest(own["G"][stay], own["v_rel"][stay]), c)
    own = weighed(model, at, c)  # with the laws of those that move
    lower, upper = bounds.of(own["holds"])
    A, b = own["A"][np.ix_(rest, rest)], own["b"][rest]
    sides = complementary(A, b, lower[rest], upper[rest], bounds.by_row(let_go)[rest])
    if sides is None:
        return None
    force, moving = np.zeros(len(rest)), np.zeros(len(rest))
    force[rest], moving[rest] = balancing(A, b, lower[rest], upper[rest], sides), -sides
    held = rest & (moving == 0)
    modes[rubs] = np.where(rest, moving, np.sign(rate))[bounds.row[rubs]]
    modes[bounds.touched] = np.where(held, 0.0, -1.0)[bounds.row[bounds.touched]]
    settled_ = Settled(modes, at["q_i_dot"] - start, hits, at["q_d_dot"])
    return settled_, own["v_rel"], own["b"] + times(own["A"], force)


class _Bounds:
    """Of the forces on rows that are at rest: touched (n_m,): stops on which their rows lie.

    rest (n_e,): what friction or a stop may hold.
    """

    def __init__(self, stops: Stops, rate: np.ndarray, come: np.ndarray, touched: np.ndarray) -> None:
        self._side, self.row, self.touched = stops.side, stops.row, touched
        slow = np.abs(rate)[self.row] <= come
        self.rest = self.by_row(((self._side == 0) & slow) | touched)

    def by_row(self, ones: np.ndarray) -> np.ndarray:
        """(n_e,) any of the modes (n_m,) of each row."""
        found = np.zeros(self.row.max() + 1, dtype=bool)
        found[self.row[ones.astype(bool)]] = True
        return found

    def of(self, holds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(n_e,) lower and upper: of friction, and of stops."""
        lower, upper = -holds, holds.copy()
        upper[self.row[self.touched & (self._side > 0)]] = np.inf
        lower[self.row[self.touched & (self._side < 0)]] = -np.inf
        return lower, upper


def _moved(model: Model, at: Mapping[str, np.ndarray], v: np.ndarray, c: np.ndarray) -> Mapping[str, np.ndarray]:
    """With other rates of q_i (n_i,)."""
    at = {**at, "q_i_dot": v}
    q_d_dot = np.asarray(model.evaluate("velocities", **at, c=c)["q_d_dot"]).ravel() if model.q_d else at["q_d_dot"]
    return {**at, "q_d_dot": q_d_dot}


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


def weighed(model: Model, at: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """What `weights` gives at a state with constants c; vectors are flat."""
    found = weights(model)(**at, c=c)
    shaped = {name: np.asarray(value, dtype=float) for name, value in found.items()}
    return {name: value if name in ("G", "by", "A") else value.ravel() for name, value in shaped.items()}


def weights(model: Model) -> ca.Function:
    """(q_i, q_d, q_i_dot, q_d_dot, t, c) -> what `elements` says of v = G q_i', with v' = b + A f of forces f (n_e,) on
    it: A = G by, b = G M_hat^-1 Q_hat + G_bias, by = M_hat^-1 G^T (n_i, n_e). Exported C has this function, too.
    """

    def build() -> ca.Function:
        n_i, n_d = len(model.q_i), len(model.q_d)
        sizes = {"q_i": n_i, "q_d": n_d, "q_i_dot": n_i, "q_d_dot": n_d, "t": 1, "c": model.c_size}
        at = {name: ca.SX.sym(name, size) for name, size in sizes.items()}
        own = model.evaluate("elements", **at)
        G = own["G"]
        factors = factor(Number(ca.sparsify(own["M_hat"])), symmetric=True)
        *columns, free = (solve(factors, Number(one)).re for one in (*ca.horzsplit(G.T), own["Q_hat"]))
        by = ca.horzcat(*columns)
        found: dict[str, ca.SX] = {}
        found |= {name: own[name] for name in ("G", "v_rel", "holds", "gap", "restitution") if name in own}
        found |= {"by": by, "A": ca.triu2symm(ca.triu(G @ by)), "b": G @ free + own["G_bias"]}
        names = list(found)
        return ca.Function("weights", list(at.values()), shared([ca.densify(one) for one in found.values()]),
                           list(at), names)  # fmt: skip

    return model.derived("weights", build)
