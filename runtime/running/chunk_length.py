"""How many steps a native call makes, so that progress and Ctrl-C stay responsive and looks at states are few."""

from __future__ import annotations

from dataclasses import dataclass

CALL_SECONDS = 0.25  # a call lasts about this long
OPERATIONS = 5_000_000  # of a first call
MOST_STEPS_OF_CALL = 1 << 20
FIRST_SAVED = 32  # of the first look: what goes wrong and heals within a chunk is not seen
SHORTER_CHUNK = 8  # times shorter: a chunk that is made again where there is trouble between two saved states
MOST_SAVED = 256  # states that are saved between two looks


@dataclass
class ChunkLength:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one; finer:
    or after so many steps, if any.

    Looks cost as much as some hundred steps of a small mechanism, so there are few of them while all is well.
    """

    steps: int
    saves: int = FIRST_SAVED
    slow_until: int = 0
    finer: int = 0

    @classmethod
    def of(cls, operations: int) -> ChunkLength:
        """Of steps that take so many operations."""
        return cls(max(1, 1 << (OPERATIONS // max(1, operations)).bit_length() - 1))

    def slow(self, step: int) -> bool:
        """Is each saved state looked at closely here?"""
        return step < self.slow_until

    def next_steps(self, step: int, seen_steps: int) -> int:
        """The length of the next call."""
        slow = self.slow(step)
        most = min(self.steps, (1 if slow else self.saves) * seen_steps - step % seen_steps)
        return min(most, self.finer) if slow and self.finer else most

    def took(self, seconds: float) -> None:
        """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
        if seconds < CALL_SECONDS / 4:
            self.steps = min(self.steps * 2, MOST_STEPS_OF_CALL)
        elif seconds > CALL_SECONDS:
            self.steps = max(1, self.steps // 2)

    def went_well(self) -> None:
        """Nothing was found: look at twice as many saved states at once."""
        self.saves = min(2 * self.saves, MOST_SAVED)

    def went_wrong(self, until: int, finer: int = 0) -> None:
        """Steps until there are made again, one save at a time, or so many steps."""
        self.saves, self.slow_until, self.finer = 1, until, finer
