"""Watching the determinants of the loop blocks: a small one says that q_i is about to lose its meaning.

The steps themselves keep the smallest and the largest determinant of each block (two operations a closure); what is
judged here is only looked at between native calls.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from runtime.contract.coordinates import parts, rate_parts
from runtime.contract.model import EmittedModel

NEAR_SINGULAR_DETERMINANT = (
    0.15  # of the largest determinant so far: below this a better q_i, or a singular position, is looked for
)
LOWERED = 0.3  # times the threshold, where nothing better was found and no singular position lies ahead
LAST_THRESHOLD = 0.05  # threshold below which a run without the variant that it needs stops
LEAST_THRESHOLD = 1e-4  # threshold below which looking again is of no use


@dataclass
class SingularityMonitor:
    """largest magnitude and last sign of each determinant, and the share of it below which steps are near-singular."""

    largest: np.ndarray = field(default_factory=lambda: np.zeros(0))
    sign: np.ndarray = field(default_factory=lambda: np.zeros(0))
    threshold: float = NEAR_SINGULAR_DETERMINANT

    @classmethod
    def of(cls, blocks: int) -> SingularityMonitor:
        """That has seen nothing yet."""
        return cls(np.zeros(blocks), np.zeros(blocks))

    def near_singular(self, low: np.ndarray, high: np.ndarray) -> bool:
        """Is a determinant of some steps below its share of the largest so far, or has one changed its sign?"""
        if not len(low):
            return False
        largest = np.maximum(self.largest, np.maximum(np.abs(low), np.abs(high)))
        changed = (np.sign(low) * np.sign(high) <= 0) | (self.sign * np.sign(low) < 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            shares = np.where(changed, -1.0, np.minimum(np.abs(low), np.abs(high)) / largest)
        return bool(shares.min() < self.threshold)

    def accept(self, low: np.ndarray, high: np.ndarray) -> None:
        """Remember steps that are not near-singular."""
        self.largest = np.maximum(self.largest, np.maximum(np.abs(low), np.abs(high)))
        self.sign = np.sign(low)

    def worst(self, values: np.ndarray) -> int:
        """The block whose determinant is smallest, relative to its largest."""
        return int(np.argmin(np.abs(values) / np.maximum(self.largest, 1e-300)))

    def lower(self) -> None:
        """Look again when the determinant is smaller still."""
        self.threshold *= LOWERED

    def give_up(self) -> None:
        """Looking again is of no use: the next near-singular step is taken unmonitored."""
        self.threshold = LOWERED * LEAST_THRESHOLD

    def passed(self) -> None:
        """A singular position lies behind: signs may have changed."""
        self.sign, self.threshold = np.zeros(len(self.largest)), NEAR_SINGULAR_DETERMINANT

    def memory(self) -> list[list[float]]:
        """In plain numbers."""
        return [self.largest.tolist(), self.sign.tolist(), [self.threshold]]

    @classmethod
    def remembered(cls, memory: list[list[float]]) -> SingularityMonitor:
        """From `memory`."""
        return cls(np.array(memory[0]), np.array(memory[1]), float(memory[2][0]))


# Numbers of a model along a motion: C_q, and the determinants of the loop blocks with their rates.


class LoopDeterminants:
    """Evaluations on all coordinates q and q_dot of one model with constants c."""

    def __init__(self, model: EmittedModel, c: np.ndarray) -> None:
        self.model, self.c = model, c
        self._determinants = model.derived("determinants_along", lambda: _determinants(model))

    def jacobian(self, t: float, q: np.ndarray) -> np.ndarray:
        """C_q (rows x coordinates)."""
        found = self.model.evaluate("constraints", q=q, q_dot=np.zeros(len(q)), t=t, c=self.c)["C_q"]
        return np.asarray(found).reshape(len(self.model.constraints), len(q))

    def determinants(self, t: float, q: np.ndarray, q_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(determinant of each loop block, its rate [1/s])."""
        found = self._determinants(t, *parts(self.model, q), *rate_parts(self.model, q, q_dot), self.c)
        values, slopes = found
        return np.asarray(values).ravel(), np.asarray(slopes).ravel()


def _determinants(model: EmittedModel) -> ca.Function:
    """(t, q_i, q_d, q_i_dot, q_d_dot, c) -> det_loop and its rate."""
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    q_i, q_d = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("q_d", len(model.q_d))
    v_i, v_d = ca.SX.sym("v_i", len(model.q_i)), ca.SX.sym("v_d", len(model.q_d))
    found = model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)["det_loop"]
    rate = ca.jtimes(found, q_i, v_i) + ca.jtimes(found, q_d, v_d) + ca.jtimes(found, t, ca.SX(1))
    return ca.Function("determinants_along", [t, q_i, q_d, v_i, v_d, c], [found, rate])
