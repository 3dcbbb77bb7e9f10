"""The work of loads, dampers and drives is integrated by the steps, and the energy of every run is judged by it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import Model, Sampled, resume, simulate
from runtime.contract.tape import arithmetic
from runtime.engine.prepare import prepare
from runtime.engine.program import Repeat
from runtime.schemes.baselines.runge_kutta import ExplicitRungeKutta
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.work import account_for_work
from symgen.scene import Scene, SceneBuilder
from symgen.scenes.spin_up_beam import spin_up_beam

Load = Callable[[str], Model]
Build = Callable[[Scene], Model]


def flywheel(torque: str, damping: float = 0.0) -> Scene:
    """J = 2 kg m2 about a fixed axis, at 3 rad/s; theta'' = (torque - damping theta') / 2."""
    builder = SceneBuilder("flywheel").rigid("wheel", mass=1.0, inertia=2.0)
    builder.revolute("axle", "ground.origin", "wheel.origin", damping=damping)
    builder.torque("motor", "wheel.origin", torque).rates({"wheel.theta": 3.0})
    return builder.simulation(t_end=2.0, dt=1e-2, scheme="rk4").build()


def masses(force: str | None) -> Scene:
    """Two coupled oscillators, whose sub-steps of `coupled` resonate with the step of the slow one at dt = 0.1 s."""
    builder = SceneBuilder("masses")
    load = {} if force is None else {"force": [force, 0.0]}
    builder.structure(
        coordinates=["x", "y"], mass=[[1.0, 0.5], [0.5, 1.0]], stiffness=[[1.0, 0.0], [0.0, 400.0]], **load
    )
    builder.groups(L=["x"], S=["y"]).initial({"x": 1.0, "y": 0.1})
    return builder.simulation(t_end=100.0, dt=0.1, m=[8], scheme="coupled").build()


@pytest.mark.parametrize("scheme", ["rk4", "dop853", "single_rate"])
def test_work_of_a_constant_torque_is_torque_times_angle(model_of: Build, scheme: str) -> None:
    """Power grows linearly, which the quadrature takes exactly."""
    run = simulate(model_of(flywheel("4.0")), scheme=scheme, save_every=7)
    assert run.work() == pytest.approx(4.0 * (run["wheel.theta"] - run["wheel.theta"][0]), abs=1e-10)
    assert np.abs(run.energy_balance()).max() < 1e-10


@pytest.mark.parametrize("scheme", ["rk4", "exponential_adams", "single_rate"])
def test_work_of_one_whole_step_beside_broken_ones(model_of: Build, scheme: str) -> None:
    """At the start, between jumps, behind an input's sample and an event, at the end; steps of 10 ms, constant torques.

    J = 2 kg m2, so W = v^2 - 9 with the velocity by hand.
    """
    torque = "where(t < 0.0153, 4, where(t < 0.035, -60, where(t < 0.0571, 50, -7))) + extra"
    torque += " + where(t < 0.1019, boost, where(t < 0.1219, -20, 500))"  # the last jump is behind the end
    builder = SceneBuilder("driven_wheel").rigid("wheel", mass=1.0, inertia=2.0)
    builder.revolute("axle", "ground.origin", "wheel.origin")
    builder.input("extra", 0.0, "N*m").input("boost", 0.0, "N*m").event("later", "t - 0.0837", action={"boost": "25"})
    builder.torque("motor", "wheel.origin", torque).rates({"wheel.theta": 3.0})
    model = model_of(builder.simulation(t_end=0.12, dt=0.01, scheme="rk4").build())
    run = simulate(model, scheme=scheme, inputs={"extra": Sampled(lambda t, x: 750.0 * t, 0.04)})
    assert run.status.name == "completed" and len(run.events) == 1
    ends = [0.0, 0.0153, 0.035, 0.04, 0.0571, 0.08, 0.0837, 0.1019, 0.12]
    v = 3.0 + np.append(0.0, np.cumsum(np.diff(ends) * [4, -60, 50, 80, 23, 53, 78, 33])) / 2
    assert run.rate("wheel.theta")[-1] == pytest.approx(v[-1], rel=1e-10)  # an event's time by search
    assert run.work()[-1] == pytest.approx(v[-1] ** 2 - 9.0, abs=1e-9)
    assert np.abs(run.energy_balance()).max() < 1e-11


def test_work_of_torque_and_damper_converges_with_order_four(model_of: Build) -> None:
    """theta' = v: v' = -v/4 + 2 sin 5t; W is the change of v^2, known in closed form."""
    model = model_of(flywheel("4 * sin(5 * t)", damping=0.5))
    a, amplitude = 0.25, 2.0
    k = amplitude / (a**2 + 25)

    def v(t: np.ndarray) -> np.ndarray:
        return (3.0 + 5 * k) * np.exp(-a * t) + k * (a * np.sin(5 * t) - 5 * np.cos(5 * t))

    errors = []
    for dt in (4e-2, 2e-2, 1e-2):
        run = simulate(model, dt=dt, save_every=1)
        errors.append(np.abs(run.work()[3:] - (v(run.t) ** 2 - 9.0)[3:]).max())
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert rates == pytest.approx(4.0, abs=0.4), errors


@pytest.mark.parametrize("scheme", ["printed", "coupled", "linearised", "exponential", "radau", "hht"])
def test_work_does_not_depend_on_what_is_saved(built_in: Load, scheme: str) -> None:
    model = built_in("flexible_slider_crank")
    often, seldom = (simulate(model, scheme=scheme, t_end=0.02, dt=4e-5, save_every=n) for n in (1, 100))
    assert np.array_equal(often.work()[::100], seldom.work())
    assert np.abs(seldom.energy_balance()).max() < 2e-3 * seldom.total_energy.max()


def test_nothing_is_added_where_nothing_works(built_in: Load) -> None:
    """The program of a conservative mechanism has no account; its energy is judged all the same."""
    run = simulate(built_in("pendulum"), t_end=0.1)
    assert "work" not in run.energy and not run.work().any()


@pytest.mark.parametrize("force", [None, "1e-9 * sin(t)"])
def test_a_load_does_not_hide_spurious_energy(model_of: Build, force: str | None) -> None:
    """The sub-cycling feeds the slow mass; driven by a billionth of its forces or not, the run ends by name."""
    run = simulate(model_of(masses(force)))
    assert run.status.name == "diverged" and 15.0 < run.status.time < 40.0
    assert "work done" in run.status.cause


def test_a_prescribed_motion_does_not_hide_spurious_energy(built_in: Load) -> None:
    """51.5 J are right; without the account this run completed at 5,145 J."""
    run = simulate(built_in("flexible_slider_crank"), scheme="coupled", m=[4], dt=1e-4)
    assert run.status.name == "diverged" and run.status.time < 0.1


def test_the_account_is_kept_by_checkpoints(built_in: Load, tmp_path: Path) -> None:
    model, settings = built_in("flexible_slider_crank"), {"scheme": "single_rate", "dt": 2e-5, "t_end": 0.01}

    def stop(t: float, t_end: float) -> None:
        if t > 0.005:
            raise KeyboardInterrupt

    whole = simulate(model, **settings)
    simulate(model, **settings, checkpoint=tmp_path / "run.npz", progress=stop)
    assert np.array_equal(resume(model, tmp_path / "run.npz").work(), whole.work())


def test_a_start_from_rest_is_not_judged_by_its_first_steps(model_of: Build) -> None:
    """A drive whose speed grows with t^3: the energy of the first steps is as small as their errors."""
    run = simulate(model_of(spin_up_beam()), t_end=1.0, dt=5e-3)
    assert run.status.ok
    assert np.abs(run.energy_balance()).max() < 0.05 * run.energy["kinetic"].max()


@pytest.mark.parametrize("scheme", ["single_rate", "printed", "coupled", "linearised", "exponential", "rk4", "hht"])
@pytest.mark.parametrize("name, most", [("hub_beam", 0.15), ("flexible_slider_crank_torque", 0.15), ("pendulum", 0.0)])
def test_the_account_costs_little(built_in: Load, name: str, most: float, scheme: str) -> None:
    """Arithmetic operations of a major step without and with the account: powers are of what is evaluated anyway."""

    def operations(account: bool) -> int:
        built = scheme_kind(scheme).build(scheme, built_in(name), 1e-5, None, {})
        if account:
            account_for_work(built)
        program = prepare(built.program(), built.layout.size, built.c_size).program
        return program.fold(
            arithmetic, sum, lambda body, node: body * (node.count if isinstance(node, Repeat) else node.usual)
        )

    assert operations(True) <= (1 + most) * operations(False)


@pytest.mark.parametrize(
    "scheme, order",
    [
        ("coupled", 2),
        ("decoupled", 2),
        ("linearised", 2),
        ("exponential", 4),
        ("exponential_rk4", 4),
        ("exponential_midpoint", 2),
    ],
)
def test_the_balance_is_of_the_order_of_the_scheme(model_of: Build, scheme: str, order: int) -> None:
    """Two damped, driven oscillators: the balance at the end falls with the scheme's order."""
    builder = SceneBuilder("fed")
    builder.structure(
        coordinates=["x", "y"],
        mass=[[1.0, 0.2], [0.2, 1.0]],
        stiffness=[[1.0, 0.3], [0.3, 9.0]],
        damping=[[0.2, 0.0], [0.0, 0.5]],
        force=["sin(2 * t)", 0.5],
    )
    builder.groups(L=["x"], S=["y"]).initial({"x": 1.0, "y": 0.1})
    model = model_of(builder.simulation(t_end=2.0, dt=0.04, m=[2]).build())
    m = {"coupled": [2], "decoupled": [2], "exponential_rk4": None, "exponential_midpoint": None}.get(scheme, [4])
    off = [abs(simulate(model, scheme=scheme, dt=dt, m=m).energy_balance()[-1]) for dt in (0.04, 0.01)]
    assert off[0] < 0.02 and np.log2(off[0] / off[1]) / 2 > order - 0.4, off


def test_a_scheme_that_does_not_count_powers_is_counted(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stage before its own observes the power; another model, so that nothing compiled is at hand."""
    monkeypatch.setattr(ExplicitRungeKutta, "counts_powers", False)
    monkeypatch.setattr(ExplicitRungeKutta, "worked", lambda *arguments: {})
    run = simulate(model_of(flywheel("3.0")), scheme="rk4", save_every=7)
    assert run.work()[-1] > 10.0
    assert run.work() == pytest.approx(3.0 * (run["wheel.theta"] - run["wheel.theta"][0]), abs=1e-10)
