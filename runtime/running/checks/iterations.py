"""The updates of all steps converged."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.schemes.verdict import verdict

NEARLY_SINGULAR = 0.05  # smallest of the largest singular value of C_q, angles counted times the mechanism's length


class Iterations(Check):
    """`iteration_failed`."""

    costly = False

    def after(self, z: np.ndarray) -> Status | None:
        """Did an update use up its iterations?"""
        scheme, singular = self.subject.scheme, self._singular()
        if verdict(scheme, z) != "iteration_failed":
            return None
        return self.subject.stop(
            "iteration_failed",
            f"the update of a step did not converge in {scheme.iteration_limit} iterations",
            singular or scheme.if_not_converged,
        )

    def _singular(self) -> str:
        """Advice for a scheme on all coordinates whose last good state is near a position where C_q loses rank."""
        subject = self.subject
        if subject.scheme.closes or subject.constraints is None or subject.good is None:
            return ""
        C_q = np.asarray(subject.constraints(subject.good, subject.c)[1])[subject.model.kept_rows]
        scale = np.where([entry.unit == "m" for entry in subject.model.description.coordinates], 1.0, subject.length)
        values = np.linalg.svd(C_q / scale, compute_uv=False)
        if not values[-1] < NEARLY_SINGULAR * values[0]:
            return ""
        return (
            "The mechanism is near a singular position, where C_q loses rank and the multipliers are not determined: "
            "take a scheme that steps over it (single_rate, rk4, dop853), or stop before it."
        )
