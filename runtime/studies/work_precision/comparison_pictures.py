"""Error against CPU time and against evaluations, one line a method; failed runs as crosses at the top."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from runtime.contract.files import replacing
from runtime.results.notebook_figure import NotebookFigure
from runtime.studies.work_precision.comparison import Comparison
from runtime.studies.work_precision.trial import Trial

TOP = 2.0  # where failures are drawn
MARKERS = "osD^vP*X<>hp"


def picture_times(comparison: Comparison, path: str | Path | None = None) -> Figure:
    """Error against CPU time [s]."""
    return _picture(comparison, lambda trial: trial.seconds, "CPU time [s]", path)


def picture_evaluations(comparison: Comparison, path: str | Path | None = None) -> Figure:
    """Error against evaluations."""
    return _picture(
        comparison, lambda trial: trial.evaluations, "evaluations of M_hat and Q_hat, sub-steps included", path
    )


def _picture(comparison: Comparison, price: Callable[[Trial], float], label: str, path: str | Path | None) -> Figure:
    figure = NotebookFigure(figsize=(11, 6.2), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    shown = [curve for curve in comparison.ranked() if curve.trials]
    palette = colormaps["tab20"](np.linspace(0, 1, max(1, len(shown))))
    for k, curve in enumerate(shown):
        good = [trial for trial in curve.trials if not trial.failure]
        style = "-" if curve.multirate else ("--" if curve.method is not None else ":")
        ax.plot(
            [max(price(trial), 1e-9) for trial in good],
            [max(trial.error, 1e-16) for trial in good],
            style,
            marker=MARKERS[k % len(MARKERS)],
            markersize=4.5,
            linewidth=1.4,
            color=palette[k],
            label=curve.label,
        )
        bad = [price(trial) for trial in curve.trials if trial.failure and price(trial) > 0]
        ax.plot(bad, [TOP] * len(bad), "x", color=palette[k], markersize=5)
    ax.axhline(comparison.tolerance, color="#6b7280", linewidth=0.8)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_ylim(top=3 * TOP)
    ax.set_xlabel(label)
    ax.set_ylabel("RMS error / amplitude, worst graded coordinate")
    problem = comparison.reference.problem
    ax.set_title(
        f"{problem.model.title or problem.model.name}, {problem.t_end:g} s (solid: with sub-steps; dashed: "
        "one step; dotted: adaptive; crosses: failed)",
        fontsize=10,
    )
    ax.grid(True, which="major", color="#e5e7eb")
    ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8)
    if path is not None:
        with replacing(path) as temporary:
            figure.savefig(temporary, dpi=120)
    return figure
