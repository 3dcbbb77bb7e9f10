"""Consistent initial conditions (assembly): positions and velocities that satisfy the constraints (Eqs. 21, 24).

What the user fixed or gave stays exactly as long as what was left open can satisfy the constraints. Only if it
cannot do given values move, as little as possible in the least-squares sense (case F1 violates one by 2e-10).
Elastic coordinates move last, being small; those left open count as given zeros.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cache, cached_property
from threading import Lock
from typing import Any, NoReturn

import numpy as np

from runtime.contract.errors import SymgenError
from runtime.contract.orientations import (
    angle_names,
    angle_rates,
    angles,
    angular_velocity,
    parameter_slopes,
    quaternion,
)
from runtime.contract.records import Coordinate
from runtime.contract.status import Event, EventKind

# Dense linear algebra by one thread of BLAS: several wait for each other longer than some hundred rows take.
#
# On two cores that other work shares, eigenvalues of a 600 x 600 matrix take 0.18 s of CPU by one thread, 2.7 s by
# two.

ROWS_OF_ONE_THREAD = 64  # rows up to which BLAS takes one thread anyway


class _OneThread:
    """A limit that lasts from the first who asks for it to the last, in whatever threads they are."""

    def __init__(self) -> None:
        self._lock, self._asked = Lock(), 0
        self._limit: Any = None

    def __enter__(self) -> None:
        with self._lock:
            if self._asked == 0:
                self._limit = _libraries().limit(limits=1, user_api="blas")
            self._asked += 1

    def __exit__(self, *raised: object) -> None:
        with self._lock:
            self._asked -= 1
            if self._asked == 0:
                self._limit.restore_original_limits()


_LIMITED = _OneThread()


def one_thread(rows: int) -> AbstractContextManager[None]:
    """While it lasts, BLAS takes one thread for matrices of so many rows; small ones are left alone."""
    return nullcontext() if rows <= ROWS_OF_ONE_THREAD else _LIMITED


def dense_eigenvalues(A: np.ndarray) -> np.ndarray:
    """(n,) of a matrix (n, n). Raises LinAlgError if it is not finite."""
    with one_thread(len(A)):
        return np.asarray(np.linalg.eigvals(A))


@cache
def _libraries() -> Any:
    from threadpoolctl import ThreadpoolController  # only where matrices are large

    return ThreadpoolController()


# Consistent initial state: positions and velocities that satisfy the constraints (Eqs. 21, 24).
#
# What the user fixed or gave stays exactly as long as what was left open can satisfy the constraints. Only if it
# cannot do given values move, as little as possible in the least-squares sense (case F1 violates one by 2e-10).
# Elastic coordinates move last, being small; those left open count as given zeros.

MAX_ASSEMBLY_ITERATIONS = 100
LARGEST_STEP = 0.5  # rad or m per iteration: keeps Newton on the branch the user started
CLOSURE_ROUNDING = 8e-16  # the same: what rounding leaves of constraints that hold; no step makes it smaller
POSITION_TOLERANCE = 1e-13  # m or rad, times the largest coordinate if above 1
VELOCITY_TOLERANCE = 1e-12
JACOBIAN_ROUNDING = 1e-13  # of the largest entry of C_q
OTHER_STARTS, TURN_OPEN = 6, 0.6  # rad or m
AS_NEAR = 1.25  # times as far away is another branch that may have been meant
ONE_PLACE = 1e-6  # rad or m between places that are one
MANY_ROWS, MOSTLY_ZERO = 200, 0.05  # from here, and for so few entries that are not zero, sparse equations
SPARSE_ROUNDING = 1e-13  # of the side: what sparse equations may leave of it
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
    branch that lies about as near to it. None where that was not looked for, or there is none. reported: events of the
    start: what may not be what was meant. not_given: names of what was changed that nobody gave.
    """

    q: np.ndarray
    q_dot: np.ndarray
    changed: dict[str, tuple[float, float]]
    placed: np.ndarray | None = None
    other: np.ndarray | None = None
    reported: tuple[tuple[EventKind, str], ...] = ()
    not_given: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Assembly:
    """What a start has to satisfy, and what may move for it: C(q) = 0, then C_q q_dot = nu.

    names: coordinates; owners: joint of each constraint row; position(q) -> (C, C_q); velocity(q) -> (C_q, nu);
    guess: where coordinates that were left open start (zero by default); reluctant: those of them that count as given;
    first: rows that place bodies, satisfied by what was left open before the others are looked at; following:
    coordinates that these rows give, whose rates cost nothing, so that those of all others change least; origins:
    columns of places of bodies, which move alone where that is enough, so that nothing turns without need.
    sequences: of Euler angles by body, where these are given in place of the Euler parameters among the names.
    """

    names: list[str]
    elastic: frozenset[int]
    owners: list[str]
    position: Residual
    velocity: Residual
    coordinates: GivenValues = GivenValues()
    rates: GivenValues = GivenValues()
    guess: np.ndarray | None = None
    reluctant: frozenset[int] = frozenset()
    first: Sequence[int] = ()
    following: frozenset[int] = frozenset()
    origins: frozenset[int] = frozenset()
    sequences: Mapping[str, str] = field(default_factory=dict)

    def stages(self, given: GivenValues, guess: np.ndarray | None) -> tuple[np.ndarray, list[np.ndarray]]:
        """(starting values, what may move: first only what was left open, then what is reluctant, given, elastic)."""
        start = np.zeros(len(self.names)) if guess is None else guess
        value = np.array([given.values.get(name, start[k]) for k, name in enumerate(self.names)])
        free = np.array([name not in given.fixed for name in self.names], dtype=bool)
        rigid, willing = ~self.among(self.elastic), ~self.among(self.reluctant)
        is_open = np.array([name not in given.values for name in self.names], dtype=bool) & rigid
        return value, [is_open & willing & free, is_open & free, rigid & free, free]

    def among(self, columns: Collection[int]) -> np.ndarray:
        """(n,) which coordinates are among these columns."""
        return np.array([k in columns for k in range(len(self.names))], dtype=bool)


