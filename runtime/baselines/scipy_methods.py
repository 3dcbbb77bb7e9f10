"""SciPy's adaptive integrators on the condensed equations."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import TO_ROUNDING, CondensedOde, observed_solution, start_of
from runtime.contract.coordinates import whole
from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.engine.rows import evaluator
from runtime.schemes.switching.impulse import impulse_at, moves_in_time
from runtime.schemes.switching.times import switching_times
from runtime.solutions.solution import Solution

# ---- Adaptive integrators go from jump to jump: none of their steps searches for what is known; impulses are
# given.

Slope = Callable[[float, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Piece:
    """A stretch of time [s] without jumps inside; first and last: clocks that show the sides of its ends."""

    start: float
    end: float
    first: float
    last: float

    def within(self, slope: Slope) -> Slope:
        """A function of (t, y) that sees no further than the ends."""
        return lambda t, y: slope(min(max(t, self.first), self.last), y)


def pieces_of(model: EmittedModel, c: np.ndarray, t_end: float) -> list[Piece]:
    """From 0 to t_end."""
    inside = [one for one in switching_times(model, c, 0.0, t_end) if 0 < one.time < t_end]
    if not inside:
        return [Piece(0.0, t_end, 0.0, t_end)]
    starts = [(0.0, 0.0), *((one.time, one.after) for one in inside)]
    ends = [*((one.time, one.before) for one in inside), (t_end, t_end)]
    return [Piece(a[0], b[0], a[1], b[1]) for a, b in zip(starts, ends, strict=True)]


class Impulses:
    """What prescribed motions do to y = [q_i, q_i_dot, loop unknowns] between two pieces."""

    def __init__(self, model: EmittedModel, c: np.ndarray) -> None:
        self.model, self.c = model, c
        self._observe: Any = CondensedOde(model, TO_ROUNDING).observe() if moves_in_time(model) else None

    def across(self, y: np.ndarray, before: float, after: float) -> np.ndarray:
        """y just after."""
        if self._observe is None:
            return y
        model, observed = self.model, self._observe(t=before, y=y, c=self.c)
        parts = {name: np.asarray(value).ravel() for name, value in observed.items()}
        q = whole(model, parts["q_i"], parts["q_d"])
        found = impulse_at(model, self.c, q, parts["q_i_dot"], before, after)
        if found is None:
            return y
        n = len(model.q_i)
        return np.concatenate([y[:n], y[n : 2 * n] + found[0], y[2 * n :]])


EXPLICIT_SCIPY = ("RK23", "RK45", "DOP853")
IMPLICIT_SCIPY = ("Radau", "BDF", "LSODA")
MOST_SLOPE_EVALUATIONS = 5_000_000  # minutes of work: at a singular position steps would shrink for ever


def reference_solution(
    model: EmittedModel,
    method: str = "DOP853",
    *,
    t_end: float,
    times: np.ndarray | None = None,
    rtol: float = 1e-11,
    atol: float = 1e-13,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> Solution:
    """Integrate the condensed equations tightly by SciPy, to judge schemes by; loops are closed to rounding.

    Parameters
    ----------
    model : Model
        The mechanism.
    method : str
        DOP853, RK45, RK23, or with the exact Jacobian Radau, BDF or LSODA.
    t_end : float
        End of the motion, which begins at 0 [s].
    times : (N,) array, optional
        Where to report [s]; the end only by default.
    rtol, atol : float
        Tolerances of a step [1; m, rad].
    parameters, initial, start : optional
        As of `simulate`.

    Returns
    -------
    Solution
        The motion at these times.

    Raises
    ------
    ArgumentError
        For an unknown method.
    ModelError, InitialStateError
        For parameters and a start that cannot be used.
    NoResult
        After too many evaluations.

    References
    ----------
    E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer, 1993.
    E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer, 1996.
    """
    if method not in EXPLICIT_SCIPY + IMPLICIT_SCIPY:
        raise ArgumentError(f"method must be one of {', '.join(EXPLICIT_SCIPY + IMPLICIT_SCIPY)}, not {method!r}")
    given = start_of(model, parameters, initial, start)
    ode = CondensedOde(model, TO_ROUNDING)
    slope, size = evaluator(ode.right_hand_side(), given.c, compiled=False), len(given.y)
    more: dict[str, Any] = {}
    if method in IMPLICIT_SCIPY:
        jacobian = evaluator(ode.jacobian(), given.c, compiled=False)
        more["jac"] = lambda t, y: jacobian(t, y).reshape(size, size).T.copy()
    t = np.array([t_end]) if times is None else np.asarray(times, dtype=float)
    started = time.perf_counter()
    settings = {"method": method, "rtol": rtol, "atol": atol}
    results = in_pieces(model, given.c, counted(slope, method), given.y, t_end, t, **settings, **more)
    wall, last = time.perf_counter() - started, results[-1]
    reached, states = (np.concatenate([getattr(one, name) for one in results], axis=-1) for name in ("t", "y"))
    status = Status("completed", t_end)
    if not last.success:
        late = float(reached[-1]) if len(reached) else 0.0
        status = Status("integrator_refused", late, None, str(last.message), "Loosen the tolerances.")
    stats: dict[str, float | int | str] = {
        "evaluations": sum(int(one.nfev) for one in results),
        "wall_seconds": wall,
        "rtol": rtol,
        "atol": atol,
    }
    return observed_solution(model, given, reached, states.T, method, stats, status)


def in_pieces(
    model: EmittedModel,
    c: np.ndarray,
    slope: Slope,
    y: np.ndarray,
    t_end: float,
    times: np.ndarray | None,
    **settings: Any,
) -> list[Any]:
    """Results of solve_ivp from 0, one a piece between jumps, until one fails; times: where to report (None: all)."""
    from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

    pieces = pieces_of(model, c, t_end)
    if len(pieces) == 1:
        return [solve_ivp(slope, (0.0, t_end), y, t_eval=times, **settings)]
    impulses, results = Impulses(model, c), list[Any]()
    for piece, after in zip(pieces, [*pieces[1:], None], strict=True):
        own = times
        if times is not None:
            own = times[(times >= piece.start) & ((times < piece.end) | (after is None))]
            own = own if after is None else np.append(own, piece.end)
        found = solve_ivp(piece.within(slope), (piece.start, piece.end), y, t_eval=own, **settings)
        found.y = np.reshape(found.y, (len(y), -1))  # of a piece in which no time is asked for it is empty
        results.append(found)
        if not found.success or after is None:
            break
        y = impulses.across(found.y[:, -1], piece.last, after.first)
        if times is not None:
            found.t, found.y = found.t[:-1], found.y[:, :-1]
    return results


def counted(slope: Slope, method: str) -> Slope:
    """The slope as a fresh array, up to MOST_SLOPE_EVALUATIONS times. Raises NoResult."""
    done = 0

    def evaluated(t: float, y: np.ndarray) -> np.ndarray:
        nonlocal done
        done += 1
        if done > MOST_SLOPE_EVALUATIONS:
            raise NoResult(
                f"{method} needs more than {MOST_SLOPE_EVALUATIONS:.0e} evaluations to get beyond t = {t:.9g} s: "
                "its steps shrink, as near a singular position of q_i or of Euler angles"
            )
        return slope(t, y).copy()

    return evaluated
