"""Independent checks of the hand-derived twins.

Lagrange's equation from body-level energies, power balance, constraints, Jacobians, published values of F1,
frequencies of F2.
"""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from tests.hand_derived import (
    twin_double_pendulum,
    twin_driven_slider_crank,
    twin_flexible_slider_crank,
    twin_four_bar,
    twin_hub_beam,
    twin_pendulum,
    twin_slider_crank,
)
from tests.hand_derived import twin_rod_data as rod_data
from tests.hand_derived.twin_common import STEP, Array, complex_step
from tests.hand_derived.twin_hub_beam_data import f2_params
from tests.hand_derived.twin_rod_tree import Params as RodParams

WEIGHT = np.array([0.0, -9.81])
PINNED = RodParams(rod=rod_data.pinned_sine_rod(2, damping_ratio=0.02), gravity=WEIGHT, torque=0.4)
HUB = replace(f2_params(20, 3, damping_ratio=0.01), gravity=np.array([0.7, -9.81]))
STIFF_HUB = replace(f2_params(20, 3, stiffening=True, damping_ratio=0.01), gravity=np.array([0.7, -9.81]))
SMALL = 1e-3  # modal amplitudes of the rod, m
TIP = 3 * [5e-3]  # the same where they move the tip

# (twin, parameters, scale of q_i, scale of q_i')
CASES: dict[str, tuple[ModuleType, Any, Any, Any]] = {
    "pendulum": (twin_pendulum, twin_pendulum.Params(c=0.3), 3.0, 4.0),
    "double_pendulum": (twin_double_pendulum, twin_double_pendulum.Params(c1=0.2, c2=0.1), 3.0, 4.0),
    "four_bar": (twin_four_bar, twin_four_bar.Params(torque=0.3), 3.0, 5.0),
    "slider_crank": (twin_slider_crank, twin_slider_crank.Params(torque=0.2), 3.0, 20.0),
    "flexible_general": (twin_flexible_slider_crank, rod_data.general_params(), [3, *TIP], [20, 1, 1, 1]),
    "flexible_f1": (twin_flexible_slider_crank, rod_data.f1_params(), [3, *4 * [SMALL]], [150, *4 * [1.0]]),
    "flexible_sine": (twin_flexible_slider_crank, PINNED, [3, SMALL, SMALL], [50, 1, 1]),
    "driven_general": (twin_driven_slider_crank, rod_data.general_params(), 5e-3, 1.0),
    "driven_f1": (twin_driven_slider_crank, rod_data.f1_params(), SMALL, 1.0),
    "hub_beam": (twin_hub_beam, HUB, [3, 0.3, 0.3, 0.3], 1.0),
    "hub_beam_stiffening": (twin_hub_beam, STIFF_HUB, [3, 0.3, 0.3, 0.3], 1.0),
}


@pytest.fixture(params=CASES, ids=list(CASES))
def sample(request: pytest.FixtureRequest) -> tuple[ModuleType, Any, Array, Array, float]:
    twin, params, scale, rate_scale = CASES[request.param]
    rng = np.random.default_rng(7)
    n = len(twin.independent(params))
    return twin, params, rng.uniform(-1, 1, n) * scale, rng.uniform(-1, 1, n) * rate_scale, 0.37


def index(twin: ModuleType, params: Any) -> tuple[list[int], list[int]]:
    names, free = twin.coordinates(params), twin.independent(params)
    return [names.index(n) for n in free], [k for k, n in enumerate(names) if n not in free]


def full_rate(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, t: float) -> tuple[Array, Array]:
    """(q, q') from the typed C_q and the numerical C_t: a path that shares nothing with M_hat."""
    i, d = index(twin, params)
    q = twin.q_full(params, q_i, t)
    C_q = twin.C_q(params, q, t)
    # central difference in t; the only rheonomic constraint is linear in t, so that it is exact to rounding
    C_t = (twin.C(params, q, t + 1) - twin.C(params, q, t - 1)) / 2
    q_dot = np.zeros(q.size, dtype=np.result_type(q, q_i_dot))
    q_dot[i] = q_i_dot
    q_dot[d] = np.linalg.solve(C_q[:, d], -C_q[:, i] @ q_i_dot - C_t)
    return q, q_dot


