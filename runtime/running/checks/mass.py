"""M_hat (n_i x n_i) is finite and positive definite."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject, observed_constants
from runtime.schemes.scheme import Scheme

NEARLY_LOST = 0.1  # of M_hat at the start: below this a breakdown of the numbers is laid to it
ADVICE = (
    "A deflection is too large for second-order geometric stiffening, or a mass is not positive: use more or stiffer "
    "bodies, smaller loads, or a shorter step if it grew by instability."
)


class Mass(Check):
    """`mass_not_positive`."""

    def __init__(self, subject: Subject) -> None:
        super().__init__(subject)
        self._mass = _mass(subject.model, subject.scheme)
        self._at_start: np.ndarray | None = None

    def start(self, z: np.ndarray) -> Status | None:
        """At the start."""
        status = self._status(z, "M_hat is not positive definite at the start")
        if status is None:
            self._at_start = np.asarray(self._mass(z, self.subject.c))
        return status

    def explains(self, z: np.ndarray) -> Status | None:
        """Of a run that stopped behind z: is M_hat about to lose its sign there, seen from M_hat at the start?"""
        M_hat = np.asarray(self._mass(z, self.subject.c))
        if self._at_start is None or not np.isfinite(M_hat).all():
            return None
        inverse = np.linalg.inv(np.linalg.cholesky(self._at_start))
        left = float(np.linalg.eigvalsh(inverse @ M_hat @ inverse.T)[0])
        if left > NEARLY_LOST:
            return None
        return self.subject.stop(
            "mass_not_positive",
            f"M_hat has lost all but {max(left, 0.0):.2g} of what it was at the start, in one direction",
            ADVICE,
        )

    def after(self, z: np.ndarray) -> Status | None:
        """On the way."""
        return self._status(z, "M_hat is no longer positive definite")

    def _status(self, z: np.ndarray, cause: str) -> Status | None:
        M_hat = np.asarray(self._mass(z, self.subject.c))
        if np.isfinite(M_hat).all() and np.linalg.eigvalsh(M_hat)[0] > 0:
            return None
        return self.subject.stop("mass_not_positive", cause, ADVICE)


def _mass(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c) -> M_hat."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    seen = {**scheme.observer(z=z, c=c), "c": observed_constants(scheme, z, c)}
    return ca.Function("mass", [z, c], [model.evaluate("condensed", **seen)["M_hat"]])
