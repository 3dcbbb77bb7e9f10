"""A run at its start: prepared, compiled, checked, and ready to go."""

from __future__ import annotations

import time

from runtime.contract.status import Event
from runtime.running.arguments import Further
from runtime.running.marks import Marks
from runtime.running.plan import Plan
from runtime.running.problem import Problem
from runtime.running.record import record_of
from runtime.running.run import Run
from runtime.running.schedule import Schedule
from runtime.running.segment import Segment
from runtime.running.time_functions import check_time_functions
from runtime.schemes.options import SchemeError

ROUNDING = 1e-13  # m or rad: less is the dust of an assembly


def begun(
    problem: Problem, plan: Plan, marks: Marks | None, further: Further | None = None, quiet: bool = False
) -> Run:
    """The run of a plan at its checked start. quiet: of a companion or a rung, whose steps may miss what loads do.

    Raises ModelError, OutputError or CompilerError.
    """
    further = further or Further()
    started = time.perf_counter()
    state, rule = problem.state, further.rule()
    segment = Segment.build(problem.model, plan, problem.p, problem.engine, state)
    events = [Event(plan.t0, kind, text) for kind, text in state.told]
    if not quiet:
        events += check_time_functions(problem.model, segment.c, plan, state, segment.switches)
    z = segment.start(state.q, state.q_dot)
    changes = ", ".join(f"{key}: {a:.9g} -> {b:.9g}" for key, (a, b) in state.changed.items() if _differ(a, b))
    record = record_of(segment, z, further.stream, keep_rows=further.bounded)
    run = Run(
        segment,
        z,
        record,
        rule,
        changes or "none",
        None if isinstance(further.progress, bool) else further.progress,
        events,
        engine=problem.engine,
        guard=segment.new_guard(),
        marks=marks,
        start=(problem.p, state),
    )
    with record.closed_on_error():
        run.status = segment.monitor.first(segment.stepper.state(z))
        record.add(0, z[None])
        run.schedule = with_reads(problem.schedule(plan.grid.dt_L), run)
    run.set_up = time.perf_counter() - started
    return run


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
    return schedule if schedule.samples or schedule.controllers else None


def _differ(given: float, used: float) -> bool:
    """Do two values differ in one of nine digits, and by more than rounding where one of them is zero?"""
    return f"{given:.9g}" != f"{used:.9g}" and abs(given - used) > ROUNDING
