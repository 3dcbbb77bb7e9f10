"""Euler angles as input and output: starts by angles, angles read off, a motion without singular orientations."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from runtime import InitialStateError, Model, Solution, ensemble, equilibrium, simulate
from runtime.contract.orientations import (
    angle_motion,
    angle_rates,
    angles,
    parameter_slopes,
    quaternion,
    turning_axes,
    turning_axes_rate,
)
from symgen.scene import Scene, SceneError, SceneRecord
from tests.laws.test_random_spatial import turned_place
from tests.support.model_values import Array, evaluate, make_state, random_states, relative_error

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
SEQUENCES = [a + b + c for a, b, c in itertools.product("xyz", repeat=3) if a != b != c]


def free(kind: str, coordinates: dict[str, Any], rates: dict[str, float], **more: Any) -> Scene:
    """A body of three different moments of inertia, in free fall without weight."""
    builder = Scene("falling", space="spatial")
    builder.rigid("body", mass=1.0, inertia=[1.0, 2.0, 3.0], orientation=kind, free=True, **more)
    builder.initial(coordinates).rates(rates)
    return builder.simulation(t_end=1.0, dt=1e-2, scheme="rk4")


def world(e: np.ndarray) -> np.ndarray:
    """Rotation matrices (N, 3, 3), by SciPy."""
    return Rotation.from_quat(np.roll(e, -1, axis=-1)).as_matrix()


@pytest.mark.parametrize("kind", SEQUENCES)
def test_angles_and_parameters(kind: str) -> None:
    """All twelve sequences against SciPy's, their axes and rates against differences."""
    rng, h = np.random.default_rng(0), 1e-6
    theta, rate = rng.uniform(0.1, 1.2, (5, 3)), rng.normal(size=(5, 3))
    e = quaternion(kind, theta)
    np.testing.assert_allclose(world(e), Rotation.from_euler(kind.upper(), theta).as_matrix(), atol=1e-14)
    np.testing.assert_allclose(angles(kind, e), theta, atol=1e-13)
    np.testing.assert_allclose(angles(kind, -e), theta, atol=1e-13)
    singular = theta * [1, 0, 1] + [0, 0.0 if kind[0] == kind[2] else math.pi / 2, 0]
    for turned in (quaternion(kind, singular), quaternion(kind, 0 * theta), rng.normal(size=(20, 4))):
        turned = turned / np.linalg.norm(turned, axis=1, keepdims=True)
        found = Rotation.from_euler(kind.upper(), angles(kind, turned)).as_matrix()
        np.testing.assert_allclose(found, world(turned), atol=1e-14)
    assert not angles(kind, np.array([1.0, 0.0, 0.0, 0.0])).any()
    near, far = (quaternion(kind, theta + step * rate) for step in (h, -h))
    np.testing.assert_allclose((parameter_slopes(kind, theta[0]) @ rate[0]), (near - far)[0] / (2 * h), atol=1e-9)
    turn = Rotation.from_matrix(np.swapaxes(world(far), 1, 2) @ world(near)).as_rotvec() / (2 * h)
    np.testing.assert_allclose((turning_axes(kind, theta) @ rate[..., None])[..., 0], turn, atol=1e-8)
    np.testing.assert_allclose(angle_rates(kind, theta, turn), rate, atol=1e-6)
    W = (turning_axes(kind, theta + h * rate) - turning_axes(kind, theta - h * rate)) / (2 * h)
    np.testing.assert_allclose(turning_axes_rate(kind, theta, rate), W, atol=1e-8)


@pytest.mark.parametrize("kind", ["zyx", "zxz"])
def test_motion_of_angles(kind: str) -> None:
    """Angles that grow evenly are read off with these rates and without accelerations, up to whole turns."""
    t, slopes = np.linspace(0.0, 0.3, 5), np.array([30.0, 1.7, -11.0])
    theta = np.array([0.2, 0.6, -0.4]) + t[:, None] * slopes
    e, h = quaternion(kind, theta), 1e-4
    near, far = (quaternion(kind, theta + step * slopes) for step in (h, -h))
    found = angle_motion(kind, e, (near - far) / (2 * h), (near - 2 * e + far) / h**2)
    np.testing.assert_allclose(np.sin((found[0] - theta) / 2), 0.0, atol=1e-13)
    np.testing.assert_allclose(found[1], np.tile(slopes, (len(t), 1)), rtol=1e-4)
    np.testing.assert_allclose(found[2], 0.0, atol=0.05)
    assert np.abs(found[0]).max() <= math.pi and np.ptp(theta[:, 0]) > math.pi


