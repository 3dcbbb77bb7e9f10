"""Motions that repeat, followed over a parameter through folds: pseudo-arclength continuation.

y = (x / scale, T, lambda / range) is a point of the curve r(y) = 0 of motions that repeat. From a point with the unit
tangent t the next one is predicted at y + s t and corrected by Newton's method on

    r(y) = 0,    t . (y - y_predicted) = 0

which is regular at folds, too. Steps s follow Newton's iterations and the curve's bend. What passes between two points
(a fold, a flip, a second frequency) is located by Brent's method over s.
Source: Seydel, Practical Bifurcation and Stability Analysis, ch. 4 and 7.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import brentq

from runtime.contract.arguments import NUMBER, NUMBERS, arguments
from runtime.contract.errors import ArgumentError, SymgenError
from runtime.contract.model import EmittedModel
from runtime.orbits.branch import KeptBranch, PeriodicBranch, Place, Point, Special
from runtime.orbits.controllers import period_map, refuse_samples, samples_in
from runtime.orbits.floquet import FLIP, FOLD, NEIMARK_SACKER, REAL, UNSTABLE, floquet
from runtime.orbits.motion import PeriodicMotion
from runtime.orbits.periodic import companion_steps, doubted, periodic, speed_period
from runtime.orbits.shooting import CLOSED_MOTION, SHOOTING_ROUNDING, Conditions, NoPeriodicMotion, Setting, Shot
from runtime.running.inputs import bound

FIRST_ARC_STEP, LONGEST_ARC_STEP, SHORTEST = 0.02, 0.08, 1e-6  # steps along the curve, in parts of the range
ARC_NEWTON_ITERATIONS, QUICK = 8, 3  # of Newton's method: at most, and so few that steps grow
PASSED = 1e-4  # what is located is that near to zero; else it jumped there
BENT = 0.9  # cosine between two tangents, at least
BRANCH = "branch point"
BETWEEN = "stability changes hereabouts"  # where the place cannot be located: a branch of motions at one value
INTERRUPTED_BRANCH = "interrupted"

Progress = Callable[[float, float], None]


@arguments(span=NUMBERS, step=NUMBER)
def periodic_over(
    model: EmittedModel,
    over: str,
    span: tuple[float, float],
    *,
    points: int = 500,
    step: float | None = None,
    flips: int = 0,
    progress: Progress | None = None,
    start: PeriodicMotion | PeriodicBranch | Mapping[str, float] | None = None,
    resume: str | Path | None = None,
    **how: Any,
) -> PeriodicBranch:
    """Follow a motion that repeats over a parameter, through folds.

    Parameters
    ----------
    model : Model
        The mechanism.
    over : str
        The parameter.
    span : (float, float)
        Its first and last value, in its SI unit.
    points : int, optional
        Points of the branch, at most.
    step : float, optional
        Longest step, in parts of the span; 0.08 by default.
    flips : int, optional
        Doublings of the period that are followed, too, each a branch in `branches`.
    progress : callable, optional
        Called with (value reached, last value).
    start : PeriodicMotion, PeriodicBranch or mapping of str to float, optional
        As of `periodic`; a motion with its parameters, or a branch, which is gone on with.
    resume : path, optional
        A folder that keeps the points; the same question goes on there after the last of them.
    **how
        Further arguments of `periodic`.

    Returns
    -------
    PeriodicBranch
        Motions with their multipliers over the parameter; folds, flips and other specials. Ctrl-C keeps what is there.

    Raises
    ------
    NoPeriodicMotion, ArgumentError, ModelError, SchemeError, NoResult
        As `periodic` does for the first motion; later trouble ends the branch, told by `stopped`.

    References
    ----------
    H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems, in: P. H. Rabinowitz (ed.),
    Applications of Bifurcation Theory, Academic Press, 1977, 359-384.
    """
    if len(span) != 2:
        raise ArgumentError("span", f"is {span!r}", "give two different numbers, the first and the last value")
    low, high = (float(value) for value in span)
    if over not in [entry.name for entry in model.parameters]:
        raise ArgumentError(f"over {over!r}", f"is not a parameter of model {model.name}", "see model.parameters")
    if not np.isfinite([low, high]).all() or low == high:
        raise ArgumentError("span", f"is {span!r}", "give two different numbers, the first and the last value")
    if isinstance(start, PeriodicBranch):
        if not start.points:
            raise ArgumentError("start", "is a branch without points", "start a new branch")
        first, done = start.first, list(start.points)
    else:
        own = start.parameters if isinstance(start, PeriodicMotion) else {}
        parameters = {**own, **how.pop("parameters", {}), over: low}
        first, done = periodic(model, parameters=parameters, start=start, **how), []
    folder = None if resume is None else Path(resume)
    walk = _Walk(model, over, (low, high), first, LONGEST_ARC_STEP if step is None else float(step), folder)
    branch = walk.walked(done, points, progress, list(start.specials) if isinstance(start, PeriodicBranch) else [])
    return _with_doublings(branch, walk, flips, points, progress)


def _with_doublings(
    branch: PeriodicBranch, walk: _Walk, flips: int, points: int, progress: Progress | None
) -> PeriodicBranch:
    """And the branches of twice the period that leave it at its flips, `flips` generations of them."""
    if not flips or branch.stopped == INTERRUPTED_BRANCH:
        return branch
    found: list[PeriodicBranch] = []
    for k, special in enumerate(branch.specials):
        if special.kind == FLIP:
            first, start = doubled(branch.first, branch.over, special.point)
            own = walk.beside(first, k)
            piece = own.walked([own.anew(start)], points, progress, [])
            found.append(_with_doublings(piece, own, flips - 1, points, progress))
            if found[-1].stopped == INTERRUPTED_BRANCH:
                return replace(branch, branches=tuple(found), stopped=INTERRUPTED_BRANCH)
    return replace(branch, branches=tuple(found))


class _Walk:
    """Along a branch. Numbers of the curve: states over their scale, the period over the first where free, value."""

    def __init__(
        self, model: EmittedModel, over: str, span: tuple[float, float], first: PeriodicMotion, longest: float,
        folder: Path | None, name: str = "branch",
    ) -> None:  # fmt: skip
        self._model, self._over, self._span, self._first, self._longest = model, over, span, first, longest
        self._folder, self._name = folder, name
        self._width = abs(span[1] - span[0])
        self._doubled = first.doublings > 0
        if first.speed is not None and first.speed[0] == over:
            refuse_samples(first.inputs, f"changes with {over}")
        setting = Setting(
            model, first.scheme, first.steps // first.parts, first.parts, first.t0, first.options, first.inputs
        )
        given = {name: value for name, value in first.parameters.items() if name != over}
        self._map = period_map(setting, first.period, given, (over,))
        count = companion_steps(first.scheme, first.steps, first.parts, samples_in(first.period, first.inputs))
        self._other = self._map.with_steps(replace(setting, steps=count // first.parts))

    def beside(self, first: PeriodicMotion, k: int) -> _Walk:
        """Along another branch over the same values, from special k of this one."""
        own = f"{self._name}_{k}"
        return _Walk(self._model, self._over, self._span, first, self._longest, self._folder, own)

    @cached_property
    def _kept(self) -> KeptBranch | None:
        """Its file, if there is one."""
        if self._folder is None:
            return None
        first = self._first
        driven = bound(self._model, first.inputs).driven_by
        numbers = {name: float(value) for name, value in sorted(first.parameters.items())}
        asked = (self._model.digest, driven, self._over, self._span, first.scheme, dict(first.options), first.steps,
                 first.parts, first.t0, first.speed, first.free or float(first.period), numbers)  # fmt: skip
        return KeptBranch(self._folder / f"{self._name}.npz", repr(asked))

    def _read(self, done: list[Point], specials: list[Special]) -> bool:
        """Replace what is done by what was kept; is that complete?"""
        places, complete = self._kept.places() if self._kept is not None else ([], False)
        if any(not one.kind for one in places):
            done.clear()
        for one in places:
            point = self._place(one)
            if one.kind:
                specials.append(Special(one.kind, one.value, one.period, point.x[0], point))
            else:
                done.append(point)
        return complete

    def _place(self, kept: Place) -> Point:
        """A point that was kept, with what is known of it computed anew."""
        shot = self._map.shot(kept.x, kept.period, [kept.value])
        conditions = self._conditions(shot, kept.period, self._first.found.turn * 2**self._first.doublings)
        found = floquet(shot.monodromy, kept.period, conditions.free, self._first.floquet.margin)
        own = (kept.value, kept.period, kept.x, shot, kept.tangent, conditions, found, kept.begins)
        return self._judged(Point(*own))

    def walked(
        self, done: list[Point], most: int, progress: Progress | None, specials: list[Special]
    ) -> PeriodicBranch:
        """From the first motion, or from where a branch stopped, to the end of the range."""
        stopped = ""
        try:
            if not self._read(done, specials):
                if not done:
                    done.append(self._started())
                stopped = self._walked(done, most, progress, specials)
                self._keep(done, specials, not stopped)
        except KeyboardInterrupt:
            stopped = INTERRUPTED_BRANCH
        if not done:
            raise KeyboardInterrupt
        return PeriodicBranch(self._model, self._over, self._span, tuple(done), tuple(specials), self._first, stopped)

    def _keep(self, done: list[Point], specials: list[Special], complete: bool = False) -> None:
        if self._kept is not None:
            self._kept.keep(done, specials, complete)

    def _walked(self, done: list[Point], most: int, progress: Progress | None, specials: list[Special]) -> str:
        """Append points and what passes between them; why it ends before the range does, "" otherwise."""
        s = min(FIRST_ARC_STEP, self._longest)
        while True:
            at = done[-1]
            self._keep(done, specials)
            if progress is not None:
                progress(at.value, self._span[1])
            if len(done) >= most:
                return f"{most} points are made"
            found = self._next(at, s)
            if found is None:
                return f"no motion was found beyond {self._over} = {at.value:.6g}"
            point, s = found
            if self._returns(at, point):
                return ""
            point = self._judged(point)
            if not at.begins:
                specials += self._passed(at, point)
            if not self._inside(point.value):
                end = self._span[0] if self._before(point.value) else self._span[1]
                done.append(self._judged(self._at_end(at, point, end)))
                turned = end == self._span[0] and not self._doubled
                return f"the branch turns back and leaves the range at {self._over} = {end:g}" if turned else ""
            done.append(point)

    def _before(self, value: float) -> bool:
        """Is it beyond the first value of the range?"""
        return (value - self._span[0]) * (self._span[1] - self._span[0]) < 0

    def _returns(self, at: Point, point: Point) -> bool:
        """Does a branch of twice the period pass the one that it left, where its halves become the same?"""
        return self._doubled and not at.begins and half_apart(at) @ half_apart(point) < 0

    def anew(self, start: Point) -> Point:
        """A point of another branch as the first of this one: its own shot, going on along its tangent."""
        shot = self._map.shot(start.x, start.period, [start.value])
        conditions = self._conditions(shot, start.period, start.conditions.turn)
        found = floquet(shot.monodromy, start.period, conditions.free, self._first.floquet.margin)
        count = start.x.size
        tangent = np.zeros(count + self._first.free + 1)
        tangent[:count] = (start.tangent.reshape(start.x.shape) / conditions.scale).ravel()
        tangent /= np.sqrt(self._dot(tangent, tangent, count))
        return self._judged(replace(start, shot=shot, conditions=conditions, tangent=tangent, floquet=found))

    # ---- points -----------------------------------------------------------------------------------------------

    def _inside(self, value: float) -> bool:
        return min(self._span) <= value <= max(self._span)

    def _period(self, value: float, period: float) -> float:
        speed = self._first.speed
        return speed_period(speed[1], value) if speed is not None and speed[0] == self._over else period

    def _started(self) -> Point:
        first = self._first
        x, value = first.found.shot.x, self._span[0]
        shot = self._map.shot(x, first.period, [value])
        conditions = self._conditions(shot, first.period, first.found.turn)
        point = self._point(value, first.period, shot, conditions, None)
        if point.tangent[-1] * (self._span[1] - self._span[0]) < 0:
            point = replace(point, tangent=-point.tangent)
        return self._judged(point)

    def _judged(self, point: Point) -> Point:
        """With its error and its margin: across the branch, to first order, the same with other steps is so far off."""
        try:
            other = self._other.shot(point.x, point.period, [point.value])
        except SymgenError:
            return replace(point, error=np.inf)
        gaps = [point.conditions.residual(point.x, shot.ends) for shot in (other, point.shot)]
        inner = self._jacobian(point.shot, point.value, point.period, point.conditions)
        along = point.tangent / self._weights(point.x.size) ** 2
        off = np.linalg.lstsq(np.vstack([inner, along]), np.append(gaps[0] - gaps[1], 0.0), rcond=1e-14)[0]
        found = doubted(point.floquet, floquet(other.monodromy, point.period, point.conditions.free))
        places = off[: point.x.size].reshape(point.x.shape)[:, : len(self._map.states.places)]
        return replace(point, floquet=found, error=float(np.abs(places).max()))

    def _conditions(self, shot: Shot, period: float, turn: np.ndarray) -> Conditions:
        moved = np.abs(np.vstack([shot.x, shot.ends])).max(axis=0)
        return Conditions(self._map.states.sizes(moved, period), turn, self._first.free, shot.x[0], shot.rates[-1])

    def _jacobian(self, shot: Shot, value: float, period: float, conditions: Conditions) -> np.ndarray:
        """(m - 1, m) of the residual by the numbers of the curve."""
        inner = conditions.jacobian(shot)
        if conditions.free:
            inner[:, -1] *= self._first.period
        column = conditions.by_parameters(shot)[:, 0]
        speed = self._first.speed
        if speed is not None and speed[0] == self._over:
            rate = -period / value / len(shot.x)
            column = column + (shot.rates / conditions.scale * rate).ravel()
        return np.column_stack([inner, column * self._width])

    def _point(
        self, value: float, period: float, shot: Shot, conditions: Conditions, before: np.ndarray | None
    ) -> Point:
        """With the tangent, the null vector of the Jacobian, on as before."""
        jacobian = self._jacobian(shot, value, period, conditions) * self._weights(shot.x.size)
        tangent = np.linalg.svd(jacobian)[2][-1] * self._weights(shot.x.size)
        tangent /= np.linalg.norm(tangent / self._weights(shot.x.size))
        if before is not None and self._dot(tangent, before, shot.x.size) < 0:
            tangent = -tangent
        found = floquet(shot.monodromy, period, conditions.free, self._first.floquet.margin)
        return Point(value, period, shot.x, shot, tangent, conditions, found)

    def _weights(self, count: int) -> np.ndarray:
        """Lengths on the curve: all states together count as one number."""
        found = np.ones(count + self._first.free + 1)
        found[:count] = np.sqrt(count)
        return found

    def _dot(self, a: np.ndarray, b: np.ndarray, count: int) -> float:
        w = self._weights(count)
        return float((a / w) @ (b / w))

    def _corrected(self, at: Point, s: float, natural: float | None = None) -> tuple[Point, int] | None:
        """The point at a distance s along the tangent, and Newton's iterations; natural: at this value instead."""
        conditions = replace(at.conditions, guess=at.x[0], guess_rates=at.shot.rates[-1])
        count, w2 = at.x.size, self._weights(at.x.size) ** 2
        y = np.zeros(count + self._first.free + 1)
        row = at.tangent / w2
        if natural is None:
            y += s * at.tangent
        else:
            row, s = np.zeros_like(row), (natural - at.value) / self._width
            row[-1] = 1.0
            y += at.tangent * (s / at.tangent[-1])
        size = np.inf
        for iteration in range(ARC_NEWTON_ITERATIONS):
            x = at.x + y[:count].reshape(at.x.shape) * conditions.scale
            value = at.value + y[-1] * self._width
            period = at.period + y[-2] * self._first.period if self._first.free else self._period(value, at.period)
            try:
                shot = self._map.shot(x, period, [value])
            except SymgenError:
                return None
            residual = np.append(conditions.residual(x, shot.ends), row @ y - s)
            before, size = size, float(np.abs(residual).max())
            if size <= CLOSED_MOTION or (size <= SHOOTING_ROUNDING and size > before / 4):
                own = self._conditions(shot, period, conditions.turn)
                return self._point(value, period, shot, own, self._rescaled(at, own)), iteration
            if not np.isfinite(size) or size > 1e3:
                return None
            matrix = np.vstack([self._jacobian(shot, value, period, conditions), row])
            y = y - np.linalg.lstsq(matrix, residual, rcond=1e-14)[0]
        return None

    def _rescaled(self, at: Point, conditions: Conditions) -> np.ndarray:
        """The tangent of a point in other scales."""
        found = at.tangent.copy()
        count = at.x.size
        found[:count] = (found[:count].reshape(at.x.shape) * (at.conditions.scale / conditions.scale)).ravel()
        return found

    def _next(self, at: Point, s: float) -> tuple[Point, float] | None:
        """The next point and the step for the one after it; None where no step is short enough."""
        while s >= SHORTEST:
            found = self._corrected(at, s)
            if found is not None:
                point, iterations = found
                ahead = self._rescaled(at, point.conditions)
                count = at.x.size
                norm = np.sqrt(self._dot(ahead, ahead, count))
                if self._dot(ahead, point.tangent, count) / norm >= BENT:
                    longer = 1.5 if iterations <= QUICK else 0.7 if iterations > 5 else 1.0
                    return point, min(self._longest, s * longer)
            s /= 2
        return None

    def _at_end(self, at: Point, beyond: Point, end: float) -> Point:
        """At an end of the range, between two points."""
        found = self._corrected(at, 0.0, natural=end)
        return beyond if found is None else found[0]

    # ---- what passes between two points ------------------------------------------------------------------------

    def _passed(self, at: Point, point: Point) -> list[Special]:
        tests = [(FOLD, _turning), (FLIP, _flipping), (NEIMARK_SACKER, _turning_away)]
        count = at.x.size
        s = self._dot(at.tangent, self._moved(at, point), count)
        found = []
        for kind, test in tests:
            if test(at) * test(point) < 0:
                found.append(self._located(at, s, test, kind))
        if not any(one is not None and one.kind == FOLD for one in found) and _beyond_one(at) != _beyond_one(point):
            found.append(self._located(at, s, _branching, BRANCH))
        known = [one for one in found if one is not None]
        if not known and (at.floquet.stability == UNSTABLE) != (point.floquet.stability == UNSTABLE):
            known.append(Special(BETWEEN, (at.value + point.value) / 2, at.period, at.x[0], at))
        return [one for one in known if self._inside(one.value)]

    def _moved(self, at: Point, point: Point) -> np.ndarray:
        found = np.zeros(len(at.tangent))
        found[: at.x.size] = ((point.x - at.x) / at.conditions.scale).ravel()
        if self._first.free:
            found[-2] = (point.period - at.period) / self._first.period
        found[-1] = (point.value - at.value) / self._width
        return found

    def _located(self, at: Point, s: float, test: Callable[[Point], float], kind: str) -> Special | None:
        """By Brent's method between two points, s apart along the tangent of the first."""
        kept: dict[float, Point] = {0.0: at}

        def value(distance: float) -> float:
            found = self._corrected(at, distance)
            if found is None:
                raise NoPeriodicMotion(f"{kind} of model {self._model.name}", "cannot be located", "take shorter steps")
            kept[distance] = found[0]
            return test(found[0])

        try:
            root = float(brentq(lambda d: test(at) if d == 0.0 else value(d), 0.0, s, xtol=1e-9 * abs(s), rtol=1e-12))
        except (NoPeriodicMotion, ValueError):
            return None
        point = kept[min(kept, key=lambda distance: abs(distance - root))]
        if abs(test(point)) > PASSED:  # two real multipliers met, or parted
            return None
        return Special(kind, point.value, point.period, point.x[0], point)


