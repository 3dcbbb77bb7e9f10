"""Loads and prescribed motions that jump in time: steps end there, each side has its value, impulses are given."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import SCHEMES, Model, ModelError, ensemble, resume, simulate
from symgen.scene import Scene, SceneRecord, s_curve, trapezoid
from tests.support.scenes import driven_bob, on_hinge

Build = Callable[[SceneRecord], Model]
ON, OFF, BACK = 0.2713, 0.611, 0.8
CAPS = {2: 1e-2, 4: 2e-5, 5: 1e-6, 8: 1e-9}  # of the error at 40 steps, by order


def pendulum() -> SceneRecord:
    """m = 1, centre at 0.5 m, inertia 0.35 about the hinge; a torque that is switched on, off, and kinks."""
    builder = on_hinge("kicked", "rod", "pin", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0)).gravity(0, -9.81)
    builder.torque("kick", "rod.origin", f"where({ON} <= t < {OFF}, 5, 0) + 20 * max(t - {BACK}, 0)")
    return builder.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


def exact_pendulum() -> np.ndarray:
    """theta and its rate after 1 s by hand: 0.35 theta'' = -4.905 cos theta + torque, piece by piece."""
    y, ends = np.zeros(2), (0.0, ON, OFF, BACK, 1.0)
    for k, (a, b) in enumerate(zip(ends, ends[1:], strict=False)):

        def slope(t: float, y: np.ndarray, k: int = k) -> list[float]:
            torque = 5.0 * (k == 1) + 20 * (t - BACK) * (k == 3)
            return [y[1], (torque - 4.905 * np.cos(y[0])) / 0.35]

        y = solve_ivp(slope, (a, b), y, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    return y


@pytest.mark.every_push("rk4", "exponential_adams", "single_rate")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_scheme_keeps_its_order_across_jumps(model_of: Build, scheme: str) -> None:
    """Jumps within steps, and a kink at the end of one. Doubling the steps divides the error by 2^order."""
    model, exact = model_of(pendulum()), exact_pendulum()
    order = {"rk4": 4, "exponential": 4, "exponential_rk4": 4, "radau": 5, "dopri5": 5, "dop853": 8}.get(scheme, 2)
    errors = []
    for steps in (20, 40):
        run = simulate(model, scheme=scheme, dt=1 / steps, force=True)
        assert run.status.ok, run.status
        errors.append(np.abs([run["rod.theta"][-1] - exact[0], run.rate("rod.theta")[-1] - exact[1]]).max())
    assert errors[1] < 1e-10 or np.log2(errors[0] / errors[1]) > order - 0.4, errors
    assert errors[1] < CAPS[order]


@pytest.mark.parametrize("scheme", ["dopri5", "exponential", "exponential_rk4"])
def test_the_work_of_each_side_is_its_own(model_of: Build, scheme: str) -> None:
    """Steps that follow from a tolerance: energy and work differ by the steps, not by the jumps of 5 N m."""
    run = simulate(model_of(pendulum()), scheme=scheme, tolerance=1e-7, seen_every=0.01)
    energy = run.energy["kinetic"] + run.energy["potential"] - run.work()
    assert np.ptp(run.work()) > 3 and np.ptp(energy) < 2e-5


UP, DOWN = float(np.nextafter(0.3, 1)), float(np.nextafter(0.7, 0))
PULSES = [(0.3, 0.7), (UP, DOWN), (0.123, 0.456), (0.51, 0.53), (0.1, 0.1517), (0.0, 0.25), (0.6, 1.0), (-1.0, 0.0)]


def pushed_masses() -> SceneRecord:
    """A mass on a rail for each pulse, pushed by 3 N from the first time to the second."""
    builder = Scene("pushed_masses")
    for k, (a, b) in enumerate(PULSES):
        builder.rigid(f"mass{k}", mass=1.0, inertia=0.1).prismatic(f"rail{k}", "ground.origin", f"mass{k}.origin")
        builder.force(f"push{k}", f"mass{k}.origin", f"where(t < {a!r}, 0, where(t <= {b!r}, 3, 0))", 0.0)
    return builder.simulation(t_end=1.0, dt=0.1, scheme="rk4").build()


@pytest.mark.every_push("rk4", "printed")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_each_side_has_its_own_value(model_of: Build, scheme: str) -> None:
    """A constant force from a to b gives v = F (b - a) and x = F (b - a) (t - (a + b) / 2), to rounding.

    Times within steps, at ends of steps, a rounding beside one, both in one step, at the start and at the end: one
    evaluation on the wrong side would be off by F h or more.
    """
    run = simulate(model_of(pushed_masses()), scheme=scheme, force=True)
    for k, (a, b) in enumerate(PULSES):
        a = max(a, 0.0)
        assert run.rate(f"mass{k}.x")[-1] == pytest.approx(3 * (b - a), rel=1e-11, abs=1e-12)
        assert run[f"mass{k}.x"][-1] == pytest.approx(3 * (b - a) * (1 - (a + b) / 2), rel=1e-11, abs=1e-12)
    assert run.t == pytest.approx(np.linspace(0, 1, 11), abs=1e-12)


def kicked_crank(motion: str, **settings: Any) -> SceneRecord:
    """A bob (1 kg, centre at 0.5 m, 0.35 kg m2 about its hinge) on the tip of a driven crank of 0.5 m."""
    builder = (
        driven_bob("kicked_crank", motion).gravity(0, -9.81).parameter("jump", 0.4567, "s").initial({"bob.theta": -1.0})
    )
    return builder.simulation(**{"t_end": 1.0, "dt": 1e-2, "scheme": "rk4", **settings}).build()


@pytest.mark.every_push("dopri5-1e-09-0.4567", "exponential_rk4-1e-10-0.46")
@pytest.mark.parametrize("jump", [0.4567, 0.46])
@pytest.mark.parametrize(
    "scheme, tolerance", [("dop853", None), ("dopri5", 1e-9), ("exponential", 1e-10), ("exponential_rk4", 1e-10)]
)
def test_a_velocity_that_jumps_gives_its_impulse(
    model_of: Build, jump: float, scheme: str, tolerance: float | None
) -> None:
    """By hand: the hinge jumps by 0.5 * 2 m/s upwards, and 0.35 dw + m l cos(theta) dv = 0 about it."""
    model = model_of(kicked_crank("where(t < jump, 0, 2 * (t - jump))"))
    run = simulate(model, parameters={"jump": jump}, scheme=scheme, tolerance=tolerance, seen_every=0.01)
    assert run.status.ok and [event.kind for event in run.events] == ["velocity_jump"]

    def hanging(t: float, y: np.ndarray, v: float = 0.0) -> list[float]:
        """The hinge goes round: its acceleration is -0.5 v^2 (cos 2t, sin 2t) with v = 2 after the jump."""
        angle = v * (t - jump)
        ax, ay = -0.5 * v**2 * np.cos(angle), -0.5 * v**2 * np.sin(angle) + 9.81
        return [y[1], -0.5 * (ay * np.cos(y[0]) - ax * np.sin(y[0])) / 0.35]

    tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12}
    before = solve_ivp(hanging, (0, jump), [-1.0, 0.0], **tight).y[:, -1]
    change = -0.5 * np.cos(before[0]) * 1.0 / 0.35
    after = solve_ivp(hanging, (jump, 1.0), before + [0, change], args=(2.0,), **tight).y[:, -1]
    assert run["bob.theta"][-1] == pytest.approx(after[0], abs=1e-8)
    assert run.rate("bob.theta")[-1] == pytest.approx(after[1], abs=1e-8)
    assert run.events[0].time == pytest.approx(jump, abs=1e-12)
    energy = run.energy["kinetic"] + run.energy["potential"] - run.work()
    assert np.ptp(energy) < 1e-4  # of jumps of 1 J


def test_a_position_that_jumps_is_refused_by_name(model_of: Build) -> None:
    model = model_of(kicked_crank("0.3 * step(t - jump)"))
    with pytest.raises(ModelError, match=r"drive\.angle: its position jumps by 0\.3 at t = 0\.4567 s"):
        simulate(model)


@pytest.mark.every_push("single_rate-None")
@pytest.mark.parametrize("scheme, tolerance", [("single_rate", None), ("dopri5", 1e-6)])
def test_a_run_across_jumps_is_gone_on_with_bit_for_bit(
    model_of: Build, tmp_path: Path, scheme: str, tolerance: float | None
) -> None:
    """Stopped before and after a jump, at the end of a step and within one; steps of a tolerance are there before."""
    model = model_of(kicked_crank("where(t < jump, 0, 2 * (t - jump))"))
    for jump, stop in ((0.46, 0.46), (0.4567, 0.45)):
        settings: dict[str, Any] = {"parameters": {"jump": jump}, "scheme": scheme, "seen_every": 0.0}
        settings |= {"tolerance": tolerance, "seen_every": 0.01}
        settings |= {"options": {"error_of": "step"}} if tolerance else {}
        whole = simulate(model, **settings)

        def interrupt(t: float, t_end: float, stop: float = stop) -> None:
            if t > stop - 1e-9:
                raise KeyboardInterrupt

        path = tmp_path / f"{jump}_{stop}.npz"
        simulate(model, **settings, checkpoint=path, checkpoint_every=1, progress=interrupt)
        again = resume(model, path)
        assert np.array_equal(again.q, whole.q) and np.array_equal(again.q_dot, whole.q_dot)
        assert again.events == whole.events and len(again.events) == 1


@pytest.mark.every_push("0.43-0.01-exponential")
@pytest.mark.parametrize("scheme", ["dopri5", "exponential", "exponential_rk4"])
@pytest.mark.parametrize("jump, dt", [(0.402, 0.1), (0.43, 0.01)])
def test_an_impulse_is_no_error(model_of: Build, scheme: str, jump: float, dt: float) -> None:
    """A bob that stands and falls, so that errors grow; steps of every level end at the jump."""
    model = model_of(kicked_crank("where(t < jump, 0, 2 * (t - jump))"))
    settings: dict[str, Any] = {"parameters": {"jump": jump}, "initial": {"bob.theta": 1.5}}
    exact = simulate(model, scheme="dop853", dt=0.002, **settings)["bob.theta"]
    run = simulate(model, scheme=scheme, tolerance=1e-5, seen_every=dt, **settings)
    error = abs(run["bob.theta"][-1] - exact[-1]) / (np.ptp(exact) / 2)
    assert error < 3e-5 and run.status.ok
    assert error / 30 < run.error.largest < max(10 * error, 1e-7)


def test_a_stepper_gives_the_run(model_of: Build) -> None:
    """Bit for bit, in one call or in many, from a saved state, after a change of the parameter that moves the jump."""
    model = model_of(kicked_crank("where(t < jump, 0, 2 * (t - jump))"))
    for jump in (0.46, 0.4567):
        whole = simulate(model, parameters={"jump": jump}, seen_every=50 * model.simulation["dt"])
        stepper = model.stepper(parameters={"jump": 0.2})
        stepper.step(40)
        stepper.change({"jump": jump})
        stepper.reset()
        stepper.step(46)
        kept = stepper.save()
        for _ in range(4):
            stepper.step()
        assert stepper.state["bob.theta_dot"] == whole.rate("bob.theta")[1]
        stepper.step(30)
        stepper.restore(kept)
        stepper.step(54)
        assert stepper.state["bob.theta"] == whole["bob.theta"][-1]
    late = model_of(kicked_crank("0.3 * step(t - 50.05)")).stepper()
    with pytest.raises(ModelError, match="position jumps by 0.3 at t = 50.05"):
        late.step(5100)


@pytest.mark.every_push("where(t < jump, 0, 2 * (t - jump))-rk4")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "exponential_adams"])
@pytest.mark.parametrize("motion", ["where(t < jump, 0, 2 * (t - jump))", "0.02 * abs(sin(30 * t / jump))"])
def test_cases_of_an_ensemble_have_their_own_jumps(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, scheme: str, motion: str
) -> None:
    """Each is the run by itself, to the last bit, and yet in its lane: one impulse, or more than a lane knows."""
    monkeypatch.setattr("runtime.studies.ensemble.rows.run_alone", None)
    model, jumps = model_of(kicked_crank(motion)), [0.3, 0.4567, 2.0]
    found = ensemble(model, {"jump": jumps}, outputs=["bob.theta", "bob.theta_dot"], seen_every=1.0, scheme=scheme)
    for k, jump in enumerate(jumps):
        alone = simulate(model, parameters={"jump": jump}, scheme=scheme, error="off", force=True)
        assert float(found["bob.theta"][k, -1]) == alone["bob.theta"][-1]
        assert float(found["bob.theta_dot"][k, -1]) == alone.rate("bob.theta")[-1]


def test_the_first_moments_of_a_smooth_motion_are_no_jump(built_in: Callable[[str], Model]) -> None:
    """A spin-up that begins as t^3: in a nanosecond its rate is rounding, which changes by jumps."""
    run = simulate(built_in("spin_up_beam"), scheme="rk4", dt=1e-9, t_end=1e-9, engine="interpreted")
    assert run.status.ok


def test_a_small_jump_of_a_slow_motion_is_a_jump(model_of: Build) -> None:
    """Of some 1e-5 rad/s, where no velocity is larger, and no condition says when."""
    builder = Scene("slow").rigid("a", mass=1.0, inertia=0.1).rigid("b", mass=1.0, inertia=0.1)
    builder.revolute("h", "ground.origin", "a.origin").revolute("k", "a.origin", "b.origin")
    builder.prescribed_angle("drive", "ground.origin", "a.origin", motion="1e-5 * sqrt((t - 0.503)**2)")
    model = model_of(builder.simulation(t_end=1.0, dt=0.05, scheme="printed").build())
    with pytest.raises(ModelError, match="velocity jumps"):
        simulate(model, scheme="rk4", engine="interpreted")


@pytest.mark.parametrize("motion", ["table('move', t - 1)", "table('move', t - 1) + more"])
@pytest.mark.parametrize("move", [trapezoid, partial(s_curve, jerk=2.0)])
def test_rounding_of_a_velocity_is_no_jump(model_of: Build, motion: str, move: Callable[..., Any]) -> None:
    """From rest at 1 s on and to rest again at the end; with an input nobody knows before which times may jump."""
    profile = move(0.25, speed=0.5, acceleration=1.0)
    builder = driven_bob("set_out", motion).table("move", **profile).input("more", rates=True)
    for t_end in (1.25, 1.0 + profile["x"][-1] + 0.25):
        run = simulate(model_of(builder.simulation(t_end=t_end).build()), scheme="rk4", dt=0.01)
        assert run.status.ok and run.events == []
    assert run["crank.theta"][-1] == pytest.approx(0.25, abs=1e-12)


def test_a_velocity_that_jumps_by_little_is_told(model_of: Build) -> None:
    run = simulate(model_of(kicked_crank("where(t < 0.4567, 0, 1e-9 * (t - 0.4567))")))
    assert [event.kind for event in run.events] == ["velocity_jump"]
