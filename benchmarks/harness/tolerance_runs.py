"""Whole motions of the hard suite by so many steps of a method: their errors against a reference, their operations."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from math import gcd

import numpy as np

from benchmarks.scenes.hard_suite import HardCase
from runtime import SchemeError
from runtime.contract.coordinates import followed, independent, loop_part, whole
from runtime.engine.rows import evaluate
from runtime.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.results.motion_error import floored
from runtime.running.method_choice import FIRST_LEVEL_STEPS, Method
from runtime.running.problem import Plan, Problem
from runtime.running.run_options import RunOptions
from runtime.running.step_refinement import RefinementLevel, StepRefinement
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.times import SwitchTime, switching_times

KEPT = 4000  # states of a reference
REACH, LEAST_STEPS = 0.3, 20_000  # h w of a reference, and how many steps it takes at least
FINER = 2**0.25  # ratio of one number of steps of an oracle to the next
MOST_STEPS = 200_000
RIVALS = (
    Method("dopri5"),
    Method("dop853"),
    Method("rk4"),
    Method("single_rate"),
    Method("exponential_rk4"),
    Method("exponential_adams"),
    Method("exponential"),
    Method("exponential", (2,)),
)


@dataclass(frozen=True)
class Made:
    """A run: its label, steps, operations of all of them, and its true error."""

    label: str
    steps: int
    operations: float
    error: float


class SampledRefinement(StepRefinement):
    """A refinement whose levels are sampled at the times of a reference that are ends of their steps."""

    def plan(self, method: Method, steps: int, known: Plan | None = None) -> Plan:
        """See Ladder."""
        return replace(super().plan(method, steps, known), seen_steps=steps // gcd(steps, KEPT))


class Case:
    """A case of the hard suite with its reference, by steps of order 8 that resolve every mode."""

    def __init__(self, case: HardCase, model: Model) -> None:
        self.case, self.model, self.t_end = case, model, case.t_end
        self.arguments = {"parameters": case.parameters, "initial": case.initial, "start": case.start}
        self.problem = Problem.of(model, case.t_end, case.parameters, case.initial, case.start)
        self.c = model.constants(self.problem.p)
        self.graded = [followed(model)[0].index(name) for name in case.graded]
        self.jumps: list[SwitchTime] = switching_times(model, self.c, 0.0, case.t_end)

    @cached_property
    def reference(self) -> np.ndarray:
        """q (KEPT + 1, n) of what tells the motion, at equal distances in time."""
        state, every = self.problem.state, -(-max(LEAST_STEPS, int(self.t_end * self._fastest() / REACH)) // KEPT)
        dt = self.t_end / (every * KEPT)
        scheme = scheme_kind("dop853").build("dop853", self.model, dt, None, {})
        if self.jumps:
            return self._with_jumps(every * KEPT, every)
        stepper = Stepper(scheme, wait=True)
        z = stepper.start(0.0, state.q, state.q_dot, self.c, dt)
        ready, states = stepper.ready(self.c, dt), [stepper.state(z).copy()]
        for _ in range(KEPT):
            stepper.run(z, ready, every)
            states.append(stepper.state(z).copy())
        found = evaluate(scheme.observer, {"z": np.array(states)}, scheme.constants(self.c, dt))
        return whole(self.model, found["q_i"], found["q_d"])[:, followed(self.model)[1]]

    def _with_jumps(self, steps: int, every: int) -> np.ndarray:
        refinement = StepRefinement(self.problem, 1e-12, self.t_end / KEPT, RunOptions())
        level = refinement.level(replace(refinement.plan(Method("dop853"), steps), seen_steps=every))
        return level.run.record.solution((0, level.run.z)).q[:, followed(self.model)[1]]

    def _fastest(self) -> float:
        """The largest frequency or decay at the start [rad/s]."""
        state, model = self.problem.state, self.model
        if not ModeSolver.possible(model):
            return 0.0
        q, v = state.q, state.q_dot
        A_q, A_v = ModeSolver(model, self.c).slopes(State(0.0, *independent(model, q, v), loop_part(model, q)))
        n = len(A_q)
        return float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [A_q, A_v]]))).max())

    def error_of(self, level: RefinementLevel) -> float:
        """True error of a level of a SampledRefinement at its samples: RMS of the worst coordinate, over its
        amplitude.
        """
        if level.lost:
            return np.inf
        steps = level.run.record.steps()[1:]
        exact = self.reference[[step * KEPT // level.steps for step in steps]]
        with np.errstate(all="ignore"):
            rms = np.sqrt(np.mean((level.run.record.compared_motion(self.model, steps)[0] - exact) ** 2, axis=0))
        found = float((rms / floored(self.model, self.reference.std(axis=0))).max())
        return found if np.isfinite(found) else np.inf

    def made(self, level: RefinementLevel) -> Made:
        """What a level took and gave."""
        plan = level.run.segment.plan
        label = " ".join([plan.name, *(f"m={m}" for m in plan.grid.m if m > 1)])
        return Made(label, level.steps, level.steps * level.run.segment.stepper.operations, self.error_of(level))


def runs_of_an_oracle(case: Case, tolerances: Iterable[float], methods: Iterable[Method] = RIVALS) -> list[Made]:
    """Single runs of all methods, each with ever more steps until one has less than the least tolerance.

    Methods that would take ten times the operations of the best are given up.
    """
    refinement, least, found, best = (
        SampledRefinement(case.problem, 1e-12, None, RunOptions()),
        min(tolerances),
        list[Made](),
        np.inf,
    )
    for method in methods:
        steps = FIRST_LEVEL_STEPS
        while steps < MOST_STEPS:
            try:
                one = case.made(refinement.level(refinement.plan(method, steps)))
            except SchemeError:
                break
            found.append(one)
            if one.error <= least:
                best = min(best, one.operations)
            if one.error <= least or one.operations > 10 * best:
                break
            steps = FIRST_LEVEL_STEPS * max(steps // FIRST_LEVEL_STEPS + 1, round(steps / FIRST_LEVEL_STEPS * FINER))
    return found


def cheapest(runs: Iterable[Made], error: float) -> Made | None:
    """The run with the fewest operations whose error is not larger."""
    return min((one for one in runs if one.error <= error), key=lambda one: one.operations, default=None)
