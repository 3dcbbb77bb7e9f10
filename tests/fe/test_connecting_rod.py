"""The connecting rod of the examples: thousands of degrees of freedom, and numbers that repeat."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from symgen.fe import STEEL, FlexibleBody
from symgen.fe.connecting_rod import BIG_EYE, LENGTH, THICKNESS, connecting_rod, connecting_rod_mesh

pytestmark = pytest.mark.long


@pytest.fixture(scope="module")
def rod() -> FlexibleBody:
    return connecting_rod()


def test_the_rod_has_thousands_of_degrees_of_freedom_and_few_modes(rod: FlexibleBody) -> None:
    assert rod.structure.n_dof == 5205
    assert rod.nf == 6
    assert list(rod.markers) == ["big_end", "small_end"]
    assert rod.markers["big_end"].position.tolist() == [0.0, 0.0, 0.0]
    assert rod.markers["small_end"].position.tolist() == [LENGTH, 0.0, 0.0]


def test_the_mesh_is_whole(rod: FlexibleBody) -> None:
    """No cell is inside out, the volume is that of its outline, and one closed surface bounds it."""
    mesh = connecting_rod_mesh()
    corners = mesh.p[:, mesh.t]
    sides = corners[:, [6, 5, 4]] - corners[:, [7]]  # from the corner (0, 0, 0) to (0, 0, 1), (0, 1, 0), (1, 0, 0)
    assert np.all(np.linalg.det(sides[:, [2, 1, 0]].transpose(2, 0, 1)) > 0.0)
    assert_allclose(rod.integrals.mass, STEEL.rho * THICKNESS * area(mesh), rtol=1e-10)
    bored = np.hypot(*mesh.p[:2]) < 1.001 * BIG_EYE[0]
    assert bored.sum() == 16 * 3


def area(mesh: object) -> float:
    """Of the middle layer's quadrilaterals, by the shoelace formula."""
    p, t = mesh.p, mesh.t  # type: ignore[attr-defined]
    low = t[[7, 4, 1, 5]][:, p[2, t[7]] < -0.4 * THICKNESS]  # corners a, b, c, d of the lower layer
    x, y = p[0, low], p[1, low]
    return float(np.sum(0.5 * np.abs(np.sum(x * np.roll(y, -1, axis=0) - y * np.roll(x, -1, axis=0), axis=0))))


def test_the_modes_are_well_apart(rod: FlexibleBody) -> None:
    assert 300.0 < rod.frequencies[0] < 400.0
    assert np.all(np.diff(rod.frequencies) > 0.02 * rod.frequencies[:-1])
    assert "nearly the same" not in rod.report()


def test_symmetry_gives_exact_zeros(rod: FlexibleBody) -> None:
    integrals = rod.integrals
    assert np.all(integrals.first_moment[1:] == 0.0) and np.count_nonzero(integrals.moments) == 3
    in_plane = np.any(rod.markers["small_end"].shape[:2] != 0.0, axis=0)
    out_of_plane = np.any(rod.markers["small_end"].rotation[:2] != 0.0, axis=0)
    assert np.all(in_plane != out_of_plane)


def test_the_numbers_do_not_depend_on_the_start_of_the_iteration(
    rod: FlexibleBody, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another start vector rounds differently everywhere, as another machine does."""
    monkeypatch.setattr("symgen.fe.static.SEED", 1)
    other, first = connecting_rod().fields(0.01), rod.fields(0.01)
    for key in ("K_ff", "D_ff", "rho_phi", "phi_phi"):
        one, two = np.array(first[key]), np.array(other[key])
        assert np.array_equal(one == 0.0, two == 0.0), key
        assert_allclose(two, one, atol=1e-9 * np.abs(one).max(), rtol=1e-9, err_msg=key)
    for name, marker in first["markers"].items():
        for key in ("shape", "rotation"):
            one, two = np.array(marker[key]), np.array(other["markers"][name][key])
            assert np.array_equal(one == 0.0, two == 0.0), key
            assert_allclose(two, one, atol=1e-9 * np.abs(one).max())


def test_held_eyes_keep_the_axial_flexibility() -> None:
    """Craig-Bampton modes stretch the rod as far as the full model does, but for the walls of the eyes held round."""
    held = connecting_rod(modes=0, mode_set="fixed_interface")
    assert held.nf == 6
    (loss,) = [one for one in held.losses() if one.name == "small_end, big_end held"]
    assert np.all(loss.loss > 0.0) and np.all(loss.loss < 0.3)
