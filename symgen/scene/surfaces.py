"""Tables of two values: surfaces over a grid, which expressions read by `table("name", x, y)`."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise
from typing import Literal

import casadi as ca
import numpy as np
from pydantic import model_validator

from runtime.contract.tape import Table, table_of
from symgen.scene.tables import along, kinks_of
from symgen.schema.fields import Number, StrictModel, refuse
from symgen.schema.texts import Text

MOST_VALUES = 40_000  # of z: a cell holds up to 16 numbers


class SurfaceTable(StrictModel):
    """z over a grid: z[k, l] at (x[k], y[l]); constant outside the grid, across its edge.

    interpolation: `linear`, straight along x and y in each cell; `cubic`, natural splines along both. A CSV (`file`,
    `columns = "grid"`) gives x, y and z when the scene is read: y in its first row, below it x and the z of each.
    """

    x: tuple[Number, ...]
    y: tuple[Number, ...]
    z: tuple[tuple[Number, ...], ...]
    interpolation: Literal["linear", "cubic"] = "linear"
    description: Text = ""

    @model_validator(mode="after")
    def _sound(self) -> SurfaceTable:
        for name, points in (("x", self.x), ("y", self.y)):
            if len(points) < 2:
                raise refuse(f"it has {len(points)} {name}", "give at least 2")
            for before, after in pairwise(points):
                if after <= before:
                    raise refuse(
                        f"its {name} do not rise from point to point: {after!r} comes after {before!r}",
                        "sort the points, and give each once",
                    )
        lengths = {len(row) for row in self.z}
        if len(self.z) != len(self.x) or lengths != {len(self.y)}:
            found = f"{len(self.z)} rows of {', '.join(map(str, sorted(lengths))) or 'no'}"
            wanted = f"{len(self.x)} rows (a row an x) of {len(self.y)} values (a value a y)"
            raise refuse(f"its z has {found} values", f"give {wanted}")
        if len(self.x) * len(self.y) > MOST_VALUES:
            raise refuse(f"it has {len(self.x) * len(self.y)} values", f"give at most {MOST_VALUES}")
        if not all(np.isfinite(table.powers).all() for table in self.tables("").values()):
            raise refuse("its surface is too steep for floating-point numbers", "give points further apart")
        return self

    @cached_property
    def _parts(self) -> tuple[Table, ...]:
        """Number of the cell and place in it from 0 to 1, of x and of y, and the coefficients of all cells."""
        axes = [part for points in (self.x, self.y) for part in _cells(np.array(points))]
        return (*axes, _entries(self._coefficients().ravel()))

    def _coefficients(self) -> np.ndarray:
        """(cells along x, cells along y, d + 1, d + 1) of u^a v^b, u and v the place in the cell."""
        z = np.array(self.z)
        by_y = along(self.interpolation, np.array(self.y), z)  # (b, x, cells along y)
        by_x = along(self.interpolation, np.array(self.x), np.moveaxis(by_y, 1, 2))  # (a, b, cells along y, along x)
        degree = len(by_x)
        u = np.diff(self.x)[None, :] ** np.arange(degree)[:, None]
        v = np.diff(self.y)[None, :] ** np.arange(degree)[:, None]
        scaled = by_x * u[:, None, None, :] * v[None, :, :, None]
        return np.ascontiguousarray(scaled.transpose(3, 2, 0, 1))

    def tables(self, name: str) -> dict[str, Table]:
        """The tables of one value that it is made of, by what emitted code calls them."""
        what = ("cell_x", "place_x", "cell_y", "place_y", "cells")
        return {f"{name}.{part}": table for part, table in zip(what, self._parts, strict=True)}

    def symbol(self, x: ca.SX, y: ca.SX) -> ca.SX:
        """z at (x, y): the polynomial of the cell, by Horner's rule; its coefficients are looked up by their number."""
        cell_x, place_x, cell_y, place_y, cells = (table.function() for table in self._parts)
        size = 2 if self.interpolation == "linear" else 4
        first = (cell_x(x) * (len(self.y) - 1) + cell_y(y)) * size**2
        u, v = place_x(x), place_y(y)
        z = ca.SX(0)
        for a in reversed(range(size)):
            row = ca.SX(0)
            for b in reversed(range(size)):
                row = row * v + cells(first + (size * a + b))
            z = z * u + row
        return z

    def kinks(self) -> tuple[tuple[float, ...], ...]:
        """Places along x and along y where its slope jumps."""
        return tuple(kinks_of(points, self.interpolation, "hold") for points in (self.x, self.y))


def _cells(points: np.ndarray) -> tuple[Table, Table]:
    """Number of the cell between points (n,), and the place in it from 0 to 1; both stay as they are outside."""
    last = len(points) - 2
    number = np.concatenate([[0], np.arange(last + 1), [last]])
    slope = np.concatenate([[0.0], 1 / np.diff(points), [0.0]])
    place = np.zeros(len(points) + 1)
    place[-1] = 1.0
    return table_of(points, number[None, :]), table_of(points, np.array([place, slope]))


def _entries(values: np.ndarray) -> Table:
    """values[k] at k = 0, 1, ..."""
    return table_of(np.arange(len(values), dtype=float), np.append(values[0], values)[None, :])
