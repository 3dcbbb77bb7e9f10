"""Loads that coarse trials do not see: how many steps do, and what runs to a tolerance make of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running.load_steps import steps_that_see_loads
from runtime.schemes.switching.times import switching_times
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
PULSE, AT, WIDTH = 5.0, 3.33, 0.002


def rotor(torque: str) -> SceneRecord:
    """theta'' = torque(t), with I = 1."""
    builder = Scene("rotor").rigid("rotor", mass=1.0, inertia=1.0)
    builder.revolute("axle", "ground.origin", "rotor.origin").torque("motor", "rotor.origin", torque)
    return builder.simulation(t_end=10.0, dt=0.1, scheme="rk4").build()


def steps(model: Model) -> int:
    c = model.constants(model.parameter_vector())
    state = start_state(model, model.parameter_vector(), c, 0.0, None, None)
    return steps_that_see_loads(model, c, state, 0.0, 10.0, switching_times(model, c, 0.0, 10.0))


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


@pytest.mark.parametrize("scheme", ["dopri5", "exponential_rk4", "auto"])
def test_a_pulse_shorter_than_coarse_steps_is_not_missed(model_of: Build, scheme: str) -> None:
    """A pulse of 3 ms in 10 s of slow motion gives the speed its integral, A w sqrt(pi); trials of 24 steps miss it."""
    model = model_of(rotor(f"0.1*cos(t) + {PULSE}*exp(-((t - {AT})/{WIDTH})**2)"))
    run = simulate(model, scheme=scheme, tolerance=1e-3)
    after = run.t > AT + 0.1
    given = run.rate("rotor.theta")[after] - 0.1 * np.sin(run.t[after])
    assert given == pytest.approx(PULSE * WIDTH * np.sqrt(np.pi), rel=0.02)
