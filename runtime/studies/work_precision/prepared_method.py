"""A method ready to be run at any step size: built and compiled once, timed without its first call."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import ceil, prod
from typing import Any

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.engine.rows import evaluate
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.broken_steps import BrokenSteps
from runtime.schemes.switching.times import SwitchTime, switching_times
from runtime.schemes.verdict import verdict
from runtime.studies.work_precision.problem import Problem

SAMPLES = 200  # at most so many states of a run are compared with the reference
REPEATS = (5, 100)  # at least, at most
ENOUGH = 0.03  # s: repeats last this long together; a single run that does is timed once
LOW = 0.25  # quantile of the repeats that counts: where others run, a clock of CPU time may miss most of a call
HOPELESS = 1.0  # relative error from which a run counts as failed


@dataclass(frozen=True)
class Spec:
    """A method by name with m and options; `label` is what reports call it."""

    scheme: str
    m: tuple[int, ...] | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """The name, with m and options where they were chosen."""
        ratios = f" m={','.join(map(str, self.m))}" if self.m else ""
        return self.scheme + ratios + "".join(f" {_word(name, value)}" for name, value in self.options.items())


def _word(name: str, value: Any) -> str:
    return value if isinstance(value, str) else f"{name}={value[0] if isinstance(value, tuple) else value}"


@dataclass(frozen=True)
class Trial:
    """One run: its setting (step dt [s] of a scheme, rtol of an adaptive integrator), steps, CPU seconds, evaluations.

    error, end_error: of the worst graded coordinate, over the motion and at its end; errors (graded,): of each.
    failure: how it ended, if not well.
    """

    label: str
    setting: float
    steps: int
    seconds: float
    evaluations: int
    error: float
    end_error: float
    errors: np.ndarray
    failure: str = ""


class PreparedMethod:
    """A method on a problem."""

    def __init__(self, spec: Spec, problem: Problem, engine: str = "auto") -> None:
        self.spec, self.problem = spec, problem
        kind = scheme_kind(spec.scheme)
        self.scheme = kind.build(spec.scheme, problem.model, 1.0, list(spec.m) if spec.m else None, spec.options)
        self._stepper = Stepper(self.scheme, engine, wait=True)
        self._observe = self.scheme.observe()

    @property
    def operations(self) -> int:
        """Of a major step."""
        return self._stepper.operations

    @cached_property
    def sub_steps(self) -> int:
        """Sub-steps of the fastest group in a major step."""
        return prod(self.scheme.grid.m)

    def run(self, steps: int) -> Trial:
        """The whole problem in so many major steps: sampled for its error, then timed."""
        problem = self.problem
        dt = problem.t_end / steps
        z0, ready = self._started(dt)
        broken = self._broken(dt)
        states, seconds = self._sampled(z0, ready, broken, steps)
        per_step, partial = self.scheme.evaluations()
        iterations = int(np.nan_to_num(states[-1][self.scheme.layout.slice("iterations")][0]))
        evaluations = (iterations or steps * per_step) + steps * partial
        ended = verdict(self.scheme, states[-1])
        if ended == "not_finite":
            return self._failed(dt, steps, seconds, evaluations, "not finite")
        seen = self._seen(states, dt)
        told = whole(problem.model, seen["q_i"], seen["q_d"])[:, followed(problem.model)[1]]
        rms, end = problem.errors(seen["t"][:, 0], told)
        if not rms.max() < HOPELESS:
            return self._failed(dt, steps, seconds, evaluations, "error above the motion itself")
        if ended == "iteration_failed":
            return self._failed(dt, steps, seconds, evaluations, "iteration failed")
        seconds = self._timed(z0, ready, broken, steps, seconds)
        return Trial(self.spec.label, dt, steps, seconds, evaluations, float(rms.max()), float(end.max()), rms)

    def observed(self, steps: int) -> tuple[dict[str, np.ndarray], np.ndarray]:
        """(what a run in so many steps shows at N samples: each (N, size); the model's constants (c_size,))."""
        dt = self.problem.t_end / steps
        states, _ = self._sampled(*self._started(dt), self._broken(dt), steps)
        return self._seen(states, dt), self.problem.c

    def _seen(self, states: list[np.ndarray], dt: float) -> dict[str, np.ndarray]:
        return evaluate(self._observe, {"z": np.array(states)}, self.scheme.constants(self.problem.c, dt))

    def _started(self, dt: float) -> tuple[np.ndarray, np.ndarray]:
        problem, state = self.problem, self.problem.state
        return (self._stepper.start(0.0, state.q, state.q_dot, problem.c, dt), self._stepper.ready(problem.c, dt))

    def _broken(self, dt: float) -> BrokenSteps | None:
        """Who steps where something jumps."""
        return BrokenSteps(self._stepper, 0.0, dt, self._switches) if self._switches else None

    def _run(self, z: np.ndarray, ready: np.ndarray, broken: BrokenSteps | None, steps: int) -> None:
        if broken is None:
            self._stepper.run(z, ready, steps)
        else:
            broken.run(z, ready, self.problem.c, steps)

    @cached_property
    def _switches(self) -> list[SwitchTime]:
        return switching_times(self.problem.model, self.problem.c, 0.0, self.problem.t_end)

    def _sampled(
        self, z0: np.ndarray, ready: np.ndarray, broken: BrokenSteps | None, steps: int
    ) -> tuple[list[np.ndarray], float]:
        z, states, spent, every = z0.copy(), [self._stepper.state(z0).copy()], 0.0, max(1, ceil(steps / SAMPLES))
        done = 0
        while done < steps:
            n = min(every, steps - done)
            began = time.process_time()
            self._run(z, ready, broken, n)
            spent += time.process_time() - began
            done += n
            states.append(self._stepper.state(z).copy())
            if not np.isfinite(z).all():
                break
        return states, spent

    def _timed(self, z0: np.ndarray, ready: np.ndarray, broken: BrokenSteps | None, steps: int, first: float) -> float:
        if first > ENOUGH:
            return first
        times: list[float] = []
        while len(times) < REPEATS[0] or (len(times) < REPEATS[1] and sum(times) <= ENOUGH):
            z = z0.copy()
            began = time.process_time()
            self._run(z, ready, broken, steps)
            times.append(time.process_time() - began)
        return float(np.quantile(times, LOW))

    def _failed(self, dt: float, steps: int, seconds: float, evaluations: int, why: str) -> Trial:
        nothing = np.full(len(self.problem.graded), np.nan)
        return Trial(self.spec.label, dt, steps, seconds, evaluations, np.inf, np.inf, nothing, why)
