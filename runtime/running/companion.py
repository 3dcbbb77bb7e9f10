"""The error of a run, measured: the whole motion is made again with other steps, and the difference is the error.

Steps 2^(1/p) times as long err twice as much, so the plain difference is the error of the run. It is not divided by
r^p - 1: where modes are not resolved there is no order, and the difference is still of the error's size. The numbers of
steps between two marks have no common divisor, else both see a periodic force at like phases.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import count
from math import ceil, gcd

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.status import Event
from runtime.results.motion_error import MotionError, amplitudes, motion_error, with_rates
from runtime.results.solution import Solution
from runtime.running.outcome import LARGEST, passed_by
from runtime.running.plan import Plan
from runtime.running.problem import Problem
from runtime.running.record import Marks
from runtime.running.run import Run, begun, integrate
from runtime.running.time_functions import INSIDE, check_time_functions

MARKS = 20  # times at which two motions are compared, about
SHORTEST, LONGEST = 10, 20  # steps from mark to mark of a short run; of longer ones so many numbers are looked at
LEAST = 4  # steps in the time in which a load acts
REST = 3.0  # price of what lies behind the last mark, beside the distance of a ratio from the one that is wanted
EARLY, FINER = 8, 4  # marks in the first stretch of a method that damps, and how much shorter steps there are


@cache
def steps_of_mark(steps: int, ratio: float, base: int | None = None) -> int:
    """a: so many steps of a run as have a number b of steps in the same time that has no divisor in common with it.

    ratio: what a / b should be. base: steps of the run between times at which both have to end a step, if there are.
    """
    longest = max(LONGEST, steps // MARKS)
    choices: Sequence[int] = range(min(steps, longest - SHORTEST), min(steps, longest) + 1)
    if base is not None:
        choices = [a for a in choices if base % a == 0] or [base]

    def distance(a: int) -> float:
        return float(abs(np.log(a / coprime(a, ratio) / ratio))) + REST * (steps % a) / steps

    return min(choices, key=distance)


def coprime(a: int, ratio: float) -> int:
    """The number nearest to a / ratio, in proportion, that has no divisor with a in common and is not a."""
    wanted = a / ratio
    below = next((b for b in range(int(wanted), 0, -1) if b != a and gcd(a, b) == 1), None)
    above = next(b for b in count(int(wanted) + 1) if b != a and gcd(a, b) == 1)
    return above if below is None or above / wanted < wanted / below else below


def marks_of(problem: Problem, plan: Plan) -> Marks:
    """Where a run of the plan is looked at, to be compared with its companion."""
    a = _steps_of_mark(problem, plan)
    every = a * ceil(plan.steps / (a * 2 * MARKS))
    return Marks(every, every // min(EARLY, every))


def measured(run: Run, solution: Solution) -> MotionError:
    """The error of a run that came to its end, by its companion: longer steps, or where these are lost shorter ones.

    Where the first would condemn the run, the second has to agree; where both are lost, far shorter steps tell.
    """
    plan, marks = run.record.segments[0].plan, run.marks
    if marks is None or not marks.samples:
        return MotionError(reason="the run was not looked at on its way")
    if not run.problem.forgets:
        return MotionError(reason="a controller keeps a memory of its own: give its numbers as Sampled(memory=...)")
    try:
        if any(event.kind == "load_missed" for event in run.events):  # other steps of this length miss it, too
            if (short := _too_short(run)) is not None:
                return MotionError(reliable_until=short.time, reason=short.text)
            return _compared(run, marks, solution, 1 / INSIDE)
        if marks.last_step < marks.every:  # an event has ended it soon
            return _compared(run, marks, solution, 1 / FINER, early=True)
        found = _compared(run, marks, solution, _ratio(plan))
        if not found.measured or max(found.judged.values()) > LARGEST:
            shorter = _compared(run, marks, solution, 1 / _ratio(plan))
            found = min((one for one in (found, shorter) if one.measured), key=lambda one: one.largest, default=found)
        if not found.measured:
            found = _compared(run, marks, solution, 1 / FINER)
        if found.measured and plan.scheme.damps:
            early = _compared(run, marks, solution, 1 / FINER, early=True)
            found = max((one for one in (found, early) if one.measured), key=lambda one: max(one.judged.values()))
    except KeyboardInterrupt:
        return MotionError(reason="stopped by the user while it was measured")
    return found


def _too_short(run: Run) -> Event | None:
    """What acts so shortly that even steps of an eighth may pass it by."""
    return next((one.told for one in passed_by(run, LEAST / INSIDE)), None)


def _ratio(plan: Plan) -> float:
    return float(2 ** (1 / plan.scheme.order))


def _steps_of_mark(problem: Problem, plan: Plan) -> int:
    base = None if problem.spacing is None else round(problem.spacing / plan.grid.dt_L)
    return steps_of_mark(plan.steps, _ratio(plan), base if base is not None and base < plan.steps else None)


def _compared(run: Run, marks: Marks, solution: Solution, ratio: float, early: bool = False) -> MotionError:
    """The difference to a companion whose steps are about `ratio` times as long; or why there is none."""
    problem, plan = run.problem, run.record.segments[0].plan
    if plan.scheme.adaptive:
        a = b = marks.early if early else marks.every
    elif early:
        a, b = marks.early, marks.early * FINER
    else:
        a = _steps_of_mark(problem, plan)
        b = coprime(a, ratio)
    every = marks.every // a * b if not early else b
    seen = marks.steps()
    shown = marks.every // a if early else min(plan.steps // marks.every, len(seen))
    if not shown:
        return MotionError(reason="the run is too short for it")
    stepped = stepped_by(problem, plan, plan.grid.dt_L * a / b, every * shown, every, ratio)
    other = begun(problem, stepped, None, quiet=True, like=run)
    if ratio == 1 / INSIDE and (missed := [one for one in loads_missed(other) if one.kind == "load_missed"]):
        return MotionError(reliable_until=missed[0].time, reason=missed[0].text)
    status = integrate(other)
    if status.name == "interrupted":
        raise KeyboardInterrupt
    step = marks.early if early else marks.every
    common = [k for k in range(1, shown + 1) if k * step in seen and k * every <= other.record.last_step]
    if status.ok and not common:
        return MotionError(reason="it ends before it is looked at twice")
    if not status.ok:
        reason = f"made again with steps of {other.segment.plan.grid.dt_L:.3g} s the motion ends as {status.name}"
        return MotionError(reliable_until=status.time, reason=f"{reason} at t = {status.time:.4g} s")
    model = problem.model
    mine, v = marks.told(model, [k * step for k in common])
    theirs, other_v = other.record.told(model, [k * every for k in common])
    t = np.array([plan.time(k * step) for k in common])
    sizes = amplitudes(model, np.concatenate([mine, theirs, solution.q[:, followed(model)[1]]]))
    return with_rates(motion_error(model, t, mine, theirs, sizes), model, v, other_v)


def loads_missed(run: Run) -> list[Event]:
    """What the steps of a run do not see of loads, and loads without a finite value."""
    segment, state = run.segment, run.problem.state
    return check_time_functions(segment.model, segment.c, segment.plan, state, segment.switches)


def stepped_by(problem: Problem, plan: Plan, dt: float, steps: int, every: int, ratio: float) -> Plan:
    """The plan of a companion."""
    options = None
    if plan.scheme.adaptive:
        dt, tolerance = plan.grid.dt_L, min(plan.options["tolerance"] * (2 if ratio > 1 else 0.5), 0.1)
        options = {**plan.options, "tolerance": tolerance}
    return replace(plan.with_steps(problem.model, dt, steps, options), seen_steps=every, outputs=(), force=True)
