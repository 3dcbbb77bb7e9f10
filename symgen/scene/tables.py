"""Tables: curves through points, which expressions read by `table("name", x)`.

CSV files that tables of a scene name: read with the scene, which then holds their numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal

import casadi as ca
import numpy as np
from pydantic import Field, Strict, model_validator

from runtime.contract.tape import Table, table_of
from symgen.scene.toml_io import named_file, text_of
from symgen.schema.errors import SceneError, show
from symgen.schema.fields import Number, StrictModel, refuse
from symgen.schema.texts import Line, Text

MAX_POINTS = 200_000  # each is some hundred bytes of text; an evaluation costs the same whatever their number


class CurveTable(StrictModel):
    """y over rising x: straight lines between the points, or a curve of cubic pieces through them.

    interpolation: `linear`; `cubic`, the natural spline; `monotone`, Fritsch and Carlson's pieces, which overshoot
    nowhere (PCHIP). outside: `hold` stays at the first and last y, `extend` goes on straight. file: a CSV that gives x
    and y when the scene is read, from these two columns (counted from 0); the scene holds its numbers from then on.
    integrated: the table is the first or second integral of that curve over x, exactly: a motion by its velocity or its
    acceleration. It is zero at the first x, with zero slope where it is the second one.
    """

    integrated: Literal[0, 1, 2] = 0
    x: tuple[Number, ...] = ()
    y: tuple[Number, ...] = ()
    interpolation: Literal["linear", "cubic", "monotone"] = "linear"
    outside: Literal["hold", "extend"] = "hold"
    file: Line = ""
    columns: tuple[Annotated[int, Strict(), Field(ge=0, le=1000)], Annotated[int, Strict(), Field(ge=0, le=1000)]] = (
        0,
        1,
    )
    description: Text = ""

    @model_validator(mode="after")
    def _sound(self) -> CurveTable:
        if self.file:
            raise refuse(f"the file '{self.file}' was not read", "give x and y here, or read the scene from its file")
        if len(self.x) != len(self.y) or not 2 <= len(self.x) <= MAX_POINTS:
            raise refuse(
                f"it has {len(self.x)} x and {len(self.y)} y", f"give as many of both, from 2 to {MAX_POINTS} points"
            )
        for k, (before, after) in enumerate(pairwise(self.x), 1):
            if after <= before:
                raise refuse(
                    f"its x do not rise from point to point: {after!r} (point {k}) comes after {before!r}",
                    "sort the points, and give each x once",
                )
        if not np.isfinite(self.curve.powers).all():
            raise refuse("its curve is too steep for floating-point numbers", "give points further apart in x")
        return self

    @cached_property
    def curve(self) -> Table:
        """What it is between and outside its points."""
        x, y = np.array(self.x), np.array(self.y)
        with np.errstate(all="ignore"):
            h, pieces = np.diff(x), along(self.interpolation, x, y)
            ends = np.zeros((2, len(pieces)))
            ends[:, 0] = y[0], y[-1]
            if self.outside == "extend":
                bend = 2 * pieces[2, -1] + 3 * h[-1] * pieces[3, -1] if len(pieces) > 2 else 0.0
                ends[:, 1] = pieces[1, 0], pieces[1, -1] + h[-1] * bend
            powers = np.column_stack([ends[0], pieces, ends[1]])
            for _ in range(self.integrated):
                powers = _integral(h, powers)
        return table_of(x, powers)

    def tables(self, name: str) -> dict[str, Table]:
        """What emitted code calls it."""
        return {name: self.curve}

    def symbol(self, x: ca.SX) -> ca.SX:
        """y as an expression of x."""
        return self.curve.function()(x)

    def kinks(self) -> tuple[tuple[float, ...], ...]:
        """Places along x where its slope jumps."""
        return (kinks_of(self.x, self.interpolation, self.outside),)


MOST_POINTS = 100  # a table with more is taken to be smooth


def kinks_of(x: tuple[float, ...], interpolation: str, outside: str) -> tuple[float, ...]:
    """All points of lines and of monotone pieces; of a natural spline the ends, if it is held there."""
    if interpolation == "cubic":
        return () if outside == "extend" else (x[0], x[-1])
    return x if len(x) <= MOST_POINTS else ()


def along(interpolation: str, x: np.ndarray, values: np.ndarray) -> np.ndarray:
    """(degree + 1, ..., n - 1) powers of x - x_k of the pieces between values (..., n) at x (n,)."""
    if interpolation == "linear":
        return np.stack([values[..., :-1], np.diff(values) / np.diff(x)])
    from scipy.interpolate import CubicSpline, PchipInterpolator  # when they are needed: importing them takes long

    cubic = interpolation == "cubic"
    curve = CubicSpline(x, values, axis=-1, bc_type="natural") if cubic else PchipInterpolator(x, values, axis=-1)
    return np.asarray(np.moveaxis(curve.c, 1, -1)[::-1])


def _integral(h: np.ndarray, powers: np.ndarray) -> np.ndarray:
    """(degree + 2, n + 1) powers of the integral over x, zero at the first point; h (n - 1,): between points."""
    found = np.vstack([np.zeros(powers.shape[1]), powers / np.arange(1, len(powers) + 1)[:, None]])
    gained = (found[1:, 1:-1] * h ** np.arange(1, len(found))[:, None]).sum(axis=0)
    found[0, 2:] = np.cumsum(gained)
    return found


def trapezoid(distance: float, speed: float, acceleration: float) -> dict[str, Any]:
    """A motion over a distance that speeds up, runs and slows down evenly, as the fields of a table of its velocity.

    Never faster than `speed` nor steeper than `acceleration`; in SI units. Raises ValueError for limits not positive.
    """
    if min(speed, acceleration) <= 0 or distance == 0:
        raise ValueError("give a distance that is not zero, and a speed and an acceleration above zero")
    way, sign = abs(distance), math.copysign(1.0, distance)
    v = min(speed, math.sqrt(way * acceleration))
    rise, run = v / acceleration, way / v - v / acceleration
    return _profile([(rise, v), (run, v), (rise, 0.0)], sign, integrated=1)


def s_curve(distance: float, speed: float, acceleration: float, jerk: float) -> dict[str, Any]:
    """The same with a limited jerk, as the fields of a table of the acceleration."""
    if min(speed, acceleration, jerk) <= 0 or distance == 0:
        raise ValueError("give a distance that is not zero, and limits above zero")
    way, sign = abs(distance), math.copysign(1.0, distance)
    v, a = speed, min(acceleration, math.sqrt(speed * jerk))
    if v * (v / a + a / jerk) > way:  # it never runs evenly
        a = acceleration
        v = a / 2 * (math.sqrt((a / jerk) ** 2 + 4 * way / a) - a / jerk)
        if v * jerk < a * a:
            bend = (way / (2 * jerk)) ** (1 / 3)
            v, a = jerk * bend**2, jerk * bend
    bend, even = a / jerk, v / a - a / jerk
    run = way / v - v / a - bend
    half = [(bend, a), (even, a), (bend, 0.0)]
    return _profile([*half, (run, 0.0), *((time, -value) for time, value in half)], sign, integrated=2)


def _profile(parts: Sequence[tuple[float, float]], sign: float, integrated: int) -> dict[str, Any]:
    """Points of (duration, value at its end) one after the other, without parts that take no time."""
    x, y = [0.0], [0.0]
    for time, value in parts:
        if time > 1e-12 * (x[-1] + sum(one for one, _ in parts)):
            x.append(x[-1] + time)
            y.append(sign * value)
    return {"x": x, "y": y, "integrated": integrated}


def with_tables(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Plain scene data with ``file`` and ``columns`` of its tables replaced by x and y.

    Raises SceneError for a path that leads out of the folder and for a file that cannot be read.
    """
    tables = data.get("tables")
    if not isinstance(tables, dict):
        return data
    return {**data, "tables": {name: _read(f"tables.{name}", entry, folder) for name, entry in tables.items()}}


