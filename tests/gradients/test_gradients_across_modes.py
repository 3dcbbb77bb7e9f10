"""Derivatives of runs across changes of friction's modes and across impacts: by hand, and by differences of runs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import SCHEMES, ArgumentError, DifferentiableRun, Model, NoResult, fit, gradient, output_jacobian, simulate
from runtime.gradients import End
from symgen.scene import Scene, SceneRecord
from tests.laws.test_friction_from_scratch import LOOP, four_bar_scene

Build = Callable[[SceneRecord], Model]
ONE_LENGTH = [name for name in SCHEMES if name not in {"generalized_alpha", "hht"}]
ORDER_TWO = {"single_rate", "printed", "coupled", "exponential_midpoint"}


def ball(t_end: float, **limits: Any) -> SceneRecord:
    """1 kg that falls by 1 m along an upright rail onto a stop."""
    scene = Scene("ball").parameter("g", 9.81).parameter("e", 0.8).gravity(0.0, "-g")
    scene.rigid("ball", mass=1.0, inertia=0.1).ground(markers={"up": {"position": (0.0, 0.0), "angle": pi / 2}})
    scene.prismatic("rail", "ground.up", "ball.origin", limits={"lower": 0.0, "restitution": "e", **limits})
    return scene.initial({"ball.y": 1.0}).simulation(t_end=t_end, dt=0.05, scheme="rk4").build()


def bounced(bounces: int, t: float) -> ca.Function:
    """(g, e, h, v) -> (y, its derivatives) at t, so many bounces after a start at h with v."""
    at = ca.SX.sym("at", 4)
    g, e, h, v = ca.vertsplit(at)
    speed = ca.sqrt(v**2 + 2 * g * h)
    since = t - (v + speed) / g
    for _ in range(bounces):
        speed = e * speed
        since = since - 2 * speed / g
    since = since + 2 * speed / g
    y = speed * since - g * since**2 / 2
    return ca.Function("bounced", [at], [y, ca.jacobian(y, at)])


@pytest.mark.every_push("rk4", "single_rate", "radau")
@pytest.mark.parametrize("scheme", ONE_LENGTH)
def test_a_ball_bounces_by_hand(model_of: Build, scheme: str) -> None:
    """Five bounces, by gravity, restitution, height and speed; some of them within one step."""
    model = model_of(ball(2.7))
    y, slopes = bounced(5, 2.7)([9.81, 0.8, 1.0, 0.0])
    for mode in ("forward", "reverse"):
        found = gradient(model, End("ball.y"), ["g", "e", "ball.y", "ball.y_dot"], scheme=scheme, mode=mode)
        assert found.value == pytest.approx(float(y), abs=1e-9)
        assert found.derivatives == pytest.approx(np.asarray(slopes).ravel(), rel=1e-8)


def test_a_ball_that_has_come_to_rest_depends_on_nothing(model_of: Build) -> None:
    """Behind infinitely many bounces, that are summed."""
    found = gradient(model_of(ball(4.5)), End("ball.y"), ["g", "e", "ball.y"], dt=0.01)
    assert np.abs(found.derivatives).max() < 1e-12 and abs(found.value) < 1e-11


def test_restitution_is_fitted(model_of: Build) -> None:
    """And gravity, from places of a ball that bounces."""
    model, truth = model_of(ball(2.0)), {"g": 9.7, "e": 0.75}
    run = simulate(model, parameters=truth, seen_every=0.1)
    found = model.fit({"t": run.t, "ball.y": run["ball.y"]}, ["g", "e"], guess={"e": 0.79}, seen_every=0.1)
    assert [found[name] for name in truth] == pytest.approx(list(truth.values()), rel=1e-7)


def published() -> SceneRecord:
    """A block between plastic stops that a spring pulls to and fro until friction holds it (Modelica's Friction)."""
    scene = Scene("published").parameter("Fc", 3.0).parameter("Fs", 5.0).parameter("k", 500.0).ground()
    friction = {"coulomb": "Fc", "stribeck": "Fs", "breakaway": "1.001*(Fc + Fs)", "viscous": 1.0}
    scene.rigid("block", mass=1.0, inertia=0.1).force("spring", "block.origin", "-k*(x + 0.25)", 0.0)
    scene.prismatic("rail", "ground.origin", "block.origin", friction={**friction, "stribeck_velocity": 0.5},
                    limits={"lower": -0.4, "upper": 0.4, "restitution": 0.0})  # fmt: skip
    scene.measure("x", "x", "block.origin").rates({"block.x": -5.0})
    return scene.simulation(t_end=1.2, dt=0.001, scheme="rk4").build()


@pytest.mark.every_push("rk4", "exponential", "single_rate")
@pytest.mark.parametrize("scheme", ONE_LENGTH)
def test_a_block_that_sticks_for_good(model_of: Build, scheme: str) -> None:
    """By coulomb and spring: figures of another program, over six reversals; the start is forgotten at the stop."""
    model, close = model_of(published()), 1e-3 if scheme in ORDER_TWO else 3e-6
    found = gradient(model, End("block.x"), ["Fc", "k", "block.x_dot"], scheme=scheme)
    assert found["Fc"] == pytest.approx(-0.04051002, rel=close)
    assert found["k"] == pytest.approx(4.0737e-4, rel=max(close, 1.3e-5))
    assert abs(found["block.x_dot"]) < close


def differences(model: Model, output: str, by: Sequence[str], at: dict[str, float], **how: Any) -> np.ndarray:
    """Central ones of runs in which the same happens in the same order."""
    found, order = [], set()
    for name in by:
        ends = []
        for value in (at[name] + 2e-6, at[name] - 2e-6):
            start = name.endswith(("_dot", ".theta", ".angle"))
            run = simulate(model, error="off", **{"initial" if start else "parameters": {name: value}}, **how)
            order.add(tuple((one.kind, one.name) for one in run.events))
            ends.append(float(run[output][-1] if not output.endswith("_dot") else run.rate(output[:-4])[-1]))
        found.append((ends[0] - ends[1]) / 4e-6)
    assert len(order) == 1 and len(order.pop()) >= 2
    return np.array(found)


def arm(space: str, stops: bool, friction: bool) -> SceneRecord:
    """Two links that are driven at the first joint, and hang in the second."""
    spatial, last = space == "spatial", "ground.origin"
    scene = Scene("arm", space=space).gravity(*((0.0, "-g", 0.0) if spatial else (0.0, "-g"))).parameter("g", 9.81)
    scene.parameter("mc", 0.4).parameter("low", -1.2).parameter("e", 0.5).ground()
    for k in range(2):
        more: dict[str, Any] = {"inertia": (0.05, 0.1, 0.1)} if spatial else {"inertia": 0.1}
        tip: dict[str, Any] = (
            {"position": (1.0, 0.1, 0.2), "axis": (0.1, 0.3, 1.0)} if spatial else {"position": (1.0, 0.1)}
        )
        scene.rigid(f"l{k}", mass=1.0 + 0.3 * k, center_of_mass=(0.5, 0.03, 0.0)[: 3 if spatial else 2],
                    markers={"tip": tip}, **more)  # fmt: skip
        own: dict[str, Any] = {}
        if friction:
            own["friction"] = {"coulomb": "mc", "breakaway": "1.3*mc", "stribeck_velocity": 0.2, "viscous": 0.1}
        if stops:
            own["limits"] = {"lower": "low", "upper": 0.9, "restitution": "e"}
        scene.revolute(f"h{k}", last, f"l{k}.origin", **own)
        last = f"l{k}.tip"
    first = "h{}.angle" if spatial else "l{}.theta"
    scene.rates({first.format(0): 0.7, first.format(1): -0.4})
    scene.torque("drive", "l0.origin", "3*sin(3*t)")
    return scene.simulation(t_end=1.6, dt=0.005, scheme="rk4").build()


@pytest.mark.every_push("spatial-False-True")
@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize("stops", [True, False])
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_an_arm_against_differences(model_of: Build, space: str, stops: bool, friction: bool) -> None:
    """Up to fifty impacts and changes of mode, bounces that are summed among them; forward and reverse."""
    if not (stops or friction):
        return
    model, last = model_of(arm(space, stops, friction)), "h1.angle" if space == "spatial" else "l1.theta"
    rate = ("h0.angle" if space == "spatial" else "l0.theta") + "_dot"
    at = {"g": 9.81, "mc": 0.4, "low": -1.2, "e": 0.5, rate: 0.7, last: 0.0}
    by = ["g", *(["mc"] if friction else []), *(["low", "e"] if stops else []), rate, last]
    wanted = differences(model, last, by, at)
    for mode in ("forward", "reverse"):
        found = gradient(model, End(last), by, mode=mode).derivatives
        assert found == pytest.approx(wanted, rel=2e-5, abs=2e-6)


@pytest.mark.long
@pytest.mark.parametrize("scheme", ["rk4", "exponential"])
def test_a_four_bar_whose_joints_all_come_to_rest_at_once(model_of: Build, scheme: str) -> None:
    """Four events at one time, which stay together: of a loop that holds one motion four times.

    Saltation is by the accelerations at the event, steps are by the scheme: they agree to its order (1e-4 at 5 ms).
    """
    model = model_of(four_bar_scene(LOOP, "2.5 * sin(2 * t)"))
    by, how = ["l0.mass", "j1.friction.coulomb", "l0.theta"], {"t_end": 1.0, "dt": 1.25e-3, "scheme": scheme}
    at = {one.name: one.default for one in model.parameters} | {"l0.theta": simulate(model, t_end=0.01)["l0.theta"][0]}
    found = gradient(model, End("l0.theta"), by, **how).derivatives
    assert found == pytest.approx(differences(model, "l0.theta", by, at, **how), rel=1e-5, abs=1e-6)


def test_what_holds_lets_go_by_a_jump(model_of: Build) -> None:
    """A pull that begins at t_1, beyond what friction holds: x = (F - Fc) (t - t_1)^2 / 2 m."""
    scene = Scene("pulled").parameter("t1", 0.433, "s").parameter("F", 5.0, "N").parameter("Fc", 3.0, "N").ground()
    scene.rigid("block", mass=2.0, inertia=0.1).force("pull", "block.origin", "F * step(t - t1)", 0.0)
    scene.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": "Fc"})
    model, s = model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()), 1.0 - 0.433
    found = gradient(model, End("block.x"), ["t1", "F", "Fc", "block.mass"])
    assert found.value == pytest.approx(s**2 / 2, rel=1e-9)
    assert found.derivatives == pytest.approx([-s, s**2 / 4, -(s**2) / 4, -(s**2) / 4], rel=1e-9)


