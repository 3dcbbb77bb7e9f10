"""Motions that repeat of bodies that turn freely in space: as rotations, by hand and against runs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, periodic, periodic_over
from runtime.gradients import Integral
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
A, C, WEIGHT_ARM, PRECESSION, SPIN = 0.25 + 0.6**2, 0.5, 0.6 * 9.81, 2.0, 6.0


@pytest.mark.parametrize("parts", [1, 4])
def test_a_heavy_top_precesses_as_by_hand(model_of: Build, parts: int) -> None:
    """(A - C) W^2 cos + m g l = C s W: a turn of precession W holds three of spin s, which end as e began or as -e.

    Nutation about it has the frequency of the potential (p_phi - p_psi cos)^2 / (2 A sin^2) + m g l cos; the other
    four multipliers are 1: two angles that nothing holds, and two momenta that are kept. In parts the top turns by
    three quarters of a turn in each, so that rotation vectors leave half a turn.
    """
    builder = Scene("top", space="spatial").gravity(0, 0, -9.81)
    builder.rigid("top", mass=1.0, inertia=[0.25, 0.25, 0.5], markers={"foot": {"position": (0, 0, -0.6)}})
    builder.spherical("pivot", "ground.origin", "top.foot")
    model = model_of(builder.simulation(t_end=1.0, dt=1e-2, scheme="rk4").build())
    cosine = (C * SPIN * PRECESSION - WEIGHT_ARM) / ((A - C) * PRECESSION**2)
    theta = float(np.arccos(cosine))
    beside = theta + 0.01
    start = {"top.e0": np.cos(beside / 2), "top.e1": np.sin(beside / 2), "top.e2": 0.0, "top.e3": 0.0}
    rates = [0.0, 2.02 * np.sin(beside), SPIN + 2.02 * np.cos(beside)]
    start |= {f"top.omega_{axis}": rate for axis, rate in zip("xyz", rates, strict=True)}
    found = periodic(model, period=2 * np.pi / PRECESSION, start=start, tolerance=1e-9, scheme="dop853", parts=parts)
    e = found.solution.q[:, [model.coordinates.index(f"top.e{k}") for k in range(4)]]
    assert 1 - 2 * (e[:, 1] ** 2 + e[:, 2] ** 2) == pytest.approx(np.full(len(e), cosine), abs=1e-9)
    assert found.state["top.omega_z"] == pytest.approx(SPIN + PRECESSION * cosine, abs=1e-9)
    momentum = C * (SPIN + PRECESSION * cosine)
    upright = A * PRECESSION * np.sin(theta) ** 2 + momentum * cosine

    def potential(angle: float) -> float:
        return (upright - momentum * np.cos(angle)) ** 2 / (2 * A * np.sin(angle) ** 2) + WEIGHT_ARM * np.cos(angle)

    bend = (potential(theta + 1e-4) - 2 * potential(theta) + potential(theta - 1e-4)) / 1e-8
    nutation = np.exp(1j * np.sqrt(bend / A) * found.period)
    assert np.abs(found.floquet.multipliers - nutation).min() < 1e-6
    assert (np.abs(found.floquet.multipliers - 1) < 1e-4).sum() == 4
    assert found.stability == "neutral"


def engine() -> SceneRecord:
    """A block on a bushing that is shaken along and about skew axes, so that it turns by a third of a radian."""
    builder = Scene("engine", space="spatial").parameter("omega", 12.0, "rad/s").parameter("inertia", 0.3)
    builder.parameter("push", 60.0, "N")
    builder.ground(markers={"mount": {"axis": [0.3, 0.2, 1.0]}})
    builder.rigid(
        "block", mass=3.0, inertia=[0.2, "inertia", 0.4], free=True,
        markers={"foot": {"position": (0.1, 0.05, -0.2), "axis": [0.3, 0.2, 1.0]}, "side": {"axis": [1.0, 0.5, 0.2]}},
    )  # fmt: skip
    builder.bushing(
        "mount", "ground.mount", "block.foot", stiffness=[2e3, 3e3, 4e3], damping=[30.0, 20.0, 10.0],
        rotational_stiffness=[50.0, 60.0, 70.0], rotational_damping=[1.0, 2.0, 3.0],
    )  # fmt: skip
    builder.force("shake", "block.origin", "push*cos(omega*t)", 0.0, "5*sin(omega*t)")
    builder.torque("twist", "block.side", "8*cos(omega*t)")
    return builder.simulation(t_end=1.0, dt=1e-2, scheme="rk4").build()


@pytest.fixture(scope="module")
def shaken(model_of: Build) -> Model:
    return model_of(engine())


def test_an_engine_on_its_mount_repeats_as_the_end_of_a_long_run(shaken: Model) -> None:
    found = periodic(shaken, speed="omega", tolerance=1e-9, scheme="dop853")
    late = shaken.simulate(
        scheme="dop853", t_end=40 * found.period, dt=found.period / found.steps, seen_every=found.period, error="off"
    )
    assert np.abs(found.solution["block.e1"]).max() > 0.05
    for name, value in found.state.items():
        assert late[name][-1] == pytest.approx(value, abs=1e-9)
    parts = periodic(shaken, speed="omega", steps=found.steps, parts=4, scheme="dop853", start=late)
    assert parts.x == pytest.approx(found.x, abs=1e-9)
    assert np.abs(parts.floquet.multipliers) == pytest.approx(np.abs(found.floquet.multipliers), abs=1e-9)


def test_a_body_far_from_upright_is_found_from_its_start_and_after_a_transient(model_of: Build) -> None:
    """A block whose mount is turned by 2.5 rad: rotation vectors come near half a turn, whatever the phase."""
    builder = Scene("turned", space="spatial").parameter("omega", 12.0, "rad/s")
    mount = {"axis": [0.0, 0.0, 1.0], "x_axis": [float(np.cos(2.5)), float(np.sin(2.5)), 0.0]}
    builder.ground(markers={"mount": mount})
    foot = {"position": (0.1, 0.05, -0.2), "axis": [0.0, 0.0, 1.0], "x_axis": [1.0, 0.0, 0.0]}
    markers = {"foot": foot, "side": {"axis": [1.0, 0.5, 0.2]}}
    builder.rigid("block", mass=3.0, inertia=[0.2, 0.3, 0.4], free=True, markers=markers)
    builder.bushing(
        "mount", "ground.mount", "block.foot", stiffness=[2e3, 3e3, 4e3], damping=[30.0, 20.0, 10.0],
        rotational_stiffness=[50.0, 60.0, 70.0], rotational_damping=[1.0, 2.0, 3.0],
    )  # fmt: skip
    builder.force("shake", "block.origin", "90*cos(omega*t)", 0.0, "5*sin(omega*t)")
    builder.torque("twist", "block.side", "8*cos(omega*t)")
    builder.initial({"block.e0": float(np.cos(1.25)), "block.e3": float(np.sin(1.25))})
    model = model_of(builder.simulation(t_end=1.0, dt=1e-2, scheme="rk4").build())
    for phase in range(4):
        how = {"speed": "omega", "steps": 120, "scheme": "rk4", "t0": phase * np.pi / 24}
        found = periodic(model, **how)
        assert 2.0 < found.x[5] < np.pi
        assert periodic(model, **how, settle=3).x == pytest.approx(found.x, abs=1e-9)


def test_gradients_and_branches_of_free_bodies(shaken: Model) -> None:
    how = {"speed": "omega", "steps": 240, "scheme": "rk4"}
    found, of = periodic(shaken, **how), Integral("block.e3", squared=True)
    slopes = found.gradient(of, ["inertia", "omega"])
    for name, value in (("inertia", 0.3), ("omega", 12.0)):
        values = []
        for sign in (1, -1):
            moved = periodic(shaken, **how, parameters={name: value * (1 + sign * 1e-4)}, start=found)
            run = moved.simulate(1, seen_every=0.0)
            values.append(of.weighed(run.t, run["block.e3"][:, None])[0])
        assert slopes[name] == pytest.approx((values[0] - values[1]) / (2e-4 * value), rel=1e-6)
    branch = periodic_over(shaken, "omega", (12.0, 16.0), **how)
    there = periodic(shaken, **how, parameters={"omega": 16.0})
    assert branch.points[-1].x[0] == pytest.approx(there.x, abs=1e-9)
    assert branch.motion(0).x == pytest.approx(found.x, abs=1e-9)


def test_a_mode_of_a_free_body_moves_as_a_run_beside_it(shaken: Model) -> None:
    found, size = periodic(shaken, speed="omega", steps=240, scheme="rk4"), 1e-4
    moved = size * found.floquet.vectors[:, 0].real
    run = shaken.simulate(
        scheme="rk4", initial=found.states.by_name(found.x + moved), t_end=found.period, dt=found.period / 240,
        seen_every=found.period / 60, error="off",
    )  # fmt: skip
    mode, growth = found.mode(0, 1, size), np.exp(found.floquet.exponents[0].real * run.t)
    still = found.simulate(1, seen_every=found.period / 60)
    for name in ("block.x", "block.e1", "block.e2"):
        assert growth * (mode[name] - still[name]) == pytest.approx(run[name] - still[name], abs=100 * size**2)
