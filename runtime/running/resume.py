"""Go on with a run from a checkpoint."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.running.arguments import Further
from runtime.running.checkpoint import Checkpoint, read_checkpoint
from runtime.running.companion import marks_of, measured
from runtime.running.inputs import InputValue, bound
from runtime.running.outcome import finished
from runtime.running.problem import Problem
from runtime.running.record import record_of
from runtime.running.run import Progress, Run
from runtime.running.segment import Segment
from runtime.running.singular.guard import Guard
from runtime.running.singular.variants import variant_of
from runtime.running.start_of_run import with_reads


def resume(
    model: Model,
    path: str | Path,
    *,
    stream: str | Path | None = None,
    engine: str = "auto",
    progress: Progress | None = None,
    checkpoint: str | Path | None = None,
    checkpoint_every: int | None = None,
    scheme: str | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
) -> Solution:
    """Go on with the run of a checkpoint to its end; the Solution is that of an uninterrupted run, bit for bit.

    stream: the run's own folder where it has moved. checkpoint: where further ones go (the same file by default).
    inputs: those of the run, where they are functions of time, samples or controllers.
    scheme, dt [s], m and options need not be said again; they are compared with the run's own. Raises ModelError for a
    checkpoint of another model or a damaged file, SchemeError for other settings, and what `simulate` raises.
    """
    kept, model = read_checkpoint(path), bound(model, inputs)
    header = kept.header
    header.check_model(model, path)
    header.check_settings({"scheme": scheme, "dt": dt, "m": m, "options": options}, path)
    rule = Further(checkpoint=checkpoint or path, checkpoint_every=checkpoint_every).rule()
    started = time.perf_counter()
    segments = _segments(model, kept, engine, path)
    segment, z = segments[header.segment], kept.z.copy()
    segment.monitor.resume(segment.stepper.state(z), header.monitor)
    segment.resume_impulses(header.impulses)
    keep_rows = bool(header.outputs) or header.stream is not None
    record = record_of(segment, z, stream or header.stream, keep_rows, resumed=True)
    record.segments[:] = segments
    with record.closed_on_error():
        record.restore(kept.arrays, header.rows, header.last_step)
    plan = segments[0].plan
    begin = ConsistentState(kept.arrays["start_q"], kept.arrays["start_q_dot"], {})
    problem = Problem(model, kept.arrays["start_p"], begin, plan.t0, plan.t_end, dict(inputs or {}), engine)
    run = Run(
        segment,
        z,
        record,
        rule,
        header.initial_changes,
        progress,
        list(header.events),
        engine=engine,
        guard=Guard.remembered(header.guard),
        earlier=kept.arrays.get("earlier"),
        marks=marks_of(problem, plan),
        start=(kept.arrays["start_p"], begin),
    )
    if run.marks is not None and "mark_steps" in kept.arrays:
        run.marks.restore(kept.arrays, segments)
    run.happenings.resume(header.happened)
    schedule = problem.schedule(plan.grid.dt_L)
    schedule.resume(header.schedule)
    run.schedule = with_reads(schedule, run)
    run.set_up = time.perf_counter() - started
    return finished(run, lambda run, solution: measured(problem, run, solution))


def _segments(model: Model, kept: Checkpoint, engine: str, path: str | Path) -> list[Segment]:
    """Those that the run has had, built again. Raises ModelError if z does not fit the one under way."""
    header = kept.header
    plan = header.plan(model)
    segments = [Segment.build(model, plan, kept.p, engine)]
    for q_i in header.segments[1:]:
        variant = model if q_i == model.q_i else variant_of(model, q_i, np.array(header.position))
        segments.append(Segment.build(variant, plan.on(variant), kept.p, engine))
    current = segments[header.segment]
    fitting = current.stepper.start(0.0, model.initial_q, model.initial_q_dot, current.c, plan.grid.dt_L)
    if len(fitting) != len(kept.z):
        raise ModelError(
            f"checkpoint {path}",
            f"it holds a state of {len(kept.z)} numbers, where the steps of its scheme {plan.name} prepared here have "
            f"{len(fitting)}: they were prepared otherwise when it was written, as another version does",
            "go on with the version that wrote it, or start again",
        )
    return segments
