"""Rows of finished cases: (status, time reached [s], values). From lanes, from single runs, in threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.errors import ModelError
from runtime.contract.loading import load_model
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.running.simulate import simulate
from runtime.studies.ensemble.lane_runs import LaneRuns, finished
from runtime.studies.ensemble.parts import StudyFolder
from runtime.studies.ensemble.question import CODES, Question
from runtime.studies.ensemble.starts import CaseStarts

AHEAD = 3  # jobs a thread that wait, so that none is idle


class Rows:
    """Makes rows of any cases of a question; table: its samples (cases, columns). Several threads may ask."""

    def __init__(self, model: Model, question: Question, table: np.ndarray, width: int | None = None) -> None:
        self.model, self.question, self.table = model, question, table
        self.lanes = LaneRuns(model, question, width)
        self._starts = CaseStarts(model, question.parameters, question.initial, question.t0, question.start)

    def of(self, first: int, stop: int, stopped: Callable[[], bool] = lambda: False) -> np.ndarray | None:
        """Rows (stop - first, 2 + width) of these cases; None if `stopped` said so."""
        question, samples = self.question, self.table[first:stop]
        found = self.lanes.run(self._starts.of(samples), stopped)
        if found is None:
            return None
        times = question.t0 + found.reached * question.dt
        rows = np.column_stack([np.zeros(len(times)), times, found.values])
        for name in np.unique(found.status[found.status != "completed"]):
            rows[found.status == name, 0] = CODES.get(str(name), 0)
        for case in np.flatnonzero(found.alone):
            if stopped():
                return None
            values, name, time = run_alone(self.model, question, samples[case])
            rows[case] = [CODES[name], time, *values]
        return rows

    def in_threads(
        self, spans: list[tuple[int, int]], workers: int, stopped: Callable[[], bool]
    ) -> Iterator[tuple[int, np.ndarray]]:
        """(first case, rows) of jobs of these spans, in order; ends early if `stopped` says so."""
        job = self.lanes.job(sum(stop - first for first, stop in spans), workers)
        jobs = iter([(k, min(k + job, stop)) for first, stop in spans for k in range(first, stop, job)])
        self.lanes.programs.compile()
        with ThreadPoolExecutor(workers, thread_name_prefix="symgen ensemble") as pool:
            waiting: deque[tuple[int, Future[np.ndarray | None]]] = deque()
            while True:
                while len(waiting) < workers * AHEAD and (span := next(jobs, None)) is not None:
                    waiting.append((span[0], pool.submit(self.of, *span, stopped)))
                if not waiting:
                    return
                first, future = waiting.popleft()
                rows = future.result()
                if rows is None:
                    return
                yield first, rows


# A case that lanes do not bring to its end is simulated by itself: singular positions, other ways to assemble.


def run_alone(model: Model, question: Question, sample: np.ndarray) -> tuple[np.ndarray, str, float]:
    """(values (width,), status, time reached [s]) of the case with these parameters and initial values."""
    plan, count = question.plan(model), len(question.parameters)
    given: dict[str, Any] = {
        "parameters": dict(zip(question.parameters, sample[:count].tolist(), strict=True)),
        "initial": dict(zip(question.initial, sample[count:].tolist(), strict=True)) or None,
    }
    try:
        solution = simulate(
            model,
            scheme=plan.name,
            dt=question.dt,
            m=list(question.m) or None,
            options=dict(plan.options),
            t0=question.t0,
            t_end=question.t_end,
            start=question.start or None,
            outputs=question.outputs,
            seen_every=0.0 if question.reduced else question.every * question.dt,
            force=True,
            **given,
        )
    except (InitialStateError, ModelError):
        return np.full(question.width(plan.steps), np.nan), "not_assembled", question.t0
    # lanes estimate no errors: a case has one status, however it was run
    name = "completed" if solution.status.whole and not solution.status.ok else solution.status.name
    return _values(question, solution, plan.steps), name, solution.status.time


def _values(question: Question, solution: Solution, steps: int) -> np.ndarray:
    if not question.reduced:
        times = len(question.marks(steps))
        values = np.full((len(question.outputs), times), np.nan)
        good = solution.outputs["t"] <= solution.status.time + 0.5 * question.dt
        for k, name in enumerate(question.outputs):
            found = solution.outputs[name][good][:times]
            values[k, : len(found)] = found
        return values.ravel()
    if not solution.status.whole:
        return np.full(len(question.reduced), np.nan)
    return np.array([_reduced(solution.outputs[name], how) for name, how in question.reduced])


def _reduced(y: np.ndarray, reduction: str) -> float:
    """As lanes do it: sums in the order of time."""
    if reduction in ("mean", "rms"):
        total = np.cumsum(y if reduction == "mean" else y * y)[-1:]
        return float(finished(reduction, total, len(y))[0])
    if reduction == "end":
        return float(y[-1])
    if reduction == "min":
        return float(y.min())
    return float((np.abs(y) if reduction == "peak" else y).max())


# What a worker of an executor does: it gets a folder, a hash and the number of a part, and leaves the part there.


def work_on(folder: str, key: str, number: int, threads: int = 1) -> int:
    """Run one part of the study with this hash, in so many threads. Its number; the rows are in the folder."""
    rows = _rows(folder, key)
    first, stop = rows.question.parts(rows.lanes.steps)[number]
    place = StudyFolder(folder)
    if place.read(number, stop - first) is not None:
        return number
    parts = [part for _, part in rows.in_threads([(first, stop)], threads, lambda: False)]
    place.write(number, np.concatenate(parts))
    return number


@lru_cache(maxsize=4)
def _rows(folder: str, key: str) -> Rows:
    """What a process needs for all parts of a study, made once."""
    place = StudyFolder(folder)
    question = place.question(key)
    model = load_model(Path(folder) / "model", question.digest)
    return Rows(model, question, place.table(question))
