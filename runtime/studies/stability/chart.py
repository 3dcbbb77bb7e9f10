"""Stability charts: spectral radius over (dt_S, m) along a motion, with limits, growth rates and resonance windows."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.baselines.scipy_methods import reference_solution
from runtime.contract.arguments import BY_NAME, CALLED, NUMBERS, RATIOS, arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.files import write_text
from runtime.contract.model import EmittedModel
from runtime.operating.mode_solver import State, state_at
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.studies.stability.spectra import ExactMotion, StepSpectrum

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# The largest stable step, resonance windows, and maps of the spectral radius over (dt, m), along a trajectory.

TENFOLD = float(np.log(10.0))
SHARE_OF_FREQUENCY = 1e-4  # growth below this share of a mode's frequency is the change of the mechanism in a step
CHART_BISECTIONS = 9
MOST_CHART_LOOKS = 10_000  # steps, and states, of a chart
Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class StabilityCurve:
    """For one m, over major steps dt [s]: largest spectral radius and mean growth rate of the worst mode [1/s].

    stable[k]: no mode grows tenfold over the motion. limit: the largest step up to which all are stable [s], None if
    even the smallest is not; beyond is True if no unstable step was found at all. windows: unstable intervals of dt
    below stable ones.
    """

    m: list[int]
    dt: np.ndarray
    radius: np.ndarray
    growth: np.ndarray
    stable: np.ndarray
    limit: float | None
    beyond: bool
    windows: list[tuple[float, float]]


def frequencies(exact: ExactMotion, state: State) -> np.ndarray:
    """(n_i,) of the modes at a state [rad/s], ascending: of each pair of eigenvalues the larger."""
    return np.asarray(np.sort(np.abs(exact.modes.eigenvalues(state)))[1::2])


class StabilityStudy:
    """Stability of one scheme with one m at several states of a motion that lasts t_end [s]."""

    def __init__(
        self,
        model: EmittedModel,
        name: str,
        m: list[int] | None,
        options: Mapping[str, Any],
        c: np.ndarray,
        states: list[State],
        t_end: float,
        exact: ExactMotion | None = None,
    ) -> None:
        scheme = scheme_kind(name).build(name, model, 1.0, m, options)
        self.m, self.states, self.t_end = list(scheme.grid.m), states, t_end
        self._spectrum = StepSpectrum(model, scheme, c, exact)
        modes = [frequencies(self._spectrum.exact, state) for state in states]
        self._allowed = np.maximum(TENFOLD / t_end, SHARE_OF_FREQUENCY * np.mean(modes, axis=0))

    def at(self, dt: float) -> tuple[float, float, bool]:
        """(largest radius, mean growth of the worst mode [1/s], stable?) for a major step."""
        found = [self._spectrum(state, dt) for state in self.states]
        growth = np.mean([one.growth for one in found], axis=0)
        worst = float(growth.max(initial=0.0))
        return max(one.radius for one in found), max(worst, 0.0), bool((growth <= self._allowed).all())

    def curve(self, dts: np.ndarray, progress: Progress | None = None) -> StabilityCurve:
        """Radius and growth over major steps dts (N,) [s], ascending, with limit and windows found by bisection."""
        rows = []
        for k, dt in enumerate(dts):
            rows.append(self.at(float(dt)))
            if progress is not None:
                progress(k + 1.0, float(len(dts)))
        radius, growth, stable = (np.array(column) for column in zip(*rows, strict=True))
        edges = [k for k in range(len(dts) - 1) if stable[k] != stable[k + 1]]
        places = [self._edge(float(dts[k]), float(dts[k + 1]), bool(stable[k])) for k in edges]
        starts = [place for k, place in zip(edges, places, strict=True) if stable[k]]
        ends = [place for k, place in zip(edges, places, strict=True) if not stable[k]]
        limit = starts[0] if stable[0] and starts else (float(dts[-1]) if stable.all() else None)
        if not stable[0]:
            starts = [float(dts[0]), *starts]
        windows = list(zip(starts, ends, strict=False))
        return StabilityCurve(self.m, np.asarray(dts), radius, growth, stable, limit, bool(stable.all()), windows)

    def _edge(self, low: float, high: float, stable_low: bool) -> float:
        for _ in range(CHART_BISECTIONS):
            middle = (low * high) ** 0.5
            if self.at(middle)[2] == stable_low:
                low = middle
            else:
                high = middle
        return float((low * high) ** 0.5)


# States along a trajectory, at which stability and frequencies are looked at.

CHART_RTOL, CHART_ATOL = 1e-7, 1e-10


def states_along(
    model: EmittedModel,
    *,
    t_end: float,
    count: int = 9,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> list[State]:
    """`count` states from 0 to t_end, evenly spaced but for a shift that keeps them off multiples of the motion."""
    places = (np.arange(count) + 0.5 * np.sin(np.arange(count)) ** 2) / max(1, count - 0.5)
    solution = reference_solution(
        model,
        t_end=t_end,
        times=places * t_end,
        rtol=CHART_RTOL,
        atol=CHART_ATOL,
        parameters=parameters,
        initial=initial,
        start=start,
    )
    return [state_at(solution, k) for k in range(len(solution.t))]


def usual_steps(
    model: EmittedModel, states: list[State], exact: ExactMotion, t_end: float, sub_steps: int, count: int
) -> np.ndarray:
    """Major steps (count,) [s] to look at: around what the fastest mode allows a sub-step, at most t_end / 4."""
    fastest = max(float(frequencies(exact, state)[-1]) for state in states)
    edge = 2.0 / fastest if fastest > 0 else t_end / 100
    high = min(4.0 * edge * sub_steps, t_end / 4)
    return np.geomspace(min(0.02 * edge * sub_steps, high / 20), high, count)


# ---- The chart over all ratios, as a table and a picture.

USUAL_RATIOS = (1, 2, 3, 4, 6, 8, 12, 16)
CHART_STATES, CHART_POINTS = 16, 20


@dataclass(frozen=True)
class StabilityChart:
    """Curves over the major step for each m. t_end [s] is the motion's length; states, where it was looked at."""

    model: EmittedModel
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

    def picture(self, path: str | Path | None = None) -> Figure:
        """Spurious growth in a major step over dt_S for each m, limits as bars. Raises OutputError."""
        from runtime.views.plots import stability_picture

        rows = [
            (
                ",".join(map(str, one.m)) or "-",
                one.dt / prod(one.m),
                np.expm1(np.minimum(one.growth * one.dt, 50.0)),
                None if one.limit is None or one.beyond else one.limit / prod(one.m),
                [(low / prod(one.m), high / prod(one.m)) for low, high in one.windows],
            )
            for one in self.curves
        ]
        about = f"{self.model.title or self.model.name}: {self.scheme}, {len(self.states)} states of {self.t_end:g} s"
        return stability_picture(about, rows, path)


