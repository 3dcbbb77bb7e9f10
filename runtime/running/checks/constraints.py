"""Constraints hold at the observed state; C in units of the mechanism: metres of its size, or radians."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.contract.units import length_rows
from runtime.running.checks.check import Check, Subject
from runtime.running.checks.step_length import step_advice

CONSTRAINT_LIMIT = 1e-6  # C of the observed state, in mechanism lengths (m) or rad
DEAD_CENTRE = (
    "So the mechanism may be at a dead centre, where the chosen independent coordinates do not determine it: choose "
    "others (partition.independent), or reduce the step."
)


class Constraints(Check):
    """`constraints_lost` by the constraints themselves."""

    def __init__(self, subject: Subject) -> None:
        super().__init__(subject)
        self._lengths = length_rows(subject.model)

    def after(self, z: np.ndarray) -> Status | None:
        """Is a constraint off by more than CONSTRAINT_LIMIT?"""
        subject = self.subject
        if subject.constraints is None:
            return None
        C = np.abs(np.asarray(subject.constraints(z, subject.c)[0]).ravel())
        if (C <= CONSTRAINT_LIMIT * np.where(self._lengths, subject.length, 1.0)).all():  # NaN is off too
            return None
        return subject.stop("constraints_lost", "a constraint no longer holds", step_advice(subject, DEAD_CENTRE))
