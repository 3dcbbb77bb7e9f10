"""Adaptive integrators go from jump to jump: none of their steps searches for what is known; impulses are given."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import TO_ROUNDING, CondensedOde
from runtime.contract.coordinates import independent_rates, whole
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.schemes.switching.impulse import impulse_at, moves_in_time
from runtime.schemes.switching.times import SwitchTime, switching_times

Slope = Callable[[float, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Piece:
    """A stretch of time [s] without jumps inside; first and last: clocks that show the sides of its ends."""

    start: float
    end: float
    first: float
    last: float

    def within(self, slope: Slope) -> Slope:
        """A function of (t, y) that sees no further than the ends."""
        return lambda t, y: slope(min(max(t, self.first), self.last), y)


def pieces_of(model: Model, c: np.ndarray, t_end: float) -> list[Piece]:
    """From 0 to t_end."""
    inside = [one for one in switching_times(model, c, 0.0, t_end) if 0 < one.time < t_end]
    if not inside:
        return [Piece(0.0, t_end, 0.0, t_end)]
    starts = [(0.0, 0.0), *((one.time, one.after) for one in inside)]
    ends = [*((one.time, one.before) for one in inside), (t_end, t_end)]
    return [Piece(a[0], b[0], a[1], b[1]) for a, b in zip(starts, ends, strict=True)]


class Impulses:
    """What prescribed motions do to y = [q_i, q_i_dot, loop unknowns] between two pieces."""

    def __init__(self, model: Model, c: np.ndarray) -> None:
        self.model, self.c = model, c
        self._observe: Any = CondensedOde(model, TO_ROUNDING).observe() if moves_in_time(model) else None

    def across(self, y: np.ndarray, before: float, after: float) -> np.ndarray:
        """y just after."""
        if self._observe is None:
            return y
        model, seen = self.model, self._observe(t=before, y=y, c=self.c)
        parts = {name: np.asarray(value).ravel() for name, value in seen.items()}
        q, q_dot = (whole(model, parts[f"q_i{rate}"], parts[f"q_d{rate}"]) for rate in ("", "_dot"))
        found = impulse_at(model, self.c, q, q_dot, before, after)
        if found is None:
            return y
        n = len(model.q_i)
        return np.concatenate([y[:n], independent_rates(model, q, found.q_dot), y[2 * n :]])


def refuse_impulses(model: Model, c: np.ndarray, t_end: float, y: np.ndarray, who: str) -> None:
    """Raises ModelError for a prescribed motion whose velocity jumps, by the start y."""
    impulses = Impulses(model, c)
    times: list[SwitchTime] = switching_times(model, c, 0.0, t_end) if moves_in_time(model) else []
    for one in times:
        if 0 < one.time < t_end and impulses.across(y, one.before, one.after) is not y:
            raise ModelError(
                f"{', '.join(one.owners)} of model {model.name}",
                f"its velocity jumps at t = {one.time:.6g} s, and {who} knows no impulses",
                "take simulate, or let the velocity change in a finite time",
            )
