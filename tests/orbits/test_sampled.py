"""Motions that repeat with controllers that are asked at samples: the closed form of the sampled linear system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm

from runtime import ArgumentError, Model, Sampled, periodic, periodic_over
from runtime.gradients import Integral
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
M, K, C, PUSH, P, D, SAMPLES = 2.0, 30.0, 0.4, 5.0, 40.0, 6.0, 16
OMEGA = 4.0  # rad/s
EVERY = 2 * np.pi / OMEGA / SAMPLES


def held() -> SceneRecord:
    """A mass on a spring, pushed by a sine, and held by the force u."""
    builder = Scene("held").parameter("omega", OMEGA, "rad/s").parameter("push", PUSH, "N").input("u", 0.0, "N")
    builder.rigid("mass", mass=M, inertia=1.0).prismatic("rail", "ground.origin", "mass.origin")
    builder.measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", f"u - {K}*x - {C}*x_dot + push*sin(omega*t)", 0.0)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def pd(t: float, seen: Any, kept: Any) -> Any:
    """u = P (r(t) - x) - D (x - x of the last sample) / h, r = 0.1 cos(w t)."""
    rate = (seen[0] - kept[0]) / EVERY
    kept[0] = seen[0]
    return P * (0.1 * np.cos(OMEGA * t) - seen[0]) - D * rate


@pytest.fixture(scope="module")
def mass(model_of: Build) -> Model:
    return model_of(held())


def by_hand(push: float = PUSH) -> tuple[np.ndarray, np.ndarray]:
    """(z at t = 0, multipliers), z = (x, x', x of the last sample): z_{k+1} = F z_k + Re(g exp(i w t_k)).

    Between samples y = (x, x', u, e) with e' = i w e, which the exponential of one matrix takes from sample to sample.
    """
    A = np.array([[0, 1, 0, 0], [-K / M, -C / M, 1 / M, -1j * push / M], [0, 0, 0, 0], [0, 0, 0, 1j * OMEGA]])
    E = expm(A * EVERY)  # sin = Re(-i e)
    law = np.array([-P - D / EVERY, 0.0, D / EVERY])
    F = np.zeros((3, 3))
    F[:2, :2] = E[:2, :2].real
    F[:2] += np.outer(E[:2, 2].real, law)
    F[2, 0] = 1.0
    g = np.append(E[:2, 3] + E[:2, 2] * P * 0.1, 0.0)
    z = np.linalg.solve(np.exp(1j * OMEGA * EVERY) * np.eye(3) - F, g).real
    return z, np.linalg.eigvals(np.linalg.matrix_power(F, SAMPLES))


def test_a_sampled_pd_holds_a_mass_as_by_hand(mass: Model) -> None:
    inputs = {"u": Sampled(pd, EVERY, ["x"], memory=[0.0])}
    found = periodic(mass, speed="omega", inputs=inputs, tolerance=1e-10, scheme="dop853")
    z, multipliers = by_hand()
    assert found.x == pytest.approx(z, abs=1e-11)
    assert np.sort(np.abs(found.floquet.multipliers)) == pytest.approx(np.sort(np.abs(multipliers)), abs=1e-11)
    assert found.stability == "stable" and found.iterations <= 2
    with pytest.raises(ArgumentError, match="not differentiated"):
        found.gradient(Integral("x"), ["push"])
    run = found.simulate(3, samples=3)
    assert run["mass.x"] == pytest.approx(np.full(4, z[0]), abs=1e-10)


@pytest.mark.long
def test_parts_and_branches_are_those_by_hand(mass: Model) -> None:
    inputs, z = {"u": Sampled(pd, EVERY, ["x"], memory=[0.0])}, by_hand()[0]
    parts = periodic(mass, speed="omega", inputs=inputs, steps=10 * SAMPLES, parts=4, scheme="dop853")
    assert parts.x == pytest.approx(z, abs=1e-9)
    branch = periodic_over(
        mass, "push", (PUSH, 2 * PUSH), speed="omega", inputs=inputs, steps=5 * SAMPLES, scheme="dop853"
    )
    assert branch.points[-1].x[0] == pytest.approx(by_hand(2 * PUSH)[0], abs=1e-9)
    assert branch.motion(len(branch.points) - 1).x == pytest.approx(by_hand(2 * PUSH)[0], abs=1e-9)


@pytest.mark.long
def test_a_controller_may_saturate_by_functions_of_casadi(mass: Model) -> None:
    """The motion is that of a long run, made with the function as it is; what saturates damps less."""

    def bang(t: float, seen: Any, kept: Any) -> Any:
        return ca.fmin(ca.fmax(pd(t, seen, kept), -2.0), 2.0)

    inputs = {"u": Sampled(bang, EVERY, ["x"], memory=[0.0])}
    found = periodic(mass, speed="omega", inputs=inputs, steps=10 * SAMPLES)
    assert np.abs(found.x - by_hand()[0]).max() > 1e-3
    late = mass.simulate(
        inputs=inputs, scheme=found.scheme, t_end=160 * found.period, dt=found.period / found.steps,
        samples=160, error="off",
    )  # fmt: skip
    assert [late["mass.x"][-1], late["mass.x_dot"][-1]] == pytest.approx(found.x[:2], abs=1e-9)


def branching(t: float, seen: Any) -> Any:
    return -1.0 if seen[0] > 0 else 1.0


@pytest.mark.parametrize(
    ("controller", "how", "message"),
    [
        (Sampled(pd, 0.1, ["x"], memory=[0.0]), {"speed": "omega"}, "not a whole multiple"),
        (Sampled(pd, EVERY, ["x"]), {"speed": "omega"}, "memory="),
        (Sampled(branching, EVERY, ["x"], memory=()), {"speed": "omega"}, "takes no symbols"),
        (Sampled(branching, EVERY, ["x"], memory=()), {"period": "free"}, "period is not known"),
        (Sampled(pd, EVERY, ["mass.x_ddot"], memory=[0.0]), {"speed": "omega"}, "mass.x_ddot.*at once"),
        (Sampled(pd, EVERY, ["x"], memory=[0.0]), {"speed": "omega", "steps": 100}, "16 samples a period"),
        (Sampled(pd, EVERY, ["x"], memory=[0.0]), {"speed": "omega", "parts": 3}, "\\[16\\] times a period"),
    ],
)
def test_controllers_that_cannot_be_crossed_are_refused(
    mass: Model, controller: Sampled, how: dict[str, Any], message: str
) -> None:
    with pytest.raises(ArgumentError, match=message):
        periodic(mass, inputs={"u": controller}, **how)


def test_what_asks_for_another_period_is_refused(mass: Model) -> None:
    inputs = {"u": Sampled(pd, EVERY, ["x"], memory=[0.0])}
    with pytest.raises(ArgumentError, match="changes with omega"):
        periodic_over(mass, "omega", (OMEGA, 2 * OMEGA), speed="omega", inputs=inputs, steps=10 * SAMPLES)
