"""A tolerance by step refinement: whole motions by one method, each level with more steps, until two agree well
enough.

The error of a level is measured as that of any run: by what it differs from the level before. Which method is refined
is decided in method_choice.py by the operations that its first level takes; `auto`, advice and comparisons read
such refinements.

It is step refinement by the global error, with Richardson extrapolation
where the order of the truncation error shows (E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential
Equations I, 2nd ed., Springer 1993, sections II.4 and II.9). Step size control by the local error is in
schemes/step_size_controller.py.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import ceil, gcd, inf
from typing import Any

import numpy as np

from runtime.contract.log import REFINEMENT
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event, Status
from runtime.results.motion_error import MotionError, amplitudes, motion_error
from runtime.running.comparison_times import comparison_steps, refined, shared
from runtime.running.fastest_mode import RESOLVED_ANGLE, fastest_mode, slopes_at_start
from runtime.running.method_choice import FIRST_LEVEL_STEPS, TOLERANCE_SAFETY, Method, chosen_method, stable_steps
from runtime.running.outcome import (
    INACCURATE_ERROR,
    chattering_of,
    comparison_times_of,
    early_steps,
    finished,
    loads_missed,
    passed_by,
    unresolved_share,
    with_what_is_damped,
)
from runtime.running.problem import (
    AUTO,
    DEFAULT,
    MAX_SAMPLES,
    SPAN_ROUNDING,
    Plan,
    Problem,
    checked_plan,
    common_time,
    refuse_alike,
)
from runtime.running.record import ComparisonTimes, among
from runtime.running.run import Run, start_run
from runtime.running.run_options import RunOptions
from runtime.running.steps_for_loads import steps_for_loads
from runtime.running.turns import frequency_at_start, frequency_at_states
from runtime.schemes.options import SchemeError
from runtime.solutions.solution import Solution

SEES_SHORT = 8  # steps in the time in which a load acts
MOST_GROWTH = 2.5  # times the steps of the level before
AFTER_LOST = 3.0  # the same, where the motion was lost
MOST_FINER = 10.0  # the same, where its steps turned a loop too far
MOST_CHATTERING = 5000  # steps of a level that crosses a kink at nearly every one
SHOWN_ORDER = 0.8  # of the order of a method: where three levels show that much, the error is half of the difference
ORDER_BISECTIONS = 40  # of the order that is shown
LEVEL_SAMPLES = 1000  # samples of a level that is kept
MOST_LEVEL_STEPS = 10**8
MOST_OPERATIONS_OF_LEVELS = 10**12  # of all levels: some minutes
MOST_RESOLVING = 10**10  # operations of a level that resolves the fastest mode: seconds
STAGNANT_DIFFERENCE = 0.5  # of a difference: levels that do not come below it any more will not
LEVELS_TO_STAGNATE = 6  # levels before that is said
UNRESOLVED_LEVELS_TO_STAGNATE = 11  # the same, where the motion is not resolved yet
RICHARDSON_SAFETY = 3.0  # times the error by extrapolation where the order shows: on the safe side
ACCURATE = 0.5  # of the error from which a run is not accurate: what nobody has graded stays below
BEFORE_END = 50  # steps before the end of a level that stops early, from which on its end can be believed
END_KNOWN = 2  # steps of a level, to which the time of its end is known
MOST_ENDING = 10**10  # operations of levels that stop early, each at another time: seconds


@dataclass(frozen=True)
class RefinementLevel:
    """A whole motion in so many steps.

    seconds: of CPU from its start to its end. differs: from the level before, relative to the amplitudes, NaN where
    there is none; error: what is taken for its error, on the safe side; compared_motion: what is most likely, by
    Richardson's extrapolation where the order shows.
    """

    steps: int
    run: Run
    comparison_times: ComparisonTimes
    status: Status
    seconds: float = 0.0
    differs: float = np.nan
    error: float = np.nan
    estimated: MotionError = field(default_factory=lambda: MotionError(reason="there is no coarser level"))

    @cached_property
    def reached(self) -> np.ndarray:
        """(N,) steps of `comparison_times.at` that the motion has come to; an event may end it before."""
        return np.asarray(
            self.comparison_times.at[among(self.comparison_times.at, np.array(self.comparison_times.steps()))]
        )

    @cached_property
    def compared(self) -> np.ndarray:
        """(2, N, n_told) what tells the motion and its rates there."""
        return self.comparison_times.compared_motion(self.run.problem.model, self.reached)

    @cached_property
    def sampled(self) -> np.ndarray:
        """(2, N, n_told) the same at its samples, which may be in phase with a vibration, and there."""
        return np.concatenate([self.run.record.compared_motion(self.run.problem.model), self.compared], axis=1)

    @property
    def lost(self) -> bool:
        """Did the motion not come to its end?"""
        return not self.status.ok


def by_step_refinement(
    problem: Problem,
    tolerance: float,
    scheme: str,
    m: list[int] | None,
    options: Mapping[str, Any],
    spacing: float | None,
    run_options: RunOptions,
) -> Solution:
    """The motion to a tolerance, as the last level of a refinement. spacing [s]: of the samples; None: as the steps
    are.

    Raises what `simulate` raises.
    """
    refinement = StepRefinement(problem, tolerance, spacing, run_options)
    if scheme == AUTO:
        method, _ = chosen_method(problem)
    else:
        method = Method(scheme, None if m is None else tuple(m), options)
    levels, total = [], 0.0
    for level in refinement.refine(method):
        levels.append(level)
        total += level.steps
        if level.status.name == "interrupted":
            break
    return refinement.solution(levels, total)


@dataclass
class StepRefinement:
    """Makes levels of a problem; unit: numbers of steps are multiples of it, until span [s]; a motion may end sooner.

    graded: whose errors are to be within the tolerance, () for those of all coordinates that tell the motion; of the
    others a run has to be accurate.
    """

    problem: Problem
    tolerance: float
    spacing: float | None = None
    run_options: RunOptions = field(default_factory=RunOptions)
    graded: Sequence[str] = ()

    def __post_init__(self) -> None:
        span = self.problem.t_end - self.problem.t0
        sampled = self.problem.spacing
        if self.spacing is not None and not 0 < self.spacing <= span * (1 + SPAN_ROUNDING):
            raise SchemeError(f"seen_every must be a time within the motion of {span:g} s, not {self.spacing!r}")
        apart = sampled or self.spacing
        if sampled is not None and self.spacing is not None:
            apart = common_time(sampled, self.spacing)
        if apart is not None and span / apart > MOST_LEVEL_STEPS:
            raise SchemeError(
                f"seen_every = {apart:g} s needs more than {MOST_LEVEL_STEPS:.0e} steps; raise it or lower t_end"
            )
        self.unit = FIRST_LEVEL_STEPS if apart is None else ceil(span / apart - SPAN_ROUNDING)
        self.span = self.unit * apart if apart is not None else span

    def plan(self, method: Method, steps: int, known: Plan | None = None) -> Plan:
        """So many steps of the method over the motion; known: a plan of its with other steps."""
        every = ceil(steps / LEVEL_SAMPLES) if self.spacing is None else max(1, round(self.spacing * steps / self.span))
        if steps / every > MAX_SAMPLES:
            raise SchemeError(f"{steps // every:.3g} samples are too many; give a longer time between them")
        if known is not None:
            refuse_alike(known.t0, known.t0 + self.span, self.span / steps)
            finer = known.with_steps(known.scheme.model, self.span / steps, steps)
            return replace(finer, seen_steps=every).until(self.problem.t_end)
        m = None if method.m is None else list(method.m)
        model, t0 = self.problem.model, self.problem.t0
        plan = checked_plan(
            model, t0 + self.span, self.span / steps, m, method.scheme, 0.0, method.options, t0, bounded=True
        )
        plan = replace(plan, seen_steps=every, force=True, refined=True, outputs=tuple(self.run_options.outputs or ()))
        return plan.until(self.problem.t_end)

    def refine(self, method: Method) -> Iterator[RefinementLevel]:
        """Levels from the first to the one that meets the tolerance, or to the last that it is worth to make."""
        least = max(
            (method.first or self.first(method)) / self.unit,
            self._units(frequency_at_start(self.problem.model, self.problem.state)),
        )
        count, levels, spent = refined(0, least), list[RefinementLevel](), 0.0
        compared, common = 0, shared(count)
        plan = None
        while True:
            plan = self.plan(method, count * self.unit, plan)
            level = self.level(plan, levels[-1].run if levels else None, [common, shared(count)])
            order = plan.scheme.order
            if levels and not level.lost and not levels[-1].lost:
                level = self.judged(levels, level, order)
                if plan.scheme.damps and level.error <= self.tolerance:  # levels that have lost a vibration agree
                    try:
                        level = self._with_what_is_damped(level)
                    except KeyboardInterrupt:
                        yield replace(level, estimated=MotionError(reason="stopped by the user while it was measured"))
                        return
            levels.append(level)
            REFINEMENT.debug(
                "%s: %s, %d steps, error %.2g, %s", self.problem.model.name, method.label, level.steps, level.error,
                level.status.name,
            )  # fmt: skip
            yield level
            spent += plan.steps * level.run.segment.stepper.operations
            if len(levels) == 1:
                compared = self._sampling_the_way(level)
            following = self.next_count(levels, order)
            following = following if following is None else max(following, compared)
            if (turned := min(self._turned_by(level), ceil(MOST_FINER * count))) > count:  # it tells nothing yet
                following = max(following or 0, turned)
            following = following if following is None else refined(count, following)
            if (
                following is None
                or spent * following / count > MOST_OPERATIONS_OF_LEVELS
                or following * self.unit > MOST_LEVEL_STEPS
            ):
                return
            count, common = following, shared(count)

    def first(self, method: Method) -> int:
        """Steps of a first level: such as see what loads do, within the stability limit at the start."""
        scheme = self.plan(method, FIRST_LEVEL_STEPS).scheme
        return max(steps_for_loads(self.problem), stable_steps(scheme, slopes_at_start(self.problem), self.span))

    def _sampling_the_way(self, level: RefinementLevel) -> int:
        """Steps, in units, that see what acts on a short part of the way that a level took."""
        shortest = min((one.end - one.start for one in passed_by(level.run, SEES_SHORT)), default=inf)
        return ceil(SEES_SHORT * self.span / shortest / self.unit)

    def _turned_by(self, level: RefinementLevel) -> int:
        """Steps, in units, none of which turns a loop too far to be followed, by what a level has seen."""
        found = [0.0]
        for segment, states in level.run.record.states():
            found.append(frequency_at_states(segment.model, segment.plan.scheme, segment.c, states))
        if level.lost:  # its step from the last good state turned by the acceleration, too
            last = level.run.segment
            state = last.state(level.run.z)[None]
            found.append(frequency_at_states(last.model, last.plan.scheme, last.c, state, by_change=True))
        return self._units(max(found))

    def _units(self, frequency: float) -> int:
        """Steps, in units, of so many in a second."""
        return ceil(self.span * frequency / self.unit)

    def level(self, plan: Plan, like: Run | None = None, common: Sequence[int] = (1,)) -> RefinementLevel:
        """A whole motion, of which one is known with other steps; nobody looks whether steps see what loads do.

        common: of how many units the steps of each motion are a multiple that this one is compared with.
        """
        steps, whole = round(self.span / plan.grid.dt_L), plan.whole_steps  # all, those within the motion
        at = [comparison_steps(whole, max(1, steps // (units * self.unit))) for units in common]
        comparison_times = ComparisonTimes(
            np.unique(np.concatenate(at)), early_steps(whole) if plan.scheme.damps else ()
        )
        run_options = RunOptions(progress=self.run_options.progress)
        run = start_run(self.problem, replace(plan, outputs=()), comparison_times, run_options, quiet=True, like=like)
        began = time.process_time()
        status = run.integrate()
        return RefinementLevel(steps, run, comparison_times, status, time.process_time() - began)

    def _with_what_is_damped(self, level: RefinementLevel) -> RefinementLevel:
        """The level with the error that the damping of its method makes, where that is larger."""
        estimated = with_what_is_damped(level.run, level.comparison_times, level.sampled, level.estimated)
        return replace(level, estimated=estimated, error=max(level.error, self._asked(estimated)))

    def judged(self, before: list[RefinementLevel], level: RefinementLevel, order: int) -> RefinementLevel:
        """The level with its error by the one before it; by extrapolation where three levels show the order."""
        last = before[-1]
        places = gcd(level.steps, last.steps)  # ends of steps of both
        every, others = level.steps // places, last.steps // places
        ours, theirs = (
            one.reached[one.reached % apart == 0] // apart for one, apart in ((level, every), (last, others))
        )
        common = np.intersect1d(ours, theirs)
        if not len(common):
            return level
        model, plan = self.problem.model, level.run.plan
        q, v = level.compared.compress(among(level.reached, common * every), axis=1)
        other_q, other_v = last.compared.compress(among(last.reached, common * others), axis=1)
        sizes = amplitudes(model, np.concatenate([other_q, level.sampled[0]]))
        t = plan.t0 + common * every * plan.grid.dt_L
        estimated = motion_error(model, t, q, other_q, sizes, (v, other_v), level.sampled[1])
        unresolved = unresolved_share(level.run, level.sampled[1])
        error = differs = self._asked(estimated)
        if len(before) > 1 and 0 < differs < last.differs:
            ratio = level.steps / last.steps
            shown = shown_order(last.differs, differs, last.steps / before[-2].steps, ratio, order)
            if shown > SHOWN_ORDER * order:
                richer = max(2.0, ratio**shown - 1)
                error *= min(0.5, RICHARDSON_SAFETY / richer)
                estimated = estimated.scaled(1 / richer)
        # what acts within one step at every level errs alike at all of them
        return replace(level, differs=differs, error=max(error, unresolved), estimated=estimated.at_least(unresolved))

    def _asked(self, error: MotionError) -> float:
        """What is compared with the tolerance; of rates, and of what is not graded, a run has to be accurate."""
        others = max(value for name, value in error.judged.items() if self.graded or name not in error.relative)
        graded = self.graded or error.relative
        return float(
            max(others * self.tolerance / (ACCURATE * INACCURATE_ERROR), *(error.relative[name] for name in graded))
        )

    def next_count(self, levels: list[RefinementLevel], order: int) -> int | None:
        """Steps of the next level, in units; None where the last one is the answer, or nothing would be won."""
        last = levels[-1]
        count = last.steps // self.unit
        if last.lost:
            return None if self.ends(levels, order) else ceil(AFTER_LOST * count)
        if len(levels) >= 3 and last.error <= self.tolerance:
            return None
        if len(levels) >= 3 and last.steps > MOST_CHATTERING and all(chattering_of(one.run) for one in levels[-3:]):
            return None  # its error falls in proportion to its steps at best, each of which is searched for its kink
        if _stagnant(levels):
            dear = self.resolving * self.unit * last.run.segment.stepper.operations > MOST_RESOLVING
            if count < self.resolving and not dear:
                return self.resolving
            if dear or _stagnant([one for one in levels if one.steps >= self.resolving * self.unit]):
                return None
        least = 2 ** (1 / order)
        factor = (
            MOST_GROWTH
            if not np.isfinite(last.error)
            else (last.error / (TOLERANCE_SAFETY * self.tolerance)) ** (1 / order)
        )
        return ceil(count * min(max(factor, least), MOST_GROWTH))

    def ends(self, levels: list[RefinementLevel], order: int) -> bool:
        """Does the motion end where the last level stops, or is it not worth while to find out?

        It does where three levels that resolve it stop for the same reason at times that converge as the method
        does, or as near to each other as their steps tell. Coarse levels may fail near each other by chance.
        """
        last = levels[-3:]
        spent = sum(one.run.step * one.run.segment.stepper.operations for one in levels if one.lost)
        if spent > MOST_ENDING:
            return True
        if last[-1].status.name == "iteration_failed":  # which no motion does, but its steps
            return False
        if len(last) < 3 or not all(one.lost and one.status.name == last[-1].status.name for one in last):
            return False
        steps, times = [one.steps for one in last], [one.status.time for one in last]
        operations = last[-1].run.segment.stepper.operations
        coarse = steps[-1] < self.resolving * self.unit and self.resolving * self.unit * operations <= MOST_RESOLVING
        if coarse or (times[-1] - self.problem.t0) / self.span * steps[0] < BEFORE_END:
            return False
        apart = np.abs(np.diff(times))
        if (apart <= END_KNOWN * self.span / np.array(steps[:-1])).all():
            return True
        shown = shown_order(apart[0], apart[1], steps[1] / steps[0], steps[2] / steps[1], order)
        return shown >= SHOWN_ORDER * order

    @cached_property
    def resolving(self) -> int:
        """Steps, in units, that resolve the fastest mode at the start, 0 where it is not known.

        Levels that leave it out agree no better with each other than by what it moves.
        """
        fastest = fastest_mode(self.problem)
        return 0 if fastest is None else ceil(self.span * fastest / RESOLVED_ANGLE / self.unit)

    def solution(self, levels: list[RefinementLevel], total: float) -> Solution:
        """What the last whole level is, with its error, and how the refinement ended."""
        whole = [one for one in levels if not one.lost]
        run_options, interrupted = self.run_options, levels[-1].status.name == "interrupted"
        chance = levels[-1].lost and not interrupted and not (whole and whole[-1].estimated.measured)
        if not whole or chance:  # a motion that coarse steps alone bring to its end is none
            return finished(levels[-1].run, levels[-1].estimated, loads_missed(levels[-1].run))
        answer = whole[-1]
        error = _doubted(answer, levels)
        run, passed = answer.run, list[Event]()
        again = run_options.bounded or (run_options.checkpoint is not None and not interrupted)
        if again:  # to keep what it makes
            plan = replace(run.record.segments[0].plan, outputs=tuple(run_options.outputs or ()))
            run = start_run(self.problem, plan, comparison_times_of(self.problem, plan), run_options)
        else:
            passed = loads_missed(run)
        found = finished(run, error, passed)
        stats: dict[str, float | int | str] = dict(found.stats) | {
            "tolerance": self.tolerance,
            "rungs": len(levels),
            "steps_of_all_rungs": total,
            "seconds_of_all_rungs": sum(one.run.seconds for one in levels),
        }
        status = found.status
        if interrupted:
            status = replace(levels[-1].status, time=found.status.time, cause="stopped by the user on a finer level")
        elif status.name == "completed" and error.measured and not answer.error <= self.tolerance:
            missed = (
                f"the error is {answer.error:.2g} of an amplitude, where {self.tolerance:g} was asked: "
                "more steps do not bring it down"
            )
            chatter = [event.text for event in found.events if event.kind == "chattering"][:1]
            stats["remark"] = "; ".join([missed, *chatter])
        return found.but(stats=stats, status=status)


def shown_order(earlier: float, later: float, first: float, second: float, most: float) -> float:
    """The order p that three motions show, each by so many times the steps of the one before (`first`, `second`),
    that differ by `earlier` and by `later`; at most `most`, and 0 where they show none.

    Their errors are as 1, first^-p and (first second)^-p, so that

        (first^p - 1) / (1 - second^-p) = earlier / later,

    whose left side grows with p.
    """
    if not later > 0:
        return most if earlier > 0 else 0.0

    def above(p: float) -> bool:
        return bool((first**p - 1) * later > earlier * (1 - second**-p))

    low, high = 0.0, float(most)
    if not above(high):
        return high
    for _ in range(ORDER_BISECTIONS):
        middle = (low + high) / 2
        low, high = (low, middle) if above(middle) else (middle, high)
    return low


def _stagnant(levels: list[RefinementLevel]) -> bool:
    """Do levels, of which there are enough, come no nearer to each other?"""
    if not levels:
        return False
    last, before = levels[-1], np.nanmin([inf, *(one.differs for one in levels[-6:-3])])
    enough = len(levels) >= (
        LEVELS_TO_STAGNATE
        if max([last.differs, *last.estimated.judged.values()]) < INACCURATE_ERROR
        else UNRESOLVED_LEVELS_TO_STAGNATE
    )
    return enough and not bool(last.differs < STAGNANT_DIFFERENCE * before)


def _doubted(answer: RefinementLevel, levels: list[RefinementLevel]) -> MotionError:
    """The error of the answer; where no two levels came to the end, why it is not to be relied on."""
    lost = [one for one in levels if one.lost and one.status.name != "interrupted"]
    if answer.estimated.measured or not lost:
        return replace(answer.estimated)
    first = min((one.status for one in lost), key=lambda status: status.time)
    return MotionError(
        reliable_until=first.time, reason=f"with other steps the motion ends as {first.name} at t = {first.time:.4g} s"
    )


def usual_steps(model: EmittedModel, t0: float, t_end: float | None) -> tuple[str, float]:
    """(scheme, step [s]) with which the motion of a model as its scene has it meets the tolerance of `auto`; kept.

    For what is made in steps of one length many times: ensembles, derivatives, steppers. Raises SchemeError where no
    level comes to its end.
    """

    def found() -> tuple[str, float]:
        problem = Problem.of(model, t_end, t0=t0)
        refinement = StepRefinement(problem, DEFAULT)
        whole = [level for level in refinement.refine(chosen_method(problem)[0]) if not level.lost]
        if not whole:
            reason = f"model {model.name} names none, and `auto` finds none whose motion comes to its end"
            raise SchemeError("scheme", reason, 'name one with its step, such as scheme="rk4", dt=1e-3')
        plan = whole[-1].run.record.segments[0].plan
        return plan.name, plan.grid.dt_L

    return model.derived(f"usual_steps {t0} {t_end}", found)
