"""When things happen in runs of steps: what is told of it is the time at which it happens, and the grid goes on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import driven_bob

Build = Callable[[SceneRecord], Model]
STARTS, STOPS, AGAIN = 0.2137, 0.5, 0.8003  # s: within a step, at the end of one, within one


@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
@pytest.mark.parametrize("watched", [False, True])
def test_impulses_are_told_when_they_are_given(model_of: Build, scheme: str, watched: bool) -> None:
    """A crank sets out at 2 rad/s, stops, and sets out again: each time the bob, hung by its hinge, is struck.

    watched: an event in the step of each, so that the step is made in parts. Energy: the drive gives what it has more.
    """
    scene = driven_bob("struck", f"2*(min(max(t - {STARTS}, 0), {STOPS - STARTS}) + max(t - {AGAIN}, 0))")
    for k, time in enumerate((STARTS, STOPS, AGAIN) if watched else ()):
        scene.event(f"clock{k}", when=f"t - {time - 0.0011}")
    scene.simulation(t_end=1.0, dt=0.01, scheme=scheme)
    run = simulate(model_of(scene.build()), seen_every=0.0, error="off")
    assert run.status.ok
    struck = [one.time for one in run.events if one.kind == "velocity_jump"]
    assert struck == pytest.approx([STARTS, STOPS, AGAIN], abs=1e-9)
    told = [one.time for one in run.events if one.kind == "event"]
    assert told == pytest.approx([time - 0.0011 for time in (STARTS, STOPS, AGAIN)] if watched else [], abs=1e-9)
    assert run.t == pytest.approx(np.arange(101) * 0.01, abs=1e-12)
    assert run.stops[:, 0][run.stops[:, 1] != 0] == pytest.approx(struck, abs=1e-9)


@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "exponential"])
@pytest.mark.parametrize("at", [0.3337, 0.33, 0.0051])
def test_what_happens_by_a_jump_happens_when_it_jumps(model_of: Build, scheme: str, at: float) -> None:
    """A load sets in, and an event whose value jumps with it sets a push: x = (2 + 6) (t - at)^2 / 2 m, exactly."""
    scene = Scene("pushed").input("push", 0.0, "N", "along the rail").rigid("cart", mass=2.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "cart.origin").force("push", "cart.origin", "push", 0.0)
    scene.force("load", "cart.origin", f"where(t >= {at}, 2, 0)", 0.0)
    scene.event("gate", when=f"where(t >= {at}, 1, -1)", action={"push": 6.0})
    model = model_of(scene.simulation(t_end=0.5, dt=0.01, scheme=scheme).build())
    run = simulate(model, seen_every=0.0, error="off")
    (event,) = run.events
    assert event.time == pytest.approx(at, abs=1e-9)
    assert run.t == pytest.approx(np.arange(51) * 0.01, abs=1e-12)
    since = np.maximum(run.t - at, 0.0)
    assert run["cart.x"] == pytest.approx(2.0 * since**2, abs=1e-11)
    assert run["cart.x_dot"][run.t > at + 0.01] == pytest.approx(4.0 * since[run.t > at + 0.01], abs=1e-11)


@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
def test_steps_behind_an_event_are_those_of_the_grid(model_of: Build, scheme: str) -> None:
    """A cart at 1 m/s that turns back at 0.1234 m: a time of its own in a step, and samples where they would be."""
    scene = Scene("turned").input("push", 0.0, "N", "along the rail").rigid("cart", mass=2.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "cart.origin").force("push", "cart.origin", "push", 0.0)
    scene.measure("way", "x", "cart.origin").event("line", when="way - 0.1234", action={"push": -4.0})
    scene.rates({"cart.x": 1.0}).simulation(t_end=0.2, dt=0.01, scheme=scheme)
    run = simulate(model_of(scene.build()), seen_every=0.0, error="off")
    assert [one.time for one in run.events] == pytest.approx([0.1234], abs=1e-9)
    assert run.t == pytest.approx(np.arange(21) * 0.01, abs=1e-12)
    since = np.maximum(run.t - 0.1234, 0.0)
    assert run["cart.x"] == pytest.approx(run.t - since**2, abs=1e-10)
