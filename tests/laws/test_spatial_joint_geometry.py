"""What joints in space hold: positions, rotations and prescribed turns, measured from the bodies' frames."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from runtime import simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial.twin_flexible_nodes import scattered
from tests.support.joint_comb import MORE, OTHERS, PLACING, comb, rigid
from tests.support.model_values import Array, State
from tests.support.spatial_motion import Frame, assembled, frames

Build = Callable[[SceneRecord, frozenset[str] | None], Model]
FULL = frozenset({"constraints", "augmented", "reactions"})


def relative_pose(scene: SceneRecord, moving: dict[str, Frame], kind: str) -> tuple[Array, Array]:
    """r_b - r_a in the axes of marker a, and the rotation from a to b; markers turn by exact rotations (1, psi / 2)."""
    ends = []
    for name, label in (("base", f"at_{kind}"), (kind, "at")):
        frame, marker = moving[name], scene.body(name).markers[label]
        z, x = np.array(marker.axis, dtype=float), np.array(marker.x_axis, dtype=float)
        z = z / np.linalg.norm(z)
        x = x - (x @ z) * z
        x = x / np.linalg.norm(x)
        axes, place = np.column_stack([x, np.cross(z, x), z]), np.array(marker.position, dtype=float)
        if frame.q_f.size:
            psi = np.array(marker.rotation, dtype=float) @ frame.q_f
            axes = Rotation.from_quat([*psi / 2, 1.0]).as_matrix() @ axes
            place = place + np.array(marker.shape, dtype=float) @ frame.q_f
        ends.append((frame.R + frame.A @ place, frame.A @ axes))
    (r_a, A_a), (r_b, A_b) = ends
    return A_a.T @ (r_b - r_a), A_a.T @ A_b


def near_start(model: Model, seed: int) -> State:
    rng, n = np.random.default_rng(seed), len(model.coordinates)
    return assembled(model, model.initial_q + 0.5 * rng.uniform(-1, 1, n), rng.uniform(-1, 1, n), 0.9)


@pytest.mark.long
def test_joints_hold_what_they_say(build: Build) -> None:
    """Relative position and rotation of the markers of every joint type, and its coordinates at a large deformation."""

    def turn(axis: str, angle: float) -> Array:
        return Rotation.from_euler(axis, angle).as_matrix()

    for types in (PLACING, OTHERS):
        scene = comb(types, psi=2.0)
        model = build(scene, FULL)
        state = near_start(model, 3)
        moving = frames(scene, state.q, state.q_dot, 0 * state.q)
        at = dict(zip(model.coordinates, state.q, strict=True))
        pose = {kind: relative_pose(scene, moving, kind) for kind in types}
        for kind, (d, A) in pose.items():
            assert np.max(np.abs(A.T @ A - np.eye(3))) < 1e-12
            own = {name.partition(".")[2]: value for name, value in at.items() if name.startswith(f"j_{kind}.")}
            angle, travel, zero = own.get("angle", 0.0), own.get("travel", 0.0), np.zeros(3)
            lead = MORE["screw"]["lead"]
            expected = {
                "revolute": (zero, turn("z", angle)),
                "prismatic": (np.array([0, 0, travel]), np.eye(3)),
                "cylindrical": (np.array([0, 0, travel]), turn("z", angle)),
                "weld": (zero, np.eye(3)),
                "screw": (np.array([0, 0, lead * angle / (2 * np.pi)]), turn("z", angle)),
                "universal": (zero, turn("z", own.get("angle1", 0.0)) @ turn("x", own.get("angle2", 0.0))),
                "planar": (np.array([own.get("x", 0.0), own.get("y", 0.0), 0]), turn("z", angle)),
            }
            if kind in expected:
                assert np.max(np.abs(d - expected[kind][0])) < 1e-11, kind
                assert np.max(np.abs(A - expected[kind][1])) < 1e-11, kind
        if types == OTHERS:
            t = state.t
            assert np.max(np.abs(pose["spherical"][0])) < 1e-11 and np.max(np.abs(pose["point_on_line"][0][:2])) < 1e-11
            assert abs(np.linalg.norm(pose["distance"][0]) - MORE["distance"]["length"]) < 1e-11
            assert abs(pose["prescribed_displacement"][0][2] - (0.3 + 0.2 * np.sin(2 * t))) < 1e-11
            A = pose["prescribed_angle"][1]
            gap = np.arctan2(A[1, 0], A[0, 0]) - (0.4 + 0.7 * t + np.sin(3 * t) / 5)
            assert abs(np.sin(gap)) < 1e-11


@pytest.mark.parametrize("kind", ["euler_parameters", "zyx"])
def test_prescribed_angle_over_many_turns(build: Build, kind: str) -> None:
    """Eight turns of a driven hinge, as the joint's own coordinate and as an Euler angle that is read off."""
    builder = Scene("driven", space="spatial").gravity(0, 0, -9.81)
    builder.rigid(
        "arm",
        **rigid(scattered(5, 0, seed=2)),
        orientation=kind,
        markers={"tip": {"position": [1, 0, 0], "axis": [0, 1, 0]}},
    )
    builder.rigid("rod", **rigid(scattered(5, 0, seed=3)), orientation=kind, markers={"top": {"axis": [0, 1, 0]}})
    builder.revolute("hinge", "ground.origin", "arm.origin").revolute("swing", "arm.tip", "rod.top")
    builder.prescribed_angle("drive", "ground.origin", "arm.origin", motion="50*t")
    model = build(builder.build(), None)
    solution = simulate(model, t_end=1.0, dt=1e-3, scheme="single_rate", seen_every=0.01, engine="interpreted")
    assert solution.status.ok
    for name in ("hinge.angle", *(["arm.theta1"] if kind == "zyx" else [])):
        np.testing.assert_allclose(np.unwrap(solution[name]), 50 * solution.t, rtol=0, atol=1e-11)
    assert np.max(solution.constraint_error) < 1e-11
