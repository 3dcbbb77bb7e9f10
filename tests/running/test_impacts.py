"""Forces of what pushes and never pulls, and the table of impacts: against momentum, energy and closed forms."""

from __future__ import annotations

import csv
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import Model, ensemble
from symgen import SceneError
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def block(**stop: Any) -> Scene:
    """2 kg on a rail that come with 1 m/s upon a stop at 0.2 m."""
    scene = Scene("block").rigid("block", mass=2.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "block.origin", limits={"lower": -0.5, "upper": 0.2, **stop})
    return scene.rates({"block.x": 1.0}).simulation(t_end=0.6)


def test_an_elastic_stop_by_hand(model_of: Build) -> None:
    """Half a period of sqrt(m / k): F = -v sqrt(k m) sin, the speed turns, the impulse is 2 m v."""
    scene = block(stiffness=2e4).measure("push", "force", "rail").event("hard", "push + 100")
    run = model_of(scene.build()).simulate(seen_every=1e-4, tolerance=1e-8)
    (hit,) = run.impacts()
    assert (hit.where, hit.side) == ("rail.stop", -1)
    assert hit.time == pytest.approx(0.2, abs=1e-6)
    assert hit.duration == pytest.approx(pi / 100, rel=1e-4)
    assert [hit.speed_before, hit.speed_after] == pytest.approx([1.0, 1.0], abs=1e-7)
    assert hit.impulse == pytest.approx(4.0, rel=1e-7)
    assert hit.energy_lost == pytest.approx(0.0, abs=1e-7)
    assert run["push"].min() == pytest.approx(-200.0, rel=1e-4)
    np.testing.assert_array_equal(run["push"], run["rail.stop_force"])
    rising = 0.2 + np.arcsin(0.5) / 100
    assert [one.time for one in run.events] == pytest.approx([rising, 0.4 + pi / 100 - rising], abs=1e-8)
    stop = run.stop("rail")
    np.testing.assert_array_equal(stop.force, run["push"])
    assert stop.impulses == pytest.approx(np.array([[0.2, -4.0]]), abs=1e-6)
    assert stop.at_rest == pytest.approx(pi / 100, abs=3e-4)


@pytest.mark.parametrize("spacing", [1e-4, 1e-3])
def test_a_damped_stop_by_its_momentum_and_energy(model_of: Build, spacing: float) -> None:
    run = model_of(block(stiffness=1e4, damping=0.5, exponent=1.5).build()).simulate(seen_every=spacing, t_end=0.45)
    (hit,) = run.impacts()
    end = float(run["block.x_dot"][-1])
    assert hit.speed_after == pytest.approx(-end, rel=1e-6)
    assert hit.impulse == pytest.approx(2.0 * (1.0 - end), rel=1e-3)
    assert hit.energy_lost == pytest.approx(1.0 - end**2, rel=1e-3)


def test_what_has_too_few_samples_is_not_told(model_of: Build) -> None:
    run = model_of(block(stiffness=1e6).build()).simulate(seen_every=1e-3)
    assert [np.isnan(hit.impulse) and np.isnan(hit.energy_lost) for hit in run.impacts()] == [True]


def test_a_rigid_stop_by_hand_and_its_file(model_of: Build, tmp_path: Path) -> None:
    """Restitution 1/2: 3/4 and 3/16 of 1 J; saved and loaded, too."""
    run = model_of(block(restitution=0.5).build()).simulate(t_end=2.0)
    table = run.impacts()
    assert [one.where for one in table] == ["rail.limits.upper", "rail.limits.lower"]
    wanted = {
        "time": [0.2, 1.6], "side": [-1, 1], "speed_before": [1.0, 0.5], "speed_after": [0.5, 0.25],
        "impulse": [3.0, 1.5], "energy_lost": [0.75, 0.1875], "duration": [0.0, 0.0],
    }  # fmt: skip
    for name, values in wanted.items():
        assert table.columns[name] == pytest.approx(values, abs=1e-9)
    assert repr(table) == "<2 impacts, 0.9375 J lost>"
    table.write_csv(tmp_path / "impacts.csv")
    rows = list(csv.DictReader((tmp_path / "impacts.csv").read_text(encoding="utf-8").splitlines()))
    assert [float(row["impulse"]) for row in rows] == [one.impulse for one in table]


