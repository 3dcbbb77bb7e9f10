"""Forces at rest or in steady motion with some coordinates clamped, and the directions that are left free."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import turned_by
from runtime.contract.model import EmittedModel
from runtime.operating.functions import PointFunctions, PointValues, row_names
from runtime.operating.mode_solver import State
from runtime.operating.newton import LARGEST_STEP, Balance, Found, balanced

PLACED_ERROR = 1e-13  # rad or m: how well clamped dependent coordinates meet their values
MOST_PLACINGS = 60


def clamped_directions(S: np.ndarray, states: Sequence[int] = ()) -> np.ndarray:
    """Orthonormal basis (n_i x k) of the directions of q_i in which the clamped coordinates, rows of S, do not move.

    states: positions in q_i that stay apart, as the last directions.
    """
    if len(states):
        mechanical = [k for k in range(S.shape[1]) if k not in states]
        own = clamped_directions(S[:, mechanical])
        basis = np.zeros((S.shape[1], own.shape[1] + len(states)))
        basis[mechanical, : own.shape[1]] = own
        basis[list(states), own.shape[1] :] = np.eye(len(states))
        return basis
    if not len(S):
        return np.eye(S.shape[1])
    unit = (np.count_nonzero(S, axis=1) == 1).all()
    if unit:  # independent coordinates, or ones that follow a single one: the others stay as they are
        moving = np.flatnonzero(~S.any(axis=0))
        return np.eye(S.shape[1])[:, moving]
    _, s, V = np.linalg.svd(S)
    rank = int(np.sum(s > 1e-12 * s[0]))
    return np.asarray(V[rank:].T)


@dataclass
class Clamped:
    """A model with coordinates `rows` of q clamped at `goal`, at time t [s] and rates v (n_i).

    Nothing depends on the integral of a controller's state, so the entry of q_i stands for the state itself, its rate.
    It remembers the loop unknowns of the last state, from which the next closure starts.
    """

    model: EmittedModel
    functions: PointFunctions
    t: float
    v: np.ndarray
    rows: list[int]
    goal: np.ndarray
    loop: np.ndarray

    def with_constants(self, c: np.ndarray) -> Clamped:
        """The same with other constants c (c_size,)."""
        return replace(self, functions=PointFunctions(self.model, c, self.functions.drives_move))

    def state(self, q_i: np.ndarray) -> State:
        """The state at q_i."""
        return State(self.t, q_i, self.rates(q_i), self.loop)

    def rates(self, q_i: np.ndarray) -> np.ndarray:
        """q_i_dot (n_i): v, and the states of controllers."""
        v = self.v.copy()
        v[self.model.states] = q_i[self.model.states]
        return v

    def unknowns_slope(self, at: PointValues) -> np.ndarray:
        """dQ_hat by the unknowns (n_i x n_i): by q_i, and by the states of controllers."""
        slope = at.J_q.copy()
        slope[:, self.model.states] = at.J_v[:, self.model.states]
        return slope

    def values(self, q_i: np.ndarray) -> PointValues | None:
        """All functions at q_i, or None where they are not finite or the loops do not close."""
        found = self.functions(self.state(q_i))
        if not found.usable:
            return None
        self.loop = found.loop
        return found

    def holding(self, at: PointValues) -> np.ndarray:
        """(k,) forces on the clamped coordinates that keep them, of least norm: S_k^T f = -Q_hat."""
        if not self.rows:
            return np.zeros(0)
        return np.asarray(np.linalg.lstsq(at.directions[self.rows].T, -at.Q, rcond=1e-12)[0])

    def slope(self, q_i: np.ndarray, at: PointValues) -> np.ndarray:
        """dQ_hat/dq_i with the holding forces constant (n_i x n_i)."""
        n, names = len(self.model.coordinates), row_names(self.model)
        if all(names[row] in self.model.q_i for row in self.rows):
            return self.unknowns_slope(at)
        force = np.zeros(len(names))
        force[self.rows] = self.holding(at)
        force = force[:n]  # what holds an independent turn adds no stiffness
        return np.asarray(
            self.unknowns_slope(at) + self.functions.pull_slope(replace(self.state(q_i), loop=at.loop), force)
        )

    def free(self, at: PointValues) -> np.ndarray:
        """Directions in which the clamped coordinates do not move (n_i x k)."""
        return clamped_directions(at.directions[self.rows], self.model.states)

    def balance(self, q_i: np.ndarray) -> Balance | None:
        """Force, slope and mass in the free directions."""
        at = self.values(q_i)
        if at is None:
            return None
        Z = self.free(at)
        return Z.T @ at.Q, Z.T @ self.slope(q_i, at) @ Z, Z.T @ at.M @ Z

    def advance(self, q_i: np.ndarray, step: np.ndarray) -> np.ndarray | None:
        """q_i after a step in the free directions, with clamped coordinates back on their values."""
        at = self.values(q_i)
        return None if at is None else self.placed(self._after(at, q_i, self.free(at) @ step))

    def placed(self, q_i: np.ndarray) -> np.ndarray | None:
        """The nearest q_i at which the clamped coordinates have their values; None if there is none in reach."""
        if not self.rows:
            return q_i
        for _ in range(MOST_PLACINGS):
            at = self.values(q_i)
            if at is None:
                return None
            off = at.places[self.rows] - self.goal
            if np.abs(off).max() <= PLACED_ERROR * max(1.0, float(np.abs(self.goal).max())):
                return q_i
            step = np.linalg.lstsq(at.directions[self.rows], off, rcond=1e-12)[0]
            share = min(1.0, LARGEST_STEP / max(float(np.abs(step).max()), 1e-300))
            q_i = self._after(at, q_i, -share * step)
        return None

    def _after(self, at: PointValues, q_i: np.ndarray, step: np.ndarray) -> np.ndarray:
        """q_i after a step; the guess of the loop unknowns goes with it where they turn."""
        q_i, self.loop = turned_by(self.model, at.q, at.S @ step, q_i, step, self.loop)
        return q_i

    def solve(self, q_i: np.ndarray) -> Found:
        """Equilibrium in the free directions."""
        placed = self.placed(q_i)
        if placed is None:
            return Found(q_i, False, np.zeros(0), 0)
        return balanced(self.balance, placed, self.advance, len(self.model.states))


def steady_rates(
    functions: PointFunctions, t: float, q_i: np.ndarray, loop: np.ndarray, rates: dict[str, float]
) -> np.ndarray:
    """q_i_dot (n_i) of least size that gives the rates; what is not given rests. Raises InitialStateError."""
    model, n = functions.model, len(functions.model.q_i)
    if not rates:
        return np.zeros(n)
    at = functions(State(t, q_i, np.zeros(n), loop))
    rows = [row_names(model).index(name) for name in rates]
    wanted, S = np.array(list(rates.values())) - at.speeds[rows], at.directions[rows]
    v = np.linalg.lstsq(S, wanted, rcond=1e-12)[0]
    if np.abs(S @ v - wanted).max() > 1e-9 * max(1.0, float(np.abs(wanted).max())):
        raise InitialStateError(f"{', '.join(rates)} cannot have these rates: they depend on each other, or are given")
    return np.where(np.abs(v) > 1e-14 * np.abs(v).max(initial=0.0), v, 0.0)
