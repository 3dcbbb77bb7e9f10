"""The energy of a mechanism grows by no more than the work that was done on it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject, observed
from runtime.running.checks.step_length import step_advice
from runtime.schemes.work import account_at, accounted

SETTLED = 10  # steps after which the energy of a run from rest is judged
ENERGY_LIMIT = 0.5  # spurious energy as a share of the largest kinetic and elastic energy seen
CAUSE = "energy grows by more than the work done on the mechanism"


class Energy(Check):
    """`diverged` by spurious energy.

    at_start [J]: total energy; largest [J]: kinetic plus elastic energy seen, less what is spurious; largest_work [J]:
    magnitude of the work. tried: trials have told what to expect of the run. Then its steps may be long, and its work
    known badly at first: it goes on, and its end is judged by `verdict`. worst [J], since [s]: spurious energy beyond
    the limit then, and the first time of it.
    """

    def __init__(self, subject: Subject) -> None:
        super().__init__(subject)
        self._known = accounted(subject.scheme) or subject.model.conservative
        parts = ("kinetic", "elastic", "potential")
        self._energies = observed(subject.model, subject.scheme, "energy", parts) if self._known else None
        self.at_start, self.largest, self.largest_work, self.moving_at_start = math.nan, 0.0, 0.0, 0.0
        self.tried, self.worst, self.since = False, 0.0, 0.0

    def start(self, z: np.ndarray) -> Status | None:
        """Remember the energy."""
        if self._energies is not None:
            self.moving_at_start, self.at_start = self._measured(z)
            self.largest = max(self.largest, self.moving_at_start)
        return None

    def after(self, z: np.ndarray) -> Status | None:
        """Has spurious energy reached ENERGY_LIMIT of the largest kinetic and elastic energy seen?"""
        if self._energies is None:
            return None
        moving, total = self._measured(z)
        work, doubt = account_at(self.subject.scheme, z, self.subject.c)
        spurious = total - self.at_start - work - doubt
        self.largest_work = max(self.largest_work, abs(work))
        self.largest = max(self.largest, moving - max(spurious, 0.0))  # what grew by itself is no measure
        if spurious <= ENERGY_LIMIT * max(self.largest, self.largest_work) or self._too_early(
            z, moving
        ):  # false for NaN
            return None
        if self.tried and math.isfinite(spurious):
            self.since = self.since if self.worst else self.subject.time(z)
            self.worst = max(self.worst, spurious)
            return None
        fastest = int(np.abs(self.subject.scheme.rates(z)).argmax())
        return self.subject.stop("diverged", CAUSE, step_advice(self.subject), fastest)

    def verdict(self) -> Status | None:
        """At the end of a run that went on: was it too much beside all that the run has seen?"""
        if not self.worst > ENERGY_LIMIT * max(self.largest, self.largest_work):
            return None
        return Status("diverged", self.since, None, CAUSE, step_advice(self.subject))

    def _too_early(self, z: np.ndarray, moving: float) -> bool:
        """From rest, energies of the first steps are as small as their errors."""
        steps = float(z[self.subject.scheme.layout.slice("n")][0])
        return steps < SETTLED and self.moving_at_start < ENERGY_LIMIT * moving

    def _measured(self, z: np.ndarray) -> tuple[float, float]:
        """(kinetic plus elastic energy, a negative one of springs that push by its magnitude; total energy) [J]."""
        assert self._energies is not None
        kinetic, elastic, potential = (float(value) for value in self._energies(z, self.subject.c))
        return kinetic + abs(elastic), kinetic + elastic + potential

    def memory(self) -> list[float]:
        """[at_start, largest, largest_work, moving_at_start], and of a run that was tried [worst, since]."""
        seen = [self.at_start, self.largest, self.largest_work, self.moving_at_start]
        return [*seen, self.worst, self.since] if self.tried else seen

    def resume(self, memory: Sequence[float]) -> None:
        """From `memory`."""
        self.at_start, self.largest, self.largest_work, self.moving_at_start = memory[:4]
        if len(memory) > 4:
            self.tried, (self.worst, self.since) = True, memory[4:]
