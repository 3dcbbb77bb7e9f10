"""The updates of all steps converged."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.schemes.verdict import verdict


class Iterations(Check):
    """`iteration_failed`."""

    costly = False

    def after(self, z: np.ndarray) -> Status | None:
        """Did an update use up its iterations?"""
        scheme = self.subject.scheme
        if verdict(scheme, z) != "iteration_failed":
            return None
        return self.subject.stop(
            "iteration_failed",
            f"the update of a step did not converge in {scheme.iteration_limit} iterations",
            "Use a smaller step, a larger eps, or (printed) common_update = direct.",
        )