def _read(item: str, entry: Any, folder: Path) -> Any:
    if not isinstance(entry, dict) or "file" not in entry:
        return entry
    found = named_file(entry["file"], folder, f"{item}.file", "table")
    kept = {key: value for key, value in entry.items() if key not in ("file", "columns")}
    return {**kept, **read_points(found, entry.get("columns", (0, 1)), item)}


def read_points(path: str | Path, columns: Sequence[int] | Literal["grid"], item: str) -> dict[str, Any]:
    """{x, y} from two columns (counted from 0) of a CSV file, {x, y, z} from a "grid". Raises SceneError."""
    rows = number_rows(
        f"{item}.file", text_of(path, f"{item}.file '{path}'", "a CSV file"), names_above=columns != "grid"
    )
    if columns == "grid":
        if len(rows) < 3 or {len(row) for row in rows[1:]} not in ({len(rows[0])}, {len(rows[0]) + 1}):
            remedy = "put y into the first row, and below it rows of x and the z of each y"
            raise SceneError(f"{item}.file", f"'{path}' is not a grid", remedy)
        y = rows[0][len(rows[0]) - len(rows[1]) + 1 :]  # a number in the corner is left out
        return {"x": [row[0] for row in rows[1:]], "y": y, "z": [row[1:] for row in rows[1:]]}
    try:
        x, y = ([row[column] for row in rows] for column in columns)
    except (IndexError, TypeError, ValueError):
        raise SceneError(
            f"{item}.columns", f"'{path}' has no columns {show(columns)}", 'count columns from 0, or write "grid"'
        ) from None
    return {"x": x, "y": y}


def number_rows(item: str, text: str, names_above: bool) -> list[list[float]]:
    """Rows of numbers between commas, semicolons or blanks; # begins a comment, names above may be left out."""
    found: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition("#")[0].replace(";", ",").replace("\t", ",").split(",")
        words = [word for part in words for word in part.split()]
        if not words:
            continue
        try:
            values = [float(word) for word in words]
        except ValueError:
            if found or not names_above:
                raise SceneError(item, f"line {number} is not a row of numbers", "correct that line") from None
            continue
        if not all(map(math.isfinite, values)):
            raise SceneError(item, f"line {number} holds a number that is not finite", "correct that line")
        found.append(values)
    return found
