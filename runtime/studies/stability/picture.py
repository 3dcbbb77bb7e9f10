"""The picture of a stability chart."""

from __future__ import annotations

from math import prod
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure

from runtime.contract.files import replacing
from runtime.results.notebook_figure import NotebookFigure
from runtime.studies.stability.chart import StabilityChart

LEVELS = (0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 1e-1, 1.0, np.inf)  # of growth in a major step
COLOURS = ("#e8f1f2", "#d3e6ea", "#b3d4db", "#8fb9c9", "#f4d58d", "#f0a35e", "#d1495b", "#8a1c3b")


def stability_picture(chart: StabilityChart, path: str | Path | None = None) -> Figure:
    """Spurious growth in a major step over dt_S for each m, limits as bars; with a path it also writes the file."""
    figure = NotebookFigure(figsize=(9, 1.8 + 0.42 * max(3, len(chart.curves))), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    norm = BoundaryNorm(np.arange(len(LEVELS)), len(COLOURS))
    mesh = None
    for row, curve in enumerate(chart.curves):
        fine = curve.dt / prod(curve.m)
        edges = np.sqrt(fine[1:] * fine[:-1])
        edges = np.concatenate([[fine[0] ** 2 / edges[0]], edges, [fine[-1] ** 2 / edges[-1]]])
        grown = np.expm1(np.minimum(curve.growth * curve.dt, 50.0))
        values = np.digitize(np.where(np.isfinite(grown), grown, 1e9), LEVELS[1:-1]) + 0.5
        mesh = ax.pcolormesh(edges, [row - 0.45, row + 0.45], values[None, :], cmap=ListedColormap(COLOURS), norm=norm)
        if curve.limit is not None and not curve.beyond:
            ax.plot([curve.limit / prod(curve.m)] * 2, [row - 0.45, row + 0.45], color="#111827", linewidth=2.0)
        for low, high in curve.windows:
            ax.plot([low / prod(curve.m), high / prod(curve.m)], [row, row], color="#111827", linewidth=1.0)
    ax.set_xscale("log")
    ax.set_yticks(range(len(chart.curves)), [",".join(map(str, curve.m)) or "-" for curve in chart.curves])
    ax.set_ylabel("m")
    ax.set_xlabel("step of the fastest group dt_S [s]")
    ax.set_title(
        f"{chart.model.title or chart.model.name}: {chart.scheme}, {len(chart.states)} states of {chart.t_end:g} s"
    )
    if mesh is not None:
        bar = figure.colorbar(mesh, ax=ax, ticks=np.arange(1, len(COLOURS)))
        bar.ax.set_yticklabels([f"{level:g}" for level in LEVELS[1:-1]])
        bar.set_label("spurious growth in a major step")
    if path is not None:
        with replacing(path) as temporary:
            figure.savefig(temporary, dpi=130)
    return figure
