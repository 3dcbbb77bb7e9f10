"""Figures that a notebook shows by themselves, panels with complete legends, units with prefixes, files."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from runtime.contract.files import OutputError, replacing
from runtime.views.curves import COLOURS, Curves

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.solutions.solution import Solution


PREFIXED = {"m": "m", "N": "N", "N m": "N m", "Pa": "Pa", "J": "J", "W": "W"}
PREFIXES = ((1e-9, "n"), (1e-6, "µ"), (1e-3, "m"), (1.0, ""), (1e3, "k"), (1e6, "M"), (1e9, "G"))
DASHES = ("-", (0, (5, 2)), (0, (1, 1.2)))
WIDTH = 10.5  # inches of two columns
NAMED = 24  # legend entries that fit beside a panel, in two columns


class NotebookFigure(Figure):
    """A matplotlib figure without pyplot; a notebook shows it before and after `%matplotlib inline`."""

    def _repr_png_(self) -> bytes:
        content = io.BytesIO()
        self.savefig(content, format="png")
        return content.getvalue()


def grid(
    count: int, title: str, columns: int = 2, ratios: Sequence[float] | None = None, shared: bool = True
) -> tuple[NotebookFigure, list[Any]]:
    """A figure with `count` panels and its title; time is shared where `shared`."""
    columns = 1 if count < 2 else columns
    rows = -(-count // columns) or 1
    size = (WIDTH if columns > 1 else 7.5, max(2.1 * rows, 3.0) + 0.5)
    figure = NotebookFigure(figsize=size, dpi=150, layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(rows, columns, squeeze=False, height_ratios=ratios, sharex=shared)
    axes = list(panels.ravel())
    for ax in axes[count:]:
        ax.remove()
    for ax in axes[: max(count - columns, 0)]:
        ax.tick_params(labelbottom=not shared)
    for ax in axes[max(count - columns, 0) : count]:
        ax.tick_params(labelbottom=True)
    for ax in axes[:count]:
        plain(ax)
    figure.suptitle(literal(title), fontsize=9.5, x=0.01, ha="left")
    return figure, axes[:count]


def literal(text: str) -> str:
    """A user's text for matplotlib, which takes what is between two $ for a formula."""
    return text.replace("$", r"\$")


def plain(ax: Axes) -> None:
    """Left and lower spines, a pale grid, numbers written out."""
    ax.grid(True, color="0.92", lw=0.7)
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(labelsize=8)
    ax.ticklabel_format(style="plain", useOffset=False)
    ax.xaxis.set_major_locator(MaxNLocator(7))


def panel(ax: Axes, t: np.ndarray, curves: Curves, *, own: bool = True) -> None:
    """Curves (N,) over time (N,) with title, unit and a complete legend outside on the right.

    own: with this project's colours; otherwise with those of the axes.
    """
    factor, unit = prefixed(curves.values, curves.unit)
    for k, (name, values) in enumerate(zip(curves.names, curves.values, strict=True)):
        style: dict[str, Any] = {"label": name}
        if own:
            style |= {"color": COLOURS[k % len(COLOURS)], "lw": 1.4, "ls": DASHES[(k // len(COLOURS)) % len(DASHES)]}
        if name == "total" and own:
            style |= {"color": "black", "ls": (0, (4, 2))}
        ax.plot(t, factor * values, **style)
    single = len(curves.names) == 1
    heading = curves.heading
    if single and curves.names[0] not in heading:
        heading = f"{heading}: {curves.names[0]}" if heading else curves.names[0]
    ax.set_title(heading, fontsize=9.5, loc="left", fontweight="bold")
    ax.set_ylabel(literal(f"[{unit}]"), fontsize=9)
    ax.set_xlabel("time [s]", fontsize=9)
    if len(t) > 1:
        ax.set_xlim(t[0], t[-1])
    if not single:
        legend(ax)


def legend(ax: Axes) -> None:
    """Every curve by name, outside on the right."""
    count = len(ax.get_legend_handles_labels()[1])
    ax.legend(
        fontsize=7.5 if count <= 9 else 6,
        frameon=False,
        loc="center left",
        bbox_to_anchor=(1.0, 0.5),
        ncols=1 if count <= NAMED // 2 else 2 if count <= NAMED else 4,
        handlelength=1.6,
        labelspacing=0.35,
    )


def prefixed(values: np.ndarray, unit: str) -> tuple[float, str]:
    """(factor, unit) that writes the largest value as 1 to 1000; angles in degrees."""
    if unit == "rad":
        return float(180.0 / np.pi), "°"
    largest = float(np.abs(values).max(initial=0.0))
    if unit not in PREFIXED or not np.isfinite(largest) or largest == 0.0:
        return 1.0, unit or "1"
    scale, prefix = max((entry for entry in PREFIXES if entry[0] <= largest * 1.0000001), default=PREFIXES[0])
    return 1.0 / scale, f"{prefix}{PREFIXED[unit]}"


def title(solution: Solution, what: str = "") -> str:
    """Scene, scheme and step, and where a run stopped that did not reach its end."""
    status = solution.status
    ending = f"      {status.ending}" if status.ending else ""
    about = f"{solution.model.title or solution.model.name}{': ' + what if what else ''}"
    return f"{about}      {solution.scheme}, {solution.step}{ending}"


def owner(ax: Axes) -> Figure:
    """The figure that axes given by the user stand in."""
    figure = ax.get_figure(root=True)
    assert isinstance(figure, Figure)
    return figure


def finish(figure: Figure, path: str | Path | None) -> Figure:
    """Write the figure where a path is given; its ending chooses the format. Raises OutputError."""
    if path is not None:
        ending = Path(path).suffix[1:].lower()
        if ending not in figure.canvas.get_supported_filetypes():
            raise OutputError(f"{path}: a picture's name must end in .png, .svg or .pdf")
        with replacing(path) as temporary:
            figure.savefig(temporary, format=ending)
    return figure
