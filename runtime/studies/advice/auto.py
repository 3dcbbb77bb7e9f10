"""scheme = "auto": the method, step and m that advice finds; every other scheme goes straight to the run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil
from typing import Any, Unpack

from runtime.contract.model import Model
from runtime.results.meter import Meter
from runtime.results.solution import Solution
from runtime.running.inputs import bound
from runtime.running.simulate import RunArguments
from runtime.running.simulate import simulate as run
from runtime.schemes.options import SchemeError

AUTO = "auto"
TOLERANCE = 1e-3


def simulate(
    model: Model,
    *,
    scheme: str | None = None,
    tolerance: float | None = None,
    graded: list[str] | None = None,
    **settings: Unpack[RunArguments],
) -> Solution:
    """Simulate a model from t0 until t_end (None: the scene's own settings).

    scheme: a name of runtime.SCHEMES, or `auto`: the fastest one that keeps `tolerance` (1e-3) in the `graded`
    coordinates (all), with the step and m that advice finds. settings: see runtime.running.simulate.simulate, which
    does the run: t_end, dt [s], m, parameters, initial, inputs, save_every, engine, options, t0, progress, force,
    start, outputs, stream, checkpoint, checkpoint_every. Advice looks at constants and functions among the inputs.
    progress = True shows how far the run is, on a terminal or in a notebook.

    Numerical failure does not raise: see Solution.status. Raises SchemeError, ModelError, InitialStateError,
    OutputError or CompilerError for arguments that cannot be used.
    """
    if settings.get("progress") is True:
        with Meter(model.name) as meter:
            settings["progress"] = meter
            return simulate(model, scheme=scheme, tolerance=tolerance, graded=graded, **settings)
    if (scheme or model.simulation.get("scheme")) != AUTO or not model.q_i:
        if tolerance is not None or graded is not None:
            raise SchemeError("tolerance and graded belong to scheme = auto; other schemes take the step dt")
        return run(model, scheme=scheme, **settings)
    if settings.get("dt") is not None or settings.get("m") is not None or settings.get("options"):
        raise SchemeError("auto chooses dt, m and options itself; leave them out and give a tolerance")
    found = choose(
        bound(model, settings.get("inputs")),
        settings.get("t_end"),
        settings.get("parameters"),
        settings.get("initial"),
        settings.get("start"),
        tolerance,
        graded,
        settings.get("save_every"),
        settings.get("t0", 0.0),
    )
    solution = run(model, **{**settings, **found.arguments})
    solution.stats["advice"] = found.reason
    return solution


@dataclass(frozen=True)
class AutomaticChoice:
    """Arguments that replace scheme, dt, m, options and save_every, and the reason."""

    arguments: dict[str, Any]
    reason: str


def choose(
    model: Model,
    t_end: float | None,
    parameters: Mapping[str, float] | None,
    initial: Mapping[str, float] | None,
    start: str | None,
    tolerance: float | None,
    graded: list[str] | None,
    save_every: int | None,
    t0: float,
) -> AutomaticChoice:
    """What to step with. States are saved about as often as the scene says. Raises what `advise` raises."""
    from runtime.studies.advice.advise import advise  # brings SciPy, which only this scheme needs

    if t0 != 0:
        raise SchemeError("auto looks at the motion from t = 0; name a scheme for a start at another time")
    advice = advise(
        model,
        tolerance=TOLERANCE if tolerance is None else tolerance,
        graded=graded,
        t_end=t_end,
        parameters=parameters,
        initial=initial,
        start=start,
    )
    dt = advice.t_end / ceil(advice.t_end / advice.dt * (1 - 1e-12))
    usual = float(model.simulation["dt"]) * int(model.simulation["save_every"])
    every = max(1, round(usual / dt)) if save_every is None else save_every
    arguments = {
        "scheme": advice.spec.scheme,
        "dt": dt,
        "m": list(advice.spec.m) if advice.spec.m else None,
        "options": dict(advice.spec.options),
        "save_every": every,
    }
    return AutomaticChoice(arguments, advice.reason)
