"""The picture of the frequencies along a motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure

from runtime.operating.along import frequencies_along
from runtime.views.figure import finish, grid, legend, owner, title
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.results.solution import Solution

LOWEST = 1e-6  # of the largest frequency: what is slower does not show on the logarithmic axis
FAINTEST = 0.25  # of a mode that is damped critically or more


def frequencies(
    solution: Solution, path: str | Path | None = None, samples: int = 60, ax: Axes | None = None
) -> Figure:
    """Frequencies |lambda| of the linearised equations over time, fainter the more a mode is damped.

    The right axis is the step at which central differences become unstable for an undamped mode, h = 2 / w. Raises
    ModelError where the model lacks its Jacobians, OutputError.
    """
    found = frequencies_along(solution, samples)
    figure: Figure
    if ax is None:
        figure, (own,) = grid(1, title(solution, "frequencies along the motion"))
    else:
        figure, own = owner(ax), ax
    lowest = LOWEST * max(float(found.frequencies.max(initial=0.0)), 1e-300)
    seen = np.maximum(found.frequencies, lowest)
    for k, name in enumerate(found.names):
        points = np.column_stack([found.t, seen[:, k]])
        colour = np.tile(to_rgba(COLOURS[k % len(COLOURS)]), (len(points) - 1, 1))
        colour[:, 3] = 1.0 - (1.0 - FAINTEST) * np.clip(np.abs(found.damping_ratios[:-1, k]), 0.0, 1.0)
        strokes = list(np.stack([points[:-1], points[1:]], axis=1))
        own.add_collection(LineCollection(strokes, colors=list(map(tuple, colour)), linewidths=1.6))
        own.plot([], [], color=COLOURS[k % len(COLOURS)], lw=1.6, label=name)
    own.set_yscale("log")
    own.set_ylim(0.5 * float(np.min(seen[seen > lowest], initial=seen.max())), 2.0 * float(seen.max()))
    own.set_xlim(found.t[0], found.t[-1])
    own.set_xlabel("time [s]", fontsize=9)
    own.set_ylabel("frequency [rad/s]", fontsize=9)
    limit = own.secondary_yaxis("right", functions=(_step_limit, _step_limit))
    limit.set_ylabel("largest step of central differences [s]", fontsize=8)
    limit.tick_params(labelsize=8)
    legend(own)
    if own.get_legend() is not None:
        own.get_legend().set_bbox_to_anchor((1.2, 0.5))  # beyond the right axis and its words
    return finish(figure, path)


def _step_limit(w: np.ndarray) -> np.ndarray:
    """h = 2 / w, which is its own inverse."""
    return np.asarray(2.0 / np.maximum(np.asarray(w, dtype=float), 1e-300))
