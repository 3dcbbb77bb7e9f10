"""Exported C of rigid stops: impacts, sums of bounces and rests with the bits of the runtime."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime.engine.c_source import find_compiler
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.export.bundles import bundle
from tests.export.test_c_stops import same
from tests.running.test_rigid_stops import ball, rod

Build = Callable[[SceneRecord], Model]
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
STRIBECK = {"coulomb": 0.3, "breakaway": 0.5, "stribeck_velocity": 0.1, "viscous": 0.05}


def rows_of_balls() -> Scene:
    """Two balls that touch, a third that comes: all are struck at once; walls at both ends."""
    scene = Scene("row")
    for name, mass in (("a", 1.0), ("b", 2.0), ("c", 0.7)):
        scene.rigid(name, mass=mass, inertia=0.1)
    scene.prismatic("first", "ground.origin", "a.origin", limits={"lower": -0.5, "restitution": 0.9})
    scene.prismatic("second", "a.origin", "b.origin", limits={"lower": 0.2, "restitution": 0.8})
    scene.prismatic("third", "b.origin", "c.origin", limits={"lower": 0.2, "upper": 0.6, "restitution": 0.7})
    return scene.initial({"a.x": 0.0, "b.x": 0.2, "c.x": 0.7}).rates({"a.x": 0.0, "b.x": 0.0, "c.x": -3.0})


def stacked() -> Scene:
    """Two balls on each other and on the ground, which come to rest."""
    scene = Scene("stacked").gravity(0.0, -9.81).ground(markers={"up": {"position": (0.0, 0.0), "angle": np.pi / 2}})
    scene.rigid("low", mass=1.0, inertia=0.1, markers={"up": {"position": (0.0, 0.0), "angle": np.pi / 2}})
    scene.rigid("high", mass=0.4, inertia=0.1)
    scene.prismatic("floor", "ground.up", "low.origin", limits={"lower": 0.1, "restitution": 0.6})
    scene.prismatic("between", "low.origin", "high.origin", limits={"lower": 0.2, "restitution": 0.7})
    return scene.initial({"low.y": 0.5, "high.y": 0.9})


def links() -> Scene:
    """A chain between stops, one joint of which rubs and another one rests on its stop."""
    scene, last = Scene("links").gravity(0.0, -9.81), "ground.origin"
    tip = {"tip": {"position": (1.0, 0.0)}}
    for k in range(3):
        scene.rigid(f"link{k}", mass=1.0, inertia=0.08, center_of_mass=(0.5, 0.0), markers=tip)
        more = {"friction": STRIBECK} if k else {}
        limits = {"lower": -0.6, "upper": 0.4, "restitution": 0.5}
        scene.revolute(f"hinge{k}", last, f"link{k}.origin", limits=limits, **more)
        last = f"link{k}.tip"
    return scene.effort("drive", coordinate="hinge0.angle", value="12 * sin(5 * t) + where(t < 0.9, 0, 15)")


def slider_crank() -> Scene:
    """A loop whose slider has stops and rubs."""
    scene = Scene("slider_crank")
    scene.rigid("crank", mass=1.0, inertia=0.02, center_of_mass=(0.15, 0.0), markers={"tip": {"position": (0.3, 0.0)}})
    scene.rigid("rod", mass=0.6, inertia=0.03, center_of_mass=(0.4, 0.0), markers={"tip": {"position": (0.8, 0.0)}})
    scene.rigid("slider", mass=2.0, inertia=0.1)
    scene.revolute("main", "ground.origin", "crank.origin").revolute("big", "crank.tip", "rod.origin")
    scene.revolute("small", "rod.tip", "slider.origin")
    limits = {"lower": 0.7, "upper": 1.0, "restitution": 0.5}
    scene.prismatic("rail", "ground.origin", "slider.origin", limits=limits, friction={"coulomb": 0.5})
    scene.effort("drive", coordinate="main.angle", value="0.5 * sin(3 * t)")
    return scene.initial({"crank.theta": 1.2}).rates({"crank.theta": -5.0})


def arm() -> Scene:
    """A beam whose hub is stopped."""
    flat: Any = {"lateral": {"ends": "clamped-free", "modes": 3}, "second_moment": 2e-9, "youngs_modulus": 7e10}
    scene = Scene("arm").gravity(0.0, -9.81).beam("arm", length=1.0, density=2700.0, area=1e-4, **flat)
    scene.revolute("pin", "ground.origin", "arm.start", limits={"lower": -0.2, "upper": 0.5, "restitution": 0.4})
    return scene.rates({"arm.theta": 2.0})


def pressed(law: str = "push * cos(4 * t)") -> Scene:
    """Friction and a plastic stop in one joint, pressed upon it and pulled away by an input."""
    scene = Scene("pressed").input("push", 20.0, "N").rigid("m", mass=1.0, inertia=0.1)
    friction, limits = {"coulomb": 2.0, "breakaway": 3.0, "stribeck_velocity": 0.1}, {"upper": 0.1, "restitution": 0.0}
    scene.prismatic("rail", "ground.origin", "m.origin", friction=friction, limits=limits)
    return scene.force("press", "m.origin", law, 0.0)


CASES: list[Any] = [  # scene, scheme, step, steps, impacts and rests at least
    (lambda: ball(0.8), "rk4", 0.01, 500, (40, 1)),
    (lambda: ball(0.8), "single_rate", 0.01, 500, (40, 1)),
    (lambda: rod("spatial", 0.6), "rk4", 0.01, 300, (10, 1)),
    (rows_of_balls, "rk4", 0.01, 300, (8, 0)),
    (stacked, "rk4", 0.01, 300, (20, 2)),
    (links, "rk4", 0.005, 400, (60, 5)),
    (slider_crank, "rk4", 2e-3, 700, (2, 0)),
    (slider_crank, "single_rate", 2e-3, 700, (2, 0)),
    (arm, "exponential", 2e-3, 500, (9, 3)),
    (pressed, "rk4", 0.01, 400, (1, 0)),
]


@pytest.mark.every_push("<lambda>-rk4-0.01-500-happens0")
@pytest.mark.parametrize(("scene", "scheme", "dt", "steps", "happens"), CASES)
def test_impacts_and_rests_have_the_bits_of_the_runtime(
    model_of: Build,
    tmp_path: Path,
    scene: Callable[[], Scene],
    scheme: str,
    dt: float,
    steps: int,
    happens: tuple[int, int],
) -> None:
    model = model_of(scene().simulation(t_end=1.0, dt=dt, scheme=scheme).build())
    own, stepper = bundle(model, tmp_path, scheme=scheme, dt=dt), model.stepper(scheme=scheme, dt=dt)
    same(own, stepper)
    started = np.zeros_like(own.z)
    own.call("start", started, own.c, 0.0, np.array([one.start for one in own.one.x]), own.w)
    np.testing.assert_array_equal(started, own.z)
    for _ in range(4):
        assert own.call("step", own.z, own.c, own.w, steps // 4) == 0
        stepper.step(steps // 4)
        same(own, stepper)
    told = [event.kind for event in stepper.events]
    assert told.count("impact") >= happens[0] and told.count("rest") >= happens[1]


def test_an_input_takes_away_what_rests_on_a_stop(model_of: Build, tmp_path: Path) -> None:
    """3 N of breakaway: a push of 20 N brings it there, 2.9 N backwards leave it, 3.1 N move it."""
    model = model_of(pressed("push").simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    own, stepper = bundle(model, tmp_path), model.stepper()
    u, x = np.zeros(len(own.one.inputs)), [one.name for one in own.one.outputs].index("m.x")
    push = [one.name for one in own.one.inputs].index("push")
    own.step(35)
    stepper.step(35)
    for value, moves in ((-2.9, False), (-3.1, True)):
        own.call("held", u, own.z)
        u[push] = value
        own.call("hold", own.z, own.c, u, own.w)
        before = own.observe()[x]
        own.step(1)
        stepper.step({"push": value}, 1)
        same(own, stepper)
        assert (own.observe()[x] < before - 1e-7) == moves and before == pytest.approx(0.1, abs=1e-9)


def test_a_start_beyond_a_stop_does_not_go_on(model_of: Build, tmp_path: Path) -> None:
    own = bundle(model_of(ball(0.8).build()), tmp_path)
    x = np.array([one.start for one in own.one.x])
    for start, end in ((-1e-3, 6), (0.0, 0), (0.5, 0)):
        x[[one.name for one in own.one.x].index("ball.y")] = start
        own.call("start", own.z, own.c, 0.0, x, own.w)
        assert own.call("step", own.z, own.c, own.w, 3) == end
