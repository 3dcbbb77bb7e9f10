"""A run that its estimate condemns is compared with a finer one: forces faster than the steps, and lost motions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, simulate
from symgen.scene import Scene, SceneBuilder

Build = Callable[[Scene], Model]
SETTINGS = {
    "single_rate": {"dt": 0.01},
    "exponential": {"dt": 0.05},
    "rk4": {"dt": 0.05},
    "dopri5": {"tolerance": 1e-2},
    "exponential_rk4": {"tolerance": 1e-2},
}


def shaken() -> Scene:
    """theta'' = 0.2 cos t + 20 sin(f t)^8 about a pin: a fast force whose mean moves the rod."""
    builder = SceneBuilder("shaken").rigid("rod", mass=1.0, inertia=0.1).parameter("f", 10.0)
    builder.revolute("pin", "ground.origin", "rod.origin")
    builder.torque("drive", "rod.origin", "0.02*cos(t) + 2*sin(f*t)**8")
    return builder.simulation(t_end=5.0, dt=0.05, scheme="rk4").build()


def turned(f: float, t: np.ndarray) -> np.ndarray:
    """sin^8 = 35/128 - 7/16 cos 2x + 7/32 cos 4x - 1/16 cos 6x + 1/128 cos 8x, integrated twice from rest."""
    found = 0.2 * (1 - np.cos(t)) + 20 * 35 / 256 * t**2
    for k, share in ((2, -7 / 16), (4, 7 / 32), (6, -1 / 16), (8, 1 / 128)):
        found += 20 * share * (1 - np.cos(k * f * t)) / (k * f) ** 2
    return found


@pytest.mark.parametrize(
    ("scheme", "f", "right"),
    [
        ("single_rate", 10.0, True),  # windows say 0.13, 2, 0.5 and 2 of the amplitude of the first four
        ("single_rate", 100.0, True),
        ("dopri5", 100.0, True),
        ("exponential_rk4", 100.0, True),
        ("rk4", 10 * np.pi, False),  # every step sees the force at its zeros and peaks only
        ("exponential", 10 * np.pi, False),
        ("single_rate", 200 * np.pi, False),  # the same force at all ends of steps, of finer ones too
    ],
)
def test_forces_faster_than_the_steps(model_of: Build, scheme: str, f: float, right: bool) -> None:
    run = simulate(model_of(shaken()), scheme=scheme, parameters={"f": f}, **SETTINGS[scheme])  # type: ignore[arg-type]
    exact = turned(f, run.t)
    off, amplitude = float(np.abs(run["rod.theta"] - exact).max()), float(np.ptp(exact) / 2)
    true = off / amplitude
    assert run.status.name == ("completed" if right else "inaccurate") and (true < 0.02 if right else true > 0.1)
    said = float(run.stats["estimated_error.rod.theta"])
    assert off / 10 < said < max(10 * off, 0.01 * amplitude) and ("remark" in run.stats) == (not right)
