"""What a run to a tolerance needs to know before: the whole motion is tried with coarse steps first.

A first trial tells the amplitudes by which errors are measured. Then steps of one length are tried (steady_trials.py):
nothing of them waits for an estimate, and what is forgotten or rings unresolved costs them nothing. Where the errors
that they make differ so much from time to time that steps of varied lengths would be fewer, those are tried too
(varied_trials.py), and what takes fewer operations makes the run. Both aim at AIM of what is asked.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.running.calibration import Calibration
from runtime.running.passing_trials import PassingTrials
from runtime.running.segment import Segment
from runtime.running.steady_trials import SteadyTrials
from runtime.running.tried_motion import SEEN, TrialRuns, TriedMotion
from runtime.running.varied_trials import COARSER, VariedTrials
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps

AIM = 0.6  # of what is asked: the error that is aimed at
WORTH = 1.1  # of the operations with steps of one length: where varied ones may take fewer than that, they are tried


class Trials:
    """Trials of a motion, as `runs` makes them. first: the first one."""

    def __init__(self, runs: TrialRuns) -> None:
        self.runs = runs
        self.first: TriedMotion | None = None

    @property
    def expected(self) -> float:
        """Operations of the coarsest, also where it was given up."""
        return self.runs.expected

    def calibration(self, asked: float) -> Calibration | None:
        """For a motion with that error; None where trials told nothing, or took more than their budget."""
        found = self._found(asked)
        return None if found is None else replace(found, alarmed=self.runs.alarmed, passes=self.runs.passes)

    def _found(self, asked: float) -> Calibration | None:
        with np.errstate(all="ignore"):
            first = self.first or self.begin(asked)
            if first is None:
                return None
            steady = SteadyTrials(self.runs, first)
            alike = self._alike(steady, AIM * asked)
            varied = VariedTrials(self.runs, first)
            if alike is not None and not self._may_win(varied, steady, asked):
                return alike
            found = [one for one in (alike, varied.calibration(asked, AIM * asked)) if one is not None]
            if not found:
                return None
            best = min(found, key=lambda one: one.operations)
            return replace(best, trials=self.runs.tries, tried=self.runs.spent)

    def begin(self, asked: float) -> TriedMotion | None:
        """The first trial for that error."""
        with np.errstate(all="ignore"):
            for tolerance in self.runs.begins:
                self.first = self.runs.of_tolerance(max(tolerance, COARSER * asked), known=None)
                if self.first is not None:
                    break
        return self.first

    @staticmethod
    def _may_win(varied: VariedTrials, steady: SteadyTrials, asked: float) -> bool:
        """Are steps of varied lengths worth more trials? As far as sizes of errors tell, and then the coarse trial."""
        if not steady.gain_of_varied() < WORTH:
            return False
        coarse = varied.begin(asked)
        return coarse is not None and coarse.operations < steady.operations_for(coarse)

    def _alike(self, steady: SteadyTrials, error: float) -> Calibration | None:
        """With steps of one length."""
        found = steady.searched(error)
        if found is None:
            return None
        told = steady.error_of(found), found.operations, self.runs.tries, self.runs.spent
        lengths = found.steady, found.low, found.high, found.steady, found.steady
        return Calibration(1.0, *lengths, *told)


def trials_of(segment: Segment, state: ConsistentState, engine: str) -> Calibration | None:
    """What trials from a state tell a run; None where the tolerance is that of steps, or there is none.

    Where the first one comes near a singular position, they are runs that pass those, and exchange coordinates.
    """
    plan, scheme = segment.plan, segment.plan.scheme
    if not isinstance(scheme, AdaptiveSteps) or scheme.error_of == "step":
        return None
    span = plan.t_end - plan.t0
    z = segment.stepper.start(plan.t0, state.q, state.q_dot, segment.c, span / SEEN)
    trials = Trials(TrialRuns(segment.stepper, z, segment.c, span, segment.switches))
    lost = trials.begin(scheme.tolerance) is None
    if trials.runs.alarmed:
        trials = Trials(PassingTrials(segment, state, engine))
    elif lost:
        return None
    return trials.calibration(scheme.tolerance)
