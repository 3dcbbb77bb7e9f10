"""Events whose values turn within steps, so that the ends of steps look alike."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import Model, simulate
from runtime.schemes.switching.event_search import first_bracket
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


@pytest.mark.long
@pytest.mark.parametrize("dt", [10.0, 20.0])
def test_steps_of_whole_turns_pass_nothing_over(model_of: Build, dt: float) -> None:
    """One turn a second, first steps of one or two: their ends look alike while cos falls below 0.01 t - 1.05."""
    builder = Scene("steady_wheel").rigid("wheel", mass=1.0, inertia=0.1)
    builder.revolute("axle", "ground.origin", "wheel.origin").measure("angle", "coordinate", "wheel.theta")
    builder.event("low", when="cos(angle) + 1.05 - 0.01 * t", direction="falling")
    builder.rates({"wheel.theta": 2 * np.pi})
    model = model_of(builder.simulation(t_end=20.0, dt=dt, scheme="dopri5").build())
    run = simulate(model, scheme="dopri5", tolerance=1e-6, options={"error_of": "step"})
    times = [brentq(lambda t: np.cos(2 * np.pi * t) + 1.05 - 0.01 * t, k, k + 0.5, xtol=1e-13) for k in range(5, 20)]
    assert [event.time for event in run.events] == pytest.approx(times, rel=0, abs=1e-9)
    assert (np.diff(run.t) > 0).all() and run.error.measured  # the sample before an event is there once


def test_a_dip_between_the_places_of_a_long_step_is_told(model_of: Build) -> None:
    """A wheel of 1 rad/s passes a dip of 1.9 rad early in steps that are as long as it likes, wherever the dip is."""
    scene = Scene("dipping_wheel").rigid("wheel", mass=1.0, inertia=0.1).parameter("middle", 2.0, "rad")
    scene.revolute("axle", "ground.origin", "wheel.origin").measure("angle", "coordinate", "wheel.theta")
    scene.event("low", when="1 - 1.5 * exp(-(angle - middle) * (angle - middle) / 2.25)").rates({"wheel.theta": 1.0})
    model = model_of(scene.simulation(t_end=20.0, dt=10.0, scheme="dopri5").build())
    half = 1.5 * np.sqrt(np.log(1.5))
    how = {"scheme": "dopri5", "tolerance": 1e-6, "options": {"error_of": "step"}, "error": "off"}
    for middle in (2.0, 2.5, 3.0, 3.5):
        run = simulate(model, **how, parameters={"middle": middle})
        assert [event.time for event in run.events] == pytest.approx([middle - half, middle + half], rel=0, abs=1e-9)


def test_steps_are_short_beside_what_events_look_at(model_of: Build) -> None:
    """A mass at 1 m/s, which steps of any length follow: sin(60 x) passes zero every pi / 60 s, and none is longer."""
    scene = Scene("passing").rigid("m", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "m.origin")
    scene.measure("x", "x", "m.origin").event("tick", "sin(60 * x)").rates({"m.x": 1.0})
    model = model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="dopri5").build())
    how = {"scheme": "dopri5", "tolerance": 1e-6, "options": {"error_of": "step"}, "error": "off"}
    run = simulate(model, **how, seen_every=0.01)
    assert [event.time for event in run.events] == pytest.approx(np.arange(1, 20) * np.pi / 60, rel=0, abs=1e-9)
    assert float(run.stats["largest_step"]) < np.pi / 60


@pytest.mark.parametrize("scheme", ["rk4", "exponential", "dopri5"])
def test_an_event_that_is_over_before_a_load_kinks_in_the_same_step(model_of: Build, scheme: str) -> None:
    """cos(20 t + 1.2) falls and rises again before a wall is met, in one step: a raw ValueError. The event is at
    (3 pi / 2 - 1.2) / 20; then the wall at 0.25 s, in which x = 0.25 + sin(w (t - 0.25)) / w."""
    wall = "where(x > 0.25, -10*(x - 0.25), 0)"
    builder = Scene("both").rigid("b", mass=1.0, inertia=1.0, free=True).measure("x", "x", of="b.origin")
    builder.input("seen").force("wall", "b.origin", wall, 0.0).rates({"b.x": 1.0})
    builder.event("turn", when="cos(20*t + 1.2)", direction="rising", action={"seen": "seen + 1"})
    call = {"tolerance": 0.1, "options": {"error_of": "step"}} if scheme == "dopri5" else {"dt": 0.3}
    run = simulate(model_of(builder.build()), scheme=scheme, t_end=0.3, error="off", **call)
    assert [event.time for event in run.events] == pytest.approx([(1.5 * np.pi - 1.2) / 20], abs=1e-9)
    w = np.sqrt(10.0)
    assert run["b.x"][-1] == pytest.approx(0.25 + np.sin(w * 0.05) / w, abs=1e-6 if scheme != "dopri5" else 1e-4)
    assert run.stats["kinks"] == 1


def test_a_step_that_tells_nothing_is_not_looked_at_for_ever() -> None:
    """Noise is never foretold: fewer places than are allowed are looked at, and each pair of them but once."""
    random, looks, pairs = np.random.default_rng(3), [0], [0]

    def values(s: np.ndarray) -> np.ndarray:
        looks[0] += len(s)
        return 1 + random.uniform(0, 1, (len(s), 2))

    def happens(old: np.ndarray, new: np.ndarray) -> bool:
        pairs[0] += 1
        return bool(((old < 0) & (new >= 0)).any())

    assert first_bracket(happens, values, 0.0, 1.0, agreements=1, most=500) is None
    assert 400 < looks[0] < 500 and pairs[0] < 2 * looks[0]


@pytest.mark.long
def test_a_far_too_long_first_level_does_not_hold_a_run_up(model_of: Build) -> None:
    """A ball on a hinge that rubs, on an arm over a stiff floor: the first level of the default call diverges."""
    scene = Scene("arm").gravity(0, -9.81).ground(markers={"floor": {"position": (0, -0.3)}})
    scene.rigid("arm", mass=1.5, inertia=0.05, center_of_mass=(0.3, 0), markers={"tip": {"position": (0.6, 0)}})
    scene.revolute("h", "ground.origin", "arm.origin").rigid("ball", mass=0.2, inertia=0.001)
    scene.revolute("h2", "arm.tip", "ball.origin", friction={"coulomb": 0.01})
    scene.load("contact", "c", marker="ball.origin", radius=0.05, plane="ground.floor", stiffness=1e5, damping=0.2,
               exponent=1.5, friction=0.3, slip_speed=1e-3)  # fmt: skip
    run = simulate(model_of(scene.simulation(t_end=1.0).build()))
    assert run.status.name == "completed" and 0 < len(run.events) < 60
    fine = simulate(run.model, scheme="dopri5", dt=1e-4, error="off")
    assert run["arm.theta"][-1] == pytest.approx(fine["arm.theta"][-1], abs=2e-3)
