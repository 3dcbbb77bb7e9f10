"""Independent checks of the spatial twins: kinetic energy of the poses, Lagrange, power, momenta, reactions."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.hand_derived.spatial import (
    twin_free_body,
    twin_free_flexible,
    twin_governor,
    twin_heavy_top,
    twin_spatial_double_pendulum,
    twin_spatial_hub_beam,
    twin_spatial_slider_crank,
)
from tests.hand_derived.spatial import twin_spatial as spatial
from tests.hand_derived.spatial.spatial_checks import (
    along_motion,
    body_jacobian,
    lagrange_force,
    mass_matrix,
    weight_potential,
)
from tests.hand_derived.twin_common import STEP, Array, complex_step

# (twin, parameters, centre of q_i, scale of q_i, scale of q_i')
CASES: dict[str, tuple[ModuleType, Any, Any, Any, Any]] = {
    "free_body_zyx": (twin_free_body, twin_free_body.Params(), 0.0, [2, 2, 2, 3, 1.2, 3], 4.0),
    "free_body_zxz": (twin_free_body, twin_free_body.Params(sequence="zxz"), [0, 0, 0, 0, 1.5, 0], 1.0, 4.0),
    "heavy_top": (twin_heavy_top, twin_heavy_top.Params(), [0, 1.5, 0], [3, 1.2, 3], 6.0),
    "double_pendulum": (twin_spatial_double_pendulum, twin_spatial_double_pendulum.Params(k2=0.4), 0.0, 3.0, 4.0),
    "governor": (twin_governor, twin_governor.Params(k=800.0, c=40.0), [0, 0.5, 0.5, 0.6], [3, 0.2, 0.4, 0.4], 3.0),
    "hub_beam": (twin_spatial_hub_beam, twin_spatial_hub_beam.Params(), 0.0, [3, 0.2, 0.2, 0.2, 0.02], 4.0),
    "free_flexible_zyx": (
        twin_free_flexible,
        twin_free_flexible.Params(),
        0.0,
        [2, 2, 2, 3, 1.2, 3, 0.3, 0.3, 0.3],
        3.0,
    ),
    "free_flexible_zxz": (
        twin_free_flexible,
        twin_free_flexible.Params(sequence="zxz"),
        [0] * 4 + [1.5] + [0] * 4,
        [2, 2, 2, 3, 1.2, 3, 0.3, 0.3, 0.3],
        3.0,
    ),
    "slider_crank": (twin_spatial_slider_crank, twin_spatial_slider_crank.Params(), 0.0, 3.0, 9.0),
}


@pytest.fixture(params=CASES, ids=list(CASES))
def sample(request: pytest.FixtureRequest) -> tuple[ModuleType, Any, Array, Array]:
    twin, params, centre, scale, rate_scale = CASES[request.param]
    rng = np.random.default_rng(5)
    n = len(twin.coordinates(params))
    return twin, params, centre + rng.uniform(-1, 1, n) * scale, rng.uniform(-1, 1, n) * rate_scale


def test_mass_matrix_is_of_the_kinetic_energy(sample: Any) -> None:
    twin, params, q_i, q_i_dot = sample
    M = twin.M_hat(params, q_i, 0.0)
    np.testing.assert_allclose(M, M.T, rtol=1e-13, atol=1e-15)
    assert np.min(np.linalg.eigvalsh(M)) > 0
    np.testing.assert_allclose(M, mass_matrix(twin, params, q_i, 0.0), rtol=1e-12, atol=1e-13 * np.max(np.abs(M)))
    kinetic = twin.energy(params, q_i, q_i_dot, 0.0)[0]
    assert abs(kinetic - 0.5 * q_i_dot @ M @ q_i_dot) < 1e-13 * kinetic


def test_force_is_lagranges(sample: Any) -> None:
    twin, params, q_i, q_i_dot = sample
    Q = twin.Q_hat(params, q_i, q_i_dot, 0.0)
    expected = lagrange_force(twin, params, q_i, q_i_dot, 0.0)
    np.testing.assert_allclose(Q, expected, rtol=0, atol=2e-10 * np.max(np.abs(Q)))


def test_power_balance(sample: Any) -> None:
    """d(T + V)/dt along the motion equals the power of what has no potential."""
    twin, params, q_i, q_i_dot = sample
    kinetic, potential = twin.energy(params, *along_motion(twin, params, q_i, q_i_dot, 0.0), 0.0)
    power = twin.Q_applied(params, q_i, q_i_dot, 0.0) @ q_i_dot
    size = abs(np.imag(kinetic)) / STEP + abs(np.imag(potential)) / STEP + abs(power)
    assert abs(np.imag(kinetic + potential) / STEP - power) < 1e-12 * size


def test_orientations_are_rotations(sample: Any) -> None:
    twin, params, q_i, _ = sample
    for body in twin.poses(params, q_i, 0.0):
        np.testing.assert_allclose(body.A @ body.A.T, np.eye(3), atol=1e-14)
        assert np.linalg.det(body.A) > 0


@pytest.mark.parametrize("sequence", ["zyx", "zxz"])
def test_angular_velocity_of_the_euler_angles(sequence: str) -> None:
    theta, theta_dot = np.array([0.7, 1.1, -2.3]), np.array([0.9, -1.7, 0.4])
    A, G = spatial.euler_A(sequence, theta), spatial.euler_G(sequence, theta)
    spin = A.T @ np.imag(spatial.euler_A(sequence, theta + 1j * STEP * theta_dot)) / STEP
    np.testing.assert_allclose(spin, spatial.tilde(G @ theta_dot), atol=1e-14)
    rate = np.imag(spatial.euler_G(sequence, theta + 1j * STEP * theta_dot)) / STEP
    np.testing.assert_allclose(spatial.euler_G_dot(sequence, theta, theta_dot), rate, atol=1e-14)


def test_euler_parameters() -> None:
    """A is a rotation turning with omega, e stays of unit length, e'' is the rate of e'."""
    rng = np.random.default_rng(2)
    e = rng.normal(size=4)
    e /= np.linalg.norm(e)
    omega, omega_dot = rng.normal(size=3), rng.normal(size=3)
    e_dot, e_ddot = spatial.parameters_dot(e, omega), spatial.parameters_ddot(e, omega, omega_dot)
    A = spatial.parameters_A(e)
    np.testing.assert_allclose(A @ A.T, np.eye(3), atol=1e-14)
    spin = A.T @ np.imag(spatial.parameters_A(e + 1j * STEP * e_dot)) / STEP
    np.testing.assert_allclose(spin, spatial.tilde(omega), atol=1e-14)
    assert abs(e @ e_dot) < 1e-14 and abs(e @ e_ddot + e_dot @ e_dot) < 1e-14
    ahead = np.imag(spatial.parameters_dot(e + 1j * STEP * e_dot, omega + 1j * STEP * omega_dot)) / STEP
    np.testing.assert_allclose(e_ddot, ahead, atol=1e-14)
    half_turn = spatial.parameters_A(np.array([np.cos(0.4), 0, 0, np.sin(0.4)]))
    np.testing.assert_allclose(half_turn, spatial.rot_z(0.8), atol=1e-15)


