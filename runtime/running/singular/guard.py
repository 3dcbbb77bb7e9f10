"""Watching the determinants of the loop blocks: a small one says that q_i is about to lose its meaning.

The steps themselves keep the smallest and the largest determinant of each block (two operations a closure); what is
judged here is only looked at between native calls.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from runtime.contract.status import Status

NEAR = 0.15  # of the largest determinant so far: below this a better q_i, or a singular position, is looked for
LOWERED = 0.3  # times the threshold, where nothing better was found and no singular position lies ahead
LAST = 0.05  # threshold below which a run without the variant that it needs stops
FLOOR = 1e-4  # threshold below which looking again is of no use


@dataclass
class Guard:
    """largest magnitude and last sign of each block's determinant, and the share that raises the alarm."""

    largest: np.ndarray = field(default_factory=lambda: np.zeros(0))
    sign: np.ndarray = field(default_factory=lambda: np.zeros(0))
    threshold: float = NEAR

    @classmethod
    def of(cls, blocks: int) -> Guard:
        """That has seen nothing yet."""
        return cls(np.zeros(blocks), np.zeros(blocks))

    def share(self, low: np.ndarray, high: np.ndarray) -> float:
        """The smallest determinant of some steps as a share of the largest so far; negative if one changed its sign."""
        if not len(self.largest):
            return 1.0
        largest = np.maximum(self.largest, np.maximum(np.abs(low), np.abs(high)))
        changed = (low * high <= 0) | (self.sign * low < 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            shares = np.where(changed, -1.0, np.minimum(np.abs(low), np.abs(high)) / largest)
        return float(shares.min())

    def alarm(self, low: np.ndarray, high: np.ndarray) -> bool:
        """Is a determinant below the threshold, or has it changed its sign?"""
        return self.share(low, high) < self.threshold

    def accept(self, low: np.ndarray, high: np.ndarray) -> None:
        """Remember steps without alarm."""
        self.largest = np.maximum(self.largest, np.maximum(np.abs(low), np.abs(high)))
        self.sign = np.sign(low)

    def worst(self, values: np.ndarray) -> int:
        """The block whose determinant is smallest, relative to its largest."""
        return int(np.argmin(np.abs(values) / np.maximum(self.largest, 1e-300)))

    def lower(self) -> None:
        """Look again when the determinant is smaller still."""
        self.threshold *= LOWERED

    def give_up(self) -> None:
        """Looking again is of no use: the next step in alarm is taken unguarded."""
        self.threshold = LOWERED * FLOOR

    def passed(self) -> None:
        """A singular position lies behind: signs may have changed."""
        self.sign, self.threshold = np.zeros(len(self.largest)), NEAR

    def memory(self) -> list[list[float]]:
        """In plain numbers."""
        return [self.largest.tolist(), self.sign.tolist(), [self.threshold]]

    @classmethod
    def remembered(cls, memory: list[list[float]]) -> Guard:
        """From `memory`."""
        return cls(np.array(memory[0]), np.array(memory[1]), float(memory[2][0]))


def lost_unguarded(time: float) -> Status:
    """Of a run whose next step after `time` [s] had to be taken although the guard gave alarm."""
    cause = "the loop closure is singular within the next step"
    return Status("branch_lost", time, None, cause, "Reduce the step, start elsewhere, or change a length a little.")
