"""From the tolerance of a motion to that of its steps, where their lengths vary.

Errors of steps add up over a motion or die out in it, by factors from 10 to 10,000 from mechanism to mechanism, but
nearly in proportion to the tolerance of the steps. What a trial and the finest one differ by is the error of the first.

    trials      at COARSER times what is asked, and at what is asked
    finer       while two of them have nearly the same steps, as stability sets those: their errors are nearly the same
    further     where the tolerance that is wanted lies far from both: coarser or finer ones, at most MOST in all
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from runtime.running.calibration import Calibration
from runtime.running.tried_motion import TrialRuns, TriedMotion

LOOSEST, FINEST = 1.0, 1e-13  # tolerances of steps
COARSER = 10.0  # tolerance of the coarser trial over what is asked
FAR = 10.0  # beyond the finest trial, errors are not taken to be in proportion to the tolerance
NEARER = 100.0  # at most, from one further trial to the next
MOST = 6  # trials that are compared
AS_LONG = 0.5  # of the power of the tolerance that steps go down by: below that it is not what sets them
TIGHTER = 3  # trials of the tolerance that is wanted, where singular positions are passed
SLOPES = (0.8, 1.25)  # of an error's power of the tolerance over what the orders of the method say


@dataclass
class VariedTrials:
    """runs: makes trials; first: a coarse one, which tells ranges. made: ever finer."""

    runs: TrialRuns
    first: TriedMotion

    def __post_init__(self) -> None:
        self.made: list[TriedMotion] = []

    def calibration(self, asked: float, aim: float) -> Calibration | None:
        """For a motion with the error `aim` where `asked` is; None where a trial is lost."""
        if (not self.made and self.begin(asked) is None) or not self._add(asked):
            return None
        while not self.runs.passes and self._steps_are_as_long() and len(self.made) < MOST:
            if not self._add(max(self.made[-1].tolerance / COARSER, FINEST)):
                return None
        wanted = self._wanted(aim)
        while len(self.made) < MOST:
            coarsest, finest = self.made[0].tolerance, self.made[-1].tolerance
            if wanted > 1.5 * coarsest and coarsest < LOOSEST:
                more = min(wanted, NEARER * coarsest, LOOSEST)
            elif wanted < finest / FAR and finest > FINEST:
                more = max(COARSER**0.5 * wanted, finest / NEARER, FINEST)
            else:
                break
            if not self._add(more):
                return None
            wanted = self._wanted(aim)
        wanted = min(max(wanted, self.made[-1].tolerance / NEARER, FINEST), LOOSEST)
        return self._seen(asked, aim, wanted) if self.runs.passes else self._told(asked, aim, wanted)

    def _seen(self, asked: float, aim: float, wanted: float) -> Calibration:
        """Where singular positions are passed the error also depends on where the steps before them end: what it was
        with a tolerance is not carried to another one without a trial of that.
        """
        error, finest = 0.0, self.made[-1]
        for _ in range(TIGHTER):
            one = self.runs.of_tolerance(wanted, finest) if wanted > finest.tolerance else None
            error = 0.0 if one is None else self.runs.error(one, finest)
            if error <= asked:
                break
            wanted = max(wanted * min(aim / error, 0.5), finest.tolerance)
        told = self._told(asked, aim, wanted)
        return replace(told, error=max(error, told.error) if error <= asked else told.error)

    def _steps_are_as_long(self) -> bool:
        """Do the two finest trials have nearly the same steps?"""
        coarse, fine = self.made[-2:]
        power = AS_LONG / self.runs.scheme.error_order
        return bool(fine.steps < coarse.steps * (coarse.tolerance / fine.tolerance) ** power)

    def begin(self, asked: float, most: float = np.inf) -> TriedMotion | None:
        """The coarser trial; None where it is lost or takes more than `most` operations."""
        return self.made[0] if self._add(min(LOOSEST, COARSER * asked), most) else None

    def _told(self, asked: float, aim: float, wanted: float) -> Calibration:
        nearest = min(self.made, key=lambda one: abs(np.log(one.tolerance / wanted)))
        finest = self.made[-1]
        longer = (wanted / nearest.tolerance) ** (1 / self.runs.scheme.error_order)
        tolerance, found, slope = self._line(aim)
        return Calibration(
            wanted / asked,
            0.0,
            finest.low,
            finest.high,
            nearest.first * min(longer, 1.0),
            nearest.longest * longer,
            float(np.exp(found + slope * (np.log(wanted) - tolerance))),
            nearest.operations / longer,
            self.runs.tries,
            self.runs.spent,
        )

    def _add(self, tolerance: float, most: float = np.inf) -> bool:
        """One more trial, in its place; False where there is none."""
        one = self.runs.of_tolerance(tolerance, self.made[-1] if self.made else self.first, most=most)
        if one is None:
            return False
        self.made = sorted([*self.made, one], key=lambda trial: -trial.tolerance)
        return True

    def _line(self, error: float) -> tuple[float, float, float]:
        """(log tolerance, log error, slope) of the trial whose error is nearest to this one, of all but the finest.

        The slope is that to the next one, within SLOPES of what the orders of the method say. An error that has fallen
        faster is luck, as where a motion is unstable in itself: steps of nearly that tolerance may be far worse.
        """
        x = np.log([one.tolerance for one in self.made[:-1]])
        y = np.log([self.runs.error(one, self.made[-1]) for one in self.made[:-1]])
        order = self.runs.scheme.order / self.runs.scheme.error_order
        least, most = SLOPES[0] * order, max(SLOPES[1] * order, 1.0)
        for j in range(1, len(y)):
            y[j] = max(y[j], y[j - 1] + most * (x[j] - x[j - 1]))
        k = int(np.argmin(abs(y - np.log(error))))
        slope = order
        if len(x) > 1:
            other = k + 1 if k == 0 or (k + 1 < len(x) and y[k] > np.log(error)) else k - 1
            slope = (y[other] - y[k]) / (x[other] - x[k])
        return float(x[k]), float(y[k]), float(min(max(slope, least), most))

    def _wanted(self, error: float) -> float:
        """The tolerance of steps that leads to an error of the motion."""
        tolerance, found, slope = self._line(error)
        return float(np.exp(tolerance + (np.log(error) - found) / slope))
