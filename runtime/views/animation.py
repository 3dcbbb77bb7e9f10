"""The mechanism in motion as a GIF or an MP4: the lines of a film, drawn with Agg."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from PIL import Image

from runtime.contract.arguments import NUMBER, PLACE, WHOLE, require
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.files import OutputError, replacing
from runtime.views.curves import COLOURS
from runtime.views.figure import finish, grid, literal, owner, title
from runtime.views.film import MAX_FRAMES, Film, Line, film, film_at, projected
from runtime.views.mechanism import Scenery, scenery

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.solutions.solution import Solution


STYLES: dict[str, dict[str, Any]] = {
    "beam": {"lw": 3.0, "solid_capstyle": "round", "zorder": 3},
    "body": {"lw": 4.0, "solid_capstyle": "round", "zorder": 3},
    "outline": {"lw": 1.4, "solid_capstyle": "round", "color": "0.6", "zorder": 3},
    "ghost": {"lw": 1.2, "ls": (0, (4, 3)), "color": "0.65", "zorder": 2},
    "spring": {"lw": 1.2, "color": "0.25", "zorder": 2.5},
    "rod": {"lw": 1.5, "color": "0.25", "zorder": 2.5},
    "joint": {"ls": "", "marker": "o", "ms": 6, "mfc": "white", "mec": "0.2", "mew": 1.2, "zorder": 4},
    "slide": {"ls": "", "marker": "s", "ms": 9, "mfc": "white", "mec": "0.2", "mew": 1.2, "zorder": 4},
    "ground": {"ls": "", "marker": "^", "ms": 11, "mfc": "0.8", "mec": "0.35", "zorder": 1.5},
}


def animate(
    solution: Solution,
    path: str | Path,
    frames: int = 60,
    fps: float = 20.0,
    exaggeration: float | None = None,
) -> Film:
    """Write a film of bodies, ghosts of the undeformed ones, springs, joints, ground and time.

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path
        Its ending says the format: `.gif` repeats, `.mp4` is H.264 (extra `film`).
    frames : int
        How many, at even times of the run.
    fps : float
        Frames a second, 0.1 to 50, which is what GIF players show.
    exaggeration : float, optional
        Factor of the deformation; by default one that makes the largest visible.

    Returns
    -------
    Film
        What was drawn.

    Raises
    ------
    ModelError
        If there is nothing to draw.
    ArgumentError
        If frames or fps are out of range.
    OutputError
        If the place is not writable, or the name has another ending.
    ImportError
        If imageio-ffmpeg is not installed and an MP4 is asked for.
    """
    require(PLACE, path=path)
    require(WHOLE, frames=frames)
    require(NUMBER, fps=fps)
    require(NUMBER, or_none=True, exaggeration=exaggeration)
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4"):
        raise OutputError(
            f"{path}: a film's name must end in .gif or .mp4; the page of `run.view` records a video, too"
        )
    if not 0.1 <= fps <= 50.0:
        raise ArgumentError(f"fps must be between 0.1 and 50 (what GIF players show), not {fps}")
    save = _save_gif if suffix == ".gif" else _mp4_writer()
    shown = film(solution, frames, exaggeration)
    images = _images(solution, shown)
    with replacing(path) as temporary:
        save(images, temporary, fps)
    return shown


def _mp4_writer() -> Callable[[Iterator[Image.Image], Path, float], None]:
    try:
        from imageio_ffmpeg import count_frames_and_secs, write_frames
    except ImportError as error:
        raise ImportError("imageio-ffmpeg is not installed; install it with: pip install 'symgen[film]'") from error

    def save(images: Iterator[Image.Image], path: Path, fps: float) -> None:
        place, first, sent = str(path.absolute()), next(images), 0  # no name that ffmpeg takes for an option
        width, height = (2 * (length // 2) for length in first.size)  # colours have half the resolution: even
        writer = write_frames(place, (width, height), fps=fps, codec="libx264", macro_block_size=2)
        writer.send(None)
        try:
            for image in chain([first], images):
                writer.send(image.crop((0, 0, width, height)).tobytes())
                sent += 1
        finally:
            writer.close()
        if count_frames_and_secs(place)[0] != sent:  # the encoder's exit status is not told
            raise OSError("the encoder did not write all frames")

    return save


def _save_gif(drawn: Iterator[Image.Image], path: Path, fps: float) -> None:
    images = list(drawn)
    palette = images[len(images) // 2].quantize(colors=64, method=Image.Quantize.MEDIANCUT)
    indexed = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    indexed[0].save(
        path,
        format="GIF",
        save_all=True,
        append_images=indexed[1:],
        duration=round(1000.0 / fps),
        loop=0,
        optimize=False,
    )


def _images(solution: Solution, shown: Film) -> Iterator[Image.Image]:
    """All frames; the unmoving background is drawn once and kept."""
    figure, ax = _stage(solution, shown)
    canvas = figure.canvas
    assert isinstance(canvas, FigureCanvasAgg)
    move, artists = _actors(ax, shown)
    canvas.draw()  # animated artists stay out of it
    background = canvas.copy_from_bbox(figure.bbox)
    for k in range(len(shown.t)):
        canvas.restore_region(background)
        move(k)
        for artist in artists:
            ax.draw_artist(artist)
        yield Image.fromarray(np.asarray(canvas.buffer_rgba()).copy()).convert("RGB")


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
    ax.set_title(literal(solution.model.title or solution.model.name), fontsize=10, loc="left", pad=18)
    if shown.exaggeration != 1.0 and solution.model.elastic:
        factor = f"{shown.exaggeration:.0f}" if shown.exaggeration >= 10 else f"{shown.exaggeration:.2g}"
        ax.text(0.0, 1.02, f"deformation x {factor}", transform=ax.transAxes, fontsize=9, color="0.35")
    return figure, ax


def _actors(ax: Axes, shown: Film) -> tuple[Callable[[int], None], list[Any]]:
    """(function that moves everything to frame k, the artists in drawing order)."""
    pieces: list[tuple[Any, Line]] = []
    for line in shown.lines:
        (artist,) = ax.plot([], [], animated=True, **_style(line))
        pieces.append((artist, line))
    clock = ax.text(0.99, 1.02, "", transform=ax.transAxes, ha="right", va="bottom", fontsize=9, animated=True)
    decimals = int(np.clip(3 - np.floor(np.log10(max(float(shown.t[-1]), 1e-9))), 0, 9))

    def move(k: int) -> None:
        for artist, line in pieces:
            artist.set_data(line.xy[k, 0], line.xy[k, 1])
        clock.set_text(f"t = {shown.t[k]:.{decimals}f} s")

    in_order = sorted((artist for artist, _ in pieces), key=lambda artist: artist.get_zorder())
    return move, [*in_order, clock]


# ---- A mechanism at several instants in one picture, later ones darker, with the paths of chosen markers.

PALEST = 0.2  # opacity of the first instant
LAST_ONLY = ("ghost", "joint", "slide")  # kinds that would crowd the picture at every instant
PATH_POINTS = 600
LEAST_ASPECT = 0.2  # of the axes of a picture
MOST_TICKS = 7  # along x, fewer where the picture is narrow


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
                ax.plot(*line.xy[frame], **_faded(line, (frame + 1) / len(times)))
    ax.set_aspect("equal")
    (left, right), (low, high) = _not_too_slim(ax.get_xlim(), ax.get_ylim())
    ax.set_xlim(left, right)
    ax.set_ylim(low, high)
    ax.xaxis.set_major_locator(MaxNLocator(int(np.clip(MOST_TICKS * (right - left) / (high - low), 2, MOST_TICKS))))
    ax.set_xlabel(shown.axes[0], fontsize=9)
    ax.set_ylabel(shown.axes[1], fontsize=9)
    paths_of = f"\nthin: path of {', '.join(traces)}" if traces else ""  # a legend would cover what is drawn
    ax.set_title(_heading(times, shown) + paths_of, fontsize=9.5, loc="left")
    return finish(figure, path)


def _not_too_slim(*limits: tuple[float, float]) -> list[tuple[float, float]]:
    """Limits of two axes, of which neither is shorter than a fifth of the other: a point may move along one of them."""
    least = LEAST_ASPECT * max(high - low for low, high in limits)
    return [
        ((low + high - least) / 2, (low + high + least) / 2) if high - low < least else (low, high)
        for low, high in limits
    ]


def _times(solution: Solution, instants: int | Sequence[float]) -> np.ndarray:
    if isinstance(instants, int):
        times = np.linspace(solution.t[0], solution.t[-1], max(instants, 0))
    else:
        times = np.asarray(instants, dtype=float)
        ends = np.clip(times, solution.t[0], solution.t[-1])
        times = np.where(np.abs(times - ends) <= 1e-9 * np.ptp(solution.t), ends, times)  # 3.0 of a run to 3 - 4e-16 s
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


def _style(line: Line) -> dict[str, Any]:
    style = dict(STYLES[line.kind])
    if line.kind in ("beam", "body", "outline") and line.colour >= 0:
        style["color"] = COLOURS[line.colour % len(COLOURS)]
        if line.xy.shape[2] == 1:
            style |= {"marker": "s", "ms": 9, "mec": "white", "mew": 0.8}
    return style


def _faded(line: Line, share: float) -> dict[str, Any]:
    """The style at a share of the time."""
    style = _style(line)
    if line.kind != "ground":
        style["alpha"] = PALEST + (1.0 - PALEST) * share**2
        style["zorder"] = style["zorder"] + 0.5 * share
    return style


def _heading(times: np.ndarray, shown: Film) -> str:
    first, last = np.where(np.abs(times[[0, -1]]) > 1e-9 * np.abs(times).max(), times[[0, -1]], 0.0)
    span = f"t = {last:.4g} s" if len(times) == 1 else f"{len(times)} instants, t = {first:.4g} to {last:.4g} s"
    factor = shown.exaggeration
    return span + (f", deformation x {factor:.3g}" if any(line.kind == "ghost" for line in shown.lines) else "")
