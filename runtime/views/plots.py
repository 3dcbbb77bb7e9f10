"""Pictures of a solution: coordinates, energy balance, constraint error, phase portraits.

Every function takes (solution, path or None) and returns the Figure; with a path it also writes the file, whose
ending chooses the format (png, svg, pdf). No pyplot, no global state: safe in threads and without a display.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from runtime.contract.files import OutputError, replacing
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.results.solution import Solution

MAX_PANELS = 12
STILL = 1e-12  # m or rad: what moves less than this against its own size has nothing to show


@dataclass(frozen=True)
class Panel:
    """Coordinates that share an axis."""

    title: str
    label: str
    names: list[str]


def coordinates(solution: Solution, path: str | Path | None = None, names: Sequence[str] | None = None) -> Figure:
    """Coordinates against time in small multiples: angles, positions, then the elastic ones of each body.

    names: which coordinates or measures (all that move by default). Raises ModelError for an unknown name.
    """
    panels = _chosen(solution, names) if names is not None else _panels(solution)
    panels, left_out = panels[:MAX_PANELS], len(panels) - MAX_PANELS
    figure, axes = _grid(len(panels), _title(solution, "coordinates"))
    for ax, panel in zip(axes, panels, strict=True):
        _lines(ax, solution, panel)
    if left_out > 0:
        figure.text(0.99, 0.005, f"{left_out} more bodies not shown", ha="right", fontsize=8, color="0.4")
    return _finish(figure, path)


def energy_balance(solution: Solution, path: str | Path | None = None) -> Figure:
    """Energies [J] against time, and below them what the balance total - initial - work leaves."""
    figure, (top, bottom) = _grid(2, _title(solution, "energy"), columns=1, ratios=(2, 1))
    for colour, key in zip(COLOURS, ("kinetic", "elastic", "potential"), strict=False):
        if np.any(solution.energy[key]):
            top.plot(solution.t, solution.energy[key], color=colour, lw=1.1, label=key)
    top.plot(solution.t, solution.total_energy, color="black", lw=1.5, label="total")
    work = solution.work()
    if np.any(work):
        top.plot(solution.t, solution.total_energy[:1] + work, color="0.45", lw=1.2, ls="--", label="initial + work")
    top.set_ylabel("energy [J]")
    _legend(top)
    bottom.plot(solution.t, solution.energy_balance(), color=COLOURS[1], lw=1.1)
    bottom.axhline(0.0, color="0.6", lw=0.7)
    bottom.set_ylabel("balance error [J]")
    bottom.set_xlabel("time [s]")
    return _finish(figure, path)


def constraint_error(solution: Solution, path: str | Path | None = None) -> Figure:
    """Largest constraint violation max |C| [m, rad] against time, logarithmic."""
    figure, (ax,) = _grid(1, _title(solution, "constraint error"))
    floor = np.finfo(float).tiny
    positive = solution.constraint_error[solution.constraint_error > floor]
    if positive.size:
        lowest = max(float(positive.min()), 1e-18)
        ax.semilogy(solution.t, np.maximum(solution.constraint_error, lowest), color=COLOURS[0], lw=1.0)
    else:
        ax.plot(solution.t, np.zeros_like(solution.t), color=COLOURS[0], lw=1.0)
    ax.set_ylabel("max |C| [m, rad]")
    ax.set_xlabel("time [s]")
    return _finish(figure, path)


def phase(solution: Solution, path: str | Path | None = None, names: Sequence[str] | None = None) -> Figure:
    """Rate against coordinate, one panel each (the independent ones by default, at most twelve).

    Raises ModelError for an unknown name.
    """
    chosen = list(names) if names is not None else solution.model.q_i
    figure, axes = _grid(min(len(chosen), MAX_PANELS), _title(solution, "phase"))
    for ax, name in zip(axes, chosen, strict=False):
        x, v = solution[name], solution.rate(name)
        ax.plot(x, v, color=COLOURS[0], lw=0.9)
        ax.plot(x[:1], v[:1], "o", color=COLOURS[2], ms=5, label="start")
        ax.plot(x[-1:], v[-1:], "s", color=COLOURS[1], ms=5, label="end")
        coordinate = solution.model.coordinate(name)
        ax.set_xlabel(f"{name} [{coordinate.unit}]")
        ax.set_ylabel(f"rate [{coordinate.unit_of(1)}]")
    if axes:
        _legend(axes[0])
    return _finish(figure, path)


def _panels(solution: Solution) -> list[Panel]:
    """Rigid angles, rigid positions, elastic coordinates body by body; what does not move is left out."""
    model = solution.model
    records = model.description.coordinates
    moving = [entry for k, entry in enumerate(records) if _moves(solution.q[:, k])] or records
    panels = [
        Panel("angles", "angle [rad]", [entry.name for entry in moving if entry.kind == "angle"]),
        Panel("positions", "position [m]", [entry.name for entry in moving if entry.kind == "position"]),
        Panel("Euler parameters", "[1]", [entry.name for entry in moving if entry.kind == "euler_parameter"]),
    ]
    for body in dict.fromkeys(entry.owner for entry in moving if entry.elastic):
        own = [entry.name for entry in moving if entry.elastic and entry.owner == body]
        panels.append(Panel(f"{body}: deformation", "modal coordinate [m]", own))
    return [panel for panel in panels if panel.names]


def _moves(values: np.ndarray) -> bool:
    return bool(np.ptp(values) > STILL * max(1e-3, float(np.abs(values).max())))


def _chosen(solution: Solution, names: Sequence[str]) -> list[Panel]:
    described = solution.model.description
    units = {entry.name: entry.unit for entry in described.coordinates}
    units |= {entry.name: entry.unit for entry in described.measures}
    return [Panel(name, f"[{units[name]}]" if name in units else "", [name]) for name in names]


def _lines(ax: Axes, solution: Solution, panel: Panel) -> None:
    """One line a coordinate; many lines share a colour map and only the first, middle and last are named."""
    many = len(panel.names) > len(COLOURS)
    spectrum = colormaps["viridis"](np.linspace(0.0, 0.92, len(panel.names))) if many else COLOURS
    named = {0, len(panel.names) // 2, len(panel.names) - 1} if many else set(range(len(panel.names)))
    for k, name in enumerate(panel.names):
        ax.plot(solution.t, solution[name], color=spectrum[k], lw=1.1, label=name if k in named else None)
    ax.set_title(panel.title, fontsize=10, loc="left")
    ax.set_ylabel(panel.label)
    ax.set_xlabel("time [s]")
    _legend(ax)


def _grid(count: int, title: str, columns: int = 2, ratios: Sequence[float] | None = None) -> tuple[Figure, list[Any]]:
    columns = 1 if count <= 3 else columns
    rows = -(-count // columns) or 1
    figure = Figure(figsize=(9.6 if columns > 1 else 7.2, max(2.2 * rows, 3.6) + 0.6), dpi=120, layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.subplots(rows, columns, squeeze=False, height_ratios=ratios, sharex=ratios is not None)
    axes = list(grid.ravel())
    for ax in axes[count:]:
        ax.remove()
    for ax in axes[:count]:
        ax.grid(True, color="0.9", lw=0.7)
        ax.spines[["top", "right"]].set_visible(False)
        ax.ticklabel_format(scilimits=(-3, 4), useMathText=True)
        ax.xaxis.set_major_locator(MaxNLocator(7))
        ax.tick_params(labelsize=9)
    figure.suptitle(title, fontsize=12)
    return figure, axes[:count]


def _legend(ax: Axes) -> None:
    """Above the axes on the right, where it hides no curve."""
    ax.legend(
        fontsize=8,
        frameon=False,
        ncols=5,
        loc="lower right",
        bbox_to_anchor=(1.0, 0.98),
        borderaxespad=0.0,
        handlelength=1.4,
        columnspacing=1.2,
    )


def _title(solution: Solution, what: str) -> str:
    ending = "" if solution.status.ok else f" ({solution.status.name} at {solution.status.time:.4g} s)"
    return f"{solution.model.title or solution.model.name}: {what}{ending}"


def _finish(figure: Figure, path: str | Path | None) -> Figure:
    if path is not None:
        ending = Path(path).suffix[1:].lower()
        if ending not in figure.canvas.get_supported_filetypes():
            raise OutputError(f"{path}: a picture's name must end in .png, .svg or .pdf")
        with replacing(path) as temporary:
            figure.savefig(temporary, format=ending)
    return figure
