"""Shapes in closed form: against frequency equations, statics, numerical integration and beams of two pieces."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import quad_vec
from scipy.linalg import block_diag, eigh, null_space
from scipy.optimize import brentq

from runtime.contract.flexible import BENDING, STRETCHING, gauss_points, panels_for
from symgen.modes.beam import exact_bending, exact_stretching
from symgen.modes.cleaning import Array, clean
from tests.support.planar_beams import planar_beam

# First three roots of the frequency equations, e.g. cos(b) cosh(b) = -1 for clamped-free.
WAVE_NUMBERS = {
    "pinned-pinned": np.pi * np.arange(1, 4),
    "clamped-free": np.array([1.875104068711961, 4.694091132974175, 7.854757438237613]),
    "clamped-pinned": np.array([3.926602312047919, 7.068582745628732, 10.210176122813031]),
    "clamped-clamped": np.array([4.730040744862704, 7.853204624095838, 10.995607838001671]),
    "free-free": np.array([4.730040744862704, 7.853204624095838, 10.995607838001671]),
}
HELD = {"welded": (0, 1), "clamped": (0, 1), "pinned": (0,), "free": ()}
HELD_STATIC = {"welded-welded": ((0, 1), ()), "welded-pinned": ((0, 1), ()), "pinned-welded": ((0,), (0,))}
HELD_STATIC["welded-heavy"] = HELD_STATIC["welded-welded"]
NATURAL = {"pinned": (2,), "free": (2, 3)}  # moment, and shear force


@pytest.mark.parametrize("ends", WAVE_NUMBERS)
def test_frequencies_are_the_roots_of_the_frequency_equation(ends: str) -> None:
    np.testing.assert_allclose(exact_bending(ends, 3).frequencies, WAVE_NUMBERS[ends] ** 2, rtol=1e-13)


@pytest.mark.parametrize("ends", STRETCHING)
def test_bar_frequencies(ends: str) -> None:
    """Exact, from above by Ritz where a static shape is among them."""
    shift = 0.0 if ends in ("free-free", "fixed-fixed") else 0.5
    error = exact_stretching(ends, 4).frequencies[:2] / (np.pi * (np.arange(1, 3) - shift)) - 1
    assert np.abs(error).max() < (5e-3 if ends == "fixed-loaded" else 1e-14) and error.min() > -1e-14


@pytest.mark.parametrize("ends", BENDING)
def test_shapes_meet_their_ends_and_are_orthogonal(ends: str) -> None:
    """Held displacements vanish; moments and shears do where nothing is attached; mass and stiffness are diagonal."""
    modes = exact_bending(ends, 7)
    functions = modes.functions
    for at, end in zip((0.0, 1.0), ends.split("-"), strict=True):
        for order in (*(HELD[end] if "welded" not in ends else HELD_STATIC[ends][int(at)]), *NATURAL.get(end, ())):
            assert np.abs(functions.at(np.array([at]), order)).max() < 1e-11 * 25.0**order
    mass, _ = quad_vec(lambda xi: np.outer(*[functions.at(np.array([xi]))[0]] * 2), 0, 1, epsabs=1e-13)
    bending, _ = quad_vec(lambda xi: np.outer(*[functions.at(np.array([xi]), 2)[0]] * 2), 0, 1, epsabs=1e-9)
    np.testing.assert_allclose(mass, modes.mass, atol=1e-11)
    np.testing.assert_allclose(bending, modes.kappa, atol=1e-10 * modes.kappa.max())
    largest = np.abs(functions.at(np.linspace(0, 1, 20001))).max(axis=0)
    np.testing.assert_allclose(largest, 1.0, atol=1e-6)


@pytest.mark.parametrize(("ends", "axial"), [("welded-welded", "fixed-loaded"), ("pinned-free", "free-fixed")])
def test_integrals_are_those_of_the_shapes(ends: str, axial: str) -> None:
    """Each integral of Eq. 20 by adaptive quadrature of the values at points, which `point` gives."""
    integrals = planar_beam(exact_bending(ends, 4, 12), exact_stretching(axial, 3, 12))

    def over_mass(value: Callable[[float], Array]) -> Array:
        return np.asarray(quad_vec(value, 0.0, 1.0, epsabs=1e-11)[0])

    point = integrals.point
    expected = {
        "phi_x": over_mass(lambda xi: point(xi).shape_x),
        "phi_y": over_mass(lambda xi: point(xi).shape_y),
        "xi_phi_x": over_mass(lambda xi: xi * point(xi).shape_x),
        "xi_phi_y": over_mass(lambda xi: xi * point(xi).shape_y),
        "H": over_mass(lambda xi: point(xi).H),
        "xH": over_mass(lambda xi: xi * point(xi).H),
    }
    for name, value in expected.items():
        np.testing.assert_allclose(getattr(integrals, name), value, atol=1e-9, err_msg=name)
    cross = over_mass(lambda xi: np.outer(point(xi).shape_x, point(xi).shape_y))
    np.testing.assert_allclose(integrals.phi_cross_phi, cross - cross.T, atol=1e-10)
    rotation = quad_vec(lambda xi: np.outer(point(xi).slope, point(xi).slope), 0.0, 0.37, epsabs=1e-12)[0]
    np.testing.assert_allclose(point(0.37).H, rotation, atol=1e-9)
    assert integrals.i0 == pytest.approx(1 / 3, rel=1e-15)


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


def test_clamped_free_data_match_analytic_integrals() -> None:
    at, integrals = 0.62, planar_beam(exact_bending("clamped-free", 2), None)
    point = integrals.point(at)
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
        np.testing.assert_allclose(getattr(integrals, name), value, rtol=1e-10, atol=1e-12, err_msg=name)
    np.testing.assert_allclose(point.H, _slope_integral(lambda x: 1.0, at), rtol=1e-10)
    np.testing.assert_allclose(point.shape_y, _cantilever(at)[0], rtol=1e-10)
    np.testing.assert_allclose(point.slope, _cantilever(at)[1], rtol=1e-10)


def test_twisted_fibres_shorten_by_the_square_of_the_twist() -> None:
    """Of a shaft held at its start: int (u')^2 to x by adaptive quadrature, and its integrals over the mass."""
    shaft = exact_stretching("fixed-free", 2)
    b = np.pi * (np.arange(1, 3) - 0.5)

    def bent(x: float) -> Array:
        rate = b * np.cos(b * x)
        return np.outer(rate, rate)

    def shortened(x: float) -> Array:
        return np.asarray(quad_vec(bent, 0.0, x)[0])

    np.testing.assert_allclose(shaft.at(0.3).eta, shortened(0.3), rtol=1e-10)
    np.testing.assert_allclose(shaft.H, quad_vec(shortened, 0.0, 1.0)[0], rtol=1e-9)
    np.testing.assert_allclose(shaft.xH, quad_vec(lambda x: x * shortened(x), 0.0, 1.0)[0], rtol=1e-9)


def test_spinning_cantilever_follows_the_geometric_stiffness_law() -> None:
    """K + w^2 (G - M) in the plane of rotation, K + w^2 G out of it (flap); Southwell's G / M is 1.193.

    Published first flap frequencies of the rotating uniform cantilever, hub radius 0, at w = 1, 5, 10 in
    units of sqrt(EI / (rho A L^4)): Wright, Smith, Thresher and Wang, J. Appl. Mech. 49, 1982.
    """
    integrals = planar_beam(exact_bending("clamped-free", 6), None)
    stiffness, mass, geometric = integrals.kappa_lateral, integrals.mass, integrals.xH
    assert geometric[0, 0] / mass[0, 0] == pytest.approx(1.193, abs=1e-3)
    for speed, published in ((1.0, 3.6816), (5.0, 6.4495), (10.0, 11.2023)):
        in_plane = eigh(stiffness + speed**2 * (geometric - mass), mass, eigvals_only=True)[0]
        assert in_plane > stiffness[0, 0] / mass[0, 0]  # spinning stiffens, in the plane too
        assert math.sqrt(in_plane + speed**2) == pytest.approx(published, rel=5e-4)


def test_arrays_are_read_only() -> None:
    with pytest.raises(ValueError, match="read-only"):
        planar_beam(exact_bending("free-free", 2), None).H[0, 0] = 1.0


def test_clean_drops_round_off_only() -> None:
    assert np.array_equal(clean(np.array([1.0, 1e-13, -2e-11])), [1.0, 0.0, -2e-11])
    assert not np.any(clean(np.array([1e-16, -3e-17]), 1.0))


def test_static_answers_of_loaded_ends_are_exact_with_the_fewest_shapes() -> None:
    """Textbook: F L^3 / 3EI and F L^2 / 2EI, M L^2 / 2EI and M L / EI, M L / 3EI and M L / 6EI; N L / EA."""

    def answer(ends: str, modes: int, at: float, force: float, moment: float) -> tuple[float, float, float]:
        one = exact_bending(ends, modes)
        end, start = one.at(at), one.at(0.0)
        q = np.linalg.solve(one.kappa, force * end.phi + moment * end.slope)
        return float(end.phi @ q), float(end.slope @ q), float(start.slope @ q)

    np.testing.assert_allclose(answer("welded-welded", 2, 1.0, 1.0, 0.0), (1 / 3, 1 / 2, 0.0), rtol=1e-13)
    np.testing.assert_allclose(answer("welded-welded", 2, 1.0, 0.0, 1.0), (1 / 2, 1.0, 0.0), rtol=1e-13)
    np.testing.assert_allclose(answer("welded-pinned", 2, 1.0, 1.0, 0.0), (1 / 3, 1 / 2, 0.0), rtol=1e-13)
    np.testing.assert_allclose(answer("pinned-welded", 2, 1.0, 0.0, 1.0), (0.0, 1 / 3, -1 / 6), rtol=1e-12, atol=1e-15)
    bar = exact_stretching("fixed-loaded", 1)
    assert float(bar.at(1.0).phi @ np.linalg.solve(bar.kappa, bar.at(1.0).phi)) == pytest.approx(1.0)
    assert answer("clamped-free", 2, 1.0, 1.0, 0.0)[0] < 0.999 / 3  # and without end shapes they are not


def test_heavy_ends_are_static_to_a_thousandth() -> None:
    """Tip load and moment, deflection and slope, all within 0.1 %; the shapes are orthogonal with modes beside them."""
    for modes in (2, 4):
        one = exact_bending("welded-heavy", modes)
        end = one.at(1.0)
        B = np.stack([end.phi, end.slope], axis=1)
        found = B.T @ np.linalg.solve(one.kappa, B)
        np.testing.assert_allclose(found, [[1 / 3, 1 / 2], [1 / 2, 1.0]], rtol=1e-3)
        xi, mu = gauss_points(panels_for(modes))
        bend = one.functions.at(xi, 2)
        np.testing.assert_allclose(bend.T @ (mu[:, None] * bend), one.kappa, atol=1e-9 * one.kappa.max())
    assert (np.diag(found) < [1 / 3, 1.0]).all()


@pytest.mark.parametrize("share", [0.1, 0.2, 0.5, 1.0, 5.0])
def test_first_frequency_with_a_tip_mass(share: float) -> None:
    """Exact: 1 + cos b cosh b + mu b (cos b sinh b - sin b cosh b) = 0, to 0.1 % with two shapes.

    Below half of the beam's mass the two cubics, which carry force and moment, leave none for its own inertia.
    """
    root = brentq(
        lambda b: (
            1 + math.cos(b) * math.cosh(b) + share * b * (math.cos(b) * math.sinh(b) - math.sin(b) * math.cosh(b))
        ),
        0.3,
        1.9,
    )
    cubics = 1e-3 if share >= 0.5 else 2.5e-3
    sets = [("welded-pinned", 2, 3e-4), ("welded-welded", 2, cubics), ("welded-welded", 3, 2e-4)]
    for ends, shapes, worst in (*sets, ("welded-heavy", 2, 1e-3), ("welded-heavy", 3, 2e-4)):
        one = exact_bending(ends, shapes)
        tip = one.at(1.0).phi
        w = math.sqrt(eigh(one.kappa, one.mass + share * np.outer(tip, tip), eigvals_only=True)[0])
        assert 0 < w / root**2 - 1 < worst


# errors of first frequency, second frequency and static deflection of the middle, in per cent, by shapes a half
HALVES = {
    ("clamped-free", "clamped-free"): {2: (11.8, 1.3, -22.2), 3: (7.5, 0.53, -15.4), 4: (5.5, 0.20, -11.7)},
    ("welded-welded", "welded-welded"): {2: (0.40, 11.0, 0.0), 3: (0.009, 0.007, 0.0), 4: (0.002, 0.007, 0.0)},
}


@pytest.mark.parametrize("ends", HALVES)
def test_a_pinned_beam_of_two_welded_halves(ends: tuple[str, str]) -> None:
    """The figures are those of an independent computation with exact integrals."""
    for modes, expected in HALVES[ends].items():
        np.testing.assert_allclose(halves_errors(ends, modes), expected, rtol=0.05, atol=1e-3)


def test_halves_with_what_is_attached_to_them_are_better_than_with_cubics_for_all() -> None:
    for modes, cubics in HALVES["welded-welded", "welded-welded"].items():
        found = np.abs(halves_errors(("pinned-welded", "welded-pinned"), modes))
        assert (found[:2] < cubics[:2]).all() and found[2] < 1e-9


def halves_errors(ends: tuple[str, str], modes: int) -> Array:
    """First and second frequency and static deflection of the middle of a pinned beam, relative errors in per cent.

    Coordinates (w, turn) of each half's frame and its shapes; the weld and the pins by the null space of their rows.
    """
    halves, h, none = [exact_bending(one, modes) for one in ends], 0.5, np.zeros(2 + modes)
    masses, loads, points = [], [], []
    for one in halves:
        shapes = np.column_stack([np.ones_like(one.xi), h * one.xi, one.phi])  # w = w_0 + x turn + Phi q_f
        masses.append(h * shapes.T @ (one.mu[:, None] * shapes))
        loads.append(h * shapes.T @ one.mu)
        for at in (0.0, 1.0):
            end = one.at(at)
            points.append((np.r_[1.0, at * h, end.phi], np.r_[0.0, 1.0, end.slope / h]))
    start, joint_a, joint_b, end = points
    weld = [np.r_[a, -b] for a, b in zip(joint_a, joint_b, strict=True)]
    free = null_space(np.array([np.r_[start[0], none], np.r_[none, end[0]], *weld]))
    stiffnesses = [block_diag(np.zeros((2, 2)), one.kappa / h**3) for one in halves]
    K, M = (free.T @ block_diag(*blocks) @ free for blocks in (stiffnesses, masses))
    w = np.sqrt(eigh(K, M, eigvals_only=True)[:2]) / (np.pi * np.arange(1, 3)) ** 2 - 1
    middle = np.r_[joint_a[0], none] @ free @ np.linalg.solve(K, free.T @ np.concatenate(loads))
    return 100 * np.array([*w, middle * 384 / 5 - 1])


@pytest.mark.parametrize(
    ("attempt", "message"),
    [
        (lambda: exact_bending("hinged", 1), "unknown ends 'hinged'.*use one of welded-welded"),
        (lambda: exact_bending("welded-welded", 1), "2 static shapes; ask for at least 2"),
        (lambda: exact_stretching("free-free", 0), "ask for at least 1"),
        (lambda: exact_bending("free-free", 2).at(1.1), r"in \[0, 1\]"),
    ],
)
def test_bad_requests_of_exact_shapes(attempt: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        attempt()
