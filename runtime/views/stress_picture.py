"""Von Mises stress at the gauges of a finite-element body over time, by equilibrium and as the sum of modes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from runtime.contract.errors import ModelError
from runtime.results.stresses import stresses as stresses_at
from runtime.views.figure import finish, grid, legend, prefixed, title
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from runtime.results.solution import Solution

MOST_GAUGES = 8


def stresses(solution: Solution, body: str, path: str | Path | None = None) -> Figure:
    """The gauges of `body` that bear most, the most loaded first; dashed: what the modes say.

    Raises ModelError for a body without gauges, OutputError.
    """
    modal = stresses_at(solution, body, way="modes")
    try:
        found, ways = stresses_at(solution, body), [("-", "equilibrium"), ("--", "modes")]
    except ModelError:  # gauges that know modal stresses only
        found, ways = modal, [("--", "modes")]
    shown = np.argsort(-found.von_mises.max(axis=0))[:MOST_GAUGES]
    figure, (ax,) = grid(1, title(solution, f"von Mises stress of {body}"))
    factor, unit = prefixed(found.von_mises[:, shown], "Pa")
    for k, gauge in enumerate(shown):
        for style, way in ways:
            values = (found if way == "equilibrium" else modal).von_mises[:, gauge]
            name = f"{found.gauges[gauge]}, {way}"
            ax.plot(found.t, factor * values, style, color=COLOURS[k % len(COLOURS)], lw=1.2, label=name)
    largest = found.largest()
    about = f"at most {factor * largest.value:.3g} {unit}, {largest.gauge} at {largest.t:.4g} s"
    ax.set_title(about, fontsize=9.5, loc="left", fontweight="bold")
    ax.set_ylabel(f"[{unit}]", fontsize=9)
    ax.set_xlabel("t [s]", fontsize=9)
    legend(ax)
    return finish(figure, path)
