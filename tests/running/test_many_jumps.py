"""Many jumps in time: the step program crosses them without Python, as their parts would be made one by one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import DifferentiableRun, Model, simulate
from runtime.engine.native import NativeProgram
from runtime.engine.prepare import Prepared
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.steps_with_stops import StepsWithStops
from runtime.schemes.switching.stop_program import KNOWN_PARTS, StopProgram
from runtime.schemes.switching.times import switching_times
from symgen.generate import model_of as on_demand
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import driven_bob, on_rail

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
UP, DOWN, ABOVE = 3.0, -1.0, 0.4  # N; the force is UP while sin(40 t + 30 t^2) > ABOVE
ON_THE_GRID = 40  # 1/s: a second wave whose jumps are at ends of steps of 0.0125 s
SCHEMES = ["rk4", "exponential_adams", "single_rate", "coupled"]


def pushed_mass() -> SceneRecord:
    builder = on_rail("pushed_mass", "mass", "rail", mass=1.0, inertia=0.1)
    builder.force("push", "mass.origin", f"where(sin(40 * t + 30 * t**2) > {ABOVE}, {UP}, {DOWN})", 0.0)
    return builder.simulation(t_end=3.9, dt=0.002, scheme="rk4").build()


def pushed_by_hand(t_end: float) -> tuple[int, float, float]:
    """(jumps, x, v): a constant force between times at which the phase is asin(ABOVE) or pi less that."""
    turns, up = 2 * np.pi * np.arange(500), np.arcsin(ABOVE)
    phases = np.sort(np.concatenate([up + turns, np.pi - up + turns]))
    return by_hand((-40 + np.sqrt(1600 + 120 * phases)) / 60, t_end)


def by_hand(times: np.ndarray, t_end: float, v: float = 0.0) -> tuple[int, float, float]:
    """The same for a force that is DOWN until the first time, then UP."""
    times, x = times[times < t_end], 0.0
    for k, (a, b) in enumerate(zip([0.0, *times], [*times, t_end], strict=True)):
        force, h = (UP if k % 2 else DOWN), b - a
        x, v = x + v * h + force * h**2 / 2, v + force * h
    return len(times), x, v


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Applications of each native call across stops."""
    found, bound = list[int](), NativeProgram.bound

    def counted(self: NativeProgram, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        go = bound(self, z, c)

        def noted(n: int) -> None:
            found.append(n)
            go(n)

        return noted

    monkeypatch.setattr(NativeProgram, "bound", counted)
    return found


@pytest.mark.parametrize("dt", [0.002, 0.01])  # s; of steps of 10 ms often one alone is whole between two broken ones
@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams", "single_rate"])
def test_a_square_wave_is_exact_without_python(model_of: Build, calls: list[int], scheme: str, dt: float) -> None:
    """Constant forces between jumps: position and velocity to rounding, and a native call for some of them.

    Calls are counted of a run alone: one whose error is measured also stops where it is compared with its companion.
    """
    model, how = model_of(pushed_mass()), {"scheme": scheme, "dt": dt, "seen_every": 1000 * dt}
    jumps, x, v = pushed_by_hand(3.9)
    run = simulate(model, error="off", **how)  # type: ignore[arg-type]
    assert jumps > 190 and len(calls) < jumps / 4 and run.t[-1] == pytest.approx(3.9)
    compared = simulate(model, force=True, **how)  # type: ignore[arg-type]
    np.testing.assert_array_equal(compared.q, run.q)  # stops between jumps change nothing
    np.testing.assert_array_equal(compared.q_dot, run.q_dot)
    assert run["mass.x"][-1] == pytest.approx(x, rel=1e-10)
    assert run.rate("mass.x")[-1] == pytest.approx(v, rel=1e-10)


@pytest.mark.parametrize("scheme", ["exponential_adams", "single_rate"])
def test_other_steps_cross_by_the_same_program(model_of: Build, monkeypatch: pytest.MonkeyPatch, scheme: str) -> None:
    """Steps are data of it: it is made once, and runs with other steps are those by hand."""
    model, made, init = model_of(pushed_mass()), list[str](), StopProgram.__init__

    def counted(self: StopProgram, of: Scheme, prepared: Prepared, impulses: bool = False) -> None:
        made.append(type(of).__name__)
        init(self, of, prepared, impulses)

    monkeypatch.setattr(StopProgram, "__init__", counted)
    model.steppers.clear()
    x, v = pushed_by_hand(3.9)[1:]
    for dt in (0.0025, 0.002):
        run = simulate(model, scheme=scheme, dt=dt, seen_every=1000 * dt, force=True)
        assert len(made) == 1
        found = run["mass.x"][-1], run.rate("mass.x")[-1]
        assert found == pytest.approx((x, v), rel=1e-9)


@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams"])
def test_no_time_is_lost_at_jumps_far_from_zero(model_of: Build, scheme: str) -> None:
    """A mass at 10 m/s past 1,000 jumps, ten in each step, from t = 1,000 s on, clocks 7 ps apart at each."""
    builder = Scene("passing").rigid("mass", mass=1.0, inertia=0.1).rates({"mass.x": 10.0})
    builder.prismatic("rail", "ground.origin", "mass.origin")
    builder.force("push", "mass.origin", f"where(sin(1000 * pi * t + 0.3) > {ABOVE}, {UP}, {DOWN})", 0.0)
    model = model_of(builder.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
    run = simulate(model, scheme=scheme, t0=1000.0, t_end=1001.0, force=True)
    turns, up = 2 * np.pi * np.arange(501), np.arcsin(ABOVE)
    phases = np.sort(np.concatenate([up + turns, np.pi - up + turns]))
    jumps, x, v = by_hand((phases - 0.3) / (1000 * np.pi), 1.0, 10.0)
    assert jumps == 1000
    assert run["mass.x"][-1] == pytest.approx(x, rel=0, abs=1e-9)
    assert run.rate("mass.x")[-1] == pytest.approx(v, rel=0, abs=1e-9)


@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams"])
def test_jumps_are_crossed_by_a_native_call_for_as_many_as_it_knows(
    model_of: Build, calls: list[int], scheme: str
) -> None:
    """Whole steps before, between and behind them, too: nothing else is called."""
    model, dt = model_of(pushed_mass()), 0.002
    own = Stepper(scheme_kind(scheme).build(scheme, model, dt, None, {}), wait=True)
    c, q = model.constants(model.parameter_vector(None)), np.zeros(len(model.coordinates))
    broken = StepsWithStops(own, 0.0, dt, switching_times(model, c, 0.0, 0.6), c)
    z, ready = own.start(0.0, q, q, c, dt), own.ready(c, dt)
    calls.clear()
    broken.run(z, ready, c, 300)
    jumps, x, v = pushed_by_hand(0.6)
    assert jumps > 10 and len(calls) <= 1 + -(-2 * jumps // KNOWN_PARTS)  # two parts at each
    there = own.scheme.observer(z=own.state(z), c=own.scheme.constants(c))
    assert float(there["q_i"]) == pytest.approx(x, rel=1e-11)
    assert float(there["q_i_dot"]) == pytest.approx(v, rel=1e-11)


def two_waves(flexible: bool = True) -> SceneRecord:
    """A damped hub with a beam; one wave jumps within steps, often twice, one at their ends."""
    builder = Scene("two_waves").rigid("hub", mass=1.0, inertia=10.0)
    builder.revolute("pivot", "ground.origin", "hub.origin", damping=2.0)
    if flexible:
        section = {"area": 7.2968e-5, "second_moment": 8.2189e-9, "youngs_modulus": 6.8952e10}
        shapes = {"ends": "clamped-free", "modes": 1}
        builder.beam("beam", length=8.0, density=2766.7, lateral=shapes, stiffening=True, **section)
        builder.weld("clamp", "hub.origin", "beam.start")
    builder.torque("kick", "hub.origin", "where(sin(250 * t + 10 * sin(9 * t)) > 0.4, 20, 0)")
    builder.torque("push", "hub.origin", f"where(sin(pi * {ON_THE_GRID} * (t - 1e-13)) > 0, 30, -30)")
    return builder.simulation(t_end=1.0, dt=0.0125, scheme="rk4").build()


def test_an_impulse_among_many_jumps(model_of: Build, calls: list[int]) -> None:
    """A drive turns smoothly, then at once; a bob on it is pushed by a wave: momentum about its hinge stays."""
    motion = "where(t < 0.4, 0, (t - 0.4)**2) + where(t < 0.7, 0, t - 0.7)"
    builder = driven_bob("driven_bob", motion)
    builder.torque("push", "bob.origin", "where(sin(300 * t) > 0, 1, -1)")
    model = model_of(builder.simulation(t_end=1.0, dt=0.004, scheme="rk4").build())
    assert len([event for event in simulate(model, error="off", seen_every=1.0).events]) == 1
    assert len(calls) < 20  # some for all of the steps
    found = simulate(model, error="off", seen_every=0.0)
    (event,) = found.events
    k = int(np.searchsorted(found.t, 0.7 - 1e-9))
    angle = found["bob.theta"][k] - found["crank.theta"][k]
    omega, drive = float(found.rate("bob.theta")[k]), (0.6, 1.6)  # J omega + m a l Omega cos(angle) stays
    rates = omega, omega - 0.25 * np.cos(angle) / 0.35

    def kinetic(crank: float, bob: float) -> float:
        return 0.005 * crank**2 + 0.175 * bob**2 + 0.125 * crank**2 + 0.25 * crank * bob * np.cos(angle)

    assert event.kind == "velocity_jump" and event.time == pytest.approx(0.7, abs=1e-9)
    energy = kinetic(drive[1], rates[1]) - kinetic(drive[0], rates[0])
    assert float(event.text.split("energy by ")[1].split()[0]) == pytest.approx(energy, rel=1e-5)


@pytest.mark.parametrize("scheme, near", [("rk4", 1e-5), ("single_rate", 2e-3)])  # s
def test_events_among_many_jumps(model_of: Build, scheme: str, near: float) -> None:
    """A mass on a spring under a wave, which an action doubles: told as by a fifth of the steps."""
    builder = Scene("shaken").input("force", 1.0, "N").rigid("mass", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("push", "mass.origin", "where(sin(250 * t + 10 * sin(9 * t)) > 0.4, force, -force) - 900 * x", 0.0)
    builder.event("through", "x", direction="rising", cool_down=0.1).initial({"mass.x": 0.01})
    builder.event("later", "t - 0.6", action={"force": "2 * force"})
    model = model_of(builder.simulation(t_end=1.0, dt=0.004, scheme="rk4").build())
    found, finer = (simulate(model, scheme=scheme, dt=dt, force=True, error="off") for dt in (0.004, 0.0008))
    told = [[(one.name, one.direction) for one in run.events] for run in (found, finer)]
    assert len(told[0]) > 4 and told[0] == told[1]
    assert [one.time for one in found.events] == pytest.approx([one.time for one in finer.events], rel=0, abs=near)


def test_the_bits_do_not_depend_on_calls_or_engines(model_of: Build) -> None:
    """One call or many, whole lists or a few steps of them, compiled or interpreted."""
    model, ends = model_of(two_waves(flexible=False)), []
    for engine, calls in (("compiled-library", [80]), ("compiled-library", [1, 3, 36, 40]), ("interpreted", [40, 40])):
        one = model.stepper(scheme="single_rate", engine=engine)
        for n in calls:
            one.step(n)
        ends.append(one.save().z)
    assert np.array_equal(ends[0], ends[1]) and np.array_equal(ends[0], ends[2])


def test_the_bits_do_not_depend_on_how_many_jumps_there_are(model_of: Build) -> None:
    """A run, the same as the beginning of a longer one, by a stepper, and differentiated."""
    model, scheme = model_of(two_waves(flexible=False)), "exponential_adams"
    short, long = (simulate(model, scheme=scheme, t_end=t_end, seen_every=0.0, force=True) for t_end in (0.25, 1.0))
    assert np.array_equal(short.q, long.q[:21]) and np.array_equal(short.q_dot, long.q_dot[:21])
    one = model.stepper(scheme=scheme)
    one.step(20)
    assert np.array_equal(one.sample.q[0], short.q[-1]) and np.array_equal(one.sample.q_dot[0], short.q_dot[-1])
    for run in (short, long):
        t_end = float(run.t[-1])
        found = DifferentiableRun(model, ["hub.theta"], ["hub.inertia"], scheme=scheme, t_end=t_end, seen_every=0.0)
        assert np.array_equal(found.values(found.x0)[:, 0], run["hub.theta"])


def test_an_action_among_jumps_of_a_model_made_on_demand() -> None:
    """Whose functions are derived when they are asked for: does a condition in time depend on the input that is set?"""
    builder = on_rail("on_demand", "mass", "rail", mass=1.0, inertia=0.1).input("force", 1.0, "N")
    builder.force("push", "mass.origin", "where(t < 0.25, force, 0)", 0.0)
    builder.event("later", "t - 0.1", action={"force": "3 * force"})
    run = simulate(on_demand(builder.simulation(t_end=0.5, dt=0.01, scheme="rk4").build()))
    assert run.rate("mass.x")[-1] == pytest.approx(0.1 + 0.15 * 3, rel=1e-9)


@pytest.mark.parametrize("condition, looks", [("t < 0.25", 1), ("t < until", 3)])
def test_inputs_of_a_stepper_and_the_search_for_jumps(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, condition: str, looks: int
) -> None:
    """Looked for anew where a time of a jump hangs on an input, not at each step with other inputs."""
    builder = Scene("held").input("force", 0.0, "N").input("until", 0.25, "s")
    builder.rigid("mass", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "mass.origin")
    builder.force("push", "mass.origin", f"where({condition}, force, 0)", 0.0)
    one, seen = model_of(builder.simulation(t_end=1.0, dt=0.1, scheme="rk4").build()).stepper(), list[float]()

    def counted(model: Model, c: np.ndarray, t0: float, t_end: float) -> Any:
        seen.append(t_end)
        return switching_times(model, c, t0, t_end)

    monkeypatch.setattr("runtime.running.stepping.switching_times", counted)
    one.reset()
    for force in (1.0, 3.0):
        one.step({"force": force, "until": 0.25}, 2)
    assert len(seen) == looks
    assert one.state["mass.x_dot"] == pytest.approx(0.2 * 1.0 + 0.05 * 3.0, rel=1e-12)
