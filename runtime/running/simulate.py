"""Run a scheme on a model: the public door."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, Unpack

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.initial_values import Initial
from runtime.contract.model import Model
from runtime.contract.refused_events import refuse_events
from runtime.contract.status import Event
from runtime.operating.given_state import given_state
from runtime.results.solution import Solution
from runtime.running.accuracy import Accuracy
from runtime.running.arguments import Further, FurtherArguments
from runtime.running.calibration import Calibration
from runtime.running.checkpoint import CheckpointRule
from runtime.running.driven import driven_solution
from runtime.running.inputs import InputValue, bound, scheduled, started
from runtime.running.outcome import finished
from runtime.running.plan import Plan, make_plan
from runtime.running.record import record_of
from runtime.running.run import Run
from runtime.running.schedule import Schedule
from runtime.running.segment import Segment
from runtime.running.time_functions import check_time_functions
from runtime.running.tolerance import with_tolerance
from runtime.running.trials import trials_of
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.options import SchemeError
from runtime.start.start_state import start_state

ROUNDING = 1e-13  # m or rad: less is the dust of an assembly

__all__ = ["Plan", "make_plan", "simulate"]


def simulate(
    model: Model,
    *,
    t_end: float | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    scheme: str | None = None,
    tolerance: float | None = None,
    options: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Initial = None,
    start: str | None = None,
    t0: float = 0.0,
    inputs: Mapping[str, InputValue] | None = None,
    calibration: Calibration | None = None,
    advice: str = "",
    **further: Unpack[FurtherArguments],
) -> Solution:
    """Simulate from t0 with major step dt and ratios m until t_end is reached (None: the scene's own settings) [s].

    The steps are all dt long, so the run ends at t_end or less than one step after it. With a tolerance (relative to
    the amplitudes) they vary: dt is then the time between states that are seen, and the run ends at t_end. Where every
    coordinate is driven there is nothing to step: see runtime.running.driven.

    scheme: a name of runtime.schemes.catalogue.SCHEMES. options: changes to its Options by name. parameters
    and initial change values by name (rates as `<coordinate>_dot`); initial may also be an equilibrium, or a solution,
    from whose last sample the run goes on (`run.initial_values(at=0.3)`: from another). start: `given`, `quasi_static`
    (elastic coordinates in equilibrium) or `equilibrium` (all but those that turn). inputs: by name a number, a
    function of time (called once with a symbol), (times, values) held in between, or a `Sampled` controller.
    calibration: what trials for the tolerance told, where they were made already; advice: why this scheme, for the
    statistics. further: see `Further`.

    Numerical failure does not raise: see Solution.status. Raises SchemeError, ModelError, InitialStateError,
    OutputError or CompilerError for arguments that cannot be used.
    """
    more, model = Further(**further), bound(model, inputs)
    if not model.q_i:
        refuse_events(model, "a motion in which every coordinate is driven")
        return _driven(model, t_end, dt, parameters, initial, t0, more, inputs)
    options, dt, every = with_tolerance(model, scheme, tolerance, options, t_end, dt, more.save_every, t0)
    plan = make_plan(model, t_end, dt, m, scheme, every, options, t0, more.bounded)
    plan = replace(plan, force=more.force, outputs=tuple(more.outputs or ()))
    rule = more.rule()
    schedule = scheduled(model, inputs, t0, plan.grid.dt_L)
    p = started(model, model.parameter_vector(parameters), schedule, t0)
    state = start_state(model, p, model.constants(p), t0, initial, start)
    steady = not (schedule.samples or schedule.controllers)  # else the motion cannot be tried

    def calibrated(segment: Segment) -> Calibration | None:
        if not steady or segment.watches_events:
            return None
        if calibration is not None and not calibration.alarmed:
            return calibration
        return trials_of(segment, state, more.engine)

    run, set_up = _begun(model, plan, p, state, more, rule, calibrated)
    run.schedule = with_reads(schedule, run)
    run.told |= {"advice": advice} if advice else {}
    return finished(run, set_up)


def with_reads(schedule: Schedule, run: Run) -> Schedule | None:
    """The schedule for a run, None if it changes nothing. Raises SchemeError for a checkpoint with an unkept memory."""
    for controller in schedule.controllers:
        if controller.memory is None and run.rule.path is not None:
            raise SchemeError(
                "checkpoint",
                f"what the controller of {controller.name!r} remembers cannot be kept",
                "give its numbers as Sampled(..., memory=[...]), memory=() if it has none, or leave the checkpoint out",
            )
        controller.read_from(run.segment.model, run.segment.plan.scheme, run.segment.c)
    if not schedule.samples and not schedule.controllers:
        return None
    run.accuracy.carried.ended = True  # what a controller would do beside the run is not known
    return schedule


def _begun(
    model: Model,
    plan: Plan,
    p: np.ndarray,
    state: ConsistentState,
    more: Further,
    rule: CheckpointRule,
    calibrated: Callable[[Segment], Calibration | None],
) -> tuple[Run, float]:
    """(a run at its checked start with parameters p (n_p,), seconds that preparing it took)."""
    started = time.perf_counter()
    segment = Segment.build(model, plan, p, more.engine, state)
    events = [Event(plan.t0, kind, text) for kind, text in state.told]
    events += check_time_functions(model, segment.c, plan, state, segment.switches)
    z = segment.start(state.q, state.q_dot)
    known, plan = calibrated(segment), segment.plan
    if known is None and isinstance(plan.scheme, AdaptiveSteps) and not plan.scheme.varies:
        raise SchemeError(
            "tolerance",
            f"{plan.name} takes steps of one length that trials find, and this motion cannot be tried",
            "take exponential_rk4, or a step dt",
        )
    if known is not None and isinstance(plan.scheme, AdaptiveSteps):
        known.begin(plan.scheme, z)
        segment.tried = known.states if known.stepper and known.stepper.program is segment.stepper.program else None
    set_up = time.perf_counter() - started
    changes = ", ".join(f"{key}: {a:.9g} -> {b:.9g}" for key, (a, b) in state.changed.items() if _differ(a, b))
    progress = None if isinstance(more.progress, bool) else more.progress
    record = record_of(segment, z, more.stream, keep_rows=more.bounded)
    run = Run(
        segment,
        z,
        record,
        rule,
        changes or "none",
        progress,
        events,
        engine=more.engine,
        guard=segment.new_guard(),
        accuracy=Accuracy(plan.steps, plan.scheme.adaptive),
        told=known.told() if known is not None else {},
    )
    with record.closed_on_error():
        run.status = segment.monitor.first(segment.stepper.state(z))
        record.add(0, z)
    return run, set_up


def _driven(
    model: Model,
    t_end: float | None,
    dt: float | None,
    parameters: Mapping[str, float] | None,
    initial: Initial,
    t0: float,
    more: Further,
    inputs: Mapping[str, InputValue] | None,
) -> Solution:
    """The motion of a model in which every coordinate is driven: nothing is stepped, whatever the scheme."""
    if more.outputs is not None or more.stream is not None or more.checkpoint is not None:
        raise SchemeError(
            "outputs, stream, checkpoint",
            f"belong to runs that step, and every coordinate of model {model.name} is driven",
            "leave them out",
        )
    settings = model.simulation
    end, step = float(settings["t_end"] if t_end is None else t_end), float(settings["dt"] if dt is None else dt)
    every = int(settings["save_every"] if more.save_every is None else more.save_every)
    if not (np.isfinite([end, step]).all() and step > 0 and end > t0 and every >= 1):
        raise SchemeError("t_end, dt, save_every", "do not make a motion", "take t_end > t0, dt > 0, save_every >= 1")
    schedule = scheduled(model, inputs, t0, step)
    if schedule.controllers:
        raise SchemeError(
            "inputs", "a controller has nothing to act on where every coordinate is driven", "give samples"
        )
    p = started(model, model.parameter_vector(parameters), schedule, t0)
    state = given_state(model, p, model.constants(p), t0, initial)
    return driven_solution(model, p, state, t0, end, step, every, schedule)


def _differ(given: float, used: float) -> bool:
    """Do two values differ in one of nine digits, and by more than rounding where one of them is zero?"""
    return f"{given:.9g}" != f"{used:.9g}" and abs(given - used) > ROUNDING
