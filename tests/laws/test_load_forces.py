"""What loads do at their markers, against closed forms and against the motion that they cause."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime import simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


def test_a_torque_over_time_and_a_spring(built_in: Load) -> None:
    """The hub's motor is 10 sin(pi t); a spring pulls with k (l - l_0) along its line."""
    run = simulate(built_in("hub_beam"), t_end=0.2)
    motor = run.load_force("motor")
    np.testing.assert_allclose(motor[:, 2], 10 * np.sin(np.pi * run.t), rtol=1e-12, atol=1e-12)
    assert not motor[:, :2].any() and np.array_equal(run["load.motor.moment [N m]"], motor[:, 2])
    run = simulate(built_in("elastic_pendulum"), t_end=0.5)
    p = {entry.name: value for entry, value in zip(run.model.parameters, run.parameters, strict=True)}
    r = np.column_stack([run["bob.x"], run["bob.y"]])
    length = np.linalg.norm(r, axis=1)
    pull = p["spring.stiffness"] * (length - p["spring.free_length"]) + p["spring.damping"] * run["stretch_dot"]
    np.testing.assert_allclose(run.load_force("spring")[:, :2], -(pull / length)[:, None] * r, rtol=1e-9, atol=1e-9)


def test_a_bushing_moves_a_free_body_as_newton_and_euler_say(model_of: Build) -> None:
    """m r'' = F and J omega' + omega x J omega = M about the centre of mass, at any turn and spin."""
    J = np.diag([0.02, 0.03, 0.05])
    scene = (
        Scene("mount", space="spatial")
        .ground(markers={"seat": {"axis": [0.2, 0.3, 1.0]}})
        .rigid("block", mass=2.0, inertia=list(np.diag(J)), orientation="zyx", free=True)
        .bushing("mount", "ground.seat", "block.origin", stiffness=[800, 500, 900], damping=[3, 2, 1],
                 rotational_stiffness=[4, 6, 5], rotational_damping=[0.02, 0.01, 0.03])
        .initial({"block.x": 0.03, "block.z": -0.02, "block.theta1": 0.7, "block.theta2": -0.4, "block.theta3": 0.5})
            .rates({"block.x": 0.4, "block.theta1": 2.0, "block.theta2": -1.0, "block.theta3": 3.0})
        .simulation(t_end=0.02, dt=1e-4, scheme="rk4").build()
    )  # fmt: skip
    run = simulate(model_of(scene), seen_every=0.0)
    force, moment = np.split(run.load_force("mount"), 2, axis=1)
    a = np.column_stack([run.acceleration(f"block.{axis}") for axis in "xyz"])
    np.testing.assert_allclose(force, 2.0 * a, rtol=1e-9, atol=1e-9)
    A = rotations(*(run[f"block.theta{k}"] for k in (1, 2, 3)))
    momentum = np.einsum("tij,jk,tlk,tl->ti", A, J, A, spins(A, run.t))  # A J A^T omega, in the world
    rate = np.gradient(momentum, run.t, axis=0, edge_order=2)[2:-2]
    np.testing.assert_allclose(moment[2:-2], rate, atol=2e-4 * np.abs(moment).max())


def rotations(first: np.ndarray, second: np.ndarray, third: np.ndarray) -> np.ndarray:
    """(N, 3, 3) about z, then the moving y, then the moving x."""

    def about(axis: int, angle: np.ndarray) -> np.ndarray:
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn = np.tile(np.eye(3), (len(angle), 1, 1))
        turn[:, i, i] = turn[:, j, j] = np.cos(angle)
        turn[:, j, i] = np.sin(angle)
        turn[:, i, j] = -turn[:, j, i]
        return turn

    return np.asarray(about(2, first) @ about(1, second) @ about(0, third))


def spins(A: np.ndarray, t: np.ndarray) -> np.ndarray:
    """(N, 3) the angular velocity in the world, from A' A^T by differences."""
    W = np.gradient(A, t, axis=0, edge_order=2) @ np.swapaxes(A, 1, 2)
    return np.stack([W[:, 2, 1] - W[:, 1, 2], W[:, 0, 2] - W[:, 2, 0], W[:, 1, 0] - W[:, 0, 1]], axis=1) / 2


def test_turning_springs_act_about_their_hinge(model_of: Build) -> None:
    """A pendulum on a skew hinge: the spring's moment is along the hinge and k (angle - free angle) large, on b."""
    builder = Scene("flap", space="spatial")
    builder.ground(markers={"axle": {"axis": [0.0, 1.0, 1.0]}})
    builder.rigid("flap", mass=1.0, inertia=[0.02, 0.02, 0.01], markers={"axle": {"axis": [0.0, 1.0, 1.0]}})
    builder.joint("revolute", "hinge", "ground.axle", "flap.axle")
    builder.rotational_spring_damper("spring", "ground.axle", "flap.axle", stiffness=3.0, damping=0.1, free_angle=0.2)
    builder.initial({"hinge.angle": 0.7})
    run = simulate(model_of(builder.simulation(t_end=0.1, dt=1e-3, scheme="rk4").build()))
    size = -3.0 * (run["hinge.angle"] - 0.2) - 0.1 * run.rate("hinge.angle")
    along = np.array([0.0, 1.0, 1.0]) / np.sqrt(2)
    np.testing.assert_allclose(run.load_force("spring"), np.outer(size, np.append(np.zeros(3), along)), atol=1e-12)
    # about the hinge: I theta'' = moment, with the inertia 0.5 (0.02 + 0.01) about the axis
    np.testing.assert_allclose(run.acceleration("hinge.angle") * 0.015, size, rtol=1e-9)
