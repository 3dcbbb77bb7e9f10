"""How long steps of one length may be for an error of the motion: trials with ever more of them, coarse ones first.

What two trials differ by is the error of the coarser one. It goes down with the order of the method, so it is measured
where that is cheap and taken on to what is asked; how far follows from what is seen, see REACH. Above ROUGH of an
amplitude there is no order. The last trial is one with the very steps that the run is to take: at some lengths, where
half periods of a vibration are a whole number of steps, steps are unstable that are stable on either side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.running.tried_motion import TrialRuns, TriedMotion

BEGIN = 24  # steps of the first trial, where nothing is known
PAIR = 1.5  # steps of a finer trial over those of one whose error is measured
# errors that are taken on, over what is aimed at: where no fall of the errors was as the order says, where one was, and
# where two were
REACH = (6.0, 24.0, 256.0)
ROUGH, LOST = 0.03, 1.0  # of an amplitude: errors above are not taken on; and tell nothing
SLACK = 1.5  # of the largest error that is taken on
LEAP, LEAPS = 8.0, (2.0, 4.0, 8.0)  # steps of a trial over those of the finest so far, at most; for as many falls
MOST = 24  # trials
CLEAN = (0.8, 1.25)  # slopes of errors over the order of the method
FEWER, MORE, ENOUGH = 1.2, 1.35, 2.5  # wanted steps over those of a trial, these over those, and its error: near enough
ASTRAY = 300  # steps from which on a motion near a singular position is believed to come there
KEPT = 0.5  # of the wanted steps: trials with more may be the run
APART = 1.1  # steps of a trial over those of a coarser one, at least
AT_ONCE = 5.0  # steps of the run over those of the finest trial, at most


@dataclass
class SteadyTrials:
    """runs: makes trials; first: one with steps to a tolerance, where there is one. made: ever finer."""

    runs: TrialRuns
    first: TriedMotion | None

    def __post_init__(self) -> None:
        self.made: list[TriedMotion] = []
        self.counts, self.errors = np.zeros(0), np.zeros(0)  # steps and errors of all but the finest

    def searched(self, error: float) -> TriedMotion | None:
        """The trial that should have an error; None if none was found."""
        count = float(max(self.runs.least, BEGIN if self.first is None else self.first.steps // 2))
        if not self._add(count) or not self._add(PAIR * count):
            return None
        while len(self.made) <= MOST:
            if self.runs.alarmed and (self.errors[-1] < ROUGH or self._count(self.made[-1]) > ASTRAY):
                return None  # others pass what is singular there
            k = self._last_above(error)
            wanted = self._between(k, error)
            if self._is_sure(k, error):
                near = [one for one in self.made if wanted / FEWER < self._count(one) < MORE * wanted]
                near = [one for one in near if self.error_of(one) < ENOUGH * error]
                if near:
                    return min(near, key=lambda one: abs(np.log(self._count(one) / wanted)))
            if not self._add(self._next(k, error, wanted), wanted):
                return None
        return None

    def gain_of_varied(self) -> float:
        """Operations with steps of varied lengths over those of one length, if errors of steps just add up.

        With sizes e of equal steps, and e of h^p, steps of equal errors s take (e / s)^(1/p) of their number each.
        """
        p, e = self.runs.scheme.error_order, self.made[-1].sizes
        root = np.mean(e ** (1 / p))
        s = (np.mean(e) / root) ** (p / (p - 1))
        return float(root * s ** (-1 / p)) * self.runs.scheme.price_of_varied(self.runs.stepper.program)

    def error_of(self, one: TriedMotion) -> float:
        """Of a trial, as far as it is known: of the finest one from that before it."""
        if one is not self.made[-1]:
            return float(self.errors[[one is other for other in self.made].index(True)])
        slope = self._used(len(self.errors) - 1)
        return float(self.errors[-1] * (self.counts[-1] / self._count(one)) ** slope)

    def operations(self, count: float) -> float:
        """Of so many steps."""
        return self.made[-1].operations * count / self._count(self.made[-1])

    def operations_for(self, other: TriedMotion) -> float:
        """Of as many steps as have the error of another motion."""
        error = self.runs.error(other, self.made[-1])
        return self.operations(self._between(self._last_above(error), error))

    def _count(self, one: TriedMotion) -> float:
        return self.runs.span / one.steady

    def _add(self, count: float, wanted: float = np.inf) -> bool:
        """One more trial, in its place; False where there is none. wanted: steps that the run may take."""
        known = self.made[-1] if self.made else self.first
        one = self.runs.of_length(self.runs.span / count, known, keep=count > KEPT * wanted)
        if one is None:
            return False
        self.made = sorted([*self.made, one], key=lambda trial: -trial.steady)
        pairs, p = list(zip(self.made, self.made[1:], strict=False)), self.runs.scheme.order
        self.counts = np.array([self._count(one) for one in self.made[:-1]])
        found = [self.runs.error(one, finer) / (1 - (finer.steady / one.steady) ** p) for one, finer in pairs]
        self.errors = np.array(found)
        return True

    def _last_above(self, error: float) -> int:
        """The finest trial whose error is larger; -1 if there is none."""
        return int(np.flatnonzero(self.errors > error).max(initial=-1))

    def _slope(self, k: int) -> float:
        """Of the errors from the trial k to the next one, over the order of the method; NaN where it is not known."""
        if not 0 <= k < len(self.errors) - 1:
            return np.nan
        fall = np.log(self.errors[k] / self.errors[k + 1]) / np.log(self.counts[k + 1] / self.counts[k])
        return float(fall / self.runs.scheme.order)

    def _is_sure(self, k: int, error: float) -> bool:
        """Is the number of steps known well enough? k: the finest trial with a larger error."""
        if 0 <= k == len(self.errors) - 1:
            return bool(self.errors[k] <= SLACK * self._largest(error, self._clean(k)))
        return True

    def _next(self, k: int, error: float, wanted: float) -> float:
        """Of how many steps the next trial is, where `wanted` should have the error."""
        finest = self._count(self.made[-1])
        if k < 0:
            return max(wanted, float(self.counts[0]) / LEAP, self.runs.least)
        if k < len(self.errors) - 1:
            return max(wanted, APART * float(self.counts[k]))
        if self._is_sure(k, error):
            return min(max(wanted, APART * finest), LEAP * finest)
        hopeful = self._clean(k, unknown=True)
        there, leap = self._taken_on(k, self._largest(error, hopeful)), LEAPS[hopeful if self.errors[k] < LOST else 0]
        if there > PAIR * finest:
            return min(there, leap * finest)
        at_once = self._clean(k) > 0 and PAIR * finest < wanted < AT_ONCE * finest
        return wanted if at_once else PAIR * finest

    @staticmethod
    def _largest(error: float, clean: int) -> float:
        """The largest error that is taken on to another one, after so many falls as the order says."""
        return max(min(REACH[clean] * error, ROUGH), 2 * error)

    def _clean(self, k: int, unknown: bool = False) -> int:
        """How many of the last two falls to a trial are as the order says; unknown: what unknown ones count as."""
        slopes = [self._slope(j) for j in (k - 1, k - 2)]
        clean = [unknown if np.isnan(slope) else CLEAN[0] < slope < CLEAN[1] for slope in slopes]
        return 2 if all(clean) else int(clean[0])

    def _taken_on(self, k: int, error: float) -> float:
        """The number of steps for an error, from the error of a trial."""
        return float(self.counts[k] * (self.errors[k] / error) ** (1 / self._used(k)))

    def _used(self, k: int) -> float:
        """The slope that an error is taken on with."""
        known = [slope for slope in (self._slope(k - 1), self._slope(k)) if np.isfinite(slope)]
        return float(self.runs.scheme.order * min(max(known[0] if known else 1.0, CLEAN[0]), CLEAN[1]))

    def _between(self, k: int, error: float) -> float:
        """The number of steps for an error; k: the finest trial with a larger one."""
        if k < 0:
            return max(self._taken_on(0, error), float(self.runs.least))
        if k == len(self.errors) - 1:
            return self._taken_on(k, error)
        share = np.log(self.errors[k] / error) / np.log(self.errors[k] / self.errors[k + 1])
        return float(self.counts[k] ** (1 - share) * self.counts[k + 1] ** share)
