"""Numbers that a motion is reduced to, as lanes make them: sums in the order of time."""

from __future__ import annotations

import numpy as np


def finished(reduction: str, kept: np.ndarray, samples: int) -> np.ndarray:
    """A sum over samples as a mean or root of the mean square."""
    mean = kept / samples
    return np.sqrt(mean) if reduction == "rms" else mean


def reduced(y: np.ndarray, reduction: str) -> float:
    """A value of samples y (N,) at every step: max, min, peak, mean, rms or end."""
    if reduction in ("mean", "rms"):
        total = np.cumsum(y if reduction == "mean" else y * y)[-1:]
        return float(finished(reduction, total, len(y))[0])
    if reduction == "end":
        return float(y[-1])
    if reduction == "min":
        return float(y.min())
    return float((np.abs(y) if reduction == "peak" else y).max())
