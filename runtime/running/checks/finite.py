"""All numbers of z are finite."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.running.checks.step_length import step_advice
from runtime.schemes.verdict import verdict

OF_EVENTS = "Write it so that it has one wherever the motion may go: a root or logarithm of max(..., 0), no division."


class Finite(Check):
    """`not_finite`."""

    costly = False

    def _of_events(self, z: np.ndarray) -> Status | None:
        """Where nothing but the value of an event is not finite."""
        scheme = self.subject.scheme
        if "event_values" not in scheme.layout.sizes or not np.isfinite(z[scheme.layout.slice("x")]).all():
            return None
        bad = ~np.isfinite(z[scheme.layout.slice("event_values")])
        if not bad.any():
            return None
        name = scheme.model.description.events[int(np.argmax(bad))].name
        return self.subject.stop("not_finite", f"the condition of event {name} has no finite value", OF_EVENTS, z=z)

    def start(self, z: np.ndarray) -> Status | None:
        """Are the accelerations at the start finite?"""
        if np.isfinite(z).all():
            return None
        return self._of_events(z) or self.subject.stop(
            "not_finite",
            "the accelerations at the start are not finite",
            "M_hat may be singular, or a load infinite: check masses, inertias, loads and the initial position.",
            z=z,
        )

    def after(self, z: np.ndarray) -> Status | None:
        """Did a coordinate become infinite or NaN?"""
        if verdict(self.subject.scheme, z) != "not_finite":
            return None
        if (found := self._of_events(z)) is not None:
            return self.subject.stop("not_finite", found.cause, found.advice)
        x, d = z[self.subject.scheme.layout.slice("x")], self.subject.increments(z)
        bad = int(np.argmax(~np.isfinite(x) | ~np.isfinite(d)))
        return self.subject.stop("not_finite", "a coordinate became infinite or NaN", step_advice(self.subject), bad)
