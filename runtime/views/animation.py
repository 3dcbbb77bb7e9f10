"""The mechanism in motion as a GIF: bodies as lines, their deformation exaggerated, drawn with Agg, saved by Pillow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from runtime.contract.errors import ArgumentError
from runtime.contract.files import OutputError, replacing
from runtime.contract.model import Model, ModelError
from runtime.views.plots import COLOURS
from runtime.views.projection import axis_labels, projected

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.results.solution import Solution

MAX_FRAMES = 2000
VISIBLE = 0.05  # the largest deformation becomes this part of the mechanism's size
GROUND = "ground"


@dataclass(frozen=True)
class Film:
    """Points of all frames: xy and ghost (frames, 2, points) [m], t (frames,) [s], the exaggeration used.

    A spatial mechanism is shown from a fixed direction, see view.py; axes are the world's in a planar one.
    """

    t: np.ndarray
    xy: np.ndarray
    ghost: np.ndarray
    exaggeration: float
    axes: tuple[str, str]

    @property
    def limits(self) -> tuple[np.ndarray, np.ndarray]:
        """Lower and upper corner of everything drawn, ghost included [m]."""
        points = np.concatenate([self.xy, self.ghost], axis=2)
        return points.min(axis=(0, 2)), points.max(axis=(0, 2))


def film(solution: Solution, frames: int = 60, exaggeration: float | None = None) -> Film:
    """Where every drawn point is at `frames` equally spaced times.

    exaggeration multiplies the elastic coordinates; None chooses it so that the largest deformation drawn becomes
    5 % of the mechanism's size (at least 1). Raises ModelError if the model has nothing to draw.
    """
    if not solution.model.has("drawing"):
        raise ModelError(
            f"model {solution.model.name} has no drawing (a structure without bodies, a model generated "
            "without it, or a solution loaded without its model)"
        )
    if not 1 <= frames <= MAX_FRAMES:
        raise ArgumentError(f"frames must be 1 to {MAX_FRAMES}, not {frames}")
    if exaggeration is not None and not np.isfinite(exaggeration):
        raise ArgumentError(f"exaggeration must be finite, not {exaggeration}")
    t = np.linspace(solution.t[0], solution.t[-1], frames)
    q = solution.interpolate(t, "q")
    c = solution.model.constants(solution.parameters)
    ghost, true = (_points(solution.model, q, t, c, factor) for factor in (0.0, 1.0))
    factor = _automatic(true, ghost) if exaggeration is None else float(exaggeration)
    return Film(t, _points(solution.model, q, t, c, factor), ghost, factor, axis_labels(solution.model))


def _points(model: Model, q: np.ndarray, t: np.ndarray, c: np.ndarray, exaggeration: float) -> np.ndarray:
    """(frames, 2, points): one call of the drawing function for all frames, side by side."""
    kernel = model.kernel("drawing")
    given: dict[str, Any] = {"q": q.T, "exaggeration": exaggeration, "t": t.reshape(1, -1), "c": c}
    arguments = {name: given[name] for name in kernel.name_in() if kernel.size1_in(name)}
    output = kernel.name_out()[0]
    flat = np.asarray(kernel(**arguments)[output], dtype=float)
    rows, points = kernel.size1_out(output), kernel.size2_out(output)
    if flat.shape[1] != points * len(t):  # nothing varies with q or t
        flat = np.tile(flat, (1, len(t)))
    return projected(model, flat.reshape(rows, len(t), points)).transpose(1, 0, 2)


def _automatic(true: np.ndarray, ghost: np.ndarray) -> float:
    deformation = float(np.abs(true - ghost).max(initial=0.0))
    size = float(np.ptp(ghost, axis=(0, 2)).max())
    if deformation <= 1e-12 * size or deformation == 0.0:
        return 1.0
    factor = max(1.0, VISIBLE * size / deformation)
    digits = 10.0 ** (np.floor(np.log10(factor)) - 1)
    return float(max(1.0, np.floor(factor / digits) * digits))  # two digits: it is shown to people


def animate(
    solution: Solution,
    path: str | Path,
    frames: int = 60,
    fps: float = 20.0,
    exaggeration: float | None = None,
) -> Film:
    """Write a GIF that repeats: bodies, ghost of the undeformed ones, ground, time. Returns what was drawn.

    Raises ModelError (nothing to draw), ValueError (frames, fps), OutputError (place not writable, not .gif).
    """
    if Path(path).suffix.lower() != ".gif":
        raise OutputError(f"{path}: an animation's name must end in .gif")
    if not 0.1 <= fps <= 50.0:
        raise ArgumentError(f"fps must be between 0.1 and 50 (what GIF players show), not {fps}")
    shown = film(solution, frames, exaggeration)
    images = _images(solution, shown)
    palette = images[len(images) // 2].quantize(colors=64, method=Image.Quantize.MEDIANCUT)
    indexed = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    with replacing(path) as temporary:
        indexed[0].save(
            temporary,
            format="GIF",
            save_all=True,
            append_images=indexed[1:],
            duration=round(1000.0 / fps),
            loop=0,
            optimize=False,
        )
    return shown


def _images(solution: Solution, shown: Film) -> list[Image.Image]:
    """All frames; the unmoving background is drawn once and kept."""
    figure, ax = _stage(solution, shown)
    canvas = figure.canvas
    assert isinstance(canvas, FigureCanvasAgg)
    move, artists = _actors(ax, solution.model, shown)
    canvas.draw()  # animated artists stay out of it
    background = canvas.copy_from_bbox(figure.bbox)
    images = []
    for k in range(len(shown.t)):
        canvas.restore_region(background)
        move(k)
        for artist in artists:
            ax.draw_artist(artist)
        images.append(Image.fromarray(np.asarray(canvas.buffer_rgba()).copy()).convert("RGB"))
    return images


def _stage(solution: Solution, shown: Film) -> tuple[Figure, Axes]:
    """Figure and axes with fixed limits, equal scales, and the ground."""
    low, high = shown.limits
    centre, extent = (low + high) / 2.0, (high - low).max()
    half = (high - low) / 2.0 + 0.08 * (extent if extent > 0 else 1.0)
    inner = np.array([5.6, float(np.clip(5.6 * half[1] / half[0], 2.0, 5.6))])  # inches, left for the drawing
    half = inner * (half / inner).max()  # the same scale along x and y
    outer = inner + (0.85, 1.1)
    figure = Figure(figsize=(float(outer[0]), float(outer[1])), dpi=100)
    FigureCanvasAgg(figure)
    ax = figure.add_axes((0.7 / outer[0], 0.55 / outer[1], inner[0] / outer[0], inner[1] / outer[1]))
    ax.set_xlim(centre[0] - half[0], centre[0] + half[0])
    ax.set_ylim(centre[1] - half[1], centre[1] + half[1])
    ax.set_xlabel(shown.axes[0])
    ax.set_ylabel(shown.axes[1])
    ax.tick_params(labelsize=8)
    ax.grid(True, color="0.92", lw=0.7)
    ax.spines[["top", "right"]].set_visible(False)
    ax.set_title(solution.model.title or solution.model.name, fontsize=10, loc="left", pad=18)
    if shown.exaggeration != 1.0 and solution.model.elastic:
        factor = f"{shown.exaggeration:.0f}" if shown.exaggeration >= 10 else f"{shown.exaggeration:.2g}"
        ax.text(0.0, 1.02, f"deformation x {factor}", transform=ax.transAxes, fontsize=9, color="0.35")
    fixed = _grounded(solution.model, shown)
    ax.plot(fixed[0], fixed[1], ls="", marker="^", ms=11, mfc="0.8", mec="0.35", zorder=1.5)
    return figure, ax


def _grounded(model: Model, shown: Film) -> np.ndarray:
    """(2, k) points of the ground, and points of bodies that do not move although the mechanism does."""
    low, high = shown.limits
    still = np.ptp(shown.xy, axis=0).max(axis=0) <= 1e-9 * max(float((high - low).max()), 1e-300)
    bodies = np.repeat([body == GROUND for body, _ in model.outlines], [count for _, count in model.outlines])
    return shown.xy[0][:, still | bodies]


def _actors(ax: Axes, model: Model, shown: Film) -> tuple[Callable[[int], None], list[Any]]:
    """(function that moves everything to frame k, the artists in drawing order)."""
    flexible = {name.rpartition(".")[0] for name in model.elastic}
    pieces: list[tuple[Any, np.ndarray, slice]] = []
    start, colour = 0, 0
    for body, count in model.outlines:
        part, start = slice(start, start + count), start + count
        if body == GROUND or count == 0:
            continue
        if body in flexible and shown.exaggeration != 0.0:
            (ghost,) = ax.plot([], [], color="0.65", lw=1.2, ls=(0, (4, 3)), animated=True)
            pieces.append((ghost, shown.ghost, part))
        (line,) = ax.plot([], [], color=COLOURS[colour % len(COLOURS)], lw=3.0, solid_capstyle="round", animated=True)
        if body not in flexible or count == 1:
            line.set(marker="s" if count == 1 else "o", ms=10 if count == 1 else 5, mec="white", mew=0.8)
        pieces.append((line, shown.xy, part))
        colour += 1
    clock = ax.text(0.99, 1.02, "", transform=ax.transAxes, ha="right", va="bottom", fontsize=9, animated=True)
    decimals = int(np.clip(3 - np.floor(np.log10(max(float(shown.t[-1]), 1e-9))), 0, 9))

    def move(k: int) -> None:
        for line, source, part in pieces:
            line.set_data(source[k, 0, part], source[k, 1, part])
        clock.set_text(f"t = {shown.t[k]:.{decimals}f} s")

    return move, [line for line, _, _ in pieces] + [clock]
