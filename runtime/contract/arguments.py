"""Arguments of public functions, checked by name: what is unknown or of another kind is refused; what may be meant."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from functools import wraps
from inspect import Parameter, signature
from numbers import Integral
from os import PathLike
from typing import Any, NamedTuple, ParamSpec, TypeVar

from runtime.contract.errors import ArgumentError, is_finite_number, shown_value

P = ParamSpec("P")
R = TypeVar("R")


class Kind(NamedTuple):
    """What an argument is, by a test; in words, what to give instead."""

    holds: Callable[[Any], bool]
    wanted: str


def _are_names(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str) and all(isinstance(one, str) for one in value)


def _is_whole(value: Any) -> bool:
    return isinstance(value, Integral) and not isinstance(value, bool) and abs(int(value)) <= MOST


def _are_numbers(value: Any) -> bool:
    listed = isinstance(value, Sequence) or getattr(value, "ndim", 0) == 1  # of NumPy, without importing it
    return listed and not isinstance(value, str | bytes) and all(map(is_finite_number, value))


def _are_numbers_of_any_shape(value: Any) -> bool:
    flat = value.ravel().tolist() if hasattr(value, "ravel") else value
    return _are_numbers(flat)


def _is_by_name(value: Any) -> bool:
    return isinstance(value, Mapping) and all(isinstance(key, str) for key in value)


def _is_place(value: Any) -> bool:
    parts = str(value).replace("\\", "/").split("/") if isinstance(value, str | PathLike) else [""]
    return any(parts) and "\0" not in str(value) and max(map(len, parts)) <= LONGEST_NAME


MOST, LONGEST_NAME = 10**15, 255  # of a count; of a file's name
BY_NAME = Kind(_is_by_name, 'give a dictionary, such as {"rod.mass": 2.0}')
START = Kind(
    lambda value: (
        _is_by_name(value) or callable(getattr(value, "initial_values", None)) and not isinstance(value, type)
    ),
    'give a dictionary, such as {"rod.theta": 0.5}, an equilibrium or a solution',
)
NAMES = Kind(_are_names, 'give a list of names, such as ["rod.theta"]')
CALLED = Kind(
    lambda value: callable(value) or isinstance(value, bool), "give a function (t, t_end), or True for a line"
)
FLAG = Kind(lambda value: isinstance(value, bool), "give True or False")
PLACE = Kind(_is_place, "give a path")
TEXT = Kind(lambda value: isinstance(value, str), "give text")
NUMBER = Kind(is_finite_number, "give a finite number")
WHOLE = Kind(_is_whole, "give a whole number")
COUNTS = Kind(
    lambda value: isinstance(value, Sequence) and not isinstance(value, str) and all(map(_is_whole, value)),
    "give a list of whole numbers",
)
NUMBERS = Kind(_are_numbers, "give a list of finite numbers")
SOME = Kind(
    lambda value: is_finite_number(value) or _are_numbers_of_any_shape(value), "give a finite number, or a list of them"
)
RUN = Kind(lambda value: hasattr(value, "q_dot") and hasattr(value, "model"), "give a solution, as `simulate` gives it")
MODEL = Kind(lambda value: hasattr(value, "description") and hasattr(value, "kernel"), "give a model")
RATIOS = Kind(
    lambda value: isinstance(value, Sequence) and not isinstance(value, str) and all(map(COUNTS.holds, value)),
    "give a list of ratios for each curve, such as [[2], [4]]",
)
ANY = Kind(lambda value: True, "")  # what the function looks at itself
OF_ANNOTATION = {  # kinds that the annotation of an argument says
    "str": TEXT,
    "Way": TEXT,
    "StressWay": TEXT,
    "float | Sequence[float]": SOME,
    "float | np.ndarray": SOME,
    "Sequence[float] | np.ndarray": NUMBERS,
    "str | Path": PLACE,
    "float": NUMBER,
    "int": WHOLE,
    "bool": FLAG,
    "list[int]": COUNTS,
    "Sequence[str]": NAMES,
    "Mapping[str, float]": BY_NAME,
    "Mapping[str, Any]": BY_NAME,
}

ENDS = ("duration", "time", "tend", "T")  # what others call t_end


def require(kind: Kind, *, or_none: bool = False, **values: Any) -> None:
    """Raises ArgumentError for the first value that is not of a kind."""
    for name, value in values.items():
        if not (or_none if value is None else kind.holds(value)):
            raise ArgumentError(name, f"cannot be {_short(value)}", kind.wanted)


def arguments(**kinds: Kind) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Check the arguments of a function by their kinds: those that are named here, else those that annotations say.

    The function raises ArgumentError for a value of another kind, None included where it is not in the annotation, for
    a keyword that it does not have, for an argument that is missing, and for one too many.
    """

    def checked(function: Callable[P, R]) -> Callable[P, R]:
        given = signature(function).parameters
        by_place = [name for name, one in given.items() if one.kind in _BY_PLACE]
        closed = all(one.kind is not Parameter.VAR_KEYWORD for one in given.values())
        open_list = any(one.kind is Parameter.VAR_POSITIONAL for one in given.values())
        wanted = [name for name, one in given.items() if one.default is one.empty and one.kind not in _LISTS]
        title = "it" if function.__name__ == "__init__" else function.__name__
        found = {name: OF_ANNOTATION[text] for name, one in given.items() if (text := _said(one)) in OF_ANNOTATION}
        known = {**found, **kinds}
        never_none = {name for name in found if "None" not in str(given[name].annotation)} | {*kinds} & {*wanted}
        never_none -= {name for name, one in given.items() if one.default is None}

        @wraps(function)
        def called(*values: P.args, **named: P.kwargs) -> R:
            if len(values) > len(by_place) and not open_list:
                raise _one_too_many(title, values[len(by_place)], list(given), [*by_place[1:]])
            for name, value in (*zip(by_place, values, strict=False), *named.items()):
                if closed and name not in given:
                    raise ArgumentError(clipped_name(name), f"{title} has no such argument", _near(name, list(given)))
                kind = known.get(name)
                if kind is None:
                    continue
                if name in never_none if value is None else not kind.holds(value):
                    raise ArgumentError(name, f"cannot be {_short(value)}", kind.wanted)
            for name in wanted[len(values) :]:
                if name not in named:
                    what = known[name].wanted if name in known else f"{title} wants {', '.join(wanted[1:] or wanted)}"
                    raise ArgumentError(name, f"is required by {title}", what)
            try:
                return function(*values, **named)
            except OverflowError as error:  # Python's integers know no bound
                raise ArgumentError(
                    title, f"was given a number that is too large: {error}", "give smaller ones"
                ) from error

        return called

    return checked


