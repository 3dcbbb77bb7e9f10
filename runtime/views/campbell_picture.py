"""The picture of a Campbell diagram."""

from __future__ import annotations

from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from runtime.contract.files import replacing
from runtime.operating.campbell import Campbell
from runtime.results.notebook_figure import NotebookFigure
from runtime.views.style import COLOURS

MOST_NAMED = 12  # modes in the legend


def campbell_picture(found: Campbell, path: str | Path | None = None) -> Figure:
    """Frequencies of the followed modes over the speed or parameter; with a path it also writes the file.

    Along a speed, frequency = speed is drawn too. Raises OutputError if the file cannot be written.
    """
    figure = NotebookFigure(figsize=(8, 5), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    for k, name in enumerate(found.names):
        label = f"{k + 1} {name}" if k < MOST_NAMED else None
        ax.plot(found.values, found.frequencies[:, k], color=COLOURS[k % len(COLOURS)], label=label)
    if found.is_speed:
        ax.plot(found.values, abs(found.values), color="0.4", lw=0.9, ls="--", label="frequency = speed")
    ax.set_xlabel(f"{found.over} [rad/s]" if found.is_speed else found.over)
    ax.set_ylabel("frequency [rad/s]")
    ax.set_ylim(bottom=0.0)
    ax.set_title(found.model.title or found.model.name, fontsize=10, loc="left")
    figure.legend(*ax.get_legend_handles_labels(), fontsize=8, frameon=False, loc="outside right center")
    ax.grid(True, color="0.92")
    if path is not None:
        with replacing(path) as temporary:
            figure.savefig(temporary, dpi=130)
    return figure
