"""Smooth loads that act for a moment: steps end within them; where they are too many, runs say it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.contract.consistent_state import ConsistentState
from runtime.running.time_functions import LOAD_PARTS, all_stops, pulse_times, pulses
from runtime.schemes.switching.times import SwitchTime
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_hinge

Build = Callable[[SceneRecord], Model]
AT, KICK, INERTIA = 3.337, 0.3, 0.1  # s, N m s / sqrt(pi), kg m^2


def kicked() -> SceneRecord:
    """A rod about a pin through its centre: 0.03 cos t, and a pulse of KICK sqrt(pi) N m s about AT."""
    builder = Scene("kicked").rigid("rod", mass=1.0, inertia=INERTIA).parameter("width", 0.01)
    builder.revolute("pin", "ground.origin", "rod.origin")
    builder.torque("drive", "rod.origin", f"0.03*cos(t) + {KICK}/width*exp(-(((t - {AT})/width)**2))")
    return builder.simulation(t_end=5.0, dt=0.05, scheme="dopri5").build()


def rod(torque: str) -> SceneRecord:
    """A rod about a pin through its centre, at rest."""
    builder = on_hinge("rod", "rod", "pin", mass=1.0, inertia=INERTIA).measure("turn", "coordinate", "rod.theta")
    return builder.torque("drive", "rod.origin", torque).simulation(t_end=5.0, dt=0.05, scheme="dopri5").build()


def turned(width: float, t: np.ndarray) -> np.ndarray:
    """theta'' integrated twice: the pulse by the error function."""
    x = (t - AT) / width
    erf = np.array([math.erf(one) for one in x])
    pulse = width / 2 * (math.sqrt(math.pi) * x * (1 + erf) + np.exp(-(x**2)))
    return (0.03 * (1 - np.cos(t)) + KICK * pulse) / INERTIA


@pytest.mark.every_push("0.01-settings4-0.001", "0.001-settings3-0.02")
@pytest.mark.parametrize(
    ("width", "settings", "off"),
    [
        (1e-3, {"scheme": "dopri5", "tolerance": 1e-3}, 1e-3),  # 0.26 off without stops
        (3e-3, {"scheme": "exponential_rk4", "tolerance": 1e-3}, 1e-3),
        (0.1, {"scheme": "dopri5", "tolerance": 1e-3}, 1e-3),
        (1e-3, {"scheme": "single_rate", "dt": 0.01}, 0.02),  # 0.9 without
        (1e-2, {"scheme": "rk4", "dt": 0.025}, 1e-3),
    ],
)
def test_short_pulses(model_of: Build, width: float, settings: dict[str, Any], off: float) -> None:
    run = simulate(model_of(kicked()), parameters={"width": width}, **settings)
    exact = turned(width, run.t)
    true = math.sqrt(np.mean((run["rod.theta"] - exact) ** 2)) / exact.std()
    assert run.status.name == "completed" and true < off
    assert (true < 1e-6 or true / 10 < run.error.largest) and run.error.largest < max(10 * true, 1e-6)


@pytest.mark.long
def test_a_pulse_that_the_motion_makes_a_load(model_of: Build) -> None:
    """theta'' = 1 - B(t) theta' from rest, a brake of 4 ms: it leaves exp(-sqrt(pi)) of the speed AT, and none is felt
    at the start."""
    model = model_of(rod(f"{INERTIA}*(1 - 500*exp(-(((t - {AT})/2e-3)**2))*turn_dot)"))
    left = AT * math.exp(-math.sqrt(math.pi)) + 5.0 - AT
    run = simulate(model, scheme="dopri5", tolerance=1e-2)
    assert run.status.ok and run.rate("rod.theta")[-1] == pytest.approx(left, rel=3e-3)
    run = simulate(model, scheme="rk4", dt=0.04)
    assert run.status.ok and run.rate("rod.theta")[-1] == pytest.approx(left, rel=3e-3)


def test_pulses_are_those_at_the_start_of_the_run(model_of: Build) -> None:
    """A pulse that acts about theta = 1 only: found where the run starts there."""
    model = model_of(rod(f"exp(-(((t - {AT})/5e-3)**2) - ((turn - 1)/0.01)**2)"))
    c = model.constants(model.parameter_vector())
    for place, count in ((0.0, 0), (1.0, LOAD_PARTS + 1)):
        q = model.initial_q.copy()
        q[model.coordinates.index("rod.theta")] = place
        state = ConsistentState(q, model.initial_q_dot, {})
        assert len(all_stops(model, c, 0.0, 5.0, state)) == count
    run = simulate(model, scheme="dopri5", tolerance=1e-3, initial={"rod.theta": 1.0})
    assert run.rate("rod.theta")[-1] == pytest.approx(5e-3 * math.sqrt(math.pi) / INERTIA, rel=0.01)


@pytest.mark.long
def test_a_pulse_that_an_eighth_of_the_step_misses_too(model_of: Build) -> None:
    """It lies four widths from the nearest of those points; steps end within it."""
    run = simulate(model_of(rod(f"0.1 + 1000*exp(-(((t - {AT})/2.5e-4)**2))")), scheme="rk4", dt=0.048)
    given = 0.25 * math.sqrt(math.pi) + 0.1 * run.t[-1]
    assert run.status.ok and run.rate("rod.theta")[-1] == pytest.approx(given / INERTIA, rel=1e-3)


def test_loads_that_no_finer_motion_shows(model_of: Build) -> None:
    """Twenty pulses, too many to end steps within, too short for an eighth of the step."""
    torque = "+".join(f"exp(-(((t - {0.2003 + 0.2309 * k})/2.5e-4)**2))" for k in range(20))
    run = simulate(model_of(rod(f"0.1 + 100*({torque})")), scheme="rk4", dt=0.048)
    assert run.status.name == "inaccurate" and "between the steps" in str(run.status.cause)


def test_where_steps_end_within_a_pulse() -> None:
    """A pulse of 3 ms on a slow load: 25 places from where it begins to where it ends; none for what is not short, for
    many pulses, or where steps end already."""

    def slow(t: np.ndarray) -> np.ndarray:
        return 0.3 * np.cos(t)

    def pulse(t: np.ndarray, at: float = AT) -> np.ndarray:
        return 100 * np.exp(-(((t - at) / 3e-3) ** 2))

    def times(forces: Callable[[np.ndarray], np.ndarray], *known: SwitchTime) -> list[float]:
        return [one.time for one in pulse_times(pulses(lambda t: np.atleast_2d(forces(t)), 0.0, 5.0), 0.0, 5.0, known)]

    found = times(lambda t: slow(t) + pulse(t))
    assert len(found) == LOAD_PARTS + 1 and found == sorted(found)
    assert found[0] == pytest.approx(AT - 0.012, abs=2e-3) and found[-1] == pytest.approx(AT + 0.012, abs=2e-3)
    assert times(slow) == []
    assert times(lambda t: np.sin(100 * t) ** 8) == []
    assert times(lambda t: sum(pulse(t, 0.1 + 0.2 * k) for k in range(25))) == []
    assert times(lambda t: slow(t) + pulse(t), SwitchTime(AT, AT, AT, ())) == []
