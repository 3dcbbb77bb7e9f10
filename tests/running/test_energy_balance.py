"""Energy and work of a run balance over its saved samples, as far as these resolve the power; they end no run."""

from __future__ import annotations

from collections.abc import Callable
from math import erf
from pathlib import Path

import numpy as np
import pytest

from runtime import Model, Sampled, Solution, resume, simulate
from runtime.results.samples import energy_balance
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import driven_bob, on_hinge, on_rail

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


def flywheel(torque: str, damping: float = 0.0) -> SceneRecord:
    """J = 2 kg m2 about a fixed axis, at 3 rad/s; theta'' = (torque - damping theta') / 2."""
    builder = Scene("flywheel").rigid("wheel", mass=1.0, inertia=2.0)
    builder.revolute("axle", "ground.origin", "wheel.origin", damping=damping)
    builder.torque("motor", "wheel.origin", torque).rates({"wheel.theta": 3.0})
    return builder.simulation(t_end=2.0, dt=1e-2, scheme="rk4").build()


def energies(power: np.ndarray) -> dict[str, np.ndarray]:
    """No energy, and one power (N,)."""
    still = np.zeros(len(power))
    names = ("kinetic", "elastic", "potential", "power_dissipated", "power_driven")
    return {name: still for name in names} | {"power_applied": power}


@pytest.mark.parametrize("scheme", ["rk4", "dop853", "single_rate"])
def test_work_of_a_constant_torque_is_torque_times_angle(model_of: Build, scheme: str) -> None:
    """Power grows linearly, which the quadrature takes exactly."""
    run = simulate(model_of(flywheel("4.0")), scheme=scheme, seen_every=0.07)
    assert run.work() == pytest.approx(4.0 * (run["wheel.theta"] - run["wheel.theta"][0]), abs=1e-10)
    assert np.abs(run.energy_balance()).max() < 1e-10 and run.balance.uncertainty[-1] < 1e-10


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams", "single_rate"])
def test_work_between_stops_of_all_kinds(model_of: Build, scheme: str) -> None:
    """Jumps of a load, samples of an input, an event: constant torques in between; steps of 1 ms.

    J = 2 kg m2, so W = v^2 - 9 with the velocity by hand.
    """
    torque = "where(t < 0.0153, 4, where(t < 0.035, -60, where(t < 0.0571, 50, -7))) + extra"
    torque += " + where(t < 0.1019, boost, where(t < 0.1219, -20, 500))"  # the last jump is behind the end
    builder = on_hinge("driven_wheel", "wheel", "axle", mass=1.0, inertia=2.0)
    builder.input("extra", 0.0, "N*m").input("boost", 0.0, "N*m").event("later", "t - 0.0837", action={"boost": "25"})
    builder.torque("motor", "wheel.origin", torque).rates({"wheel.theta": 3.0})
    model = model_of(builder.simulation(t_end=0.12, dt=0.001, scheme="rk4").build())
    run = simulate(model, scheme=scheme, inputs={"extra": Sampled(lambda t, x: 750.0 * t, 0.04)})
    assert run.status.name == "completed" and len(run.events) == 1
    ends = [0.0, 0.0153, 0.035, 0.04, 0.0571, 0.08, 0.0837, 0.1019, 0.12]
    v = 3.0 + np.append(0.0, np.cumsum(np.diff(ends) * [4, -60, 50, 80, 23, 53, 78, 33])) / 2
    assert run.rate("wheel.theta")[-1] == pytest.approx(v[-1], rel=1e-10)  # an event's time by search
    assert run.work()[-1] == pytest.approx(v[-1] ** 2 - 9.0, abs=1e-9)
    assert np.abs(run.energy_balance()).max() < 1e-10


def test_work_converges_with_the_fourth_order_of_the_samples_and_its_uncertainty_is_honest() -> None:
    """P = e^t sin 9t with a jump of 5 at t = 1.2345, known in closed form; samples unevenly apart, too."""

    def exact(t: np.ndarray) -> np.ndarray:
        smooth = (np.exp(t) * (np.sin(9 * t) - 9 * np.cos(9 * t)) + 9) / 82
        return smooth + 5 * np.maximum(t - 1.2345, 0)

    errors = []
    for n in (41, 81, 161):
        for t in (np.linspace(0, 2, n), 2 * np.linspace(0, 1, n) ** 1.3):
            power = np.exp(t) * np.sin(9 * t) + 5 * (t > 1.2345)
            found = energy_balance(t, energies(power), np.array([[1.2345, 0.0]]))
            off = np.abs(found.work - exact(t)).max()
            assert off < found.uncertainty[-1] < 100 * off
            errors.append(off)
    assert np.log2(np.array(errors[:-2]) / errors[2:]).min() > 3.5, errors


