"""scheme = "auto": a tolerance instead of a step, by the method that the stiffness of the motion asks for.

Trials of the whole motion tell the steps that a method needs (runtime/running/trials.py). The explicit pair is first.
Stiffness is seen where its steps come near its stability limit, mostly in its first, coarse trial; then the exponential
methods are tried before it goes on, and the one that needs the fewest operations makes the run. Of the methods that
come later no more is tried than would be worth it: they have to take clearly fewer than the best one so far
(runtime/running/rival_trials.py).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Unpack

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import independent, loop_part
from runtime.contract.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.results.meter import Meter
from runtime.results.solution import Solution
from runtime.running.arguments import RunArguments
from runtime.running.calibration import Calibration
from runtime.running.inputs import bound, scheduled, started
from runtime.running.load_steps import steps_that_see_loads
from runtime.running.plan import Plan, make_plan
from runtime.running.simulate import simulate as run
from runtime.running.time_functions import all_stops
from runtime.running.tolerance import tolerance_of, with_tolerance
from runtime.running.trials import Trials
from runtime.running.tried_motion import RANGING, TrialRuns, TriedMotion
from runtime.running.varied_trials import COARSER
from runtime.schemes.baselines.dormand_prince import DormandPrince5
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.kept_steppers import kept_stepper
from runtime.schemes.options import LARGE_SYSTEM, SchemeError
from runtime.schemes.step_limit import limit_between_the_axes
from runtime.schemes.switching.times import SwitchTime
from runtime.start.start_state import start_state
from runtime.studies.work_precision.dense_methods import affordable

AUTO = "auto"
TOLERANCE = 1e-3
EXPLICIT, UNVARIED = "dopri5", "exponential_adams"  # the second with steps of one length only
NEAR = 0.3  # of the stability limit of the explicit pair
NEAR_OF_ELASTIC = 0.1  # of it where the model has stiff deflections: methods that follow them may take longer steps


def simulate(model: Model, *, scheme: str | None = None, **settings: Unpack[RunArguments]) -> Solution:
    """Simulate a model from t0 until t_end (None: the scene's own settings).

    scheme: a name of runtime.SCHEMES, or `auto`: steps as long as `tolerance` (1e-3) allows, by the method that the
    stiffness of the motion asks for; that is also meant where a tolerance is given and no scheme. settings: see
    runtime.running.simulate.simulate, which does the run: t_end, dt [s], m, tolerance, parameters, initial, inputs,
    save_every, engine, options, t0, progress, force, start, outputs, stream, checkpoint, checkpoint_every.
    progress = True shows how far the run is, on a terminal or in a notebook.

    Numerical failure does not raise: see Solution.status. Raises SchemeError, ModelError, InitialStateError,
    OutputError or CompilerError for arguments that cannot be used.
    """
    if settings.get("progress") is True:
        with Meter(model.name) as meter:
            settings["progress"] = meter
            return simulate(model, scheme=scheme, **settings)
    tolerance = settings.get("tolerance")
    wanted = scheme or (AUTO if tolerance is not None else model.simulation.get("scheme"))
    if wanted != AUTO or not model.q_i:
        return run(model, scheme=scheme, **settings)
    if settings.get("m") is not None or settings.get("options"):
        raise SchemeError("auto chooses m and options itself; leave them out, or name a scheme")
    if tolerance is None:
        tolerance = float(model.simulation.get("tolerance") or TOLERANCE)
    tolerance = tolerance_of(model, EXPLICIT, tolerance)
    assert tolerance is not None
    chosen = choose(bound(model, settings.get("inputs")), tolerance, settings)
    settings["tolerance"] = tolerance
    if chosen.known is None:
        settings["options"] = {"error_of": "step"}
    return run(model, scheme=chosen.scheme, calibration=chosen.known, advice=chosen.reason, **settings)


@dataclass(frozen=True)
class AutomaticChoice:
    """The scheme, the reason in plain words, and what trials told (None: nothing)."""

    scheme: str
    reason: str
    known: Calibration | None = None


def choose(model: Model, tolerance: float, settings: RunArguments) -> AutomaticChoice:
    """What to step with. settings: of the run. Raises what `simulate` raises."""
    motion = _Motion.of(model, tolerance, settings)
    explicit = motion.trials(EXPLICIT)
    near = motion.near
    tried, best, prices = [explicit], None, {}
    coarse = (max(RANGING, COARSER * tolerance) / tolerance) ** (1 / explicit.runs.scheme.error_order)
    if explicit.begin(tolerance, longest=coarse * near) is not None:
        known = explicit.calibration(tolerance)
        if known and known.longest < near:
            return AutomaticChoice(EXPLICIT, f"{EXPLICIT} to {tolerance:g}: the motion is not stiff", known)
        best = _Best.of(EXPLICIT, known, explicit)
        prices[EXPLICIT] = np.inf if known is None else known.operations
    names = [name for name in exponentials(model) if motion.may_be_tried or name != UNVARIED]
    for name in [*names, *([] if EXPLICIT in prices else [EXPLICIT])]:
        trials = explicit if name == EXPLICIT else motion.trials(name)
        tried += [] if name == EXPLICIT else [trials]
        if best is None:
            known = trials.calibration(tolerance)
            prices[name] = np.inf if known is None else known.operations
        elif name == EXPLICIT and motion.least_price(trials) > best.known.operations:
            known, prices[name] = None, motion.least_price(trials)
        else:
            known, prices[name] = trials.beside(tolerance, best.known, best.finest)
        if name == UNVARIED and trials.runs.alarmed:  # its run may have to vary steps
            known = None
        best = _Best.of(name, known, trials, best)
    if best is None:
        return motion.by_steps(dict(zip([EXPLICIT, *names], tried, strict=True)))
    price = best.known.operations
    seen = " and ".join(f"{name} takes {_times(prices[name] / price)}" for name in prices if name != best.name)
    seen = seen or "there is no other method"
    spent = sum(trials.runs.spent for trials in tried) - (price if best.known.states is not None else 0.0)
    known = replace(best.known, tried=spent, trials=sum(trials.runs.tries for trials in tried))
    return AutomaticChoice(best.name, f"{best.name} to {tolerance:g}: the motion is stiff, and {seen}", known)


def exponentials(model: Model) -> list[str]:
    """Methods for stiff motion that the model can be stepped with, and that are not dear by its size."""
    found = ["exponential_rk4"] if model.has("deflections") else []
    if found and not model.description.orientations and not model.has("shifted_solution"):
        found.append(UNVARIED)  # it has one matrix of the deflections, and no charts to a tolerance
    small = model.has("residual_jacobian") and (len(model.q_i) <= LARGE_SYSTEM if found else affordable(model))
    return [*found, "exponential"] if small else found


def _times(ratio: float) -> str:
    """In words; a method that takes a little less, as far as a short trial tells, is not worth more trials."""
    if ratio < 1:
        return "about as many operations"
    return f"{ratio:.3g} times the operations" if np.isfinite(ratio) else "more operations than were tried"


@dataclass(frozen=True)
class _Best:
    """The method that takes the fewest operations so far; finest: a trial with steps of one length, and its error."""

    name: str
    known: Calibration
    finest: tuple[TriedMotion, float]

    @staticmethod
    def of(name: str, known: Calibration | None, trials: Trials, before: _Best | None = None) -> _Best | None:
        """With what trials have told, if they did; else what it was before."""
        if known is None:
            return before
        finest = trials.finest or (None if before is None else before.finest)
        assert finest is not None
        return _Best(name, known, finest)


@dataclass(frozen=True)
class _Motion:
    """A motion from a state, with constants c (c_size,) and times that no step crosses; plan: of the explicit pair;
    least: steps that see what loads do. may_be_tried: will the run be as its trials?
    """

    tolerance: float
    c: np.ndarray
    state: ConsistentState
    plan: Plan
    engine: str
    least: int
    may_be_tried: bool
    switches: list[SwitchTime]

    @classmethod
    def of(cls, model: Model, tolerance: float, settings: RunArguments) -> _Motion:
        """That of a run. Raises what `simulate` raises."""
        t0, times = settings.get("t0", 0.0), (settings.get("t_end"), settings.get("dt"))
        options, dt, every = with_tolerance(model, EXPLICIT, tolerance, None, *times, settings.get("save_every"), t0)
        plan = make_plan(model, times[0], dt, None, EXPLICIT, every, options, t0, bounded=True)
        inputs = settings.get("inputs")
        schedule = scheduled(model, inputs, t0, plan.grid.dt_L)
        p = started(model, model.parameter_vector(settings.get("parameters")), schedule, t0)
        tried = not (schedule.samples or schedule.controllers or model.description.events)
        c = model.constants(p)
        state = start_state(model, p, c, t0, settings.get("initial"), settings.get("start"))
        switches = all_stops(model, c, t0, plan.t_end, state)
        least = steps_that_see_loads(model, c, state, t0, plan.t_end, switches)
        return cls(tolerance, c, state, plan, settings.get("engine", "auto"), least, tried, switches)

    def trials(self, name: str) -> Trials:
        """Of a method, with the program of its run."""
        plan = self.plan
        scheme = scheme_kind(name).build(name, plan.scheme.model, plan.grid.dt_L, None, plan.options)
        stepper = kept_stepper(scheme, self.engine)
        z = stepper.start(plan.t0, self.state.q, self.state.q_dot, self.c, plan.grid.dt_L)
        span = plan.t_end - plan.t0
        return Trials(TrialRuns(stepper, z, self.c, span, self.switches, shown=plan.steps, least=self.least))

    def by_steps(self, tried: Mapping[str, Trials]) -> AutomaticChoice:
        """Where trials told nothing: the method that would take the fewest operations with coarse steps.

        Where they came near a singular position, its run makes others that pass it.
        """
        alarmed = any(trials.runs.alarmed for trials in tried.values())
        for name, trials in tried.items():
            if name != UNVARIED:
                trials.begin(self.tolerance)
        able = [name for name in tried if name != UNVARIED]
        best = min(able, key=lambda name: (tried[name].expected, name == EXPLICIT))
        reason = (
            f"{best} to {self.tolerance:g} a step: trials of the whole motion would take too long, or come to no end"
        )
        if alarmed:
            reason = f"{best} to {self.tolerance:g}: the motion comes near singular positions"
        return AutomaticChoice(best, reason, Calibration.of_none() if alarmed else None)

    def least_price(self, trials: Trials) -> float:
        """Operations of the explicit pair with the longest steps that are stable at the start."""
        steps = (self.plan.t_end - self.plan.t0) / self._limit if self._limit else 0.0
        return steps * trials.runs.scheme.operations_of_plain(trials.runs.stepper.program)

    @property
    def near(self) -> float:
        """Steps of the explicit pair from which on a motion counts as stiff [s]: near what a vibration or a decay at
        the start allows; 0 where that is not known.
        """
        return (NEAR_OF_ELASTIC if self.plan.scheme.model.has("deflections") else NEAR) * self._limit

    @cached_property
    def _limit(self) -> float:
        """The longest step of the explicit pair that is stable at the start [s]; 0 where that is not known."""
        model = self.plan.scheme.model
        if not ModeSolver.possible(model):
            return 0.0
        at = independent(model, self.state.q, self.state.q_dot)
        try:
            state = State(self.plan.t0, *at, loop_part(model, self.state.q))
            slopes = ModeSolver(model, self.c).slopes(state)
            limit = limit_between_the_axes(*slopes, DormandPrince5.reach, DormandPrince5.decay_reach)
        except np.linalg.LinAlgError:
            return 0.0
        return np.inf if limit is None else limit.h
