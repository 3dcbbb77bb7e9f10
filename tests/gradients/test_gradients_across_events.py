"""Derivatives of runs across events that act: their times follow the motion (saltation)."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, NoResult, gradient, output_jacobian, simulate
from runtime.gradients import End, passes
from runtime.gradients.differentiable_run import OutputJacobian
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_rail

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
G = 9.81


def thrown_back() -> SceneRecord:
    """A ball (2 kg) that falls from 1 m: below `floor` a push acts, above it none; it comes back again and again."""
    builder = Scene("thrown_back").parameter("floor", 0.3, "m").parameter("strength", 90.0, "N")
    builder.input("push", 0.0, "N").gravity(-G, 0).rigid("ball", mass=2.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "ball.origin").initial({"ball.x": 1.0}).measure("x", "x", "ball.origin")
    builder.force("push", "ball.origin", "push", 0.0)
    builder.event("down", "x - floor", direction="falling", action={"push": "strength - 3 * x"})
    builder.event("up", "x - floor", direction="rising", action={"push": "0"})
    return builder.simulation(t_end=2.0, dt=0.037, scheme="rk4").build()


def thrown_back_by_hand(t_end: float) -> ca.Function:
    """(floor, strength, mass, x(0)) -> (x, x') at t_end: parabolas between times that solve quadratic equations."""
    at = ca.SX.sym("at", 4)
    floor, strength, mass, x = ca.vertsplit(at)
    v, t, below = ca.SX(0), (zero := ca.SX(0)), False
    while True:
        a = -G + ((strength - 3 * floor) / mass if below else 0)
        tau = -2 * v / a if t is not zero else ca.sqrt(2 * (x - floor) / G)
        if float(ca.Function("t", [at], [t + tau])([0.3, 90.0, 2.0, 1.0])) > t_end:
            break
        x, v, t, below = floor, v + a * tau, t + tau, not below
    tau = t_end - t
    return ca.Function("end", [at], [ca.vertcat(x + v * tau + a * tau**2 / 2, v + a * tau)])


@pytest.mark.parametrize("scheme", ["rk4", "exponential", "single_rate"])
@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_a_ball_that_is_thrown_back(model_of: Build, scheme: str, mode: str) -> None:
    """Four events by hand, each at a time and with an action that move with the state before."""
    model, by = model_of(thrown_back()), ["floor", "strength", "ball.mass", "ball.x"]
    x, v = ca.vertsplit(thrown_back_by_hand(2.0)(at := ca.SX.sym("at", 4)))
    whole = simulate(model, scheme=scheme)
    assert len(whole.events) == 4
    for k, (output, value) in enumerate((("ball.x", x), ("ball.x_dot", v))):
        exact = ca.Function("exact", [at], [value, ca.jacobian(value, at)])([0.3, 90.0, 2.0, 1.0])
        found = gradient(model, End(output), by, scheme=scheme, mode=mode)
        assert found.value == (whole["ball.x"], whole.rate("ball.x"))[k][-1]
        assert found.value == pytest.approx(float(exact[0]), rel=1e-9)
        np.testing.assert_allclose(found.derivatives, np.asarray(exact[1]).ravel(), rtol=1e-9)


def end_stop(**settings: float) -> SceneRecord:
    """A mass on a spring `k` with 2 m/s that meets a preloaded stop at `gap`, which acts by events alone."""
    builder = Scene("preloaded_stop").rigid("mass", mass=1.5, inertia=0.1)
    for name, value in {"k": 40.0, "k_stop": 900.0, "preload": 6.0, "gap": 0.2}.items():
        builder.parameter(name, value)
    builder.input("on", 0.0).prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("spring", "mass.origin", "-k * x - on * (preload + k_stop * (x - gap))", 0.0)
    builder.event("meets", "x - gap", direction="rising", action={"on": "1"})
    builder.event("leaves", "x - gap", direction="falling", action={"on": "0"})
    builder.rates({"mass.x": 2.0})
    return builder.simulation(**{"t_end": 0.5, "dt": 5e-3, "scheme": "dop853", **settings}).build()


def end_stop_by_hand() -> ca.Function:
    """(k, k_stop, preload, gap, mass, x'(0)) -> (x, its derivatives) at 0.5 s: three harmonic pieces."""
    at = ca.SX.sym("at", 6)
    k, k_stop, preload, gap, mass, v = ca.vertsplit(at)
    w, w_stop = ca.sqrt(k / mass), ca.sqrt((k + k_stop) / mass)
    meets, v_meets = ca.asin(gap * w / v) / w, ca.sqrt(v**2 - (gap * w) ** 2)
    middle = (k_stop * gap - preload) / (k + k_stop)
    leaves = meets + 2 * ca.atan2(v_meets / w_stop, gap - middle) / w_stop
    angle = w * (0.5 - leaves)
    x = gap * ca.cos(angle) - v_meets / w * ca.sin(angle)
    return ca.Function("end", [at], [x, ca.jacobian(x, at), leaves])


BY = ["k", "k_stop", "preload", "gap", "mass.mass", "mass.x_dot"]


def test_a_preloaded_end_stop(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """By hand; forward, reverse, and reverse in segments."""
    model = model_of(end_stop())
    x, slopes, leaves = end_stop_by_hand()([40.0, 900.0, 6.0, 0.2, 1.5, 2.0])
    assert float(leaves) < 0.3
    forward, reverse = (gradient(model, End("mass.x"), BY, mode=mode) for mode in ("forward", "reverse"))
    assert forward.value == pytest.approx(float(x), rel=1e-10)
    np.testing.assert_allclose(forward.derivatives, np.asarray(slopes).ravel(), rtol=1e-9)
    np.testing.assert_allclose(reverse.derivatives, forward.derivatives, rtol=1e-12)
    monkeypatch.setattr(passes, "TAPE_NUMBERS", 0)
    parts = gradient(model, End("mass.x"), BY, mode="reverse")
    np.testing.assert_allclose(parts.derivatives, reverse.derivatives, rtol=1e-13)


def test_events_among_jumps_of_a_flexible_hub(model_of: Build) -> None:
    """A brake that acts by the angle of a hub with a beam, under a wave: against differences of `simulate`."""
    builder = Scene("braked_hub").rigid("hub", mass=1.0, inertia=2.0).parameter("grip", 60.0).parameter("w", 31.0)
    section = {"area": 7e-4, "second_moment": 8e-9, "youngs_modulus": 7e10}
    builder.beam("beam", length=1.0, density=2700.0, lateral={"ends": "clamped-free", "modes": 1}, **section)
    builder.revolute("pivot", "ground.origin", "hub.origin").weld("clamp", "hub.origin", "beam.start")
    builder.input("brake", 0.0).measure("angle", "coordinate", "hub.theta")
    builder.torque("drive", "hub.origin", "where(sin(w * t) > -0.5, 30, 10) - brake * angle_dot")
    builder.event("on", "angle_dot - 2", direction="rising", action={"brake": "grip * angle"})
    model = model_of(builder.simulation(t_end=0.3, dt=2e-3, scheme="exponential_rk4").build())
    by = ["grip", "w", "hub.inertia", "hub.theta_dot"]
    run = DifferentiableRun(model, ["hub.theta"], by)

    def end(x: np.ndarray) -> float:
        given = {"parameters": dict(zip(by[:3], x[:3], strict=True)), "initial": {"hub.theta_dot": x[3]}}
        return float(simulate(model, **given)["hub.theta"][-1])

    forward, reverse = (run.gradient(End("hub.theta"), run.x0, mode=mode) for mode in ("forward", "reverse"))
    assert forward.value == end(run.x0)
    np.testing.assert_allclose(reverse.derivatives, forward.derivatives, rtol=1e-11)
    for k in range(4):
        step = 1e-5 * max(abs(run.x0[k]), 1.0)
        difference = (end(run.x0 + step * np.eye(4)[k]) - end(run.x0 - step * np.eye(4)[k])) / (2 * step)
        assert forward.derivatives[k] == pytest.approx(difference, rel=1e-6)


def test_what_has_no_derivative_is_refused_by_name(model_of: Build) -> None:
    """An event that grazes zero, one that chatters, one that ends the run, two that act at one time."""

    def refused(*events: dict[str, object]) -> OutputJacobian:
        builder = Scene("thrown").input("push", 0.0, "N").gravity(-G, 0).rigid("ball", mass=1.0, inertia=0.1)
        builder.prismatic("rail", "ground.origin", "ball.origin").measure("x", "x", "ball.origin")
        builder.force("push", "ball.origin", "push", 0.0).rates({"ball.x": 2.0})
        for k, event in enumerate(events):
            builder.event(f"event{k}", **event)
        model = model_of(builder.simulation(t_end=0.3, dt=0.03, scheme="rk4").build())
        return output_jacobian(model, ["ball.x"], ["ball.x_dot"])

    act = {"action": {"push": "push + 1"}}
    top = 2.0**2 / (2 * G)
    with pytest.raises(NoResult, match=r"event event0 of model thrown: grazes zero at t = 0\.20"):
        refused({"when": f"x - {top - 1e-10!r}", "direction": "rising", **act})
    assert refused({"when": f"x - {top - 1e-3!r}", **act}).values.size
    up = {"when": "x_dot", "direction": "rising", "action": {"push": "-40"}}
    with pytest.raises(NoResult, match="event event1 happens 50 times within one step"):
        refused(up, {"when": "x_dot", "direction": "falling", "action": {"push": "40"}})
    with pytest.raises(ArgumentError, match="event0 of model thrown: end the run at a time that depends on"):
        refused({"when": "x - 0.1", "terminal": True})
    with pytest.raises(NoResult, match="events event0, event1 of model thrown: act at one time"):
        refused({"when": "x - 0.1", **act}, {"when": "2 * x - 0.2", **act})
    for at in (0.1, 0.09):
        builder = on_rail("relieved", "ball", "rail", mass=1.0, inertia=0.1).input("own", 0.0, "N")
        builder.force("push", "ball.origin", f"where(t < {at}, 2, own)", 0.0)
        builder.event("takes", f"t - {at}", action={"own": "3"})
        model = model_of(builder.simulation(t_end=0.3, dt=0.03, scheme="rk4").build())
        with pytest.raises(NoResult, match="coincides with a jump of a load"):
            output_jacobian(model, ["ball.x"], ["ball.x_dot"])
