"""The advice of a status is taken: the same call with what it says is accepted, and goes to its end."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

from runtime import Status, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.running.test_fast_loops import slider_crank
from tests.running.test_tolerance_behind_passages import hung

Build = Callable[[SceneRecord], Model]
OFTEN = 8  # times at most


def ball_on_an_arm() -> SceneRecord:
    """A ball with an arm on a hinge with friction falls on a floor with friction: two rigid bodies."""
    scene = Scene("disc").gravity(0, -9.81).rigid("ball", mass=1.0, inertia=0.004, free=True)
    scene.rigid("arm", mass=0.5, inertia=0.01, center_of_mass=(0.25, 0))
    scene.revolute("h", "ball.origin", "arm.origin", friction={"coulomb": 0.3})
    contact = {"plane": "ground.origin", "damping": 0.2, "exponent": 1.5, "friction": 0.4}
    scene.contact("floor", "ball.origin", 0.1, 2e4, **contact)
    scene.initial({"ball.x": 0.0, "ball.y": 0.3, "ball.theta": 0.0, "arm.theta": -2.0})
    return scene.rates({"ball.x": 0.6, "ball.y": 0.0, "ball.theta": 0.0, "arm.theta": 0.0}).build()


def mass_on_a_spring() -> SceneRecord:
    """100 rad/s."""
    scene = Scene("spring").rigid("m", mass=1.0, inertia=1.0, free=True)
    return scene.measure("x", "x", of="m.origin").force("k", "m.origin", "-1e4*x", 0.0).initial({"m.x": 1.0}).build()


def taken(call: dict[str, Any], status: Status) -> dict[str, Any]:
    """The call with what the advice says."""
    advice, new = status.advice, dict(call)
    step, named = re.search(r"dt=(\d[\d.e+-]*\d|\d)", advice), re.search(r'scheme="(\w+)"', advice)
    assert step or "smaller tolerance" in advice or "smaller step" in advice, advice
    if named:
        assert "dt" not in call
        new["scheme"] = named[1]
        new.pop("tolerance", None)
    if step:
        assert named or "dt" in call, "a step where none was given"
        new["dt"] = float(step[1])
        assert new["dt"] < call.get("dt", 1.0)
    elif "smaller step" in advice:
        new["dt"] = call["dt"] / 3
    else:
        new["tolerance"] = call["tolerance"] / 10
    return new


@pytest.mark.every_push("loop", "long", "exchange")
@pytest.mark.parametrize(
    ("scene", "call", "name"),
    [
        pytest.param(slider_crank, {"scheme": "rk4", "dt": 0.05, "t_end": 5.0}, "constraints_lost", id="loop"),
        pytest.param(slider_crank, {"scheme": "radau", "dt": 0.05, "t_end": 5.0}, "branch_lost", id="branch"),
        pytest.param(hung, {"scheme": "dop853", "dt": 0.25, "t_end": 5.0}, "branch_lost", id="exchange"),
        pytest.param(mass_on_a_spring, {"scheme": "single_rate", "dt": 0.03, "t_end": 1.0}, "step_too_long", id="long"),
        pytest.param(
            mass_on_a_spring, {"scheme": "rk4", "dt": 0.2, "t_end": 50.0, "force": True}, "diverged", id="forced"
        ),
        pytest.param(
            slider_crank,
            {"scheme": "exponential_rk4", "tolerance": 0.1, "t_end": 3.0, "options": {"error_of": "step"}},
            "inaccurate",
            id="tolerance",
        ),
    ],
)
def test_the_advice_is_taken_until_the_run_completes(
    model_of: Build, scene: Callable[[], SceneRecord], call: dict[str, Any], name: str
) -> None:
    model = model_of(scene())
    run = simulate(model, **call)
    assert run.status.name == name
    for _ in range(OFTEN):
        call = taken(call, run.status)
        run = simulate(model, **call)
        if run.status.name == "completed":
            break
    assert run.status.name == "completed", (call, run.status)


@pytest.mark.every_push("slider_crank-call0")
@pytest.mark.parametrize(
    ("scene", "call"),
    [
        (slider_crank, {"scheme": "rk4", "dt": 0.05, "t_end": 5.0}),
        (hung, {"scheme": "dop853", "dt": 0.25, "t_end": 5.0}),
    ],
)
def test_a_tolerance_in_place_of_a_step_completes_at_once(
    model_of: Build, scene: Callable[[], SceneRecord], call: dict[str, Any]
) -> None:
    model = model_of(scene())
    assert "give a tolerance in place of it" in simulate(model, **call).status.advice
    del call["dt"]
    assert simulate(model, **call, tolerance=1e-4).status.name == "completed"
