"""What a comparison runs: fixed-step schemes by step, adaptive integrators by tolerance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import ceil

import numpy as np

from runtime.baselines.scipy_methods import scipy_solution
from runtime.baselines.sundials import sundials_solution
from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.schemes.catalogue import SCHEMES
from runtime.schemes.options import SchemeError
from runtime.studies.work_precision.dense_methods import LARGE, affordable, dense_methods
from runtime.studies.work_precision.prepared_method import PreparedMethod, Spec, Trial
from runtime.studies.work_precision.problem import Problem
from runtime.studies.work_precision.stiff_methods import stiff_methods

TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9)
SAMPLES = 101
FEWEST, FACTOR = 10, 2**0.5  # steps: the first trial, and the ratio of one trial to the next
FINEST = 3e-8  # relative error at which a curve has gone far enough
ADAPTIVE: dict[str, Callable[..., Solution]] = {
    "DOP853 adaptive": partial(scipy_solution, method="DOP853"),
    "Radau adaptive": partial(scipy_solution, method="Radau"),
    "CVODES BDF": partial(sundials_solution, method="cvodes"),
    "CVODES Adams": partial(sundials_solution, method="cvodes", multistep="adams"),
    "IDAS": partial(sundials_solution, method="idas"),
}
FOR_LARGE = ("DOP853 adaptive", "CVODES BDF", "CVODES Adams", "IDAS")
FOR_LONGEST = ("DOP853 adaptive",)  # the others need derivatives of hundreds of thousands of operations


@dataclass(frozen=True)
class Method:
    """One curve of a comparison: a fixed-step scheme, or the name of an adaptive integrator."""

    label: str
    spec: Spec | None = None

    @property
    def multirate(self) -> bool:
        """Does it take sub-steps?"""
        return self.spec is not None and SCHEMES[self.spec.scheme].multirate


def usual_methods(model: Model) -> list[Method]:
    """Every scheme with a usual m, and the adaptive integrators; of dense ones fewer for large models: `left_out`."""
    dense = [
        Spec("exponential", (1,)),
        Spec("exponential", (2,)),
        Spec("exponential", (4,)),
        Spec("exponential", (1,), {"order": 5}),
        Spec("exponential", (2,), {"order": 5}),
        Spec("linearised", (2,)),
        Spec("linearised", (8,), {"propagation": "central_difference"}),
    ]
    dense += [Spec("radau", None, {"eps": (1e-6,)}), Spec("generalized_alpha"), Spec("hht")]
    specs = dense_methods(model, dense)
    specs = [*stiff_methods(model), *specs]
    if len(model.groups) > 1:
        inner = (1,) * (len(model.groups) - 2)
        specs += [Spec("coupled", (*inner, 4)), Spec("printed", (*inner, 4), {"common_update": "direct"})]
        if len(model.groups) == 2:
            specs += [Spec("decoupled", (4,))]
    specs += [
        Spec("single_rate"),
        Spec("single_rate", None, {"common_velocity": "predictor"}),
        Spec("rk4"),
        Spec("dop853"),
    ]
    return [Method(spec.label, spec) for spec in specs] + [Method(name) for name in _usual_adaptive(model)]


def _usual_adaptive(model: Model) -> tuple[str, ...]:
    if len(model.q_i) <= LARGE:
        return tuple(ADAPTIVE)
    return FOR_LARGE if affordable(model) and model.has("residual_jacobian") else FOR_LONGEST


def methods_named(model: Model, names: list[str]) -> list[Method]:
    """Methods by name: `exponential`, `coupled:4` (m after a colon, ratios with +), or an adaptive one's name.

    `compiled` alone stands for all usual ones but the adaptive. Raises SchemeError.
    """
    if names == ["compiled"]:
        return [method for method in usual_methods(model) if method.spec is not None]
    found = []
    for name in names:
        adaptive = next((one for one in ADAPTIVE if one.lower().replace(" ", "_") == name.lower()), None)
        if adaptive is not None:
            found.append(Method(adaptive))
            continue
        scheme, _, ratios = name.partition(":")
        if scheme not in SCHEMES:
            known = ", ".join([*SCHEMES, *(one.lower().replace(" ", "_") for one in ADAPTIVE)])
            raise SchemeError(f"there is no method {name!r}; methods are {known}")
        try:
            m = tuple(int(part) for part in ratios.split("+")) if ratios else None
        except ValueError:
            raise SchemeError(f"{name!r}: what follows the colon must be whole numbers, such as {scheme}:4") from None
        found.append(Method(Spec(scheme, m).label, Spec(scheme, m)))
    return found


def run_method(method: Method, problem: Problem, seconds: float) -> tuple[list[Trial], PreparedMethod | None]:
    """Trials of a method, coarse to fine, until it is fine enough or a run takes longer than `seconds`."""
    if method.spec is None:
        return _adaptive(method.label, problem, seconds), None
    prepared = PreparedMethod(method.spec, problem)
    trials: list[Trial] = []
    steps = float(FEWEST)
    while True:
        trial = prepared.run(ceil(steps))
        trials.append(trial)
        if trial.seconds > seconds or trial.error < max(FINEST, 3 * problem.reference_error):
            return trials, prepared
        steps *= FACTOR if not trial.failure else 2.0


def _adaptive(label: str, problem: Problem, seconds: float) -> list[Trial]:
    trials: list[Trial] = []
    times = np.linspace(0.0, problem.t_end, SAMPLES)
    for tolerance in TOLERANCES:
        solution = problem.solved(ADAPTIVE[label], times, tolerance)
        spent = float(solution.stats["wall_seconds"])
        evaluations = int(solution.stats["evaluations"])
        failed = "" if solution.status.whole and len(solution.t) == SAMPLES else solution.status.cause or "failed"
        if failed:
            nothing = np.full(len(problem.graded), np.nan)
            trials.append(Trial(label, tolerance, evaluations, spent, evaluations, np.inf, np.inf, nothing, failed))
            continue
        rms, end = problem.errors(times, solution.q[:, followed(problem.model)[1]])
        trials.append(Trial(label, tolerance, evaluations, spent, evaluations, float(rms.max()), float(end.max()), rms))
        if spent > 10 * seconds or rms.max() < FINEST:
            break
    return trials
