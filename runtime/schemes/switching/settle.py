"""Stick and slip, contact and separation: which elements are held and which move, at the start of a run and at jumps.

This is the active set of stiction and of unilateral contact, decided where forces or rates jump.

An element is a direction v = G q_i' with a force f on it between two bounds: of friction -F and F, of a stop that is
touched 0 and infinity, of both the sums. First what comes upon a stop is thrown back, see stops.py. Then what is at
rest is held or moves, see complementarity.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.schemes.switching.complementarity import balancing, complementary, times
from runtime.schemes.switching.consistency import NoMode as NoMode
from runtime.schemes.switching.consistency import broken_law, no_limit
from runtime.schemes.switching.stops import AT_REST, Impact, Stops

PIVOT = 1e-9
MATRICES = {"M_hat", "G", "by", "A", "Q_hat_R", "holds_R", "b_R", "F_a", "F_f", "F_R"}
# of the largest rate: what stops one that rests is less; an element whose rate is zero since its G is passes on
PASSING_RATE = 1e-6
MOST_TURNS, FOUND = 100, 1e-14  # of forces that are shares of reactions, which at least halve their error in a turn


@dataclass(frozen=True)
class Settled:
    """modes (n_m,): of friction 0 stuck, else the sign of the rate; of stops 0 closed, 1 open, -1 left at rest.

    push (n_i,): what is added to q_i'; impacts: what stops did; q_d_dot (n_d,): rates afterwards.
    """

    modes: np.ndarray
    push: np.ndarray
    impacts: list[Impact]
    q_d_dot: np.ndarray


def settled(
    model: EmittedModel,
    at: Mapping[str, np.ndarray],
    c: np.ndarray,
    released: np.ndarray,
    rest_rate: np.ndarray,
    reached: np.ndarray | None = None,
) -> Settled | NoMode:
    """The modes at a state, and what makes at rest what has come to rest; NoMode where no modes are consistent.

    at: q_i, q_d, q_i_dot, q_d_dot, t; c (c_size,): constants, with the modes until now in it. released (n_m,):
    those that are held no longer; rest_rate (n_m,): rates below which one has come to rest; reached (n_m,): stops that
    are just reached. A stop whose bounces come too close takes them all at once: it is hit again without
    restitution.
    """
    stops = Stops.of(model, c, reached)
    soon = dict[int, float]()
    while True:
        found = _once(model, at, c, released, rest_rate, stops, soon)
        if found is None:
            return NoMode(*no_mode(model, at, c))
        if isinstance(found, NoMode):
            return found
        new = stops.too_close(found[0].impacts, *found[1:])
        if not new:
            return found[0]
        soon |= new


def _once(
    model: EmittedModel,
    at: Mapping[str, np.ndarray],
    c: np.ndarray,
    released: np.ndarray,
    rest_rate: np.ndarray,
    stops: Stops,
    soon: Mapping[int, float],
) -> tuple[Settled, np.ndarray, np.ndarray] | NoMode | None:
    """Settled, and by row of G rates v and accelerations v'; soon: stops without restitution, and when they close."""
    start, c, own = at["q_i_dot"], c.copy(), weighed(model, at, c)
    if (wrong := no_limit(model, own["holds"])) is not None:
        return wrong
    slow = AT_REST * (1.0 + np.abs(start).max(initial=0.0))
    struck = stops.struck(own, slow, soon)
    if struck is None:
        return None
    push, impacts = struck
    rate = own["v_rel"] + times(own["G"], push)
    bounds = _Bounds(stops, rate, np.maximum(rest_rate, slow), stops.touched(own, rate, slow))
    rest, rubs, modes = bounds.rest, stops.side == 0, np.ones(len(stops.side))
    modes[rubs] = np.where(rest, 0.0, np.sign(rate))[stops.row[rubs]]
    c[len(c) - model.signals.size + model.element_modes] = modes
    at = _moved(model, at, start + push, c)
    for _ in range(2 if rest.any() else 1):  # the second time what the first one rounded
        own, v = weighed(model, at, c), at["q_i_dot"]
        most = PASSING_RATE * np.abs(own["G"]).max(axis=1) * (1.0 + np.abs(v).max(initial=0.0))
        stay = rest & (np.abs(own["v_rel"]) <= most)
        at = _moved(model, at, v + _at_rest(own["G"][stay], own["v_rel"][stay]), c)
    own = weighed(model, at, c)  # with the laws of those that move
    balance = _balance(own, bounds, rest, bounds.by_row(released))
    if balance is None:
        return None
    moving, accelerations, force = balance
    held = rest & (moving == 0)
    modes[rubs] = np.where(rest, moving, np.sign(rate))[bounds.row[rubs]]
    modes[bounds.touched] = np.where(held, 0.0, -1.0)[bounds.row[bounds.touched]]
    if "margin" in own and _beyond(model, at, c, modes).any():
        return None
    if rest.any() and (broken := broken_law(model, at, c, modes, rest, force, own)) is not None:
        return broken
    settled_ = Settled(modes, at["q_i_dot"] - start, impacts, at["q_d_dot"])
    return settled_, own["v_rel"], accelerations


def _beyond(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray, modes: np.ndarray) -> np.ndarray:
    """(n_r,) frictions by reactions whose contraction is above its bound with these modes (n_m,)."""
    c = c.copy()
    c[len(c) - model.signals.size + model.element_modes] = modes
    return np.asarray(elements(model, at, c)["margin"] < 0)


