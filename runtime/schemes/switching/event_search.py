"""Where in a step an event happens: the step itself, ended sooner, tells.

A step from the same state to a share of its length is the interpolant: it is what the scheme would have done, stiff
modes included. The bracket of a change is narrowed until it is LOCATED long; its end, just after the change, is the
event, so that the value is past zero from there on and one passage counts once.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

LOCATED = 1e-12  # s
OF_STEP = 1e-7  # of a short step, instead
MOST_LOOKS = 100
Looked = tuple[float, np.ndarray]  # how far [s], and the events' values (n_e,) there
Passed = Callable[[np.ndarray, np.ndarray], list[int]]  # which events happen between two sets of values


def first_passage(
    passed: Passed, at: Callable[[float], np.ndarray], low: Looked, high: Looked, length: float
) -> tuple[float, np.ndarray]:
    """How far [s] into a step of this length an event has just happened, to LOCATED, and the values (n_e,) before it.

    at(s): the events' values (n_e,) a part of the step on; low and high: places between which it happens.
    """
    before = low[1]
    looks: list[Looked] = [low, high]
    width = min(LOCATED, OF_STEP * length)
    for look in range(MOST_LOOKS):
        if high[0] - low[0] <= width:
            break
        guess = (low[0] + high[0]) / 2
        if look % 5 != 4:  # a little beyond the zero of a curve through the last looks, or a little before it
            zero = min(_zero(k, low, high, looks) for k in passed(before, high[1]))
            guess = zero + (0.4 if high[0] - zero > zero - low[0] else -0.4) * width
        guess = min(max(guess, low[0] + width / 4), high[0] - width / 4)
        looked = guess, at(guess)
        looks.append(looked)
        low, high = (low, looked) if passed(before, looked[1]) else (looked, high)
    return high[0], before


def _zero(k: int, low: Looked, high: Looked, looks: list[Looked]) -> float:
    """Of event k, by the parabola s(e) through both ends of its bracket and the last look beside them, or secant."""
    (a, e_low), (b, e_high) = low, high
    e_a, e_b = float(e_low[k]), float(e_high[k])
    secant = a + (b - a) * abs(e_a) / max(abs(e_a) + abs(e_b), 1e-300)
    beside = next((one for one in reversed(looks) if one[0] not in (a, b)), None)
    if beside is None:
        return secant
    s, e = beside[0], float(beside[1][k])
    if len({e, e_a, e_b}) < 3:
        return secant
    found = (
        a * e_b * e / ((e_a - e_b) * (e_a - e))
        + b * e_a * e / ((e_b - e_a) * (e_b - e))
        + s * e_a * e_b / ((e - e_a) * (e - e_b))
    )
    return found if a < found < b else secant
