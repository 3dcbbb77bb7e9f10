"""The balance of energy and work of a motion, from its saved samples: energy - energy at the start - work.

The work is the integral of P = power_applied + power_driven - power_dissipated: cubics through four samples next to
one another, none of them across a stop, where power may jump; there those of both sides are continued to it. It is of
order 4 where power is smooth. By how much it may be wrong is told by the work over every other sample.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

STORED = ("kinetic", "elastic", "potential")
WINDOW = 4  # samples that a polynomial passes through
GAUSS = (1 - 3**-0.5) / 2, (1 + 3**-0.5) / 2  # of an interval: two points take cubics exactly


@dataclass(frozen=True)
class EnergyBalance:
    """Of N samples [J]: work (N,) since the first one, error (N,), and uncertainty (N,) of the work, which rises."""

    work: np.ndarray
    error: np.ndarray
    uncertainty: np.ndarray

    @property
    def largest(self) -> float:
        """Largest error [J]."""
        return float(np.abs(self.error).max(initial=0.0))

    @property
    def resolved(self) -> bool:
        """Do the samples tell the error, or is it within what they leave open?"""
        return len(self.work) > 2 and bool(self.uncertainty[-1] <= self.largest)

    def __str__(self) -> str:
        known = f"{self.largest:.3g} J"
        if self.resolved:
            return known
        return f"{known}, not resolved by the samples (their work is known to {self.uncertainty[-1]:.2g} J)"


def energy_balance(t: np.ndarray, energy: Mapping[str, np.ndarray], stops: np.ndarray) -> EnergyBalance:
    """Of samples at t (N,) [s]; stops (S, 2): times [s], and the energy that an impulse put in there [J].

    A sample at the very time of a stop shows what is before it.
    """
    total = np.sum([energy[name] for name in STORED], axis=0)
    P = energy["power_applied"] + energy["power_driven"] - energy["power_dissipated"]
    inside = stops[(stops[:, 0] >= t[0]) & (stops[:, 0] < t[-1])]
    times, put_in = inside[np.argsort(inside[:, 0], kind="stable")].T
    with np.errstate(all="ignore"):  # of samples that are not finite
        work = _integrals(t, P, times)
        off = _difference_to_half(t, P, times, work)
        work = work + np.append(0.0, np.cumsum(put_in))[np.searchsorted(times, t, side="left")]
        return EnergyBalance(work, total - total[0] - work, off)


def _difference_to_half(t: np.ndarray, P: np.ndarray, stops: np.ndarray, work: np.ndarray) -> np.ndarray:
    """(N,) largest difference until each sample to the integral over every other one."""
    n = len(t)
    if n < 3:
        return np.append(0.0, np.abs(np.diff(t) * np.diff(P) / 2))
    half = np.unique(np.append(np.arange(0, n, 2), n - 1))
    off = np.maximum.accumulate(np.abs(_integrals(t[half], P[half], stops) - work[half]))
    return np.asarray(off[np.searchsorted(half, np.arange(n))])


def _integrals(t: np.ndarray, P: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """(N,) integrals of P (N,) from the first sample on; stops (S,), rising, lie among the samples."""
    if len(t) < 2:
        return np.zeros(len(t))
    piece = np.searchsorted(stops, t, side="left")  # of each sample: how many stops are before it
    ends = np.sort(np.concatenate([t, stops]))
    start, length = ends[:-1], np.diff(ends)
    own = np.searchsorted(stops, start, side="right")  # piece of each interval
    own = np.where(length > 0, own, piece[-1])
    sample = np.clip(np.searchsorted(t, start, side="right") - 1, 0, len(t) - 2)
    first, last = np.searchsorted(piece, own, side="left"), np.searchsorted(piece, own, side="right")
    alone = first == last  # no sample between two stops: a line through those beside them
    first, last = np.where(alone, sample, first), np.where(alone, sample + 2, last)
    count = np.minimum(last - first, WINDOW)
    begin = np.clip(sample - 1, first, last - count)
    done = np.zeros(len(start))
    for n in range(1, WINDOW + 1):
        of = np.flatnonzero(count == n)
        window = begin[of, None] + np.arange(n)
        for share in GAUSS:
            done[of] += length[of] / 2 * _interpolated(t[window], P[window], start[of] + share * length[of])
    return np.append(0.0, np.cumsum(np.bincount(sample, done, minlength=len(t) - 1)))


def _interpolated(t: np.ndarray, P: np.ndarray, at: np.ndarray) -> np.ndarray:
    """(K,) values at times (K,) of the polynomials through P (K, n) at t (K, n)."""
    found = np.zeros(len(at))
    for a in range(t.shape[1]):
        factor = P[:, a].copy()
        for b in range(t.shape[1]):
            if b != a:
                factor *= (at - t[:, b]) / (t[:, a] - t[:, b])
        found += factor
    return found
