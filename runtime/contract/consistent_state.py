"""Consistent initial state: positions and velocities that satisfy the constraints (Eqs. 21, 24).

What the user fixed or gave stays exactly as long as what was left open can satisfy the constraints. Only if it
cannot do given values move, as little as possible in the least-squares sense (case F1 violates one by 2e-10).
Elastic coordinates move last, being small; those left open count as given zeros.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NoReturn

import numpy as np

from runtime.contract.errors import SymgenError
from runtime.contract.one_thread import one_thread
from runtime.contract.status import EventKind

MAX_ITERATIONS = 100
LARGEST_STEP = 0.5  # rad or m per iteration: keeps Newton on the branch the user started
POSITION_TOLERANCE = 1e-13  # m or rad, times the largest coordinate if above 1
VELOCITY_TOLERANCE = 1e-12
ROUNDING = 1e-13  # of the largest entry of C_q
OTHER_STARTS, TURN_OPEN = 6, 0.6  # rad or m
AS_NEAR = 1.25  # times as far away is another branch that may have been meant
SAME = 1e-6  # rad or m between places that are one
REMEDY = {
    "position": "free one of the fixed values, correct lengths and axes, take a joint that leaves more free, or start "
    "closer to an assembled position",
    "velocity": "free one of the fixed rates, or remove one of these joints or prescribed motions",
}

Residual = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


class InitialStateError(SymgenError, ValueError):
    """No consistent initial state: the message names the joints in conflict and what to do."""


@dataclass(frozen=True)
class GivenValues:
    """What the user said about coordinates or rates: name -> value, and which of them are fixed."""

    values: Mapping[str, float] = field(default_factory=dict)
    fixed: frozenset[str] = frozenset()


@dataclass(frozen=True)
class ConsistentState:
    """q and q_dot (all coordinates), and what had to be changed: {name: (given, used)}, deflections included.

    placed (n,): where joints that place bodies put what was not given, before loops were closed; other (n,): another
    branch that lies about as near to it. None where that was not looked for, or there is none. told: events of the
    start: what may not be what was meant.
    """

    q: np.ndarray
    q_dot: np.ndarray
    changed: dict[str, tuple[float, float]]
    placed: np.ndarray | None = None
    other: np.ndarray | None = None
    told: tuple[tuple[EventKind, str], ...] = ()


def consistent_state(
    names: list[str],
    elastic: frozenset[int],
    owners: list[str],
    position: Residual,
    velocity: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
    coordinates: GivenValues,
    rates: GivenValues,
    guess: np.ndarray | None = None,
    reluctant: frozenset[int] = frozenset(),
    first: Sequence[int] = (),
    following: frozenset[int] = frozenset(),
    origins: frozenset[int] = frozenset(),
) -> ConsistentState:
    """Solve C(q) = 0, then C_q q_dot = nu.

    names: coordinates; owners: joint of each constraint row; position(q) -> (C, C_q); velocity(q) -> (C_q, nu);
    guess: where coordinates that were left open start (zero by default); reluctant: those of them that count as given;
    first: rows that place bodies, satisfied by what was left open before the others are looked at; following:
    coordinates that these rows give, whose rates cost nothing, so that those of all others change least; origins:
    columns of places of bodies, which move alone where that is enough, so that nothing turns without need.
    Raises InitialStateError if no state within reach satisfies the constraints.
    """
    q0, stages = _start(names, elastic, coordinates, guess, reluctant)
    free, given = stages[-1], q0
    stages.insert(0, stages[0] & np.array([k in origins for k in range(len(names))], dtype=bool))
    open_ = np.array([k in reluctant and name not in coordinates.values for k, name in enumerate(names)], dtype=bool)
    q = None
    rows = np.array(first, dtype=int)
    for start in _starts(q0, open_):
        if len(first):
            start = _nearest(start, stages[1], lambda q: tuple(part[rows] for part in position(q)))
        moving, q = _first_closed(start, stages, position)
        if q is not None:
            break
    if q is None:
        _refuse(*position(_nearest(q0, free, position)), free, owners, names, "position")
    v0, stages = _start(names, elastic, rates, None, reluctant)
    free = stages[-1]
    C_q, nu = velocity(q)
    cheap = np.array([k in following for k in range(len(names))], dtype=bool)
    v = next((v for mask in stages if (v := _velocities(v0, mask, cheap, C_q, nu)) is not None), None)
    if v is None:
        nearest = v0 + _least_change(C_q, nu - C_q @ v0, free)
        _refuse(nu - C_q @ nearest, C_q, free, owners, names, "velocity")
    changed = {
        name: (float(given[k]), float(q[k]))
        for k, name in enumerate(names)
        if (name in coordinates.values or k in elastic) and q[k] != given[k]
    }
    changed |= {
        f"{name}_dot": (rates.values[name], float(v[k]))
        for k, name in enumerate(names)
        if name in rates.values and v[k] != rates.values[name]
    }
    return ConsistentState(q, v, changed, start, _other_branch(start, q, moving, position))


def _first_closed(
    start: np.ndarray, stages: list[np.ndarray], position: Residual
) -> tuple[np.ndarray, np.ndarray | None]:
    """(what moved, q) of the first stage that can satisfy the constraints; q is None if none can."""
    for mask in stages:
        q = _positions(start, mask, position)
        if q is not None:
            return mask, q
    return stages[-1], None


def _other_branch(start: np.ndarray, q: np.ndarray, moving: np.ndarray, position: Residual) -> np.ndarray | None:
    """The branch on the other side of the start, if it lies about as near as q."""
    if np.abs(q - start).max(initial=0.0) <= SAME or not _is_isolated(position(q)[1][:, moving]):
        return None
    found = _positions(2 * start - q, moving, position)
    if found is None or np.abs(less_turns(found - q)).max() <= SAME:
        return None
    return (
        found if np.linalg.norm(less_turns(found - start)) <= AS_NEAR * np.linalg.norm(less_turns(q - start)) else None
    )


def _is_isolated(slope: np.ndarray) -> bool:
    """Do the constraints leave nothing open of what moves (columns)?"""
    return bool(np.linalg.matrix_rank(slope, tol=SAME) == slope.shape[1])


def less_turns(change: np.ndarray) -> np.ndarray:
    """Changes of angles less whole turns (and so of lengths, which are small here, or not asked about)."""
    return np.asarray((change + np.pi) % (2 * np.pi) - np.pi)


def _start(
    names: list[str], elastic: frozenset[int], given: GivenValues, guess: np.ndarray | None, reluctant: frozenset[int]
) -> tuple[np.ndarray, list[np.ndarray]]:
    """(starting values, what may move: first only what was left open, then what is reluctant, given, elastic)."""
    start = np.zeros(len(names)) if guess is None else guess
    value = np.array([given.values.get(name, start[k]) for k, name in enumerate(names)])
    is_elastic = np.array([k in elastic for k in range(len(names))], dtype=bool)
    free = np.array([name not in given.fixed for name in names], dtype=bool)
    is_open = np.array([name not in given.values for name in names], dtype=bool) & ~is_elastic
    is_reluctant = np.array([k in reluctant for k in range(len(names))], dtype=bool)
    return value, [is_open & ~is_reluctant & free, is_open & free, ~is_elastic & free, free]


def _starts(q0: np.ndarray, open_: np.ndarray) -> Iterator[np.ndarray]:
    """q0, then starts with the open coordinates of joints turned a little: a straight chain knows no way to bend."""
    yield q0
    rng = np.random.default_rng(0)
    for _ in range(OTHER_STARTS if open_.any() else 0):
        yield q0 + np.where(open_, rng.uniform(-TURN_OPEN, TURN_OPEN, len(q0)), 0.0)


def _positions(q0: np.ndarray, free: np.ndarray, position: Residual) -> np.ndarray | None:
    """Gauss-Newton on C(q) = 0 moving the free coordinates only; None if it does not get there."""
    q = _nearest(q0, free, position)
    C, _ = position(q)
    return q if C.size == 0 or np.abs(C).max() <= POSITION_TOLERANCE * _scale(q) else None


def _nearest(q0: np.ndarray, free: np.ndarray, position: Residual) -> np.ndarray:
    q, best, best_error = q0.copy(), q0.copy(), np.inf
    for _ in range(MAX_ITERATIONS):
        C, C_q = position(q)
        if not (np.all(np.isfinite(C)) and np.all(np.isfinite(C_q))):
            raise InitialStateError("the constraints are not finite at the initial state; check motions and parameters")
        error = float(np.abs(C).max(initial=0.0))
        if error < best_error:
            best, best_error = q, error
        if error <= 1e-16 * _scale(q):
            break
        step = _least_change(C_q, -C, free)
        largest = float(np.abs(step).max(initial=0.0))
        if largest <= 1e-16 * _scale(q):
            break
        if largest > LARGEST_STEP and not _solves(q + step, position):
            step *= LARGEST_STEP / largest
        q = q + step
    return best


def _solves(q: np.ndarray, position: Residual) -> bool:
    """Do the constraints hold? After a long step they do only if they are linear in what moved, as along a chain."""
    C, _ = position(q)
    return bool(np.abs(C).max(initial=0.0) <= POSITION_TOLERANCE * _scale(q))


def _velocities(
    v0: np.ndarray, free: np.ndarray, cheap: np.ndarray, C_q: np.ndarray, nu: np.ndarray
) -> np.ndarray | None:
    v = v0 + _least_dear_change(C_q, nu - C_q @ v0, free, cheap)
    v = v + _least_change(C_q, nu - C_q @ v, free)
    residual = float(np.abs(nu - C_q @ v).max(initial=0.0))
    return v if residual <= VELOCITY_TOLERANCE * _scale(v) else None


def _least_dear_change(C_q: np.ndarray, side: np.ndarray, free: np.ndarray, cheap: np.ndarray) -> np.ndarray:
    """A step with C_q step = side whose part without the cheap coordinates is smallest; they follow from it."""
    if not (cheap & free).any():
        return _least_change(C_q, side, free)
    Q, R = np.linalg.qr(C_q[:, cheap & free])
    rank_deficient = np.abs(np.diag(R)).min() <= 1e-10 * np.abs(R).max()
    if rank_deficient:  # a placed body whose own rows do not give all of it: treat all alike
        return _least_change(C_q, side, free)
    beyond = C_q - Q @ (Q.T @ C_q)  # what they cannot satisfy; nothing at all where only rounding is left
    beyond[np.abs(beyond) < ROUNDING * np.abs(C_q).max()] = 0.0
    step = _least_change(beyond, side - Q @ (Q.T @ side), free & ~cheap)
    return np.asarray(step + _least_change(C_q, side - C_q @ step, free & cheap))


def _least_change(C_q: np.ndarray, side: np.ndarray, free: np.ndarray) -> np.ndarray:
    """Smallest step with C_q step = side on the free coordinates (least squares if there is none)."""
    step = np.zeros(C_q.shape[1])
    if C_q.shape[0] and free.any():
        with one_thread(len(free)):
            step[free] = np.linalg.lstsq(C_q[:, free], side, rcond=1e-13)[0]
    return step


def _scale(values: np.ndarray) -> float:
    return max(1.0, float(np.abs(values).max(initial=0.0)))


def _refuse(
    residual: np.ndarray, C_q: np.ndarray, free: np.ndarray, owners: list[str], names: list[str], level: str
) -> NoReturn:
    worst = np.abs(residual) > 0.01 * np.abs(residual).max()
    joints = sorted({owners[k] for k in np.flatnonzero(worst)})
    touched = np.abs(C_q[worst]).max(axis=0) > 0
    held = sorted(names[k] for k in np.flatnonzero(touched & ~free))
    reason = f"; fixed there: {', '.join(held)}" if held else ""
    raise InitialStateError(
        f"no consistent initial state at {level} level: {', '.join(joints)} cannot all be satisfied "
        f"(largest error {np.abs(residual).max():.3g}){reason}; {REMEDY[level]}"
    )
