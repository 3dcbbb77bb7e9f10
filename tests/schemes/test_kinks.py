"""Loads with a kink in the motion, such as max(0, ...): steps end there by themselves; what a start upon it costs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from runtime.running.stepping import ModelStepper
from symgen.scene import Scene, SceneRecord
from tests.support.prepared_runs import PreparedRuns
from tests.support.scenes import on_hinge, on_rail

Build = Callable[[SceneRecord], Model]
T_END, DT = 0.16, 0.01


def against_a_stop(angle: float) -> SceneRecord:
    """A rod that turns with 2 rad/s against a stop that pushes back beyond its horizontal position."""
    builder = Scene("against_a_stop").gravity(0, -9.81)
    builder.rigid(
        "rod", mass=1.0, inertia=0.1, markers={"hinge": {"position": (-0.5, 0)}, "tip": {"position": (0.5, 0)}}
    )
    builder.revolute("hinge", "ground.origin", "rod.hinge").measure("height", "y", of="rod.tip")
    builder.force("stop", "rod.tip", 0, "max(0, -60 * height)")
    builder.initial({"rod.theta": angle}).rates({"rod.theta": -2.0})
    return builder.simulation(t_end=T_END, dt=DT, scheme="rk4").build()


@pytest.mark.parametrize(
    "scheme, angle, order, most",
    [("exponential", -0.02, 4, 2.5e-11), ("exponential", 0.0, 2, 6e-6), ("radau", 0.0, 5, 3e-12)],
)
def test_a_start_on_a_kink(model_of: Build, scheme: str, angle: float, order: float, most: float) -> None:
    """The first step is linearised without the stop that it goes into: h^2 once, where others keep their order."""
    model = model_of(against_a_stop(angle))
    wanted = PreparedRuns(model, "dop853", engine="interpreted").end(T_END, DT / 8)
    runs = PreparedRuns(model, scheme, [1] if scheme == "exponential" else None, engine="interpreted")
    errors = [float(np.abs(runs.end(T_END, h) - wanted).max()) for h in (DT / 2, DT / 4)]
    assert errors[1] < most, errors
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1), errors


# ---- kinks that the motion comes to on the way: steps end there by themselves


def stop_of_a_rod() -> SceneRecord:
    """A rod of 1 kg that falls from the horizontal onto an elastic stop of 2000 N m/rad at -1.2 rad."""
    rod = Scene("stop_of_a_rod").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0))
    rod.revolute("pin", "ground.origin", "rod.origin").measure("a", "coordinate", "rod.theta")
    rod.torque("stop", "rod.origin", "where(a<-1.2, 2000*(-1.2-a), 0)")
    return rod.simulation(t_end=0.6, dt=0.02, scheme="rk4", seen_every=0.0).build()


def stop_of_a_tip() -> SceneRecord:
    """The same rod; its tip meets a spring that acts on one side."""
    rod = Scene("stop_of_a_tip").gravity(0, -9.81)
    rod.rigid("rod", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
    rod.revolute("pin", "ground.origin", "rod.origin").measure("tipx", "x", "rod.tip")
    rod.force("spring", "rod.tip", "-1e5*max(0,tipx-0.2)", 0.0).initial({"rod.theta": -3.0})
    return rod.simulation(t_end=0.7, dt=0.001, scheme="rk4", seen_every=0.0).build()


def backlash() -> SceneRecord:
    """Two wheels with 45 degrees of play: beyond it c (p -+ b/2) + d p', never pulling, at most twice the spring."""
    wheels = Scene("backlash").rigid("a", mass=1.0, inertia=5.0).rigid("b", mass=1.0, inertia=1.0)
    wheels.revolute("of_a", "ground.origin", "a.origin").revolute("of_b", "ground.origin", "b.origin")
    wheels.measure("x", "coordinate", "a.theta").measure("y", "coordinate", "b.theta")
    wheels.parameter("e", np.pi / 8, "rad")
    beyond = "where({p} > e, max(0, min(2*20*({p}-e), 20*({p}-e) + 0.5*{v})), 0)"
    law = f"{beyond.format(p='(y-x)', v='(y_dot-x_dot)')} - {beyond.format(p='(x-y)', v='(x_dot-y_dot)')}"
    wheels.torque("lash", "b.origin", f"-({law})", reaction="a.origin")
    wheels.torque("drive", "a.origin", "10*sin(2.5*t) - 20*x").rates({"b.theta": 3.0})
    return wheels.simulation(t_end=4.0, dt=0.008, scheme="rk4", seen_every=0.0).build()


