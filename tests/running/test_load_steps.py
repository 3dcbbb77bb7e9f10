"""Loads that coarse trials do not see: how many steps do, and what runs to a tolerance make of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import Model, simulate
from runtime.running.steps_for_loads import steps_that_see_loads
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_hinge

Build = Callable[[SceneRecord], Model]
PULSE, AT, WIDTH = 5.0, 3.33, 0.002


def rotor(torque: str) -> SceneRecord:
    """theta'' = torque(t), with I = 1."""
    builder = on_hinge("rotor", "rotor", "axle", mass=1.0, inertia=1.0).torque("motor", "rotor.origin", torque)
    return builder.simulation(t_end=10.0, dt=0.1, scheme="rk4").build()


def steps(model: Model) -> int:
    c = model.constants(model.parameter_vector())
    state = start_state(model, model.parameter_vector(), c, 0.0, None, None)
    return steps_that_see_loads(model, c, state, 0.0, 10.0)


@pytest.mark.parametrize(
    ("torque", "least", "most"),
    [
        ("0.3", 0, 0),
        ("0.3*sin(0.6*t)", 1, 16),  # a period
        ("where(t < 4, 0.3, -0.2)", 1, 16),  # steps end there
        ("0.3*cos(200*t)**8", 128, 1024),  # 640 pulses, whose mean eighty steps tell by chance
        (f"{PULSE}*exp(-((t - {AT})/{WIDTH})**2)", 1024, 8192),
    ],
)
def test_so_many_steps_see_a_load(model_of: Build, torque: str, least: int, most: int) -> None:
    assert least <= steps(model_of(rotor(torque))) <= most


@pytest.mark.every_push("auto")
@pytest.mark.parametrize("scheme", ["dopri5", "exponential_rk4", "auto"])
def test_a_pulse_shorter_than_coarse_steps_is_not_missed(model_of: Build, scheme: str) -> None:
    """A pulse of 3 ms in 10 s of slow motion gives the speed its integral, A w sqrt(pi); trials of 24 steps miss
    it.
    """
    model = model_of(rotor(f"0.1*cos(t) + {PULSE}*exp(-((t - {AT})/{WIDTH})**2)"))
    run = simulate(model, scheme=scheme, tolerance=1e-3)
    after = run.t > AT + 0.1
    given = run.rate("rotor.theta")[after] - 0.1 * np.sin(run.t[after])
    assert given == pytest.approx(PULSE * WIDTH * np.sqrt(np.pi), rel=0.02)


def narrow(width: float) -> SceneRecord:
    """A rod of 1 kg and 1 m that falls from the horizontal, and is struck where it passes -1.2 rad."""
    builder = Scene("struck").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0))
    builder.revolute("hinge", "ground.origin", "rod.origin").measure("a", "angle", "rod.origin")
    return builder.torque("push", "rod.origin", f"400*exp(-((a + 1.2)/{width!r})**2)").build()


def struck(width: float, t: np.ndarray) -> np.ndarray:
    """Its angle at times t, by I theta'' = M(theta) - m g l cos(theta) with steps of 0.1 ms."""

    def slope(t: float, y: np.ndarray) -> list[float]:
        return [y[1], 3 * (400 * np.exp(-(((y[0] + 1.2) / width) ** 2)) - 9.81 / 2 * np.cos(y[0]))]

    found = solve_ivp(slope, (0, t[-1]), [0, 0], method="DOP853", rtol=1e-11, atol=1e-11, t_eval=t, max_step=1e-4)
    return np.asarray(found.y[0])


@pytest.mark.long
@pytest.mark.parametrize("width", [1e-3, 5e-3, 0.05])
@pytest.mark.parametrize("scheme", ["dopri5", "rk4"])
def test_a_load_narrow_in_angle_is_stepped_into(model_of: Build, scheme: str, width: float) -> None:
    """Seventeen steps pass it by, and twice as many do: the way that they take tells that it is there."""
    run = simulate(model_of(narrow(width)), scheme=scheme, tolerance=1e-5, t_end=2.0)
    exact = struck(width, run.t)
    assert run.status.name == "completed"
    assert np.sqrt(np.mean((run["rod.theta"] - exact) ** 2)) < 1e-5 * exact.std()


def test_a_load_narrow_in_angle_that_steps_pass_by_is_told(model_of: Build) -> None:
    """Steps of 50 ms, and of an eighth of it, do not see the 9 ms in which it acts; without it nothing is said."""
    run = simulate(model_of(narrow(5e-3)), scheme="rk4", dt=0.05, t_end=2.0)
    assert run.status.name == "inaccurate" and "short part of the way" in str(run.status.cause)
    assert [event.kind for event in run.events] == ["load_missed"] and 0.3 < run.events[0].time < 0.5
    assert not simulate(model_of(narrow(3.0)), scheme="rk4", dt=0.05, t_end=2.0).events
