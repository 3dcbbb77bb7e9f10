"""A run that begins where another ended is the rest of one run: inputs, modes, controllers and cool-downs go along."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, ModelError, Sampled, simulate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def wheel() -> Scene:
    """Turned by 1 N m, until an event at 1 rad sets the brake to 3 N m."""
    scene = Scene("wheel").input("u", 0.0).rigid("w", mass=1.0, inertia=0.1).revolute("h", "ground.origin", "w.origin")
    scene.measure("a", "coordinate", of="w.theta").torque("q", "w.origin", "1.0 - u")
    scene.event("e", "a - 1", direction="rising", action={"u": 3.0})
    return scene.simulation(t_end=2.0, dt=0.01, scheme="rk4")


@pytest.mark.parametrize("way", [{"scheme": "rk4", "dt": 0.01}, {}], ids=["steps", "default"])
def test_inputs_that_events_have_set_go_along(model_of: Build, way: dict[str, Any]) -> None:
    """By hand: 10 rad/s^2 up to 1 rad at 1/sqrt(5) s, then -20 rad/s^2; a number that is given anew is kept."""
    model = model_of(wheel().build())
    half = simulate(model, t_end=1.0, **way)
    rest = simulate(model, t0=1.0, t_end=2.0, initial=half, **way)
    left = 2 - 0.2**0.5
    assert rest["w.theta"][-1] == pytest.approx(1 + 20**0.5 * left - 10 * left**2, abs=1e-6) and rest["u"][0] == 3
    free = simulate(model, t0=1.0, t_end=2.0, initial=half, parameters={"u": 1.0}, **way)
    assert free["w.theta_dot"][-1] == pytest.approx(half["w.theta_dot"][-1], abs=1e-9)
    anew = simulate(model, t_end=1.0, initial=half, **way)  # another motion from there
    assert anew["u"][0] == 0


def block() -> Scene:
    """It is pushed against friction that lets go late, and an end stop."""
    friction = {"coulomb": 4.0, "breakaway": 6.0, "stribeck_velocity": 0.2}
    scene = Scene("block").input("u", 0.0, "N").rigid("b", mass=1.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "b.origin", friction=friction,
                    limits={"upper": 0.1, "restitution": 0.0})  # fmt: skip
    return scene.force("pull", "b.origin", "9 * sin(4 * t) + u", 0.0).simulation(t_end=1.6, dt=0.01, scheme="rk4")


@pytest.mark.parametrize("t0", [0.1, 0.3, 0.7, 0.9, 1.2])
def test_modes_of_friction_and_stops_go_along(model_of: Build, t0: float) -> None:
    """Stuck, sliding, on the stop: both halves are the whole, events included."""
    model = model_of(block().build())
    whole, half = simulate(model, error="off"), simulate(model, t_end=t0, error="off")
    rest = simulate(model, t0=t0, initial=half, error="off")
    assert rest["b.x"][-1] == pytest.approx(whole["b.x"][-1], abs=1e-9)
    assert [event.text for event in half.events + rest.events] == [event.text for event in whole.events]


def integral(t: float, seen: np.ndarray, memory: np.ndarray) -> float:
    """Of what is missing to 0.05 m."""
    memory[0] += 0.05 - seen[0]
    return float(20 * memory[0])


def test_memories_of_controllers_go_along(model_of: Build) -> None:
    """An integral goes on; another memory, a controller that is asked at other times, and none are refused by name."""
    model = model_of(block().build())

    def by(memory: Any, every: float = 0.05) -> dict[str, Any]:
        return {"u": Sampled(integral, every=every, reads=["b.x"], memory=memory)}

    whole = simulate(model, inputs=by([0.0]), error="off")
    half = simulate(model, t_end=0.8, inputs=by([0.0]), error="off")
    rest = simulate(model, t0=0.8, initial=half, inputs=by([0.0]), error="off")
    assert rest["b.x"][-1] == pytest.approx(whole["b.x"][-1], abs=1e-9)
    assert rest["u"][-1] == pytest.approx(whole["u"][-1], abs=1e-9)
    with pytest.raises(ModelError, match="'u'.*has another memory than that of the run"):
        simulate(model, t0=0.8, initial=half, inputs=by([0.0, 0.0]), error="off")
    with pytest.raises(ModelError, match=r"'u'.*is sampled every 0\.3 s"):
        simulate(model, t0=0.8, initial=half, inputs=by([0.0], 0.3), dt=0.1, error="off")
    with pytest.raises(ModelError, match="'u'.*was driven in the run"):
        simulate(model, t0=0.8, initial=half, error="off")
    assert simulate(model, t0=0.8, initial=half, parameters={"u": 0.0}, error="off").status.ok

    def forgets(t: float, seen: np.ndarray) -> float:
        return 0.0

    unknown = {"u": Sampled(forgets, every=0.05, reads=["b.x"])}
    half = simulate(model, t_end=0.8, inputs=unknown, error="off")
    with pytest.raises(ModelError, match="'u'.*cannot be continued"):
        simulate(model, t0=0.8, initial=half, inputs=unknown, error="off")
    assert simulate(model, t0=0.8, initial=half.initial_values(), inputs=unknown, error="off").status.ok


def test_a_cool_down_goes_along(model_of: Build) -> None:
    """An event every quarter of a second is not looked for half a second behind one, across the cut, too."""
    scene = wheel().event("turns", "sin(8 * pi * t)", direction="rising", cool_down=0.45)
    model = model_of(scene.build())
    whole, half = simulate(model, error="off"), simulate(model, t_end=0.6, error="off")
    rest = simulate(model, t0=0.6, initial=half, error="off")
    times = [[event.time for event in run.events if event.name == "turns"] for run in (whole, half, rest)]
    assert times[1] and times[1] + times[2] == pytest.approx(times[0], abs=1e-9)
