"""Times that can be compared: methods take turns, CPU time of this thread, the lower quartile of many bursts."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import quantiles

BURST_SECONDS = 2e-3
SETTLE_ROUNDS = 3
MOST_CALLS = 1 << 30


@dataclass(frozen=True)
class Timing:
    """Seconds a call of one method: the lower quartile of all bursts, and how far the median lies above it (relative).

    Not the least of them: where other programs run, a clock of CPU time misses half of a burst now and then.
    """

    best: float
    spread: float
    bursts: tuple[float, ...]


def interleave(
    methods: Mapping[str, Callable[[int], None]], rounds: int, burst_seconds: float = BURST_SECONDS
) -> dict[str, Timing]:
    """Each method(n) does its work n times; every round runs one burst of each, so that all see the same machine."""
    counts = {name: _calibrate(work, burst_seconds) for name, work in methods.items()}
    found: dict[str, list[float]] = {name: [] for name in methods}
    for turn in range(SETTLE_ROUNDS + rounds):
        for name, work in methods.items():
            seconds = _burst(work, counts[name]) / counts[name]
            if turn >= SETTLE_ROUNDS:
                found[name].append(seconds)
    return {name: _timing(bursts) for name, bursts in found.items()}


def ratio(first: Timing, second: Timing) -> tuple[float, float, float]:
    """(ratio of the best, lower and upper quartile of the round-by-round ratios)."""
    rounds = [a / b for a, b in zip(first.bursts, second.bursts, strict=True)]
    lower, _, upper = quantiles(rounds, n=4)
    return first.best / second.best, lower, upper


def _burst(work: Callable[[int], None], count: int) -> float:
    started = time.thread_time()
    work(count)
    return time.thread_time() - started


def _calibrate(work: Callable[[int], None], burst_seconds: float) -> int:
    count = 1
    while (seconds := _burst(work, count)) < burst_seconds / 2:
        count *= 2
        if count > MOST_CALLS:
            raise AssertionError("a benchmark does nothing: the compiler removed its work")
    return max(1, round(count * burst_seconds / seconds))


def _timing(bursts: list[float]) -> Timing:
    ordered = sorted(bursts)
    best = ordered[len(bursts) // 4]
    return Timing(best, ordered[len(bursts) // 2] / best - 1, tuple(bursts))
