"""A connecting rod from a mesh of hexahedra, reduced to six modes: 5,205 degrees of freedom become six.

The built-in scene spatial_slider_crank uses its data: `write` makes symgen/scenes/connecting_rod.json.
"""

import json
import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen.fe import FlexibleBody
from symgen.fe.connecting_rod import connecting_rod


def write(rod: FlexibleBody, path: Path) -> None:
    """The modal data as JSON, with the surface that pictures show."""
    path.write_text(json.dumps(rod.fields(damping_ratio=0.002, surface=2000), indent=1) + "\n", encoding="utf-8")


def main(picture: Path | None = None, out: Path | None = None) -> None:
    """It prints what the reduction keeps and loses, and writes the data where `out` says."""
    rod = connecting_rod(modes=6)
    print(rod.report())
    if out:
        write(rod, out)
    if picture:
        surface, figure = rod.surface(max_triangles=2000), Figure(figsize=(10, 5), dpi=120)
        for k in range(4):
            left, low = 0.5 * (k % 2), 0.5 - 0.5 * (k // 2)
            ax = figure.add_axes((left, low - 0.27, 0.5, 1.0), projection="3d", facecolor="none")  # they overlap
            shape = surface["shapes"][:, :, k]
            moved = surface["vertices"] + 0.03 * shape / np.abs(shape).max()
            ax.plot_trisurf(*moved.T, triangles=surface["triangles"], color="#6baed6", lw=0.1, edgecolor="0.4")
            figure.text(left + 0.25, low + 0.42, f"mode {k + 1}: {rod.frequencies[k]:.0f} Hz", ha="center")
            ax.set_box_aspect(np.ptp(moved, axis=0), zoom=1.05)
            ax.set_axis_off()
            ax.view_init(35, -75)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
