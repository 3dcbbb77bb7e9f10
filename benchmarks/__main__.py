"""Run the benchmarks: `python -m benchmarks [--only NAME] [--out DIR] [--publish] [--kept] [--smallest]`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path

from benchmarks.cases import (
    arms,
    ensemble,
    ensemble_tolerance,
    events,
    exported_c,
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
    scaling,
    sizes,
    step_slider_crank,
    tolerance,
)
from benchmarks.harness import figures
from benchmarks.harness.kept import keep, kept
from benchmarks.harness.machine import describe_machine
from benchmarks.harness.page import as_markdown, with_sections
from benchmarks.harness.result import Benchmark, Result, Skipped
from benchmarks.harness.smallest import smallest
from benchmarks.pages import (
    bad_input,
    estimates,
    hard_tables,
    hard_twins,
    long_runs,
    orientations,
    spherical_trees,
    stress_modes,
    urdf_robots,
)
from benchmarks.tables import arms as arms_tables
from benchmarks.tables import hard_steps as hard_steps_tables
from benchmarks.tables import others as others_tables
from benchmarks.tables import scaling as scaling_tables
from benchmarks.tables import tolerance as tolerance_tables

BENCHMARKS: dict[str, Benchmark] = {
    "step_slider_crank": step_slider_crank.run,
    "native_code": native_code.run,
    "exported_c": exported_c.run,
    "ensemble": ensemble.run,
    "ensemble_tolerance": ensemble_tolerance.run,
    "rhs_chain": rhs_chain.run,
    "generation": generation.run,
    "sizes": sizes.run,
    "scaling": scaling.run,
    "gradients": gradients.run,
    "rhs_pinocchio": rhs_pinocchio.run,
    "operations": operations.run,
    "arms": arms.run,
    "hard_steps": hard_steps.run,
    "tolerance": tolerance.run,
    "jumps": jumps.run,
    "events": events.run,
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
    "orientations": orientations.main,
    "spherical_trees": spherical_trees.main,
    "urdf_robots": urdf_robots.main,
}
WRITTEN = frozenset({"hard_tables", "long_runs", "hard_twins"})  # computed pages that --publish writes
FIGURES: dict[str, dict[str, Callable[[Result], str]]] = {  # what pages have of benchmarks, by marker
    "arms": arms_tables.FIGURES,
    "hard_steps": hard_steps_tables.FIGURES,
    "others": others_tables.FIGURES,
    "scaling": scaling_tables.FIGURES,
    "tolerance": tolerance_tables.FIGURES,
}
PICTURES: dict[str, Callable[[Result, Path], None]] = {"scaling": scaling_tables.picture}  # in docs/images
PAGE = Path(__file__).resolve().parents[1] / "docs" / "evidence" / "benchmarks.md"


def main(arguments: list[str] | None = None) -> int:
    """Run, print, and keep every result as soon as it is there; --publish also writes pages or their sections."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.smallest and options.publish:
        parser.error("--smallest measures nothing that could be published")
    chosen = options.only or [*BENCHMARKS, *PAGES]
    for name in filter(PAGES.__contains__, chosen):
        print(f"computing the page {name} ...", file=sys.stderr, flush=True)
        if options.publish and name not in WRITTEN:
            print(f"{name} writes no page: its figures are printed", file=sys.stderr)
        PAGES[name](["--publish"] if options.publish and name in WRITTEN else [])
    measured = [name for name in chosen if name in BENCHMARKS]
    if measured:
        _measure(measured, options)
    return 0


def _measure(names: list[str], options: argparse.Namespace) -> None:
    here, missing = describe_machine(), []
    results: list[Result] = []
    for name in names:
        found = kept(options.out, name) if options.kept else _run(name, here, options.smallest)
        if found is None:
            missing.append(name)
            continue
        machine, result = found
        results.append(result)
        if not options.kept and not options.smallest:
            keep(options.out, machine, result, results)
        if options.publish:
            PAGE.write_text(with_sections(PAGE.read_text(encoding="utf-8"), machine, [result]), encoding="utf-8")
            _publish_figures(machine, result)
    page = as_markdown(here, results)
    if options.publish and missing:
        print(f"other sections of {PAGE.name} stay: there is nothing of {', '.join(missing)}", file=sys.stderr)
    elif options.publish and not options.only and not options.kept:
        PAGE.write_text(page, encoding="utf-8")
    print(page)


def _run(name: str, machine: dict[str, str], least: bool) -> tuple[dict[str, str], Result] | None:
    print(f"running {name} ...", file=sys.stderr, flush=True)
    run = BENCHMARKS[name]
    try:
        with smallest(sys.modules[run.__module__]) if least else nullcontext():
            return machine, run()
    except Skipped as reason:
        print(f"skipped {name}: {reason}", file=sys.stderr)
        return None


def _publish_figures(machine: dict[str, str], result: Result) -> None:
    """The tables that pages have of a benchmark, each with where it was measured."""
    by = f"Written by `python -m benchmarks --only {result.name} --publish`, on {machine['processor']}."
    written = {marker: f"{make(result)}\n{by}" for marker, make in FIGURES.get(result.name, {}).items()}
    if result.name in PICTURES:
        PICTURES[result.name](result, figures.DOCS / "images" / f"{result.name}.png")
    for page in figures.publish(written):
        print(f"figures of {result.name} are in {page.name}", file=sys.stderr)


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
        help="folder for NAME.json of each benchmark, results.json and results.md (default: %(default)s)",
    )
    parser.add_argument(
        "--publish",
        action="store_true",
        help="also write docs/evidence/benchmarks.md (with --only, the other sections stay) and the tables between the "
        "markers of a benchmark in other pages, each as soon as it is measured",
    )
    parser.add_argument(
        "--kept", action="store_true", help="measure nothing: take what an earlier run left in the folder of --out"
    )
    parser.add_argument(
        "--smallest",
        action="store_true",
        help="the smallest work of each, to see whether it runs: its figures say nothing, and are not kept",
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
