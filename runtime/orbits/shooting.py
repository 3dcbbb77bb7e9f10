"""The map of a period, x(t0) -> x(t0 + T), with its exact derivatives, and Newton's method on x(t0 + T) = x(t0).

The map is that of Poincare for forced motions (stroboscopic).

This is multiple shooting: the period is cut into K parts of equal length. The unknowns are the states x_k = (q_i,
q_i_dot) at their starts, the period T where it is free, and the conditions

    F_k(x_k, T, p) - x_{k+1} = 0,    k < K - 1
    F_{K-1}(x_{K-1}, T, p) - x_0 - turn = 0
    (x_0 - x_guess) . x_guess_dot = 0                  the phase, only where T is free

turn holds the whole turns, 2 pi k, by which angles go on in a period. Derivatives by x and p are tangents of the run
itself, those by T are the rates at the end of a part times its share of the period.
Source: Nayfeh & Balachandran, Applied Nonlinear Dynamics, ch. 6; Ascher, Mattheij & Russell, ch. 4.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from runtime.contract.errors import ArgumentError, NoResult, SymgenError
from runtime.contract.model import EmittedModel
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.orbits.states import States

CLOSED_MOTION = 1e-11  # of each coordinate's scale: what a closed motion may be open by
SHOOTING_ROUNDING = 1e-8  # the same, where Newton's method gets no nearer
SHOOTING_ITERATIONS, SHOT_HALVINGS = 25, 8
SPENT = 1e-7  # s: parts of a period are not shorter
START = "give a start nearer to the motion, let it settle first (settle=20 periods), or cut the period into parts"

T = TypeVar("T")


class NoPeriodicMotion(NoResult):
    """Shooting found no motion that repeats."""


@dataclass(frozen=True)
class Shot:
    """Parts of a period from states x (K, n): where they end (K, n), how that moves with their starts (K, n, n).

    by_parameters (K, n, n_p); rates (K, n) at the ends [per s].
    """

    x: np.ndarray
    ends: np.ndarray
    slopes: np.ndarray
    by_parameters: np.ndarray
    rates: np.ndarray

    @property
    def monodromy(self) -> np.ndarray:
        """(n, n) dx(t0 + T)/dx(t0)."""
        found = np.eye(self.x.shape[1])
        for slope in self.slopes:
            found = slope @ found
        return found


@dataclass(frozen=True)
class Setting:
    """What is run: a model with a scheme, so many steps a part, so many parts a period, from t0 [s] on."""

    model: EmittedModel
    scheme: str
    steps: int
    parts: int
    t0: float
    options: Mapping[str, Any]
    inputs: Mapping[str, Any]


class PeriodMap:
    """The map of a period of T [s]; by: parameters that it is differentiated by. Raises what DifferentiableRun does.

    states: what the numbers of a state are.
    """

    def __init__(self, setting: Setting, period: float, parameters: Mapping[str, float], by: Sequence[str]) -> None:
        self.setting, self.parameters, self.by = setting, dict(parameters), tuple(by)
        self.states = States(setting.model)
        key = f"orbit by {setting.scheme} {dict(setting.options)} {self.by}"
        own = setting.model.derived(key, lambda: self._first(period)) if not setting.inputs else self._first(period)
        self._run = own.over(setting.t0, period / setting.parts, setting.steps, parameters=self.parameters)
        self._placed: dict[tuple[float, float], DifferentiableRun] = {}

    @property
    def size(self) -> int:
        """Numbers in a state."""
        return len(self.states.names)

    def shot(self, x: np.ndarray, period: float, values: Sequence[float]) -> Shot:
        """From states x (K, n) at parameters `by` with these values. Raises NoPeriodicMotion."""
        parts, n = self.setting.parts, self.size
        ends, rates = np.zeros((parts, n)), np.zeros((parts, n))
        slopes, by_parameters = np.zeros((parts, n, n)), np.zeros((parts, n, len(self.by)))
        for k in range(parts):
            found = result_of(self._part(k, period).jacobian, np.concatenate([x[k], values]))
            ends[k], rates[k] = self.states.state_of_outputs(found.values[-1], x[(k + 1) % parts])
            slope = self.states.slopes(found.values[-1], found.derivatives[-1], ends[k])
            slopes[k], by_parameters[k] = slope[:, :n], slope[:, n:]
        return Shot(x, ends, slopes, by_parameters, rates)

    def ends(self, x: np.ndarray, period: float, values: Sequence[float]) -> np.ndarray:
        """(K, n) where the parts end. Raises NoPeriodicMotion."""
        following = np.roll(x, -1, axis=0)
        return np.array([self._end(k, x[k], period, values, following[k]) for k in range(len(x))])

    def along(self, x: np.ndarray, period: float, values: Sequence[float]) -> np.ndarray:
        """(K, n) starts of the parts of one motion from x (n,)."""
        found = [x]
        for k in range(self.setting.parts - 1):
            found.append(self._end(k, found[-1], period, values, found[-1]))
        return np.array(found)

    def _end(self, k: int, x: np.ndarray, period: float, values: Sequence[float], beside: np.ndarray) -> np.ndarray:
        """(n,) where a part ends, near to the state `beside`."""
        shown = result_of(self._part(k, period).values, np.concatenate([x, values]))
        return self.states.state_of_outputs(shown[-1], beside)[0]

    def with_steps(self, setting: Setting) -> PeriodMap:
        """The same with other steps and parts; what is compiled is shared."""
        other = copy(self)
        other.setting, other._placed = setting, {}
        return other

    def with_parts(self, parts: int) -> PeriodMap:
        """The same with the steps of a period in so many parts."""
        setting = self.setting
        return self.with_steps(replace(setting, parts=parts, steps=setting.steps * setting.parts // parts))

    def next_period(self, x: np.ndarray, period: float) -> np.ndarray:
        """(n,) where the first part ends if it begins a period later, from a state x (n,). Raises NoPeriodicMotion."""
        later = self._run.over(self.setting.t0 + period, period / self.setting.parts, self.setting.steps)
        return self.states.state_of_outputs(result_of(later.values, x)[-1], x)[0]

    def _part(self, k: int, period: float) -> DifferentiableRun:
        length = period / self.setting.parts
        if not np.isfinite(length) or length < SPENT:
            raise NoPeriodicMotion(f"a period of {period:g} s", "is none", "give a better guess of it")
        key = (self.setting.t0 + k * length, length)
        if key not in self._placed:
            if len(self._placed) > 4 * self.setting.parts:
                self._placed.clear()
            self._placed[key] = self._run.over(*key, self.setting.steps)
        return self._placed[key]

    def _first(self, period: float) -> DifferentiableRun:
        return self._prepared(period, self.states.outputs, self.by, self.setting.inputs)

    def _prepared(
        self, period: float, outputs: Sequence[str], by: Sequence[str], inputs: Mapping[str, Any]
    ) -> DifferentiableRun:
        """by: besides the state."""
        own, setting = self.setting.model, self.setting
        length = period / setting.parts
        return DifferentiableRun(
            own,
            outputs,
            [*self.states.names, *by],
            initial=self.states.upright,
            t_end=setting.t0 + length,
            dt=length / setting.steps,
            scheme=setting.scheme,
            options=setting.options,
            start="given",
            t0=setting.t0,
            inputs=inputs or None,
            samples=1,
        )


def result_of(run: Callable[[np.ndarray], T], x: np.ndarray) -> T:
    """What a run from x gives. Raises NoPeriodicMotion where it does not come to its end, and says why."""
    try:
        return run(x)
    except NoPeriodicMotion:
        raise
    except NoResult as error:
        raise NoPeriodicMotion(
            f"a run of a period of {error.item}", f"does not come to its end: {error.problem}", START
        ) from None


@dataclass(frozen=True)
class Closed:
    """A motion that repeats: the shot from it, its period [s], the turns of its angles (n,), Newton's iterations."""

    shot: Shot
    period: float
    turn: np.ndarray
    iterations: int