@pytest.mark.every_push("stop_of_a_rod")
@pytest.mark.parametrize(
    "scene, dt, order, most, lost",
    [
        (stop_of_a_rod, 0.005, 3.8, 2e-5, 1e-3),
        (stop_of_a_tip, 0.00025, 3.8, 2e-5, 1e-4),
        (backlash, 0.004, 3.9, 1e-9, 1e-6),
    ],
)
def test_steps_end_at_kinks_by_themselves(
    model_of: Build, scene: Callable[[], SceneRecord], dt: float, order: float, most: float, lost: float
) -> None:
    """rk4 has order 4 and tells its error to a factor 10, without a word about the kinks; crossed they cost that."""
    model = model_of(scene())
    ends, told = [], []
    for h in (dt, dt / 2, dt / 32):
        run = simulate(model, dt=h, error="measured" if h > dt / 4 else "off")
        ends.append(run.q[-1])
        told.append(max(run.error.at_end.values(), default=0.0))
        assert run.status.ok and not run.events and run.stats["kinks"]
    errors = [float(np.abs(end - ends[2]).max()) for end in ends[:2]]
    assert np.log2(errors[0] / errors[1]) > order and errors[1] < most, errors
    assert all(error / 10 < one < 10 * error for one, error in zip(told, errors, strict=False)), (told, errors)
    crossed = simulate(model, dt=dt, options={"kinks": "crossed"})
    assert float(np.abs(crossed.q[-1] - ends[2]).max()) > lost
    owner = model.description.kinks[0]
    assert [(one.kind, one.name) for one in crossed.events] == [("kink_crossed", owner)]
    assert owner in crossed.events[0].text and "kinks" in crossed.events[0].text


@pytest.mark.every_push("exponential_rk4-3.8", "single_rate-1.9")
@pytest.mark.parametrize(
    "scheme, order", [("exponential_rk4", 3.8), ("exponential", 3.8), ("single_rate", 1.9), ("dopri5", 4.3)]
)
def test_schemes_keep_their_order_across_kinks(model_of: Build, scheme: str, order: float) -> None:
    model = model_of(backlash())
    ends = [simulate(model, scheme=scheme, dt=h, error="off").q[-1] for h in (0.016, 0.004, 0.001)]
    first, second = (float(np.abs(end - ends[2]).max()) for end in ends[:2])
    assert np.log2(first / second) / 2 > order, (first, second)


def test_a_tolerance_ends_steps_at_kinks(model_of: Build) -> None:
    """Energy of a rod on an elastic stop, by steps of a tolerance that end at both sides of each contact."""
    run = simulate(
        model_of(stop_of_a_rod()), scheme="dopri5", tolerance=1e-9, options={"error_of": "step"}, seen_every=0.02
    )
    spring = 1000 * np.minimum(0, run["rod.theta"] + 1.2) ** 2
    energy = run.energy["kinetic"] + run.energy["potential"] + spring
    assert np.ptp(energy) < 1e-7 and int(run.stats["kinks"]) >= 2 and not run.events


def sticking() -> SceneRecord:
    """Dry friction by its sign, which sticks half of the time: the velocity comes to zero ever again."""
    mass = on_rail("sticking", "m", "rail", mass=1.0, inertia=0.1)
    mass.measure("x", "coordinate", "m.x").force("f", "m.origin", "-3*sign(x_dot) + 2*sin(2*pi*t)", 0.0)
    return mass.rates({"m.x": 1.0}).simulation(t_end=1.0, dt=0.001, scheme="rk4", seen_every=0.0).build()


