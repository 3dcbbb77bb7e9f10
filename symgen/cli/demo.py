"""`symgen demo`: generate, simulate, report and animate one mechanism from nothing."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command, add_run_options, add_scene
from symgen.cli.outcome import Outcome
from symgen.cli.progress import Progress

DEMOS = {"slider-crank": "flexible_slider_crank"}  # what a demo's name means; any other word is the scene itself


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers, "demo", run, "Generate a built-in scene, simulate it, and show the results.",
        "Leaves model/, report.json, report.md, motion.gif, coordinates.png, energy.png, solution.npz and .csv.")
    add_scene(command, nargs="?", default="slider-crank",
              help="slider-crank (flexible, the default), any other built-in scene, or a .toml file")
    command.add_argument("--out", metavar="DIR", help="folder for everything (default: out/SCENE)")
    add_run_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """The whole path; a scene without bodies to draw gets no animation."""
    from runtime.animation import animate
    from runtime.loading import load_model
    from runtime.report import run_report
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
        if model.has("drawing"):
            animate(solution, folder / "motion.gif")
            files["motion.gif"] = str(folder / "motion.gif")
    lines = [*summary(solution), f"in {folder}: {MODEL_FOLDER}/, {', '.join(files)}"]
    return Outcome({"report": run_report(solution), "folder": str(folder), "files": files}, lines, exit_code(solution))
