"""Friction whose limit changes during a run: clutches and brakes, against event-driven equations and closed forms."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from math import nan
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import Model, ensemble, gradient
from runtime.gradients import End
from symgen import SceneError
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
J = np.array([1.0, 0.7, 0.4])
G = np.array([[1.0, 0.0, 0.0], [-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]])  # brake on A, clutch A-B, clutch B-C
MARKS = [0.2, 0.3, 0.4, 0.55, 0.85, 0.9, 1.1, 1.4]
LIMITS = [  # the brake takes hold at last; two clutches whose ramps overlap
    "where(t >= 0.9, min(8, 16*(t - 0.9)), 0)",
    "where(t < 0.2, 0, min(6, k*(t - 0.2)))",
    "max(0, min(min(20*(t - 0.3), 5), 20*(1.1 - t)))",
]


def train(limits: list[str] = LIMITS, space: str = "planar", torque: str = "4*sin(6*t) + 1") -> Scene:
    """Three inertias in line on one axle."""
    scene = Scene("train", space=space).parameter("k", 30.0)
    for name, inertia in zip("ABC", J.tolist(), strict=True):
        scene.rigid(name, mass=1.0, inertia=inertia if space == "planar" else [inertia] * 3)
    ends = ("ground.origin", "A.origin", "B.origin", "C.origin")
    for k, limit in enumerate(limits):
        scene.revolute(f"c{k}", ends[k], ends[k + 1], friction={"coulomb": limit})
    return scene.torque("drive", "A.origin", torque)


def limits_at(t: float) -> np.ndarray:
    """(3,) the same as numbers."""
    brake = min(8.0, 16 * (t - 0.9)) if t >= 0.9 else 0.0
    first = 0.0 if t < 0.2 else min(6.0, 30 * (t - 0.2))
    return np.array([brake, first, max(0.0, min(20 * (t - 0.3), 5.0, 20 * (1.1 - t)))])


def forces(t: float, sides: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """(3,) on the relative rates, and accelerations; sides: 0 of what sticks, else the sign of its rate."""
    f = np.array([-side * limit for side, limit in zip(sides, limits_at(t), strict=True)])
    Q, stuck = np.array([4 * np.sin(6 * t) + 1, 0.0, 0.0]), [k for k in range(3) if sides[k] == 0]
    if stuck:
        own = G[stuck] / J
        f[stuck] = np.linalg.solve(own @ G[stuck].T, -own @ (Q + G.T @ f))
    return f, (Q + G.T @ f) / J


def consistent(t: float, v: np.ndarray) -> tuple[int, ...]:
    """The modes just behind t by trying all of what is at rest."""
    rates = G @ v
    tried = product(*[(0, 1, -1) if abs(rate) < 1e-9 else (int(np.sign(rate)),) for rate in rates])
    for sides in tried:
        f, a = forces(t + 1e-9, sides)
        holds = all(abs(f[k]) <= limits_at(t + 1e-9)[k] + 1e-12 for k in range(3) if sides[k] == 0)
        goes = all(side * (G @ a)[k] > -1e-12 for k, side in enumerate(sides) if side and abs(rates[k]) < 1e-9)
        if holds and goes:
            return sides
    raise AssertionError("no modes are consistent")


def event_driven(t_end: float) -> np.ndarray:
    """(6,) angles in the world and their rates at t_end, by an established integrator with events."""
    t, y = 0.0, np.zeros(6)
    for end in [*(mark for mark in MARKS if mark < t_end), t_end]:
        while t < end - 1e-12:
            sides = consistent(t, y[3:])
            ends = [
                lambda t, y, k=k, s=sides: (
                    limits_at(t)[k] - abs(forces(t, s)[0][k]) if s[k] == 0 else s[k] * (G @ y[3:])[k]
                ) + 1e-12
                for k in range(3)
            ]  # fmt: skip
            for one in ends:
                one.terminal, one.direction = True, -1  # type: ignore[attr-defined]
            found = solve_ivp(
                lambda t, y, s=sides: np.concatenate([y[3:], forces(t, s)[1]]),
                (t, end), y, events=ends, rtol=1e-12, atol=1e-13, method="DOP853", max_step=0.02,
            )  # fmt: skip
            stuck = found.t[-1] == t
            t, y = found.t[-1], found.y[:, -1].copy()
            if stuck:
                y, t = y + 1e-9 * np.concatenate([y[3:], forces(t, sides)[1]]), t + 1e-9
    return y


@pytest.mark.parametrize(
    "how",
    [{}, {"tolerance": 1e-8}, {"scheme": "rk4", "dt": 1e-3}, {"scheme": "dopri5", "tolerance": 1e-9},
     {"scheme": "radau", "dt": 1e-3}, {"scheme": "exponential", "dt": 1e-3}],
)  # fmt: skip
@pytest.mark.every_push("how0")
def test_three_clutches_by_ramps_that_overlap(model_of: Build, how: dict[str, Any]) -> None:
    run = model_of(train().simulation(t_end=2.0).build()).simulate(t_end=2.0, **how)
    right = event_driven(2.0)
    angles, rates = (np.array([run[f"{name}.theta{end}"][-1] for name in "ABC"]) for end in ("", "_dot"))
    assert run.status.name == "completed"
    assert np.abs(angles - right[:3]).max() < 1e-8
    assert np.abs(rates - right[3:]).max() < 1e-8
    assert [event.name for event in run.events if event.kind == "mode"] == [
        "c1.friction", "c2.friction", "c2.friction", "c0.friction",
    ]  # fmt: skip


@pytest.mark.long
def test_lanes_steppers_and_space_follow_the_run(model_of: Build) -> None:
    """An ensemble by the ramp of a clutch, a stepper, and the same wheels in space."""
    model, how = model_of(train().simulation(t_end=2.0).build()), {"scheme": "rk4", "dt": 2e-3}
    ramps = [10.0, 20.0, 30.0, 40.0]
    found = ensemble(model, {"k": ramps}, outputs=["B.theta"], t_end=2.0, seen_every=0.1, **how)
    runs = [model.simulate(t_end=2.0, parameters={"k": k}, seen_every=0.1, **how) for k in ramps]
    np.testing.assert_array_equal(np.asarray(found["B.theta"]), [run["B.theta"] for run in runs])
    stepper = model.stepper(**how)
    stepper.step(1000)
    assert [event.time for event in stepper.events] == [event.time for event in runs[2].events]
    spatial = model_of(train(space="spatial").simulation(t_end=2.0).build()).simulate(t_end=2.0, **how)
    times = [event.time for event in spatial.events if event.kind == "mode"]
    assert times == pytest.approx([event.time for event in runs[2].events if event.kind == "mode"], abs=1e-9)


@pytest.mark.parametrize(("mode", "t_end"), [("reverse", 0.9), ("forward", 1.3)])
def test_derivatives_by_the_ramp_of_a_clutch(model_of: Build, mode: str, t_end: float) -> None:
    """By differences of event-driven equations in closed form where B is caught by A: of runs, to their rounding."""
    model, how = model_of(train().simulation(t_end=2.0).build()), {"scheme": "rk4", "dt": 2e-3, "t_end": t_end}
    for angle in ("A.theta", "B.theta"):
        ends = [model.simulate(parameters={"k": 30.0 + by}, **how)[angle][-1] for by in (1e-3, -1e-3)]
        found = gradient(model, End(angle), ["k"], mode=mode, **how).derivatives[0]
        assert found == pytest.approx((ends[0] - ends[1]) / 2e-3, abs=1e-10)
        assert abs(found) > 1e-3


def wheel(friction: dict[str, Any], torque: str = "3.0", **inputs: float) -> Scene:
    """2 kg m2 with a brake, under 3 N m."""
    scene = Scene("wheel").rigid("wheel", mass=1.0, inertia=2.0).measure("turn", "angle", "wheel.origin")
    for name, value in inputs.items():
        scene.input(name, value)
    scene.revolute("hinge", "ground.origin", "wheel.origin", friction=friction)
    return scene.torque("drive", "wheel.origin", torque)


STOPS_AT = 0.4 + 0.6 / 3.5  # 0.6 rad/s at 0.4 s; the brake takes 7 of 10 N m out of it
BRAKED = 0.5 * 1.5 * 0.4**2 + 0.6**2 / 7


@pytest.mark.parametrize(
    "limit",
    ["where(t >= 0.4, 10, 0)", "where(t < 0.4, 0, 1) * pressure * 0.5", 'table("brake", t)', "10 * step(on)",
     "where(turn < 0.12, 0, 10)"],
)  # fmt: skip
def test_a_brake_by_time_inputs_tables_events_and_the_motion(model_of: Build, limit: str) -> None:
    """At 0.4 s, when it has turned by 0.12 rad, a brake of 10 N m takes hold, and holds."""
    scene = wheel({"coulomb": limit}, pressure=20.0)
    steep = {"x": [0.0, 0.4, 0.4 + 1e-9, 2.0], "y": [0.0, 0.0, 10.0, 10.0]}
    if "table" in limit:
        scene.table("brake", **steep)
    if "on" in limit:
        scene.input("on", -1.0).event("takes", "turn - 0.12", action={"on": 1.0})
    run = model_of(scene.simulation(t_end=1.0).build()).simulate(t_end=1.0, tolerance=1e-7)
    (stick,) = [event for event in run.events if event.kind == "mode"]
    assert run.status.name == "completed"
    assert stick.time == pytest.approx(STOPS_AT, abs=1e-6)
    assert run["turn"][-1] == pytest.approx(BRAKED, abs=1e-6)
    assert run["wheel.theta_dot"][-1] == 0.0


def test_a_brake_lets_go_where_its_limit_falls_below_what_it_holds(model_of: Build) -> None:
    """10 (0.5 - t) N m hold 3 N m until 0.2 s; a state follows a valve; 2 w' = 3 - 10 (0.5 - t) from there on."""
    run = model_of(wheel({"coulomb": "max(0, 10 * (0.5 - t))"}).simulation(t_end=0.5).build()).simulate(t_end=0.5)
    (slide,) = [event for event in run.events if event.kind == "mode"]
    assert slide.time == pytest.approx(0.2, abs=1e-9)
    assert run["wheel.theta_dot"][-1] == pytest.approx(2.5 * 0.3**2, abs=1e-9)
    valve = wheel({"coulomb": "valve"}).state("valve", rate="-5 * valve", initial=6.0)
    run = model_of(valve.simulation(t_end=0.5).build()).simulate(t_end=0.5, tolerance=1e-9)
    (slide,) = [event for event in run.events if event.kind == "mode"]
    assert slide.time == pytest.approx(np.log(2) / 5, abs=1e-8)


