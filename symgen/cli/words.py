"""How words of the command line are read, and what is said of those that cannot be."""

from __future__ import annotations

import argparse
import difflib
import math
import re
import shlex
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any, NoReturn

from runtime.contract.errors import SymgenError

CHOICE = re.compile(r"argument (.+?): invalid choice: '(.*?)' \(choose from (.+)\)", re.DOTALL)


class UsageError(SymgenError):
    """Wrong words on the command line."""


class Parser(argparse.ArgumentParser):
    """An ArgumentParser that raises UsageError, in one line with what was probably meant."""

    def error(self, message: str) -> NoReturn:
        """Raise UsageError with the message."""
        choice = CHOICE.fullmatch(message)
        if choice is None:
            raise UsageError(f"{message} (see: {self.prog} --help)")
        name, word, listed = choice.groups()
        known = [part.strip().strip("'") for part in listed.split(",")]
        if name in ("COMMAND", "command"):
            raise UsageError(f"there is no command '{word}'{closest(word, known) or f' (see: {self.prog} --help)'}")
        raise UsageError(f"{name} takes no '{word}'{closest(word, known) or '; it takes ' + ', '.join(known)}")

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse all words; those that nothing takes are refused in the name of the command that got them."""
        parsed, further = self.parse_known_args(args, namespace)
        if further:
            commands = next((a.choices for a in self._actions if isinstance(a, argparse._SubParsersAction)), {})
            commands.get(getattr(parsed, "command", ""), self).refuse(further[0])
        return parsed

    def refuse(self, word: str) -> NoReturn:
        """Raise UsageError for a word that the command does not take."""
        if not word.startswith("-"):
            raise UsageError(f"'{word}' is one word too many (see: {self.prog} --help)")
        name = word.partition("=")[0]
        meant = closest(name, self._option_string_actions) or f" (see: {self.prog} --help)"
        raise UsageError(f"{self.prog.partition(' ')[2] or self.prog} has no option {name}{meant}")


def closest(word: str, known: Iterable[str]) -> str:
    """`; did you mean 'x'?`, or nothing where no known word is like it."""
    found = difflib.get_close_matches(word, list(known), n=1, cutoff=0.55)
    return f"; did you mean '{found[0]}'?" if found else ""


def reader(wanted: str) -> Callable[[Callable[[str], Any]], Callable[[str], Any]]:
    """A function of a word whose ValueError becomes `'word' is not <wanted>`."""

    def named(read: Callable[[str], Any]) -> Callable[[str], Any]:
        @wraps(read)
        def converted(text: str) -> Any:
            try:
                return read(text)
            except (ValueError, argparse.ArgumentTypeError):
                raise argparse.ArgumentTypeError(f"{text!r} is not {wanted}") from None

        return converted

    return named


def number(text: str) -> float:
    """A finite float."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a number; give it in SI units without the unit, such as 1"
        ) from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def positive(text: str) -> float:
    """A finite float above zero."""
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above zero")
    return value


def names(text: str) -> list[str]:
    """Comma-separated names."""
    found = [part.strip() for part in text.split(",") if part.strip()]
    if not found:
        raise argparse.ArgumentTypeError("at least one name is needed")
    return found


@reader("a list of whole numbers such as 10,4")
def ratios(text: str) -> list[int]:
    """Comma-separated whole numbers; an empty text is an empty list."""
    return [int(part) for part in text.split(",")] if text.strip() else []


def _named(text: str) -> tuple[str, str]:
    """The two sides of NAME=VALUE."""
    name, equals, value = text.partition("=")
    if not (name.strip() and equals):
        raise ValueError
    return name.strip(), value


@reader("NAME=VALUE")
def option(text: str) -> tuple[str, Any]:
    """NAME=VALUE with a word, a number, or numbers separated by commas as the value."""
    name, value = _named(text)
    parsed = [_word_or_number(part) for part in value.split(",")]
    return name, parsed[0] if len(parsed) == 1 else tuple(parsed)


@reader("NAME=FILE")
def file_of(text: str) -> tuple[str, str]:
    """NAME=FILE."""
    return _named(text)


def _word_or_number(text: str) -> str | int | float:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text


@reader("NAME=VALUE with a finite number")
def assignment(text: str) -> tuple[str, float]:
    """NAME=VALUE with a finite number."""
    name, value = _named(text)
    return name, number(value)


@reader("NAME=FROM:TO with finite numbers")
def span(text: str) -> tuple[str, float, float]:
    """NAME=FROM:TO with finite numbers."""
    name, values = _named(text)
    first, last = values.split(":")
    return name, number(first), number(last)


@reader("a positive number of seconds, or `free`")
def period(text: str) -> float | str:
    """Seconds, or the word `free`."""
    return text if text == "free" else positive(text)


@reader("FROM:TO with positive numbers, rising")
def frequencies(text: str) -> tuple[float, float]:
    """FROM:TO with positive numbers, rising."""
    first, last = map(number, text.split(":"))
    if not 0 < first < last:
        raise ValueError
    return first, last


@reader("NAME=lin:FROM:TO:COUNT, NAME=log:FROM:TO:COUNT (one sign) or NAME=1,2,5")
def over(text: str) -> tuple[str, list[float]]:
    """NAME=lin:FROM:TO:COUNT, NAME=log:FROM:TO:COUNT or NAME=VALUE,VALUE,..."""
    name, values = _named(text)
    spacing, *parts = values.split(":")
    if spacing not in ("lin", "log"):
        return name, [number(part) for part in values.split(",")]
    first, last, count = number(parts[0]), number(parts[1]), int(":".join(parts[2:]))
    if count < 2 or (spacing == "log" and first * last <= 0):
        raise ValueError
    import numpy as np

    spaced = np.linspace(first, last, count) if spacing == "lin" else np.geomspace(first, last, count)
    return name, [float(value) for value in spaced]


class Gather(argparse.Action):
    """NAME=VALUE into a dict; of the same name the last counts."""

    def __call__(
        self, parser: Any, namespace: argparse.Namespace, values: Any, option_string: str | None = None
    ) -> None:
        setattr(namespace, self.dest, {**getattr(namespace, self.dest), values[0]: values[1]})


MOTION = ("t_end", "parameters", "initial", "start")
RUN = (*MOTION, "dt", "m", "scheme", "tolerance", "options", "force", "seen_every", "samples", "engine")


def settings(arguments: argparse.Namespace, names: Iterable[str]) -> dict[str, Any]:
    """What was given, as keyword arguments of the function that takes it."""
    return {name: getattr(arguments, name) for name in names}


def motion_words(arguments: argparse.Namespace) -> str:
    """The scene and its motion in the words that they were given in, for a command that is to be run again."""
    words = [shlex.quote(arguments.scene)]
    for flag, given in ("with", arguments.made_with), ("set", arguments.parameters), ("initial", arguments.initial):
        words += [f"--{flag} {shlex.quote(f'{name}={value:.12g}')}" for name, value in given.items()]
    words += [f"--t-end {arguments.t_end:.12g}"] if arguments.t_end is not None else []
    words += [f"--start {arguments.start}"] if arguments.start is not None else []
    return " ".join(words)
