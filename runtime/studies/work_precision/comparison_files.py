"""A comparison as plain values, CSV and Markdown, and the folder that holds these with the page and the pictures."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.files import write_text
from runtime.results.export import as_json
from runtime.studies.work_precision.comparison import Comparison, WorkCurve
from runtime.studies.work_precision.comparison_page import comparison_page
from runtime.studies.work_precision.comparison_pictures import picture_evaluations, picture_times

STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#1f2937}"
    "table{border-collapse:collapse;margin:1em 0;font-size:13px}td,th{border:1px solid #d1d5db;padding:.25em .6em;"
    "text-align:right}td:first-child,th:first-child{text-align:left}img{max-width:100%}"
    "tr.failed td{color:#9ca3af}code{background:#f3f4f6;padding:0 .2em}"
)
ERRORS = ("error", "end_error", "told_error")
HEADER = [
    "method",
    "time to tolerance [ms]",
    "evaluations to tolerance",
    "order",
    "finest error",
    "energy error",
    "energy trend",
    "remark",
]


def comparison_data(comparison: Comparison) -> dict[str, Any]:
    """Plain values, SI units; errors are relative to each coordinate's amplitude."""
    reference, problem = comparison.reference, comparison.reference.problem
    return {
        "model": problem.model.name,
        "title": problem.model.title,
        "t_end": problem.t_end,
        "tolerance": comparison.tolerance,
        "reference_error": reference.off,
        "graded": reference.amplitudes,
        "recommendation": comparison.recommendation(),
        "gain": _finite(comparison.gain()),
        "methods": [_curve_data(curve, comparison.tolerance) for curve in comparison.ranked()],
    }


def _curve_data(curve: WorkCurve, tolerance: float) -> dict[str, Any]:
    return {
        "method": curve.label,
        "sub_steps": curve.multirate,
        "seconds_to_tolerance": _finite(curve.seconds_to(tolerance)),
        "evaluations_to_tolerance": _finite(curve.evaluations_to(tolerance)),
        "order": _finite(curve.order),
        "energy_error": curve.energy.largest if curve.energy else None,
        "energy_trend": curve.energy.trend if curve.energy else None,
        "failure": curve.failure,
        "trials": [
            {
                "dt_or_rtol": trial.setting,
                "steps": trial.steps,
                "seconds": trial.seconds,
                "evaluations": trial.evaluations,
                "error": _finite(trial.error),
                "end_error": _finite(trial.end_error),
                "told_error": _finite(trial.told),
                "failure": trial.failure,
            }
            for trial in curve.trials
        ],
    }


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


FILES = tuple(f"comparison.{ending}" for ending in ("json", "csv", "md", "html")) + (
    "error_time.png",
    "error_evaluations.png",
)


def write_tables(comparison: Comparison, folder: str | Path) -> None:
    """comparison.json, .csv and .md in `folder`: what a comparison keeps on its way. Raises OutputError."""
    place, data = Path(folder), comparison_data(comparison)
    write_text(place / "comparison.json", as_json(data))
    write_text(place / "comparison.csv", _csv(comparison))
    write_text(place / "comparison.md", markdown(data))


def write_comparison(comparison: Comparison, folder: str | Path, scene: str = "") -> dict[str, str]:
    """comparison.json, .csv, .md, .html and the pictures in `folder`; {what: path}. Raises OutputError.

    scene: what a command calls the scene (the model's name by default).
    """
    place, data = Path(folder), comparison_data(comparison)
    picture_times(comparison, place / "error_time.png")
    picture_evaluations(comparison, place / "error_evaluations.png")
    write_tables(comparison, place)
    write_text(place / "comparison.html", comparison_page(comparison, data, scene))
    return {name: str(place / name) for name in FILES}


def _csv(comparison: Comparison) -> str:
    text, names = io.StringIO(), comparison.reference.graded
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(
        [
            "method",
            "dt_or_rtol",
            "steps",
            "cpu_seconds",
            "evaluations",
            *ERRORS,
            "failure",
            *names,
        ]
    )
    for curve in comparison.curves:
        for trial in curve.trials:
            writer.writerow(
                [
                    trial.label,
                    repr(trial.setting),
                    trial.steps,
                    repr(trial.seconds),
                    trial.evaluations,
                    repr(trial.error),
                    repr(trial.end_error),
                    repr(trial.told),
                    trial.failure,
                    *(repr(trial.errors.get(name, float("nan"))) for name in names),
                ]
            )
    return text.getvalue()


def summary_rows(data: Mapping[str, Any]) -> list[list[str]]:
    """A row of texts for each method, in the order of HEADER."""
    rows = []
    for entry in data["methods"]:
        errors = [trial["error"] for trial in entry["trials"] if trial["error"] is not None]
        rows.append(
            [
                entry["method"],
                _text(entry["seconds_to_tolerance"], 1e3),
                _text(entry["evaluations_to_tolerance"]),
                _text(entry["order"]),
                _text(min(errors) if errors else None),
                _text(entry["energy_error"]),
                _text(entry["energy_trend"]),
                entry["failure"] or _remark(entry),
            ]
        )
    return rows


def _remark(entry: Mapping[str, Any]) -> str:
    return "" if entry["seconds_to_tolerance"] is not None else "tolerance not reached in the time allowed"


def _text(value: float | None, factor: float = 1.0) -> str:
    return "-" if value is None else f"{value * factor:.3g}"


def _introduction(data: Mapping[str, Any]) -> list[str]:
    graded = ", ".join(f"{name} ({size:.3g})" for name, size in data["graded"].items())
    return [
        f"Motion of {data['t_end']:g} s. Graded: {graded}; in brackets the amplitude that errors are relative to.",
        "Error: RMS over the motion of the worst graded coordinate. Time: CPU, compiled, one thread, first call "
        "excluded, lower quartile of several runs. Reference: DOP853 at rtol 1e-11, itself off by "
        f"{data['reference_error']:.1e} at most. Evaluations count M_hat and Q_hat and sub-steps alike.",
        f"Recommended: {data['recommendation']}.",
    ]


def markdown(data: Mapping[str, Any]) -> str:
    """The summary as a page with the pictures beside it."""
    lines = [
        f"# {data['title'] or data['model']}: error against time",
        *_introduction(data),
        "![error against CPU time](error_time.png)",
        "![error against evaluations](error_evaluations.png)",
    ]
    table = [HEADER, ["---"] * len(HEADER), *summary_rows(data)]
    lines.append("\n".join(f"| {' | '.join(cell.replace('|', '/') for cell in row)} |" for row in table))
    return "\n\n".join(lines) + "\n"
