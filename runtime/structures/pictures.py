"""Pictures of a structure: its regions, its motion, its deformed mesh, error against time; VTK for ParaView."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.sparse as sp
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter
from scipy.sparse.csgraph import connected_components

from runtime.contract.errors import ArgumentError
from runtime.structures.regions import Regions
from runtime.structures.structure import Array, LinearStructure, StructureError
from runtime.views.curves import COLOURS
from runtime.views.figure import finish, grid, legend, prefixed

if TYPE_CHECKING:
    from runtime.structures.report import Row
    from runtime.structures.run import StructureRun

MOST_CURVES = 6
DEFORMED = 0.08  # of the structure's size: how far the largest displacement is drawn
CELL_TYPES = {  # meshio's names by dimension and corners
    (2, 3): "triangle", (2, 4): "quad", (3, 3): "triangle", (3, 4): "tetra", (3, 8): "hexahedron", (3, 10): "tetra10",
    (3, 20): "hexahedron20", (2, 2): "line", (3, 2): "line",
}  # fmt: skip


def drawable(structure: LinearStructure) -> tuple[Array, Any]:
    """Points (nodes, 2) and cells of a structure in a plane; raises StructureError where there is nothing to draw."""
    if structure.points is None or structure.cells is None:
        raise StructureError("points", "the structure has no mesh to draw", "give points and cells")
    if structure.points.shape[1] != 2:
        raise StructureError("points", "pictures are of structures in a plane", "write_vtk shows solids in ParaView")
    return structure.points, structure.cells


def regions_picture(structure: LinearStructure, regions: Regions, path: str | Path | None = None) -> Figure:
    """The mesh, coloured by how often its nodes step: the paper's Fig. 1. Written where a path (.png, .svg, .pdf)
    is given.
    """
    points, cells = drawable(structure)
    times = np.empty(len(points))
    for group, fastest in zip(regions.groups, regions.fastest, strict=True):
        times[group.nodes] = regions.fastest[-1] / fastest
    figure, axes = grid(
        2, f"{structure.title or structure.name}: steps of each node in one of the slowest", columns=2, shared=False
    )
    often = times[cells].max(axis=1)
    fast = points[_largest_part(cells, np.flatnonzero(times == times.max()))]
    for ax, zoomed in zip(axes, (False, True), strict=True):
        for k, count in enumerate(np.unique(often)):
            own = list(points[cells[often == count]])
            lines: dict[str, Any] = {"lw": 0.25, "edgecolor": "white"} if zoomed else {"lw": 0, "edgecolor": "face"}
            ax.add_collection(PolyCollection(own, facecolor=COLOURS[k], label=f"{count:.0f}", **lines))
        _frame(ax, points)
        if zoomed and len(regions.groups) > 1:
            middle, half = (fast.min(axis=0) + fast.max(axis=0)) / 2, 0.65 * float(np.ptp(fast, axis=0).max())
            ax.set_xlim(middle[0] - half, middle[0] + half), ax.set_ylim(middle[1] - half, middle[1] + half)
            ax.set_title("where it steps most often", fontsize=9.5, loc="left", fontweight="bold")
    legend(axes[-1])
    return finish(figure, path)


def _largest_part(cells: Any, nodes: Any) -> Any:
    """Of some nodes those that hang together in the largest number."""
    count = int(cells.max()) + 1
    inside = np.zeros(count, dtype=bool)
    inside[nodes] = True
    pairs = np.concatenate([cells[:, [k, k - 1]] for k in range(cells.shape[1])])
    pairs = pairs[inside[pairs].all(axis=1)]
    graph = sp.coo_matrix((np.ones(len(pairs)), pairs.T), shape=(count, count))
    part = connected_components(graph, directed=False)[1]
    return nodes[part[nodes] == np.bincount(part[nodes]).argmax()]


def _frame(ax: Any, points: Array) -> None:
    low, high = points.min(axis=0), points.max(axis=0)
    edge = 0.05 * max(high - low)
    ax.set_xlim(low[0] - edge, high[0] + edge), ax.set_ylim(low[1] - edge, high[1] + edge)
    ax.set_aspect("equal")
    ax.grid(False)
    ax.set_xlabel("x [m]", fontsize=9), ax.set_ylabel("y [m]", fontsize=9)


def motion_picture(run: StructureRun, names: Sequence[str] | None = None, path: str | Path | None = None) -> Figure:
    """Displacements over time: those named, or the loaded and largest of what was kept; and the energy below."""
    if names is None:
        largest = np.argsort(-np.abs(run.values).max(axis=0, initial=0.0))[:MOST_CURVES]
        names = [run.names[k] for k in sorted(largest)]
    figure, (upper, lower) = grid(2, f"{run.model.title}      {run.about}", columns=1)
    curves = np.column_stack([run[name] for name in names])
    late, second = _times(run.t)
    factor, unit = prefixed(curves, "m")
    for k, name in enumerate(names):
        upper.plot(late * run.t, factor * curves[:, k], lw=1.3, color=COLOURS[k % len(COLOURS)], label=name)
    upper.set_ylabel(f"displacement [{unit}]", fontsize=9)
    legend(upper)
    total = run.energy.sum(axis=1)
    factor, unit = prefixed(total, "J")
    for k, (label, values) in enumerate(
        (("kinetic", run.energy[:, 0]), ("elastic", run.energy[:, 1]), ("total", total))
    ):
        lower.plot(
            late * run.energy_times,
            factor * values,
            lw=1.3,
            color="black" if label == "total" else COLOURS[k],
            label=label,
        )
    lower.set_ylabel(f"energy [{unit}]", fontsize=9)
    lower.set_xlabel(f"time [{second}]", fontsize=9)
    legend(lower)
    return finish(figure, path)


def _times(t: Array) -> tuple[float, str]:
    """Factor and unit that write the last time as 1 to 1000."""
    units = ((1.0, "s"), (1e3, "ms"), (1e6, "µs"))
    return next((entry for entry in units if entry[0] * float(t[-1]) >= 1), units[-1])


def field_picture(run: StructureRun, times: Sequence[float] | None = None, path: str | Path | None = None) -> Figure:
    """The deformed mesh at some times [s], coloured by how far its nodes have moved; four in the run by default."""
    structure = run.model.structure
    points, cells = drawable(structure)
    wanted = np.linspace(0, run.field_times[-1], 5)[1:] if times is None else np.asarray(times, dtype=float)
    rows = [int(np.argmin(abs(run.field_times - t))) for t in wanted]
    moved = run.fields[rows].reshape(len(rows), len(points), structure.width)
    size = np.linalg.norm(moved, axis=2)
    factor, unit = prefixed(size, "m")
    late, second = _times(run.field_times)
    scale = DEFORMED * float(np.ptp(points, axis=0).max()) / max(float(size.max()), 1e-300)
    figure, axes = grid(len(rows), f"{run.model.title}: displacements, drawn {scale:.3g} times as large", shared=False)
    for ax, row, offset, far in zip(axes, rows, moved, size, strict=True):
        shape = points + scale * offset[:, :2]
        found = PolyCollection(
            list(shape[cells]), array=factor * far[cells].mean(axis=1), cmap="viridis", lw=0, edgecolor="face"
        )
        found.set_clim(0, factor * float(size.max()))
        ax.add_collection(found)
        _frame(ax, points)
        ax.set_title(f"t = {late * run.field_times[row]:.4g} {second}", fontsize=9.5, loc="left", fontweight="bold")
    figure.colorbar(found, ax=axes, shrink=0.7, label=f"displacement [{unit}]")
    return finish(figure, path)


def error_time_picture(title: str, rows: Sequence[Row], path: str | Path | None = None) -> Figure:
    """Error against the time that a run took, a curve for each method."""
    figure, (ax,) = grid(1, f"{title}: error against time", shared=False)
    for k, method in enumerate(dict.fromkeys(row.method for row in rows)):
        own = [row for row in rows if row.method == method]
        ax.loglog(
            [r.seconds for r in own],
            [r.error for r in own],
            "osD^v"[k % 5] + "-",
            ms=5,
            lw=1.3,
            color=COLOURS[k],
            label=method,
        )
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set_xlabel("time of the run [s]", fontsize=9)
    ax.set_ylabel("error, of the amplitude", fontsize=9)
    legend(ax)
    return finish(figure, path)


def write_vtk(run: StructureRun, path: str | Path) -> Path:
    """The kept fields as a time series for ParaView: an XDMF file with its data beside it, by meshio (extra `files`).

    Raises ArgumentError where meshio is not installed, StructureError where the structure has no mesh.
    """
    try:
        import meshio
    except ImportError as error:
        raise ArgumentError("write_vtk", "meshio is not installed", 'pip install "symgen[files]"') from error
    structure = run.model.structure
    if structure.points is None or structure.cells is None:
        raise StructureError("points", "the structure has no mesh to write", "give points and cells")
    points = structure.points
    kind = CELL_TYPES.get((points.shape[1], structure.cells.shape[1]))
    if kind is None:
        raise StructureError(
            "cells", f"have {structure.cells.shape[1]} corners", f"known: {sorted(set(CELL_TYPES.values()))}"
        )
    space = np.zeros((len(points), 3))
    space[:, : points.shape[1]] = points
    with meshio.xdmf.TimeSeriesWriter(str(path), data_format="XML") as writer:
        writer.write_points_cells(space, [(kind, structure.cells)])
        for t, field in zip(run.field_times, run.fields, strict=True):
            moved = np.zeros((len(points), 3))
            moved[:, : structure.width] = field.reshape(len(points), structure.width)
            writer.write_data(float(t), point_data={"displacement": moved})
    return Path(path)
