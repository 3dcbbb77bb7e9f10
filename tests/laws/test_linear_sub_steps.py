"""Rational sub-steps of a linear system: against the matrix exponential, at any stiffness, and the phi functions."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
import scipy.linalg

from runtime.schemes.linear_propagation import LinearSystem, factors_of, propagate
from runtime.schemes.partial_fractions import poles
from tests.support.model_values import Array


class SubStep:
    """One sub-step of n coordinates as a function of numbers; h is an argument."""

    def __init__(self, n: int) -> None:
        M, J_q, J_v = (ca.SX.sym(name, n, n) for name in ("M", "J_q", "J_v"))
        w, u, G = ca.SX.sym("w", n), ca.SX.sym("u", n), [ca.SX.sym(f"G{k}", n) for k in range(3)]
        tau, h = ca.SX.sym("tau"), ca.SX.sym("h")
        system = LinearSystem(M, J_q, J_v)
        after = propagate(system, factors_of(system, h), w, u, (G[0], G[1], G[2]), tau, h)
        self._function = ca.Function("sub_step", [M, J_q, J_v, w, u, *G, tau, h], list(after))

    def __call__(self, matrices: tuple[Array, Array, Array], y: Array, G: Array, tau: float, h: float) -> Array:
        w, u = np.split(y, 2)
        return np.concatenate([np.asarray(part).ravel() for part in self._function(*matrices, w, u, *G, tau, h)])


def random_system(seed: int, n: int) -> tuple[tuple[Array, Array, Array], Array, Array]:
    """M positive definite, J_q and J_v not symmetric; y and G."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(n, n))
    M = root @ root.T + n * np.eye(n)
    K, D = rng.normal(size=(2, n, n))
    J_q = -(K @ K.T * 30 + rng.normal(size=(n, n)))
    J_v = -(D @ D.T + rng.normal(size=(n, n)))
    return (M, J_q, J_v), rng.normal(size=2 * n), rng.normal(size=(3, n)) * 5


def exact(matrices: tuple[Array, Array, Array], y: Array, G: Array, tau: float, h: float) -> Array:
    """By the exponential of the system with the force, its slope and its bend as further states."""
    M, J_q, J_v = matrices
    n = len(M)
    A = np.zeros((2 * n + 3, 2 * n + 3))
    A[:n, n : 2 * n] = np.eye(n)
    A[n : 2 * n, :n], A[n : 2 * n, n : 2 * n] = np.linalg.solve(M, J_q), np.linalg.solve(M, J_v)
    A[n : 2 * n, 2 * n :] = np.linalg.solve(M, G.T)  # G0 + G1 s1 + G2 s2, s1 = tau, s2 = tau^2 / 2
    A[2 * n + 1, 2 * n], A[2 * n + 2, 2 * n + 1] = 1.0, 1.0
    return np.asarray(scipy.linalg.expm(A * h) @ np.concatenate([y, [1.0, tau, tau**2 / 2]]))[: 2 * n]


@pytest.mark.parametrize("n", [1, 2, 4])
def test_sub_steps_are_of_sixth_order(n: int) -> None:
    """Law: the error of a unit of time falls with h^6, with springs, dampers, and a force of second degree in time."""
    step = SubStep(n)
    for seed in range(5):
        matrices, y, G = random_system(seed, n)
        wanted = exact(matrices, y, G, 0.3, 1.0)
        steps, errors = [1 / 8, 1 / 16, 1 / 32], []
        for h in steps:
            now = y
            for k in range(round(1 / h)):
                now = step(matrices, now, G, 0.3 + k * h, h)
            errors.append(np.max(np.abs(now - wanted)) / np.max(np.abs(wanted)))
        assert errors[-1] < 2e-7, (seed, errors)
        assert np.log2(errors[0] / errors[1]) == pytest.approx(6.0, abs=0.15), (seed, errors)


@pytest.mark.parametrize("reach", [1e-3, 0.1, 1.0, 2.0, 10.0, 1e3, 1e6])
def test_undamped_modes_keep_their_energy_at_any_stiffness(reach: float) -> None:
    """Law: |R(i w h)| = 1, a hundred steps of a coupled pair with modes w h = reach and reach / 7 keep its energy."""
    rng = np.random.default_rng(3)
    root = rng.normal(size=(2, 2))
    M = root @ root.T + np.eye(2)
    factor = np.linalg.cholesky(M)
    turn = scipy.linalg.expm(np.array([[0, 0.7], [-0.7, 0]]))
    K = factor @ turn @ np.diag([reach**2, (reach / 7) ** 2]) @ turn.T @ factor.T
    step, y = SubStep(2), np.concatenate([rng.normal(size=2) / reach, rng.normal(size=2)])

    def energy(y: Array) -> float:
        return float(y[:2] @ K @ y[:2] + y[2:] @ M @ y[2:]) / 2

    start = energy(y)
    for _ in range(100):
        y = step((M, -K, np.zeros((2, 2))), y, np.zeros((3, 2)), 0.0, 1.0)
    assert energy(y) == pytest.approx(start, rel=1e-11)


@pytest.mark.parametrize("damping", [1.0, 30.0, 1e3, 1e6, 1e9])
def test_stiff_dampers_are_bounded(damping: float) -> None:
    """Law: no multiplier is above 1 however strong the damper; the fast decay's tends to -1, the slow one's to 1."""
    step, one = SubStep(1), np.eye(1)
    columns = [step((one, -4.0 * one, -damping * one), y, np.zeros((3, 1)), 0.0, 1.0) for y in np.eye(2)]
    values = np.linalg.eigvals(np.array(columns).T)
    assert np.max(np.abs(values)) < 1.0
    if damping >= 1e3:
        slow = values[np.argmax(values.real)].real
        assert slow == pytest.approx(math.exp(-4.0 / damping), rel=1e-4)
        assert -1.0 < values.min().real < -1.0 + 25 / damping


@pytest.mark.parametrize("degree", [1, 3, 5])
def test_partial_fractions_are_the_phi_functions(degree: int) -> None:
    """Law: sum_j weights[k - 1] / (r_j - z) has the Taylor coefficients of phi_k below z^(2 degree + 1 - k) only."""
    fractions = poles(degree)
    assert sum(pole.share for pole in fractions) == degree
    for k in (1, 2, 3):
        order = 2 * degree + 1 - k
        for j in range(order + 1):
            found = sum((pole.share * pole.weights[k - 1] / pole.r ** (j + 1)).real for pole in fractions)
            ratio = found * math.factorial(j + k)
            assert abs(ratio - 1) < 1e-9 if j < order else abs(ratio - 1) > 1e-3, (k, j, ratio)


def test_the_denominator_is_that_of_the_diagonal_pade_approximation() -> None:
    """Law: 1 + z phi_1 is the Pade approximation (3, 3) of exp, with poles where 120 - 60 z + 12 z^2 = z^3."""
    for pole in poles():
        assert abs(120 - 60 * pole.r + 12 * pole.r**2 - pole.r**3) < 1e-11
    for z in (-3.0, 0.5, 2.0):
        value = 1 + z * sum((pole.share * pole.weights[0] / (pole.r - z)).real for pole in poles())
        even, odd = 120 + 12 * z**2, 60 * z + z**3
        assert value == pytest.approx((even + odd) / (even - odd), rel=1e-13)
