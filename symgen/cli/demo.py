"""`symgen demo`: generate, simulate, report and animate one mechanism from nothing."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from symgen.cli.outcome import Outcome, Progress
from symgen.cli.runs import (
    MODEL_FOLDER,
    estimated,
    exit_code,
    leave_results,
    modelling_lines,
    modelling_report,
    run_model,
    summary,
)
from symgen.cli.sources import find_source
from symgen.cli.words import MOTION, settings

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

DEMOS = {"slider-crank": "flexible_slider_crank"}  # what a demo's name means; any other word is the scene itself
SAMPLES = 500  # about so many are kept of the main run


def demo(arguments: argparse.Namespace) -> Outcome:
    """Generate a built-in scene, simulate it, and show the results; `plate` is a structure stepped by regions.

    Leaves model/, report.json, motion.gif, view.html, motion.png, deformation.png, forces.png,
    energy.png, solution.npz and .csv, and a report of methods: methods.md, methods.csv, error_time.png. What is advised
    is the main run; the scene's own scheme is beside it in difference.png.
    """
    if arguments.scene == "plate":
        from symgen.cli.plate_demo import plate_demo

        return plate_demo(arguments.out, arguments.t_end)
    from runtime.model import load_model
    from runtime.studies.advice.report import PAGE, PICTURE, TABLE, report
    from runtime.views import plots
    from runtime.views.report import run_report
    from symgen.generate import generate

    folder = Path(arguments.out) if arguments.out else Path("out") / Path(arguments.scene).stem
    source = find_source(DEMOS.get(arguments.scene, arguments.scene), arguments.made_with)
    with Progress("symgen") as progress:
        progress.note(f"deriving {source.scene.name} ...")
        model = load_model(generate(source.scene, folder / MODEL_FOLDER))
        advice = report(model, folder, note=progress.note, **settings(arguments, MOTION))
    files = {name: str(folder / name) for name in (PAGE, TABLE, PICTURE)}
    chosen = any(getattr(arguments, name) for name in ("scheme", "dt", "m", "options"))
    best = {
        "scheme": advice.method.scheme,
        "m": list(advice.method.m) if advice.method.m else None,
        "options": dict(advice.method.options),
        "dt": advice.dt,
        "samples": SAMPLES,
    }
    solution = run_model(model, arguments if chosen else argparse.Namespace(**vars(arguments) | best))
    lines = summary(solution)
    if not chosen:
        own = run_model(model, arguments)
        lines.append(f"difference.png compares with scheme {own.scheme} at its dt = {own.dt:g} s")
        plots.difference(own, solution, folder / "difference.png")
        files["difference.png"] = str(folder / "difference.png")
    told = estimated(solution, arguments.convergence)
    lines += modelling_lines(told)
    with Progress("symgen") as progress:
        progress.note("drawing ...")
        files |= leave_results(solution, folder, told=told) | _moving(solution, folder)
    lines.append(f"in {folder}: {MODEL_FOLDER}/, {', '.join(files)}")
    return Outcome(
        {"report": run_report(solution) | modelling_report(told), "folder": str(folder), "files": files},
        lines,
        exit_code(solution),
    )


def _moving(solution: Solution, folder: Path) -> dict[str, str]:
    """A film and a page; nothing for a scene without bodies to draw."""
    from runtime.views.animation import animate
    from runtime.views.viewer.page import show

    if not solution.model.has("geometry"):
        return {}
    animate(solution, folder / "motion.gif")
    show(solution, folder / "view.html")
    return {name: str(folder / name) for name in ("motion.gif", "view.html")}
