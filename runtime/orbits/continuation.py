"""Motions that repeat, followed over a parameter through folds: pseudo-arclength continuation.

y = (x / scale, T, lambda / range) is a point of the curve r(y) = 0 of motions that repeat. From a point with the unit
tangent t the next one is predicted at y + s t and corrected by Newton's method on

    r(y) = 0,    t . (y - y_predicted) = 0

which is regular at folds, too. Steps s follow Newton's iterations and the curve's bend. What passes between two points
(a fold, a flip, a second frequency) is located by Brent's method over s.
Source: Seydel, Practical Bifurcation and Stability Analysis, ch. 4 and 7.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import brentq

from runtime.contract.errors import ArgumentError, SymgenError
from runtime.contract.files import replacing, write_text
from runtime.contract.model import Model
from runtime.orbits.floquet import FLIP, FOLD, NEIMARK_SACKER, REAL, UNSTABLE, Floquet, floquet
from runtime.orbits.motion import PeriodicMotion
from runtime.orbits.periodic import periodic, sizes, speed_period
from runtime.orbits.shooting import CLOSED, ROUNDED, Conditions, NoPeriodicMotion, PeriodMap, Setting, Shot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FIRST, LONGEST, SHORTEST = 0.02, 0.08, 1e-6  # steps along the curve, in parts of the range
ITERATIONS, QUICK = 8, 3  # of Newton's method: at most, and so few that steps grow
PASSED = 1e-4  # what is located is that near to zero; else it jumped there
BENT = 0.9  # cosine between two tangents, at least
BRANCH = "branch point"

COLOURS = {"fold": "#d1495b", "flip": "#2e7d32", "Neimark-Sacker": "#7b1fa2", "branch point": "#ef6c00"}

Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class Special:
    """A place of a branch where something passes the unit circle: kind, value of the parameter, period [s], state."""

    kind: str
    value: float
    period: float
    state: np.ndarray


@dataclass(frozen=True)
class Point:
    """A motion on the branch: value of the parameter, period [s], states (K, n), shot, tangent (m,), sizes (n,)."""

    value: float
    period: float
    x: np.ndarray
    shot: Shot
    tangent: np.ndarray
    conditions: Conditions
    floquet: Floquet


@dataclass(frozen=True, repr=False)
class PeriodicBranch:
    """N motions that repeat, along a curve over the parameter `over`.

    points: in their order on the curve; specials: folds, flips and others between them; first: the motion that it began
    with; stopped: why it ended before the range did, "" otherwise.
    """

    model: Model
    over: str
    span: tuple[float, float]
    points: tuple[Point, ...] = field(repr=False)
    specials: tuple[Special, ...]
    first: PeriodicMotion = field(repr=False)
    stopped: str = ""

    @property
    def values(self) -> np.ndarray:
        """(N,) of the parameter."""
        return np.array([point.value for point in self.points])

    @property
    def periods(self) -> np.ndarray:
        """(N,) [s]."""
        return np.array([point.period for point in self.points])

    @property
    def multipliers(self) -> np.ndarray:
        """(N, n) by falling size."""
        return np.array([point.floquet.multipliers for point in self.points])

    @property
    def stability(self) -> list[str]:
        """`stable`, `unstable` or `neutral`, of each."""
        return [point.floquet.stability for point in self.points]

    def motion(self, k: int) -> PeriodicMotion:
        """One of them, with its error measured. Raises NoPeriodicMotion."""
        point = self.points[k]
        if self.first.speed is not None:
            length: dict[str, Any] = {"speed": self.first.speed[0], "turns": self.first.speed[1]}
        else:
            length = {"period": "free", "guess": point.period} if self.first.free else {"period": point.period}
        names = list(self.first.state)
        return periodic(
            self.model,
            **length,
            parameters={**self.first.parameters, self.over: point.value},
            inputs=self.first.inputs,
            start=dict(zip(names, point.x[0].tolist(), strict=True)),
            settle=None,
            scheme=self.first.scheme,
            options=self.first.options,
            steps=self.first.steps,
            parts=self.first.parts,
            t0=self.first.t0,
        )

    def largest(self, output: str) -> np.ndarray:
        """(N,) the largest magnitude over a period of a coordinate, rate or measure. Raises ModelError."""
        found = np.zeros(len(self.points))
        names = list(self.first.state)
        for k, point in enumerate(self.points):
            moved = replace(
                self.first,
                period=point.period,
                state=dict(zip(names, point.x[0].tolist(), strict=True)),
                parameters={**self.first.parameters, self.over: point.value},
            )
            found[k] = np.abs(moved.simulate(1, outputs=[output], save_every=1).outputs[output]).max()
        return found

    def write_csv(self, path: str | Path, outputs: Sequence[str] = ()) -> None:
        """One row a motion: value, period, stability, largest multiplier, largest outputs. Raises OutputError."""
        columns = [self.largest(name) for name in outputs]
        rows = [",".join([self.over, "period [s]", "stability", "largest multiplier", *outputs])]
        for k, point in enumerate(self.points):
            numbers = [float(np.abs(point.floquet.counted).max(initial=0.0)), *(float(one[k]) for one in columns)]
            rows.append(",".join([repr(point.value), repr(point.period), self.stability[k], *map(repr, numbers)]))
        write_text(Path(path), "\n".join(rows) + "\n")

    def picture(self, output: str, path: str | Path | None = None) -> Figure:
        """The largest magnitude of an output over the parameter: stable solid, unstable dashed, specials marked."""
        return _picture(self, output, path)

    def __repr__(self) -> str:
        told = ", ".join(f"{one.kind} at {one.value:.6g}" for one in self.specials) or "no change of stability"
        ended = f"; stopped: {self.stopped}" if self.stopped else ""
        return (
            f"<PeriodicBranch of {self.model.name}: {len(self.points)} motions over {self.over} from "
            f"{self.values[0]:g} to {self.values[-1]:g}, {told}{ended}>"
        )


def periodic_over(
    model: Model,
    over: str,
    span: tuple[float, float],
    *,
    points: int = 500,
    step: float | None = None,
    progress: Progress | None = None,
    start: PeriodicMotion | PeriodicBranch | Mapping[str, float] | None = None,
    **how: Any,
) -> PeriodicBranch:
    """Motions that repeat over a parameter, from the first value of `span` to the second, through folds on the way.

    points: at most so many; step: longest, in parts of the span (0.08); progress(value reached, last value). start: as
    of `periodic`, or a branch, which is gone on with. how: further arguments of `periodic`. Ctrl-C keeps what is there.
    Raises what `periodic` does for the first motion; later trouble ends the branch and is told by `stopped`.
    """
    low, high = (float(value) for value in span)
    if over not in [entry.name for entry in model.parameters]:
        raise ArgumentError(f"over {over!r}", f"is no parameter of model {model.name}", "see model.parameters")
    if not np.isfinite([low, high]).all() or low == high:
        raise ArgumentError("span", f"is {span!r}", "give two different numbers, the first and the last value")
    if isinstance(start, PeriodicBranch):
        if not start.points:
            raise ArgumentError("start", "is a branch without points", "begin anew")
        first, done = start.first, list(start.points)
    else:
        parameters = {**how.pop("parameters", {}), over: low}
        first, done = periodic(model, parameters=parameters, start=start, **how), []
    walk = _Walk(model, over, (low, high), first, LONGEST if step is None else float(step))
    return walk.walked(done, points, progress, list(start.specials) if isinstance(start, PeriodicBranch) else [])


class _Walk:
    """Along a branch. Numbers of the curve: states over their scale, the period over the first where free, value."""

    def __init__(
        self, model: Model, over: str, span: tuple[float, float], first: PeriodicMotion, longest: float
    ) -> None:
        self._model, self._over, self._span, self._first, self._longest = model, over, span, first, longest
        self._width = abs(span[1] - span[0])
        setting = Setting(
            model, first.scheme, first.steps // first.parts, first.parts, first.t0, first.options, first.inputs
        )
        given = {name: value for name, value in first.parameters.items() if name != over}
        self._map = PeriodMap(setting, first.period, given, (over,))

    def walked(
        self, done: list[Point], most: int, progress: Progress | None, specials: list[Special]
    ) -> PeriodicBranch:
        """From the first motion, or from where a branch stopped, to the end of the range."""
        s, stopped = min(FIRST, self._longest), ""
        try:
            if not done:
                done.append(self._begun())
            while True:
                if progress is not None:
                    progress(done[-1].value, self._span[1])
                if len(done) >= most:
                    stopped = f"{most} points are made"
                    break
                found = self._next(done[-1], s)
                if found is None:
                    stopped = f"no motion was found beyond {self._over} = {done[-1].value:.6g}"
                    break
                point, s = found
                specials += self._passed(done[-1], point)
                if not self._inside(point.value):
                    if (point.value - self._span[1]) * (self._span[1] - self._span[0]) >= 0:
                        done.append(self._at_end(done[-1], point))
                    else:
                        stopped = f"the branch turns back and leaves the range at {self._over} = {self._span[0]:g}"
                    break
                done.append(point)
        except KeyboardInterrupt:
            stopped = "interrupted"
        if not done:
            raise KeyboardInterrupt
        return PeriodicBranch(self._model, self._over, self._span, tuple(done), tuple(specials), self._first, stopped)

    # ---- points -----------------------------------------------------------------------------------------------

    def _inside(self, value: float) -> bool:
        return min(self._span) <= value <= max(self._span)

    def _period(self, value: float, period: float) -> float:
        speed = self._first.speed
        return speed_period(speed[1], value) if speed is not None and speed[0] == self._over else period

    def _begun(self) -> Point:
        first = self._first
        x, value = first.found.shot.x, self._span[0]
        shot = self._map.shot(x, first.period, [value])
        conditions = self._conditions(shot, first.period, first.found.turn)
        point = self._point(value, first.period, shot, conditions, None)
        if point.tangent[-1] * (self._span[1] - self._span[0]) < 0:
            point = replace(point, tangent=-point.tangent)
        return point

    def _conditions(self, shot: Shot, period: float, turn: np.ndarray) -> Conditions:
        moved = np.abs(np.vstack([shot.x, shot.ends])).max(axis=0)
        return Conditions(sizes(moved, period), turn, self._first.free, shot.x[0], shot.rates[-1])

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
        found = floquet(shot.monodromy, period, conditions.free)
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
        for iteration in range(ITERATIONS):
            x = at.x + y[:count].reshape(at.x.shape) * conditions.scale
            value = at.value + y[-1] * self._width
            period = at.period + y[-2] * self._first.period if self._first.free else self._period(value, at.period)
            try:
                shot = self._map.shot(x, period, [value])
            except SymgenError:
                return None
            residual = np.append(conditions.residual(x, shot.ends), row @ y - s)
            before, size = size, float(np.abs(residual).max())
            if size <= CLOSED or (size <= ROUNDED and size > before / 4):
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

    def _at_end(self, at: Point, beyond: Point) -> Point:
        """At the last value of the range, between two points."""
        found = self._corrected(at, 0.0, natural=self._span[1])
        return beyond if found is None else found[0]

    # ---- what passes between two points ------------------------------------------------------------------------

    def _passed(self, at: Point, point: Point) -> list[Special]:
        tests = [(FOLD, _turning), (FLIP, _flipping), (NEIMARK_SACKER, _turning_away)]
        count = at.x.size
        s = self._dot(at.tangent, self._moved(at, point), count)
        found = []
        for kind, test in tests:
            if test(at) * test(point) < 0:
                special = self._located(at, s, test, kind)
                if special is not None and self._inside(special.value):
                    found.append(special)
        if not any(one.kind == FOLD for one in found) and _beyond_one(at) != _beyond_one(point):
            special = self._located(at, s, _branching, BRANCH)
            if special is not None and self._inside(special.value):
                found.append(special)
        return found

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
        return Special(kind, point.value, point.period, point.x[0])


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


def _picture(branch: PeriodicBranch, output: str, path: str | Path | None) -> Figure:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from runtime.results.notebook_figure import NotebookFigure

    figure = NotebookFigure(figsize=(8, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    values, heights = branch.values, branch.largest(output)
    unstable = np.array([one == UNSTABLE for one in branch.stability])
    first = 0
    for k in range(1, len(values) + 1):
        if k == len(values) or unstable[k] != unstable[first]:
            piece = slice(first, min(k + 1, len(values)))
            style: dict[str, Any] = {"linestyle": "--", "color": "#9aa5b1"} if unstable[first] else {"color": "#1f4e79"}
            ax.plot(values[piece], heights[piece], linewidth=1.8, **style)
            first = k
    for special in branch.specials:
        near = int(np.abs(np.hypot(values - special.value, 0.0)).argmin())
        ax.plot(special.value, heights[near], "o", color=COLOURS.get(special.kind, "#111827"), markersize=6)
        ax.annotate(special.kind, (special.value, heights[near]), textcoords="offset points", xytext=(6, 6), fontsize=8)
    entry = next(one for one in branch.model.parameters if one.name == branch.over)
    ax.set_xlabel(f"{branch.over} [{entry.unit or '-'}]")
    ax.set_ylabel(f"largest |{output}| of a period")
    ax.set_title(f"{branch.model.title or branch.model.name}: motions that repeat (dashed: unstable)", fontsize=10)
    ax.grid(alpha=0.25)
    if path is not None:
        with replacing(path) as temporary:
            figure.savefig(temporary, dpi=130)
    return figure
