"""What was probably meant: one line for a misspelled command, option or choice."""

from __future__ import annotations

import argparse
import difflib
import re
from collections.abc import Iterable, Sequence

CHOICE = re.compile(r"argument (.+?): invalid choice: '(.*?)' \(choose from (.+)\)", re.DOTALL)


def closest(word: str, known: Iterable[str]) -> str:
    """`; did you mean 'x'?`, or nothing where no known word is like it."""
    found = difflib.get_close_matches(word, list(known), n=1, cutoff=0.55)
    return f"; did you mean '{found[0]}'?" if found else ""


def explained(message: str, program: str) -> str:
    """A message of argparse in one line that says what to do."""
    choice = CHOICE.fullmatch(message)
    if choice is None:
        return f"{message} (see: {program} --help)"
    name, word, listed = choice.groups()
    known = [part.strip().strip("'") for part in listed.split(",")]
    meant = closest(word, known)
    if name in ("COMMAND", "command"):
        return f"there is no command '{word}'{meant or f' (see: {program} --help)'}"
    return f"{name} takes no '{word}'{meant or '; it takes ' + ', '.join(known)}"


def unknown_words(words: Sequence[str], command: argparse.ArgumentParser) -> str:
    """What is said of words that a command does not take."""
    first = words[0]
    options = [option for action in command._actions for option in action.option_strings]
    if not first.startswith("-"):
        return f"'{first}' is one word too many (see: {command.prog} --help)"
    name = first.partition("=")[0]
    meant = closest(name, options) or f" (see: {command.prog} --help)"
    return f"{command.prog.partition(' ')[2] or command.prog} has no option {name}{meant}"
