"""What someone who models a spatial mechanism for the first time runs into: measures, rates, placement, messages."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import Solution, load_model, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.joints import JOINTS
from symgen.pipeline import derive
from symgen.scene import Scene, SceneError, SceneRecord


def builder() -> Scene:
    return Scene("use", space="spatial")


def run(scene: Scene, folder: Path, t_end: float, dt: float) -> Solution:
    return simulate(
        load_model(generate(scene.build(), folder / "use")),
        t_end=t_end,
        dt=dt,
        scheme="single_rate",
        engine="interpreted",
    )


def test_a_controller_reads_the_angle_of_a_hinge_over_full_turns(tmp_path: Path) -> None:
    """The measure is the hinge's own angle: a wrapped one would throw the controller off after half a turn."""
    scene = (
        builder()
        .rigid("wheel", mass=1.0, inertia=[0.1, 0.1, 0.1])
        .revolute("hinge", "ground.origin", "wheel.origin")
        .measure("turned", "angle", "wheel.origin", "ground.origin")
        .torque("motor", "wheel.origin", "5 * (10 * t - turned) + 10 - turned_dot")
    )
    found = run(scene, tmp_path, 3.0, 1e-3)
    assert found["hinge.angle"][-1] == pytest.approx(30.0, abs=1e-4)
    assert np.array_equal(found["turned"], found["hinge.angle"])


def test_a_spring_on_a_hinge_does_not_care_which_marker_is_named_first(tmp_path: Path) -> None:
    """Its angle goes beyond half a turn either way; between -pi and pi it would throw the wheel on."""
    scene = (
        builder()
        .rigid("wheel", mass=1.0, inertia=[0.2, 0.2, 0.3])
        .revolute("hinge", "ground.origin", "wheel.origin")
        .rotational_spring_damper("spring", "wheel.origin", "ground.origin", stiffness=1.0)
        .measure("back", "angle", "ground.origin", "wheel.origin")
        .rates({"hinge.angle": 10.0})
    )
    found = run(scene, tmp_path, 4.0, 1e-3)
    assert np.abs(found["hinge.angle"]).max() == pytest.approx(10 * math.sqrt(0.3), rel=1e-5)
    assert np.array_equal(found["back"], -found["hinge.angle"])


def test_a_motor_does_not_turn_what_it_does_not_drive(tmp_path: Path) -> None:
    """Rates left open: those of placed bodies follow, and a free hinge beyond the motor starts at rest."""
    scene = (
        builder()
        .rigid("a", mass=1.0, inertia=[0.1, 0.1, 0.1])
        .rigid("b", mass=1.0, inertia=[0.1, 0.1, 0.1])
        .revolute("driven", "ground.origin", "a.origin")
        .revolute("idle", "a.origin", "b.origin")
        .prescribed_angle("motor", "ground.origin", "a.origin", "2 * pi * t")
    )
    model = load_model(generate(scene.build(), tmp_path / "use"))
    rates = dict(zip(model.coordinates, model.initial_q_dot.tolist(), strict=True))
    assert rates["driven.angle"] == pytest.approx(2 * math.pi, abs=1e-12)
    assert abs(rates["idle.angle"]) < 1e-12
    assert rates["b.e3"] == pytest.approx(math.pi, abs=1e-12)


def test_a_gyroscope_on_a_free_frame_precesses_as_by_hand(tmp_path: Path) -> None:
    """The spin that is prescribed against the frame does not turn the frame; m g l / (I spin) is what is left."""
    spin, arm, moment = 200.0, 0.1, 2e-3
    precession = arm * 9.81 / (moment * spin)
    scene = (
        builder()
        .gravity(0, 0, -9.81)
        .rigid("frame", mass=0.01, inertia=[1e-5] * 3, markers={"axle": {"axis": [1, 0, 0]}})
        .rigid(
            "rotor",
            mass=1.0,
            inertia=[moment, 1e-3, 1e-3],
            center_of_mass=[arm, 0, 0],
            markers={"axle": {"axis": [1, 0, 0]}},
        )
        .spherical("pivot", "ground.origin", "frame.origin")
        .revolute("axle", "frame.axle", "rotor.axle")
        .prescribed_angle("drive", "frame.axle", "rotor.axle", f"{spin} * t")
        .rates({"frame.e3": precession / 2})
    )
    found = run(scene, tmp_path, 0.5, 5e-4)
    turned = 2 * math.atan2(found["frame.e3"][-1], found["frame.e0"][-1])
    assert turned == pytest.approx(precession * 0.5, rel=1e-3)
    assert np.abs(found["frame.e1"]).max() < 1e-2