@pytest.mark.parametrize("sequence", ["zyx", "zxz"])
def test_free_body_accelerations_are_newtons(sequence: str) -> None:
    """M_hat^-1 Q_hat gives the same R_o'' and omega' as Newton and Euler about the centre of mass."""
    params = twin_free_body.Params(sequence=sequence)
    q, v = np.array([0.3, -0.2, 0.9, 0.8, 1.1, -0.6]), np.array([1.0, 2.0, -1.5, 2.1, -3.0, 1.7])
    acceleration = np.linalg.solve(twin_free_body.M_hat(params, q, 0.0), twin_free_body.Q_hat(params, q, v, 0.0))
    G = spatial.euler_G(sequence, q[3:])
    R_ddot, omega_dot = twin_free_body.accelerations(params, spatial.euler_A(sequence, q[3:]), G @ v[3:])
    np.testing.assert_allclose(acceleration[:3], R_ddot, rtol=1e-12, atol=1e-12)
    bias = spatial.euler_G_dot(sequence, q[3:], v[3:]) @ v[3:]
    np.testing.assert_allclose(G @ acceleration[3:] + bias, omega_dot, rtol=1e-12, atol=1e-12)


def test_free_body_applied_force_is_of_the_virtual_work() -> None:
    params = twin_free_body.Params()
    q = np.array([0.3, -0.2, 0.9, 0.8, 1.1, -0.6])
    J_p = complex_step(lambda x: x[:3] + spatial.euler_A("zyx", x[3:]) @ params.point, q)
    J_w = body_jacobian(twin_free_body, params, q, 0.0, 0)[1]
    expected = J_p.T @ params.force + J_w.T @ spatial.euler_A("zyx", q[3:]) @ params.moment
    np.testing.assert_allclose(twin_free_body.Q_applied(params, q, 0 * q, 0.0), expected, rtol=1e-13)