def _growth_below(curve: StabilityCurve) -> float | None:
    """The largest growth [1/s] among steps up to the limit; None where even the smallest step is unstable."""
    if curve.limit is None:
        return None
    below = curve.growth[curve.dt <= curve.limit]
    return float(below.max()) if len(below) else 0.0


@arguments(m=RATIOS, options=BY_NAME, parameters=BY_NAME, initial=BY_NAME, dt_range=NUMBERS, progress=CALLED)
def stability_chart(
    model: EmittedModel,
    scheme: str | None = None,
    *,
    m: list[list[int]] | None = None,
    dt_range: tuple[float, float] | None = None,
    points: int = CHART_POINTS,
    states: int = CHART_STATES,
    options: Mapping[str, Any] | None = None,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    progress: Progress | None = None,
) -> StabilityChart:
    """Chart the stability of a scheme at states of a motion.

    Parameters
    ----------
    model : Model
        The mechanism.
    scheme : str, optional
        The scene's own by default.
    m : list of list of int, optional
        Ratios to chart; a usual set by default.
    dt_range : (float, float), optional
        Smallest and largest step of the fastest group [s].
    points : int, optional
        Steps in between.
    states : int, optional
        States of the motion that are looked at.
    options : mapping, optional
        Of the scheme.
    t_end : float, optional
        Length of the motion [s].
    parameters, initial, start : optional
        As of `simulate`.
    progress : callable, optional
        Called with (done, all).

    Returns
    -------
    StabilityChart
        Growth [1/s] over the step for each m, and the limit of each.

    Raises
    ------
    SchemeError, ModelError, InitialStateError
        For arguments that cannot be used.

    Notes
    -----
    Eigenvalues of one major step of the linearised equations; growth is what the step adds to that of the motion
    itself.
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
    for count, what in ((points, "points"), (states, "states")):
        if not 1 <= count <= MOST_CHART_LOOKS:
            raise ArgumentError(what, f"cannot be {count}", f"give 1 to {MOST_CHART_LOOKS}")
    if dt_range is not None and not (len(dt_range) == 2 and 0 < dt_range[0] < dt_range[1]):
        raise ArgumentError("dt_range", f"cannot be {dt_range!r}", "give the shortest and the longest step [s]")
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


def _usual_ratios(model: EmittedModel, name: str) -> list[list[int]]:
    kind = scheme_kind(name)
    if kind.ratios == "none":
        return [[]]
    if kind.ratios == "sub_steps":
        return [[2], [4], [8]]
    groups = len(model.groups)
    return [[1] * (groups - 2) + [ratio] for ratio in USUAL_RATIOS] if groups > 1 else [[]]