_BY_PLACE = (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)
_LISTS = (Parameter.VAR_POSITIONAL, Parameter.VAR_KEYWORD)


def _said(argument: Parameter) -> str:
    text = str(argument.annotation).removesuffix(" | None")
    return "str" if text.startswith("Literal[") else text


def _one_too_many(title: str, value: Any, known: Sequence[str], by_place: Sequence[str]) -> ArgumentError:
    """Of what stands by place where names are wanted: a number may be the end of a motion."""
    meant = f"did you mean t_end={_short(value)}?" if "t_end" in known and is_finite_number(value) else ""
    allowed = f"only {', '.join(by_place)} by position" if by_place else "keyword arguments only"
    taken = f"{title} takes {allowed}"
    return ArgumentError(_short(value), f"is positional, and {taken}", meant or "name the argument")


def clipped_name(name: str) -> str:
    """A keyword as a message shows it."""
    return name[:40] if name else "''"


def _near(name: str, known: Sequence[str]) -> str:
    if name in ENDS and "t_end" in known:
        return "did you mean t_end?"
    near = get_close_matches(name, known, n=1, cutoff=0.5)
    return f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}"


def _short(value: Any) -> str:
    text = shown_value(value)
    return f"a {type(value).__name__}" if len(text) > 40 else text
