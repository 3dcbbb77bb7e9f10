"""The choice of a method by what its first level of steps takes: operations of a step, times steps that are stable."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import ceil
from typing import Any

import numpy as np

from runtime.contract.model import EmittedModel
from runtime.running.fastest_mode import slopes_at_start
from runtime.running.problem import (
    Problem,
)
from runtime.running.steps_for_loads import steps_for_loads
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import LARGE_SYSTEM
from runtime.schemes.scheme import Scheme, evaluation_operations

FIRST_LEVEL_STEPS = 20  # steps of a first level, at least
TOLERANCE_SAFETY = 0.9  # of a tolerance, and of a stability limit
EXPLICIT_METHODS = ("dopri5", "rk4")
HANDICAP = {"rk4": 2}  # times the steps that a method of lower order is expected to take
# operations of a step: evaluations, and times n, n^2, n^3 of n coordinates; of the hard suite, to a factor 1.6
PRICES = {
    "dopri5": (6.5, 0, 0, 0),
    "rk4": (4.0, 0, 0, 0),
    "exponential_rk4": (4.5, 300, 20, 0),
    "exponential": (4.0, 500, 300, 10),
}
DENSE_STEP_OPERATIONS = 12  # operations of a step with dense matrices, over n^3
MOST_DENSE = 400_000  # operations of such a step: some 30 s of the compiler


@dataclass(frozen=True)
class Method:
    """A scheme with ratios m and options; first: steps of its first level, 0 for as many as it needs."""

    scheme: str
    m: tuple[int, ...] | None = None
    options: Mapping[str, Any] = field(default_factory=dict)
    first: int = 0

    @property
    def label(self) -> str:
        """The name, with m and options where they were chosen."""
        ratios = f" m={','.join(map(str, self.m))}" if self.m else ""
        return self.scheme + ratios + "".join(f" {_word(name, value)}" for name, value in self.options.items())


def _word(name: str, value: Any) -> str:
    return value if isinstance(value, str) else f"{name}={value[0] if isinstance(value, tuple) else value}"


def chosen_method(problem: Problem) -> tuple[Method, str]:
    """The method whose first level takes the fewest operations, and why; nothing is compiled for it."""
    return problem.model.of_numbers("method", problem.numbers, lambda: _chosen(problem))


def _chosen(problem: Problem) -> tuple[Method, str]:
    slopes, compared = slopes_at_start(problem), steps_for_loads(problem)
    prices: list[tuple[float, Method]] = []
    evaluation = 0
    for name in (*EXPLICIT_METHODS, *_exponentials(problem.model)):
        kind, steps = scheme_kind(name), max(FIRST_LEVEL_STEPS, compared)
        if kind.make.limited():
            span = problem.t_end - problem.t0
            scheme = kind.build(name, problem.model, span / FIRST_LEVEL_STEPS, None, {})
            steps = max(steps, stable_steps(scheme, slopes, span))
            evaluation = evaluation or evaluation_operations(scheme)
        method = Method(name, first=steps)
        if name == EXPLICIT_METHODS[0] and steps <= max(FIRST_LEVEL_STEPS, compared):
            return method, f"{name}: the motion is not stiff"
        prices.append((steps * HANDICAP.get(name, 1) * _price(name, evaluation, len(problem.model.q_i)), method))
    price, best = min(prices, key=lambda one: one[0])
    others = ", ".join(f"{one.scheme} {other / price:.3g}" for other, one in prices if one is not best)
    return best, f"{best.scheme}: the motion is stiff; operations of a first level, relative to it: {others}"


def _price(name: str, evaluation: int, n: int) -> float:
    """Operations of a step with n coordinates, about."""
    evaluations, *of_size = PRICES[name]
    return float(evaluations * evaluation + sum(factor * n**power for power, factor in enumerate(of_size, start=1)))


def stable_steps(scheme: Scheme, slopes: tuple[np.ndarray, np.ndarray] | None, span: float) -> int:
    """Steps of a first level: within the stability limit at the start."""
    limit = scheme.step_limit(*slopes) if slopes is not None and scheme.limited() else None
    if limit is None:
        return FIRST_LEVEL_STEPS
    sub_steps = scheme.grid.h[0] / scheme.grid.h[-1]
    return max(FIRST_LEVEL_STEPS, ceil(span / (TOLERANCE_SAFETY * limit.h * sub_steps)))


def _exponentials(model: EmittedModel) -> list[str]:
    """Methods for stiff motion that the model can be stepped with, and that are not dear by its size."""
    found = ["exponential_rk4"] if model.has("deflections") else []
    n = len(model.q_i)
    small = model.has("residual_jacobian") and (n <= LARGE_SYSTEM if found else affordable(model))
    return [*found, "exponential"] if small else found


def affordable(model: EmittedModel) -> bool:
    """Is a step with dense matrices short enough to be compiled?"""
    return DENSE_STEP_OPERATIONS * len(model.q_i) ** 3 <= MOST_DENSE
