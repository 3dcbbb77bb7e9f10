"""Increments stay bounded. Angles may turn for ever, so growth is not judged on positions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.running.checks.step_length import step_advice

GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call


class Growth(Check):
    """`diverged` by the size of a step. scale: the largest position or increment at the start, at least 1."""

    costly = False
    scale = 1.0

    def start(self, z: np.ndarray) -> Status | None:
        """Remember the scale."""
        x, d = z[self.subject.scheme.layout.slice("x")], self.subject.increments(z)
        self.scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        return None

    def after(self, z: np.ndarray) -> Status | None:
        """Is an increment beyond the limit?"""
        d = np.abs(self.subject.increments(z))
        if not d.max(initial=0.0) > GROWTH_LIMIT * self.scale:
            return None
        cause = "the coordinate grows without bound"
        return self.subject.stop("diverged", cause, step_advice(self.subject), int(d.argmax()))

    def memory(self) -> list[float]:
        """[scale]."""
        return [self.scale]

    def resume(self, memory: Sequence[float]) -> None:
        """From `memory`."""
        (self.scale,) = memory