def test_a_body_passes_the_singular_orientation_of_its_angles(model_of: Build) -> None:
    """It tumbles within 0.6 degrees of it, where rates of angles reach 300 rad/s: energy and momentum stay.

    It is told, and the run is that of the body without angles, bit for bit.
    """
    rates = {"body.theta2": 3.0, "body.theta1": 0.03}
    run = simulate(model_of(free("zyx", {}, rates).build()))
    assert run.status.name == "completed"
    (event,) = run.events
    assert event.kind == "angles_singular" and "zyx of body" in event.text and 0.45 < event.time < 0.6
    omega = np.column_stack([run[f"body.omega_{axis}"] for axis in "xyz"])
    A = world(np.column_stack([run[f"body.e{k}"] for k in range(4)]))
    momentum = np.einsum("tij,tj->ti", A, omega * [1.0, 2.0, 3.0])
    np.testing.assert_allclose(momentum, momentum[:1].repeat(len(run.t), axis=0), atol=1e-8 * np.abs(momentum).max())
    np.testing.assert_allclose(run.total_energy, run.total_energy[0], rtol=1e-8)
    theta = np.column_stack([run[f"body.theta{k}"] for k in (1, 2, 3)])
    np.testing.assert_allclose(Rotation.from_euler("ZYX", theta).as_matrix(), A, atol=1e-12)
    np.testing.assert_allclose(omega[0], [0.0, 3.0, 0.03], atol=1e-15)
    turns = {"body.omega_y": 3.0, "body.omega_z": 0.03}
    other = simulate(model_of(free("euler_parameters", {}, turns).build()))
    assert np.array_equal(other.q, run.q) and not other.events


@pytest.mark.parametrize("kind, middle", [("zxz", 0.0), ("zyx", math.pi / 2)])
def test_a_start_in_the_singular_orientation(model_of: Build, kind: str, middle: float) -> None:
    """Rates of angles there are an angular velocity like any other: the one about the axis that two angles share."""
    run = simulate(model_of(free(kind, {"body.theta2": middle}, {"body.theta1": 2.0}).build()), t_end=0.1)
    assert run.status.ok
    expected = [0.0, 0.0, 2.0] if kind == "zxz" else [-2.0, 0.0, 0.0]
    np.testing.assert_allclose([run[f"body.omega_{axis}"][0] for axis in "xyz"], expected, atol=1e-15)


def test_what_is_given_by_angles_stays(model_of: Build) -> None:
    """One fixed angle of a rod between two balls of a loop: its own turn, which the loop leaves open."""
    builder = Scene("loop", space="spatial").ground(markers={"b": {"position": [0.5, 0.9, 0.2], "axis": [0, 0.8, 0.6]}})
    builder.rigid("crank", mass=1.0, inertia=[0.02] * 3, markers={"tip": {"position": [0, 0.4, 0]}})
    ends = {"near": {"position": [0, -0.3, 0]}, "far": {"position": [0, 0.4, 0]}}
    builder.rigid("rod", mass=1.0, inertia=[0.05, 0.03, 0.05], orientation="zxy", markers=ends)
    builder.rigid("rocker", mass=1.0, inertia=[0.03] * 3, markers={"tip": {"position": [0.3, 0, 0]}})
    builder.revolute("left", "ground.origin", "crank.origin").revolute("right", "ground.b", "rocker.origin")
    builder.spherical("first", "crank.tip", "rod.near").spherical("second", "rod.far", "rocker.tip")
    builder.initial({"rod.theta3": {"value": 0.3, "fixed": True}})
    model = model_of(builder.rates({"rod.theta3": {"value": 20.0, "fixed": True}}).build())
    run = simulate(model, t_end=1e-3, dt=1e-3, scheme="rk4")
    assert run["rod.theta3"][0] == pytest.approx(0.3, abs=1e-12)
    assert run["rod.theta3_dot"][0] == pytest.approx(20.0, abs=1e-9)
    assert run.constraint_error[0] < 1e-12
    again = simulate(model, t_end=1e-3, dt=1e-3, scheme="rk4", initial={"rod.theta3": -0.4, "rod.theta3_dot": 5.0})
    assert again["rod.theta3"][0] == pytest.approx(-0.4, abs=1e-12)
    assert again["rod.theta3_dot"][0] == pytest.approx(5.0, abs=1e-9)
    for name in ("rod.theta1", "rod.theta2"):
        assert again[name][0] == pytest.approx(run[name][0], abs=1e-9)


