"""Events of the motion: located, told once each, with actions on inputs, ends of runs, and order across end stops."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, ArgumentError, Model, ModelError, ensemble, resume, simulate
from runtime.running.checkpoint import read_checkpoint
from runtime.studies.advice.reference import independent_reference
from symgen.scene import Scene, SceneError, SceneRecord
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]
G = 9.81


def falling(**events: dict[str, Any]) -> SceneRecord:
    """A mass on a rail along gravity from 1 m, pushed by an input; x = 1 - G t^2 / 2."""
    builder = Scene("falling_mass").parameter("height", 0.6, "m").input("push", 0.0, "N").gravity(-G, 0)
    builder.rigid("mass", mass=2.0, inertia=0.1).prismatic("rail", "ground.origin", "mass.origin")
    builder.initial({"mass.x": 1.0}).measure("x", "x", "mass.origin").force("push", "mass.origin", "push", 0.0)
    for name, fields in events.items():
        builder.event(name, **fields)
    return builder.simulation(t_end=0.5, dt=0.03, scheme="rk4").build()


@pytest.mark.every_push("rk4", "single_rate")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_an_event_is_located_acts_and_keeps_what_is_exact(model_of: Build, scheme: str) -> None:
    """At x = height the push becomes 3 m g: from there the mass rises with 2 g, by hand; two events in one step too."""
    passing = {"when": "x - height", "direction": "falling", "action": {"push": "push + 3 * 2 * 9.81"}}
    model = model_of(falling(passing=passing, near={"when": "x - height + 1e-3"}, never={"when": "x - 9"}))
    for height in (0.6, 0.95):
        run = simulate(model, scheme=scheme, parameters={"height": height}, t_end=0.7, force=True)
        t = np.sqrt(2 * (1 - height) / G)
        v, left = -G * t, run.t[-1] - t
        back = (-v - np.sqrt(v**2 - 4 * G * 1e-3)) / (2 * G), (-v + np.sqrt(v**2 - 4 * G * 1e-3)) / (2 * G)
        assert run["mass.x"][-1] == pytest.approx(height + v * left + G * left**2, abs=1e-8)
        assert run["push"][-1] == 6 * G
        told = [(event.name, event.direction) for event in run.events]
        assert told == [("passing", "falling"), ("near", "falling"), ("near", "rising")]
        times = [event.time for event in run.events]
        assert times == pytest.approx([t, t + back[0], t + back[1]], rel=0, abs=1e-10)


@pytest.mark.every_push("exponential_rk4")
@pytest.mark.parametrize("scheme", ["dopri5", "exponential", "exponential_rk4"])
def test_events_with_a_tolerance(model_of: Build, tmp_path: Path, scheme: str) -> None:
    """The same law; steps are long beside the time between the events, and samples lie where they were asked for."""
    passing = {"when": "x - height", "direction": "falling", "action": {"push": "push + 3 * 2 * 9.81"}}
    high = {"when": "x - 0.9", "direction": "rising", "terminal": True}
    model = model_of(falling(passing=passing, high=high))
    where = tmp_path / "run.npz"
    run = simulate(
        model, scheme=scheme, tolerance=1e-6, t_end=1.0, seen_every=0.05, checkpoint=where, checkpoint_every=1
    )
    t = np.sqrt(0.8 / G)
    v = -G * t
    end = t + (-v + np.sqrt(v**2 + 4 * G * 0.3)) / (2 * G)
    assert [event.time for event in run.events] == pytest.approx([t, end], rel=0, abs=1e-10)
    assert run.status.name == "event" and run.t[-1] == run.events[-1].time
    assert run.t[:-1] == pytest.approx(0.05 * np.arange(len(run.t) - 1), rel=0, abs=1e-15)
    s = np.maximum(run.t - t, 0)
    assert run["mass.x"] == pytest.approx(1 - G * run.t**2 / 2 + 3 * G / 2 * s**2, abs=1e-9)
    assert run.work()[-1] == pytest.approx(6 * G * 0.3, rel=1e-9)
    again = resume(model, where)
    assert again.events == run.events and np.array_equal(again.q, run.q)
    short = simulate(
        model, scheme=scheme, tolerance=1e-6, t_end=0.5, seen_every=0.05
    )  # its last step may run beyond the end
    assert short.status.name == "completed" and short.t[-1] == pytest.approx(0.5) and len(short.events) == 1


def latched(mass: str = "m") -> SceneRecord:
    """A spring that loses three quarters of its stiffness as the mass passes 0.5 m."""
    builder = Scene("latched_mass").parameter("k", 100.0, "N/m").parameter("m", 2.0, "kg")
    builder.rigid("mass", mass=mass, inertia=0.1).prismatic("rail", "ground.origin", "mass.origin")
    builder.measure("x", "x", "mass.origin").force("spring", "mass.origin", "-k * x", 0.0).initial({"mass.x": 1.0})
    builder.event("half", "x - 0.5", direction="falling", action={"k": "k / 4"})
    return builder.simulation(t_end=0.6, dt=1e-3, scheme="rk4").build()


@pytest.mark.parametrize("scheme, tolerance", [("rk4", None), ("single_rate", None), ("dopri5", 1e-9)])
def test_an_action_on_a_parameter(model_of: Build, scheme: str, tolerance: float | None) -> None:
    """k = 200 N/m, then 50: w = 10, then 5 rad/s, by hand; a parameter is given and told as any other."""
    scene = latched()
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    run = simulate(model_of(scene), scheme=scheme, tolerance=tolerance, parameters={"k": 200.0})
    t = np.pi / 3 / 10
    v, left = -10 * np.sin(10 * t), run.t[-1] - t
    exact = 0.5 * np.cos(5 * left) + v / 5 * np.sin(5 * left)
    assert run["mass.x"][-1] == pytest.approx(exact, abs=1e-4 if scheme == "single_rate" else 1e-8)
    assert run["k"][0] == 200 and run["k"][-1] == 50 and run.events[0].text == "event half, falling: k = 50"
    with pytest.raises(SceneError, match=r"'mass'\.mass: uses 'k', which an event sets during the run"):
        latched(mass="m + k / 100")


def swinging(**event: Any) -> SceneRecord:
    """x = cos(2 pi t) passes zero every half second."""
    builder = on_rail("swinging_mass", "mass", "rail", mass=1.0, inertia=0.1).measure("x", "x", "mass.origin")
    builder.force("spring", "mass.origin", "-4 * pi ** 2 * x", 0.0).initial({"mass.x": 1.0}).event("zero", "x", **event)
    return builder.simulation(t_end=3.0, dt=0.01, scheme="dopri5").build()


@pytest.mark.every_push("1e-09")
@pytest.mark.parametrize("tolerance", [None, 1e-9])
def test_a_cool_down_leaves_out_what_comes_too_soon(model_of: Build, tolerance: float | None) -> None:
    """Crossings at 1/4, 3/4 ... s: 0.6 s leave out every other one, 0.49 s none."""
    for cool_down, times in ((0.6, [0.25, 1.25, 2.25]), (0.49, [0.25, 0.75, 1.25, 1.75, 2.25, 2.75])):
        model = model_of(swinging(cool_down=cool_down))
        run = simulate(model, tolerance=tolerance)
        assert [event.time for event in run.events] == pytest.approx(times, abs=1e-7)
    with pytest.raises(SceneError, match="cool_down: -1.0 is out of range"):
        swinging(cool_down=-1.0)


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "coupled"])
def test_steppers_know_events_bit_for_bit(model_of: Build, scheme: str) -> None:
    """In calls of one or of many steps, across an action, to a terminal event, and again from a state that was kept."""
    passing = {
        "when": "x - height",
        "direction": "falling",
        "action": {"push": "push + 3 * 2 * 9.81"},
        "cool_down": 0.1,
    }
    model = model_of(falling(passing=passing, high={"when": "x - 0.9", "direction": "rising", "terminal": True}))
    run = simulate(model, scheme=scheme, t_end=1.0, force=True)
    stepper = model.stepper(scheme=scheme)
    for block in (1, 8):
        stepper.reset()
        stepper.step(block)
        assert stepper.ended is None
        kept = stepper.save()
        for _ in range(2):
            while stepper.ended is None:
                stepper.step(block)
            assert stepper.events == run.events and stepper.ended == run.status and stepper.time == run.t[-1]
            assert stepper.state["mass.x"] == run["mass.x"][-1] and stepper.sample["push"][0] == 6 * G
            with pytest.raises(ArgumentError, match="event high has ended the motion.*reset or restore"):
                stepper.step()
            stepper.restore(kept)


def test_a_terminal_event_ends_the_run_there(model_of: Build, tmp_path: Path) -> None:
    model = model_of(falling(floor={"when": "x - height", "terminal": True}))
    run = simulate(model, checkpoint=tmp_path / "run.npz", checkpoint_every=2)
    t = np.sqrt(0.8 / G)
    assert run.status.name == "event" and run.status.ok and run.status.time == pytest.approx(t, abs=2e-10)
    assert run.t[-1] == pytest.approx(t, abs=2e-10) and run["mass.x"][-1] == pytest.approx(0.6, abs=1e-9)
    again = resume(model, tmp_path / "run.npz")
    assert again.t[-1] == run.t[-1] and again.events == run.events and np.array_equal(again.q, run.q)
    cases = ensemble(model, {"height": [0.6, 0.9]}, outputs=["mass.x"], reduce={"mass.x": "min"})
    assert cases["mass.x_min"].values == pytest.approx([0.6, 0.9], abs=1e-9)


def test_an_action_that_undoes_itself_is_named(model_of: Build) -> None:
    """A force against each way of moving, stronger than gravity: at rest it would change for ever."""
    up = {"when": "x_dot", "direction": "rising", "action": {"push": "-40"}}
    down = {"when": "x_dot", "direction": "falling", "action": {"push": "40"}}
    run = simulate(model_of(falling(up=up, down=down)), initial={"mass.x_dot": 1.0})
    assert run.status.name == "chattering" and run.status.time == pytest.approx(1 / G, abs=1e-6)
    assert "event down happens 50 times within one step" in run.status.cause


@pytest.mark.long
def test_chattering_across_a_resume_is_found_when_it_would_have_been(model_of: Build, tmp_path: Path) -> None:
    """Gone on with after some of the fifty; an older checkpoint does not know of them, and goes on all the same."""
    up = {"when": "x_dot", "direction": "rising", "action": {"push": "-40"}}
    down = {"when": "x_dot", "direction": "falling", "action": {"push": "40"}}
    model, path = model_of(falling(up=up, down=down)), tmp_path / "run.npz"
    settings: dict[str, Any] = {"scheme": "dopri5", "tolerance": 1e-6, "initial": {"mass.x_dot": 1.0}}
    settings |= {"options": {"error_of": "step"}, "seen_every": 0.01}
    whole = simulate(model, **settings)
    seen = []

    def interrupt(t: float, t_end: float) -> None:
        seen.append(t)
        if seen.count(t) == 30:
            raise KeyboardInterrupt

    assert simulate(model, **settings, checkpoint=path, progress=interrupt).status.name == "interrupted"
    kept = read_checkpoint(path)
    assert 10 < len(kept.header["events"]) < len(whole.events) - 10
    again = resume(model, path)
    assert again.status == whole.status and again.events == whole.events and whole.status.name == "chattering"


@pytest.mark.every_push("rk4", "printed")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_there_and_back_within_one_step(model_of: Build, scheme: str) -> None:
    """Thrown up, the mass is above its height for 9 ms in steps of 30 ms; what it misses by 1 um changes no bit."""
    top = 1 + 1.0**2 / (2 * G)
    builder_events = {"near": {"when": f"x - {top - 1e-4!r}"}, "far": {"when": f"x - {top + 1e-6!r}"}}
    settings: dict[str, Any] = {"scheme": scheme, "initial": {"mass.x_dot": 1.0}, "t_end": 0.3, "force": True}
    run = simulate(model_of(falling(**builder_events)), **settings)
    away = np.sqrt(2e-4 / G)
    assert [(event.name, event.direction) for event in run.events] == [("near", "rising"), ("near", "falling")]
    assert [event.time for event in run.events] == pytest.approx([1 / G - away, 1 / G + away], rel=0, abs=1e-9)
    without, far = (
        simulate(model_of(falling(**events)), **settings) for events in ({}, {"far": builder_events["far"]})
    )
    assert not far.events and np.array_equal(far.q, without.q) and np.array_equal(far.q_dot, without.q_dot)


def turning(**event: Any) -> SceneRecord:
    """A wheel from rest under 1 N m: angle = 5 t^2, which a step of any length follows."""
    builder = Scene("turning_wheel").rigid("wheel", mass=1.0, inertia=0.1)
    builder.revolute("axle", "ground.origin", "wheel.origin").measure("angle", "coordinate", "wheel.theta")
    builder.torque("drive", "wheel.origin", "1.0").event("turn", **event)
    return builder.simulation(t_end=5.0, dt=2.5, scheme="dopri5").build()


TURNS = 2 * np.pi * np.arange(81)
DIPS = np.sort(np.concatenate([TURNS + np.arccos(-0.99), TURNS - np.arccos(-0.99)]))


@pytest.mark.every_push("sin(angle)-rising-times0-dopri5", "sin(angle)-rising-times0-exponential_rk4")
@pytest.mark.parametrize("scheme", ["dopri5", "exponential", "exponential_rk4"])
@pytest.mark.parametrize(
    "when, direction, times",
    [
        ("sin(angle)", "rising", np.sqrt(TURNS / 5)),
        ("cos(angle) + 0.99", "either", np.sqrt(DIPS[DIPS > 0] / 5)),
        ("sin(angle_dot) - 0.999", "falling", (TURNS + np.pi - np.arcsin(0.999)) / 10),
    ],
)
def test_long_steps_of_a_tolerance_pass_nothing_over(
    model_of: Build, scheme: str, when: str, direction: str, times: np.ndarray
) -> None:
    """20 turns in 5 s, which steps of any length follow: each passage is told, at its time by hand."""
    run = simulate(model_of(turning(when=when, direction=direction)), scheme=scheme, tolerance=1e-6)
    assert [event.time for event in run.events] == pytest.approx(times[(times > 0) & (times < 5)], rel=0, abs=1e-9)


@pytest.mark.every_push("100")
@pytest.mark.parametrize("every", [1, 10, 100])
def test_samples_far_apart_miss_no_event(model_of: Build, every: int) -> None:
    """A mass on a spring turns back at k pi / w; each time is told, however many states are made in one call."""
    mass = on_rail("turning_back", "m", "rail", mass=1.0, inertia=0.1)
    mass.measure("x", "coordinate", "m.x").force("spring", "m.origin", "-4e4 * x", 0.0).event("turns", "x_dot")
    mass.rates({"m.x": 5.0}).simulation(t_end=1.0, dt=0.001, scheme="dopri5")
    options = {"error_of": "step"}
    given = {"scheme": "dopri5", "tolerance": 1e-8, "options": options, "error": "off"}
    run = simulate(model_of(mass.build()), seen_every=every * 1e-3, **given)
    times = (np.arange(64) + 0.5) * np.pi / 200
    assert [event.time for event in run.events] == pytest.approx(times[times < 1.0], rel=0, abs=1e-7)


def test_many_events_between_states_that_are_seen_are_no_chatter(model_of: Build) -> None:
    """x = cos(2 pi t) passes zero twice a second: 60 times before the first state that is seen, at times by hand."""
    how = {"scheme": "dopri5", "tolerance": 1e-8, "options": {"error_of": "step"}, "error": "off"}
    run = simulate(model_of(swinging()), **how, t_end=30.1, seen_every=30.1)
    assert run.status.name == "completed"
    assert [event.time for event in run.events] == pytest.approx(0.25 + 0.5 * np.arange(60), rel=0, abs=1e-5)


def end_stop(event: bool) -> SceneRecord:
    """A rod that falls onto a spring at -1 rad."""
    builder = Scene("end_stop").gravity(0, -G).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    builder.revolute("pin", "ground.origin", "rod.origin").measure("angle", "coordinate", "rod.theta")
    builder.torque("stop", "rod.origin", "where(angle < -1, 400 * (-1 - angle), 0)")
    if event:
        builder.event("contact", "angle + 1")
    return builder.simulation(t_end=1.0, dt=0.01, scheme="exponential").build()


def test_an_event_at_an_end_stop_keeps_the_order(model_of: Build) -> None:
    """The force kinks at contact: where steps end there, by an event or by themselves, order 4 holds."""
    with_event, without = model_of(end_stop(True)), model_of(end_stop(False))
    exact = simulate(with_event, scheme="dop853", dt=1e-3)["rod.theta"][-1]

    def errors(model: Model, **options: str) -> list[float]:
        return [abs(simulate(model, dt=dt, options=options)["rod.theta"][-1] - exact) for dt in (1 / 40, 1 / 80)]

    for model in (with_event, without):
        coarse, fine = errors(model)
        assert np.log2(coarse / fine) > 3.6 and fine < 1e-6
    assert errors(without, kinks="crossed")[1] > 1e-3
    run = simulate(with_event, dt=0.0025)
    assert [event.direction for event in run.events] == ["falling", "rising"]
    energy = run.energy["kinetic"] + run.energy["potential"] - run.work()
    assert np.ptp(energy) < 1e-3


def test_wrong_events_and_those_who_do_not_look_are_named(model_of: Build) -> None:
    with pytest.raises(SceneError, match="neither an input nor a parameter.*did you mean 'push'"):
        falling(wrong={"when": "x", "action": {"pushh": 1.0}})
    model = model_of(falling(floor={"when": "x - height"}))
    with pytest.raises(ModelError, match="events floor of model falling_mass.*comparisons of methods"):
        independent_reference(model)
