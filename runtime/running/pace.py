"""How long a native call of a run lasts, so that progress and Ctrl-C stay responsive, and who hears Ctrl-C."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType

CALL_SECONDS = 0.25  # a call lasts about this long
LONGEST_CALL = 1 << 20
FIRST_SAVED = 32  # of the first look: what goes wrong and heals within a stretch is not seen
MOST_SAVED = 256  # states that are saved between two looks


@dataclass
class Pace:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one.

    Looks cost as much as some hundred steps of a small mechanism, so there are few of them while all is well.
    """

    steps: int = 64
    saves: int = FIRST_SAVED
    slow_until: int = 0

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
    """asked: was Ctrl-C pressed? A second press stops at once."""

    asked = False

    def _heard(self, number: int, frame: FrameType | None) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True


@contextmanager
def heard_interrupts() -> Iterator[Interrupts]:
    """Hear Ctrl-C while inside. Outside the main thread, and where the caller has a handler, nothing changes."""
    heard = Interrupts()
    ours = (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    )
    if ours:
        signal.signal(signal.SIGINT, heard._heard)
    try:
        yield heard
    finally:
        if ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)
