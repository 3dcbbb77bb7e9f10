"""Smooth loads that act for a moment: with a tolerance steps end within them; with steps of one length runs say it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running.pulses import PARTS, pulse_times
from runtime.schemes.switching.times import SwitchTime
from symgen.scene import Scene, SceneBuilder

Build = Callable[[Scene], Model]
AT, KICK, INERTIA = 3.337, 0.3, 0.1  # s, N m s / sqrt(pi), kg m^2


def kicked() -> Scene:
    """A rod about a pin through its centre: 0.03 cos t, and a pulse of KICK sqrt(pi) N m s about AT."""
    builder = SceneBuilder("kicked").rigid("rod", mass=1.0, inertia=INERTIA).parameter("width", 0.01)
    builder.revolute("pin", "ground.origin", "rod.origin")
    builder.torque("drive", "rod.origin", f"0.03*cos(t) + {KICK}/width*exp(-(((t - {AT})/width)**2))")
    return builder.simulation(t_end=5.0, dt=0.05, scheme="dopri5").build()


def turned(width: float, t: np.ndarray) -> np.ndarray:
    """theta'' integrated twice: the pulse by the error function."""
    x = (t - AT) / width
    erf = np.array([math.erf(one) for one in x])
    pulse = width / 2 * (math.sqrt(math.pi) * x * (1 + erf) + np.exp(-(x**2)))
    return (0.03 * (1 - np.cos(t)) + KICK * pulse) / INERTIA


@pytest.mark.parametrize(
    ("width", "settings", "off", "name"),
    [
        (1e-3, {"scheme": "dopri5", "tolerance": 1e-3}, 3e-3, "completed"),  # 0.26 off without stops, and completed
        (3e-3, {"scheme": "exponential_rk4", "tolerance": 1e-3}, 3e-3, "completed"),
        (0.1, {"scheme": "dopri5", "tolerance": 1e-3}, 3e-3, "completed"),
        (1e-3, {"scheme": "single_rate", "dt": 0.01}, 2.0, "inaccurate"),  # completed
        (1e-2, {"scheme": "rk4", "dt": 0.025}, 2.0, "inaccurate"),
    ],
)
def test_short_pulses(model_of: Build, width: float, settings: dict[str, Any], off: float, name: str) -> None:
    run = simulate(model_of(kicked()), parameters={"width": width}, **settings)
    exact = turned(width, run.t)
    true = math.sqrt(np.mean((run["rod.theta"] - exact) ** 2)) / exact.std()
    assert run.status.name == name and true < off and (true > 0.05) == (name == "inaccurate")
    assert [event.kind for event in run.events] == ["load_missed"] * (name == "inaccurate")


def test_where_steps_end_within_a_pulse() -> None:
    """A pulse of 3 ms on a slow load: 25 places from where it begins to where it ends; none for what is not short, for
    many pulses, or where steps end already."""

    def slow(t: np.ndarray) -> np.ndarray:
        return 0.3 * np.cos(t)

    def pulse(t: np.ndarray, at: float = AT) -> np.ndarray:
        return 100 * np.exp(-(((t - at) / 3e-3) ** 2))

    found = [one.time for one in pulse_times(lambda t: slow(t) + pulse(t), 0.0, 5.0, [])]
    assert len(found) == PARTS + 1 and found == sorted(found)
    assert found[0] == pytest.approx(AT - 0.012, abs=2e-3) and found[-1] == pytest.approx(AT + 0.012, abs=2e-3)
    assert pulse_times(slow, 0.0, 5.0, []) == []
    assert pulse_times(lambda t: np.sin(100 * t) ** 8, 0.0, 5.0, []) == []
    assert pulse_times(lambda t: sum(pulse(t, 0.1 + 0.2 * k) for k in range(25)), 0.0, 5.0, []) == []
    assert pulse_times(lambda t: slow(t) + pulse(t), 0.0, 5.0, [SwitchTime(AT, AT, AT, ())]) == []
