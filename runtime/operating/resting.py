"""Friction and stops at a state that no run leads to: what moves slides by the sign of its rate, the rest holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from runtime.contract.coordinates import at_home, dependent_part, rate_parts
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel, refuse_reactions
from runtime.operating.at_stops import MOST_CORRECTIONS, ON_IT, gaps
from runtime.operating.balance import MOST_PLACINGS, Clamped
from runtime.operating.functions import PointValues, independent_turns
from runtime.operating.newton import LARGEST_STEP, STEP_HALVINGS, Found
from runtime.schemes.switching.complementarity import balancing, complementary
from runtime.schemes.switching.settle import elements
from runtime.schemes.switching.stops import AT_REST

BEYOND = 1e-9  # of what holds: how far a force may be beyond it


MOST_TURNS, SETTLED_FORCES = 100, 1e-14  # of forces of joints that follow from the friction they cause


@dataclass(frozen=True)
class Unlocked:
    """M_hat and Q_hat with the friction of joints that slide and none of those that rest, and stops open.

    G, G_bias, lower and upper (k,): of what rests, by friction or on a stop, with the bounds of its force. own: the
    function `elements`; beyond: stops that the state is beyond, with the distance [m or rad].
    """

    model: EmittedModel
    M: np.ndarray
    Q: np.ndarray
    G: np.ndarray
    G_bias: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    own: Mapping[str, np.ndarray]
    beyond: Mapping[str, float]

    def accelerations(self, tau: np.ndarray | None = None) -> np.ndarray | None:
        """q_i_ddot (n_i,) with what rests held as far as friction and stops can; None where no choice is consistent.

        Raises ModelError beyond a stop, and for friction by reactions.
        """
        self.refuse_beyond()
        refuse_reactions(self.model, "forward dynamics at a state do not solve for", "give coulomb, or step it")
        Q = self.Q if tau is None else self.Q + tau
        free, by = np.linalg.solve(self.M, Q), np.linalg.solve(self.M, self.G.T)
        A, b = self.G @ by, self.G @ free + self.G_bias
        sides = complementary(A, b, self.lower, self.upper)
        return None if sides is None else free + by @ balancing(A, b, self.lower, self.upper, sides)

    def force_at(self, a: np.ndarray) -> np.ndarray:
        """Q_hat (n_i,) at accelerations (n_i,), on which friction by reactions depends: R = |F_0 + F_a a + F_R R|.

        Raises ModelError beyond a stop, and where these reactions have no solution.
        """
        self.refuse_beyond()
        if "F_0" not in self.own:
            return self.Q
        own, R = self.own, np.zeros(len(self.own["margin"]))
        for _ in range(MOST_TURNS):
            before = R
            R = np.linalg.norm((own["F_0"] + own["F_a"] @ a + own["F_R"] @ R).reshape(len(R), -1), axis=1)
            if (np.abs(R - before) <= SETTLED_FORCES * np.abs(R).max(initial=0.0)).all():
                return np.asarray(self.Q + own["Q_hat_R"] @ R)
        raise ModelError(
            f"friction of model {self.model.name}", "the joint forces that mu needs have no solution at this state",
            "take a smaller mu, or a smaller radius",
        )  # fmt: skip

    def refuse_beyond(self) -> None:
        """Raises ModelError for a state beyond a stop."""
        for name, far in self.beyond.items():
            raise ModelError(f"{name} of model {self.model.name}", f"q is {far:.6g} beyond it", "give a q within it")


def with_modes(model: EmittedModel, values: np.ndarray, modes: np.ndarray) -> np.ndarray:
    """p or c, whose last entries are the inputs, with modes (n_m,)."""
    found = values.copy()
    found[len(found) - model.signals.size + model.element_modes] = modes
    return found


def state_of(clamped: Clamped, at: PointValues, q_i: np.ndarray) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Arguments of the functions of friction, and c: turns are zero, charts are where the bodies are."""
    model = clamped.model
    c, q_d = at_home(model, clamped.functions.c, dependent_part(model, at.q))
    places = np.where(np.isin(np.arange(len(q_i)), independent_turns(model)), 0.0, q_i)
    state = {"q_i": places, "q_d": q_d, "q_i_dot": clamped.rates(q_i), "q_d_dot": rate_parts(model, at.q, at.q_dot)[1]}
    return {**state, "t": np.array(clamped.t)}, c


