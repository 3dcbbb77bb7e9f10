"""Parameters and initial values of a model from measured outputs: least squares with the derivatives of the run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import Model
from runtime.gradients.derivatives_of_run import OutputJacobian
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.gradients.fitted import Fit
from runtime.gradients.measured import Measured, measured

TOLERANCE = 1e-10
UNTOLD = 1e-9  # of the largest singular value of the scaled Jacobian: a direction that the data do not see
FAR = 1e3  # times the largest residual of the guess: what a run that fails on the way counts as

Bounds = Mapping[str, tuple[float, float]]


def fit(
    model: Model,
    data: Mapping[str, Any],
    parameters: Sequence[str],
    *,
    bounds: Bounds | None = None,
    guess: Mapping[str, float] | None = None,
    fixed: Mapping[str, float] | None = None,
    deviation: float | Mapping[str, Any] | None = None,
    **run: Any,
) -> Fit:
    """Values of `parameters` (parameters, coordinates and rates at the start, by name) for which outputs come nearest.

        minimise sum over outputs and saved times of ((output - data) / deviation)^2

    data: {output: (N,) values at the saved times}, with "t" (N,) [s] if it is to be compared. deviation: the standard
    deviation of the data, one number or {output: number or (N,)}, infinite where there is none; without it that of the
    one output is estimated from what is left over. guess: where the search begins (else the model's values). bounds:
    {name: (lowest, highest)}; without them only the signs that the model asks for. fixed: values of other parameters.
    run: the further arguments of DifferentiableRun. Raises what that raises, ArgumentError for data or bounds that
    cannot be used, NoResult where the data do not tell the parameters.
    """
    outputs = [name for name in data if name != "t"]
    prepared = DifferentiableRun(model, outputs, parameters, parameters=fixed, **run)
    return fit_prepared(prepared, data, bounds=bounds, guess=guess, deviation=deviation)


def fit_prepared(
    run: DifferentiableRun,
    data: Mapping[str, Any],
    *,
    bounds: Bounds | None = None,
    guess: Mapping[str, float] | None = None,
    deviation: float | Mapping[str, Any] | None = None,
) -> Fit:
    """`fit` on a run prepared once, for who fits again and again: data of its outputs, unknown what it takes."""
    seen = measured(run, data, deviation)
    begin = dict(guess or {})
    wrong = [name for name in begin if name not in run.by]
    if wrong:
        raise ArgumentError(f"guess of {wrong[0]}", "is not fitted", f"guess only {', '.join(run.by)}")
    x = np.array([begin.get(name, value) for name, value in zip(run.by, run.x0, strict=True)], dtype=float)
    search = _Search(run, seen, np.where(x == 0, 1.0, np.abs(x)))
    low, high = _limits(run.model, run.by, bounds or {}, x)
    found = least_squares(
        search.residuals,
        x / search.scale,
        search.jacobian,
        (low / search.scale, high / search.scale),
        xtol=TOLERANCE,
        ftol=TOLERANCE,
        gtol=TOLERANCE,
    )
    at = run.jacobian(found.x * search.scale)
    freedom = seen.count - len(x)
    covariance = _covariance(run.by, search.weighted(at)) * np.outer(search.scale, search.scale)
    if not seen.known:
        covariance *= float(np.sum(found.fun**2)) / freedom
    return Fit(
        names=run.by,
        x=found.x * search.scale,
        covariance=covariance,
        freedom=np.inf if seen.known else freedom,
        t=run.t,
        data={name: seen.values[:, k] for k, name in enumerate(run.outputs)},
        fitted={name: at.values[:, k] for k, name in enumerate(run.outputs)},
        evaluations=int(found.nfev),
        converged=bool(found.status > 0),
        message=str(found.message),
    )


class _Search:
    """Residuals and their Jacobian by x over its scale; each run is made once, with its derivatives."""

    def __init__(self, run: DifferentiableRun, seen: Measured, scale: np.ndarray) -> None:
        self._run, self._seen, self.scale = run, seen, scale
        self._at: tuple[np.ndarray, OutputJacobian | None] | None = None
        self._far = 0.0

    def residuals(self, x: np.ndarray) -> np.ndarray:
        """(outputs - data) / deviation, flat."""
        at = self._evaluated(x)
        if at is None:
            return np.full(self._seen.values.size, self._far)
        found = self._seen.residuals(at.values)
        self._far = self._far or FAR * max(float(np.abs(found).max()), 1e-300)
        return found

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        """Of the residuals."""
        at = self._evaluated(x)
        return np.zeros((self._seen.values.size, len(x))) if at is None else self.weighted(at)

    def weighted(self, at: OutputJacobian) -> np.ndarray:
        """(residuals, n)."""
        rows = at.derivatives * self._seen.weights[:, :, None]
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
            "the data do not tell " + ("it" if "," not in untold else "them apart"),
            "measure another output, or another motion, or leave one of them fixed",
        )
    return np.asarray((directions.T / values**2) @ directions)


def _limits(model: Model, names: Sequence[str], bounds: Bounds, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Raises ArgumentError for bounds that are none, or that the guess lies outside of."""
    signs = {parameter.name: parameter.bound for parameter in model.parameters}
    wrong = [name for name in bounds if name not in names]
    if wrong:
        raise ArgumentError(f"bounds of {wrong[0]}", "are of nothing that is fitted", f"bound {', '.join(names)}")
    low, high = np.full(len(x), -np.inf), np.full(len(x), np.inf)
    for k, name in enumerate(names):
        if signs.get(name, "any") != "any":
            low[k] = 0.0 if signs[name] == "not negative" else 1e-12 * abs(x[k])
        if name in bounds:
            low[k], high[k] = (float(value) for value in bounds[name])
        if not low[k] < high[k] or not low[k] <= x[k] <= high[k]:
            raise ArgumentError(
                f"bounds of {name}",
                f"are {low[k]:g} and {high[k]:g}, the guess {x[k]:g}",
                "let the guess lie between them",
            )
    return low, high
