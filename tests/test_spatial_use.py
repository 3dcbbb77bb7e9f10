"""What someone who models a spatial mechanism for the first time runs into: measures, rates, placement, messages."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.solution import Solution
from symgen.generate import generate
from symgen.scene import SceneBuilder, SceneError


def builder() -> SceneBuilder:
    return SceneBuilder("use", space="spatial")


def run(scene: SceneBuilder, folder: Path, t_end: float, dt: float) -> Solution:
    return simulate(load_model(generate(scene.build(), folder / "use")), t_end=t_end, dt=dt, scheme="single_rate",
                    engine="interpreted")


def test_a_controller_reads_the_angle_of_a_hinge_over_full_turns(tmp_path: Path) -> None:
    """The measure is the hinge's own angle: a wrapped one would throw the controller off after half a turn."""
    scene = (builder().rigid("wheel", mass=1.0, inertia=[0.1, 0.1, 0.1])
             .revolute("hinge", "ground.origin", "wheel.origin")
             .measure("turned", "angle", "wheel.origin", "ground.origin")
             .torque("motor", "wheel.origin", "5 * (10 * t - turned) + 10 - turned_dot"))
    found = run(scene, tmp_path, 3.0, 1e-3)
    assert found["hinge.angle"][-1] == pytest.approx(30.0, abs=1e-4)
    assert np.array_equal(found["turned"], found["hinge.angle"])


def test_a_body_on_a_rod_exchanges_the_angle_that_no_longer_changes_the_length(tmp_path: Path) -> None:
    """Where rod and arm come to lie in line every lever arm is zero there: the mechanism's size is that elsewhere."""
    scene = (builder().gravity(0, 0, -9.81)
             .rigid("bob", mass=2.0, inertia=[0.1, 0.2, 0.3], markers={"eye": {"position": [0, 0, 0.5]}})
             .distance("rod", "ground.origin", "bob.eye", length=1.0).initial({"bob.x": 1.0}))
    found = run(scene, tmp_path, 1.0, 1e-3)
    assert found.status.name == "completed"
    assert [event.kind for event in found.events] == ["repartition"]
    assert np.abs(found.energy_balance()).max() < 0.05
    assert found.constraint_error.max() < 1e-10
