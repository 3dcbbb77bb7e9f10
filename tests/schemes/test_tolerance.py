"""A tolerance instead of a step: what is delivered, orders between steps, stops, rejections, the least step."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from math import gamma, pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from runtime import (
    ArgumentError,
    SchemeError,
    ensemble,
    load_model,
    output_jacobian,
    reference_solution,
    resume,
    simulate,
)
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.adaptive_scheme import AdaptiveScheme
from runtime.schemes.scheme import LARGEST_NUMBER
from runtime.schemes.switching.times import SwitchTime
from symgen.scene import Scene, SceneRecord
from symgen.scenes import generated_folder
from tests.support.model_values import Array
from tests.support.prepared_runs import PreparedRuns
from tests.support.scenes import on_hinge, on_rail

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
METHODS = ("dopri5", "exponential_rk4")
LOCAL = {"error_of": "step"}


def rotor(torque: str, **simulation: object) -> SceneRecord:
    """theta'' = torque(t), with I = 1."""
    return (
        on_hinge("rotor", "rotor", "axle", mass=1.0, inertia=1.0)
        .torque("motor", "rotor.origin", torque)
        .simulation(t_end=1.0, dt=0.01, scheme="dopri5", **simulation)
        .build()
    )


@pytest.mark.parametrize("scheme", (*METHODS, "exponential", "rk4", "exponential_adams", "single_rate", "radau"))
def test_what_is_asked_is_delivered_and_told(built_in: Load, scheme: str) -> None:
    """A pendulum against order 8 in SciPy, RMS over the motion."""
    model = built_in("pendulum")
    for tolerance in (1e-2, 1e-4):
        run = simulate(model, scheme=scheme, tolerance=tolerance, t_end=4.0)
        assert run.status.ok and run.t[-1] == pytest.approx(4.0, abs=1e-12)
        exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t).q_i
        error = float(np.sqrt(np.mean((run.q_i - exact) ** 2)) / exact.std())
        assert error < tolerance
        assert error / 10 < run.error.largest < max(10 * error, 1e-9)
        assert run.stats["tolerance"] == tolerance and run.stats["rungs"] >= 3


def test_vibrations_that_all_levels_lose_are_told(built_in: Load) -> None:
    """Radau damps the rod's axial vibration within few steps: its levels agreed to 6e-5, all of them off by 5e-3."""
    run = simulate(built_in("flexible_slider_crank"), scheme="radau", tolerance=1e-3, t_end=0.1)
    exact = reference_solution(run.model, t_end=float(run.t[-1]), times=run.t).q_i
    error = np.sqrt(np.mean((run.q_i - exact) ** 2, axis=0)) / exact.std(axis=0)
    assert error.max() < 3 * run.error.largest
    assert error.max() < 3e-3 and (run.error.largest < 1e-3 or "remark" in run.stats)


@pytest.mark.parametrize(
    ("scheme", "dt", "t_end"),
    [
        ("radau", 5e-4, 0.1),
        ("radau", 2e-3, 0.3),
        ("radau", 2.5e-4, 0.3),
        ("rk4", 1e-4, 0.3),
        ("exponential_adams", 1e-3, 0.3),
    ],
)
def test_what_steps_of_one_length_damp_is_told(built_in: Load, scheme: str, dt: float, t_end: float) -> None:
    """The rod's axial vibration again, which the first twentieth of the motion told to a third to a sixth."""
    run = simulate(built_in("flexible_slider_crank"), scheme=scheme, dt=dt, t_end=t_end)
    exact = reference_solution(run.model, t_end=float(run.t[-1]), times=run.t).q_i
    error = np.sqrt(np.mean((run.q_i - exact) ** 2, axis=0)) / exact.std(axis=0)
    assert run.status.ok and run.error.largest / 2 < error.max() < 2 * run.error.largest


