"""scheme = "auto": a tolerance instead of a step, by the method that the stiffness of the motion asks for.

The explicit pair begins the motion. Stiffness is seen where its steps come near its stability limit; then the
exponential methods begin it too, and the one that needs the fewest operations for a piece of it makes the run.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import independent
from runtime.contract.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.results.meter import Meter
from runtime.results.solution import Solution
from runtime.running.arguments import RunArguments
from runtime.running.inputs import bound
from runtime.running.simulate import simulate as run
from runtime.running.tolerance import tolerance_of, whole_span
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.dormand_prince import DormandPrince5
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import LARGE_SYSTEM, SchemeError
from runtime.schemes.step_limit import limit_between_the_axes
from runtime.schemes.stepper import Stepper
from runtime.start.start_state import start_state

AUTO = "auto"
TOLERANCE = 1e-3
EXPLICIT = "dopri5"
SETTLED, TRIED = 0.01, 0.03  # of the motion: until the steps have found their length, and until they are compared
NEAR = 0.3  # of the stability limit of the explicit pair


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
    solution = run(model, scheme=chosen.scheme, **settings)
    solution.stats["advice"] = chosen.reason
    return solution


@dataclass(frozen=True)
class AutomaticChoice:
    """The scheme, and the reason in plain words."""

    scheme: str
    reason: str


def choose(model: Model, tolerance: float, settings: RunArguments) -> AutomaticChoice:
    """What to step with. settings: of the run. Raises what `simulate` raises."""
    t0, p = settings.get("t0", 0.0), model.parameter_vector(settings.get("parameters"))
    state = start_state(model, p, model.constants(p), t0, settings.get("initial"), settings.get("start"))
    piece = _Piece(model, tolerance, model.constants(p), state, t0, whole_span(model, settings.get("t_end"), t0))
    explicit = piece.tried(EXPLICIT)
    if not explicit.stiff:
        return AutomaticChoice(EXPLICIT, f"{EXPLICIT} to {tolerance:g}: the motion is not stiff")
    price = {EXPLICIT: explicit.operations, **{name: piece.tried(name).operations for name in exponentials(model)}}
    best, *others = sorted(price, key=lambda name: price[name])
    if not np.isfinite(price[best]):
        best = next(iter(exponentials(model)), EXPLICIT)
        return AutomaticChoice(best, f"{best} to {tolerance:g}: no method came through the piece that was tried")
    seen = " and ".join(f"{name} takes {_times(price[name] / price[best])}" for name in others)
    seen = seen or "there is no other method"
    return AutomaticChoice(best, f"{best} to {tolerance:g}: the motion is stiff, and {seen}")


def exponentials(model: Model) -> list[str]:
    """Methods for stiff motion that the model can be stepped with, and that are not dear by its size."""
    found = ["exponential_rk4"] if model.has("deflections") else []
    small = model.has("residual_jacobian") and len(model.q_i) <= LARGE_SYSTEM
    return [*found, "exponential"] if small else found


def _times(ratio: float) -> str:
    return f"{ratio:.3g} times the operations" if np.isfinite(ratio) else "more operations than were tried"


@dataclass(frozen=True)
class _Trial:
    """operations from SETTLED to TRIED of the motion, infinite where the end was not reached; stiff: are steps near
    the stability limit of an explicit method?
    """

    operations: float
    stiff: bool


@dataclass(frozen=True)
class _Piece:
    """The beginning of a motion of `span` [s] from a state at t0, with constants c (c_size,)."""

    model: Model
    tolerance: float
    c: np.ndarray
    state: ConsistentState
    t0: float
    span: float

    def tried(self, name: str) -> _Trial:
        """By a method."""
        h = SETTLED * self.span
        scheme = scheme_kind(name).build(name, self.model, h, None, {"tolerance": self.tolerance})
        assert isinstance(scheme, AdaptiveSteps)
        stepper, count = Stepper(scheme), round(TRIED / SETTLED)
        z, ready = stepper.start(self.t0, self.state.q, self.state.q_dot, self.c, h), stepper.ready(self.c, h)
        stepper.run(z, ready, 1)
        before = scheme.operations_taken(z, stepper.program)
        stepper.run(z, ready, count - 1)
        arrived = int(z[1]) == count and bool(np.isfinite(z).all())
        operations = scheme.operations_taken(z, stepper.program) - before if arrived else np.inf
        return _Trial(operations, self._stiff(float(z[scheme.layout.slice("h_largest")][0])))

    def _stiff(self, h: float) -> bool:
        """Is the longest step near what a vibration or a decay at the start allows? Yes where that is not known."""
        if not ModeSolver.possible(self.model):
            return True
        at = independent(self.model, self.state.q, self.state.q_dot)
        try:
            state = State(self.t0, *at, self.state.q[self.model.loop_columns])
            slopes = ModeSolver(self.model, self.c).slopes(state)
            limit = limit_between_the_axes(*slopes, DormandPrince5.reach, DormandPrince5.decay_reach)
        except np.linalg.LinAlgError:
            return True
        return limit is not None and not h < NEAR * limit.h
