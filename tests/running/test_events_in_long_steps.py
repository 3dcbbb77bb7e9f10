"""Events whose values turn within steps, so that the ends of steps look alike."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


@pytest.mark.every_push("20.0")
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