def test_vibrations_that_begin_late_are_told(model_of: Build) -> None:
    """x'' = -w^2 (x - cos t - a(t)) by hand, where a jumps to 0.01 at 2 s: levels agreed to 3e-6, off by 7e-3."""
    w, t_end = 200.0, 4.0
    scene = on_rail("chaser", "mass", "rail", mass=1.0, inertia=0.1)
    scene.measure("place", "x", "mass.origin").initial({"mass.x": 1.0})
    scene.force("spring", "mass.origin", f"-{w**2} * (place - cos(t) - where(t < 2.0, 0.0, 0.01))", 0.0)
    model, share = model_of(scene.simulation(t_end=t_end, dt=1e-3, scheme="rk4").build()), w**2 / (w**2 - 1)
    for settings in ({"scheme": "radau", "tolerance": 1e-3}, {"scheme": "radau", "dt": 0.02}, {"dt": 8e-3}):
        run = simulate(model, **settings)  # type: ignore[arg-type]
        exact = share * np.cos(run.t) + (1 - share) * np.cos(w * run.t)
        exact = exact + np.where(run.t > 2.0, 0.01 * (1 - np.cos(w * (run.t - 2.0))), 0.0)
        error = float(np.sqrt(np.mean((run["mass.x"] - exact) ** 2)) / exact.std())
        assert error < 3 * run.error.largest, settings
        assert run.status.ok == ("tolerance" in settings), settings  # the rate has lost a vibration of 2 m/s
        assert error < 1e-3 or not run.status.ok, settings


def test_rates_are_accurate_where_positions_hardly_tell(model_of: Build) -> None:
    """x'' = -w^2 (x - cos t) by hand: a vibration of 0.005 m within the tolerance has half of the rate."""
    scene = on_rail("chaser", "mass", "rail", mass=1.0, inertia=0.1)
    scene.measure("place", "x", "mass.origin").initial({"mass.x": 1.005})
    scene.force("spring", "mass.origin", "-40000 * (place - cos(t))", 0.0)
    model, w = model_of(scene.simulation(t_end=5.0, dt=1e-3, scheme="rk4").build()), 200.0
    run, share = simulate(model, scheme="rk4", tolerance=1e-2), w**2 / (w**2 - 1)
    exact = -share * np.sin(run.t) - (1.005 - share) * w * np.sin(w * run.t)
    assert run.status.ok and "remark" not in run.stats
    assert np.sqrt(np.mean((run.rate("mass.x") - exact) ** 2)) < 0.05 * np.sqrt(np.mean(exact**2))


@pytest.mark.parametrize("spacing", [0.02, 0.3])
def test_samples_are_as_far_apart_as_asked(built_in: Load, spacing: float) -> None:
    """dt with a tolerance is the time between samples; without one they are the steps, a thousand at most."""
    model = built_in("pendulum")
    run = simulate(model, scheme="dopri5", tolerance=1e-4, seen_every=spacing, t_end=3.0)
    assert run.t == pytest.approx(np.arange(round(3.0 / spacing) + 1) * spacing, abs=1e-12)
    free = simulate(model, scheme="single_rate", tolerance=1e-6, t_end=3.0)
    assert 300 < len(free.t) - 1 <= 1000 < free.stats["steps"]


def test_a_tolerance_that_rounding_does_not_allow_ends_in_time(built_in: Load) -> None:
    """The error stays where it is, whatever the number of steps: said, and no refinement without end."""
    run = simulate(built_in("pendulum"), scheme="dopri5", tolerance=1e-13, t_end=1.0)
    assert run.status.ok and run.stats["rungs"] < 30 and run.error.largest < 1e-10
    assert run.error.largest < 1e-13 or "do not bring it down" in str(run.stats["remark"])


def seen_inside_a_step(model: Model, scheme: str, h: float, share: float) -> tuple[Array, Array, Array]:
    """(q_i, q_i_dot) at a share of one step of h from the start, and the exact ones, one below the other."""
    runs = PreparedRuns(model, scheme, options={"tolerance": 0.1})
    assert isinstance(runs.scheme, AdaptiveScheme)
    layout, state = runs.scheme.layout, runs.state
    z = runs.stepper.start(0.0, state.q, state.q_dot, runs.c, share * h)
    z[layout.slice("h_next")] = h
    runs.stepper.run(z, runs.stepper.prepared.ready(runs.scheme.constants(runs.c, share * h, 1e9)), 1)
    assert z[layout.slice("accepted_steps")] == 1 and z[layout.slice("t_to")] == pytest.approx(h)
    fine = PreparedRuns(model, "dop853").samples(share * h / 40, 40, 40)
    exact = np.array([fine["x"][-1], fine["v"][-1]])
    return z[layout.slice("x")], z[layout.slice("v")], exact


