"""Checks of the flexible spatial twins and of the slider-crank's closure that need more than the generic ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.hand_derived.spatial import twin_free_flexible, twin_spatial_hub_beam, twin_spatial_slider_crank
from tests.hand_derived.spatial import twin_spatial as spatial
from tests.hand_derived.spatial.spatial_checks import along_motion
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes
from tests.hand_derived.twin_common import STEP, Array, complex_step

NONE = np.zeros(3)


@pytest.mark.parametrize("sequence", ["zyx", "zxz"])
def test_free_flexible_accelerations(sequence: str) -> None:
    """Euler angles and body-axes velocities give the same accelerations."""
    params = twin_free_flexible.Params(sequence=sequence)
    rng = np.random.default_rng(8)
    q, v = rng.normal(size=9) * 0.5 + 0.4, rng.normal(size=9) * 2
    acceleration = np.linalg.solve(
        twin_free_flexible.M_hat(params, q, 0.0), twin_free_flexible.Q_hat(params, q, v, 0.0)
    )
    G, bias = spatial.euler_G(sequence, q[3:6]), spatial.euler_G_dot(sequence, q[3:6], v[3:6]) @ v[3:6]
    A = spatial.euler_A(sequence, q[3:6])
    R_ddot, omega_dot, q_f_ddot = twin_free_flexible.accelerations(params, A, G @ v[3:6], q[6:], v[6:])
    np.testing.assert_allclose(acceleration[:3], R_ddot, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(G @ acceleration[3:6] + bias, omega_dot, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(acceleration[6:], q_f_ddot, rtol=1e-9, atol=1e-9)


def test_free_flexible_keeps_its_momenta() -> None:
    """Without loads the momenta of the nodes, velocities by complex step, do not change along the motion."""
    params = twin_free_flexible.Params(gravity=NONE, force=NONE)
    rng = np.random.default_rng(9)
    q, v = rng.normal(size=9) * 0.5 + 0.4, rng.normal(size=9) * 2
    acceleration = np.linalg.solve(
        twin_free_flexible.M_hat(params, q, 0.0), twin_free_flexible.Q_hat(params, q, v, 0.0)
    )

    def places(x: Array) -> Array:
        return np.array([place for _, place in twin_free_flexible.nodes(params, x, 0.0)])

    def momentum(s: float) -> Array:
        x, rate = q + s * v + s**2 / 2 * acceleration, v + s * acceleration
        linear = params.body.masses[:, None] * (np.imag(places(x + 1j * STEP * rate)) / STEP)
        return np.concatenate([linear.sum(axis=0), np.cross(places(x), linear).sum(axis=0)])

    h = 1e-3
    rate = (8 * (momentum(h) - momentum(-h)) - momentum(2 * h) + momentum(-2 * h)) / (12 * h)
    size = np.max(np.abs(momentum(0.0)))
    np.testing.assert_allclose(rate, 0, atol=1e-7 * size)
    # the flexible part takes part in the exchange: the motion is not a rigid one
    assert np.max(np.abs(acceleration[6:])) > 1


def test_free_flexible_without_modes_in_play_is_rigid() -> None:
    """The block of (R_o, theta) at q_f = 0 is that of the rigid body of the same nodes."""
    params = twin_free_flexible.Params(gravity=NONE, force=NONE)
    masses, x = params.body.masses, params.body.positions
    total = masses.sum()
    centre = masses @ x / total
    arms = x - centre
    inertia = sum(m * (a @ a * np.eye(3) - np.outer(a, a)) for m, a in zip(masses, arms, strict=True))
    q = np.concatenate([[0.3, -0.2, 0.9, 0.8, 1.1, -0.6], np.zeros(3)])
    M = twin_free_flexible.M_hat(params, q, 0.0)[:6, :6]
    A, G = spatial.euler_A("zyx", q[3:6]), spatial.euler_G("zyx", q[3:6])
    J_v = np.hstack([np.eye(3), -A @ spatial.tilde(centre) @ G])
    J_w = np.hstack([np.zeros((3, 3)), G])
    np.testing.assert_allclose(M, total * J_v.T @ J_v + J_w.T @ inertia @ J_w, rtol=1e-12, atol=1e-13)


def test_hub_beam_in_a_plane() -> None:
    """Axis along z, one bending mode in y, clamp on the axis: the planar matrix [[J + q N q, b], [b, M_ff]]."""
    s = np.linspace(0, 1, 5)
    shapes = np.zeros((5, 3, 1))
    shapes[:, 1, 0] = s**2
    masses = np.array([0.1, 0.2, 0.2, 0.2, 0.1])
    positions = np.stack([1.5 * s, 0 * s, 0 * s], axis=1)
    beam = Nodes(masses, positions, shapes, np.array([[7.0]]), np.zeros((1, 1)))
    unit = np.eye(3)
    params = replace(
        twin_spatial_hub_beam.Params(),
        beam=beam,
        A_a=unit,
        B_b=unit,
        B_c=unit,
        clamp=NONE,
        hub_centre=NONE,
        gravity=NONE,
        torque=0.0,
        damper=0.0,
    )
    q, v = np.array([0.8, 0.3]), np.array([2.0, 0.7])
    m_ff, b = masses @ s**4, 1.5 * masses @ s**3
    M = [[0.19 + masses @ (1.5 * s) ** 2 + m_ff * 0.09, b], [b, m_ff]]
    Q = [-2 * 2.0 * m_ff * 0.3 * 0.7, 4.0 * m_ff * 0.3 - 7.0 * 0.3]
    np.testing.assert_allclose(twin_spatial_hub_beam.M_hat(params, q, 0.0), M, rtol=1e-13)
    np.testing.assert_allclose(twin_spatial_hub_beam.Q_hat(params, q, v, 0.0), Q, rtol=1e-13)


@pytest.mark.parametrize("phi", np.linspace(0, 2 * np.pi, 9)[:-1])
def test_slider_crank_closes(phi: float) -> None:
    """The rod's pin is the crank's pin; the universal joint's axes cross at a right angle and its angles are met."""
    twin, params, q = twin_spatial_slider_crank, twin_spatial_slider_crank.Params(), np.array([phi])
    A_r = twin.rod_A(params, q)
    crank, rod, slider = twin.origins(params, q)
    pin = rod + A_r @ np.array([params.l, 0, 0])
    np.testing.assert_allclose(pin, twin.crank_pin(params, phi), atol=1e-14)
    np.testing.assert_allclose(pin, crank + spatial.rot_x(phi) @ np.array([0, params.r, 0]), atol=1e-14)
    assert slider[0] > 0 and abs(A_r[2, 1]) < 1e-15
    e_x, e_y, e_z = np.eye(3)
    U, B = np.stack([e_y, -e_x, e_z], axis=1), np.stack([-e_y, e_x, e_z], axis=1)
    alpha, beta = twin.universal_angles(params, q)
    np.testing.assert_allclose(A_r @ B, U @ spatial.rot_z(alpha) @ spatial.rot_x(beta), atol=1e-14)


def test_slider_crank_derivatives() -> None:
    """x', alpha', beta' and the second ones of the twin, by complex step of the first."""
    params = twin_spatial_slider_crank.Params()
    for low, high in (("x", "x1"), ("x1", "x2"), ("alpha", "a1"), ("a1", "a2"), ("beta", "b1"), ("b1", "b2")):
        slope = complex_step(
            lambda p, low=low: np.array([twin_spatial_slider_crank._motion(params, p[0])[low]]), np.array([0.7])
        )
        assert abs(slope[0, 0] - twin_spatial_slider_crank._motion(params, 0.7)[high]) < 1e-13


def test_slider_crank_keeps_its_energy() -> None:
    """No loads: the kinetic energy does not change along the motion."""
    params = replace(twin_spatial_slider_crank.Params(), gravity=NONE, torque=0.0, force=0.0, c=0.0)
    motion = along_motion(twin_spatial_slider_crank, params, np.array([0.7]), np.array([5.0]), 0.0)
    kinetic = twin_spatial_slider_crank.energy(params, *motion, 0.0)[0]
    assert abs(np.imag(kinetic) / STEP) < 1e-12 * np.real(kinetic)
