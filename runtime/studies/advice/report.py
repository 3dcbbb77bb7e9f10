"""A report of methods on a model: true error, by an independent reference, against the time of their steps."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from math import isfinite
from pathlib import Path

from runtime.contract.arguments import BY_NAME, NAMES, arguments
from runtime.contract.escapes import markdown
from runtime.contract.files import write_text
from runtime.contract.model import EmittedModel
from runtime.studies.advice.advice_text import advice_lines
from runtime.studies.advice.advise import Advice, Note, advise
from runtime.studies.advice.reference import independent_reference
from runtime.studies.advice.trial import Trial

PICTURE, TABLE, PAGE = "error_time.png", "methods.csv", "methods.md"


@arguments(graded=NAMES, parameters=BY_NAME, initial=BY_NAME)
def report(
    model: EmittedModel,
    folder: str | Path | None = None,
    *,
    tolerance: float = 1e-3,
    graded: Sequence[str] | None = None,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    note: Note = lambda text: None,
) -> Advice:
    """Make the motion by every method with ever more steps; tell the true error and the time of each.

    Parameters
    ----------
    model : Model
        The mechanism.
    folder : path, optional
        Left there are methods.md, methods.csv and error_time.png.
    tolerance, graded, t_end, parameters, initial, start, note : optional
        As of `advise`.

    Returns
    -------
    Advice
        That of `advise`, with `trials` of each method: every motion against the reference, by the time of its steps
        alone.

    Raises
    ------
    NoReference, ModelError, OutputError
        Where no reference can be made, for models with events, for a folder that takes nothing; and what `advise`
        raises.

    Notes
    -----
    The reference is independent of the project's schemes: SciPy's DOP853 at 1e-11.
    """
    note("computing the reference")
    reference = independent_reference(
        model, t_end=t_end, parameters=parameters, initial=initial, start=start, graded=graded
    )
    found: Advice = advise(model, tolerance=tolerance, graded=graded, note=note, reference=reference)
    if folder is not None:
        leave(found, Path(folder))
    return found


def leave(found: Advice, folder: Path) -> dict[str, str]:
    """The files of a report, by name. Raises OutputError."""
    write_text(folder / PAGE, as_markdown(found))
    write_text(folder / TABLE, as_csv(found))
    found.picture(folder / PICTURE)
    return {name: str(folder / name) for name in (PAGE, TABLE, PICTURE)}


def trials_of(found: Advice) -> list[Trial]:
    """All motions that were made, method by method."""
    return [trial for one in found.candidates for trial in one.trials]


def as_markdown(found: Advice) -> str:
    """The page."""
    off = found.reference.off if found.reference is not None else float("nan")
    lines = [
        f"# {markdown(found.model.title or found.model.name)}: error against time",
        "",
        f"{found.t_end:g} s of motion. The error is RMS over the motion, over the amplitude, of the worst of",
        f"{', '.join(found.graded)}, against DOP853 of SciPy, which is itself off by {off:.1g}.",
        "Time is processor time of the steps alone.",
        "",
        f"![error against time]({PICTURE})",
        "",
        "| method | step [s] | steps | time [ms] | error | what the run says of it |",
        "|---|---:|---:|---:|---:|---:|",
    ]
    for trial in trials_of(found):
        estimated = markdown(trial.failure) or (f"{trial.estimated:.2g}" if isfinite(trial.estimated) else "")
        size = f"{trial.setting:.3g} | {trial.steps} | {1e3 * trial.seconds:.3g}"
        lines.append(f"| {trial.label} | {size} | {trial.error:.2g} | {estimated} |")
    return "\n".join([*lines, "", "```", *advice_lines(found), "```", ""])


def as_csv(found: Advice) -> str:
    """One row a motion."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["method", "dt [s]", "steps", "seconds [s]", "error", "error_at_end", "told", "failure"])
    for one in trials_of(found):
        row = [one.label, one.setting, one.steps, one.seconds, one.error, one.end_error, one.estimated, one.failure]
        writer.writerow(row)
    return text.getvalue()
