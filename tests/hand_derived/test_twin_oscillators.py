"""The exact amplification matrices of case L1 against the growth law, and against each other."""

from __future__ import annotations

import numpy as np
import pytest

from tests.hand_derived.twin_oscillators import (
    Params,
    central_difference_matrix,
    growth_rate,
    growth_rate_law,
    printed_subcycling_matrix,
    stabilising_damping_law,
)


@pytest.mark.parametrize("m", [2, 3, 5, 10])
@pytest.mark.parametrize("c", [0.2, 0.5, 0.8])
def test_growth_law(c: float, m: int) -> None:
    w, dt_L = 3.0, 0.01
    matrix = printed_subcycling_matrix(Params(c=c, w=w), dt_L / m, m)
    assert growth_rate(matrix, dt_L) == pytest.approx(growth_rate_law(c, w, m, dt_L), rel=0.05)


def test_one_sub_step_is_single_rate() -> None:
    params = Params(c=0.6, w=2.0, k_L=0.7, zeta=0.03)
    single = central_difference_matrix(params, 0.05)
    np.testing.assert_allclose(printed_subcycling_matrix(params, 0.05, 1), single, atol=1e-14)


def test_single_rate_is_neutral_below_its_limit_and_unstable_above() -> None:
    params = Params(c=0.6, w=1.0, k_L=0.3)
    M, K = np.array([[1, 0.6], [0.6, 1]]), np.diag([0.3, 1.0])
    limit = 2 / np.sqrt(np.max(np.linalg.eigvals(np.linalg.solve(M, K)).real))
    assert abs(growth_rate(central_difference_matrix(params, 0.99 * limit), 1.0)) < 1e-9
    assert growth_rate(central_difference_matrix(params, 1.01 * limit), 1.0) > 1e-2


@pytest.mark.parametrize("factor, stable", [(0.9, False), (1.1, True)])
def test_damping_law(factor: float, stable: bool) -> None:
    """The rigid pair of unit eigenvalues (k_L = 0) is set aside: the oscillating pair decides."""
    c, w, m, dt_L = 0.5, 1.0, 5, 0.02
    params = Params(c=c, w=w, zeta=factor * stabilising_damping_law(c, w, m, dt_L))
    values = np.linalg.eigvals(printed_subcycling_matrix(params, dt_L / m, m))
    oscillating = values[np.abs(np.angle(values)) > 0.5 * w * dt_L]
    assert oscillating.size == 2
    assert (np.max(np.abs(oscillating)) < 1) == stable


def test_single_rate_follows_the_exact_solution_to_second_order() -> None:
    """Damped, coupled: the error at t = 2 falls by 4 when the step halves."""
    params = Params(c=0.4, w=2.0, k_L=0.5, zeta=0.1)
    M, K, D = np.array([[1, 0.4], [0.4, 1]]), np.diag([0.5, 4.0]), np.diag([0, 0.4])
    generator = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    values, vectors = np.linalg.eig(generator)
    weights = np.linalg.solve(vectors, np.array([1.0, 0.5, 0.0, 0.0]))

    def exact(t: float) -> np.ndarray:
        return (vectors @ (weights * np.exp(values * t))).real[:2]

    errors = []
    for steps in (100, 200):
        dt = 2.0 / steps
        before, now = exact(-dt), exact(0.0)
        state = np.array([before[0], now[0], before[1], now[1]])
        state = np.linalg.matrix_power(central_difference_matrix(params, dt), steps) @ state
        errors.append(np.max(np.abs(state[[1, 3]] - exact(2.0))))
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] < 1e-3
