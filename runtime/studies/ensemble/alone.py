"""A case that lanes do not bring to its end is simulated by itself: singular positions, other ways to assemble."""

from __future__ import annotations

from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.running.simulate import simulate
from runtime.studies.ensemble.lane_runs import finished
from runtime.studies.ensemble.question import Question


def run_alone(model: Model, question: Question, sample: np.ndarray) -> tuple[np.ndarray, str, float]:
    """(values (width,), status, time reached [s]) of the case with these parameters and initial values."""
    plan, count = question.plan(model), len(question.parameters)
    given: dict[str, Any] = {
        "parameters": dict(zip(question.parameters, sample[:count].tolist(), strict=True)),
        "initial": dict(zip(question.initial, sample[count:].tolist(), strict=True)) or None,
    }
    try:
        solution = simulate(
            model,
            scheme=plan.name,
            dt=question.dt,
            m=list(question.m) or None,
            options=dict(plan.options),
            t0=question.t0,
            t_end=question.t_end,
            start=question.start or None,
            outputs=question.outputs,
            save_every=1 if question.reduced else question.every,
            force=True,
            **given,
        )
    except (InitialStateError, ModelError):
        return np.full(question.width(plan.steps), np.nan), "not_assembled", question.t0
    # lanes estimate no errors: a case has one status, however it was run
    name = "completed" if solution.status.whole and not solution.status.ok else solution.status.name
    return _values(question, solution, plan.steps), name, solution.status.time


def _values(question: Question, solution: Solution, steps: int) -> np.ndarray:
    if not question.reduced:
        times = len(question.marks(steps))
        values = np.full((len(question.outputs), times), np.nan)
        good = solution.outputs["t"] <= solution.status.time + 0.5 * question.dt
        for k, name in enumerate(question.outputs):
            found = solution.outputs[name][good][:times]
            values[k, : len(found)] = found
        return values.ravel()
    if not solution.status.whole:
        return np.full(len(question.reduced), np.nan)
    return np.array([_reduced(solution.outputs[name], how) for name, how in question.reduced])


def _reduced(y: np.ndarray, reduction: str) -> float:
    """As lanes do it: sums in the order of time."""
    if reduction in ("mean", "rms"):
        total = np.cumsum(y if reduction == "mean" else y * y)[-1:]
        return float(finished(reduction, total, len(y))[0])
    if reduction == "end":
        return float(y[-1])
    if reduction == "min":
        return float(y.min())
    return float((np.abs(y) if reduction == "peak" else y).max())
