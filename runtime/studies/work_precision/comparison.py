"""Error against time for many methods on one motion: trials, orders, energy, and a recommendation with its reason."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import NoResult, SymgenError
from runtime.studies.work_precision.energy_drift import EnergyDrift, energy_drift
from runtime.studies.work_precision.methods import Method, run_method
from runtime.studies.work_precision.prepared_method import PreparedMethod, Trial
from runtime.studies.work_precision.problem import Problem, Setting

LONGEST = 0.3  # s: a method's curve ends with a run this long
ASYMPTOTIC = 3e-2  # errors below this take part in the order
Note = Callable[[str], None]


@dataclass(frozen=True)
class WorkCurve:
    """One method: its trials, its order by the slope of error over step (NaN: not enough trials), energy drift."""

    method: Method
    trials: list[Trial]
    order: float
    energy: EnergyDrift | None
    failure: str = ""

    def seconds_to(self, tolerance: float) -> float:
        """CPU time [s] to a tolerance, between trials by interpolation in logarithms; inf if it was not reached."""
        return self._to(tolerance, lambda trial: trial.seconds)

    def evaluations_to(self, tolerance: float) -> float:
        """Evaluations to a tolerance."""
        return self._to(tolerance, lambda trial: trial.evaluations)

    def _to(self, tolerance: float, price: Callable[[Trial], float]) -> float:
        best, above = np.inf, None
        for trial in self.trials:
            if trial.error > tolerance:
                above = None if trial.failure else trial
            elif above is None:
                best = min(best, price(trial))
            else:
                share = np.log(above.error / tolerance) / np.log(above.error / max(trial.error, 1e-300))
                best = min(best, float(price(above) ** (1 - share) * price(trial) ** share))
                above = None
        return float(best)


@dataclass(frozen=True)
class Comparison:
    """All curves on one problem. tolerance: at which methods are ranked."""

    problem: Problem
    tolerance: float
    curves: list[WorkCurve]

    def ranked(self) -> list[WorkCurve]:
        """Curves by time to the tolerance."""
        return sorted(self.curves, key=lambda curve: curve.seconds_to(self.tolerance))

    def gain(self) -> float:
        """Time of the best method with one step for all coordinates over that of the best one with sub-steps."""
        best = {
            multirate: min(
                (curve.seconds_to(self.tolerance) for curve in self.curves if curve.method.multirate == multirate),
                default=np.inf,
            )
            for multirate in (True, False)
        }
        return float(best[False] / max(best[True], 1e-300)) if np.isfinite(best[True]) else 0.0

    def recommendation(self) -> str:
        """What to use, and why."""
        first = self.ranked()[0]
        if not np.isfinite(first.seconds_to(self.tolerance)):
            return f"no method reached {self.tolerance:g}: allow more time, or loosen the tolerance"
        time = f"{first.seconds_to(self.tolerance) * 1e3:.3g} ms to an error of {self.tolerance:g}"
        gain = self.gain()
        if not first.method.multirate:
            loss = f"; the best method with sub-steps takes {1 / gain:.2g} times as long" if gain > 0 else ""
            return f"{first.method.label}, one step for all coordinates: {time}{loss}"
        if not np.isfinite(gain):
            return f"{first.method.label}: {time}; no method with one step for all coordinates reached it"
        return (
            f"{first.method.label}: {time}, {gain:.2g} times as fast as the best method with one step for all "
            "coordinates"
        )


def work_precision(
    setting: Setting,
    methods: list[Method],
    tolerance: float = 1e-3,
    longest: float = LONGEST,
    note: Note = lambda text: None,
    keep: Callable[[Comparison], object] = lambda comparison: None,
) -> Comparison:
    """Run all methods on a setting, judged by an independent reference. Raises NoReference.

    keep: called with what there is after each method.
    """
    note("computing the reference")
    problem = setting.judged()
    curves = []
    for method in methods:
        note(f"running {method.label}")
        curves.append(_curve(method, problem, longest))
        keep(Comparison(problem, tolerance, list(curves)))
    return Comparison(problem, tolerance, curves)


def _curve(method: Method, problem: Problem, longest: float) -> WorkCurve:
    try:
        trials, prepared = run_method(method, problem, longest)
    except NoResult:
        raise
    except SymgenError as error:  # a scheme that this model does not allow, for instance
        return WorkCurve(method, [], np.nan, None, str(error).splitlines()[0])
    failure = "" if any(not trial.failure for trial in trials) else trials[-1].failure
    return WorkCurve(method, trials, _order(method, trials), _drift(prepared, trials), failure)


def _order(method: Method, trials: list[Trial]) -> float:
    """Slope over the trials that are neither coarse nor near the finest error seen."""
    if method.spec is None:
        return np.nan
    finest = min((trial.error for trial in trials), default=np.inf)
    used = [trial for trial in trials if 5 * finest < trial.error < ASYMPTOTIC]
    if len(used) < 3 or used[0].error < 10 * used[-1].error:
        return np.nan
    return float(np.polyfit(np.log([trial.setting for trial in used]), np.log([trial.error for trial in used]), 1)[0])


def _drift(prepared: PreparedMethod | None, trials: list[Trial]) -> EnergyDrift | None:
    """At the coarsest trial that is good to a tenth of a per cent."""
    good = [trial for trial in trials if trial.error < 1e-3]
    return energy_drift(prepared, good[0].steps) if prepared is not None and good else None