@pytest.mark.every_push("exponential-None")
@pytest.mark.parametrize("scheme, tolerance", [("exponential", None), ("dopri5", 1e-6)])
def test_a_kink_that_comes_ever_again_is_crossed(model_of: Build, scheme: str, tolerance: float | None) -> None:
    """The run goes on as with steps that cross it, and says so: it slides from 1 m/s, then stays."""
    options = {"error_of": "step"} if tolerance else None
    run = simulate(model_of(sticking()), scheme=scheme, tolerance=tolerance, options=options)
    assert run.status.ok and {one.kind for one in run.events} == {"chattering", "kink_crossed"}
    assert np.abs(run["m.x"][run.t > 0.7] - run["m.x"][-1]).max() < 2e-3 and int(run.stats["kinks"]) < 1000


def test_drag_of_what_stands_still_finds_no_kink(model_of: Build) -> None:
    """abs(v) of velocities that die down to rounding: no search at every step."""
    disc = on_hinge("drag", "disc", "pin", mass=1.0, inertia=0.1)
    disc.measure("a", "coordinate", "disc.theta").torque("air", "disc.origin", "-abs(a_dot)*a_dot - 5*a - 3*a_dot")
    disc.rates({"disc.theta": 0.5}).simulation(t_end=50.0, dt=0.005, scheme="rk4", seen_every=0.5)
    run = simulate(model_of(disc.build()))
    assert run.status.name == "completed" and not run.events and int(run.stats["kinks"]) < 20


def test_steppers_and_resumed_runs_end_steps_at_kinks(model_of: Build) -> None:
    """The bits of the run."""
    model = model_of(stop_of_a_rod())
    run, stepper = simulate(model, dt=0.005), ModelStepper(model, dt=0.005)
    for _ in range(60):
        stepper.step()
    kept = stepper.save()
    stepper.step(60)
    assert stepper.events == [] and stepper.sample.q[0, 2] == run["rod.theta"][-1]
    stepper.restore(kept)
    stepper.step(60)
    assert stepper.sample.q[0, 2] == run["rod.theta"][-1]


def test_a_scene_without_kinks_watches_nothing(model_of: Build) -> None:
    """Conditions in time alone, and smooth loads, are no kinks: their steps have nothing of it."""
    rod = on_hinge("smooth", "rod", "pin", mass=1.0, inertia=0.1)
    rod.measure("a", "coordinate", "rod.theta").torque("drive", "rod.origin", "where(t < 1, 1, 0) - 2*sin(a)")
    model = model_of(rod.simulation(t_end=0.1, dt=0.01, scheme="rk4").build())
    assert model.description.kinks == [] and not model.has("events")


@pytest.mark.long
def test_kinks_stand_beside_friction_and_events(model_of: Build) -> None:
    """Friction that sticks, a stop and an event on one rail, with kinks located and crossed."""
    rail = Scene("rubbing").rigid("m", mass=1.0, inertia=0.1)
    stops = {"lower": -0.4, "upper": 0.4, "stiffness": 4e4, "damping": 0.3}
    rail.prismatic("rail", "ground.origin", "m.origin", friction={"coulomb": 3.0}, limits=stops)
    rail.measure("x", "coordinate", "m.x").force("f", "m.origin", "-50*(x+0.25)", 0.0).event(
        "e", "x", direction="rising"
    )
    model = model_of(rail.rates({"m.x": -5.0}).simulation(t_end=2.0, dt=2.5e-4, scheme="rk4", seen_every=2e-3).build())
    located, crossed = simulate(model), simulate(model, options={"kinks": "crossed"})
    assert located.stats["kinks"] == 4 and located["m.x_dot"][-1] == 0.0
    assert [event.kind for event in located.events if event.name != "rail.friction"] == ["event"]
    assert [event.name for event in crossed.events if event.kind == "kink_crossed"] == ["rail"]
    assert crossed["m.x"][-1] == pytest.approx(located["m.x"][-1], abs=1e-3)


# ---- loads that jump where the motion comes to a place: all stages of a step see its near side


