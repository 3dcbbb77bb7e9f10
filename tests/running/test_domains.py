"""An expression without a value where the motion leads: the status names item, argument, value and time."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
CALLS: list[dict[str, Any]] = [
    {},
    {"scheme": "rk4", "dt": 0.01},
    {"scheme": "single_rate", "dt": 0.01},
    {"scheme": "radau", "dt": 0.01},
    {"scheme": "dopri5", "tolerance": 1e-4, "options": {"error_of": "step"}},
]


def flying(name: str) -> Scene:
    """1 kg at 1 m/s; x is its place, a = 0.25 m."""
    scene = Scene(name).rigid("b", mass=1.0, inertia=1.0, free=True).measure("x", "x", of="b.origin")
    return scene.parameter("a", 0.25).input("u", 1.0).rates({"b.x": 1.0})


def met(force: Callable[[float], float]) -> float:
    """When x = 0.25 is met by x'' = force(x), by SciPy [s]."""

    def here(t: float, y: np.ndarray) -> float:
        return float(y[0] - 0.25)

    here.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(lambda t, y: [y[1], force(y[0])], (0, 1), [0, 1], "DOP853", rtol=1e-10, events=here)
    return float(found.t_events[0][0])


def pushed(name: str, force: str) -> Scene:
    return flying(name).force("push", "b.origin", force, 0.0)


def root(x: float) -> float:
    return float(np.sqrt(max(0.25 - x, 0.0)))


def logarithm(x: float) -> float:
    return float(-np.log(max(0.25 - x, 1e-12)))


CASES: dict[str, tuple[Scene, str, str, str, float]] = {
    "root": (pushed("root", "u * sqrt(a - x)"), "load 'push'", "sqrt(a - x)", "a - x is negative", met(root)),
    "power": (pushed("power", "(a - x)**0.5"), "load 'push'", "(a - x) ** 0.5", "a - x is negative", met(root)),
    "log": (pushed("logs", "-log(a - x)"), "load 'push'", "log(a - x)", "a - x is not positive", met(logarithm)),
    "arcsine": (flying("arc").state("s", "asin(4 * x)"), "state 's'", "asin(4 * x)", "4 * x is beyond 1", 0.25),
    "state": (flying("state").state("s", "sqrt(a - x)"), "state 's'", "sqrt(a - x)", "a - x is negative", 0.25),
    "event": (
        flying("watch").event("e", when="sqrt(a - x) - 10", action={"u": 1.0}),
        "event 'e'",
        "sqrt(a - x)",
        "a - x is negative",
        0.25,
    ),
    "action": (
        flying("act").event("e", when="x - a", action={"u": "log(a - x - 0.1)"}),
        "event 'e'",
        "log(a - x - 0.1)",
        "a - x - 0.1 is not positive",
        0.25,
    ),
    "time": (
        flying("late").torque("turn", "b.origin", "sqrt(0.25 - t)"),
        "load 'turn'",
        "sqrt(0.25 - t)",
        "0.25 - t is negative",
        0.25,
    ),
}


@pytest.mark.every_push("root-call0", "event-call1", "log-call2")
@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("case", CASES)
def test_what_has_no_value_is_named(model_of: Build, case: str, call: dict[str, Any]) -> None:
    scene, item, part, argument, time = CASES[case]
    status = simulate(model_of(scene.build()), t_end=1.0, **call).status
    assert status.name == "not_finite", status
    assert status.cause.startswith(item) and f"{part} has no value where {argument}" in status.cause, status
    value, t = (float(one) for one in re.findall(r"it is (\S+) at t = (\S+) s", status.cause)[0])
    assert t == pytest.approx(time, abs=0.012 if call.get("scheme") == "single_rate" else 3e-3)
    assert abs(value - {"arcsine": 1.0, "action": -0.1}.get(case, 0.0)) < 0.02
    assert "max(..., 0)" in status.advice and status.time <= t + 1e-9


def test_the_advice_is_taken(model_of: Build) -> None:
    """x'' = sqrt(max(a - x, 0)) from there on is a flight at one speed."""
    run = simulate(model_of(pushed("mended", "u * sqrt(max(a - x, 0))").build()), t_end=1.0)
    assert run.status.name == "completed"
    speed = np.sqrt(1 + 4 / 3 * 0.25**1.5)  # energy: v^2 / 2 = 1 / 2 + int sqrt(a - x) dx
    assert run["b.x_dot"][-1] == pytest.approx(speed, rel=1e-3)


def test_a_branch_that_is_not_taken_has_no_say(model_of: Build) -> None:
    """The root stands where x < a only; what ends the run is another load."""
    scene = pushed("branch", "where(x < a, sqrt(a - x), 0)").torque("turn", "b.origin", "log(0.5 - t)")
    status = simulate(model_of(scene.build()), t_end=1.0, scheme="rk4", dt=0.01).status
    assert status.name == "not_finite" and status.cause.startswith("load 'turn', value: log(0.5 - t) has no value")


def test_no_text_of_a_scene_is_taken_for_an_expression(model_of: Build) -> None:
    """Titles and descriptions may look like one."""
    scene = flying("words").parameter("k", 1.0, description="sqrt(a - x)").torque("turn", "b.origin", "log(0.5 - t)")
    status = simulate(model_of(scene.build()), t_end=1.0, scheme="rk4", dt=0.01).status
    assert status.cause.startswith("load 'turn'")
