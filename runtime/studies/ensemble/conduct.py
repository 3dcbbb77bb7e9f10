"""Who runs the parts of a study: threads of this process, or the workers of an executor; what is finished is kept."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, wait
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from runtime.contract.errors import NoResult, SymgenError
from runtime.contract.model import Model
from runtime.running.pace import Interrupts
from runtime.studies.ensemble.parts import StudyFolder
from runtime.studies.ensemble.question import NAMES, Question
from runtime.studies.ensemble.rows import Rows, work_on

Progress = Callable[[float, float], None]
POLL = 0.2  # s between two looks at whether Ctrl-C was pressed
LARGE = 1 << 28  # bytes of results: above, with a folder, they stay in a file
AHEAD = 2  # parts a worker that wait


@dataclass(frozen=True)
class Means:
    """What a study is run with: threads, an executor, who is told, and the folder for parts."""

    workers: int
    executor: Executor | None
    progress: Progress | None
    folder: str | Path | None

    def tell(self, done: int, cases: int) -> None:
        """Cases that are done."""
        if self.progress is not None:
            self.progress(done, cases)


def answered(model: Model, question: Question, table: np.ndarray, means: Means) -> np.ndarray:
    """Rows (cases, 2 + width) of all cases; those that were not done are `interrupted`."""
    with Interrupts() as interrupts:
        if means.folder is not None:
            return _kept_in(StudyFolder(means.folder), model, question, table, means, interrupts)
        if means.executor is None:
            rows = _unknown(question, np.empty((question.cases, 2 + _width(model, question))))
            made = Rows(model, question, table).in_threads(
                [(0, question.cases)], means.workers, lambda: interrupts.asked
            )
            for first, part in made:
                rows[first : first + len(part)] = part
                means.tell(first + len(part), question.cases)
            return rows
        place = tempfile.mkdtemp(prefix="symgen-ensemble-")
        rows = _kept_in(StudyFolder(place), model, question, table, means, interrupts)
        shutil.rmtree(place, ignore_errors=True)  # after a failure it stays, and the error names it
        return rows


def _width(model: Model, question: Question) -> int:
    return question.width(question.plan(model).steps)


def _unknown(question: Question, rows: np.ndarray) -> np.ndarray:
    """Rows of cases that were not run."""
    rows[:] = np.nan
    rows[:, 0], rows[:, 1] = NAMES.index("interrupted"), question.t0
    return rows


def _kept_in(
    study: StudyFolder, model: Model, question: Question, table: np.ndarray, means: Means, interrupts: Interrupts
) -> np.ndarray:
    """Rows of a study with a folder: finished parts are read, the others run."""
    question = study.begin(model, question, table)
    shape = (question.cases, 2 + _width(model, question))
    rows = _unknown(question, study.room(shape) if 8 * shape[0] * shape[1] > LARGE else np.empty(shape))
    missing, done = [], 0
    for number, (first, stop) in enumerate(question.parts(question.plan(model).steps)):
        part = study.read(number, stop - first)
        if part is None:
            missing.append((number, first, stop))
        else:
            rows[first:stop] = part
            done += stop - first
    if not missing:
        return rows
    if means.executor is not None:
        made = _by_workers(study, question, missing, means.executor, means.workers, interrupts)
    else:
        made = _by_threads(study, Rows(model, question, table), missing, means.workers, interrupts)
    for first, part in made:
        rows[first : first + len(part)] = part
        done += len(part)
        means.tell(done, question.cases)
    return rows


def _by_threads(
    study: StudyFolder, rows: Rows, missing: list[tuple[int, int, int]], workers: int, interrupts: Interrupts
) -> Iterator[tuple[int, np.ndarray]]:
    """(first case, rows) of finished parts, each written when its last job is done."""
    made = rows.in_threads([(first, stop) for _, first, stop in missing], workers, lambda: interrupts.asked)
    waiting: list[np.ndarray] = []
    left = list(missing)
    for _, job in made:
        waiting.append(job)
        number, first, stop = left[0]
        if sum(len(one) for one in waiting) == stop - first:
            part = np.concatenate(waiting)
            study.write(number, part)
            waiting, left = [], left[1:]
            yield first, part


def _by_workers(
    study: StudyFolder,
    question: Question,
    missing: list[tuple[int, int, int]],
    executor: Executor,
    threads: int,
    interrupts: Interrupts,
) -> Iterator[tuple[int, np.ndarray]]:
    """(first case, rows) of the parts that workers have left in the folder. Raises NoResult where they die."""
    spans = {number: (first, stop) for number, first, stop in missing}
    left, running = list(spans), dict[Future[int], int]()
    try:
        while (left or running) and not interrupts.asked:
            while left and len(running) < AHEAD * _workers(executor):
                number = left.pop(0)
                running[executor.submit(work_on, str(study.path), question.key, number, threads)] = number
            done, _ = wait(running, timeout=POLL, return_when=FIRST_COMPLETED)
            for future in done:
                number = running.pop(future)
                first, stop = spans[number]
                future.result()
                part = study.read(number, stop - first)
                if part is None:
                    raise OSError(f"part {number} was done but is not in {study.path}: do workers see this folder?")
                yield first, part
    except SymgenError:
        raise
    except (Exception, CancelledError) as error:
        raise NoResult(
            f"executor {type(executor).__name__}",
            f"ended before the study did ({type(error).__name__}: {error})",
            f"finished parts are in {study.path}: the same call with folder = that path goes on from there",
        ) from error
    finally:
        for future in running:
            future.cancel()


def _workers(executor: Executor) -> int:
    """How many tasks an executor runs at a time, as far as it says so."""
    found = getattr(executor, "_max_workers", None)
    return found if isinstance(found, int) and found > 0 else 16