@pytest.mark.parametrize(
    ("scheme", "order"),
    [("dopri5", 5), ("exponential_rk4", 4)],
)
def test_between_the_ends_of_a_step_the_order_is_kept(built_in: Load, scheme: str, order: int) -> None:
    """Local errors of q_i and q_i_dot inside a step fall as h^(order + 1) and h^order at least, with a loop."""
    model, h = built_in("slider_crank"), 5e-4
    errors = []
    for k in range(2):
        q, v, exact = seen_inside_a_step(model, scheme, h / 2**k, 0.37)
        errors.append([np.abs(q - exact[0]).max(), np.abs(v - exact[1]).max()])
    slopes = np.log2(np.array(errors[0]) / np.array(errors[1]))
    assert slopes[0] > order + 0.6 and slopes[1] > order - 0.4
    most = (3e-9, 1e-4) if order > 2 else (2e-8, 3e-4)
    assert errors[-1][0] < most[0] and errors[-1][1] < most[1]


@pytest.mark.parametrize("scheme", METHODS)
def test_steps_keep_their_length_while_the_error_allows_it(built_in: Load, scheme: str) -> None:
    """Of a swinging pendulum few steps have another length than the one before; none is thrown away for that."""
    runs = PreparedRuns(built_in("pendulum"), scheme, options={"tolerance": 1e-5})
    layout, dt = runs.scheme.layout, 1e-3
    z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, dt)
    lengths: list[float] = []
    for _ in range(4000):
        runs.stepper.run(z, runs.stepper.ready(runs.c, dt), 1)
        if z[layout.slice("accepted_steps")] > len(lengths):
            lengths.append(float(z[layout.slice("h_try")][0]))
    changes = int((np.diff(lengths[20:]) != 0).sum())
    assert len(lengths) > 60 and changes < 0.25 * len(lengths)
    assert z[layout.slice("rejected_steps")] <= 0.1 * len(lengths)


def test_errors_are_measured_by_amplitudes_as_they_grow(model_of: Build) -> None:
    """A vibration of 1e-3 rad on a motion that grows to 5: as many steps in one application as in 200, to a tenth."""
    model, taken = model_of(rotor("3.6*cos(60*t) + 100*t**3")), []
    for seen in (1, 200):
        runs = PreparedRuns(model, "dopri5", options={"tolerance": 1e-4})
        z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, 1.0 / seen)
        z[runs.scheme.layout.slice("h_next")] = 1e-3
        runs.stepper.run(z, runs.stepper.ready(runs.c, 1.0 / seen), seen)
        taken.append(float(z[runs.scheme.layout.slice("accepted_steps")][0]))
    assert taken[0] == pytest.approx(taken[1], rel=0.1)


@pytest.mark.parametrize("scheme", METHODS)
def test_no_step_crosses_a_stop(built_in: Load, scheme: str) -> None:
    """Thirteen stops, some closer than a step and some next to each other: each is the end of a step."""
    model = built_in("pendulum")
    stops = (0.1, 0.103, 0.5, 0.77, 0.78, 0.79, 0.8, 0.81, 1.0, 1.25, 1.5, 1.75, 1.7500001)
    plan = make_plan(model, 2.0, 1e-3, None, scheme, None, {"tolerance": 1e-4}, 0.0)
    segment = SteppedModel.of_run(model, plan, model.parameter_vector(), "auto")
    segment.switches = [SwitchTime(stop, stop, stop, ()) for stop in stops]
    z, layout = segment.start(model.initial_q, model.initial_q_dot), plan.scheme.layout
    ends = set()
    for _ in range(plan.steps):
        segment.run(z, 1)
        ends.add(float(z[layout.slice("t_to")][0]))
    assert set(stops[:-2]) <= ends
    assert z[layout.slice("h_least")] == pytest.approx(1e-7)  # from the last but one to the last
    assert len(ends) < plan.steps / 4  # what is seen does not shorten steps
    start, end = z[layout.slice("t_from")][0], z[layout.slice("t_to")][0]
    assert not any(start < stop < end for stop in stops) and z[layout.slice("breakpoints")][0] == LARGEST_NUMBER


def test_steps_end_where_a_load_jumps(model_of: Build) -> None:
    """theta'' = 1 until 0.4, then -2: found in the expression, and with a step's end there the pair is exact."""
    model = model_of(rotor("where(t < 0.4, 1.0, -2.0)"))
    plan = make_plan(model, 1.0, 0.1, None, "dopri5", None, {"tolerance": 1e-3}, 0.0)
    for found, most in ((True, 1e-13), (False, 0.1)):
        segment = SteppedModel.of_run(model, plan, model.parameter_vector(), "auto")
        segment.switches = segment.switches if found else []
        z = segment.start(model.initial_q, model.initial_q_dot)
        segment.run(z, 10)
        error = abs(float(z[plan.scheme.layout.slice("x")][0]) - (0.08 + 0.4 * 0.6 - 0.36))
        assert error < most and (error > 1e-9) == (not found)


