"""Parameter identification: parameters and initial values from measured outputs, by nonlinear least squares.

The derivatives are those of the run; of the Hessian of the sum of squares the part J^T J is taken (Gauss-Newton), in a
trust region. Its inverse is the covariance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from scipy import stats
from scipy.optimize import least_squares

from runtime.contract.arguments import BY_NAME, NAMES, arguments
from runtime.contract.errors import ArgumentError, NoResult, is_finite_number
from runtime.contract.model import EmittedModel
from runtime.gradients.differentiable_run import DifferentiableRun, OutputJacobian

FIT_TOLERANCE = 1e-10
UNTOLD = 1e-9  # of the largest singular value of the scaled Jacobian: a direction that the data do not see
FAILED_RESIDUAL = 1e3  # times the largest residual of the guess: what a run that fails on the way counts as

Bounds = Mapping[str, tuple[float, float]]


@arguments(data=BY_NAME, parameters=NAMES, bounds=BY_NAME, guess=BY_NAME, fixed=BY_NAME)
def fit(
    model: EmittedModel,
    data: Mapping[str, Any],
    parameters: Sequence[str],
    *,
    bounds: Bounds | None = None,
    guess: Mapping[str, float] | None = None,
    fixed: Mapping[str, float] | None = None,
    deviation: float | Mapping[str, Any] | None = None,
    **run: Any,
) -> Fit:
    """Fit parameters, and coordinates and rates at the start, to measured outputs.

    Parameters
    ----------
    model : Model
        The mechanism.
    data : mapping of str to array_like (N,)
        Values of outputs at the saved times, in SI units; with "t" (N,) [s] if it is to be compared.
    parameters : sequence of str
        What is fitted: parameters, coordinates, rates (`_dot`).
    bounds : mapping of str to (float, float), optional
        Lowest and highest values; without them only the signs that the model asks for.
    guess : mapping of str to float, optional
        Where the search begins; else the model's values.
    fixed : mapping of str to float, optional
        Values of other parameters.
    deviation : float or mapping, optional
        Standard deviation of the data: one number, or by output a number or (N,), infinite where there is none. Without
        it that of the one output is estimated from what is left over.
    **run
        Further arguments of `DifferentiableRun`, those of `simulate`.

    Returns
    -------
    Fit
        Values, standard errors, correlation, and the fitted outputs.

    Raises
    ------
    ArgumentError
        For data or bounds that cannot be used.
    NoResult
        Where the data do not determine the parameters.
    ModelError, SchemeError, InitialStateError
        As of `DifferentiableRun`.

    Notes
    -----
    minimise sum over outputs and saved times of ((output - data) / deviation)^2, with exact derivatives of the run.

    References
    ----------
    G. A. F. Seber and C. J. Wild, Nonlinear Regression, Wiley, 1989.
    """
    outputs = [name for name in data if name != "t"]
    prepared = DifferentiableRun(model, outputs, parameters, parameters=fixed, **run)
    return fit_prepared(prepared, data, bounds=bounds, guess=guess, deviation=deviation)


class Predicts(Protocol):
    """What is fitted: outputs (N, n_y) at times t (N,) [s], and their slopes by x (n,)."""

    @property
    def model(self) -> EmittedModel:
        """The mechanism."""

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of what was measured."""

    @property
    def by(self) -> tuple[str, ...]:
        """Names of what is fitted."""

    @property
    def x0(self) -> np.ndarray:
        """Where the search begins, if nothing else is said."""

    @property
    def t(self) -> np.ndarray:
        """Times of the outputs [s]."""

    def jacobian(self, x: Any) -> OutputJacobian:
        """Outputs and slopes there. Raises NoResult."""


