"""What methods are compared on: a model with its start, a duration, graded coordinates, and a reference path."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import followed
from runtime.contract.errors import ModelError
from runtime.contract.model import Model, refuse_events
from runtime.results.motion_error import floored
from runtime.start.start_state import start_state
from runtime.studies.work_precision.reference_path import reference_path
from runtime.studies.work_precision.self_reference import MARGIN, TooLong, self_reference

RTOL, ATOL = 1e-11, 1e-13
LOOSER = 100.0  # the error of the reference is estimated from a path with tolerances this much looser
SHORTER = 4.0
LONGEST_CUT = 1e4  # a problem is shortened to this part at most


Path = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Setting:
    """A model with parameters p and constants c from a state, for t_end [s].

    graded: positions in what tells the motion (`followed`); arguments are parameters, initial and start as `simulate`
    takes them.
    """

    model: Model
    p: np.ndarray
    c: np.ndarray
    state: ConsistentState
    t_end: float
    graded: list[int]
    arguments: Mapping[str, Any] = field(default_factory=dict)

    def judged(self) -> Problem:
        """With an independent reference: DOP853 at tight tolerances, judged by a looser run. Raises NoReference."""
        path = reference_path(self.model, self.c, self.state, self.t_end, RTOL, ATOL)
        looser = reference_path(self.model, self.c, self.state, self.t_end, RTOL * LOOSER, ATOL * LOOSER)
        times = np.linspace(0.0, self.t_end, 101)
        tight = path(times)
        off = np.sqrt(np.mean((looser(times) - tight) ** 2, axis=0)) / _amplitudes(self.model, tight)
        return self._problem(self.t_end, path, float(off[self.graded].max()))

    def quick(self, tolerance: float, seconds: float) -> tuple[Problem, float]:
        """(problem with a reference of its own making, tolerance): shortened where the motion is too long.

        Errors grow about in proportion to time, so the tolerance of a shortened problem shrinks with it.
        Raises NoReference.
        """
        t_end = self.t_end
        while True:
            allowed = tolerance * t_end / self.t_end
            try:
                path = self_reference(self.model, self.c, self.state, t_end, allowed, seconds, self.graded)
            except TooLong:
                t_end /= SHORTER
                if t_end < self.t_end / LONGEST_CUT:
                    raise
                continue
            return self._problem(t_end, path, allowed / MARGIN), allowed

    def _problem(self, t_end: float, path: Path, error: float) -> Problem:
        return Problem(self, t_end, path, error)


@dataclass(frozen=True)
class Problem:
    """A setting, or its first t_end seconds, with a reference: path gives what tells the motion (N, n) at times (N,).

    reference_error says how far the path may be off, relative like any error here.
    """

    setting: Setting
    t_end: float
    path: Path
    reference_error: float

    @property
    def model(self) -> Model:
        """Of the setting."""
        return self.setting.model

    @property
    def c(self) -> np.ndarray:
        """(c_size,) of the setting."""
        return self.setting.c

    @property
    def state(self) -> ConsistentState:
        """Where the motion starts."""
        return self.setting.state

    @property
    def graded(self) -> list[int]:
        """Positions of what is judged in what tells the motion."""
        return self.setting.graded

    def solved(self, solver: Callable[..., Any], times: np.ndarray, tolerance: float) -> Any:
        """What an adaptive solver makes of it at times (N,) [s]; its atol fits the smallest graded amplitude."""
        atol = tolerance * min(1.0, float(self.amplitudes.min()))
        return solver(self.model, t_end=self.t_end, times=times, rtol=tolerance, atol=atol, **self.setting.arguments)

    @cached_property
    def amplitudes(self) -> np.ndarray:
        """RMS (n_graded,) of each graded coordinate about its mean, over the motion [m or rad]."""
        return _amplitudes(self.model, self.path(np.linspace(0.0, self.t_end, 401)))[self.graded]

    def errors(self, times: np.ndarray, told: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(RMS over the motion, at the end), both (n_graded,), over the amplitude; times (N,) [s], told (N, n)."""
        with np.errstate(over="ignore", invalid="ignore"):
            off = (told - self.path(times))[:, self.graded] / self.amplitudes
            return np.sqrt(np.mean(off**2, axis=0)), np.abs(off[-1])


def _amplitudes(model: Model, told: np.ndarray) -> np.ndarray:
    """(n,) RMS of samples (N, n) of what tells the motion about their means, floored."""
    return floored(model, np.sqrt(np.mean((told - told.mean(axis=0)) ** 2, axis=0)))


def make_setting(
    model: Model,
    *,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    graded: list[str] | None = None,
) -> Setting:
    """A setting from the same arguments as `simulate`; graded: names (by default all that tells the motion).

    Raises ModelError or InitialStateError.
    """
    refuse_events(model, "comparisons of methods")
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    known = followed(model)[0]
    names = known if not graded else list(graded)
    for name in names:
        if name not in known:
            raise ModelError(
                f"{name!r} cannot be graded: it is not an independent coordinate of {model.name}; those "
                f"are {', '.join(known)}"
            )
    end = float(model.simulation["t_end"]) if t_end is None else float(t_end)
    return Setting(
        model,
        p,
        c,
        start_state(model, p, c, 0.0, initial, start),
        end,
        [known.index(name) for name in names],
        {"parameters": parameters, "initial": initial, "start": start},
    )