@pytest.mark.long
def test_a_body_on_a_rod_exchanges_the_angle_that_no_longer_changes_the_length(tmp_path: Path) -> None:
    """Where rod and arm come to lie in line every lever arm is zero there: the mechanism's size is that elsewhere."""
    scene = (
        builder()
        .gravity(0, 0, -9.81)
        .rigid("bob", mass=2.0, inertia=[0.1, 0.2, 0.3], markers={"eye": {"position": [0, 0, 0.5]}})
        .distance("rod", "ground.origin", "bob.eye", length=1.0)
        .initial({"bob.x": 1.0})
    )
    found = run(scene, tmp_path, 1.0, 1e-3)
    assert found.status.name == "completed"
    assert [event.kind for event in found.events] == ["repartition"]
    assert np.abs(found.energy_balance()).max() < 0.05
    assert found.constraint_error.max() < 1e-10


def pendulum() -> Scene:
    return builder().rigid("rod", mass=1.0, inertia=[0.1, 0.1, 0.1]).revolute("hinge", "ground.origin", "rod.origin")


def door() -> Scene:
    ends = {"low": {"position": [0, 0, 0.3]}, "high": {"position": [0, 0, 1.7]}}
    moved = {"low": ends["low"], "high": {"position": [0.001, 0, 1.7]}}
    return (
        builder()
        .ground(markers=moved)
        .rigid("door", mass=20.0, inertia=[2.0, 3.0, 1.0], markers=ends)
        .revolute("lower", "ground.low", "door.low")
        .revolute("upper", "ground.high", "door.high")
    )


@pytest.mark.parametrize(
    "scene, item, problem, remedy",
    [
        (
            pendulum().torque("motor", "rod.origin", "-hinge.angle"),
            "loads[0] 'motor'.value",
            "'hinge.angle'",
            "measure",
        ),
        (
            builder().rigid("rod", mass=1.0, inertia=np.eye(3), free=True),
            "bodies[0] 'rod'.inertia",
            "matrix",
            "products",
        ),
        (door(), "initial", "lower, upper cannot all be satisfied", "a joint that leaves more free"),
        (
            pendulum()
            .prescribed_angle("p1", "ground.origin", "rod.origin", "t")
            .prescribed_angle("p2", "ground.origin", "rod.origin", "2 * t"),
            "initial",
            "p1, p2 cannot",
            "remove one of",
        ),
    ],
)
def test_a_mistake_is_named_with_its_remedy(tmp_path: Path, scene: Scene, item: str, problem: str, remedy: str) -> None:
    with pytest.raises(SceneError) as caught:
        generate(scene.build(), tmp_path / "bad")
    assert caught.value.item == item
    assert problem in caught.value.problem
    assert remedy in caught.value.remedy


def test_every_joint_has_a_method_of_the_builder() -> None:
    further = {
        "screw": {"lead": 0.1},
        "distance": {"length": 1.0},
        "prescribed_angle": {"motion": "t"},
        "prescribed_displacement": {"motion": "t"},
    }
    girder = {"length": 1.0, "density": 2700.0, "area": 1e-4, "second_moment": 1e-9, "second_moment_z": 1e-9}
    for name, joint in JOINTS.items():
        scene = builder().rigid("a", mass=1.0, inertia=[0.1, 0.1, 0.1])
        scene.beam("b", **girder, youngs_modulus=7e10, lateral={"ends": "pinned-pinned", "modes": 1}, free=True)
        on = "b.start" if joint.on_beam else "ground.origin"
        getattr(scene, name)("link", on, "a.origin", **further.get(name, {}))
        assert scene.build().joints[0].type == name


