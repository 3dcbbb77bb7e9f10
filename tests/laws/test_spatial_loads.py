"""Loads on a free body in space against their definitions, by Newton's and Euler's equations."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial.twin_flexible_nodes import scattered
from tests.support.joint_comb import rigid
from tests.support.model_values import augmented_solution, relative_error
from tests.support.spatial_motion import Frame, frames, momentum_rate, place

Build = Callable[[SceneRecord, frozenset[str] | None], Model]
FULL = frozenset({"constraints", "augmented", "reactions"})


def loads_from_outside() -> SceneRecord:
    builder = Scene("pushed", space="spatial")
    builder.ground(markers={"a": {"position": [0.3, -0.2, 0.1], "axis": [1, 1, 0], "x_axis": [0, 0, 1]}})
    builder.rigid(
        "body",
        **rigid(scattered(5, 0, seed=2)),
        orientation="xyz",
        free=True,
        markers={"m": {"position": [0.2, 0.5, -0.3], "axis": [1, -1, 2], "x_axis": [1, 1, 0]}},
    )
    return builder.force("world", "body.m", 1.0, -2.0, "3 + t").build()


A_GROUND = np.column_stack([[0, 0, 1], np.array([1, -1, 0]) / math.sqrt(2), np.array([1, 1, 0]) / math.sqrt(2)])
M_BODY = np.column_stack(
    [np.array([1, 1, 0]) / math.sqrt(2), np.array([-1, 1, 1]) / math.sqrt(3), np.array([1, -1, 2]) / math.sqrt(6)]
)
LOADS: dict[str, dict[str, Any]] = {
    "force": {"type": "force", "marker": "body.m", "components": [1.0, -2.0, "3 + t"]},
    "own force": {"type": "force", "marker": "body.m", "components": [1.0, -2.0, "3 + t"], "frame": "body"},
    "torque": {"type": "torque", "marker": "body.m", "value": "2 + t"},
    "spring": {
        "type": "spring_damper",
        "marker_a": "ground.a",
        "marker_b": "body.m",
        "stiffness": 7.0,
        "damping": 0.4,
        "free_length": 0.3,
    },
    "bushing": {
        "type": "bushing",
        "marker_a": "ground.a",
        "marker_b": "body.m",
        "stiffness": [3, 4, 5],
        "damping": [0.1, 0.2, 0.3],
        "rotational_stiffness": [6, 7, 8],
        "rotational_damping": [0.4, 0.5, 0.6],
    },
}


@pytest.mark.parametrize("kind", LOADS)
def test_loads_push_as_they_say(build: Build, kind: str) -> None:
    """Force and moment on a free body against the load's definition; a bushing's rotation is small here (1e-7)."""
    data = loads_from_outside().to_dict()
    data["loads"] = [{"name": "load", **LOADS[kind]}]
    scene, t = SceneRecord.from_dict(data), 0.4
    model = build(scene, FULL)
    rng, tiny = np.random.default_rng(1), 1e-7
    A = A_GROUND @ Rotation.from_rotvec(tiny * np.array([1.0, 2.0, -3.0])).as_matrix() @ M_BODY.T
    A = A if kind == "bushing" else Rotation.from_rotvec([0.3, 0.9, -0.5]).as_matrix()
    R, v, omega = rng.normal(size=(3, 3))
    omega = tiny * omega if kind == "bushing" else omega
    state = place(scene, model, {"body": Frame(R, A, v, omega, v, v, *[np.zeros(0)] * 3)}, t)
    frame = frames(scene, state.q, state.q_dot, augmented_solution(model, state)[0])["body"]
    rate = momentum_rate(scattered(5, 0, seed=2), frame)
    arm = A @ np.array([0.2, 0.5, -0.3])
    d, d_dot = R + arm - np.array([0.3, -0.2, 0.1]), v + np.cross(omega, arm)
    length = np.linalg.norm(d)
    along = A_GROUND.T @ d, A_GROUND.T @ d_dot
    force = {
        "force": np.array([1.0, -2.0, 3 + t]),
        "own force": A @ M_BODY @ [1.0, -2.0, 3 + t],
        "torque": np.zeros(3),
        "spring": -(7.0 * (length - 0.3) + 0.4 * d @ d_dot / length) * d / length,
        "bushing": -A_GROUND @ (np.array([3, 4, 5]) * along[0] + np.array([0.1, 0.2, 0.3]) * along[1]),
    }[kind]
    moment = {
        "torque": (2 + t) * A @ M_BODY[:, 2],
        "bushing": -A_GROUND
        @ (np.array([6, 7, 8]) * tiny * np.array([1.0, 2.0, -3.0]) + np.array([0.4, 0.5, 0.6]) * (A_GROUND.T @ omega)),
    }
    assert relative_error(rate.linear, force) < 1e-11 if np.any(force) else np.max(np.abs(rate.linear)) < 1e-12
    turning = rate.angular - np.cross(R + arm, rate.linear)
    expected = moment.get(kind, np.zeros(3))
    assert np.max(np.abs(turning - expected)) < (1e-13 if kind == "bushing" else 1e-11)
