"""Run a scheme on a model, or go on with a run from a checkpoint: the public doors."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypedDict

import numpy as np

from runtime.contract.model import Model, ModelError
from runtime.contract.status import Event, Status
from runtime.engine.choose import sub_step_operations
from runtime.results.export import run_header
from runtime.results.solution import Solution
from runtime.results.stream import StreamFile, Table
from runtime.running.checkpoint import check_model, check_settings, read_checkpoint
from runtime.running.leg import Leg
from runtime.running.plan import Plan, make_plan, whole_number
from runtime.running.record import Record, columns_of
from runtime.running.run import CheckpointRule, Progress, Run
from runtime.running.singular.guard import Guard
from runtime.running.singular.variants import variant_of
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.schemes.scheme import evaluation_operations
from runtime.start.start_state import start_state

__all__ = ["Plan", "make_plan", "resume", "simulate"]


class RunArguments(TypedDict, total=False):
    """The arguments of `simulate` besides the model and the scheme, for those who pass them on."""

    t_end: float | None
    dt: float | None
    m: list[int] | None
    parameters: Mapping[str, float] | None
    initial: Mapping[str, float] | None
    save_every: int | None
    engine: str
    options: Mapping[str, Any] | None
    t0: float
    progress: Progress | None
    force: bool
    start: str | None
    outputs: Sequence[str] | None
    stream: str | Path | None
    checkpoint: str | Path | None
    checkpoint_every: int | None


def simulate(
    model: Model,
    *,
    t_end: float | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    scheme: str | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    save_every: int | None = None,
    engine: str = "auto",
    options: Mapping[str, Any] | None = None,
    t0: float = 0.0,
    progress: Progress | None = None,
    force: bool = False,
    start: str | None = None,
    outputs: Sequence[str] | None = None,
    stream: str | Path | None = None,
    checkpoint: str | Path | None = None,
    checkpoint_every: int | None = None,
) -> Solution:
    """Simulate from t0 with major step dt and ratios m until t_end is reached (None: the scene's own settings).

    The steps are all dt long, so the run ends at t_end or less than one step after it.

    scheme: a name of runtime.schemes.catalogue.SCHEMES. options: changes to its Options by name.
    parameters and initial change values by name (rates as `<coordinate>_dot`). save_every counts major steps.
    progress(t, t_end) is called between native calls. start: `given` or `quasi_static` (elastic coordinates in
    equilibrium). A run whose step is above the stability limit at the start stops there, unless `force`.

    outputs: names of coordinates, rates, measures or energies; only these are kept of the saved samples, in
    Solution.outputs. stream: a folder that takes the samples instead of memory (runtime.results.stream). checkpoint:
    a file that `resume` goes on from, written every `checkpoint_every` major steps (None: every minute) and on Ctrl-C.

    Numerical failure does not raise: see Solution.status. Raises SchemeError, ModelError, InitialStateError,
    OutputError or CompilerError for arguments that cannot be used.
    """
    bounded = outputs is not None or stream is not None
    plan = make_plan(model, t_end, dt, m, scheme, save_every, options, t0, bounded)
    rule = _rule(checkpoint, checkpoint_every)
    p = model.parameter_vector(parameters)
    state = start_state(model, p, model.constants(p), t0, initial, start)
    started = time.perf_counter()
    leg = Leg.build(model, plan, p, engine, force)
    z = leg.start(state.q, state.q_dot)
    set_up = time.perf_counter()
    changes = ", ".join(f"{key}: {given:.9g} -> {used:.9g}" for key, (given, used) in state.changed.items())
    settings = _Settings(plan, force, tuple(outputs or ()), changes or "none")
    record = _record(leg, settings, z, stream, keep_rows=bounded)
    run = Run(leg, z, record, rule, settings.header(model), progress, engine=engine, guard=leg.new_guard())
    run.status = leg.watch.first(leg.stepper.state(z))
    record.add(0, z)
    return _finished(run, settings, set_up - started)


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
) -> Solution:
    """Go on with the run of a checkpoint to its end; the Solution is that of an uninterrupted run, bit for bit.

    stream: the run's own folder where it has moved. checkpoint: where further ones go (the same file by default).
    scheme, dt, m and options need not be said again; they are compared with the run's own. Raises ModelError for a
    checkpoint of another model or a damaged file, SchemeError for other settings, and what `simulate` raises.
    """
    kept = read_checkpoint(path)
    header = kept.header
    check_model(kept, model, path)
    check_settings(kept, {"scheme": scheme, "dt": dt, "m": m, "options": options}, path)
    settings = _Settings.of(model, header)
    started = time.perf_counter()
    legs = [Leg.build(model, settings.plan, kept.p, engine, settings.force)]
    for q_i in header["legs"][1:]:
        variant = model if q_i == model.q_i else variant_of(model, q_i, np.array(header["place"]))
        legs.append(Leg.build(variant, settings.plan.on(variant), kept.p, engine, True))
    leg = legs[int(header["leg"])]
    if len(leg.stepper.start(0.0, model.initial_q, model.initial_q_dot, leg.c, settings.plan.grid.dt_L)) != len(kept.z):
        raise ModelError(
            f"checkpoint {path} holds a state of another length than this scheme's; it was written by another version"
        )
    set_up = time.perf_counter()
    z = kept.z.copy()
    leg.watch.resume(leg.stepper.state(z), [float(value) for value in header["watch"]])
    record = _record(
        leg,
        settings,
        z,
        stream or header["stream"],
        keep_rows=bool(settings.outputs) or header["stream"] is not None,
        resumed=True,
    )
    record.legs[:] = legs
    record.restore(kept.arrays, int(header["rows"]), int(header["last_step"]))
    run = Run(
        leg,
        z,
        record,
        _rule(checkpoint or path, checkpoint_every),
        settings.header(model),
        progress,
        [Event(*event) for event in header["events"]],
        engine=engine,
        guard=Guard.remembered(header["guard"]),
        earlier=kept.arrays.get("earlier"),
    )
    return _finished(run, settings, set_up - started)


@dataclass(frozen=True)
class _Settings:
    """What a checkpoint says of a run besides where it is."""

    plan: Plan
    force: bool
    outputs: tuple[str, ...]
    initial_changes: str

    def header(self, model: Model) -> dict[str, Any]:
        """In JSON."""
        plan = self.plan
        return {
            "model": model.name,
            "digest": model.digest,
            "scene_toml": model.scene_toml,
            "scheme": plan.name,
            "dt": plan.grid.dt_L,
            "m": list(plan.grid.m),
            "options": dict(plan.options),
            "t0": plan.t0,
            "steps": plan.steps,
            "save_every": plan.save_every,
            "force": self.force,
            "outputs": list(self.outputs),
            "initial_changes": self.initial_changes,
        }

    @classmethod
    def of(cls, model: Model, header: Mapping[str, Any]) -> _Settings:
        """From a checkpoint's header."""
        options = {
            name: tuple(value) if isinstance(value, list) else value for name, value in header["options"].items()
        }
        built = scheme_kind(header["scheme"]).build(header["scheme"], model, header["dt"], header["m"] or None, options)
        plan = Plan(header["scheme"], built, options, int(header["steps"]), int(header["save_every"]), header["t0"])
        return cls(plan, bool(header["force"]), tuple(header["outputs"]), str(header["initial_changes"]))


def _rule(path: str | Path | None, every: int | None) -> CheckpointRule:
    chosen = None if every is None else whole_number(every)
    if every is not None and (chosen is None or chosen < 1):
        raise SchemeError(f"checkpoint_every must be a whole number of major steps of at least 1, not {every!r}")
    if every is not None and path is None:
        raise SchemeError("checkpoint_every needs a file: checkpoint = ...")
    return CheckpointRule(None if path is None else Path(path), chosen)


def _record(
    leg: Leg, settings: _Settings, z: np.ndarray, stream: str | Path | None, keep_rows: bool, resumed: bool = False
) -> Record:
    """Whole states in memory, columns in memory, or a stream. Raises OutputError or ModelError."""
    table: Table | None = None
    if keep_rows:
        seen = leg.observed([leg.stepper.state(z)])
        columns = columns_of(seen, settings.outputs)
        if stream is None:
            table = Table(columns)
        else:
            table = StreamFile(stream, columns, resumed)
            running = Status(
                "interrupted", leg.plan.t0, None, "the run did not come to its end", "What was streamed is there."
            )
            table.write_header(
                {
                    **run_header(replace(seen, status=running)),
                    "parameters": leg.p.tolist(),
                    "outputs": list(settings.outputs),
                }
            )
    return Record([leg], leg.plan.save_every, table, settings.outputs)


def _finished(run: Run, settings: _Settings, setup: float) -> Solution:
    """Go, and put the Solution together."""
    began = time.perf_counter()
    status = run.status if run.step == 0 and run.status is not None else run.go()
    wall = time.perf_counter() - began
    last = (run.record.legs.index(run.leg), run.leg.stepper.state(run.z))
    run.record.flush()
    solution = run.record.solution(last)
    stats = {**_statistics(run.leg, run.z, setup, wall), **solution.stats, "initial_changes": settings.initial_changes}
    plan = settings.plan
    stats["options"] = ", ".join(f"{key} = {getattr(plan.scheme.options, key)}" for key in scheme_kind(plan.name).takes)
    if run.leg.stepper.engine.note:
        stats["engine_note"] = run.leg.stepper.engine.note
    if run.record.legs[0].watch.step_limit is not None:
        stats["step_limit_at_start"] = run.record.legs[0].watch.step_limit
    if run.events:
        stats["events"] = len(run.events)
    solution = replace(solution, status=status, stats=stats, events=run.events, parameters=run.leg.p)
    table = run.record.table
    if isinstance(table, StreamFile):
        table.write_header(
            {**run_header(solution), "parameters": run.leg.p.tolist(), "outputs": list(settings.outputs)}
        )
        table.close()
    return solution


def _statistics(leg: Leg, z: np.ndarray, setup: float, wall: float) -> dict[str, float | int | str]:
    layout, scheme, stepper = leg.plan.scheme.layout, leg.plan.scheme, leg.stepper
    steps = leg.step_of(z)
    iterations = int(z[layout.slice("iterations")][0])
    full, partial = scheme.evaluations()
    full_evaluations, sub_steps = iterations or steps * full, steps * partial
    repeated = sub_step_operations(stepper.program) if partial else None
    cost = {} if repeated is None else {"sub_step_cost": repeated / evaluation_operations(scheme)}
    return {
        **cost,
        "steps": steps,
        "sub_steps": sub_steps,
        "full_evaluations": full_evaluations,
        "evaluations": full_evaluations + sub_steps,
        "iterations": iterations,
        "engine": stepper.engine.name,
        "operations_per_step": stepper.operations,
        "setup_seconds": setup,
        "wall_seconds": wall,
        "seconds_per_step": wall / max(1, steps),
    }
