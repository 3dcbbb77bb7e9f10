"""Many motions that repeat: one for each case of a study, and parameters from a measured one.

A fit needs the slopes of the motion that stays periodic: with x0(p) where F(x0, p) = x0 + turn and the monodromy M,

    (I - M) dx0/dp = F_p,        dy/dp = y_p + y_x dx0/dp.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, arguments
from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import EmittedModel
from runtime.gradients.differentiable_run import OutputJacobian
from runtime.gradients.fit import Bounds, Fit, fit_prepared
from runtime.orbits.motion import SINGULAR_SENSITIVITY, PeriodicMotion, gradient_run
from runtime.orbits.periodic import periodic
from runtime.orbits.shooting import NoPeriodicMotion
from runtime.running.columns import columns_of
from runtime.studies.ensemble.starts import columns_by_name, table_of

REDUCED: dict[str, Callable[[np.ndarray], Any]] = {  # of the values over one period, its end left out
    "max": np.max,
    "min": np.min,
    "peak": lambda y: np.abs(y).max(),
    "mean": np.mean,
    "rms": lambda y: np.sqrt(np.mean(y**2)),
}


TOLERANCE, WRONG = 1e-6, 0.1  # errors over amplitudes: that of `periodic`; of given steps, none is a motion beyond it


@arguments()
def periodic_cases(model: EmittedModel, parameters: Any, reduce: Mapping[str, str | Sequence[str]], **how: Any) -> Any:
    """Find the motion that repeats in each of many cases: a study of steady states instead of transients.

    Parameters
    ----------
    model : Model
        The mechanism.
    parameters : mapping of str to array_like (cases,), or DataFrame
        Values by name, an array or one number for all cases, in SI units.
    reduce : mapping of str to str or sequence of str
        By output one or several of max, min, peak (largest magnitude), mean, rms, over one period.
    **how
        Arguments of `periodic`: `speed` or `period`, `tolerance` or `steps`, `scheme`, ...

    Returns
    -------
    xarray.Dataset or dict of str to ndarray
        Over `case`: `<output>_<reduction>`, `status` ("completed"; "inaccurate" beyond the tolerance, with given
        steps beyond 0.1; "no_motion", with NaN), `stability`, `error` [1],
        `period` [s], `multiplier` (the largest by size), and what was varied; a dictionary without xarray.

    Raises
    ------
    ArgumentError, ModelError, SchemeError
        For what cannot be used.

    Notes
    -----
    Each search begins at the motion found for the nearest case before it, and anew where that fails.
    """
    if "start" in how or "parameters" in how:
        raise ArgumentError("start" if "start" in how else "parameters", "is that of each case", "leave it out")
    wanted = _reductions(reduce)
    (names, _), table = table_of(model, columns_by_name("parameters", parameters), None)
    spread = np.maximum(np.ptp(table, axis=0), 1e-300)
    found: list[PeriodicMotion | None] = []
    rows = np.full((len(table), len(wanted)), np.nan)
    for k, case in enumerate(table):
        given = dict(zip(names, case.tolist(), strict=True))
        away = [float(np.abs((table[j] - case) / spread).max()) if one else np.inf for j, one in enumerate(found)]
        near = found[int(np.argmin(away))] if away and min(away) < np.inf else None
        motion = _motion(model, given, near, how)
        found.append(motion)
        if motion is not None:
            rows[k] = _reduced(motion, wanted)
    limit = WRONG if "steps" in how else float(how.get("tolerance", TOLERANCE))
    return _result(model, names, table, wanted, rows, found, limit)


def _status(motion: PeriodicMotion | None, limit: float) -> str:
    """Of a case whose error may be so large [1]."""
    if motion is None:
        return "no_motion"
    return "inaccurate" if motion.error.largest > limit else "completed"


def _reductions(reduce: Mapping[str, str | Sequence[str]]) -> list[tuple[str, str]]:
    """(output, reduction) of all. Raises ArgumentError."""
    if not isinstance(reduce, Mapping) or not reduce:
        raise ArgumentError("reduce", "names no output", 'give a dictionary, such as {"rod.q1": ["peak", "rms"]}')
    found = [(name, one) for name, which in reduce.items() for one in ([which] if isinstance(which, str) else which)]
    for name, one in found:
        if one not in REDUCED:
            raise ArgumentError(
                f"reduce[{name!r}]", f"there is no reduction {one!r}", f"choose from {', '.join(REDUCED)}"
            )
    return found


def _motion(
    model: EmittedModel, given: dict[str, float], near: PeriodicMotion | None, how: Mapping[str, Any]
) -> PeriodicMotion | None:
    """Of one case, from another's motion or anew; None where there is none in reach."""
    for start in (near, None) if near is not None else (None,):
        try:
            return periodic(model, parameters=given, start=start, **how)
        except NoResult:
            continue
    return None


