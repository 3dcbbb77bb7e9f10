"""Modes against exact frequencies: turning and loaded beams, whirl, damped and free systems."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import equilibrium, linearise, modes
from runtime.model import Model
from runtime.operating.linearisation import modal_analysis
from symgen.scene import Scene, SceneRecord
from symgen.scenes.beams import spin_up_beam
from tests.support.rotor_scenes import UNIT, gimbal

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
# exact Euler-Bernoulli beam turning at hub radius 0, frequencies out of plane in units of sqrt(EI / (rho A L^4))
ROTATING = {
    2.0: (4.137320, 22.614922, 62.273184),
    6.0: (7.360373, 26.809082, 66.683914),
    10.0: (11.202328, 33.640366, 74.649295),
}


def test_coupled_frequencies_of_the_hub_and_its_beam(built_in: Load, model_of: Build) -> None:
    """Exact: y = p sin bx + q sinh bx + r (cos bx - cosh bx) with a free end and, at the hub, J_h w^2 y' = -E I y''.

    With a = b L, J = J_h / (rho A L^3): J a^3 (p + q) = 2 r, and w = a^2 sqrt(E I / (rho A L^4)). Case F2 prints
    5.8293, 19.052, 51.36 rad/s for J_h = 10.
    """
    E, second, rho, A, L, J_h = 6.8952e10, 8.2189e-9, 2766.7, 7.2968e-5, 8.0, 10.0
    J, unit = J_h / (rho * A * L**3), math.sqrt(E * second / (rho * A * L**4))

    def gap(a: float) -> float:
        end = [-math.sin(a), math.sinh(a), -math.cos(a) - math.cosh(a)]
        shear = [-math.cos(a), math.cosh(a), math.sin(a) - math.sinh(a)]
        return float(np.linalg.det([end, shear, [J * a**3, J * a**3, -2.0]]))

    grid = np.linspace(1.0, 9.0, 400)
    roots = [brentq(gap, a, b) for a, b in zip(grid, grid[1:], strict=False) if gap(a) * gap(b) < 0][:3]
    exact = np.array([a**2 * unit for a in roots])
    np.testing.assert_allclose(exact, (5.8293, 19.052, 51.36), rtol=4e-4)
    three = modes(built_in("hub_beam"))
    assert three.names[0] == "rigid hub.theta" and three.frequencies[0] == 0 and list(three.rigid[:2]) == [True, False]
    np.testing.assert_allclose(three.frequencies[1:], exact, rtol=4e-4)


def rotating(model: Model, speed: float, clamped: float) -> np.ndarray:
    """In-plane frequencies in units of sqrt(EI / (rho A L^4)) of a beam on a drive of constant speed."""
    found = linearise(
        model, equilibrium(model, parameters={"omega": speed * clamped}, at_time=20.0), inputs=(), outputs=()
    )
    return np.asarray(found.frequencies / clamped)


@pytest.mark.long
def test_a_rotating_cantilever(model_of: Build) -> None:
    """Exact: in the plane of rotation w^2 is that out of plane less the speed squared; 16 modes in closed form."""
    model = model_of(spin_up_beam(modes=16))
    for speed, out_of_plane in ROTATING.items():
        error = rotating(model, speed, UNIT)[:3] / np.sqrt(np.array(out_of_plane) ** 2 - speed**2) - 1
        assert np.abs(error[:2]).max() < 1e-5 and abs(error[2]) < 1e-5, (speed, error)


@pytest.mark.long
def test_a_rotating_cantilever_out_of_plane(build: Callable[[SceneRecord, frozenset[str]], Model]) -> None:
    """Exact: out of the plane of rotation and in it at once, in space; 8 modes each way."""
    ends = {"ends": "clamped-free", "modes": 8}
    scene = (
        Scene("flap", space="spatial")
        .parameter("omega", 6.0, "rad/s", "speed")
        .beam("beam", length=1.0, density=1.0, area=1.0, second_moment=1.0, second_moment_z=1.0, youngs_modulus=1.0,
              lateral=ends, lateral_z=ends, stiffening=True)
        .revolute("pivot", "ground.origin", "beam.start")
        .prescribed_angle("drive", "ground.origin", "beam.start", motion="omega * t")
        .build()
    )  # fmt: skip
    model = build(scene, frozenset({"condensed", "closure", "velocities", "residual_jacobian"}))
    for speed in (2.0, 6.0):
        flap = np.array(ROTATING[speed])
        exact = np.sort(np.concatenate([flap, np.sqrt(flap**2 - speed**2)]))
        np.testing.assert_allclose(modes(model, parameters={"omega": speed}).frequencies[:6], exact, rtol=2e-5)


@pytest.mark.long
def test_convergence_in_modes(model_of: Build) -> None:
    """From above, as Ritz has it: at speed 10 the first frequency in the plane is off by these parts."""
    exact = math.sqrt(ROTATING[10.0][0] ** 2 - 100.0)
    errors = [rotating(model_of(spin_up_beam(modes=count)), 10.0, UNIT)[0] / exact - 1 for count in (3, 5, 8, 12)]
    np.testing.assert_allclose(errors, [8.2e-3, 1.2e-3, 1.62e-4, 2.53e-5], rtol=0.02)


def test_pinned_beam_under_an_axial_load(model_of: Build) -> None:
    """Exact: w^2 = w_0^2 (1 - P / P_cr), from tension to 0.9 P_cr, with Euler's P_cr; unstable above."""
    L, E, second, rho, A = 2.0, 7e10, 1e-9, 2700.0, 1e-4
    scene = (
        Scene("column")
        .parameter("P", 1.0, "N", "compression")
        .beam("column", length=L, density=rho, area=A, second_moment=second, youngs_modulus=E,
              lateral={"ends": "pinned-pinned", "modes": 2}, stiffening=True)
        .revolute("left", "ground.origin", "column.start")
        .point_on_line("right", "ground.origin", "column.end")
        .force("push", "column.end", "-P", 0.0)
        .build()
    )  # fmt: skip
    model = model_of(scene)
    critical, w_0 = math.pi**2 * E * second / L**2, (math.pi / L) ** 2 * math.sqrt(E * second / (rho * A))
    for share in (-2.0, -0.5, 0.5, 0.9):
        w = modes(model, parameters={"P": share * critical}).frequencies[0]
        assert w**2 == pytest.approx(w_0**2 * (1 - share), rel=2e-5)
    beyond = modes(model, parameters={"P": 1.1 * critical})
    assert beyond.eigenvalues[0].real > 0 and beyond.damping_ratios[0] == -1 and not beyond.system.modal.stable


