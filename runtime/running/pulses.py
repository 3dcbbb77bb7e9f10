"""Loads that act for a short time only: where steps as long as they like would not see them.

A smooth pulse has no condition that tells its time, and between two steps nothing shows it: a motion that is made
twice misses it twice. So loads are looked at as functions of time, everything else held, on parts of the motion: where
five values of a part do not tell its impulse, something short happens there, and steps end at PARTS places within it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from runtime.schemes.switching.times import MARGIN, SwitchTime

LEVELS = ((256, 12), (64, 8), (16, 3))  # parts of a motion, and how many of them at most hold something short
POINTS = 1 << 15  # of the motion, where loads are looked at
MISSED = 0.02  # of the whole impulse of a load
BOOLE = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90
ACTS = 1e-6  # of the largest second difference: where a pulse begins and ends
SLOW = 4.0  # times the median of these differences, at least: what acts all the time
CLOSELY = 65  # looks about its peak
PARTS = 24
REACH = 8  # parts of the motion on each side

Forces = Callable[[np.ndarray], np.ndarray]  # (n_Q, N) at times (1, N)


def pulse_times(
    forces: Forces, t0: float, t_end: float, known: Sequence[SwitchTime], step: float = np.inf
) -> list[SwitchTime]:
    """Times within short pulses from t0 to t_end [s], rising; known: where steps end anyway; step: the longest [s]."""
    times = np.linspace(t0, t_end, POINTS + 1)
    values = np.asarray(forces(times[None, :])).reshape(-1, POINTS + 1)
    if not (np.abs(values) < 1e290).all():
        return []
    spans = sorted(
        {
            span
            for k, row in enumerate(values)
            if np.ptp(row) > 0
            for span in _spans(row)
            if _has_height(forces, times, k, row, span)
        }
    )
    jumps = np.array([one.time for one in known])
    found: set[float] = set()
    for first, last in spans:
        low, high = times[first], times[last]
        if high - low < PARTS * step and not ((jumps >= low) & (jumps <= high)).any():
            found |= set(np.linspace(low, high, PARTS + 1).tolist())
    margins = [(t, MARGIN * max(abs(t), t_end - t0)) for t in sorted(found) if t0 < t < t_end]
    return [SwitchTime(t, t - margin, t + margin, ()) for t, margin in margins]


def _has_height(forces: Forces, times: np.ndarray, k: int, row: np.ndarray, span: tuple[int, int]) -> bool:
    """Has a load k the height that its values (POINTS + 1,) show? At a pole it has none."""
    peak = span[0] + int(np.abs(row[span[0] : span[1] + 1]).argmax())
    near = np.linspace(times[max(peak - 1, 0)], times[min(peak + 1, POINTS)], CLOSELY)
    found = np.asarray(forces(near[None, :])).reshape(-1, CLOSELY)[k]
    return bool(np.abs(found).max() < 2 * abs(row[peak]))


def _spans(row: np.ndarray) -> list[tuple[int, int]]:
    """From and to which point of (POINTS + 1,) values something short acts."""
    varying = row - np.median(row)
    whole, bends = float(np.abs(varying).sum()), np.abs(np.diff(varying, 2))
    found: list[tuple[int, int]] = []
    for parts, most in LEVELS:
        n = POINTS // parts
        edges = varying[: parts * n + 1 : n]
        inner = varying[:-1].reshape(parts, n)
        sums = inner.sum(axis=1) + (edges[1:] - edges[:-1]) / 2
        boole = n * (np.column_stack([inner[:, :: n // 4], edges[1:]]) @ BOOLE)
        missed = np.flatnonzero(np.abs(sums - boole) > MISSED * whole)
        if 0 < len(missed) <= most:
            parts_of = [(int(k) * n, (int(k) + 1) * n) for k in missed]
            new = [ends for ends in parts_of if not any(low < ends[1] and ends[0] < high for low, high in found)]
            found = _merged([*found, *(_within(bends, *ends) for ends in new)])
    return found


def _within(bends: np.ndarray, first: int, last: int) -> tuple[int, int]:
    """Of a part, and beyond it, where values bend; a slow load beside the pulse does not."""
    least = max(ACTS * bends[first : last - 1].max(), SLOW * float(np.median(bends)))
    still = np.flatnonzero(bends <= least)
    acts = first + np.flatnonzero(bends[first : last - 1] > least)
    before, after = still[still < acts[0]], still[still > acts[-1]]
    low = int(before[-1]) + 1 if len(before) else 0
    high = int(after[0]) + 1 if len(after) else len(bends) + 1
    reach = REACH * (last - first)
    return max(low, first - reach), min(high, last + reach)


def _merged(spans: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Rising, those that touch as one."""
    found: list[tuple[int, int]] = []
    for low, high in sorted(spans):
        if found and low <= found[-1][1]:
            low, high = found[-1][0], max(found.pop()[1], high)
        found.append((low, high))
    return found