def test_a_body_on_a_hinge_is_given_by_its_angles(model_of: Build) -> None:
    """The hinge's own angle follows, whichever of e and -e the joint's markers make of it."""
    for x_axis in ([1, 0, 0], [-1, 0, 0]):
        builder = Scene("door", space="spatial").rigid(
            "door", mass=1.0, inertia=[1.0] * 3, orientation="zyx", markers={"edge": {"x_axis": x_axis}}
        )
        builder.revolute("hinge", "ground.origin", "door.edge").initial({"door.theta1": 2.5}).rates(
            {"door.theta1": 3.0}
        )
        run = simulate(model_of(builder.simulation(t_end=0.1, dt=1e-2, scheme="rk4").build()))
        expected = 2.5 if x_axis[0] > 0 else 2.5 - math.pi
        assert math.remainder(run["hinge.angle"][0] - expected, 2 * math.pi) == pytest.approx(0.0, abs=1e-12)
        np.testing.assert_allclose(np.unwrap(run["door.theta1"]), 2.5 + 3.0 * run.t, atol=1e-12)


def test_what_is_left_open_rests(model_of: Build) -> None:
    """A wheel that spins on a body whose angles are given starts alone."""
    axles = {"axle": {"position": [0, 0.3, 0], "axis": [0, 1, 0]}}
    builder = free("zyx", {f"body.theta{k}": {"value": 0.1 * k, "fixed": True} for k in (1, 2, 3)}, {}, markers=axles)
    builder.rigid("wheel", mass=0.1, inertia=[0.01] * 3, markers={"axle": {"axis": [0, 1, 0]}})
    builder.revolute("axle", "body.axle", "wheel.axle").rates({"axle.angle": 20.0})
    run = simulate(model_of(builder.build()), t_end=0.01)
    for name in ("x", "y", "z", "theta1", "theta2", "theta3"):
        assert run[f"body.{name}_dot"][0] == pytest.approx(0.0, abs=1e-14)
    assert run["axle.angle_dot"][0] == 20.0


def test_angles_wherever_values_have_names(model_of: Build, tmp_path: Any) -> None:
    """Measures and their rates, saved tables, ensembles, other starts of a run, equilibria."""
    builder = free("zyx", {"body.theta1": 0.4}, {"body.theta1": 1.0, "body.theta2": 0.5})
    builder.measure("yaw", "coordinate", "body.theta1")
    model = model_of(builder.build())
    run = simulate(model, t_end=0.2)
    np.testing.assert_allclose(run["yaw"], run["body.theta1"], atol=1e-14)
    np.testing.assert_allclose(run["yaw_dot"], run["body.theta1_dot"], atol=1e-13)
    run.export(tmp_path / "run.csv")
    header = (tmp_path / "run.csv").read_text().splitlines()[0]
    assert "body.theta2 [rad]" in header and "body.theta2_dot [rad/s]" in header
    run.save(tmp_path / "run.npz")
    np.testing.assert_array_equal(Solution.load(tmp_path / "run.npz")["body.theta3"], run["body.theta3"])
    cases = ensemble(model, initial={"body.theta2": [0.1, 0.7]}, outputs=["body.theta2"], t_end=0.1)
    for case, value in enumerate((0.1, 0.7)):
        alone = simulate(model, t_end=0.1, initial={"body.theta2": value})
        assert alone["body.theta2"][0] == pytest.approx(value, abs=1e-14)
        assert alone["body.theta1"][0] == pytest.approx(0.4, abs=1e-14)
        np.testing.assert_allclose(np.asarray(cases["body.theta2"])[case][-1], alone["body.theta2"][-1], atol=1e-13)
    assert equilibrium(model, initial={"body.theta2": 0.3})["body.theta2"] == pytest.approx(0.3, abs=1e-12)
    with pytest.raises(InitialStateError, match="theta1_dot and angular velocities of body"):
        simulate(model, initial={"body.theta1_dot": 1.0, "body.omega_x": 1.0})
    spun = simulate(model, t_end=0.01, initial={"body.theta2": 0.6, "body.omega_x": 4.0})
    assert spun["body.theta2"][0] == pytest.approx(0.6, abs=1e-14) and spun["body.omega_x"][0] == 4.0