def pushed_by_place(law: str, x: float, v: float) -> SceneRecord:
    """1 kg on a rail under a force by its place x."""
    mass = on_rail("by_place", "m", "rail", mass=1.0, inertia=0.1).measure("x", "coordinate", "m.x")
    mass.force("f", "m.origin", law, 0.0).initial({"m.x": x}).rates({"m.x": v})
    return mass.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


def spring_and_push(t: float) -> tuple[float, float]:
    """(x, v) of x'' = -4 x, and + 10 beyond x = 0.5, from x = 0 with 2 m/s: sines about 0, then about 2.5."""
    there = np.arcsin(0.5) / 2
    v, s = 2 * np.cos(2 * there), t - there
    return 2.5 - 2 * np.cos(2 * s) + v / 2 * np.sin(2 * s), 4 * np.sin(2 * s) + v * np.cos(2 * s)


def relay_to_the_middle(t: float) -> tuple[float, float]:
    """(x, v) of x'' = -sign(x) from rest at x = 1, while x < 0 for the first time: parabolas."""
    s = t - np.sqrt(2)
    return -np.sqrt(2) * s + s**2 / 2, -np.sqrt(2) + s


EVERY_SCHEME = ["rk4", "dopri5", "dop853", "exponential", "exponential_rk4", "exponential_adams", "radau",
                "single_rate", "printed"]  # fmt: skip
ORDERS = {"rk4": (4, 2e-7), "dopri5": (5, 6e-10), "exponential_rk4": (4, 5e-8), "exponential_adams": (4, 7e-8),
          "radau": (5, 3e-10), "single_rate": (2, 2e-3), "printed": (2, 2e-3)}  # fmt: skip


@pytest.mark.every_push("rk4", "radau")
@pytest.mark.parametrize("scheme", ORDERS)
def test_schemes_keep_their_order_across_a_jump_by_place(model_of: Build, scheme: str) -> None:
    order, most = ORDERS[scheme]
    model, errors = model_of(pushed_by_place("-4*x + where(x > 0.5, 10, 0)", 0.0, 2.0)), []
    for dt in (0.051, 0.0255, 0.01275):
        run = simulate(model, scheme=scheme, dt=dt, error="off")
        assert run.status.ok and run.stats["kinks"] == 1 and not run.events
        errors.append(float(np.abs(np.array([run["m.x"][-1], run["m.x_dot"][-1]]) - spring_and_push(1.0)).max()))
    assert errors[1] < 1.3 * most, errors
    for coarse, fine in zip(errors, errors[1:], strict=False):
        assert np.log2(coarse / fine) == pytest.approx(order, abs=0.15), errors


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", EVERY_SCHEME)
def test_a_constant_force_that_jumps_costs_nothing(model_of: Build, scheme: str) -> None:
    """On both sides of -sign(x) every scheme is exact, so all that is left is how well x = 0 is located."""
    run = simulate(model_of(pushed_by_place("-sign(x)", 1.0, 0.0)), scheme=scheme, dt=0.051, t_end=2.0, error="off")
    assert [run["m.x"][-1], run["m.x_dot"][-1]] == pytest.approx(relay_to_the_middle(2.0), abs=2e-11)


@pytest.mark.parametrize("scheme", ["dopri5", "exponential_rk4", "radau"])
def test_a_tolerance_holds_across_a_jump_by_place(model_of: Build, scheme: str) -> None:
    """Few steps do: an error of first order took 130,000 of radau's, and 2e-5 was left of 1e-8."""
    model = model_of(pushed_by_place("-sign(x)", 1.0, 0.0))
    run = simulate(model, scheme=scheme, tolerance=1e-8, t_end=2.0)
    assert run["m.x_dot"][-1] == pytest.approx(relay_to_the_middle(2.0)[1], abs=1e-8)
    assert run.status.name == "completed" and run.stats["steps"] < 500


@pytest.mark.parametrize("scheme", ["rk4", "radau"])
def test_a_jump_back_and_forth_by_rate(model_of: Build, scheme: str) -> None:
    """A brake of 3 N at positive rates only, under -2 N: stops after 0.2 m, and goes back under -2 N, exactly."""
    run = simulate(
        model_of(pushed_by_place("-2 + where(x_dot > 0, -3, 0)", 0.0, 2.0)), scheme=scheme, dt=0.03, error="off"
    )
    assert run["m.x_dot"][-1] == pytest.approx(-2 * 0.6, abs=1e-10)
    assert run["m.x"][-1] == pytest.approx(0.4 - 0.36, abs=1e-10)


