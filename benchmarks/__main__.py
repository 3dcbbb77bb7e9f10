"""Run the benchmarks: `python -m benchmarks [--only NAME] [--out DIR] [--publish]`."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path

from benchmarks.cases import (
    arms,
    ensemble,
    exudyn_slider_crank,
    generation,
    gradients,
    hard_steps,
    iftomm,
    jumps,
    native_code,
    operations,
    others,
    rhs_chain,
    rhs_pinocchio,
    sizes,
    step_slider_crank,
    tolerance,
)
from benchmarks.harness.machine import describe_machine
from benchmarks.harness.page import as_json, as_markdown, with_sections
from benchmarks.harness.result import Benchmark, Result, Skipped
from benchmarks.pages import (
    bad_input,
    estimates,
    hard_tables,
    hard_twins,
    long_runs,
    orientations,
    spherical_trees,
    stress_modes,
    sub_steps,
)

BENCHMARKS: dict[str, Benchmark] = {
    "step_slider_crank": step_slider_crank.run,
    "native_code": native_code.run,
    "ensemble": ensemble.run,
    "rhs_chain": rhs_chain.run,
    "generation": generation.run,
    "sizes": sizes.run,
    "gradients": gradients.run,
    "rhs_pinocchio": rhs_pinocchio.run,
    "operations": operations.run,
    "arms": arms.run,
    "hard_steps": hard_steps.run,
    "tolerance": tolerance.run,
    "jumps": jumps.run,
    "others": others.run,
    "iftomm": iftomm.run,
    "exudyn_slider_crank": exudyn_slider_crank.run,
}
PAGES: dict[str, Callable[[list[str]], int]] = {
    "hard_tables": hard_tables.main,
    "long_runs": long_runs.main,
    "estimates": estimates.main,
    "bad_input": bad_input.main,
    "hard_twins": hard_twins.main,
    "stress_modes": stress_modes.main,
    "sub_steps": sub_steps.main,
    "orientations": orientations.main,
    "spherical_trees": spherical_trees.main,
}
PAGE = Path(__file__).resolve().parents[1] / "docs" / "evidence" / "benchmarks.md"


def main(arguments: list[str] | None = None) -> int:
    """Run, print, and write results.json and results.md; --publish also writes the page or its sections."""
    options = _parser().parse_args(arguments)
    chosen = options.only or [*BENCHMARKS, *PAGES]
    for name in filter(PAGES.__contains__, chosen):
        print(f"computing the page {name} ...", file=sys.stderr, flush=True)
        PAGES[name](["--publish"] if options.publish else [])
    measured = [name for name in chosen if name in BENCHMARKS]
    if measured:
        _measure(measured, options)
    return 0


def _measure(names: list[str], options: argparse.Namespace) -> None:
    machine, skipped = describe_machine(), []
    results: list[Result] = []
    for name in names:
        print(f"running {name} ...", file=sys.stderr, flush=True)
        try:
            results.append(BENCHMARKS[name]())
        except Skipped as reason:
            print(f"skipped {name}: {reason}", file=sys.stderr)
            skipped.append(name)
    page = as_markdown(machine, results)
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "results.json").write_text(json.dumps(as_json(machine, results), indent=1) + "\n", encoding="utf-8")
    (options.out / "results.md").write_text(page, encoding="utf-8")
    if options.publish and skipped:
        print(f"{PAGE.name} is left as it is: it needs {', '.join(skipped)} too", file=sys.stderr)
    elif options.publish:
        whole = with_sections(PAGE.read_text(encoding="utf-8"), machine, results) if options.only else page
        PAGE.write_text(whole, encoding="utf-8")
    print(page)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument(
        "--only",
        action="append",
        choices=[*BENCHMARKS, *PAGES],
        metavar="NAME",
        help=f"run only this one; may be repeated ({', '.join(BENCHMARKS)}; pages: {', '.join(PAGES)})",
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("out/benchmarks"),
        metavar="DIR",
        help="folder for results.json and results.md (default: %(default)s)",
    )
    parser.add_argument(
        "--publish",
        action="store_true",
        help="also write docs/evidence/benchmarks.md; with --only, the other sections stay",
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
