"""`symgen report`: error against time for many methods on a scene, or on the hard suite."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import (
    UsageError,
    add_accuracy_options,
    add_command,
    add_motion_options,
    add_scene,
    motion_words,
    names,
    number,
)
from symgen.cli.outcome import Outcome
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from runtime.contract.model import Model
    from runtime.studies.work_precision.comparison import Comparison
    from runtime.studies.work_precision.problem import Setting
    from runtime.studies.work_precision.suite import SuiteResult


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "report",
        run,
        "Compare methods on a scene: error against CPU time and evaluations.",
        "Every method runs the motion with ever finer steps, judged by an independent reference. Leaves "
        "comparison.json, .csv, .md, .html, error_time.png and error_evaluations.png in --out.",
    )
    add_scene(command, nargs="?")
    command.add_argument("--suite", choices=("hard",), help="the hard suite instead of a scene")
    command.add_argument("--cases", type=names, metavar="NAMES", help="only these cases of the suite")
    command.add_argument(
        "--methods",
        type=names,
        metavar="NAMES",
        help="methods such as exponential:2,coupled:4,rk4,cvodes_bdf; compiled for all but the "
        "adaptive ones (default: all that make sense)",
    )
    command.add_argument(
        "--longest",
        type=number,
        default=0.3,
        metavar="SECONDS",
        help="a method's curve ends with a run this long (default: %(default)s)",
    )
    command.add_argument("--out", metavar="DIR", help="folder for the report (default: out/report/SCENE)")
    add_accuracy_options(command)
    add_motion_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """One comparison, or one for each case of the suite."""
    if (arguments.suite is None) == (arguments.scene is None):
        raise UsageError("give a scene, or --suite hard")
    if arguments.cases and not arguments.suite:
        raise UsageError("--cases belongs to --suite")
    return _suite(arguments) if arguments.suite else _scene(arguments)


def _scene(arguments: argparse.Namespace) -> Outcome:
    from runtime.studies.work_precision.comparison_files import comparison_data, write_comparison
    from runtime.studies.work_precision.dense_methods import left_out
    from runtime.studies.work_precision.problem import make_setting
    from symgen.cli.sources import opened_model

    model = opened_model(arguments.scene, arguments.made_with)
    setting = make_setting(
        model,
        t_end=arguments.t_end,
        parameters=dict(arguments.set),
        initial=dict(arguments.initial),
        start=arguments.start,
        graded=arguments.graded,
    )
    folder = Path(arguments.out) if arguments.out else Path("out") / "report" / model.name
    comparison = _compared(model, setting, arguments, folder)
    files = write_comparison(comparison, folder, motion_words(arguments))
    said = [] if arguments.methods else [one for one in [left_out(model)] if one]
    data = {"comparison": comparison_data(comparison), "files": files}
    return Outcome(data, [*table(comparison), *said, f"in {folder}"])


def _compared(model: Model, setting: Setting, arguments: argparse.Namespace, folder: Path) -> Comparison:
    """Its tables are in the folder after each method: an interrupted report keeps what it has."""
    from runtime.studies.work_precision.comparison import work_precision
    from runtime.studies.work_precision.comparison_files import write_tables
    from runtime.studies.work_precision.methods import methods_named, usual_methods

    methods = methods_named(model, arguments.methods) if arguments.methods else usual_methods(model)
    with Progress(f"symgen {model.name}") as progress:
        return work_precision(
            setting,
            methods,
            arguments.tolerance,
            arguments.longest,
            progress.note,
            lambda found: write_tables(found, folder),
        )


def table(comparison: Comparison) -> list[str]:
    """Methods by time to the tolerance, and the recommendation."""
    lines = [f"{'method':36} {'ms':>9} {'evaluations':>12} {'order':>6}   to an error of {comparison.tolerance:g}"]
    for curve in comparison.ranked():
        seconds, count = curve.seconds_to(comparison.tolerance), curve.evaluations_to(comparison.tolerance)
        reached = f"{seconds * 1e3:9.3g} {count:12.4g}" if seconds < float("inf") else f"{'-':>9} {'-':>12}"
        order = f"{curve.order:6.2f}" if curve.order == curve.order else f"{'-':>6}"
        lines.append(f"{curve.method.label:36} {reached} {order}   {curve.failure}".rstrip())
    return [*lines, f"recommended: {comparison.recommendation()}"]


def _suite(arguments: argparse.Namespace) -> Outcome:
    from runtime.studies.work_precision.suite import suite_markdown, write_suite
    from symgen.scenes.hard_suite import HARD_SUITE

    chosen = arguments.cases or list(HARD_SUITE)
    unknown = [name for name in chosen if name not in HARD_SUITE]
    if unknown:
        raise UsageError(f"the hard suite has no case {unknown[0]!r}; it has {', '.join(HARD_SUITE)}")
    folder = Path(arguments.out) if arguments.out else Path("out") / "report" / "hard"
    results: list[SuiteResult] = []
    for name in chosen:  # what is done is kept when a later case is interrupted
        results.append(_case(name, folder / name, arguments))
        files = write_suite(results, folder)
    rows = suite_markdown(results).rstrip().splitlines()[4:]
    return Outcome({"cases": [result.row() for result in results], "files": files}, [*rows, f"in {folder}"])


def _case(name: str, folder: Path, arguments: argparse.Namespace) -> SuiteResult:
    from runtime.contract.errors import NoResult
    from runtime.contract.loading import load_model
    from runtime.studies.advice.advise import advise
    from runtime.studies.work_precision.comparison_files import write_comparison
    from runtime.studies.work_precision.problem import make_setting
    from runtime.studies.work_precision.suite import SuiteResult
    from symgen.generate import generate
    from symgen.scenes.hard_suite import HARD_SUITE

    case = HARD_SUITE[name]
    motion: dict[str, Any] = {
        "t_end": case.t_end,
        "start": case.start,
        "graded": list(case.graded),
        "parameters": dict(case.parameters),
        "initial": dict(case.initial),
    }
    with tempfile.TemporaryDirectory() as place:
        model = load_model(generate(case.make(), Path(place) / "model"))
    try:
        comparison = _compared(model, make_setting(model, **motion), arguments, folder)
    except NoResult as error:
        return SuiteResult(name, None, None, str(error))
    write_comparison(comparison, folder)
    try:
        with Progress(f"symgen {name}") as progress:
            return SuiteResult(
                name, comparison, advise(model, tolerance=arguments.tolerance, note=progress.note, **motion)
            )
    except NoResult as error:
        return SuiteResult(name, comparison, None, str(error))