@pytest.mark.parametrize("scheme", METHODS)
def test_a_rejected_step_is_made_as_if_it_had_not_been_tried(built_in: Load, scheme: str) -> None:
    """A first step far too long is rejected; the motion is that of a run which begins with the step then accepted."""
    runs = PreparedRuns(built_in("slider_crank"), scheme, options={"tolerance": 1e-6})
    layout, ready = runs.scheme.layout, runs.stepper.ready(runs.c, 1e-6)
    z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, 1e-6)
    other = z.copy()
    z[layout.slice("h_next")] = 0.05
    runs.stepper.run(z, ready, 1)
    assert z[layout.slice("rejected_steps")] >= 2
    other[layout.slice("h_next")] = z[layout.slice("h_least")]
    runs.stepper.run(other, ready, 1)
    assert other[layout.slice("rejected_steps")] == 0
    for name in ("q_to", "v_to", "a_from", "x", "v", "t_to"):
        np.testing.assert_array_equal(z[layout.slice(name)], other[layout.slice(name)], name)


def test_a_load_without_a_value_is_named_where_steps_shrink(model_of: Build) -> None:
    """theta'' = (0.9876543 - t)^-3 has no motion beyond that time; the load is named."""
    model = model_of(rotor("1/(0.9876543 - t)**3"))
    run = simulate(model, tolerance=1e-4, scheme="dopri5", t_end=2.0, options=LOCAL)
    assert run.status.name == "not_finite" and 0.95 < run.status.time < 0.99
    assert np.isfinite(run.q).all() and run.t[-1] == run.status.time


def test_the_least_step_ends_a_run_by_name(model_of: Build) -> None:
    """theta'' = 50 theta^3 from rest at 1 rad has no motion beyond a fifth of int_1^inf dx / sqrt(x^4 - 1)."""
    scene = Scene("blow_up").rigid("rod", mass=1.0, inertia=1.0).revolute("hinge", "ground.origin", "rod.origin")
    scene.measure("angle", "coordinate", "rod.theta").torque("motor", "rod.origin", "50 * angle**3")
    model = model_of(scene.initial({"rod.theta": 1.0}).simulation(t_end=1.0, dt=0.01).build())
    run = simulate(model, tolerance=1e-4, scheme="dopri5", options=LOCAL)
    last = gamma(0.25) ** 2 / (4 * sqrt(2 * pi)) / 5
    assert run.status.name == "step_too_short" and 0.99 * last < run.status.time <= last
    assert np.isfinite(run.q).all() and run.t[-1] == run.status.time


@pytest.mark.parametrize("scheme", METHODS)
def test_a_resumed_run_is_the_uninterrupted_one(built_in: Load, tmp_path: Path, scheme: str) -> None:
    model, path = built_in("slider_crank"), tmp_path / "run.npz"
    settings = {"scheme": scheme, "tolerance": 1e-4, "seen_every": 1e-3, "t_end": 0.06, "options": LOCAL}
    whole = simulate(model, **settings)  # type: ignore[arg-type]

    def stop(t: float, t_end: float) -> None:
        if t > 0.03:
            shutil.copy(path, tmp_path / "copy.npz")
            raise KeyboardInterrupt

    broken = simulate(model, **settings, checkpoint=path, checkpoint_every=7, progress=stop)  # type: ignore[arg-type]
    assert broken.status.name == "interrupted"
    for kept in (path, tmp_path / "copy.npz"):
        run = resume(model, kept)
        assert np.array_equal(run.q, whole.q) and np.array_equal(run.q_ddot, whole.q_ddot)
        assert run.stats["steps"] == whole.stats["steps"]


def test_both_engines_give_the_same_bits(built_in: Load) -> None:
    settings = {"scheme": "exponential_rk4", "tolerance": 1e-3, "seen_every": 0.05, "t_end": 0.5, "options": LOCAL}
    one, other = (
        simulate(built_in("hub_beam"), engine=name, **settings) for name in ("compiled-library", "interpreted")
    )  # type: ignore[arg-type]
    assert np.array_equal(one.q, other.q) and one.stats["steps"] == other.stats["steps"]


