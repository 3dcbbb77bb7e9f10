"""Stability charts: spectral radius over (dt_S, m) along a motion, with limits, growth rates and resonance windows."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NUMBERS, arguments
from runtime.contract.errors import ModelError
from runtime.contract.files import write_text
from runtime.contract.model import Model
from runtime.operating.mode_solver import State
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.studies.stability.along import states_along
from runtime.studies.stability.limits import StabilityCurve, StabilityStudy, usual_steps
from runtime.studies.stability.spectrum import ExactMotion

USUAL_RATIOS = (1, 2, 3, 4, 6, 8, 12, 16)
STATES, POINTS = 16, 20
Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class StabilityChart:
    """Curves over the major step for each m. t_end [s] is the motion's length; states, where it was looked at."""

    model: Model
    scheme: str
    curves: list[StabilityCurve]
    states: list[State]
    t_end: float

    def table(self) -> list[dict[str, Any]]:
        """One row for each m: the largest stable steps [s], and the windows of instability below stable steps."""
        return [
            {
                "m": curve.m,
                "dt_limit": curve.limit,
                "dt_S_limit": None if curve.limit is None else curve.limit / prod(curve.m),
                "no_limit_found": curve.beyond,
                "windows": curve.windows,
                "largest_growth_below_limit": _growth_below(curve),
                "smallest_dt": float(curve.dt[0]),
                "growth_at_smallest_dt": float(curve.growth[0]),
            }
            for curve in self.curves
        ]

    def write_csv(self, path: str | Path) -> None:
        """Every point: m, dt, dt_S [s], spectral radius, growth rate [1/s], stable. Raises OutputError."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["m", "dt", "dt_S", "spectral_radius", "growth_rate", "stable"])
        for curve in self.curves:
            for dt, radius, growth, stable in zip(curve.dt, curve.radius, curve.growth, curve.stable, strict=True):
                writer.writerow(
                    [
                        " ".join(map(str, curve.m)) or "1",
                        repr(float(dt)),
                        repr(float(dt) / prod(curve.m)),
                        repr(float(radius)),
                        repr(float(growth)),
                        int(stable),
                    ]
                )
        write_text(path, text.getvalue())


def _growth_below(curve: StabilityCurve) -> float | None:
    """The largest growth [1/s] among steps up to the limit; None where even the smallest step is unstable."""
    if curve.limit is None:
        return None
    below = curve.growth[curve.dt <= curve.limit]
    return float(below.max()) if len(below) else 0.0


@arguments(options=BY_NAME, parameters=BY_NAME, initial=BY_NAME, dt_range=NUMBERS)
def stability_chart(
    model: Model,
    scheme: str | None = None,
    *,
    m: list[list[int]] | None = None,
    dt_range: tuple[float, float] | None = None,
    points: int = POINTS,
    states: int = STATES,
    options: Mapping[str, Any] | None = None,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    progress: Progress | None = None,
) -> StabilityChart:
    """Chart of a scheme (the scene's own by default) at `states` states of a motion of t_end [s].

    m: lists of ratios (a usual set by default); dt_range: smallest and largest step of the fastest group [s].
    Raises SchemeError, ModelError or InitialStateError for arguments that cannot be used.
    """
    if not model.q_i:
        raise ModelError(
            f"every coordinate of model {model.name} is driven: nothing is stepped, so nothing is unstable"
        )
    name = scheme or str(model.simulation["scheme"])
    if name == "auto":
        raise SchemeError("scheme", f"model {model.name} names none", "name the scheme whose stability is asked for")
    if not model.has("residual_jacobian"):
        raise ModelError(f"model {model.name} was generated without its Jacobians; regenerate it with all functions")
    end = float(model.simulation["t_end"]) if t_end is None else float(t_end)
    if not end > 0:
        raise ModelError(f"t_end must be a positive time, not {t_end!r}")
    c = model.constants(model.parameter_vector(parameters))
    along = states_along(model, t_end=end, count=states, parameters=parameters, initial=initial, start=start)
    exact = ExactMotion(model, c)
    chosen = _usual_ratios(model, name) if m is None else m
    curves = []
    for k, ratios in enumerate(chosen):
        study = StabilityStudy(model, name, ratios, options or {}, c, along, end, exact)
        sub_steps = prod(study.m)
        if dt_range is not None:
            steps = np.geomspace(dt_range[0] * sub_steps, dt_range[1] * sub_steps, points)
        else:
            steps = usual_steps(model, along, exact, end, sub_steps, points)

        def report(done: float, of: float, k: int = k) -> None:
            if progress is not None:
                progress(k + done / of, float(len(chosen)))

        curves.append(study.curve(steps, report))
    return StabilityChart(model, name, curves, along, end)


def _usual_ratios(model: Model, name: str) -> list[list[int]]:
    kind = scheme_kind(name)
    if kind.ratios == "none":
        return [[]]
    if kind.ratios == "sub_steps":
        return [[2], [4], [8]]
    groups = len(model.groups)
    return [[1] * (groups - 2) + [ratio] for ratio in USUAL_RATIOS] if groups > 1 else [[]]
