"""What a run is asked to do: a model with parameters, inputs and a start, checked once, over a span of time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import Initial
from runtime.contract.model import Model
from runtime.running.inputs import InputValue, Sampled, Schedule, scheduled, started
from runtime.schemes.options import SchemeError
from runtime.start.start_state import start_state

SEEN_AT_LEAST = 100  # samples of a motion whose spacing is the scene's
SAME = 1e-9  # of a time: two that differ by less are one
ROUNDING = 1e-6  # of an interval: a span is a whole number of them up to this


@dataclass(frozen=True, eq=False)
class Problem:
    """A model from a consistent state at t0 until t_end [s], with parameters p (n_p,) and inputs.

    Everybody who makes this motion takes it: a run, its companion, the rungs of a ladder. Nobody changes it.
    """

    model: Model
    p: np.ndarray
    state: ConsistentState
    t0: float
    t_end: float
    inputs: Mapping[str, InputValue]
    engine: str = "auto"

    @staticmethod
    def of(
        model: Model,
        t_end: float | None = None,
        parameters: Mapping[str, float] | None = None,
        initial: Initial = None,
        start: str | None = None,
        t0: float = 0.0,
        inputs: Mapping[str, InputValue] | None = None,
        engine: str = "auto",
        dt: float | None = None,
    ) -> Problem:
        """Checked, of a model that its inputs are bound to; dt: of the steps, where they are known [s].

        Raises SchemeError for times, ModelError and InitialStateError for parameters, inputs and the start.
        """
        begin, end = span_of(model, t0, t_end)
        grid = dt if dt is not None else spacing_of(inputs or {}, begin) or (end - begin)
        p = started(model, model.parameter_vector(parameters), scheduled(model, inputs, begin, grid), begin)
        state = start_state(model, p, model.constants(p), begin, initial, start)
        return Problem(model, p, state, begin, end, dict(inputs or {}), engine)

    def schedule(self, dt: float) -> Schedule:
        """What becomes of the inputs on a grid of steps dt [s], from the start; controllers remember nothing yet."""
        return scheduled(self.model, self.inputs, self.t0, dt)

    @cached_property
    def numbers(self) -> tuple[float | bytes, ...]:
        """What the motion of a model, with its inputs, depends on."""
        state = self.state
        return self.t0, self.t_end, self.p.tobytes(), state.q.tobytes(), state.q_dot.tobytes()

    @cached_property
    def spacing(self) -> float | None:
        """The longest step at whose multiples all inputs are sampled [s]; None: nothing is sampled."""
        return spacing_of(self.inputs, self.t0)

    @property
    def forgets(self) -> bool:
        """Can the motion be made again? A controller that keeps memory of its own may give other numbers then."""
        return all(one.memory is not None for one in self.inputs.values() if isinstance(one, Sampled))


def span_of(model: Model, t0: Any, t_end: Any) -> tuple[float, float]:
    """(t0, t_end) [s], the scene's own end where none is given. Raises SchemeError."""
    if isinstance(t0, bool) or not isinstance(t0, int | float | np.number) or not np.isfinite(t0):
        raise SchemeError(f"t0 must be a time in seconds, not {t0!r}")
    end = model.simulation["t_end"] if t_end is None else t_end
    if isinstance(end, bool) or not isinstance(end, int | float | np.number) or not np.isfinite(end) or end <= t0:
        raise SchemeError(f"t_end must be a time after t0 = {t0:g} s, not {end!r}")
    return float(t0), float(end)


def seen_every_of(seen_every: Any, samples: Any, t0: float, t_end: float) -> float | None:
    """The time from sample to sample that is asked for [s], 0 for every step; None: nothing is. Raises SchemeError."""
    if seen_every is not None and samples is not None:
        raise SchemeError("seen_every, samples", "are two answers", "give the time between samples or their number")
    if samples is not None:
        if isinstance(samples, bool) or not isinstance(samples, int | np.integer) or samples < 1:
            raise SchemeError(f"samples must be a whole number of at least 1, not {samples!r}")
        return (t_end - t0) / int(samples)
    number = isinstance(seen_every, int | float | np.number) and not isinstance(seen_every, bool)
    if seen_every is not None and not (number and 0 <= seen_every < np.inf):
        raise SchemeError(f"seen_every must be a time between samples in seconds, not {seen_every!r}")
    return None if seen_every is None else float(seen_every)


def own_spacing(model: Model, t0: float, t_end: float) -> float:
    """The scene's time from sample to sample [s], 0 for every step; of a shorter motion such that it is still seen."""
    return min(float(model.simulation.get("seen_every", 0.0)), (t_end - t0) / SEEN_AT_LEAST)


def spacing_of(inputs: Mapping[str, InputValue], t0: float) -> float | None:
    """The longest time of which all periods of controllers and all times of samples are multiples [s], if there are."""
    times = [value.every for value in inputs.values() if isinstance(value, Sampled)]
    for value in inputs.values():
        if isinstance(value, tuple | list) and len(value):
            try:
                times += [float(t) - t0 for t in value[0] if float(t) > t0]
            except (TypeError, ValueError):  # not two lists of numbers: who reads them says so
                continue
    times = [t for t in times if isinstance(t, int | float) and np.isfinite(t) and t > 0]
    found: float | None = None
    for t in times:
        found = t if found is None else common_time(found, t)
    return found


def common_time(a: float, b: float) -> float:
    """The largest time of which both are multiples [s], up to rounding."""
    least = SAME * max(a, b)
    while b > least:
        a, b = b, a % b
        if a - b < least:  # a remainder that is the divisor but for rounding
            b = 0.0
    return a
