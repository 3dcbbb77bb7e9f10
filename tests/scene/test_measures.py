"""Measures by expression, in the axes of a marker, and of the forces of loads, against what they stand for."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.model import Model
from symgen.scene import Scene, SceneError, SceneRecord

Build = Callable[[SceneRecord], Model]


def arm(space: str = "planar") -> Scene:
    """A hub that a torque turns, a rod on it, a spring from its tip to the ground."""
    tip, inertia = ([0.5, 0.1], 0.05) if space == "planar" else ([0.5, 0.1, 0.2], [0.05, 0.06, 0.07])
    scene = Scene("measured_arm", space=space).parameter("k", 3.0).input("u", 0.2)
    end = {"end": {"position": [0.4, 0.0, 0.0][: len(tip)]}}
    scene.rigid("hub", mass=2.0, inertia=inertia, markers=end)
    scene.rigid("rod", mass=1.0, inertia=inertia, markers={"tip": {"position": tip}})
    scene.revolute("h", "ground.origin", "hub.origin", damping=0.1).revolute("j", "hub.end", "rod.origin")
    scene.torque("drive", "hub.origin", "0.3 * sin(5 * t)")
    scene.spring_damper("spring", "ground.origin", "rod.tip", stiffness=20.0, damping=0.4, free_length=0.2)
    scene.rotational_spring_damper("coil", "hub.origin", "rod.origin", stiffness=2.0, damping=0.1, free_angle=0.3)
    return scene.simulation(t_end=0.4, dt=1e-3, scheme="rk4")


def test_expressions_of_the_motion(model_of: Build) -> None:
    """Coordinates, rates, inputs, parameters, t, other measures; rates where there are no rates in it."""
    scene = arm().initial({"rod.theta": 0.3}).measure("x", "x", of="rod.tip")
    scene.measure("power", "expression", "0.3 * sin(5 * t) * hub.theta_dot", unit="W")
    scene.measure("lift", "expression", "x - k * cos(rod.theta) + t * x", unit="m")
    scene.measure("speed", "expression", "2 * lift_dot + u", unit="m/s")
    run = model_of(scene.build()).simulate()
    t, power = run.t, 0.3 * np.sin(5 * run.t) * run["hub.theta_dot"]
    np.testing.assert_allclose(run["power"], power, rtol=1e-13)
    np.testing.assert_allclose(run["lift"], run["x"] * (1 + t) - 3 * np.cos(run["rod.theta"]), rtol=1e-13)
    rate = run["x_dot"] * (1 + t) + run["x"] + 3 * np.sin(run["rod.theta"]) * run["rod.theta_dot"]
    np.testing.assert_allclose(run["lift_dot"], rate, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(run["speed"], 2 * rate + 0.2, rtol=1e-12, atol=1e-13)
    assert "power_dot" not in run.model.measures and "speed_dot" not in run.model.measures
    units = {entry.name: (entry.unit, entry.about) for entry in run.model.description.measures}
    assert units["power"] == ("W", "0.3 * sin(5 * t) * hub.theta_dot") and units["lift_dot"][0] == "m/s"


def test_the_work_of_a_measured_power_is_the_energy(model_of: Build) -> None:
    """What a torque puts in is what the arm has and what its dampers took: an independent sum."""
    scene = arm().measure("M", "moment", "drive").measure("power", "expression", "M * hub.theta_dot", unit="W")
    run = model_of(scene.build()).simulate()
    np.testing.assert_allclose(run["power"], run.energy["power_applied"], rtol=1e-12, atol=1e-15)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_components_in_the_axes_of_a_marker(space: str, model_of: Build) -> None:
    """The tip as the hub sees it: by a rotation by hand about z, through both hinges."""
    scene = arm(space).initial({"rod.theta": 0.3} if space == "planar" else {})
    for axis in "xy":
        scene.measure(f"in_{axis}", axis, of="rod.tip", relative_to="hub.origin", axes="hub.origin")
        scene.measure(f"at_{axis}", axis, of="rod.tip", relative_to="hub.origin")
    scene.measure("phi", "angle", of="hub.origin")
    run = model_of(scene.build()).simulate()
    cosine, sine = np.cos(run["phi"]), np.sin(run["phi"])
    np.testing.assert_allclose(run["in_x"], cosine * run["at_x"] + sine * run["at_y"], atol=1e-14)
    np.testing.assert_allclose(run["in_y"], cosine * run["at_y"] - sine * run["at_x"], atol=1e-14)
    slope = np.gradient(run["in_y"], run.t, edge_order=2)[1:-1]
    assert np.abs(run["in_y_dot"][1:-1] - slope).max() < 1e-4 * np.abs(slope).max()
    notes = {entry.name: entry.about for entry in run.model.description.measures}
    assert notes["in_x"] == "x from hub.origin to rod.tip in the axes of hub.origin" and notes["at_x"] == ""


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_forces_of_loads(space: str, model_of: Build) -> None:
    """A spring by its law, a coil by its own, components against the force that results have in world axes."""
    scene = arm(space).measure("l", "distance", of="rod.tip").measure("turn", "angle", "rod.origin", "hub.origin")
    scene.measure("pull", "force", "spring").measure("M", "moment", "coil")
    scene.measure("across", "force", "spring", component="y", axes="rod.tip")
    scene.measure("along_x", "force", "spring", component="x").measure("phi", "angle", of="rod.origin")
    run = model_of(scene.build()).simulate()
    np.testing.assert_allclose(run["pull"], 20 * (run["l"] - 0.2) + 0.4 * run["l_dot"], rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(run["M"], -2 * (run["turn"] - 0.3) - 0.1 * run["turn_dot"], rtol=1e-12, atol=1e-13)
    force = run.load_force("spring")
    np.testing.assert_allclose(run["along_x"], force[:, 0], rtol=1e-13)
    across = np.cos(run["phi"]) * force[:, 1] - np.sin(run["phi"]) * force[:, 0]
    np.testing.assert_allclose(run["across"], across, rtol=1e-11, atol=1e-12)


def test_forces_of_efforts_lines_and_springs_without_length(model_of: Build) -> None:
    """An effort is its expression; a line what it pulls with; a spring of no free length k l + c l'."""
    scene = Scene("pulled", gravity=(0.0, 0.0)).rigid("b", mass=1.0, inertia=1.0)
    scene.prismatic("rail", "ground.origin", "b.origin").initial({"b.x": 0.3})
    scene.effort("motor", "rail.travel", "2 - t").line("rope", "ground.origin", "b.origin", "5 * length + rate")
    scene.spring_damper("spring", "ground.origin", "b.origin", stiffness=7.0, damping=2.0)
    for name in ("motor", "rope", "spring"):
        scene.measure(f"F_{name}", "force", name)
    run = model_of(scene.simulation(t_end=0.2, dt=1e-3, scheme="rk4").build()).simulate()
    x, v = run["b.x"], run["b.x_dot"]
    np.testing.assert_allclose(run["F_motor"], 2 - run.t, rtol=1e-14)
    np.testing.assert_allclose(run["F_rope"], 5 * x + v, rtol=1e-12)
    np.testing.assert_allclose(run["F_spring"], 7 * x + 2 * v, rtol=1e-12)
    acceleration = run["F_motor"] - run["F_rope"] - run["F_spring"]
    np.testing.assert_allclose(run["b.x_ddot"], acceleration, rtol=1e-11, atol=1e-12)