def test_what_is_held_at_the_start_forgets_its_rate(model_of: Build) -> None:
    """It slides for a time of that rate and sticks; what its impulse does to the other link is left: differences."""
    scene = Scene("held").gravity(0.0, -9.81).ground()
    scene.rigid("a", mass=1.0, center_of_mass=(0.5, 0.0), inertia=0.1, markers={"tip": {"position": (1.0, 0.0)}})
    scene.rigid("b", mass=1.0, center_of_mass=(0.5, 0.0), inertia=0.1)
    scene.revolute("base", "ground.origin", "a.origin", friction={"coulomb": 90.0}).revolute("h", "a.tip", "b.origin")
    model = model_of(scene.simulation(t_end=0.5, dt=0.005, scheme="rk4").build())
    by = ["a.theta_dot", "b.theta_dot", "a.theta"]
    found = output_jacobian(model, ["a.theta", "b.theta"], by)
    for k, name in enumerate(by):
        ends = [simulate(model, initial={name: d}, error="off").q[-1][[2, 5]] for d in (1e-5, -1e-5)]
        assert found.derivatives[-1, :, k] == pytest.approx((ends[0] - ends[1]) / 2e-5, abs=1e-4)
    assert found["a.theta", "a.theta_dot"][-1] == pytest.approx(0.0, abs=1e-12)


