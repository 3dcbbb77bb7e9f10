"""Modal data of the uniform beam against analytic shapes, integrals and frequencies."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest
from scipy.integrate import quad_vec
from scipy.linalg import eigh

from symgen.modes import AXIAL_ENDS, LATERAL_ENDS, axial_modes, clean, lateral_modes
from symgen.modes.cleaning import Array
from symgen.modes.mesh import beam_stiffness, lumped_masses
from tests.support.planar_beams import planar_beam

# First three roots of the frequency equations, e.g. cos(b) cosh(b) = -1 for clamped-free.
WAVE_NUMBERS = {
    "pinned-pinned": np.pi * np.arange(1, 4),
    "clamped-free": np.array([1.875104068711961, 4.694091132974175, 7.854757438237613]),
    "clamped-pinned": np.array([3.926602312047919, 7.068582745628732, 10.210176122813031]),
    "clamped-clamped": np.array([4.730040744862704, 7.853204624095838, 10.995607838001671]),
    "free-free": np.array([4.730040744862704, 7.853204624095838, 10.995607838001671]),
}
LATERAL_CASES = [(ends, n, modes) for ends in LATERAL_ENDS for n, modes in ((7, 3), (20, 8))]


@pytest.mark.parametrize("ends", LATERAL_ENDS)
def test_lateral_frequencies_converge_with_second_order(ends: str) -> None:
    exact = WAVE_NUMBERS[ends] ** 2
    errors = [np.abs(lateral_modes(n, ends, 3).frequencies / exact - 1.0) for n in (40, 80)]
    assert np.all(errors[1] < 3e-3)
    assert np.all(np.log2(errors[0] / errors[1]) > 1.9)


@pytest.mark.parametrize("ends", AXIAL_ENDS)
def test_axial_frequencies_converge_with_second_order(ends: str) -> None:
    exact = np.pi * (np.arange(1, 4) - 0.5 * (ends == "fixed-free"))
    errors = [np.abs(axial_modes(n, ends, 3).frequencies / exact - 1.0) for n in (40, 80)]
    assert np.all(errors[1] < 1e-3)
    assert np.allclose(np.log2(errors[0] / errors[1]), 2.0, atol=0.02)
    closed_form = 80 * np.sin(exact / 80)  # of the lumped bar with 40 elements
    assert np.allclose(axial_modes(40, ends, 3).frequencies, closed_form, rtol=1e-12)


@pytest.mark.parametrize("elements", [20, 200])
def test_pinned_pinned_shapes_are_sines_at_the_nodes(elements: int) -> None:
    modes = lateral_modes(elements, "pinned-pinned", 8)
    exact = np.sin(np.pi * np.outer(modes.xi, np.arange(1, 9)))
    exact /= np.max(np.abs(exact), axis=0)
    assert np.max(np.abs(modes.phi - exact)) < 1e-10


def test_axial_shapes_are_sines_and_cosines_at_the_nodes() -> None:
    fixed, free = axial_modes(24, "fixed-free", 4), axial_modes(24, "free-free", 4)
    angles = np.pi * np.outer(fixed.xi, np.arange(1, 5))
    assert np.allclose(fixed.u, np.sin(angles - np.pi / 2 * fixed.xi[:, None]), atol=1e-12)
    assert np.allclose(free.u, np.cos(angles), atol=1e-12)
    stretched = 24 * np.diff(free.u, axis=0)
    assert np.allclose(stretched.T @ stretched / 24, free.kappa, atol=1e-11)


@pytest.mark.parametrize(("ends", "elements", "count"), LATERAL_CASES)
def test_modes_satisfy_the_assembled_finite_element_equations(ends: str, elements: int, count: int) -> None:
    """K (w, w') = lambda (M w, 0) in every free row of the uncondensed problem, rotations included."""
    modes = lateral_modes(elements, ends, count)
    start, end = ends.split("-")
    stiffness = beam_stiffness(elements)
    nodal = np.stack([modes.phi, modes.slope], axis=1).reshape(-1, count)
    inertia = np.zeros_like(nodal)
    inertia[0::2] = modes.mu[:, None] * modes.phi * modes.frequencies**2
    held = [0] * (start != "free") + [1] * (start == "clamped")
    held += [2 * elements] * (end != "free") + [2 * elements + 1] * (end == "clamped")
    residual = np.delete(stiffness @ nodal - inertia, held, axis=0)
    assert np.max(np.abs(residual)) < 1e-11 * np.max(np.abs(stiffness))
    assert not np.any(nodal[held])
    assert np.allclose(nodal.T @ stiffness @ nodal, modes.kappa, rtol=1e-9, atol=1e-9 * np.max(modes.kappa))
    assert np.allclose(modes.phi.T @ (modes.mu[:, None] * modes.phi), modes.mass, atol=1e-13)


@pytest.mark.parametrize("ends", LATERAL_ENDS)
def test_orthogonality_normalisation_and_sign(ends: str) -> None:
    modes = lateral_modes(30, ends, 6)
    for matrix in (modes.kappa, modes.mass):
        assert np.array_equal(matrix, np.diag(np.diag(matrix))) and np.all(np.diag(matrix) > 0)
    assert np.all(np.diff(modes.frequencies) > 0)
    assert np.allclose(modes.frequencies**2, np.diag(modes.kappa) / np.diag(modes.mass), rtol=1e-14)
    assert np.array_equal(np.max(np.abs(modes.phi), axis=0), np.ones(6))
    assert all(column[np.abs(column) > 1e-6][0] > 0 for column in modes.phi.T)
    assert np.array_equal(modes.eta, modes.eta.swapaxes(1, 2))


@pytest.mark.parametrize("ends", ["pinned-pinned", "clamped-clamped", "free-free"])
@pytest.mark.parametrize("elements", [21, 30])
def test_symmetric_supports_give_exact_parity_and_zeros(ends: str, elements: int) -> None:
    modes = lateral_modes(elements, ends, 6)
    parity = np.array([1.0, -1.0] * 3)
    assert np.array_equal(modes.phi[::-1], parity * modes.phi)
    assert np.array_equal(modes.slope[::-1], -parity * modes.slope)
    integrals = planar_beam(modes, None)
    assert not np.any(integrals.phi_y[1::2])
    assert not np.any(modes.eta[-1][np.add.outer(np.arange(6), np.arange(6)) % 2 == 1])
    if ends == "free-free":
        assert not np.any(integrals.phi_y) and not np.any(integrals.xi_phi_y)
    if ends == "pinned-pinned":
        assert np.array_equal(modes.eta[-1], np.diag(np.diag(modes.eta[-1])))


def _cantilever(x: float) -> tuple[Array, Array]:
    """First two analytic clamped-free shapes (magnitude 1 at the tip, positive at the clamp) and slopes."""
    b = WAVE_NUMBERS["clamped-free"][:2]
    z = b * x
    ratio = (np.cosh(b) + np.cos(b)) / (np.sinh(b) + np.sin(b))
    tip = np.abs(np.cosh(b) - np.cos(b) - ratio * (np.sinh(b) - np.sin(b)))
    shape = np.cosh(z) - np.cos(z) - ratio * (np.sinh(z) - np.sin(z))
    return shape / tip, b * (np.sinh(z) + np.sin(z) - ratio * (np.cosh(z) - np.cos(z))) / tip


def _slope_integral(weight: Callable[[float], float], end: float = 1.0) -> Array:
    """Integral of weight(x) w'^T w' from 0 to `end` over the analytic cantilever slopes."""
    return quad_vec(lambda x: weight(x) * np.outer(_cantilever(x)[1], _cantilever(x)[1]), 0.0, end)[0]


def _converged(meshes: Sequence[object], name: str) -> Array:
    """Richardson extrapolation of a second-order quantity from a mesh and one twice as fine."""
    coarse, fine = (np.asarray(getattr(mesh, name)) for mesh in meshes)
    return (4.0 * fine - coarse) / 3.0


def test_clamped_free_data_match_analytic_integrals() -> None:
    at = 0.62
    meshes = [planar_beam(lateral_modes(n, "clamped-free", 2), None) for n in (80, 160)]
    points = [mesh.point(at) for mesh in meshes]
    expected = {
        "phi_y": quad_vec(lambda x: _cantilever(x)[0], 0.0, 1.0)[0],
        "xi_phi_y": quad_vec(lambda x: x * _cantilever(x)[0], 0.0, 1.0)[0],
        "mass": 0.25 * np.eye(2),
        "kappa_lateral": np.diag(0.25 * WAVE_NUMBERS["clamped-free"][:2] ** 4),
        # By exchange of the integrals over x and over eta.
        "H": _slope_integral(lambda x: 1.0 - x),
        "xH": _slope_integral(lambda x: 0.5 * (1.0 - x * x)),
    }
    for name, value in expected.items():
        assert np.allclose(_converged(meshes, name), value, rtol=1e-5, atol=1e-9), name
    assert np.allclose(_converged(points, "H"), _slope_integral(lambda x: 1.0, at), rtol=1e-5)
    assert np.allclose(_converged(points, "shape_y"), _cantilever(at)[0], rtol=1e-5)
    assert np.allclose(_converged(points, "slope"), _cantilever(at)[1], rtol=1e-5)


def test_spinning_cantilever_follows_the_geometric_stiffness_law() -> None:
    """K + w^2 (G - M) in the plane of rotation, K + w^2 G out of it (flap); Southwell's G / M is 1.193.

    Published first flap frequencies of the rotating uniform cantilever, hub radius 0, at w = 1, 5, 10 in
    units of sqrt(EI / (rho A L^4)): Wright, Smith, Thresher and Wang, J. Appl. Mech. 49, 1982.
    """
    integrals = planar_beam(lateral_modes(150, "clamped-free", 6), None)
    stiffness, mass, geometric = integrals.kappa_lateral, integrals.mass, integrals.xH
    assert geometric[0, 0] / mass[0, 0] == pytest.approx(1.193, abs=1e-3)
    for speed, published in ((1.0, 3.6816), (5.0, 6.4495), (10.0, 11.2023)):
        in_plane = eigh(stiffness + speed**2 * (geometric - mass), mass, eigvals_only=True)[0]
        assert in_plane > stiffness[0, 0] / mass[0, 0]  # spinning stiffens, in the plane too
        assert math.sqrt(in_plane + speed**2) == pytest.approx(published, rel=5e-4)


def test_integrals_are_the_sums_over_the_nodes() -> None:
    lateral, axial = lateral_modes(16, "clamped-pinned", 3), axial_modes(16, "fixed-free", 2)
    integrals = planar_beam(lateral, axial)
    x, y = np.zeros((2, 17, 5))
    y[:, :3], x[:, 3:] = lateral.phi, axial.u
    mu, xi = lateral.mu, lateral.xi
    assert integrals.nf == 5
    assert pytest.approx(mu @ xi) == 0.5
    assert integrals.i0 == pytest.approx(1 / 3 + 1 / (6 * 16**2))
    expected = {"phi_x": mu @ x, "phi_y": mu @ y, "xi_phi_x": (mu * xi) @ x, "xi_phi_y": (mu * xi) @ y}
    expected["mass"] = x.T @ (mu[:, None] * x) + y.T @ (mu[:, None] * y)
    expected["phi_cross_phi"] = x.T @ (mu[:, None] * y) - y.T @ (mu[:, None] * x)
    expected["H"], expected["xH"] = np.zeros((2, 5, 5))
    expected["H"][:3, :3] = np.tensordot(mu, lateral.eta, 1)
    expected["xH"][:3, :3] = np.tensordot(mu * xi, lateral.eta, 1)
    for name, value in expected.items():
        assert np.allclose(getattr(integrals, name), value, atol=1e-13), name
    assert np.array_equal(integrals.kappa_axial, axial.kappa)


def test_points_on_nodes_and_between() -> None:
    lateral, axial = lateral_modes(10, "clamped-free", 3), axial_modes(10, "fixed-free", 1)
    integrals = planar_beam(lateral, axial)
    for k in range(11):
        point = integrals.point(k * 0.1)  # 3 * 0.1 is not 0.3: the node is still meant
        assert np.array_equal(point.shape_y, [*lateral.phi[k], 0.0])
        assert np.array_equal(point.shape_x, [0.0, 0.0, 0.0, *axial.u[k]])
        assert np.array_equal(point.slope, [*lateral.slope[k], 0.0])
        assert np.array_equal(point.H[:3, :3], lateral.eta[k])
    at, step = 0.347, 1e-6
    before, middle, after = (lateral.interpolate(at + shift) for shift in (-step, 0.0, step))
    assert np.allclose((after.phi - before.phi) / (2 * step), middle.slope, rtol=1e-8)
    assert np.allclose((after.eta - before.eta) / (2 * step), np.outer(middle.slope, middle.slope), rtol=1e-6)
    assert np.allclose(axial.interpolate(at), 0.53 * axial.u[3] + 0.47 * axial.u[4])


def test_same_request_gives_same_numbers_and_arrays_are_read_only() -> None:
    ends = "free-free"
    first, second = (planar_beam(lateral_modes(25, ends, 5), axial_modes(25, ends, 3)) for _ in range(2))
    for name in ("phi_x", "xi_phi_x", "mass", "phi_cross_phi", "kappa_lateral", "H", "xH"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes()
    with pytest.raises(ValueError, match="read-only"):
        first.H[0, 0] = 1.0


def test_smallest_meshes() -> None:
    for elements in (1, 2, 3, 49, 107, 500):
        assert math.fsum(lumped_masses(elements)) == 1.0
    # Half of the mass on springs of 48 EI / L^3 and 3 EI / L^3.
    assert lateral_modes(2, "pinned-pinned", 1).frequencies[0] == pytest.approx(math.sqrt(96.0))
    assert lateral_modes(1, "clamped-free", 1).frequencies[0] == pytest.approx(math.sqrt(6.0))
    assert axial_modes(1, "free-free", 1).frequencies[0] == pytest.approx(2.0)


def test_clean_drops_round_off_only() -> None:
    assert np.array_equal(clean(np.array([1.0, 1e-13, -2e-11])), [1.0, 0.0, -2e-11])
    assert not np.any(clean(np.array([1e-16, -3e-17]), 1.0))


BAD_REQUESTS: list[tuple[Callable[[], object], str]] = [
    (lambda: lateral_modes(10, "hinged", 1), "unknown ends 'hinged'.*use one of pinned-pinned"),
    (lambda: lateral_modes(5, "pinned-pinned", 6), "at least 7 elements"),
    (lambda: axial_modes(3, "free-free", 4), "at least 4 elements"),
    (lambda: axial_modes(3, "free-free", 0), "ask for at least 1"),
    (lambda: axial_modes(0, "free-free", 1), "give at least 1"),
    (lambda: planar_beam(lateral_modes(4, "free-free", 1), None).point(1.2), r"in \[0, 1\]"),
    (lambda: planar_beam(lateral_modes(4, "free-free", 1), None).point(math.nan), r"in \[0, 1\]"),
]


@pytest.mark.parametrize(("attempt", "message"), BAD_REQUESTS)
def test_bad_requests_say_what_to_do(attempt: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        attempt()
