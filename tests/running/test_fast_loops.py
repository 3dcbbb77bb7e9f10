"""Loops that speed up: a slider-crank driven by a constant torque, run up from rest without end.

What is right comes from the energy of one freedom, I(theta) theta_dot^2 / 2 = T (theta - theta_0), with the inertia I
of crank, rod and slider reduced to the crank by hand, and from t = int d theta / theta_dot.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
START = 1.0  # rad
CRANK, ROD, SLIDER = 0.1, 0.01, 0.3  # inertias of crank and rod [kg m^2], mass of the slider [kg]


def slider_crank(r: float = 0.1, length: float = 0.3) -> SceneRecord:
    """Crank of length r, rod and slider; nothing but a torque T acts, and no scheme is named."""
    scene = Scene("run_up").parameter("T", 10.0)
    scene.rigid("c", mass=1.0, inertia=CRANK, markers={"tip": {"position": [r, 0]}})
    scene.rigid(
        "rod", mass=0.5, inertia=ROD, center_of_mass=(length / 2, 0), markers={"tip": {"position": [length, 0]}}
    )
    scene.rigid("sl", mass=SLIDER, inertia=1e-3).revolute("a", "ground.origin", "c.origin")
    scene.revolute("b", "c.tip", "rod.origin").revolute("e", "rod.tip", "sl.origin")
    scene.prismatic("g", "ground.origin", "sl.origin").torque("m", "c.origin", "T")
    return scene.initial({"c.theta": START}).build()


def reduced_inertia(theta: np.ndarray, r: float, length: float) -> np.ndarray:
    """I(theta) [kg m^2] by the velocities of rod and slider at a unit rate of the crank."""
    s, c = np.sin(theta), np.cos(theta)
    phi = -r * c / np.sqrt(length**2 - (r * s) ** 2)  # rate of the rod's angle, sin(phi) = -r sin(theta) / length
    sin_phi = -r * s / length
    cos_phi = np.sqrt(1 - sin_phi**2)
    x_rod, y_rod = -r * s - length / 2 * sin_phi * phi, r * c + length / 2 * cos_phi * phi
    x_slider = -r * s - length * sin_phi * phi
    return np.asarray(CRANK + 0.5 * (x_rod**2 + y_rod**2) + ROD * phi**2 + SLIDER * x_slider**2)


def exact_end(T: float, t_end: float, r: float = 0.1, length: float = 0.3) -> tuple[float, float]:
    """(theta, theta_dot) at t_end: t(u) = int sqrt(2 I / T) du with u = sqrt(theta - START), by Gauss, turn by turn."""
    nodes, weights = np.polynomial.legendre.leggauss(64)

    def passed(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """Time from u = a to u = b [s]."""
        u = (a + b)[:, None] / 2 + (b - a)[:, None] / 2 * nodes
        return (b - a) / 2 * (np.sqrt(2 * reduced_inertia(START + u**2, r, length) / T) @ weights)

    turns = np.sqrt(2 * np.pi * np.arange(3 + T * t_end**2 / (2 * CRANK * 2 * np.pi)))
    times = np.concatenate([[0.0], np.cumsum(passed(turns[:-1], turns[1:]))])
    n = int(np.searchsorted(times, t_end)) - 1

    def missing(u: float) -> float:
        return float(times[n] + passed(turns[n : n + 1], np.array([u]))[0] - t_end)

    u = brentq(missing, turns[n], turns[n + 1], xtol=1e-13)
    theta = START + u**2
    return theta, float(np.sqrt(2 * T * u**2 / reduced_inertia(np.array(theta), r, length)))


@pytest.fixture(scope="module")
def model(model_of: Build) -> Model:
    return model_of(slider_crank())


def test_the_exact_end_is_that_of_the_issue() -> None:
    assert exact_end(10.0, 5.0)[1] == pytest.approx(475.859, abs=1e-3)


def assert_right(run: Any, T: float, t_end: float, far: float) -> None:
    """The angle at the end, relative; and the rate there by the energy."""
    theta, _ = exact_end(T, t_end)
    assert run.status.name == "completed", run.status
    assert run["c.theta"][-1] == pytest.approx(theta, rel=far)
    energy = reduced_inertia(run["c.theta"], 0.1, 0.3) * run["c.theta_dot"] ** 2 / 2
    assert np.abs(energy - T * (run["c.theta"] - START)).max() < far * energy.max()


@pytest.mark.every_push("10.0-10.0")
@pytest.mark.parametrize("t_end", [1.0, 5.0, 10.0, 20.0])
@pytest.mark.parametrize("T", [1.0, 2.0, 3.0, 5.0, 10.0, 100.0])
def test_a_slider_crank_is_run_up_by_the_default_call(model: Model, T: float, t_end: float) -> None:
    """To 19,000 rad/s. Whether it came to its end hung on torque and end like a lottery: constraints_lost."""
    assert_right(simulate(model, t_end=t_end, parameters={"T": T}), T, t_end, 1e-3)


@pytest.mark.every_push("call0")
@pytest.mark.parametrize(
    "call",
    [
        {"tolerance": 1e-9},
        {"scheme": "dopri5", "tolerance": 1e-6},
        {"scheme": "radau", "tolerance": 1e-6},
        {"samples": 7},
    ],
)
def test_loops_that_speed_up_meet_any_tolerance(model: Model, call: dict[str, Any]) -> None:
    tolerance = call.get("tolerance", 1e-3)
    run = simulate(model, t_end=5.0, **call)
    assert_right(run, 10.0, 5.0, max(tolerance, 1e-7))
    assert run["c.theta_dot"][-1] == pytest.approx(475.859198, rel=max(tolerance, 1e-7))


@pytest.mark.every_push("0.01-exponential_rk4")
@pytest.mark.parametrize("scheme", ["dopri5", "exponential_rk4"])
@pytest.mark.parametrize("tolerance", [0.1, 1e-2, 1e-3])
def test_a_step_whose_loops_do_not_close_is_made_again(model_of: Build, scheme: str, tolerance: float) -> None:
    """A rod hardly longer than the crank: steps of their own error went on until a loop was lost. What they give may be
    inaccurate, and says so."""
    model = model_of(slider_crank(0.1, 0.11))
    run = simulate(model, scheme=scheme, tolerance=tolerance, t_end=3.0, options={"error_of": "step"})
    assert run.status.whole, run.status
    theta, _ = exact_end(10.0, 3.0, 0.1, 0.11)
    off = abs(run["c.theta"][-1] - theta) / float(np.sqrt(np.mean(np.square(run["c.theta"]))))
    assert run.error.largest > 0.1 * off


@pytest.mark.long
def test_a_drive_beyond_the_lengths_is_lost_constraints_whatever_chooses_the_step(model_of: Build) -> None:
    """A slider is drawn to 0.5 m by two rods that reach 0.4 m, at 0.1 m/s from 0.35 m; the step has no part in it."""
    scene = Scene("reach").ground(markers={"along": {"position": [0, 0]}})
    scene.rigid("c", mass=1.0, inertia=0.1, markers={"tip": {"position": [0.1, 0]}})
    scene.rigid("rod", mass=0.5, inertia=0.01, center_of_mass=(0.15, 0), markers={"tip": {"position": [0.3, 0]}})
    scene.rigid("sl", mass=0.3, inertia=1e-3).rigid("bob", mass=0.1, inertia=0.01, center_of_mass=(0.1, 0))
    scene.revolute("a", "ground.origin", "c.origin").revolute("b", "c.tip", "rod.origin")
    scene.revolute("e", "rod.tip", "sl.origin").prismatic("g", "ground.origin", "sl.origin")
    scene.prescribed_displacement("d", "ground.along", "sl.origin", "0.35 + 0.1*t").revolute(
        "h", "sl.origin", "bob.origin"
    )
    scene.gravity(0, -9.81).initial({"c.theta": 0.8})
    model = model_of(scene.build())
    for call in ({}, {"tolerance": 1e-6}, {"scheme": "dopri5", "tolerance": 1e-4, "options": {"error_of": "step"}}):
        run = simulate(model, t_end=1.5, **call)
        assert run.status.name in ("constraints_lost", "branch_lost"), (call, run.status)
        assert run.status.time == pytest.approx(0.5, abs=0.02), call
