"""Steps that `simulate`, `animate` and `demo` share: run a model, leave the results, say how it ended."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import UsageError
from symgen.cli.outcome import FAILED, INTERRUPTED, OK
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from runtime.contract.model import Model
    from runtime.results.solution import Solution

BALANCE_REMARK = 0.01
MODEL_FOLDER, SOLUTION_FILE = "model", "solution.npz"


def run_model(model: Model, arguments: argparse.Namespace, **kept: Any) -> Solution:
    """Simulate with the options of `add_run_options`; kept: what of the run is kept where.

    Raises UsageError, and what `simulate` raises.
    """
    from runtime import simulate
    from runtime.engine.compiled import CompilerError

    try:
        with Progress(f"symgen {model.name}") as progress:
            return simulate(
                model,
                t_end=arguments.t_end,
                dt=arguments.dt,
                m=arguments.m,
                scheme=arguments.scheme,
                parameters=dict(arguments.set),
                initial=dict(arguments.initial),
                save_every=arguments.save_every,
                engine=arguments.engine,
                progress=progress,
                options=dict(arguments.option),
                force=arguments.force,
                start=arguments.start,
                tolerance=arguments.tolerance,
                **kept,
            )
    except CompilerError as error:  # asked for a compiled engine where it cannot be had
        raise UsageError(f"{error}; use --engine auto or interpreted") from error


def results_of(folder: str | Path) -> Solution:
    """What `simulate --out` left in a folder. Raises UsageError."""
    from runtime.contract.loading import load_model
    from runtime.results.solution import Solution

    path = Path(folder)
    if not (path / SOLUTION_FILE).is_file():
        raise UsageError(f"{folder} holds no results; make them with: symgen simulate SCENE --out {folder}")
    return Solution.load(path / SOLUTION_FILE, load_model(path / MODEL_FOLDER))


def loaded_or_run(arguments: argparse.Namespace) -> tuple[Solution, Path | None]:
    """The results of a folder with that folder, or those of a scene simulated now. Raises UsageError."""
    from symgen.cli.sources import builtin_name, is_folder, opened_model

    folder = Path(arguments.scene)
    if is_folder(arguments.scene) and (folder / SOLUTION_FILE).is_file() and builtin_name(arguments.scene) is None:
        settings = ("t_end", "dt", "m", "scheme", "set", "initial", "option", "save_every")
        given = [name for name in settings if getattr(arguments, name)]
        if given:
            raise UsageError(
                f"{arguments.scene} holds results that are there already; --{given[0].replace('_', '-')} "
                "needs a SCENE to simulate"
            )
        return results_of(folder), folder
    return run_model(opened_model(arguments.scene, arguments.made_with), arguments), None


def leave_all(solution: Solution, folder: Path, pictures: bool) -> dict[str, str]:
    """Results, pictures if wanted, and the model with what all that asked of it; {what: path}.

    Raises OutputError or SceneError.
    """
    from symgen.cli.sources import leave_model

    try:
        files = leave_results(solution, folder)
        return {**files, **leave_pictures(solution, folder)} if pictures else files
    finally:
        leave_model(solution.model, folder / MODEL_FOLDER)


def leave_results(solution: Solution, folder: Path) -> dict[str, str]:
    """solution.npz, solution.csv, report.json and report.md in `folder`; {what: path}. Raises OutputError."""
    from runtime.views.report import run_report, write_report

    solution.save(folder / SOLUTION_FILE)
    solution.to_csv(folder / "solution.csv")
    write_report(run_report(solution), folder, solution.model.title or solution.model.name)
    names = (SOLUTION_FILE, "solution.csv", "report.json", "report.md")
    return {name: str(folder / name) for name in names}


def leave_pictures(solution: Solution, folder: Path) -> dict[str, str]:
    """motion.png, energy.png and, where there are any, deformation.png and forces.png; {what: path}.

    Raises OutputError.
    """
    from runtime.views import plots

    return {path.name: str(path) for path in plots.usual(solution, folder)}


def exit_code(solution: Solution) -> int:
    """0 for a completed run, 130 for an interrupted one, 1 for any other."""
    if solution.status.ok:
        return OK
    return INTERRUPTED if solution.status.name == "interrupted" else FAILED


def summary(solution: Solution, judged: float | None = None) -> list[str]:
    """A few lines on a run for a person. judged: its error, where a reference knows it better than its estimate."""
    from runtime.contract.coordinates import followed

    model, stats = solution.model, solution.stats
    m = ",".join(map(str, solution.m)) or "-"
    lines = [
        f"{model.title or model.name}: {solution.status}",
        f"scheme {solution.scheme}, dt = {solution.dt:g} s, m = {m}, {stats.get('steps', '?')} steps, "
        f"{stats.get('engine', '?')}, {_seconds(stats.get('wall_seconds'))}",
        f"largest constraint error {float(solution.constraint_error.max(initial=0.0)):.3g}, {_energy(solution)}",
    ]
    balance = float(abs(solution.energy_balance()).max()) if len(solution.t) > 2 else 0.0
    scale = float(solution.energy["kinetic"].max() + abs(solution.energy["elastic"]).max())
    if balance - float(stats.get("work_doubt", 0.0)) > BALANCE_REMARK * scale:
        lines.append(
            f"the energy balance is off by {balance / scale:.2g} of the energy in motion: the step is too long for "
            "the scheme; take a smaller one, or compare with --scheme single_rate"
        )
    if judged is not None:
        lines.append(f"error: {judged:.2g} of the amplitudes, RMS over the motion, against the comparison's reference")
    elif "estimated_error" in stats:
        name = str(stats["estimated_error_of"])
        lines.append(
            f"estimated error: {float(stats['estimated_error']):.2g} of the amplitude of {name} "
            f"(worst near t = {float(stats[f'worst_time.{name}']):.4g} s)"
        )
    if "remark" in stats and judged is None:
        lines.append(str(stats["remark"]))
    lines += [str(event) for event in solution.events]
    if stats.get("initial_changes", "none") != "none":
        lines.append(f"the initial state was corrected: {stats['initial_changes']}")
    if "sub_step_cost" in stats:
        lines.append(f"a sub-step costs {float(stats['sub_step_cost']):.2g} of a full evaluation (operations)")
    if "advice" in stats:
        lines.append(f"chosen automatically: {stats['advice']}")
    if "engine_note" in stats:
        lines.append(str(stats["engine_note"]))
    names = followed(model)[0]
    final = ", ".join(f"{name} = {float(solution[name][-1]):.9g}" for name in names[:7])
    more = ", ..." if len(names) > 7 else ""
    return [*lines, f"at t = {float(solution.t[-1]):.6g} s: {final}{more}"]


def _energy(solution: Solution) -> str:
    """The energy balance, unless the samples between the ends, over which work is integrated, were not kept."""
    total = f"total energy {float(solution.total_energy[-1]):.6g} J"
    if len(solution.t) < 3:
        return f"{total} (no energy balance: only the first and the last state were kept)"
    return f"largest energy balance error {float(abs(solution.energy_balance()).max()):.3g} J ({total})"


def _seconds(value: Any) -> str:
    return f"{value:.3g} s" if isinstance(value, int | float) else "? s"
