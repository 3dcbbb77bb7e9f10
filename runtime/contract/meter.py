"""How far a run is: part, time reached, rate and what remains, on a terminal or in a notebook's cell."""

from __future__ import annotations

import sys
import time
from typing import Any, Self, TextIO

PERIOD = 0.1  # s between updates


class Meter:
    """Call it with (time reached, end time) [s], or with numbers of what is `counted`; `close` wipes the line.

    In a notebook the line is an output of the cell; elsewhere it is on standard error, on a terminal only.
    """

    def __init__(self, label: str, stream: TextIO | None = None, counted: str = "") -> None:
        self._counted = counted
        self._label, self._stream = label, stream if stream is not None else sys.stderr
        self._cell = _cell() if stream is None else None
        self._active = self._cell is not None or self._stream.isatty()
        self._shown, self._last, self._began = False, 0.0, time.monotonic()
        self._first: tuple[float, float] | None = None

    def __call__(self, t: float, t_end: float) -> None:
        now = time.monotonic()
        if self._first is None:
            self._first = (now, t)
        if self._active and now - self._last >= PERIOD:
            self._last = now
            spent, done = now - self._first[0], t - self._first[1]
            self._write(progress_text(self._label, t, t_end, spent, done, self._counted))

    def note(self, text: str) -> None:
        """Show what is being done."""
        if self._active:
            self._write(f"{self._label} {text}")

    def close(self) -> None:
        """Wipe the line."""
        if self._shown:
            self._write("")
            self._shown = False

    def _write(self, text: str) -> None:
        self._shown = True
        if self._cell is not None:
            self._cell(text)
            return
        self._stream.write(f"\r\x1b[K{text}{' ' if text else ''}")
        self._stream.flush()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def progress_text(label: str, t: float, t_end: float, spent: float, done: float, counted: str = "") -> str:
    """The line at time t [s] of t_end, `spent` seconds after the first `done` seconds ago in the motion.

    counted: what t and t_end are numbers of, instead of seconds.
    """
    part = min(max(t / t_end, 0.0), 1.0) if t_end > 0 else 1.0
    bar = "#" * round(30 * part)
    where = f"{t:.0f} of {t_end:.0f} {counted}" if counted else f"t = {t:.4g} s"
    text = f"{label} [{bar:<30}] {100 * part:5.1f} %  {where}"
    if done <= 0 or spent <= 0:
        return text
    return f"{text}  {done / spent:.3g} {counted or 's'} a second, {_clock((t_end - t) * spent / done)} left"


def _clock(seconds: float) -> str:
    return (
        f"{seconds:.0f} s"
        if seconds < 100
        else f"{seconds / 60:.0f} min"
        if seconds < 6000
        else f"{seconds / 3600:.1f} h"
    )


def _cell() -> Any:
    """What writes a text into the cell of a notebook that runs; None elsewhere."""
    if "ipykernel" not in sys.modules:
        return None
    from html import escape

    from IPython.display import HTML, display

    handle = display(HTML(""), display_id=True)
    return lambda text: handle.update(HTML(f"<code>{escape(text)}</code>"))
