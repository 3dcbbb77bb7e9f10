"""A connecting rod from a mesh of hexahedra, reduced to six modes: 5,205 degrees of freedom become six.

The built-in scene spatial_slider_crank uses its data: `write` makes symgen/scenes/connecting_rod.json.
"""

import json
import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from skfem import MeshHex

from symgen.fe import STEEL, FlexibleBody

LENGTH = 0.3  # between the axes of the eyes [m]
THICKNESS = 0.008  # along the pins, z
BIG_EYE = (0.016, 0.026)  # inner and outer radius
SMALL_EYE = (0.009, 0.016)

AROUND = 16  # cells around an eye
ACROSS = 2  # of these the shank joins so many: it is 20 mm wide at the big eye and 12 mm at the small one
ALONG = 16
LAYERS = 2
JOINT = np.pi * ACROSS / AROUND  # half the angle over which the shank joins an eye
SAME = 1e-6  # of the radius


def connecting_rod(modes: int = 6, mode_set: str = "free") -> FlexibleBody:
    """The rod as a body with the markers big_end (the origin) and small_end (at x = 0.3 m), pins along z.

    Quadratic hexahedra; arguments as those of `FlexibleBody.from_structure`.
    """
    return FlexibleBody.from_mesh(
        connecting_rod_mesh(),
        STEEL,
        order=2,
        modes=modes,
        mode_set=mode_set,
        origin="big_end",
        marker_positions={"big_end": (0.0, 0.0, 0.0), "small_end": (LENGTH, 0.0, 0.0)},
        interface={
            "big_end": lambda places: _in_eye(places, 0.0, BIG_EYE[0]),
            "small_end": lambda places: _in_eye(places, LENGTH, SMALL_EYE[0]),
        },
    )


def connecting_rod_mesh() -> MeshHex:
    """The mesh: straight-sided hexahedra, the same in every layer."""
    corners = np.concatenate([_eye(0.0, BIG_EYE, 0.0), _shank(), _eye(LENGTH, SMALL_EYE, np.pi)])
    points, quads = _joined(corners)
    n = len(points)
    z = np.linspace(-0.5 * THICKNESS, 0.5 * THICKNESS, LAYERS + 1)
    nodes = np.concatenate([np.column_stack([points, np.full(n, height)]) for height in z])
    a, b, c, d = quads.T
    # scikit-fem numbers the corners of a cell from (1, 1, 1) to (0, 0, 0);
    # a, b, c, d are those at (0, 0), (1, 0), (1, 1), (0, 1) of the layer.
    cells = [np.stack([c + n, c, b + n, d + n, b, d, a + n, a]) + layer * n for layer in range(LAYERS)]
    return MeshHex(nodes.T.copy(), np.concatenate(cells, axis=1))


def _in_eye(places: np.ndarray, centre: float, radius: float) -> np.ndarray:
    """Which of the places (n, 3) are on the inner wall of an eye; nodes between corners lie on the chords."""
    return np.hypot(places[:, 0] - centre, places[:, 1]) <= radius * (1.0 + SAME)


def _eye(centre: float, radii: tuple[float, float], facing: float) -> np.ndarray:
    """Corners (m, 4, 2) of a ring, the middle of the joint with the shank at the angle `facing`."""
    angles = np.linspace(-JOINT, 2.0 * np.pi - JOINT, AROUND + 1) + facing
    inner, outer = (_arc(centre, radius, angles) for radius in radii)
    return np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]], axis=1)


def _shank() -> np.ndarray:
    """Corners (m, 4, 2) of the shank, between the arcs where it meets the eyes."""
    angles = np.linspace(-JOINT, JOINT, ACROSS + 1)
    here, there = _arc(0.0, BIG_EYE[1], angles), _arc(LENGTH, SMALL_EYE[1], np.pi - angles)
    share = np.linspace(0.0, 1.0, ALONG + 1)[:, None, None]
    grid = (1.0 - share) * here + share * there
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 2)


def _arc(centre: float, radius: float, angles: np.ndarray) -> np.ndarray:
    return np.column_stack([centre + radius * np.cos(angles), radius * np.sin(angles)])


def _joined(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 2) and places (m, 4) of quadrilaterals, corners at the same place made one."""
    flat = corners.reshape(-1, 2)
    _, first, inverse = np.unique(np.round(flat / (SAME * LENGTH)), axis=0, return_index=True, return_inverse=True)
    return flat[first], inverse.reshape(-1, 4)


def write(rod: FlexibleBody, path: Path) -> None:
    """The modal data as JSON, with the surface that pictures show."""
    path.write_text(json.dumps(rod.fields(damping_ratio=0.002, surface=2000), indent=1) + "\n", encoding="utf-8")


def main(picture: Path | None = None, out: Path | None = None) -> None:
    """Say what the reduction keeps and loses, and write the data where `out` says."""
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
