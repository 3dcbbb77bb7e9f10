"""A run that was made to be compared: its true error by the reference, what it says of it, CPU time, evaluations."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from math import nan

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import EmittedModel
from runtime.running.outcome import statistics
from runtime.running.step_refinement import RefinementLevel
from runtime.solutions.solution import Solution
from runtime.studies.advice.reference import Reference

TIMED_REPEATS = (5, 100)  # at least, at most
ENOUGH_SECONDS = 0.03  # s: repeats last this long together; a single run that does is timed once
TIME_QUANTILE = (
    0.25  # quantile of the repeats that counts: where others run, a clock of CPU time may miss most of a call
)
FAILED_ERROR = 1.0  # relative error from which a run counts as failed


@dataclass(frozen=True)
class Trial:
    """setting: the step dt [s]; seconds: of CPU.

    error, end_error: of the worst graded coordinate, over the motion and at its end; errors: of each, by name.
    estimated: what the refinement says of the error. failure: how it ended, if not well.
    """

    label: str
    setting: float
    steps: int
    seconds: float
    evaluations: int
    error: float
    end_error: float = nan
    errors: dict[str, float] = field(default_factory=dict)
    estimated: float = nan
    failure: str = ""


def trial_of(label: str, level: RefinementLevel, reference: Reference) -> Trial:
    """A level of a refinement, timed again without what surrounds its steps."""
    run = level.run
    first = run.record.segments[0]
    dt, counted = first.plan.grid.dt_L, statistics(run.segment, run.z, 0.0, 0.0)
    made = int(counted["steps"]), seconds_of(level), int(counted["evaluations"])
    if level.lost:
        return Trial(label, dt, *made, np.inf, np.inf, failure=level.status.cause or level.status.name)
    samples = run.sampled_solution()
    at = first.plan.t0 + level.reached * dt  # samples alone, evenly spaced, may be in phase with a vibration
    q = np.concatenate([level.compared[0], compared_motion(reference.problem.model, samples)])
    error = reference.error(np.concatenate([at, samples.t]), q)
    if not reference.worst(error) < FAILED_ERROR:
        return Trial(label, dt, *made, np.inf, np.inf, failure="error above the motion itself")
    errors = {name: error.relative[name] for name in reference.graded}
    ends = reference.at_end(error)
    return Trial(label, dt, *made, reference.worst(error), ends, errors, level.estimated.largest)


def compared_motion(model: EmittedModel, samples: Solution) -> np.ndarray:
    """(N, n_told) what tells the motion, of samples."""
    return samples.q[:, followed(model)[1]]


def seconds_of(level: RefinementLevel) -> float:
    """CPU time of the steps of a level alone, in one call [s]; of one that passes singular positions, of the run."""
    run, first = level.run, level.run.record.segments[0]
    if len(run.record.segments) > 1 or run.schedule is not None or level.lost or level.seconds > ENOUGH_SECONDS:
        return level.seconds
    first.stepper.finish()
    z0, times = first.start(run.problem.state.q, run.problem.state.q_dot), list[float]()
    while len(times) < TIMED_REPEATS[0] or (len(times) < TIMED_REPEATS[1] and sum(times) <= ENOUGH_SECONDS):
        z = z0.copy()
        began = time.process_time()
        first.advance(z, level.steps)
        times.append(time.process_time() - began)
    return float(np.quantile(times, TIME_QUANTILE))
