"""Cases stepped side by side: the bits of steppers by themselves, resets of some of them, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from runtime import ArgumentError, InitialStateError, ModelError, SchemeError
from symgen import Scene
from symgen.scenes import SCENES

CASES = 37  # no multiple of a vector's width
OUTPUTS = ["rod.theta", "rod.theta_dot", "height"]


@pytest.fixture(scope="module")
def model():
    scene = Scene("pushed").parameter("l", 0.5, "m").input("torque", 0.0, "N m").input("drag", 0.1, "N m s")
    scene.gravity(0, -9.81).rigid(
        "rod", mass=1.0, inertia=0.1, center_of_mass=("l", 0.0), markers={"tip": {"position": ("l", 0.0)}}
    )
    scene.revolute("hinge", "ground.origin", "rod.origin")
    scene.torque("motor", "rod.origin", "torque - drag * angle_dot")
    scene.measure("angle", "angle", of="rod.origin").measure("height", "y", of="rod.tip")
    return scene.simulation(dt=2e-3, scheme="rk4").model()


def alone(model, parameters, initial):
    stepper = model.stepper(parameters=parameters)
    stepper.reset(initial)
    return stepper, stepper.reader(OUTPUTS)


@pytest.mark.parametrize("workers", [1, 3])
def test_a_case_has_the_bits_of_a_stepper_by_itself(model, workers: int) -> None:
    rng, lengths, angles = np.random.default_rng(0), np.linspace(0.4, 0.6, CASES), np.linspace(-1, 1, CASES)
    lanes = model.lanes(CASES, parameters={"l": lengths}, outputs=OUTPUTS, workers=workers)
    values = lanes.reset({"rod.theta": angles, "rod.theta_dot": 0.5})
    starts = ({"rod.theta": angle, "rod.theta_dot": 0.5} for angle in angles.tolist())
    own = [alone(model, {"l": length}, start) for length, start in zip(lengths.tolist(), starts, strict=True)]
    for _ in range(5):
        np.testing.assert_array_equal(values, [read() for _, read in own])
        torques = rng.normal(size=CASES)
        values = lanes.step({"torque": torques, "drag": 0.2}, 7)
        for torque, (stepper, _) in zip(torques.tolist(), own, strict=True):
            stepper.step({"torque": torque, "drag": 0.2}, 7)
    np.testing.assert_array_equal(lanes.step(np.column_stack([torques, torques]), 3)[0], after(own[0], torques[0]))
    assert lanes.time == pytest.approx(np.full(CASES, 38 * 2e-3))
    assert not lanes.lost.any() and (lanes.status == "completed").all()


def after(one, torque):
    stepper, read = one
    stepper.step([torque, torque], 3)
    return read()


def test_some_begin_anew_and_the_others_go_on(model) -> None:
    lengths = np.linspace(0.4, 0.6, CASES)
    lanes, others = (model.lanes(CASES, parameters={"l": lengths}, outputs=OUTPUTS) for _ in range(2))
    for both in (lanes, others):
        both.reset({"rod.theta": 0.3})
        both.step({"torque": 1.0}, 20)
    which = np.arange(CASES) % 3 == 0
    values = lanes.reset({"rod.theta": np.linspace(-1, 0, which.sum())}, which, parameters={"l": 0.7})
    assert (lanes.time[which] == 0).all() and (lanes.time[~which] == 0.04).all()
    np.testing.assert_array_equal(values[~which], others.values[~which])
    now, then = lanes.step(None, 10), others.step(None, 10)
    np.testing.assert_array_equal(now[~which], then[~which])
    stepper, read = alone(model, {"l": 0.7}, {"rod.theta": -1.0})
    stepper.step(10)  # inputs are what the parameters say
    np.testing.assert_array_equal(now[0], read())
    np.testing.assert_array_equal(lanes.reset({"rod.theta": 0.2}, [4, 1])[[1, 4], 0], [0.2, 0.2])


def test_loops_and_flexible_bodies_go_side_by_side() -> None:
    crank = SCENES["flexible_slider_crank_free"]().model()
    speeds, settings = np.linspace(140.0, 160.0, 9), {"scheme": "single_rate", "dt": 1e-5}
    lanes = crank.lanes(9, **settings)
    lanes.reset({"crank.theta_dot": speeds})
    values = lanes.step(n=200)
    for case in (0, 8):
        stepper = crank.stepper(**settings)
        stepper.reset({"crank.theta_dot": float(speeds[case])})
        stepper.step(200)
        np.testing.assert_array_equal(values[case], stepper.reader(lanes.outputs)())


def test_what_is_lost_is_known_and_begins_anew(model) -> None:
    lanes = model.lanes(5)
    torque = np.array([0.0, 1e200, 0.0, 1e200, 0.0])
    lanes.step({"torque": torque, "drag": 1e4}, 400)
    assert lanes.lost.tolist() == [True] * 5  # such a drag is far too stiff for these steps
    lanes.reset({"rod.theta": 0.1}, lanes.lost)
    lanes.step({"torque": torque * 0, "drag": 0.1}, 5)
    assert not lanes.lost.any() and np.isfinite(lanes.values).all()


def test_what_does_not_go_side_by_side_is_refused(model) -> None:
    scene = Scene("stopped").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
    stop = scene.revolute("hinge", "ground.origin", "rod.origin", limits={"lower": -1.0, "restitution": 0.5}).model()
    with pytest.raises(ModelError, match=r"events, stops.*model\.stepper"):
        stop.lanes(4, scheme="rk4", dt=1e-3)
    with pytest.raises(SchemeError, match="remembers earlier steps"):
        model.lanes(4, scheme="exponential_adams", dt=1e-3)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda m: m.lanes(0), "cases: must be a whole number of at least 1"),
        (lambda m: m.lanes(3, parameters={"l": [0.5, 0.6]}), r"l: has shape \(2,\)"),
        (lambda m: m.lanes(3, parameters={"l": float("nan")}), r"l\[0\]: is nan"),
        (lambda m: m.lanes(3, outputs=["nothing"]), "nothing"),
        (lambda m: m.lanes(3).step({"torque": [1.0, 2.0]}), r"torque: has shape \(2,\)"),
        (lambda m: m.lanes(3).step({"push": 1.0}), "no input 'push'"),
        (lambda m: m.lanes(3).step({"torque": float("nan")}), "torque: has values that are not finite"),
        (lambda m: m.lanes(3).step(np.zeros((3, 1))), r"u: has shape \(3, 1\)"),
        (lambda m: m.lanes(3).step(n=-1), "n: is -1"),
        (lambda m: m.lanes(3).reset({"rod.theta": 0.1}, [0, 7]), "which"),
        (lambda m: m.lanes(3).reset({"rod.phi": 0.1}), "rod.phi"),
        (lambda m: m.lanes(3).reset(parameters={"l": 0.5}), "l: is none of those that vary"),
    ],
)
def test_wrong_arguments_are_named(model, call, says) -> None:
    with pytest.raises((ArgumentError, ModelError, InitialStateError), match=says):
        call(model)
