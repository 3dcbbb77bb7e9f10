"""Cases that are stepped again, finer, until each meets the tolerance: side by side with those of the same level.

What a case does depends on the case alone: its bits are the same whoever goes beside it.

References: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993,
section II.4 (Richardson's extrapolation, which tells the error of two runs with unlike steps).
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import get_args

import numpy as np

from runtime.contract.status import StatusName
from runtime.results.motion_error import errors_of_many
from runtime.running.method_choice import TOLERANCE_SAFETY
from runtime.running.outcome import INACCURATE_ERROR
from runtime.running.step_refinement import (
    ACCURATE,
    AFTER_LOST,
    LEVELS_TO_STAGNATE,
    MOST_GROWTH,
    RICHARDSON_SAFETY,
    SHOWN_ORDER,
    STAGNANT_DIFFERENCE,
)
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import LaneResults
from runtime.studies.ensemble.rows import Rows

JOB = 1000  # cases of a thread, so that levels are shared
REFINED_JOB_BYTES = 1 << 25  # of their samples
LEAST_REFINED_JOB = 64
MOST_RUNS = 14  # of a case
LEAST_WHOLE = 3  # levels that come to their end before one is believed
LOST_BY_COARSE_STEPS = (
    "diverged",
    "not_finite",
    "deflection_too_large",
    "constraints_lost",
    "mass_not_positive",
    "inaccurate",
)  # steps may do it
LOST_TWICE, LOST_COARSE = 2, 4  # levels in a row that end alike before a case does; of those that coarse steps cause
ONE_END = 0.02  # of the motion: ends that are one
LEAST_ORDER = 1.0  # that is shown where an error is extrapolated
MOST_ORDER = 1.125  # of the method's: what coarse levels may show, whose errors fall faster than its order
UNBELIEVED = 2.0  # times the steps of a level where nothing is known of its error
SEARCHED_ORDERS = np.linspace(0.05, 12.0, 240)  # that are looked for
NAME = f"U{max(map(len, get_args(StatusName)))}"


def rows_of(spec: EnsembleSpec, table: np.ndarray) -> Rows:
    """Results of the cases of an ensemble, to a tolerance if it has one."""
    return Rows(spec, table) if spec.refinement is None else RefinedRows(spec, table)


class RefinedRows(Rows):
    """Results to a tolerance of any cases of an ensemble."""

    def __init__(self, spec: EnsembleSpec, table: np.ndarray) -> None:
        super().__init__(spec, table)
        assert spec.refinement is not None
        self._refinement, self._lock = spec.refinement, threading.Lock()
        self._levels = {spec.refinement.first: Rows(spec, table)}

    def job(self, cases: int, workers: int) -> int:
        """Cases that a thread takes at a time."""
        by_room = REFINED_JOB_BYTES // (8 * max(1, self.spec.width))
        return max(LEAST_REFINED_JOB, min(JOB, by_room, -(-cases // workers)))

    def level(self, steps: int) -> Rows:
        """Runs with so many steps in each unit."""
        with self._lock:
            if steps not in self._levels:
                self._levels[steps] = Rows(self.spec.level(steps), self.table)
            return self._levels[steps]

    def of(self, first: int, stop: int, stopped: Callable[[], bool] = lambda: False) -> LaneResults | None:
        """Results of these cases, each at its own level; None if `stopped` said so."""
        cases = RefinedCases(self.spec, stop - first)
        samples = self.table[first:stop]
        while cases.open.any():
            for steps in np.unique(cases.steps[cases.open]):
                which = np.flatnonzero(cases.open & (cases.steps == steps))
                rows = self.level(int(steps))
                found = rows.run(samples[which], stopped)
                if found is None:
                    return None
                cases.take(which, rows.spec, found)
        return cases.results()


class RefinedCases:
    """What is known of some cases after the levels that each has taken.

    steps (cases,): in each unit, of the level that a case takes next, or took last; open (cases,): which go on.
    """

    def __init__(self, spec: EnsembleSpec, cases: int) -> None:
        assert spec.refinement is not None
        self._spec, self._asked = spec, spec.refinement
        self._order = int(spec.plan.scheme.order)
        self.steps = np.full(cases, self._asked.first)
        self.open = np.ones(cases, dtype=bool)
        self._last_whole = np.zeros(cases, dtype=int)  # the last level that came to its end
        self._taken = np.zeros(cases, dtype=int)
        self._whole = np.zeros(cases, dtype=int)  # levels in a row that came to their ends
        self._lost = np.zeros(cases, dtype=int)  # the same of those that did not, in the same way
        self._ratio = np.full(cases, 2.0)  # of the last two levels
        self._differs = np.full((cases, LEVELS_TO_STAGNATE), np.nan)  # of levels from those before, the last one first
        self._raw = np.full(cases, np.nan)  # the last one
        self._error = np.full(cases, np.nan)  # on the safe side
        self._kept = LaneResults.none_yet(spec, cases)
        self._last = np.full((cases, 0, 0), np.nan)

    def take(self, which: np.ndarray, spec: EnsembleSpec, found: LaneResults) -> None:
        """What a level has given for these cases: their errors, and what each does next."""
        steps = round(self._asked.length / spec.plan.grid.dt_L)
        values, motion = self._parts(spec, found.values)
        if not self._last.shape[1]:
            self._last = np.full((len(self.steps), *motion.shape[1:]), np.nan)
        whole = (found.status == "completed") & np.isfinite(motion).all(axis=(1, 2))
        self._judge(which, steps, whole, values, motion)
        self._note(which, steps, whole, found, values, motion)
        self._go_on(which, steps, whole)

    def _parts(self, spec: EnsembleSpec, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(what is told of cases (cases, told), motions at the times of comparison (cases, 2 n_told, N))."""
        reduced, names, marks = len(spec.reduced), spec.outputs, np.array(spec.marks)
        samples = values[:, reduced:].reshape(len(values), len(names), len(marks))
        assert spec.refinement is not None
        n = spec.compared
        at = np.searchsorted(marks, spec.refinement.places(spec.plan))
        motion = samples[:, n][:, :, at]
        if reduced:
            return values[:, :reduced], motion
        own = samples[:, : spec.refinement.asked][:, :, np.searchsorted(marks, spec.sampled)]
        return own.reshape(len(values), -1), motion

    def _judge(self, w: np.ndarray, steps: int, whole: np.ndarray, values: np.ndarray, motion: np.ndarray) -> None:
        """Errors by what levels differ from those before; by extrapolation where three of them show the order."""
        model, tolerance = self._spec.model, self._asked.tolerance
        relative, rates = errors_of_many(model, motion, self._last[w])
        estimated = relative.max(axis=1)
        asked = np.maximum(estimated, rates.max(axis=1) * tolerance / (ACCURATE * INACCURATE_ERROR))
        both = whole & (self._whole[w] > 0)
        ratio = np.where(both, steps / np.maximum(self._last_whole[w], 1), 2.0)
        raw, before, third = self._raw[w], self._differs[w, 0], both & (self._whole[w] > 1)
        with np.errstate(all="ignore"):
            shown = np.where(third, shown_orders(raw / asked, self._ratio[w], ratio), 0.0)
            raw_now = asked.copy()
            shows = third & (asked < before) & (shown > SHOWN_ORDER * self._order)
            richer = np.maximum(2.0, ratio ** np.minimum(shown, self._order) - 1)
            # levels that agree by chance: no less than the pair before lets expect
            expected = before * (1 - ratio ** -float(self._order)) / (self._ratio[w] ** self._order - 1)
            chance = third & (asked < expected)
            falls = third & (shown > LEAST_ORDER)
            share = np.where(falls, 1 / (ratio ** np.minimum(shown, MOST_ORDER * self._order) - 1), 1.0)
        asked = np.where(chance, expected, asked)
        self._error[w] = np.where(
            both, asked * np.where(shows, np.minimum(0.5, RICHARDSON_SAFETY / richer), 1.0), np.nan
        )
        share = np.where(both, share, np.nan)
        self._kept.errors[w, 0] = estimated * share
        off = self._of_outputs(values, self._kept.values[w])
        with np.errstate(divide="ignore"):
            of_steps = np.where(both, 1 / np.maximum(ratio - 1, 0.1), np.nan)
        at_ends = [how == "end" for _, how in self._spec.reduced] or [True] * off.shape[1]
        self._kept.errors[w, 1:] = off * np.where(at_ends, share[:, None], of_steps[:, None])
        self._differs[w] = np.roll(self._differs[w], 1, axis=1)
        self._differs[w, 0] = np.where(both, asked, np.nan)
        self._ratio[w], self._raw[w] = ratio, np.where(both, raw_now, np.nan)

    def _of_outputs(self, values: np.ndarray, before: np.ndarray) -> np.ndarray:
        """(cases, values told apart) by what they differ, of histories the RMS.

        What is reduced over steps, a mean or a peak, knows them at their ends only: it converges with order 1.
        """
        off: np.ndarray = np.abs(values - before)
        if self._spec.reduced:
            return off
        return np.asarray(np.sqrt(np.mean(off.reshape(len(off), len(self._spec.asked), -1) ** 2, axis=2)))

    def _note(
        self,
        w: np.ndarray,
        steps: int,
        whole: np.ndarray,
        found: LaneResults,
        values: np.ndarray,
        motion: np.ndarray,
    ) -> None:
        """What the level gave, and how it ended."""
        kept, plan = self._kept, self._spec.plan
        near = np.abs(kept.time[w] - found.time) <= ONE_END * (plan.t_end - plan.t0)
        alike = ~whole & (kept.status[w] == found.status) & near
        self._lost[w] = np.where(whole, 0, np.where(alike, self._lost[w] + 1, 1))
        self._whole[w] = np.where(whole, self._whole[w] + 1, 0)
        self._last_whole[w] = np.where(whole, steps, self._last_whole[w])
        self._taken[w] += 1
        kept.steps_of_all_levels[w] += steps * self._asked.units
        self._last[w[whole]] = motion[whole]
        kept.values[w], kept.status[w], kept.time[w] = values, found.status, found.time
        kept.status[w] = np.where((found.status == "completed") & ~whole, "not_finite", found.status)
        kept.steps[w] = self._spec.level(steps).plan.steps

    def _go_on(self, w: np.ndarray, steps: int, whole: np.ndarray) -> None:
        """Which cases are done, and the next level of the others."""
        error, tolerance = self._error[w], self._asked.tolerance
        done = whole & (self._whole[w] >= LEAST_WHOLE) & (error <= tolerance)
        ends = np.where(np.isin(self._kept.status[w], LOST_BY_COARSE_STEPS), LOST_COARSE, LOST_TWICE)
        least = np.nanmin(np.where(np.isnan(self._differs[w, 3:]), np.inf, self._differs[w, 3:]), axis=1)
        stagnant = whole & (self._taken[w] >= LEVELS_TO_STAGNATE) & ~(self._differs[w, 0] < STAGNANT_DIFFERENCE * least)
        done |= (self._lost[w] >= ends) | stagnant | (self._taken[w] >= MOST_RUNS)
        done |= self._kept.status[w] == "not_assembled"
        with np.errstate(all="ignore"):
            wanted = error.copy()
            # two levels: at what the third would leave were the order to show
            gain = np.maximum(2.0, self._ratio[w] ** self._order - 1)
            wanted = np.where(self._whole[w] == 2, wanted * np.minimum(0.5, RICHARDSON_SAFETY / gain), wanted)
            factor = (wanted / (TOLERANCE_SAFETY * tolerance)) ** (1 / self._order)
        factor = np.where(np.isfinite(factor), np.clip(factor, 2 ** (1 / self._order), MOST_GROWTH), UNBELIEVED)
        factor = np.where(whole, factor, AFTER_LOST)
        levels = self._asked.levels
        following = levels[np.minimum(np.searchsorted(levels, np.ceil(steps * factor)), len(levels) - 1)]
        spent = self._kept.steps_of_all_levels[w] + following * self._asked.units
        done |= (following <= steps) | (spent > self._asked.budget)
        self.steps[w] = np.where(done, steps, following)
        self.open[w] = ~done

    def results(self) -> LaneResults:
        """Of all cases. One that has not met the tolerance is no completed one."""
        missed = (self._kept.status == "completed") & ~(
            (self._error <= self._asked.tolerance) & (self._whole >= LEAST_WHOLE)
        )
        self._kept.status[missed] = "inaccurate"
        self._kept.errors[~np.isin(self._kept.status, ("completed", "inaccurate"))] = np.nan
        return self._kept


def shown_orders(fall: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """The orders (cases,) that three levels show whose differences fall by `fall`, see
    runtime/running/step_refinement.py.
    """
    table = (first[:, None] ** SEARCHED_ORDERS - 1) / (1 - second[:, None] ** -SEARCHED_ORDERS)
    shown = SEARCHED_ORDERS[np.minimum((table < fall[:, None]).sum(axis=1), len(SEARCHED_ORDERS) - 1)]
    return np.asarray(np.where(fall > table[:, 0], shown, 0.0))
