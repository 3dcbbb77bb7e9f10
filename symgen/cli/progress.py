"""A progress line on standard error, on a terminal only."""

from __future__ import annotations

import sys
import time
from typing import TextIO

PERIOD = 0.1  # s between updates


class Progress:
    """Call it with (time reached, end time) [s]; `close` wipes the line."""

    def __init__(self, label: str, stream: TextIO | None = None) -> None:
        self._label, self._stream = label, stream if stream is not None else sys.stderr
        self._shown, self._last = False, 0.0
        self._active = self._stream.isatty()

    def __call__(self, t: float, t_end: float) -> None:
        now = time.monotonic()
        if not self._active or now - self._last < PERIOD:
            return
        self._last, self._shown = now, True
        part = min(max(t / t_end, 0.0), 1.0) if t_end > 0 else 1.0
        bar = "#" * round(30 * part)
        self._stream.write(f"\r{self._label} [{bar:<30}] {100 * part:5.1f} %  t = {t:.4g} s ")
        self._stream.flush()

    def note(self, text: str) -> None:
        """Show what is being done."""
        if self._active:
            self._stream.write(f"\r\x1b[K{self._label} {text} ")
            self._stream.flush()
            self._shown = True

    def close(self) -> None:
        """Wipe the line."""
        if self._shown:
            self._stream.write("\r\x1b[K")
            self._stream.flush()
            self._shown = False

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