def balls(places: Sequence[float], walls: bool) -> SceneRecord:
    """One after the other on one rail, 1 m wide, of which the first moves; or each before a wall of its own."""
    scene, last = Scene("balls").ground().parameter("e", 1.0), "ground.origin"
    for k, x in enumerate(places):
        scene.rigid(f"b{k}", mass=1.0, inertia=0.1).initial({f"b{k}.x": x})
        ends = {"lower": -1.0} if walls else {"lower": 1.0} if k else {"upper": 50.0}
        scene.prismatic(f"r{k}", last, f"b{k}.origin", limits={**ends, "restitution": "e"})
        last = "ground.origin" if walls else f"b{k}.origin"
    scene.rates({"b0.x": -1.0, "b1.x": -1.0} if walls else {"b0.x": 2.0})
    return scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()


def test_what_has_no_derivative_is_refused_by_name(model_of: Build) -> None:
    by = ["e", "b0.x"]
    with pytest.raises(NoResult, match=r"r0.limits.lower, r1.limits.lower.*act at one time, t = 1 s, and separate"):
        gradient(model_of(balls([0.0, 0.0], walls=True)), End("b0.x"), by)
    with pytest.raises(NoResult, match="leads to several impacts at t = 1 s: which have no derivative"):
        gradient(model_of(balls([0.0, 3.0, 4.0], walls=False)), End("b0.x"), by)
    loose = Scene("loose").ground().rigid("block", mass=1.0, inertia=0.1).force("pull", "block.origin", 5.0, 0.0)
    loose.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0}).input("u", 0.0)
    model = model_of(loose.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    with pytest.raises(NoResult, match=r"by block.x_dot: differs on the two sides: rail.friction is at rest"):
        gradient(model, End("block.x"), ["block.mass", "block.x_dot"])
    assert gradient(model, End("block.x"), ["block.mass"]).derivatives == pytest.approx([-1.0], rel=1e-9)
    smooth = Scene("smooth").ground().rigid("block", mass=1.0, inertia=0.1).input("u", 1.0, filter=5.0)
    smooth.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0}).effort("f", "rail.travel", "u")
    with pytest.raises(ArgumentError, match="rates or filters change inputs too"):
        gradient(model_of(smooth.build()), End("block.x"), ["block.mass"])
    struck = {"initial": {"ball.y": 0.0, "ball.y_dot": -1.0}}
    with pytest.raises(NoResult, match="a stop is struck there"):
        gradient(model_of(ball(1.0)), End("ball.y"), ["g"], **struck)
    graze = Scene("graze").ground().rigid("m", mass=1.0, inertia=0.1).force("spring", "m.origin", "-x", 0.0)
    graze.prismatic("rail", "ground.origin", "m.origin", limits={"lower": -1.0, "restitution": 0.5})
    graze.measure("x", "x", "m.origin").initial({"m.x": 1 + 1e-11})
    with pytest.raises(NoResult, match=r"rail.limits.lower.*grazes zero at t = 3.14"):
        gradient(model_of(graze.simulation(t_end=4.0, dt=0.1, scheme="dop853").build()), End("m.x"), ["m.x"])