@pytest.mark.parametrize("joints", [("revolute", "revolute"), ("spherical", "spherical"), ("spherical", "revolute")])
def test_loads_that_follow_coordinates(
    build: Callable[[SceneRecord, frozenset[str] | None], Model], joints: tuple[str, str]
) -> None:
    """Residual Jacobians where loads depend on angles, places and Euler parameters of bodies that joints place, and on
    their rates: differences of Q_hat - M_hat a."""
    builder = Scene("controlled", space="spatial").gravity(0.3, -0.4, -9.81)
    ends = {"hinge": {"axis": [0.3, 0.4, 1]}, "next": {"position": [0.5, 0.2, 0.1], "axis": [1, 0.2, 0.3]}}
    data: dict[str, Any] = {"mass": 1.0, "inertia": [0.4, 0.5, 0.6], "center_of_mass": [0.1, 0.2, 0.3], "markers": ends}
    builder.rigid("base", orientation="xyz", **data).rigid("arm", orientation="zyx", **data)
    builder.joint(joints[0], "first", "ground.origin", "base.hinge")
    builder.joint(joints[1], "second", "base.next", "arm.hinge")
    for name, coordinate in (("yaw", "arm.theta1"), ("pitch", "base.theta2"), ("x", "arm.x"), ("e", "arm.e1")):
        builder.measure(name, "coordinate", coordinate)
    builder.torque("held", "arm.hinge", "-5 * yaw - 0.3 * yaw_dot + 2 * e * x_dot", reaction="base.next")
    builder.torque("turned", "base.hinge", "3 * pitch + 0.2 * yaw * pitch_dot - 4 * x + e_dot")
    functions = {"condensed", "closure", "velocities", "residual_jacobian"}
    model = build(builder.build(), frozenset(functions))
    (state,), n, h = random_states(model, 1), len(model.q_i), 1e-5
    a = np.linspace(-1.0, 1.0, n)

    def residual(step: Array, change: Array) -> Array:
        at = make_state(model, turned_place(model, state, step), state.q_i_dot + change, state.t, state.q)
        out = evaluate(model, "condensed", **at.values())
        return np.asarray(out["Q_hat"] - out["M_hat"].reshape(n, n) @ a)

    found, none = evaluate(model, "residual_jacobian", **state.values(), q_i_ddot=a), np.zeros(n)
    J_q = np.array([residual(unit, none) - residual(-unit, none) for unit in h * np.eye(n)]).T / (2 * h)
    J_v = np.array([residual(none, unit) - residual(none, -unit) for unit in h * np.eye(n)]).T / (2 * h)
    assert relative_error(found["J_q"].reshape(n, n), J_q) < 1e-7
    assert relative_error(found["J_v"].reshape(n, n), J_v) < 1e-7


@pytest.mark.parametrize(
    "change, item, problem",
    [
        (lambda b: b.independent("body.theta1"), "partition.independent[0]", "at the start and in results only"),
        (lambda b: b.initial({"body.theta1": 1.0, "body.e1": 0.5}), "initial.coordinates['body.theta1']", "body.e1"),
        (lambda b: b.rates({"body.theta1": 1.0, "body.omega_x": 1.0}), "initial.rates['body.theta1']", "omega_x"),
    ],
)
def test_what_angles_cannot_be(change: Callable[[Any], Any], item: str, problem: str) -> None:
    with pytest.raises(SceneError) as caught:
        change(free("zyx", {}, {})).build()
    assert caught.value.item == item and problem in caught.value.problem and caught.value.remedy
