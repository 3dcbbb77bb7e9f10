"""Points that meet: distances of zero, their rates, and springs and dampers between them, against x(t) by hand."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import ModelError, linearise, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
SPACES = ("planar", "spatial")


def free_body(space: str) -> Scene:
    """1 kg at the origin, whose distance from there is measured."""
    inertia: Any = 0.1 if space == "planar" else [0.1, 0.1, 0.1]
    scene = Scene(f"meets_{space}", space=space).rigid("b", mass=1.0, inertia=inertia, free=True)
    return scene.measure("d", "distance", of="b.origin")


@pytest.mark.parametrize("space", SPACES)
def test_the_rate_of_a_distance_of_zero_is_the_speed(model_of: Build, space: str) -> None:
    """d = 5 t, so that d' = 5 from the right; at rest d' = 0; through the ground's origin d = |x|."""
    model = model_of(free_body(space).simulation(t_end=1.0).build())
    run = simulate(model, initial={"b.x_dot": 3.0, "b.y_dot": 4.0})
    np.testing.assert_allclose(run["d_dot"], 5.0, rtol=1e-12)
    assert run.status.name == "completed" and not run.events
    np.testing.assert_array_equal(simulate(model)["d_dot"], 0.0)
    through = simulate(model, initial={"b.x": -0.5, "b.x_dot": 1.0}, scheme="rk4", dt=0.125, seen_every=0.125)
    np.testing.assert_allclose(through["d_dot"], [-1, -1, -1, -1, 1, 1, 1, 1, 1], atol=1e-14)


@pytest.mark.parametrize("space", SPACES)
def test_a_damper_acts_from_the_point_where_its_ends_meet(model_of: Build, space: str) -> None:
    """m x'' = -k x - c x' from x = 0, x' = 1: x = e^(-c t / 2) sin(w t) / w; the first stage, too, feels -c."""
    scene = free_body(space).spring_damper("k", "ground.origin", "b.origin", stiffness=100.0, damping=3.0)
    model = model_of(scene.rates({"b.x": 1.0}).simulation(t_end=0.3).build())
    w = np.sqrt(100.0 - 2.25)
    errors = []
    for dt in (4e-3, 2e-3):
        run = simulate(model, scheme="rk4", dt=dt)
        errors.append(np.abs(run["b.x"] - np.exp(-1.5 * run.t) * np.sin(w * run.t) / w).max())
        assert run["b.x_ddot"][0] == pytest.approx(-3.0, rel=1e-12)
    assert errors[1] < 1e-9 and np.log2(errors[0] / errors[1]) > 3.7
    only = free_body(space).spring_damper("c", "ground.origin", "b.origin", stiffness=0.0, damping=3.0)
    run = simulate(model_of(only.rates({"b.x": 1.0}).simulation(t_end=0.5).build()))
    np.testing.assert_allclose(run["b.x"], (1 - np.exp(-3 * run.t)) / 3, atol=2e-4)


def test_forces_by_the_rate_of_a_distance(model_of: Build) -> None:
    """m x'' = -d' = -x' from where the points are one: x' = e^-t."""
    scene = free_body("planar").force("drag", "b.origin", "-d_dot", 0.0).rates({"b.x": 1.0})
    run = simulate(model_of(scene.simulation(t_end=1.0, tolerance=1e-6).build()))
    assert run.status.name == "completed"
    np.testing.assert_allclose(run["b.x_dot"], np.exp(-run.t), atol=1e-5)


def test_what_has_no_direction_or_slope_there_is_named(model_of: Build) -> None:
    """A spring with a free length, and the derivative of a distance."""
    spring = free_body("planar").spring_damper("k", "ground.origin", "b.origin", stiffness=1.0, free_length=0.1)
    run = simulate(model_of(spring.simulation(t_end=0.1).build()))
    assert run.status.name == "not_finite" and "'k'" in str(run.status)
    model = model_of(free_body("planar").simulation(t_end=0.1).build())
    with pytest.raises(ModelError, match="output d, d_dot.*no derivative"):
        linearise(model, outputs=["d", "d_dot"])


def test_measures_without_a_value_are_told(model_of: Build) -> None:
    """An angle about z of a direction along z: the motion completes, and says which columns hold NaN."""
    scene = Scene("upright", space="spatial").measure("turn", "angle", of="b.arrow")
    scene.rigid(
        "b", mass=1.0, inertia=[0.1, 0.1, 0.1], free=True, markers={"arrow": {"axis": [1, 0, 0], "x_axis": [0, 0, 1]}}
    )
    run = simulate(model_of(scene.rates({"b.x": 1.0}).simulation(t_end=0.1).build()))
    assert run.status.name == "completed" and np.isnan(run["turn_dot"]).all()
    (told,) = [event for event in run.events if event.kind == "measure_undefined"]
    assert "turn_dot" in told.text and "turn," not in told.text and told.time == 0.0
