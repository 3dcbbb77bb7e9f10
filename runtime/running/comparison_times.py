"""The times at which two motions by unlike steps are compared: ends of steps of both, in phase with no vibration.

An error that is looked at once in a period of a vibration, always at the same phase, is not seen: one that comes late
is right wherever it turns back. So of the times that are ends of steps of both motions one is taken from each of
MOST_COMPARISON_TIMES equal parts of the motion, where the squares j^2 times the golden ratio, modulo 1, put it.
These are distributed evenly (Weyl 1916), and unlike the multiples of an irrational number they keep step with no
frequency: of an error that grows with time the root mean square at these times is within 0.68 and 1.24 of the true
one, for all of 30,000 frequencies.

The common times are but few steps apart, by a number that has no divisor in common with the steps of the other motion
between them, so that both see a periodic force at unlike phases. A vibration is seen in one phase only where just so
many steps, or twice as many, make its period.

References: H. Weyl, Ueber die Gleichverteilung von Zahlen mod. Eins, Mathematische Annalen 77 (1916) 313-352.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import count
from math import ceil, gcd, sqrt

import numpy as np

MOST_COMPARISON_TIMES = 64  # times, and the end of the motion
GOLDEN = (sqrt(5.0) - 1.0) / 2.0
ODD = (3, 7, 9, 11, 13)  # steps from one common time to the next: such as no round number of steps a period divides
EVEN_TOO = range(1, 14)  # the same of short motions
STEPS_OF_LONG_MOTION = 50  # steps of a motion from which on all of its ends are near to one of the common times
REST_WEIGHT = (
    1.5  # price of what lies behind the last time, beside the distance of a ratio from the one that is wanted, which
)
# counts twice where the two motions would be more alike
COARSE_WEIGHT = 0.2  # the same of the steps from one common time to the next


def comparison_steps(steps: int, every: int = 1, most: int = MOST_COMPARISON_TIMES) -> np.ndarray:
    """(N,) steps, rising, of a motion of so many steps: multiples of `every`, about one in each of `most` equal parts,
    and the last of all.
    """
    places = steps // every
    if places <= most:
        return every * np.arange(1, places + 1)
    parts = np.arange(most)
    at = np.ceil((parts + GOLDEN * (parts + 1) ** 2 % 1.0) * places / most).astype(int)
    return every * np.union1d(np.clip(at, 1, places), places)


@cache
def common_steps(steps: int, ratio: float, base: int | None = None) -> int:
    """a: after each a steps of a run a motion of longer steps (shorter ones, for a ratio below 1) ends a step, too, its
    b-th one, where b has no divisor in common with a.

    ratio: what a / b should be. base: steps of the run between times at which both have to end a step, if there are.
    """
    choices: Sequence[int] = ODD if steps >= STEPS_OF_LONG_MOTION else EVEN_TOO[: min(steps, len(EVEN_TOO))]
    if base is not None:
        choices = sorted({base, *(a for a in EVEN_TOO if base % a == 0)})

    def distance(a: int) -> float:
        longer = float(np.log(a / coprime(a, ratio) / ratio))
        return (
            abs(longer) * (1 if longer * (ratio - 1) > 0 else 2)
            + (REST_WEIGHT * (steps % a) + COARSE_WEIGHT * a) / steps
        )

    return min(choices, key=distance)


def coprime(a: int, ratio: float) -> int:
    """The number nearest to a / ratio, in proportion, that has no divisor with a in common and is not a."""
    wanted = a / ratio
    below = next((b for b in range(int(wanted), 0, -1) if b != a and gcd(a, b) == 1), None)
    above = next(b for b in count(int(wanted) + 1) if b != a and gcd(a, b) == 1)
    return above if below is None or above / wanted < wanted / below else below


# Of motions that are refined one after another: numbers of steps, in units that all of them are multiples of.

FEW = range(5, 10)  # steps, in units, from one time that a motion shares with the next one to the following


def shared(units: int) -> int:
    """Of how many units the steps of the next motion are a multiple, after one with so many: its times are common."""
    return next((units // few for few in FEW if units % few == 0), 1)


def refined(units: int, wanted: float) -> int:
    """The next number of units, at least as many as wanted and more than there were: a multiple of what is shared,
    which shares a large part of its own with the one that follows, and as no other divisor in common where it can.
    """
    common = shared(units) if units else 1
    own = units // common
    least = max(own + 1, ceil(wanted / common - 1e-9))
    good = [x for x in range(least, least + len(FEW)) if x < FEW[0] or any(x % few == 0 for few in FEW)]
    return common * next((x for x in good if gcd(x, own) == 1), good[0] if good else least)
