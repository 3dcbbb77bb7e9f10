"""An estimate of the error of a run of fixed steps, from short windows that are stepped again with half the step.

A window of K major steps starts at a state of the run. From there the run's own steps lead to A, and 2 K half steps
from the same positions and velocities to B. With order p the error of the window is about (A - B) 2^p / (2^p - 1).
Errors of all steps are taken to add up as those of the windows do, which is right for phases of undamped oscillations,
too much where a damper forgets errors, and too little where a motion is chaotic.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.model import Model, ModelError
from runtime.results.amplitudes import floored
from runtime.running.segment import Segment
from runtime.running.singular.guard import Guard

WINDOWS = 10  # at most
SHORTEST = 4  # steps of a window
SHARE = 0.05  # of the run's steps lie in windows; stepping them three times costs 15 %
WORTH_A_WORD = 0.1  # error of a coordinate relative to its amplitude that a run does not end without saying


@dataclass
class CoordinateError:
    """Of one coordinate of q_i: error so far, the worst window's error and time [s], and the range that was seen."""

    error: float = 0.0
    worst: float = 0.0
    worst_time: float = 0.0
    low: float = np.inf
    high: float = -np.inf

    @property
    def amplitude(self) -> float:
        """Half the range of the coordinate."""
        return (self.high - self.low) / 2


class Accuracy:
    """Estimates the error of each coordinate of q_i on the way; errors: by name."""

    def __init__(self, steps: int) -> None:
        self.length = max(SHORTEST, round(SHARE * steps / WINDOWS))
        self.count = min(WINDOWS, int(2 * SHARE * steps / self.length)) if steps >= 2 * SHORTEST else 0
        self.marks = [steps * k // self.count for k in range(self.count)]
        self.apart = steps / max(1, self.count)
        self.errors: dict[str, CoordinateError] = {}

    def until_next(self, step: int) -> int | None:
        """Steps to the next window; None if there is none behind this step."""
        return next((mark - step for mark in self.marks if mark > step), None)

    def look(self, segment: Segment, z: np.ndarray, guard: Guard) -> None:
        """Judge the window that starts at z (whole, flat), if one does; near a singular position it says nothing."""
        if segment.step_of(z) not in self.marks:
            return
        with np.errstate(all="ignore"):
            found = self._window(segment, z.copy(), guard)
        if found is None:
            return
        off, q_i = found
        time = segment.plan.time(segment.step_of(z))
        for name, error, values in zip(segment.model.q_i, off, q_i, strict=True):
            one = self.errors.setdefault(name, CoordinateError())
            one.error += float(error) * self.apart / self.length
            one.low, one.high = min(one.low, *map(float, values)), max(one.high, *map(float, values))
            if error > one.worst:
                one.worst, one.worst_time = float(error), time

    def _window(self, segment: Segment, z: np.ndarray, guard: Guard) -> tuple[np.ndarray, list[np.ndarray]] | None:
        """(error of each coordinate (n_i,), positions at both ends (n_i, 2)); None if the window tells nothing."""
        scheme, stepper, dt = segment.plan.scheme, segment.stepper, segment.plan.grid.dt_L
        try:
            start = segment.observed([stepper.state(z)])
        except ModelError:
            return None
        t, q, q_dot = float(start.t[0]), start.q[0], start.q_dot[0]
        segment.run(z, self.length)
        if guard.alarm(*segment.determinants(z)):
            return None
        halved = stepper.start(t, q, q_dot, segment.c, dt / 2)
        stepper.run(halved, stepper.ready(segment.c, dt / 2), 2 * self.length)
        ends = [
            np.asarray(scheme.observer(z=stepper.state(one), c=scheme.constants(segment.c, step))["q_i"]).ravel()
            for one, step in ((z, dt), (halved, dt / 2))
        ]
        gain = 2.0**scheme.order
        off = np.abs(ends[0] - ends[1]) * gain / (gain - 1)
        if not np.isfinite(off).all():
            return None
        return off, list(np.column_stack([q[segment.model.independent_columns], ends[0]]))

    def watch(self, q_i: dict[str, np.ndarray]) -> None:
        """Widen the ranges by samples of coordinates (N,)."""
        for name, one in self.errors.items():
            if name in q_i and len(q_i[name]):
                one.low, one.high = min(one.low, float(q_i[name].min())), max(one.high, float(q_i[name].max()))

    def worst(self, model: Model) -> tuple[str, float]:
        """The coordinate whose error is largest relative to its amplitude, and that error; a still one says nothing."""
        seen = [self.errors.get(name, CoordinateError(low=0.0, high=0.0)) for name in model.q_i]
        relative = [one.error for one in seen] / floored(model, np.array([one.amplitude for one in seen]))
        return model.q_i[int(np.argmax(relative))], float(np.max(relative))

    def stats(self, model: Model) -> dict[str, float | int | str]:
        """For Solution.stats: of each coordinate its estimated error and the worst time [s]; the worst of all."""
        found: dict[str, float | int | str] = {}
        for name, one in self.errors.items():
            found |= {f"estimated_error.{name}": one.error, f"worst_time.{name}": one.worst_time}
        if self.errors:
            name, relative = self.worst(model)
            found |= {"estimated_error": relative, "estimated_error_of": name}
            if relative > WORTH_A_WORD:
                found["remark"] = (
                    f"the error of {name} is estimated at {relative:.2g} of its amplitude, worst near "
                    f"t = {self.errors[name].worst_time:.4g} s: take a smaller step, or another scheme (symgen advise)"
                )
        return found

    def memory(self) -> dict[str, list[float]]:
        """In plain numbers, by coordinate."""
        return {name: [one.error, one.worst, one.worst_time, one.low, one.high] for name, one in self.errors.items()}

    def resume(self, memory: Mapping[str, Sequence[float]]) -> None:
        """From `memory`."""
        self.errors = {name: CoordinateError(*values) for name, values in memory.items()}