def fit_prepared(
    run: Predicts,
    data: Mapping[str, Any],
    *,
    bounds: Bounds | None = None,
    guess: Mapping[str, float] | None = None,
    deviation: float | Mapping[str, Any] | None = None,
) -> Fit:
    """`fit` on a run prepared once, for who fits again and again: data of its outputs, unknown what it takes."""
    measurements = measured(run, data, deviation)
    begin = dict(guess or {})
    wrong = [name for name in begin if name not in run.by]
    if wrong:
        raise ArgumentError(f"guess of {wrong[0]}", "is not fitted", f"guess only {', '.join(run.by)}")
    x = np.array([begin.get(name, value) for name, value in zip(run.by, run.x0, strict=True)], dtype=float)
    search = _Search(run, measurements, np.where(x == 0, 1.0, np.abs(x)))
    low, high = _limits(run.model, run.by, bounds or {}, x)
    found = least_squares(
        search.residuals,
        x / search.scale,
        search.jacobian,
        (low / search.scale, high / search.scale),
        xtol=FIT_TOLERANCE,
        ftol=FIT_TOLERANCE,
        gtol=FIT_TOLERANCE,
    )
    at = run.jacobian(found.x * search.scale)
    freedom = measurements.count - len(x)
    covariance = _covariance(run.by, search.weighted(at)) * np.outer(search.scale, search.scale)
    if not measurements.known:
        covariance *= float(np.sum(found.fun**2)) / freedom
    return Fit(
        names=run.by,
        x=found.x * search.scale,
        covariance=covariance,
        freedom=np.inf if measurements.known else freedom,
        t=run.t,
        data={name: measurements.values[:, k] for k, name in enumerate(run.outputs)},
        fitted={name: at.values[:, k] for k, name in enumerate(run.outputs)},
        evaluations=int(found.nfev),
        converged=bool(found.status > 0),
        message=str(found.message),
    )


class _Search:
    """Residuals and their Jacobian by x over its scale; each run is made once, with its derivatives."""

    def __init__(self, run: Predicts, measurements: Measured, scale: np.ndarray) -> None:
        self._run, self._measurements, self.scale = run, measurements, scale
        self._at: tuple[np.ndarray, OutputJacobian | None] | None = None
        self._far = 0.0

    def residuals(self, x: np.ndarray) -> np.ndarray:
        """(outputs - data) / deviation, flat."""
        at = self._evaluated(x)
        if at is None:
            return np.full(self._measurements.values.size, self._far)
        found = self._measurements.residuals(at.values)
        self._far = self._far or FAILED_RESIDUAL * max(float(np.abs(found).max()), 1e-300)
        return found

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        """Of the residuals."""
        at = self._evaluated(x)
        return np.zeros((self._measurements.values.size, len(x))) if at is None else self.weighted(at)

    def weighted(self, at: OutputJacobian) -> np.ndarray:
        """(residuals, n)."""
        rows = at.derivatives * self._measurements.weights[:, :, None]
        return np.asarray(rows.reshape(-1, len(self.scale)) * self.scale)

    def _evaluated(self, x: np.ndarray) -> OutputJacobian | None:
        """None for a run that fails, unless it is the first one."""
        if self._at is None or not np.array_equal(self._at[0], x):
            try:
                self._at = (x.copy(), self._run.jacobian(x * self.scale))
            except NoResult:
                if self._at is None:
                    raise
                self._at = (x.copy(), None)
        return self._at[1]


def _covariance(names: Sequence[str], jacobian: np.ndarray) -> np.ndarray:
    """(J^T J)^-1. Raises NoResult for a direction that no residual depends on."""
    _, values, directions = np.linalg.svd(jacobian, full_matrices=False)
    if values[-1] <= UNTOLD * values[0]:
        blind = np.abs(directions[-1])
        untold = ", ".join(name for name, share in zip(names, blind, strict=True) if share > 0.1 * blind.max())
        raise NoResult(
            f"fit of {untold}",
            "the data do not determine " + ("it" if "," not in untold else "them apart"),
            "measure another output, or another motion, or leave one of them fixed",
        )
    return np.asarray((directions.T / values**2) @ directions)


