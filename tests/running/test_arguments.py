"""Arguments of the doors: unknown keywords and other kinds of values are refused by name, with what may be meant."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import pytest

from runtime import ensemble, simulate
from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model

SHORT: dict[str, Any] = {"t_end": 0.01, "dt": 1e-3, "scheme": "rk4"}


@pytest.mark.parametrize("door", [simulate, ensemble])
@pytest.mark.parametrize(
    "wrong, words",
    [
        ({"tend": 2}, ["tend", "did you mean t_end?"]),
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
