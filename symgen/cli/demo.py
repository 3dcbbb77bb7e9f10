"""`symgen demo`: generate, simulate, report and animate one mechanism from nothing."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.outcome import Outcome, Progress
from symgen.cli.runs import MODEL_FOLDER, exit_code, leave_results, run_model, summary
from symgen.cli.sources import find_source
from symgen.cli.words import MOTION, motion_words, settings

if TYPE_CHECKING:
    from runtime.contract.model import Model
    from runtime.results.solution import Solution
    from runtime.studies.work_precision.comparison import Comparison

DEMOS = {"slider-crank": "flexible_slider_crank"}  # what a demo's name means; any other word is the scene itself
METHODS = ["exponential:1", "exponential:2", "single_rate", "rk4", "radau"]  # and sub-cycling, where there are groups
LONGEST = 0.02  # s: where a method's curve ends
SAMPLES = 500  # about so many are kept of the main run


def demo(arguments: argparse.Namespace) -> Outcome:
    """Generate a built-in scene, simulate it, and show the results.

    Leaves model/, report.json, report.md, motion.gif, view.html, motion.png, deformation.png, forces.png,
    energy.png, solution.npz and .csv, and a comparison of methods: comparison.html, .md, .csv, .json,
    error_time.png, error_evaluations.png. What it recommends is the main run; the scene's own scheme is beside it
    in difference.png.
    """
    from runtime.contract.loading import load_model
    from runtime.views import plots
    from runtime.views.report import run_report
    from symgen.generate import generate

    folder = Path(arguments.out) if arguments.out else Path("out") / Path(arguments.scene).stem
    source = find_source(DEMOS.get(arguments.scene, arguments.scene), arguments.made_with)
    with Progress("symgen") as progress:
        progress.note(f"deriving {source.scene.name} ...")
        model = load_model(generate(source.scene, folder / MODEL_FOLDER))
        files, best, judged = _compared(model, arguments, folder, progress)
    chosen = any(getattr(arguments, name) for name in ("scheme", "dt", "m", "options"))
    solution = run_model(model, arguments if chosen or best is None else argparse.Namespace(**vars(arguments) | best))
    lines = summary(solution, None if chosen else judged)
    if best is not None and not chosen:
        own = run_model(model, arguments)
        lines.append(f"{own.scheme} with dt = {own.dt:g} s, as the scene has it, stands beside it in difference.png")
        plots.difference(own, solution, folder / "difference.png")
        files["difference.png"] = str(folder / "difference.png")
    with Progress("symgen") as progress:
        progress.note("drawing ...")
        files |= leave_results(solution, folder) | _moving(solution, folder)
    lines.append(f"in {folder}: {MODEL_FOLDER}/, {', '.join(files)}")
    return Outcome({"report": run_report(solution), "folder": str(folder), "files": files}, lines, exit_code(solution))


def _moving(solution: Solution, folder: Path) -> dict[str, str]:
    """A film and a page; nothing for a scene without bodies to draw."""
    from runtime.views.animation import animate
    from runtime.views.viewer.page import write_view

    if not solution.model.has("geometry"):
        return {}
    animate(solution, folder / "motion.gif")
    write_view(solution, folder / "view.html")
    return {name: str(folder / name) for name in ("motion.gif", "view.html")}


def _compared(
    model: Model, arguments: argparse.Namespace, folder: Path, progress: Progress
) -> tuple[dict[str, str], dict[str, Any] | None, float | None]:
    """A short comparison of methods on the same motion: its files, the arguments of a run as it recommends, and the
    error of that run.
    """
    from runtime.studies.work_precision.comparison import work_precision
    from runtime.studies.work_precision.comparison_files import write_comparison
    from runtime.studies.work_precision.methods import methods_named

    if not model.has("dQ_hat_dq_i"):
        return {}, None, None
    names = METHODS + (["coupled:4", "printed:4"] if len(model.groups) == 2 else [])
    comparison = work_precision(
        model, methods_named(model, names), longest=LONGEST, note=progress.note, **settings(arguments, MOTION)
    )
    files = write_comparison(comparison, folder, motion_words(arguments, DEMOS.get(arguments.scene, "")))
    return files, *_recommended(comparison)


def _recommended(comparison: Comparison) -> tuple[dict[str, Any] | None, float | None]:
    """Scheme, m, options and the coarsest step from which on all runs kept the tolerance, and the error of that run."""
    first = comparison.ranked()[0]
    method, trials = first.method, first.trials
    fine = [k for k in range(len(trials)) if all(one.error <= comparison.tolerance for one in trials[k:])]
    if method is None or not fine:
        return None, None
    trial = trials[fine[0]]
    arguments = {
        "scheme": method.scheme,
        "m": list(method.m) if method.m else None,
        "options": dict(method.options),
        "dt": trial.setting,
        "samples": min(trial.steps, SAMPLES),
    }
    return arguments, trial.error
