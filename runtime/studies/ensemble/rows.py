"""Results of cases: from lanes, from single runs, in threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.errors import ModelError
from runtime.running.simulate import simulate
from runtime.solutions.solution import Solution
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import LaneResults, LaneRuns
from runtime.studies.ensemble.reductions import reduced
from runtime.studies.ensemble.starts import CaseStarts

WAITING_JOBS = 3  # jobs a thread that wait, so that none is idle


class Rows:
    """Results of any cases of an ensemble; table: its samples (cases, columns). Several threads may ask."""

    def __init__(self, spec: EnsembleSpec, table: np.ndarray, width: int | None = None) -> None:
        self.spec, self.table = spec, table
        self.lanes, self._starts = LaneRuns(spec, width), CaseStarts(spec)

    def of(self, first: int, stop: int, stopped: Callable[[], bool] = lambda: False) -> LaneResults | None:
        """Results of these cases; None if `stopped` said so."""
        return self.run(self.table[first:stop], stopped)

    def run(self, samples: np.ndarray, stopped: Callable[[], bool]) -> LaneResults | None:
        """Results of any samples (cases, columns); None if `stopped` said so."""
        found = self.lanes.run(self._starts.of(samples), stopped)
        if found is None:
            return None
        for case in np.flatnonzero(found.alone):
            if stopped():
                return None
            found.values[case], found.status[case], found.time[case] = run_alone(self.spec, samples[case])
        return found

    def job(self, cases: int, workers: int) -> int:
        """Cases that a thread takes at a time."""
        return self.lanes.job(cases, workers)

    def in_threads(self, workers: int, stopped: Callable[[], bool]) -> Iterator[tuple[int, LaneResults]]:
        """(first case, results) of jobs, in order; ends early if `stopped` says so."""
        cases = len(self.table)
        job = self.job(cases, workers)
        jobs = iter([(first, min(first + job, cases)) for first in range(0, cases, job)])
        self.lanes.programs.compile()
        with ThreadPoolExecutor(workers, thread_name_prefix="symgen ensemble") as pool:
            waiting: deque[tuple[int, Future[LaneResults | None]]] = deque()
            while True:
                while len(waiting) < workers * WAITING_JOBS and (span := next(jobs, None)) is not None:
                    waiting.append((span[0], pool.submit(self.of, *span, stopped)))
                if not waiting:
                    return
                first, future = waiting.popleft()
                found = future.result()
                if found is None:
                    return
                yield first, found


# A case that lanes do not bring to its end is simulated by itself: singular positions, other ways to assemble.


def run_alone(spec: EnsembleSpec, sample: np.ndarray) -> tuple[np.ndarray, str, float]:
    """(values (width,), status, time reached [s]) of the case with these parameters and initial values."""
    plan, count = spec.plan, len(spec.parameters)
    given: dict[str, Any] = {
        "parameters": dict(zip(spec.parameters, sample[:count].tolist(), strict=True)),
        "initial": dict(zip(spec.initial, sample[count:].tolist(), strict=True)) or None,
    }
    try:
        solution = simulate(
            spec.model,
            scheme=plan.name,
            dt=plan.grid.dt_L,
            m=list(plan.grid.m) or None,
            options=dict(plan.options),
            t0=plan.t0,
            t_end=plan.t_end,
            start=spec.start or None,
            outputs=spec.outputs,
            seen_every=0.0 if spec.reduced or spec.refinement else plan.seen_steps * plan.grid.dt_L,
            force=True,
            error="off",  # lanes estimate none
            **given,
        )
    except (InitialStateError, ModelError):
        return np.full(spec.width, np.nan), "not_assembled", plan.t0
    # a case has one status, however it was run
    name = "completed" if solution.status.whole and not solution.status.ok else solution.status.name
    # what acts within a step at every level errs alike at all of them, so that no other level shows it
    if spec.refinement is not None and float(solution.stats.get("unresolved_loads", 0.0)) > spec.refinement.tolerance:
        name = "inaccurate"
    return _values(spec, solution), name, solution.status.time


def _values(spec: EnsembleSpec, solution: Solution) -> np.ndarray:
    if spec.refinement is not None:
        return np.concatenate([_whole(spec, solution), _sampled(spec, solution)])
    if not spec.reduced:
        times = len(spec.marks)
        values = np.full((len(spec.outputs), times), np.nan)
        good = solution.outputs["t"] <= solution.status.time + 0.5 * spec.plan.grid.dt_L
        for k, name in enumerate(spec.outputs):
            found = solution.outputs[name][good][:times]
            values[k, : len(found)] = found
        return values.ravel()
    return _whole(spec, solution)


def _sampled(spec: EnsembleSpec, solution: Solution) -> np.ndarray:
    """Outputs at the marks, of a run that is kept at every step."""
    t, times = np.asarray(solution.outputs["t"]), spec.plan.times(np.array(spec.marks))
    places = np.minimum(np.searchsorted(t, times - 0.25 * spec.plan.last_step), len(t) - 1)
    values = np.array([np.asarray(solution.outputs[name])[places] for name in spec.outputs])
    values[:, times > solution.status.time + 0.25 * spec.plan.last_step] = np.nan
    return values.ravel()


def _whole(spec: EnsembleSpec, solution: Solution) -> np.ndarray:
    if not solution.status.whole:
        return np.full(len(spec.reduced), np.nan)
    return np.array([reduced(solution.outputs[name], how) for name, how in spec.reduced])