# ---- samples of inputs beside friction ---------------------------------------------------------------------------

TORQUES = (0.1 * np.arange(40), 9.0 * np.sin(0.2 * np.arange(40)) + 5 * np.sin(0.53 * np.arange(40) + 1) + 3)


def geared(**friction: Any) -> SceneRecord:
    """A joint with friction that holds an arm with a payload; its motor is told a torque by samples."""
    scene = Scene("payload").parameter("J", 0.4).parameter("load", 0.5).parameter("F", 1.2).input("torque", 0.0, "N m")
    tip = {"tip": {"position": [0.5, 0.0]}}
    scene.rigid("arm", mass=2.0, inertia="J", center_of_mass=(0.2, 0.0), markers=tip).gravity(0.0, -9.81)
    scene.rigid("load", mass="load", inertia=0.01).weld("grip", "arm.tip", "load.origin")
    scene.revolute("joint", "ground.origin", "arm.origin", friction={"coulomb": "F", **friction})
    scene.effort("motor", "joint.angle", "torque").initial({"arm.theta": -1.2})
    return scene.simulation(t_end=2.0, dt=0.01, scheme="rk4", seen_every=0.02).build()


@pytest.mark.long
@pytest.mark.parametrize("scheme", ["rk4", "radau", "exponential"])
def test_samples_beside_friction_against_differences(model_of: Build, scheme: str) -> None:
    """It starts and lets go at samples, turns back between them, and sticks; by parameters and by each sample."""
    times, sizes = TORQUES[0], np.where(TORQUES[0] % 1 < 0.4, 2.36 + 2.6 * np.sign(np.sin(3 * TORQUES[0])), 0.0)
    model, inputs = model_of(geared(breakaway=1.8, stribeck_velocity=0.1, viscous=0.3)), {"torque": (times, sizes)}
    call: dict[str, Any] = {"scheme": scheme, "dt": 0.005, "inputs": inputs}
    run = DifferentiableRun(model, ["arm.theta", "arm.theta_dot"], ["J", "F", "load", "torque"], **call)
    made = simulate(model, **call)
    changes = [(event.time, event.text.split(" ", 1)[1]) for event in made.events if event.kind == "mode"]
    assert changes[0] == (pytest.approx(0.1), "slides forwards") and "sticks" in [text for _, text in changes]
    assert any(min(abs(time - times)) > 1e-3 for time, _ in changes)
    np.testing.assert_allclose(run.values(run.x0)[:, 0], made["arm.theta"], atol=1e-12)
    slopes = run.jacobian(run.x0)
    for k in range(len(run.by)):
        ends = [run.values(run.x0 + sign * 1e-6 * np.eye(len(run.by))[k]) for sign in (1, -1)]
        change = (ends[0] - ends[1]) / 2e-6
        np.testing.assert_allclose(slopes.derivatives[:, :, k], change, atol=2e-5 * max(1, np.abs(change).max()))
    reverse = run.gradient(End("arm.theta"), run.x0, "reverse")
    np.testing.assert_allclose(reverse.derivatives, slopes.derivatives[-1, 0], rtol=1e-9, atol=1e-13)