def test_what_lies_between_the_samples_is_not_resolved() -> None:
    """A burst of power of the length of a sample: the balance is off, and says that the samples do not tell."""
    t = np.linspace(0, 1, 21)
    fed = 1000 * 0.02 * np.sqrt(np.pi) / 2 * (1 + np.array([erf((one - 0.52) / 0.02) for one in t]))
    kicked = {**energies(1000 * np.exp(-(((t - 0.52) / 0.02) ** 2))), "kinetic": fed}
    assert not (found := energy_balance(t, kicked, np.zeros((0, 2)))).resolved
    assert "too few samples to check below" in str(found)
    lost = {**energies(np.zeros(21)), "kinetic": 1 + t}
    assert (found := energy_balance(t, lost, np.zeros((0, 2)))).resolved and str(found) == "1 J"


def test_stops_closer_than_samples_and_samples_at_stops() -> None:
    """Piecewise constant powers, switched at samples (shown before the switch) and twice between two samples."""
    t = np.linspace(0, 1, 11)
    power = np.where(t <= 0.5, 3.0, 7.0)
    found = energy_balance(t, energies(power), np.array([[0.5, 0.0]]))
    assert found.work == pytest.approx(3 * np.minimum(t, 0.5) + 7 * np.maximum(t - 0.5, 0), abs=1e-14)
    crowded = np.array([[0.52, 0.25], [0.54, -1.0], [0.58, 0.0]])
    found = energy_balance(t, energies(np.full(11, 2.0)), crowded)
    assert found.work == pytest.approx(2 * t - 0.75 * (t > 0.55), abs=1e-14)


def test_a_mechanism_that_nothing_feeds_has_no_work(built_in: Load) -> None:
    run = simulate(built_in("pendulum"), t_end=0.1)
    assert not run.work().any() and run.balance.resolved


@pytest.mark.long
def test_stops_are_kept_by_files_and_checkpoints(model_of: Build, tmp_path: Path) -> None:
    """A load that jumps, and the impulse of a prescribed motion behind the place where the run stops."""
    motion = "where(t < 0.0201, 0, t - 0.0201) + where(t < 0.07, 0, 3*(t - 0.07))"
    builder = driven_bob("driven_bob", motion)
    builder.torque("push", "bob.origin", "where(sin(300 * t) > 0, 1, -1)")
    model = model_of(builder.simulation(t_end=0.1, dt=0.001, scheme="rk4").build())

    def stop(t: float, t_end: float) -> None:
        if t > 0.05:
            raise KeyboardInterrupt

    whole = simulate(model)
    simulate(model, checkpoint=tmp_path / "run.npz", progress=stop)
    again = resume(model, tmp_path / "run.npz")
    assert np.abs(whole.energy_balance()).max() < 1e-5 * np.ptp(whole.work())
    assert np.count_nonzero(whole.stops[:, 1]) == 2 and len(whole.stops) > 9
    assert np.array_equal(again.stops, whole.stops) and np.array_equal(again.work(), whole.work())
    whole.save(tmp_path / "solution.npz")
    assert np.array_equal(Solution.load(tmp_path / "solution.npz", model).work(), whole.work())


@pytest.mark.every_push("weight-single_rate", "hinge-exponential")
@pytest.mark.parametrize("scheme", ["single_rate", "printed", "coupled", "exponential", "exponential_rk4", "rk4"])
@pytest.mark.parametrize("load", ["hinge", "weight"])
def test_a_mechanism_at_rest_on_a_load_stays_there(model_of: Build, load: str, scheme: str) -> None:
    """A torque as a spring and damper, or a weight on a spring of force, from their own equilibria: nothing happens."""
    builder = Scene(f"{load}_at_rest").rigid("rod", mass=1.0, inertia=0.1)
    if load == "hinge":
        builder.revolute("hinge", "ground.origin", "rod.origin")
        builder.measure("q", "coordinate", "rod.theta").torque("spring", "rod.origin", "-300*(q - 0.1) - 3*q_dot")
        builder.initial({"rod.theta": 0.1})
    else:
        builder.prismatic("rail", "ground.origin", "rod.origin")
        builder.measure("q", "coordinate", "rod.x").force("spring", "rod.origin", "9.81 - 400*q - 2*q_dot", 0.0)
        builder.initial({"rod.x": 9.81 / 400})
    model = model_of(builder.simulation(t_end=0.5, dt=1e-3, scheme="rk4").build())
    run = simulate(model, scheme=scheme)
    assert run.status.name == "completed" and np.ptp(run.q, axis=0).max() < 1e-12


