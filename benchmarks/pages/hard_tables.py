"""Computes the page of the hard suite: `python -m benchmarks.pages.hard_tables [--only CASE] [--publish]`."""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.scenes.hard_suite import HARD_SUITE, HardCase
from runtime import Solution, load_model, reference_solution
from runtime.model import Model
from symgen.generate import generate
from tests.support.modes import modes_at

PAGE = Path(__file__).resolve().parents[2] / "docs" / "evidence" / "hard-suite.md"
TOLERANCES = (1e-9, 1e-11)  # rtol; atol is 1/100 of it
SAMPLES, EVERY = 1001, 10  # frequencies at every tenth sample
SHOWN = 6  # frequencies listed in full up to here, else the lowest and the highest

HEADER = (
    "| case | scene | start | t_end [s] | frequencies at the start [rad/s] | largest over the motion "
    "| rate [1/s] | agreement | evaluations |",
    "|---|---|---|---:|---|---|---:|---:|---:|",
)
REASONS = (
    "| case | why it is hard | changes of the scene | amplitude, end value of graded coordinates |",
    "|---|---|---|---|",
)
GRADED = 5  # graded coordinates told of

INTRODUCTION = """# Hard suite

Written by `python -m benchmarks.pages.hard_tables --publish`; every number is computed. The cases are `HARD_SUITE` in
`benchmarks/scenes/hard_suite.py`; `test_hard_suite_schemes_agree` runs each of them for a short time.

A scheme is judged on the graded coordinates: the rigid and lateral ones of q_i. Axial coordinates are not graded, and
of the two oscillators only the slow one is.

Frequencies are `Modes.undamped` of `tests/support/modes.py`: those of the condensed equations linearised
without their velocity terms, at the start and the largest of each over the motion. Zero is a direction without
stiffness or with negative stiffness. Where something dissipates, the rate is the fastest decay at the start, the
largest -Re of the eigenvalues of the linearised equations: an `rk4` step must stay below 2.785 / rate, while central
difference takes the damper implicitly, by its Newton step on the velocities.

The reference is DOP853 on the emitted functions at rtol = {fine:g}; agreement is the largest difference, anywhere in
the motion, to rtol = {coarse:g}, relative to a coordinate's amplitude (half of largest less smallest). Evaluations are
those of the finer reference.
"""


@dataclass(frozen=True)
class Measured:
    """What the page says about a case."""

    case: HardCase
    solution: Solution
    agreement: float
    start: np.ndarray
    largest: np.ndarray
    decay: float | None


def reference(model: Model, case: HardCase, rtol: float, samples: int = SAMPLES) -> Solution:
    """The reference motion of a case. Raises RuntimeError if it does not reach t_end."""
    solution = reference_solution(
        model,
        t_end=case.t_end,
        times=np.linspace(0.0, case.t_end, samples),
        rtol=rtol,
        atol=rtol / 100,
        parameters=case.parameters,
        initial=case.initial,
        start=case.start,
    )
    if solution.status.name != "completed":
        raise RuntimeError(f"{case.name}: {solution.status}")
    return solution


def amplitude(values: np.ndarray) -> float:
    """Half of largest less smallest."""
    return float(np.ptp(values)) / 2


def measure(case: HardCase, folder: Path) -> Measured:
    """Generate the scene, compute both references and the frequencies along the finer one."""
    model = load_model(generate(case.make(), folder / case.name))
    coarse, fine = (reference(model, case, rtol) for rtol in TOLERANCES)
    agreement = max(float(np.abs(coarse[name] - fine[name]).max()) / amplitude(fine[name]) for name in case.graded)
    modes = modes_at(fine, range(0, SAMPLES, EVERY))
    along = np.array([one.undamped for one in modes])
    damped = bool(np.any(fine.energy["power_dissipated"] > 0))
    return Measured(case, fine, agreement, along[0], along.max(axis=0), modes[0].fastest_decay if damped else None)


def row(one: Measured) -> str:
    """A case in the table."""
    case = one.case
    decay = "-" if one.decay is None else f"{one.decay:.4g}"
    return (
        f"| {case.name} | `{one.solution.model.name}` | {case.start} | {case.t_end:g} | "
        f"{_listed(one.start)} | {_listed(one.largest)} | {decay} | {one.agreement:.0e} | "
        f"{one.solution.stats['evaluations']} |"
    )


def reason(one: Measured) -> str:
    """A case in the second table: why it is hard, its changes to the scene, the first graded coordinates."""
    case, solution = one.case, one.solution
    changes = [
        ", ".join(f"`{name}` = {value:.6g}" for name, value in values.items())
        for values in (case.parameters, case.initial)
        if values
    ]
    shown = list(case.graded)[:GRADED]
    told = "; ".join(f"`{name}` {amplitude(solution[name]):.3g}, {solution[name][-1]:.6g}" for name in shown)
    return f"| {case.name} | {case.why[0].upper()}{case.why[1:]} | {'; '.join(changes)} | {told} |"


def _listed(values: np.ndarray) -> str:
    if len(values) <= SHOWN:
        return ", ".join(f"{value:.4g}" for value in values)
    return f"{values[0]:.4g} to {values[-1]:.4g} ({len(values)})"


def page(rows: Mapping[str, str], reasons: Mapping[str, str]) -> str:
    """The page docs/evidence/hard-suite.md, from the rows of its cases by name."""
    introduction = INTRODUCTION.format(coarse=TOLERANCES[0], fine=TOLERANCES[1])
    return "\n".join([introduction, *HEADER, *rows.values(), "", *REASONS, *reasons.values(), ""])


def published() -> tuple[dict[str, str], dict[str, str]]:
    """(rows, reasons) by case, as the page has them."""
    first, second = (part.splitlines() for part in PAGE.read_text(encoding="utf-8").split(REASONS[0]))
    return by_case(first), by_case(second)


def by_case(lines: list[str]) -> dict[str, str]:
    """Rows of a table by the case that they begin with."""
    return {name: line for line in lines for name in HARD_SUITE if line.startswith(f"| {name} |")}


def main(arguments: list[str] | None = None) -> int:
    """Compute and print the page; --publish also writes it."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.hard_tables", description=__doc__)
    parser.add_argument("--only", action="append", choices=list(HARD_SUITE), metavar="CASE")
    parser.add_argument(
        "--publish",
        action="store_true",
        help="also write docs/evidence/hard-suite.md; with --only, the other cases stay as they are",
    )
    options = parser.parse_args(arguments)
    chosen = options.only or list(HARD_SUITE)
    rows, reasons = published() if options.publish and options.only else ({}, {})
    with tempfile.TemporaryDirectory() as folder:
        for name in chosen:
            print(f"{name} ...", file=sys.stderr, flush=True)
            one = measure(HARD_SUITE[name], Path(folder))
            rows[name], reasons[name] = row(one), reason(one)
    names = [name for name in HARD_SUITE if name in rows]
    text = page({name: rows[name] for name in names}, {name: reasons[name] for name in names})
    if options.publish:
        PAGE.write_text(text, encoding="utf-8")
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
