"""What a check is, and what it looks at."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined
from runtime.contract.model import Model
from runtime.contract.status import Status, StatusName
from runtime.contract.units import mechanism_length
from runtime.schemes.scheme import Scheme


class Subject:
    """A scheme on a model with the model's constants c (c_size,), and the last z that passed all checks.

    length [m]: size of the mechanism, from the lever arms in C_q at the start; 1 without constraints.
    """

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray) -> None:
        self.model, self.scheme, self.c = model, scheme, scheme.constants(c)
        self.good: np.ndarray | None = None
        self.length = 1.0
        self.constraints = observed(model, scheme, "constraints", ("C", "C_q")) if _constrained(model) else None

    def begin(self, z: np.ndarray) -> None:
        """Take the start for good, and the mechanism's size from it."""
        self.good = z.copy()
        if self.constraints is not None:
            self.length = mechanism_length(self.model, np.asarray(self.constraints(z, self.c)[1]))

    def time(self, z: np.ndarray) -> float:
        """Time of a state [s]."""
        layout = self.scheme.layout
        return float(z[layout.slice("t0")][0] + z[layout.slice("n")][0] * self.scheme.grid.dt_L)

    def increments(self, z: np.ndarray) -> np.ndarray:
        """About what each coordinate of q_i (n_i,) moves in a step."""
        return np.asarray(self.scheme.rates(z) * self.scheme.step_sizes)

    def stop(
        self, name: StatusName, cause: str, advice: str, k: int | None = None, z: np.ndarray | None = None
    ) -> Status:
        """The status that ends a run at its last good state, or at z; k: position in q_i of what is to blame."""
        state = z if self.good is None or z is not None else self.good
        assert state is not None
        return Status(name, self.time(state), None if k is None else self.model.q_i[k], cause, advice)


class Check:
    """Looks at z; a Status ends the run, None lets it go on. costly: more than a short native call."""

    costly = True

    def __init__(self, subject: Subject) -> None:
        self.subject = subject

    def start(self, z: np.ndarray) -> Status | None:
        """At the start of a run."""
        return None

    def after(self, z: np.ndarray) -> Status | None:
        """After a native call."""
        return None

    def memory(self) -> list[float]:
        """What later checks compare with."""
        return []

    def resume(self, memory: Sequence[float]) -> None:
        """Go on with the memory of an earlier check of the same kind."""


def observed(model: Model, scheme: Scheme, name: str, outputs: Sequence[str]) -> ca.Function:
    """(z, c) -> outputs of a kernel of (q, q_dot, t) at the state that z shows; built once for a scheme."""
    return scheme.derived(f"observed {name}", lambda: _observed(model, scheme, name, outputs))


def _observed(model: Model, scheme: Scheme, name: str, outputs: Sequence[str]) -> ca.Function:
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    seen = scheme.observer(z=z, c=c)
    q, q_dot = joined(model, seen["q_i"], seen["q_d"]), joined(model, seen["q_i_dot"], seen["q_d_dot"])
    found = model.evaluate(name, q=q, q_dot=q_dot, t=seen["t"], c=observed_constants(scheme, z, c))
    return ca.Function(f"observed_{name}", [z, c], [found[output] for output in outputs])


def observed_constants(scheme: Scheme, z: ca.SX, c: ca.SX) -> ca.SX:
    """The model's constants at a state, with the inputs that it holds."""
    return scheme.constants_at(scheme.layout.unpack(z[: scheme.layout.size]), c[: scheme.model.c_size])


def _constrained(model: Model) -> bool:
    return bool(model.constraints) and model.has("constraints")
