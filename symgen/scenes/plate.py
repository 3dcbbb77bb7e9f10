"""A plate in plane stress with a finely meshed spot, assembled in NumPy: the paper's Fig. 1 in earnest.

Square of side 1 m, held on its left edge, pulled at the middle of its right edge by a short pulse. Right-angled
triangles, bisected (newest vertex first) about the middle of the plate.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp

from symgen.mechanism.builder import Scene
from symgen.scene.structures import StructureScene

YOUNGS_MODULUS, POISSON, DENSITY = 2.1e11, 0.3, 7850.0  # steel
PULSE = 5e-5  # [s]
FORCE = 1e6  # [N]


class Plate(NamedTuple):
    """K (n, n) [N/m], lumped M (n,) [kg], points (nodes, 2) [m], cells (triangles, 3), names of coordinates, the
    one pulled.
    """

    stiffness: sp.csr_matrix
    mass: np.ndarray
    points: np.ndarray
    cells: np.ndarray
    names: list[str]
    pulled: str


def plate_scene(divisions: int = 60, refinements: int = 6, radius: float = 0.03) -> StructureScene:
    """The plate as a scene; parameters force [N] and pulse [s]."""
    found = plate(divisions, refinements, radius)
    scene = Scene("plate", title="Plate with a fine spot").parameter("force", FORCE, "N").parameter("pulse", PULSE, "s")
    made: StructureScene = scene.structure(
        mass=found.mass, stiffness=found.stiffness, coordinates=found.names, width=2, points=found.points,
        cells=found.cells, force={found.pulled: "force * where(t < pulse, sin(pi * t / pulse)**2, 0)"},
    )  # fmt: skip
    return made


def plate(divisions: int = 60, refinements: int = 6, radius: float = 0.03) -> Plate:
    """The plate with so many squares along a side, and triangles within `radius` [m] bisected so many times twice."""
    points, cells = _mesh(divisions)
    for _ in range(refinements):
        middle = points[cells].mean(axis=1) - 0.5
        points, cells = _bisected(points, cells, np.hypot(*middle.T) < radius)
    K, M = _assembled(points, cells)
    free = np.flatnonzero(points[:, 0] > 1e-9)
    place = np.full(len(points), -1)
    place[free] = np.arange(len(free))
    rows = (2 * free[:, None] + [0, 1]).ravel()
    names = [f"n{node}.{axis}" for node in range(len(free)) for axis in "xy"]
    pulled = int(np.argmin(np.hypot(points[free, 0] - 1, points[free, 1] - 0.5)))
    inside = np.all(place[cells] >= 0, axis=1)  # triangles at the held edge are not drawn
    return Plate(sp.csr_matrix(K[rows][:, rows]), M[rows], points[free], place[cells[inside]], names, f"n{pulled}.x")


def _mesh(divisions: int) -> tuple[np.ndarray, np.ndarray]:
    """Squares cut along one diagonal; the corner opposite to the longest side comes first."""
    side = np.linspace(0, 1, divisions + 1)
    points = np.column_stack([np.tile(side, divisions + 1), np.repeat(side, divisions + 1)])
    a = (np.arange(divisions)[:, None] * (divisions + 1) + np.arange(divisions)).ravel()
    b, c, d = a + 1, a + divisions + 2, a + divisions + 1
    return points, np.concatenate([np.column_stack([b, c, a]), np.column_stack([d, a, c])])


def _bisected(points: np.ndarray, cells: np.ndarray, marked: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Cut the marked triangles across their longest side, and others until no node hangs on a side.

    Each triangle's longest side is that from its second to its third corner.
    """
    while marked.any():
        longest = np.sort(cells[:, 1:], axis=1)
        sides = np.unique(longest[marked], axis=0)
        key = longest @ [len(points), 1]
        cut = np.isin(key, sides @ [len(points), 1])
        number = np.searchsorted(sides @ [len(points), 1], key[cut]) + len(points)
        points = np.concatenate([points, points[sides].mean(axis=1)])
        first, second, third = cells[cut].T
        halves = np.concatenate([np.column_stack([number, first, second]), np.column_stack([number, third, first])])
        cells = np.concatenate([cells[~cut], halves])
        marked = _hanging(cells, np.sort(sides, axis=1), len(points))
    return points, cells


def _hanging(cells: np.ndarray, sides: np.ndarray, count: int) -> np.ndarray:
    """Triangles that still have a side whose middle is a node."""
    found = np.zeros(len(cells), dtype=bool)
    for one, other in ((0, 1), (1, 2), (2, 0)):
        found |= np.isin(np.sort(cells[:, [one, other]], axis=1) @ [count, 1], sides @ [count, 1])
    return found


def _assembled(points: np.ndarray, cells: np.ndarray) -> tuple[sp.csr_matrix, np.ndarray]:
    """K and lumped M of triangles of constant strain, a metre thick (plane stress)."""
    x, y = points[cells].transpose(2, 1, 0)
    area = abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 2
    signed = ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 2
    b = np.array([y[1] - y[2], y[2] - y[0], y[0] - y[1]]) / (2 * signed)
    c = np.array([x[2] - x[1], x[0] - x[2], x[1] - x[0]]) / (2 * signed)
    strain = np.zeros((len(cells), 3, 6))
    strain[:, 0, 0::2], strain[:, 1, 1::2] = b.T, c.T
    strain[:, 2, 0::2], strain[:, 2, 1::2] = c.T, b.T
    E, nu = YOUNGS_MODULUS, POISSON
    elastic = E / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    blocks = np.einsum("nji,jk,nkl->nil", strain, elastic, strain) * area[:, None, None]
    rows = (2 * cells[:, :, None] + [0, 1]).reshape(len(cells), 6)
    where = np.repeat(rows, 6, axis=1).ravel(), np.tile(rows, (1, 6)).ravel()
    K = sp.csr_matrix((blocks.ravel(), where), shape=(2 * len(points),) * 2)
    mass = np.zeros(len(points))
    np.add.at(mass, cells.ravel(), np.repeat(DENSITY * area / 3, 3))
    return (K + K.T) / 2, np.repeat(mass, 2)
