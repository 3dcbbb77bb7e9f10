"""How long a native call of a run lasts, so that progress and Ctrl-C stay responsive, and who hears Ctrl-C."""

from __future__ import annotations

import signal
import threading
from dataclasses import dataclass
from types import FrameType
from typing import Self

CALL_SECONDS = 0.25  # a call lasts about this long
OPERATIONS = 5_000_000  # of a first call
LONGEST_CALL = 1 << 20
FIRST_SAVED = 32  # of the first look: what goes wrong and heals within a stretch is not seen
MOST_SAVED = 256  # states that are saved between two looks


@dataclass
class Pace:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one.

    Looks cost as much as some hundred steps of a small mechanism, so there are few of them while all is well.
    """

    steps: int
    saves: int = FIRST_SAVED
    slow_until: int = 0

    @classmethod
    def of(cls, operations: int) -> Pace:
        """Of steps that take so many operations."""
        return cls(max(1, 1 << (OPERATIONS // max(1, operations)).bit_length() - 1))

    def slow(self, step: int) -> bool:
        """Is each saved state looked at closely here?"""
        return step < self.slow_until

    def next_steps(self, step: int, seen_steps: int) -> int:
        """The length of the next call."""
        saves = 1 if self.slow(step) else self.saves
        return min(self.steps, saves * seen_steps - step % seen_steps)

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


class Interrupts:
    """Hears Ctrl-C inside a `with`. asked: was it pressed? A second press stops at once.

    Outside the main thread, and where the caller has a handler, nothing changes.
    """

    asked = False
    _ours = False

    def __enter__(self) -> Self:
        own = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        self._ours = own and threading.current_thread() is threading.main_thread()
        if self._ours:
            signal.signal(signal.SIGINT, self._heard)
        return self

    def __exit__(self, *_: object) -> None:
        if self._ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)

    def _heard(self, number: int, frame: FrameType | None) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True
