"""What is kept of every lane at each major step: is it alive, why not, and what its outputs come to.

causes: 0 while nothing is wrong with a lane, then what was at the first step at which something was, as a sum of powers
of two in the order of CAUSES; reached: steps that were good.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np

from runtime.contract.status import StatusName
from runtime.engine.program import Fields
from runtime.running.monitor import CLOSURE_LIMIT
from runtime.running.singular.guard import NEAR
from runtime.running.stepped_model import HIGHEST, LOWEST
from runtime.schemes.scheme import Scheme

# in the order in which they are looked for; `singular` is no end: that case is run by itself
CAUSES: tuple[StatusName | str, ...] = (
    "singular",
    "iteration_failed",
    "not_finite",
    "constraints_lost",
)

Step = Callable[[ca.SX, ca.SX], ca.SX]
# name: (at the start, with one more value)
REDUCTIONS: dict[str, tuple[Callable[[ca.SX], ca.SX], Step]] = {
    "max": (lambda y: y, ca.fmax),
    "min": (lambda y: y, ca.fmin),
    "peak": (ca.fabs, lambda kept, y: ca.fmax(kept, ca.fabs(y))),
    "mean": (lambda y: y, lambda kept, y: kept + y),
    "rms": (lambda y: y * y, lambda kept, y: kept + y * y),
    "end": (lambda y: y, lambda kept, y: y),
}


class LaneAccount:
    """Fields of z and the stage that keeps them; reduced: (position in `outputs`, reduction) of each value kept.

    length [m]: size of the mechanism, which closure errors are compared with.
    """

    def __init__(self, scheme: Scheme, reduced: list[tuple[int, str]], length: float) -> None:
        self.scheme, self.reduced, self.length = scheme, reduced, length
        self.blocks = scheme.layout.sizes["det_low"]

    @property
    def fields(self) -> dict[str, int]:
        """What is kept in z."""
        return {"causes": 1, "reached": 1, "largest": self.blocks, "before": self.blocks, "reduced": len(self.reduced)}

    def begin(self, z: Fields) -> Mapping[str, ca.SX]:
        """At the start, step 0."""
        zeros = ca.SX.zeros(self.blocks)
        values = [REDUCTIONS[name][0](z["outputs"][k]) for k, name in self.reduced]
        lost = ca.logic_not(self.scheme.alive(self.scheme.layout.unpack(z["scheme"])))
        start = {"causes": lost * 2 ** CAUSES.index("not_finite"), "reached": ca.SX(0), "largest": zeros}
        return {**start, "before": zeros, "reduced": ca.vertcat(*values) if values else ca.SX(0, 1)}

    def step(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        """After one more major step."""
        s = self.scheme.layout.unpack(z["scheme"])
        alarm, account = self._guarded(z, s)
        none, scheme = ca.SX(0), self.scheme
        found = {
            "singular": alarm,
            "iteration_failed": none if scheme.iteration_limit is None else s["failures"] > 0,
            "not_finite": ca.logic_not(scheme.alive(s)),
            "constraints_lost": s["closure_error"] > CLOSURE_LIMIT * self.length if self.blocks else none,
        }
        now = ca.SX(0)
        for k, name in enumerate(CAUSES):
            now = now + found[name] * 2**k
        causes = z["causes"] + (z["causes"] <= 0) * now
        values = [REDUCTIONS[name][1](z["reduced"][n], z["outputs"][k]) for n, (k, name) in enumerate(self.reduced)]
        return {
            **account,
            "causes": causes,
            "reached": z["reached"] + (causes <= 0),
            "reduced": ca.vertcat(*values) if values else ca.SX(0, 1),
        }

    def _guarded(self, z: Fields, s: Fields) -> tuple[ca.SX, dict[str, ca.SX]]:
        """(is the determinant of a loop block small, or has it changed its sign?, what is kept of them).

        See runtime/running/singular/guard.
        """
        alarm, largest = ca.SX(0), ca.SX(z["largest"])
        for k in range(self.blocks):
            low, high = s["det_low"][k], s["det_high"][k]
            least, most = ca.fmin(ca.fabs(low), ca.fabs(high)), ca.fmax(ca.fabs(low), ca.fabs(high))
            largest[k] = ca.fmax(most, largest[k])
            changed = ca.logic_or(low * high <= 0, z["before"][k] * low < 0)
            alarm = ca.logic_or(alarm, ca.logic_or(least < NEAR * largest[k], changed))
        fresh = {"det_low": LOWEST * ca.SX.ones(self.blocks), "det_high": HIGHEST * ca.SX.ones(self.blocks)}
        state = self.scheme.layout.pack({**s, **fresh})
        return alarm, {"scheme": state, "largest": largest, "before": s["det_high"]}


def cause_of(causes: np.ndarray) -> np.ndarray:
    """Names of the first of CAUSES in sums of their powers of two, "completed" for zero."""
    found = np.full(causes.shape, "completed", dtype="U20")
    for k in reversed(range(len(CAUSES))):
        found[(causes.astype(int) >> k) & 1 > 0] = CAUSES[k]
    return found