def consistent_state(task: Assembly) -> ConsistentState:
    """The state of all coordinates next to what was given.

    Raises InitialStateError if no state within reach satisfies the constraints.
    """
    if task.sequences:
        return _by_angles(task)
    names, owners, position = task.names, task.owners, task.position
    given, stages = task.stages(task.coordinates, task.guess)
    free = stages[-1]
    stages.insert(0, stages[0] & task.among(task.origins))
    not_given = task.among(task.reluctant - {k for k, name in enumerate(names) if name in task.coordinates.values})
    q = None
    rows = np.array(task.first, dtype=int)
    for start in _starts(given, not_given):
        if len(rows):
            start = _nearest(start, stages[1], lambda q: tuple(part[rows] for part in position(q)))
        moving, q = _first_closed(start, stages, position)
        if q is not None:
            break
    if q is None:
        _refuse(*position(_nearest(given, free, position)), free, owners, names, "position")
    v0, stages = task.stages(task.rates, None)
    free = stages[-1]
    C_q, nu = task.velocity(q)
    cheap = task.among(task.following)
    v = next((v for mask in stages if (v := _velocities(v0, mask, cheap, C_q, nu)) is not None), None)
    if v is None:
        nearest = v0 + _least_change(C_q, nu - C_q @ v0, free)
        _refuse(nu - C_q @ nearest, C_q, free, owners, names, "velocity")
    changed = {
        name: (float(given[k]), float(q[k]))
        for k, name in enumerate(names)
        if (name in task.coordinates.values or k in task.elastic) and q[k] != given[k]
    }
    changed |= {
        f"{name}_dot": (task.rates.values[name], float(v[k]))
        for k, name in enumerate(names)
        if name in task.rates.values and v[k] != task.rates.values[name]
    }
    unasked = frozenset(name for name in changed if name in names and name not in task.coordinates.values)
    return ConsistentState(q, v, changed, start, _other_branch(start, q, moving, position), not_given=unasked)


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
    if np.abs(q - start).max(initial=0.0) <= ONE_PLACE:
        return None
    slope = position(q)[1][:, moving]
    if np.array_equal(slope, position(start)[1][:, moving]) or not _is_isolated(slope):  # a plane has one side
        return None
    found = _positions(2 * start - q, moving, position)
    if found is None or np.abs(less_turns(found - q)).max() <= ONE_PLACE:
        return None
    return (
        found if np.linalg.norm(less_turns(found - start)) <= AS_NEAR * np.linalg.norm(less_turns(q - start)) else None
    )


def _is_isolated(slope: np.ndarray) -> bool:
    """Do the constraints leave nothing open of what moves (columns)?"""
    return bool(np.linalg.matrix_rank(slope, tol=ONE_PLACE) == slope.shape[1])