def test_a_load_by_a_measure_is_the_load_by_its_expression(model_of: Build) -> None:
    """Jumps and kinks within a measure end steps where those of the load itself do."""
    law = "where(b.x < 0.5, 3, -1) - 0.2 * abs(b.x_dot - 1)"
    runs = []
    for text in (law.replace("b.x_dot", "x_dot").replace("b.x", "x"), "push + 0"):
        scene = Scene("jumps").rigid("b", mass=1.0, inertia=1.0).prismatic("rail", "ground.origin", "b.origin")
        scene.measure("x", "x", of="b.origin").measure("push", "expression", law, unit="N")
        scene.effort("motor", "rail.travel", text).simulation(t_end=2.0, dt=0.01, scheme="rk4")
        runs.append(model_of(scene.build()).simulate())
    assert len(runs[0].model.description.kinks) == len(runs[1].model.description.kinks) == 2
    np.testing.assert_allclose(runs[1].q[-1], runs[0].q[-1], rtol=1e-12)
    np.testing.assert_allclose(
        runs[0]["push"], np.where(runs[0]["b.x"] < 0.5, 3, -1) - 0.2 * np.abs(runs[0]["b.x_dot"] - 1)
    )


def test_what_a_drive_takes_is_a_column(model_of: Build) -> None:
    """J theta'' of a driven wheel, among the outputs that studies take."""
    scene = Scene("driven").rigid("wheel", mass=1.0, inertia=0.1)
    scene.prescribed_angle("drive", "ground.origin", "wheel.origin", "2 * t + sin(t)")
    run = model_of(scene.simulation(t_end=0.2, dt=1e-3, scheme="rk4").build()).simulate()
    np.testing.assert_allclose(run["drive.motor"], -0.1 * np.sin(run.t), atol=1e-13)


