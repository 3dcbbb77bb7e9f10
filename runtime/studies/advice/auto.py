"""scheme = "auto": a tolerance instead of a step, by the method that the stiffness of the motion asks for.

Trials of the whole motion tell the steps that a method needs (runtime/running/trials.py). The explicit pair is first.
Stiffness is seen where its steps come near its stability limit, mostly in its first, coarse trial; then the exponential
methods are tried before it goes on, and the one that needs the fewest operations makes the run. Of the methods that
come later no more is tried than would be worth it: RIVAL times the operations of the best run so far.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
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
from runtime.running.inputs import bound
from runtime.running.simulate import simulate as run
from runtime.running.tolerance import tolerance_of, whole_span
from runtime.running.trials import Trials
from runtime.running.tried_motion import SEEN, TrialRuns
from runtime.schemes.adaptive.dormand_prince import DormandPrince5
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.kept_steppers import kept_stepper
from runtime.schemes.options import LARGE_SYSTEM, SchemeError
from runtime.schemes.step_limit import limit_between_the_axes
from runtime.schemes.switching.times import SwitchTime, switching_times
from runtime.start.start_state import start_state
from runtime.studies.work_precision.dense_methods import affordable

AUTO = "auto"
TOLERANCE = 1e-3
EXPLICIT = "dopri5"
NEAR = 0.3  # of the stability limit of the explicit pair
RIVAL, LITTLE = 8.0, 1e7  # times the operations of the best run known, or so many: trials of another take no more
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
    t0, p = settings.get("t0", 0.0), model.parameter_vector(settings.get("parameters"))
    c = model.constants(p)
    state = start_state(model, p, c, t0, settings.get("initial"), settings.get("start"))
    span = whole_span(model, settings.get("t_end"), t0)
    motion = _Motion(model, tolerance, c, state, t0, span, switching_times(model, c, t0, t0 + span))
    explicit = motion.trials(EXPLICIT)
    found: dict[str, _Tried] = {}
    if not motion.seems_stiff(explicit):
        found = {EXPLICIT: motion.tried(explicit, {})}
        known = found[EXPLICIT].known
        if known and not motion.stiff(known.longest):
            return AutomaticChoice(EXPLICIT, f"{EXPLICIT} to {tolerance:g}: the motion is not stiff", known)
    for name in exponentials(model):
        found[name] = motion.tried(motion.trials(name), found)
    if EXPLICIT not in found:
        found[EXPLICIT] = motion.tried(explicit, found)
    best, *others = sorted(found, key=lambda name: found[name].price)
    if found[best].known is None:
        best, *others = sorted(found, key=lambda name: (found[name].expected, name == EXPLICIT))
        reason = f"{best} to {tolerance:g} a step: trials of the whole motion would take too long, or come to no end"
        return AutomaticChoice(best, reason, None)
    seen = " and ".join(f"{name} takes {_times(found[name].price / found[best].price)}" for name in others)
    seen = seen or "there is no other method"
    return AutomaticChoice(best, f"{best} to {tolerance:g}: the motion is stiff, and {seen}", found[best].known)


def exponentials(model: Model) -> list[str]:
    """Methods for stiff motion that the model can be stepped with, and that are not dear by its size."""
    found = ["exponential_rk4"] if model.has("deflections") else []
    small = model.has("residual_jacobian") and (len(model.q_i) <= LARGE_SYSTEM if found else affordable(model))
    return [*found, "exponential"] if small else found


def _times(ratio: float) -> str:
    return f"{ratio:.3g} times the operations" if np.isfinite(ratio) else "more operations than were tried"


@dataclass(frozen=True)
class _Tried:
    """known: what trials of a method told, if they did; expected: operations of the coarsest."""

    known: Calibration | None
    expected: float

    @property
    def price(self) -> float:
        """Operations of the run, infinite where they are not known."""
        return np.inf if self.known is None else self.known.operations


@dataclass(frozen=True)
class _Motion:
    """A motion of `span` [s] from a state at t0, with constants c (c_size,) and times that no step crosses."""

    model: Model
    tolerance: float
    c: np.ndarray
    state: ConsistentState
    t0: float
    span: float
    switches: list[SwitchTime]

    def trials(self, name: str) -> Trials:
        """Of a method."""
        h = self.span / SEEN
        scheme = scheme_kind(name).build(name, self.model, h, None, {"tolerance": self.tolerance})
        stepper = kept_stepper(scheme)
        z = stepper.start(self.t0, self.state.q, self.state.q_dot, self.c, h)
        return Trials(TrialRuns(stepper, z, self.c, self.span, self.switches))

    def tried(self, trials: Trials, rivals: Mapping[str, _Tried]) -> _Tried:
        """What trials tell, where it may be worth more than what others were found to need."""
        best = min((one.price for one in rivals.values()), default=np.inf)
        trials.runs.budget = min(trials.runs.budget, max(RIVAL * best, LITTLE))
        return _Tried(trials.calibration(self.tolerance), trials.expected)

    def seems_stiff(self, trials: Trials) -> bool:
        """Would steps of the explicit pair be near its stability limit, as far as its first trial tells?"""
        first = trials.begin(self.tolerance)
        if first is None:
            return True
        return self.stiff(first.longest * (self.tolerance / first.tolerance) ** (1 / trials.runs.scheme.error_order))

    def stiff(self, h: float) -> bool:
        """Is a step near what a vibration or a decay at the start allows? Yes where that is not known."""
        if not ModeSolver.possible(self.model):
            return True
        at = independent(self.model, self.state.q, self.state.q_dot)
        try:
            state = State(self.t0, *at, loop_part(self.model, self.state.q))
            slopes = ModeSolver(self.model, self.c).slopes(state)
            limit = limit_between_the_axes(*slopes, DormandPrince5.reach, DormandPrince5.decay_reach)
        except np.linalg.LinAlgError:
            return True
        near = NEAR_OF_ELASTIC if self.model.has("deflections") else NEAR
        return limit is not None and not h < near * limit.h
