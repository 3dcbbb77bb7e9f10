"""Measured outputs at the saved times of a run, checked, with their standard deviations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.gradients.differentiable_run import DifferentiableRun

SAME_TIME = 1e-6  # of a step


@dataclass(frozen=True)
class Measured:
    """values (N, n_y), weights (N, n_y) = 1 / deviation; known: were deviations given?"""

    values: np.ndarray
    weights: np.ndarray
    known: bool

    @property
    def count(self) -> int:
        """How many numbers were measured."""
        return int(np.count_nonzero(self.weights))

    def residuals(self, outputs: np.ndarray) -> np.ndarray:
        """(outputs - values) / deviation, flat."""
        return np.asarray(((outputs - self.values) * self.weights).ravel())


def measured(run: DifferentiableRun, data: Mapping[str, Any], deviation: float | Mapping[str, Any] | None) -> Measured:
    """Raises ArgumentError for data of another length, at other times, with NaN, or too few of them."""
    samples, names = len(run.t), run.outputs
    missing = [name for name in names if name not in data]
    if missing:
        raise ArgumentError(f"data of {missing[0]}", "are missing", f"give {', '.join(names)}")
    if "t" in data:
        times = _column(data["t"], "t", samples)
        off = float(np.abs(times - run.t).max())
        if not off <= SAME_TIME * run.plan.grid.dt_L:
            raise ArgumentError(
                "data of t",
                f"differ from the saved times by up to {off:.3g} s",
                f"every {run.plan.save_every} steps of {run.plan.grid.dt_L:g} s gives {run.t[0]:g} to {run.t[-1]:g} s: "
                "interpolate the data, or choose dt, save_every and t_end to fit them",
            )
    if deviation is None and len(names) > 1:
        raise ArgumentError("deviation", "is missing", "with more than one output say how exact each of them is")
    given = (
        deviation
        if isinstance(deviation, Mapping)
        else {name: 1.0 if deviation is None else deviation for name in names}
    )
    for name in names:
        if name not in given:
            raise ArgumentError(f"deviation of {name}", "is missing", f"give one for each of {', '.join(names)}")
    spread = np.column_stack(
        [_column(np.broadcast_to(given[name], samples), f"{name} (deviation)", samples) for name in names]
    )
    if not (spread > 0).all():
        raise ArgumentError("deviation", "must be positive", "let it be infinite where nothing was measured")
    values = np.column_stack([_column(data[name], name, samples) for name in names])
    there = np.isfinite(spread)
    for k, name in enumerate(names):
        bad = np.flatnonzero(there[:, k] & ~np.isfinite(values[:, k]))
        if len(bad):
            raise ArgumentError(
                f"data of {name}",
                f"is {values[bad[0], k]} at t = {run.t[bad[0]]:.6g} s",
                "leave it out by an infinite deviation there",
            )
    found = Measured(np.where(there, values, 0.0), np.where(there, 1.0 / spread, 0.0), deviation is not None)
    if found.count <= len(run.by):
        raise ArgumentError("data", f"are {found.count} numbers for {len(run.by)} unknowns", "measure more of them")
    return found


def _column(values: Any, name: str, samples: int) -> np.ndarray:
    try:
        column = np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise ArgumentError(f"data of {name}", f"are no numbers ({error})", "give an array of them") from error
    if column.shape != (samples,):
        raise ArgumentError(
            f"data of {name}", f"have shape {column.shape}", f"give one value for each of the {samples} saved times"
        )
    return column
