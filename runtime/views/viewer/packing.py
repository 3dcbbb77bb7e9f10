"""Arrays as text for the page."""

from __future__ import annotations

import base64

import numpy as np


def packed(values: np.ndarray, kind: str = "<f4") -> str:
    """Base64 of the numbers in little-endian order, whatever the shape of the array."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode("ascii")