def test_impacts_at_one_time_lose_what_the_motion_loses(model_of: Build) -> None:
    """Two blocks on one rail that strike stops and each other: the sum is the change of kinetic energy."""
    scene = Scene("row").rigid("a", mass=1.0, inertia=0.1).rigid("b", mass=3.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "a.origin", limits={"lower": 0.0, "upper": 1.0, "restitution": 0.6})
    scene.prismatic("gap", "a.origin", "b.origin", limits={"lower": 0.0, "restitution": 0.8})
    scene.initial({"a.x": 0.5, "b.x": 0.9}).rates({"a.x": 1.3, "b.x": -0.7})
    run = model_of(scene.simulation(t_end=3.0).build()).simulate()
    kinetic = [0.5 * run["a.x_dot"][k] ** 2 + 1.5 * run["b.x_dot"][k] ** 2 for k in (0, -1)]
    assert len(run.impacts()) == 3
    assert run.impacts().columns["energy_lost"].sum() == pytest.approx(kinetic[0] - kinetic[1], rel=1e-9)


def test_a_contact_by_its_momentum(model_of: Build) -> None:
    """A ball that falls and slides: normal force, friction mu N, and the upward momentum of each bounce."""
    scene = Scene("ball").gravity(0.0, -9.81).rigid("ball", mass=0.5, inertia=1e3, free=True)
    law = {"stiffness": 1e5, "damping": 0.4, "exponent": 1.5, "friction": 0.3}
    scene.contact("touch", marker="ball.origin", radius=0.1, plane="ground.origin", **law)
    scene.initial({"ball.y": 0.3}).rates({"ball.x": 5.0})
    for part in ("normal", "friction"):
        scene.measure(part, "force", "touch", component=part)
    scene.event("hard", "normal - 50", direction="rising")
    run = model_of(scene.simulation(t_end=0.6).build()).simulate(seen_every=1e-4, tolerance=1e-8)
    np.testing.assert_array_equal(run["normal"], run["touch.normal_force"])
    assert run.load_force("touch")[:, 1] == pytest.approx(run["normal"], abs=1e-9)
    assert run["friction"] == pytest.approx(0.3 * run["normal"], rel=1e-6, abs=1e-9)
    table = run.impacts()
    assert len(table) == len(run.events) >= 2
    for one in table:
        assert one.impulse == pytest.approx(
            0.5 * (one.speed_before + one.speed_after) + 0.5 * 9.81 * one.duration, rel=1e-4
        )
    assert [one.where for one in table] == ["touch.contact"] * len(table)


@pytest.mark.long
def test_play_of_teeth_is_an_output_everywhere(model_of: Build) -> None:
    """The torque of a gear with play is what turns the driven wheel; ensembles and files have it."""
    scene = Scene("mesh").parameter("load", 2.0)
    for name, inertia in (("a", 0.1), ("b", 0.4)):
        scene.rigid(name, mass=1.0, inertia=inertia).revolute(f"hinge_{name}", "ground.origin", f"{name}.origin")
    play = {"gap": 0.01, "stiffness": 500.0, "damping": 0.5}
    scene.gear("teeth", "hinge_a.angle", "hinge_b.angle", ratio=2.0, backlash=play)
    scene.torque("drive", "a.origin", "load*sin(20*t)").measure("tooth", "moment", "teeth")
    model = model_of(scene.simulation(t_end=0.5, dt=1e-3, scheme="rk4").build())
    run = model.simulate()
    np.testing.assert_array_equal(run["tooth"], run["teeth.backlash_force"])
    share = run["b.theta_ddot"] * 0.4 / np.where(run["tooth"] == 0, 1.0, run["tooth"])
    touching = run["tooth"] != 0
    assert touching.any() and not touching.all()
    assert share[touching] == pytest.approx(share[touching][0], rel=1e-9)  # the ratio of the teeth
    assert abs(share[touching][0]) in (pytest.approx(2.0), pytest.approx(0.5))
    found = ensemble(model, {"load": [1.0, 2.0]}, outputs=["teeth.backlash_force"])
    assert np.asarray(found["teeth.backlash_force"])[1, -1] == run["tooth"][-1]
    assert any(name.endswith("teeth.backlash_force") for name in run.columns())
    assert any(str(name).endswith("teeth.backlash_force") for name in run.to_xarray())


@pytest.mark.parametrize(
    ("kind", "of", "component", "says"),
    [
        ("moment", "rail", "own", "has a force"),
        ("force", "rail", "x", "along its coordinate"),
        ("force", "pull", "normal", "only the force of a contact"),
    ],
)
def test_forces_that_are_none_are_refused(kind: str, of: str, component: str, says: str) -> None:
    scene = block(stiffness=1e4).force("pull", "block.origin", "1.0", "0.0")
    with pytest.raises(SceneError, match=says):
        scene.measure("one", kind, of, component=component).build()
