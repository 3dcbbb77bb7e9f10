"""Schemes with steps of one length on the hard suite: the time of each to 1e-3, and how far each is behind the
best.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
from scipy.interpolate import CubicSpline

from benchmarks.harness.fewest import Timed, fewest
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.tolerance_runs import KEPT, Case
from benchmarks.scenes.hard_suite import CASES, HARD_SUITE, HardCase
from runtime.model import Model
from runtime.running.method_choice import Method
from runtime.studies.advice.methods import stiff_methods
from runtime.studies.advice.reference import Reference
from runtime.studies.advice.trial import Trial

TOLERANCE, MOST = 1e-3, 200_000
TURNS = 4  # further timings of each method's best run: another program's burst hits one of them
DENSE = 13  # independent coordinates up to which schemes that factorise M_hat take part
STIFF = ("exponential_adams", "exponential_rk4")
FIVE = {"order": 5}
OWN = ("exponential",)
SMALLEST = {"CASES": (replace(HARD_SUITE["overdamped"], t_end=0.1),), "TURNS": 1}
EXPLICIT = (Method("dop853"), Method("rk4"), Method("single_rate", None, {"common_velocity": "predictor"}))
REMARK = """\
CPU time of one native call for the whole motion, at the fewest steps that bring every graded coordinate below 1e-3 of
its RMS amplitude; the lower quartile of at least five calls, of five such by turns the median. `exponential_rk4 / best`
is its time over that of the fastest scheme on the case, `these / best` that of the fastest of it and
`exponential_adams`; `radau / best of ours` is how many times as long `radau` takes as the fastest of these two,
and `exponential`. Of schemes that factorise M_hat none is tried above {dense} coordinates, and on other
large cases (arms, the loop in space) `exponential` with m = 1 alone."""


def run() -> Result:
    """All cases, small ones first."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for hard in CASES:
            print(f"  {hard.name} ...", file=sys.stderr, flush=True)
            found = best_trials(hard, model_of(hard.make(), folder))
            details[hard.name] = {name: (one.steps, one.seconds, one.error) for name, one in found.items()}
            lines += _lines(hard.name, {name: one.seconds for name, one in found.items()}, found)
    return Result("hard_steps", "Steps of one length on the hard suite", lines, details, REMARK.format(dense=DENSE))


def best_trials(hard: HardCase, model: Model) -> dict[str, Trial]:
    """The best run of every scheme that meets the tolerance, by label."""
    return best_of(contenders(model, hard.large), reference_of(hard, model))


def best_of(methods: list[Method], reference: Reference) -> dict[str, Trial]:
    """The best run to the tolerance of each of these methods that meets it, by label; timed again by turns."""
    found: dict[str, Trial] = {}
    timed: dict[str, Timed] = {}
    quickest = np.inf
    for method in methods:
        one = Timed(method, reference)
        best = fewest(one, TOLERANCE, most=MOST, seconds_to_beat=5 * quickest)
        if best is not None:
            found[method.label], timed[method.label] = best, one
            quickest = min(quickest, best.seconds)
    times = {label: [best.seconds] for label, best in found.items()}
    for _ in range(TURNS):
        for label, best in found.items():
            times[label].append(timed[label].run(best.steps).seconds)
    return {label: replace(best, seconds=float(np.median(times[label]))) for label, best in found.items()}


def reference_of(hard: HardCase, model: Model) -> Reference:
    """Of the case's own making: order 8, steps that resolve every mode."""
    case = Case(hard, model)
    path = CubicSpline(np.linspace(0.0, hard.t_end, KEPT + 1), case.reference)
    return Reference(case.problem, path, list(hard.graded), 1e-7, case.arguments)


def contenders(model: Model, large: bool) -> list[Method]:
    """The likeliest first; of those that factorise M_hat one where the case is large."""
    found = stiff_methods(model)
    if len(model.q_i) <= DENSE and model.has("residual_jacobian"):
        if large:
            return [*found, Method("exponential", (1,)), *EXPLICIT]
        orders = [Method("exponential", (m,), options) for options in ({}, FIVE) for m in (1, 2)]
        found += [*orders, Method("radau", None, {"eps": (1e-6,)})]
    return [*found, *EXPLICIT]


def _lines(name: str, times: dict[str, float], found: dict[str, Trial]) -> list[Line]:
    ranked = sorted(times, key=lambda label: times[label])
    told = ", ".join(f"{label} {times[label] * 1e3:.3g} ms in {found[label].steps} steps" for label in ranked[:4])
    lines = []
    stiff = {label: times[label] / times[ranked[0]] for label in times if label.startswith(STIFF)}
    if stiff:
        lines.append(Line(f"{name}: these / best", min(stiff.values()), "", 1.1, told))
        lines += [Line(f"{name}: {label} / best", ratio, "") for label, ratio in stiff.items()]
    else:
        lines.append(Line(f"{name}: best", times[ranked[0]] * 1e3, "ms", note=told))
    radau = next((times[label] for label in ranked if label.startswith("radau")), None)
    ours = [time for label, time in times.items() if label.startswith(STIFF + OWN)]
    if radau is not None and ours:
        lines.append(Line(f"{name}: radau / best of ours", radau / min(ours), ""))
    return lines
