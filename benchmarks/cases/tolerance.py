"""A tolerance instead of a step, on the hard suite: what is delivered, rejections, and time over the best step's.

Each case runs by the method that `auto` chooses, from 1e-2 to 1e-6, and by the same method with steps of one length,
more and more of them. Delivered is the RMS error over the motion of the worst independent coordinate, relative to its
amplitude and at least a thousandth of the largest of its kind and unit, as trials measure it. Time is CPU time of
one native call for the whole motion; that of steps of one length is taken at the error that was delivered.
"""

from __future__ import annotations

import sys
from time import process_time

import numpy as np

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.tolerance_runs import Case, Method, Run, best_of, steps_at, swept
from runtime.running.calibration import Calibration
from runtime.studies.advice.auto import choose
from symgen.scenes.hard_suite import CASES

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


def run() -> Result:
    """Every case of the hard suite."""
    details: dict[str, dict] = {}
    began = process_time()
    with workplace() as folder:
        for k, hard in enumerate(CASES, start=1):
            details[hard.name] = _case(Case(hard, model_of(hard.make(), folder)))
            print(f"tolerance: {hard.name}, {k} of {len(CASES)}, {process_time() - began:.0f} CPU s", file=sys.stderr)
    return told(details)


def told(details: dict[str, dict]) -> Result:
    """The figures of all cases, by name."""
    cells = [cell for found in details.values() for cell in found["cells"]]
    ratios = np.array([cell["time"] for cell in cells if np.isfinite(cell["time"])])
    delivered = np.array([cell["delivered"] for cell in cells])
    rejected = np.array([cell["rejected"] for cell in cells])
    thrown = sum(one["rejected"] * one["steps"] for one in cells) / sum(one["steps"] for one in cells)
    within = float(((delivered >= 0.1) & (delivered <= 3)).mean())
    summary = [
        Line("time over the best step, median", float(np.median(ratios)), "", 1.0),
        Line("time over the best step, share of runs above 1.15", float((ratios > 1.15).mean()), "", 0.0),
        Line("delivered over asked outside 0.1 to 3, share of runs", 1 - within, "", 0.1),
        Line("delivered over asked above 3, share of runs", float((delivered > 3).mean()), ""),
        Line("rejected steps, largest share of a run", float(rejected.max()), "", 0.1),
        Line("rejected steps, share of all", thrown, "", 0.1),
        Line("steps over those of the best step, median", _median(cells, "steps_over_fixed"), ""),
        Line("operations of the trials over those of the run, median", _median(cells, "trials"), ""),
    ]
    lines = [_line(name, found) for name, found in details.items()]
    return Result("tolerance", "A tolerance instead of a step, on the hard suite", [*summary, *lines], details, REMARK)


REMARK = (
    "Each case by the method that `auto` chooses, to 1e-2, 1e-3, 1e-4, 1e-5 and 1e-6. Delivered over asked is of the "
    "worst independent coordinate. The best step is that of the same method with steps of one length at the error that "
    "was delivered, from a sweep of numbers of steps by a factor of 1.4; a dash where none came to that error. Time is "
    "that of the run; operations of the trials before it are told beside it, over those of the run: of all methods "
    "that were tried, less the run where one of them is the run. In the sweep steps "
    "go across times at which loads jump; those of a run to a tolerance end there."
)


def _case(case: Case) -> dict:
    """What `auto` chose, and of each tolerance what it gave."""
    chosen = {tolerance: choose(case.model, tolerance, case.arguments) for tolerance in TOLERANCES}
    cells: list[dict[str, float]] = []
    for name in dict.fromkeys(choice.scheme for choice in chosen.values()):
        asked = {tolerance: choice.known for tolerance, choice in chosen.items() if choice.scheme == name}
        method = Method(case, name, {"tolerance": TOLERANCES[0]})
        runs = {tolerance: method.to_tolerance(tolerance, known) for tolerance, known in asked.items()}
        steady = Method(case, name, {}, [2] if name == "exponential" else None)
        slowest = max(best_of(method.advancing(case.t_end, 1, tolerance, one))[0] for tolerance, one in asked.items())
        fixed = swept(steady, min(one.error for one in runs.values()), 4 * slowest)
        for tolerance, one in runs.items():
            cells.append(_cell(method, steady, tolerance, asked[tolerance], one, steps_at(fixed, one.error)))
    schemes = [choice.scheme for choice in chosen.values()]
    return {"schemes": schemes, "cells": sorted(cells, key=lambda cell: -cell["tolerance"])}


def _cell(
    method: Method, steady: Method, tolerance: float, known: Calibration | None, one: Run, fixed: float
) -> dict[str, float]:
    """Figures of a run; fixed: how many steps of one length have its error."""
    t_end = method.case.t_end
    steps = max(1, round(fixed) if np.isfinite(fixed) else one.steps)
    seconds, other = best_of(method.advancing(t_end, 1, tolerance, known), steady.advancing(t_end / steps, steps))
    return {
        "tolerance": tolerance,
        "delivered": one.error / tolerance,
        "graded": one.graded / tolerance,
        "steps": one.steps,
        "rejected": one.rejected / max(1, one.steps + one.rejected),
        "seconds": seconds,
        "time": seconds / other if np.isfinite(fixed) else np.nan,
        "steps_over_fixed": (one.steps + one.rejected) / fixed,
        "trials": known.tried / known.operations if known is not None else np.nan,
    }


def _median(cells: list[dict[str, float]], key: str) -> float:
    return float(np.nanmedian([cell[key] for cell in cells]))


def _line(name: str, found: dict) -> Line:
    """The median of a case's time ratios, with all its figures."""
    cells = found["cells"]
    ratios = [cell["time"] for cell in cells if np.isfinite(cell["time"])]

    def listed(key: str) -> str:
        return ", ".join(f"{cell[key]:.2g}" if np.isfinite(cell[key]) else "-" for cell in cells)

    schemes = ", ".join(dict.fromkeys(found["schemes"]))
    steps = ", ".join(f"{cell['steps']:.0f}" for cell in cells)
    figures = f"delivered over asked {listed('delivered')}; time over the best step {listed('time')}"
    note = f"{schemes}; {steps} steps; {figures}"
    return Line(
        f"{name}: time over the best step, median", float(np.median(ratios)) if ratios else np.nan, "", note=note
    )