@pytest.mark.every_push("3.0")
@pytest.mark.parametrize("torque", ["3.0", "40.0", "0.1"])
@pytest.mark.parametrize(
    ("limit", "says"),
    [
        ("10 * (0.5 - t)", "hinge.friction: a limit of it becomes negative"),
        ("10 * sqrt(0.5 - t)", "joint 'hinge', friction, coulomb: sqrt(0.5 - t) has no value"),
    ],
)
def test_a_limit_that_is_none_ends_the_run_by_name(model_of: Build, torque: str, limit: str, says: str) -> None:
    """At 0.5 s, stuck or sliding."""
    model = model_of(wheel({"coulomb": limit}, torque).simulation(t_end=1.0).build())
    for how in ({}, {"scheme": "rk4", "dt": 0.003}, {"scheme": "dopri5", "tolerance": 1e-6}):
        run = model.simulate(**how)
        assert run.status.name in ("no_mode", "not_finite")
        assert run.status.time == pytest.approx(0.5, abs=3e-3)
        none = "hinge.friction: a limit of it becomes no number"  # seen by the element, or first by the load
        assert says in run.status.cause or none in run.status.cause


def test_what_holds_less_than_what_slides_ends_the_run(model_of: Build) -> None:
    friction = {"coulomb": 4.0, "breakaway": "5 - 2*t", "stribeck": 0.0}
    run = model_of(wheel(friction, "1.0").simulation(t_end=1.0).build()).simulate()
    assert (run.status.name, run.status.time) == ("no_mode", pytest.approx(0.5, abs=1e-6))


