"""Arguments of the doors: unknown keywords and other kinds of values are refused by name, with what may be meant."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, ModelError, ensemble, simulate
from runtime.export.c_bundle import exported
from runtime.gradients import Formula
from runtime.model import Model
from tests.support.input_scenes import cart

SHORT: dict[str, Any] = {"t_end": 0.01, "dt": 1e-3, "scheme": "rk4"}


@pytest.mark.parametrize("door", [simulate, ensemble])
@pytest.mark.parametrize(
    "wrong, words",
    [
        ({"tend": 2}, ["tend", "did you mean t_end?"]),
        ({"duration": 2}, ["duration", "did you mean t_end?"]),
        ({"T": 2}, ["did you mean t_end?"]),
        ({"schem": "rk4"}, ["did you mean scheme?"]),
        ({"nonsense_of_mine": 1}, ["no such argument", "t_end"]),
        ({"progress": 5}, ["progress", "function"]),
        ({"options": [1]}, ["options", "dictionary"]),
        ({"inputs": [1]}, ["inputs", "dictionary"]),
        ({"outputs": 5}, ["outputs", "list of names"]),
        ({"outputs": "lower.theta"}, ["outputs", "list of names"]),
        ({"parameters": [1, 2]}, ["parameters", "{"]),
        ({"initial": [1, 2]}, ["initial", "{"]),
    ],
)
def test_wrong_arguments_are_named(
    built_in: Callable[..., Model], door: Callable[..., Any], wrong: dict[str, Any], words: list[str]
) -> None:
    with pytest.raises(ArgumentError) as refused:
        door(built_in("double_pendulum"), **{**SHORT, **wrong})
    assert all(word in str(refused.value) for word in words), str(refused.value)


@pytest.mark.parametrize("wrong", [{"force": "yes"}, {"stream": 5}, {"checkpoint": 5}])
def test_wrong_arguments_of_a_run_are_named(built_in: Callable[..., Model], wrong: dict[str, Any]) -> None:
    with pytest.raises(ArgumentError, match=next(iter(wrong))):
        simulate(built_in("double_pendulum"), **SHORT, **wrong)


def test_help_shows_the_arguments(built_in: Callable[..., Model]) -> None:
    """Of the functions and of the method of a model."""
    for door in (simulate, ensemble, built_in("double_pendulum").simulate):
        assert {"t_end", "dt", "scheme", "initial"} <= set(inspect.signature(door).parameters)


@pytest.mark.parametrize("value", [0.1 + 1j, "a", None])
def test_cases_are_numbers(built_in: Callable[..., Model], value: Any) -> None:
    with pytest.raises(ArgumentError, match=r"upper.theta_dot.*number"):
        ensemble(built_in("double_pendulum"), initial={"upper.theta_dot": [value, 0.2]}, **SHORT)


DOORS = (
    "resume equilibrium modes linearise campbell unbalance_response periodic quasi_static_motion advise stability "
    "convergence report stepper ode"
)


@pytest.mark.parametrize("name", DOORS.split())
def test_unknown_keywords_of_every_door_are_named(built_in: Callable[..., Model], name: str) -> None:
    with pytest.raises(ArgumentError, match="bogus.*no such argument"):
        getattr(built_in("hub_beam"), name)(bogus=3)


@pytest.mark.parametrize("name", ["export_c", "export_fmu"])
def test_what_hands_a_model_on_takes_a_path_and_names_unknown_keywords(
    built_in: Callable[..., Model], name: str
) -> None:
    door = getattr(built_in("hub_beam"), name)
    with pytest.raises(ArgumentError, match="bogus.*no such argument"):
        door("there", bogus=3)
    with pytest.raises(ArgumentError, match="give a path"):
        door(5)


@pytest.mark.parametrize(
    "ask, words",
    [
        (lambda model: model.equilibrium(held=["hub.theta"]), "held.*dictionary"),
        (lambda model: model.equilibrium(t="now"), "t: .*number"),
        (lambda model: model.modes("rest"), "at: .*equilibrium"),
        (lambda model: model.linearise([1, 2]), "at: .*equilibrium"),
        (lambda model: model.linearise((model.simulate(**SHORT), 10**6)), "at: .*sample"),
        (lambda model: model.linearise(outputs="tip_y"), "outputs.*list of names"),
        (lambda model: model.gradient("tip_y", ["hub.inertia"], **SHORT), "of: .*objective"),
        (lambda model: model.gradient(Formula(("tip_y",), lambda t, y: y["x"]), ["hub.inertia"], **SHORT), "column"),
        (lambda model: model.fit([[0.0], [1.0]], ["hub.inertia"], **SHORT), "data.*dictionary"),
        (lambda model: model.periodic(period=0.1, start=3), "start.*initial values"),
        (lambda model: model.periodic_over("hub.inertia", 3.0, period=0.1), "span"),
        (lambda model: model.simulate(**SHORT, stream=""), "stream.*path"),
        (lambda model: exported(model, "rk4", "1 ms"), "dt: .*number"),
    ],
)
def test_other_kinds_are_named_at_every_door(
    built_in: Callable[..., Model], ask: Callable[[Model], object], words: str
) -> None:
    with pytest.raises(ArgumentError, match=words):
        ask(built_in("hub_beam"))


def test_what_a_stepper_cannot_take_is_named(model_of: Callable[..., Model]) -> None:
    stepper = model_of(cart()).stepper(dt=1e-3, scheme="rk4")
    for wrong in (-1, 1.5, {"force": [1.0]}, {"force": abs}, "abc"):
        with pytest.raises(ArgumentError):
            stepper.step(wrong)
    with pytest.raises(ArgumentError):
        stepper.restore(None)
    assert stepper.time == 0.0
    stepper.step({"force": np.array(2.0)}, 1000)
    assert stepper.state["cart.x"] == pytest.approx(0.5, rel=1e-12)  # F t^2 / 2 m, m = 2 kg


def test_samples_that_are_no_pair_are_named(model_of: Callable[..., Model]) -> None:
    for wrong in ([1.0, 2.0, 3.0], (1.0,), ("a", "b")):
        with pytest.raises(ModelError, match="input 'force'"):
            model_of(cart()).simulate(inputs={"force": wrong}, **SHORT)
