"""Motions that repeat with controllers, events and rotating axes, by hand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import fsolve

from runtime import Model, periodic, periodic_over, simulate
from runtime.orbits.shooting import NoPeriodicMotion
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def test_the_state_of_a_controller_repeats_and_its_integral_need_not(model_of: Build) -> None:
    """z' = A z + b (cos w t + 1), z = (x, x', y): the answer at w and at rest; multipliers are those of exp(A T)."""
    builder = Scene("lag").parameter("omega", 2.0, "rad/s").rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.state("y", "3*(x-y)", unit="m").force("f", "mass.origin", "-4*x-0.5*x_dot-2*y+cos(omega*t)+1", 0.0)
    model = model_of(builder.simulation(t_end=10.0, dt=1e-2, scheme="rk4").build())
    found = periodic(model, speed="omega", tolerance=1e-9, scheme="dop853")
    A, b = np.array([[0.0, 1.0, 0.0], [-4.0, -0.5, -2.0], [3.0, 0.0, -3.0]]), np.array([0.0, 1.0, 0.0])
    z = np.linalg.solve(2j * np.eye(3) - A, b).real - np.linalg.solve(A, b)
    assert list(found.state.values()) == pytest.approx(list(z), abs=1e-10)
    exact = np.exp(np.linalg.eigvals(A) * np.pi)
    assert np.sort_complex(found.floquet.multipliers) == pytest.approx(np.sort_complex(exact), abs=1e-10)
    run = simulate(model, initial={"mass.x": 0.1, "y": z[2]}, t_end=1.0, error="off")
    again = periodic(model, speed="omega", start=run, steps=found.steps, scheme="dop853")
    assert list(again.state.values()) == pytest.approx(list(z), abs=1e-10)


def relay() -> Scene:
    """A mass with damping c that a force of 1 N drives to and fro: it changes sides where x passes 1 and -1."""
    builder = Scene("relay").parameter("c", 0.4).input("u", 1.0, "N").rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", "u - c * x_dot", 0.0)
    builder.event("back", "x - 1", direction="rising", action={"u": "-1"})
    builder.event("on", "x + 1", direction="falling", action={"u": "1"})
    return builder.initial({"mass.x": 0.0}).rates({"mass.x": 1.2}).simulation(t_end=10.0, dt=1e-2, scheme="rk4")


@pytest.mark.long
def test_a_relay_swings_by_itself(model_of: Build) -> None:
    """x = 1 - s / c + (v + 1 / c) (1 - exp(-c s)) / c after the change at x = 1; x = -1 with -v half a period later."""
    model, c = model_of(relay().build()), 0.4

    def half(v: float, s: float) -> tuple[float, float]:
        decay = np.exp(-c * s)
        return 1 - s / c + (v + 1 / c) * (1 - decay) / c, (v + 1 / c) * decay - 1 / c

    def open_(y: np.ndarray) -> list[float]:
        x, v = half(*y)
        return [x + 1, v + y[0]]

    v, s = fsolve(open_, [1.0, 3.0], xtol=1e-13)
    found = periodic(model, period="free", guess=2 * s + 0.1, steps=400, scheme="dop853")
    assert found.period == pytest.approx(2 * s, abs=1e-9)

    def returned(v: float) -> float:  # Poincare's map of half a period, at the crossing of x = -1
        duration = fsolve(lambda one: half(v, one[0])[0] + 1, [s], xtol=1e-13)[0]
        return -half(v, duration)[1]

    slope = (returned(v + 1e-5) - returned(v - 1e-5)) / 2e-5
    assert found.floquet.counted[0] == pytest.approx(slope**2, abs=1e-7)
    assert found.stability == "stable"


@pytest.mark.long
def test_what_events_did_must_repeat(model_of: Build) -> None:
    """A force that an event turns on once and for all is on at the end of the period and not at its start."""
    builder = Scene("latched").parameter("omega", 2.0).input("u", 0.0, "N").rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", "u - 6*x - 3*x_dot + cos(omega*t)", 0.0)
    builder.event("latch", "x - 0.05", direction="rising", action={"u": "0.5"})
    model = model_of(builder.simulation(t_end=10.0, dt=1e-2, scheme="rk4").build())
    with pytest.raises(NoPeriodicMotion, match="events do not repeat"):
        periodic(model, speed="omega", steps=200, scheme="dop853")


M, K, OUTER, INNER, E = 2.0, 800.0, 6.0, 4.0, 1e-3


def rotor(rotating: bool, omega: float) -> SceneRecord:
    """A Jeffcott rotor with outer and inner damping; two masses on rails have its coordinates in either axes."""
    builder = Scene("rotating" if rotating else "fixed").parameter("omega", omega, "rad/s")
    for name, along in (("first", "x"), ("second", "y")):
        builder.rigid(name, mass=M, inertia=1.0)
        builder.prismatic(f"rail_{name}", "ground.origin", f"{name}.origin").measure(along, "x", f"{name}.origin")
    if rotating:  # a = F / m + 2 w v + w^2 r, and outer damping acts on the velocity v + w x r
        forces = (
            f"-{K}*x - {INNER}*x_dot - {OUTER}*(x_dot - omega*y) + {M}*(2*omega*y_dot + omega*omega*(x + {E}))",
            f"-{K}*y - {INNER}*y_dot - {OUTER}*(y_dot + omega*x) + {M}*(omega*omega*y - 2*omega*x_dot)",
        )
    else:  # inner damping acts on the velocity v - w x r
        push = f"{M}*{E}*omega*omega"
        forces = (
            f"-{K}*x - {OUTER}*x_dot - {INNER}*(x_dot + omega*y) + {push}*cos(omega*t)",
            f"-{K}*y - {OUTER}*y_dot - {INNER}*(y_dot - omega*x) + {push}*sin(omega*t)",
        )
    builder.force("f", "first.origin", forces[0], 0.0).force("g", "second.origin", forces[1], 0.0)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


@pytest.mark.long
def test_a_jeffcott_rotor_is_the_same_in_rotating_and_in_fixed_axes(model_of: Build) -> None:
    """(k - m w^2 + i c_o w) r = m e w^2, whatever the inner damping; multipliers of a turn are those of both axes.

    The threshold is sqrt(k / m) (1 + c_i / c_o) turned around: there the inner damping feeds what the outer one takes.
    """
    omega = 15.0
    models = [model_of(rotor(rotating, omega)) for rotating in (False, True)]
    fixed, turning = (periodic(model, speed="omega", tolerance=1e-11, scheme="dop853") for model in models)
    r = M * E * omega**2 / (K - M * omega**2 + 1j * OUTER * omega)
    for found in (fixed, turning):
        assert found.state["first.x"] == pytest.approx(r.real, abs=1e-9 * abs(r))
        assert found.state["second.x"] == pytest.approx(r.imag, abs=1e-9 * abs(r))
    assert turning.solution["x"] == pytest.approx(np.full(len(turning.solution.t), r.real), abs=1e-9 * abs(r))
    for one in fixed.floquet.multipliers:
        assert np.abs(turning.floquet.multipliers - one).min() < 1e-9
    threshold = np.sqrt(K / M) * (1 + OUTER / INNER)
    for model in models:
        branch = periodic_over(model, "omega", (0.9 * threshold, 1.1 * threshold), speed="omega", scheme="dop853")
        (leaves,) = [one for one in branch.specials if one.kind == "Neimark-Sacker"]
        assert leaves.value == pytest.approx(threshold, rel=1e-8)
