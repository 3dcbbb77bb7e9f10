"""One model, many cases: the public door."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any

from runtime.contract.arguments import BY_NAME, CALLED, NAMES, arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.meter import Meter
from runtime.contract.model import EmittedModel
from runtime.running.interrupts import Interrupts
from runtime.running.planning import make_plan
from runtime.running.problem import seen_every_of, span_of, whole_number
from runtime.running.run_options import Progress
from runtime.running.time_functions import check_time_functions
from runtime.schemes.switching.times import switching_times
from runtime.start.start_state import start_state
from runtime.studies.ensemble.ensemble_result import ensemble_result
from runtime.studies.ensemble.ensemble_spec import DEVICES, EnsembleSpec
from runtime.studies.ensemble.lane_programs import programs_of
from runtime.studies.ensemble.lane_runs import LaneResults
from runtime.studies.ensemble.parts import (
    CASES_OF_PART,
    GPU_CHUNK,
    Executor,
    HereExecutor,
    Maker,
    in_parts,
    study_folder,
)
from runtime.studies.ensemble.refined_rows import rows_of
from runtime.studies.ensemble.refinement import refuse_steps
from runtime.studies.ensemble.starts import columns_by_name, table_of, with_functions
from runtime.studies.ensemble.store import check_store, stored


@arguments(inputs=BY_NAME, options=BY_NAME, outputs=NAMES, reduce=BY_NAME, progress=CALLED)
def ensemble(
    model: EmittedModel,
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
    tolerance: float | None = None,
    workers: int | None = None,
    executor: Executor | Maker | None = None,
    folder: str | Path | None = None,
    chunk: int | None = None,
    retries: int = 3,
    on_disk: bool = False,
    device: str = "cpu",
    progress: Progress | bool | None = None,
) -> Any:
    """Run many cases of a model side by side; each is, bit for bit, the run that `simulate` makes.

    Parameters
    ----------
    model : Model
        The mechanism.
    parameters, initial : mapping of str to array_like (cases,), or DataFrame, optional
        Values by name, an array or one number for all cases, in SI units; rates at the start as `<coordinate>_dot`.
    inputs : mapping, optional
        By name numbers, arrays (cases,), or functions of time that all cases share (called once with a symbolic t).
    scheme, dt, m, options, t_end, t0, start : optional
        As of `simulate`, with steps of one length dt [s].
    outputs : sequence of str, optional
        Coordinates, rates, accelerations, measures, energies, `lam.row` or joint forces by name.
    reduce : mapping of str to str or sequence of str, optional
        By output one or several of max, min, peak (largest magnitude), mean, rms, end, over all steps; an output
        without any is kept at its end.
    seen_every : float, optional
        Histories in place of `reduce`: time between stored samples [s].
    samples : int, optional
        Their number besides the first, in place of `seen_every`.
    tolerance : float, optional
        RMS error of each case's motion over its amplitudes [1], in place of dt. Each case is stepped again, finer,
        until it meets it.
    workers : int, optional
        Threads; None: as many as processors, with an executor one a worker.
    executor : Executor or callable, optional
        Where parts of `chunk` cases are worked out: anything with `submit`, such as a ProcessPoolExecutor or
        `Client.get_executor()` of dask; or a function that makes one, called again where workers have died.
    folder : path, optional
        Keeps parts that are done, so that the same call goes on where another was stopped.
    chunk : int, optional
        Cases of a part; 1,000 by default.
    retries : int, optional
        How often a part that fails is tried again.
    on_disk : bool, optional
        True leaves the results in `folder`, as a Zarr store, and returns a Dataset that reads from there what is
        asked for: memory then holds one part in place of the study (extra `zarr`).
    device : str, optional
        "gpu": an NVIDIA GPU makes the steps, with the bits of the CPU (extra `gpu`).
    progress : bool or callable, optional
        True shows a line; a function is called with (cases done, cases).

    Returns
    -------
    xarray.Dataset or dict of str to ndarray
        Over `case` (and `time`): the outputs (values of whole runs as `<output>_<reduction>`), status and time_reached
        [s]
        of each case, and what was varied; a dictionary without xarray. A case that fails has its status and NaN. Ctrl-C
        leaves the cases that were not done with status `interrupted`.

    Raises
    ------
    ArgumentError, ModelError, SchemeError, CompilerError
        For what cannot be used.

    Notes
    -----
    To a tolerance every case has its own steps and its own `error`, and `error.<output>` (or
    `error.<output>_<reduction>`) in units of the output, RMS over the motion where it is a history; `steps` of the run
    that answers, and `steps_of_all_levels`, those before it included. A case that more steps do not bring below the
    tolerance is `inaccurate`, with its error; NaN where nothing could be measured. Errors are estimates by Richardson's
    extrapolation from runs with unlike steps.

    Cases are lanes of the same native steps. Order and bits are those of one process, whatever works them out.
    """
    if not model.q_i:
        raise ModelError(f"every coordinate of model {model.name} is driven: use simulate, there is nothing to step")
    count = (1 if executor is not None else _processors()) if workers is None else whole_number(workers)
    if count is None or count < 1:
        raise ArgumentError("workers", f"must be a whole number of threads of at least 1, not {workers!r}")
    model, constant = with_functions(model, inputs)
    names, table = table_of(model, {**columns_by_name("parameters", parameters), **constant}, initial)
    spacing = seen_every_of(seen_every, samples, *span_of(model, t0, t_end))
    if reduce is not None and spacing is not None:
        remedy = "give reduce for values of whole runs, or seen_every (or samples)"
        raise ArgumentError("reduce and seen_every", "exclude each other", remedy)
    if tolerance is None:
        plan = make_plan(model, t_end, dt, m, scheme, spacing, options, t0, bounded=True)
        spec = EnsembleSpec.ask(model, names, plan, start, outputs, reduce)
        _check_names(spec)
    else:
        refuse_steps(scheme, dt, m, options)
        spec = EnsembleSpec.to_tolerance(
            model, names, table, tolerance, start, outputs, reduce,
            scheme=scheme, m=m, options=options, t0=t0, t_end=t_end, spacing=spacing,
        )  # fmt: skip
        _check_names(spec)
    usual = GPU_CHUNK if device == "gpu" else CASES_OF_PART
    size, tries = _whole("chunk", usual if chunk is None else chunk, 1), _whole("retries", retries, 0)
    if executor is not None and not (hasattr(executor, "submit") or callable(executor)):
        raise ArgumentError("executor", f"{executor!r} has no submit", "give an executor, or a function that makes one")
    spec = _on_device(spec, device, executor)
    if on_disk:
        check_store(folder)
    if chunk is not None and executor is None and folder is None:
        raise ArgumentError("chunk", "applies to parts only", "give an executor or a folder, too")

    def parts(stopped: Callable[[], bool]) -> Iterator[tuple[int, LaneResults]]:
        if executor is None and folder is None:
            return rows_of(spec, table).in_threads(count, stopped)
        where = executor if executor is not None else HereExecutor()
        return in_parts(
            spec, table, executor=where, chunk=size, threads=count, retries=tries, folder=folder, stopped=stopped
        )

    with Meter(model.name, counted="cases") if progress is True else nullcontext(progress or None) as meter:
        if on_disk:
            assert folder is not None
            _work_through(parts, len(table), meter, lambda first, part: None)
            return stored(spec, table, folder, size, study_folder(spec, table, folder, size).read)
        found = LaneResults.none_yet(spec, len(table))
        _work_through(parts, len(table), meter, found.put)
        return ensemble_result(spec, table, found)


def _on_device(spec: EnsembleSpec, device: str, executor: Executor | Maker | None) -> EnsembleSpec:
    """The same on this device. Raises ArgumentError, and NoGpu with what is missing, before anything is done."""
    if device not in DEVICES:
        raise ArgumentError("device", f"there is no {device!r}", f"take one of {', '.join(DEVICES)}")
    if device == "cpu":
        return spec
    if executor is not None:
        raise ArgumentError("device and executor", "exclude each other", "give one of them")
    found = replace(spec, device=device)
    programs_of(found).compile()
    return found


def _work_through(
    parts: Callable[[Callable[[], bool]], Iterator[tuple[int, LaneResults]]],
    cases: int,
    progress: Progress | None,
    take: Callable[[int, LaneResults], None],
) -> None:
    """Hand on parts as they are done, up to the end or to Ctrl-C."""
    done = 0
    with Interrupts() as interrupts:
        for first, part in parts(lambda: interrupts.asked):
            take(first, part)
            done += len(part.time)
            if progress is not None:
                progress(done, cases)


def _whole(name: str, value: Any, least: int) -> int:
    found = whole_number(value)
    if found is None or found < least:
        raise ArgumentError(name, f"must be a whole number of at least {least}, not {value!r}")
    return found


def _processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _check_names(spec: EnsembleSpec) -> None:
    """Names of initial values, and prescribed motions that jump: by the model's own start. Raises what a run raises."""
    model, plan = spec.model, spec.plan
    p = model.parameter_vector()
    coordinates = {f"{name}{end}": None for name in model.coordinates for end in ("", "_dot")}
    for name in spec.initial:
        if name not in coordinates:
            start_state(model, p, model.constants(p), plan.t0, {name: 0.0}, spec.start or None)  # says why
    if model.constraints:
        c = model.constants(p)
        own = start_state(model, p, c, 0.0, None, "given")
        check_time_functions(model, c, plan, own, switching_times(model, c, plan.t0, plan.t_end))
