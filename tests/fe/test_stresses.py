"""Stresses of solid bodies from their modal coordinates, against the textbook."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from symgen.fe import FiniteElementError, FlexibleBody, LineMesh, Material, Section

skfem = pytest.importorskip("skfem")
L, A, B = 0.2, 0.02, 0.01
MATERIAL = Material(E=2.0e11, nu=0.0, rho=7800.0)


@pytest.fixture(scope="module")
def bar() -> FlexibleBody:
    """A bar along x with its ends as rigid interfaces, and the static shapes of their motions."""
    sides = [np.linspace(0.0, L, 5), np.array([-A / 2, A / 2]), np.array([-B / 2, B / 2])]
    return FlexibleBody.from_mesh(
        skfem.MeshHex.init_tensor(*sides),
        MATERIAL,
        interface={"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > L - 1e-9},
        modes=0,
        mode_set="fixed_interface",
        origin="root",
    )


def coordinates(bar: FlexibleBody, motion: int) -> np.ndarray:
    """q_f of 1 mm (or 1 mrad) between the interfaces, in component `motion`, as the markers see it."""
    root, tip = (np.vstack([one.shape, one.rotation]) for one in (bar.markers["root"], bar.markers["tip"]))
    carry = np.eye(6)
    carry[1, 5], carry[2, 4] = L, -L  # a turn of the root carries the tip
    wanted = np.zeros(6)
    wanted[motion] = 1e-3
    return np.linalg.lstsq(tip - carry @ root, wanted, rcond=None)[0]


def test_a_pulled_bar(bar: FlexibleBody) -> None:
    """sigma = E u / L everywhere, and nothing else; von Mises the same."""
    stresses, q_f = bar.stresses(), coordinates(bar, 0)
    (tensor,) = stresses.of(q_f)
    expected = MATERIAL.E * 1e-3 / L
    assert_allclose(tensor[0, 0], expected, rtol=1e-6)
    tensor[0, 0] = 0.0
    assert np.abs(tensor).max() < 1e-6 * expected
    both = stresses.von_mises([q_f, -2 * q_f])
    assert_allclose(both[0], expected, rtol=1e-6)
    assert_allclose(both[1], 2 * expected, rtol=1e-6)


def test_pure_bending(bar: FlexibleBody) -> None:
    """Ends turned against each other by a, the tip at a L / 2 from the root's tangent: sigma = -E y a / L."""
    stresses = bar.stresses()
    q_f = coordinates(bar, 5) + L / 2 * coordinates(bar, 1)
    (tensor,) = stresses.of(q_f)
    expected = -MATERIAL.E * stresses.points[:, 1] * 1e-3 / L
    assert_allclose(tensor[0, 0], expected, atol=1e-6 * np.abs(expected).max())


def test_a_frame_has_no_stresses_at_points() -> None:
    places = np.linspace(0.0, 1.0, 11)[:, None] * np.array([1.0, 0.0, 0.0])
    mesh = LineMesh(places, [(k, k + 1) for k in range(10)], Section.rectangle(0.02, 0.01))
    body = FlexibleBody.from_mesh(mesh, MATERIAL, interface={"root": [0]}, modes=1)
    with pytest.raises(FiniteElementError, match="stresses.*not made from a solid mesh"):
        body.stresses()


def test_stresses_at_the_surface(bar: FlexibleBody) -> None:
    """A linear field is met on the surface too, where no point of the quadrature is: pure bending, at its corners."""
    q_f = coordinates(bar, 5) + L / 2 * coordinates(bar, 1)
    surface = bar.surface()
    found = surface["stresses"] @ q_f  # xx yy zz yz xz xy
    expected = -MATERIAL.E * surface["vertices"][:, 1].astype(float) * 1e-3 / L
    assert np.abs(expected).min() > 0.99 * MATERIAL.E * A / 2 * 1e-3 / L  # corners only
    assert_allclose(found[:, 0], expected, rtol=1e-4)
    assert np.abs(found[:, 1:]).max() < 1e-4 * np.abs(expected).max()
