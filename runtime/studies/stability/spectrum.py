"""What the amplification matrix at a state says: spectral radius, and growth that the equations do not have.

Over a step the equations themselves change, and may make a motion grow (a falling pendulum does). So multipliers of the
step are compared with those of the exact motion over the same time, which a much finer exponential step gives.
"""

from __future__ import annotations

from bisect import bisect
from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import dense_eigenvalues
from runtime.contract.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.studies.stability.tangent import TangentStep

VANISHED = 0.5  # multipliers below this have no counterpart in the motion that could grow
FINER = 4  # exact motion: this many exponential steps
ROUNDING = 1e-9


@dataclass(frozen=True)
class Spectrum:
    """Spectral radius of a major step, and of each mode (ascending) the growth rate [1/s] that the exact motion lacks.

    A negative rate is damping that the equations do not have.
    """

    radius: float
    growth: np.ndarray


class StepSpectrum:
    """Spectra of a scheme at states of a model; the step may be changed without building anything anew."""

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray, exact: ExactMotion | None = None) -> None:
        self.scheme, self.c = scheme, c
        self._step = _TangentFrom(scheme, c)
        self.exact = exact or ExactMotion(model, c)

    def matrix(self, state: State, dt: float) -> np.ndarray:
        """Amplification matrix (2 n_i, 2 n_i) of (q_i, q_i_dot) over a major step dt [s] started at a state."""
        return self._step(state, dt)

    def __call__(self, state: State, dt: float) -> Spectrum:
        """Radius and growth at a state."""
        exact, matrix = self.exact(state, dt), self.matrix(state, dt)
        if not np.isfinite(matrix).all():
            return Spectrum(np.inf, np.full(len(exact) // 2, np.inf))
        multipliers = dense_eigenvalues(matrix)
        size = np.abs(multipliers)
        # which mode a multiplier belongs to is told by the nearest exact one; aliases fall together
        nearest = np.abs(multipliers[:, None] - exact[None, :]).argmin(axis=1)
        growth = np.full(len(exact), -np.inf)
        for k in np.flatnonzero(size > VANISHED):
            j = nearest[k]
            with np.errstate(divide="ignore"):  # an exact multiplier of zero: growth without bound
                growth[j] = max(growth[j], float(np.log(size[k] / abs(exact[j]))))
        modes = growth.reshape(-1, 2).max(axis=1)
        return Spectrum(float(size.max()), np.where(np.isfinite(modes), modes, 0.0) / dt)


class ExactMotion:
    """Multipliers of the exact motion over a time, pairs of a mode together, slow modes first; kept for reuse.

    A motion over dt goes on from the longest shorter one that is known, by steps of at most dt / FINER.
    """

    def __init__(self, model: Model, c: np.ndarray) -> None:
        self._step = _TangentFrom(scheme_kind("exponential").build("exponential", model, 1.0, [4], {}), c)
        self.modes = ModeSolver(model, c)
        self._found: dict[tuple[float, float], np.ndarray] = {}
        self._eigenvalues: dict[float, np.ndarray] = {}
        self._reached: dict[float, list[Reached]] = {}

    def __call__(self, state: State, dt: float) -> np.ndarray:
        """Multipliers over dt from a state."""
        key = (state.t, dt)
        if key not in self._found:
            matrix = self._matrix(state, dt)
            values = dense_eigenvalues(matrix) if np.isfinite(matrix).all() else np.ones(len(matrix))
            values = values[np.argsort(-np.abs(values))][: 2 * self.modes.n]  # memory beyond the motion vanishes
            frozen = self._frozen(state)
            self._found[key] = values[_matched(np.exp(frozen * dt), values)]
        return self._found[key]

    def _frozen(self, state: State) -> np.ndarray:
        if state.t not in self._eigenvalues:
            values = self.modes(state).eigenvalues
            self._eigenvalues[state.t] = values[np.argsort(np.abs(values), kind="stable")]
        return self._eigenvalues[state.t]

    def _matrix(self, state: State, dt: float) -> np.ndarray:
        known = self._reached.setdefault(state.t, [self._step.start(state)])
        place = bisect(known, dt, key=lambda one: one.t)
        before = known[place - 1]
        steps = int(np.ceil(FINER * (dt - before.t) / dt - ROUNDING))
        reached = self._step.on(before, dt, steps)
        if np.isfinite(reached.matrix).all():
            known.insert(place, reached)
        return reached.matrix


def _matched(wanted: np.ndarray, found: np.ndarray) -> list[int]:
    """For each wanted value the nearest found one that is not taken yet."""
    left, order = list(range(len(found))), []
    for value in wanted:
        best = min(left, key=lambda k: abs(found[k] - value))
        left.remove(best)
        order.append(best)
    return order


@dataclass(frozen=True)
class Reached:
    """z and the amplification matrix a time t [s] after a state."""

    t: float
    z: np.ndarray
    matrix: np.ndarray


class _TangentFrom:
    """Amplification matrix of several major steps from a state."""

    def __init__(self, scheme: Scheme, c: np.ndarray) -> None:
        self.c, self.scheme, self._tangent = c, scheme, TangentStep(scheme)

    def start(self, state: State) -> Reached:
        """At the state itself."""
        c = self.scheme.constants(self.c, 1.0)
        z = np.asarray(self.scheme.starter(state.t, state.q_i, state.q_i_dot, state.loop, c)).ravel()
        return Reached(0.0, z, np.eye(len(self._tangent.columns)))

    def on(self, reached: Reached, t: float, steps: int) -> Reached:
        """Further on, up to t, by equal steps."""
        z, matrix = reached.z, reached.matrix
        c = self.scheme.constants(self.c, (t - reached.t) / max(steps, 1))
        for _ in range(steps):
            z, step = self._tangent(z, c)
            matrix = step @ matrix
        return Reached(t, z, matrix)

    def __call__(self, state: State, dt: float) -> np.ndarray:
        """Over one major step."""
        c = self.scheme.constants(self.c, dt)
        z = np.asarray(self.scheme.starter(state.t, state.q_i, state.q_i_dot, state.loop, c)).ravel()
        return self._tangent(z, c)[1]