@pytest.mark.parametrize("settings", [{"tolerance": 1e-4}, {"scheme": "rk4", "dt": 1e-3}])
def test_a_run_says_what_it_took_by_part(built_in: Load, settings: dict[str, object]) -> None:
    """Steps, the time of a step, and the times around them; under a tolerance those of its levels together, too."""
    stats = simulate(built_in("double_pendulum"), t_end=1.0, **settings).stats  # type: ignore[arg-type]
    parts = ("setup_seconds", "wall_seconds", "error_seconds", "limits_seconds")
    assert all(float(stats[part]) > 0 for part in parts)
    assert float(stats["seconds_per_step"]) * int(stats["steps"]) == pytest.approx(float(stats["wall_seconds"]))
    if "tolerance" in settings:
        assert float(stats["seconds_of_all_rungs"]) > float(stats["wall_seconds"])


def test_auto_takes_the_method_that_stiffness_asks_for(built_in: Load) -> None:
    """A pendulum, a damper that dies out in a thousandth of the motion, and a stiff elastic rod."""
    plain, stiff = simulate(built_in("pendulum"), tolerance=1e-3), simulate(built_in("overdamped_joint"), scheme="auto")
    assert plain.scheme == "dopri5"
    assert stiff.scheme == "exponential_rk4"
    assert plain.status.ok and stiff.status.ok and stiff.stats["tolerance"] == 1e-3
    rod = simulate(built_in("stiff_slider_crank"), scheme="auto", t_end=0.05)
    assert rod.scheme == "exponential_rk4" and rod.status.ok


def test_modes_that_ring_are_seen_by_the_estimate(built_in: Load) -> None:
    """Undamped oscillators, the fast one released: its phase is right to the tolerance over 150 periods."""
    model, p = built_in("two_oscillators"), {"c": 0.5, "k_L": 1.0, "w": 80.0, "zeta": 0.0}
    settings = {"parameters": p, "initial": {"x_L": 1.0, "x_S": 1.0}, "t_end": 10.0, "seen_every": 0.05}
    exact = simulate(model, scheme="dop853", dt=0.001, **settings)  # type: ignore[arg-type]
    for scheme in ("exponential_rk4", "exponential"):
        run = simulate(model, scheme=scheme, tolerance=1e-3, **settings)  # type: ignore[arg-type]
        assert np.abs(run["x_S"] - exact["x_S"]).max() < 3e-3 * np.ptp(exact["x_S"])
        assert run.stats["steps"] < 2000  # h w = 0.4


def test_a_scene_may_ask_for_a_tolerance(model_of: Build) -> None:
    model = model_of(rotor("cos(6*t)", tolerance=1e-6))
    run = simulate(model)
    assert run.stats["tolerance"] == 1e-6
    theta = (1 - np.cos(6 * run.t)) / 36
    assert np.abs(run["rotor.theta"] - theta).max() < 1e-6 * np.ptp(theta)
    fixed = simulate(model, scheme="rk4")  # another scheme takes the scene's step
    assert fixed.dt == 0.01 and fixed.stats["steps"] == 100


def test_what_cannot_follow_a_tolerance_says_so(built_in: Load) -> None:
    model = built_in("pendulum")
    with pytest.raises(SchemeError, match="rk4 has no option 'error_of'"):
        simulate(model, scheme="rk4", tolerance=1e-3, options=LOCAL)
    for wrong in (0.0, -1e-3, 0.5):
        with pytest.raises(SchemeError, match="tolerance must be between 0 and 0.1"):
            simulate(model, scheme="dopri5", tolerance=wrong)
    for no_number in (True, float("nan"), "small"):
        with pytest.raises(ArgumentError, match="tolerance: cannot be .*; give a finite number"):
            simulate(model, scheme="dopri5", tolerance=no_number)  # type: ignore[arg-type]
    adaptive = {"scheme": "dopri5", "options": {"tolerance": 1e-3}}
    with pytest.raises(SchemeError, match="a stepper needs a fixed step"):
        load_model(generated_folder("pendulum")).stepper(**adaptive)
    with pytest.raises(SchemeError, match="an ensemble needs a fixed step"):
        ensemble(model, {"rod.mass": [1.0, 2.0]}, outputs=["rod.theta"], t_end=0.1, dt=0.01, **adaptive)
    with pytest.raises(SchemeError, match="a derivative of a run needs a fixed step"):
        output_jacobian(model, ["rod.theta"], ["rod.mass"], t_end=0.1, dt=0.01, **adaptive)
    with pytest.raises(SchemeError, match="exponential_adams has no option '.*exponential_rk4, dopri5 would take it"):
        simulate(model, scheme="exponential_adams", tolerance=1e-3, options=LOCAL)
    with pytest.raises(SchemeError, match="auto chooses m and options itself"):
        simulate(model, scheme="auto", options={"closure_iterations": 3})
