"""The progress line of a command; --quiet leaves it out."""

from __future__ import annotations

from typing import TextIO

from runtime.results.meter import Meter


class Progress(Meter):
    """A Meter that is silent while `silenced` is set."""

    silenced = False

    def __init__(self, label: str, stream: TextIO | None = None, counted: str = "") -> None:
        super().__init__(label, stream, counted)
        self._active = self._active and not Progress.silenced
