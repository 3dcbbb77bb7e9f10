"""The picture of a fit: data and fitted outputs over time, and what is left over."""

from __future__ import annotations

from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from runtime.contract.files import replacing
from runtime.gradients.fitted import Fit

DATA, LINE = "#8fb9c9", "#8a1c3b"


def fit_picture(fit: Fit, path: str | Path | None = None) -> Figure:
    """A column for each output: data (points) and fit (line) above, residuals below; with a path it writes the file."""
    figure = Figure(figsize=(5.5 * len(fit.data), 5.0), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(2, len(fit.data), sharex=True, squeeze=False, height_ratios=[3, 1])
    for column, (name, values) in enumerate(fit.data.items()):
        above, below = axes[0, column], axes[1, column]
        above.plot(fit.t, values, ".", markersize=3, color=DATA, label="data")
        above.plot(fit.t, fit.fitted[name], color=LINE, linewidth=1.2, label="fit")
        above.set_ylabel(name)
        above.legend(frameon=False)
        below.plot(fit.t, fit.residuals[name], ".", markersize=2, color=LINE)
        below.axhline(0.0, color="#111827", linewidth=0.6)
        below.set_ylabel("residual")
        below.set_xlabel("t [s]")
    figure.suptitle(
        ", ".join(
            f"{name} = {value:.4g} ± {error:.1g}"
            for name, value, error in zip(fit.names, fit.x, fit.standard_errors, strict=True)
        ),
        fontsize="medium",
    )
    if path is not None:
        with replacing(Path(path)) as temporary:
            figure.savefig(temporary, format=Path(path).suffix.lstrip(".") or "png")
    return figure