def less_turns(change: np.ndarray) -> np.ndarray:
    """Changes of angles less whole turns (and so of lengths, which are small here, or not asked about)."""
    return np.asarray((change + np.pi) % (2 * np.pi) - np.pi)


def _starts(q0: np.ndarray, not_given: np.ndarray) -> Iterator[np.ndarray]:
    """q0, then starts with the open coordinates of joints turned a little: a straight chain knows no way to bend."""
    yield q0
    rng = np.random.default_rng(0)
    for _ in range(OTHER_STARTS if not_given.any() else 0):
        yield q0 + np.where(not_given, rng.uniform(-TURN_OPEN, TURN_OPEN, len(q0)), 0.0)


def _positions(q0: np.ndarray, free: np.ndarray, position: Residual) -> np.ndarray | None:
    """Gauss-Newton on C(q) = 0 moving the free coordinates only; None if it does not get there."""
    q = _nearest(q0, free, position)
    return q if _solves(q, position) else None


def _nearest(q0: np.ndarray, free: np.ndarray, position: Residual) -> np.ndarray:
    q, best, best_error = q0.copy(), q0.copy(), np.inf
    for _ in range(MAX_ASSEMBLY_ITERATIONS):
        C, C_q = position(q)
        if not (np.all(np.isfinite(C)) and np.all(np.isfinite(C_q))):
            raise InitialStateError("the constraints are not finite at the initial state; check motions and parameters")
        error = float(np.abs(C).max(initial=0.0))
        if error < best_error:
            best, best_error = q, error
        if error <= CLOSURE_ROUNDING * _scale(q):
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
    left = nu - C_q @ v
    if np.abs(left).max(initial=0.0) > CLOSURE_ROUNDING * _scale(v):
        v = v + _least_change(C_q, left, free)
    residual = float(np.abs(nu - C_q @ v).max(initial=0.0))
    return v if residual <= VELOCITY_TOLERANCE * _scale(v) else None


def _least_dear_change(C_q: np.ndarray, side: np.ndarray, free: np.ndarray, cheap: np.ndarray) -> np.ndarray:
    """A step with C_q step = side whose part without the cheap coordinates is smallest; they follow from it."""
    if not side.any() or not (cheap & free).any():
        return _least_change(C_q, side, free)
    Q, R = np.linalg.qr(C_q[:, cheap & free])
    rank_deficient = np.abs(np.diag(R)).min() <= 1e-10 * np.abs(R).max()
    if rank_deficient:  # a placed body whose own rows do not give all of it: treat all alike
        return _least_change(C_q, side, free)
    beyond = C_q - Q @ (Q.T @ C_q)  # what they cannot satisfy; nothing at all where only rounding is left
    beyond[np.abs(beyond) < JACOBIAN_ROUNDING * np.abs(C_q).max()] = 0.0
    step = _least_change(beyond, side - Q @ (Q.T @ side), free & ~cheap)
    return np.asarray(step + _least_change(C_q, side - C_q @ step, free & cheap))


def _least_change(C_q: np.ndarray, side: np.ndarray, free: np.ndarray) -> np.ndarray:
    """Smallest step with C_q step = side on the free coordinates (least squares if there is none)."""
    step = np.zeros(C_q.shape[1])
    if side.any() and free.any():
        found = _least_change_sparse(C_q[:, free], side) if min(C_q.shape) > MANY_ROWS else None
        if found is None:
            with one_thread(len(free)):
                found = np.linalg.lstsq(C_q[:, free], side, rcond=1e-13)[0]
        step[free] = found
    return step


def _least_change_sparse(A: np.ndarray, side: np.ndarray) -> np.ndarray | None:
    """A^T (A A^T)^-1 side, refined once, for rows that hardly touch each other; None where that is no solution.

    Rows that depend on each other leave it to the dense least squares: the square of their condition shows in what is
    left of the side.
    """
    from scipy.sparse import csc_array  # takes long to load, and few mechanisms are so large
    from scipy.sparse.linalg import splu

    rows = csc_array(A)
    if rows.nnz > MOSTLY_ZERO * A.size:
        return None
    try:
        factors = splu(csc_array(rows @ rows.T))
    except RuntimeError:  # exactly singular
        return None
    step = np.asarray(rows.T @ factors.solve(side))
    step += rows.T @ factors.solve(side - rows @ step)
    left = float(np.abs(side - rows @ step).max())
    solved = np.isfinite(step).all() and left <= SPARSE_ROUNDING * float(np.abs(side).max())
    return step if solved else None


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


