"""The connecting rod of the examples: two eyes and a tapered shank, meshed with hexahedra."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from symgen.fe.body import FlexibleBody
from symgen.fe.structure import STEEL, FiniteElementError, Flags, Integers, Material
from symgen.modes.cleaning import Array

if TYPE_CHECKING:
    import skfem

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


def connecting_rod(modes: int = 6, mode_set: str = "free", material: Material = STEEL) -> FlexibleBody:
    """The rod as a body with the markers big_end (the origin) and small_end (at x = 0.3 m), pins along z.

    Quadratic hexahedra, 6,000 degrees of freedom; steel unless told otherwise. Arguments as those of
    `FlexibleBody.from_structure`. Raises FiniteElementError, also without scikit-fem.
    """
    return FlexibleBody.from_mesh(
        connecting_rod_mesh(),
        material,
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


def connecting_rod_mesh() -> skfem.MeshHex:
    """The mesh: straight-sided hexahedra, the same in every layer. Raises FiniteElementError without scikit-fem."""
    try:
        from skfem import MeshHex
    except ImportError as error:
        raise FiniteElementError("scikit-fem", "it is not installed", "pip install 'symgen[fe]'") from error
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


def _in_eye(places: Array, centre: float, radius: float) -> Flags:
    """Which of the places (n, 3) are on the inner wall of an eye; nodes between corners lie on the chords."""
    return np.hypot(places[:, 0] - centre, places[:, 1]) <= radius * (1.0 + SAME)


def _eye(centre: float, radii: tuple[float, float], facing: float) -> Array:
    """Corners (m, 4, 2) of a ring, the middle of the joint with the shank at the angle `facing`."""
    angles = np.linspace(-JOINT, 2.0 * np.pi - JOINT, AROUND + 1) + facing
    inner, outer = (_arc(centre, radius, angles) for radius in radii)
    return np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]], axis=1)


def _shank() -> Array:
    """Corners (m, 4, 2) of the shank, between the arcs where it meets the eyes."""
    angles = np.linspace(-JOINT, JOINT, ACROSS + 1)
    here, there = _arc(0.0, BIG_EYE[1], angles), _arc(LENGTH, SMALL_EYE[1], np.pi - angles)
    share = np.linspace(0.0, 1.0, ALONG + 1)[:, None, None]
    grid = (1.0 - share) * here + share * there
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 2)


def _arc(centre: float, radius: float, angles: Array) -> Array:
    return np.column_stack([centre + radius * np.cos(angles), radius * np.sin(angles)])


def _joined(corners: Array) -> tuple[Array, Integers]:
    """Points (n, 2) and places (m, 4) of quadrilaterals, corners at the same place made one."""
    flat = corners.reshape(-1, 2)
    _, first, inverse = np.unique(np.round(flat / (SAME * LENGTH)), axis=0, return_index=True, return_inverse=True)
    return flat[first], np.asarray(inverse, dtype=np.int64).reshape(-1, 4)
