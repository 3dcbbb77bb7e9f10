"""A branch of motions that repeat, over a parameter: its points, what passes between them, tables and pictures."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.files import replacing, write_text
from runtime.contract.model import EmittedModel
from runtime.orbits.controllers import remembering
from runtime.orbits.floquet import UNSTABLE, Floquet
from runtime.orbits.motion import PeriodicMotion
from runtime.orbits.periodic import periodic
from runtime.orbits.shooting import Conditions, Shot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from runtime.solutions.solution import Solution


@dataclass(frozen=True)
class Special:
    """A place of a branch where something passes the unit circle: kind, value of the parameter, period [s], state."""

    kind: str
    value: float
    period: float
    state: np.ndarray
    point: Point = field(repr=False)


@dataclass(frozen=True)
class Point:
    """A motion on the branch: value of the parameter, period [s], states (K, n), shot, tangent (m,), sizes (n,).

    begins: is it where a branch leaves another one? error: how far coordinates are off across the branch, in parts of
    their sizes, by the same with other steps; from that the margin of `floquet` follows, too.
    """

    value: float
    period: float
    x: np.ndarray
    shot: Shot
    tangent: np.ndarray
    conditions: Conditions
    floquet: Floquet
    begins: bool = False
    error: float = np.inf


@dataclass(frozen=True, repr=False)
class PeriodicBranch:
    """N motions that repeat, along a curve over the parameter `over`.

    points: in their order on the curve; specials: folds, flips and others between them; first: the motion that it began
    with; stopped: why it ended before the range did, "" otherwise; branches: of twice the period, from its flips.
    """

    model: EmittedModel
    over: str
    span: tuple[float, float]
    points: tuple[Point, ...] = field(repr=False)
    specials: tuple[Special, ...]
    first: PeriodicMotion = field(repr=False)
    stopped: str = ""
    branches: tuple[PeriodicBranch, ...] = ()

    @property
    def all(self) -> Iterator[PeriodicBranch]:
        """Itself, and all that branches off."""
        yield self
        for one in self.branches:
            yield from one.all

    @property
    def values(self) -> np.ndarray:
        """(N,) of the parameter."""
        return np.array([point.value for point in self.points])

    @property
    def periods(self) -> np.ndarray:
        """(N,) [s]."""
        return np.array([point.period for point in self.points])

    @property
    def errors(self) -> np.ndarray:
        """(N,) how far coordinates are off, across the branch, in parts of their sizes."""
        return np.array([point.error for point in self.points])

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
        return periodic(
            self.model,
            **length,
            parameters={**self.first.parameters, self.over: point.value},
            inputs=remembering(self.first.inputs, point.x[0]),
            start=self.first.states.by_name(point.x[0]),
            settle=None,
            scheme=self.first.scheme,
            options=self.first.options,
            steps=self.first.steps,
            parts=self.first.parts,
            t0=self.first.t0,
        )

    def period_of(self, k: int, **changes: Any) -> Solution:
        """One period of a motion as continuation found it; changes: further arguments of `simulate`."""
        point = self.points[k]
        found = replace(
            self.first,
            period=point.period,
            x=point.x[0],
            parameters={**self.first.parameters, self.over: point.value},
        )
        return found.simulate(1, **changes)

    def largest(self, output: str) -> np.ndarray:
        """(N,) the largest magnitude over a period of a coordinate, rate or measure. Raises ModelError."""
        runs = (self.period_of(k, outputs=[output], seen_every=0.0) for k in range(len(self.points)))
        return np.array([float(np.abs(run.outputs[output]).max()) for run in runs])

    def write_csv(self, path: str | Path, outputs: Sequence[str] = ()) -> None:
        """One row a motion: value, period, stability, largest multiplier, largest outputs, doublings, error.

        Those of branches follow. Raises OutputError.
        """
        rows = [",".join([self.over, "period [s]", "stability", "largest multiplier", *outputs, "doublings", "error"])]
        for one in self.all:
            columns = [one.largest(name) for name in outputs]
            for k, point in enumerate(one.points):
                size = point.floquet.largest
                numbers = [size, *(float(column[k]) for column in columns), one.first.doublings, point.error]
                rows.append(",".join([repr(point.value), repr(point.period), one.stability[k], *map(repr, numbers)]))
        write_text(Path(path), "\n".join(rows) + "\n")

    def picture(self, output: str, path: str | Path | None = None) -> Figure:
        """The largest magnitude of an output over the parameter: stable solid, unstable dashed, specials marked."""
        from runtime.views.plots import branch_picture

        every = list(self.all)
        heights = [one.largest(output) for one in every]
        unstable = [np.array([kind == UNSTABLE for kind in one.stability]) for one in every]
        curves = [
            (one.values, height, dashed, one.first.doublings)
            for one, height, dashed in zip(every, heights, unstable, strict=True)
        ]
        marked = [
            (special.kind, special.value, own[int(np.abs(one.values - special.value).argmin())])
            for one, own in zip(every, heights, strict=True)
            for special in one.specials
        ]
        entry = next(one for one in self.model.parameters if one.name == self.over)
        over, about = f"{self.over} [{entry.unit or '-'}]", self.model.title or self.model.name
        return branch_picture(about, over, output, curves, marked, path)

    def view(self, path: str | Path | None = None, outputs: Sequence[str] = ()) -> Any:
        """The picture as a page with a slider, which chooses the motion whose curves show; () stands for all q_i.

        Written to `path` (.html), else shown in the notebook or opened. Raises ModelError and OutputError.
        """
        from runtime.views.viewer.branch_page import show_branch

        return show_branch(self, path, list(outputs) or list(self.model.q_i))

    def __repr__(self) -> str:
        changes = ", ".join(f"{one.kind} at {one.value:.6g}" for one in self.specials) or "no change of stability"
        more = f"; {len(self.branches)} branches of twice the period" if self.branches else ""
        ended = f"; stopped: {self.stopped}" if self.stopped else ""
        return (
            f"<PeriodicBranch of {self.model.name}: {len(self.points)} motions over {self.over} from "
            f"{self.values[0]:g} to {self.values[-1]:g}, {changes}, errors up to {self.errors.max():.2g}{more}{ended}>"
        )


# A branch in a file: its points and what passes between them, so that a continuation goes on after the last of them.
#
# Only places are kept, (value, period, states, tangent); what is known of them is computed anew. The file is written
# behind every point, under another name first.


@dataclass(frozen=True)
class Place:
    """Of a point, or of a special one by its kind ("": none)."""

    kind: str
    value: float
    period: float
    x: np.ndarray
    tangent: np.ndarray
    begins: bool


class KeptBranch:
    """In `path`, of a question that is a text: what tells one branch from another."""

    def __init__(self, path: Path, question: str) -> None:
        self._path, self._question = path, question

    def places(self) -> tuple[list[Place], bool]:
        """(what is kept, is the branch complete?). Raises ArgumentError for another branch's file, or a broken one."""
        if not self._path.exists():
            return [], False
        try:
            with np.load(self._path, allow_pickle=False) as kept:
                question, complete = str(kept["question"]), bool(kept["complete"])
                columns = [kept[name] for name in ("kind", "value", "period", "x", "tangent", "begins")]
        except (OSError, ValueError, KeyError, zipfile.BadZipFile) as error:
            problem = f"{self._path} cannot be read: {error}"
            raise ArgumentError("resume", problem, "name another folder, or remove the file") from None
        if question != self._question:
            problem = f"{self._path} holds the branch of another model, range, period or scheme"
            raise ArgumentError("resume", problem, "repeat the same call, or name another folder")
        rows = zip(*columns, strict=True)
        return [Place(str(a), float(b), float(c), x, tangent, bool(d)) for a, b, c, x, tangent, d in rows], complete

    def keep(self, points: Sequence[Point], specials: Sequence[Special], complete: bool) -> None:
        """Write them. Raises OutputError."""
        kinds = [*("" for _ in points), *(one.kind for one in specials)]
        all_ = [*points, *(one.point for one in specials)]
        with replacing(self._path) as temporary, temporary.open("wb") as file:
            np.savez(
                file, question=np.array(self._question), complete=np.array(complete), kind=np.array(kinds),
                value=np.array([one.value for one in all_]), period=np.array([one.period for one in all_]),
                x=np.array([one.x for one in all_]), tangent=np.array([one.tangent for one in all_]),
                begins=np.array([one.begins for one in all_]),
            )  # fmt: skip