# Consistent starts that are given by Euler angles: `consistent_state` with these in place of Euler parameters.
#
# What was given or fixed of the angles stays as any other coordinate does, one by one; what comes back has Euler
# parameters.


@dataclass(frozen=True)
class AngleForm:
    """names: all coordinates; sequences: by body, of those whose angles stand for e0 ... e3."""

    names: list[str]
    sequences: Mapping[str, str]

    @cached_property
    def parameters(self) -> dict[str, list[int]]:
        """Columns of the Euler parameters, by body."""
        return {body: [self.names.index(f"{body}.e{k}") for k in range(4)] for body in self.sequences}

    @cached_property
    def plain(self) -> list[int]:
        """Columns that are the same in both."""
        turning = {column for columns in self.parameters.values() for column in columns}
        return [column for column in range(len(self.names)) if column not in turning]

    @cached_property
    def own(self) -> list[str]:
        """Names here: what is the same, then the angles."""
        turning = [name for body in self.sequences for name in angle_names(body)]
        return [*(self.names[column] for column in self.plain), *turning]

    def columns(self, body: str) -> list[int]:
        """Of a body's angles here."""
        return [self.own.index(name) for name in angle_names(body)]

    def chosen(self, columns: frozenset[int]) -> frozenset[int]:
        """Columns here of those of all coordinates; of a body's angles if its parameters are among them."""
        found = {k for k, column in enumerate(self.plain) if column in columns}
        for body, own in self.parameters.items():
            found |= set(self.columns(body)) if columns & set(own) else set()
        return frozenset(found)

    def of_coordinates(self, q: np.ndarray) -> np.ndarray:
        """Coordinates here of all coordinates (n,)."""
        turning = [angles(kind, q[self.parameters[body]]) for body, kind in self.sequences.items()]
        return np.concatenate([q[self.plain], *turning])

    def of_rates(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """Rates here of all coordinates and rates (n,)."""
        turning = []
        for body, kind in self.sequences.items():
            e = q[self.parameters[body]]
            turning.append(angle_rates(kind, angles(kind, e), angular_velocity(e, q_dot[self.parameters[body]])))
        return np.concatenate([q_dot[self.plain], *turning])

    def whole(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(all coordinates (n,), their slopes (n x n')) at x (n',)."""
        q, slope = np.zeros(len(self.names)), np.zeros((len(self.names), len(x)))
        q[self.plain] = x[: len(self.plain)]
        slope[self.plain, range(len(self.plain))] = 1.0
        for body, kind in self.sequences.items():
            own, columns = self.parameters[body], self.columns(body)
            q[own] = quaternion(kind, x[columns])
            slope[np.ix_(own, columns)] = parameter_slopes(kind, x[columns])
        return q, slope

    def fitting(self, x: np.ndarray, position: Residual) -> tuple[np.ndarray, np.ndarray]:
        """`whole`; of e and -e, which are one orientation, what fits better to the joints that place the body."""
        q, slope = self.whole(x)
        off = float(np.abs(position(q)[0]).max(initial=0.0))
        for own in self.parameters.values():
            other = q.copy()
            other[own] *= -1.0
            found = float(np.abs(position(other)[0]).max(initial=0.0))
            if found < off:
                q, off = other, found
                slope[own] *= -1.0
        return q, slope


def _by_angles(task: Assembly) -> ConsistentState:
    """`consistent_state` where angles of bodies are given; columns are those of all coordinates."""
    form, position = AngleForm(task.names, task.sequences), task.position

    def position_by(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, slope = form.fitting(x, position)
        C, C_q = position(q)
        return C, C_q @ slope

    def velocity_by(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, slope = form.fitting(x, position)
        C_q, nu = task.velocity(q)
        return C_q @ slope, nu

    assert task.guess is not None
    columns: dict[str, Any] = {
        name: form.chosen(getattr(task, name)) for name in ("elastic", "reluctant", "following", "origins")
    }
    own = replace(task, names=form.own, position=position_by, velocity=velocity_by, sequences={}, **columns)
    found = consistent_state(replace(own, guess=form.of_coordinates(task.guess)))
    q, slope = form.fitting(found.q, position)
    placed, other = (None if x is None else form.whole(x)[0] for x in (found.placed, found.other))
    return replace(found, q=q, q_dot=slope @ found.q_dot, placed=placed, other=other)


def angle_bodies(names: Mapping[str, object], sequences: Mapping[str, str]) -> dict[str, str]:
    """Those of the sequences (by body) whose angles are among the names."""
    return {body: kind for body, kind in sequences.items() if not names.keys().isdisjoint(angle_names(body))}


# What assembly did to coordinates that nobody gave: told where it moved them far, or might have gone elsewhere.

ASSEMBLED: EventKind = "assembled"
QUARTER = np.pi / 2
SHOWN_COORDINATES = 4  # coordinates that a text names


def with_words(state: ConsistentState, coordinates: Sequence[Coordinate], given: Collection[str]) -> ConsistentState:
    """The state with `reported` of what assembly did; given: names of coordinates that were."""
    reported: list[str] = []
    if state.placed is not None:
        origins = [k for k, one in enumerate(coordinates) if one.kind == "position"]
        extent = float(np.ptp(state.q[origins])) if origins else 0.0
        far = [k for k in _left_open(coordinates, given) if _is_far(coordinates, k, state.placed, state.q, extent)]
        moves = [f"{coordinates[k].name} {state.placed[k]:.4g} -> {state.q[k]:.4g}" for k in far]
        if moves:
            reported.append(
                f"closing the loops moved far what was not given: {_shown(moves)}. Give them to choose the branch"
            )
    if state.other is not None:
        other = state.other
        apart = [k for k in _left_open(coordinates, given) if abs(less_turns(other[k] - state.q[k])) > ONE_PLACE]
        places = [f"{coordinates[k].name} = {other[k]:.4g}, not {state.q[k]:.4g}" for k in apart]
        if places:
            reported.append(f"another branch lies about as near: {_shown(places)}. Give one of them to choose it")
    return replace(state, reported=(*state.reported, *((ASSEMBLED, text) for text in reported)))


# What assembly did to what somebody gave: told where it is more than the digits that were given.

LEAST_CHANGE = 1e-9  # of a value, and m, rad or their rates: less is what assemblies round
ROUNDED_DIGITS = 1e-3  # of a value: no more is laid to digits that were left out


def start_events(state: ConsistentState, t0: float) -> list[Event]:
    """What a run tells of its start at t0 [s]: what may not be what was meant."""
    found = [Event(t0, kind, text) for kind, text in state.reported]
    for name, (given, used) in state.changed.items():
        if name not in state.not_given and not rounds_to(given, used):
            text = f"{name} was given as {given:.9g} and begins at {used:.9g}, where joints and stops allow it"
            found.append(Event(t0, "start_changed", text, name))
    return found


def rounds_to(given: float, used: float) -> bool:
    """Is a value the given one but for digits that were left out there?"""
    change, exponent = abs(used - given), Decimal(repr(float(given))).normalize().as_tuple().exponent
    digits = 0.5 * 10.0**exponent if isinstance(exponent, int) else 0.0
    return change <= max(LEAST_CHANGE * max(1.0, abs(given)), min(digits, ROUNDED_DIGITS * abs(given)))


def _left_open(coordinates: Sequence[Coordinate], given: Collection[str]) -> list[int]:
    """Angles first, which say more than places."""
    columns = [k for k, one in enumerate(coordinates) if one.name not in given and one.kind not in ("modal", "state")]
    return sorted(columns, key=lambda k: not coordinates[k].turns)


def _is_far(coordinates: Sequence[Coordinate], k: int, placed: np.ndarray, q: np.ndarray, extent: float) -> bool:
    """More than a quarter turn, or than the extent [m] of the mechanism?"""
    if coordinates[k].kind == "angle":
        return abs(float(q[k] - placed[k])) > QUARTER
    if coordinates[k].kind == "euler_parameter":
        own = [
            j for j, one in enumerate(coordinates) if (one.owner, one.kind) == (coordinates[k].owner, "euler_parameter")
        ]
        return k == own[0] and abs(float(q[own] @ placed[own])) < np.cos(QUARTER / 2)
    return 0 < extent < abs(float(q[k] - placed[k]))


def _shown(parts: list[str]) -> str:
    return ", ".join(parts[:SHOWN_COORDINATES]) + (", ..." if len(parts) > SHOWN_COORDINATES else "")