def _limits(model: EmittedModel, names: Sequence[str], bounds: Bounds, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Raises ArgumentError for bounds that are none, or that the guess lies outside of."""
    signs = {parameter.name: parameter.bound for parameter in model.parameters}
    wrong = [name for name in bounds if name not in names]
    if wrong:
        raise ArgumentError(f"bounds of {wrong[0]}", "belong to no fitted parameter", f"bound {', '.join(names)}")
    low, high = np.full(len(x), -np.inf), np.full(len(x), np.inf)
    for k, name in enumerate(names):
        if signs.get(name, "any") != "any":
            low[k] = 0.0 if signs[name] == "not negative" else 1e-12 * abs(x[k])
        if name in bounds:
            low[k], high[k] = _pair(name, bounds[name])
        if not low[k] < high[k] or not low[k] <= x[k] <= high[k]:
            raise ArgumentError(
                f"bounds of {name}",
                f"are {low[k]:g} and {high[k]:g}, the guess {x[k]:g}",
                "let the guess lie between them",
            )
    return low, high


def _pair(name: str, given: Any) -> tuple[float, float]:
    """Two numbers. Raises ArgumentError for anything else."""
    try:
        low, high = (float(value) for value in given)
    except (TypeError, ValueError):
        raise ArgumentError(f"bounds of {name}", f"are {given!r}", "give (lowest, highest)") from None
    return low, high


# What a fit found: values, how sure they are, and what is left over.

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Fit:
    """x (n,) of the names with their covariance (n, n), in SI units; freedom: of the estimated deviation (inf: given).

    t (N,) [s], data and fitted {output: (N,)}; evaluations: runs of the search; converged, message: how it ended. The
    covariance is that of the linear theory: right where the residuals are independent and the model is nearly linear
    over it.
    """

    names: tuple[str, ...]
    x: np.ndarray
    covariance: np.ndarray
    freedom: float
    t: np.ndarray
    data: Mapping[str, np.ndarray]
    fitted: Mapping[str, np.ndarray]
    evaluations: int
    converged: bool
    message: str

    def __getitem__(self, name: str) -> float:
        """The value of one. Raises ArgumentError for another name."""
        return float(self.x[self._index(name)])

    @property
    def residuals(self) -> dict[str, np.ndarray]:
        """fitted - data of every output, (N,)."""
        return {name: self.fitted[name] - values for name, values in self.data.items()}

    @property
    def standard_errors(self) -> np.ndarray:
        """(n,) square roots of the variances."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def correlation(self) -> np.ndarray:
        """(n, n): near 1 or -1 where the data hardly tell two apart."""
        return np.asarray(self.covariance / np.outer(self.standard_errors, self.standard_errors))

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """In which the truth lies with this confidence, whatever the others are. Raises ArgumentError."""
        k = self._index(name)
        half = float(stats.t.ppf(0.5 + _share(confidence) / 2, self.freedom)) * self.standard_errors[k]
        return float(self.x[k] - half), float(self.x[k] + half)

    def contains(self, values: Mapping[str, float], confidence: float = 0.95) -> bool:
        """Do values of all names lie in the ellipsoid that holds the truth with this confidence?"""
        missing = [name for name in self.names if name not in values]
        if missing:
            raise ArgumentError(f"value of {missing[0]}", "is missing", f"give {', '.join(self.names)}")
        away = np.array([values[name] for name in self.names]) - self.x
        scale = self.standard_errors
        distance = float((away / scale) @ np.linalg.solve(self.correlation, away / scale))
        n = len(self.names)
        if np.isinf(self.freedom):
            return bool(distance <= stats.chi2.ppf(_share(confidence), n))
        return bool(distance <= n * stats.f.ppf(_share(confidence), n, self.freedom))

    def picture(self, path: str | Path | None = None) -> Figure:
        """Data, fitted outputs and residuals over time; with a path it also writes the file."""
        from runtime.views.plots import fit_picture

        title = "\n".join(f"{name} = {value:.4g} ± {error:.1g}" for name, value, error in self._rows())
        return fit_picture(title, self.t, self.data, self.fitted, path)

    def __str__(self) -> str:
        rows = [f"{name} = {value:.6g} +- {error:.2g}" for name, value, error in self._rows()]
        return "\n".join([*rows, f"{self.evaluations} runs; {self.message}"])

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(name)}</td><td>{value:.6g}</td><td>{error:.2g}</td></tr>"
            for name, value, error in self._rows()
        )
        return f"<table><tr><th>name</th><th>value</th><th>standard error</th></tr>{rows}</table>{escape(self.message)}"

    def _rows(self) -> list[tuple[str, float, float]]:
        return list(zip(self.names, map(float, self.x), map(float, self.standard_errors), strict=True))

    def _index(self, name: str) -> int:
        if name not in self.names:
            raise ArgumentError(f"{name!r}", "was not fitted", f"take one of {', '.join(self.names)}")
        return self.names.index(name)


