"""Derivatives of runs whose loads jump in time: steps end there, and a time that moves has its part."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime import SCHEMES, DifferentiableRun, Model, gradient, simulate
from runtime.gradients import End, passes
from symgen.scene import Scene, SceneRecord
from tests.gradients.test_gradients import sliding

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_time_that_moves_has_its_derivative(model_of: Build, scheme: str) -> None:
    """x(1) = f (1 - T)^2 / 2 by hand: of a jump within a step, and of one at the end of a step."""
    model = model_of(sliding("where(t < T, 0, f)", T=0.5, f=2.0))
    for T in (0.5, 0.4567):
        for mode in ("forward", "reverse"):
            found = gradient(model, End("mass.x"), ["f", "T"], scheme=scheme, dt=0.02, mode=mode, parameters={"T": T})
            np.testing.assert_allclose(found.derivatives, [(1 - T) ** 2 / 2, -2 * (1 - T)], rtol=1e-11)
            assert found.value == pytest.approx((1 - T) ** 2, rel=1e-12)
    run = DifferentiableRun(model, ["mass.x_dot"], ["T"], scheme=scheme, dt=0.02, seen_every=0.5)
    np.testing.assert_allclose(run.jacobian(run.x0)["mass.x_dot", "T"], [0.0, -2.0, -2.0], atol=1e-11)


def kicked() -> SceneRecord:
    """A pendulum with a step, a square wave and a ramp, all of whose times move."""
    builder = Scene("kicked_pendulum").gravity(0, -9.81).parameter("w", 7.0, "rad/s").parameter("T", 0.4567, "s")
    builder.rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0)).revolute("pin", "ground.origin", "rod.origin")
    torque = "where(t < T, 0, 5) + where(sin(w * t) > 0.2, 3, 0) + 20 * max(t - T - 0.1, 0)"
    return builder.torque("kick", "rod.origin", torque).simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


@pytest.mark.parametrize("scheme, dt, closely", [("rk4", 0.01, 1e-6), ("single_rate", 2e-3, 1e-4)])
def test_forward_reverse_and_differences_of_runs(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, scheme: str, dt: float, closely: float
) -> None:
    """Against differences of `simulate`: exact where no time moves, else to the order; also in segments."""
    model, by = model_of(kicked()), ["w", "T", "rod.mass", "rod.theta_dot"]
    run = DifferentiableRun(model, ["rod.theta"], by, scheme=scheme, dt=dt, seen_every=10 * dt)

    def end(x: np.ndarray) -> float:
        given = {"parameters": dict(zip(by[:3], x[:3], strict=True)), "initial": {"rod.theta_dot": x[3]}}
        return float(simulate(model, scheme=scheme, dt=dt, **given)["rod.theta"][-1])

    forward, reverse = (run.gradient(End("rod.theta"), run.x0, mode=mode) for mode in ("forward", "reverse"))
    assert forward.value == end(run.x0)
    np.testing.assert_allclose(reverse.derivatives, forward.derivatives, rtol=0, atol=1e-12 * 8)
    for k, limit in enumerate((closely, closely, 1e-8, 1e-8)):
        ends = {n: end(run.x0 + 1e-4 * n * np.eye(4)[k]) for n in (-2, -1, 1, 2)}
        difference = (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / 12e-4
        assert forward.derivatives[k] == pytest.approx(difference, rel=limit)
    monkeypatch.setattr(passes, "TAPE_NUMBERS", 0)
    again = DifferentiableRun(model, ["rod.theta"], by, scheme=scheme, dt=dt, seen_every=10 * dt)
    parts = again.gradient(End("rod.theta"), again.x0, mode="reverse")
    np.testing.assert_allclose(parts.derivatives, reverse.derivatives, rtol=1e-13)


@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams"])
def test_a_jump_at_the_end_of_a_step(model_of: Build, scheme: str) -> None:
    """A whole step follows, as in `simulate`: the same bits; against differences where no time moves, and by T."""
    model, T = model_of(kicked()), 0.46
    run = DifferentiableRun(
        model,
        ["rod.theta"],
        ["rod.mass", "T"],
        scheme=scheme,
        parameters={"T": T},
        seen_every=10 * model.simulation["dt"],
    )

    def course(mass: float, T: float = T) -> np.ndarray:
        parameters = {"rod.mass": mass, "T": T}
        return np.asarray(
            simulate(model, scheme=scheme, parameters=parameters, seen_every=10 * model.simulation["dt"])["rod.theta"]
        )

    assert np.array_equal(run.values(run.x0)[:, 0], course(1.0))
    both = [run.gradient(End("rod.theta"), run.x0, mode=mode) for mode in ("forward", "reverse")]
    forward, reverse = (found.derivatives for found in both)
    np.testing.assert_allclose(reverse, forward, rtol=0, atol=1e-12 * 8)
    ends = {n: course(1.0 + 1e-4 * n)[-1] for n in (-2, -1, 1, 2)}
    difference = (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / 12e-4
    assert forward[0] == pytest.approx(difference, rel=1e-8)
    moved = (course(1.0, T + 1e-4)[-1] - course(1.0, T - 1e-4)[-1]) / 2e-4
    assert forward[1] == pytest.approx(moved, rel=1e-4)


def pushed_beyond() -> SceneRecord:
    """1 kg that slides into a push which begins at `edge` and ends at `edge` + 1."""
    scene = Scene("pushed_beyond").parameter("edge", 0.5, "m").parameter("push", 10.0, "N")
    scene.rigid("block", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "block.origin")
    scene.measure("x", "coordinate", "block.x").force("f", "block.origin", "where(edge < x < edge + 1, push, 0)", 0.0)
    return scene.rates({"block.x": 1.0}).simulation(t_end=1.2, dt=0.03, scheme="rk4").build()


@pytest.mark.parametrize("mode", ["forward", "reverse"])
@pytest.mark.parametrize("scheme", ["rk4", "exponential", "single_rate", "radau"])
def test_a_push_that_begins_and_ends_at_a_place(model_of: Build, scheme: str, mode: str) -> None:
    """By hand: v = sqrt(v0^2 + 2 push) behind it, x from the times (edge - x0) / v0 and (v - v0) / push on the way."""
    at = ca.SX.sym("at", 4)
    edge, push, x, v = ca.vertsplit(at)
    left = ca.sqrt(v**2 + 2 * push)
    end = ca.vertcat(edge + 1 + left * (1.2 - (edge - x) / v - (left - v) / push), left)
    exact = ca.Function("exact", [at], [end, ca.jacobian(end, at)])([0.5, 10.0, 0.0, 1.0])
    by = ["edge", "push", "block.x", "block.x_dot"]
    for k, name in enumerate(("block.x", "block.x_dot")):
        found = gradient(model_of(pushed_beyond()), End(name), by, scheme=scheme, mode=mode)
        assert found.value == pytest.approx(float(exact[0][k]), abs=1e-8)
        np.testing.assert_allclose(found.derivatives, np.asarray(exact[1])[k], atol=2e-7)
