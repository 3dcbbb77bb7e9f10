"""What a run to a tolerance needs to know before: the whole motion is tried with coarse steps first.

Steps of one length are tried (steady_trials.py): nothing of them waits for an estimate, and what is forgotten or rings
unresolved costs them nothing. Where the errors that they make differ so much from time to time that steps of varied
lengths would be fewer, those are tried too (varied_trials.py), and what takes fewer operations makes the run. Both aim
at AIM of what is asked. Of another method one trial tells most often whether it is worth more (rival_trials.py).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.running.calibration import Calibration
from runtime.running.load_steps import steps_that_see_loads
from runtime.running.passing_trials import PassingTrials
from runtime.running.rival_trials import RivalTrials
from runtime.running.segment import Segment
from runtime.running.steady_trials import SteadyTrials
from runtime.running.tried_motion import LEAST_STEPS, TrialRuns, TriedMotion
from runtime.running.varied_trials import COARSER, VariedTrials
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps

AIM = 0.6  # of what is asked: the error that is aimed at
WORTH = 1.0  # of the operations with steps of one length: where varied ones may take fewer than that, they are tried
WORTH_PASSING = 1.1  # of motions that pass singular positions
COARSE = 0.7  # of them: what the coarse trial with varied steps may take


class Trials:
    """Trials of a motion, as `runs` makes them. first: one with steps to a tolerance, where that is tried before.
    finest: the finest with steps of one length, and its error.
    """

    def __init__(self, runs: TrialRuns) -> None:
        self.runs = runs
        self.first: TriedMotion | None = None
        self.finest: tuple[TriedMotion, float] | None = None

    @property
    def expected(self) -> float:
        """Operations of the last one, also where it was given up."""
        return self.runs.expected

    def calibration(self, asked: float) -> Calibration | None:
        """For a motion with that error; None where trials told nothing, or took more than their budget."""
        with np.errstate(all="ignore"):
            steady = SteadyTrials(self.runs, self.first)
            alike = self._alike(steady, AIM * asked)
            first = steady.made[-1] if steady.made and not self.runs.passes else self.first
            if first is None:
                return None
            varied = VariedTrials(self.runs, first)
            if not self.runs.scheme.varies:
                return None if alike is None else self._told(alike)
            if alike is not None and not self._may_win(varied, steady, asked, alike.operations):
                return self._told(alike)
            other = varied.calibration(asked, AIM * asked)
            if other is not None and other.longest * self.runs.least > self.runs.span and self.runs.least > LEAST_STEPS:
                other = None  # such steps may miss a load
            found = [one for one in (alike, other) if one is not None]
            if self.finest is None and found:
                self.finest = varied.made[-1], asked
            return self._told(min(found, key=lambda one: one.operations)) if found else None

    def beside(
        self, asked: float, best: Calibration, finest: tuple[TriedMotion, float]
    ) -> tuple[Calibration | None, float]:
        """(what trials tell where this method takes fewer operations than the best one so far, else None; operations
        that it would take, as far as that is known); finest: a trial of another method, and its error.
        """
        with np.errstate(all="ignore"):
            rival = RivalTrials(self.runs, *finest)
            found = rival.searched(AIM * asked, best.operations)
            if found is None:
                return None, rival.price
            return self._told(self._of(found, rival.error)), rival.price

    def begin(self, asked: float, longest: float = np.inf) -> TriedMotion | None:
        """A first trial with steps to a tolerance, for that error; None where one of them is as long as `longest`."""
        with np.errstate(all="ignore"):
            for tolerance in self.runs.begins:
                self.first = self.runs.of_tolerance(max(tolerance, COARSER * asked), known=None, longest=longest)
                if self.first is not None:
                    break
        return self.first

    def _told(self, best: Calibration) -> Calibration:
        """With what all trials took; one that is the run takes nothing."""
        spent = self.runs.spent - (best.operations if best.states is not None else 0.0)
        alarmed, passes = self.runs.alarmed, self.runs.passes
        return replace(best, trials=self.runs.tries, tried=spent, alarmed=alarmed, passes=passes)

    def _may_win(self, varied: VariedTrials, steady: SteadyTrials, asked: float, operations: float) -> bool:
        """Are steps of varied lengths worth more trials? As far as sizes of errors tell, and then the coarse trial."""
        worth, most = (WORTH_PASSING, np.inf) if self.runs.passes else (WORTH, COARSE * operations)
        if not steady.gain_of_varied() < worth:
            return False
        coarse = varied.begin(asked, most)
        return coarse is not None and coarse.operations < steady.operations_for(coarse)

    def _alike(self, steady: SteadyTrials, error: float) -> Calibration | None:
        """With steps of one length."""
        found = steady.searched(error)
        if found is None:
            return None
        self.finest = steady.made[-1], steady.error_of(steady.made[-1])
        return self._of(found, steady.error_of(found))

    def _of(self, found: TriedMotion, error: float) -> Calibration:
        """A run with the steps of a trial."""
        told = error, found.operations, self.runs.tries, self.runs.spent, found.states, self.runs.stepper
        return Calibration(1.0, found.steady, found.low, found.high, found.steady, found.steady, *told)


def trials_of(segment: Segment, state: ConsistentState, engine: str) -> Calibration | None:
    """What trials from a state tell a run; None where the tolerance is that of steps, or there is none.

    Where they come near a singular position, other ones are runs that pass those, and exchange coordinates.
    """
    plan, scheme = segment.plan, segment.plan.scheme
    if not isinstance(scheme, AdaptiveSteps) or scheme.error_of == "step":
        return None
    least = steps_that_see_loads(segment.model, segment.c, state, plan.t0, plan.t_end, segment.switches)
    z, span = segment.start(state.q, state.q_dot), plan.t_end - plan.t0
    trials = Trials(TrialRuns(segment.stepper, z, segment.c, span, segment.switches, shown=plan.steps, least=least))
    found = trials.calibration(scheme.tolerance)
    if not trials.runs.alarmed:
        return found
    trials = Trials(PassingTrials(segment, state, engine, least=least))
    return None if trials.begin(scheme.tolerance) is None else trials.calibration(scheme.tolerance)
