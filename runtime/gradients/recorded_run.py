"""A run that was made once, ready for its vector-Jacobian products."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from runtime.contract.errors import ArgumentError, NoResult


@dataclass(frozen=True, eq=False)
class RecordedRun:
    """A run with the values x, as `DifferentiableRun.record` gives it.

    Attributes
    ----------
    t : (N,) array
        Saved times [s].
    outputs, by : tuple of str
        Names of what comes out (n_y) and of what it is differentiated by (n).
    values : (N, n_y) array
        The outputs, SI units.
    mode : str
        How derivatives are found: ``forward``, the Jacobian is here; ``reverse``, the steps are on tapes.
    """

    t: np.ndarray
    outputs: tuple[str, ...]
    by: tuple[str, ...]
    values: np.ndarray = field(repr=False)
    mode: str
    back: Callable[[np.ndarray], np.ndarray] = field(repr=False)

    def pull_back(self, cotangents: np.ndarray) -> np.ndarray:
        """Multiply the Jacobian of the outputs by cotangents from the left, as often as it is asked for.

        Parameters
        ----------
        cotangents : (N, n_y) array
            The derivative of a number by each of the outputs.

        Returns
        -------
        (n,) array
            The derivative of that number by the values of `by`.

        Raises
        ------
        ArgumentError
            For cotangents of another shape or that are not finite.
        NoResult
            Where a derivative is not finite.
        """
        try:
            bars = np.array(cotangents, dtype=float)
        except (TypeError, ValueError, OverflowError, RecursionError):
            raise ArgumentError("cotangents", "is not an array of numbers", f"give {self.values.shape}") from None
        if bars.shape != self.values.shape:
            wanted = f"give {self.values.shape}: {len(self.t)} saved times, outputs {', '.join(self.outputs)}"
            raise ArgumentError("cotangents", f"has shape {bars.shape}", wanted)
        if not np.isfinite(bars).all():
            row, column = np.argwhere(~np.isfinite(bars))[0]
            where = f"is {bars[row, column]} for {self.outputs[column]} at t = {self.t[row]:.6g} s"
            raise ArgumentError("cotangents", where, "give finite numbers")
        with np.errstate(all="ignore"):  # what overflows is said by name
            found = self.back(bars)
        require_finite(found, self.by)
        return found


def require_finite(slopes: np.ndarray, by: tuple[str, ...]) -> None:
    """Raises NoResult for derivatives (..., n) that are not finite, naming what they are by."""
    bad = ~np.isfinite(slopes).all(axis=tuple(range(slopes.ndim - 1)))
    if bad.any():
        names = ", ".join(name for name, wrong in zip(by, bad, strict=True) if wrong)
        raise NoResult(
            f"derivative by {names}",
            "is not finite: the run passes a point where a function has none (a root at zero, a division)",
            "start slightly away from that point",
        )
