"""Energy of a mechanism that no load and no prescribed motion feeds can only stay or fall."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject, observed
from runtime.running.checks.step_length import step_advice

ENERGY_LIMIT = 0.5  # spurious energy as a share of the largest kinetic and elastic energy seen


class Energy(Check):
    """`diverged` by spurious energy. at_start [J]: total energy; largest [J]: kinetic plus elastic energy seen."""

    def __init__(self, subject: Subject) -> None:
        super().__init__(subject)
        parts = ("kinetic", "elastic", "potential")
        self._energies = (
            observed(subject.model, subject.scheme, "energy", parts) if subject.model.conservative else None
        )
        self.at_start, self.largest = math.nan, 0.0

    def start(self, z: np.ndarray) -> Status | None:
        """Remember the energy."""
        if self._energies is not None:
            moving, self.at_start = self._measured(z)
            self.largest = max(self.largest, moving)
        return None

    def after(self, z: np.ndarray) -> Status | None:
        """Has spurious energy reached ENERGY_LIMIT of the largest kinetic and elastic energy seen?"""
        if self._energies is None:
            return None
        moving, total = self._measured(z)
        self.largest = max(self.largest, moving)
        if total - self.at_start <= ENERGY_LIMIT * self.largest:  # false for NaN
            return None
        fastest = int(np.abs(self.subject.scheme.rates(z)).argmax())
        cause = "energy grows although nothing feeds the mechanism"
        return self.subject.stop("diverged", cause, step_advice(self.subject), fastest)

    def _measured(self, z: np.ndarray) -> tuple[float, float]:
        """(kinetic plus elastic energy, total energy) [J]."""
        assert self._energies is not None
        kinetic, elastic, potential = (float(value) for value in self._energies(z, self.subject.c))
        return kinetic + elastic, kinetic + elastic + potential

    def memory(self) -> list[float]:
        """[at_start, largest]."""
        return [self.at_start, self.largest]

    def resume(self, memory: Sequence[float]) -> None:
        """From `memory`."""
        self.at_start, self.largest = memory