def test_a_payload_is_identified_from_a_log_with_friction(model_of: Build) -> None:
    """Inertia, payload and friction from a log of another program's run: their truth, and within what noise allows."""
    model, truth = model_of(geared(viscous=0.3)), {"J": 0.4, "load": 0.5, "F": 1.2}
    log = logged(truth)
    settings: dict[str, Any] = {"inputs": {"torque": TORQUES}, "bounds": {"load": (0.0, 3.0)}}
    data = {"t": 0.02 * np.arange(101), "arm.theta": log[:, 0], "arm.theta_dot": log[:, 1]}
    guess, deviation = {"J": 0.55, "load": 0.9, "F": 0.7}, {"arm.theta": 1e-3, "arm.theta_dot": 1e-2}
    exact = fit(model, data, list(truth), guess=guess, deviation=deviation, **settings)
    np.testing.assert_allclose(exact.x, list(truth.values()), rtol=2e-6)
    noise = np.random.default_rng(3)
    for name, spread in deviation.items():
        data[name] = data[name] + noise.normal(0.0, spread, 101)
    found = fit(model, data, list(truth), guess=guess, deviation=deviation, **settings)
    assert found.converged and found.contains(truth, 0.99) and (found.standard_errors < 0.02).all()


def logged(truth: dict[str, float]) -> np.ndarray:
    """Angle and rate (101, 2) of the joint by hand and SciPy: (J + m l^2) w' = torque - weight - friction.

    Integrated from sample to sample, and from reversal to reversal; it never sticks, as the torque beyond them shows.
    """
    inertia = truth["J"] + 0.01 + 2.0 * 0.2**2 + truth["load"] * 0.5**2
    weight = 9.81 * (2.0 * 0.2 + truth["load"] * 0.5)
    grid, state, side = 0.02 * np.arange(101), np.array([-1.2, 0.0]), 0.0
    rows = [state]
    for k, t in enumerate(grid[:-1]):
        torque = TORQUES[1][int(np.floor(t / 0.1 + 1e-9))]
        end = grid[k + 1]
        while t < end:
            drive = torque - weight * np.cos(state[0])
            if state[1] == 0:
                assert abs(drive) > truth["F"]
                side = np.sign(drive)

            def rate(_: float, y: np.ndarray, torque: float = torque, side: float = side) -> list[float]:
                friction = truth["F"] * side + 0.3 * y[1]
                return [y[1], (torque - weight * np.cos(y[0]) - friction) / inertia]

            def still(time: float, y: np.ndarray, start: float = t, side: float = side) -> float:
                return float(y[1] * side if time > start + 1e-9 else 1.0)

            still.terminal, still.direction = True, -1  # type: ignore[attr-defined]
            part = solve_ivp(rate, (t, end), state, "DOP853", rtol=1e-12, atol=1e-13, events=still)
            t, state = part.t[-1], part.y[:, -1]
            if part.status == 1:
                state = np.array([state[0], 0.0])
        rows.append(state)
    return np.array(rows)
