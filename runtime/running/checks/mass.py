"""M_hat (n_i x n_i) is finite and positive definite."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject
from runtime.schemes.scheme import Scheme

ADVICE = (
    "A deflection is too large for second-order geometric stiffening, or a mass is not positive: use more or stiffer "
    "bodies, smaller loads, or a shorter step if it grew by instability."
)


class Mass(Check):
    """`mass_not_positive`."""

    def __init__(self, subject: Subject) -> None:
        super().__init__(subject)
        self._mass = _mass(subject.model, subject.scheme)

    def start(self, z: np.ndarray) -> Status | None:
        """At the start."""
        return self._status(z, "M_hat is not positive definite at the start")

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
    seen = {**scheme.observer(z=z, c=c), "c": c[: model.c_size]}
    return ca.Function("mass", [z, c], [model.evaluate("condensed", **seen)["M_hat"]])