def _share(confidence: float) -> float:
    if not 0 < confidence < 1:
        raise ArgumentError("confidence", f"is {confidence}", "give a fraction between 0 and 1, such as 0.95")
    return confidence


# Measured outputs at the saved times of a run, checked, with their standard deviations.

TIME_OF_STEP = 1e-6  # of a step


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


def measured(run: Predicts, data: Mapping[str, Any], deviation: float | Mapping[str, Any] | None) -> Measured:
    """Raises ArgumentError for data of another length, at other times, with NaN, or too few of them."""
    samples, names = len(run.t), run.outputs
    missing = [name for name in names if name not in data]
    if missing:
        raise ArgumentError(f"data of {missing[0]}", "are missing", f"give {', '.join(names)}")
    if "t" in data and isinstance(run, DifferentiableRun):
        times = _column(data["t"], "t", samples)
        off = float(np.abs(times - run.t).max())
        if not off <= TIME_OF_STEP * run.plan.grid.dt_L:
            raise ArgumentError(
                "data of t",
                f"differ from the saved times by up to {off:.3g} s",
                f"every {run.plan.seen_steps} steps of {run.plan.grid.dt_L:g} s gives {run.t[0]:g} to {run.t[-1]:g} s: "
                "interpolate the data, or choose dt, seen_every and t_end to fit them",
            )
    if deviation is None and len(names) > 1:
        raise ArgumentError("deviation", "is missing", "with several outputs, give the standard deviation of each")
    given = (
        deviation
        if isinstance(deviation, Mapping)
        else {name: 1.0 if deviation is None else deviation for name in names}
    )
    for name in names:
        if name not in given:
            raise ArgumentError(f"deviation of {name}", "is missing", f"give one for each of {', '.join(names)}")
    spread = np.column_stack([_column(_spread(given[name], samples), f"{name} (deviation)", samples) for name in names])
    if not (spread > 0).all():
        raise ArgumentError("deviation", "must be positive", "set it to infinity where nothing was measured")
    values = np.column_stack([_column(data[name], name, samples) for name in names])
    there = np.isfinite(spread)
    for k, name in enumerate(names):
        bad = np.flatnonzero(there[:, k] & ~np.isfinite(values[:, k]))
        if len(bad):
            raise ArgumentError(
                f"data of {name}",
                f"is {values[bad[0], k]} at t = {run.t[bad[0]]:.6g} s",
                "exclude it with an infinite deviation there",
            )
    found = Measured(np.where(there, values, 0.0), np.where(there, 1.0 / spread, 0.0), deviation is not None)
    if found.count <= len(run.by):
        raise ArgumentError("data", f"are {found.count} numbers for {len(run.by)} unknowns", "measure more of them")
    return found


def _spread(given: Any, samples: int) -> Any:
    """A number stands for all samples."""
    return np.full(samples, given) if is_finite_number(given) or isinstance(given, float) else given


def _column(values: Any, name: str, samples: int) -> np.ndarray:
    try:
        column = np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise ArgumentError(f"data of {name}", f"are not numbers ({error})", "give an array of them") from error
    if column.shape != (samples,):
        raise ArgumentError(
            f"data of {name}", f"have shape {column.shape}", f"give one value for each of the {samples} saved times"
        )
    return column
