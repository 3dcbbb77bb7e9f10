"""The times at which loads and prescribed motions jump or kink: where a condition of the model changes its sign.

A condition is a function of time once the parameters are numbers. Interval bounds of it and of its slope tell where it
has no zero and where it has at most one; what is left is halved. So of `sin(w t) > 0` every change is found, however
short its period is beside a step.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.contract.tape import node_value, read_tape
from runtime.engine.rows import ManyPoints
from runtime.schemes.switching.enclosure import Enclosure

MOST_TIMES = 100_000
MOST_PIECES = 1 << 17  # of the run, under way: from then on what is left is judged by the ends of the pieces
NARROW = 1e-12  # of the run: changes nearer to each other are one, narrower pieces are not halved
FINEST = 1e-18  # of the run, about zero; elsewhere floats are further apart
MARGIN = 16 * np.finfo(float).eps  # of a time: conditions written in another way round otherwise
Signs = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class SwitchTime:
    """A time [s] at which something jumps or kinks; before < time < after: clocks that show one side and the other.

    owners: the loads, joints, states and inputs that it is of.
    """

    time: float
    before: float
    after: float
    owners: tuple[str, ...]


def has_switching_times(model: Model) -> bool:
    """May loads or prescribed motions jump or kink in time, by the scene or by the functions given for inputs?"""
    return model.has("switching") or bool(model.sources)


def switches_by_inputs(model: Model) -> bool:
    """Do conditions of the scene depend on held inputs?"""
    if not model.has("switching") or not model.signals.size:
        return False
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    return bool(ca.depends_on(model.evaluate("switching", t=t, c=c)["switching"], c[-model.signals.size :]))


def switching_times(model: Model, c: np.ndarray, t0: float, t_end: float) -> list[SwitchTime]:
    """All of them from t0 to t_end [s], rising, for constants c (c_size,) with held inputs; no step should cross one.

    Raises ModelError if there are more than MOST_TIMES.
    """
    found: list[SwitchTime] = []
    if not has_switching_times(model) or not t_end > t0:
        return found
    t = ca.SX.sym("t")
    for owner, value in conditions(model, ca.SX(ca.DM(c)), t):
        if not ca.depends_on(value, t):
            continue
        found += [SwitchTime(*clocks, (owner,)) for clocks in _changes(value, t, t0, t_end)]
        if len(found) > MOST_TIMES:
            raise ModelError(
                f"{owner} of model {model.name}",
                f"jumps or kinks more than {MOST_TIMES} times from {t0:g} to {t_end:g} s, and steps end at each",
                "simulate a shorter time, or let it change smoothly",
            )
    return _merged(found, NARROW * (t_end - t0))


def conditions(model: Model, c: ca.SX, t: ca.SX) -> Iterator[tuple[str, ca.SX]]:
    """(owner, value that changes its sign), of the scene and of functions given for inputs; constants c (c_size,)."""
    if model.has("switching"):
        values = model.evaluate("switching", t=t, c=c)["switching"]
        yield from zip(model.description.switching, ca.vertsplit(ca.SX(values)), strict=True)
    for name, source in model.sources.items():
        yield from ((f"input {name}", value) for value in _of_function(source, t))


def _of_function(source: ca.Function, t: ca.SX) -> Iterator[ca.SX]:
    """What changes sign where a function of time branches, by its operations."""
    values: list[ca.SX] = []
    for node in read_tape(source).nodes:
        values.append(node_value(node, values, [t]))
        if node.op in (ca.OP_LT, ca.OP_LE, ca.OP_EQ, ca.OP_NE, ca.OP_FMIN, ca.OP_FMAX):
            yield values[node.a] - values[node.b]
        elif node.op in (ca.OP_SIGN, ca.OP_FABS):
            yield values[node.a]
        elif node.op in (ca.OP_FLOOR, ca.OP_CEIL):
            yield ca.sin(np.pi * values[node.a])
        elif node.op == ca.OP_FMOD:
            yield ca.sin(np.pi * values[node.a] / values[node.b])


def _changes(value: ca.SX, t: ca.SX, t0: float, t_end: float) -> list[tuple[float, float, float]]:
    """(time, clock before, clock after) of each change of sign."""
    with_slope = ca.Function("condition", [t], [ca.densify(ca.vertcat(value, ca.jacobian(value, t)))])
    plain, nothing = ManyPoints(ca.Function("condition", [t], [ca.densify(value)])), np.zeros(0)

    def at(times: np.ndarray) -> np.ndarray:
        return plain(nothing, times[:, None])[:, 0]

    around = NARROW * max(t_end - t0, abs(t0), abs(t_end))  # a change at t0 or at t_end shows its two sides
    low, high = _pieces(Enclosure(with_slope), t0 - around, t_end + around)
    if not len(low):
        return []
    a, b = at(low), at(high)
    change = (a >= 0) != (b >= 0)
    low, high, a, b = (part[change] for part in (low, high, a, b))
    rising = b > a
    # both ends of a stretch of zeros: the last clock with the sign before, the first with the one after
    before = _last(low, high, lambda x: np.where(rising, at(x) < 0, at(x) > 0), np.where(rising, a < 0, a > 0))
    high = _soon(before, high, lambda x: np.where(rising, at(x) > 0, at(x) < 0))
    after = -_last(-high, -before, lambda x: np.where(rising, at(-x) > 0, at(-x) < 0), np.where(rising, b > 0, b < 0))
    time = before + (after - before) / 2
    inside = (time >= t0 - around) & (time <= t_end + around)
    margin = MARGIN * np.abs(time)
    clocks = np.column_stack([np.clip(time, t0, t_end), before - margin, after + margin])[inside]
    return [(float(one), float(two), float(three)) for one, two, three in clocks]


def _pieces(condition: Enclosure, t0: float, t_end: float) -> tuple[np.ndarray, np.ndarray]:
    """Pieces of the run (low, high) with at most one change each; those that surely have none are left out."""
    low, high = np.array([t0]), np.array([t_end])
    kept: list[tuple[np.ndarray, np.ndarray]] = []
    while len(low):
        (value, slope), jumps = condition.bounds(low, high)
        possible = (value[0] <= 0) & (value[1] >= 0)
        one = ((slope[0] > 0) | (slope[1] < 0)) & ~jumps
        done = possible & (one | (high - low <= NARROW * (t_end - t0)))
        kept.append((low[done], high[done]))
        low, high = low[possible & ~done], high[possible & ~done]
        if len(low) > MOST_PIECES:
            kept.append((low, high))
            break
        middle = low + (high - low) / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    lows, highs = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    order = np.argsort(lows)
    return lows[order], highs[order]


def _soon(low: np.ndarray, high: np.ndarray, holds: Signs) -> np.ndarray:
    """Times from low to high at which a condition holds as it does at high, by going ahead from low."""
    reach, found = 2 * np.spacing(np.abs(low)), high.copy()
    waits = np.ones(len(low), dtype=bool)
    while waits.any():
        near = np.minimum(low + reach, high)
        done = waits & ((near >= high) | holds(near))
        found[done], waits = near[done], waits & ~done
        reach *= 8
    return found


def _last(low: np.ndarray, high: np.ndarray, holds: Signs, at_low: np.ndarray) -> np.ndarray:
    """The last float in [low, high] until which a condition holds, by halving; low where it does not hold there."""
    low, high, finest = low.copy(), np.where(at_low, high, low), FINEST * (high - low).max(initial=0.0)
    while True:
        middle = low + (high - low) / 2
        if not np.any((low < middle) & (middle < high) & (high - low > finest)):
            return low
        yes = holds(middle)
        low, high = np.where(yes, middle, low), np.where(yes, high, middle)


def between(switches: Sequence[SwitchTime], t0: float, t_end: float) -> Sequence[SwitchTime]:
    """Those of all, rising, that are from t0 to t_end [s]."""
    first, last = (
        find(switches, t, key=lambda one: one.time) for find, t in ((bisect_left, t0), (bisect_right, t_end))
    )
    return switches[first:last]


def _merged(found: list[SwitchTime], near: float) -> list[SwitchTime]:
    """In order; those at one time together."""
    merged: list[SwitchTime] = []
    for one in sorted(found, key=lambda each: each.time):
        if merged and one.time - merged[-1].time <= near:
            last = merged.pop()
            owners = tuple(dict.fromkeys((*last.owners, *one.owners)))
            one = SwitchTime(last.time, min(last.before, one.before), max(last.after, one.after), owners)
        merged.append(one)
    return merged
