"""Runs that stop before their end: when, whatever is sampled, and whether a tolerance believes it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def bent() -> SceneRecord:
    """A cantilever, E I = 70 N m^2, 1 m, under 100 t N at its tip: 0.4 m is passed near 0.4 * 3 E I / 100 = 0.84 s.

    Slowly: its first vibration has a period of 0.11 s.
    """
    builder = Scene("bent").beam(
        "b",
        length=1.0,
        density=2700.0,
        area=1e-4,
        second_moment=1e-9,
        youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 2},
        damping_ratio=0.05,
    )
    builder.weld("wall", "ground.origin", "b.start").force("load", "b.end", 0, "100*t")
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def sticking() -> SceneRecord:
    """A pendulum with a beam on a hinge that sticks and a stop that is never touched.

    A regular motion of 1.52 s. Coarse steps fail in it near 0.09 s, in several ways.
    """
    builder = Scene("sticking").gravity(0, -9.81)
    tip = {"tip": {"position": (0.6441, 0)}}
    builder.rigid("b0", mass=1.0336, inertia=0.019682, center_of_mass=(0.3574, 0.05), markers=tip)
    builder.beam(
        "b1",
        length=0.7991,
        density=2700.0,
        area=1.79e-4,
        second_moment=2.0665357722672695e-09,
        youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 2},
        damping_ratio=0.01,
    )
    limits = {"lower": -2.9101, "restitution": 0.0}
    friction = {"coulomb": 0.3221, "breakaway": 0.8022, "stribeck_velocity": 0.0333, "viscous": 0.0588}
    builder.revolute("h0", "ground.origin", "b0.origin", damping=0.0316, limits=limits)
    builder.revolute("h1", "b0.tip", "b1.start", damping=0.038, friction=friction)
    builder.torque("t0", "b0.origin", "0.9639 * sin(2.0071 * t + 5.8787)")
    builder.initial({"b0.theta": -2.103, "b1.theta": -1.933, "b1.q1": 0.0, "b1.q2": 0.0})
    builder.rates({"b0.theta": -1.624, "b1.theta": 0.883, "b1.q1": 0.0, "b1.q2": 0.0})
    return builder.build()


@pytest.mark.parametrize("samples", [1, 10, 400])
def test_a_run_stops_in_the_step_in_which_it_has_to(model_of: Build, samples: int) -> None:
    """Not at the sample before, which was up to half of the motion earlier."""
    model = model_of(bent())
    run, every = (simulate(model, dt=1 / 400, samples=count) for count in (samples, 400))
    assert run.status.name == "deflection_too_large" and run.status.time == every.status.time == run.t[-1]
    assert run.status.time == pytest.approx(0.84, abs=0.01)


@pytest.mark.parametrize("settings", [{}, {"samples": 10}, {"samples": 30}, {"samples": 100, "tolerance": 1e-5}])
def test_a_tolerance_believes_an_end_that_converges(model_of: Build, settings: dict[str, Any]) -> None:
    run = simulate(model_of(bent()), **{"tolerance": 1e-3} | settings)
    assert run.status.name == "deflection_too_large" and run.status.time == pytest.approx(0.8446, abs=5e-4)


@pytest.mark.long
@pytest.mark.parametrize("samples", [30, 60])
def test_a_tolerance_does_not_believe_ends_of_coarse_steps(model_of: Build, samples: int) -> None:
    """It ended as `chattering` or `not_finite` at 0.09 s; right is what event-driven equations by hand come to."""
    run = simulate(model_of(sticking()), t_end=1.52, samples=samples)
    assert run.status.name == "completed" and len(run.events) == 11
    assert run["b0.theta"][-1] == pytest.approx(-1.45522, abs=2e-3)
    assert run["b1.theta"][-1] == pytest.approx(-1.48107, abs=2e-3)
