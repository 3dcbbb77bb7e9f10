"""The independent reference that methods are compared by, DOP853 of SciPy at any time, and runs by it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
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
from runtime.running.problem import Problem
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
