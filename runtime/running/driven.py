"""Mechanisms in which every coordinate is driven: positions, rates, accelerations and forces without integration.

q = f(t) (Eq. 31), q' and q'' follow (Eqs. 36, 35), and the multipliers from the rows of the dependent coordinates
(Eq. 37), motors among them. Loops are followed from instant to instant, so that their branch is kept.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from runtime.contract.arguments import BY_NAME, NUMBER, arguments
from runtime.contract.consistent_state import ConsistentState, start_events
from runtime.contract.coordinates import at_home, dependent_part, parts, whole
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event, Status
from runtime.engine.rows import evaluate
from runtime.operating.balance import Clamped
from runtime.operating.equilibrium import NoEquilibrium
from runtime.operating.functions import PointFunctions
from runtime.operating.given_state import given_position, given_state
from runtime.results.motion_error import MotionError
from runtime.running.inputs import Schedule
from runtime.running.outcome import with_limits
from runtime.running.problem import dividing_step, seen_every_of, steps_until
from runtime.running.time_functions import refuse_position_jumps
from runtime.schemes.options import SchemeError
from runtime.schemes.switching.impulse import impulse_at, impulse_text
from runtime.schemes.switching.times import switching_times
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution

SCHEME = "driven"
DRIVEN_CLOSURE_TOLERANCE = (
    1e-14  # rad or m, times the largest coordinate: correction after which the loops count as closed
)
STAGNANT_CORRECTION = 1e-11  # a correction that small, but no longer shrinking, is rounding
MOST_DRIVEN_CLOSURES = 25
MAX_BRANCH_CORRECTION = 0.2  # rad or m: a correction above this may have left the branch
DRIVEN_SAMPLES = 200  # samples where nothing is said
MOST_INSTANT_HALVINGS = 12  # of the time from one instant to the next
NO_STEPS = MotionError(reason="the drives give the motion at every instant, nothing is integrated")


def driven_solution(
    model: EmittedModel,
    p: np.ndarray,
    state: ConsistentState,
    t0: float,
    t_end: float,
    dt: float,
    schedule: Schedule,
) -> Solution:
    """The motion of a model without independent coordinates, from its state at t0 until t_end [s].

    Samples are dt apart. Where the loops cannot be followed the run ends, with status `constraints_lost`.
    Raises ModelError for a motion whose position jumps.
    """
    started = time.perf_counter()
    times = _instants(t0, t_end, dt)
    c = model.constants(p)
    refuse_position_jumps(model, c, state, switching_times(model, c, t0, t_end), t0, t_end)
    if schedule.samples:
        w = model.signals.size
        c = np.tile(c, (len(times), 1))
        c[:, -w:] = schedule.rows(times, dt, p[-w:])
    follower = _Follower(model, c)
    q_d = follower.along(times, dependent_part(model, state.q))
    lost = len(q_d) < len(times)
    times, c = times[: len(q_d)], c if c.ndim == 1 else c[: len(q_d)]
    none = np.zeros((len(times), 0))
    motion = _motion(model, times, c, none, none, q_d)
    status = Status("completed", float(times[-1])) if not lost else _lost(float(times[-1]))
    events = start_events(state, t0) + _impulses(follower, t0, float(times[-1]), dependent_part(model, state.q))
    stats: dict[str, float | int | str] = {"seconds": time.perf_counter() - started, "closures": follower.closures}
    found = assemble_solution(model, times, *motion, p, c, SCHEME, dt, [], stats, status)
    return with_limits(replace(found, events=events, error=NO_STEPS))


def _instants(t0: float, t_end: float, dt: float) -> np.ndarray:
    """(N,) dt apart from t0 on, and the end where that is nearer [s]."""
    dt = dividing_step(t0, t_end, dt)
    found = steps_until(t0, t_end, dt)
    times = t0 + dt * np.arange(found["steps"] + 1)
    if found["end"] is not None:
        times[-1] = t_end
    return times


def _motion(
    model: EmittedModel, times: np.ndarray, c: np.ndarray, q_i: np.ndarray, q_i_dot: np.ndarray, q_d: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """q, q_dot, q_ddot (N, n) where q_i has no acceleration (Eqs. 36, 35)."""
    still, q_d_dot, q_d_ddot = np.zeros_like(q_i_dot), np.zeros_like(q_d), np.zeros_like(q_d)
    values = {"q_i": q_i, "q_d": q_d, "q_i_dot": q_i_dot, "q_i_ddot": still, "t": times[:, None]}
    if model.q_d:
        q_d_dot = values["q_d_dot"] = evaluate(model.kernel("velocities"), values, c)["q_d_dot"]
        q_d_ddot = evaluate(model.kernel("accelerations"), values, c)["q_d_ddot"]
    return whole(model, q_i, q_d), whole(model, q_i_dot, q_d_dot), whole(model, still, q_d_ddot)


def _impulses(follower: _Follower, t0: float, t_end: float, q_d: np.ndarray) -> list[Event]:
    """One for each time at which the velocity of a motion jumps: the forces of its motor have no finite value there."""
    model, c = follower.model, np.atleast_2d(follower.c)[0]
    events, none = [], np.zeros(0)
    times = [one for one in switching_times(model, c, t0, t_end) if t0 < one.time < t_end]
    for one, here in zip(times, follower.along(np.array([t0, *(one.time for one in times)]), q_d)[1:], strict=False):
        impulse = impulse_at(model, c, whole(model, none, here), none, one.before, one.after)
        if impulse is not None:
            events.append(Event(one.time, "velocity_jump", impulse_text(model, impulse[1])))
    return events


def _lost(t: float) -> Status:
    return Status(
        "constraints_lost",
        t,
        cause="the loops cannot be closed further along the driven motion",
        advice="The drive asks for a position that the mechanism cannot reach, or passes a dead centre: another motion",
    )


@dataclass
class _Follower:
    model: EmittedModel
    c: np.ndarray
    closures: int = field(default=0)

    def along(self, times: np.ndarray, q_d: np.ndarray) -> np.ndarray:
        """(N, n_d) positions at the times, as far as the loops can be followed; at least at the first."""
        if not self.model.loop_unknowns:
            values = {"q_d": np.tile(q_d, (len(times), 1)), "t": times[:, None], "q_i": np.zeros((len(times), 0))}
            return evaluate(self.model.kernel("closure"), values, self.c)["q_d_next"]
        rows = np.broadcast_to(self.c, (len(times), self.c.shape[-1]))  # what is held from each instant on
        self.c = rows[0]
        c, q_d = at_home(self.model, self.c, q_d)
        found = [self._closed(q_d, float(times[0]), c)]
        if found[0] is None:
            found = [q_d]
        for before, t, self.c in zip(times, times[1:], rows, strict=False):
            following = self._next(np.asarray(found[-1]), float(before), float(t), MOST_INSTANT_HALVINGS)
            if following is None:
                break
            found.append(following)
        return np.array(found)

    def _next(self, q_d: np.ndarray, before: float, t: float, halvings: int) -> np.ndarray | None:
        """Positions at t from those before, through instants in between where the loops do not close at once."""
        c, q_d = at_home(self.model, self.c, q_d)
        values = {"q_d": q_d, "t": before, "q_i": np.zeros(0), "q_i_dot": np.zeros(0), "c": c}
        rate = np.asarray(self.model.evaluate("velocities", **values)["q_d_dot"]).ravel()
        guess = q_d + (t - before) * rate
        found = self._closed(guess, t, c) if np.isfinite(guess).all() else None
        if found is not None and np.abs(found - guess).max() <= MAX_BRANCH_CORRECTION:
            return found
        if not halvings:
            return None
        middle = self._next(q_d, before, 0.5 * (before + t), halvings - 1)
        return None if middle is None else self._next(middle, 0.5 * (before + t), t, halvings - 1)

    def _closed(self, q_d: np.ndarray, t: float, c: np.ndarray) -> np.ndarray | None:
        """Newton on the loop unknowns until the correction is rounding; None if it does not get there."""
        before = np.inf
        for _ in range(MOST_DRIVEN_CLOSURES):
            self.closures += 1
            found = self.model.evaluate("closure", q_d=q_d, t=t, q_i=np.zeros(0), c=c)
            following = np.asarray(found["q_d_next"]).ravel()
            if not np.isfinite(following).all():
                return None
            moved, scale = float(np.abs(following - q_d).max()), max(1.0, float(np.abs(following).max()))
            q_d = following
            if moved <= DRIVEN_CLOSURE_TOLERANCE * scale or (
                moved <= STAGNANT_CORRECTION * scale and moved >= 0.5 * before
            ):
                return q_d
            before = moved
        return None


# Driven mechanisms with flexible bodies whose elastic coordinates follow the loads without vibrating.
#
# At each instant Q_hat(q_i, 0, t) = 0 for the elastic coordinates (Eq. 38 with q_i_ddot = q_i_dot = 0): loads and
# inertia of the driven motion against stiffness. Their rates are those of the equilibrium along the motion,
# J_q q_i_dot = -dQ_hat/dt.

QUASI_STATIC = "quasi_static"


@arguments(parameters=BY_NAME, t0=NUMBER)
def quasi_static_motion(
    model: EmittedModel,
    *,
    t_end: float | None = None,
    seen_every: float | None = None,
    samples: int | None = None,
    parameters: Mapping[str, float] | None = None,
    t0: float = 0.0,
) -> Solution:
    """Follow a driven mechanism with elastic bodies that deform without vibrating.

    Parameters
    ----------
    model : Model
        A mechanism whose rigid coordinates are all driven.
    t_end : float, optional
        End of the motion [s]; the scene's by default.
    seen_every : float, optional
        Time between stored samples [s].
    samples : int, optional
        Number of stored samples besides the first, in place of `seen_every`; 200 by default.
    parameters : mapping of str to float, optional
        Parameters that are not as the scene has them, in SI units.
    t0 : float, optional
        Start of the motion [s].

    Returns
    -------
    Solution
        The motion, elastic accelerations being zero.

    Raises
    ------
    ModelError
        For free rigid coordinates, and for drives that jump.
    SchemeError
        For times that cannot be used.
    NoEquilibrium
        With the time at which there is none.
    """
    free = [name for name in model.q_i if name not in model.elastic]
    if free:
        raise ModelError(f"model {model.name} moves freely in {', '.join(free)}: drive it, or simulate")
    end = float(model.simulation["t_end"] if t_end is None else t_end)
    asked = seen_every_of(seen_every, samples, t0, end)
    step = asked or float(model.simulation.get("seen_every", (end - t0) / DRIVEN_SAMPLES))
    if not (np.isfinite([t0, end, step]).all() and step > 0 and end > t0):
        raise SchemeError("t_end", "is not after t0", "take t_end > t0")
    times = _instants(t0, end, step)
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    if switches := switching_times(model, c, t0, end):
        refuse_position_jumps(model, c, given_state(model, p, c, t0, None), switches, t0, end)
    q, q_i_dot = _followed(model, PointFunctions(model, c), times, *given_position(model, p, c, t0, {}))
    q_i, q_d = parts(model, q)
    motion, status = _motion(model, times, c, q_i, q_i_dot, q_d), Status("completed", float(times[-1]))
    found = assemble_solution(model, times, *motion, p, c, QUASI_STATIC, step, [], {}, status)
    return with_limits(replace(found, error=NO_STEPS))


def _followed(
    model: EmittedModel, functions: PointFunctions, times: np.ndarray, q_i: np.ndarray, loop: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(q (N, n), q_i_dot (N, n_i)) of the equilibria, each reached from the one before."""
    task = Clamped(model, functions, float(times[0]), np.zeros(len(q_i)), [], np.zeros(0), loop)
    places, rates = [], []
    for t in times:
        task = replace(task, t=float(t))
        found = task.solve(q_i)
        at = task.values(found.x) if found.converged else None
        if at is None:
            raise NoEquilibrium(f"model {model.name} has no quasi-static equilibrium in reach at t = {t:.9g} s", {})
        q_i = found.x
        places.append(at.q)
        rates.append(np.linalg.lstsq(at.J_q, -at.Q_t, rcond=1e-12)[0])
    return np.array(places), np.array(rates)
