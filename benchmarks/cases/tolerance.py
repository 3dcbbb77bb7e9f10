"""A tolerance instead of a step, on the hard suite: what is delivered, rejections, and time over the best step's.

Each case runs by the method that `auto` chooses, from 1e-2 to 1e-6, and by the same method with steps of one length,
more and more of them. Delivered is the RMS error over the motion of the worst independent coordinate, relative to its
amplitude and at least a thousandth of the largest of its kind and unit, as the controller measures. Time is CPU time of
one native call for the whole motion; that of steps of one length is taken at the error that was delivered.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from runtime.contract.coordinates import followed, independent, whole
from runtime.contract.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.results.sampling import evaluate
from runtime.running.arguments import RunArguments
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.error_norm import FLOOR
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.times import SwitchTime, switching_times
from runtime.studies.advice.auto import choose
from runtime.studies.work_precision.problem import Setting, make_setting
from symgen.scenes.hard_suite import CASES, HardCase

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
SEEN = 200  # states that errors are taken from
KEPT = 4000  # states of a reference; steps of one length end at some of them
REFERENCE, TIGHT = "dopri5", 3e-11
REACH, LEAST_STEPS = 0.75, 20_000  # h w of a reference with steps of one length, and how many it takes at least
COARSE = (20, 25, 32, 40, 50, 80, 100, 125, 160)  # numbers of steps that divide KEPT
FINER = 2**0.5  # ratio of one number of steps to the next
REPEATS, ENOUGH = 3, 0.03  # timings at least, and until they last this long together [s]
Advance = Callable[[np.ndarray, int], None]


@dataclass(frozen=True)
class Run:
    """Error of the worst coordinate, of the worst graded one, CPU seconds; steps made, and thrown away."""

    error: float
    graded: float
    seconds: float
    steps: int
    rejected: int = 0


class Case:
    """A case of the hard suite with its reference."""

    def __init__(self, case: HardCase, model: Model) -> None:
        self.case, self.model, self.t_end = case, model, case.t_end
        self.arguments: RunArguments = {
            "parameters": case.parameters,
            "initial": case.initial,
            "start": case.start,
            "t_end": case.t_end,
        }
        self.setting: Setting = make_setting(
            model,
            t_end=case.t_end,
            parameters=case.parameters,
            initial=case.initial,
            start=case.start,
        )
        self.graded = [followed(model)[0].index(name) for name in case.graded]
        self.jumps: list[SwitchTime] = switching_times(model, self.setting.c, 0.0, case.t_end)

    @cached_property
    def reference(self) -> np.ndarray:
        """q_i (KEPT + 1, n_i): order 8 with steps that resolve every mode; the explicit pair where loads jump."""
        if self.jumps:
            method = Method(self, REFERENCE, {"tolerance": TIGHT})
            return method.motion(self.t_end / KEPT, KEPT, 1, TIGHT)[0]
        steps = max(LEAST_STEPS, int(self.t_end * self._fastest() / REACH))
        every = -(-steps // KEPT)
        method = Method(self, "dop853", {})
        return method.motion(self.t_end / (every * KEPT), KEPT, every)[0]

    def _fastest(self) -> float:
        """The largest frequency or decay at the start [rad/s]."""
        s, model = self.setting, self.model
        if not ModeSolver.possible(model):
            return 0.0
        q, v = s.state.q, s.state.q_dot
        at = State(0.0, *independent(model, q, v), q[model.loop_columns])
        A_q, A_v = ModeSolver(model, s.c).slopes(at)
        n = len(A_q)
        return float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [A_q, A_v]]))).max())

    @cached_property
    def amplitudes(self) -> np.ndarray:
        """(n_i,) RMS about the mean, at least FLOOR of the largest of the same kind and unit."""
        rms = np.sqrt(np.mean((self.reference - self.reference.mean(axis=0)) ** 2, axis=0))
        entries = {entry.name: (entry.kind, entry.unit) for entry in self.model.description.coordinates}
        kinds = [entries[name] for name in followed(self.model)[0]]
        largest = {kind: max(a for a, k in zip(rms, kinds, strict=True) if k == kind) for kind in kinds}
        return np.array([max(a, FLOOR * largest[kind], 1e-10) for a, kind in zip(rms, kinds, strict=True)])

    def errors(self, q_i: np.ndarray) -> tuple[float, float]:
        """(of the worst coordinate, of the worst graded one) of a motion seen at equal distances in time."""
        off = q_i - self.reference[:: KEPT // (len(q_i) - 1)]
        found = np.sqrt(np.mean(off**2, axis=0)) / self.amplitudes
        return float(found.max()), float(found[self.graded].max())


class Method:
    """A scheme on a case."""

    def __init__(self, case: Case, name: str, options: dict[str, float], m: list[int] | None = None) -> None:
        self.case = case
        self.scheme: Scheme = scheme_kind(name).build(name, case.model, 1.0, m, options)
        self.stepper = Stepper(self.scheme, wait=True)

    def begun(self, dt: float, tolerance: float | None = None) -> tuple[np.ndarray, Advance]:
        """(z at the start, what makes steps of dt from it)."""
        s, scheme = self.case.setting, self.scheme
        z = self.stepper.start(0.0, s.state.q, s.state.q_dot, s.c, dt)
        if not isinstance(scheme, AdaptiveSteps):
            ready = self.stepper.ready(s.c, dt)
            return z, lambda state, n: self.stepper.run(state, ready, n)
        ready = self.stepper.ready_for(scheme.constants(s.c, dt, tolerance))

        def advance(state: np.ndarray, n: int) -> None:
            end = int(state[1]) + n
            while state[1] < end and not scheme.is_stuck(state):
                scheme.look_ahead(state, self.case.jumps)
                self.stepper.run(state, ready, end - int(state[1]))

        return z, advance

    def motion(self, dt: float, seen: int, every: int, tolerance: float | None = None) -> tuple[np.ndarray, np.ndarray]:
        """(coordinates (seen + 1, n) that tell the motion, every so many steps of dt [s]; z at the end)."""
        z, advance = self.begun(dt, tolerance)
        states = [self.stepper.state(z).copy()]
        for _ in range(seen):
            advance(z, every)
            states.append(self.stepper.state(z).copy())
        model, constants = self.case.model, self.scheme.constants(self.case.setting.c, dt)
        found = evaluate(self.scheme.observer, {"z": np.array(states)}, constants)
        return whole(model, found["q_i"], found["q_d"])[:, followed(model)[1]], z

    def seconds(self, dt: float, steps: int, tolerance: float | None = None) -> float:
        """CPU time of the motion in one call, the best of several."""
        spent: list[float] = []
        while len(spent) < REPEATS or sum(spent) < ENOUGH:
            z, advance = self.begun(dt, tolerance)
            began = time.process_time()
            advance(z, steps)
            spent.append(time.process_time() - began)
        return min(spent)

    def to_tolerance(self, tolerance: float) -> Run:
        """With steps as long as it allows."""
        scheme, dt = self.scheme, self.case.t_end / SEEN
        assert isinstance(scheme, AdaptiveSteps)
        q, z = self.motion(dt, SEEN, 1, tolerance)
        error, graded = self.case.errors(q)
        taken = scheme.taken(z)
        seconds = self.seconds(self.case.t_end, 1, tolerance)
        return Run(error, graded, seconds, int(taken["steps"]), int(taken["rejected_steps"]))

    def of_one_length(self, steps: int) -> Run:
        """With so many steps: one of COARSE or a multiple of SEEN."""
        dt, seen = self.case.t_end / steps, min(steps, SEEN)
        with np.errstate(all="ignore"):
            error, graded = self.case.errors(self.motion(dt, seen, steps // seen)[0])
        return Run(error if np.isfinite(error) else np.inf, graded, self.seconds(dt, steps), steps)


def numbers_of_steps() -> Iterator[int]:
    """Ever more, each about FINER times the last."""
    yield from COARSE
    factor = 1.0
    while True:
        yield SEEN * round(factor)
        factor = max(factor * FINER, round(factor) + 1.0)


def swept(method: Method, most_exact: float, longest: float) -> list[Run]:
    """Runs with ever more steps of one length, until one is more exact than what is asked or takes too long [s]."""
    runs: list[Run] = []
    for steps in numbers_of_steps():
        runs.append(method.of_one_length(steps))
        if runs[-1].error < most_exact or runs[-1].seconds > longest:
            return runs
    return runs


def seconds_at(runs: list[Run], error: float) -> float:
    """CPU time of steps of one length with that error, between two runs by powers; NaN if none came to it."""
    best = np.nan
    for coarse, fine in zip(runs[:-1], runs[1:], strict=True):
        if coarse.error > error >= fine.error:
            share = (
                np.log(coarse.error / error) / np.log(coarse.error / fine.error) if np.isfinite(coarse.error) else 1.0
            )
            best = np.fmin(best, coarse.seconds ** (1 - share) * fine.seconds**share)
    return float(best)


def run() -> Result:
    """Every case of the hard suite."""
    details: dict = {}
    cells: list[dict[str, float]] = []
    lines: list[Line] = []
    with workplace() as folder:
        for hard in CASES:
            case = Case(hard, model_of(hard.make(), folder))
            found = _case(case)
            details[hard.name] = found
            cells += found["cells"]
            lines.append(_line(hard.name, found))
    ratios = np.array([cell["time"] for cell in cells if np.isfinite(cell["time"])])
    delivered = np.array([cell["delivered"] for cell in cells])
    rejected = np.array([cell["rejected"] for cell in cells])
    within = float(((delivered >= 0.1) & (delivered <= 3)).mean())
    summary = [
        Line("time over the best step, median", float(np.median(ratios)), "", 1.0),
        Line("time over the best step, share of runs above 1.15", float((ratios > 1.15).mean()), "", 0.0),
        Line("delivered over asked outside 0.1 to 3, share of runs", 1 - within, "", 0.1),
        Line("delivered over asked above 3, share of runs", float((delivered > 3).mean()), ""),
        Line("rejected steps, largest share of a run", float(rejected.max()), "", 0.1),
    ]
    return Result("tolerance", "A tolerance instead of a step, on the hard suite", [*summary, *lines], details, REMARK)


REMARK = (
    "Each case by the method that `auto` chooses, to 1e-2, 1e-3, 1e-4, 1e-5 and 1e-6. Delivered over asked is of the "
    "worst independent coordinate. The best step is that of the same method with steps of one length at the error that "
    "was delivered, from a sweep of numbers of steps by a factor of 1.4; a dash where none came to that error."
)


def _case(case: Case) -> dict:
    """What `auto` chose, and of each tolerance what it gave."""
    chosen = {tolerance: choose(case.model, tolerance, case.arguments).scheme for tolerance in TOLERANCES}
    cells: list[dict[str, float]] = []
    for name in dict.fromkeys(chosen.values()):
        asked = [tolerance for tolerance in TOLERANCES if chosen[tolerance] == name]
        method = Method(case, name, {"tolerance": TOLERANCES[0]})
        runs = {tolerance: method.to_tolerance(tolerance) for tolerance in asked}
        finest, slowest = min(one.error for one in runs.values()), max(one.seconds for one in runs.values())
        fixed = swept(Method(case, name, {}, [2] if name == "exponential" else None), finest, 4 * slowest)
        cells += [_cell(tolerance, one, seconds_at(fixed, one.error)) for tolerance, one in runs.items()]
    return {"schemes": list(chosen.values()), "cells": sorted(cells, key=lambda cell: -cell["tolerance"])}


def _cell(tolerance: float, one: Run, fixed: float) -> dict[str, float]:
    return {
        "tolerance": tolerance,
        "delivered": one.error / tolerance,
        "graded": one.graded / tolerance,
        "steps": one.steps,
        "rejected": one.rejected / max(1, one.steps + one.rejected),
        "seconds": one.seconds,
        "time": one.seconds / fixed,
    }


def _line(name: str, found: dict) -> Line:
    """The median of a case's time ratios, with all its figures."""
    cells = found["cells"]
    ratios = [cell["time"] for cell in cells if np.isfinite(cell["time"])]

    def listed(key: str) -> str:
        return ", ".join(f"{cell[key]:.2g}" if np.isfinite(cell[key]) else "-" for cell in cells)

    schemes = ", ".join(dict.fromkeys(found["schemes"]))
    steps = ", ".join(f"{cell['steps']:.0f}" for cell in cells)
    figures = f"delivered over asked {listed('delivered')}; time over the best step {listed('time')}"
    note = f"{schemes}; {steps} steps; {figures}"
    return Line(
        f"{name}: time over the best step, median", float(np.median(ratios)) if ratios else np.nan, "", note=note
    )