def losses(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray, found: Settled) -> list[float]:
    """What each stop that is struck took, -p (v- + v+) / 2 [J]."""
    own, impacts = elements(model, at, c), [(model.mode_events[one.k], one.impulse) for one in found.impacts]
    passing = own["v_rel"] + 0.5 * times(own["G"], found.push)
    return [-one.side * p * float(passing[one.row]) for one, p in impacts]


def losses_text(lost: float, gained: float, driven: bool) -> str:
    """What energy is `gained` besides what is lost comes by the impulses of drives, where there are any."""
    given = f", work done by the prescribed motion: {gained + lost:.6g} J" if driven else ""
    return f", {lost:.6g} J lost{given}"


def no_mode(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> tuple[str, str]:
    """(cause, remedy) where no choice is consistent."""
    own = elements(model, at, c)
    if "margin" in own:
        sides = np.sign(own["v_rel"])[[event.row for event in model.mode_events]]
        beyond = _beyond(model, at, c, np.where(sides == 0, 1.0, sides))
        rows = np.abs(own["holds_R"]).argmax(axis=0)[beyond]
        names = [event.name for event in model.mode_events if not event.side and event.row in rows]
        if names:
            return (
                f"{', '.join(names)}: the joint's own force rises by more than half of what friction gains with it "
                "(Painleve): accelerations may be two or none",
                "Take a smaller mu, or a smaller radius.",
            )
    return (
        "no choice of what is held and what moves is consistent",
        "Look at the friction and the stops of joints that share a loop, or take a smaller friction.",
    )


def _balance(
    own: Mapping[str, np.ndarray], bounds: _Bounds, rest: np.ndarray, released: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
    """(n_e,) where each row at rest goes, zero where it is held, v' and the forces; None: nothing is consistent.

    Bounds and laws that are shares of the joints' own forces R follow from them, which follow from what is held.
    """
    n, shares = len(own.get("margin", ())), own["shares"][rest] if "shares" in own else None
    R, moving, force = np.zeros(n), np.zeros(len(rest)), np.zeros(len(rest))
    for _ in range(MOST_TURNS):
        b, holds = own["b"], own["holds"]
        if n:
            b, holds = b + own["b_R"] @ R, holds + own["holds_R"] @ R
        A, limits = own["A"][np.ix_(rest, rest)], holds
        while True:
            lower, upper = bounds.of(limits)
            sides = complementary(A, b[rest], lower[rest], upper[rest], released[rest], shares)
            if sides is None:
                return None
            moving[rest] = -sides
            fallen = np.where(moving != 0, np.minimum(limits, own.get("slides", limits)), limits)
            if (fallen == limits).all():
                break
            limits = fallen  # of what lets go, at once: it may be too much for others that held
        force[rest] = balancing(A, b[rest], lower[rest], upper[rest], sides, shares)
        before = R
        if n:
            R = np.linalg.norm((own["F_0"] + own["F_f"] @ force + own["F_R"] @ R).reshape(n, -1), axis=1)
        if (np.abs(R - before) <= FOUND * np.abs(R).max(initial=0.0)).all():
            return moving, b + times(own["A"], force), force
    return None


class _Bounds:
    """Of the forces on rows that are at rest: touched (n_m,): stops on which their rows lie.

    rest (n_e,): what friction or a stop may hold.
    """

    def __init__(self, stops: Stops, rate: np.ndarray, rest_rate: np.ndarray, touched: np.ndarray) -> None:
        self._side, self.row, self.touched = stops.side, stops.row, touched
        slow = np.abs(rate)[self.row] <= rest_rate
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


def _moved(model: EmittedModel, at: Mapping[str, np.ndarray], v: np.ndarray, c: np.ndarray) -> Mapping[str, np.ndarray]:
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


def elements(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """The function `elements` at a state with constants c; vectors are flat."""
    return _arrays(model.evaluate("elements", **at, c=c))


def weighed(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """What `weights` gives at a state with constants c; vectors are flat."""
    return _arrays(weights(model)(**at, c=c))


def _arrays(found: Mapping[str, ca.DM]) -> dict[str, np.ndarray]:
    shaped = {name: np.asarray(value, dtype=float) for name, value in found.items()}
    return {name: value if name in MATRICES else value.ravel() for name, value in shaped.items()}


def weights(model: EmittedModel) -> ca.Function:
    """(q_i, q_d, q_i_dot, q_d_dot, t, c) -> what `elements` says of v = G q_i', with v' = b + A f of forces f (n_e,) on
    it: A = G by, b = G M_hat^-1 Q_hat + G_bias, by = M_hat^-1 G^T (n_i, n_e). Exported C has this function, too.
    Of friction by reactions R: b + b_R R, holds + holds_R R, and R_k = |F_0 + F_f f + F_R R|_k.
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
        found |= {"slides": own["slides"]} if "slides" in own else {}
        if "margin" in own:
            by_R = ca.horzcat(*(solve(factors, Number(one)).re for one in ca.horzsplit(own["Q_hat_R"])))
            found |= {"b_R": G @ by_R, "F_f": own["F_f"] + own["F_a"] @ by, "F_R": own["F_R"] + own["F_a"] @ by_R}
            found |= {"F_0": own["F_0"] + own["F_a"] @ free} | {
                name: own[name] for name in ("holds_R", "shares", "margin")
            }
        names = list(found)
        return ca.Function("weights", list(at.values()), shared([ca.densify(one) for one in found.values()]),
                           list(at), names)  # fmt: skip

    return model.derived("weights", build)