def test_free_body_keeps_its_momenta() -> None:
    """Without loads: linear and angular momentum about the world origin do not change along the motion."""
    none = np.zeros(3)
    params = replace(twin_free_body.Params(), gravity=none, force=none, moment=none)
    q, v = np.array([0.3, -0.2, 0.9, 0.8, 1.1, -0.6]), np.array([1.0, 2.0, -1.5, 2.1, -3.0, 1.7])
    q_c, v_c = along_motion(twin_free_body, params, q, v, 0.0)
    omega = spatial.euler_G("zyx", q_c[3:]) @ v_c[3:]
    linear, angular = twin_free_body.momenta(params, q_c[:3], spatial.euler_A("zyx", q_c[3:]), v_c[:3], omega)
    np.testing.assert_allclose(np.imag(linear) / STEP, 0, atol=1e-12 * np.linalg.norm(np.real(linear)))
    np.testing.assert_allclose(np.imag(angular) / STEP, 0, atol=1e-11 * np.linalg.norm(np.real(angular)))


def test_lagranges_top_precesses_steadily() -> None:
    """Symmetric top: p1, p3 constant; steady precession where I O^2 cos - p3 O + m g l = 0 (fixed-point moments)."""
    params = twin_heavy_top.Params(
        inertia=np.diag([0.05, 0.05, 0.09]), centre=np.array([0, 0, 0.4]), gravity=np.array([0, 0, -9.81])
    )
    I_1, I_3 = np.diag(twin_heavy_top.inertia_about_pivot(params))[[0, 2]]
    tilt, turn = 0.7, 1.3
    p_3 = (I_1 * turn**2 * np.cos(tilt) + params.mass * 9.81 * 0.4) / turn
    rates = np.array([turn, 0.0, p_3 / I_3 - turn * np.cos(tilt)])
    q = np.array([0.2, tilt, 0.9])
    steady = np.linalg.solve(twin_heavy_top.M_hat(params, q, 0.0), twin_heavy_top.Q_hat(params, q, rates, 0.0))
    np.testing.assert_allclose(steady, 0, atol=1e-12)


def test_heavy_top_reaction_is_the_rate_of_momentum() -> None:
    params, q, v = twin_heavy_top.Params(), np.array([0.4, 1.1, -0.7]), np.array([3.0, -2.0, 5.0])
    expected = motion_force(twin_heavy_top, params, q, v, 0) - params.mass * params.gravity
    np.testing.assert_allclose(twin_heavy_top.reaction(params, q, v, 0.0), expected, rtol=1e-7)


def motion_force(twin: ModuleType, params: Any, q_i: Array, q_i_dot: Array, k: int) -> Array:
    """m a_c of body k, by second differences of its position along the motion."""
    acceleration = np.linalg.solve(twin.M_hat(params, q_i, 0.0), twin.Q_hat(params, q_i, q_i_dot, 0.0))
    h = 1e-3

    def velocity(s: float) -> Array:
        q, v = q_i + s * q_i_dot + s**2 / 2 * acceleration, q_i_dot + s * acceleration
        return body_jacobian(twin, params, q, 0.0, k)[0] @ v

    rate = (8 * (velocity(h) - velocity(-h)) - velocity(2 * h) + velocity(-2 * h)) / (12 * h)
    return twin.poses(params, q_i, 0.0)[k].mass * rate


