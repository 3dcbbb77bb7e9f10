"""The loop closure was near its solution before Newton, so that it stays on its branch."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.running.checks.constraints import DEAD_CENTRE
from runtime.running.checks.step_length import step_advice

CLOSURE_LIMIT = 1e-2  # C before the last Newton step, in mechanism lengths; quadratic convergence leaves its square


class Closure(Check):
    """`constraints_lost` by the closure of the steps."""

    costly = False

    def after(self, z: np.ndarray) -> Status | None:
        """How far was the closure off, at most?"""
        subject = self.subject
        if not z[subject.scheme.layout.slice("closure_error")][0] > CLOSURE_LIMIT * subject.length:
            return None
        cause = "the loop closure moves too far in one step for Newton"
        return subject.stop("constraints_lost", cause, step_advice(subject, DEAD_CENTRE))
