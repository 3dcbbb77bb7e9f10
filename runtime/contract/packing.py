"""Arrays as text: base64 of the numbers in little-endian order."""

from __future__ import annotations

import base64

import numpy as np


def packed(values: np.ndarray, kind: str = "<f4") -> str:
    """The text of an array, whatever its shape."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode("ascii")


def unpacked(text: str, kind: str = "<f4") -> np.ndarray:
    """The numbers of `packed`, flat. Raises ValueError for another text."""
    return np.frombuffer(base64.b64decode(text, validate=True), dtype=kind)
