"""The surface of a finite-element body as triangles with its modes, for pictures; thinned where there are many."""

from __future__ import annotations

from typing import Any

import numpy as np

from symgen.fe.errors import FiniteElementError
from symgen.fe.structure import AXES, Integers
from symgen.modes.cleaning import Array

ROUNDS = ((0, 1, 2, 3), (0, 1, 3, 2), (0, 2, 1, 3))  # the three ways around four corners
GROWTH = 1.25  # of the cells in which vertices are made one


def boundary_triangles(mesh: Any) -> Integers:
    """Triangles (m, 3) of vertices on the boundary of a scikit-fem mesh; a quadrilateral gives two."""
    facets = np.asarray(mesh.facets[:, mesh.boundary_facets()], dtype=np.int64).T
    if facets.shape[1] == AXES:
        return facets
    corners = np.asarray(mesh.p).T[facets]  # (m, 4, 3); scikit-fem sorts the corners of a facet by number
    around = [np.linalg.norm(corners[:, order] - corners[:, np.roll(order, 1)], axis=2).sum(axis=1) for order in ROUNDS]
    ordered = np.take_along_axis(facets, np.array(ROUNDS)[np.argmin(around, axis=0)], axis=1)
    return np.concatenate([ordered[:, [0, 1, 2]], ordered[:, [0, 2, 3]]])


def thinned(positions: Array, triangles: Integers, most: int) -> tuple[Integers, Integers]:
    """(places of the vertices that are kept, triangles of them), at most so many.

    Vertices in the same cell of a grid become the first of them; the grid is made coarser until it suffices.
    """
    used, triangles = np.unique(triangles, return_inverse=True)
    triangles = triangles.reshape(-1, AXES)
    kept, coarse = np.arange(len(used)), triangles
    size = float(np.ptp(positions[used], axis=0).max()) * most**-0.5 / 2.0
    while len(coarse) > most:
        size *= GROWTH
        cells = np.floor((positions[used] - positions[used].min(axis=0)) / size).astype(np.int64)
        _, kept, which = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        coarse = which.reshape(-1)[triangles]
        whole = (coarse[:, 0] != coarse[:, 1]) & (coarse[:, 1] != coarse[:, 2]) & (coarse[:, 2] != coarse[:, 0])
        coarse = coarse[whole]
        coarse = coarse[np.unique(np.sort(coarse, axis=1), axis=0, return_index=True)[1]]
    return used[kept], coarse


def surface_data(positions: Array, nodal: Array, triangles: Integers, origin: Array, most: int) -> dict[str, Array]:
    """vertices (n, 3) [m] from `origin`, triangles (m, 3), shapes (n, 3, nf) of the nodes' positions and shapes.

    Raises FiniteElementError without triangles, and for fewer than 4 of them.
    """
    if not len(triangles):
        raise FiniteElementError(
            "surface",
            "matrices and beams have no faces",
            "give triangles: places of three nodes each, (m, 3), or make the body from a solid mesh",
        )
    if most < 4:
        raise FiniteElementError("max_triangles", f"is {most}", "give at least 4")
    if triangles.min() < 0 or triangles.max() >= len(positions):
        raise FiniteElementError(
            "triangles", "name nodes that are not there", f"give places from 0 to {len(positions) - 1}"
        )
    kept, found = thinned(positions, triangles, most)
    return {
        "vertices": np.array(positions[kept] - origin, dtype=np.float32),
        "triangles": found.astype(np.int32),
        "shapes": np.array(nodal[kept], dtype=np.float32),
    }