@pytest.mark.parametrize("scheme", ["rk4", "dopri5", "single_rate"])
@pytest.mark.parametrize("breakaway", [3.5, 5.0])
def test_what_lets_go_falls_to_coulomb_at_once(model_of: Build, scheme: str, breakaway: float) -> None:
    """stribeck = 0: 10 N m hold wheel A until 2.5 s, then 2 N m rub; B on A, 2 kg m2 each, holds up to its breakaway.

    With 3.5 N m it slides at once, since 4 N m would be needed: 2 a' = 4 t - 2 - 3, 2 b' = 3. With 5 N m it slides
    when 2 w' = (4 t - 2) / 2 = 5, at 3 s.
    """
    scene = Scene("cascade").rigid("A", mass=1.0, inertia=2.0).rigid("B", mass=1.0, inertia=2.0)
    scene.revolute("r", "ground.origin", "A.origin", friction={"coulomb": 2, "breakaway": 10, "stribeck": 0})
    scene.revolute("s", "A.origin", "B.origin", friction={"coulomb": 3, "breakaway": breakaway, "stribeck": 0})
    model = model_of(scene.torque("drive", "A.origin", "4 * t").simulation(t_end=4.0).build())
    run = model.simulate(scheme=scheme, dt=1e-3)
    at = {event.name: event.time for event in run.events if event.kind == "mode"}
    both = 3.0 if breakaway == 5.0 else 2.5
    assert at == pytest.approx({"r.friction": 2.5, "s.friction": both}, abs=1e-9)
    tau, left = 4.0 - both, both - 2.5
    w = (4 * 2.5 - 2) / 4 * left + left**2 / 2
    a, b = w + (4 * both - 5) / 2 * tau + tau**2, w + 1.5 * tau
    assert [run["A.theta_dot"][-1], run["B.theta_dot"][-1]] == pytest.approx([a, b], rel=1e-9)


@pytest.mark.parametrize(
    ("friction", "says"),
    [
        ({"coulomb": "10 * (t - 1)"}, "must be not negative"),
        ({"coulomb": "nothing * 3"}, "unknown name 'nothing'"),
        ({"coulomb": 5.0, "stribeck": 3.0, "stribeck_velocity": 0.1}, "is beyond what holds"),
        ({"coulomb": 5.0, "breakaway": 6.0, "stribeck": 0.0, "stribeck_velocity": 0.1}, "has no effect"),
    ],
)
def test_friction_that_makes_no_sense_is_refused(friction: dict[str, Any], says: str) -> None:
    with pytest.raises(SceneError, match=says.replace("(", r"\(")):
        wheel(friction).build()


def test_an_input_may_not_make_a_limit_negative(model_of: Build) -> None:
    """A stepper's user is told, and so is who gives no number."""
    model = model_of(wheel({"coulomb": "lim"}, lim=5.0).simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    stepper = model.stepper()
    stepper.step({"lim": 1.0}, 10)
    with pytest.raises(Exception, match="hinge.friction: a limit of it becomes negative"):
        stepper.step({"lim": -1.0}, 10)
    with pytest.raises(Exception, match=r"lim"):
        stepper.step({"lim": nan}, 10)
