"""scheme = "auto": the method, step and m that advice finds, as arguments of `simulate`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil
from typing import Any

from runtime.advice.advise import advise
from runtime.model import Model
from runtime.schemes.options import SchemeError

AUTO = "auto"
TOLERANCE = 1e-3


@dataclass(frozen=True)
class Choice:
    """Arguments that replace scheme, dt, m, options and save_every, and the reason."""

    arguments: dict[str, Any]
    reason: str


def choose(model: Model, t_end: float | None, parameters: Mapping[str, float] | None,
           initial: Mapping[str, float] | None, start: str | None, tolerance: float | None, graded: list[str] | None,
           save_every: int | None, t0: float) -> Choice:
    """What to step with. States are saved about as often as the scene says. Raises what `advise` raises."""
    if t0 != 0:
        raise SchemeError("auto looks at the motion from t = 0; name a scheme for a start at another time")
    advice = advise(model, tolerance=TOLERANCE if tolerance is None else tolerance, graded=graded, t_end=t_end,
                    parameters=parameters, initial=initial, start=start)
    dt = advice.t_end / ceil(advice.t_end / advice.dt * (1 - 1e-12))
    usual = float(model.simulation["dt"]) * int(model.simulation["save_every"])
    every = max(1, round(usual / dt)) if save_every is None else save_every
    arguments = {"scheme": advice.spec.scheme, "dt": dt, "m": list(advice.spec.m) if advice.spec.m else None,
                 "options": dict(advice.spec.options), "save_every": every}
    return Choice(arguments, advice.reason)
