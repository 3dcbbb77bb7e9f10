"""Friction and stops at a state that no run leads to: what moves slides by the sign of its rate, the rest holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.coordinates import at_home, dependent_part, rate_parts
from runtime.contract.model import Model, refuse_reactions
from runtime.operating.balance import Clamped
from runtime.operating.functions import PointValues, independent_turns
from runtime.schemes.switching.complementarity import balancing, complementary
from runtime.schemes.switching.settle import elements
from runtime.schemes.switching.stops import AT_REST

BEYOND = 1e-9  # of what holds: how far a force may be beyond it


@dataclass(frozen=True)
class Unlocked:
    """M_hat and Q_hat with the friction of joints that slide and none of those that rest; G, G_bias and bounds (k,) of
    the latter.
    """

    M: np.ndarray
    Q: np.ndarray
    G: np.ndarray
    G_bias: np.ndarray
    holds: np.ndarray

    def accelerations(self) -> np.ndarray | None:
        """q_i_ddot (n_i,) with what rests held as far as friction can; None where no choice is consistent."""
        free, by = np.linalg.solve(self.M, self.Q), np.linalg.solve(self.M, self.G.T)
        A, b = self.G @ by, self.G @ free + self.G_bias
        sides = complementary(A, b, -self.holds, self.holds)
        return None if sides is None else free + by @ balancing(A, b, -self.holds, self.holds, sides)


def with_modes(model: Model, values: np.ndarray, modes: np.ndarray) -> np.ndarray:
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


def signs(model: Model, at: Mapping[str, np.ndarray], c: np.ndarray) -> np.ndarray:
    """(n_m,) of the rates of joints with friction, zero at rest, one of stops; at: q_i, q_d, q_i_dot, q_d_dot, t."""
    refuse_reactions(model, "is open at a state by itself", "give coulomb, or step it")
    rate = elements(model, at, c)["v_rel"][[one.row for one in model.mode_events]]
    rest = AT_REST * (1.0 + np.abs(at["q_i_dot"]).max(initial=0.0))
    sides = np.array([one.side for one in model.mode_events])
    return np.where(sides != 0, 1.0, np.where(np.abs(rate) <= rest, 0.0, np.sign(rate)))


def unlocked(model: Model, at: Mapping[str, np.ndarray], c: np.ndarray) -> Unlocked:
    """At a state: q_i, q_d, q_i_dot, q_d_dot, t, with constants c."""
    modes = signs(model, at, c)
    own = elements(model, at, with_modes(model, c, modes))
    rest = [one.row for one, mode in zip(model.mode_events, modes, strict=True) if mode == 0]
    return Unlocked(own["M_hat"], own["Q_hat"], own["G"][rest], own["G_bias"][rest], own["holds"][rest])


def held(model: Model, at: Mapping[str, np.ndarray], c: np.ndarray) -> tuple[dict[str, float], dict[str, float]]:
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
