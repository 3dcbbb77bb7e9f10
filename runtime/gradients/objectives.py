"""Numbers made of outputs at saved times, with their derivatives by them.

An objective has `outputs`, names in order, and `weighed(t, y)`: its value, and its derivative by y (N, n_y), the values
of these outputs at the saved times t (N,). Ready-made ones are here; `Formula` makes one of any CasADi expression.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.results.peaks import sampled_peak

Weighed = tuple[float, np.ndarray]


class Objective(Protocol):
    """See the module's text."""

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names, in the order of the columns of y."""

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """(value, derivative by y)."""


@dataclass(frozen=True)
class End:
    """An output at the last saved time."""

    output: str

    @property
    def outputs(self) -> tuple[str, ...]:
        """The one."""
        return (self.output,)

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """y_N."""
        slope = np.zeros_like(y)
        slope[-1, 0] = 1.0
        return float(y[-1, 0]), slope


@dataclass(frozen=True)
class Integral:
    """The integral over time of an output, or of its square, by the trapezoidal rule over the saved times."""

    output: str
    squared: bool = False

    @property
    def outputs(self) -> tuple[str, ...]:
        """The one."""
        return (self.output,)

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """sum of w_k y_k or of w_k y_k^2."""
        weights = trapezoid_weights(t)[:, None]
        if not isinstance(self.squared, bool):
            raise ArgumentError("squared", f"is a {type(self.squared).__name__}", "give True or False")
        if self.squared:
            return float(np.sum(weights * y**2)), 2 * weights * y
        return float(np.sum(weights * y)), weights.copy()


@dataclass(frozen=True)
class SquaredError:
    """The sum of squares of (output - data) / deviation over the saved times.

    data (N,); deviation: one number or (N,), infinite where nothing was measured.
    """

    output: str
    data: np.ndarray = field(repr=False)
    deviation: float | np.ndarray = 1.0

    @property
    def outputs(self) -> tuple[str, ...]:
        """The one."""
        return (self.output,)

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """sum of r_k^2. Raises ArgumentError for data of another length, and for NaN."""
        data = _numbers(self.data, f"data of {self.output}")
        if data.shape != t.shape:
            raise ArgumentError(
                f"data of {self.output}",
                f"has shape {data.shape}",
                f"give one value for each of the {len(t)} saved times",
            )
        deviation = _numbers(self.deviation, f"deviation of {self.output}")
        if deviation.shape not in ((), t.shape) or not np.all(deviation > 0):
            raise ArgumentError(
                f"deviation of {self.output}",
                "is not a positive number, or one for each saved time",
                "set it to infinity where nothing was measured",
            )
        weights = 1.0 / np.broadcast_to(deviation, t.shape)
        bad = np.flatnonzero((weights > 0) & ~np.isfinite(data))
        if len(bad):
            raise ArgumentError(
                f"data of {self.output}",
                f"is {data[bad[0]]} at t = {t[bad[0]]:.6g} s",
                "set the deviation to infinity there",
            )
        residual = np.where(weights > 0, y[:, 0] - data, 0.0) * weights
        return float(residual @ residual), (2 * residual * weights)[:, None]


@dataclass(frozen=True)
class Largest:
    """The largest value of an output, or of its magnitude, between saved times too.

    The parabola through the largest saved value and its two neighbours has it, so that value and derivative are those
    of the curve and not of one sample, which is beside the peak by up to half the time between them; see
    `runtime.results.peaks`. Where the curve is not smooth, and at its ends, it is the sample. Where two peaks are equal
    it has no derivative, and that of the first is given.
    """

    output: str
    magnitude: bool = True

    @property
    def outputs(self) -> tuple[str, ...]:
        """The one."""
        return (self.output,)

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """max of |y(t)| or y(t)."""
        if not isinstance(self.magnitude, bool):
            raise ArgumentError("magnitude", f"is a {type(self.magnitude).__name__}", "give True or False")
        column = y[:, 0]
        sign = -1.0 if self.magnitude and abs(column.min()) > column.max() else 1.0
        peak, slope = sampled_peak(t, sign * column), np.zeros_like(y)
        slope[peak.samples, 0] = sign * peak.weights
        return peak.value, slope


@dataclass(frozen=True)
class Formula:
    """Any function of the outputs: `build(t, y)` makes a CasADi expression of t (N,) and of columns y[name] (N,)."""

    outputs: tuple[str, ...]
    build: Callable[[ca.SX, Mapping[str, ca.SX]], ca.SX]
    _functions: dict[int, ca.Function] = field(default_factory=dict, repr=False, compare=False)

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """Value and gradient by CasADi."""
        value, slope = self._function(len(t))(t, y)
        return float(value), np.asarray(slope)

    def _function(self, samples: int) -> ca.Function:
        if samples not in self._functions:
            t, y = ca.SX.sym("t", samples), ca.SX.sym("y", samples, len(self.outputs))
            columns = {name: y[:, k] for k, name in enumerate(self.outputs)}
            if not callable(self.build):
                raise ArgumentError("build", f"is a {type(self.build).__name__}", "give a function of t and y")
            try:
                value: Any = self.build(t, columns)
            except KeyError as missing:
                listed = f"name it among the outputs, which are {', '.join(self.outputs)}"
                raise ArgumentError("objective", f"reads the column {missing} that it has not", listed) from None
            if not isinstance(value, ca.SX | int | float) or ca.SX(value).numel() != 1:
                raise ArgumentError("objective", f"gives {value!r}", "it must be one number made of t and y by CasADi")
            slope = ca.densify(ca.reshape(ca.gradient(ca.SX(value), ca.vec(y)), samples, len(self.outputs)))
            self._functions[samples] = ca.Function("objective", [t, y], [ca.SX(value), slope])
        return self._functions[samples]


def _numbers(values: Any, item: str) -> np.ndarray:
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError, OverflowError, RecursionError):
        raise ArgumentError(item, "are not numbers", "give an array of them") from None


def trapezoid_weights(t: np.ndarray) -> np.ndarray:
    """(N,) [s]: w with w @ y the integral of y over the times t."""
    h = np.diff(t)
    return np.concatenate([h, [0.0]]) / 2 + np.concatenate([[0.0], h]) / 2
