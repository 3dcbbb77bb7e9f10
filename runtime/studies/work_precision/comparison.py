"""Error against time for many methods on one motion: rungs of ladders, orders, energy, and a recommendation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, arguments
from runtime.contract.errors import NoResult, SymgenError
from runtime.contract.model import Model
from runtime.running.ladder import Ladder, Method, Rung
from runtime.studies.work_precision.methods import multirate
from runtime.studies.work_precision.reference import Reference, independent_reference
from runtime.studies.work_precision.trial import FINEST, Trial, adaptive_trials, trial_of

LONGEST = 0.3  # s: a method's curve ends with a run this long
ASYMPTOTIC = 3e-2  # errors below this take part in the order
ACCURATE = 1e-3  # error of the run whose energy is looked at
NEAR = 3.0  # times the error of the reference: nothing finer is judged
Note = Callable[[str], None]


@dataclass(frozen=True)
class EnergyDrift:
    """Relative to the largest kinetic and elastic energy: largest error, and slope of a linear fit times duration."""

    largest: float
    trend: float


@dataclass(frozen=True)
class WorkCurve:
    """One method: its trials, its order by the slope of error over step (NaN: not enough trials), energy drift.

    method: None for an established integrator.
    """

    label: str
    method: Method | None
    trials: list[Trial]
    order: float
    energy: EnergyDrift | None
    failure: str = ""

    @property
    def multirate(self) -> bool:
        """Does it take sub-steps?"""
        return self.method is not None and multirate(self.method)

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
    """All curves on one motion. tolerance: at which methods are ranked."""

    reference: Reference
    tolerance: float
    curves: list[WorkCurve]

    def ranked(self) -> list[WorkCurve]:
        """Curves by time to the tolerance."""
        return sorted(self.curves, key=lambda curve: curve.seconds_to(self.tolerance))

    def gain(self) -> float:
        """Time of the best method with one step for all coordinates over that of the best one with sub-steps."""
        best = {
            multirate: min(
                (curve.seconds_to(self.tolerance) for curve in self.curves if curve.multirate == multirate),
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
        if not first.multirate:
            loss = f"; the best method with sub-steps takes {1 / gain:.2g} times as long" if gain > 0 else ""
            return f"{first.label}, one step for all coordinates: {time}{loss}"
        if not np.isfinite(gain):
            return f"{first.label}: {time}; no method with one step for all coordinates reached it"
        return f"{first.label}: {time}, {gain:.2g} times as fast as the best method with one step for all coordinates"


@arguments(graded=NAMES, parameters=BY_NAME)
def work_precision(
    model: Model,
    methods: Sequence[Method | str],
    tolerance: float = 1e-3,
    longest: float = LONGEST,
    note: Note = lambda text: None,
    keep: Callable[[Comparison], object] = lambda comparison: None,
    *,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    graded: Sequence[str] | None = None,
) -> Comparison:
    """All rungs of the ladders of all methods on a motion, judged by an independent reference.

    methods: schemes, and established integrators by name. keep: called with what there is after each method; graded:
    names of what is judged; the others are those of `simulate`. Raises NoReference, and what `simulate` raises.
    """
    note("computing the reference")
    reference = independent_reference(
        model, t_end=t_end, parameters=parameters, initial=initial, start=start, graded=graded
    )
    return compared(reference, methods, tolerance, longest, note, keep)


def compared(
    reference: Reference,
    methods: Sequence[Method | str],
    tolerance: float = 1e-3,
    longest: float = LONGEST,
    note: Note = lambda text: None,
    keep: Callable[[Comparison], object] = lambda comparison: None,
) -> Comparison:
    """The same by a reference that is there."""
    curves: list[WorkCurve] = []
    for method in methods:
        label = method if isinstance(method, str) else method.label
        note(f"running {label}")
        try:
            curves.append(curve_of(method, reference, longest))
        except NoResult:
            raise
        except SymgenError as error:  # a scheme that this model does not allow, for instance
            given = None if isinstance(method, str) else method
            curves.append(WorkCurve(label, given, [], np.nan, None, str(error).splitlines()[0]))
        keep(Comparison(reference, tolerance, list(curves)))
    return Comparison(reference, tolerance, curves)


def curve_of(method: Method | str, reference: Reference, longest: float) -> WorkCurve:
    """The ladder of a method until it is fine enough or a run takes longer than `longest` [s]."""
    if isinstance(method, str):
        trials, drift, order, given = adaptive_trials(method, reference, longest), None, np.nan, None
    else:
        trials, drift, given = [], None, method
        for rung in Ladder(reference.problem, FINEST).climb(method):
            trials.append(trial_of(method.label, rung, reference))
            if drift is None and trials[-1].error < ACCURATE:
                drift = energy_drift(rung)
            if trials[-1].seconds > longest or trials[-1].error < max(FINEST, NEAR * reference.off):
                break
        order = order_of(trials)
    failure = "" if any(not trial.failure for trial in trials) else trials[-1].failure
    return WorkCurve(method if isinstance(method, str) else method.label, given, trials, order, drift, failure)


def order_of(trials: Sequence[Trial]) -> float:
    """Slope over the trials that are neither coarse nor near the finest error seen; NaN without a decade of these."""
    finest = min((trial.error for trial in trials), default=np.inf)
    used = [trial for trial in trials if 5 * finest < trial.error < ASYMPTOTIC]
    if len(used) < 2 or used[0].error < 10 * used[-1].error:
        return np.nan
    return float(np.polyfit(np.log([trial.setting for trial in used]), np.log([trial.error for trial in used]), 1)[0])


def energy_drift(rung: Rung) -> EnergyDrift | None:
    """Of a whole motion; None where the mechanism is fed or damped on purpose, or rests."""
    run = rung.run
    if not run.segment.model.conservative:
        return None
    seen = run.seen()
    total, scale = seen.total_energy, float((seen.energy["kinetic"] + seen.energy["elastic"]).max())
    if not np.isfinite(total).all() or scale <= 0:
        return None
    error = (total - total[0]) / scale
    trend = float(np.polyfit((seen.t - seen.t[0]) / np.ptp(seen.t), error, 1)[0])
    return EnergyDrift(float(np.abs(error).max()), trend)
