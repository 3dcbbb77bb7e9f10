"""Inputs at operating points: trimmed, columns of linear systems, slopes of runs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import expm

from runtime import ArgumentError, NoEquilibrium, ensemble, equilibrium, gradient, linearise, simulate
from runtime.gradients import End
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.input_scenes import cart, crane, wave
from tests.support.scenes import on_hinge

Build = Callable[[SceneRecord], Model]


def test_trim_and_columns_of_inputs(model_of: Build) -> None:
    """A pendulum held at an angle while its trolley accelerates by -g tan(angle); columns of B by hand."""
    model = model_of(crane(rates=True))
    found = equilibrium(model, inputs={"way_ddot": None}, held={"load.theta": 0.1})
    assert found.trimmed["way_ddot"] == pytest.approx(-9.81 * np.tan(0.1), rel=1e-12)
    np.testing.assert_allclose(linearise(model, at={"load.theta": 0.3}, inputs=["way_ddot"]).B_state[1], -np.cos(0.3))
    system = linearise(model_of(cart()), at={"cart.x": 0.0}, inputs=["force"], outputs=["cart.x", "force"])
    np.testing.assert_array_equal(system.B_state, [[0.0], [0.5]])
    np.testing.assert_array_equal(system.D_state, [[0.0], [1.0]])


def test_a_trim_beside_what_nothing_moves(model_of: Build) -> None:
    """A block that slides freely beside a held pendulum has no stiffness: the torque is m g L cos(angle) still."""
    scene = (
        Scene("beside")
        .input("torque", 0.0, "N m")
        .gravity(0, -9.81)
        .rigid("arm", mass=1.0, inertia=0.02, center_of_mass=(0.5, 0))
        .rigid("block", mass=1.0, inertia=0.02)
        .revolute("axle", "ground.origin", "arm.origin")
        .prismatic("rail", "ground.origin", "block.origin")
        .torque("motor", "arm.origin", "torque")
    )
    model = model_of(scene.build())
    with np.errstate(over="raise", invalid="raise"):
        found = equilibrium(model, held={"arm.theta": 0.3}, inputs={"torque": None})
        assert found.trimmed["torque"] == pytest.approx(9.81 * 0.5 * np.cos(0.3), rel=1e-12)
        with pytest.raises(NoEquilibrium, match=r"arm.inertia"):  # which does not act on it
            equilibrium(model, held={"arm.theta": 0.3}, inputs={"arm.inertia": None})


def test_a_sample_is_linearised_with_the_inputs_of_its_time(model_of: Build) -> None:
    """K = m L (g cos th - x'' sin th) of the crane, with x'' of that time."""
    model = model_of(crane(rates=True))
    run = simulate(model, inputs={"way": wave})
    angle, pull = run["load.theta"][700], run["trolley.x_ddot"][700]
    K = linearise(model, at=(run, 700)).K[0, 0]
    assert K == pytest.approx(9.81 * np.cos(angle) - pull * np.sin(angle), rel=1e-12)


def test_the_linear_system_is_the_slope_of_the_simulation(model_of: Build) -> None:
    """exp(A T) and its integral against central differences of runs over T: a PD loop about a bent crane."""
    scene = (
        on_hinge("arm", "arm", "joint", mass=1.0, inertia=0.02, center_of_mass=(0.5, 0.0))
        .input("torque", 0.0, "N m")
        .gravity(0, -9.81)
        .measure("angle", "angle", "arm.origin")
        .torque("motor", "arm.origin", "torque - 6 * angle - 0.8 * angle_dot")
        .simulation(t_end=1.0, dt=1e-3, scheme="dop853")
        .build()
    )
    model, T = model_of(scene), 0.2
    rest = equilibrium(model, inputs={"torque": 3.0})
    system = linearise(model, rest, inputs=["torque"])
    exact = expm(np.block([[system.A_state, system.B_state], [np.zeros((1, 3))]]) * T)[:2]
    stepper, found, e = model.stepper(), [], 1e-5
    for k in range(3):
        ends = []
        for sign in (e, -e):
            x = np.array([rest["arm.theta"], 0.0]) + sign * (np.arange(2) == k)
            stepper.reset({"arm.theta": x[0], "arm.theta_dot": x[1]})
            stepper.step({"torque": 3.0 + sign * (k == 2)}, 200)
            ends.append([stepper.state["arm.theta"], stepper.state["arm.theta_dot"]])
        found.append((np.array(ends[0]) - np.array(ends[1])) / (2 * e))
    np.testing.assert_allclose(np.array(found).T, exact, rtol=1e-7, atol=1e-8)


@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_gradients_by_inputs(model_of: Build, mode: str) -> None:
    """x = F t^2 / 2 m: its slope by the force and by the mass."""
    found = gradient(model_of(cart()), End("cart.x"), ["force", "cart.mass"], parameters={"force": 3.0}, mode=mode)
    np.testing.assert_allclose([found["force"], found["cart.mass"]], [0.25, -0.375], rtol=1e-12)


def accelerated(motion: str) -> SceneRecord:
    """A pendulum of 1 m on a trolley that goes along a given way, with a damped second one below it."""
    return (
        Scene("accelerated")
        .gravity(0, -9.81)
        .rigid("trolley", mass=2.0, inertia=0.1)
        .rigid("load", mass=1.0, inertia=0.0, center_of_mass=(0, -1.0), markers={"end": {"position": (0.0, -1.0)}})
        .rigid("tail", mass=0.5, inertia=0.01, center_of_mass=(0, -0.4))
        .prismatic("rail", "ground.origin", "trolley.origin")
        .prescribed_displacement("drive", "ground.origin", "trolley.origin", motion=motion)
        .revolute("hook", "trolley.origin", "load.origin")
        .revolute("knee", "load.end", "tail.origin")
        .rotational_spring_damper("stiff", "load.origin", "tail.origin", stiffness=2.0, damping=0.3, free_angle=0.4)
        .build()
    )


def test_drives_are_held_unless_a_time_is_asked(model_of: Build) -> None:
    """At rest under gravity, where the drive's place is; moving: as on a trolley that is pushed by its acceleration.

    The linear system about either is what the same trolley without a motion gives, to the last digits.
    """
    model, still = model_of(accelerated("0.3 + 0.2 * t + 0.4 * t**2")), model_of(accelerated("0.3"))
    held, rest = equilibrium(model), equilibrium(still)
    assert held.drives == "held" and "drives held as at t = 0 s" in repr(held)
    np.testing.assert_allclose(held.q, rest.q, atol=1e-12)
    assert not held.q_dot.any() and held.steady and held.stable
    np.testing.assert_allclose(np.sort_complex(held.eigenvalues), np.sort_complex(rest.eigenvalues), rtol=1e-9)
    matrices = [linearise(one, at, inputs=[], outputs=[]) for one, at in ((model, held), (still, rest))]
    for name in "MDK":
        np.testing.assert_allclose(*(getattr(one, name) for one in matrices), atol=1e-10)
    moving = equilibrium(model, at_time=0.0)
    assert moving.drives == "moving" and moving["trolley.x_dot"] == pytest.approx(0.2)
    assert abs(moving["load.theta"] - held["load.theta"]) > 0.05
    assert "drives" not in repr(equilibrium(model_of(cart()), held={"cart.x": 0.0}))


def test_a_function_that_takes_numbers_only_is_refused(model_of: Build) -> None:
    """math.sin makes NaN of a symbol: said with what to write, before a run of NaN."""
    model = model_of(cart())
    with pytest.raises(ArgumentError, match="cannot take a symbol.*np.sin"):
        simulate(model, inputs={"force": lambda t: 2.0 * math.sin(3 * t) + t})
    assert simulate(model, inputs={"force": lambda t: np.sin(t)}, scheme="rk4").status.ok


@pytest.mark.long
def test_runs_begin_where_others_rest_or_end(model_of: Build) -> None:
    """An equilibrium and a solution as `initial`: of runs, ensembles, steppers, equilibria; runs go on."""
    model = model_of(accelerated("0.1 * t"))
    rest = equilibrium(model, at_time=0.0)
    still = simulate(model, initial=rest, t_end=0.5, dt=1e-3, scheme="dop853")
    assert np.abs(still["load.theta"] - rest["load.theta"]).max() < 1e-9
    free = model_of(accelerated("0.1"))
    whole = simulate(free, initial={"load.theta": 0.4}, t_end=1.0, dt=1e-3, scheme="dop853")
    half = simulate(free, initial=whole.initial_values(at=0.5), t_end=0.25, dt=1e-3, scheme="dop853")
    rest_of_it = simulate(free, initial=half, t_end=0.25, dt=1e-3, scheme="dop853")
    np.testing.assert_allclose(rest_of_it.q[-1], whole.q[-1], atol=1e-9)
    table = ensemble(
        free,
        parameters={"load.mass": [1.0, 1.0]},
        initial=half,
        outputs=["load.theta"],
        t_end=0.25,
        dt=1e-3,
        scheme="dop853",
    )
    np.testing.assert_allclose(table["load.theta"][:, -1], whole["load.theta"][-1], atol=1e-9)
    stepper = free.stepper(scheme="dop853", dt=1e-3)
    stepper.reset(half)
    stepper.step(250)
    assert stepper.state["load.theta"] == pytest.approx(whole["load.theta"][-1], abs=1e-9)
    assert equilibrium(free, initial=half)["load.theta"] == pytest.approx(equilibrium(free)["load.theta"], abs=1e-9)
