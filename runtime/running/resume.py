"""Go on with a run from its checkpoint."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from runtime.contract.arguments import BY_NAME, CALLED, PLACE, arguments
from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event
from runtime.results.motion_error import MotionError
from runtime.running.checkpoint import Checkpoint, read_checkpoint
from runtime.running.chunk_length import ChunkLength
from runtime.running.inputs import InputValue, bound
from runtime.running.outcome import NOT_ASKED, comparison_times_of, finished
from runtime.running.problem import Plan, Problem
from runtime.running.recording import record_of
from runtime.running.run import Run
from runtime.running.run_options import Progress, RunOptions
from runtime.running.singular.exchange import variant_of
from runtime.running.singular.singularity_monitor import SingularityMonitor
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.switching.impulse import Impulse
from runtime.solutions.solution import Solution


@arguments(inputs=BY_NAME, progress=CALLED, stream=PLACE, checkpoint=PLACE, path=PLACE)
def resume(
    model: EmittedModel,
    path: str | Path,
    *,
    stream: str | Path | None = None,
    engine: str = "auto",
    progress: Progress | None = None,
    checkpoint: str | Path | None = None,
    checkpoint_every: int | None = None,
    inputs: Mapping[str, InputValue] | None = None,
) -> Solution:
    """Continue a run from its checkpoint to its end.

    Parameters
    ----------
    model : Model
        The model of the run.
    path : path
        The checkpoint.
    stream : path, optional
        The run's folder, if it was moved; a folder that does not hold the stream of this run is refused, whether it is
        named here or in the checkpoint.
    engine : {"auto", "compiled", "interpreted"}, optional
        As of `simulate`.
    progress : callable, optional
        Called with (t, t_end) [s].
    checkpoint : path, optional
        Where further checkpoints go; the same file by default.
    checkpoint_every : int, optional
        Major steps between checkpoints.
    inputs : mapping, optional
        Those of the run, where they are functions of time, samples or controllers.

    Returns
    -------
    Solution
        That of an uninterrupted run, bit for bit.

    Raises
    ------
    ModelError
        For a checkpoint of another model, of another version, or a damaged file; and what `simulate` raises.
    """
    kept, model = read_checkpoint(path), bound(model, inputs)
    header = kept.header
    kept.check_model(model, path)
    run_options = RunOptions(
        progress=progress, checkpoint=checkpoint or path, checkpoint_every=checkpoint_every
    ).checked()
    started = time.perf_counter()
    segments = _segments(model, kept, engine, path)
    segment, z = segments[header["segment"]], kept.z.copy()
    segment.monitor.resume(segment.state(z), header["monitor"])
    segment.impulses.update({at: Impulse(energy, np.array(jumps)) for at, energy, *jumps in header["impulses"]})
    keep_rows = bool(header["plan"]["outputs"]) or header["stream"] is not None
    folder, of_run = stream or header["stream"], str(header["stream_run"])
    if folder is not None and not of_run:
        raise ModelError(f"stream {folder}", "the run of the checkpoint was not streamed", "leave stream out")
    record = record_of(segment, z, folder, keep_rows, of_run)
    record.segments[:] = segments
    with record.closed_on_error():
        record.restore(kept.arrays, header["rows"], header["last_step"])
    plan = segments[0].plan
    begin = ConsistentState(kept.arrays["start_q"], kept.arrays["start_q_dot"], {})
    problem = Problem(model, kept.arrays["start_p"], begin, plan.t0, plan.t_end, dict(inputs or {}), engine)
    run = Run(
        problem,
        segment,
        z,
        record,
        run_options,
        header["initial_changes"],
        ChunkLength.of(segment.stepper.operations),
        [Event(**event) for event in header["events"]],
        singularity=SingularityMonitor.remembered(header["guard"]),
        earlier=kept.arrays.get("earlier"),
        comparison_times=comparison_times_of(problem, plan) if "mark_samples" in kept.arrays else None,
        started=started,
    )
    if run.comparison_times is not None:
        comparison_times = {name: kept.arrays[f"mark_{name}"] for name in ("sample_segments", "samples")}
        run.comparison_times.segments = record.segments
        run.comparison_times.restore(comparison_times, 0, -1)
        run.comparison_times.last_step = max(run.comparison_times.steps(), default=-1)
    run.event_handler.resume(header["happened"])
    schedule = problem.schedule(plan.grid.dt_L)
    schedule.resume(header["schedule"])
    run.follow(schedule)
    return finished(run, MotionError(reason=NOT_ASKED) if run.comparison_times is None else None)


def _segments(model: EmittedModel, kept: Checkpoint, engine: str, path: str | Path) -> list[SteppedModel]:
    """Those that the run has had, built again. Raises ModelError if z does not fit the one under way."""
    header = kept.header
    plan = Plan.of_numbers(model, header["plan"])
    begin = ConsistentState(kept.arrays["start_q"], kept.arrays["start_q_dot"], {})
    segments = [SteppedModel.of_run(model, plan, kept.p, engine, begin)]
    for q_i in header["segments"][1:]:
        variant = model if q_i == model.q_i else variant_of(model, q_i, np.array(header["position"]))
        segments.append(SteppedModel.of_run(variant, plan.on(variant), kept.p, engine, begin))
    current = segments[header["segment"]]
    fitting = current.stepper.start(0.0, model.initial_q, model.initial_q_dot, current.c, plan.grid.dt_L)
    if len(fitting) != len(kept.z):
        raise ModelError(
            f"checkpoint {path}",
            f"it holds a state of {len(kept.z)} numbers, where the steps of its scheme {plan.name} prepared here have "
            f"{len(fitting)}: they were prepared otherwise when it was written, as another version does",
            "go on with the version that wrote it, or start again",
        )
    return segments
