"""A scene that names no scheme: what is made in steps of one length takes those that `auto` finds."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import SchemeError, ensemble, output_jacobian, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


@pytest.fixture(scope="module")
def bob(model_of: Build) -> Model:
    scene = Scene("bob").gravity(0, -9.81).rigid("bob", mass=1.0, inertia=0.1, center_of_mass=(1.0, 0.0))
    return model_of(scene.revolute("pin", "ground.origin", "bob.origin").simulation(t_end=1.0).build())


def test_an_ensemble_a_stepper_and_a_derivative_need_no_scheme(bob: Model) -> None:
    """Angles at 1 s to the tolerance of `auto`; the derivative by mass against differences of runs to 1e-9, to 2 %."""
    cases = ensemble(bob, {"bob.mass": [1.0, 2.0]}, outputs=["bob.theta"])
    exact = [simulate(bob, tolerance=1e-9, parameters={"bob.mass": mass})["bob.theta"][-1] for mass in (1.0, 2.0)]
    np.testing.assert_allclose(cases["bob.theta"][:, -1], exact, rtol=0, atol=2e-3)
    stepper = bob.stepper()
    while stepper.time < 1.0 - stepper.dt / 2:
        stepper.step()
    assert stepper.state["bob.theta"] == pytest.approx(exact[0], abs=2e-3)
    slope = output_jacobian(bob, ["bob.theta"], ["bob.mass"]).derivatives[-1, 0, 0]
    near = [simulate(bob, tolerance=1e-9, parameters={"bob.mass": mass})["bob.theta"][-1] for mass in (0.99, 1.01)]
    assert slope == pytest.approx((near[1] - near[0]) / 0.02, rel=2e-2)


def test_a_step_may_be_named_alone(bob: Model) -> None:
    assert bob.stepper(dt=1e-3).dt == 1e-3


def test_a_motion_shorter_than_the_step_that_a_scheme_would_take(model_of: Build) -> None:
    """It was refused for a dt that nobody had given; free fall for half a millisecond."""
    scene = Scene("drop").gravity(0, -9.81).rigid("ball", mass=1.0, inertia=0.1, free=True)
    run = simulate(model_of(scene.simulation(t_end=5e-4).build()))
    assert run.status.ok and run["ball.y"][-1] == pytest.approx(-9.81 / 2 * 5e-4**2, rel=1e-6)


def test_ratios_and_options_need_a_scheme(bob: Model) -> None:
    with pytest.raises(SchemeError, match="auto chooses m and options itself; leave them out, or name a scheme"):
        ensemble(bob, {"bob.mass": [1.0]}, outputs=["bob.theta"], m=[4])


def test_a_motion_that_auto_cannot_make_is_refused(model_of: Build) -> None:
    """x'' = x^3 from x = 10 is infinite long before 10 s."""
    scene = Scene("away").rigid("block", mass=1.0, inertia=1.0, free=True).initial({"block.x": 10.0})
    scene.measure("x", "x", of="block.origin").force("push", "block.origin", "x**3", 0.0)
    model = model_of(scene.simulation(t_end=10.0).build())
    with pytest.raises(SchemeError, match="finds none whose motion comes to its end; name one with its step"):
        ensemble(model, {"block.mass": [1.0]}, outputs=["block.x"])
