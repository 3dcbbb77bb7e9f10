"""What a run leaves: its Solution with how it ended and what it took."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from runtime.contract.coordinates import euler_angles
from runtime.contract.doors import opened
from runtime.contract.status import Status
from runtime.results.motion_error import MotionError
from runtime.results.solution import Solution
from runtime.running.run import Run, integrate
from runtime.running.stepped_model import SteppedModel

LARGEST = 0.1  # of an amplitude: the error from which a run is not accurate
LARGEST_OF_RATES = 0.5  # the same of rates: vibrations that hardly move anything have a part in them
WORTH_A_WORD = 0.03  # of an amplitude
ADVICE = "Take a smaller step, or a tolerance instead of a step."

Measure = Callable[[Run, Solution], MotionError]


def finished(run: Run, measure: Measure) -> Solution:
    """Go to the end, measure the error of what came to it, and put the Solution together."""
    with run.record.closed_on_error():
        solution = _ended(run, measure)
    run.record.close()
    return solution


def passed_by(run: Run, steps: float) -> list[Any]:
    """Loads that act in less than so many steps along the way of a run, as `short_loads` finds them."""
    loads = run.segment.model.description.measures and opened("runtime.running.load_path:short_loads")(run, steps)
    return loads or []


def _ended(run: Run, measure: Measure) -> Solution:
    status = integrate(run)
    if status.ok:
        run.events += [one.told for one in passed_by(run, 1.0)[:1]]
    run.record.flush()
    solution = run.seen()
    if not status.ok:
        laid = opened("runtime.running.diagnose:laid_to_loads")
        status = laid(status, solution, run.events, 2 * run.plan.grid.dt_L)
    stats = {**statistics(run.segment, run.z, run.set_up, run.seconds), **solution.stats, **_circumstances(run)}
    events = sorted((event for event in run.events if event.kind != "kink"), key=lambda event: event.time)
    if run.segment.model.description.kinks and run.segment.plan.scheme.options.kinks == "crossed":
        events += opened("runtime.results.kinks:crossed_kinks")(solution)
    elif len(events) < len(run.events):
        stats["kinks"] = len(run.events) - len(events)
    solution = solution.but(status=status, stats=stats, events=events, parameters=run.segment.p, stops=_stops(run))
    began = time.perf_counter()
    solution = with_error(solution, measure(run, solution) if status.ok else MotionError(reason=f"it is {status.name}"))
    measured = time.perf_counter()
    solution = with_limits(solution)
    parts = {"error_seconds": measured - began, "limits_seconds": time.perf_counter() - measured}
    return run.record.finished(solution.but(stats={**solution.stats, **parts}))


def _stops(run: Run) -> np.ndarray:
    """(S, 2) times at which the power of a run may jump [s], and the energy that an impulse put in there [J].

    A sample at the very time of a stop shows what is before it: inputs change behind the sample, loads before it.
    """
    plan, segments = run.segment.plan, run.record.segments
    impulses = {at: one.energy for segment in segments for at, one in segment.impulses.items()}
    found = {float(one.before): 0.0 for one in run.segment.switches if one.time not in impulses}
    found |= {event.time: 0.0 for event in run.events if event.kind in ("event", "mode", "rest")}
    if run.schedule is not None:
        found |= {plan.time(step): 0.0 for step in run.schedule.changes(run.step)}
    found |= impulses
    return np.array(sorted(found.items())).reshape(-1, 2)


def with_error(solution: Solution, error: MotionError) -> Solution:
    """The solution with its error, which its status and statistics tell."""
    stats: dict[str, float | int | str] = dict(solution.stats)
    status = solution.status
    if not error.measured:
        stats["error_not_measured"] = error.reason
        if error.reliable_until is not None and status.ok:
            status = Status("inaccurate", status.time, None, error.reason, ADVICE)
        return solution.but(error=error, stats=stats, status=status)
    stats |= {"error": error.largest, "error_of": error.of}
    worst = max(error.relative, key=lambda name: error.judged[name])
    rates = [name for name in error.judged if name not in error.relative]
    rate = max(rates, key=lambda name: error.judged[name], default=worst)
    bad, advice = error.judged[worst] > LARGEST, ADVICE[0].lower() + ADVICE[1:]
    if not bad and error.judged[rate] > LARGEST_OF_RATES:  # a rate is named where positions are right
        bad, worst = True, rate
    if error.reliable_until is not None:
        stats["reliable_until"] = error.reliable_until
    if bad and status.ok:
        cause = f"its error is {error.judged[worst]:.2g} of its amplitude"
        if error.reliable_until is not None:
            cause = f"{cause}; the motion is not to be relied on after t = {error.reliable_until:.4g} s"
        status = Status("inaccurate", status.time, worst, cause, ADVICE)
    elif error.judged[rate] > LARGEST:
        stats["remark"] = f"{rate} is off by {error.judged[rate]:.2g} of its size: {advice}"
    elif error.largest > WORTH_A_WORD:
        stats["remark"] = f"the error of {error.of} is {error.largest:.2g} of its amplitude: {advice}"
    return solution.but(error=error, stats=stats, status=status)


def _circumstances(run: Run) -> dict[str, float | int | str]:
    """What a run was made with, and what happened."""
    first, plan = run.record.segments[0], run.segment.plan
    found: dict[str, float | int | str] = {
        "initial_changes": run.initial_changes,
        "options": ", ".join(f"{key} = {getattr(plan.scheme.options, key)}" for key in plan.scheme.options.names()),
    }
    if run.segment.stepper.engine.note:
        found["engine_note"] = run.segment.stepper.engine.note
    if first.monitor.step_limit is not None:
        found["step_limit_at_start"] = first.monitor.step_limit
    return found


def statistics(segment: SteppedModel, z: np.ndarray, setup: float, wall: float) -> dict[str, float | int | str]:
    """Counts of evaluations, times [s] and operations of a run that has come to z (flat)."""
    layout, scheme, stepper = segment.plan.scheme.layout, segment.plan.scheme, segment.stepper
    steps = int(z[1])
    iterations = int(z[layout.slice("iterations")][0])
    full, partial = scheme.evaluations()
    full_evaluations, sub_steps = iterations or steps * full, steps * partial
    taken = scheme.taken(z)
    if taken:
        del taken["reached"]
        steps, full_evaluations = int(taken["steps"]), int(taken.pop("evaluations"))
    cost = {} if stepper.sub_step_cost is None else {"sub_step_cost": stepper.sub_step_cost}
    return {
        **cost,
        "steps": steps,
        "sub_steps": sub_steps,
        "full_evaluations": full_evaluations,
        "evaluations": full_evaluations + sub_steps,
        "iterations": iterations,
        **taken,
        "engine": stepper.engine.name,
        "operations_per_step": stepper.operations,
        "setup_seconds": setup,
        "wall_seconds": wall,
        "seconds_per_step": wall / max(1, steps),
    }


def with_limits(solution: Solution) -> Solution:
    """The solution with what was found of flexible bodies and Euler angles; the number of its events is told."""
    if solution.model.elastic or euler_angles(solution.model):
        solution = opened("runtime.running.limits:with_limits")(solution)
    return solution.but(stats={**solution.stats, "events": len(solution.events)}) if solution.events else solution
