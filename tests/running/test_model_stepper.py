"""The stepper: one call or many give the same bits; resets, saved states, controllers in the loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from runtime import ArgumentError, ModelError, SchemeError, equilibrium, simulate
from runtime.model import Model
from symgen.scene import SceneRecord
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]


@pytest.mark.parametrize(
    "name, scheme", [("pendulum", "single_rate"), ("four_bar", "coupled"), ("hub_beam", "single_rate")]
)
def test_many_calls_are_one_run_bit_for_bit(built_in: Load, name: str, scheme: str) -> None:
    """10,000 calls of one step, one call of 10,000, and `simulate`."""
    model = built_in(name)
    one, many = (model.stepper(scheme=scheme, dt=1e-4) for _ in range(2))
    for _ in range(10_000):
        one.step()
    many.step(10_000)
    run = simulate(model, scheme=scheme, dt=1e-4, t_end=1.0, samples=1)
    np.testing.assert_array_equal(one.save().z, many.save().z)
    np.testing.assert_array_equal(one.sample.q[0], run.q[-1])
    np.testing.assert_array_equal(one.sample.q_dot[0], run.q_dot[-1])
    np.testing.assert_array_equal(one.sample.joint_forces[0], run.joint_forces[-1])
    assert one.time == run.t[-1]


@pytest.mark.parametrize("engine", ["interpreted", "auto"])
def test_restored_states_go_on_as_before(built_in: Load, engine: str) -> None:
    model = built_in("double_pendulum")
    stepper = model.stepper(scheme="rk4", dt=1e-3, engine=engine)
    stepper.step(100)
    kept = stepper.save()
    stepper.step(50)
    first = stepper.state
    stepper.restore(kept)
    assert stepper.time == pytest.approx(0.1)
    stepper.step(50)
    assert stepper.state == first
    stepper.reset()
    stepper.step(150)
    assert stepper.state == first


def test_reset_takes_states_by_name_and_equilibria(built_in: Load) -> None:
    model = built_in("pendulum")
    stepper = model.stepper(scheme="rk4", dt=1e-3)
    stepper.reset({"rod.theta": 0.3, "rod.theta_dot": 2.0}, t=1.5)
    assert stepper.state["rod.theta"] == 0.3 and stepper.state["rod.theta_dot"] == 2.0 and stepper.time == 1.5
    hanging = equilibrium(model)
    stepper.reset(hanging)
    stepper.step(1000)
    assert stepper.state["rod.theta"] == pytest.approx(hanging["rod.theta"], abs=1e-14)


def test_what_is_read(built_in: Load) -> None:
    """The fast reader gives what the sample has."""
    stepper = built_in("four_bar").stepper(scheme="coupled", dt=1e-3)
    names = ["rocker.theta", "crank.theta_dot", "rocker.theta_dot"]
    read = stepper.reader(names)
    for _ in range(3):
        stepper.step(7)
        np.testing.assert_allclose(read(), [stepper.state[name] for name in names], rtol=0, atol=1e-9)
    assert set(stepper.reactions) == set(stepper.model.joints)
    tip = built_in("pendulum").stepper(scheme="rk4")
    tip.step(10)
    assert tip.reader(["tip_x"])()[0] == pytest.approx(tip.measures["tip_x"], abs=1e-15)


def cart() -> SceneRecord:
    """1 kg on a rail under a force u."""
    return (
        on_rail("cart", "cart", "rail", mass=1.0, inertia=1.0)
        .parameter("u", 0.0, "N", "force")
        .force("drive", "cart.origin", "u", 0.0)
        .initial({"cart.x": 1.0})
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
        .build()
    )


def test_a_sampled_controller_in_the_loop(model_of: Build) -> None:
    """Exact: u held for 20 ms at a time, u = -6 x - 4 x' - 2 s with s the sum of x; zero-order hold by expm."""
    stepper = model_of(cart()).stepper()
    read, total = stepper.reader(["cart.x", "cart.x_dot"]), 0.0

    for _ in range(150):
        x, v = read()
        total += 0.02 * float(x)
        stepper.change({"u": -6.0 * float(x) - 4.0 * float(v) - 2.0 * total})
        stepper.step(20)
    hold = expm(np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]) * 0.02)
    z, s = np.array([1.0, 0.0]), 0.0
    for _ in range(150):
        s += 0.02 * z[0]
        z = (hold @ np.array([*z, -6.0 * z[0] - 4.0 * z[1] - 2.0 * s]))[:2]
    np.testing.assert_allclose(read(), z, rtol=0, atol=1e-12)
    assert stepper.time == pytest.approx(3.0)


