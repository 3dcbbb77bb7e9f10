"""CVODES and IDAS on a case of the hard suite, in each of the ways that could suit it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from math import inf

import casadi as ca
import numpy as np

from benchmarks.contenders.external import SLOPES, VALUES
from benchmarks.contenders.sundials import Sundials, refuse_impulses
from benchmarks.harness.matched import Attempt, Matched, match
from runtime.baselines.condensed_ode import TO_ROUNDING, CondensedOde, start_of
from runtime.contract.coordinates import followed, whole
from runtime.engine.rows import evaluate
from runtime.studies.advice.reference import Reference

SAMPLES = 100
MOST_STEPS = 10_000  # between two samples
TOLERANCES = tuple(10.0**-k for k in range(1, 10))
FIRST = 2  # where the search begins: 1e-3
REPEATS = 2
WAYS: Mapping[str, dict[str, tuple[str, int | None]]] = {
    "cvodes": {"BDF": ("bdf", None), "BDF to order 2": ("bdf", 2), "Adams": ("adams", None)},
    "idas": {"BDF": ("bdf", None), "BDF to order 2": ("bdf", 2)},
}


@dataclass
class SundialsRuns:
    """`cvodes` or `idas` on a problem: native right-hand side and exact Jacobian, made once for all runs."""

    method: str
    reference: Reference
    sundials: Sundials = field(init=False)

    def __post_init__(self) -> None:
        problem, model = self.reference.problem, self.reference.problem.model
        given = start_of(model, **self.reference.arguments)
        refuse_impulses(model, given.c, problem.t_end, given.y, self.method)
        self.sundials = Sundials(model, self.method, given)
        observe = CondensedOde(model, TO_ROUNDING).observe()
        self._observe = ca.Function(
            "seen", observe.sx_in(), observe.call(observe.sx_in())[:2], ["t", "y", "c"], ["q_i", "q_d"]
        )
        self._times = np.linspace(0.0, problem.t_end, SAMPLES + 1)

    def best(self, tolerance: float, longest: float) -> tuple[str, Matched]:
        """(the way that takes least time to the tolerance, what it takes); `longest` [s] as for `match`."""
        amplitudes = self.reference.amplitudes.values()
        weights = {"": min(amplitudes), ", coarse atol": max(amplitudes)}
        found: dict[str, Matched] = {}
        for way, (multistep, order) in WAYS[self.method].items():
            for word, weight in weights.items():
                run = partial(self.attempt, multistep, order, weight)
                found[way + word] = match(run, TOLERANCES, FIRST, tolerance, longest)
                longest = min(longest, 4 * found[way + word].seconds)
        way = min(found, key=lambda name: found[name].seconds)
        return way, found[way]

    def attempt(self, multistep: str, order: int | None, weight: float, rtol: float) -> Attempt:
        """One run; the absolute tolerance is rtol times the weight, in all coordinates and rates."""
        done = self.sundials.run(self._times, rtol, rtol * weight, multistep, order, MOST_STEPS, REPEATS)
        steps, seconds = int(done.stats["steps"]), float(done.stats["cpu_seconds"])
        if done.refused:
            return Attempt(rtol, inf, seconds, steps, done.refused)
        seen = evaluate(self._observe, {"t": self._times[:, None], "y": done.y}, self.sundials.given.c)
        model = self.reference.problem.model
        told = whole(model, seen["q_i"], seen["q_d"])[:, followed(model)[1]]
        error = self.reference.worst(self.reference.error(self._times, told))
        own = self._evaluations(int(done.stats["evaluations"]), int(done.stats["factorisations"]))
        return Attempt(rtol, error, seconds, steps, own=own)

    def _evaluations(self, values: int, slopes: int) -> float:
        """CPU seconds of so many evaluations of the equations and of their Jacobian."""
        of_values, of_slopes = self._prices
        return values * of_values + slopes * of_slopes

    @cached_property
    def _prices(self) -> tuple[float, float]:
        """CPU seconds of one, where they were made last."""
        native = self.sundials.native
        return (inf, inf) if native is None else (native.seconds(VALUES), native.seconds(SLOPES))
