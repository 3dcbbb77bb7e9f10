"""Derivatives of runs across changes of friction's modes and across impacts: by hand, and by differences of runs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi
from typing import Any

import casadi as ca
import numpy as np
import pytest

from runtime import Model, gradient, output_jacobian, simulate
from runtime.contract.errors import ArgumentError, NoResult
from runtime.gradients.objectives import End
from runtime.schemes.catalogue import SCHEMES
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


@pytest.mark.every_push("planar-True-True", "spatial-False-True")
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
    with pytest.raises(NoResult, match=r"r0.limits.lower, r1.limits.lower.*act at one time, t = 1 s, and move apart"):
        gradient(model_of(balls([0.0, 0.0], walls=True)), End("b0.x"), by)
    with pytest.raises(NoResult, match="impacts that follow one another at t = 1 s: they have no derivative"):
        gradient(model_of(balls([0.0, 3.0, 4.0], walls=False)), End("b0.x"), by)
    loose = Scene("loose").ground().rigid("block", mass=1.0, inertia=0.1).force("pull", "block.origin", 5.0, 0.0)
    loose.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0}).input("u", 0.0)
    model = model_of(loose.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    with pytest.raises(NoResult, match=r"by block.x_dot: is another to each side: rail.friction is at rest"):
        gradient(model, End("block.x"), ["block.mass", "block.x_dot"])
    assert gradient(model, End("block.x"), ["block.mass"]).derivatives == pytest.approx([-1.0], rel=1e-9)
    with pytest.raises(ArgumentError, match="samples, rates or filters change inputs too"):
        gradient(model, End("block.x"), ["block.mass"], inputs={"u": ([0.0, 0.5], [0.0, 1.0])})
    struck = {"initial": {"ball.y": 0.0, "ball.y_dot": -1.0}}
    with pytest.raises(NoResult, match="a stop is struck there"):
        gradient(model_of(ball(1.0)), End("ball.y"), ["g"], **struck)
    graze = Scene("graze").ground().rigid("m", mass=1.0, inertia=0.1).force("spring", "m.origin", "-x", 0.0)
    graze.prismatic("rail", "ground.origin", "m.origin", limits={"lower": -1.0, "restitution": 0.5})
    graze.measure("x", "x", "m.origin").initial({"m.x": 1 + 1e-11})
    with pytest.raises(NoResult, match=r"rail.limits.lower.*grazes zero at t = 3.14"):
        gradient(model_of(graze.simulation(t_end=4.0, dt=0.1, scheme="dop853").build()), End("m.x"), ["m.x"])
