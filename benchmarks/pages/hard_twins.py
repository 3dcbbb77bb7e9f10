"""The hard suite at full length by equations that are not condensed: `python -m benchmarks.pages.hard_twins`.

Reference values of the hard suite come from the condensed equations. Here every case is integrated once more from the
start to the end. Planar cases by equations that the generator has no part in: Lagrange's of the first kind, from the
kinetic energy of material points (benchmarks/contenders/material_points.py). Others, and with --coordinates all, in all
coordinates and multipliers (Eq. 28): other emitted functions, another linear system, no elimination, no loop closure;
constraints hold at the level of accelerations only.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Iterable
from typing import Any

import numpy as np

from benchmarks.cases.hard_by_points import BY_POINTS
from benchmarks.harness import figures
from benchmarks.scenes.hard_suite import HARD_SUITE, HardCase
from runtime import Model, Solution, SymgenError, load_model, reference_solution
from symgen.generate import generate
from tests.support.augmented import augmented_run

SAMPLES = 41
RTOL, ATOL = 1e-9, 1e-12


def compared(case: HardCase, by_points: bool) -> tuple[float, str, float]:
    """(largest difference of a graded coordinate over its amplitude, end value of the first, seconds of CPU)."""
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(case.make(), folder))
    times = np.linspace(0.0, case.t_end, SAMPLES)
    motion: dict[str, Any] = {
        "t_end": case.t_end,
        "times": times,
        "parameters": case.parameters,
        "initial": case.initial,
    }
    condensed = reference_solution(model, **motion, start=case.start)
    began = time.process_time()
    found = (points if by_points else augmented)(case, model, condensed, motion)
    seconds = time.process_time() - began
    off = []
    for name in case.graded:
        amplitude = float(np.ptp(condensed[name])) / 2
        off.append(float(np.abs(found[name] - condensed[name]).max()) / amplitude)
    first = case.graded[0]
    return max(off), f"`{first}` = {found[first][-1]:.9g}", seconds


def augmented(case: HardCase, model: Model, condensed: Solution, motion: dict[str, Any]) -> dict[str, np.ndarray]:
    """Graded coordinates over time by the emitted functions in all coordinates."""
    twin = augmented_run(model, **motion, start=case.start, rtol=RTOL, atol=ATOL)
    return {name: twin[name] for name in case.graded}


def points(case: HardCase, model: Model, condensed: Solution, motion: dict[str, Any]) -> dict[str, np.ndarray]:
    """The same by material points, from the same start."""
    twin = BY_POINTS[case.name]
    mechanism = twin.make()
    columns = [model.coordinates.index(name) for name in mechanism.names]
    q = mechanism.motion(condensed.q[0, columns], condensed.q_dot[0, columns], motion["times"], twin.breaks, RTOL, ATOL)
    return {name: q[:, mechanism.names.index(name)] for name in case.graded}


def rows_of(names: Iterable[str], by_points: bool) -> dict[str, str]:
    """Rows of the table by case, printed as they come."""
    rows = {}
    for name in names:
        try:
            off, end, seconds = compared(HARD_SUITE[name], by_points)
            rows[name] = f"| {name} | {off:.1g} | {end} |"
            print(f"{rows[name]} {seconds:.0f} s", flush=True)
        except (SymgenError, RuntimeError) as error:  # CasADi's: bodies without mass make M singular
            print(f"| {name} | - | {str(error).strip().splitlines()[-1]} |", flush=True)
    return rows


def publish(marker: str, rows: dict[str, str]) -> None:
    """Put rows into the table of these figures; those of other cases stay."""
    head, rule, *old = figures.figures(marker).splitlines()
    known = {row.split("|")[1].strip(): row for row in old} | rows
    ordered = [known[name] for name in HARD_SUITE if name in known]
    figures.publish({marker: "\n".join([head, rule, *ordered])})


def main(arguments: list[str] | None = None) -> int:
    """Print a row for each case: planar ones by material points, others in all coordinates, or all as asked."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.hard_twins", description=__doc__)
    parser.add_argument("--only", action="append", choices=list(HARD_SUITE), help="these cases")
    parser.add_argument("--points", action="store_true", help="by material points, planar cases only")
    parser.add_argument("--coordinates", action="store_true", help="in all coordinates and multipliers only")
    parser.add_argument("--publish", action="store_true", help="also write the rows into docs/evidence/silence.md")
    options = parser.parse_args(arguments)
    names = options.only or list(HARD_SUITE)
    both = not options.points and not options.coordinates
    for by_points, wanted in ((True, both or options.points), (False, both or options.coordinates)):
        chosen = [name for name in names if (name in BY_POINTS if by_points else not both or name not in BY_POINTS)]
        if wanted and chosen:
            print("by material points" if by_points else "in all coordinates")
            rows = rows_of(chosen, by_points)
            if options.publish:
                publish("hard_twins.points" if by_points else "hard_twins", rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
