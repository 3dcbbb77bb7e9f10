"""All numbers of z are finite."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.running.checks.step_length import step_advice
from runtime.schemes.verdict import verdict


class Finite(Check):
    """`not_finite`."""

    costly = False

    def start(self, z: np.ndarray) -> Status | None:
        """Are the accelerations at the start finite?"""
        if np.isfinite(z).all():
            return None
        return self.subject.stop(
            "not_finite",
            "the accelerations at the start are not finite",
            "M_hat may be singular: check masses, inertias and the initial position.",
            z=z,
        )

    def after(self, z: np.ndarray) -> Status | None:
        """Did a coordinate become infinite or NaN?"""
        if verdict(self.subject.scheme, z) != "not_finite":
            return None
        x, d = z[self.subject.scheme.layout.slice("x")], self.subject.increments(z)
        bad = int(np.argmax(~np.isfinite(x) | ~np.isfinite(d)))
        return self.subject.stop("not_finite", "a coordinate became infinite or NaN", step_advice(self.subject), bad)
