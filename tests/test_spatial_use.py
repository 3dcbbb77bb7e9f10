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


def test_a_motor_does_not_turn_what_it_does_not_drive(tmp_path: Path) -> None:
    """Rates left open: those of placed bodies follow, and a free hinge beyond the motor starts at rest."""
    scene = (builder().rigid("a", mass=1.0, inertia=[0.1, 0.1, 0.1]).rigid("b", mass=1.0, inertia=[0.1, 0.1, 0.1])
             .revolute("driven", "ground.origin", "a.origin").revolute("idle", "a.origin", "b.origin")
             .prescribed_angle("motor", "ground.origin", "a.origin", "2 * pi * t"))
    model = load_model(generate(scene.build(), tmp_path / "use"))
    rates = dict(zip(model.coordinates, model.initial_q_dot.tolist(), strict=True))
    assert rates["driven.angle"] == pytest.approx(2 * math.pi, abs=1e-12)
    assert abs(rates["idle.angle"]) < 1e-12
    assert rates["b.e3"] == pytest.approx(math.pi, abs=1e-12)


def test_a_gyroscope_on_a_free_frame_precesses_as_by_hand(tmp_path: Path) -> None:
    """The spin that is prescribed against the frame does not turn the frame; m g l / (I spin) is what is left."""
    spin, arm, moment = 200.0, 0.1, 2e-3
    precession = arm * 9.81 / (moment * spin)
    scene = (builder().gravity(0, 0, -9.81)
             .rigid("frame", mass=0.01, inertia=[1e-5] * 3, markers={"axle": {"axis": [1, 0, 0]}})
             .rigid("rotor", mass=1.0, inertia=[moment, 1e-3, 1e-3], center_of_mass=[arm, 0, 0],
                    markers={"axle": {"axis": [1, 0, 0]}})
             .spherical("pivot", "ground.origin", "frame.origin").revolute("axle", "frame.axle", "rotor.axle")
             .prescribed_angle("drive", "frame.axle", "rotor.axle", f"{spin} * t")
             .rates({"frame.e3": precession / 2}))
    found = run(scene, tmp_path, 0.5, 5e-4)
    turned = 2 * math.atan2(found["frame.e3"][-1], found["frame.e0"][-1])
    assert turned == pytest.approx(precession * 0.5, rel=1e-3)
    assert np.abs(found["frame.e1"]).max() < 1e-2


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
