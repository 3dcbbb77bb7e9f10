"""Is another method worth it? A trial with a share of the operations of the best so far, seen beside that one's finest.

Its error is many times what is aimed at, so it is told well by a motion that has about that. The order of the method
takes it on to the number of steps that a run would take. Where that is worth it, these very steps are tried: they are
taken if the motion is where the other method's is, as far as both may be off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.running.steady_trials import APART, LOST, ROUGH
from runtime.running.tried_motion import TrialRuns, TriedMotion

WORTH = 0.9  # of the operations of the best: what may take more is not worth it
SHARES = (0.5, 0.75)  # of these, of the first trial: the less, the more its error may be over what is aimed at
AGREES = 1.5  # times what both motions may be off
SAME = 1.05  # of the steps of the first trial: that is the run then
MOST = 2  # trials with steps that the run may take


@dataclass
class RivalTrials:
    """runs: makes trials; finest: a trial of another method, off: its error. After a search, price: operations that a
    run would take, as far as that is known; error: that is expected of it.
    """

    runs: TrialRuns
    finest: TriedMotion
    off: float
    price: float = np.inf
    error: float = np.inf

    def searched(self, error: float, operations: float) -> TriedMotion | None:
        """The trial that should have an error with fewer operations than the best method; None if there is none."""
        scheme, span = self.runs.scheme, self.runs.span
        each = scheme.operations_of_plain(self.runs.stepper.program)
        most, order = WORTH * operations / each, scheme.order
        self.price = self.runs.least * each
        if most < self.runs.least:
            return None
        share = min(max((error / ROUGH) ** (1 / order), SHARES[0]), SHARES[1])
        count = max(share * most, self.runs.least)
        one = self.runs.of_length(span / count, self.finest, keep=True)
        found = np.inf if one is None else self.runs.error(one, self.finest) + self.off
        wanted = max(count * (found / error) ** (1 / order), self.runs.least)
        self.price = wanted * each if found < LOST else np.inf
        for _ in range(MOST):
            if not self.price <= WORTH * operations:
                return None
            if not count <= wanted < SAME * count:
                one = self.runs.of_length(span / wanted, self.finest, keep=True)
            if one is None:
                return None
            apart = self.runs.error(one, self.finest)
            self.error = max(found * (count / wanted) ** order, apart - self.off)
            if apart < AGREES * (error + self.off):
                return one
            found, count = apart + self.off, wanted
            wanted = max(count * (found / error) ** (1 / order), APART * count)
            self.price = wanted * each
        return None
