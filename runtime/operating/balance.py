"""Forces at rest or in steady motion with some coordinates clamped, and the directions that are left free."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import turned_by
from runtime.contract.model import EmittedModel
from runtime.operating.functions import ALREADY_CLOSED, PointFunctions, PointValues, rates_and_forces, row_names
from runtime.operating.mode_solver import State
from runtime.schemes.stage_equations import StageEquations

# ---- Newton's method for a balance of forces, kept from running to equilibria that are not stable.
#
# r(x) = 0 with the exact slope H = dr/dx. Where the symmetric part of H (in the metric of the mass matrix) has
# positive eigenvalues, x is on a hill of the potential: the step goes down it, with the eigenvalues' absolute
# values (the saddle-free Newton method, Dauphin et al. 2014), so that it ends in a valley unless it starts on a
# summit. Near the solution the step is Newton's own. Directions without stiffness are left alone.

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


# ---- Parameters that loads depend on, solved for so that no coordinate needs a holding force.

TRIM_ITERATIONS = 50
TRIM_TOLERANCE = 1e-12  # of the largest correction, relative to the largest value
BALANCED = 1e-9  # what may be left of the forces, relative to those before


def force_by_parameters(model: EmittedModel, names: Sequence[str], drives_move: bool = True) -> ca.Function:
    """(t, q_i, q_i_dot, a, loop unknowns, p) -> d(Q_hat - M_hat a)/d(p of these names) (n_i x k), q_d = f(q_i, p)."""
    index = [[parameter.name for parameter in model.parameters].index(name) for name in names]
    n = len(model.q_i)
    t, q, v, a = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    equations = StageEquations(model, model.kernel("constants")(p))
    _, M, Q = rates_and_forces(equations, equations.close(q, loop, t, ALREADY_CLOSED), v, drives_move)
    slope = ca.jacobian(Q - ca.mtimes(M, a), p)[:, index]
    return ca.Function("by_parameters", [t, q, v, a, loop, p], [ca.densify(slope)])


def _reciprocal(sizes: np.ndarray) -> np.ndarray:
    """1 / sizes; 1 for what has none, as the row of a coordinate on which nothing depends."""
    return 1.0 / np.where(sizes > 1e-300, sizes, 1.0)


@dataclass(frozen=True)
class Trimmed:
    """q_i, p and the iterations it took; converged. clamped: with the constants of the last p."""

    clamped: Clamped
    q_i: np.ndarray
    p: np.ndarray
    iterations: int
    converged: bool


def trimmed(model: EmittedModel, clamped: Clamped, q_i: np.ndarray, p: np.ndarray, names: Sequence[str]) -> Trimmed:
    """Newton on Q_hat(q_i, p) = 0 and the clamped coordinates' values, over q_i and the named parameters.

    It begins at the equilibrium with holding forces.
    """
    drives_move = clamped.functions.drives_move
    by_parameters = force_by_parameters(model, names, drives_move)
    index = [[parameter.name for parameter in model.parameters].index(name) for name in names]
    n, p = len(q_i), p.copy()
    start = np.inf
    for iteration in range(TRIM_ITERATIONS):
        clamped = clamped.with_constants(model.constants(p))
        at = clamped.values(q_i)
        if at is None:
            break
        state = State(clamped.t, q_i, clamped.rates(q_i), at.loop)
        Q_p = np.asarray(by_parameters(state.t, state.q_i, state.q_i_dot, np.zeros(n), state.loop, p))
        k = len(clamped.rows)
        matrix = np.block([[clamped.unknowns_slope(at), Q_p], [at.directions[clamped.rows], np.zeros((k, len(index)))]])
        side = np.concatenate([at.Q, at.places[clamped.rows] - clamped.goal])
        scale = _reciprocal(np.abs(matrix).max(axis=1))
        columns = _reciprocal(np.abs(matrix * scale[:, None]).max(axis=0))
        step = -columns * np.linalg.lstsq(matrix * np.outer(scale, columns), scale * side, rcond=1e-13)[0]
        size = float(np.abs(at.Q).max())
        start = size if iteration == 0 else start
        done = np.abs(step[:n]).max() <= TRIM_TOLERANCE * max(1.0, float(np.abs(q_i).max()))
        done = done and bool(np.all(np.abs(step[n:]) <= 1e-11 * np.maximum(np.abs(p[index]), 1e-300)))
        if done or size == 0:
            return Trimmed(clamped, q_i, p, iteration, size <= BALANCED * max(start, 1e-300) or iteration == 0)
        q_i = q_i + step[:n]
        p[index] += step[n:]
    return Trimmed(clamped, q_i, p, TRIM_ITERATIONS, False)
