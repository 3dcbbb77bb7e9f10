"""Stops, play and contact that push and never pull: closed forms, conservation, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from math import log, sqrt

import numpy as np
import pytest

from runtime import ensemble, simulate
from runtime.model import Model
from symgen import SceneError
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def slider(space: str, **fields: object) -> Scene:
    """2 kg on a rail, 1 m/s; its coordinate is `m.x` in the plane, `rail.travel` in space."""
    scene = Scene("slider", space=space)
    inertia: object = 0.1 if space == "planar" else (0.1, 0.1, 0.1)
    scene.rigid("m", mass=2.0, inertia=inertia).prismatic("rail", "ground.origin", "m.origin", **fields)
    scene.rates({"m.x" if space == "planar" else "rail.travel": 1.0})
    return scene.simulation(t_end=1.0, dt=0.001, scheme="rk4", seen_every=0.0)


def returned(damping: float, speed: float) -> float:
    """The speed u after a stop of Hunt and Crossley: v - ln(1 + D v) / D = -u - ln(1 - D u) / D, whatever k and n."""
    low, high = 0.0, speed
    for _ in range(200):
        u = (low + high) / 2
        left = speed - log(1 + damping * speed) / damping + u + log(1 - damping * u) / damping
        low, high = (low, u) if left < 0 else (u, high)
    return low


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
@pytest.mark.parametrize("exponent, order, most", [(1.0, 3.7, 4e-9), (2.0, 3.9, 5e-11), (1.5, 2.2, 4e-8)])
def test_a_stop_returns_what_hunt_and_crossley_say(
    model_of: Build, space: str, exponent: float, order: float, most: float
) -> None:
    limits = {"upper": 0.5, "stiffness": 3e4, "damping": 0.8, "exponent": exponent}
    model, exact = model_of(slider(space, limits=limits).build()), returned(0.8, 1.0)
    errors = []
    for dt in (5e-4, 2.5e-4):
        run = simulate(model, dt=dt, error="off")
        errors.append(abs(run.q_i[-1, 0] - run.q_i[-2, 0] + dt * exact) / dt)
        assert run.stats["kinks"] == 2 and not run.events
    assert np.log2(errors[0] / errors[1]) > order and errors[1] < most, errors


@pytest.mark.long
def test_limits_without_damping_keep_the_energy(model_of: Build) -> None:
    """Between two ends, nine times there and back."""
    limits = {"lower": -0.2, "upper": "reach", "stiffness": 4e4}
    scene = slider("planar", limits=limits).parameter("reach", 0.3, "m").simulation(t_end=9.0, dt=5e-4)
    run = simulate(model_of(scene.build()), scheme="exponential", seen_every=0.0)
    energy = run.energy["kinetic"] + run.energy["elastic"]
    assert np.ptp(energy) < 1e-9 and int(run.stats["kinks"]) > 30
    assert run["m.x"].min() == pytest.approx(-0.2 - sqrt(2 / 4e4), abs=1e-5)
    assert run["m.x"].max() == pytest.approx(0.3 + sqrt(2 / 4e4), abs=1e-5)


@pytest.mark.long
def test_play_of_a_joint_is_its_expression(model_of: Build) -> None:
    """k d + c d', no less than 0, no more than 2 k d, on both sides; the same as a torque by where, min and max."""

    def wheels(lash: bool) -> SceneRecord:
        scene = Scene("wheels").rigid("a", mass=1.0, inertia=5.0).rigid("b", mass=1.0, inertia=1.0)
        play = {"backlash": {"gap": 0.8, "stiffness": 20.0, "damping": 0.5}} if lash else {}
        scene.revolute("of_a", "ground.origin", "a.origin").revolute("of_b", "a.origin", "b.origin", **play)
        scene.measure("x", "coordinate", "a.theta").measure("y", "coordinate", "b.theta")
        beyond = "where({p} > 0.4, max(0, min(2*20*({p}-0.4), 20*({p}-0.4) + 0.5*{v})), 0)"
        law = f"{beyond.format(p='(y-x)', v='(y_dot-x_dot)')} - {beyond.format(p='(x-y)', v='(x_dot-y_dot)')}"
        if not lash:
            scene.torque("lash", "b.origin", f"-({law})", reaction="a.origin")
        scene.torque("drive", "a.origin", "10*sin(2.5*t) - 20*x").rates({"b.theta": 3.0})
        return scene.simulation(t_end=4.0, dt=0.004, scheme="rk4", seen_every=0.0).build()

    record, expression = (simulate(model_of(wheels(lash))) for lash in (True, False))
    assert np.abs(record.q - expression.q).max() < 1e-9 and record.stats["kinks"] == expression.stats["kinks"]
    assert abs(record.balance.largest) < 1e-3 * record.energy["kinetic"].max()


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_gear_with_play_lags_by_half_of_it(model_of: Build, space: str) -> None:
    """Driven slowly one way the wheel follows half the gap and the give of the teeth behind, M / k."""
    inertia = (lambda j: j) if space == "planar" else (lambda j: (j, j, j))
    scene = (
        Scene("gears", space=space)
        .rigid("a", mass=1.0, inertia=inertia(0.03))
        .rigid("b", mass=1.0, inertia=inertia(0.5))
    )
    scene.revolute("h_a", "ground.origin", "a.origin", damping=0.1)
    scene.revolute("h_b", "ground.origin", "b.origin", damping=2.0)
    scene.gear("mesh", "h_a.angle", "h_b.angle", -2.0, backlash={"gap": 0.02, "stiffness": 500.0, "damping": 5.0})
    scene.effort("drive", "h_a.angle", 0.6)
    run = simulate(model_of(scene.simulation(t_end=20.0, dt=0.01, scheme="rk4", seen_every=0.0).build()))
    a, b = (
        (run["a.theta"][-1], run["b.theta"][-1]) if space == "planar" else (run["h_a.angle"][-1], run["h_b.angle"][-1])
    )
    rate = 0.6 / (0.1 + 2.0 / 4)
    assert a + 2 * b == pytest.approx(0.01 + (0.6 - 0.1 * rate) / 500, rel=1e-6)