def test_car_axis_at_rest(model_of: Build) -> None:
    """Hand: each half mass on its spring, y = 0.5 - (m/2) g / k, and sqrt(k / (m/2)) twice, in any pair of shapes."""
    y_axis = {"position": (0.0, 0.0), "angle": math.pi / 2}
    scene = (
        Scene("car_axis")
        .gravity(0.0, -1.0)
        .ground(markers={"axis": y_axis, "right": {"position": (1.0, 0.0)}})
        .rigid("axle", mass=1e-3, inertia=2.5e-4, center_of_mass=(0.5, 0.0), markers={"end": {"position": (1.0, 0.0)}})
        .point_on_line("left_end", "ground.axis", "axle.origin")
        .spring_damper("left", "ground.origin", "axle.origin", stiffness=1.0, free_length=0.5)
        .spring_damper("right", "ground.right", "axle.end", stiffness=1.0, free_length=0.5)
        .initial({"axle.y": 0.45, "axle.theta": 0.05})
        .build()
    )
    model = model_of(scene)
    rest = equilibrium(model)
    assert rest.stable and rest["axle.y"] == pytest.approx(0.4995, abs=1e-12)
    assert rest["axle.theta"] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(modes(model, rest).frequencies, math.sqrt(1.0 / 5e-4), rtol=1e-9)


