"""Runs of the hard suite to a tolerance and with steps of one length: their errors against a reference, their times."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from runtime.contract.coordinates import followed, independent, loop_part, whole
from runtime.contract.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.results.sampling import evaluate
from runtime.running.arguments import RunArguments
from runtime.running.calibration import Calibration
from runtime.schemes.adaptive.adaptive_state import STOPS
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.error_norm import FLOOR
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.times import SwitchTime, switching_times
from runtime.studies.work_precision.problem import Setting, make_setting
from symgen.scenes.hard_suite import HardCase

SEEN = 200  # states that errors are taken from
KEPT = 4000  # states of a reference; steps of one length end at some of them
REFERENCE, TIGHT = "dopri5", 3e-11
REACH, LEAST_STEPS = 0.75, 20_000  # h w of a reference with steps of one length, and how many it takes at least
COARSE = (20, 25, 32, 40, 50, 80, 100, 125, 160)  # numbers of steps that divide KEPT
FINER = 2**0.5  # ratio of one number of steps to the next
SWEEP = 20.0  # CPU seconds of all runs with steps of one length of a method
REPEATS, ENOUGH = 7, 0.1  # timings at least, and until they last this long together [s]
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
        at = State(0.0, *independent(model, q, v), loop_part(model, q))
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

    def begun(
        self, dt: float, tolerance: float | None = None, known: Calibration | None = None
    ) -> tuple[np.ndarray, Advance]:
        """(z at the start, what makes steps of dt from it); known: what trials told."""
        s, scheme = self.case.setting, self.scheme
        z = self.stepper.start(0.0, s.state.q, s.state.q_dot, s.c, dt)
        if not isinstance(scheme, AdaptiveSteps):
            ready = self.stepper.ready(s.c, dt)
            return z, lambda state, n: self.stepper.run(state, ready, n)
        if known is not None:
            known.begin(scheme, z)
        ready = self.stepper.ready_for(scheme.constants(s.c, dt, tolerance))

        scheme.look_ahead(z, self.case.jumps)
        further = len(self.case.jumps) >= STOPS  # than z knows from the start

        def advance(state: np.ndarray, n: int) -> None:
            end, on = int(state[1]) + n, True
            while on:
                if further:
                    scheme.look_ahead(state, self.case.jumps)
                self.stepper.run(state, ready, end - int(state[1]))
                on = state[1] < end and not scheme.is_stuck(state)

        return z, advance

    def motion(
        self, dt: float, seen: int, every: int, tolerance: float | None = None, known: Calibration | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """(coordinates (seen + 1, n) that tell the motion, every so many steps of dt [s]; z at the end)."""
        z, advance = self.begun(dt, tolerance, known)
        states = [self.stepper.state(z).copy()]
        for _ in range(seen):
            advance(z, every)
            states.append(self.stepper.state(z).copy())
        model, constants = self.case.model, self.scheme.constants(self.case.setting.c, dt)
        found = evaluate(self.scheme.observer, {"z": np.array(states)}, constants)
        return whole(model, found["q_i"], found["q_d"])[:, followed(model)[1]], z

    def advancing(
        self, dt: float, steps: int, tolerance: float | None = None, known: Calibration | None = None
    ) -> Callable[[], float]:
        """What makes the whole motion in one call and gives its CPU time [s]."""
        begun, advance = self.begun(dt, tolerance, known)

        def made() -> float:
            z = begun.copy()
            began = time.process_time()
            advance(z, steps)
            return time.process_time() - began

        return made

    def to_tolerance(self, tolerance: float, known: Calibration | None) -> Run:
        """With steps as long as it allows."""
        scheme, dt = self.scheme, self.case.t_end / SEEN
        assert isinstance(scheme, AdaptiveSteps)
        q, z = self.motion(dt, SEEN, 1, tolerance, known)
        error, graded = self.case.errors(q)
        taken = scheme.taken(z)
        return Run(error, graded, np.nan, int(taken["steps"]), int(taken["rejected_steps"]))

    def of_one_length(self, steps: int) -> Run:
        """With so many steps: one of COARSE or a multiple of SEEN."""
        dt, seen = self.case.t_end / steps, min(steps, SEEN)
        with np.errstate(all="ignore"):
            error, graded = self.case.errors(self.motion(dt, seen, steps // seen)[0])
        return Run(error if np.isfinite(error) else np.inf, graded, self.advancing(dt, steps)(), steps)


def best_of(*made: Callable[[], float]) -> list[float]:
    """The least CPU time of each [s], taken by turns, so that a busy machine is as slow for all."""
    spent: list[list[float]] = [[] for _ in made]
    while len(spent[0]) < REPEATS or sum(map(sum, spent)) < ENOUGH * len(made):
        for own, one in zip(spent, made, strict=True):
            own.append(one())
    return [min(own) for own in spent]


def numbers_of_steps() -> Iterator[int]:
    """Ever more, each about FINER times the last."""
    yield from COARSE
    factor = 1.0
    while True:
        yield SEEN * round(factor)
        factor = max(factor * FINER, round(factor) + 1.0)


def swept(method: Method, most_exact: float, longest: float) -> list[Run]:
    """Runs with ever more steps of one length, until one is more exact than what is asked or takes too long [s], or all
    have taken SWEEP.
    """
    runs: list[Run] = []
    began = time.process_time()
    for steps in numbers_of_steps():
        runs.append(method.of_one_length(steps))
        if runs[-1].error < most_exact or runs[-1].seconds > longest or time.process_time() - began > SWEEP:
            return runs
    return runs


def steps_at(runs: list[Run], error: float) -> float:
    """How many steps of one length have that error, between two runs by powers; NaN if none came to it."""
    best = np.nan
    for coarse, fine in zip(runs[:-1], runs[1:], strict=True):
        if coarse.error > error >= fine.error:
            share = (
                np.log(coarse.error / error) / np.log(coarse.error / fine.error) if np.isfinite(coarse.error) else 1.0
            )
            best = np.fmin(best, coarse.steps ** (1 - share) * fine.steps**share)
    return float(best)
