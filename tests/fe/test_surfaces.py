"""Surfaces for pictures: closed, of the right area, moved by the modes as the nodes are; thinned they keep shape."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from numpy.testing import assert_allclose

from symgen.fe import FiniteElementError, FlexibleBody
from symgen.fe.connecting_rod import BIG_EYE, connecting_rod
from symgen.fe.stresses import boundary_triangles
from tests.fe.test_solids import FACES, MATERIAL, SIZE, hexahedra, tetrahedra

AREA = 2 * float(SIZE[0] * SIZE[1] + SIZE[1] * SIZE[2] + SIZE[2] * SIZE[0])


def area(vertices: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


@pytest.mark.parametrize("mesh", [hexahedra(), tetrahedra()], ids=["hexahedra", "tetrahedra"])
def test_the_boundary_of_a_box_is_closed_and_has_its_area(mesh) -> None:
    triangles = boundary_triangles(mesh)
    assert area(mesh.p.T, triangles) == pytest.approx(AREA, rel=1e-12)
    edges = Counter(tuple(sorted((int(t[i]), int(t[j])))) for t in triangles for i, j in ((0, 1), (1, 2), (2, 0)))
    assert set(edges.values()) == {2}


def test_vertices_move_with_the_modes_of_their_nodes() -> None:
    """The mean over the wall of an eye is the marker's own shape."""
    rod = connecting_rod(modes=4)
    surface = rod.surface()
    wall = np.hypot(*surface["vertices"][:, :2].T) <= BIG_EYE[0] * 1.001
    layers, count = np.unique(np.round(surface["vertices"][wall, 2], 6), return_counts=True)
    assert len(layers) == 3 and set(count) == {16}
    seen = surface["shapes"][wall].mean(axis=0)
    size = np.abs(surface["shapes"]).max()
    assert_allclose(seen, rod.markers["big_end"].shape, atol=0.02 * size)
    assert surface["vertices"].dtype == np.float32 and surface["shapes"].shape[2] == 4


def test_thinning_keeps_the_box() -> None:
    body = FlexibleBody.from_mesh(hexahedra(80), MATERIAL, order=1, modes=3, interface=FACES)
    full, few = body.surface(), body.surface(max_triangles=500)
    assert len(few["triangles"]) <= 500 < len(full["triangles"])
    assert_allclose(np.ptp(few["vertices"], axis=0), SIZE, rtol=0.2)
    assert area(few["vertices"], few["triangles"]) == pytest.approx(AREA, rel=0.25)


def test_a_body_without_faces_says_so() -> None:
    body = FlexibleBody.from_mesh(hexahedra(), MATERIAL, order=1, modes=3, interface=FACES)
    s = body.structure
    nodes = np.column_stack([s.ids, s.positions])
    bare = FlexibleBody.from_matrices(s.K, s.M, nodes, modes=3, interface={"left": s.ids[s.positions[:, 0] < 1e-9]})
    with pytest.raises(FiniteElementError, match="have no faces"):
        bare.surface()
