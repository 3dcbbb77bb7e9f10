"""Friction by the joint's own force: mu R of slides, mu R radius of hinges, by hand and against equations by hand."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, hypot, sin
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from runtime import SCHEMES, Model, ModelError, simulate
from runtime.export.c_bundle import exported
from runtime.gradients import End
from symgen.scene import Scene, SceneError, SceneRecord

Build = Callable[[SceneRecord], Model]
GRAVITY = 9.81
TILT = 0.6  # rad


def incline(mu: float, push: str = "0", slope: float = -TILT, **more: Any) -> SceneRecord:
    """2 kg on a rail, pushed along x."""
    scene = Scene("incline").gravity(0.0, -GRAVITY)
    scene.ground(markers={"rail": {"position": (0, 0), "angle": slope}}).rigid("m", mass=2.0, inertia=0.1)
    scene.prismatic("rail", "ground.rail", "m.origin", friction={"mu": mu, **more}).initial({"m.theta": slope})
    scene.force("push", "m.origin", push, 0.0)
    return scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


def pendulum(space: str, mu: float | str, radius: float = 0.05, **more: Any) -> Scene:
    """A rod of 1 kg and 1 m that falls from level; its angle is rod.theta, or pin.angle in space."""
    spatial = space == "spatial"
    scene = Scene("pendulum", space=space).gravity(*((0.0, -GRAVITY, 0.0)[: 3 if spatial else 2]))
    about: Any = (0.1, 0.1, 0.1) if spatial else 0.1
    scene.rigid("rod", mass=1.0, inertia=about, center_of_mass=(0.5, 0.0, 0.0) if spatial else (0.5, 0.0))
    scene.revolute("pin", "ground.origin", "rod.origin", friction={"mu": mu, "radius": radius, **more})
    return scene.simulation(t_end=1.5, dt=0.01, scheme="rk4")


def test_a_block_slides_down_a_slope_or_stays(model_of: Build) -> None:
    """By hand: g (sin - mu cos) t^2 / 2 below tan = 0.684, nothing above, held by the weight's share."""
    run = simulate(model_of(incline(0.3)))
    way = GRAVITY * (sin(TILT) - 0.3 * cos(TILT)) / 2
    assert hypot(run["m.x"][-1], run["m.y"][-1]) == pytest.approx(way, rel=1e-13)
    assert run.friction("rail").force[-1] == pytest.approx(-0.3 * 2 * GRAVITY * cos(TILT), rel=1e-13)
    assert run.friction("rail").heat[-1] == pytest.approx(0.3 * 2 * GRAVITY * cos(TILT) * way, rel=1e-9)
    run = simulate(model_of(incline(0.8)))
    assert not run["m.x"].any() and run.friction("rail").force[-1] == pytest.approx(-2 * GRAVITY * sin(TILT), rel=1e-13)


def test_a_push_presses_the_block_upon_its_rail(model_of: Build) -> None:
    """Pushed up by p = 40 t along x: off where p cos - m g sin = mu (m g cos + p sin), then by the same difference."""
    run = simulate(model_of(incline(0.3, "40 * t", slope=TILT)))
    s, c, weight = sin(TILT), cos(TILT), 2 * GRAVITY
    down = weight * (s - 0.3 * c) / (40 * (c + 0.3 * s))  # s: until then it slides down
    up = weight * (s + 0.3 * c) / (40 * (c - 0.3 * s))

    def along(t: np.ndarray, y: np.ndarray, side: int) -> list[float]:
        p = 40 * float(t)
        return [y[1], (p * c - weight * s - side * 0.3 * (weight * c + p * s)) / 2]

    def still(t: float, y: np.ndarray, side: int) -> float:
        return float(y[1]) if t > 0.05 else -1.0

    still.terminal = True  # type: ignore[attr-defined]
    first = solve_ivp(along, (0, 1), [0.0, 0.0], "DOP853", rtol=1e-12, atol=1e-13, args=(-1,), events=still)
    assert down < first.t[-1] < up  # it comes to rest, and waits
    last = solve_ivp(along, (up, 1.0), [first.y[0, -1], 0.0], "DOP853", rtol=1e-12, atol=1e-13, args=(1,))
    times = {event.text.rsplit("friction ", 1)[1]: event.time for event in run.events}
    assert times == pytest.approx({"sticks": first.t[-1], "slides forwards": up}, abs=1e-9)
    assert run["m.x"][-1] / c == pytest.approx(last.y[0, -1], abs=1e-9)


