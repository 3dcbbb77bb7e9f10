"""Loads and prescribed motions as functions of time alone: do the steps of a run see what they do?

Everything but t is held as it is at the start of the run, and once more turned a little and with rates, as a load may
be nothing at the start by the motion alone: a brake of a mechanism at rest. Where a load jumps or kinks steps end, so
that nothing is missed there. Of the others each of the shortest steps is looked into at a few points: a load whose
impulse the ends of the steps do not show is named, and so is one that has no finite value. A prescribed motion whose
velocity jumps at a known time has an impulse; one whose position jumps is refused, and so is a jump of velocity that no
condition tells of.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import parts, rate_parts
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event
from runtime.engine.rows import ManyPoints
from runtime.running.problem import Plan
from runtime.schemes.stage_equations import is_long_tree
from runtime.schemes.switching.times import CONDITION_ROUNDING, SwitchTime, has_switching_times, switching_times

POINTS_OF_STEP = 8  # points a step, where there are not too many steps
MOST_LOAD_POINTS = 200_000
MISSED, DRIFT = 0.02, 0.1  # of the whole impulse of a load: in a step, and summed up
JUMP = 1e-6  # of the largest position or velocity of the prescribed motions
RANGE_SAMPLES, STILL_RANGE = 200, 1e-12  # looks at the range of a motion; m or rad, and their rates
CANDIDATES, TIME_HALVINGS = 8, 60
RANGE_PLACES, RANGE_RATES = (0.2, 0.4), (1.0, 1.5)  # rad or m, and their rates, from the first coordinate to the last
LARGEST_LOAD = 1e290  # N or N m: its work overflows


def check_time_functions(
    model: EmittedModel, c: np.ndarray, plan: Plan, state: ConsistentState, switches: Sequence[SwitchTime] | None = None
) -> list[Event]:
    """What steps of the plan miss, in events. Raises ModelError for a prescribed motion that jumps.

    switches: where steps end; None where they do not. Then a jump of velocity is refused, too.
    """
    if not depends_on_time(model):
        return []
    known = switching_times(model, c, plan.t0, plan.t_end) if switches is None else switches
    refuse_position_jumps(model, c, state, known, plan.t0, plan.t_end)
    steps = plan.steps * prod(plan.grid.m)
    points = min(POINTS_OF_STEP, MOST_LOAD_POINTS // steps)
    if points < 2:
        return []
    times = np.linspace(plan.t0, plan.t_end, steps * points + 1)
    ends = [one.time for one in switches or ()]
    _refuse_jumps(model, c, state, times, [one.time for one in switches or () if one.owners])  # not within pulses
    numbers = {int((end - plan.t0) / plan.grid.dt_L * (1 - 1e-9)) for end in ends}
    broken = np.zeros(plan.steps, bool)
    broken[[number for number in numbers if 0 <= number < plan.steps]] = True
    sub_steps = np.repeat(broken, prod(plan.grid.m))
    found = _missed_loads(model, c, state, times, points, sub_steps)
    varying = plan.scheme.adaptive  # whose steps end within short pulses, see `all_stops`
    return [event for event in found if not varying or event.kind != "load_missed"]


def refuse_position_jumps(
    model: EmittedModel, c: np.ndarray, state: ConsistentState, switches: Sequence[SwitchTime], t0: float, t_end: float
) -> None:
    """Raises ModelError for a prescribed motion whose position jumps at one of these times, by what it does else."""
    function = _of_time(model, c, state, "constraints", "C") if model.constraints and switches else None
    if function is None:
        return
    sides = np.array([[one.before, one.after] for one in switches]).ravel()
    values = function(np.concatenate([sides, np.linspace(t0, t_end, RANGE_SAMPLES)]))
    jumps = np.abs(values[:, 1 : len(sides) : 2] - values[:, 0 : len(sides) : 2])
    allowed = JUMP * np.ptp(values, axis=1) + STILL_RANGE
    row, k = divmod(int((jumps - allowed[:, None]).argmax()), len(switches))
    if jumps[row, k] > allowed[row]:
        raise ModelError(
            f"prescribed motion of {model.constraints[row]}",
            f"its position jumps by {jumps[row, k]:.4g} at t = {switches[k].time:.6g} s",
            "let it go there in a finite time; a jump of its velocity is possible, one of its position is not",
        )


def depends_on_time(model: EmittedModel) -> bool:
    """Does anything of the equations but their state, a load or a prescribed motion, change with time?"""
    names = ("constraints", "forward_dynamics" if is_long_tree(model) else "condensed")
    return has_switching_times(model) or any(model.has(one) and "t" in model.kernel(one).name_in() for one in names)


OfTime = Callable[[np.ndarray], np.ndarray]  # (n, N) at times (N,)


def _of_time(model: EmittedModel, c: np.ndarray, state: ConsistentState, name: str, output: str) -> OfTime | None:
    """An output of a kernel at the state; None if it does not depend on t."""
    if not model.has(name) or "t" not in model.kernel(name).name_in():
        return None
    numbers = (name, output, c.tobytes(), state.q.tobytes(), state.q_dot.tobytes())
    return model.of_numbers("of time", numbers, lambda: _with_time_left(model, c, state, name, output))


def _with_time_left(
    model: EmittedModel, c: np.ndarray, state: ConsistentState, name: str, output: str
) -> OfTime | None:
    t = ca.SX.sym("t")
    (q_i, q_d), (q_i_dot, q_d_dot) = parts(model, state.q), rate_parts(model, state.q, state.q_dot)
    values = {
        "q": state.q,
        "q_dot": state.q_dot,
        "q_i": q_i,
        "q_d": q_d,
        "q_i_dot": q_i_dot,
        "q_d_dot": q_d_dot,
        "c": c,
    }
    found = ca.densify(model.evaluate(name, **{key: ca.SX(ca.DM(one)) for key, one in values.items()}, t=t)[output])
    if not ca.depends_on(found, t):
        return None
    points = ManyPoints(ca.Function("of_time", [t], [found]))
    return lambda times: points(times[:, None]).T


def force_of_time(model: EmittedModel, c: np.ndarray, state: ConsistentState) -> OfTime | None:
    """Q_hat (n_i, N) at the state; None if it does not depend on t."""
    if is_long_tree(model) and "t" not in model.kernel("forward_dynamics").name_in():
        return None
    return _of_time(model, c, state, "condensed", "Q_hat")


def _refuse_jumps(
    model: EmittedModel, c: np.ndarray, state: ConsistentState, times: np.ndarray, ends: Sequence[float]
) -> None:
    function = _of_time(model, c, state, "constraints", "C_t") if model.constraints else None
    if function is None:
        return
    velocities = function(times)
    allowed = JUMP * np.abs(velocities).max(axis=1) + STILL_RANGE
    steep = np.argsort(-np.abs(np.diff(velocities, 2)), axis=1)[:, :CANDIDATES]  # steep is no jump
    looked = [(row, k) for row, own in enumerate(steep) for k in own if not _ends_between(ends, *times[[k, k + 2]])]
    if not looked:
        return
    rows, at = np.array(looked).T
    near = np.where(at > 0, at - 1, np.minimum(at + 2, len(times) - 2))
    slopes = (velocities[rows, near + 1] - velocities[rows, near]) / (times[near + 1] - times[near])

    def levels(t: np.ndarray) -> np.ndarray:
        """(n,) of each candidate at its own time, what changes steadily taken out."""
        found: np.ndarray = function(t)[rows, np.arange(len(rows))] - slopes * t
        return found

    low, high = times[at], times[at + 2]
    below, above = levels(low), levels(high)
    for _ in range(TIME_HALVINGS):
        middle = (low + high) / 2
        if not ((low < middle) & (middle < high)).any():
            break
        between = levels(middle)
        left = np.abs(between - below) > np.abs(above - between)
        low, below = np.where(left, (low, below), (middle, between))
        high, above = np.where(left, (middle, between), (high, above))
    jumps = above - below
    beyond = np.flatnonzero(np.abs(jumps) > allowed[rows])
    if len(beyond):
        k = int(beyond[0])
        raise ModelError(
            f"prescribed motion of {model.constraints[rows[k]]}",
            f"its velocity jumps by {-jumps[k]:.4g} at t = {high[k]:.6g} s, which takes an impulse",
            "let the velocity change in a finite time, or start a new run there",
        )


def _ends_between(ends: Sequence[float], low: float, high: float) -> bool:
    return any(low <= end <= high for end in ends)


def all_stops(
    model: EmittedModel, c: np.ndarray, t0: float, t_end: float, state: ConsistentState, step: float = np.inf
) -> list[SwitchTime]:
    """Times that no step of a run should cross: jumps and kinks, and places within short pulses of loads.

    state: at the start of the run. step [s]: no longer ones are made, so that those may stay out which lie farther
    apart.
    """

    if not depends_on_time(model):
        return []

    def found() -> tuple[list[SwitchTime], list[tuple[float, float]]]:
        forces = _forces_nearby(model, c, state)
        return switching_times(model, c, t0, t_end), [] if forces is None else pulses(forces, t0, t_end)

    motion = t0, t_end, c.tobytes(), state.q.tobytes(), state.q_dot.tobytes()
    known, short = model.of_numbers("stops", motion, found)
    return sorted([*known, *pulse_times(short, t0, t_end, known, step)], key=lambda one: one.time)


def _forces_nearby(model: EmittedModel, c: np.ndarray, state: ConsistentState) -> OfTime | None:
    """Q_hat at a state, and below it at a turned one that moves; None where no load depends on t.

    What is not finite at the second is left out: nothing says that the motion comes there.
    """
    own, other = force_of_time(model, c, state), force_of_time(model, c, _moved(model, state))
    if own is None and other is None:
        return None
    n = len(model.q_i)

    def forces(times: np.ndarray) -> np.ndarray:
        """(2 n_i, N)."""
        none = np.zeros((n, len(times)))
        here = none if own is None else own(times)
        there = none if other is None else other(times).copy()
        there[~np.all(np.abs(there) < LARGEST_LOAD, axis=1)] = 0.0
        return np.vstack([here, there])

    return forces


def _moved(model: EmittedModel, state: ConsistentState) -> ConsistentState:
    """Coordinates that are not elastic by RANGE_PLACES, all rates by RANGE_RATES; loops need not close, loads do
    not ask.
    """
    entries = {entry.name: entry for entry in model.description.coordinates}
    rigid = [entries[name].unit in ("rad", "m") and not entries[name].elastic for name in model.coordinates]
    n = len(rigid)
    return ConsistentState(
        state.q + np.where(rigid, np.linspace(*RANGE_PLACES, n), 0.0), state.q_dot + np.linspace(*RANGE_RATES, n), {}
    )


def _missed_loads(
    model: EmittedModel, c: np.ndarray, state: ConsistentState, times: np.ndarray, points: int, broken: np.ndarray
) -> list[Event]:
    loads = _forces_nearby(model, c, state)
    if loads is None:
        return []
    forces = loads(times)
    bad = ~(np.abs(forces) < LARGEST_LOAD)
    if bad.any():
        k = int(bad.any(axis=0).argmax())
        text = f"the load on {model.q_i[int(bad[:, k].argmax())]} has no finite value at t = {times[k]:.6g} s"
        return [Event(float(times[k]), "load_not_finite", text)]
    names = [*model.q_i, *model.q_i]
    varying = forces - np.median(forces, axis=1)[:, None]
    h = (times[-1] - times[0]) / (len(times) - 1)
    fine = h * (varying[:, 1:] + varying[:, :-1]) / 2
    impulse = fine.reshape(len(forces), -1, points).sum(axis=2)
    ends = varying[:, ::points]
    shown = points * h * (ends[:, 1:] + ends[:, :-1]) / 2
    missed = np.where(broken, 0.0, np.abs(impulse - shown))
    share = missed.max(axis=1) / np.maximum(np.abs(fine).sum(axis=1), 1e-300)
    worst = int(share.argmax())
    total = np.abs(np.where(broken, 0.0, impulse - shown).cumsum(axis=1)).max(axis=1)
    drift = total / np.maximum(np.abs(fine).sum(axis=1), 1e-300)
    if not share[worst] > MISSED and drift.max() > DRIFT:
        worst = int(drift.argmax())
        text = f"the ends of the steps show {drift[worst]:.2g} of the impulse of the load on {names[worst]} wrong"
        return [Event(float(times[0]), "load_missed", f"{text}: it changes as often as they come; take other steps")]
    if not share[worst] > MISSED:
        return []
    time = float(times[points * int(missed[worst].argmax())])
    text = (
        f"the load on {names[worst]} acts between the steps: after t = {time:.6g} s the ends of a step miss "
        f"{share[worst]:.2g} of its impulse; take a smaller step, or let it act longer"
    )
    return [Event(time, "load_missed", text)]


# ---- loads that act for a short time: a motion that is made twice misses them twice --------------------------

SEARCH_LEVELS = ((256, 12), (64, 8), (16, 3))  # parts of a motion, and how many of them at most hold something short
LOAD_POINTS = 1 << 15  # of the motion, where loads are looked at
MISSED_IMPULSE = 0.02  # of the whole impulse of a load
BOOLE = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90
ACTS = 1e-6  # of the largest second difference: where a pulse begins and ends
SLOW = 4.0  # times the median of these differences, at least: what acts all the time
CLOSELY = 65  # looks about its peak
LOAD_PARTS = 24
NEIGHBOUR_PARTS = 8  # parts of the motion on each side


def pulses(forces: OfTime, t0: float, t_end: float) -> list[tuple[float, float]]:
    """(begin, end) [s] of what acts for a short time from t0 to t_end [s], rising."""
    times = np.linspace(t0, t_end, LOAD_POINTS + 1)
    values = forces(times)
    if not (np.abs(values) < 1e290).all():
        return []
    spans = {
        span
        for k, row in enumerate(values)
        if np.ptp(row) > 0
        for span in short_spans(row)
        if _has_height(forces, times, k, row, span)
    }
    return [(times[first], times[last]) for first, last in sorted(spans)]


def pulse_times(
    short: Sequence[tuple[float, float]], t0: float, t_end: float, known: Sequence[SwitchTime], step: float = np.inf
) -> list[SwitchTime]:
    """Times within pulses from t0 to t_end [s], rising; known: where steps end anyway; step: the longest [s]."""
    jumps = np.array([one.time for one in known])
    found: set[float] = set()
    for low, high in short:
        if high - low < LOAD_PARTS * step and not ((jumps >= low) & (jumps <= high)).any():
            found |= set(np.linspace(low, high, LOAD_PARTS + 1).tolist())
    margins = [(t, CONDITION_ROUNDING * max(abs(t), t_end - t0)) for t in sorted(found) if t0 < t < t_end]
    return [SwitchTime(t, t - margin, t + margin, ()) for t, margin in margins]


def _has_height(forces: OfTime, times: np.ndarray, k: int, row: np.ndarray, span: tuple[int, int]) -> bool:
    """Has a load k the height that its values (LOAD_POINTS + 1,) show? At a pole it has none."""
    peak = span[0] + int(np.abs(row[span[0] : span[1] + 1]).argmax())
    near = np.linspace(times[max(peak - 1, 0)], times[min(peak + 1, LOAD_POINTS)], CLOSELY)
    found = forces(near)[k]
    return bool(np.abs(found).max() < 2 * abs(row[peak]))


def short_spans(row: np.ndarray) -> list[tuple[int, int]]:
    """From and to which point of values (N + 1,) at even distances something short acts; N: a power of two."""
    points = len(row) - 1
    varying = row - np.median(row)
    whole, bends = float(np.abs(varying).sum()), np.abs(np.diff(varying, 2))
    found: list[tuple[int, int]] = []
    for count, most in SEARCH_LEVELS:
        n = points // count
        edges = varying[: count * n + 1 : n]
        inner = varying[:-1].reshape(count, n)
        sums = inner.sum(axis=1) + (edges[1:] - edges[:-1]) / 2
        boole = n * (np.column_stack([inner[:, :: n // 4], edges[1:]]) @ BOOLE)
        missed = np.flatnonzero(np.abs(sums - boole) > MISSED_IMPULSE * whole)
        if 0 < len(missed) <= most:
            parts_of = [(int(k) * n, (int(k) + 1) * n) for k in missed]
            new = [ends for ends in parts_of if not any(low < ends[1] and ends[0] < high for low, high in found)]
            found = _merged([*found, *(_within(bends, *ends) for ends in new)])
    return found


def _within(bends: np.ndarray, first: int, last: int) -> tuple[int, int]:
    """Of a part, and beyond it, where values bend; a slow load beside the pulse does not."""
    least = max(ACTS * bends[first : last - 1].max(), SLOW * float(np.median(bends)))
    still = np.flatnonzero(bends <= least)
    acts = first + np.flatnonzero(bends[first : last - 1] > least)
    if not len(acts):  # nothing bends more than all along
        return first, last
    before, after = still[still < acts[0]], still[still > acts[-1]]
    low = int(before[-1]) + 1 if len(before) else 0
    high = int(after[0]) + 1 if len(after) else len(bends) + 1
    reach = NEIGHBOUR_PARTS * (last - first)
    return max(low, first - reach), min(high, last + reach)


def _merged(spans: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Rising, those that touch as one."""
    found: list[tuple[int, int]] = []
    for low, high in sorted(spans):
        if found and low <= found[-1][1]:
            low, high = found[-1][0], max(found.pop()[1], high)
        found.append((low, high))
    return found
