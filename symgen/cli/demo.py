"""`symgen demo`: generate, simulate, report and animate one mechanism from nothing."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import add_command, add_run_options, add_scene, motion_words
from symgen.cli.outcome import Outcome
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from runtime.contract.model import Model

DEMOS = {"slider-crank": "flexible_slider_crank"}  # what a demo's name means; any other word is the scene itself
METHODS = ["exponential:1", "linearised:2", "single_rate", "rk4", "radau"]  # and sub-cycling, where there are groups
LONGEST = 0.02  # s: where a method's curve ends


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "demo",
        run,
        "Generate a built-in scene, simulate it, and show the results.",
        "Leaves model/, report.json, report.md, motion.gif, view.html, motion.png, deformation.png, forces.png, "
        "energy.png, solution.npz and .csv, and a "
        "comparison of methods: comparison.html, .md, .csv, .json, error_time.png, error_evaluations.png.",
    )
    add_scene(
        command,
        nargs="?",
        default="slider-crank",
        help="slider-crank (flexible, the default), any other built-in scene, or a .toml file",
    )
    command.add_argument("--out", metavar="DIR", help="folder for everything (default: out/SCENE)")
    add_run_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """The whole path; a scene without bodies to draw gets no animation."""
    from runtime.contract.loading import load_model
    from runtime.views.animation import animate
    from runtime.views.report import run_report
    from symgen.cli.running import MODEL_FOLDER, exit_code, leave_pictures, leave_results, run_model, summary
    from symgen.cli.sources import find_source
    from symgen.generate import generate

    folder = Path(arguments.out) if arguments.out else Path("out") / Path(arguments.scene).stem
    source = find_source(DEMOS.get(arguments.scene, arguments.scene), arguments.made_with)
    with Progress("symgen") as progress:
        progress.note(f"deriving {source.scene.name} ...")
        model = load_model(generate(source.scene, folder / MODEL_FOLDER))
    solution = run_model(model, arguments)
    with Progress("symgen") as progress:
        progress.note("drawing ...")
        files = leave_results(solution, folder) | leave_pictures(solution, folder)
        if model.has("geometry"):
            animate(solution, folder / "motion.gif")
            files["motion.gif"] = str(folder / "motion.gif")
        files |= _compared(model, arguments, folder, progress)
    lines = [*summary(solution), f"in {folder}: {MODEL_FOLDER}/, {', '.join(files)}"]
    return Outcome({"report": run_report(solution), "folder": str(folder), "files": files}, lines, exit_code(solution))


def _compared(model: Model, arguments: argparse.Namespace, folder: Path, progress: Progress) -> dict[str, str]:
    """A short comparison of methods on the same motion."""
    from runtime.studies.work_precision.comparison import work_precision
    from runtime.studies.work_precision.comparison_files import write_comparison
    from runtime.studies.work_precision.methods import methods_named
    from runtime.studies.work_precision.problem import make_setting

    if not model.has("dQ_hat_dq_i"):
        return {}
    setting = make_setting(
        model,
        t_end=arguments.t_end,
        parameters=dict(arguments.set),
        initial=dict(arguments.initial),
        start=arguments.start,
    )
    names = METHODS + (["coupled:4", "printed:4"] if len(model.groups) == 2 else [])
    comparison = work_precision(setting, methods_named(model, names), longest=LONGEST, note=progress.note)
    return write_comparison(comparison, folder, motion_words(arguments, DEMOS.get(arguments.scene, "")))
