"""Symmetric exponential midpoint steps: order, time reversal, growth and energy of undamped motion, price."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import simulate
from runtime.contract.model import Model
from runtime.contract.tape import arithmetic
from runtime.schemes.catalogue import scheme_kind
from runtime.studies.stability.tangent import TangentStep
from symgen.scene import SceneRecord
from symgen.scenes import SCENES
from symgen.scenes.arm import arm
from tests.hand_derived.twin_subcycling import radius
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
NAME = "exponential_midpoint"
FASTEST = 2360.0  # rad/s, of the arm
RINGING = {f"link3.q{k}_dot": rate for k, rate in ((1, 0.1), (2, 0.07), (3, 0.05))}


@pytest.mark.parametrize(
    "scene, t_end, dt, cap", [("hub_beam", 0.8, 2e-2, 2e-5), ("flexible_slider_crank_torque", 0.02, 2e-4, 3e-7)]
)
def test_order_two(model_of: Build, scene: str, t_end: float, dt: float, cap: float) -> None:
    """Slope and cap of the error of q_i at t_end, with loads over time, modal damping and a loop."""
    model = model_of(SCENES[scene]())
    exact = PreparedRuns(model, "dop853").end(t_end, dt / 64)
    runs, steps = PreparedRuns(model, NAME), [dt, dt / 2, dt / 4]
    errors = [float(np.max(np.abs(runs.end(t_end, step) - exact))) for step in steps]
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(2.0, abs=0.25), errors
    assert errors[-1] < cap, errors


def test_the_way_back_is_the_way_there(model_of: Build) -> None:
    """Law: 200 steps from (q, -v) of the end lead to (q, -v) of the start; the mode turns eight times in a step."""
    runs = PreparedRuns(model_of(arm(3)), NAME)
    start, dt = runs.state.q.copy(), 50.0 / FASTEST
    there = runs.samples(dt, 200, 200)
    assert np.abs(there["x"][-1] - there["x"][0]).max() > 0.3
    z = runs.stepper.start(0.0, start, np.zeros(len(start)), runs.c, dt)
    ready, layout = runs.stepper.ready(runs.c, dt), runs.scheme.layout
    runs.stepper.run(z, ready, 200)
    z[layout.slice("v")] *= -1
    runs.stepper.run(z, ready, 200)
    assert np.abs(z[layout.slice("x")] - there["x"][0]).max() < 1e-9


@pytest.mark.parametrize("c", [0.3, 0.6])
@pytest.mark.parametrize("slow", [0.2, 0.5])
def test_undamped_oscillators_do_not_grow(model_of: Build, c: float, slow: float) -> None:
    """Law: the spectral radius is one for H w from 2 to 200, windows at multiples of pi included; slow: H w_L."""
    data = SCENES["two_oscillators"]().to_dict()
    data["partition"] = {**data["partition"], "stiff": ["x_S"]}
    model = model_of(SceneRecord.from_dict(data))
    scheme = scheme_kind(NAME).build(NAME, model, 1.0, None, {})
    tangent, growth = TangentStep(scheme), 0.0
    for reach in (*np.geomspace(2.0, 200.0, 40), *(np.pi * np.arange(1, 64, 3))):
        p = model.parameter_vector({"c": c, "w": reach / slow, "k_L": 1.0, "zeta": 0.0})
        constants = scheme.constants(model.constants(p), slow)
        z = np.asarray(scheme.starter(0.0, np.zeros(2), np.zeros(2), np.zeros(0), constants)).ravel()
        growth = max(growth, float(np.log(radius(tangent(z, constants)[1]))))
    assert growth < 1e-11, growth


@pytest.mark.parametrize("reach", [50.0, 16 * np.pi])
def test_energy_does_not_drift(model_of: Build, reach: float) -> None:
    """Swinging arm with ringing modes, undamped, 100,000 steps; `exponential_rk4` loses several times as much [J]."""
    model, steps, dt, drift = model_of(arm(3)), 100_000, reach / FASTEST, {}
    for scheme in (NAME, "exponential_rk4"):
        run = simulate(model, t_end=steps * dt, dt=dt, scheme=scheme, initial=RINGING, samples=1000)
        tenths = [part.mean() for part in np.array_split(run.total_energy, 10)]
        drift[scheme] = abs(tenths[-1] - tenths[0])
    assert drift[NAME] < 3e-5 < drift["exponential_rk4"], drift


def test_price_of_an_iteration(model_of: Build) -> None:
    """Law: O(N): 170 operations for each further link of an arm."""
    counts = []
    for links in (8, 12):
        scheme = scheme_kind(NAME).build(NAME, model_of(arm(links)), 1.0, None, {})
        counts.append({stage.name(): arithmetic(stage) for stage in scheme.program().stages()}["midpoint_iterate"])
    assert counts[1] - counts[0] <= 4 * 170 and counts[1] < 12 * 170 + 900, counts


@pytest.mark.parametrize("reach", [50.0, 17 * np.pi])
def test_every_step_on_two_masses_converges(model_of: Build, reach: float) -> None:
    """300,000 native steps at H w_L = 0.2, c = 0.6: what rounding leaves counts as arrived, and the energy stays."""
    data, dt, c, w = SCENES["two_oscillators"]().to_dict(), 0.2, 0.6, reach / 0.2
    data["partition"] = {**data["partition"], "stiff": ["x_S"]}
    runs = PreparedRuns(
        model_of(SceneRecord.from_dict(data)), NAME, parameters={"c": c, "w": w, "k_L": 1.0, "zeta": 0.0}
    )
    z = runs.stepper.start(0.0, np.array([1.0, 0.01]), np.array([0.0, 0.3]), runs.c, dt)
    layout, before = runs.scheme.layout, z.copy()

    def energy(z: np.ndarray) -> float:
        (x_L, x_S), (v_L, v_S) = z[layout.slice("x")], z[layout.slice("v")]
        return float(v_L**2 + 2 * c * v_L * v_S + v_S**2 + x_L**2 + (w * x_S) ** 2) / 2

    runs.stepper.run(z, runs.stepper.ready(runs.c, dt), 300_000)
    assert z[layout.slice("failures")][0] == 0
    assert abs(energy(z) / energy(before) - 1) < 1e-8