def angular(mu_r: float, angle: float, rate: float) -> float:
    """Of a rod on a bearing: 0.35 a = -4.905 cos - sign mu r |R(a)|, R = m (acceleration of the centre - g)."""

    def left(a: float) -> float:
        x = 0.5 * (-a * sin(angle) - rate**2 * cos(angle))
        y = 0.5 * (a * cos(angle) - rate**2 * sin(angle)) + GRAVITY
        return 0.35 * a + 0.5 * GRAVITY * cos(angle) + np.sign(rate) * mu_r * hypot(x, y)

    return float(brentq(left, -100, 100, xtol=1e-13, rtol=1e-14))


@pytest.mark.every_push("0.3-planar", "3.0-spatial", "planar-0.3", "spatial-3.0")
@pytest.mark.parametrize("space", ["planar", "spatial"])
@pytest.mark.parametrize("mu", [0.3, 3.0])
def test_a_rod_on_its_bearing(model_of: Build, space: str, mu: float) -> None:
    """Up to its first reversal, in the order of rk4."""
    model, name = model_of(pendulum(space, mu).build()), "rod.theta" if space == "planar" else "pin.angle"
    start, t = [0.0, -1e-9], np.arange(0, 0.81, 0.1)
    twin = solve_ivp(lambda t, y: [y[1], angular(mu * 0.05, *y)], (0, 0.8), start, "DOP853", t, rtol=1e-11, atol=1e-12)
    errors = []
    for dt in (0.02, 0.01):
        run = simulate(model, t_end=0.8, dt=dt, seen_every=0.1)
        errors.append(np.abs(run[name] - twin.y[0]).max())
    assert errors[1] < 2e-7 and errors[0] / errors[1] > 11
    assert run.balance.largest < 1e-2


@pytest.mark.every_push("rk4", "radau")
@pytest.mark.parametrize("scheme", sorted({"rk4", "exponential", "dopri5", "radau", "single_rate"} & set(SCHEMES)))
def test_every_scheme_brings_the_rod_to_the_same_rest(model_of: Build, scheme: str) -> None:
    """It swings to and fro and sticks where its weight is within mu r R, without creep; order of each scheme."""
    model = model_of(pendulum("planar", 3.0).build())
    runs = [simulate(model, scheme=scheme, t_end=6.0, dt=dt, seen_every=0.1) for dt in (0.01, 0.005)]
    fine = simulate(model, scheme="rk4", t_end=6.0, dt=0.0025, seen_every=0.1)
    assert [event.text for event in runs[1].events] == [event.text for event in fine.events]
    assert fine.events[-1].text.endswith("sticks") and fine["rod.theta_dot"][-1] == 0.0
    errors = [np.abs(run["rod.theta"] - fine["rod.theta"]).max() for run in runs]
    assert errors[1] < (1e-3 if scheme == "single_rate" else 1e-6)
    assert errors[0] / errors[1] > 3 or errors[0] < 1e-8
    held = abs(fine.friction("pin").force[-1])
    assert held == pytest.approx(0.5 * GRAVITY * abs(cos(fine["rod.theta"][-1])), rel=1e-12)
    assert held < 3.0 * 0.05 * GRAVITY and np.ptp(fine["rod.theta"][-5:]) == 0.0


@pytest.mark.long
def test_three_links_share_their_reactions(model_of: Build) -> None:
    """Bearings of a chain feel each other: R of the run is that of its own reactions, and the order that of rk4."""
    scene, last = Scene("chain").gravity(0.0, -GRAVITY), "ground.origin"
    for k in range(3):
        scene.rigid(
            f"l{k}", mass=1.0, inertia=0.08, center_of_mass=(0.5, 0.1), markers={"tip": {"position": (1.0, 0.0)}}
        )
        scene.revolute(f"j{k}", last, f"l{k}.origin", friction={"mu": 0.4, "radius": 0.05, "viscous": 0.01})
        last = f"l{k}.tip"
    model = model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    runs = [simulate(model, dt=dt, seen_every=0.02) for dt in (0.01, 0.005, 0.0025)]
    assert len({tuple(event.text for event in run.events) for run in runs}) == 1
    errors = [np.abs(run.q - runs[2].q).max() for run in runs[:2]]
    assert errors[1] < 1e-6 and errors[0] / errors[1] > 8
    for k in range(3):
        size = np.hypot(*runs[2].joint_force(f"j{k}")[:, :2].T)
        rub = runs[2].friction(f"j{k}")
        slides = rub.mode != 0
        law = -rub.mode * 0.4 * 0.05 * size - 0.01 * rub.velocity
        assert slides.sum() > 10 and rub.force[slides] == pytest.approx(law[slides], abs=1e-11)


