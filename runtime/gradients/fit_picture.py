"""The picture of a fit: data and fitted outputs over time, and what is left over."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from runtime.contract.files import replacing

DATA, LINE = "#8fb9c9", "#8a1c3b"
Columns = Mapping[str, np.ndarray]


def fit_picture(t: np.ndarray, data: Columns, fitted: Columns, title: str, path: str | Path | None = None) -> Figure:
    """Of each output (N,) over t (N,) [s] data (points), fit (line), residuals; with a path it also writes the file."""
    figure = Figure(figsize=(2.0 + 5.5 * len(data), 4.4), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(2, len(data), sharex=True, squeeze=False, height_ratios=[3, 1])
    for column, (name, values) in enumerate(data.items()):
        above, below = axes[0, column], axes[1, column]
        above.plot(t, values, ".", markersize=3, color=DATA, label="data")
        above.plot(t, fitted[name], color=LINE, linewidth=1.2, label="fit")
        above.set_ylabel(name)
        above.legend(frameon=False)
        below.plot(t, fitted[name] - values, ".", markersize=2, color=LINE)
        below.axhline(0.0, color="#111827", linewidth=0.6)
        below.set_ylabel("residual")
        below.set_xlabel("t [s]")
    figure.suptitle(title, fontsize="medium")
    if path is not None:
        with replacing(Path(path)) as temporary:
            figure.savefig(temporary, dpi=130, format=Path(path).suffix[1:] or "png")
    return figure
