"""Event location: where in a step an event happens (a zero crossing) the step itself, ended sooner, tells.

A step from the same state to a share of its length is the interpolant: it is what the scheme would have done, stiff
modes included. The bracket of a change is narrowed by bisection and inverse quadratic interpolation until it is
EVENT_LOCATION_TOLERANCE long; its end, just after the change, is the event, so that the value is past zero from
there on and one passage counts once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

EVENT_LOCATION_TOLERANCE = 1e-12  # s
OF_STEP = 1e-7  # of a short step, instead
MOST_ROOT_LOOKS = 100
Looked = tuple[float, np.ndarray]  # how far [s], and the events' values (n_e,) there
Passed = Callable[[np.ndarray, np.ndarray], list[int]]  # which events happen between two sets of values


def first_passage(
    passed: Passed, at: Callable[[float], np.ndarray], low: Looked, high: Looked, length: float
) -> tuple[float, np.ndarray]:
    """How far [s] into a step of this length an event has just happened, to EVENT_LOCATION_TOLERANCE, and the
    values (n_e,) before it.

    at(s): the events' values (n_e,) a part of the step on; low and high: places between which it happens.
    """
    before = low[1]
    looks: list[Looked] = [low, high]
    width = min(EVENT_LOCATION_TOLERANCE, OF_STEP * length)
    for look in range(MOST_ROOT_LOOKS):
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


# Events that happen and end within one step: what says that one may have, and where it has.
#
# Values at the ends of a step tell nothing of a dip through zero between them. While stepping, two signs of one are
# looked at, each of which costs a few operations and errs on the safe side, since a polynomial lies within the hull of
# its Bernstein coefficients:
#
#     a dip            of steps of one length: the slopes at both ends lead into it, and the cubic through values and
#                      slopes may reach zero
#     room for zero    of steps of a tolerance, which may be long: the polynomial through the values at the ends and at
#                      LOOK_NODES on the step's interpolant, less what it does not resolve, may reach zero between them
#
# Then the step is looked at closely: intervals are halved until second differences leave no room for a zero in any
# before the first change of sign.

# of a step: no share of its length is a whole number of others, so that turns are not missed
LOOK_NODES = (0.17, 0.53, 0.83)
SAFE_DIFFERENCE = 3.0  # times the second difference of a step that is looked at closely
FORETOLD_SHARE = 0.05  # of the range of four looks: a fifth one that cubics through them foretell
VALUE_ROUNDING = (
    1e-13  # of the largest of them: what is constant, as the force of what rests, is not looked at for ever
)
LEAST_INTERVAL = 1e-6  # of a step: intervals are halved no further
LEAST_SAMPLE_SHARE = 1e-3  # of the time between states that are seen
INTERVALS_AT_ONCE = 16  # intervals that are halved, from the left
# of a range: a quartic part of a step that must be looked at, and that next ones have
UNRESOLVED, RESOLVED_SHARE = 0.05, 0.01
HARMLESS_SHARE = 0.25  # of the way to zero: what is so small beside it does not matter
MOST_PLACES = 20_000  # where a look is a value of a function
MOST_PLACES_OF_STEP = (
    500  # where each is a step: those of a step far too long, which tells nothing, would be looked at for ever
)

Pair = Callable[[np.ndarray, np.ndarray], bool]  # does an event happen between two sets of values (n_e,)?


def _to_bernstein() -> np.ndarray:
    """(5, 5): Bernstein coefficients on [0, 1] of the polynomial of degree 4 through values at 0, LOOK_NODES and 1."""
    x = np.array([0.0, *LOOK_NODES, 1.0])
    return np.linalg.inv(np.array([[_choose(k) * s**k * (1 - s) ** (4 - k) for k in range(5)] for s in x]))


def _choose(k: int) -> int:
    return (1, 4, 6, 4, 1)[k]


BERNSTEIN = _to_bernstein()
CUBIC = 1 / 128  # of the coefficient of degree 4: how far the nearest cubic is away on [0, 1]


def dips(old: Any, old_slope: Any, new: Any, new_slope: Any, h: Any) -> Any:
    """(n_e,) 1 where a cubic with these values and slopes (SX or DM) at the ends of h [s] dips, and may reach zero."""
    side = ca.sign(old)
    into = (side * old_slope < 0) * (side * new_slope > 0) * (side * new > 0)
    lowest = ca.fmin(side * (old + h / 3 * old_slope), side * (new - h / 3 * new_slope))
    return into * (lowest <= 0)


def unsure(old: Any, old_slope: Any, new: Any, new_slope: Any, h: Any) -> Any:
    """(n_e,) 1 where the same cubic may reach zero between ends of one sign, or may turn between those of two.

    More than `dips` sees, for steps in which something happens: what passes zero once may do so again soon.
    """
    side, way = ca.sign(old), ca.sign(new - old)
    first, last = old + h / 3 * old_slope, new - h / 3 * new_slope
    reaches = ca.fmin(side * first, side * last) <= 0
    turns = ca.fmin(ca.fmin(way * (first - old), way * (last - first)), way * (new - last)) < 0
    return ca.if_else(side * new > 0, reaches, turns)


@dataclass(frozen=True)
class ValuesInStep:
    """Of events at 0, LOOK_NODES and 1 of a step (n_e each), by Bernstein coefficients of the polynomial through
    them.
    """

    values: list[ca.SX]

    @property
    def _bernstein(self) -> list[ca.SX]:
        return [sum((float(w) * e for w, e in zip(row, self.values, strict=True)), ca.SX(0)) for row in BERNSTEIN]

    @property
    def _rest(self) -> ca.SX:
        """(n_e,) how far the nearest cubic is away."""
        return CUBIC * ca.fabs(sum(((-1) ** k * _choose(k) * b for k, b in enumerate(self._bernstein)), ca.SX(0)))

    @property
    def unresolved(self) -> ca.SX:
        """(n_e,) the same over the range of the values, or over the way to zero where that is far."""
        low = high = self.values[0]
        for e in self.values[1:]:
            low, high = ca.fmin(low, e), ca.fmax(high, e)
        nearest = ca.fmax(ca.fmax(low, -high), 0)
        return self._rest / ca.fmax(ca.fmax(high - low, HARMLESS_SHARE * nearest), 1e-300)

    def room_for_zero(self) -> ca.SX:
        """(n_e,) 1 where more may happen within the step than its two ends tell."""
        b, rest = self._bernstein, self._rest
        start, way = ca.sign(b[0]), ca.sign(b[4] - b[0])
        side = start + (1 - ca.fabs(start)) * ca.sign(b[4])  # an end at zero has none
        lowest, rising = side * b[1], way * (b[1] - b[0])
        for k in (2, 3):
            lowest = ca.fmin(lowest, side * b[k])
        for k in (2, 3, 4):
            rising = ca.fmin(rising, way * (b[k] - b[k - 1]))
        return ca.fmax(ca.if_else(side * b[4] > 0, lowest <= rest, rising < 0), self.unresolved > UNRESOLVED)

    def resolved(self) -> ca.SX:
        """1 where steps of this length tell how all values change."""
        return ca.mmax(self.unresolved) <= RESOLVED_SHARE

    def longest(self, h: ca.SX, dt: ca.SX) -> ca.SX:
        """The longest step [s] after one of h [s] in which values would still be resolved.

        Not shorter than h, nor than LEAST_SAMPLE_SHARE of dt [s]: what is there is rounding.
        """
        worst = ca.mmax(self.unresolved)
        return ca.fmax(LEAST_SAMPLE_SHARE * dt, h * ca.fmax(1.0, (RESOLVED_SHARE / ca.fmax(worst, 1e-12)) ** 0.25))


def first_bracket(
    happens: Pair,
    values: Callable[[np.ndarray], np.ndarray],
    start: float,
    end: float,
    agreements: int = 2,
    most: int = MOST_PLACES,
) -> tuple[float, float] | None:
    """The first interval [s] of a step, from start to end, between whose ends an event happens; None: there is none.

    values(s (N,)): (N, n_e) at places on the step. agreements: so many halvings in a row must be as neighbours
    foretell. most: fewer places are looked at.
    """
    s = np.linspace(start, end, 4 * agreements + 1)
    e, known = values(s), np.zeros(4 * agreements, dtype=int)
    passing = np.array([happens(*pair) for pair in zip(e, e[1:], strict=False)])  # of each interval
    while True:
        first = int(passing.argmax()) if passing.any() else None
        open_ = ((known < agreements) | _unsettled(s, e)) & (np.diff(s) > LEAST_INTERVAL * (end - start))
        k = np.flatnonzero(open_[: None if first is None else first + 1])[:INTERVALS_AT_ONCE]
        if not len(k) or len(s) + len(k) >= most:
            return None if first is None else (float(s[first]), float(s[first + 1]))
        middles = (s[k] + s[k + 1]) / 2
        new = values(middles)
        known[k] = np.where(_foretold(s, e, k, middles, new), known[k] + 1, 0)
        halves = [(happens(e[at], one), happens(one, e[at + 1])) for at, one in zip(k.tolist(), new, strict=True)]
        passing[k] = [left for left, _ in halves]
        passing = np.insert(passing, k + 1, [right for _, right in halves])
        s, e, known = np.insert(s, k + 1, middles), np.insert(e, k + 1, new, axis=0), np.insert(known, k + 1, known[k])


def _foretold(s: np.ndarray, e: np.ndarray, k: np.ndarray, x: np.ndarray, new: np.ndarray) -> np.ndarray:
    """Are values (m, n_e) at x in intervals k about those of the cubic through the four looks around each?"""
    near = np.clip(k - 1, 0, len(s) - 4)[:, None] + np.arange(4)
    at, known = s[near], e[near]
    cubic = np.zeros_like(new)
    for j in range(4):
        others = [i for i in range(4) if i != j]
        weight = np.prod([(x - at[:, i]) / (at[:, j] - at[:, i]) for i in others], axis=0)
        cubic += weight[:, None] * known[:, j]
    allowed = FORETOLD_SHARE * np.ptp(known, axis=1) + VALUE_ROUNDING * np.abs(known).max(axis=1)
    return np.asarray((np.abs(new - cubic) <= allowed).all(axis=1))


def _unsettled(s: np.ndarray, e: np.ndarray) -> np.ndarray:
    """(N - 1,) intervals in which some value (N, n_e) may reach zero and turn back."""
    width = np.diff(s)[:, None]
    slope = np.diff(e, axis=0) / width
    bend = np.abs(np.diff(slope, axis=0) / (s[2:] - s[:-2])[:, None])  # half the second derivative
    most = np.maximum(np.vstack([bend[:1], bend]), np.vstack([bend, bend[-1:]]))
    a, b = e[:-1], e[1:]
    dip = SAFE_DIFFERENCE * most * width**2 / 4 > np.minimum(np.abs(a), np.abs(b))
    turn = SAFE_DIFFERENCE * most * width > np.abs(slope)
    return np.asarray(np.where(a * b > 0, dip, turn).any(axis=1))


def looked_at(function: ca.Function, *fixed: Any) -> Callable[[np.ndarray], np.ndarray]:
    """(N,) -> (N, n_e) of a Function whose last argument is a number, the others fixed."""
    return lambda s: np.asarray(function(*fixed, s[None, :])).T
