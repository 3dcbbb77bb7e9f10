"""Ctrl-C during a run is heard between native calls, where the state is whole."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


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
