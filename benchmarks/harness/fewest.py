"""The fewest steps with which a method stays below an error, judged by a reference, and the time that these take."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from runtime.running.method_choice import FIRST_LEVEL_STEPS, Method
from runtime.running.step_refinement import StepRefinement
from runtime.studies.advice.reference import Reference
from runtime.studies.advice.trial import Trial, trial_of

REFINEMENTS = 4  # halvings of the interval (in logarithm) between too few steps and enough
HOPELESSLY_SLOW = 2.0  # times what is to be beaten
CHEAP = 0.02  # s: a run this short is never given up for its length


@dataclass
class Timed:
    """A method on a motion; operations: of a step, known after a run."""

    method: Method
    reference: Reference
    operations: int = field(default=0, init=False)

    def run(self, steps: int) -> Trial:
        """The whole motion in so many steps."""
        refinement = StepRefinement(self.reference.problem, 1e-12)
        level = refinement.level(refinement.plan(self.method, steps))
        self.operations = level.run.segment.stepper.operations
        return trial_of(self.method.label, level, self.reference)


def fewest(timed: Timed, error: float, most: int = 10**8, seconds_to_beat: float = np.inf) -> Trial | None:
    """The run; None where the steps would be too many, or take far longer than what is to be beaten [s]."""
    low, best, steps = 0, None, FIRST_LEVEL_STEPS
    while best is None:
        found = timed.run(steps)
        if found.error <= error:
            best = found
        elif steps >= most or found.seconds > max(CHEAP, HOPELESSLY_SLOW * seconds_to_beat):
            return None
        else:
            low, steps = steps, min(most, 2 * steps)
    for _ in range(REFINEMENTS):
        middle = round((low * best.steps) ** 0.5)
        if middle in (low, best.steps) or middle < FIRST_LEVEL_STEPS:
            break
        found = timed.run(middle)
        low, best = (low, found) if found.error <= error else (middle, best)
    return best