def test_changed_parameters_are_those_of_a_run(model_of: Build) -> None:
    model = model_of(cart())
    stepper = model.stepper(parameters={"u": 2.0})
    stepper.step(1000)
    np.testing.assert_array_equal(stepper.sample.q[0], simulate(model, parameters={"u": 2.0}).q[-1])
    stepper.change({"cart.mass": 4.0})
    assert stepper.sample.parameters[[p.name for p in model.parameters].index("u")] == 2.0


def test_checks_on_demand(built_in: Load) -> None:
    """A step far beyond its limit: the stepper goes on, and `check` says what a run would have said."""
    stepper = built_in("two_oscillators").stepper(scheme="single_rate", dt=1.0)
    assert stepper.check() is None
    stepper.step(2000)
    found = stepper.check()
    assert found is not None and not found.ok


def test_wrong_requests(built_in: Load, model_of: Build) -> None:
    model = built_in("pendulum")
    stepper = model.stepper()
    with pytest.raises(ModelError, match="no parameter 'rod.m'"):
        stepper.change({"rod.m": 1.0})
    with pytest.raises(ModelError, match="output 'tip'.*has no output of this name"):
        stepper.reader(["tip"])
    with pytest.raises(ArgumentError, match="another model"):
        stepper.restore(model_of(cart()).stepper().save())
    with pytest.raises(SchemeError):
        model.stepper(dt=-1.0)
    with pytest.raises(SchemeError):
        model.stepper(scheme="none")


@pytest.mark.parametrize("name, steps", [("hub_beam", 1), ("two_oscillators", 1)])
def test_steps_that_do_not_converge_are_divided_as_in_a_run(built_in: Load, name: str, steps: int) -> None:
    """In many calls, in one, behind a restored state and a reset: the states are those of the run."""
    model = built_in(name)
    how: dict[str, Any] = {"scheme": "printed", "m": [1], "options": {"max_iterations": 5}}
    run = simulate(model, t_end=0.05, error="off", samples=1, **how)
    one, many = (model.stepper(**how) for _ in range(2))
    kept, n = many.save(), int(run.stats["steps"])
    many.step(n)
    for _ in range(n):
        one.step()
    assert run.status.ok and many.check() is None
    assert many.divided_steps == one.divided_steps == run.stats.get("divided_steps", 0) >= steps
    np.testing.assert_array_equal(many.sample.q_i[0], run.q_i[-1])
    np.testing.assert_array_equal(one.save().z, many.save().z)
    end = many.sample
    many.restore(kept)
    many.step(n // 2)
    many.restore(many.save())
    many.step(n - n // 2)
    np.testing.assert_array_equal(many.sample.q_i, end.q_i)
    many.reset()
    assert many.divided_steps == 0
    many.step(n)
    np.testing.assert_array_equal(many.sample.q_i, end.q_i)


def test_steps_that_converge_in_no_parts_are_told_by_the_check(built_in: Load) -> None:
    """Far above the limit of the sweep in a strong damper the run ends, and the stepper goes on with what is left."""
    model = built_in("overdamped_joint")
    how: dict[str, Any] = {"scheme": "printed", "m": [1], "dt": 1e-3, "parameters": {"spring.damping": 1.3e6}}
    stepper = model.stepper(**how)
    stepper.step(20)
    status, run = stepper.check(), simulate(model, t_end=0.02, error="off", force=True, **how)
    assert stepper.time == pytest.approx(0.02) and run.status.name == "iteration_failed"
    assert status is not None and not status.ok