def lagrangian(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, t: float) -> complex:
    kinetic, potential = twin.energy(params, *full_rate(twin, params, q_i, q_i_dot, t), t)
    return kinetic - potential


def momentum(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return complex_step(lambda v: np.array([lagrangian(twin, params, q_i, v, t)]), q_i_dot)[0]


def test_constraints_and_order(sample: Any) -> None:
    twin, params, q_i, _, t = sample
    i, d = index(twin, params)
    q = twin.q_full(params, q_i, t)
    assert q.size == len(twin.coordinates(params))
    np.testing.assert_allclose(twin.C(params, q, t), 0, atol=1e-13)
    np.testing.assert_array_equal(q[i], q_i)
    np.testing.assert_array_equal(q[d], twin.q_d(params, q_i, t))
    numerical = complex_step(lambda x: twin.C(params, x, t), q)
    np.testing.assert_allclose(twin.C_q(params, q, t), numerical, atol=1e-13)


def test_mass_matrix_is_the_momentum_matrix(sample: Any) -> None:
    twin, params, q_i, q_i_dot, t = sample
    M = twin.M_hat(params, q_i, t)
    np.testing.assert_allclose(M, M.T, rtol=1e-13, atol=1e-16)
    assert np.min(np.linalg.eigvalsh(M)) > 0
    base = momentum(twin, params, q_i, q_i_dot, t)
    columns = [momentum(twin, params, q_i, q_i_dot + e, t) - base for e in np.eye(q_i.size)]
    np.testing.assert_allclose(M, np.array(columns).T, rtol=1e-10, atol=1e-11 * np.max(np.abs(M)))


def test_lagrange_equation(sample: Any) -> None:
    """d/dt dL/dq' - dL/dq = Q_applied along q'' = M_hat^-1 Q_hat, with L from the bodies."""
    twin, params, q_i, q_i_dot, t = sample
    acceleration = np.linalg.solve(twin.M_hat(params, q_i, t), twin.Q_hat(params, q_i, q_i_dot, t))
    h = 1e-6 / max(1.0, np.max(np.abs(q_i_dot)))

    def ahead(s: float) -> Array:
        position = q_i + s * q_i_dot + s**2 / 2 * acceleration
        return momentum(twin, params, position, q_i_dot + s * acceleration, t + s)

    # fourth-order difference along the motion
    rate = (8 * (ahead(h) - ahead(-h)) - ahead(2 * h) + ahead(-2 * h)) / (12 * h)
    slope = complex_step(lambda x: np.array([lagrangian(twin, params, x, q_i_dot, t)]), q_i)[0]
    applied = twin.Q_applied(params, q_i, q_i_dot, t)
    scale = np.max(np.abs(rate)) + np.max(np.abs(slope)) + np.max(np.abs(applied))
    np.testing.assert_allclose(rate - slope, applied, rtol=0, atol=2e-8 + 2e-11 * scale)


@pytest.mark.parametrize("sample", [name for name in CASES if not name.startswith("driven")], indirect=True)
def test_power_balance(sample: Any) -> None:
    """d(T + V)/dt along the vector field equals the applied power; a drive does work, so not where driven."""
    twin, params, q_i, q_i_dot, t = sample
    acceleration = np.linalg.solve(twin.M_hat(params, q_i, t), twin.Q_hat(params, q_i, q_i_dot, t))
    s = 1j * STEP
    q, q_dot = full_rate(twin, params, q_i + s * q_i_dot, q_i_dot + s * acceleration, t)
    kinetic, potential = twin.energy(params, q, q_dot, t)
    power = twin.Q_applied(params, q_i, q_i_dot, t) @ q_i_dot
    size = abs(np.imag(kinetic)) / STEP + abs(np.imag(potential)) / STEP + abs(power)
    assert abs(np.imag(kinetic + potential) / STEP - power) < 1e-12 * size


def test_jacobians(sample: Any) -> None:
    twin, params, q_i, q_i_dot, t = sample
    a = np.linspace(1, 2, q_i.size) * np.max(np.abs(q_i_dot))
    pairs = [
        (twin.dQ_hat_dq_i(params, q_i, q_i_dot, t), lambda x: twin.Q_hat(params, x, q_i_dot, t), q_i),
        (twin.dQ_hat_dq_i_dot(params, q_i, q_i_dot, t), lambda x: twin.Q_hat(params, q_i, x, t), q_i_dot),
        (twin.dMa_dq_i(params, q_i, a, t), lambda x: twin.M_hat(params, x, t) @ a, q_i),
    ]
    for jacobian, function, x in pairs:
        top = np.max(np.abs(jacobian)) + 1e-12
        np.testing.assert_allclose(jacobian, complex_step(function, x), rtol=1e-10, atol=1e-11 * top)
        for j in range(x.size):  # plain differences: the complex step must not hide a non-analytic path
            h = 1e-5 * max(abs(x[j]), 1e-2)
            e = np.eye(x.size)[j] * h
            difference = (function(x + e) - function(x - e)) / (2 * h)
            noise = 1e-15 * np.max(np.abs(function(x))) / h
            np.testing.assert_allclose(jacobian[:, j], difference, rtol=1e-5, atol=1e-6 * top + 10 * noise)


def test_four_bar_stays_on_its_branch() -> None:
    for theta in np.linspace(0, 2 * np.pi, 73):
        th2, th3 = twin_four_bar.closure(twin_four_bar.Params(), theta)
        assert 0 < th3 - th2 < np.pi and 0 < th2 < np.pi / 2


def test_f1_elastic_frequencies() -> None:
    rod = rod_data.f1_rod()
    frequencies = np.sqrt(eigh(rod.K_ff, rod.M_ff, eigvals_only=True))
    np.testing.assert_allclose(frequencies, [1277, 5107, 6841, 24613], atol=0.6)


def test_f2_coupled_frequencies() -> None:
    """Linear coupled frequencies of case F2 with J_hub = 10."""
    params = f2_params(100, 8)
    q = np.zeros(9)
    stiffness, mass = -twin_hub_beam.dQ_hat_dq_i(params, q, q, 3.0), twin_hub_beam.M_hat(params, q, 3.0)
    values = eigh(stiffness, mass, eigvals_only=True)
    np.testing.assert_allclose(np.sqrt(values[1:4]), [5.8293, 19.052, 51.36], rtol=5e-4)


def f1_errors(rtol: float = 1e-11, atol: float = 1e-13) -> dict[str, float]:
    """Relative errors of the driven F1 twin at t = 0.1 against the published values."""
    params, twin = rod_data.f1_params(), twin_driven_slider_crank

    def rate(t: float, y: Array) -> Array:
        return np.concatenate([y[4:], np.linalg.solve(*twin.condensed(params, y[:4], y[4:], t))])

    start = np.concatenate([rod_data.F1_START, rod_data.F1_START_RATE])
    solution = solve_ivp(rate, (0.0, 0.1), start, method="DOP853", rtol=rtol, atol=atol)
    q, q_dot = solution.y[:4, -1], solution.y[4:, -1]
    errors = {f"q{k + 1}": abs(q[k] / rod_data.F1_END[k] - 1) for k in range(4)}
    full = twin.q_full(params, q, 0.1)
    errors["phi2"] = abs(full[5] / rod_data.F1_END_PHI2 - 1)
    errors["x3"] = abs(full[-3] / rod_data.F1_END_X3 - 1)
    errors["phi2_dot"] = abs(twin.tree_rate(params, q, q_dot, 0.1)[1] / rod_data.F1_END_PHI2_RATE - 1)
    return errors


@pytest.mark.long
def test_f1_published_values() -> None:
    """At the tight default tolerances (twice the time) the errors are q1 5e-11, q2 3e-11, q3 and q4 4e-10."""
    errors = f1_errors(rtol=1e-8, atol=1e-12)
    assert errors["q1"] < 1e-8 and errors["q2"] < 1e-8
    assert errors["q3"] < 1e-7 and errors["q4"] < 1e-7
    # the published x3 breaks the constraint by 2e-10 m
    assert errors["phi2"] < 1e-10 and errors["phi2_dot"] < 1e-8 and errors["x3"] < 1e-8
