"""The error of a run that its estimate condemns, measured: the whole motion is stepped again, and more finely.

Errors of windows are taken to add up, and those that are carried on to be small. Where errors of steps go to and fro,
as with forces much faster than the motion, or a stiff vibration rings at the edge of stability, the sum is far more
than the motion is off. So before a run is called inaccurate, or told to be off by ten times what trials expect, all of
it is compared with a finer one. That costs four to seven times the run, and only these pay it.
"""

from __future__ import annotations

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import followed
from runtime.contract.model import ModelError
from runtime.running.accuracy import Accuracy
from runtime.running.neighbour import seen_state
from runtime.running.passing_trials import PassingTrials
from runtime.running.run import Run
from runtime.running.segment import Segment
from runtime.running.singular.carry import RANGES
from runtime.running.time_functions import all_stops, missed_by_finer
from runtime.running.tried_motion import OPERATIONS, SEEN, TrialRuns
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.switching.broken_steps import BrokenSteps
from runtime.schemes.switching.times import SwitchTime

SHORTER = ((1 + 5**0.5) / 2) ** 3  # steps of one length over those of the finer motion: no common period with a force
PARTS = 4  # of a step on the grid, of the finer motion
FINEST = 8  # where a load acts between the steps, which then also end within short pulses
FINER = 64.0  # tolerance of the run over that of the finer motion
AS_BEGUN = ("h_next", "per_step", "steady", "ranging", *RANGES)  # what trials have told at the start
DOUBTED = 10.0  # times what trials expect, where that is more than was asked: such an estimate is not believed at once
MISSED = 3.0  # times what was asked and expected: the tolerance was not kept


def doubted(run: Run, accuracy: Accuracy) -> bool:
    """Does the estimate of a run that has come to its end say far more than the trials that were made before it, or
    did a load act between its steps?
    """
    if misses_load(run):
        return bool(accuracy.errors)
    if "expected_error" not in run.told or not accuracy.errors:
        return False
    relative = accuracy.relative(run.segment.model)[0]
    asked = float(run.segment.plan.scheme.options.tolerance)  # type: ignore[attr-defined]
    expected, error = float(run.told["expected_error"]), max(relative.values())
    return error > max(DOUBTED * expected, asked) or error > MISSED * max(expected, asked)


def misses_load(run: Run) -> bool:
    """Is it known that a load acts between the steps?"""
    return any(event.kind == "load_missed" for event in run.events)


def finer_misses_load(run: Run, state: ConsistentState) -> bool:
    """Would the finer motion that `measured_errors` makes of such a run from a state on not show that load either?"""
    first = run.record.segments[0]
    stops = _stops(run, first, state)
    return missed_by_finer(first.model, first.c, state, first.plan, FINEST, stops)


def _stops(run: Run, segment: Segment, state: ConsistentState) -> list[SwitchTime]:
    """Where steps of one length of the finer motion end besides."""
    plan = segment.plan
    return all_stops(segment.model, segment.c, plan.t0, plan.t_end, state) if misses_load(run) else segment.switches


def measured_errors(run: Run, state: ConsistentState) -> dict[str, float] | None:
    """Largest error [m or rad] of each coordinate of `followed` over a run from a state on; None where it is not told.

    It is not where inputs or events change the motion on the way, or where it takes too many operations.
    """
    first = run.record.segments[0]
    if run.schedule is not None or first.watches_events:
        return None
    with np.errstate(all="ignore"):
        try:
            found = (_varying if first.plan.scheme.adaptive else _fixed)(run, first, state)
        except ModelError:
            return None
    if found is None or not np.isfinite(found).all():
        return None
    return dict(zip(followed(first.model)[0], found.tolist(), strict=True))


def _fixed(run: Run, segment: Segment, state: ConsistentState) -> np.ndarray | None:
    """(n_told,) by steps of a part of the length."""
    plan, stepper, c = segment.plan, segment.stepper, segment.c
    if len(run.record.segments) > 1 or any(event.kind == "singular_position" for event in run.events):
        return None
    parts = FINEST if misses_load(run) else PARTS
    if (1 + parts) * plan.steps * stepper.operations > OPERATIONS:
        return None
    scheme, dt, columns = plan.scheme, plan.grid.dt_L / parts, followed(segment.model)[1]
    own, finer = segment.start(state.q, state.q_dot), stepper.start(plan.t0, state.q, state.q_dot, c, dt)
    broken, ready = BrokenSteps(stepper, plan.t0, dt, _stops(run, segment, state)), stepper.ready(c, dt)
    marks = sorted({plan.steps * (k + 1) // SEEN for k in range(SEEN)} - {0})
    off = np.zeros(len(columns))
    for steps in np.diff([0, *marks]).tolist():
        segment.run(own, steps)
        broken.run(finer, ready, c, parts * steps)
        ends = seen_state(segment, own)[0], seen_state(segment, finer, scheme.constants(c, dt))[0]
        off = np.fmax(off, np.abs(ends[0] - ends[1])[columns])
        if not np.isfinite([*ends[0], *ends[1]]).all():
            return None
    return np.asarray(off * parts**scheme.order / (parts**scheme.order - 1))


def _varying(run: Run, segment: Segment, state: ConsistentState) -> np.ndarray | None:
    """(n_told,) by trials with the run's steps, and with shorter ones."""
    plan, scheme = segment.plan, segment.plan.scheme
    assert isinstance(scheme, AdaptiveSteps) and run.record.first is not None
    begun, span = run.record.first[1], plan.t_end - plan.t0
    if len(run.record.segments) > 1 or any(event.kind == "singular_position" for event in run.events):
        runs: TrialRuns = PassingTrials(segment, state, run.engine)
    else:
        start = segment.stepper.start(plan.t0, state.q, state.q_dot, segment.c, span / SEEN)
        runs = TrialRuns(segment.stepper, start, segment.c, span, segment.switches)
    for name in AS_BEGUN:
        runs.z[scheme.layout.slice(name)] = begun[scheme.layout.slice(name)]
    alike = begun[scheme.layout.slice("steady")][0] > 0
    finer = SHORTER**scheme.error_order if alike else FINER
    one, other = runs.again(1.0), runs.again(1 / finer)
    if one is None or other is None:
        return None
    times = finer ** (scheme.order / scheme.error_order)
    return np.asarray(np.abs(one.seen - other.seen).max(axis=0) * times / (times - 1))