@dataclass(frozen=True)
class Conditions:
    """What a motion that repeats satisfies. scale (n,): sizes of the states; turn (n,); free: is T unknown?

    guess (n,), guess_rates (n,): the phase of a free one.
    """

    scale: np.ndarray
    turn: np.ndarray
    free: bool
    guess: np.ndarray
    guess_rates: np.ndarray

    def residual(self, x: np.ndarray, ends: np.ndarray) -> np.ndarray:
        """(K n,) or (K n + 1,), each over its scale."""
        gaps = ends - np.roll(x, -1, axis=0)
        gaps[-1] -= self.turn
        found = (gaps / self.scale).ravel()
        if not self.free:
            return np.asarray(found)
        rates = self.guess_rates / self.scale
        return np.append(found, rates @ ((x[0] - self.guess) / self.scale) / max(np.linalg.norm(rates), 1e-300))

    def jacobian(self, shot: Shot) -> np.ndarray:
        """Of the residual by (x / scale, T)."""
        parts, n = shot.x.shape
        found = np.zeros((parts * n + self.free, parts * n + self.free))
        for k in range(parts):
            here, there = slice(k * n, k * n + n), (k + 1) % parts
            found[here, here] += shot.slopes[k] * self.scale / self.scale[:, None]
            found[here, there * n : there * n + n] -= np.eye(n)
            if self.free:
                found[here, -1] = shot.rates[k] / self.scale / parts
        if self.free:
            rates = self.guess_rates / self.scale
            found[-1, :n] = rates / max(np.linalg.norm(rates), 1e-300)
        return found

    def by_parameters(self, shot: Shot) -> np.ndarray:
        """(rows of the residual, n_p)."""
        found = (shot.by_parameters / self.scale[:, None]).reshape(-1, shot.by_parameters.shape[2])
        return np.vstack([found, np.zeros((1, found.shape[1]))]) if self.free else found


