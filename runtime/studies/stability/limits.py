"""The largest stable step, resonance windows, and maps of the spectral radius over (dt, m), along a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.model import Model
from runtime.operating.mode_solver import State
from runtime.schemes.catalogue import scheme_kind
from runtime.studies.stability.spectrum import ExactMotion, StepSpectrum

TENFOLD = float(np.log(10.0))
SHARE_OF_FREQUENCY = 1e-4  # growth below this share of a mode's frequency is the change of the mechanism in a step
BISECTIONS = 9
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


class StabilityStudy:
    """Stability of one scheme with one m at several states of a motion that lasts t_end [s]."""

    def __init__(
        self,
        model: Model,
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
        modes = [self._spectrum.exact.modes(state).frequencies for state in states]
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
        for _ in range(BISECTIONS):
            middle = (low * high) ** 0.5
            if self.at(middle)[2] == stable_low:
                low = middle
            else:
                high = middle
        return float((low * high) ** 0.5)


def usual_steps(
    model: Model, states: list[State], exact: ExactMotion, t_end: float, sub_steps: int, count: int
) -> np.ndarray:
    """Major steps (count,) [s] to look at: around what the fastest mode allows a sub-step, at most t_end / 4."""
    fastest = max(float(exact.modes(state).frequencies[-1]) for state in states)
    edge = 2.0 / fastest if fastest > 0 else t_end / 100
    high = min(4.0 * edge * sub_steps, t_end / 4)
    return np.geomspace(min(0.02 * edge * sub_steps, high / 20), high, count)
