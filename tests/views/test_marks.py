"""Stops, what holds and wheels in the page of a run: their places by hand, and that a browser draws them."""

from __future__ import annotations

import base64
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.views.viewer.page import view
from runtime.views.viewer.record import view_record
from symgen.scene import Scene, SceneRecord
from tests.support.browser import used

Build = Callable[[SceneRecord], Model]


def machine(space: str) -> SceneRecord:
    """A block that strikes its upper stop and sticks, a flap between stops, two wheels in mesh."""
    spatial = space == "spatial"
    third = (0.0,) if spatial else ()
    scene = Scene("machine", space=space).gravity(0.0, -9.81, *third)
    level = {"axis": (1, 0, 0)} if spatial else {"angle": 0.0}
    markers = {"left": (0.9, 0.3), "right": (1.5, 0.3), "high": (0.9, 1.1)}
    scene.ground(markers={key: {"position": (*at, *third)} for key, at in markers.items()}
                 | {"rail": {"position": (0.0, 0.0, *third), **level}})  # fmt: skip
    shape = {"mass": 1.0, "inertia": (0.1,) * 3 if spatial else 0.1}
    scene.rigid("block", markers={"seat": {"position": (0.0, 0.0, *third), **level}}, **shape)
    scene.rigid("flap", center_of_mass=(0.3, 0.0, *third), **shape).rigid("a", **shape).rigid("b", **shape)
    scene.parameter("top", 0.6, "m")
    scene.prismatic("table", "ground.rail", "block.seat", friction={"coulomb": 2.0},
                    limits={"upper": "top", "restitution": 0.5})  # fmt: skip
    scene.revolute("hinge", "ground.high", "flap.origin", limits={"lower": -2.2, "upper": 0.5, "restitution": 0.4})
    scene.revolute("fast", "ground.left", "a.origin").revolute("slow", "ground.right", "b.origin")
    scene.gear("mesh", "fast.angle", "slow.angle", -2.0)
    scene.rates({"table.travel" if spatial else "block.x": 2.0})
    return scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_marks_stand_where_the_scene_has_them(model_of: Build, space: str) -> None:
    """Bars at 0.6 m, marks at -2.2 and 0.5 rad, radii 0.2 and 0.4 m of wheels 0.6 m apart; held from its stick on."""
    run = simulate(model_of(machine(space)))
    record = view_record(run)
    joints = {joint["name"]: joint for joint in record["joints"]}
    assert joints["table"]["ends"] == [None, pytest.approx(0.6, abs=1e-12)]
    assert joints["table"]["rail"][1] > 0.6
    assert joints["hinge"]["ends"] == pytest.approx([-2.2, 0.5], abs=1e-12)
    hubs = [record["bodies"][joints["mesh"][end][0]]["name"] for end in "ab"]
    radii = dict(zip(hubs, joints["mesh"]["wheels"], strict=True))
    assert radii == {"a": pytest.approx(0.2, abs=1e-12), "b": pytest.approx(0.4, abs=1e-12)}
    changes = [event for event in run.events if event.kind in ("impact", "mode")]
    assert record["marks"] == [[pytest.approx(event.time, abs=1e-8), int(event.kind == "mode")] for event in changes]
    assert record["box"][1][0] >= 1.9 - 1e-9 and joints["fast"]["held"] is None and joints["fast"]["ends"] == []
    t = np.frombuffer(base64.b64decode(record["t"]))
    held = np.frombuffer(base64.b64decode(joints["table"]["held"]), dtype="<f4")
    sticks = next(event.time for event in run.events if event.text == "table.friction sticks")
    assert (held == (t >= sticks + 0.01)).mean() > 0.99 and held[-1] == 1.0


@pytest.mark.long
def test_a_browser_draws_the_marks(model_of: Build, tmp_path: Path) -> None:
    run = simulate(model_of(machine("planar")))
    probe = """
    const by = (name) => symgenView.run.joints.find((joint) => joint.name === name);
    const bar = by("table").bars[0].bar.position, disc = by("mesh").discs[0].position;
    document.documentElement.dataset.probe = JSON.stringify([bar.x, bar.y, disc.x, by("hinge").bars.length]);
    """
    found = used(view(run).text, tmp_path, probe, "t=1.9")
    assert "error" not in found and found["ready"] == "1"
    x, y, hub, marks = found["probe"]
    assert 0.6 < x < 0.7 and abs(y) < 1e-6 and hub in (pytest.approx(0.9), pytest.approx(1.5)) and marks == 2