def disc(space: str) -> Scene:
    """A ball of 1 kg and 0.1 m on a table."""
    scene = Scene("disc", space=space)
    scene.gravity(0, -9.81) if space == "planar" else scene.gravity(0, 0, -9.81)
    inertia: object = 0.004 if space == "planar" else (0.004, 0.004, 0.004)
    scene.rigid("m", mass=1.0, inertia=inertia, free=True)
    law = {"stiffness": 1e5, "damping": 0.2, "exponent": 1.5, "friction": 0.3, "slip_speed": 1e-3}
    scene.load("contact", "floor", marker="m.origin", radius=0.1, plane="ground.origin", **law)
    return scene.rates({"m.x": 2.0}).simulation(t_end=1.0, dt=5e-4, scheme="rk4", seen_every=0.0)


@pytest.mark.parametrize("space, up", [("planar", "m.y"), ("spatial", "m.z")])
def test_a_ball_that_slides_comes_to_roll(model_of: Build, space: str, up: str) -> None:
    """By momentum about the floor 5/7 of its speed, whatever the friction."""
    run = simulate(model_of(disc(space).initial({up: 0.1001}).build()))
    assert run["m.x_dot"][-1] == pytest.approx(2 * 5 / 7, rel=1e-7)
    slide = 2 * 2 / 7 / (0.3 * 9.81)  # s, by Coulomb's law
    assert run["m.x"][-1] == pytest.approx(2 * slide - 0.3 * 9.81 * slide**2 / 2 + 10 / 7 * (1 - slide), abs=2e-3)


@pytest.mark.long
def test_two_discs_exchange_momentum(model_of: Build) -> None:
    """Linear and angular momentum stay; in an exchange head on the speeds are those of an elastic one."""

    def pair(offset: float, spin: float, **law: float) -> SceneRecord:
        scene = (
            Scene("pair").rigid("a", mass=1.0, inertia=0.01, free=True).rigid("b", mass=3.0, inertia=0.01, free=True)
        )
        ball = {"marker": "a.origin", "radius": 0.1, "other": "b.origin", "other_radius": 0.2}
        scene.load("contact", "hit", **ball, stiffness=1e5, exponent=2.0, **law)
        scene.initial({"b.x": 0.5, "b.y": offset}).rates({"a.x": 1.0, "a.theta": spin})
        return scene.simulation(t_end=0.4, dt=1e-4, scheme="rk4", seen_every=0.0).build()

    run = simulate(model_of(pair(0.0, 0.0)))
    assert [run["a.x_dot"][-1], run["b.x_dot"][-1]] == pytest.approx([-0.5, 0.5], abs=1e-8)
    run = simulate(model_of(pair(0.05, 3.0, friction=0.4)))
    masses, r, v = {"a": 1.0, "b": 3.0}, {}, {}
    for one in masses:
        r[one], v[one] = (np.column_stack([run[f"{one}.{c}{end}"] for c in "xy"]) for end in ("", "_dot"))
    assert np.abs(sum(m * v[one] for one, m in masses.items()) - [1.0, 0.0]).max() < 1e-13
    about = sum(m * (r[one][:, 0] * v[one][:, 1] - r[one][:, 1] * v[one][:, 0]) for one, m in masses.items())
    angular = about + 0.01 * (run["a.theta_dot"] + run["b.theta_dot"])
    assert np.ptp(angular) < 1e-7 and abs(run["b.theta_dot"][-1]) > 0.1