def test_a_coefficient_beyond_its_bound_is_refused_by_name(model_of: Build) -> None:
    """A light rod close to its bearing: a = mu r (m l / J) |R| turns R by mu r m l / J = 0.71 a newton at mu = 1."""
    scene = Scene("light").gravity(0.0, -GRAVITY).rigid("rod", mass=1.0, inertia=0.001, center_of_mass=(0.05, 0.0))
    scene.parameter("mu", 1.0, "1").rates({"rod.theta": 1.0})
    scene.revolute("pin", "ground.origin", "rod.origin", friction={"mu": "mu", "radius": 0.05})
    model = model_of(scene.simulation(t_end=0.2, dt=0.01, scheme="rk4").build())
    run = simulate(model)
    assert run.status.name == "no_mode" and "pin.friction: the joint's own force rises" in str(run.status)
    assert simulate(model, parameters={"mu": 0.65}).status.ok  # 0.46
    assert simulate(model, parameters={"mu": 10.0}, initial={"rod.theta_dot": 0.0}).status.ok  # it holds


def test_what_knows_no_reactions_says_so(model_of: Build) -> None:
    model = model_of(pendulum("planar", 0.3).build())
    for ask in (model.equilibrium, lambda: model.coriolis([0.5], [1.0]), lambda: exported(model)):
        with pytest.raises(ModelError, match=r"pin\.friction of model pendulum: follows from reactions by mu, which"):
            ask()
    assert model.mass_matrix([0.5]) == pytest.approx(0.1 + 0.5**2, rel=1e-14)  # by hand: friction is no part of M


@pytest.mark.parametrize(
    ("joint", "friction", "item", "says"),
    [
        ("prismatic", {"coulomb": 1.0, "mu": 0.3}, "friction", "has coulomb and mu"),
        ("prismatic", {"viscous": 1.0}, "friction", "does not say how much"),
        ("prismatic", {"mu": 0.3, "radius": 0.1}, "friction.radius", "applies to hinges only"),
        ("revolute", {"mu": 0.3}, "friction.radius", "is missing"),
        ("prismatic", {"mu": 0.3, "breakaway": 2.0}, "friction.breakaway", "does not go with mu"),
        ("prismatic", {"coulomb": 1.0, "mu_static": 2.0}, "friction.mu_static", "does not go with coulomb"),
        ("prismatic", {"mu": 0.3, "mu_static": 0.2, "stribeck_velocity": 0.1}, "friction.mu_static", "is below mu"),
        ("prismatic", {"mu": 0.3, "mu_static": 0.4}, "friction", "falls from mu_static to mu over no velocity"),
        ("prismatic", {"mu": -0.3}, "friction.mu", "negative"),
    ],
)
def test_friction_by_reactions_that_cannot_be_is_refused(
    joint: str, friction: dict[str, float], item: str, says: str
) -> None:
    scene = Scene("m").rigid("m", mass=1.0, inertia=0.1)
    with pytest.raises(SceneError) as raised:
        getattr(scene, joint)("seat", "ground.origin", "m.origin", friction=friction).build()
    assert f"'seat'.{item}" in str(raised.value) and says in str(raised.value), raised.value


def test_redundant_joints_leave_reactions_open(model_of: Build) -> None:
    scene = Scene("twice").rigid("m", mass=1.0, inertia=0.1, markers={"end": {"position": (1.0, 0.0)}})
    scene.prismatic("rail", "ground.origin", "m.origin", friction={"mu": 0.3})
    scene.prismatic("again", "ground.origin", "m.end")
    with pytest.raises(SceneError, match=r"rail\.friction\.mu.*redundant joints leave it open"):
        model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())


def test_slow_sliding_rubs_more(model_of: Build) -> None:
    """mu_static holds, and falls to mu over the velocity: pulled by 4 t off at mu_static m g / 4."""
    model = model_of(incline(0.1, "4 * t", slope=0.0, mu_static=0.2, stribeck_velocity=0.01))
    run = simulate(model, t_end=3.0)
    (off,) = (event.time for event in run.events)
    assert off == pytest.approx(0.2 * 2 * GRAVITY / 4, abs=1e-9)
    assert run["rail.friction_force"][-1] == pytest.approx(-0.1 * 2 * GRAVITY, rel=1e-9)


