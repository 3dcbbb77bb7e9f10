"""`symgen simulate`, `resume`, `cache`, and what other commands share with them: run a model, leave its results."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.outcome import FAILED, INTERRUPTED, OK, Outcome, Progress
from symgen.cli.sources import builtin_name, is_folder, leave_model, opened_model, opened_text, try_leaving_model
from symgen.cli.words import RUN, UsageError, settings

if TYPE_CHECKING:
    from runtime.model import Model
    from runtime.solutions.solution import Solution
    from runtime.studies.convergence import Convergence
    from runtime.views.run_page import NotEstimated

    Told = Convergence | NotEstimated

BALANCE_REMARK = 0.01
MODEL_FOLDER, SOLUTION_FILE = "model", "solution.npz"


def simulate(arguments: argparse.Namespace) -> Outcome:
    """Simulate a scene or a generated model.

    With --out it leaves model/, solution.npz, solution.csv, report.json, page.html and pictures.
    """
    if arguments.plots and not arguments.out:
        raise UsageError("--plots needs --out DIR")
    folder = Path(arguments.out) if arguments.out else None
    model = opened_model(arguments.scene, arguments.made_with)
    if folder:
        try_leaving_model(folder / MODEL_FOLDER)
    inputs = input_samples(arguments.inputs) if arguments.inputs else None
    kept = settings(arguments, ("outputs", "stream", "checkpoint", "checkpoint_every"))
    solution = run_model(model, arguments, inputs=inputs, **kept)
    return _outcome(solution, folder, arguments.plots is not False, arguments.convergence)


def resume(arguments: argparse.Namespace) -> Outcome:
    """Go on with a run from its checkpoint.

    The results are those of an uninterrupted run, bit for bit.
    """
    from runtime import resume
    from runtime.running.checkpoint import read_checkpoint

    folder = Path(arguments.out) if arguments.out else None
    keep = folder / MODEL_FOLDER if folder else None
    if keep:
        try_leaving_model(keep)
    header = read_checkpoint(arguments.file).header
    model = (
        opened_model(arguments.scene, keep=keep, digest=header["digest"])
        if arguments.scene
        else opened_text(header["model"], header["scene_toml"], header["digest"], keep)
    )
    with Progress(f"symgen {model.name}") as progress:
        how = settings(arguments, ("stream", "engine", "checkpoint_every"))
        solution = resume(model, arguments.file, progress=progress, **how)
    return _outcome(solution, folder, pictures=False)


def _outcome(solution: Solution, folder: Path | None, pictures: bool, convergence: str = "half") -> Outcome:
    """What a run ended with; its files if there is a folder for them, with a page the error of the model, too."""
    from runtime.views.report import run_report

    told = estimated(solution, convergence) if folder and pictures else None
    files = leave_all(solution, folder, pictures, told) if folder else {}
    lines = summary(solution) + modelling_lines(told) + ([f"results in {folder}"] if folder else [])
    report = run_report(solution) | modelling_report(told)
    return Outcome({"report": report, "files": files}, lines, exit_code(solution))


def estimated(solution: Solution, convergence: str) -> Told:
    """The error of the model of a run, or why it is not estimated."""
    from runtime.views.run_page import modelling_error

    with Progress("symgen") as progress:
        progress.note("estimating the error of the model ...")
        return modelling_error(solution, convergence)


def modelling_lines(told: Told | None) -> list[str]:
    """What the summary of a run says of the error of the model."""
    if told is None:
        return []
    from runtime.views.run_page import NotEstimated

    return [f"error of the model not estimated: {told.why}"] if isinstance(told, NotEstimated) else told.lines()


def modelling_report(told: Told | None) -> dict[str, Any]:
    """The section of report.json."""
    if told is None:
        return {}
    from runtime.views.run_page import NotEstimated

    return {"modelling_error": {"not_estimated": told.why} if isinstance(told, NotEstimated) else told.to_dict()}


def cache(arguments: argparse.Namespace) -> Outcome:
    """Show what is kept of compiled programs and of models, or remove it.

    Nothing is lost by removing it: what is needed is compiled and generated again.
    """
    from runtime.contract.cache import refused_folder
    from runtime.contract.kept_models import KeptModels
    from runtime.engine.object_cache import MOST_CACHE_BYTES, ObjectCache

    cache, models, variants, sent = ObjectCache(), *map(KeptModels, ("models", "variants", "sent"))
    rooms = [(one, refused_folder(one.folder)) for one in (cache, models, variants, sent)]
    refused = "; ".join(why for _, why in rooms if why)
    entries = cache.entries()
    size = sum(size for _, size, _ in entries)
    facts: dict[str, Any] = {
        "folder": str(cache.folder),
        "programs": len(entries),
        "bytes": size,
        "most": MOST_CACHE_BYTES,
    }
    facts |= {"models": len(models.entries()), "variants": len(variants.entries()), "sent": len(sent.entries())}
    lines = [
        f"{cache.folder}: {len(entries)} compiled programs, {size / 1e6:.3g} of {MOST_CACHE_BYTES / 1e6:.0f} MB; "
        f"{facts['models']} generated models, {facts['variants']} variants and {facts['sent']} models from elsewhere "
        "beside them"
    ]
    if refused:
        facts["refused"] = refused
        lines.append(f"not used: {refused}")
    if arguments.clear:
        facts["removed"] = sum(room.clear() for room, why in rooms if not why)
        lines.append(f"{facts['removed']} removed")
    return Outcome(facts, lines)


def input_samples(path: str) -> dict[str, tuple[list[float], list[float]]]:
    """{input: (times [s], values)} of a CSV with the header `t,name,...` and a row for each time from which they hold.

    Raises UsageError or SceneError for a file that is none.
    """
    from symgen.scene.tables import number_rows
    from symgen.scene.toml_io import text_of

    item = f"--inputs {path}"
    text = text_of(path, item, "a CSV file")
    header = [name.strip() for name in text.partition("\n")[0].split(",")]
    rows = number_rows(item, text, names_above=True)
    if len(header) < 2 or header[0] != "t" or not rows:
        raise UsageError(f"{item}: the first line must name the columns, t,input,... and rows must follow")
    short = next((number for number, row in enumerate(rows, 2) if len(row) != len(header)), None)
    if short is not None:
        raise UsageError(f"{item}: row {short} does not hold {len(header)} numbers")
    times, *columns = ([row[k] for row in rows] for k in range(len(header)))
    return {name: (times, values) for name, values in zip(header[1:], columns, strict=True)}


def run_model(model: Model, arguments: argparse.Namespace, **kept: Any) -> Solution:
    """Simulate with the options of a run; kept: what of the run is kept where.

    Raises UsageError, and what `simulate` raises.
    """
    from runtime import simulate
    from runtime.contract.errors import CompilerError

    try:
        with Progress(f"symgen {model.name}") as progress:
            return simulate(model, progress=progress, **settings(arguments, RUN), **kept)
    except CompilerError as error:  # asked for a compiled engine where it cannot be had
        raise UsageError(f"{error}; use --engine auto or interpreted") from error


def results_of(folder: str | Path) -> Solution:
    """What `simulate --out` left in a folder. Raises UsageError."""
    from runtime.model import load_model
    from runtime.solutions.solution import Solution

    path = Path(folder)
    if not (path / SOLUTION_FILE).is_file():
        raise UsageError(f"{folder} holds no results; make them with: symgen simulate SCENE --out {folder}")
    return Solution.load(path / SOLUTION_FILE, load_model(path / MODEL_FOLDER))


def loaded_or_run(arguments: argparse.Namespace) -> tuple[Solution, Path | None]:
    """The results of a folder with that folder, or those of a scene simulated now. Raises UsageError."""
    folder = Path(arguments.scene)
    if is_folder(arguments.scene) and (folder / SOLUTION_FILE).is_file() and builtin_name(arguments.scene) is None:
        flags = {"parameters": "set", "options": "option"}
        given = [flags.get(name, name) for name in RUN if name != "engine" and getattr(arguments, name)]
        if given:
            raise UsageError(
                f"{arguments.scene} holds results already; --{given[0].replace('_', '-')} needs a SCENE to simulate"
            )
        return results_of(folder), folder
    return run_model(opened_model(arguments.scene, arguments.made_with), arguments), None


def leave_all(solution: Solution, folder: Path, pictures: bool, told: Told | None = None) -> dict[str, str]:
    """Results, pictures if wanted, and the model with what all that asked of it; {what: path}.

    Raises OutputError or SceneError.
    """
    try:
        return leave_results(solution, folder, pictures, told)
    finally:
        leave_model(solution.model, folder / MODEL_FOLDER)


def leave_results(solution: Solution, folder: Path, pictures: bool = True, told: Told | None = None) -> dict[str, str]:
    """solution.npz and .csv, report.json; page.html, motion.png, energy.png, where there are any deformation.png
    and forces.png; {what: path}. told: the error of the model. Raises OutputError.
    """
    from runtime.contract.files import write_text
    from runtime.results.export import as_json
    from runtime.views.report import run_report

    solution.save(folder / SOLUTION_FILE)
    solution.export(folder / "solution.csv")
    write_text(folder / "report.json", as_json(run_report(solution) | modelling_report(told)))
    names = [SOLUTION_FILE, "solution.csv", "report.json"]
    if pictures:
        from runtime.views import plots

        names += [path.name for path in plots.usual(solution, folder)]
        solution.page(folder / "page.html", convergence="off" if told is None else told)
        names.append("page.html")
    return {name: str(folder / name) for name in names}


def exit_code(solution: Solution) -> int:
    """0 for a completed run, 130 for an interrupted one, 1 for any other."""
    if solution.status.ok:
        return OK
    return INTERRUPTED if solution.status.name == "interrupted" else FAILED


def summary(solution: Solution) -> list[str]:
    """A few lines on a run for a person."""
    from runtime.contract.coordinates import followed

    model, stats = solution.model, solution.stats
    m = ",".join(map(str, solution.m)) or "-"
    lines = [
        f"{model.title or model.name}: {solution.status}",
        f"scheme {solution.scheme}, {solution.pace}, m = {m}, {stats.get('steps', '?')} steps, "
        f"{stats.get('engine', '?')}, {_seconds(stats.get('wall_seconds'))}",
        f"largest constraint error {float(solution.constraint_error.max(initial=0.0)):.3g}, {_energy(solution)}",
    ]
    balance = solution.balance
    scale = float(solution.energy["kinetic"].max() + abs(solution.energy["elastic"]).max())
    if len(solution.t) > 2 and balance.largest - balance.uncertainty[-1] > BALANCE_REMARK * scale:
        lines.append(
            f"the energy balance is off by {balance.largest / scale:.2g} of the energy in motion: the step is too long "
            "for the scheme; take a smaller one, or compare with --scheme single_rate"
        )
    if "error" in stats:
        lines.append(f"measured error: {float(stats['error']):.2g} of the amplitude of {stats['error_of']}")
    elif "error_not_measured" in stats:
        lines.append(f"error not measured: {stats['error_not_measured']}")
    if "remark" in stats:
        lines.append(str(stats["remark"]))
    lines += [str(event) for event in solution.events]
    if stats.get("initial_changes", "none") != "none":
        lines.append(f"the initial state was corrected: {stats['initial_changes']}")
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
    return f"largest energy balance error {solution.balance} ({total})"


def _seconds(value: Any) -> str:
    return f"{value:.3g} s" if isinstance(value, int | float) else "? s"