def test_a_beam_that_is_bent_to_close_a_loop_is_reported(tmp_path: Path) -> None:
    """A rod 0.05 m too short for its place closes by stretching only; nobody gave that deflection."""
    scene = (
        builder()
        .ground(markers={"far": {"position": [1.1, 0, 0]}})
        .beam(
            "rod",
            length=1.0,
            density=2700.0,
            area=1e-4,
            second_moment=1e-9,
            second_moment_z=1e-9,
            youngs_modulus=7e10,
            axial={"ends": "fixed-free", "modes": 1},
            lateral={"ends": "clamped-free", "modes": 1},
        )
        .weld("root", "ground.origin", "rod.start")
        .distance("tip", "ground.far", "rod.end", length=0.05)
    )
    model = load_model(generate(scene.build(), tmp_path / "use"))
    before, after = model.initial_changes["rod.q2"]
    assert before == 0.0 and abs(after) > 0.01


def test_a_measure_reads_a_coordinate(model_of: Callable[[SceneRecord], Model]) -> None:
    """A controller on the second angle of a universal joint: the measure is that coordinate, its rate too."""
    builder = Scene("fork", space="spatial").gravity(0, 0, -9.81)
    builder.rigid("rod", mass=1.0, inertia=[0.1, 0.1, 0.02], center_of_mass=[0, 0, -0.5])
    builder.universal("fork", "ground.origin", "rod.origin").measure("tilt", "coordinate", "fork.angle2")
    builder.force("hold", "rod.center", 0, "2 * tilt + 0.1 * tilt_dot", 0)
    scene = builder.initial({"fork.angle2": 0.3}).simulation(t_end=0.2, dt=1e-3, scheme="rk4").build()
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    solution = simulate(model_of(scene))
    assert np.array_equal(solution["tilt"], solution["fork.angle2"])
    assert np.allclose(solution["tilt_dot"], solution.rate("fork.angle2"))
    with pytest.raises(SceneError, match="tilt.*no coordinate 'fork.angel2'.*fork.angle2"):
        Scene("bad", space="spatial").rigid("rod", mass=1, inertia=[1, 1, 1]).universal(
            "fork", "ground.origin", "rod.origin"
        ).measure("tilt", "coordinate", "fork.angel2").build()


def test_a_straight_cardan_shaft_finds_a_way_to_bend() -> None:
    """At the start given by zeros no small motion closes the loop: the assembly tries joints turned a little."""
    beta = math.radians(30)
    aside = [math.sin(beta), 0, math.cos(beta)]
    builder = Scene("cardan", space="spatial").ground(markers={"outlet": {"position": aside}})
    builder.rigid("near", mass=1, inertia=[1, 1, 1], markers={"fork": {"axis": [1, 0, 0], "x_axis": [0, 0, 1]}})
    builder.rigid(
        "shaft",
        mass=1,
        inertia=[1, 1, 1],
        markers={"near": {"x_axis": [0, 1, 0]}, "far": {"position": [0, 0, 1], "axis": [0, 1, 0], "x_axis": [0, 0, 1]}},
    )
    builder.rigid("far", mass=1, inertia=[1, 1, 1], markers={"fork": {"x_axis": [1, 0, 0]}})
    builder.revolute("inlet", "ground.origin", "near.origin").universal("u1", "near.fork", "shaft.near")
    builder.universal("u2", "shaft.far", "far.fork").cylindrical("outlet", "ground.outlet", "far.origin")
    derived = derive(builder.build(), frozenset({"constraints"}))
    names = derived.system.equations.names
    shaft = derived.initial.q[[names.index(f"far.{axis}") for axis in "xyz"]]
    travel = derived.initial.q[names.index("outlet.travel")]
    assert np.allclose(shaft, np.array(aside) + [0, 0, travel], atol=1e-12)
    assert np.abs(derived.initial.q).max() < math.pi  # turned a little, not round and round