@pytest.mark.parametrize(
    "name, measure, text",
    [
        (
            "p",
            ("expression", "hub.thta_dot"),
            r"measures\[0\] 'p'.of: there is no coordinate 'hub.thta_dot'.*'hub.theta",
        ),
        ("p", ("expression", "2 * p"), "uses itself"),
        ("p", ("expression", "q + 1"), "unknown name 'q'"),
        ("p", ("expression", "__import__('os')"), "not allowed"),
        ("p", ("force", "sprin"), "there is no load 'sprin'.*did you mean 'spring'"),
        ("p", ("force", "h"), r"the force of 'h' follows from accelerations.*run.joint_force\('h'\)"),
        ("p", ("force", "drive"), "the torque 'drive' has a moment only; take \"moment\""),
        ("p", ("moment", "spring"), 'has a force only; take "force"'),
    ],
)
def test_refusals(name: str, measure: tuple[str, str], text: str) -> None:
    """Names the measure, what is wrong, what to do."""
    with pytest.raises(SceneError, match=text):
        arm().measure(name, *measure).build()


def test_further_refusals() -> None:
    """Axes of what has none, components that are not there, uses before they are known."""
    with pytest.raises(SceneError, match="the distance is the same in all axes"):
        arm().measure("l", "distance", of="rod.tip", axes="hub.origin").build()
    with pytest.raises(SceneError, match="body 'hub' has no marker 'orgin'"):
        arm().measure("l", "x", of="rod.tip", axes="hub.orgin").build()
    with pytest.raises(SceneError, match='does not name a marker; write "world"'):
        arm().measure("l", "x", of="rod.tip", axes="hub").build()
    with pytest.raises(SceneError, match="in a planar scene forces have x and y"):
        arm().measure("F", "force", "spring", component="z").build()
    with pytest.raises(SceneError, match="uses 'b', which is declared below it"):
        arm().measure("a", "expression", "b + 1").measure("b", "expression", "t").build()
    with pytest.raises(SceneError, match="uses 'F', a force of a load"):
        arm().measure("F", "force", "spring").torque("brake", "hub.origin", "-F").build()
    with pytest.raises(SceneError, match="'power_dot'"):
        arm().measure("power", "expression", "hub.theta_dot").torque("brake", "hub.origin", "power_dot").model()


@pytest.mark.long
def test_events_and_files_know_them(model_of: Build) -> None:
    """An event at a force; a scene that is written and read again is the same."""
    scene = arm().measure("F", "force", "spring").measure("M", "expression", "F * 0.5", unit="N m")
    scene.event("turned", "M - 3.05", terminal=True)
    record = scene.build()
    assert SceneRecord.from_toml_text(record.to_toml()) == record
    run = model_of(record).simulate()
    assert run.status.name == "event" and run["F"][-1] == pytest.approx(6.1, abs=1e-9)
