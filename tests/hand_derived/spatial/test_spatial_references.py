"""Reference runs of the IFToMM cases A02, A04 and of the fast heavy top, against published and computed numbers."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.hand_derived.spatial import twin_bricard, twin_fast_top
from tests.hand_derived.spatial import twin_n_four_bar as four_bar
from tests.hand_derived.twin_common import STEP, Array, complex_step

P3_HALF = [0.9682836791067775, -1.2246251594363333, 0.7501466094377676]
P3_ONE = [0.5105014611872206, -1.649167599394806, 0.1401231145532866]


def bricard_rate(t: float, y: Array) -> Array:
    return np.concatenate([y[5:], twin_bricard.acceleration(y[:5], y[5:])])


def test_bricard_at_the_start() -> None:
    points = np.array(twin_bricard.frames(np.zeros(5))[1])
    np.testing.assert_array_equal(points, [[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1]])
    values = np.linalg.svd(twin_bricard.closure_jacobian(np.zeros(5)), compute_uv=False)
    assert values[4] < 1e-14 and values[3] > 0.1  # one constraint too many, one degree of freedom


@pytest.mark.long
def test_bricard_published_values() -> None:
    solution = solve_ivp(bricard_rate, (0, 1), np.zeros(10), method="DOP853", rtol=1e-11, atol=1e-12, t_eval=[0.5, 1.0])
    for y, expected in zip(solution.y.T, (P3_HALF, P3_ONE), strict=True):
        q = twin_bricard.project(y[:5])
        np.testing.assert_allclose(q, y[:5], atol=1e-9)  # integrated closure has not drifted
        np.testing.assert_allclose(twin_bricard.frames(q)[1][3], expected, rtol=0, atol=2e-9)
        start = twin_bricard.energy(np.zeros(5), np.zeros(5))[1]
        assert abs(sum(twin_bricard.energy(y[:5], y[5:])) - start) < 1e-9


def closed_state(path: float, speed: float) -> tuple[Array, Array]:
    """A closed position some way along the mechanism's path, and a rate along it."""
    q = np.zeros(5)
    direction = twin_bricard.tangent(q)
    for _ in range(20):
        previous, direction = direction, twin_bricard.tangent(q)
        direction = direction * np.sign(direction @ previous)
        q = twin_bricard.project(q + path / 20 * direction)
    return q, speed * twin_bricard.tangent(q)


def test_bricard_closure_and_its_rates() -> None:
    """C_q by complex step; C'' = 0 along the accelerations; energy of the poses kept."""
    q, v = closed_state(0.8, 2.5)
    np.testing.assert_allclose(twin_bricard.closure(q), 0, atol=1e-13)
    C_q = twin_bricard.closure_jacobian(q)
    np.testing.assert_allclose(C_q, complex_step(twin_bricard.closure, q), atol=1e-13)
    a = twin_bricard.acceleration(q, v)
    ahead = complex_step(lambda s: twin_bricard.closure_jacobian(q + s[0] * v) @ (v + s[0] * a), np.zeros(1))
    np.testing.assert_allclose(ahead, 0, atol=1e-11)
    kinetic, potential = twin_bricard.energy(q + 1j * STEP * v, v + 1j * STEP * a)
    assert abs(np.imag(kinetic + potential)) / STEP < 1e-11 * abs(np.imag(potential)) / STEP


@pytest.mark.every_push("0")
@pytest.mark.parametrize("k", range(5))
def test_bricard_condensed_form(k: int) -> None:
    """M_hat q_k'' = Q_hat for any hinge as the independent one; M_hat is the kinetic energy of the poses."""
    q, v = closed_state(0.8, 2.5)
    M_hat, Q_hat = twin_bricard.condensed(q, v, k)
    assert abs(M_hat * twin_bricard.acceleration(q, v)[k] - Q_hat) < 1e-10 * abs(Q_hat)
    kinetic = 0.0
    for body, moved in zip(twin_bricard.poses(q), twin_bricard.poses(q + 1j * STEP * v), strict=True):
        velocity, A_dot = np.imag(moved.R_c) / STEP, np.imag(moved.A) / STEP
        spin = body.A.T @ A_dot
        omega = np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        kinetic += 0.5 * body.mass * velocity @ velocity + 0.5 * omega @ body.inertia @ omega
    assert abs(0.5 * M_hat * v[k] ** 2 - kinetic) < 1e-12 * kinetic


@pytest.mark.long
def test_fast_top_computed_values() -> None:
    solution = solve_ivp(
        twin_fast_top.rate, (0, 1), twin_fast_top.START, method="DOP853", rtol=1e-12, atol=1e-13, t_eval=[0.2, 1.0]
    )
    np.testing.assert_allclose(
        twin_fast_top.centre(solution.y[:, 0]), [0.60555056138, 0.59895768179, -0.52398302743], rtol=0, atol=1e-9
    )
    np.testing.assert_allclose(
        twin_fast_top.centre(solution.y[:, 1]), [0.17334396410, 0.64008859207, -0.74849079113], rtol=0, atol=1e-9
    )
    np.testing.assert_allclose(solution.y[5], 150.0, rtol=1e-14)
    assert abs(twin_fast_top.energy(twin_fast_top.START) - 5435.6967908655) < 1e-9
    assert abs(twin_fast_top.energy(solution.y[:, 1]) - 5435.6967908655) < 1e-7


def test_n_four_bar_exact_values() -> None:
    assert abs(four_bar.time_at(2, np.pi / 2) - 0.714355529293) < 1e-12
    assert abs(four_bar.time_at(2, 2 * np.pi) - 1.94251492261) < 1e-11
    for t, place in (
        (1, [-0.19502030194944, -0.98079920566217]),
        (2, [0.057815795768011, 0.99832726786346]),
        (10, [0.32845811154082, 0.9445185381786]),
    ):
        np.testing.assert_allclose(four_bar.B0(2, t), place, rtol=0, atol=1e-12)
    assert len(four_bar.singular_times(2, 10.0)) == 10


@pytest.mark.parametrize("N", [1, 2, 5, 40])
def test_n_four_bar_meets_its_equation(N: int) -> None:
    """phi'' = m_g/I sin phi integrated, against the quadrature; energy of the bars themselves."""
    pull = 9.81 * ((N + 1) * 0.5 + N) / ((N + 1) / 3 + N)
    solution = solve_ivp(
        lambda t, y: [y[1], pull * np.sin(y[0])], (0, 3.3), [0.0, 1.0], method="DOP853", rtol=1e-12, atol=1e-13
    )
    phi, rate = solution.y[:, -1]
    assert abs(four_bar.angle_at(N, 3.3) - phi) < 1e-9
    np.testing.assert_allclose(four_bar.B0_dot(N, 3.3), [rate * np.cos(phi), -rate * np.sin(phi)], atol=1e-8)
    crank = 0.5 * (0.25 + 1 / 12) * rate**2 + 9.81 * np.cos(phi) / 2
    coupler = 0.5 * rate**2 + 9.81 * np.cos(phi)
    assert abs((N + 1) * crank + N * coupler - four_bar.energy(N)) < 1e-8 * four_bar.energy(N)