def _reduced(motion: PeriodicMotion, wanted: Sequence[tuple[str, str]]) -> list[float]:
    run = motion.simulate(1, seen_every=0.0)
    values = columns_of(run, list(dict.fromkeys(name for name, _ in wanted)))
    return [float(REDUCED[how](values[name][:-1])) for name, how in wanted]


def _result(
    model: EmittedModel,
    names: Sequence[str],
    table: np.ndarray,
    wanted: Sequence[tuple[str, str]],
    rows: np.ndarray,
    found: Sequence[PeriodicMotion | None],
    limit: float,
) -> Any:
    from importlib.util import find_spec

    from runtime.results.dataset import described

    labels = described(model, [name for name, _ in wanted])
    arrays: dict[str, Any] = {}
    for k, (name, how) in enumerate(wanted):
        label = {**labels[name], "long_name": f"{how} of {labels[name]['long_name']} over a period"}
        arrays[f"{name}_{how}"] = rows[:, k], label
    number: dict[str, tuple[str, str, Callable[[PeriodicMotion], float]]] = {
        "error": ("estimated error of the motion over its amplitudes", "1", lambda one: one.error.largest),
        "period": ("period", "s", lambda one: one.period),
        "multiplier": ("size of the largest Floquet multiplier", "1", lambda one: one.floquet.largest),
    }
    for key, (meaning, unit, of) in number.items():
        values = np.array([np.nan if one is None else float(of(one)) for one in found])
        arrays[key] = values, {"long_name": meaning, "units": unit}
    arrays["status"] = np.array([_status(one, limit) for one in found]), {"long_name": "status"}
    arrays["stability"] = np.array(["" if one is None else one.stability for one in found]), {"long_name": "stability"}
    units = {one.name: one.unit for one in model.parameters}
    varied = {name: (table[:, k], {"units": units[name]} if units[name] else {}) for k, name in enumerate(names)}
    if find_spec("xarray") is None:
        return {name: values for name, (values, _) in {**varied, **arrays}.items()}
    import xarray

    over = {name: (("case",), *one) for name, one in varied.items()}
    data = {name: (("case",), *one) for name, one in arrays.items()}
    attributes = {"model": model.name, "title": model.title}
    return xarray.Dataset(data, coords={"case": np.arange(len(table)), **over}, attrs=attributes)


# ---- parameters from a measured motion that repeats ---------------------------------------------------------------


@arguments(data=BY_NAME, parameters=NAMES, bounds=BY_NAME, guess=BY_NAME, fixed=BY_NAME)
def fit_periodic(
    model: EmittedModel,
    data: Mapping[str, Any],
    parameters: Sequence[str],
    *,
    bounds: Bounds | None = None,
    guess: Mapping[str, float] | None = None,
    fixed: Mapping[str, float] | None = None,
    deviation: float | Mapping[str, Any] | None = None,
    **how: Any,
) -> Fit:
    """Fit parameters to one period of a measured steady state, without its start.

    Parameters
    ----------
    model : Model
        The mechanism.
    data : mapping of str to array_like (N,)
        Values of outputs at N times that divide the period evenly, from its start on and without its end, in SI units.
    parameters : sequence of str
        What is fitted; neither the speed nor what the period depends on.
    bounds, guess, deviation : optional
        As of `fit`.
    fixed : mapping of str to float, optional
        Values of other parameters.
    **how
        Arguments of `periodic`: `speed` or `period`, `steps` (a multiple of N), `scheme`, ...

    Returns
    -------
    Fit
        Values, standard errors, correlation, and the fitted outputs.

    Raises
    ------
    ArgumentError, ModelError, SchemeError
        For what cannot be used.
    NoResult
        Where the data do not determine the parameters, and where the guess has no motion that repeats.

    Notes
    -----
    Gauss-Newton in a trust region, as `fit`; the derivatives are those of the motion that stays periodic.

    References
    ----------
    R. Seydel, Practical Bifurcation and Stability Analysis, 3rd ed., Springer, 2010.
    """
    outputs = [name for name in data if name != "t"]
    counts = {np.size(data[name]) for name in outputs}
    if len(counts) != 1 or min(counts, default=0) < 2:
        raise ArgumentError("data", "have different numbers of values", "give one for each time of the period")
    if how.get("speed") in parameters or how.get("period") == "free":
        raise ArgumentError("parameters", "would change the period, but the data are at fixed times", "fix the period")
    run = SteadyRun(model, tuple(outputs), tuple(parameters), dict(fixed or {}), counts.pop(), dict(how))
    return fit_prepared(run, {name: data[name] for name in outputs}, bounds=bounds, guess=guess, deviation=deviation)