def closed(map_: PeriodMap, conditions: Conditions, shot: Shot, period: float, values: Sequence[float]) -> Closed:
    """Newton's method with a line search from a shot. Raises NoPeriodicMotion with what came nearest."""
    for iteration in range(SHOOTING_ITERATIONS):
        residual = conditions.residual(shot.x, shot.ends)
        size = float(np.abs(residual).max())
        if size <= CLOSED_MOTION:
            return Closed(shot, period, conditions.turn, iteration)
        found = _searched(map_, conditions, shot, period, values, residual)
        if found is None:
            if size <= SHOOTING_ROUNDING:
                return Closed(shot, period, conditions.turn, iteration)
            break
        shot, period = found
    worst = int(np.abs(residual[: shot.x.size]).argmax()) % map_.size
    raise NoPeriodicMotion(
        f"model {map_.setting.model.name}",
        f"Newton's method leaves {map_.states.names[worst]} open by {np.abs(residual).max():.2g} of its size after "
        f"{iteration + 1} iterations with a period of {period:.6g} s",
        START,
    )


def closed_beside(map_: PeriodMap, conditions: Conditions, found: Closed) -> Closed:
    """The motion by a map that differs little from the one of `found`: with derivatives of its first shot only.

    Raises NoPeriodicMotion.
    """
    first = map_.shot(found.shot.x, found.period, ())
    shot, period, size = first, found.period, np.inf
    jacobian = conditions.jacobian(first)
    while True:
        residual = conditions.residual(shot.x, shot.ends)
        before, size = size, float(np.abs(residual).max())
        if size <= CLOSED_MOTION or (size <= SHOOTING_ROUNDING and size > before / 4):
            return Closed(shot, period, conditions.turn, 0)
        if not size <= before / 4:
            return closed(map_, conditions, first, found.period, ())
        x, period = _moved(conditions, shot.x, period, _solved(jacobian, -residual))
        shot = replace(shot, x=x, ends=map_.ends(x, period, ()))


def _solved(jacobian: np.ndarray, right: np.ndarray) -> np.ndarray:
    """By least squares where the Jacobian is singular: a free motion without a phase, a fold."""
    return np.asarray(np.linalg.lstsq(jacobian, right, rcond=1e-13)[0])


def _moved(conditions: Conditions, x: np.ndarray, period: float, step: np.ndarray) -> tuple[np.ndarray, float]:
    """States and period after a step of the unknowns."""
    there = x + step[: x.size].reshape(x.shape) * conditions.scale
    return there, period + float(step[-1]) if conditions.free else period


def _searched(
    map_: PeriodMap,
    conditions: Conditions,
    shot: Shot,
    period: float,
    values: Sequence[float],
    residual: np.ndarray,
) -> tuple[Shot, float] | None:
    """Along Newton's step to where the residual is smaller; None where it is not. Most often the whole step will do."""
    step = _solved(conditions.jacobian(shot), -residual)
    size, share = np.linalg.norm(residual), 1.0
    for halving in range(SHOT_HALVINGS):
        there, length = _moved(conditions, shot.x, period, share * step)
        try:
            if length > 0.2 * period:
                found = map_.shot(there, length, values) if halving == 0 else None
                ends = map_.ends(there, length, values) if found is None else found.ends
                if np.linalg.norm(conditions.residual(there, ends)) < (1 - 1e-4 * share) * size:
                    return found or map_.shot(there, length, values), length
        except SymgenError as error:
            if isinstance(error, ArgumentError):
                raise
        share /= 2
    return None
