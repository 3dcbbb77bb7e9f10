"""Runs whose error was not asked for: resumed, they are the uninterrupted run, bit for bit, by every scheme."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import SCHEMES, Model, Sampled, resume, simulate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
ENDS = {
    "friction": {"friction": {"coulomb": 2.0, "breakaway": 3.0, "stribeck_velocity": 0.3}},
    "stop": {"limits": {"upper": 0.3, "restitution": 0.5}},
    "both": {"friction": {"coulomb": 2.0}, "limits": {"lower": -0.1, "upper": 0.3, "restitution": 0.5}},
}


def pushed(**ends: object) -> Scene:
    """A block that is pushed to and fro, and by a controller."""
    scene = Scene("pushed").input("u", 0.0, "N").rigid("block", mass=1.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "block.origin", **ends)
    scene.force("push", "block.origin", "12 * sin(6 * t) + u", 0.0).measure("speed", "coordinate", of="block.x")
    return scene.simulation(t_end=0.6, dt=1e-3, scheme="rk4")


def damping(t: float, seen: np.ndarray, memory: np.ndarray) -> float:
    """By the mean rate of the last two looks."""
    found = -2.0 * (seen[0] + memory[0]) / 2
    memory[0] = seen[0]
    return float(found)


@pytest.mark.parametrize(
    ("ends", "scheme"),
    [
        ("both", "rk4"),
        *(pytest.param(ends, scheme, marks=pytest.mark.long) for ends in ENDS for scheme in SCHEMES),
    ],
)
def test_a_run_without_error_goes_on_from_its_checkpoint(
    model_of: Build, tmp_path: Path, ends: str, scheme: str
) -> None:
    """Its events, inputs, modes and states; that its error was not asked for is known, too."""
    model, file = model_of(pushed(**ENDS[ends]).build()), tmp_path / "kept.npz"
    inputs = {"u": Sampled(damping, every=0.02, reads=["block.x_dot"], memory=[0.0])}
    plan = {"t_end": 0.6, "scheme": scheme, "dt": 1e-3, "error": "off", "inputs": inputs}
    whole = simulate(model, **plan, checkpoint=file, checkpoint_every=37)
    assert whole.status.name == "completed" and {"mode", "impact"} & {one.kind for one in whole.events}
    found = resume(model, file, inputs=inputs)
    assert np.array_equal(found.q, whole.q) and np.array_equal(found.q_dot, whole.q_dot)
    assert [str(one) for one in found.events] == [str(one) for one in whole.events]
    assert np.array_equal(found["u"], whole["u"]) and found.status == whole.status
    assert found.error.reason == whole.error.reason == "it was switched off"
