"""Times at which loads and prescribed motions jump or kink, against times known by hand."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import ModelError
from runtime.model import Model
from runtime.schemes.switching import times
from runtime.schemes.switching.enclosure import Enclosure
from runtime.schemes.switching.times import switching_times
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


TABLES: dict[str, dict[str, object]] = {
    "line": {"x": [0.2, 0.6, 0.9], "y": [0.0, 1.0, 0.0]},
    "spline": {"x": [0.1, 0.5, 0.9], "y": [0.0, 1.0, 0.0], "interpolation": "cubic"},
}
RISE = brentq(lambda u: 3.75 * u - 7.8125 * u**3 - 0.4, 0.0, 0.3)  # the natural spline from 0 to 1 in 0.4 s, alike back
CASES = {
    "where(t < on, 1, 0)": [0.25],
    "where(0.1 <= t < 3 * on, t, 0)": [0.1, 0.75],
    "abs(sin(w * t))": [0.0, np.pi / 10, np.pi / 5, 3 * np.pi / 10],
    "step(2 * t - 0.7) + sign(0.5 - t)": [0.35, 0.5],
    "min(t, 2 * on, 0.9) + max(exp(-t), 0.5)": [0.5, np.log(2)],
    "where(where(t < 0.2, t, t - 0.5) > 0, 1, 0)": [0.0, 0.2, 0.5],
    "where(t > held, 1, 0) + where(w > 3, 1, 0)": [0.6],
    'table("line", 2 * t)': [0.1, 0.3, 0.45],
    'table("spline", t + 0.01)': [0.09, 0.89],
    'where(table("line", 2 * t) > 0.5, 1, 0)': [0.2, 0.375],
    'where(table("spline", t + 0.01) > 0.4, 1, 0)': [0.09 + RISE, 0.89 - RISE],
    "where(angle > t, 1, 0)": [],  # depends on the motion
    "sin(w * t)": [],
}


def pushed(name: str, *torques: str) -> SceneRecord:
    """A hinged rod with torques, parameters `on` and `w`, an input and a measure."""
    builder = Scene(name).parameter("on", 0.25, "s").parameter("w", 10.0, "rad/s").input("held", 0.6)
    builder.rigid("rod", mass=1.0, inertia=0.1).revolute("hinge", "ground.origin", "rod.origin")
    builder.measure("angle", "coordinate", "rod.theta")
    for number, torque in enumerate(torques):
        builder.torque(f"push{number}", "rod.origin", torque)
    for table, fields in TABLES.items():
        builder.table(table, **fields)
    return builder.simulation(t_end=1.0, dt=0.01).build()


def test_times_are_those_known_by_hand(model_of: Build) -> None:
    model = model_of(pushed("switched", *CASES))
    c = model.constants(model.parameter_vector())
    found = switching_times(model, c, 0.0, 1.0)
    for number, (torque, known) in enumerate(CASES.items()):
        own = [one.time for one in found if f"push{number}" in one.owners]
        np.testing.assert_allclose(own, known, atol=1e-15, err_msg=torque)
    for one in found:  # the clocks show both sides of each, whatever rounding does at the time itself
        assert one.before <= one.time <= one.after and one.before < one.after
        signs = [np.asarray(model.evaluate("switching", t=t, c=c)["switching"]) > 0 for t in (one.before, one.after)]
        assert (signs[0] != signs[1]).sum() >= len(one.owners)


def test_what_does_not_jump_has_no_such_function(model_of: Build) -> None:
    model = model_of(pushed("not_switched", "sin(w * t)", "where(angle > 1, t, 0)", "where(w > 3, t, 0)"))
    assert not model.has("switching") and not model.description.switching


def test_times_follow_parameters_and_inputs(model_of: Build) -> None:
    model = model_of(pushed("switched_moved", "where(t < on, 1, where(t > held, 2, 0))"))
    for on, held in ((0.25, 0.6), (0.4, 0.9), (2.0, 0.3)):
        c = model.constants(model.parameter_vector({"on": on, "held": held}))
        assert [one.time for one in switching_times(model, c, 0.0, 1.0)] == pytest.approx(
            sorted(time for time in (on, held) if time < 1)
        )


def test_functions_given_for_inputs_have_times(model_of: Build) -> None:
    given = model_of(pushed("switched_source", "held")).with_inputs(
        {"held": lambda t: ca.if_else(t < 0.3, 1, ca.fmax(0.7 - t, 0))}
    )
    found = switching_times(given, given.constants(given.parameter_vector()), 0.0, 1.0)
    assert [one.time for one in found] == pytest.approx([0.3, 0.7])
    assert found[0].owners == ("input held",)


def test_every_period_is_found_and_too_many_are_refused(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    model = model_of(pushed("switched_often", "where(sin(w * t) > 0.2, 1, 0)"))
    c = model.constants(model.parameter_vector({"w": 800.0}))
    found = [one.time for one in switching_times(model, c, 0.0, 1.0)]
    rise = np.arcsin(0.2)
    turns = np.arange(200)
    known = np.sort(np.concatenate([rise + 2 * np.pi * turns, np.pi - rise + 2 * np.pi * turns])) / 800
    np.testing.assert_allclose(found, known[known < 1], atol=1e-14)
    monkeypatch.setattr(times, "MOST_TIMES", 100)
    with pytest.raises(ModelError, match="push0 of model switched_often.*more than 100 times"):
        switching_times(model, c, 0.0, 1.0)


def test_bounds_hold_what_a_function_does() -> None:
    """Of every operation, over random intervals: no value lies outside."""
    t = ca.SX.sym("t")
    u = t / 2
    values = [
        ca.sin(3 * t), ca.cos(t) * t, ca.tan(t), ca.asin(u / 3), ca.acos(u / 3), ca.atan(t), ca.sinh(u), ca.cosh(t),
        ca.tanh(t), ca.exp(-t), ca.log(t + 4), ca.sqrt(t + 4), ca.fabs(t - 1), ca.sign(t), t**3, (t + 4) ** 1.5,
        t**2 - t, 1 / (t - 0.3), t / (t + 5), ca.fmin(t, ca.fmax(1 - t, 0.2)), ca.floor(t), ca.ceil(3 * t),
        ca.if_else(ca.logic_and(t > 0, t <= 1), t + 1, -t), ca.if_else(ca.logic_or(t < -1, t > 1), 1, t),
        ca.atan2(t, 2), 2.0**t, ca.if_else(ca.logic_not(t == u), 1, 2),
    ]  # fmt: skip
    function = ca.Function("all", [t], [ca.vertcat(*values)])
    rng = np.random.default_rng(1)
    low = rng.uniform(-3, 3, 200)
    high = low + rng.choice([0.0, 1e-3, 0.5, 3.0], 200)
    bounds, _ = Enclosure(function).bounds(low, high)
    for share in np.linspace(0, 1, 21):
        seen = np.asarray(function((low + share * (high - low))[None, :]))
        for value, (least, most) in zip(seen, bounds, strict=True):
            assert np.all((least <= value) & (value <= most) | np.isnan(value))
