"""A tolerance instead of a step, on the hard suite: what is delivered, and what the whole refinement costs.

Each case goes by `auto` to 1e-2 ... 1e-6. Delivered is the true RMS error of the worst coordinate at the marks of the
answer, against order 8 with steps that resolve every mode. The price is that of all levels, in operations, over the
fewest with which an oracle would have met the tolerance in one run: the best of eight methods with the best number of
steps, to a fifth.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from time import process_time
from typing import Any

import numpy as np

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.tolerance_runs import Case, SampledRefinement, cheapest, runs_of_an_oracle
from benchmarks.scenes.hard_suite import CASES, HARD_SUITE
from runtime.running.method_choice import chosen_method
from runtime.running.run_options import RunOptions
from runtime.running.step_refinement import RefinementLevel

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
SMALLEST = {"CASES": (replace(HARD_SUITE["overdamped"], t_end=0.1),), "TOLERANCES": (1e-2,)}
REMARK = (
    "Each case by `auto` to 1e-2, 1e-3, 1e-4, 1e-5 and 1e-6. Delivered over asked is of the worst coordinate. All "
    "operations of all levels are compared with the fewest of a single run that meets the tolerance: the best of "
    "`dopri5`, `dop853`, `rk4`, `single_rate`, `exponential_rk4`, `exponential_adams` and `exponential` with the best "
    "number of steps, which nobody knows before; a dash where none met it."
)


def run() -> Result:
    """Every case of the hard suite."""
    details: dict[str, dict[str, Any]] = {}
    began = process_time()
    with workplace() as folder:
        for k, hard in enumerate(CASES, start=1):
            details[hard.name] = measured(Case(hard, model_of(hard.make(), folder)))
            note = _line(hard.name, details[hard.name]).note
            print(f"{k} of {len(CASES)}, {process_time() - began:.0f} CPU s: {hard.name}: {note}", file=sys.stderr)
    return told(details)


def measured(case: Case) -> dict[str, Any]:
    """The method of a case, and what it gave to each tolerance."""
    method, reason = chosen_method(case.problem)
    single = runs_of_an_oracle(case, TOLERANCES)
    cells = []
    for tolerance in TOLERANCES:
        levels: list[RefinementLevel] = []
        began = process_time()
        levels.extend(SampledRefinement(case.problem, tolerance, None, RunOptions()).refine(method))
        seconds = process_time() - began
        answer = next((one for one in reversed(levels) if not one.lost), levels[-1])
        best = cheapest(single, tolerance)
        operations = sum(case.made(one).operations for one in levels)
        cells.append(
            {
                "tolerance": tolerance,
                "delivered": case.error_of(answer) / tolerance,
                "told": answer.estimated.largest / tolerance,
                "said": bool(answer.error > tolerance) or answer.lost,
                "rungs": len(levels),
                "steps": answer.steps,
                "operations": operations,
                "seconds": seconds,
                "price": operations / best.operations if best is not None else np.nan,
                "best": best.label if best is not None else "",
            }
        )
    return {"scheme": method.scheme, "reason": reason, "cells": cells}


def told(details: dict[str, dict[str, Any]]) -> Result:
    """The figures of all cases, by name."""
    cells = [cell for found in details.values() for cell in found["cells"]]
    delivered, prices = (np.array([cell[key] for cell in cells], dtype=float) for key in ("delivered", "price"))
    silent = np.array([cell["delivered"] > 1 and not cell["said"] for cell in cells])
    met = prices[np.isfinite(prices)]
    summary = [
        Line("delivered more error than was asked, share of runs", float((delivered > 1).mean()), "", 0.03),
        Line("delivered over asked, largest of those that say nothing", _largest(delivered[~_said(cells)]), "", 2.0),
        Line("above what was asked and no word, share of runs", float(silent.mean()), ""),
        Line("operations of all levels over those of the best single run, median", float(np.median(met)), "", 4.5),
        Line("the same, nine tenths of the runs below", float(np.percentile(met, 90)), ""),
    ]
    lines = [_line(name, found) for name, found in details.items()]
    return Result("tolerance", "A tolerance instead of a step, on the hard suite", [*summary, *lines], details, REMARK)


def _said(cells: list[dict[str, Any]]) -> np.ndarray:
    return np.array([cell["said"] for cell in cells], dtype=bool)


def _largest(values: np.ndarray) -> float:
    return float(values.max()) if len(values) else 0.0


def _line(name: str, found: dict[str, Any]) -> Line:
    """The median of a case's prices, with all its figures."""
    cells = found["cells"]
    prices = [cell["price"] for cell in cells if np.isfinite(cell["price"])]

    def listed(key: str) -> str:
        return ", ".join(f"{cell[key]:.2g}" if np.isfinite(cell[key]) else "-" for cell in cells)

    steps = ", ".join(f"{cell['steps']:.0f}" for cell in cells)
    note = f"{found['scheme']}; {steps} steps; delivered over asked {listed('delivered')}; price {listed('price')}"
    return Line(f"{name}: price, median", float(np.median(prices)) if prices else np.nan, "", note=note)
