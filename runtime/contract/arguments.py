"""Arguments of public functions, checked by name: what is unknown or of another kind is refused; what may be meant."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from functools import wraps
from inspect import Parameter, signature
from math import isfinite
from numbers import Real
from os import PathLike
from typing import Any, NamedTuple, ParamSpec, TypeVar

from runtime.contract.errors import ArgumentError

P = ParamSpec("P")
R = TypeVar("R")


class Kind(NamedTuple):
    """What an argument is, by a test; in words, what to give instead."""

    holds: Callable[[Any], bool]
    wanted: str


def _are_names(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str) and all(isinstance(one, str) for one in value)


def _is_number(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool) and isfinite(value)


def _are_numbers(value: Any) -> bool:
    listed = isinstance(value, Sequence) or hasattr(value, "__array__")  # of NumPy, without importing it
    return listed and not isinstance(value, str) and all(map(_is_number, value))


BY_NAME = Kind(lambda value: isinstance(value, Mapping), 'give a dictionary, such as {"rod.mass": 2.0}')
START = Kind(
    lambda value: isinstance(value, Mapping) or hasattr(value, "initial_values"),
    'give a dictionary, such as {"rod.theta": 0.5}, an equilibrium or a solution',
)
NAMES = Kind(_are_names, 'give a list of names, such as ["rod.theta"]')
CALLED = Kind(
    lambda value: callable(value) or isinstance(value, bool), "give a function (t, t_end), or True for a line"
)
FLAG = Kind(lambda value: isinstance(value, bool), "give True or False")
PLACE = Kind(lambda value: isinstance(value, str | PathLike) and value != "", "give a path")
NUMBER = Kind(_is_number, "give a finite number")
NUMBERS = Kind(_are_numbers, "give a list of finite numbers")

ENDS = ("duration", "time", "tend", "T")  # what others call t_end


def arguments(**kinds: Kind) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Names the arguments of a function that are checked by kind; None is always taken.

    The function raises ArgumentError for a value of another kind and for a keyword that it does not have.
    """

    def checked(function: Callable[P, R]) -> Callable[P, R]:
        given = signature(function).parameters
        known = [*given]
        closed = all(one.kind is not Parameter.VAR_KEYWORD for one in given.values())
        title = "it" if function.__name__ == "__init__" else function.__name__

        @wraps(function)
        def called(*values: P.args, **named: P.kwargs) -> R:
            for name, value in {**dict(zip(known, values, strict=False)), **named}.items():
                if closed and name not in known:
                    raise ArgumentError(name, f"{title} has no such argument", _near(name, known))
                if name in kinds and value is not None and not kinds[name].holds(value):
                    raise ArgumentError(name, f"cannot be {_short(value)}", kinds[name].wanted)
            return function(*values, **named)

        return called

    return checked


def _near(name: str, known: Sequence[str]) -> str:
    if name in ENDS and "t_end" in known:
        return "did you mean t_end?"
    near = get_close_matches(name, known, n=1, cutoff=0.5)
    return f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}"


def _short(value: Any) -> str:
    text = repr(value)
    return f"a {type(value).__name__}" if len(text) > 40 else text
