"""One model, many cases: the public door."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.doors import BY_NAME, CALLED, NAMES, PLACE, arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import Model
from runtime.results.meter import Meter
from runtime.running.plan import whole_number
from runtime.running.problem import seen_every_of, span_of
from runtime.running.time_functions import check_time_functions
from runtime.schemes.switching.times import switching_times
from runtime.start.start_state import start_state
from runtime.studies.ensemble.conduct import Means, Progress, answered
from runtime.studies.ensemble.parts import dataset
from runtime.studies.ensemble.question import Question
from runtime.studies.ensemble.starts import columns_by_name, table_of, with_functions


@arguments(inputs=BY_NAME, options=BY_NAME, outputs=NAMES, reduce=BY_NAME, progress=CALLED, folder=PLACE)
def ensemble(
    model: Model,
    parameters: Any = None,
    initial: Any = None,
    inputs: Mapping[str, Any] | None = None,
    *,
    scheme: str | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    t_end: float | None = None,
    t0: float = 0.0,
    start: str | None = None,
    outputs: Sequence[str] | None = None,
    reduce: Mapping[str, str | Sequence[str]] | None = None,
    seen_every: float | None = None,
    samples: int | None = None,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Progress | bool | None = None,
    folder: str | Path | None = None,
) -> Any:
    """Run many cases of a model side by side; each is, bit for bit, the run that `simulate` makes.

    parameters, initial: names (rates as `<coordinate>_dot`) to arrays (cases,) or to one number for all; a DataFrame;
    or ("a", "b"): array (cases, 2), as scipy.stats.qmc samples them. inputs: by name numbers, arrays (cases,), or
    functions of time that all cases share (called once with a symbolic t). scheme, dt [s], m, options, t0,
    t_end [s], start: as for `simulate`. outputs: names of coordinates, rates, accelerations, measures, energies,
    `lam.row` or joint forces. reduce: output to one or several of max, min, peak (largest magnitude), mean, rms, end,
    over all steps; an output without any is kept at its end. seen_every [s] or samples: histories instead, by the
    time between samples or their number.

    workers: threads (None: as many as processors), or with an executor threads of each task. executor: any
    concurrent.futures.Executor; its tasks get a folder and a hash. folder: where finished parts are kept, so that the
    same call goes on after an interruption; workers on other machines must see it. progress(cases done, cases), or True
    for a line on the terminal.

    The result is an xarray Dataset over `case` (and `time`), without xarray a dictionary of arrays: the outputs (values
    of whole runs as `<output>_<reduction>`), status and time_reached [s] of each case, and what was varied. A case that
    fails has its status and NaN. Ctrl-C leaves the cases that were not done with status `interrupted`. Raises
    ArgumentError, ModelError, SchemeError, OutputError or CompilerError for what cannot be used, NoResult for an
    executor that dies.
    """
    if not model.q_i:
        raise ModelError(f"every coordinate of model {model.name} is driven: use simulate, there is nothing to step")
    model, constant = with_functions(model, inputs, executor is not None)
    names, table = table_of(model, {**columns_by_name("parameters", parameters), **constant}, initial)
    seen = seen_every_of(seen_every, samples, *span_of(model, t0, t_end))
    question = Question.ask(model, names, len(table), scheme, dt, m, options, t0, t_end, start, outputs, reduce, seen)
    _check_names(model, question, table)
    count = _count(workers, executor)
    if progress is True:
        with Meter(model.name, counted="cases") as meter:
            rows = answered(model, question, table, Means(count, executor, meter, folder))
    else:
        rows = answered(model, question, table, Means(count, executor, progress or None, folder))
    return dataset(model, question, table, rows)


def _count(workers: int | None, executor: Executor | None) -> int:
    found = whole_number(1 if executor is not None else _processors()) if workers is None else whole_number(workers)
    if found is None or found < 1:
        raise ArgumentError("workers", f"must be a whole number of threads of at least 1, not {workers!r}")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise ArgumentError(
            "executor", f"{type(executor).__name__} has no submit", "give a concurrent.futures.Executor"
        )
    return found


def _processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _check_names(model: Model, question: Question, table: np.ndarray) -> None:
    """Names of initial values, and prescribed motions that jump: by the model's own start. Raises what a run raises."""
    p, plan = model.parameter_vector(), question.plan(model)
    coordinates = {f"{name}{end}": None for name in model.coordinates for end in ("", "_dot")}
    for name in question.initial:
        if name not in coordinates:
            start_state(model, p, model.constants(p), question.t0, {name: 0.0}, question.start or None)  # says why
    if model.constraints:
        c = model.constants(p)
        own = start_state(model, p, c, 0.0, None, "given")
        check_time_functions(model, c, plan, own, switching_times(model, c, plan.t0, plan.t_end))