def test_a_run_is_differentiated_by_mu(model_of: Build) -> None:
    """Across two reversals of the rod, against differences of runs."""
    model = model_of(pendulum("planar", "mu").parameter("mu", 1.0, "1").build())
    steps: Any = {"t_end": 2.5, "dt": 0.005, "scheme": "rk4"}
    found = model.gradient(End("rod.theta"), ["mu"], **steps)
    ends = [simulate(model, parameters={"mu": mu}, error="off", **steps)["rod.theta"][-1] for mu in (1.0001, 0.9999)]
    assert found.derivatives[0] == pytest.approx((ends[0] - ends[1]) / 2e-4, rel=1e-6)


def stopped_crank(**laws: dict[str, float]) -> Scene:
    """A slider-crank whose bearings A and B rub by what presses on them, with an end stop of its slide."""
    scene = Scene("stopped_crank").gravity(0, -GRAVITY)
    scene.rigid("c", mass=1.9787, inertia=0.00378463475625, center_of_mass=(0.07575, 0),
                markers={"tip": {"position": (0.1515, 0)}})  # fmt: skip
    scene.rigid("k", mass=1.3757, inertia=0.03371488635441667, center_of_mass=(0.27115, 0),
                markers={"tip": {"position": (0.5423, 0)}})  # fmt: skip
    scene.rigid("s", mass=1.4464, inertia=0.001)
    scene.revolute("A", "ground.origin", "c.origin", friction=laws["A"])
    scene.revolute("B", "c.tip", "k.origin", friction=laws["B"]).revolute("C", "k.tip", "s.origin")
    scene.prismatic("D", "ground.origin", "s.origin", limits={"lower": 0.4717, "restitution": 0.0})
    scene.torque("q", "c.origin", "3.9797 * sin(4.5106 * t + 2.5083)").independent("c.theta")
    scene.initial({"c.theta": {"value": -1.02, "fixed": True}, "k.theta": 0.24035735528428023, "s.x": 0.606})
    return scene.rates({"c.theta": {"value": 3.92, "fixed": True}})


FALLING = {
    "A": {"mu": 0.4915, "mu_static": 0.695, "radius": 0.0514, "stribeck_velocity": 0.0861},
    "B": {"mu": 0.273, "mu_static": 0.3137, "radius": 0.0414, "stribeck_velocity": 0.1898},
}


@pytest.mark.long
@pytest.mark.parametrize("steps", [{"scheme": "dopri5", "dt": 1.45e-3}, {"tolerance": 1e-4}], ids=["dt", "tolerance"])
def test_a_stop_beside_two_frictions_lets_go(model_of: Build, steps: dict[str, Any]) -> None:
    """Event-driven equations by hand: it leaves at 0.846554 s and comes to 1.330134 rad; the stop never pulls."""
    run = simulate(model_of(stopped_crank(**FALLING).build()), t_end=1.45, **steps)
    assert run.status.name == "completed" and run["D.stop_force"].min() >= 0
    assert run["c.theta"][-1] == pytest.approx(1.330134, abs=2e-6)
    leaves = [event.time for event in run.events if event.name == "A.friction" and "forwards" in event.text]
    assert leaves[-1] == pytest.approx(0.846554, abs=2e-6)
    rests = (run.t > 0.43) & (run.t < 0.8465)
    assert rests.any() and not run["c.theta_dot"][rests].any()


def test_a_wrong_choice_of_modes_ends_the_run(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stop that would pull is named where it is decided (interpreted: in Python), and behind it where missed."""
    scene = Scene("thrown").gravity(0, -GRAVITY).rigid("ball", mass=1.0, inertia=0.1)
    scene.ground(markers={"up": {"position": (0, 0), "angle": np.pi / 2}})
    scene.prismatic("rail", "ground.up", "ball.origin", limits={"lower": 0.0, "restitution": 0.0})
    scene.force("lift", "ball.origin", 0.0, "40 * t").initial({"ball.y": 0.05})
    model = model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    assert simulate(model).status.name == "completed"

    def all_hold(A: np.ndarray, b: np.ndarray, *_: Any) -> np.ndarray:
        return np.zeros(len(b), dtype=int)

    monkeypatch.setattr("runtime.schemes.switching.settle.complementary", all_hold)
    run = simulate(model, engine="interpreted")
    assert run.status.name == "no_mode" and "rail.limits.lower" in run.status.cause and run.t[-1] < 0.26
    monkeypatch.setattr("runtime.schemes.switching.settle.broken_law", lambda *_: None)
    run = simulate(model, engine="interpreted")
    assert run.status.name == "no_mode" and "rail.limits.lower pulls" in run.status.cause
