"""Looks at the state of a run between native calls, by the checks of runtime/running/checks."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject
from runtime.running.checks.closure import Closure
from runtime.running.checks.constraints import Constraints
from runtime.running.checks.deflection import Deflection
from runtime.running.checks.finite import Finite
from runtime.running.checks.growth import Growth
from runtime.running.checks.iterations import Iterations
from runtime.running.checks.least_step import LeastStep
from runtime.running.checks.mass import Mass
from runtime.running.checks.step_length import StepLength
from runtime.schemes.scheme import Scheme

BREAKDOWNS = ("not_finite", "diverged", "constraints_lost", "iteration_failed")  # that M_hat may be the cause of
FULL_CHECKS = 16  # saved states; constraints and mass cost more than a short call


class Monitor:
    """Looks at z after each native call; `after` returns a Status to stop with, or None to go on.

    c (c_size,), p (n_p,): constants and parameters of the run (p: those of the model where None).
    """

    def __init__(
        self, model: Model, scheme: Scheme, c: np.ndarray, force: bool = False, p: np.ndarray | None = None
    ) -> None:
        self.subject = Subject(model, scheme, c)
        self._finite, self._step = Finite(self.subject), StepLength(self.subject, force)
        self._mass = Mass(self.subject)
        cheap = (
            Growth(self.subject),
            Closure(self.subject),
            Iterations(self.subject),
            LeastStep(self.subject),
        )
        deflection = Deflection(self.subject, model.parameter_vector() if p is None else p)
        costly = (Constraints(self.subject), self._mass, deflection, self._step)
        self.checks: list[Check] = [self._finite, *cheap, *costly]
        self._latest: np.ndarray | None = None  # the last state that passed the cheap checks
        self._samples = 0

    @property
    def step_limit(self) -> float | None:
        """The stability limit of the fastest group's step at the start [s]; None: none, or not known."""
        return self._step.limit

    def first(self, z: np.ndarray) -> Status | None:
        """Check the start (the scheme's part of z, flat), and remember what later states are compared with."""
        status = self._finite.start(z)
        if status is None:
            self.subject.begin(z)
            status = next((found for check in self.checks[1:] if (found := check.start(z)) is not None), None)
        return status

    def after(self, z: np.ndarray, last: bool = False, samples: int = 1) -> Status | None:
        """Status that ends the run, or None to go on. z is put back to the last good state when it ends.

        samples: saved states since the last call. Cheap checks follow every call; the others for the first FULL_CHECKS
        samples, then once in FULL_CHECKS of them, and at the last.
        """
        before, self._samples = self._samples, self._samples + samples
        full = last or self._samples <= FULL_CHECKS or self._samples // FULL_CHECKS > before // FULL_CHECKS
        due = (check for check in self.checks if full or not check.costly)
        status = next((found for check in due if (found := check.after(z)) is not None), None)
        if status is None:
            self._latest = z.copy()
        elif self._latest is not None and status.name in BREAKDOWNS:
            status = self._mass.explains(self._latest) or status
        if status is not None and self.subject.good is not None:
            z[:] = self.subject.good
        elif full:
            self.subject.good = z.copy()
        return status

    def memory(self) -> dict[str, list[float]]:
        """What later checks compare with, by the name of the check."""
        kept = {type(check).__name__: check.memory() for check in self.checks}
        own = {"length": [self.subject.length], "samples": [float(self._samples)]}
        return {**own, **{name: values for name, values in kept.items() if values}}

    def resume(self, z: np.ndarray, memory: Mapping[str, list[float]]) -> None:
        """Go on from a good state with the memory of an earlier monitor."""
        self.subject.good, self._latest = z.copy(), z.copy()
        self.recall(memory)

    def recall(self, memory: Mapping[str, list[float]]) -> None:
        """Compare with what `memory` holds again; the last good state stays."""
        (self.subject.length,) = memory["length"]
        self._samples = int(memory.get("samples", [self._samples])[0])
        for check in self.checks:
            if type(check).__name__ in memory:
                check.resume(memory[type(check).__name__])
