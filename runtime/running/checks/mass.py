"""M_hat (n_i x n_i) is finite and positive definite."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.one_thread import one_thread
from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject, observed_constants
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import StageEquations, is_long_tree

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

    def matrix(self, z: np.ndarray) -> np.ndarray:
        """M_hat (n_i x n_i) at a state."""
        return self._mass(z, self.subject.c)

    def start(self, z: np.ndarray) -> Status | None:
        """At the start."""
        status = self._status(z, "M_hat is not positive definite at the start")
        if status is None:
            self._at_start = self.matrix(z)
        return status

    def explains(self, z: np.ndarray) -> Status | None:
        """Of a run that stopped behind z: is M_hat about to lose its sign there, seen from M_hat at the start?"""
        M_hat = self.matrix(z)
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
        M_hat = self.matrix(z)
        with one_thread(len(M_hat)):
            if np.isfinite(M_hat).all() and np.linalg.eigvalsh(M_hat)[0] > 0:
                return None
        return self.subject.stop("mass_not_positive", cause, ADVICE)


def _mass(model: Model, scheme: Scheme) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """(z, c) -> M_hat (n_i x n_i); of a long tree from the kinetic energy, so that M_hat is not derived for this."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    if is_long_tree(model) and model.has("energy"):
        return lambda z, c: _hessian(scheme.derived("momenta", lambda: _momenta(model, scheme)), z, c)
    seen = {**scheme.observer(z=z, c=c), "c": observed_constants(scheme, z, c)}
    function = ca.Function("mass", [z, c], [model.evaluate("condensed", **seen)["M_hat"]])
    return lambda z, c: np.asarray(function(z, c))


def _momenta(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c, q_i_dot) -> dT/dq_i_dot at the configuration that z shows, (n_i,): M_hat q_i_dot, and a constant part."""
    z, c, rates = (
        ca.SX.sym(name, size) for name, size in (("z", scheme.layout.size), ("c", scheme.c_size), ("v", len(model.q_i)))
    )
    seen, constants = scheme.observer(z=z, c=c), observed_constants(scheme, z, c)
    equations = StageEquations(model, constants)
    at = {"q_i": seen["q_i"], "q_d": seen["q_d"], "q_i_dot": rates, "t": seen["t"]}
    q_d_dot = equations.call("velocities", **at)["q_d_dot"] if model.q_d else ca.SX(0, 1)
    q, q_dot = equations.joined(seen["q_i"], seen["q_d"]), equations.joined(rates, q_d_dot)
    kinetic = equations.call("energy", q=q, q_dot=q_dot, t=seen["t"])["kinetic"]
    return ca.Function("momenta", [z, c, rates], [ca.densify(ca.gradient(kinetic, rates))])


def _hessian(momenta: ca.Function, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """M_hat column by column."""
    n = momenta.size1_in(2)
    found = np.asarray(momenta(z, c, np.hstack([np.zeros((n, 1)), np.eye(n)])))
    return np.asarray(found[:, 1:] - found[:, :1])