def test_double_pendulum_reactions() -> None:
    """Newton for each body, moments about the world origin for each body, no constraint moment about the axes."""
    twin, params = twin_spatial_double_pendulum, twin_spatial_double_pendulum.Params(k1=0.3)
    q, v = np.array([0.8, -1.4]), np.array([2.0, -3.0])
    acceleration = np.linalg.solve(twin.M_hat(params, q, 0.0), twin.Q_hat(params, q, v, 0.0))
    (F_1, N_1), (F_2, N_2) = twin.reactions(params, q, v, 0.0)
    A_1, A_2 = twin.orientations(params, q)
    R_1, R_2 = twin.origins(params, q)
    axes = params.A_1a[:, 2], (A_1 @ params.B_2a)[:, 2]
    hinges = params.pivot1, R_2 + A_2 @ params.u_2b
    torques = -(params.k1 * q[0] + params.c1 * v[0]), -(params.k2 * q[1] + params.c2 * v[1])
    N_1, N_2 = N_1 + axes[0] * torques[0], N_2 + axes[1] * torques[1]
    loads = [
        (F_1 - F_2, N_1 - N_2 + np.cross(hinges[0], F_1) - np.cross(hinges[1], F_2)),
        (F_2, N_2 + np.cross(hinges[1], F_2)),
    ]

    def momentum(s: float, k: int) -> Array:
        x, rate = q + s * v + s**2 / 2 * acceleration, v + s * acceleration
        body, (J_v, J_w) = twin.poses(params, x, 0.0)[k], body_jacobian(twin, params, x, 0.0, k)
        linear = body.mass * J_v @ rate
        angular = body.A @ body.inertia @ body.A.T @ J_w @ rate + np.cross(body.R_c, linear)
        return np.concatenate([linear, angular])

    h = 1e-3
    for k, (force, moment) in enumerate(loads):
        ahead = 8 * (momentum(h, k) - momentum(-h, k)) - momentum(2 * h, k) + momentum(-2 * h, k)
        body = twin.poses(params, q, 0.0)[k]
        weight = body.mass * params.gravity
        expected = np.concatenate([force + weight, moment + np.cross(body.R_c, weight)])
        np.testing.assert_allclose(ahead / (12 * h), expected, rtol=0, atol=1e-7)


def test_potential_is_the_weight(sample: Any) -> None:
    """V changes by the work of gravity alone once springs and modes are switched off."""
    twin, params, q_i, _ = sample
    soft = {"k": 0.0, "k1": 0.0, "k2": 0.0}
    params = replace(params, **{name: value for name, value in soft.items() if hasattr(params, name)})
    q_i = q_i.copy()
    if hasattr(twin, "nodes"):  # the rigid coordinates only
        q_i[1 if twin is twin_spatial_hub_beam else 6 :] = 0
    gravity = getattr(params, "gravity", np.array([0, 0, -9.81]))
    slope = complex_step(lambda x: np.array([twin.energy(params, x, 0 * q_i, 0.0)[1]]), q_i)
    expected = complex_step(lambda x: np.array([weight_potential(twin, params, gravity, x, 0.0)]), q_i)
    np.testing.assert_allclose(slope, expected, rtol=1e-12, atol=1e-12)


def test_governor_springs_by_points() -> None:
    """Spring lengths from the poses; their gradients by complex step."""
    params, q = twin_governor.Params(), np.array([0.4, 0.45, 0.5, 0.7])
    bodies = twin_governor.poses(params, q, 0.0)
    for k, side in ((0, 1), (1, -1)):
        end = bodies[1].R_c + bodies[1].A @ np.array([side * params.b, 0, 0])
        length = np.linalg.norm(bodies[2 + k].R_c - end)
        assert abs(twin_governor.springs(params, q)[0][k] - length) < 1e-14
    gradient = complex_step(lambda x: twin_governor.springs(params, x)[0], q)
    _, by_beta, by_s = twin_governor.springs(params, q)
    np.testing.assert_allclose(gradient[:, 1], by_s, rtol=1e-13)
    np.testing.assert_allclose(gradient[:, 2:], np.diag(by_beta), rtol=1e-13, atol=1e-16)


def governor_rate(t: float, y: Array) -> Array:
    params = twin_governor.Params()
    q, v = y[:4], y[4:]
    return np.concatenate([v, np.linalg.solve(twin_governor.M_hat(params, q, t), twin_governor.Q_hat(params, q, v, t))])


def test_governor_published_values() -> None:
    """A05: eigenvalues at the start and slider travel to 1 s (10 s agrees to 6e-14 as well, in 10 s of time)."""
    start = np.concatenate(twin_governor.start(twin_governor.Params()))
    jacobian = complex_step(lambda y: governor_rate(0.0, y), start)
    np.testing.assert_allclose(np.sort(np.linalg.eigvals(jacobian).real)[:2], [-8117, -1450], atol=0.5)

    def slope(t: float, y: Array) -> Array:
        return complex_step(lambda x: governor_rate(t, x), y)

    solution = solve_ivp(
        governor_rate, (0, 1), start, method="Radau", jac=slope, rtol=1e-7, atol=1e-10, t_eval=[0.1, 0.5, 1.0]
    )
    expected = [0.52383647556958, 0.74324942478637, 0.50142092237955]
    np.testing.assert_allclose(solution.y[1], expected, rtol=0, atol=1e-7)
