"""Derivatives of runs: forward equals reverse, complex steps, exact solutions, differences of whole runs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, DifferentiableRun, InitialStateError, Model, gradient, output_jacobian, simulate
from runtime.gradients import End, Formula, Integral, Largest, SquaredError, passes
from symgen.scene import Scene, SceneRecord
from tests.running.test_inputs import cart
from tests.support import complex_step

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]

ROD = ["crank.tip.x", "rod.mass", "rod.M_ff[0,0]", "rod.K_ff[0,0]", "slider.mass", "crank.theta", "crank.theta_dot"]
ROD_RUNS = [
    ("single_rate", {"dt": 2e-5, "t_end": 2e-4}),
    ("printed", {"dt": 4e-5, "m": [4], "t_end": 1.6e-4}),
    ("exponential", {"dt": 2e-4, "m": [2], "t_end": 4e-4}),
]


def sliding(force: str, **parameters: float) -> SceneRecord:
    """A mass of 1 kg on a line with a force on it: its velocity is the integral of the force."""
    builder = Scene("sliding")
    for name, value in parameters.items():
        builder.parameter(name, value)
    builder.rigid("mass", mass=1.0, inertia=1.0).prismatic("line", "ground.origin", "mass.origin")
    builder.measure("place", "x", of="mass.origin")
    return builder.force("push", "mass.origin", force, 0.0).simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


@pytest.mark.parametrize("mode", ["forward", "reverse"])
@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
def test_derivatives_of_forces_that_depend_on_time(model_of: Build, scheme: str, mode: str) -> None:
    """v' = a (1 - t) + b t + c t from rest: v(1) is (a + b + c) / 2. CasADi's integrators give another reverse."""
    model = model_of(sliding("a * (1 - t) + b * t + c * t", a=1.0, b=0.5, c=0.25))
    found = gradient(model, End("mass.x_dot"), ["a", "b", "c"], scheme=scheme, mode=mode)
    np.testing.assert_allclose(found.derivatives, [0.5, 0.5, 0.5], rtol=1e-12)
    assert found.mode == mode and found.value == pytest.approx(0.875, rel=1e-12)


@pytest.mark.parametrize("scheme, settings", ROD_RUNS, ids=[scheme for scheme, _ in ROD_RUNS])
def test_forward_reverse_and_complex_step_agree(built_in: Load, scheme: str, settings: dict) -> None:
    """Of the freely running slider-crank, through loops, start, constants(p), sub-steps and the printed iteration."""
    model = built_in("flexible_slider_crank_free")
    run = DifferentiableRun(
        model, ["rod.q1", "slider.x_ddot"], ROD, scheme=scheme, seen_every=2 * model.simulation["dt"], **settings
    )
    objective = Formula(run.outputs, lambda t, y: y["rod.q1"][-1] * 1e6 + 1e-3 * (t * y["slider.x_ddot"]).T @ t)
    forward, reverse = (run.gradient(objective, run.x0, mode=mode) for mode in ("forward", "reverse"))
    scale = np.abs(forward.derivatives).max()
    np.testing.assert_allclose(reverse.derivatives, forward.derivatives, rtol=0, atol=1e-12 * scale)
    jacobian = run.jacobian(run.x0)
    for name in ("crank.tip.x", "crank.theta_dot"):
        exact = complex_step.derivatives(run, name)
        for k, output in enumerate(run.outputs):
            limit = 1e-9 * np.abs(exact[:, k]).max()
            np.testing.assert_allclose(jacobian[output, name], exact[:, k], rtol=0, atol=limit)


def test_outputs_are_those_of_the_simulation(built_in: Load) -> None:
    model = built_in("four_bar")
    names = ["coupler.theta", "crank.theta_dot", "rocker.theta_ddot", "kinetic"]
    names += [f"{model.joints[0]}.force_x", f"lam.{model.constraints[0]}"]
    found = output_jacobian(model, names, ["crank.mass"], t_end=0.05, seen_every=50 * model.simulation["dt"])
    whole = simulate(model, t_end=0.05, seen_every=50 * model.simulation["dt"])
    np.testing.assert_allclose(found.t, whole.t, rtol=1e-15)
    for k, name in enumerate(names):
        expected = whole.energy["kinetic"] if name == "kinetic" else whole[name]
        np.testing.assert_allclose(found.values[:, k], expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max())


def test_the_assembly_of_the_start_is_differentiated(built_in: Load) -> None:
    """Four-bar with the rocker's angle and rate given, which the crank follows: against differences of simulations."""
    model = built_in("four_bar")
    by = ["coupler.tip.x", "rocker.theta", "rocker.theta_dot"]
    run = DifferentiableRun(model, ["crank.theta"], by, t_end=0.05, seen_every=50 * model.simulation["dt"])
    found = run.gradient(End("crank.theta"), run.x0)

    def end(x: np.ndarray) -> float:
        given = {"rocker.theta": x[1], "rocker.theta_dot": x[2]}
        done = simulate(
            model, t_end=0.05, seen_every=50 * model.simulation["dt"], parameters={"coupler.tip.x": x[0]}, initial=given
        )
        return float(done["crank.theta"][-1])

    for k in range(3):
        ends = {n: end(run.x0 + 1e-4 * n * np.eye(3)[k]) for n in (-2, -1, 1, 2)}
        difference = (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / 12e-4
        assert found.derivatives[k] == pytest.approx(difference, rel=1e-7)


def test_a_long_run_keeps_the_square_root_of_its_steps(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """In segments from kept states, the same derivatives bit for bit; four times the steps, twice the memory."""
    model, by = built_in("hub_beam"), ["beam.youngs_modulus", "hub.inertia", "hub.theta_dot"]
    objective = Integral("tip_y", squared=True)

    def reverse() -> np.ndarray:  # by the best code from the first step: bits of the first code are others
        run = DifferentiableRun(model, ["tip_y"], by, t_end=0.3, seen_every=7e-3, wait=True)
        return run.gradient(objective, run.x0, mode="reverse").derivatives

    whole = reverse()
    monkeypatch.setattr(passes, "TAPE_NUMBERS", 0)
    kept = []
    for steps in (100, 400, 1600):
        run = DifferentiableRun(model, ["tip_y"], by, t_end=steps * 1e-3, seen_every=7e-3)
        backward = run._backward
        kept.append(len(backward.parts) * run.program.active.z_size + backward.longest * backward.stepping.records)
        if steps == 400:
            np.testing.assert_array_equal(reverse(), whole)
            assert len(backward.parts) > 3
    assert kept[1] < 2.2 * kept[0] and kept[2] < 2.2 * kept[1]


def test_objectives_have_the_derivatives_of_their_values() -> None:
    """By differences, of every ready-made objective."""
    rng = np.random.default_rng(1)
    t, y = np.linspace(0.0, 2.0, 9), rng.normal(size=(9, 1))
    data = np.where(np.arange(9) == 4, np.nan, rng.normal(size=9))
    spread = np.where(np.isnan(data), np.inf, 0.3)
    for one in (End("y"), Integral("y"), Integral("y", True), SquaredError("y", data, spread), Largest("y")):
        value, slope = one.weighed(t, y)
        for k in range(9):
            moved = [one.weighed(t, y + s * 1e-6 * np.eye(9)[:, k : k + 1])[0] for s in (-1, 1)]
            assert slope[k, 0] == pytest.approx((moved[1] - moved[0]) / 2e-6, rel=1e-6, abs=1e-8), one
    assert Integral("y").weighed(t, t[:, None])[0] == pytest.approx(2.0)


@pytest.mark.parametrize("phase", [0.1, 0.37, 0.55, 0.8])
def test_a_largest_value_is_that_of_the_curve_and_not_of_a_sample(phase: float) -> None:
    """A sin(2 pi t + phase) with 20 samples a period has the peak A, by A the slope 1, by the phase none.

    Its largest sample is up to 1.2 % lower, and moves with the phase by up to 0.16 A.
    """
    t, A = np.linspace(0.0, 1.0, 21), -0.3
    value, slope = Largest("y").weighed(t, A * np.sin(2 * np.pi * t + phase)[:, None])
    assert value == pytest.approx(0.3, rel=3e-4)
    assert slope[:, 0] @ np.sin(2 * np.pi * t + phase) == pytest.approx(-1.0, rel=3e-4)
    assert slope[:, 0] @ (A * np.cos(2 * np.pi * t + phase)) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize(
    "y", [[0.0, 0, 1, 1, 1], [0, 1, 0, 1, 0.5], [0, 0, 2, 0, 0], [1, 2, 3, 4, 6], [6, 4, 3, 1, 1], [2, 2, 2, 2, 2]]
)
def test_a_largest_value_at_a_jump_a_spike_or_an_end_is_the_sample(y: list[float]) -> None:
    value, slope = Largest("y").weighed(np.arange(5.0), np.array(y)[:, None])
    assert value == max(y)
    assert slope[:, 0].tolist() == (np.arange(5) == np.argmax(y)).tolist()


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_scheme_has_a_way_back(built_in: Load, scheme: str) -> None:
    """By a stiffness, a mass and a start, of two coupled oscillators; the run is that of a simulation bit for bit."""
    model = built_in("two_oscillators")
    masses = [parameter.name for parameter in model.parameters if parameter.kind != "data"][:2]
    by, names = [*masses, model.q_i[0], f"{model.q_i[1]}_dot"], list(model.q_i)
    run = DifferentiableRun(model, names, by, scheme=scheme, dt=1e-3, t_end=8e-3, seen_every=0.004)
    objective = Formula(run.outputs, lambda t, y: 1e3 * y[names[0]][-1] + (t * y[names[1]]).T @ t)
    forward, reverse = (run.gradient(objective, run.x0, mode=mode).derivatives for mode in ("forward", "reverse"))
    np.testing.assert_allclose(reverse, forward, rtol=0, atol=1e-12 * np.abs(forward).max())
    assert np.abs(forward).min() > 0
    whole = simulate(model, scheme=scheme, dt=1e-3, t_end=8e-3, seen_every=0.004)
    np.testing.assert_array_equal(run.values(run.x0), whole.q_i)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_complex_steps_confirm_every_scheme(built_in: Load, scheme: str) -> None:
    """An arm of two links with elastic joints: by a mass, an angle and a rate, none of which acts linearly."""
    by, names = ["link2.mass", "link1.theta", "rotor2.theta_dot"], ["link1.theta_dot", "link2.theta_dot"]
    initial = {"link1.theta": 0.4, "rotor1.theta": 0.39, "link1.theta_dot": 3.0, "link2.theta_dot": -5.0}
    settings = {"dt": 4e-4, "t_end": 8e-4, "seen_every": 0.0008, "initial": initial}
    run = DifferentiableRun(built_in("flexible_joint_arm"), names, by, scheme=scheme, **settings)
    jacobian = run.jacobian(run.x0)
    for name in by:
        exact = complex_step.derivatives(run, name, initial)
        for k, output in enumerate(names):
            limit = 1e-9 * np.abs(exact[:, k]).max()
            np.testing.assert_allclose(jacobian[output, name], exact[:, k], rtol=0, atol=limit)
        assert np.abs(exact).max() > 0


def test_a_quasi_static_start_moves_with_its_parameters(built_in: Load) -> None:
    """Equilibrium of the rod and its rate, by parameters and rigid coordinates: against sixth-order differences."""
    model, by = built_in("flexible_slider_crank_free"), ["crank.tip.x", "slider.mass", "crank.theta", "crank.theta_dot"]
    settings = {
        "dt": 2e-5,
        "t_end": 2e-4,
        "seen_every": 0.0002,
        "start": "quasi_static",
        "initial": {"crank.theta": 0.7},
    }
    run = DifferentiableRun(model, ["rod.q1", "rod.q1_dot"], by, **settings)
    slopes = run.jacobian(run.x0).derivatives
    weights = {-3: -1 / 60, -2: 3 / 20, -1: -3 / 4, 1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    for k, value in enumerate(run.x0):
        h = 1e-3 * abs(value)
        difference = sum(w * run.values(run.x0 + n * h * np.eye(4)[k]) for n, w in weights.items()) / h
        np.testing.assert_allclose(slopes[:, :, k], difference, rtol=1e-7, atol=1e-9 * np.abs(difference).max())


def test_the_start_of_a_free_body_is_turned_further(built_in: Load) -> None:
    """By its turns, one rotation vector in its axes, and its angular velocity there, against differences."""
    model, e = built_in("tumbling_body"), [f"body.e{k}" for k in range(4)]
    by = [f"body.{name}_{axis}" for name in ("turn", "omega") for axis in "xyz"]
    run = DifferentiableRun(model, [*e, "body.e1_dot", "body.x"], by, t_end=0.3, dt=0.01, scheme="rk4", samples=2)
    x = run.x0 + [0.4, -0.3, 0.9, 0.5, 0.2, -1.0]
    found, steps = run.jacobian(x).derivatives, 1e-5 * np.eye(6)
    for k, step in enumerate(steps):
        change = (run.values(x + step) - run.values(x - step)) / 2e-5
        assert found[:, :, k] == pytest.approx(change, abs=1e-8)


def test_a_start_by_euler_angles_is_not_turned_further(model_of: Build) -> None:
    scene = Scene("angles", space="spatial").rigid("body", mass=1.0, inertia=[1.0] * 3, free=True, orientation="zyx")
    with pytest.raises(InitialStateError, match=r"theta1.*Euler parameters"):
        gradient(model_of(scene.build()), End("body.e1"), ["body.turn_x"], t_end=0.1, initial={"body.theta1": 0.1})


def test_inputs_are_parameters_of_a_run(model_of: Build) -> None:
    """2 kg pushed by an input: x(1) = F / (2 m) for a constant one, (1 - sin(2) / 2) / (2 m) for sin(2 t)."""
    model = model_of(cart())
    for mode in ("forward", "reverse"):
        held = gradient(model, End("cart.x"), ["force", "cart.mass"], inputs={"force": 3.0}, mode=mode)
        np.testing.assert_allclose(held.derivatives, [1 / 4, -3 / 8], rtol=1e-11)
        wave = gradient(model, End("cart.x"), ["cart.mass"], inputs={"force": lambda t: np.sin(2 * t)}, mode=mode)
        assert wave["cart.mass"] == pytest.approx(-(1 - np.sin(2.0) / 2) / 8, rel=1e-9)


@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "exponential"])
def test_a_held_input_has_a_derivative_for_each_sample(model_of: Build, scheme: str, monkeypatch) -> None:
    """2 kg pushed by f_k in a time h_k: x(1) = sum f_k h_k (time left from its middle on) / m, whatever f is."""
    model, times = model_of(cart()), [0.0, 0.25, 0.5, 0.75, 2.0]
    force, settings = (times, [1.0, -2.0, 0.5, 3.0, 9.0]), {"scheme": scheme, "seen_every": 0.3}
    exact = 0.25 * (1 - np.arange(0.125, 1, 0.25)) / 2
    run = DifferentiableRun(model, ["cart.x"], ["force"], inputs={"force": force}, **settings)
    assert run.by == ("force[0]", "force[1]", "force[2]", "force[3]")
    one, other = (run.gradient(End("cart.x"), run.x0, mode=mode).derivatives for mode in ("forward", "reverse"))
    rounded = 4e-15 * 1000  # steps: the partial fractions of phi add up to 1 within some 1e-15
    np.testing.assert_allclose(other, one, rtol=rounded)
    np.testing.assert_allclose(one, exact, rtol=1e-11)
    assert run.gradient(End("cart.x"), run.x0).value == pytest.approx(float(one @ run.x0), rel=1e-12)  # it is linear
    whole = simulate(model, inputs={"force": force}, **settings)
    np.testing.assert_allclose(run.values(run.x0)[:, 0], whole["cart.x"], rtol=1e-14)
    monkeypatch.setattr(passes, "TAPE_NUMBERS", 0)
    again = DifferentiableRun(model, ["cart.x"], ["force[3]", "cart.mass"], inputs={"force": force}, **settings)
    assert again.gradient(End("cart.x"), again.x0, mode="reverse")["force[3]"] == other[3]


def test_angular_velocities_have_derivatives(built_in: Load) -> None:
    """Those of a tumbling body, against central differences of its runs."""
    how: dict[str, Any] = {"t_end": 0.5, "dt": 0.01, "scheme": "rk4", "samples": 5}
    run = DifferentiableRun(
        built_in("tumbling_body"), ["body.omega_x", "body.omega_z"], ["body.inertia.xx", "body.omega_y"], **how
    )
    found, h = run.jacobian(run.x0).derivatives, 1e-5
    for k, step in enumerate(h * np.eye(2)):
        differences = (run.values(run.x0 + step) - run.values(run.x0 - step)) / (2 * h)
        np.testing.assert_allclose(found[:, :, k], differences, atol=1e-9)
