"""Ensembles to a tolerance on ten small cases of the hard suite: what is told of each case, and what that costs.

True errors are of the same samples, against motions by the same method with eight times the most steps of any case.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from time import process_time
from typing import Any

import numpy as np

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.scenes.hard_suite import HARD_SUITE
from runtime.contract.coordinates import followed
from runtime.model import Model
from runtime.results.motion_error import errors_of_many

TOLERANCE, CASES_EACH, CHECKED, SINGLE = 1e-4, 1000, 100, 12
SPREAD = 0.1  # of a value that is varied
FINER = 8  # times the most steps of any case: of the motions that are taken for the truth
SAMPLES = 60
# What is varied, by case of the hard suite.
VARIED: dict[str, tuple[str, ...]] = {
    "f1_smooth": ("omega",),
    "slider_crank_free": ("crank.inertia",),
    "slider_crank_torque": ("motor_torque", "crank.mass"),
    "f2_heavy_hub": ("torque", "hub.inertia"),
    "f2_light_hub": ("torque", "hub.inertia"),
    "f3_spin_up": ("ramp",),
    "overdamped": ("rod.mass", "spring.damping"),
    "oscillators_10": ("c", "k_L"),
    "joint_arm": ("shoulder_torque", "elbow_torque"),
    "governor": ("slider.mass",),
}
SMALLEST = {"VARIED": {"overdamped": ("rod.mass",)}, "TOLERANCE": 1e-2, "CASES_EACH": 8, "CHECKED": 4, "SINGLE": 1}
REMARK = """\
{cases} cases each, what is named varied by {spread:.0%}, to {tolerance:g} by the method that `auto` takes. True errors
are of the first {checked} cases. Told: the `error` of a case; two numbers agree within 3 where neither is above three
times the other. Price: steps of all levels over those of `simulate` to the same tolerance, mean of {single} cases,
which choose their own method. Times are CPU seconds of one thread, compiled code in the cache."""


@dataclass(frozen=True)
class Figures:
    """What was measured of one case of the suite."""

    scheme: str
    answered: float  # share of cases that are completed
    missed: float  # share of those that are completed above the tolerance
    apart: float  # share whose told error is not within 3 of the true one
    low: float  # share whose told error is a third of the true one or less
    median: float  # of told over true
    price: float
    case_ms: float
    single_ms: float
    steps_a_second: float


def run() -> Result:
    """All cases of VARIED."""
    found: dict[str, Figures] = {}
    with workplace() as folder:
        for name, varied in VARIED.items():
            hard = HARD_SUITE[name]
            found[name] = measured(model_of(hard.make(), folder), varied, hard.parameters, hard.initial, hard.t_end)
            print(f"{name}: {found[name]}", file=sys.stderr)
    remark = REMARK.format(cases=CASES_EACH, spread=SPREAD, tolerance=TOLERANCE, checked=CHECKED, single=SINGLE)
    return Result("ensemble_tolerance", "Ensembles to a tolerance", lines_of(found), _details(found), remark)


def measured(model: Model, varied: tuple[str, ...], parameters: Any, initial: Any, t_end: float) -> Figures:
    """One case of the suite."""
    rng, own = np.random.default_rng(1), {entry.name: k for k, entry in enumerate(model.parameters)}
    values = {**parameters}
    for name in varied:
        middle = parameters.get(name, model.parameter_vector()[own[name]])
        values[name] = middle * rng.uniform(1 - SPREAD, 1 + SPREAD, CASES_EACH)
    names = followed(model)[0]
    outputs = [*names, *(f"{name}_dot" for name in names)]
    asked: dict[str, Any] = {"initial": initial or None, "t_end": t_end, "outputs": outputs, "samples": SAMPLES}
    asked |= {"workers": 1}
    model.ensemble(_first(values, 2), tolerance=TOLERANCE, **asked)  # compiles
    began = process_time()
    answer = model.ensemble(values, tolerance=TOLERANCE, **asked)
    seconds = process_time() - began
    scheme = answer.attrs["scheme"]

    few = _first(values, CHECKED)
    steps = FINER * int(answer["steps"].values[:CHECKED].max())
    near = model.ensemble(few, scheme=scheme, dt=t_end / steps, **asked)
    y, z = (np.stack([one[name].values[:CHECKED] for name in outputs], axis=1) for one in (answer, near))
    true = errors_of_many(model, y, z)[0].max(axis=1)
    done = answer["status"].values[:CHECKED] == "completed"
    ratio = answer["error"].values[:CHECKED][done] / true[done]

    alone, cpu = _single(model, values, initial, t_end)
    of_cases = answer["steps"].values
    return Figures(
        scheme=scheme,
        answered=float((answer["status"].values == "completed").mean()),
        missed=float((true[done] > TOLERANCE).mean()),
        apart=float(((ratio < 1 / 3) | (ratio > 3)).mean()),
        low=float((ratio < 1 / 3).mean()),
        median=float(np.median(ratio)),
        price=float(answer["steps_of_all_levels"].values[:SINGLE].mean() / alone),
        case_ms=1e3 * seconds / CASES_EACH,
        single_ms=1e3 * cpu,
        steps_a_second=float(of_cases.sum() / seconds),
    )


def _first(values: dict[str, Any], cases: int) -> dict[str, Any]:
    return {name: value[:cases] if np.ndim(value) else value for name, value in values.items()}


def _single(model: Model, values: dict[str, Any], initial: Any, t_end: float) -> tuple[float, float]:
    """(steps of all levels, CPU seconds) of `simulate`, means of the first cases."""
    steps: list[float] = []
    seconds: list[float] = []
    for k in range(SINGLE + 1):
        parameters = {name: float(np.ravel(value)[min(k, np.size(value) - 1)]) for name, value in values.items()}
        began = process_time()
        run = model.simulate(t_end=t_end, tolerance=TOLERANCE, parameters=parameters, initial=initial or None)
        seconds.append(process_time() - began)
        steps.append(float(run.stats["steps_of_all_rungs"]))
    return float(np.mean(steps[:SINGLE])), float(np.mean(seconds[1:]))


def lines_of(found: dict[str, Figures]) -> list[Line]:
    """Means over the suite, then each case."""

    def mean(name: str) -> float:
        values: list[float] = [getattr(one, name) for one in found.values()]
        return sum(values) / len(values)

    lines = [
        Line("completed above the tolerance, share of cases", mean("missed"), "", 0.02),
        Line("told not within a factor 3 of the truth, share of cases", mean("apart"), "", 0.1),
        Line("told less than a third of the truth, share of cases", mean("low"), ""),
        Line("steps of all levels over those of single runs, mean", mean("price"), "", 1.2),
    ]
    for name, one in found.items():
        note = (
            f"{one.scheme}; completed {one.answered:.3f}; not within 3: {one.apart:.2f}, told over true in the middle "
            f"{one.median:.2f}; price {one.price:.2f}; single run {one.single_ms:.3g} ms"
        )
        lines.append(
            Line(f"{name}: a case", one.case_ms, "ms", note=f"{note}; {one.steps_a_second:.2g} steps a second")
        )
    return lines


def _details(found: dict[str, Figures]) -> dict[str, Any]:
    return {name: vars(one) for name, one in found.items()}
