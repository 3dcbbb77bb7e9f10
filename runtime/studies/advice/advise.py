"""Choose a method and its steps for a model by trying the candidates on its own motion.

Frequencies say which steps are stable; how large an error a step makes, and what it costs, is measured: every candidate
runs (a part of) the motion with ever more steps until it meets the tolerance, against a path that is finer still.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from html import escape

import numpy as np

from runtime.contract.coordinates import followed, independent, loop_part, told_state
from runtime.contract.errors import NoResult
from runtime.contract.model import Model
from runtime.contract.status import card, line, table
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.ladder import chosen_method
from runtime.running.problem import Problem as MotionProblem
from runtime.schemes.catalogue import SCHEMES
from runtime.schemes.options import LARGEST_TOLERANCE, SchemeError
from runtime.studies.advice.frequencies import Groups, ModeRange, mode_ranges, propose_groups
from runtime.studies.stability.limits import StabilityStudy
from runtime.studies.work_precision.dense_methods import ONE_OF_EACH, dense_methods
from runtime.studies.work_precision.prepared_method import PreparedMethod, Spec, Trial
from runtime.studies.work_precision.problem import Problem, Setting, make_setting
from runtime.studies.work_precision.search import Search, search_steps
from runtime.studies.work_precision.stiff_methods import stiff_methods

PILOT_SECONDS = 2.0
STATES = 12
MARGIN = 0.9  # of a stability limit
STUDIED = 20  # independent coordinates up to which a step's stability is computed; beyond, the trial has to do
LONG_JACOBIANS = 40_000  # operations: each further method with them takes the compiler a minute
FEW_STEPS = 20  # in the motion tried: what grows over so few steps is in their error already
SAFETY = 0.85  # of the tolerance, so that a slightly different motion meets it too
Note = Callable[[str], None]


@dataclass(frozen=True)
class Advice:
    """What to use, and why.

    spec, dt [s] and trial describe the advised method and its trial; limit is its largest stable step (None: no
    limit); automatic: the scheme that `auto` would take, and why (None: the tolerance is too loose for it);
    searches hold all trials of all candidates, ascending in time; gain is how many times faster it is than the best
    method with one step for all coordinates; tried [s] is the length of the motion tried.
    """

    model: Model
    tolerance: float
    graded: list[str]
    tried: float
    t_end: float
    modes: list[ModeRange]
    groups: Groups | None
    searches: list[Search]
    spec: Spec
    dt: float
    trial: Trial
    limit: float | None
    gain: float
    reason: str
    automatic: tuple[str, str] | None

    @property
    def seconds(self) -> float:
        """Expected CPU time of the whole motion [s]."""
        return self.trial.seconds * self.t_end / self.tried

    def _repr_html_(self) -> str:
        rows = [
            (one.label, f"{one.best.setting:.4g} s", f"{one.best.seconds * 1e3:.4g} ms", f"{one.best.error:.2g}")
            if one.best
            else (one.label, "not reached in useful time")
            for one in self.searches
        ]
        about = f"an error of {self.tolerance:g} in {', '.join(self.graded)}, tried on {self.tried:g} s"
        wanted = f"{self.spec.label}, dt = {self.dt:.6g} s"
        return card(wanted, about, line(escape(self.reason)), table(rows, ("method", "step", "time", "error")))


class NoAdvice(NoResult):
    """No method met the tolerance; the message says what was tried."""


def candidates(model: Model) -> list[Spec]:
    """Methods worth trying, the likeliest first."""
    found = stiff_methods(model)
    dense = [
        Spec("exponential", (1,)),
        Spec("exponential", (2,)),
        Spec("exponential", (1,), {"order": 5}),
        Spec("exponential", (2,), {"order": 5}),
        Spec("linearised", (2,)),
        Spec("linearised", (2,), {"corrections": 1}),
        Spec("radau", None, {"eps": (1e-6,)}),
    ]
    if model.operations.get("residual_jacobian", 0) >= LONG_JACOBIANS:
        dense = list(ONE_OF_EACH)
    found += dense_methods(model, dense)
    found += [Spec("single_rate", None, {"common_velocity": "predictor"}), Spec("rk4"), Spec("dop853")]
    if len(model.groups) > 1:
        inner = (1,) * (len(model.groups) - 2)
        found += [Spec("coupled", (*inner, ratio)) for ratio in (2, 5, 10)]
        if len(model.groups) == 2:
            found += [Spec("decoupled", (ratio,)) for ratio in (2, 5, 10)]
    return found


def advise(
    model: Model,
    *,
    tolerance: float = 1e-3,
    graded: list[str] | None = None,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    note: Note = lambda text: None,
) -> Advice:
    """Advice for a motion of t_end [s].

    tolerance: on the RMS error over the motion of every graded coordinate, relative to its amplitude. graded: names
    in q_i (all by default). note is told what is being done. Raises SchemeError, ModelError, InitialStateError,
    NoReference or NoAdvice.
    """
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance < 1:
        raise SchemeError(f"the tolerance must be between 0 and 1, not {tolerance!r}")
    setting = make_setting(model, t_end=t_end, parameters=parameters, initial=initial, start=start, graded=graded)
    note("finding a reference path")
    problem, allowed = setting.quick(tolerance, PILOT_SECONDS)
    searches = _searched(problem, SAFETY * allowed, note)
    done = sorted((one for one in searches if one.best), key=lambda one: one.seconds)
    if not done:
        raise NoAdvice(
            f"none of {', '.join(one.label for one in searches)} reached {tolerance:g} on {model.name}; "
            "loosen the tolerance or grade fewer coordinates"
        )
    solver = ModeSolver(model, setting.c) if model.has("residual_jacobian") else None
    states = _states(problem) if solver else []
    note("computing frequencies and stability")
    best, limit = _within_limit(problem, done, states)
    return _advice(setting, problem, tolerance, searches, best, limit, solver, states)


def _searched(problem: Problem, tolerance: float, note: Note) -> list[Search]:
    searches: list[Search] = []
    fastest = np.inf
    for spec in candidates(problem.model):
        note(f"trying {spec.label}")
        prepared = PreparedMethod(spec, problem)
        searches.append(search_steps(prepared, tolerance, seconds_to_beat=fastest))
        fastest = min(fastest, searches[-1].seconds)
    return searches


def _states(problem: Problem) -> list[State]:
    """States along the reference path, rates by differences."""
    times = (np.arange(STATES) + 0.5 * np.sin(np.arange(STATES)) ** 2) / STATES * problem.t_end
    step = 1e-4 * problem.t_end / STATES
    now, ahead = (told_state(problem.model, problem.path(at)) for at in (times, times + step))
    loop = loop_part(problem.model, problem.state.q)
    q_i, v = independent(problem.model, now, (ahead - now) / step)
    return [State(float(t), q, rate, loop) for t, q, rate in zip(times, q_i, v, strict=True)]


def _within_limit(problem: Problem, done: list[Search], states: list[State]) -> tuple[Search, float | None]:
    """The fastest search whose step keeps the margin to its stability limit, and that limit."""
    for one in done:
        assert one.best is not None
        spec = one.spec
        kind = SCHEMES[spec.scheme]
        scheme = kind.build(spec.scheme, problem.model, 1.0, list(spec.m) if spec.m else None, spec.options)
        limited = scheme.limited(scheme.options)
        if not limited or not states or len(problem.model.q_i) > STUDIED:
            return one, None
        if problem.t_end < FEW_STEPS * one.best.setting:
            return one, None
        study = StabilityStudy(
            problem.model, spec.scheme, list(spec.m) if spec.m else None, spec.options, problem.c, states, problem.t_end
        )
        curve = study.curve(np.geomspace(one.best.setting / 4, 4 * one.best.setting, 9))
        if curve.limit is None:
            continue
        if not curve.beyond and one.best.setting > MARGIN * curve.limit:
            prepared = PreparedMethod(spec, problem)
            one.best = prepared.run(int(np.ceil(problem.t_end / (MARGIN * curve.limit))))
        return one, None if curve.beyond else curve.limit
    return done[0], None


def _advice(
    setting: Setting,
    problem: Problem,
    tolerance: float,
    searches: list[Search],
    best: Search,
    limit: float | None,
    solver: ModeSolver | None,
    states: list[State],
) -> Advice:
    model, trial = setting.model, best.best
    assert trial is not None
    single = min((one.seconds for one in searches if not SCHEMES[one.spec.scheme].multirate), default=np.inf)
    gain = single / best.seconds
    spec = best.spec
    return Advice(
        model,
        tolerance,
        [followed(model)[0][k] for k in setting.graded],
        problem.t_end,
        setting.t_end,
        mode_ranges(model, solver, states) if solver else [],
        propose_groups(model, solver, states) if solver else None,
        sorted(searches, key=lambda one: one.seconds),
        spec,
        trial.setting,
        trial,
        limit,
        gain,
        _reason(spec, trial, limit, gain, best.seconds <= min(one.seconds for one in searches)),
        _automatic(setting) if tolerance <= LARGEST_TOLERANCE else None,
    )


def _automatic(setting: Setting) -> tuple[str, str]:
    """(scheme, reason) of `auto` for the motion of the setting."""
    method, reason = chosen_method(MotionProblem(setting.model, setting.p, setting.state, 0.0, setting.t_end, {}))
    return method.scheme, reason


def _reason(spec: Spec, trial: Trial, limit: float | None, gain: float, fastest: bool) -> str:
    step = f"step {trial.setting:.3g} s, error {trial.error:.2g}"
    bound = f"; stable up to {limit:.3g} s" if limit else "; no stability limit near that step"
    if not SCHEMES[spec.scheme].multirate:
        which = "the fastest here" if fastest else "the fastest here that is stable at its step"
        return f"use one step for all coordinates: {spec.label} is {which} ({step}{bound})"
    if not np.isfinite(gain):
        return f"{spec.label}: {step}{bound}; no method with one step for all coordinates got there in useful time"
    faster = f"{gain:.2g} times as fast" if abs(gain - 1.0) >= 0.05 else "as fast"
    return f"{spec.label} is {faster} as the best method with one step for all coordinates ({step}{bound})"
