"""What has no derivative is refused by name; what has one is not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import (
    ArgumentError,
    DifferentiableRun,
    InitialStateError,
    Model,
    ModelError,
    NoResult,
    Sampled,
    SymgenError,
    gradient,
)
from runtime.gradients import End, SquaredError
from symgen.scene import Scene, SceneRecord
from tests.gradients.test_gradients import sliding
from tests.running.test_inputs import cart, crane
from tests.support.slider_cranks import loop

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]


def test_jumps_that_move_apart_are_refused(model_of: Build) -> None:
    """Two at one time: whether the force between them acts depends on which one comes first."""
    model = model_of(sliding("where(t < T, 0, f) + where(t < 2 * S, 1, 0)", T=0.5, f=2.0, S=0.25))
    run = {"scheme": "rk4", "dt": 0.01}
    with pytest.raises(NoResult, match=r"two conditions change at t = 0\.5 s and separate"):
        gradient(model, End("mass.x_dot"), ["T", "S"], **run)
    assert gradient(model, End("mass.x_dot"), ["f"], **run)["f"] == pytest.approx(0.5, rel=1e-12)
    later = gradient(model, End("mass.x_dot"), ["T"], parameters={"T": 3.0}, **run)
    assert later["T"] == 0.0  # it does not switch in this run


@pytest.mark.long
def test_a_jump_that_the_motion_decides_is_refused_and_a_bend_is_not(model_of: Build) -> None:
    """x'' = 1 until x = 0.1, then more: by a jump of the force, or by a spring that begins there. A jump that steps
    cross is refused; where they end there its time is that of x = 0.1, sqrt(0.2).
    """
    run = {"scheme": "rk4", "dt": 0.01}
    jump = model_of(sliding("where(place < 0.1, 1, k)", k=5.0))
    with pytest.raises(NoResult, match="force on mass.x jumps by 4"):
        gradient(jump, End("mass.x_dot"), ["k"], **run, options={"kinks": "crossed"})
    assert gradient(jump, End("mass.x_dot"), ["k"], **run)["k"] == pytest.approx(1 - np.sqrt(0.2), rel=1e-6)
    bend = model_of(sliding("where(place < 0.1, 1, 1 - k * (place - 0.1))", k=5.0))
    t1, w = np.sqrt(0.2), np.sqrt(5.0)  # then x - 0.1 = (1 - cos w s) / k + v1 / w sin w s

    def exact(k: float) -> float:
        w = np.sqrt(k)
        return float(np.sin(w * (1 - t1)) / w + t1 * np.cos(w * (1 - t1)))

    found = gradient(bend, End("mass.x_dot"), ["k"], **run)
    difference = (exact(5.0 + 1e-5) - exact(5.0 - 1e-5)) / 2e-5
    assert found["k"] == pytest.approx(difference, rel=2e-3)
    assert found.value == pytest.approx(exact(w**2), rel=1e-4)


@pytest.mark.parametrize(
    "outputs, by, error, text",
    [
        (["tip_y"], ["hub.inertai"], ModelError, "did you mean 'hub.inertia'"),
        (["tip_z"], ["hub.inertia"], ModelError, "output 'tip_z'.*did you mean 'tip_y'"),
        ("tip_y", ["hub.inertia"], ArgumentError, "outputs.*give a list of names"),
        (["tip_y"], [], ModelError, "by must be a list"),
        (["tip_y"], ["hub.inertia", "hub.inertia"], ModelError, "names something twice"),
        (["tip_y"], ["beam.modes"], ModelError, "structure"),
        (["tip_y"], ["beam/clamped-free3@0.0625.at[0,0]"], ArgumentError, "only as structure or as drawing"),
    ],
)
def test_names_that_cannot_be_used(built_in: Load, outputs, by, error: type[SymgenError], text: str) -> None:
    with pytest.raises(error, match=text):
        DifferentiableRun(built_in("hub_beam"), outputs, by)


def test_values_that_cannot_be_used(built_in: Load) -> None:
    model = built_in("hub_beam")
    run = DifferentiableRun(model, ["tip_y"], ["hub.inertia", "torque"], t_end=0.02, seen_every=0.01)
    for x, text in (([1.0], "has shape"), ([np.nan, 1.0], "value of hub.inertia is nan"), ({"torque": 1.0}, "missing")):
        with pytest.raises(ArgumentError, match=text):
            run.values(x)
    with pytest.raises(ModelError, match="must be at least zero"):
        run.values([-1.0, 1.0])
    with pytest.raises(ArgumentError, match="needs the output 'tip_x'"):
        run.gradient(End("tip_x"), run.x0)
    with pytest.raises(ArgumentError, match="one value for each of the 3 saved times"):
        run.gradient(SquaredError("tip_y", np.zeros(2)), run.x0)
    with pytest.raises(ArgumentError, match="data of tip_y: is nan at t = 0.01 s"):
        run.gradient(SquaredError("tip_y", np.array([0.0, np.nan, 0.0])), run.x0)
    with pytest.raises(ArgumentError, match="mode"):
        run.gradient(End("tip_y"), run.x0, mode="sideways")


def test_runs_without_a_derivative(built_in: Load) -> None:
    with pytest.raises(NoResult, match="step_too_long"):
        gradient(built_in("hub_beam"), End("tip_y"), ["torque"], dt=0.1, t_end=1.0)
    with pytest.raises(InitialStateError, match="beam.q1 follow from the equilibrium"):
        gradient(built_in("hub_beam"), End("tip_y"), ["beam.q1"], t_end=0.02, start="quasi_static")
    with pytest.raises(InitialStateError, match="the assembly moves crank.theta"):
        short = {"coupler.tip.x": 0.52}
        gradient(built_in("four_bar"), End("crank.theta"), ["crank.mass"], t_end=0.02, parameters=short)


def test_inputs_that_are_not_differentiated(model_of: Build) -> None:
    model, moved = model_of(cart()), model_of(crane(rates=True))
    with pytest.raises(ArgumentError, match="input 'force': a controller"):
        gradient(model, End("cart.x"), ["cart.mass"], inputs={"force": Sampled(lambda t, values: 1.0, 0.1)})
    with pytest.raises(ArgumentError, match="input 'way': .* with rates"):
        gradient(moved, End("load.theta"), ["load.mass"], inputs={"way": ([0.0, 0.5], [0.0, 0.1])})
    with pytest.raises(ModelError, match=r"neither a parameter nor a coordinate 'force\[7\]'"):
        gradient(model, End("cart.x"), ["force[7]"], inputs={"force": ([0.0, 0.5], [0.0, 0.1])})


@pytest.mark.long
def test_a_change_of_coordinates_on_the_way_is_refused(model_of: Build) -> None:
    """The slider's place as q_i of a crank that goes round: a simulation goes on with the crank's angle."""
    model = model_of(loop(0.3, 1.0, "slider.x").build())
    with pytest.raises(NoResult, match="a simulation would change coordinates there"):
        gradient(model, End("crank.theta"), ["crank.mass"], scheme="rk4", t_end=1.0, dt=1e-3)


def test_a_prescribed_velocity_that_jumps_is_refused(model_of: Build) -> None:
    """As a simulation refuses it, before any step."""
    scene = (
        Scene("turned")
        .parameter("speed", 2.0, "rad/s")
        .rigid("wheel", mass=1.0, inertia=1.0)
        .rigid("bob", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
        .revolute("axle", "ground.origin", "wheel.origin")
        .revolute("hinge", "wheel.origin", "bob.origin")
        .prescribed_angle("drive", "ground.origin", "wheel.origin", motion="where(t < 0.5, 0, speed * (t - 0.5))")
        .simulation(t_end=1.0, dt=1e-2, scheme="rk4")
        .build()
    )
    with pytest.raises(ModelError, match=r"its velocity jumps by 2 at t = 0\.5 s"):
        gradient(model_of(scene), End("bob.theta"), ["speed"])


def test_a_derivative_says_where_it_is_taken(built_in: Load) -> None:
    """The three methods want their point, and keep none: at every x the slopes are those of differences there."""
    run = DifferentiableRun(built_in("pendulum"), ["tip_x"], ["length"], t_end=0.5, dt=5e-3, seen_every=0.1)
    for ask in (run.values, run.jacobian, lambda *x: run.gradient(End("tip_x"), *x)):
        with pytest.raises((ArgumentError, TypeError), match="x"):
            ask()
    with pytest.raises(ArgumentError, match="x.*give"):
        run.jacobian(None)
    x, h = run.x0 * 1.3, 1e-5
    difference = (run.values(x + h) - run.values(x - h))[:, 0] / (2 * h)
    run.values(run.x0)  # leaves nothing behind
    assert run.jacobian(x)["tip_x", "length"] == pytest.approx(difference, rel=1e-7, abs=1e-9)
    for mode in ("forward", "reverse"):
        assert run.gradient(End("tip_x"), x, mode=mode)["length"] == pytest.approx(difference[-1], rel=1e-7)
