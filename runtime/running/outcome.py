"""What a run leaves: its Solution with how it ended and what it took."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.files import OutputError
from runtime.contract.status import Status
from runtime.engine.choose import sub_step_operations
from runtime.results.export import run_header
from runtime.results.solution import Solution
from runtime.results.stream import StreamFile
from runtime.running.inaccurate import ADVICE, judged
from runtime.running.limits import with_limits
from runtime.running.run import Run
from runtime.running.second_opinion import MISSED, doubted, finer_misses_load, measured_errors, misses_load
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.evaluation import evaluation_operations


def finished(run: Run, setup: float) -> Solution:
    """Go to the end, and put the Solution together; setup: seconds that it took to come to the start."""
    run.record.watch = run.accuracy.watch  # what is written and forgotten widens the ranges, too
    with run.record.closed_on_error():
        solution = _ended(run, setup)
    run.record.close()
    return solution


def _ended(run: Run, setup: float) -> Solution:
    began = time.perf_counter()
    status = run.status if run.step == 0 and run.status is not None else run.go()
    status = _explained(status, run)
    wall = time.perf_counter() - began
    last = (run.record.segments.index(run.segment), run.segment.stepper.state(run.z))
    run.record.flush()
    solution = run.record.solution(last)
    if status.name == "completed":
        run.accuracy.look(run.segment, run.z, run.guard)
    run.accuracy.watch(solution.q, solution.q_dot)
    run.accuracy.widen(run.segment.model)
    if status.name == "completed":
        status = _measured(run, status, ConsistentState(solution.q[0], solution.q_dot[0], {}))
    circumstances = {**_circumstances(run), **run.accuracy.stats(run.segment.model)}
    stats = {**_statistics(run.segment, run.z, setup, wall), **solution.stats, **circumstances}
    _tell(run, stats)
    status = judged(status, run.accuracy, run.segment.model)
    solution = replace(solution, status=status, stats=stats, events=run.events, parameters=run.segment.p)
    solution = with_limits(replace(solution, stops=_stops(run)))
    table = run.record.table
    if isinstance(table, StreamFile):
        outputs = list(run.segment.plan.outputs)
        try:
            table.write_header({**run_header(solution), "parameters": run.segment.p.tolist(), "outputs": outputs})
        except OutputError as error:  # the header that is there says that the run did not come to its end
            solution = replace(solution, status=Status("output_failed", status.time, None, str(error)))
    return solution


def _stops(run: Run) -> np.ndarray:
    """(S, 2) times at which the power of a run may jump [s], and the energy that an impulse put in there [J].

    A sample at the very time of a stop shows what is before it: inputs change behind the sample, loads before it.
    """
    plan, segments = run.segment.plan, run.record.segments
    impulses = {at: one.energy for segment in segments for at, one in segment.impulses.items()}
    found = {float(one.before): 0.0 for one in run.segment.switches if one.time not in impulses}
    found |= {event.time: 0.0 for event in run.events if event.kind == "event"}
    if run.schedule is not None:
        found |= {plan.time(step): 0.0 for step in run.schedule.changes(run.step)}
    found |= impulses
    return np.array(sorted(found.items())).reshape(-1, 2)


def _explained(status: Status, run: Run) -> Status:
    """A breakdown where a load has no finite value, or acts between the steps, is its doing."""
    near = 2 * run.segment.plan.grid.dt_L
    endless = [one for one in run.events if one.kind == "load_not_finite" and one.time <= status.time + near]
    missed = [one for one in run.events if one.kind == "load_missed" and abs(one.time - status.time) <= near]
    if status.name not in ("not_finite", "diverged", "step_too_short") or not endless + missed:
        return status
    advice = "Let it be finite, or end the run before." if endless else "Give it a smaller step there."
    return Status(status.name, status.time, status.coordinate, (endless + missed)[0].text, advice)


def _measured(run: Run, status: Status, state: ConsistentState) -> Status:
    """Where the estimate of a run would condemn it, or is not believed: its error as the whole motion tells it.

    `inaccurate` where the motion that would tell it does not show the load either that the run has missed. That may
    take longer than the run, which is there already: Ctrl-C ends the measuring only.
    """
    model = run.segment.model
    if judged(status, run.accuracy, model).ok and not doubted(run, run.accuracy):
        return status
    try:
        found = measured_errors(run, state)
        unseen = found is not None and misses_load(run) and finer_misses_load(run, state)
    except KeyboardInterrupt:
        return status  # it stays what it was judged
    if unseen:
        missed = next(event for event in run.events if event.kind == "load_missed")
        return Status("inaccurate", status.time, None, f"{missed.text} (an eighth of it misses it, too)", ADVICE)
    run.accuracy.measured |= found or {}
    return status


def _tell(run: Run, stats: dict[str, float | int | str]) -> None:
    """What was said of the run before it began, beside its own statistics."""
    stats |= run.told
    if "expected_error" not in run.told:
        return
    passed = any(event.kind == "singular_position" for event in run.events)
    if passed and "trials_pass" not in run.told:  # no trial came near it
        del stats["expected_error"]
    elif "estimated_error" in stats:  # errors that grow with time are seen by trials, and not by windows
        expected, error = float(run.told["expected_error"]), float(stats["estimated_error"])
        stats["estimated_error"] = max(expected, error)
        asked = float(run.segment.plan.scheme.options.tolerance)  # type: ignore[attr-defined]
        if error > MISSED * max(expected, asked):
            stats["error_over_tolerance"] = error / asked
            said = (
                f"the error is estimated at {error:.2g} of an amplitude, where {asked:g} was asked and trials expected "
            )
            stats.setdefault("remark", f"{said}{expected:.2g}: take a smaller tolerance")


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


def _statistics(segment: Segment, z: np.ndarray, setup: float, wall: float) -> dict[str, float | int | str]:
    """Counts of evaluations, times [s] and operations of a run that has come to z (flat)."""
    layout, scheme, stepper = segment.plan.scheme.layout, segment.plan.scheme, segment.stepper
    steps = segment.step_of(z)
    iterations = int(z[layout.slice("iterations")][0])
    full, partial = scheme.evaluations()
    full_evaluations, sub_steps = iterations or steps * full, steps * partial
    taken: dict[str, float | int | str] = {}
    if isinstance(scheme, AdaptiveSteps):
        taken = scheme.taken(z)
        steps, full_evaluations = int(taken["steps"]), int(taken.pop("evaluations"))
    repeated = sub_step_operations(stepper.program) if partial else None
    whole = evaluation_operations(scheme) if repeated is not None else 0  # zero where all of it is constant
    cost = {"sub_step_cost": repeated / whole} if repeated is not None and whole else {}
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
