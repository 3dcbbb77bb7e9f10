"""scheme = "auto": a tolerance instead of a step, by the method that the stiffness of the motion asks for.

Candidates are the explicit pair, and exponentials on the stiff deflections where the model has any. Where there is a
choice both begin the motion; stiffness shows in the explicit pair's steps. The one that needs fewer operations for a
piece of it makes the run.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

import numpy as np

from runtime.contract.model import Model
from runtime.results.meter import Meter
from runtime.results.solution import Solution
from runtime.running.arguments import RunArguments
from runtime.running.inputs import bound
from runtime.running.simulate import simulate as run
from runtime.running.tolerance import tolerance_of, whole_span
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.schemes.stepper import Stepper
from runtime.start.start_state import start_state

AUTO = "auto"
TOLERANCE = 1e-3
EXPLICIT, EXPONENTIAL = "dopri5", "exponential_rk4"
SETTLED, TRIED = 0.01, 0.03  # of the motion: until the steps have found their length, and until they are compared


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
    if not model.has("deflections"):
        return AutomaticChoice(EXPLICIT, f"{EXPLICIT} to {tolerance:g}: no deflection of the mechanism is stiff")
    p = model.parameter_vector(settings.get("parameters"))
    c, t0 = model.constants(p), settings.get("t0", 0.0)
    state = start_state(model, p, c, t0, settings.get("initial"), settings.get("start"))
    span = whole_span(model, settings.get("t_end"), t0)
    price = {
        name: _operations(model, name, tolerance, c, (state.q, state.q_dot), t0, span)
        for name in (EXPLICIT, EXPONENTIAL)
    }
    best, other = sorted(price, key=lambda name: price[name])
    if not np.isfinite(price[best]):
        return AutomaticChoice(EXPONENTIAL, f"{EXPONENTIAL} to {tolerance:g}: neither method came through the trial")
    ratio = price[other] / price[best]
    seen = f"{ratio:.3g} times the operations" if np.isfinite(ratio) else "more operations than were tried"
    return AutomaticChoice(best, f"{best} to {tolerance:g}: {other} took {seen} on a piece of the motion")


def _operations(
    model: Model,
    name: str,
    tolerance: float,
    c: np.ndarray,
    state: tuple[np.ndarray, np.ndarray],
    t0: float,
    span: float,
) -> float:
    """Operations that a method takes from SETTLED to TRIED of the motion, infinite where it does not get there."""
    scheme = scheme_kind(name).build(name, model, SETTLED * span, None, {"tolerance": tolerance})
    assert isinstance(scheme, AdaptiveSteps)
    stepper = Stepper(scheme)
    z = stepper.start(t0, *state, c, SETTLED * span)
    ready = stepper.ready(c, SETTLED * span)
    stepper.run(z, ready, 1)
    before = scheme.operations_taken(z, stepper.program)
    stepper.run(z, ready, round(TRIED / SETTLED) - 1)
    arrived = int(z[1]) == round(TRIED / SETTLED) and np.isfinite(z).all()
    return scheme.operations_taken(z, stepper.program) - before if arrived else np.inf
