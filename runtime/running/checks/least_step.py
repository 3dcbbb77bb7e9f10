"""Steps that follow from a tolerance do not shrink without end."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps


class LeastStep(Check):
    """`step_too_short`."""

    costly = False

    def after(self, z: np.ndarray) -> Status | None:
        """Was a step rejected that is as short as steps may be?"""
        scheme = self.subject.scheme
        if not isinstance(scheme, AdaptiveSteps) or not scheme.is_stuck(z):
            return None
        return self.subject.stop(
            "step_too_short",
            f"the least step does not meet the tolerance {scheme.tolerance:g} behind t = {scheme.reached(z):.9g} s",
            "A force or a rate may grow without bound there, or jump at a time that depends on the motion: look at the "
            "motion until then, raise the tolerance, or take a scheme with steps of one length.",
        )