def test_rigid_body_modes_are_named(built_in: Load) -> None:
    """A body in free space at rest: three motions along axes and three turns, all without stiffness."""
    found = modes(built_in("tumbling_body"), {f"body.{name}_dot": 0.0 for name in ("e1", "e2", "e3")})
    assert found.rigid.all() and not found.frequencies.any()
    assert all(name.startswith("rigid body.") for name in found.names)


@pytest.mark.parametrize("speed", [0.0, 30.0, 300.0])
def test_whirl_of_a_rotor(model_of: Build, speed: float) -> None:
    """Exact: w = sqrt(a^2 + k / I_t) -+ a with a = I_p speed / (2 I_t), backward and forward."""
    k, I_t, I_p = 45.0, 0.02, 0.03
    model = model_of(gimbal(k, 30.0))
    found = modes(model, equilibrium(model, rates={"spin.omega": speed}))
    a = I_p * speed / (2 * I_t)
    exact = [0.0, math.sqrt(a**2 + k / I_t) - a, math.sqrt(a**2 + k / I_t) + a]
    np.testing.assert_allclose(found.frequencies, exact, rtol=1e-9)
    assert found.names[0] == "rigid spin.angle"
    if speed:  # forward whirl: lean follows tilt by a quarter of a turn, backward: it leads
        tilt, lean = (found.system.names.index(name) for name in ("tilt.angle", "lean.angle"))
        turns = found.shapes[lean, 1:] / found.shapes[tilt, 1:]
        np.testing.assert_allclose(turns, [1j, -1j], atol=1e-9)


def test_the_start_speed_is_the_default(model_of: Build) -> None:
    """Without a place, the rates of the scene's start are kept: here 30 rad/s."""
    model = model_of(gimbal(45.0, 30.0))
    np.testing.assert_array_equal(
        modes(model).frequencies, modes(model, equilibrium(model, rates={"spin.angle": 30.0})).frequencies
    )


def test_damped_modes_are_complex() -> None:
    """Against the roots of det(s^2 M + s D + s K) of a chain of two masses with one damper, expanded by hand."""
    M, D, K = np.diag([2.0, 1.0]), np.array([[3.0, -3.0], [-3.0, 3.0]]), np.array([[50.0, -20.0], [-20.0, 20.0]])
    # (2 s^2 + 3 s + 50)(s^2 + 3 s + 20) - (3 s + 20)^2
    roots = np.roots([2.0, 9.0, 90.0, 90.0, 600.0])
    found = modal_analysis(M, D, K)
    for value in found.eigenvalues:
        assert np.abs(roots - value).min() < 1e-11
    np.testing.assert_allclose(found.frequencies, np.abs(found.eigenvalues), rtol=1e-14)
    np.testing.assert_allclose(found.damping_ratios, -found.eigenvalues.real / found.frequencies, rtol=1e-12)
    assert np.abs(found.shapes.imag).max() > 0.05
    for k, value in enumerate(found.eigenvalues):
        left = (value**2 * M + value * D + K) @ found.shapes[:, k]
        assert np.abs(left).max() < 1e-11 * 50


def test_overdamped_modes_keep_their_pairs() -> None:
    """Two independent overdamped oscillators: frequency sqrt(k / m) and ratio c / (2 sqrt(k m)) each, by hand."""
    found = modal_analysis(np.diag([1.0, 2.0]), np.diag([5.0, 60.0]), np.diag([4.0, 200.0]))
    np.testing.assert_allclose(found.frequencies, [2.0, 10.0], rtol=1e-12)
    np.testing.assert_allclose(found.damping_ratios, [1.25, 1.5], rtol=1e-12)


def test_a_free_damped_body_has_one_zero() -> None:
    """m x'' + d x' = 0: a rigid-body mode although one of its eigenvalues is -d / m."""
    found = modal_analysis(np.array([[2.0]]), np.array([[3.0]]), np.array([[0.0]]))
    assert found.rigid[0] and found.frequencies[0] == 0 and found.stable
    np.testing.assert_allclose(np.sort(found.every_eigenvalue.real), [-1.5, 0.0], atol=1e-15)
