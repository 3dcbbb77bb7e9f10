"""The picture of an ensemble: values of whole runs over what was varied, or the bundle of all histories."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from runtime.contract.files import replacing
from runtime.results.notebook_figure import NotebookFigure
from runtime.views.figure import grid
from runtime.views.style import COLOURS

MOST_PANELS, MOST_CURVES = 8, 100
BAND = (5, 50, 95)  # percent


def ensemble_picture(
    title: str,
    varied: Mapping[str, np.ndarray],
    values: Mapping[str, np.ndarray],
    time: np.ndarray | None = None,
    path: str | Path | None = None,
) -> NotebookFigure:
    """Panels of the first values (cases,), or (cases, times) over `time`; with a path it also writes the file.

    varied: parameters and initial values by name (cases,). The second of them is the colour. Raises OutputError.
    """
    shown = dict(list(values.items())[:MOST_PANELS])
    figure, axes = grid(len(shown), title, shared=time is not None)
    for ax, (name, found) in zip(axes, shown.items(), strict=True):
        if time is not None:
            _bundle(ax, time, found)
        else:
            _over(figure, ax, varied, found)
        ax.set_ylabel(name)
    for ax in axes[-2:]:
        ax.set_xlabel("time [s]" if time is not None else next(iter(varied)))
    if path is not None:
        with replacing(path) as temporary:
            figure.savefig(temporary)
    return figure


def _bundle(ax: Axes, time: np.ndarray, found: np.ndarray) -> None:
    """Some histories, and between which values most of them are."""
    chosen = np.unique(np.linspace(0, len(found) - 1, MOST_CURVES).astype(int))
    ax.plot(time, found[chosen].T, color="0.75", lw=0.4)
    good = found[np.isfinite(found).all(axis=1)]
    if len(good):
        low, middle, high = np.percentile(good, BAND, axis=0)
        ax.fill_between(time, low, high, color=COLOURS[0], alpha=0.25, lw=0)
        ax.plot(time, middle, color=COLOURS[0], lw=1.2)


def _over(figure: NotebookFigure, ax: Axes, varied: Mapping[str, np.ndarray], found: np.ndarray) -> None:
    """Points over the first of what was varied, a line where nothing else was."""
    names: Sequence[str] = list(varied)
    if len(names) == 1:
        order = np.argsort(varied[names[0]])
        ax.plot(varied[names[0]][order], found[order], color=COLOURS[0], marker=".", ms=3, lw=0.8)
        return
    points = ax.scatter(varied[names[0]], found, c=varied[names[1]], s=8, cmap="viridis", linewidths=0, zorder=3)
    figure.colorbar(points, ax=ax, label=names[1], pad=0.01)
