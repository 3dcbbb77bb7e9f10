"""Rows of finished cases: (status, time reached [s], values). From lanes, from single runs, in threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import get_args

import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import StatusName
from runtime.studies.ensemble.alone import run_alone
from runtime.studies.ensemble.lane_runs import LaneRuns
from runtime.studies.ensemble.question import Question
from runtime.studies.ensemble.starts import CaseStarts

NAMES: tuple[str, ...] = get_args(StatusName)
CODES = {name: code for code, name in enumerate(NAMES)}  # completed is 0
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
