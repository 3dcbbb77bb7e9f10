"""Numbers in what a script prints."""

from __future__ import annotations

import re


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", text)]


def line(text: str, beginning: str) -> list[float]:
    """Numbers of the line that begins so."""
    (found,) = (row for row in text.splitlines() if row.startswith(beginning))
    return numbers(found.removeprefix(beginning))