def test_the_balance_tells_spurious_energy(model_of: Build) -> None:
    """Two oscillators whose sub-steps of `coupled` resonate with the step of the slow one: energy beyond the work."""
    builder = Scene("masses")
    builder.structure(
        coordinates=["x", "y"],
        mass=[[1.0, 0.5], [0.5, 1.0]],
        stiffness=[[1.0, 0.0], [0.0, 400.0]],
        force=["sin(t)", 0.0],
    )
    builder.groups(L=["x"], S=["y"]).initial({"x": 1.0, "y": 0.1})
    run = simulate(model_of(builder.simulation(t_end=30.0, dt=0.1, m=[8], scheme="coupled").build()))
    assert run.balance.resolved and run.balance.largest > 1.0


@pytest.mark.parametrize("samples", [50, 500])
def test_a_sampled_controller_is_not_condemned(model_of: Build, samples: int) -> None:
    """A pendulum under a torque that is held for 20 ms: what that does is its sum of torque and turn, to 1e-9 J."""
    scene = Scene("held").gravity(0, -9.81).input("u", 0.0)
    scene.rigid("p", mass=1.0, inertia=0.02, center_of_mass=(0.5, 0)).revolute("h", "ground.origin", "p.origin")
    scene.torque("tq", "p.origin", "u").initial({"p.theta": -1.5})
    model = model_of(scene.simulation(t_end=1.0, dt=1e-3, scheme="dopri5").build())

    def law(t: float, seen: np.ndarray) -> float:
        return float(np.clip(20 * (0.5 - seen[0]) - seen[1], -9, 9))

    reads = ["p.theta", "p.theta_dot"]
    inputs = {"u": Sampled(law, every=0.02, reads=reads, memory=())}
    run = simulate(model, inputs=inputs, tolerance=1e-4, samples=samples)
    theta, rate = run["p.theta"], run["p.theta_dot"]
    asked = [int(np.abs(run.t - k * 0.02).argmin()) for k in range(51)]
    torques = [law(0.0, np.array([theta[k], rate[k]])) for k in asked[:-1]]
    work = sum(u * (theta[b] - theta[a]) for u, a, b in zip(torques, asked, asked[1:], strict=False))
    energy = 0.27 / 2 * rate[-1] ** 2 + 9.81 * 0.5 * (np.sin(theta[-1]) - np.sin(theta[0]))
    assert energy == pytest.approx(work, abs=1e-9)  # the run is right, so its balance has to be
    assert run.work()[-1] == pytest.approx(work, abs=2e-5) and run.balance.largest < 2e-5
    assert run.balance.largest < run.balance.uncertainty[-1]


@pytest.mark.every_push("stop")
@pytest.mark.parametrize(
    "ends",
    [
        {"friction": {"coulomb": 5.0, "breakaway": 15.0, "stribeck_velocity": 0.5, "viscous": 1.0}},
        {"limits": {"upper": 0.4, "restitution": 0.5}},
        {"limits": {"upper": 0.4, "stiffness": 1e4, "damping": 0.3}},
    ],
    ids=["friction", "stop", "elastic"],
)
def test_modes_and_kinks_split_the_work(model_of: Build, ends: dict[str, dict[str, float]]) -> None:
    """A block, coarsely seen: its balance is left open by the samples, not condemned, and fine ones show it."""
    scene = Scene("block").rigid("block", mass=1.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "block.origin", **{"limits": {"upper": 0.4, "restitution": 0.5}} | ends)
    scene.force("pull", "block.origin", "25 * sin(pi * t / 2)", 0.0)
    model = model_of(scene.simulation(t_end=3.0, dt=0.01, scheme="rk4").build())
    run, fine = simulate(model, tolerance=1e-4, samples=60), simulate(model, dt=1e-3)
    assert run.status.name == fine.status.name == "completed"
    for one in (run, fine):
        assert one.balance.largest < one.balance.uncertainty[-1] or one.balance.largest < 1e-6
    assert fine.balance.largest < 5e-4 and fine.balance.uncertainty[-1] < 5e-3


def test_power_jumps_where_the_motion_lets_a_load_jump(model_of: Build) -> None:
    """10 N from x = 0.5 m on, between two samples: the work is 10 (x - 0.5), for any number of samples."""
    scene = on_rail("pushed", "mass", "rail", mass=1.0, inertia=0.1)
    scene.measure("place", "x", "mass.origin").rates({"mass.x": 1.0})
    scene.force("push", "mass.origin", "where(place > 0.5, 10.0, 0.0)", 0.0)
    model = model_of(scene.simulation(t_end=0.98, dt=0.00875, scheme="rk4").build())
    for seen in (0.07, 0.035):
        run = simulate(model, seen_every=seen)
        assert run.work() == pytest.approx(10.0 * np.maximum(run["mass.x"] - 0.5, 0.0), abs=1e-5)
