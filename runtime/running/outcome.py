"""What a run leaves: its Solution with how it ended, what it took, and its error.

The error is measured: the whole motion is made again with other steps, and the difference is the error. Steps 2^(1/p)
times as long err twice as much, so the plain difference is the error of the run. It is not divided by r^p - 1: where
modes are not resolved there is no order, and the difference is still of the error's size. At which times: see
comparison_times.py.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from logging import DEBUG, INFO, WARNING
from math import ceil
from typing import Any

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import euler_angles, followed
from runtime.contract.errors import printable
from runtime.contract.log import EVENTS, RUN
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event, Status
from runtime.results.motion_error import MotionError, amplitudes, motion_error
from runtime.results.samples import ONE_TIME_SHARE
from runtime.results.undefined import undefined_measures
from runtime.running.chattering import chattering
from runtime.running.comparison_times import common_steps, comparison_steps, coprime
from runtime.running.fastest_mode import RESOLVED_ANGLE, fastest_mode
from runtime.running.going_on import driven_inputs
from runtime.running.powers import powers_at
from runtime.running.problem import Plan, Problem
from runtime.running.record import ComparisonTimes, among
from runtime.running.run import Run, start_run
from runtime.running.stepped_model import SteppedModel
from runtime.running.time_functions import POINTS_OF_STEP, check_time_functions
from runtime.schemes.options import LARGEST_TOLERANCE
from runtime.solutions.solution import Solution

INACCURATE_ERROR = 0.1  # of an amplitude: the error from which a run is not accurate
LARGEST_OF_RATES = 0.5  # the same of rates: vibrations that hardly move anything have a part in them
WORTH_A_WORD = 0.03  # of an amplitude
NOT_ASKED = "it was switched off"  # why there is no error
SMALLER_STEP = "Take a smaller step, or a tolerance instead of a step."
SMALLER_TOLERANCE = "Take a smaller tolerance."


def finished(run: Run, error: MotionError | None = None, missed: Sequence[Event] = ()) -> Solution:
    """Go to the end and put the Solution together. error: where it is known or not wanted; else it is measured.

    missed: events of loads that steps of the run pass by, which it has not looked for itself.
    """
    try:
        return _ended(run, error, missed)
    finally:
        run.record.close()


def passed_by(run: Run, steps: float) -> list[Any]:
    """Loads that act in less than so many steps along the way of a run, as `short_loads` finds them."""
    if not run.segment.model.description.measures:
        return []
    from runtime.running.load_path import short_loads

    return list(short_loads(run, steps))


def _ended(run: Run, error: MotionError | None, missed: Sequence[Event]) -> Solution:
    status = run.integrate()
    happened = [*missed, *run.events, *(one.event for one in (passed_by(run, 1.0)[:1] if status.ok else ()))]
    run.record.flush()
    solution = run.sampled_solution()
    if not status.ok:
        from runtime.running.diagnose import laid_to_loads
        from runtime.running.domains import outside_its_domain

        found = outside_its_domain(status, solution, run.segment.with_inputs(run.z), run.plan.scheme.next_step(run.z))
        near = 2 * run.plan.grid.dt_L
        status = found if found is not status else laid_to_loads(status, solution, happened, near)
    stats = {**statistics(run.segment, run.z, run.set_up, run.seconds), **solution.stats, **_circumstances(run)}
    if divisions := sum(segment.divisions.steps for segment in run.record.segments):
        stats["divided_steps"] = divisions
    if run.plan.end is not None and not run.plan.scheme.adaptive:
        stats["last_step"] = run.plan.last_step
    events = sorted((event for event in happened if event.kind != "kink"), key=lambda event: event.time)
    if run.segment.model.description.kinks and run.segment.plan.scheme.options.kinks == "crossed":
        from runtime.results.crossed_kinks import crossed_kinks

        events += crossed_kinks(solution)
    elif len(events) < len(happened):
        stats["kinks"] = len(happened) - len(events)
        slides = chattering_of(run)
        events = sorted([*events, *slides], key=lambda event: event.time)
    solution = solution.but(status=status, stats=stats, events=events, parameters=run.segment.p, stops=_stops(run))
    solution = solution.but(powers=powers_at(solution.stops[:, 0], run.record.segments))
    solution = solution.but(driven=driven_inputs(run.problem.model, run.schedule, run.problem.inputs))
    began = time.perf_counter()
    if not status.ok:
        error = MotionError(reason=f"it is {status.name}")
    unresolved = unresolved_share(run, solution.q_dot)
    if unresolved:
        solution = solution.but(stats={**solution.stats, "unresolved_loads": unresolved})
    solution = with_error(
        solution,
        measured(run, solution).at_least(unresolved) if error is None else error,
        SMALLER_TOLERANCE if run.plan.refined or run.plan.scheme.adaptive else SMALLER_STEP,
    )
    if slides := [event for event in events if event.kind == "chattering"]:
        said = [solution.stats["remark"]] if "remark" in solution.stats else []
        solution = solution.but(stats={**solution.stats, "remark": "; ".join(map(str, [*said, slides[0].text]))})
    estimated = time.perf_counter()
    solution = with_limits(solution)
    parts = {"error_seconds": estimated - began, "limits_seconds": time.perf_counter() - estimated}
    solution = run.record.finished(solution.but(stats={**solution.stats, **parts}))
    _log(solution)
    return solution


def unresolved_share(run: Run, rates: np.ndarray) -> float:
    """Error of a rate behind loads that act for less than two steps, over the largest of the rates of a motion [1]."""
    off = max((segment.unresolved for segment in run.record.segments), default=0.0)
    size = float(np.abs(rates).max(initial=0.0))
    return min(1.0, off / size) if off and size else 0.0


def _log(solution: Solution) -> None:
    name, status = solution.model.name, solution.status
    for event in solution.events if EVENTS.isEnabledFor(DEBUG) else ():
        EVENTS.debug("%s: %s", name, printable(str(event)))
    how = f"{solution.scheme}, {solution.pace}"
    RUN.log(INFO if status.ok else WARNING, "%s: %s; %s; error %s", name, printable(str(status)), how, solution.error)


def chattering_of(run: Run) -> list[Event]:
    """What chatters in a run that has come to its end."""
    span = run.plan.time(run.step) - run.plan.t0
    return chattering(run.events, span / max(1, int(statistics(run.segment, run.z, 0.0, 0.0)["steps"])))


def _stops(run: Run) -> np.ndarray:
    """(S, 2) times at which the power of a run may jump [s], and the energy that an impulse put in there [J].

    A sample at the very time of a stop shows what is before it: inputs change behind the sample, loads before it. A
    kink at the start, such as of a wheel that stands on the road, is none: the power of the first sample goes on.
    """
    plan, segments = run.segment.plan, run.record.segments
    near_start = plan.t0 + ONE_TIME_SHARE * (run.plan.time(run.step) - plan.t0)
    impulses = {at: one.energy for segment in segments for at, one in segment.impulses.items()}
    found = {float(one.before): 0.0 for one in run.segment.switches if one.time not in impulses}
    found |= {event.time: 0.0 for event in run.events if event.kind in ("event", "mode", "rest")}
    found |= {event.time: 0.0 for event in run.events if event.kind == "kink" and event.time > near_start}
    if run.schedule is not None:
        found |= {plan.time(step): 0.0 for step in run.schedule.changes(run.step)}
    found |= impulses
    return np.array(sorted(found.items())).reshape(-1, 2)


def with_error(solution: Solution, error: MotionError, smaller: str = SMALLER_STEP) -> Solution:
    """The solution with its error, which its status and statistics tell; smaller: how to make that smaller."""
    stats: dict[str, float | int | str] = dict(solution.stats)
    status = solution.status
    if not error.measured:
        stats["error_not_measured"] = error.reason
        if error.reliable_until is not None and status.ok:
            status = Status("inaccurate", status.time, None, error.reason, smaller)
        return solution.but(error=error, stats=stats, status=status)
    stats |= {"error": error.largest, "error_of": error.of}
    worst = max(error.relative, key=lambda name: error.judged[name])
    rates = [name for name in error.judged if name not in error.relative]
    rate = max(rates, key=lambda name: error.judged[name], default=worst)
    bad, advice = error.judged[worst] > INACCURATE_ERROR, smaller[0].lower() + smaller[1:]
    if not bad and error.judged[rate] > LARGEST_OF_RATES:  # a rate is named where positions are right
        bad, worst = True, rate
    if error.reliable_until is not None:
        stats["reliable_until"] = error.reliable_until
    if bad and status.ok:
        cause = f"its error is {error.judged[worst]:.2g} of its amplitude"
        if error.reliable_until is not None:
            cause = f"{cause}; the motion is not to be relied on after t = {error.reliable_until:.4g} s"
        status = Status("inaccurate", status.time, worst, cause, smaller)
    elif error.judged[rate] > INACCURATE_ERROR:
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
    return {
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
    """The solution with what was found of flexible bodies, Euler angles and measures; the number of events is told."""
    if solution.model.elastic or euler_angles(solution.model):
        from runtime.running.limits import with_limits

        solution = with_limits(solution)
    if undefined := undefined_measures(solution):
        solution = solution.but(events=[*solution.events, *undefined])
    return solution.but(stats={**solution.stats, "events": len(solution.events)}) if solution.events else solution


# ---- The same motion with other steps ---------------------------------------------------------------------------

FIRST_PART = 1 / 20  # of a motion, in which methods that damp are compared with far shorter steps
SHORTER_COMPANION = (
    2  # times shorter steps, of which a regular error of order 2 leaves a quarter: where a run may be condemned
)
EARLY, FINER_COMPANION = 8, 4  # times there, and how much shorter those steps are
LONGER_PART = 4  # times: the next part, where the difference still grows
GROWS = 1.2  # times the difference in the first half of a part: a regular error has some 2.6 in the second
DOUBTED_ERROR = 2.0  # times the error that was compared_motion: what vibrations might bring it to at most
START_FINER = 8  # the same for methods whose steps pass by what dies out or lets go within one of them
SAVED = 20  # samples of a companion, which nobody sees but who looks for trouble
LEAST_STEPS_OF_LOAD = 4  # steps in the time in which a load acts


def comparison_times_of(problem: Problem, plan: Plan) -> ComparisonTimes:
    """Where a run of the plan is looked at, to be compared with its companion."""
    every = 1 if plan.scheme.adaptive else _common_steps(problem, plan)
    return ComparisonTimes(comparison_steps(plan.whole_steps, every), early_steps(plan.whole_steps))


def early_steps(steps: int) -> np.ndarray:
    """(N,) steps, rising, at which the first part of a motion of so many steps is looked at."""
    return comparison_steps(ceil(steps * FIRST_PART), most=EARLY)


def measured(run: Run, solution: Solution) -> MotionError:
    """The error of a run that came to its end, by its companion: longer steps, or where these are lost shorter ones.

    Where the first would condemn the run, the second has to agree; where both are lost, far shorter steps tell.
    """
    plan, comparison_times = run.record.segments[0].plan, run.comparison_times
    if comparison_times is None or not comparison_times.samples:
        return MotionError(reason="the run was not monitored")
    if not run.problem.forgets:
        return MotionError(reason="a controller has a memory of its own: declare it by Sampled(memory=...)")
    columns = followed(run.problem.model)[1]
    sampled = np.stack([solution.q[:, columns], solution.q_dot[:, columns]])
    sampled = np.concatenate(
        [sampled, comparison_times.compared_motion(run.problem.model)], axis=1
    )  # samples may be in phase with a vibration
    try:
        if any(event.kind == "load_missed" for event in solution.events):  # other steps of this length miss it, too
            for short in passed_by(run, LEAST_STEPS_OF_LOAD / POINTS_OF_STEP)[
                :1
            ]:  # even steps of an eighth may pass it by
                return MotionError(reliable_until=short.event.time, reason=short.event.text)
            return compared(run, comparison_times, sampled, 1 / POINTS_OF_STEP)
        if not among(comparison_times.at, np.array(comparison_times.steps())).any():  # an event has ended it soon
            return compared(run, comparison_times, sampled, 1 / FINER_COMPANION, early=True)
        found = MotionError(reason="its start is as the rest")
        if plan.scheme.passes_transients and not plan.scheme.adaptive:
            found = compared_behind_start(run, comparison_times, sampled, _ratio(plan))
        if not found.measured:
            found = compared(run, comparison_times, sampled, _ratio(plan))
        if not found.measured or max(found.judged.values()) > INACCURATE_ERROR:
            shorter = compared(run, comparison_times, sampled, 1 / SHORTER_COMPANION)
            found = min((one for one in (found, shorter) if one.measured), key=lambda one: one.largest, default=found)
        if not found.measured:
            found = compared(run, comparison_times, sampled, 1 / FINER_COMPANION)
        if found.measured and plan.scheme.damps:
            found = with_what_is_damped(run, comparison_times, sampled, found)
    except KeyboardInterrupt:
        return MotionError(reason="stopped by the user while it was measured")
    return found


def with_what_is_damped(
    run: Run, comparison_times: ComparisonTimes, sampled: np.ndarray, estimated: MotionError
) -> MotionError:
    """The error of a run: `compared_motion`, by steps of about its length, or what is lost to its steps where that
    is larger.

    Steps of about one length lose alike the vibrations that they damp. FINER_COMPANION times shorter ones keep
    these for longer, which the first part of the motion shows. An amplitude that decays, or a phase that drifts, is
    off in proportion to time at most: where the difference grows to the end of that part and could be more than was
    told at the end of the motion, a part LONGER_PART times as long is looked at, and so on. Where jumps of loads or
    events begin vibrations that are not resolved, it is the whole motion.
    """
    found, share, at = estimated, FIRST_PART, comparison_times.early
    sizes = amplitudes(run.problem.model, sampled[0])  # of the whole motion
    while True:
        pair = beside(
            run, comparison_times, at, 1, 1 if run.plan.scheme.adaptive else FINER_COMPANION, 1 / FINER_COMPANION
        )
        if isinstance(pair, MotionError):
            break
        error = pair.error(slice(None), sizes, sampled[1])
        found = found.with_larger(error)
        most = _sizes(error) / share
        if half := len(pair.t) // 2:
            first, second = (_sizes(pair.error(part, sizes, sampled[1])) for part in (slice(half), slice(half, None)))
            most[second <= GROWS * first] = 0.0
        excited = _excited_later(run)
        if share == 1.0 or not (excited or (most > DOUBTED_ERROR * _sizes(estimated)).any()):
            break
        share = 1.0 if excited else min(1.0, LONGER_PART * share)
        at = comparison_times.at[comparison_times.at <= share * comparison_times.at[-1]]
    return found


def _sizes(error: MotionError) -> np.ndarray:
    """(2,) the largest that is told, and that is judged, of rates, too."""
    return np.array([error.largest, max(error.judged.values())])


def _excited_later(run: Run) -> bool:
    """May a vibration that the steps of a run do not resolve begin behind its start?"""
    plan = run.record.segments[0].plan
    happens = run.segment.switches or run.schedule or any(event.time > plan.t0 for event in run.events)
    if plan.scheme.adaptive or not happens:
        return False
    fastest = fastest_mode(run.problem)
    return not plan.scheme.limited() if fastest is None else plan.grid.dt_L * fastest > RESOLVED_ANGLE


def _ratio(plan: Plan) -> float:
    return float(2 ** (1 / plan.scheme.order))


def _common_steps(problem: Problem, plan: Plan) -> int:
    """Steps of a run from one time at which its companion ends a step, too, to the next."""
    base = None if problem.spacing is None else round(problem.spacing / plan.grid.dt_L)
    whole = plan.whole_steps
    return common_steps(max(1, whole), _ratio(plan), base if base is not None and base < whole else None)


@dataclass(frozen=True)
class Pair:
    """What tells a run and its companion, and their rates, (2, N, n_told) each, at times t (N,) [s]."""

    model: EmittedModel
    t: np.ndarray
    run: np.ndarray
    companion: np.ndarray

    def error(self, part: slice, sizes: np.ndarray, rates: np.ndarray) -> MotionError:
        """Their difference in a part of the times, by amplitudes (n_told,) and rates (M, n_told) of the motion."""
        (q, v), (other_q, other_v) = self.run[:, part], self.companion[:, part]
        return motion_error(self.model, self.t[part], q, other_q, sizes, (v, other_v), rates)


def compared(
    run: Run, comparison_times: ComparisonTimes, sampled: np.ndarray, ratio: float, early: bool = False
) -> MotionError:
    """The difference to a companion whose steps are about `ratio` times as long; or why there is none.

    sampled_solution (2, N, n_told): of the whole run and of its rates, which tells its amplitudes. early: in its
    first part only.
    """
    plan = run.record.segments[0].plan
    a = 1 if plan.scheme.adaptive or early else _common_steps(run.problem, plan)
    b = 1 if plan.scheme.adaptive else FINER_COMPANION if early else coprime(a, ratio)
    pair = beside(run, comparison_times, comparison_times.early if early else comparison_times.at, a, b, ratio)
    if isinstance(pair, MotionError):
        return pair
    motion = sampled[0] if early else np.concatenate([pair.companion[0], sampled[0]])
    return pair.error(slice(None), amplitudes(pair.model, motion), sampled[1])


def beside(
    run: Run, comparison_times: ComparisonTimes, at: np.ndarray, a: int, b: int, ratio: float
) -> Pair | MotionError:
    """A run and a companion with b steps for each a of its, at steps of the run that are multiples of a; or why not."""
    problem, plan = run.problem, run.record.segments[0].plan
    at = at[among(at, np.array(comparison_times.steps()))]
    if not len(at):
        return MotionError(reason="the run is too short for it")
    other_times = ComparisonTimes(at // a * b)
    stepped = stepped_by(problem, plan, plan.grid.dt_L * a / b, int(other_times.at[-1]), ratio)
    other = start_run(problem, stepped, other_times, quiet=True, like=run)
    if ratio == 1 / POINTS_OF_STEP and (missed := [one for one in loads_missed(other) if one.kind == "load_missed"]):
        return MotionError(reliable_until=missed[0].time, reason=missed[0].text)
    status = other.integrate()
    if status.name == "interrupted":
        raise KeyboardInterrupt
    both = among(other_times.at, np.array(other_times.steps()))
    if status.ok and not both.any():
        return MotionError(reason="it ends before it can be compared")
    if not status.ok:
        reason = f"made again with steps of {other.segment.plan.grid.dt_L:.3g} s the motion ends as {status.name}"
        return MotionError(reliable_until=status.time, reason=f"{reason} at t = {status.time:.4g} s")
    model = problem.model
    return Pair(
        model,
        plan.times(at[both]),
        comparison_times.compared_motion(model, at[both]),
        other_times.compared_motion(model, other_times.at[both]),
    )


def compared_behind_start(
    run: Run, comparison_times: ComparisonTimes, sampled: np.ndarray, ratio: float
) -> MotionError:
    """The difference to a companion whose steps are about `ratio` times as long behind its first part, and START_FINER
    times shorter in it; not where inputs, events or other independent coordinates would have to go along.

    Steps that take the stiff part of the motion exactly pass by a contact that lets go, or a friction that begins to
    slide, within the first of them. Longer ones do the same, and what they miss goes on for ever.
    """
    problem, plan = run.problem, run.record.segments[0].plan
    a = _common_steps(problem, plan)
    b, first = coprime(a, ratio), a * ceil(plan.whole_steps * FIRST_PART / a)
    at = comparison_times.at[
        among(comparison_times.at, np.array(comparison_times.steps())) & (comparison_times.at > first)
    ]
    if problem.model.description.events or problem.inputs or len(run.record.segments) > 1 or not len(at):
        return MotionError(reason="it cannot be started with other steps")
    fine = stepped_by(problem, plan, plan.grid.dt_L / START_FINER, first * START_FINER, 1 / START_FINER)
    start = start_run(problem, fine, None, quiet=True, like=run)
    status = start.integrate()
    if status.name == "interrupted":
        raise KeyboardInterrupt
    if not status.ok:
        return MotionError(reason=f"with steps of {start.segment.plan.grid.dt_L:.3g} s it ends as {status.name}")
    there = start.sampled_solution()
    later = replace(problem, t0=plan.time(first), state=ConsistentState(there.q[-1], there.q_dot[-1], {}))
    beside = ComparisonTimes((at - first) // a * b)
    stepped = stepped_by(later, replace(plan, t0=later.t0), plan.grid.dt_L * a / b, int(beside.at[-1]), ratio)
    other = start_run(later, stepped, beside, quiet=True)
    status = other.integrate()
    if status.name == "interrupted":
        raise KeyboardInterrupt
    both = among(beside.at, np.array(beside.steps()))
    if not status.ok or not both.any():
        return MotionError(reason=f"with longer steps behind its start it ends as {status.name}")
    model = problem.model
    (mine, v), (theirs, other_v) = (
        comparison_times.compared_motion(model, at[both]),
        beside.compared_motion(model, beside.at[both]),
    )
    sizes = amplitudes(model, np.concatenate([theirs, sampled[0]]))
    return motion_error(model, plan.times(at[both]), mine, theirs, sizes, (v, other_v), sampled[1])


def loads_missed(run: Run) -> list[Event]:
    """What the steps of a run do not see of loads, and loads without a finite value."""
    segment, state = run.segment, run.problem.state
    return check_time_functions(segment.model, segment.c, segment.plan, state, segment.switches)


def stepped_by(problem: Problem, plan: Plan, dt: float, steps: int, ratio: float) -> Plan:
    """The plan of a companion."""
    options = None
    if plan.scheme.adaptive:
        dt, tolerance = plan.grid.dt_L, plan.options["tolerance"]
        larger = ratio > 1 and 2 * tolerance <= LARGEST_TOLERANCE
        options = {**plan.options, "tolerance": tolerance * (2 if larger else 0.5)}
    stepped = plan.with_steps(problem.model, dt, steps, options)
    return replace(stepped, seen_steps=max(1, steps // SAVED), outputs=(), force=True)