@dataclass
class SteadyRun:
    """One period of a motion that repeats as a function of parameters, at `samples` times that divide it evenly."""

    model: EmittedModel
    outputs: tuple[str, ...]
    by: tuple[str, ...]
    fixed: dict[str, float]
    samples: int
    how: dict[str, Any]
    _last: PeriodicMotion | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        known = [one.name for one in self.model.parameters]
        for name in (*self.by, *self.fixed):
            if name not in known:
                self.model.parameter_vector({name: 1.0})  # says what there is
        if steps := self.how.get("steps"):
            if steps % self.samples:
                raise ArgumentError("steps", f"are {steps}, with {self.samples} samples", "give a multiple of that")
        else:
            self.how["steps"] = self.samples * max(1, round(400 / self.samples))
        self.t = np.arange(self.samples) * (self._at(self.x0).period / self.samples)

    @property
    def x0(self) -> np.ndarray:
        """(n,) the values of the model."""
        defaults = {one.name: float(one.default) for one in self.model.parameters}
        return np.array([defaults[name] for name in self.by])

    def jacobian(self, x: np.ndarray) -> OutputJacobian:
        """Outputs (N, n_y), and their derivatives (N, n_y, n) by the parameters, at the values x (n,)."""
        motion = self._at(np.asarray(x, dtype=float))
        states, n = motion.states, len(motion.x)
        shown = tuple(states.outputs)
        run = gradient_run(motion, tuple(dict.fromkeys((*self.outputs, *shown))), [*states.names, *self.by])
        at = run.x0.copy()
        at[:n] = motion.x
        found = run.jacobian(at)
        own, last = ([run.outputs.index(name) for name in names] for names in (self.outputs, shown))
        end = found.derivatives[-1][last]
        F_p = states.slopes(found.values[-1, last], np.eye(len(shown)), motion.found.shot.ends[-1]) @ end[:, n:]
        matrix = np.eye(n) - motion.found.shot.monodromy
        singular = np.linalg.svd(matrix, compute_uv=False)
        if singular[-1] <= SINGULAR_SENSITIVITY * singular[0]:
            raise NoPeriodicMotion(
                f"model {self.model.name}",
                "the motion has no derivative: a Floquet multiplier is 1",
                "give the model damping",
            )
        x_p = np.linalg.solve(matrix, F_p)
        every = motion.steps // self.samples
        y = found.derivatives[: motion.steps : every][:, own]
        slopes = y[:, :, n:] + y[:, :, :n] @ x_p
        values = found.values[: motion.steps : every][:, own]
        return OutputJacobian(self.t, self.outputs, self.by, values, slopes)

    def _at(self, x: np.ndarray) -> PeriodicMotion:
        """The motion there, sought from the last one. Raises NoResult."""
        given = {**self.fixed, **dict(zip(self.by, x.tolist(), strict=True))}
        try:
            self._last = periodic(self.model, parameters=given, start=self._last, **self.how)
        except NoResult:
            if self._last is None:
                raise
            self._last = periodic(self.model, parameters=given, **self.how)
        return self._last
