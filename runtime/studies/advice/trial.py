"""A run that was made to be compared: its true error by the reference, what it says of it, CPU time, evaluations."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from math import nan

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.running.ladder import Rung
from runtime.running.outcome import statistics
from runtime.studies.advice.reference import Reference

REPEATS = (5, 100)  # at least, at most
ENOUGH = 0.03  # s: repeats last this long together; a single run that does is timed once
LOW = 0.25  # quantile of the repeats that counts: where others run, a clock of CPU time may miss most of a call
HOPELESS = 1.0  # relative error from which a run counts as failed


@dataclass(frozen=True)
class Trial:
    """setting: the step dt [s]; seconds: of CPU.

    error, end_error: of the worst graded coordinate, over the motion and at its end; errors: of each, by name. told:
    what the ladder says of the error. failure: how it ended, if not well.
    """

    label: str
    setting: float
    steps: int
    seconds: float
    evaluations: int
    error: float
    end_error: float = nan
    errors: dict[str, float] = field(default_factory=dict)
    told: float = nan
    failure: str = ""


def trial_of(label: str, rung: Rung, reference: Reference) -> Trial:
    """A rung of a ladder, timed again without what surrounds its steps."""
    run = rung.run
    first = run.record.segments[0]
    dt, counted = first.plan.grid.dt_L, statistics(run.segment, run.z, 0.0, 0.0)
    made = int(counted["steps"]), seconds_of(rung), int(counted["evaluations"])
    if rung.lost:
        return Trial(label, dt, *made, np.inf, np.inf, failure=rung.status.cause or rung.status.name)
    seen = run.seen()
    error = reference.error(seen.t, told(reference.problem.model, seen))
    if not reference.worst(error) < HOPELESS:
        return Trial(label, dt, *made, np.inf, np.inf, failure="error above the motion itself")
    errors = {name: error.relative[name] for name in reference.graded}
    ends = reference.at_end(error)
    return Trial(label, dt, *made, reference.worst(error), ends, errors, rung.told.largest)


def told(model: Model, seen: Solution) -> np.ndarray:
    """(N, n_told) what tells the motion, of samples."""
    return seen.q[:, followed(model)[1]]


def seconds_of(rung: Rung) -> float:
    """CPU time of the steps of a rung alone, in one call [s]; of one that passes singular positions, of the run."""
    run, first = rung.run, rung.run.record.segments[0]
    if len(run.record.segments) > 1 or run.schedule is not None or rung.lost or rung.seconds > ENOUGH:
        return rung.seconds
    first.stepper.finish()
    z0, times = first.start(run.problem.state.q, run.problem.state.q_dot), list[float]()
    while len(times) < REPEATS[0] or (len(times) < REPEATS[1] and sum(times) <= ENOUGH):
        z = z0.copy()
        began = time.process_time()
        first.advance(z, rung.steps)
        times.append(time.process_time() - began)
    return float(np.quantile(times, LOW))
