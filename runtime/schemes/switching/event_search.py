"""Where in a step an event happens: the step itself, ended sooner, tells.

A step from the same state to a share of its length is the interpolant: it is what the scheme would have done, stiff
modes included. The bracket of a change is narrowed until it is LOCATED long; its end, just after the change, is the
event, so that the value is past zero from there on and one passage counts once.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.watched import passed

LOCATED = 1e-10  # s
OF_STEP = 1e-6  # of a short step, instead
MOST_LOOKS = 100


def first_passage(
    scheme: Scheme, at: Callable[[float], np.ndarray], before: np.ndarray, after: np.ndarray, length: float
) -> float:
    """How far [s] into a step of this length an event has just happened, to LOCATED.

    at(s): the events' values (n_e,) a part of the step on; before and after: at its start and end.
    """
    low, high, e_low, e_high = 0.0, length, before, after
    width = min(LOCATED, OF_STEP * length)
    for look in range(MOST_LOOKS):
        if high - low <= width:
            break
        guess = (low + high) / 2
        if look % 3 != 2:  # by the secant of the first that passes, a little beyond it and a little before it
            own = passed(scheme, before, e_high)
            share = min(abs(e_low[k]) / max(abs(e_low[k]) + abs(e_high[k]), 1e-300) for k in own)
            guess = low + share * (high - low) + (0.4 if look % 3 == 0 else -0.4) * width
        guess = min(max(guess, low + width / 4), high - width / 4)
        e = at(guess)
        if passed(scheme, before, e):
            high, e_high = guess, e
        else:
            low, e_low = guess, e
    return high
