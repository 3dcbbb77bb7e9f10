"""An ensemble in parts: on any executor, kept in a folder, gone on with after a failure; the bits of one process.

A part is so many cases. It is worked out wherever the executor has a worker: in processes of this machine, in a dask
cluster, under MPI. What a worker needs is the model, which travels with its files, and plain numbers.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import BrokenExecutor
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, Protocol, TypeAlias
from zipfile import BadZipFile

import numpy as np

from runtime.contract.errors import ArgumentError, ModelError, NoResult, SymgenError
from runtime.contract.files import OutputError, replacing, write_text
from runtime.contract.model import EmittedModel
from runtime.running.problem import Plan
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import TOLD, LaneResults
from runtime.studies.ensemble.refined_rows import rows_of
from runtime.studies.ensemble.refinement import Refinement

CASES_OF_PART = 1000  # cases of a part
GPU_CHUNK = 1 << 16  # where a GPU makes the steps
WAITING_PARTS = 4  # parts a worker that wait
WORKERS = 16  # of an executor that does not say how many it has
HEADER = "study.json"
PAUSE = 0.005  # s from look to look at what is running


class Work(Protocol):
    """What `submit` of an executor gives."""

    def done(self) -> bool:
        """Has it ended?"""

    def result(self) -> Any:
        """What it gave; raises what it raised."""

    def cancel(self) -> Any:
        """Leave it out, if it has not begun."""


class Executor(Protocol):
    """Anything with `submit(function, *arguments)`: of concurrent.futures, dask.distributed, mpi4py, Ray."""

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> Work:
        """Have a worker call it."""


Maker: TypeAlias = Callable[[], Executor]


@dataclass(frozen=True)
class Job:
    """What a worker is told: the model and plain numbers; key: of the study."""

    key: str
    model: EmittedModel
    parameters: list[str]
    initial: list[str]
    plan: dict[str, Any]
    start: str
    outputs: list[str]
    reduced: list[tuple[str, str]]
    refinement: Refinement | None
    version: str
    device: str = "cpu"

    @classmethod
    def of(cls, spec: EnsembleSpec, table: np.ndarray) -> Job:
        """Of an ensemble and its samples."""
        plan = spec.plan.numbers
        parameters, initial, start = spec.parameters, spec.initial, spec.start
        outputs, reduced, model = spec.outputs, spec.reduced, spec.model
        said = [model.digest, own_version(), parameters, initial, plan, start, outputs, reduced]
        if spec.refinement is not None:
            said.append(asdict(spec.refinement))
        digest = hashlib.sha256(json.dumps(said, default=str, sort_keys=True).encode())
        digest.update(repr(sorted(model.input_values.items())).encode() + model.driven_by.encode())
        digest.update(np.ascontiguousarray(table).tobytes())
        key = digest.hexdigest()[:24]
        refinement = spec.refinement
        return cls(
            key, model, parameters, initial, plan, start, outputs, reduced, refinement, own_version(), spec.device
        )

    def spec(self) -> EnsembleSpec:
        """As it was asked."""
        plan = Plan.of_numbers(self.model, self.plan)
        asked = (self.outputs, self.reduced, self.refinement, self.device)
        return EnsembleSpec(self.model, self.parameters, self.initial, plan, self.start, *asked)


@cache
def own_version() -> str:
    """Of the distribution, "unknown" where it is not installed."""
    try:
        return version("symgen")
    except PackageNotFoundError:
        return "unknown"


_specs: dict[tuple[str, str], EnsembleSpec] = {}  # of this worker: prepared once for all parts of a study


def work_out(job: Job, table: np.ndarray, threads: int) -> dict[str, np.ndarray]:
    """What is told of some cases, by name: what a worker does. Raises ModelError where it has another version."""
    if job.version != own_version():
        problem = f"this worker has symgen {own_version()}, the study was begun with {job.version}"
        raise ModelError("ensemble", problem, "install the same version everywhere")
    key = job.key, job.device
    if key not in _specs:
        _specs.clear()
        _specs[key] = job.spec()
    spec = _specs[key]
    found = LaneResults.none_yet(spec, len(table))
    for first, part in rows_of(spec, table).in_threads(threads, lambda: False):
        found.put(first, part)
    return found.kept


class StudyFolder:
    """Parts of one study on disk: what was done is read again by the same call."""

    def __init__(self, folder: str | Path, job: Job, cases: int, chunk: int) -> None:
        self._folder = Path(folder)
        own = {"study": job.key, "model": job.model.name, "cases": cases, "chunk": chunk}
        header = self._folder / HEADER
        if header.exists():
            try:
                found = json.loads(header.read_text(encoding="utf-8"))
            except (OSError, ValueError) as error:
                raise OutputError(f"{header} cannot be read ({error}); choose another folder") from error
            if found != own:
                problem = f"holds another study: {_about(found)}; this one is {_about(own)}"
                raise ArgumentError("folder", f"{folder} {problem}", "choose another folder")
        elif self._folder.is_dir() and any(self._folder.iterdir()):
            raise ArgumentError("folder", f"{folder} holds other files", "choose an empty or a new folder")
        else:
            write_text(header, json.dumps(own))

    def _file(self, first: int) -> Path:
        return self._folder / f"part-{first:09d}.npz"

    def read(self, first: int, count: int) -> LaneResults | None:
        """The part from this case on; None where it was not done or is damaged."""
        try:
            with open(self._file(first), "rb") as stream, np.load(stream, allow_pickle=False) as part:
                found = _results(part)
        except (OSError, ValueError, KeyError, EOFError, BadZipFile):
            return None
        return found if len(found.time) == count else None

    def write(self, first: int, part: LaneResults) -> None:
        """Keep a part, whole or not at all. Raises OutputError."""
        with replacing(self._file(first)) as place, open(place, "wb") as stream:
            np.savez(stream, allow_pickle=False, **part.kept)


def _results(kept: Mapping[str, np.ndarray]) -> LaneResults:
    found = {name: kept[name] for name in TOLD}
    return LaneResults(alone=np.zeros(len(found["time"]), dtype=bool), **found)


def _about(header: Any) -> str:
    if not isinstance(header, Mapping):
        return "something unreadable"
    return f"{header.get('study')} of {header.get('model')}, {header.get('cases')} cases by {header.get('chunk')}"


def study_folder(spec: EnsembleSpec, table: np.ndarray, folder: str | Path, chunk: int) -> StudyFolder:
    """Where the parts of this study are kept. Raises ArgumentError, OutputError for a folder of something else."""
    return StudyFolder(folder, Job.of(spec, table), len(table), chunk)


def in_parts(
    spec: EnsembleSpec,
    table: np.ndarray,
    *,
    executor: Executor | Maker,
    chunk: int,
    threads: int,
    retries: int,
    folder: str | Path | None,
    stopped: Callable[[], bool],
) -> Iterator[tuple[int, LaneResults]]:
    """(first case, results) of parts as they are done; ends early if `stopped` says so.

    executor: one, or a function that makes one, called again where its workers have died. A part that fails is tried
    again `retries` times. Raises NoResult with the first case of a part that still fails; what was done is kept.
    """
    job = Job.of(spec, table)
    study = None if folder is None else StudyFolder(folder, job, len(table), chunk)
    left: list[int] = []
    for first in range(0, len(table), chunk):
        kept = study and study.read(first, len(table[first : first + chunk]))
        if kept:
            yield first, kept
        else:
            left.append(first)
    workers = _Workers(executor, retries)
    try:
        for first, values in workers.work(job, table, left[::-1], chunk, threads, stopped):
            part = _results(values)
            if study:
                study.write(first, part)
            yield first, part
    finally:
        workers.close()


class _Workers:
    """Parts on an executor, which is made anew where it breaks."""

    def __init__(self, executor: Executor | Maker, retries: int) -> None:
        self._make = None if hasattr(executor, "submit") else executor
        self._pool: Any = executor if self._make is None else self._make()
        self._retries = retries
        self._running: dict[Any, int] = {}
        self._failed: dict[int, int] = {}

    def work(
        self, job: Job, table: np.ndarray, left: list[int], chunk: int, threads: int, stopped: Callable[[], bool]
    ) -> Iterator[tuple[int, Any]]:
        """(first case, what a worker gave), as they are done."""
        ahead = WAITING_PARTS * (getattr(self._pool, "_max_workers", None) or WORKERS)
        while (left or self._running) and not stopped():
            try:
                while left and len(self._running) < ahead:
                    work = self._pool.submit(work_out, job, table[left[-1] : left[-1] + chunk], threads)
                    self._running[work] = left.pop()
                done = [work for work in self._running if work.done()]
                if not done:
                    time.sleep(PAUSE)
                for work in done:
                    first = self._running.pop(work)
                    try:
                        found = work.result()
                    except BrokenExecutor:
                        left.append(first)
                        raise
                    except SymgenError:  # another try would end as this one
                        raise
                    except Exception as error:
                        self._count(first, error)
                        left.append(first)
                        continue
                    yield first, found
            except BrokenExecutor as error:
                left += self._running.values()
                self._running.clear()
                self._count(-1, error)
                if self._make is None:
                    remedy = "give a function that makes one, which is called again, and a folder, which keeps parts"
                    raise NoResult("executor", f"its workers have died: {error}", remedy) from error
                self._shut()
                self._pool = self._make()

    def _count(self, first: int, error: Exception) -> None:
        self._failed[first] = self._failed.get(first, 0) + 1
        if self._failed[first] > self._retries:
            what = "its workers" if first < 0 else f"cases from {first} on"
            problem = f"{what} failed {self._failed[first]} times, at last with {error!r}"
            raise NoResult(
                "ensemble", problem, "the same call with the same folder goes on from what was done"
            ) from error

    def _shut(self) -> None:
        if hasattr(self._pool, "shutdown"):
            self._pool.shutdown(wait=False, cancel_futures=True)

    def close(self) -> None:
        """Leave out what has not begun; an executor that was made here is ended."""
        for work in self._running:
            work.cancel()
        if self._make is not None:
            self._shut()


class HereExecutor:
    """Parts one after the other in this process: for a folder without an executor."""

    _max_workers = 1

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> Work:
        """Call it when its result is asked for."""
        return _Later(function, arguments)


class _Later:
    def __init__(self, function: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
        self._function, self._arguments = function, arguments

    def done(self) -> bool:
        """It can be asked for."""
        return True

    def result(self) -> Any:
        """Called now."""
        return self._function(*self._arguments)

    def cancel(self) -> bool:
        """It has not begun."""
        return True
