"""The page of a comparison: verdict, work-precision plot, table, how it was measured; one file, no network."""

from __future__ import annotations

import html
import json
import os
import platform
import re
from collections.abc import Mapping
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from importlib.resources import files
from pathlib import Path
from typing import Any

from runtime.running.ladder import Method
from runtime.studies.work_precision.comparison import Comparison, WorkCurve

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#6a4c93", "#8c564b", "#4b5563", "#b3261e")
SHOWN_PARAMETERS = 40


def comparison_page(comparison: Comparison, data: Mapping[str, Any], scene: str = "") -> str:
    """The page. data: `comparison_data` of it; scene: what a command calls the scene (the model's name by default)."""
    by_label = {curve.label: curve for curve in comparison.curves}
    methods = [
        {**entry, "kind": _kind(by_label[entry["method"]]), "command": _command(by_label[entry["method"]], scene, data)}
        for entry in data["methods"]
    ]
    record = {
        **{key: data[key] for key in ("model", "title", "t_end", "tolerance")},
        "methods": methods,
        "colours": COLOURS,
        "measured": _measured(comparison, data),
    }
    parts = {
        "title": html.escape(f"{data['title'] or data['model']}: error against time"),
        "plain": html.escape(f"Recommended: {data['recommendation']}."),
        "styles": _text("report.css"),
        "script": _text("report.js"),
        "data": json.dumps(record, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c"),
    }
    pieces = re.split("@@([a-z]+)@@", _text("report.html"))
    return "".join(parts[piece] if k % 2 else piece for k, piece in enumerate(pieces))


def _kind(curve: WorkCurve) -> str:
    if curve.method is None:
        return "adaptive"
    return "sub" if curve.multirate else "one"


def _command(curve: WorkCurve, scene: str, data: Mapping[str, Any]) -> str:
    """What runs a scheme, without its step; "" for an adaptive integrator, which is here to compare with only."""
    return "" if curve.method is None else command(curve.method, scene or str(data["model"]))


def command(method: Method, scene: str) -> str:
    """The words for `symgen simulate`, without a step."""
    words = ["symgen simulate", scene, f"--scheme {method.scheme}"]
    words += [f"--m {','.join(map(str, method.m))}"] if method.m else []
    for name, value in method.options.items():
        words.append(f"--option {name}={','.join(map(str, value)) if isinstance(value, tuple) else value}")
    return " ".join(words)


def _measured(comparison: Comparison, data: Mapping[str, Any]) -> dict[str, str]:
    """Scene, error, time, reference, machine, versions, parameters: texts by name."""
    problem = comparison.reference.problem
    model = problem.model
    graded = ", ".join(f"{name} ({size:.3g})" for name, size in data["graded"].items())
    changed = [
        f"{entry.name} = {value:.6g} {entry.unit}".rstrip()
        for entry, value in zip(model.parameters, problem.p, strict=True)
        if entry.kind == "declared" or (entry.kind == "scene" and value != entry.default)
    ]
    return {
        "scene": f"{model.name}: {len(model.coordinates)} coordinates, {len(model.q_i)} independent; groups "
        f"{', '.join(group.name for group in model.groups)}; {data['t_end']:g} s of motion",
        "error": f"RMS over the motion of the worst graded coordinate, relative to its amplitude: {graded}",
        "time": "CPU time of one thread, compiled, first call excluded, lower quartile of several runs; evaluations "
        "count M_hat and Q_hat and sub-steps alike",
        "reference": f"DOP853 at rtol 1e-11, itself off by {data['reference_error']:.1e} at most",
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        "date": date.today().isoformat(),
        "versions": ", ".join(f"{name} {_version(name)}" for name in ("symgen", "casadi", "numpy", "scipy"))
        + f", Python {platform.python_version()}",
        "model": f"SHA-256 {model.digest[:16]}" if model.digest else "not kept",
        "parameters": ", ".join(changed[:SHOWN_PARAMETERS]) or "as the scene has them",
    }


def _processor() -> str:
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        text = ""
    found = re.search(r"model name\s*:\s*(.+)", text)
    return found.group(1).strip() if found else platform.processor() or "processor not known"


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "(not installed)"


def _text(name: str) -> str:
    return files("runtime.studies.work_precision").joinpath("report_page", name).read_text(encoding="utf-8")
