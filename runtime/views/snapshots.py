"""A mechanism at several instants in one picture, the later the stronger, with the paths of chosen markers."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from runtime.contract.errors import ArgumentError, ModelError
from runtime.views.animation import STYLES
from runtime.views.figure import finish, grid, owner, title
from runtime.views.film import MAX_FRAMES, Film, Line, film_at
from runtime.views.mechanism.scenery import Scenery, scenery
from runtime.views.projection import projected
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.results.solution import Solution

PALEST = 0.2  # opacity of the first instant
LAST_ONLY = ("ghost", "joint", "slide")  # kinds that would crowd the picture at every instant
PATH_POINTS = 600


def snapshots(
    solution: Solution,
    path: str | Path | None = None,
    instants: int | Sequence[float] = 5,
    traces: Sequence[str] = (),
    exaggeration: float | None = None,
    ax: Axes | None = None,
) -> Figure:
    """The mechanism at `instants` (how many, or times [s]) in one picture; traces: paths of markers "body.marker".

    exaggeration multiplies the deformation (None: the largest of these instants becomes visible). A spatial mechanism
    is seen from a fixed side. Raises ModelError (nothing to draw, no such marker), ArgumentError, OutputError.
    """
    times = _times(solution, instants)
    shown = film_at(solution, times, exaggeration)
    paths = [_path(solution, name, shown.exaggeration) for name in traces]
    figure: Figure
    if ax is None:
        figure, (ax,) = grid(1, title(solution), shared=False)
    else:
        figure = owner(ax)
    for k, xy in enumerate(paths):
        ax.plot(*xy, color=COLOURS[-1 - k % len(COLOURS)], lw=0.9, alpha=0.7, zorder=1.8)
    for frame in range(len(times)):
        last = frame == len(times) - 1
        for line in shown.lines:
            if last or line.kind not in LAST_ONLY:
                ax.plot(*line.xy[frame], **_style(line, frame, len(times)))
    ax.set_aspect("equal")
    ax.set_xlabel(shown.axes[0], fontsize=9)
    ax.set_ylabel(shown.axes[1], fontsize=9)
    paths_of = f"\nthin: path of {', '.join(traces)}" if traces else ""  # a legend would cover what is drawn
    ax.set_title(_heading(times, shown) + paths_of, fontsize=9.5, loc="left")
    return finish(figure, path)


def _times(solution: Solution, instants: int | Sequence[float]) -> np.ndarray:
    if isinstance(instants, int):
        times = np.linspace(solution.t[0], solution.t[-1], max(instants, 0))
    else:
        times = np.asarray(instants, dtype=float)
    if not 1 <= times.size <= MAX_FRAMES or times.min() < solution.t[0] or times.max() > solution.t[-1]:
        raise ArgumentError(f"instants must be a number from 1 to {MAX_FRAMES}, or times of the run, not {instants}")
    return np.sort(times)


def _path(solution: Solution, name: str, factor: float) -> np.ndarray:
    """(2, N) where the marker goes, in the picture's plane."""
    scene: Scenery = scenery(solution, np.linspace(solution.t[0], solution.t[-1], PATH_POINTS))
    known = [f"{body.name}.{marker}" for body in scene.bodies for marker in body.markers.names]
    if name not in known:
        raise ModelError(f"{solution.model.name} has no marker {name!r} to draw; it has {', '.join(known)}")
    return projected(solution.model, scene.place(name, factor).T)


def _style(line: Line, frame: int, count: int) -> dict[str, Any]:
    share = (frame + 1) / count
    style = dict(STYLES[line.kind])
    if line.kind in ("beam", "body", "outline") and line.colour >= 0:
        style["color"] = COLOURS[line.colour % len(COLOURS)]
        if line.xy.shape[2] == 1:
            style |= {"marker": "s", "ms": 8, "mec": "white", "mew": 0.8}
    if line.kind != "ground":
        style["alpha"] = PALEST + (1.0 - PALEST) * share**2
        style["zorder"] = style["zorder"] + 0.5 * share
    return style


def _heading(times: np.ndarray, shown: Film) -> str:
    first, last = times[0], times[-1]
    span = f"t = {last:.4g} s" if len(times) == 1 else f"{len(times)} instants, t = {first:.4g} to {last:.4g} s"
    factor = shown.exaggeration
    return span + (f", deformation x {factor:.3g}" if any(line.kind == "ghost" for line in shown.lines) else "")
