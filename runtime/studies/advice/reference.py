"""The independent reference that methods are compared by, DOP853 of SciPy at any time, and runs by it."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import nan
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, integrated
from runtime.baselines.scipy_methods import counted, in_pieces
from runtime.contract.coordinates import followed
from runtime.contract.errors import NoResult
from runtime.contract.model import EmittedModel, refuse_events
from runtime.engine.rows import evaluator
from runtime.results.motion_error import MotionError, amplitudes, motion_error
from runtime.running.comparison_times import comparison_steps
from runtime.running.outcome import statistics
from runtime.running.problem import Problem
from runtime.running.step_refinement import RefinementLevel
from runtime.solutions.solution import Solution
from runtime.studies.advice.methods import checked_grades

REFERENCE_RTOL, REFERENCE_ATOL = 1e-11, 1e-13
PARTS_OF_MOTION = 2**40  # parts of a motion, of which times are multiples
LOOSER_TOLERANCES = 100.0  # its own error is estimated from a path with tolerances this much looser
Path = Callable[[np.ndarray], np.ndarray]


class NoReference(NoResult):
    """The reference could not be computed."""


@dataclass(frozen=True)
class Reference:
    """path: times (N,) [s] -> what tells the motion (N, n_told) of a problem (`followed`).

    graded: names of what is judged. off: how far the path itself may be off, relative like any error. arguments: the
    parameters, initial and start of the problem, as `simulate` takes them.
    """

    problem: Problem
    path: Path
    graded: Sequence[str]
    off: float = 0.0
    arguments: Mapping[str, Any] = field(default_factory=dict)

    @cached_property
    def sizes(self) -> np.ndarray:
        """(n_told,) amplitudes of the motion [m or rad]."""
        return amplitudes(self.problem.model, self.path(_times(self.problem, 400)))

    @property
    def amplitudes(self) -> dict[str, float]:
        """Of what is graded, by name [m or rad]."""
        known = followed(self.problem.model)[0]
        return {name: float(self.sizes[known.index(name)]) for name in self.graded}

    def error(self, t: np.ndarray, compared_motion: np.ndarray) -> MotionError:
        """Of what a run tells (N, n_told) at times t (N,) [s]."""
        with np.errstate(over="ignore", invalid="ignore"):
            return motion_error(self.problem.model, t, compared_motion, self.path(t), self.sizes)

    def worst(self, error: MotionError) -> float:
        """The largest relative error of what is graded."""
        found = max(error.relative[name] for name in self.graded)
        return found if np.isfinite(found) else np.inf

    def at_end(self, error: MotionError) -> float:
        """The same at the end of the motion."""
        sizes = {name: error.over_motion[name] / error.relative[name] for name in self.graded if error.relative[name]}
        return max((error.at_end[name] / size for name, size in sizes.items()), default=0.0)


def independent_reference(
    model: EmittedModel,
    *,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    graded: Sequence[str] | None = None,
) -> Reference:
    """At tight tolerances, and how far it is from a looser path. The arguments are those of `simulate`.

    Raises ModelError, InitialStateError, SchemeError or NoReference.
    """
    refuse_events(model, "comparisons of methods")
    names = checked_grades(model, graded)
    problem = Problem.of(model, t_end, parameters, initial, start)
    tight, looser = (
        reference_path(problem, REFERENCE_RTOL * factor, REFERENCE_ATOL * factor) for factor in (1.0, LOOSER_TOLERANCES)
    )
    arguments = {"parameters": parameters, "initial": initial, "start": start}
    found = Reference(problem, tight, names, 0.0, arguments)
    times = _times(problem, 100)
    return Reference(problem, tight, names, found.worst(found.error(times, looser(times))), arguments)


def _times(problem: Problem, count: int) -> np.ndarray:
    """(N,) times of a motion [s], rising, that no vibration is in phase with; the last one is its end."""
    span = problem.t_end - problem.t0
    return problem.t0 + span / PARTS_OF_MOTION * comparison_steps(PARTS_OF_MOTION, most=count)


def reference_path(problem: Problem, rtol: float, atol: float) -> Path:
    """times (N,) -> what tells the motion (N, n_told): DOP853 with its dense output.

    Raises NoReference, or NoResult for steps that shrink.
    """
    model, state, t_end = problem.model, problem.state, problem.t_end
    c = model.constants(problem.p)
    y0 = integrated(model, state.q, state.q_dot)
    at = [*model.places.plain, *range(len(y0) - model.places.parameters.size, len(y0))]
    slope = counted(evaluator(CondensedOde(model, 1).right_hand_side(), c), "the reference")
    with np.errstate(all="ignore"):  # a motion that leaves the range of numbers is told by the result
        settings = {"method": "DOP853", "dense_output": True, "rtol": rtol, "atol": atol}
        results = in_pieces(model, c, slope, y0, t_end, None, **settings)
    last = results[-1]
    if not last.success or not np.isfinite(last.y[:, -1]).all():
        raise NoReference(f"the reference stopped at t = {last.t[-1]:.6g} s: {last.message}")
    starts = np.array([one.t[0] for one in results[1:]])

    def path(times: np.ndarray) -> np.ndarray:
        asked = np.clip(times, 0.0, t_end)
        pieces, found = np.searchsorted(starts, asked, side="right"), np.zeros((len(asked), len(at)))
        for k in np.unique(pieces):
            found[pieces == k] = results[k].sol(asked[pieces == k]).T[:, at]
        return found

    return path


# A run that was made to be compared: its true error by the reference, what it says of it, CPU time, evaluations.

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
