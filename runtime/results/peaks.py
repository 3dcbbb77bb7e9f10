"""Peaks between samples: the largest value of a curve that is known at times only."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

EVEN = 0.5  # second differences beside a peak over that at the peak, at least: else samples do not show a smooth curve


class SampledPeak(NamedTuple):
    """The largest value of a curve, its time [s], and how it is made of samples: weights (n,) of `samples` (n,)."""

    value: float
    t: float
    samples: np.ndarray
    weights: np.ndarray


def sampled_peak(t: np.ndarray, y: np.ndarray) -> SampledPeak:
    """Find the largest value of a curve from samples, by the parabola through the largest one and its neighbours.

    Parameters
    ----------
    t, y : (N,) array
        Times [s], not falling, and values.

    Returns
    -------
    SampledPeak
        Its weights are the derivative of its value by the samples: at the top of a curve a shift of time changes
        nothing (envelope theorem).

    Notes
    -----
    At a sine with n samples a period the error of the value is that of the parabola, of the order n^-4 where that
    of the largest sample is of the order n^-2; in the derivative n^-3 and n^-1. The sample itself counts at the ends of
    the curve, and where its second differences show no smooth curve: at jumps, kinks and where samples are too few.
    """
    top = int(y.argmax())
    curvature = _second_difference(t, y, top)
    beside = [_second_difference(t, y, k) / curvature for k in (top - 1, top + 1)] if curvature < 0 else [0.0]
    if not all(EVEN <= ratio <= 1 / EVEN for ratio in beside if not np.isnan(ratio)) or np.isnan(beside).all():
        return SampledPeak(float(y[top]), float(t[top]), np.array([top]), np.ones(1))
    at = np.arange(top - 1, top + 2)
    a, b, c = t[at]
    at_top = (y[top + 1] - y[top]) / (c - b) - (c - b) * curvature  # slope of the parabola at b
    s = float(np.clip(b - at_top / (2 * curvature), a, c))
    weights = np.array(
        [
            (s - b) * (s - c) / ((a - b) * (a - c)),
            (s - a) * (s - c) / ((b - a) * (b - c)),
            (s - a) * (s - b) / ((c - a) * (c - b)),
        ]
    )
    return SampledPeak(float(weights @ y[at]), s, at, weights)


def _second_difference(t: np.ndarray, y: np.ndarray, k: int) -> float:
    """Divided, [t_k-1, t_k, t_k+1] y; NaN where there is none."""
    if not 1 <= k <= len(t) - 2 or not t[k - 1] < t[k] < t[k + 1]:
        return float(np.nan)
    slopes = np.diff(y[k - 1 : k + 2]) / np.diff(t[k - 1 : k + 2])
    return float((slopes[1] - slopes[0]) / (t[k + 1] - t[k - 1]))