@pytest.mark.parametrize("law", ["-10*sqrt(where(x > 0.5, x - 0.5, 0))", "where(x > 0.5, -10*(x-0.5)**1.5, 0)"])
def test_a_law_without_a_value_beyond_is_not_held(model_of: Build, law: str) -> None:
    """A root ends where the load begins to act: stages that lie before it see what the law says there."""
    model = model_of(pushed_by_place(law, 0.0, 1.0))
    run = simulate(model, dt=0.03, error="off")
    power = 0.5 if "sqrt" in law else 1.5
    assert run.status.ok and run.stats["kinks"] >= 1
    stored = 10 * np.maximum(run["m.x"] - 0.5, 0) ** (power + 1) / (power + 1)
    assert np.abs(run["m.x_dot"] ** 2 / 2 + stored - 0.5).max() < (2e-3 if power == 0.5 else 2e-6)


def test_a_stepper_has_the_bits_of_a_run_across_a_jump_by_place(model_of: Build) -> None:
    model = model_of(pushed_by_place("-4*x + where(x > 0.5, 10, 0)", 0.0, 2.0))
    run, stepper = simulate(model, error="off"), model.stepper()
    stepper.step(20)
    kept = stepper.save()
    stepper.step(80)
    assert stepper.sample.q[0, 0] == run.q[-1, 0]
    stepper.restore(kept)
    stepper.step(80)
    assert stepper.sample.q[0, 0] == run.q[-1, 0]


# ---- loads that act for less than a step: their ends are ends of steps at every length, so other lengths err alike


@pytest.mark.parametrize("stiffness", [2e3, 2e5, 2e7])
@pytest.mark.parametrize("asked", [{"dt": 0.1}, {"dt": 0.01}, {"tolerance": 1e-3}])
def test_a_contact_that_steps_do_not_resolve_is_not_told_as_right(model_of: Build, stiffness: float, asked) -> None:
    """A pendulum on an elastic stop: its energy is kept, what a run loses of it is in its error."""
    builder = on_hinge("rod", "rod", "pin", mass=1.0, inertia=1.0).measure("a", "coordinate", "rod.theta")
    builder.torque("drive", "rod.origin", f"-10*sin(a) + where(a < -1.2, {stiffness}*(-1.2 - a), 0)")
    builder.initial({"rod.theta": 1.5}).simulation(t_end=2.0, dt=0.01, scheme="rk4")
    model = model_of(builder.build())
    run = simulate(model, scheme="rk4", t_end=2.0, **asked)
    height = 10 * (1 - np.cos(run["rod.theta"])) + stiffness / 2 * np.minimum(run["rod.theta"] + 1.2, 0) ** 2
    lost = abs(float((run["rod.theta_dot"] ** 2 / 2 + height)[-1]) / (10 * (1 - np.cos(1.5))) - 1)
    assert lost < 0.05 or run.status.name == "inaccurate"
    assert not run.error.measured or lost < 20 * run.error.largest + 1e-6


def test_a_push_that_steps_do_resolve_is_right_however_short(model_of: Build) -> None:
    """10 N over 1 mm, 1 kg at 1 m/s, in steps of 0.1 s: v^2 = 1 + 2 10 0.001."""
    builder = on_rail("pushed", "cart", "rail", mass=1.0, inertia=1.0).measure("x", "coordinate", "cart.x")
    builder.force("push", "cart.origin", "where(x > 0.5, 10, 0) * where(x < 0.501, 1, 0)", 0)
    builder.rates({"cart.x": 1.0}).simulation(t_end=1.0, dt=0.1, scheme="rk4")
    run = simulate(model_of(builder.build()))
    assert run.status.name == "completed" and run.error.largest < 1e-6
    assert run["cart.x_dot"][-1] == pytest.approx(np.sqrt(1.02), abs=1e-9)