def _turning(point: Point) -> float:
    """Changes its sign where the branch turns back."""
    return float(point.tangent[-1])


def _real(point: Point) -> np.ndarray:
    found = point.floquet.counted
    return np.asarray(found[np.abs(found.imag) <= REAL * np.maximum(np.abs(found), 1e-300)].real)


def _flipping(point: Point) -> float:
    """Changes its sign where a real multiplier passes -1."""
    return float(np.prod(np.sign(_real(point) + 1.0)) * np.abs(_real(point) + 1.0).min(initial=1.0))


def _branching(point: Point) -> float:
    """Changes its sign where a real multiplier passes +1."""
    return float(np.prod(np.sign(_real(point) - 1.0)) * np.abs(_real(point) - 1.0).min(initial=1.0))


def _beyond_one(point: Point) -> int:
    return int((_real(point) > 1.0).sum())


def _turning_away(point: Point) -> float:
    """Changes its sign where a pair of multipliers passes the unit circle."""
    found = point.floquet.counted
    pairs = np.abs(found[found.imag > REAL * np.maximum(np.abs(found), 1e-300)])
    return float(pairs.max(initial=0.0)) - 1.0


# Where a multiplier passes -1, a motion of twice the period branches off: its start and its direction.
#
# With the monodromy's eigenvector M v = -v, a disturbance v comes back as -v after a period T and as v after 2 T. So
# the motion of the period T, taken twice, is a point of the branch of motions of 2 T, and (v, -v) is a direction along
# which the branch leaves it; the parameter moves with the square of the distance.
# Source: Seydel, Practical Bifurcation and Stability Analysis, ch. 7.