def signs(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> np.ndarray:
    """(n_m,) of the rates of joints with friction, zero at rest, one of stops; at: q_i, q_d, q_i_dot, q_d_dot, t."""
    rate = elements(model, at, c)["v_rel"][[one.row for one in model.mode_events]]
    sides = np.array([one.side for one in model.mode_events])
    return np.where(sides != 0, 1.0, np.where(np.abs(rate) <= _slow(at), 0.0, np.sign(rate)))


def _slow(at: Mapping[str, np.ndarray]) -> float:
    """The rate below which an element rests."""
    return AT_REST * (1.0 + float(np.abs(at["q_i_dot"]).max(initial=0.0)))


def unlocked(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> Unlocked:
    """At a state: q_i, q_d, q_i_dot, q_d_dot, t, with constants c; stops are open where the state is within them."""
    modes = signs(model, at, c)
    own = elements(model, at, with_modes(model, c, modes))
    events, holds = model.mode_events, own["holds"]
    stops = [one for one in events if one.side]
    gap = dict(zip((one.name for one in stops), own.get("gap", np.zeros(0)), strict=True))
    still = np.abs(own["v_rel"]) <= _slow(at)
    touched = [one for one in stops if gap[one.name] <= ON_IT and still[one.row]]
    rubs = [one.row for one, mode in zip(events, modes, strict=True) if mode == 0]
    lower, upper = -holds, holds.copy()
    upper[[one.row for one in touched if one.side > 0]] = np.inf
    lower[[one.row for one in touched if one.side < 0]] = -np.inf
    rest = sorted({*rubs, *(one.row for one in touched)})
    beyond = {name: -float(one) for name, one in gap.items() if one < -ON_IT}
    G, bias = own["G"][rest], own["G_bias"][rest]
    return Unlocked(model, own["M_hat"], own["Q_hat"], G, bias, lower[rest], upper[rest], own, beyond)


def held(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> tuple[dict[str, float], dict[str, float]]:
    """(forces of what friction or a closed stop holds at rest, those of them that are beyond what it can), by name.

    c: with their modes; nothing accelerates.
    """
    modes = c[len(c) - model.signals.size + model.element_modes]
    still = {**at, "q_i_ddot": np.zeros(len(model.q_i))}
    found = np.asarray(model.evaluate("element_forces", **still, c=c)["f_rel"]).ravel()
    holds = elements(model, at, c)["holds"]
    rest = [one for one, mode in zip(model.mode_events, modes, strict=True) if not mode]
    pushes = {(one.row, one.side) for one in rest}
    forces, beyond = {one.name: float(found[one.row]) for one in rest}, dict[str, float]()
    for one in rest:
        f, most = forces[one.name], float(holds[one.row]) * (1 + BEYOND)
        if f < -most and (one.row, -1) not in pushes or f > most and (one.row, 1) not in pushes:
            beyond[one.name] = f
    return forces, beyond


# Equilibria that rest on rigid stops: what would lie beyond a stop is put on it, none pulls.
#
# With the gaps g >= 0 of stops and their forces f >= 0, g f = 0: an active set. Each round closes the stops that the
# last equilibrium is beyond and opens those that would pull; a closed stop locks its row in M_hat and Q_hat.

CLOSED_GAP = 1e-12  # m or rad


def on_stops(clamped: Clamped, found: Found, p: np.ndarray) -> tuple[Found, np.ndarray, Clamped]:
    """From an equilibrium with all stops open the one that rests on those it is beyond, and p with their modes.

    And `clamped` with the constants of that p. Where no choice comes out, the last is what is found.
    """
    model, iterations = clamped.model, found.iterations
    stops = np.array([bool(one.side) for one in model.mode_events])
    names = np.array([one.name for one in model.mode_events])
    for _ in range(MOST_CORRECTIONS):
        at = clamped.values(found.x)
        if not found.converged or at is None:
            break
        now = p[len(p) - model.signals.size + model.element_modes]
        closed, gap = stops & (now == 0), _rows(clamped, at)[0]
        pulls = stops & np.isin(names, list(held(model, *state_of(clamped, at, found.x))[1]))
        off = (gap < -ON_IT) | closed & (gap > ON_IT)
        if not (off | pulls).any():
            break
        closed = (closed | off) & ~pulls
        placed = _placed(clamped, found.x, closed)
        if placed is None:
            clamped = replace(clamped, loop=at.loop)
            break
        p = with_modes(model, p, np.where(stops, np.where(closed, 0.0, 1.0), now))
        clamped = clamped.with_constants(model.constants(p))
        found = clamped.solve(placed)
        iterations += found.iterations
    return Found(found.x, found.converged, found.residual, iterations), p, clamped


def _rows(clamped: Clamped, at: PointValues) -> tuple[np.ndarray, np.ndarray]:
    """Gaps (n_m,), infinite for friction, and their slopes by q_i (n_m, n_i)."""
    events = clamped.model.mode_events
    side, gap = np.array([one.side for one in events]), np.full(len(events), np.inf)
    gap[side != 0], G = gaps(clamped.model, clamped.functions.c, clamped.t, at.q, at.q_dot)
    return gap, side[:, None] * G[[one.row for one in events]]


def _placed(clamped: Clamped, q_i: np.ndarray, closed: np.ndarray) -> np.ndarray | None:
    """The nearest q_i on the closed stops (n_m,) with clamped coordinates as they are; None if none is in reach."""
    for _ in range(MOST_PLACINGS):
        at = clamped.values(q_i)
        if at is None:
            return None
        gap, slopes = _rows(clamped, at)
        if np.abs(gap[closed]).max(initial=0.0) <= CLOSED_GAP:
            return q_i
        step = np.linalg.lstsq(slopes[closed] @ clamped.free(at), -gap[closed], rcond=1e-12)[0]
        step *= min(1.0, LARGEST_STEP / max(float(np.abs(step).max(initial=0.0)), 1e-300))
        for _ in range(STEP_HALVINGS):  # until the loops close from where they were
            there = clamped.advance(q_i, step)
            if there is not None and clamped.values(there) is not None:
                break
            step = 0.5 * step
        else:
            return None
        q_i = there
    return None


def refuse_beyond(model: EmittedModel, c: np.ndarray, t: float, q: np.ndarray, q_dot: np.ndarray) -> None:
    """Raises ModelError where an equilibrium is beyond a rigid stop all the same: what is held or turns is."""
    stops, (gap, _) = [one for one in model.mode_events if one.side], gaps(model, c, t, q, q_dot)
    beyond = {stops[k].name: -float(gap[k]) for k in np.flatnonzero(gap < -ON_IT)}
    if beyond:
        found = ", ".join(f"{by:.4g} beyond {name}" for name, by in beyond.items())
        remedy = "hold or turn other coordinates, begin elsewhere, or simulate with damping until it rests"
        raise ModelError(f"the equilibrium of model {model.name}", f"lies {found}", remedy)
