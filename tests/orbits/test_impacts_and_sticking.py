"""Motions that repeat with impacts and with friction that sticks: closed forms, and their multipliers by hand."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from runtime import Model, periodic, periodic_over
from runtime.gradients import End
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
G, E, OMEGA = 9.81, 0.7, 40.0
T = 2 * pi / OMEGA


def juggler() -> SceneRecord:
    """A ball that bounces on a table, which swings upright by amp sin(omega t)."""
    up = {"up": {"position": (0.0, 0.0), "angle": pi / 2}}
    scene = Scene("juggler").gravity(0.0, -G).parameter("omega", OMEGA, "rad/s").parameter("amp", 0.004, "m")
    scene.ground(markers=up).rigid("table", mass=1.0, inertia=0.1, markers=up)
    scene.rigid("ball", mass=0.3, inertia=0.1, markers=up).prismatic("post", "ground.up", "table.up")
    scene.prescribed_displacement("shake", "ground.up", "table.up", motion="amp * sin(omega * t)")
    scene.prismatic("rail", "table.up", "ball.up", limits={"lower": 0.0, "restitution": E})
    return scene.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def bounced(amp: float, above: bool) -> tuple[np.ndarray, np.ndarray]:
    """(y, y' at t = 0, monodromy from there): a bounce a period, where the table has V = g T (1 - e) / 2 (1 + e).

    Across it, with dT = -dy / (v- - V): dy+ = dy + (v- - v+) dT, dv+ = -e dv + (1 + e) (g + table'') dT.
    """
    V = G * T * (1 - E) / (2 * (1 + E))
    phase = np.arccos(V / (amp * OMEGA)) * (1 if above else -1) % (2 * pi)
    at, speed = phase / OMEGA, G * T / 2
    rest = T - at
    start = np.array([amp * np.sin(phase) + speed * rest - G * rest**2 / 2, speed - G * rest])
    table = -amp * OMEGA**2 * np.sin(phase)
    across = np.array([[1 - 2 * speed / (speed + V), 0.0], [(1 + E) * (G + table) / (speed + V), -E]])
    flown = [np.array([[1.0, t], [0.0, 1.0]]) for t in (at, rest)]
    return start, flown[1] @ across @ flown[0]


@pytest.mark.every_push("rk4-True", "rk4-False")
@pytest.mark.parametrize("above", [True, False])
@pytest.mark.parametrize("scheme", ["rk4", "exponential_rk4", "dop853", "single_rate"])
def test_a_ball_that_bounces_once_a_period(model_of: Build, scheme: str, above: bool) -> None:
    """Its state and its multipliers, whose product is e^2."""
    model = model_of(juggler())
    start, monodromy = bounced(0.004, above)
    near = dict(zip(("ball.y", "ball.y_dot"), (start + [1e-5, 1e-4]).tolist(), strict=True))
    found = periodic(model, speed="omega", start=near, scheme=scheme, steps=200)
    assert found.x == pytest.approx(start, abs=1e-10)
    wanted = np.linalg.eigvals(monodromy)
    assert np.prod(wanted) == pytest.approx(E**2)
    assert np.sort_complex(found.floquet.multipliers) == pytest.approx(np.sort_complex(wanted), rel=1e-8)
    assert sum(event.kind == "impact" for event in found.solution.events) == 1


@pytest.mark.long
def test_a_harder_table_throws_the_ball_to_twice_the_period(model_of: Build) -> None:
    """The flip is where the trace is -(1 + e^2)."""
    model, (start, monodromy) = model_of(juggler()), bounced(0.006, above=True)
    wanted = brentq(lambda amp: np.trace(bounced(amp, True)[1]) + 1 + E**2, 0.0036, 0.01, xtol=1e-14)
    near = dict(zip(("ball.y", "ball.y_dot"), start.tolist(), strict=True))
    assert np.abs(np.linalg.eigvals(monodromy)).max() < 1
    branch = periodic_over(model, "amp", (0.006, 1.1 * wanted), speed="omega", start=near, steps=100, points=12)
    flips = [one for one in branch.specials if one.kind == "flip"]
    assert [one.value for one in flips] == pytest.approx([wanted], rel=1e-6)


def test_a_ball_that_comes_to_rest_each_period_forgets_all(model_of: Build) -> None:
    """It is left behind where the table falls faster than by g, bounces, rests: both multipliers are zero."""
    how = {"speed": "omega", "parameters": {"amp": 0.0085, "rail.limits.restitution": 0.2}, "steps": 400}
    found = periodic(model_of(juggler()), start={"ball.y": 0.02}, settle=3, **how)
    assert found.x == pytest.approx([0.0, 0.0085 * OMEGA], abs=1e-11)
    assert np.abs(found.floquet.multipliers).max() < 1e-9 and found.stability == "stable"
    leaves, *_, rests = found.solution.events
    assert leaves.time == pytest.approx(np.arcsin(G / (0.0085 * OMEGA**2)) / OMEGA, abs=1e-10)
    assert leaves.text == "rail.limits.lower opens" and rests.kind == "rest"


K, SLOW, FAST, FALLS, V_BELT = 50.0, 2.0, 1.0, 0.1, 0.2


def belt() -> SceneRecord:
    """A block on a belt, held by a spring: 2 N hold it, and 1 N rubs when it slides fast."""
    scene = Scene("belt").parameter("V", V_BELT, "m/s").ground().rigid("belt", mass=1.0, inertia=0.1)
    scene.rigid("block", mass=1.0, inertia=0.1).prismatic("roll", "ground.origin", "belt.origin")
    scene.prescribed_displacement("drive", "ground.origin", "belt.origin", motion="V * t")
    law = {"coulomb": FAST, "breakaway": SLOW, "stribeck_velocity": FALLS}
    scene.prismatic("rub", "belt.origin", "block.origin", friction=law).measure("x", "x", "block.origin")
    scene.force("spring", "block.origin", f"-{K} * x", 0.0).initial({"block.x": 0.01})
    return scene.simulation(t_end=6.0, dt=2e-3, scheme="rk4").build()


@pytest.mark.parametrize("start", [{"start": {"block.x": 0.0, "block.x_dot": V_BELT}, "guess": 1.0}, {}])
def test_a_block_that_sticks_and_slips_on_a_belt(model_of: Build, start: dict[str, Any]) -> None:
    """It sticks until the spring pulls 2 N, and slips until it is as fast as the belt again; the rest is forgotten."""

    def slips(t: float, z: np.ndarray) -> list[float]:
        return [z[1], -K * z[0] + FAST + (SLOW - FAST) * np.exp(-(V_BELT - z[1]) / FALLS)]

    def sticks(t: float, z: np.ndarray) -> float:
        return float(z[1] - V_BELT) if t > 0.05 else -1.0

    sticks.terminal = True  # type: ignore[attr-defined]
    begin = [SLOW / K, V_BELT - 1e-12]
    slip = solve_ivp(slips, [0, 10], begin, events=sticks, rtol=1e-12, atol=1e-14, method="DOP853")
    period = slip.t[-1] + (SLOW / K - slip.y[0, -1]) / V_BELT
    found = periodic(model_of(belt()), period="free", tolerance=1e-8, **start)
    assert found.period == pytest.approx(period, rel=1e-7)
    assert np.sort(np.abs(found.floquet.multipliers)) == pytest.approx([0.0, 1.0], abs=1e-7)
    assert found.stability == "stable"


M, SPRING, PUSH, RUB, DRIVE = 1.0, 9.0, 10.0, 6.0, 1.2


def half(x: float, push: float = PUSH) -> tuple[float, float, float]:
    """(where it sticks next, when it lets go, when it sticks) of a block that push sin(DRIVE t) releases at x."""
    w, go = np.sqrt(SPRING / M), np.arcsin((RUB + SPRING * x) / push) / DRIVE
    size = push / (SPRING - M * DRIVE**2)
    a, b = x + RUB / SPRING - size * np.sin(DRIVE * go), -size * DRIVE * np.cos(DRIVE * go) / w

    def rate(s: float) -> float:
        return float(size * DRIVE * np.cos(DRIVE * (go + s)) - a * w * np.sin(w * s) + b * w * np.cos(w * s))

    s = brentq(rate, 0.5, 1.9, xtol=1e-14)
    place = size * np.sin(DRIVE * (go + s)) - RUB / SPRING + a * np.cos(w * s) + b * np.sin(w * s)
    return float(place), float(go), float(go + s)


def sticks_at(push: float) -> float:
    """Where it rests between two slides of one motion that is alike to both sides."""
    return float(brentq(lambda x: half(x, push)[0] + x, -1.3, -1.0, xtol=1e-14))


@pytest.mark.parametrize("t0", [0.0, 1.7])
def test_a_driven_block_that_sticks_twice_a_period(model_of: Build, t0: float) -> None:
    """It sticks to both sides; from where it slides, and from where it is held; its derivative by the push."""
    scene = Scene("driven").parameter("push", PUSH).rigid("block", mass=M, inertia=0.1).ground()
    scene.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": RUB}).measure(
        "x", "x", "block.origin"
    )
    scene.force("f", "block.origin", f"push * sin({DRIVE} * t) - {SPRING} * x", 0.0).initial({"block.x": -1.1})
    model = model_of(scene.simulation(t_end=5.0, dt=0.01, scheme="rk4").build())
    x = sticks_at(PUSH)
    found = periodic(model, period=2 * pi / DRIVE, t0=t0, tolerance=1e-7)
    assert np.abs(found.solution["block.x"]).max() == pytest.approx(-x, rel=1e-7)
    slope = (half(x + 1e-5)[0] - half(x - 1e-5)[0]) / 2e-5
    assert np.sort(np.abs(found.floquet.multipliers)) == pytest.approx([0.0, slope**2], abs=1e-8)
    if t0:
        assert found.x == pytest.approx([-x, 0.0], abs=1e-7) and found.x[1] == 0
        wanted = -(sticks_at(PUSH + 1e-4) - sticks_at(PUSH - 1e-4)) / 2e-4
        assert found.gradient(End("block.x"), ["push"])["push"] == pytest.approx(wanted, rel=1e-6)