def doubled(first: PeriodicMotion, over: str, at: Point) -> tuple[PeriodicMotion, Point]:
    """(the motion at a flip, taken twice; the point that its branch begins with).

    first: of the branch that has the flip. The point's tangent holds (v, -v) of the parts (2 K n,), not yet scaled.
    """
    turn, period = at.conditions.turn, 2 * at.period
    x = np.concatenate([at.x, at.x + turn])
    v = _disturbance(at)
    conditions = replace(at.conditions, turn=2 * turn)
    point = replace(at, period=period, x=x, conditions=conditions, tangent=np.concatenate([v, -v]).ravel(), begins=True)
    motion = replace(
        first,
        period=period,
        x=x[0],
        turns={name: 2 * k for name, k in first.turns.items()},
        steps=2 * first.steps,
        parts=2 * first.parts,
        parameters={**first.parameters, over: at.value},
        speed=None if first.speed is None else (first.speed[0], 2 * first.speed[1]),
        doublings=first.doublings + 1,
    )
    return motion, point


def half_apart(point: Point) -> np.ndarray:
    """(n,) how far a motion of twice a period is from having that period: between its halves, in parts of sizes."""
    half = len(point.x) // 2
    return np.asarray((point.x[half] - point.x[0] - point.conditions.turn / 2) / point.conditions.scale)


def _disturbance(at: Point) -> np.ndarray:
    """(K, n) of the parts, along the multiplier nearest to -1."""
    multipliers, vectors = np.linalg.eig(at.shot.monodromy)
    found = [vectors[:, int(np.abs(multipliers + 1.0).argmin())].real]
    for slope in at.shot.slopes[:-1]:
        found.append(slope @ found[-1])
    return np.array(found)