@pytest.mark.parametrize(
    "fields, item, says",
    [
        ({"limits": {"stiffness": 1.0}}, "'rail'.limits", "have neither lower nor upper"),
        ({"limits": {"lower": 0.5, "upper": 0.5, "stiffness": 1.0}}, "'rail'.limits", "not below upper"),
        ({"limits": {"lower": 0.5, "stiffness": 0.0}}, "'rail'.limits.stiffness", "positive"),
        ({"limits": {"lower": 0.5, "stiffness": 1.0, "exponent": 0.5}}, "limits.exponent", "1"),
        ({"limits": {"lower": 0.5, "stiffness": 1.0, "damping": -1.0}}, "'rail'.limits.damping", "negative"),
        ({"backlash": {"gap": -0.1, "stiffness": 1.0}}, "'rail'.backlash.gap", "negative"),
    ],
)
def test_bad_stops_are_refused_by_name(fields: dict[str, object], item: str, says: str) -> None:
    with pytest.raises(SceneError) as raised:
        slider("planar", **fields).build()
    assert item in str(raised.value) and says in str(raised.value), raised.value


def test_a_hinge_that_closes_a_loop_in_space_has_no_limits() -> None:
    """It has no angle there."""
    scene = Scene("loop", space="spatial").rigid(
        "a", mass=1.0, inertia=(1.0, 1.0, 1.0), markers={"tip": {"position": (1, 0, 0)}}
    )
    scene.revolute("one", "ground.origin", "a.origin").ground(markers={"end": {"position": (1, 0, 0)}})
    scene.revolute("two", "ground.end", "a.tip", limits={"upper": 1.0, "stiffness": 1e4})
    with pytest.raises(SceneError, match="two.*no angle of its own"):
        scene.build()


@pytest.mark.parametrize(
    "fields, item, says",
    [
        ({}, "'hit'.plane", "needs plane or other"),
        ({"plane": "ground.origin", "other": "m.origin"}, "'hit'.plane", "needs plane or other, and not both"),
        ({"other": "ground.origin", "radius": 0.0}, "'hit'.radius", "never touch"),
        ({"plane": "ground.origin", "other_radius": 0.2}, "'hit'.other_radius", "a second ball"),
        ({"plane": "ground.origin", "slip_speed": 0.0}, "'hit'.slip_speed", "positive"),
        ({"plane": "ground.nowhere"}, "nowhere", "marker"),
    ],
)
def test_bad_contacts_are_refused_by_name(fields: dict[str, object], item: str, says: str) -> None:
    scene = slider("planar").load(
        "contact", "hit", **({"marker": "m.origin", "radius": 0.1, "stiffness": 1e4} | fields)
    )
    with pytest.raises(SceneError) as raised:
        scene.build()
    assert item in str(raised.value) and says in str(raised.value), raised.value


def braked_rod() -> SceneRecord:
    """A rod that falls onto a stop of 400 N m/rad; each time it turns back an event makes a brake stronger."""
    rod = Scene("braked_rod").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    rod.revolute("pin", "ground.origin", "rod.origin", limits={"lower": -1.0, "stiffness": 400.0})
    rod.measure("angle", "coordinate", "rod.theta").input("brake").torque("brake", "rod.origin", "-brake")
    rod.event("turns", "angle_dot", direction="falling", action={"brake": "brake + 0.3"})
    return rod.simulation(t_end=2.0, dt=0.01, scheme="rk4", seen_every=0.0).build()


def test_errors_across_stops_and_events_are_told(model_of: Build) -> None:
    """Within a factor 10 of the true ones, with steps of one length and with a tolerance, which is delivered."""
    model = model_of(braked_rod())
    exact = simulate(model, dt=2e-4, seen_every=0.01, error="off").q_i[:, 0]
    runs = [simulate(model, dt=dt, seen_every=0.01) for dt in (0.01, 0.005, 0.0025)]
    runs += [simulate(model, scheme="auto", tolerance=tolerance, seen_every=0.01) for tolerance in (1e-4, 1e-6)]
    for run, asked in zip(runs, (1e-2, 1e-3, 1e-4, 1e-4, 1e-6), strict=True):
        true = np.sqrt(np.mean((run.q_i[:, 0] - exact) ** 2)) / exact.std()
        assert true < asked and true / 10 < run.error.largest < 10 * true, (true, run.error.largest)
        assert run.status.ok and {event.name for event in run.events} == {"turns"}


def test_cases_that_come_to_a_stop_are_the_runs_by_themselves(model_of: Build) -> None:
    """Bit for bit, beside cases that never do."""
    model = model_of(slider("planar", limits={"upper": 0.5, "stiffness": 3e4, "damping": 0.8}).build())
    speeds = np.array([0.2, 0.9, -1.0, 2.0])
    found = ensemble(model, initial={"m.x_dot": speeds}, outputs=["m.x"])
    for k, speed in enumerate(speeds):
        run = simulate(model, initial={"m.x_dot": float(speed)}, error="off")
        assert np.ravel(found["m.x"][k])[-1] == run["m.x"][-1]
