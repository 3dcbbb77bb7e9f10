"""How many major steps a run makes before it looks at what it has done."""

from __future__ import annotations

from dataclasses import dataclass

CALL_SECONDS = 0.25  # a call lasts about this long, so that progress and Ctrl-C stay responsive
LONGEST_CALL = 1 << 20
MOST_SAVED = 256  # states that are saved between two looks


@dataclass
class Pace:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one.

    Looks cost as much as some hundred steps of a small mechanism, so there are fewer of them while all is well.
    """

    steps: int = 1
    saves: int = 1
    slow_until: int = 0

    def slow(self, step: int) -> bool:
        """Is each saved state looked at closely here?"""
        return step < self.slow_until

    def next_steps(self, step: int, save_every: int) -> int:
        """The length of the next call."""
        saves = 1 if self.slow(step) else self.saves
        return min(self.steps, saves * save_every - step % save_every)

    def took(self, seconds: float) -> None:
        """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
        if seconds < CALL_SECONDS / 4:
            self.steps = min(self.steps * 2, LONGEST_CALL)
        elif seconds > CALL_SECONDS:
            self.steps = max(1, self.steps // 2)

    def went_well(self) -> None:
        """Nothing was found: look at twice as many saved states at once."""
        self.saves = min(2 * self.saves, MOST_SAVED)

    def went_wrong(self, until: int) -> None:
        """Steps until there are made again, one save at a time."""
        self.saves, self.slow_until = 1, until
