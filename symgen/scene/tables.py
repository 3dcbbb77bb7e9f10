"""Tables: curves through points, which expressions read by `table("name", x)`."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict, model_validator

from symgen.schema.fields import Number, StrictModel, Text, refuse

MAX_POINTS = 1000  # each costs some ten operations in every evaluation


class CurveTable(StrictModel):
    """y over rising x: straight lines between the points, or the natural cubic spline through them.

    outside: `hold` stays at the first and last y, `extend` goes on straight. file: a CSV that gives x and y when the
    scene is read, from these two columns (counted from 0); the scene holds its numbers from then on.
    """

    x: tuple[Number, ...] = ()
    y: tuple[Number, ...] = ()
    interpolation: Literal["linear", "cubic"] = "linear"
    outside: Literal["hold", "extend"] = "hold"
    file: Text = ""
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
        if any(after <= before for before, after in zip(self.x, self.x[1:], strict=False)):
            raise refuse("its x do not rise from point to point", "sort the points, and give each x once")
        return self

    def value(self, x: float) -> float:
        """y at x as a number."""
        k = max(0, min(len(self.x) - 2, sum(known <= x for known in self.x) - 1))
        bends = self._bends() if self.interpolation == "cubic" else [0.0] * len(self.x)
        h, inside = self.x[k + 1] - self.x[k], min(max(x, self.x[0]), self.x[-1])
        a, b = (self.x[k + 1] - inside) / h, (inside - self.x[k]) / h
        y = a * self.y[k] + b * self.y[k + 1] + ((a**3 - a) * bends[k] + (b**3 - b) * bends[k + 1]) * h**2 / 6
        if self.outside == "hold" or inside == x:
            return y
        slope = (self.y[k + 1] - self.y[k]) / h + ((1 - 3 * a**2) * bends[k] + (3 * b**2 - 1) * bends[k + 1]) * h / 6
        return y + slope * (x - inside)

    def _bends(self) -> list[float]:
        """Second derivatives at the points, zero at both ends: the tridiagonal system of the natural spline."""
        n, x, y = len(self.x), self.x, self.y
        diagonal, right = [1.0] * n, [0.0] * n
        upper = [0.0] * n
        for k in range(1, n - 1):
            before, after = x[k] - x[k - 1], x[k + 1] - x[k]
            kink = 6 * ((y[k + 1] - y[k]) / after - (y[k] - y[k - 1]) / before)
            diagonal[k] = 2 * (before + after) - before * upper[k - 1]
            upper[k] = after / diagonal[k]
            right[k] = (kink - before * right[k - 1]) / diagonal[k]
        for k in range(n - 2, 0, -1):
            right[k] -= upper[k] * right[k + 1]
        return right
