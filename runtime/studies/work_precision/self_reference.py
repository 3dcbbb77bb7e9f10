"""A reference path by compiled one-step methods refined until they agree with themselves: fast, for choosing a method.

It is no judge of the methods that made it; reports take an independent solver (reference_path.py).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from math import ceil

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import Model
from runtime.results.motion_error import floored
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.broken_steps import BrokenSteps
from runtime.schemes.switching.times import switching_times
from runtime.studies.work_precision.reference_path import NoReference

MARGIN = 30.0  # the path is this much more accurate than the tolerance asked for
FIRST_STEPS, SAMPLES = 64, 50
OUT_OF_RANGE = 1e100  # m or rad: a motion that leaves for good
METHODS = (("exponential", [2]), ("dop853", None))


class TooLong(NoReference):
    """The motion is too long for the time allowed."""


class OneStepPath:
    """What tells the motion at any times, by steps of at most `step` that end there."""

    def __init__(self, model: Model, c: np.ndarray, state: ConsistentState, method: str, m: list[int] | None) -> None:
        self._model, self.c, self.state = model, c, state
        self._stepper = Stepper(scheme_kind(method).build(method, model, 1.0, m, {}))
        self.step = np.inf

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """(N, n) at ascending times from 0 on."""
        layout, known = self._stepper.scheme.layout, switching_times(self._model, self.c, 0.0, float(times[-1]))
        z = self._stepper.start(0.0, self.state.q, self.state.q_dot, self.c, 1.0)
        t0, n = (layout.slice(name) for name in ("t0", "n"))
        told = layout.slice("x").start + self._stepper.scheme.model.places.plain
        if "chart" in layout.sizes:  # after a step bodies are where their charts are
            charts = layout.slice("chart")
            told = np.concatenate([told, np.arange(charts.start, charts.stop)])
        rows, reached, ready, last = [], 0.0, None, 0.0
        for t in times:
            if t > reached:
                steps = max(1, ceil((t - reached) / self.step * (1 - 1e-9)))
                dt = (t - reached) / steps
                if ready is None or abs(dt - last) > 1e-12 * dt:
                    ready, last = self._stepper.ready(self.c, dt), dt
                own = [one for one in known if reached <= one.time <= t]
                parts = BrokenSteps(self._stepper, reached, dt, own)
                z[t0], z[n] = parts.grid.clock(0), 0.0  # the clock of a scheme counts steps of one size
                parts.run(z, ready, self.c, steps)
                reached = float(t)
            rows.append(z[told].copy())
        return np.array(rows)


def self_reference(
    model: Model,
    c: np.ndarray,
    state: ConsistentState,
    t_end: float,
    tolerance: float,
    seconds: float,
    graded: list[int],
) -> Callable[[np.ndarray], np.ndarray]:
    """A path, times (N,) [s] -> what tells the motion (N, n).

    Halving its step changes it by tolerance / MARGIN at most. c: the model's constants (c_size,).

    Raises TooLong if that takes longer than `seconds`, NoReference if no method gets there.
    """
    times, late = np.linspace(0.0, t_end, SAMPLES + 1), False
    for method, m in METHODS:
        if method == "exponential" and not model.has("residual_jacobian"):
            continue
        path = OneStepPath(model, c, state, method, m)
        path.step, previous = t_end / FIRST_STEPS, None
        began = time.perf_counter()
        while time.perf_counter() - began < seconds:
            values = path(times)
            if not np.isfinite(values).all() or np.abs(values).max() > OUT_OF_RANGE:
                previous = None
            else:
                late = True
                if previous is not None and _distance(model, values, previous, graded) < tolerance / MARGIN:
                    return path
                previous = values
            path.step /= 2
    if late:
        raise TooLong("the motion is too long for the time allowed")
    raise NoReference(f"no path of {t_end:g} s stays finite, however small its steps: is the motion unstable?")


def _distance(model: Model, values: np.ndarray, previous: np.ndarray, graded: list[int]) -> float:
    """The largest RMS difference of a graded coordinate of two paths (N, n), over its amplitude."""
    spread = floored(model, np.sqrt(np.mean((values - values.mean(axis=0)) ** 2, axis=0)))
    off = np.sqrt(np.mean((values - previous) ** 2, axis=0)) / spread
    return float(off[graded].max())
