"""A model as it stands at the start, as a small SVG: the lines of a film at one instant."""

from __future__ import annotations

import numpy as np

from runtime.contract.model import Model
from runtime.views.curves import COLOURS
from runtime.views.film import Line, lines_of
from runtime.views.mechanism import still

WIDTH, HIGHEST, MARGIN = 300.0, 200.0, 14.0  # pixels
WIDTHS = {"beam": 3.0, "body": 4.0, "outline": 1.2, "spring": 1.2, "rod": 1.5}


def model_sketch(model: Model) -> str:
    """SVG of the initial position with the default parameters; "" if there is nothing to draw."""
    if not model.has("geometry"):
        return ""
    lines = lines_of(still(model), 1.0)
    points = np.concatenate([line.xy[0] for line in lines], axis=1)
    low, high = np.nanmin(points, axis=1), np.nanmax(points, axis=1)
    size = np.maximum(high - low, 1e-3 * max(float((high - low).max()), 1e-9))
    scale = min((WIDTH - 2 * MARGIN) / size[0], (HIGHEST - 2 * MARGIN) / size[1])
    height = 2 * MARGIN + scale * size[1]
    drawn = "".join(
        _drawn(line, np.array([MARGIN, height - MARGIN])[:, None] + scale * (line.xy[0] - low[:, None]) * [[1], [-1]])
        for line in sorted(lines, key=lambda line: line.kind in ("joint", "slide", "ground"))
        if line.kind != "ghost"
    )
    return f'<svg width="{WIDTH:.0f}" height="{height:.0f}" style="display:block;margin:4px 0">{drawn}</svg>'


def _drawn(line: Line, xy: np.ndarray) -> str:
    """One line in pixels (2, n), NaN where the pen is lifted; joints and the ground as marks."""
    if line.kind in ("joint", "slide", "ground") or xy.shape[1] == 1:
        kind = "slide" if line.kind == "body" else line.kind
        return "".join(_mark(kind, x, y) for x, y in xy.T)
    path, command = [], "M"
    for x, y in xy.T:
        if not np.isnan(x):
            path.append(f"{command}{x:.1f} {y:.1f}")
        command = "M" if np.isnan(x) else "L"
    colour = COLOURS[line.colour % len(COLOURS)] if line.colour >= 0 else "#555"
    style = f'fill="none" stroke="{colour}" stroke-width="{WIDTHS[line.kind]}" stroke-linecap="round"'
    return f'<path d="{"".join(path)}" {style}/>'


def _mark(kind: str, x: float, y: float) -> str:
    if kind == "ground":
        return f'<path d="M{x:.1f} {y - 7:.1f}l7 12h-14z" fill="#ccc" stroke="#555"/>'
    if kind == "slide":
        return f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" fill="#fff" stroke="#333"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.2" fill="#fff" stroke="#333"/>'
